//! `twinedge convert` and outputs in general: written completely, never over the input, and in the format of their extension.

use crate::shared::{PARCELS, TOPOLOGY, has};
use crate::support::Folder;
use serde_json::{Value, json};

fn parcels() -> Folder {
    Folder::new(&[("parcels.geojson", PARCELS)])
}

#[test]
fn what_a_format_cannot_hold_is_refused_and_said() {
    let folder = parcels();
    folder.write("lakes.geojson", PARCELS.replace("\"source\":\"survey\",\n", ""));
    folder.transcript(
        "
convert parcels.geojson -o out.shp => 2 the ids of 3 features ++ foreign members (source)
convert parcels.geojson -o out.xyz => 2 --to
convert parcels.geojson --lossy -o missing/out.gpkg => 2 missing/out.gpkg: No such file
",
    );
    assert_eq!(folder.names("").len(), 2);
    let warned = folder.run("convert parcels.geojson -o out.shp --lossy").err;
    assert!(warned.lines().all(|line| line.starts_with("warning: Shapefile does not hold ")), "{warned}");
    // Ids are kept in a column.
    for name in ["lakes.shp", "lakes.gpkg", "lakes.fgb"] {
        folder.transcript(&format!(
            "
convert lakes.geojson -o {name} => 2 the ids of 3 features ++ --id-column
convert lakes.geojson -o {name} --id-column owner => 2 there is a column owner already
convert lakes.geojson -o {name} --id-column parcel => 0
"
        ));
        let (_, layer) = folder.json(&format!("convert {name} -o -"));
        assert_eq!(layer["features"][1]["properties"]["parcel"], json!("A-2"), "{name}");
    }
    let open = Folder::new(&[("open.wkt", "POLYGON((0 0,1 0,1 1))")]);
    let ran = open.run("convert open.wkt -o - --to wkt");
    assert!(ran.out == "POLYGON((0 0,1 0,1 1,0 0))\n" && ran.err.contains("an open ring, which is closed"), "{ran:?}");
}

#[test]
fn the_input_is_not_overwritten_by_any_path() {
    let folder = parcels();
    folder.ok("convert parcels.geojson -o a.shp --lossy");
    folder.ok("convert parcels.geojson -o other.geojson");
    std::fs::create_dir(folder.path("below")).unwrap();
    std::fs::hard_link(folder.path("parcels.geojson"), folder.path("hard.geojson")).unwrap();
    let mut names = vec!["parcels.geojson", "below/../parcels.geojson", "hard.geojson"];
    if cfg!(unix) {
        #[cfg(unix)]
        std::os::unix::fs::symlink(folder.path("parcels.geojson"), folder.path("link.geojson")).unwrap();
        names.push("link.geojson");
    }
    for name in names {
        folder.transcript(&format!(
            "
clean parcels.geojson -o {name} => 2 this is the input
convert parcels.geojson -o {name} => 2 this is the input
decompose --snap auto parcels.geojson -o {name} => 2 this is the input
audit parcels.geojson -o {name} => 2 this is the input
overlay parcels.geojson other.geojson -o {name} => 2 this is the input, and is not overwritten
draw parcels.geojson -o {name} => 2 this command writes .svg, and no .geojson
"
        ));
    }
    assert_eq!(folder.text("parcels.geojson"), PARCELS);
    // Parts of a Shapefile are not overwritten either, nor a second input.
    folder.transcript(
        "
audit a.shp --format json -o a.shp => 2 this is the input
audit a.shp --format json -o a.dbf => 2 this is the input
audit a.shp --format json -o a.cpg => 2 this is the input
overlay parcels.geojson other.geojson -o other.geojson => 2 this is an input, and is not overwritten
",
    );
}

#[test]
fn what_fails_leaves_what_was_there() {
    let folder = Folder::new(&[("mixed.wkt", "POINT(1 2)\nLINESTRING(0 0,1 1)\n"), ("out.shp", "before")]);
    folder.transcript("convert mixed.wkt -o out.shp => 2");
    assert_eq!((&*folder.text("out.shp"), folder.names("").len()), ("before", 2));
}

#[cfg(unix)]
#[test]
fn a_link_is_followed_and_a_device_written_to() {
    let folder = parcels();
    folder.write("target.wkt", "before");
    std::os::unix::fs::symlink(folder.path("target.wkt"), folder.path("link.wkt")).unwrap();
    folder.ok("convert parcels.geojson -o link.wkt --lossy");
    assert!(std::fs::symlink_metadata(folder.path("link.wkt")).unwrap().is_symlink());
    assert!(folder.text("target.wkt").starts_with("POLYGON((0 0,"));
    folder.transcript("draw parcels.geojson -o /dev/null => 1");
}

#[test]
fn every_command_reads_every_format() {
    let folder = parcels();
    for name in ["p.geojsonl", "p.gpkg", "p.shp", "p.wkb", "p.wkt"] {
        folder.ok(&format!("convert parcels.geojson -o {name} --lossy"));
        let (_, found) = folder.json(&format!("audit --format json {name}"));
        // A Shapefile has outer rings clockwise.
        has(&found["import"], &json!({"features": 3, "rings_wound_wrongly": 0}));
        folder.ok(&format!("query --snap auto {name} faces"));
    }
    folder.write("map.topojson", TOPOLOGY);
    folder.transcript(
        "
audit map.topojson --layer squares => 0
audit --arcs --layer squares map.topojson => 0 arcs of TopoJSON
audit map.topojson => 2 (--layer): there are squares, town
audit --arcs map.topojson => 2 there are squares, town
clean map.topojson --layer squares -o clean.geojson => 0
draw map.topojson --layer squares => 0 left
query map.topojson --layer squares neighbours left => 0 right
convert map.topojson --layer squares -o other.topojson => 2 TopoJSON is read here, but not written
audit p.shp --name-from owner --snap auto --coverage => 1 Müller
",
    );
    let layer: Value = serde_json::from_str(&folder.ok("convert map.topojson --layer squares -o -")).unwrap();
    assert_eq!(
        (&layer["features"][1]["id"], &layer["features"][1]["properties"]["name"]),
        (&json!("b"), &json!("right"))
    );
    assert!(!folder.run("convert map.topojson --layer squares -o other.topojson").err.contains("--lossy"));
    assert!(!folder.path("other.topojson").exists());
}

#[test]
fn extensions_and_layers_that_a_command_does_not_have_are_refused() {
    let folder = parcels();
    let before = folder.names("");
    for command in ["audit", "draw", "decompose", "voronoi"] {
        for name in ["out.gpkg", "out.xyz"] {
            folder.transcript(&format!("{command} parcels.geojson -o {name} => 2 this command writes ."));
        }
        if command != "decompose" {
            folder.transcript(&format!("{command} parcels.geojson --layer roads => 2 there is no layer \"roads\""));
        }
    }
    folder.transcript("convert parcels.geojson -o - --to wkt --layer roads => 2 there is no layer \"roads\"");
    assert_eq!(folder.names(""), before);
    // The extension selects the format, and a file has no colours.
    folder.ok("decompose --snap auto parcels.geojson -o pieces.json");
    assert!(serde_json::from_str::<Value>(&folder.text("pieces.json")).is_ok());
    folder.ok("decompose --snap auto parcels.geojson -o pieces.txt");
    let text = folder.text("pieces.txt");
    assert!(text.contains("diagonals") && !text.contains('\u{1b}'), "{text:?}");
}

#[test]
fn pieces_of_two_layers_have_the_attributes_of_both() {
    let square = |id: Value, name: &str, [x0, y0, x1, y1]: [f64; 4]| {
        let geometry = json!({"type": "Polygon", "coordinates": [[[x0, y0], [x1, y0], [x1, y1], [x0, y1], [x0, y0]]]});
        json!({"type": "Feature", "id": id, "properties": {"name": name}, "geometry": geometry})
    };
    let layer = |features: Vec<Value>, crs: Value| {
        json!({"type": "FeatureCollection", "crs": crs, "features": features}).to_string()
    };
    let epsg = |number: u32| json!({"type": "name", "properties": {"name": format!("urn:ogc:def:crs:EPSG::{number}")}});
    // ```text
    //   2 +-------+
    //     |   f   |        the first layer: the field f, and the garden g inside it;
    //   1 |  +---+|----+   the second: the zone z, from x = 2 to 4 and y = 0 to 1
    //     |  | g :|: z |
    //   0 +--+---+-----+
    // ```
    let first =
        vec![square(json!("f"), "field", [0.0, 0.0, 3.0, 2.0]), square(json!("g"), "garden", [1.0, 0.0, 2.5, 1.0])];
    let folder = Folder::new(&[
        ("first.geojson", &layer(first, Value::Null)),
        ("second.geojson", &layer(vec![square(json!(7), "zone", [2.0, 0.0, 4.0, 1.0])], Value::Null)),
        ("swiss.geojson", &layer(Vec::new(), epsg(2056))),
        ("french.geojson", &layer(Vec::new(), epsg(2154))),
    ]);
    let all = ["f,7,1.0", "f,,5.0", "g,7,0.5", "g,,1.0", ",7,1.0"];
    for (keep, kept) in
        [("either", &[0, 1, 2, 3, 4][..]), ("both", &[0, 2]), ("first", &[0, 1, 2, 3]), ("first-only", &[1, 3])]
    {
        let (_, layer) = folder.json(&format!("overlay first.geojson second.geojson --keep {keep} -o -"));
        let piece = |feature: &Value| {
            let [id, id_1, name, name_1] =
                ["id", "id_1", "name", "name_1"].map(|key| feature["properties"][key].as_str().unwrap_or_default());
            assert_eq!((id.get(..1), id_1.is_empty()), (name.get(..1), name_1.is_empty()));
            // The shoelace formula.
            let rings: Vec<Vec<[f64; 2]>> = serde_json::from_value(feature["geometry"]["coordinates"].clone()).unwrap();
            let twice =
                |ring: &Vec<[f64; 2]>| ring.windows(2).map(|e| e[0][0] * e[1][1] - e[1][0] * e[0][1]).sum::<f64>();
            format!("{id},{id_1},{:.1}", rings.iter().map(twice).sum::<f64>() / 2.0)
        };
        let pieces: Vec<String> = layer["features"].as_array().unwrap().iter().map(piece).collect();
        assert_eq!(pieces, kept.iter().map(|one| all[*one]).collect::<Vec<_>>(), "{keep}");
    }
    let csv = folder.ok("query first.geojson overlay second.geojson --format csv");
    assert_eq!(csv.lines().skip(1).collect::<Vec<_>>(), all);
    let (_, found) = folder.json("query first.geojson overlay second.geojson --sort area --limit 1 --format json");
    let field = json!({"number": 0, "id": "f", "name": "field"});
    assert_eq!(found["pairs"], json!([{"first": field, "second": null, "area": 5.0}]));
    folder.transcript(
        "
query first.geojson overlay second.geojson => 0 1.0000  field (id f), zone (id 7)
overlay first.geojson second.geojson => 2 no file to write was given
overlay swiss.geojson french.geojson -o - => 2 the layers are in different coordinate reference systems: EPSG:2056 and EPSG:2154
query first.geojson overlay swiss.geojson => 2 swiss.geojson: a map is made of lines and polygons, and this file has no features
",
    );
}
