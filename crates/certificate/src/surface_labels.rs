//! Making labels of surfaces. [`check_surface`](super::check_surface) does not rely on any code here.

use super::answers::Answers;
use super::columns::{Column, Labels, LabelsError};
use super::labels::{Ranks, nils};
use super::surface::Surface;
use crate::NIL;
use alloc::vec::Vec;
use twinedge::validate::{Link, Part, View};

impl Labels {
    /// Makes the labels of a structure on closed surfaces. Also returns the sum of the genera of its components.
    ///
    /// If the structure keeps all rules of [`Expectation::surface`](twinedge::validate::Expectation::surface),
    /// [`check_surface`](super::check_surface) passes with both; otherwise it never does. Lists of holes and an unbounded face
    /// are ignored.
    ///
    /// Cost: O(n). The labels take 4 bytes for each half-edge, 8 more unless the genus is 0, and 4 more if there are several components.
    ///
    /// # Errors
    /// [`LabelsError::TooLarge`], [`LabelsError::OutOfMemory`].
    pub fn of_surface<V: View + ?Sized>(view: &V) -> Result<(Self, usize), LabelsError> {
        let parts = view.parts();
        let mut labels = Self::of_links(view)?;
        if !parts.has(Part::Faces) {
            labels.find_cycles(view)?;
        }
        let s = Surface(Answers::new(view, &labels));
        let mut component = nils(s.0.half_edges)?;
        let mut ranks = Ranks::new(&s.0)?;
        let mut roots = 0_usize;
        for root in (0..s.0.half_edges).filter(|h| s.0.is_half_edge(*h)) {
            let ranked = |_: &mut Ranks, h: usize| component[h] = root as u32;
            if ranks.add(root) {
                roots += 1;
                if roots == 1 { ranks.spread_in_order(&s.0, ranked) } else { ranks.spread(&s.0, ranked) }
            }
        }
        let half_edges = (0..s.0.half_edges).filter(|h| s.0.is_half_edge(*h)).count();
        let orbits = (0..s.0.vertices).filter(|v| s.0.leaving(*v).is_some()).count()
            + (0..s.boundaries()).filter(|b| s.start(*b).is_some()).count();
        let genus = (half_edges + 4 * roots).saturating_sub(2 * orbits) / 4;
        if roots == 1 {
            component = (0..s.0.half_edges).find(|h| s.0.is_half_edge(*h)).map(|h| h as u32).into_iter().collect();
        }
        if genus > 0 {
            let turn = |h: usize| s.0.twin(h).and_then(|t| s.0.next(t));
            let turns = positions(s.0.half_edges, (0..s.0.vertices).filter_map(|v| s.0.leaving(v)), turn)?;
            let steps = positions(s.0.half_edges, (0..s.boundaries()).filter_map(|b| s.start(b)), |h| s.0.next(h))?;
            labels.set(Column::HalfEdgeTurn, turns);
            labels.set(Column::HalfEdgeStep, steps);
        }
        labels.set(Column::HalfEdgeComponent, component);
        labels.set(Column::HalfEdgeRank, ranks.rank);
        Ok((labels, genus))
    }
}

/// Returns the positions of half-edges on their orbits, counted from these starts.
fn positions(
    slots: usize,
    starts: impl Iterator<Item = usize>,
    step: impl Fn(usize) -> Link,
) -> Result<Vec<u32>, LabelsError> {
    let mut position = nils(slots)?;
    for start in starts {
        let (mut at, mut count) = (Some(start), 0);
        while let Some(h) = at.filter(|h| position.get(*h) == Some(&NIL)) {
            position[h] = count;
            count += 1;
            at = step(h);
        }
    }
    Ok(position)
}
