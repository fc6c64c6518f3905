(** * ConnectBridge: connecting two cycles keeps all rules (`bridge` in dcel/operators/connect.rs)

    The corners after [a] and after [b] are on two boundary components of one face, and both are cycles. The new edge makes
    one cycle of them. One of the two boundary components, [kept], has all half-edges then, and [dropped] is gone.

<<
      f ┌──────────────────┐         f ┌──────────────────┐       two inner ones: kept stays where it is listed.
        │   ┌──┐a    b┌──┐ │           │   ┌──┐a    b┌──┐ │       an outer one and an inner one: what is left is the
        │   └──┘      └──┘ │   ──►     │   └──┘──────└──┘ │       outer one, whether it is kept or dropped that was
        └──────────────────┘           └──────────────────┘       the outer one before.
>>

    So one inner boundary component is gone in either case: [dropped], or [kept], which is an outer one now. *)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import Arith View Rules Map Counting Lists TopologyProof Genus WholeEuler Verdict NewEdge ConnectCorners.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** True if the face [f] is bounded by [dropped]: then [kept] bounds it in its place. *)
Definition takes_over t f dropped := outer t f == Some dropped.

(** The rest of the list of the face [f]. *)
Definition bridge_list t f kept dropped :=
  [seq c <- inner_list t f | c != if takes_over t f dropped then kept else dropped].

(** The view [t] with the edge [h], [k] between the corners after [a] and after [b], which are on the boundary components
    [kept] and [dropped] of the face [f], in this order or the other. *)
Definition bridge t a b h k f kept dropped : view := let n := attach t a b h k in {|
  vertex_slots := vertex_slots n;
  half_edge_slots := half_edge_slots n;
  boundary_slots := boundary_slots n;
  face_slots := face_slots n;
  is_vertex := is_vertex n;
  is_half_edge := is_half_edge n;
  is_boundary := fun c => (c != dropped) && is_boundary n c;
  is_face := is_face n;
  says_origin := says_origin n;
  says_twin := says_twin n;
  says_next := says_next n;
  says_prev := says_prev n;
  says_boundary := fun i => if [|| i == h, i == k | boundary_of t i == Some dropped] then Some kept else says_boundary n i;
  says_leaving := says_leaving n;
  says_isolated := says_isolated n;
  says_boundary_face := says_boundary_face n;
  says_boundary_start := says_boundary_start n;
  says_boundary_place := fun c => if takes_over t f dropped && (c == kept) then Some Outer else
    if c \in bridge_list t f kept dropped then Some (Inner (seq.index c (bridge_list t f kept dropped)))
    else says_boundary_place n c;
  says_outer := fun g => if takes_over t f dropped && (g == f) then Some kept else says_outer n g;
  says_inner_count := fun g => if g == f then size (bridge_list t f kept dropped) else says_inner_count n g;
  says_inner := fun g i => if g == f then nth None [seq Some c | c <- bridge_list t f kept dropped] i else says_inner n g i
|}.

Section Bridge.
Variables (t : view) (a b h k f kept dropped ba bb na nb oa ob : nat).
Hypothesis keeps : rules t.
Hypothesis free_h : ~~ half_edge t h.
Hypothesis free_k : ~~ half_edge t k.
Hypothesis hk : h != k.
Hypothesis boundary_a : boundary_of t a = Some ba.
Hypothesis boundary_b : boundary_of t b = Some bb.
Hypothesis two : ba = kept /\ bb = dropped \/ ba = dropped /\ bb = kept.
Hypothesis differ : kept <> dropped.
Hypothesis kept_in_f : boundary_face t kept = Some f.
Hypothesis dropped_in_f : boundary_face t dropped = Some f.
Hypothesis next_a : next t a = Some na.
Hypothesis next_b : next t b = Some nb.
Hypothesis target_a : target t a = Some oa.
Hypothesis target_b : target t b = Some ob.

Notation t' := (bridge t a b h k f kept dropped).
Let low : lower t. Proof. by move=> q _; apply: keeps. Qed.
Let map : is_map t := low_map low.
Let live_a : half_edge t a := heard_live boundary_a.
Let live_b : half_edge t b := heard_live boundary_b.
Let live_kept : boundary t kept := heard_live kept_in_f.
Let live_dropped : boundary t dropped := heard_live dropped_in_f.

Lemma bridge_attached : attached t t' a b h k.
Proof. by have [] := attach_attached h k (low_r1 low) live_a live_b. Qed.

Let new := bridge_attached.
Let half_edgeE := half_edgeE new.
Let nextE := nextE new.
Let old_h := NewEdge.old_h free_h.
Let old_k := NewEdge.old_k free_k.
Let links_of := NewEdge.links_of keeps.
Let start_live := NewEdge.start_live keeps.
Let up_half_edge := NewEdge.up_half_edge half_edgeE.
Let half_edgeP := NewEdge.half_edgeP free_h free_k half_edgeE.
Let newE := NewEdge.newE hk.
Let origin_up := origin_up free_h free_k new.
Let connected_up := connected_up free_h free_k new.
Let connectedE := connectedE keeps free_h free_k hk new target_a target_b.
Let bare_attached := bare_attached keeps free_h free_k hk new live_a live_b.

Let a_not_b : a <> b.
Proof.
by move=> ab; move: boundary_a; rewrite ab boundary_b => -[bab]; case: two => -[A B]; apply: differ; rewrite -A -B bab.
Qed.

(** ** What the view says *)

Lemma boundaryE c : boundary t' c = (c != dropped) && boundary t c.
Proof. by rewrite {1}/boundary /= andbCA. Qed.

Lemma boundary_kept : boundary t' kept. Proof. by rewrite boundaryE live_kept andbT; apply/eqP. Qed.

Lemma boundary_up c : boundary t c -> c <> dropped -> boundary t' c.
Proof. by move=> lc cd; rewrite boundaryE lc andbT; apply/eqP. Qed.

Lemma boundary_ofE i : boundary_of t' i =
  if [|| i == h, i == k | boundary_of t i == Some dropped] then Some kept else boundary_of t i.
Proof.
rewrite {1}/boundary_of /heard half_edgeE /=; case: (i == h) => //=; case: (i == k) => //=.
by case: ifP => //= no; rewrite {1}/boundary_of /heard no; rewrite /boundary_of /heard no.
Qed.

Lemma faceE c : boundary_face t' c = if c == dropped then None else boundary_face t c.
Proof. by rewrite {1}/boundary_face /heard boundaryE /=; case: eqP. Qed.

Lemma startE c : boundary_start t' c = if c == dropped then None else boundary_start t c.
Proof. by rewrite {1}/boundary_start /heard boundaryE /=; case: eqP. Qed.

Notation took := (takes_over t f dropped).
Notation left := (bridge_list t f kept dropped).

(** The inner boundary component that is gone. *)
Definition gone := if took then kept else dropped.

Lemma leftP c : c \in left <-> [/\ c <> gone, is_inner t c & boundary_face t c = Some f].
Proof.
rewrite mem_filter -/gone; split=> [/andP[/eqP ne /(inner_listP low)[]] //|[/eqP -> I F]].
exact/(inner_listP low).
Qed.

Lemma left_uniq : uniq left. Proof. exact: filter_uniq (inner_list_uniq low f). Qed.

Lemma outer_place c : boundary t c -> boundary_face t c = Some f -> ~ is_inner t c -> outer t f = Some c.
Proof.
move=> lc; have [g [p [_ -> Ep L]]] := placeP low lc => -[<-] no.
by case: p Ep L => // i Ep; case: no; exists i.
Qed.

Lemma tookP : took -> outer t f = Some dropped. Proof. exact: eqP. Qed.

Lemma outer_not_inner c : outer t f = Some c -> ~ is_inner t c.
Proof. by move=> E [i]; have [_ ->] := @listed_names _ low f Outer c E. Qed.

Lemma gone_inner : is_inner t gone /\ boundary_face t gone = Some f.
Proof.
rewrite /gone; case: ifP => T; split=> //.
  have [g [p [_ Ef Ep L]]] := placeP low live_kept; move: Ef L; rewrite kept_in_f => -[<-] L.
  case: p Ep L => [|i] Ep L; last by exists i.
  by move: L; rewrite /= (tookP T) => -[/esym/differ].
have [g [p [_ Ef Ep L]]] := placeP low live_dropped; move: Ef L; rewrite dropped_in_f => -[<-] L.
case: p Ep L => [|i] Ep L; last by exists i.
by move: T; rewrite /takes_over -[outer t f]/(listed t f Outer) L eqxx.
Qed.

(** The other one of the two. *)
Definition stays := if took then dropped else kept.

Lemma stays_not_gone : stays <> gone.
Proof. by rewrite /stays /gone; case: ifP => _ // /esym. Qed.

Lemma stays_in_f : boundary_face t stays = Some f. Proof. by rewrite /stays; case: ifP. Qed.

Lemma placeE c : boundary t' c -> boundary_place t' c = if took && (c == kept) then Some Outer else
    if c \in left then Some (Inner (seq.index c left)) else boundary_place t c.
Proof. by move=> lc; rewrite {1}/boundary_place /heard lc /=; move: lc; rewrite boundaryE /boundary_place /heard => /andP[_ ->]. Qed.

Lemma outerE g : outer t' g = if took && (g == f) then Some kept else outer t g.
Proof.
rewrite {1}/outer /heard -[face t' g]/(face t g) /=; case: (boolP (took && (g == f))) => [/andP[T /eqP->]|//].
by rewrite (heard_live (tookP T)).
Qed.

Lemma live_f : face t f.
Proof. by have [[_ _ B _] _] := keeps R1; have [[g + lg] _] := B kept live_kept; rewrite kept_in_f => -[->]. Qed.

Lemma countE g : inner_count t' g = if g == f then size left else inner_count t g.
Proof. by rewrite {1}/inner_count /= -[face t' g]/(face t g); case: eqP => [->|_] //; rewrite live_f. Qed.

Lemma innerE g i c : inner t' g i = Some c <->
  if g == f then c \in left /\ seq.index c left = i else inner t g i = Some c.
Proof.
rewrite {1}/inner countE /=; case: eqP => [_|_]; last by [].
exact: listed_at left_uniq.
Qed.

Lemma is_innerE c : is_inner t' c <-> is_inner t c /\ c <> gone.
Proof.
have gone_place : boundary t' gone -> boundary_place t' gone = Some Outer.
  by move=> l; rewrite placeE // /gone; move: l; rewrite boundaryE /gone; case: (took); rewrite eqxx.
split=> [[i P]|[[i P] cg]].
  have lc := heard_live P; have cg : c <> gone by move=> E; rewrite E gone_place // -E in P.
  split=> //; move: P; rewrite (placeE lc); case: ifP => // _; case: ifP => [/leftP[] //|_ P]; by exists i.
have lc : boundary t c := heard_live P.
have lc' : boundary t' c.
  apply: boundary_up => // cd; move: cg P; rewrite /gone; case: ifP => [T _|_ //]; rewrite cd => P.
  by apply: (outer_not_inner (tookP T)); exists i.
rewrite /is_inner (placeE lc'); case: ifP => [/andP[T /eqP ck]|_]; first by case: cg; rewrite /gone T.
by case: ifP => _; [exists (seq.index c left)|exists i].
Qed.

(** ** R1 to L3 *)

Lemma two_start c : c = ba \/ c = bb -> exists g, boundary_start t c = Some (AtHalfEdge g).
Proof.
by case=> ->; [have [g S _] := start_of_cycle keeps boundary_a|have [g S _] := start_of_cycle keeps boundary_b]; exists g.
Qed.
Lemma kept_start : exists g, boundary_start t kept = Some (AtHalfEdge g).
Proof. by apply: two_start; case: two => -[-> ->]; auto. Qed.
Lemma dropped_start : exists g, boundary_start t dropped = Some (AtHalfEdge g).
Proof. by apply: two_start; case: two => -[-> ->]; auto. Qed.

Lemma starts_same u c : starts_at_vertex t' u c <-> starts_at_vertex t u c.
Proof.
rewrite /starts_at_vertex startE; case: eqP => [->|_] //; split=> // S.
by have [g] := dropped_start; rewrite S.
Qed.

Lemma listed_bridge g p c : listed t' g p = Some c ->
  [/\ boundary t' c, boundary_face t' c = Some g & boundary_place t' c = Some p].
Proof.
move=> L; have [lc cd Fc] : [/\ boundary t c, c <> dropped & boundary_face t c = Some g].
  case: p L => [|i] /=.
    rewrite outerE; case: ifP => [/andP[_ /eqP->] [<-]|no O] //.
    have [Fc _] := @listed_names _ low g Outer c O; split=> //; first exact: heard_live Fc.
    move=> cd; move: Fc; rewrite cd dropped_in_f => -[fg].
    by move: no; rewrite -fg eqxx andbT /takes_over fg O cd eqxx.
  move/innerE; case: eqP => [->|gf I].
    move=> [/leftP[cg [j P] Fc] _]; split=> //; first exact: heard_live P.
    move=> cd; move: cg; rewrite /gone; case: ifP => // T _; apply: (outer_not_inner (tookP T)).
    by exists j; rewrite -cd.
  have [Fc Pc] := @listed_names _ low g (Inner i) c I; split=> //; first exact: heard_live Fc.
  by move=> cd; case: gf; move: Fc; rewrite cd dropped_in_f => -[].
have lc' := boundary_up lc cd; split=> //; first by rewrite faceE; case: eqP.
rewrite placeE //; case: p L => [|i] /=.
  rewrite outerE; case: ifP => [/andP[-> _] [<-]|no O]; first by rewrite eqxx.
  have [_ Pc] := @listed_names _ low g Outer c O; case: ifP => // _.
  by case: ifP => [/leftP[_ [i]]|_]; rewrite Pc.
move/innerE; case: eqP => [gf [cl <-]|gf I].
  rewrite cl; case: ifP => // /andP[T /eqP ck]; move/leftP: cl => [cg _ _].
  by case: cg; rewrite /gone T.
have [Fc' Pc] := @listed_names _ low g (Inner i) c I; case: ifP => [/andP[_ /eqP ck]|_].
  by case: gf; move: Fc'; rewrite ck kept_in_f => -[].
by case: ifP => // /leftP[_ _]; rewrite Fc' => -[/gf].
Qed.

Lemma bridge_f2 : f2_listed t'.
Proof.
apply: f2_if => [c lc|g p c /listed_bridge[]//].
move: (lc); rewrite boundaryE => /andP[/eqP cd lc0].
have [g [p [lg Ef Ep L]]] := placeP low lc0; exists g.
suff [q L'] : exists q, listed t' g q = Some c.
  by have [_ Fc Pc] := listed_bridge L'; exists q.
case: p Ep L => [|i] Ep L.
  exists Outer; rewrite /= outerE; case: ifP => // /andP[T /eqP gf]; rewrite gf /= (tookP T) in L.
  by case: L => /esym.
case: (g =P f) => [gf|gf]; last by exists (Inner i); apply/innerE; case: eqP.
case: (c =P gone) => [cg|cg].
  exists Outer; rewrite /= outerE gf eqxx andbT.
  by move: cg; rewrite /gone; case: ifP => // _ ->.
exists (Inner (seq.index c left)); apply/innerE; rewrite gf eqxx; split=> //; apply/leftP; split=> //; last by rewrite -gf.
by exists i.
Qed.

Lemma bridge_links : links_live t'.
Proof.
have [[H V B F] _] := keeps R1; split.
- move=> i li; have [A1 A2 A3 A4] := attached_links keeps free_h free_k hk new live_a live_b next_a next_b target_a target_b li.
  split=> //; rewrite boundary_ofE; case: ifP => [_|no]; first by exists kept; rewrite ?boundary_kept.
  case/half_edgeP: li no => [||{A1 A2 A3 A4}i li ih ik]; rewrite ?eqxx ?orbT // ih ik /= => no.
  have [_ _ _ _ [c C lc]] := H i li; exists c => //; apply: boundary_up => // cd.
  by rewrite C cd eqxx in no.
- move=> u lu; have [L I] := V u lu; split.
    by case: L => [[g G lg]|[N Bu]]; [left; exists g; rewrite ?up_half_edge|right; split=> //; apply/bare_attached].
  case: I => [N|[c C lc]]; [by left|right; exists c => //; apply: boundary_up => // cd].
  have [A N] := keeps B2 u lu; case: (vertexP low lu) => [x _ xu|d _ bu Id S].
    have [Iu _] : isolated t u = None /\ forall d, ~ starts_at_vertex t u d by apply: N; rewrite -xu; apply: not_bare low x.
    by move: C; rewrite Iu.
  move: C; rewrite Id => -[dc]; have [g] := dropped_start.
  by move: S; rewrite /starts_at_vertex dc cd => ->.
- move=> c; rewrite boundaryE faceE startE => /andP[/negPf -> lc]; have [L S] := B c lc; split=> //.
  by case: (boundary_start t c) S => [[i|u]|] //= l; apply: up_half_edge.
move=> g lg; split=> [|i lt].
  case O: (outer t' g) => [c|]; [right; exists c => //|by left].
  by have [] := @listed_bridge g Outer c O.
case I: (inner t' g i) => [c|]; first by exists c => //; have [] := @listed_bridge g (Inner i) c I.
move: I; rewrite /inner lt /= -/left; move: lt; rewrite countE; case: eqP => [_ lt|_ lt].
  by rewrite (nth_map 0).
have [_ /(_ i lt)[c E _]] := F g lg; by move: E; rewrite /inner lt => ->.
Qed.

Lemma bridge_r1 : r1_live t'.
Proof. by split; [exact: bridge_links|exact: lists_short_listed bridge_links bridge_f2]. Qed.

Lemma bridge_l1 : l1_twin t'. Proof. exact: (attached_l1 keeps free_h free_k hk new). Qed.
Lemma bridge_l2 : l2_next_prev t'.
Proof. exact: (attached_l2 keeps free_h free_k hk new live_a live_b next_a next_b). Qed.
Lemma bridge_l3 : l3_target t'.
Proof. exact: (attached_l3 keeps free_h free_k hk new live_a live_b next_a next_b). Qed.

Let map' : is_map t'.
Proof. by have [H _ _ _] := bridge_links; split; [|exact: bridge_l1|exact: bridge_l2|exact: bridge_l3]. Qed.

(** ** V1, V2 *)

Lemma bridge_v1 : v1_leaving t'. Proof. by move=> u g lu E; apply: origin_up; apply: (keeps V1). Qed.

Lemma bridge_v2 : v2_rotation t'.
Proof. exact: (attached_v2 keeps free_h free_k hk new live_a live_b next_a next_b map'). Qed.

(** ** B1: all half-edges of the two boundary components are on one cycle now *)

Let next_boundary := next_boundary keeps.
Let cycle_of := cycle_of keeps.

(** A cycle from the new edge on: from [y], the next one after [x], all that is on its old cycle is reached. *)
Lemma cycle_from x y z i : (x = a /\ z = b) \/ (x = b /\ z = a) -> next t x = Some y -> boundary_of t x <> boundary_of t z ->
  on_cycle t y i -> on_cycle t' y i.
Proof.
move=> xz N ne; suff H m j : iter m (obind (next t)) (Some y) = Some j -> boundary_of t j = boundary_of t x /\ on_cycle t' y j.
  by case=> m /H[].
elim: m j => [|m IH] j /=; first by case=> <-; split; [exact: next_boundary|exact: orbit_refl].
case E: (iter m _ _) => [u|] //= U; have [Bu Cu] := IH u E; split; first by rewrite (next_boundary U).
case: (u =P x) => [ux|ux]; first by move: U; rewrite ux N => -[<-]; apply: orbit_refl.
have uz : u <> z by move=> uz; apply: ne; rewrite -Bu uz.
apply: orbit_step Cu _; rewrite nextE old_h ?old_k ?(heard_live U) //.
by case: xz => -[xa zb]; rewrite -xa -zb (introF eqP ux) (introF eqP uz).
Qed.

Let live_new := live_new new.

Lemma ends_differ : boundary_of t a <> boundary_of t b.
Proof. by rewrite boundary_a boundary_b => -[E]; case: two => -[A B]; apply: differ; rewrite -A -B. Qed.

Lemma on_new i : boundary_of t' i = Some kept -> on_cycle t' h i.
Proof.
have H_nb : on_cycle t' h nb by apply: orbit_step (orbit_refl _ _) _; rewrite nextE eqxx.
have of_b j : boundary_of t j = Some bb -> on_cycle t' h j.
  move=> Bj; apply: orbit_trans H_nb _; apply: (@cycle_from b nb a j) => //; [by right|exact/nesym/ends_differ|].
  by apply: cycle_of Bj; rewrite (next_boundary next_b).
have K : on_cycle t' h k.
  apply: orbit_step (of_b b boundary_b) _; rewrite nextE old_h ?old_k // eqxx.
  by case: eqP => // ba'; case: a_not_b.
have K_na : on_cycle t' h na by apply: orbit_step K _; rewrite nextE !newE; case: eqP.
have of_a j : boundary_of t j = Some ba -> on_cycle t' h j.
  move=> Bj; apply: orbit_trans K_na _; apply: (@cycle_from a na b j) => //; [by left|exact: ends_differ|].
  by apply: cycle_of Bj; rewrite (next_boundary next_a).
rewrite boundary_ofE; case: (i =P h) => [->|_] /=; first by move=> _; apply: orbit_refl.
case: (i =P k) => [-> //|_] /=.
have side : boundary_of t i = Some dropped \/ boundary_of t i = Some kept -> on_cycle t' h i.
  case: two => -[A B] [] Bi; [apply: of_b|apply: of_a|apply: of_a|apply: of_b]; by rewrite ?A ?B.
by case: eqP => [D _|_ B]; apply: side; auto.
Qed.

Lemma constant i : half_edge t' i -> next t' i >>= boundary_of t' = boundary_of t' i.
Proof.
have oldE j : half_edge t j -> boundary_of t' j = if boundary_of t j == Some dropped then Some kept else boundary_of t j.
  by move=> lj; rewrite boundary_ofE old_h ?old_k.
have side j c n : half_edge t j -> next t j = Some n -> boundary_of t j = Some c -> c = kept \/ c = dropped ->
    boundary_of t' n = Some kept /\ boundary_of t' j = Some kept.
  move=> lj N B cc; have [_ _ [m M lm] _ _] := links_of lj; move: M lm; rewrite N => -[<-] ln.
  rewrite !oldE // (next_boundary N) B; case: cc => ->; rewrite ?eqxx //.
  by case: eqP.
have sa : ba = kept \/ ba = dropped by case: two => -[-> _]; auto.
have sb : bb = kept \/ bb = dropped by case: two => -[_ ->]; auto.
have [Na Ka] := side a ba na live_a next_a boundary_a sa; have [Nb Kb] := side b bb nb live_b next_b boundary_b sb.
have Kh : boundary_of t' h = Some kept by rewrite boundary_ofE eqxx.
have Kk : boundary_of t' k = Some kept by rewrite boundary_ofE eqxx orbT.
case/half_edgeP=> [||{}i li ih ik]; rewrite nextE ?newE ?ih ?ik.
- by rewrite next_b /= Nb Kh.
- by case: (a == b); rewrite ?next_a /= ?Na Kk.
case: (i =P a) => [->|_] /=; first by rewrite Kh Ka.
case: (i =P b) => [->|_] /=; first by rewrite Kk Kb.
have [_ _ [m M lm] _ _] := links_of li; rewrite M /= !oldE //.
by rewrite (next_boundary M).
Qed.

Lemma bridge_b1 : b1_cycle t'.
Proof.
split=> [i /constant //|c i]; rewrite boundaryE => /andP[/eqP cd lc] li.
have side x : x = kept \/ x = dropped -> c <> kept -> x <> c by case=> -> ck => [/esym|/esym].
have not_ends : c <> kept -> boundary_of t a <> Some c /\ boundary_of t b <> Some c.
  by rewrite boundary_a boundary_b => ck; case: two => -[-> ->]; split=> -[]; apply: side => //; auto.
have startE' g : boundary_start t' c = Some (AtHalfEdge g) <-> boundary_start t c = Some (AtHalfEdge g).
  by rewrite startE; case: eqP.
have Bstart g : boundary_start t c = Some (AtHalfEdge g) -> boundary_of t' g = Some c.
  move=> S; rewrite boundary_ofE old_h ?old_k ?(start_live S) //= (start_on_cycle keeps S).
  by case: eqP => // -[/cd].
split=> [Bi|[g /startE' /Bstart <-]]; last exact: constant_on_cycle constant.
case: (c =P kept) => [ck|ck].
  have [g S] := kept_start; rewrite ck in Bi startE' Bstart *; exists g; first exact/startE'.
  have [lh _] := live_new; apply: orbit_trans (on_new Bi).
  exact: (cycle_sym map' lh (up_half_edge (start_live S)) (on_new (Bstart g S))).
have [na' nb'] := not_ends ck; move: Bi; rewrite boundary_ofE.
case: ifP => [_ [/esym]//|_ Bi]; have [g S C] := start_of_cycle keeps Bi; exists g; first exact/startE'.
exact: (cycle_away keeps free_h free_k new (start_on_cycle keeps S) na' nb' C).
Qed.

(** ** B2, F1 *)

Lemma bridge_b2 : b2_isolated t'.
Proof.
move=> u lu; have [A N] := keeps B2 u lu; split=> [/bare_attached /A[c [E S]]|not_bare].
  by exists c; split=> // d; rewrite -S; apply: starts_same.
have [|E S] := N; first by move=> B; apply: not_bare; apply/bare_attached.
by split=> // c /starts_same; apply: S.
Qed.

Lemma unboundedE g : unbounded t' g <-> unbounded t g.
Proof.
rewrite /unbounded outerE -[face t' g]/(face t g); case: ifP => // /andP[T /eqP->].
by rewrite (tookP T); split=> -[].
Qed.

Lemma bridge_f1 : f1_outer t'.
Proof.
have [[g [U one]] O] := keeps F1; split.
  by exists g; split; [apply/unboundedE|move=> g' /unboundedE; apply: one].
move=> g' c u; rewrite outerE; case: ifP => [_ [<-] /starts_same|_ E /starts_same]; last exact: O E.
by have [s S] := kept_start; rewrite /starts_at_vertex S.
Qed.

(** ** T1 to T3: two components become one, and what is gone was the outside of one of them *)

(** The ends of the new edge: on the component of which the outside is gone, and on the other. *)
Lemma ends : exists og os, [/\ (og = oa /\ os = ob) \/ (og = ob /\ os = oa),
  exists2 v, vertex_at t gone = Some v & connected t v og & exists2 v, vertex_at t stays = Some v & connected t v os].
Proof.
have at_a : exists2 v, vertex_at t ba = Some v & connected t v oa.
  have O : origin t na = Some oa by rewrite (origin_next keeps live_a next_a).
  have B : boundary_of t na = Some ba by rewrite (next_boundary next_a).
  by have [_] := on_side low B O.
have at_b : exists2 v, vertex_at t bb = Some v & connected t v ob.
  have O : origin t nb = Some ob by rewrite (origin_next keeps live_b next_b).
  have B : boundary_of t nb = Some bb by rewrite (next_boundary next_b).
  by have [_] := on_side low B O.
have : (gone = ba /\ stays = bb) \/ (gone = bb /\ stays = ba).
  by rewrite /gone /stays; case: (took); case: two => -[-> ->]; auto.
by case=> -[-> ->]; [exists oa, ob|exists ob, oa]; split=> //; auto.
Qed.

Section Ends.
Variables (og os : nat).
Hypothesis ends_are : (og = oa /\ os = ob) \/ (og = ob /\ os = oa).
Hypothesis at_gone : exists2 v, vertex_at t gone = Some v & connected t v og.
Hypothesis at_stays : exists2 v, vertex_at t stays = Some v & connected t v os.

Let sym := connected_sym map.
Let trans := @connected_trans t.

Lemma live_end c v u : vertex_at t c = Some v -> connected t v u -> vertex t u.
Proof. by move=> W; apply: (NewEdge.connected_live keeps); apply: vertex_at_live keeps _ _ W. Qed.

Lemma live_os : vertex t os. Proof. by case: at_stays => v; apply: live_end. Qed.
Lemma live_og : vertex t og. Proof. by case: at_gone => v; apply: live_end. Qed.

Lemma outside_gone u : outside_of t u gone <-> connected t u og.
Proof.
have [I _] := gone_inner; have [v W C] := at_gone; split=> [[_ [w]]|Cu]; last first.
  by split=> //; exists v => //; apply: trans Cu (sym C).
by rewrite W => -[<-] Cu; apply: trans Cu C.
Qed.

Lemma separate : ~ connected t og os.
Proof.
move=> C; have O : outside_of t os gone by apply/outside_gone; apply: sym.
have [v W Cv] := at_stays; have [c [Oc one]] := keeps T1 os live_os.
have stays_live : boundary t stays by rewrite /stays; case: (took).
case I: (boundary_place t stays) => [[|i]|].
- have E : outer t f = Some stays.
    by apply: outer_place => //; [exact: stays_in_f|move=> [j]; rewrite I].
  have R := face_rooted low (keeps T1) (keeps T2) live_f; have [_ Fg] := gone_inner.
  apply: (not_in_itself (keeps T1) R E W (live_end W (connected_self _ _)) _ Fg).
  by case: O => Ig [w Wg Cg]; split=> //; exists w => //; apply: trans Cv Cg.
- apply: stays_not_gone; rewrite -(one gone O); apply/esym/one; split; first by exists i.
  by exists v => //; apply: sym.
by have [g [p [_ _ P _]]] := placeP low stays_live; move: P; rewrite I.
Qed.

Lemma joinedE u w : connected t' u w <->
  [\/ connected t u w, connected t u og /\ connected t os w | connected t u os /\ connected t og w].
Proof.
apply: iff_trans (connectedE u w) _; case: ends_are => -[-> ->] //.
by split=> -[C|C|C]; [constructor 1|constructor 3|constructor 2|constructor 1|constructor 3|constructor 2].
Qed.

Lemma vertex_atE c : boundary t' c -> vertex_at t' c = vertex_at t c.
Proof.
rewrite boundaryE => /andP[/negPf cd lc]; rewrite /vertex_at startE cd.
case S: (boundary_start t c) => [[g|//]|//]; have lg := start_live S.
by have [[v V _] _ _ _ _] := links_of lg; rewrite V; apply: origin_up.
Qed.

(** If the removed one was not the outside, the outside is as it was. *)
Lemma outside_up u c : outside_of t u c -> c <> gone -> outside_of t' u c.
Proof.
move=> [I [w W C]] cg; have I' : is_inner t' c by apply/is_innerE.
have lc : boundary t' c by case: I' => i P; apply: heard_live P.
by split=> //; exists w; [rewrite vertex_atE|apply: connected_up].
Qed.

(** The outside of the other component is that of both. *)
Lemma outside_other u c : connected t u og -> outside_of t os c -> outside_of t' u c.
Proof.
move=> C O; have cg : c <> gone by move=> E; rewrite E in O; apply: separate; apply/sym/outside_gone.
case: (outside_up O cg) => I [w W C']; split=> //; exists w => //.
apply: connected_trans C'; apply/joinedE; constructor 2; split=> //; exact: connected_self.
Qed.

Lemma outside_down u c : outside_of t' u c ->
  c <> gone /\ (outside_of t u c \/ connected t u og /\ outside_of t os c).
Proof.
case=> /[dup] I' /is_innerE[I cg] [w]; have lc : boundary t' c by case: I' => i P; apply: heard_live P.
rewrite vertex_atE // => W /joinedE[C|[A C]|[A C]]; split=> //.
- by left; split=> //; exists w.
- by right; split=> //; split=> //; exists w.
case: cg; have [d [_ one]] := keeps T1 og live_og.
rewrite -(one gone); last by apply/outside_gone; apply: connected_self.
by apply/esym/one; split=> //; exists w.
Qed.

(** Both components are one. *)
Lemma all_joined u w : connected t u og \/ connected t u os -> connected t w og \/ connected t w os -> connected t' u w.
Proof.
case=> U [] W; apply/joinedE.
- by constructor 1; apply: trans U (sym W).
- by constructor 2; split=> //; apply: sym.
- by constructor 3; split=> //; apply: sym.
by constructor 1; apply: trans U (sym W).
Qed.

Lemma ends_t1 : t1_outside t'.
Proof.
move=> u lu; have [c [O one]] := keeps T1 u lu; case: (c =P gone) => cg.
  have C : connected t u og by apply/outside_gone; rewrite -cg.
  have [d [Od oned]] := keeps T1 os live_os; exists d; split; first exact: outside_other.
  by move=> e /outside_down[eg [Oe|[_ /oned]//]]; case: eg; rewrite -(one e Oe).
exists c; split; first exact: outside_up.
move=> e /outside_down[eg [/one //|[C _]]]; case: cg; apply: one; exact/outside_gone.
Qed.

Lemma bounds_still g c w : outer t g = Some c -> vertex_at t c = Some w -> exists c' w',
  [/\ outer t' g = Some c', vertex_at t' c' = Some w' & connected t' w' w].
Proof.
move=> O W; case T: (took && (g == f)).
  have [v V Cv] := at_gone; have [s S Cs] := at_stays; exists kept, v; rewrite outerE T.
  have [tk /eqP gf] := andP T; move: V S; rewrite /gone /stays tk => V S.
  split=> //; first by rewrite vertex_atE // boundary_kept.
  apply: all_joined; first by left.
  by move: O; rewrite gf (tookP tk) => -[dc]; move: W; rewrite -dc S => -[<-]; right.
have O' : outer t' g = Some c by rewrite outerE T.
have [lc _ _] := @listed_bridge g Outer c O'.
by exists c, w; split=> //; [rewrite vertex_atE|exact: connected_self].
Qed.

Lemma rooted_up g : rooted t g -> rooted t' g.
Proof.
elim=> {g} [g /unboundedE U|g c w d g' O W Od Ed _ IH]; first exact: rooted_here.
have [c' [w' [O' W' C']]] := bounds_still O W.
have out e h' : outside_of t' w e -> boundary_face t e = Some h' -> rooted t' h' -> rooted t' g.
  move=> [I [v V C]] Ee R; apply: (@rooted_out t' g c' w' e h') => //.
    by split=> //; exists v => //; apply: connected_trans C' C.
  have le : boundary t' e by case: I => i P; apply: heard_live P.
  by rewrite faceE; case: eqP le => // ->; rewrite boundaryE eqxx.
case: (d =P gone) => dg; last by apply: (out d g') => //; apply: outside_up.
have Cw : connected t w og by apply/outside_gone; rewrite -dg.
have gf : g' = f by move: Ed; rewrite dg; have [_ ->] := gone_inner => -[].
rewrite gf in IH; have [s S Cs] := at_stays; have ls : boundary t stays by rewrite /stays; case: (took).
case I: (boundary_place t stays) => [[|i]|]; last 2 first.
- apply: (out stays f) => //; last exact: stays_in_f.
  by apply: outside_other => //; split; [exists i|exists s => //; apply: sym].
- by have [x [p [_ _ P _]]] := placeP low ls; move: P; rewrite I.
have E : outer t f = Some stays by apply: outer_place => //; [exact: stays_in_f|move=> [j]; rewrite I].
have [c2 [w2 [O2 W2 C2]]] := bounds_still E S.
have [e [h' [[Ie [v V C]] Ee R]]] := rooted_from IH O2 W2; apply: (@rooted_out t' g c' w' e h') => //.
split=> //; exists v => //; apply: connected_trans C' (connected_trans _ C).
apply: (connected_sym map'); apply: connected_trans C2 _; apply: all_joined; [by right|by left].
Qed.

Lemma ends_t2 : t2_nesting t'.
Proof.
move=> u c g lu [[i P] _]; have lc : boundary t c by move: (heard_live P); rewrite boundaryE => /andP[].
rewrite faceE; case: eqP => // _ Ec; apply: rooted_up.
apply: (face_rooted low (keeps T1) (keeps T2)).
by have [[_ _ B _] _] := keeps R1; have [[g' + lg] _] := B c lc; rewrite Ec => -[->].
Qed.

End Ends.

Lemma bridge_t1 : t1_outside t'.
Proof. by have [og [os [E G S]]] := ends; apply: (ends_t1 E G S). Qed.

Lemma bridge_t2 : t2_nesting t'.
Proof. by have [og [os [E G S]]] := ends; apply: (ends_t2 E G S). Qed.

(** One edge more, and one inner boundary component less. *)
Lemma bridge_t3 : t3_euler t'.
Proof.
have low' : lower t'.
  case=> // _; [exact: bridge_r1|exact: bridge_l1|exact: bridge_l2|exact: bridge_l3|exact: bridge_v1|
    exact: bridge_v2|exact: bridge_b1|exact: bridge_b2|exact: bridge_f1|exact: bridge_f2].
have [es He] := edges_each low; have He' := edges_attached keeps free_h free_k new He.
have Hv := lists_filter (@vertex_below t) (fun v => iff_refl (vertex t v)).
have Hf := lists_filter (@face_below t) (fun g => iff_refl (face t g)).
have u : uniq (inner_ones t) by rewrite !filter_uniq ?iota_uniq.
have Hb : lists (inner_ones t) (is_inner t) by split=> // c; apply: inner_onesP.
have Hb' : lists (rem gone (inner_ones t)) (is_inner t').
  split=> [|c]; first exact: rem_uniq.
  rewrite mem_rem_uniq // inE /=; split=> [/andP[/eqP cg /(inner_onesP low) I]|/is_innerE[I cg]].
    exact/is_innerE.
  by apply/andP; split; [apply/eqP|apply/(inner_onesP low)].
have eq := (t3_counts low (keeps T1) Hv He Hf Hb).1 (keeps T3).
apply/(t3_counts low' bridge_t1 Hv He' Hf Hb'); rewrite eq.
have in_gone : gone \in inner_ones t by apply/(inner_onesP low); case: gone_inner.
by rewrite size_rem //=; case: (inner_ones t) in_gone => //= c s _; arith.
Qed.

Lemma bridge_rules : rules t'.
Proof.
have H r : index r < index T4 -> holds t' r.
  case: r => // _; [exact: bridge_r1|exact: bridge_l1|exact: bridge_l2|exact: bridge_l3|exact: bridge_v1|
    exact: bridge_v2|exact: bridge_b1|exact: bridge_b2|exact: bridge_f1|exact: bridge_f2|exact: bridge_t1|
    exact: bridge_t2|exact: bridge_t3].
by move=> r; case: (ltnP (index r) (index T4)) => [/H //|]; case: r => // _; apply: t4_follows => q; apply: H.
Qed.

End Bridge.

(** Let [h] and [k] be free slots, and the corners after [a] and after [b] be on two boundary components of one face:
    if all rules held before, they hold after, whichever of the two is kept. *)
Theorem bridge_keeps_rules t a b h k f kept dropped :
  boundary_of t a = Some kept /\ boundary_of t b = Some dropped \/
  boundary_of t a = Some dropped /\ boundary_of t b = Some kept ->
  kept <> dropped -> boundary_face t kept = Some f -> boundary_face t dropped = Some f ->
  ~~ half_edge t h -> ~~ half_edge t k -> h != k ->
  rules t -> rules (bridge t a b h k f kept dropped).
Proof.
move=> sides kd kf df fh fk hk keeps.
have [ba [bb [Ba Bb two]]] : exists ba bb, [/\ boundary_of t a = Some ba, boundary_of t b = Some bb &
    ba = kept /\ bb = dropped \/ ba = dropped /\ bb = kept].
  by case: sides => -[-> ->]; [exists kept, dropped|exists dropped, kept]; split=> //; [left|right].
have links c e : boundary_of t c = Some e -> exists n o, next t c = Some n /\ target t c = Some o.
  move=> B; have lc := heard_live B; have [_ [d D ld] [n N _] _ _] := links_of keeps lc; have [[o O _] _ _ _ _] := links_of keeps ld.
  by exists n, o; rewrite /target D.
have [na [oa [Na Ta]]] := links a ba Ba; have [nb [ob [Nb Tb]]] := links b bb Bb.
exact: (bridge_rules keeps fh fk hk Ba Bb two kd kf df Na Nb Ta Tb).
Qed.
