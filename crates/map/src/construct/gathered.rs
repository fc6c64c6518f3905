//! The builder's input before the map exists: darts over distinct segments, and features made of them.

/// A future half-edge: twice the number of its segment, plus 1 if it runs against the segment.
pub(super) type Dart = u32;

/// A polygon of a feature, or all its lines.
#[derive(Clone, Copy, Debug)]
pub(super) struct Part {
    pub(super) feature: u32,
    pub(super) is_polygon: bool,
    /// The index after its last dart.
    end: usize,
}

/// The features until the map is built.
#[derive(Clone, Debug, Default)]
pub(super) struct GatheredFeatures {
    pub(super) names: Vec<Option<String>>,
    pub(super) parts: Vec<Part>,
    /// The rings of each polygon, one after the other; the segments of all lines.
    pub(super) darts: Vec<Dart>,
}

impl GatheredFeatures {
    /// Adds a part to the next feature, made of all darts since the previous part.
    pub(super) fn put_part(&mut self, is_polygon: bool) {
        self.parts.push(Part { feature: self.names.len() as u32, is_polygon, end: self.darts.len() });
    }

    /// Returns the parts with their darts, in order of the features.
    pub(super) fn all(&self) -> impl Iterator<Item = (Part, &[Dart])> {
        let mut start = 0;
        self.parts.iter().map(move |part| {
            let darts = &self.darts[start..part.end];
            start = part.end;
            (*part, darts)
        })
    }

    /// Returns the darts of polygons, each with its feature, in order of the features.
    pub(super) fn polygons(&self) -> impl Iterator<Item = (u32, &[Dart])> {
        self.all().filter(|(part, _)| part.is_polygon).map(|(part, darts)| (part.feature, darts))
    }

    /// Replaces each dart by the darts that `by` appends for it.
    pub(super) fn replace(&mut self, mut by: impl FnMut(&mut Vec<Dart>, Dart)) {
        let darts = core::mem::take(&mut self.darts);
        self.darts.reserve_exact(darts.len());
        let mut start = 0;
        for part in &mut self.parts {
            for dart in &darts[start..part.end] {
                by(&mut self.darts, *dart);
            }
            start = part.end;
            part.end = self.darts.len();
        }
    }
}

pub(super) fn origin(segments: &[[u32; 2]], dart: Dart) -> u32 {
    segments[dart as usize >> 1][dart as usize & 1]
}

pub(super) fn target(segments: &[[u32; 2]], dart: Dart) -> u32 {
    origin(segments, dart ^ 1)
}
