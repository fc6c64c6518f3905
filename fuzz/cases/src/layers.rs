//! Layers of features.

use twinedge_layers::{Format, Layer, ReadOptions, read_layer, write};

fn written(layer: &Layer, format: Format) -> Vec<u8> {
    let mut bytes = Vec::new();
    write(layer, &mut bytes, format).expect("memory");
    bytes
}

/// Writes the layer, and reads it again unchanged.
fn comes_back(bytes: &[u8], format: Format) {
    // The first bytes identify other formats, whatever the requested format.
    if format == Format::FlatGeobuf && !bytes.starts_with(b"fgb") {
        return;
    }
    let options = ReadOptions { format: Some(format), ..ReadOptions::default() };
    let read = |mut bytes: &[u8]| read_layer(&mut bytes, None, &options);
    let Ok(found) = read(bytes) else { return };
    let once = written(&found, format);
    let again = read(&once).expect("what was written is of the format");
    assert_eq!(found.features.len(), again.features.len());
    // Compared as bytes: a height may be NaN.
    assert_eq!(once, written(&again, format));
}

/// Reads well-known binary, writes it, and reads it again unchanged.
///
/// # Panics
/// If the features differ.
pub fn layer(bytes: &[u8]) {
    comes_back(bytes, Format::Wkb);
}

/// Reads `FlatGeobuf`, writes it, and reads it again unchanged.
///
/// # Panics
/// If the features differ.
pub fn flatgeobuf(bytes: &[u8]) {
    comes_back(bytes, Format::FlatGeobuf);
}
