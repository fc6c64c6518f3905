(** * ExpectationsExamples: what the rules say of some tables under other expectations than the closed plane *)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import View Rules Table RotationSystem Expectations ExpectationsCheck ExpectationsVerdict.
From twinedge Require Import ExpectationsFaceless ExpectationsParts ExpectationsFaces ExpectationsMissing ExpectationsOpenCounts ExpectationsOpen.
From twinedge Require Import ExpectationsNested ExpectationsHoles ExpectationsClosed.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** Vertices with a half-edge that they keep, half-edges with `prev`, and the faces that they name. *)
Definition mesh (vertices : seq nat) (half_edges : seq half_edge_row) (faces : seq link) (face_starts : seq nat) := {|
  answers := view_of {|
    vertex_rows := [seq Some (VertexRow (Some h) None) | h <- vertices];
    half_edge_rows := [seq Some row | row <- half_edges];
    boundary_rows := [::];
    face_rows := [seq Some (FaceRow None [::]) | _ <- face_starts] |};
  stored := Parts true true (face_starts != [::]) false false false false;
  says_face := nth None faces;
  says_outer_half_edge := nth None (map Some face_starts);
  says_inner_start := fun _ _ => None
|}.

Definition with_border := Expectation false true false false None false None None None false.

(** ** A torus: one vertex and two loops that cross there, without faces. The plane forbids what surfaces allow

<<
          │ h2               around the vertex: h0, h2, h1, h3
     h1 ──0── h0             V − E + cycles = 1 − 2 + 1 = 0 = 2 − 2 · 1
          │ h3
>>
*)

Definition torus_of_darts := mesh [:: 0]
  [:: HalfEdgeRow #0 #1 #3 #2 'nil; HalfEdgeRow #0 #0 #2 #3 'nil; HalfEdgeRow #0 #3 #0 #1 'nil; HalfEdgeRow #0 #2 #1 #0 'nil] [::] [::].

Example torus_on_surface : rules_of surface torus_of_darts /\ first_broken_of plane torus_of_darts = Some (Basic T3).
Proof. by split; [apply/first_broken_of_none|]; vm_compute. Qed.

(** The genus is 1, if one asks for it. *)
Example torus_genus : rules_of (Expectation false false true false (Some 4) true (Some 1) (Some 0) (Some 1) false) torus_of_darts /\
  first_broken_of (Expectation false false false false None false None None (Some 0) false) torus_of_darts = Some (Mesh M7).
Proof. by split; [apply/first_broken_of_none|]; vm_compute. Qed.

(** So it is a rotation system, and cannot be drawn in the plane. *)
Example torus_is_rotations : exists r, represents_rotations (answers torus_of_darts) r.
Proof. by apply/(faceless_surface _ false false false false)/torus_on_surface.1. Qed.

Example torus_cannot_be_drawn : ~ exists r, represents_rotations (answers torus_of_darts) r /\ plane_system r.
Proof.
move=> R; have [_ E] := torus_on_surface; suff: first_broken_of plane torus_of_darts = None by rewrite E.
apply/first_broken_of_none; exact: (faceless_plane _ false false false false _ _ _).2 R.
Qed.

(** Nor does it matter that `prev` and the half-edges kept by vertices are stored. *)
Definition torus_of_next := let: Structure v _ sf so si := torus_of_darts in
  Structure v (Parts false false false false false false false) sf so si.

Example torus_of_next_is_rotations : rules_of surface torus_of_next /\
  exists r, represents_rotations (answers (filled surface torus_of_next)) r.
Proof.
have H : rules_of surface torus_of_next by apply/first_broken_of_none; vm_compute.
by split=> //; apply/filled_faceless_surface.
Qed.

(** ** A triangle of three half-edges that have a face and no twin: right where open boundaries are legal

<<
           2
         ╱   ╲           h0 from 0 to 1, h1 from 1 to 2, h2 from 2 to 0, and none on the other side
       0 ───── 1
>>
*)

Definition triangle := mesh [:: 0; 1; 2]
  [:: HalfEdgeRow #0 'nil #1 #2 'nil; HalfEdgeRow #1 'nil #2 #0 'nil; HalfEdgeRow #2 'nil #0 #1 'nil] [:: #0; #0; #0] [:: 0].

Example triangle_open : rules_of with_border triangle /\ first_broken_of surface triangle = Some (Basic R1).
Proof. by split; [apply/first_broken_of_none|]; vm_compute. Qed.

(** It is a rotation system of which one cycle is missing, and it lies in the plane. *)
Example triangle_plane : rules_of (open_on true) triangle /\ is_open_map true (answers triangle) /\
  open_faces (answers triangle) (says_face triangle) (says_outer_half_edge triangle).
Proof.
have H : rules_of (open_on true) triangle by apply/first_broken_of_none; vm_compute.
by split=> //; exact: ((open_named (on := true) _ false false _ _ _ (erefl : false && true = false)).1 H).
Qed.

(** Two such triangles with one vertex in common are refused: the cycles that are missing would meet there. *)
Definition bow_tie := mesh [:: 0; 1; 2; 4; 5]
  [:: HalfEdgeRow #0 'nil #1 #2 'nil; HalfEdgeRow #1 'nil #2 #0 'nil; HalfEdgeRow #2 'nil #0 #1 'nil;
      HalfEdgeRow #0 'nil #4 #5 'nil; HalfEdgeRow #3 'nil #5 #3 'nil; HalfEdgeRow #4 'nil #3 #4 'nil] [:: #0; #0; #0; #1; #1; #1] [:: 0; 3].

Example bow_tie_meets : first_broken_of with_border bow_tie = Some (Basic V2) /\
  ~ exists r missing, @represents_without (answers bow_tie) r missing.
Proof.
have E : first_broken_of with_border bow_tie = Some (Basic V2) by vm_compute.
split=> // R; have [no _] := (first_broken_of_some _ _ _).1 E; apply: no.
have keeps := (open_rules_mean_missing (answers bow_tie)).2 R.
exact: (@open_v2 (answers bow_tie) false false false false (says_face bow_tie) (says_outer_half_edge bow_tie) (says_inner_start bow_tie) true false keeps).
Qed.

(** It is a disc of triangles: one component, one border loop, and genus 0; and it is not closed. *)
Example triangle_is_disc :
  rules_of (Expectation false true true true (Some 3) false (Some 1) (Some 1) (Some 0) true) triangle /\
  first_broken_of (Expectation false true false false None true None None None false) triangle = Some (Mesh M4).
Proof. by split; [apply/first_broken_of_none|]; vm_compute. Qed.

(** ** The same with twins, which have no face. A vertex that keeps a half-edge inside breaks M8, if it is asked for *)

Definition triangle_with_twins := mesh [:: 0; 3; 4]
  [:: HalfEdgeRow #0 #3 #1 #2 'nil; HalfEdgeRow #1 #4 #2 #0 'nil; HalfEdgeRow #2 #5 #0 #1 'nil;
      HalfEdgeRow #1 #0 #5 #4 'nil; HalfEdgeRow #2 #1 #3 #5 'nil; HalfEdgeRow #0 #2 #4 #3 'nil]
  [:: #0; #0; #0; 'nil; 'nil; 'nil] [:: 0].

Example triangle_keeps_inside : rules_of with_border triangle_with_twins /\
  first_broken_of (Expectation false true false false None false None (Some 1) None true) triangle_with_twins = Some (Mesh M8).
Proof. by split; [apply/first_broken_of_none|]; vm_compute. Qed.

(** ** The same with a face there, too: two triangles make a sphere, and each face is one cycle *)

Definition two_triangles := mesh [:: 0; 3; 4]
  [:: HalfEdgeRow #0 #3 #1 #2 'nil; HalfEdgeRow #1 #4 #2 #0 'nil; HalfEdgeRow #2 #5 #0 #1 'nil;
      HalfEdgeRow #1 #0 #5 #4 'nil; HalfEdgeRow #2 #1 #3 #5 'nil; HalfEdgeRow #0 #2 #4 #3 'nil]
  [:: #0; #0; #0; #1; #1; #1] [:: 0; 3].

Example two_triangles_closed : rules_of surface two_triangles /\
  faces_are_cycles (answers two_triangles) (says_face two_triangles) (says_outer_half_edge two_triangles).
Proof.
have H : rules_of surface two_triangles by apply/first_broken_of_none; vm_compute.
split=> //; exact: ((named_faces _ false false false _ _ _).1 H).2.
Qed.

(** It is plane, too: a sphere, any of whose faces can be the unbounded one. *)
Example two_triangles_plane : rules_of plane two_triangles /\ is_plane (answers two_triangles).
Proof.
have H : rules_of plane two_triangles by apply/first_broken_of_none; vm_compute.
split=> //; exact: ((named_faces_plane _ false false _ _ _).1 H).1.
Qed.

(** ** A loop with an isolated vertex inside, without records for boundary components

<<
        ┌──◄──h0──┐          the unbounded face 0 lists, inside, the cycle of h0
        │    ·1   │          the face 1 has the cycle of h1 as its outer one, and lists the vertex 1 inside
        └──0──────┘
>>
*)

Definition loop_of_faces (sides : seq link) (outers : seq link) (inners : seq (seq start)) (unbounded : bool) := {|
  answers := view_of {|
    vertex_rows := [:: Some (VertexRow #0 'nil); Some (VertexRow 'nil 'nil)];
    half_edge_rows := [:: Some (HalfEdgeRow #0 #1 #0 #0 'nil); Some (HalfEdgeRow #0 #0 #1 #1 'nil)];
    boundary_rows := [::];
    face_rows := [seq Some (FaceRow None [seq None | _ <- l]) | l <- inners] |};
  stored := Parts true true true false false true unbounded;
  says_face := nth None sides;
  says_outer_half_edge := nth None outers;
  says_inner_start := fun f i => nth None (map Some (nth [::] inners f)) i
|}.

Definition point_in_loop := loop_of_faces [:: #0; #1] [:: 'nil; #1] [:: [:: AtHalfEdge 0]; [:: AtVertex 1]] true.

Example point_in_loop_nested : rules_of plane point_in_loop /\ is_plane (answers point_in_loop) /\ faces_nested plane point_in_loop.
Proof.
have H : rules_of plane point_in_loop by apply/first_broken_of_none; vm_compute.
by split=> //; have [] := (holes_named _ false true _ _ _).1 H.
Qed.

(** Without an unbounded face: the loop bounds two faces, and the vertex lies in neither of them. *)
Example point_nowhere : rules_of plane (loop_of_faces [:: #0; #1] [:: #0; #1] [:: [::]; [::]] false).
Proof. by apply/first_broken_of_none; vm_compute. Qed.

(** A loop that lies in the face that it bounds is not nested. *)
Definition loop_inside_itself := loop_of_faces [:: #0; #0] [:: #1] [:: [:: AtHalfEdge 0]] false.

Example loop_not_nested : first_broken_of plane loop_inside_itself = Some (Basic T2) /\ ~ faces_nested plane loop_inside_itself.
Proof.
split; [by vm_compute|case=> _ _ _ _ _ _ [depth [same deeper]]].
by have := deeper 0 0 0 0 erefl erefl; rewrite ltnn.
Qed.
