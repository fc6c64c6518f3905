//! Drawing points, segments and rings exactly where they are.

use super::at::At;
use super::error::EditError;
use super::outcome::Edited;
use crate::planar_map::PlanarMap;

impl PlanarMap {
    /// Inserts a vertex at a point: none if there is one already; one that splits the edge on which it lies; an isolated
    /// one in a face.
    ///
    /// [`Edited::vertices`] has the vertex, and [`Edited::vertices_made`] is empty if it was there.
    ///
    /// O(1) once the point is found; see [`At`].
    ///
    /// ```
    /// use twinedge_map::PlanarMap;
    ///
    /// let mut map = PlanarMap::new();
    /// map.insert_segment([0.0, 0.0], [2.0, 2.0])?;
    /// let on_the_edge = map.insert_point([1.0, 1.0])?;
    /// assert_eq!(on_the_edge.edges_split.len(), 1);
    /// assert_eq!(map.insert_point([1.0, 1.0])?.vertices, on_the_edge.vertices);
    /// // Only just off the edge is in the face.
    /// let isolated = map.insert_point([0.5, 0.5 + f64::EPSILON])?;
    /// assert!(isolated.edges_split.is_empty());
    /// # Ok::<(), twinedge_map::edit::EditError>(())
    /// ```
    ///
    /// # Errors
    /// [`EditError::NotPlane`]; [`EditError::NotFinite`]; [`EditError::OutOfRange`]; [`EditError::Operator`] for a stale key
    /// or a map that is full.
    pub fn insert_point(&mut self, at: impl Into<At>) -> Result<Edited, EditError> {
        self.draw(&[at.into()], false)
    }

    /// Inserts a segment, exactly.
    ///
    /// ```text
    ///   ·─────┬─────·               ·─────┬─────·
    ///   │     │     │               │     │     │
    ///   ├─────┼─────┤      ──►      ├─────┼─────┤
    ///   │     │     │               │     │  ╱  │
    ///   ·─────┴─────·               ·─────┴─╱───·
    ///                                      ╱
    /// ```
    ///
    /// Vertices that lie on it cut it in several edges. An end in the interior of an edge splits that. Where an edge runs
    /// along it, it is reused. Where it crosses an edge, it is refused: the crossing has no coordinates of its own in
    /// general; [`insert_segment_snapped`](Self::insert_segment_snapped) rounds them.
    ///
    /// Of a bounded face that is split, the part with the shorter outer boundary is the new one; on a tie, that to the left.
    ///
    /// What the index takes to find what is on it ([costs](crate::edit#costs)), once its first point is found; see [`At`].
    /// For each face that is split into parts with boundaries of lengths s and t, s ≤ t, where j of its k inner boundary
    /// components lie in the box around the first, O(k + (s + j) log (s + j)) at most.
    ///
    /// ```
    /// use twinedge_map::PlanarMap;
    /// use twinedge_map::edit::EditError;
    ///
    /// let mut map = PlanarMap::new();
    /// let wall = map.insert_segment([0.0, 0.0], [4.0, 0.0])?.way[0];
    /// assert_eq!(map.insert_segment([1.0, 1.0], [1.0, -1.0]), Err(EditError::Crosses(wall)));
    /// // Of this the middle is there.
    /// let longer = map.insert_segment([-2.0, 0.0], [6.0, 0.0])?;
    /// assert_eq!((longer.way.len(), longer.way[1], longer.edges_made.len()), (3, wall, 2));
    /// # Ok::<(), twinedge_map::edit::EditError>(())
    /// ```
    ///
    /// # Errors
    /// [`EditError::NotPlane`]; [`EditError::NotFinite`]; [`EditError::OutOfRange`]; [`EditError::NoLength`];
    /// [`EditError::Crosses`]; [`EditError::Operator`] for a stale key or a map that is full.
    pub fn insert_segment(&mut self, from: impl Into<At>, to: impl Into<At>) -> Result<Edited, EditError> {
        self.draw(&[from.into(), to.into()], false)
    }

    /// Inserts a closed chain of segments through these points, each as [`insert_segment`](Self::insert_segment) would, all
    /// or none. Whether the last point repeats the first makes no difference.
    ///
    /// The ring may touch itself and run along itself, but not cross itself.
    ///
    /// O(sizes of the faces that each of its m segments passes + m log m), once its first point is found, and besides for
    /// each face that is split what it costs there. O(m²) if it touches itself elsewhere than at its points. Nothing is
    /// copied for the sake of atomicity: the ring is held against the map and against itself before anything changes.
    ///
    /// ```
    /// use twinedge_map::PlanarMap;
    ///
    /// let mut map = PlanarMap::new();
    /// map.insert_ring([[0.0, 0.0], [8.0, 0.0], [0.0, 8.0], [0.0, 0.0]])?;
    /// let lake = map.insert_ring([[1.0, 1.0], [3.0, 1.0], [1.0, 3.0]])?;
    /// assert_eq!((lake.way.len(), map.dcel().face_count()), (3, 3));
    /// # Ok::<(), twinedge_map::edit::EditError>(())
    /// ```
    ///
    /// # Errors
    /// [`EditError::NotARing`]; [`EditError::SelfCrossing`]; and those of [`insert_segment`](Self::insert_segment).
    pub fn insert_ring(&mut self, points: impl IntoIterator<Item = impl Into<At>>) -> Result<Edited, EditError> {
        let mut points: Vec<At> = points.into_iter().map(Into::into).collect();
        let repeats_first = match points[..] {
            [first, .., last] => self.point_of(first)? == self.point_of(last)?,
            _ => false,
        };
        if repeats_first {
            points.pop();
        }
        if points.len() < 3 {
            return Err(EditError::NotARing { points: points.len() });
        }
        self.draw(&points, true)
    }
}
