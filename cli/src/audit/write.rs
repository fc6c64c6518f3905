//! Writing an audit in the format that was asked for.

use super::arguments::Run;
use super::audited::Audited;
use super::destination::ReportFormat;
use super::packed::Picture;
use super::text::text;
use super::{findings_geojson, page};
use crate::output::{counted, plain, print};
use crate::status::{Failure, Verdict};

/// Writes an audit. `picture` makes what a page shows. Where a layer or a page goes to a file, a line for people says so.
pub(super) fn write(
    mut audited: Audited,
    run: &Run<'_>,
    picture: impl FnOnce(&Audited) -> Picture,
) -> Result<Verdict, Failure> {
    let Run { asked, to, .. } = run;
    audited.elapsed_ms = run.elapsed_ms();
    let audited = if asked.explain { audited } else { audited.unexplained() };
    match to.format {
        ReportFormat::Text => to.text(&text(&audited)?)?,
        ReportFormat::Json => to.json(&audited.json())?,
        ReportFormat::Geojson => to.bytes(&findings_geojson::layer(&audited)?)?,
        ReportFormat::Html => to.bytes(page::page(&audited, &picture(&audited))?.as_bytes())?,
    }
    if let (ReportFormat::Geojson | ReportFormat::Html, Some(file)) = (to.format, to.file()) {
        let listed = match (audited.listed().count(), audited.total()) {
            (listed, total) if listed as u64 == total => counted(listed, "finding"),
            (listed, total) => format!("{listed} of {}", counted(total as usize, "finding")),
        };
        let [input, verdict, file] =
            [&audited.input, &audited.verdict(), &file.display().to_string()].map(|text| plain(text));
        print(&format!("{input}: {verdict}; {listed} written to {file}\n"))?;
    }
    Ok(if audited.valid { Verdict::Sound } else { Verdict::Wrong })
}
