//! Maps whose edges meet other than at vertices, cut tile by tile.

use crate::maps::{Random, area, feature, line, point, sets};
use crate::whole::{all_pieces, compare, grid, merged, whole, whole_cut};
use std::collections::BTreeSet;
use std::convert::Infallible;
use twinedge_coverage::tile::{AuditError, CrossingKind, Cuts, Grid, Piece, Summary, Tile, TileError, audit};
use twinedge_coverage::{CoverageRule, Limits};
use twinedge_map::{BuildError, Feature, Shape};

/// Positions of lines between tiles: between points of the lattice, through them, and through the most frequent crossings.
const PLACES: [f64; 5] = [0.0, 0.5, 1.0, 1.5, 2.0];

/// Triangles and lines between points of a lattice of 4 by 4 points, whose edges cross each other and pass through the points.
fn on_lattice(random: &mut Random, count: usize) -> Vec<Feature> {
    let corner = |random: &mut Random| [random.below(4) as f64, random.below(4) as f64];
    let shape = |random: &mut Random| {
        let corners = [corner(random), corner(random), corner(random)];
        if random.below(4) == 0 { line(&corners) } else { Shape::polygon(corners) }
    };
    (0..count).map(|_| feature([shape(random)])).collect()
}

#[test]
fn small_maps_are_cut_alike_under_every_tiling() {
    let (sets, mut random) = (sets(&PLACES), Random::new(51));
    for count in [2, 4] {
        let features = on_lattice(&mut random, count);
        for upright in &sets {
            for level in &sets {
                compare(&features, &grid(upright, level), &Limits::default(), &mut random);
            }
        }
    }
}

#[test]
fn crossings_on_lines_and_corners_between_tiles_are_cut_once() {
    let (sets, mut random) = (sets(&PLACES), Random::new(52));
    for round in 0..250 {
        let features = on_lattice(&mut random, 2 + round % 7);
        let [upright, level] = [0; 2].map(|_| sets[random.below(sets.len())].clone());
        compare(&features, &grid(&upright, &level), &Limits::default(), &mut random);
    }
}

/// Far from the origin the cells of the grid are large: edges visit hot pixels that they pass, and pieces are bent again.
#[test]
fn edges_that_are_bent_again_are_bent_alike() {
    let mut random = Random::new(53);
    let far = f64::from(1 << 24) * f64::from(1 << 24);
    let mut bent = 0;
    for round in 0..200 {
        let size = [3.0, 12.0, 40.0][round % 3];
        let part = |random: &mut Random| far + (random.part() * size * 16.0).floor() / 16.0;
        let corner = |random: &mut Random| [part(random), part(random)];
        let shape = |random: &mut Random| {
            let corners = [corner(random), corner(random), corner(random)];
            match random.below(4) {
                0 => line(&corners),
                1 => point(corners[0][0], corners[0][1]),
                _ => Shape::polygon(corners),
            }
        };
        let features: Vec<Feature> = (0..12).map(|_| feature([shape(&mut random)])).collect();
        let [upright, level] = [(); 2].map(|()| random.pair(part));
        compare(&features, &grid(&upright, &level), &Limits::default(), &mut random);
        bent += usize::from(crate::whole::rounds(&features) > 1);
    }
    assert!(bent > 50, "{bent}");
}

/// Parcels of a cadastre: neighbours whose borders lack each other's vertices, overlap, leave gaps, cross.
fn parcels(random: &mut Random) -> Vec<Feature> {
    let mut features = Vec::new();
    for x in 0..5 {
        for y in 0..5 {
            let [x, y] = [f64::from(x) * 0.7, f64::from(y) * 0.7];
            let by = |random: &mut Random| (random.part() - 0.5) * 0.2;
            let mut ring = vec![[x, y], [x + 0.7, y], [x + 0.7, y + 0.7], [x, y + 0.7]];
            match random.below(8) {
                // A corner that the neighbour lacks, exactly on its border, or nearly.
                0 => ring.insert(1, [x + 0.35, y]),
                1 => ring.insert(2, [x + 0.7, y + 0.1 + 0.5 * random.part()]),
                2 => ring.insert(3, [x + 0.5, f64::midpoint(y, y) + 0.7]),
                // Beyond the border, or short of it.
                3 => ring.insert(2, [x + 0.7 + by(random), y + 0.35]),
                4 => ring[2] = [x + 0.7 + by(random), y + 0.7 + by(random)],
                5 => ring[1] = [x + 0.7 + 1e-9, y],
                _ => {}
            }
            if random.below(15) > 0 {
                features.push(feature([Shape::polygon(ring)]));
            }
        }
    }
    features.push(feature([line(&[[-0.2, 0.35], [1.9, 1.05], [3.7, 0.35]]), point(0.35, 0.35)]));
    features
}

#[test]
fn findings_of_a_cadastre_are_those_of_the_whole() {
    let (mut random, mut seen) = (Random::new(54), BTreeSet::new());
    let given = Limits { gap_width: Some(0.05), sliver_area: Some(0.01), ..Limits::default() };
    for round in 0..120 {
        let features = parcels(&mut random);
        let places = [0.0, 0.35, 0.7, 1.05, 1.4, 1.0, 2.2, 2.8];
        let [upright, level] = [(); 2].map(|()| random.pair(|random| places[random.below(8)]));
        let limits = if round % 2 == 0 { Limits::default() } else { given.clone() };
        compare(&features, &grid(&upright, &level), &limits, &mut random);
        seen.extend(whole_cut(&features, &limits).findings.iter().map(|finding| finding.rule));
    }
    let expected = [CoverageRule::Overlap, CoverageRule::Gap, CoverageRule::NearMiss, CoverageRule::Mismatch];
    assert!(expected.iter().all(|rule| seen.contains(rule)), "{seen:?}");
}

/// Long edges that cross several tiles without a vertex there, and are bent in some of them.
#[test]
fn edges_across_many_tiles_are_cut_in_each() {
    let mut random = Random::new(55);
    let lines = Grid::new([0.0, 0.0], [60.0, 60.0], 12, 9).expect("a grid");
    for _ in 0..20 {
        let mut features = Vec::new();
        for _ in 0..6 {
            let mut end = || [random.part() * 60.0, random.part() * 60.0];
            features.push(feature([Shape::polygon([end(), end(), end()])]));
        }
        features.push(feature([area([5.0, 5.0], [55.0, 55.0]), line(&[[0.0, 30.0], [60.0, 30.0]])]));
        compare(&features, &lines, &Limits::default(), &mut random);
    }
}

#[test]
fn the_driver_says_what_rules_and_cut_tiles_say() {
    let mut random = Random::new(56);
    let features = parcels(&mut random);
    let grid = grid(&[1.0, 2.1], &[0.7]);
    let pieces = all_pieces(&grid, &features);
    let of_tile = |_| Ok::<_, Infallible>(pieces.iter().collect());
    let outcome = audit(&grid, &Limits::default(), Cuts::new(4.0).expect("finite"), of_tile).expect("in range");
    assert!(!outcome.crossings.is_empty() && !outcome.is_valid() && !whole(&features).is_plane());
    let found = outcome.coverage.expect("it was cut").findings;
    assert_eq!(found.len(), whole_cut(&features, &Limits::default()).findings.len());
}

#[test]
fn a_tile_that_is_left_out_of_all_rounds_shows_what_is_not_cut() {
    let features = [feature([area([0.0, 0.0], [2.5, 2.5])]), feature([area([1.5, 1.5], [4.0, 4.0])])];
    let (grid, mut cuts) = (grid(&[2.0], &[2.0]), Cuts::new(4.0).expect("finite"));
    let (left_out, pieces) = (Tile(2), all_pieces(&grid, &features));
    while !cuts.is_complete() {
        let others = grid.tiles().filter(|tile| *tile != left_out);
        let found: Vec<_> = others.map(|tile| cuts.search(&grid, tile, &pieces).expect("in range")).collect();
        cuts.take(found).expect("few rounds");
    }
    let summary = |tile| Summary::cut(&grid, tile, &pieces, &Limits::default(), &cuts).expect("in range");
    let summaries = grid.tiles().map(summary).collect();
    let outcome = merged(summaries, &mut Random::new(57)).finish().expect("no tile is missing");
    assert_eq!(outcome.coverage, None);
    let [crossing] = &outcome.crossings[..] else { panic!("{:?}", outcome.crossings) };
    assert_eq!(crossing.kind, CrossingKind::Cross);
    // The left side of the second square, and the upper side of the first one.
    assert!(crossing.first.iter().all(|p| p.y.to_bits() == 2.5_f64.to_bits() || p.x.to_bits() == 1.5_f64.to_bits()));
}

#[test]
fn what_cannot_be_cut_is_refused() {
    for largest in [f64::NAN, f64::INFINITY, -1.0] {
        assert!(matches!(Cuts::new(largest), Err(BuildError::OutOfReach { .. })));
    }
    let (cuts, grid) = (Cuts::new(3.0).expect("finite"), grid(&[1.0], &[]));
    let outside = Tile(2);
    assert_eq!(cuts.search(&grid, outside, []).unwrap_err(), TileError::NoSuchTile(outside));
    for far in [4.0, f64::NAN, f64::NEG_INFINITY] {
        let far_is_finite = far.is_finite();
        let far = feature([line(&[[0.0, 0.0], [far, 1.0]])]);
        let refused = cuts.pieces(&grid, 0, &far).unwrap_err();
        let is_refused = if far_is_finite {
            matches!(refused, BuildError::OutOfReach { y: 1.0, .. })
        } else {
            matches!(refused, BuildError::NotFinite { y: 1.0, .. })
        };
        assert!(is_refused, "{refused:?}");
    }
    // Pieces of a map that reaches farther than the cuts.
    let far = feature([line(&[[0.0, 0.0], [4.0, 1.0]])]);
    let pieces = all_pieces(&grid, &[far]);
    let is_refused = |error: &TileError| matches!(error, TileError::Build(BuildError::OutOfReach { y: 1.0, .. }));
    assert!(is_refused(&cuts.search(&grid, Tile(0), &pieces).unwrap_err()));
    let failed = audit::<Piece, _>(&grid, &Limits::default(), cuts, |_| Err("no file"));
    assert_eq!(failed, Err(AuditError::Pieces("no file")));
}

/// A vertex in the border of a feature that overlaps there is no mismatch, and only the tile to which snapping moves it knows the overlap.
#[test]
fn a_vertex_that_is_moved_to_another_tile_is_judged_there() {
    let near = 2.0 - f64::EPSILON;
    let features =
        [feature([area([near, 0.0], [4.0, 2.0])]), feature([Shape::polygon([[near, 1.0], [3.0, 0.5], [3.0, 1.5]])])];
    assert!(whole_cut(&features, &Limits::default()).findings.iter().all(|one| one.rule == CoverageRule::Overlap));
    compare(&features, &grid(&[2.0], &[]), &Limits::default(), &mut Random::new(58));
}

/// Regression: areas were rounded as far as the first edge of the tile lay away, so slivers far from it were taken for large.
#[test]
fn a_sliver_far_from_the_first_edge_of_its_tile_is_found() {
    let features = [feature([area([0.0, 0.0], [1.0, 1.0])]), feature([area([1e9, 1e9], [1e9 + 0.125, 1e9 + 8.0])])];
    let limits = Limits { gap_width: Some(0.1), sliver_area: Some(2.0), ..Limits::default() };
    compare(&features, &Grid::everything(), &limits, &mut Random::new(59));
    assert_eq!(whole_cut(&features, &limits).of(CoverageRule::Sliver).count(), 1);
}

/// Regression: tiles said that T4 holds whatever the counts are.
#[test]
fn too_many_edges_are_a_violation_of_t4() {
    let corners = [[0.0, 0.0], [4.0, 0.0], [2.0, 3.0], [1.0, 1.0], [3.0, 1.5], [2.0, 0.5]];
    let pairs = (0..6).flat_map(|j| (0..j).map(move |i| feature([line(&[corners[i], corners[j]])])));
    let features: Vec<Feature> = pairs.collect();
    compare(&features, &grid(&[2.0], &[1.0]), &Limits::default(), &mut Random::new(60));
}

/// Regression: pieces that were divided for another grid were accepted, and their features vanished from a valid map.
#[test]
fn pieces_of_another_grid_are_refused() {
    let features = [feature([area([0.0, 0.0], [2.0, 2.0])])];
    let (one, other) = (grid(&[1.0], &[]), grid(&[5.0], &[]));
    let pieces = all_pieces(&one, &features);
    assert_eq!(Summary::new(&other, Tile(0), &pieces, &Limits::default()).unwrap_err(), TileError::OtherGrid);
    assert_eq!(Cuts::new(2.0).expect("finite").search(&other, Tile(0), &pieces).unwrap_err(), TileError::OtherGrid);
    let mut forged = serde_json::to_value(&pieces[0]).expect("it can be saved");
    forged["grid"] = serde_json::Value::Null;
    assert!(serde_json::from_value::<Piece>(forged).is_err(), "only a piece without edges is of any grid");
    let unreadable = Piece::unreadable(1, "it is damaged");
    let found = Summary::new(&other, Tile(0), [&unreadable], &Limits::default()).expect("it is of any grid");
    let rest = Summary::new(&other, Tile(1), [], &Limits::default()).expect("nothing is there");
    let outcome = found.merge(rest).expect("neighbours").finish().expect("all tiles");
    assert_eq!(outcome.unreadable, [(1, "it is damaged".to_owned())]);
}

#[test]
fn grids_that_no_predicate_is_exact_for_are_refused() {
    use twinedge_coverage::tile::GridError;
    for x in [f64::NAN, f64::INFINITY, 1e200] {
        let sample = vec![[0.0, 0.0].into(), [1.0, 0.0].into(), [x, 0.0].into(), [x, 0.0].into()];
        assert_eq!(Grid::fitted(sample, 1), Err(GridError::Lines), "{x}");
    }
    assert_eq!(Grid::new([0.0, f64::NAN], [1.0, 1.0], 1, 1), Err(GridError::Lines));
    assert_eq!(Grid::fitted(vec![[3.0, 3.0].into(); 9], 1).map(|grid| grid.len()), Ok(1));
}
