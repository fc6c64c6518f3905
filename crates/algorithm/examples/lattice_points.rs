//! Pick's theorem on a small map: the area of a face from its lattice points.
//!
//! ```text
//! cargo run -p twinedge-algorithm --example lattice_points
//! ```

use std::error::Error;
use twinedge_algorithm::lattice::of_map;
use twinedge_map::PlanarMap;

fn main() -> Result<(), Box<dyn Error>> {
    // The polygon of the lecture, with 30 lattice points inside and 22 on its boundary, and a hole.
    let mut map = PlanarMap::new();
    map.insert_ring([[0.0, 0.0], [5.0, 0.0], [5.0, 4.0], [2.0, 10.0], [0.0, 9.0]])?;
    show(&map)?;
    assert_eq!(of_map(&map)?.total.area_doubled, 2 * 40);
    map.insert_ring([[1.0, 2.0], [3.0, 2.0], [2.0, 4.0]])?;
    show(&map)
}

fn show(map: &PlanarMap) -> Result<(), Box<dyn Error>> {
    let counts = of_map(map)?;
    for (face, count) in &counts.faces {
        let [interior, boundary, holes] = [count.interior, count.boundary, count.holes];
        let area = count.area_doubled as f64 / 2.0;
        let face = map.dcel().face(*face)?.index();
        println!("f{face}: A = {area} = I + B/2 - 1 + h = {interior} + {boundary}/2 - 1 + {holes}");
        assert!(count.pick_holds());
    }
    assert!(counts.pick_holds());
    println!();
    Ok(())
}
