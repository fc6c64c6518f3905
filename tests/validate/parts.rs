//! Sets of parts: closed under dependencies, and other parts are ignored. The forms of structures are such sets.

use crate::support::erased::validate;
use crate::support::small::small_maps;
use std::collections::BTreeSet;
use twinedge::validate::{Collect, Expectation, FaceRow, Only, Part, Parts, Table};
use twinedge_trials::forms::{forms, projected, projections};

/// The parts that this one depends on.
fn needs(part: Part) -> &'static [Part] {
    match part {
        Part::BoundaryComponents | Part::Holes => &[Part::Faces],
        Part::Places => &[Part::Faces, Part::BoundaryComponents],
        Part::UnboundedFace => &[Part::Faces, Part::Holes],
        _ => &[],
    }
}

/// All 128 sets of parts, regardless of dependencies.
fn all_sets() -> impl Iterator<Item = BTreeSet<Part>> {
    (0..1_u32 << Part::ALL.len())
        .map(|bits| Part::ALL.into_iter().filter(|part| bits >> *part as u32 & 1 == 1).collect())
}

/// Each closed set, once.
fn closed_sets() -> Vec<Parts> {
    let is_closed = |set: &BTreeSet<Part>| set.iter().all(|part| needs(*part).iter().all(|other| set.contains(other)));
    all_sets().filter(is_closed).map(|set| set.into_iter().collect()).collect()
}

fn of(parts: Parts) -> BTreeSet<Part> {
    parts.iter().collect()
}

#[test]
fn a_part_comes_with_those_on_which_it_depends() {
    let mut found = BTreeSet::new();
    for set in all_sets() {
        let parts: Parts = set.iter().copied().collect();
        let expected: BTreeSet<Part> = set.iter().flat_map(|part| needs(*part).iter().chain([part])).copied().collect();
        assert_eq!(of(parts), expected);
        assert!(parts.iter().is_sorted(), "in the order of `Part::ALL`");
        assert!(Part::ALL.into_iter().all(|part| parts.has(part) == expected.contains(&part)));
        assert_eq!(parts.iter().collect::<Parts>(), parts);
        assert_eq!(format!("{parts:?}"), format!("{expected:?}"));
        found.insert(expected);
    }
    // With and without prev and leaving; no faces, or three ways to store boundary components, times three to store
    // holes.
    assert_eq!(found.len(), 2 * 2 * (1 + 3 * 3));
    assert_eq!((of(Parts::NONE).len(), of(Parts::ALL), Parts::default()), (0, Part::ALL.into(), Parts::ALL));
}

#[test]
fn a_part_goes_with_those_that_depend_on_it() {
    for parts in closed_sets() {
        for part in Part::ALL {
            let (with, without) = (parts.with(part), parts.without(part));
            let mut expected = of(parts);
            expected.retain(|other| *other != part && !needs(*other).contains(&part));
            assert_eq!(of(without), expected);
            let mut expected = of(parts);
            expected.extend(needs(part).iter().chain([&part]));
            assert_eq!(of(with), expected);
            // Repeating changes nothing, and one undoes the other for the part itself.
            assert_eq!((with.with(part), without.without(part)), (with, without));
            assert_eq!(with.without(part).intersection(parts), without);
            assert_eq!((parts.has(part), parts.has(part)), (with == parts, without != parts));
            assert_eq!(without.with(part).intersection(with), without.with(part));
        }
    }
}

#[test]
fn the_order_in_which_parts_come_and_go_makes_no_difference() {
    let sets = closed_sets();
    for parts in &sets {
        for (one, other) in Part::ALL.into_iter().flat_map(|one| Part::ALL.map(|other| (one, other))) {
            assert_eq!(parts.with(one).with(other), parts.with(other).with(one));
            assert_eq!(parts.without(one).without(other), parts.without(other).without(one));
        }
        for other in &sets {
            let both = parts.intersection(*other);
            assert_eq!((of(both), both), (&of(*parts) & &of(*other), other.intersection(*parts)));
            assert!(sets.contains(&both), "{both:?} is not closed");
        }
    }
}

#[test]
fn each_part_has_a_word_and_a_name_of_its_own() {
    for part in Part::ALL {
        assert_eq!(Part::from_word(part.word()), Some(part));
        assert!(part.word().bytes().all(|byte| byte.is_ascii_lowercase() || byte == b'_'));
    }
    assert_eq!(Part::ALL.map(Part::name).into_iter().collect::<BTreeSet<_>>().len(), Part::ALL.len());
    for word in ["", "Prev", "prev ", "unbounded face", "holes holes"] {
        assert_eq!(Part::from_word(word), None);
    }
}

/// The table with nil in every column of a missing part.
fn erased(table: &Table, parts: Parts) -> Table {
    let mut table = Table { parts, ..table.clone() };
    let lacks = |part| !parts.has(part);
    for row in table.half_edges.iter_mut().flatten() {
        row.prev = row.prev.filter(|_| !lacks(Part::Prev));
        row.boundary = row.boundary.filter(|_| !lacks(Part::BoundaryComponents));
        row.face = row.face.filter(|_| !lacks(Part::Faces));
    }
    for row in table.vertices.iter_mut().flatten() {
        row.leaving = row.leaving.filter(|_| !lacks(Part::Leaving));
        row.isolated = row.isolated.filter(|_| !lacks(Part::BoundaryComponents) && !lacks(Part::Holes));
    }
    for row in table.boundaries.iter_mut().flatten() {
        row.place = row.place.filter(|_| !lacks(Part::Places));
    }
    for row in table.faces.iter_mut().flatten() {
        row.outer = row.outer.filter(|_| !lacks(Part::BoundaryComponents));
        if lacks(Part::BoundaryComponents) {
            row.inner.fill(None);
        }
        if lacks(Part::Holes) {
            row.inner.clear();
            row.inner_starts.clear();
        }
    }
    if lacks(Part::BoundaryComponents) {
        table.boundaries.clear();
    }
    if lacks(Part::Faces) {
        table.faces.clear();
    }
    table
}

/// The maps are valid without the part, or invalid.
#[test]
fn what_is_not_looked_at_might_as_well_not_be_there() {
    let (mut right, mut wrong) = (0, 0);
    let sets = closed_sets();
    for whole in small_maps(2, 3) {
        for form in forms() {
            let table = projected(&whole, &form);
            for parts in &sets {
                let looked_at = form.parts.intersection(*parts);
                let only = validate(&Only::new(&table, *parts), &form.expectation, Collect::All);
                let report = validate(&erased(&table, looked_at), &form.expectation, Collect::All);
                assert_eq!(only, report, "{table}\n{form:?}\n{parts:?}\n{only}\n{report}");
                *if report.is_valid() { &mut right } else { &mut wrong } += 1;
            }
        }
    }
    assert!(right > 10_000 && wrong > 10_000, "{right} {wrong}");
}

#[test]
fn there_are_112_forms() {
    let all = forms();
    // The parts of the faces: none, or three ways to store boundary components, times three to store holes and the
    // unbounded face; surfaces have neither. Then prev and leaving, and open boundaries.
    let of_the_plane = 2 * 4 * (1 + 3 * 3);
    let of_surfaces = 2 * 4 * (1 + 3);
    assert_eq!(all.len(), of_the_plane + of_surfaces);
    assert_eq!(all.len(), 112);
    for (i, one) in all.iter().enumerate() {
        assert!(!all[..i].contains(one), "{one:?} is there twice");
    }
    let surfaces = all.iter().filter(|one| one.expectation.surface_kind() == Expectation::surface().surface_kind());
    assert_eq!(surfaces.count(), of_surfaces);
}

/// A part missing in a form is nil, so a validator that reads it would fail.
#[test]
fn what_is_left_out_is_nil() {
    for table in small_maps(2, 3) {
        for form in forms() {
            for projection in projections(&table, &form) {
                let lacks = |part| !form.parts.has(part);
                assert_eq!(projection.parts, form.parts);
                let half_edges = || projection.half_edges.iter().flatten();
                let vertices = || projection.vertices.iter().flatten();
                assert!(!lacks(Part::Prev) || half_edges().all(|row| row.prev.is_none()));
                assert!(!lacks(Part::Leaving) || vertices().all(|row| row.leaving.is_none()));
                assert!(!lacks(Part::Faces) || half_edges().all(|row| row.face.is_none()));
                assert!(!lacks(Part::BoundaryComponents) || half_edges().all(|row| row.boundary.is_none()));
                assert!(!lacks(Part::BoundaryComponents) || projection.boundaries.iter().flatten().count() == 0);
                assert!(!lacks(Part::Places) || projection.boundaries.iter().flatten().all(|row| row.place.is_none()));
                let faces = || projection.faces.iter().flatten();
                assert!(!lacks(Part::Faces) || faces().count() == 0);
                assert!(!lacks(Part::Holes) || faces().all(|row| row.inner.is_empty() && row.inner_starts.is_empty()));
                let bounded = |row: &FaceRow| row.outer.is_some() || row.outer_half_edge.is_some();
                assert!(!lacks(Part::UnboundedFace) || faces().all(bounded));
            }
        }
    }
}
