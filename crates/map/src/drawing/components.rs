//! The components of an embedding, each with its lexicographically smallest vertex and bend.

use super::columns::Columns;
use crate::numbers::{NIL, Sets};
use core::cmp::Ordering;
use twinedge::validate::Unchecked;
use twinedge_geometry::predicates::compare_lexicographic;

pub(crate) struct Components {
    pub(crate) of: Vec<u32>,
    /// For each component, its lexicographically smallest vertex.
    pub(crate) lowest: Vec<u32>,
    /// For each component, its lexicographically smallest bend if that is smaller than all vertices, otherwise `NIL`.
    pub(crate) lowest_bend: Vec<u32>,
}

impl Components {
    /// Finds the components. O(n α(n)) for n half-edges and vertices.
    pub(crate) fn of(columns: &Columns) -> Result<Self, Unchecked> {
        let mut sets = Sets::try_new(columns.points.len()).ok_or(Unchecked::OutOfMemory)?;
        for h in columns.half_edges() {
            sets.join(columns.origin[h], columns.target(h) as u32);
        }
        let mut of = vec![NIL; columns.points.len()];
        let mut numbers = of.clone();
        let mut lowest: Vec<u32> = Vec::new();
        for v in columns.vertices() {
            let number = &mut numbers[sets.find(v as u32) as usize];
            if *number == NIL {
                *number = lowest.len() as u32;
                lowest.push(v as u32);
            }
            of[v] = *number;
            let low = &mut lowest[of[v] as usize];
            if compare_lexicographic(columns.points[v], columns.points[*low as usize]) == Ordering::Less {
                *low = v as u32;
            }
        }
        let mut lowest_bend = vec![NIL; lowest.len()];
        if !columns.bends.points.is_empty() {
            for h in columns.half_edges().filter(|h| columns.is_asked(*h)) {
                let component = of[columns.origin(h)] as usize;
                let low = &mut lowest_bend[component];
                for place in columns.bends.range(h) {
                    let at = |place: u32| columns.bends.points[place as usize];
                    let smallest = if *low == NIL { columns.points[lowest[component] as usize] } else { at(*low) };
                    if compare_lexicographic(at(place as u32), smallest) == Ordering::Less {
                        *low = place as u32;
                    }
                }
            }
        }
        Ok(Self { of, lowest, lowest_bend })
    }
}
