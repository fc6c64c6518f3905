//! Tests of `feature_tries`.

use super::{EMPTY, FeatureTries, SetOperation};
use crate::FeatureId;
use quickcheck::quickcheck;
use std::collections::BTreeSet;

/// Numbers that share prefixes of all lengths.
fn spread(numbers: &[(u8, u8)]) -> BTreeSet<FeatureId> {
    numbers.iter().map(|(shift, low)| FeatureId::new((1_u32 << (shift % 32)) ^ u32::from(low % 70))).collect()
}

quickcheck! {
    fn sets_are_those_of_the_standard_library(a: Vec<(u8, u8)>, b: Vec<(u8, u8)>) -> bool {
        let (a, b) = (spread(&a), spread(&b));
        let mut tries = FeatureTries::default();
        let [x, y] = [&a, &b].map(|set| tries.number(set.iter().copied()));
        let mut is = |operation, expected: BTreeSet<FeatureId>| {
            let set = tries.combined(operation, x, y);
            let equal = tries.members(set).eq(expected.iter().copied());
            // The order of insertion does not matter: equal sets have equal numbers.
            equal && set == tries.number(expected.into_iter().rev())
        };
        is(SetOperation::Common, &a & &b)
            && is(SetOperation::Either, &a | &b)
            && is(SetOperation::Differing, &a ^ &b)
    }
}

#[test]
fn sets_inside_each_other_share_their_nodes() {
    const SETS: u32 = 10_000;
    let mut tries = FeatureTries::default();
    let mut set = EMPTY;
    for feature in 0..SETS {
        let single = tries.single(FeatureId::new(feature));
        set = tries.combined(SetOperation::Differing, set, single);
    }
    assert_eq!(tries.members(set).count(), SETS as usize);
    assert!(tries.nodes.len() < 12 * SETS as usize, "{}", tries.nodes.len());
}
