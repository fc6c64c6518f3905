(** * Certified: the verdict on a folder, and what it means *)

From Coq Require Import ZArith.
From mathcomp Require Import all_ssreflect.
From twinedge Require Import View Rules Subdivision Loops LoopsProof Reference Map Counting Lists Drawing Euler Verdict Labels LabelsSound OneOfEach.
From twinedge Require Import Surface Orientation Coordinates CoordinatesSound Columns.
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

(** The claim "surface": one of the genus that its counts have, with as many components as roots, and holes. *)
Definition surface_genus (o : surface) : nat :=
  let t := surface_view_in o in
  (half_edge_count t + 4 * component_count t (components_in o) - 2 * (rotation_count t + cycle_count t)) %/ 4.

Definition surface_components (o : surface) : nat := component_count (surface_view_in o) (components_in o).

Definition surface_holes (o : surface) : nat := hole_count (surface_view_in o).

Definition judge_surface (o : surface) : verdict :=
  if readable_surface o then
    if surface_accepts (surface_view_in o) (turns_in o) (steps_in o) (components_in o) (surface_ranks_in o) (borders_in o) (surface_genus o)
    then Valid else Invalid
  else Unreadable.

(** A table in a folder with the verdict "valid" keeps all rules, and represents a planar subdivision. *)
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
have H := labels_sound A; have map : is_map (view_in (topology o)) by apply: low_map => q _; apply: H.
split; first exact: H.
- by move=> k p g h; apply: (drawn_edges map D).
- by move=> k v h; apply: (drawn_vertices_off D).
- exact: (drawn_vertices D).
exact: (drawn_length map D).
Qed.

(** A table in a folder with the claim "surface" and the verdict "valid" keeps the rules of half-edges, V1, V2 and B1. It has as
    many components as are counted, and their genera add up to the genus that is computed: V + cycles + 2 · genus = E + 2 · components. *)
Theorem valid_is_surface o : judge_surface o = Valid -> let t := surface_view_in o in
  [/\ is_map t, v1_leaving t, v2_rotation t, b1_cycle t
    & exists vs cs es ps, [/\ lists_one_of_each vs (on_orbit (turn t)) (half_edge t), lists_one_of_each cs (on_cycle t) (half_edge t),
        lists_one_of_each es (same_edge t) (half_edge t), lists_one_of_each ps (reached (near t)) (half_edge t)
        & size ps = surface_components o /\ size vs + size cs + (surface_genus o).*2 = size es + (surface_components o).*2]].
Proof.
rewrite /judge_surface; case: (readable_surface o); last by []; case A: (surface_accepts _ _ _ _ _ _ _); last by [].
by move=> _; exact: surface_sound A.
Qed.

(** Each face has one boundary component, and each boundary component a face of its own, or it is a hole. No two holes meet at a
    vertex, and none meets itself there; beside each edge of a hole is a face. *)
Theorem valid_has_border o : judge_surface o = Valid -> let t := surface_view_in o in
  [/\ forall f, face t f -> exists2 b, outer t f = Some b & boundary_face t b = Some f,
      forall b f, boundary_face t b = Some f -> outer t f = Some b,
      forall g h, half_edge t g -> half_edge t h -> in_hole t g -> in_hole t h -> origin t g = origin t h -> g = h
    & forall h g, in_hole t h -> twin t h = Some g -> ~~ in_hole t g].
Proof.
rewrite /judge_surface; case: (readable_surface o); last by []; case A: (surface_accepts _ _ _ _ _ _ _); last by [].
by move=> _; exact: surface_border_sound A.
Qed.

(** It is open at as many holes as are printed: these are the cycles of half-edges without face, counting one of each. *)
Theorem valid_has_holes o : judge_surface o = Valid -> let t := surface_view_in o in
  exists hs, lists_one_of_each hs (on_cycle t) (fun h => half_edge t h /\ in_hole t h) /\ size hs = surface_holes o.
Proof.
rewrite /judge_surface; case: (readable_surface o); last by []; case A: (surface_accepts _ _ _ _ _ _ _); last by [].
by move=> _; exact: surface_holes_sound A.
Qed.
