//! M1 … M8: the optional rules.

macro_rules! mesh_rules {
    ($define:ident $($before:tt)*) => {
        $crate::validate::catalogue::drawing::drawing_rules! {
            $define
            $($before)*
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
        }
    };
}

pub(in crate::validate) use mesh_rules;
