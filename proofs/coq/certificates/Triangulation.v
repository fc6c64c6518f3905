(** * Triangulation: positive triangles inside a negative one, and which of them a point is in

    The hypotheses are all local: of one dart and those next to it. Nothing is said of connectedness, of Euler's formula,
    of the order around vertices, or that vertices are at different points.

<<
      ┌───────────────────┐       each triangle runs counter-clockwise, but for one, the outer one,
      │ ╲       ╱ ╲      ╱        which has all others inside if it is turned around
      │   ╲   ╱     ╲  ╱
      │     ·─────── ·
      └───
>>

    The crossings of the darts with a ray are added up in two ways. A dart and its twin cancel out. Three darts of a triangle
    make 1 if the point is in the triangle, and 0 otherwise. So as many inner triangles are around a point as outer ones. *)

From Coq Require Import ZArith Lia.
From mathcomp Require Import all_ssreflect.
From twinedge Require Import Orientation.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Local Open Scope Z_scope.

Section Triangulation.
Variables (dart : finType) (twin next : dart -> dart) (inner : pred dart).
Implicit Types (d e : dart) (p v : point).

Definition corners_turn (pt : dart -> point) d := orient (pt d) (pt (next d)) (pt (next (next d))).

Record triangulation (pt : dart -> point) : Prop := Triangulation {
  twin_back : involutive twin;
  next_thrice : forall d, next (next (next d)) = d;
  point_next : forall d, pt (next d) = pt (twin d);
  inner_next : forall d, inner (next d) = inner d;
  inner_positive : forall d, inner d -> 0 < corners_turn pt d;
  outer_negative : forall d, ~~ inner d -> corners_turn pt d < 0;
  outer_three : (#|[pred d | ~~ inner d]| <= 3)%N;
  outer_twin : forall d, ~~ inner d -> inner (twin d)
}.

Lemma scaled_triangulation pt n : 0 < n -> triangulation pt -> triangulation (fun d => scaled n (pt d)).
Proof.
move=> pos [tK n3 pn inn ip on ot ow]; split=> // d; first by rewrite pn.
  by move=> /ip; rewrite /corners_turn orient_scaled; nia.
by move=> /on; rewrite /corners_turn orient_scaled; nia.
Qed.

(** ** Sums of integers *)

Canonical Z_add_monoid := Monoid.Law Z.add_assoc Z.add_0_l Z.add_0_r.
Canonical Z_add_comoid := Monoid.ComLaw Z.add_comm.

Notation sum F := (\big[Z.add/0]_(d : dart) F d).

Lemma sum_cardinal (p : pred dart) : \big[Z.add/0]_(d | p d) 1 = Z.of_nat #|p|.
Proof.
rewrite big_const; elim: #|_| => [//|n IH]; rewrite iterS IH Nat2Z.inj_succ; lia.
Qed.

Lemma sum_opposite (F : dart -> Z) : sum (fun d => - F d) = - sum F.
Proof. by apply: (big_rec2 (fun x y => x = - y)) => // d x y _ ->; lia. Qed.

(** ** Around a point *)

Section Around.
Variables (pt : dart -> point).
Hypothesis ok : triangulation pt.
Variable p : point.

Let next_inj : injective next := can_inj (g := fun d => next (next d)) (next_thrice ok).

Definition cross_at d := crossing p (pt d) (pt (next d)).
Definition around_at d := around p (pt d) (pt (next d)) (pt (next (next d))).
Definition covers d := ~~ (around_at d =? 0).

Lemma around_atE d : around_at d = cross_at d + cross_at (next d) + cross_at (next (next d)).
Proof. by rewrite /around_at /around /cross_at (next_thrice ok). Qed.

Lemma covers_next d : covers (next d) = covers d.
Proof. by rewrite /covers /around_at (next_thrice ok) around_turn. Qed.

Lemma sum_next F : sum (fun d => F (next d)) = sum F.
Proof. by rewrite [RHS](reindex_inj next_inj). Qed.

Lemma sum_around : sum around_at = 0.
Proof.
have zero : sum cross_at = 0.
  have E : sum cross_at = - sum cross_at.
    rewrite -sum_opposite {1}(reindex_inj (inv_inj (twin_back ok))) /=; apply: eq_bigr => d _.
    rewrite /cross_at -(point_next ok) (point_next ok (twin d)) (twin_back ok).
    exact: crossing_swap.
  lia.
rewrite (eq_bigr (fun d => cross_at d + cross_at (next d) + cross_at (next (next d)))); last by move=> d _; apply: around_atE.
by rewrite !big_split /= (sum_next (fun d => cross_at (next d))) (sum_next cross_at) zero.
Qed.

(** *** One triangle *)

Lemma inner_around d : inner d -> around_at d = if covers d then 1 else 0.
Proof.
move=> /(inner_positive ok)/(around_once p)[+ _]; rewrite /covers -/(around_at d).
by case=> ->.
Qed.

(** The outer triangle, turned around. *)
Lemma outer_turned d : ~~ inner d -> 0 < orient (pt d) (pt (next (next d))) (pt (next d)).
Proof.
move=> /(outer_negative ok).
by rewrite /corners_turn -(orient_turn (pt d)) (orient_swap (pt (next (next d)))) orient_turn; lia.
Qed.

Lemma outer_around d : ~~ inner d -> around_at d = if covers d then - 1 else 0.
Proof.
move=> /outer_turned pos; rewrite /covers /around_at -(Z.opp_involutive (around _ _ _ _)) -around_swap.
by have [[->|->] _] := around_once p pos.
Qed.

(** A point in an inner triangle is not to the right of its sides, and if it is to the left of all, it is in it. *)
Lemma covers_closed d : inner d -> covers d -> 0 <= orient (pt d) (pt (next d)) p.
Proof.
move=> i c; have [_ [H _]] := around_once p (inner_positive ok i).
by have [] := H _; rewrite // -/(around_at d) inner_around // c.
Qed.

Lemma covers_open d : inner d -> 0 < orient (pt d) (pt (next d)) p -> 0 < orient (pt (next d)) (pt (next (next d))) p ->
  0 < orient (pt (next (next d))) (pt d) p -> covers d.
Proof.
move=> i u v w; have [_ [_ H]] := around_once p (inner_positive ok i).
by rewrite /covers /around_at H.
Qed.

(** The outer triangle is the other way round. *)
Lemma outer_closed d : ~~ inner d -> covers d -> orient (pt d) (pt (next d)) p <= 0.
Proof.
move=> o c; have [_ [H _]] := around_once p (outer_turned o).
have [|_ [_]] := H _; first by rewrite around_swap -/(around_at d) outer_around // c.
by rewrite (orient_swap (pt d)); lia.
Qed.

Lemma outer_open d : ~~ inner d -> orient (pt d) (pt (next d)) p < 0 -> orient (pt (next d)) (pt (next (next d))) p < 0 ->
  orient (pt (next (next d))) (pt d) p < 0 -> covers d.
Proof.
move=> o u v w; have [_ [_ H]] := around_once p (outer_turned o); rewrite /covers /around_at -(Z.opp_involutive (around _ _ _ _)) -around_swap H //.
- by rewrite (orient_swap (pt (next (next d)))); lia.
- by rewrite (orient_swap (pt (next d))); lia.
by rewrite (orient_swap (pt d)); lia.
Qed.

(** *** As many inner darts as outer ones have the point in their triangle *)

Lemma covered_as_often : #|[pred d | inner d && covers d]| = #|[pred d | ~~ inner d && covers d]|.
Proof.
apply: Nat2Z.inj; rewrite -!sum_cardinal; have := sum_around; rewrite (bigID inner) /=.
have -> : \big[Z.add/0]_(d | inner d) around_at d = \big[Z.add/0]_(d | inner d && covers d) 1.
  by rewrite [RHS]big_mkcondr; apply: eq_bigr => d /inner_around.
have -> : \big[Z.add/0]_(d | ~~ inner d) around_at d = - \big[Z.add/0]_(d | ~~ inner d && covers d) 1.
  rewrite [in RHS]big_mkcondr; apply: (big_rec2 (fun x y => x = - y)) => // d x y /outer_around -> ->.
  by case: (covers d); rewrite -[Z_add_monoid _ y]/(_ + y); lia.
lia.
Qed.

Lemma next_differs d : (0 <> corners_turn pt d) -> next d != d /\ next (next d) != d.
Proof.
move=> turn; split; apply/eqP=> E; case: turn; rewrite /corners_turn ?E /orient /cross /sub; cbn [fst snd].
  by ring.
by ring.
Qed.

Lemma inner_differs d : inner d -> [&& next d != d, next (next d) != d & next (next d) != next d].
Proof.
move=> i; have [|-> ->] := @next_differs d; first by have := inner_positive ok i; lia.
by have [] := @next_differs (next d); rewrite ?next_thrice //; have := inner_positive ok (etrans (inner_next ok d) i); lia.
Qed.

(** No point is in two triangles. *)
Lemma covered_once d e : inner d -> inner e -> covers d -> covers e -> e \in [:: d; next d; next (next d)].
Proof.
move=> id ie cd ce; case: (boolP (e \in _)) => // out.
have /and3P[n1 n2 n3] := inner_differs id.
have u : uniq [:: e; d; next d; next (next d)].
  by rewrite cons_uniq out /= !inE negb_or (eq_sym d) n1 (eq_sym d) n2 (eq_sym (next d)) n3.
have : (4 <= #|[pred d | inner d && covers d]|)%N.
  rewrite -[4%N](card_uniqP u); apply: subset_leq_card; apply/subsetP => x.
  by rewrite !inE => /or4P[] /eqP->; rewrite ?(inner_next ok) ?covers_next ?id ?ie ?cd ?ce.
rewrite covered_as_often => four; have := leq_trans four (subset_leq_card _) => /(_ [pred d | ~~ inner d]) H.
have /(leq_trans (H _)) : (#|[pred d | ~~ inner d]| <= 3)%N by exact: outer_three ok.
by apply; apply/subsetP => x; rewrite !inE => /andP[].
Qed.

(** A point that an inner triangle covers is covered by an outer one, and so all do; and the other way round. *)
Lemma covered_outside d : inner d -> covers d -> exists2 o, ~~ inner o & covers o.
Proof.
move=> i c; have : (0 < #|[pred d | ~~ inner d && covers d]|)%N.
  by rewrite -covered_as_often; apply/card_gt0P; exists d; rewrite inE i.
by case/card_gt0P=> o; rewrite inE => /andP[]; exists o.
Qed.

Lemma covered_inside o : ~~ inner o -> covers o -> exists2 d, inner d & covers d.
Proof.
move=> i c; have : (0 < #|[pred d | inner d && covers d]|)%N.
  by rewrite covered_as_often; apply/card_gt0P; exists o; rewrite inE i.
by case/card_gt0P=> d; rewrite inE => /andP[]; exists d.
Qed.

(** There is one outer triangle. *)
Lemma outer_one o o' : ~~ inner o -> ~~ inner o' -> o' \in [:: o; next o; next (next o)].
Proof.
move=> io io'; case: (boolP (o' \in _)) => // out.
have neg d : ~~ inner d -> corners_turn pt d < 0 by apply: (outer_negative ok).
have [n1 n2] : next o != o /\ next (next o) != o by apply: next_differs; have := neg o io; lia.
have n3 : next (next o) != next o.
  by have [] := @next_differs (next o) _; rewrite // => E; have := neg (next o); rewrite (inner_next ok) io -E => /(_ isT).
have u : uniq [:: o'; o; next o; next (next o)].
  by rewrite cons_uniq out /= !inE negb_or (eq_sym o) n1 (eq_sym o) n2 (eq_sym (next o)) n3.
have : (4 <= #|[pred d | ~~ inner d]|)%N.
  rewrite -[4%N](card_uniqP u); apply: subset_leq_card; apply/subsetP => x.
  by rewrite !inE => /or4P[] /eqP->; rewrite ?(inner_next ok).
by move=> four; have := leq_trans four (outer_three ok).
Qed.

(** So a point in an inner triangle is not to the right of the outer triangle's sides, seen from inside. *)
Lemma covered_within d o : inner d -> covers d -> ~~ inner o -> orient (pt o) (pt (next o)) p <= 0.
Proof.
move=> id cd io; have [o' io' co'] := covered_outside id cd; apply: outer_closed => //.
by have := outer_one io' io; rewrite !inE => /or3P[] /eqP->; rewrite ?covers_next.
Qed.

End Around.
End Triangulation.
