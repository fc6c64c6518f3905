//! What a validation asks of the allocator, per record: the figures in the documentation of `validate`.

use crate::counting::{LIVE_BYTES, PEAK_BYTES};
use twinedge::delegate_view;
use twinedge::validate::reference::rule_by_rule;
use twinedge::validate::{BoundaryPlace, Collect, Expectation, Link, Part, Rule, Start, View, validate};

/// The most bytes that are live at a time while a structure is validated, less those of a structure without records.
fn peak(view: &impl View, expectation: Expectation) -> usize {
    peak_of(|| validate(view, &expectation, Collect::All).is_valid())
}

fn peak_of(is_valid: impl FnOnce() -> bool) -> usize {
    let before = LIVE_BYTES.get();
    PEAK_BYTES.set(before);
    assert!(is_valid());
    (PEAK_BYTES.get() - before).cast_unsigned()
}

/// What a report takes, whatever the structure.
const REPORT: usize = 2000;

/// So many isolated vertices in the unbounded face.
struct Points(usize);

impl View for Points {
    fn vertex_slots(&self) -> usize {
        self.0
    }
    fn half_edge_slots(&self) -> usize {
        0
    }
    fn boundary_slots(&self) -> usize {
        self.0
    }
    fn face_slots(&self) -> usize {
        1
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
    fn isolated(&self, v: usize) -> Link {
        Some(v)
    }
    fn boundary_face(&self, _: usize) -> Link {
        Some(0)
    }
    fn boundary_start(&self, b: usize) -> Option<Start> {
        Some(Start::Vertex(b))
    }
    fn boundary_place(&self, b: usize) -> Option<BoundaryPlace> {
        Some(BoundaryPlace::Inner(b))
    }
    fn inner_count(&self, _: usize) -> usize {
        self.0
    }
    fn inner(&self, _: usize, i: usize) -> Link {
        Some(i)
    }
}

/// One cycle of so many edges: half-edges `2i` on its inside, `2i + 1` on its outside. Where the border is open, there is no
/// outside.
struct Polygon {
    edges: usize,
    open: bool,
}

impl View for Polygon {
    fn vertex_slots(&self) -> usize {
        self.edges
    }
    fn half_edge_slots(&self) -> usize {
        2 * self.edges
    }
    fn is_half_edge(&self, h: usize) -> bool {
        h < 2 * self.edges && (h % 2 == 0 || !self.open)
    }
    fn face_slots(&self) -> usize {
        if self.open { 1 } else { 2 }
    }
    fn boundary_slots(&self) -> usize {
        self.face_slots()
    }
    fn origin(&self, h: usize) -> Link {
        Some((h / 2 + h % 2) % self.edges)
    }
    fn twin(&self, h: usize) -> Link {
        (!self.open).then_some(h ^ 1)
    }
    fn next(&self, h: usize) -> Link {
        let n = 2 * self.edges;
        Some(if h % 2 == 0 { (h + 2) % n } else { (h + n - 2) % n })
    }
    fn prev(&self, h: usize) -> Link {
        let n = 2 * self.edges;
        Some(if h % 2 == 1 { (h + 2) % n } else { (h + n - 2) % n })
    }
    fn face(&self, h: usize) -> Link {
        Some(h % 2)
    }
    fn boundary(&self, h: usize) -> Link {
        Some(h % 2)
    }
    fn leaving(&self, v: usize) -> Link {
        Some(2 * v)
    }
    fn boundary_face(&self, b: usize) -> Link {
        Some(b)
    }
    fn boundary_start(&self, b: usize) -> Option<Start> {
        Some(Start::HalfEdge(b))
    }
    fn boundary_place(&self, _: usize) -> Option<BoundaryPlace> {
        Some(BoundaryPlace::Outer)
    }
    fn outer(&self, f: usize) -> Link {
        Some(f)
    }
    fn outer_half_edge(&self, f: usize) -> Link {
        Some(f)
    }
}

/// As many bytes as the documentation says at most, and no less than nine tenths of that where all are needed.
#[track_caller]
fn assert_close(bytes: usize, stated: usize) {
    assert!(bytes <= stated + REPORT, "{bytes} bytes are more than {stated}");
    assert!(bytes >= stated / 10 * 9, "{bytes} bytes are far less than {stated}");
}

/// As many bytes as are allocated at a time by the rules without the fast path.
fn peak_elsewhere(view: &impl View, expectation: Expectation) -> usize {
    peak_of(|| rule_by_rule(view, &expectation, Collect::All).is_valid())
}

#[test]
fn a_component_takes_68_bytes_and_elsewhere_144_at_most() {
    let plane = Expectation::plane();
    // The list of components was just copied to twice its size.
    let n = (1 << 16) + 1;
    assert_close(peak(&Points(n), plane), (8 + 68) * n);
    assert_close(peak_elsewhere(&Points(n), plane), (20 + 144) * n);
    for n in [1000, 3000, 30_000, 1 << 16, 100_000] {
        assert!(peak(&Points(n), plane) <= (8 + 68) * n + REPORT);
        assert!(peak_elsewhere(&Points(n), plane) <= (20 + 144) * n + REPORT);
    }
}

/// Edges from one vertex, the last or the first, to all others. With the last one, no other vertex has a neighbour with a
/// smaller number.
struct Star {
    edges: usize,
    centre_is_last: bool,
}

impl View for Star {
    fn vertex_slots(&self) -> usize {
        self.edges + 1
    }
    fn half_edge_slots(&self) -> usize {
        2 * self.edges
    }
    fn origin(&self, h: usize) -> Link {
        let centre = if self.centre_is_last { self.edges } else { 0 };
        Some(if h % 2 == 0 { centre } else { h / 2 + usize::from(!self.centre_is_last) })
    }
    fn twin(&self, h: usize) -> Link {
        Some(h ^ 1)
    }
    fn next(&self, h: usize) -> Link {
        Some(if h % 2 == 0 { h + 1 } else { (h + 1) % (2 * self.edges) })
    }
}

#[test]
fn vertices_and_half_edges_take_what_is_said() {
    let edges = 100_000;
    let closed = Polygon { edges, open: false };
    let surface = Expectation::surface();
    assert_close(peak(&closed, surface), 8 * edges);
    assert_close(peak(&closed, surface.without(Part::Leaving)), 12 * edges);
    assert_close(peak_elsewhere(&closed, surface), 20 * edges);
    // Two half-edges for each vertex, of which each takes 4 bytes while the rotations are walked around, and 5 later.
    let mesh = surface.without(Part::BoundaryComponents).without(Part::Prev);
    assert_close(peak_elsewhere(&closed, mesh), 20 * edges + 4 * 2 * edges);
    for open in [false, true] {
        for expectation in [mesh.open(), mesh.without(Part::Faces).open(), surface.without(Part::Prev).open()] {
            assert!(peak(&Polygon { edges, open }, expectation) <= 16 * edges + REPORT);
            let polygon = Polygon { edges, open };
            assert!(peak_elsewhere(&polygon, expectation) <= (20 + 5 * 2) * edges + REPORT);
        }
    }
    let map = surface.without(Part::Faces).without(Part::Prev).without(Part::Leaving);
    // The one cycle is long: a bit for each half-edge of it, while the rotations are walked around.
    assert_close(peak(&Star { edges, centre_is_last: false }, map), 12 * edges + 2 * edges / 8);
    assert_close(peak(&Star { edges, centre_is_last: true }, map), 16 * edges);
}

/// A structure with one wrong answer: that for this record to the question of this rule.
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

/// What the fast path keeps of a structure with one fault, until the rules have used it, and what they take beside it are together no
/// more than the rules take alone, and less than the documentation says.
#[test]
fn what_is_partly_settled_takes_no_more_than_elsewhere() {
    let edges = 100_000;
    let right = Polygon { edges, open: false };
    let surface = Expectation::surface();
    let mesh = surface.without(Part::BoundaryComponents);
    let map = surface.without(Part::Faces);
    let mut most = 0;
    for expectation in [surface, mesh, map, surface.open(), mesh.open(), map.open(), Expectation::plane()] {
        for expectation in [expectation, expectation.without(Part::Leaving), expectation.without(Part::Prev)] {
            for (rule, record) in [
                (Rule::R1, edges),
                (Rule::L1, edges),
                (Rule::L2, edges),
                (Rule::L3, edges),
                (Rule::V1, edges / 2),
                (Rule::B1, edges),
                (Rule::F2, 0),
            ] {
                let view = Wrong { right: &right, rule, record };
                let bytes = peak_of(|| {
                    let _ = validate(&view, &expectation, Collect::All);
                    true
                });
                most = most.max(bytes);
                assert!(bytes <= 20 * edges + REPORT, "{bytes} bytes, {rule:?}, {expectation:?}");
            }
        }
    }
    assert_close(most, 20 * edges);
}
