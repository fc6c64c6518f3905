//! Shrinks a program while keeping its finding.

use crate::program::{Operator, Program};

/// Drops steps and lowers arguments as long as `keeps` returns true.
///
/// # Errors
/// If `keeps` fails.
pub fn shrink<E>(
    program: &Program,
    operators: &[Operator],
    mut keeps: impl FnMut(&Program) -> Result<bool, E>,
) -> Result<Program, E> {
    let mut best = program.clone();
    loop {
        let mut better = None;
        let candidates = fewer_steps(&best).chain(lower_arguments(&best)).chain(fewer_records(&best, operators));
        for candidate in candidates {
            if keeps(&candidate)? {
                better = Some(candidate);
                break;
            }
        }
        match better {
            Some(better) => best = better,
            None => return Ok(best),
        }
    }
}

/// The program without one of its halves, quarters, …, single steps.
fn fewer_steps(program: &Program) -> impl Iterator<Item = Program> + '_ {
    let n = program.0.len();
    let widths = std::iter::successors(Some(n.div_ceil(2)), |width| (*width > 1).then(|| width / 2));
    widths.flat_map(move |width| {
        (0..n).step_by(width).map(move |from| {
            let mut steps = program.0.clone();
            steps.drain(from..(from + width).min(n));
            Program(steps)
        })
    })
}

/// The program with one argument lowered, to each value below.
fn lower_arguments(program: &Program) -> impl Iterator<Item = Program> + '_ {
    let places = (0..program.0.len()).flat_map(|step| (0..program.0[step].arguments.len()).map(move |a| (step, a)));
    places.flat_map(move |(step, argument)| {
        (0..program.0[step].arguments[argument]).map(move |lower| {
            let mut candidate = program.clone();
            candidate.0[step].arguments[argument] = lower;
            candidate
        })
    })
}

/// The program without one step and the record that it made: the places of later steps, from some place on, move down
/// by one.
fn fewer_records<'a>(program: &'a Program, operators: &'a [Operator]) -> impl Iterator<Item = Program> + 'a {
    let highest = program.0.iter().flat_map(|step| step.arguments.iter().copied()).max().unwrap_or(0);
    (0..program.0.len()).flat_map(move |dropped| {
        (1..=highest).map(move |from| {
            let mut steps = program.0.clone();
            steps.remove(dropped);
            for step in steps[dropped..].iter_mut().filter(|step| operators[step.operator].places) {
                step.arguments.iter_mut().filter(|place| **place >= from).for_each(|place| *place -= 1);
            }
            Program(steps)
        })
    })
}
