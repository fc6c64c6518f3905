//! Structures whose vertices have coordinates.

use twinedge::validate::{Only, View};
use twinedge_geometry::Point;

/// A structure whose vertices have coordinates.
pub trait Embedding: View {
    /// Returns the coordinates of the vertex. Called only on live vertices.
    fn point(&self, vertex: usize) -> Point;

    /// Returns the number of bends of the half-edge: 0 for a straight edge.
    ///
    /// Called only on the half-edge with the smaller index; its twin has the bends in reverse. An edge that ends at one breaks
    /// G4.
    fn bends(&self, half_edge: usize) -> usize {
        let _ = half_edge;
        0
    }

    /// Returns the `bend`-th bend from the origin of the half-edge, counted from 0, below [`bends`](Self::bends).
    ///
    /// ```
    /// use twinedge_geometry::Point;
    /// use twinedge::validate::{Collect, Expectation, Link, Parts, View, Violation};
    /// use twinedge_map::{Embedding, validate_embedding};
    ///
    /// /// One edge from (0, 0) to (4, 0), drawn as a line with bends.
    /// struct Road(Vec<[f64; 2]>);
    ///
    /// impl View for Road {
    ///     fn parts(&self) -> Parts { Parts::NONE }
    ///     fn vertex_slots(&self) -> usize { 2 }
    ///     fn half_edge_slots(&self) -> usize { 2 }
    ///     fn origin(&self, half_edge: usize) -> Link { Some(half_edge) }
    ///     fn twin(&self, half_edge: usize) -> Link { Some(1 - half_edge) }
    ///     fn next(&self, half_edge: usize) -> Link { Some(1 - half_edge) }
    /// }
    ///
    /// impl Embedding for Road {
    ///     fn point(&self, vertex: usize) -> Point { [[0.0, 0.0], [4.0, 0.0]][vertex].into() }
    ///     fn bends(&self, _: usize) -> usize { self.0.len() }
    ///     fn bend(&self, _: usize, bend: usize) -> Point { self.0[bend].into() }
    /// }
    ///
    /// let judge = |road: &Road| validate_embedding(road, &Expectation::plane(), Collect::All);
    /// assert!(judge(&Road(vec![[1.0, 1.0], [3.0, 1.0]])).is_valid());
    /// let crossing = judge(&Road(vec![[3.0, 1.0], [3.0, -1.0], [1.0, -1.0], [1.0, 2.0], [4.0, 2.0]]));
    /// let violation = Violation::SegmentsCross { first: 0, first_segment: 0, second: 0, second_segment: 3 };
    /// assert_eq!(crossing.first(), Some(&violation));
    /// ```
    fn bend(&self, half_edge: usize, bend: usize) -> Point {
        let _ = (half_edge, bend);
        Point::default()
    }
}

impl<E: Embedding + ?Sized> Embedding for &E {
    fn point(&self, vertex: usize) -> Point {
        (**self).point(vertex)
    }

    fn bends(&self, half_edge: usize) -> usize {
        (**self).bends(half_edge)
    }

    fn bend(&self, half_edge: usize, bend: usize) -> Point {
        (**self).bend(half_edge, bend)
    }
}

impl<E: Embedding + ?Sized> Embedding for alloc::boxed::Box<E> {
    fn point(&self, vertex: usize) -> Point {
        (**self).point(vertex)
    }

    fn bends(&self, half_edge: usize) -> usize {
        (**self).bends(half_edge)
    }

    fn bend(&self, half_edge: usize, bend: usize) -> Point {
        (**self).bend(half_edge, bend)
    }
}

impl<E: Embedding> Embedding for Only<E> {
    fn point(&self, vertex: usize) -> Point {
        self.whole().point(vertex)
    }

    fn bends(&self, half_edge: usize) -> usize {
        self.whole().bends(half_edge)
    }

    fn bend(&self, half_edge: usize, bend: usize) -> Point {
        self.whole().bend(half_edge, bend)
    }
}
