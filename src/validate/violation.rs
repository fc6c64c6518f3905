//! Every way of breaking a rule, with the records involved, what usually causes it and what mends it.

use super::record::{Field, Record};
use super::rule::Rule;
use super::view::{BoundaryPlace, Link};

macro_rules! violations {
    ($($rule:ident $variant:ident $({ $($field:ident: $type:ty),+ })? $kind:literal
        $what:literal cause $cause:literal remedy $remedy:literal;)*) => {
        /// One broken rule, with the records that break it. `Display` says in a sentence what is wrong and why it matters.
        ///
        /// Numbers are the indices of the [`View`](super::View).
        ///
        /// ```
        /// use twinedge::validate::{Collect, Expectation, Table, Violation, validate};
        /// // A loop that is its own twin.
        /// let table: Table = "V 1 0 - H 1 0 0 0 0 0 B 1 0 h0 i0 F 1 - 1 0".parse()?;
        /// let report = validate(&table, &Expectation::plane(), Collect::All);
        /// let violation = report.violations()[0];
        /// assert_eq!(violation, Violation::TwinIsSelf { half_edge: 0 });
        /// assert_eq!(violation.kind(), "twin_is_self");
        /// assert_eq!(violation.to_string(), "half-edge 0 is its own twin, so its edge has one side only");
        /// assert!(violation.remedy().starts_with("create both half-edges of an edge together"));
        /// # Ok::<(), twinedge::validate::ParseTableError>(())
        /// ```
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
        #[cfg_attr(feature = "serde", serde(tag = "kind", content = "fields", rename_all = "snake_case"))]
        #[non_exhaustive]
        #[allow(missing_docs, reason = "the fields are named after the words of the design, and each variant says what they are")]
        pub enum Violation {
            $(
                #[doc = concat!(stringify!($rule), ": ", $what)]
                #[doc = concat!("\n\n*Usual cause:* ", $cause, ".")]
                #[doc = concat!("\n\n*Remedy:* ", $remedy, ".")]
                $variant $({ $($field: $type),+ })?,
            )*
        }

        impl Violation {
            /// All names of violations, in the order of the rules: see [`kind`](Self::kind).
            pub const KINDS: &[&str] = &[$($kind),*];

            /// The name of the violation, in snake case. Names do not change between versions.
            #[must_use]
            pub const fn kind(&self) -> &'static str {
                match self { $(Self::$variant { .. } => $kind,)* }
            }

            /// The rule that is broken.
            #[must_use]
            pub const fn rule(&self) -> Rule {
                match self { $(Self::$variant { .. } => Rule::$rule,)* }
            }

            /// What usually causes such a violation, as part of a sentence.
            #[must_use]
            pub const fn cause(&self) -> &'static str {
                match self { $(Self::$variant { .. } => $cause,)* }
            }

            /// What mends it, as part of a sentence.
            #[must_use]
            pub const fn remedy(&self) -> &'static str {
                match self { $(Self::$variant { .. } => $remedy,)* }
            }
        }
    };
}

violations! {
    R1 Nil { record: Record, field: Field } "nil"
        "a link that the record needs is nil."
        cause "a record was created and not linked in, or an operation returned early and left it unfinished"
        remedy "set the link, or retire the record; if the structure has no such links at all, leave the part out of the expectation by `Expectation::without`";
    R1 Dangling { record: Record, field: Field, value: usize } "dangling"
        "a link leads past the end or to a vacant slot."
        cause "a record was removed, and a link to it was left behind, or indices were not adjusted when records were moved"
        remedy "find what links to a record before it is removed, and use generational keys, so that a stale key is an error; if all such links dangle, implement the number of slots (`face_slots`, `boundary_slots`)";
    R1 ListTooLong { face: usize, claimed: usize } "list_too_long"
        "the faces up to this one list more than twice as many inner boundary components as there are, and 16. The rest of the lists was not read, so its links cannot be said to be live."
        cause "entries are appended to the list of a face and never taken out, or the length is not initialised"
        remedy "list each boundary component once, and take its entry out where it moves or goes";
    L1 TwinIsSelf { half_edge: usize } "twin_is_self"
        "a half-edge is its own twin."
        cause "half-edges were created one by one instead of in pairs, or the twin of an open boundary was set to the half-edge itself"
        remedy "create both half-edges of an edge together; at an open boundary let the twin be nil, and validate with `Expectation::open`";
    L1 TwinNotMutual { half_edge: usize, twin: usize, found: Link } "twin_not_mutual"
        "the twin of the twin is another half-edge, or nil."
        cause "three or more faces share an edge (a non-manifold mesh), so a later pair took over a half-edge of an earlier one, or only one direction was written"
        remedy "write both directions in one place; split the edge where more than two faces meet in it";
    L2 PrevOfNext { half_edge: usize, next: usize, found: usize } "prev_of_next"
        "`prev(next(h))` is not `h`."
        cause "`next` was changed and `prev` was not"
        remedy "write `next(a) = b` and `prev(b) = a` by one function, and nowhere else";
    L2 NextOfPrev { half_edge: usize, prev: usize, found: usize } "next_of_prev"
        "`next(prev(h))` is not `h`."
        cause "`prev` was changed and `next` was not"
        remedy "write `next(a) = b` and `prev(b) = a` by one function, and nowhere else";
    L2 NextShared { first: usize, second: usize, next: usize } "next_shared"
        "without `prev`: two half-edges have the same next."
        cause "a half-edge was inserted into a cycle, and the one that it displaced still has the old next"
        remedy "when a half-edge is inserted, relink the one before it too";
    L3 Target { half_edge: usize, next: usize, target: usize, found: usize } "target"
        "the next half-edge starts elsewhere than at the target."
        cause "an origin was not updated when vertices were split or merged, or half-edges were linked around the wrong vertex"
        remedy "when a vertex goes, give all half-edges of its rotation their new origin; link only half-edges that meet";
    V1 NotLeaving { vertex: usize, half_edge: usize, origin: usize } "not_leaving"
        "the half-edge kept by a vertex starts at another vertex."
        cause "the half-edge that the vertex kept was moved to another vertex, or the vertex keeps one that arrives"
        remedy "after each change at a vertex let it keep a half-edge that leaves it; if it keeps one that arrives, answer with its twin";
    V2 SplitRotation { vertex: usize, half_edge: usize, reached: usize, degree: usize } "split_rotation"
        "the rotation does not reach all half-edges with that origin."
        cause "two fans of faces touch in one vertex (a non-manifold mesh), or vertices at the same place were merged without relinking their half-edges"
        remedy "give each fan a vertex of its own, or link the fans into one rotation";
    B1 BoundaryChanges { half_edge: usize, next: usize, boundary: Link, found: Link } "boundary_changes"
        "a half-edge and its next belong to different boundary components."
        cause "a cycle was split or joined, and its half-edges were not all relabelled"
        remedy "after `next` has changed, walk the new cycle and label each half-edge of it";
    B1 StartElsewhere { boundary: usize, half_edge: usize, found: Link } "start_elsewhere"
        "the start of a boundary component belongs to another one."
        cause "the half-edge at which it started went to another cycle"
        remedy "when a half-edge leaves a cycle, let the boundary component start at one that stays";
    B1 SecondCycle { boundary: usize, cycle: usize, half_edges: usize } "second_cycle"
        "a boundary component has more half-edges than the cycle of its start."
        cause "a cycle was split in two, and the second one got no boundary component of its own"
        remedy "create a boundary component for the second cycle, label its half-edges, and list it in a face";
    B1 FaceChanges { half_edge: usize, next: usize, face: Link, found: Link } "face_changes"
        "without records for boundary components: a half-edge and its next name different faces."
        cause "a face was split or merged, and its half-edges were not all relabelled"
        remedy "after `next` has changed, walk the new cycle and label each half-edge of it";
    B1 ListedElsewhere { face: usize, half_edge: usize, found: Link } "listed_elsewhere"
        "without records for boundary components: a face lists a half-edge that names another face."
        cause "the half-edge that the face kept went to another face"
        remedy "let each face keep a half-edge that names it";
    B2 IsolatedUnclaimed { vertex: usize } "isolated_unclaimed"
        "no boundary component starts at a vertex without half-edges."
        cause "the last edge at the vertex was removed and the vertex was kept, or the input has points that no edge uses"
        remedy "list the vertex as an inner boundary component of the face in which it lies, or remove it";
    B2 IsolatedTwice { vertex: usize, first: Record, second: Record } "isolated_twice"
        "two boundary components start at one vertex."
        cause "an isolated vertex was added to a second face and not taken out of the first"
        remedy "move the one boundary component instead of creating another";
    B2 StartsAtConnected { record: Record, vertex: usize } "starts_at_connected"
        "a boundary component starts at a vertex that has half-edges."
        cause "an edge was added at an isolated vertex, and the boundary component that the vertex was is still there"
        remedy "retire that boundary component when the vertex gets its first edge";
    B2 IsolatedMismatch { vertex: usize, boundary: usize, found: Link } "isolated_mismatch"
        "an isolated vertex names another boundary component than the one that starts at it."
        cause "the boundary component was replaced and the link of the vertex was not"
        remedy "write both links in one place";
    B2 ConnectedNamesBoundary { vertex: usize, boundary: usize } "connected_names_boundary"
        "a vertex that has half-edges names a boundary component that it would be if it were isolated."
        cause "the link was not cleared when the vertex got its first edge"
        remedy "set it to nil as soon as a half-edge leaves the vertex";
    F1 NoUnboundedFace "no_unbounded_face"
        "every face has an outer boundary component."
        cause "a closed mesh was expected to lie in the plane, or the outside has no face record"
        remedy "use `Expectation::surface` for a mesh, or `without(Part::UnboundedFace)` where the outside has no record";
    F1 SecondUnboundedFace { first: usize, second: usize } "second_unbounded_face"
        "two faces have no outer boundary component."
        cause "a face was created and its outer boundary component was not set, or two maps were put together with the unbounded face of each"
        remedy "set the outer boundary component (`outer`, or `outer_half_edge` without boundary component records), or merge the unbounded faces";
    F1 NoOuter { face: usize } "no_outer"
        "without an unbounded face: a face has no outer boundary component."
        cause "a face was created and its outer boundary component was not set, or a face that is gone was not retired"
        remedy "set the outer boundary component (`outer`, or `outer_half_edge` without boundary component records), or retire the face";
    F1 OuterIsVertex { face: usize, boundary: usize } "outer_is_vertex"
        "the outer boundary component of a face is an isolated vertex."
        cause "an isolated vertex was entered as outer instead of inner"
        remedy "list it as an inner boundary component of the face in which it lies";
    F2 NotListed { boundary: usize, face: Link } "not_listed"
        "no face lists the boundary component."
        cause "it was created, or moved, and not entered in the list of its face"
        remedy "enter it in the list of the face that it names";
    F2 CycleNotListed { half_edge: usize } "cycle_not_listed"
        "without records for boundary components: no face lists the cycle of this half-edge."
        cause "a face has a hole that it does not list, or keeps no half-edge of its outer cycle"
        remedy "list a half-edge of each cycle in its face";
    F2 ListedTwice { record: Record, face: usize } "listed_twice"
        "a boundary component (or, without records for them, the cycle of this half-edge) is listed again."
        cause "it was moved to another face, and the entry in the first one was left behind"
        remedy "take the old entry out when the new one is made";
    F2 ListedByOther { boundary: usize, face: usize, found: Link } "listed_by_other"
        "a boundary component is listed by another face than the one that it names."
        cause "it was moved to another face, and only one of the two links was written"
        remedy "write the link to the face and the entry of the list in one place";
    F2 WrongPlace { boundary: usize, place: Option<BoundaryPlace>, listed: BoundaryPlace } "wrong_place"
        "a boundary component is listed at another place than it says."
        cause "an entry was removed by moving the last one into its place, and the one moved was not told its new place"
        remedy "update the place of the entry that is moved; if there are no places, validate `without(Part::Places)`";
    T1 NoOutside { vertex: usize } "no_outside"
        "all boundary components of a component are outer."
        cause "each cycle was taken for the outer boundary of a face, also those that turn clockwise, or a closed mesh was expected to lie in the plane"
        remedy "list the outside of each component as an inner boundary component of the face in which it lies; use `Expectation::surface` for a mesh";
    T1 TwoOutsides { vertex: usize, first: Record, second: Record } "two_outsides"
        "a component has two inner boundary components; these are where they start."
        cause "two components were joined by an edge, and both outsides were kept, or a face inside a component lists its boundary as inner"
        remedy "keep one outside when components are joined; a cycle around a bounded face is outer";
    T2 NestedInItself { vertex: usize, face: usize } "nested_in_itself"
        "a component lies, through others, inside itself."
        cause "a component was moved into a face that lies inside it"
        remedy "move it to a face that is reachable from the unbounded face without passing through the component";
    T3 Genus { vertex: usize, vertices: usize, edges: usize, cycles: usize, genus: usize } "genus"
        "a component has handles."
        cause "edges cross, or half-edges are linked in the wrong order around a vertex, or the mesh has handles"
        remedy "node edges that cross, sort the half-edges around each vertex by angle, or validate with `Expectation::surface`";
    T3 NoSuchSurface { vertex: usize, vertices: usize, edges: usize, cycles: usize } "no_such_surface"
        "no surface has this Euler characteristic."
        cause "the answers of the structure changed during the validation"
        remedy "do not change the structure while it is validated";
    T4 TooManyEdges { vertices: usize, edges: usize } "too_many_edges"
        "more edges than a simple planar map can have."
        cause "the answers of the structure changed during the validation"
        remedy "do not change the structure while it is validated";
    T4 TooManyFaces { vertices: usize, faces: usize } "too_many_faces"
        "more faces than a simple planar map can have."
        cause "the answers of the structure changed during the validation"
        remedy "do not change the structure while it is validated";
    M1 UnusedVertex { vertex: usize } "unused_vertex"
        "no half-edge leaves the vertex."
        cause "faces were deleted and their vertices kept, or the vertex belongs to a line or a point of the input"
        remedy "delete the vertex, or do not ask for `no_unused_vertices`";
    M2 LoopEdge { half_edge: usize, vertex: usize } "loop_edge"
        "an edge starts and ends at the same vertex."
        cause "an edge was contracted while another joined its ends, or a face lists a vertex twice in a row"
        remedy "delete the edge, or subdivide it; refuse to contract an edge whose ends have a neighbour in common that is not opposite to it";
    M2 ParallelEdges { first: usize, second: usize, vertices: [usize; 2] } "parallel_edges"
        "two edges join the same vertices."
        cause "two faces at an edge were not joined as twins, an edge was flipped onto one that was there, or a face has two sides"
        remedy "join the half-edges as twins, or subdivide one of the edges; look for an edge between the vertices before one is made";
    M3 WrongSides { record: Record, sides: usize, expected: usize } "wrong_sides"
        "a face (or, without faces, the cycle of this half-edge) has another number of sides."
        cause "an edge of the face was split and the face was not, or the input mixes triangles with other polygons"
        remedy "split the face by diagonals, or ask for the number that its faces have";
    M4 OnBorder { half_edge: usize, vertices: [usize; 2], lacks: Field } "on_border"
        "a half-edge has no twin, or bounds no face."
        cause "the surface has a hole or a rim, or two faces at an edge were not joined as twins"
        remedy "fill the hole, join the faces, or ask for the `borders` that there are instead";
    M5 WrongComponents { found: usize, expected: usize } "wrong_components"
        "there are more or fewer components with an edge."
        cause "parts that should meet have vertices of their own where they touch, or loose parts were left behind"
        remedy "merge the vertices that coincide, or delete the loose parts";
    M6 WrongBorders { found: usize, expected: usize } "wrong_borders"
        "there are more or fewer border loops."
        cause "faces are missing, or neighbouring faces were not joined as twins"
        remedy "fill the holes, or join the faces";
    M7 WrongGenus { found: usize, expected: usize } "wrong_genus"
        "there are more or fewer handles."
        cause "faces are missing on both sides of a tunnel, a small handle was left by a reconstruction, or vertices were merged across a gap"
        remedy "cut the handle and close both ends, or ask for the genus that the surface has";
    M8 KeptInside { vertex: usize, half_edge: usize, border: usize } "kept_inside"
        "a vertex keeps a half-edge that has twin and face, and another one that leaves it lacks one of them."
        cause "a face was removed, or added beside the border, and the half-edge kept by its vertices was not chosen again"
        remedy "after a change along the border, let each vertex there keep the half-edge of the border that leaves it";
    G1 NotFinite { vertex: usize } "not_finite"
        "a coordinate is NaN or infinite, or out of the range of the exact predicates."
        cause "a coordinate was missing in the input, or a projection or a division failed"
        remedy "drop or repair such points before the map is built";
    G1 ZeroLength { half_edge: usize } "zero_length"
        "both ends of an edge lie at the same point."
        cause "points of the input were repeated, or rounded to the same coordinates"
        remedy "merge the two vertices, which contracts the edge";
    G1 BendNotFinite { half_edge: usize, bend: usize } "bend_not_finite"
        "a coordinate of a bend is NaN or infinite, or out of the range of the exact predicates."
        cause "a coordinate was missing in the input, or a projection or a division failed"
        remedy "drop the bend, or repair its coordinates";
    G1 SegmentZeroLength { half_edge: usize, segment: usize } "segment_zero_length"
        "two consecutive points of an edge with bends are the same."
        cause "a point of the line was repeated, or rounded to the same coordinates"
        remedy "drop the repeated point";
    G2 OutOfOrder { vertex: usize, half_edge: usize, found: usize } "out_of_order"
        "`next` is not the next half-edge clockwise at the target."
        cause "the half-edges were sorted counter-clockwise, or by rounded angles, or a vertex was moved across an edge"
        remedy "sort the half-edges around each vertex by exact predicates, and link them clockwise";
    G3 OuterClockwise { boundary: Record } "outer_clockwise"
        "an outer cycle turns clockwise."
        cause "the outside of a component was entered as the outer boundary of a face, or the y-axis points down"
        remedy "enter it as an inner boundary component of the face around it; mirror the coordinates if the y-axis points down";
    G3 InnerCounterClockwise { boundary: Record } "inner_counter_clockwise"
        "an inner cycle turns counter-clockwise."
        cause "the outer boundary of a face was entered as a hole, or the y-axis points down"
        remedy "enter it as the outer boundary component of the face inside it; mirror the coordinates if the y-axis points down";
    G4 Cross { first: usize, second: usize } "cross"
        "two edges cross."
        cause "the input was not noded, or a vertex was moved across an edge"
        remedy "split both edges where they cross (`geometry::noding`, or `Builder` with a snap size)";
    G4 Touch { vertex: usize, half_edge: usize } "touch"
        "a vertex lies inside an edge."
        cause "borders of neighbouring polygons do not have the same vertices (a T-junction)"
        remedy "split the edge at the vertex (`geometry::noding`, or `Builder` with a snap size)";
    G4 Overlap { first: usize, second: usize } "overlap"
        "two edges have more than a point in common."
        cause "a border was drawn twice, with other vertices"
        remedy "split both edges at the vertices of the other, and merge the parts that coincide";
    G4 SamePlace { first: usize, second: usize } "same_place"
        "two vertices lie at the same point."
        cause "points were not merged by their coordinates"
        remedy "merge the vertices, and link their half-edges into one rotation";
    G4 SegmentsCross { first: usize, first_segment: usize, second: usize, second_segment: usize } "segments_cross"
        "two segments cross, of edges of which one has bends, or of one edge."
        cause "lines were not noded, or were simplified one by one, or a line crosses itself"
        remedy "split both edges where they cross, or restore the bends that keep them apart";
    G4 VertexInSegment { vertex: usize, half_edge: usize, segment: usize } "vertex_in_segment"
        "a vertex lies inside a segment of an edge with bends."
        cause "an edge was not split where another one ends"
        remedy "split the edge at the vertex";
    G4 BendInSegment { half_edge: usize, bend: usize, other: usize, segment: usize } "bend_in_segment"
        "a bend lies inside a segment of another edge, or of its own."
        cause "lines that touch were not noded"
        remedy "make the bend a vertex, and split the other edge there";
    G4 SegmentsOverlap { first: usize, first_segment: usize, second: usize, second_segment: usize } "segments_overlap"
        "two segments have more than a point in common, of edges of which one has bends, or of one edge."
        cause "a border was drawn twice, or a line turns back along itself"
        remedy "split both edges at the points of the other, and merge the parts that coincide";
    G4 BendAtVertex { half_edge: usize, bend: usize, vertex: usize } "bend_at_vertex"
        "a bend lies at a vertex, where its edge does not end."
        cause "an edge was not split where it passes through a vertex"
        remedy "split the edge at the vertex";
    G4 BendsAtSamePlace { first: usize, first_bend: usize, second: usize, second_bend: usize } "bends_at_same_place"
        "two bends, of two edges or of one, lie at the same point."
        cause "lines that meet were not noded there"
        remedy "make the point a vertex, and split the edges there";
    G5 WrongFace { boundary: Record, face: usize, found: Link } "wrong_face"
        "an inner boundary component lies in another face than the one that lists it, or in none."
        cause "a hole was assigned by its bounding box or by an inexact test, or stayed behind when its face was split"
        remedy "locate a point of the hole by exact predicates, and move the hole to that face";
    G5 Unlisted { vertex: usize, face: usize } "unlisted"
        "a component without inner boundary component lies in a face, not outside everything."
        cause "a component that lies in a face was taken for one that lies outside everything"
        remedy "list its outside in that face";
}

impl Violation {
    /// The records that are involved, the one at fault first; two at the most, none where the whole structure is meant.
    #[must_use]
    pub const fn records(&self) -> [Option<Record>; 2] {
        use Record::{Boundary as B, Face as F, HalfEdge as H, Vertex as X};
        use Violation as V;
        match *self {
            V::Nil { record, .. } | V::Dangling { record, .. } | V::WrongSides { record, .. } => [Some(record), None],
            V::TwinIsSelf { half_edge }
            | V::CycleNotListed { half_edge }
            | V::OnBorder { half_edge, .. }
            | V::BendNotFinite { half_edge, .. }
            | V::SegmentZeroLength { half_edge, .. }
            | V::ZeroLength { half_edge } => [Some(H(half_edge)), None],
            V::LoopEdge { half_edge, vertex } | V::BendAtVertex { half_edge, vertex, .. } => {
                [Some(H(half_edge)), Some(X(vertex))]
            }
            V::TwinNotMutual { half_edge, twin, .. } => [Some(H(half_edge)), Some(H(twin))],
            V::PrevOfNext { half_edge, next, .. }
            | V::Target { half_edge, next, .. }
            | V::BoundaryChanges { half_edge, next, .. }
            | V::FaceChanges { half_edge, next, .. } => [Some(H(half_edge)), Some(H(next))],
            V::NextOfPrev { half_edge, prev, .. } => [Some(H(half_edge)), Some(H(prev))],
            V::NextShared { first, second, .. }
            | V::ParallelEdges { first, second, .. }
            | V::Cross { first, second }
            | V::Overlap { first, second }
            | V::SegmentsCross { first, second, .. }
            | V::SegmentsOverlap { first, second, .. }
            | V::BendsAtSamePlace { first, second, .. }
            | V::BendInSegment { half_edge: first, other: second, .. } => [Some(H(first)), Some(H(second))],
            V::NotLeaving { vertex, half_edge, .. }
            | V::SplitRotation { vertex, half_edge, .. }
            | V::OutOfOrder { vertex, half_edge, .. }
            | V::VertexInSegment { vertex, half_edge, .. }
            | V::KeptInside { vertex, half_edge, .. }
            | V::Touch { vertex, half_edge } => [Some(X(vertex)), Some(H(half_edge))],
            V::StartElsewhere { boundary, half_edge, .. } => [Some(B(boundary)), Some(H(half_edge))],
            V::SecondCycle { boundary, .. } | V::WrongPlace { boundary, .. } | V::NotListed { boundary, .. } => {
                [Some(B(boundary)), None]
            }
            V::OuterClockwise { boundary } | V::InnerCounterClockwise { boundary } => [Some(boundary), None],
            V::ListedElsewhere { face, half_edge, .. } => [Some(F(face)), Some(H(half_edge))],
            V::IsolatedUnclaimed { vertex }
            | V::NoOutside { vertex }
            | V::TwoOutsides { vertex, .. }
            | V::Genus { vertex, .. }
            | V::NoSuchSurface { vertex, .. }
            | V::UnusedVertex { vertex }
            | V::NotFinite { vertex } => [Some(X(vertex)), None],
            V::IsolatedTwice { vertex, second, .. } => [Some(X(vertex)), Some(second)],
            V::StartsAtConnected { record, vertex } => [Some(record), Some(X(vertex))],
            V::IsolatedMismatch { vertex, boundary, .. } | V::ConnectedNamesBoundary { vertex, boundary } => {
                [Some(X(vertex)), Some(B(boundary))]
            }
            V::SecondUnboundedFace { first, second } => [Some(F(second)), Some(F(first))],
            V::NoOuter { face } | V::ListTooLong { face, .. } => [Some(F(face)), None],
            V::OuterIsVertex { face, boundary } => [Some(F(face)), Some(B(boundary))],
            V::ListedTwice { record, face } => [Some(record), Some(F(face))],
            V::ListedByOther { boundary, face, .. } => [Some(B(boundary)), Some(F(face))],
            V::WrongFace { boundary, face, .. } => [Some(boundary), Some(F(face))],
            V::NestedInItself { vertex, face } | V::Unlisted { vertex, face } => [Some(X(vertex)), Some(F(face))],
            V::SamePlace { first, second } => [Some(X(first)), Some(X(second))],
            V::NoUnboundedFace
            | V::TooManyEdges { .. }
            | V::TooManyFaces { .. }
            | V::WrongComponents { .. }
            | V::WrongBorders { .. }
            | V::WrongGenus { .. } => [None, None],
        }
    }
}
