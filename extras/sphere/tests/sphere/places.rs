//! Places: equal vectors for the same place, and the distance from the true place.

use crate::support::{Numbers, at};
use twinedge_geometry::predicates::Orientation;
use twinedge_sphere::predicates::side;
use twinedge_sphere::{Place, PlaceError};

#[test]
fn places_that_are_the_same_have_one_vector() {
    for latitude in [-89.9, -51.3, -45.0, 0.0, 1e-9, 45.0, 60.1] {
        assert_eq!(at(180.0, latitude), at(-180.0, latitude));
        assert_eq!(at(-180.0, latitude).vector()[1].to_bits(), 0);
        for longitude in [0.0, 0.1, 44.9, 45.0, 90.0, 135.0, 170.5] {
            let place = at(longitude, latitude);
            let [x, y, z] = place.vector();
            // Other differences of doubles are rounded.
            if longitude * 8.0 % 1.0 == 0.0 {
                assert_eq!(place, at(longitude - 360.0, latitude), "{longitude}");
                assert_eq!(place.antipode(), at(longitude - 180.0, -latitude), "{longitude}");
                assert_eq!(at(longitude + 90.0, latitude).vector(), [0.0 - y, x, z], "{longitude}");
            }
            assert_eq!(at(-longitude, latitude).vector(), [x, 0.0 - y, z], "{longitude}");
            assert_eq!(at(longitude, -latitude).vector(), [x, y, 0.0 - z], "{longitude}");
            assert!(x.abs().max(y.abs()) == 1.0);
        }
    }
    assert_eq!((at(17.0, 90.0), at(-99.0, -90.0)), (Place::NORTH, Place::SOUTH));
    assert_eq!(at(17.0, 90.000_000_5), Place::NORTH);
    assert!(Place::SOUTH.is_pole() && !at(0.0, 89.999_999_999_999_99).is_pole());
}

#[test]
fn what_is_no_place_is_refused() {
    assert_eq!(Place::new(f64::NAN, 0.0), Err(PlaceError::NotFinite));
    assert_eq!(Place::new(0.0, f64::INFINITY), Err(PlaceError::NotFinite));
    assert_eq!(Place::new(0.0, -90.1), Err(PlaceError::BeyondPole(-90.1)));
    assert_eq!(Place::toward([f64::NAN, 1.0, 1.0]), None);
    assert_eq!(Place::toward([1.0, 1.0, f64::INFINITY]), None);
    assert_eq!(Place::toward([0.0, 1e-40, 0.0]), None);
}

#[test]
fn meridians_and_the_equator_are_great_circles() {
    let mut numbers = Numbers(1);
    for _ in 0..2_000 {
        let longitude = numbers.fraction() * 360.0 - 180.0;
        let mut latitude = || numbers.fraction() * 180.0 - 90.0;
        let (a, b, c) = (at(longitude, latitude()), at(longitude, latitude()), at(longitude, latitude()));
        for p in [c, Place::NORTH, Place::SOUTH, c.antipode()] {
            assert_eq!(side(a, b, p), Orientation::Collinear, "{longitude}");
        }
        let [a, b, c] = [(); 3].map(|()| at(numbers.fraction() * 360.0, 0.0));
        assert_eq!(side(a, b, c), Orientation::Collinear);
    }
}

/// The vectors of places, up to the rounding of a double, and the angle between computed and true vector as a distance.
///
/// Computed by mpmath 1.3 with 50 digits: `[tan λ, tan φ / cos λ]` of the doubles nearest to the longitude and the latitude in degrees.
#[test]
fn places_lie_within_nanometres_of_the_true_ones() {
    for (longitude, latitude, y, z) in GOLDEN {
        let [one, found_y, found_z] = at(longitude, latitude).vector();
        assert_eq!(one, 1.0);
        // The length of the cross product, by the differences.
        let (dy, dz) = (found_y - y, found_z - z);
        let (across, square) = ((y * dz - z * dy).hypot(dy).hypot(dz), 1.0 + y * y + z * z);
        let angle = across / square;
        assert!(angle < 4e-16, "{longitude} {latitude}: {angle}");
    }
}

const GOLDEN: [(f64, f64, f64, f64); 6] = [
    (0.1, 51.477_928, 0.001_745_331_024_188_800_4, 1.256_180_616_579_150_7),
    (-44.3, -33.85, -0.975_859_125_768_514_3, -0.937_142_589_414_476_3),
    (30.0, 60.0, 0.577_350_269_189_625_7, 2.0),
    (44.999_99, 89.999_999_9, 0.999_999_650_934_210_4, 810_284_591.225_194_6),
    (-12.345_678_901, 1e-7, -0.218_870_553_660_946_04, 1.786_644_648_261_882_4e-9),
    (7.2, -89.0, 0.126_329_378_446_108_17, -57.745_300_573_466_466),
];

#[test]
fn degrees_come_back() {
    let mut numbers = Numbers(2);
    for _ in 0..2_000 {
        let (longitude, latitude) = (numbers.fraction() * 360.0 - 180.0, numbers.fraction() * 180.0 - 90.0);
        let [x, y] = at(longitude, latitude).degrees();
        assert!((x - longitude).abs() < 1e-13 && (y - latitude).abs() < 1e-13, "{longitude} {latitude}");
    }
    assert_eq!(Place::NORTH.degrees(), [0.0, 90.0]);
    assert_eq!(at(180.0, -45.0).degrees(), [180.0, -45.0]);
}
