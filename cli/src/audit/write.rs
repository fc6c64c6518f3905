//! Writing an audit in the format that was asked for.

use super::arguments::Run;
use super::destination::ReportFormat;
use super::packed::Picture;
use super::report::AuditReport;
use super::text::text;
use super::{findings_geojson, page};
use crate::output::{counted, plain, print};
use crate::status::{Failure, Verdict};

/// Writes an audit. `picture` makes what a page shows. Where a layer or a page goes to a file, a line for people says so.
pub(super) fn write(
    mut report: AuditReport,
    run: &Run<'_>,
    picture: impl FnOnce(&AuditReport) -> Picture,
) -> Result<Verdict, Failure> {
    let Run { asked, to, .. } = run;
    report.elapsed_ms = run.elapsed_ms();
    let report = if asked.explain { report } else { report.unexplained() };
    match to.format {
        ReportFormat::Text => to.text(&text(&report)?)?,
        ReportFormat::Json => to.json(&report.json())?,
        ReportFormat::Geojson => to.bytes(&findings_geojson::layer(&report)?)?,
        ReportFormat::Html => to.bytes(page::page(&report, &picture(&report))?.as_bytes())?,
    }
    if let (ReportFormat::Geojson | ReportFormat::Html, Some(file)) = (to.format, to.file()) {
        let listed = match (report.listed().count(), report.total()) {
            (listed, total) if listed as u64 == total => counted(listed, "finding"),
            (listed, total) => format!("{listed} of {}", counted(total as usize, "finding")),
        };
        let [input, verdict, file] =
            [&report.input, &report.verdict(), &file.display().to_string()].map(|text| plain(text));
        print(&format!("{input}: {verdict}; {listed} written to {file}\n"))?;
    }
    Ok(if report.valid { Verdict::Sound } else { Verdict::Wrong })
}
