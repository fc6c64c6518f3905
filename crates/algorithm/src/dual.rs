//! Walks over a map: its faces, vertices and features as graphs for the crate `petgraph`.
//!
//! | graph | nodes | edges | made |
//! | --- | --- | --- | --- |
//! | [`Dual`] | faces, including the unbounded one | edges of the map, each joining the faces on its sides | a view, without copying |
//! | [`Skeleton`] | vertices | edges of the map, each joining its ends | a view, without copying |
//! | [`borders`] | features | pairs of features with a common border | a separate graph |
//!
//! The views implement petgraph's visit traits, so its algorithms run on them directly: shortest paths, components, bridges,
//! articulation points, spanning trees. [`route`] covers the most common use.
//!
//! ```
//! use petgraph::algo::{articulation_points::articulation_points, bridges, connected_components, dijkstra};
//! use twinedge_algorithm::dual::{Dual, Skeleton};
//! use twinedge_map::PlanarMap;
//!
//! // A square with a wall across it, and an edge that dangles.
//! let mut map = PlanarMap::new();
//! map.insert_ring([[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]])?;
//! map.insert_segment([1.0, 0.0], [1.0, 2.0])?;
//! map.insert_segment([2.0, 1.0], [1.5, 1.0])?;
//!
//! // No face is more than one edge away from the outside.
//! let dual = Dual::new(&map);
//! let far = dijkstra(&dual, map.dcel().unbounded_face().key(), None, |_| 1);
//! assert_eq!(far.values().max(), Some(&1));
//!
//! let skeleton = Skeleton::new(&map);
//! assert_eq!(connected_components(&skeleton), 1);
//! assert_eq!(bridges(&skeleton).count(), 1);
//! assert_eq!(articulation_points(&skeleton).len(), 1);
//! # Ok::<(), twinedge_map::edit::EditError>(())
//! ```
//!
//! An edge is a bridge of the skeleton if and only if it has the same face on both sides: it is a loop of the dual. The dual has
//! no bridge, as no edge of the map is a loop; but petgraph (0.8) treats each parallel edge as the only one, so do not use it to
//! find bridges of a dual.

use super::centroid::of_faces;
use super::claims::{faces_by_feature, features_of};
use core::ops::Add;
use petgraph::Undirected;
use petgraph::algo::astar;
use petgraph::graph::{NodeIndex, UnGraph};
use petgraph::visit::{
    Data, EdgeRef, GraphBase, GraphProp, IntoEdgeReferences, IntoEdges, IntoNeighbors, IntoNodeIdentifiers,
    IntoNodeReferences, NodeCompactIndexable, NodeCount, NodeIndexable, Visitable,
};
use std::collections::{BTreeMap, HashSet};
use twinedge::dcel::{Face, FaceKey, HalfEdge, HalfEdgeKey, Vertex, VertexKey};
use twinedge_geometry::Point;
use twinedge_map::{Embedding, FeatureId, PlanarMap};

/// An edge of a [`Dual`] or a [`Skeleton`]. Its weight is the length of the edge of the map.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MapEdge<N> {
    source: N,
    target: N,
    half_edge: HalfEdgeKey,
    length: f64,
}

impl<N: Copy> EdgeRef for MapEdge<N> {
    type NodeId = N;
    type EdgeId = HalfEdgeKey;
    type Weight = f64;

    fn source(&self) -> N {
        self.source
    }

    fn target(&self) -> N {
        self.target
    }

    fn weight(&self) -> &f64 {
        &self.length
    }

    /// The half-edge with the source to its left, for a dual, or at its origin, for a skeleton.
    fn id(&self) -> HalfEdgeKey {
        self.half_edge
    }
}

fn length(map: &PlanarMap, h: HalfEdge<'_>) -> f64 {
    let [a, b] = [h.origin(), h.target()].map(|v| map.point(v.index()));
    (b.x - a.x).hypot(b.y - a.y)
}

/// The nodes of a view: keys by number, and numbers by index of record.
#[derive(Clone, Debug)]
struct Nodes<K> {
    keys: Vec<K>,
    numbers: Vec<u32>,
}

impl<K> Nodes<K> {
    fn new(records: impl Iterator<Item = (usize, K)>) -> Self {
        let mut nodes = Self { keys: Vec::new(), numbers: Vec::new() };
        for (index, key) in records {
            nodes.numbers.resize(index + 1, u32::MAX);
            nodes.numbers[index] = nodes.keys.len() as u32;
            nodes.keys.push(key);
        }
        nodes
    }
}

macro_rules! view {
    ($(#[$doc:meta])* $name:ident, $key:ident, $all:ident, $record:ident, $side:expr, $leaving:expr) => {
        $(#[$doc])*
        #[derive(Clone, Debug)]
        pub struct $name<'m> {
            map: &'m PlanarMap,
            nodes: Nodes<$key>,
        }

        impl<'m> $name<'m> {
            /// Creates the view of a map. O(records).
            #[must_use]
            pub fn new(map: &'m PlanarMap) -> Self {
                Self { map, nodes: Nodes::new(map.dcel().$all().map(|node| (node.index(), node.key()))) }
            }

            fn edge(&self, h: HalfEdge<'_>) -> MapEdge<$key> {
                let side: fn(HalfEdge<'_>) -> $key = $side;
                MapEdge { source: side(h), target: side(h.twin()), half_edge: h.key(), length: length(self.map, h) }
            }
        }

        impl GraphBase for $name<'_> {
            type NodeId = $key;
            type EdgeId = HalfEdgeKey;
        }

        impl Data for $name<'_> {
            type NodeWeight = ();
            type EdgeWeight = f64;
        }

        impl GraphProp for $name<'_> {
            type EdgeType = Undirected;
        }

        impl NodeCount for $name<'_> {
            fn node_count(&self) -> usize {
                self.nodes.keys.len()
            }
        }

        /// Numbers from 0, without gaps.
        impl NodeIndexable for $name<'_> {
            fn node_bound(&self) -> usize {
                self.nodes.keys.len()
            }

            /// Returns `usize::MAX` for a stale key.
            fn to_index(&self, node: $key) -> usize {
                let number = self.map.dcel().$record(node).ok().and_then(|node| self.nodes.numbers.get(node.index()));
                number.map_or(usize::MAX, |number| *number as usize)
            }

            /// Returns the null key for a number out of range.
            fn from_index(&self, number: usize) -> $key {
                self.nodes.keys.get(number).copied().unwrap_or_default()
            }
        }

        impl NodeCompactIndexable for $name<'_> {}

        impl Visitable for $name<'_> {
            type Map = HashSet<$key>;

            fn visit_map(&self) -> Self::Map {
                HashSet::with_capacity(self.nodes.keys.len())
            }

            fn reset_map(&self, map: &mut Self::Map) {
                map.clear();
            }
        }

        impl<'g> IntoNodeIdentifiers for &'g $name<'_> {
            type NodeIdentifiers = core::iter::Copied<core::slice::Iter<'g, $key>>;

            fn node_identifiers(self) -> Self::NodeIdentifiers {
                self.nodes.keys.iter().copied()
            }
        }

        impl<'g> IntoNodeReferences for &'g $name<'_> {
            type NodeRef = ($key, &'g ());
            type NodeReferences = Box<dyn ExactSizeIterator<Item = Self::NodeRef> + 'g>;

            fn node_references(self) -> Self::NodeReferences {
                Box::new(self.nodes.keys.iter().map(|key| (*key, &())))
            }
        }

        /// Yields each edge of the map once.
        impl<'g> IntoEdgeReferences for &'g $name<'_> {
            type EdgeRef = MapEdge<$key>;
            type EdgeReferences = Box<dyn Iterator<Item = MapEdge<$key>> + 'g>;

            fn edge_references(self) -> Self::EdgeReferences {
                Box::new(self.map.dcel().edges().map(|h| self.edge(h)))
            }
        }

        /// Yields each edge at the node once, with the node as its source; nothing for a stale key.
        impl<'g> IntoEdges for &'g $name<'_> {
            type Edges = Box<dyn Iterator<Item = MapEdge<$key>> + 'g>;

            fn edges(self, node: $key) -> Self::Edges {
                let node = self.map.dcel().$record(node).ok();
                let edges = node.into_iter().flat_map($leaving).map(|h| (h.index() < h.twin().index(), self.edge(h)));
                // Both half-edges of a loop are at the node.
                Box::new(edges.filter(|(first, edge)| *first || edge.source != edge.target).map(|(_, edge)| edge))
            }
        }

        impl<'g> IntoNeighbors for &'g $name<'_> {
            type Neighbors = Box<dyn Iterator<Item = $key> + 'g>;

            fn neighbors(self, node: $key) -> Self::Neighbors {
                Box::new(self.edges(node).map(|edge| edge.target))
            }
        }
    };
}

view! {
    /// The dual of a map: its faces, joined across its edges. Two faces with several common edges are joined several times, and
    /// an edge with one face on both sides is a loop.
    Dual, FaceKey, faces, face, |h| h.face().key(), |face: Face<'g>| face.half_edges()
}

view! {
    /// The vertices of a map, joined by its edges.
    Skeleton, VertexKey, vertices, vertex, |h| h.origin().key(), |vertex: Vertex<'g>| vertex.rotation()
}

/// Returns the features of a map as a graph, joined where they have a [common border](super::neighbours), weighted by the length
/// of the border; the number of a node is [`FeatureId::index`]. For overlapping features, the length is the mean from both sides.
///
/// O(edges · k² · log) for edges with up to k features on a side.
///
/// ```
/// use petgraph::algo::connected_components;
/// use twinedge_algorithm::dual::borders;
/// use twinedge_map::{Builder, Shape};
///
/// let square = |x: f64| [[x, 0.0], [x + 1.0, 0.0], [x + 1.0, 1.0], [x, 1.0]];
/// let mut builder = Builder::new();
/// for x in [0.0, 1.0, 5.0] {
///     builder.shape(&Shape::polygon(square(x)))?;
/// }
/// let graph = borders(&builder.build()?);
/// assert_eq!((graph.node_count(), graph.edge_count(), connected_components(&graph)), (3, 1, 2));
/// assert_eq!(graph.edge_weights().next(), Some(&1.0));
/// # Ok::<(), twinedge_map::BuildError>(())
/// ```
#[must_use]
pub fn borders(map: &PlanarMap) -> UnGraph<FeatureId, f64> {
    let mut lengths: BTreeMap<[FeatureId; 2], f64> = BTreeMap::new();
    for h in map.dcel().edges() {
        let [left, right] = [h.face(), h.twin().face()].map(|face| features_of(map, face).collect::<Vec<_>>());
        for (a, b) in left.iter().flat_map(|a| right.iter().map(move |b| (*a, *b))) {
            // One of them ends here, or both do.
            let ending = u8::from(!right.contains(&a)) + u8::from(!left.contains(&b));
            if a != b && ending > 0 {
                *lengths.entry([a.min(b), a.max(b)]).or_default() += length(map, h) * f64::from(ending) / 2.0;
            }
        }
    }
    let mut graph = UnGraph::with_capacity(map.features().count(), lengths.len());
    for feature in map.features() {
        graph.add_node(feature);
    }
    for ([a, b], length) in lengths {
        graph.add_edge(NodeIndex::new(a.index()), NodeIndex::new(b.index()), length);
    }
    graph
}

/// The measure of a route.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum By {
    /// Few borders; on a tie, the shortest route from centroid to centroid.
    #[default]
    Borders,
    /// A short route from centroid to centroid.
    Length,
}

/// A route between two features.
#[derive(Clone, Debug, PartialEq)]
pub struct Route {
    /// The features, including both ends.
    pub features: Vec<FeatureId>,
    /// The sum of the distances between the centroids of successive features, in the units of the coordinates.
    pub length: f64,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
struct Cost {
    borders: u32,
    length: f64,
}

impl Add for Cost {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self { borders: self.borders + other.borders, length: self.length + other.length }
    }
}

/// Returns the best route between two features across borders; `None` if there is none, or if one is not a feature of the map.
///
/// O(edges of the map · log), plus the cost of [`borders`].
///
/// ```
/// use twinedge_algorithm::dual::{By, route};
/// use twinedge_map::{Builder, Shape};
///
/// let square = |x: f64| [[x, 0.0], [x + 1.0, 0.0], [x + 1.0, 1.0], [x, 1.0]];
/// let mut builder = Builder::new();
/// let mut ids = Vec::new();
/// for x in [0.0, 1.0, 2.0] {
///     ids.push(builder.shape(&Shape::polygon(square(x)))?);
/// }
/// let map = builder.build()?;
/// let way = route(&map, ids[0], ids[2], By::Borders).unwrap();
/// assert_eq!((way.features, way.length), (ids, 2.0));
/// # Ok::<(), twinedge_map::BuildError>(())
/// ```
#[must_use]
pub fn route(map: &PlanarMap, from: FeatureId, to: FeatureId, by: By) -> Option<Route> {
    let graph = borders(map);
    let [start, end] = [from, to].map(|feature| NodeIndex::new(feature.index()));
    graph.node_weight(start).and(graph.node_weight(end))?;
    let centroid = |faces: Vec<FaceKey>| {
        let faces: Vec<Face<'_>> = faces.into_iter().filter_map(|face| map.dcel().face(face).ok()).collect();
        of_faces(map, &faces)
    };
    let centroids: Vec<Option<Point>> = faces_by_feature(map).into_iter().map(centroid).collect();
    // A feature with a border covers a face, so it has a centroid unless numbers overflow.
    let distance = |a: NodeIndex, b: NodeIndex| {
        let both = centroids[a.index()].zip(centroids[b.index()]);
        both.map_or(0.0, |(a, b)| (b.x - a.x).hypot(b.y - a.y))
    };
    let step = |edge: petgraph::graph::EdgeReference<'_, f64>| {
        let length = distance(edge.source(), edge.target());
        Cost { borders: u32::from(by == By::Borders), length }
    };
    let (_, nodes) = astar(&graph, start, |node| node == end, step, |_| Cost::default())?;
    let length = nodes.windows(2).map(|pair| distance(pair[0], pair[1])).sum();
    Some(Route { features: nodes.into_iter().map(|node| graph[node]).collect(), length })
}
