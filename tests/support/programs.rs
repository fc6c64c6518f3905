//! Programs for laws, always the same ones.

use quickcheck::{Gen, QuickCheck, Testable};
use twinedge::dcel::Dcel;
use twinedge::program::choose::{Choose, Random};
use twinedge::program::{Program, Runner};

/// Tests a law on `tests` random arguments of up to `size` operators or entries.
pub(crate) fn check(tests: u64, size: usize, law: impl Testable) {
    QuickCheck::new().rng(Gen::from_size_and_seed(size, 2026)).tests(tests).quickcheck(law);
}

/// The structure that a program builds.
pub(crate) fn built(program: &Program) -> Dcel {
    let mut runner = Runner::new(Dcel::new());
    runner.run(program);
    runner.into_subject()
}

/// The program with these lines.
pub(crate) fn program(lines: &str) -> Program {
    format!("twinedge program 1\n{lines}").parse().unwrap()
}

/// Pseudorandom bytes.
pub(crate) fn noise(seed: u64) -> impl Iterator<Item = u8> {
    let mut state = seed;
    std::iter::repeat_with(move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 56) as u8
    })
}

/// The program of this many pseudorandom bytes.
pub(crate) fn random(seed: u64, bytes: usize) -> Program {
    Program::from_bytes(&noise(seed).take(bytes).collect::<Vec<_>>())
}

/// Other pseudorandom bytes, those of pinned programs.
pub(crate) fn drawn(count: usize) -> Vec<u8> {
    let mut random = Random::seeded(52);
    (0..count).map(|_| random.choose(256) as u8).collect()
}

/// Asserts that a text has this checksum, by FNV-1a.
#[track_caller]
pub(crate) fn pinned(text: &str, expected: u64) {
    let fnv = |sum: u64, byte: u8| (sum ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01B3);
    let found = text.bytes().fold(0xCBF2_9CE4_8422_2325, fnv);
    assert!(found == expected, "the checksum is {found:#018x}, of {} bytes: {:.300}", text.len(), text);
}
