//! The political map of the world: the contour of a country, its neighbours, one at a coordinate, a colouring, and a route.
//!
//! ```text
//! cargo run -p twinedge-algorithm --example political_map
//! ```

use std::error::Error;
use twinedge_algorithm::colouring::feature_colours;
use twinedge_algorithm::dual::{By, borders, route};
use twinedge_algorithm::{contour, neighbours};
use twinedge_formats::io::geojson;
use twinedge_geometry::Point;
use twinedge_map::{Builder, FeatureId, Located, Locator, PlanarMap};

fn country(map: &PlanarMap, name: &str) -> Result<FeatureId, Box<dyn Error>> {
    Ok(map.features().find(|feature| map.name(*feature) == Some(name)).ok_or("it is on the map")?)
}

fn name(map: &PlanarMap, country: FeatureId) -> &str {
    map.name(country).unwrap_or("a country without name")
}

fn main() -> Result<(), Box<dyn Error>> {
    // Every ring of every country is a chain of segments. A border shared by two countries becomes one edge with a country on
    // each side, and the edges enclose the faces.
    let mut builder = Builder::new();
    let file: &[u8] = include_bytes!("../../../cli/data/world-110m.geojson");
    geojson::read(file, |feature| builder.feature(&feature).map(drop).map_err(Box::<dyn Error>::from))?;
    let map = builder.build()?;
    println!(
        "{} countries, {} vertices, {} edges, {} faces",
        map.features().count(),
        map.dcel().vertex_count(),
        map.dcel().edge_count(),
        map.dcel().face_count()
    );

    // The contour of a country: walk around its faces.
    let switzerland = country(&map, "Switzerland")?;
    let contour = contour::of_feature(&map, switzerland)?;
    println!("The contour of Switzerland has {} points.", contour.polygons[0].outer.len() - 1);
    assert_eq!(contour.polygons.len(), 1);

    // All its neighbours: look across each edge, at the face of the twin.
    let neighbours = neighbours::of_feature(&map, switzerland);
    let mut names: Vec<&str> = neighbours.iter().map(|neighbour| name(&map, neighbour.neighbour)).collect();
    names.sort_unstable();
    println!("Switzerland borders on {}.", names.join(", "));
    assert_eq!(names, ["Austria", "France", "Germany", "Italy"]);

    // Find the country at a coordinate.
    let locator = Locator::new(&map)?;
    for (x, y, expected) in [(7.45, 46.95, "Switzerland"), (28.25, -29.5, "Lesotho"), (116.4, 39.9, "China")] {
        let Located::Face(face) = locator.locate(Point::new(x, y))? else { return Err("it is on a border".into()) };
        let found = map.features_of(face)?.next().ok_or("it is in no country")?;
        println!("({x}, {y}) is in {}.", name(&map, found));
        assert_eq!(name(&map, found), expected);
    }

    // A colouring, verified: no border has the same colour on both sides.
    let colours = feature_colours(&map);
    let graph = borders(&map);
    for edge in graph.edge_indices() {
        let (a, b) = graph.edge_endpoints(edge).ok_or("every edge has ends")?;
        assert_ne!(colours[a.index()], colours[b.index()]);
    }
    let count = colours.iter().max().map_or(0, |largest| largest + 1);
    println!("{count} colours tell all neighbours apart, across {} borders.", graph.edge_count());
    assert!(count <= 6);

    // From country to country.
    let way = route(&map, country(&map, "Portugal")?, country(&map, "China")?, By::Borders).ok_or("there is a way")?;
    let names: Vec<&str> = way.features.iter().map(|country| name(&map, *country)).collect();
    println!("From Portugal to China: {}.", names.join(", "));
    assert_eq!(names, ["Portugal", "Spain", "France", "Germany", "Poland", "Russia", "China"]);
    Ok(())
}
