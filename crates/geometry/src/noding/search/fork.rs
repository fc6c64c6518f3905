//! The tasks of a search, run one after the other or, if there are many, in two halves at once. Blocks share no pixel, so the
//! finds in one do not affect the finds in another; only the numbers of new vertices depend on the order.

use super::filing::Filing;
use super::limits::{Budget, limit};
use super::{Look, PixelVisits, Search, Task};
use crate::noding::input::NodingError;
use crate::threads;

/// With fewer segments, tasks are not halved.
const MANY: usize = limit(1 << 13, 16);

impl Search<'_> {
    pub(super) fn run(&mut self) -> Result<(), NodingError> {
        let (mut segment_ids, mut vertex_ids) = (Vec::new(), Vec::new());
        while let Some(task) = self.tasks.pop() {
            match task {
                Task::Look(look) => {
                    segment_ids.clear();
                    segment_ids.extend(self.segment_pool.drain(look.segments_from..));
                    vertex_ids.clear();
                    vertex_ids.extend(self.vertex_pool.drain(look.vertices_from..));
                    self.look(&look, &segment_ids, &mut vertex_ids)?;
                }
                Task::Finish { bundle, vertices_from } => {
                    self.bundles -= 1;
                    for v in vertices_from..self.vertices.len() {
                        self.try_bundle(&bundle, v as u32);
                    }
                }
            }
            // One task finds at most O(n), in practice.
            self.budget.check(self.found.visits.len())?;
            if let Some(mut other) = self.halve() {
                let (these, others) = threads::join(|| self.run(), || other.run());
                these?;
                others?;
                self.take(other)?;
            }
        }
        Ok(())
    }

    /// Moves about half of the tasks to another search, if there are many and no bundle waits for results of this one.
    fn halve(&mut self) -> Option<Self> {
        if !cfg!(feature = "rayon") || self.segment_pool.len() < MANY || self.tasks.len() < 2 || self.bundles > 0 {
            return None;
        }
        let half = self.segment_pool.len() / 2;
        let before = |task: &Task<'_>| matches!(task, Task::Look(look) if look.segments_from < half);
        let from = self.tasks.partition_point(before).clamp(1, self.tasks.len() - 1);
        let Some(&Task::Look(Look { segments_from, vertices_from, .. })) = self.tasks.get(from) else { return None };
        let mut tasks = self.tasks.split_off(from);
        for task in &mut tasks {
            if let Task::Look(look) = task {
                look.segments_from -= segments_from;
                look.vertices_from -= vertices_from;
            }
        }
        Some(Self {
            pixels: self.pixels,
            segments: self.segments,
            vertices: self.vertices.beside(),
            found: PixelVisits::default(),
            budget: Budget { counted: 0, ..self.budget },
            tasks,
            bundles: 0,
            segment_pool: self.segment_pool.split_off(segments_from),
            vertex_pool: self.vertex_pool.split_off(vertices_from),
            filing: Filing::default(),
            boxes: Vec::new(),
        })
    }

    fn take(&mut self, other: Self) -> Result<(), NodingError> {
        let renamed = self.vertices.take(&other.vertices).ok_or(NodingError::TooMany)?;
        self.found.visits.extend(other.found.visits.into_iter().map(|[segment, v]| [segment, renamed(v)]));
        self.found.doubtful.extend(other.found.doubtful);
        Ok(())
    }
}
