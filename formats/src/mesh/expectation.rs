//! What a mesh is expected to be.

use super::{HalfEdgeMesh, MeshCounts};
use std::fmt;

/// What a mesh is held to beyond being a surface: nothing, unless it is said.
///
/// ```
/// use twinedge_formats::mesh::MeshExpectation;
/// // A torus of triangles.
/// let torus = MeshExpectation::new().closed().components(1).genus(1).triangles().no_unused_vertices();
/// # let _ = torus;
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub struct MeshExpectation {
    borders: Option<usize>,
    genus: Option<usize>,
    components: Option<usize>,
    sides: Option<usize>,
    no_unused_vertices: bool,
}

impl MeshExpectation {
    /// Surfaces, whatever their borders, genus and faces.
    #[must_use]
    pub const fn new() -> Self {
        Self { borders: None, genus: None, components: None, sides: None, no_unused_vertices: false }
    }

    /// No border: every edge has two faces. The same as no `borders`.
    #[must_use]
    pub const fn closed(self) -> Self {
        self.borders(0)
    }

    /// So many border loops.
    #[must_use]
    pub const fn borders(mut self, count: usize) -> Self {
        self.borders = Some(count);
        self
    }

    /// So many handles, over all components.
    #[must_use]
    pub const fn genus(mut self, genus: usize) -> Self {
        self.genus = Some(genus);
        self
    }

    /// So many connected components.
    #[must_use]
    pub const fn components(mut self, count: usize) -> Self {
        self.components = Some(count);
        self
    }

    /// All faces with three sides.
    #[must_use]
    pub const fn triangles(self) -> Self {
        self.sides(3)
    }

    /// All faces with so many sides. Faces that are left out are a fault anyway, and do not count.
    #[must_use]
    pub const fn sides(mut self, count: usize) -> Self {
        self.sides = Some(count);
        self
    }

    /// Every vertex in some face.
    #[must_use]
    pub const fn no_unused_vertices(mut self) -> Self {
        self.no_unused_vertices = true;
        self
    }

    /// What is not met. O(faces).
    pub(super) fn unmet(&self, half_edges: &HalfEdgeMesh<'_>, counts: &MeshCounts) -> Vec<Unmet> {
        let mut unmet = Vec::new();
        if let Some(expected) = self.borders.filter(|expected| counts.borders != Some(*expected)) {
            unmet.push(Unmet::Borders { expected, found: counts.borders, border_edges: counts.border_edges });
        }
        if let Some(expected) = self.genus.filter(|expected| counts.genus != Some(*expected)) {
            unmet.push(Unmet::Genus { expected, found: counts.genus });
        }
        if let Some(expected) = self.components.filter(|expected| counts.components != *expected) {
            unmet.push(Unmet::Components { expected, found: counts.components });
        }
        if let Some(expected) = self.sides {
            let faces = half_edges.mesh().faces().enumerate();
            let mut others = faces.filter(|(f, face)| face.len() != expected && !half_edges.is_left_out(*f));
            if let Some((first, face)) = others.next() {
                unmet.push(Unmet::Sides { expected, faces: 1 + others.count(), first, found: face.len() });
            }
        }
        if self.no_unused_vertices && counts.unused_vertices > 0 {
            unmet.push(Unmet::UnusedVertices { count: counts.unused_vertices });
        }
        unmet
    }
}

/// An expectation that is not met. `Display` says it in a sentence.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Unmet {
    /// Another number of border loops.
    Borders {
        /// What was expected.
        expected: usize,
        /// What there is; not known where faces could not be joined.
        found: Option<usize>,
        /// How many edges have one face only.
        border_edges: usize,
    },
    /// Another genus.
    Genus {
        /// What was expected.
        expected: usize,
        /// What there is; not known where faces could not be joined to surfaces.
        found: Option<usize>,
    },
    /// Another number of components.
    Components {
        /// What was expected.
        expected: usize,
        /// What there is.
        found: usize,
    },
    /// Faces with another number of sides.
    Sides {
        /// What was expected.
        expected: usize,
        /// How many faces have another number.
        faces: usize,
        /// The first of them.
        first: usize,
        /// How many sides it has.
        found: usize,
    },
    /// Vertices that no face uses; which ones, the findings say.
    UnusedVertices {
        /// How many.
        count: usize,
    },
}

impl Unmet {
    /// The name of the expectation: `borders`, `genus`, `components`, `sides` or `no_unused_vertices`. It is stable.
    #[must_use]
    pub const fn name(&self) -> &'static str {
        match self {
            Self::Borders { .. } => "borders",
            Self::Genus { .. } => "genus",
            Self::Components { .. } => "components",
            Self::Sides { .. } => "sides",
            Self::UnusedVertices { .. } => "no_unused_vertices",
        }
    }
}

/// A count in words.
struct Shown(Option<usize>);

impl fmt::Display for Shown {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            Some(count) => write!(f, "{count}"),
            None => f.write_str("unknown, since faces could not be joined"),
        }
    }
}

impl fmt::Display for Unmet {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Borders { expected, found, border_edges } => write!(
                f,
                "expected {expected} border loop(s), found {} ({border_edges} edge(s) with one face)",
                Shown(found)
            ),
            Self::Genus { expected, found } => write!(f, "expected genus {expected}, found {}", Shown(found)),
            Self::Components { expected, found } => write!(f, "expected {expected} component(s), found {found}"),
            Self::Sides { expected, faces, first, found } => write!(
                f,
                "expected faces with {expected} sides, found {faces} with another number; the first is face {first} with {found}"
            ),
            Self::UnusedVertices { count } => write!(f, "expected no unused vertices, found {count}"),
        }
    }
}
