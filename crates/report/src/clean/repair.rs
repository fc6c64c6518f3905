//! The options for cleaning a layer.

use super::names::Names;
use crate::error::Error;
use twinedge_layers::Layer;
use twinedge_layers::clean::{CleanOptions, CleanReport, GapsTo, clean};

/// The options for cleaning a layer.
#[derive(Clone, Debug, Default)]
pub struct Repair<'a> {
    /// The names of features in the report.
    pub names: Names<'a>,
    /// The options.
    pub options: CleanOptions,
    /// The column and value of the features that receive gaps; replaces the field of the options.
    pub gaps_to: Option<(&'a str, &'a str)>,
}

impl Repair<'_> {
    /// Cleans a layer in place. Costs as [`clean`] does.
    ///
    /// # Errors
    /// [`Error::NoColumn`], [`Error::GapsTo`] and [`Error::Clean`]; the layer is then unchanged.
    pub fn clean(&self, layer: &mut Layer) -> Result<CleanReport, Error> {
        self.names.refuse_unknown(layer)?;
        let mut options = self.options.clone();
        if let Some((column, value)) = self.gaps_to {
            options.gaps_to = Some(GapsTo::with_value(layer, column, value)?);
        }
        Ok(clean(layer, &options)?)
    }
}
