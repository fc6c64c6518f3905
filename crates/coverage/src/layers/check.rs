//! X1 within, X2 cover, X3 border, X5 line, X6 point: two layers on one map.

use super::finding::{Deviation, LayerFinding, sort};
use super::parents::live;
use super::split;
use crate::CoverageError;
use crate::region::{connected, ends, segment_length};
use rustc_hash::{FxHashMap, FxHashSet};
use twinedge::dcel::{Face, HalfEdge, Vertex};
use twinedge_algorithm::area::{Sum, face_area};
use twinedge_algorithm::claims::faces_by_feature;
use twinedge_geometry::Point;
use twinedge_map::{FeatureId, Located, PlanarMap};

/// Finds violations of X1 … X3, X5 and X6. The first `audited` features of the map belong to the audited layer, all others to the
/// other layer. `points` are the points of the audited layer, which a map does not keep.
///
/// X1 applies to features that cover faces, X5 to features that cover none. X2 applies if both layers have areas, X3 if the
/// audited layer has areas or lines. Findings come in order of the rules; within one kind by falling area and length.
///
/// O(n log n) for n half-edges, faces and points, each counted once for each feature that covers it.
///
/// ```
/// use twinedge_coverage::layers::{LayerRule, check};
/// use twinedge_map::{Builder, Noding, Shape};
///
/// // Two counties, and the state that they are in; it is wider by one.
/// let area = |x: f64, width: f64| Shape::polygon([[x, 0.0], [x + width, 0.0], [x + width, 2.0], [x, 2.0]]);
/// let mut builder = Builder::new();
/// builder.shape(&area(0.0, 2.0))?;
/// builder.shape(&area(2.0, 2.0))?;
/// builder.shape(&area(0.0, 5.0))?;
/// let map = builder.build_with(Noding::Exact)?;
/// let found = check(&map, 2, &[])?;
/// let rules: Vec<_> = found.iter().map(|one| (one.rule(), one.area, one.length)).collect();
/// // Beyond the second county, the state is alone, and so are three of the four edges around that place.
/// assert_eq!(rules, [(LayerRule::Cover, 2.0, 6.0), (LayerRule::Border, 0.0, 4.0)]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`CoverageError::NotPlane`].
pub fn check(
    map: &PlanarMap,
    audited: usize,
    points: &[(FeatureId, Point)],
) -> Result<Vec<LayerFinding>, CoverageError> {
    map.plane()?;
    let layers = Layers::new(map, audited);
    let mut found = Vec::new();
    if layers.has_area {
        found.extend(layers.not_within());
        found.extend(layers.covered_by_one());
    }
    found.extend(layers.along_borders());
    found.extend(points.iter().filter_map(|point| layers.not_inside(*point)));
    sort(&mut found);
    Ok(found)
}

/// Both layers, with the features of each face.
struct Layers<'a> {
    map: &'a PlanarMap,
    audited: usize,
    /// For each face, the features of the audited layer and of the other layer that cover it, in order.
    claims: Vec<[Vec<FeatureId>; 2]>,
    /// True for each feature of the audited layer that covers a face.
    is_area: Vec<bool>,
    /// True if some feature of the audited layer covers a face.
    has_area: bool,
}

impl<'a> Layers<'a> {
    fn new(map: &'a PlanarMap, audited: usize) -> Self {
        // `audited` may exceed the number of features.
        let audited = audited.min(map.features().count());
        let mut claims: Vec<[Vec<FeatureId>; 2]> = Vec::new();
        let mut is_area = vec![false; audited];
        for face in map.dcel().faces() {
            let [here, there] = split(map, face, audited);
            for one in &here {
                is_area[one.index()] = true;
            }
            if claims.len() <= face.index() {
                claims.resize(face.index() + 1, Default::default());
            }
            claims[face.index()] = [here, there];
        }
        let has_area = is_area.contains(&true);
        Self { map, audited, claims, is_area, has_area }
    }

    fn here(&self, face: Face<'_>) -> &[FeatureId] {
        &self.claims[face.index()][0]
    }

    fn there(&self, face: Face<'_>) -> &[FeatureId] {
        &self.claims[face.index()][1]
    }

    /// Checks X1.
    fn not_within(&self) -> Vec<LayerFinding> {
        let faces = faces_by_feature(self.map);
        let audited = self.map.features().take(self.audited);
        audited.filter_map(|feature| self.outside_of_one(feature, live(self.map, faces.get(feature.index())))).collect()
    }

    /// Returns the finding for a feature that is not within one feature of the other layer.
    fn outside_of_one(&self, feature: FeatureId, faces: Vec<Face<'_>>) -> Option<LayerFinding> {
        let first = self.there(*faces.first()?);
        if first.iter().any(|one| faces.iter().all(|face| self.there(*face).contains(one))) {
            return None;
        }
        let mut shares: FxHashMap<FeatureId, Sum> = FxHashMap::default();
        for face in &faces {
            let area = face_area(self.map, face.key()).unwrap_or_default();
            self.there(*face).iter().for_each(|one| shares.entry(*one).or_default().add(area));
        }
        let mut others: Vec<(FeatureId, Sum)> = shares.into_iter().collect();
        others.sort_by(|(a, one), (b, other)| other.value().total_cmp(&one.value()).then(a.cmp(b)));
        let others: Vec<FeatureId> = others.into_iter().map(|(one, _)| one).collect();
        let is_outside = |face: &Face<'_>| others.first().is_none_or(|one| !self.there(*face).contains(one));
        let outside: Vec<Face<'_>> = faces.into_iter().filter(is_outside).collect();
        Some(LayerFinding::of_faces(self.map, Deviation::NotWithin, [vec![feature], others], &outside))
    }

    /// Checks X2.
    fn covered_by_one(&self) -> Vec<LayerFinding> {
        let class = |face: Face<'_>| match (self.here(face), self.there(face)) {
            ([], []) => None,
            (_, []) => Some(Deviation::OnlyHere),
            ([], _) => Some(Deviation::OnlyThere),
            _ => None,
        };
        let regions = connected(self.map.dcel().faces(), class);
        let finding = |region: Vec<Face<'_>>| {
            let deviation = class(region[0])?;
            let features = [0, 1].map(|side| sorted(region.iter().flat_map(|f| &self.claims[f.index()][side])));
            Some(LayerFinding::of_faces(self.map, deviation, features, &region))
        };
        regions.into_iter().filter_map(finding).collect()
    }

    /// Checks X3 and X5.
    fn along_borders(&self) -> Vec<LayerFinding> {
        let has_line = |h: HalfEdge<'_>| {
            let along = self.map.features_along(h.key()).into_iter().flatten();
            along.filter(|one| one.index() < self.audited && !self.is_area[one.index()]).collect::<Vec<_>>()
        };
        let (mut borders, mut lines) = (Vec::new(), Vec::new());
        let mut has_lines = false;
        for h in self.map.dcel().edges() {
            let sides = [h.face(), h.twin().face()];
            let of_lines = has_line(h);
            has_lines |= !of_lines.is_empty();
            let is_border = self.there(sides[0]) != self.there(sides[1]);
            let is_own = !of_lines.is_empty() || self.here(sides[0]) != self.here(sides[1]);
            if is_border && !is_own {
                let mut pair = sides.map(|side| self.there(side));
                pair.sort_unstable();
                borders.push((h, pair));
            }
            if !is_border {
                lines.extend(of_lines.into_iter().map(|line| (h, line)));
            }
        }
        if !self.has_area && !has_lines {
            return Vec::new();
        }
        let border = |(pair, stretch): ([&[FeatureId]; 2], Vec<HalfEdge<'_>>)| {
            let around = stretch.iter().flat_map(|h| self.here(h.face()));
            self.stretch(Deviation::NoBorder, [sorted(around), sorted(pair.into_iter().flatten())], &stretch)
        };
        let line = |(line, stretch): (FeatureId, Vec<HalfEdge<'_>>)| {
            let around = stretch.iter().flat_map(|h| self.there(h.face()));
            self.stretch(Deviation::OffBorder, [vec![line], sorted(around)], &stretch)
        };
        let borders = chains(&borders).into_iter().map(border);
        borders.chain(chains(&lines).into_iter().map(line)).collect()
    }

    fn stretch(
        &self,
        deviation: Deviation,
        [features, others]: [Vec<FeatureId>; 2],
        edges: &[HalfEdge<'_>],
    ) -> LayerFinding {
        let stretches: Vec<[Point; 2]> = edges.iter().map(|h| ends(self.map, *h)).collect();
        let length: Sum = stretches.iter().map(|stretch| segment_length(*stretch)).collect();
        let longest = stretches.iter().max_by(|a, b| segment_length(**a).total_cmp(&segment_length(**b)));
        let middle = |[a, b]: [Point; 2]| Point::new(f64::midpoint(a.x, b.x), f64::midpoint(a.y, b.y));
        LayerFinding {
            deviation,
            features,
            others,
            area: 0.0,
            width: 0.0,
            length: length.value(),
            at: longest.copied().map(middle).unwrap_or_default(),
            faces: Vec::new(),
            stretches,
        }
    }

    /// Checks X6.
    fn not_inside(&self, (feature, point): (FeatureId, Point)) -> Option<LayerFinding> {
        let at = self.map.noding().map_or(point, |noding| noding.snapped(point));
        let dcel = self.map.dcel();
        let around = |vertex: Vertex<'a>| -> Vec<Face<'a>> {
            let alone = vertex.isolated().map(|boundary| boundary.face());
            vertex.rotation().map(HalfEdge::face).chain(alone).collect()
        };
        let faces: Vec<Face<'_>> = match self.map.locate(at) {
            Ok(Located::Face(face)) => dcel.face(face).into_iter().collect(),
            Ok(Located::Edge(h)) => dcel.half_edge(h).into_iter().flat_map(|h| [h.face(), h.twin().face()]).collect(),
            Ok(Located::Vertex(v)) => dcel.vertex(v).into_iter().flat_map(around).collect(),
            // A point outside the range of the map lies inside nothing.
            Err(_) => Vec::new(),
        };
        let first = faces.first().map(|face| self.there(*face)).unwrap_or_default();
        if first.iter().any(|one| faces.iter().all(|face| self.there(*face).contains(one))) {
            return None;
        }
        let others = sorted(faces.iter().flat_map(|face| self.there(*face)));
        let none = LayerFinding::of_faces(self.map, Deviation::NotInside, [vec![feature], others], &[]);
        Some(LayerFinding { at, ..none })
    }
}

fn sorted<'a>(features: impl Iterator<Item = &'a FeatureId>) -> Vec<FeatureId> {
    let mut all: Vec<FeatureId> = features.copied().collect();
    all.sort_unstable();
    all.dedup();
    all
}

/// Groups edges of one class that are connected at vertices, in order of their first. Expected O(edges + rotations of vertices).
fn chains<'a, C: Clone + Eq + std::hash::Hash>(edges: &[(HalfEdge<'a>, C)]) -> Vec<(C, Vec<HalfEdge<'a>>)> {
    let mut at_vertex: FxHashMap<(usize, &C), Vec<usize>> = FxHashMap::default();
    for (number, (h, class)) in edges.iter().enumerate() {
        for vertex in [h.origin(), h.target()] {
            at_vertex.entry((vertex.index(), class)).or_default().push(number);
        }
    }
    let mut seen = FxHashSet::default();
    let mut found = Vec::new();
    for start in 0..edges.len() {
        if !seen.insert(start) {
            continue;
        }
        let class = &edges[start].1;
        let mut chain = vec![start];
        let mut next = 0;
        while let Some(number) = chain.get(next).copied() {
            next += 1;
            for vertex in [edges[number].0.origin(), edges[number].0.target()] {
                // Removed, so that each vertex is visited once.
                let here = at_vertex.remove(&(vertex.index(), class)).unwrap_or_default();
                chain.extend(here.into_iter().filter(|other| seen.insert(*other)));
            }
        }
        found.push((class.clone(), chain.into_iter().map(|number| edges[number].0).collect()));
    }
    found
}
