//! G1 … G5: coordinates.

macro_rules! drawing_rules {
    ($define:ident $($before:tt)*) => {
        $define! {
            $($before)*
            /// Also refuses coordinates outside the range in which the predicates are exact. For an edge with bends,
            /// the bends and the segments between them are checked.
            G1 "finite" counts "vertex" "vertices"
                "coordinates are finite, and no edge has zero length"
                in "crates/map/src/drawing/finite" broken by "crates/map/tests/map/drawing/embeddings" "g1_a_coordinate_that_is_not_finite"
            {
                NotFinite { vertex: vertex } "not_finite"
                    says "vertex {vertex} has a coordinate that is not finite, or out of range"
                    cause "a coordinate was missing in the input, or a projection or a division failed"
                    remedy "drop or repair such points before the map is built";
                ZeroLength { half_edge: half_edge } "zero_length"
                    says "half-edge {half_edge} starts and ends at the same point: it has no direction"
                    cause "points of the input were repeated, or rounded to the same coordinates"
                    remedy "merge the two vertices, which contracts the edge";
                BendNotFinite { half_edge: half_edge, bend: number } "bend_not_finite"
                    says "bend {bend} of half-edge {half_edge} has a coordinate that is not finite, or out of range"
                    cause "a coordinate was missing in the input, or a projection or a division failed"
                    remedy "drop the bend, or repair its coordinates";
                SegmentZeroLength { half_edge: half_edge, segment: number } "segment_zero_length"
                    says "segment {segment} of half-edge {half_edge} starts and ends at the same point: it has no direction"
                    cause "a point of the line was repeated, or rounded to the same coordinates"
                    remedy "drop the repeated point";
            }
            /// ```text
            ///    b   c
            ///     \ /     a, b, c, d follow one another clockwise, by `next∘twin` and by their angles
            /// a ── v
            ///       \
            ///        d
            /// ```
            G2 "angles" counts "vertex" "vertices"
                "half-edges around a vertex are in angular order"
                in "crates/map/src/drawing/angles" broken by "crates/map/tests/map/drawing/embeddings" "g2_two_leaves_of_a_star_have_changed_places"
            {
                OutOfOrder { vertex: vertex, half_edge: half_edge, found: half_edge } "out_of_order"
                    says "at vertex {vertex}, half-edge {found} follows half-edge {half_edge} in the rotation, but another lies between: the coordinates and the links disagree"
                    cause "the half-edges were sorted counter-clockwise, or by rounded angles, or a vertex was moved across an edge"
                    remedy "sort the half-edges around each vertex by exact predicates, and link them clockwise";
            }
            /// ```text
            /// ┌───◄───┐
            /// │ ┌─►─┐ │    the face is to the left of both cycles
            /// ▼ ▲   ▼ ▲
            /// │ └─◄─┘ │
            /// └───►───┘
            /// ```
            G3 "winding" counts "cycle" "cycles"
                "outer cycles turn counter-clockwise, inner ones clockwise"
                in "crates/map/src/drawing/winding" broken by "crates/map/tests/map/drawing/embeddings" "g3_a_square_seen_in_a_mirror"
            {
                OuterClockwise { boundary: outer } "outer_clockwise"
                    says "{boundary} turns clockwise, so its face would lie outside it"
                    cause "the outside of a component was entered as the outer boundary of a face, or the y-axis points down"
                    remedy "enter it as an inner boundary component of the face around it; mirror the coordinates if the y-axis points down";
                InnerCounterClockwise { boundary: inner } "inner_counter_clockwise"
                    says "{boundary} turns counter-clockwise, so its face would lie inside it"
                    cause "the outer boundary of a face was entered as a hole, or the y-axis points down"
                    remedy "enter it as the outer boundary component of the face inside it; mirror the coordinates if the y-axis points down";
            }
            /// ```text
            /// \ /        |              ______
            ///  X         |         ====/======      o o
            /// / \    ----+----        /
            /// ```
            ///
            /// A bend is not an endpoint: edges do not meet there, and an edge does not pass through its own bends.
            G4 "disjoint" counts "edge" "edges"
                "edges meet only at shared endpoints"
                in "crates/map/src/drawing/disjoint" broken by "crates/map/tests/map/drawing/embeddings" "g4_a_square_twisted_into_a_bow_tie"
            {
                Cross { first: half_edge, second: half_edge } "cross"
                    says "half-edges {first} and {second} cross where no vertex is: the map is not plane"
                    cause "the input was not noded, or a vertex was moved across an edge"
                    remedy "split both edges where they cross (`geometry::noding`, or `Builder` with a snap size)";
                Touch { vertex: vertex, half_edge: half_edge } "touch"
                    says "vertex {vertex} lies inside half-edge {half_edge}, which does not end there"
                    cause "borders of neighbouring polygons do not have the same vertices (a T-junction)"
                    remedy "split the edge at the vertex (`geometry::noding`, or `Builder` with a snap size)";
                Overlap { first: half_edge, second: half_edge } "overlap"
                    says "half-edges {first} and {second} overlap: they have more than a point in common"
                    cause "a border was drawn twice, with other vertices"
                    remedy "split both edges at the vertices of the other, and merge the parts that coincide";
                SamePlace { first: vertex, second: vertex } "same_place"
                    says "vertices {first} and {second} lie at the same point but are not joined"
                    cause "points were not merged by their coordinates"
                    remedy "merge the vertices, and link their half-edges into one rotation";
                SegmentsCross { first: half_edge, first_segment: number, second: half_edge, second_segment: number } "segments_cross"
                    says "segment {first_segment} of half-edge {first} and segment {second_segment} of half-edge {second} cross where no vertex is: the map is not plane"
                    cause "lines were not noded, or were simplified one by one, or a line crosses itself"
                    remedy "split both edges where they cross, or restore the bends that keep them apart";
                VertexInSegment { vertex: vertex, half_edge: half_edge, segment: number } "vertex_in_segment"
                    says "vertex {vertex} lies inside segment {segment} of half-edge {half_edge}, which does not end there"
                    cause "an edge was not split where another one ends"
                    remedy "split the edge at the vertex";
                BendInSegment { half_edge: half_edge, bend: number, other: half_edge, segment: number } "bend_in_segment"
                    says "bend {bend} of half-edge {half_edge} lies inside segment {segment} of half-edge {other}"
                    cause "lines that touch were not noded"
                    remedy "make the bend a vertex, and split the other edge there";
                SegmentsOverlap { first: half_edge, first_segment: number, second: half_edge, second_segment: number } "segments_overlap"
                    says "segment {first_segment} of half-edge {first} and segment {second_segment} of half-edge {second} overlap: they have more than a point in common"
                    cause "a border was drawn twice, or a line turns back along itself"
                    remedy "split both edges at the points of the other, and merge the parts that coincide";
                BendAtVertex { half_edge: half_edge, bend: number, vertex: vertex } "bend_at_vertex"
                    says "bend {bend} of half-edge {half_edge} lies at vertex {vertex}, where the half-edge does not end"
                    cause "an edge was not split where it passes through a vertex"
                    remedy "split the edge at the vertex";
                BendsAtSamePlace { first: half_edge, first_bend: number, second: half_edge, second_bend: number } "bends_at_same_place"
                    says "bend {first_bend} of half-edge {first} and bend {second_bend} of half-edge {second} lie at the same point, where no vertex is"
                    cause "lines that meet were not noded there"
                    remedy "make the point a vertex, and split the edges there";
            }
            /// ```text
            /// ┌─────────┐
            /// │    f    │    going straight down from the lowest vertex v of a component, the first edge
            /// │   v·    │    bounds the face in which the component lies
            /// │    :    │
            /// └────┴────┘
            /// ```
            G5 "inside" counts "boundary component" "boundary components"
                "each inner boundary component lies in the face that lists it, and a component that no face lists lies in no face"
                in "crates/map/src/drawing/inside" broken by "crates/map/tests/map/drawing/embeddings" "g5_an_island_listed_by_the_face_next_door"
            {
                WrongFace { boundary: inner, face: face, found: face_link } "wrong_face"
                    says "{boundary} is listed by face {face}, but lies in {place}"
                    with |names| { place = found.map_or(Place::Nowhere, |face| Place::In(names.face(face))) }
                    cause "a hole was assigned by its bounding box or by an inexact test, or stayed behind when its face was split"
                    remedy "locate a point of the hole by exact predicates, and move the hole to that face";
                Unlisted { vertex: vertex, face: face } "unlisted"
                    says "the component of vertex {vertex} lies in face {face}, which does not list it"
                    cause "a component that lies in a face was taken for one that lies outside everything"
                    remedy "list its outside in that face";
            }
        }
    };
}

pub(in crate::validate) use drawing_rules;
