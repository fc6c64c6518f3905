//! The operators of triangle meshes, defined as steps of the basic operators.
//!
//! Kernels of triangle meshes have no `connect` and no `remove_edge`. They flip an edge, split an edge or a triangle, and collapse an
//! edge, each in one operation. The functions here define these operations by basic operators, and define when they are refused. They
//! are the operators `mesh_…` of the models and of [`Dcel`](crate::dcel::Dcel), with which [`conformance`](super::conformance)
//! compares a kernel.
//!
//! | operator | steps | refused unless |
//! | --- | --- | --- |
//! | [`flip_edge`] | `flip_edge`, either way: in two triangles both give the same edge | there is a triangle on both sides, and their two other vertices are not adjacent |
//! | [`split_edge`] | `split_edge`; on each side, `connect` the new vertex with the opposite one | each side is a triangle or outside, not both outside |
//! | [`split_face`] | `split_vertex`: a new vertex at a new edge; `connect` it with the two other corners | the face is a triangle |
//! | [`collapse_edge`] | `contract_edge`; on each side, `remove_edge` one of the two edges that are parallel now | each side is a triangle or outside, not both outside, and the link condition holds |
//!
//! *Outside* is the border of a mesh ([`Refusal::Border`]) and the unbounded face of a map.
//!
//! # The link condition
//!
//! The link of a vertex is the boundary of its triangles: their other vertices, and the edges opposite. The link of an edge is the
//! vertices opposite. The border counts as if joined to one extra vertex. Collapsing an edge ab of a simple triangulation yields a
//! simple triangulation of the same surface if and only if the links of a and b intersect exactly in the link of ab (Dey,
//! Edelsbrunner, Guha and Nekhayev, *Topology preserving edge contraction*, 1999). The condition rules out a third vertex adjacent to
//! both, an inner edge between two border vertices, a border of three edges, and the tetrahedron.
//!
//! # Handles
//!
//! Kernels may choose the handles, except that the half-edges of the surrounding boundary keep theirs: the other edges of the
//! triangles at the edge, or, for a triangle that collapses, the other edges of the triangles beyond. The new half-edges are found
//! from these by `next` and `twin`. A kernel may therefore turn an edge either way, and keep either of two merged edges. Vertices keep
//! their handles; a kernel keeps one end of a collapsed edge, and
//! [`collapse_keeps`](crate::program::conformance::Conformance::collapse_keeps) can fix which one.
//!
//! A kernel that moves half-edges to other indices, as it must where `next` is arithmetic on the index, or that does not store the
//! half-edges on its border, is tested through [`Named`].

mod named;

pub use named::Named;

use super::operators::Call;
use super::subject::{Refusal, Subject};
use crate::dcel::{Corner, Turn};
use alloc::vec;
use alloc::vec::Vec;

/// Tells whether a face, not the outside, lies to the left of a half-edge. Without faces, only half-edges without `next` are outside.
pub(super) fn is_inside<K: Subject>(subject: &K, h: K::HalfEdge) -> Result<bool, Refusal> {
    match subject.face_of(Corner::At(h)) {
        Err(Refusal::Border) => Ok(false),
        Err(Refusal::Unsupported) => Ok(subject.next_of(h) != Err(Refusal::Unsupported)),
        other => other.map(|face| Some(face) != subject.unbounded_face()),
    }
}

/// The half-edges of the triangle to the left of `h`, beginning with `h`; `None` if the left side is outside.
fn triangle<K: Subject>(subject: &K, h: K::HalfEdge) -> Result<Option<[K::HalfEdge; 3]>, Refusal> {
    if !is_inside(subject, h)? {
        return Ok(None);
    }
    let second = subject.next_of(h)?;
    let third = subject.next_of(second)?;
    if subject.next_of(third)? == h && second != h { Ok(Some([h, second, third])) } else { Err(Refusal::NotTriangle) }
}

/// The two different triangles at an edge; at most one is missing.
type Sides<H> = [Option<[H; 3]>; 2];

fn sides<K: Subject>(subject: &K, h: K::HalfEdge) -> Result<Sides<K::HalfEdge>, Refusal> {
    let twin = subject.twin_of(h)?;
    let [left, right] = [triangle(subject, h)?, triangle(subject, twin)?];
    if left.is_none() && right.is_none() {
        return Err(Refusal::Border);
    }
    if left.is_some_and(|left| left.contains(&twin)) { Err(Refusal::NotTriangle) } else { Ok([left, right]) }
}

fn leaving<K: Subject>(subject: &K, h: K::HalfEdge) -> Result<Vec<K::HalfEdge>, Refusal> {
    let mut all = vec![h];
    let mut at = subject.next_of(subject.twin_of(h)?)?;
    while at != h {
        all.push(at);
        at = subject.next_of(subject.twin_of(at)?)?;
    }
    Ok(all)
}

fn target<K: Subject>(subject: &K, h: K::HalfEdge) -> Result<K::Vertex, Refusal> {
    subject.origin_of(subject.twin_of(h)?)
}

/// The link of a vertex: vertices, and edges by their ends. `None` is the extra vertex joined with the border.
struct Link<V> {
    vertices: Vec<Option<V>>,
    edges: Vec<[Option<V>; 2]>,
}

fn link<K: Subject>(subject: &K, h: K::HalfEdge) -> Result<Link<K::Vertex>, Refusal> {
    let mut link = Link { vertices: Vec::new(), edges: Vec::new() };
    for side in leaving(subject, h)? {
        let end = Some(target(subject, side)?);
        link.vertices.push(end);
        // The third vertex of the triangle to the left; on the border, the extra vertex.
        if let Some([_, second, _]) = triangle(subject, side)? {
            link.edges.push([end, Some(target(subject, second)?)]);
        } else {
            let before = before_on_border(subject, side)?;
            link.vertices.push(None);
            link.edges.extend([[end, None], [Some(before), None]]);
        }
    }
    Ok(link)
}

/// The vertex before the origin of `h` on its cycle: the target of the last half-edge of the rotation before `h`.
fn before_on_border<K: Subject>(subject: &K, h: K::HalfEdge) -> Result<K::Vertex, Refusal> {
    let mut at = h;
    loop {
        let following = subject.next_of(subject.twin_of(at)?)?;
        if following == h {
            // next(twin(at)) = h, so twin(at) comes before h.
            return target(subject, at);
        }
        at = following;
    }
}

/// Tells whether the links of the two ends share only the vertices opposite.
fn link_condition<K: Subject>(subject: &K, h: K::HalfEdge, sides: &Sides<K::HalfEdge>) -> Result<bool, Refusal> {
    let twin = subject.twin_of(h)?;
    let [origin, target] = [subject.origin_of(h)?, subject.origin_of(twin)?];
    let mut opposite = Vec::new();
    for side in sides {
        opposite.push(side.map(|[_, _, third]| subject.origin_of(third)).transpose()?);
    }
    // A loop, or a triangle containing one.
    if origin == target || opposite.contains(&Some(origin)) || opposite.contains(&Some(target)) {
        return Ok(false);
    }
    let (a, b) = (link(subject, h)?, link(subject, twin)?);
    let common = |v: &Option<K::Vertex>| b.vertices.contains(v);
    let same = |one: [Option<K::Vertex>; 2], other: [Option<K::Vertex>; 2]| one == other || one == [other[1], other[0]];
    Ok(opposite[0] != opposite[1]
        && a.vertices.iter().filter(|v| common(v)).all(|v| opposite.contains(v))
        && !a.edges.iter().any(|edge| b.edges.iter().any(|other| same(*edge, *other))))
}

/// Flips an edge inside its two triangles, to join the two other vertices. This implementation turns the half-edge counter-clockwise,
/// from the vertex opposite on its right to the vertex opposite on its left; a kernel may also turn it clockwise.
///
/// O(degree²) questions plus `flip_edge`.
///
/// # Errors
/// [`Refusal::Stale`]; [`Refusal::Border`] if a side is outside; [`Refusal::NotTriangle`] if a side is not a triangle, or both are the
/// same one; [`Refusal::NotSimple`] if the two other vertices are the same or adjacent.
pub fn flip_edge<K: Subject>(subject: &mut K, half_edge: K::HalfEdge) -> Result<(), Refusal> {
    let twin = subject.twin_of(half_edge)?;
    if !is_inside(subject, half_edge)? || !is_inside(subject, twin)? {
        return Err(Refusal::Border);
    }
    let [Some(left), Some(right)] = sides(subject, half_edge)? else { return Err(Refusal::Border) };
    let (c, d) = (subject.origin_of(left[2])?, subject.origin_of(right[2])?);
    let mut adjacent = c == d;
    for h in leaving(subject, left[2])? {
        adjacent |= target(subject, h)? == d;
    }
    if adjacent {
        return Err(Refusal::NotSimple);
    }
    subject.apply(Call::FlipEdge { half_edge, turn: Turn::CounterClockwise }).map(drop)
}

/// Puts a new vertex on an edge, and joins it with the opposite vertex of each triangle.
///
/// O(1) questions plus the steps.
///
/// # Errors
/// [`Refusal::Stale`]; [`Refusal::Border`] if both sides are outside; [`Refusal::NotTriangle`] if an inside side is not a triangle, or
/// both are the same one; [`Refusal::Full`].
pub fn split_edge<K: Subject>(subject: &mut K, half_edge: K::HalfEdge) -> Result<(), Refusal> {
    let [left, right] = sides(subject, half_edge)?;
    let n = subject.make_edge(Call::SplitEdge { half_edge })?;
    // The corners of the new vertex: `n` leaves it on the left of the edge, the twin of the given half-edge on the right.
    let twin = subject.twin_of(half_edge)?;
    let mut made = Vec::new();
    for (corner, side) in [(n, left), (twin, right)] {
        let Some([_, _, third]) = side else { continue };
        match subject.make_edge(Call::connect(Corner::At(corner), Corner::At(third))) {
            Ok(edge) => made.push(edge),
            Err(refusal) => {
                undo(subject, made)?;
                subject.apply(Call::JoinEdges { half_edge })?;
                return Err(refusal);
            }
        }
    }
    Ok(())
}

/// Puts a new vertex into the triangle to the left of a half-edge, and joins it with the three corners.
///
/// O(1) questions plus the steps.
///
/// # Errors
/// [`Refusal::Stale`]; [`Refusal::Border`] if the face is outside; [`Refusal::NotTriangle`]; [`Refusal::Full`].
pub fn split_face<K: Subject>(subject: &mut K, half_edge: K::HalfEdge) -> Result<(), Refusal> {
    let [first, second, third] = triangle(subject, half_edge)?.ok_or(Refusal::Border)?;
    let n = subject.make_edge(Call::SplitVertex { from: Corner::At(first), to: Corner::At(first) })?;
    let mut made = Vec::new();
    let mut corner = subject.twin_of(n)?;
    for to in [second, third] {
        match subject.make_edge(Call::connect(Corner::At(corner), Corner::At(to))) {
            Ok(edge) => {
                made.push(edge);
                corner = edge;
            }
            Err(refusal) => {
                undo(subject, made)?;
                subject.apply(Call::ContractEdge { half_edge: n })?;
                return Err(refusal);
            }
        }
    }
    Ok(())
}

/// Removes the edges of a failed operator, the last one first.
fn undo<K: Subject>(subject: &mut K, made: Vec<K::HalfEdge>) -> Result<(), Refusal> {
    made.into_iter().rev().try_for_each(|edge| subject.apply(Call::RemoveEdge { half_edge: edge }).map(drop))
}

/// Collapses an edge to a vertex, together with its triangles; the two other edges of each triangle merge.
///
/// O(degree²) questions plus the steps.
///
/// # Errors
/// [`Refusal::Stale`]; [`Refusal::Border`] if both sides are outside; [`Refusal::NotTriangle`] if an inside side is not a triangle,
/// both are the same one, or a face at either end is not a triangle; [`Refusal::NotSimple`] if the link condition does not hold.
pub fn collapse_edge<K: Subject>(subject: &mut K, half_edge: K::HalfEdge) -> Result<(), Refusal> {
    let found = sides(subject, half_edge)?;
    if !link_condition(subject, half_edge, &found)? {
        return Err(Refusal::NotSimple);
    }
    subject.apply(Call::ContractEdge { half_edge })?;
    for [_, second, third] in found.into_iter().flatten() {
        // Keep the edge on the border.
        let beyond = subject.twin_of(second)?;
        let is_border = !is_inside(subject, beyond)?;
        subject.apply(Call::RemoveEdge { half_edge: if is_border { third } else { second } })?;
    }
    Ok(())
}
