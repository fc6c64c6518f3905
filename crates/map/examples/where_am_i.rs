//! Locating points and the borders ahead: points and lines on a map of the world.
//!
//! Builds the map of all countries, then finds the country of a point and the borders on a flight. Answers are exact.
//!
//! ```text
//! cargo run -p twinedge-map --example where_am_i
//! ```

use std::error::Error;
use twinedge::dcel::FaceKey;
use twinedge_formats::io::geojson;
use twinedge_geometry::Point;
use twinedge_map::{Builder, Located, Locator, PlanarMap, QueryLine, ZoneElement};

fn world() -> Result<PlanarMap, Box<dyn Error>> {
    let mut builder = Builder::new();
    geojson::read(include_bytes!("../../../tests/data/world-50m.geojson").as_slice(), |feature| {
        builder.feature(&feature)?;
        Ok::<(), Box<dyn Error>>(())
    })?;
    Ok(builder.build()?)
}

/// The countries that claim a face; "the ocean" for the unbounded face, "a lake" for another unclaimed face.
fn name(map: &PlanarMap, face: FaceKey) -> Result<String, Box<dyn Error>> {
    let names: Vec<&str> = map.features_of(face)?.filter_map(|feature| map.name(feature)).collect();
    Ok(match names[..] {
        [] if map.dcel().face(face)?.is_unbounded() => "the ocean".to_owned(),
        [] => "a lake".to_owned(),
        _ => names.join(" and "),
    })
}

/// The countries on both sides of a border.
fn border(map: &PlanarMap, located: Located) -> Result<String, Box<dyn Error>> {
    Ok(match located {
        Located::Face(face) => name(map, face)?,
        Located::Edge(half_edge) => {
            let h = map.dcel().at(half_edge);
            let (left, right) = (h.face().key(), h.twin().face().key());
            format!("the border of {} and {}", name(map, left)?, name(map, right)?)
        }
        Located::Vertex(vertex) => {
            let around = map.dcel().at(vertex).rotation().map(|h| h.face().key());
            let names: Result<Vec<String>, _> = around.map(|face| name(map, face)).collect();
            format!("the corner of {}", names?.join(", "))
        }
    })
}

fn main() -> Result<(), Box<dyn Error>> {
    let map = world()?;
    let locator = Locator::new(&map)?;

    for (x, y, expected) in
        [(28.25, -29.5, "Lesotho"), (24.0, -29.0, "South Africa"), (51.0, 42.0, "a lake"), (-30.0, 0.0, "the ocean")]
    {
        let found = border(&map, locator.locate(Point::new(x, y))?)?;
        println!("{x}, {y} lies in {found}");
        assert_eq!(found, expected);
    }
    // A vertex where three borders meet: for example of Austria, Liechtenstein and Switzerland.
    let meet = |f: &str| map.features().find(|feature| map.name(*feature) == Some(f));
    let countries = ["Austria", "Liechtenstein", "Switzerland"].map(meet);
    let corner = map.dcel().vertices().find(|v| {
        let around =
            |f| v.rotation().any(|h| map.features_of(h.face().key()).is_ok_and(|mut all| all.any(|g| Some(g) == f)));
        countries.into_iter().all(around)
    });
    let corner = corner.ok_or("there is one")?;
    let p = map[corner.key()];
    println!("{}, {} is {}", p.x, p.y, border(&map, locator.locate(p)?)?);
    assert_eq!(locator.locate(p)?, Located::Vertex(corner.key()));

    // Straight east from the Atlantic to the Indian Ocean.
    let flight = QueryLine::Segment(Point::new(5.0, 1.5), Point::new(50.0, 1.5));
    let mut way: Vec<String> = Vec::new();
    let mut borders = 0;
    for met in locator.zone(&flight)? {
        match met {
            ZoneElement::Face(face) => way.push(name(&map, face)?),
            ZoneElement::Edge(_) => borders += 1,
            ZoneElement::Along(_) | ZoneElement::Vertex(_) => {}
        }
    }
    println!("From 5 to 50 degrees east, 1.5 north: {}", way.join(", "));
    assert_eq!(borders, way.len() - 1);
    way.dedup();
    assert_eq!(
        (way.first().map(String::as_str), way.last().map(String::as_str)),
        (Some("the ocean"), Some("the ocean"))
    );
    let countries = ["Eq. Guinea", "Gabon", "Congo", "Dem. Rep. Congo", "Uganda", "Kenya", "Somalia"];
    assert!(way.iter().map(String::as_str).filter(|name| !name.starts_with("the ") && *name != "a lake").eq(countries));
    Ok(())
}
