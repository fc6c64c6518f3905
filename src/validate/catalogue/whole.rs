//! T1 … T4: containment and Euler's formula.

macro_rules! whole_rules {
    ($define:ident $($before:tt)*) => {
        $crate::validate::catalogue::mesh::mesh_rules! {
            $define
            $($before)*
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
        }
    };
}

pub(in crate::validate) use whole_rules;
