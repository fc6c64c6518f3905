(** * View: what the validator asks of a structure (structure/view.rs)

    The trait `View` as a record of Coq. A structure has slots for vertices, half-edges, boundary components and faces.
    It says which slots are live, and it answers questions about them. An answer may be nil, may lead nowhere, may lead
    to a vacant slot, and may contradict any other answer: nothing is assumed of it.

<<
      trait View                              record view
      fn half_edge_slots(&self) -> usize      half_edge_slots : nat
      fn is_half_edge(&self, h) -> bool       is_half_edge    : nat -> bool
      fn next(&self, h) -> Option<usize>      says_next       : nat -> option nat
>>

    What differs from Rust: a number has no upper bound here, and an answer stays the same from call to call. *)

From mathcomp Require Import all_ssreflect.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** `Link`: nil, or the number of a slot, which may not exist. *)
Definition link := option nat.

(** `Start`: where a boundary component starts. *)
Inductive start := AtHalfEdge of nat | AtVertex of nat.

(** `Place`: where a boundary component says that its face lists it. *)
Inductive place := Outer | Inner of nat.

Record view := View {
  vertex_slots : nat;
  half_edge_slots : nat;
  boundary_slots : nat;
  face_slots : nat;
  is_vertex : nat -> bool;
  is_half_edge : nat -> bool;
  is_boundary : nat -> bool;
  is_face : nat -> bool;
  says_origin : nat -> link;
  says_twin : nat -> link;
  says_next : nat -> link;
  says_prev : nat -> link;
  says_boundary : nat -> link;
  says_leaving : nat -> link;
  says_isolated : nat -> link;
  says_boundary_face : nat -> link;
  says_boundary_start : nat -> option start;
  says_boundary_place : nat -> option place;
  says_outer : nat -> link;
  says_inner_count : nat -> nat;
  says_inner : nat -> nat -> link
}.

(** A record is live if its slot exists and is not vacant. *)

Definition vertex t v := (v < vertex_slots t) && is_vertex t v.
Definition half_edge t h := (h < half_edge_slots t) && is_half_edge t h.
Definition boundary t b := (b < boundary_slots t) && is_boundary t b.
Definition face t f := (f < face_slots t) && is_face t f.

(** Answers are heard of live records only, as in reference/rules.rs: all others are nil. *)

Definition heard T (live : nat -> bool) (says : nat -> option T) i : option T := if live i then says i else None.

Definition origin t := heard (half_edge t) (says_origin t).
Definition twin t := heard (half_edge t) (says_twin t).
Definition next t := heard (half_edge t) (says_next t).
Definition prev t := heard (half_edge t) (says_prev t).
Definition boundary_of t := heard (half_edge t) (says_boundary t).
Definition leaving t := heard (vertex t) (says_leaving t).
Definition isolated t := heard (vertex t) (says_isolated t).
Definition boundary_face t := heard (boundary t) (says_boundary_face t).
Definition boundary_start t := heard (boundary t) (says_boundary_start t).
Definition boundary_place t := heard (boundary t) (says_boundary_place t).
Definition outer t := heard (face t) (says_outer t).
Definition inner_count t f := if face t f then says_inner_count t f else 0.

(** The inner boundary component at position [i] of the list of face [f], if the list is that long. *)
Definition inner t f i : link := if i < inner_count t f then says_inner t f i else None.

(** [l >>= says]: the link [l] is followed. Nil is followed to nil. *)
Notation "l >>= says" := (obind says l) (at level 50, left associativity).

(** The end of a half-edge: the origin of its twin. *)
Definition target t h := twin t h >>= origin t.

(** The next half-edge, clockwise, with the same origin: `next(twin(h))`. *)
Definition turn t h := twin t h >>= next t.

(** [y] is [x], or what [step] leads to from [x] in so many steps. *)
Definition on_orbit (step : nat -> link) x y := exists n, iter n (obind step) (Some x) = Some y.
