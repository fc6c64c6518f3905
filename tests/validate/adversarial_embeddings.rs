//! Drawings that lie: whatever is answered, and however the answers change, validation ends, without a panic, in linear
//! time, and asks only about what there is.

use crate::support::moody::Moody;
use crate::support::nested::{nested, nested_textbook};
use twinedge::geometry::Point;
use twinedge::validate::{Collect, Expectation, Part};
use twinedge::validate::{Embedding, places, validate_embedding};

/// Where the vertices of the nested triangles lie, as long as the drawing is in the mood to say so.
const POINTS: [[f64; 2]; 7] = [[0.0, 0.0], [10.0, 0.0], [5.0, 10.0], [4.0, 1.0], [6.0, 1.0], [5.0, 3.0], [7.0, 3.0]];

impl Embedding for Moody<'_> {
    fn point(&self, vertex: usize) -> Point {
        let strange = [f64::NAN, f64::INFINITY, 0.0, -0.0, 1e300, f64::MIN_POSITIVE, 5.0];
        match self.mood() {
            Some(u64::MAX) => POINTS[vertex].into(),
            Some(mood) => Point::new(strange[mood as usize % 7], strange[mood as usize / 7 % 7]),
            None => Point::new(f64::NAN, f64::NAN),
        }
    }
}

#[test]
fn answers_may_change_from_call_to_call() {
    let plane = Expectation::plane();
    let textbook = plane.without(Part::BoundaryComponents);
    for (table, expectation) in [(nested(), plane), (nested_textbook(), textbook)] {
        let honest = Moody::new(&table, u64::MAX, 0);
        assert!(validate_embedding(&honest, &expectation, Collect::All).is_valid());
        let questions = honest.questions.get();
        for expectation in [expectation, expectation.open(), expectation.without(Part::UnboundedFace).open()] {
            for patience in 0..questions {
                for seed in 0..40 {
                    let moody = Moody::new(&table, patience, seed);
                    let report = validate_embedding(&moody, &expectation, Collect::All);
                    let asked = moody.questions.get();
                    assert!(asked <= 3 * questions, "{asked} questions, {questions} if honest\n{report}");
                    for violation in report.violations() {
                        assert!(places(&moody, violation).len() <= 4);
                    }
                }
            }
        }
    }
}
