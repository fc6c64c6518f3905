//! Which features cover each face, and which run along each edge.
//!
//! Few sets of features occur on a map, and most of them on many faces or edges: a country on each of its faces, two
//! countries along their border. So every set is kept once, for good, and a face or an edge holds its number. Giving a new
//! face the set of another is a copy of one number, which is what edits do most.

use super::feature::FeatureId;
use rustc_hash::FxHashMap;

/// The number of a set of features.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub(super) struct SetId(u32);

/// The sets of features of the faces and edges of a map, by index.
#[derive(Clone, Debug)]
pub(super) struct FeatureSets {
    /// Each sorted, without repetition. The first is the empty one.
    sets: Vec<Box<[FeatureId]>>,
    numbers: FxHashMap<Box<[FeatureId]>, SetId>,
    faces: Vec<SetId>,
    /// By half the index of either half-edge.
    edges: Vec<SetId>,
}

impl Default for FeatureSets {
    fn default() -> Self {
        let numbers = FxHashMap::from_iter([(Box::default(), SetId(0))]);
        Self { sets: vec![Box::default()], numbers, faces: Vec::new(), edges: Vec::new() }
    }
}

impl FeatureSets {
    /// From sorted pairs: the index of a face and the number of a feature that covers it; the smaller index of the two
    /// half-edges of an edge and the number of a feature that runs along it. O(pairs), expected.
    pub(super) fn new(covering: &[(u32, u32)], running: &[(u32, u32)]) -> Self {
        let mut features = Self::default();
        let mut set = Vec::new();
        let mut last = SetId(0);
        let mut take = |pairs: &[(u32, u32)], per_index: u32, column: fn(&mut Self) -> &mut Vec<SetId>| {
            for same in pairs.chunk_by(|a, b| a.0 == b.0) {
                set.clear();
                set.extend(same.iter().map(|(_, feature)| FeatureId(*feature)));
                // What comes together often belongs to the same features.
                if *features.sets[last.0 as usize] != *set {
                    last = features.number(&set);
                }
                put(column(&mut features), (same[0].0 / per_index) as usize, last);
            }
        };
        take(covering, 1, |features| &mut features.faces);
        take(running, 2, |features| &mut features.edges);
        features
    }

    /// The number of a set that is sorted and has no repetition. O(its size), expected.
    pub(super) fn number(&mut self, set: &[FeatureId]) -> SetId {
        if let Some(known) = self.numbers.get(set) {
            return *known;
        }
        let number = SetId(self.sets.len() as u32);
        self.sets.push(set.into());
        self.numbers.insert(set.into(), number);
        number
    }

    /// The features of a set, in order. O(1).
    pub(super) fn set(&self, number: SetId) -> &[FeatureId] {
        &self.sets[number.0 as usize]
    }

    /// What covers the face with this index. O(1).
    pub(super) fn of_face(&self, face: usize) -> SetId {
        self.faces.get(face).copied().unwrap_or_default()
    }

    /// What runs along the edge of the half-edge with this index. O(1).
    pub(super) fn along(&self, half_edge: usize) -> SetId {
        self.edges.get(half_edge / 2).copied().unwrap_or_default()
    }

    pub(super) fn put_face(&mut self, face: usize, set: SetId) {
        put(&mut self.faces, face, set);
    }

    pub(super) fn put_along(&mut self, half_edge: usize, set: SetId) {
        put(&mut self.edges, half_edge / 2, set);
    }

    /// The set of those in both. O(sizes).
    pub(super) fn common(&mut self, a: SetId, b: SetId) -> SetId {
        self.combined(a, b, |in_a, in_b| in_a && in_b)
    }

    /// The set of those in either. O(sizes).
    pub(super) fn either(&mut self, a: SetId, b: SetId) -> SetId {
        self.combined(a, b, |in_a, in_b| in_a || in_b)
    }

    /// The set of those in one and not in the other. O(sizes).
    pub(super) fn differing(&mut self, a: SetId, b: SetId) -> SetId {
        self.combined(a, b, |in_a, in_b| in_a != in_b)
    }

    fn combined(&mut self, a: SetId, b: SetId, keep: fn(bool, bool) -> bool) -> SetId {
        if a == b {
            return if keep(true, true) { a } else { SetId(0) };
        }
        let (one, other) = (self.set(a), self.set(b));
        let mut all: Vec<FeatureId> = one.iter().chain(other).copied().collect();
        all.sort_unstable();
        all.dedup();
        all.retain(|f| keep(one.binary_search(f).is_ok(), other.binary_search(f).is_ok()));
        self.number(&all)
    }
}

/// Writes into a column, which grows as needed.
pub(super) fn put<T: Copy + Default>(column: &mut Vec<T>, index: usize, value: T) {
    if index >= column.len() {
        column.resize(index + 1, T::default());
    }
    column[index] = value;
}
