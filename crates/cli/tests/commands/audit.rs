//! `twinedge audit` and `twinedge postgis`: inputs, options, exit status, and the destination of reports.

use crate::shared::{CUBE, PARCELS, TOWN, has};
use crate::support::{Folder, crossing};
use serde_json::{Value, json};
use std::process::{Command, Stdio};

/// One input of each kind, and what cannot be read.
fn inputs() -> Folder {
    let folder = Folder::new(&[
        ("valid.wkt", "POLYGON((0 0,1 0,0 1,0 0))\n"),
        ("overlap.wkt", "POLYGON((0 0,2 0,2 2,0 2,0 0))\nPOLYGON((1 1,3 1,3 3,1 3,1 1))\n"),
        ("points.wkt", "POINT (1 2)\nMULTIPOINT ((1 2), (3 4))\n"),
        ("parcels.geojson", PARCELS),
        ("states.geojson", &PARCELS.replace("{\"owner\":\"Meier\"", "{\"name\":\"A\",\"state\":\"A\"")),
        ("cube.mesh", CUBE),
        ("flat.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"),
        ("empty.tables", "V 0 H 0 B 0 F 0\n"),
        ("point.txt", "v1 nil\nf1 nil nil\n"),
        ("twice.txt", "V 1 - 0 H 0 B 1 0 v0 i0 F 1 - 1 0 = ok\nV 1 - 0 H 0 B 1 0 v0 i0 F 1 - 1 0 = R1\n"),
        ("colon.json", "{\n  \"type\": }"),
        ("cut.json", "{\"type\": \"FeatureCollection\",\n\"features\": ["),
        ("nothing", ""),
        ("sqlite", "SQLite format 3\0 and more"),
        ("list.json", "["),
    ]);
    folder.write("utf-16", b"\xFF\xFE");
    folder.write("town.copy", TOWN);
    std::fs::create_dir(folder.path("cadastre.gdb")).unwrap();
    std::fs::create_dir(folder.path("folder")).unwrap();
    folder
}

#[test]
fn data_in_a_pipe_are_never_answered_by_the_verdict_on_the_built_in_map() {
    let folder = Folder::new(&[("map.wkt", "POLYGON((2 46, 4 46, 4 48, 2 48, 2 46))\n")]);
    let ran = folder.run("audit < map.wkt");
    assert_eq!((ran.status, &*ran.out), (Some(2), ""));
    assert_eq!(ran.err, "twinedge: there are data on standard input: give `-` as the file to read them\n");
    assert!(folder.ok("audit - < map.wkt").contains("standard input"));
    // Nothing is in this pipe.
    assert!(folder.ok("audit").contains("built in"));
    // Another argument names it.
    assert!(folder.ok("query overlay - < map.wkt").contains("France"));
}

#[test]
fn each_input_has_its_status_and_each_misuse_its_message() {
    inputs().transcript(
        "
audit => 0 7,655 ++ structure valid · coverage: 1 gap, 2 invalid features
audit valid.wkt => 0 valid: every rule that applies holds
audit - < valid.wkt => 0 standard input
audit overlap.wkt => 1 not valid
audit parcels.geojson --name-from owner --snap auto --coverage => 1 Müller
audit parcels.geojson --layer parcels => 1
audit cube.mesh --closed --genus 0 --sides 4 => 0 OBJ, 8 points, 6 faces
audit cube.mesh --triangles => 1 M3 face 1 has 4 sides, where 3 are expected
audit - --postgis < town.copy => 0 P4  cached     ok      36 values
audit - < town.copy => 0 valid: every rule that applies holds
audit twice.txt => 1 1 verdict of the file differs
audit points.wkt --allow-empty => 0

audit missing.geojson => 2 missing.geojson: No such file
audit cadastre.gdb => 2 a file geodatabase of Esri ++ ogr2ogr
audit folder => 2 this is a folder
audit - < colon.json => 2 twinedge: standard input: ++ line 2, column 11
audit - < cut.json => 2 standard input: ++ line 2, column
audit - < nothing => 2 standard input: the input is empty
audit - < utf-16 => 2 looks like text in UTF-16
audit - < sqlite => 2 ogr2ogr
audit points.wkt => 2 this file has 2 features with 3 points and nothing else
query points.wkt faces => 2 this file has 2 features with 3 points and nothing else
draw points.wkt => 2 this file has 2 features with 3 points and nothing else
audit valid.wkt --accept list.json => 2 list.json: no list of accepted findings: EOF while parsing
audit valid.wkt --against points.wkt => 2 points.wkt: a map is made of lines and polygons
audit valid.wkt --against nowhere.shp => 2 nowhere.shp: No such file

=> 2 Usage
audit a b => 2 unexpected argument
audit --format xml => 2 invalid value 'xml'
audit --list -1 => 2 not a whole number
audit --list x => 2 invalid value 'x' for '--list <N>': not a whole number
audit --snap=0 => 2 neither `auto` nor a positive number
audit --snap -1 => 2 invalid value '-1' for '--snap <auto|SIZE>': neither `auto` nor a positive number
audit --snap=NaN => 2 neither `auto` nor a positive number
audit --snap=inf => 2 neither `auto` nor a positive number
audit --snap=fine => 2 neither `auto` nor a positive number
audit --accept-gap 12 => 2 not a point
audit --accept-gap 12, => 2 not a point
audit --accept-gap a,b => 2 not a point
audit --accept-gap 1,2,3 => 2 not a point
audit --gap-width=0 => 2 not a positive number
audit --gap-width=-1 => 2 not a positive number
audit --gap-width=inf => 2 not a positive number
audit --gap-width=wide => 2 not a positive number
audit valid.wkt --against valid.wkt --tiles 2 => 2 cannot be used with '--tiles <N>'
audit valid.wkt --parent-column =x => 2 neither COLUMN nor COLUMN=KEY
audit valid.wkt --tiles 2 --snap auto => 2 --snap and --tiles do not go together
audit valid.wkt --tiles 2 --format html => 2 the format html and --tiles do not go together
audit valid.wkt --tiles 2 --geodesic => 2 --geodesic and --tiles do not go together
audit valid.wkt --memory 2G --geodesic => 2 --geodesic and --memory do not go together

audit flat.off --snap auto => 2 --snap is for maps, and this is a mesh
audit flat.off --coverage => 2 --coverage, its limits ++ are for maps, and this is a mesh
audit flat.off --geodesic => 2 --geodesic are for maps, and this is a mesh
audit flat.off --against valid.wkt => 2 --against and --parent-column are for maps, and this is a mesh
audit flat.off --format geojson => 2 this is a mesh
audit flat.off --layer roads => 2 there is no layer \"roads\"
audit empty.tables --snap auto => 2 --snap is for maps, and this is a file of tables
audit empty.tables --closed => 2 is no mesh file
audit empty.tables --sliver 1 => 2 --geodesic are for maps, and this is a file of tables
audit empty.tables --format geojson => 2 this is a file of tables
audit empty.tables --format html => 2 this is a file of tables
audit empty.tables --layer roads => 2 there is no layer \"roads\"
audit point.txt --snap auto => 2 --snap is for maps, and this is a textbook's tables
audit point.txt --genus 0 => 2 is no mesh file
audit point.txt --layer roads => 2 there is no layer \"roads\"
audit town.copy --coverage => 2 --geodesic are for maps, and this is a topology of PostGIS
audit town.copy --postgis --layer roads => 2 there is no layer \"roads\"
audit - --snap auto < town.copy => 2 --snap is for maps, and this is a topology of PostGIS
audit - --arcs --snap auto < valid.wkt => 2 --snap is for maps
audit --closed => 2 is no mesh file
draw cube.mesh => 2 this is a mesh (OBJ); only `twinedge audit` and `twinedge certify` take meshes
query cube.mesh faces => 2 this is a mesh (OBJ); only `twinedge audit` and `twinedge certify` take meshes

postgis => 2 Usage
postgis --sql 'my \"old\" town' => 0 BEGIN TRANSACTION ISOLATION LEVEL REPEATABLE READ READ ONLY; ++ COPY \"my \"\"old\"\" town\".node ( ++ COPY \"my \"\"old\"\" town\".edge_data ( ++ COPY \"my \"\"old\"\" town\".face ( ++ TO STDOUT (FORMAT binary); ++ COMMIT;
",
    );
}

/// Each option has its effect in the report.
#[test]
fn options_reach_the_report() {
    let folder = inputs();
    let of_map = "--snap 0.5 --name-from owner --allow-empty --coverage --gap-width 0.25 --lake-width 5 --accept-gap '(1, -2)' --accept-gap 3,4 \
                  --sliver 2 --edges straight --geodesic --timeout 600";
    let of_mesh =
        "--borders 2 --genus 1 --components 2 --sides 5 --no-unused-vertices --no-zero-area --no-crossings --outward";
    let against = json!({"options": {"against": "overlap.wkt"}});
    let expected = json!({
        "snap": 0.5, "name_from": "owner", "allow_empty": true, "coverage": true, "gap_width": 0.25, "lake_width": 5,
        "accept_gap": [[1, -2], [3, 4]], "sliver": 2, "edges": "straight", "geodesic": true,
    });
    let mesh = json!({
        "expected": "surface open asking no-unused-vertices sides 5 components 2 borders 2 genus 1", "space": ["M9", "M10", "M11"],
    });
    for (line, expected) in [
        ("valid.wkt".to_owned(), json!({"options": {}, "verdict": "valid"})),
        (format!("parcels.geojson {of_map}"), json!({ "options": expected })),
        ("overlap.wkt --against overlap.wkt".to_owned(), against),
        ("states.geojson --parent-column state=name".to_owned(), json!({"options": {"parent_column": "state=name"}})),
        (format!("cube.mesh {of_mesh}"), json!({ "options": mesh })),
        ("overlap.wkt --explain --list 1".to_owned(), json!({"violation_count": 2})),
        ("overlap.wkt --tiles 3".to_owned(), json!({"tiles": {"columns": 3}})),
        ("overlap.wkt --memory 64K".to_owned(), json!({"tiles": {"count": 1}})),
    ] {
        let (_, found) = folder.json(&format!("audit {line} --format json"));
        has(&found, &expected);
    }
    let (_, found) = folder.json("audit overlap.wkt --explain --list 1 --format json");
    let violations = found["violations"].as_array().unwrap();
    assert!(violations.len() == 1 && violations[0]["remedy"].is_string(), "{found}");
}

#[test]
fn the_extension_of_the_output_says_the_format() {
    let folder = inputs();
    for (name, format, begins) in [
        ("a.geojson", "geojson", "{\"type\":\"FeatureCollection\""),
        ("a.html", "html", "<!doctype html>"),
        ("a.json", "json", "{\n  \"input\""),
        ("a.txt", "text", "valid.wkt"),
        ("a.sarif", "sarif", "{\n  \"$schema\""),
        ("a.xml", "junit", "<?xml version=\"1.0\""),
    ] {
        folder.ok(&format!("audit valid.wkt -o {name}"));
        let written = folder.text(name);
        assert!(written.starts_with(begins) && !written.contains('\u{1b}'), "{name}: {written}");
        assert!(folder.ok(&format!("audit valid.wkt --format {format}")).starts_with(begins), "{format}");
    }
    let said = folder.ok("audit valid.wkt -o b.html --format geojson");
    assert!(
        said.ends_with("0 findings written to b.html\n") && folder.text("b.html").starts_with("{\"type\""),
        "{said}"
    );
}

#[test]
fn quiet_and_colours_are_obeyed() {
    let folder = inputs();
    for (input, status) in [("valid.wkt", 0), ("overlap.wkt", 1)] {
        let ran = folder.run(&format!("audit {input} -q"));
        assert_eq!((ran.status, &*ran.out), (Some(status), ""));
    }
    let coloured = ["always", "never", "auto"]
        .map(|when| folder.run(&format!("audit overlap.wkt --color {when}")).out.contains('\u{1b}'));
    assert_eq!(coloured, [true, false, false]);
    folder.write("metres.wkt", "POLYGON((0 0,900 0,900 900,0 900,0 0))\nPOLYGON((800 0,999 0,999 9,800 9,800 0))\n");
    let warned = folder.run("audit metres.wkt --format geojson").err;
    assert!(warned.starts_with("warning: ") && warned.contains("no coordinate reference system is known"), "{warned}");
}

#[test]
fn the_judged_bytes_are_named() {
    let folder = inputs();
    // Computed by `sha256sum`.
    let digest = "2cbf33d79f9a1427072bdfe4c486247d76aa40fd3299c0ebf020ca7ba0936674";
    let judged = json!({"sha256": digest, "bytes": 27});
    for (line, expected) in [
        (
            "- < valid.wkt",
            json!({"judged": judged, "version": env!("CARGO_PKG_VERSION"), "first": null, "unknown": null}),
        ),
        ("valid.wkt", json!({"judged": judged, "judged_by": null})),
        ("overlap.wkt --against valid.wkt", json!({"judged_by": judged, "judged": {"bytes": 62}})),
    ] {
        let (arguments, input) = line.split_once(" <").map_or((line, String::new()), |(a, i)| (a, format!(" <{i}")));
        has(&folder.json(&format!("audit {arguments} --format json{input}")).1, &expected);
    }
}

#[test]
fn what_was_not_judged_in_time_is_not_valid() {
    let mut late = Command::new(env!("CARGO_BIN_EXE_twinedge"))
        .args(["audit", "-", "--format", "json", "--timeout", "0.2"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    // Nothing is written, so the input does not end.
    let kept = late.stdin.take();
    let output = late.wait_with_output().unwrap();
    drop(kept);
    assert_eq!(output.status.code(), Some(1));
    let unknown = json!(["time was up after 0.2 s"]);
    let expected = json!({"verdict": "unknown", "valid": false, "unknown": unknown, "counts": null, "judged": null});
    has(&serde_json::from_slice(&output.stdout).unwrap(), &expected);
}

#[test]
fn an_audit_in_time_and_on_disk_is_as_any_other() {
    let folder = inputs();
    let report = |words: &str| {
        let (status, mut found) = folder.json(&format!("audit {} --format json {words}", crossing()));
        found["elapsed_ms"] = Value::Null;
        assert_eq!(status, Some(1));
        let tiles = found["tiles"]["count"].take();
        (found["tiles"].take(), tiles.as_u64(), found)
    };
    assert_eq!(report("--timeout 600"), report(""));
    let ((_, few, on_disk), (_, _, in_memory)) = (report("--memory 12M"), report("--tiles 3"));
    assert!(few > Some(1) && on_disk == in_memory, "{on_disk}");
    // More memory than was given is said to be used.
    folder.transcript(
        "
audit overlap.wkt --memory 64K => 1 overlap.wkt: ++ MiB of memory were used, where --memory gives 1
audit overlap.wkt --memory 4G => 1 G4
",
    );
}

/// `edges: "spherical"` of `GeoParquet` 1.1.
#[test]
fn a_file_that_says_that_its_edges_are_spherical_is_judged_so() {
    let ring = |[x0, y0, x1, y1]: [f64; 4]| json!([[[x0, y0], [0, y0], [x1, y0], [x1, y1], [x0, y1], [x0, y0]]]);
    let feature =
        |at| json!({"type": "Feature", "properties": {}, "geometry": {"type": "Polygon", "coordinates": ring(at)}});
    let features = [feature([-60.0, 30.0, 60.0, 50.0]), feature([-5.0, 60.0, 5.0, 72.0])];
    let layer = json!({"type": "FeatureCollection", "edges": "spherical", "features": features});
    let folder = Folder::new(&[("two.geojson", &layer.to_string())]);
    folder.ok("convert two.geojson -o two.parquet");
    folder.transcript(
        "
audit two.parquet => 1 edges are great circles, as the file says
audit two.parquet --tiles 2 => 2 edges are spherical by the file, and straight in tiles: --edges straight
audit two.parquet --memory 1G => 2 edges are spherical by the file, and straight in tiles: --edges straight
tile two.parquet --grid 1x1 --tile 0 -o s => 2 edges are spherical by the file, and straight in tiles: --edges straight
audit two.parquet --edges straight => 0 its edges are spherical, and they were judged as straight
audit two.parquet --edges straight --tiles 2 => 0 its edges are spherical, and they were judged as straight
audit two.parquet --edges straight --memory 1G => 0 its edges are spherical, and they were judged as straight
tile two.parquet --grid 1x1 --tile 0 -o s --edges straight => 0
",
    );
}

#[test]
fn the_tables_that_are_drawn_are_audited() {
    let folder = Folder::new(&[("l.wkt", "POLYGON((0 0,1 0,1 2,3 2,3 3,0 3,0 0))\n")]);
    let tables = folder.ok("draw l.wkt --tables");
    assert!(tables.starts_with("Vertex  Coordinates  IncidentEdge\n"), "{tables}");
    folder.write("tables.txt", &tables);
    // A vertex moved across its edges.
    folder.write("moved.txt", tables.replace("(1, 2)", "(-20, 2)"));
    folder.transcript("audit tables.txt => 0 valid: every rule that applies holds\naudit moved.txt => 1 G4");
}
