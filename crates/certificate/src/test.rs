//! The tests by name, and their failures.

use core::fmt;

macro_rules! tests {
    ($($(#[$doc:meta])* $test:ident $name:literal of $records:literal,)*) => {
        /// A test of a certificate, for each record of one kind. `proofs/coq/CERTIFICATE.md` has the same [names](Self::name).
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        #[non_exhaustive]
        pub enum Test {
            $($(#[$doc])* $test,)*
        }

        impl Test {
            /// All tests.
            pub const ALL: [Self; [$($name),*].len()] = [$(Self::$test),*];

            /// Returns the name of the test.
            #[must_use]
            pub const fn name(self) -> &'static str {
                match self { $(Self::$test => $name,)* }
            }

            /// Returns the kind of record, in the plural; empty for a test of the whole.
            #[must_use]
            pub const fn records(self) -> &'static str {
                match self { $(Self::$test => $records,)* }
            }
        }
    };
}

tests! {
    /// The numbers of ranks and of half-edge slots are equal, and slot numbers fit into 32 bits. Otherwise nothing else is
    /// tested.
    Readable "readable" of "",
    /// `twin(twin(h)) = h`, and `twin(h) ≠ h`.
    TwinOk "twin_ok" of "half-edges",
    /// `prev(next(h)) = h`, and `next(prev(h)) = h`.
    NextOk "next_ok" of "half-edges",
    /// `origin(next(h)) = origin(twin(h))`.
    TargetOk "target_ok" of "half-edges",
    /// The origin keeps a half-edge.
    OriginOk "origin_ok" of "half-edges",
    /// The next half-edge has the same boundary component, which starts at a half-edge.
    CycleOk "cycle_ok" of "half-edges",
    /// A neighbour has a lower rank, or the half-edge is a root.
    RankOk "rank_ok" of "half-edges",
    /// The vertex and its half-edge, or its boundary component if isolated, name each other.
    VertexOk "vertex_ok" of "vertices",
    /// The boundary component and its start name each other; an isolated vertex is an inner one.
    StartOk "start_ok" of "boundary components",
    /// The face lists the boundary component at its place.
    PlaceOk "place_ok" of "boundary components",
    /// The entries of the list of the face name it, and their places.
    FaceOk "face_ok" of "faces",
    /// There is one unbounded face.
    OneUnbounded "one_unbounded" of "",
    /// Vertices, cycles, half-edges and roots are in Euler's proportion.
    EulerOk "euler_ok" of "",
    /// Without stored boundary components: the half-edge names the face of its boundary component.
    FaceNameOk "face_name_ok" of "half-edges",
    /// Without stored boundary components: the face names starts of its boundary components, in their order.
    FaceStartsOk "face_starts_ok" of "faces",
    /// The twin is a dart, and its twin is this one.
    DartTwinOk "dart_twin_ok" of "darts",
    /// The next dart starts where the twin starts.
    DartPointOk "dart_point_ok" of "darts",
    /// The half-edge on the dart names the dart; or neither the dart nor its twin has a half-edge.
    DartHalfEdgeOk "dart_half_edge_ok" of "darts",
    /// The half-edge ahead is on the dart, or is the half-edge ahead of the next dart counter-clockwise.
    DartAheadOk "dart_ahead_ok" of "darts",
    /// The face is the same in the triangle and across added edges, and equals the face of the half-edge.
    DartFaceOk "dart_face_ok" of "darts",
    /// A neighbour in the same face has a lower rank, or the dart is the dart of its face.
    DartRankOk "dart_rank_ok" of "darts",
    /// Triangle 0 runs clockwise, all others counter-clockwise.
    TriangleOk "triangle_ok" of "triangles",
    /// The half-edge lies on a dart that starts at its origin, and its twin on the twin.
    HalfEdgeDartOk "half_edge_dart_ok" of "half-edges",
    /// The next half-edge counter-clockwise lies on the next dart that has one.
    RotationOk "rotation_ok" of "half-edges",
    /// The dart starts at the vertex; if it is isolated, the dart is in its face.
    VertexDartOk "vertex_dart_ok" of "vertices",
    /// On surfaces: the next half-edge around the origin has a greater turn, or is the one kept by the vertex.
    TurnOk "turn_ok" of "half-edges",
    /// On surfaces: the next half-edge has a greater step, or is the start of the boundary component.
    StepOk "step_ok" of "half-edges",
    /// On surfaces: neighbours have the same component, and one of them a lower rank, except at the root.
    ComponentOk "component_ok" of "half-edges",
    /// On open surfaces: a half-edge of a hole is the only one that leaves its origin, and its twin bounds a face.
    BorderOk "border_ok" of "half-edges",
    /// On surfaces: the half-edge kept by a vertex leaves it.
    SurfaceVertexOk "surface_vertex_ok" of "vertices",
    /// On surfaces: the boundary component starts with one of its half-edges, and is the outer one of its face; or it is a hole.
    SurfaceBoundaryOk "surface_boundary_ok" of "boundary components",
    /// On surfaces: the outer boundary component of the face names it.
    SurfaceFaceOk "surface_face_ok" of "faces",
    /// On surfaces: vertices, boundary components, half-edges and roots are in Euler's proportion for the genus.
    GenusOk "genus_ok" of "",
}

/// A test that failed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Failure {
    test: Test,
    count: usize,
    first: usize,
}

impl Failure {
    /// Returns the test.
    #[must_use]
    pub const fn test(self) -> Test {
        self.test
    }

    /// Returns the number of failing records; 1 for a test of the whole.
    #[must_use]
    pub const fn count(self) -> usize {
        self.count
    }

    /// Returns the first failing record. `None` for a test of the whole.
    #[must_use]
    pub const fn first(self) -> Option<usize> {
        if self.test.records().is_empty() { None } else { Some(self.first) }
    }
}

/// Formats the line printed by Coq's checker.
impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.test.name())?;
        match self.first() {
            Some(first) => write!(f, ": {} of the {}, the first is {first}", self.count, self.test.records()),
            None => Ok(()),
        }
    }
}

/// A consumer of test results, as needed by a checker.
pub(super) trait Noted {
    /// Records the result of a test of record `i`. Returns `None` if the check ends here.
    fn note(&mut self, test: Test, i: usize, passes: bool) -> Option<()>;
}

/// Ends the check at the first failure.
pub(super) struct UntilFailure;

impl Noted for UntilFailure {
    #[inline(always)]
    fn note(&mut self, _: Test, _: usize, passes: bool) -> Option<()> {
        passes.then_some(())
    }
}

pub(super) struct Failures([Option<Failure>; Test::ALL.len()]);

impl Failures {
    pub(super) const fn new() -> Self {
        Self([None; Test::ALL.len()])
    }

    #[cold]
    #[inline(never)]
    fn add(&mut self, test: Test, i: usize) {
        self.0[test as usize].get_or_insert(Failure { test, count: 0, first: i }).count += 1;
    }

    pub(super) fn into_result(self) -> Result<(), alloc::vec::Vec<Failure>> {
        let failures: alloc::vec::Vec<Failure> = self.0.into_iter().flatten().collect();
        if failures.is_empty() { Ok(()) } else { Err(failures) }
    }
}

impl Noted for Failures {
    #[inline]
    fn note(&mut self, test: Test, i: usize, passes: bool) -> Option<()> {
        if !passes {
            self.add(test, i);
        }
        Some(())
    }
}
