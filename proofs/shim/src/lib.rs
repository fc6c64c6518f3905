//! The names of Kani's library that the harnesses use, with its signatures, for the type-checker only.
//!
//! Under `cargo kani` the real library takes this one's place; see `proofs/README.md`.

pub use kani_macros::{proof, unwind};

/// Types of which Kani can make up any value.
pub trait Arbitrary: Sized {
    /// Any value at all.
    fn any() -> Self;
}

impl Arbitrary for usize {
    fn any() -> Self {
        Self::default()
    }
}

/// Any value at all.
#[must_use]
pub fn any<T: Arbitrary>() -> T {
    T::any()
}

/// Leaves out what does not fulfil the condition.
///
/// # Panics
/// If the condition is not fulfilled.
pub fn assume(condition: bool) {
    assert!(condition, "only a model checker can leave out what it has already chosen");
}
