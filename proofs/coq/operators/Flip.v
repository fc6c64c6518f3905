(** * Flip: flipping an edge keeps all rules (dcel/operators/flip.rs)

    The edge of [n] and its twin [m] is taken out, by which two faces become one (RemoveMerge.v), and is put back between two corners
    of the cycle that is left there (ConnectSplit.v). Flipping takes the next corners along this cycle; any two will do.

<<
        ┌──────┬──────┐         ┌─────────────┐         ┌─────────────┐
        │      │      │   ──►   │             │   ──►   │  ────n────  │
        └──────┴──────┘         └─────────────┘         └─────────────┘
>>
*)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import View Rules Map RemoveEdge RemoveMerge ConnectSplit.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** The view [t], in which [n] runs from the corner after [a] to that after [b]. The face on one side of it is [g]. [new_left]: that is to
    the left. [moved]: the inner boundary components that are in it. *)
Definition flip_edge t n m f g kept dropped a b new_left moved :=
  split_face (merge_faces t n m f g kept dropped) a b n m f g kept dropped false new_left moved.

(** The edge is between two faces, and the corners are of its two cycles. *)
Definition is_flip t n m f g kept dropped a b :=
  is_seam t n m f g kept dropped && all (fun i => [&& i != n, i != m & (boundary_of t i == Some kept) || (boundary_of t i == Some dropped)]) [:: a; b].

(** If all rules held before, they hold after. *)
Theorem flip_edge_keeps_rules t n m f g kept dropped a b new_left moved : is_flip t n m f g kept dropped a b ->
  rules t -> rules (flip_edge t n m f g kept dropped a b new_left moved).
Proof.
case/andP=> seam /and3P[a_ok b_ok _] keeps; have keeps' := merge_faces_keeps_rules seam keeps.
case/and4P: seam => /eqP T _ kd faces; pose t1 := merge_faces t n m f g kept dropped.
have halfE i : half_edge t1 i = [&& i != n, i != m & half_edge t i].
  by rewrite /half_edge /=; case: (i != n); case: (i != m); rewrite /= ?andbF.
have at_ i : [&& i != n, i != m & (boundary_of t i == Some kept) || (boundary_of t i == Some dropped)] -> boundary_of t1 i = Some kept.
  case/and3P=> i_n im B; have li : half_edge t i by case/orP: (B) => /eqP E; apply: heard_live E.
  rewrite /boundary_of /heard halfE i_n im li /=; case: eqP => // no.
  by case/orP: B => /eqP B; [move: B; rewrite /boundary_of /heard li|case: no].
have kept_live : boundary t kept by case/orP: faces => /and3P[/eqP F /eqP G _]; [apply: heard_live F|apply: heard_live G].
apply: split_face_keeps_rules keeps'; rewrite ?at_ //.
- by rewrite /boundary_face /heard -/t1 /boundary /= kd /= -/(boundary t kept) kept_live eqxx.
- by rewrite -/t1 halfE eqxx.
- by rewrite -/t1 halfE eqxx andbF.
- by apply/eqP=> E; have [_ no] := keeps L1 n (heard_live T); apply: no; rewrite T E.
- by rewrite /boundary /= eqxx andbF.
by rewrite /face /= eqxx andbF.
Qed.
