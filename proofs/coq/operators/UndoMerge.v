(** * UndoMerge: an edge between two faces that was removed can be put back

    Removing an edge with different boundary components on both sides (RemoveMerge.v) is undone by connecting the corners where it was
    (ConnectSplit.v), or by a loop where it left an isolated vertex (ConnectLoop.v): the table after has the same core as the one
    before. *)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import View Rules Map Lists NewEdge ConnectCorners Stretch Core Tidy NewFace ConnectSplit ConnectLoop.
From twinedge Require Import RemoveEdge RemoveMerge Same.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section UndoMerge.
Variables (t : view) (n m f g bn bm bf bg un um : nat).
Hypothesis keeps : rules t.
Hypothesis twin_n : twin t n = Some m.
Hypothesis boundary_n : boundary_of t n = Some bn.
Hypothesis boundary_m : boundary_of t m = Some bm.
Hypothesis differ : bn <> bm.
Hypothesis faces : bf = bn /\ bg = bm \/ bf = bm /\ bg = bn.
Hypothesis face_f : boundary_face t bf = Some f.
Hypothesis face_g : boundary_face t bg = Some g.
Hypothesis outer_g : ~~ inn_of t bg.
Hypothesis origin_n : origin t n = Some un.
Hypothesis origin_m : origin t m = Some um.

Notation t1 := (merge_faces t n m f g bn bm).
Notation inn := (inn_of t).
(** The inner boundary components that go back to the face [g]. *)
Definition moved_back : pred nat := fun d => boundary_face t d == Some g.

Let sides : bn = bn /\ bm = bm \/ bn = bm /\ bm = bn := or_introl (conj erefl erefl).
Let out : taken_out t t1 n m bn bn. Proof. by case: (merged_out t n m f g bn bm). Qed.
Let c : core t inn := core_of_rules keeps.
Let links_of := NewEdge.links_of keeps.
Let live_n : half_edge t n := heard_live twin_n.
Let live_m : half_edge t m := heard_live (twin_of keeps twin_n).

Lemma merged_keeps : rules t1.
Proof.
apply: merge_faces_keeps_rules => //; rewrite /is_seam twin_n boundary_n boundary_m !eqxx /= (introF eqP differ) /=.
by case: faces outer_g face_f face_g => -[-> ->] -> -> ->; rewrite !eqxx ?orbT.
Qed.
Let keeps1 := merged_keeps.

Lemma live_f_g : boundary t bf /\ boundary t bg. Proof. by split; [apply: heard_live face_f|apply: heard_live face_g]. Qed.
Lemma live_both : boundary t bn /\ boundary t bm. Proof. by have [] := live_f_g; case: faces => -[-> ->]. Qed.

Lemma merged_boundary d : boundary t1 d = (d != bm) && boundary t d. Proof. by rewrite {1}/boundary /= andbCA. Qed.
Lemma merged_face x : face t1 x = (x != g) && face t x. Proof. by rewrite {1}/face /= andbCA. Qed.
Lemma free_slots : [/\ ~~ half_edge t1 n, ~~ half_edge t1 m, n != m, ~~ boundary t1 bm & ~~ face t1 g].
Proof.
by rewrite !(half_edgeE out) merged_boundary merged_face !eqxx andbF; split=> //; apply/eqP/(n_not_m keeps twin_n).
Qed.

Lemma merged_half_edges i : [|| i == n, i == m | half_edge t1 i] = half_edge t i.
Proof.
rewrite (half_edgeE out); case: (i =P n) => [->|_]; first by rewrite live_n.
by case: (i =P m) => [->|_]; rewrite ?live_m.
Qed.

Lemma kept_face : boundary_face t1 bn = Some f.
Proof. by rewrite /boundary_face /heard merged_boundary (introF eqP differ) /=; have [-> _] := live_both; rewrite eqxx. Qed.

Lemma merged_boundary_face d : boundary t d -> d <> bn -> d <> bm ->
  boundary_face t1 d = if boundary_face t d == Some g then Some f else boundary_face t d.
Proof.
move=> ld dn dm; rewrite {1}/boundary_face /heard merged_boundary (introF eqP dm) ld /= (introF eqP dn) /=; case: eqP => // _.
by rewrite /boundary_face /heard ld.
Qed.

Lemma inn_merged d : boundary t1 d -> inn_of t1 d = merged_inn t bn bm d.
Proof. exact: relist_inn. Qed.

Lemma bg_is d : boundary t d -> boundary_face t d = Some g -> ~~ inn d -> d = bg.
Proof. by move=> ld F I; apply: (outer_in_g keeps face_g outer_g F I). Qed.

(** Faces and boundary components are as they were, however the edge is put back. *)
Section Faces.
Variable cut : view.
Let t2 := new_face t1 cut f g bn bm bf bg moved_back.
Let left_right : bn = bn /\ bm = bm \/ bn = bm /\ bm = bn := or_introl (conj erefl erefl).

Lemma back_boundary : boundary t2 =1 boundary t.
Proof.
move=> d; rewrite /t2 NewFace.boundaryE merged_boundary; case: (d =P bm) => [->|//]; by have [_ ->] := live_both.
Qed.

Lemma back_face : face t2 =1 face t.
Proof.
move=> x; rewrite /t2 NewFace.faceE merged_face.
by case: (x =P g) => [->|//]; have [y + ly] := core_face c (proj2 live_f_g); rewrite face_g => -[->].
Qed.

Lemma other_joint d : d <> bn -> d <> bm -> ~ joint bn bm d. Proof. by move=> dn dm []. Qed.

Lemma bounds_f : bounds t1 f bn = ~~ inn bf.
Proof.
have l1 : boundary t1 bn by rewrite merged_boundary (introF eqP differ); have [-> _] := live_both.
have E : inn_of t1 bn = inn bf by rewrite (inn_merged l1) (inn_joint faces outer_g).
apply/eqP/idP => [/(inn_outer keeps1)[_]|I]; first by rewrite E.
by apply/(inn_outer keeps1); rewrite E kept_face.
Qed.

Lemma back_other d : boundary t d -> d <> bn -> d <> bm -> boundary_face t2 d = boundary_face t d /\ inn_of t2 d = inn d.
Proof.
move=> ld dn dm; have [_ _ _ free_b free_g] := free_slots; have ld2 : boundary t2 d by rewrite back_boundary.
have ld1 : boundary t1 d by rewrite merged_boundary (introF eqP dm).
have [df dg] : d == bf = false /\ d == bg = false by split; apply/eqP; case: faces => -[E E']; rewrite ?E ?E'.
have I1 : inn_of t1 d = inn d by rewrite (inn_merged ld1) (inn_other _ (other_joint dn dm)).
have newE : (d \in new_list t1 f bn moved_back) = (boundary_face t d == Some g).
  apply/idP/idP => [/(newsP f bn moved_back keeps1 free_b)[_ //]|F].
  apply/(newsP f bn moved_back keeps1 free_b); split=> //; last by rewrite (merged_boundary_face ld dn dm) F.
  apply/(inn_inner keeps1 ld1); rewrite I1; apply/negPn/negP=> I; have := bg_is ld (eqP F) I.
  by move/eqP; rewrite dg.
split.
  rewrite (NewFace.boundary_faceE left_right faces ld2) df dg newE (merged_boundary_face ld dn dm).
  by case: eqP => [->|].
rewrite {1}/inn_of (NewFace.placeE keeps1 free_b left_right faces ld2) df dg /=.
case: ifP => [/(oldsP f bn bf moved_back keeps1 free_b)[[_ _ I _]|[_ /eqP]]|_]; last 1 first.
- rewrite newE; case: eqP => F; last by rewrite -I1.
  by apply/esym/negPn/negP=> I; have /eqP := bg_is ld F I; rewrite dg.
- by rewrite -I1; apply/esym/(inn_inner keeps1 ld1).
by rewrite df.
Qed.

Lemma back_boundary_face d : boundary t d -> boundary_face t2 d = boundary_face t d /\ inn_of t2 d = inn d.
Proof.
move=> ld; have [_ _ _ free_b free_g] := free_slots; have ld2 : boundary t2 d by rewrite back_boundary.
have fg : bf <> bg by case: faces => -[-> ->] // /esym.
have [->|->|[dn dm]] : [\/ d = bg, d = bf | d <> bn /\ d <> bm].
  case: (d =P bg) => [|dg]; first by constructor 1.
  by case: (d =P bf) => [|df]; [constructor 2|constructor 3; case: faces df dg => -[-> ->]].
- have lg : boundary t2 bg by rewrite back_boundary; case: live_f_g.
  rewrite (NewFace.boundary_faceE left_right faces lg) eqxx face_g; split=> //.
  by rewrite {1}/inn_of (NewFace.placeE keeps1 free_b left_right faces lg) eqxx (negPf outer_g).
- have lf : boundary t2 bf by rewrite back_boundary; case: live_f_g.
  rewrite (NewFace.boundary_faceE left_right faces lf) (introF eqP fg) eqxx face_f; split=> //.
  rewrite {1}/inn_of (NewFace.placeE keeps1 free_b left_right faces lf) (introF eqP fg) eqxx bounds_f /=.
  case I: (inn bf) => //=; have -> // : bf \in old_list t1 f bn bf moved_back.
  by apply/(oldsP f bn bf moved_back keeps1 free_b); right; rewrite bounds_f I.
exact: back_other.
Qed.

End Faces.

Lemma of_faces : (if bg == bn then bm else bn) = bf /\ (if bg == bn then bn else bm) = bg.
Proof. by case: faces => -[-> ->]; rewrite ?eqxx // eq_sym (introF eqP differ). Qed.

Let next_some := RemoveEdge.next_some keeps.
Let left i : half_edge t i -> i <> n -> i <> m -> half_edge t1 i.
Proof. by move=> li /eqP i_n /eqP im; rewrite (half_edgeE out) i_n im. Qed.

(** A half-edge that is left, of another cycle or of one of the two. *)
Lemma merged_side i : half_edge t1 i -> boundary_of t1 i = if boundary_of t i == Some bm then Some bn else boundary_of t i.
Proof.
move=> l; rewrite (RemoveMerge.boundary_ofE (l : half_edge (merged t n m f g bn bm) i) : boundary_of t1 i = _); have [li _ _] := leftP out l.
have [_ _ _ _ [d D _]] := links_of li; rewrite D /= /now.
by have -> : (Some d == Some bm) = (d == bm) by []; case: eqP.
Qed.

(** ** A loop that was alone on both cycles *)

Lemma undo_merge_alone : next t n = Some n -> next t m = Some m ->
  isolated t1 un = Some bn /\ same_core (loop_at_isolated t1 un n m f g bn bm false (bg == bn) moved_back) t.
Proof.
move=> N M; have K : corner t n m n = None by rewrite /corner past_n M eqxx N eqxx.
have I : isolated t1 un = Some bn := isolated_un f g bn bm keeps twin_n origin_n K.
split=> //; rewrite /loop_at_isolated /=; have [-> ->] := of_faces; set cut := loop_cycles _ _ _ _ _ _.
pose t2 := new_face t1 cut f g bn bm bf bg moved_back; have uu : un = um := loop_ends keeps twin_n origin_n origin_m N.
have hE i : half_edge t2 i = half_edge t i by rewrite ConnectLoop.half_edgeE merged_half_edges.
split; try by [move=> u; apply/esym/(vertexE out)|move=> i; rewrite -/t2 hE|move=> x; apply/esym/back_face|move=> d; apply/esym/back_boundary].
- move=> i; rewrite -/t2 hE ConnectLoop.originE => li.
  case: (i =P n) => [-> //|i_n]; case: (i =P m) => [->|im]; first by rewrite origin_m uu.
  by rewrite (originE out (left li i_n im)).
- move=> i; rewrite -/t2 hE ConnectLoop.twinE => li; case: (i =P n) => [-> //|i_n]; case: (i =P m) => [->|im].
    exact: (twin_of keeps twin_n).
  by rewrite (twinE out (left li i_n im)).
- move=> i; rewrite -/t2 hE ConnectLoop.nextE => li; case: (i =P n) => [-> //|i_n]; case: (i =P m) => [-> //|im].
  have [x X _] := next_some li; rewrite (nextE out (left li i_n im)) X /= /past.
  case: eqP => [xn|_]; first by case: i_n; apply: (one_next keeps X); rewrite xn.
  by case: eqP => // xm; case: im; apply: (one_next keeps X); rewrite xm.
- move=> i; rewrite -/t2 hE ConnectLoop.boundary_ofE => li; case: (i =P n) => [-> //|i_n]; case: (i =P m) => [-> //|im].
  rewrite (merged_side (left li i_n im)); case: eqP => // B; case: im.
  apply: (orbit_ind (P := fun u => u = m)) (cycle_of keeps boundary_m B) => // u w ->; by rewrite M => -[].
- move=> u; rewrite -/t2 ConnectLoop.isolatedE => lu; case: (u =P un) => [->|uun].
    by case J: (isolated t un) => [d|] //; have [/(_ n live_n)] := core_isolated c J; rewrite origin_n.
  case J: (isolated t u) => [d|]; first by rewrite (isolated_still keeps twin_n out J).
  case J': (isolated t1 u) => [d|] //.
  by have [[J2 _]|[/uun //]] := RemoveMerge.isolated_end keeps twin_n boundary_n boundary_m sides differ origin_n origin_m (J' : isolated (merged t n m f g bn bm) u = Some d); rewrite J in J2.
- by move=> d; rewrite -/t2 back_boundary => /(back_boundary_face cut)[->].
by move=> d; rewrite -/t2 back_boundary => /(back_boundary_face cut)[_ ->].
Qed.

(** ** Otherwise one of the half-edges, say [n], has others on its cycle *)

Hypothesis next_n_n : next t n <> Some n.

Definition before_n := odflt 0 (prev t n).
Definition before_m := if next t m == Some m then before_n else odflt 0 (prev t m).
Notation a := before_n.
Notation b := before_m.

Let prev_is i : half_edge t i -> next t (odflt 0 (prev t i)) = Some i.
Proof. by move=> li; have [_ +] := keeps L2 i li; case: (prev t i). Qed.
Let next_a : next t a = Some n. Proof. exact: prev_is live_n. Qed.
Let next_b : next t m <> Some m -> next t b = Some m. Proof. by rewrite /before_m => /eqP/negPf->; apply: prev_is live_m. Qed.
Let b_is_a : next t m = Some m -> b = a. Proof. by rewrite /before_m => ->; rewrite eqxx. Qed.
Let at_a : boundary_of t a = Some bn. Proof. by rewrite -boundary_n (next_boundary keeps next_a). Qed.
Let at_b : next t m <> Some m -> boundary_of t b = Some bm.
Proof. by move=> M; rewrite -boundary_m (next_boundary keeps (next_b M)). Qed.

Lemma before_differ : next t m <> Some m -> a <> b.
Proof. by move=> M E; have := at_b M; rewrite -E at_a => -[/differ]. Qed.

Lemma left_before_n : half_edge t1 a.
Proof.
apply: left (heard_live next_a) _ _ => E; first by apply: next_n_n; rewrite -{1}E.
by have := at_a; rewrite E boundary_m => -[/esym/differ].
Qed.

Lemma left_before_m : half_edge t1 b.
Proof.
case: (next t m =P Some m) => M; first by rewrite (b_is_a M) left_before_n.
apply: left (heard_live (next_b M)) _ _ => E; last by case: (M); rewrite -{1}E (next_b M).
by have := at_b M; rewrite E boundary_n => -[/differ].
Qed.

(** Both corners are on the cycle that is left. *)
Lemma corners_kept : boundary_of t1 a = Some bn /\ boundary_of t1 b = Some bn.
Proof.
split; rewrite merged_side ?left_before_n ?left_before_m //; first by rewrite at_a; case: eqP.
by case: (next t m =P Some m) => M; rewrite ?(b_is_a M) ?at_a ?(at_b M) ?eqxx //; case: eqP.
Qed.

Lemma next_before_n : next t1 a = if next t m == Some m then next t n else next t m.
Proof. by rewrite (nextE out left_before_n) next_a /= past_n. Qed.
Lemma next_before_m : next t1 b = next t n.
Proof.
case: (next t m =P Some m) => M; first by rewrite (b_is_a M) next_before_n M eqxx.
by rewrite (nextE out left_before_m) (next_b M) /= (past_m keeps twin_n) (introF eqP next_n_n).
Qed.

(** The half-edges to the left of the edge are those that were on the cycle of [n]. *)
Lemma undo_side i : half_edge t1 i -> (i \in left_side t1 a b) = (boundary_of t i == Some bn).
Proof.
move=> l; have [Ba Bb] := corners_kept; have [y Y ly] := next_some live_n; have Yb : next t1 b = Some y by rewrite next_before_m.
have By : boundary_of t1 y = Some bn by rewrite (next_boundary keeps1 Yb).
have total j : half_edge t1 j -> exists2 x, next t1 j = Some x & half_edge t1 x by exact: (RemoveEdge.next_some keeps1).
have below := @half_edge_below t1; have C := cycle_of keeps1 By Ba; have live_y := heard_live By.
rewrite /left_side Yb; have [y_in a_in] := stretch_ends below total live_y C.
(* From a half-edge of the cycle of n but the last one, all is as it was. *)
have next1 j x : half_edge t1 j -> boundary_of t j = Some bn -> j <> a -> next t j = Some x -> next t1 j = Some x /\ boundary_of t x = Some bn.
  move=> lj Bj ja X; rewrite (nextE out lj) X /= (next_boundary keeps X) Bj /past.
  case: eqP => [xn|_]; first by case: ja; apply: (one_next keeps X); rewrite xn.
  by case: eqP => // xm; have := next_boundary keeps X; rewrite xm boundary_m Bj => -[/esym/differ].
apply/idP/eqP=> [|B].
  suff H j : j \in stretch (next t1) (half_edge_slots t1) y a -> half_edge t1 j /\ boundary_of t j = Some bn by move=> /H[].
  move: j; apply: (stretch_ind below total live_y C) => [|j x _ ja [lj Bj] N]; first by rewrite (next_boundary keeps Y).
  have [Lj _ _] := leftP out lj; have [z Z _] := next_some Lj; have [N1 Bz] := next1 j z lj Bj ja Z.
  by have [w W lw] := total j lj; move: W lw N; rewrite N1 => -[<-] lw [<-].
have [li i_n im] := leftP out l; have Cy : on_cycle t y i by apply: (cycle_of keeps (c := bn)); rewrite ?B ?(next_boundary keeps Y).
suff [[]//|//] : i \in stretch (next t1) (half_edge_slots t1) y a /\ boundary_of t i = Some bn \/ i = n.
apply: (orbit_ind (P := fun u => u \in stretch (next t1) (half_edge_slots t1) y a /\ boundary_of t u = Some bn \/ u = n)) Cy => [|u w].
  by left; rewrite y_in (next_boundary keeps Y).
case=> [[F Bu]|->] N; last by left; move: N; rewrite Y => -[<-]; rewrite y_in (next_boundary keeps Y).
case: (u =P a) => [ua|ua]; first by right; move: N; rewrite ua next_a => -[].
have lu : half_edge t1 u := orbit_live keeps1 live_y (stretch_on below total live_y C F).
by have [N1 Bw] := next1 u w lu Bu ua N; left; split=> //; apply: (stretch_step below total live_y C) F ua N1.
Qed.

Lemma undo_merge : same_core (split_face t1 a b n m f g bn bm false (bg == bn) moved_back) t.
Proof.
have [Ba Bb] := corners_kept; rewrite /split_face /=; have [-> ->] := of_faces; set cut := split_cycle _ _ _ _ _ _ _ _.
pose t2 := new_face t1 cut f g bn bm bf bg moved_back.
have new : attached t1 t2 a b n m := split_attached n m f g bm bn bm bf bg moved_back keeps1 Ba Bb.
have hE i : half_edge t2 i = half_edge t i by rewrite (ConnectCorners.half_edgeE new) merged_half_edges.
have target1 i : half_edge t1 i -> target t1 i = target t i.
  move=> l; rewrite /target (twinE out l); case T: (twin t i) => [x|] //=.
  by rewrite (originE out) // (twin_left keeps twin_n out l T).
have loop : next t m = Some m -> un = um.
  by move=> M; apply/esym/(loop_ends keeps (twin_of keeps twin_n) origin_m origin_n M).
split; try by [move=> u; apply/esym/(vertexE out)|move=> i; rewrite -/t2 hE|move=> x; apply/esym/back_face|move=> d; apply/esym/back_boundary].
- move=> i; rewrite -/t2 hE (ConnectCorners.originE new) => li; case: (i =P n) => [->|i_n].
    by rewrite (target1 _ left_before_n) (origin_next keeps next_a).
  case: (i =P m) => [->|im]; last by rewrite (originE out (left li i_n im)).
  rewrite (target1 _ left_before_m); case: (next t m =P Some m) => M; last by rewrite (origin_next keeps (next_b M)).
  by rewrite (b_is_a M) -(origin_next keeps next_a) origin_n origin_m loop.
- move=> i; rewrite -/t2 hE (ConnectCorners.twinE new) => li; case: (i =P n) => [-> //|i_n]; case: (i =P m) => [->|im].
    exact: (twin_of keeps twin_n).
  by rewrite (twinE out (left li i_n im)).
- move=> i; rewrite -/t2 hE (ConnectCorners.nextE new) next_before_n next_before_m => li; case: (i =P n) => [-> //|i_n].
  case: (i =P m) => [->|im].
    by case: (next t m =P Some m) => M; [rewrite (b_is_a M) eqxx|rewrite (introF eqP (before_differ M))].
  case: (i =P a) => [-> //|ia]; case: (i =P b) => [ib|ib].
    by rewrite ib next_b // => M; apply: ia; rewrite ib b_is_a.
  have [x X _] := next_some li; rewrite (nextE out (left li i_n im)) X /= /past.
  case: eqP => [xn|_]; first by case: ia; apply: (one_next keeps X); rewrite xn.
  case: eqP => // xm; case: (next t m =P Some m) => M; first by case: im; apply: (one_next keeps X); rewrite xm.
  by case: ib; apply: (one_next keeps X); rewrite xm next_b.
- have nbE : exists2 x, next t n = Some x & next t1 b = Some x.
    by have [x X _] := next_some live_n; exists x; rewrite ?next_before_m.
  have [x _ Xb] := nbE; move=> i; rewrite -/t2 hE (ConnectSplit.boundary_ofE n m f g bm bn bm bf bg moved_back keeps1 Ba Bb Xb) => li.
  case: (i =P n) => [-> //|i_n]; case: (i =P m) => [->|im] /=.
    rewrite boundary_m; case: ifP => // ms; have [_ _ _ _ [_ /(_ m ms) B]] := side_facts keeps1 Ba Bb Xb.
    by have [_ + _ _ _] := free_slots; rewrite (heard_live B).
  have l := left li i_n im; rewrite (undo_side l) (merged_side l); case: eqP => [-> //|Bn].
  by case: (boundary_of t i =P Some bm) => [-> //|Bm]; rewrite ?eqxx // (introF eqP Bn).
- move=> u; rewrite -/t2 => lu; have -> : isolated t2 u = isolated t1 u by [].
  case J: (isolated t u) => [d|]; first by rewrite (isolated_still keeps twin_n out J).
  case J': (isolated t1 u) => [d|] //.
  have [[J2 _]|[_ _ _ [/next_n_n]]] // := RemoveMerge.isolated_end keeps twin_n boundary_n boundary_m sides differ origin_n origin_m (J' : isolated (merged t n m f g bn bm) u = Some d).
  by rewrite J in J2.
- by move=> d; rewrite -/t2 back_boundary => /(back_boundary_face cut)[->].
by move=> d; rewrite -/t2 back_boundary => /(back_boundary_face cut)[_ ->].
Qed.

End UndoMerge.
