//! Queries of a map that involve more than one record.
//!
//! Each takes a [`PlanarMap`](crate::map::PlanarMap), does not change it, and states its cost.
//!
//! | module | answers |
//! | --- | --- |
//! | [`area`] | how large is a face, a feature? |
//! | [`colouring`] | which colours tell neighbours apart? |
//! | [`contour`] | what is the outline of a feature, a face, any set of faces? |
//! | [`coverage`] | which faces does a feature cover, and which are claimed twice? |
//! | [`neighbours`] | which faces or features share a border, where, and how long is it? |
//! | [`mod@overlay`] | what do two maps make together? |

pub mod area;
pub mod colouring;
pub mod contour;
pub mod coverage;
pub mod neighbours;
pub mod overlay;
