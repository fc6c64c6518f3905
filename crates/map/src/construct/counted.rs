//! Counting the irregularities of features one by one, for a map too large to be gathered as a whole.

use super::builder::Builder;
use super::error::BuildError;
use crate::feature::Feature;
use crate::summary::{BuildSummary, Irregularity, Position};

impl BuildSummary {
    /// Counts the next feature like [`Builder::feature`], without storing it. Counts only its own repeated segments. Expected
    /// O(points).
    ///
    /// ```
    /// use twinedge_map::{BuildSummary, Feature, Shape};
    ///
    /// let mut summary = BuildSummary::default();
    /// let open = Shape::Polygon(vec![[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]].map(Into::into).to_vec()]);
    /// for _ in 0..2 {
    ///     summary.count(&Feature { shapes: vec![open.clone()], ..Feature::default() })?;
    /// }
    /// assert_eq!((summary.features, summary.segments, summary.open_rings), (2, 6, 2));
    /// assert_eq!(summary.irregularities[1].position.feature, 1);
    /// # Ok::<(), twinedge_map::BuildError>(())
    /// ```
    ///
    /// # Errors
    /// As for [`Builder::feature`]; nothing of the feature is counted then.
    pub fn count(&mut self, feature: &Feature) -> Result<(), BuildError> {
        let number = self.features;
        let of_map = |position: Position| Position { feature: number, ..position };
        let mut builder = Builder::new();
        builder.feature(feature).map_err(|error| match error {
            BuildError::NotFinite { position, x, y } => BuildError::NotFinite { position: of_map(position), x, y },
            BuildError::OutOfRange { position, x, y } => BuildError::OutOfRange { position: of_map(position), x, y },
            other => other,
        })?;
        // All fields are named, so none is forgotten.
        let BuildSummary {
            features,
            segments,
            duplicate_segments,
            zero_length_segments,
            open_rings,
            degenerate_rings,
            rings_wound_wrongly,
            self_touching_rings,
            spikes,
            irregularities,
        } = builder.summary();
        for irregularity in irregularities {
            let is_like = |other: &&Irregularity| other.kind == irregularity.kind;
            if self.irregularities.iter().filter(is_like).count() < Self::LISTED {
                self.irregularities.push(Irregularity { position: of_map(irregularity.position), ..*irregularity });
            }
        }
        self.features += features;
        self.segments += segments;
        self.duplicate_segments += duplicate_segments;
        self.zero_length_segments += zero_length_segments;
        self.open_rings += open_rings;
        self.degenerate_rings += degenerate_rings;
        self.rings_wound_wrongly += rings_wound_wrongly;
        self.self_touching_rings += self_touching_rings;
        self.spikes += spikes;
        Ok(())
    }
}
