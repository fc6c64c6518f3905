(** * Columns: a certificate as a folder of files

    What the bytes of the files of CERTIFICATE.md mean: a view, and a rank for each of its half-edges. This is the reader
    of the extracted checker; what is left to OCaml is to read the files into memory.

<<
      half_edge_twin.u32     01 00 00 00 │ 00 00 00 00 │ FF FF FF FF │ …       twin(0) = 1, twin(1) = 0, twin(2) is nil
>>
*)

From Coq Require Import ZArith.
From mathcomp Require Import all_ssreflect.
From twinedge Require Import View Loops Coordinates.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** ** Bytes and numbers *)

(** The content of a file. *)
Definition file := seq nat.
Definition bytes_in (f : file) : nat := size f.
Definition byte (f : file) (i : nat) : nat := nth 0 f i.

Definition four := 4.
Definition base := 256.
Definition highest := 255.
Definition second_highest := 254.

(** The number at position [i]: four bytes, the lowest first. *)
Definition number_at (f : file) i : nat :=
  let k := four * i in
  byte f k + base * (byte f (k + 1) + base * (byte f (k + 2) + base * byte f (k + 3))).

Definition high_bytes (f : file) i : bool :=
  let k := four * i in [&& byte f (k + 3) == highest, byte f (k + 2) == highest & byte f (k + 1) == highest].

Definition is_nil_at f i : bool := high_bytes f i && (byte f (four * i) == highest).
Definition is_vacant_at f i : bool := high_bytes f i && (byte f (four * i) == second_highest).

Definition link_at f i : link := if is_nil_at f i then None else Some (number_at f i).

(** ** The folder *)

Record folder := Folder {
  claim : file;
  half_edge_rows : nat;
  vertex_rows : nat;
  boundary_rows : nat;
  face_rows : nat;
  inner_rows : nat;
  half_edge_origin : file;
  half_edge_twin : file;
  half_edge_next : file;
  half_edge_prev : file;
  half_edge_boundary : file;
  half_edge_rank : file;
  vertex_leaving : file;
  vertex_isolated : file;
  boundary_face_column : file;
  boundary_start_column : file;
  boundary_vertex_column : file;
  boundary_place_column : file;
  face_outer : file;
  face_end : file;
  face_inner : file
}.

(** "twinedge certificate 1", "plane", "drawing" and "surface", each with the end of its line. *)
Definition first_line : seq nat :=
  [:: 116; 119; 105; 110; 101; 100; 103; 101; 32; 99; 101; 114; 116; 105; 102; 105; 99; 97; 116; 101; 32; 49; 10].
Definition plane_line : seq nat := [:: 112; 108; 97; 110; 101; 10].
Definition drawing_line : seq nat := [:: 100; 114; 97; 119; 105; 110; 103; 10].
Definition surface_line : seq nat := [:: 115; 117; 114; 102; 97; 99; 101; 10].

Fixpoint begins_with (f : file) i (s : seq nat) : bool :=
  if s is a :: r then if byte f i == a then begins_with f i.+1 r else false else true.

Definition fits n (f : file) : bool := bytes_in f == four * n.

Definition readable (line : seq nat) (o : folder) : bool :=
  [&& begins_with (claim o) 0 (first_line ++ line),
      [&& fits (half_edge_rows o) (half_edge_origin o), fits (half_edge_rows o) (half_edge_twin o),
          fits (half_edge_rows o) (half_edge_next o), fits (half_edge_rows o) (half_edge_prev o),
          fits (half_edge_rows o) (half_edge_boundary o) & fits (half_edge_rows o) (half_edge_rank o)],
      fits (vertex_rows o) (vertex_leaving o) && fits (vertex_rows o) (vertex_isolated o),
      [&& fits (boundary_rows o) (boundary_face_column o), fits (boundary_rows o) (boundary_start_column o),
          fits (boundary_rows o) (boundary_vertex_column o) & fits (boundary_rows o) (boundary_place_column o)]
    & [&& fits (face_rows o) (face_outer o), fits (face_rows o) (face_end o) & fits (inner_rows o) (face_inner o)]].

(** ** The view and the ranks *)

Definition start_at (o : folder) b : option start :=
  match link_at (boundary_start_column o) b, link_at (boundary_vertex_column o) b with
  | Some h, None => Some (AtHalfEdge h)
  | None, Some v => Some (AtVertex v)
  | _, _ => None
  end.

Definition place_at (o : folder) b : option place :=
  if link_at (boundary_place_column o) b is Some i then Some (Inner i) else Some Outer.

Definition list_begin (o : folder) f : nat := if f is g.+1 then number_at (face_end o) g else 0.
Definition entry_at (o : folder) f i : link :=
  let k := list_begin o f + i in if k < inner_rows o then link_at (face_inner o) k else None.

Definition view_in (o : folder) : view := {|
  vertex_slots := vertex_rows o;
  half_edge_slots := half_edge_rows o;
  boundary_slots := boundary_rows o;
  face_slots := face_rows o;
  is_vertex := fun v => ~~ is_vacant_at (vertex_leaving o) v;
  is_half_edge := fun h => ~~ is_vacant_at (half_edge_origin o) h;
  is_boundary := fun b => ~~ is_vacant_at (boundary_face_column o) b;
  is_face := fun f => ~~ is_vacant_at (face_outer o) f;
  says_origin := link_at (half_edge_origin o);
  says_twin := link_at (half_edge_twin o);
  says_next := link_at (half_edge_next o);
  says_prev := link_at (half_edge_prev o);
  says_boundary := link_at (half_edge_boundary o);
  says_leaving := link_at (vertex_leaving o);
  says_isolated := link_at (vertex_isolated o);
  says_boundary_face := link_at (boundary_face_column o);
  says_boundary_start := start_at o;
  says_boundary_place := place_at o;
  says_outer := link_at (face_outer o);
  says_inner_count := fun f => number_at (face_end o) f - list_begin o f;
  says_inner := entry_at o
|}.

Definition ranks_in (o : folder) : nat -> nat := number_at (half_edge_rank o).

(** ** The surface *)

(** The columns of [topology] that a surface does not have are not looked at. *)
Record surface := Surface {
  surface_topology : folder;
  half_edge_turn : file;
  half_edge_step : file;
  half_edge_component : file;
  vertex_border : file
}.

Definition readable_surface (s : surface) : bool :=
  let o := surface_topology s in
  [&& begins_with (claim o) 0 (first_line ++ surface_line),
      [&& fits (half_edge_rows o) (half_edge_origin o), fits (half_edge_rows o) (half_edge_twin o),
          fits (half_edge_rows o) (half_edge_next o), fits (half_edge_rows o) (half_edge_prev o)
        & fits (half_edge_rows o) (half_edge_boundary o)],
      [&& fits (half_edge_rows o) (half_edge_turn s), fits (half_edge_rows o) (half_edge_step s),
          fits (half_edge_rows o) (half_edge_component s) & fits (half_edge_rows o) (half_edge_rank o)],
      fits (vertex_rows o) (vertex_leaving o) && fits (vertex_rows o) (vertex_border s)
    & [&& fits (boundary_rows o) (boundary_face_column o), fits (boundary_rows o) (boundary_start_column o)
        & fits (face_rows o) (face_outer o)]].

(** Boundary components are cycles, and each is the outer one of its face. *)
Definition surface_view_in (s : surface) : view :=
  let o := surface_topology s in {|
  vertex_slots := vertex_rows o;
  half_edge_slots := half_edge_rows o;
  boundary_slots := boundary_rows o;
  face_slots := face_rows o;
  is_vertex := is_vertex (view_in o);
  is_half_edge := is_half_edge (view_in o);
  is_boundary := is_boundary (view_in o);
  is_face := is_face (view_in o);
  says_origin := says_origin (view_in o);
  says_twin := says_twin (view_in o);
  says_next := says_next (view_in o);
  says_prev := says_prev (view_in o);
  says_boundary := says_boundary (view_in o);
  says_leaving := says_leaving (view_in o);
  says_isolated := fun _ => None;
  says_boundary_face := says_boundary_face (view_in o);
  says_boundary_start := fun b => if link_at (boundary_start_column o) b is Some h then Some (AtHalfEdge h) else None;
  says_boundary_place := fun _ => Some Outer;
  says_outer := says_outer (view_in o);
  says_inner_count := fun _ => 0;
  says_inner := fun _ _ => None
|}.

Definition turns_in (s : surface) : nat -> nat := number_at (half_edge_turn s).
Definition steps_in (s : surface) : nat -> nat := number_at (half_edge_step s).
Definition components_in (s : surface) : nat -> nat := number_at (half_edge_component s).
Definition surface_ranks_in (s : surface) : nat -> nat := ranks_in (surface_topology s).
Definition borders_in (s : surface) : nat -> link := link_at (vertex_border s).

(** ** The drawing *)

Definition eight := 8.

(** The signed number at position [i]: eight bytes, the lowest first, of two's complement, of which the last one repeats the
    sign. Only numbers from −2^53 to 2^53 are [in_range], so that seven bytes are enough. *)

Definition wrap : Z := (2 ^ 56)%Z.

Definition integer_at (f : file) i : Z :=
  let k := eight * i in
  (Z.of_nat (byte f k + base * (byte f (k + 1) + base * (byte f (k + 2) + base * (byte f (k + 3)
    + base * (byte f (k + 4) + base * (byte f (k + 5) + base * byte f (k + 6)))))))
   - if byte f (k + 7) == highest then wrap else 0)%Z.

Definition in_range (f : file) i : bool :=
  let k := eight * i in
  (byte f (k + 7) == 0) && (byte f (k + 6) < 32) || (byte f (k + 7) == highest) && (223 < byte f (k + 6)).

Record drawing := Drawing {
  topology : folder;
  triangle_rows : nat;
  point_rows : nat;
  dart_twin_column : file;
  dart_point_column : file;
  dart_half_edge_column : file;
  dart_ahead_column : file;
  dart_face_column : file;
  dart_rank_column : file;
  point_x : file;
  point_y : file;
  half_edge_dart_column : file;
  vertex_dart_column : file;
  face_dart_column : file
}.

Definition readable_drawing (o : drawing) : bool :=
  let darts := 3 * triangle_rows o in
  [&& readable drawing_line (topology o),
      [&& fits darts (dart_twin_column o), fits darts (dart_point_column o), fits darts (dart_half_edge_column o),
          fits darts (dart_ahead_column o), fits darts (dart_face_column o) & fits darts (dart_rank_column o)],
      [&& fits (half_edge_rows (topology o)) (half_edge_dart_column o), fits (vertex_rows (topology o)) (vertex_dart_column o)
        & fits (face_rows (topology o)) (face_dart_column o)],
      [&& bytes_in (point_x o) == eight * point_rows o, bytes_in (point_y o) == eight * point_rows o
        & vertex_rows (topology o) <= point_rows o],
      all_below darts (fun d => number_at (dart_point_column o) d < point_rows o)
    & all_below (point_rows o) (fun i => in_range (point_x o) i && in_range (point_y o) i)].

Definition point_in (o : drawing) i : Z * Z := (integer_at (point_x o) i, integer_at (point_y o) i).

Definition refinement_in (o : drawing) : refinement := {|
  triangle_count := triangle_rows o;
  dart_twin := number_at (dart_twin_column o);
  dart_point := number_at (dart_point_column o);
  dart_half_edge := link_at (dart_half_edge_column o);
  dart_ahead := number_at (dart_ahead_column o);
  dart_face := number_at (dart_face_column o);
  dart_rank := number_at (dart_rank_column o);
  point_at := point_in o;
  half_edge_dart := number_at (half_edge_dart_column o);
  vertex_dart := number_at (vertex_dart_column o);
  face_dart := number_at (face_dart_column o)
|}.
