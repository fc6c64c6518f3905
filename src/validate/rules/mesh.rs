//! M1 … M8: claims about meshes, each checked if asked for.

use super::live::Census;
use super::whole::borders_broken;
use crate::validate::columns::{NIL, column};
use crate::validate::findings::{Findings, Flow};
use crate::validate::report::{Field, Record, Unchecked, Violation};
use crate::validate::rule::Rule;
use crate::validate::structure::Part;
use crate::validate::subject::Subject;

macro_rules! mesh_rules {
    ($define:ident $($before:tt)*) => {
        $crate::validate::rules::drawing::drawing_rules! {
            $define
            $($before)*
            /// Checked where the expectation asks for it by `no_unused_vertices`.
            ///
            /// ```text
            /// ·──────·
            /// │    ╱ │    ·v    no half-edge leaves v
            /// │  ╱   │
            /// ·──────·
            /// ```
            M1 "used" counts "vertex" "vertices"
                "some half-edge leaves every vertex"
                in "mesh" broken by "mesh_rules" "m1_a_vertex_is_unused"
            {
                UnusedVertex { vertex: vertex } "unused_vertex"
                    says "no half-edge leaves vertex {vertex}: no edge and no face uses it"
                    cause "faces were deleted and their vertices kept, or the vertex belongs to a line or a point of the input"
                    remedy "delete the vertex, or do not ask for `no_unused_vertices`";
            }
            /// Checked where the expectation asks for it by `simple`. A face with two sides has parallel edges.
            ///
            /// ```text
            ///            e
            /// ┌───┐    ┌───┐
            /// │   v    u   v    the loop starts and ends at v; e and f both join u and v
            /// └───┘    └───┘
            ///            f
            /// ```
            M2 "simple" counts "edge" "edges"
                "no edge is a loop, and no two edges join the same vertices"
                in "mesh" broken by "mesh_rules" "m2_an_edge_is_a_loop_or_parallel_to_another"
            {
                LoopEdge { half_edge: half_edge, vertex: vertex } "loop_edge"
                    says "half-edge {half_edge} starts and ends at vertex {vertex}: its edge is a loop"
                    cause "an edge was contracted while another joined its ends, or a face lists a vertex twice in a row"
                    remedy "delete the edge, or subdivide it; refuse to contract an edge whose ends have a neighbour in common that is not opposite to it";
                ParallelEdges { first: half_edge, second: half_edge, vertices: ends } "parallel_edges"
                    says "half-edges {first} and {second} belong to two edges that both join vertices {vertices}: the ends do not tell which edge is meant"
                    cause "two faces at an edge were not joined as twins, an edge was flipped onto one that was there, or a face has two sides"
                    remedy "join the half-edges as twins, or subdivide one of the edges; look for an edge between the vertices before one is made";
            }
            /// Checked where the expectation asks for it by `sides` or `triangles`. The sides of a face are all half-edges that bound
            /// it, those of its holes too. The unbounded face may have any number. Without faces, each cycle of `next` is a face.
            ///
            /// ```text
            /// ·──────·
            /// │    ╱  ╲    a triangle and a quadrilateral
            /// │  ╱     ╲
            /// ·────·────·
            /// ```
            M3 "sides" counts "face" "faces"
                "every bounded face has the expected number of sides"
                in "mesh" broken by "mesh_rules" "m3_a_face_has_a_side_too_many"
            {
                WrongSides { record: sided, sides: number, expected: number } "wrong_sides"
                    says "{record} has {found}, where {expected} are expected"
                    with |names| { found = Number(sides as u64, "side", "sides") }
                    cause "an edge of the face was split and the face was not, or the input mixes triangles with other polygons"
                    remedy "split the face by diagonals, or ask for the number that its faces have";
            }
            /// Checked where the expectation asks for it by `closed`. Together with `open`, it names each half-edge at a border; without,
            /// R1 finds that links are missing.
            ///
            /// ```text
            /// ·───►───·
            /// │  f   ╱     the half-edge of f has no twin, or its twin bounds no face
            /// │    ╱
            /// ·──·
            /// ```
            M4 "closed" counts "half-edge" "half-edges"
                "every half-edge has a twin and bounds a face"
                in "mesh" broken by "mesh_rules" "m4_a_mesh_has_a_border"
            {
                OnBorder { half_edge: half_edge, vertices: ends, lacks: field } "on_border"
                    says "half-edge {half_edge}, from vertex {u} to vertex {v}, {lack}: the surface has a border there"
                    with |names| { u = names.vertex(vertices[0]), v = names.vertex(vertices[1]), lack = if lacks == Field::Twin { "has no twin" } else { "bounds no face" } }
                    cause "the surface has a hole or a rim, or two faces at an edge were not joined as twins"
                    remedy "fill the hole, join the faces, or ask for the `borders` that there are instead";
            }
            /// Checked where the expectation asks for it by `components`. Isolated vertices do not count: M1 is about them.
            ///
            /// ```text
            /// ·───·     ·───·
            /// │ ╱       │ ╱      two components
            /// ·         ·
            /// ```
            M5 "connected" counts "component" "components"
                "there are as many components with an edge as expected"
                in "mesh" broken by "mesh_rules" "m5_there_is_a_second_component"
            {
                WrongComponents { found: number, expected: number } "wrong_components"
                    says "the structure has {count} with an edge, where {expected} are expected"
                    with |names| { count = Number(found as u64, "component", "components") }
                    cause "parts that should meet have vertices of their own where they touch, or loose parts were left behind"
                    remedy "merge the vertices that coincide, or delete the loose parts";
            }
            /// Checked where the expectation asks for it by `borders`. A border loop is a cycle of half-edges without face, or a cycle
            /// that the missing twins would make: both ways of keeping a border have the same number.
            ///
            /// ```text
            /// ┌─────────────┐
            /// │   ┌─────┐   │
            /// │   │     │   │    an annulus: two border loops
            /// │   └─────┘   │
            /// └─────────────┘
            /// ```
            M6 "borders" counts "component" "components"
                "there are as many border loops as expected"
                in "mesh" broken by "mesh_rules" "m6_there_is_a_second_border"
            {
                WrongBorders { found: number, expected: number } "wrong_borders"
                    says "the structure has {count}, where {expected} are expected"
                    with |names| { count = Number(found as u64, "border loop", "border loops") }
                    cause "faces are missing, or neighbouring faces were not joined as twins"
                    remedy "fill the holes, or join the faces";
            }
            /// Checked where the expectation asks for it by `genus`.
            ///
            /// ```text
            ///    ______
            ///  ╱  ____  ╲
            /// │  ╲____╱  │    a torus: genus 1
            ///  ╲ ______ ╱
            /// ```
            M7 "genus" counts "component" "components"
                "the genera of the components add up to the genus expected"
                in "mesh" broken by "mesh_rules" "m7_a_sphere_is_no_torus"
            {
                WrongGenus { found: number, expected: number } "wrong_genus"
                    says "the components have genus {found} together, where {expected} is expected"
                    cause "faces are missing on both sides of a tunnel, a small handle was left by a reconstruction, or vertices were merged across a gap"
                    remedy "cut the handle and close both ends, or ask for the genus that the surface has";
            }
            /// Checked where the expectation asks for it by `border_kept`. Libraries that promise it tell a border vertex from an inner one
            /// by the one half-edge. Where vertices keep none, it is not checked.
            ///
            /// ```text
            ///   f  ╱
            ///    ╱      a half-edge without face or twin leaves v: v keeps such a half-edge,
            /// ──v───    and none that bounds f
            /// ```
            M8 "kept" counts "vertex" "vertices"
                "if a half-edge without twin or face leaves a vertex, the half-edge kept by that vertex lacks a twin or a face"
                in "mesh" broken by "mesh_rules" "m8_a_border_vertex_keeps_an_inner_half_edge"
            {
                KeptInside { vertex: vertex, half_edge: half_edge, border: half_edge } "kept_inside"
                    says "vertex {vertex} keeps half-edge {half_edge}, which is not on the border, where half-edge {border} leaves it along the border"
                    cause "a face was removed, or added beside the border, and the half-edge kept by its vertices was not chosen again"
                    remedy "after a change along the border, let each vertex there keep the half-edge of the border that leaves it";
            }
        }
    };
}

pub(in crate::validate) use mesh_rules;

/// Runs M1 … M8, as far as they are asked for. `is_simple` says that there is neither a loop nor a pair of parallel edges.
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

/// True if an optional rule is passed over: it was not asked for, or the rule that it needs is broken, which is then entered as
/// the reason.
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
/// It needs live origins.
fn used(subject: Subject<'_>, census: &Census, findings: &mut Findings) -> Flow {
    if passes_over(subject, Rule::M1, census.links_broken(), findings) {
        return Ok(());
    }
    findings.checked(Rule::M1, census.vertices as u64);
    if census.isolated_vertices == 0 {
        return Ok(());
    }
    let mut used = column(subject.extent.vertices.0, false)?;
    for h in subject.half_edges() {
        if let Some(used) = used.get_mut(subject.origin(h) as usize) {
            *used = true;
        }
    }
    subject.vertices().filter(|v| !used[*v]).try_for_each(|vertex| findings.add(Violation::UnusedVertex { vertex }))
}

/// M2 simple: no edge is a loop, and no two edges join the same vertices.
///
/// The edges are sorted by their smaller end, so that edges with the same ends are found in linear time. Of several edges that
/// join the same vertices, each but the first is reported, together with the first.
fn simple(subject: Subject<'_>, census: &Census, is_simple: bool, findings: &mut Findings) -> Flow {
    if passes_over(subject, Rule::M2, census.map_broken(findings), findings) {
        return Ok(());
    }
    findings.checked(Rule::M2, census.edges as u64);
    if is_simple {
        return Ok(());
    }
    let (vertices, half_edges) = (subject.extent.vertices.0, subject.extent.half_edges.0);
    // For each vertex the first edge of which it is the smaller end, and for each half-edge that stands for its edge the next one.
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
    // For each vertex the last edge that was seen to lead there.
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
/// It needs closed cycles, each with one face. The sides of a face are all half-edges that bound it; without faces, they are
/// the half-edges of a cycle.
fn sides(subject: Subject<'_>, census: &Census, findings: &mut Findings) -> Flow {
    let has_faces = subject.has(Part::Faces);
    let below: &[Rule] = if has_faces { &[Rule::R1, Rule::L2, Rule::B1, Rule::F1] } else { &[Rule::L2] };
    let broken = census.links_broken().or_else(|| findings.broken(below));
    if passes_over(subject, Rule::M3, broken, findings) {
        return Ok(());
    }
    if has_faces { faces(subject, findings) } else { cycles(subject, findings) }
}

/// One face, or one cycle.
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
    let mut sides = column(subject.extent.faces.0, 0)?;
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
    let mut seen = column(subject.extent.half_edges.0, false)?;
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
/// It needs live links.
fn closed(subject: Subject<'_>, census: &Census, findings: &mut Findings) -> Flow {
    if passes_over(subject, Rule::M4, census.links_broken(), findings) {
        return Ok(());
    }
    findings.checked(Rule::M4, census.half_edges as u64);
    // R1 has shown that nothing is missing.
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
/// Compares the number of border loops, which is known unless a rule that the counting relies on is broken.
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
/// Compares the sum that T3 has made.
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
/// It needs live links and V1.
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
    // R1 has shown that nothing is missing.
    if !subject.is_open() {
        return Ok(());
    }
    let is_on_border = |h: usize| subject.view.twin(h).is_none() || subject.lacks_face(h);
    // For each vertex the first half-edge of the border that leaves it.
    let mut border = column(subject.extent.vertices.0, NIL)?;
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
