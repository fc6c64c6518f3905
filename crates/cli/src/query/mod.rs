//! `twinedge query`: answers one question about a map.

mod at;
mod borders;
mod contour;
mod coverage;
mod faces;
mod lattice;
mod line;
mod list;
mod neighbours;
mod overlay;
mod route;
mod which;

pub(crate) use which::{Source, find};

use crate::input::MapFile;
use crate::output::{Failure, Verdict, plain};
use clap::Subcommand;
use twinedge_report::{Imported, Keep, Units};

/// Ask a map about neighbours, places, lines, outlines, faces, ways and lattice points.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  twinedge query neighbours Switzerland                   in the built-in map of the world
  twinedge query world.geojson neighbours Switzerland
  twinedge query at 28.25 -29.5
  twinedge query line -10 52 30 52 --format json
  twinedge query world.geojson contour Lesotho --format wkt
  twinedge query - faces --format json < parcels.geojson
  twinedge query route Portugal China
  twinedge query counties.geojson neighbours --where STATE=Iowa --name-from NAME
  twinedge query counties.geojson neighbours --all --sort length --limit 20 --format csv
  twinedge query parcels.geojson coverage
  twinedge query soils.gpkg overlay parcels.gpkg

NAME is the name of a feature as the map writes it, or # and its number, counted from 0: '#12'. A file that is called like a \
question, such as faces, needs its folder: ./faces

Exit status: 0 there is an answer; 2 the input could not be read, or has no feature of that name.")]
pub(crate) struct Query {
    #[command(flatten)]
    map: MapFile,

    #[command(subcommand)]
    question: Question,
}

#[derive(Debug, Subcommand)]
enum Question {
    Neighbours(neighbours::Neighbours),
    Coverage(coverage::CoverageOf),
    Overlay(overlay::OverlayOf),
    At(at::At),
    Line(line::Line),
    Contour(contour::Contour),
    Faces(faces::Faces),
    Route(route::Route),
    Lattice(lattice::Lattice),
}

impl Question {
    /// Returns the notes on the input that the answer needs.
    const fn keep(&self) -> Keep<'_> {
        let condition = match self {
            Self::Neighbours(question) => question.condition(),
            Self::Contour(question) => question.condition(),
            _ => None,
        };
        Keep {
            coverage: matches!(self, Self::Coverage(_)),
            condition,
            columns: &[],
            features: matches!(self, Self::Overlay(_)),
            points: matches!(self, Self::Overlay(_)),
        }
    }
}

impl Query {
    pub(crate) fn run(&self) -> Result<Verdict, Failure> {
        let imported = self.map.build_keeping(self.question.keep())?;
        for warning in imported.noted.warnings(&imported.read) {
            eprintln!("twinedge: warning: {}: {warning}", plain(&imported.name));
        }
        if let Question::Coverage(question) = &self.question {
            question.answer(&imported)?;
            return Ok(Verdict::Sound);
        }
        if let Question::Overlay(question) = &self.question {
            question.answer(&imported, &self.map.options)?;
            return Ok(Verdict::Sound);
        }
        if !imported.map.is_plane() {
            let why = "edges cross, touch or overlap, so places are not well defined";
            let input = imported.name;
            return Err(Failure(format!("{input}: {why}; --snap auto cuts them, audit says where they are")));
        }
        let units = match &self.question {
            Question::Neighbours(question) => question.units(&imported)?,
            _ => Units::Plane(Units::UNKNOWN),
        };
        let Imported { name: input, map, noted, .. } = imported;
        let asked = Source { input, map, noted };
        match &self.question {
            Question::Neighbours(question) => question.answer(&asked, &units),
            Question::At(question) => question.answer(&asked),
            Question::Line(question) => question.answer(&asked),
            Question::Contour(question) => question.answer(&asked),
            Question::Faces(question) => question.answer(&asked),
            Question::Route(question) => question.answer(&asked),
            Question::Lattice(question) => question.answer(&asked),
            Question::Coverage(_) | Question::Overlay(_) => Ok(()),
        }?;
        Ok(Verdict::Sound)
    }
}
