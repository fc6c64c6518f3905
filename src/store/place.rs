//! The place that a boundary component has in the lists of its face, as one number.
//!
//! Small numbers are positions among the inner boundary components. The others have names, all of them here. While an
//! operator runs, the places of outer boundary components also serve as links of a queue: then a number is the index of the
//! boundary component that follows.

/// It is the outer boundary component.
pub(crate) const OUTER: u32 = u32::MAX;

/// It ends the queue of an operator.
pub(crate) const LAST: u32 = u32::MAX - 1;

/// No face lists it.
pub(crate) const UNLISTED: u32 = u32::MAX - 2;

/// Positions and indices are below this in every store.
pub(crate) const MOST: u32 = 1 << 31;

const _: () = assert!(OUTER != LAST && LAST != UNLISTED && OUTER != UNLISTED);
const _: () = assert!(MOST < OUTER && MOST < LAST && MOST < UNLISTED);
