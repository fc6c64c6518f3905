//! All single corruptions of all small maps, and pairs of them.
//!
//! The maps are all planar subdivisions of up to N edges and N + 1 vertices: with one or several components, nested, with
//! isolated vertices. The structure makes them; tables have two forms, with records for boundary components and as in textbooks.
//! Every field is set to nil, to every slot of the target kind (one vacant), to the slot past the end, and to the largest number.
//!
//! Changing a single field usually changes a count. Corruptions that keep the counts are therefore added. They exchange the
//! contents of two cells of a kind, two whole records, the bounded faces of two cycles, the lists of two faces (with and without
//! the links that lead there), the twins of two edges, or the nexts of two half-edges or of three around a vertex. Each half-edge
//! of an edge becomes its own twin. Two cycles become one boundary component, an outer one becomes an inner one and vice versa, a
//! loop becomes a single half-edge that is its own twin, and a face lists an entry again, or more often than R1 reads. Some of
//! these tables break T1, T2 and T3 and no earlier rule.
//!
//! Maps of up to two edges and two vertices are also judged in every form: for each of the 112 [expectations](crate::forms),
//! closed and, if the expectation allows it, with a face or a cycle of half-edges taken out. In each form, every rule of the
//! expectation must be the first broken one for some table, except for those implied by earlier rules: T4, and T3 on surfaces of
//! any genus. Three more expectations add M1 … M8: a sphere of triangles, for which M1 … M4 are first broken, a sphere, for which
//! M5 … M7 are, and a surface whose border vertices keep border half-edges, for which M8 is. Tables in these forms are also
//! judged without a change: some of them break M1 … M8 only.
//!
//! The reference decides whether a table is invalid, and which rule it breaks first; the validator must agree. Pairs of single
//! corruptions follow: all of them on the maps with at most one edge and two vertices, and a sample of them on all maps.

mod exchange;
mod judge;
mod outcome;
mod specimen;
mod watch;

pub use outcome::{CorruptResults, CorruptWork, ExpectationRow, FieldRow, RuleRow, SampledPairs, Tally};
pub use specimen::Family;
pub use watch::HUNG;

use crate::census::{Census, Scope};
use crate::forms::Form;
use crate::outcome::Outcome;
use crate::rows::MOST_FINDINGS;
use crate::run::Run;
use crate::structure::{Structure, StructureError};
use crate::verdict::Checker;
use judge::{Court, Judge, Judgement};
use specimen::{Corruption, Specimen, held_to, in_words, independent_rules};
use twinedge::program::Subject;
use twinedge::validate::Rule;
use watch::Watch;

const PAIRS_OF_A_PIECE: u32 = 1000;

/// Maps, each in all its forms, and the reasons for missing ones.
struct Specimens {
    /// Empty if the structure does not make the map.
    maps: Vec<Vec<Specimen>>,
    findings: Vec<(usize, String)>,
}

/// Sets every field of every small map of a structure to every other value, and compares a validator with the reference.
///
/// A validation that takes longer than [`HUNG`] counts as hung. One that does not return within a minute cannot be stopped:
/// `hangs` is then called with the findings. It should end the process, like [`abort`]; otherwise the call never returns.
///
/// Time and memory grow about twelvefold with each edge; see [`CorruptWork::estimate`].
///
/// # Errors
/// [`StructureError`], if maps of this structure cannot be told apart.
///
/// # Examples
/// ```
/// use twinedge::validate::Expectation;
/// use twinedge_trials::RawPointers;
/// use twinedge_trials::corrupt::{CorruptWork, abort};
/// use twinedge_trials::{Run, Structure, Validator, corrupt};
/// let mine = Structure::new("mine", RawPointers::new, Expectation::plane());
/// let work = CorruptWork { edges: 1, pairs: 100, seed: 1 };
/// let outcome = corrupt(&mine, work, &Validator, &Run::default(), &abort)?.into_result()?;
/// assert!(outcome.fields.iter().all(|row| row.tally.caught == row.tally.wrong));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn corrupt<K: Subject>(
    structure: &Structure<K>,
    work: CorruptWork,
    checker: &dyn Checker,
    run: &Run<'_>,
    hangs: &(dyn Fn(&Outcome<CorruptResults>) + Sync),
) -> Result<Outcome<CorruptResults>, StructureError> {
    structure.can_be_told_apart()?;
    let specimens = collect(structure, work.edges, run);
    let maps: Vec<&[Specimen]> = run.part().numbers(specimens.maps.len()).map(|i| &*specimens.maps[i]).collect();
    let all: Vec<&Specimen> =
        specimens.maps.iter().flatten().filter(|specimen| specimen.form != Family::Every).collect();
    let pieces: Vec<usize> = run.part().numbers(work.pairs.div_ceil(PAIRS_OF_A_PIECE) as usize).collect();
    let watch = Watch::new();
    let court = Court::new(checker, run, &watch);
    let judge_all = || {
        let judge = || Judge::new(&court);
        drop(run.each("corruptions", maps.len(), judge, |judge, number| judge.corrupt(maps[number])));
        drop(run.each("pairs of corruptions", pieces.len(), judge, |judge, number| {
            let piece = pieces[number];
            let count = PAIRS_OF_A_PIECE.min(work.pairs - piece as u32 * PAIRS_OF_A_PIECE);
            judge.corrupt_pairs(&all, work.seed, piece as u64, count);
        }));
    };
    let found = |hanging| summarize(structure, work, run, &specimens, court.judged(), hanging);
    watch.during(judge_all, |corruption| hangs(&found(Some(corruption))));
    Ok(found(None))
}

/// Prints the validation that does not return to standard error, and aborts the process: for tests.
pub fn abort(outcome: &Outcome<CorruptResults>) {
    eprintln!("{}", outcome.findings.first().map_or("a validation does not return", String::as_str));
    std::process::abort();
}

/// Returns all maps in all their forms. The programs that make them come from a census of the library's own structure.
fn collect<K: Subject>(structure: &Structure<K>, edges: usize, run: &Run<'_>) -> Specimens {
    run.reporter().begin("maps", None);
    let mut specimens = Specimens { maps: Vec::new(), findings: Vec::new() };
    let census = Census::new(Scope::Subdivisions { edges, vertices: edges + 1 });
    for (number, found) in census.take_while(|_| !run.is_stopped()).enumerate() {
        match Specimen::all(structure, &found.program) {
            Ok(map) => specimens.maps.push(map),
            Err(why) => {
                specimens.maps.push(Vec::new());
                specimens.findings.push((number, why));
            }
        }
        run.reporter().advance();
    }
    run.reporter().end();
    specimens
}

fn summarize<K: Subject>(
    on: &Structure<K>,
    work: CorruptWork,
    run: &Run<'_>,
    specimens: &Specimens,
    judged: Judgement,
    hanging: Option<Corruption<'_>>,
) -> Outcome<CorruptResults> {
    let unusable = specimens.findings.iter().filter(|(number, _)| run.part().has(*number as u64));
    let unusable: Vec<String> = unusable.map(|(_, why)| format!("the structure does not make a map: {why}")).collect();
    let hangs = hanging.map(|corruption| format!("the validator does not return: {corruption}"));
    let rules = Rule::ALL.iter().filter(|rule| !rule.is_geometric() && !rule.is_optional());
    let rule_row = |rule: &Rule| RuleRow { rule: *rule, wrong: judged.first_broken.get(rule).copied().unwrap_or(0) };
    let field_row = |((form, field), tally): (&(Family, &str), &Tally)| FieldRow {
        form: *form,
        field: (*field).to_owned(),
        tally: *tally,
    };
    let has_every_part = specimens.maps.iter().flatten().any(|specimen| specimen.number.is_some());
    let forms = if has_every_part { held_to() } else { Vec::new() };
    let form_row = |(number, form): (usize, &Form)| {
        let of_it = judged.by_expectation.range((number, None)..(number + 1, None));
        let first = |rule: &Rule| judged.by_expectation.get(&(number, Some(*rule))).copied().unwrap_or(0);
        ExpectationRow {
            number,
            expectation: in_words(*form),
            corruptions: of_it.map(|(_, count)| count).sum(),
            first_broken: independent_rules(*form)
                .iter()
                .map(|rule| RuleRow { rule: *rule, wrong: first(rule) })
                .collect(),
        }
    };
    let results = CorruptResults {
        on: on.name().to_owned(),
        maps: judged.maps,
        maps_found: specimens.maps.len(),
        unusable: unusable.len(),
        fields: judged.fields.iter().map(field_row).collect(),
        expectations: forms.iter().enumerate().map(form_row).collect(),
        small_pairs: judged.small_pairs,
        pairs: SampledPairs { seed: work.seed, tally: judged.pairs },
        first_broken: rules.map(rule_row).collect(),
        hung: judged.hung + u64::from(hangs.is_some()),
        panics: judged.panics,
        findings: hangs.into_iter().chain(unusable).chain(judged.findings).take(MOST_FINDINGS).collect(),
    };
    Outcome::new(work, run, results)
}
