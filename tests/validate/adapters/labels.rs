//! Lists of faces derived from the faces of half-edges.

use super::MESH;
use crate::support::erased::{first_broken_rule, validate};
use crate::support::nested::{PLANE, nested_textbook};
use crate::support::opinions::agree;
use crate::support::tables::{TETRAHEDRON, Without, half_edge, textbook_map, textbook_mesh};
use std::collections::BTreeSet;
use twinedge::validate::adapt::FaceLabels;
use twinedge::validate::{Collect, Link, Part, Rule, Start, Table, View};

/// A face named by two cycles, and a face named by none.
#[test]
fn labels_alone_show_faces_that_are_not_one_cycle() {
    let mut table = textbook_mesh(4, &TETRAHEDRON);
    let judge = |table: &Table| {
        let mut bare = table.clone();
        bare.faces.iter_mut().flatten().for_each(|row| row.outer_half_edge = None);
        let view = FaceLabels::one_cycle(&bare).unwrap();
        for f in 0..bare.faces.len() {
            let first = (0..bare.half_edges.len()).find(|h| bare.face(*h) == Some(f));
            assert_eq!(view.outer_half_edge(f), first);
        }
        let report = validate(&view, &MESH, Collect::All);
        assert_eq!(first_broken_rule(&view, &MESH), report.broken_rules().next());
        report.broken_rules().collect::<Vec<_>>()
    };
    assert_eq!(judge(&table), []);
    for row in table.half_edges.iter_mut().flatten().filter(|row| row.face == Some(3)) {
        row.face = Some(2);
    }
    assert_eq!(judge(&table), [Rule::F1, Rule::F2]);
    table.faces.pop();
    assert_eq!(judge(&table), [Rule::F2]);
}

/// The lists of a map follow from its labels, up to their order and the representatives of cycles.
#[test]
fn holes_follow_from_labels() {
    let mut table = nested_textbook();
    // Derived lists never contain the isolated vertex.
    table.vertices.pop();
    table.faces[1].as_mut().unwrap().inner_starts.pop();
    assert_eq!(agree(&table, PLANE), None);
    let view = FaceLabels::with_holes(&table, Some(0)).unwrap();
    let listed =
        |f: usize| (view.outer_half_edge(f), (0..view.inner_count(f)).map(|i| view.inner_start(f, i)).collect());
    let hole = |h: usize| vec![Some(Start::HalfEdge(h))];
    assert_eq!([0, 1, 2].map(listed), [(None, hole(1)), (Some(0), hole(7)), (Some(6), vec![])]);
    assert_eq!(first_broken_rule(&view, &PLANE), None);
    let isolated = FaceLabels::with_holes(nested_textbook(), Some(0)).unwrap();
    assert_eq!(first_broken_rule(&isolated, &PLANE), Some(Rule::B2));
    assert_eq!((view.inner_count(3), view.inner_count(usize::MAX), view.inner_start(0, 9)), (0, 0, None));
}

/// Returns the number of nodes connected to the first by these edges.
fn reached(edges: &[(usize, usize)]) -> usize {
    let mut reached = BTreeSet::from([0]);
    while let Some((a, b)) = edges.iter().find(|(a, b)| reached.contains(a) != reached.contains(b)) {
        reached.extend([*a, *b]);
    }
    reached.len()
}

/// Every label of every cycle of three separate loops, with every unbounded face, or none. Labels join faces and components; a
/// map is a tree rooted at the unbounded face.
#[test]
fn labels_that_cannot_nest_are_refused() {
    let half_edges: Vec<(usize, usize)> = (0..6).map(|h| (h / 2, h)).collect();
    let loops = textbook_map(3, &half_edges, &[(None, &[]), (None, &[]), (None, &[]), (None, &[])]);
    let loops = loops.without(Part::Leaving);
    let mut accepted = [0, 0];
    for labels in 0..4_usize.pow(6) {
        let label = |h: usize| labels / 4_usize.pow(h as u32) % 4;
        let mut table = loops.clone();
        for h in 0..6 {
            half_edge(&mut table, h).face = Some(label(h));
        }
        let edges: Vec<(usize, usize)> = (0..6).map(|h| (h / 2, 3 + label(h))).collect();
        // Components 0 … 2 and faces 3 … 6: a tree of 7 nodes has 6 edges, and is connected.
        let is_tree = reached(&edges) == 7;
        let judge = |unbounded: Link| {
            let view = FaceLabels::with_holes(&table, unbounded).unwrap();
            // All cycles of the unbounded face are inner.
            assert_eq!(unbounded.and_then(|f| view.outer_half_edge(f)), None);
            let report = validate(&view, &PLANE, Collect::AtMost(0));
            assert_eq!(report.broken_rules().next(), first_broken_rule(&view, &PLANE));
            report.is_valid()
        };
        for f in 0..4 {
            assert_eq!(judge(Some(f)), is_tree, "{edges:?} {f}");
        }
        accepted[0] += usize::from(is_tree);
        // Without a record of the unbounded face, the root is a component.
        assert_eq!(judge(None), is_tree);
        // If one half-edge is outside everything, or missing, the three other faces are bounded.
        table.faces.pop();
        for outside in [1, 3, 5] {
            let labels_live = (0..6).all(|h| h == outside || label(h) < 3);
            let edges: Vec<(usize, usize)> = (0..6).filter(|h| *h != outside).map(|h| (h / 2, 3 + label(h))).collect();
            let is_tree = labels_live && reached(&edges) == 6;
            let mut table = table.clone();
            half_edge(&mut table, outside).face = None;
            let mut without = table.clone();
            without.half_edges[outside] = None;
            half_edge(&mut without, outside ^ 1).twin = None;
            for table in [table, without] {
                let view = FaceLabels::with_holes(&table, None).unwrap();
                let report = validate(&view, &PLANE.open(), Collect::AtMost(0));
                assert_eq!(report.broken_rules().next(), first_broken_rule(&view, &PLANE.open()));
                assert_eq!(report.is_valid(), is_tree, "{edges:?}\n{report}");
                // The component at the border lies in no face.
                let inside = outside ^ 1;
                assert!(!is_tree || view.outer_half_edge(label(inside)) == Some(inside), "{edges:?}");
                accepted[1] += usize::from(is_tree);
            }
        }
    }
    // A component joins two faces. By Cayley there are 4² trees on four faces, and 3! · 2³ ways to name and orient their edges.
    assert_eq!(accepted[0], 16 * 6 * 8);
    assert!(accepted[1] > 0);
}
