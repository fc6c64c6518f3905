//! Structures that store targets.

use super::{as_targets, maps, mirrored};
use crate::support::erased::{first_broken_rule, validate};
use crate::support::opinions::agree;
use crate::support::tables::half_edge;
use std::collections::BTreeSet;
use twinedge::validate::{Collect, Link, Table, View};
use twinedge_trials::enumerate::for_each_corruption;

/// A structure with targets is valid if and only if its mirror image, without derived links, is: for each change of one link,
/// and of two if origins are involved.
#[test]
fn targets_are_judged_as_their_mirror_image() {
    for (table, expectation) in maps() {
        let table = mirrored(&table);
        assert_eq!(agree(&mirrored(&table), expectation), None);
        let same = |changed: &Table| {
            let verdict = first_broken_rule(&mirrored(changed), &expectation).is_none();
            let view = as_targets(changed).unwrap();
            let report = validate(&view, &expectation, Collect::All);
            assert_eq!(report.is_valid(), verdict, "{changed}\n{report}");
            assert_eq!(first_broken_rule(&view, &expectation), report.broken_rules().next());
            verdict
        };
        let mut caught = 0;
        for_each_corruption(&mut table.clone(), table.parts, |changed, _, _| caught += usize::from(!same(changed)));
        assert!(caught > 50);
        let n = table.half_edges.len();
        for (g, h) in (0..n).flat_map(|g| (0..g).map(move |h| (g, h))) {
            if table.half_edges[g].is_none() || table.half_edges[h].is_none() {
                continue;
            }
            for (u, v) in (0..4).map(|i| (i % 2, i / 2)) {
                let mut changed = table.clone();
                (half_edge(&mut changed, g).origin, half_edge(&mut changed, h).origin) = (Some(u), Some(v));
                same(&changed);
            }
        }
    }
}

/// Even at a border, each target is the origin of exactly one half-edge.
#[test]
fn each_target_is_read_once() {
    for (table, _) in maps() {
        let live: Vec<usize> = (0..table.half_edges.len()).filter(|h| table.is_half_edge(*h)).collect();
        let mirrored = mirrored(&table);
        let targets = as_targets(&mirrored).unwrap();
        let from: BTreeSet<Link> = live.iter().map(|h| targets.origin_from(*h)).collect();
        assert_eq!(from, live.iter().copied().map(Some).collect());
    }
    let nothing = Table::default();
    let nothing = as_targets(&nothing).unwrap();
    assert_eq!((nothing.origin_from(0), nothing.origin_from(usize::MAX), nothing.origin(3)), (None, None, None));
}

/// Of two half-edges with the same `next`, the first is taken for the one before it.
#[test]
fn of_two_with_one_next_the_first_is_before() {
    let [_, (table, _), _] = maps();
    let bare = |h: &usize| table.is_half_edge(*h) && table.twin(*h).is_none();
    let bare: Vec<usize> = (0..table.half_edges.len()).filter(bare).collect();
    let mut tried = 0;
    for (g, h) in bare.iter().flat_map(|g| bare.iter().map(move |h| (*g, *h))).filter(|(g, h)| g != h) {
        let next = table.next(g).unwrap();
        if bare.contains(&next) {
            let mut changed = table.clone();
            half_edge(&mut changed, h).next = Some(next);
            assert_eq!(as_targets(&changed).unwrap().origin_from(next), Some(g.min(h)));
            tried += 1;
        }
    }
    assert!(tried > 0);
}
