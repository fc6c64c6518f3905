//! Notes on the input of a map.

use crate::imported::Imported;
use crate::report::Note;
use crate::words::noding_line;
use crate::words::{counted, grouped, plain};
use std::collections::BTreeSet;
use std::fmt::Write as _;
use twinedge_layers::io::ReadSummary;
use twinedge_map::{BuildSummary, Irregularity, IrregularityKind};

/// Returns all notes, in reading order.
pub(crate) fn notes(imported: &Imported, warnings: Vec<String>) -> Vec<Note> {
    let Imported { read, map, noted, .. } = imported;
    let mut notes = vec![Note::Plain(input_line(&imported.summary, imported.orients_rings))];
    notes.extend(dropped_line(read).map(Note::Plain));
    notes.extend(map.noding().map(noding_line).map(Note::Plain));
    notes.extend(warnings.into_iter().map(Note::Warning));
    notes.extend(noted.hint().map(Note::Plain));
    notes.extend(irregularities(imported).into_iter().map(Note::Detail));
    notes
}

/// The parts that the reader dropped, except properties, which every file has.
fn dropped_line(read: &ReadSummary) -> Option<String> {
    let mut dropped = Vec::new();
    if read.with_extra_dimensions > 0 {
        dropped.push(format!("the dimensions beyond x and y of {}", counted(read.with_extra_dimensions, "position")));
    }
    if read.dropped_empty > 0 {
        dropped.push(counted(read.dropped_empty, "empty shape"));
    }
    (!dropped.is_empty()).then(|| format!("dropped: {}", dropped.join(", ")))
}

fn input_line(summary: &BuildSummary, orients_rings: bool) -> String {
    let (features, segments) = (summary.features, summary.segments);
    let mut line = format!("{}, {}", counted(features, "feature"), counted(segments, "segment"));
    for (count, what) in [
        (summary.duplicate_segments, "repeated and merged"),
        (summary.zero_length_segments, "of zero length and dropped"),
        (summary.open_rings, "added to close open rings"),
    ] {
        if count > 0 {
            let _ = write!(line, ", {} {what}", grouped(count));
        }
    }
    let mut mark = ';';
    for (count, one, several) in [
        (summary.degenerate_rings, "ring encloses nothing", "rings enclose nothing"),
        (
            if orients_rings { summary.rings_wound_wrongly } else { 0 },
            "ring is wound the wrong way",
            "rings are wound the wrong way",
        ),
        (summary.self_touching_rings, "ring touches itself", "rings touch themselves"),
        (summary.spikes, "spike", "spikes"),
    ] {
        if count > 0 {
            let what = if count == 1 { one } else { several };
            let _ = write!(line, "{mark} {} {what}", grouped(count));
            mark = ',';
        }
    }
    line
}

/// The number of irregularities of each kind shown in text. Rings of the wrong orientation are not shown: usually all or none have it.
const SHOWN: usize = 3;

fn irregularities(Imported { map, summary, .. }: &Imported) -> Vec<String> {
    let found = &summary.irregularities;
    let kinds: BTreeSet<_> =
        found.iter().map(|one| one.kind).filter(|kind| *kind != IrregularityKind::WoundWrongly).collect();
    let of_kind = |kind| found.iter().filter(move |one| one.kind == kind).take(SHOWN);
    let line = |one: &Irregularity| {
        let Irregularity { kind, at, position, .. } = one;
        let name = map.features().nth(position.feature).and_then(|feature| map.name(feature));
        let name = name.map_or_else(String::new, |name| format!(" ({})", plain(name)));
        format!("  {kind} at ({}, {}): {position}{name}", at.x, at.y)
    };
    kinds.into_iter().flat_map(of_kind).map(line).collect()
}
