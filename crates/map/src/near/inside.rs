//! G5: each inner boundary component lies in the face that lists it. See [why it need not be located](twinedge::validate::near#what-lies-where).

use super::chain::{Beside, Chain, SummedChain};
use super::drawing::{Drawing, sorted};
use super::tree::DrawnTrees;
use crate::numbers::NIL;
use rustc_hash::FxHashMap;
use twinedge::validate::Start;
use twinedge::validate::near::changes::{Row, TIMES, Time, index};
use twinedge_geometry::Point;
use twinedge_geometry::predicates::compare_lexicographic;

/// The ways that the boundary components of the faces went, sorted.
struct Moves {
    /// For each that a face has no more, that face, and its face now, or none where it is no more.
    went: Vec<(usize, Option<usize>)>,
    /// For each face those that have some of what it had, itself included; and the other way round.
    targets: Vec<(usize, usize)>,
    sources: Vec<(usize, usize)>,
}

/// The pairs that begin with a face.
fn of<T>(pairs: &[(usize, T)], f: usize) -> &[(usize, T)] {
    let rest = &pairs[pairs.partition_point(|(face, _)| *face < f)..];
    &rest[..rest.partition_point(|(face, _)| *face == f)]
}

impl Moves {
    fn new(drawing: &Drawing<'_>, faces: &[usize]) -> Self {
        let face = |time: Time, b| index(drawing.label(time, b).face);
        let pairs = drawing.changed_labels().filter_map(|b| Some((face(Time::Before, b)?, face(Time::After, b))));
        let mut went: Vec<_> = pairs.filter(|(from, to)| *to != Some(*from)).collect();
        went.sort_unstable();
        let stays = faces.iter().filter(|f| count(drawing, **f) > of(&went, **f).len()).map(|f| (*f, *f));
        let targets = sorted(went.iter().filter_map(|(from, to)| Some((*from, (*to)?))).chain(stays).collect());
        let sources = sorted(targets.iter().map(|(from, to)| (*to, *from)).collect());
        Self { went, targets, sources }
    }

    /// Returns true if all boundary components of a face that are left are now of another one, or still its own.
    fn is_whole(&self, drawing: &Drawing<'_>, from: usize, to: usize) -> bool {
        let went = of(&self.went, from);
        let number = |to: Option<usize>| {
            let rest = &went[went.partition_point(|(_, now)| *now < to)..];
            rest.partition_point(|(_, now)| *now == to)
        };
        number(None) + number(Some(to)) == went.len() && (from == to || went.len() == count(drawing, from))
    }
}

/// The number of boundary components that a face had.
fn count(drawing: &Drawing<'_>, f: usize) -> usize {
    let face = drawing.face(Time::Before, f);
    face.inner as usize + usize::from(face.is_live() && face.outer != NIL)
}

/// A place that tells where an inner boundary component lies: a place beside it that is as it was, with the face in which that was, or its
/// smallest point.
enum Knowledge {
    Kept(Beside, usize),
    New(Point),
}

/// G5. Nothing also where this cannot be told from what has changed.
pub(super) fn is_inside(drawing: &Drawing<'_>, trees: &DrawnTrees) -> Option<()> {
    let faces = |b: &usize| TIMES.map(|time| index(drawing.label(time, *b).face));
    let faces: Vec<usize> = sorted(drawing.labels.iter().flat_map(faces).flatten().collect());
    let moves = Moves::new(drawing, &faces);
    let chains = chains(drawing, &moves);
    let check = Check { drawing, trees, moves: &moves, chains: &chains };
    let mut affected: FxHashMap<usize, usize> = FxHashMap::default();
    for b in &drawing.labels {
        let label = drawing.label(Time::After, *b);
        let Some((f, _)) = label.inner() else { continue };
        *affected.entry(f).or_default() += 1;
        let lies_there = match check.known(label.start())? {
            Knowledge::Kept(beside, was_in) => check.lies_in(f, beside, was_in)?,
            Knowledge::New(lowest) => match trees.below(lowest) {
                // The region above an edge is to the left of the half-edge that leads to the right.
                Some((h, rises)) => {
                    let h = if rises { h } else { drawing.twin(Time::After, h)? };
                    drawing.face_of(Time::After, h) == Some(f)
                }
                None => drawing.is_unbounded(Time::After, f),
            },
        };
        lies_there.then_some(())?;
    }
    for f in faces {
        if drawing.face(Time::After, f).inner as usize > affected.get(&f).copied().unwrap_or(0) {
            check.others(f)?;
        }
    }
    Some(())
}

/// For each face what its boundary has become: what the half-edges of its boundary components are now, less what they were, and
/// less those that its sources have lost.
fn chains(drawing: &Drawing<'_>, moves: &Moves) -> FxHashMap<usize, SummedChain> {
    let mut chains: FxHashMap<usize, Chain> = FxHashMap::default();
    for h in &drawing.half_edges {
        for (time, weight) in [(Time::Before, -1), (Time::After, 1)] {
            let (Some(b), Some(line)) = (drawing.label_of(time, *h), drawing.line(time, *h)) else { continue };
            let [was, now] = TIMES.map(|time| index(drawing.label(time, b).face));
            let lost_by = was.filter(|_| now.is_none()).map_or(&[][..], |f| of(&moves.targets, f));
            for f in now.into_iter().chain(lost_by.iter().map(|(_, to)| *to)) {
                chains.entry(f).or_default().add(line.points, weight);
            }
        }
    }
    chains.into_iter().map(|(f, chain)| (f, chain.summed())).collect()
}

struct Check<'a> {
    drawing: &'a Drawing<'a>,
    trees: &'a DrawnTrees,
    moves: &'a Moves,
    chains: &'a FxHashMap<usize, SummedChain>,
}

impl Check<'_> {
    /// That place of the boundary component that starts here.
    fn known(&self, start: Start) -> Option<Knowledge> {
        let drawing = self.drawing;
        let first = match start {
            Start::HalfEdge(h) => h,
            Start::Vertex(v) => return self.known_vertex(v),
        };
        let mut lowest = drawing.line(Time::After, first)?.points[0];
        let mut h = first;
        // Those that are not as they were are among those that may differ.
        for _ in 0..=drawing.half_edges.len() {
            if let Some([at, towards]) = drawing.kept(h) {
                return Some(Knowledge::Kept(Beside { at, towards }, drawing.face_of(Time::Before, h)?));
            }
            let at = drawing.line(Time::After, h)?.points[0];
            if compare_lexicographic(at, lowest).is_lt() {
                lowest = at;
            }
            h = drawing.row(Time::After, h).next as usize;
            if h == first {
                return Some(Knowledge::New(lowest));
            }
        }
        None
    }

    /// The same of an isolated vertex.
    fn known_vertex(&self, v: usize) -> Option<Knowledge> {
        let drawing = self.drawing;
        let at = drawing.place(Time::After, v)?;
        if drawing.place(Time::Before, v) != Some(at) {
            return Some(Knowledge::New(at));
        }
        let was = drawing.vertex(Time::Before, v);
        if was.isolated != NIL {
            let label = drawing.label(Time::Before, was.isolated as usize);
            return Some(Knowledge::Kept(Beside::isolated(at), label.face as usize));
        }
        let h = was.leaving as usize;
        let towards = drawing.line(Time::Before, h)?.points[1];
        Some(Knowledge::Kept(Beside { at, towards }, drawing.face_of(Time::Before, h)?))
    }

    /// The number of times that the boundary of a face went around a place in another face, or the same, without what has changed. Nothing if
    /// that cannot be told.
    fn around_before(&self, f: usize, was_in: usize) -> Option<i64> {
        let mut around = 0;
        for &(_, from) in of(&self.moves.sources, f) {
            if from != was_in {
                self.moves.is_whole(self.drawing, from, f).then_some(())?;
                around -= i64::from(self.drawing.is_unbounded(Time::Before, from));
                continue;
            }
            let outer = self.drawing.face(Time::Before, from).outer;
            if outer != NIL {
                let now = self.drawing.label(Time::After, outer as usize);
                around += i64::from(!now.is_live() || now.face as usize == f);
            }
        }
        Some(around)
    }

    /// The number of times that the boundary of a face goes around a place inside it.
    fn required(&self, f: usize) -> i64 {
        i64::from(!self.drawing.is_unbounded(Time::After, f))
    }

    /// Returns true if a place that was in a face is now in another, or still in it.
    fn lies_in(&self, f: usize, beside: Beside, was_in: usize) -> Option<bool> {
        let changed = self.chains.get(&f).map_or(0, |chain| chain.around(beside));
        Some(self.around_before(f, was_in)? + changed == self.required(f))
    }

    /// The inner boundary components of a face that were there before, and of which nothing has changed.
    fn others(&self, f: usize) -> Option<()> {
        let drawing = self.drawing;
        (self.around_before(f, f)? == self.required(f)).then_some(())?;
        let Some((chain, envelope)) = self.chains.get(&f).and_then(|chain| Some((chain, chain.envelope()?))) else {
            return Some(());
        };
        for b in self.trees.starts_in(envelope) {
            let label = drawing.label(Time::After, b);
            let is_other =
                label.inner().is_some_and(|(face, _)| face == f) && drawing.labels.binary_search(&b).is_err();
            if !is_other {
                continue;
            }
            let beside = match label.start() {
                Start::HalfEdge(h) => {
                    let [at, towards] = drawing.kept(h)?;
                    Beside { at, towards }
                }
                Start::Vertex(v) => Beside::isolated(drawing.place(Time::After, v)?),
            };
            (chain.around(beside) == 0).then_some(())?;
        }
        Some(())
    }
}
