//! From the objects of a file to the polygons on the sides of its arcs.

use super::super::error::{Cause, Place, ReadError};
use super::super::model::Line;
use super::document::{Document, content};
use super::features::{chosen, list, no_list};
use super::finding::{Findings, Kind};
use super::topology::{ArcTopology, NIL};
use crate::io::MAX_NESTED_COLLECTIONS;
use rustc_hash::FxHashMap;
use serde_json::Value as Json;
use std::io::Read;
use twinedge_geometry::Point;

/// Reads the arcs, and the structure of the object of this name, or of the only one. Of each rule A0 … A3 up to `limit` findings
/// are kept; all are counted. The other objects are checked for A1 and counted for A3.
///
/// O(n log n) for n bytes: no ring is assembled.
///
/// # Errors
/// [`ReadError`], as for a layer, except that indices without an arc, arcs that do not join and repeated arcs are findings.
pub fn read(reader: &mut dyn Read, layer: Option<&str>, limit: usize) -> Result<ArcTopology, ReadError> {
    let document = Document::read(reader)?;
    let name = chosen(&document.objects, layer)?;
    if document.arcs.len() >= (NIL / 2) as usize {
        let cause = Cause::TooMany { what: "arcs", count: document.arcs.len() as u64 };
        return Err(content(Place::Header, cause));
    }
    let mut reading = Reading {
        shape: document.arcs.iter().map(ArcShape::of).collect(),
        used: vec![false; document.arcs.len()],
        topology: ArcTopology {
            label: vec![NIL; 2 * document.arcs.len()],
            is_outer: vec![false; 2 * document.arcs.len()],
            findings: Findings::new(limit),
            ..ArcTopology::default()
        },
    };
    for (object, json) in &document.objects {
        let is_chosen = *object == name;
        let parts = json.get("geometries").filter(|_| json["type"] == "GeometryCollection");
        let parts = match parts {
            Some(parts) => parts.as_array().map(Vec::as_slice).ok_or_else(|| content(Place::Header, no_list()))?,
            None => std::slice::from_ref(json),
        };
        for (number, part) in parts.iter().enumerate() {
            let whose = Whose { object, number, json: part, is_chosen };
            reading.geometry(part, &whose, 0).map_err(|cause| content(Place::Feature(number), cause))?;
        }
    }
    Ok(reading.finish(&document.arcs))
}

struct Whose<'a> {
    object: &'a str,
    number: usize,
    json: &'a Json,
    is_chosen: bool,
}

impl Whose<'_> {
    fn name(&self) -> String {
        let known = [&self.json["properties"]["name"], &self.json["id"]];
        let known = known.into_iter().find_map(|value| match value {
            Json::String(text) => Some(text.clone()),
            Json::Number(number) => Some(number.to_string()),
            _ => None,
        });
        let known = known.map_or_else(String::new, |known| format!(" ({known})"));
        format!("feature {} of {}{known}", self.number, self.object)
    }
}

/// The properties of an arc that rings need.
struct ArcShape {
    /// The first and last point; none without positions.
    ends: Option<[Point; 2]>,
    has_length: bool,
    /// Twice the area between the arc and the straight line back from its end.
    area: f64,
}

fn cross(o: Point, a: Point, b: Point) -> f64 {
    (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x)
}

impl ArcShape {
    fn of(arc: &Line) -> Self {
        let point = |i: usize| arc.get(i).map(|p| Point::new(p.x, p.y));
        let ends = point(0).zip(arc.len().checked_sub(1).and_then(point)).map(|(a, b)| [a, b]);
        let first = point(0).unwrap_or_default();
        let pairs = || (1..arc.len()).filter_map(|i| point(i - 1).zip(point(i)));
        let area = pairs().map(|(a, b)| cross(first, a, b)).sum();
        Self { ends, has_length: pairs().any(|(a, b)| a != b), area }
    }
}

struct Reading {
    shape: Vec<ArcShape>,
    used: Vec<bool>,
    topology: ArcTopology,
}

/// A chain of existing arcs that join.
struct Chain {
    half_edges: Vec<u32>,
    /// The first and last point; none without arcs.
    ends: Option<[Point; 2]>,
    /// Twice the area between the chain and the straight line back from its end.
    area: f64,
}

impl Reading {
    /// Reads a geometry. The recursion is as deep as collections are nested.
    fn geometry(&mut self, json: &Json, whose: &Whose<'_>, depth: usize) -> Result<(), Cause> {
        let given = || json.get("arcs").ok_or_else(no_list);
        match json["type"].as_str() {
            Some("LineString") => drop(self.chain(given()?, whose)?),
            Some("MultiLineString") => drop(list(given()?, |line| self.chain(line, whose))?),
            Some("Polygon") => self.polygon(given()?, whose, None)?,
            Some("MultiPolygon") => {
                let polygons = given()?.as_array().ok_or_else(no_list)?;
                for (part, rings) in polygons.iter().enumerate() {
                    self.polygon(rings, whose, Some(part))?;
                }
            }
            Some("GeometryCollection") => {
                if depth == MAX_NESTED_COLLECTIONS {
                    return Err(Cause::TooDeep);
                }
                let parts = json.get("geometries").and_then(Json::as_array).ok_or_else(no_list)?;
                for part in parts {
                    self.geometry(part, whose, depth + 1)?;
                }
            }
            Some("Point" | "MultiPoint") => {}
            None if json["type"].is_null() && json.get("type").is_some() => {}
            _ => return Err(Cause::Invalid("a geometry without a type that TopoJSON has".to_owned())),
        }
        Ok(())
    }

    /// Checks A1 for a line or ring; returns `None` for a broken one.
    fn chain(&mut self, indices: &Json, whose: &Whose<'_>) -> Result<Option<Chain>, Cause> {
        let mut chain = Chain { half_edges: Vec::new(), ends: None, area: 0.0 };
        let mut is_whole = true;
        let mut before: Option<(i64, Point)> = None;
        for index in indices.as_array().ok_or_else(no_list)? {
            let index = index.as_i64().ok_or_else(|| Cause::Invalid(format!("{index} is no index of an arc")))?;
            self.topology.indices += 1;
            let arc = usize::try_from(if index < 0 { !index } else { index }).unwrap_or(usize::MAX);
            let findings = &mut self.topology.findings;
            let Some(shape) = self.shape.get(arc) else {
                let all = self.shape.len();
                let message = || format!("{} has the index {index}, and there are {all} arcs", whose.name());
                findings.add(Kind::NO_SUCH_ARC, message, &[]);
                (is_whole, before) = (false, None);
                continue;
            };
            self.used[arc] = true;
            let Some(mut ends) = shape.ends else {
                // A0 names the arc.
                (is_whole, before) = (false, None);
                continue;
            };
            if index < 0 {
                ends.reverse();
            }
            if let Some((last, end)) = before.filter(|(_, end)| *end != ends[0]) {
                let message = || {
                    let (from, to) = ((end.x, end.y), (ends[0].x, ends[0].y));
                    format!(
                        "in {}, arc {last} ends at {from:?}, and arc {index} after it begins at {to:?}",
                        whose.name()
                    )
                };
                findings.add(Kind::NOT_JOINED, message, &[end.into(), ends[0].into()]);
                is_whole = false;
            }
            before = Some((index, ends[1]));
            let begin = chain.ends.map_or(ends[0], |[begin, _]| begin);
            chain.ends = Some([begin, ends[1]]);
            chain.area += if index < 0 { -shape.area } else { shape.area } + cross(begin, ends[0], ends[1]);
            if shape.has_length {
                chain.half_edges.push(2 * arc as u32 + u32::from(index < 0));
            }
        }
        Ok(Some(chain).filter(|_| is_whole))
    }

    /// Reads the rings of a polygon, the outer one first.
    fn polygon(&mut self, rings: &Json, whose: &Whose<'_>, part: Option<usize>) -> Result<(), Cause> {
        let mut face = NIL;
        for (number, ring) in rings.as_array().ok_or_else(no_list)?.iter().enumerate() {
            let Some(chain) = self.chain(ring, whose)? else { continue };
            let findings = &mut self.topology.findings;
            let ring = || {
                let part = part.map_or_else(String::new, |part| format!(" of polygon {part}"));
                format!("ring {number}{part} of {}", whose.name())
            };
            let Some([begin, end]) = chain.ends else {
                findings.add(Kind::RING_WITHOUT_AREA, || format!("{} has no arcs", ring()), &[]);
                continue;
            };
            if begin != end {
                let (from, to) = ((begin.x, begin.y), (end.x, end.y));
                let message = || format!("{} begins at {from:?} and ends at {to:?}", ring());
                findings.add(Kind::NOT_CLOSED, message, &[begin.into(), end.into()]);
                continue;
            }
            if chain.area == 0.0 {
                findings.add(Kind::RING_WITHOUT_AREA, || format!("{} encloses nothing", ring()), &[begin.into()]);
                continue;
            }
            if !whose.is_chosen {
                continue;
            }
            if face == NIL {
                let part = part.map_or_else(String::new, |part| format!(", polygon {part}"));
                face = self.topology.names.len() as u32;
                self.topology.names.push(whose.name() + &part);
            }
            // The polygon lies to the left of its outer ring counter-clockwise, and to the left of its holes clockwise.
            let turned = u32::from((chain.area > 0.0) != (number == 0));
            for half_edge in chain.half_edges {
                self.side((half_edge ^ turned) as usize, face, number == 0);
            }
        }
        Ok(())
    }

    /// Assigns a polygon to the left side of a half-edge (A2).
    fn side(&mut self, half_edge: usize, face: u32, is_outer: bool) {
        let topology = &mut self.topology;
        let there = topology.label[half_edge];
        if there == NIL {
            topology.label[half_edge] = face;
            topology.is_outer[half_edge] = is_outer;
            return;
        }
        let (names, arc) = (&topology.names, half_edge / 2);
        let message = || {
            let [one, two] = [there, face].map(|face| names.get(face as usize).map_or("", String::as_str));
            format!("arc {arc} has {one} and {two} on the same side")
        };
        let ends = self.shape[arc].ends.into_iter().flatten().map(Into::into);
        topology.findings.add(Kind::SAME_SIDE, message, &ends.collect::<Vec<_>>());
    }

    fn finish(self, arcs: &[Line]) -> ArcTopology {
        let Self { shape, used, mut topology } = self;
        let mut vertices: FxHashMap<[u64; 2], u32> = FxHashMap::default();
        topology.first_bend.push(0);
        for (number, (arc, shape)) in arcs.iter().zip(&shape).enumerate() {
            let ends: Vec<[f64; 2]> = shape.ends.into_iter().flatten().map(Into::into).collect();
            let findings = &mut topology.findings;
            if !shape.has_length {
                let message = || format!("arc {number} has no two different positions");
                findings.add(Kind::ARC_WITHOUT_LENGTH, message, &ends);
            }
            if !used[number] {
                findings.add(Kind::UNUSED, || format!("no object uses arc {number}"), &ends);
            }
            let sides = [topology.label[2 * number], topology.label[2 * number + 1]];
            if sides[0] == sides[1] && sides[0] != NIL {
                let name = &topology.names[sides[0] as usize];
                findings.add(Kind::BOTH_SIDES, || format!("arc {number} has {name} on both sides"), &ends);
            }
            let mut of_arc = [NIL; 2];
            if let Some(ends) = shape.ends.filter(|_| sides != [NIL; 2]) {
                of_arc = ends.map(|end| {
                    // Zero has two signs.
                    let key = [(end.x + 0.0).to_bits(), (end.y + 0.0).to_bits()];
                    *vertices.entry(key).or_insert_with(|| {
                        topology.points.push(end);
                        topology.points.len() as u32 - 1
                    })
                });
                topology.add_bends(arc);
            }
            topology.ends.push(of_arc);
            topology.first_bend.push(topology.bends.len());
        }
        topology.link();
        topology.list();
        topology
    }
}

impl ArcTopology {
    /// Adds the positions between the ends of an arc with length.
    fn add_bends(&mut self, arc: &Line) {
        let mut points = arc.iter().map(|p| Point::new(p.x, p.y));
        let Some(mut before) = points.next() else { return };
        for point in points {
            if point == before {
                self.repeated_points += 1;
            } else {
                self.bends.push(point);
            }
            before = point;
        }
        // The last one that is not repeated is the end: arcs without length are no edges.
        self.bends.pop();
    }
}
