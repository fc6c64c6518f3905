//! The part of a map that lies in a tile.

use super::NIL;
use super::bounds::{Bounds, Crossings, compare_along};
use super::cuts::Cuts;
use super::ends::{Ends, compare_edges, compare_points, in_order};
use super::fault::{Crossing, CrossingKind};
use super::piece::{Piece, edges};
use super::side::Side;
use twinedge::dcel::RecordKind;
use twinedge_geometry::crossing::{Clash, clashes};
use twinedge_geometry::predicates::compare_angle;
use twinedge_geometry::sweep::{Below, sweep_all};
use twinedge_geometry::{Point, threads};
use twinedge_map::BuildError;

/// An edge that meets the tile. Its half-edges are numbered twice its number, from its smaller end, and that plus one.
pub(super) struct Segment {
    pub(super) ends: Ends,
    /// Its place in the order of the map.
    place: u32,
    /// The contacts where the first half-edge enters and leaves the tile.
    pub(super) entry: Option<u32>,
    pub(super) exit: Option<u32>,
}

/// An edge as a part of a feature uses it, and the sides of the tile where it enters and leaves.
struct Use {
    ends: Ends,
    sides: [Option<Side>; 2],
    part: u32,
    place: u32,
}

/// A part of a feature, and whether it contains the lower left corner of the tile.
pub(super) struct Cover {
    pub(super) feature: u32,
    pub(super) is_polygon: bool,
    pub(super) has_corner: bool,
}

pub(super) struct Cycles {
    /// For each contact, the contact where the half-edge that enters there leaves again.
    pub(super) leaves: Vec<u32>,
    /// The first half-edge of each cycle that no border cuts.
    pub(super) closed: Vec<u32>,
}

/// The edges of pieces that meet a tile, and the vertices in it.
pub(super) struct Local {
    pub(super) bounds: Bounds,
    /// Distinct, in order: the ends of edges, some of them outside, and isolated vertices.
    pub(super) points: Vec<Point>,
    /// Distinct, in order.
    pub(super) segments: Vec<Segment>,
    ends: Vec<[u32; 2]>,
    /// The parts of features, and the parts that use each edge, in order, once for each use.
    pub(super) covers: Vec<Cover>,
    uses: Lists,
    /// The half-edges that leave each point, counter-clockwise from the positive x axis.
    leaving: Lists,
    next: Vec<u32>,
    pub(super) below: Below,
    pub(super) is_plane: bool,
    /// The contacts counter-clockwise from the lower left corner: the side, the segment, true if its first half-edge enters.
    pub(super) contacts: Vec<(Side, u32, bool)>,
}

/// Lists of numbers, one after another.
struct Lists {
    first: Vec<u32>,
    all: Vec<u32>,
}

impl Lists {
    fn of(&self, i: u32) -> &[u32] {
        &self.all[self.first[i as usize] as usize..self.first[i as usize + 1] as usize]
    }

    /// Files each item under its list, in order. O(items + lists).
    fn new(lists: usize, items: impl Iterator<Item = (u32, u32)> + Clone) -> Self {
        // After summation, `first[i + 1]` is the start of list i; filing moves it to the end of the list.
        let mut first = vec![0_u32; lists + 2];
        for (list, _) in items.clone() {
            first[list as usize + 2] += 1;
        }
        for i in 1..first.len() {
            first[i] += first[i - 1];
        }
        let mut all = vec![0; first[lists + 1] as usize];
        for (list, item) in items {
            let place = &mut first[list as usize + 1];
            all[*place as usize] = item;
            *place += 1;
        }
        Self { first, all }
    }
}

impl Local {
    /// Draws pieces in a tile, with their edges cut if there are cuts. O(n log n).
    pub(super) fn new(pieces: &[&Piece], bounds: Bounds, cuts: Option<&Cuts>) -> Result<Self, BuildError> {
        let (mut covers, mut drawn, mut alone) = (Vec::new(), Vec::new(), Vec::new());
        for piece in pieces {
            for part in &piece.parts {
                let number = covers.len() as u32;
                let mut has_corner = part.has_corner;
                for chain in &part.chains {
                    let cut = cuts.map(|cuts| cuts.cut(chain));
                    if let Some(cut) = cut.as_ref().filter(|_| part.is_polygon) {
                        // Cutting moved the edges across the corner if it lies between the old chain and the new one.
                        let around: Vec<Point> = chain.iter().chain(cut.iter().rev()).copied().collect();
                        has_corner ^= bounds.has_corner_in(&around);
                    }
                    let chain = cut.as_ref().unwrap_or(chain);
                    let before = drawn.len();
                    drawn.extend(edges(chain).map(|ends| (in_order(ends), number)));
                    if drawn.len() == before {
                        alone.extend(chain.first());
                    }
                }
                covers.push(Cover { feature: piece.feature, is_polygon: part.is_polygon, has_corner });
            }
        }
        let mut met: Vec<Use> = Vec::with_capacity(drawn.len());
        for (ends, part) in drawn {
            let Crossings { entry, exit } = bounds.crossings(ends);
            if entry.is_some() || exit.is_some() || bounds.contains(ends[0]) {
                met.push(Use { ends, sides: [entry, exit], part, place: met.len() as u32 });
            }
        }
        threads::sort_unstable_by(&mut met, |a, b| compare_edges(&a.ends, &b.ends).then(a.place.cmp(&b.place)));
        alone.retain(|p| bounds.contains(*p));
        let mut points: Vec<Point> = met.iter().flat_map(|one| one.ends).chain(alone).collect();
        threads::sort_unstable_by(&mut points, |a, b| compare_points(*a, *b));
        points.dedup();
        let mut sides: [Vec<(u32, bool)>; 4] = Default::default();
        let (mut segments, mut ends, mut first) = (Vec::new(), Vec::new(), vec![0]);
        for same in met.chunk_by(|a, b| a.ends == b.ends) {
            let Use { ends: between, sides: met_at, place, .. } = same[0];
            let number = segments.len() as u32;
            for (side, is_entry) in met_at.into_iter().zip([true, false]) {
                if let Some(side) = side {
                    sides[side as usize].push((number, is_entry));
                }
            }
            let at = |p: Point| points.binary_search_by(|q| compare_points(*q, p)).unwrap_or_default() as u32;
            segments.push(Segment { ends: between, place, entry: None, exit: None });
            ends.push(between.map(at));
            first.push(first.last().unwrap_or(&0) + same.len() as u32);
        }
        let uses = Lists { first, all: met.into_iter().map(|one| one.part).collect() };
        let swept = sweep_all(&points, &ends).map_err(|_| BuildError::Full(RecordKind::Vertex))?;
        let darts = (0..).zip(ends.as_flattened()).map(|(dart, from)| (*from, dart));
        let leaving = Lists::new(points.len(), darts);
        let mut local = Self {
            bounds,
            next: vec![NIL; 2 * segments.len()],
            is_plane: swept.1.is_none(),
            below: swept.0,
            points,
            segments,
            ends,
            covers,
            uses,
            leaving,
            contacts: Vec::new(),
        };
        local.link();
        local.touch(sides);
        Ok(local)
    }

    /// Sorts the rotations, and finds the half-edge after each.
    fn link(&mut self) {
        for v in 0..self.points.len() {
            let range = self.leaving.first[v] as usize..self.leaving.first[v + 1] as usize;
            let (at, points, ends) = (self.points[v], &self.points, &self.ends);
            let head = |h: &u32| points[ends[(h >> 1) as usize][1 - (h & 1) as usize] as usize];
            let leaving = &mut self.leaving.all[range];
            // Of edges that overlap, the first of the map comes first, as in the map.
            let place = |h: &u32| self.segments[(h >> 1) as usize].place;
            threads::sort_unstable_by(leaving, |a, b| {
                compare_angle(at, head(a), head(b)).then(place(a).cmp(&place(b)))
            });
            // The next half-edge after one that arrives is the one clockwise of its twin.
            let Some(mut clockwise) = leaving.last().copied() else { continue };
            for h in &*leaving {
                self.next[(h ^ 1) as usize] = clockwise;
                clockwise = *h;
            }
        }
    }

    /// Sorts the contacts around the tile.
    fn touch(&mut self, sides: [Vec<(u32, bool)>; 4]) {
        for (side, mut along) in Side::ALL.into_iter().zip(sides) {
            let ends = |segment: u32| self.segments[segment as usize].ends;
            if self.is_plane {
                along.sort_by(|a, b| compare_along(side, ends(a.0), ends(b.0)));
            }
            if matches!(side, Side::Top | Side::Left) {
                along.reverse();
            }
            self.contacts.extend(along.into_iter().map(|(segment, is_entry)| (side, segment, is_entry)));
        }
        for (contact, (_, segment, is_entry)) in (0..).zip(&self.contacts) {
            let segment = &mut self.segments[*segment as usize];
            *(if *is_entry { &mut segment.entry } else { &mut segment.exit }) = Some(contact);
        }
    }

    /// Returns the points in the tile, by number.
    pub(super) fn inside(&self) -> impl Iterator<Item = (u32, Point)> + '_ {
        (0..).zip(self.points.iter().copied()).filter(|(_, p)| self.bounds.contains(*p))
    }

    /// Returns the number of a point.
    pub(super) fn number(&self, p: Point) -> Option<u32> {
        self.points.binary_search_by(|q| compare_points(*q, p)).ok().map(|number| number as u32)
    }

    pub(super) fn origin(&self, h: u32) -> u32 {
        self.ends[(h >> 1) as usize][(h & 1) as usize]
    }

    pub(super) fn next(&self, h: u32) -> u32 {
        self.next[h as usize]
    }

    pub(super) fn leaving(&self, point: u32) -> &[u32] {
        self.leaving.of(point)
    }

    /// Returns the parts that use an edge, once for each use.
    pub(super) fn uses(&self, segment: u32) -> &[u32] {
        self.uses.of(segment)
    }

    pub(super) fn entering(&self, contact: u32) -> u32 {
        let (_, segment, is_entry) = self.contacts[contact as usize];
        segment << 1 | u32::from(!is_entry)
    }

    /// Returns the contact at which a half-edge leaves the tile, if it does.
    pub(super) fn leaves_at(&self, h: u32) -> Option<u32> {
        let segment = &self.segments[(h >> 1) as usize];
        if h & 1 == 0 { segment.exit } else { segment.entry }
    }

    /// Returns the numbers of the features along an edge.
    pub(super) fn features_along(&self, segment: u32) -> Vec<u32> {
        let mut features: Vec<u32> =
            self.uses(segment).iter().map(|part| self.covers[*part as usize].feature).collect();
        features.sort_unstable();
        features.dedup();
        features
    }

    /// Returns the pairs of edges that meet other than at shared endpoints.
    pub(super) fn crossings(&self) -> Vec<Crossing> {
        if self.is_plane {
            return Vec::new();
        }
        let ends = |segment: u32| self.segments[segment as usize].ends;
        let along = |segment: u32| self.features_along(segment);
        let crossing = |clash: Clash| {
            let (kind, a, b, mut features) = match clash {
                Clash::Cross { a, b } => (CrossingKind::Cross, ends(a), ends(b), [along(a), along(b)].concat()),
                Clash::Overlap { a, b } => (CrossingKind::Overlap, ends(a), ends(b), [along(a), along(b)].concat()),
                Clash::Touch { vertex, segment } => {
                    let at = self.points[vertex as usize];
                    // The tile of a vertex knows the edges that end at it.
                    if !self.bounds.contains(at) {
                        return None;
                    }
                    let at_vertex = self.leaving(vertex).iter().flat_map(|h| along(h >> 1));
                    (CrossingKind::Touch, [at; 2], ends(segment), at_vertex.chain(along(segment)).collect())
                }
                Clash::SamePlace { .. } => return None,
            };
            features.sort_unstable();
            features.dedup();
            let is_in_order = kind == CrossingKind::Touch || compare_edges(&a, &b).is_le();
            let [first, second] = if is_in_order { [a, b] } else { [b, a] };
            Some(Crossing { kind, first, second, features })
        };
        let (found, _) = clashes(&self.points, &self.ends, usize::MAX).unwrap_or_default();
        found.into_iter().filter_map(crossing).collect()
    }

    /// O(half-edges).
    pub(super) fn trace(&self) -> Cycles {
        let mut is_passed = vec![false; self.next.len()];
        let mut leaves = Vec::with_capacity(self.contacts.len());
        for contact in 0..self.contacts.len() as u32 {
            let mut h = self.entering(contact);
            loop {
                is_passed[h as usize] = true;
                if let Some(contact) = self.leaves_at(h) {
                    leaves.push(contact);
                    break;
                }
                h = self.next(h);
            }
        }
        let mut closed = Vec::new();
        for start in 0..self.next.len() as u32 {
            if !is_passed[start as usize] {
                closed.push(start);
            }
            let mut h = start;
            while !is_passed[h as usize] {
                is_passed[h as usize] = true;
                h = self.next(h);
            }
        }
        Cycles { leaves, closed }
    }

    /// Returns the half-edges of a cycle, up to where it leaves the tile.
    pub(super) fn along(&self, start: u32) -> impl Iterator<Item = u32> + '_ {
        let next = move |h: &u32| {
            let next = self.next(*h);
            (next != start && self.leaves_at(*h).is_none()).then_some(next)
        };
        core::iter::successors(Some(start), next)
    }
}
