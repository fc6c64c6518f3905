//! The checks of the rules, in the groups of the [catalogue](super::catalogue): [`links`], [`faces`], [`whole`], [`mesh`]. R1 stands in
//! [`live`]. G1 … G5 are checked by the crate `twinedge-map`.

pub(super) mod faces;
pub(super) mod links;
pub(super) mod live;
pub(super) mod mesh;
pub(super) mod whole;
