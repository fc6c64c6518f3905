(** * Examples: what the rules say of some tables

    They guard our reading of the rules, and show that the theorems about operators are about something. Each is what a Rust
    programmer would write as a [Table]. *)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import View Rules Reference Verdict Table Subdivision Lists ConnectBridge.
From twinedge Require Import ConnectSplit ConnectLoop Connect RemoveMerge RemovePart Contract SplitVertex Flip FastPath Programs.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** ** One edge, and an isolated vertex, in the unbounded face: a subdivision

<<
        0 ─────h0────► 1        · 2           h1 is the twin of h0
>>
*)

Definition edge_and_point := view_of {|
  vertex_rows := [:: Some (VertexRow #0 'nil); Some (VertexRow #1 'nil); Some (VertexRow 'nil #1)];
  half_edge_rows := [:: Some (HalfEdgeRow #0 #1 #1 #1 #0); Some (HalfEdgeRow #1 #0 #0 #0 #0)];
  boundary_rows := [:: Some (BoundaryRow #0 (Some (AtHalfEdge 0)) (Some (Inner 0)));
                       Some (BoundaryRow #0 (Some (AtVertex 2)) (Some (Inner 1)))];
  face_rows := [:: Some (FaceRow 'nil [:: #0; #1])] |}.

Example edge_and_point_keeps_all : rules edge_and_point.
Proof. by apply/first_broken_none; vm_compute. Qed.

Example edge_and_point_is_plane : exists s, represents edge_and_point s.
Proof. by apply/rules_mean_subdivision/edge_and_point_keeps_all. Qed.

(** ** A loop with a point inside, and vacant slots: a subdivision

<<
          ┌──────────┐
          │  f2  · 2 │           h1 runs around f2, h3 is its twin outside;
          └── 0 ─────┘           vertex 1, half-edges 0 and 2 and face 1 are vacant
>>
*)

Definition point_in_loop := view_of {|
  vertex_rows := [:: Some (VertexRow #1 'nil); None; Some (VertexRow 'nil #2)];
  half_edge_rows := [:: None; Some (HalfEdgeRow #0 #3 #1 #1 #0); None; Some (HalfEdgeRow #0 #1 #3 #3 #1)];
  boundary_rows := [:: Some (BoundaryRow #2 (Some (AtHalfEdge 1)) (Some Outer));
                       Some (BoundaryRow #0 (Some (AtHalfEdge 3)) (Some (Inner 0)));
                       Some (BoundaryRow #2 (Some (AtVertex 2)) (Some (Inner 0)))];
  face_rows := [:: Some (FaceRow 'nil [:: #1]); None; Some (FaceRow #0 [:: #2])] |}.

Example point_in_loop_keeps_all : rules point_in_loop.
Proof. by apply/first_broken_none; vm_compute. Qed.

Example point_in_loop_is_plane : exists s, represents point_in_loop s.
Proof. by apply/rules_mean_subdivision/point_in_loop_keeps_all. Qed.

(** ** A torus: one vertex, two loops that cross it, one walk. T3 is broken first

<<
          │ h2               around the vertex: h0, h2, h1, h3
     h1 ──0── h0             V − E + cycles = 1 − 2 + 1 = 0 = 2 − 2 · 1
          │ h3
>>
*)

Definition torus := view_of {|
  vertex_rows := [:: Some (VertexRow #0 'nil)];
  half_edge_rows := [:: Some (HalfEdgeRow #0 #1 #3 #2 #0); Some (HalfEdgeRow #0 #0 #2 #3 #0);
                        Some (HalfEdgeRow #0 #3 #0 #1 #0); Some (HalfEdgeRow #0 #2 #1 #0 #0)];
  boundary_rows := [:: Some (BoundaryRow #0 (Some (AtHalfEdge 0)) (Some (Inner 0)))];
  face_rows := [:: Some (FaceRow 'nil [:: #0])] |}.

Example torus_breaks_t3_first : ~ t3_euler torus /\ forall q, index q < index T3 -> holds torus q.
Proof. by apply/(first_broken_some torus T3); vm_compute. Qed.

Example torus_is_not_plane : ~ exists s, represents torus s.
Proof. by move/rules_mean_subdivision => /(_ T3); case: torus_breaks_t3_first. Qed.

(** ** A loop that lies in its own inside. T2 is broken first

<<
          ┌──────────┐           face 1 is bounded by the cycle of h0 and lists the cycle of h1
          │    f1    │           as a hole: the component lies in the face that it bounds
          └── 0 ─────┘
>>
*)

Definition loop_in_itself := view_of {|
  vertex_rows := [:: Some (VertexRow #0 'nil)];
  half_edge_rows := [:: Some (HalfEdgeRow #0 #1 #0 #0 #0); Some (HalfEdgeRow #0 #0 #1 #1 #1)];
  boundary_rows := [:: Some (BoundaryRow #1 (Some (AtHalfEdge 0)) (Some Outer));
                       Some (BoundaryRow #1 (Some (AtHalfEdge 1)) (Some (Inner 0)))];
  face_rows := [:: Some (FaceRow 'nil [::]); Some (FaceRow #0 [:: #1])] |}.

Example loop_in_itself_breaks_t2_first : ~ t2_nesting loop_in_itself /\ forall q, index q < index T2 -> holds loop_in_itself q.
Proof. by apply/(first_broken_some loop_in_itself T2); vm_compute. Qed.

Example loop_in_itself_is_not_plane : ~ exists s, represents loop_in_itself s.
Proof. by move/rules_mean_subdivision => /(_ T2); case: loop_in_itself_breaks_t2_first. Qed.

(** ** An empty map is one unbounded face. Two unbounded faces break F1 first *)

Definition faces_only n := view_of {|
  vertex_rows := [::]; half_edge_rows := [::]; boundary_rows := [::];
  face_rows := nseq n (Some (FaceRow 'nil [::])) |}.

Example empty_map_keeps_all : rules (faces_only 1).
Proof. by apply/first_broken_none; vm_compute. Qed.

Example two_unbounded_break_f1_first : ~ f1_outer (faces_only 2) /\ forall q, index q < index F1 -> holds (faces_only 2) q.
Proof. by apply/(first_broken_some (faces_only 2) F1); vm_compute. Qed.

(** ** The fast path, run: it accepts what is right, refuses the torus, and leaves T2 to be checked *)

Example fast_path_on_examples :
  [/\ fast_path edge_and_point, fast_path point_in_loop, fast_path (faces_only 1), ~~ fast_path torus
    & fast_path loop_in_itself].
Proof. by split; vm_compute. Qed.

(** ** Two edges in the unbounded face, and a bridge between them

<<
        0 ──h0──► 1    3 ◄──h2── 2               0 ──h0──► 1 ──h4──► 3 ◄──h2── 2
>>
*)

Definition two_edges := view_of {|
  vertex_rows := [:: Some (VertexRow #0 'nil); Some (VertexRow #1 'nil); Some (VertexRow #2 'nil); Some (VertexRow #3 'nil)];
  half_edge_rows := [:: Some (HalfEdgeRow #0 #1 #1 #1 #0); Some (HalfEdgeRow #1 #0 #0 #0 #0);
                        Some (HalfEdgeRow #2 #3 #3 #3 #1); Some (HalfEdgeRow #3 #2 #2 #2 #1)];
  boundary_rows := [:: Some (BoundaryRow #0 (Some (AtHalfEdge 0)) (Some (Inner 0)));
                       Some (BoundaryRow #0 (Some (AtHalfEdge 2)) (Some (Inner 1)))];
  face_rows := [:: Some (FaceRow 'nil [:: #0; #1])] |}.

Example two_edges_keeps_all : rules two_edges.
Proof. by apply/first_broken_none; vm_compute. Qed.

Example two_edges_bridged : rules (bridge two_edges 0 2 4 5 0 1 0).
Proof. by apply: bridge_keeps_rules two_edges_keeps_all => //; right. Qed.

Example two_edges_bridged_rows : let t := bridge two_edges 0 2 4 5 0 1 0 in
  [/\ inner_list t 0 = [:: 1], [seq boundary_of t i | i <- iota 0 7] = [:: #1; #1; #1; #1; #1; #1; 'nil],
      [seq next t i | i <- iota 0 7] = [:: #4; #0; #5; #2; #3; #1; 'nil] & first_broken t = None].
Proof. by split; vm_compute. Qed.

(** ** An edge in a loop, and a bridge between them: what was an inner boundary component bounds the face then

<<
          ┌─────────────┐            ┌──────────────┐
          │ 1 ──h2──► 2 │            │ 1 ──h2──► 2  │
          └── 0 ────────┘            └── 0 ──h4──┘ ─┘
>>
*)

Definition edge_in_loop := view_of {|
  vertex_rows := [:: Some (VertexRow #0 'nil); Some (VertexRow #2 'nil); Some (VertexRow #3 'nil)];
  half_edge_rows := [:: Some (HalfEdgeRow #0 #1 #0 #0 #0); Some (HalfEdgeRow #0 #0 #1 #1 #1);
                        Some (HalfEdgeRow #1 #3 #3 #3 #2); Some (HalfEdgeRow #2 #2 #2 #2 #2)];
  boundary_rows := [:: Some (BoundaryRow #1 (Some (AtHalfEdge 0)) (Some Outer));
                       Some (BoundaryRow #0 (Some (AtHalfEdge 1)) (Some (Inner 0)));
                       Some (BoundaryRow #1 (Some (AtHalfEdge 2)) (Some (Inner 0)))];
  face_rows := [:: Some (FaceRow 'nil [:: #1]); Some (FaceRow #0 [:: #2])] |}.

Example edge_in_loop_keeps_all : rules edge_in_loop.
Proof. by apply/first_broken_none; vm_compute. Qed.

Example edge_in_loop_bridged : rules (bridge edge_in_loop 0 2 4 5 1 2 0).
Proof. by apply: bridge_keeps_rules edge_in_loop_keeps_all => //; right. Qed.

Example edge_in_loop_bridged_rows : let t := bridge edge_in_loop 0 2 4 5 1 2 0 in
  [/\ outer t 1 = #2, inner_list t 1 = [::], boundary_place t 2 = Some Outer & first_broken t = None].
Proof. by split; vm_compute. Qed.

(** ** A second edge between two vertices encloses a new face, and the isolated vertex is told to lie there

<<
        0 ─────h0────► 1        · 2            0 ─────h0────► 1        h2 runs back from 1 to 0,
                                               │      · 2     │        h0 and h2 run around the new face
                                               └──────◄──h2───┘
>>
*)

Example edge_split : rules (split_face edge_and_point 0 1 2 3 0 1 0 2 true true (fun c => c == 1)).
Proof. by apply: split_face_keeps_rules edge_and_point_keeps_all. Qed.

Example edge_split_rows : let t := split_face edge_and_point 0 1 2 3 0 1 0 2 true true (fun c => c == 1) in
  [/\ [seq boundary_of t i | i <- iota 0 4] = [:: #2; #0; #2; #0], [seq next t i | i <- iota 0 4] = [:: #2; #3; #0; #1],
      [seq outer t x | x <- iota 0 2] = [:: 'nil; #2], [seq inner_list t x | x <- iota 0 2] = [:: [:: 0]; [:: 1]]
    & first_broken t = None].
Proof. by split; vm_compute. Qed.

(** ** A loop inside a loop, at the same corner. The new face is what is to the right of [h0], inside the new loop

<<
          ┌──────────────┐           ┌──────────────┐
          │   f2   · 2   │           │ (──)  f2 · 2 │        the new loop is h0 and h2; h2 is alone on its cycle
          └── 0 ─────────┘           └── 0 ─────────┘
>>
*)

Example loop_split : rules (split_face point_in_loop 1 1 0 2 2 1 0 3 false false pred0).
Proof. by apply: split_face_keeps_rules point_in_loop_keeps_all. Qed.

Example loop_split_rows : let t := split_face point_in_loop 1 1 0 2 2 1 0 3 false false pred0 in
  [/\ [seq boundary_of t i | i <- iota 0 4] = [:: #0; #0; #3; #1], [seq next t i | i <- iota 0 4] = [:: #1; #0; #2; #3],
      [seq outer t x | x <- iota 0 3] = [:: 'nil; #3; #0], [seq inner_list t x | x <- iota 0 3] = [:: [:: 1]; [::]; [:: 2]]
    & first_broken t = None].
Proof. by split; vm_compute. Qed.

(** ** A loop at the isolated vertex, and the edge is told to lie in the new face

<<
        0 ─────h0────► 1        · 2            ┌──────────────────────┐
                                               │ 0 ─────h0────► 1     │     h2 runs around the new face
                                               └────────── 2 ─────────┘
>>
*)

Example loop_added : rules (loop_at_isolated edge_and_point 2 2 3 0 1 1 2 true true (fun c => c == 0)).
Proof. by apply: loop_at_isolated_keeps_rules edge_and_point_keeps_all. Qed.

Example loop_added_rows : let t := loop_at_isolated edge_and_point 2 2 3 0 1 1 2 true true (fun c => c == 0) in
  [/\ [seq boundary_of t i | i <- iota 0 4] = [:: #0; #0; #2; #1], [seq next t i | i <- iota 0 4] = [:: #1; #0; #2; #3],
      [seq outer t x | x <- iota 0 2] = [:: 'nil; #2], [seq inner_list t x | x <- iota 0 2] = [:: [:: 1]; [:: 0]]
    & first_broken t = None].
Proof. by split; vm_compute. Qed.

(** ** A new vertex at an end of the edge

<<
        0 ─────h0────► 1        · 2            0 ──h0──► 1 ──h2──► 3        · 2
>>
*)

Example vertex_on_edge : rules (split_vertex edge_and_point 0 0 3 2 3).
Proof. by apply: split_vertex_keeps_rules edge_and_point_keeps_all. Qed.

Example vertex_on_edge_rows : let t := split_vertex edge_and_point 0 0 3 2 3 in
  [/\ [seq next t i | i <- iota 0 4] = [:: #2; #0; #3; #1], [seq origin t i | i <- iota 0 4] = [:: #0; #1; #1; #3],
      [seq leaving t i | i <- iota 0 4] = [:: #0; #1; 'nil; #3] & first_broken t = None].
Proof. by split; vm_compute. Qed.

(** ** … and without it again: all is as it was *)

Example vertex_off_edge : rules (contract_edge (split_vertex edge_and_point 0 0 3 2 3) 2 3 1 3).
Proof. by apply: contract_edge_keeps_rules vertex_on_edge. Qed.

Example vertex_off_edge_rows : let t := contract_edge (split_vertex edge_and_point 0 0 3 2 3) 2 3 1 3 in
  [/\ [seq half_edge t i | i <- iota 0 4] = [:: true; true; false; false], [seq next t i | i <- iota 0 2] = [:: #1; #0],
      [seq origin t i | i <- iota 0 2] = [:: #0; #1], [seq leaving t i | i <- iota 0 4] = [:: #0; #1; 'nil; 'nil]
    & first_broken t = None].
Proof. by split; vm_compute. Qed.

(** ** … and without the edge that was there first: an isolated vertex *)

Example edge_contracted_rows : let t := contract_edge edge_and_point 0 1 1 0 in
  [/\ is_contractible edge_and_point 0 1 1 0, [seq isolated t i | i <- iota 0 3] = [:: 'nil; #0; #1] & first_broken t = None].
Proof. by split; vm_compute. Qed.

(** A loop is not contracted, and corners at two vertices split none. *)

Example not_contracted : ~~ is_contractible point_in_loop 1 3 0 0 /\ ~~ is_splittable edge_and_point 0 1 3 2 3.
Proof. by split; vm_compute. Qed.

(** ** An end of two edges is split between them: h1 leaves the new vertex

<<
        0 ─────h0────► 1                       0 ─────h0────► 3
        │              │                       │              │ h4 leads from 1 to 3
        └──────◄──h2───┘                       └──────◄──h2── 1
>>
*)

Definition digon := split_face edge_and_point 0 1 2 3 0 1 0 2 true true (fun c => c == 1).

Example vertex_split : rules (split_vertex digon 0 3 3 4 5).
Proof. by apply: split_vertex_keeps_rules edge_split. Qed.

Example vertex_split_rows : let t := split_vertex digon 0 3 3 4 5 in
  [/\ [seq next t i | i <- iota 0 6] = [:: #5; #3; #0; #4; #1; #2], [seq origin t i | i <- iota 0 6] = [:: #0; #3; #1; #0; #1; #3],
      [seq boundary_of t i | i <- iota 0 6] = [:: #2; #0; #2; #0; #0; #2] & first_broken t = None].
Proof. by split; vm_compute. Qed.

(** ** One of the two edges is flipped: its ends change places *)

Example edge_flipped : rules (flip_edge digon 0 1 0 1 2 0 3 2 true (fun c => c == 1)).
Proof. by apply: flip_edge_keeps_rules edge_split. Qed.

Example edge_flipped_rows : let t := flip_edge digon 0 1 0 1 2 0 3 2 true (fun c => c == 1) in
  [/\ [seq next t i | i <- iota 0 4] = [:: #3; #2; #1; #0], [seq origin t i | i <- iota 0 4] = [:: #1; #0; #1; #0],
      [seq boundary_of t i | i <- iota 0 4] = [:: #2; #0; #0; #2], [seq inner_list t x | x <- iota 0 2] = [:: [:: 0]; [:: 1]]
    & first_broken t = None].
Proof. by split; vm_compute. Qed.

(** ** The isolated vertex is connected to an end of the edge *)

Example points_connected : rules (connect_isolated edge_and_point 0 2 1 2 3).
Proof. by apply: connect_isolated_keeps_rules edge_and_point_keeps_all. Qed.

Example points_connected_rows : let t := connect_isolated edge_and_point 0 2 1 2 3 in
  [/\ [seq next t i | i <- iota 0 4] = [:: #2; #0; #3; #1], [seq origin t i | i <- iota 0 4] = [:: #0; #1; #1; #2],
      [seq isolated t i | i <- iota 0 3] = [:: 'nil; 'nil; 'nil], inner_list t 0 = [:: 0] & first_broken t = None].
Proof. by split; vm_compute. Qed.

(** ** The loop is removed: its vertex is isolated, and the one inside lies in the unbounded face

<<
          ┌──────────┐
          │  f2  · 2 │           · 0    · 2
          └── 0 ─────┘
>>
*)

Example loop_removed : rules (merge_faces point_in_loop 1 3 0 2 1 0).
Proof. by apply: merge_faces_keeps_rules point_in_loop_keeps_all. Qed.

Example loop_removed_rows : let t := merge_faces point_in_loop 1 3 0 2 1 0 in
  [/\ [seq half_edge t i | i <- iota 0 4] = [:: false; false; false; false], [seq isolated t i | i <- iota 0 3] = [:: #1; 'nil; #2],
      [seq face t i | i <- iota 0 3] = [:: true; false; false], inner_list t 0 = [:: 1; 2] & first_broken t = None].
Proof. by split; vm_compute. Qed.

(** The face that surrounds the other is not the one that is dropped. *)

Example no_seam : ~~ is_seam point_in_loop 1 3 2 0 0 1.
Proof. by vm_compute. Qed.

(** ** The edge is removed: its ends are two isolated vertices, one of which has the new boundary component

<<
        0 ─────h0────► 1        · 2            · 0            · 1        · 2
>>
*)

Example bridge_removed : rules (part_component edge_and_point 0 1 0 0 2 0 2 0).
Proof. by apply: (@part_component_keeps_rules _ 0 1 0 0 2 0 2 0 0 [::]) edge_and_point_keeps_all. Qed.

Example bridge_removed_rows : let t := part_component edge_and_point 0 1 0 0 2 0 2 0 in
  [/\ [seq half_edge t i | i <- iota 0 2] = [:: false; false], [seq isolated t i | i <- iota 0 3] = [:: #0; #2; #1],
      inner_list t 0 = [:: 0; 1; 2] & first_broken t = None].
Proof. by split; vm_compute. Qed.

(** A bridge inside a face that its own component bounds: the part with the outside stays the outer one, and no other does. *)

Example hair_removed : let t := split_vertex point_in_loop 1 1 3 4 5 in
  is_bridge t 4 5 2 0 3 0 3 0 1 [::] /\ ~~ is_bridge t 4 5 2 0 3 0 3 3 1 [::].
Proof. by split; vm_compute. Qed.
