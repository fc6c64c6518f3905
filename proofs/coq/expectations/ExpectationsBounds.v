(** * ExpectationsBounds: T4 follows from the rules before it, under every expectation, so it is never broken first *)

From mathcomp Require Import all_ssreflect all_fingroup.
From twinedge Require Import View Rules Reference Expectations ExpectationsCheck ExpectationsVerdict ExpectationsFaceless ExpectationsParts.
From twinedge Require Import ExpectationsOpenCounts ExpectationsOpen ExpectationsNested ExpectationsHoles ExpectationsClosed.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section Stored.
Variables (t : view) (faces records holes unbounded : bool) (sf so : nat -> link) (si : nat -> nat -> option start).
Let s := Structure t (Parts true true faces records true holes unbounded) sf so si.

Lemma open_t4 : before_t4 (open_on true) s -> t4 (open_on true) s.
Proof.
suff: before_t4 (open_on true) s -> rules_of (open_on true) s by move=> R /R H; apply: (H (Basic T4)).
rewrite /s; case: faces; last by move=> H; apply/open_faceless_rules; exact: open_faceless_before H.
case: holes; case: records => H.
- exact/nested_recorded_rules/nested_recorded_before.
- exact/nested_named_rules/nested_named_before.
- have off : false && true = false by []; apply/(open_recorded_rules t true unbounded sf so si off); exact: open_recorded_before H.
have off : false && true = false by []; apply/(open_named_rules t true unbounded sf so si off); exact: open_named_before H.
Qed.

Lemma closed_t4 : before_t4 (closed_on true) s -> t4 (closed_on true) s.
Proof. by case/closed_before=> /open_t4 T none; apply/(same_closed_t4 none). Qed.

End Stored.

Theorem t4_follows_of e s : before_t4 e s -> holds_of e s (Basic T4).
Proof.
case: e => on op m1 m2 m3 m4 m5 m6 m7 m8; case: on; last by move=> _; rewrite /= /t4.
set e := Expectation _ _ _ _ _ _ _ _ _ _ => H.
pose Q (r : any_rule) := if r is Basic q then index q < index T4 : Prop else False.
have fill e' : ~~ border_kept e' -> (before_t4 e' (filled e' s) -> t4 e' (filled e' s)) -> before_t4 e' s -> t4 e' s.
  move=> unasked; have [K _] := @filled_keeps Q e' s isT isT unasked => T B.
  have : t4 e' (filled e' s) by apply: T => q lt; apply: (K _ (Basic q)) => // -[r|] //; apply: B.
  by case: (s) => v [[] [] fa bo [] ho un] sf so si.
have every e' : before_t4 e' (filled e' s) = before_t4 e' (let: Structure v (Parts _ _ fa bo _ ho un) sf so si := filled e' s in
    Structure v (Parts true true fa bo true ho un) sf so si).
  by case: (s) => v [[] [] fa bo [] ho un] sf so si.
case: op @e H => e H.
  have B : before_t4 (open_on true) s by move=> q lt; have := H q lt; case: q {lt} => K; exact: K.
  have T : before_t4 (open_on true) (filled (open_on true) s) -> t4 (open_on true) (filled (open_on true) s).
    by rewrite every; case: (s) => v [[] [] fa bo [] ho un] sf so si; apply: open_t4.
  exact: (fill (open_on true) isT T B).
have B : before_t4 (closed_on true) s by move=> q lt; have := H q lt; case: q {lt} => K; exact: K.
have T : before_t4 (closed_on true) (filled (closed_on true) s) -> t4 (closed_on true) (filled (closed_on true) s).
  by rewrite every; case: (s) => v [[] [] fa bo [] ho un] sf so si; apply: closed_t4.
exact: (fill (closed_on true) isT T B).
Qed.

Corollary t4_never_first e s : first_broken_of e s <> Some (Basic T4).
Proof.
move=> E; have [no before] := (first_broken_of_some e s (Basic T4)).1 E; apply: no; apply: t4_follows_of => r lt.
exact: (before (Basic r)).
Qed.
