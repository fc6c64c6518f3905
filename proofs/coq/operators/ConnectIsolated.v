(** * ConnectIsolated: attaching a new vertex to an isolated one keeps all rules (`split_vertex` in dcel/operators/split_vertex.rs)

    The boundary component of [o] becomes the cycle of the two new half-edges. If [v] was isolated, too, and was removed first, this
    connects two isolated vertices (Connect.v).

<<
      f ┌─────────────┐         f ┌─────────────┐       half-edge h: from o, twin k, next k
        │  · o        │   ──►     │  · ────── · │       half-edge k: from v, twin h, next h
        └─────────────┘           └─────────────┘       boundary b, which started at o, starts at h
>>
*)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import View Rules Map Lists Verdict NewEdge.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** The view [t], in which [v] is free and [b] is the boundary component of the isolated vertex [o], with an edge from [o]
    to [v]: its half-edges are [h], to [v], and [k], from [v]. *)
Definition attach_to_isolated t o v b h k : view := {|
  vertex_slots := maxn (vertex_slots t) v.+1;
  half_edge_slots := maxn (half_edge_slots t) (maxn h.+1 k.+1);
  boundary_slots := boundary_slots t;
  face_slots := face_slots t;
  is_vertex := fun i => (i == v) || vertex t i;
  is_half_edge := fun i => [|| i == h, i == k | half_edge t i];
  is_boundary := is_boundary t;
  is_face := is_face t;
  says_origin := fun i => if i == h then Some o else if i == k then Some v else says_origin t i;
  says_twin := fun i => if i == h then Some k else if i == k then Some h else says_twin t i;
  says_next := fun i => if i == h then Some k else if i == k then Some h else says_next t i;
  says_prev := fun i => if i == h then Some k else if i == k then Some h else says_prev t i;
  says_boundary := fun i => if (i == h) || (i == k) then Some b else says_boundary t i;
  says_leaving := fun i => if i == v then Some k else if i == o then Some h else says_leaving t i;
  says_isolated := fun i => if (i == v) || (i == o) then None else says_isolated t i;
  says_boundary_face := says_boundary_face t;
  says_boundary_start := fun c => if c == b then Some (AtHalfEdge h) else says_boundary_start t c;
  says_boundary_place := says_boundary_place t;
  says_outer := says_outer t;
  says_inner_count := says_inner_count t;
  says_inner := says_inner t
|}.

Section Attach.
Variables (t : view) (o v b h k : nat).
Hypothesis keeps : rules t.
Hypothesis isolated_o : isolated t o = Some b.
Hypothesis free_vertex : ~~ vertex t v.
Hypothesis free_h : ~~ half_edge t h.
Hypothesis free_k : ~~ half_edge t k.
Hypothesis hk : h != k.

Notation t' := (attach_to_isolated t o v b h k).
Let low : lower t. Proof. by move=> q _; apply: keeps. Qed.

Let live_o : vertex t o := heard_live isolated_o.

Lemma bare_o : bare t o.
Proof.
case: (vertexP low live_o) => [x _ xo|//]; have [_ N] := keeps B2 o live_o.
by have [|I _] := N; [rewrite -xo; apply: not_bare low x|move: I; rewrite isolated_o].
Qed.

Lemma starts_at_o c : starts_at_vertex t o c <-> c = b.
Proof. by have [A _] := keeps B2 o live_o; have [d []] := A bare_o; rewrite isolated_o => -[<-]. Qed.

Lemma start_b : boundary_start t b = Some (AtVertex o). Proof. exact/starts_at_o. Qed.
Lemma live_b : boundary t b. Proof. exact: heard_live start_b. Qed.

Lemma vertexE i : vertex t' i = (i == v) || vertex t i.
Proof. exact: one_more (@vertex_below t). Qed.

Lemma half_edgeE i : half_edge t' i = [|| i == h, i == k | half_edge t i].
Proof. exact: two_more (@half_edge_below t). Qed.

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

Ltac heard := rewrite /heard half_edgeE /=; case: (_ == h) => //=; case: (_ == k) => //=.

Lemma originE i : origin t' i = if i == h then Some o else if i == k then Some v else origin t i.
Proof. by rewrite {1}/origin; heard. Qed.
Lemma twinE i : twin t' i = if i == h then Some k else if i == k then Some h else twin t i.
Proof. by rewrite {1}/twin; heard. Qed.
Lemma nextE i : next t' i = if i == h then Some k else if i == k then Some h else next t i.
Proof. by rewrite {1}/next; heard. Qed.
Lemma prevE i : prev t' i = if i == h then Some k else if i == k then Some h else prev t i.
Proof. by rewrite {1}/prev; heard. Qed.
Lemma boundary_ofE i : boundary_of t' i = if (i == h) || (i == k) then Some b else boundary_of t i.
Proof. by rewrite {1}/boundary_of; heard. Qed.

Lemma leavingE i : leaving t' i = if i == v then Some k else if i == o then Some h else leaving t i.
Proof.
rewrite {1}/leaving /heard vertexE /=; case: (i == v) => //=.
by case: (i =P o) => [->|_] //; rewrite live_o.
Qed.

Lemma isolatedE i : isolated t' i = if (i == v) || (i == o) then None else isolated t i.
Proof. by rewrite {1}/isolated /heard vertexE /=; case: (i == v) => //=; case: (i == o) => //=; case: (vertex t i). Qed.

Lemma startE c : boundary_start t' c = if c == b then Some (AtHalfEdge h) else boundary_start t c.
Proof.
rewrite /boundary_start /heard -[boundary t' c]/(boundary t c) /=; case: (c =P b) => [->|_] //.
by rewrite live_b.
Qed.

Let new_twin : l1_twin t' := new_l1 keeps free_h free_k hk half_edgeE twinE.
Let bare_old := NewEdge.bare_old free_vertex free_h free_k hk half_edgeE originE.

Lemma live_h : half_edge t' h. Proof. by rewrite half_edgeE eqxx. Qed.
Lemma live_k : half_edge t' k. Proof. by rewrite half_edgeE eqxx orbT. Qed.
Lemma o_not_v : (o == v) = false.
Proof. by apply/eqP=> ov; move: live_o; rewrite ov (negPf free_vertex). Qed.

(** ** R1 to L3 *)

Lemma attach_links : links_live t'.
Proof.
have [[H V B F] _] := keeps R1; split.
- move=> i /half_edgeP[||{}i li ih ik]; rewrite originE twinE nextE prevE boundary_ofE ?newE.
  + split; [exists o|exists k|exists k|exists k|exists b]; rewrite ?live_k //; first by rewrite up_vertex.
    exact: live_b.
  + split; [exists v|exists h|exists h|exists h|exists b]; rewrite ?live_h //; first by rewrite vertexE eqxx.
    exact: live_b.
  rewrite ih ik /=; have [[u U lu] [g G lg] [m M lm] [p P lp] C] := H i li; split=> //.
  + by exists u; rewrite ?up_vertex.
  + by exists g; rewrite ?up_half_edge.
  + by exists m; rewrite ?up_half_edge.
  by exists p; rewrite ?up_half_edge.
- move=> u; rewrite leavingE isolatedE vertexE; case: (u =P v) => [_ _|_ /=].
    by split; left=> //; exists k; rewrite ?live_k.
  case: (u =P o) => [_ _|uo lu]; first by split; left=> //; exists h; rewrite ?live_h.
  have [L I] := V u lu; split=> //; case: L => [[g G lg]|[N Bu]]; [left; exists g; rewrite ?up_half_edge // | right].
  by split=> //; apply/bare_old.
- move=> c lc; have [L S] := B c lc; split=> //; rewrite startE; case: (c =P b) => [_|_]; first exact: live_h.
  by case: (boundary_start t c) S => [[i|u]|] //= l; [apply: up_half_edge|apply: up_vertex].
exact: F.
Qed.

Lemma attach_l2 : l2_next_prev t'.
Proof.
move=> i /half_edgeP[||{}i li ih ik]; rewrite nextE prevE ?newE /=; rewrite ?prevE ?nextE ?newE //.
rewrite ih ik; have [E D] := keeps L2 i li; have [_ _ [m M lm] [p P lp] _] := links_of li.
rewrite M P /= in E D *; by rewrite prevE nextE !old_h ?old_k.
Qed.

Lemma attach_l3 : l3_target t'.
Proof.
move=> i /half_edgeP[||{}i li ih ik]; rewrite nextE twinE ?newE //.
rewrite ih ik; have [_ [g G lg] [m M lm] _ _] := links_of li; have := keeps L3 i li; rewrite G M /= => E.
by rewrite !originE !old_h ?old_k.
Qed.

(** ** V1, V2 *)

Lemma attach_v1 : v1_leaving t'.
Proof.
move=> u g; rewrite vertexE leavingE; case: (u =P v) => [-> _ [<-]|_ /=]; first by rewrite originE !newE.
case: (u =P o) => [-> _ [<-]|_ lu E]; first by rewrite originE eqxx.
have O := keeps V1 u g lu E; by rewrite originE old_h ?old_k // (heard_live O).
Qed.

Lemma turn_up g x : on_orbit (turn t) g x -> on_orbit (turn t') g x.
Proof.
apply: orbit_sub => u w z E ou; apply: orbit_step ou _; rewrite -E; move: E.
rewrite /turn; case G: (twin t u) => [g'|] //= N.
by rewrite twinE old_h ?old_k ?(heard_live G) // G /= nextE old_h ?old_k ?(heard_live N).
Qed.

Lemma attach_v2 : v2_rotation t'.
Proof.
have kv i : half_edge t i -> origin t i <> Some v.
  by move/links_of=> [[u -> lu] _ _ _ _] [uv]; move: lu; rewrite uv (negPf free_vertex).
have ov : o <> v by apply/eqP; rewrite o_not_v.
move=> g x lg lx; split=> [/(on_rotation_origin new_twin attach_l3) ->//|].
rewrite !originE; case: (half_edgeP lg) => [||{lg}g lg gh gk]; case: (half_edgeP lx) => [||{lx}x lx xh xk];
  rewrite ?newE ?gh ?gk ?xh ?xk.
- by move=> _; apply: orbit_refl.
- by case.
- by move/esym/bare_o.
- by case=> /esym.
- by move=> _; apply: orbit_refl.
- by move/esym/kv.
- by move/bare_o.
- by move/kv.
by move=> E; apply: turn_up; apply/(keeps V2 g x lg lx).
Qed.

(** ** B1 to F2 *)

Lemma cycle_new x : on_cycle t' h x -> (x == h) || (x == k).
Proof.
case=> m; elim: m x => [|m IH] x /=; first by case=> <-; rewrite eqxx.
case E: (iter m _ _) => [y|] //=; rewrite nextE; case/orP: (IH y E) => /eqP->; rewrite !newE => -[<-].
  by rewrite eqxx orbT.
by rewrite eqxx.
Qed.

Lemma cycle_stays g x : half_edge t g -> on_cycle t' g x -> half_edge t x /\ on_cycle t g x.
Proof.
move=> lg [m]; elim: m x => [|m IH] x /=; first by case=> <-; split=> //; apply: orbit_refl.
case E: (iter m _ _) => [y|] //=; have [ly C] := IH y E; rewrite nextE old_h ?old_k // => N.
have [_ _ [x' + lx] _ _] := links_of ly; rewrite N => -[xx]; rewrite -xx in lx; split=> //.
exact: orbit_step C N.
Qed.

Lemma cycle_old g x : half_edge t g -> on_cycle t' g x <-> on_cycle t g x.
Proof.
move=> lg; split=> [/(cycle_stays lg)[]//|]; apply: orbit_sub => u w z E ou; apply: orbit_step ou _.
by rewrite nextE old_h ?old_k ?(heard_live E).
Qed.

Lemma old_not_b i : half_edge t i -> boundary_of t i <> Some b.
Proof. by move=> li; have [_ D] := keeps B1; move/(D b i live_b li)=> [g]; rewrite start_b. Qed.

Lemma attach_b1 : b1_cycle t'.
Proof.
have [C D] := keeps B1; split=> [i|c i lc].
  case/half_edgeP=> [||{}i li ih ik]; rewrite nextE boundary_ofE ?newE ?orbT /=; try by rewrite boundary_ofE ?newE ?orbT.
  rewrite ih ik /=; have [_ _ [m M lm] _ _] := links_of li; have := C i li; rewrite M /= => <-.
  by rewrite boundary_ofE old_h ?old_k.
have h_h : on_cycle t' h h by apply: orbit_refl.
have h_k : on_cycle t' h k by apply: orbit_step h_h _; rewrite nextE eqxx.
have not_new g x : half_edge t g -> on_cycle t' g x -> (x == h) || (x == k) = false.
  by move=> lg /(cycle_stays lg)[lx _]; rewrite old_h ?old_k.
rewrite boundary_ofE startE; case/half_edgeP=> [||{}i li ih ik]; rewrite ?newE ?orbT /=.
- case: (c =P b) => [->|cb]; first by split=> // _; exists h.
  by split=> [[/esym//]|[g /start_live lg /(not_new g h lg)]]; rewrite newE.
- case: (c =P b) => [->|cb]; first by split=> // _; exists h.
  by split=> [[/esym//]|[g /start_live lg /(not_new g k lg)]]; rewrite !newE.
rewrite ih ik /=; case: (c =P b) => [->|_].
  split=> [/(old_not_b li) //|[_ [<-]] /cycle_new]; by rewrite ih ik.
rewrite (D c i lc li); split=> -[g S X]; exists g => //; apply/(cycle_old _ (start_live S)); exact: X.
Qed.

(** Of the vertices other than [o], the same start. *)
Lemma starts_less u c : starts_at_vertex t' u c <-> u <> o /\ starts_at_vertex t u c.
Proof.
rewrite /starts_at_vertex startE; case: (c =P b) => [->|cb].
  by rewrite start_b; split=> // -[uo [ou]]; case: uo.
by split=> [S|[]//]; split=> // uo; apply: cb; apply/starts_at_o; rewrite /starts_at_vertex S uo.
Qed.

Lemma attach_b2 : b2_isolated t'.
Proof.
move=> u; rewrite vertexE isolatedE; case: (u =P v) => [-> _|_ /=].
  split=> [B|_]; first by have := B k live_k; rewrite originE !newE.
  by split=> // c /starts_less[_ /start_vertex]; rewrite (negPf free_vertex).
case: (u =P o) => [-> _|uo lu].
  split=> [B|_]; first by have := B h live_h; rewrite originE eqxx.
  by split=> // c /starts_less[].
have [A N] := keeps B2 u lu; split=> [/(bare_old lu uo) /A[c [E S]]|nb].
  by exists c; split=> // d; rewrite -S; split=> [/starts_less[]//|X]; apply/starts_less.
have [|E S] := N; first by move=> B; apply: nb; apply/bare_old.
by split=> // c /starts_less[_]; apply: S.
Qed.

Lemma attach_f1 : f1_outer t'.
Proof. by have [U O] := keeps F1; split=> // f c u E /starts_less[_]; apply: O E. Qed.

(** ** T1 to T3 *)

Lemma vertex_atE c : vertex_at t' c = vertex_at t c.
Proof.
rewrite /vertex_at startE; case: (c =P b) => [->|_]; first by rewrite originE eqxx start_b.
case S: (boundary_start t c) => [[g|u]|] //.
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
  exact: attach_v1|exact: attach_v2|exact: attach_b1|exact: attach_b2|exact: attach_f1|exact: (keeps F2)].
Qed.

Lemma attach_rules : rules t'.
Proof.
have H r : index r < index T4 -> holds t' r.
  case: r => // _; [by split; [exact: attach_links|case: (keeps R1)]|exact: attach_l2|exact: attach_l3|
    exact: attach_v1|exact: attach_v2|exact: attach_b1|exact: attach_b2|exact: attach_f1|exact: (keeps F2)|
    exact: attach_t1|exact: attach_t2|exact: attach_t3].
by move=> r; case: (ltnP (index r) (index T4)) => [/H //|]; case: r => // _; apply: t4_follows => q; apply: H.
Qed.

End Attach.

(** Let [v], [h] and [k] be free slots and [b] the boundary component of the isolated vertex [o]: if all rules held
    before, they hold after. *)
Theorem attach_to_isolated_keeps_rules t o v b h k : isolated t o = Some b ->
  ~~ vertex t v -> ~~ half_edge t h -> ~~ half_edge t k -> h != k ->
  rules t -> rules (attach_to_isolated t o v b h k).
Proof. by move=> io fv fh fk hk keeps; apply: attach_rules. Qed.
