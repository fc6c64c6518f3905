//! Corruptions of several fields at once.
//!
//! Changing a single field usually changes a count, which is enough for a validator that only counts. Most of these corruptions
//! keep the number of links of each kind and their targets. The others join or move cycles, and update all links to them.

use crate::enumerate::{Cell, TableCells};
use std::mem::swap;
use twinedge::validate::{BoundaryPlace, BoundaryRow, FaceRow, Link, Part, Parts, Start, Table, View};

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Rows {
    Vertices,
    HalfEdges,
    Boundaries,
    Faces,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Exchange {
    /// The contents of two cells of a kind.
    Cells(Cell, Cell),
    /// Two whole records.
    Records(Rows, usize, usize),
    /// The labels of two cycles or isolated vertices, by the numbers of their entries in the lists of the faces; with the starts,
    /// the two bound each other's faces, at each other's places.
    Cycles { entries: [usize; 2], with_starts: bool },
    /// The lists of two faces; with the names, the listed records name the face that lists them.
    Lists { faces: [usize; 2], with_names: bool },
    /// A half-edge and its twin each become their own twin.
    OwnTwins(usize),
    /// Two half-edges become twins, and so do their former twins.
    Twins(usize, usize),
    /// The twins of three half-edges with the same origin are permuted cyclically: none leads back.
    TurnedTwins([usize; 3]),
    /// A loop becomes one half-edge, its own twin. The other one is removed, with everything that it alone bounded.
    Halved(usize),
    /// An isolated vertex without face gets one, as its outer boundary component.
    AddedFace(usize),
    /// The next half-edges of two half-edges are exchanged. `prev` is updated.
    Nexts(usize, usize),
    /// Permutes the nexts of three half-edges that end at one vertex; with the labels, each cycle is then one boundary component.
    Turned { half_edges: [usize; 3], with_labels: bool },
    /// The second of two cycles gets the label of the first, and its own list entry is removed.
    Joined([usize; 2]),
    /// An outer boundary component, by the number of its entry, becomes an inner one of that face. Its own face is removed.
    MadeInner { entry: usize, of: usize },
    /// An inner boundary component becomes the outer one of a new face.
    MadeOuter { entry: usize },
    /// Like `MadeOuter`, and a vertex on its cycle becomes the inner one in its place, as if it were isolated.
    MadeVertex { entry: usize },
    /// A face lists an inner boundary component several times: once more, or until R1 stops reading the list.
    Repeated { entry: usize, often: bool },
}

impl Exchange {
    /// Returns all of them, for a valid table and these parts.
    pub(super) fn all(table: &Table, parts: Parts) -> Vec<Self> {
        let mut all = cells(table, parts);
        all.extend(records(table, parts));
        all.extend(Self::structural(table, parts));
        all
    }

    /// Returns the exchanges of cycles, lists, twins and nexts: links that depend on one another are changed together.
    pub(super) fn structural(table: &Table, parts: Parts) -> Vec<Self> {
        let mut all = Vec::new();
        let entries = entries(table, parts);
        for [i, j] in pairs(entries.len()) {
            all.extend([true, false].map(|with_starts| Self::Cycles { entries: [i, j], with_starts }));
            all.extend([Self::Joined([i, j]), Self::Joined([j, i])]);
        }
        for (entry, listed) in entries.iter().enumerate().filter(|_| parts.has(Part::Holes)) {
            if listed.place == BoundaryPlace::Outer {
                let others = (0..table.faces.len()).filter(|f| table.is_face(*f) && *f != listed.face);
                all.extend(others.map(|of| Self::MadeInner { entry, of }));
            } else {
                all.extend([Self::MadeOuter { entry }, Self::MadeVertex { entry }]);
                all.extend([true, false].map(|often| Self::Repeated { entry, often }));
            }
        }
        if parts.has(Part::Holes) && parts.has(Part::Faces) {
            for faces in pairs(table.faces.len()).filter(|faces| faces.iter().all(|f| table.is_face(*f))) {
                if faces.iter().any(|f| table.inner_count(*f) > 0) {
                    all.extend([true, false].map(|with_names| Self::Lists { faces, with_names }));
                }
            }
        }
        if parts.has(Part::BoundaryComponents) && !parts.has(Part::UnboundedFace) {
            let live = |v: &usize| table.is_vertex(*v);
            let is_connected = |v: &usize| table.half_edges.iter().flatten().any(|row| row.origin == Some(*v));
            let alone =
                (0..table.vertices.len()).filter(|v| live(v) && !is_connected(v) && table.isolated(*v).is_none());
            all.extend(alone.map(Self::AddedFace));
        }
        let live: Vec<usize> = (0..table.half_edges.len()).filter(|h| table.is_half_edge(*h)).collect();
        let paired = |h: usize| table.twin(h).is_some();
        all.extend(live.iter().filter(|h| table.twin(**h).is_some_and(|t| t > **h)).map(|h| Self::OwnTwins(*h)));
        let is_loop = |h: usize| table.twin(h).is_some_and(|t| table.origin(t) == table.origin(h));
        all.extend(live.iter().filter(|h| is_loop(**h)).map(|h| Self::Halved(*h)));
        for [i, j] in pairs(live.len()) {
            let (g, h) = (live[i], live[j]);
            if paired(g) && paired(h) && table.twin(g) != Some(h) {
                all.push(Self::Twins(g, h));
            }
            all.push(Self::Nexts(g, h));
        }
        let target = |h: usize| table.next(h).and_then(|n| table.origin(n));
        for (i, j, k) in (0..live.len()).flat_map(|i| pairs(live.len()).map(move |[j, k]| (i, j, k))) {
            let half_edges = [live[i], live[j], live[k]];
            // The first is the smallest, in both directions of the permutation.
            if i < j && half_edges.iter().all(|h| target(*h) == target(live[i])) {
                for half_edges in [half_edges, [live[i], live[k], live[j]]] {
                    if half_edges.iter().all(|h| paired(*h)) {
                        all.push(Self::TurnedTwins(half_edges));
                    }
                    all.push(Self::Turned { half_edges, with_labels: false });
                    if parts.has(Part::Faces) {
                        all.push(Self::Turned { half_edges, with_labels: true });
                    }
                }
            }
        }
        all
    }

    pub(super) const fn kind(self) -> &'static str {
        match self {
            Self::Cells(..) => "exchanged: two cells",
            Self::Records(..) => "exchanged: two records",
            Self::Cycles { .. } => "exchanged: two cycles",
            Self::Lists { .. } => "exchanged: two lists",
            Self::OwnTwins(_) | Self::Twins(..) | Self::TurnedTwins(_) => "exchanged: twins",
            Self::Halved(_) => "halved: a loop",
            Self::AddedFace(_) => "added: a face",
            Self::Nexts(..) | Self::Turned { .. } => "exchanged: nexts",
            Self::Joined(_) => "joined: two cycles",
            Self::MadeInner { .. } | Self::MadeOuter { .. } | Self::MadeVertex { .. } => "moved: a cycle",
            Self::Repeated { .. } => "repeated: an entry",
        }
    }

    /// Applies it. Returns true if the table has changed; if not, it has no meaning.
    pub(super) fn apply(self, table: &mut Table, parts: Parts) -> bool {
        let before = table.clone();
        let done = match self {
            Self::Cells(one, other) => exchange_cells(table, one, other),
            Self::Records(rows, one, other) => {
                match rows {
                    Rows::Vertices => table.vertices.swap(one, other),
                    Rows::HalfEdges => table.half_edges.swap(one, other),
                    Rows::Boundaries => table.boundaries.swap(one, other),
                    Rows::Faces => table.faces.swap(one, other),
                }
                Some(())
            }
            Self::Cycles { entries, with_starts } => exchange_cycles(table, parts, entries, with_starts),
            Self::Lists { faces, with_names } => exchange_lists(table, parts, faces, with_names),
            Self::OwnTwins(h) => table.twin(h).map(|t| {
                set_twin(table, h, h);
                set_twin(table, t, t);
            }),
            Self::Twins(g, h) => table.twin(g).zip(table.twin(h)).map(|(twin_g, twin_h)| {
                pair(table, g, h);
                pair(table, twin_g, twin_h);
            }),
            Self::TurnedTwins([f, g, h]) => {
                table.twin(f).zip(table.twin(g)).zip(table.twin(h)).map(|((twin_f, twin_g), twin_h)| {
                    for (h, twin) in [(f, twin_g), (g, twin_h), (h, twin_f)] {
                        set_twin(table, h, twin);
                    }
                })
            }
            Self::Halved(h) => halve(table, parts, h),
            Self::AddedFace(v) => add_face(table, parts, v),
            Self::Nexts(g, h) => turn(table, parts, &[g, h]),
            Self::Turned { half_edges, with_labels } => turn(table, parts, &half_edges)
                .and_then(|()| if with_labels { label_cycles(table, parts) } else { Some(()) }),
            Self::Joined([kept, gone]) => {
                let all = entries(table, parts);
                all.get(kept).zip(all.get(gone)).and_then(|(kept, gone)| join(table, *kept, *gone))
            }
            Self::MadeInner { entry, of } => {
                entries(table, parts).get(entry).and_then(|entry| make_inner(table, *entry, of))
            }
            Self::MadeOuter { entry } => entries(table, parts).get(entry).and_then(|entry| make_outer(table, *entry)),
            Self::Repeated { entry, often } => {
                entries(table, parts).get(entry).and_then(|entry| repeat(table, *entry, often))
            }
            Self::MadeVertex { entry } => {
                entries(table, parts).get(entry).and_then(|entry| make_vertex(table, parts, *entry))
            }
        };
        done.is_some() && *table != before
    }
}

fn pairs(n: usize) -> impl Iterator<Item = [usize; 2]> {
    (0..n).flat_map(move |i| (i + 1..n).map(move |j| [i, j]))
}

fn cells(table: &Table, parts: Parts) -> Vec<Exchange> {
    let all = table.cells(parts);
    let alike = |i: usize, j: usize| std::mem::discriminant(&all[i]) == std::mem::discriminant(&all[j]);
    let alike = pairs(all.len()).filter(|[i, j]| alike(*i, *j));
    alike.map(|[i, j]| Exchange::Cells(all[i], all[j])).collect()
}

fn records(table: &Table, parts: Parts) -> Vec<Exchange> {
    let with_faces = parts.has(Part::Faces);
    let with_boundaries = with_faces && parts.has(Part::BoundaryComponents);
    let mut all = Vec::new();
    let mut of = |rows: Rows, wanted: bool, live: Vec<bool>| {
        let pairs = pairs(live.len()).filter(|[i, j]| wanted && live[*i] && live[*j]);
        all.extend(pairs.map(|[i, j]| Exchange::Records(rows, i, j)));
    };
    of(Rows::Vertices, true, table.vertices.iter().map(Option::is_some).collect());
    of(Rows::HalfEdges, true, table.half_edges.iter().map(Option::is_some).collect());
    of(Rows::Boundaries, with_boundaries, table.boundaries.iter().map(Option::is_some).collect());
    of(Rows::Faces, with_faces, table.faces.iter().map(Option::is_some).collect());
    all
}

fn exchange_cells(table: &mut Table, one: Cell, other: Cell) -> Option<()> {
    let any = *table.values(one).first()?;
    let held = table.set(one, any)?;
    let replaced = table.set(other, held)?;
    table.set(one, replaced)?;
    Some(())
}

/// An entry of the list of a face: the face, the place, and the start of the listed record.
#[derive(Clone, Copy)]
struct Entry {
    face: usize,
    place: BoundaryPlace,
    boundary: Link,
    start: Start,
}

/// Returns the entries of the lists of all faces, including the outer ones.
fn entries(table: &Table, parts: Parts) -> Vec<Entry> {
    let mut all = Vec::new();
    if !parts.has(Part::Faces) {
        return all;
    }
    for face in (0..table.faces.len()).filter(|f| table.is_face(*f)) {
        let inner = if parts.has(Part::Holes) { table.inner_count(face) } else { 0 };
        for place in std::iter::once(BoundaryPlace::Outer).chain((0..inner).map(BoundaryPlace::Inner)) {
            let boundary = match place {
                BoundaryPlace::Outer => table.outer(face),
                BoundaryPlace::Inner(i) => table.inner(face, i),
            };
            let start = match (parts.has(Part::BoundaryComponents), place) {
                (true, _) => boundary.and_then(|b| table.boundary_start(b)),
                (false, BoundaryPlace::Outer) => table.outer_half_edge(face).map(Start::HalfEdge),
                (false, BoundaryPlace::Inner(i)) => table.inner_start(face, i),
            };
            all.extend(start.map(|start| Entry { face, place, boundary, start }));
        }
    }
    all
}

/// Returns the half-edges on the cycle through one, if it closes.
fn cycle(table: &Table, start: Start) -> Vec<usize> {
    let Start::HalfEdge(first) = start else { return Vec::new() };
    let mut cycle = vec![first];
    while let Some(next) = cycle.last().and_then(|h| table.next(*h)).filter(|next| !cycle.contains(next)) {
        cycle.push(next);
    }
    cycle
}

/// Assigns the half-edges, or the isolated vertex, to the listed record of the entry.
fn label(table: &mut Table, start: Start, half_edges: &[usize], by: Entry) {
    for h in half_edges {
        if let Some(row) = table.half_edges.get_mut(*h).and_then(Option::as_mut) {
            match by.boundary {
                Some(b) => row.boundary = Some(b),
                None => row.face = Some(by.face),
            }
        }
    }
    if let (Start::Vertex(v), Some(b)) = (start, by.boundary)
        && let Some(row) = table.vertices.get_mut(v).and_then(Option::as_mut)
    {
        row.isolated = Some(b);
    }
}

fn set_start(table: &mut Table, entry: Entry, start: Start) -> Option<()> {
    if let Some(b) = entry.boundary {
        table.boundaries.get_mut(b)?.as_mut()?.start = Some(start);
        return Some(());
    }
    let row = table.faces.get_mut(entry.face)?.as_mut()?;
    match (entry.place, start) {
        (BoundaryPlace::Outer, Start::HalfEdge(h)) => row.outer_half_edge = Some(h),
        // Textbooks enter a face by a half-edge.
        (BoundaryPlace::Outer, Start::Vertex(_)) => return None,
        (BoundaryPlace::Inner(i), start) => *row.inner_starts.get_mut(i)? = Some(start),
    }
    Some(())
}

fn exchange_cycles(table: &mut Table, parts: Parts, numbers: [usize; 2], with_starts: bool) -> Option<()> {
    let all = entries(table, parts);
    let [one, other] = numbers.map(|number| all.get(number).copied());
    let (one, other) = one.zip(other)?;
    let cycles = [one, other].map(|entry| cycle(table, entry.start));
    label(table, one.start, &cycles[0], other);
    label(table, other.start, &cycles[1], one);
    if with_starts {
        set_start(table, one, other.start)?;
        set_start(table, other, one.start)?;
    }
    Some(())
}

fn exchange_lists(table: &mut Table, parts: Parts, [f, g]: [usize; 2], with_names: bool) -> Option<()> {
    let (before, after) = table.faces.split_at_mut(g);
    let (one, other) = (before.get_mut(f)?.as_mut()?, after.first_mut()?.as_mut()?);
    swap(&mut one.inner, &mut other.inner);
    swap(&mut one.inner_starts, &mut other.inner_starts);
    if !with_names {
        return Some(());
    }
    for entry in entries(table, parts) {
        if ![f, g].contains(&entry.face) || entry.place == BoundaryPlace::Outer {
            continue;
        }
        name(table, entry);
    }
    Some(())
}

fn set_twin(table: &mut Table, h: usize, twin: usize) {
    if let Some(row) = table.half_edges.get_mut(h).and_then(Option::as_mut) {
        row.twin = Some(twin);
    }
}

fn pair(table: &mut Table, g: usize, h: usize) {
    set_twin(table, g, h);
    set_twin(table, h, g);
}

fn add_face(table: &mut Table, parts: Parts, v: usize) -> Option<()> {
    let (b, face) = (table.boundaries.len(), table.faces.len());
    let place = parts.has(Part::Places).then_some(BoundaryPlace::Outer);
    table.boundaries.push(Some(BoundaryRow { face: Some(face), start: Some(Start::Vertex(v)), place }));
    table.faces.push(Some(FaceRow { outer: Some(b), ..FaceRow::default() }));
    if parts.has(Part::Holes) {
        table.vertices.get_mut(v)?.as_mut()?.isolated = Some(b);
    }
    Some(())
}

fn halve(table: &mut Table, parts: Parts, h: usize) -> Option<()> {
    let t = table.twin(h)?;
    let (v, after) = (table.origin(t)?, table.next(t)?);
    let live = (0..table.half_edges.len()).filter(|g| table.is_half_edge(*g)).collect::<Vec<_>>();
    let before = live.into_iter().find(|g| table.next(*g) == Some(t))?;
    for entry in entries(table, parts).into_iter().filter(|entry| entry.start == Start::HalfEdge(t)) {
        if after == t { unlist(table, entry, true)? } else { set_start(table, entry, Start::HalfEdge(after))? }
    }
    table.half_edges.get_mut(before)?.as_mut()?.next = Some(after);
    if parts.has(Part::Prev) {
        table.half_edges.get_mut(after)?.as_mut()?.prev = Some(before);
    }
    let vertex = table.vertices.get_mut(v)?.as_mut()?;
    vertex.leaving = vertex.leaving.map(|leaving| if leaving == t { h } else { leaving });
    set_twin(table, h, h);
    table.half_edges[t] = None;
    Some(())
}

/// Moves each next half-edge to the following half-edge of the list.
fn turn(table: &mut Table, parts: Parts, half_edges: &[usize]) -> Option<()> {
    let nexts: Vec<usize> = half_edges.iter().map(|h| table.next(*h)).collect::<Option<_>>()?;
    for (i, h) in half_edges.iter().enumerate() {
        let next = nexts[(i + 1) % nexts.len()];
        table.half_edges.get_mut(*h)?.as_mut()?.next = Some(next);
        if parts.has(Part::Prev) {
            table.half_edges.get_mut(next)?.as_mut()?.prev = Some(*h);
        }
    }
    Some(())
}

/// Leaves every cycle one of the boundary components that start on it, an inner one if possible. The others are removed, with the
/// faces that they enclose. `None` for a cycle without any, or if a face with holes would be removed.
fn label_cycles(table: &mut Table, parts: Parts) -> Option<()> {
    let mut all = entries(table, parts);
    all.sort_by_key(|entry| entry.place == BoundaryPlace::Outer);
    let mut labelled = vec![false; table.half_edges.len()];
    let mut gone: Vec<Entry> = Vec::new();
    for entry in all {
        let Start::HalfEdge(start) = entry.start else { continue };
        if *labelled.get(start)? {
            gone.push(entry);
            continue;
        }
        let half_edges = cycle(table, entry.start);
        for h in &half_edges {
            labelled[*h] = true;
        }
        label(table, entry.start, &half_edges, entry);
    }
    let has_face = |h: usize| table.boundary(h).is_some() || table.face(h).is_some();
    if (0..labelled.len()).any(|h| table.is_half_edge(h) && has_face(h) && !labelled[h]) {
        return None;
    }
    // From the last place to the first, so that no other entry moves.
    gone.iter().rev().try_for_each(|entry| unlist(table, *entry, true))
}

/// Removes an entry from the list of its face, or the face for the outer one, and optionally its record. `None` if a face with
/// holes would be removed.
fn unlist(table: &mut Table, entry: Entry, with_record: bool) -> Option<()> {
    match entry.place {
        BoundaryPlace::Outer if table.inner_count(entry.face) > 0 => return None,
        BoundaryPlace::Outer => table.faces[entry.face] = None,
        BoundaryPlace::Inner(i) => {
            let row = table.faces.get_mut(entry.face)?.as_mut()?;
            if entry.boundary.is_none() {
                row.inner_starts.remove(i);
            } else {
                row.inner.remove(i);
                for (place, b) in row.inner.iter().enumerate().skip(i) {
                    let moved = table.boundaries.get_mut((*b)?)?.as_mut()?;
                    moved.place = moved.place.map(|_| BoundaryPlace::Inner(place));
                }
            }
        }
    }
    if with_record && let Some(b) = entry.boundary {
        table.boundaries[b] = None;
    }
    Some(())
}

fn join(table: &mut Table, kept: Entry, gone: Entry) -> Option<()> {
    let (Start::HalfEdge(_), Start::HalfEdge(_)) = (kept.start, gone.start) else { return None };
    let half_edges = cycle(table, gone.start);
    label(table, gone.start, &half_edges, kept);
    unlist(table, gone, true)
}

fn make_inner(table: &mut Table, entry: Entry, of: usize) -> Option<()> {
    unlist(table, entry, false)?;
    let row = table.faces.get_mut(of)?.as_mut()?;
    if entry.boundary.is_some() {
        row.inner.push(entry.boundary);
    } else {
        row.inner_starts.push(Some(entry.start));
    }
    let place = BoundaryPlace::Inner(table.inner_count(of) - 1);
    name(table, Entry { face: of, place, ..entry });
    Some(())
}

fn make_outer(table: &mut Table, entry: Entry) -> Option<()> {
    let Start::HalfEdge(h) = entry.start else { return None };
    unlist(table, entry, false)?;
    let outer_half_edge = if entry.boundary.is_some() { None } else { Some(h) };
    table.faces.push(Some(FaceRow { outer: entry.boundary, outer_half_edge, ..FaceRow::default() }));
    name(table, Entry { face: table.faces.len() - 1, place: BoundaryPlace::Outer, ..entry });
    Some(())
}

fn make_vertex(table: &mut Table, parts: Parts, entry: Entry) -> Option<()> {
    make_outer(table, entry)?;
    let Start::HalfEdge(h) = entry.start else { return None };
    let start = Some(Start::Vertex(table.origin(h)?));
    let b = table.boundaries.len();
    let row = table.faces.get_mut(entry.face)?.as_mut()?;
    if entry.boundary.is_none() {
        row.inner_starts.push(start);
        return Some(());
    }
    let place = parts.has(Part::Places).then_some(BoundaryPlace::Inner(row.inner.len()));
    row.inner.push(Some(b));
    table.boundaries.push(Some(BoundaryRow { face: Some(entry.face), start, place }));
    Some(())
}

fn repeat(table: &mut Table, entry: Entry, often: bool) -> Option<()> {
    // More than twice the number of records that can be listed, plus 16.
    let records = table.boundaries.len() + table.half_edges.len() + table.vertices.len();
    let times = if often { 2 * records + 17 } else { 1 };
    let row = table.faces.get_mut(entry.face)?.as_mut()?;
    if entry.boundary.is_some() {
        row.inner.extend(std::iter::repeat_n(entry.boundary, times));
    } else {
        row.inner_starts.extend(std::iter::repeat_n(Some(entry.start), times));
    }
    Some(())
}

/// Makes each entry name the face that lists it, and the place.
fn name(table: &mut Table, entry: Entry) {
    if let Some(row) = entry.boundary.and_then(|b| table.boundaries.get_mut(b)).and_then(Option::as_mut) {
        row.face = Some(entry.face);
        row.place = row.place.map(|_| entry.place);
    } else {
        let half_edges = cycle(table, entry.start);
        label(table, entry.start, &half_edges, entry);
    }
}
