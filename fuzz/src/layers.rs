//! Layers of features.

use twinedge_formats::layer::{Format, Layer, ReadOptions, read_layer, write};

/// The geometries of a layer, written.
fn written(layer: &Layer) -> Vec<u8> {
    let mut bytes = Vec::new();
    write(layer, &mut bytes, Format::Wkb).expect("memory");
    bytes
}

/// What is read of well-known binary is written and read again as it was.
///
/// # Panics
/// If not.
pub fn layer(bytes: &[u8]) {
    let options = ReadOptions { format: Some(Format::Wkb), ..ReadOptions::default() };
    let read = |mut bytes: &[u8]| read_layer(&mut bytes, None, &options);
    // Other formats are recognised as such.
    let Ok(found) = read(bytes) else { return };
    let once = written(&found);
    let again = read(&once).expect("what was written is well-known binary");
    assert_eq!(found.features.len(), again.features.len());
    // Compared as bytes: a height may be NaN.
    assert!(once == written(&again));
}
