(** * Connect: connecting a corner to an isolated vertex keeps all rules (dcel/operators/connect.rs)

    `connect` joins two corners of one face by an edge. Here the second corner is that of an isolated vertex, so that the
    edge is a bridge: the isolated vertex and its boundary component are gone, and the vertex is at the end of an edge.

<<
      f ┌──────────┐         f ┌──────────┐        half-edge h: from the corner after a, twin k
        │    · v   │           │   ┌─· v  │        half-edge k: from v, twin h
        │          │   ──►     │  h│k     │        along the boundary: a, h, k, next(a)
        └──►───·───┘           └──►┴──────┘        vertex v: leaving k, no longer isolated
           a                      a
>>
*)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import View Rules Map Counting Verdict AddVertex RemoveVertex NewEdge.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** The view [t], in which [v] is free, with a vertex [v] at the end of an edge, which is inserted after the half-edge [a]:
    its half-edges are [h], to [v], and [k], from [v]. *)
Definition attach_vertex t a v h k : view := {|
  vertex_slots := maxn (vertex_slots t) v.+1;
  half_edge_slots := maxn (half_edge_slots t) (maxn h.+1 k.+1);
  boundary_slots := boundary_slots t;
  face_slots := face_slots t;
  is_vertex := fun i => (i == v) || vertex t i;
  is_half_edge := fun i => [|| i == h, i == k | half_edge t i];
  is_boundary := is_boundary t;
  is_face := is_face t;
  says_origin := fun i => if i == h then target t a else if i == k then Some v else says_origin t i;
  says_twin := fun i => if i == h then Some k else if i == k then Some h else says_twin t i;
  says_next := fun i => if i == h then Some k else if i == k then next t a else if i == a then Some h else says_next t i;
  says_prev := fun i => if i == h then Some a else if i == k then Some h else
    if Some i == next t a then Some k else says_prev t i;
  says_boundary := fun i => if (i == h) || (i == k) then boundary_of t a else says_boundary t i;
  says_leaving := fun i => if i == v then Some k else says_leaving t i;
  says_isolated := fun i => if i == v then None else says_isolated t i;
  says_boundary_face := says_boundary_face t;
  says_boundary_start := says_boundary_start t;
  says_boundary_place := says_boundary_place t;
  says_outer := says_outer t;
  says_inner_count := says_inner_count t;
  says_inner := says_inner t
|}.

Section Attach.
Variables (t : view) (a v h k o n b : nat).
Hypothesis keeps : rules t.
Hypothesis free_vertex : ~~ vertex t v.
Hypothesis free_h : ~~ half_edge t h.
Hypothesis free_k : ~~ half_edge t k.
Hypothesis hk : h != k.
Hypothesis live_a : half_edge t a.
Hypothesis target_a : target t a = Some o.
Hypothesis next_a : next t a = Some n.
Hypothesis boundary_a : boundary_of t a = Some b.

Notation t' := (attach_vertex t a v h k).

Lemma vertexE i : vertex t' i = (i == v) || vertex t i.
Proof.
rewrite {1}/vertex /= leq_max ltnS; case: eqP => [->|_] /=; first by rewrite leqnn orbT.
by case: (boolP (vertex t i)) => [/andP[-> _]|_]; rewrite ?andbF.
Qed.

Lemma half_edgeE i : half_edge t' i = [|| i == h, i == k | half_edge t i].
Proof.
rewrite {1}/half_edge /= !leq_max !ltnS; case: eqP => [->|_] /=; first by rewrite leqnn !orbT.
case: eqP => [->|_] /=; first by rewrite leqnn !orbT.
by case: (boolP (half_edge t i)) => [/andP[-> _]|_]; rewrite ?andbF.
Qed.

Let old_h := NewEdge.old_h free_h.
Let old_k := NewEdge.old_k free_k.
Let links_of := NewEdge.links_of keeps.
Let start_live := NewEdge.start_live keeps.
Let start_vertex := NewEdge.start_vertex keeps.
Let up_half_edge := NewEdge.up_half_edge half_edgeE.
Let up_vertex := NewEdge.up_vertex vertexE.
Let half_edgeP := NewEdge.half_edgeP free_h free_k half_edgeE.
Let newE := NewEdge.newE hk.

(** ** What the view says *)

Lemma live_n : half_edge t n.
Proof. by have [_ _ [g + l] _ _] := links_of live_a; rewrite next_a => -[->]. Qed.

Lemma live_o : vertex t o.
Proof.
have [_ [g E lg] _ _ _] := links_of live_a; have [[u U lu] _ _ _ _] := links_of lg.
by move: target_a; rewrite /target E /= U => -[<-].
Qed.

Lemma live_b : boundary t b.
Proof. by have [_ _ _ _ [c + l]] := links_of live_a; rewrite boundary_a => -[->]. Qed.

Lemma origin_n : origin t n = Some o.
Proof. by have := keeps L3 a live_a; rewrite next_a /= => ->. Qed.

Lemma prev_n : prev t n = Some a.
Proof. by have [+ _] := keeps L2 a live_a; rewrite next_a. Qed.

Ltac heard := rewrite /heard half_edgeE /=; case: (_ == h) => //=; case: (_ == k) => //=.

Lemma originE i : origin t' i = if i == h then Some o else if i == k then Some v else origin t i.
Proof. by rewrite {1}/origin; heard. Qed.

Lemma twinE i : twin t' i = if i == h then Some k else if i == k then Some h else twin t i.
Proof. by rewrite {1}/twin; heard. Qed.

Lemma nextE i : next t' i = if i == h then Some k else if i == k then Some n else if i == a then Some h else next t i.
Proof.
rewrite {1}/next; heard; rewrite ?next_a //.
by case: (i =P a) => [->|_] //; rewrite live_a.
Qed.

Lemma prevE i : prev t' i = if i == h then Some a else if i == k then Some h else if i == n then Some k else prev t i.
Proof.
rewrite {1}/prev; heard => //; rewrite next_a -[Some i == Some n]/(i == n).
by case: (i =P n) => [->|_] //; rewrite live_n.
Qed.

Lemma boundary_ofE i : boundary_of t' i = if (i == h) || (i == k) then Some b else boundary_of t i.
Proof. by rewrite {1}/boundary_of; heard; rewrite ?boundary_a. Qed.

Lemma leavingE i : leaving t' i = if i == v then Some k else leaving t i.
Proof. by rewrite {1}/leaving /heard vertexE /=; case: (i == v). Qed.

Lemma isolatedE i : isolated t' i = if i == v then None else isolated t i.
Proof. by rewrite {1}/isolated /heard vertexE /=; case: (i == v). Qed.

Let attach_l1 : l1_twin t' := new_l1 keeps free_h free_k hk half_edgeE twinE.

(** ** R1 to L3 *)

Lemma bare_old u : vertex t u -> bare t' u <-> bare t u.
Proof.
move=> lu; split=> [B i li|B i /half_edgeP[||{}i li ih ik]].
- by move=> E; apply: (B i (up_half_edge li)); rewrite originE old_h ?old_k.
- by rewrite originE eqxx => -[ou]; apply: (B n live_n); rewrite origin_n ou.
- by rewrite originE !newE => -[vu]; move: lu; rewrite -vu (negPf free_vertex).
by rewrite originE ih ik; apply: B.
Qed.

Lemma attach_links : links_live t'.
Proof.
have [[H V B F] _] := keeps R1; split.
- move=> i /half_edgeP[||{}i li ih ik]; rewrite originE twinE nextE prevE boundary_ofE ?newE.
  + split; [exists o|exists k|exists k|exists a|exists b]; rewrite ?vertexE ?half_edgeE ?eqxx ?live_o ?live_a ?orbT //.
    exact: live_b.
  + split; [exists v|exists h|exists n|exists h|exists b]; rewrite ?vertexE ?half_edgeE ?eqxx ?live_n ?orbT //.
    exact: live_b.
  rewrite ih ik /=; have [[u U lu] [g G lg] [m M lm] [p P lp] C] := H i li; split=> //.
  + by exists u; rewrite ?up_vertex.
  + by exists g; rewrite ?up_half_edge.
  + case: (i =P a) => _; [exists h|exists m] => //; last exact: up_half_edge.
    by rewrite half_edgeE eqxx.
  case: (i =P n) => _; [exists k|exists p] => //; last exact: up_half_edge.
  by rewrite half_edgeE eqxx orbT.
- move=> u; rewrite leavingE isolatedE vertexE; case: (u =P v) => [_ _|_ /= lu].
    by split; left=> //; exists k; rewrite // half_edgeE eqxx orbT.
  have [L I] := V u lu; split=> //; case: L => [[g G lg]|[N Bu]]; [left; exists g; rewrite ?up_half_edge // | right].
  by split=> //; apply/bare_old.
- move=> c lc; have [L S] := B c lc; split=> //; rewrite -[boundary_start t' c]/(boundary_start t c).
  by case: (boundary_start t c) S => [[i|u]|] //= l; [apply: up_half_edge|apply: up_vertex].
exact: F.
Qed.

Lemma attach_l2 : l2_next_prev t'.
Proof.
move=> i /half_edgeP[||{}i li ih ik]; rewrite nextE prevE ?newE /=.
- by rewrite prevE nextE !newE old_h ?old_k ?eqxx.
- by rewrite prevE nextE !newE old_h ?old_k ?eqxx ?live_n.
rewrite ih ik; have [E D] := keeps L2 i li; have [_ _ [m M lm] [p P lp] _] := links_of li; split.
  case: (i =P a) => [->|ia] /=; first by rewrite prevE !newE.
  rewrite M /= in E *; rewrite prevE old_h ?old_k //; case: (m =P n) E => [->|_] //.
  by rewrite prev_n => -[/esym].
case: (i =P n) => [->|ni] /=; first by rewrite nextE !newE.
rewrite P /= in D *; rewrite nextE old_h ?old_k //; case: (p =P a) D => [->|_] //.
by rewrite next_a => -[/esym].
Qed.

Lemma attach_l3 : l3_target t'.
Proof.
move=> i /half_edgeP[||{}i li ih ik]; rewrite nextE twinE ?newE /=.
- by [].
- by rewrite !originE !newE old_h ?old_k ?live_n // origin_n.
rewrite ih ik; have [_ [g G lg] [m M lm] _ _] := links_of li; have := keeps L3 i li; rewrite G M /=.
rewrite (originE g) old_h ?old_k // => <-; case: (i =P a) M => [->|_] M /=; last by rewrite originE old_h ?old_k.
by rewrite originE eqxx; move: M; rewrite next_a => -[<-]; rewrite origin_n.
Qed.

(** ** V1, V2 *)

Lemma attach_v1 : v1_leaving t'.
Proof.
move=> u g; rewrite vertexE leavingE; case: (u =P v) => [-> _ [<-]|_ /= lu E]; first by rewrite originE !newE.
have O := keeps V1 u g lu E; by rewrite originE old_h ?old_k // (heard_live O).
Qed.

Lemma turnE i : turn t' i = if i == h then Some n else if i == k then Some k else if twin t i == Some a then Some h
  else turn t i.
Proof.
rewrite /turn twinE; case: eqP => _ /=; first by rewrite nextE !newE.
case: eqP => _ /=; first by rewrite nextE !newE.
case G: (twin t i) => [g|] //=; have lg : half_edge t g.
  by have [_ [g' + l] _ _ _] := links_of (heard_live G); rewrite G => -[->].
by rewrite nextE old_h ?old_k // -[Some g == Some a]/(g == a).
Qed.

Lemma turn_up g x : on_orbit (turn t) g x -> on_orbit (turn t') g x.
Proof.
apply: orbit_sub => u w z E ou; have [m G] : exists m, twin t u = Some m.
  by move: E; rewrite /turn; case: (twin t u) => [m|] //; exists m.
have lu : half_edge t u := heard_live G.
have T : turn t' u = if twin t u == Some a then Some h else turn t u by rewrite turnE old_h ?old_k.
case: (twin t u =P Some a) T => [A|_] T; last by apply: orbit_step ou _; rewrite T.
apply: (orbit_step (y := h)); first by apply: orbit_step ou _; rewrite T.
by rewrite turnE eqxx -E /turn A /= next_a.
Qed.

Lemma attach_v2 : v2_rotation t'.
Proof.
have [_ [d D ld] _ _ _] := links_of live_a.
have Od : origin t d = Some o by move: target_a; rewrite /target D.
have Td : turn t' d = Some h.
  by rewrite turnE old_h ?old_k //; have [+ _] := keeps L1 a live_a; rewrite D /= => ->; rewrite eqxx.
have kv i : half_edge t i -> origin t i <> Some v.
  by move/links_of=> [[u -> lu] _ _ _ _] [uv]; move: lu; rewrite uv (negPf free_vertex).
have ov : o <> v by move=> ov; move: live_o; rewrite ov (negPf free_vertex).
move=> g x lg lx; split=> [/(on_rotation_origin attach_l1 attach_l3) ->//|].
rewrite !originE; case: (half_edgeP lg) => [||{lg}g lg gh gk]; rewrite ?newE.
- case: (half_edgeP lx) => [||{lx}x lx xh xk]; rewrite ?newE; first by move=> _; apply: orbit_refl.
    by case.
  rewrite xh xk => E; have [m] : on_orbit (turn t') n x by apply: turn_up; apply/(keeps V2 n x live_n lx); rewrite origin_n.
  by move=> I; exists m.+1; rewrite iterSr /= turnE eqxx.
- case: (half_edgeP lx) => [||{lx}x lx xh xk]; rewrite ?newE; [by case=> /esym|by move=> _; apply: orbit_refl|].
  by rewrite xh xk => /esym/kv.
rewrite gh gk; case: (half_edgeP lx) => [||{lx}x lx xh xk]; rewrite ?newE.
- move=> E; apply: orbit_step Td; apply: turn_up; apply/(keeps V2 g d lg ld); by rewrite Od.
- by move/kv.
by rewrite xh xk => E; apply: turn_up; apply/(keeps V2 g x lg lx).
Qed.

(** ** B1 to F2 *)

(** [h] and [k] are on the cycle of [a]; without them it is the cycle that it was. *)
Definition without i := if (i == h) || (i == k) then a else i.

Lemma without_old i : half_edge t i -> without i = i.
Proof. by move=> l; rewrite /without old_h ?old_k. Qed.

Lemma cycle_down g x : on_cycle t' g x -> on_cycle t (without g) (without x).
Proof.
case=> m; elim: m x => [|m IH] x /=; first by case=> <-; apply: orbit_refl.
case E: (iter m _ _) => [y|] //=; have := IH y E; rewrite nextE; move: (without g) => g'; rewrite /without.
case: (y =P h) => [_|_] /=; first by move=> C [<-]; rewrite ?newE ?orbT.
case: (y =P k) => [_|_] /=; first by move=> C [<-]; rewrite old_h ?old_k ?live_n //; apply: orbit_step C next_a.
case: (y =P a) => [-> C [<-]|_ C N]; first by rewrite newE.
have [_ _ [x' + lx] _ _] := links_of (heard_live N); rewrite N => -[xx]; rewrite -xx in lx.
by rewrite old_h ?old_k //; apply: orbit_step C N.
Qed.

Lemma a_to_h : next t' a = Some h. Proof. by rewrite nextE old_h ?old_k ?eqxx. Qed.
Lemma h_to_k : next t' h = Some k. Proof. by rewrite nextE eqxx. Qed.

Lemma cycle_up g x : on_cycle t g x -> on_cycle t' g x.
Proof.
apply: orbit_sub => u w z E ou; have lu : half_edge t u := heard_live E.
case: (u =P a) ou E => [->|/eqP/negPf ua] ou E; last by apply: orbit_step ou _; rewrite nextE old_h ?old_k ?ua.
apply: (orbit_step (y := k)); first exact: orbit_step (orbit_step ou a_to_h) h_to_k.
by rewrite nextE !newE -E next_a.
Qed.

Lemma cycle_on g x : half_edge t g -> half_edge t' x -> on_cycle t' g x <-> on_cycle t g (without x).
Proof.
move=> lg lx; split=> [/cycle_down|]; first by rewrite (without_old lg).
rewrite /without; case: (half_edgeP lx) => [||{lx}x lx xh xk] /=; rewrite ?newE ?orbT.
- by move/cycle_up=> C; apply: orbit_step C a_to_h.
- by move/cycle_up=> C; apply: orbit_step (orbit_step C a_to_h) h_to_k.
by rewrite xh xk; apply: cycle_up.
Qed.

Lemma without_live i : half_edge t' i -> half_edge t (without i).
Proof. by case/half_edgeP=> [||{}i li ih ik]; rewrite /without ?newE ?orbT // ih ik. Qed.

Lemma boundary_without i : boundary_of t' i = boundary_of t (without i).
Proof. by rewrite boundary_ofE /without; case: (_ || _); rewrite ?boundary_a. Qed.

Lemma attach_b1 : b1_cycle t'.
Proof.
have [C D] := keeps B1; split=> [i|c i lc li].
  case/half_edgeP=> [||{}i li ih ik]; rewrite nextE boundary_ofE ?newE ?orbT /=.
  - by rewrite boundary_ofE !newE orbT.
  - by rewrite boundary_ofE old_h ?old_k ?live_n //=; have := C a live_a; rewrite next_a /= boundary_a.
  rewrite ih ik /=; case: (i =P a) => [->|_] /=; first by rewrite boundary_ofE eqxx boundary_a.
  have [_ _ [m M lm] _ _] := links_of li; have := C i li; rewrite M /= => <-.
  by rewrite boundary_ofE old_h ?old_k.
rewrite boundary_without; apply: iff_trans (D c _ lc (without_live li)) _.
by split=> -[g S O]; exists g => //; apply/(cycle_on (start_live S) li).
Qed.

Lemma not_at_v c : ~ starts_at_vertex t' v c.
Proof. by move/start_vertex; rewrite (negPf free_vertex). Qed.

Lemma attach_b2 : b2_isolated t'.
Proof.
move=> u; rewrite vertexE isolatedE; case: (u =P v) => [-> _|_ /= lu].
  split=> [B|_]; last by split=> // c; apply: not_at_v.
  have lk : half_edge t' k by rewrite half_edgeE eqxx orbT.
  by have := B k lk; rewrite originE !newE.
have [A N] := keeps B2 u lu; split=> [/(bare_old lu) /A //|nb]; apply: N => B; apply: nb; exact/bare_old.
Qed.

(** ** T1 to T3 *)

Lemma vertex_atE c : vertex_at t' c = vertex_at t c.
Proof.
rewrite /vertex_at -[boundary_start t' c]/(boundary_start t c); case S: (boundary_start t c) => [[g|u]|] //.
by have lg := start_live S; rewrite originE old_h ?old_k.
Qed.

Lemma attach_t1 : t1_outside t'.
Proof. by apply: (new_t1 keeps free_vertex free_h free_k hk live_o vertexE originE twinE _ vertex_atE). Qed.

Lemma attach_t2 : t2_nesting t'.
Proof. by apply: (new_t2 keeps free_vertex free_h free_k hk live_o vertexE originE twinE _ _ _ _ vertex_atE). Qed.

Lemma attach_t3 : t3_euler t'.
Proof.
apply: (new_t3 keeps free_vertex free_h free_k hk live_o vertexE half_edgeE originE twinE _ _ vertex_atE) => //.
case=> // _; [by split; [exact: attach_links|case: (keeps R1)]|exact: attach_l2|exact: attach_l3|
  exact: attach_v1|exact: attach_v2|exact: attach_b1|exact: attach_b2|exact: (keeps F1)|exact: (keeps F2)].
Qed.

Lemma attach_rules : rules t'.
Proof.
have H r : index r < index T4 -> holds t' r.
  case: r => // _; [by split; [exact: attach_links|case: (keeps R1)]|exact: attach_l2|exact: attach_l3|
    exact: attach_v1|exact: attach_v2|exact: attach_b1|exact: attach_b2|exact: (keeps F1)|exact: (keeps F2)|
    exact: attach_t1|exact: attach_t2|exact: attach_t3].
by move=> r; case: (ltnP (index r) (index T4)) => [/H //|]; case: r => // _; apply: t4_follows => q; apply: H.
Qed.

End Attach.

(** Where [v], [h] and [k] are free slots and [a] is a half-edge: if all rules held before, they hold after. *)
Theorem attach_vertex_keeps_rules t a v h k : half_edge t a ->
  ~~ vertex t v -> ~~ half_edge t h -> ~~ half_edge t k -> h != k ->
  rules t -> rules (attach_vertex t a v h k).
Proof.
move=> la fv fh fk hk keeps; have [_ [d D ld] [n N _] _ [b B _]] := links_of keeps la.
have [[o O _] _ _ _ _] := links_of keeps ld.
by apply: (attach_rules (o := o) (n := n) (b := b)) => //; rewrite /target D.
Qed.

(** The bridge to an isolated vertex: [t] with the isolated vertex [v], as the boundary component [b] of the face [f], is
    before, and [t] with [v] at the end of an edge from the corner after [a] is after. The corner may even be of another
    face: then the edge could not be drawn where [v] lies, but what is there after is right all the same. *)
Theorem bridge_to_isolated_vertex_keeps_rules t a v b f h k : half_edge t a -> face t f ->
  ~~ vertex t v -> ~~ boundary t b -> ~~ half_edge t h -> ~~ half_edge t k -> h != k ->
  rules (add_isolated_vertex t v b f) -> rules (attach_vertex t a v h k).
Proof.
move=> la lf fv fb fh fk hk keeps; apply: attach_vertex_keeps_rules => //.
exact: (remove_isolated_vertex_keeps_rules fv fb lf).
Qed.
