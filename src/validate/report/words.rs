//! Numbers that agree with their nouns.

use core::fmt;

/// A number with its noun: `1 map`, `2 maps`.
pub(super) struct Number(pub(super) u64, pub(super) &'static str, pub(super) &'static str);

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(number, one, many) = *self;
        write!(f, "{number} {}", if number == 1 { one } else { many })
    }
}
