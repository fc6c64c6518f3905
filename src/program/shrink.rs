//! Making a failing program small.

use super::op::{Op, Program};
use super::retarget::Script;
use alloc::vec::Vec;
use core::ops::Range;

/// Makes a program smaller for as long as it fails: drops ever smaller runs of operators, then simplifies the operators
/// that remain. The result fails too (if `program` does), and no longer if any one operator is dropped or simplified.
///
/// Zeller and Hildebrandt's delta debugging (*Simplifying and Isolating Failure-Inducing Input*, 2002), with one
/// addition: what remains goes on choosing the same half-edges and vertices, although the lists in which they are
/// counted have changed. Every step makes the program smaller, so it ends.
pub fn shrink(program: &Program, mut fails: impl FnMut(&Program) -> bool) -> Program {
    let mut smallest = program.clone();
    while let Some(smaller) = candidates(&smallest).find(&mut fails) {
        smallest = smaller;
    }
    smallest
}

/// Programs that are a little smaller than this one, the smallest first.
///
/// This is what `quickcheck` is given to shrink with; [`shrink`] repeats it as often as it helps. Each takes a run of
/// the program on a [`Dcel`](crate::dcel::Dcel) to find.
pub fn candidates(program: &Program) -> impl Iterator<Item = Program> + use<> {
    let script = Script::of(program);
    let count = program.0.len();
    let lengths = core::iter::successors(Some(count), |length| (*length > 1).then(|| length.div_ceil(2)));
    let lengths = lengths.filter(|length| *length > 0);
    let dropped = lengths.flat_map(move |length| {
        (0..count).step_by(length).map(move |begin| Edit::Drop(begin..(begin + length).min(count)))
    });
    let simpler = |(place, op): (usize, &Op)| op.simpler().into_iter().map(move |op| Edit::Replace(place, op));
    let simpler: Vec<Edit> = program.0.iter().enumerate().flat_map(simpler).collect();
    // Counted anew, numbers beyond the ends of their lists come down at once.
    let anew = Some(script.without(&(0..0))).filter(|anew| anew != program);
    let program = program.clone();
    let edited = dropped.chain(simpler).flat_map(move |edit| {
        // To a subject that does less than `Dcel`, the same numbers may mean the same more often than the same names.
        let (followed, plain) = match edit {
            Edit::Drop(places) => {
                let plain = program.0[..places.start].iter().chain(&program.0[places.end..]).copied().collect();
                (script.without(&places), plain)
            }
            Edit::Replace(place, op) => {
                let mut plain = program.clone();
                plain.0[place] = op;
                (script.with(place, op), plain)
            }
        };
        let plain = Some(plain).filter(|plain| *plain != followed);
        core::iter::once(followed).chain(plain)
    });
    anew.into_iter().chain(edited)
}

/// One way to make a program smaller.
enum Edit {
    Drop(Range<usize>),
    Replace(usize, Op),
}
