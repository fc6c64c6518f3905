//! The columns of certificates have the proof's file names, in the order of its tables. Also tests a reference to columns, and
//! columns without points.

use twinedge_certificate::{Column, Columns, Labels, LabelsError};

const FILES: &str = include_str!("../../../../proofs/coq/CERTIFICATE.md");

/// The file names in the tables of a section, without extensions.
fn listed(section: &str) -> Vec<&'static str> {
    let sections = FILES.split("\n## ").filter(|text| text.lines().next() == Some(section));
    let rows = sections.flat_map(str::lines).filter_map(|line| line.strip_prefix("| `"));
    rows.filter_map(|row| row.split_once(".u32`")).map(|(name, _)| name).filter(|name| !name.contains('`')).collect()
}

fn names(columns: &[Column]) -> Vec<&'static str> {
    columns.iter().map(|column| column.name()).collect()
}

#[test]
fn a_subdivision_has_the_columns_of_its_folder() {
    assert_eq!(names(Column::of_subdivision()), listed("The folder"));
    assert_eq!(Column::of_subdivision().len(), 15);
}

/// Most of these are also columns of subdivisions; the others are in the table of surfaces.
#[test]
fn a_surface_has_the_columns_of_its_tables() {
    let of_surface = names(Column::of_surface());
    let [own, shared] = [listed("Surfaces"), listed("The folder")];
    assert!(own.len() > 4 && own.iter().all(|name| of_surface.contains(name)), "{own:?}");
    assert!(of_surface.iter().all(|name| own.contains(name) || shared.contains(name)), "{of_surface:?}");
}

#[test]
fn a_drawing_has_the_columns_of_its_table() {
    assert_eq!(names(Column::of_drawing()), listed("Drawings"));
    assert_eq!(Column::of_drawing().len(), 9);
}

/// Columns that report seven points, but only the location of the first one.
struct SevenPoints(Labels);

impl Columns for SevenPoints {
    type Numbers<'a> = &'a [u32];

    fn column(&self, column: Column) -> &[u32] {
        self.0.column(column)
    }
    fn points(&self) -> usize {
        7
    }
    fn point(&self, point: usize) -> Option<[i64; 2]> {
        (point == 0).then_some([3, -4])
    }
}

fn points(columns: impl Columns) -> (usize, [Option<[i64; 2]>; 2]) {
    (columns.points(), [columns.point(0), columns.point(1)])
}

#[test]
fn a_reference_has_the_points_of_its_columns_and_labels_have_none() {
    let seven = SevenPoints(Labels::default());
    assert_eq!(points(&seven), (7, [Some([3, -4]), None]));
    assert_eq!(points(seven), (7, [Some([3, -4]), None]));
    assert_eq!(points(Labels::default()), (0, [None; 2]));
}

#[test]
fn each_reason_against_labels_is_said_in_words_of_its_own() {
    assert!(LabelsError::NoContainment.to_string().contains("no lists of inner boundary components"));
    assert!(LabelsError::TooLarge.to_string().contains("more records than 32 bits can number"));
    assert!(LabelsError::OutOfMemory.to_string().contains("memory"));
}
