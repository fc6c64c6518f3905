//! A GeoJSON file on disk whose features are read on demand and replaced.

use super::clean::{Bounds, CleanError, Extent, Source};
use super::error::ReadError;
use super::geojson;
use super::geojson_edit::{edited_feature, is_box};
use super::geojson_places::{Places, places};
use super::model::{Feature, Header, Layer};
use super::read::{ReadOptions, beginning, format_of};
use crate::io::Format;
use crate::io::geojson::Documents;
use std::collections::BTreeMap;
use std::fs::File;
use std::io::{self, BufReader, Read, Seek, SeekFrom, Write};
use std::ops::Range;
use std::path::Path;

/// A file of GeoJSON or newline-delimited GeoJSON whose features are read on demand. Replacements are kept in another file.
///
/// The written text equals the file byte by byte, except for changed geometries, the boxes of their features, and the box of the
/// collection, if there is one. Memory is 64 bytes for each feature, plus the current feature.
///
/// ```
/// use std::io::Write;
/// use twinedge_layers::GeoJsonFile;
/// use twinedge_layers::clean::Source;
///
/// let mut file = tempfile::NamedTempFile::new()?;
/// let line = |x| format!("{{\"type\": \"Feature\",  \"geometry\": {{\"type\":\"Point\",\"coordinates\":[{x},0.0]}}, \"properties\": {{}}}}\n");
/// write!(file, "{}{}", line(1), line(2))?;
/// let mut layer = GeoJsonFile::open(file.path(), tempfile::tempfile()?, &mut |_| Ok(()))?;
/// let mut feature = layer.read(1)?;
/// feature.geometry = None;
/// layer.replace(1, Some(&feature))?;
/// let mut written = Vec::new();
/// layer.write(&mut written)?;
/// assert_eq!(String::from_utf8(written)?, format!("{}{}", line(1), "{\"type\": \"Feature\",  \"geometry\": null, \"properties\": {}}\n"));
/// # Ok::<_, Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct GeoJsonFile {
    file: File,
    format: Format,
    header: Header,
    places: Places,
    extents: Vec<Extent>,
    /// The texts of replaced features, and the range of the current text of each, by number.
    replaced: File,
    end: u64,
    in_force: BTreeMap<usize, Range<u64>>,
    /// The ranges of texts that count as the original ones.
    settled: BTreeMap<usize, Range<u64>>,
}

/// A range of the file, and its replacement.
type Replacement = (Range<u64>, Vec<u8>);

/// The reason why a file of GeoJSON could not be cleaned by its neighbourhoods.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum FileError {
    /// The file could not be read or written.
    #[error(transparent)]
    Io(#[from] io::Error),
    /// The file is not GeoJSON.
    #[error(transparent)]
    Read(#[from] ReadError),
    /// The file is in another format.
    #[error(
        "this is {0}, and only files of GeoJSON and newline-delimited GeoJSON are read feature by feature, and written so"
    )]
    Format(Format),
    /// A feature is not where it was: the file has changed, or the name of its member `features` is written with escapes.
    #[error("feature {0} is not found where it should be: did the file change?")]
    Moved(usize),
    /// The layer could not be cleaned.
    #[error(transparent)]
    Clean(#[from] CleanError),
}

impl GeoJsonFile {
    /// Opens a file and reads it twice, once to pass on features. `scratch` is an empty file to read and write. O(bytes).
    ///
    /// # Errors
    /// [`FileError`], and the errors of `each`.
    pub fn open(
        path: &Path,
        scratch: File,
        each: &mut dyn FnMut(Feature) -> Result<(), ReadError>,
    ) -> Result<Self, FileError> {
        let mut file = File::open(path)?;
        let head = beginning(&mut file)?;
        let format = format_of(&head, Some(path), &ReadOptions::default())?;
        let documents = match format {
            Format::GeoJson => Documents::One,
            Format::GeoJsonSeq => Documents::Many,
            other => return Err(FileError::Format(other)),
        };
        let mut extents = Vec::new();
        file.rewind()?;
        let header = geojson::read(&mut BufReader::new(&file), documents, &mut |feature| {
            extents.push(Extent::of(&feature));
            each(feature)
        })?;
        file.rewind()?;
        let places = places(BufReader::with_capacity(1 << 16, &file))?;
        if places.features.len() != extents.len() {
            return Err(FileError::Moved(places.features.len().min(extents.len())));
        }
        Ok(Self {
            file,
            format,
            header,
            places,
            extents,
            replaced: scratch,
            end: 0,
            in_force: BTreeMap::new(),
            settled: BTreeMap::new(),
        })
    }

    /// Returns the format.
    #[must_use]
    pub const fn format(&self) -> Format {
        self.format
    }

    /// Returns all members except the features.
    #[must_use]
    pub const fn header(&self) -> &Header {
        &self.header
    }

    /// Passes on all features in their current state, in order. O(bytes).
    ///
    /// # Errors
    /// [`FileError`], and the errors of `each`.
    pub fn each<E: From<FileError>>(&mut self, mut each: impl FnMut(Feature) -> Result<(), E>) -> Result<(), E> {
        for number in 0..self.extents.len() {
            each(self.now(number)?)?;
        }
        Ok(())
    }

    /// Writes the text with the current features. O(bytes).
    ///
    /// # Errors
    /// [`FileError`]; a part may have been written.
    pub fn write(&mut self, out: &mut dyn Write) -> Result<(), FileError> {
        let mut of_box = self.edit_of_box()?;
        let numbers: Vec<usize> = self.in_force.keys().copied().collect();
        let mut from = 0;
        let mut put = |this: &mut Self, place: Range<u64>, text: &[u8], out: &mut dyn Write| {
            this.copy(from..place.start, out)?;
            out.write_all(text)?;
            from = place.end;
            Ok::<_, FileError>(())
        };
        for number in numbers {
            let place = self.places.features[number].clone();
            if let Some((before, text)) = of_box.take_if(|(before, _)| before.start < place.start) {
                put(self, before, &text, out)?;
            }
            let text = self.text_now(number)?;
            put(self, place, text.as_bytes(), out)?;
        }
        if let Some((place, text)) = of_box {
            put(self, place, &text, out)?;
        }
        let end = self.file.metadata()?.len();
        self.copy(from..end, out)
    }

    /// Returns the replacement of the box of the collection, if it changes.
    fn edit_of_box(&mut self) -> Result<Option<Replacement>, FileError> {
        let place = self.places.bbox.clone().filter(|_| self.format == Format::GeoJson && !self.in_force.is_empty());
        let Some(place) = place else { return Ok(None) };
        let mut bounds = Bounds::default();
        self.each(|feature| {
            feature.geometry.iter().for_each(|geometry| bounds.take(geometry));
            Ok::<_, FileError>(())
        })?;
        let before = text(&mut self.file, &place)?;
        let now = bounds.json().filter(|now| !is_box(&before, now));
        Ok(now.map(|now| (place, now.to_string().into_bytes())))
    }

    fn copy(&mut self, place: Range<u64>, out: &mut dyn Write) -> Result<(), FileError> {
        self.file.seek(SeekFrom::Start(place.start))?;
        let length = place.end.saturating_sub(place.start);
        if io::copy(&mut (&self.file).take(length), out)? < length {
            return Err(io::Error::from(io::ErrorKind::UnexpectedEof).into());
        }
        Ok(())
    }

    /// Makes the current features the original ones. O(bytes of the replaced features).
    ///
    /// # Errors
    /// [`FileError`].
    pub fn settle(&mut self) -> Result<(), FileError> {
        self.settled = self.in_force.clone();
        let numbers: Vec<usize> = self.settled.keys().copied().collect();
        for number in numbers {
            self.extents[number] = Extent::of(&self.now(number)?);
        }
        Ok(())
    }

    fn text_before(&mut self, number: usize) -> Result<String, FileError> {
        if let Some(place) = self.settled.get(&number) {
            return text(&mut self.replaced, place);
        }
        let place = self.places.features.get(number).ok_or(FileError::Moved(number))?;
        text(&mut self.file, place)
    }

    fn text_now(&mut self, number: usize) -> Result<String, FileError> {
        match self.in_force.get(&number) {
            Some(place) => text(&mut self.replaced, place),
            None => self.text_before(number),
        }
    }

    fn now(&mut self, number: usize) -> Result<Feature, FileError> {
        let text = self.text_now(number)?;
        one(&text).ok_or(FileError::Moved(number))
    }
}

impl Source for GeoJsonFile {
    type Error = FileError;

    fn extents(&self) -> &[Extent] {
        &self.extents
    }

    fn read(&mut self, number: usize) -> Result<Feature, FileError> {
        let feature = one(&self.text_before(number)?);
        // The file may have changed since it was read as a whole.
        feature.filter(|feature| Extent::of(feature) == self.extents[number]).ok_or(FileError::Moved(number))
    }

    fn replace(&mut self, number: usize, feature: Option<&Feature>) -> Result<(), FileError> {
        let Some(feature) = feature else {
            match self.settled.get(&number) {
                Some(place) => drop(self.in_force.insert(number, place.clone())),
                None => drop(self.in_force.remove(&number)),
            }
            return Ok(());
        };
        let layer = Layer { features: vec![feature.clone()], ..Layer::default() };
        let text = edited_feature(&self.text_before(number)?, &layer).ok_or(FileError::Moved(number))?;
        self.replaced.seek(SeekFrom::Start(self.end))?;
        self.replaced.write_all(text.as_bytes())?;
        let start = self.end;
        self.end += text.len() as u64;
        self.in_force.insert(number, start..self.end);
        Ok(())
    }
}

fn text(file: &mut File, place: &Range<u64>) -> Result<String, FileError> {
    let length = usize::try_from(place.end - place.start).map_err(io::Error::other)?;
    let mut bytes = vec![0; length];
    file.seek(SeekFrom::Start(place.start))?;
    file.read_exact(&mut bytes)?;
    Ok(String::from_utf8(bytes).map_err(io::Error::other)?)
}

fn one(text: &str) -> Option<Feature> {
    let mut found = Vec::new();
    let read = geojson::read(&mut text.as_bytes(), Documents::One, &mut |feature| {
        found.push(feature);
        Ok(())
    });
    read.ok()?;
    if found.len() == 1 { found.pop() } else { None }
}
