//! Files of TopoJSON.

use twinedge_layers::{Format, Place, ReadError, ReadOptions, read_layer, topojson as arcs, write};

/// Reads TopoJSON and audits its arcs. Both return, and errors lie inside the input. The features are written as
/// well-known binary and read again unchanged.
///
/// # Panics
/// If the features differ, or an error lies outside the input.
pub fn topojson(bytes: &[u8]) {
    let lines = bytes.split(|byte| *byte == b'\n').count();
    // Each object by itself, if there are several.
    let mut layers = vec![None];
    if let Err(error) = arcs::read(&mut &*bytes, None, 2) {
        match error {
            ReadError::Layers { layers: found, .. } => layers = found.into_iter().map(Some).collect(),
            ReadError::Content { place: Place::Text(at), .. } => assert!(at.line <= lines, "{at}"),
            _ => {}
        }
    }
    for layer in layers.into_iter().take(3) {
        if let Ok(topology) = arcs::read(&mut &*bytes, layer.as_deref(), 2) {
            let audit = arcs::audit(&topology, 2);
            assert_eq!(audit.is_valid(), audit.violation_count() == 0, "{audit}");
        }
        let options = ReadOptions { format: Some(Format::TopoJson), layer, ..ReadOptions::default() };
        let Ok(found) = read_layer(&mut &*bytes, None, &options) else { continue };
        let mut once = Vec::new();
        write(&found, &mut once, Format::Wkb).expect("memory");
        let options = ReadOptions { format: Some(Format::Wkb), ..ReadOptions::default() };
        let again = read_layer(&mut &*once, None, &options).expect("what was written is well-known binary");
        let mut twice = Vec::new();
        write(&again, &mut twice, Format::Wkb).expect("memory");
        assert_eq!(once, twice);
    }
}
