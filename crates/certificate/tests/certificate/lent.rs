//! Structures that lend their half-edges as columns are judged as those that answer, corrupt or not.

use crate::tables::{TETRAHEDRON, textbook_mesh, torus, with_boundary_components};
use twinedge::delegate_view;
use twinedge::validate::{HalfEdgeColumns, HalfEdgeRow, Link, Parts, Table, View};
use twinedge_certificate::{Labels, check, check_surface, passes, passes_surface};
use twinedge_trials::census::{Census, Scope};
use twinedge_trials::enumerate::for_each_corruption;

/// A table whose half-edges are also columns.
struct Lending<'a> {
    table: &'a Table,
    columns: [Vec<u32>; 6],
}

impl<'a> Lending<'a> {
    /// Returns `None` if it may not lend them, as the twin of a half-edge is not the other half-edge of a pair.
    fn new(table: &'a Table) -> Option<Self> {
        let number = |link: Link| link.map_or(u32::MAX, |to| u32::try_from(to).unwrap_or(u32::MAX));
        let column = |link: fn(HalfEdgeRow) -> Link| -> Vec<u32> {
            table.half_edges.iter().map(|row| number(row.and_then(link))).collect()
        };
        let mut twins = table.half_edges.iter().enumerate();
        let are_paired = twins.all(|(h, row)| row.is_none_or(|row| row.twin == Some(h ^ 1)));
        let live = table.half_edges.chunks(2).map(|edge| u32::from(edge[0].is_some())).collect();
        let is_whole = table.half_edges.chunks(2).all(|edge| edge.len() == 2 && edge[0].is_some() == edge[1].is_some());
        let columns = [
            column(|row| row.origin),
            column(|row| row.next),
            column(|row| row.prev),
            column(|row| row.boundary),
            column(|row| row.face),
            live,
        ];
        (are_paired && is_whole).then_some(Self { table, columns })
    }
}

impl View for Lending<'_> {
    delegate_view!(|this| this.table);

    fn half_edge_columns(&self) -> Option<HalfEdgeColumns<'_>> {
        let [origin, next, prev, boundary, face, live_edges] = &self.columns;
        Some(HalfEdgeColumns { origin, next, prev, boundary, face, live_edges: Some(live_edges) })
    }
}

#[test]
fn half_edges_in_columns_are_judged_as_answers_are() {
    let (mut right, mut wrong) = (0, 0);
    for map in Census::new(Scope::Subdivisions { edges: 2, vertices: 3 }) {
        let mut table = Table::copy_of(map.runner.subject()).unwrap();
        let labels = Labels::new(&table).unwrap();
        assert_eq!(check(&Lending::new(&table).unwrap(), &labels), Ok(()), "{table}");
        for_each_corruption(&mut table, Parts::ALL, |corrupt, cell, value| {
            let Some(lending) = Lending::new(corrupt) else { return };
            let answered = check(corrupt, &labels);
            assert_eq!(passes(&lending, &labels), answered.is_ok(), "{cell:?} = {value:?}: {corrupt}");
            assert_eq!(check(&lending, &labels), answered, "{cell:?} = {value:?}: {corrupt}");
            *if answered.is_ok() { &mut right } else { &mut wrong } += 1;
        });
    }
    assert!(wrong > 1000, "{right} {wrong}");
    let [mesh, torus] = [textbook_mesh(4, &TETRAHEDRON), textbook_mesh(9, &torus([3, 3]))];
    for mut table in [with_boundary_components(&mesh), with_boundary_components(&torus), mesh, torus] {
        let (labels, genus) = Labels::of_surface(&table).unwrap();
        assert_eq!(check_surface(&Lending::new(&table).unwrap(), &labels, genus), Ok(()), "{table}");
        let parts = table.parts;
        for_each_corruption(&mut table, parts, |corrupt, cell, value| {
            let Some(lending) = Lending::new(corrupt) else { return };
            let answered = check_surface(corrupt, &labels, genus);
            assert_eq!(passes_surface(&lending, &labels, genus), answered.is_ok(), "{cell:?} = {value:?}: {corrupt}");
            assert_eq!(check_surface(&lending, &labels, genus), answered, "{cell:?} = {value:?}: {corrupt}");
            *if answered.is_ok() { &mut right } else { &mut wrong } += 1;
        });
    }
    assert!(right > 0, "{right} {wrong}");
}
