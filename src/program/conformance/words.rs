//! Half-edges in words, with the vertices that they join: those that operators choose, and those that differences name.

use super::difference::Difference;
use crate::dcel::Corner;
use crate::program::operators::Op;
use crate::program::panics::catch;
use crate::program::run::runner::Runner;
use crate::program::subject::{Refusal, Subject};
use crate::validate::Record;
use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;

/// The handles that an operator chooses.
pub(super) fn call<K: Subject>(runner: &Runner<K>, op: Op) -> String {
    let half_edge = |h: K::HalfEdge| match ends(runner.subject(), h) {
        Ok([origin, target]) => format!("{h:?} ({origin:?} to {target:?})"),
        Err(refusal) => format!("{h:?} ({refusal})"),
    };
    let chosen = || match runner.resolve(op) {
        Ok(call) => call.map(|v| format!("{v:?}"), half_edge, |f| format!("{f:?}")).to_string(),
        Err(outcome) => outcome.to_string(),
    };
    catch(chosen).unwrap_or_else(|panic| format!("panicked: {panic}"))
}

fn ends<K: Subject>(subject: &K, h: K::HalfEdge) -> Result<[K::Vertex; 2], Refusal> {
    Ok([subject.origin_of(h)?, subject.origin_of(subject.twin_of(h)?)?])
}

/// The half-edges that a difference names, where that can be told.
pub(super) fn places<K: Subject>(runner: &Runner<K>, difference: &Difference) -> Vec<String> {
    let subject = runner.subject();
    let of_view = |h: usize| {
        let target = subject.twin(h).filter(|twin| *twin < subject.half_edge_slots()).and_then(|t| subject.origin(t));
        let [origin, target] = [subject.origin(h)?, target?];
        Some(format!("half-edge {h} joins vertex {origin} and vertex {target}"))
    };
    let of_corner = |corner: usize| {
        let Corner::At(h) = runner.corners().nth(corner)? else { return None };
        let [origin, target] = ends(subject, h).ok()?;
        Some(format!("corner {corner} is that of half-edge {h:?}, which joins {origin:?} and {target:?}"))
    };
    let found = || match difference {
        Difference::View { half_edge, .. } | Difference::Unknown { half_edge, .. } => {
            Vec::from_iter(of_view(*half_edge))
        }
        Difference::Answers { corner, .. } | Difference::Missing { corner } => Vec::from_iter(of_corner(*corner)),
        Difference::Invalid(report) => {
            let records = report.first().into_iter().flat_map(|violation| violation.records()).flatten();
            let half_edges = records.filter_map(|record| match record {
                Record::HalfEdge(h) if h < subject.half_edge_slots() && subject.is_half_edge(h) => Some(h),
                _ => None,
            });
            half_edges.filter_map(of_view).collect()
        }
        _ => Vec::new(),
    };
    catch(found).unwrap_or_default()
}
