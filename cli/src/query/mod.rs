//! `twinedge query`: answers one question about a map.

mod asked;
mod at;
mod contour;
mod faces;
mod lattice;
mod line;
mod names;
mod neighbours;
mod record;
mod route;

pub(crate) use asked::Asked;
pub(crate) use names::{find, label};

use crate::input::{Imported, MapFile};
use crate::status::{Failure, Verdict};
use clap::Subcommand;

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
    At(at::At),
    Line(line::Line),
    Contour(contour::Contour),
    Faces(faces::Faces),
    Route(route::Route),
    Lattice(lattice::Lattice),
}

impl Query {
    pub(crate) fn run(&self) -> Result<Verdict, Failure> {
        let Imported { name: input, map, .. } = self.map.build()?;
        if !map.is_plane() {
            let why = "edges cross, touch or overlap, so places are not well defined";
            return Err(Failure(format!("{input}: {why}; --snap auto cuts them, audit says where they are")));
        }
        let asked = Asked { input, map };
        match &self.question {
            Question::Neighbours(question) => question.answer(&asked),
            Question::At(question) => question.answer(&asked),
            Question::Line(question) => question.answer(&asked),
            Question::Contour(question) => question.answer(&asked),
            Question::Faces(question) => question.answer(&asked),
            Question::Route(question) => question.answer(&asked),
            Question::Lattice(question) => question.answer(&asked),
        }?;
        Ok(Verdict::Sound)
    }
}
