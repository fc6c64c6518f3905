//! Well-known families of structures, each validated as its owner would do it, without hiding faults: each stored link of a
//! small valid structure is set to every other value, and the verdict is compared with an independent one.

mod ccb;
mod corner_table;
mod keyed_mesh;
mod quad_edge;
mod surface_mesh;
mod winged_edge;

use crate::support::erased::{broken_rules, first_broken_rule, validate};
use crate::support::tables::{TETRAHEDRON, textbook_mesh};

use twinedge::validate::{Collect, Expectation, HalfEdgeRow, Link, Report, Table, View};

/// A stored link, and the number of records that it can lead to.
type Stored<'a> = (&'a mut Link, usize);

/// The number of changes of one stored link, and the number of changes that both verdicts accept.
#[derive(Debug, PartialEq, Eq)]
struct Changes {
    all: usize,
    accepted: usize,
}

/// Sets each link of a valid structure to every other value (nil, each record, the one past the end, `usize::MAX`), and
/// compares the verdict with an independent one.
#[track_caller]
fn each_change<S: Clone>(
    sound: &S,
    links: impl Fn(&mut S) -> Vec<Stored<'_>>,
    verdict: impl Fn(&S) -> Report,
    independent: impl Fn(&S) -> bool,
) -> Changes {
    let report = verdict(sound);
    assert!(report.is_valid(), "{report}");
    assert!(independent(sound));
    let mut changed = sound.clone();
    let mut changes = Changes { all: 0, accepted: 0 };
    for i in 0..links(&mut changed).len() {
        let (before, slots) = {
            let links = links(&mut changed);
            (*links[i].0, links[i].1)
        };
        for value in [None, Some(usize::MAX)].into_iter().chain((0..=slots).map(Some)).filter(|value| *value != before)
        {
            *links(&mut changed)[i].0 = value;
            let (report, accepted) = (verdict(&changed), independent(&changed));
            assert_eq!(report.is_valid(), accepted, "link {i} was {before:?} and is {value:?}\n{report}");
            changes.all += 1;
            changes.accepted += usize::from(accepted);
        }
        *links(&mut changed)[i].0 = before;
    }
    changes
}

/// Returns the common verdict of both validators.
#[track_caller]
fn judged(view: &impl View, expectation: Expectation) -> Report {
    let report = validate(view, &expectation, Collect::All);
    assert_eq!(report.broken_rules().next(), first_broken_rule(view, &expectation), "{report}");
    report
}

/// The verdict of the reference on a table.
fn holds(table: &Table, expectation: Expectation) -> bool {
    broken_rules(table, &expectation).is_empty()
}

/// The mirror image of a half-edge that stores its target: seen from the other side it starts there, and `next` and `prev`
/// are exchanged. No link is derived. A structure is valid if and only if its mirror image is.
fn mirrored(target: Link, [twin, next, prev]: [Link; 3]) -> HalfEdgeRow {
    HalfEdgeRow { origin: target, twin, next: prev, prev: next, ..HalfEdgeRow::default() }
}

/// The twin of a stored half-edge, if twins have neighbouring numbers. Dangling links are unchanged.
fn other_side(half_edge: Link, half_edges: usize) -> Link {
    half_edge.map(|h| if h < half_edges { h ^ 1 } else { h })
}

/// A tetrahedron without one face: its vertices, and for each half-edge origin, next and face. Twins have neighbouring
/// numbers, and border half-edges have no face.
fn open_tetrahedron() -> Table {
    let mut table = textbook_mesh(4, &TETRAHEDRON);
    for row in table.half_edges.iter_mut().flatten().filter(|row| row.face == Some(3)) {
        row.face = None;
    }
    table.faces.pop();
    table
}
