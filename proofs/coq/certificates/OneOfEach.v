(** * OneOfEach: lists with one of each, by their length *)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import View Rules Counting WholeEuler.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section OneOfEach.
Variables (same : nat -> nat -> Prop) (P : nat -> Prop) (s' : seq nat).
Hypothesis sym : forall x y, P x -> P y -> same x y -> same y x.
Hypothesis trans : forall x y z, same x y -> same y z -> same x z.
Hypothesis each : lists_one_of_each s' same P.

Lemma one_of_each_refl x : P x -> same x x.
Proof.
have [_ sP _ all] := each => Px; have [z zs zx] := all x Px.
by apply: (trans _ zx); apply: sym zx => //; apply: sP.
Qed.

Lemma different_le s : uniq s -> (forall x, x \in s -> P x) ->
  (forall x y, x \in s -> y \in s -> same x y -> x = y) -> size s <= size s'.
Proof.
have [_ sP' _ all] := each => u sP one.
apply: (@rel_size_le s s' (fun x y => y \in s' /\ same y x)) => // [x xs|x y z xs ys [zs zx] [_ zy]].
  by have [y ys yx] := all x (sP x xs); exists y.
by apply: one => //; apply: (trans _ zy); apply: sym zx; [apply: sP'|apply: sP].
Qed.

(** As many different ones as there are: they are one of each. *)
Lemma different_all s : (forall x y, P x -> P y -> same x y \/ ~ same x y) -> uniq s -> (forall x, x \in s -> P x) ->
  (forall x y, x \in s -> y \in s -> same x y -> x = y) -> size s' <= size s -> lists_one_of_each s same P.
Proof.
move=> dec u sP one ge; split=> // x Px.
have [//|none] : (exists2 y, y \in s & same y x) \/ (forall y, y \in s -> ~ same y x).
  elim: (s) sP => [|y r IH] sP; first by right.
  have [|[z zr zx]|none] := IH; first by move=> z zr; apply: sP; rewrite inE zr orbT.
    by left; exists z => //; rewrite inE zr orbT.
  have [yx|yx] := dec y x (sP y (mem_head _ _)) Px; first by left; exists y; rewrite ?mem_head.
  by right=> z; rewrite inE => /orP[/eqP->|/none].
suff : size (x :: s) <= size s' by rewrite /= => lt; have := leq_ltn_trans ge lt; rewrite ltnn.
apply: different_le => /=.
- by rewrite u andbT; apply/negP=> /none; apply; apply: one_of_each_refl.
- by move=> y; rewrite inE => /orP[/eqP->|/sP].
move=> y z; rewrite !inE => /orP[/eqP->|ys] /orP[/eqP->|zs] // yz; last exact: one.
  by case: (none z zs); apply: sym yz => //; apply: sP.
by case: (none y ys).
Qed.

(** Some of which each is one of are no fewer than there are. *)
Lemma cover_le s : (forall x, x \in s -> P x) -> (forall x, P x -> exists2 y, y \in s & same y x) -> size s' <= size s.
Proof.
have [u sP' one _] := each => sP cover.
apply: (@rel_size_le s' s (fun x y => y \in s /\ same y x)) => // [x xs|x y z xs ys [zs zx] [_ zy]].
  by have [y ys yx] := cover x (sP' x xs); exists y.
by apply: one => //; apply: (trans _ zy); apply: sym zx; [apply: sP|apply: sP'].
Qed.

(** As few as there are: they are different. *)
Lemma cover_all s : uniq s -> (forall x, x \in s -> P x) -> (forall x, P x -> exists2 y, y \in s & same y x) ->
  size s <= size s' -> lists_one_of_each s same P.
Proof.
move=> u sP cover le; split=> // x y xs ys xy; apply/eqP; case: (x =P y) => // /eqP ne.
suff : size s' <= size (rem y s).
  by rewrite size_rem // => le'; have := leq_trans le le'; case: (s) ys => //= a r _; rewrite ltnn.
have mem z : z \in s -> z != y -> z \in rem y s by move=> zs zy; rewrite mem_rem_uniq // inE zy.
apply: cover_le => [z /mem_rem/sP //|z Pz]; have [w ws wz] := cover z Pz.
case: (w =P y) wz => [->|/eqP wy] wz; last by exists w => //; apply: mem.
by exists x; [apply: mem|apply: trans wz].
Qed.
End OneOfEach.
