//! The outline of South Africa, with the hole that is Lesotho, and of both together, without it.
//!
//! ```text
//! cargo run -p twinedge-algorithm --example contour
//! ```

use std::error::Error;
use twinedge_algorithm::claims::faces_of;
use twinedge_algorithm::contour;
use twinedge_algorithm::contour::Contour;
use twinedge_formats::io::{geojson, wkt};
use twinedge_map::{Builder, Feature, FeatureId, PlanarMap};

fn read(bytes: &[u8]) -> Result<PlanarMap, Box<dyn Error>> {
    let mut builder = Builder::new();
    geojson::read(bytes, |feature| builder.feature(&feature).map(drop).map_err(Box::<dyn Error>::from))?;
    Ok(builder.build()?)
}

fn named(map: &PlanarMap, name: &str) -> Result<FeatureId, Box<dyn Error>> {
    Ok(map.features().find(|f| map.name(*f) == Some(name)).ok_or("it is on the map")?)
}

fn line(what: &str, contour: &Contour) -> String {
    let holes: usize = contour.polygons.iter().map(|p| p.holes.len()).sum();
    format!("{what}: {} polygon(s), {holes} hole(s), {:.2} square degrees", contour.polygons.len(), contour.area())
}

fn main() -> Result<(), Box<dyn Error>> {
    let map = read(include_bytes!("../../../cli/data/world-110m.geojson"))?;
    let (south_africa, lesotho) = (named(&map, "South Africa")?, named(&map, "Lesotho")?);

    let outline = contour::of_feature(&map, south_africa)?;
    let faces = [south_africa, lesotho].into_iter().flat_map(|feature| faces_of(&map, feature));
    let together = contour::of_faces(&map, faces)?;
    let enclave = contour::of_feature(&map, lesotho)?;
    let lines = [line("South Africa", &outline), line("with Lesotho", &together), line("Lesotho", &enclave)];
    println!("{}", lines.join("\n"));
    assert_eq!(lines, EXPECTED);

    // The hole is the outline of Lesotho, the other way round.
    let mut hole = outline.polygons[0].holes[0].clone();
    hole.reverse();
    assert_eq!(hole, enclave.polygons[0].outer);

    let mut text = Vec::new();
    wkt::write(&mut text, &[Feature::from(enclave)])?;
    print!("{}", String::from_utf8(text)?);
    Ok(())
}

const EXPECTED: [&str; 3] = [
    "South Africa: 1 polygon(s), 1 hole(s), 112.72 square degrees",
    "with Lesotho: 1 polygon(s), 0 hole(s), 115.28 square degrees",
    "Lesotho: 1 polygon(s), 0 hole(s), 2.56 square degrees",
];
