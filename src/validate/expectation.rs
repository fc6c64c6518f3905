//! What a structure is held to: the surface on which it lies, and the parts that it has.

/// A part that a structure may lack. Rules about a part that it lacks are not checked, and the report says so.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
#[non_exhaustive]
pub enum Part {
    /// `prev` links.
    Prev,
    /// A half-edge kept by each vertex.
    Leaving,
    /// Faces. Without them the structure is a combinatorial map: B and F do not apply.
    Faces,
    /// Records for boundary components. Without them half-edges name their face and faces name half-edges.
    BoundaryComponents,
    /// The place of a boundary component in the list of its face, as stored in the boundary component.
    Places,
    /// Lists of inner boundary components. Without them each face has one cycle, as in a mesh, and containment (T1, T2)
    /// is not represented. Nor is where an isolated vertex lies: `isolated` is not read, and B2 is not checked.
    Holes,
    /// The one face without outer boundary component. Without it, a component that lies outside all others lies in no
    /// face: it has no inner boundary component, and if it is an isolated vertex, no boundary component starts there.
    UnboundedFace,
}

impl Part {
    const fn bit(self) -> u8 {
        1 << self as u8
    }

    /// The name of the part, without article.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Prev => "prev links",
            Self::Leaving => "leaving half-edges",
            Self::Faces => "faces",
            Self::BoundaryComponents => "boundary component records",
            Self::Places => "places in the list of the face",
            Self::Holes => "lists of inner boundary components",
            Self::UnboundedFace => "unbounded face",
        }
    }
}

/// The surface on which the structure is to lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Surface {
    /// The plane: every component has genus 0 and containment is a tree rooted at the unbounded face.
    Plane,
    /// Orientable surfaces of any genus, one per component.
    Any,
}

/// What a structure is held to.
///
/// ```
/// use twinedge::validate::{Expectation, Part};
/// // A triangle mesh: no holes in faces, no unbounded face, a border whose half-edges have no face or no twin.
/// let mesh = Expectation::surface().without(Part::BoundaryComponents).without(Part::Prev).open();
/// assert!(!mesh.has(Part::Prev));
/// assert!(mesh.is_open());
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Expectation {
    surface: Surface,
    open: bool,
    lacks: u8,
}

impl Expectation {
    /// A planar subdivision with every part.
    #[must_use]
    pub const fn plane() -> Self {
        Self { surface: Surface::Plane, open: false, lacks: 0 }
    }

    /// A subdivision of closed orientable surfaces: no unbounded face, no holes in faces.
    #[must_use]
    pub const fn surface() -> Self {
        let lacks = Part::Holes.bit() | Part::UnboundedFace.bit();
        Self { surface: Surface::Any, open: false, lacks }
    }

    /// The same, for a structure that lacks this part, and the parts that depend on it.
    #[must_use]
    pub const fn without(mut self, part: Part) -> Self {
        self.lacks |= part.bit();
        self.lacks |= match part {
            Part::Faces => {
                Part::BoundaryComponents.bit() | Part::Places.bit() | Part::Holes.bit() | Part::UnboundedFace.bit()
            }
            Part::BoundaryComponents => Part::Places.bit(),
            // An unbounded face has inner boundary components only.
            Part::Holes => Part::UnboundedFace.bit(),
            _ => 0,
        };
        self
    }

    /// The same, but open boundaries are legal. At an edge of an open boundary one side is missing, in one of two ways:
    ///
    /// - There is one half-edge. It has a face, and no twin.
    /// - There are two half-edges, twins of each other. The one along the boundary has no face (no boundary component,
    ///   where there are records for these).
    ///
    /// A half-edge with neither twin nor face bounds nothing, and breaks R1. If the structure lacks faces, there is
    /// nothing to check of that.
    ///
    /// The outside of a component may be an open boundary, and then it has no inner boundary component.
    #[must_use]
    pub const fn open(mut self) -> Self {
        self.open = true;
        self
    }

    /// The surface on which the structure is to lie.
    #[must_use]
    pub const fn surface_kind(&self) -> Surface {
        self.surface
    }

    /// Whether open boundaries are legal.
    #[must_use]
    pub const fn is_open(&self) -> bool {
        self.open
    }

    /// Whether the structure has this part.
    #[must_use]
    pub const fn has(&self, part: Part) -> bool {
        self.lacks & part.bit() == 0
    }
}
