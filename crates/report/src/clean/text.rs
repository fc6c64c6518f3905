//! The report as text.

use super::{Cleaning, Written};
use crate::words::noding_line;
use crate::words::style::{BAD, GOOD, QUIET};
use crate::words::{counted, decimals_of, grouped, measure, place, plain};
use std::fmt::Write as _;
use twinedge_coverage::clean::{ChangeKind, ChosenWidth};
use twinedge_layers::clean::{FeatureChange, LayerChange, Left};

impl Cleaning<'_> {
    /// Returns the report as text, with at most `list` changes.
    ///
    /// # Errors
    /// Never: writing to a string does not fail.
    pub fn text(&self, list: usize) -> Result<String, std::fmt::Error> {
        let Self { name, report, decimals, .. } = self;
        let decimals = *decimals;
        let mut out = String::new();
        writeln!(out, "{}", plain(name))?;
        let all = counted(self.features, "feature");
        writeln!(out, "{QUIET}{all}, {} with polygons{QUIET:#}", grouped(report.polygons))?;
        if let Some(noding) = report.noding.as_ref().filter(|noding| noding.cell > 0.0) {
            writeln!(out, "{QUIET}{}{QUIET:#}", noding_line(noding))?;
        }
        let limit = format!("  {QUIET}below an area of {}{QUIET:#}", measure(report.sliver_area));
        if let Some(tiles) = &self.tiles {
            writeln!(out, "{QUIET}{}{QUIET:#}", tiles.line)?;
        }
        out.push('\n');
        for (kind, what, beside) in [
            (ChangeKind::Overlap, "overlaps resolved", String::new()),
            (ChangeKind::Gap, "gaps filled", self.width()),
            (ChangeKind::Sliver, "slivers given to neighbours or dropped", limit),
        ] {
            let found = report.changes.iter().filter(|change| change.kind == kind);
            let area: f64 = found.clone().map(|change| change.area).sum();
            let area = if area > 0.0 { format!("  area {}", measure(area)) } else { String::new() };
            writeln!(out, "  {what:38} {:>9}{area}{beside}", grouped(found.count()))?;
        }
        writeln!(out, "  {:38} {:>9}", "vertices of neighbours added", grouped(report.added.len()))?;
        let gone = report.features.iter().filter(|feature| feature.area_after == 0.0).count();
        for (what, count) in
            [("features with another geometry", report.features.len()), ("of these, without area now", gone)]
        {
            writeln!(out, "  {what:38} {:>9}", grouped(count))?;
        }
        out.push('\n');
        for change in report.changes.iter().take(list) {
            self.write_change(&mut out, change, decimals)?;
        }
        let more = report.changes.len().saturating_sub(list);
        if more > 0 {
            writeln!(out, "… and {} more; see --list", grouped(more))?;
        }
        for vertex in report.added.iter().take(list) {
            let at = place([vertex.at.x, vertex.at.y], decimals);
            writeln!(out, "vertex of {} added to {}: at {at}", self.label(vertex.of), self.label(vertex.to))?;
        }
        let more = report.added.len().saturating_sub(list);
        if more > 0 {
            writeln!(out, "… and {} more vertices; see --list", grouped(more))?;
        }
        for feature in report.features.iter().take(list) {
            let FeatureChange { feature: number, area_before, area_after, points_before, points_after, .. } = feature;
            writeln!(
                out,
                "{}: area {} → {}, points {} → {}; {}",
                self.label(*number),
                measure(*area_before),
                measure(*area_after),
                grouped(*points_before),
                grouped(*points_after),
                self.reasons(feature).join("; "),
            )?;
        }
        let more = report.features.len().saturating_sub(list);
        if more > 0 {
            writeln!(out, "… and {} more features; see --list", grouped(more))?;
        }
        for warning in self.warnings() {
            writeln!(out, "{BAD}warning{BAD:#}: {warning}")?;
        }
        for one in report.remaining.iter().take(list) {
            writeln!(out, "left: {}", self.remaining(one, decimals))?;
        }
        let more = report.remaining.len().saturating_sub(list);
        if more > 0 {
            writeln!(out, "… and {} more are left; see --list", grouped(more))?;
        }
        self.write_too_large(&mut out, list)?;
        for one in report.wider_gaps.iter().take(list) {
            writeln!(out, "left as it is: {}", self.remaining(one, decimals))?;
        }
        for one in report.accepted_gaps.iter().take(list) {
            writeln!(out, "accepted: {}", self.described(one, decimals))?;
        }
        if let Some(Written { name, format }) = self.written {
            writeln!(out, "written to {} ({format})", plain(name))?;
        }
        if let Some(patch) = self.patch {
            writeln!(out, "what takes it back is in {}", plain(patch))?;
        }
        self.write_verdict(&mut out)?;
        Ok(out)
    }

    fn write_too_large(&self, out: &mut String, list: usize) -> std::fmt::Result {
        for one in self.tiles.iter().flat_map(|tiles| &tiles.too_large).take(list) {
            writeln!(out, "{BAD}not cleaned{BAD:#}: {one}")?;
        }
        Ok(())
    }

    fn write_verdict(&self, out: &mut String) -> std::fmt::Result {
        let too_large = self.tiles.as_ref().map_or(0, |tiles| tiles.too_large.len());
        match &self.report.left {
            Some(_) if too_large > 0 => {
                let all = counted(too_large, "neighbourhood");
                writeln!(out, "{BAD}not clean{BAD:#}: {all} took more than --memory ({:.0} ms)", self.elapsed_ms)
            }
            None => writeln!(out, "{GOOD}clean{GOOD:#}: C1 to C7 hold{} ({:.0} ms)", self.wider(), self.elapsed_ms),
            Some(left) => writeln!(out, "{BAD}not clean{BAD:#}: {} ({:.0} ms)", left_text(left), self.elapsed_ms),
        }
    }

    /// The width up to which gaps were filled, for `--gap-width auto`.
    fn width(&self) -> String {
        let text = match self.report.chosen {
            Some(ChosenWidth { width, gaps, next, .. }) => {
                format!(
                    "up to the width {width}, chosen: {}, and none from there to {}",
                    counted(gaps, "gap"),
                    measure(next)
                )
            }
            None if self.chooses_width => "no width was chosen: none is ten times narrower than the next".to_owned(),
            None => return String::new(),
        };
        format!("  {QUIET}{text}{QUIET:#}")
    }

    /// The number of gaps left because they are wider than the limit.
    fn wider(&self) -> String {
        match (self.report.wider_gaps.len(), self.greatest_gap) {
            (_, None) => String::new(),
            (0, Some(width)) => format!(", up to a gap width of {width}"),
            (1, Some(width)) => format!("; 1 gap wider than {width} is left"),
            (n, Some(width)) => format!("; {} gaps wider than {width} are left", grouped(n)),
        }
    }

    fn write_change(&self, out: &mut String, change: &LayerChange, decimals: usize) -> std::fmt::Result {
        let to = change.to.map_or_else(|| "nobody".to_owned(), |to| self.label(to));
        let from = match &change.from[..] {
            [] => String::new(),
            from => format!(" of {}", self.labels(from)),
        };
        let (area, width) = (measure(change.area), measure(change.width));
        let at = place([change.at.x, change.at.y], decimals.max(decimals_of(Some(change.width))));
        writeln!(out, "{}{from} to {to}: area {area}, width {width}, at {at}", change.kind)
    }
}

/// The remaining findings, and the options that remove them.
fn left_text(left: &Left) -> String {
    if !left.is_plane {
        return "borders still cross; --snap SIZE rounds them to a coarser grid".to_owned();
    }
    let all = [
        (left.overlaps, "overlap", ""),
        (left.gaps, "gap", " (--gap-width W fills those up to a width)"),
        (left.near_misses, "near miss", " (--gap-width W closes those up to a width)"),
        (left.slivers, "sliver", " that is all there is of its feature"),
        (left.invalid, "invalid feature", ""),
    ];
    let parts = all.iter().filter(|(count, ..)| *count > 0).map(|(count, what, hint)| match (*count, *what) {
        (n, "near miss") if n > 1 => format!("{} near misses{hint}", grouped(n)),
        (n, what) => format!("{}{hint}", counted(n, what)),
    });
    format!("left are {}", parts.collect::<Vec<_>>().join(", "))
}
