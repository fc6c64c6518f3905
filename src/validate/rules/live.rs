//! R1 live: every link that a record needs is there, and every link leads to a live record.
//!
//! ```text
//!   half-edge 3 ── next ──► 7     ok if slot 7 holds a half-edge
//!                  next ──► nil   a cycle that ends
//!                  next ──► 99    past the end, or a retired record
//! ```
//!
//! At an open boundary the twin or the face of a half-edge may be nil, but not both: such a half-edge bounds nothing, and
//! no other record is on its other side.
//!
//! A structure may claim lists of any length. Each boundary component is listed once, so no more than twice as many
//! entries as there are boundary components, and 16, are read; a list that goes on after that breaks R1, because its links
//! cannot be said to be live. Without records for boundary components, vertices and half-edges are counted instead.

use crate::validate::columns::{Fan, NIL, column};
use crate::validate::expectation::Part;
use crate::validate::findings::{Flow, Halt};
use crate::validate::record::{Field, Record};
use crate::validate::rule::Rule;
use crate::validate::run::Run;
use crate::validate::view::{Link, Start, View};
use crate::validate::violation::Violation;

/// The kind of record that a link leads to.
#[derive(Clone, Copy)]
enum RecordKind {
    Vertex,
    HalfEdge,
    Boundary,
    Face,
}

/// Runs R1, and counts the records on the way.
pub(in crate::validate) fn check<V: View + ?Sized>(run: &mut Run<'_, V>) -> Result<(), Halt> {
    half_edges(run)?;
    run.map_is_live = run.findings.holds(Rule::R1);
    vertices(run)?;
    boundaries(run)?;
    faces(run)
}

/// Whether the link leads to a live record of that kind.
#[inline]
fn leads<V: View + ?Sized>(run: &Run<'_, V>, link: usize, kind: RecordKind) -> bool {
    match kind {
        RecordKind::Vertex => link < run.vertices as usize && run.view.is_vertex(link),
        RecordKind::HalfEdge => link < run.half_edges as usize && run.view.is_half_edge(link),
        RecordKind::Boundary => link < run.boundaries as usize && run.view.is_boundary(link),
        RecordKind::Face => link < run.faces as usize && run.view.is_face(link),
    }
}

/// Checks one link; nil is a violation only where the record needs it.
#[inline]
fn check_link<V: View + ?Sized>(
    run: &mut Run<'_, V>,
    (record, field): (Record, Field),
    link: Link,
    kind: RecordKind,
    needed: bool,
) -> Flow {
    match link {
        Some(value) if leads(run, value, kind) => Ok(()),
        Some(value) => run.findings.add(Violation::Dangling { record, field, value }),
        None if needed => run.findings.add(Violation::Nil { record, field }),
        None => Ok(()),
    }
}

fn check_start<V: View + ?Sized>(run: &mut Run<'_, V>, (record, field): (Record, Field), start: Option<Start>) -> Flow {
    let (link, kind) = match start {
        Some(Start::Vertex(v)) => (Some(v), RecordKind::Vertex),
        Some(Start::HalfEdge(h)) => (Some(h), RecordKind::HalfEdge),
        None => (None, RecordKind::HalfEdge),
    };
    check_link(run, (record, field), link, kind, true)
}

fn half_edges<V: View + ?Sized>(run: &mut Run<'_, V>) -> Flow {
    use RecordKind::{Boundary, Face, HalfEdge, Vertex};
    let with_prev = run.expect.has(Part::Prev);
    let with_boundary = run.expect.has(Part::BoundaryComponents);
    let with_face = run.expect.has(Part::Faces) && !with_boundary;
    let closed = !run.expect.is_open();
    let links = 3 + u64::from(with_prev) + u64::from(with_boundary || with_face);
    if run.known.half_edges.is_none() {
        run.fans = column(run.vertices, Fan { degree: 0, leaving: NIL })?;
    }
    let (mut live, mut without_twin) = (0, 0);
    for i in 0..run.in_doubt() {
        let Some(h) = run.doubtful(i).map(|h| h as usize) else { continue };
        live += 1;
        let record = Record::HalfEdge(h);
        let origin = run.view.origin(h);
        check_link(run, (record, Field::Origin), origin, Vertex, true)?;
        if run.known.half_edges.is_none() {
            if let Some(fan) = origin.and_then(|v| run.fans.get_mut(v)) {
                *fan = Fan { degree: fan.degree + 1, leaving: h as u32 };
            }
        }
        let twin = run.view.twin(h);
        without_twin += usize::from(twin.is_none());
        check_link(run, (record, Field::Twin), twin, HalfEdge, closed)?;
        check_link(run, (record, Field::Next), run.view.next(h), HalfEdge, true)?;
        if with_prev {
            check_link(run, (record, Field::Prev), run.view.prev(h), HalfEdge, true)?;
        }
        // At an open boundary one of the two sides is missing, not both.
        let bounds = closed || twin.is_none();
        if with_boundary {
            check_link(run, (record, Field::Boundary), run.view.boundary(h), Boundary, bounds)?;
        } else if with_face {
            check_link(run, (record, Field::Face), run.view.face(h), Face, bounds)?;
        }
    }
    if let Some(doubts) = &run.known.half_edges {
        (live, without_twin) = (doubts.live, doubts.unpaired);
    }
    run.counts.half_edges = live;
    run.counts.edges = (live - without_twin) / 2 + without_twin;
    run.findings.checked(Rule::R1, live as u64 * links);
    Ok(())
}

fn vertices<V: View + ?Sized>(run: &mut Run<'_, V>) -> Flow {
    let with_leaving = run.expect.has(Part::Leaving);
    let with_isolated = run.expect.has(Part::BoundaryComponents) && run.expect.has(Part::Holes);
    let links = u64::from(with_leaving || with_isolated);
    if let Some(known) = run.known.vertices {
        run.counts.vertices = known.live;
        run.counts.isolated_vertices = known.isolated;
        run.findings.checked(Rule::R1, known.live as u64 * links);
        return Ok(());
    }
    run.count_fans()?;
    let mut live = 0;
    for v in 0..run.vertices as usize {
        if !run.view.is_vertex(v) {
            continue;
        }
        live += 1;
        let connected = run.fans[v].degree > 0;
        run.counts.isolated_vertices += usize::from(!connected);
        let record = Record::Vertex(v);
        if with_leaving {
            check_link(run, (record, Field::Leaving), run.view.leaving(v), RecordKind::HalfEdge, connected)?;
        }
        if with_isolated {
            // Whether a vertex without half-edges may lack it is decided by B2.
            check_link(run, (record, Field::Isolated), run.view.isolated(v), RecordKind::Boundary, false)?;
        }
    }
    run.counts.vertices = live;
    run.findings.checked(Rule::R1, live as u64 * links);
    Ok(())
}

fn boundaries<V: View + ?Sized>(run: &mut Run<'_, V>) -> Flow {
    let by_record = run.expect.has(Part::BoundaryComponents);
    let live = match run.known.lists {
        Some(lists) => {
            if by_record {
                lists.outer + lists.inner
            } else {
                0
            }
        }
        None => each_boundary(run)?,
    };
    run.findings.checked(Rule::R1, live as u64 * 2);
    // Valid lists stay far below this, and corrupt ones are read far enough to find what they list twice.
    let records = if by_record { live } else { run.counts.half_edges + run.counts.vertices };
    run.list_budget = 2 * records + 16;
    Ok(())
}

fn each_boundary<V: View + ?Sized>(run: &mut Run<'_, V>) -> Result<usize, Halt> {
    let mut live = 0;
    for b in 0..run.boundaries as usize {
        if !run.view.is_boundary(b) {
            continue;
        }
        live += 1;
        let record = Record::Boundary(b);
        check_link(run, (record, Field::Face), run.view.boundary_face(b), RecordKind::Face, true)?;
        check_start(run, (record, Field::Start), run.view.boundary_start(b))?;
    }
    Ok(live)
}

fn faces<V: View + ?Sized>(run: &mut Run<'_, V>) -> Flow {
    if let Some(lists) = run.known.lists {
        run.counts.faces = lists.faces;
        run.findings.checked(Rule::R1, (lists.faces + lists.inner) as u64);
        return Ok(());
    }
    let by_record = run.expect.has(Part::BoundaryComponents);
    let with_inner = run.expect.has(Part::Holes);
    let mut budget = run.list_budget;
    let (mut live, mut links) = (0, 0);
    for f in 0..run.faces as usize {
        if !run.view.is_face(f) {
            continue;
        }
        live += 1;
        let record = Record::Face(f);
        if by_record {
            check_link(run, (record, Field::Outer), run.view.outer(f), RecordKind::Boundary, false)?;
        } else {
            check_link(run, (record, Field::Outer), run.view.outer_half_edge(f), RecordKind::HalfEdge, false)?;
        }
        links += 1;
        let claimed = if with_inner { run.view.inner_count(f) } else { 0 };
        let listed = claimed.min(budget);
        for i in 0..listed {
            if by_record {
                check_link(run, (record, Field::Inner(i)), run.view.inner(f, i), RecordKind::Boundary, true)?;
            } else {
                check_start(run, (record, Field::Inner(i)), run.view.inner_start(f, i))?;
            }
        }
        budget -= listed;
        links += listed as u64;
        if listed < claimed && run.findings.unchecked(Rule::R1).is_none() {
            run.list_too_long(f, claimed)?;
        }
    }
    run.counts.faces = live;
    run.findings.checked(Rule::R1, links);
    Ok(())
}
