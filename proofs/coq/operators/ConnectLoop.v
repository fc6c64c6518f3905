(** * ConnectLoop: a loop at an isolated vertex keeps all rules (`split_face` in dcel/operators/connect.rs)

    Both corners are that of the isolated vertex [v]. The new edge is a loop, each of its two half-edges is a cycle alone, and
    one of the two bounds the new face [g].

<<
      f ┌─────────────┐         f ┌─────────────┐       half-edge h: from v to v, twin k, next h
        │     · v     │   ──►     │    ( · )    │       half-edge k: from v to v, twin h, next k
        └─────────────┘           └─────────────┘       vertex v: leaving k, no longer isolated
>>
*)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import View Rules Map Lists NewEdge NewFace.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** The view [t] with a loop at [v], and the boundary components [left] and [right], one of which started at [v], to its
    left and right. *)
Definition loop_cycles t v h k left right : view := {|
  vertex_slots := vertex_slots t;
  half_edge_slots := maxn (half_edge_slots t) (maxn h.+1 k.+1);
  boundary_slots := boundary_slots t;
  face_slots := face_slots t;
  is_vertex := is_vertex t;
  is_half_edge := fun i => [|| i == h, i == k | half_edge t i];
  is_boundary := is_boundary t;
  is_face := is_face t;
  says_origin := fun i => if (i == h) || (i == k) then Some v else says_origin t i;
  says_twin := fun i => if i == h then Some k else if i == k then Some h else says_twin t i;
  says_next := fun i => if (i == h) || (i == k) then Some i else says_next t i;
  says_prev := fun i => if (i == h) || (i == k) then Some i else says_prev t i;
  says_boundary := fun i => if i == h then Some left else if i == k then Some right else says_boundary t i;
  says_leaving := fun u => if u == v then Some k else says_leaving t u;
  says_isolated := fun u => if u == v then None else says_isolated t u;
  says_boundary_face := says_boundary_face t;
  says_boundary_start := fun c => if c == left then Some (AtHalfEdge h) else
    if c == right then Some (AtHalfEdge k) else says_boundary_start t c;
  says_boundary_place := says_boundary_place t;
  says_outer := says_outer t;
  says_inner_count := says_inner_count t;
  says_inner := says_inner t
|}.

(** The operator is told the same as [ConnectSplit.split_face]. *)
Definition loop_at_isolated t v h k f g kept made (made_left new_left : bool) moved : view :=
  let left := if made_left then made else kept in
  let right := if made_left then kept else made in
  new_face t (loop_cycles t v h k left right) f g kept made
    (if new_left then right else left) (if new_left then left else right) moved.

Section Loop.
Variables (t : view) (v h k f g kept made left right of_old of_new : nat) (moved : pred nat).
Hypothesis keeps : rules t.
Hypothesis free_h : ~~ half_edge t h.
Hypothesis free_k : ~~ half_edge t k.
Hypothesis hk : h != k.
Hypothesis free_boundary : ~~ boundary t made.
Hypothesis free_face : ~~ face t g.
Hypothesis isolated_v : isolated t v = Some kept.
Hypothesis kept_in_f : boundary_face t kept = Some f.
Hypothesis sides : left = kept /\ right = made \/ left = made /\ right = kept.
Hypothesis faces : of_old = left /\ of_new = right \/ of_old = right /\ of_new = left.

Let cut := loop_cycles t v h k left right.
Notation t' := (new_face t cut f g kept made of_old of_new moved).
Let low : lower t. Proof. by move=> q _; apply: keeps. Qed.
Let live_v : vertex t v := heard_live isolated_v.

Lemma bare_v : bare t v.
Proof.
case: (vertexP low live_v) => [x _ xv|//]; have [_ N] := keeps B2 v live_v.
by have [|I _] := N; [rewrite -xv; apply: not_bare low x|move: I; rewrite isolated_v].
Qed.

Lemma starts_at_v c : starts_at_vertex t v c <-> c = kept.
Proof. by have [A _] := keeps B2 v live_v; have [d []] := A bare_v; rewrite isolated_v => -[<-]. Qed.

(** ** What the view says *)

Lemma half_edgeE i : half_edge t' i = [|| i == h, i == k | half_edge t i].
Proof. exact: two_more (@half_edge_below t). Qed.

Ltac heard := rewrite /heard half_edgeE /=; case: (_ == h) => //=; case: (_ == k) => //=.

Lemma originE i : origin t' i = if (i == h) || (i == k) then Some v else origin t i.
Proof. by rewrite {1}/origin; heard. Qed.
Lemma twinE i : twin t' i = if i == h then Some k else if i == k then Some h else twin t i.
Proof. by rewrite {1}/twin; heard. Qed.
Lemma nextE i : next t' i = if (i == h) || (i == k) then Some i else next t i.
Proof. by rewrite {1}/next; heard. Qed.
Lemma prevE i : prev t' i = if (i == h) || (i == k) then Some i else prev t i.
Proof. by rewrite {1}/prev; heard. Qed.
Lemma boundary_ofE i : boundary_of t' i = if i == h then Some left else if i == k then Some right else boundary_of t i.
Proof. by rewrite {1}/boundary_of; heard. Qed.
Lemma leavingE u : leaving t' u = if u == v then Some k else leaving t u.
Proof. by rewrite {1}/leaving /heard -[vertex t' u]/(vertex t u) /=; case: (u =P v) => [->|//]; rewrite live_v. Qed.
Lemma isolatedE u : isolated t' u = if u == v then None else isolated t u.
Proof. by rewrite {1}/isolated /heard -[vertex t' u]/(vertex t u) /=; case: (u == v) => //; case: (vertex t u). Qed.

Let old_h := NewEdge.old_h free_h.
Let old_k := NewEdge.old_k free_k.
Let links_of := NewEdge.links_of keeps.
Let start_live := NewEdge.start_live keeps.
Let up_half_edge := NewEdge.up_half_edge half_edgeE.
Let half_edgeP := NewEdge.half_edgeP free_h free_k half_edgeE.
Let newE := NewEdge.newE hk.
Let boundaryE : forall c, boundary t' c = (c == made) || boundary t c.
Proof. exact: NewFace.boundaryE. Qed.
Let left_not_right : left <> right := left_not_right free_boundary kept_in_f sides.
Let live_left : boundary t' left. Proof. by apply: NewFace.live_left kept_in_f sides. Qed.
Let live_right : boundary t' right. Proof. by apply: NewFace.live_right kept_in_f sides. Qed.
Let startE c : boundary t' c -> boundary_start t' c =
  if c == left then Some (AtHalfEdge h) else if c == right then Some (AtHalfEdge k) else boundary_start t c.
Proof. by move=> lc; apply: (@NewFace.startE t cut f g kept made left right of_old of_new moved sides h k). Qed.
Let otherP c : boundary t' c -> c <> left -> c <> right -> other kept made c /\ boundary t c.
Proof. exact: (@NewFace.otherP t cut f g kept made left right of_old of_new moved sides). Qed.

Lemma live_h : half_edge t' h. Proof. by rewrite half_edgeE eqxx. Qed.
Lemma live_k : half_edge t' k. Proof. by rewrite half_edgeE eqxx orbT. Qed.

Lemma origin_up i u : origin t i = Some u -> origin t' i = Some u.
Proof. by move=> O; rewrite originE old_h ?old_k ?(heard_live O). Qed.

Lemma bare_old u : u <> v -> bare t' u <-> bare t u.
Proof.
move=> uv; split=> B i li; first by have := B i (up_half_edge li); rewrite originE old_h ?old_k.
case/half_edgeP: li => [||{}i li ih ik]; rewrite originE ?newE ?orbT /=; try by case=> /esym.
by rewrite ih ik; apply: B.
Qed.

(** ** R1 to V2 *)

Lemma loop_half_edges : half_edges_live t'.
Proof.
move=> i /half_edgeP[||{}i li ih ik]; rewrite originE twinE nextE prevE boundary_ofE ?newE ?orbT /=.
- split; [exists v|exists k|exists h|exists h|exists left] => //; exact: live_h || exact: live_k.
- split; [exists v|exists h|exists k|exists k|exists right] => //; exact: live_h || exact: live_k.
rewrite ih ik; have [[u U lu] [e E le] [m M lm] [p P lp] [c C lc]] := links_of li; split.
- by exists u.
- by exists e; rewrite ?up_half_edge.
- by exists m; rewrite ?up_half_edge.
- by exists p; rewrite ?up_half_edge.
by exists c; rewrite // boundaryE lc orbT.
Qed.

Lemma loop_vertices : vertices_live t'.
Proof.
move=> u lu; have [[_ V _ _] _] := keeps R1; have [L I] := V u lu; rewrite leavingE isolatedE.
case: (u =P v) => [_|uv]; first by split; left=> //; exists k; rewrite ?live_k.
split.
  by case: L => [[e E le]|[N Bu]]; [left; exists e; rewrite ?up_half_edge|right; split=> //; apply/bare_old].
by case: I => [N|[c C lc]]; [left|right; exists c; rewrite // boundaryE lc orbT].
Qed.

Lemma loop_l1 : l1_twin t'. Proof. exact: new_l1 keeps free_h free_k hk half_edgeE twinE. Qed.

Lemma loop_l2 : l2_next_prev t'.
Proof.
move=> i /half_edgeP[||{}i li ih ik]; rewrite nextE prevE ?newE ?orbT /=; rewrite ?prevE ?nextE ?newE ?orbT //.
rewrite ih ik; have [E D] := keeps L2 i li; have [_ _ [m M lm] [p P lp] _] := links_of li.
by rewrite M P /= in E D *; rewrite prevE nextE !old_h ?old_k.
Qed.

Lemma loop_l3 : l3_target t'.
Proof.
move=> i /half_edgeP[||{}i li ih ik]; rewrite nextE twinE ?newE ?orbT /=; rewrite ?originE ?newE ?orbT //.
rewrite ih ik; have [_ [e E le] [m M lm] _ _] := links_of li; have := keeps L3 i li; rewrite E M /= => O.
by rewrite !originE !old_h ?old_k.
Qed.

Lemma loop_v1 : v1_leaving t'.
Proof.
move=> u e lu; rewrite leavingE; case: (u =P v) => [-> [<-]|_ E]; first by rewrite originE eqxx orbT.
by apply: origin_up; apply: (keeps V1).
Qed.

Lemma loop_v2 : v2_rotation t'.
Proof.
have h_k : on_orbit (turn t') h k by exists 1; rewrite /= /turn twinE eqxx /= nextE eqxx orbT.
have k_h : on_orbit (turn t') k h by exists 1; rewrite /= /turn twinE !newE /= nextE eqxx.
have up : forall y x, on_orbit (turn t) y x -> on_orbit (turn t') y x.
  move=> y x; apply: orbit_sub => u w z E ou; apply: orbit_step ou _; rewrite -E; move: E.
  rewrite /turn; case D: (twin t u) => [d|] //= N.
  by rewrite twinE old_h ?old_k ?(heard_live D) // D /= nextE old_h ?old_k ?(heard_live N).
move=> y x ly lx; split=> [/(on_rotation_origin loop_l1 loop_l3) ->//|].
have not_v i : half_edge t i -> Some v <> origin t i by move=> li /esym; apply: bare_v.
rewrite !originE; case: (half_edgeP ly) => [||{ly}y ly yh yk]; case: (half_edgeP lx) => [||{lx}x lx xh xk];
  rewrite ?newE ?orbT ?yh ?yk ?xh ?xk //=; try by move=> _; apply: orbit_refl.
- by move/not_v.
- by move/not_v.
- by move/esym/not_v.
- by move/esym/not_v.
by move=> E; apply: up; apply/(keeps V2 y x ly lx).
Qed.

(** ** B1, B2 *)

Lemma alone_on_cycle i j : next t' i = Some i -> on_cycle t' i j -> j = i.
Proof.
move=> N [m]; elim: m j => [|m IH] j /=; first by case.
by case E: (iter m _ _) => [u|] //=; rewrite (IH u E) N => -[].
Qed.

Lemma next_h : next t' h = Some h. Proof. by rewrite nextE eqxx. Qed.
Lemma next_k : next t' k = Some k. Proof. by rewrite nextE eqxx orbT. Qed.

Lemma not_kept i : boundary_of t i <> Some kept.
Proof.
move=> B; have [[w W _] _ _ _ _] := links_of (heard_live B); have [[e S] _] := on_side low B W.
by have := (starts_at_v kept).2 erefl; rewrite /starts_at_vertex S.
Qed.

Lemma not_made i : boundary_of t i <> Some made.
Proof.
move=> B; have [_ _ _ _ [c C lc]] := links_of (heard_live B); move: C lc; rewrite B => -[<-].
by rewrite (negPf free_boundary).
Qed.

Lemma loop_b1 : b1_cycle t'.
Proof.
have [C D] := keeps B1; have old_cycle e i : half_edge t e -> on_cycle t' e i <-> on_cycle t e i.
  move=> le; split=> [|]; last first.
    apply: orbit_sub => u w z E ou; apply: orbit_step ou _.
    by rewrite nextE old_h ?old_k ?(heard_live E).
  case=> m; suff H : forall i, iter m (obind (next t')) (Some e) = Some i -> half_edge t i /\ on_cycle t e i by case/H.
  elim: m => [|m IH] j /=; first by case=> <-; split=> //; apply: orbit_refl.
  case E: (iter m _ _) => [u|] //=; have [lu Cu] := IH u E; rewrite nextE old_h ?old_k //= => N.
  split; last exact: orbit_step Cu N.
  by have [_ _ [m' + lm] _ _] := links_of lu; rewrite N => -[->].
split=> [i|c i lc].
  case/half_edgeP=> [||{}i li ih ik]; rewrite nextE ?newE ?orbT ?ih ?ik //=.
  have [_ _ [m M lm] _ _] := links_of li; have := C i li; rewrite M /= => E.
  by rewrite !boundary_ofE !old_h ?old_k.
have lr := left_not_right; have old_not i' : boundary_of t i' <> Some left /\ boundary_of t i' <> Some right.
  by case: sides => -[-> ->]; split; (exact: not_kept || exact: not_made).
have away e i' : half_edge t i' -> next t' e = Some e -> half_edge t e = false -> ~ on_cycle t' e i'.
  by move=> li N ne /(alone_on_cycle N) E; rewrite E ne in li.
rewrite startE //; case/half_edgeP=> [||{}i li ih ik]; rewrite boundary_ofE ?newE ?ih ?ik.
- case: (c =P left) => [->|cl]; first by split=> // _; exists h => //; apply: orbit_refl.
  split=> [[/esym//]|[e]]; case: (c =P right) => [_ [<-] /(alone_on_cycle next_k)/eqP|cr S /(old_cycle e h (start_live S))].
    by rewrite newE.
  by move/(orbit_live keeps (start_live S)); rewrite (negPf free_h).
- case: (c =P left) => [->|cl].
    by split=> [[/esym/lr]|[_ [<-] /(alone_on_cycle next_h)/eqP]] //; rewrite newE.
  case: (c =P right) => [->|cr]; first by split=> // _; exists k => //; apply: orbit_refl.
  split=> [[/esym//]|[e S /(old_cycle e k (start_live S))/(orbit_live keeps (start_live S))]].
  by rewrite (negPf free_k).
have [nl nr] := old_not i; case: (c =P left) => [->|cl].
  by split=> [/nl|[_ [<-] /away []]] //; [exact: next_h|exact: negPf].
case: (c =P right) => [->|cr].
  by split=> [/nr|[_ [<-] /away []]] //; [exact: next_k|exact: negPf].
have [_ lc0] := otherP lc cl cr; rewrite (D c i lc0 li).
by split=> -[e S X]; exists e => //; apply/(old_cycle e i (start_live S)).
Qed.

Lemma starts_less u c : starts_at_vertex t' u c <-> u <> v /\ starts_at_vertex t u c.
Proof.
split=> [S|[uv S]].
  have lc := heard_live S; move: S; rewrite /starts_at_vertex startE //; case: eqP => // cl; case: eqP => // cr S.
  have [[ck _] _] := otherP lc cl cr; split=> // uv; apply: ck; apply/starts_at_v.
  by rewrite /starts_at_vertex S uv.
have ck : c <> kept.
  by move=> ck; move: S; rewrite ck /starts_at_vertex ((starts_at_v kept).2 erefl) => -[/esym].
have oc : other kept made c by split=> // cm; move: free_boundary; rewrite -cm (heard_live S).
have [cl cr] : c <> left /\ c <> right by case: oc; case: sides => -[-> ->].
have lc : boundary t' c by rewrite boundaryE (heard_live S) orbT.
by rewrite /starts_at_vertex startE // (introF eqP cl) (introF eqP cr).
Qed.

Lemma loop_b2 : b2_isolated t'.
Proof.
move=> u lu; rewrite isolatedE; case: (u =P v) => [->|uv].
  split=> [B|_]; first by have := B h live_h; rewrite originE eqxx.
  by split=> // c /starts_less[].
have [A N] := keeps B2 u lu; split=> [/(bare_old uv) /A[c [E S]]|nb].
  by exists c; split=> // d; rewrite -S; split=> [/starts_less[]//|X]; apply/starts_less.
have [|E S] := N; first by move=> B; apply: nb; apply/bare_old.
by split=> // c /starts_less[_]; apply: S.
Qed.

(** ** F1 to T4 *)

Lemma connected_same u w : connected t' u w <-> connected t u w.
Proof.
split; elim=> [|i x y _ IH X Y]; try exact: connected_self.
  have li : half_edge t' i := heard_live X; move: X Y; rewrite /target twinE originE.
  case: (half_edgeP li) => [||{}i {}li ih ik]; rewrite ?newE ?orbT /=.
  - by move=> [xv]; rewrite originE eqxx orbT => -[yv]; rewrite -yv xv.
  - by move=> [xv]; rewrite originE eqxx => -[yv]; rewrite -yv xv.
  rewrite ih ik /= => X; have [_ [d D ld] _ _ _] := links_of li; rewrite D /= originE old_h ?old_k // => Y.
  by apply: connected_edge IH X _; rewrite /target D.
apply: connected_edge IH (origin_up X) _; move: Y; rewrite /target twinE old_h ?old_k ?(heard_live X) //.
by case: (twin t i) => [d|] //= /origin_up.
Qed.

Lemma loop_rules : rules t'.
Proof.
have at_v i : (i == h) || (i == k) -> exists2 w, origin t' i = Some w & connected t v w.
  by move=> new; exists v; [rewrite originE new|apply: connected_self].
have V : vertex_at t kept = Some v by rewrite /vertex_at ((starts_at_v kept).2 erefl).
apply: (@new_face_rules t cut f g kept made left right of_old of_new moved keeps free_boundary free_face kept_in_f
  sides faces h k (fun c => erefl) (fun u => erefl) connected_same origin_up v V).
- by apply: at_v; rewrite eqxx.
- by apply: at_v; rewrite eqxx orbT.
- exact: loop_half_edges.
- exact: loop_vertices.
- exact: up_half_edge.
- exact: live_h.
- exact: live_k.
- exact: loop_l1.
- exact: loop_l2.
- exact: loop_l3.
- exact: loop_v1.
- exact: loop_v2.
- exact: loop_b1.
- exact: loop_b2.
exact: (edges_more keeps free_h free_k half_edgeE twinE).
Qed.

End Loop.

(** Let [h] and [k], [made] and [g] be free slots, and [kept] the boundary component of the isolated vertex [v]: if all
    rules held before, they hold after, whatever is told. *)
Theorem loop_at_isolated_keeps_rules t v h k f g kept made made_left new_left moved :
  isolated t v = Some kept -> boundary_face t kept = Some f ->
  ~~ half_edge t h -> ~~ half_edge t k -> h != k -> ~~ boundary t made -> ~~ face t g ->
  rules t -> rules (loop_at_isolated t v h k f g kept made made_left new_left moved).
Proof.
move=> iv kf fh fk hk fm fg keeps.
by rewrite /loop_at_isolated; apply: (loop_rules _ keeps fh fk hk fm fg iv kf);
  [case: made_left; auto|case: new_left; auto].
Qed.
