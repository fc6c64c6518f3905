(** * SurfaceComplete: every surface has a certificate that is accepted

    What is accepted is a surface, and a surface has positions, ranks and names of its components and holes that are accepted. Where
    no boundary components and faces are stored, one for each cycle is added before. *)

From mathcomp Require Import all_ssreflect all_fingroup.
From twinedge Require Import Arith View Rules Loops LoopsProof Reference Map Counting ReferenceProof TopologyProof.
From twinedge Require Import Drawing Euler Numbered Genus Labels LabelsComplete OneOfEach Orbits Surface RotationSystem.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** ** The rules of a surface

    R1, L1, L2, L3, V1, V2 and B1, as for the plane. Each boundary component is a cycle. A face has one of them, which names it; a
    boundary component without a face is a hole. No vertex is passed twice by holes, and beside each edge of a hole is a face. *)

Record is_surface t : Prop := IsSurface {
  surface_half_edges : is_map t;
  surface_kept_leaves : v1_leaving t;
  surface_bare : forall v, vertex t v -> leaving t v = None -> bare t v;
  surface_rotation : v2_rotation t;
  surface_starts : forall b, boundary t b -> exists2 h, boundary_start t b = Some (AtHalfEdge h) & half_edge t h;
  surface_cycles_of : b1_cycle t;
  surface_faces : forall f, face t f -> exists2 b, outer t f = Some b & boundary_face t b = Some f;
  surface_boundaries : forall b f, boundary_face t b = Some f -> outer t f = Some b;
  surface_holes_apart : forall g h, half_edge t g -> half_edge t h -> in_hole t g -> in_hole t h -> origin t g = origin t h -> g = h;
  surface_beside_hole : forall h g, in_hole t h -> twin t h = Some g -> ~~ in_hole t g
}.

Section Complete.
Variable t : view.
Hypothesis s : is_surface t.

Let map := surface_half_edges s.

Lemma leaving_dart v h : leaving t v = Some h -> exists2 x : dart t, num x = h & org x = v.
Proof. by move=> E; apply/(originP map); apply: (surface_kept_leaves s) (heard_live E) E. Qed.

Lemma kept_of (x : dart t) : exists2 y : dart t, leaving t (org x) = Some (num y) & org y = org x.
Proof.
case E: (leaving t (org x)) => [h|].
  by have [y yh yx] := leaving_dart E; exists y; rewrite ?yh.
have := surface_bare s (org_live map x) E (dart_live x); by rewrite (originE map).
Qed.

Lemma start_of_dart b : boundary t b -> exists2 y : dart t, boundary_start t b = Some (AtHalfEdge (num y)) & bnd y = b.
Proof.
move=> lb; have [h S lh] := surface_starts s lb; have [y yh] := dartP lh; exists y; first by rewrite yh.
have [_ B] := surface_cycles_of s; have /(B b _ lb (dart_live y)) : exists2 g, boundary_start t b = Some (AtHalfEdge g) & on_cycle t g (num y).
  by exists (num y); [rewrite yh|exists 0].
by rewrite (boundaryE map) => -[].
Qed.

Lemma bnd_nx_same (x : dart t) : bnd (nx x) = bnd x.
Proof. by have [B _] := surface_cycles_of s; have := B _ (dart_live x); rewrite (nextE map) /= !(boundaryE map) => -[]. Qed.

(** ** Labels

    A half-edge's position is the number of turns, or of steps, from the one that its vertex keeps, or with which its boundary
    component starts. *)

Definition first_around (x : dart t) : dart t := step (fun h => origin t h >>= leaving t) x.
Definition first_along (x : dart t) : dart t := step (fun h => boundary_of t h >>= cycle_start t) x.

Definition from_first (follow first : dart t -> dart t) h : nat :=
  if @pick_slot (half_edge_slots t) (half_edge t) (Some h) is Some x then findex follow (first x) x else 0.

Definition position_of := from_first (@tn t) first_around.
Definition step_of := from_first (@nx t) first_along.
Definition component_of h : nat := odflt 0 (labels t h).
Definition border_of v : link :=
  if [pick x : dart t | in_hole t (num x) && (org x == v)] is Some x then Some (num x) else None.

Lemma from_firstE follow first (x : dart t) : from_first follow first (num x) = findex follow (first x) x.
Proof. by rewrite /from_first pick_num. Qed.

Lemma findex_grows (f : dart t -> dart t) y x : injective f -> fconnect f y x -> f x = y \/ findex f y x < findex f y (f x).
Proof.
move=> inj yx; case: (f x =P y) => [|ne]; [by left|right].
have lt : findex f y x < fingraph.order f y by apply: findex_max.
case: (ltngtP (findex f y x).+1 (fingraph.order f y)) => [more|less|same].
- by rewrite -{2}(iter_findex yx) -iterS findex_iter.
- by move: less; rewrite ltnS leqNgt lt.
by case: ne; rewrite -{1}(iter_findex yx) -iterS same iter_order.
Qed.

Lemma first_aroundE (x : dart t) : leaving t (org x) = Some (num (first_around x)) /\ fconnect (@tn t) (first_around x) x.
Proof.
have [y E yx] := kept_of x; have -> : first_around x = y by apply: stepP; rewrite (originE map).
by split=> //; rewrite (rotationE map (surface_rotation s)) yx.
Qed.

Lemma first_alongE (x : dart t) :
  boundary_start t (bnd x) = Some (AtHalfEdge (num (first_along x))) /\ fconnect (@nx t) (first_along x) x.
Proof.
have [y S yb] := start_of_dart (bnd_live map x).
have -> : first_along x = y by apply: stepP; rewrite (boundaryE map) /= /cycle_start S.
split=> //; apply/(on_cycleE map); have [_ B] := surface_cycles_of s.
have /(B _ _ (bnd_live map x) (dart_live x))[g] : boundary_of t (num x) = Some (bnd x) by apply: boundaryE.
by rewrite S => -[->].
Qed.

Lemma first_around_tn (x : dart t) : first_around (tn x) = first_around x.
Proof. by have [E _] := first_aroundE x; have [] := first_aroundE (tn x); rewrite (org_tn map) E => -[/num_inj]. Qed.

Lemma first_along_nx (x : dart t) : first_along (nx x) = first_along x.
Proof. by have [E _] := first_alongE x; have [] := first_alongE (nx x); rewrite bnd_nx_same E => -[/num_inj]. Qed.

Lemma complete_turn genus (x : dart t) : turn_ok t position_of genus (num x).
Proof.
apply/orP; right; rewrite (turnE map) (originE map) /=; have [-> yx] := first_aroundE x.
rewrite /position_of !from_firstE first_around_tn /= (inj_eq (@num_inj _ _)).
by case: (findex_grows (tn_inj map) yx) => [->|->]; rewrite ?eqxx ?orbT.
Qed.

Lemma complete_step genus (x : dart t) : step_ok t step_of genus (num x).
Proof.
apply/orP; right; rewrite (nextE map) (boundaryE map) /= /cycle_start; have [-> yx] := first_alongE x.
rewrite /step_of !from_firstE first_along_nx /= (inj_eq (@num_inj _ _)).
by case: (findex_grows (nx_inj map) yx) => [->|->]; rewrite ?eqxx ?orbT.
Qed.

(** *** Components *)

Lemma component_joined (x y : dart t) : joined x y -> component_of (num y) = component_of (num x).
Proof. by move/(labelE map) => E; rewrite /component_of E. Qed.

Definition root_of_piece h : Prop := labels t h = Some h.
Definition beside h g := g \in near t h.

Lemma piece_grounded (x : dart t) : grounded root_of_piece beside (num x).
Proof.
have [r xr] := label_total map x.
have [_ lr rr] := flood_all_label (@half_edge_below t) (near_live map) (near_sym map) (near_enough t) xr.
have [y yr] := dartP lr; have : joined x y by apply/(labelE map); rewrite yr xr; apply/esym.
suff H g : reached (near t) (num x) g -> grounded root_of_piece beside g -> grounded root_of_piece beside (num x).
  by move=> xy; apply: H xy _; apply: grounded_base; rewrite /root_of_piece yr.
by elim=> // u w _ IH uw gw; apply: IH; apply: (@grounded_down _ _ u w).
Qed.

Lemma component_ranks : exists rank : nat -> nat, forall x : dart t,
  root_of_piece (num x) \/ exists2 g, g \in near t (num x) & rank g < rank (num x).
Proof.
have [|rank ranks] := @ranks_exist root_of_piece beside [seq h <- iota 0 (half_edge_slots t) | half_edge t h].
  by move=> h; rewrite mem_filter => /andP[/dartP[x <-] _]; apply: piece_grounded.
by exists rank => x; apply: ranks; rewrite mem_filter mem_iota add0n dart_live half_edge_below ?dart_live.
Qed.

Lemma complete_components : component_count t component_of = size (pieces t).
Proof.
rewrite /component_count numberE size_filter; apply: eq_count => h /=; rewrite /component_of.
case lh: (half_edge t h) => /=.
  have [x xh] := dartP lh; have [r] := label_total map x; rewrite xh => -> /=.
  by apply/eqP/eqP => [->|[]].
by case E: (labels t h) => [r|] //; rewrite (label_live map E) in lh.
Qed.

Variable rank : nat -> nat.
Hypothesis ranks : forall x : dart t, root_of_piece (num x) \/ exists2 g, g \in near t (num x) & rank g < rank (num x).

Lemma complete_component (x : dart t) : component_ok t component_of rank (num x).
Proof.
rewrite /component_ok (nextE map) (twinE map) (prevE map) /= (component_joined (joined_nx map x)) (component_joined (joined_tw map x)).
rewrite !eqxx /=; case: (ranks x) => [E|[g]]; first by rewrite /component_of E eqxx.
by rewrite (near_dart map) !inE => /or3P[] /eqP-> ->; rewrite ?orbT.
Qed.

(** *** Holes *)

Lemma complete_border (x : dart t) : border_ok t border_of (num x).
Proof.
rewrite /border_ok; case: ifP => // hx; rewrite (originE map) (twinE map) /=; apply/andP; split.
  rewrite /border_of; case: pickP => [y /andP[hy /eqP yx]|none]; last by have := none x; rewrite hx eqxx.
  have -> : num y = num x; last by rewrite /= eqxx.
  by apply: (surface_holes_apart s) => //; [apply: dart_live|apply: dart_live|rewrite !(originE map) yx].
by apply: (surface_beside_hole s) hx (twinE map x).
Qed.

(** *** The tests *)

Lemma complete_half_edge genus (x : dart t) : surface_half_edge_ok t position_of step_of component_of rank border_of genus (num x).
Proof.
rewrite /surface_half_edge_ok complete_turn complete_step complete_component complete_border /twin_ok /next_ok /target_ok /origin_ok /cycle_ok.
have [E _] := first_aroundE x; have [S _] := first_alongE x.
rewrite (originE map) (twinE map) (nextE map) (prevE map) (boundaryE map) /= !(originE map) (twinE map) (prevE map) (nextE map).
rewrite (boundaryE map) (twK map) (nxK map) (pvK map) (org_nx map) bnd_nx_same E /cycle_start S /= !eqxx.
by rewrite (inj_eq (@num_inj _ _)) (tw_neq map).
Qed.

Lemma surface_is_basic : basics t.
Proof.
split=> //; last exact: bnd_nx_same.
  by move=> v h /leaving_dart[x <- <-]; rewrite (originE map) dart_live.
by move=> b h S; have [y] := start_of_dart (heard_live S); rewrite S => -[->] <-; rewrite (boundaryE map) dart_live.
Qed.

Lemma complete_formula : exists genus, 2 * (rotation_count t + cycle_count t) + 4 * genus = half_edge_count t + 4 * component_count t component_of.
Proof.
have basic := surface_is_basic; have [vs [cs [es [g [Hv Hc _ E F]]]]] := orbit_formula basic; exists g.
have V : size (rotations t) = size vs.
  apply: (one_of_each_size (same := on_orbit (turn t)) (P := half_edge t)) (Hv) => [g' h'|i j k|].
  - exact: (turn_sym map).
  - exact: orbit_trans.
  by apply: (rotations_each basic) => x; have [K yx] := first_aroundE x; exists (first_around x); rewrite // fconnect_sym //; apply: tn_inj.
have C : size (cycles t) = size cs.
  apply: (one_of_each_size (same := on_cycle t) (P := half_edge t)) (Hc) => [g' h'|i j k|].
  - exact: (cycle_sym map).
  - exact: orbit_trans.
  by apply: (cycles_each basic) => x; have [K yx] := first_alongE x; exists (first_along x); rewrite // fconnect_sym //; apply: nx_inj.
by rewrite rotations_count cycles_count complete_components V C E; move: F; arith.
Qed.

Lemma complete_surface : exists genus, surface_accepts t position_of step_of component_of rank border_of genus.
Proof.
have [genus F] := complete_formula; exists genus; apply/and5P; split; last exact/eqP.
- by apply/each_half_edgeP => h /dartP[x <-]; apply: complete_half_edge.
- apply/each_vertexP => v _; rewrite /surface_vertex_ok; case E: (leaving t v) => [h|] //.
  by have [x <- <-] := leaving_dart E; rewrite dart_live (originE map) /= eqxx.
- apply/each_boundaryP => b lb; have [y S yb] := start_of_dart lb.
  rewrite /surface_boundary_ok S dart_live (boundaryE map) yb /= eqxx.
  by case Ef: (boundary_face t b) => [f|] //; rewrite (surface_boundaries s Ef) /= eqxx.
apply/each_faceP => f lf; have [b Eb Ef] := surface_faces s lf.
by rewrite /surface_face_ok Eb Ef /= eqxx.
Qed.

End Complete.

(** ** Sound and complete *)

Theorem surface_certificate t :
  is_surface t <-> exists position step component rank border genus, surface_accepts t position step component rank border genus.
Proof.
split=> [s|[position [step [component [rank [border [genus ok]]]]]]].
  have [rank ranks] := component_ranks s; have [genus ok] := complete_surface s ranks.
  by do 5 eexists; exists genus; apply: ok.
have [map v1 v2 b1 _] := surface_sound ok; have [faces boundaries apart beside_hole] := surface_border_sound ok.
split=> //.
- move=> v _ E h lh /= O; case/and5P: ok => /each_half_edgeP /(_ h lh) /and5P[_ _ _ + _] _ _ _ _.
  by rewrite /origin_ok O /= E.
move=> b lb; case/and5P: ok => _ _ /each_boundaryP /(_ b lb) /andP[+ _] _ _.
by case: (boundary_start t b) => [[h|]|] // /andP[lh _]; exists h.
Qed.

(** ** Without faces

    Where vertices and half-edges are all that is stored, each cycle gets a boundary component and a face, which have the number of
    one of its half-edges. *)

Definition cycle_number t h : nat :=
  if @pick_slot (half_edge_slots t) (half_edge t) (Some h) is Some x then num (root (frel (@nx t)) x) else 0.

Definition numbers_cycle t h := half_edge t h && (cycle_number t h == h).

Definition with_faces t : view := {|
  vertex_slots := vertex_slots t;
  half_edge_slots := half_edge_slots t;
  boundary_slots := half_edge_slots t;
  face_slots := half_edge_slots t;
  is_vertex := is_vertex t;
  is_half_edge := is_half_edge t;
  is_boundary := numbers_cycle t;
  is_face := numbers_cycle t;
  says_origin := says_origin t;
  says_twin := says_twin t;
  says_next := says_next t;
  says_prev := says_prev t;
  says_boundary := fun h => Some (cycle_number t h);
  says_leaving := says_leaving t;
  says_isolated := fun _ => None;
  says_boundary_face := fun b => Some b;
  says_boundary_start := fun b => Some (AtHalfEdge b);
  says_boundary_place := fun _ => Some Outer;
  says_outer := fun f => Some f;
  says_inner_count := fun _ => 0;
  says_inner := fun _ _ => None
|}.

Section WithFaces.
Variable t : view.
Hypothesis keeps : surface_rules t.

Notation u := (with_faces t).

Let inj : injective (@nx t). Proof. exact: (nx_inj (one_boundary_map keeps)). Qed.
Let sym : connect_sym (frel (@nx t)). Proof. exact: fconnect_sym inj. Qed.

Lemma cycle_numberE (x : dart t) : cycle_number t (num x) = num (root (frel (@nx t)) x).
Proof. by rewrite /cycle_number pick_num. Qed.

Lemma added_live b : boundary u b = numbers_cycle t b.
Proof.
rewrite /boundary /=; case E: (numbers_cycle t b); last by rewrite andbF.
by case/andP: E => /half_edge_below ->.
Qed.

Lemma added_cycle (x : dart t) : boundary u (num (root (frel (@nx t)) x)).
Proof. by rewrite added_live /numbers_cycle dart_live cycle_numberE (root_root sym) /=. Qed.

Lemma added_boundary (x : dart t) : boundary_of u (num x) = Some (num (root (frel (@nx t)) x)).
Proof. by rewrite /boundary_of /heard (dart_live x : half_edge u (num x)) /= cycle_numberE. Qed.

Lemma with_faces_map : is_map u.
Proof.
have [[H _] [L1 L2 L3] _ _] := keeps; split=> // h lh; have [O T N P] := H h lh; split=> //.
have [x <-] := dartP (t := t) lh; exists (num (root (frel (@nx t)) x)); [exact: added_boundary|exact: added_cycle].
Qed.

Let map := with_faces_map.

Lemma with_faces_b1 : b1_cycle u.
Proof.
split=> [h lh|b h lb lh]; have [x xh] := dartP (t := t) lh; rewrite -xh.
  rewrite (nextE map x) /= !added_boundary; congr (Some (num _)); apply/eqP; rewrite (root_connect sym) sym.
  exact: fconnect1.
have [y yb] : exists y : dart t, num y = b by move: lb; rewrite added_live => /andP[/dartP].
have ry : root (frel (@nx t)) y = y.
  by move: lb; rewrite added_live -yb => /andP[_ /eqP]; rewrite cycle_numberE => /num_inj.
have S : boundary_start u b = Some (AtHalfEdge b) by rewrite /boundary_start /heard lb.
rewrite added_boundary S -yb; split=> [[/num_inj xy]|[_ [<-] /(on_cycleE map y x) yx]].
  exists (num y) => //; apply/(on_cycleE map y x); change (fconnect (@nx t) y x); rewrite sym -xy; exact: connect_root.
by congr (Some (num _)); rewrite -[RHS]ry; apply/esym/eqP; rewrite (root_connect sym).
Qed.

Lemma with_faces_no_hole h : half_edge u h -> in_hole u h = false.
Proof.
by move=> lh; have [x <-] := dartP (t := t) lh; rewrite /in_hole added_boundary /boundary_face /heard added_cycle.
Qed.

Lemma rules_surface : is_surface u.
Proof.
have [[_ V] _ v1 v2] := keeps; split=> //.
- by move=> v lv; case: (V v lv) => [[h E _]|[_ no _]]; [rewrite -[leaving u v]/(leaving t v) E|exact: no].
- move=> b lb; exists b; first by rewrite /boundary_start /heard lb.
  by move: lb; rewrite added_live => /andP[].
- exact: with_faces_b1.
- by move=> f lf; exists f; [rewrite /outer /heard lf|rewrite /boundary_face /heard (lf : boundary u f)].
- by move=> b f Ef; have lb := heard_live Ef; move: Ef; rewrite /boundary_face /heard lb => -[<-]; rewrite /outer /heard (lb : face u b).
- by move=> g h lg _; rewrite with_faces_no_hole.
move=> h g; case: (boolP (half_edge u h)) => [lh|no]; first by rewrite with_faces_no_hole.
by rewrite /in_hole /boundary_of /heard (negPf no).
Qed.

End WithFaces.

Lemma surface_rules_hold t : is_surface (with_faces t) -> surface_rules t.
Proof.
move=> s; have [H l1 l2 l3] := surface_half_edges s; split=> //; [split=> [h lh|v lv]| |].
- by have [O T N P _] := H h lh.
- case E: (leaving (with_faces t) v) => [h|]; last by right; split=> //; apply: (surface_bare s lv E).
  by left; exists h => //; apply: heard_live ((surface_kept_leaves s) v h lv E).
- exact: surface_kept_leaves s.
exact: surface_rotation s.
Qed.

(** If nothing but vertices and half-edges is stored, the rules of closed surfaces hold if and only if the table has a certificate
    when its cycles have got faces. *)

Theorem rotations_certificate t :
  surface_rules t <-> exists position step component rank border genus, surface_accepts (with_faces t) position step component rank border genus.
Proof. by rewrite -surface_certificate; split=> [/rules_surface|/surface_rules_hold]. Qed.
