//! The checks of the rules, grouped as in the [catalogue](super::catalogue): [`links`], [`faces`], [`whole`], [`mesh`]. R1 is in
//! [`live`]. The crate `twinedge-map` checks G1 … G5.

pub(super) mod faces;
pub(super) mod links;
pub(super) mod live;
pub(super) mod mesh;
pub(super) mod whole;
