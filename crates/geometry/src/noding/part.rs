//! Noding a part of a drawing, on the grid of the whole.
//!
//! The hot pixels of a part, and the visits of segments to them, do not depend on anything outside. So parts find them
//! separately, and together they have all of the whole. An edge between two hot pixels is bent by the hot pixels that it visits,
//! possibly in other parts: that takes another round once the edges are known.

use super::chains::Chains;
use super::grid::Grid;
use super::input::{Input, NodingError, Snap};
use super::pixel::{Pixel, Pixels, Segment};
use super::read::Read;
use super::runs::{self, Runs};
use super::search::search;
use crate::point::Point;
use crate::predicates::MIN_COORDINATE;
use rustc_hash::FxHashMap;

/// The grid of [`Snap::Auto`] for a whole drawing that is noded in parts.
#[derive(Clone, Copy, Debug)]
pub struct PartNoding {
    grid: Grid,
}

/// The cuts known to a part. Points are centres of pixels.
#[derive(Debug, Default)]
pub struct PartCuts {
    /// The hot pixels without any ends.
    pub crossings: Vec<Point>,
    /// The segments that visit hot pixels between their ends, with these pixels in order.
    pub chains: Vec<(usize, Vec<Point>)>,
    /// The segments whose line between pixel centres may visit other pixels than the segment.
    pub doubtful: Vec<usize>,
}

impl PartNoding {
    /// Creates the grid for coordinates up to `largest` in magnitude.
    ///
    /// # Errors
    /// [`NodingError::OutOfRange`], also if the number is not finite.
    pub fn new(largest: f64) -> Result<Self, NodingError> {
        let grid = |snap| Grid::new(snap, largest, Input::Point(0));
        let automatic = grid(Snap::Auto)?;
        // The predicates must also be exact on grid points.
        let is_too_fine = automatic.cell() < MIN_COORDINATE;
        Ok(Self { grid: if is_too_fine { grid(Snap::Size(MIN_COORDINATE))? } else { automatic } })
    }

    /// Returns the width of a cell.
    #[must_use]
    pub fn cell(&self) -> f64 {
        self.grid.cell()
    }

    fn pixel(&self, p: Point) -> Pixel {
        self.grid.pixels.at(self.grid.steps(p))
    }

    /// Returns the centre of the pixel of a point.
    #[must_use]
    pub fn snapped(&self, p: Point) -> Point {
        self.grid.point(self.pixel(p))
    }

    /// Finds where segments cross or pass near vertices, including `points`.
    ///
    /// Returns an error if there are more than `most` cuts.
    ///
    /// # Errors
    /// [`NodingError::TooMany`], [`NodingError::TooManyCuts`].
    pub fn cuts(&self, segments: &[[Point; 2]], points: &[Point], most: usize) -> Result<PartCuts, NodingError> {
        if segments.len().saturating_mul(2).saturating_add(points.len()) >= u32::MAX as usize {
            return Err(NodingError::TooMany);
        }
        let read = Read::new(&self.grid, segments, points);
        let Runs { joined, of, .. } = runs::join(read.segments());
        let mut vertices = read.vertices.clone();
        let found = search(self.grid.pixels, &joined, &mut vertices, most)?;
        let mut is_doubtful = vec![false; joined.len()];
        found.doubtful.iter().for_each(|run| is_doubtful[*run as usize] = true);
        let runs = Chains::through(&joined, &vertices, found.visits);
        let centre = |v: &u32| self.grid.point(vertices[*v as usize]);
        let mut cuts = PartCuts {
            crossings: vertices[read.vertices.len()..].iter().map(|pixel| self.grid.point(*pixel)).collect(),
            ..PartCuts::default()
        };
        let mut of = of.into_iter().map(|run| run as usize);
        for (segment, [from, to]) in read.ends().enumerate() {
            let Some(run) = (if from == to { None } else { of.next() }) else { continue };
            if is_doubtful[run] {
                cuts.doubtful.push(segment);
            }
            let [i, j] = [from, to].map(|end| runs.place(run, &joined[run], &vertices, end));
            let between = &runs.pool()[i.min(j) + 1..i.max(j)];
            if !between.is_empty() {
                let forth = between.iter().map(centre);
                cuts.chains.push((segment, if i < j { forth.collect() } else { forth.rev().collect() }));
            }
        }
        Ok(cuts)
    }

    /// Finds the hot pixels that edges visit between their end pixels, going from centre to centre. Edges must not cross.
    ///
    /// # Errors
    /// [`NodingError::TooManyCuts`].
    pub fn bends(
        &self,
        edges: &[[Point; 2]],
        hot: &[Point],
        most: usize,
    ) -> Result<Vec<(usize, Vec<Point>)>, NodingError> {
        let mut vertices: Vec<Pixel> = Vec::new();
        let mut numbers: FxHashMap<Pixel, u32> = FxHashMap::default();
        let mut number = |p: Point| {
            let pixel = self.pixel(p);
            *numbers.entry(pixel).or_insert_with(|| {
                vertices.push(pixel);
                vertices.len() as u32 - 1
            })
        };
        let ends: Vec<[u32; 2]> = edges.iter().map(|edge| edge.map(&mut number)).collect();
        for p in hot {
            number(*p);
        }
        let segment = |ends: &[u32; 2]| Segment::between(&vertices, *ends);
        let segments: Vec<Segment> = ends.iter().map(segment).collect();
        let found = search(Pixels::ONE_STEP, &segments, &mut vertices, most)?;
        let chains = Chains::through(&segments, &vertices, found.visits);
        let bent = chains.all().enumerate().filter(|(_, chain)| chain.len() > 2);
        let centre = |v: &u32| self.grid.point(vertices[*v as usize]);
        Ok(bent.map(|(edge, chain)| (edge, chain[1..chain.len() - 1].iter().map(centre).collect())).collect())
    }
}
