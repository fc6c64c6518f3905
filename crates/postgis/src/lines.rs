//! The lines of a topology alone: they can be judged despite broken links.
//!
//! A line ends at the node that its edge names, if it lies there, or else at any node at that point. Otherwise the end is a
//! vertex without node.

use super::topology::Topology;
use std::collections::{BTreeMap, BTreeSet, HashMap};
use twinedge::validate::{Collect, Expectation, Link, Parts, Record, Report, Rule, RuleOutcome, View, Violation};
use twinedge_geometry::Point;
use twinedge_geometry::predicates::in_range;
use twinedge_map::{Embedding, validate_embedding};

/// The lines, each linked only to itself, and the nodes.
pub(super) struct Lines<'a> {
    topology: &'a Topology,
    /// The ends without node, which are vertices after the nodes, each with a half-edge that starts there.
    without_node: Vec<(Point, usize)>,
    /// The vertices at both ends of each line.
    ends: Vec<[u32; 2]>,
    is_vertex: Vec<bool>,
    is_line: Vec<bool>,
}

pub(super) struct Drawing {
    pub(super) violations: Vec<Violation>,
    pub(super) finite: DrawingRule,
    pub(super) disjoint: DrawingRule,
}

/// The outcome of a rule, and the number of records that it was not checked for.
pub(super) struct DrawingRule {
    pub(super) outcome: RuleOutcome,
    pub(super) left_out: u64,
}

impl<'a> Lines<'a> {
    /// O(n) for n nodes and edges.
    pub(super) fn of(topology: &'a Topology) -> Self {
        let is_node =
            |node| topology.is_vertex(node) && !(topology.points[node].x.is_nan() && topology.points[node].y.is_nan());
        let mut lines = Self {
            topology,
            without_node: Vec::new(),
            ends: topology.ends.clone(),
            is_vertex: (0..topology.nodes.len()).map(is_node).collect(),
            is_line: (0..topology.edges.len()).map(|edge| topology.is_half_edge(2 * edge)).collect(),
        };
        lines.attach();
        lines
    }

    /// Finds the vertices of lines that do not end at their nodes.
    fn attach(&mut self) {
        let topology = self.topology;
        if topology.loose.is_empty() {
            return;
        }
        let key = |p: Point| [p.x + 0.0, p.y + 0.0].map(f64::to_bits);
        let mut at = HashMap::new();
        for node in (0..topology.nodes.len()).filter(|node| self.is_vertex[*node]) {
            at.entry(key(topology.points[node])).or_insert(node as u32);
        }
        for (edge, line) in &topology.loose {
            let edge = *edge as usize;
            let Some(line) = line else {
                self.is_line[edge] = false;
                continue;
            };
            for (side, end) in line.iter().enumerate() {
                let named = topology.ends[edge][side];
                if topology.points.get(named as usize) != Some(end) || !self.is_vertex[named as usize] {
                    self.ends[edge][side] = *at.entry(key(*end)).or_insert_with(|| {
                        self.without_node.push((*end, 2 * edge + side));
                        self.is_vertex.push(true);
                        (self.is_vertex.len() - 1) as u32
                    });
                }
            }
        }
    }

    /// Judges G1, and G4 for the parts that pass G1. O(n log n) for n points, plus O(p) for p overlapping boxes, if lines clash.
    pub(super) fn judge(&mut self, collect: Collect) -> Drawing {
        let edges = |lines: &Self| lines.is_line.iter().filter(|is_line| **is_line).count() as u64;
        let nodes = self.is_vertex.iter().take(self.topology.nodes.len());
        let nodes_left_out = nodes.filter(|is_vertex| !**is_vertex).count() as u64;
        let judged = |lines: &Self, rule, report: &Report| DrawingRule {
            outcome: report.outcome(rule).unwrap_or_default(),
            left_out: lines.is_line.len() as u64 - edges(lines) + if rule == Rule::G1 { nodes_left_out } else { 0 },
        };
        let all = validate_embedding(self, &Expectation::plane(), collect);
        let finite = judged(self, Rule::G1, &all);
        let mut violations = all.violations().to_vec();
        let mut disjoint = judged(self, Rule::G4, &all);
        if finite.outcome.violations > 0 {
            self.drop_unsound();
            let sound = validate_embedding(self, &Expectation::plane(), collect);
            violations.extend(sound.violations());
            disjoint = judged(self, Rule::G4, &sound);
        }
        violations.retain(|violation| matches!(violation.rule(), Rule::G1 | Rule::G4));
        Drawing { violations, finite, disjoint }
    }

    fn drop_unsound(&mut self) {
        for vertex in 0..self.is_vertex.len() {
            self.is_vertex[vertex] &= in_range(self.point(vertex));
        }
        for (edge, is_line) in self.is_line.iter_mut().enumerate() {
            let points = self.topology.line_points(edge);
            *is_line &= points.iter().all(|p| in_range(*p)) && points.windows(2).all(|pair| pair[0] != pair[1]);
        }
    }

    /// Returns the name of a record; for an end without node, the edge that ends there.
    pub(super) fn name(&self, record: Record) -> String {
        match record {
            Record::Vertex(vertex) if vertex >= self.topology.nodes.len() => {
                let half_edge = self.without_node[vertex - self.topology.nodes.len()].1;
                let end = if half_edge.is_multiple_of(2) { "start" } else { "end" };
                let edge = self.topology.edges.id(half_edge / 2).unwrap_or_default();
                format!("missing at the {end} of edge {edge}")
            }
            _ => self.topology.name(record),
        }
    }

    /// Returns the faces around which the judged lines do not close.
    pub(super) fn open_faces(&self) -> BTreeSet<u32> {
        let edges = (0..self.is_line.len()).filter(|edge| !self.is_line[*edge]);
        let without_line = edges.flat_map(|edge| self.topology.sides[edge]);
        without_line.chain(self.odd_ends().into_keys()).collect()
    }

    /// Maps each face to the vertices with an odd number of ends of lines with this face on one side. Others are absent.
    pub(super) fn odd_ends(&self) -> BTreeMap<u32, BTreeSet<u32>> {
        let mut odd: BTreeMap<u32, BTreeSet<u32>> = BTreeMap::new();
        for (edge, [left, right]) in self.topology.sides.iter().enumerate() {
            if self.is_line[edge] && left != right {
                for face in [left, right] {
                    let vertices = odd.entry(*face).or_default();
                    self.ends[edge].into_iter().for_each(|vertex| toggle(vertices, vertex));
                }
            }
        }
        odd.retain(|_, vertices| !vertices.is_empty());
        odd
    }
}

/// Adds a vertex that is not in the set, and removes one that is.
fn toggle(vertices: &mut BTreeSet<u32>, vertex: u32) {
    if !vertices.remove(&vertex) {
        vertices.insert(vertex);
    }
}

impl View for Lines<'_> {
    fn parts(&self) -> Parts {
        Parts::NONE
    }

    fn vertex_slots(&self) -> usize {
        self.is_vertex.len()
    }

    fn half_edge_slots(&self) -> usize {
        2 * self.is_line.len()
    }

    fn is_vertex(&self, vertex: usize) -> bool {
        self.is_vertex[vertex]
    }

    fn is_half_edge(&self, half_edge: usize) -> bool {
        self.is_line[half_edge / 2]
    }

    fn origin(&self, half_edge: usize) -> Link {
        Some(self.ends[half_edge / 2][half_edge % 2] as usize)
    }

    fn twin(&self, half_edge: usize) -> Link {
        Some(half_edge ^ 1)
    }

    /// Each line turns back at its ends.
    fn next(&self, half_edge: usize) -> Link {
        Some(half_edge ^ 1)
    }
}

impl Embedding for Lines<'_> {
    fn point(&self, vertex: usize) -> Point {
        match vertex.checked_sub(self.topology.nodes.len()) {
            None => self.topology.points[vertex],
            Some(end) => self.without_node[end].0,
        }
    }

    fn bends(&self, half_edge: usize) -> usize {
        self.topology.bends(half_edge)
    }

    fn bend(&self, half_edge: usize, bend: usize) -> Point {
        self.topology.bend(half_edge, bend)
    }
}
