//! M1 … M8: claims about meshes, each checked on request.

use super::live::Census;
use super::whole::borders_broken;
use crate::numbers::NIL;
use crate::validate::findings::{Findings, Flow};
use crate::validate::report::{Field, Record, Unchecked, Violation};
use crate::validate::rule::Rule;
use crate::validate::structure::Part;
use crate::validate::subject::{Subject, column};

/// Runs the requested rules of M1 … M8. `is_simple` is true if there are neither loops nor parallel edges.
pub(crate) fn mesh(subject: Subject<'_>, census: &Census, is_simple: bool, findings: &mut Findings) -> Flow {
    used(subject, census, findings)?;
    simple(subject, census, is_simple, findings)?;
    sides(subject, census, findings)?;
    closed(subject, census, findings)?;
    connected(subject, census, findings)?;
    borders(subject, census, findings)?;
    genus(subject, census, findings)?;
    kept(subject, census, findings)
}

/// Returns true if an optional rule is skipped: it was not requested, or a rule that it needs is broken, which is recorded as the
/// reason.
fn passes_over(subject: Subject<'_>, rule: Rule, broken: Option<Rule>, findings: &mut Findings) -> bool {
    if !subject.extent.expect.asks_for(rule) {
        return true;
    }
    if let Some(broken) = broken {
        findings.not_checked(rule, Unchecked::Broken(broken));
    }
    broken.is_some()
}

/// M1 used: some half-edge leaves every vertex.
///
/// Needs live origins.
fn used(subject: Subject<'_>, census: &Census, findings: &mut Findings) -> Flow {
    if passes_over(subject, Rule::M1, census.links_broken(), findings) {
        return Ok(());
    }
    findings.checked(Rule::M1, census.vertices as u64);
    if census.isolated_vertices == 0 {
        return Ok(());
    }
    let mut used = column(subject.extent.vertices.count, false)?;
    for h in subject.half_edges() {
        if let Some(used) = used.get_mut(subject.origin(h) as usize) {
            *used = true;
        }
    }
    subject.vertices().filter(|v| !used[*v]).try_for_each(|vertex| findings.add(Violation::UnusedVertex { vertex }))
}

/// M2 simple: no edge is a loop, and no two edges join the same vertices.
///
/// The edges are sorted by their smaller end, so edges with the same ends are found in linear time. Of parallel edges, each but
/// the first is reported, together with the first.
fn simple(subject: Subject<'_>, census: &Census, is_simple: bool, findings: &mut Findings) -> Flow {
    if passes_over(subject, Rule::M2, census.map_broken(findings), findings) {
        return Ok(());
    }
    findings.checked(Rule::M2, census.edges as u64);
    if is_simple {
        return Ok(());
    }
    let (vertices, half_edges) = (subject.extent.vertices.count, subject.extent.half_edges.count);
    // By vertex: the first edge with this smaller end; by half-edge that represents its edge: the next such edge.
    let mut first = column(vertices, NIL)?;
    let mut next = column(half_edges, NIL)?;
    for h in (0..half_edges).rev().filter(|h| subject.is_live_half_edge(*h)) {
        let twin = subject.twin(h);
        let [smaller, _] = subject.ends(h);
        if twin == NIL || h < twin {
            if let Some(first) = first.get_mut(smaller as usize) {
                next[h as usize] = core::mem::replace(first, h);
            }
        }
    }
    // By vertex: the last edge seen to lead there.
    let mut seen = column(vertices, NIL)?;
    for v in 0..vertices {
        let mut h = first[v as usize];
        while h != NIL {
            let (half_edge, [smaller, larger]) = (h as usize, subject.ends(h));
            h = next[half_edge];
            if smaller == larger {
                findings.add(Violation::LoopEdge { half_edge, vertex: v as usize })?;
                continue;
            }
            let Some(last) = seen.get_mut(larger as usize) else { continue };
            if *last != NIL && subject.ends(*last) == [v, larger] {
                let (first, vertices) = (*last as usize, [v as usize, larger as usize]);
                findings.add(Violation::ParallelEdges { first, second: half_edge, vertices })?;
            } else {
                *last = half_edge as u32;
            }
        }
    }
    Ok(())
}

/// M3 sides: every bounded face has the expected number of sides.
///
/// Needs closed cycles, each with one face. The sides of a face are all half-edges that bound it; without faces, the half-edges of
/// a cycle.
fn sides(subject: Subject<'_>, census: &Census, findings: &mut Findings) -> Flow {
    let has_faces = subject.has(Part::Faces);
    let below: &[Rule] = if has_faces { &[Rule::R1, Rule::L2, Rule::B1, Rule::F1] } else { &[Rule::L2] };
    let broken = census.links_broken().or_else(|| findings.broken(below));
    if passes_over(subject, Rule::M3, broken, findings) {
        return Ok(());
    }
    if has_faces { faces(subject, findings) } else { cycles(subject, findings) }
}

fn one(subject: Subject<'_>, record: Record, sides: u32, findings: &mut Findings) -> Flow {
    findings.checked(Rule::M3, 1);
    let sides = sides as usize;
    match subject.extent.expect.expected_count(Rule::M3) {
        Some(expected) if sides != expected => findings.add(Violation::WrongSides { record, sides, expected }),
        _ => Ok(()),
    }
}

fn faces(subject: Subject<'_>, findings: &mut Findings) -> Flow {
    let by_record = subject.has(Part::BoundaryComponents);
    let mut sides = column(subject.extent.faces.count, 0)?;
    for h in subject.half_edges() {
        let name = subject.extent.name(subject.view, h as usize);
        let face = if by_record {
            subject.extent.boundaries.existing(name).and_then(|b| subject.view.boundary_face(b))
        } else {
            name
        };
        if let Some(sides) = face.and_then(|f| sides.get_mut(f)) {
            *sides += 1;
        }
    }
    for f in subject.faces().filter(|f| subject.outer(*f).is_some()) {
        one(subject, Record::Face(f), sides[f], findings)?;
    }
    Ok(())
}

fn cycles(subject: Subject<'_>, findings: &mut Findings) -> Flow {
    let mut seen = column(subject.extent.half_edges.count, false)?;
    for start in subject.half_edges() {
        let (mut h, mut sides) = (start, 0);
        while h != NIL && !core::mem::replace(&mut seen[h as usize], true) {
            sides += 1;
            h = subject.next(h);
        }
        if sides > 0 {
            one(subject, Record::HalfEdge(start as usize), sides, findings)?;
        }
    }
    Ok(())
}

/// M4 closed: every half-edge has a twin and bounds a face.
///
/// Needs live links.
fn closed(subject: Subject<'_>, census: &Census, findings: &mut Findings) -> Flow {
    if passes_over(subject, Rule::M4, census.links_broken(), findings) {
        return Ok(());
    }
    findings.checked(Rule::M4, census.half_edges as u64);
    // R1 has shown that no link is missing.
    if !subject.is_open() {
        return Ok(());
    }
    let face = if subject.has(Part::BoundaryComponents) { Field::Boundary } else { Field::Face };
    for h in subject.half_edges() {
        let half_edge = h as usize;
        let lacks = if subject.view.twin(half_edge).is_none() {
            Field::Twin
        } else if subject.lacks_face(half_edge) {
            face
        } else {
            continue;
        };
        let vertices = [subject.origin(h), subject.target(h)].map(|v| v as usize);
        findings.add(Violation::OnBorder { half_edge, vertices, lacks })?;
    }
    Ok(())
}

/// M5 connected: there are as many components with an edge as expected.
///
/// Isolated vertices do not count.
fn connected(subject: Subject<'_>, census: &Census, findings: &mut Findings) -> Flow {
    let broken = census.rotations_broken(findings);
    if passes_over(subject, Rule::M5, broken, findings) {
        return Ok(());
    }
    // An isolated vertex is a component without edges.
    let found = findings.counts.components.map(|all| all.saturating_sub(census.isolated_vertices));
    findings.checked(Rule::M5, found.unwrap_or(0) as u64);
    match (found, subject.extent.expect.expected_count(Rule::M5)) {
        (Some(found), Some(expected)) if found != expected => {
            findings.add(Violation::WrongComponents { found, expected })
        }
        _ => Ok(()),
    }
}

/// M6 borders: there are as many border loops as expected.
///
/// Compares the number of border loops, which is known unless a rule that its counting relies on is broken.
fn borders(subject: Subject<'_>, census: &Census, findings: &mut Findings) -> Flow {
    let broken = census.rotations_broken(findings).or_else(|| borders_broken(subject, findings));
    if passes_over(subject, Rule::M6, broken, findings) {
        return Ok(());
    }
    let found = findings.counts.borders;
    findings.checked(Rule::M6, findings.counts.components.unwrap_or(0) as u64);
    match (found, subject.extent.expect.expected_count(Rule::M6)) {
        (Some(found), Some(expected)) if found != expected => findings.add(Violation::WrongBorders { found, expected }),
        _ => Ok(()),
    }
}

/// M7 genus: the genera of the components add up to the genus expected.
///
/// Compares the sum computed by T3.
fn genus(subject: Subject<'_>, census: &Census, findings: &mut Findings) -> Flow {
    let broken = census.rotations_broken(findings).or_else(|| findings.broken(&[Rule::T3]));
    if passes_over(subject, Rule::M7, broken, findings) {
        return Ok(());
    }
    let found = findings.counts.genus;
    findings.checked(Rule::M7, findings.counts.components.unwrap_or(0) as u64);
    match (found, subject.extent.expect.expected_count(Rule::M7)) {
        (Some(found), Some(expected)) if found != expected => findings.add(Violation::WrongGenus { found, expected }),
        _ => Ok(()),
    }
}

/// M8 kept: if a half-edge without twin or face leaves a vertex, the half-edge kept by that vertex lacks a twin or a face.
///
/// Needs live links and V1.
fn kept(subject: Subject<'_>, census: &Census, findings: &mut Findings) -> Flow {
    let broken = census.links_broken().or_else(|| findings.broken(&[Rule::V1]));
    if passes_over(subject, Rule::M8, broken, findings) {
        return Ok(());
    }
    if !subject.has(Part::Leaving) {
        findings.not_checked(Rule::M8, Unchecked::Lacks(Part::Leaving));
        return Ok(());
    }
    findings.checked(Rule::M8, census.vertices as u64);
    // R1 has shown that no link is missing.
    if !subject.is_open() {
        return Ok(());
    }
    let is_on_border = |h: usize| subject.view.twin(h).is_none() || subject.lacks_face(h);
    // By vertex: the first half-edge of the border that leaves it.
    let mut border = column(subject.extent.vertices.count, NIL)?;
    for h in subject.half_edges().filter(|h| is_on_border(*h as usize)) {
        if let Some(border) = border.get_mut(subject.origin(h) as usize) {
            *border = h.min(*border);
        }
    }
    for vertex in subject.vertices().filter(|v| border[*v] != NIL) {
        let Some(half_edge) = subject.extent.half_edges.existing(subject.view.leaving(vertex)) else { continue };
        if !is_on_border(half_edge) {
            findings.add(Violation::KeptInside { vertex, half_edge, border: border[vertex] as usize })?;
        }
    }
    Ok(())
}
