//! Reports of the library, and the JSON of `twinedge audit`, have the form of `docs/report.schema.json`.

use crate::support::{data, json as run};
use boon::{Compiler, Schemas};
use serde_json::{Value, json, to_value};
use twinedge::validate::{Collect, Expectation, Table, validate};

/// What is wrong with the form of a document.
fn complaint(document: &Value) -> Option<String> {
    let (mut schemas, mut compiler) = (Schemas::new(), Compiler::new());
    let path = format!("{}/../docs/report.schema.json", env!("CARGO_MANIFEST_DIR"));
    let schema = compiler.compile(&path, &mut schemas).unwrap();
    schemas.validate(document, schema).err().map(|error| error.to_string())
}

#[test]
fn reports_of_the_library_have_the_form() {
    let (mut valid, mut broken) = (0, 0);
    for text in ["V 0 H 0 B 0 F 1 - 0", "V 1 0 - H 1 0 0 0 0 0 B 1 0 h0 i0 F 1 - 1 0", "V 1 0 - H 1 9 - - - - B 0 F 0"]
    {
        let table: Table = text.parse().unwrap();
        for expectation in [Expectation::plane(), Expectation::surface().open().genus(1)] {
            for collect in [Collect::All, Collect::First] {
                let report = validate(&table, &expectation, collect);
                let document = to_value(&report).unwrap();
                assert_eq!(complaint(&document), None, "{document:#}");
                if report.is_valid() { valid += 1 } else { broken += 1 }
            }
        }
    }
    assert!(valid > 0 && broken > 4, "{valid} {broken}");
}

#[test]
fn audits_of_maps_meshes_and_textbook_tables_have_the_form() {
    let textbook = format!("{}/../examples/tables/five_faces.txt", env!("CARGO_MANIFEST_DIR"));
    let mesh = format!("{}/schema-tetrahedron.off", env!("CARGO_TARGET_TMPDIR"));
    std::fs::write(&mesh, "OFF\n4 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n").unwrap();
    let crossing = data("world-110m-crossing.geojson");
    for (arguments, valid) in [
        (&["--list", "3"][..], true),
        (&[crossing.as_str(), "--explain"], false),
        (&[mesh.as_str(), "--closed"], false),
        (&[textbook.as_str()], true),
    ] {
        let (_, document) = run(&[&["audit", "--format", "json"], arguments].concat());
        assert_eq!((complaint(&document), &document["valid"]), (None, &json!(valid)), "{arguments:?}");
    }
}

/// The form is one that something can fail.
#[test]
fn other_documents_do_not_have_the_form() {
    let table: Table = "V 1 0 - H 1 0 0 0 0 0 B 1 0 h0 i0 F 1 - 1 0".parse().unwrap();
    let right = to_value(validate(&table, &Expectation::plane(), Collect::All)).unwrap();
    let changes: [fn(&mut Value); 6] = [
        |d| d["schema"] = json!("twinedge-report/2"),
        |d| d["counts"]["edges"] = json!(-1),
        |d| d["rules"][0]["id"] = json!(7),
        |d| d["rules"][4]["unchecked"] = json!({ "because": "L1" }),
        |d| d["violations"][0]["records"] = json!([{ "corner": 0 }]),
        |d| {
            d.as_object_mut().unwrap().remove("valid");
        },
    ];
    for change in changes {
        let mut document = right.clone();
        change(&mut document);
        assert!(complaint(&document).is_some(), "{document}");
    }
}
