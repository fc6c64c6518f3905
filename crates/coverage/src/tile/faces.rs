//! The parts of faces in a tile.
//!
//! The border of the tile and the cycles that it cuts form new cycles, each the outer boundary of a part, as is each outer cycle
//! inside. The outside of a component inside the tile is in the part below its least vertex.
//!
//! ```text
//!   ┌──────┬───────┐
//!   │  1   │   2   │     three contacts, three parts that the border cuts,
//!   ├─────┐│  ┌──┐ │     and one inside
//!   │  3  └┤  │4 │ │
//!   │      └──┼──┼─┤
//!   └─────────┴──┴─┘
//! ```

use super::NIL;
use super::bounds::{is_below, is_left_of_ray};
use super::local::{Cycles, Local};
use super::side::Side;
use super::summary::Face;
use core::ops::Range;
use petgraph::unionfind::UnionFind;
use rustc_hash::FxHashMap;

/// The parts of faces in a tile; those cut by the border come first.
pub(super) struct Faces {
    pub(super) all: Vec<Face>,
    /// The part between each contact and the next; if there is no contact, the only one.
    pub(super) after: Vec<u32>,
    /// The part to the left of each half-edge.
    of: Vec<u32>,
}

impl Faces {
    /// O(n log n), plus the features of all parts.
    pub(super) fn new(local: &Local, Cycles { leaves, closed }: &Cycles) -> Self {
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
        let mut faces = Self { all: vec![Face::default(); cut], after, of: vec![NIL; 2 * local.segments.len()] };
        for contact in 0..count as u32 {
            faces.mark(local, local.entering(contact), number_of[contact as usize]);
        }
        let mut outsides = Vec::new();
        for start in closed {
            if let Some(least) = outside(local, *start) {
                outsides.push((least, *start));
            } else {
                faces.all.push(Face::default());
                faces.mark(local, *start, faces.all.len() as u32 - 1);
            }
        }
        faces.place(local, outsides);
        faces.cover(local);
        let bounds = &local.bounds;
        for (side, line) in Side::ALL.into_iter().zip([bounds.low.y, bounds.high.x, bounds.high.y, bounds.low.x]) {
            if line.is_infinite() {
                let part = faces.before(local.contacts.iter().take_while(|contact| contact.0 < side).count());
                faces.all[part as usize].is_unbounded = true;
            }
        }
        faces
    }

    fn before(&self, contact: usize) -> u32 {
        let count = self.after.len();
        self.after[(contact + count - 1) % count]
    }

    fn mark(&mut self, local: &Local, start: u32, part: u32) {
        for h in local.along(start) {
            self.of[h as usize] = part;
        }
    }

    /// Finds the parts that contain the outsides of components, each given by its least point and a half-edge.
    fn place(&mut self, local: &Local, mut outsides: Vec<(u32, u32)>) {
        // Left to right, so the part of the edge below is known.
        outsides.sort_unstable();
        let least: Vec<u32> = outsides.iter().map(|(least, _)| *least).collect();
        let at_bottom = local.contacts.partition_point(|contact| contact.0 == Side::Bottom);
        let bottom = local.bounds.low.y;
        for ((least, start), below) in outsides.into_iter().zip(local.below.of(&least)) {
            let x = local.points[least as usize].x;
            let ends = |segment: u32| local.segments[segment as usize].ends;
            let part = if let Some(segment) = below.filter(|segment| !is_below(ends(*segment), x, bottom)) {
                self.of[2 * segment as usize]
            } else {
                let is_passed = |segment: u32| bottom.is_finite() && is_left_of_ray(ends(segment), x, bottom);
                self.before(local.contacts[..at_bottom].partition_point(|(_, segment, _)| is_passed(*segment)))
            };
            self.mark(local, start, part);
        }
    }

    /// Finds the features that cover each part: from the part at the lower left corner, across edges.
    fn cover(&mut self, local: &Local) {
        let mut beside = vec![Vec::new(); self.all.len()];
        for segment in 0..local.segments.len() as u32 {
            let [left, right] = self.beside(segment);
            if left != right {
                beside[left as usize].push((segment, right));
                beside[right as usize].push((segment, left));
            }
        }
        let mut is_known = vec![false; self.all.len()];
        let start = self.before(0);
        is_known[start as usize] = true;
        let has_corner = |part: &u32| local.covers[*part as usize].has_corner;
        let mut left = vec![(start, (0..local.covers.len() as u32).filter(has_corner).collect::<Vec<u32>>())];
        while let Some((part, covers)) = left.pop() {
            for (segment, beyond) in &beside[part as usize] {
                if !core::mem::replace(&mut is_known[*beyond as usize], true) {
                    left.push((*beyond, across(local, *segment, &covers)));
                }
            }
            let mut features: Vec<u32> = covers.iter().map(|part| local.covers[*part as usize].feature).collect();
            features.sort_unstable();
            features.dedup();
            self.all[part as usize].features = features;
        }
    }

    /// Returns the parts on the border before, between and after some contacts.
    pub(super) fn along(&self, contacts: Range<usize>) -> Vec<u32> {
        (contacts.start..=contacts.end).map(|contact| self.before(contact)).collect()
    }

    /// Returns the parts to the left and right of an edge.
    pub(super) fn beside(&self, segment: u32) -> [u32; 2] {
        [0, 1].map(|way| self.of[2 * segment as usize + way])
    }

    /// Returns the parts around a point.
    pub(super) fn around<'a>(&'a self, local: &'a Local, point: u32) -> impl Iterator<Item = &'a Face> {
        local.leaving(point).iter().map(|h| &self.all[self.of[*h as usize] as usize])
    }
}

/// Returns the least point of a cycle inside the tile if the cycle is the outside of its component.
fn outside(local: &Local, start: u32) -> Option<u32> {
    let least = local.along(start).map(|h| local.origin(h)).min()?;
    let (at, leaving) = (local.points[least as usize], local.leaving(least));
    // The direction straight left lies in the corner that this half-edge begins; a bounded face has nothing to the left.
    let upper = leaving.partition_point(|h| {
        let head = local.points[local.origin(h ^ 1) as usize];
        (at.y, at.x) < (head.y, head.x)
    });
    let first = leaving.get(upper.wrapping_sub(1)).or(leaving.last())?;
    local.along(start).any(|h| h == *first).then_some(least)
}

/// Returns the polygons that contain the part beyond an edge: a polygon that uses it an odd number of times begins or ends there.
fn across(local: &Local, segment: u32, covers: &[u32]) -> Vec<u32> {
    let uses = local.uses(segment).chunk_by(|a, b| a == b);
    let odd = uses.filter(|same| local.covers[same[0] as usize].is_polygon && same.len() % 2 == 1).map(|same| same[0]);
    // Both are in order.
    let (mut beyond, mut covers) = (Vec::with_capacity(covers.len() + 1), covers.iter().copied().peekable());
    for polygon in odd {
        beyond.extend(core::iter::from_fn(|| covers.next_if(|other| *other < polygon)));
        if covers.next_if_eq(&polygon).is_none() {
            beyond.push(polygon);
        }
    }
    beyond.extend(covers);
    beyond
}
