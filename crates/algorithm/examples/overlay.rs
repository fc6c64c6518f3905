//! Overlays parcels with a flood and computes the flooded area of each.

use twinedge_algorithm::area::{face_area, feature_area};
use twinedge_algorithm::contour::of_faces;
use twinedge_algorithm::overlay::{Operation, overlay};
use twinedge_geometry::noding::Snap;
use twinedge_map::{Builder, Feature, Shape};

fn polygon(name: &str, corners: [[f64; 2]; 4]) -> Feature {
    Feature { name: Some(name.to_owned()), shapes: vec![Shape::polygon(corners)], ..Feature::default() }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut parcels = Builder::new();
    parcels.feature(&polygon("the Miller's", [[0.0, 0.0], [40.0, 0.0], [40.0, 30.0], [0.0, 30.0]]))?;
    parcels.feature(&polygon("the Potter's", [[40.0, 0.0], [90.0, 0.0], [90.0, 30.0], [40.0, 30.0]]))?;
    let parcels = parcels.build()?;

    let mut flood = Builder::new();
    let water = flood.feature(&polygon("water", [[20.0, -9.0], [100.0, -9.0], [100.0, 7.0], [20.0, 15.0]]))?;
    let flood = flood.build()?;

    let both = overlay(&parcels, &flood, Snap::Auto)?;
    let mut wet = Vec::new();
    for parcel in parcels.features() {
        let faces: Vec<_> = both.faces(Operation::Intersection, parcel, water).collect();
        let area = faces.iter().map(|face| face_area(both.map(), *face)).sum::<Result<f64, _>>()?;
        println!(
            "{}: {area:.1} of {:.1} under water, with a shore of {} points",
            parcels.name(parcel).unwrap_or_default(),
            feature_area(&parcels, parcel),
            of_faces(both.map(), faces)?.polygons.iter().map(|polygon| polygon.outer.len() - 1).sum::<usize>()
        );
        wet.push(area);
    }
    assert_eq!(wet, [280.0, 525.0]);
    Ok(())
}
