//! A floor plan cut into convex rooms: triangulates, examines each diagonal once, and keeps the essential ones.
//!
//! ```text
//! cargo run -p twinedge-algorithm --example convex_pieces
//! ```

use std::error::Error;
use twinedge_algorithm::area::face_area;
use twinedge_algorithm::convex::{is_essential, triangulate};
use twinedge_map::PlanarMap;

fn main() -> Result<(), Box<dyn Error>> {
    // ┌─────────────────┐
    // │   ┌───┐         │   an L with a column in it, and a wall that ends in the room
    // │   └───┘     │   │
    // │         ┌───┴───┘
    // │         │
    // └─────────┘
    let mut map = PlanarMap::new();
    let walls = [[0.0, 0.0], [5.0, 0.0], [5.0, 3.0], [7.0, 3.0], [9.0, 3.0], [9.0, 7.0], [0.0, 7.0]];
    let room = map.insert_ring(walls)?.faces_split[0].1;
    map.insert_ring([[2.0, 4.0], [4.0, 4.0], [4.0, 6.0], [2.0, 6.0]])?;
    map.insert_segment([7.0, 3.0], [7.0, 5.0])?;
    let area = face_area(&map, room)?;

    // The triangulation is the map itself: the diagonals are its edges, and only their list is kept separately.
    let triangulation = triangulate(&mut map, [room])?.remove(0);
    println!(
        "{} triangles by {} diagonals; {} reflex corners",
        triangulation.triangles,
        triangulation.diagonals.len(),
        triangulation.reflex
    );

    // Each diagonal is examined once: two links and one exact predicate at each end.
    let mut pieces = triangulation.triangles;
    for diagonal in triangulation.diagonals {
        let h = map.dcel().at(diagonal);
        let [a, b] = [map[h.origin().key()], map[h.target().key()]];
        let line = format!("({}, {})-({}, {})", a.x, a.y, b.x, b.y);
        if is_essential(&map, diagonal)? {
            println!("  {line} is essential");
        } else {
            map.remove_edge(diagonal)?;
            pieces -= 1;
            println!("  {line} goes: {pieces} pieces left");
        }
    }

    // The pieces are faces of the map, along with the column and the outside.
    assert!(map.validate().is_valid());
    assert_eq!(map.dcel().face_count(), pieces + 2);
    let covered: f64 =
        map.dcel().faces().filter_map(|face| face_area(&map, face.key()).ok()).filter(|a| a.is_finite()).sum();
    assert!((covered - (area + 4.0)).abs() < 1e-12);
    Ok(())
}
