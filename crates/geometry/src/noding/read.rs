//! The input on the grid: merges equal points, and assigns vertices to them.

use super::grid::Grid;
use super::input::{Input, NodingError};
use super::pixel::{Pixel, Segment, Steps};
use crate::events::sorted;
use crate::point::{Point, folded};
use crate::threads;
use rustc_hash::FxHashMap;
use std::borrow::Cow;

/// The input as read. Points and segments with given numbers are borrowed.
#[derive(Default)]
pub(super) struct Read<'a> {
    sites: Cow<'a, [Point]>,
    /// By site, its position and its vertex.
    positions: Vec<Steps>,
    vertex_of: Vec<u32>,
    /// The sites where each segment starts and ends.
    ends: Cow<'a, [[u32; 2]]>,
    points: Vec<u32>,
    pub(super) vertices: Vec<Pixel>,
    /// The vertices in the order of their pixels, or empty.
    pub(super) order: Vec<u32>,
}

impl<'a> Read<'a> {
    pub(super) fn new(grid: &Grid, segments: &[[Point; 2]], points: &[Point]) -> Self {
        let mut reader =
            Reader { grid, read: Read::default(), sites: FxHashMap::default(), vertices: FxHashMap::default() };
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
            reader.read.ends.to_mut().push([from, end]);
        }
        for &point in points {
            let site = reader.site(point);
            reader.read.points.push(site);
        }
        reader.read
    }

    /// Reads distinct points, all of them vertices, and segments between them by number.
    pub(super) fn numbered(grid: &Grid, points: &'a [Point], segments: &'a [[u32; 2]]) -> Self {
        let positions: Vec<Steps> = threads::map(points, |point| grid.steps(*point));
        let pixel = |number: u32| grid.pixels.at(positions[number as usize]);
        // The points of a column of pixels follow each other.
        let mut by_pixel: Vec<(Pixel, u32)> =
            sorted(points).into_iter().map(|event| (pixel(event.vertex), event.vertex)).collect();
        for column in by_pixel.chunk_by_mut(|(p, _), (q, _)| p[0] == q[0]) {
            threads::sort_unstable_by(column, |(p, i), (q, j)| p[1].cmp(&q[1]).then(i.cmp(j)));
        }
        // The vertices keep the order of the points: neighbours in a drawing are mostly neighbours there.
        let mut vertex_of = vec![0; points.len()];
        let first_of = |equal: &[(Pixel, u32)]| equal[0].1;
        let mut order = Vec::with_capacity(points.len());
        for equal in by_pixel.chunk_by(|(p, _), (q, _)| p == q) {
            order.push(first_of(equal));
            for (_, number) in equal {
                vertex_of[*number as usize] = first_of(equal);
            }
        }
        drop(by_pixel);
        let mut vertices: Vec<Pixel> = Vec::with_capacity(order.len());
        for number in 0..points.len() as u32 {
            let first = vertex_of[number as usize];
            if first == number {
                vertex_of[number as usize] = vertices.len() as u32;
                vertices.push(pixel(number));
            } else {
                vertex_of[number as usize] = vertex_of[first as usize];
            }
        }
        for first in &mut order {
            *first = vertex_of[*first as usize];
        }
        Self {
            sites: points.into(),
            positions,
            vertex_of,
            ends: segments.into(),
            points: (0..points.len() as u32).collect(),
            vertices,
            order,
        }
    }

    pub(super) fn segments(&self) -> Vec<Segment> {
        let mut segments = Vec::with_capacity(self.ends.len());
        segments.extend(self.ends.iter().filter_map(|ends| {
            let [p, q] = ends.map(|site| (self.positions[site as usize], self.vertex_of[site as usize]));
            let [(a, from), (b, to)] = if p.0 < q.0 { [p, q] } else { [q, p] };
            (from != to).then_some(Segment { a, b, ends: [from, to] })
        }));
        segments
    }

    /// Returns the vertices where each segment starts and ends.
    pub(super) fn ends(&self) -> impl Iterator<Item = [u32; 2]> {
        self.ends.iter().map(|ends| ends.map(|site| self.vertex_of[site as usize]))
    }

    pub(super) fn points(&self) -> impl Iterator<Item = u32> {
        self.points.iter().map(|&site| self.vertex_of[site as usize])
    }

    pub(super) fn distinct(&self) -> usize {
        self.sites.len()
    }

    pub(super) fn largest_move(&self, grid: &Grid, vertices: &[Pixel]) -> [f64; 2] {
        self.sites.iter().zip(&self.vertex_of).fold([0.0; 2], |[x, y], (point, vertex)| {
            let to = grid.point(vertices[*vertex as usize]);
            [f64::max(x, (to.x - point.x).abs()), f64::max(y, (to.y - point.y).abs())]
        })
    }
}

struct Reader<'a> {
    grid: &'a Grid,
    read: Read<'static>,
    /// Keyed by [`Point::hash_key`].
    sites: FxHashMap<(u64, u64), u32>,
    /// Keyed by the folded coordinates of the pixel.
    vertices: FxHashMap<(u64, u64), u32>,
}

impl Reader<'_> {
    fn site(&mut self, point: Point) -> u32 {
        *self.sites.entry(point.hash_key()).or_insert_with(|| {
            let position = self.grid.steps(point);
            let pixel = self.grid.pixels.at(position);
            let key = pixel.map(|c| folded(c.cast_unsigned()));
            let vertex = *self.vertices.entry(key.into()).or_insert_with(|| {
                self.read.vertices.push(pixel);
                self.read.vertices.len() as u32 - 1
            });
            self.read.sites.to_mut().push(point);
            self.read.positions.push(position);
            self.read.vertex_of.push(vertex);
            self.read.sites.len() as u32 - 1
        })
    }
}

/// Returns the largest magnitude of a coordinate, and the first part of the input where it occurs.
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
