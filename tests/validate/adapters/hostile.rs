//! Structures that answer for missing records, that change, or that claim too much.

use super::{MESH, as_targets, fan, maps, mirrored};
use crate::support::erased::validate;
use crate::support::inconsistent::Inconsistent;
use crate::support::nested::{PLANE, nested_textbook};
use crate::support::only_live::OnlyLive;
use crate::support::tables::{TEXTBOOK, Without};
use twinedge::validate::adapt::{Borders, FaceLabels};
use twinedge::validate::{Collect, Expectation, HalfEdgeRow, Link, Only, Part, Parts, Table, View};
use twinedge::{delegate_view, view_answers};

/// A table with a tombstone before each half-edge: a dead half-edge with the answers of the live one.
struct WithTombstones(Table);

impl View for WithTombstones {
    delegate_view!(|this| &this.0; except half_edge_slots, is_half_edge, origin, twin, next, prev, face, leaving, outer_half_edge);
    fn half_edge_slots(&self) -> usize {
        2 * self.0.half_edge_slots()
    }
    fn is_half_edge(&self, h: usize) -> bool {
        h % 2 == 1 && self.0.is_half_edge(h / 2)
    }
    fn origin(&self, h: usize) -> Link {
        self.0.origin(h / 2)
    }
    fn twin(&self, h: usize) -> Link {
        self.0.twin(h / 2).map(|twin| 2 * twin + 1)
    }
    fn next(&self, h: usize) -> Link {
        self.0.next(h / 2).map(|next| 2 * next + 1)
    }
    fn prev(&self, h: usize) -> Link {
        self.0.prev(h / 2).map(|prev| 2 * prev + 1)
    }
    fn face(&self, h: usize) -> Link {
        self.0.face(h / 2)
    }
    fn leaving(&self, v: usize) -> Link {
        self.0.leaving(v).map(|h| 2 * h + 1)
    }
    fn outer_half_edge(&self, f: usize) -> Link {
        self.0.outer_half_edge(f).map(|h| 2 * h + 1)
    }
}

/// Answers for deleted half-edges are ignored.
#[test]
fn adapters_do_not_read_tombstones() {
    let judge = |view: &dyn View, expectation: &Expectation| {
        let report = validate(view, expectation, Collect::All);
        assert!(report.is_valid(), "{report}");
    };
    for (table, expectation) in maps() {
        judge(&as_targets(&WithTombstones(mirrored(&table))).unwrap(), &expectation);
        judge(&FaceLabels::one_cycle(WithTombstones(table)).unwrap(), &expectation);
    }
    judge(&Borders::of(WithTombstones(fan().without(Part::Leaving))).unwrap(), &MESH.open());
    let mut nested = nested_textbook().without(Part::Leaving);
    nested.vertices.pop();
    nested.faces[1].as_mut().unwrap().inner_starts.pop();
    judge(&FaceLabels::with_holes(WithTombstones(nested), Some(0)).unwrap(), &PLANE);
}

/// A link to a vacant or missing slot is an ordinary answer: the slot's contents are never read.
#[test]
fn adapters_ask_no_vacant_slot() {
    let links: [fn(&mut HalfEdgeRow) -> &mut Link; 3] = [|row| &mut row.twin, |row| &mut row.next, |row| &mut row.prev];
    for (table, expectation) in maps().into_iter().chain([(nested_textbook(), PLANE), (fan(), MESH.open())]) {
        let beyond = table.half_edges.len();
        for (h, link, slots) in
            (0..beyond).flat_map(|h| links.map(|link| [(h, link, beyond), (h, link, beyond + 1)])).flatten()
        {
            let mut to_vacant = table.clone();
            let Some(row) = &mut to_vacant.half_edges[h] else { continue };
            *link(row) = Some(beyond);
            to_vacant.half_edges.resize(slots, None);
            let view = OnlyLive(&to_vacant);
            let judge = |view: &dyn View| assert!(!validate(view, &expectation, Collect::All).is_valid());
            judge(&as_targets(&view).unwrap());
            judge(&Borders::of(&view).unwrap());
            judge(&FaceLabels::one_cycle(&view).unwrap());
            judge(&FaceLabels::with_holes(&view, None).unwrap());
        }
    }
}

/// No answers, even dangling or changing ones, make an adapter panic, loop, or ask about missing slots.
#[test]
fn adapters_are_total() {
    let all = |view: &dyn Fn() -> Box<dyn View>| {
        let read = view();
        let mut adapted: Vec<Option<Box<dyn View>>> = vec![
            as_targets(&read).map(|view| Box::new(view) as _),
            Borders::of(view()).map(|view| Box::new(view) as _),
            FaceLabels::one_cycle(view()).map(|view| Box::new(view) as _),
        ];
        adapted.extend(
            [None, Some(0), Some(2), Some(usize::MAX)]
                .map(|unbounded| FaceLabels::with_holes(view(), unbounded).map(|view| Box::new(view) as _)),
        );
        for view in adapted.into_iter().flatten() {
            for expectation in [MESH, MESH.open(), PLANE, PLANE.open()] {
                for parts in [TEXTBOOK, Parts::NONE.with(Part::Prev)] {
                    validate(&Only::new(&view, parts), &expectation, Collect::All);
                }
            }
        }
    };
    for (table, _) in maps().into_iter().chain([(nested_textbook(), PLANE), (fan(), MESH)]) {
        let table: &'static Table = Box::leak(Box::new(table));
        for consistent in (0..200).chain([u64::MAX]) {
            all(&|| Box::new(Inconsistent::new(table, consistent, consistent)));
        }
    }
}

/// A table that claims one half-edge fewer on every call, down to none.
struct Shrinking<'a>(&'a Table, std::cell::Cell<usize>);

impl View for Shrinking<'_> {
    delegate_view!(|this| this.0; except half_edge_slots, face_slots);
    fn half_edge_slots(&self) -> usize {
        self.1.set(self.1.get().saturating_sub(1));
        self.1.get()
    }
    fn face_slots(&self) -> usize {
        self.half_edge_slots().min(self.0.face_slots())
    }
}

#[test]
fn a_structure_that_shrinks_makes_no_adapter_panic() {
    for (table, expectation) in maps() {
        for claimed in 1..40 {
            let view = || Shrinking(&table, std::cell::Cell::new(claimed.min(table.half_edges.len() + 1)));
            let judge = |view: &dyn View| drop(validate(&view, &expectation, Collect::All));
            judge(&as_targets(&view()).unwrap());
            judge(&Borders::of(view()).unwrap());
            judge(&FaceLabels::one_cycle(view()).unwrap());
            judge(&FaceLabels::with_holes(view(), Some(0)).unwrap());
        }
    }
}

/// A structure that claims more records than 32-bit numbers gets no adapter.
#[test]
fn a_claim_of_too_many_records_makes_no_adapter() {
    struct Claims([usize; 3]);
    impl View for Claims {
        view_answers! { |claims|
            parts => Parts::NONE.with(Part::Faces),
            vertex_slots => claims.0[0],
            half_edge_slots => claims.0[1],
            face_slots => claims.0[2],
            origin(_h) => None,
            twin(_h) => None,
            next(_h) => None,
        }
    }
    for claimed in [usize::MAX, u32::MAX as usize] {
        assert!(as_targets(&Claims([0, claimed, 0])).is_none());
        assert!(Borders::of(Claims([0, claimed, 0])).is_none());
        for claims in [[0, claimed, 0], [0, 0, claimed]] {
            assert!(FaceLabels::one_cycle(Claims(claims)).is_none());
            assert!(FaceLabels::with_holes(Claims(claims), None).is_none());
        }
    }
}
