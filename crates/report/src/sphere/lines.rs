//! Arcs as lines on the map.

use crate::trace::position;
use twinedge_diagnosis::Position;
use twinedge_geometry::Point;
use twinedge_sphere::Place;

/// The greatest length, in degrees, of a straight line that represents a part of an arc.
const STEP: f64 = 0.5;

/// Returns arcs as lines on the map. Consecutive arcs form one line, unless they cross the antimeridian. Intermediate points show the curvature of an
/// arc.
pub(super) fn lines(arcs: &[[Point; 2]]) -> Vec<Vec<Position>> {
    let mut lines: Vec<Vec<Position>> = Vec::new();
    for ends in arcs {
        let [from, to] = ends.map(position);
        let is_next = lines.last().and_then(|line| line.last()) == Some(&from);
        let mut line = if is_next { lines.pop().unwrap_or_default() } else { vec![from] };
        for at in between(*ends).into_iter().chain([to]) {
            if line.last().is_some_and(|last| (last[0] - at[0]).abs() > 180.0) {
                lines.push(std::mem::take(&mut line));
            }
            line.push(at);
        }
        lines.push(line);
    }
    // A line of a single point beyond the antimeridian shows nothing.
    lines.retain(|line| line.len() > 1);
    lines
}

/// Points along an arc, without its ends.
fn between([a, b]: [Point; 2]) -> Vec<Position> {
    let (Ok(from), Ok(to)) = (Place::new(a.x, a.y), Place::new(b.x, b.y)) else { return Vec::new() };
    let [p, q] = [from, to].map(|place| {
        let vector = place.vector();
        let length = vector.iter().map(|x| x * x).sum::<f64>().sqrt();
        vector.map(|x| x / length)
    });
    let chord = (0..3).map(|i| (q[i] - p[i]).powi(2)).sum::<f64>().sqrt();
    // The angle is at most π/2 times the chord.
    let parts = (chord * std::f64::consts::FRAC_PI_2).to_degrees() / STEP;
    let parts = (1..=360).take_while(|part| f64::from(*part) < parts).count() + 1;
    let at = |part: usize| {
        let t = part as f64 / parts as f64;
        Place::toward([0, 1, 2].map(|i| p[i] + (q[i] - p[i]) * t)).map(Place::degrees)
    };
    (1..parts).filter_map(at).collect()
}

#[cfg(test)]
mod tests {
    use super::lines;
    use twinedge_geometry::Point;

    #[test]
    fn arcs_are_lines_with_points_between_that_break_at_the_antimeridian() {
        let point = Point::new;
        // Along the 49th parallel, and on to the south.
        let found = lines(&[[point(-100.0, 49.0), point(-90.0, 49.0)], [point(-90.0, 49.0), point(-90.0, 48.8)]]);
        assert_eq!((found.len(), found[0].first(), found[0].last()), (1, Some(&[-100.0, 49.0]), Some(&[-90.0, 48.8])));
        let top = found[0].iter().map(|at| at[1]).fold(0.0, f64::max);
        assert!((49.10..49.11).contains(&top), "{top}");
        let found = lines(&[[point(179.0, 10.0), point(-179.0, 10.0)], [point(-179.0, 10.0), point(-178.0, 10.0)]]);
        assert_eq!(found.len(), 2);
        assert!(found.iter().flatten().all(|at| at[0].abs() > 177.0));
    }
}
