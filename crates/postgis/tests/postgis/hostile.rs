//! Malicious streams: every prefix and many changes of valid streams lead to a topology or to a typed error with its place.

use crate::support::{DECIMAL, EDGE, GEOM, LARGE_IDS, Rows, START, TOWN};
use quickcheck::{Gen, QuickCheck};
use std::io::BufReader;
use twinedge_postgis::{Cause, ReadError, TableName, audit, read};

/// Reads and audits the input; returns true if it is a topology.
fn survives(bytes: &[u8]) -> bool {
    match read(bytes, 10) {
        Ok(topology) => {
            let audit = audit(&topology, 10).expect("there is memory");
            assert!(!audit.to_string().is_empty());
            true
        }
        Err(ReadError::Content { byte, cause, .. }) => {
            assert!(byte <= bytes.len() as u64, "{cause} at byte {byte} of {}", bytes.len());
            assert!(!cause.to_string().is_empty());
            false
        }
        Err(error) => panic!("{error}"),
    }
}

fn error(bytes: &[u8]) -> (u64, String, Cause) {
    match read(bytes, 10) {
        Err(ReadError::Content { byte, place, cause }) => (byte, place.to_string(), cause),
        other => panic!("{other:?}"),
    }
}

#[test]
fn every_prefix_ends_early() {
    for bytes in [TOWN, DECIMAL, LARGE_IDS] {
        assert!(survives(bytes));
        for length in 0..bytes.len() {
            let (byte, _, cause) = error(&bytes[..length]);
            let expected = if length == 0 { Cause::Empty } else { Cause::Truncated };
            assert_eq!(cause, expected, "{length}");
            assert!(byte <= length as u64);
        }
    }
}

#[test]
fn changed_bytes() {
    fn survive(changes: Vec<(usize, u8)>) {
        for bytes in [TOWN, DECIMAL, LARGE_IDS] {
            let mut bytes = bytes.to_vec();
            for (at, byte) in &changes {
                let at = at % bytes.len();
                bytes[at] = *byte;
            }
            survives(&bytes);
        }
    }
    QuickCheck::new().tests(3000).rng(Gen::new(6)).quickcheck(survive as fn(Vec<(usize, u8)>));
}

/// Links and coordinates with any values, in well-formed streams.
#[test]
fn changed_values() {
    fn survive(changes: Vec<(u8, u8, u8, i32)>) {
        let mut rows = Rows::of(TOWN);
        for (table, row, column, value) in changes {
            let table = &mut rows.0[usize::from(table) % 3];
            let row = usize::from(row) % table.len();
            let row = &mut table[row];
            let column = usize::from(column) % row.len();
            if column + 1 == row.len() {
                let Some(geometry) = &mut row[column] else { continue };
                let at = 13 + value.unsigned_abs() as usize % (geometry.len() - 16);
                geometry[at..at + 3].copy_from_slice(&value.to_le_bytes()[..3]);
            } else {
                row[column] = if value % 5 == 0 { None } else { Some((value % 20).to_be_bytes().to_vec()) };
            }
        }
        assert!(survives(&rows.bytes()));
    }
    QuickCheck::new().tests(3000).rng(Gen::new(4)).quickcheck(survive as fn(Vec<(u8, u8, u8, i32)>));
}

#[test]
fn any_bytes() {
    fn survive(bytes: Vec<u8>, begins: bool) {
        let head: &[u8] = if begins { &TOWN[..19] } else { &[] };
        survives(&[head, &bytes].concat());
    }
    QuickCheck::new().tests(3000).rng(Gen::new(300)).quickcheck(survive as fn(Vec<u8>, bool));
}

/// A pipe returns any number of bytes at a time.
#[test]
fn streams_may_come_in_small_pieces() {
    let whole = audit(&read(TOWN, 100).unwrap(), 100).unwrap();
    for capacity in [1, 2, 7, 100] {
        let pieces = read(BufReader::with_capacity(capacity, TOWN), 100).unwrap();
        assert_eq!(audit(&pieces, 100).unwrap(), whole);
    }
}

#[test]
fn errors_say_where_and_what() {
    let (byte, place, cause) = error(b"BEGIN\nPGCOPY\n\xff\r\n\0");
    assert_eq!((byte, place.as_str()), (0, "table node"));
    assert!(matches!(&cause, Cause::Signature { found } if found.starts_with("BEGIN\\nPGCOPY")), "{cause}");

    let mut bytes = TOWN.to_vec();
    bytes[12] = 1;
    assert_eq!(error(&bytes).2, Cause::Flags(0x0001_0000));

    let changed = |table: usize, row: usize, column: usize, value: &[u8]| {
        let mut rows = Rows::of(TOWN);
        rows.0[table][row][column] = Some(value.to_vec());
        error(&rows.bytes())
    };
    let (byte, place, cause) = changed(EDGE, 4, START, &[0; 3]);
    assert_eq!((place.as_str(), cause), ("table edge_data, row 5, column start_node", Cause::Width(3)));
    let mut rows = Rows::of(TOWN);
    rows.0[EDGE].truncate(4);
    // The number of columns follows, an integer with its length, and the length of the next.
    assert_eq!(byte, rows.bytes().len() as u64 - 2 + 2 + 8 + 4);
    assert_eq!(changed(EDGE, 0, GEOM, &[2, 2, 0, 0, 0]).2, Cause::ByteOrder(2));
    assert_eq!(changed(EDGE, 0, GEOM, &[]).2, Cause::GeometryTruncated);
    assert_eq!(changed(EDGE, 0, GEOM, &[1, 2, 0, 0, 0, 255, 255, 255, 255]).2, Cause::GeometryTruncated);
    assert_eq!(changed(EDGE, 0, GEOM, &[1, 2, 0, 0, 0, 0, 0, 0, 0, 9]).2, Cause::GeometryTrailing(1));
    let (_, place, cause) = changed(1, 2, 1, &[1, 3, 0, 0, 0, 255, 255, 255, 255]);
    assert_eq!((place.as_str(), cause), ("table face, row 3, column mbr", Cause::GeometryTruncated));

    let mut rows = Rows::of(TOWN);
    rows.0[0][1].pop();
    let (_, place, cause) = error(&rows.bytes());
    assert_eq!((place.as_str(), cause), ("table node, row 2", Cause::Columns { found: 2, expected: 3 }));

    let mut bytes = TOWN.to_vec();
    bytes[21..25].copy_from_slice(&(-7_i32).to_be_bytes());
    assert_eq!(error(&bytes).2, Cause::Length(-7));

    let trailing = [TOWN, b"COMMIT\n"].concat();
    assert_eq!(error(&trailing).2, Cause::Trailing);
    assert_eq!(TableName::EdgeData.to_string(), "edge_data");
}
