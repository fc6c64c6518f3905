//! A layer of boundaries, and the faults of their relations.

use crate::elements::{Elements, OsmError, Relation, Role};
use crate::filter::TagFilter;
use crate::finding::{Findings, Found, Kind};
use crate::rings::{Piece, Ring, open_ends, rings};
use rustc_hash::FxHashSet;
use std::cmp::Ordering;
use std::collections::BTreeMap;
use std::path::Path;
use twinedge_diagnosis::{Diagnosis, FeatureName, RuleLine};
use twinedge_geometry::Point;
use twinedge_layers::nesting::{Extent, area, direction, lies_in};
use twinedge_layers::{Crs, Dimensions, Feature, Geometry, Header, Id, Layer, Line, Position, Shape, Value};

/// The boundaries of a file.
#[derive(Clone, Debug)]
pub struct Boundaries {
    /// One feature per relation, by id, with its tags as attributes. Its polygons are the areas of closed rings, in any role.
    pub layer: Layer,
    /// The outcome of O1 … O5.
    pub rules: Vec<RuleLine>,
    /// The kept violations, in the order of the rules.
    pub findings: Vec<Diagnosis>,
}

impl Boundaries {
    /// Returns the number of violations of O1 … O5, kept or not.
    #[must_use]
    pub fn violation_count(&self) -> u64 {
        self.rules.iter().map(|rule| rule.violations).sum()
    }
}

/// Reads selected relations of types `boundary` and `multipolygon` from `.osm.pbf`. Keeps up to `limit` violations per rule;
/// counts all.
///
/// O(file) in three passes by all threads, and O(r²) for r rings of a relation with nested boxes. Memory O(selected nodes).
///
/// # Errors
/// [`OsmError`].
pub fn read(path: &Path, filter: &TagFilter, limit: usize) -> Result<Boundaries, OsmError> {
    let elements = Elements::read(path, filter)?;
    let mut made = Making { elements: &elements, findings: Findings::new(limit), sides: BTreeMap::new() };
    let features = elements.relations.iter().enumerate().map(|(number, relation)| made.feature(number, relation));
    let features: Vec<Feature> = features.collect();
    made.same_sides();
    let rules = made.findings.rules();
    let mut findings = made.findings.kept;
    findings.sort_by_key(|one| one.rule);
    let header = Header { name: Some(filter.to_string()), crs: Some(Crs::epsg(4326)), ..Header::default() };
    Ok(Boundaries { layer: Layer { header, features }, rules, findings })
}

struct Making<'a> {
    elements: &'a Elements,
    findings: Findings,
    /// The relations on each side of a way: true for the left one.
    sides: BTreeMap<(i64, bool), Vec<usize>>,
}

/// A ring with its place among the others of its relation.
struct Placed {
    line: Line,
    /// The number of rings around it.
    depth: usize,
    /// The smallest ring around it.
    parent: Option<usize>,
    /// True if it is known to be an outer ring or a hole.
    is_certain: bool,
}

impl Placed {
    const fn is_outer(&self) -> bool {
        self.depth.is_multiple_of(2)
    }

    /// Returns the ways whose role contradicts the position of the ring.
    fn wrong(&self, ring: &Ring, pieces: &[Piece<'_>]) -> Vec<i64> {
        let wrong = if self.is_outer() { Role::Inner } else { Role::Outer };
        let of_ring = ring.pieces.iter().map(|(piece, _)| &pieces[*piece]);
        let mut ways: Vec<i64> = of_ring.filter(|piece| piece.role == wrong).map(|piece| piece.way).collect();
        ways.dedup();
        ways
    }
}

impl<'a> Making<'a> {
    fn feature(&mut self, number: usize, relation: &Relation) -> Feature {
        let (pieces, is_complete) = self.pieces(number, relation);
        self.findings.checked[1] += 1;
        if relation.members.is_empty() {
            let message = || format!("no way is a member of {} as a border", said(relation));
            self.findings.add(Kind::NO_WAYS, || Found { message: message(), ..Found::of([named(number, relation)]) });
        }
        let open = open_ends(&pieces);
        if !open.is_empty() {
            let places = open.iter().filter_map(|node| self.place(*node)).collect();
            self.findings.add(Kind::OPEN, || Found {
                // An even number of nodes, as each way has two ends.
                message: format!("the rings of {} are open at {} nodes", said(relation), open.len()),
                records: open.iter().map(|node| format!("node {node}")).collect(),
                places,
                follows_from: (!is_complete).then_some("O1"),
                ..Found::of([named(number, relation)])
            });
        }
        let rings = rings(&pieces);
        let line = |ring: &Ring| ring.points.iter().map(|p| Position::new(p.x, p.y)).collect();
        let mut placed = placed(rings.iter().map(line).collect());
        self.findings.checked[4] += placed.len() as u64;
        for (ring, place) in rings.iter().zip(&mut placed) {
            let ways = place.wrong(ring, &pieces);
            // A ring around it may be missing.
            place.is_certain = is_complete || ways.is_empty();
            if !place.is_certain {
                continue;
            }
            self.role(number, relation, &ways, place);
            let inside_is_left = match direction(&place.line) {
                Ordering::Equal => continue,
                turns => (turns == Ordering::Greater) == place.is_outer(),
            };
            for (piece, is_forward) in &ring.pieces {
                let side = (pieces[*piece].way, *is_forward == inside_is_left);
                let relations = self.sides.entry(side).or_default();
                // A way can be in several rings.
                if relations.last() != Some(&number) {
                    relations.push(number);
                }
            }
        }
        let attributes = relation.tags.iter().map(|(key, value)| (key.as_str().into(), Value::Text(value.clone())));
        Feature {
            id: Some(Id::Text(id(relation))),
            attributes: attributes.collect(),
            geometry: geometry(placed),
            ..Feature::default()
        }
    }

    /// Returns the usable members, and true if these are all. Checks O1 and O3.
    fn pieces(&mut self, number: usize, relation: &Relation) -> (Vec<Piece<'a>>, bool) {
        let elements = self.elements;
        let mut seen = FxHashSet::default();
        let mut pieces = Vec::new();
        let mut is_complete = true;
        for member in &relation.members {
            for rule in [0, 2] {
                self.findings.checked[rule] += 1;
            }
            let of_member = |message: String| Found {
                message,
                records: vec![format!("way {}", member.way)],
                ..Found::of([named(number, relation)])
            };
            let Some(nodes) = elements.ways.get(&member.way).filter(|nodes| nodes.len() > 1) else {
                let message =
                    || format!("way {} of {} is not in the file, or has no length there", member.way, said(relation));
                self.findings.add(Kind::WAY_MISSING, || of_member(message()));
                is_complete = false;
                continue;
            };
            if let Some(node) = nodes.iter().find(|node| !elements.nodes.contains_key(node)) {
                let message =
                    || format!("node {node} of way {}, a member of {}, is not in the file", member.way, said(relation));
                self.findings.add(Kind::NODE_MISSING, || of_member(message()));
                is_complete = false;
                continue;
            }
            if !seen.insert(member.way) {
                let message = || format!("way {} is a member of {} more than once", member.way, said(relation));
                let line = self.points(nodes);
                self.findings.add(Kind::REPEATED, || Found {
                    places: line.first().copied().into_iter().collect(),
                    lines: vec![line],
                    ..of_member(message())
                });
                continue;
            }
            let points = nodes.iter().filter_map(|node| elements.nodes.get(node)).copied().collect();
            pieces.push(Piece { way: member.way, role: member.role, nodes, points });
        }
        (pieces, is_complete)
    }

    fn role(&mut self, number: usize, relation: &Relation, ways: &[i64], place: &Placed) {
        let Some(first) = ways.first() else { return };
        self.findings.add(Kind::ROLE, || {
            let line: Vec<_> = place.line.iter().map(|p| [p.x, p.y]).collect();
            let (role, what) = if place.is_outer() { ("inner", "an outer ring") } else { ("outer", "a hole") };
            let others = match ways.len() - 1 {
                0 => String::new(),
                n => format!(" and {n} more"),
            };
            Found {
                message: format!("way {first}{others} of {what} of {} has the role {role}", said(relation)),
                records: ways.iter().map(|way| format!("way {way}")).collect(),
                places: line.first().copied().into_iter().collect(),
                lines: vec![line],
                ..Found::of([named(number, relation)])
            }
        });
    }

    /// Checks O4: one finding for each pair of relations.
    fn same_sides(&mut self) {
        let mut pairs: BTreeMap<[usize; 2], Vec<i64>> = BTreeMap::new();
        for ((way, _), numbers) in &self.sides {
            for pair in numbers.windows(2) {
                pairs.entry([pair[0], pair[1]]).or_default().push(*way);
            }
        }
        self.findings.checked[3] = self.sides.len() as u64;
        let elements = self.elements;
        for (pair, ways) in pairs {
            let lines: Vec<_> =
                ways.iter().filter_map(|way| elements.ways.get(way)).map(|nodes| self.points(nodes)).collect();
            self.findings.add(Kind::SAME_SIDE, || {
                let [first, second] = pair.map(|number| &elements.relations[number]);
                let along = match &ways[..] {
                    [way] => format!("way {way}"),
                    ways => format!("{} ways", ways.len()),
                };
                Found {
                    message: format!("{} and {} lie on the same side of {along}", said(first), said(second)),
                    records: ways.iter().map(|way| format!("way {way}")).collect(),
                    places: lines.iter().filter_map(|line| line.get(line.len() / 2)).copied().collect(),
                    lines,
                    ..Found::of(pair.map(|number| named(number, &elements.relations[number])))
                }
            });
        }
    }

    fn place(&self, node: i64) -> Option<[f64; 2]> {
        self.elements.nodes.get(&node).map(|Point { x, y }| [*x, *y])
    }

    fn points(&self, nodes: &[i64]) -> Vec<[f64; 2]> {
        nodes.iter().filter_map(|node| self.place(*node)).collect()
    }
}

fn placed(lines: Vec<Line>) -> Vec<Placed> {
    let extents: Vec<(Extent, f64)> = lines.iter().map(|line| (Extent::of(line), area(line).abs())).collect();
    let around = |inner: usize| {
        let (extent, of_inner) = &extents[inner];
        let is_larger =
            |outer: usize| extents[outer].1.total_cmp(of_inner).then(inner.cmp(&outer)) == Ordering::Greater;
        (0..lines.len())
            .filter(|outer| *outer != inner && extents[*outer].0.contains(extent) && is_larger(*outer))
            .filter(|outer| lies_in(&lines[inner], &lines[*outer]))
            .collect::<Vec<_>>()
    };
    let places: Vec<(usize, Option<usize>)> = (0..lines.len())
        .map(|ring| {
            let around = around(ring);
            let smallest = around.iter().copied().min_by(|a, b| extents[*a].1.total_cmp(&extents[*b].1));
            (around.len(), smallest)
        })
        .collect();
    let place = |(line, (depth, parent))| Placed { line, depth, parent, is_certain: true };
    lines.into_iter().zip(places).map(place).collect()
}

/// Returns the polygons: one outer ring each, counter-clockwise, with the holes directly inside it, clockwise.
fn geometry(placed: Vec<Placed>) -> Option<Geometry> {
    let mut polygons: BTreeMap<usize, Vec<Line>> = BTreeMap::new();
    for (number, ring) in placed.iter().enumerate().filter(|(_, ring)| ring.is_certain && ring.is_outer()) {
        polygons.insert(number, vec![turned(ring.line.clone(), Ordering::Greater)]);
    }
    for ring in placed {
        if ring.is_certain
            && !ring.is_outer()
            && let Some(polygon) = ring.parent.and_then(|parent| polygons.get_mut(&parent))
        {
            polygon.push(turned(ring.line, Ordering::Less));
        }
    }
    let mut polygons: Vec<Vec<Line>> = polygons.into_values().collect();
    let shape = match polygons.len() {
        0 => return None,
        1 => Shape::Polygon(polygons.remove(0)),
        _ => Shape::MultiPolygon(polygons),
    };
    Some(Geometry::new(Dimensions::Xy, shape))
}

fn turned(mut ring: Line, way: Ordering) -> Line {
    if direction(&ring) == way.reverse() {
        ring.reverse();
    }
    ring
}

/// Returns the id in the notation of other programs.
fn id(relation: &Relation) -> String {
    format!("relation/{}", relation.id)
}

fn name(relation: &Relation) -> Option<&str> {
    relation.tags.iter().find(|(key, _)| key == "name").map(|(_, name)| name.as_str())
}

fn said(relation: &Relation) -> String {
    let id = id(relation);
    name(relation).map_or_else(|| id.clone(), |name| format!("{} ({id})", plain(name)))
}

fn named(number: usize, relation: &Relation) -> FeatureName {
    let id = id(relation);
    FeatureName { number, label: said(relation), name: name(relation).map(str::to_owned), id: Some(id) }
}

/// Makes a text safe for a terminal.
fn plain(text: &str) -> String {
    text.chars().map(|c| if c.is_control() { char::REPLACEMENT_CHARACTER } else { c }).collect()
}
