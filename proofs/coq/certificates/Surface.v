(** * Surface: certificates of surfaces of any genus

    If the genus is 0, Euler's formula says that each vertex has one rotation and each boundary component one cycle, as in the plane. For
    any other genus positions say it: from every half-edge they grow around the vertex, until the half-edge that the vertex keeps,
    and along the cycle, until the start. A label that names the component is the same along the links, and ranks lead down to
    the half-edge whose number it is, so that there are exactly as many components as these.

    A surface with a border is a closed one on which some boundary components are *holes*: they have no face. Along a border
    no vertex is passed twice, and no edge has a hole on both sides.

<<
         \   2                    each half-edge is followed by one with a greater position,
      1 ── v ── 3                 or by the one that the vertex keeps
         /   0 (kept)
>>
*)

From mathcomp Require Import all_ssreflect all_fingroup.
From twinedge Require Import Arith View Rules Loops LoopsProof Reference Map Counting ReferenceProof TopologyProof.
From twinedge Require Import Drawing Euler Numbered Genus Labels OneOfEach Orbits Fewer.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section Checker.
Variables (t : view) (position step component rank : nat -> nat) (border : nat -> link) (genus : nat).

Definition turn_ok h :=
  (genus == 0) || if turn t h is Some g then same_link (origin t h >>= leaving t) (Some g) || (position h < position g) else false.

Definition step_ok h :=
  (genus == 0) || if next t h is Some g then same_link (boundary_of t h >>= cycle_start t) (Some g) || (step h < step g) else false.

Definition same_component h (l : link) := if l is Some g then component g == component h else false.

Definition component_ok h :=
  [&& same_component h (next t h), same_component h (twin t h)
    & [|| component h == h, lower_than rank h (next t h), lower_than rank h (prev t h) | lower_than rank h (twin t h)]].

(** It bounds no face. *)
Definition in_hole h := if boundary_of t h is Some b then is_nil (boundary_face t b) else false.

(** One half-edge of a hole leaves a vertex at most, the one that [border] names; on its other side is a face. *)
Definition border_ok h :=
  if in_hole h then
    same_link (origin t h >>= border) (Some h) && if twin t h is Some g then ~~ in_hole g else false
  else true.

Definition surface_half_edge_ok h :=
  [&& twin_ok t h, next_ok t h, target_ok t h, origin_ok t h
    & [&& cycle_ok t h, turn_ok h, step_ok h, component_ok h & border_ok h]].

Definition surface_vertex_ok v :=
  if leaving t v is Some h then half_edge t h && same_link (origin t h) (Some v) else true.

Definition surface_boundary_ok b :=
  (if boundary_start t b is Some (AtHalfEdge h) then half_edge t h && same_link (boundary_of t h) (Some b) else false)
  && if boundary_face t b is Some f then same_link (outer t f) (Some b) else true.

Definition surface_face_ok f := if outer t f is Some b then same_link (boundary_face t b) (Some f) else false.

Definition component_count := number (half_edge_slots t) (fun h => half_edge t h && (component h == h)).

Definition surface_accepts :=
  [&& each_half_edge t surface_half_edge_ok, each_vertex t surface_vertex_ok, each_boundary t surface_boundary_ok,
      each_face t surface_face_ok
    & 2 * (rotation_count t + cycle_count t) + 4 * genus == half_edge_count t + 4 * component_count].

(** ** Why it is right *)

Hypothesis ok : surface_accepts.

Let half_edges h : half_edge t h -> surface_half_edge_ok h.
Proof. by case/and5P: ok => /each_half_edgeP H _ _ _ _ /H. Qed.

Lemma surface_map : is_map t.
Proof. by apply: map_tests => h /half_edges /and5P[-> -> -> -> /andP[->]]. Qed.

Let map := surface_map.

Lemma surface_leaving v h : leaving t v = Some h -> half_edge t h /\ origin t h = Some v.
Proof.
move=> E; case/and5P: ok => _ /each_vertexP /(_ v (heard_live E)) + _ _ _.
by rewrite /surface_vertex_ok E => /andP[lh /same_linkP].
Qed.

Lemma surface_start b h : boundary_start t b = Some (AtHalfEdge h) -> half_edge t h /\ boundary_of t h = Some b.
Proof.
move=> E; case/and5P: ok => _ _ /each_boundaryP /(_ b (heard_live E)) + _ _.
by rewrite /surface_boundary_ok E => /andP[/andP[lh /same_linkP]].
Qed.

Lemma surface_cycle (x : dart t) : bnd (nx x) = bnd x.
Proof.
have /and5P[_ _ _ _ /and5P[/andP[+ _] _ _ _ _]] := half_edges (dart_live x).
by rewrite (nextE map) /= !(boundaryE map) => /same_linkP[].
Qed.

Lemma surface_basics : basics t.
Proof. by split; [exact: map|exact: surface_leaving|exact: surface_start|exact: surface_cycle]. Qed.

Let basic := surface_basics.

(** *** Components *)

Definition component_roots := [seq h <- iota 0 (half_edge_slots t) | half_edge t h && (component h == h)].

Lemma component_same (x y : dart t) : joined x y -> component (num y) = component (num x).
Proof.
have next_same (z : dart t) : component (num (nx z)) = component (num z).
  have /and5P[_ _ _ _ /and5P[_ _ _ /and3P[+ _ _] _]] := half_edges (dart_live z).
  by rewrite (nextE map) => /eqP.
move=> xy; apply: (@joined_ind t map (fun y => component (num y) = component (num x)) x y _ xy) => // z E; split.
- by rewrite next_same.
- by rewrite -E -[in RHS](pvK map z) next_same.
have /and5P[_ _ _ _ /and5P[_ _ _ /and3P[_ + _] _]] := half_edges (dart_live z).
by rewrite (twinE map) => /eqP->.
Qed.

Lemma component_descends (x : dart t) : exists2 y : dart t, component (num y) = num y & joined x y.
Proof.
move: {2}(rank _).+1 (ltnSn (rank (num x))) => n; elim: n x => // n IH x lt.
have down y : joined x y -> rank (num y) < rank (num x) -> exists2 z : dart t, component (num z) = num z & joined x z.
  move=> xy low; have [|z zz yz] := IH y; first exact: leq_trans low lt.
  by exists z => //; apply: joined_trans xy yz.
have /and5P[_ _ _ _ /and5P[_ _ _ /and3P[_ _ +] _]] := half_edges (dart_live x).
rewrite (nextE map) (prevE map) (twinE map) => /or4P[/eqP E|low|low|low].
- by exists x => //; apply: joined_refl.
- by apply: down low; apply: joined_nx.
- by apply: down low; apply: (joined_sym map); have := joined_nx map (pv x); rewrite (pvK map).
by apply: down low; apply: joined_tw.
Qed.

Lemma roots_each : lists_one_of_each component_roots (reached (near t)) (half_edge t).
Proof.
have mem h : h \in component_roots -> half_edge t h /\ component h = h by rewrite mem_filter => /andP[/andP[lh /eqP]].
split; first exact: filter_uniq (iota_uniq _ _).
- by move=> h /mem[].
- move=> g h /mem[/dartP[x <-] Ex] /mem[/dartP[y <-] Ey] xy.
  by rewrite -Ex -Ey; apply/esym/component_same.
move=> h /dartP[x <-]; have [y Ey xy] := component_descends x; exists (num y); last exact: (joined_sym map xy).
by rewrite mem_filter dart_live Ey eqxx mem_iota add0n half_edge_below ?dart_live.
Qed.

(** *** Rotations and cycles *)

(** Genus 0: by Euler's formula. *)
Lemma surface_orbits (x : dart t) : genus = 0 ->
  (exists2 y : dart t, leaving t (org x) = Some (num y) & fconnect (@tn t) x y) /\
  (exists2 y : dart t, boundary_start t (bnd x) = Some (AtHalfEdge (num y)) & fconnect (@nx t) x y).
Proof.
move=> none.
have twins h : half_edge t h -> twin_ok t h by case/half_edges/and5P.
have nexts h : half_edge t h -> next t h >>= prev t = Some h by case/half_edges/and5P=> _ /andP[/same_linkP].
have targets h : half_edge t h -> next t h >>= origin t = twin t h >>= origin t by case/half_edges/and5P=> _ _ /same_linkP.
have same h : half_edge t h -> next t h >>= boundary_of t = boundary_of t h by case/half_edges/and5P=> _ _ _ _ /andP[/andP[/same_linkP]].
have [_ roots_live _ roots_cover] := roots_each.
have sums : 2 * (rotation_count t + cycle_count t) = half_edge_count t + 4 * size component_roots.
  by case/and5P: ok => _ _ _ _ /eqP; rewrite none muln0 addn0 /component_count numberE -size_filter.
have [[v [g [E O R]]] [b [k [S B C]]]] := every_orbit twins nexts targets same surface_leaving surface_start roots_live roots_cover sums (dart_live x).
have [lg _] := surface_leaving E; have [lk _] := surface_start S; have [[y yg] [z zk]] := (dartP lg, dartP lk).
move: O B; rewrite (originE map) (boundaryE map) => -[vE] [bE]; split; [exists y|exists z].
- by rewrite vE yg.
- by rewrite fconnect_sym; [apply/(on_rotationE map); rewrite yg|exact: tn_inj].
- by rewrite bE zk.
by rewrite fconnect_sym; [apply/(on_cycleE map); rewrite zk|exact: nx_inj].
Qed.

(** Positions that grow until [y] lead to [y]. *)
Lemma positions_lead (f : dart t -> dart t) (p : nat -> nat) x y : injective f ->
  (forall k, let z := iter k f x in f z = y \/ p (num z) < p (num (f z))) -> fconnect f x y.
Proof.
move=> inj H; have grow k : fconnect f x y \/ p (num x) + k <= p (num (iter k f x)).
  elim: k => [|k [|le]]; [by right; rewrite addn0|by left|].
  case: (H k) => [<-|lt]; first by left; apply: (fconnect_iter f k.+1).
  by right; rewrite addnS; apply: leq_ltn_trans le lt.
case: (grow (fingraph.order f x)) => //; rewrite iter_order // => le.
by have := fingraph.order_gt0 f x; move: le; rewrite -{2}[p (num x)]addn0 leq_add2l leqn0 => /eqP->.
Qed.

Lemma surface_kept (x : dart t) : exists2 y : dart t, leaving t (org x) = Some (num y) & fconnect (@tn t) x y.
Proof.
have [/(surface_orbits x)[]//|some] := eqVneq genus 0.
have /and5P[_ _ _ + _] := half_edges (dart_live x); rewrite /origin_ok (originE map) /=.
case E: (leaving t (org x)) => [h|] // _; have [/dartP[y yh] _] := surface_leaving E; exists y; first by rewrite yh.
apply: (positions_lead (p := position) (tn_inj map)) => k /=; set z := iter k _ x.
have oz : org z = org x by rewrite /z; elim: (k) => //= j IH; rewrite org_tn.
have /and5P[_ _ _ _ /and5P[_ + _ _ _]] := half_edges (dart_live z).
rewrite /turn_ok (negPf some) (turnE map) (originE map) /= oz E => /orP[/same_linkP[]|lt]; last by right.
by rewrite -yh => /num_inj->; left.
Qed.

Lemma surface_started (x : dart t) : exists2 y : dart t, boundary_start t (bnd x) = Some (AtHalfEdge (num y)) & fconnect (@nx t) x y.
Proof.
have [/(surface_orbits x)[]//|some] := eqVneq genus 0.
have /and5P[_ _ _ _ /and5P[/andP[_ +] _ _ _ _]] := half_edges (dart_live x); rewrite (boundaryE map) /= /cycle_start.
case E: (boundary_start t (bnd x)) => [[h|]|] // _; have [/dartP[y yh] _] := surface_start E; exists y; first by rewrite yh.
apply: (positions_lead (p := step) (nx_inj map)) => k /=; set z := iter k _ x.
have bz : bnd z = bnd x by rewrite /z; elim: (k) => //= j IH; rewrite surface_cycle.
have /and5P[_ _ _ _ /and5P[_ _ + _ _]] := half_edges (dart_live z).
rewrite /step_ok (negPf some) (nextE map) (boundaryE map) /= bz /cycle_start E => /orP[/same_linkP[]|lt]; last by right.
by rewrite -yh => /num_inj->; left.
Qed.

Lemma surface_v1 : v1_leaving t.
Proof. by move=> v h _ /surface_leaving[]. Qed.

Lemma surface_v2 : v2_rotation t.
Proof.
move=> g h /dartP[x <-] /dartP[y <-]; rewrite (on_rotationE map) !(originE map); split=> [/(org_orbit basic)-> //|[xy]].
have [k kx xk] := surface_kept x; have [l ly yl] := surface_kept y; move: kx; rewrite xy ly => -[/num_inj kl].
by apply: connect_trans xk _; rewrite -kl fconnect_sym //; apply: tn_inj.
Qed.

Lemma surface_b1 : b1_cycle t.
Proof.
split=> [h /dartP[x <-]|b h lb /dartP[x <-]]; first by rewrite (nextE map) /= !(boundaryE map) surface_cycle.
rewrite (boundaryE map); split=> [[xb]|[g S]].
  have [y S xy] := surface_started x; exists (num y); first by rewrite -xb.
  by apply/(on_cycleE map); rewrite fconnect_sym //; apply: nx_inj.
have [/dartP[y yg]] := surface_start S; rewrite -yg (boundaryE map) => -[yb] /(on_cycleE map)/(bnd_orbit basic) yx.
by rewrite -yx yb.
Qed.

Lemma surface_rotations : lists_one_of_each (rotations t) (on_orbit (turn t)) (half_edge t).
Proof. exact: rotations_each basic surface_kept. Qed.

Lemma surface_cycles : lists_one_of_each (cycles t) (on_cycle t) (half_edge t).
Proof. exact: cycles_each basic surface_started. Qed.

Lemma surface_formula : exists es, lists_one_of_each es (same_edge t) (half_edge t) /\
  size component_roots = component_count /\ size (rotations t) + size (cycles t) + genus.*2 = size es + component_count.*2.
Proof.
have [vs [cs [es [g [_ _ He E _]]]]] := orbit_formula basic; exists es; split=> //.
split; first by rewrite /component_count numberE -size_filter.
case/and5P: ok => _ _ _ _ /eqP; rewrite rotations_count cycles_count E; arith.
Qed.

(** *** Faces and holes *)

Lemma surface_face f : face t f -> exists2 b, outer t f = Some b & boundary_face t b = Some f.
Proof.
case/and5P: ok => _ _ _ /each_faceP H _ /H; rewrite /surface_face_ok.
by case: (outer t f) => [b|] // /same_linkP[]; exists b.
Qed.

Lemma surface_outer b f : boundary_face t b = Some f -> outer t f = Some b.
Proof.
move=> E; case/and5P: ok => _ _ /each_boundaryP /(_ b (heard_live E)) + _ _.
by rewrite /surface_boundary_ok E => /andP[_ /same_linkP].
Qed.

Lemma surface_border g h : half_edge t g -> half_edge t h -> in_hole g -> in_hole h -> origin t g = origin t h -> g = h.
Proof.
move=> lg lh ig ih E; have named k : half_edge t k -> in_hole k -> origin t k >>= border = Some k.
  by move=> /half_edges /and5P[_ _ _ _ /and5P[_ _ _ _ B]] ik; move: B; rewrite /border_ok ik => /andP[/same_linkP].
by move: (named g lg ig); rewrite E named // => -[].
Qed.

Lemma surface_hole_twin h g : in_hole h -> twin t h = Some g -> ~~ in_hole g.
Proof.
move=> ih E; have /half_edges /and5P[_ _ _ _ /and5P[_ _ _ _]] := heard_live E.
by rewrite /border_ok ih E => /andP[].
Qed.

(** One half-edge of each hole: where it starts. *)
Definition hole_starts := [seq start_of t b | b <- iota 0 (boundary_slots t) & boundary t b && is_nil (boundary_face t b)].

Lemma surface_hole_start b : boundary t b && is_nil (boundary_face t b) -> ~~ is_nil (cycle_start t b).
Proof.
case/andP=> lb _; case/and5P: ok => _ _ /each_boundaryP /(_ b lb) + _ _.
by rewrite /surface_boundary_ok /cycle_start; case: (boundary_start t b) => [[h|v]|].
Qed.

Lemma surface_holes_each : lists_one_of_each hole_starts (on_cycle t) (fun h => half_edge t h /\ in_hole h).
Proof.
split; first exact: starts_uniq surface_hole_start.
- move=> h /mapP[b]; rewrite mem_filter => /andP[hb _] ->.
  have [x -> xb] := start_dart basic (surface_hole_start hb); split; first exact: dart_live.
  by rewrite /in_hole (boundaryE map) xb; case/andP: hb.
- move=> g h /mapP[b]; rewrite mem_filter => /andP[hb _] -> /mapP[c]; rewrite mem_filter => /andP[hc _] ->.
  have [x Ex xb] := start_dart basic (surface_hole_start hb); have [y Ey yc] := start_dart basic (surface_hole_start hc).
  by rewrite Ex Ey (on_cycleE map) => /(bnd_orbit basic); rewrite xb yc => bc; rewrite -Ex -Ey bc.
move=> h [/dartP[x <-]]; rewrite /in_hole (boundaryE map) => nil; have [y E xy] := surface_started x; exists (num y).
  apply/mapP; exists (bnd x); last by rewrite /start_of E.
  by rewrite mem_filter mem_iota add0n nil (heard_live E) boundary_below ?(heard_live E).
by apply/(on_cycleE map); rewrite fconnect_sym //; apply: nx_inj.
Qed.

End Checker.

Definition hole_count t := number (boundary_slots t) (fun b => boundary t b && is_nil (boundary_face t b)).

(** ** What is accepted is a surface

    R1 for half-edges, L1, L2, L3, V1, V2 and B1 hold; there are as many components as are counted, and their genera add up to
    the genus that is claimed: counting one of each rotation, cycle, edge and component, V + cycles + 2 · genus = E + 2 · components. *)

Theorem surface_sound t position step component rank border genus :
  surface_accepts t position step component rank border genus ->
  [/\ is_map t, v1_leaving t, v2_rotation t, b1_cycle t
    & exists vs cs es ps, [/\ lists_one_of_each vs (on_orbit (turn t)) (half_edge t), lists_one_of_each cs (on_cycle t) (half_edge t),
        lists_one_of_each es (same_edge t) (half_edge t), lists_one_of_each ps (reached (near t)) (half_edge t)
        & size ps = component_count t component /\ size vs + size cs + genus.*2 = size es + (component_count t component).*2]].
Proof.
move=> ok; split; [exact: surface_map ok|exact: surface_v1 ok|exact: surface_v2 ok|exact: surface_b1 ok|].
have [es [He eq]] := surface_formula ok; exists (rotations t), (cycles t), es, (component_roots t component); split=> //.
- exact: surface_rotations ok.
- exact: surface_cycles ok.
exact: roots_each ok.
Qed.

(** Each face has one boundary component, and each boundary component has a face of its own, or is a hole. At a vertex one
    half-edge of a hole starts at most, and on its other side is a face: the faces are a surface of which the holes are the border. *)

Theorem surface_border_sound t position step component rank border genus :
  surface_accepts t position step component rank border genus ->
  [/\ forall f, face t f -> exists2 b, outer t f = Some b & boundary_face t b = Some f,
      forall b f, boundary_face t b = Some f -> outer t f = Some b,
      forall g h, half_edge t g -> half_edge t h -> in_hole t g -> in_hole t h -> origin t g = origin t h -> g = h
    & forall h g, in_hole t h -> twin t h = Some g -> ~~ in_hole t g].
Proof.
move=> ok; split; [exact: surface_face ok|exact: surface_outer ok|exact: surface_border ok|exact: surface_hole_twin ok].
Qed.

(** There are as many border loops as holes are counted: each cycle of half-edges of holes is one hole. *)

Theorem surface_holes_sound t position step component rank border genus :
  surface_accepts t position step component rank border genus ->
  exists hs, lists_one_of_each hs (on_cycle t) (fun h => half_edge t h /\ in_hole t h) /\ size hs = hole_count t.
Proof.
move=> ok; exists (hole_starts t); split; first exact: surface_holes_each ok.
by rewrite size_map size_filter /hole_count numberE.
Qed.

(** ** Fewer tests for spheres

    Of genus 0, that the origin keeps a half-edge, that the boundary component starts with one, and that [next (prev h) = h] follow from the
    other tests ([Fewer.v]). *)

Definition few_sphere_half_edge_ok t component rank border h :=
  [&& twin_ok t h, same_link (next t h >>= prev t) (Some h), target_ok t h,
      same_link (next t h >>= boundary_of t) (boundary_of t h) & component_ok t component rank h && border_ok t border h].

Definition few_spheres_accept t component rank border :=
  [&& each_half_edge t (few_sphere_half_edge_ok t component rank border), each_vertex t (surface_vertex_ok t),
      each_boundary t (surface_boundary_ok t), each_face t (surface_face_ok t)
    & 2 * (rotation_count t + cycle_count t) == half_edge_count t + 4 * component_count t component].

Theorem few_spheres t position step component rank border :
  few_spheres_accept t component rank border -> surface_accepts t position step component rank border 0.
Proof.
case/and5P=> /each_half_edgeP H /each_vertexP V /each_boundaryP B F /eqP sums.
have twins h : half_edge t h -> twin_ok t h by case/H/and5P.
have nexts h : half_edge t h -> next t h >>= prev t = Some h by case/H/and5P=> _ /same_linkP.
have targets h : half_edge t h -> next t h >>= origin t = twin t h >>= origin t by case/H/and5P=> _ _ /same_linkP.
have same h : half_edge t h -> next t h >>= boundary_of t = boundary_of t h by case/H/and5P=> _ _ _ /same_linkP.
have keeps v h : leaving t v = Some h -> half_edge t h /\ origin t h = Some v.
  by move=> E; have := V v (heard_live E); rewrite /surface_vertex_ok E => /andP[lh /same_linkP].
have starts b h : boundary_start t b = Some (AtHalfEdge h) -> half_edge t h /\ boundary_of t h = Some b.
  by move=> E; have /andP[+ _] := B b (heard_live E); rewrite E => /andP[lh /same_linkP].
have roots_live h : h \in component_roots t component -> half_edge t h by rewrite mem_filter => /andP[/andP[]].
have roots_cover : forall h, half_edge t h -> exists2 g, g \in component_roots t component & reached (near t) g h.
  apply: (roots_reach (rank := rank) twins nexts roots_live) => h lh; have /and5P[_ _ _ _ /andP[/and3P[_ _ C] _]] := H h lh.
  case/or4P: C => [root|->|->|->]; rewrite ?orbT; [left|by right|by right|by right].
  by rewrite mem_filter lh root mem_iota add0n half_edge_below.
move: (sums); rewrite /component_count numberE -size_filter -/(component_roots t component) => roots_sums.
apply/and5P; split; [|exact/each_vertexP|exact/each_boundaryP|exact: F|by rewrite muln0 addn0; apply/eqP].
apply/each_half_edgeP=> h lh; have /and5P[tw _ ta _ /andP[co bo]] := H h lh.
rewrite /surface_half_edge_ok tw ta co bo (prev_back nexts lh).
rewrite (every_origin twins nexts targets same keeps starts roots_live roots_cover roots_sums lh).
by rewrite (every_cycle twins nexts targets same keeps starts roots_live roots_cover roots_sums lh).
Qed.
