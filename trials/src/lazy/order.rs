//! Numbers that are only compared with each other: those in the same order are equivalent.

use super::work::MOST_SLOTS;

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
