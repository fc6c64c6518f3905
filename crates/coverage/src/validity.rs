//! C6 OGC validity: the polygons of each feature are valid by the rules of the OGC.
//!
//! ```text
//!   ┌─────┐      ┌──┐       ┌───────┐  ┌─┐   ┌─────────┐   ┌─────────┐   ┌────○────┐
//!   └───┐ │      └┐ │       │       │  └─┘   │ ┌─────┐ │   │ ┌─────┐ │   │   / \   │
//!    ┌──┼─┘     ┌─○─┘       │       │        │ │ ┌─┐ │ │   │ │     │ │   │  ○   ○  │
//!    └──┘       └──┘        └───────┘        │ └─┴─┴─┘ │   │ └─────┘ │   │   \ /   │
//!                                            └─────────┘   └─────────┘   └────○────┘
//!   Self-       Ring Self-  Hole lies        Holes are     Nested        Interior is
//!   intersection intersection outside shell  nested        shells        disconnected
//! ```
//!
//! The terms follow the JTS Topology Suite and descendants (GEOS, PostGIS, shapely, QGIS). Exact predicates make all decisions.
//!
//! All polygons of a feature are taken as one multi-polygon. An open ring is a defect, and counts as closed for the other kinds.
//! Consecutive repeated points count once; the builder of a map reports them.
//!
//! Source: "Simple feature access, part 1: common architecture" (OGC 06-103r4), sections 6.1.11 and 6.1.14.

use super::apart;
use super::rings::{Contact, Meet, Ring, Rings, with_index};
use core::fmt;
use rustc_hash::{FxHashMap, FxHashSet};
use twinedge_geometry::Point;
use twinedge_map::Shape;

/// A reason why the polygons of a feature are invalid.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum DefectKind {
    /// A ring with fewer than three consecutive different points, or a line with fewer than two.
    TooFewPoints,
    /// The last point of a ring does not repeat the first.
    OpenRing,
    /// Rings cross or overlap.
    SelfIntersection,
    /// A ring visits a point twice, without crossing itself.
    RingSelfIntersection,
    /// A hole lies outside the outer ring of its polygon.
    HoleOutsideShell,
    /// A hole lies inside another one of its polygon.
    NestedHoles,
    /// Rings touch so often that the inside of the polygon is disconnected.
    DisconnectedInterior,
    /// A polygon lies inside another one of the feature.
    NestedShells,
}

impl fmt::Display for DefectKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::TooFewPoints => "Too few points in geometry component",
            Self::OpenRing => "Ring is not closed",
            Self::SelfIntersection => "Self-intersection",
            Self::RingSelfIntersection => "Ring Self-intersection",
            Self::HoleOutsideShell => "Hole lies outside shell",
            Self::NestedHoles => "Holes are nested",
            Self::DisconnectedInterior => "Interior is disconnected",
            Self::NestedShells => "Nested shells",
        })
    }
}

/// A defect of the polygons of a feature.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Defect {
    /// The kind.
    pub kind: DefectKind,
    /// The location: rounded for crossing rings, the last point of an open ring.
    pub at: Point,
    /// The first point of an open ring, where the gap ends; `None` for the other kinds.
    pub gap_to: Option<Point>,
    /// The shape.
    pub shape: usize,
    /// The ring in the shape.
    pub ring: usize,
}

/// Returns all defects of the shapes of a feature, each location once, in order of their kinds. Rings that cross or touch
/// themselves have no inside, so nesting is checked only if there are none.
///
/// O(n log n + p + r · k) for n points, p pairs of overlapping boxes, and r rings with k segments each at the height of a point.
///
/// ```
/// use twinedge_coverage::{DefectKind, defects};
/// use twinedge_map::Shape;
///
/// let square = |low: f64, high: f64| [[low, low], [high, low], [high, high], [low, high]];
/// let found = defects(&[Shape::polygon(square(0.0, 4.0)).hole(square(5.0, 6.0))]);
/// assert_eq!((found[0].kind, found[0].ring), (DefectKind::HoleOutsideShell, 1));
/// assert_eq!(found[0].kind.to_string(), "Hole lies outside shell");
/// assert!(defects(&[Shape::polygon(square(0.0, 4.0)).hole(square(1.0, 2.0))]).is_empty());
/// ```
#[must_use]
pub fn defects(shapes: &[Shape]) -> Vec<Defect> {
    let (mut found, rings) = rings_of(shapes);
    let are_whole = found.iter().all(|defect| defect.kind == DefectKind::OpenRing);
    match apart::containers(&rings) {
        Some(containers) => found.extend(nesting(&rings, &containers)),
        None => found.extend(with_index(&rings, |index| of_meeting(&rings, index, are_whole))),
    }
    found.sort_by_key(|defect| (defect.kind, defect.shape, defect.ring));
    found
}

/// Returns the rings that enclose something, and the defects of individual rings and lines.
pub(super) fn rings_of(shapes: &[Shape]) -> (Vec<Defect>, Vec<Ring>) {
    let (mut found, mut rings) = (Vec::new(), Vec::new());
    for (polygon, shape) in shapes.iter().enumerate() {
        let mut note = |kind, ring, [at, to]: [Option<Point>; 2]| {
            found.extend(at.map(|at| Defect { kind, at, gap_to: to, shape: polygon, ring }));
        };
        match shape {
            Shape::Polygon(all) => {
                for (number, points) in all.iter().enumerate() {
                    let distinct = without_repetition(points);
                    if distinct.len() < 3 {
                        note(DefectKind::TooFewPoints, number, [points.first().copied(), None]);
                        continue;
                    }
                    if let Some(ends) = gap(points) {
                        note(DefectKind::OpenRing, number, ends.map(Some));
                    }
                    rings.push(Ring { points: distinct, polygon, number });
                }
            }
            Shape::Line(points) if without_repetition(points).len() < 2 => {
                note(DefectKind::TooFewPoints, 0, [points.first().copied(), None]);
            }
            Shape::Line(_) | Shape::Point(_) => {}
        }
    }
    (found, rings)
}

/// Returns the last and the first point of an open ring.
fn gap(ring: &[Point]) -> Option<[Point; 2]> {
    Some([*ring.last()?, *ring.first()?]).filter(|[last, first]| last != first)
}

/// Returns the defects of rings if some of them meet.
fn of_meeting(rings: &[Ring], index: &Rings<'_>, are_whole: bool) -> Vec<Defect> {
    let meets = index.meets();
    let is_touch = |meet: &Meet| meet.contact == Contact::Touch;
    let mut found: Vec<Defect> =
        meets.iter().filter(|meet| !is_touch(meet)).map(|meet| intersection(rings, meet)).collect();
    if meets.iter().all(is_touch) {
        found.extend(nesting(rings, &index.containers()));
        if are_whole && found.is_empty() {
            found.extend(disconnected(rings, &meets));
        }
    }
    found
}

/// Returns the points of a ring or line, without consecutive repetitions, and for a ring without a last point equal to the first.
fn without_repetition(points: &[Point]) -> Vec<Point> {
    let mut distinct: Vec<Point> = points.to_vec();
    distinct.dedup();
    while distinct.len() > 1 && distinct.first() == distinct.last() {
        distinct.pop();
    }
    distinct
}

fn defect(rings: &[Ring], kind: DefectKind, ring: usize, at: Point) -> Defect {
    let Ring { polygon, number, .. } = rings[ring];
    Defect { kind, at, gap_to: None, shape: polygon, ring: number }
}

fn intersection(rings: &[Ring], meet: &Meet) -> Defect {
    let kind = match meet.contact {
        Contact::SelfTouch => DefectKind::RingSelfIntersection,
        Contact::Crossing | Contact::Touch => DefectKind::SelfIntersection,
    };
    defect(rings, kind, meet.rings[0], meet.at)
}

/// Finds the misplaced rings among rings that do not cross.
fn nesting(rings: &[Ring], containers: &[Vec<usize>]) -> Vec<Defect> {
    let mut found = Vec::new();
    let shells: FxHashSet<usize> = rings.iter().filter(|c| c.number == 0).map(|c| c.polygon).collect();
    for (r, containers) in containers.iter().enumerate() {
        let ring = &rings[r];
        let within = |polygon: usize, is_shell: bool| {
            containers.iter().map(|c| &rings[*c]).any(|c| c.polygon == polygon && (c.number == 0) == is_shell)
        };
        let kind = if ring.number > 0 {
            if shells.contains(&ring.polygon) && !within(ring.polygon, true) {
                DefectKind::HoleOutsideShell
            } else if within(ring.polygon, false) {
                DefectKind::NestedHoles
            } else {
                continue;
            }
        } else {
            let is_nested = |c: &usize| {
                let c = &rings[*c];
                c.number == 0 && c.polygon != ring.polygon && !within(c.polygon, false)
            };
            if !containers.iter().any(is_nested) {
                continue;
            }
            DefectKind::NestedShells
        };
        found.push(defect(rings, kind, r, ring.points[0]));
    }
    found
}

/// Finds polygons whose inside is disconnected: rings and their touching points, joined to each other, form a cycle. Each such
/// polygon is reported where its first cycle closes.
fn disconnected(rings: &[Ring], meets: &[Meet]) -> Vec<Defect> {
    // Rings first, then points of a polygon.
    let mut parent: Vec<usize> = (0..rings.len()).collect();
    let mut points: FxHashMap<((u64, u64), usize), usize> = FxHashMap::default();
    let mut joined: FxHashSet<(usize, usize)> = FxHashSet::default();
    let mut reported = FxHashSet::default();
    let mut found = Vec::new();
    for meet in meets {
        let polygon = rings[meet.rings[0]].polygon;
        if polygon != rings[meet.rings[1]].polygon {
            continue;
        }
        let point = *points.entry((meet.at.hash_key(), polygon)).or_insert_with(|| {
            parent.push(parent.len());
            parent.len() - 1
        });
        for ring in meet.rings {
            if !joined.insert((ring, point)) {
                continue;
            }
            let (one, other) = (root(&mut parent, ring), root(&mut parent, point));
            if one != other {
                parent[one] = other;
            } else if reported.insert(polygon) {
                found.push(defect(rings, DefectKind::DisconnectedInterior, ring, meet.at));
            }
        }
    }
    found
}

fn root(parent: &mut [usize], mut of: usize) -> usize {
    while parent[of] != of {
        parent[of] = parent[parent[of]];
        of = parent[of];
    }
    of
}
