//! The account of cleaning: changes and their reasons, gaps that are left, wide or accepted, and neighbourhoods that are too large.

use crate::coverage::SPINDLE;
use crate::support::uncoloured;
use crate::values::{has, members};
use serde_json::{Value, json};
use twinedge_coverage::clean::Options;
use twinedge_formats::layer::clean::CleanOptions;
use twinedge_formats::layer::{GeoJsonFile, ReadOptions, read_layer};
use twinedge_geometry::Point;
use twinedge_report::clean::{Cleaning, Names, Repair, clean_in_tiles};
use twinedge_report::{Division, Error, InMemory};

fn by(assign: Options) -> Repair<'static> {
    Repair { options: CleanOptions { assign, ..CleanOptions::default() }, ..Repair::default() }
}

fn up_to(width: f64) -> Options {
    Options { gap_width: Some(width), ..Options::default() }
}

/// Cleans a layer. Returns the report for people and as JSON.
fn cleaned(input: &str, repair: &Repair<'_>) -> Result<(String, Value), Error> {
    let mut layer = read_layer(&mut input.as_bytes(), None, &ReadOptions::default()).unwrap();
    let report = repair.clean(&mut layer)?;
    let cleaning = Cleaning::new("input", repair, &layer, &report);
    Ok((uncoloured(&cleaning.text(20).unwrap()), cleaning.json()))
}

/// Three parcels: the second begins half a unit inside the first, and a narrow gap separates both from the third. A copy of the second has no id, and
/// another feature no geometry.
const PARCELS: &str = r#"{"type":"FeatureCollection", "features":[
{"type":"Feature","id":"A-1","properties":{"owner":"Meier","since":"2020-01-31"},"geometry":{"type":"Polygon","coordinates":[[[0,0],[10,0],[10,10],[0,10],[0,0]]]}},
{"type":"Feature","id":"A-2","properties":{"owner":"Kunz"},"geometry":{"type":"Polygon","coordinates":[[[9.5,0],[20,0],[20,10],[9.5,10],[9.5,0]]]}},
{"type":"Feature","id":"A-3","properties":{"owner":"Huber"},"geometry":{"type":"Polygon","coordinates":[[[0,10],[10,10.05],[20,10],[20,20],[0,20],[0,10]]]}}
]}"#;

fn with_copy() -> String {
    let copy = r#",{"type":"Feature","properties":{"owner":"Copy"},"geometry":{"type":"Polygon","coordinates":[[[9.5,0],[20,0],[20,10],[9.5,10],[9.5,0]]]}}
,{"type":"Feature","properties":{"owner":"Nowhere"},"geometry":null}
]}"#;
    PARCELS.replace("\n]}", copy)
}

/// Repairs, and what people read of them.
#[test]
fn changes_have_features_and_reasons() {
    let names = Names { from: Some("owner") };
    for (input, repair, lines) in [
        (PARCELS, Repair::default(), &["overlap of A-1, A-2 to A-2: area 5.0000, width 0.4762"][..]),
        (
            &with_copy(),
            Repair { names, ..by(up_to(0.1)) },
            &[
                "warning: Copy has no geometry any more: its place went to ",
                "Copy: area 105.0000 → 0.0000, points 5 → 0; overlap with ",
                "gap filled",
            ],
        ),
        (
            SPINDLE,
            by(up_to(1.0)),
            &[
                "features with another geometry                 0\n",
                "left as it is: gap of feature 0, feature 1, area 400.0000, width ",
                "clean: C1 to C7 hold; 1 gap wider than 1 is left",
            ],
        ),
        (
            SPINDLE,
            by(Options { accepted_gaps: vec![Point::new(50.0, 0.0)], ..Options::default() }),
            &["accepted: gap of feature 0, feature 1, area 400.0000, width "],
        ),
    ] {
        let (text, _) = cleaned(input, &repair).unwrap();
        for line in lines {
            assert!(text.contains(line), "{line}\n{text}");
        }
    }
    // A gap is left and named, together with the width that fills it.
    let (left, _) = cleaned(SPINDLE, &Repair::default()).unwrap();
    assert!(left.contains("left: gap of feature 0, feature 1, area 400.0000"), "{left}");
    let width = left.split("--gap-width ").nth(1).and_then(|rest| rest.split(' ').next()).expect("a width");
    assert_eq!(cleaned(SPINDLE, &by(up_to(width.parse().unwrap()))).unwrap().1["clean"], true);
}

#[test]
fn wide_and_accepted_gaps_do_not_stay_as_faults() {
    let accepted = Options { accepted_gaps: vec![Point::new(50.0, 0.0)], ..Options::default() };
    let lakes = |width: f64| Options { lake_width: Some(width), ..Options::default() };
    let area = json!([{"area": 400}]);
    for (options, expected) in [
        (Options::default(), json!({"clean": false})),
        (up_to(1.0), json!({"clean": true, "changes": [], "wider_gaps": area})),
        (accepted.clone(), json!({"clean": true, "changes": [], "accepted_gaps": area})),
        (Options { gap_width: Some(100.0), ..accepted }, json!({"clean": true, "changes": [], "accepted_gaps": area})),
        (lakes(1.0), json!({"clean": true})),
        (Options { gap_width: Some(1.0), ..lakes(10.0) }, json!({"clean": false})),
    ] {
        has(&cleaned(SPINDLE, &by(options)).unwrap().1, &expected);
    }
}

#[test]
fn columns_and_values_that_are_not_there_are_refused() {
    let named = |column| Repair { names: Names { from: Some(column) }, ..Repair::default() };
    let to = |pair| Repair { gaps_to: Some(pair), ..Repair::default() };
    for (repair, why) in [
        (named("nothing"), "no feature has a value in the column nothing; there are owner, since"),
        (to(("sort", "road")), "--gaps-to: there is no column sort"),
    ] {
        let error = cleaned(PARCELS, &repair).unwrap_err().to_string();
        assert!(error.contains(why), "{error}");
    }
}

/// Rows of squares of 10. One square reaches half a unit into its right neighbour, far from a slit between two others.
fn squares() -> String {
    let square = |i: usize| {
        let (x, y) = ((i % 8) as f64 * 10.0, (i / 8) as f64 * 10.0);
        let right = match i {
            9 => x + 10.5,
            52 => x + 9.9,
            _ => x + 10.0,
        };
        let ring = [[x, y], [right, y], [right, y + 10.0], [x, y + 10.0], [x, y]];
        json!({"type": "Feature", "properties": {}, "geometry": {"type": "Polygon", "coordinates": [ring]}}).to_string()
    };
    (0..64).map(|i| square(i) + "\n").collect()
}

#[test]
fn a_neighbourhood_that_does_not_fit_stays_as_it_is_and_is_said() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("squares.geojsonl");
    std::fs::write(&path, squares()).unwrap();
    let repair = by(Options { sliver_area: Some(1.5), ..Options::default() });
    let open = |each: &mut dyn FnMut(_)| {
        let mut take = |feature| {
            each(feature);
            Ok(())
        };
        GeoJsonFile::open(&path, tempfile::tempfile()?, &mut take)
    };
    let shelves = || Ok(Box::<InMemory>::default() as _);
    let (mut file, tiles) = clean_in_tiles(open, &repair, Division::Within(1024), shelves, &mut |_| {}).unwrap();
    let mut written = Vec::new();
    file.write(&mut written).unwrap();
    assert_eq!(String::from_utf8(written).unwrap(), squares());
    let cleaning = Cleaning::of_tiles("squares", &repair, &tiles);
    let report = cleaning.json();
    // The squares that meet the box around the faulty ones: 16 for each fault.
    let left = members(&report["tiles"]["not_cleaned"], &["features", "vertices"]);
    let left: Vec<_> = left.as_array().unwrap().iter().map(|one| (&one[0][0]["number"], &one[1])).collect();
    assert_eq!(left, [(&json!(1), &json!(80)), (&json!(44), &json!(80))]);
    let rules = json!(["C1", "C2", "C7", "C7", "C7", "C7", "C7", "C7"]);
    assert_eq!((&members(&report["left"]["findings"], &["rule"]), &report["clean"]), (&rules, &json!(false)));
    let text = uncoloured(&cleaning.text(20).unwrap());
    let line = "not cleaned: 6 features between (10, 0) and (30, 30): the neighbourhood has 80 vertices\n";
    assert!(text.contains(line), "{text}");
}
