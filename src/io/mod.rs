//! Reading and writing maps.
