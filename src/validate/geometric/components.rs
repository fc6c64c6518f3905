//! The components of an embedding, each with its lexicographically smallest vertex and bend.

use super::columns::Columns;
use crate::geometry::predicates::compare_lexicographic;
use crate::validate::columns::NIL;
use core::cmp::Ordering;

/// The components of an embedding.
pub(in crate::validate) struct Components {
    /// For each vertex, its component.
    pub(in crate::validate) of: Vec<u32>,
    /// For each component, its lexicographically smallest vertex.
    pub(in crate::validate) lowest: Vec<u32>,
    /// For each component, the place of its lexicographically smallest bend, if that is smaller than all vertices; else nil.
    pub(in crate::validate) lowest_bend: Vec<u32>,
}

impl Components {
    /// O(n α(n)) for n half-edges and vertices.
    pub(in crate::validate) fn of(columns: &Columns) -> Self {
        // For each vertex another of its component, until that is itself.
        let mut towards: Vec<u32> = (0..columns.points.len() as u32).collect();
        for h in columns.half_edges() {
            let (a, b) = (find(&mut towards, columns.origin[h]), find(&mut towards, columns.target(h) as u32));
            // The larger index gives way, so chains lead downwards.
            towards[a.max(b) as usize] = a.min(b);
        }
        let mut of = vec![NIL; columns.points.len()];
        let mut lowest: Vec<u32> = Vec::new();
        for v in columns.vertices() {
            let first = find(&mut towards, v as u32) as usize;
            if first == v {
                of[v] = lowest.len() as u32;
                lowest.push(v as u32);
                continue;
            }
            of[v] = of[first];
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
        Self { of, lowest, lowest_bend }
    }
}

/// The vertex by which the component is known so far, halving the way there.
fn find(towards: &mut [u32], mut v: u32) -> u32 {
    while towards[v as usize] != v {
        towards[v as usize] = towards[towards[v as usize] as usize];
        v = towards[v as usize];
    }
    v
}
