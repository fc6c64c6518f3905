(** * LabelsComplete: where all rules hold, there are ranks that are accepted *)

From mathcomp Require Import all_ssreflect all_fingroup.
From twinedge Require Import Arith View Rules Loops LoopsProof Reference Map Counting Lists ReferenceProof TopologyProof.
From twinedge Require Import Drawing Subdivision Euler Numbered Genus WholeEuler Verdict Labels Orbits LabelsSound.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** ** What leads down to a base can be put in order *)

Section Order.
Variables (base : nat -> Prop) (down : nat -> nat -> Prop).

Inductive grounded x : Prop :=
  | grounded_base of base x
  | grounded_down y of down x y & grounded y.

(** Each is a base, or leads down to one that comes later in the list. *)
Fixpoint ordered (s : seq nat) : Prop :=
  if s is x :: r then [/\ base x \/ exists2 y, y \in r & down x y, x \notin r & ordered r] else True.

Fixpoint rank_in (s : seq nat) x : nat := if s is y :: r then if x == y then size s else rank_in r x else 0.

Lemma rank_in_size s x : rank_in s x <= size s.
Proof. by elim: s => //= y r IH; case: eqP => // _; apply: leqW. Qed.

Lemma ordered_rank s x : ordered s -> x \in s ->
  base x \/ exists2 y, y \in s & down x y /\ rank_in s y < rank_in s x.
Proof.
elim: s => //= z r IH [zr nz o]; rewrite inE; case: eqP => [-> _|ne /= xr].
  case: zr => [bz|[y yr zy]]; [by left|right; exists y; first by rewrite inE yr orbT].
  by split=> //; case: eqP => [yz|_]; [rewrite yz (negPf nz) in yr|rewrite ltnS rank_in_size].
case: (IH o xr) => [bx|[y yr [xy lt]]]; [by left|right; exists y; first by rewrite inE yr orbT].
by split=> //; case: eqP => [yz|//]; rewrite yz (negPf nz) in yr.
Qed.

Lemma ordered_more s x : ordered s -> grounded x -> exists r, [/\ ordered r, {subset s <= r} & x \in r].
Proof.
move=> o; elim=> {x} [x bx|x y xy _ [r [or sub yr]]].
  case: (boolP (x \in s)) => xs; first by exists s; split.
  exists (x :: s); split=> /= [|y ys|]; [by split=> //; left|by rewrite inE ys orbT|exact: mem_head].
case: (boolP (x \in r)) => xr; first by exists r; split.
exists (x :: r); split=> /= [|z /sub zr|]; [by split=> //; right; exists y|by rewrite inE zr orbT|exact: mem_head].
Qed.

Theorem ranks_exist (s : seq nat) : (forall x, x \in s -> grounded x) ->
  exists rank : nat -> nat, forall x, x \in s -> base x \/ exists2 y, down x y & rank y < rank x.
Proof.
suff H : (forall x, x \in s -> grounded x) -> exists r, ordered r /\ {subset s <= r}.
  move/H=> [r [o sub]]; exists (rank_in r) => x /sub/(ordered_rank o)[bx|[y _ []]]; first by left.
  by right; exists y.
elim: s => [|x s IH] g; first by exists [::].
case: IH => [y ys|r [o sub]]; first by apply: g; rewrite inE ys orbT.
have [r' [o' sub' xr]] := ordered_more o (g x (mem_head _ _)); exists r'; split=> // y.
by rewrite inE => /orP[/eqP->|/sub/sub'].
Qed.
End Order.

Section Complete.
Variable t : view.
Hypothesis low : lower t.
Hypothesis t1 : t1_outside t.
Hypothesis t2 : t2_nesting t.
Hypothesis t3 : t3_euler t.

Let map := low_map low.

(** ** Every half-edge leads down to the unbounded face *)

(** The half-edge is where the outside of its component starts, which lies in the face. *)
Definition root_in h f := exists b,
  [/\ boundary_of t h = Some b, boundary_start t b = Some (AtHalfEdge h), is_inner t b & boundary_face t b = Some f].

Definition bottom h := exists2 f, root_in h f & outer t f = None.

Definition down h g := g \in near t h \/ exists2 f, root_in h f & outer t f >>= cycle_start t = Some g.

Lemma grounded_reached x y : reached (near t) x y -> grounded bottom down y -> grounded bottom down x.
Proof. by elim=> // u w _ IH uw gw; apply: IH; apply: (@grounded_down _ _ u w) => //; left. Qed.

Lemma start_root (x : dart t) b f : outside_of t (org x) b -> boundary_face t b = Some f ->
  exists y : dart t, joined x y /\ root_in (num y) f.
Proof.
case/(outside_dart low)=> I [y S xy] Ef; exists y; split=> //; exists b; split=> //.
have := boundaryP low (heard_live S); case=> [z|v]; rewrite S // => -[yz] zb.
by rewrite yz (boundaryE map) zb.
Qed.

Lemma root_grounded f : rooted t f -> forall h, root_in h f -> grounded bottom down h.
Proof.
elim=> {f} [f [_ E] h r|f b w b' f' E W O Ef _ IH h r].
  by apply: grounded_base; exists f.
have lf : face t f by apply: heard_live E.
case: (faceP low lf) => [|z]; rewrite E // => -[bz] S; rewrite -bz in S.
apply: (@grounded_down _ _ h (num z)); first by right; exists f; rewrite // E /= /cycle_start S.
have wz : w = org z by move: W; rewrite (vertex_at_cycle low S) => -[].
rewrite wz in O; have [y [zy ry]] := start_root O Ef.
by apply: grounded_reached zy _; apply: IH.
Qed.

Lemma all_grounded (x : dart t) : grounded bottom down (num x).
Proof.
have [b [O _]] := t1 (org_live map x); have [f Ef _] := outside_face low O.
have [y [xy ry]] := start_root O Ef; apply: grounded_reached xy _.
by apply: root_grounded ry; apply: t2 O Ef; apply: org_live.
Qed.

(** ** The counts *)

Lemma complete_edges es : lists_one_of_each es (same_edge t) (half_edge t) -> half_edge_count t = (size es).*2.
Proof.
move=> He; rewrite /half_edge_count numberE.
by apply: (edges_half low) He => // [h|x _]; [apply: half_edge_below|apply: dart_live].
Qed.

Lemma roots_ofP h : h \in roots_of t <-> exists f, root_in h f.
Proof.
split=> [/mapP[b]|[f [b [B S [i P] Ef]]]].
  rewrite mem_filter => /andP[/andP[c I] _] ->; move: c; rewrite /cycle_start /start_of.
  case S: (boundary_start t b) => [[g|]|] // _; have lb := heard_live S.
  have [f [p [_ Ef Ep _]]] := placeP low lb; exists f, b; split=> //.
    by case: (boundaryP low lb) => [x|v]; rewrite S // => -[->] <-; apply: (boundaryE map).
  by move: I; rewrite /listed_inner /is_inner; case: (boundary_place t b) => [[|i]|] // _; exists i.
apply/mapP; exists b; last by rewrite /start_of S.
by rewrite mem_filter /cycle_start S /listed_inner P mem_iota add0n /= boundary_below //; apply: heard_live S.
Qed.

Lemma root_outside' (x : dart t) f : root_in (num x) f -> exists2 b, outside_of t (org x) b & boundary_of t (num x) = Some b.
Proof.
by case=> b [B S I _]; exists b => //; apply/(outside_dart low); split=> //; exists x => //; apply: joined_refl.
Qed.

Lemma complete_roots : size (roots_of t) = size (pieces t).
Proof.
apply: (one_of_each_size (same := reached (near t)) (P := half_edge t)) (pieces_each low).
- by move=> g h lg _; apply: (reached_sym (near_live map) (near_sym map) lg).
- by move=> x y z; apply: reached_trans.
have live h : h \in roots_of t -> half_edge t h by case/roots_ofP=> f [b [B _ _ _]]; apply: heard_live B.
split=> //.
- rewrite map_inj_in_uniq ?filter_uniq ?iota_uniq // => b c.
  have start d : d \in [seq b <- iota 0 (boundary_slots t) | ~~ is_nil (cycle_start t b) && listed_inner t b] ->
      boundary_of t (start_of t d) = Some d.
    rewrite mem_filter => /andP[/andP[cy _] _]; move: cy; rewrite /cycle_start /start_of.
    case S: (boundary_start t d) => [[g|]|] // _.
    by case: (boundaryP low (heard_live S)) => [x|v]; rewrite S // => -[->] <-; apply: (boundaryE map).
  by move=> /start Eb /start Ec E; move: Eb; rewrite E Ec => -[].
- move=> g h gs hs; have [x xg] := dartP (live g gs); have [y yh] := dartP (live h hs); rewrite -xg -yh in gs hs *.
  move=> xy; case/roots_ofP: gs => f rx; case/roots_ofP: hs => f' ry.
  have [b Ob Bx] := root_outside' rx; have [c Oc By] := root_outside' ry.
  have [d [_ one]] := t1 (org_live map x).
  have bc : b = c.
    rewrite -(one b Ob); apply: one; case: Oc => I [w W yw]; split=> //; exists w => //.
    by apply: connected_trans yw; apply: (joined_connected map).
  case: rx => b' [B' S _ _]; case: ry => c' [C' S' _ _].
  move: B' C'; rewrite Bx By => -[bb] [cc]; move: S S'; rewrite -bb -cc bc => -> -[] //.
move=> h /dartP[x <-]; have [b [O _]] := t1 (org_live map x); have [f Ef _] := outside_face low O.
have [y [xy ry]] := start_root O Ef; exists (num y); first by apply/roots_ofP; exists f.
exact: (joined_sym map xy).
Qed.

Lemma complete_euler : euler_ok t.
Proof.
have [es He] := edges_each low; have := (t3_sums low He).1 t3.
rewrite /euler_ok rotations_count cycles_count roots_count (complete_edges He) complete_roots => eq.
by apply/eqP; rewrite eq; arith.
Qed.

(** ** The tests *)

Variable rank : nat -> nat.
Hypothesis ranks : forall x : dart t, bottom (num x) \/ exists2 g, down (num x) g & rank g < rank (num x).

Lemma complete_rank (x : dart t) : rank_ok t rank (num x).
Proof.
have root f : root_in (num x) f -> (outer t f = None \/ exists2 g, outer t f >>= cycle_start t = Some g & rank g < rank (num x)) ->
    is_root t rank (num x).
  case=> b [B S [i P] Ef] O; rewrite /is_root B /cycle_start S /listed_inner P Ef /= eqxx /=.
  by case: O => [->|[g E lt]] //; rewrite E /= lt orbT.
rewrite /rank_ok; case: (ranks x) => [[f r E]|[g [ng|[f r E]] lt]].
- by rewrite (root f r) ?orbT //; left.
- move: ng; rewrite (near_dart map) !inE (nextE map) (prevE map) (twinE map) /=.
  by case/or3P=> /eqP E; rewrite -E lt ?orbT.
by rewrite (root f r) ?orbT //; right; exists g.
Qed.

Lemma complete_half_edge (x : dart t) : half_edge_ok t rank (num x).
Proof.
have [z E _] := kept_org low x; have [g S _] := start_bnd low x.
rewrite /half_edge_ok complete_rank /twin_ok /next_ok /target_ok /origin_ok /cycle_ok.
rewrite (originE map) (twinE map) (nextE map) (prevE map) (boundaryE map) /= !(originE map) (twinE map) (prevE map) (nextE map).
rewrite (boundaryE map) (twK map) (nxK map) (pvK map) (org_nx map) (bnd_nx low) E /cycle_start S /= !eqxx.
by rewrite (inj_eq (@num_inj _ _)) (tw_neq map).
Qed.

Lemma complete_vertex v : vertex t v -> vertex_ok t v.
Proof.
move=> lv; rewrite /vertex_ok; case: (vertexP low lv) => [x E xv|b E bv I S].
  have [_ H] := low_b2 low lv; have [|-> _] := H; first by rewrite -xv; apply: not_bare.
  by rewrite E dart_live (originE map) xv /= eqxx.
by rewrite E I (heard_live S) /= /starts_at S /= eqxx.
Qed.

Lemma complete_boundary b : boundary t b -> boundary_ok t b.
Proof.
move=> lb; apply/andP; split; rewrite /start_ok /place_ok.
  case: (boundaryP low lb) => [x S xb|v S lv bv I]; rewrite S; first by rewrite dart_live (boundaryE map) xb /= eqxx.
  have [i P] := vertex_inner low S; rewrite lv I /listed_inner P /= eqxx andbT.
  by case: (vertexP low lv) => [x _ xv|c -> //]; case: (@not_bare _ low x); rewrite xv.
have [f [p [lf Ef Ep L]]] := placeP low lb; rewrite Ef Ep.
by case: p Ep L => [|i] _ /= ->; rewrite lf /= eqxx.
Qed.

Lemma complete_face f : face t f -> face_ok t f.
Proof.
move=> lf; have entry p b : listed t f p = Some b -> entry_ok t f p (Some b).
  move=> L; have [Ef Ep] := listed_names low L; rewrite /entry_ok /= (listed_live low L) Ef Ep /= eqxx.
  by case: p {L Ep} => //= i.
apply/andP; split; first by case E: (outer t f) => [b|] //=; apply: (entry Outer).
apply/all_belowP => i lt; have [_ _ _ /(_ f lf)[_ /(_ i lt)[b E _]]] := low_r1 low; rewrite E.
exact: entry.
Qed.

Lemma complete_unbounded : one_unbounded t.
Proof.
rewrite /one_unbounded /unbounded_count numberE; apply/count1P => [f /andP[/face_below //]|].
have [[f [[lf E] one]] _] := low_f1 low; exists f; split; first by rewrite lf E.
by move=> g /andP[lg /is_nilP Eg]; apply: one.
Qed.

Lemma complete_accepts : accepts t rank.
Proof.
apply/and5P; split; last by rewrite complete_euler complete_unbounded.
- by apply/each_half_edgeP => h /dartP[x <-]; apply: complete_half_edge.
- by apply/each_vertexP; apply: complete_vertex.
- by apply/each_boundaryP; apply: complete_boundary.
by apply/each_faceP; apply: complete_face.
Qed.

End Complete.

(** ** The two theorems

    What is accepted keeps all rules, whatever the ranks are; and where all rules hold, there are ranks that are accepted. *)

Theorem labels_complete t : rules t -> exists rank, accepts t rank.
Proof.
move=> H; have low : lower t by move=> q _; apply: H.
have [|rank ranks] := @ranks_exist (bottom t) (down t) [seq h <- iota 0 (half_edge_slots t) | half_edge t h].
  by move=> h; rewrite mem_filter => /andP[/dartP[x <-] _]; apply: (all_grounded low (H T1) (H T2)).
exists rank; apply: (complete_accepts low (H T1) (H T3)) => x.
by apply: ranks; rewrite mem_filter mem_iota add0n dart_live half_edge_below ?dart_live.
Qed.

Corollary labels_mean_subdivision t : (exists rank, accepts t rank) <-> exists s, represents t s.
Proof.
rewrite -rules_mean_subdivision; split=> [[rank /labels_sound //]|]; exact: labels_complete.
Qed.
