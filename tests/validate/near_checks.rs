//! Local validation, check by check: several wrong records at once, which only one check notices.

use crate::support::changes::difference;
use crate::support::erased::validate;
use crate::support::tables::{Without, face, half_edge};
use twinedge::validate::near::{Baseline, validate_near};
use twinedge::validate::{
    BoundaryPlace, BoundaryRow, Collect, Expectation, FaceRow, HalfEdgeRow, Part, Parts, Rule, Start, Table, VertexRow,
    View,
};

/// This many components of two vertices joined by two edges, each with a face inside. Component i has the half-edges 4i and 4i + 2
/// around its inside, with boundary component 2i, and the other two around its outside, with 2i + 1.
fn rings(count: usize) -> Table {
    let mut table = Table { faces: vec![Some(FaceRow::default())], ..Table::default() };
    for i in 0..count {
        let (v, h, b) = (2 * i, 4 * i, 2 * i);
        let vertex = |leaving: usize| Some(VertexRow { leaving: Some(leaving), ..VertexRow::default() });
        table.vertices.extend([vertex(h), vertex(h + 1)]);
        let half_edge = |origin: usize, twin: usize, next: usize, boundary: usize| {
            let [origin, twin, next, boundary] = [origin, twin, next, boundary].map(Some);
            Some(HalfEdgeRow { origin, twin, next, prev: next, boundary, ..HalfEdgeRow::default() })
        };
        table.half_edges.extend([
            half_edge(v, h + 1, h + 2, b),
            half_edge(v + 1, h, h + 3, b + 1),
            half_edge(v + 1, h + 3, h, b),
            half_edge(v, h + 2, h + 1, b + 1),
        ]);
        let face = add_face(&mut table);
        add_boundary(&mut table, face, Start::HalfEdge(h), true);
        add_boundary(&mut table, 0, Start::HalfEdge(h + 1), false);
    }
    table
}

fn add_face(table: &mut Table) -> usize {
    table.faces.push(Some(FaceRow::default()));
    table.faces.len() - 1
}

fn add_boundary(table: &mut Table, f: usize, start: Start, is_outer: bool) -> usize {
    table.boundaries.push(Some(BoundaryRow { start: Some(start), ..BoundaryRow::default() }));
    let b = table.boundaries.len() - 1;
    list(table, f, b, is_outer);
    b
}

/// Puts a boundary component at the end of a list, or in the place of the outer one.
fn list(table: &mut Table, f: usize, b: usize, is_outer: bool) {
    let place = if is_outer { BoundaryPlace::Outer } else { BoundaryPlace::Inner(face(table, f).inner.len()) };
    match place {
        BoundaryPlace::Outer => face(table, f).outer = Some(b),
        BoundaryPlace::Inner(_) => face(table, f).inner.push(Some(b)),
    }
    let row = table.boundaries[b].as_mut().unwrap();
    (row.face, row.place) = (Some(f), Some(place));
}

fn add_isolated(table: &mut Table, f: usize) -> usize {
    table.vertices.push(Some(VertexRow::default()));
    let v = table.vertices.len() - 1;
    let b = add_boundary(table, f, Start::Vertex(v), false);
    table.vertices[v].as_mut().unwrap().isolated = Some(b);
    v
}

/// Makes the inside cycle of a component an inner one of the unbounded face: Euler's sum falls by two, and T1 is broken.
fn turn_inside_out(table: &mut Table, ring: usize) {
    table.faces[ring + 1] = None;
    list(table, 0, 2 * ring, false);
}

/// Makes the outside cycle of a component the outer one of a new face: Euler's sum rises by two.
fn close(table: &mut Table, ring: usize) {
    let f = add_face(table);
    let b = 2 * ring + 1;
    let Some(BoundaryPlace::Inner(i)) = table.boundaries[b].unwrap().place else { unreachable!("it is an inner one") };
    face(table, 0).inner.swap_remove(i);
    if let Some(Some(last)) = face(table, 0).inner.get(i).copied() {
        table.boundaries[last].as_mut().unwrap().place = Some(BoundaryPlace::Inner(i));
    }
    list(table, f, b, true);
}

/// Half-edges with the twins 2i and 2i + 1, by vertex in clockwise order, and a face for each cycle.
fn turning(rotations: &[&[usize]]) -> Table {
    let count = rotations.iter().map(|rotation| rotation.len()).sum();
    let parts = Parts::NONE.with(Part::Prev).with(Part::Leaving).with(Part::Faces);
    let mut table = Table { parts, half_edges: vec![Some(HalfEdgeRow::default()); count], ..Table::default() };
    for (v, rotation) in rotations.iter().enumerate() {
        table.vertices.push(Some(VertexRow { leaving: Some(rotation[0]), ..VertexRow::default() }));
        for h in *rotation {
            let row = half_edge(&mut table, *h);
            (row.origin, row.twin) = (Some(v), Some(h ^ 1));
        }
        turn(&mut table, rotation);
    }
    for h in 0..count {
        if half_edge(&mut table, h).face.is_none() {
            let f = add_face(&mut table);
            face(&mut table, f).outer_half_edge = Some(h);
            let mut at = h;
            while half_edge(&mut table, at).face.replace(f).is_none() {
                at = half_edge(&mut table, at).next.unwrap();
            }
        }
    }
    table
}

/// Links half-edges in clockwise order, the last one to the first.
fn turn(table: &mut Table, rotation: &[usize]) {
    for (i, h) in rotation.iter().enumerate() {
        let next = rotation[(i + 1) % rotation.len()];
        half_edge(table, h ^ 1).next = Some(next);
        half_edge(table, next).prev = Some(h ^ 1);
    }
}

/// Asserts that a change breaks this rule and no earlier one, and that local validation finds it: with a baseline of the previous
/// structure, and with one that followed it from nothing; with only changed records named, and with all.
fn assert_found(name: &str, [before, after]: [&Table; 2], expectation: &Expectation, rule: Rule) {
    let report = validate(after, expectation, Collect::All);
    assert_eq!(report.broken_rules().next(), Some(rule), "{name}: {report}");
    let parts = before.parts;
    let unbounded = parts.has(Part::UnboundedFace).then(|| Some(FaceRow::default()));
    let nothing = Table { parts, faces: unbounded.into_iter().collect(), ..Table::default() };
    let mut followed = Baseline::new(&nothing, expectation).unwrap();
    validate_near(&mut followed, before, &difference(&nothing, before)).unwrap();
    let mut changed = difference(before, after);
    // An entry beyond the end of a list, or of a removed face, is not written.
    changed.listed.retain(|(f, i)| after.is_face(*f) && *i < after.inner_count(*f));
    let mut everything = difference(&Table::default(), after);
    everything.vertices.extend(&changed.vertices);
    everything.half_edges.extend(&changed.half_edges);
    everything.boundaries.extend(&changed.boundaries);
    everything.faces.extend(&changed.faces);
    for baseline in [Baseline::new(before, expectation).unwrap(), followed] {
        for written in [&changed, &everything] {
            let found = validate_near(&mut baseline.clone(), after, written);
            assert_eq!(found, Err(Box::new(report.clone())), "{name}");
        }
    }
}

/// Wrong components are added to keep the sum of Euler's formula.
#[test]
#[expect(clippy::too_many_lines, reason = "a table of cases")]
fn what_only_one_check_finds() {
    type Change = fn(&mut Table);
    let mut isolated_in_face = rings(2);
    add_isolated(&mut isolated_in_face, 1);
    add_isolated(&mut isolated_in_face, 1);
    let mut one_vertex = rings(0);
    add_isolated(&mut one_vertex, 0);
    let cases: [(&str, Table, Change, Rule); 12] = [
        (
            "a half-edge is its own twin",
            one_vertex,
            |table| {
                let [own, b] = [Some(0), Some(0)];
                let row =
                    HalfEdgeRow { origin: own, twin: own, next: own, prev: own, boundary: b, ..HalfEdgeRow::default() };
                table.half_edges.push(Some(row));
                table.vertices[0] = Some(VertexRow { leaving: Some(0), ..VertexRow::default() });
                table.boundaries[0].as_mut().unwrap().start = Some(Start::HalfEdge(0));
            },
            Rule::L1,
        ),
        (
            "two half-edges are each other's twins, and those that were their twins do not know",
            rings(1),
            |table| {
                for (h, twin) in [(0, 2), (2, 0)] {
                    table.half_edges[h].as_mut().unwrap().twin = Some(twin);
                }
            },
            Rule::L1,
        ),
        (
            "each half-edge of two cycles has a label of its own",
            rings(1),
            |table| {
                let f = add_face(table);
                let b = add_boundary(table, f, Start::HalfEdge(2), true);
                table.half_edges[2].as_mut().unwrap().boundary = Some(b);
                let b = add_boundary(table, 0, Start::HalfEdge(3), false);
                table.half_edges[3].as_mut().unwrap().boundary = Some(b);
            },
            Rule::B1,
        ),
        (
            "isolated vertices name what starts elsewhere",
            rings(1),
            |table| {
                let v = add_isolated(table, 0);
                let row = table.vertices[v];
                table.vertices.extend([row, row]);
                turn_inside_out(table, 0);
            },
            Rule::B2,
        ),
        (
            "three cycles have one label",
            rings(0),
            |table| {
                *table = rings(4);
                for ring in [1, 2] {
                    for h in [4 * ring + 1, 4 * ring + 3] {
                        table.half_edges[h].as_mut().unwrap().boundary = Some(1);
                    }
                    table.boundaries[2 * ring + 1] = None;
                }
                let all: Vec<usize> = face(table, 0).inner.iter().flatten().copied().collect();
                face(table, 0).inner.clear();
                all.into_iter().filter(|b| [1, 7].contains(b)).for_each(|b| list(table, 0, b, false));
                turn_inside_out(table, 3);
            },
            Rule::B1,
        ),
        (
            "three cycles say that they are the outer one of a face",
            rings(4),
            |table| {
                for ring in [1, 2] {
                    table.faces[ring + 1] = None;
                    table.boundaries[2 * ring].as_mut().unwrap().face = Some(1);
                }
                close(table, 3);
            },
            Rule::F2,
        ),
        (
            "two faces have another cycle as their outer one, and those that were say that they still are",
            rings(5),
            |table| {
                for (f, ring) in [(1, 1), (3, 3)] {
                    table.faces[ring + 1] = None;
                    list(table, f, 2 * ring, true);
                }
                close(table, 4);
            },
            Rule::F2,
        ),
        (
            "two new faces say that their outer one is that of another face",
            rings(2),
            |table| {
                for _ in 0..2 {
                    let f = add_face(table);
                    face(table, f).outer = Some(0);
                }
                turn_inside_out(table, 1);
            },
            Rule::F2,
        ),
        (
            "a face goes, and what it listed stays",
            isolated_in_face,
            |table| {
                let f = add_face(table);
                list(table, f, 0, true);
                table.faces[1] = None;
                turn_inside_out(table, 1);
            },
            Rule::R1,
        ),
        (
            "two more faces are unbounded",
            rings(1),
            |table| {
                add_face(table);
                add_face(table);
                turn_inside_out(table, 0);
            },
            Rule::F1,
        ),
        (
            "a list is shorter than there are boundary components that say that they are there",
            rings(2),
            |table| {
                face(table, 0).inner.pop();
            },
            Rule::F2,
        ),
        ("a component has two inner boundary components", rings(1), |table| turn_inside_out(table, 0), Rule::T1),
    ];
    for (name, before, change, rule) in cases {
        let mut after = before.clone();
        change(&mut after);
        assert_found(name, [&before, &after], &Expectation::plane(), rule);
    }
}

/// A fault in the links from an unchanged half-edge to a changed one, which no other check finds.
#[test]
fn what_only_a_half_edge_that_has_not_changed_tells() {
    type Change = fn(&mut Table);
    let petal = |i: usize| [[8 * i + 1, 8 * i + 2], [8 * i + 3, 8 * i + 4], [8 * i + 5, 8 * i + 6]];
    let corners: Vec<[usize; 2]> = (0..3).flat_map(petal).collect();
    let mut petals: Vec<&[usize]> = vec![&[7, 0, 15, 8, 23, 16]];
    petals.extend(corners.iter().map(|corner| corner.as_slice()));
    let cases: [(&str, Table, Change, Rule); 4] = [
        (
            "two vertices have one rotation, in which each has two stretches: the first half-edge of one is another's before",
            turning(&[&[0, 3], &[1, 2], &[4, 7], &[5, 6]]).without(Part::Faces),
            |table| {
                turn(table, &[3, 4, 7, 0]);
                for (h, v, leaving) in [(0, 2, 7), (4, 0, 3)] {
                    half_edge(table, h).origin = Some(v);
                    table.vertices[v].as_mut().unwrap().leaving = Some(leaving);
                }
            },
            Rule::L3,
        ),
        (
            "the same, and the last of a stretch is another's before",
            turning(&[&[0, 2, 4, 6], &[8, 10, 12, 14], &[1, 3, 5, 7, 9, 11, 13, 15]]).without(Part::Faces),
            |table| {
                let edge = |(h, v): (usize, usize)| {
                    Some(HalfEdgeRow { origin: Some(v), twin: Some(h ^ 1), ..HalfEdgeRow::default() })
                };
                table.half_edges.extend([(16, 0), (17, 1)].map(edge));
                turn(table, &[0, 2, 12, 17, 14, 8, 10, 4, 16, 6]);
                for (h, v, leaving) in [(2, 1, 8), (10, 0, 0)] {
                    half_edge(table, h).origin = Some(v);
                    table.vertices[v].as_mut().unwrap().leaving = Some(leaving);
                }
            },
            Rule::L3,
        ),
        (
            "two half-edges lead to the same",
            turning(&[&[0], &[1, 2], &[3]]),
            |table| {
                half_edge(table, 3).next = Some(2);
                half_edge(table, 2).prev = Some(3);
            },
            Rule::L2,
        ),
        (
            "three cycles have become one that has their three labels by turns",
            turning(&petals),
            |table| {
                turn(table, &[7, 8, 23, 0, 15, 16]);
                for i in 0..3 {
                    let (first, last, end) = (8 * i, 8 * i + 6, 24 + 2 * i);
                    let label = half_edge(table, first).face;
                    half_edge(table, (last + 16) % 24).face = label;
                    // An edge to a new vertex.
                    let corner = half_edge(table, first + 2).origin;
                    table.vertices.push(Some(VertexRow { leaving: Some(end + 1), ..VertexRow::default() }));
                    let new = Some(table.vertices.len() - 1);
                    table.half_edges.extend([(end, corner), (end + 1, new)].map(|(h, origin)| {
                        Some(HalfEdgeRow { origin, twin: Some(h ^ 1), face: label, ..HalfEdgeRow::default() })
                    }));
                    turn(table, &[first + 1, end, first + 2]);
                    turn(table, &[end + 1]);
                }
            },
            Rule::B1,
        ),
    ];
    for (name, before, change, rule) in cases {
        let mut after = before.clone();
        change(&mut after);
        assert_found(name, [&before, &after], &Expectation::surface(), rule);
    }
}
