//! Making a failing program small.

use super::script::{Language, Script};
use alloc::vec::Vec;
use core::ops::Range;

/// Makes a program smaller for as long as it fails: drops ever smaller runs of operators, then simplifies the operators
/// that remain. The result fails too (if `program` does), and no longer if any one operator is dropped or simplified.
///
/// Zeller and Hildebrandt's delta debugging (*Simplifying and Isolating Failure-Inducing Input*, 2002), with one
/// addition: what remains goes on choosing the same half-edges and vertices, although the lists in which they are
/// counted have changed. Every step makes the program smaller, so it ends.
///
/// A program for a structure that is not empty at the start, such as a mesh, is made small by [`Generator::shrink`](crate::program::Generator::shrink), and by
/// [`Conformance::run_and_shrink`](crate::program::conformance::Conformance::run_and_shrink).
pub fn shrink<P: Language>(program: &P, fails: impl FnMut(&P) -> bool) -> P {
    shrink_from(program, &P::Start::default(), fails)
}

/// The same for programs that begin with this structure.
pub(in crate::program) fn shrink_from<P: Language>(
    program: &P,
    start: &P::Start,
    mut fails: impl FnMut(&P) -> bool,
) -> P {
    let mut smallest = program.clone();
    while let Some(smaller) = candidates_from(&smallest, start).find(&mut fails) {
        smallest = smaller;
    }
    smallest
}

/// Programs that are a little smaller than this one, the smallest first.
///
/// This is what `quickcheck` and `proptest` are given to shrink with; [`shrink`] repeats it as often as it helps. Each takes a run
/// of the program to find, on a [`PointerModel`](crate::program::PointerModel) or, for edits, a planar map.
pub fn candidates<P: Language>(program: &P) -> impl Iterator<Item = P> + use<P> {
    candidates_from(program, &P::Start::default())
}

/// The same for programs that begin with this structure.
pub(super) fn candidates_from<P: Language>(program: &P, start: &P::Start) -> impl Iterator<Item = P> + use<P> {
    let script: Script<P> = Script::of(program, start);
    let ops = program.ops().to_vec();
    let count = ops.len();
    let lengths = core::iter::successors(Some(count), |length| (*length > 1).then(|| length.div_ceil(2)));
    let lengths = lengths.filter(|length| *length > 0);
    let dropped = lengths.flat_map(move |length| {
        (0..count).step_by(length).map(move |begin| Edit::Drop(begin..(begin + length).min(count)))
    });
    let simpler = |(place, op): (usize, &P::Op)| P::simpler(op).into_iter().map(move |op| Edit::Replace(place, op));
    let simpler: Vec<Edit<P::Op>> = ops.iter().enumerate().flat_map(simpler).collect();
    // Counted anew, numbers beyond the ends of their lists come down at once.
    let anew = Some(script.without(&(0..0))).filter(|anew| anew != program);
    let edited = dropped.chain(simpler).flat_map(move |edit| {
        // To a subject that does less than `Dcel`, the same numbers may mean the same more often than the same names.
        let mut plain = ops.clone();
        let followed = match edit {
            Edit::Drop(places) => {
                plain.drain(places.clone());
                script.without(&places)
            }
            Edit::Replace(place, op) => {
                plain[place] = op.clone();
                script.with(place, &op)
            }
        };
        let plain = Some(P::from_ops(plain)).filter(|plain| *plain != followed);
        core::iter::once(followed).chain(plain)
    });
    anew.into_iter().chain(edited)
}

/// One way to make a program smaller.
enum Edit<O> {
    Drop(Range<usize>),
    Replace(usize, O),
}
