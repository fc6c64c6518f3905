//! `twinedge draw`: a picture of a map.

use crate::input::MapFile;
use crate::output::style::BAD;
use crate::output::{Failure, Verdict, grouped, print_answer};
use crate::output_file::{format_of, write_file};
use std::path::{Path, PathBuf};
use twinedge::validate::{Collect, Expectation};
use twinedge_geometry::Point;
use twinedge_map::{PlanarMap, validate_embedding};
use twinedge_report::Imported;
use twinedge_report::svg::{self, Options};
use twinedge_report::textbook::Textbook;

/// The maximal number of half-edges that are legible with `--detail`.
const LEGIBLE: usize = 1_000;

/// Draw a map as SVG: its faces, its edges, and in red what breaks a rule.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  twinedge draw -o world.svg                                     the built-in map of the world
  twinedge draw parcels.geojson --detail -o parcels.svg          with half-edges, as textbooks draw them
  twinedge draw --detail --window 5.5 45.5 11 48 -o alps.svg     a part of it

Each feature has a colour, and neighbours have different ones. A face that two features claim is hatched, a gap between them is \
dotted, and a dashed ring shows where one of them is tiny. A map that is not plane is drawn as well; violations have numbers, which \
are explained below the map. Islands far from everything else are drawn in insets, unless --whole is given.

Exit status: 0 the map is drawn and valid; 1 it is drawn, and violations are marked; 2 it could not be read or drawn.")]
#[allow(clippy::struct_excessive_bools, reason = "flags of a command")]
pub(crate) struct Draw {
    #[command(flatten)]
    map: MapFile,

    /// File to write; `-` is standard output, and the default.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,

    /// Draw half-edges as arrows, with their names and links, and the names of vertices and faces.
    #[arg(long)]
    detail: bool,

    /// Write the three tables of the textbooks instead of a picture: vertices, faces, half-edges.
    #[arg(long, conflicts_with_all = ["detail", "force", "window", "size", "whole"])]
    tables: bool,

    /// Draw details even if there are too many to be legible.
    #[arg(long)]
    force: bool,

    /// Draw only the rectangle between two opposite corners.
    #[arg(long, num_args = 4, value_names = ["X0", "Y0", "X1", "Y1"], allow_negative_numbers = true)]
    window: Option<Vec<f64>>,

    /// Draw islands far from everything else where they are, even if that makes everything small.
    #[arg(long)]
    whole: bool,

    /// Longer side of the map in the picture, in pixels.
    #[arg(long, value_name = "PIXELS", default_value_t = 1_200, value_parser = clap::value_parser!(u32).range(100..=100_000))]
    size: u32,

    /// Greatest number of violations to mark.
    #[arg(long, value_name = "N", default_value_t = Collect::DEFAULT_CAP, value_parser = twinedge_report::whole, allow_negative_numbers = true)]
    list: usize,
}

/// Returns the least and the greatest coordinates of all vertices; `None` if there is no vertex.
fn extent(map: &PlanarMap) -> Result<Option<[Point; 2]>, Failure> {
    let mut extent: Option<[Point; 2]> = None;
    for vertex in map.dcel().vertices() {
        let p = map.position(vertex.key())?;
        let [low, high] = extent.unwrap_or([p, p]);
        extent = Some([Point::new(low.x.min(p.x), low.y.min(p.y)), Point::new(high.x.max(p.x), high.y.max(p.y))]);
    }
    Ok(extent)
}

/// Refuses a window that misses the map: the picture would be empty.
fn refuse_outside(name: &str, [a, b]: [Point; 2], [low, high]: [Point; 2]) -> Result<(), Failure> {
    let is_apart = |a: f64, b: f64, low: f64, high: f64| a.max(b) < low || a.min(b) > high;
    if is_apart(a.x, b.x, low.x, high.x) || is_apart(a.y, b.y, low.y, high.y) {
        let (x0, y0, x1, y1) = (low.x, low.y, high.x, high.y);
        return Err(Failure(format!(
            "{name}: --window lies outside the map, which spans ({x0}, {y0}) to ({x1}, {y1})"
        )));
    }
    Ok(())
}

impl Draw {
    pub(crate) fn run(&self) -> Result<Verdict, Failure> {
        let window = match self.window.as_deref() {
            None => None,
            Some(&[x0, y0, x1, y1]) if [x1 - x0, y1 - y0].iter().all(|side| side.is_finite() && *side != 0.0) => {
                Some([Point::new(x0, y0), Point::new(x1, y1)])
            }
            Some(_) => return Err(Failure("--window needs two corners of a rectangle with an area".to_owned())),
        };
        let file = self.output.as_deref().filter(|path| *path != Path::new("-"));
        format_of(file, &[(if self.tables { "txt" } else { "svg" }, ())])?;
        let Imported { name, map, .. } = self.map.build()?;
        if let (Some(window), Some(extent)) = (window, extent(&map)?) {
            refuse_outside(&name, window, extent)?;
        }
        let half_edges = svg::half_edges_in(&map, window);
        if self.detail && half_edges > LEGIBLE && !self.force {
            let (found, limit) = (grouped(half_edges), grouped(LEGIBLE));
            return Err(Failure(format!(
                "{name}: {found} half-edges are too many for --detail, which is legible up to {limit}: choose a part with \
--window, or use --force"
            )));
        }
        let report = validate_embedding(&map, &Expectation::plane(), Collect::AtMost(self.list));
        let options = Options {
            size: self.size.into(),
            detail: self.detail,
            window,
            insets: !self.whole,
            violations: report.violations(),
        };
        let picture = if self.tables { Textbook::of_embedding(&map).to_string() } else { svg::draw(&map, &options) };
        match file {
            None => print_answer(&picture)?,
            Some(path) => write_file(path, self.map.path(), picture.as_bytes())?,
        }
        if report.is_valid() {
            return Ok(Verdict::Sound);
        }
        let first = report.first().map(ToString::to_string).unwrap_or_default();
        anstream::eprintln!("{BAD}not valid{BAD:#}: {name}: {first}; `twinedge audit` says all");
        Ok(Verdict::Wrong)
    }
}
