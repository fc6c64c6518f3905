//! Writing an audit in the requested format.

use super::destination::{Destination, ReportFormat};
use crate::output::plain;
use crate::output::print;
use crate::output::style::BAD;
use crate::status::Failure;
use twinedge_report::Audited;

/// Writes the measures of ISO 19157, in the form named by the output's extension.
pub(super) fn write_iso(audited: &Audited, to: &Destination<'_>) -> Result<(), Failure> {
    match to.format {
        ReportFormat::Json => to.bytes(&audited.iso_json()?),
        // Standard output has no extension.
        ReportFormat::Junit | ReportFormat::Text => to.bytes(audited.iso_xml()?.as_bytes()),
        _ => Err(Failure("the measures of ISO 19157 are written as .xml or .json".to_owned())),
    }
}

/// Writes an audit. If a layer or a page goes to a file, also prints a line about it.
pub(super) fn write(audited: &Audited, to: &Destination<'_>) -> Result<(), Failure> {
    match to.format {
        ReportFormat::Text => to.text(&audited.text()?)?,
        ReportFormat::Json => to.bytes(&audited.json()?)?,
        ReportFormat::Geojson => {
            let (layer, warnings) = audited.findings()?;
            for warning in warnings {
                anstream::eprintln!("{BAD}warning{BAD:#}: {warning}");
            }
            to.bytes(&layer)?;
        }
        ReportFormat::Sarif => to.bytes(&audited.sarif()?)?,
        ReportFormat::Junit => to.bytes(audited.junit()?.as_bytes())?,
        ReportFormat::Html => to.bytes(audited.page()?.as_bytes())?,
    }
    if let (ReportFormat::Geojson | ReportFormat::Html, Some(file)) = (to.format, to.file()) {
        print(&format!("{} written to {}\n", audited.summary()?, plain(&file.display().to_string())))?;
    }
    Ok(())
}
