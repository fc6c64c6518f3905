(** * Collapse: what stays true of components and nesting where vertices are taken together

    Some operators take away a vertex and leave the faces and boundary components as they are: joining two edges does. Each
    vertex before corresponds to one after, [col]. If what was connected is connected then, and what a boundary component
    passed it passes then, T1 and T2 stay true.

<<
      · u ─── · v ─── · w       col u = u, col v = w, col w = w         · u ─────── · w
>>
*)

From mathcomp Require Import all_ssreflect all_fingroup.
From twinedge Require Import View Rules Map Core.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** What [u] is connected to is connected to it, where L1 holds. *)
Lemma connected_back t u w : l1_twin t -> connected t u w -> connected t w u.
Proof.
move=> L1; elim=> [|h v x _ IH O T]; first exact: connected_self.
apply: connected_trans IH; move: T; rewrite /target; case G: (twin t h) => [g|] //= X.
apply: (@connected_edge t x g x v) => //; first exact: connected_self.
by have [+ _] := L1 h (heard_live O); rewrite /target G /= => ->.
Qed.

Section Collapse.
Variables (t t' : view) (inn : pred nat) (col : nat -> nat).
Hypothesis c : core t inn.
Hypothesis twins : l1_twin t'.
Hypothesis vertex_col : forall v, vertex t' v -> vertex t v /\ col v = v.
Hypothesis connected_col : forall u w, connected t u w -> connected t' (col u) (col w).
Hypothesis passes_col : forall b v, passes t b v -> exists2 w, passes t' b w & connected t' (col v) w.
Hypothesis boundary_same : forall b, boundary t' b = boundary t b.
Hypothesis face_same : forall f, face t' f = face t f.
Hypothesis boundary_face_same : forall b, boundary_face t' b = boundary_face t b.

Lemma collapse_inside v : vertex t' v -> exists b w, [/\ boundary t' b, inn b, passes t' b w & connected t' v w].
Proof.
move=> /vertex_col[lv cv]; have [b [w [lb I P C]]] := core_inside c lv; have [x P' C'] := passes_col P.
exists b, x; split=> //; first by rewrite boundary_same.
by apply: connected_trans C'; rewrite -cv; apply: connected_col.
Qed.

Lemma collapse_out f : face t' f -> steps_out t' inn f.
Proof.
rewrite face_same => /(core_out c); elim=> {f} [f lf no|f b v d w g F I P J Q C G _ IH].
  by apply: out_here => [|b]; [rewrite face_same|rewrite boundary_face_same; apply: no].
have [x P' Cx] := passes_col P; have [y Q' Cy] := passes_col Q.
apply: (@out_through t' inn f b x d y g) => //; rewrite ?boundary_face_same //.
exact: connected_trans (connected_back twins Cx) (connected_trans (connected_col C) Cy).
Qed.

End Collapse.
