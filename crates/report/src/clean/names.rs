//! The names by which a report calls features.

use crate::error::Error;
use crate::words::plain;
use std::collections::BTreeSet;
use twinedge_layers::{Feature, Layer, Value};

const COLUMNS: usize = 20;

/// The source of the names of features.
#[derive(Clone, Copy, Debug, Default)]
pub struct Names<'a> {
    /// The requested column.
    pub from: Option<&'a str>,
}

impl Names<'_> {
    pub(super) fn of(self, feature: &Feature) -> Option<String> {
        match self.from {
            Some(column) => feature.get(column).and_then(Value::text),
            None => feature.name(),
        }
    }

    /// Refuses a column that no feature has.
    ///
    /// # Errors
    /// [`Error::NoColumn`].
    pub fn refuse_unknown(self, layer: &Layer) -> Result<(), Error> {
        let Some(column) = self.from else { return Ok(()) };
        if layer.features.iter().any(|feature| self.of(feature).is_some()) {
            return Ok(());
        }
        let mut known = BTreeSet::new();
        layer.features.iter().for_each(|feature| self.columns(feature, &mut known));
        Err(no_column(column, known))
    }

    pub(super) fn columns(self, feature: &Feature, known: &mut BTreeSet<String>) {
        if self.from.is_some() {
            known.extend(feature.attributes.iter().map(|(name, _)| plain(name)));
        }
    }
}

/// Returns the error for a column that no feature has, with the first known columns.
pub(super) fn no_column(column: &str, known: BTreeSet<String>) -> Error {
    Error::NoColumn { column: column.to_owned(), known: known.into_iter().take(COLUMNS).collect() }
}
