//! Editing a map: draws two countries and a lake, lays a road across them, moves a border post, and removes the border. A
//! separate land register follows the reports of each edit.
//!
//! ```text
//! cargo run -p twinedge-map --example edit_a_map
//! ```

use std::error::Error;
use twinedge::dcel::FaceKey;
use twinedge_geometry::noding::Snap;
use twinedge_map::PlanarMap;
use twinedge_map::edit::{EditError, Edited};

/// Data stored alongside a map: the name of each piece of land.
struct Register {
    lots: Vec<(FaceKey, String)>,
}

impl Register {
    fn name(&self, face: FaceKey) -> &str {
        self.lots.iter().find(|(lot, _)| *lot == face).map_or("?", |(_, name)| name)
    }

    /// Splits and merges lots as the map did.
    fn follow(&mut self, edited: &Edited) {
        for (kept, gone) in &edited.faces_merged {
            let name = format!("{} with {}", self.name(*kept), self.name(*gone));
            self.lots.retain(|(lot, _)| lot != kept && lot != gone);
            self.lots.push((*kept, name));
        }
        for (kept, made) in &edited.faces_split {
            let name = format!("part of {}", self.name(*kept));
            self.lots.push((*made, name));
        }
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut map = PlanarMap::new();
    let grid = Snap::Size(1.0 / 1024.0);
    let mut register = Register { lots: vec![(map.dcel().unbounded_face().key(), "the sea".to_owned())] };

    // The land, and a border across it: its ends lie on the coast, which it splits.
    let coast = map.insert_ring([[0.0, 0.0], [12.0, 0.0], [12.0, 8.0], [0.0, 8.0]])?;
    let (_, land) = coast.faces_split[0];
    register.lots.push((land, "Westland".to_owned()));
    let border = map.insert_segment([6.0, 0.0], [6.0, 8.0])?;
    let northwards = map.dcel().at(border.way[0]);
    let (west, east) = (northwards.face().key(), northwards.twin().face().key());
    register.lots.retain(|(lot, _)| *lot != land);
    register.lots.extend([(west, "Westland".to_owned()), (east, "Eastland".to_owned())]);
    println!("the border splits {} edges and {} face", border.edges_split.len(), border.faces_split.len());
    assert_eq!((border.edges_split.len(), border.faces_split.len()), (2, 1));

    // Countries are features, and cover faces.
    for (face, name) in [(west, "Westland"), (east, "Eastland")] {
        let country = map.add_feature(Some(name.to_owned()));
        map.set_features_of(face, [country])?;
    }
    let covered = |map: &PlanarMap, face| -> Result<Vec<String>, Box<dyn Error>> {
        Ok(map.features_of(face)?.filter_map(|f| map.name(f)).map(str::to_owned).collect())
    };

    // A lake in the east. It also belongs to Eastland, like the area before.
    let lake = map.insert_ring([[8.0, 3.0], [10.0, 3.0], [9.0, 5.0]])?;
    register.follow(&lake);
    let (_, water) = lake.faces_split[0];
    println!("the lake is {}, covered by {:?}", register.name(water), covered(&map, water)?);
    assert_eq!(register.name(water), "part of Eastland");
    assert_eq!(covered(&map, water)?, ["Eastland"]);

    // A road may not cross the border exactly: in general no double is exactly at the crossing.
    let refused = map.insert_segment([1.0, 1.0], [11.0, 2.0]);
    println!(
        "an exact road: {}",
        refused.as_ref().err().map_or("laid".to_owned(), |_| "it would cross an edge".to_owned())
    );
    assert!(matches!(refused, Err(EditError::Crosses(_))));
    let road = map.insert_segment_snapped([1.0, 1.0], [11.0, 2.0], grid)?;
    register.follow(&road);
    println!("a rounded road: {} edges, through a new vertex on the border", road.way.len());
    assert_eq!((road.way.len(), road.edges_split.len()), (2, 1));

    // The border post at the crossing moves a bit; it may not move into the lake.
    let post = map.dcel().at(road.way[0]).target().key();
    map.move_vertex(post, [6.5, 1.5])?;
    let into_the_lake = map.move_vertex(post, [9.0, 3.5]);
    println!("the post moves to {:?}, and not into the lake", map[post]);
    assert!(matches!(into_the_lake, Err(EditError::EdgeInTheWay(_) | EditError::VertexInTheWay(_))));

    // The border is removed, edge by edge. Areas with one country on each side are then covered by neither.
    let (south, north) = road.edges_split[0];
    for h in [south, north] {
        let edited = map.remove_edge(h)?;
        register.follow(&edited);
        for (_, feature) in &edited.features_dropped {
            println!("{} no longer covers all of one face", map.name(*feature).unwrap_or("?"));
        }
    }
    let union = map.dcel().at(road.way[0]).face().key();
    println!("the land is {}, covered by {:?}", register.name(union), covered(&map, union)?);
    assert!(covered(&map, union)?.is_empty());
    assert!(register.name(union).contains("with"));

    let report = map.validate();
    println!("{report}");
    assert!(report.is_valid());
    Ok(())
}
