(** * AnyInner: wherever a face lists an inner boundary component, it can be moved (inner.rs)

    MoveInner.v moves the last entry of a list. Any other entry changes places with the last one first, as in the Rust code,
    where the last one takes the place of what leaves. The order of a list does not matter (Renaming.v).

<<
      f lists   5  b  7  2          b and the last one change places         f lists   5  2  7
      g lists   3                   ── then b is moved ──►                   g lists   3  b
>>
*)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import View Rules Map Lists Renaming MoveInner.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** [i] and [j] change places. *)
Definition swap (i j n : nat) := if n == i then j else if n == j then i else n.

(** The view [t], in which the entries [i] and [j] of the list of the face [f] have changed places. *)
Definition exchange t f i j : view := {|
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
  says_leaving := says_leaving t;
  says_isolated := says_isolated t;
  says_boundary_face := says_boundary_face t;
  says_boundary_start := says_boundary_start t;
  says_boundary_place := fun c => if says_boundary_place t c is Some (Inner n) then
    Some (Inner (if boundary_face t c == Some f then swap i j n else n)) else says_boundary_place t c;
  says_outer := says_outer t;
  says_inner_count := says_inner_count t;
  says_inner := fun g n => says_inner t g (if g == f then swap i j n else n)
|}.

Lemma swapK i j : involutive (swap i j).
Proof.
move=> n; rewrite /swap; case: (n =P i) => [->|ni]; first by rewrite eqxx; case: (j =P i) => [->|].
case: (n =P j) => [->|nj]; first by rewrite eqxx.
by case: eqP => // _; case: eqP.
Qed.

Lemma swap_below i j m n : i < m -> j < m -> n < m -> swap i j n < m.
Proof. by rewrite /swap; case: (n == i) => //; case: (n == j). Qed.

Section AnyInner.
Variables (t : view) (f i j : nat).
Hypothesis lt_i : i < inner_count t f.
Hypothesis lt_j : j < inner_count t f.

Notation t' := (exchange t f i j).

Lemma exchanged_place c : boundary_place t' c = if boundary_place t c is Some (Inner n) then
  Some (Inner (if boundary_face t c == Some f then swap i j n else n)) else boundary_place t c.
Proof. by rewrite /boundary_place /heard -[boundary t' c]/(boundary t c); case: (boundary t c). Qed.

Lemma exchanged_inner g n : n < inner_count t g ->
  (if g == f then swap i j n else n) < inner_count t g /\ inner t' g (if g == f then swap i j n else n) = inner t g n.
Proof.
move=> lt; have lt' : (if g == f then swap i j n else n) < inner_count t g.
  by case: eqP lt => // -> lt; apply: swap_below.
split=> //; rewrite {1}/inner -[inner_count t' g]/(inner_count t g) lt' /= /inner lt.
by case: (g == f); rewrite ?swapK.
Qed.

Lemma exchange_renames : renaming t t' id id id id (fun g n => if g == f then swap i j n else n).
Proof.
have same (live : nat -> bool) : renumbers id live live.
  by split=> // n; split=> [l|[m l <-] //]; exists n.
have nothing (l : link) : omap id l = l by case: l.
split=> //; rewrite -?[vertex t']/(vertex t) -?[half_edge t']/(half_edge t) -?[boundary t']/(boundary t) -?[face t']/(face t);
  try exact: same.
- move=> c g lc E; rewrite exchanged_place E /=; split=> //.
    by rewrite -[boundary_start t' c]/(boundary_start t c); case: (boundary_start t c) => [[]|].
  by case: (boundary_place t c) => [[|n]|] //=.
- by move=> g n lg lt; rewrite nothing; apply: exchanged_inner.
move=> g n lg lt; exists (if g == f then swap i j n else n); first by case: (exchanged_inner lt).
by case: (g == f); rewrite ?swapK.
Qed.

Lemma exchanged_connected u w : connected t' u w <-> connected t u w.
Proof.
split; first by elim=> [|h x y _ IH O T]; [apply: connected_self|apply: connected_edge IH O T].
by elim=> [|h x y _ IH O T]; [apply: connected_self|apply: (@connected_edge t') IH O T].
Qed.

Lemma exchanged_outside w c : outside_of t' w c <-> outside_of t w c.
Proof.
have I : is_inner t' c <-> is_inner t c.
  rewrite /is_inner exchanged_place; case: (boundary_place t c) => [[|n]|] //.
  by split=> _; [exists n|eexists].
by split=> -[/I P [x W /exchanged_connected C]]; split=> //; exists x => //; apply/exchanged_connected.
Qed.

Lemma exchanged_inside b g : inside t' b g <-> inside t b g.
Proof.
split.
  elim=> [h c w E W /exchanged_outside O|h c w d h' E W /exchanged_outside O D _ IH].
    exact: (@inside_here t b h c w).
  exact: (@inside_deeper t b h c w d h').
elim=> [h c w E W /exchanged_outside O|h c w d h' E W /exchanged_outside O D _ IH].
  exact: (@inside_here t' b h c w).
exact: (@inside_deeper t' b h c w d h').
Qed.

End AnyInner.

(** Moving the inner boundary component [b], the entry [i] of the list of the face [f], to the face [g] keeps all rules if
    and only if that face is not inside its component. *)
Theorem move_any_inner_keeps_rules t b f i g : rules t -> boundary_face t b = Some f ->
  boundary_place t b = Some (Inner i) -> face t g -> g != f ->
  rules (move_inner (exchange t f i (inner_count t f).-1) b f g) <-> ~ inside t b g.
Proof.
move=> keeps E P lg gf; have [f' [p [Ef Ep L]]] := keeps F2 b (heard_live E).
have lt : i < inner_count t f.
  by move: Ef Ep L; rewrite E P => -[<-] [<-] /(_ f (Inner i))[_ /(_ (conj erefl erefl))]; rewrite /= /inner; case: ifP.
have lt' : (inner_count t f).-1 < inner_count t f by rewrite (ltn_predK lt).
have keeps' := renaming_keeps (exchange_renames lt lt') keeps.
apply: iff_trans (move_inner_keeps_rules keeps' E _ lg gf) _.
  by rewrite exchanged_place P E eqxx /swap eqxx.
have same := exchanged_inside t f i (inner_count t f).-1 b g.
by split=> no /same.
Qed.
