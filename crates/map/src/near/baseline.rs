//! The structure and its coordinates as of the last valid state.

use super::disjoint::is_disjoint;
use super::drawing::{Drawing, Place, read_places};
use super::drawn::Update;
use super::inside::is_inside;
use super::tree::DrawnTrees;
use crate::Embedding;
use crate::drawing::validate_embedding;
use twinedge::validate::near::changes::{Column, Diff, HalfEdge, Row as _};
use twinedge::validate::near::{Baseline, BaselineError, WriteSet};
use twinedge::validate::{Collect, Expectation, Part, Report, Surface};

/// The links and coordinates of a valid structure, kept for comparison after a change. See [`validate_embedding_near`].
///
/// Takes 32 bytes per vertex on top of a [`Baseline`], and about 70 per edge and 40 per inner boundary component for R-trees.
#[derive(Clone, Debug)]
pub struct EmbeddingBaseline {
    links: Baseline,
    places: Column<Place>,
    /// `None` if the drawing was not read after the links.
    trees: Option<DrawnTrees>,
}

impl EmbeddingBaseline {
    /// Validates the structure in full, and copies its links and coordinates. O(n log n).
    ///
    /// # Errors
    /// The structure is invalid; edges have bends; or the expectation does not describe a plane map with faces, boundary
    /// components, places, lists of inner ones, and an unbounded face.
    pub fn new<E: Embedding + ?Sized>(embedding: &E, expectation: &Expectation) -> Result<Self, BaselineError> {
        let parts = expectation.looks_at(embedding.parts());
        Baseline::supports(expectation, parts)?;
        let needed = [Part::Faces, Part::BoundaryComponents, Part::Places, Part::Holes, Part::UnboundedFace];
        if let Some(part) = needed.into_iter().find(|part| !parts.has(*part)) {
            return Err(BaselineError::Lacks(part));
        }
        if expectation.surface_kind() != Surface::Plane {
            return Err(BaselineError::NotPlane);
        }
        validate_embedding(embedding, expectation, Collect::All).into_result().map_err(BaselineError::Invalid)?;
        let links = Baseline::of_right(embedding, expectation)?;
        let bends =
            |(h, _, row): (usize, HalfEdge, HalfEdge)| row.is_live() && h < row.twin as usize && embedding.bends(h) > 0;
        if links.changes().half_edges.changes().any(bends) {
            return Err(BaselineError::Bends);
        }
        let mut baseline = Self { links, places: Column::default(), trees: None };
        baseline.draw_all(embedding).ok_or(BaselineError::Changing)?;
        Ok(baseline)
    }

    /// Returns the expectation that the structure must meet.
    #[must_use]
    pub const fn expectation(&self) -> &Expectation {
        self.links.expectation()
    }

    /// Reads the drawing after the links: relative to an empty drawing, everything is new.
    fn draw_all<E: Embedding + ?Sized>(&mut self, embedding: &E) -> Option<()> {
        let mut all = Column::default();
        let diff = self.links.changes();
        read_places(&mut all, diff, embedding)?;
        let update = Drawing::new(embedding, diff, &all)?.update()?;
        self.trees = Some(DrawnTrees::new(update));
        self.links.commit();
        all.commit();
        self.places = all;
        Some(())
    }
}

/// Validates a structure with coordinates after a change, in time proportional to the change. Checks all rules from R1 to T4 and
/// from G1 to G5; [`near`](crate::near) explains the method.
///
/// `written` must name every record that changed since the baseline was made or last advanced, and each vertex that moved. If all
/// rules hold, the baseline advances. Costs O(k log n) for k records that were written or are edges of moved vertices, of n; plus
///
/// - for each redrawn edge, the cost of finding the edges whose boxes meet its box in an R-tree, and the number of these edges;
/// - for each face whose extent has changed, O(log k) for each inner boundary component that starts in the box around the gained
///   or lost area.
///
/// If a rule is broken, the structure is validated in full in O(n log n), so the report equals the report of
/// [`validate_embedding`](crate::validate_embedding). The baseline does not advance.
///
/// ```
/// use twinedge_map::PlanarMap;
/// use twinedge_map::near::{EmbeddingBaseline, validate_embedding_near};
/// use twinedge::validate::near::WriteSet;
/// use twinedge::validate::{Expectation, View};
///
/// let mut map = PlanarMap::new();
/// let corner = map.insert_ring([[0.0, 0.0], [4.0, 0.0], [0.0, 4.0]])?.vertices[0];
/// let mut baseline = EmbeddingBaseline::new(&map, &Expectation::plane())?;
/// map.move_vertex(corner, [-1.0, -1.0])?;
/// let written = WriteSet { vertices: vec![map.dcel().vertex(corner)?.index()], ..WriteSet::default() };
/// validate_embedding_near(&mut baseline, &map, &written)?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// The report of the full validation, if a rule is broken.
pub fn validate_embedding_near<E: Embedding + ?Sized>(
    baseline: &mut EmbeddingBaseline,
    embedding: &E,
    written: &WriteSet,
) -> Result<(), Box<Report>> {
    let EmbeddingBaseline { links, places, trees } = baseline;
    if let Some(trees) = trees {
        places.clear();
        let found = links.check(embedding, written).and_then(|()| check(links.changes(), places, trees, embedding));
        if found.is_some() {
            links.commit();
            places.commit();
            return Ok(());
        }
    }
    validate_embedding(embedding, links.expectation(), Collect::All).into_result()?;
    // The structure is valid: a changed record was not named, or the changes do not determine the nesting.
    *trees = None;
    if links.read(embedding).is_some() {
        let _ = baseline.draw_all(embedding);
    }
    Ok(())
}

/// Checks G1, G3, G4 and G5; G2 follows. Advances the trees if all hold.
fn check<E: Embedding + ?Sized>(
    diff: &Diff,
    places: &mut Column<Place>,
    trees: &mut DrawnTrees,
    embedding: &E,
) -> Option<()> {
    read_places(places, diff, embedding)?;
    let drawing = Drawing::new(embedding, diff, places)?;
    let update = drawing.update()?;
    trees.apply(&update);
    let keeps = keeps_rules(&drawing, &update, trees);
    if keeps.is_none() {
        trees.undo(&update);
    }
    keeps
}

fn keeps_rules(drawing: &Drawing<'_>, update: &Update, trees: &DrawnTrees) -> Option<()> {
    is_disjoint(&update.drawn.come, trees).then_some(())?;
    drawing.winding()?;
    is_inside(drawing, trees)
}
