//! The output of `clean`, its patch, and undoing a patch.

use crate::convert::LayerOutput;
use crate::input::LayerFile;
use crate::output::{Failure, Verdict, json, named, plain, print};
use crate::output_file::write_file;
use same_file::is_same_file;
use std::fs::File;
use std::io::BufReader;
use std::path::Path;
use twinedge_layers::clean::CleanReport;
use twinedge_layers::{Edit, Format, Layer, edits, write};
use twinedge_report::Judged;
use twinedge_report::clean::{Changes, Patch, Written};

pub(super) struct Cleaned<'a> {
    pub(super) count: usize,
    /// The text of the input, if it is GeoJSON.
    pub(super) text: Option<(String, Format)>,
    pub(super) after: &'a Layer,
    pub(super) report: &'a CleanReport,
}

impl Cleaned<'_> {
    pub(super) fn write(
        &self,
        input: &LayerFile,
        output: &LayerOutput,
        patch: Option<&Path>,
    ) -> Result<Option<Written>, Failure> {
        if let Some(path) = patch {
            refuse_same(path, output.path())?;
            refuse_same(path, input.path())?;
        }
        let (made, written) = match self.text.as_ref().filter(|(_, format)| output.format() == Some(*format)) {
            Some((text, format)) => {
                let (made, after) = Patch::of_text(text, &self.edits(text, *format)?, self.after);
                (Some(made), output.write_text(&after, *format, input.path())?)
            }
            None => (None, output.write(self.after, input.path())?),
        };
        if let Some(path) = patch {
            let made = made.map_or_else(|| self.of_layers(input, output), Ok)?;
            write_file(path, input.path(), &json(&made)?)?;
        }
        Ok(written)
    }

    /// Returns the changes of the text; if it has no room for one of them, the whole text is replaced.
    fn edits(&self, text: &str, format: Format) -> Result<Vec<Edit>, Failure> {
        let changed: Vec<usize> = self.report.features.iter().map(|change| change.feature).collect();
        if changed.is_empty() {
            return Ok(Vec::new());
        }
        if let Some(edits) = edits(text, format, self.count, self.after, &changed) {
            return Ok(edits);
        }
        let mut after = Vec::new();
        write(self.after, &mut after, format)?;
        Ok(vec![Edit { feature: None, place: 0..text.len(), after: String::from_utf8(after)? }])
    }

    fn of_layers(&self, input: &LayerFile, output: &LayerOutput) -> Result<Patch, Failure> {
        let judged = |path: Option<&Path>| match path {
            Some(path) => Ok(Judged::of(BufReader::new(File::open(path)?))?),
            None => Err(Failure("--patch: only GeoJSON has a patch by way of standard input and output".to_owned())),
        };
        let files = [judged(input.path())?, judged(output.main_file().as_deref())?];
        Ok(Patch::of_layers(self.after, self.report, files)?)
    }
}

fn refuse_same(patch: &Path, other: Option<&Path>) -> Result<(), Failure> {
    match other.filter(|other| patch == *other || is_same_file(patch, other).unwrap_or(false)) {
        Some(_) => Err(Failure(format!("{}: this is another file of the same command", patch.display()))),
        None => Ok(()),
    }
}

/// Writes the input of a cleaned file, by the patch written with that file.
pub(super) fn undo(patch: &Path, input: &LayerFile, output: &LayerOutput) -> Result<Verdict, Failure> {
    let name = patch.display().to_string();
    let failed = named(&name);
    let document = BufReader::new(File::open(patch).map_err(|error| failed(error.to_string()))?);
    let read: Patch = serde_json::from_reader(document).map_err(|error| failed(error.to_string()))?;
    if let Some(path) = output.path() {
        refuse_same(patch, Some(path))?;
    }
    let bytes = input.bytes()?;
    let refused = |error: twinedge_report::clean::PatchError| failed(error.to_string());
    let (written, count) = match &read.changes {
        Changes::Text(changes) => {
            read.refuse_other(&Judged::of_bytes(&bytes)).map_err(refused)?;
            let text = read.undo_text(changes, &String::from_utf8(bytes)?).map_err(refused)?;
            (output.write_text(&text, output.format().unwrap_or(Format::GeoJson), input.path())?, changes.len())
        }
        Changes::Geometries(changes) => {
            read.refuse_other(&Judged::of_bytes(&bytes)).map_err(refused)?;
            let (_, mut layer) = input.read()?;
            Patch::undo_layer(changes, &mut layer).map_err(refused)?;
            (output.write(&layer, input.path())?, changes.len())
        }
    };
    if let Some(Written { name, .. }) = written.filter(|_| !output.is_stdout()) {
        let changes = if count == 1 { "1 change".to_owned() } else { format!("{count} changes") };
        print(&format!("{changes} taken back: written to {}\n", plain(&name)))?;
    }
    Ok(Verdict::Sound)
}
