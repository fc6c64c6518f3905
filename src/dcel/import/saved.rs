//! The serde form of structures.

use super::error::{ImportError, Outside};
use super::from_view::import;
use super::gather::Numbers;
use crate::dcel::structure::Dcel;
use crate::numbers::NIL;
use crate::store::{Generations, Live, Store};
use crate::validate::{
    BoundaryPlace, BoundaryRow, Expectation, FaceRow, HalfEdgeRow, Part, Parts, Start, Table, VertexRow,
};
use alloc::vec;
use alloc::vec::Vec;
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// The version of the saved form.
const FORM: u8 = 1;

/// The saved form of a structure: the generations of all slots, and the links (as slots) of the live records in order of
/// their slots.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Saved {
    form: u8,
    generations: Generations,
    /// By vertex; `None` if isolated.
    leaving: Vec<Option<u32>>,
    /// By half-edge.
    origin: Vec<u32>,
    next: Vec<u32>,
    boundary: Vec<u32>,
    /// By boundary component.
    start: Vec<SavedStart>,
    /// By face.
    outer: Vec<Option<u32>>,
    inner: Vec<Vec<u32>>,
}

#[derive(Clone, Copy, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
enum SavedStart {
    HalfEdge(u32),
    Vertex(u32),
}

/// Keys survive: data saved alongside by key, for example in a [`SecondaryMap`](crate::dcel::SecondaryMap), still refers to
/// the same records, and stale keys stay stale.
///
/// ```
/// use twinedge::dcel::{Dcel, SecondaryMap};
///
/// let mut map = Dcel::new();
/// let outside = map.unbounded_face().key();
/// let mut names = SecondaryMap::new();
/// names.insert(map.add_isolated_vertex(outside)?.vertex, "Tristan da Cunha");
/// let gone = map.add_isolated_vertex(outside)?.vertex;
/// map.remove_isolated_vertex(gone)?;
///
/// let text = serde_json::to_string(&(&map, &names, gone))?;
/// let (map, names, gone): (Dcel, SecondaryMap<_, String>, _) = serde_json::from_str(&text)?;
/// let vertex = map.vertices().next().unwrap();
/// assert_eq!(names[vertex.key()], "Tristan da Cunha");
/// assert!(map.vertex(gone).is_err());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
impl Serialize for Dcel {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let saved = Saved {
            form: FORM,
            generations: self.store.generations(),
            leaving: self.vertices().map(|v| v.leaving().map(|h| h.index() as u32)).collect(),
            origin: self.half_edges().map(|h| h.origin().index() as u32).collect(),
            next: self.half_edges().map(|h| h.next().index() as u32).collect(),
            boundary: self.half_edges().map(|h| h.boundary().index() as u32).collect(),
            start: self
                .boundaries()
                .filter_map(|b| {
                    let of_cycle = b.start().map(|h| SavedStart::HalfEdge(h.index() as u32));
                    of_cycle.or_else(|| b.isolated_vertex().map(|v| SavedStart::Vertex(v.index() as u32)))
                })
                .collect(),
            outer: self.faces().map(|f| f.outer().map(|b| b.index() as u32)).collect(),
            inner: self.faces().map(|f| f.inner().map(|b| b.index() as u32).collect()).collect(),
        };
        saved.serialize(serializer)
    }
}

/// Validates as [`Dcel::from_view`] does: a structure that is not a planar subdivision is an error containing the report.
impl<'de> Deserialize<'de> for Dcel {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let saved = Saved::deserialize(deserializer)?;
        if saved.form != FORM {
            return Err(D::Error::custom(format_args!("form {} of a structure is not known", saved.form)));
        }
        let table = saved.table().ok_or_else(|| D::Error::custom("a column is too short or too long"))?;
        let Saved { generations, .. } = saved;
        let restore = |columns: &super::gather::Columns, numbers: &Numbers| {
            let (store, slots) = Store::restored(generations, &live(numbers)).ok_or(ImportError::Inconsistent)?;
            Ok(columns.assembly().link(store, &slots))
        };
        let (dcel, _) = import(&table, Expectation::plane(), Outside::Given, restore).map_err(D::Error::custom)?;
        Ok(dcel)
    }
}

fn live(numbers: &Numbers) -> Live {
    fn slots(numbers: &[u32]) -> Vec<u32> {
        let count = numbers.iter().filter(|n| **n != NIL).count();
        let mut slots = vec![0; count];
        for (slot, n) in numbers.iter().enumerate().filter(|(_, n)| **n != NIL) {
            slots[*n as usize] = slot as u32;
        }
        slots
    }
    Live {
        vertices: slots(&numbers.vertices),
        half_edges: slots(&numbers.half_edges),
        boundaries: slots(&numbers.boundaries),
        faces: slots(&numbers.faces),
    }
}

/// Returns a row for each slot, empty for vacant slots; `None` unless there is one row per live slot.
fn rows<R>(generations: &[u32], rows: impl IntoIterator<Item = R>) -> Option<Vec<Option<R>>> {
    let mut rows = rows.into_iter();
    let mut table = Vec::with_capacity(generations.len());
    for generation in generations {
        table.push(if generation % 2 == 1 { Some(rows.next()?) } else { None });
    }
    rows.next().is_none().then_some(table)
}

impl Saved {
    /// Builds the table of the columns, valid or not; `None` if the lengths of the columns do not match.
    fn table(&self) -> Option<Table> {
        let Generations { vertices, edges, boundaries, faces, .. } = &self.generations;
        let half_edges: Vec<u32> = edges.iter().flat_map(|generation| [*generation; 2]).collect();
        let link = |slot: u32| Some(slot as usize);
        let live = half_edges.iter().filter(|generation| **generation % 2 == 1).count();
        if [self.origin.len(), self.next.len(), self.boundary.len()] != [live; 3] {
            return None;
        }
        let columns = self.origin.iter().zip(&self.next).zip(&self.boundary);
        let mut table = Table {
            parts: Parts::ALL.without(Part::Prev),
            vertices: rows(
                vertices,
                self.leaving.iter().map(|h| VertexRow { leaving: h.map(|h| h as usize), isolated: None }),
            )?,
            half_edges: rows(
                &half_edges,
                columns.map(|((origin, next), boundary)| HalfEdgeRow {
                    origin: link(*origin),
                    next: link(*next),
                    boundary: link(*boundary),
                    ..HalfEdgeRow::default()
                }),
            )?,
            boundaries: rows(
                boundaries,
                self.start.iter().map(|start| BoundaryRow {
                    start: Some(match *start {
                        SavedStart::HalfEdge(h) => Start::HalfEdge(h as usize),
                        SavedStart::Vertex(v) => Start::Vertex(v as usize),
                    }),
                    ..BoundaryRow::default()
                }),
            )?,
            faces: rows(
                faces,
                self.outer.iter().map(|b| FaceRow { outer: b.map(|b| b as usize), ..FaceRow::default() }),
            )?,
        };
        for (h, row) in table.half_edges.iter_mut().enumerate() {
            if let Some(row) = row {
                row.twin = Some(h ^ 1);
            }
        }
        self.lists(&mut table)?;
        for b in 0..table.boundaries.len() {
            let Some(Some(Start::Vertex(v))) = table.boundaries[b].map(|row| row.start) else { continue };
            if let Some(Some(row)) = table.vertices.get_mut(v) {
                row.isolated = row.isolated.or(Some(b));
            }
        }
        Some(table)
    }

    /// Fills in the lists of the faces, and the face of each boundary component where it is first listed.
    fn lists(&self, table: &mut Table) -> Option<()> {
        let mut inner = self.inner.iter();
        for (f, row) in table.faces.iter_mut().enumerate() {
            let Some(row) = row else { continue };
            row.inner = inner.next()?.iter().map(|b| Some(*b as usize)).collect();
            let outer = row.outer.map(|b| (b, BoundaryPlace::Outer)).into_iter();
            let listed = row.inner.iter().flatten().enumerate().map(|(i, b)| (*b, BoundaryPlace::Inner(i)));
            for (b, place) in outer.chain(listed) {
                if let Some(Some(boundary)) = table.boundaries.get_mut(b) {
                    boundary.face = boundary.face.or(Some(f));
                    boundary.place = boundary.place.or(Some(place));
                }
            }
        }
        inner.next().is_none().then_some(())
    }
}
