//! The work and the results of `corrupt`.

use super::specimen::{EDGES_OF_EVERY_FORM, Family};
use crate::outcome::Results;
use crate::rows::{Row, add_findings, add_rows, rows};
use crate::run::Estimate;
use std::time::Duration;
use twinedge::validate::Rule;

/// The results of [`corrupt()`](crate::corrupt()).
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct CorruptResults {
    /// The structure with the corrupted tables.
    pub on: String,
    /// The number of maps with all single corruptions judged, in all forms.
    pub maps: usize,
    /// The number of maps in all parts of the work.
    pub maps_found: usize,
    /// The number of maps that the structure did not make.
    pub unusable: usize,
    /// All single corruptions and exchanges, by the form of the table and the field or exchange.
    pub fields: Vec<FieldRow>,
    /// The result of each expectation, for the tables in every form. Empty if the structure lacks a part.
    pub expectations: Vec<ExpectationRow>,
    /// All pairs of corruptions of the smallest maps.
    pub small_pairs: Tally,
    /// The sampled pairs.
    pub pairs: SampledPairs,
    /// For each rule, the number of tables that break it first, by the reference.
    pub first_broken: Vec<RuleRow>,
    /// Validations that took longer than a second, or did not return.
    pub hung: u64,
    /// Validations that panicked.
    pub panics: u64,
    /// The first disagreements. All are counted.
    pub findings: Vec<String>,
}

rows! {
    /// The results of some corruptions, counted.
    #[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
    pub struct Tally {
        /// The number of corruptions.
        count corruptions: u64 = "corruptions" 13;
        /// Invalid by the reference.
        count wrong: u64 = "wrong" 13;
        /// Invalid, and the validator agrees.
        count caught: u64 = "caught" 13;
        /// Invalid, and the validator accepts.
        zero missed: u64 = "missed" 7;
        /// Valid, and the validator rejects.
        zero false_alarms: u64 = "false" 7;
        /// Caught, but the validator names another rule as the first broken one.
        zero other_rule: u64 = "other rule" 10;
        /// The longest time of a validation.
        #[cfg_attr(feature = "serde", serde(rename = "slowest_us", with = "micros"))]
        slowest slowest: Duration = "slowest" 12;
    }
}

/// An expectation, and the number of tables that break each rule first under it.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct ExpectationRow {
    /// Its index in [`forms`](crate::forms::forms()), followed by three that add M1 … M8.
    pub number: usize,
    /// The expectation in words.
    pub expectation: String,
    /// The number of corrupted tables that were compared with it.
    pub corruptions: u64,
    /// For each rule, the number of tables that break it first, by the reference. Rules that the expectation does not check, and
    /// those implied by earlier rules, are absent.
    pub first_broken: Vec<RuleRow>,
}

/// A field and the results of its corruptions.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct FieldRow {
    /// The form of the table.
    pub form: Family,
    /// The field.
    pub field: String,
    /// The results of its corruptions.
    #[cfg_attr(feature = "serde", serde(flatten))]
    pub tally: Tally,
}

/// The sampled pairs of corruptions.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct SampledPairs {
    /// The seed of the sample.
    pub seed: u64,
    /// The results of the pairs.
    #[cfg_attr(feature = "serde", serde(flatten))]
    pub tally: Tally,
}

rows! {
    /// The number of tables that break a rule first.
    #[derive(Clone, Debug, PartialEq, Eq)]
    pub struct RuleRow {
        /// The rule.
        #[cfg_attr(feature = "serde", serde(with = "rule_id"))]
        label rule: Rule;
        /// The number of invalid tables.
        count wrong: u64;
    }
}

impl Tally {
    /// Returns the number of differences between the validator and the reference.
    #[must_use]
    pub const fn disagreements(&self) -> u64 {
        self.missed + self.false_alarms + self.other_rule
    }
}

impl CorruptResults {
    fn tallies(&self) -> impl Iterator<Item = &Tally> {
        self.fields.iter().map(|row| &row.tally).chain([&self.small_pairs, &self.pairs.tally])
    }

    /// Returns the expectations, each with a rule that it checks, but that no table in its form breaks first.
    pub fn never_first_broken(&self) -> impl Iterator<Item = (&str, Rule)> {
        self.expectations.iter().flat_map(|row| {
            let never = row.first_broken.iter().filter(|broken| broken.wrong == 0);
            never.map(|broken| (row.expectation.as_str(), broken.rule))
        })
    }
}

impl Results for CorruptResults {
    type Work = CorruptWork;

    fn on(&self) -> Vec<&str> {
        vec![&self.on]
    }

    fn reasons(&self, work: &Self::Work, is_complete: bool) -> Vec<String> {
        let counts = [
            ("maps that the structure did not make", self.unusable as u64),
            ("tables on which validator and reference differ", self.tallies().map(Tally::disagreements).sum()),
            ("validations that hung", self.hung),
            ("validations that panicked", self.panics),
        ];
        let counts = counts.into_iter().filter(|(_, count)| *count > 0);
        let mut reasons: Vec<String> = counts.map(|(what, count)| format!("{what}: {count}")).collect();
        if is_complete && self.tallies().all(|tally| tally.caught == 0) {
            reasons.push("no wrong table was caught".to_owned());
        }
        // With fewer edges, nothing can be nested in itself.
        if is_complete && work.edges >= EDGES_OF_EVERY_FORM {
            let never: Vec<String> = self.never_first_broken().map(|(of, rule)| format!("{rule} of {of}")).collect();
            if let Some(first) = never.first() {
                reasons.push(format!("rules that no table in every form breaks first: {}, as {first}", never.len()));
            }
        }
        reasons.extend(self.findings.iter().cloned());
        reasons
    }

    fn absorb(&mut self, other: &Self) {
        self.maps += other.maps;
        self.unusable += other.unusable;
        for other in &other.fields {
            match self.fields.iter_mut().find(|row| (row.form, &row.field) == (other.form, &other.field)) {
                Some(row) => row.tally.add(&other.tally),
                None => self.fields.push(other.clone()),
            }
        }
        for (row, other) in self.expectations.iter_mut().zip(&other.expectations) {
            row.corruptions += other.corruptions;
            add_rows(&mut row.first_broken, &other.first_broken);
        }
        self.small_pairs.add(&other.small_pairs);
        self.pairs.tally.add(&other.pairs.tally);
        add_rows(&mut self.first_broken, &other.first_broken);
        self.hung += other.hung;
        self.panics += other.panics;
        add_findings(&mut self.findings, &other.findings);
    }

    fn complete(&mut self) {
        self.fields.sort_by(|a, b| (a.form, &a.field).cmp(&(b.form, &b.field)));
    }
}

#[cfg(feature = "serde")]
mod micros {
    use serde::{Deserialize, Deserializer, Serializer, de::Error};
    use std::time::Duration;

    pub(super) fn serialize<S: Serializer>(time: &Duration, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_f64(time.as_secs_f64() * 1e6)
    }

    pub(super) fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Duration, D::Error> {
        let micros = f64::deserialize(deserializer)?;
        Duration::try_from_secs_f64(micros / 1e6).map_err(D::Error::custom)
    }
}

#[cfg(feature = "serde")]
mod rule_id {
    use serde::{Deserialize, Deserializer, Serializer, de::Error};
    use twinedge::validate::Rule;

    #[allow(clippy::trivially_copy_pass_by_ref, reason = "the signature that serde calls")]
    pub(super) fn serialize<S: Serializer>(rule: &Rule, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(rule.id())
    }

    pub(super) fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Rule, D::Error> {
        let id = String::deserialize(deserializer)?;
        let rule = Rule::ALL.iter().find(|rule| rule.id() == id);
        rule.copied().ok_or_else(|| D::Error::custom(format!("there is no rule {id}")))
    }
}

/// The work of `corrupt`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct CorruptWork {
    /// The largest number of edges of a map.
    pub edges: usize,
    /// The number of pairs of corruptions to sample.
    pub pairs: u32,
    /// The seed of the sample.
    pub seed: u64,
}

impl CorruptWork {
    /// Returns the approximate number of judged corruptions.
    #[must_use]
    pub fn estimate(&self) -> Estimate {
        // Approximately a third of 12ⁿ maps.
        let maps = 12_u128.saturating_pow(self.edges as u32).div_ceil(3) + 1;
        let of_each = 200 + 220 * (self.edges * self.edges) as u128;
        let amount = maps.saturating_mul(of_each).saturating_add(self.pairs.into());
        Estimate { amount, unit: "corruptions", per_second: 300_000 }
    }
}
