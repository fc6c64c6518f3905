//! The input on the grid: equal points made one, and the vertices that they become.

use super::grid::Grid;
use super::input::{Input, NodingError};
use super::pixel::{Pixel, Segment, Steps};
use crate::geometry::point::{Point, folded};
#[cfg(feature = "map")]
use crate::geometry::threads;
use rustc_hash::FxHashMap;

/// A distinct point of the input.
struct Site {
    point: Point,
    at: Steps,
    vertex: u32,
}

/// The input, read.
#[derive(Default)]
pub(super) struct Read {
    sites: Vec<Site>,
    /// The sites where each segment starts and ends.
    ends: Vec<[u32; 2]>,
    /// The sites of the single points.
    points: Vec<u32>,
    /// The pixels of all sites, distinct.
    pub(super) vertices: Vec<Pixel>,
    /// The vertices in the order of their pixels, or none of them.
    pub(super) order: Vec<u32>,
}

impl Read {
    pub(super) fn new(grid: &Grid, segments: &[[Point; 2]], points: &[Point]) -> Self {
        let mut reader =
            Reader { grid, read: Self::default(), sites: FxHashMap::default(), vertices: FxHashMap::default() };
        reader.sites.reserve(segments.len());
        reader.vertices.reserve(segments.len());
        // The segments of a ring follow each other.
        let mut last: Option<(Point, u32)> = None;
        for &[from, to] in segments {
            let from = match last {
                Some((point, site)) if point == from => site,
                _ => reader.site(from),
            };
            let end = reader.site(to);
            last = Some((to, end));
            reader.read.ends.push([from, end]);
        }
        for &point in points {
            let site = reader.site(point);
            reader.read.points.push(site);
        }
        reader.read
    }

    /// The same for distinct points, each of which is a vertex, and segments between them by number.
    #[cfg(feature = "map")]
    pub(super) fn numbered(grid: &Grid, points: &[Point], segments: &[[u32; 2]]) -> Self {
        let places: Vec<Steps> = threads::map(points, |point| grid.steps(*point));
        let mut sorted: Vec<(Pixel, u32)> = places.iter().map(|at| grid.pixels.at(*at)).zip(0..).collect();
        // One number for both coordinates is compared without a branch.
        let key = |[x, y]: Pixel| i128::from(x) << 64 | i128::from(y.cast_unsigned() ^ 1 << 63);
        threads::sort_unstable_by(&mut sorted, |(a, p), (b, q)| key(*a).cmp(&key(*b)).then(p.cmp(q)));
        // The vertices keep the order of the points: neighbours in a drawing are mostly neighbours there.
        let mut vertices: Vec<Pixel> = Vec::with_capacity(points.len());
        let mut vertex_of = vec![0; points.len()];
        let first_of = |equal: &[(Pixel, u32)]| equal[0].1;
        for equal in sorted.chunk_by(|(p, _), (q, _)| p == q) {
            for (_, number) in equal {
                vertex_of[*number as usize] = first_of(equal);
            }
        }
        for number in 0..points.len() {
            let first = vertex_of[number] as usize;
            if first == number {
                vertex_of[number] = vertices.len() as u32;
                vertices.push(grid.pixels.at(places[number]));
            } else {
                vertex_of[number] = vertex_of[first];
            }
        }
        let order = sorted.chunk_by(|(p, _), (q, _)| p == q).map(|equal| vertex_of[first_of(equal) as usize]).collect();
        let site = |((point, at), vertex): ((&Point, Steps), u32)| Site { point: *point, at, vertex };
        Self {
            sites: points.iter().zip(places).zip(vertex_of).map(site).collect(),
            ends: segments.to_vec(),
            points: (0..points.len() as u32).collect(),
            vertices,
            order,
        }
    }

    /// The segments that are more than a vertex.
    pub(super) fn segments(&self) -> Vec<Segment> {
        let longer = self.ends.iter().map(|ends| ends.map(|site| &self.sites[site as usize]));
        let mut segments = Vec::with_capacity(self.ends.len());
        segments.extend(
            longer
                .filter(|[p, q]| p.vertex != q.vertex)
                .map(|[p, q]| if p.at < q.at { [p, q] } else { [q, p] })
                .map(|[p, q]| Segment { a: p.at, b: q.at, ends: [p.vertex, q.vertex] }),
        );
        segments
    }

    /// The vertices where each segment starts and ends.
    pub(super) fn ends(&self) -> impl Iterator<Item = [u32; 2]> {
        self.ends.iter().map(|ends| ends.map(|site| self.sites[site as usize].vertex))
    }

    /// The vertices of the single points.
    pub(super) fn points(&self) -> impl Iterator<Item = u32> {
        self.points.iter().map(|&site| self.sites[site as usize].vertex)
    }

    /// Returns the number of distinct points.
    pub(super) fn distinct(&self) -> usize {
        self.sites.len()
    }

    /// The largest move of a point, in x and in y.
    pub(super) fn largest_move(&self, grid: &Grid) -> [f64; 2] {
        self.sites.iter().fold([0.0; 2], |[x, y], Site { point, vertex, .. }| {
            let to = grid.point(self.vertices[*vertex as usize]);
            [f64::max(x, (to.x - point.x).abs()), f64::max(y, (to.y - point.y).abs())]
        })
    }
}

struct Reader<'a> {
    grid: &'a Grid,
    read: Read,
    /// By [`Point::hash_key`].
    sites: FxHashMap<(u64, u64), u32>,
    /// By the coordinates of the pixel, folded.
    vertices: FxHashMap<(u64, u64), u32>,
}

impl Reader<'_> {
    fn site(&mut self, point: Point) -> u32 {
        *self.sites.entry(point.hash_key()).or_insert_with(|| {
            let at = self.grid.steps(point);
            let pixel = self.grid.pixels.at(at);
            let key = pixel.map(|c| folded(c.cast_unsigned()));
            let vertex = *self.vertices.entry(key.into()).or_insert_with(|| {
                self.read.vertices.push(pixel);
                self.read.vertices.len() as u32 - 1
            });
            self.read.sites.push(Site { point, at, vertex });
            self.read.sites.len() as u32 - 1
        })
    }
}

/// The largest magnitude of a coordinate, and the first that has it.
pub(super) fn largest_coordinate(segments: &[[Point; 2]], points: &[Point]) -> Result<(f64, Input), NodingError> {
    let ends = segments.iter().enumerate().flat_map(|(i, ends)| ends.iter().map(move |p| (p, Input::Segment(i))));
    let points = points.iter().enumerate().map(|(i, p)| (p, Input::Point(i)));
    ends.chain(points).try_fold((0.0, Input::Segment(0)), |largest, (p, at)| {
        let magnitude = p.x.abs().max(p.y.abs());
        if !(p.x.is_finite() && p.y.is_finite()) {
            Err(NodingError::NotFinite { at })
        } else if magnitude > largest.0 {
            Ok((magnitude, at))
        } else {
            Ok(largest)
        }
    })
}
