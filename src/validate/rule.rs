//! The rules by name.

use core::fmt;

macro_rules! rules {
    ($($(#[doc = $more:literal])* $variant:ident $id:literal $name:literal counts $one:literal $many:literal
        $statement:literal in $file:literal broken by $tests:literal $test:literal;)*) => {
        /// A rule of the structure. The order is that in which they rely on one another: each rule makes sense once those
        /// before it hold.
        ///
        /// ```
        /// use twinedge::validate::Rule;
        /// assert_eq!(Rule::ALL.len(), 27);
        /// let rule = Rule::L1;
        /// assert_eq!((rule.id(), rule.name()), ("L1", "twin"));
        /// assert_eq!(rule.statement(), "`twin(twin(h)) = h` and `twin(h) ≠ h`");
        /// ```
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
        #[non_exhaustive]
        pub enum Rule {
            $(
                #[doc = concat!("**", $id, " ", $name, "**: ", $statement, ".\n")]
                $(#[doc = $more])*
                #[doc = concat!(
                    "\n\nChecked in `src/validate/rules/", $file, ".rs`; broken alone by `", $test,
                    "` in `tests/validate/", $tests, ".rs`."
                )]
                $variant,
            )*
        }

        impl Rule {
            /// All rules, in order.
            pub const ALL: &[Self] = &[$(Self::$variant),*];

            /// The id: `R1` … `G5`.
            #[must_use]
            pub const fn id(self) -> &'static str {
                match self { $(Self::$variant => $id,)* }
            }

            /// The name in one word or two.
            #[must_use]
            pub const fn name(self) -> &'static str {
                match self { $(Self::$variant => $name,)* }
            }

            /// The noun for so many of what the rule is checked on: `vertex`, `vertices`.
            #[must_use]
            pub const fn unit(self, count: u64) -> &'static str {
                match self { $(Self::$variant => if count == 1 { $one } else { $many },)* }
            }

            /// The rule in one sentence.
            #[must_use]
            pub const fn statement(self) -> &'static str {
                match self { $(Self::$variant => $statement,)* }
            }
        }
    };
}

rules! {
    /// At an open boundary twin or face may be nil, but not both. Lists with more than twice as many entries as there are boundary
    /// components, and 16, are not read to the end, and break the rule, too.
    ///
    /// ```text
    /// half-edge 3 ── next ──► 7     ok if slot 7 holds a half-edge
    ///                next ──► nil   a cycle that ends
    ///                next ──► 99    past the end, or a retired record
    /// ```
    ///
    /// In the [reference](mod@crate::validate::reference): `r1`.
    R1 "R1" "live" counts "link" "links"
        "every link that a record needs is there, and every link leads to a live record"
        in "live" broken by "violations" "r1_a_link_dangles";
    /// ```text
    ///      h
    /// ·────────►·
    /// ·◄────────·
    ///   twin(h)
    /// ```
    ///
    /// In the [reference](mod@crate::validate::reference): `l1`.
    L1 "L1" "twin" counts "half-edge" "half-edges"
        "`twin(twin(h)) = h` and `twin(h) ≠ h`"
        in "twin" broken by "violations" "l1_the_twins_twin_is_another";
    /// Without `prev`: no two half-edges have the same next.
    ///
    /// ```text
    ///   prev(h)        h         next(h)
    /// ·─────────►·──────────►·───────────►·
    /// ```
    ///
    /// In the [reference](mod@crate::validate::reference): `l2`.
    L2 "L2" "next/prev" counts "half-edge" "half-edges"
        "`prev(next(h)) = h` and `next(prev(h)) = h`"
        in "next_prev" broken by "violations" "l2_next_and_prev_disagree";
    /// ```text
    ///      h          next(h)
    /// ·──────────►v────────────►·     both start at v, the target of h
    /// ·◄──────────v
    ///    twin(h)
    /// ```
    ///
    /// In the [reference](mod@crate::validate::reference): `l3`.
    L3 "L3" "target" counts "half-edge" "half-edges"
        "`origin(next(h)) = origin(twin(h))`"
        in "target" broken by "violations" "l3_the_next_half_edge_starts_elsewhere";
    /// ```text
    /// vertex 3 ── leaving ──► half-edge 8 ── origin ──► 3
    /// ```
    ///
    /// In the [reference](mod@crate::validate::reference): `v1`.
    V1 "V1" "leaving" counts "vertex" "vertices"
        "the half-edge kept by a vertex leaves that vertex"
        in "leaving" broken by "violations" "v1_the_half_edge_of_a_vertex_leaves_another";
    /// ```text
    ///      \   |   /              \   |
    ///       \  |  /                \  |   ___
    /// ───────  v  ───────    ───────  v  ___   two fans that share a vertex: each is closed under
    ///       /  |  \                /  |        next∘twin, and neither reaches the other
    ///      /   |   \              /   |
    /// ```
    ///
    /// In the [reference](mod@crate::validate::reference): `v2`.
    V2 "V2" "rotation" counts "vertex" "vertices"
        "the rotation of a vertex is all half-edges with that origin"
        in "rotation" broken by "violations" "v2_two_fans_share_a_vertex";
    /// Without records for boundary components: the face is constant along `next`, and a face keeps half-edges of its own.
    ///
    /// ```text
    /// ┌──► 4 ──► 4 ──► 4 ──┐ start of 4
    /// └────────────────────┘
    /// ```
    ///
    /// In the [reference](mod@crate::validate::reference): `b1`.
    B1 "B1" "cycle" counts "half-edge" "half-edges"
        "the boundary component is constant along `next`, its start is on its own cycle, and it has one cycle"
        in "cycle" broken by "violations" "b1_a_boundary_component_has_a_second_cycle";
    /// Without records for boundary components, entries of the lists of the faces stand for them.
    ///
    /// ```text
    /// ·v    isolated(v) = 7 ◄──► start(7) = v
    /// ```
    ///
    /// In the [reference](mod@crate::validate::reference): `b2`.
    B2 "B2" "isolated" counts "vertex" "vertices"
        "a vertex has no half-edge if and only if exactly one boundary component starts at it, and they name each other"
        in "isolated" broken by "violations" "b2_nothing_starts_at_an_isolated_vertex";
    /// ```text
    /// face 2 ── outer ──► component 5, a cycle
    /// face 0 ── outer ──► nil: the unbounded face, and no other
    /// ```
    ///
    /// In the [reference](mod@crate::validate::reference): `f1`.
    F1 "F1" "outer" counts "face" "faces"
        "a bounded face has exactly one outer boundary component, a cycle; the one unbounded face has none"
        in "outer" broken by "violations" "f1_no_face_is_unbounded_or_two_are";
    /// Without records for boundary components: each cycle with a face is listed exactly once.
    ///
    /// ```text
    /// face 2 ── outer ───► component 5 ── face ──► 2, place: outer
    ///        └─ inner[0] ► component 8 ── face ──► 2, place: inner 0
    /// ```
    ///
    /// In the [reference](mod@crate::validate::reference): `f2`.
    F2 "F2" "listed" counts "boundary component" "boundary components"
        "every boundary component is listed exactly once, by the face it names, at the place it says"
        in "listed" broken by "violations" "f2_a_boundary_component_is_not_listed";
    /// At an open boundary, or where the unbounded face has no record, a component may have none.
    ///
    /// ```text
    /// ┌───────────────┐
    /// │  a   ┌─────┐  │    the unbounded face lists the outside of a,
    /// │      │  c  │  │    the face between them lists the outside of c
    /// │      └─────┘  │
    /// └───────────────┘
    /// ```
    ///
    /// In the [reference](mod@crate::validate::reference): `t1`.
    T1 "T1" "outside" counts "component" "components"
        "each component has exactly one inner boundary component, its outside"
        in "outside" broken by "violations" "t1_a_component_has_two_outsides";
    /// All other rules can hold while this one is broken.
    ///
    /// ```text
    /// unbounded face
    ///   └─ component a
    ///        └─ face of a ─ component c
    ///                         └─ face of c ─ …
    /// ```
    ///
    /// In the [reference](mod@crate::validate::reference): `t2`.
    T2 "T2" "nesting" counts "component" "components"
        "containment is a tree rooted at the unbounded face"
        in "nesting" broken by "violations" "t2_a_component_lies_inside_itself";
    /// ```text
    /// ·─────·
    /// │   ╱ │    V = 4, E = 5, three cycles: two triangles and the outside
    /// │ ╱   │    4 − 5 + 3 = 2, so g = 0
    /// ·─────·
    /// ```
    ///
    /// In the [reference](mod@crate::validate::reference): `t3`.
    T3 "T3" "Euler" counts "component" "components"
        "per component `V − E + cycles = 2 − 2g`, with `g = 0` in the plane"
        in "euler" broken by "violations" "t3_a_component_has_a_handle";
    /// It follows from the other rules, and checks the counting.
    ///
    /// In the [reference](mod@crate::validate::reference): `t4`.
    T4 "T4" "bounds" counts "map" "maps"
        "a simple map with `V ≥ 3` has `E ≤ 3V − 6` and `F ≤ 2V − 4`"
        in "bounds" broken by "violations" "t4_is_broken_with_t1_where_faces_are_counted_wrong";
    /// Checked where the expectation asks for it by `no_unused_vertices`.
    ///
    /// ```text
    /// ·──────·
    /// │    ╱ │    ·v    no half-edge leaves v
    /// │  ╱   │
    /// ·──────·
    /// ```
    ///
    /// In the [reference](mod@crate::validate::reference): `m1`.
    M1 "M1" "used" counts "vertex" "vertices"
        "some half-edge leaves every vertex"
        in "used" broken by "mesh_rules" "m1_a_vertex_is_unused";
    /// Checked where the expectation asks for it by `simple`. A face with two sides has parallel edges.
    ///
    /// ```text
    ///            e
    /// ┌───┐    ┌───┐
    /// │   v    u   v    the loop starts and ends at v; e and f both join u and v
    /// └───┘    └───┘
    ///            f
    /// ```
    ///
    /// In the [reference](mod@crate::validate::reference): `m2`.
    M2 "M2" "simple" counts "edge" "edges"
        "no edge is a loop, and no two edges join the same vertices"
        in "simple" broken by "mesh_rules" "m2_an_edge_is_a_loop_or_parallel_to_another";
    /// Checked where the expectation asks for it by `sides` or `triangles`. The sides of a face are all half-edges that bound
    /// it, those of its holes too. The unbounded face may have any number. Without faces, each cycle of `next` is a face.
    ///
    /// ```text
    /// ·──────·
    /// │    ╱  ╲    a triangle and a quadrilateral
    /// │  ╱     ╲
    /// ·────·────·
    /// ```
    ///
    /// In the [reference](mod@crate::validate::reference): `m3`.
    M3 "M3" "sides" counts "face" "faces"
        "every bounded face has the expected number of sides"
        in "sides" broken by "mesh_rules" "m3_a_face_has_a_side_too_many";
    /// Checked where the expectation asks for it by `closed`. Together with `open`, it names each half-edge at a border; without,
    /// R1 finds that links are missing.
    ///
    /// ```text
    /// ·───►───·
    /// │  f   ╱     the half-edge of f has no twin, or its twin bounds no face
    /// │    ╱
    /// ·──·
    /// ```
    ///
    /// In the [reference](mod@crate::validate::reference): `m4`.
    M4 "M4" "closed" counts "half-edge" "half-edges"
        "every half-edge has a twin and bounds a face"
        in "closed" broken by "mesh_rules" "m4_a_mesh_has_a_border";
    /// Checked where the expectation asks for it by `components`. Isolated vertices do not count: M1 is about them.
    ///
    /// ```text
    /// ·───·     ·───·
    /// │ ╱       │ ╱      two components
    /// ·         ·
    /// ```
    ///
    /// In the [reference](mod@crate::validate::reference): `m5`.
    M5 "M5" "connected" counts "component" "components"
        "there are as many components with an edge as expected"
        in "connected" broken by "mesh_rules" "m5_there_is_a_second_component";
    /// Checked where the expectation asks for it by `borders`. A border loop is a cycle of half-edges without face, or a cycle
    /// that the missing twins would make: both ways of keeping a border have the same number.
    ///
    /// ```text
    /// ┌─────────────┐
    /// │   ┌─────┐   │
    /// │   │     │   │    an annulus: two border loops
    /// │   └─────┘   │
    /// └─────────────┘
    /// ```
    ///
    /// In the [reference](mod@crate::validate::reference): `m6`.
    M6 "M6" "borders" counts "component" "components"
        "there are as many border loops as expected"
        in "borders" broken by "mesh_rules" "m6_there_is_a_second_border";
    /// Checked where the expectation asks for it by `genus`.
    ///
    /// ```text
    ///    ______
    ///  ╱  ____  ╲
    /// │  ╲____╱  │    a torus: genus 1
    ///  ╲ ______ ╱
    /// ```
    ///
    /// In the [reference](mod@crate::validate::reference): `m7`.
    M7 "M7" "genus" counts "component" "components"
        "the genera of the components add up to the genus expected"
        in "genus" broken by "mesh_rules" "m7_a_sphere_is_no_torus";
    /// Checked where the expectation asks for it by `border_kept`. Libraries that promise it tell a border vertex from an inner one
    /// by the one half-edge. Where vertices keep none, it is not checked.
    ///
    /// ```text
    ///   f  ╱
    ///    ╱      a half-edge from v without face or twin: v keeps such a one,
    /// ──v───    not one of those that bound f
    /// ```
    ///
    /// In the [reference](mod@crate::validate::reference): `m8`.
    M8 "M8" "kept" counts "vertex" "vertices"
        "a vertex that some half-edge without twin or face leaves keeps such a one"
        in "kept" broken by "mesh_rules" "m8_a_border_vertex_keeps_an_inner_half_edge";
    /// A coordinate is also refused if it is out of the range in which the predicates are exact. Of an edge with bends, these are checked,
    /// and each segment between them.
    G1 "G1" "finite" counts "vertex" "vertices"
        "coordinates are finite, and no edge has zero length"
        in "finite" broken by "embeddings" "g1_a_coordinate_that_is_not_finite";
    /// ```text
    ///    b   c
    ///     \ /     a, b, c, d follow one another clockwise, by `next∘twin` and by their angles
    /// a ── v
    ///       \
    ///        d
    /// ```
    G2 "G2" "angles" counts "vertex" "vertices"
        "half-edges around a vertex are in angular order"
        in "angles" broken by "embeddings" "g2_two_leaves_of_a_star_have_changed_places";
    /// ```text
    /// ┌───◄───┐
    /// │ ┌─►─┐ │    the face is to the left of both cycles
    /// ▼ ▲   ▼ ▲
    /// │ └─◄─┘ │
    /// └───►───┘
    /// ```
    G3 "G3" "winding" counts "cycle" "cycles"
        "outer cycles turn counter-clockwise, inner ones clockwise"
        in "winding" broken by "embeddings" "g3_a_square_seen_in_a_mirror";
    /// ```text
    /// \ /        |              ______
    ///  X         |         ====/======      o o
    /// / \    ----+----        /
    /// ```
    ///
    /// A bend is no endpoint: edges do not meet there, and an edge does not pass through its own bends.
    G4 "G4" "disjoint" counts "edge" "edges"
        "edges meet only at shared endpoints"
        in "disjoint" broken by "embeddings" "g4_a_square_twisted_into_a_bow_tie";
    /// ```text
    /// ┌─────────┐
    /// │    f    │    going straight down from the lowest vertex v of a component, the first edge
    /// │   v·    │    bounds the face in which the component lies
    /// │    :    │
    /// └────┴────┘
    /// ```
    G5 "G5" "inside" counts "boundary component" "boundary components"
        "each inner boundary component lies in the face that lists it, and what no face lists lies in none"
        in "inside" broken by "embeddings" "g5_an_island_listed_by_the_face_next_door";
}

impl Rule {
    /// Whether the rule is about coordinates (G1 … G5).
    #[must_use]
    pub const fn is_geometric(self) -> bool {
        matches!(self, Self::G1 | Self::G2 | Self::G3 | Self::G4 | Self::G5)
    }

    /// Whether the rule is checked only where the expectation asks for it (M1 … M8).
    #[must_use]
    pub const fn is_optional(self) -> bool {
        matches!(self, Self::M1 | Self::M2 | Self::M3 | Self::M4 | Self::M5 | Self::M6 | Self::M7 | Self::M8)
    }

    /// The position in [`Rule::ALL`].
    #[must_use]
    pub const fn index(self) -> usize {
        self as usize
    }
}

impl fmt::Display for Rule {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.id())
    }
}
