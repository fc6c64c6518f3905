//! Segments side by side in a block, searched by bisection.
//!
//! ```text
//!   ──────────────────────────── 0
//!           \                        A short segment crosses the chords before and after its end, one by one, until it
//!   ─────────\────────────────── 1   crosses no more. A vertex is visited by chords that are neighbours.
//!             \        ┌─┐
//!   ───────────\───────┼·┼────── 2
//!                      └─┘
//!   ──────────────────────────── 3
//! ```

use super::chords::Chord;
use super::pixel::{Block, Pixel, Pixels, Segment, Steps, cross, minus};

/// Ordered segments that cut across a block without crossing in it.
pub(super) struct Bundle<'a> {
    pub(super) pixels: Pixels,
    pub(super) segments: &'a [Segment],
    pub(super) chords: Vec<Chord>,
}

impl Bundle<'_> {
    fn segment(&self, chord: Chord) -> &Segment {
        &self.segments[chord.segment as usize]
    }

    /// Returns the side of a chord on which a position of the block lies: negative beyond the chord, towards the next one.
    fn side(&self, chord: Chord, position: Steps) -> i128 {
        let segment = self.segment(chord);
        let left = cross(segment.direction(), minus(position, segment.a)).signum();
        if chord.first_is_left { left } else { -left }
    }

    /// Returns the crossings inside the block with a segment that has an end in it.
    ///
    /// Cost: O(log m) for m chords, and O(1) for each crossing.
    pub(super) fn crossings(&self, block: &Block, segment: &Segment, end: Steps) -> impl Iterator<Item = Pixel> {
        let crossing = |chord: &Chord| {
            let pixel = self.pixels.crossing(segment, self.segment(*chord));
            pixel.filter(|&pixel| block.contains(pixel))
        };
        let (before, rest) = self.chords.split_at(self.chords.partition_point(|chord| self.side(*chord, end) < 0));
        let after = &rest[rest.partition_point(|chord| self.side(*chord, end) == 0)..];
        before.iter().rev().map_while(crossing).chain(after.iter().map_while(crossing))
    }

    /// Returns the segments that visit a pixel of the block.
    ///
    /// Cost: O(log m) for m chords, and O(1) for each visit.
    pub(super) fn visitors(&self, pixel: Pixel) -> impl Iterator<Item = u32> {
        let centre = self.pixels.centre(pixel);
        let visits = move |chord: &Chord| self.pixels.visits(self.segment(*chord), pixel);
        let from = self.chords.partition_point(|chord| !visits(chord) && self.side(*chord, centre) < 0);
        self.chords[from..].iter().take_while(move |chord| visits(chord)).map(|chord| chord.segment)
    }
}
