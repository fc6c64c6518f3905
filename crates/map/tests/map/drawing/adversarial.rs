//! Embeddings whose answers change: validation ends, without a panic, in linear time, and reads only existing slots.

use crate::support::embeddings::validate_embedding;
use crate::support::inconsistent::Inconsistent;
use crate::support::nested::{PLANE, nested, nested_textbook};
use crate::support::tables::Without;
use twinedge::validate::{Collect, Part};
use twinedge_geometry::Point;
use twinedge_map::{Embedding, places};

/// The coordinates of the vertices of the nested triangles, while answers are consistent.
const POINTS: [[f64; 2]; 7] = [[0.0, 0.0], [10.0, 0.0], [5.0, 10.0], [4.0, 1.0], [6.0, 1.0], [5.0, 3.0], [7.0, 3.0]];

impl Embedding for Inconsistent<'_> {
    fn point(&self, vertex: usize) -> Point {
        let strange = [f64::NAN, f64::INFINITY, 0.0, -0.0, 1e300, f64::MIN_POSITIVE, 5.0];
        match self.noise() {
            Some(u64::MAX) => POINTS[vertex].into(),
            Some(noise) => Point::new(strange[noise as usize % 7], strange[noise as usize / 7 % 7]),
            None => Point::new(f64::NAN, f64::NAN),
        }
    }
}

#[test]
fn answers_may_change_from_call_to_call() {
    for table in [nested(), nested_textbook()] {
        let consistent = Inconsistent::new(&table, u64::MAX, 0);
        assert!(validate_embedding(&consistent, &PLANE, Collect::All).is_valid());
        let questions = consistent.questions.get();
        let without = table.without(Part::UnboundedFace);
        for (table, expectation) in [(&table, PLANE), (&table, PLANE.open()), (&without, PLANE.open())] {
            for consistent_answers in 0..questions {
                for seed in 0..40 {
                    let view = Inconsistent::new(table, consistent_answers, seed);
                    let report = validate_embedding(&view, &expectation, Collect::All);
                    let asked = view.questions.get();
                    // The fast path may read nearly everything before it fails, and then every rule reads again.
                    assert!(asked <= 5 * questions, "{asked} questions, {questions} if consistent\n{report}");
                    for violation in report.violations() {
                        assert!(places(&view, violation).len() <= 4);
                    }
                }
            }
        }
    }
}
