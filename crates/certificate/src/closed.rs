//! Closing an open surface: each missing face becomes a hole.
//!
//! ```text
//!      face │ no half-edge            face │ hole
//!       h ▲ │                  ──►     h ▲ │ ▼ added, the twin of h
//!         │ │                            │ │
//! ```
//!
//! The check of a [`SurfaceCertificate`](super::SurfaceCertificate) does not rely on any code here.

use super::answers::Answers;
use super::columns::{Column, Labels, LabelsError, MOST_SLOTS, VACANT};
use super::labels::nils;
use super::saved::number;
use super::storage::Entries as _;
use super::surface::Surface;
use crate::NIL;
use alloc::vec::Vec;
use twinedge::validate::{BoundaryPlace, Link, Part, View};

/// Returns the links of a structure on surfaces as columns, with added twins and boundary components without face.
pub(super) fn closed<V: View + ?Sized>(view: &V) -> Result<Labels, LabelsError> {
    let mut made = Labels::of_links(view)?;
    if !view.parts().has(Part::Faces) {
        made.find_cycles(view)?;
    }
    let s = Surface(Answers::new(view, &made));
    let mut columns = half_edges(&s)?;
    faces(&s, &mut columns)?;
    add_holes(&mut columns, s.0.vertices)?;
    let leaving = |v| live(s.0.is_vertex(v), within(s.0.half_edges, s.0.leaving(v)));
    columns.set(Column::VertexLeaving, filled(s.0.vertices, leaving)?);
    Ok(columns)
}

/// Returns the half-edges, followed by a new twin for each half-edge without one.
fn half_edges<V: View + ?Sized>(s: &Surface<'_, V>) -> Result<Labels, LabelsError> {
    let of = |link: &dyn Fn(usize) -> Link, slots| filled(s.0.half_edges, |h| within(slots, link(h)));
    let mut origin = filled(s.0.half_edges, |h| live(s.0.is_half_edge(h), number(s.0.origin(h))))?;
    let mut twin = of(&|h| s.0.twin(h), s.0.half_edges)?;
    let (mut next, mut prev) = (of(&|h| s.0.next(h), s.0.half_edges)?, of(&|h| s.0.prev(h), s.0.half_edges)?);
    let mut boundary = of(&|h| s.boundary(h), s.boundaries())?;
    // For each vertex, the leaving and the arriving half-edge without a twin.
    let (mut leaving, mut arriving) = (nils(s.0.vertices)?, nils(s.0.vertices)?);
    let ends = |h: usize| [s.0.origin(h), s.0.next(h).and_then(|n| s.0.origin(n))];
    let single = (0..s.0.half_edges).filter(|h| s.0.is_half_edge(*h) && s.0.twin(*h).is_none());
    for h in single.clone() {
        let added = twin.len();
        if added >= MOST_SLOTS {
            return Err(LabelsError::TooLarge);
        }
        let [from, to] = ends(h);
        twin[h] = added as u32;
        put(&mut leaving, from, h);
        put(&mut arriving, to, h);
        twin.push(h as u32);
        origin.push(number(to));
        boundary.push(NIL);
    }
    // The twin of the half-edge that leaves the vertex ends there, and is followed by the twin of the arriving one.
    let across = |half_edge: Option<&u32>| half_edge.and_then(|h| twin.get(*h as usize)).copied().unwrap_or(NIL);
    for h in single {
        let [from, to] = ends(h);
        next.push(across(from.and_then(|v| arriving.get(v))));
        prev.push(across(to.and_then(|v| leaving.get(v))));
    }
    let mut columns = Labels::default();
    columns.set(Column::HalfEdgeOrigin, origin);
    columns.set(Column::HalfEdgeTwin, twin);
    columns.set(Column::HalfEdgeNext, next);
    columns.set(Column::HalfEdgePrev, prev);
    columns.set(Column::HalfEdgeBoundary, boundary);
    Ok(columns)
}

/// Adds the faces and their boundary components. If boundary components are not stored, they have the numbers of the faces.
fn faces<V: View + ?Sized>(s: &Surface<'_, V>, columns: &mut Labels) -> Result<(), LabelsError> {
    let faces = if s.0.by_record() { s.0.faces } else { s.boundaries() };
    let is_face = |f| if s.0.by_record() { s.0.is_face(f) } else { s.is_boundary(f) };
    let outer = |f| if s.0.by_record() { s.0.outer(f) } else { Some(f) };
    // A record without a face is no hole: its link leads nowhere.
    let face = |b| match s.0.by_record() {
        false => Some(b),
        true if s.0.place(b) == Some(BoundaryPlace::Outer) => s.0.boundary_face(b).or(Some(usize::MAX)),
        true => Some(usize::MAX),
    };
    columns.set(Column::FaceOuter, filled(faces, |f| live(is_face(f), within(s.boundaries(), outer(f))))?);
    columns.set(Column::BoundaryFace, filled(s.boundaries(), |b| live(s.is_boundary(b), number(face(b))))?);
    columns.set(Column::BoundaryStart, filled(s.boundaries(), |b| within(s.0.half_edges, s.start(b)))?);
    Ok(())
}

/// Adds a boundary component without a face for each cycle of half-edges that have none.
fn add_holes(columns: &mut Labels, vertices: usize) -> Result<(), LabelsError> {
    let mut border = nils(vertices)?;
    for start in 0..columns.column(Column::HalfEdgeBoundary).len() {
        let mut at = start;
        let hole = columns.column(Column::BoundaryFace).len();
        let is_free = |columns: &Labels, h: usize| {
            let is_live = columns.column(Column::HalfEdgeOrigin).get(h).is_some_and(|origin| *origin != VACANT);
            is_live && columns.number(Column::HalfEdgeBoundary, h) == NIL
        };
        if !is_free(columns, at) {
            continue;
        }
        if hole >= MOST_SLOTS {
            return Err(LabelsError::TooLarge);
        }
        columns.column_mut(Column::BoundaryFace).push(NIL);
        columns.column_mut(Column::BoundaryStart).push(start as u32);
        while is_free(columns, at) {
            columns.column_mut(Column::HalfEdgeBoundary)[at] = hole as u32;
            let origin = columns.number(Column::HalfEdgeOrigin, at) as usize;
            put(&mut border, Some(origin), at);
            at = columns.number(Column::HalfEdgeNext, at) as usize;
        }
    }
    columns.set(Column::VertexBorder, border);
    Ok(())
}

/// Sets the entry of this slot, if it exists.
fn put(column: &mut [u32], slot: Link, number: usize) {
    if let Some(entry) = slot.and_then(|slot| column.get_mut(slot)) {
        *entry = number as u32;
    }
}

/// Returns the number for the first column of a kind of record.
const fn live(is_live: bool, number: u32) -> u32 {
    if is_live { number } else { VACANT }
}

/// Returns a link as a number. A link beyond these slots must not lead to slots added after them.
fn within(slots: usize, link: Link) -> u32 {
    number(link.map(|to| if to < slots { to } else { usize::MAX }))
}

fn filled(slots: usize, entry: impl Fn(usize) -> u32) -> Result<Vec<u32>, LabelsError> {
    let mut filled = nils(slots)?;
    filled.iter_mut().enumerate().for_each(|(i, number)| *number = entry(i));
    Ok(filled)
}
