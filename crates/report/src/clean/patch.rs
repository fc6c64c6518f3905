//! A patch: the changes made by cleaning, and a way to undo them.

use crate::verdict::Judged;
use serde::{Deserialize, Serialize};
use twinedge_layers::clean::{CleanReport, FeatureChange};
use twinedge_layers::{
    Edit, Feature, Format, Geometry, Id, Layer, ReadError, ReadOptions, WriteError, edited, read_layer, write,
};

/// The changes from one file to another, as JSON. A patch belongs to these two files, byte for byte.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Patch {
    /// The version of the program that wrote it.
    pub twinedge: String,
    /// The bytes of the input; for a Shapefile, the bytes of the `.shp`.
    pub input: Judged,
    /// The bytes of the output.
    pub output: Judged,
    /// The changes, in order.
    pub changes: Changes,
}

/// Changes of a text, or of geometries.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Changes {
    /// Stretches of GeoJSON text. The text between them is equal in both files, so undoing restores the input byte for byte.
    Text(Vec<TextChange>),
    /// Geometries, if the formats differ or are not text.
    Geometries(Vec<GeometryChange>),
}

/// A stretch of a text.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TextChange {
    /// The number of the feature, counted from 0; `None` for a member of the whole file.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub feature: Option<usize>,
    /// Its id.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub id: Option<String>,
    /// The place in the output, in bytes.
    pub at: usize,
    /// The text in the input.
    pub before: String,
    /// The text in the output.
    pub after: String,
}

/// The geometry of a feature.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct GeometryChange {
    /// The number of the feature, counted from 0.
    pub feature: usize,
    /// Its id.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub id: Option<String>,
    /// True if the input does not have the feature.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub made: bool,
    /// The geometry in the input as well-known text; null for none.
    pub before: Option<String>,
    /// The geometry in the output.
    pub after: Option<String>,
}

/// The reason why a patch cannot be undone.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum PatchError {
    /// The file is not the patch's output.
    #[error("the patch belongs to a file of {} bytes with the SHA-256 {}, and this one has {} bytes and {}", .patch.bytes, .patch.sha256, .file.bytes, .file.sha256)]
    OtherFile {
        /// The output named by the patch.
        patch: Judged,
        /// The file.
        file: Judged,
    },
    /// The changes do not lead to the input, so the patch itself was edited.
    #[error("the patch does not lead back to the input that it names: it was changed")]
    OtherInput,
    /// The file has no such feature.
    #[error("the patch is about feature {0}, which the file does not have")]
    NoFeature(usize),
    /// A geometry is not well-known text.
    #[error("the geometry of feature {feature} in the patch: {error}")]
    Geometry {
        /// The feature.
        feature: usize,
        /// The reason.
        error: ReadError,
    },
    /// A geometry cannot be written as well-known text.
    #[error(transparent)]
    Write(#[from] WriteError),
}

impl Patch {
    /// Creates a patch from a text, the [changes](Edit) made to it, and the layer afterwards. Also returns the text afterwards. O(bytes).
    ///
    /// # Panics
    /// Panics if the changes do not belong to this text.
    #[must_use]
    pub fn of_text(before: &str, edits: &[Edit], after: &Layer) -> (Self, String) {
        let mut behind = 0;
        let mut from = 0;
        let mut changes = Vec::new();
        for Edit { feature, place, after: text } in edits {
            behind += place.start - from;
            changes.push(TextChange {
                feature: *feature,
                id: feature.and_then(|number| id(after, number)),
                at: behind,
                before: before[place.clone()].to_owned(),
                after: text.clone(),
            });
            behind += text.len();
            from = place.end;
        }
        let output = edited(before, edits);
        let [input, made] = [before, &output].map(|text| Judged::of_bytes(text.as_bytes()));
        (Self { twinedge: version(), input, output: made, changes: Changes::Text(changes) }, output)
    }

    /// Creates a patch from a cleaned layer and its report. O(positions of the changed features).
    ///
    /// # Errors
    /// [`PatchError::Write`].
    pub fn of_layers(after: &Layer, report: &CleanReport, [input, output]: [Judged; 2]) -> Result<Self, PatchError> {
        let change = |change: &FeatureChange| {
            let FeatureChange { feature, before, .. } = change;
            let geometry = after.features.get(*feature).and_then(|feature| feature.geometry.as_ref());
            Ok(GeometryChange {
                feature: *feature,
                id: id(after, *feature),
                made: report.made == Some(*feature),
                before: before.as_ref().map(text_of).transpose()?,
                after: geometry.map(text_of).transpose()?,
            })
        };
        let changes = report.features.iter().map(change).collect::<Result<_, PatchError>>()?;
        Ok(Self { twinedge: version(), input, output, changes: Changes::Geometries(changes) })
    }

    /// Refuses a file that is not the patch's output.
    ///
    /// # Errors
    /// [`PatchError::OtherFile`].
    pub fn refuse_other(&self, file: &Judged) -> Result<(), PatchError> {
        if *file == self.output {
            return Ok(());
        }
        Err(PatchError::OtherFile { patch: self.output.clone(), file: file.clone() })
    }

    /// Returns the input's text, from changes of a text and the output's text. O(bytes).
    ///
    /// # Errors
    /// [`PatchError::OtherFile`] and [`PatchError::OtherInput`].
    pub fn undo_text(&self, changes: &[TextChange], output: &str) -> Result<String, PatchError> {
        self.refuse_other(&Judged::of_bytes(output.as_bytes()))?;
        let mut input = String::new();
        let mut from = 0;
        for TextChange { at, before, after, .. } in changes {
            let kept = output.get(from..*at).filter(|_| output.get(*at..).is_some_and(|rest| rest.starts_with(after)));
            input.push_str(kept.ok_or(PatchError::OtherInput)?);
            input.push_str(before);
            from = at + after.len();
        }
        input.push_str(&output[from..]);
        if Judged::of_bytes(input.as_bytes()) == self.input { Ok(input) } else { Err(PatchError::OtherInput) }
    }

    /// Restores the geometries of the features in the output, and drops features that the input does not have. The layer must come from a file that
    /// [was not refused](Self::refuse_other). O(positions of these features).
    ///
    /// # Errors
    /// [`PatchError::NoFeature`] and [`PatchError::Geometry`].
    pub fn undo_layer(changes: &[GeometryChange], layer: &mut Layer) -> Result<(), PatchError> {
        let mut made = Vec::new();
        for GeometryChange { feature: number, made: is_made, before, .. } in changes {
            let feature = layer.features.get_mut(*number).ok_or(PatchError::NoFeature(*number))?;
            let read = |text: &String| geometry(text).map_err(|error| PatchError::Geometry { feature: *number, error });
            feature.geometry = before.as_ref().map(read).transpose()?.flatten();
            made.extend(is_made.then_some(*number));
        }
        let mut number = 0;
        layer.features.retain(|_| {
            number += 1;
            !made.contains(&(number - 1))
        });
        Ok(())
    }
}

fn version() -> String {
    env!("CARGO_PKG_VERSION").to_owned()
}

fn id(layer: &Layer, feature: usize) -> Option<String> {
    layer.features.get(feature)?.id.as_ref().map(Id::to_string)
}

fn text_of(geometry: &Geometry) -> Result<String, WriteError> {
    let feature = Feature { geometry: Some(geometry.clone()), ..Feature::default() };
    let mut text = Vec::new();
    write(&Layer { features: vec![feature], ..Layer::default() }, &mut text, Format::Wkt)?;
    Ok(String::from_utf8_lossy(&text).trim_end().to_owned())
}

fn geometry(text: &str) -> Result<Option<Geometry>, ReadError> {
    let options = ReadOptions { format: Some(Format::Wkt), ..ReadOptions::default() };
    let layer = read_layer(&mut text.as_bytes(), None, &options)?;
    Ok(layer.features.into_iter().next().and_then(|feature| feature.geometry))
}
