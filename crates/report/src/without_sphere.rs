//! Stands in for the audit of edges along great circles, if the feature `geodesic` is off.

use crate::error::Error;
use crate::imported::Imported;
use crate::options::Options;
use crate::report::AuditReport;

pub(crate) fn audit(_: &mut Imported, _: &Options, _: &mut dyn FnMut(&'static str)) -> Result<AuditReport, Error> {
    Err(Error::GeodesicOff)
}
