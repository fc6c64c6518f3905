(** * Certified: the verdict on a folder, and what it means *)

From Coq Require Import ZArith.
From mathcomp Require Import all_ssreflect.
From twinedge Require Import View Rules Subdivision Map Verdict Labels LabelsSound Orientation Coordinates CoordinatesSound Columns.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Inductive verdict := Valid | Invalid | Unreadable.

(** The claim "plane". *)
Definition judge (o : folder) : verdict :=
  if readable plane_line o then if accepts (view_in o) (ranks_in o) then Valid else Invalid else Unreadable.

(** The claim "drawing": plane, and drawn with straight edges. *)
Definition judge_drawing (o : drawing) : verdict :=
  if readable_drawing o then
    if accepts (view_in (topology o)) (ranks_in (topology o)) && drawn (view_in (topology o)) (refinement_in o)
    then Valid else Invalid
  else Unreadable.

(** What is in a folder with the verdict "valid" keeps all rules, and represents a planar subdivision. *)
Theorem valid_is_plane o : judge o = Valid -> rules (view_in o) /\ exists s, represents (view_in o) s.
Proof.
rewrite /judge; case: (readable _ o) => //; case A: (accepts _ _) => // _; have H := labels_sound A.
by split=> //; apply/rules_mean_subdivision.
Qed.

(** So is what is in one with a drawing; and the drawing is without crossings: at each rational point [p / k] there is at
    most one edge, and no vertex if there is an edge; vertices are at different points, and no edge has length zero. *)
Theorem valid_is_drawn o : judge_drawing o = Valid -> let t := view_in (topology o) in let at_ := point_in o in
  let on k p h := exists u w, [/\ origin t h = Some u, target t h = Some w & strictly_between (scaled k (at_ u)) (scaled k (at_ w)) p] in
  [/\ rules t,
      forall k p g h, (0 < k)%Z -> half_edge t g -> half_edge t h -> on k p g -> on k p h -> h = g \/ twin t g = Some h,
      forall k v h, (0 < k)%Z -> vertex t v -> half_edge t h -> ~ on k (scaled k (at_ v)) h,
      forall u v, vertex t u -> vertex t v -> at_ u = at_ v -> u = v
    & forall h u w, half_edge t h -> origin t h = Some u -> target t h = Some w -> at_ u <> at_ w].
Proof.
rewrite /judge_drawing; case: (readable_drawing o) => //; case A: (accepts _ _) => //; case D: (drawn _ _) => //= _.
have H := labels_sound A; have map : is_map (view_in (topology o)).
  by case: (H R1) => -[ll _ _ _] _; split=> //; [exact: (H L1)|exact: (H L2)|exact: (H L3)].
split=> //.
- by move=> k p g h; apply: (drawn_edges map D).
- by move=> k v h; apply: (drawn_vertices_off D).
- exact: (drawn_vertices D).
exact: (drawn_length map D).
Qed.
