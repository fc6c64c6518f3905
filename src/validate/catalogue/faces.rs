//! B1 … F2: boundary components and faces.

macro_rules! faces_rules {
    ($define:ident $($before:tt)*) => {
        $crate::validate::catalogue::whole::whole_rules! {
            $define
            $($before)*
            /// Without records for boundary components: the face is constant along `next`, and a face lists only half-edges of its
            /// own.
            ///
            /// ```text
            /// ┌──► 4 ──► 4 ──► 4 ──┐ start of 4
            /// └────────────────────┘
            /// ```
            B1 "cycle" counts "half-edge" "half-edges"
                "the boundary component is constant along `next`, its start is on its own cycle, and it has one cycle"
                in "src/validate/rules/faces" broken by "tests/validate/violations" "b1_a_boundary_component_has_a_second_cycle"
            {
                BoundaryChanges { half_edge: half_edge, next: half_edge, boundary: boundary_link, found: boundary_link } "boundary_changes"
                    says "half-edge {half_edge} belongs to boundary component {boundary}, its next {next} to {found}: one cycle belongs to two boundary components"
                    cause "a cycle was split or joined, and its half-edges were not all relabelled"
                    remedy "after `next` has changed, walk the new cycle and label each half-edge of it";
                StartElsewhere { boundary: boundary, half_edge: half_edge, found: boundary_link } "start_elsewhere"
                    says "boundary component {boundary} starts at half-edge {half_edge}, which belongs to {found}: a walk along it is a walk along another one"
                    cause "the half-edge at which it started went to another cycle"
                    remedy "when a half-edge leaves a cycle, let the boundary component start at one that stays";
                SecondCycle { boundary: boundary, cycle: number, half_edges: number } "second_cycle"
                    says "boundary component {boundary} has {named}, but the cycle of its start has {cycle}: the others lie on a cycle at which no boundary component starts"
                    with |names| { named = Number(half_edges as u64, "half-edge", "half-edges") }
                    cause "a cycle was split in two, and the second one got no boundary component of its own"
                    remedy "create a boundary component for the second cycle, label its half-edges, and list it in a face";
                FaceChanges { half_edge: half_edge, next: half_edge, face: face_link, found: face_link } "face_changes"
                    says "half-edge {half_edge} bounds face {face}, its next {next} bounds {found}: the face changes along one cycle"
                    cause "a face was split or merged, and its half-edges were not all relabelled"
                    remedy "after `next` has changed, walk the new cycle and label each half-edge of it";
                ListedElsewhere { face: face, half_edge: half_edge, found: face_link } "listed_elsewhere"
                    says "face {face} lists half-edge {half_edge}, which bounds face {found}: a walk around the one is a walk around the other"
                    cause "the half-edge that the face kept went to another face"
                    remedy "let each face keep a half-edge that names it";
            }
            /// Without records for boundary components, the list entries of the faces take their place.
            ///
            /// ```text
            /// ·v    isolated(v) = 7 ◄──► start(7) = v
            /// ```
            B2 "isolated" counts "vertex" "vertices"
                "a vertex has no half-edge if and only if exactly one boundary component starts at it, and they name each other"
                in "src/validate/rules/faces" broken by "tests/validate/violations" "b2_nothing_starts_at_an_isolated_vertex"
            {
                IsolatedUnclaimed { vertex: vertex } "isolated_unclaimed"
                    says "no half-edge leaves vertex {vertex} and no boundary component starts at it: no walk over the faces reaches it"
                    cause "the last edge at the vertex was removed and the vertex was kept, or the input has points that no edge uses"
                    remedy "list the vertex as an inner boundary component of the face in which it lies, or remove it";
                IsolatedTwice { vertex: vertex, second: record, first: record } "isolated_twice"
                    says "{first} and {second} both start at isolated vertex {vertex}, so the vertex lies in two places at once"
                    cause "an isolated vertex was added to a second face and not taken out of the first"
                    remedy "move the one boundary component instead of creating another";
                StartsAtConnected { record: record, vertex: vertex } "starts_at_connected"
                    says "{record} starts at vertex {vertex} as if it were isolated, but half-edges leave it"
                    cause "an edge was added at an isolated vertex, and the boundary component that the vertex was is still there"
                    remedy "retire that boundary component when the vertex gets its first edge";
                IsolatedMismatch { vertex: vertex, boundary: boundary, found: boundary_link } "isolated_mismatch"
                    says "boundary component {boundary} starts at isolated vertex {vertex}, which names {found} instead: its face is not determined"
                    cause "the boundary component was replaced and the link of the vertex was not"
                    remedy "write both links in one place";
                ConnectedNamesBoundary { vertex: vertex, boundary: boundary } "connected_names_boundary"
                    says "vertex {vertex} names boundary component {boundary} as if it were isolated, but half-edges leave it"
                    cause "the link was not cleared when the vertex got its first edge"
                    remedy "set it to nil as soon as a half-edge leaves the vertex";
            }
            /// ```text
            /// face 2 ── outer ──► component 5, a cycle
            /// face 0 ── outer ──► nil: the unbounded face, and no other
            /// ```
            F1 "outer" counts "face" "faces"
                "a bounded face has exactly one outer boundary component, a cycle; the one unbounded face has none"
                in "src/validate/rules/faces" broken by "tests/validate/violations" "f1_no_face_is_unbounded_or_two_are"
            {
                NoUnboundedFace "no_unbounded_face"
                    says "every face has an outer boundary component, but one face of a plane is unbounded and has none"
                    cause "a closed mesh was expected to lie in the plane, or the outside has no face record"
                    remedy "use `Expectation::surface` for a mesh, or leave `Part::UnboundedFace` out of `View::parts` where the outside has no record";
                SecondUnboundedFace { second: face, first: face } "second_unbounded_face"
                    says "faces {first} and {second} both have no outer boundary component, but only one face of a plane is unbounded"
                    cause "a face was created and its outer boundary component was not set, or two maps were put together with the unbounded face of each"
                    remedy "set the outer boundary component (`outer`, or `outer_half_edge` without boundary component records), or merge the unbounded faces";
                NoOuter { face: face } "no_outer"
                    says "face {face} has no outer boundary component, but every face of this structure needs one: `outer` (or, without boundary component records, `outer_half_edge`) is nil"
                    cause "a face was created and its outer boundary component was not set, or a face that is gone was not retired"
                    remedy "set the outer boundary component (`outer`, or `outer_half_edge` without boundary component records), or retire the face";
                OuterIsVertex { face: face, boundary: boundary } "outer_is_vertex"
                    says "the outer boundary component {boundary} of face {face} is an isolated vertex, which encloses nothing"
                    cause "an isolated vertex was entered as outer instead of inner"
                    remedy "list it as an inner boundary component of the face in which it lies";
            }
            /// Without records for boundary components: each cycle with a face is listed exactly once.
            ///
            /// ```text
            /// face 2 ── outer ───► component 5 ── face ──► 2, place: outer
            ///        └─ inner[0] ► component 8 ── face ──► 2, place: inner 0
            /// ```
            F2 "listed" counts "boundary component" "boundary components"
                "every boundary component is listed exactly once, by the face it names, at the place it says"
                in "src/validate/rules/faces" broken by "tests/validate/violations" "f2_a_boundary_component_is_not_listed"
            {
                NotListed { boundary: boundary, face: face_link } "not_listed"
                    says "boundary component {boundary} names face {face}, but no face lists it: a walk over the faces never reaches it"
                    cause "it was created, or moved, and not entered in the list of its face"
                    remedy "enter it in the list of the face that it names";
                CycleNotListed { half_edge: half_edge } "cycle_not_listed"
                    says "no face lists the cycle of half-edge {half_edge}: a walk over the faces never reaches it"
                    cause "a face has a hole that it does not list, or keeps no half-edge of its outer cycle"
                    remedy "list a half-edge of each cycle in its face";
                ListedTwice { record: record, face: face } "listed_twice"
                    says "face {face} lists {record}, which was listed before: a walk over the faces reaches it twice"
                    cause "it was moved to another face, and the entry in the first one was left behind"
                    remedy "take the old entry out when the new one is made";
                ListedByOther { boundary: boundary, face: face, found: face_link } "listed_by_other"
                    says "face {face} lists boundary component {boundary}, which names face {found}: the two directions disagree"
                    cause "it was moved to another face, and only one of the two links was written"
                    remedy "write the link to the face and the entry of the list in one place";
                WrongPlace { boundary: boundary, place: place, listed: list_place } "wrong_place"
                    says "boundary component {boundary} says that it is {place}, but its face lists it as {listed}: to remove it would remove another one"
                    cause "an entry was removed by moving the last one into its place, and the one moved was not told its new place"
                    remedy "update the place of the entry that is moved; if there are no places, leave `Part::Places` out of `View::parts`";
            }
        }
    };
}

pub(in crate::validate) use faces_rules;
