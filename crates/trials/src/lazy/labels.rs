//! Labels as a checker of certificates reads them, and their columns.

use super::work::{Claim, LazyError, LazyWork, MOST_SLOTS};
use std::fmt;
use twinedge::validate::Part;
use twinedge_certificate::{Column, Columns, Labels, Numbers};

/// The labels of a table, whose cells can be open.
#[derive(Clone, Copy)]
pub struct LazyLabels<'a>(&'a dyn LabelSource);

pub(super) trait LabelSource {
    fn count(&self, column: Column) -> usize;
    fn at(&self, column: Column, entry: usize) -> Option<u32>;
}

impl<'a> LazyLabels<'a> {
    pub(super) fn new(labels: &'a dyn LabelSource) -> Self {
        Self(labels)
    }
}

impl LabelSource for Labels {
    fn count(&self, column: Column) -> usize {
        self.column(column).len()
    }

    fn at(&self, column: Column, entry: usize) -> Option<u32> {
        self.column(column).get(entry).copied()
    }
}

/// A column of [`LazyLabels`].
#[derive(Clone, Copy)]
pub struct LazyColumn<'a> {
    labels: LazyLabels<'a>,
    column: Column,
}

impl Columns for LazyLabels<'_> {
    type Numbers<'a>
        = LazyColumn<'a>
    where
        Self: 'a;

    fn column(&self, column: Column) -> LazyColumn<'_> {
        LazyColumn { labels: *self, column }
    }
}

impl Numbers for LazyColumn<'_> {
    fn count(self) -> usize {
        self.labels.0.count(self.column)
    }

    fn at(self, entry: usize) -> Option<u32> {
        self.labels.0.at(self.column, entry)
    }
}

/// The columns with entries, each with its name and its numbers.
impl fmt::Display for LazyLabels<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for column in Column::ALL.into_iter().filter(|column| self.0.count(*column) > 0) {
            write!(f, " {}", column.name())?;
            for number in (0..self.0.count(column)).filter_map(|entry| self.0.at(column, entry)) {
                if number == u32::MAX { f.write_str(" -")? } else { write!(f, " {number}")? }
            }
        }
        Ok(())
    }
}

impl fmt::Debug for LazyLabels<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("LazyLabels").finish_non_exhaustive()
    }
}

impl fmt::Debug for LazyColumn<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("LazyColumn").field(&self.column).finish()
    }
}

pub(super) struct Shape {
    pub(super) column: Column,
    pub(super) longest: usize,
    /// True if it can be shorter. An absent entry of links is nil, so shorter columns of links are no different ones.
    pub(super) is_any_length: bool,
    pub(super) entries: Entries,
}

/// The entries of a column: nil, or a number from 0 below a bound.
pub(super) enum Entries {
    Links(usize),
    /// Ranks or positions: those in the same order are equivalent.
    Ordered(usize),
}

/// Returns the columns of the labels of this work: for links that its tables do not store, and numbers that are always labels.
///
/// A link leads to each slot or to the one past the end, as in tables. As many ranks as half-edges, and nil, can be in any order.
///
/// # Errors
/// [`LazyError::NoCertificates`].
pub(super) fn shapes(work: &LazyWork) -> Result<Vec<Shape>, LazyError> {
    let claim = work.claim()?;
    let LazyWork { vertices, half_edges, boundaries, faces, .. } = *work;
    let has = |part| work.parts().has(part);
    let (by_record, has_faces) = (has(Part::BoundaryComponents), has(Part::Faces));
    let in_plane = matches!(claim, Claim::Plane);
    // The list of a face of a table has one entry per vertex; in labels each boundary component is listed once.
    let places = if by_record { vertices } else { boundaries };
    let mut shapes = Vec::new();
    let mut add = |is_label, is_any_length, column, longest, entries| {
        if is_label {
            shapes.push(Shape { column, longest, is_any_length, entries });
        }
    };
    let links = |slots| Entries::Links(slots + 1);
    let ordered = || Entries::Ordered(half_edges);
    add(true, true, Column::HalfEdgeRank, half_edges + 1, ordered());
    add(!has(Part::Prev), false, Column::HalfEdgePrev, half_edges, links(half_edges));
    add(!has(Part::Leaving), false, Column::VertexLeaving, vertices, links(half_edges));
    add(!in_plane, true, Column::HalfEdgeTurn, half_edges, ordered());
    add(!in_plane, true, Column::HalfEdgeStep, half_edges, ordered());
    add(!in_plane, true, Column::HalfEdgeComponent, half_edges, links(half_edges));
    // On surfaces, faces that half-edges name are their own boundary components.
    let has_cycles = !by_record && (in_plane || !has_faces);
    add(has_cycles, false, Column::HalfEdgeBoundary, half_edges, links(boundaries));
    add(has_cycles, true, Column::BoundaryFace, boundaries, links(faces));
    add(has_cycles, false, Column::BoundaryStart, boundaries, links(half_edges));
    add(has_cycles, false, Column::BoundaryVertex, boundaries, links(vertices));
    add(!has(Part::Places) && (by_record || in_plane), false, Column::BoundaryPlace, boundaries, links(places));
    let has_lists = !by_record && in_plane;
    add(has_lists, false, Column::VertexIsolated, vertices, links(boundaries));
    add(has_lists, !has_faces, Column::FaceOuter, faces, links(boundaries));
    // Ends are numbers of entries: one more than there are.
    add(has_lists, false, Column::FaceEnd, faces, links(boundaries + 1));
    add(has_lists, false, Column::FaceInner, boundaries, links(boundaries));
    Ok(shapes)
}

/// The distinct numbers that were read in a column, in ascending order.
#[derive(Default)]
pub(super) struct Order {
    numbers: [u32; MOST_SLOTS + 1],
    count: usize,
}

impl Order {
    /// Returns the number of places for one more among this many.
    pub(super) const fn places(numbers: usize) -> usize {
        2 * numbers + 1
    }

    pub(super) fn add(&mut self, number: u32) {
        if let Err(at) = self.numbers[..self.count].binary_search(&number) {
            self.numbers.copy_within(at..self.count, at + 1);
            self.numbers[at] = number;
            self.count += 1;
        }
    }

    /// Returns the number at this place: before the first one, the first one, between it and the second one, and so on.
    pub(super) fn number(&self, place: usize) -> u32 {
        let before = |place: usize| place.checked_sub(1).map_or(0, |place| self.numbers[place]);
        if place % 2 == 1 {
            return before(place / 2 + 1);
        }
        let after = if place / 2 < self.count { self.numbers[place / 2] } else { u32::MAX - 1 };
        before(place / 2).midpoint(after)
    }

    /// The number of the `agreeing` tables that also have a number at this place, out of `all` numbers; 0 without such a place.
    ///
    /// The distinct numbers read can be chosen in a binomial number of ways, and the next one can be any of these.
    pub(super) fn agreeing(&self, agreeing: u128, all: u128, place: usize) -> u128 {
        let count = self.count as u128;
        match place % 2 {
            _ if place >= Self::places(self.count) => 0,
            1 => agreeing / all,
            _ => agreeing / all * (all - count) / (count + 1),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn orders(read: &[u32], left: usize, agreeing: u128, all: u128, found: &mut Vec<(Vec<u32>, u128)>) {
        if left == 0 {
            return found.push((read.to_vec(), agreeing));
        }
        let mut order = Order::default();
        for number in read {
            order.add(*number);
        }
        for place in 0..Order::places(read.len()) {
            let agreeing = order.agreeing(agreeing, all, place);
            if agreeing > 0 {
                orders(&[read, &[order.number(place)]].concat(), left - 1, agreeing, all, found);
            }
        }
    }

    #[test]
    fn each_order_is_there_once_and_all_numbers_are_counted() {
        // Weak orders of n numbers: A000670.
        for (length, weak_orders) in [(0, 1), (1, 1), (2, 3), (3, 13), (4, 75), (5, 541)] {
            let all = length as u128 + 1;
            let mut found = Vec::new();
            orders(&[], length, all.pow(length as u32), all, &mut found);
            assert_eq!(found.len(), weak_orders);
            assert_eq!(found.iter().map(|(_, agreeing)| agreeing).sum::<u128>(), all.pow(length as u32));
            let ranks = |numbers: &[u32]| -> Vec<usize> {
                numbers.iter().map(|n| numbers.iter().filter(|other| *other < n).count()).collect()
            };
            let mut orders: Vec<_> = found.iter().map(|(numbers, _)| ranks(numbers)).collect();
            orders.sort();
            orders.dedup();
            assert_eq!(orders.len(), weak_orders);
        }
    }

    #[test]
    fn as_many_numbers_as_there_are_slots_have_room_in_any_order() {
        for place in [0, 1] {
            let mut order = Order::default();
            for count in 0..=MOST_SLOTS {
                order.add(order.number(place * Order::places(order.count).saturating_sub(1)));
                assert_eq!(order.count, count + 1);
            }
        }
    }
}
