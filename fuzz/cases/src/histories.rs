//! The target that undoes and redoes.

#[path = "../../../crates/map/tests/map/rewound.rs"]
mod rewound;

use twinedge::program::Program;
use twinedge::program::conformance::{Conformance, Coverage};
use twinedge::validate::Expectation;
use twinedge_map::PlanarMap;
use twinedge_map::program::EditProgram;
use twinedge_trials::Rewound;

/// Longer programs are cut off.
const LONGEST: usize = 60;

/// Runs a program of operators or, if the first byte is odd, of edits, each as a change. After each, some changes are
/// undone and redone, in step with kept copies. The written records are valid, and a failed change leaves nothing
/// behind.
///
/// # Panics
/// If the structure differs from its copies, or is not valid.
pub fn history(bytes: &[u8]) {
    let Some((first, bytes)) = bytes.split_first() else { return };
    if first % 2 == 0 {
        let mut program = Program::from_bytes(bytes);
        program.0.truncate(LONGEST);
        let asked = Conformance::of(&Expectation::plane()).coverage(Coverage::Nothing);
        if let Err(failure) = asked.run(&program, Rewound::default()) {
            panic!("{failure}\n{program}");
        }
    } else {
        let mut program = EditProgram::from_bytes(bytes);
        program.0.truncate(LONGEST);
        let mut rewound = rewound::Rewound::new(PlanarMap::new());
        for op in &program.0 {
            rewound.step(op, |_| {});
        }
    }
}
