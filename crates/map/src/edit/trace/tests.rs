//! Tests of `trace`.

use crate::planar_map::PlanarMap;
use twinedge_geometry::steps::steps_of;

#[test]
fn a_face_is_looked_at_once_however_many_vertices_are_on_the_way() {
    const POINTS: u32 = 1000;
    let mut map = PlanarMap::new();
    for i in 0..POINTS {
        map.insert_point([f64::from(i), 0.0]).unwrap();
    }
    let (edited, steps) = steps_of(|| map.insert_segment([-1.0, 0.0], [f64::from(POINTS), 0.0]));
    assert_eq!(edited.map(|edited| edited.way.len()), Ok(POINTS as usize + 1));
    assert!(steps < 50 * u64::from(POINTS), "{steps}");
}
