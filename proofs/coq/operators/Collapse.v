(** * Collapse: what stays true of components and nesting where vertices are taken together, or apart

    Some operators take away a vertex, or add one, and leave the faces and boundary components as they are: contracting an edge
    does, and splitting a vertex. Vertices before and after correspond, [r]. If what was connected is connected then, and what a
    boundary component passed it passes then, T1 and T2 stay true.

<<
      · u ─── · v ─── · w       r u u, r v w, r w w         · u ─────── · w
>>
*)

From mathcomp Require Import all_ssreflect all_fingroup.
From twinedge Require Import View Rules Map Core.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** If L1 holds, connection is symmetric: whatever [u] is connected to is connected to [u]. *)
Lemma connected_back t u w : l1_twin t -> connected t u w -> connected t w u.
Proof.
move=> L1; elim=> [|h v x _ IH O T]; first exact: connected_self.
apply: connected_trans IH; move: T; rewrite /target; case G: (twin t h) => [g|] //= X.
apply: (@connected_edge t x g x v) => //; first exact: connected_self.
by have [+ _] := L1 h (heard_live O); rewrite /target G /= => ->.
Qed.

Section Collapse.
Variables (t t' : view) (inn : pred nat) (r : nat -> nat -> Prop).
Hypothesis c : core t inn.
Hypothesis vertex_r : forall v', vertex t' v' -> exists2 v, vertex t v & r v v'.
Hypothesis connected_r : forall u w u' w', connected t u w -> r u u' -> r w w' -> connected t' u' w'.
Hypothesis passes_r : forall b v, passes t b v -> exists2 v', r v v' & passes t' b v'.
Hypothesis boundary_same : forall b, boundary t' b = boundary t b.
Hypothesis face_same : forall f, face t' f = face t f.
Hypothesis boundary_face_same : forall b, boundary_face t' b = boundary_face t b.

Lemma collapse_inside v : vertex t' v -> exists b w, [/\ boundary t' b, inn b, passes t' b w & connected t' v w].
Proof.
move=> /vertex_r[u lu R]; have [b [w [lb I /passes_r[x S P] C]]] := core_inside c lu.
by exists b, x; split=> //; [rewrite boundary_same|apply: connected_r C R S].
Qed.

Lemma collapse_out f : face t' f -> steps_out t' inn f.
Proof.
rewrite face_same => /(core_out c); elim=> {f} [f lf no|f b v d w g F I /passes_r[x R P] J /passes_r[y S Q] C G _ IH].
  by apply: out_here => [|b]; [rewrite face_same|rewrite boundary_face_same; apply: no].
by apply: (@out_through t' inn f b x d y g) => //; rewrite ?boundary_face_same //; apply: connected_r C R S.
Qed.

End Collapse.
