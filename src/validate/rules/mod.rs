//! The checks of the rules, in the groups of the [catalogue](super::catalogue): [`links`], [`faces`], [`whole`], [`mesh`]. R1 stands in
//! [`live`], and each of G1 … G5 in a file of its own.

pub(super) mod faces;
pub(super) mod links;
pub(super) mod live;
pub(super) mod mesh;
pub(super) mod whole;

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
