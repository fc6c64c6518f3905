//! The memory of a validation per record: the figures in the documentation of `validate`.

use crate::counting::{LIVE_BYTES, PEAK_BYTES};
use twinedge::validate::reference::rule_by_rule;
use twinedge::validate::{BoundaryPlace, Collect, Expectation, Link, Only, Part, Parts, Rule, Start, View, validate};
use twinedge::{delegate_view, view_answers};

/// The peak of live bytes during a validation, minus the peak for an empty structure.
fn peak(view: &impl View, expectation: Expectation) -> usize {
    peak_of(|| validate(view, &expectation, Collect::All).is_valid())
}

fn peak_of(is_valid: impl FnOnce() -> bool) -> usize {
    let before = LIVE_BYTES.get();
    PEAK_BYTES.set(before);
    assert!(is_valid());
    (PEAK_BYTES.get() - before).cast_unsigned()
}

/// The size of a report, for any structure.
const REPORT: usize = 2000;

/// This number of isolated vertices in the unbounded face.
struct Points(usize);

impl View for Points {
    view_answers! { |points|
        parts => Parts::ALL,
        vertex_slots => points.0,
        half_edge_slots => 0,
        boundary_slots => points.0,
        face_slots => 1,
        origin(_h) => None,
        twin(_h) => None,
        next(_h) => None,
        isolated(v) => Some(v),
        boundary_face(_h) => Some(0),
        boundary_start(b) => Some(Start::Vertex(b)),
        boundary_place(b) => Some(BoundaryPlace::Inner(b)),
        inner_count(_h) => points.0,
        inner(_h, i) => Some(i),
    }
}

/// One cycle of `edges` edges: half-edges `2i` on its inside, `2i + 1` on its outside. With an open border there is no
/// outside.
struct Polygon {
    edges: usize,
    open: bool,
}

impl View for Polygon {
    view_answers! { |polygon|
        parts => Parts::ALL,
        vertex_slots => polygon.edges,
        half_edge_slots => 2 * polygon.edges,
        is_half_edge(h) => h < 2 * polygon.edges && (h % 2 == 0 || !polygon.open),
        face_slots => if polygon.open { 1 } else { 2 },
        boundary_slots => polygon.face_slots(),
        origin(h) => Some((h / 2 + h % 2) % polygon.edges),
        twin(h) => (!polygon.open).then_some(h ^ 1),
        next(h) => {
            let n = 2 * polygon.edges;
            Some(if h % 2 == 0 { (h + 2) % n } else { (h + n - 2) % n })
        },
        prev(h) => {
            let n = 2 * polygon.edges;
            Some(if h % 2 == 1 { (h + 2) % n } else { (h + n - 2) % n })
        },
        face(h) => Some(h % 2),
        boundary(h) => Some(h % 2),
        leaving(v) => Some(2 * v),
        boundary_face(b) => Some(b),
        boundary_start(b) => Some(Start::HalfEdge(b)),
        boundary_place(_h) => Some(BoundaryPlace::Outer),
        outer(f) => Some(f),
        outer_half_edge(f) => Some(f),
    }
}

/// Asserts at most the documented number of bytes, and at least nine tenths of it.
#[track_caller]
fn assert_close(bytes: usize, stated: usize) {
    assert!(bytes <= stated + REPORT, "{bytes} bytes are more than {stated}");
    assert!(bytes >= stated / 10 * 9, "{bytes} bytes are far less than {stated}");
}

/// The peak of live bytes of the rules without the fast path.
fn peak_elsewhere(view: &impl View, expectation: Expectation) -> usize {
    peak_of(|| rule_by_rule(view, &expectation, Collect::All).is_valid())
}

#[test]
fn a_component_takes_20_bytes_and_elsewhere_72_at_most() {
    let plane = Expectation::plane();
    // The list of components was just copied to twice its size.
    let n = (1 << 16) + 1;
    assert_close(peak(&Points(n), plane), (8 + 20) * n);
    assert_close(peak_elsewhere(&Points(n), plane), (16 + 72) * n);
    for n in [1000, 3000, 30_000, 1 << 16, 100_000] {
        assert!(peak(&Points(n), plane) <= (8 + 20) * n + REPORT);
        assert!(peak_elsewhere(&Points(n), plane) <= (16 + 72) * n + REPORT);
    }
}

/// Edges from one vertex, the last or the first, to all others. If it is the last one, no other vertex has a neighbour with
/// a smaller number.
struct Star {
    edges: usize,
    centre_is_last: bool,
}

impl View for Star {
    view_answers! { |star|
        parts => Parts::NONE,
        vertex_slots => star.edges + 1,
        half_edge_slots => 2 * star.edges,
        origin(h) => {
            let centre = if star.centre_is_last { star.edges } else { 0 };
            Some(if h % 2 == 0 { centre } else { h / 2 + usize::from(!star.centre_is_last) })
        },
        twin(h) => Some(h ^ 1),
        next(h) => Some(if h % 2 == 0 { h + 1 } else { (h + 1) % (2 * star.edges) }),
    }
}

#[test]
fn vertices_and_half_edges_take_what_is_said() {
    let edges = 100_000;
    let closed = Polygon { edges, open: false };
    let surface = Expectation::surface();
    assert_close(peak(&closed, surface), 8 * edges);
    assert_close(peak(&Only::new(&closed, Parts::ALL.without(Part::Leaving)), surface), 12 * edges);
    assert_close(peak_elsewhere(&closed, surface), 12 * edges);
    // Two half-edges per vertex, which take 4 bytes each before the rotations are walked around.
    let mesh = Parts::NONE.with(Part::Leaving).with(Part::Faces);
    assert_close(peak_elsewhere(&Only::new(&closed, mesh), surface), 8 * edges + 4 * 2 * edges);
    for open in [false, true] {
        for parts in [mesh, mesh.without(Part::Faces), Parts::ALL.without(Part::Prev)] {
            let polygon = Only::new(Polygon { edges, open }, parts);
            assert!(peak(&polygon, surface.open()) <= 16 * edges + REPORT);
            assert!(peak_elsewhere(&polygon, surface.open()) <= (12 + 4 * 2) * edges + REPORT);
        }
    }
    // The only cycle is long: one bit for each of its half-edges, while the rotations are walked around.
    assert_close(peak(&Star { edges, centre_is_last: false }, surface), 12 * edges + 2 * edges / 8);
    assert_close(peak(&Star { edges, centre_is_last: true }, surface), 12 * edges);
}

/// A structure with one incorrect answer: for this record, to the question of this rule.
struct Wrong<'a, V> {
    right: &'a V,
    rule: Rule,
    record: usize,
}

impl<V> Wrong<'_, V> {
    fn is_asked(&self, rule: Rule, record: usize) -> bool {
        rule == self.rule && record == self.record
    }
}

impl<V: View> View for Wrong<'_, V> {
    delegate_view!(|this| this.right; except origin, twin, next, prev, boundary, face, leaving, boundary_face);

    fn origin(&self, h: usize) -> Link {
        if self.is_asked(Rule::R1, h) { None } else { self.right.origin(h) }
    }
    fn twin(&self, h: usize) -> Link {
        if self.is_asked(Rule::L1, h) { Some(h) } else { self.right.twin(h) }
    }
    fn next(&self, h: usize) -> Link {
        if self.is_asked(Rule::L3, h) { Some(h) } else { self.right.next(h) }
    }
    fn prev(&self, h: usize) -> Link {
        if self.is_asked(Rule::L2, h) { Some(h) } else { self.right.prev(h) }
    }
    fn boundary(&self, h: usize) -> Link {
        if self.is_asked(Rule::B1, h) { Some(1 - h % 2) } else { self.right.boundary(h) }
    }
    fn face(&self, h: usize) -> Link {
        if self.is_asked(Rule::B1, h) { Some(1 - h % 2) } else { self.right.face(h) }
    }
    fn leaving(&self, v: usize) -> Link {
        if self.is_asked(Rule::V1, v) { self.right.leaving(v + 1) } else { self.right.leaving(v) }
    }
    fn boundary_face(&self, b: usize) -> Link {
        if self.is_asked(Rule::F2, b) { Some(1 - b) } else { self.right.boundary_face(b) }
    }
}

/// With one fault, the fast path has freed its memory before the rules allocate theirs.
#[test]
fn a_structure_with_a_fault_takes_no_more_than_elsewhere() {
    let edges = 20_000;
    let right = Polygon { edges, open: false };
    let surface = Expectation::surface();
    let forms = [surface, surface.open()].into_iter().flat_map(|claims| {
        [None, Some(Part::BoundaryComponents), Some(Part::Faces)]
            .map(|lacks| (claims, lacks.map_or(Parts::ALL, |part| Parts::ALL.without(part))))
    });
    let mut most = 0;
    for (expectation, parts) in forms.chain([(Expectation::plane(), Parts::ALL)]) {
        for parts in [parts, parts.without(Part::Leaving), parts.without(Part::Prev)] {
            for (rule, record) in [
                (Rule::R1, edges),
                (Rule::L1, edges),
                (Rule::L2, edges),
                (Rule::L3, edges),
                (Rule::V1, edges / 2),
                (Rule::B1, edges),
                (Rule::F2, 0),
            ] {
                let view = Only::new(Wrong { right: &right, rule, record }, parts);
                let bytes = peak_of(|| {
                    let _ = validate(&view, &expectation, Collect::All);
                    true
                });
                most = most.max(bytes);
                assert!(bytes <= 20 * edges + REPORT, "{bytes} bytes, {rule:?}, {expectation:?}, {parts:?}");
            }
        }
    }
    assert_close(most, 20 * edges);
}
