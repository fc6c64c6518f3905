//! `twinedge voronoi`: the cells of the points of a file.

use crate::input::LayerFile;
use crate::output::{Failure, Verdict, plain, print, print_answer};
use crate::output_file::{format_of, write_file};
use std::path::{Path, PathBuf};
use twinedge_algorithm::voronoi::{Voronoi, VoronoiError, delaunay, voronoi, voronoi_merging};
use twinedge_geometry::Point;
use twinedge_map::PlanarMap;
use twinedge_report::svg::{self, Options};
use twinedge_report::voronoi::{Sites, cells, shared, triangles};

/// Make the Voronoi diagram of points: for each the part of the plane that is nearest to it.
///
/// Each cell has the properties of its point, and `site`, the number of the point, counted from 0. Points at the same place have
/// one cell, the first one's. Unbounded cells are closed by a box, the one given or one that is a tenth wider than the points;
/// it is the `bbox` of the output.
#[derive(Debug, clap::Args)]
#[command(
    name = "voronoi",
    after_help = "Examples:
  twinedge voronoi stations.geojson -o cells.geojson
  twinedge voronoi stations.gpkg --layer active --bounds 5.5 45.5 11 48 -o cells.svg
  twinedge voronoi stations.geojson --merge-close -o cells.geojson
  twinedge voronoi stations.geojson --delaunay -o triangles.geojson

Exit status: 0 the diagram is made; 2 the input could not be read or has something else than points, or a point lies outside \
the bounds."
)]
pub(crate) struct MakeVoronoi {
    #[command(flatten)]
    points: LayerFile,

    /// Lower left and upper right corner of the box that closes the cells.
    #[arg(long, num_args = 4, value_names = ["X0", "Y0", "X1", "Y1"], allow_negative_numbers = true, conflicts_with = "delaunay")]
    bounds: Option<Vec<f64>>,

    /// Make the triangles of the Delaunay triangulation instead, without properties but `sites`, the numbers of their corners.
    #[arg(long)]
    delaunay: bool,

    /// Give points that are too close to each other for doubles to tell their cells apart one cell, and name them. Without this, there is
    /// no diagram then.
    #[arg(long, conflicts_with = "delaunay")]
    merge_close: bool,

    /// File to write, GeoJSON or, by the ending .svg, a picture; `-` is GeoJSON on standard output, and the default.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

impl MakeVoronoi {
    pub(crate) fn run(&self) -> Result<Verdict, Failure> {
        let file = self.output.as_deref().filter(|path| *path != Path::new("-"));
        let is_svg = format_of(file, &[("geojson", false), ("json", false), ("svg", true)])?.unwrap_or(false);
        let (name, sites) = self.read()?;
        let failed = |error: VoronoiError| Failure(format!("{name}: {error}"));
        let (map, collection, what) = if self.delaunay {
            let found = delaunay(&sites.points).map_err(failed)?;
            let (collection, what) = triangles(&found)?;
            (found.map, collection, what)
        } else {
            let bounds = match self.bounds.as_deref() {
                Some(&[x0, y0, x1, y1]) => Some([Point::new(x0, y0), Point::new(x1, y1)]),
                _ => None,
            };
            let make = if self.merge_close { voronoi_merging } else { voronoi };
            let found = make(&sites.points, bounds).map_err(|error| match error {
                VoronoiError::TooClose { .. } => Failure(format!("{name}: {error}; --merge-close gives them one cell")),
                error => failed(error),
            })?;
            if let (None, Some(shared)) = (file, shared(&found)) {
                anstream::eprintln!("{}: {shared}", plain(&name));
            }
            let (collection, what) = cells(&found, &sites)?;
            (coloured(found)?, collection, what)
        };
        let Some(path) = file else {
            print_answer(&collection)?;
            return Ok(Verdict::Sound);
        };
        let text = if is_svg { svg::draw(&map, &Options::default()) } else { collection };
        write_file(path, self.points.path(), text.as_bytes())?;
        print(&format!("{}: {what}\n", plain(&name)))?;
        Ok(Verdict::Sound)
    }

    fn read(&self) -> Result<(String, Sites), Failure> {
        let (name, layer) = self.points.read()?;
        let sites = Sites::new(&layer).map_err(|error| Failure(format!("{name}: {error}")))?;
        Ok((name, sites))
    }
}

/// Builds the map with a feature for each cell, so that neighbours have different colours.
fn coloured(found: Voronoi) -> Result<PlanarMap, Failure> {
    let mut map = found.map;
    for cell in found.cells {
        let feature = map.add_feature(None);
        map.set_features_of(cell, [feature])?;
    }
    Ok(map)
}
