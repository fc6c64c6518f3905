//! The pieces of faces in a tile.
//!
//! The border of the tile and the cycles that it cuts form new cycles, each the outer boundary of a piece, as is each outer cycle
//! inside. The outside of a component inside the tile is in the piece below its least vertex.
//!
//! ```text
//!   ┌──────┬───────┐
//!   │  1   │   2   │     three contacts, three pieces that the border cuts,
//!   ├─────┐│  ┌──┐ │     and one inside
//!   │  3  └┤  │4 │ │
//!   │      └──┼──┼─┤
//!   └─────────┴──┴─┘
//! ```

use super::NIL;
use super::clip::{is_below, is_left_of_ray};
use super::ends::compare_points;
use super::local::{Local, Part};
use super::side::Side;
use super::summary::Face;
use core::ops::Range;
use petgraph::unionfind::UnionFind;
use rustc_hash::FxHashMap;
use twinedge_geometry::Point;
use twinedge_geometry::sweep::sweep;
use twinedge_map::Embedding as _;

/// The pieces of faces in a tile; pieces cut by the border come first.
pub(super) struct Pieces {
    pub(super) faces: Vec<Face>,
    /// The piece between each contact and the next; if there is no contact, the only one.
    pub(super) after: Vec<u32>,
    /// The piece to the left of each half-edge, by index.
    of: Vec<u32>,
}

impl Pieces {
    /// `leaves` contains, for each contact, the contact where the half-edge that enters there leaves again, and `closed` a
    /// half-edge of each cycle inside. O(n log n).
    pub(super) fn new(local: &Local<'_>, leaves: &[u32], closed: &[usize]) -> Self {
        let count = local.contacts.len();
        let following = |contact: usize| (contact + 1) % count;
        // After a cycle leaves, the border leads to the next contact, where another one enters.
        let mut sets = UnionFind::new(count);
        for (enter, leave) in (0..).zip(leaves) {
            sets.union(enter, following(*leave as usize) as u32);
        }
        let mut numbers = FxHashMap::default();
        let mut number_of = sets.into_labeling();
        for number in &mut number_of {
            let next = numbers.len() as u32;
            *number = *numbers.entry(*number).or_insert(next);
        }
        let cut = number_of.iter().max().map_or(1, |most| *most as usize + 1);
        let after = if count == 0 { vec![0] } else { (0..count).map(|i| number_of[following(i)]).collect() };
        let mut pieces = Self { faces: vec![Face::default(); cut], after, of: vec![NIL; local.part_of.len()] };
        for contact in 0..count as u32 {
            pieces.mark(local, local.entering(contact), number_of[contact as usize]);
        }
        let is_outer = |h: &usize| local.half_edge(*h).is_some_and(|h| h.boundary().is_outer());
        for start in closed.iter().filter(|h| is_outer(h)) {
            let number = pieces.faces.len() as u32;
            pieces.faces.push(Face::default());
            pieces.mark(local, *start, number);
        }
        let outsides: Vec<usize> = closed.iter().copied().filter(|h| !is_outer(h)).collect();
        pieces.place(local, &outsides);
        pieces.say_features(local);
        for side in Side::ALL {
            let bounds = &local.bounds;
            let line = match side {
                Side::Bottom => bounds.bottom,
                Side::Right => bounds.right,
                Side::Top => bounds.top,
                Side::Left => bounds.left,
            };
            if line.is_none() {
                let before = local.contacts.iter().take_while(|contact| contact.0 < side).count();
                let piece = pieces.before(before);
                pieces.faces[piece as usize].is_unbounded = true;
            }
        }
        pieces
    }

    fn before(&self, contact: usize) -> u32 {
        let count = self.after.len();
        self.after[(contact + count - 1) % count]
    }

    /// Marks the half-edges of a cycle, up to where it leaves the tile.
    fn mark(&mut self, local: &Local<'_>, start: usize, piece: u32) {
        let mut h = start;
        loop {
            self.of[h] = piece;
            let next = local.half_edge(h).map(|h| h.next().index());
            match next {
                Some(next) if next != start && local.leaves_at(h).is_none() => h = next,
                _ => break,
            }
        }
    }

    /// Finds the pieces that contain the outsides of components, each given by a half-edge.
    fn place(&mut self, local: &Local<'_>, outsides: &[usize]) {
        if outsides.is_empty() {
            return;
        }
        let least_of = |start: usize| {
            let along =
                core::iter::successors(local.half_edge(start), |h| Some(h.next()).filter(|next| next.index() != start));
            let points = along.map(|h| local.map.point(h.origin().index()));
            points.min_by(|a, b| compare_points(*a, *b)).unwrap_or_default()
        };
        let mut least: Vec<(Point, usize)> = outsides.iter().map(|start| (least_of(*start), *start)).collect();
        least.sort_by(|a, b| compare_points(a.0, b.0));
        let mut points: Vec<Point> = local.parts.iter().flat_map(|part| part.ends).collect();
        points.sort_by(|a, b| compare_points(*a, *b));
        points.dedup();
        let number = |p: Point| points.binary_search_by(|q| compare_points(*q, p)).unwrap_or_default() as u32;
        let segments: Vec<[u32; 2]> = local.parts.iter().map(|part| part.ends.map(number)).collect();
        let queries: Vec<u32> = least.iter().map(|(p, _)| number(*p)).collect();
        let below = sweep(&points, &segments, &queries).map(|swept| swept.below).unwrap_or_default();
        let at_bottom = local.contacts.partition_point(|contact| contact.0 == Side::Bottom);
        // Left to right, so the piece of the edge below is known.
        for ((p, start), below) in least.into_iter().zip(below) {
            let part = below.map(|part| &local.parts[part as usize]);
            let bottom = local.bounds.bottom;
            let inside = part.filter(|part| bottom.is_none_or(|y| !is_below(part.ends, p.x, y)));
            let piece = if let Some(part) = inside {
                self.of[part.half_edges[0]]
            } else {
                let is_passed =
                    |part: u32| bottom.is_some_and(|y| is_left_of_ray(local.parts[part as usize].ends, p.x, y));
                self.before(local.contacts[..at_bottom].partition_point(|(_, part, _)| is_passed(*part)))
            };
            self.mark(local, start, piece);
        }
    }

    /// Sets the features that cover the pieces.
    fn say_features(&mut self, local: &Local<'_>) {
        let mut is_known = vec![false; self.faces.len()];
        for h in local.parts.iter().flat_map(|part| part.half_edges) {
            let piece = self.of[h] as usize;
            if core::mem::replace(&mut is_known[piece], true) {
                continue;
            }
            let face = local.half_edge(h).map(|h| h.face().key());
            self.faces[piece].features = local.covering(face);
        }
        if !is_known[0] {
            // The tile has no edge. An isolated vertex determines its face, or else an arbitrary point.
            let face = local.map.face_at(local.bounds.any_point());
            self.faces[0].features = local.covering(face.map(|face| face.key()));
        }
    }

    /// Returns the pieces on the border before, between and after some contacts.
    pub(super) fn along(&self, contacts: Range<usize>) -> Vec<u32> {
        (contacts.start..=contacts.end).map(|contact| self.before(contact)).collect()
    }

    /// Returns the pieces on both sides of an edge.
    pub(super) fn beside(&self, part: &Part) -> [u32; 2] {
        part.half_edges.map(|h| self.of[h])
    }
}
