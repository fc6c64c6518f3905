(** * NearSum: what the sum V − E + F = 1 + I says of T1 and T3 (near/check.rs)

    I is the number of inner boundary components. Where R1 to F2 hold, the sum is right if and only if there are as many of these as
    components, less the handles. So it proves T1 and T3 if each component has one at least; and it lets pass what has two in one
    component and none in another, or a handle and one too few.

<<
      V + F + 2 g + I = 1 + E + 2 C        V + F = 1 + I + E   exactly if   I + g = C
>>
*)

From mathcomp Require Import all_ssreflect all_fingroup.
From twinedge Require Import Arith View Rules Loops LoopsProof Reference Map Counting Lists TopologyProof.
From twinedge Require Import Drawing Euler Numbered Genus WholeEuler.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section Sum.
Variable t : view.
Hypothesis low : lower t.

Let map := low_map low.
Let rot := low_v2 low.

Variables (vs es fs cs bs : seq nat).
Hypotheses (Hv : lists vs (vertex t)) (He : lists_one_of_each es (same_edge t) (half_edge t)) (Hf : lists fs (face t)).
Hypotheses (Hc : lists_one_of_each cs (connected t) (vertex t)) (Hb : lists bs (is_inner t)).

(** The sum of near: with [g = 0] exactly if T3 holds. *)
Theorem sum_says : exists g, (g = 0 <-> t3_euler t) /\ (size vs + size fs = 1 + size bs + size es <-> size bs + g = size cs).
Proof.
have [edges every] := every_edge_exists (twK map) (tw_neq map).
exists (handles (turns low) (@tw t) edges); split; first by rewrite (t3_plane low every) drawnP.
have := whole_euler low every (rotations_each low) (cycles_each low) He (pieces_each low).
have := vertices_size Hv; have := faces_size low Hf; have := boundaries_sides low; have := components_size low Hc.
have : size (boundaries t) = size (outer_ones t) + size (inner_ones t) by exact: size_split.
have : size (rotations t) = size (with_edges t) by exact: size_map.
have -> : size (inner_ones t) = size bs.
  have Hi : lists (inner_ones t) (is_inner t) by split=> [|b]; [rewrite !filter_uniq ?iota_uniq | apply: inner_onesP].
  exact: lists_size Hi Hb.
by split; arith.
Qed.

(** The component of an inner boundary component. *)
Lemma outside_one v w b : outside_of t v b -> outside_of t w b -> connected t v w.
Proof.
move=> [_ [x X vx]] [_ [y]]; rewrite X => -[<-] wx; apply: connected_trans vx _; exact: (connected_sym map).
Qed.

(** If each component has an inner boundary component, the sum is right if and only if T1 and T3 hold. *)
Theorem sum_enough : (forall v, vertex t v -> exists b, outside_of t v b) ->
  size vs + size fs = 1 + size bs + size es <-> t1_outside t /\ t3_euler t.
Proof.
move=> some; have [ub memb] := Hb; have [uc live one all] := Hc; have [g [g0 sum]] := sum_says; rewrite sum; split=> [eq|[T1 /g0->]].
  have fits bs' : (forall v, v \in cs -> exists2 b, b \in bs' & outside_of t v b) -> size cs <= size bs'.
    move=> has_one; apply: (@rel_size_le _ _ (outside_of t) uc has_one) => v w b vc wc vb wb.
    by apply: one => //; apply: outside_one vb wb.
  have le : size cs <= size bs.
    by apply: fits => v vc; have [b o] := some v (live v vc); exists b => //; apply/memb; case: o.
  split; last by apply/g0; move: eq le; arith.
  move=> v lv; have [b o] := some v lv; exists b; split=> // c oc; apply/eqP/negPn/negP=> bc.
  have bb : b \in bs by apply/memb; case: o.
  have : size cs <= size (rem c bs).
    apply: fits => w wc; have [v0 v0c v0v] := all v lv.
    have keep d : outside_of t w d -> d != c -> exists2 d', d' \in rem c bs & outside_of t w d'.
      by move=> od dc; exists d => //; rewrite mem_rem_uniq // inE /= dc; apply/memb; case: od.
    have [d od] := some w (live w wc); case: (d =P c) => [dc|/eqP dc]; last exact: keep dc.
    rewrite dc in od; apply: (keep b) => //; case: o => I [x X vx]; split=> //; exists x => //.
    by apply: connected_trans vx; apply: outside_one od oc.
  have cc : c \in bs by apply/memb; case: oc.
  by rewrite size_rem //; move: eq le; case: (bs) cc => //= *; arith.
by rewrite addn0; apply/esym; rewrite (components_inner low T1 Hc); apply: (lists_size _ Hb);
  split=> [|b]; [rewrite !filter_uniq ?iota_uniq | apply: inner_onesP].
Qed.

End Sum.
