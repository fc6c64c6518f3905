//! Equality: structures are equal if and only if they have the same records under the same keys, with the same links and lists.

use crate::support::saved::each_change;
use crate::support::tracked::Keys;
use serde_json::{from_value, to_value};
use std::collections::BTreeSet;
use twinedge::dcel::{Boundary, Dcel, Split};
use twinedge::program::{Op, Runner, StepOutcome, try_every_op};
use twinedge::validate::Table;
use twinedge_trials::census::{Census, Scope};

fn maps() -> impl Iterator<Item = Runner<Dcel>> {
    Census::new(Scope::Subdivisions { edges: 2, vertices: 3 }).map(|map| map.runner)
}

/// A refused operator leaves the structure equal, and an applied one does not, except for moving a boundary component to its own face
/// and turning a loop around nothing.
#[test]
fn every_operator_on_every_small_map_makes_a_difference_if_it_is_applied() {
    let (mut applied, mut refused, mut stays) = (0, 0, 0);
    for runner in maps() {
        let before = runner.subject();
        let facts = |map: &Dcel| (Keys::of(map), Table::copy_of(map));
        let facts_before = facts(before);
        assert_eq!(*before, before.clone());
        try_every_op(&runner, |op, outcome, after| {
            let differs = facts(after.subject()) != facts_before;
            assert_eq!((after.subject() != before, before != after.subject()), (differs, differs), "{op} {outcome:?}");
            let may_stay = matches!(op, Op::MoveInner { .. } | Op::FlipEdge { .. });
            match (outcome == StepOutcome::Applied, differs) {
                (true, true) => applied += 1,
                (false, false) => refused += 1,
                (true, false) if may_stay => stays += 1,
                _ => panic!("{op} {outcome:?}, {differs}"),
            }
        });
    }
    assert!(applied > 1000 && refused > 1000 && stays > 10, "{applied} {refused} {stays}");
}

/// Everything is saved: a change in one place is refused, or makes another structure. The generation of a vacant slot belongs to no
/// key.
#[test]
fn another_key_link_start_or_order_makes_a_difference() {
    let (mut others, mut same_keys) = (0, 0);
    for runner in maps() {
        let map = runner.subject();
        let saved = to_value(map).unwrap();
        each_change(&saved, |place, changed| {
            let Ok(other) = from_value::<Dcel>(changed) else { return };
            let is_same = place.starts_with("/generations") && Keys::of(&other) == Keys::of(map);
            assert_eq!(other == *map, is_same, "{place} of {saved}");
            *if is_same { &mut same_keys } else { &mut others } += 1;
        });
    }
    assert!(others > 100 && same_keys > 100, "{others} {same_keys}");
}

#[test]
fn the_order_of_a_list_makes_a_difference() {
    let mut map = Dcel::new();
    let outside = map.unbounded_face().key();
    let v = map.add_isolated_vertex(outside).unwrap().vertex;
    map.connect(v, v, Split::default()).unwrap();
    let vertices = [(); 3].map(|()| map.add_isolated_vertex(outside).unwrap().vertex);
    let inside = map.faces().find(|f| !f.is_unbounded()).unwrap().key();
    let order = |map: &Dcel| map.unbounded_face().inner().map(Boundary::key).collect::<Vec<_>>();
    let is_same = vertices.iter().map(|v| {
        let (mut moved, alone) = (map.clone(), map.at(*v).isolated().unwrap().key());
        moved.move_inner(alone, inside).unwrap();
        assert_ne!(moved, map);
        moved.move_inner(alone, outside).unwrap();
        // All links are unchanged, and perhaps the list.
        assert_eq!(moved == map, order(&moved) == order(&map));
        moved == map
    });
    assert_eq!(is_same.collect::<BTreeSet<_>>(), BTreeSet::from([false, true]));
}

#[test]
fn structures_made_apart_have_other_keys() {
    let map = Dcel::new();
    assert_eq!(map, map.clone());
    assert_ne!(map, Dcel::new());
}

#[test]
fn the_debug_form_is_one_short_line() {
    let runner = maps().max_by_key(|runner| runner.subject().half_edge_count()).unwrap();
    let map = runner.subject();
    let [v, e, b, f] = [map.vertex_count(), map.edge_count(), map.boundary_count(), map.face_count()];
    assert_eq!(format!("{map:?}"), format!("Dcel {{ vertices: {v}, edges: {e}, boundaries: {b}, faces: {f} }}"));
}
