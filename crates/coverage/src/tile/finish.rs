//! The audit of the whole map, from the summaries of all tiles.

use super::error::FinishError;
use super::fault::{Crossing, SeamFault, Uneven};
use super::findings::coverage;
use super::summary::Summary;
use crate::{Coverage, Defect};
use twinedge::validate::{Bounds, Counts, Rule, RuleOutcome, Unchecked, Violation};
use twinedge_geometry::Point;
use twinedge_map::BuildError;

/// The audit of a map by its tiles.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Outcome {
    /// The numbers of records.
    pub counts: Counts,
    /// The least and the greatest corner of the box around the features; `None` if there are none.
    pub corners: Option<[Point; 2]>,
    /// The number of polygon edges by extent, the greater of their extents in x and y: sorted pairs of the exponent, in the bit
    /// format of a double, and the number. An edge counts each time it is drawn.
    pub extents: Vec<(u16, u64)>,
    /// Pairs of edges that meet other than at a shared endpoint (G4).
    pub crossings: Vec<Crossing>,
    /// The components for which `V − E + cycles` is not 2 (T3).
    pub uneven: Vec<Uneven>,
    /// The places where two tiles contradict each other (S1 … S3).
    pub seams: Vec<SeamFault>,
    /// The findings of C1 … C5 and C7. `None` if the extents of features are unknown, since tiles contradict each other, or edges
    /// meet other than at vertices and were not cut.
    pub coverage: Option<Coverage>,
    /// The reason why edges that meet other than at vertices could not be cut, if cutting failed.
    pub uncut: Option<BuildError>,
    /// The features whose shapes are invalid by the rules of the OGC (C6), by number.
    pub defects: Vec<(u32, Vec<Defect>)>,
    /// The features without points, by number.
    pub without_geometry: Vec<u32>,
    /// The features whose geometries could not be read, by number, and why; they are no part of the map.
    pub unreadable: Vec<(u32, String)>,
    /// Features whose pieces were not all given to their tiles, or that share a number with another feature.
    pub not_given: Vec<u32>,
    /// False if `V − E + F = 1 + C` does not hold for the sums, or for not exactly one unbounded face (T3); `None` if faces are
    /// unknown.
    pub adds_up: Option<bool>,
}

impl Outcome {
    /// Returns true if the whole map is a valid planar subdivision.
    #[must_use]
    pub fn is_valid(&self) -> bool {
        self.crossings.is_empty()
            && self.uneven.is_empty()
            && self.seams.is_empty()
            && self.not_given.is_empty()
            && self.adds_up == Some(true)
    }
}

impl Outcome {
    /// Returns the outcome with the coverage of the cut map, if edges meet other than at vertices and tiles do not contradict
    /// each other.
    #[must_use]
    pub fn with_cut(self, cut: Self) -> Self {
        if self.needs_cut() { Self { coverage: cut.coverage, ..self } } else { self }
    }

    /// Returns true if cutting edges where they meet would determine the extents of features.
    #[must_use]
    pub fn needs_cut(&self) -> bool {
        !self.crossings.is_empty() && self.seams.is_empty() && self.not_given.is_empty()
    }

    /// Returns the outcomes of R1 … G5, as in the report of the whole map. Building from features guarantees some of them.
    pub fn rules(&self) -> impl Iterator<Item = (Rule, RuleOutcome)> + use<> {
        let Counts { vertices, half_edges, edges, faces, outer_boundaries, inner_boundaries, .. } = self.counts;
        let isolated = self.counts.isolated_vertices;
        // Tiles together may have more records than a small machine's `usize` can count.
        let sum = |numbers: &[usize]| numbers.iter().fold(0, |sum: usize, n| sum.saturating_add(*n));
        let boundaries = sum(&[outer_boundaries, inner_boundaries]);
        let links = sum(&[half_edges.saturating_mul(5), vertices, boundaries, boundaries, faces, inner_boundaries]);
        let (uneven, crossings) = (self.uneven.len(), self.crossings.len());
        let broken = [(uneven, Rule::T3), (crossings, Rule::G4)].into_iter().find(|(count, _)| *count > 0);
        let simple = vertices >= 3;
        let over = self.too_many().len();
        Rule::ALL.iter().copied().filter_map(move |rule| {
            let (checked, violations) = match rule {
                Rule::R1 => (links, 0),
                Rule::L1 | Rule::L2 | Rule::L3 | Rule::B1 => (half_edges, 0),
                Rule::V1 | Rule::V2 | Rule::G2 => (vertices.saturating_sub(isolated), 0),
                Rule::B2 | Rule::G1 => (vertices, 0),
                Rule::F1 => (faces, 0),
                Rule::F2 => (boundaries, 0),
                Rule::T1 | Rule::T2 | Rule::G5 => (inner_boundaries, 0),
                Rule::T3 => (inner_boundaries, uneven),
                Rule::T4 => (usize::from(simple), over),
                Rule::G3 => (boundaries.saturating_sub(isolated), 0),
                Rule::G4 => (edges, crossings),
                _ => return None,
            };
            let unchecked = match (rule, broken) {
                (Rule::T4, _) if !simple => Some(Unchecked::NotSimple),
                (Rule::G3 | Rule::G5, Some((_, broken))) => Some(Unchecked::Broken(broken)),
                _ => None,
            };
            let checked = if unchecked.is_some() { 0 } else { checked as u64 };
            Some((rule, RuleOutcome { checked, violations: violations as u64, unchecked }))
        })
    }

    /// Returns the violations of T4: more edges or faces than a simple map can have.
    #[must_use]
    pub fn too_many(&self) -> Vec<Violation> {
        let Counts { vertices, edges, faces, .. } = self.counts;
        let Some(Bounds { most_edges, most_faces }) = self.bounds() else { return Vec::new() };
        let of_edges = (edges > most_edges).then_some(Violation::TooManyEdges { vertices, edges });
        let of_faces = (faces > most_faces).then_some(Violation::TooManyFaces { vertices, faces });
        of_edges.into_iter().chain(of_faces).collect()
    }

    /// Returns the greatest numbers of edges and faces by T4, if it applies.
    #[must_use]
    pub fn bounds(&self) -> Option<Bounds> {
        let vertices = self.counts.vertices;
        let most = |times: usize| vertices.saturating_mul(times) - 2 * times;
        (vertices >= 3).then(|| Bounds { most_edges: most(3), most_faces: most(2) })
    }
}

impl Summary {
    fn missing(&self) -> Result<(), FinishError> {
        let count = self.grid.len().saturating_sub(self.tiles.len()) as u64;
        match self.grid.tiles().find(|tile| self.tiles.binary_search(tile).is_err()) {
            Some(first) => Err(FinishError::Missing { first, count }),
            None => Ok(()),
        }
    }

    /// Completes the audit of the whole, from the summary of all its tiles. O(tiles log tiles).
    ///
    /// ```
    /// use twinedge_coverage::Limits;
    /// use twinedge_map::{Feature, Shape};
    /// use twinedge_coverage::tile::{Cuts, FinishError, Grid, Summary};
    ///
    /// let grid = Grid::new([0.0, 0.0], [4.0, 4.0], 2, 2)?;
    /// let square = Shape::polygon([[1.0, 1.0], [3.0, 1.0], [3.0, 3.0], [1.0, 3.0]]);
    /// let pieces = Cuts::new(4.0)?.pieces(&grid, 0, &Feature { shapes: vec![square], ..Feature::default() })?;
    /// let mut tiles = grid.tiles().map(|tile| Summary::new(&grid, tile, &pieces, &Limits::default()));
    /// let first = tiles.next().unwrap()?;
    /// assert!(matches!(first.clone().finish(), Err(FinishError::Missing { count: 3, .. })));
    /// let whole = tiles.try_fold(first, |sum, tile| Ok::<_, Box<dyn std::error::Error>>(sum.merge(tile?)?))?;
    /// let outcome = whole.finish()?;
    /// assert!(outcome.is_valid());
    /// assert_eq!((outcome.counts.vertices, outcome.counts.edges, outcome.counts.faces), (4, 4, 2));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`FinishError::Missing`].
    pub fn finish(mut self) -> Result<Outcome, FinishError> {
        self.missing()?;
        let totals = self.totals;
        let number = |n: u64| usize::try_from(n).unwrap_or(usize::MAX);
        let with_edges = totals.components.saturating_sub(totals.isolated_vertices);
        // Each component has one outside cycle, and each other cycle bounds a face.
        let bounded = totals.cycles.saturating_sub(with_edges);
        let adds_up = self.is_plane.then(|| totals.faces == bounded + 1 && totals.unbounded_faces == 1);
        let genus =
            self.uneven.iter().map(Uneven::genus).try_fold(0_u64, |sum, genus| Some(sum.saturating_add(genus?)));
        let counts = Counts {
            vertices: number(totals.vertices),
            half_edges: number(totals.edges.saturating_mul(2)),
            edges: number(totals.edges),
            faces: number(if self.is_plane { totals.faces } else { bounded + 1 }),
            outer_boundaries: number(bounded),
            inner_boundaries: number(totals.components),
            isolated_vertices: number(totals.isolated_vertices),
            components: Some(number(totals.components)),
            cycles: Some(number(totals.cycles)),
            borders: Some(0),
            genus: genus.map(number),
        };
        let incomplete = self.claimed.iter().filter(|one| one.seen != one.of);
        let mut not_given: Vec<u32> = incomplete.map(|one| one.feature).collect();
        not_given.dedup();
        let mut seams = [&self.seams[..], &self.plane_seams].concat();
        seams.sort_by(SeamFault::compare);
        let absent = core::mem::take(&mut self.absent);
        let is_known = self.is_plane && seams.is_empty() && not_given.is_empty();
        Ok(Outcome {
            counts,
            corners: self.corners,
            coverage: is_known.then(|| coverage(&self)),
            extents: self.extents,
            uncut: None,
            not_given,
            without_geometry: absent.iter().filter(|(_, why)| why.is_none()).map(|(feature, _)| *feature).collect(),
            unreadable: absent.into_iter().filter_map(|(feature, why)| Some((feature, why?))).collect(),
            defects: self.defects,
            crossings: self.crossings,
            uneven: self.uneven,
            seams,
            adds_up,
        })
    }
}
