//! The parts that a structure stores.

use core::fmt;

/// A part that some structures store and others do not. Rules about a missing part are not checked, and the report says so.
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
    /// The place of a boundary component in the list of its face, stored in the boundary component.
    Places,
    /// Lists of inner boundary components. Without them each face has one cycle, as in a mesh, and neither containment (T1, T2) nor
    /// the face of an isolated vertex is represented: `isolated` is not read, and B2 is not checked.
    Holes,
    /// The one face without outer boundary component. Without it, a component outside all others lies in no face: it has no inner
    /// boundary component, and for an isolated vertex no boundary component exists.
    UnboundedFace,
}

impl Part {
    /// All parts.
    pub const ALL: [Self; 7] = [
        Self::Prev,
        Self::Leaving,
        Self::Faces,
        Self::BoundaryComponents,
        Self::Places,
        Self::Holes,
        Self::UnboundedFace,
    ];

    const fn bit(self) -> u8 {
        1 << self as u8
    }

    /// Returns the name of the part, without article.
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

    /// Returns the word for the part in tables and JSON.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Prev => "prev",
            Self::Leaving => "leaving",
            Self::Faces => "faces",
            Self::BoundaryComponents => "boundary_components",
            Self::Places => "places",
            Self::Holes => "holes",
            Self::UnboundedFace => "unbounded_face",
        }
    }

    /// Returns the part with this [word](Self::word).
    #[must_use]
    pub fn from_word(word: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|part| part.word() == word)
    }

    const fn needs(self) -> u8 {
        match self {
            Self::Prev | Self::Leaving | Self::Faces => 0,
            Self::BoundaryComponents | Self::Holes => Self::Faces.bit(),
            Self::Places => Self::Faces.bit() | Self::BoundaryComponents.bit(),
            // An unbounded face has only inner boundary components.
            Self::UnboundedFace => Self::Faces.bit() | Self::Holes.bit(),
        }
    }
}

/// A set of parts that a structure stores besides `origin`, `twin` and `next`: the answer of [`View::parts`](super::View::parts).
///
/// Adding a part adds its dependencies, and removing a part removes its dependents. Places depend on boundary components, the
/// unbounded face on holes, and all four on faces.
///
/// ```
/// use twinedge::validate::{Part, Parts};
/// // Faces with holes that name half-edges, and an unbounded face.
/// let parts = Parts::NONE.with(Part::UnboundedFace);
/// assert!(parts.has(Part::Holes) && parts.has(Part::Faces) && !parts.has(Part::BoundaryComponents));
/// assert_eq!(Parts::ALL.without(Part::Faces), Parts::NONE.with(Part::Prev).with(Part::Leaving));
/// ```
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub struct Parts(u8);

impl Parts {
    /// No parts: a combinatorial map of `origin`, `twin` and `next`.
    pub const NONE: Self = Self(0);

    /// Every part.
    pub const ALL: Self = {
        let (mut all, mut i) = (0, 0);
        while i < Part::ALL.len() {
            all |= Part::ALL[i].bit();
            i += 1;
        }
        Self(all)
    };

    /// Returns these parts with `part` and its dependencies.
    #[must_use]
    pub const fn with(self, part: Part) -> Self {
        Self(self.0 | part.bit() | part.needs())
    }

    /// Returns these parts without `part` and its dependents.
    #[must_use]
    pub const fn without(self, part: Part) -> Self {
        let (mut rest, mut i) = (self.0 & !part.bit(), 0);
        while i < Part::ALL.len() {
            if Part::ALL[i].needs() & part.bit() != 0 {
                rest &= !Part::ALL[i].bit();
            }
            i += 1;
        }
        Self(rest)
    }

    /// Returns the parts in both sets.
    #[must_use]
    pub const fn intersection(self, other: Self) -> Self {
        Self(self.0 & other.0)
    }

    /// Returns true if the part is stored.
    #[must_use]
    pub const fn has(self, part: Part) -> bool {
        self.0 & part.bit() != 0
    }

    /// Returns the parts one by one, in the order of [`Part::ALL`].
    pub fn iter(self) -> impl Iterator<Item = Part> {
        Part::ALL.into_iter().filter(move |part| self.has(*part))
    }
}

/// Every part, the default of a [`Table`](super::super::Table).
impl Default for Parts {
    fn default() -> Self {
        Self::ALL
    }
}

/// Collects parts, with their dependencies.
impl FromIterator<Part> for Parts {
    fn from_iter<I: IntoIterator<Item = Part>>(parts: I) -> Self {
        parts.into_iter().fold(Self::NONE, Self::with)
    }
}

/// Prints the set of parts.
impl fmt::Debug for Parts {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_set().entries(self.iter()).finish()
    }
}

/// A list of the parts. Reading adds dependencies.
#[cfg(feature = "serde")]
impl serde::Serialize for Parts {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(self.iter())
    }
}

#[cfg(feature = "serde")]
impl<'de> serde::Deserialize<'de> for Parts {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        Ok(alloc::vec::Vec::<Part>::deserialize(deserializer)?.into_iter().collect())
    }
}
