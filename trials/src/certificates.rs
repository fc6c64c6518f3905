//! Certificates as a validator, and as input for other checkers of certificates.

use crate::random::Random;
use crate::verdict::{Checker, Validator, Verdict};
use std::hash::{DefaultHasher, Hash as _, Hasher as _};
use twinedge::validate::reference::first_broken_rule;
use twinedge::validate::{Expectation, Parts, Rule, Surface, Table};
use twinedge_certificate::{Certificate, Column, Labels, check, check_surface};

/// A validator that uses certificates only: a table is valid if its own labels pass, or random ranks, or modified labels; with
/// the table, and in a plane as a self-contained certificate. It differs from the reference if and only if one of these does: its
/// result is then the first broken rule, or R1.
///
/// Open structures, and meshes with further expectations, have no labels: these are left to [`Validator`].
#[derive(Clone, Copy, Debug, Default)]
pub struct Certificates;

impl Checker for Certificates {
    fn check(&self, table: &Table, expectation: &Expectation) -> Verdict {
        let Some((labels, genus)) = labels(table, expectation) else { return Validator.check(table, expectation) };
        let passes = |labels: &Labels| match genus {
            None => check(table, labels).is_ok(),
            // A surface passes with its own genus, and with no other.
            Some(genus) => (0..=genus + 1).filter(|genus| check_surface(table, labels, *genus).is_ok()).count() == 1,
        };
        let mut random = random_of(table);
        let mut changed = labels.clone();
        for _ in 0..2 {
            change(&mut changed, &mut random);
        }
        let all = [random_ranks(&labels, &mut random), labels, changed];
        let stands_alone = |labels: &Labels| Certificate::new(table, labels).is_ok_and(|alone| alone.check().is_ok());
        let beside = all.iter().any(passes);
        let alone = if genus.is_none() { all.iter().any(stands_alone) } else { beside };
        let broken = first_broken_rule(table, expectation);
        let valid = if beside == alone { beside } else { broken.is_some() };
        Verdict { valid, broken: if valid { None } else { broken.or(Some(Rule::R1)) } }
    }
}

/// Returns certificates of a table of a plane subdivision: with its own labels, with random ranks, and two with one changed
/// number. `None` for a table that lacks a part.
#[must_use]
pub fn certificates_of(table: &Table) -> Option<[Certificate; 4]> {
    if table.parts != Parts::ALL {
        return None;
    }
    let labels = Labels::new(table).ok()?;
    let own = Certificate::new(table, &labels).ok()?;
    let mut random = random_of(table);
    let ranked = Certificate::new(table, &random_ranks(&labels, &mut random)).ok()?;
    let mut changed = || {
        let mut columns = own.columns().clone();
        change(&mut columns, &mut random);
        Certificate::from_columns(columns)
    };
    Some([changed()?, changed()?, ranked, own])
}

/// Returns the labels of a table for this expectation, and the genus on surfaces. `None` where the expectation has no labels.
fn labels(table: &Table, expectation: &Expectation) -> Option<(Labels, Option<usize>)> {
    let asks = Rule::ALL.iter().any(|rule| rule.is_optional() && expectation.asks_for(*rule));
    match expectation.surface_kind() {
        _ if asks || expectation.is_open() => None,
        Surface::Plane => Labels::new(table).ok().map(|labels| (labels, None)),
        _ => Labels::of_surface(table).ok().map(|(labels, genus)| (labels, Some(genus))),
    }
}

/// Returns the same random numbers every time for the same table.
fn random_of(table: &Table) -> Random {
    let mut hasher = DefaultHasher::new();
    table.to_string().hash(&mut hasher);
    Random::new(hasher.finish(), 0)
}

fn random_ranks(labels: &Labels, random: &mut Random) -> Labels {
    let mut labels = labels.clone();
    let count = labels.column(Column::HalfEdgeRank).len();
    labels.column_mut(Column::HalfEdgeRank).iter_mut().for_each(|rank| *rank = random.below(count) as u32);
    labels
}

/// Sets one number, if there is one, to another possible number, to nil, or to the content of a vacant slot.
fn change(labels: &mut Labels, random: &mut Random) {
    let filled: Vec<Column> = Column::ALL.into_iter().filter(|column| !labels.column(*column).is_empty()).collect();
    let Some(column) = filled.get(random.below(filled.len())) else { return };
    let column = labels.column_mut(*column);
    let (at, value) = (random.below(column.len()), random.below(column.len() + 3) as u32);
    column[at] = if value as usize > column.len() { u32::MAX - (value - column.len() as u32 - 1) } else { value };
}
