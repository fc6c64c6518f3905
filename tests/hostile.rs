//! Structures that lie: the validator returns, and refuses them. No answer may make it panic, ask about what is not
//! there, or go on for ever.

mod support;

use std::cell::Cell;
use support::opinions::{agree, broken};
use support::tables::{map, mesh};
use twinedge::validate::{
    Collect, Expectation, Link, Part, Place, Rule, Start, Table, Unchecked, View, Violation, validate,
};

/// All the expectations that make a difference to which code runs.
fn expectations() -> Vec<Expectation> {
    let mut all = vec![];
    for base in [Expectation::plane(), Expectation::surface()] {
        for parts in [&[][..], &[Part::BoundaryComponents], &[Part::Faces], &[Part::Holes], &[Part::UnboundedFace]] {
            let without = |expectation: Expectation, part: &Part| expectation.without(*part);
            let expectation = parts.iter().fold(base, without);
            let without_prev = expectation.without(Part::Prev);
            all.extend([expectation, expectation.open(), without_prev, without_prev.open()]);
        }
    }
    all
}

/// A structure that claims this many slots of each kind and answers every question with this link.
struct Claims {
    slots: [usize; 4],
    answer: Link,
    listed: usize,
}

impl View for Claims {
    fn vertex_slots(&self) -> usize {
        self.slots[0]
    }
    fn half_edge_slots(&self) -> usize {
        self.slots[1]
    }
    fn boundary_slots(&self) -> usize {
        self.slots[2]
    }
    fn face_slots(&self) -> usize {
        self.slots[3]
    }
    fn origin(&self, _: usize) -> Link {
        self.answer
    }
    fn twin(&self, _: usize) -> Link {
        self.answer
    }
    fn next(&self, _: usize) -> Link {
        self.answer
    }
    fn prev(&self, _: usize) -> Link {
        self.answer
    }
    fn boundary(&self, _: usize) -> Link {
        self.answer
    }
    fn face(&self, _: usize) -> Link {
        self.answer
    }
    fn leaving(&self, _: usize) -> Link {
        self.answer
    }
    fn isolated(&self, _: usize) -> Link {
        self.answer
    }
    fn boundary_face(&self, _: usize) -> Link {
        self.answer
    }
    fn boundary_start(&self, _: usize) -> Option<Start> {
        self.answer.map(Start::HalfEdge)
    }
    fn boundary_place(&self, _: usize) -> Option<Place> {
        self.answer.map(Place::Inner)
    }
    fn outer(&self, _: usize) -> Link {
        self.answer
    }
    fn inner_count(&self, _: usize) -> usize {
        self.listed
    }
    fn inner(&self, _: usize, _: usize) -> Link {
        self.answer
    }
    fn outer_half_edge(&self, _: usize) -> Link {
        self.answer
    }
    fn inner_start(&self, _: usize, position: usize) -> Option<Start> {
        self.answer.map(if position.is_multiple_of(2) { Start::HalfEdge } else { Start::Vertex })
    }
}

#[test]
fn a_claim_of_too_many_records_is_refused_unread() {
    for kind in 0..4 {
        for claimed in [usize::MAX, u32::MAX as usize] {
            let mut slots = [1; 4];
            slots[kind] = claimed;
            let view = Claims { slots, answer: None, listed: 0 };
            let report = validate(&view, &Expectation::plane(), Collect::All);
            assert!(!report.is_valid());
            assert_eq!((report.violation_count(), report.certificate()), (0, None));
            assert!(report.outcomes().all(|(_, outcome)| outcome.unchecked == Some(Unchecked::TooLarge)));
        }
        let mut slots = [1; 4];
        slots[kind] = usize::MAX;
        assert_eq!(Table::copy_of(&Claims { slots, answer: None, listed: 0 }), None);
    }
    assert_eq!(Table::copy_of(&Claims { slots: [1; 4], answer: None, listed: usize::MAX }), None);
}

#[test]
fn every_link_leads_to_one_record() {
    for expectation in expectations() {
        for answer in [None, Some(0), Some(1), Some(999), Some(1000), Some(usize::MAX)] {
            for listed in [0, 3, usize::MAX] {
                let view = Claims { slots: [1000; 4], answer, listed };
                let report = validate(&view, &expectation, Collect::AtMost(0));
                assert!(!report.is_valid());
                assert!(report.violation_count() > 0);
            }
        }
    }
}

/// A table that answers as it is for a while, and then anything, differently each time. It insists on being asked about
/// slots that it has only.
struct Moody<'a> {
    table: &'a Table,
    questions: Cell<u64>,
    /// What it last said of the length of a list.
    listed: Cell<usize>,
    patience: u64,
    seed: u64,
}

impl<'a> Moody<'a> {
    fn new(table: &'a Table, patience: u64, seed: u64) -> Self {
        Self { table, questions: Cell::new(0), listed: Cell::new(0), patience, seed }
    }

    /// Something between 0 and `n`, or the answer of the table while patience lasts.
    fn link(&self, answer: Link, n: usize) -> Link {
        let mood = self.mood()?;
        if mood == u64::MAX { answer } else { Some((mood % (n as u64 + 1)) as usize) }
    }

    /// [`u64::MAX`] while patience lasts; then pseudorandom, and nil now and then.
    fn mood(&self) -> Option<u64> {
        let asked = self.questions.get() + 1;
        self.questions.set(asked);
        if asked <= self.patience {
            return Some(u64::MAX);
        }
        // A step of SplitMix64.
        let mut z = (self.seed << 32 | asked).wrapping_mul(0x9E37_79B9_7F4A_7C15);
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        let z = (z ^ (z >> 31)) >> 1;
        (!z.is_multiple_of(16)).then_some(z >> 4)
    }

    fn is(&self, answer: bool) -> bool {
        match self.mood() {
            Some(u64::MAX) => answer,
            mood => mood.is_some(),
        }
    }

    fn start(&self, answer: Option<Start>) -> Option<Start> {
        match self.mood()? {
            u64::MAX => answer,
            mood if mood.is_multiple_of(3) => self.link(None, self.table.vertices.len()).map(Start::Vertex),
            _ => self.link(None, self.table.half_edges.len()).map(Start::HalfEdge),
        }
    }

    fn vertex(&self, v: usize) -> usize {
        assert!(v < self.table.vertices.len());
        v
    }

    fn half_edge(&self, h: usize) -> usize {
        assert!(h < self.table.half_edges.len());
        h
    }

    fn boundary_slot(&self, b: usize) -> usize {
        assert!(b < self.table.boundaries.len());
        b
    }

    fn position(&self, i: usize) -> usize {
        assert!(i < self.listed.get());
        i
    }

    fn face_slot(&self, f: usize) -> usize {
        assert!(f < self.table.faces.len());
        f
    }
}

impl View for Moody<'_> {
    fn vertex_slots(&self) -> usize {
        self.table.vertices.len()
    }
    fn half_edge_slots(&self) -> usize {
        self.table.half_edges.len()
    }
    fn boundary_slots(&self) -> usize {
        self.table.boundaries.len()
    }
    fn face_slots(&self) -> usize {
        self.table.faces.len()
    }
    fn is_vertex(&self, v: usize) -> bool {
        self.is(self.table.is_vertex(self.vertex(v)))
    }
    fn is_half_edge(&self, h: usize) -> bool {
        self.is(self.table.is_half_edge(self.half_edge(h)))
    }
    fn is_boundary(&self, b: usize) -> bool {
        self.is(self.table.is_boundary(self.boundary_slot(b)))
    }
    fn is_face(&self, f: usize) -> bool {
        self.is(self.table.is_face(self.face_slot(f)))
    }
    fn origin(&self, h: usize) -> Link {
        self.link(self.table.origin(self.half_edge(h)), self.table.vertices.len())
    }
    fn twin(&self, h: usize) -> Link {
        self.link(self.table.twin(self.half_edge(h)), self.table.half_edges.len())
    }
    fn next(&self, h: usize) -> Link {
        self.link(self.table.next(self.half_edge(h)), self.table.half_edges.len())
    }
    fn prev(&self, h: usize) -> Link {
        self.link(self.table.prev(self.half_edge(h)), self.table.half_edges.len())
    }
    fn boundary(&self, h: usize) -> Link {
        self.link(self.table.boundary(self.half_edge(h)), self.table.boundaries.len())
    }
    fn face(&self, h: usize) -> Link {
        self.link(self.table.face(self.half_edge(h)), self.table.faces.len())
    }
    fn leaving(&self, v: usize) -> Link {
        self.link(self.table.leaving(self.vertex(v)), self.table.half_edges.len())
    }
    fn isolated(&self, v: usize) -> Link {
        self.link(self.table.isolated(self.vertex(v)), self.table.boundaries.len())
    }
    fn boundary_face(&self, b: usize) -> Link {
        self.link(self.table.boundary_face(self.boundary_slot(b)), self.table.faces.len())
    }
    fn boundary_start(&self, b: usize) -> Option<Start> {
        self.start(self.table.boundary_start(self.boundary_slot(b)))
    }
    fn boundary_place(&self, b: usize) -> Option<Place> {
        self.table.boundary_place(self.boundary_slot(b))
    }
    fn outer(&self, f: usize) -> Link {
        self.link(self.table.outer(self.face_slot(f)), self.table.boundaries.len())
    }
    fn inner_count(&self, f: usize) -> usize {
        self.listed.set(self.link(Some(self.table.inner_count(self.face_slot(f))), 5).unwrap_or(usize::MAX));
        self.listed.get()
    }
    fn inner(&self, f: usize, i: usize) -> Link {
        self.link(self.table.inner(self.face_slot(f), self.position(i)), self.table.boundaries.len())
    }
    fn outer_half_edge(&self, f: usize) -> Link {
        self.link(self.table.outer_half_edge(self.face_slot(f)), self.table.half_edges.len())
    }
    fn inner_start(&self, f: usize, i: usize) -> Option<Start> {
        self.start(self.table.inner_start(self.face_slot(f), self.position(i)))
    }
}

/// A loop in a loop beside a vertex, in either form: every question has an answer in it.
fn loops() -> Table {
    let (outside, between) = ([Start::HalfEdge(1), Start::Vertex(2)], [Start::HalfEdge(3)]);
    let half_edges = [(0, 0), (0, 1), (1, 2), (1, 3)];
    let faces: [(Option<usize>, &[Start]); 3] = [(None, &outside), (Some(0), &between), (Some(2), &[])];
    let (mut table, textbook) = (map(3, &half_edges, &faces), support::tables::textbook_map(3, &half_edges, &faces));
    for (row, other) in table.half_edges.iter_mut().flatten().zip(textbook.half_edges.iter().flatten()) {
        row.face = other.face;
    }
    for (row, other) in table.faces.iter_mut().flatten().zip(textbook.faces.iter().flatten()) {
        (row.outer_half_edge, row.inner_starts) = (other.outer_half_edge, other.inner_starts.clone());
    }
    table
}

/// Whatever changes while it is being looked at, and from whichever question on: only a few questions more are asked,
/// and none about what is not there.
#[test]
fn answers_may_change_from_call_to_call() {
    let table = loops();
    for expectation in expectations() {
        let questions = |patience, seed| {
            let view = Moody::new(&table, patience, seed);
            validate(&view, &expectation, Collect::All);
            view.questions.get()
        };
        let honest = questions(u64::MAX, 0);
        for patience in 0..=honest {
            for seed in 0..8 {
                assert!(questions(patience, seed) < 3 * honest + 300, "{expectation:?}");
            }
        }
    }
}

/// `next` is a permutation when R1 and L2 look at it, and another when T3 counts its cycles: the only way to a surface
/// that does not exist, because where L and V2 hold, the numbers of a component are those of a surface.
#[test]
fn a_surface_that_does_not_exist() {
    struct Fickle(Cell<usize>, usize);
    impl View for Fickle {
        fn vertex_slots(&self) -> usize {
            1
        }
        fn half_edge_slots(&self) -> usize {
            2
        }
        fn origin(&self, _: usize) -> Link {
            Some(0)
        }
        fn twin(&self, half_edge: usize) -> Link {
            Some(half_edge ^ 1)
        }
        fn next(&self, half_edge: usize) -> Link {
            self.0.set(self.0.get() + 1);
            Some(if self.0.get() <= self.1 { half_edge } else { half_edge ^ 1 })
        }
    }
    let expectation = Expectation::surface().without(Part::Faces).without(Part::Prev).without(Part::Leaving);
    let reports = (0..20).map(|n| validate(&Fickle(Cell::new(0), n), &expectation, Collect::All));
    let odd: Vec<_> = reports.filter(|report| broken(report) == [Rule::T3]).collect();
    let violation = Violation::NoSuchSurface { vertex: 0, vertices: 1, edges: 1, cycles: 1 };
    assert!(!odd.is_empty());
    assert!(odd.iter().all(|report| report.violations() == [violation]));
}

/// A torus of six triangles for each unit of length.
fn torus(length: usize) -> Table {
    let vertex = |i: usize, j: usize| 3 * (i % length) + j % 3;
    let triangles: Vec<[usize; 3]> = (0..3 * length)
        .map(|k| (k / 3, k % 3))
        .flat_map(|(i, j)| {
            let [a, b, c, d] = [vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)];
            [[a, b, c], [a, c, d]]
        })
        .collect();
    mesh(3 * length, &triangles)
}

/// Twice and four times the records cost twice and four times the questions, whether the structure is right or not.
#[test]
fn the_work_is_linear() {
    let expectation = Expectation::surface();
    assert_eq!(validate(&torus(10), &expectation, Collect::All).certificate().unwrap().genus, 1);
    let questions = |length, spoil: &dyn Fn(&mut Table)| {
        let mut table = torus(length);
        spoil(&mut table);
        let view = Moody::new(&table, u64::MAX, 0);
        validate(&view, &expectation, Collect::All);
        view.questions.get()
    };
    let spoils: [&dyn Fn(&mut Table); 6] = [
        &|_| (),
        &|table| table.half_edges.iter_mut().flatten().for_each(|row| row.next = Some(0)),
        &|table| table.half_edges.iter_mut().flatten().for_each(|row| row.origin = Some(0)),
        &|table| table.half_edges.iter_mut().flatten().for_each(|row| row.boundary = Some(0)),
        &|table| table.boundaries.iter_mut().flatten().for_each(|row| row.start = Some(Start::HalfEdge(0))),
        &|table| table.faces.iter_mut().flatten().for_each(|row| row.outer = Some(0)),
    ];
    for spoil in spoils {
        let [one, two, four] = [10, 20, 40].map(|length| questions(length, spoil));
        // What is asked but once, before something amiss is found, drops out of the differences.
        assert!((four - two).abs_diff(2 * (two - one)) < 10, "{one} {two} {four}");
    }
}

#[test]
fn an_honest_table_is_judged_as_always() {
    for expectation in [Expectation::plane(), Expectation::plane().without(Part::BoundaryComponents)] {
        assert_eq!(agree(&loops(), expectation), None);
    }
}
