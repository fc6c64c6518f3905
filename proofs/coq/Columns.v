(** * Columns: a certificate as a folder of files

    What the bytes of the files of CERTIFICATE.md mean: a view, and a rank for each of its half-edges. This is the reader
    of the extracted checker; what is left to OCaml is to read the files into memory.

<<
      half_edge_twin.u32     01 00 00 00 │ 00 00 00 00 │ FF FF FF FF │ …       twin(0) = 1, twin(1) = 0, twin(2) is nil
>>
*)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import View.
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

(** "twinedge certificate 1" and "plane", each with the end of its line. *)
Definition first_line : seq nat :=
  [:: 116; 119; 105; 110; 101; 100; 103; 101; 32; 99; 101; 114; 116; 105; 102; 105; 99; 97; 116; 101; 32; 49; 10].
Definition plane_line : seq nat := [:: 112; 108; 97; 110; 101; 10].

Fixpoint begins_with (f : file) i (s : seq nat) : bool :=
  if s is a :: r then if byte f i == a then begins_with f i.+1 r else false else true.

Definition fits n (f : file) : bool := bytes_in f == four * n.

Definition readable (o : folder) : bool :=
  [&& begins_with (claim o) 0 (first_line ++ plane_line),
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
