//! Further dimensions of points on new rings.

use super::super::model::{Feature, Geometry, Line, Position};
use super::restored::key;
use rustc_hash::FxHashMap;
use std::borrow::Cow;
use twinedge_geometry::Point;
use twinedge_geometry::noding::NodingSummary;

type Key = (u64, u64);
type Known = FxHashMap<Key, Box<[f64]>>;

pub(super) struct Further {
    /// The rounding of the points, if they were rounded.
    noding: Option<NodingSummary>,
    of_all: Known,
    of_feature: Known,
    /// The number of coordinates of the current feature's points beyond x and y, if it is equal for all.
    count: Option<usize>,
}

/// Records a point at its position and at its rounded position; the first of several at a position counts.
fn note(known: &mut Known, position: &Position, noding: Option<NodingSummary>) {
    known.entry(key(position.x, position.y)).or_insert_with(|| position.more.clone());
    if let Some(noding) = noding {
        let Point { x, y } = noding.snapped(Point::new(position.x, position.y));
        known.entry(key(x, y)).or_insert_with(|| position.more.clone());
    }
}

impl Further {
    /// Records the points of all features with further dimensions. O(points), expected.
    pub(super) fn new(features: &[Cow<'_, Feature>], noding: Option<NodingSummary>) -> Self {
        let mut of_all = Known::default();
        for geometry in features.iter().filter_map(|feature| feature.geometry.as_ref()) {
            geometry.shape.visit(&mut |position| {
                if !position.more.is_empty() {
                    note(&mut of_all, position, noding);
                }
            });
        }
        Self { noding, of_all, of_feature: Known::default(), count: None }
    }

    /// Switches to a feature, whose own points take precedence.
    pub(super) fn of_feature(&mut self, geometry: &Geometry) {
        self.of_feature.clear();
        self.count = None;
        if self.of_all.is_empty() {
            return;
        }
        let mut is_uniform = true;
        let (known, count, noding) = (&mut self.of_feature, &mut self.count, self.noding);
        geometry.shape.visit(&mut |position| {
            is_uniform &= *count.get_or_insert(position.more.len()) == position.more.len();
            note(known, position, noding);
        });
        match self.count {
            // Only the declared dimensions of the geometry are available.
            None => self.count = Some(geometry.dimensions.more()),
            Some(_) if !is_uniform => self.count = None,
            Some(_) => {}
        }
    }

    /// Returns the positions of a closed ring. O(points), expected.
    pub(super) fn line(&self, ring: &[Point]) -> Line {
        let known = |p: &Point| {
            let key = key(p.x, p.y);
            let fits = |numbers: usize| self.count.is_none_or(|count| count == numbers);
            let own = self.of_feature.get(&key);
            own.or_else(|| self.of_all.get(&key).filter(|more| fits(more.len()))).cloned()
        };
        let mut further: Vec<Option<Box<[f64]>>> = ring.iter().map(known).collect();
        match self.count {
            Some(count) if count > 0 => self.interpolate(ring, &mut further, count),
            _ => {}
        }
        ring.iter().zip(further).map(|(p, more)| Position { x: p.x, y: p.y, more: more.unwrap_or_default() }).collect()
    }

    /// Interpolates numbers of unknown points between their neighbours on the ring, by distance along it.
    fn interpolate(&self, ring: &[Point], further: &mut [Option<Box<[f64]>>], count: usize) {
        let places: Vec<usize> = (0..further.len()).filter(|i| further[*i].is_some()).collect();
        let (Some(first), Some(last)) = (places.first(), places.last()) else {
            // All points are new: use any point of the feature.
            let any = self.of_feature.values().next().cloned().unwrap_or_else(|| vec![0.0; count].into());
            further.fill(Some(any));
            return;
        };
        // The last point of the ring equals the first: the path continues after it.
        let steps = ring.len().saturating_sub(1).max(1);
        let wrapped = places.iter().copied().skip(1).chain([first + steps]);
        for (from, to) in places.iter().copied().zip(wrapped) {
            let length = |a: usize, b: usize| {
                let (p, q) = (ring[a % steps], ring[b % steps]);
                (q.x - p.x).hypot(q.y - p.y)
            };
            let whole: f64 = (from..to).map(|i| length(i, i + 1)).sum();
            let mut so_far = 0.0;
            for i in from + 1..to {
                so_far += length(i - 1, i);
                let part = if whole > 0.0 { so_far / whole } else { 0.0 };
                let ends = [from, to].map(|i| further[i % steps].clone().or_else(|| further[*last].clone()));
                let [Some(a), Some(b)] = ends else { continue };
                let between = a.iter().zip(&b).map(|(a, b)| a + (b - a) * part).collect();
                further[i % steps].get_or_insert(between);
            }
        }
        // The end repeats the start.
        if let [start, .., end] = further {
            end.clone_from(start);
        }
    }
}
