//! A map as a graph: results of petgraph compared with the structure.

use crate::planar::{self, noded};
use petgraph::algo::articulation_points::articulation_points;
use petgraph::algo::{bridges, connected_components, dijkstra};
use petgraph::visit::{Bfs, EdgeRef, IntoEdgeReferences, IntoEdges, IntoNeighbors, NodeCount, NodeIndexable};
use quickcheck::QuickCheck;
use std::collections::{BTreeMap, BTreeSet};
use twinedge::dcel::{FaceKey, StaleKey, Vertex, VertexKey};
use twinedge_algorithm::centroid::{face_centroid, feature_centroid};
use twinedge_algorithm::claims::faces_of;
use twinedge_algorithm::dual::{By, Dual, Skeleton, borders, route};
use twinedge_algorithm::neighbours::of_feature;
use twinedge_geometry::Point;
use twinedge_map::{Builder, FeatureId, PlanarMap, Shape};

/// Returns the number of components of the vertices, without one of them: visits every edge until nothing changes.
fn components_without(map: &PlanarMap, without: Option<VertexKey>) -> usize {
    let vertices = || map.dcel().vertices().filter(|v| Some(v.key()) != without);
    let mut label: BTreeMap<usize, usize> = vertices().map(|v| (v.index(), v.index())).collect();
    let mut changed = true;
    while changed {
        changed = false;
        for h in map.dcel().half_edges() {
            let ends = [h.origin(), h.target()].map(|v| label.get(&v.index()).copied());
            if let [Some(a), Some(b)] = ends
                && a < b
            {
                label.insert(h.target().index(), a);
                changed = true;
            }
        }
    }
    label.values().collect::<BTreeSet<_>>().len()
}

fn graphs_say_what_the_map_says(shapes: planar::Scribble) -> bool {
    let map = noded(&shapes);
    let dcel = map.dcel();
    let (dual, skeleton) = (Dual::new(&map), Skeleton::new(&map));
    let figures = map.validate().figures().unwrap();
    assert_eq!((dual.node_count(), dual.edge_references().count()), (figures.faces, figures.edges));
    assert_eq!((skeleton.node_count(), skeleton.edge_references().count()), (figures.vertices, figures.edges));
    assert_eq!(connected_components(&skeleton), figures.components);
    // Every edge has another face next to it, or lies in the face around it: all faces are connected.
    assert_eq!(connected_components(&dual), 1);

    let edge = |h: twinedge::dcel::HalfEdgeKey| dcel.half_edge(h).unwrap().index() / 2;
    let bridges: BTreeSet<usize> = bridges(&skeleton).map(|e| edge(e.id())).collect();
    let loops: BTreeSet<usize> =
        dual.edge_references().filter(|e| e.source() == e.target()).map(|e| edge(e.id())).collect();
    assert_eq!(bridges, loops);

    let found: BTreeSet<usize> =
        articulation_points(&skeleton).into_iter().map(|v| dcel.vertex(v).unwrap().index()).collect();
    let alone = |v: &Vertex<'_>| usize::from(v.degree() == 0);
    let cuts: BTreeSet<usize> = { dcel.vertices() }
        .filter(|v| components_without(&map, Some(v.key())) + alone(v) > figures.components)
        .map(Vertex::index)
        .collect();
    assert_eq!(found, cuts);

    for face in dcel.faces() {
        let across: Vec<FaceKey> = dual.neighbors(face.key()).collect();
        let loops = across.iter().filter(|other| **other == face.key()).count();
        assert_eq!(across.len() + loops, face.half_edges().count());
        assert!(dual.edges(face.key()).all(|e| {
            let h = dcel.half_edge(e.id()).unwrap();
            e.source() == face.key() && h.face() == face && h.twin().face().key() == e.target()
        }));
        assert_eq!(dual.from_index(dual.to_index(face.key())), face.key());
    }
    // Features overlap here, and an edge inside the overlap of two features is no border.
    borders_are_means(&map);
    let mut visited = 0;
    let mut walk = Bfs::new(&dual, dcel.unbounded_face().key());
    while walk.next(&dual).is_some() {
        visited += 1;
    }
    visited == figures.faces
}

#[test]
fn random_maps() {
    QuickCheck::new().tests(150).quickcheck(graphs_say_what_the_map_says as fn(planar::Scribble) -> bool);
}

#[test]
fn stale_keys_lead_nowhere() {
    let mut other = PlanarMap::new();
    let ring = other.insert_ring([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]).unwrap();
    let map = PlanarMap::new();
    let dual = Dual::new(&map);
    assert_eq!(dual.neighbors(ring.faces_split[0].1).count(), 0);
    assert_eq!(dual.to_index(ring.faces_split[0].1), usize::MAX);
    assert_eq!(dual.from_index(7), FaceKey::default());
    assert_eq!(Skeleton::new(&map).neighbors(ring.vertices[0]).count(), 0);
}

fn named(map: &PlanarMap, name: &str) -> FeatureId {
    map.features().find(|feature| map.name(*feature) == Some(name)).unwrap()
}

#[test]
fn borders_are_those_between_neighbours() {
    for map in planar::world_maps() {
        assert_eq!(borders(&map).node_count(), map.features().count());
        borders_are_means(&map);
    }
}

/// The border of two features is the mean of the borders seen from both sides.
fn borders_are_means(map: &PlanarMap) {
    let mut expected: BTreeMap<[usize; 2], f64> = BTreeMap::new();
    for feature in map.features() {
        for border in of_feature(map, feature) {
            let (a, b) = (feature.index(), border.neighbour.index());
            *expected.entry([a.min(b), a.max(b)]).or_default() += border.length / 2.0;
        }
    }
    let graph = borders(map);
    let found: BTreeMap<[usize; 2], f64> = { graph.edge_references() }
        .map(|e| {
            ([e.source().index().min(e.target().index()), e.source().index().max(e.target().index())], *e.weight())
        })
        .collect();
    assert!(found.keys().eq(expected.keys()));
    assert!(found.values().zip(expected.values()).all(|(a, b)| (a - b).abs() <= 1e-9 * b));
}

/// Six borders lie between Portugal and China, as in any atlas; there is no route to Australia.
#[test]
fn golden_routes() {
    let map = planar::world_maps().next().unwrap();
    let names = |from: &str, to: &str| {
        let found = route(&map, named(&map, from), named(&map, to), By::Borders)?;
        Some(found.features.iter().map(|f| map.name(*f).unwrap().to_owned()).collect::<Vec<_>>())
    };
    let way = ["Portugal", "Spain", "France", "Germany", "Poland", "Russia", "China"];
    assert_eq!(names("Portugal", "China").unwrap(), way);
    assert_eq!(names("Portugal", "Portugal").unwrap(), ["Portugal"]);
    assert_eq!(names("Portugal", "Australia"), None);
    let elsewhere = planar::world_maps().nth(1).unwrap().features().last().unwrap();
    assert_eq!(route(&map, elsewhere, elsewhere, By::Borders), None);
}

/// Compared with shortest routes for all pairs, found by trying every feature as the last but one.
#[test]
fn routes_are_shortest_ways() {
    let map = planar::world_maps().next().unwrap();
    let graph = borders(&map);
    let features: Vec<FeatureId> = map.features().collect();
    let centroid: Vec<Option<Point>> = features.iter().map(|f| feature_centroid(&map, *f)).collect();
    let n = features.len();
    let mut fewest = vec![vec![f64::INFINITY; n]; n];
    let mut shortest = fewest.clone();
    for i in 0..n {
        (fewest[i][i], shortest[i][i]) = (0.0, 0.0);
    }
    for e in graph.edge_references() {
        let (i, j) = (e.source().index(), e.target().index());
        let (a, b) = (centroid[i].unwrap(), centroid[j].unwrap());
        (fewest[i][j], fewest[j][i]) = (1.0, 1.0);
        let length = (a.x - b.x).hypot(a.y - b.y);
        (shortest[i][j], shortest[j][i]) = (length, length);
    }
    for table in [&mut fewest, &mut shortest] {
        for k in 0..n {
            for i in 0..n {
                for j in 0..n {
                    table[i][j] = table[i][j].min(table[i][k] + table[k][j]);
                }
            }
        }
    }
    for (i, from) in features.iter().enumerate().step_by(59) {
        for (j, to) in features.iter().enumerate().step_by(3) {
            let by_borders = route(&map, *from, *to, By::Borders);
            let by_length = route(&map, *from, *to, By::Length);
            let borders = by_borders.as_ref().map_or(f64::INFINITY, |r| (r.features.len() - 1) as f64);
            assert_eq!(borders.to_bits(), fewest[i][j].to_bits());
            let length = by_length.as_ref().map_or(f64::INFINITY, |r| r.length);
            assert!(length.to_bits() == shortest[i][j].to_bits() || (length - shortest[i][j]).abs() < 1e-9);
            assert!(by_borders.is_none_or(|r| r.length >= length - 1e-9));
        }
    }
}

#[test]
fn centroids_are_those_of_symmetric_shapes() {
    let square = |low: f64, high: f64| [[low, low], [high, low], [high, high], [low, high]];
    let mut builder = Builder::new();
    // A square with a hole off the middle: 16·(2, 2) − 1·(1.5, 1.5), by 15.
    let id = builder.shape(&Shape::polygon(square(0.0, 4.0)).hole(square(1.0, 2.0))).unwrap();
    let empty = builder.shape(&Shape::Point(Point::new(9.0, 9.0))).unwrap();
    let map = builder.build().unwrap();
    let found = feature_centroid(&map, id).unwrap();
    assert!((found.x - 30.5 / 15.0).abs() < 1e-15 && (found.y - 30.5 / 15.0).abs() < 1e-15);
    assert_eq!(face_centroid(&map, faces_of(&map, id)[0]), Ok(Some(found)));
    assert_eq!(feature_centroid(&map, empty), None);
    assert_eq!(face_centroid(&map, map.dcel().unbounded_face().key()), Ok(None));
    let stale = { PlanarMap::new() }.dcel().unbounded_face().key();
    assert_eq!(face_centroid(&map, stale), Err(StaleKey::Face(stale)));
}

/// The distance from the outside equals the number of borders between, by petgraph and by peeling.
#[test]
fn distances_from_the_outside() {
    let mut map = PlanarMap::new();
    for i in 0..5 {
        let (low, high) = (f64::from(i), 20.0 - f64::from(i));
        map.insert_ring([[low, low], [high, low], [high, high], [low, high]]).unwrap();
    }
    let far = dijkstra(&Dual::new(&map), map.dcel().unbounded_face().key(), None, |_| 1);
    assert_eq!(far.values().copied().collect::<BTreeSet<_>>(), (0..=5).collect());
}
