//! The fast check of each rule, in a file under the name of the rule.
//!
//! | rules | files |
//! | --- | --- |
//! | R1 | `live` |
//! | L1, L2, L3 | `twin`, `next_prev`, `target` |
//! | V1, V2 | `leaving`, `rotation` |
//! | B1, B2 | `cycle`, `isolated` |
//! | F1, F2 | `outer`, `listed` |
//! | T1 … T4 | `outside`, `nesting`, `euler`, `bounds` |
//! | M1 … M8 | `used`, `simple`, `sides`, `closed`, `connected`, `borders`, `genus`, `kept` |
//! | G1 … G5 | `finite`, `angles`, `winding`, `disjoint`, `inside` |

pub(super) mod borders;
pub(super) mod bounds;
pub(super) mod closed;
pub(super) mod connected;
pub(super) mod cycle;
pub(super) mod euler;
pub(super) mod genus;
pub(super) mod isolated;
pub(super) mod kept;
pub(super) mod leaving;
pub(super) mod listed;
pub(super) mod live;
pub(super) mod nesting;
pub(super) mod next_prev;
pub(super) mod outer;
pub(super) mod outside;
pub(super) mod rotation;
pub(super) mod sides;
pub(super) mod simple;
pub(super) mod target;
pub(super) mod twin;
pub(super) mod used;

#[cfg(feature = "geometry")]
pub(super) mod angles;
#[cfg(feature = "geometry")]
pub(super) mod disjoint;
#[cfg(feature = "geometry")]
pub(super) mod finite;
#[cfg(feature = "geometry")]
pub(super) mod inside;
#[cfg(feature = "geometry")]
pub(super) mod winding;
