//! The option for lengths along the earth.

use crate::status::{Failure, named};
use twinedge_report::{Imported, Units};

/// The measure of lengths and areas.
#[derive(Debug, clap::Args)]
pub(crate) struct Measured {
    /// Lengths in metres along geodesics and areas in square metres, on the ellipsoid WGS 84; of areas, the borders are straight in the coordinates. Only
    /// for longitudes and latitudes in degrees.
    #[arg(long)]
    geodesic: bool,
}

impl Measured {
    /// Returns true if lengths and areas are measured along the earth.
    pub(crate) const fn is_geodesic(&self) -> bool {
        self.geodesic
    }

    pub(crate) fn units(&self, imported: &Imported) -> Result<Units, Failure> {
        Units::of(imported, self.geodesic).map_err(named(&imported.name))
    }
}
