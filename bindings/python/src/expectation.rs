//! The expectation and the limits of a validation, from keyword arguments.

use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use twinedge::validate::Expectation;
use twinedge_columns::Preset;

/// The required rules, and the number of violations to list.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct Claims {
    plane: bool,
    open: bool,
    preset: Option<String>,
    /// The optional rules, by their words, with their numbers.
    asked: Vec<(String, Option<usize>)>,
    list: usize,
}

impl Claims {
    /// Returns the number of violations to list.
    pub(crate) const fn list(&self) -> usize {
        self.list
    }

    /// Returns the expectation of a structure of columns.
    pub(crate) fn of_columns(&self) -> PyResult<Expectation> {
        let base = match &self.preset {
            None if self.plane => Expectation::plane(),
            None => Expectation::surface(),
            Some(name) => Preset::from_name(name)
                .ok_or_else(|| {
                    let names: Vec<_> = Preset::ALL.iter().map(|preset| preset.name()).collect();
                    PyValueError::new_err(format!(
                        "preset: there is none named {name:?}; there are {}",
                        names.join(", ")
                    ))
                })?
                .expectation(),
        };
        self.asking(base)
    }

    /// Returns the expectation, with the required rules.
    pub(crate) fn asking(&self, base: Expectation) -> PyResult<Expectation> {
        let base = if self.open { base.open() } else { base };
        let asked = self.asked.iter().try_fold(base, |expectation, (word, number)| expectation.asking(word, *number));
        asked.map_err(|error| PyValueError::new_err(error.to_string()))
    }
}
