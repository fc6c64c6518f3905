//! `clean` for a file that is larger than memory.

use super::{Clean, GapWidth};
use crate::on_disk::{shelf_for, tell_excess};
use crate::output::{Failure, Verdict, named};
use crate::progress::busy;
use std::time::Instant;
use twinedge_layers::{Feature, Format, GeoJsonFile};
use twinedge_report::Division;
use twinedge_report::clean::{Cleaning, clean_in_tiles};

impl Clean {
    /// Cleans by tiles, and writes the output feature by feature.
    pub(super) fn in_tiles(&self, division: Division, start: Instant) -> Result<Verdict, Failure> {
        let refused = |why: &str| Err(Failure(format!("--memory, --tiles: {why}")));
        if matches!(self.gap_width, Some(GapWidth::Auto)) {
            return refused("--gap-width auto looks at all gaps at once, and is not for tiles");
        }
        let Some(path) = self.input.path() else {
            return refused("a file is needed, and not standard input");
        };
        let name = path.display().to_string();
        match self.input.format()? {
            Some(format @ (Format::GeoJson | Format::GeoJsonSeq)) => self.output.refuse_other(format)?,
            _ => return refused("only files of GeoJSON and newline-delimited GeoJSON are cleaned feature by feature"),
        }
        self.output.refuse_input(path)?;
        let open = |each: &mut dyn FnMut(Feature)| {
            let mut take = |feature| {
                each(feature);
                Ok(())
            };
            GeoJsonFile::open(path, tempfile::tempfile()?, &mut take)
        };
        let repair = self.repair();
        let cleaned = busy(|stage| clean_in_tiles(open, &repair, division, || shelf_for(division), stage));
        tell_excess(&name, division);
        let (mut file, tiles) = cleaned.map_err(named(&name))?;
        let written = self.output.write_with(file.format(), path, |out| file.write(out).map_err(named(&name)))?;
        let mut report = Cleaning::of_tiles(&name, &repair, &tiles);
        report.written = written.as_ref();
        self.say(report, start)?;
        Ok(if tiles.report.left.is_none() { Verdict::Sound } else { Verdict::Wrong })
    }
}
