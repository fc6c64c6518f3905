//! R1 … V2: links, and the combinatorial map that they make.

macro_rules! links_rules {
    ($define:ident $($before:tt)*) => {
        $crate::validate::catalogue::faces::faces_rules! {
            $define
            $($before)*
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
        }
    };
}

pub(in crate::validate) use links_rules;
