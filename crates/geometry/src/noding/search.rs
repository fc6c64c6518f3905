//! Finds the hot pixels that segments visit.
//!
//! The plane is halved repeatedly until a block contains few segments and few vertices; there, every pair is tried. Three
//! techniques avoid most of the other pairs:
//!
//! - If a block has no vertex, all its segments are chords, and their crossings are listed without trying pairs. Without
//!   crossings there is nothing to find; otherwise only visits to the now known vertices remain.
//! - If halving does not separate segments because most of them meet in one pixel, that pixel is cut out of the block: in the
//!   other parts they are apart.
//! - If halving does not separate segments because most of them lie side by side, they are set aside as a *bundle*. The others
//!   are searched without them, and bisection finds anything between them.
//!
//! ```text
//!   ┌───────┬─┬───────┐
//!   │       │ │       │   A block with a busy pixel p: two large parts, two parts of a column,
//!   │       ├─┤       │   and p itself, which is hot. Segments that meet in p and nowhere
//!   │       │p│       │   else are chords that do not cross in the other four.
//!   │       ├─┤       │
//!   │       │ │       │
//!   └───────┴─┴───────┘
//! ```
//!
//! A block with many segments is cut into tiles at once, enough to have few segments in each, if most segments are so short that
//! one or two tiles contain them. This saves passing over all of them for each halving.
//!
//! Blocks consist of whole pixels, so each hot pixel is in one leaf, and each visit is found once.

use super::bundle::Bundle;
use super::chords::{Chord, Chords, chords};
use super::input::NodingError;
use super::pixel::{Block, Pixel, Pixels, Segment, Steps};
use core::sync::atomic::AtomicUsize;
use filing::{Content, Filing, PartFiling};
use limits::{Budget, limit};
use parts::{Tiles, around, halves};
use vertices::Vertices;

mod filing;
mod fork;
mod limits;
mod parts;
mod vertices;

#[cfg(test)]
mod tests;

/// Up to this number of pairs, trying all is cheaper than halving.
const FEW_PAIRS: usize = limit(256, 8);

/// Up to this number of pairs, trying all is cheaper than anything but halving.
const SOME_PAIRS: usize = limit(8192, 16);

/// Up to this number of vertices are tried on all segments, and up to this number of segments that end in a block on all others.
const FEW: usize = limit(16, 2);

/// With more crossings than this for each chord of a block, they are not listed.
const DENSE: usize = limit(8, 1);

/// From this number of segments on, a block is cut into tiles.
const MANY: usize = limit(64, 4);

#[derive(Default)]
pub(super) struct PixelVisits {
    /// Pairs of a segment and a vertex whose pixel it visits without ending there.
    pub(super) visits: Vec<[u32; 2]>,
    /// Segments whose line between pixel centres may visit other pixels than the segment; some are listed repeatedly. Segments
    /// that already run between centres are not listed.
    pub(super) doubtful: Vec<u32>,
}

enum Task<'a> {
    Look(Look),
    /// Try a bundle on the vertices found in its block since it was set aside.
    Finish {
        bundle: Bundle<'a>,
        vertices_from: usize,
    },
}

/// A block to search, with its segments and vertices at the top of the two pools.
struct Look {
    block: Block,
    segments_from: usize,
    vertices_from: usize,
    state: State,
}

#[derive(Clone, Copy, PartialEq)]
enum State {
    New,
    /// A pixel was cut out to make it. The next step is to halve it, which bounds the depth.
    Cut,
    Crossed,
}

struct Search<'a> {
    pixels: Pixels,
    segments: &'a [Segment],
    vertices: Vertices<'a>,
    found: PixelVisits,
    budget: Budget<'a>,
    tasks: Vec<Task<'a>>,
    bundles: usize,
    segment_pool: Vec<u32>,
    vertex_pool: Vec<u32>,
    filing: Filing,
    /// The blocks around the segments of a leaf, kept to reuse memory.
    boxes: Vec<Block>,
}

/// Adds a vertex for each pixel without one where two segments cross, and finds all visits.
///
/// Segments must not overlap in more than a point; vertices must be distinct and include all ends.
///
/// Returns an error if there are more than `most` visits.
///
/// Cost: O((n + k) log n) in practice, for n segments and vertices and k crossings and visits.
pub(super) fn search(
    pixels: Pixels,
    segments: &[Segment],
    vertices: &mut Vec<Pixel>,
    most: usize,
) -> Result<PixelVisits, NodingError> {
    if segments.len() >= u32::MAX as usize {
        return Err(NodingError::TooMany);
    }
    let all = vertices.iter().copied().map(Block::one).reduce(|a, b| a.join(&b));
    let task = |block| Task::Look(Look { block, segments_from: 0, vertices_from: 0, state: State::New });
    let visits = AtomicUsize::new(0);
    let mut search = Search {
        pixels,
        segments,
        found: PixelVisits::default(),
        budget: Budget { most, visits: &visits, counted: 0 },
        tasks: all.map(task).into_iter().collect(),
        bundles: 0,
        segment_pool: (0..segments.len() as u32).collect(),
        vertex_pool: (0..vertices.len() as u32).collect(),
        filing: Filing::default(),
        boxes: Vec::new(),
        vertices: Vertices::new(vertices),
    };
    search.run()?;
    let Search { found, vertices: all, .. } = search;
    if found.visits.len() > most {
        return Err(NodingError::TooManyCuts { allowed: most });
    }
    let added = all.added();
    vertices.extend(added);
    Ok(found)
}

/// Returns the number of pairs to try among `m` segments and between them and `h` vertices.
fn pairs(m: usize, h: usize) -> usize {
    m.saturating_mul(m + h)
}

/// The treatment of a block that halving does not separate.
enum Instead {
    Cut(Pixel),
    SetAside(Vec<Chord>),
    Cross(Vec<Pixel>),
}

impl Search<'_> {
    fn look(&mut self, look: &Look, segments: &[u32], vertices: &mut Vec<u32>) -> Result<(), NodingError> {
        let block = &look.block;
        if look.state == State::Crossed {
            self.look_for_visits(block, segments, vertices);
            return Ok(());
        }
        if block.low == block.high {
            return self.look_at_pixel(block.low, segments, vertices);
        }
        let work = pairs(segments.len(), vertices.len());
        if work <= FEW_PAIRS {
            return self.try_all(block, segments, vertices);
        }
        let mut busy = None;
        if vertices.is_empty() {
            match chords(self.pixels, block, self.segments, segments, DENSE * segments.len()) {
                Chords::Cross { pairs, all: true } => {
                    self.add(self.crossings(&pairs), vertices)?;
                    self.look_for_visits(block, segments, vertices);
                    return Ok(());
                }
                Chords::Cross { pairs, all: false } => busy = self.busy(&pairs),
                Chords::SideBySide(_) | Chords::Apart => return Ok(()),
            }
        }
        if segments.len() >= MANY && self.tile(block, segments, vertices) {
            return Ok(());
        }
        let (tasks, segments_to, vertices_to) = (self.tasks.len(), self.segment_pool.len(), self.vertex_pool.len());
        let most = self.halve_block(block, segments, vertices, State::New);
        if most <= work - work / 4 || (work > SOME_PAIRS && look.state == State::Cut) {
            return Ok(());
        }
        // Halving is hardly worth the effort.
        let instead =
            if work <= SOME_PAIRS { None } else { busy.map(Instead::Cut).or_else(|| self.instead(block, segments)) };
        if work <= SOME_PAIRS || instead.is_some() {
            self.tasks.truncate(tasks);
            self.segment_pool.truncate(segments_to);
            self.vertex_pool.truncate(vertices_to);
        }
        match instead {
            Some(Instead::Cut(pixel)) => {
                self.part(&around(block, pixel), segments, vertices);
                vertices.retain(|&v| self.vertices[v as usize] == pixel);
                self.look_at_pixel(pixel, segments, vertices)
            }
            Some(Instead::SetAside(chords)) => self.set_aside(chords, block, segments, vertices),
            Some(Instead::Cross(crossings)) => {
                self.add(crossings, vertices)?;
                self.look_for_visits(block, segments, vertices);
                Ok(())
            }
            None if work <= SOME_PAIRS => self.try_all(block, segments, vertices),
            None => Ok(()),
        }
    }

    /// Searches a block whose crossings are among its vertices. Vertices beyond it may be listed, so one pixel may have many.
    fn look_for_visits(&mut self, block: &Block, segments: &[u32], vertices: &[u32]) {
        let are_few = vertices.len() <= FEW || segments.len().saturating_mul(vertices.len()) <= FEW_PAIRS;
        if are_few || block.low == block.high {
            self.try_visits(segments, vertices);
        } else {
            self.halve_block(block, segments, vertices, State::Crossed);
        }
    }

    /// Defers the tiles of a block, if most segments lie in few of them and no tile has most.
    fn tile(&mut self, block: &Block, segments: &[u32], vertices: &[u32]) -> bool {
        let tiles = Tiles::new(block, segments.len());
        self.filing.clear(tiles.len());
        // The remaining budget of tiles for segments that are in more than one.
        let mut left = segments.len();
        for &id in segments {
            let segment = &self.segments[id as usize];
            let around = self.pixels.around(segment);
            let range = tiles.of(&around);
            if let Some(tile) = range.only() {
                self.filing.segment(tile, id, around);
                continue;
            }
            let Some(rest) = left.checked_sub(range.len()) else {
                return false;
            };
            left = rest;
            for tile in range.tiles() {
                if self.pixels.line_nears(segment, &tiles.block(tile)) {
                    self.filing.segment(tile, id, around);
                }
            }
        }
        let most = segments.len() - segments.len() / 4;
        if self.filing.contents().iter().any(|content| content.segments > most) {
            return false;
        }
        for &id in vertices {
            self.filing.vertex(tiles.at(self.vertices[id as usize]), id);
        }
        self.put_off(|tile| tiles.block(tile), State::New);
        true
    }

    /// Defers the halves of a block. Returns the number of pairs in the half with more.
    fn halve_block(&mut self, block: &Block, segments: &[u32], vertices: &[u32], state: State) -> usize {
        let (halves, axis) = halves(block);
        let middle = halves[0].high[axis];
        self.filing.clear(2);
        for &id in segments {
            let segment = &self.segments[id as usize];
            let around = self.pixels.around(segment);
            if around.high[axis] <= middle {
                self.filing.segment(0, id, around);
            } else if around.low[axis] > middle {
                self.filing.segment(1, id, around);
            } else {
                for (number, half) in halves.iter().enumerate() {
                    if self.pixels.line_nears(segment, half) {
                        self.filing.segment(number, id, around);
                    }
                }
            }
        }
        for &id in vertices {
            let pixel = self.vertices[id as usize];
            self.filing.vertex(usize::from(pixel[axis] > middle), id);
        }
        self.put_off(|number| halves[number], state)
    }

    /// Defers the parts of a block after a pixel was cut out.
    fn part(&mut self, parts: &[Block], segments: &[u32], vertices: &[u32]) {
        self.filing.clear(parts.len());
        for &id in segments {
            let segment = &self.segments[id as usize];
            let around = self.pixels.around(segment);
            for (number, part) in parts.iter().enumerate() {
                if around.overlaps(part) && (part.includes(&around) || self.pixels.line_nears(segment, part)) {
                    self.filing.segment(number, id, around);
                }
            }
        }
        for &id in vertices {
            let pixel = self.vertices[id as usize];
            for (number, _) in parts.iter().enumerate().filter(|(_, part)| part.contains(pixel)) {
                self.filing.vertex(number, id);
            }
        }
        self.put_off(|number| parts[number], State::Cut);
    }

    /// Defers parts of a block with the segments and vertices filed under each, skipping parts without anything to find. Returns
    /// the largest number of pairs in a part.
    fn put_off(&mut self, part: impl Fn(usize) -> Block, state: State) -> usize {
        let mut most = 0;
        // A visit takes a vertex, and an unknown crossing takes two segments.
        let worth = |c: &Content| c.segments > 0 && (c.vertices > 0 || c.segments >= 2 && state != State::Crossed);
        self.filing.pour(&mut self.segment_pool, &mut self.vertex_pool, worth, |filed| {
            let PartFiling { content, segments_from, vertices_from, .. } = filed;
            let block = part(filed.part).meet(&content.around);
            self.tasks.push(Task::Look(Look { block, segments_from, vertices_from, state }));
            most = most.max(pairs(content.segments, content.vertices));
        });
        most
    }

    fn wait(&mut self, block: Block, segments: &[u32], vertices: &[u32], state: State) {
        let (segments_from, vertices_from) = (self.segment_pool.len(), self.vertex_pool.len());
        self.segment_pool.extend(segments);
        self.vertex_pool.extend(vertices);
        self.tasks.push(Task::Look(Look { block, segments_from, vertices_from, state }));
    }

    fn instead(&self, block: &Block, segments: &[u32]) -> Option<Instead> {
        if let Some(hub) = self.hub(block, segments) {
            return Some(Instead::Cut(hub));
        }
        let (ending, across): (Vec<u32>, Vec<u32>) = segments.iter().partition(|&&id| self.end_in(block, id).is_some());
        if across.len() < ending.len() {
            return None;
        }
        let pairs = match chords(self.pixels, block, self.segments, &across, DENSE * across.len()) {
            Chords::SideBySide(chords) => return Some(Instead::SetAside(chords)),
            Chords::Cross { pairs, all: false } => return self.busy(&pairs).map(Instead::Cut),
            Chords::Cross { pairs, all: true } => pairs,
            Chords::Apart => Vec::new(),
        };
        if ending.len() > FEW {
            return None;
        }
        let mut crossings = self.crossings(&pairs);
        for &id in &ending {
            crossings.extend(self.crossings_with(id, block, segments));
        }
        Some(Instead::Cross(crossings))
    }

    /// Returns the pixels in which pairs of segments cross.
    fn crossings(&self, pairs: &[[u32; 2]]) -> Vec<Pixel> {
        let segments = pairs.iter().map(|pair| pair.map(|id| &self.segments[id as usize]));
        segments.filter_map(|[s, t]| self.pixels.crossing(s, t)).collect()
    }

    /// Returns the pixels of a block in which a segment crosses others.
    fn crossings_with(&self, id: u32, block: &Block, others: &[u32]) -> impl Iterator<Item = Pixel> {
        let segment = &self.segments[id as usize];
        let others = others.iter().map(|&other| &self.segments[other as usize]);
        others.filter_map(|other| self.pixels.crossing(segment, other)).filter(|&pixel| block.contains(pixel))
    }

    /// Returns the pixel in which most of the first pairs cross.
    fn busy(&self, pairs: &[[u32; 2]]) -> Option<Pixel> {
        let mut some = self.crossings(&pairs[..pairs.len().min(64)]);
        some.sort_unstable();
        some.chunk_by(|p, q| p == q).max_by_key(|equal| equal.len()).map(|equal| equal[0])
    }

    /// Returns a pixel in the block in which more than half of the segments end.
    fn hub(&self, block: &Block, segments: &[u32]) -> Option<Pixel> {
        // The majority vote of Boyer and Moore, and then a count of its winner.
        let ends = || segments.iter().flat_map(|&id| self.segments[id as usize].ends);
        let (mut leader, mut lead) = (None, 0_usize);
        for end in ends().filter(|&end| block.contains(self.vertices[end as usize])) {
            if lead == 0 {
                leader = Some(end);
            }
            lead = if leader == Some(end) { lead + 1 } else { lead - 1 };
        }
        let leader = leader.filter(|&leader| ends().filter(|&end| end == leader).count() > segments.len() / 2);
        leader.map(|id| self.vertices[id as usize])
    }

    /// Returns the position of a segment's end in the block.
    fn end_in(&self, block: &Block, id: u32) -> Option<Steps> {
        let Segment { a, b, .. } = self.segments[id as usize];
        [a, b].into_iter().find(|&end| block.contains(self.pixels.at(end)))
    }

    /// Searches one pixel: it is hot if it has a vertex, or if two segments cross in it.
    fn look_at_pixel(&mut self, pixel: Pixel, segments: &[u32], vertices: &mut Vec<u32>) -> Result<(), NodingError> {
        if vertices.is_empty() {
            let Chords::Cross { .. } = chords(self.pixels, &Block::one(pixel), self.segments, segments, 1) else {
                return Ok(());
            };
            self.add(vec![pixel], vertices)?;
        }
        self.try_visits(segments, vertices);
        Ok(())
    }

    fn try_all(&mut self, block: &Block, segments: &[u32], vertices: &mut Vec<u32>) -> Result<(), NodingError> {
        self.surround(segments);
        let mut crossings = Vec::new();
        for (i, &id) in segments.iter().enumerate() {
            for (&other, around) in segments[..i].iter().zip(&self.boxes) {
                if around.overlaps(&self.boxes[i]) {
                    let [s, t] = [id, other].map(|id| &self.segments[id as usize]);
                    crossings.extend(self.pixels.crossing(s, t).filter(|&pixel| block.contains(pixel)));
                }
            }
        }
        self.add(crossings, vertices)?;
        self.try_boxes(segments, vertices);
        Ok(())
    }

    fn surround(&mut self, segments: &[u32]) {
        self.boxes.clear();
        self.boxes.extend(segments.iter().map(|&id| self.pixels.around(&self.segments[id as usize])));
    }

    fn try_visits(&mut self, segments: &[u32], vertices: &[u32]) {
        self.surround(segments);
        self.try_boxes(segments, vertices);
    }

    /// Tries all vertices on all segments, given the blocks around the segments.
    fn try_boxes(&mut self, segments: &[u32], vertices: &[u32]) {
        let before = self.found.doubtful.len();
        for &v in vertices {
            let pixel = self.vertices[v as usize];
            for (&id, _) in segments.iter().zip(&self.boxes).filter(|(_, around)| around.contains(pixel)) {
                let segment = &self.segments[id as usize];
                if segment.ends.contains(&v) {
                    continue;
                }
                if self.pixels.visits(segment, pixel) {
                    self.found.visits.push([id, v]);
                } else if self.pixels.shift > 0 && Pixels::ONE_STEP.visits(&self.pixels.between_centres(segment), pixel)
                {
                    self.found.doubtful.push(id);
                }
            }
        }
        if self.found.doubtful.len() > before {
            let mut doubtful = self.found.doubtful.split_off(before);
            doubtful.sort_unstable();
            doubtful.dedup();
            self.found.doubtful.append(&mut doubtful);
        }
    }

    /// Adds the pixels that are not yet among the vertices of their block.
    fn add(&mut self, mut pixels: Vec<Pixel>, vertices: &mut Vec<u32>) -> Result<(), NodingError> {
        if pixels.is_empty() {
            return Ok(());
        }
        pixels.sort_unstable();
        pixels.dedup();
        let mut known: Vec<Pixel> = vertices.iter().map(|&v| self.vertices[v as usize]).collect();
        known.sort_unstable();
        for pixel in pixels {
            if known.binary_search(&pixel).is_err() {
                vertices.push(self.vertices.push(pixel).ok_or(NodingError::TooMany)?);
            }
        }
        Ok(())
    }

    /// Sets a bundle aside, and defers the search of the block without it.
    fn set_aside(
        &mut self,
        chords: Vec<Chord>,
        block: &Block,
        segments: &[u32],
        vertices: &mut Vec<u32>,
    ) -> Result<(), NodingError> {
        let bundle = Bundle { pixels: self.pixels, segments: self.segments, chords };
        let (mut others, mut crossings) = (Vec::new(), Vec::new());
        for &id in segments {
            if let Some(end) = self.end_in(block, id) {
                others.push(id);
                crossings.extend(bundle.crossings(block, &self.segments[id as usize], end));
            } else if self.pixels.shift > 0 {
                self.found.doubtful.push(id);
            }
        }
        self.add(crossings, vertices)?;
        for &v in &*vertices {
            self.try_bundle(&bundle, v);
        }
        self.bundles += 1;
        self.tasks.push(Task::Finish { bundle, vertices_from: self.vertices.len() });
        self.wait(*block, &others, vertices, State::New);
        Ok(())
    }

    fn try_bundle(&mut self, bundle: &Bundle<'_>, v: u32) {
        let visitors = bundle.visitors(self.vertices[v as usize]);
        self.found.visits.extend(visitors.map(|id| [id, v]));
    }
}
