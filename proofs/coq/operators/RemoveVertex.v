(** * RemoveVertex: removing an isolated vertex keeps all rules (dcel/operators/inner.rs)

    The isolated vertex [v] and its boundary component [b] are taken away, and the lists are made anew. Adding the vertex makes the
    same again (AddVertex.v).

<<
      f ┌────────────┐          f ┌────────────┐
        │    · v     │    ──►     │            │
        └────────────┘            └────────────┘
>>
*)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import Arith View Rules Map Counting Lists Core Tidy.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** The view [t] without [v] and [b]; places and lists are as they were. *)
Definition without t v b : view := {|
  vertex_slots := vertex_slots t;
  half_edge_slots := half_edge_slots t;
  boundary_slots := boundary_slots t;
  face_slots := face_slots t;
  is_vertex := fun u => (u != v) && is_vertex t u;
  is_half_edge := is_half_edge t;
  is_boundary := fun d => (d != b) && is_boundary t d;
  is_face := is_face t;
  says_origin := says_origin t;
  says_twin := says_twin t;
  says_next := says_next t;
  says_prev := says_prev t;
  says_boundary := says_boundary t;
  says_leaving := says_leaving t;
  says_isolated := says_isolated t;
  says_boundary_face := says_boundary_face t;
  says_boundary_start := says_boundary_start t;
  says_boundary_place := says_boundary_place t;
  says_outer := says_outer t;
  says_inner_count := says_inner_count t;
  says_inner := says_inner t
|}.

Definition remove_isolated_vertex t v b := relist (without t v b) (inn_of t).

Section Without.
Variables (t : view) (v b : nat).
Hypothesis keeps : rules t.
Hypothesis isolated_v : isolated t v = Some b.

Notation t' := (without t v b).
Notation inn := (inn_of t).
Let low : lower t. Proof. by move=> q _; apply: keeps. Qed.
Let map : is_map t := low_map low.
Let c : core t inn := core_of_rules keeps.
Let r : rest t inn := rest_of_rules keeps.
Let bare_v : bare t v. Proof. by have [] := core_isolated c isolated_v. Qed.
Let inner_b : inn b. Proof. by have [] := core_isolated c isolated_v. Qed.
Let none_on_b i : boundary_of t i <> Some b. Proof. by have [_ _] := core_isolated c isolated_v; apply. Qed.

Lemma vertexE u : vertex t' u = (u != v) && vertex t u. Proof. by rewrite /vertex /= andbCA. Qed.
Lemma boundaryE d : boundary t' d = (d != b) && boundary t d. Proof. by rewrite {1}/boundary /= andbCA. Qed.

Lemma isolatedE u : isolated t' u = if u == v then None else isolated t u.
Proof. by rewrite {1}/isolated /heard vertexE; case: (u == v). Qed.
Lemma boundary_faceE d : boundary_face t' d = if d == b then None else boundary_face t d.
Proof. by rewrite {1}/boundary_face /heard boundaryE; case: (d == b). Qed.

Lemma passes_v u : passes t b u -> u = v.
Proof. by case=> [[i /none_on_b]|I] //; apply: (core_one c I). Qed.

Lemma passes_left d u : d <> b -> passes t d u -> passes t' d u.
Proof.
move=> db [P|I]; [by left|right]; rewrite isolatedE; case: eqP => // uv.
by case: db; move: I; rewrite uv isolated_v => -[].
Qed.

Lemma connected_left u w : connected t u w -> connected t' u w.
Proof. by elim=> [|i x y _ IH X Y]; [apply: connected_self|apply: (@connected_edge t' u i x y)]. Qed.

Lemma connected_v u : connected t u v -> u = v.
Proof. by move/(connected_sym map)/(connected_bare map (low_v2 low) bare_v). Qed.

Lemma no_outer_left f : no_outer t' inn f <-> no_outer t inn f.
Proof.
split=> no d F; last by apply: no; move: F; rewrite boundary_faceE; case: ifP.
by case: (d =P b) => [-> //|db]; apply: no; rewrite boundary_faceE (introF eqP db).
Qed.

Lemma without_out f : steps_out t inn f -> steps_out t' inn f.
Proof.
elim=> {f} [f lf no|f d u e w g F I P J Q C G _ IH]; first by apply: out_here => //; apply/no_outer_left.
have db : d <> b by move=> E; move: I; rewrite E inner_b.
have eb : e <> b.
  move=> E; rewrite E in Q; have wv := passes_v Q; rewrite wv in C; have uv := connected_v C.
  case: P => [[i _ O]|K]; first by case: (bare_v (heard_live O)); rewrite O uv.
  by case: db; move: K; rewrite uv isolated_v => -[].
apply: (@out_through t' inn f d u e w g) => //; try exact: passes_left; try exact: connected_left;
  by rewrite boundary_faceE ?(introF eqP db) ?(introF eqP eb).
Qed.

Lemma without_core : core t' inn.
Proof.
split; try by [apply: (core_twin c)|apply: (core_next c)|apply: (core_target c)|apply: (core_rotation c)|apply: (core_side c)
  |apply: (core_cycle c)].
- move=> i li; have [[u U lu] T N [d B ld]] := core_live c li; split=> //.
    by exists u => //; rewrite vertexE lu andbT; apply/eqP=> uv; case: (bare_v li); rewrite -uv.
  by exists d => //; rewrite boundaryE ld andbT; apply/eqP=> db; case: (@none_on_b i); rewrite -db.
- move=> u; rewrite vertexE isolatedE => /andP[/eqP uv lu] B; rewrite (introF eqP uv).
  have [d I ld] := core_bare c lu B; exists d => //; rewrite boundaryE ld andbT; apply/eqP=> db.
  by apply: uv; apply: (core_one c I); rewrite db.
- by move=> u d; rewrite isolatedE; case: eqP => // _; apply: (core_isolated c).
- by move=> u w d; rewrite !isolatedE; case: eqP => // _; case: eqP => // _; apply: (core_one c).
- move=> d; rewrite boundaryE => /andP[/eqP db ld]; have [u P] := core_used c ld; exists u; exact: passes_left.
- by move=> d; rewrite boundaryE boundary_faceE => /andP[/negPf-> ld]; apply: (core_face c).
- move=> d e Id Ie; have no x : ~~ inn x -> x == b = false by move=> I; apply/eqP=> E; move: I; rewrite E inner_b.
  by rewrite !boundary_faceE !no // boundaryE => F /andP[_]; apply: (core_outer c).
- have [f [[lf no] one]] := core_unbounded c; exists f; split; first by split=> //; apply/no_outer_left.
  by move=> g [lg /no_outer_left]; move=> no'; apply: one.
- move=> u; rewrite vertexE => /andP[/eqP uv lu]; have [d [w [ld I P C]]] := core_inside c lu.
  have db : d <> b by move=> E; rewrite E in P; apply: uv; apply: connected_v; rewrite -(passes_v P).
  by exists d, w; split=> //; [rewrite boundaryE ld andbT; apply/eqP|apply: passes_left|apply: connected_left].
- by move=> f lf; apply/without_out/(core_out c).
have [vs [hs [fs [bs [Hv Hh Hf Hb eq]]]]] := core_counts c.
have lb : boundary t b /\ inn b by split=> //; have [d + ld] := core_bare c (heard_live isolated_v) bare_v; rewrite isolated_v => -[->].
exists (rem v vs), hs, fs, (rem b bs); split=> //.
- by apply: lists_iff (lists_rem v Hv) => u; rewrite vertexE; split=> [[/eqP->]|/andP[/eqP]].
- apply: lists_iff (lists_rem b Hb) => d; rewrite boundaryE.
  by split=> [[/eqP-> []]|[/andP[/eqP db ld] I]].
by move: eq; rewrite (size_lists_rem Hv (heard_live isolated_v)) (size_lists_rem Hb lb); arith.
Qed.

Lemma without_rules : rules (relist t' inn).
Proof.
apply: relist_rules without_core _ _ _ => [i li|u|d]; first exact: (rest_prev r).
  rewrite vertexE => /andP[uv lu]; have -> : leaving t' u = leaving t u by rewrite /leaving /heard vertexE uv lu.
  exact: (rest_leaving r lu).
move=> ld'; have := ld'; rewrite boundaryE => /andP[/eqP db ld].
have -> : boundary_start t' d = boundary_start t d by rewrite /boundary_start /heard ld' ld.
case: (rest_start r ld) => [|[u S I]]; [by left|right; exists u => //].
by rewrite isolatedE; case: eqP => // uv; case: db; move: I; rewrite uv isolated_v => -[].
Qed.

End Without.

(** If all rules held before, they hold after. *)
Theorem remove_isolated_vertex_keeps_rules t v b : isolated t v = Some b -> rules t -> rules (remove_isolated_vertex t v b).
Proof. by move=> I keeps; apply: without_rules. Qed.
