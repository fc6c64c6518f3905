//! A map that is not plane: the builder makes it, and every refusal names the place and a remedy.

use twinedge_algorithm::lattice;
use twinedge_algorithm::overlay::overlay;
use twinedge_coverage::{Limits, check, layers};
use twinedge_geometry::noding::Snap;
use twinedge_map::{Builder, PlanarMap, QueryLine};

fn built(segments: &[[[f64; 2]; 2]]) -> PlanarMap {
    let mut builder = Builder::new();
    for [from, to] in segments {
        builder.segment(*from, *to).unwrap();
    }
    builder.build().unwrap()
}

#[test]
fn a_refusal_says_where_edges_meet_and_what_cuts_them() {
    for (segments, at) in [
        ([[[0.0, 0.0], [2.0, 2.0]], [[0.0, 2.0], [2.0, 0.0]]], "(1, 1)"),
        ([[[0.0, 0.0], [4.0, 0.0]], [[3.0, 0.0], [3.0, 2.0]]], "(3, 0)"),
        ([[[0.0, 0.0], [4.0, 0.0]], [[4.0, 0.0], [2.0, 0.0]]], "(4, 0)"),
    ] {
        let mut map = built(&segments);
        let mut refusals = vec![
            map.zone(&QueryLine::Line([0.0, 0.0].into(), [5.0, 5.0].into())).unwrap_err().to_string(),
            map.locate([5.0, 5.0].into()).unwrap_err().to_string(),
            lattice::of_map(&map).unwrap_err().to_string(),
            check(&map, &Limits::default()).unwrap_err().to_string(),
            layers::check(&map, 1, &[]).unwrap_err().to_string(),
            layers::check_parents(&map, &[], &[]).unwrap_err().to_string(),
            overlay(&map, &PlanarMap::new(), Snap::Auto).unwrap_err().to_string(),
        ];
        refusals.push(map.insert_point([5.0, 5.0]).unwrap_err().to_string());
        for said in refusals {
            assert!(said.contains(&format!("as at {at}; `Builder::build_with(Noding::Snap(")), "{said}");
        }
    }
}

#[test]
fn the_place_of_a_crossing_is_near_both_edges_however_large_they_are() {
    for scale in [1e-60, 1.0, 1e100] {
        let [a, b] = [[-3.0, -1.0], [9.0, 3.0]].map(|p: [f64; 2]| p.map(|x| x * scale));
        let [c, d] = [[1.0, 5.0], [2.0, -4.0]].map(|p: [f64; 2]| p.map(|x| x * scale));
        let at = built(&[[a, b], [c, d]]).not_plane().unwrap().at.unwrap();
        assert!(at.x >= scale && at.x <= 2.0 * scale && at.y >= 0.0 && at.y <= scale, "{at:?}");
    }
    assert_eq!(built(&[[[0.0, 0.0], [1.0, 0.0]]]).not_plane(), None);
}
