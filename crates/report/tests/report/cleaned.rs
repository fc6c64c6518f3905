//! The account of cleaning: changes and their reasons, and gaps that are left, wide or accepted.

use crate::coverage::SPINDLE;
use crate::shared::{PARCELS, has};
use crate::support::uncoloured;
use serde_json::{Value, json};
use twinedge_coverage::clean::Options;
use twinedge_geometry::Point;
use twinedge_layers::clean::CleanOptions;
use twinedge_layers::{ReadOptions, read_layer};
use twinedge_report::Error;
use twinedge_report::clean::{Cleaning, Names, Repair};

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

/// A copy of the second parcel has no id, and another feature no geometry.
fn with_copy() -> String {
    let copy = r#"
,{"type":"Feature","properties":{"owner":"Copy"},"geometry":{"type":"Polygon","coordinates":[[[9.5,0],[20,0],[20,10],[9.5,10],[9.5,0]]]}}
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
