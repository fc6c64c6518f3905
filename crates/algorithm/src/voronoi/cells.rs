//! The edges of a Voronoi diagram inside a box, from the triangulation.
//!
//! The border between the cells of two sites lies on the line halfway between them, parametrised by a number `u`: 0 between the
//! sites, growing to the left of the direction from one to the other. It runs from the circumcentre of the triangle on the right
//! to that of the triangle on the left; without a triangle, it has no end. An end inside the box is the rounded centre, shared by
//! all edges that end there; a border that leaves the box ends exactly on a side of the box.

use super::centre::centre;
use super::sites::{Site, Triangulation};
use rustc_hash::FxHashMap;
use spade::Triangulation as _;
use spade::handles::{DirectedEdgeHandle, FaceHandle, PossiblyOuterTag};
use twinedge_geometry::predicates::on_one_circle;
use twinedge_geometry::{MIN_COORDINATE, Point};

type Edge<'a> = DirectedEdgeHandle<'a, Site, (), (), ()>;

pub(super) const NO_SITE: u32 = u32::MAX;

#[derive(Debug, Default)]
pub(super) struct Drawing {
    pub(super) points: Vec<Point>,
    pub(super) segments: Vec<[u32; 2]>,
    /// For each segment, the vertices of the triangulation whose cells lie to its left and to its right.
    pub(super) sites: Vec<[u32; 2]>,
    places: FxHashMap<[u64; 2], u32>,
}

impl Drawing {
    fn point(&mut self, p: Point) -> u32 {
        // A coordinate too close to zero becomes zero. Adding zero turns −0 into 0.
        let [x, y] = [p.x, p.y].map(|c| if c.abs() < MIN_COORDINATE { 0.0 } else { c + 0.0 });
        let next = self.points.len() as u32;
        let number = *self.places.entry([x.to_bits(), y.to_bits()]).or_insert(next);
        if number == next {
            self.points.push(Point::new(x, y));
        }
        number
    }

    /// Draws a segment, unless its ends have been rounded to one point.
    fn segment(&mut self, ends: [u32; 2], sites: [u32; 2]) {
        if ends[0] != ends[1] {
            self.segments.push(ends);
            self.sites.push(sites);
        }
    }
}

/// The box, and the distance from its border within which a centre counts as on it.
struct Frame {
    low: Point,
    high: Point,
    shortest: f64,
}

impl Frame {
    /// Returns the point where a centre is drawn, with the side that contains it, if any; `None` if the centre is outside.
    fn place(&self, centre: Point) -> Option<(Point, Option<usize>)> {
        let Self { low, high, shortest } = *self;
        let gaps = [centre.y - low.y, high.x - centre.x, high.y - centre.y, centre.x - low.x];
        if gaps.iter().any(|gap| *gap < -shortest) {
            return None;
        }
        let mut place = centre;
        let mut on = None;
        for (side, _) in gaps.iter().enumerate().filter(|(_, gap)| **gap <= shortest) {
            on = Some(side);
            match side {
                0 => place.y = low.y,
                1 => place.x = high.x,
                2 => place.y = high.y,
                _ => place.x = low.x,
            }
        }
        Some((place, on))
    }
}

/// The four sides, each with its points by the varying coordinate.
#[derive(Default)]
struct Sides([Vec<(f64, u32)>; 4]);

/// Draws the borders between cells, and the box. A border no longer than `shortest` collapses to one point.
pub(super) fn draw(triangulation: &Triangulation, [low, high]: [Point; 2], shortest: f64) -> Drawing {
    let mut drawing = Drawing::default();
    let mut sides = Sides::default();
    let centres = Centres::new(triangulation, shortest);
    let frame = Frame { low, high, shortest };
    let mut numbers = vec![None; triangulation.num_all_faces()];
    for e in triangulation.undirected_edges() {
        let e = e.as_directed();
        let line = Line::new(e);
        let Some((entry, exit)) = line.within(low, high) else { continue };
        let centres = [e.rev().face(), e.face()].map(|face| centres.of(face));
        let places = centres.map(|end| end.and_then(|(face, centre)| Some((face, frame.place(centre)?))));
        // An end that is not inside lies before the box or behind it, as seen along the line, in every rounding.
        let middle = entry.0.midpoint(exit.0);
        let is_inside = |i: usize| places[i].is_some_and(|(_, (_, side))| side.is_none());
        let starts = is_inside(0) || centres[0].is_none_or(|(_, centre)| line.at(centre) < middle);
        let ends = is_inside(1) || centres[1].is_none_or(|(_, centre)| line.at(centre) > middle);
        if !(starts && ends) {
            continue;
        }
        let mut end = |i: usize, (_, side, at): Crossing| {
            if let Some((face, (centre, side))) = places[i] {
                let made = || {
                    let number = drawing.point(centre);
                    if let Some(side) = side {
                        sides.0[side].push((if side % 2 == 0 { centre.x } else { centre.y }, number));
                    }
                    number
                };
                return *numbers[face].get_or_insert_with(made);
            }
            let number = drawing.point(match side {
                0 => Point::new(at, low.y),
                1 => Point::new(high.x, at),
                2 => Point::new(at, high.y),
                _ => Point::new(low.x, at),
            });
            sides.0[side].push((at, number));
            number
        };
        let ends = [end(0, entry), end(1, exit)];
        // To the left of the border lies the cell of the site where the edge starts.
        drawing.segment(ends, [e.from().index() as u32, e.to().index() as u32]);
    }
    draw_box(&mut drawing, sides, [low, high]);
    drawing
}

/// Draws the box, counter-clockwise, through the points on its sides.
fn draw_box(drawing: &mut Drawing, sides: Sides, [low, high]: [Point; 2]) {
    let corners = [low, Point::new(high.x, low.y), high, Point::new(low.x, high.y)].map(|p| drawing.point(p));
    for (side, mut points) in sides.0.into_iter().enumerate() {
        points.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        if side >= 2 {
            points.reverse();
        }
        let mut last = corners[side];
        for number in points.into_iter().map(|(_, number)| number).chain([corners[(side + 1) % 4]]) {
            // The cell inside is found from another one of its edges.
            drawing.segment([last, number], [NO_SITE; 2]);
            last = number;
        }
    }
}

/// The crossing of a line with a side of the box: the position on the line, the side, and the coordinate on the side.
type Crossing = (f64, usize, f64);

struct Line {
    middle: Point,
    direction: Point,
}

impl Line {
    fn new(e: Edge<'_>) -> Self {
        let [s, t] = [e.from(), e.to()].map(|v| v.data().point());
        let middle = Point::new(s.x + (t.x - s.x) / 2.0, s.y + (t.y - s.y) / 2.0);
        Self { middle, direction: Point::new(s.y - t.y, t.x - s.x) }
    }

    /// Returns the position on the line nearest to a point.
    fn at(&self, p: Point) -> f64 {
        let Point { x, y } = self.direction;
        ((p.x - self.middle.x) * x + (p.y - self.middle.y) * y) / (x * x + y * y)
    }

    /// Returns the crossings at which the line enters and leaves a box.
    fn within(&self, low: Point, high: Point) -> Option<(Crossing, Crossing)> {
        let (m, d) = (self.middle, self.direction);
        let (mut entry, mut exit): (Crossing, Crossing) = ((f64::NEG_INFINITY, 0, 0.0), (f64::INFINITY, 0, 0.0));
        // Sides in order: below, right, above, left.
        let sides = [(d.y, low.y - m.y), (-d.x, m.x - high.x), (-d.y, m.y - high.y), (d.x, low.x - m.x)];
        for (side, (towards_inside, gap)) in sides.into_iter().enumerate() {
            let u = gap / towards_inside;
            if towards_inside > 0.0 && u > entry.0 {
                entry = (u, side, 0.0);
            } else if towards_inside < 0.0 && u < exit.0 {
                exit = (u, side, 0.0);
            }
        }
        let on_side = |(u, side, _): Crossing| {
            let at =
                if side % 2 == 0 { (m.x + u * d.x).clamp(low.x, high.x) } else { (m.y + u * d.y).clamp(low.y, high.y) };
            (u, side, at)
        };
        (entry.0 < exit.0).then(|| (on_side(entry), on_side(exit)))
    }
}

struct Centres {
    /// For each triangle, a common representative of all triangles whose centres are the same vertex.
    same: Vec<u32>,
    centres: Vec<Point>,
}

impl Centres {
    fn new(triangulation: &Triangulation, shortest: f64) -> Self {
        let mut centres = vec![Point::default(); triangulation.num_all_faces()];
        for face in triangulation.inner_faces() {
            centres[face.index()] = centre(face.vertices().map(|v| v.data().point()));
        }
        let mut same: Vec<u32> = (0..triangulation.num_all_faces() as u32).collect();
        let root = |same: &mut Vec<u32>, mut i: u32| {
            while same[i as usize] != i {
                let above = same[same[i as usize] as usize];
                same[i as usize] = above;
                i = above;
            }
            i
        };
        for e in triangulation.undirected_edges() {
            let e = e.as_directed();
            let (Some(left), Some(right)) = (e.face().as_inner(), e.rev().face().as_inner()) else { continue };
            let one_circle = || {
                let apex = e.rev().opposite_vertex().map(|v| v.data().point());
                let triangle = left.vertices().map(|v| v.data().point());
                apex.is_some_and(|d| on_one_circle(triangle, d))
            };
            let (p, q) = (centres[left.index()], centres[right.index()]);
            if (p.x - q.x).hypot(p.y - q.y) <= shortest || one_circle() {
                let (a, b) = (root(&mut same, left.index() as u32), root(&mut same, right.index() as u32));
                same[a as usize] = b;
            }
        }
        for i in 0..same.len() as u32 {
            same[i as usize] = root(&mut same, i);
        }
        Self { same, centres }
    }

    /// Returns the representative triangle of the same vertex, and its centre; `None` for the outer face.
    fn of(&self, face: FaceHandle<'_, PossiblyOuterTag, Site, (), (), ()>) -> Option<(usize, Point)> {
        let same = self.same[face.as_inner()?.index()] as usize;
        Some((same, self.centres[same]))
    }
}
