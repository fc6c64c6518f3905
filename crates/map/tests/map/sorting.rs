//! Maps do not depend on the order in which the standard library sorts items that tie.

use std::sync::atomic::Ordering;
use twinedge::program::choose::{Choose, Random};
use twinedge::validate::Table;
use twinedge_algorithm::voronoi::voronoi;
use twinedge_coverage::{Limits, check};
use twinedge_geometry::Point;
use twinedge_geometry::noding::Snap;
use twinedge_geometry::threads::REVERSE_TIES;
use twinedge_map::{Builder, Feature, Noding, PlanarMap, QueryLine, Shape};

/// Removes the versions of keys, which differ from map to map.
fn without_versions(text: &str) -> String {
    let part = |part: &str| match part.split_once('v').filter(|(index, _)| index.parse::<u32>().is_ok()) {
        Some((index, rest)) => format!("{index}{}", rest.trim_start_matches(|c: char| c.is_ascii_digit())),
        None => part.to_owned(),
    };
    text.split("Key(").map(part).collect()
}

/// Everything reported about a map of these rectangles: as built, cut and rounded.
fn told(rectangles: &[[f64; 4]]) -> Vec<String> {
    let built = |noding: Noding| {
        let mut builder = Builder::new();
        for [x, y, w, h] in rectangles.iter().copied() {
            let ring = [[x, y], [x + w, y], [x + w, y + h], [x, y + h]];
            builder.feature(&Feature { shapes: vec![Shape::polygon(ring)], ..Feature::default() }).unwrap();
        }
        builder.build_with(noding).unwrap()
    };
    let of_map = |map: &PlanarMap| {
        let features: Vec<Vec<_>> = map.dcel().faces().map(|f| map.features_of(f.key()).unwrap().collect()).collect();
        let zone = map.zone(&QueryLine::Line(Point::new(0.0, 0.5), Point::new(9.0, 4.0)));
        let audit = check(map, &Limits::default());
        let table = Table::copy_of(map).unwrap();
        without_versions(&format!("{table}\n{features:?}\n{zone:?}\n{audit:?}\n{:?}", map.validate()))
    };
    let mut all: Vec<String> = [Noding::None, Noding::Snap(Snap::Size(1.0)), Noding::Snap(Snap::Size(0.25))]
        .map(|noding| of_map(&built(noding)))
        .into();
    let sites: Vec<Point> = rectangles.iter().map(|[x, y, ..]| Point::new(*x, *y)).collect();
    all.push(format!("{:?}", voronoi(&sites, None).map(|found| of_map(&found.map))));
    all
}

#[test]
fn maps_are_the_same_however_items_that_tie_are_sorted() {
    // Two rectangles that share parts of two sides.
    let mut drawings = vec![vec![[0.0, 0.0, 1.0, 2.0], [0.0, 0.0, 1.0, 1.0]]];
    let mut random = Random::seeded(24);
    for _ in 0..60 {
        let mut number = |most: usize| random.choose(2 * most) as f64 / 2.0;
        let rectangles = (0..12).map(|_| [number(6), number(6), 0.5 + number(4), 0.5 + number(4)]);
        drawings.push(rectangles.collect());
    }
    let as_it_is: Vec<_> = drawings.iter().map(|drawing| told(drawing)).collect();
    REVERSE_TIES.store(true, Ordering::Relaxed);
    let reversed: Vec<_> = drawings.iter().map(|drawing| told(drawing)).collect();
    REVERSE_TIES.store(false, Ordering::Relaxed);
    for (i, (one, other)) in as_it_is.iter().zip(&reversed).enumerate() {
        assert_eq!(one, other, "{:?}", drawings[i]);
    }
}
