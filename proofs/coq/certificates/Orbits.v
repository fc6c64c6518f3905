(** * Orbits: rotations, cycles and pieces, and what the records of a view say of them

    Where four facts hold that the tests of a certificate say ([basics]), different vertices are on different rotations, and
    different boundary components have different cycles. Nothing is said here of ranks. *)

From mathcomp Require Import all_ssreflect all_fingroup.
From twinedge Require Import Arith View Rules Loops LoopsProof Reference Map Counting ReferenceProof TopologyProof.
From twinedge Require Import Drawing Euler Numbered Genus WholeEuler Labels OneOfEach.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** Five tests of the half-edges say that the links between them are permutations. *)
Lemma map_tests t : (forall h, half_edge t h -> [&& twin_ok t h, next_ok t h, target_ok t h, origin_ok t h & cycle_ok t h]) ->
  is_map t.
Proof.
move=> tests.
have live (on : pred nat) T (asked : nat -> option T) l x : (forall i x, asked i = Some x -> on i) ->
    l >>= asked = Some x -> leads_to on l.
  by move=> H; case: l => [i|] //= E; exists i => //; apply: H E.
have nonnil l : ~~ is_nil l -> exists x, l = Some x by case: l => [x|] // _; exists x.
have heardL T (on : pred nat) (says : nat -> option T) i x : heard on says i = Some x -> on i by apply: heard_live.
split=> h /tests /and5P[/andP[/same_linkP tt /same_linkP nt] /andP[/same_linkP pn /same_linkP np] /same_linkP ta o /andP[_ c]] //.
have [x ox] := nonnil _ o; have [y cy] := nonnil _ c; split.
- exact: live (@heardL _ _ _) ox.
- exact: live (@heardL _ _ _) tt.
- exact: live (@heardL _ _ _) pn.
- exact: live (@heardL _ _ _) np.
apply: live cy => i z; rewrite /cycle_start; case S: (boundary_start t i) => [s|] // _.
exact: heard_live S.
Qed.

(** The facts on which the rotations, the cycles and their counts rest. *)
Record basics t : Prop := Basics {
  basic_map : is_map t;
  basic_leaving : forall v h, leaving t v = Some h -> half_edge t h /\ origin t h = Some v;
  basic_start : forall b h, boundary_start t b = Some (AtHalfEdge h) -> half_edge t h /\ boundary_of t h = Some b;
  basic_cycle : forall x : dart t, bnd (nx x) = bnd x
}.

Lemma is_nilP l : reflect (l = None) (is_nil l).
Proof. by case: l => [i|]; constructor. Qed.

Lemma numberE n (p : pred nat) : number n p = count p (iota 0 n).
Proof. by rewrite /number fold_count. Qed.

Definition roots_of t := [seq start_of t b | b <- iota 0 (boundary_slots t) & ~~ is_nil (cycle_start t b) && listed_inner t b].

Section Counts.
Variable t : view.
Hypothesis basic : basics t.

Let map := basic_map basic.

Lemma orbits_exist (f : dart t -> dart t) says : injective f ->
  (forall x y : dart t, on_orbit says (num x) (num y) <-> fconnect f x y) ->
  exists s, lists_one_of_each s (on_orbit says) (half_edge t).
Proof.
move=> inj onE; have sym := fconnect_sym inj; exists [seq num x | x <- enum (roots (frel f))]; split.
- by rewrite (map_inj_uniq (@num_inj _ _)) enum_uniq.
- by move=> h /mapP[x _ ->]; apply: dart_live.
- move=> g h /mapP[x + ->] /mapP[y + ->]; rewrite !mem_enum => /eqP rx /eqP ry /onE xy.
  by rewrite -rx -ry; congr num; apply/(rootP sym).
move=> h /dartP[x <-]; exists (num (root (frel f) x)).
  by apply: map_f; rewrite mem_enum; apply: roots_root.
by apply/onE; rewrite sym; apply: connect_root.
Qed.

Lemma edge_list : exists es, lists_one_of_each es (same_edge t) (half_edge t) /\ half_edge_count t = (size es).*2.
Proof.
have [edges every] := every_edge_exists (twK map) (tw_neq map); have [u all] := every.
have sameE (x y : dart t) : same_edge t (num x) (num y) <-> x = y \/ tw x = y.
  by rewrite /same_edge (twinE map); split=> [[/num_inj|[/num_inj]]|[->|->]]; by [left|right].
exists [seq num x | x <- edges]; split; last first.
  rewrite size_map (size_every every) /half_edge_count numberE (@count_slots _ _ (@half_edge_below t)) //.
  by apply: eq_card => x; rewrite !inE dart_live.
move: u; rewrite cat_uniq => /and3P[ue /hasPn no ut]; split.
- by rewrite (map_inj_uniq (@num_inj _ _)).
- by move=> h /mapP[x _ ->]; apply: dart_live.
- move=> g h /mapP[x xs ->] /mapP[y ys ->] /sameE[-> //|xy].
  by case/negP: (no (tw x) (map_f _ xs)); rewrite xy.
move=> h /dartP[x <-]; have := all x; rewrite mem_cat => /orP[xs|/mapP[y ys ->]].
  by exists (num x); [apply: map_f|left].
by exists (num y); [apply: map_f|apply/sameE; right].
Qed.

Lemma piece_list : lists_one_of_each (pieces t) (reached (near t)) (half_edge t).
Proof.
have piece h : h \in pieces t <-> labels t h = Some h.
  rewrite mem_filter mem_iota add0n; split=> [/andP[/eqP]//|E].
  by rewrite E eqxx half_edge_below // (label_live map E).
split; first exact: filter_uniq (iota_uniq _ _).
- by move=> h /piece/(label_live map).
- move=> g h /piece gp /piece hp; have [x xg] := dartP (label_live map gp); have [y yh] := dartP (label_live map hp).
  rewrite -xg -yh => /(labelE map); rewrite xg yh gp hp => -[] //.
move=> h /dartP[x <-]; have [r xr] := label_total map x; exists r.
  apply/piece; by case: (flood_all_label (@half_edge_below t) (near_live map) (near_sym map) (near_enough t) xr).
have [_ lr rr] := flood_all_label (@half_edge_below t) (near_live map) (near_sym map) (near_enough t) xr.
have [y yr] := dartP lr; rewrite -yr; apply/(labelE map).
by rewrite xr -yr; move: rr; rewrite -yr.
Qed.

(** *** The lists of the records *)

Lemma rotations_count : rotation_count t = size (rotations t).
Proof.
rewrite size_map size_filter /rotation_count numberE; apply: eq_count => v.
by case: (leaving t v).
Qed.

Lemma cycles_count : cycle_count t = size (cycles t).
Proof.
rewrite size_map size_filter /cycle_count numberE; apply: eq_count => b.
by rewrite /cycle_start /cyclic; case: (boundary_start t b) => [[|]|].
Qed.

Lemma roots_count : root_count t = size (roots_of t).
Proof. by rewrite size_map size_filter /root_count numberE. Qed.

Lemma kept_dart v : v \in with_edges t -> exists2 x : dart t, kept t v = num x & org x = v.
Proof.
rewrite mem_filter => /andP[+ _]; rewrite /kept; case E: (leaving t v) => [h|] // _.
by have [lh /(originP map)[x <- <-]] := basic_leaving basic E; exists x.
Qed.

Lemma start_dart b : ~~ is_nil (cycle_start t b) -> exists2 x : dart t, start_of t b = num x & bnd x = b.
Proof.
rewrite /cycle_start /start_of; case E: (boundary_start t b) => [[h|]|] // _.
have [/dartP[x xh] bh] := basic_start basic E; exists x; first by rewrite xh.
by move: bh; rewrite -xh (boundaryE map) => -[].
Qed.

Lemma cyclicE b : cyclic t b = ~~ is_nil (cycle_start t b).
Proof. by rewrite /cyclic /cycle_start; case: (boundary_start t b) => [[|]|]. Qed.

Lemma org_orbit (x y : dart t) : fconnect (@tn t) x y -> org x = org y.
Proof. by move/iter_findex <-; elim: (findex _ _ _) => //= k ->; rewrite org_tn. Qed.

Lemma bnd_orbit (x y : dart t) : fconnect (@nx t) x y -> bnd x = bnd y.
Proof. by move/iter_findex <-; elim: (findex _ _ _) => //= k ->; rewrite (basic_cycle basic). Qed.

Lemma rotations_differ g h : g \in rotations t -> h \in rotations t -> on_orbit (turn t) g h -> g = h.
Proof.
case/mapP=> v /kept_dart[x Ex xv] -> /mapP[w /kept_dart[y Ey yw] ->].
rewrite Ex Ey (on_rotationE map) => /org_orbit; rewrite xv yw => vw.
by rewrite -Ex -Ey vw.
Qed.

Lemma cycles_differ g h : g \in cycles t -> h \in cycles t -> on_cycle t g h -> g = h.
Proof.
have mem b : b \in [seq b <- iota 0 (boundary_slots t) | cyclic t b] -> exists2 x : dart t, start_of t b = num x & bnd x = b.
  by rewrite mem_filter cyclicE => /andP[/start_dart].
case/mapP=> b /mem[x Ex xb] -> /mapP[c /mem[y Ey yc] ->].
rewrite Ex Ey (on_cycleE map) => /bnd_orbit; rewrite xb yc => bc.
by rewrite -Ex -Ey bc.
Qed.

Lemma rotations_uniq : uniq (rotations t).
Proof.
rewrite map_inj_in_uniq ?filter_uniq ?iota_uniq // => v w /kept_dart[x -> <-] /kept_dart[y -> <-] /num_inj-> //.
Qed.

Lemma starts_uniq (p : pred nat) : (forall b, p b -> ~~ is_nil (cycle_start t b)) ->
  uniq [seq start_of t b | b <- iota 0 (boundary_slots t) & p b].
Proof.
move=> cyc; rewrite map_inj_in_uniq ?filter_uniq ?iota_uniq // => b c; rewrite !mem_filter.
by move=> /andP[/cyc/start_dart[x -> <-] _] /andP[/cyc/start_dart[y -> <-] _] /num_inj->.
Qed.

Lemma starts_live (p : pred nat) h : (forall b, p b -> ~~ is_nil (cycle_start t b)) ->
  h \in [seq start_of t b | b <- iota 0 (boundary_slots t) & p b] -> half_edge t h.
Proof. by move=> cyc /mapP[b]; rewrite mem_filter => /andP[/cyc/start_dart[x -> _] _] ->; apply: dart_live. Qed.

Lemma inner_cyclic b : ~~ is_nil (cycle_start t b) && listed_inner t b -> ~~ is_nil (cycle_start t b).
Proof. by case/andP. Qed.

Lemma cyclic_start b : cyclic t b -> ~~ is_nil (cycle_start t b).
Proof. by rewrite cyclicE. Qed.

(** *** Euler's formula

    Different vertices are on different rotations, different boundary components have different cycles. *)

Lemma starts_half_edge h : h \in cycles t -> half_edge t h.
Proof. exact: starts_live cyclic_start. Qed.

Lemma rotations_half_edge h : h \in rotations t -> half_edge t h.
Proof. by move=> /mapP[v /kept_dart[x -> _] ->]; apply: dart_live. Qed.

(** If what each vertex keeps, or each boundary component starts with, is on every such orbit, they are one of each. *)
Lemma rotations_each :
  (forall x : dart t, exists2 y : dart t, leaving t (org x) = Some (num y) & fconnect (@tn t) x y) ->
  lists_one_of_each (rotations t) (on_orbit (turn t)) (half_edge t).
Proof.
move=> kept_on; split; [exact: rotations_uniq|exact: rotations_half_edge|exact: rotations_differ|].
move=> h /dartP[x <-]; have [y E xy] := kept_on x; exists (num y).
  apply/mapP; exists (org x); last by rewrite /kept E.
  by rewrite mem_filter E mem_iota add0n vertex_below ?org_live.
by apply/(on_rotationE map); rewrite fconnect_sym //; apply: tn_inj.
Qed.

Lemma cycles_each :
  (forall x : dart t, exists2 y : dart t, boundary_start t (bnd x) = Some (AtHalfEdge (num y)) & fconnect (@nx t) x y) ->
  lists_one_of_each (cycles t) (on_cycle t) (half_edge t).
Proof.
move=> started_on; split; [exact: starts_uniq cyclic_start|exact: starts_half_edge|exact: cycles_differ|].
move=> h /dartP[x <-]; have [y E xy] := started_on x; exists (num y).
  apply/mapP; exists (bnd x); last by rewrite /start_of E.
  by rewrite mem_filter /cyclic E mem_iota add0n boundary_below ?bnd_live.
by apply/(on_cycleE map); rewrite fconnect_sym //; apply: nx_inj.
Qed.

Lemma orbit_decided says (f : dart t -> dart t) : (forall x y : dart t, on_orbit says (num x) (num y) <-> fconnect f x y) ->
  forall g h, half_edge t g -> half_edge t h -> on_orbit says g h \/ ~ on_orbit says g h.
Proof.
move=> onE _ _ /dartP[x <-] /dartP[y <-]; rewrite onE.
by case: (fconnect f x y); [left|right].
Qed.

Lemma orbit_formula : exists vs cs es g, [/\ lists_one_of_each vs (on_orbit (turn t)) (half_edge t),
  lists_one_of_each cs (on_cycle t) (half_edge t), lists_one_of_each es (same_edge t) (half_edge t),
  half_edge_count t = (size es).*2 & size vs + size cs + g.*2 = size es + (size (pieces t)).*2].
Proof.
have [vs Hv] := orbits_exist (tn_inj map) (on_rotationE map); have [cs Hc] := orbits_exist (nx_inj map) (on_cycleE map).
have [es [He E]] := edge_list; have Hp := piece_list.
have [g formula] : exists g, size vs + size cs + g.*2 = size es + (size (pieces t)).*2.
  by apply: (@part_euler t (half_edge t) map) Hv Hc He Hp => // x _; split; apply: dart_live.
by exists vs, cs, es, g.
Qed.

Lemma reached_back g h : half_edge t g -> half_edge t h -> reached (near t) g h -> reached (near t) h g.
Proof. by move=> lg _; apply: (reached_sym (near_live map) (near_sym map) lg). Qed.

End Counts.
