//! Parts of the work add up to the whole.

use super::{panics, pointers, slots};
use std::time::Duration;
use twinedge::validate::Expectation;
use twinedge_trials::corrupt::{CorruptResults, CorruptWork, abort};
use twinedge_trials::planted::Planted;
use twinedge_trials::prove::ProveWork;
use twinedge_trials::sample::SampleWork;
use twinedge_trials::soak::SoakWork;
use twinedge_trials::tables::{TablesResults, TablesWork};
use twinedge_trials::{
    Outcome, Progress, Results, Run, Shard, Structure, SumError, Validator, corrupt, prove, sample, soak, sum, tables,
};

/// Returns the outcomes of all parts, the last first.
fn parts<R: Results>(count: u32, part: impl Fn(&Run<'_>) -> Outcome<R>) -> Vec<Outcome<R>> {
    let shards = (0..count).rev().map(|index| Shard::new(index, count).unwrap());
    shards.map(|shard| part(&Run::default().shard(shard))).collect()
}

/// Checks that the sums for these numbers of parts are the results of one run, and again as JSON.
fn adds_up<R: Results>(counts: &[u32], part: impl Fn(&Run<'_>) -> Outcome<R>) -> Outcome<R>
where
    Outcome<R>: PartialEq + std::fmt::Debug + serde::Serialize + serde::de::DeserializeOwned,
{
    let whole = part(&Run::default());
    assert_eq!(part(&Run::default().threads(3)), whole);
    for count in counts {
        let parts = parts(*count, &part);
        assert_eq!(sum(&parts).unwrap(), whole, "{count} parts");
        let text = serde_json::to_string(&parts).unwrap();
        assert_eq!(serde_json::from_str::<Vec<Outcome<R>>>(&text).unwrap(), parts);
    }
    whole
}

#[test]
fn parts_of_prove_add_up() {
    let whole = adds_up(&[1, 3, 16], |run| prove(&slots(), ProveWork { edges: 3 }, run).unwrap());
    assert!(whole.is_ok(), "{:?}", whole.reasons());
    // More parts than the 3 connected maps of up to 1 edge.
    adds_up(&[20], |run| prove(&pointers(), ProveWork { edges: 1 }, run).unwrap());
}

#[test]
fn violations_of_the_parts_of_prove_add_up() {
    let panics = panics();
    let work = ProveWork { edges: 2 };
    let whole = prove(&panics, work, &Run::default()).unwrap();
    let parts = parts(4, |run| prove(&panics, work, run).unwrap());
    let added = sum(&parts).unwrap();
    assert!(!whole.is_ok() && whole.edges.iter().any(|row| row.violations > 0));
    // Only the first findings are kept.
    assert_eq!((&added.edges, &added.nested), (&whole.edges, &whole.nested));
}

/// Times differ from run to run.
fn without_times(mut outcome: Outcome<CorruptResults>) -> Outcome<CorruptResults> {
    let results = &mut outcome.results;
    let tallies = results.fields.iter_mut().map(|row| &mut row.tally);
    tallies
        .chain([&mut results.small_pairs, &mut results.pairs.tally])
        .for_each(|tally| tally.slowest = Duration::ZERO);
    outcome
}

#[test]
fn parts_of_corrupt_add_up() {
    let part = |edges| {
        let work = CorruptWork { edges, pairs: 2_500, seed: 7 };
        move |run: &Run<'_>| without_times(corrupt(&slots(), work, &Validator, run, &abort).unwrap())
    };
    let whole = adds_up(&[1, 2], part(1));
    assert!(whole.is_ok(), "{:?}", whole.reasons());
    // More parts than the 2 maps and the 3 pieces of the sample.
    adds_up(&[7], part(0));
}

#[test]
fn parts_of_tables_add_up() {
    let whole = adds_up(&[3], |run| tables(TablesWork { half_edges: 2 }, &Validator, run));
    assert!(whole.is_ok(), "{:?}", whole.reasons());
    adds_up(&[500], |run| tables(TablesWork { half_edges: 0 }, &Validator, run));
}

#[test]
fn parts_of_sample_add_up() {
    let whole = adds_up(&[1, 2, 5], |run| sample(SampleWork { tables: 3_500, seed: 7 }, &Validator, run));
    assert!(whole.is_ok() && whole.judged == 3_500, "{:?}", whole.reasons());
}

#[test]
fn parts_of_soak_add_up() {
    let work = SoakWork { programs: 20, steps: 30, seed: 5 };
    let whole = adds_up(&[1, 3, 32], |run| soak(&[&slots(), &pointers()], work, run));
    assert!(whole.is_ok() && whole.structures.iter().all(|row| row.programs == 20));
}

#[test]
fn the_first_failure_of_the_parts_of_soak_is_that_of_the_whole() {
    let planted = Structure::new("planted", Planted::<false>::default, Expectation::plane());
    let work = SoakWork { programs: 40, steps: 40, seed: 3 };
    let whole = soak(&[&planted], work, &Run::default().threads(1)).results.failure.unwrap();
    assert_eq!(soak(&[&planted], work, &Run::default().threads(4)).failure.as_ref(), Some(&whole));
    let parts = parts(5, |run| soak(&[&planted], work, run));
    assert_eq!(sum(&parts).unwrap().failure, Some(whole));
}

/// Stops before the first piece of work.
struct Stopped;

impl Progress for Stopped {
    fn is_stopped(&self) -> bool {
        true
    }
}

#[test]
fn parts_that_are_no_whole_are_errors() {
    let part = |half_edges, index, count| {
        let run = Run::default().shard(Shard::new(index, count).unwrap());
        tables(TablesWork { half_edges }, &Validator, &run)
    };
    let shard = |text: &str| text.parse::<Shard>().unwrap();
    let of = |parts: &[Outcome<TablesResults>]| sum(parts).unwrap_err();
    assert_eq!(of(&[]), SumError::Empty);
    let (first, second) = (part(0, 0, 2), part(0, 1, 2));
    assert_eq!(of(std::slice::from_ref(&first)), SumError::Missing { count: 1, first: vec![shard("1/2")] });
    assert_eq!(
        of(&[second.clone(), first.clone(), second.clone()]),
        SumError::Repeated { position: 2, shard: shard("1/2") }
    );
    let other = SumError::OtherCount { position: 1, first: shard("0/2"), other: shard("1/3") };
    assert_eq!(of(&[first.clone(), part(0, 1, 3)]), other);
    let other = of(&[first.clone(), part(1, 1, 2)]);
    assert!(matches!(other, SumError::OtherWork { position: 1, .. }), "{other:?}");
    assert!(other.to_string().contains("half_edges: 1"), "{other}");
    let stopped = tables(TablesWork { half_edges: 0 }, &Validator, &Run::default().progress(&Stopped));
    assert_eq!(of(&[stopped]), SumError::Interrupted { position: 0, shard: Shard::WHOLE });
    // Only some of very many are named.
    let told = of(&[part(0, 0, 1_000)]).to_string();
    assert!(told.starts_with("999 parts are missing: 1/1000, 2/1000, ") && told.len() < 200, "{told}");
}
