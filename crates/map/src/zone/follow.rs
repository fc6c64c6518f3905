//! Following a line from one record to the next.

use super::ZoneElement;
use super::line::{EventRecord, Line, LineEvent, LinePiece, LinePlace};
use crate::locate::LocateError;
use crate::planar_map::PlanarMap;
use twinedge_geometry::Point;

/// The beginning of a zone: an event, or the inside of a piece, with its place unless it is infinitely far away.
#[derive(Clone, Copy)]
pub(super) enum ZoneStart<'m> {
    Event(LineEvent<'m>),
    Piece(LinePiece<'m>, Option<LinePlace>),
}

/// Visits the elements of a zone, up to a point if the zone has an end. `next` returns the event after a place in a piece.
pub(super) fn follow<'m>(
    map: &'m PlanarMap,
    line: &Line,
    to: Option<Point>,
    begin: ZoneStart<'m>,
    mut next: impl FnMut(LinePiece<'m>, Option<LinePlace>) -> Option<LineEvent<'m>>,
    mut visit: impl FnMut(ZoneElement),
) -> Result<(), LocateError> {
    let (mut event, mut piece, mut at) = match begin {
        ZoneStart::Event(event) => (Some(event), None, None),
        ZoneStart::Piece(piece, at) => (None, Some(piece), at),
    };
    // A line meets everything but faces at most once.
    let mut left = map.dcel().vertex_count() + map.dcel().edge_count();
    loop {
        if let Some(event) = event {
            visit(match event.record {
                EventRecord::Vertex(vertex) => ZoneElement::Vertex(vertex.key()),
                EventRecord::Edge(h) => ZoneElement::Edge(h.key()),
            });
            if to.is_some_and(|to| line.order(event.place, LinePlace::At(to)).is_ge()) {
                return Ok(());
            }
            left = left.checked_sub(1).ok_or(map.not_plane().unwrap_or_default())?;
            at = Some(event.place);
            piece = Some(line.after(map, event));
        }
        let Some(through) = piece else { return Ok(()) };
        visit(match through {
            LinePiece::Face(face) => ZoneElement::Face(face.key()),
            LinePiece::Along(h) => ZoneElement::Along(h.key()),
        });
        event = next(through, at);
        let fits = match (through, event.map(|event| event.record)) {
            (_, None) | (LinePiece::Face(_), Some(EventRecord::Vertex(_))) => true,
            (LinePiece::Face(face), Some(EventRecord::Edge(h))) => h.twin().face() == face,
            (LinePiece::Along(h), Some(EventRecord::Vertex(vertex))) => h.target() == vertex,
            (LinePiece::Along(_), Some(EventRecord::Edge(_))) => false,
        };
        if !fits {
            return Err(map.not_plane().unwrap_or_default().into());
        }
        if event.is_none() {
            return Ok(());
        }
    }
}
