(** * AddVertex: adding an isolated vertex to a face keeps all rules (dcel/operators/inner.rs)

    The operator writes two new rows and one new entry, and touches nothing else.

<<
      f ┌────────────┐          f ┌────────────┐       vertex v:     leaving nil, isolated b
        │            │    ──►     │    · v     │       boundary b:   face f, starts at v, the last inner one of f
        └────────────┘            └────────────┘       face f:       one inner one more
>>
*)

From mathcomp Require Import all_ssreflect all_fingroup.
From twinedge Require Import View Rules Map Drawing Subdivision Represented Verdict NewEdge.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** The view [t] with an isolated vertex [v] added to the face [f], as the boundary component [b]. *)
Definition add_isolated_vertex t v b f : view := {|
  vertex_slots := maxn (vertex_slots t) v.+1;
  half_edge_slots := half_edge_slots t;
  boundary_slots := maxn (boundary_slots t) b.+1;
  face_slots := face_slots t;
  is_vertex := fun i => (i == v) || vertex t i;
  is_half_edge := is_half_edge t;
  is_boundary := fun i => (i == b) || boundary t i;
  is_face := is_face t;
  says_origin := says_origin t;
  says_twin := says_twin t;
  says_next := says_next t;
  says_prev := says_prev t;
  says_boundary := says_boundary t;
  says_leaving := fun i => if i == v then None else says_leaving t i;
  says_isolated := fun i => if i == v then Some b else says_isolated t i;
  says_boundary_face := fun i => if i == b then Some f else says_boundary_face t i;
  says_boundary_start := fun i => if i == b then Some (AtVertex v) else says_boundary_start t i;
  says_boundary_place := fun i => if i == b then Some (Inner (inner_count t f)) else says_boundary_place t i;
  says_outer := says_outer t;
  says_inner_count := fun i => if i == f then (inner_count t f).+1 else says_inner_count t i;
  says_inner := fun i j => if (i == f) && (j == inner_count t f) then Some b else says_inner t i j
|}.

(** ** The same for subdivisions *)

Section Subdivided.
Variables (s : subdivision) (g : faces s).

Definition tail_more (x : darts s) : option (vertices s) := Some (tail x).
Definition piece_more (v : option (vertices s)) : option (pieces s) := omap (@piece s) v.
Definition lies_more (p : option (pieces s)) : faces s := if p is Some q then lies_in q else g.

Notation edge := (edge_between (@other s) (@tail s)).
Notation edge_more := (edge_between (@other s) tail_more).

Lemma edge_some v w : edge_more (Some v) (Some w) = edge v w.
Proof. by []. Qed.

Lemma edge_none v w : edge_more v w -> exists v' w', v = Some v' /\ w = Some w'.
Proof. by case/existsP=> x /andP[/eqP <- /eqP <-]; exists (tail x), (tail (other x)). Qed.

Lemma connect_some v w : connect edge_more (Some v) w -> exists2 w', w = Some w' & connect edge v w'.
Proof.
case/connectP=> p; elim: p v => [|u p IH] v /=; first by move=> _ ->; exists v.
case/andP=> e; have [v' [u' [[_] uu]]] := edge_none e; move: e; rewrite uu edge_some => vu pp E.
by have [w' -> uw] := IH u' pp E; exists w' => //; apply: connect_trans (connect1 vu) uw.
Qed.

Lemma connect_more v w : connect edge v w -> connect edge_more (Some v) (Some w).
Proof.
case/connectP=> p; elim: p v => [|u p IH] v /=; first by move=> _ ->.
by case/andP=> vu /IH/[apply]; apply: connect_trans; apply: connect1; rewrite edge_some.
Qed.

Lemma connected_more v w : (piece_more v == piece_more w) = connect edge_more v w.
Proof.
apply/eqP/idP; case: v w => [v|] [w|] //=.
- by move=> [] /eqP; rewrite piece_connected; apply: connect_more.
- by case/connect_some=> w' [->]; rewrite -piece_connected => /eqP ->.
- by case/connect_some.
by case/connectP=> [[|u p]] //= /andP[/edge_none[? [? []]]].
Qed.

Lemma inhabited_more p : exists v, piece_more v = p.
Proof. by case: p => [p|]; [case: (piece_inhabited p) => v <-; exists (Some v) | exists None]. Qed.

Lemma one_outside_more (x : darts s) : exists2 y, outside y /\ piece_more (tail_more y) = piece_more (tail_more x) &
  forall z, outside z -> piece_more (tail_more z) = piece_more (tail_more x) -> same_walk (rotation s) (@other s) y z.
Proof.
by have [y [oy yx] one] := one_outside x; exists y; [rewrite /= yx | move=> z oz [/(one z oz)]].
Qed.

Lemma put_down_more : exists2 ps, uniq ps /\ (forall p, p \in ps) &
  put_down tail_more piece_more (@outside s) (@left s) lies_more (unbounded_face s) ps.
Proof.
have [ps [u all] down] := one_by_one s; exists (None :: map Some ps).
  split=> [|[p|]]; last exact: mem_head; last by rewrite inE map_f.
  by rewrite /= map_inj_uniq ?u ?andbT => [|p q []//]; apply/mapP=> -[].
split; last first.
  elim: ps {u all} down => //= p ps IH [th /IH down]; split=> //.
  by case: th => [->|[x [no xp px]]]; [left | right; exists x; split=> //; apply: map_f].
case: (eqVneq g (unbounded_face s)) => [gu|/bounded[x no xg]]; first by left.
by right; exists x; split=> //; apply: map_f.
Qed.

Definition add_vertex : subdivision :=
  @Subdivision _ (darts s) _ (faces s) (rotation s) (@other s) tail_more (@other_back s) (@other_differs s)
    (@rotation_tail s) piece_more connected_more inhabited_more (@edge_by_edge s) (@outside s) (@outside_walk s)
    one_outside_more (unbounded_face s) (@left s) lies_more (@left_outside s) (@left_inside s) (@left_own s) (@bounded s)
    put_down_more.

End Subdivided.

(** ** The operator keeps all rules *)

Section Operator.
Variables (t : view) (v b f : nat).
Hypothesis free_vertex : ~~ vertex t v.
Hypothesis free_boundary : ~~ boundary t b.
Hypothesis live_face : face t f.

Notation t' := (add_isolated_vertex t v b f).

Lemma vertex_more i : vertex t' i = (i == v) || vertex t i.
Proof. exact: one_more (@vertex_below t). Qed.

Lemma boundary_more i : boundary t' i = (i == b) || boundary t i.
Proof. exact: one_more (@boundary_below t). Qed.

Lemma old_vertex i : vertex t i -> i == v = false.
Proof. by move=> l; apply/eqP=> E; rewrite E (negPf free_vertex) in l. Qed.

Lemma old_boundary i : boundary t i -> i == b = false.
Proof. by move=> l; apply/eqP=> E; rewrite E (negPf free_boundary) in l. Qed.

Lemma vertex_says A (says says' : nat -> option A) i : vertex t i -> (i == v = false -> says' i = says i) ->
  heard (vertex t') says' i = heard (vertex t) says i.
Proof. by move=> l E; rewrite /heard vertex_more l orbT E // old_vertex. Qed.

Lemma boundary_says A (says says' : nat -> option A) i : boundary t i -> (i == b = false -> says' i = says i) ->
  heard (boundary t') says' i = heard (boundary t) says i.
Proof. by move=> l E; rewrite /heard boundary_more l orbT E // old_boundary. Qed.

Lemma leaving_old i : vertex t i -> leaving t' i = leaving t i.
Proof. by move=> l; apply: vertex_says => //= ->. Qed.
Lemma isolated_old i : vertex t i -> isolated t' i = isolated t i.
Proof. by move=> l; apply: vertex_says => //= ->. Qed.
Lemma boundary_face_old i : boundary t i -> boundary_face t' i = boundary_face t i.
Proof. by move=> l; apply: boundary_says => //= ->. Qed.
Lemma boundary_start_old i : boundary t i -> boundary_start t' i = boundary_start t i.
Proof. by move=> l; apply: boundary_says => //= ->. Qed.
Lemma boundary_place_old i : boundary t i -> boundary_place t' i = boundary_place t i.
Proof. by move=> l; apply: boundary_says => //= ->. Qed.

Lemma inner_count_more i : inner_count t' i = if i == f then (inner_count t f).+1 else inner_count t i.
Proof. by rewrite {1}/inner_count /= -[face t' i]/(face t i); case: eqP => [->|_] //; rewrite live_face. Qed.

Lemma inner_more i j : inner t' i j = if (i == f) && (j == inner_count t f) then Some b else inner t i j.
Proof.
rewrite {1}/inner inner_count_more /=; case: eqP => [->|_] //=; case: eqP => [->|ne]; first by rewrite ltnSn.
by rewrite /inner ltnS leq_eqVlt; case: eqP ne => // _ _.
Qed.

Lemma inner_old i j c : inner t i j = Some c -> inner t' i j = Some c.
Proof.
rewrite inner_more /inner; case: ifP => // lt E; case: andP => // -[/eqP ii /eqP jj].
by move: lt; rewrite ii jj ltnn.
Qed.

Lemma stands_old i g io : boundary t i -> stands t i g io -> stands t' i g io.
Proof.
move=> l [Ef S]; split; first by rewrite boundary_face_old.
case: io S => [[j [P L]]|[P L]]; [exists j|]; rewrite boundary_place_old //; split=> //.
exact: inner_old.
Qed.

Lemma represents_more s : represents t s -> exists s', represents t' s'.
Proof.
case=> nv [nd [nf [nw [ni rep]]]].
have [g gf] := face_is_nf rep live_face.
have nvl u : vertex t (nv u) := vertex_nv rep u.
have nwl x : boundary t (nw x) := boundary_nw rep x.
have nil u : alone u -> boundary t (ni u) := @boundary_ni _ _ _ _ _ _ _ rep u.
pose nv' (u : option (vertices s)) := if u is Some w then nv w else v.
pose ni' (u : option (vertices s)) := if u is Some w then ni w else b.
have alone_some u : alone (s := add_vertex g) (Some u) = alone u by [].
exists (add_vertex g), nv', nd, nf, nw, ni'; split.
- split=> [[u|] [w|] //= E|i]; first by congr Some; apply: (nv_inj rep).
  + by have := old_vertex (nvl u); rewrite E eqxx.
  + by have := old_vertex (nvl w); rewrite -E eqxx.
  rewrite vertex_more; split=> [/orP[/eqP->|/(vertex_is_nv rep)[u <-]]|[[u|] <-]] /=; [by exists None|by exists (Some u)| |].
    by rewrite nvl orbT.
  by rewrite eqxx.
- exact: darts_numbered rep.
- exact: faces_numbered rep.
- exact: walks_numbered rep.
- move=> [u|] [w|] //= au aw E; first by congr Some; apply: (isolated_numbered rep).
    by have := old_boundary (nil u au); rewrite E eqxx.
  by have := old_boundary (nil w aw); rewrite -E eqxx.
- move=> x [u|] au /=; first exact: (walk_or_isolated rep).
  by move=> E; have := old_boundary (nwl x); rewrite E eqxx.
- move=> i; rewrite boundary_more; split=> [/orP[/eqP->|]|[[x <-]|[[u|] au <-]]].
  + by right; exists None => //; apply/forallP.
  + by move/(boundaries_numbered rep)=> [[x xi]|[u au ui]]; [left; exists x | right; exists (Some u)].
  + by rewrite nwl orbT.
  + by rewrite /= nil ?orbT.
  by rewrite /= eqxx.
- exact: (says_of_dart rep).
- move=> [u|].
    change (alone (s := add_vertex g) (Some u)) with (alone u); rewrite /nv' /ni' leaving_old // isolated_old //.
    have := says_of_vertex rep u; case: (alone u) => // -[[x E xu] I]; split=> //; by exists x; rewrite //= /tail_more xu.
  have -> : alone (s := add_vertex g) None by apply/forallP.
  by rewrite /= /leaving /isolated /heard vertex_more eqxx /= eqxx.
- move=> x; have [S [y E xy]] := says_of_walk rep x; split; first exact: stands_old.
  by exists y => //; rewrite boundary_start_old.
- move=> [u|] au /=.
    by have [S E] := says_of_isolated rep (au : alone u); rewrite boundary_start_old ?nil //; split=> //; apply: stands_old => //; apply: nil.
  rewrite /boundary_start /heard boundary_more eqxx /= eqxx; split=> //; split.
    by rewrite /boundary_face /heard boundary_more eqxx /= eqxx gf.
  exists (inner_count t f); rewrite /boundary_place /heard boundary_more eqxx /= eqxx; split=> //.
  by rewrite gf inner_more !eqxx.
- move=> i c E; have [Ef Ep] := lists_outer rep E; have lc := heard_live Ef.
  by rewrite boundary_face_old // boundary_place_old.
move=> i j; rewrite inner_count_more inner_more; case: eqP => [->|ne] lt /=; last first.
  have [c [E Ef Ep]] := lists_inner rep lt; have lc := heard_live Ef.
  by exists c; rewrite boundary_face_old // boundary_place_old.
case: eqP => [->|ne].
  exists b; rewrite /boundary_face /boundary_place /heard boundary_more eqxx /= eqxx; by [].
have lt' : j < inner_count t f by move: lt; rewrite ltnS leq_eqVlt => /orP[/eqP|].
have [c [E Ef Ep]] := lists_inner rep lt'; have lc := heard_live Ef.
by exists c; rewrite boundary_face_old // boundary_place_old.
Qed.

(** Let [v] and [b] be free slots and [f] a face: if all rules held before, they hold after. *)
Theorem add_isolated_vertex_keeps_rules : rules t -> rules t'.
Proof.
move/rules_mean_subdivision=> [s /represents_more H].
exact/rules_mean_subdivision.
Qed.

End Operator.
