(** * Table: a view as plain tables (table/mod.rs)

    A row that is [None] is vacant. *)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import View.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Record vertex_row := VertexRow { leaving_cell : link; isolated_cell : link }.
Record half_edge_row := HalfEdgeRow {
  origin_cell : link; twin_cell : link; next_cell : link; prev_cell : link; boundary_cell : link }.
Record boundary_row := BoundaryRow { face_cell : link; start_cell : option start; place_cell : option place }.
Record face_row := FaceRow { outer_cell : link; inner_cells : seq link }.

Record table := Table {
  vertex_rows : seq (option vertex_row);
  half_edge_rows : seq (option half_edge_row);
  boundary_rows : seq (option boundary_row);
  face_rows : seq (option face_row)
}.

Definition row A (rows : seq (option A)) i : option A := nth None rows i.
Definition cell A B (rows : seq (option A)) (field : A -> option B) i : option B := row rows i >>= field.
Definition is_row A (rows : seq (option A)) i := isSome (row rows i).

Definition view_of (t : table) : view := {|
  vertex_slots := size (vertex_rows t);
  half_edge_slots := size (half_edge_rows t);
  boundary_slots := size (boundary_rows t);
  face_slots := size (face_rows t);
  is_vertex := is_row (vertex_rows t);
  is_half_edge := is_row (half_edge_rows t);
  is_boundary := is_row (boundary_rows t);
  is_face := is_row (face_rows t);
  says_origin := cell (half_edge_rows t) origin_cell;
  says_twin := cell (half_edge_rows t) twin_cell;
  says_next := cell (half_edge_rows t) next_cell;
  says_prev := cell (half_edge_rows t) prev_cell;
  says_boundary := cell (half_edge_rows t) boundary_cell;
  says_leaving := cell (vertex_rows t) leaving_cell;
  says_isolated := cell (vertex_rows t) isolated_cell;
  says_boundary_face := cell (boundary_rows t) face_cell;
  says_boundary_start := cell (boundary_rows t) start_cell;
  says_boundary_place := cell (boundary_rows t) place_cell;
  says_outer := cell (face_rows t) outer_cell;
  says_inner_count := fun f => if row (face_rows t) f is Some r then size (inner_cells r) else 0;
  says_inner := fun f i => if row (face_rows t) f is Some r then nth None (inner_cells r) i else None
|}.

(** Links as a table shows them. *)
Notation "'nil" := (None : link) (at level 0).
Notation "# i" := (Some i) (at level 0, i at level 0).
