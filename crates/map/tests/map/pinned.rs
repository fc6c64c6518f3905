//! Pinned bytes, text, form and candidates of programs of edits: corpora and regression tests keep their meaning.

use crate::support::programs::{drawn, pinned};
use arbitrary::{Arbitrary, Unstructured};
use twinedge::program::choose::Random;
use twinedge::program::{Program, candidates};
use twinedge_map::program::{EditKind, EditProgram};

#[test]
fn bytes_are_the_programs_that_they_were() {
    let bytes = drawn(20_000);
    pinned(&EditProgram::from_bytes(&bytes).to_string(), 0x9070_4C81_7D47_C48C);
    pinned(&EditProgram::arbitrary(&mut Unstructured::new(&bytes)).unwrap().to_string(), 0x7B8A_3488_6836_25FA);
    pinned(&EditProgram::arbitrary_take_rest(Unstructured::new(&bytes)).unwrap().to_string(), 0x9070_4C81_7D47_C48C);
    // An edit without arguments takes no byte, but decoding still ends.
    let features = EditProgram::generator().only(&[EditKind::AddFeature]).decode(&[1, 2, 3]);
    assert_eq!(features.to_string(), "twinedge edits 1\nadd_feature\nadd_feature\nadd_feature\n");
}

#[test]
fn random_programs_are_those_that_they_were() {
    let edits = EditProgram::generator().length(300..=400);
    pinned(&edits.generate(&mut Random::seeded(1)).to_string(), 0x3701_4E6E_CE0E_31BD);
}

#[test]
fn programs_are_printed_as_they_were() {
    let bytes = drawn(5_000);
    let both = format!("{:?} {:?}", Program::from_bytes(&bytes), EditProgram::from_bytes(&bytes));
    pinned(&both, 0xD921_D5DB_06B3_5DBF);
}

#[test]
fn candidates_are_those_that_they_were() {
    let edits = EditProgram::from_bytes(&drawn(60));
    let text: String = candidates(&edits).map(|smaller| smaller.to_string()).collect();
    pinned(&text, 0xF595_6AC2_DA6C_D0E4);
}
