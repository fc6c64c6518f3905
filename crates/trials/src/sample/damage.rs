//! Random damage to tables.
//!
//! Setting a single cell to a random value usually breaks R1, or changes a count. Most kinds of damage therefore keep the counts:
//! two cells, two records, two cycles or the lists of two faces are exchanged, with or without the links that lead there.

use super::subdivision::shuffle;
use crate::enumerate::{Cell, TableCells};
use crate::random::Random;
use std::mem::swap;
use twinedge::validate::{BoundaryPlace, Link, Parts, Start, Table, View};

type Damage = fn(&mut Table, &mut Random);

const KINDS: [Damage; 15] = [
    set_cell,
    copy_cell,
    copy_cell,
    swap_cells,
    swap_cells,
    swap_records,
    retire_or_copy_record,
    rotate_next,
    rotate_next,
    exchange_twins,
    exchange_cycles,
    join_cycles,
    exchange_lists,
    lengthen_or_shorten_list,
    overfill_list,
];

pub(super) fn damage(table: &mut Table, random: &mut Random) {
    KINDS[random.below(KINDS.len())](table, random);
}

fn any_cell(table: &Table, random: &mut Random) -> Option<Cell> {
    let cells = table.cells(Parts::ALL);
    cells.get(random.below(cells.len())).copied()
}

/// Sets a cell to a random value, including nil, vacant slots and the largest number.
fn set_cell(table: &mut Table, random: &mut Random) {
    let Some(cell) = any_cell(table, random) else { return };
    let values = table.values(cell);
    table.set(cell, values[random.below(values.len())]);
}

fn alike(table: &Table, cell: Cell, random: &mut Random) -> Cell {
    let kind = std::mem::discriminant(&cell);
    let cells = table.cells(Parts::ALL).into_iter();
    let cells: Vec<Cell> = cells.filter(|other| std::mem::discriminant(other) == kind).collect();
    cells[random.below(cells.len())]
}

fn copy_cell(table: &mut Table, random: &mut Random) {
    let Some(cell) = any_cell(table, random) else { return };
    let other = alike(table, cell, random);
    let any = table.values(other)[0];
    if let Some(held) = table.set(other, any) {
        table.set(other, held);
        table.set(cell, held);
    }
}

fn swap_cells(table: &mut Table, random: &mut Random) {
    let Some(cell) = any_cell(table, random) else { return };
    let other = alike(table, cell, random);
    let any = table.values(other)[0];
    if let Some(held) = table.set(other, any)
        && let Some(replaced) = table.set(cell, held)
        && cell != other
    {
        table.set(other, replaced);
    }
}

fn swap_two<T>(rows: &mut [T], random: &mut Random) {
    if !rows.is_empty() {
        rows.swap(random.below(rows.len()), random.below(rows.len()));
    }
}

fn swap_records(table: &mut Table, random: &mut Random) {
    match random.below(4) {
        0 => swap_two(&mut table.vertices, random),
        1 => swap_two(&mut table.half_edges, random),
        2 => swap_two(&mut table.boundaries, random),
        _ => swap_two(&mut table.faces, random),
    }
}

/// Copies a row, vacant or not, over another one, or to the end.
fn copy_row<T: Clone>(rows: &mut Vec<Option<T>>, random: &mut Random) {
    let row = rows.get(random.below(rows.len())).cloned().flatten();
    let row = if random.below(2) == 0 { None } else { row };
    let to = random.below(rows.len() + 1);
    if to < rows.len() { rows[to] = row } else { rows.push(row) }
}

fn retire_or_copy_record(table: &mut Table, random: &mut Random) {
    match random.below(5) {
        0 => copy_row(&mut table.vertices, random),
        1 => copy_row(&mut table.half_edges, random),
        2 => copy_row(&mut table.boundaries, random),
        3 => copy_row(&mut table.faces, random),
        // A vertex without any link.
        _ => table.vertices.push(Some(twinedge::validate::VertexRow::default())),
    }
}

fn live_half_edges(table: &Table) -> Vec<usize> {
    (0..table.half_edges.len()).filter(|h| table.is_half_edge(*h)).collect()
}

/// Rotates the next half-edges of two or three half-edges, with their `prev`. Usually of the same vertex, so that L3 holds.
fn rotate_next(table: &mut Table, random: &mut Random) {
    let mut around = live_half_edges(table);
    shuffle(&mut around, random);
    let Some(first) = around.first().copied() else { return };
    if random.below(4) > 0 {
        let target = |h: usize| table.twin(h).and_then(|twin| table.origin(twin));
        around.retain(|h| target(*h) == target(first));
    }
    around.truncate(2 + random.below(2));
    let nexts: Vec<Link> = around.iter().map(|h| table.next(*h)).collect();
    for (i, h) in around.iter().enumerate() {
        let next = nexts[(i + 1) % nexts.len()];
        if let Some(row) = table.half_edges[*h].as_mut() {
            row.next = next;
        }
        if let Some(row) = next.and_then(|next| table.half_edges.get_mut(next)?.as_mut()) {
            row.prev = Some(*h);
        }
    }
}

/// Pairs the half-edges of two edges the other way.
fn exchange_twins(table: &mut Table, random: &mut Random) {
    let live = live_half_edges(table);
    if live.is_empty() {
        return;
    }
    let [g, h] = [0; 2].map(|_| live[random.below(live.len())]);
    let (Some(twin_g), Some(twin_h)) = (table.twin(g), table.twin(h)) else { return };
    if g == h || twin_g == h {
        return;
    }
    for (a, b) in [(g, twin_h), (h, twin_g)] {
        for (a, b) in [(a, b), (b, a)] {
            if let Some(row) = table.half_edges.get_mut(a).and_then(Option::as_mut) {
                row.twin = Some(b);
            }
        }
    }
}

fn two_boundaries(table: &Table, random: &mut Random) -> Option<[usize; 2]> {
    let live: Vec<usize> = (0..table.boundaries.len()).filter(|b| table.is_boundary(*b)).collect();
    if live.is_empty() { None } else { Some([0; 2].map(|_| live[random.below(live.len())])) }
}

/// Exchanges the faces that the cycles of two boundary components, or isolated vertices, bound. Sometimes the starts stay.
fn exchange_cycles(table: &mut Table, random: &mut Random) {
    let Some([b, c]) = two_boundaries(table, random) else { return };
    let exchanged = |link: Link| match link {
        Some(i) if i == b => Some(c),
        Some(i) if i == c => Some(b),
        other => other,
    };
    for row in table.half_edges.iter_mut().flatten() {
        row.boundary = exchanged(row.boundary);
    }
    for row in table.vertices.iter_mut().flatten() {
        row.isolated = exchanged(row.isolated);
    }
    if random.below(4) > 0 {
        let starts = [b, c].map(|b| table.boundary_start(b));
        for (b, start) in [(b, starts[1]), (c, starts[0])] {
            if let Some(row) = table.boundaries[b].as_mut() {
                row.start = start;
            }
        }
    }
}

/// Makes the half-edges of one boundary component name another one.
fn join_cycles(table: &mut Table, random: &mut Random) {
    let Some([b, c]) = two_boundaries(table, random) else { return };
    for row in table.half_edges.iter_mut().flatten().filter(|row| row.boundary == Some(b)) {
        row.boundary = Some(c);
    }
    if random.below(2) == 0
        && let Some(Start::HalfEdge(_)) = table.boundary_start(b)
        && let Some(row) = table.boundaries[b].as_mut()
    {
        row.start = None;
    }
}

fn any_face(table: &Table, random: &mut Random) -> Option<usize> {
    let live: Vec<usize> = (0..table.faces.len()).filter(|f| table.is_face(*f)).collect();
    live.get(random.below(live.len())).copied()
}

/// Makes the inner boundary components of a face's list name the face and their place.
fn name_listing_face(table: &mut Table, f: usize) {
    for i in 0..table.inner_count(f) {
        if let Some(b) = table.inner(f, i)
            && let Some(row) = table.boundaries.get_mut(b).and_then(Option::as_mut)
        {
            (row.face, row.place) = (Some(f), Some(BoundaryPlace::Inner(i)));
        }
    }
}

/// Exchanges the lists of two faces. The listed records usually follow.
fn exchange_lists(table: &mut Table, random: &mut Random) {
    let (Some(f), Some(g)) = (any_face(table, random), any_face(table, random)) else { return };
    if f == g {
        return;
    }
    let [low, high] = [f.min(g), f.max(g)];
    let (before, after) = table.faces.split_at_mut(high);
    if let (Some(one), Some(other)) = (&mut before[low], &mut after[0]) {
        swap(&mut one.inner, &mut other.inner);
    }
    if random.below(4) > 0 {
        name_listing_face(table, f);
        name_listing_face(table, g);
    }
}

/// Makes a face list a boundary component once more, or once less.
fn lengthen_or_shorten_list(table: &mut Table, random: &mut Random) {
    let Some(f) = any_face(table, random) else { return };
    let listed = two_boundaries(table, random).map(|[b, _]| b);
    let Some(row) = table.faces[f].as_mut() else { return };
    let at = random.below(row.inner.len() + 1);
    if random.below(2) == 0 {
        row.inner.insert(at, listed);
    } else if at < row.inner.len() {
        row.inner.remove(at);
    }
    if random.below(2) == 0 {
        name_listing_face(table, f);
    }
}

/// Makes a list longer than R1 allows: twice the number of boundary components, plus 16.
fn overfill_list(table: &mut Table, random: &mut Random) {
    let Some(f) = any_face(table, random) else { return };
    let listed = two_boundaries(table, random).map(|[b, _]| b);
    let longest = 2 * table.boundaries.len() + 16;
    let Some(row) = table.faces[f].as_mut() else { return };
    row.inner.resize(longest + random.below(2), listed);
}
