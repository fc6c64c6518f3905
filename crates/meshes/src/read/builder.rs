//! An indexed mesh under construction by a reader.

use super::error::{Cause, Failure, Position};
use crate::IndexedMesh;

/// The points and faces read up to this point. Faces may list points that come later, so indices are checked at the end.
#[derive(Debug)]
pub(super) struct Builder {
    points: Vec<[f64; 3]>,
    corners: Vec<u32>,
    offsets: Vec<u32>,
    /// The largest index in a face, and its position.
    largest: Option<(u32, Position)>,
    /// The number of the first point in the format.
    first: i64,
}

impl Builder {
    pub(super) fn new(first: i64) -> Self {
        Self { points: Vec::new(), corners: Vec::new(), offsets: vec![0], largest: None, first }
    }

    /// Reserves room for the counts of a header, but for no more than `left` bytes can hold.
    pub(super) fn reserve(&mut self, points: u64, faces: u64, sides: u64, left: usize) {
        // In text, a coordinate or an index has at least one byte and a blank; in most binary files, four bytes.
        let fits = |count: u64, bytes: usize| usize::try_from(count).unwrap_or(usize::MAX).min(left / bytes);
        self.points.reserve(fits(points, 6));
        self.offsets.reserve(fits(faces, 6));
        self.corners.reserve(fits(faces.saturating_mul(sides), 2));
    }

    pub(super) fn points(&self) -> &[[f64; 3]] {
        &self.points
    }

    #[inline]
    pub(super) fn point(&mut self, point: [f64; 3], at: Position) -> Result<(), Failure> {
        if self.points.len() == IndexedMesh::MOST {
            return Err(Failure::new(at, Cause::TooLarge));
        }
        self.points.push(point);
        Ok(())
    }

    /// Adds a corner to the face that is being read; points are counted from 0 here.
    #[inline]
    pub(super) fn corner(&mut self, point: i64, at: Position) -> Result<(), Failure> {
        let Ok(index) = u32::try_from(point) else {
            let index = point.saturating_add(self.first);
            return Err(Failure::new(at, Cause::IndexOutOfRange { index, points: self.points.len() }));
        };
        if self.corners.len() == IndexedMesh::MOST {
            return Err(Failure::new(at, Cause::TooLarge));
        }
        if self.largest.is_none_or(|(largest, _)| index > largest) {
            self.largest = Some((index, at));
        }
        self.corners.push(index);
        Ok(())
    }

    #[inline]
    pub(super) fn face(&mut self, at: Position) -> Result<(), Failure> {
        if self.offsets.len() > IndexedMesh::MOST {
            return Err(Failure::new(at, Cause::TooLarge));
        }
        self.offsets.push(self.corners.len() as u32);
        Ok(())
    }

    pub(super) fn finish(self) -> Result<IndexedMesh, Failure> {
        if let Some((index, at)) = self.largest.filter(|(index, _)| *index as usize >= self.points.len()) {
            let index = i64::from(index) + self.first;
            return Err(Failure::new(at, Cause::IndexOutOfRange { index, points: self.points.len() }));
        }
        Ok(IndexedMesh::new(self.points, self.corners, self.offsets).expect("indices and sizes were checked"))
    }
}
