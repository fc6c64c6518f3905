//! Reading the features in a window, by the boxes stored in a file.

use super::each::EachGeometry;
use super::error::ReadError;
use super::extent::Extent;
use super::model::Header;
use super::read::{ReadOptions, beginning, format_of};
use super::windows::Windows;
use std::fs::File;
use std::path::Path;
use twinedge_geometry::Point;

/// A file with boxes that locate its features, so that the features in a window are read without the others: `FlatGeobuf` with an
/// index, and `GeoParquet` with statistics of its column of boxes or of Parquet's own geometries.
///
/// Boxes are not trusted: geometries are compared with the boxes around them. A window cannot reveal features hidden by incorrect
/// boxes; but the boxes place each feature somewhere, and reading that place is an error. So if windows that together cover the
/// plane are read without an error, none of them missed anything.
///
/// ```
/// use twinedge_geometry::Point;
/// use twinedge_layers::{
///     Dimensions, Feature, Format, Geometry, Indexed, Layer, Position, ReadOptions, Shape, write_path,
/// };
///
/// # #[cfg(feature = "geoparquet")] {
/// # let folder = tempfile::tempdir()?;
/// # let path = folder.path().join("trees.parquet");
/// let tree = |x| Feature {
///     geometry: Some(Geometry::new(Dimensions::Xy, Shape::Point(Some(Position::new(x, 0.0))))),
///     ..Feature::default()
/// };
/// write_path(&Layer { features: vec![tree(1.0), tree(5.0)], ..Layer::default() }, &path, Format::GeoParquet)?;
/// let mut file = Indexed::open(&path, &ReadOptions::default())?.unwrap();
/// assert_eq!(file.corners(), Some([Point::new(1.0, 0.0), Point::new(5.0, 0.0)]));
/// let mut found = Vec::new();
/// file.read([Point::new(4.0, -1.0), Point::new(6.0, 1.0)], &mut |_| true, &mut |number, _| found.push(number))?;
/// assert_eq!(found, [1]);
/// # }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Indexed {
    file: Box<dyn Windows + Send>,
    features: u64,
}

/// The numbers of features and bytes of a file, as read and in total.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Amount {
    /// The number of features read. Repeated reads count repeatedly.
    pub features: u64,
    /// The number of features in the file.
    pub of_features: u64,
    /// The number of bytes read, counting repetitions; for `GeoParquet`, only bytes of columns.
    pub bytes: u64,
    /// The number of bytes of the file.
    pub of_bytes: u64,
}

impl Indexed {
    /// Opens a file; `None` if it has no boxes for reading windows. O(row groups).
    ///
    /// # Errors
    /// [`ReadError`].
    pub fn open(path: &Path, options: &ReadOptions) -> Result<Option<Self>, ReadError> {
        if options.files.is_some() {
            return Ok(None);
        }
        let head = beginning(&mut File::open(path)?)?;
        let file: Option<Box<dyn Windows + Send>> = match format_of(&head, Some(path), options) {
            #[cfg(feature = "flatgeobuf")]
            Ok(crate::io::Format::FlatGeobuf) => {
                super::flatgeobuf::IndexedFile::open(path)?.map(|file| Box::new(file) as _)
            }
            #[cfg(feature = "geoparquet")]
            Ok(crate::io::Format::GeoParquet) => {
                super::geoparquet::IndexedFile::open(path)?.map(|file| Box::new(file) as _)
            }
            // Faults of other files are found when they are read as a whole.
            _ => None,
        };
        Ok(file.map(|file| Self { file, features: 0 }))
    }

    /// Returns the corners of the box around all features, as stated by the file; `None` if not stated, or without features.
    #[must_use]
    pub fn corners(&self) -> Option<[Point; 2]> {
        let Extent { low, high } = Some(self.file.extent()).filter(Extent::is_known)?;
        Some([low, high])
    }

    /// Returns everything in the file except features and columns. O(1).
    ///
    /// # Errors
    /// [`ReadError`].
    pub fn header(&self) -> Result<Header, ReadError> {
        self.file.header()
    }

    /// Returns true if the file declares that all geometries are points.
    ///
    /// # Errors
    /// [`ReadError`].
    pub fn has_only_points(&self) -> Result<bool, ReadError> {
        self.file.has_only_points()
    }

    /// Returns the number of features whose boxes are examined one by one to [read](Self::read) a window: for `GeoParquet` all
    /// features of the row groups that meet it; for `FlatGeobuf` none, as its index locates each feature. O(row groups).
    #[must_use]
    pub fn passed(&self, [low, high]: [Point; 2]) -> u64 {
        self.file.passed(&Extent { low, high })
    }

    /// Passes on the geometries of all wanted features that may meet the closed box between two corners, with their numbers in
    /// the file, in order. Attributes are not read. Memory O(largest feature), or O(pages of a row group).
    ///
    /// # Errors
    /// [`ReadError`], with [`Cause::OutOfBox`](super::Cause::OutOfBox) if something is outside its box.
    pub fn read(
        &mut self,
        [low, high]: [Point; 2],
        is_wanted: &mut dyn FnMut(u64) -> bool,
        each: &mut EachGeometry<'_>,
    ) -> Result<(), ReadError> {
        let window = Extent { low, high };
        let count = &mut self.features;
        let mut counted = |number, geometry| {
            *count += 1;
            each(number, geometry);
        };
        self.file.read(&window, is_wanted, &mut counted)
    }

    /// Returns the numbers of features and bytes read so far.
    #[must_use]
    pub fn amount(&self) -> Amount {
        let (of_features, [bytes, of_bytes]) = (self.file.count(), self.file.bytes());
        Amount { features: self.features, of_features, bytes, of_bytes }
    }
}
