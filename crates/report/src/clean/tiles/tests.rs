//! Cleaning by tiles reports and writes the same as cleaning the whole layer, for any grid.

use super::{CleanedTiles, clean_in_tiles};
use crate::clean::{Cleaning, Repair};
use crate::shelf::{InMemory, Shelf};
use crate::tiles::Division;
use quickcheck::{Arbitrary, Gen, QuickCheck};
use std::fmt::Write as _;
use std::path::Path;
use std::{fs, io};
use twinedge_coverage::clean::{ChangeKind, Options, Winner};
use twinedge_geometry::Point;
use twinedge_layers::clean::{CleanOptions, CleanReport};
use twinedge_layers::{Feature, GeoJsonFile, ReadOptions, read_layer};

type Ring = Vec<[f64; 2]>;

/// Parcels with shared borders, in rows, with faults.
#[derive(Clone, Debug)]
struct Parcels {
    size: [u8; 2],
    /// The parcel, the fault, and a number that parametrizes it.
    faults: Vec<(u8, u8, u8)>,
    /// Offsets of the corners.
    noise: Vec<u8>,
    tiles: u32,
    winner: u8,
    gap_width: bool,
    far: bool,
}

impl Arbitrary for Parcels {
    fn arbitrary(g: &mut Gen) -> Self {
        let small = |g: &mut Gen, most: u8| 1 + u8::arbitrary(g) % most;
        let count = usize::from(small(g, 5));
        Self {
            size: [small(g, 9), small(g, 9)],
            faults: (0..count).map(|_| Arbitrary::arbitrary(g)).collect(),
            noise: (0..16).map(|_| u8::arbitrary(g)).collect(),
            tiles: u32::from(small(g, 5)),
            winner: u8::arbitrary(g),
            gap_width: bool::arbitrary(g),
            far: bool::arbitrary(g),
        }
    }

    fn shrink(&self) -> Box<dyn Iterator<Item = Self>> {
        let (all, again) = (self.clone(), self.clone());
        let fewer = self.faults.shrink().map(move |faults| Self { faults, ..all.clone() });
        let nearer = self.noise.shrink().filter(|noise| !noise.is_empty());
        Box::new(fewer.chain(nearer.map(move |noise| Self { noise, ..again.clone() })))
    }
}

impl Parcels {
    fn corner(&self, i: u8, j: u8) -> [f64; 2] {
        let noise = |k: u8| f64::from(self.noise[usize::from(k) % self.noise.len()] % 16) / 8.0;
        let away = if self.far { 1000.0 } else { 0.0 };
        [f64::from(i) * 10.0 + noise(3 * i + 7 * j) - away, f64::from(j) * 10.0 + noise(5 * i + 2 * j + 1)]
    }

    /// The middles of sides are vertices as well.
    fn parcel(&self, i: u8, j: u8) -> Ring {
        let corners = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)].map(|(i, j)| self.corner(i, j));
        let sides = corners.into_iter().zip([corners[1], corners[2], corners[3], corners[0]]);
        sides.flat_map(|(a, b)| [a, [f64::midpoint(a[0], b[0]), f64::midpoint(a[1], b[1])]]).collect()
    }

    fn features(&self) -> Vec<Vec<Ring>> {
        let [columns, rows] = self.size;
        let mut all: Vec<Vec<Ring>> =
            (0..rows).flat_map(|j| (0..columns).map(move |i| (i, j))).map(|(i, j)| vec![self.parcel(i, j)]).collect();
        let count = all.len();
        for (parcel, fault, more) in &self.faults {
            let number = usize::from(*parcel) % count;
            let by = f64::from(more % 8) / 4.0 - 1.0;
            let k = usize::from(more / 8) % 8;
            let Some(ring) = all[number].first_mut().filter(|ring| k < ring.len()) else { continue };
            let (p, q) = (ring[k], ring[(k + 1) % ring.len()]);
            match fault % 11 {
                0 => ring[k][0] += by,
                1 => ring[k][1] += by,
                // Borders cross away from points.
                2 => {
                    ring[k][0] += by / 3.0;
                    let next = (k + 1) % ring.len();
                    ring[next][0] -= by / 3.0;
                }
                3 => ring.insert(k + 1, [f64::midpoint(p[0], q[0]), f64::midpoint(p[1], q[1])]),
                4 => drop(ring.remove(k)),
                5 => {
                    let same = all[number].clone();
                    all.push(same);
                }
                // A sliver becomes a part of another parcel.
                6 => all[usize::from(*more) % count].push(vec![p, q, [p[0] + 0.125, p[1] + 0.25]]),
                7 => all[number].clear(),
                8 => ring.splice(k..k, [p, [p[0] + 3.0, p[1] + 4.0], p]).for_each(drop),
                9 => ring.insert(k, p),
                // A house over corners.
                _ => all.push(vec![vec![p, [p[0] + 4.0, p[1] - 1.0], [p[0] + 5.0, p[1] + 13.0]]]),
            }
        }
        all
    }

    /// The text, with an id, a name, and numbers as no program writes them.
    fn text(&self) -> String {
        let mut text = String::new();
        for (number, parts) in self.features().iter().enumerate() {
            let ring = |ring: &Ring| {
                let points: Vec<String> =
                    ring.iter().chain(ring.first()).map(|[x, y]| format!("[{x:?}, {y:e}]")).collect();
                format!("[[{}]]", points.join(","))
            };
            let geometry = match &parts[..] {
                [] => "null".to_owned(),
                [one] => format!(r#"{{"type":"Polygon","coordinates":{}}}"#, ring(one)),
                parts => {
                    let parts: Vec<String> = parts.iter().map(ring).collect();
                    format!(r#"{{"type": "MultiPolygon","coordinates":[{}]}}"#, parts.join(", "))
                }
            };
            let _ = writeln!(
                text,
                r#"{{"type": "Feature", "id":{number}, "properties":{{"name":"p{number}"}},"geometry":{geometry}}}"#
            );
        }
        text
    }

    fn repair(&self) -> Repair<'static> {
        let winners = [Winner::Inner, Winner::Larger, Winner::Smaller, Winner::First, Winner::Last];
        let assign = Options {
            winner: winners[usize::from(self.winner) % 5],
            sliver_area: Some(0.75),
            gap_width: self.gap_width.then_some(0.5),
            ..Options::default()
        };
        Repair { options: CleanOptions { assign, ..CleanOptions::default() }, ..Repair::default() }
    }
}

fn by_tiles(path: &Path, repair: &Repair<'_>, division: Division) -> (Vec<Feature>, String, CleanedTiles) {
    let open = |each: &mut dyn FnMut(Feature)| {
        let mut take = |feature| {
            each(feature);
            Ok(())
        };
        GeoJsonFile::open(path, tempfile::tempfile()?, &mut take)
    };
    let shelves = || -> io::Result<Box<dyn Shelf>> { Ok(Box::<InMemory>::default()) };
    let (mut file, tiles) = clean_in_tiles(open, repair, division, shelves, &mut |_| {}).unwrap();
    let mut written = Vec::new();
    file.write(&mut written).unwrap();
    let layer = read_layer(&mut &*written, Some(Path::new("x.geojsonl")), &ReadOptions::default()).unwrap();
    (layer.features, String::from_utf8(written).unwrap(), tiles)
}

type ChangeKey = (ChangeKind, Vec<usize>, Option<usize>, [i64; 4]);

/// The changes with rounded measures, for comparison.
fn change_keys(report: &CleanReport) -> Vec<ChangeKey> {
    let rounded = |x: f64| (x * 1e6).round() as i64;
    let mut keys: Vec<_> = report
        .changes
        .iter()
        .map(|one| {
            let Point { x, y } = one.at;
            (one.kind, one.from.clone(), one.to, [one.area, one.width, x, y].map(rounded))
        })
        .collect();
    keys.sort();
    keys
}

fn added_keys(report: &CleanReport) -> Vec<(usize, usize, [u64; 2])> {
    let mut keys: Vec<_> =
        report.added.iter().map(|one| (one.to, one.of, [one.at.x, one.at.y].map(f64::to_bits))).collect();
    keys.sort_unstable();
    keys
}

fn left_keys(report: &CleanReport) -> Vec<(&'static str, Vec<usize>, [i64; 2])> {
    let all = [&report.remaining, &report.wider_gaps, &report.accepted_gaps];
    let rounded = |x: f64| (x * 1e6).round() as i64;
    let mut keys: Vec<_> = all
        .into_iter()
        .flatten()
        .map(|one| (one.rule.id(), one.features.clone(), [one.area, one.width].map(rounded)))
        .collect();
    keys.sort();
    keys
}

/// Returns the number of changed features, if tiles and the whole layer agree.
fn changed(text: &str, repair: &Repair<'_>, tiles: u32) -> Result<usize, String> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("parcels.geojsonl");
    fs::write(&path, text).unwrap();
    let before = read_layer(&mut text.as_bytes(), Some(&path), &ReadOptions::default()).unwrap();
    let mut whole = before.clone();
    // All parcels may be gone.
    let Ok(report) = repair.clean(&mut whole) else { return Ok(0) };
    let (features, written, cleaned) = by_tiles(&path, repair, Division::Across(tiles));
    for (number, (one, other)) in features.iter().zip(&whole.features).enumerate() {
        if one != other {
            return Err(format!("feature {number}: {:?} and {:?}", one.geometry, other.geometry));
        }
        let is_changed = report.features.iter().any(|change| change.feature == number);
        if !is_changed && written.lines().nth(number) != text.lines().nth(number) {
            return Err(format!("the text of feature {number} changed"));
        }
    }
    let differ = |what: &str, one: String, other: String| {
        if one == other { Ok(()) } else { Err(format!("{what}: {one}\nof the whole: {other}")) }
    };
    let pair = [&cleaned.report, &report];
    let of = |key: &dyn Fn(&CleanReport) -> String| pair.map(key);
    let [one, other] = of(&|it| format!("{:?}", change_keys(it)));
    differ("changes", one, other)?;
    let [one, other] = of(&|it| format!("{:?}", added_keys(it)));
    differ("vertices", one, other)?;
    let [one, other] = of(&|it| {
        format!(
            "{:?}",
            it.features.iter().map(|one| (one.feature, one.points_before, one.points_after)).collect::<Vec<_>>()
        )
    });
    differ("features", one, other)?;
    let [one, other] = of(&|it| format!("{:?} {:?} {}", it.left, left_keys(it), it.polygons));
    differ("left", one, other)?;
    // A second run by tiles changes nothing and leaves the same findings.
    fs::write(&path, &written).unwrap();
    let (_, again, twice) = by_tiles(&path, repair, Division::Across(tiles));
    differ("twice", again, written)?;
    differ("left of twice", format!("{:?}", left_keys(&twice.report)), format!("{:?}", left_keys(&cleaned.report)))?;
    Ok(report.features.len())
}

#[test]
#[allow(clippy::needless_pass_by_value, reason = "quickcheck hands properties their input by value")]
fn tiles_clean_as_the_whole_does() {
    fn law(parcels: Parcels) -> bool {
        changed(&parcels.text(), &parcels.repair(), parcels.tiles)
            .inspect_err(|why| eprintln!("{why}\n{}", parcels.text()))
            .is_ok()
    }
    QuickCheck::new().tests(120).quickcheck(law as fn(Parcels) -> bool);
}

/// Every neighbourhood and every round has the grid of the whole.
#[test]
fn grids_of_rounds_are_those_of_the_whole() {
    // The spike at 64 is gone after the first round, and the finest grid of the rest is half as wide.
    let faults = vec![(10, 74, 160), (0, 0, 210)];
    let spiked = Parcels { size: [2, 6], faults, noise: vec![1], tiles: 3, winner: 0, gap_width: true, far: false };
    // The filler at one parcel crosses a border, the filler at the other lies beside a border, by less than a cell.
    let (faults, noise) = (vec![(107, 1, 48), (0, 0, 181)], vec![1, 0, 18, 0, 0, 0]);
    let filled = Parcels { size: [4, 9], faults, noise, tiles: 2, winner: 88, gap_width: true, far: true };
    for (parcels, count) in [(spiked, 3), (filled, 4)] {
        assert_eq!(changed(&parcels.text(), &parcels.repair(), parcels.tiles), Ok(count));
    }
}

/// Nothing overlaps, is left out, or crosses.
#[test]
fn a_hole_outside_of_its_polygon_becomes_a_part_of_it() {
    let square = |x: f64, side: f64| {
        let [y, far, high] = [x, x + side, x + side];
        format!("[[{x:?},{y:?}],[{far:?},{y:?}],[{far:?},{high:?}],[{x:?},{high:?}],[{x:?},{y:?}]]")
    };
    let rings = format!("{},{}", square(0.0, 10.0), square(20.0, 4.0));
    let text = [rings, square(40.0, 10.0)]
        .map(|rings| {
            format!(r#"{{"type":"Feature","properties":{{}},"geometry":{{"type":"Polygon","coordinates":[{rings}]}}}}"#)
                + "\n"
        })
        .concat();
    let repair = Repair {
        options: CleanOptions {
            assign: Options { sliver_area: Some(0.75), ..Options::default() },
            ..CleanOptions::default()
        },
        ..Repair::default()
    };
    assert_eq!(changed(&text, &repair, 2), Ok(1));
}

/// Rows of squares of 10. One square reaches half a unit into its right neighbour, far from a slit between two others.
#[test]
fn a_neighbourhood_that_does_not_fit_stays_as_it_is_and_is_said() {
    let square = |i: u32| {
        let [x, y] = [i % 8, i / 8].map(|place| f64::from(place) * 10.0);
        let right = x + [10.0, 10.5, 9.9][usize::from(i == 9) + 2 * usize::from(i == 52)];
        let ring = [[x, y], [right, y], [right, y + 10.0], [x, y + 10.0], [x, y]];
        format!(r#"{{"type":"Feature","properties":{{}},"geometry":{{"type":"Polygon","coordinates":[{ring:?}]}}}}"#)
            + "\n"
    };
    let text: String = (0..64).map(square).collect();
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("squares.geojsonl");
    fs::write(&path, &text).unwrap();
    let assign = Options { sliver_area: Some(1.5), ..Options::default() };
    let repair = Repair { options: CleanOptions { assign, ..CleanOptions::default() }, ..Repair::default() };
    let (_, written, tiles) = by_tiles(&path, &repair, Division::Within(1024));
    assert_eq!(written, text);
    let cleaning = Cleaning::of_tiles("squares", &repair, &tiles);
    let report = cleaning.json();
    // The squares that meet the box around the faulty ones: 16 for each fault.
    let left = report["tiles"]["not_cleaned"].as_array().unwrap().iter();
    let left: Vec<_> = left.map(|one| (one["features"][0]["number"].as_u64(), one["vertices"].as_u64())).collect();
    assert_eq!(left, [(Some(1), Some(80)), (Some(44), Some(80))]);
    let rules = report["left"]["findings"].as_array().unwrap().iter().map(|one| one["rule"].as_str().unwrap());
    assert_eq!(rules.collect::<Vec<_>>(), [vec!["C1", "C2"], vec!["C7"; 6]].concat());
    let line = "6 features between (10, 0) and (30, 30): the neighbourhood has 80 vertices";
    assert!(report["clean"] == false && cleaning.text(20).unwrap().contains(line), "{report}");
}

/// Layers that one cleaning by tiles did not clean: vertices lie within a cell of borders.
const WITHIN_A_CELL: [&[[[f64; 2]; 3]]; 2] = [
    &[
        [[0.3, 1.2], [2.5, 1.9], [2.2, 1.2]],
        [[2.1, 0.4], [0.3, 1.2], [0.840_000_000_000_000_1, 0.96]],
        [[4.2, 5.2], [4.2, 4.5], [2.5, 1.9]],
        [[3.35, 3.55], [5.6, 4.8], [1.6, 3.5]],
    ],
    &[
        [[0.6, 4.4], [5.8, 5.8], [4.9, 5.2]],
        [[0.0, 4.1], [1.4, 5.7], [3.0, 2.9]],
        [[1.8, 5.8], [4.2, 2.1], [4.5, 5.4]],
        [[4.5, 1.4], [1.7, 4.1], [1.57, 4.22]],
    ],
];

/// Triangles with coordinates in tenths. Some corners lie on corners or sides of other triangles, up to rounding.
fn triangles(some: &mut impl FnMut(usize) -> usize) -> Vec<[[f64; 2]; 3]> {
    let mut corners: Vec<[f64; 2]> = Vec::new();
    for _ in 0..3 * (2 + some(4)) {
        corners.push(match some(4) {
            0 if corners.len() > 1 => {
                let [a, b] = [0; 2].map(|_| corners[some(corners.len())]);
                let part = [0.5, 0.3, 0.7, 0.1][some(4)];
                [0, 1].map(|i| a[i] + part * (b[i] - a[i]))
            }
            1 if !corners.is_empty() => corners[some(corners.len())],
            _ => [some(60), some(60)].map(|x| x as f64 / 10.0),
        });
    }
    corners.chunks_exact(3).map(|ring| [ring[0], ring[1], ring[2]]).collect()
}

#[test]
fn cleaning_again_changes_nothing_by_tiles_and_as_a_whole() {
    // Linear congruences (D. Knuth, MMIX).
    let mut state = 1_u64;
    let mut some = |below: usize| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as usize % below
    };
    let assign = Options { sliver_area: Some(0.001), gap_width: Some(0.6), ..Options::default() };
    let repair = Repair { options: CleanOptions { assign, ..CleanOptions::default() }, ..Repair::default() };
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("triangles.geojsonl");
    let random = (0..400).map(|_| triangles(&mut some));
    for layer in WITHIN_A_CELL.into_iter().map(<[_]>::to_vec).chain(random) {
        let mut text = String::new();
        for [a, b, c] in layer {
            let ring = [a, b, c, a];
            let _ = writeln!(
                text,
                r#"{{"type":"Feature","properties":{{}},"geometry":{{"type":"Polygon","coordinates":[{ring:?}]}}}}"#
            );
        }
        fs::write(&path, &text).unwrap();
        let mut whole = read_layer(&mut text.as_bytes(), Some(&path), &ReadOptions::default()).unwrap();
        let is_cleaned = repair.clean(&mut whole).is_ok();
        // Rings that enclose nothing are gone.
        if !is_cleaned || whole.features.iter().all(|feature| feature.geometry.is_none()) {
            continue;
        }
        let mut twice = whole.clone();
        repair.clean(&mut twice).unwrap();
        assert_eq!(twice, whole, "{text}");
        let (_, written, once) = by_tiles(&path, &repair, Division::Across(1));
        fs::write(&path, &written).unwrap();
        let (_, again, twice) = by_tiles(&path, &repair, Division::Across(1));
        assert_eq!(again, written, "{text}");
        assert_eq!(left_keys(&twice.report), left_keys(&once.report), "{text}");
    }
}
