//! The sources of choices: answers are in range, and exhaustive enumeration is complete.

use std::collections::BTreeSet;
use twinedge::program::choose::{Bytes, Choose, Odometer, for_each_choice};

/// Asks the number of questions given by the first answer, each with its own bound.
fn questions(source: &mut impl Choose) -> Vec<usize> {
    let count = source.choose(4);
    // The first of these is no choice, and takes no byte.
    (0..count).map(|i| source.choose(i + 1)).collect()
}

#[test]
fn every_sequence_of_answers_comes_exactly_once() {
    let mut seen = Vec::new();
    let count = for_each_choice(|source| seen.push(questions(source)));
    let distinct: BTreeSet<_> = seen.iter().cloned().collect();
    assert_eq!(count, 1 + 1 + 2 + 2 * 3);
    assert_eq!((seen.len(), distinct.len()), (10, 10));
    assert!(seen.is_sorted_by(|a, b| a.len() < b.len() || a < b), "like a mileage counter");
}

#[test]
fn a_body_without_questions_runs_once() {
    assert_eq!(for_each_choice(|_| ()), 1);
    assert_eq!(for_each_choice(|source| assert_eq!(source.choose(0), 0)), 1);
    assert_eq!(for_each_choice(|source| assert_eq!(source.choose(1), 0)), 1);
}

#[test]
fn answers_of_the_odometer_replay_as_bytes() {
    for_each_choice(|source: &mut Odometer| {
        let body = questions(source);
        let bytes: Vec<u8> = source.answers().map(|answer| u8::try_from(answer).unwrap()).collect();
        assert_eq!(questions(&mut Bytes::new(&bytes)), body);
    });
}

#[test]
fn a_body_that_changes_its_mind_is_still_answered_in_range() {
    let mut runs = 0;
    for_each_choice(|source| {
        runs += 1;
        let n = if runs == 3 { 2 } else { 5 };
        assert!(source.choose(n) < n);
        if runs < 3 {
            source.choose(2);
        }
    });
    assert!(runs <= 10);
}

#[test]
fn bytes_take_what_the_number_needs_and_end_in_zeros() {
    let mut source = Bytes::new(&[7, 0x34, 0x12, 9, 1, 2, 3, 4, 5, 6, 7, 0xFF]);
    assert_eq!(source.choose(256), 7);
    assert_eq!(source.choose(0x1_0000), 0x1234);
    assert_eq!(source.choose(1), 0);
    assert_eq!(source.choose(4), 1, "modulo");
    assert_eq!(source.choose(usize::MAX) % 256, 1);
    assert_eq!(source.rest().len(), 0, "eight bytes, or as many as there are");
    assert_eq!(source.choose(10), 0);
}

#[test]
fn arbitrary_bytes_are_a_source() {
    let mut source = arbitrary::Unstructured::new(&[1, 2, 3, 250, 17]);
    for n in [1, 2, 3, 200, 256, 70_000, usize::MAX, 0] {
        assert!(Choose::choose(&mut source, n) < n.max(1));
    }
    assert_eq!(questions(&mut arbitrary::Unstructured::new(&[3, 1, 2])), [0, 1, 2]);
}
