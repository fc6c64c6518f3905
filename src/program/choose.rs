//! Test bodies that draw their decisions from a source of choices, so that several engines can run the same body.
//!
//! The body asks a [`Choose`] for numbers and builds its test case from them. The source belongs to an engine:
//!
//! | source | engine |
//! | --- | --- |
//! | [`Odometer`], turned by [`for_each_choice`] | exhaustive: every sequence of answers, one after the other |
//! | [`Bytes`] | a fuzzer's bytes, or a `Vec<u8>` of quickcheck, which then shrinks the choices too |
//! | [`Random`] | random numbers from a seed, without another crate |
//! | `arbitrary::Unstructured` (feature `arbitrary`) | a fuzzer's bytes, already wrapped |
//! | `quickcheck::Gen` (feature `quickcheck`) | quickcheck, at random |
//! | `proptest::test_runner::TestRunner` (feature `proptest`) | proptest, at random |
//! | an implementation that answers with `kani::any` | a model checker: all sequences at once |
//!
//! ```
//! use twinedge::program::choose::{Bytes, Choose, for_each_choice};
//!
//! /// Two dice: the second has as many sides as the first shows.
//! fn throw(source: &mut impl Choose) -> usize {
//!     let first = 1 + source.choose(6);
//!     first + source.choose(first)
//! }
//!
//! let mut most = 0;
//! assert_eq!(for_each_choice(|source| most = most.max(throw(source))), 1 + 2 + 3 + 4 + 5 + 6);
//! assert_eq!(most, 11);
//! assert_eq!(throw(&mut Bytes::new(&[5, 5])), 11);
//! ```

use alloc::vec::Vec;

/// A source of choices.
pub trait Choose {
    /// Returns a number below `n`; 0 if `n` is 0.
    fn choose(&mut self, n: usize) -> usize;
}

/// Choices from bytes. Each choice takes as few bytes as `n` needs, the lowest first, modulo `n`. When the bytes run out, every
/// choice is 0.
#[derive(Clone, Copy, Debug)]
pub struct Bytes<'a> {
    rest: &'a [u8],
}

impl<'a> Bytes<'a> {
    /// Choices from these bytes.
    #[must_use]
    pub const fn new(bytes: &'a [u8]) -> Self {
        Self { rest: bytes }
    }

    /// The bytes not yet taken.
    #[must_use]
    pub const fn rest(&self) -> &'a [u8] {
        self.rest
    }
}

impl Choose for Bytes<'_> {
    fn choose(&mut self, n: usize) -> usize {
        let largest = n.saturating_sub(1);
        if largest == 0 {
            return 0;
        }
        let wanted = (usize::BITS - largest.leading_zeros()).div_ceil(8) as usize;
        let (taken, rest) = self.rest.split_at(wanted.min(self.rest.len()));
        self.rest = rest;
        taken.iter().rev().fold(0, |number, byte| number << 8 | usize::from(*byte)) % n
    }
}

/// Random choices, the same for the same seed (the generator `splitmix64`: Steele, Lea and Flood, 2014).
///
/// ```
/// use twinedge::program::choose::{Choose, Random};
/// let throws = |seed| { let mut die = Random::seeded(seed); [(); 20].map(|()| 1 + die.choose(6)) };
/// assert_eq!(throws(1), throws(1));
/// assert_ne!(throws(1), throws(2));
/// assert!(throws(3).iter().all(|throw| (1..=6).contains(throw)));
/// ```
#[derive(Clone, Debug)]
pub struct Random(u64);

impl Random {
    /// Choices from this seed.
    #[must_use]
    pub const fn seeded(seed: u64) -> Self {
        Self(seed)
    }
}

impl Choose for Random {
    fn choose(&mut self, n: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mixed = (self.0 ^ self.0 >> 30).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let mixed = (mixed ^ mixed >> 27).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((mixed ^ mixed >> 31) % n.max(1) as u64) as usize
    }
}

#[cfg(feature = "arbitrary")]
impl Choose for arbitrary::Unstructured<'_> {
    /// Returns 0 when the bytes have run out.
    fn choose(&mut self, n: usize) -> usize {
        self.int_in_range(0..=n.saturating_sub(1)).unwrap_or(0)
    }
}

#[cfg(feature = "quickcheck")]
impl Choose for quickcheck::Gen {
    /// Every number is equally likely. (`usize::arbitrary` prefers the ends of its range, which are nothing special here.)
    fn choose(&mut self, n: usize) -> usize {
        const ALL: [u8; 256] = {
            let mut all = [0; 256];
            let mut byte = 0;
            while byte < 256 {
                all[byte] = byte as u8;
                byte += 1;
            }
            all
        };
        let bytes: [u8; 8] = core::array::from_fn(|_| self.choose(&ALL).copied().unwrap_or_default());
        (u64::from_le_bytes(bytes) % n.max(1) as u64) as usize
    }
}

#[cfg(feature = "proptest")]
impl Choose for proptest::test_runner::TestRunner {
    fn choose(&mut self, n: usize) -> usize {
        use proptest::strategy::{Strategy, ValueTree};
        // A range that is not empty always has a number.
        (0..n.max(1)).new_tree(self).map_or(0, |tree| tree.current())
    }
}

/// The answers of one run of a body, turned to the answers of the next run. See [`for_each_choice`].
#[derive(Clone, Debug, Default)]
pub struct Odometer {
    /// The answers, each with its number of alternatives.
    wheels: Vec<(usize, usize)>,
    asked: usize,
}

impl Odometer {
    /// The answers of this run, omitting forced ones. As bytes they make [`Bytes`] give the same answers, provided that no choice
    /// was among more than 256.
    #[must_use]
    pub fn answers(&self) -> impl ExactSizeIterator<Item = usize> + '_ {
        self.wheels[..self.asked].iter().map(|(answer, _)| *answer)
    }

    /// Advances to the next sequence: increments the last answer that can be incremented and drops the answers after it. Returns
    /// false at the end.
    fn turn(&mut self) -> bool {
        self.asked = 0;
        while let Some((answer, n)) = self.wheels.pop() {
            if answer + 1 < n {
                self.wheels.push((answer + 1, n));
                return true;
            }
        }
        false
    }
}

impl Choose for Odometer {
    fn choose(&mut self, n: usize) -> usize {
        if n <= 1 {
            return 0;
        }
        if self.asked == self.wheels.len() {
            self.wheels.push((0, n));
        }
        let (answer, known) = &mut self.wheels[self.asked];
        // A body that asks a different question the second time still gets an answer.
        *known = n;
        *answer = (*answer).min(n - 1);
        self.asked += 1;
        *answer
    }
}

/// Runs the body once for every sequence of answers, and returns the number of runs.
///
/// Sequences are not ordered by length: to find a shortest failing one, raise a bound on the number of steps from 1. To end a run
/// early, the body stops asking.
///
/// The body must ask the same questions after the same answers, and the number of questions must be bounded; otherwise this
/// function does not terminate.
pub fn for_each_choice(mut body: impl FnMut(&mut Odometer)) -> u64 {
    let mut odometer = Odometer::default();
    let mut count = 0;
    loop {
        body(&mut odometer);
        count += 1;
        // Answers not used in this run belong to no sequence.
        odometer.wheels.truncate(odometer.asked);
        if !odometer.turn() {
            return count;
        }
    }
}
