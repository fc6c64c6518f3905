//! The arcs of a file as a half-edge structure, and as a view.

use super::finding::Findings;
use twinedge::validate::{Link, Part, Parts, Record, Start, View};
use twinedge_geometry::Point;
use twinedge_geometry::predicates::compare_angle;
use twinedge_map::Embedding;

pub(super) const NIL: u32 = u32::MAX;

/// The arcs of the polygons of an object, as a half-edge structure: half-edge `2 · i` is arc `i`, and `2 · i + 1` is arc `i`
/// backwards, index `~i`. Faces are polygons, each polygon of a multi-polygon separately.
///
/// The file states the polygon to the left of a half-edge, and the outer ring. It does not state the half-edge that follows
/// another around a face: that is the next one in the order around the end. A polygon whose place differs from that of its arcs
/// therefore has a label that changes along a cycle (B1), and so on.
///
/// Points that repeat the one before them are no bends. Arcs without length, and arcs that no polygon uses, are no edges.
#[derive(Debug, Default)]
pub struct ArcTopology {
    pub(super) points: Vec<Point>,
    /// The ends of each arc; nil for an arc that is no edge.
    pub(super) ends: Vec<[u32; 2]>,
    /// The index of the first bend of each arc; the last entry is the number of bends.
    pub(super) first_bend: Vec<usize>,
    pub(super) bends: Vec<Point>,
    /// The polygon to the left of each half-edge; nil for none.
    pub(super) label: Vec<u32>,
    /// True for each half-edge on the outer ring of that polygon.
    pub(super) is_outer: Vec<bool>,
    pub(super) next: Vec<u32>,
    /// A half-edge of the outer cycle of each face.
    pub(super) outer: Vec<u32>,
    /// Faces with a half-edge of each inner cycle, sorted.
    pub(super) inner: Vec<(u32, u32)>,
    pub(super) names: Vec<String>,
    pub(super) indices: u64,
    pub(super) repeated_points: u64,
    pub(super) findings: Findings,
}

impl ArcTopology {
    /// Returns the name of a record: the index of an arc, with `~` if it is backwards; the polygon; the coordinates of an end.
    ///
    /// For [`Report::named`](twinedge::validate::Report::named). A record that does not exist is named by its number.
    #[must_use]
    pub fn name(&self, record: Record) -> String {
        let found = match record {
            Record::Vertex(v) => self.points.get(v).map(|p| format!("({}, {})", p.x, p.y)),
            Record::HalfEdge(h) => Some(format!("{}{}", if h.is_multiple_of(2) { "" } else { "~" }, h / 2)),
            Record::Face(f) => self.names.get(f).cloned(),
            Record::Boundary(_) => None,
        };
        found.unwrap_or_else(|| record.index().to_string())
    }

    /// Returns the first point after the origin of a half-edge.
    fn towards(&self, half_edge: usize) -> Point {
        if self.bends(half_edge) > 0 {
            return self.bend(half_edge, 0);
        }
        self.points[self.ends[half_edge / 2][1 - half_edge % 2] as usize]
    }

    /// Links each half-edge to its next one: the next one clockwise around its end. O(n log n).
    pub(super) fn link(&mut self) {
        let mut around: Vec<(u32, u32)> = Vec::new();
        for (arc, ends) in self.ends.iter().enumerate() {
            let sides = ends.iter().zip(2 * arc as u32..);
            around.extend(sides.filter(|(v, _)| **v != NIL).map(|(v, h)| (*v, h)));
        }
        around.sort_unstable();
        self.next = vec![NIL; 2 * self.ends.len()];
        for leaving in around.chunk_by_mut(|a, b| a.0 == b.0) {
            let center = self.points[leaving[0].0 as usize];
            leaving.sort_by(|a, b| compare_angle(center, self.towards(a.1 as usize), self.towards(b.1 as usize)));
            for (i, (_, h)) in leaving.iter().enumerate() {
                let before = i.checked_sub(1).unwrap_or(leaving.len() - 1);
                self.next[(h ^ 1) as usize] = leaving[before].1;
            }
        }
    }

    /// Finds the cycles of the faces. The cycle with the outer ring is the outer one. O(n log n).
    pub(super) fn list(&mut self) {
        self.outer = vec![NIL; self.names.len()];
        let mut seen = vec![false; self.next.len()];
        for start in 0..self.next.len() {
            let face = self.label[start];
            if face == NIL || self.next[start] == NIL {
                continue;
            }
            let (mut h, mut is_outer, mut is_new) = (start, false, false);
            // `next` is a permutation, as each half-edge follows exactly one other.
            while !seen[h] {
                (seen[h], is_new) = (true, true);
                is_outer |= self.is_outer[h] && self.label[h] == face;
                h = self.next[h] as usize;
            }
            let outer = &mut self.outer[face as usize];
            if is_new && is_outer && *outer == NIL {
                *outer = start as u32;
            } else if is_new {
                self.inner.push((face, start as u32));
            }
        }
        self.inner.sort_unstable();
    }

    fn inner_of(&self, face: usize) -> &[(u32, u32)] {
        let before = |face: usize| self.inner.partition_point(|(f, _)| (*f as usize) < face);
        &self.inner[before(face)..before(face.saturating_add(1))]
    }
}

fn entry(column: &[u32], i: usize) -> Link {
    column.get(i).filter(|slot| **slot != NIL).map(|slot| *slot as usize)
}

/// Arcs with faces and their holes, as the polygons state. No polygon is the outside, so there is no unbounded face.
impl View for ArcTopology {
    fn parts(&self) -> Parts {
        Parts::NONE.with(Part::Holes)
    }

    fn vertex_slots(&self) -> usize {
        self.points.len()
    }

    fn half_edge_slots(&self) -> usize {
        self.next.len()
    }

    fn face_slots(&self) -> usize {
        self.outer.len()
    }

    fn is_half_edge(&self, half_edge: usize) -> bool {
        self.ends[half_edge / 2][0] != NIL
    }

    /// A polygon that owns no side of an arc occurs twice in the object, which is A2.
    fn is_face(&self, face: usize) -> bool {
        self.outer[face] != NIL || !self.inner_of(face).is_empty()
    }

    fn origin(&self, half_edge: usize) -> Link {
        entry(&self.ends[half_edge / 2], half_edge % 2)
    }

    fn twin(&self, half_edge: usize) -> Link {
        Some(half_edge ^ 1)
    }

    fn next(&self, half_edge: usize) -> Link {
        entry(&self.next, half_edge)
    }

    fn face(&self, half_edge: usize) -> Link {
        entry(&self.label, half_edge)
    }

    fn outer_half_edge(&self, face: usize) -> Link {
        entry(&self.outer, face)
    }

    fn inner_count(&self, face: usize) -> usize {
        self.inner_of(face).len()
    }

    fn inner_start(&self, face: usize, position: usize) -> Option<Start> {
        self.inner_of(face).get(position).map(|(_, h)| Start::HalfEdge(*h as usize))
    }
}

impl Embedding for ArcTopology {
    fn point(&self, vertex: usize) -> Point {
        self.points[vertex]
    }

    fn bends(&self, half_edge: usize) -> usize {
        self.first_bend[half_edge / 2 + 1] - self.first_bend[half_edge / 2]
    }

    fn bend(&self, half_edge: usize, bend: usize) -> Point {
        let [from, to] = [self.first_bend[half_edge / 2], self.first_bend[half_edge / 2 + 1]];
        self.bends[if half_edge.is_multiple_of(2) { from + bend } else { to - 1 - bend }]
    }
}
