//! G1 and G2: the points, and the angles around each of them.

use super::columns::{Columns, NIL};
use super::{Embedding, Run};
use crate::geometry::predicates::{compare_angle, in_range};
use crate::validate::{Flow, Rule, Violation};
use core::cmp::Ordering;

impl<D: Embedding + ?Sized> Run<'_, D> {
    /// Runs G1.
    pub(super) fn finite(&mut self, columns: &Columns) -> Flow {
        let mut checked = 0;
        for v in columns.vertices() {
            checked += 1;
            if !in_range(columns.points[v]) {
                self.findings.add(Violation::NotFinite { vertex: v })?;
            }
        }
        self.findings.checked(Rule::G1, checked);
        for h in columns.half_edges() {
            // Nil is larger than any half-edge.
            if (h as u32) < columns.twin[h] && columns.tail(h) == columns.head(h) {
                self.findings.add(Violation::ZeroLength { half_edge: h })?;
            }
        }
        Ok(())
    }

    /// Runs G2: turning clockwise once around a vertex, the angle rises exactly once.
    pub(super) fn angles(&mut self, columns: &Columns) -> Flow {
        let mut seen = vec![false; columns.points.len()];
        let mut checked = 0;
        // At an open boundary the walk ends, so it has to begin where that border comes in.
        let borders = columns.half_edges().filter(|h| columns.twin[*h] == NIL).map(|h| columns.next(h));
        for first in borders.chain(columns.half_edges()) {
            let v = columns.origin(first);
            if std::mem::replace(&mut seen[v], true) {
                continue;
            }
            checked += 1;
            let center = columns.points[v];
            let mut rises = 0;
            let mut h = first;
            while let Some(after) = columns.clockwise(h) {
                if compare_angle(center, columns.head(h), columns.head(after)) == Ordering::Less {
                    rises += 1;
                    if rises > 1 {
                        self.findings.add(Violation::OutOfOrder { vertex: v, half_edge: h, found: after })?;
                        break;
                    }
                }
                h = after;
                if h == first {
                    break;
                }
            }
        }
        self.findings.checked(Rule::G2, checked);
        Ok(())
    }
}
