//! Local validation: it accepts nothing that a full validation refuses, follows valid changes, and reads only changes.

use crate::support::changes::{difference, note};
use crate::support::erased::validate;
use crate::support::only_live::OnlyLive;
use crate::support::small::small_maps;
use crate::support::watched::Watched;
use twinedge::dcel::{Corner, Dcel, HalfEdge, Split};
use twinedge::program::{StepOutcome, try_every_op};
use twinedge::validate::near::{Baseline, BaselineError, WriteSet, validate_near};
use twinedge::validate::{BoundaryPlace, Collect, Expectation, Part, Parts, Rule, Start, Table};
use twinedge_trials::census::{Census, Scope};
use twinedge_trials::enumerate::for_each_corruption;
use twinedge_trials::forms::{Form, forms, projected};

const PLANE: Expectation = Expectation::plane();
const SURFACE: Expectation = Expectation::surface();

/// Asserts that accepted structures keep R1 … F2.
fn judge(baseline: &Baseline, table: &Table, written: &WriteSet) -> bool {
    let found = validate_near(&mut baseline.clone(), &OnlyLive(table), written);
    let report = validate(table, baseline.expectation(), Collect::First);
    match found {
        Ok(()) => {
            let broken = report.broken_rules().find(|rule| *rule <= Rule::F2);
            assert_eq!(broken, None, "{table}\n{written:?}\n{report}");
        }
        // Of two full validations, this one stops at the first broken rule.
        Err(found) => assert_eq!(found.first(), report.first(), "{table}\n{written:?}"),
    }
    report.is_valid()
}

#[test]
fn every_corruption_of_every_small_map_in_every_form() {
    let (mut judged, mut right) = (0, 0);
    for whole in small_maps(2, 3) {
        for form in forms() {
            let mut table = projected(&whole, &form);
            let Ok(baseline) = Baseline::new(&table, &form.expectation) else { continue };
            for_each_corruption(&mut table, form.parts, |corrupt, cell, _| {
                let mut written = WriteSet::default();
                note(&mut written, cell);
                judged += 1;
                right += usize::from(judge(&baseline, corrupt, &written));
            });
        }
    }
    assert!(judged > 100_000 && right > 1_000, "{judged} corruptions, of which {right} are right");
}

#[test]
fn every_pair_of_corruptions_of_every_smallest_map() {
    let (mut judged, mut right) = (0, 0);
    // Without faces, a rotation that falls in two breaks no other rule.
    for form in [Form::new(PLANE, Parts::ALL), Form::new(SURFACE, Parts::NONE)] {
        for whole in small_maps(1, 3) {
            let mut table = projected(&whole, &form);
            let baseline = Baseline::new(&table, &form.expectation).unwrap();
            for_each_corruption(&mut table, form.parts, |corrupt, first, _| {
                let mut twice = corrupt.clone();
                for_each_corruption(&mut twice, form.parts, |corrupt, second, _| {
                    let mut written = WriteSet::default();
                    note(&mut written, first);
                    note(&mut written, second);
                    judged += 1;
                    right += usize::from(judge(&baseline, corrupt, &written));
                });
            });
        }
    }
    assert!(judged > 100_000 && right > 100, "{judged} pairs, of which {right} are right");
}

/// The outer boundary component of a face and an isolated vertex inside exchange their places; half-edges are unchanged.
#[test]
fn an_isolated_vertex_is_no_outer_boundary_component() {
    let before = Table::copy_of(&ring(5)).unwrap();
    let baseline = Baseline::new(&before, &PLANE).unwrap();
    let is_isolated = |b: usize| before.boundaries[b].is_some_and(|row| matches!(row.start, Some(Start::Vertex(_))));
    let mut exchanged = 0;
    for (f, face) in before.faces.iter().enumerate().filter_map(|(f, face)| Some((f, face.as_ref()?))) {
        let Some(outer) = face.outer else { continue };
        for (i, inner) in
            face.inner.iter().enumerate().filter_map(|(i, b)| Some((i, (*b).filter(|b| is_isolated(*b))?)))
        {
            let mut after = before.clone();
            let row = after.faces[f].as_mut().unwrap();
            (row.outer, row.inner[i]) = (Some(inner), Some(outer));
            after.boundaries[inner].as_mut().unwrap().place = Some(BoundaryPlace::Outer);
            after.boundaries[outer].as_mut().unwrap().place = Some(BoundaryPlace::Inner(i));
            assert!(!judge(&baseline, &after, &difference(&before, &after)));
            assert_eq!(validate(&after, &PLANE, Collect::First).broken_rules().next(), Some(Rule::F1));
            exchanged += 1;
        }
    }
    assert_eq!(exchanged, 1);
}

/// Two isolated vertices lose their boundary components, and the face around them is removed: its outer boundary component
/// becomes an inner one of the unbounded face. The sum of Euler's formula is unchanged, and only the vertices, which were not
/// written, reveal the fault.
#[test]
fn vertices_of_boundary_components_that_go_are_looked_at() {
    let mut dcel = Dcel::new();
    let outside = dcel.unbounded_face().key();
    let v = dcel.add_isolated_vertex(outside).unwrap().vertex;
    let h = dcel.connect(v, v, Split::default()).unwrap().half_edge;
    let inside = dcel.faces().find(|face| !face.is_unbounded()).unwrap().key();
    dcel.split_edge(h).unwrap();
    for _ in 0..2 {
        dcel.add_isolated_vertex(inside).unwrap();
    }
    let before = Table::copy_of(&dcel).unwrap();
    let mut after = before.clone();
    let gone = after.faces.iter().position(|face| face.as_ref().is_some_and(|face| face.outer.is_some())).unwrap();
    let face = after.faces[gone].take().unwrap();
    for b in face.inner.iter().flatten() {
        after.boundaries[*b] = None;
    }
    let (kept, unbounded) = after.faces.iter_mut().enumerate().find_map(|(f, face)| Some((f, face.as_mut()?))).unwrap();
    let place = BoundaryPlace::Inner(unbounded.inner.len());
    unbounded.inner.push(face.outer);
    let outer = after.boundaries[face.outer.unwrap()].as_mut().unwrap();
    (outer.face, outer.place) = (Some(kept), Some(place));
    let written = difference(&before, &after);
    assert!(written.vertices.is_empty());
    assert!(!judge(&Baseline::new(&before, &PLANE).unwrap(), &after, &written));
    let report = validate(&after, &PLANE, Collect::All);
    assert_eq!(report.broken_rules().next(), Some(Rule::R1));
}

/// Data about a refused change does not influence the next one.
#[test]
fn a_refused_change_leaves_the_baseline_as_it_was() {
    let mut refused = 0;
    for mut table in small_maps(2, 2) {
        let before = table.clone();
        let mut baseline = Baseline::new(&table, &PLANE).unwrap();
        for_each_corruption(&mut table, Parts::ALL, |corrupt, cell, _| {
            let mut written = WriteSet::default();
            note(&mut written, cell);
            if validate_near(&mut baseline, corrupt, &written).is_ok() {
                // It has moved on: move it back.
                validate_near(&mut baseline, &before, &written).unwrap();
            } else {
                let watched = Watched::new(&before);
                validate_near(&mut baseline, &watched, &WriteSet::default()).unwrap();
                assert_eq!(watched.next.get(), 0, "{corrupt}");
                refused += 1;
            }
        });
    }
    assert!(refused > 3_000, "{refused}");
}

/// Every incorrect link after an operator, on every small map.
#[test]
fn every_operator_with_every_wrong_link() {
    let (mut judged, mut wrong) = (0, 0);
    for map in Census::new(Scope::Subdivisions { edges: 2, vertices: 2 }) {
        let before = Table::copy_of(map.runner.subject()).unwrap();
        let baseline = Baseline::new(&before, &PLANE).unwrap();
        try_every_op(&map.runner, |_, outcome, changed| {
            if outcome != StepOutcome::Applied {
                return;
            }
            let mut after = Table::copy_of(changed.subject()).unwrap();
            let by_operator = difference(&before, &after);
            for_each_corruption(&mut after, Parts::ALL, |corrupt, cell, _| {
                let mut written = by_operator.clone();
                note(&mut written, cell);
                judged += 1;
                wrong += usize::from(!judge(&baseline, corrupt, &written));
            });
        });
    }
    assert!(judged > 100_000 && wrong * 10 > judged * 9, "{judged} results, of which {wrong} are wrong");
}

/// The table with each of its records removed in turn.
fn dropped(table: &Table) -> Vec<Table> {
    let mut all = vec![];
    for v in 0..table.vertices.len() {
        all.push(Table { vertices: without(&table.vertices, v), ..table.clone() });
    }
    for h in 0..table.half_edges.len() {
        all.push(Table { half_edges: without(&table.half_edges, h), ..table.clone() });
    }
    for b in 0..table.boundaries.len() {
        all.push(Table { boundaries: without(&table.boundaries, b), ..table.clone() });
    }
    for f in 0..table.faces.len() {
        all.push(Table { faces: without(&table.faces, f), ..table.clone() });
    }
    all
}

fn without<R: Clone>(rows: &[Option<R>], i: usize) -> Vec<Option<R>> {
    let mut rows = rows.to_vec();
    rows[i] = None;
    rows
}

/// Additionally drops a record that an operator needs, in every way. On surfaces without `prev` the half-edges of a dropped
/// vertex may all be unchanged, and no sum reveals it.
#[test]
fn every_operator_that_drops_a_record() {
    let (mut judged, mut wrong) = (0, 0);
    for form in [Form::new(PLANE, Parts::ALL), Form::new(SURFACE, Parts::NONE)] {
        for map in Census::new(Scope::Subdivisions { edges: 2, vertices: 2 }) {
            let read = |dcel: &Dcel| projected(&Table::copy_of(dcel).unwrap(), &form);
            let before = read(map.runner.subject());
            let baseline = Baseline::new(&before, &form.expectation).unwrap();
            try_every_op(&map.runner, |_, outcome, changed| {
                if outcome != StepOutcome::Applied {
                    return;
                }
                for table in dropped(&read(changed.subject())) {
                    judged += 1;
                    wrong += usize::from(!judge(&baseline, &table, &difference(&before, &table)));
                }
            });
        }
    }
    assert!(judged > 20_000 && wrong * 2 > judged, "{judged} results, of which {wrong} are wrong");
}

/// A random mixture of the rows of two tables.
fn mixed<R: Clone + PartialEq>(
    before: &[Option<R>],
    after: &[Option<R>],
    mut coin: impl FnMut() -> bool,
) -> Vec<Option<R>> {
    let row = |rows: &[Option<R>], i: usize| rows.get(i).cloned().flatten();
    let mut either = |i: usize| {
        let [was, is] = [before, after].map(|rows| row(rows, i));
        if was != is && coin() { was } else { is }
    };
    (0..before.len().max(after.len())).map(&mut either).collect()
}

/// Operators that leave some records unchanged by mistake: a few ways of each.
#[test]
fn every_operator_that_forgets_some_records() {
    let (mut judged, mut right, mut bits) = (0, 0, 1_u64);
    let mut coin = || {
        bits = bits.wrapping_mul(0x5851_F42D_4C95_7F2D).wrapping_add(0x1405_7B7E_F767_814F);
        bits >> 62 == 0
    };
    for (claims, parts) in [
        (PLANE, Parts::ALL),
        (PLANE, Parts::ALL.without(Part::Prev)),
        (PLANE, Parts::NONE.with(Part::Leaving)),
        (SURFACE, Parts::ALL.without(Part::BoundaryComponents)),
    ] {
        let form = Form::new(claims, parts);
        for map in Census::new(Scope::Subdivisions { edges: 3, vertices: 2 }) {
            let before = projected(&Table::copy_of(map.runner.subject()).unwrap(), &form);
            let baseline = Baseline::new(&before, &claims).unwrap();
            try_every_op(&map.runner, |_, outcome, changed| {
                if outcome != StepOutcome::Applied {
                    return;
                }
                let after = projected(&Table::copy_of(changed.subject()).unwrap(), &form);
                for _ in 0..8 {
                    let some = Table {
                        parts: form.parts,
                        vertices: mixed(&before.vertices, &after.vertices, &mut coin),
                        half_edges: mixed(&before.half_edges, &after.half_edges, &mut coin),
                        boundaries: mixed(&before.boundaries, &after.boundaries, &mut coin),
                        faces: mixed(&before.faces, &after.faces, &mut coin),
                    };
                    judged += 1;
                    right += usize::from(judge(&baseline, &some, &difference(&before, &some)));
                }
            });
        }
    }
    assert!(judged > 20_000 && right > 1_000, "{judged} results, of which {right} are right");
}

/// One baseline follows each operator, and then equals a new one.
#[test]
fn a_baseline_follows_every_operator_on_every_small_map() {
    for (claims, parts) in [
        (PLANE, Parts::ALL),
        (PLANE, Parts::ALL.without(Part::Prev).without(Part::Leaving)),
        (PLANE, Parts::ALL.without(Part::Faces)),
        (PLANE, Parts::NONE),
        (SURFACE, Parts::ALL),
        (SURFACE, Parts::ALL.without(Part::BoundaryComponents)),
    ] {
        let form = Form::new(claims, parts);
        for map in Census::new(Scope::Subdivisions { edges: 3, vertices: 2 }) {
            let whole = Table::copy_of(map.runner.subject()).unwrap();
            let before = projected(&whole, &form);
            let baseline = Baseline::new(&before, &claims).unwrap();
            try_every_op(&map.runner, |op, _, changed| {
                let after = projected(&Table::copy_of(changed.subject()).unwrap(), &form);
                let mut followed = baseline.clone();
                let written = difference(&before, &after);
                validate_near(&mut followed, &after, &written).unwrap();
                // Both lead to the same verdicts from here on, if the change is undone the same way.
                let fresh = Baseline::new(&after, &claims).unwrap();
                for mut baseline in [followed, fresh] {
                    validate_near(&mut baseline, &before, &written).unwrap();
                }
                assert_eq!(written.is_empty(), before == after, "{op:?}");
                let mut nothing = written;
                nothing.clear();
                assert!(nothing.is_empty());
            });
        }
    }
}

/// A ring of this many edges, with an isolated vertex and a ring of three in its face.
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

/// The amount of data read does not grow with the structure.
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
            let mut baseline = Baseline::new(&before, &PLANE).unwrap();
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
    let of = |claims, parts| Baseline::new(&projected(&table, &Form::new(claims, parts)), &claims);
    assert!(matches!(of(PLANE.open(), Parts::ALL), Err(BaselineError::OpenBoundaries)));
    for part in [Part::BoundaryComponents, Part::Places, Part::UnboundedFace] {
        assert!(matches!(of(PLANE, Parts::ALL.without(part)), Err(BaselineError::Lacks(lacks)) if lacks == part));
    }
    let told = BaselineError::OpenBoundaries.to_string();
    assert_eq!(told, "open boundaries are not validated locally: use `validate`");
    let mut broken = table;
    broken.half_edges.iter_mut().flatten().next().unwrap().next = Some(0);
    let Err(BaselineError::Invalid(report)) = Baseline::new(&broken, &PLANE) else { panic!() };
    assert_eq!(*report, validate(&broken, &PLANE, Collect::All));
}

/// A face that was added and removed within one change, with all its records.
#[test]
fn what_came_and_went_is_vacant() {
    let mut dcel = ring(5_000);
    let mut baseline = Baseline::new(&dcel, &PLANE).unwrap();
    let before = Table::copy_of(&dcel).unwrap();
    let h = dcel.half_edges().next().unwrap();
    let (from, to) = (Corner::At(h.key()), Corner::At(h.next().next().key()));
    let connected = dcel.connect(from, to, Split::default()).unwrap().half_edge;
    let between = Table::copy_of(&dcel).unwrap();
    dcel.remove_edge(connected).unwrap();
    let after = Table::copy_of(&dcel).unwrap();
    let (mut written, back) = (difference(&before, &between), difference(&between, &after));
    written.half_edges.extend(back.half_edges);
    written.vertices.extend(back.vertices);
    written.boundaries.extend(back.boundaries);
    written.faces.extend(back.faces);
    written.listed.extend(back.listed);
    let watched = Watched::new(&after);
    validate_near(&mut baseline, &watched, &written).unwrap();
    assert!(watched.twin.get() < 100, "{}", watched.twin.get());
}

/// A baseline that missed records is incorrect. Still nothing loops or panics, and faults of the structure are found if they
/// are named.
#[test]
fn a_baseline_that_missed_something_ends() {
    for mut table in small_maps(2, 2) {
        let right = Baseline::new(&table, &PLANE).unwrap();
        let everything = difference(&Table::default(), &table);
        let before = table.clone();
        for_each_corruption(&mut table, Parts::ALL, |corrupt, cell, _| {
            let mut baseline = right.clone();
            let mut written = everything.clone();
            note(&mut written, cell);
            // It sees no change, and then is given unchanged records.
            assert!(validate_near(&mut baseline, corrupt, &WriteSet::default()).is_ok());
            let found = validate_near(&mut baseline, corrupt, &written);
            let report = validate(corrupt, &PLANE, Collect::First);
            assert!(found.is_err() || report.broken_rules().all(|rule| rule > Rule::F2), "{corrupt}");
            assert!(validate_near(&mut baseline, &before, &written).is_ok());
        });
    }
}

/// A valid structure is accepted although changed records were not named, and followed from there.
#[test]
fn forgotten_records_are_caught_up_with() {
    let mut dcel = ring(5);
    let mut baseline = Baseline::new(&dcel, &PLANE).unwrap();
    let h = dcel.half_edges().next().unwrap().key();
    // Nothing is named, so nothing is read or found.
    dcel.split_edge(h).unwrap();
    validate_near(&mut baseline, &dcel, &WriteSet::default()).unwrap();
    let before = Table::copy_of(&dcel).unwrap();
    dcel.split_edge(h).unwrap();
    let some =
        WriteSet { vertices: difference(&before, &Table::copy_of(&dcel).unwrap()).vertices, ..WriteSet::default() };
    validate_near(&mut baseline, &dcel, &some).unwrap();
    let before = Table::copy_of(&dcel).unwrap();
    dcel.split_edge(h).unwrap();
    let after = Table::copy_of(&dcel).unwrap();
    let watched = Watched::new(&after);
    validate_near(&mut baseline, &watched, &difference(&before, &after)).unwrap();
    assert!(watched.twin.get() < 100);
}

/// Failing to follow a change would be a false alarm, followed by a full validation.
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
    let split_next: Change = |dcel| {
        let h = first(dcel).next().key();
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
    for parts in [Parts::ALL, Parts::ALL.without(Part::Prev)] {
        let mut dcel = ring(5_000);
        let read = |dcel: &Dcel| projected(&Table::copy_of(dcel).unwrap(), &Form::new(PLANE, parts));
        let mut before = read(&dcel);
        let mut baseline = Baseline::new(&before, &PLANE).unwrap();
        let first = [split, split, split_next, add, add, add, drop_first, bridge, drop_first];
        for change in first.into_iter().chain([join, split, split_next, bridge, add, join]) {
            change(&mut dcel);
            let after = read(&dcel);
            let watched = Watched::new(&after);
            validate_near(&mut baseline, &watched, &difference(&before, &after)).unwrap();
            assert!(watched.twin.get() < 200 && watched.inner.get() < 200, "{}", watched.twin.get());
            before = after;
        }
    }
}
