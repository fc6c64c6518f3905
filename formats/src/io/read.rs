//! Reading a map in any text format.

use super::error::{ReadCause, ReadError, TextPlace};
use super::foreign::ForeignFormat;
use super::format::Format;
use super::properties::Properties;
use super::summary::ReadSummary;
use std::io::{Cursor, Read};
use twinedge_map::Feature;

const HEAD: u64 = 1 << 16;

/// Reads a map, passing its features to `each` in the order of the file.
///
/// Without a given format, the content decides ([`Format::of_content`]). Content of a known but unsupported format is an error
/// that names the format and explains how to convert it, even if a format is given.
///
/// The reader is buffered inside. Faults may appear only after some features have been passed on; `each` can stop reading with
/// its own error, which is returned. Time O(bytes); memory O(largest feature), for well-known text O(longest line), plus 64 KiB.
///
/// ```
/// use twinedge_formats::io;
/// use twinedge_formats::io::Format;
/// use twinedge_map::Builder;
///
/// let text = "# two parcels\nPOLYGON((0 0, 1 0, 1 1, 0 0))\nPOLYGON((0 0, 1 1, 0 1, 0 0))\n";
/// let mut builder = Builder::new();
/// let summary = io::read(text.as_bytes(), Format::of_path("parcels.wkt"), |feature| {
///     builder.feature(&feature).map(drop).map_err(Box::<dyn std::error::Error>::from)
/// })?;
/// assert_eq!((summary.features, summary.polygons), (2, 2));
/// assert_eq!(builder.build()?.dcel().face_count(), 3);
/// # Ok::<_, Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`ReadError`], converted to `E`, and the errors of `each`.
pub fn read<R, E>(
    reader: R,
    format: Option<Format>,
    mut each: impl FnMut(Feature) -> Result<(), E>,
) -> Result<ReadSummary, E>
where
    R: Read,
    E: From<ReadError>,
{
    read_with_properties(reader, format, |feature, _| each(feature))
}

/// Reads a map like [`read`], and passes on the properties of each feature. [`Properties`] has an example.
///
/// # Errors
/// As for [`read`].
pub fn read_with_properties<R, E>(
    mut reader: R,
    format: Option<Format>,
    each: impl FnMut(Feature, &Properties) -> Result<(), E>,
) -> Result<ReadSummary, E>
where
    R: Read,
    E: From<ReadError>,
{
    let mut head = Vec::new();
    if let Err(error) = reader.by_ref().take(HEAD).read_to_end(&mut head) {
        return Err(ReadError::new(TextPlace::START.after(&head), ReadCause::Io(error)).into());
    }
    let refuse = |cause| Err(ReadError::new(TextPlace::START, cause).into());
    if let Some(foreign) = ForeignFormat::of_content(&head) {
        return refuse(ReadCause::Foreign(foreign));
    }
    let is_blank = head.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(&head).trim_ascii().is_empty();
    let of_content = Format::of_content(&head);
    if let Some(certain) = of_content.filter(|format| format.is_certain()) {
        return refuse(ReadCause::Elsewhere(certain));
    }
    let Some(format) = Format::of_file(of_content, format) else {
        return refuse(if is_blank { ReadCause::Empty } else { ReadCause::Unrecognised });
    };
    let all = Cursor::new(head).chain(reader);
    match format {
        Format::GeoJson => super::geojson::read_with_properties(all, each),
        Format::GeoJsonSeq => super::geojson::read_sequence_with_properties(all, each),
        #[cfg(feature = "wkt")]
        Format::Wkt => {
            let mut each = each;
            super::wkt::read(all, |feature| each(feature, &Properties::default()))
        }
        #[cfg(not(feature = "wkt"))]
        Format::Wkt => refuse(ReadCause::FeatureOff(format)),
        elsewhere => refuse(ReadCause::Elsewhere(elsewhere)),
    }
}
