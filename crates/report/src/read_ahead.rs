//! Reading ahead of the consumer of features, on platforms with threads.

#[cfg(not(target_family = "wasm"))]
mod threads;

#[cfg(not(target_family = "wasm"))]
pub(crate) use threads::read_ahead;
use twinedge_layers::ReadError;
use twinedge_map::Feature;

/// Takes a feature or refuses it. What remains in the value is dropped.
pub(crate) type Take<'a> = dyn FnMut(&mut Feature) -> Result<(), ReadError> + Send + 'a;

/// Hands a feature on, unless an earlier one was refused.
pub(crate) type HandOn<'a> = dyn FnMut(Feature) -> Result<(), ReadError> + Send + 'a;

/// Reads features, and hands each to `take`, in order.
#[cfg(target_family = "wasm")]
pub(crate) fn read_ahead<R>(
    take: &mut Take<'_>,
    read: impl FnOnce(&mut HandOn<'_>) -> Result<R, ReadError>,
) -> Result<R, ReadError> {
    read(&mut |mut feature| take(&mut feature))
}
