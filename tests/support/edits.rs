//! Random programs of edits on whole numbers, for tests that ask about their outcome.

use quickcheck::{Arbitrary, Gen};
use twinedge::dcel::{Face, HalfEdge, Vertex};
use twinedge::geometry::Point;
use twinedge::geometry::noding::Snap;
use twinedge::map::{FeatureId, PlanarMap};

/// Vertices have even coordinates from 0 to this.
pub(crate) const SIDE: u8 = 14;

/// A place with whole coordinates.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Spot(pub(crate) i32, pub(crate) i32);

impl Spot {
    pub(crate) fn point(self) -> Point {
        Point::new(self.0.into(), self.1.into())
    }

    /// A place for a vertex.
    fn even(self) -> Point {
        Self(self.0 & !1, self.1 & !1).point()
    }
}

impl Arbitrary for Spot {
    fn arbitrary(g: &mut Gen) -> Self {
        let mut along = || i32::from(u8::arbitrary(g) % (SIDE + 1));
        Self(along(), along())
    }
}

#[derive(Clone, Debug)]
pub(crate) enum Edit {
    Point(Spot),
    Segment(Spot, Spot),
    Snapped(Spot, Spot),
    Ring(Vec<Spot>),
    RemoveEdge(u8),
    RemoveVertex(u8),
    MoveVertex(u8, Spot),
    /// Some face is covered by these of the features there are, one bit each.
    Claim(u8, u8),
    /// The same along some edge.
    Along(u8, u8),
}

impl Arbitrary for Edit {
    fn arbitrary(g: &mut Gen) -> Self {
        let spot = Spot::arbitrary;
        let byte = u8::arbitrary;
        match byte(g) % 16 {
            0 => Self::Point(spot(g)),
            1..4 => Self::Segment(spot(g), spot(g)),
            4..7 => Self::Snapped(spot(g), spot(g)),
            7..10 => Self::Ring((0..3 + byte(g) % 3).map(|_| spot(g)).collect()),
            10 => Self::RemoveEdge(byte(g)),
            11 => Self::RemoveVertex(byte(g)),
            12 => Self::MoveVertex(byte(g), spot(g)),
            13..15 => Self::Claim(byte(g), byte(g)),
            _ => Self::Along(byte(g), byte(g)),
        }
    }
}

fn choose<T>(all: impl Iterator<Item = T>, which: u8) -> Option<T> {
    let mut all: Vec<T> = all.collect();
    let place = usize::from(which).checked_rem(all.len())?;
    Some(all.swap_remove(place))
}

/// Does an edit, unless there is nothing to do it to. Some are refused, which `tests/edit` looks after.
pub(crate) fn apply(map: &mut PlanarMap, edit: &Edit) {
    let some_vertex = |map: &PlanarMap, which| choose(map.dcel().vertices().map(Vertex::key), which);
    let some_edge = |map: &PlanarMap, which| choose(map.dcel().edges().map(HalfEdge::key), which);
    let bits = |map: &PlanarMap, set: u8| -> Vec<FeatureId> {
        map.features().filter(|f| set & 1 << (f.index() % 8) != 0).collect()
    };
    let nothing_to_do = || Ok(());
    let _outcome = match edit {
        Edit::Point(p) => map.insert_point(p.even()).map(drop),
        Edit::Segment(a, b) => map.insert_segment(a.even(), b.even()).map(drop),
        Edit::Snapped(a, b) => map.insert_segment_snapped(a.point(), b.point(), Snap::Size(2.0)).map(drop),
        Edit::Ring(spots) => map.insert_ring(spots.iter().map(|p| p.even())).map(drop),
        Edit::RemoveEdge(which) => some_edge(map, *which).map_or_else(nothing_to_do, |h| map.remove_edge(h).map(drop)),
        Edit::RemoveVertex(which) => {
            some_vertex(map, *which).map_or_else(nothing_to_do, |v| map.remove_vertex(v).map(drop))
        }
        Edit::MoveVertex(which, to) => {
            some_vertex(map, *which).map_or_else(nothing_to_do, |v| map.move_vertex(v, to.even()))
        }
        Edit::Claim(which, set) => {
            let set = bits(map, *set);
            choose(map.dcel().faces().map(Face::key), *which)
                .map_or_else(nothing_to_do, |f| map.set_features_of(f, set))
        }
        Edit::Along(which, set) => {
            let set = bits(map, *set);
            some_edge(map, *which).map_or_else(nothing_to_do, |h| map.set_features_along(h, set))
        }
    };
}

/// The map that a program makes of the empty one, with features that nobody has claimed at first.
#[allow(dead_code, reason = "some tests ask between two edits")]
pub(crate) fn edited(program: &[Edit], features: usize) -> PlanarMap {
    let mut map = PlanarMap::new();
    for i in 0..features {
        map.add_feature(Some(format!("feature {i}")));
    }
    for edit in program {
        apply(&mut map, edit);
    }
    map
}
