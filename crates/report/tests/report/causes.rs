//! Layers with planted faults: the number of causes equals the number of faults.

use crate::shared::{has, members};
use crate::support::{Asked, audited, json, page_data, parsed, says, text};
use serde_json::{Value, json};

type Ring = Vec<[f64; 2]>;
type Parcels = Vec<([usize; 2], Ring)>;

/// A corner of a grid of parcels, 100 by 80, in the coordinates of a national grid. No side is parallel to an axis.
fn corner([column, row]: [usize; 2]) -> [f64; 2] {
    let (x, y) = (column as f64, row as f64);
    [2_683_000.0 + 100.0 * x + 7.0 * (y % 3.0), 1_247_000.0 + 80.0 * y + 5.0 * (x % 2.0)]
}

fn ring(parcels: &mut Parcels, place: [usize; 2]) -> &mut Ring {
    &mut parcels.iter_mut().find(|(other, _)| *other == place).expect("it is on the grid").1
}

/// A fault: its rule, and a function that plants it.
type Fault = (&'static str, fn(&mut Parcels));

const FAULTS: [Fault; 5] = [
    ("C1", |all| {
        // A side is moved into the neighbour.
        let ring = ring(all, [1, 1]);
        ring[1][0] += 3.0;
        ring[2][0] += 3.0;
    }),
    ("C2", |all| ring(all, [4, 1])[1][0] -= 2.0),
    ("C6", |all| ring(all, [1, 4]).swap(2, 3)),
    ("C5", |all| {
        let copy = ring(all, [4, 4]).clone();
        all.push(([9, 9], copy));
    }),
    ("C7", |all| {
        let ring = ring(all, [3, 3]);
        let middle = [0, 1].map(|axis| f64::midpoint(ring[0][axis], ring[1][axis]));
        ring.insert(1, middle);
    }),
];

/// Parcels with these faults, as well-known text.
fn planted(faults: &[Fault]) -> String {
    let around = |[c, r]: [usize; 2]| [[c, r], [c + 1, r], [c + 1, r + 1], [c, r + 1]].map(corner).to_vec();
    let places = (0..6).flat_map(|column| (0..6).map(move |row| [column, row]));
    let mut all: Parcels = places.map(|place| (place, around(place))).collect();
    for (_, plant) in faults {
        plant(&mut all);
    }
    all.iter().map(|(_, ring)| polygon(ring)).collect()
}

fn polygon(ring: &[[f64; 2]]) -> String {
    let corners: Vec<String> = ring.iter().chain(&ring[..1]).map(|[x, y]| format!("{x} {y}")).collect();
    format!("POLYGON(({}))\n", corners.join(","))
}

#[test]
fn a_layer_with_n_faults_has_n_causes() {
    for count in 0..=FAULTS.len() {
        let found = json(planted(&FAULTS[..count]), "--coverage");
        assert_eq!(found["causes"], count, "{found}");
        let findings = found["coverage"]["findings"].as_array().unwrap().iter();
        let causes = findings.filter(|one| one.get("follows_from").is_none()).map(|one| one["rule"].as_str().unwrap());
        let sorted = |mut rules: Vec<_>| {
            rules.sort_unstable();
            rules
        };
        assert_eq!(
            sorted(causes.collect()),
            sorted(FAULTS[..count].iter().map(|(rule, _)| *rule).collect()),
            "{found}"
        );
        let violations = found["violations"].as_array().unwrap();
        assert!(violations.iter().all(|one| one["follows_from_id"].is_string()), "{found}");
        if count > 0 {
            let first =
                found["coverage"]["findings"].as_array().unwrap().iter().find(|one| one.get("follows_from").is_none());
            assert_eq!(found["first"]["id"], first.unwrap()["id"]);
        }
    }
}

#[test]
fn each_form_of_a_report_counts_causes() {
    let layer = planted(&FAULTS);
    says(&*layer, "--coverage", &["\nnot valid: 5 findings, from which "]);
    let audited = audited(layer, "--coverage");
    let page = audited.page().unwrap();
    assert!(page.contains("<p id=\"verdict\">not valid: 5 findings, from which "));
    assert_eq!(page_data(&page).unwrap()["tone"], "bad");
    assert_eq!(audited.junit().unwrap().matches("<failure ").count(), 5);
    let sarif: Value = serde_json::from_slice(&audited.sarif().unwrap()).unwrap();
    let results = sarif["runs"][0]["results"].as_array().unwrap();
    assert_eq!(results.iter().filter(|one| one["level"] == "error").count(), 5, "{sarif}");
}

/// The line crosses both borders at a corner of their overlap, which has one feature in common with each of these crossings.
#[test]
fn a_crossing_follows_from_findings_about_both_of_its_features_only() {
    let layer = "POLYGON((0 0,10 0,10 10,0 10,0 0))\nPOLYGON((5 5,15 5,15 15,5 15,5 5))\nLINESTRING(9 4,11 6)\n";
    let found = json(layer, "");
    let crossings: Vec<_> = found["violations"].as_array().unwrap().iter().filter(|one| one["rule"] == "G4").collect();
    assert!(crossings.len() > 2, "{found}");
    for one in crossings {
        let is_of_line = one["feature_numbers"].as_array().unwrap().contains(&json!(2));
        assert_eq!(one.get("follows_from_id").is_none(), is_of_line, "{one}");
    }
    assert_eq!(found["first"]["rule"], "C1", "{found}");
}

#[test]
fn a_headline_has_the_structure_and_the_coverage() {
    // Neither a missing parcel nor a copy makes borders cross.
    let layer = planted(&[("C2", |all| all.retain(|(place, _)| *place != [3, 3])), FAULTS[3]]);
    let headline = "structure valid · coverage: 1 gap, 1 set of duplicates";
    has(&json(layer, ""), &json!({"verdict": "valid", "coverage": {"verdict": "invalid"}, "headline": headline}));
}

/// A gap of three millimetres in the coordinates of a national grid.
const CRACK: &str = "POLYGON((2683000 1247000,2683100 1247000,2683100 1247080,2683000 1247080,2683000 1247000))
POLYGON((2683100.003 1247000,2683200 1247000,2683200 1247080,2683100.003 1247080,2683100.003 1247000))
POLYGON((2683000 1247080,2683100 1247080,2683100.003 1247080,2683200 1247080,2683200 1247100,2683000 1247100,2683000 1247080))
POLYGON((2683000 1246980,2683200 1246980,2683200 1247000,2683100.003 1247000,2683100 1247000,2683000 1247000,2683000 1246980))
";

#[test]
fn a_printed_place_accepts_the_gap_and_another_place_is_a_warning() {
    let text = text(CRACK, "");
    let line = text.lines().find(|line| line.starts_with("C2 gap")).expect("there is a gap");
    let place: String = line.rsplit_once("at ").unwrap().1.chars().filter(|c| !"() ".contains(*c)).collect();
    let accepted = json!({"verdict": "valid", "coverage": {"gaps": 0, "accepted_gaps": 1}, "warnings": []});
    has(&json(CRACK, &format!("--coverage --accept-gap {place}")), &accepted);
    let found = json(CRACK, "--accept-gap 2683050,1247040");
    assert_eq!(found["warnings"], json!(["there is no gap at the accepted place (2683050, 1247040)"]));
}

/// Accepts all findings of one layer, and judges another layer by that list. Without `--coverage`, only the structure counts.
#[track_caller]
fn by_the_list_of(before: &str, after: &str, expected: &Value) {
    let list = Asked::new("").accepting(br#"{"schema": "twinedge-accepted/1", "accepted": []}"#);
    let list = list.audit("layer", before).unwrap().accept_all(None, "", "2026-01-31").unwrap();
    let judged = |layer: &str| parsed(&Asked::new("").accepting(&list).audit("layer", layer).unwrap());
    has(&judged(before), &json!({"verdict": "valid", "causes": 0}));
    has(&judged(after), expected);
}

#[test]
fn accepted_findings_do_not_accept_others() {
    let invalid = json!({"verdict": "invalid"});
    // A lake, and a line that crosses elsewhere.
    let lake = "POLYGON((0 0,100 0,100 10,95 20,100 30,100 100,0 100,0 0))\nPOLYGON((100 0,200 0,200 100,100 100,100 30,100 10,100 0))\n";
    by_the_list_of(lake, &format!("{lake}LINESTRING(50 70,150 72)\n"), &json!({"verdict": "invalid", "causes": 1}));
    // A spike, and its feature crosses itself or others.
    let spike = "POLYGON((0 0,50 0,50 12,50 0,100 0,100 80,0 80,0 0))\n";
    by_the_list_of(spike, "POLYGON((0 0,50 0,50 12,50 0,100 80,100 0,0 80,0 0))\n", &invalid);
    by_the_list_of(spike, &format!("{spike}LINESTRING(-20 40,150 45)\n"), &invalid);
    let row = |tip: u32| {
        let others = (1..6).map(|i| format!("POLYGON(({0} 0,{1} 0,{1} 100,{0} 100,{0} 0))\n", 100 * i, 100 * i + 100));
        let first = format!("POLYGON((0 0,100 0,100 50,{tip} 50,100 50,100 100,0 100,0 0))\n");
        std::iter::once(first).chain(others).collect::<String>()
    };
    by_the_list_of(&row(105), &row(550), &invalid);
    // A missing vertex is accepted at its place only.
    let layer = |west: &str, east: &str| {
        format!(
            "POLYGON((0 0,100 0,{west}100 1000,0 1000,0 0))\nPOLYGON((100 0,200 0,200 1000,100 1000,{east}100 0))\n"
        )
    };
    let grown = json!({"verdict": "invalid", "coverage": {"mismatches": 1}, "accepted": {"grown": [members(&json(layer("", "100 900,"), "")["coverage"]["findings"], &["id"])[0]]}});
    by_the_list_of(&layer("100 100,", ""), &layer("", "100 900,"), &grown);
}
