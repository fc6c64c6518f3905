//! GeoJSON files whose features are read and replaced one by one.

use crate::support::scratch;
use std::fs;
use std::path::Path;
use twinedge_layers::clean::Source as _;
use twinedge_layers::{Feature, FileError, Format, GeoJsonFile, ReadOptions, edited, edits, read_layer};

fn open(path: &Path) -> Result<(GeoJsonFile, Vec<Feature>), FileError> {
    let mut features = Vec::new();
    let mut take = |feature| {
        features.push(feature);
        Ok(())
    };
    let file = GeoJsonFile::open(path, tempfile::tempfile().unwrap(), &mut take)?;
    Ok((file, features))
}

/// Removes the geometries of the second and the last feature, and compares the text with a change of the whole text.
fn replaced_as_in_the_whole(text: &str, name: &str) {
    let (_folder, path) = scratch(name);
    fs::write(&path, text).unwrap();
    let (mut file, features) = open(&path).unwrap();
    let format = file.format();
    let mut layer = read_layer(&mut text.as_bytes(), Some(&path), &ReadOptions::default()).unwrap();
    assert_eq!(layer.features, features);
    for (number, feature) in features.iter().enumerate() {
        assert_eq!(&file.read(number).unwrap(), feature, "{text}");
    }
    let mut unchanged = Vec::new();
    file.write(&mut unchanged).unwrap();
    assert_eq!(unchanged, text.as_bytes());

    let mut changed = vec![1.min(features.len() - 1), features.len() - 1];
    changed.dedup();
    // A change that is undone is not a change.
    file.replace(0, Some(&Feature::default())).unwrap();
    file.replace(0, None).unwrap();
    for number in &changed {
        let feature = &mut layer.features[*number];
        feature.geometry = None;
        feature.members.shift_remove("bbox");
        file.replace(*number, Some(feature)).unwrap();
    }
    if let Some(bbox) = layer.header.members.get_mut("bbox") {
        *bbox = serde_json::json!([1, 2, 1, 2]);
    }
    let edits = edits(text, format, features.len(), &layer, &changed).unwrap();
    let mut written = Vec::new();
    file.write(&mut written).unwrap();
    assert_eq!(String::from_utf8(written).unwrap(), edited(text, &edits));
    let mut now = Vec::new();
    file.each(|feature| {
        now.push(feature);
        Ok::<_, FileError>(())
    })
    .unwrap();
    assert_eq!(now, layer.features);
}

#[test]
fn what_changes_is_what_changes_in_the_whole_text() {
    let feature = |x: f64, more: &str| {
        format!(
            r#"{{ "type":"Feature",{more} "geometry": {{"type":"Point","coordinates":[{x:e},2.0]}} ,"properties":{{"a]}}":"}}\"]{{","features":[{{"b":[1]}}]}}}}"#
        )
    };
    let one = feature(1.0, "");
    let two = feature(2.0, r#""bbox":[2,2,2,2],"#);
    let three = feature(3.0, r#""x":{"features":[{},{}]},"#);
    let list = format!("[ {one}\n,\t{two} , {three}]");
    for members in [
        format!(r#""type":"FeatureCollection","name":"features","features":{list}"#),
        format!(
            r#""x":[[{{}}],{{"bbox":[9]}}],"bbox": [1, 2,3, 2.0 ],"type":"FeatureCollection","features" : {list}, "y":{{}}"#
        ),
        format!(r#""type":"FeatureCollection","features":{list},"bbox":[1,2,3,2] "#),
        format!(r#""type":"FeatureCollection","features":{list},"bbox":[1,2,1.0,2]"#),
    ] {
        replaced_as_in_the_whole(&format!("\u{feff} {{{members}}}\r\n"), "layer.geojson");
    }
    replaced_as_in_the_whole(&one, "layer.geojson");
    replaced_as_in_the_whole(&format!("{one}\n{two}\r\n\n{three}"), "layer.geojsonl");
    replaced_as_in_the_whole(&format!("\u{1e}{one}\n\u{1e}{two}\n\u{1e}{three}\n"), "layer.geojsonl");
    // A geometry without a feature around it becomes a feature.
    replaced_as_in_the_whole(&format!("{one}\n{{\"type\":\"Point\",\"coordinates\":[5,6]}}\n"), "layer.geojsonl");
}

#[test]
fn a_file_that_is_no_geojson_or_changes_is_an_error() {
    let (_folder, path) = scratch("layer.geojsonl");
    let wkt = path.with_extension("wkt");
    fs::write(&wkt, "POINT(1 2)\n").unwrap();
    assert!(matches!(open(&wkt), Err(FileError::Format(Format::Wkt))));
    fs::write(&path, "{\"type\":\"Feature\",\n").unwrap();
    assert!(matches!(open(&path), Err(FileError::Read(_))));
    // The name of the array is written in a form that the reader does not look for.
    let point = r#"{"type":"Feature","properties":null,"geometry":null}"#;
    let odd = format!(r#"{{"type":"FeatureCollection","\u0066eatures":[{point},{point}]}}"#);
    fs::write(&path, odd).unwrap();
    let error = open(&path).unwrap_err();
    assert!(matches!(error, FileError::Moved(1)), "{error}");

    let square = |x: u8| format!("{{\"type\":\"Polygon\",\"coordinates\":[[[0,0],[{x},0],[{x},1],[0,0]]]}}\n");
    fs::write(&path, square(1) + &square(2)).unwrap();
    let (mut file, _) = open(&path).unwrap();
    fs::write(&path, square(1) + &square(3)).unwrap();
    assert!(file.read(0).is_ok());
    assert!(matches!(file.read(1), Err(FileError::Moved(1))));
    fs::write(&path, square(1)).unwrap();
    assert!(matches!(file.read(1), Err(FileError::Io(_))));
}
