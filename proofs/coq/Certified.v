(** * Certified: the verdict on a folder, and what it means *)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import View Rules Subdivision Verdict Labels LabelsSound Columns.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Inductive verdict := Valid | Invalid | Unreadable.

Definition judge (o : folder) : verdict :=
  if readable o then if accepts (view_in o) (ranks_in o) then Valid else Invalid else Unreadable.

(** What is in a folder with the verdict "valid" keeps all rules, and represents a planar subdivision. *)
Theorem valid_is_plane o : judge o = Valid -> rules (view_in o) /\ exists s, represents (view_in o) s.
Proof.
rewrite /judge; case: (readable o) => //; case A: (accepts _ _) => // _; have H := labels_sound A.
by split=> //; apply/rules_mean_subdivision.
Qed.
