(** * RotationSystem: what the rules mean where nothing but vertices and half-edges is stored

    The expectation is a closed surface, and the parts are `prev` and `leaving`: no boundary components, and no faces. The rules
    that are left are R1 of these links, L1, L2, L3, V1 and V2. They mean a rotation system, that is, a graph on some closed
    surface: at each vertex the half-edges that leave it in their order around it, and an involution that pairs half-edges to
    edges.

<<
      h, its twin k                   rotation: the next half-edge, clockwise, around the same vertex
      ·──h──►  ◄──k──·                other:    the other half-edge of the same edge
                                      next h  = rotation (other h)
>>
*)

From mathcomp Require Import all_ssreflect all_fingroup.
From twinedge Require Import View Rules Loops LoopsProof Map Subdivision.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** ** The rules *)

Section Rules.
Variable t : view.

(** R1 of the links that are stored. *)
Definition surface_links_live :=
  (forall h, half_edge t h -> [/\ leads_to (vertex t) (origin t h), leads_to (half_edge t) (twin t h),
      leads_to (half_edge t) (next t h) & leads_to (half_edge t) (prev t h)]) /\
  forall v, vertex t v -> leads_to (half_edge t) (leaving t v) \/ leaving t v = None /\ bare t v.

Definition surface_rules :=
  [/\ surface_links_live, [/\ l1_twin t, l2_next_prev t & l3_target t], v1_leaving t & v2_rotation t].

End Rules.

(** ** Rotation systems *)

Record rotation_system := RotationSystem {
  points : finType;
  arcs : finType;
  around : {perm arcs};
  opposite : arcs -> arcs;
  from : arcs -> points;
  opposite_back : involutive opposite;
  opposite_differs : forall x, opposite x != x;
  around_from : forall x y, (y \in porbit around x) = (from x == from y)
}.

(** The parts of the rotation system can be numbered so that the view has these numbers and says of them what is so. *)
Record numbered t s (nv : points s -> nat) (nd : arcs s -> nat) : Prop := Numbered {
  points_numbered : numbers nv (vertex t);
  arcs_numbered : numbers nd (half_edge t);
  says_of_arc : forall x,
    [/\ origin t (nd x) = Some (nv (from x)), twin t (nd x) = Some (nd (opposite x)),
        next t (nd x) = Some (nd (follow (@around s) (@opposite s) x))
      & prev t (nd (follow (@around s) (@opposite s) x)) = Some (nd x)];
  says_of_point : forall v, (exists2 x, leaving t (nv v) = Some (nd x) & from x = v) \/
    leaving t (nv v) = None /\ forall x, from x <> v
}.

Definition represents_rotations t s := exists nv nd, @numbered t s nv nd.

Lemma porbit_fconnect (T : finType) (p : {perm T}) x y : (y \in porbit p x) = fconnect p x y.
Proof.
by apply/porbitP/idP => [[i ->]|/iter_findex <-]; [rewrite permX fconnect_iter | exists (findex p x y); rewrite permX].
Qed.

(** ** What keeps the rules is a rotation system

    The lemmas of Map.v are about views with boundary components. Here each half-edge gets the same one. *)

Definition one_boundary t : view := {|
  vertex_slots := vertex_slots t;
  half_edge_slots := half_edge_slots t;
  boundary_slots := 1;
  face_slots := face_slots t;
  is_vertex := is_vertex t;
  is_half_edge := is_half_edge t;
  is_boundary := fun _ => true;
  is_face := is_face t;
  says_origin := says_origin t;
  says_twin := says_twin t;
  says_next := says_next t;
  says_prev := says_prev t;
  says_boundary := fun _ => Some 0;
  says_leaving := says_leaving t;
  says_isolated := says_isolated t;
  says_boundary_face := says_boundary_face t;
  says_boundary_start := says_boundary_start t;
  says_boundary_place := says_boundary_place t;
  says_outer := says_outer t;
  says_inner_count := says_inner_count t;
  says_inner := says_inner t
|}.

Section Kept.
Variable t : view.
Hypothesis keeps : surface_rules t.

Notation u := (one_boundary t).

Lemma one_boundary_map : is_map u.
Proof.
have [[H _] [L1 L2 L3] _ _] := keeps; split=> // h lh; have [O T N P] := H h lh; split=> //.
by exists 0; rewrite // /boundary_of /heard lh.
Qed.

Let map := one_boundary_map.
Let rot : v2_rotation u. Proof. by have [] := keeps. Qed.

Definition kept_point : finType := [finType of slot (vertex_slots u) (vertex u)].
Definition kept_from (x : dart u) : kept_point := at_slot (@vertex_below u) (org_live map x).
Definition kept_around : {perm dart u} := perm (tn_inj map).

Lemma kept_around_from x y : (y \in porbit kept_around x) = (kept_from x == kept_from y).
Proof.
rewrite porbit_fconnect (eq_fconnect (permE (tn_inj map))) (rotationE map rot).
by apply/eqP/eqP => [E|E]; [apply: num_inj; rewrite !num_at | rewrite -[org x]/(num (kept_from x)) E].
Qed.

Definition kept_system : rotation_system :=
  @RotationSystem kept_point (dart u) kept_around (@tw u) kept_from (twK map) (tw_neq map) kept_around_from.

Lemma kept_follow x : follow kept_around (@tw u) x = nx x.
Proof. by rewrite /follow permE /tn (twK map). Qed.

Lemma rules_have_rotations : represents_rotations t kept_system.
Proof.
have [[_ Hv] _ V1 _] := keeps.
exists (fun v : kept_point => num v), (fun x : dart u => num x); split.
- split=> [v w /num_inj //|i]; split=> [/(slotP (@vertex_below u))[v vi]|[v <-]]; [by exists v|exact: num_live].
- split=> [x y /num_inj //|i]; split=> [/(dartP (t := u))[x xi]|[x <-]]; [by exists x|exact: dart_live].
- move=> x; rewrite [follow _ _ _](kept_follow x); split; [exact: (originE map) | exact: (twinE map) | exact: (nextE map) |].
  by have := prevE map (nx x); rewrite (nxK map).
move=> v; have lv : vertex u (num v) := num_live v.
case: (Hv _ lv) => [[h L lh]|[L no]]; [left|right].
  have [x xh] := dartP (t := u) lh; exists x; first by rewrite xh.
  have E : origin u (num x) = Some (num v) by rewrite xh; apply: (V1 _ _ lv L).
  by move: E; rewrite (originE map) => -[E]; apply: num_inj.
split=> // x xv; apply: (no (num x) (dart_live x)); rewrite -xv; exact: (originE map).
Qed.

End Kept.

(** ** A rotation system keeps the rules *)

Section Represented.
Variables (t : view) (s : rotation_system) (nv : points s -> nat) (nd : arcs s -> nat).
Hypothesis rep : numbered t nv nd.

Lemma nd_inj : injective nd. Proof. by have [] := arcs_numbered rep. Qed.
Lemma nv_inj : injective nv. Proof. by have [] := points_numbered rep. Qed.
Lemma arc_of h : half_edge t h -> exists x, nd x = h. Proof. by have [_ H] := arcs_numbered rep => /H. Qed.
Lemma nd_live x : half_edge t (nd x). Proof. by have [_ H] := arcs_numbered rep; apply/H; exists x. Qed.
Lemma nv_live v : vertex t (nv v). Proof. by have [_ H] := points_numbered rep; apply/H; exists v. Qed.
Lemma origin_nd x : origin t (nd x) = Some (nv (from x)). Proof. by case: (says_of_arc rep x). Qed.
Lemma twin_nd x : twin t (nd x) = Some (nd (opposite x)). Proof. by case: (says_of_arc rep x). Qed.
Lemma next_nd x : next t (nd x) = Some (nd (follow (@around s) (@opposite s) x)). Proof. by case: (says_of_arc rep x). Qed.

Lemma turn_nd x : turn t (nd x) = Some (nd (around s x)).
Proof. by rewrite /turn twin_nd /= next_nd /follow opposite_back. Qed.

Lemma iter_turn n x : iter n (obind (turn t)) (Some (nd x)) = Some (nd (iter n (around s) x)).
Proof. by elim: n => //= n ->; rewrite /= turn_nd. Qed.

Lemma from_around x : from (around s x) = from x.
Proof. by apply/eqP; rewrite eq_sym -around_from porbit_fconnect fconnect1. Qed.

Lemma prev_nd x : exists2 y, prev t (nd x) = Some (nd y) & follow (@around s) (@opposite s) y = x.
Proof.
exists (opposite ((around s)^-1%g x)); last by rewrite /follow opposite_back permKV.
by have [_ _ _] := says_of_arc rep (opposite ((around s)^-1%g x)); rewrite /follow opposite_back permKV.
Qed.

Lemma rotations_have_rules : surface_rules t.
Proof.
split; first split.
- move=> h /arc_of[x <-]; have [y P _] := prev_nd x; rewrite origin_nd twin_nd next_nd P.
  by split; [exists (nv (from x)) => //; apply: nv_live | | |]; eexists; by [|apply: nd_live].
- move=> v; have [_ H] := points_numbered rep => /H[p <-].
  case: (says_of_point rep p) => [[x L _]|[L no]]; [left; exists (nd x); rewrite ?L ?nd_live // | right; split=> //].
  by move=> h /arc_of[x <-]; rewrite origin_nd => -[/nv_inj/no].
- split=> h /arc_of[x <-].
  + rewrite twin_nd /= twin_nd opposite_back; split=> // -[/nd_inj E]; by have := opposite_differs x; rewrite E eqxx.
  + have [y P yx] := prev_nd x; rewrite next_nd P /= next_nd yx; split=> //.
    by case: (says_of_arc rep x).
  by rewrite next_nd twin_nd /= !origin_nd /follow from_around.
- move=> v h; have [_ H] := points_numbered rep => /H[p <-] L.
  by case: (says_of_point rep p) => [[x]|[]]; rewrite L // => -[->] <-; rewrite origin_nd.
move=> g h /arc_of[x <-] /arc_of[y <-]; rewrite !origin_nd; split=> [[n]|[/nv_inj E]].
  rewrite iter_turn => -[/nd_inj <-]; elim: n => //= n ->; by rewrite from_around.
have := around_from x y; rewrite E eqxx porbit_fconnect => /iter_findex F.
by exists (findex (around s) x y); rewrite iter_turn F.
Qed.

End Represented.

(** If vertices and half-edges are all that is stored, the rules of closed surfaces mean rotation systems. *)
Theorem surface_rules_mean_rotations t : surface_rules t <-> exists s, represents_rotations t s.
Proof.
split=> [keeps|[s [nv [nd rep]]]]; first by exists (kept_system keeps); apply: rules_have_rotations.
exact: rotations_have_rules rep.
Qed.
