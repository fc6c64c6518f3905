//! Cleaning adjacent neighbourhoods one after the other equals cleaning the whole layer.

use twinedge_coverage::clean::{Options, Winner};
use twinedge_layers::clean::{CleanError, CleanOptions, Extent, Neighbourhoods, Source, clean, clean_neighbourhoods};
use twinedge_layers::{Dimensions, Feature, Geometry, Layer, Position, Shape};

/// The features before and after cleaning.
struct Kept {
    before: Vec<Feature>,
    now: Vec<Feature>,
    extents: Vec<Extent>,
}

impl Source for Kept {
    type Error = CleanError;

    fn extents(&self) -> &[Extent] {
        &self.extents
    }

    fn read(&mut self, number: usize) -> Result<Feature, CleanError> {
        Ok(self.before[number].clone())
    }

    fn replace(&mut self, number: usize, feature: Option<&Feature>) -> Result<(), CleanError> {
        self.now[number] = feature.unwrap_or(&self.before[number]).clone();
        Ok(())
    }
}

fn boxes<const N: usize>(all: [[f64; 4]; N]) -> Vec<Feature> {
    let feature = |[x0, y0, x1, y1]: [f64; 4]| {
        let ring = [[x0, y0], [x1, y0], [x1, y1], [x0, y1], [x0, y0]].map(|[x, y]| Position::new(x, y));
        let polygon = Geometry::new(Dimensions::Xy, Shape::Polygon(vec![ring.to_vec()]));
        Feature { geometry: Some(polygon), ..Feature::default() }
    };
    all.map(feature).to_vec()
}

/// The first of two overlapping features keeps the place.
fn options() -> CleanOptions {
    let assign = Options { winner: Winner::First, sliver_area: Some(0.01), ..Options::default() };
    CleanOptions { assign, ..CleanOptions::default() }
}

/// Returns the remaining features and the result.
fn cleaned(before: &[Feature], concerned: &[Vec<usize>], most: u64) -> (Vec<Feature>, Neighbourhoods) {
    let extents = before.iter().map(Extent::of).collect();
    let mut source = Kept { before: before.to_vec(), now: before.to_vec(), extents };
    let done = clean_neighbourhoods(&mut source, concerned, &options(), most).unwrap();
    (source.now, done)
}

#[test]
fn a_feature_that_two_neighbourhoods_change_makes_one_of_them() {
    // The third feature overlaps both others, which are far from each other.
    let before = boxes([[0.0, 0.0, 4.0, 4.0], [40.0, 0.0, 44.0, 4.0], [3.0, 1.0, 41.0, 2.0]]);
    let mut whole = Layer { features: before.clone(), ..Layer::default() };
    clean(&mut whole, &options()).unwrap();
    let (now, done) = cleaned(&before, &[vec![0], vec![1]], u64::MAX);
    assert_eq!(now, whole.features);
    assert_eq!((done.cleaned, done.report.changes.len()), (1, 2));
}

#[test]
fn what_a_neighbourhood_changed_is_undone_if_it_becomes_part_of_one_that_is_too_large() {
    // The first two overlap, and so do the last two. The boxes around both pairs meet, but the pairs do not.
    let before =
        boxes([[30.0, 3.0, 34.0, 5.0], [33.0, 3.0, 38.0, 5.0], [40.0, 3.0, 44.0, 9.0], [30.0, 6.0, 41.0, 8.0]]);
    let mut whole = Layer { features: before.clone(), ..Layer::default() };
    clean(&mut whole, &options()).unwrap();
    let concerned = [vec![0, 1], vec![2]];
    let (now, done) = cleaned(&before, &concerned, 20);
    assert_eq!((now, done.cleaned, done.largest), (whole.features, 1, 20));
    let (now, done) = cleaned(&before, &concerned, 19);
    assert_eq!((now, done.cleaned), (before, 0));
    assert_eq!((&done.too_large[0].features, done.too_large[0].vertices), (&vec![0, 1, 2, 3], 20));
}
