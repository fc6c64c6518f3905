//! Writing an audit in the requested format.

use super::destination::{Destination, ReportFormat};
use crate::output::style::BAD;
use crate::output::{plain, print};
use crate::status::Failure;
use twinedge_report::Audited;

/// Writes an audit. Where a layer or a page goes to a file, a line for people says so.
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
