//! Pointer-style: boxed records joined by raw pointers, as the literature draws them.
//!
//! ```text
//!   keys                    columns of pointers    records, each in a box of its own
//!   half-edge slotmap  [h][t]…   [•][•]…  ───────►  ┌─────────┐ twin  ┌─────────┐
//!   vertex slotmap     [v]…      [•]…               │ key     │◄─────►│ key     │
//!   …                                               │ origin •│─► v   │ origin •│─► w
//!                                                   │ next   •│─►     │ next   •│─►
//!                                                   │ prev   •│─►     │ prev   •│─►
//!                                                   └─────────┘       └─────────┘
//! ```
//!
//! A slot is a pointer to its record, and a step is a bare dereference.

mod records;
mod store;

pub use store::PointerStore;
