//! Reports with the owner's names, and indices of the owner's ids.

use super::adapters::maps;
use crate::support::erased::validate;
use crate::support::nested::{PLANE, nested, nested_textbook};
use crate::support::tables::Without;
use std::collections::BTreeSet;
use twinedge::validate::adapt::{Ids, Index};
use twinedge::validate::{Collect, Part, Parts, Record, Table, Violation};
use twinedge_trials::enumerate::for_each_corruption;

#[test]
fn an_index_numbers_ids_in_their_order() {
    let index = Index::of(["c", "a", "b", "a"]);
    assert_eq!((index.len(), index.is_empty(), Index::<u8>::default().is_empty()), (4, false, true));
    assert_eq!(["a", "b", "c", "d", ""].map(|id| index.get(&id)), [Some(1), Some(2), Some(0), None, None]);
    assert_eq!([0, 1, 2, 3, 4].map(|i| index.id(i).copied()), [Some("c"), Some("a"), Some("b"), Some("a"), None]);
    assert_eq!([None, Some("b"), Some("z")].map(|id| index.link(id)), [None, Some(2), Some(usize::MAX)]);
    assert_eq!(index.follow(0, &index, |id| (*id == "c").then_some("b")), Some(2));
    assert_eq!(index.follow(1, &index, |id| (*id == "c").then_some("b")), None);
    assert_eq!(index.follow(9, &index, |_| Some("b")), None);
    assert_eq!((index.name(2), index.name(7)), ("\"b\"".to_owned(), "7".to_owned()));
}

#[test]
fn an_index_that_is_extended_keeps_its_numbers() {
    let mut index = Index::of(["c", "a", "a"]);
    index.extend(["b", "a", "d", "B", "b", "d"]);
    assert_eq!((0..index.len()).map(|i| *index.id(i).unwrap()).collect::<Vec<_>>(), ["c", "a", "a", "b", "d", "B"]);
    assert_eq!(["a", "b", "c", "d", "B"].map(|id| index.get(&id)), [Some(1), Some(3), Some(0), Some(4), Some(5)]);
    index.extend([]);
    index.extend(["c"]);
    assert_eq!(index.len(), 6);
    let ids = Ids { vertices: Index::of([1.5_f64.to_bits()]), half_edges: index, faces: Index::of(['f']) };
    let names = [Record::Vertex(3), Record::HalfEdge(4), Record::Face(0), Record::Boundary(8)].map(|r| ids.name(r));
    assert_eq!(names, ["3", "\"d\"", "'f'", "8"]);
}

/// With indices as names, a report reads as without names; and every record in a violation is named.
#[test]
fn every_record_in_a_report_is_named() {
    let mut seen = BTreeSet::new();
    let tables = [(nested_textbook(), PLANE), (nested(), PLANE)];
    for (table, expectation) in tables.into_iter().chain(maps()) {
        let (without_prev, parts) = (table.without(Part::Prev), Parts::ALL.without(Part::UnboundedFace));
        let by_record = Table { parts, ..table.clone() };
        for (mut table, expectation) in [(table, expectation), (without_prev, expectation), (by_record, PLANE)] {
            let parts = table.parts;
            for_each_corruption(&mut table, parts, |changed, _, _| {
                let report = validate(changed, &expectation, Collect::All);
                assert_eq!(report.named(|record| record.index()).to_string(), report.to_string());
                assert_eq!(format!("{:?}", report.named(|record| record.index())), report.to_string());
                for violation in report.violations() {
                    seen.insert(violation.kind());
                    let text =
                        violation.named(|record| format!("<{}>", record.to_string().replace(' ', "_"))).to_string();
                    for record in violation.records().into_iter().flatten() {
                        let name = format!("<{}>", record.to_string().replace(' ', "_"));
                        assert!(text.contains(&name), "{violation:?}: {text} lacks {name}");
                    }
                }
            });
        }
    }
    assert!(seen.len() > 25, "{seen:?}");
    // Violations about coordinates, and others that no single corruption produces.
    let named = |violation: Violation| violation.named(|record| format!("<{record}>")).message();
    assert!(
        named(Violation::Cross { first: 1, second: 2 }).starts_with("half-edges <half-edge 1> and <half-edge 2> cross")
    );
    assert!(named(Violation::SamePlace { first: 1, second: 2 }).starts_with("vertices <vertex 1> and <vertex 2> lie"));
    let wrong = Violation::WrongFace { boundary: Record::Boundary(1), face: 2, found: Some(3) };
    assert_eq!(
        named(wrong),
        "the inner boundary component <boundary component 1> is listed by face <face 2>, but lies in face <face 3>"
    );
    let start = Violation::OuterClockwise { boundary: Record::HalfEdge(4) };
    assert!(named(start).starts_with("the outer boundary component at half-edge <half-edge 4> turns"));
    assert!(named(Violation::Unlisted { vertex: 1, face: 2 }).contains("<vertex 1> lies in face <face 2>"));
}
