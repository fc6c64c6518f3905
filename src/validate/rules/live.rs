//! R1, and the census of records taken while checking it.
//!
//! At an open boundary the twin or the face of a half-edge may be nil, but not both: such a half-edge bounds nothing, and
//! no other record is on its other side.
//!
//! A structure may claim lists of any length. Each boundary component is listed once, so reading stops after twice the
//! number of boundary components plus 16 entries. A list that continues breaks R1, because its links cannot be shown to be
//! live. Without records for boundary components, vertices and half-edges are counted instead.

use crate::numbers::NIL;
use crate::validate::findings::{Findings, Flow, Halt};
use crate::validate::half_edges::HalfEdges;
use crate::validate::report::{Field, Record, Unchecked, Violation};
use crate::validate::rule::Rule;
use crate::validate::structure::{Link, Part, Start};
use crate::validate::subject::{Subject, column};
use alloc::vec::Vec;

pub(crate) struct Census {
    pub(crate) half_edges: usize,
    pub(crate) edges: usize,
    pub(crate) vertices: usize,
    pub(crate) isolated_vertices: usize,
    /// True if the links between half-edges and vertices (the combinatorial map) are live.
    pub(crate) map_is_live: bool,
    /// The maximum number of list entries that each rule reads. Longer lists are invalid.
    pub(crate) list_budget: usize,
    pub(crate) fans: Vec<Fan>,
}

impl Census {
    /// Returns the first broken rule of those required for a combinatorial map.
    pub(crate) fn map_broken(&self, findings: &Findings) -> Option<Rule> {
        self.links_broken().or_else(|| findings.broken(&[Rule::L1, Rule::L2, Rule::L3]))
    }

    /// Returns R1, if a link between half-edges and vertices breaks it.
    pub(crate) fn links_broken(&self) -> Option<Rule> {
        if self.map_is_live { None } else { Some(Rule::R1) }
    }

    /// Returns the first broken rule of those required for whole rotations, which determine components.
    pub(crate) fn rotations_broken(&self, findings: &Findings) -> Option<Rule> {
        self.map_broken(findings).or_else(|| findings.broken(&[Rule::V2]))
    }
}

/// The half-edges that leave one vertex: their number, and one of them.
#[derive(Clone, Copy)]
pub(crate) struct Fan {
    pub(crate) degree: u32,
    pub(crate) leaving: u32,
}

fn note(fans: &mut [Fan], origin: u32, h: u32) {
    if let Some(fan) = fans.get_mut(origin as usize) {
        *fan = Fan { degree: fan.degree + 1, leaving: h };
    }
}

#[derive(Clone, Copy)]
enum Target {
    Vertex,
    HalfEdge,
    Boundary,
    Face,
}

/// R1 live: every link that a record needs is there and leads to a live record, and no face lists far more boundary components than there are.
///
/// Counts the records on the way.
pub(crate) fn live(subject: Subject<'_>, half_edges: impl HalfEdges, findings: &mut Findings) -> Result<Census, Halt> {
    let mut fans = column(subject.extent.vertices.count, Fan { degree: 0, leaving: NIL })?;
    let [half_edges, edges] = links_of_half_edges(subject, half_edges, &mut fans, findings)?;
    let map_is_live = findings.holds(Rule::R1);
    let [vertices, isolated_vertices] = vertices(subject, &fans, findings)?;
    let boundaries = boundaries(subject, findings)?;
    // Valid lists stay far below this, and corrupt lists are read far enough to find repeated entries.
    let records = if subject.has(Part::BoundaryComponents) { boundaries } else { half_edges + vertices };
    let list_budget = 2 * records + 16;
    faces(subject, list_budget, findings)?;
    Ok(Census { half_edges, edges, vertices, isolated_vertices, map_is_live, list_budget, fans })
}

#[inline]
fn leads(subject: Subject<'_>, link: usize, kind: Target) -> bool {
    match kind {
        Target::Vertex => subject.is_vertex(link),
        Target::HalfEdge => subject.is_half_edge(link),
        Target::Boundary => subject.is_boundary(link),
        Target::Face => subject.is_face(link),
    }
}

struct Links<'a, 'f> {
    subject: Subject<'a>,
    record: Record,
    findings: &'f mut Findings,
}

impl Links<'_, '_> {
    /// Checks one link; nil is a violation only if the record needs the link.
    fn check(&mut self, field: Field, link: Link, kind: Target, is_needed: bool) -> Flow {
        let record = self.record;
        match link {
            Some(value) if leads(self.subject, value, kind) => Ok(()),
            Some(value) => self.findings.add(Violation::Dangling { record, field, value }),
            None if is_needed => self.findings.add(Violation::Nil { record, field }),
            None => Ok(()),
        }
    }

    fn check_start(&mut self, field: Field, start: Option<Start>) -> Flow {
        let (link, kind) = match start {
            Some(Start::Vertex(v)) => (Some(v), Target::Vertex),
            Some(Start::HalfEdge(h)) => (Some(h), Target::HalfEdge),
            None => (None, Target::HalfEdge),
        };
        self.check(field, link, kind, true)
    }
}

fn links_of_half_edges(
    subject: Subject<'_>,
    half_edges: impl HalfEdges,
    fans: &mut [Fan],
    findings: &mut Findings,
) -> Result<[usize; 2], Halt> {
    let Subject { view, extent } = subject;
    let (has_prev, has_names) = (extent.has(Part::Prev), extent.has(Part::Faces));
    let by_record = extent.has(Part::BoundaryComponents);
    let (vertices, names) = (extent.vertices, if by_record { extent.boundaries } else { extent.faces });
    let are_live = |h: u32, origin: u32, twin: u32| {
        vertices.is_live(origin as usize, |v| view.is_vertex(v))
            && half_edges.is_live(twin)
            && half_edges.is_live(half_edges.next(h))
            && (!has_prev || half_edges.is_live(half_edges.prev(h)))
            && (!has_names || {
                let is_live = |name| if by_record { view.is_boundary(name) } else { view.is_face(name) };
                names.is_live(half_edges.name(h) as usize, is_live)
            })
    };
    let (mut live, mut unpaired) = (0, 0);
    for h in subject.half_edges() {
        let (origin, twin) = (half_edges.origin(h), half_edges.twin(h));
        if !are_live(h, origin, twin) {
            half_edge(subject, h as usize, findings)?;
        }
        live += 1;
        unpaired += usize::from(twin == NIL);
        note(fans, origin, h);
    }
    let edges = (live - unpaired) / 2 + unpaired;
    (findings.counts.half_edges, findings.counts.edges) = (live, edges);
    let links = 3 + u64::from(extent.has(Part::Prev)) + u64::from(extent.has(Part::Faces));
    findings.checked(Rule::R1, live as u64 * links);
    Ok([live, edges])
}

/// Checks the links of one half-edge, reading them again to report each.
#[cold]
fn half_edge(subject: Subject<'_>, h: usize, findings: &mut Findings) -> Flow {
    let Subject { view, extent } = subject;
    let mut links = Links { subject, record: Record::HalfEdge(h), findings };
    let is_closed = !subject.is_open();
    links.check(Field::Origin, view.origin(h), Target::Vertex, true)?;
    let twin = view.twin(h);
    links.check(Field::Twin, twin, Target::HalfEdge, is_closed)?;
    links.check(Field::Next, view.next(h), Target::HalfEdge, true)?;
    if extent.has(Part::Prev) {
        links.check(Field::Prev, view.prev(h), Target::HalfEdge, true)?;
    }
    if !extent.has(Part::Faces) {
        return Ok(());
    }
    let (field, kind) = if extent.has(Part::BoundaryComponents) {
        (Field::Boundary, Target::Boundary)
    } else {
        (Field::Face, Target::Face)
    };
    // At an open boundary only one of the two sides may be missing.
    let is_needed = is_closed || twin.is_none();
    links.check(field, extent.name(view, h), kind, is_needed)
}

fn vertices(subject: Subject<'_>, fans: &[Fan], findings: &mut Findings) -> Result<[usize; 2], Halt> {
    let names_boundary = subject.has(Part::BoundaryComponents) && subject.has(Part::Holes);
    let (mut live, mut isolated) = (0, 0);
    for v in subject.vertices() {
        live += 1;
        let is_connected = fans[v].degree > 0;
        isolated += usize::from(!is_connected);
        let mut links = Links { subject, record: Record::Vertex(v), findings: &mut *findings };
        if subject.has(Part::Leaving) {
            links.check(Field::Leaving, subject.view.leaving(v), Target::HalfEdge, is_connected)?;
        }
        if names_boundary {
            // B2 decides whether a vertex without half-edges may lack it.
            links.check(Field::Isolated, subject.view.isolated(v), Target::Boundary, false)?;
        }
    }
    (findings.counts.vertices, findings.counts.isolated_vertices) = (live, isolated);
    let links = u64::from(subject.has(Part::Leaving) || names_boundary);
    findings.checked(Rule::R1, live as u64 * links);
    Ok([live, isolated])
}

fn boundaries(subject: Subject<'_>, findings: &mut Findings) -> Result<usize, Halt> {
    let mut live = 0;
    for b in subject.boundaries() {
        live += 1;
        let mut links = Links { subject, record: Record::Boundary(b), findings: &mut *findings };
        links.check(Field::Face, subject.view.boundary_face(b), Target::Face, true)?;
        links.check_start(Field::Start, subject.view.boundary_start(b))?;
    }
    findings.checked(Rule::R1, live as u64 * 2);
    Ok(live)
}

fn faces(subject: Subject<'_>, mut budget: usize, findings: &mut Findings) -> Flow {
    let by_record = subject.has(Part::BoundaryComponents);
    let outer_kind = if by_record { Target::Boundary } else { Target::HalfEdge };
    let (mut live, mut entries) = (0, 0);
    for f in subject.faces() {
        live += 1;
        let claimed = if subject.has(Part::Holes) { subject.view.inner_count(f) } else { 0 };
        let listed = claimed.min(budget);
        let mut links = Links { subject, record: Record::Face(f), findings: &mut *findings };
        links.check(Field::Outer, subject.outer(f), outer_kind, false)?;
        for i in 0..listed {
            if by_record {
                links.check(Field::Inner(i), subject.view.inner(f, i), Target::Boundary, true)?;
            } else {
                links.check_start(Field::Inner(i), subject.view.inner_start(f, i))?;
            }
        }
        budget -= listed;
        entries += 1 + listed as u64;
        if listed < claimed && findings.unchecked(Rule::R1).is_none() {
            list_too_long(f, claimed, findings)?;
        }
    }
    findings.counts.faces = live;
    findings.checked(Rule::R1, entries);
    Ok(())
}

/// Reports a list that is not read to its end: unread links cannot be shown to be live.
pub(crate) fn list_too_long(face: usize, claimed: usize, findings: &mut Findings) -> Flow {
    findings.not_checked(Rule::R1, Unchecked::ListTooLong);
    findings.add(Violation::ListTooLong { face, claimed })
}
