//! Bytes, text, saved form, candidates and outcomes of programs, pinned: corpora and regression tests keep their meaning.

use crate::support::programs::{drawn, pinned};
use arbitrary::{Arbitrary, Unstructured};
use std::fmt::Write;
use twinedge::program::choose::Random;
use twinedge::program::*;
use twinedge::validate::{Expectation, Table};

fn all_of_meshes() -> Vec<OpKind> {
    OpKind::SHARES.iter().filter(|(_, share)| *share == 0).map(|(kind, _)| *kind).collect()
}

#[test]
fn bytes_are_the_programs_that_they_were() {
    let bytes = drawn(20_000);
    pinned(&Program::from_bytes(&bytes).to_string(), 0xDF9C_E363_C0B5_D4D6);
    pinned(&Program::generator().decode(&bytes).to_string(), 0xF1A2_36CA_6DEF_8589);
    pinned(&Program::generator().only(&all_of_meshes()).decode(&bytes).to_string(), 0x83AE_8D18_59D9_06DA);
    pinned(&Program::arbitrary(&mut Unstructured::new(&bytes)).unwrap().to_string(), 0xCA68_7C66_1619_AD55);
    pinned(&Program::arbitrary_take_rest(Unstructured::new(&bytes)).unwrap().to_string(), 0xDF9C_E363_C0B5_D4D6);
}

#[test]
fn random_programs_are_those_that_they_were() {
    let generator = Program::generator().length(300..=400);
    pinned(&generator.generate(&mut Random::seeded(1)).to_string(), 0x17BD_930D_5281_3511);
}

#[test]
fn programs_are_saved_as_they_were() {
    let program = Program::from_bytes(&drawn(5_000));
    let json = serde_json::to_string(&program).unwrap();
    pinned(&json, 0x03DD_7C64_69D2_828C);
    assert_eq!(serde_json::from_str::<Program>(&json).unwrap(), program);
    pinned(&format!("{program:?}"), 0x5348_6CA0_EE28_A3C2);
}

#[test]
fn operators_choose_and_do_what_they_did() {
    let (mut calls, mut outcomes) = (String::new(), String::new());
    let mut runner = Runner::new(PointerModel::new());
    let everything =
        OpKind::SHARES.iter().fold(Program::generator(), |all, (kind, share)| all.weight(*kind, (*share).max(2)));
    for op in everything.length(700..=700).generate(&mut Random::seeded(7)).0 {
        if let Ok(call) = runner.resolve(op) {
            let call = call.map(|v| format!("{v:?}"), |h| format!("{h:?}"), |f| format!("{f:?}"));
            writeln!(calls, "{call} {call:?}").unwrap();
        }
        writeln!(outcomes, "{}", runner.step(op)).unwrap();
    }
    pinned(&calls, 0x6637_210F_C006_3C56);
    pinned(&outcomes, 0x1D62_9B05_4EB9_71D5);
    pinned(&Table::copy_of(runner.subject()).unwrap().to_string(), 0x879A_6F79_C0B2_8487);
    pinned(&format!("{:?}", every_op(&runner).len()), 0x96E7_26AA_27C8_5257);
    let summary = conformance::check(PointerModel::new, &Expectation::plane()).unwrap();
    pinned(&summary.to_string(), 0x6123_C1CA_3438_A9FF);
}

#[test]
fn candidates_are_those_that_they_were() {
    let text = |all: Vec<String>| all.concat();
    let program = Program::from_bytes(&drawn(150));
    pinned(&text(candidates(&program).map(|smaller| smaller.to_string()).collect()), 0x25BD_5B1E_7A7E_2ED6);
}
