//! Many segments that all cut across a block: finds their crossings, or their order if none cross.
//!
//! ```text
//!      c   b
//!   +--+---+---+    Each segment is a chord. Walking round the border, chords that do not cross close in the
//!   +a         |    reverse of the order in which they opened, like brackets: here a b b c c a, say. A chord that
//!   |          +a   closes out of turn crosses those that opened after it and are still open, and no others.
//!   +---+--+---+
//!       c  b
//! ```
//!
//! So O(m log m) steps, plus one for each crossing, replace m²/2 pairs.
//!
//! A block owns its left and its lower side. To make that exact, the border is shifted infinitesimally: the sides to the left by
//! ε, the lower and the upper one downwards by δ, infinitely smaller than ε. Then no chord meets a corner, no two chords meet the
//! border at one point, and a crossing is inside exactly if the block owns it.

use super::pixel::{Block, Pixels, Segment, compare, cross, minus};
use crate::threads;
use core::cmp::Ordering;

struct End {
    /// Counter-clockwise: lower, right, upper, left.
    side: u8,
    /// The coordinate along the side, in doubled steps: an integer part, and a remainder with its denominator.
    floor: i64,
    rest: i64,
    denominator: i64,
    /// The decrease of that coordinate as the side moves by the infinitesimal amount, over the same denominator.
    rate: i64,
    chord: u32,
    /// True if the segment leaves the block here.
    leaves: bool,
}

impl End {
    /// Compares two ends counter-clockwise around the border.
    fn order(&self, other: &Self) -> Ordering {
        self.side.cmp(&other.side).then_with(|| {
            let upwards = self
                .floor
                .cmp(&other.floor)
                .then_with(|| compare((self.rest, self.denominator), (other.rest, other.denominator)))
                .then_with(|| compare((other.rate, other.denominator), (self.rate, self.denominator)));
            if self.side < 2 { upwards } else { upwards.reverse() }
        })
    }
}

pub(super) enum Chords {
    /// These pairs cross inside; the list is complete if `all` is true.
    Cross { pairs: Vec<[u32; 2]>, all: bool },
    /// They do not cross, and lie side by side in this order.
    SideBySide(Vec<Chord>),
    /// They do not cross, and are not in one sequence.
    Apart,
}

#[derive(Clone, Copy)]
pub(super) struct Chord {
    pub(super) segment: u32,
    pub(super) first_is_left: bool,
}

/// Arranges these segments in the block. None may end inside, and no two may overlap. Lists at most `most` crossings.
///
/// Cost: O(m log m) for m segments, and O(1) for each crossing.
pub(super) fn chords(pixels: Pixels, block: &Block, segments: &[Segment], ids: &[u32], most: usize) -> Chords {
    let mut ends = Vec::with_capacity(2 * ids.len());
    for (number, &id) in (0..).zip(ids) {
        chord(pixels.sides(block), &segments[id as usize], number, &mut ends);
    }
    threads::sort_unstable_by(&mut ends, |a, b| a.order(b).then(a.chord.cmp(&b.chord)));
    let mut opened = vec![false; ids.len()];
    let (mut open, mut pairs) = (Vec::new(), Vec::new());
    for chord in ends.iter().map(|end| end.chord as usize) {
        if !opened[chord] {
            opened[chord] = true;
            open.push(chord);
        } else if let Some(place) = open.iter().rposition(|&other| other == chord) {
            open.remove(place);
            let crossed = open[place..].iter().take(most - pairs.len());
            pairs.extend(crossed.map(|&other| [ids[chord], ids[other]]));
            if pairs.len() == most {
                return Chords::Cross { pairs, all: false };
            }
        }
    }
    if !pairs.is_empty() {
        return Chords::Cross { pairs, all: true };
    }
    // A chord whose ends are neighbours on the border has all others on one side. Between two such chords lie all others.
    let mut lone = (0..ends.len()).filter(|&i| ends[i].chord == ends[(i + 1) % ends.len()].chord);
    match (lone.next(), lone.next(), lone.next()) {
        (Some(i), Some(_), None) => {
            // Starting at the second end of the first lone chord, counter-clockwise: one end of each chord, in order. Earlier
            // chords lie to the left, going from this end to the other.
            let side_by_side = ends.iter().cycle().skip(i + 1).take(ends.len() / 2);
            let chords = side_by_side.map(|end| Chord { segment: ids[end.chord as usize], first_is_left: !end.leaves });
            Chords::SideBySide(chords.collect())
        }
        _ => Chords::Apart,
    }
}

/// Adds the two ends of a chord, unless the segment misses the block.
fn chord([left, lower, right, upper]: [i64; 4], s: &Segment, number: u32, ends: &mut Vec<End>) {
    let [dx, dy] = s.direction();
    let start = s.a.map(|c| 2 * c);
    // Is a corner to the left of the segment? A corner on its line moves by (−ε, −δ), that is by ε·dy − δ·dx.
    let is_left = [[left, lower], [right, lower], [right, upper], [left, upper]].map(|corner| {
        match cross([dx, dy], minus(corner, start)).cmp(&0) {
            Ordering::Equal => dy > 0 || (dy == 0 && dx < 0),
            sign => sign == Ordering::Greater,
        }
    });
    for (side, at) in [lower, right, upper, left].into_iter().enumerate() {
        if is_left[side] == is_left[(side + 1) % 4] {
            continue;
        }
        // Towards the side, and along it.
        let (across, along) =
            if side % 2 == 0 { ((dy, start[1]), (dx, start[0])) } else { ((dx, start[0]), (dy, start[1])) };
        let denominator = across.0.abs();
        let rate = along.0 * across.0.signum();
        let product = i128::from(at - across.1) * i128::from(rate);
        let (floor, rest) = (product.div_euclid(denominator.into()), product.rem_euclid(denominator.into()));
        ends.push(End {
            side: side as u8,
            floor: along.1 + floor as i64,
            rest: rest as i64,
            denominator,
            rate,
            chord: number,
            leaves: is_left[(side + 1) % 4],
        });
    }
}
