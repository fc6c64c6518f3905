//! Cleaning a layer of polygons.

use crate::audit::LimitsAsked;
use crate::source::{Failure, Source, snap};
use crate::work::within;
use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use twinedge::algorithm::clean::{Options, Winner};
use twinedge_formats::layer::clean::{CleanOptions, clean as mend};
use twinedge_formats::layer::{Format, Layer, write};
use twinedge_report::clean::{Cleaning, Names};

/// The features whose geometry is another one now, by number, with that geometry as hexadecimal digits of well-known binary.
type Changed = Vec<(usize, Option<String>)>;

fn winner(name: &str) -> Result<Winner, Failure> {
    Ok(match name {
        "inner" => Winner::Inner,
        "larger" => Winner::Larger,
        "smaller" => Winner::Smaller,
        "first" => Winner::First,
        "last" => Winner::Last,
        other => {
            return Err(Failure::Value(format!("overlap: {other:?} is none of inner, larger, smaller, first, last")));
        }
    })
}

/// Repairs the polygons of a layer: the report, and what has changed. A `cell` of 0 chooses the grid.
#[pyfunction]
pub(crate) fn clean(
    py: Python<'_>,
    source: Source,
    limits: LimitsAsked,
    cell: Option<f64>,
    overlap: &str,
) -> PyResult<(String, Changed)> {
    let winner = winner(overlap)?;
    let work = move || {
        let name = source.name().to_owned();
        let mut layer = source.read()?;
        let limits = limits.limits();
        let greatest_gap = limits.lake_width.or(limits.gap_width);
        let assign = Options {
            winner,
            gap_width: limits.gap_width,
            lake_width: limits.lake_width,
            accepted_gaps: limits.accepted_gaps,
            sliver_area: limits.sliver_area,
            ..Options::default()
        };
        let how = CleanOptions { snap: snap(cell), assign };
        let report = mend(&mut layer, &how).map_err(|error| Failure::Value(format!("{name}: {error}")))?;
        let mut cleaning = Cleaning::new(&name, Names::default(), &layer, &report);
        cleaning.greatest_gap = greatest_gap;
        let document = cleaning.json().to_string();
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
fn digits(features: Vec<twinedge_formats::layer::Feature>) -> Result<String, Failure> {
    let mut bytes = Vec::new();
    write(&Layer { features, ..Layer::default() }, &mut bytes, Format::Wkb).map_err(Failure::value)?;
    let text = String::from_utf8(bytes).map_err(Failure::value)?;
    Ok(text.trim_end().to_owned())
}
