//! Points, and faces as lists of point numbers.

/// A mesh as in files: points, and faces that list the points around them. Any fault is possible except an index out of range.
///
/// The lists of all faces lie in one array, the *corners*. `offsets` has the start of each face.
///
/// ```
/// use twinedge_meshes::IndexedMesh;
///
/// let square = vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
/// let mesh = IndexedMesh::from_faces(square, [[0, 1, 2], [0, 2, 3]])?;
/// assert_eq!(mesh.face_count(), 2);
/// assert_eq!(mesh.face(1), [0, 2, 3]);
/// # Ok::<(), twinedge_meshes::IndexedMeshError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct IndexedMesh {
    points: Vec<[f64; 3]>,
    corners: Vec<u32>,
    offsets: Vec<u32>,
}

/// The reason that points and faces are no [`IndexedMesh`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum IndexedMeshError {
    /// A face lists a point that does not exist.
    #[error("face {face} lists point {index}, but there are {points} points, counted from 0")]
    IndexOutOfRange {
        /// The face.
        face: usize,
        /// The listed index.
        index: u32,
        /// The number of points.
        points: usize,
    },
    /// The offsets do not start at 0, decrease, or do not end at the number of corners.
    #[error("offset {position} is out of order: offsets rise from 0 to the number of corners")]
    Offsets {
        /// The first offset that is wrong.
        position: usize,
    },
    /// There are more than 2³¹ − 2 points, corners or faces.
    #[error("more than 2,147,483,646 points, corners or faces")]
    TooLarge,
}

impl IndexedMesh {
    /// The largest number of points, corners, and faces, so that twice this number still has 32 bits.
    pub(crate) const MOST: usize = u32::MAX as usize / 2 - 1;

    /// Makes a mesh from flat arrays: face `f` lists `corners[offsets[f] .. offsets[f + 1]]`, so there is one offset more than
    /// there are faces. The coordinates are not checked. O(corners).
    ///
    /// # Errors
    ///
    /// If a corner is not the index of a point, offsets are out of order, or the mesh is too large.
    pub fn new(points: Vec<[f64; 3]>, corners: Vec<u32>, offsets: Vec<u32>) -> Result<Self, IndexedMeshError> {
        if points.len() > Self::MOST || corners.len() > Self::MOST || offsets.len() > Self::MOST + 1 {
            return Err(IndexedMeshError::TooLarge);
        }
        if offsets.first() != Some(&0) {
            return Err(IndexedMeshError::Offsets { position: 0 });
        }
        if let Some(falls) = offsets.windows(2).position(|pair| pair[0] > pair[1]) {
            return Err(IndexedMeshError::Offsets { position: falls + 1 });
        }
        if offsets.last() != Some(&(corners.len() as u32)) {
            return Err(IndexedMeshError::Offsets { position: offsets.len() - 1 });
        }
        if let Some(corner) = corners.iter().position(|index| *index as usize >= points.len()) {
            let face = offsets.partition_point(|offset| *offset as usize <= corner) - 1;
            return Err(IndexedMeshError::IndexOutOfRange { face, index: corners[corner], points: points.len() });
        }
        Ok(Self { points, corners, offsets })
    }

    /// Makes a mesh from one list for each face. O(corners).
    ///
    /// # Errors
    ///
    /// If a face lists a point that does not exist, or the mesh is too large.
    pub fn from_faces<F: AsRef<[u32]>>(
        points: Vec<[f64; 3]>,
        faces: impl IntoIterator<Item = F>,
    ) -> Result<Self, IndexedMeshError> {
        let (mut corners, mut offsets) = (Vec::new(), vec![0]);
        for face in faces {
            corners.extend_from_slice(face.as_ref());
            if corners.len() > Self::MOST {
                return Err(IndexedMeshError::TooLarge);
            }
            offsets.push(corners.len() as u32);
        }
        Self::new(points, corners, offsets)
    }

    /// Returns the coordinates of the points, in the units of the file.
    #[must_use]
    pub fn points(&self) -> &[[f64; 3]] {
        &self.points
    }

    /// Returns the lists of all faces, one after the other.
    #[must_use]
    pub fn corners(&self) -> &[u32] {
        &self.corners
    }

    /// Returns the start of the list of each face in [`corners`](Self::corners), and at the end the number of corners.
    #[must_use]
    pub fn offsets(&self) -> &[u32] {
        &self.offsets
    }

    /// Returns the number of faces.
    #[must_use]
    pub fn face_count(&self) -> usize {
        self.offsets.len() - 1
    }

    /// Returns the points around a face, in order.
    ///
    /// # Panics
    ///
    /// If there is no such face.
    #[must_use]
    pub fn face(&self, face: usize) -> &[u32] {
        &self.corners[self.offsets[face] as usize..self.offsets[face + 1] as usize]
    }

    /// Returns the points around each face.
    #[must_use]
    pub fn faces(&self) -> impl ExactSizeIterator<Item = &[u32]> + '_ {
        self.offsets.windows(2).map(|pair| &self.corners[pair[0] as usize..pair[1] as usize])
    }
}
