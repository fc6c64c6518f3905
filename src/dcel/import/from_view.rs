//! Builds a [`Dcel`] from any valid structure, with the mapping from indices of the view to keys.

use super::error::{ImportError, Outside};
use super::gather::{Columns, Gather, Numbers};
use crate::dcel::structure::Dcel;
use crate::numbers::NIL;
use crate::store::{BoundaryKey, FaceKey, HalfEdgeKey, VertexKey};
use crate::validate::{Collect, Expectation, Part, Parts, Report, View, validate};
use alloc::boxed::Box;
use alloc::vec::Vec;

impl Dcel {
    /// Builds the structure that a view describes, and returns the new keys of its records.
    ///
    /// The view is validated first, and the result again, so only planar subdivisions are accepted, whatever the view
    /// answers.
    ///
    /// | the structure stores | expectation | outside |
    /// | --- | --- | --- |
    /// | an unbounded face and lists of holes | [`Expectation::plane`] | [`Outside::Given`] |
    /// | one cycle for each face, closed, genus 0 | [`Expectation::surface`] | [`Outside::Face`] |
    /// | one cycle for each face, and one border | `Expectation::surface().open()` | [`Outside::Border`] |
    ///
    /// Boundary components, their places, `prev` and leaving half-edges are optional.
    ///
    /// Records and lists keep their order; of the two half-edges of an edge, the one with the smaller index in the view
    /// gets the smaller index.
    ///
    /// O(n) time and memory for n slots of the view.
    ///
    /// # Errors
    /// [`ImportError::Invalid`] with the report, if the view breaks a rule. For a valid view: [`ImportError::Lacks`] if it
    /// has no faces; [`ImportError::NoUnboundedFace`], [`ImportError::SecondUnboundedFace`] and [`ImportError::NoSuchFace`]
    /// if `outside` does not suit it; [`ImportError::Genus`] and [`ImportError::Disconnected`]; [`ImportError::Border`],
    /// [`ImportError::NoBorder`] and [`ImportError::SeveralBorders`]; [`ImportError::NotPlane`] with the report, if a
    /// component then lies in no face or in two; [`ImportError::Inconsistent`] if the view changes its answers;
    /// [`ImportError::Full`].
    ///
    /// ```
    /// use twinedge::dcel::{Dcel, Outside};
    /// use twinedge::validate::{Expectation, Link, Part, Parts, View};
    ///
    /// /// A tetrahedron: half-edges `3f`, `3f + 1`, `3f + 2` around face `f`.
    /// struct Tetrahedron;
    ///
    /// impl View for Tetrahedron {
    ///     fn parts(&self) -> Parts { Parts::NONE.with(Part::Faces) }
    ///     fn vertex_slots(&self) -> usize { 4 }
    ///     fn half_edge_slots(&self) -> usize { 12 }
    ///     fn face_slots(&self) -> usize { 4 }
    ///     fn origin(&self, h: usize) -> Link { Some([0, 1, 2, 0, 3, 1, 1, 3, 2, 2, 3, 0][h]) }
    ///     fn twin(&self, h: usize) -> Link { Some([5, 8, 11, 10, 6, 0, 4, 9, 1, 7, 3, 2][h]) }
    ///     fn next(&self, h: usize) -> Link { Some(h - h % 3 + (h + 1) % 3) }
    ///     fn face(&self, h: usize) -> Link { Some(h / 3) }
    ///     fn outer_half_edge(&self, f: usize) -> Link { Some(3 * f) }
    /// }
    ///
    /// let (map, keys) = Dcel::from_view(&Tetrahedron, &Expectation::surface(), Outside::Face(3))?;
    /// assert_eq!(keys.face(3), Some(map.unbounded_face().key()));
    /// let h = map.half_edge(keys.half_edge(0).unwrap())?;
    /// assert_eq!(Some(h.next().key()), keys.half_edge(1));
    /// assert_eq!(Some(h.origin().key()), keys.vertex(0));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn from_view<V: View + ?Sized>(
        view: &V,
        expectation: &Expectation,
        outside: Outside,
    ) -> Result<(Self, Keys), ImportError> {
        let assemble = |columns: &Columns, _: &Numbers| columns.assembly().assemble_right().map_err(ImportError::Full);
        let (dcel, numbers) = import(view, *expectation, outside, assemble)?;
        let keys = keys(&dcel, &numbers);
        Ok((dcel, keys))
    }
}

pub(super) fn import<V: View + ?Sized>(
    view: &V,
    expectation: Expectation,
    outside: Outside,
    assemble: impl FnOnce(&Columns, &Numbers) -> Result<Dcel, ImportError>,
) -> Result<(Dcel, Numbers), ImportError> {
    let report = validate(view, &expectation, Collect::All);
    if !report.is_valid() {
        return Err(ImportError::Invalid(Box::new(report)));
    }
    let parts = expectation.looks_at(view.parts());
    check_outside(view, parts, outside)?;
    check_surface(&report, parts, outside)?;
    let (columns, numbers) = Gather::read(view, expectation, outside)?;
    if outside == Outside::Border {
        check_borders(&report, columns.outside_cycles())?;
    }
    let dcel = assemble(&columns, &numbers)?;
    let report = dcel.validate();
    if report.is_valid() { Ok((dcel, numbers)) } else { Err(ImportError::NotPlane(Box::new(report))) }
}

fn check_outside<V: View + ?Sized>(view: &V, parts: Parts, outside: Outside) -> Result<(), ImportError> {
    if !parts.has(Part::Faces) {
        return Err(ImportError::Lacks(Part::Faces));
    }
    match (outside, parts.has(Part::UnboundedFace)) {
        (Outside::Given, false) => Err(ImportError::NoUnboundedFace),
        (Outside::Face(_) | Outside::Border, true) => Err(ImportError::SecondUnboundedFace),
        (Outside::Face(f), false) if f >= view.face_slots() || !view.is_face(f) => Err(ImportError::NoSuchFace(f)),
        _ => Ok(()),
    }
}

/// Checks that the structure lies on a sphere, and is connected if nothing says how components nest.
fn check_surface(report: &Report, parts: Parts, outside: Outside) -> Result<(), ImportError> {
    let counts = report.counts();
    match (counts.genus, counts.components) {
        (Some(genus), _) if genus > 0 => Err(ImportError::Genus(genus)),
        (_, Some(components)) if components > 1 && matches!(outside, Outside::Face(_)) && !parts.has(Part::Holes) => {
            Err(ImportError::Disconnected(components))
        }
        _ => Ok(()),
    }
}

/// Checks that each component has exactly one border or other outside cycle.
fn check_borders(report: &Report, borders: usize) -> Result<(), ImportError> {
    let counts = report.counts();
    let components = counts.components.unwrap_or(0).saturating_sub(counts.isolated_vertices);
    match borders.cmp(&components) {
        core::cmp::Ordering::Less => Err(ImportError::NoBorder),
        core::cmp::Ordering::Equal => Ok(()),
        core::cmp::Ordering::Greater => Err(ImportError::SeveralBorders { borders, components }),
    }
}

pub(super) fn keys(dcel: &Dcel, numbers: &Numbers) -> Keys {
    // Slot 0 of each kind is vacant, and so is the first pair of half-edges.
    fn all<K>(numbers: &[u32], key: impl Fn(usize) -> Option<K>) -> Vec<Option<K>> {
        numbers.iter().map(|n| if *n == NIL { None } else { key(*n as usize) }).collect()
    }
    Keys {
        vertices: all(&numbers.vertices, |n| dcel.vertex_at(n + 1).map(|v| v.key())),
        half_edges: all(&numbers.half_edges, |n| dcel.half_edge_at(n + 2).map(|h| h.key())),
        boundaries: all(&numbers.boundaries, |n| dcel.boundary_at(n + 1).map(|b| b.key())),
        faces: all(&numbers.faces, |n| dcel.face_at(n + 1).map(|f| f.key())),
    }
}

/// The keys in the [`Dcel`](crate::dcel::Dcel) of the records of a view, by index.
///
/// Records that the view does not have, such as missing twins along a border, are omitted.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Keys {
    pub(super) vertices: Vec<Option<VertexKey>>,
    pub(super) half_edges: Vec<Option<HalfEdgeKey>>,
    pub(super) boundaries: Vec<Option<BoundaryKey>>,
    pub(super) faces: Vec<Option<FaceKey>>,
}

impl Keys {
    /// Returns the key of the vertex with this index in the view; `None` if the slot was vacant. O(1).
    #[must_use]
    pub fn vertex(&self, index: usize) -> Option<VertexKey> {
        self.vertices.get(index).copied().flatten()
    }

    /// Returns the key of the half-edge with this index in the view; `None` if the slot was vacant. O(1).
    #[must_use]
    pub fn half_edge(&self, index: usize) -> Option<HalfEdgeKey> {
        self.half_edges.get(index).copied().flatten()
    }

    /// Returns the key of the boundary component with this index in the view; `None` if the slot was vacant, or if the
    /// view has no records of boundary components. O(1).
    #[must_use]
    pub fn boundary(&self, index: usize) -> Option<BoundaryKey> {
        self.boundaries.get(index).copied().flatten()
    }

    /// Returns the key of the face with this index in the view; `None` if the slot was vacant. O(1).
    #[must_use]
    pub fn face(&self, index: usize) -> Option<FaceKey> {
        self.faces.get(index).copied().flatten()
    }
}
