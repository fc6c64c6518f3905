//! Local validation: it accepts nothing that a full validation refuses, follows what is right, and reads only what has changed.

use crate::support::changes::{difference, touch};
use crate::support::erased::validate;
use crate::support::only_live::OnlyLive;
use crate::support::watched::Watched;
use twinedge::dcel::{Corner, Dcel, HalfEdge, Split};
use twinedge::program::census::{Census, Scope};
use twinedge::program::{StepOutcome, try_every_op};
use twinedge::validate::enumerate::for_each_corruption;
use twinedge::validate::forms::{expectations, projected};
use twinedge::validate::near::{Baseline, BaselineError, Touched, validate_near};
use twinedge::validate::{
    BoundaryPlace, BoundaryRow, Collect, Expectation, FaceRow, HalfEdgeRow, Part, Rule, Start, Table, VertexRow, View,
};

/// Asserts that what is found right keeps R1 … F2.
fn judge(baseline: &Baseline, table: &Table, touched: &Touched) -> bool {
    let found = validate_near(&mut baseline.clone(), &OnlyLive(table), touched);
    let report = validate(table, baseline.expectation(), Collect::All);
    match found {
        Ok(()) => {
            let broken = report.broken_rules().find(|rule| *rule <= Rule::F2);
            assert_eq!(broken, None, "{table}\n{touched:?}\n{report}");
        }
        Err(found) => assert_eq!(*found, report, "{table}\n{touched:?}"),
    }
    report.is_valid()
}

#[test]
fn every_corruption_of_every_small_map_in_every_form() {
    let (mut judged, mut right) = (0, 0);
    for map in Census::new(Scope::Subdivisions { edges: 2, vertices: 3 }) {
        let whole = Table::copy_of(map.runner.subject()).unwrap();
        for expectation in expectations() {
            let mut table = projected(&whole, &expectation);
            let Ok(baseline) = Baseline::new(&table, &expectation) else { continue };
            for_each_corruption(&mut table, &expectation, |corrupt, cell, _| {
                let mut touched = Touched::default();
                touch(&mut touched, cell);
                judged += 1;
                right += usize::from(judge(&baseline, corrupt, &touched));
            });
        }
    }
    assert!(judged > 100_000 && right > 1_000, "{judged} corruptions, of which {right} are right");
}

#[test]
fn every_pair_of_corruptions_of_every_smallest_map() {
    let expectation = Expectation::plane();
    let (mut judged, mut right) = (0, 0);
    for map in Census::new(Scope::Subdivisions { edges: 1, vertices: 3 }) {
        let mut table = Table::copy_of(map.runner.subject()).unwrap();
        let baseline = Baseline::new(&table, &expectation).unwrap();
        for_each_corruption(&mut table, &expectation, |corrupt, first, _| {
            let mut twice = corrupt.clone();
            for_each_corruption(&mut twice, &expectation, |corrupt, second, _| {
                let mut touched = Touched::default();
                touch(&mut touched, first);
                touch(&mut touched, second);
                judged += 1;
                right += usize::from(judge(&baseline, corrupt, &touched));
            });
        });
    }
    assert!(judged > 100_000 && right > 100, "{judged} pairs, of which {right} are right");
}

/// All that an operator can do wrong by one link, on every small map.
#[test]
fn every_operator_with_every_wrong_link() {
    let expectation = Expectation::plane();
    let (mut judged, mut wrong) = (0, 0);
    for map in Census::new(Scope::Subdivisions { edges: 2, vertices: 2 }) {
        let before = Table::copy_of(map.runner.subject()).unwrap();
        let baseline = Baseline::new(&before, &expectation).unwrap();
        try_every_op(&map.runner, |_, outcome, changed| {
            if outcome != StepOutcome::Applied {
                return;
            }
            let mut after = Table::copy_of(changed.subject()).unwrap();
            let written = difference(&before, &after);
            for_each_corruption(&mut after, &expectation, |corrupt, cell, _| {
                let mut touched = written.clone();
                touch(&mut touched, cell);
                judged += 1;
                wrong += usize::from(!judge(&baseline, corrupt, &touched));
            });
        });
    }
    assert!(judged > 100_000 && wrong * 10 > judged * 9, "{judged} results, of which {wrong} are wrong");
}

/// One baseline follows each operator, and is then what a new one would be.
#[test]
fn a_baseline_follows_every_operator_on_every_small_map() {
    for expectation in [
        Expectation::plane(),
        Expectation::plane().without(Part::Prev).without(Part::Leaving),
        Expectation::plane().without(Part::Faces),
        Expectation::plane().without(Part::Faces).without(Part::Prev).without(Part::Leaving),
        Expectation::surface(),
        Expectation::surface().without(Part::BoundaryComponents),
    ] {
        for map in Census::new(Scope::Subdivisions { edges: 3, vertices: 2 }) {
            let whole = Table::copy_of(map.runner.subject()).unwrap();
            let before = projected(&whole, &expectation);
            let baseline = Baseline::new(&before, &expectation).unwrap();
            try_every_op(&map.runner, |op, _, changed| {
                let after = projected(&Table::copy_of(changed.subject()).unwrap(), &expectation);
                let mut followed = baseline.clone();
                let touched = difference(&before, &after);
                validate_near(&mut followed, &after, &touched).unwrap();
                // Both lead to the same verdicts from here on, if they go back by the same way.
                let fresh = Baseline::new(&after, &expectation).unwrap();
                for mut baseline in [followed, fresh] {
                    validate_near(&mut baseline, &before, &touched).unwrap();
                }
                assert!(!touched.is_empty() || before == after, "{op:?}");
            });
        }
    }
}

/// A ring of this many edges, and in its face an isolated vertex and a ring of three.
fn ring(edges: usize) -> Dcel {
    let mut dcel = Dcel::new();
    let outside = dcel.unbounded_face().key();
    for edges in [edges, 3] {
        let face = dcel.faces().find(|face| !face.is_unbounded()).map_or(outside, |face| face.key());
        let v = dcel.add_isolated_vertex(face).unwrap().vertex;
        let h = dcel.connect(v, v, Split::default()).unwrap().half_edge;
        for _ in 1..edges {
            dcel.split_edge(h).unwrap();
        }
        dcel.add_isolated_vertex(face).unwrap();
    }
    dcel
}

/// What it reads does not grow with the structure.
#[test]
fn what_is_read_depends_on_the_change_only() {
    type Change = fn(&mut Dcel);
    let changes: [(&str, Change); 6] = [
        ("split_edge", |dcel| {
            let h = dcel.half_edges().next().unwrap().key();
            dcel.split_edge(h).unwrap();
        }),
        ("join_edges", |dcel| {
            let h = dcel.half_edges().next().unwrap().key();
            dcel.join_edges(h).unwrap();
        }),
        ("connect, near", |dcel| {
            let h = dcel.half_edges().next().unwrap();
            let (from, to) = (Corner::At(h.key()), Corner::At(h.next().next().key()));
            dcel.connect(from, to, Split::default()).unwrap();
        }),
        ("connect, with an isolated vertex", |dcel| {
            let h = dcel.half_edges().find(|h| h.face().inner().any(|b| b.isolated_vertex().is_some())).unwrap();
            let v = h.face().inner().find_map(|b| b.isolated_vertex()).unwrap().key();
            let h = h.key();
            dcel.connect(h, v, Split::default()).unwrap();
        }),
        ("add_isolated_vertex", |dcel| {
            let f = dcel.half_edges().next().unwrap().face().key();
            dcel.add_isolated_vertex(f).unwrap();
        }),
        ("contract_edge", |dcel| {
            let h = dcel.half_edges().next().unwrap().key();
            dcel.contract_edge(h).unwrap();
        }),
    ];
    for (name, change) in changes {
        let asked = [50, 5_000].map(|edges| {
            let mut dcel = ring(edges);
            let before = Table::copy_of(&dcel).unwrap();
            let mut baseline = Baseline::new(&before, &Expectation::plane()).unwrap();
            change(&mut dcel);
            let after = Table::copy_of(&dcel).unwrap();
            let watched = Watched::new(&after);
            validate_near(&mut baseline, &watched, &difference(&before, &after)).unwrap();
            [&watched.twin, &watched.next, &watched.prev, &watched.inner_count, &watched.inner]
                .map(std::cell::Cell::get)
        });
        assert_eq!(asked[0], asked[1], "{name}");
        assert!(asked[0].iter().sum::<usize>() < 300, "{name}: {asked:?}");
    }
}

#[test]
fn where_there_is_no_local_validation() {
    let table = Table::copy_of(&ring(3)).unwrap();
    let of = |expectation: Expectation| Baseline::new(&projected(&table, &expectation), &expectation);
    assert!(matches!(of(Expectation::plane().open()), Err(BaselineError::OpenBoundaries)));
    for part in [Part::BoundaryComponents, Part::Places, Part::UnboundedFace] {
        assert!(matches!(of(Expectation::plane().without(part)), Err(BaselineError::Lacks(lacks)) if lacks == part));
    }
    let mut broken = table;
    broken.half_edges.iter_mut().flatten().next().unwrap().next = Some(0);
    let Err(BaselineError::Invalid(report)) = Baseline::new(&broken, &Expectation::plane()) else { panic!() };
    assert_eq!(*report, validate(&broken, &Expectation::plane(), Collect::All));
}

/// A face that came and went within one change, like all of its records.
#[test]
fn what_came_and_went_is_vacant() {
    let mut dcel = ring(5_000);
    let mut baseline = Baseline::new(&dcel, &Expectation::plane()).unwrap();
    let before = Table::copy_of(&dcel).unwrap();
    let h = dcel.half_edges().next().unwrap();
    let (from, to) = (Corner::At(h.key()), Corner::At(h.next().next().key()));
    let connected = dcel.connect(from, to, Split::default()).unwrap().half_edge;
    let between = Table::copy_of(&dcel).unwrap();
    dcel.remove_edge(connected).unwrap();
    let after = Table::copy_of(&dcel).unwrap();
    let (mut touched, back) = (difference(&before, &between), difference(&between, &after));
    touched.half_edges.extend(back.half_edges);
    touched.vertices.extend(back.vertices);
    touched.boundaries.extend(back.boundaries);
    touched.faces.extend(back.faces);
    touched.listed.extend(back.listed);
    let watched = Watched::new(&after);
    validate_near(&mut baseline, &watched, &touched).unwrap();
    assert!(watched.twin.get() < 100, "{}", watched.twin.get());
}

/// After records were not named the baseline is wrong. Nothing loops or panics then, and what is wrong in the structure itself
/// is found if it is named.
#[test]
fn a_baseline_that_missed_something_ends() {
    let expectation = Expectation::plane();
    for map in Census::new(Scope::Subdivisions { edges: 2, vertices: 2 }) {
        let mut table = Table::copy_of(map.runner.subject()).unwrap();
        let right = Baseline::new(&table, &expectation).unwrap();
        let everything = difference(&Table::default(), &table);
        let before = table.clone();
        for_each_corruption(&mut table, &expectation, |corrupt, cell, _| {
            let mut baseline = right.clone();
            let mut touched = everything.clone();
            touch(&mut touched, cell);
            // It believes that nothing has changed, and then hears of records that have not.
            assert!(validate_near(&mut baseline, corrupt, &Touched::default()).is_ok());
            let found = validate_near(&mut baseline, corrupt, &touched);
            let report = validate(corrupt, &expectation, Collect::First);
            assert!(found.is_err() || report.broken_rules().all(|rule| rule > Rule::F2), "{corrupt}");
            assert!(validate_near(&mut baseline, &before, &touched).is_ok());
        });
    }
}

/// A structure that is right although records that have changed were not named is right, and followed from there.
#[test]
fn forgotten_records_are_caught_up_with() {
    let mut dcel = ring(5);
    let mut baseline = Baseline::new(&dcel, &Expectation::plane()).unwrap();
    let h = dcel.half_edges().next().unwrap().key();
    // Nothing is named, so nothing is read, and nothing can be said.
    dcel.split_edge(h).unwrap();
    validate_near(&mut baseline, &dcel, &Touched::default()).unwrap();
    let before = Table::copy_of(&dcel).unwrap();
    dcel.split_edge(h).unwrap();
    let some =
        Touched { vertices: difference(&before, &Table::copy_of(&dcel).unwrap()).vertices, ..Touched::default() };
    validate_near(&mut baseline, &dcel, &some).unwrap();
    let before = Table::copy_of(&dcel).unwrap();
    dcel.split_edge(h).unwrap();
    let after = Table::copy_of(&dcel).unwrap();
    let watched = Watched::new(&after);
    validate_near(&mut baseline, &watched, &difference(&before, &after)).unwrap();
    assert!(watched.twin.get() < 100);
}

/// This many components of two vertices with two edges between them, each with a face inside. Component i has the half-edges 4i and
/// 4i + 2 around its inside, with boundary component 2i, and the other two around its outside, with 2i + 1.
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

fn face(table: &mut Table, f: usize) -> &mut FaceRow {
    table.faces[f].as_mut().unwrap()
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

/// The cycle inside a component becomes an inner one of the unbounded face: two less in Euler's formula, and T1 is broken.
fn turn_inside_out(table: &mut Table, ring: usize) {
    table.faces[ring + 1] = None;
    list(table, 0, 2 * ring, false);
}

/// The cycle outside a component becomes the outer one of a new face: two more.
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

/// Several wrong records at once, of which no other check but the one that is meant notices anything: with wrong components added
/// so that the sum of Euler's formula holds.
#[test]
#[expect(clippy::too_many_lines, reason = "a table of cases")]
fn what_only_one_check_finds() {
    type Change = fn(&mut Table);
    let mut isolated_in_face = rings(2);
    add_isolated(&mut isolated_in_face, 1);
    add_isolated(&mut isolated_in_face, 1);
    let mut one_vertex = rings(0);
    add_isolated(&mut one_vertex, 0);
    let cases: [(&str, Table, Change, Rule); 9] = [
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
        ("a component has two inner boundary components", rings(1), |table| turn_inside_out(table, 0), Rule::T1),
    ];
    for (name, before, change, rule) in cases {
        let mut after = before.clone();
        change(&mut after);
        let mut touched = difference(&before, &after);
        // The list of a face that goes is not written.
        touched.listed.retain(|(f, _)| after.is_face(*f));
        let report = validate(&after, &Expectation::plane(), Collect::All);
        assert_eq!(report.broken_rules().next(), Some(rule), "{name}: {report}");
        let mut baseline = Baseline::new(&before, &Expectation::plane()).unwrap();
        assert_eq!(validate_near(&mut baseline, &after, &touched), Err(Box::new(report)), "{name}");
    }
}

/// What the baseline did not follow would be a false alarm, and be followed by a full validation.
#[test]
fn a_baseline_follows_a_sequence_without_reading_everything() {
    type Change = fn(&mut Dcel);
    fn first(dcel: &Dcel) -> HalfEdge<'_> {
        dcel.half_edges().next().unwrap()
    }
    let add: Change = |dcel| {
        let f = first(dcel).face().key();
        dcel.add_isolated_vertex(f).unwrap();
    };
    let split: Change = |dcel| {
        let h = first(dcel).key();
        dcel.split_edge(h).unwrap();
    };
    let join: Change = |dcel| {
        let h = first(dcel).key();
        dcel.join_edges(h).unwrap();
    };
    let bridge: Change = |dcel| {
        let h = first(dcel);
        let (v, h) = (h.face().inner().find_map(|b| b.isolated_vertex()).unwrap().key(), h.key());
        dcel.connect(h, v, Split::default()).unwrap();
    };
    let drop_first: Change = |dcel| {
        let v = first(dcel).face().inner().find_map(|b| b.isolated_vertex()).unwrap().key();
        dcel.remove_isolated_vertex(v).unwrap();
    };
    for expectation in [Expectation::plane(), Expectation::plane().without(Part::Prev)] {
        let mut dcel = ring(5_000);
        let mut before = Table::copy_of(&dcel).unwrap();
        let mut baseline = Baseline::new(&before, &expectation).unwrap();
        for change in [split, split, add, add, add, drop_first, bridge, drop_first, join, split, bridge, add, join] {
            change(&mut dcel);
            let after = Table::copy_of(&dcel).unwrap();
            let watched = Watched::new(&after);
            validate_near(&mut baseline, &watched, &difference(&before, &after)).unwrap();
            assert!(watched.twin.get() < 200 && watched.inner.get() < 200, "{}", watched.twin.get());
            before = after;
        }
    }
}
