//! A second opinion on a list of faces: a slow and obvious implementation by sets, written from the definitions of the
//! kinds.

use std::collections::{BTreeMap, BTreeSet};
use twinedge_meshes::{Finding, IndexedMesh};

type Set = BTreeSet<usize>;

pub(crate) struct Opinion {
    pub(crate) findings: Vec<Finding>,
    /// The faces that are kept.
    pub(crate) kept: Vec<(usize, Vec<usize>)>,
    /// The faces of each edge, and whether each runs from the smaller vertex to the larger.
    pub(crate) edges: BTreeMap<(usize, usize), Vec<(usize, bool)>>,
}

fn directed_edges(face: &[usize]) -> Vec<(usize, usize)> {
    (0..face.len()).map(|i| (face[i], face[(i + 1) % face.len()])).collect()
}

fn is_rotation_of(a: &[usize], b: &[usize]) -> bool {
    a.len() == b.len() && (0..a.len()).any(|shift| (0..a.len()).all(|i| a[i] == b[(i + shift) % b.len()]))
}

/// Merges sets with common members until all are disjoint.
pub(crate) fn merged(mut sets: Vec<Set>) -> Vec<Set> {
    let mut done: Vec<Set> = Vec::new();
    while let Some(mut set) = sets.pop() {
        let (touching, apart): (Vec<_>, Vec<_>) = done.into_iter().partition(|other| !other.is_disjoint(&set));
        set.extend(touching.into_iter().flatten());
        done = apart;
        done.push(set);
    }
    done
}

pub(crate) fn opinion(mesh: &IndexedMesh) -> Opinion {
    let faces: Vec<Vec<usize>> = mesh.faces().map(|face| face.iter().map(|v| *v as usize).collect()).collect();
    let mut findings = Vec::new();
    if faces.is_empty() {
        findings.push(Finding::NoFaces);
    }

    // Degenerate faces.
    let mut sound = Vec::new();
    let mut with_repetition = Vec::new();
    for (f, face) in faces.iter().enumerate() {
        let distinct: Set = face.iter().copied().collect();
        if distinct.len() < 3 {
            let mut vertices: Vec<_> = distinct.into_iter().collect();
            vertices.sort_by_key(|v| face.iter().position(|w| w == v));
            findings.push(Finding::DegenerateFace { face: f, vertices });
        } else if let Some(again) = (0..face.len()).find(|i| face[..*i].contains(&face[*i])) {
            with_repetition.push(Finding::RepeatedVertex { face: f, vertex: face[again] });
        } else {
            sound.push((f, face.clone()));
        }
    }
    findings.extend(with_repetition);

    // Repeated faces.
    let mut kept: Vec<(usize, Vec<usize>)> = Vec::new();
    for (f, face) in sound {
        let backwards: Vec<_> = face.iter().rev().copied().collect();
        let earlier = kept.iter().find_map(|(g, other)| {
            let same = is_rotation_of(&face, other);
            (same || is_rotation_of(&backwards, other)).then_some((*g, !same))
        });
        match earlier {
            Some((first, reversed)) => {
                findings.push(Finding::RepeatedFace { face: f, first, reversed, vertices: face });
            }
            None => kept.push((f, face)),
        }
    }

    // Edges.
    let mut edges: BTreeMap<_, Vec<_>> = BTreeMap::new();
    for (f, face) in &kept {
        for (a, b) in directed_edges(face) {
            edges.entry((a.min(b), a.max(b))).or_default().push((*f, a < b));
        }
    }
    for ((a, b), sides) in &edges {
        if sides.len() >= 3 {
            let faces = sides.iter().map(|(f, _)| *f).collect();
            findings.push(Finding::NonManifoldEdge { vertices: [*a, *b], faces });
        }
    }
    for ((a, b), sides) in &edges {
        if let [(f, up), (g, also_up)] = sides[..]
            && up == also_up
        {
            let vertices = if up { [*a, *b] } else { [*b, *a] };
            findings.push(Finding::FlippedFaces { vertices, faces: [f, g] });
        }
    }

    // Vertices.
    for v in 0..mesh.points().len() {
        let faces_here: Vec<usize> = kept.iter().filter(|(_, face)| face.contains(&v)).map(|(f, _)| *f).collect();
        let alone = faces_here.iter().map(|f| Set::from([*f]));
        let at_edges = edges.iter().filter(|((a, b), _)| *a == v || *b == v);
        let together = at_edges.map(|(_, sides)| sides.iter().map(|(f, _)| *f).collect());
        let fans = merged(alone.chain(together).collect());
        if fans.len() > 1 {
            let mut firsts: Vec<_> = fans.iter().filter_map(|fan| fan.first().copied()).collect();
            firsts.sort_unstable();
            findings.push(Finding::NonManifoldVertex { vertex: v, faces: firsts });
        }
    }
    for vertex in 0..mesh.points().len() {
        if !kept.iter().any(|(_, face)| face.contains(&vertex)) {
            findings.push(Finding::UnusedVertex { vertex });
        }
    }
    Opinion { findings, kept, edges }
}

impl Opinion {
    pub(crate) fn used_vertices(&self) -> Set {
        self.kept.iter().flat_map(|(_, face)| face.iter().copied()).collect()
    }

    pub(crate) fn components(&self) -> usize {
        merged(self.kept.iter().map(|(_, face)| face.iter().copied().collect()).collect()).len()
    }

    /// The connected sets of border edges, by vertices.
    pub(crate) fn border_graph_components(&self) -> usize {
        let border = self.edges.iter().filter(|(_, sides)| sides.len() == 1);
        merged(border.map(|((a, b), _)| Set::from([*a, *b])).collect()).len()
    }

    /// Tries all ways to reverse faces.
    pub(crate) fn orientable(&self) -> bool {
        let rank: BTreeMap<usize, usize> = self.kept.iter().enumerate().map(|(i, (f, _))| (*f, i)).collect();
        let pairs: Vec<_> = self.edges.values().filter(|sides| sides.len() == 2).collect();
        (0_u64..1 << self.kept.len()).any(|turned| {
            pairs.iter().all(|sides| {
                let runs = |(f, up): (usize, bool)| up != (turned >> rank[&f] & 1 == 1);
                runs(sides[0]) != runs(sides[1])
            })
        })
    }
}
