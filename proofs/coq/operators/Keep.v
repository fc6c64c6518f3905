(** * Keep: which half-edge a vertex or a boundary component keeps does not matter

    A vertex keeps any half-edge that leaves it, and a boundary component starts at any half-edge on it. An operator that keeps
    other ones than the Rust code does the same. *)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import View Rules Core Tidy.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** The view [t], in which the vertex [u] keeps [leaves u], and the boundary component [b] starts at [starts b], if these may. *)
Definition keep_others t (leaves starts : nat -> link) : view := {|
  vertex_slots := vertex_slots t;
  half_edge_slots := half_edge_slots t;
  boundary_slots := boundary_slots t;
  face_slots := face_slots t;
  is_vertex := is_vertex t;
  is_half_edge := is_half_edge t;
  is_boundary := is_boundary t;
  is_face := is_face t;
  says_origin := says_origin t;
  says_twin := says_twin t;
  says_next := says_next t;
  says_prev := says_prev t;
  says_boundary := says_boundary t;
  says_leaving := fun u => if leaves u >>= origin t == Some u then leaves u else says_leaving t u;
  says_isolated := says_isolated t;
  says_boundary_face := says_boundary_face t;
  says_boundary_start := fun b => if starts b >>= boundary_of t == Some b then omap AtHalfEdge (starts b) else
    says_boundary_start t b;
  says_boundary_place := says_boundary_place t;
  says_outer := says_outer t;
  says_inner_count := says_inner_count t;
  says_inner := says_inner t
|}.

(** If all rules held before, they hold after. *)
Theorem keep_others_keeps_rules t leaves starts : rules t -> rules (keep_others t leaves starts).
Proof.
move=> keeps; have r := rest_of_rules keeps; apply: (core_rules (core_same _ _ _ _ _ _ _ _ _ _ (core_of_rules keeps))) => //.
split; try by [apply: (rest_prev r)|apply: (rest_place r)|apply: (rest_listed r)|apply: (rest_lists r)].
- move=> v lv; have lv' : vertex t v := lv; have := rest_leaving r lv'; rewrite /leaving /heard lv lv' /=.
  by case: eqP => // E _; left; case: (leaves v) E => [h|] // O; exists h.
move=> b lb; have lb' : boundary t b := lb; have := rest_start r lb'; rewrite /boundary_start /heard lb lb' /=.
by case: eqP => // E _; left; case: (starts b) E => [h|] // B; exists h.
Qed.
