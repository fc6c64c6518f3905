//! An open surface is closed: wherever a face is missing, there is a hole.
//!
//! ```text
//!      face │ no half-edge            face │ hole
//!       h ▲ │                  ──►     h ▲ │ ▼ added, the twin of h
//!         │ │                            │ │
//! ```
//!
//! Nothing here has to be right for the check of a [`SurfaceCertificate`](super::SurfaceCertificate) to be.

use super::answers::Answers;
use super::columns::{Column, Labels, LabelsError, MOST_SLOTS, VACANT};
use super::labels::nils;
use super::saved::number;
use super::surface::Surface;
use crate::slots::NIL;
use crate::validate::structure::{BoundaryPlace, Link, Part, View};
use alloc::vec::Vec;

/// The links of a structure on surfaces as columns, in which each half-edge has a twin and a boundary component. The boundary components
/// that are added have no face.
pub(super) fn closed<V: View + ?Sized>(view: &V) -> Result<Labels, LabelsError> {
    let mut made = Labels::of_links(view)?;
    if !view.parts().has(Part::Faces) {
        made.find_cycles(view)?;
    }
    let s = Surface(Answers::new(view, &made));
    let mut columns = half_edges(&s)?;
    faces(&s, &mut columns)?;
    add_holes(&mut columns, s.0.vertices)?;
    let leaving =
        filled(s.0.vertices, |v| if s.0.is_vertex(v) { within(s.0.half_edges, s.0.leaving(v)) } else { VACANT })?;
    columns.set(Column::VertexLeaving, leaving);
    Ok(columns)
}

/// The half-edges, and after them a twin for each that has none.
fn half_edges<V: View + ?Sized>(s: &Surface<'_, V>) -> Result<Labels, LabelsError> {
    let of = |link: &dyn Fn(usize) -> Link, slots| filled(s.0.half_edges, |h| within(slots, link(h)));
    let mut origin = filled(s.0.half_edges, |h| if s.0.is_half_edge(h) { number(s.0.origin(h)) } else { VACANT })?;
    let mut twin = of(&|h| s.0.twin(h), s.0.half_edges)?;
    let (mut next, mut prev) = (of(&|h| s.0.next(h), s.0.half_edges)?, of(&|h| s.0.prev(h), s.0.half_edges)?);
    let mut boundary = of(&|h| s.boundary(h), s.boundaries())?;
    // For each vertex the half-edge without twin that leaves it, and the one that arrives there.
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
        for (at, half_edge) in [(from.and_then(|v| leaving.get_mut(v)), h), (to.and_then(|v| arriving.get_mut(v)), h)] {
            at.into_iter().for_each(|at| *at = half_edge as u32);
        }
        twin.push(h as u32);
        origin.push(number(to));
        boundary.push(NIL);
    }
    // The twin of the one that leaves the vertex ends there, and is followed by the twin of the one that arrives.
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

/// The faces and their boundary components. Where these are no records of their own, they have the numbers of the faces.
fn faces<V: View + ?Sized>(s: &Surface<'_, V>, columns: &mut Labels) -> Result<(), LabelsError> {
    let faces = if s.0.by_record() { s.0.faces } else { s.boundaries() };
    let is_face = |f| if s.0.by_record() { s.0.is_face(f) } else { s.is_boundary(f) };
    let outer = |f| if s.0.by_record() { s.0.outer(f) } else { Some(f) };
    // A record without face is no hole: its link leads nowhere.
    let face = |b| match s.0.by_record() {
        false => Some(b),
        true if s.0.place(b) == Some(BoundaryPlace::Outer) => s.0.boundary_face(b).or(Some(usize::MAX)),
        true => Some(usize::MAX),
    };
    columns
        .set(Column::FaceOuter, filled(faces, |f| if is_face(f) { within(s.boundaries(), outer(f)) } else { VACANT })?);
    columns.set(
        Column::BoundaryFace,
        filled(s.boundaries(), |b| if s.is_boundary(b) { number(face(b)) } else { VACANT })?,
    );
    columns.set(Column::BoundaryStart, filled(s.boundaries(), |b| within(s.0.half_edges, s.start(b)))?);
    Ok(())
}

/// Half-edges without boundary component get one for each cycle, without face.
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
            border.get_mut(origin).into_iter().for_each(|border| *border = at as u32);
            at = columns.number(Column::HalfEdgeNext, at) as usize;
        }
    }
    columns.set(Column::VertexBorder, border);
    Ok(())
}

/// A link as a number. One that leads to none of these slots does not lead to what is added after them.
fn within(slots: usize, link: Link) -> u32 {
    number(link.map(|to| if to < slots { to } else { usize::MAX }))
}

fn filled(slots: usize, entry: impl Fn(usize) -> u32) -> Result<Vec<u32>, LabelsError> {
    let mut filled = nils(slots)?;
    filled.iter_mut().enumerate().for_each(|(i, number)| *number = entry(i));
    Ok(filled)
}
