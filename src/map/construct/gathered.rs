//! The input of the builder before there is a map: darts over distinct segments, and features made of them.

/// A half-edge before there are any: twice the number of its segment, plus 1 if it runs against it.
pub(super) type Dart = u32;

/// The record of a feature until the map is built.
#[derive(Clone, Debug, Default)]
pub(super) struct GatheredFeature {
    pub(super) name: Option<String>,
    /// For each polygon its rings, one after the other.
    pub(super) polygons: Vec<Vec<Dart>>,
    /// All segments of lines.
    pub(super) lines: Vec<Dart>,
}

/// The point where a dart starts.
pub(super) fn origin(segments: &[[u32; 2]], dart: Dart) -> u32 {
    segments[dart as usize >> 1][dart as usize & 1]
}

/// The point where a dart ends.
pub(super) fn target(segments: &[[u32; 2]], dart: Dart) -> u32 {
    origin(segments, dart ^ 1)
}
