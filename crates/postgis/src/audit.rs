//! The audit of a topology: the validator's rules, and P0 … P4.

use super::advice::advice;
use super::containing::containing;
use super::error::ReadError;
use super::finding::{Finding, Findings, RULES};
use super::lines::{Drawing, Lines};
use super::listed::Listed;
use super::mbr::Mbr;
use super::mend::Mender;
use super::message::{message, unit};
use super::topology::Topology;
use std::collections::BTreeSet;
use twinedge::validate::{Collect, Expectation, Record, Report, Rule, RuleOutcome, View, Violation, validate};
use twinedge_diagnosis::{Diagnosis, Kind, Position, Reason, Records, RuleLine, Trace, middle};
use twinedge_diagnosis::{TopologyAudit, TopologyCounts};
use twinedge_map::{Embedding, places, validate_embedding};

const GEOMETRIC: [Rule; 5] = [Rule::G1, Rule::G2, Rule::G3, Rule::G4, Rule::G5];

/// Judges a topology. Up to `limit` violations are kept, in the order of the rules; all are counted.
///
/// O(n log n) for n rows and bends, plus O(p) for p pairs of segments with overlapping boxes, if edges clash.
///
/// # Errors
/// [`ReadError::OutOfMemory`].
///
/// ```
/// use twinedge_postgis::{audit, read};
/// // What `psql` writes for a topology with nothing but face 0, and no `mbr`.
/// let begin = b"PGCOPY\n\xff\r\n\0\0\0\0\0\0\0\0\0";
/// let (end, face) = ([0xff; 2], [0, 2, 0, 0, 0, 4, 0, 0, 0, 0, 0xff, 0xff, 0xff, 0xff]);
/// let streams = [&begin[..], &end, begin, &face, &end, begin, &end].concat();
/// let found = audit(&read(&*streams, 100)?, 100)?;
/// assert!(found.is_valid());
/// assert_eq!(found.counts().faces, 1);
/// # Ok::<(), twinedge_postgis::ReadError>(())
/// ```
pub fn audit(topology: &Topology, limit: usize) -> Result<TopologyAudit, ReadError> {
    let view = Listed::of(topology)?;
    let collect = Collect::AtMost(limit);
    let report = if topology.findings.counts[1] == 0 {
        validate_embedding(&view, &Expectation::plane(), collect)
    } else {
        validate(&view, &Expectation::plane(), collect)
    };
    let mut findings = topology.findings.clone();
    let name = |record| topology.name(record);
    let mut theirs: Vec<(Fault, Diagnosis)> =
        report.violations().iter().map(|one| (Fault::Of(*one), diagnosis(topology, &view, name, one))).collect();
    let mut left_out = LeftOut::default();
    let mut drawing = None;
    // G5 covers the places of isolated nodes, and tests that the lines around each face close, where the links allow it.
    if is_checked(&report, Rule::G5) {
        boxes(topology, &BTreeSet::new(), &mut findings);
    } else {
        let mut lines = Lines::of(topology);
        left_out.boxes = boxes(topology, &lines.open_faces(), &mut findings);
        let mut disjoint = holds(&report, Rule::G4);
        if !is_checked(&report, Rule::G4) {
            let mut judged = lines.judge(collect);
            judged.violations.retain(|one| !is_checked(&report, one.rule()));
            let of_lines = |one: &Violation| (Fault::Of(*one), diagnosis(topology, &lines, |r| lines.name(r), one));
            theirs.extend(judged.violations.iter().map(of_lines));
            disjoint = judged.disjoint.outcome.violations == 0;
            drawing = Some(judged);
        }
        left_out.nodes = if disjoint {
            containing(topology, &lines.open_faces(), &mut findings)
        } else {
            topology.contained.len() as u64
        };
    }
    let rules = rules(topology, &findings, &report, drawing.as_ref(), &left_out);
    let found = findings.kept.iter().map(|finding| (Fault::Own(*finding), own(topology, finding)));
    let found: Vec<_> = found.chain(theirs).collect();
    let violations = if found.is_empty() { Vec::new() } else { with_sql(topology, &rules, found) };
    let counts = TopologyCounts {
        nodes: topology.nodes.len(),
        isolated_nodes: report.counts().isolated_vertices,
        edges: topology.edges.len(),
        faces: topology.faces.len(),
        components: report.counts().components,
        bends: topology.bends.len(),
        repeated_points: topology.repeated_points,
    };
    Ok(TopologyAudit::new(counts, rules, violations, limit))
}

/// Returns true if the rule was checked on all records.
fn is_checked(report: &Report, rule: Rule) -> bool {
    report.outcome(rule).is_some_and(|outcome| outcome.unchecked.is_none())
}

/// Returns true if no violation of the rule was found.
fn holds(report: &Report, rule: Rule) -> bool {
    report.outcome(rule).is_none_or(|outcome| outcome.violations == 0)
}

/// A finding of this format, or a violation of the validator.
enum Fault {
    Own(Finding),
    Of(Violation),
}

fn own(topology: &Topology, finding: &Finding) -> Diagnosis {
    let line = finding.edge().and_then(|id| line(topology, topology.edges.slot(id)?));
    placed(finding.into(), place(topology, finding), line.into_iter().collect())
}

fn with_sql(topology: &Topology, rules: &[RuleLine], found: Vec<(Fault, Diagnosis)>) -> Vec<Diagnosis> {
    let lines = Lines::of(topology);
    let mender = Mender::of(topology, &lines, rules);
    let sql = |fault: &Fault, diagnosis: &Diagnosis| match fault {
        Fault::Own(finding) => mender.of_finding(finding),
        Fault::Of(violation) => mender.of_violation(violation, &diagnosis.records.names()),
    };
    found.into_iter().map(|(fault, one)| Diagnosis { sql: Some(sql(&fault, &one)), ..one }).collect()
}

/// Returns a violation with the names of the database, its places, and the lines of its edges.
fn diagnosis<E: Embedding>(
    topology: &Topology,
    view: &E,
    name: impl Fn(Record) -> String,
    violation: &Violation,
) -> Diagnosis {
    let records = || violation.records().into_iter().flatten();
    let [cause, remedy] = advice(violation.rule()).map(Some);
    let diagnosis = Diagnosis {
        cause,
        remedy,
        // The fields are slots, which are unknown to the user.
        kind: Kind::Named { kind: violation.kind() },
        message: message(topology, name, violation),
        records: Records::Names { records: records().filter_map(|record| named(topology, record)).collect() },
        ..violation.into()
    };
    let places = places(view, violation).into_iter().map(Into::into).collect();
    placed(diagnosis, places, records().filter_map(|record| drawn(topology, record)).collect())
}

/// Returns the same diagnosis with its places, and the lines of its edges in full.
fn placed(diagnosis: Diagnosis, places: Vec<Position>, lines: Vec<Vec<Position>>) -> Diagnosis {
    let points = if lines.is_empty() { places.clone() } else { Vec::new() };
    let trace = Trace { points, lines, ..Trace::default() };
    Diagnosis { look: middle(&places), places: Some(places), trace, ..diagnosis }
}

fn named(topology: &Topology, record: Record) -> Option<String> {
    let table = match record {
        Record::Vertex(vertex) if vertex < topology.nodes.len() => "node",
        Record::HalfEdge(_) => "edge",
        Record::Face(_) => "face",
        // A boundary component, or the end of a line without node.
        _ => return None,
    };
    Some(format!("{table} {}", topology.name(record)))
}

fn drawn(topology: &Topology, record: Record) -> Option<Vec<Position>> {
    match record {
        Record::HalfEdge(h) => line(topology, u32::try_from(h / 2).ok()?),
        _ => None,
    }
}

/// Returns the line of an edge with two points or more, if all of them are finite.
fn line(topology: &Topology, edge: u32) -> Option<Vec<Position>> {
    let line = topology.line_points(edge as usize);
    (line.len() > 1 && line.iter().all(|p| p.x.is_finite() && p.y.is_finite()))
        .then(|| line.into_iter().map(Into::into).collect())
}

/// Checks P4 for `mbr`. Returns the number of boxes that cannot be judged, because the lines around their faces do not close.
fn boxes(topology: &Topology, open: &BTreeSet<u32>, findings: &mut Findings) -> u64 {
    let mut left_out = 0;
    for (slot, mbr) in topology.mbrs.iter().enumerate().filter(|(slot, _)| topology.is_face(*slot)) {
        let face = topology.faces.id(slot).unwrap_or_default();
        match mbr {
            Mbr::Null if face == 0 => {}
            _ if face == 0 => findings.add(Finding::UniverseHasMbr { face }),
            Mbr::Null => findings.add(Finding::MbrMissing { face }),
            Mbr::NoBox => findings.add(Finding::MbrNotBox { face }),
            Mbr::Is(_) if open.contains(&(slot as u32)) => left_out += 1,
            Mbr::Is(found) if *found != topology.boxes[slot] => findings.add(Finding::MbrWrong { face }),
            Mbr::Is(_) => {}
        }
    }
    left_out
}

/// The records for which P2 and P4 are not known, because the lines around their faces do not close.
#[derive(Default)]
struct LeftOut {
    boxes: u64,
    nodes: u64,
}

fn rules(
    topology: &Topology,
    findings: &Findings,
    report: &Report,
    drawing: Option<&Drawing>,
    left_out: &LeftOut,
) -> Vec<RuleLine> {
    let [nodes, faces, edges] = [&topology.nodes, &topology.faces, &topology.edges].map(|ids| ids.len() as u64);
    let checked = [nodes + faces + edges, nodes + edges, nodes, faces, faces + 2 * edges];
    let own = RULES.into_iter().enumerate().map(|(i, [id, name, unit, statement])| {
        let (out, why) = match id {
            "P2" => (left_out.nodes, Reason::NotLocated),
            "P4" => (left_out.boxes, Reason::NotClosed),
            _ => (0, Reason::NotClosed),
        };
        let left_out = Some(out).filter(|out| *out > 0);
        let unchecked = left_out.map(|_| why);
        RuleLine {
            id,
            name,
            statement,
            checked: checked[i] - out,
            unit,
            violations: findings.counts[i],
            unchecked,
            left_out,
        }
    });
    own.chain(report.outcomes().map(|(rule, outcome)| of_validator(report, rule, outcome)))
        .chain(GEOMETRIC.into_iter().filter(|rule| report.outcome(*rule).is_none()).map(|rule| RuleLine {
            unchecked: Some(Reason::Broken("P1")),
            ..RuleLine::new(rule, RuleOutcome::default())
        }))
        .map(|line| drawing.and_then(|drawing| of_lines(drawing, &line)).unwrap_or(line))
        .map(|line| RuleLine { unit: unit(line.unit), ..line })
        .collect()
}

/// Returns a rule of the validator, with the number of records that were left out.
fn of_validator(report: &Report, rule: Rule, outcome: RuleOutcome) -> RuleLine {
    let counts = report.counts();
    let all = match rule {
        Rule::L1 | Rule::L2 | Rule::L3 | Rule::B1 => Some(counts.half_edges),
        Rule::V1 | Rule::V2 | Rule::B2 | Rule::G2 => Some(counts.vertices),
        Rule::F1 | Rule::F2 => Some(counts.faces),
        _ => None,
    };
    let line = RuleLine::new(rule, outcome);
    let left_out = all.filter(|_| line.is_open()).map(|all| (all as u64).saturating_sub(outcome.checked));
    if left_out == Some(0) && matches!(rule, Rule::L1 | Rule::L2 | Rule::L3) {
        // The dangling links concern other records.
        return RuleLine { unchecked: None, ..line };
    }
    RuleLine { left_out, ..line }
}

/// Returns the line of G1 or G4 for the lines alone, if the rule was not checked otherwise.
fn of_lines(drawing: &Drawing, line: &RuleLine) -> Option<RuleLine> {
    line.unchecked?;
    let (rule, judged, needs) = match line.id {
        "G1" => (Rule::G1, &drawing.finite, "P1"),
        "G4" if drawing.finite.outcome.violations > 0 => (Rule::G4, &drawing.disjoint, "G1"),
        "G4" => (Rule::G4, &drawing.disjoint, "P1"),
        _ => return None,
    };
    let line = RuleLine::new(rule, judged.outcome);
    let left_out = Some(judged.left_out).filter(|out| *out > 0);
    Some(RuleLine { unchecked: line.unchecked.or(left_out.map(|_| Reason::Broken(needs))), left_out, ..line })
}

/// Returns the place of a finding: the node, or the ends of the edge.
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
