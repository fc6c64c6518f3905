//! The Python module `twinedge._twinedge`: the validator over numpy arrays, audits of meshes and maps, whole or in
//! tiles, queries of maps, and maps to edit.
//!
//! Each function returns a report as JSON, in the form of `docs/report.md`. The package `twinedge` turns it into
//! objects.

mod arrays;
mod attributes;
mod audit;
mod clean;
mod editor;
mod expectation;
mod geometries;
mod maps;
mod overlay;
mod source;
mod structure;
mod tiles;
mod work;

use pyo3::prelude::*;
use twinedge_coverage::layers::{Deviation, LayerRule};

/// The native part of `twinedge`.
#[pymodule]
fn _twinedge(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
    module.add("REPORT_SCHEMA", twinedge::validate::REPORT_SCHEMA)?;
    module.add("DEFAULT_LIST", twinedge::validate::Collect::DEFAULT_CAP)?;
    module.add("PRESETS", twinedge_columns::Preset::ALL.iter().map(|p| p.name()).collect::<Vec<_>>())?;
    module.add("KINDS", twinedge::validate::Violation::KINDS.to_vec())?;
    let of_meshes = twinedge_meshes::Kind::ALL.iter().map(|kind| kind.name());
    let of_coverages = twinedge_coverage::CoverageRule::ALL.iter().map(|rule| rule.name());
    // Layers are compared only with their own parents.
    let of_parents = Deviation::ALL.into_iter().filter(|kind| kind.rule() == LayerRule::Parent).map(Deviation::name);
    module.add("FINDING_KINDS", of_meshes.chain(of_coverages).chain(of_parents).collect::<Vec<_>>())?;
    module.add_function(wrap_pyfunction!(structure::validate, module)?)?;
    module.add_function(wrap_pyfunction!(structure::explain, module)?)?;
    module.add_class::<maps::Map>()?;
    module.add_class::<editor::Editor>()?;
    module.add_function(wrap_pyfunction!(audit::audit, module)?)?;
    module.add_function(wrap_pyfunction!(audit::audit_faces, module)?)?;
    module.add_function(wrap_pyfunction!(audit::diff, module)?)?;
    module.add_function(wrap_pyfunction!(clean::clean, module)?)?;
    module.add_function(wrap_pyfunction!(maps::build_map, module)?)?;
    module.add_function(wrap_pyfunction!(tiles::survey, module)?)?;
    module.add_function(wrap_pyfunction!(tiles::even_grid, module)?)?;
    module.add_function(wrap_pyfunction!(tiles::fitted_grid, module)?)?;
    module.add_function(wrap_pyfunction!(tiles::boxes, module)?)?;
    module.add_function(wrap_pyfunction!(tiles::divide, module)?)?;
    module.add_function(wrap_pyfunction!(tiles::no_cuts, module)?)?;
    module.add_function(wrap_pyfunction!(tiles::tiles_to_search, module)?)?;
    module.add_function(wrap_pyfunction!(tiles::search, module)?)?;
    module.add_function(wrap_pyfunction!(tiles::take, module)?)?;
    module.add_function(wrap_pyfunction!(tiles::summarise, module)?)?;
    module.add_function(wrap_pyfunction!(overlay::extents, module)?)?;
    module.add_function(wrap_pyfunction!(overlay::tiles_near, module)?)?;
    module.add_function(wrap_pyfunction!(overlay::overlay_tile, module)?)?;
    module.add_function(wrap_pyfunction!(tiles::merge, module)?)?;
    module.add_function(wrap_pyfunction!(tiles::finish, module)?)
}
