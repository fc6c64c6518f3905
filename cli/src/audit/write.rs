//! Writing a report in one of the formats with a map.

use super::destination::{Destination, ReportFormat};
use super::document::Document;
use super::packed::Map;
use super::{findings_geojson, page};
use crate::output::{counted, plain, print};
use crate::status::Failure;

/// Writes a report. `map` packs what the page shows. Where it goes to a file, a line for people says so.
pub(super) fn write(document: &Document, to: &Destination<'_>, map: impl FnOnce() -> Map) -> Result<(), Failure> {
    match to.format {
        ReportFormat::Html => to.bytes(page::page(document, &map())?.as_bytes())?,
        _ => to.bytes(&findings_geojson::layer(document)?)?,
    }
    let Some(file) = to.file() else { return Ok(()) };
    let listed = match (document.findings.len(), document.total) {
        (listed, total) if listed as u64 == total => counted(listed, "finding"),
        (listed, total) => format!("{listed} of {}", counted(total as usize, "finding")),
    };
    let [input, verdict, file] =
        [&document.input, &document.verdict, &file.display().to_string()].map(|text| plain(text));
    print(&format!("{input}: {verdict}; {listed} written to {file}\n"))
}
