(** * Stretch: a piece of an orbit

    The numbers from [x] to [z] along [says], which can be taken back: the half-edges between two corners of a cycle, along `next`
    (ConnectSplit.v), or between two corners of a vertex, along `turn` (SplitVertex.v). *)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import View Rules LoopsProof.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** The numbers from [x] to [z], by [says]; at most so many. *)
Fixpoint stretch (says : nat -> link) most x z : seq nat :=
  if most is m.+1 then x :: (if x == z then [::] else if says x is Some y then stretch says m y z else [::]) else [::].

Section Stretch.
Variables (n : nat) (live : nat -> bool) (says : nat -> link).
Hypothesis below : forall i, live i -> i < n.
Hypothesis total : forall i, live i -> exists2 j, says i = Some j & live j.
Hypothesis injective_says : forall i j, live i -> live j -> says i = says j -> i = j.

Notation f := (step says : slot n live -> slot n live).
Let saysE (x : slot n live) : says (num x) = Some (num (f x)) := says_step below total x.

Lemma step_inj : injective f.
Proof. by move=> x y E; apply/num_inj/injective_says; rewrite ?num_live // !saysE E. Qed.

Lemma stretchE m k (x z : slot n live) : iter m f x = z -> (forall j, j < m -> iter j f x <> z) -> m < k ->
  stretch says k (num x) (num z) = [seq num y | y <- traject f x m.+1].
Proof.
elim: m k x => [|m IH] [//|k] x /=; first by move=> -> _ _; rewrite eqxx.
move=> E first lt; case: eqP => [/num_inj xz|_]; first by case: (first 0 isT).
by rewrite saysE (IH k (f x)) // -?iterSr // => j jm; rewrite -iterSr; apply: (first j.+1).
Qed.

Variables x z : nat.
Hypothesis live_x : live x.
Hypothesis xz : on_orbit says x z.
Notation s := (stretch says n x z).

(** In the order of the walk, which comes to [z] at last, and not before. *)
Lemma stretch_is : exists y m, [/\ num y = x :> nat, num (iter m f y) = z, forall j, j < m -> num (iter j f y) <> z,
  forall i, i \in s <-> exists2 j, j <= m & i = num (iter j f y) & forall j, j <= m -> num (iter j.+1 f y) = x -> j = m].
Proof.
have [y yx] := slotP below live_x; have := xz; rewrite -yx => xz'; have [k] := xz'; rewrite (iter_step below total) => -[kz].
have [w wz] : exists w : slot n live, num w = z by exists (iter k f y).
move: xz'; rewrite -wz => /(on_orbit_step below total) c; pose m := findex f y w.
have before j : j < m -> iter j f y <> w.
  by move=> jm E; have := findex_iter (ltn_trans jm (findex_max c)); rewrite E => mj; rewrite /m mj ltnn in jm.
have lt : m < n by apply: leq_trans (findex_max c) (leq_trans (max_card _) (card_slot _ _)).
exists y, m; split=> //; first by rewrite iter_findex.
- by move=> j jm /num_inj; apply: before.
- move=> i; rewrite (stretchE (iter_findex c) before lt); split=> [/mapP[u /trajectP[j jm ->] ->]|[j jm ->]]; first by exists j.
  by apply: map_f; apply/trajectP; exists j.
move=> j jm /num_inj E; apply/eqP; rewrite eqn_leq jm leqNgt; apply/negP=> lt'.
by have := findex_iter (leq_ltn_trans lt' (findex_max c)); rewrite E findex0.
Qed.

Lemma stretch_ends : x \in s /\ z \in s.
Proof.
by have [y [m [yx yz _ inE _]]] := stretch_is; split; apply/inE; [exists 0|exists m].
Qed.

Lemma stretch_step i j : i \in s -> i <> z -> says i = Some j -> j \in s.
Proof.
have [y [m [_ yz _ inE _]]] := stretch_is; move=> /inE[l lm ->] ne; rewrite saysE => -[<-]; apply/inE; exists l.+1 => //.
by rewrite ltn_neqAle lm andbT; apply/eqP=> E; apply: ne; rewrite E.
Qed.

Lemma stretch_back i j : live i -> j \in s -> says i = Some j -> j = x \/ i \in s /\ i <> z.
Proof.
have [y [m [yx _ before inE _]]] := stretch_is; move=> li /inE[[|l] lm ->] N; first by left.
have [w wi] := slotP below li; rewrite -wi in N *; move: N; rewrite saysE => -[/num_inj/step_inj ->].
by right; split; [apply/inE; exists l => //; apply: ltnW|apply: before].
Qed.

(** The last before [x] is [z], or is not there. *)
Lemma stretch_before i : i <> z -> says i = Some x -> i \notin s.
Proof.
have [y [m [_ yz _ inE last]]] := stretch_is; move=> ne N; apply/negP=> /inE[j jm E]; apply: ne.
by move: N; rewrite E saysE => -[] /(last j jm) ->.
Qed.

Lemma stretch_ind (P : nat -> Prop) : P x -> (forall i j, i \in s -> i <> z -> P i -> says i = Some j -> P j) -> forall i, i \in s -> P i.
Proof.
have [y [m [yx yz before inE _]]] := stretch_is; move=> Px keep i /inE[j jm ->].
elim: j jm => [|j IH] jm; first by rewrite /= yx.
by apply: keep (IH (ltnW jm)) (saysE _); [apply/inE; exists j => //; apply: ltnW|apply: before].
Qed.

Lemma stretch_on i : i \in s -> on_orbit says x i.
Proof.
have [y [m [yx _ _ inE _]]] := stretch_is; move=> /inE[j _ ->]; exists j.
by rewrite -yx (iter_step below total).
Qed.

End Stretch.
