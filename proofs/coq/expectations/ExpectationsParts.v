(** * ExpectationsParts: what need not be stored, as it follows from the rest

    A structure without `prev`, without half-edges kept by vertices, or without places keeps the rules if and only if it keeps them
    when these are filled in. So what the rules mean where they are stored they mean where they are not.

<<
      ──g──► ──h──►        prev h   := the g whose next is h
      v ──h──►             leaving v := some h whose origin is v
      f lists b at p       place b  := p
>>
*)

From mathcomp Require Import all_ssreflect all_fingroup.
From twinedge Require Import View Rules Loops LoopsProof Reference ReferenceProof Map Subdivision Verdict RotationSystem.
From twinedge Require Import Expectations ExpectationsCheck ExpectationsLists ExpectationsPlane ExpectationsFaceless.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** The first of those below [n] with the property. *)
Lemma first_some n (p : pred nat) x : ohead [seq y <- iota 0 n | p y] = Some x -> p x /\ x < n.
Proof.
have: {subset [seq y <- iota 0 n | p y] <= [pred y | p y && (y < n)]} by move=> y; rewrite mem_filter mem_iota.
by case: [seq _ <- _ | _] => [|y ys] // /(_ y (mem_head _ _))/andP[py lt] [<-].
Qed.

Lemma first_none n (p : pred nat) x : ohead [seq y <- iota 0 n | p y] = None -> x < n -> ~~ p x.
Proof.
move=> N lt; apply/negP=> px; have: x \in [seq y <- iota 0 n | p y] by rewrite mem_filter px mem_iota.
by case: [seq _ <- _ | _] N.
Qed.

(** The view with other answers to one question. *)
Definition view_with v (prevs leavings : nat -> link) (places : nat -> option place) : view := {|
  vertex_slots := vertex_slots v;
  half_edge_slots := half_edge_slots v;
  boundary_slots := boundary_slots v;
  face_slots := face_slots v;
  is_vertex := is_vertex v;
  is_half_edge := is_half_edge v;
  is_boundary := is_boundary v;
  is_face := is_face v;
  says_origin := says_origin v;
  says_twin := says_twin v;
  says_next := says_next v;
  says_prev := prevs;
  says_boundary := says_boundary v;
  says_leaving := leavings;
  says_isolated := says_isolated v;
  says_boundary_face := says_boundary_face v;
  says_boundary_start := says_boundary_start v;
  says_boundary_place := places;
  says_outer := says_outer v;
  says_inner_count := says_inner_count v;
  says_inner := says_inner v
|}.

(** A half-edge that leaves the vertex, and the place where a face lists the boundary component. *)
Definition some_leaving v w : link := ohead [seq h <- iota 0 (half_edge_slots v) | same_link (origin v h) (Some w)].
Definition some_place e s b : option place :=
  omap snd (ohead [seq x <- entry_list e s | same_link (listed (seen e s) x.1 x.2) (Some b)]).

Section Parts.
Variables (e : expectation) (v : view) (prev_stored leaving_stored faces records places holes unbounded : bool).
Variables (sf so : nat -> link) (si : nat -> nat -> option start).

Notation stores pr le pl w := (Structure w (Parts pr le faces records pl holes unbounded) sf so si).

(** They are of any rules [Q], if those are among them that say what the part is. *)
Variable Q : any_rule -> Prop.
Notation keeps w := (forall r, Q r -> holds_of e w r).

Theorem prev_follows : Q (Basic R1) -> Q (Basic L2) -> let s := stores false leaving_stored places v in
  keeps s <-> keeps (stores true leaving_stored places (view_with v (before s) (says_leaving v) (says_boundary_place v))).
Proof.
move=> q1 q2 s; set s' := Structure _ _ _ _ _.
have others r : r <> Basic R1 -> r <> Basic L2 -> holds_of e s r = holds_of e s' r by case: r => [[]|[]].
split=> [H|H] r q.
  have [Hh Hv Hb Hf S] := H (Basic R1) q1; have L2' : l2 e s := H (Basic L2) q2.
  have NE k : next (seen e s) k = next v k by [].
  have NE' k : next (seen e s') k = next v k by [].
  pose dart' := [finType of slot (half_edge_slots v) (half_edge v)].
  have total h : half_edge v h -> exists2 n, next v h = Some n & half_edge v n by case/Hh.
  pose nx' : dart' -> dart' := step (next v).
  have nextN (x : dart') : next v (num x) = Some (num (nx' x)) := says_step (@half_edge_below v) total x.
  have inj : injective nx'.
    by move=> x y E; apply: num_inj; apply: (L2' (num x) (num y) (num_live x) (num_live y)); rewrite !NE !nextN E.
  have prevE (h : nat) : half_edge v h -> exists2 g, before s h = Some g & half_edge v g /\ next v g = Some h.
    case/(slotP (@half_edge_below v))=> y yh; case E: (before s h) => [g|].
      by case/first_some: E => /andP[lg /same_linkP N] _; exists g.
    have := first_none E (half_edge_below (num_live (invF inj y))).
    by rewrite num_live nextN f_invF yh /= eqxx.
  have prevS h g : half_edge v h -> before s h = Some g -> prev (seen e s') h = Some g.
    by move=> lh E; rewrite /prev /heard (lh : half_edge (seen e s') h).
  have r1' : r1 e s'.
    split=> // h lh; have [O T N _ D] := Hh h lh; split=> // _.
    by have [g E [lg _]] := prevE h lh; exists g => //; apply: prevS.
  have l2' : l2 e s'.
    move=> h lh; split.
      have [n N ln] := total h lh; rewrite NE' N /=.
      have [g E [lg Ng]] := prevE n ln; rewrite (prevS n g ln E); congr Some.
      by apply: (L2' g h lg lh); rewrite !NE Ng N.
    by have [g E [lg Ng]] := prevE h lh; rewrite (prevS h g lh E).
  by case: r q => [[]|m] q //; rewrite -others //; apply: H.
have [Hh Hv Hb Hf S] := H (Basic R1) q1; have L2' : l2 e s' := H (Basic L2) q2.
have r1' : r1 e s by split=> // h lh; have [O T N _ D] := Hh h lh; split.
have l2' : l2 e s.
  move=> g h lg lh E; have [G _] := L2' g lg; have [K _] := L2' h lh.
  by move: G; rewrite (E : next (seen e s') g = next (seen e s') h) K => -[].
by case: r q => [[]|m] q //; rewrite others //; apply: H.
Qed.

Theorem leaving_follows : Q (Basic R1) -> ~~ border_kept e -> let s := stores prev_stored false places v in
  keeps s <-> keeps (stores prev_stored true places (view_with v (says_prev v) (some_leaving v) (says_boundary_place v))).
Proof.
move=> q1 /negPf unasked s; set s' := Structure _ _ _ _ _.
have others r : r <> Basic R1 -> r <> Basic V1 -> r <> Mesh M8 -> holds_of e s r = holds_of e s' r by case: r => [[]|[]].
have leavingE w : vertex v w -> leaving (seen e s') w = some_leaving v w by move=> lw; rewrite /leaving /heard (lw : vertex (seen e s') w).
split=> [H|H] r q.
  have [Hh Hv Hb Hf S] := H (Basic R1) q1.
  have r1' : r1 e s'.
    split=> // w lw; split; last by have [_] := Hv w lw.
    move=> _; rewrite leavingE //; case E: (some_leaving v w) => [h|]; [left|right].
      by case/first_some: E => /same_linkP O _; exists h => //; apply: heard_live O.
    split=> // h lh O; have := first_none E (half_edge_below (lh : half_edge v h)).
    by rewrite (O : origin v h = Some w) /= eqxx.
  have v1' : v1_leaving (seen e s').
    by move=> w h lw; rewrite leavingE // => /first_some[/same_linkP].
  case: r q => [[]|[]] q //; try by (rewrite -others //; apply: H).
  by rewrite /= /m8 unasked.
have [Hh Hv Hb Hf S] := H (Basic R1) q1.
have r1' : r1 e s by split=> // w lw; split=> //; have [_] := Hv w lw.
have v1' : v1_leaving (seen e s) by move=> w h _; rewrite /leaving /heard; case: ifP.
case: r q => [[]|[]] q //; try by (rewrite others //; apply: H).
Qed.

Theorem places_follow : let s := stores prev_stored leaving_stored false v in
  keeps s <-> keeps (stores prev_stored leaving_stored true (view_with v (says_prev v) (says_leaving v) (some_place e s))).
Proof.
move=> s; set s' := Structure _ _ _ _ _.
have others r : r <> Basic F2 -> holds_of e s r = holds_of e s' r by case: r => [[]|[]].
suff same : f2 e s <-> f2 e s'.
  by split=> H; case=> [[]|m] q;
    first [by rewrite -others //; apply: H | by rewrite others //; apply: H | by apply/same; apply: (H (Basic F2))].
rewrite /f2 -[has_records s']/(has_records s) -[has_faces s']/(has_faces s); case R: (has_records s) => //.
split=> H b lb; have [f [p [Ef P L]]] := H b lb; exists f, p; split=> //; last by rewrite /has_places andbF.
move=> _.
have lp : listed (seen e s) f p = Some b by apply/L.
rewrite /boundary_place /heard (lb : boundary (seen e s') b) /= /some_place.
case E: [seq x <- entry_list e s | _] => [|[g q] rest].
  have: (f, p) \in [seq x <- entry_list e s | same_link (listed (seen e s) x.1 x.2) (Some b)].
    by rewrite mem_filter (listed_entry lp) andbT; apply/same_linkP.
  by rewrite E.
have: (g, q) \in [seq x <- entry_list e s | same_link (listed (seen e s) x.1 x.2) (Some b)] by rewrite E mem_head.
by rewrite mem_filter => /andP[/same_linkP /= /L[_ qp] _]; rewrite /= qp.
Qed.

End Parts.

(** ** A structure with all three filled in *)

Definition with_prev s := let: Structure v (Parts pr le fa bo pl ho un) sf so si := s in
  if pr then s else
  Structure (view_with v (before s) (says_leaving v) (says_boundary_place v)) (Parts true le fa bo pl ho un) sf so si.

Definition with_leaving s := let: Structure v (Parts pr le fa bo pl ho un) sf so si := s in
  if le then s else
  Structure (view_with v (says_prev v) (some_leaving v) (says_boundary_place v)) (Parts pr true fa bo pl ho un) sf so si.

Definition with_places e s := let: Structure v (Parts pr le fa bo pl ho un) sf so si := s in
  if pl then s else
  Structure (view_with v (says_prev v) (says_leaving v) (some_place e s)) (Parts pr le fa bo true ho un) sf so si.

Definition filled e s := with_places e (with_leaving (with_prev s)).

(** It keeps the rules of any expectation if and only if the structure does; but M8 is a rule about what is stored. *)
Theorem filled_keeps (Q : any_rule -> Prop) e s : Q (Basic R1) -> Q (Basic L2) -> ~~ border_kept e ->
  (forall r, Q r -> holds_of e s r) <-> (forall r, Q r -> holds_of e (filled e s) r).
Proof.
move=> q1 q2 unasked; pose keeps u := forall r, Q r -> holds_of e u r.
have P u : keeps u <-> keeps (with_prev u).
  by case: u => v [[] le fa bo pl ho un] sf so si //; apply: prev_follows.
have L u : keeps u <-> keeps (with_leaving u).
  by case: u => v [pr [] fa bo pl ho un] sf so si //; apply: leaving_follows.
have A u : keeps u <-> keeps (with_places e u).
  by case: u => v [pr le fa bo [] ho un] sf so si //; apply: places_follow.
by rewrite -/(keeps s) -/(keeps (filled e s)) P L A.
Qed.

Corollary filled_rules e s : ~~ border_kept e -> rules_of e s <-> rules_of e (filled e s).
Proof.
move=> unasked; have := @filled_keeps (fun _ => True) e s I I unasked.
by case=> K K'; split=> H r; [apply: K|apply: K'].
Qed.

(** So of the closed plane with everything else the rules mean planar subdivisions, and without faces the rules mean rotation
    systems, whether these parts are stored or not. *)

Theorem filled_plane v pr le pl sf so si : let s := Structure v (Parts pr le true true pl true true) sf so si in
  rules_of plane s <-> exists u, represents (answers (filled plane s)) u.
Proof.
move=> s; rewrite (filled_rules s (isT : ~~ border_kept plane)) -rules_mean_subdivision.
by rewrite /s; case: pr s; case: le; case: pl => s; apply: plane_rules.
Qed.

Theorem filled_faceless_surface v pr le bo pl ho un sf so si : let s := Structure v (Parts pr le false bo pl ho un) sf so si in
  rules_of surface s <-> exists r, represents_rotations (answers (filled surface s)) r.
Proof.
move=> s; rewrite (filled_rules s (isT : ~~ border_kept surface)).
by rewrite /s; case: pr s; case: le; case: pl => s; apply: faceless_surface.
Qed.

Theorem filled_faceless_plane v pr le bo pl ho un sf so si : let s := Structure v (Parts pr le false bo pl ho un) sf so si in
  rules_of plane s <-> exists r, represents_rotations (answers (filled plane s)) r /\ plane_system r.
Proof.
move=> s; rewrite (filled_rules s (isT : ~~ border_kept plane)).
by rewrite /s; case: pr s; case: le; case: pl => s; apply: faceless_plane.
Qed.
