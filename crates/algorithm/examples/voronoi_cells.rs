//! The nearest post office: the Voronoi diagram of a few places as a map, and its dual, the Delaunay triangulation.
//!
//! ```text
//! cargo run -p twinedge-algorithm --example voronoi_cells
//! ```

use std::collections::BTreeSet;
use std::error::Error;
use twinedge_algorithm::area::face_area;
use twinedge_algorithm::neighbours;
use twinedge_algorithm::voronoi::{delaunay, voronoi};
use twinedge_geometry::Point;
use twinedge_map::{Located, Locator};

const OFFICES: [(&str, f64, f64); 6] = [
    ("Airport", 9.0, 8.0),
    ("Bridge", 4.0, 3.0),
    ("Castle", 1.0, 9.0),
    ("Docks", 8.0, 1.0),
    ("East Gate", 6.0, 5.0),
    ("Fair", 2.0, 1.0),
];

fn main() -> Result<(), Box<dyn Error>> {
    let sites = OFFICES.map(|(_, x, y)| Point::new(x, y));
    let diagram = voronoi(&sites, Some([Point::new(0.0, 0.0), Point::new(10.0, 10.0)]))?;
    assert!(diagram.map.validate().is_valid());

    // Each office has a cell; its neighbours are across the edges.
    let mut borders = BTreeSet::new();
    for (site, (name, ..)) in OFFICES.iter().enumerate() {
        let around = neighbours::of_face(&diagram.map, diagram.cells[site])?;
        let beside: Vec<usize> =
            around.iter().filter_map(|n| diagram.cells.iter().position(|cell| *cell == n.neighbour)).collect();
        let names: Vec<&str> = beside.iter().map(|other| OFFICES[*other].0).collect();
        println!(
            "{name}: {:.2} square miles, beside {}",
            face_area(&diagram.map, diagram.cells[site])?,
            names.join(", ")
        );
        borders.extend(beside.into_iter().map(|other| [site.min(other), site.max(other)]));
    }

    // The nearest office of a place is the site of its cell.
    let locator = Locator::new(&diagram.map)?;
    let home = Point::new(5.0, 3.5);
    let Located::Face(cell) = locator.locate(home)? else { return Err("two offices are nearest".into()) };
    let nearest = diagram.cells.iter().position(|other| *other == cell).ok_or("every cell has a site")?;
    println!("From ({}, {}) it is nearest to {}.", home.x, home.y, OFFICES[nearest].0);
    assert_eq!(OFFICES[nearest].0, "Bridge");

    // The dual: offices are joined if their cells have a common border, inside or outside the box.
    let triangles = delaunay(&sites)?;
    let number = |v| triangles.vertices.iter().position(|vertex| *vertex == v);
    let joined: BTreeSet<[usize; 2]> = { triangles.map.dcel().half_edges() }
        .filter_map(|h| Some([number(h.origin().key())?, number(h.target().key())?]))
        .filter(|[a, b]| a < b)
        .collect();
    println!("{} borders in the box, {} edges between offices", borders.len(), joined.len());
    assert!(borders.is_subset(&joined));
    Ok(())
}
