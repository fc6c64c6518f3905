(** * Arith: linear arithmetic, decided by Coq's own [lia] *)

From Coq Require Import Lia.
From mathcomp Require Import all_ssreflect.

Ltac to_coq :=
  repeat match goal with
  | H : is_true (leq _ _) |- _ => apply (elimT leP) in H
  | H : is_true (@eq_op nat_eqType _ _) |- _ => apply (elimT eqP) in H
  | H : is_true (andb _ _) |- _ => apply (elimT andP) in H; destruct H
  end;
  try match goal with
  | |- is_true (leq _ _) => apply/leP
  | |- is_true (@eq_op nat_eqType _ _) => apply/eqP
  end;
  repeat match goal with
  | H : context [double ?n] |- _ => rewrite -(mul2n n) in H
  | |- context [double ?n] => rewrite -(mul2n n)
  | H : context [addn ?m ?n] |- _ => change (addn m n) with (Nat.add m n) in H
  | |- context [addn ?m ?n] => change (addn m n) with (Nat.add m n)
  | H : context [muln ?m ?n] |- _ => change (muln m n) with (Nat.mul m n) in H
  | |- context [muln ?m ?n] => change (muln m n) with (Nat.mul m n)
  | H : context [subn ?m ?n] |- _ => change (subn m n) with (Nat.sub m n) in H
  | |- context [subn ?m ?n] => change (subn m n) with (Nat.sub m n)
  end;
  change (nat_of_bool true) with 1 in *; change (nat_of_bool false) with 0 in *.

Ltac arith := intros; to_coq; lia.

Example arith_works (a b c : nat) : a < b -> b.*2 + 3 <= c -> 2 * a + 5 <= c.
Proof. arith. Qed.
