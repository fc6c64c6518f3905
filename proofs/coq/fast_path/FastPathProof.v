(** * FastPathProof: the fast path accepts exactly the views that keep R1 to T1, and T3

<<
      the scan, the walks, the figures        ⟺   R1 … F2       FastPathAccepted.v, FastPathKept.v
      as few sets as Euler's formula allows   ⟺   T3            FastPathComponents.v, where R1 … F2 hold
      each set has one outside                ⟺   T1            FastPathComponents.v, where T3 holds, too
>>

    T2 is not settled here: the validator checks it next, and then all rules are known to hold. *)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import View Rules Lists ReferenceProof Verdict FastPath FastPathAccepted FastPathKept FastPathComponents.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Theorem fast_path_accepts t : fast_path t <-> holds_before t T2 /\ t3_euler t.
Proof.
split=> [/and5P[/allP scan /andP[/allP listed once] /allP around counts /andP[few ones]]|[H t3]].
  have low : lower t.
    apply: accepted_lower => // [h lh|v lv]; first by apply: scan; rewrite half_edge_onesP.
    by have := around v; rewrite vertex_onesP => /(_ lv); case: (FastPath.around t v) => [k|] // _; exists k.
  have t3 := (as_few_as_can_be_means low).1 few; have t1 := (one_outside_means low t3).1 ones; split=> // r.
  by rewrite ltnS leq_eqVlt => /orP[/eqP E|/low //]; case: r E.
have low : lower t by move=> q lt; apply: H; apply: leq_trans lt _.
apply/and5P; split.
- by apply/allP=> h; rewrite half_edge_onesP => lh; apply: scan_kept.
- by rewrite once_kept // andbT; apply/allP => e; apply: entry_kept.
- by apply/allP=> v; rewrite vertex_onesP => lv; rewrite around_kept.
- exact: complete_kept.
by apply/andP; split; [apply/as_few_as_can_be_means | apply/one_outside_means => //; apply: (H T1)].
Qed.

(** So a structure keeps all rules if and only if the fast path accepts it and T2 holds. *)

Corollary fast_path_leaves_t2 t : rules t <-> fast_path t /\ t2_nesting t.
Proof.
split=> [H|[/fast_path_accepts[H t3] t2] r].
  split; last exact: (H T2).
  by apply/fast_path_accepts; split=> [q _|]; [exact: H|exact: (H T3)].
have up : holds_before t T4.
  by move=> q lt; case: (ltnP (index q) (index T2)) => [/H //|]; case: q lt.
by case: r (up r) => [|||||||||||||_]; try exact; apply: t4_follows.
Qed.
