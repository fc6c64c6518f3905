//! The one table of operators.
//!
//! From it follow the operators of programs and their calls, their bytes, their text, their Rust source, how they are made
//! simpler, how their numbers follow what they chose, and how the counts of a map change. The operators of meshes are in no random
//! program that is not of them ([`Program::from_bytes`](crate::program::Program::from_bytes)). A row reads:
//!
//! ```text
//! variant  method  how many of 32 random operators are this one
//!     what it may add to the numbers of vertices, edges, faces and components
//!     its arguments: how a program chooses each, what that is in a call, and (what it depends on)
//! ```

/// Calls the macro `$then` with the table.
macro_rules! operators {
    ($then:ident) => {
        $then! {
            AddIsolatedVertex add_isolated_vertex 5 {
                changes [(1, 0, 0, 1)]
                face: FacePick => F, ();
            }
            RemoveIsolatedVertex remove_isolated_vertex 1 {
                changes [(-1, 0, 0, -1)]
                vertex: VertexPick => V, ();
            }
            Connect connect 9 {
                changes [(0, 1, 1, 0), (0, 1, 0, -1)]
                from: CornerPick => Corner<H, V>, ();
                to: SecondPick => Corner<H, V>, (from, Fit::Face);
                new_face: Side => Side, ();
                inner: InnerPick => Vec<Corner<H, V>>, (from);
            }
            RemoveEdge remove_edge 3 {
                changes [(0, -1, -1, 0), (0, -1, 0, 1)]
                half_edge: HalfEdgePick => H, ();
            }
            SplitEdge split_edge 2 {
                changes [(1, 1, 0, 0)]
                half_edge: HalfEdgePick => H, ();
            }
            JoinEdges join_edges 1 {
                changes [(-1, -1, 0, 0)]
                half_edge: HalfEdgePick => H, ();
            }
            SplitVertex split_vertex 3 {
                changes [(1, 1, 0, 0)]
                from: CornerPick => Corner<H, V>, ();
                to: SecondPick => Corner<H, V>, (from, Fit::Vertex);
            }
            ContractEdge contract_edge 2 {
                changes [(-1, -1, 0, 0)]
                half_edge: HalfEdgePick => H, ();
            }
            FlipEdge flip_edge 3 {
                changes [(0, 0, 0, 0)]
                half_edge: HalfEdgePick => H, ();
                turn: Turn => Turn, ();
            }
            MoveInner move_inner 3 {
                changes [(0, 0, 0, 0)]
                inner: CornerPick => Corner<H, V>, ();
                face: FacePick => F, ();
            }
            MeshFlipEdge mesh_flip_edge 0 {
                changes [(0, 0, 0, 0)]
                half_edge: HalfEdgePick => H, ();
            }
            MeshSplitEdge mesh_split_edge 0 {
                changes [(1, 3, 2, 0), (1, 2, 1, 0)]
                half_edge: HalfEdgePick => H, ();
            }
            MeshSplitFace mesh_split_face 0 {
                changes [(1, 3, 2, 0)]
                half_edge: HalfEdgePick => H, ();
            }
            MeshCollapseEdge mesh_collapse_edge 0 {
                changes [(-1, -3, -2, 0), (-1, -2, -1, 0)]
                half_edge: HalfEdgePick => H, ();
            }
        }
    };
}
pub(in crate::program) use operators;
