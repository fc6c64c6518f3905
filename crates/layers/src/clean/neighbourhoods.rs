//! Cleaning a layer of any size: only the features around faults are in memory, one neighbourhood at a time.
//!
//! ```text
//!   ┌───┬───┬───┬───┐     the features that something is wrong with are the core of a neighbourhood; its window is the
//!   │   │╔══╪══╗│   │     box around them. All features that meet the window are read and cleaned together: in the window
//!   ├───┼╫─A│B─╫┼───┤     the map is that of the whole layer. Whatever changes joins the core, and the window grows,
//!   │   │╚══╪══╝│   │     until nothing else changes. Neighbourhoods whose windows meet become one.
//!   └───┴───┴───┴───┘
//! ```
//!
//! *Why this equals cleaning the whole.* In the end windows are disjoint, and each contains the boxes of all features that change
//! in it. So a feature that meets a window but is not in its core does not change. Inside a window, all faces, their claims and
//! adjacent features equal those of the whole; gaps and slivers that reach out of it stay
//! ([`Options::window`](twinedge_coverage::clean::Options::window)). A gap to be filled lies in the box around its neighbours,
//! which are in the core, as its finding names them. The given limits apply to the whole, and so does the finest grid.
//!
//! *Exceptions.* Without a given area of slivers, cleaning the whole measures the parts of features anew in each round. If input
//! borders cross, the whole is cut on the finest grid everywhere, but here only neighbourhoods with crossings are; so points
//! within a cell of each other may merge there and stay distinct here.

use super::super::model::{Feature, Layer};
use super::extent::{Extent, around};
use super::{CleanError, CleanOptions, CleanReport, clean_part};
use rstar::primitives::{GeomWithData, Rectangle};
use rstar::{AABB, RTree};
use rustc_hash::FxHashMap;
use std::collections::BTreeSet;
use twinedge_geometry::Point;
use twinedge_geometry::noding::Snap;

/// The margin around windows, by the largest coordinate: 64 cells of the finest grid.
const MARGIN: f64 = 64.0 / Snap::AUTO_CELLS as f64;

/// Features that are read on demand.
pub trait Source {
    /// The error of reading or replacing a feature.
    type Error: From<CleanError>;

    /// Returns the extents of the polygons of all features, in order.
    fn extents(&self) -> &[Extent];

    /// Reads a feature in its original state.
    ///
    /// # Errors
    /// The error of the source.
    fn read(&mut self, number: usize) -> Result<Feature, Self::Error>;

    /// Replaces a feature, or restores its original state if `feature` is `None`.
    ///
    /// # Errors
    /// The error of the source.
    fn replace(&mut self, number: usize, feature: Option<&Feature>) -> Result<(), Self::Error>;
}

/// A neighbourhood with more vertices than allowed. Nothing in it was changed.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct TooLarge {
    /// The corners of the box around the features that would change.
    pub window: [Point; 2],
    /// The features that would change, and perhaps adjacent ones, by number.
    pub features: Vec<usize>,
    /// The number of vertices of all features that meet the box.
    pub vertices: u64,
}

/// A layer cleaned by its neighbourhoods.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Neighbourhoods {
    /// The report, without remaining findings: [`CleanReport::judge`] adds them. Changes are in order of their kinds and places.
    pub report: CleanReport,
    /// The number of cleaned neighbourhoods.
    pub cleaned: usize,
    /// The greatest number of vertices of one of them.
    pub largest: u64,
    /// The neighbourhoods that were not cleaned, by the place of their windows.
    pub too_large: Vec<TooLarge>,
}

/// Cleans a layer by its neighbourhoods. `concerned` are sets of features with a fault between them, by number; a neighbourhood
/// may have at most `most` vertices. The options must include an area of slivers; gaps go to neighbours, the width of gaps is not
/// chosen, and no grid may be requested.
///
/// Memory is O(features) for boxes, plus the cost of cleaning the largest neighbourhood. Time O(f log w) for f features and w
/// neighbourhoods, each time that windows grow, plus the time to clean the neighbourhoods.
///
/// ```
/// use twinedge_coverage::clean::Options;
/// use twinedge_layers::clean::{CleanError, CleanOptions, Extent, Source, clean_neighbourhoods};
/// use twinedge_layers::{Dimensions, Feature, Geometry, Position, Shape};
///
/// struct InMemory(Vec<Feature>, Vec<Extent>);
/// impl Source for InMemory {
///     type Error = CleanError;
///     fn extents(&self) -> &[Extent] { &self.1 }
///     fn read(&mut self, number: usize) -> Result<Feature, CleanError> { Ok(self.0[number].clone()) }
///     fn replace(&mut self, number: usize, feature: Option<&Feature>) -> Result<(), CleanError> {
///         if let Some(feature) = feature { self.0[number] = feature.clone(); }
///         Ok(())
///     }
/// }
///
/// // The second of three squares reaches half a unit into the first one.
/// let squares = [0.0, 9.5, 40.0].map(|x| {
///     let ring = [[x, 0.0], [x + 10.0, 0.0], [x + 10.0, 10.0], [x, 10.0], [x, 0.0]].map(|[x, y]| Position::new(x, y));
///     let shape = Shape::Polygon(vec![ring.to_vec()]);
///     Feature { geometry: Some(Geometry::new(Dimensions::Xy, shape)), ..Feature::default() }
/// });
/// let extents = squares.iter().map(Extent::of).collect();
/// let assign = Options { sliver_area: Some(0.1), ..Options::default() };
/// let options = CleanOptions { assign, ..CleanOptions::default() };
/// let done = clean_neighbourhoods(&mut InMemory(squares.into(), extents), &[vec![0, 1]], &options, u64::MAX)?;
/// assert_eq!((done.cleaned, done.largest, done.report.changes[0].area), (1, 10, 5.0));
/// # Ok::<(), CleanError>(())
/// ```
///
/// # Errors
/// The errors of the source, and of [`clean`](super::clean).
pub fn clean_neighbourhoods<S: Source>(
    source: &mut S,
    concerned: &[Vec<usize>],
    options: &CleanOptions,
    most: u64,
) -> Result<Neighbourhoods, S::Error> {
    let mut windows = Windows::new(source.extents());
    for features in concerned {
        drop(windows.add(source.extents(), features.iter().copied().collect()));
    }
    loop {
        let near = windows.features_near(source.extents());
        if near.is_empty() {
            break;
        }
        for (window, numbers) in near {
            let vertices: u64 = numbers.iter().map(|number| u64::from(source.extents()[*number].vertices)).sum();
            let Some(open) = windows.all.get_mut(&window) else { continue };
            if vertices > most {
                open.state = State::TooLarge(vertices);
                continue;
            }
            let features = numbers.iter().map(|number| source.read(*number)).collect::<Result<_, _>>()?;
            let mut layer = Layer { features, ..Layer::default() };
            let mut asked = options.clone();
            asked.assign.window = Some(grown(open.corners, windows.largest));
            let mut report = clean_part(&mut layer, &asked, windows.largest)?;
            renumber(&mut report, &numbers);
            let fresh: BTreeSet<usize> =
                report.touched().into_iter().filter(|number| !open.core.contains(number)).collect();
            if fresh.is_empty() {
                for change in &report.features {
                    let place = numbers.binary_search(&change.feature).ok();
                    source.replace(change.feature, place.and_then(|place| layer.features.get(place)))?;
                }
                open.state = State::Cleaned(Box::new(report), vertices);
                continue;
            }
            let grown = windows.remove(window).into_iter().flat_map(|window| window.core).chain(fresh).collect();
            for number in windows.add(source.extents(), grown) {
                source.replace(number, None)?;
            }
        }
    }
    Ok(windows.finish(source.extents(), options))
}

enum State {
    Open,
    Cleaned(Box<CleanReport>, u64),
    TooLarge(u64),
}

struct Window {
    /// The features that change, and the faulty ones.
    core: BTreeSet<usize>,
    corners: [Point; 2],
    state: State,
}

type Known = GeomWithData<Rectangle<[f64; 2]>, usize>;

/// The disjoint windows of all neighbourhoods.
struct Windows {
    all: FxHashMap<usize, Window>,
    tree: RTree<Known>,
    largest: f64,
    next: usize,
}

impl Windows {
    fn new(extents: &[Extent]) -> Self {
        Self { all: FxHashMap::default(), tree: RTree::new(), largest: Extent::largest(extents), next: 0 }
    }

    /// Adds a window around some features, joined with all windows that it meets. Returns the features that these had changed.
    fn add(&mut self, extents: &[Extent], mut core: BTreeSet<usize>) -> Vec<usize> {
        let mut changed = Vec::new();
        let Some(mut corners) = around(core.iter().filter_map(|number| extents[*number].corners)) else {
            return changed;
        };
        while let Some(window) = self.met_by(corners).and_then(|number| self.remove(number)) {
            if let State::Cleaned(report, _) = &window.state {
                changed.extend(report.features.iter().map(|change| change.feature));
            }
            corners = around([corners, window.corners].into_iter()).unwrap_or(corners);
            core.extend(window.core);
        }
        self.tree.insert(known(corners, self.next));
        self.all.insert(self.next, Window { core, corners, state: State::Open });
        self.next += 1;
        changed
    }

    /// Returns a window that meets a box, apart from the margin.
    fn met_by(&self, corners: [Point; 2]) -> Option<usize> {
        self.tree.locate_in_envelope_intersecting(envelope(grown(corners, self.largest))).next().map(|met| met.data)
    }

    fn remove(&mut self, number: usize) -> Option<Window> {
        let window = self.all.remove(&number)?;
        self.tree.remove(&known(window.corners, number));
        Some(window)
    }

    /// Returns, for each uncleaned window, the features that meet it, in order.
    fn features_near(&self, extents: &[Extent]) -> Vec<(usize, Vec<usize>)> {
        let open = self.all.iter().filter(|(_, window)| matches!(window.state, State::Open));
        let tree = RTree::bulk_load(
            open.map(|(number, window)| known(grown(window.corners, self.largest), *number)).collect(),
        );
        let mut near: FxHashMap<usize, Vec<usize>> = FxHashMap::default();
        if tree.size() > 0 {
            for (number, corners) in (0..).zip(extents).filter_map(|(number, it)| Some((number, it.corners?))) {
                for met in tree.locate_in_envelope_intersecting(envelope(corners)) {
                    near.entry(met.data).or_default().push(number);
                }
            }
        }
        let mut near: Vec<(usize, Vec<usize>)> = near.into_iter().collect();
        near.sort_unstable();
        near
    }

    fn finish(self, extents: &[Extent], options: &CleanOptions) -> Neighbourhoods {
        let mut all: Vec<(usize, Window)> = self.all.into_iter().collect();
        all.sort_by(|(i, a), (j, b)| compare(a.corners[0], b.corners[0]).then(i.cmp(j)));
        let mut done = Neighbourhoods {
            report: CleanReport {
                polygons: extents.iter().filter(|extent| extent.corners.is_some()).count(),
                sliver_area: options.assign.sliver_area.unwrap_or_default(),
                gap_width: options.assign.gap_width,
                ..CleanReport::default()
            },
            cleaned: 0,
            largest: 0,
            too_large: Vec::new(),
        };
        for (_, Window { core, corners, state }) in all {
            match state {
                State::Cleaned(report, vertices) => {
                    done.cleaned += 1;
                    done.largest = done.largest.max(vertices);
                    done.report.append(*report);
                }
                State::TooLarge(vertices) => {
                    let features = core.into_iter().collect();
                    done.too_large.push(TooLarge { window: corners, features, vertices });
                }
                State::Open => {}
            }
        }
        done.report.sort();
        done
    }
}

fn known([low, high]: [Point; 2], number: usize) -> Known {
    GeomWithData::new(Rectangle::from_corners([low.x, low.y], [high.x, high.y]), number)
}

fn envelope([low, high]: [Point; 2]) -> AABB<[f64; 2]> {
    AABB::from_corners([low.x, low.y], [high.x, high.y])
}

/// Returns a box with the margin for this largest coordinate: points in it may move by a cell.
fn grown([low, high]: [Point; 2], largest: f64) -> [Point; 2] {
    let margin = largest * MARGIN;
    [Point::new(low.x - margin, low.y - margin), Point::new(high.x + margin, high.y + margin)]
}

fn compare(a: Point, b: Point) -> std::cmp::Ordering {
    twinedge_geometry::predicates::compare_lexicographic(a, b)
}

/// Replaces the numbers of features in a part by their numbers in the whole.
fn renumber(report: &mut CleanReport, numbers: &[usize]) {
    for change in &mut report.changes {
        for number in change.from.iter_mut().chain(&mut change.to) {
            *number = numbers[*number];
        }
    }
    for vertex in &mut report.added {
        vertex.to = numbers[vertex.to];
        vertex.of = numbers[vertex.of];
    }
    for change in &mut report.features {
        change.feature = numbers[change.feature];
    }
}
