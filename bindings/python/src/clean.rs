//! Cleaning a layer of polygons.

use crate::audit::options;
use crate::source::{Failure, Source};
use crate::work::within;
use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use twinedge_coverage::clean::{Options, Winner};
use twinedge_layers::clean::{CleanOptions, GapsTo};
use twinedge_layers::{Format, Layer, write};
use twinedge_report::clean::{Cleaning, Repair};

/// The features with a changed geometry, by number, with the new geometry as hexadecimal digits of well-known binary.
type Changed = Vec<(usize, Option<String>)>;

/// Repairs the polygons of a layer. Returns the report and the changes. Gaps go to one
/// of the features of `gaps_to`, or to a new one behind the others if that is empty.
#[pyfunction]
pub(crate) fn clean(
    py: Python<'_>,
    source: Source,
    asked: &str,
    overlap: &str,
    chooses_width: bool,
    gaps_to: Option<Vec<usize>>,
) -> PyResult<(String, Changed)> {
    let unknown = || Failure::Value(format!("overlap: {overlap:?} is none of inner, larger, smaller, first, last"));
    let winner = Winner::of_name(overlap).ok_or_else(unknown)?;
    let gaps_to = gaps_to.map(|all| if all.is_empty() { GapsTo::New(Vec::new()) } else { GapsTo::Features(all) });
    let asked = options(asked, None)?;
    let (limits, snap) = (asked.coverage.limits.limits(), asked.map.snap);
    let work = move || {
        let name = source.name().to_owned();
        let mut layer = source.read()?;
        let assign = Options {
            winner,
            gap_width: limits.gap_width,
            lake_width: limits.lake_width,
            accepted_gaps: limits.accepted_gaps,
            sliver_area: limits.sliver_area,
            ..Options::default()
        };
        let options = CleanOptions { snap, assign, chooses_width, gaps_to };
        let repair = Repair { options, ..Repair::default() };
        let report = repair.clean(&mut layer).map_err(|error| Failure::Value(format!("{name}: {error}")))?;
        let document = Cleaning::new(&name, &repair, &layer, &report).json().to_string();
        let mut changed = Vec::new();
        for number in report.features.iter().map(|change| change.feature) {
            let feature = layer.features.get(number).cloned();
            let is_empty = feature.as_ref().is_none_or(|feature| feature.geometry.is_none());
            let digits = if is_empty { None } else { Some(digits(feature.into_iter().collect())?) };
            changed.push((number, digits));
        }
        Ok::<_, Failure>((document, changed))
    };
    let outcome = within(py, None, work)?.ok_or_else(|| PyRuntimeError::new_err("time was up"))?;
    Ok(outcome?)
}

/// A geometry in hexadecimal digits.
fn digits(features: Vec<twinedge_layers::Feature>) -> Result<String, Failure> {
    let mut bytes = Vec::new();
    write(&Layer { features, ..Layer::default() }, &mut bytes, Format::Wkb).map_err(Failure::value)?;
    let text = String::from_utf8(bytes).map_err(Failure::value)?;
    Ok(text.trim_end().to_owned())
}
