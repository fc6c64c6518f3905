//! Tests of `parallel`.

use super::settle_in_parts;
use crate::validate::subject::{Extent, Subject};
use crate::validate::{Expectation, Part, Parts, Table};

/// True if a structure is settled in parts.
fn is_settled(table: &str, parts: Parts) -> bool {
    let table = Table { parts, ..table.parse().unwrap() };
    let extent = Extent::of(&table, Expectation::plane()).unwrap();
    settle_in_parts(Subject { view: &table, extent }).is_some()
}

#[test]
fn a_right_structure_is_settled_and_no_other() {
    const LOOP: &str = "V 1 0 - H 2 0 1 0 0 0 0 0 1 1 1 B 2 1 h0 o 0 h1 i0 F 2 - 1 1 0 0";
    assert!(is_settled(LOOP, Parts::ALL));
    assert!(is_settled(LOOP, Parts::ALL.without(Part::Prev)));
    assert!(!is_settled(LOOP, Parts::ALL.without(Part::Places)));
    assert!(!is_settled(&LOOP.replace("h1 i0", "h0 i0"), Parts::ALL));
}
