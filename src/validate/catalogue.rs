//! Every rule with its violations: the table from which [`Rule`](super::Rule) and [`Violation`](super::Violation) are generated.
//!
//! A rule is a row: documentation, id and name, the noun for the checked records, its statement, the file of its check, and the test
//! that breaks only it. Its violations follow: variant and fields, kind, sentence, usual cause and remedy. The kinds of fields are
//! listed in `violation.rs`; `with` names further words of the sentence.

/// Passes all rows, in the order of the rules, to the macro with this name.
macro_rules! catalogue {
    ($define:ident) => { $define! {
    // R1 … V2: links, and the combinatorial map that they make.
    /// At an open boundary twin or face may be nil, but not both. A list is not read to the end if all lists together have more
    /// entries than twice the number of boundary components plus 16; this also breaks the rule.
    ///
    /// ```text
    /// half-edge 3 ── next ──► 7     ok if slot 7 holds a half-edge
    ///                next ──► nil   a cycle that ends
    ///                next ──► 99    past the end, or a retired record
    /// ```
    R1 "live" counts "link" "links"
        "every link that a record needs is there and leads to a live record, and no face lists far more boundary components than there are"
        in "src/validate/rules/live" broken by "tests/validate/violations" "r1_a_link_dangles"
    {
        Nil { record: record, field: field } "nil"
            says "the {field} of {record} is nil, but the record needs one"
            cause "a record was created and not linked in, or an operation returned early and left it unfinished"
            remedy "set the link, or retire the record; if the structure has no such links at all, leave the part out of `View::parts`";
        Dangling { record: record, field: field, value: dangling } "dangling"
            says "the {field} of {record} {value}: following it reads something else"
            cause "a record was removed, and a link to it was left behind, or indices were not adjusted when records were moved"
            remedy "find what links to a record before it is removed, and use generational keys, so that a stale key is an error; if all such links dangle, implement the number of slots (`face_slots`, `boundary_slots`)";
        ListTooLong { face: face, claimed: number } "list_too_long"
            says "face {face} claims {claimed} inner boundary components, far more than there can be: the lists were not read to the end"
            cause "entries are appended to the list of a face and never taken out, or the length is not initialised"
            remedy "list each boundary component once, and take its entry out where it moves or goes";
    }
    /// ```text
    ///      h
    /// ·────────►·
    /// ·◄────────·
    ///   twin(h)
    /// ```
    L1 "twin" counts "half-edge" "half-edges"
        "`twin(twin(h)) = h` and `twin(h) ≠ h`"
        in "src/validate/rules/links" broken by "tests/validate/violations" "l1_the_twins_twin_is_another"
    {
        TwinIsSelf { half_edge: half_edge } "twin_is_self"
            says "half-edge {half_edge} is its own twin, so its edge has one side only"
            cause "half-edges were created one by one instead of in pairs, or the twin of an open boundary was set to the half-edge itself"
            remedy "create both half-edges of an edge together; at an open boundary let the twin be nil, and validate with `Expectation::open`";
        TwinNotMutual { half_edge: half_edge, twin: half_edge, found: half_edge_link } "twin_not_mutual"
            says "half-edge {half_edge} has twin {twin}, whose twin is {found}: the two sides disagree about their edge"
            cause "three or more faces share an edge (a non-manifold mesh), so a later pair took over a half-edge of an earlier one, or only one direction was written"
            remedy "write both directions in one place; split the edge where more than two faces meet in it";
    }
    /// Without `prev`: no two half-edges have the same next.
    ///
    /// ```text
    ///   prev(h)        h         next(h)
    /// ·─────────►·──────────►·───────────►·
    /// ```
    L2 "next/prev" counts "half-edge" "half-edges"
        "`prev(next(h)) = h` and `next(prev(h)) = h`"
        in "src/validate/rules/links" broken by "tests/validate/violations" "l2_next_and_prev_disagree"
    {
        PrevOfNext { half_edge: half_edge, next: half_edge, found: half_edge } "prev_of_next"
            says "half-edge {half_edge} has next {next}, whose prev is {found}: a walk back along the cycle leaves it"
            cause "`next` was changed and `prev` was not"
            remedy "write `next(a) = b` and `prev(b) = a` by one function, and nowhere else";
        NextOfPrev { half_edge: half_edge, prev: half_edge, found: half_edge } "next_of_prev"
            says "half-edge {half_edge} has prev {prev}, whose next is {found}: a walk along the cycle leaves it"
            cause "`prev` was changed and `next` was not"
            remedy "write `next(a) = b` and `prev(b) = a` by one function, and nowhere else";
        NextShared { first: half_edge, second: half_edge, next: half_edge } "next_shared"
            says "half-edges {first} and {second} both have next {next}, so one of their cycles never closes"
            cause "a half-edge was inserted into a cycle, and the one that it displaced still has the old next"
            remedy "when a half-edge is inserted, relink the one before it too";
    }
    /// ```text
    ///      h          next(h)
    /// ·──────────►v────────────►·     both start at v, the target of h
    /// ·◄──────────v
    ///    twin(h)
    /// ```
    L3 "target" counts "half-edge" "half-edges"
        "`origin(next(h)) = origin(twin(h))`"
        in "src/validate/rules/links" broken by "tests/validate/violations" "l3_the_next_half_edge_starts_elsewhere"
    {
        Target { half_edge: half_edge, next: half_edge, target: vertex, found: vertex } "target"
            says "half-edge {half_edge} ends at vertex {target}, but its next {next} starts at vertex {found}: the cycle jumps"
            cause "an origin was not updated when vertices were split or merged, or half-edges were linked around the wrong vertex"
            remedy "when a vertex goes, give all half-edges of its rotation their new origin; link only half-edges that meet";
    }
    /// ```text
    /// vertex 3 ── leaving ──► half-edge 8 ── origin ──► 3
    /// ```
    V1 "leaving" counts "vertex" "vertices"
        "the half-edge kept by a vertex leaves that vertex"
        in "src/validate/rules/links" broken by "tests/validate/violations" "v1_the_half_edge_of_a_vertex_leaves_another"
    {
        NotLeaving { vertex: vertex, half_edge: half_edge, origin: vertex } "not_leaving"
            says "vertex {vertex} keeps half-edge {half_edge}, which leaves vertex {origin}: its rotation is that of another vertex"
            cause "the half-edge that the vertex kept was moved to another vertex, or the vertex keeps one that arrives"
            remedy "after each change at a vertex let it keep a half-edge that leaves it; if it keeps one that arrives, answer with its twin";
    }
    /// ```text
    ///      \   |   /              \   |
    ///       \  |  /                \  |   ___
    /// ───────  v  ───────    ───────  v  ___   two fans that share a vertex: each is closed under
    ///       /  |  \                /  |        next∘twin, and neither reaches the other
    ///      /   |   \              /   |
    /// ```
    V2 "rotation" counts "vertex" "vertices"
        "the rotation of a vertex is all half-edges with that origin"
        in "src/validate/rules/links" broken by "tests/validate/violations" "v2_two_fans_share_a_vertex"
    {
        SplitRotation { vertex: vertex, half_edge: half_edge, reached: number, degree: number } "split_rotation"
            says "from half-edge {half_edge} the rotation of vertex {vertex} reaches {reached} of the {degree} half-edges that leave it: several fans share the vertex, and no walk around it reaches them all"
            cause "two fans of faces touch in one vertex (a non-manifold mesh), or vertices at the same place were merged without relinking their half-edges"
            remedy "give each fan a vertex of its own, or link the fans into one rotation";
    }
    // B1 … F2: boundary components and faces.
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
    // T1 … T4: containment and Euler's formula.
    /// At an open boundary, or where the unbounded face has no record, a component may have none.
    ///
    /// ```text
    /// ┌───────────────┐
    /// │  a   ┌─────┐  │    the unbounded face lists the outside of a,
    /// │      │  c  │  │    the face between them lists the outside of c
    /// │      └─────┘  │
    /// └───────────────┘
    /// ```
    T1 "outside" counts "component" "components"
        "each component has exactly one inner boundary component, its outside"
        in "src/validate/rules/whole" broken by "tests/validate/violations" "t1_a_component_has_two_outsides"
    {
        NoOutside { vertex: vertex } "no_outside"
            says "the component of vertex {vertex} has only outer boundary components, so it lies in no face at all"
            cause "each cycle was taken for the outer boundary of a face, also those that turn clockwise, or a closed mesh was expected to lie in the plane"
            remedy "list the outside of each component as an inner boundary component of the face in which it lies; use `Expectation::surface` for a mesh";
        TwoOutsides { vertex: vertex, first: record, second: record } "two_outsides"
            says "the component of vertex {vertex} has two inner boundary components, at {first} and at {second}: it would lie in two faces at once"
            cause "two components were joined by an edge, and both outsides were kept, or a face inside a component lists its boundary as inner"
            remedy "keep one outside when components are joined; a cycle around a bounded face is outer";
    }
    /// All other rules can hold while this one is broken.
    ///
    /// ```text
    /// unbounded face
    ///   └─ component a
    ///        └─ face of a ─ component c
    ///                         └─ face of c ─ …
    /// ```
    T2 "nesting" counts "component" "components"
        "containment is a tree rooted at the unbounded face"
        in "src/validate/rules/whole" broken by "tests/validate/violations" "t2_a_component_lies_inside_itself"
    {
        NestedInItself { vertex: vertex, face: face } "nested_in_itself"
            says "the component of vertex {vertex} lies in face {face}, which lies, through others, inside that component: no path leads from it out to the unbounded face"
            cause "a component was moved into a face that lies inside it"
            remedy "move it to a face that is reachable from the unbounded face without passing through the component";
    }
    /// ```text
    /// ·─────·
    /// │   ╱ │    V = 4, E = 5, three cycles: two triangles and the outside
    /// │ ╱   │    4 − 5 + 3 = 2, so g = 0
    /// ·─────·
    /// ```
    T3 "Euler" counts "component" "components"
        "per component `V − E + cycles = 2 − 2g`, with `g = 0` in the plane"
        in "src/validate/rules/whole" broken by "tests/validate/violations" "t3_a_component_has_a_handle"
    {
        Genus { vertex: vertex, vertices: number, edges: number, cycles: number, genus: number } "genus"
            says "the component of vertex {vertex} has V − E + cycles = {vertices} − {edges} + {cycles}, genus {genus}: it can only be drawn on a surface with {handles}, not in the plane"
            with |names| { handles = Number(genus as u64, "handle", "handles") }
            cause "edges cross, or half-edges are linked in the wrong order around a vertex, or the mesh has handles"
            remedy "node edges that cross, sort the half-edges around each vertex by angle, or validate with `Expectation::surface`";
        NoSuchSurface { vertex: vertex, vertices: number, edges: number, cycles: number } "no_such_surface"
            says "the component of vertex {vertex} has V − E + cycles = {vertices} − {edges} + {cycles}, which no orientable surface has"
            cause "the answers of the structure changed during the validation"
            remedy "do not change the structure while it is validated";
    }
    /// Follows from the other rules, and cross-checks the counting.
    T4 "bounds" counts "map" "maps"
        "a simple map with `V ≥ 3` has `E ≤ 3V − 6` and `F ≤ 2V − 4`"
        in "src/validate/rules/whole" broken by "tests/validate/violations" "t4_is_broken_with_t1_where_faces_are_counted_wrong"
    {
        TooManyEdges { vertices: number, edges: number } "too_many_edges"
            says "the map is simple and has {edges} edges on {vertices} vertices, more than 3V − 6 = {most}: it is not planar"
            with |names| { most = vertices.saturating_mul(3).saturating_sub(6) }
            cause "the answers of the structure changed during the validation"
            remedy "do not change the structure while it is validated";
        TooManyFaces { vertices: number, faces: number } "too_many_faces"
            says "the map is simple and has {faces} faces on {vertices} vertices, more than 2V − 4 = {most}: some face has no boundary of its own"
            with |names| { most = vertices.saturating_mul(2).saturating_sub(4) }
            cause "the answers of the structure changed during the validation"
            remedy "do not change the structure while it is validated";
    }
    // M1 … M8: the optional rules.
    /// Checked on request, by `no_unused_vertices`.
    ///
    /// ```text
    /// ·──────·
    /// │    ╱ │    ·v    no half-edge leaves v
    /// │  ╱   │
    /// ·──────·
    /// ```
    M1 "used" counts "vertex" "vertices"
        "some half-edge leaves every vertex"
        in "src/validate/rules/mesh" broken by "tests/validate/mesh_rules" "m1_a_vertex_is_unused"
    {
        UnusedVertex { vertex: vertex } "unused_vertex"
            says "no half-edge leaves vertex {vertex}: no edge and no face uses it"
            cause "faces were deleted and their vertices kept, or the vertex belongs to a line or a point of the input"
            remedy "delete the vertex, or do not ask for `no_unused_vertices`";
    }
    /// Checked on request, by `simple`. A face with two sides has parallel edges.
    ///
    /// ```text
    ///            e
    /// ┌───┐    ┌───┐
    /// │   v    u   v    the loop starts and ends at v; e and f both join u and v
    /// └───┘    └───┘
    ///            f
    /// ```
    M2 "simple" counts "edge" "edges"
        "no edge is a loop, and no two edges join the same vertices"
        in "src/validate/rules/mesh" broken by "tests/validate/mesh_rules" "m2_an_edge_is_a_loop_or_parallel_to_another"
    {
        LoopEdge { half_edge: half_edge, vertex: vertex } "loop_edge"
            says "half-edge {half_edge} starts and ends at vertex {vertex}: its edge is a loop"
            cause "an edge was contracted while another joined its ends, or a face lists a vertex twice in a row"
            remedy "delete the edge, or subdivide it; refuse to contract an edge whose ends have a neighbour in common that is not opposite to it";
        ParallelEdges { first: half_edge, second: half_edge, vertices: ends } "parallel_edges"
            says "half-edges {first} and {second} belong to two edges that both join vertices {vertices}: the ends do not tell which edge is meant"
            cause "two faces at an edge were not joined as twins, an edge was flipped onto one that was there, or a face has two sides"
            remedy "join the half-edges as twins, or subdivide one of the edges; look for an edge between the vertices before one is made";
    }
    /// Checked on request, by `sides` or `triangles`. The sides of a face are all half-edges that bound it, including its
    /// holes. The unbounded face may have any number. Without faces, each cycle of `next` counts as a face.
    ///
    /// ```text
    /// ·──────·
    /// │    ╱  ╲    a triangle and a quadrilateral
    /// │  ╱     ╲
    /// ·────·────·
    /// ```
    M3 "sides" counts "face" "faces"
        "every bounded face has the expected number of sides"
        in "src/validate/rules/mesh" broken by "tests/validate/mesh_rules" "m3_a_face_has_a_side_too_many"
    {
        WrongSides { record: sided, sides: number, expected: number } "wrong_sides"
            says "{record} has {found}, where {expected} are expected"
            with |names| { found = Number(sides as u64, "side", "sides") }
            cause "an edge of the face was split and the face was not, or the input mixes triangles with other polygons"
            remedy "split the face by diagonals, or ask for the number that its faces have";
    }
    /// Checked on request, by `closed`. With `open`, it names each half-edge at a border; without, R1 reports the missing
    /// links.
    ///
    /// ```text
    /// ·───►───·
    /// │  f   ╱     the half-edge of f has no twin, or its twin bounds no face
    /// │    ╱
    /// ·──·
    /// ```
    M4 "closed" counts "half-edge" "half-edges"
        "every half-edge has a twin and bounds a face"
        in "src/validate/rules/mesh" broken by "tests/validate/mesh_rules" "m4_a_mesh_has_a_border"
    {
        OnBorder { half_edge: half_edge, vertices: ends, lacks: field } "on_border"
            says "half-edge {half_edge}, from vertex {u} to vertex {v}, {lack}: the surface has a border there"
            with |names| { u = names.vertex(vertices[0]), v = names.vertex(vertices[1]), lack = if lacks == Field::Twin { "has no twin" } else { "bounds no face" } }
            cause "the surface has a hole or a rim, or two faces at an edge were not joined as twins"
            remedy "fill the hole, join the faces, or ask for the `borders` that there are instead";
    }
    /// Checked on request, by `components`. Isolated vertices do not count: M1 is about them.
    ///
    /// ```text
    /// ·───·     ·───·
    /// │ ╱       │ ╱      two components
    /// ·         ·
    /// ```
    M5 "connected" counts "component" "components"
        "there are as many components with an edge as expected"
        in "src/validate/rules/mesh" broken by "tests/validate/mesh_rules" "m5_there_is_a_second_component"
    {
        WrongComponents { found: number, expected: number } "wrong_components"
            says "the structure has {count} with an edge, where {expected} are expected"
            with |names| { count = Number(found as u64, "component", "components") }
            cause "parts that should meet have vertices of their own where they touch, or loose parts were left behind"
            remedy "merge the vertices that coincide, or delete the loose parts";
    }
    /// Checked on request, by `borders`. A border loop is a cycle of half-edges without face, or a cycle that the missing twins
    /// would form: both representations of a border yield the same number.
    ///
    /// ```text
    /// ┌─────────────┐
    /// │   ┌─────┐   │
    /// │   │     │   │    an annulus: two border loops
    /// │   └─────┘   │
    /// └─────────────┘
    /// ```
    M6 "borders" counts "component" "components"
        "there are as many border loops as expected"
        in "src/validate/rules/mesh" broken by "tests/validate/mesh_rules" "m6_there_is_a_second_border"
    {
        WrongBorders { found: number, expected: number } "wrong_borders"
            says "the structure has {count}, where {expected} are expected"
            with |names| { count = Number(found as u64, "border loop", "border loops") }
            cause "faces are missing, or neighbouring faces were not joined as twins"
            remedy "fill the holes, or join the faces";
    }
    /// Checked on request, by `genus`.
    ///
    /// ```text
    ///    ______
    ///  ╱  ____  ╲
    /// │  ╲____╱  │    a torus: genus 1
    ///  ╲ ______ ╱
    /// ```
    M7 "genus" counts "component" "components"
        "the genera of the components add up to the genus expected"
        in "src/validate/rules/mesh" broken by "tests/validate/mesh_rules" "m7_a_sphere_is_no_torus"
    {
        WrongGenus { found: number, expected: number } "wrong_genus"
            says "the components have genus {found} together, where {expected} is expected"
            cause "faces are missing on both sides of a tunnel, a small handle was left by a reconstruction, or vertices were merged across a gap"
            remedy "cut the handle and close both ends, or ask for the genus that the surface has";
    }
    /// Checked on request, by `border_kept`. Libraries that promise it recognise a border vertex by this half-edge. Not checked
    /// if vertices store no half-edge.
    ///
    /// ```text
    ///   f  ╱
    ///    ╱      a half-edge without face or twin leaves v: v keeps such a half-edge,
    /// ──v───    and none that bounds f
    /// ```
    M8 "kept" counts "vertex" "vertices"
        "if a half-edge without twin or face leaves a vertex, the half-edge kept by that vertex lacks a twin or a face"
        in "src/validate/rules/mesh" broken by "tests/validate/mesh_rules" "m8_a_border_vertex_keeps_an_inner_half_edge"
    {
        KeptInside { vertex: vertex, half_edge: half_edge, border: half_edge } "kept_inside"
            says "vertex {vertex} keeps half-edge {half_edge}, which is not on the border, where half-edge {border} leaves it along the border"
            cause "a face was removed, or added beside the border, and the half-edge kept by its vertices was not chosen again"
            remedy "after a change along the border, let each vertex there keep the half-edge of the border that leaves it";
    }
    // G1 … G5: coordinates.
    /// Also refuses coordinates outside the range in which the predicates are exact. For an edge with bends,
    /// the bends and the segments between them are checked.
    G1 "finite" counts "vertex" "vertices"
        "coordinates are finite, and no edge has zero length"
        in "crates/map/src/drawing/rules" broken by "crates/map/tests/map/drawing/embeddings" "g1_a_coordinate_that_is_not_finite"
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
        in "crates/map/src/drawing/rules" broken by "crates/map/tests/map/drawing/embeddings" "g2_two_leaves_of_a_star_have_changed_places"
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
        in "crates/map/src/drawing/rules" broken by "crates/map/tests/map/drawing/embeddings" "g3_a_square_seen_in_a_mirror"
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
        in "crates/map/src/drawing/rules" broken by "crates/map/tests/map/drawing/embeddings" "g4_a_square_twisted_into_a_bow_tie"
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
        in "crates/map/src/drawing/rules" broken by "crates/map/tests/map/drawing/embeddings" "g5_an_island_listed_by_the_face_next_door"
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
    } };
}

pub(super) use catalogue;
