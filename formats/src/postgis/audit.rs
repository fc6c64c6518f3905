//! The audit of a topology: the validator's rules, and P0 … P4.

use super::containing::{containing, points};
use super::error::ReadError;
use super::finding::{Finding, Findings, RULES};
use super::mbr::Mbr;
use super::message::message;
use super::topology::Topology;
use crate::diagnosis::{Diagnosis, Kind, Position, Reason, Records, RuleLine, Trace, middle};
use crate::topology_audit::{TopologyAudit, TopologyCounts};
use twinedge::delegate_view;
use twinedge::geometry::Point;
use twinedge::validate::adapt::FaceLabels;
use twinedge::validate::{
    Collect, Embedding, Expectation, Part, Parts, Record, Report, Rule, RuleOutcome, Start, View,
};
use twinedge::validate::{places, validate, validate_embedding};

/// The topology with what its columns imply: the lists of the faces.
struct Listed<'a> {
    labels: FaceLabels<&'a Topology>,
    topology: &'a Topology,
}

impl View for Listed<'_> {
    delegate_view!(|this| &this.labels; except parts, inner_count, inner_start);

    /// Faces with holes, and face 0 as the unbounded one: F1 is broken where there is no row for it.
    fn parts(&self) -> Parts {
        Parts::NONE.with(Part::UnboundedFace)
    }

    fn inner_count(&self, face: usize) -> usize {
        self.labels.inner_count(face) + self.topology.contained(face).len()
    }

    fn inner_start(&self, face: usize, position: usize) -> Option<Start> {
        let holes = self.labels.inner_count(face);
        match position.checked_sub(holes) {
            None => self.labels.inner_start(face, position),
            Some(i) => self.topology.contained(face).get(i).map(|(_, node)| Start::Vertex(*node as usize)),
        }
    }
}

impl Embedding for Listed<'_> {
    fn point(&self, vertex: usize) -> Point {
        self.topology.point(vertex)
    }

    fn bends(&self, half_edge: usize) -> usize {
        self.topology.bends(half_edge)
    }

    fn bend(&self, half_edge: usize, bend: usize) -> Point {
        self.topology.bend(half_edge, bend)
    }
}

const GEOMETRIC: [Rule; 5] = [Rule::G1, Rule::G2, Rule::G3, Rule::G4, Rule::G5];

/// Judges a topology. Up to `limit` violations are kept, those of the first rules before others; all are counted.
///
/// O(n log n) for n rows and bends, and p more for p pairs of segments whose boxes meet, if edges clash.
///
/// # Errors
/// [`ReadError::OutOfMemory`].
///
/// ```
/// use twinedge_formats::postgis::{audit, read};
/// // What `psql` writes for a topology with nothing but face 0, and no `mbr`.
/// let begin = b"PGCOPY\n\xff\r\n\0\0\0\0\0\0\0\0\0";
/// let (end, face) = ([0xff; 2], [0, 2, 0, 0, 0, 4, 0, 0, 0, 0, 0xff, 0xff, 0xff, 0xff]);
/// let streams = [&begin[..], &end, begin, &face, &end, begin, &end].concat();
/// let found = audit(&read(&*streams, 100)?, 100)?;
/// assert!(found.is_valid());
/// assert_eq!(found.counts().faces, 1);
/// # Ok::<(), twinedge_formats::postgis::ReadError>(())
/// ```
pub fn audit(topology: &Topology, limit: usize) -> Result<TopologyAudit, ReadError> {
    let labels = FaceLabels::with_holes(topology, topology.universe()).ok_or(ReadError::OutOfMemory)?;
    let view = Listed { labels, topology };
    let ends_meet = topology.findings.counts[1] == 0;
    let collect = Collect::AtMost(limit);
    let report = if ends_meet {
        validate_embedding(&view, &Expectation::plane(), collect)
    } else {
        validate(&view, &Expectation::plane(), collect)
    };
    let mut findings = topology.findings.clone();
    let broken = |rule: &Rule| report.outcome(*rule).is_some_and(|outcome| outcome.violations > 0);
    let mbrs_unchecked = [Rule::R1, Rule::L3, Rule::B1].into_iter().find(broken);
    if mbrs_unchecked.is_none() {
        boxes(topology, &mut findings);
    }
    // G5 asks the same, where the links allow it.
    let is_checked = report.outcome(Rule::G5).is_some_and(|outcome| outcome.unchecked.is_none());
    let nowhere = if is_checked {
        0
    } else if ends_meet && !broken(&Rule::G4) {
        containing(topology, &mut findings)
    } else {
        topology.contained.len() as u64
    };
    let unchecked = Unchecked { mbrs: mbrs_unchecked, nowhere };
    let rules = rules(topology, &findings, &report, &unchecked);
    let own = findings.kept.iter().map(|finding| {
        let line = finding.edge().and_then(|id| line(topology, topology.edges.slot(id)?));
        placed(finding.into(), place(topology, finding), line.into_iter().collect())
    });
    let theirs = report.violations().iter().map(|violation| {
        let records = || violation.records().into_iter().flatten();
        let diagnosis = Diagnosis {
            // Its fields are slots, which nobody knows.
            kind: Kind::Named { kind: violation.kind() },
            message: message(topology, violation),
            records: Records::Names { records: records().filter_map(|record| named(topology, record)).collect() },
            ..violation.into()
        };
        let places = places(&view, violation).into_iter().map(Into::into).collect();
        placed(diagnosis, places, records().filter_map(|record| drawn(topology, record)).collect())
    });
    let counts = TopologyCounts {
        nodes: topology.nodes.len(),
        isolated_nodes: report.counts().isolated_vertices,
        edges: topology.edges.len(),
        faces: topology.faces.len(),
        components: report.counts().components,
        bends: topology.bends.len(),
        repeated_points: topology.repeated_points,
    };
    Ok(TopologyAudit::new(counts, rules, own.chain(theirs).collect(), limit))
}

/// The same with its places, and the lines of its edges, whole.
fn placed(diagnosis: Diagnosis, places: Vec<Position>, lines: Vec<Vec<Position>>) -> Diagnosis {
    let points = if lines.is_empty() { places.clone() } else { Vec::new() };
    let trace = Trace { points, lines, ..Trace::default() };
    Diagnosis { look: middle(&places), places: Some(places), trace, ..diagnosis }
}

/// The name of a record in the database.
fn named(topology: &Topology, record: Record) -> Option<String> {
    let table = match record {
        Record::Vertex(_) => "node",
        Record::HalfEdge(_) => "edge",
        Record::Face(_) => "face",
        Record::Boundary(_) => return None,
    };
    Some(format!("{table} {}", topology.name(record)))
}

/// The line of an edge.
fn drawn(topology: &Topology, record: Record) -> Option<Vec<Position>> {
    match record {
        Record::HalfEdge(h) => line(topology, u32::try_from(h / 2).ok()?),
        _ => None,
    }
}

/// The line of an edge with two points or more, if all of them are finite.
fn line(topology: &Topology, edge: u32) -> Option<Vec<Position>> {
    let edge = edge as usize;
    let line = topology.ends.get(edge).map(|_| points(topology, edge))?;
    (line.len() > 1 && line.iter().all(|p| p.x.is_finite() && p.y.is_finite()))
        .then(|| line.into_iter().map(Into::into).collect())
}

/// P4, for `mbr`.
fn boxes(topology: &Topology, findings: &mut Findings) {
    for (slot, mbr) in topology.mbrs.iter().enumerate().filter(|(slot, _)| topology.is_face(*slot)) {
        let face = topology.faces.id(slot).unwrap_or_default();
        match mbr {
            Mbr::Null if face == 0 => {}
            _ if face == 0 => findings.add(Finding::UniverseHasMbr { face }),
            Mbr::Null => findings.add(Finding::MbrMissing { face }),
            Mbr::NoBox => findings.add(Finding::MbrNotBox { face }),
            Mbr::Is(found) if *found != topology.boxes[slot] => findings.add(Finding::MbrWrong { face }),
            Mbr::Is(_) => {}
        }
    }
}

/// The questions that could not be asked.
struct Unchecked {
    /// The rule without which `mbr` cannot be judged.
    mbrs: Option<Rule>,
    /// The number of isolated nodes that may lie anywhere.
    nowhere: u64,
}

fn rules(topology: &Topology, findings: &Findings, report: &Report, not: &Unchecked) -> Vec<RuleLine> {
    let [nodes, faces, edges] = [&topology.nodes, &topology.faces, &topology.edges].map(|ids| ids.len() as u64);
    let checked = [nodes + faces + edges, nodes + edges, nodes, faces, faces + 2 * edges];
    let own = RULES.into_iter().enumerate().map(|(i, [id, name, unit, statement])| {
        let unchecked = match id {
            "P4" => not.mbrs.map(Reason::BoxesNeed),
            "P2" if not.nowhere > 0 => Some(Reason::NotLocated(not.nowhere)),
            _ => None,
        };
        RuleLine { id, name, statement, checked: checked[i], unit, violations: findings.counts[i], unchecked }
    });
    let missing = GEOMETRIC.into_iter().filter(|rule| report.outcome(*rule).is_none());
    let missing = missing
        .map(|rule| RuleLine { unchecked: Some(Reason::Broken("P1")), ..RuleLine::new(rule, RuleOutcome::default()) });
    own.chain(RuleLine::of(report)).chain(missing).collect()
}

/// The place of a finding: the node, or the ends of the edge.
fn place(topology: &Topology, finding: &Finding) -> Vec<Position> {
    let node = |id: i64| topology.nodes.slot(id).map(|slot| topology.points[slot as usize].into());
    let edge = |id: i64| {
        let ends = topology.edges.slot(id).map(|slot| topology.ends[slot as usize]);
        let points = ends.into_iter().flatten().filter_map(|node| topology.points.get(node as usize));
        points.map(|p| (*p).into()).collect()
    };
    let mut at: Vec<Position> = match *finding {
        Finding::StartsElsewhere { edge: id, .. }
        | Finding::EndsElsewhere { edge: id, .. }
        | Finding::EdgeWithoutCurve { edge: id }
        | Finding::EdgeNotCurve { edge: id, .. }
        | Finding::AbsNextDiffers { edge: id, .. } => edge(id),
        Finding::LiesElsewhere { node: id, .. }
        | Finding::ConnectedHasContainingFace { node: id, .. }
        | Finding::NoSuchContainingFace { node: id, .. } => node(id).into_iter().collect(),
        _ => Vec::new(),
    };
    at.retain(|[x, y]| !x.is_nan() && !y.is_nan());
    at
}
