//! The taker of the features that a reader hands over.

use super::error::ReadError;
use super::model::Feature;

/// Takes the features of a layer, one by one, and ends the reading by an error.
pub type Each<'a> = dyn FnMut(Feature) -> Result<(), ReadError> + 'a;
