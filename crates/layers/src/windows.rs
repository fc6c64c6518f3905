//! Files whose features in a window are found by boxes.

use super::each::EachGeometry;
use super::error::ReadError;
use super::extent::Extent;
use super::model::Header;

/// A file whose features in a window are found by their boxes.
pub(super) trait Windows {
    /// The box around all features, as the file states it.
    fn extent(&self) -> Extent;
    fn header(&self) -> Result<Header, ReadError>;
    fn has_only_points(&self) -> Result<bool, ReadError>;
    /// The number of features whose boxes are examined one by one to read a window.
    fn passed(&self, window: &Extent) -> u64;
    fn read(
        &mut self,
        window: &Extent,
        is_wanted: &mut dyn FnMut(u64) -> bool,
        each: &mut EachGeometry<'_>,
    ) -> Result<(), ReadError>;
    /// The number of features.
    fn count(&self) -> u64;
    /// The number of bytes read, and of all.
    fn bytes(&self) -> [u64; 2];
}
