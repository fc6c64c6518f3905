//! The claim of the lectures: adding a vertex, adding an edge and removing one changes a fixed number of rows in the three
//! tables. Prints the tables before and after each step, with the changed rows.
//!
//! ```text
//!   v1 ────e1──── v2      v1 ──e1── v5 ──e5── v2      v1 ──e1── v5 ──e5── v2
//!     \         /           \               /           \       │       /
//!      e3     e4             e3           e4             e3     e6    e4
//!        \   /                 \         /                 \    │   /
//!         v3 ──e2── v4          v3 ──e2── v4                 \  │ /
//!                                                              v3 ──e2── v4
//!   the map               a vertex on e1              an edge from corner to corner; then e2 is removed
//! ```
//!
//! ```text
//! cargo run -p twinedge-map --example constant_time_updates
//! ```

use std::collections::BTreeSet;
use std::error::Error;
use twinedge::dcel::{Dcel, Side, Split, VertexKey};
use twinedge::validate::{Collect, Expectation};
use twinedge_formats::textbook::Textbook;
use twinedge_geometry::Point;
use twinedge_map::validate_embedding;

/// A structure with separate coordinates.
#[derive(Default)]
struct Drawing {
    dcel: Dcel,
    places: Vec<(VertexKey, Point)>,
}

impl Drawing {
    fn tables(&self) -> Textbook {
        Textbook::of(&self.dcel, |v| {
            let key = self.dcel.vertex_at(v)?.key();
            self.places.iter().find(|(vertex, _)| *vertex == key).map(|(_, place)| *place)
        })
    }

    /// Prints the tables, and returns the names of the new, removed or changed rows.
    fn show(&self, what: &str, before: &mut String) -> Result<Vec<String>, Box<dyn Error>> {
        let tables = self.tables();
        let report = validate_embedding(&tables, &Expectation::plane(), Collect::All);
        if !report.is_valid() {
            return Err(report.to_string().into());
        }
        let after = tables.to_string();
        println!("=== {what} ===\n\n{after}");
        // Rows, independent of the widths of the columns.
        let rows = |text: &str| -> BTreeSet<Vec<String>> {
            text.lines().map(|line| line.split_whitespace().map(str::to_owned).collect()).collect()
        };
        let (old, new) = (rows(before), rows(&after));
        let names: BTreeSet<String> = old.symmetric_difference(&new).filter_map(|row| row.first().cloned()).collect();
        *before = after;
        Ok(names.into_iter().collect())
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut drawing = Drawing::default();
    let outside = drawing.dcel.unbounded_face().key();
    let mut vertices = Vec::new();
    for place in [[0.0, 2.0], [2.0, 2.0], [1.0, 0.0], [3.0, 0.0]] {
        let vertex = drawing.dcel.add_isolated_vertex(outside)?.vertex;
        drawing.places.push((vertex, place.into()));
        vertices.push(vertex);
    }
    let dcel = &mut drawing.dcel;
    let e1 = dcel.connect(vertices[0], vertices[1], Split::default())?.half_edge;
    let from_v3 = dcel.connect(vertices[2], vertices[3], Split::default())?.half_edge;
    // From v3 to v1, next to e2. From v3 to v2, between them: that closes the triangle, which lies to the left.
    dcel.connect(from_v3, e1, Split::default())?;
    let at_v2 = dcel.at(e1).twin().key();
    dcel.connect(from_v3, at_v2, Split { new_face: Side::Left, inner: &[] })?;
    let mut before = String::new();
    drawing.show("the map", &mut before)?;

    // A vertex on e1 adds an edge and a vertex, and changes the rows of their neighbours.
    let split = drawing.dcel.split_edge(e1)?;
    drawing.places.push((split.vertex, Point::new(1.0, 2.0)));
    let changed = drawing.show("a vertex on e1", &mut before)?;
    println!("changed: {}\n", changed.join(", "));
    let mut all_changed = vec![changed];

    // An edge between two corners of f2, given by the half-edges that start there with f2 to their left.
    let triangle = drawing.dcel.at(e1).twin().face();
    let corner = |vertex: VertexKey| triangle.half_edges().find(|h| h.origin().key() == vertex).map(|h| h.key());
    let (from, to) = (corner(vertices[2]).ok_or("v3")?, corner(split.vertex).ok_or("v5")?);
    drawing.dcel.connect(from, to, Split::default())?;
    let changed = drawing.show("an edge from v3 to v5", &mut before)?;
    println!("changed: {}\n", changed.join(", "));
    all_changed.push(changed);

    drawing.dcel.remove_edge(from_v3)?;
    let changed = drawing.show("without e2", &mut before)?;
    println!("changed: {}", changed.join(", "));
    all_changed.push(changed);
    assert_eq!(all_changed, [ADDED_VERTEX, ADDED_EDGE, REMOVED_EDGE]);
    Ok(())
}

/// The new vertex, the two new half-edges, their neighbours, and the vertex that keeps the new edge.
const ADDED_VERTEX: &[&str] = &["e1,1", "e1,2", "e4,1", "e4,2", "e5,1", "e5,2", "v2", "v5"];
/// The new edge, the new face, the half-edges next to its ends, and those of the shorter cycle, with a changed face.
const ADDED_EDGE: &[&str] = &["e1,2", "e3,2", "e4,1", "e5,2", "e6,1", "e6,2", "f2", "f3"];
/// The removed edge, the half-edges next to it, its ends, and the face, in which one of them is now isolated.
const REMOVED_EDGE: &[&str] = &["e2,1", "e2,2", "e3,1", "e4,2", "f1", "v3", "v4"];
