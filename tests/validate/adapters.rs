//! The adapters of `validate::adapt`, and reports with the owner's names.

use crate::support::inconsistent::Inconsistent;
use crate::support::nested::nested_textbook;
use crate::support::opinions::agree;
use crate::support::tables::{half_edge, textbook_map, textbook_mesh, vertex};
use std::collections::BTreeSet;
use twinedge::delegate_view;
use twinedge::validate::adapt::{Backward, Borders, FaceLabels, Ids, Index, Targets};
use twinedge::validate::enumerate::{Cell, for_each_corruption};
use twinedge::validate::reference::first_broken_rule;
use twinedge::validate::{
    Collect, Expectation, HalfEdgeRow, Link, Part, Record, Rule, Start, Table, View, Violation, validate,
};

const BARE: Expectation = Expectation::plane().without(Part::Faces).without(Part::Leaving);
const MESH: Expectation = Expectation::surface().without(Part::BoundaryComponents);
const TEXTBOOK: Expectation = Expectation::plane().without(Part::BoundaryComponents);

/// A view whose origins are read as targets.
struct AsTargets<V>(V);

impl<V: View> View for AsTargets<V> {
    delegate_view!(|this| &this.0; except origin, target);
    fn origin(&self, _: usize) -> Link {
        None
    }
    fn target(&self, half_edge: usize) -> Link {
        self.0.origin(half_edge)
    }
}

/// The table seen from the other side: what was the origin is the target, and cycles run backwards.
fn mirrored(table: &Table) -> Table {
    let mut mirrored = table.clone();
    for row in mirrored.half_edges.iter_mut().flatten() {
        std::mem::swap(&mut row.next, &mut row.prev);
    }
    mirrored
}

/// A closed mesh, one with a border whose half-edges have no twins, and an edge with a loop at one end.
fn maps() -> [(Table, Expectation); 3] {
    let closed = textbook_mesh(4, &[[0, 1, 2], [0, 3, 1], [1, 3, 2], [0, 2, 3]]);
    let mut open = with_bare_border(5, &[[0, 1, 2], [0, 2, 3], [0, 3, 4]]);
    let borders: Vec<usize> = (0..open.half_edges.len()).filter(|h| half_edge(&mut open, *h).face.is_none()).collect();
    for h in borders {
        open.half_edges[h] = None;
        half_edge(&mut open, h ^ 1).twin = None;
    }
    let tadpole = textbook_map(2, &[(0, 2), (1, 0), (1, 1), (1, 3)], &[(Some(0), &[]), (Some(3), &[])]);
    let surface = MESH.without(Part::Leaving);
    [(closed, surface), (open, surface.open()), (tadpole, surface)]
}

/// A structure with targets is sound if and only if its mirror image, in which nothing is derived, is: for each change of each
/// link, and of two at once where origins are concerned.
#[test]
fn targets_are_judged_as_their_mirror_image() {
    for (table, expectation) in maps() {
        let table = mirrored(&table);
        assert_eq!(agree(&mirrored(&table), expectation), None);
        let same = |changed: &Table| {
            let verdict = first_broken_rule(&mirrored(changed), &expectation).is_none();
            let report = validate(&Targets::of(AsTargets(changed)).unwrap(), &expectation, Collect::All);
            assert_eq!(report.is_valid(), verdict, "{changed}\n{report}");
            assert_eq!(
                first_broken_rule(&Targets::of(AsTargets(changed)).unwrap(), &expectation),
                report.broken_rules().next()
            );
            verdict
        };
        let mut caught = 0;
        for_each_corruption(&mut table.clone(), &expectation, |changed, _, _| caught += usize::from(!same(changed)));
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

/// At a border, too, each target is the origin of exactly one half-edge.
#[test]
fn each_target_is_read_once() {
    for (table, _) in maps() {
        let live: Vec<usize> = (0..table.half_edges.len()).filter(|h| table.is_half_edge(*h)).collect();
        let targets = Targets::of(AsTargets(mirrored(&table))).unwrap();
        let from: BTreeSet<Link> = live.iter().map(|h| targets.origin_from(*h)).collect();
        assert_eq!(from, live.iter().copied().map(Some).collect());
    }
    let nothing = Targets::of(AsTargets(Table::default())).unwrap();
    assert_eq!((nothing.origin_from(0), nothing.origin_from(usize::MAX), nothing.origin(3)), (None, None, None));
}

/// `next` is not read, and where `prev` is changed it is no permutation. All else is as with both links.
#[test]
fn backward_links_are_judged_as_forward_ones() {
    for (table, expectation) in maps() {
        let mut caught = 0;
        for_each_corruption(&mut table.clone(), &expectation, |changed, cell, _| {
            let mut backward = changed.clone();
            backward.half_edges.iter_mut().flatten().for_each(|row| row.next = None);
            let view = Backward::of(&backward).unwrap();
            let report = validate(&view, &expectation, Collect::All);
            assert_eq!(report.broken_rules().next(), first_broken_rule(&view, &expectation));
            let verdict = match cell {
                Cell::Next(_) => true,
                Cell::Prev(_) => false,
                _ => first_broken_rule(changed, &expectation).is_none(),
            };
            assert_eq!(report.is_valid(), verdict, "{cell:?} {report}");
            caught += usize::from(!verdict);
        });
        assert!(caught > 50);
    }
}

/// A mesh of these triangles. Its border half-edges have twin and origin, and neither face nor next.
fn with_bare_border(vertices: usize, triangles: &[[usize; 3]]) -> Table {
    let mut table = textbook_mesh(vertices, triangles);
    for h in 0..table.half_edges.len() {
        if table.face(h).is_none() {
            let origin = table.next(h ^ 1).and_then(|next| table.origin(next));
            *half_edge(&mut table, h) = HalfEdgeRow { origin, twin: Some(h ^ 1), ..HalfEdgeRow::default() };
        }
    }
    for h in 0..table.half_edges.len() {
        half_edge(&mut table, h).prev = (0..table.half_edges.len()).find(|prev| table.next(*prev) == Some(h));
    }
    for v in 0..vertices {
        vertex(&mut table, v).leaving = (0..table.half_edges.len()).find(|h| table.origin(*h) == Some(v));
    }
    table
}

/// Three triangles around vertex 0, side by side.
fn fan() -> Table {
    with_bare_border(5, &[[0, 1, 2], [0, 2, 3], [0, 3, 4]])
}

#[test]
fn a_border_without_next_is_linked() {
    let table = fan();
    assert_eq!(agree(&table, MESH.open()), Some(Rule::R1));
    let linked = Borders::of(&table).unwrap();
    assert_eq!(first_broken_rule(&linked, &MESH.open()), None);
    let found = validate(&linked, &MESH.open(), Collect::All).into_result().unwrap();
    assert_eq!((found.cycles, found.edges, found.borders), (3, 7, 1));
    // Its other links are kept, and half-edges that are not there have none.
    for h in (0..14).filter(|h| table.half_edges[*h].unwrap().face.is_some()) {
        assert_eq!((linked.next(h), linked.prev(h)), (table.next(h), table.prev(h)));
    }
    assert_eq!((linked.next(99), linked.prev(usize::MAX)), (None, None));
}

/// Two triangles that share a vertex only: two borders, and the fans are not joined, so that V2 finds them.
#[test]
fn each_fan_has_a_border_of_its_own() {
    let table = with_bare_border(5, &[[0, 1, 2], [0, 3, 4]]);
    let report = validate(&Borders::of(&table).unwrap(), &MESH.open(), Collect::All);
    let Violation::SplitRotation { vertex, reached, degree, .. } = report.violations()[0] else { panic!("{report}") };
    assert_eq!((vertex, reached, degree, report.violations().len()), (0, 2, 4, 1));
}

/// A border is without next all along or not at all, and what is no border gets no next.
#[test]
fn a_border_with_one_next_is_refused() {
    let right = Table::copy_of(&Borders::of(&fan()).unwrap()).unwrap();
    assert_eq!(agree(&right, MESH.open()), None);
    let broken = |table: &Table| first_broken_rule(&Borders::of(table).unwrap(), &MESH.open());
    assert_eq!(broken(&right), None);
    for h in 0..14 {
        let mut mixed = fan();
        half_edge(&mut mixed, h).next = if fan().next(h).is_none() { right.next(h) } else { None };
        assert_eq!(broken(&mixed), Some(Rule::R1));
        // One of which the twin is gone, too.
        let mut single = fan();
        half_edge(&mut single, h).twin = None;
        assert!(broken(&single).is_some());
    }
}

/// A face that two cycles name, and one that nobody names.
#[test]
fn labels_alone_show_faces_that_are_not_one_cycle() {
    let mut table = textbook_mesh(4, &[[0, 1, 2], [0, 3, 1], [1, 3, 2], [0, 2, 3]]);
    let judge = |table: &Table| {
        let mut bare = table.clone();
        bare.faces.iter_mut().flatten().for_each(|row| row.outer_half_edge = None);
        let view = FaceLabels::one_cycle(&bare).unwrap();
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

/// The lists of a map follow from its labels, up to their order and the half-edges that stand for cycles.
#[test]
fn holes_follow_from_labels() {
    let mut table = nested_textbook();
    // The isolated vertex is in no list that can be derived.
    table.vertices.pop();
    table.faces[1].as_mut().unwrap().inner_starts.pop();
    assert_eq!(agree(&table, TEXTBOOK), None);
    let view = FaceLabels::with_holes(&table, Some(0)).unwrap();
    let listed =
        |f: usize| (view.outer_half_edge(f), (0..view.inner_count(f)).map(|i| view.inner_start(f, i)).collect());
    let hole = |h: usize| vec![Some(Start::HalfEdge(h))];
    assert_eq!([0, 1, 2].map(listed), [(None, hole(1)), (Some(0), hole(7)), (Some(6), vec![])]);
    assert_eq!(first_broken_rule(&view, &TEXTBOOK), None);
    let isolated = FaceLabels::with_holes(nested_textbook(), Some(0)).unwrap();
    assert_eq!(first_broken_rule(&isolated, &TEXTBOOK), Some(Rule::B2));
    assert_eq!((view.inner_count(3), view.inner_count(usize::MAX), view.inner_start(0, 9)), (0, 0, None));
}

/// Every label of every cycle of three loops side by side, and every unbounded face, or none. By the labels, faces and components
/// are joined; a map is a tree that hangs from the unbounded face.
#[test]
fn labels_that_cannot_nest_are_refused() {
    let half_edges: Vec<(usize, usize)> = (0..6).map(|h| (h / 2, h)).collect();
    let loops = textbook_map(3, &half_edges, &[(None, &[]), (None, &[]), (None, &[]), (None, &[])]);
    let mut accepted = [0, 0];
    for labels in 0..4_usize.pow(6) {
        let label = |h: usize| labels / 4_usize.pow(h as u32) % 4;
        let mut table = loops.clone();
        for h in 0..6 {
            half_edge(&mut table, h).face = Some(label(h));
        }
        let edges: Vec<(usize, usize)> = (0..6).map(|h| (h / 2, 3 + label(h))).collect();
        // Components 0 … 2 and faces 3 … 6: a tree of 7 nodes has 6 edges, and is connected.
        let mut reached = BTreeSet::from([0]);
        while let Some((a, b)) = edges.iter().find(|(a, b)| reached.contains(a) != reached.contains(b)) {
            reached.extend([*a, *b]);
        }
        let is_tree = reached.len() == 7;
        let expectation = TEXTBOOK.without(Part::Leaving);
        let judge = |unbounded: Link, expectation: Expectation| {
            let view = FaceLabels::with_holes(&table, unbounded).unwrap();
            let report = validate(&view, &expectation, Collect::AtMost(0));
            assert_eq!(report.broken_rules().next(), first_broken_rule(&view, &expectation));
            report.is_valid()
        };
        for f in 0..4 {
            assert_eq!(judge(Some(f), expectation), is_tree, "{edges:?} {f}");
        }
        accepted[0] += usize::from(is_tree);
        // Without a record of the unbounded face the tree hangs from a component.
        assert_eq!(judge(None, expectation.without(Part::UnboundedFace)), is_tree);
        // Where half-edge 1 is outside everything, the three other faces are bounded.
        half_edge(&mut table, 1).face = None;
        table.faces.pop();
        let labels_live = (0..6).all(|h| h == 1 || label(h) < 3);
        let edges: Vec<(usize, usize)> =
            edges.into_iter().enumerate().filter(|(h, _)| *h != 1).map(|(_, e)| e).collect();
        let mut reached = BTreeSet::from([0]);
        while let Some((a, b)) = edges.iter().find(|(a, b)| reached.contains(a) != reached.contains(b)) {
            reached.extend([*a, *b]);
        }
        let view = FaceLabels::with_holes(&table, None).unwrap();
        let expectation = expectation.without(Part::UnboundedFace).open();
        let report = validate(&view, &expectation, Collect::AtMost(0));
        assert_eq!(report.broken_rules().next(), first_broken_rule(&view, &expectation));
        assert_eq!(report.is_valid(), labels_live && reached.len() == 6, "{edges:?}\n{report}");
        accepted[1] += usize::from(report.is_valid());
    }
    // A component joins two faces. By Cayley there are 4² trees on four faces, and 3! · 2³ ways to name and turn their edges.
    assert_eq!(accepted[0], 16 * 6 * 8);
    assert!(accepted[1] > 0);
}

/// No answers, whether they dangle or change from call to call, make an adapter panic, loop, or ask about slots that are
/// not there.
#[test]
fn adapters_are_total() {
    let all = |view: &dyn Fn() -> Box<dyn View>| {
        let expectations = [MESH, MESH.open(), TEXTBOOK, TEXTBOOK.open(), BARE, BARE.open()];
        let mut adapted: Vec<Option<Box<dyn View>>> = vec![
            Targets::of(AsTargets(view())).map(|view| Box::new(view) as _),
            Borders::of(view()).map(|view| Box::new(view) as _),
            Backward::of(view()).map(|view| Box::new(view) as _),
            FaceLabels::one_cycle(view()).map(|view| Box::new(view) as _),
        ];
        adapted.extend(
            [None, Some(0), Some(2), Some(usize::MAX)]
                .map(|unbounded| FaceLabels::with_holes(view(), unbounded).map(|view| Box::new(view) as _)),
        );
        for view in adapted.into_iter().flatten() {
            for expectation in expectations {
                validate(&view, &expectation, Collect::All);
            }
        }
    };
    for (table, _) in maps().into_iter().chain([(nested_textbook(), TEXTBOOK), (fan(), MESH)]) {
        let table: &'static Table = Box::leak(Box::new(table));
        for consistent in (0..200).chain([u64::MAX]) {
            all(&|| Box::new(Inconsistent::new(table, consistent, consistent)));
        }
    }
}

/// A table that claims one half-edge less each time it is asked, until there is none.
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
            judge(&Targets::of(AsTargets(view())).unwrap());
            judge(&Borders::of(view()).unwrap());
            judge(&Backward::of(view()).unwrap());
            judge(&FaceLabels::one_cycle(view()).unwrap());
            judge(&FaceLabels::with_holes(view(), Some(0)).unwrap());
        }
    }
}

/// A claim of more records than 32 bits number makes no adapter.
#[test]
fn a_claim_of_too_many_records_makes_no_adapter() {
    struct Claims([usize; 3]);
    impl View for Claims {
        fn vertex_slots(&self) -> usize {
            self.0[0]
        }
        fn half_edge_slots(&self) -> usize {
            self.0[1]
        }
        fn face_slots(&self) -> usize {
            self.0[2]
        }
        fn origin(&self, _: usize) -> Link {
            None
        }
        fn twin(&self, _: usize) -> Link {
            None
        }
        fn next(&self, _: usize) -> Link {
            None
        }
    }
    for claimed in [usize::MAX, u32::MAX as usize] {
        assert!(Targets::of(Claims([0, claimed, 0])).is_none());
        assert!(Borders::of(Claims([0, claimed, 0])).is_none());
        assert!(Backward::of(Claims([0, claimed, 0])).is_none());
        for claims in [[0, claimed, 0], [0, 0, claimed]] {
            assert!(FaceLabels::one_cycle(Claims(claims)).is_none());
            assert!(FaceLabels::with_holes(Claims(claims), None).is_none());
        }
    }
}

#[test]
fn an_index_numbers_ids_in_their_order() {
    let index = Index::of(["c", "a", "b", "a"]);
    assert_eq!((index.len(), index.is_empty(), Index::<u8>::default().is_empty()), (4, false, true));
    assert_eq!(["a", "b", "c", "d", ""].map(|id| index.get(&id)), [Some(1), Some(2), Some(0), None, None]);
    assert_eq!([0, 1, 2, 3, 4].map(|i| index.id(i).copied()), [Some("c"), Some("a"), Some("b"), Some("a"), None]);
    assert_eq!([None, Some("b"), Some("z")].map(|id| index.link(id)), [None, Some(2), Some(usize::MAX)]);
    assert_eq!(index.follow(0, &index, |id| (*id == "c").then_some("b")), Some(2));
    assert_eq!(index.follow(1, &index, |id| (*id == "c").then_some("b")), None);
    assert_eq!(index.follow(9, &index, |_| Some("b")), None);
    assert_eq!((index.name(2), index.name(7)), ("\"b\"".to_owned(), "7".to_owned()));
}

#[test]
fn an_index_that_is_extended_keeps_its_numbers() {
    let mut index = Index::of(["c", "a", "a"]);
    index.extend(["b", "a", "d", "b", "d", "B"]);
    assert_eq!((0..index.len()).map(|i| *index.id(i).unwrap()).collect::<Vec<_>>(), ["c", "a", "a", "b", "d", "B"]);
    assert_eq!(["a", "b", "c", "d", "B"].map(|id| index.get(&id)), [Some(1), Some(3), Some(0), Some(4), Some(5)]);
    index.extend([]);
    index.extend(["c"]);
    assert_eq!(index.len(), 6);
    let ids = Ids { vertices: Index::of([1.5_f64.to_bits()]), half_edges: index, faces: Index::of(['f']) };
    let names = [Record::Vertex(3), Record::HalfEdge(4), Record::Face(0), Record::Boundary(8)].map(|r| ids.name(r));
    assert_eq!(names, ["3", "\"d\"", "'f'", "8"]);
}

/// With the index as the name, a report reads as it does without names; and each record that a violation names is named.
#[test]
fn every_record_in_a_report_is_named() {
    let mut seen = BTreeSet::new();
    let tables = [(nested_textbook(), TEXTBOOK), (crate::support::nested::nested(), Expectation::plane())];
    for (table, expectation) in tables.into_iter().chain(maps()) {
        for expectation in
            [expectation, expectation.without(Part::Prev), Expectation::plane().without(Part::UnboundedFace)]
        {
            for_each_corruption(&mut table.clone(), &expectation, |changed, _, _| {
                let report = validate(changed, &expectation, Collect::All);
                assert_eq!(report.named(|record| record.index()).to_string(), report.to_string());
                assert_eq!(format!("{:?}", report.named(|record| record.index())), report.to_string());
                for violation in report.violations() {
                    seen.insert(violation.kind());
                    let text =
                        violation.named(|record| format!("<{}>", record.to_string().replace(' ', "_"))).to_string();
                    for record in violation.records().into_iter().flatten() {
                        let name = format!("<{}>", record.to_string().replace(' ', "_"));
                        assert!(text.contains(&name), "{violation:?}: {text} lacks {name}");
                    }
                }
            });
        }
    }
    assert!(seen.len() > 25, "{seen:?}");
    // Those of coordinates, and what no single corruption shows.
    let named = |violation: Violation| violation.named(|record| format!("<{record}>")).to_string();
    assert!(
        named(Violation::Cross { first: 1, second: 2 }).starts_with("half-edges <half-edge 1> and <half-edge 2> cross")
    );
    assert!(named(Violation::SamePlace { first: 1, second: 2 }).starts_with("vertices <vertex 1> and <vertex 2> lie"));
    let wrong = Violation::WrongFace { boundary: Record::Boundary(1), face: 2, found: Some(3) };
    assert_eq!(
        named(wrong),
        "the inner boundary component <boundary component 1> is listed by face <face 2>, but lies in face <face 3>"
    );
    let start = Violation::OuterClockwise { boundary: Record::HalfEdge(4) };
    assert!(named(start).starts_with("the outer boundary component at half-edge <half-edge 4> turns"));
    assert!(named(Violation::Unlisted { vertex: 1, face: 2 }).contains("<vertex 1> lies in face <face 2>"));
}
