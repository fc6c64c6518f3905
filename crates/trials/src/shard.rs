//! One of several parts of the same work.

use std::fmt;
use std::str::FromStr;
use thiserror::Error;

/// One of N parts of the same work, counted from 0. The parts are disjoint, and together they are the whole work.
///
/// The part of a piece depends on the piece alone, not on threads or machines. With more parts than pieces, some are empty.
///
/// ```
/// use twinedge_trials::Shard;
/// let shard: Shard = "2/8".parse()?;
/// assert_eq!((shard.index(), shard.count()), (2, 8));
/// assert_eq!(shard.to_string(), "2/8");
/// # Ok::<(), twinedge_trials::ParseShardError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(into = "String", try_from = "String")
)]
pub struct Shard {
    index: u32,
    count: u32,
}

/// There is no such part.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum ShardError {
    /// The number of parts is 0.
    #[error("there must be at least 1 part")]
    NoParts,
    /// Parts are counted from 0.
    #[error("there is no part {index} of {count}; parts are counted from 0")]
    OutOfRange {
        /// The part.
        index: u32,
        /// The number of all parts.
        count: u32,
    },
}

/// The error of a text that is not a part.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum ParseShardError {
    /// It is not two numbers with `/` between them.
    #[error("expected K/N, two whole numbers, as in 0/4")]
    Syntax,
    /// There is no such part.
    #[error(transparent)]
    Shard(#[from] ShardError),
}

impl Shard {
    /// All of the work: part 0 of 1.
    pub const WHOLE: Self = Self { index: 0, count: 1 };

    /// Returns part `index` of `count`.
    ///
    /// # Errors
    /// [`ShardError::NoParts`] if `count` is 0, [`ShardError::OutOfRange`] if `index` is not below it.
    pub const fn new(index: u32, count: u32) -> Result<Self, ShardError> {
        match (index, count) {
            (_, 0) => Err(ShardError::NoParts),
            (index, count) if index >= count => Err(ShardError::OutOfRange { index, count }),
            (index, count) => Ok(Self { index, count }),
        }
    }

    /// Returns the part, from 0.
    #[must_use]
    pub const fn index(self) -> u32 {
        self.index
    }

    /// Returns the number of parts.
    #[must_use]
    pub const fn count(self) -> u32 {
        self.count
    }

    /// Returns true if it is all of the work.
    #[must_use]
    pub const fn is_whole(self) -> bool {
        self.count == 1
    }

    /// Returns true if the piece with this number is in this part.
    pub(crate) const fn has(self, number: u64) -> bool {
        number % self.count as u64 == self.index as u64
    }

    /// Returns true if the piece that these bytes name is in this part. Always the same for the same bytes (FNV-1a).
    pub(crate) fn has_name(self, name: &[u8]) -> bool {
        let hash = name.iter().fold(0xCBF2_9CE4_8422_2325_u64, |hash, byte| {
            (hash ^ u64::from(*byte)).wrapping_mul(0x0000_0100_0000_01B3)
        });
        // For names that differ only in the last byte, the low bits are not spread enough.
        self.has(hash ^ hash >> 32)
    }

    /// Returns the numbers below `count` that are in this part.
    pub(crate) fn numbers(self, count: usize) -> impl ExactSizeIterator<Item = usize> {
        (self.index as usize..count.max(self.index as usize)).step_by(self.count as usize)
    }
}

impl fmt::Display for Shard {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.index, self.count)
    }
}

impl FromStr for Shard {
    type Err = ParseShardError;

    fn from_str(text: &str) -> Result<Self, ParseShardError> {
        let number = |digits: &str| {
            let all_digits = digits.bytes().all(|byte| byte.is_ascii_digit());
            digits.parse().ok().filter(|_| all_digits).ok_or(ParseShardError::Syntax)
        };
        let (index, count) = text.split_once('/').ok_or(ParseShardError::Syntax)?;
        Ok(Self::new(number(index)?, number(count)?)?)
    }
}

impl From<Shard> for String {
    fn from(shard: Shard) -> Self {
        shard.to_string()
    }
}

impl TryFrom<String> for Shard {
    type Error = ParseShardError;

    fn try_from(text: String) -> Result<Self, ParseShardError> {
        text.parse()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_parts_are_disjoint_and_together_all() {
        for count in 1..20 {
            let parts: Vec<Shard> = (0..count).map(|index| Shard::new(index, count).unwrap()).collect();
            for piece in 0..50_u64 {
                assert_eq!(parts.iter().filter(|part| part.has(piece)).count(), 1);
                assert_eq!(parts.iter().filter(|part| part.has_name(&piece.to_le_bytes())).count(), 1);
            }
            let mut numbers: Vec<usize> = parts.iter().flat_map(|part| part.numbers(7)).collect();
            numbers.sort_unstable();
            assert_eq!(numbers, [0, 1, 2, 3, 4, 5, 6]);
        }
    }

    #[test]
    fn parts_that_are_not_there_are_errors() {
        assert_eq!(Shard::new(0, 0), Err(ShardError::NoParts));
        assert_eq!(Shard::new(4, 4), Err(ShardError::OutOfRange { index: 4, count: 4 }));
        assert_eq!("4/4".parse::<Shard>(), Err(ShardError::OutOfRange { index: 4, count: 4 }.into()));
        for text in ["", "1", "1/", "/2", "-1/2", "+1/2", "1/2/3", "a/b", " 1/2", "1/4294967296"] {
            assert_eq!(text.parse::<Shard>(), Err(ParseShardError::Syntax), "{text}");
        }
    }
}
