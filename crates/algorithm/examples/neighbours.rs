//! Who borders Switzerland, and how long are the borders?
//!
//! ```text
//! cargo run -p twinedge-algorithm --example neighbours
//! ```

use std::error::Error;
use twinedge_algorithm::neighbours::of_feature;
use twinedge_formats::io::geojson;
use twinedge_map::{Builder, PlanarMap};

fn read(bytes: &[u8]) -> Result<PlanarMap, Box<dyn Error>> {
    let mut builder = Builder::new();
    geojson::read(bytes, |feature| builder.feature(&feature).map(drop).map_err(Box::<dyn Error>::from))?;
    Ok(builder.build()?)
}

fn main() -> Result<(), Box<dyn Error>> {
    let map = read(include_bytes!("../../../cli/data/world-110m.geojson"))?;
    let switzerland = map.features().find(|f| map.name(*f) == Some("Switzerland")).ok_or("it is on the map")?;
    let mut lines = Vec::new();
    for border in of_feature(&map, switzerland) {
        let name = map.name(border.neighbour).unwrap_or("nobody");
        let points: usize = border.borders.iter().map(Vec::len).sum();
        lines.push(format!("{name}: {:.2} degrees, {points} points", border.length));
    }
    lines.sort();
    println!("{}", lines.join("\n"));
    assert_eq!(lines, EXPECTED);
    Ok(())
}

const EXPECTED: [&str; 4] = [
    "Austria: 1.47 degrees, 5 points",
    "France: 3.48 degrees, 8 points",
    "Germany: 2.26 degrees, 4 points",
    "Italy: 4.43 degrees, 10 points",
];
