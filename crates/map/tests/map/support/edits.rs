//! Random programs of edits on whole numbers, for tests of their outcome.

use quickcheck::{Arbitrary, Gen};
use twinedge::program::candidates;
use twinedge_geometry::Point;
use twinedge_map::PlanarMap;
use twinedge_map::program::{AtPick, EditKind, EditOp, EditProgram, EditRunner, FeaturesPick, GridPick, Spot};

/// Vertices have even coordinates from 0 to this.
pub(crate) const SIDE: u8 = 14;

/// A position with whole coordinates.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Place(u8, u8);

impl Place {
    pub(crate) fn point(self) -> Point {
        Point::new(self.0.into(), self.1.into())
    }
}

impl Arbitrary for Place {
    fn arbitrary(g: &mut Gen) -> Self {
        let mut along = || u8::arbitrary(g) % (SIDE + 1);
        Self(along(), along())
    }
}

/// A program that makes only vertices with even coordinates from 0 to [`SIDE`].
#[derive(Clone, Debug)]
pub(crate) struct EvenEdits(pub(crate) EditProgram);

impl Arbitrary for EvenEdits {
    fn arbitrary(g: &mut Gen) -> Self {
        let generator = EditProgram::generator()
            .weight(EditKind::AddFeature, 0)
            .weight(EditKind::InsertRing, 10)
            .weight(EditKind::SetFeaturesOf, 6);
        let mut program = generator.length(0..=g.size()).generate(g);
        for op in &mut program.0 {
            match op {
                EditOp::InsertSegmentSnapped { snap, .. } => *snap = GridPick::Size(2.0.into()),
                EditOp::SetFeaturesOf { features, .. } | EditOp::SetFeaturesAlong { features, .. } => {
                    *features = FeaturesPick(u8::arbitrary(g).into());
                }
                _ => {}
            }
            // Snapping makes coordinates even.
            let mask = if matches!(op, EditOp::InsertSegmentSnapped { .. }) { !0 } else { !1 };
            for spot in spots(op) {
                let Place(x, y) = Place::arbitrary(g);
                *spot = Spot::new((x & mask).into(), (y & mask).into());
            }
        }
        Self(program)
    }

    fn shrink(&self) -> Box<dyn Iterator<Item = Self>> {
        Box::new(candidates(&self.0).map(Self).filter(|smaller| smaller.clone().takes_even()))
    }
}

impl EvenEdits {
    fn takes_even(mut self) -> bool {
        self.0.0.iter_mut().all(|op| {
            let step = match op {
                EditOp::InsertSegmentSnapped { snap, .. } if *snap != GridPick::Size(2.0.into()) => return false,
                EditOp::InsertSegmentSnapped { .. } => 1.0,
                _ => 2.0,
            };
            spots(op).into_iter().all(|spot| [spot.x, spot.y].iter().all(|c| c.get() % step == 0.0))
        })
    }
}

/// The points given to an edit.
fn spots(op: &mut EditOp) -> Vec<&mut Spot> {
    let at: Vec<&mut AtPick> = match op {
        EditOp::InsertPoint { at } => vec![at],
        EditOp::InsertSegment { from, to } | EditOp::InsertSegmentSnapped { from, to, .. } => vec![from, to],
        EditOp::InsertRing { points } => points.0.iter_mut().collect(),
        EditOp::MoveVertex { to, .. } => return vec![to],
        _ => Vec::new(),
    };
    at.into_iter()
        .filter_map(|at| match at {
            AtPick::Point(spot) | AtPick::Near(spot, _) => Some(spot),
            AtPick::Vertex(_) => None,
        })
        .collect()
}

/// The map that a program makes from the empty map, with `features` features initially unassigned.
pub(crate) fn edited(program: &EvenEdits, features: usize) -> PlanarMap {
    let mut map = PlanarMap::new();
    for i in 0..features {
        map.add_feature(Some(format!("feature {i}")));
    }
    let mut runner = EditRunner::new(map);
    for op in &program.0.0 {
        let mut op = op.clone();
        if let EditOp::SetFeaturesOf { features: set, .. } | EditOp::SetFeaturesAlong { features: set, .. } = &mut op {
            set.0 &= (1 << features) - 1;
        }
        runner.step(&op);
    }
    runner.into_map()
}
