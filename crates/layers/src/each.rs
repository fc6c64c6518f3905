//! Callbacks of readers.

use super::error::ReadError;
use super::model::{Feature, Geometry};

/// Takes the features of a layer one by one, and can stop reading with an error.
pub type Each<'a> = dyn FnMut(Feature) -> Result<(), ReadError> + 'a;

/// Takes the geometries of features in a window, each with the number of its feature.
pub type EachGeometry<'a> = dyn FnMut(u64, Option<Geometry>) + 'a;
