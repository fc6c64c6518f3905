//! G5: each inner boundary component lies in the face that lists it. See [why it is not
//! located](twinedge::validate::near#what-lies-where).

use super::chain::{Beside, Chain, SummedChain};
use super::drawing::{Drawing, sorted};
use super::tree::DrawnTrees;
use crate::numbers::NIL;
use rustc_hash::FxHashMap;
use twinedge::validate::Start;
use twinedge::validate::near::changes::{Row, TIMES, Time, index};
use twinedge_geometry::Point;
use twinedge_geometry::predicates::compare_lexicographic;

/// The moves of boundary components between faces, sorted.
struct Moves {
    /// For each component that left a face: that face, and the component's new face, or `None` if the component was dropped.
    went: Vec<(usize, Option<usize>)>,
    /// For each face, the faces that now have some of its components, possibly itself; and the reverse.
    targets: Vec<(usize, usize)>,
    sources: Vec<(usize, usize)>,
}

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

    /// Returns true if all surviving boundary components of a face now belong to one other face, or all still to their own.
    fn is_whole(&self, drawing: &Drawing<'_>, from: usize, to: usize) -> bool {
        let went = of(&self.went, from);
        let number = |to: Option<usize>| {
            let rest = &went[went.partition_point(|(_, now)| *now < to)..];
            rest.partition_point(|(_, now)| *now == to)
        };
        number(None) + number(Some(to)) == went.len() && (from == to || went.len() == count(drawing, from))
    }
}

/// Returns the number of boundary components that a face had before.
fn count(drawing: &Drawing<'_>, f: usize) -> usize {
    let face = drawing.face(Time::Before, f);
    face.inner as usize + usize::from(face.is_live() && face.outer != NIL)
}

/// Evidence of an inner boundary component's location: an unchanged point next to it with its old face, or its smallest point.
enum Knowledge {
    Kept(Beside, usize),
    New(Point),
}

/// Checks G5. Returns `None` if G5 is broken or the changes do not determine it.
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
                // The region above an edge is to the left of the half-edge that runs to the right.
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

/// Returns the change of each face's boundary: the new half-edges minus the old ones and components dropped by its sources.
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
    /// Finds the evidence for the boundary component that starts here.
    fn known(&self, start: Start) -> Option<Knowledge> {
        let drawing = self.drawing;
        let first = match start {
            Start::HalfEdge(h) => h,
            Start::Vertex(v) => return self.known_vertex(v),
        };
        let mut lowest = drawing.line(Time::After, first)?.points[0];
        let mut h = first;
        // All changed half-edges of the component are in `half_edges`.
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

    /// Finds the evidence for an isolated vertex.
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

    /// Returns how often the boundary of a face went around a point of a face (the same or another), before the changes in
    /// `chains`. Returns `None` if this is undetermined.
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

    /// Returns the required winding number of a face's boundary around a point inside the face.
    fn required(&self, f: usize) -> i64 {
        i64::from(!self.drawing.is_unbounded(Time::After, f))
    }

    /// Returns true if a point that was in the face `was_in` is now in the face `f`.
    fn lies_in(&self, f: usize, beside: Beside, was_in: usize) -> Option<bool> {
        let changed = self.chains.get(&f).map_or(0, |chain| chain.around(beside));
        Some(self.around_before(f, was_in)? + changed == self.required(f))
    }

    /// Checks the unchanged inner boundary components of a face.
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
