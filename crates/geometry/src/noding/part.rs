//! Noding of a part of a drawing, on the grid of the whole.
//!
//! The pixels that are hot in a part, and the visits of segments to them, depend on nothing outside. So parts find them one by
//! one, and together they have those of the whole. An edge between two hot pixels is bent by the hot pixels that it visits, in
//! whatever parts these lie: that takes another round, as soon as the edges are known.

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

/// The grid of [`Snap::Auto`] for a whole drawing, of which parts are noded.
#[derive(Clone, Copy, Debug)]
pub struct PartNoding {
    grid: Grid,
}

/// The cuts that a part knows of. Points are centres of pixels.
#[derive(Debug, Default)]
pub struct PartCuts {
    /// The hot pixels in which nothing ends.
    pub crossings: Vec<Point>,
    /// The segments that visit hot pixels between their ends, with these in order.
    pub chains: Vec<(usize, Vec<Point>)>,
    /// The segments whose way from centre to centre may visit pixels that they do not visit.
    pub doubtful: Vec<usize>,
}

impl PartNoding {
    /// The grid for coordinates up to `largest` in magnitude.
    ///
    /// # Errors
    /// [`NodingError::OutOfRange`], or that the number is not finite.
    pub fn new(largest: f64) -> Result<Self, NodingError> {
        let grid = |snap| Grid::new(snap, largest, Input::Point(0));
        let automatic = grid(Snap::Auto)?;
        // The predicates must be exact on grid points, too.
        let is_too_fine = automatic.cell() < MIN_COORDINATE;
        Ok(Self { grid: if is_too_fine { grid(Snap::Size(MIN_COORDINATE))? } else { automatic } })
    }

    /// The width of a cell.
    #[must_use]
    pub fn cell(&self) -> f64 {
        self.grid.cell()
    }

    fn pixel(&self, p: Point) -> Pixel {
        self.grid.pixels.at(self.grid.steps(p))
    }

    /// The centre of the pixel of a point.
    #[must_use]
    pub fn snapped(&self, p: Point) -> Point {
        self.grid.point(self.pixel(p))
    }

    /// Finds where segments cross or pass near vertices. Points are vertices, too.
    ///
    /// More than so many cuts are an error.
    ///
    /// # Errors
    /// [`NodingError::TooMany`], [`NodingError::TooManyCuts`].
    pub fn cuts(&self, segments: &[[Point; 2]], points: &[Point], most: usize) -> Result<PartCuts, NodingError> {
        if segments.len().saturating_mul(2).saturating_add(points.len()) >= u32::MAX as usize {
            return Err(NodingError::TooMany);
        }
        let read = Read::new(&self.grid, segments, points);
        let Runs { joined, of, .. } = runs::join(read.segments(&self.grid));
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

    /// Finds the hot pixels that edges visit, on their way from centre to centre, and which are not their ends. Edges do not cross.
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
