//! The search on small input, compared with trying all pairs.

use super::{
    Block, Budget, Filing, Look, Pixel, PixelVisits, Pixels, Search, Segment, State, Tiles, Vertices, around, search,
};
use crate::noding::runs::join;
use quickcheck::{Gen, QuickCheck};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::atomic::AtomicUsize;

/// Segments of one of several families, made from arbitrary numbers.
fn family(kind: u8, raw: &[(i8, i8, i8, i8)]) -> Vec<[[i64; 2]; 2]> {
    let numbers = raw.iter().map(|&(a, b, c, d)| [a, b, c, d].map(i64::from));
    let segment = |(i, [a, b, c, d]): (usize, [i64; 4])| match kind % 7 {
        0 => [[a, b], [c, d]],
        // Through or near the origin.
        1 => [[a, b], [-a + c % 3, -b + d % 3]],
        // From the origin, or far from it.
        2 => [[if i % 4 == 0 { c } else { 0 }, if i % 4 == 0 { d } else { 0 }], [a, b]],
        // A bundle with short segments between.
        3 if i % 3 > 0 => [[-130, a], [130, a + b % 4]],
        4 if i % 3 > 0 => [[a - 130, -a - 130], [a + 130, -a + 130 + b % 4]],
        5 if i % 3 > 0 => [[a, -130], [a + b % 4, 130]],
        // All on a few lines.
        6 => [[a, 2 * a + d % 2], [c, 2 * c + d % 2]],
        _ => [[a, b], [a + c % 5, b + d % 5]],
    };
    numbers.enumerate().map(segment).collect()
}

/// Compares all finds with the results of trying all pairs.
#[expect(clippy::needless_pass_by_value, reason = "what quickcheck asks for")]
fn finds_all(kind: u8, raw: Vec<(i8, i8, i8, i8)>, shift: u8) -> bool {
    let pixels = Pixels { shift: u32::from(shift % 4) };
    let mut vertices: Vec<Pixel> = Vec::new();
    let mut vertex = |pixel: Pixel| {
        let known = vertices.iter().position(|&v| v == pixel);
        known.unwrap_or_else(|| {
            vertices.push(pixel);
            vertices.len() - 1
        }) as u32
    };
    let oriented = family(kind, &raw).into_iter().map(|[a, b]| [a.min(b), a.max(b)]);
    let segments: Vec<Segment> = oriented
        .map(|[a, b]| Segment { a, b, ends: [vertex(pixels.at(a)), vertex(pixels.at(b))] })
        .filter(|segment| segment.ends[0] != segment.ends[1])
        .collect();
    let runs = join(segments).joined;

    let crossings = runs.iter().enumerate().flat_map(|(i, s)| runs[..i].iter().filter_map(|t| pixels.crossing(s, t)));
    let hot: BTreeSet<Pixel> = vertices.iter().copied().chain(crossings).collect();
    let found = search(pixels, &runs, &mut vertices, usize::MAX).unwrap();
    assert_eq!(vertices.len(), hot.len());
    assert_eq!(vertices.iter().copied().collect::<BTreeSet<_>>(), hot);

    let mut visits: BTreeMap<u32, Vec<Pixel>> = BTreeMap::new();
    for [run, v] in found.visits {
        visits.entry(run).or_default().push(vertices[v as usize]);
    }
    for (id, run) in (0..).zip(&runs) {
        let mut visited = visits.remove(&id).unwrap_or_default();
        visited.sort_unstable();
        let inner = || hot.iter().copied().filter(|&pixel| !run.ends.map(|v| vertices[v as usize]).contains(&pixel));
        assert!(inner().filter(|&pixel| pixels.visits(run, pixel)).eq(visited.iter().copied()));
        let straight = pixels.between_centres(run);
        let strays = inner().any(|pixel| Pixels::ONE_STEP.visits(&straight, pixel) && !visited.contains(&pixel));
        assert!(!strays || found.doubtful.contains(&id));
    }
    true
}

#[test]
fn halving_and_cutting_and_setting_aside_find_what_trying_all_finds() {
    for (size, tests) in [(8, 2000), (40, 700), (120, 60)] {
        let check = finds_all as fn(u8, Vec<(i8, i8, i8, i8)>, u8) -> bool;
        QuickCheck::new().rng(Gen::from_size_and_seed(size, 7)).tests(tests).quickcheck(check);
    }
}

#[test]
fn the_parts_around_a_pixel_and_the_pixel_make_the_block() {
    for (high, pixels) in [([4, 2], 15), ([0, 5], 6), ([1, 1], 4)] {
        let block = Block { low: [0, 0], high };
        for pixel in (0..=high[0]).flat_map(|x| (0..=high[1]).map(move |y| [x, y])) {
            let parts = around(&block, pixel);
            let held = |at: Pixel| parts.iter().filter(|part| part.contains(at)).count();
            let all = || (0..=high[0]).flat_map(|x| (0..=high[1]).map(move |y| [x, y]));
            assert!(all().all(|at| held(at) == usize::from(at != pixel)));
            assert_eq!(all().count(), pixels);
            assert!(parts.iter().all(|part| part.contains(part.low) && block.includes(part)));
        }
    }
}

#[test]
fn the_tiles_of_a_block_make_the_block() {
    for high in [[4, 2], [0, 5], [1, 1], [7, 8], [0, 0]] {
        let block = Block { low: [-3, 2], high: [high[0] - 3, high[1] + 2] };
        for segments in [0, 1, 100, 1_000_000] {
            let tiles = Tiles::new(&block, segments);
            let parts: Vec<Block> = (0..tiles.len()).map(|tile| tiles.block(tile)).collect();
            for pixel in (-3..=high[0] - 3).flat_map(|x| (2..=high[1] + 2).map(move |y| [x, y])) {
                let held: Vec<usize> = (0..parts.len()).filter(|tile| parts[*tile].contains(pixel)).collect();
                assert_eq!(held, [tiles.at(pixel)]);
                assert_eq!(tiles.of(&Block::one(pixel)).only(), Some(tiles.at(pixel)));
            }
            let range = tiles.of(&block);
            let all: Vec<usize> = range.tiles().collect();
            assert_eq!((all.len(), range.only()), (range.len(), Some(all[0]).filter(|_| all.len() == 1)));
            assert!((0..parts.len()).all(|tile| all.contains(&tile) == block.overlaps(&parts[tile])));
        }
    }
}

#[test]
fn a_block_of_one_pixel_is_not_halved_for_ever() {
    let segments: Vec<Segment> =
        (-5..=5).map(|i| Segment { a: [-40, -i], b: [40, i], ends: [u32::MAX - 1, u32::MAX] }).collect();
    // None lies in the block.
    let given: Vec<Pixel> = (0..20).map(|i| [-20 - i, -20]).collect();
    let visits = AtomicUsize::new(0);
    let mut search = Search {
        pixels: Pixels { shift: 0 },
        segments: &segments,
        vertices: Vertices::new(&given),
        found: PixelVisits::default(),
        budget: Budget { most: usize::MAX, visits: &visits, counted: 0 },
        tasks: Vec::new(),
        bundles: 0,
        segment_pool: Vec::new(),
        vertex_pool: Vec::new(),
        filing: Filing::default(),
        boxes: Vec::new(),
    };
    let look = Look { block: Block::one([0, 0]), segments_from: 0, vertices_from: 0, state: State::Crossed };
    let numbers: Vec<u32> = (0..11).collect();
    search.look(&look, &numbers, &mut (0..20).collect()).unwrap();
    assert!(search.tasks.is_empty());
}
