//! The tree of containment: the components in each face, and the code of the whole.

use super::map::{Map, Search, fill};
use crate::slots::NIL;
use crate::validate::{Start, View};
use alloc::vec::Vec;
use core::ops::Range;

/// The contents of the faces of a view, and the codes found so far.
#[derive(Debug, Default)]
pub(super) struct Nesting {
    /// By cycle: the face that it bounds from outside; NIL if it is the outside of its component.
    inside: Vec<u32>,
    /// By component: a half-edge of its outside cycle, and the face that lists it.
    outsides: Vec<(u32, u32)>,
    /// By face: how many isolated vertices it lists.
    isolated: Vec<u32>,
    unbounded: u32,
    /// By face: where its components begin in `contents`; one more at the end.
    begins: Vec<u32>,
    contents: Vec<u32>,
    /// By component: where its cycles begin in `cycles`; one more at the end.
    cycle_begins: Vec<u32>,
    cycles: Vec<u32>,
    /// The components level by level, the outermost first, and where each level ends.
    levels: Vec<u32>,
    ends: Vec<usize>,
    /// By component: its rank in its level, and its code, a stretch of `codes`.
    ranks: Vec<u32>,
    spans: Vec<Range<usize>>,
    codes: Vec<u32>,
    /// By face: its note, a stretch of `notes`.
    note_spans: Vec<Range<usize>>,
    notes: Vec<u32>,
    result: Vec<u32>,
}

impl Nesting {
    /// Reads the faces of a view; `None` unless each cycle, isolated vertex and component has exactly one place. O(n).
    pub(super) fn read<V: View + ?Sized>(&mut self, map: &mut Map, view: &V) -> Option<()> {
        let faces = view.face_slots();
        u32::try_from(faces).ok().filter(|faces| *faces < NIL)?;
        fill(&mut self.inside, map.cycles.len(), NIL)?;
        fill(&mut self.outsides, map.components(), (NIL, NIL))?;
        fill(&mut self.isolated, faces, 0)?;
        map.mark_busy(view)?;
        self.unbounded = NIL;
        let mut listed = 0;
        for f in (0..faces).filter(|f| view.is_face(*f)) {
            match outer_start(view, f) {
                Some(Start::HalfEdge(h)) => {
                    let cycle = map.cycle[map.dense(h)? as usize] as usize;
                    if core::mem::replace(&mut self.inside[cycle], f as u32) != NIL {
                        return None;
                    }
                    listed += 1;
                }
                None if self.unbounded == NIL => self.unbounded = f as u32,
                _ => return None,
            }
            for position in 0..view.inner_count(f) {
                match inner_start(view, f, position)? {
                    Start::HalfEdge(h) => {
                        let h = map.dense(h)?;
                        let outside = &mut self.outsides[map.component[h as usize] as usize];
                        if outside.0 != NIL {
                            return None;
                        }
                        *outside = (h, f as u32);
                        listed += 1;
                    }
                    Start::Vertex(v) => {
                        map.mark_isolated(v)?;
                        self.isolated[f] += 1;
                    }
                }
            }
        }
        // Each component has one outside, so with this number of entries every cycle is covered once if none is covered
        // twice.
        let once = |(h, _): &(u32, u32)| *h != NIL && self.inside[map.cycle[*h as usize] as usize] == NIL;
        if !map.all_busy(view) || self.unbounded == NIL || listed != map.cycles.len() || !self.outsides.iter().all(once)
        {
            return None;
        }
        self.sort_contents(faces)?;
        self.sort_cycles(map)?;
        self.sort_levels(map)
    }

    fn sort_contents(&mut self, faces: usize) -> Option<()> {
        let keys = self.outsides.iter().map(|(_, f)| *f);
        sort_by_key(keys, faces, &mut self.begins, &mut self.contents)
    }

    fn sort_cycles(&mut self, map: &Map) -> Option<()> {
        let keys = map.cycles.iter().map(|h| map.component[*h as usize]);
        sort_by_key(keys, map.components(), &mut self.cycle_begins, &mut self.cycles)
    }

    /// Sorts level by level, from the unbounded face inwards; `None` if a component is never reached because it lies
    /// inside itself.
    fn sort_levels(&mut self, map: &Map) -> Option<()> {
        self.levels.clear();
        self.ends.clear();
        self.levels.extend_from_slice(stretch(&self.begins, &self.contents, self.unbounded));
        let mut done = 0;
        while done < self.levels.len() {
            self.ends.push(self.levels.len());
            for position in done..self.levels.len() {
                for cycle in stretch(&self.cycle_begins, &self.cycles, self.levels[position]) {
                    let f = self.inside[*cycle as usize];
                    if f != NIL {
                        self.levels.extend_from_slice(stretch(&self.begins, &self.contents, f));
                    }
                }
            }
            done = self.ends.last().copied().unwrap_or(self.levels.len());
        }
        (self.levels.len() == map.components()).then_some(())
    }

    /// The code: the contents of the unbounded face, then the distinct codes of each level, outermost first.
    pub(super) fn code(&mut self, map: &Map, search: &mut Search) -> &[u32] {
        self.ranks.clear();
        self.ranks.resize(map.components(), 0);
        self.spans.clear();
        self.spans.resize(map.components(), 0..0);
        self.note_spans.clear();
        self.note_spans.resize(self.isolated.len(), 0..0);
        self.codes.clear();
        self.notes.clear();
        let mut end = self.levels.len();
        for level in (0..self.ends.len()).rev() {
            let begin = level.checked_sub(1).map_or(0, |above| self.ends[above]);
            for position in begin..end {
                self.write_code(map, search, self.levels[position]);
            }
            self.rank(begin..end);
            end = begin;
        }
        self.write_note(self.unbounded);
        self.result.clear();
        self.result.extend_from_slice(&self.notes[self.note_spans[self.unbounded as usize].clone()]);
        let mut begin = 0;
        for end in self.ends.iter().copied() {
            let mut last = NIL;
            for c in self.levels[begin..end].iter().map(|c| *c as usize) {
                if core::mem::replace(&mut last, self.ranks[c]) != self.ranks[c] {
                    let code = &self.codes[self.spans[c].clone()];
                    self.result.push(code.len() as u32);
                    self.result.extend_from_slice(code);
                }
            }
            // No code is empty, so this ends the level.
            self.result.push(0);
            begin = end;
        }
        &self.result
    }

    /// Computes the code of a component. The components in its faces must have their ranks already.
    fn write_code(&mut self, map: &Map, search: &mut Search, component: u32) {
        for i in range(&self.cycle_begins, component) {
            let f = self.inside[self.cycles[i] as usize];
            if f != NIL {
                self.write_note(f);
            }
        }
        search.begin(map.len());
        let first = self.outsides[component as usize].0;
        let mut root = first;
        loop {
            search.offer(map, root, |h| match self.inside[map.cycle[h as usize] as usize] {
                NIL => &[],
                f => &self.notes[self.note_spans[f as usize].clone()],
            });
            root = map.next[root as usize];
            if root == first {
                break;
            }
        }
        let begin = self.codes.len();
        self.codes.extend_from_slice(search.least());
        self.spans[component as usize] = begin..self.codes.len();
    }

    /// Writes the contents of a face: the number of isolated vertices, the number of components, and their ranks.
    fn write_note(&mut self, face: u32) {
        let begin = self.notes.len();
        let contents = stretch(&self.begins, &self.contents, face);
        self.notes.extend([self.isolated[face as usize], contents.len() as u32]);
        self.notes.extend(contents.iter().map(|c| self.ranks[*c as usize]));
        self.notes[begin + 2..].sort_unstable();
        self.note_spans[face as usize] = begin..self.notes.len();
    }

    fn rank(&mut self, level: Range<usize>) {
        let code = |c: u32| &self.codes[self.spans[c as usize].clone()];
        self.levels[level.clone()].sort_by(|a, b| code(*a).cmp(code(*b)));
        let mut rank = 0;
        let mut last: Option<u32> = None;
        for c in &self.levels[level] {
            if last.is_some_and(|last| code(last) != code(*c)) {
                rank += 1;
            }
            self.ranks[*c as usize] = rank;
            last = Some(*c);
        }
    }
}

/// The start of the outer boundary component of a face, stored directly or through the component.
fn outer_start<V: View + ?Sized>(view: &V, face: usize) -> Option<Start> {
    match view.outer(face) {
        Some(b) => view.boundary_start(b),
        None => view.outer_half_edge(face).map(Start::HalfEdge),
    }
}

/// The start of an inner boundary component of a face, stored directly or through the component.
fn inner_start<V: View + ?Sized>(view: &V, face: usize, position: usize) -> Option<Start> {
    match view.inner(face, position) {
        Some(b) => view.boundary_start(b),
        None => view.inner_start(face, position),
    }
}

/// Sorts `0..` by keys below `count`: fills the beginning of each key and the sorted numbers. O(n + count).
fn sort_by_key(
    keys: impl Iterator<Item = u32> + Clone,
    count: usize,
    begins: &mut Vec<u32>,
    sorted: &mut Vec<u32>,
) -> Option<()> {
    fill(begins, count + 1, 0)?;
    let mut len = 0;
    for key in keys.clone() {
        begins[key as usize + 1] += 1;
        len += 1;
    }
    for key in 0..count {
        begins[key + 1] += begins[key];
    }
    fill(sorted, len, 0)?;
    for (number, key) in keys.enumerate() {
        let place = &mut begins[key as usize];
        sorted[*place as usize] = number as u32;
        *place += 1;
    }
    // Each beginning has moved to the next key's.
    begins.rotate_right(1);
    begins[0] = 0;
    Some(())
}

fn range(begins: &[u32], key: u32) -> Range<usize> {
    begins[key as usize] as usize..begins[key as usize + 1] as usize
}

fn stretch<'a>(begins: &[u32], sorted: &'a [u32], key: u32) -> &'a [u32] {
    &sorted[range(begins, key)]
}
