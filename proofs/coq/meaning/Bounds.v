(** * Bounds: T4 follows from the others (rules/bounds.rs)

    In a simple plane map with three vertices or more every walk of a component with three vertices or more has at least
    three half-edges. So [3 · cycles ≤ 2E], and Euler's formula gives [E ≤ 3V − 6]. Components with fewer vertices make
    it only easier. *)

From mathcomp Require Import all_ssreflect all_fingroup.
From twinedge Require Import Arith View Rules Loops LoopsProof Reference Map Counting Lists TopologyProof.
From twinedge Require Import Drawing Euler Numbered Genus WholeEuler.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section Bounds.
Variable t : view.
Hypothesis low : lower t.
Hypothesis t3 : t3_euler t.
Hypothesis plain : simple t.

Let map := low_map low.

Lemma no_loop (x : dart t) : org x <> org (tw x).
Proof. by have [H _] := plain (num x) (originE map x) (targetE map x). Qed.

Lemma no_parallel (x y : dart t) : org y = org x -> org (tw y) = org (tw x) -> x = y.
Proof.
move=> o w; have [_ H] := plain (num y) (originE map x) (targetE map x).
by apply: num_inj; apply: H; rewrite ?(originE map) ?(targetE map) ?o ?w.
Qed.

(** T3 of a component with edges. *)
Lemma part_plane es r : lists_one_of_each es (same_edge t) (half_edge t) -> r \in pieces t ->
  size (in_part t r (rotations t)) + size (in_part t r (cycles t)) = size (in_part t r es) + 2.
Proof.
move=> Hes rp; have [x xr] : exists x : dart t, labels t (num x) = Some r.
  by have rr := (piecesP low r).1 rp; have [x xr] := dartP (label_live map rr); exists x; rewrite xr.
have [V [E [C [H VC]]]] := t3 (org_live map x); have [a b c] := component_sizes low xr Hes H.
by rewrite -a -b -c; arith.
Qed.

(** A component is one edge, or all its cycles have three half-edges or more. *)
Lemma part_bound es r : lists_one_of_each es (same_edge t) (half_edge t) -> r \in pieces t ->
  let V := size (in_part t r (rotations t)) in let E := size (in_part t r es) in
  E + 6 <= 3 * V \/ V = 2 /\ E = 1.
Proof.
move=> Hes rp V E.
have euler : V + size (in_part t r (cycles t)) = E + 2 := part_plane Hes rp.
have He := in_part_each low r (label_edge low) Hes.
have twice := edges_twice low He; rewrite -/E in twice.
have Hc := in_part_each low r (label_cycle low) (cycles_each low).
case: (pickP (fun x : dart t => (labels t (num x) == Some r) && (nx (nx x) == x))) => [x /andP[/eqP xr /eqP xx]|none].
  right; have tx : tw x = nx x.
    by apply: no_parallel; rewrite ?(org_nx map) ?(twK map) // -(org_nx map) xx.
  have only (y : dart t) : labels t (num y) = Some r -> y = x \/ y = tw x.
    move=> yr; apply: (@joined_ind t map (fun y => y = x \/ y = tw x) x y); last by left.
      have nt : nx (tw x) = x by rewrite tx xx.
      have pt : pv (tw x) = x by rewrite tx (nxK map).
      have px : pv x = tw x by rewrite -{1}xx (nxK map) tx.
      by move=> z [->|->]; rewrite ?(twK map) ?nt ?pt ?px -?tx; split; auto.
    by apply/(labelE map); rewrite xr yr.
  have cyc1 : size (in_part t r (cycles t)) = size [:: num x].
    apply: (one_of_each_size _ _ Hc) => [g h /(part_live low) lg /(part_live low) lh|g h k|].
    - exact: cycle_sym.
    - exact: orbit_trans.
    split=> // [h|g h|h /eqP hr]; rewrite ?inE; first by move/eqP->; apply/eqP.
      by move=> /eqP-> /eqP->.
    have [y yh] := dartP (label_live map hr); rewrite -yh in hr *; exists (num x); rewrite ?mem_head //.
    by apply/(on_cycleE map); case: (only y hr) => ->; rewrite ?connect0 // tx fconnect1.
  have edge1 : (size [:: num x]).*2 = E.*2.
    rewrite twice; apply: (edges_twice low); split=> // [h|g h|h /eqP hr]; rewrite ?inE; first by move/eqP->; apply/eqP.
      by move=> /eqP-> /eqP->.
    have [y yh] := dartP (label_live map hr); rewrite -yh in hr *; exists (num x); rewrite ?mem_head //.
    by apply/(same_edge_dart low); case: (only y hr) => ->; [left|right].
  by move: euler edge1; rewrite cyc1 /=; split; arith.
left; suff : 3 * size (in_part t r (cycles t)) <= E.*2 by arith.
case: Hc => u live one _; rewrite twice; set cs := in_part t r (cycles t) in u live one *.
have [cs' cE] : exists cs' : seq (dart t), cs = [seq num x | x <- cs'].
  elim: (cs) live => [|h s IH] H; first by exists [::].
  case: IH => [g gs|s' ->]; first by apply: H; rewrite inE gs orbT.
  have [y <-] := dartP (part_live low (H h (mem_head _ _))); by exists (y :: s').
have u' : uniq cs' by move: u; rewrite cE (map_inj_uniq (@num_inj _ _)).
have inr y : y \in cs' -> labels t (num y) = Some r.
  by move=> ys; apply/eqP; apply: (live (num y)); rewrite cE map_f.
have same y z k : y \in cs' -> z \in cs' -> y = iter k (@nx t) z -> y = z.
  move=> ys zs yz; apply/esym; apply: num_inj; apply: one; rewrite ?cE ?map_f //.
  by apply/(on_cycleE map); rewrite yz fconnect_iter.
have three y : y \in cs' -> nx (nx y) <> y.
  by move=> ys yy; have := none y; rewrite inr // yy !eqxx.
have two y : y \in cs' -> nx y <> y.
  by move=> ys yy; apply: (three y ys); rewrite !yy.
have -> : 3 * size cs = size [seq num x | x <- cs' ++ [seq nx y | y <- cs'] ++ [seq nx (nx y) | y <- cs']].
  by rewrite cE !size_map !size_cat !size_map !mulSn mul0n addn0.
rewrite -size_filter; apply: uniq_leq_size.
  rewrite (map_inj_uniq (@num_inj _ _)) cat_uniq u' cat_uniq (map_inj_uniq (nx_inj map)) u'.
  rewrite (map_inj_uniq (inj_comp (nx_inj map) (nx_inj map))) u' !andbT /=; apply/andP; split.
    apply/hasPn=> y; rewrite mem_cat => /orP[] /mapP[z zs ->]; apply/negP=> ys.
      by apply: (two z zs); apply: (same _ _ 1 ys zs).
    by apply: (three z zs); apply: (same _ _ 2 ys zs).
  apply/hasPn=> y /mapP[z zs ->]; apply/negP=> /mapP[w ws /(nx_inj map)] zw.
  by apply: (two z zs); rewrite zw; apply: (same w z 1 ws zs); rewrite /= zw.
move=> h /mapP[y + ->]; rewrite mem_filter mem_iota add0n half_edge_below ?dart_live // leq0n !andbT.
have step (z : dart t) : labels t (num z) = Some r -> part t r (num (nx z)).
  by move=> zr; have [] := @part_closed _ low r z; [apply/eqP|].
rewrite !mem_cat => /or3P[/inr yr|/mapP[z /inr/step zr ->] //|/mapP[z /inr/step/eqP/step zr ->] //].
exact/eqP.
Qed.

(** Over all components with edges. *)
Lemma pieces_bound es : lists_one_of_each es (same_edge t) (half_edge t) ->
  size es + 5 * size (pieces t) <= 3 * size (rotations t).
Proof.
move=> He; have [_ liveV _ _] := rotations_each low; have [_ liveE _ _] := He.
have each r : r \in pieces t -> size (in_part t r es) + 5 <= 3 * size (in_part t r (rotations t)).
  by move=> rp; have [|[-> ->]] := part_bound He rp; arith.
have := sumn_le each; rewrite sumn_add sumn_const (sum_parts low liveE) -(sum_parts low liveV).
rewrite (_ : sumn [seq 3 * size _ | r <- _] = 3 * sumn [seq size (in_part t r (rotations t)) | r <- pieces t]) //.
by elim: (pieces t) => //= r s ->; arith.
Qed.

(** Without T1 nothing is said of faces. *)
Lemma edges_bound vs es : lists vs (vertex t) -> lists_one_of_each es (same_edge t) (half_edge t) -> 3 <= size vs ->
  size es + 6 <= 3 * size vs.
Proof.
move=> Hv He V3; have sizeV := vertices_size Hv; have sizeR : size (rotations t) = size (with_edges t) by exact: size_map.
have total := pieces_bound He; have [_ liveV _ _] := rotations_each low; have [_ liveE _ _] := He.
have sumV := sum_parts low liveV; have sumE := sum_parts low liveE.
case P: (pieces t) => [|r [|q s]] in sumV sumE total *; rewrite /= in sumV sumE total; [by arith| |by arith].
have rp : r \in pieces t by rewrite P mem_head.
by have [b|[b1 b2]] := part_bound He rp; arith.
Qed.

(** The same of cycles, which are the faces where each face has one. *)
Lemma cycles_bound vs : lists vs (vertex t) -> 3 <= size vs -> size (cycles t) + 4 <= 2 * size vs.
Proof.
move=> Hv V3; have sizeV := vertices_size Hv; have sizeR : size (rotations t) = size (with_edges t) by exact: size_map.
have [es He] := edges_each low; have [_ liveV _ _] := rotations_each low; have [_ liveC _ _] := cycles_each low.
have one r : r \in pieces t -> size (in_part t r (cycles t)) + 4 <= 2 * size (in_part t r (rotations t)) \/
    size (in_part t r (rotations t)) = 2 /\ size (in_part t r (cycles t)) = 1.
  by move=> rp; have := part_plane He rp; case: (part_bound He rp) => [|[]]; [left|right]; arith.
have each r : r \in pieces t -> size (in_part t r (cycles t)) + 3 <= 2 * size (in_part t r (rotations t)).
  by move=> rp; case: (one r rp) => [|[-> ->]]; arith.
have := sumn_le each; rewrite sumn_add sumn_const (sum_parts low liveC).
rewrite (_ : sumn [seq 2 * size _ | r <- _] = 2 * sumn [seq size (in_part t r (rotations t)) | r <- pieces t]); last first.
  by elim: (pieces t) => //= r s ->; arith.
have sumV := sum_parts low liveV; have sumC := sum_parts low liveC; rewrite sumV.
case P: (pieces t) => [|r [|q s]] in sumV sumC *; rewrite /= in sumV sumC *; [by arith| |by arith].
have rp : r \in pieces t by rewrite P mem_head.
by have [b|[b1 b2]] := one r rp; arith.
Qed.

Lemma bounds : t1_outside t -> t4_bounds t.
Proof.
move=> t1 V E F H _ V3; have := H; case=> vs [es [fs [Hv He Hf [VE EE FE]]]].
have [cs Hc] : exists cs, lists_one_of_each cs (connected t) (vertex t).
  pose of_piece r := odflt 0 (origin t r).
  have ofP r : r \in pieces t -> exists2 x : dart t, num x = r & of_piece r = org x /\ labels t (num x) = Some r.
    move=> rp; have rr := (piecesP low r).1 rp; have [x xr] := dartP (label_live map rr).
    by exists x; rewrite // /of_piece -xr (originE map) xr.
  exists ([seq of_piece r | r <- pieces t] ++ isolated_ones t).
  have sep v : v \in [seq of_piece r | r <- pieces t] -> ~ bare t v.
    by case/mapP=> r /ofP[x _ [-> _]] ->; apply: (not_bare low).
  split.
  - rewrite cat_uniq; apply/and3P; split; last by rewrite filter_uniq ?iota_uniq.
      rewrite map_inj_in_uniq ?filter_uniq ?iota_uniq // => r q /ofP[x _ [-> xr]] /ofP[y _ [-> yq]] xy.
      by have /(labelE map) := same_org_joined map (low_v2 low) xy; rewrite xr yq => -[].
    by apply/hasPn=> v /(isolated_onesP low)[_ bv]; apply/negP=> /sep.
  - move=> v; rewrite mem_cat => /orP[/mapP[r /ofP[x _ [-> _]] ->]|/(isolated_onesP low)[] //].
    exact: org_live.
  - move=> v w; rewrite !mem_cat => /orP[/mapP[r /ofP[x _ [rx xr]] ->]|/(isolated_onesP low)[_ bv]]; last first.
      by move=> _ /(connected_bare map (low_v2 low) bv).
    case/orP=> [/mapP[q /ofP[y _ [qy yq]] ->]|/(isolated_onesP low)[_ bw]].
      move=> c; suff -> : r = q by [].
      by move: c; rewrite rx qy => /(label_connected map (low_v2 low)); rewrite xr yq => -[].
    by move/(connected_sym map)/(connected_bare map (low_v2 low) bw).
  move=> v lv; case: (vertexP low lv) => [x _ <-|b _ bv _ _].
    have [r xr rp] := label_piece low x; have [y yr [oy yr']] := ofP r rp; exists (of_piece r).
      by rewrite mem_cat map_f.
    by rewrite oy; apply/(label_connected map (low_v2 low)); rewrite xr.
  exists v; last exact: connected_self.
  by rewrite mem_cat; apply/orP; right; apply/(isolated_onesP low).
have plane := (euler_plane low t1 H Hc).1 t3.
have sizeV := vertices_size Hv; have sizeC := components_size low Hc.
have sizeR : size (rotations t) = size (with_edges t) by exact: size_map.
have [_ liveV _ _] := rotations_each low; have [_ liveE _ _] := He.
have sumV := sum_parts low liveV; have sumE := sum_parts low liveE.
have total := pieces_bound He.
case P: (pieces t) => [|r [|q s]] in sumV sumE sizeC total *; rewrite /= in sumV sumE sizeC total.
- by rewrite -EE in sumE total *; split; arith.
- have rp : r \in pieces t by rewrite P mem_head.
  have [b|[b1 b2]] := part_bound He rp; split; arith.
- by split; arith.
Qed.

End Bounds.
