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
    sides: Option<usize>,
    simple: bool,
    closed: bool,
    used: bool,
    border_kept: bool,
    components: Option<usize>,
    borders: Option<usize>,
    genus: Option<usize>,
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
        Ok(self.asking(base))
    }

    /// Returns the expectation, with the required rules.
    pub(crate) fn asking(&self, mut expectation: Expectation) -> Expectation {
        if self.open {
            expectation = expectation.open();
        }
        for (asked, ask) in [
            (self.simple, Expectation::simple as fn(Expectation) -> Expectation),
            (self.closed, Expectation::closed),
            (self.used, Expectation::no_unused_vertices),
            (self.border_kept, Expectation::border_kept),
        ] {
            if asked {
                expectation = ask(expectation);
            }
        }
        for (number, ask) in [
            (self.sides, Expectation::sides as fn(Expectation, usize) -> Expectation),
            (self.components, Expectation::components),
            (self.borders, Expectation::borders),
            (self.genus, Expectation::genus),
        ] {
            if let Some(number) = number {
                expectation = ask(expectation, number);
            }
        }
        expectation
    }
}
