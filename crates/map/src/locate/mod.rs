//! Point location by an index.
//!
//! | | build | query | for |
//! | --- | --- | --- | --- |
//! | [`Locator`] | O(n log n) | O(log n) | many queries on one map |
//! | [`PlanarMap::locate`](crate::PlanarMap::locate) | once, O(n log n), then maintained through edits | O(log n) on most maps, O(n) at worst | a map that changes between queries |
//!
//! Both are exact: a point is at a vertex, inside an edge or in a face, without any tolerance.
//!
//! ```text
//!    ●────────────●
//!    │      f     │      p: in face f
//!    │  p      q  r      q: in face f, however near to the edge
//!    │            │      r: inside the edge
//!    ●────────────●
//! ```
//!
//! ```
//! use twinedge_geometry::Point;
//! use twinedge_map::{Builder, Located, Locator, Shape};
//!
//! let square = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]];
//! let lake = [[1.0, 1.0], [2.0, 1.0], [1.0, 2.0]];
//! let mut builder = Builder::new();
//! let land = builder.shape(&Shape::polygon(square).hole(lake))?;
//! let map = builder.build()?;
//!
//! let locator = Locator::new(&map)?;
//! let Located::Face(face) = locator.locate(Point::new(3.0, 3.0))? else { panic!("it is inside") };
//! assert!(map.features_of(face)?.eq([land]));
//! let Located::Face(lake) = locator.locate(Point::new(1.25, 1.25))? else { panic!("it is inside") };
//! assert_eq!(map.features_of(lake)?.count(), 0);
//! assert!(matches!(locator.locate(Point::new(1.5, 1.5))?, Located::Edge(_)));
//! assert!(matches!(locator.locate(Point::new(4.0, 4.0))?, Located::Vertex(_)));
//! assert_eq!(locator.locate(Point::new(5.0, 4.0))?, Located::Face(map.dcel().unbounded_face().key()));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # How
//!
//! The map is cut into slabs so that few edges pass from one to the next (see `slabs.rs`). The index of a slab is the search
//! graph of its trapezoidal map (see `trapezoids.rs`): O(n) memory and O(log n) per query, for every map. In front of it is a
//! grid of about one cell per edge. A cell that no edge meets stores its face, so most searches end in the grid. Other cells
//! store the place in the graph where their points diverge. The graph determines the worst case: the grid has no lists.

mod cells;
mod graph;
pub(crate) mod in_face;
mod kept;
mod lists;
pub(crate) mod located;
pub(crate) mod locator;
mod slabs;
mod trapezoids;

pub use located::{LocateError, Located};
pub use locator::Locator;
