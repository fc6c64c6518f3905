//! Converts streams to rows and back: a second, minimal reader of the format.
#![allow(clippy::unnecessary_wraps, reason = "a value of a row may be null")]

use twinedge_postgis::{Topology, TopologyAudit, audit, read};

/// The map `town` of `tests/postgis/maps.sql`, written by `PostgreSQL` 15 with PostGIS 3.3.2.
pub(crate) const TOWN: &[u8] = include_bytes!("data/town.copy");
/// The other maps of that file.
pub(crate) const DECIMAL: &[u8] = include_bytes!("data/decimal.copy");
pub(crate) const LARGE_IDS: &[u8] = include_bytes!("data/large_ids.copy");
pub(crate) const OLD_TOWN: &[u8] = include_bytes!("data/old_town.copy");

/// A row: the bytes of each value, or null.
pub(crate) type Row = Vec<Option<Vec<u8>>>;

/// A named change of the rows.
pub(crate) type Change = (&'static str, fn(&mut Rows));

#[derive(Clone)]
pub(crate) struct Rows(pub(crate) [Vec<Row>; 3]);

pub(crate) const NODE: usize = 0;
pub(crate) const FACE: usize = 1;
pub(crate) const EDGE: usize = 2;

/// The columns of edges.
pub(crate) const START: usize = 1;
pub(crate) const END: usize = 2;
pub(crate) const NEXT_LEFT: usize = 3;
pub(crate) const ABS_NEXT_LEFT: usize = 4;
pub(crate) const LEFT_FACE: usize = 7;
pub(crate) const GEOM: usize = 9;

impl Rows {
    /// Parses a valid stream.
    pub(crate) fn of(bytes: &[u8]) -> Self {
        let mut at = 0;
        let mut take = |count: usize| {
            at += count;
            &bytes[at - count..at]
        };
        Self([(); 3].map(|()| {
            let mut rows = Vec::new();
            take(19);
            loop {
                let columns = i16::from_be_bytes(take(2).try_into().unwrap());
                if columns == -1 {
                    return rows;
                }
                let value = |_| {
                    let length = i32::from_be_bytes(take(4).try_into().unwrap());
                    usize::try_from(length).ok().map(|length| take(length).to_vec())
                };
                rows.push((0..columns).map(value).collect());
            }
        }))
    }

    pub(crate) fn bytes(&self) -> Vec<u8> {
        let mut out = Vec::new();
        for rows in &self.0 {
            out.extend(b"PGCOPY\n\xff\r\n\0\0\0\0\0\0\0\0\0");
            for row in rows {
                out.extend((row.len() as u16).to_be_bytes());
                for value in row {
                    out.extend(value.as_ref().map_or(u32::MAX, |value| value.len() as u32).to_be_bytes());
                    out.extend(value.iter().flatten());
                }
            }
            out.extend((-1_i16).to_be_bytes());
        }
        out
    }

    pub(crate) fn read(&self) -> Topology {
        read(&*self.bytes(), 100).expect("the streams are well-formed")
    }

    pub(crate) fn audit(&self) -> TopologyAudit {
        audit(&self.read(), 100).expect("there is memory")
    }

    pub(crate) fn row(&mut self, table: usize, id: i32) -> &mut Row {
        let found = self.0[table].iter_mut().find(|row| row[0] == int(id));
        found.expect("there is such a row")
    }
}

pub(crate) fn int(value: i32) -> Option<Vec<u8>> {
    Some(value.to_be_bytes().to_vec())
}

pub(crate) fn point(x: f64, y: f64) -> Option<Vec<u8>> {
    Some([&[1, 1, 0, 0, 0], &x.to_le_bytes()[..], &y.to_le_bytes()].concat())
}

pub(crate) fn line(points: &[[f64; 2]]) -> Option<Vec<u8>> {
    let coordinates = points.iter().flatten().flat_map(|x| x.to_le_bytes());
    Some([1, 2, 0, 0, 0].into_iter().chain((points.len() as u32).to_le_bytes()).chain(coordinates).collect())
}

/// The outer ring of a polygon.
pub(crate) fn polygon(points: &[[f64; 2]]) -> Option<Vec<u8>> {
    let ring = line(points)?;
    Some([&[1, 3, 0, 0, 0, 1, 0, 0, 0], &ring[5..]].concat())
}
