//! Unsupported geometry types, by name and number.

/// By number in well-known binary, also used by `FlatGeobuf`.
const UNREAD: [(u32, &str); 8] = [
    (8, "CircularString"),
    (9, "CompoundCurve"),
    (10, "CurvePolygon"),
    (11, "MultiCurve"),
    (12, "MultiSurface"),
    (15, "PolyhedralSurface"),
    (16, "TIN"),
    (17, "Triangle"),
];

/// The greatest number of a type with curves.
const LAST_CURVE: u32 = 12;

/// Returns the reason why a geometry type is not supported, and a remedy, by its number in well-known binary or `FlatGeobuf`.
///
/// ```
/// use twinedge_layers::io::unread_geometry;
///
/// assert_eq!(
///     unread_geometry(10),
///     "CurvePolygon has curves, and only straight lines are read: `ogr2ogr -nlt CONVERT_TO_LINEAR map.gpkg FILE` makes lines of them"
/// );
/// ```
#[must_use]
pub fn unread_geometry(kind: u32) -> String {
    match UNREAD.iter().find(|(number, _)| *number == kind) {
        Some((number, name)) if *number <= LAST_CURVE => format!(
            "{name} has curves, and only straight lines are read: `ogr2ogr -nlt CONVERT_TO_LINEAR map.gpkg FILE` makes lines of them"
        ),
        Some((_, name)) => {
            format!("{name} is not read: `ogr2ogr -nlt MULTIPOLYGON map.gpkg FILE` makes polygons of it")
        }
        None => format!("{kind} is no type of geometries that is read here"),
    }
}

/// Returns the number of the first unsupported type in a text. O(bytes).
#[cfg(feature = "wkt")]
pub(super) fn unread_in(text: &str) -> Option<u32> {
    let of_word = |word: &str| {
        let word = word.trim_end_matches(['Z', 'z', 'M', 'm']);
        UNREAD.iter().find(|(_, name)| name.eq_ignore_ascii_case(word)).map(|(number, _)| *number)
    };
    text.split(|c: char| !c.is_ascii_alphabetic()).find_map(of_word)
}
