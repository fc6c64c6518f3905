//! twinedge
#![cfg_attr(not(feature = "geometry"), no_std)]

extern crate alloc;

pub mod validate;

#[cfg(feature = "dcel")]
pub mod store;

#[cfg(feature = "dcel")]
pub mod dcel;

#[cfg(feature = "program")]
pub mod program;

#[cfg(feature = "geometry")]
pub mod geometry;
#[cfg(feature = "geometry")]
pub mod io;
