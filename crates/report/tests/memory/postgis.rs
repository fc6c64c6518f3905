//! The counts declared in a stream cost no memory.

use crate::peak;
use twinedge_postgis::read;

#[test]
fn claims_cost_nothing() {
    let header: &[u8] = b"PGCOPY\n\xff\r\n\0\0\0\0\0";
    let begun = [header, &[0; 4]].concat();
    let long: &[u8] = &[0x7f, 0xff, 0xff, 0xff];
    let node: &[u8] = &[0, 3, 0, 0, 0, 4, 0, 0, 0, 1, 0xff, 0xff, 0xff, 0xff];
    let empty_table: &[u8] = &[0xff, 0xff];
    for bytes in [
        // An extension of the header, a geometry, a line and a polygon with a count of 2³¹ bytes, points or rings.
        [header, &[0xff; 4]].concat(),
        [&begun, node, long, &[1, 1]].concat(),
        [&begun, node, &[0, 0, 0, 9], &[1, 2, 0, 0, 0, 0xff, 0xff, 0xff, 0x7f]].concat(),
        [&begun, empty_table, &begun, &[0, 2, 0, 0, 0, 4, 0, 0, 0, 1], &[0, 0, 0, 9], &[1, 3, 0, 0, 0], &[0xff; 4]]
            .concat(),
    ] {
        let used = peak(|| assert!(read(&*bytes, 100).is_err()));
        assert!(used < 20_000, "{used} bytes for a stream of {}", bytes.len());
    }
}
