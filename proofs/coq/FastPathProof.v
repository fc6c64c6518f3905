(** * FastPathProof: the fast path accepts exactly the views that keep R1 to T1 *)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import Arith View Rules Loops LoopsProof Reference Map Counting Lists ReferenceProof Genus WholeEuler.
From twinedge Require Import FastPath FastPathAccepted.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section FastPathProof.
Variable t : view.

(** ** What keeps R1 to F2 is walked through without a fault *)

Section Kept.
Hypothesis low : lower t.

Let map := low_map low.

Lemma says_leavingE v (x : dart t) : leaving t v = Some (num x) -> says_leaving t v = Some (num x).
Proof. by move=> E; rewrite -E /leaving heardE //; apply: heard_live E. Qed.

Lemma says_twinE (x : dart t) : says_twin t (num x) = Some (num (tw x)).
Proof. by rewrite -(twinE map) /twin heardE ?dart_live. Qed.
Lemma says_nextE (x : dart t) : says_next t (num x) = Some (num (nx x)).
Proof. by rewrite -(nextE map) /next heardE ?dart_live. Qed.
Lemma says_prevE (x : dart t) : says_prev t (num x) = Some (num (pv x)).
Proof. by rewrite -(prevE map) /prev heardE ?dart_live. Qed.
Lemma says_originE (x : dart t) : says_origin t (num x) = Some (org x).
Proof. by rewrite -(originE map) /origin heardE ?dart_live. Qed.
Lemma says_boundaryE (x : dart t) : says_boundary t (num x) = Some (bnd x).
Proof. by rewrite -(boundaryE map) /boundary_of heardE ?dart_live. Qed.

Lemma existing_num (x : dart t) : existing (half_edge_slots t) (Some (num x)) = Some (num x).
Proof. by rewrite /= half_edge_below ?dart_live. Qed.

Lemma around_stepE (x : dart t) : around_step t (num x) = turn t (num x).
Proof.
rewrite (turnE map) /around_step says_twinE existing_num says_originE org_live // says_nextE existing_num.
by [].
Qed.

Lemma along_stepE (x : dart t) : along_step t (bnd x) (num x) = next t (num x).
Proof.
rewrite (nextE map) /along_step says_twinE says_nextE !existing_num !dart_live says_boundaryE says_twinE says_prevE !says_originE.
rewrite (twK map) (nxK map) (org_nx map) /= !eqxx (inj_eq (@num_inj _ _)).
by rewrite (tw_neq map).
Qed.

Lemma around_trip (x : dart t) : round_trip (half_edge_slots t) (around_step t) (num x) = Some (order (@tn t) x).
Proof.
rewrite -(@round_trip_eq _ (turn t)) => [|y on].
  have inj : injective (step (turn t) : dart t -> dart t).
    by move=> y z; rewrite !(step_turn map) => /(tn_inj map).
  rewrite (round_tripE (@half_edge_below t) (turn_total map) inj); congr Some.
  by apply: eq_card => y; rewrite !inE; apply: eq_fconnect; apply: step_turn.
have/dartP[z <-] := on_orbit_live (@half_edge_below t) (turn_total map) on.
by rewrite around_stepE.
Qed.

Lemma along_trip (x : dart t) : round_trip (half_edge_slots t) (along_step t (bnd x)) (num x) = Some (order (@nx t) x).
Proof.
rewrite -(@round_trip_eq _ (next t)) => [|y on].
  exact: (round_tripE (@half_edge_below t) (next_total map) (nx_inj map)).
have/dartP[z zy] := on_orbit_live (@half_edge_below t) (next_total map) on; rewrite -zy in on *.
have/(on_cycleE map)/(cycle_bnd low)-> := on; by rewrite along_stepE.
Qed.

Lemma around_kept v : vertex t v -> around t v = Some (read (degrees t) v).
Proof.
move=> lv; rewrite /around; case: (vertexP low lv) => [x L xv|b L bv I S].
  rewrite (says_leavingE L) dart_live says_originE xv /= eqxx.
  have -> : says_isolated t v = None.
    have [_ H] := low_b2 low lv; have nb : ~ bare t v by rewrite -xv; apply: not_bare.
    by have [+ _] := H nb; rewrite /isolated heardE.
  rewrite around_trip; congr Some; rewrite (degreeE map) -xv; apply/eqP/(orbit_fullP x (org_tn map)) => y yx.
  by rewrite (rotationE map (low_v2 low)) yx.
have -> : says_leaving t v = None by move: L; rewrite /leaving heardE.
have -> : read (degrees t) v = 0 by apply/eqP/degree0P.
move: I S; rewrite /isolated heardE // /starts_at_vertex => I S; have lb := heard_live S.
by rewrite /names_its_boundary I lb; move: S; rewrite /boundary_start heardE // => -> /=; rewrite eqxx.
Qed.

Lemma along_kept b : boundary t b -> along t b = Some (read (lengths t) b).
Proof.
move=> lb; rewrite /along -(@heardE _ (boundary t) (says_boundary_start t) b lb) -/(boundary_start t b).
case: (boundaryP low lb) => [x S xb|v S lv bv I]; rewrite S.
  rewrite half_edge_below ?dart_live // -xb along_trip; congr Some; rewrite (lengthE map).
  by apply/eqP/(orbit_fullP x (bnd_nx low)) => y yx; rewrite -(bndE low) yx.
have [i P] := vertex_inner low S; move: P; rewrite /boundary_place heardE // => ->; congr Some.
rewrite (lengthE map); apply/esym; apply: eq_card0 => x; rewrite !inE; apply/eqP=> xb.
by have [g S' _] := start_bnd low x; move: S; rewrite -xb S'.
Qed.

Lemma stands_kept b : boundary t b -> stands_there t b.
Proof.
move=> lb; have [f [p [lf Ef Ep L]]] := placeP low lb; move: Ef Ep.
by rewrite /boundary_face /boundary_place !heardE // /stands_there => -> ->; rewrite lf L /= eqxx.
Qed.

Lemma sum_tally n live (key : nat -> link) : (forall h, half_edge t h -> exists2 v, key h = Some v & v \in live_ones n live) ->
  (forall h v, key h = Some v -> half_edge t h) ->
  sumn [seq read (tally (half_edge_slots t) key) v | v <- live_ones n live] = size (half_edge_ones t).
Proof.
move=> tot dom; rewrite -(@sumn_parts _ (live_ones n live) key) ?ones_uniq //; last first.
  by move=> h; rewrite half_edge_onesP => /tot.
congr sumn; apply: eq_map => v; rewrite tallyE size_filter /half_edge_ones /live_ones count_filter.
by apply: eq_count => h /=; case: eqP => // /dom ->.
Qed.

Lemma complete_kept : complete t.
Proof.
apply/and5P; split; apply/eqP.
- have -> : [seq odflt 0 (around t v) | v <- vertex_ones t] = [seq read (degrees t) v | v <- vertex_ones t].
    by apply/eq_in_map => v; rewrite vertex_onesP => /around_kept ->.
  apply: sum_tally => [h /dartP[x <-]|h v E]; last exact: heard_live E.
  by exists (org x); [apply: originE | rewrite -/(vertex_ones t) vertex_onesP; apply: org_live].
- have -> : [seq odflt 0 (along t b) | b <- boundary_ones t] = [seq read (lengths t) b | b <- boundary_ones t].
    by apply/eq_in_map => b; rewrite boundary_onesP => /along_kept ->.
  apply: sum_tally => [h /dartP[x <-]|h v E]; last exact: heard_live E.
  by exists (bnd x); [apply: boundaryE | rewrite -/(boundary_ones t) boundary_onesP; apply: bnd_live].
- rewrite -!size_filter; apply: (@rel_size _ _ (fun b v => starts_at_vertex t v b)).
  + by apply: filter_uniq; apply: ones_uniq.
  + by apply: filter_uniq; apply: ones_uniq.
  + move=> b; rewrite mem_filter boundary_onesP => /andP[c lb]; case: (boundaryP low lb) => [x S _|v S lv bv _].
      by move: c; rewrite /is_at_vertex; move: S; rewrite /boundary_start heardE // => ->.
    exists v => //; rewrite mem_filter vertex_onesP lv andbT /is_isolated.
    by case: (vertexP low lv) => [x _ xv|d + _ _ _]; [case: (not_bare low (x := x)); rewrite xv | rewrite /leaving heardE // => ->].
  + move=> v; rewrite mem_filter vertex_onesP => /andP[i lv]; case: (vertexP low lv) => [x L _|b _ _ _ S].
      by move: i; rewrite /is_isolated (says_leavingE L).
    have lb := heard_live S; exists b => //; rewrite mem_filter boundary_onesP lb andbT /is_at_vertex.
    by move: S; rewrite /starts_at_vertex /boundary_start heardE // => ->.
  + move=> b c v _; rewrite mem_filter boundary_onesP => /andP[_ lc] Sb Sc.
    case: (boundaryP low lc) => [x S|w S lw _ I]; first by move: Sc; rewrite /starts_at_vertex S.
    move: Sc; rewrite /starts_at_vertex S => -[wv]; rewrite -wv in Sb.
    exact: (bare_unique low lw I Sb).
  by move=> b v w _ _; rewrite /starts_at_vertex => -> -[].
- rewrite -(size_places t) -(size_map (named t)); apply: perm_size; apply: uniq_perm; first exact: places_uniq.
    rewrite map_inj_in_uniq ?ones_uniq // => b c; rewrite !boundary_onesP => lb lc.
    have [f [p [_ Ef Ep L]]] := placeP low lb; have [g [q [_ Eg Eq L']]] := placeP low lc.
    move: Ef Ep Eg Eq; rewrite /boundary_face /boundary_place !heardE // /named => -> -> -> -> [fg /(can_inj codeK) pq].
    by move: L; rewrite fg pq L' => -[].
  move=> [f c]; apply/idP/mapP => [/placesP[lf H]|[b]].
    have [b L] : exists b, listed t f (uncode c) = Some b.
      case: c H => [i lt|H] /=.
        have lt' : i < inner_count t f by rewrite /inner_count lf.
        by have [_ _ _ /(_ f lf)[_ /(_ i lt')[b E _]]] := low_r1 low; exists b.
      by move: H; rewrite /outer heardE // /has_outer; case: (says_outer t f) => [b|] // _; exists b.
    have lb := listed_live low L; have [Ef Ep] := listed_names low L; exists b; first by rewrite boundary_onesP.
    move: Ef Ep; rewrite /boundary_face /boundary_place !heardE // /named => -> -> /=.
    by case: c {H L}.
  rewrite boundary_onesP => lb; have [g [q [_ Eg Eq L]]] := placeP low lb.
  move: Eg Eq; rewrite /boundary_face /boundary_place !heardE // /named => -> -> -> /=.
  exact: listed_place L.
rewrite -(count_predC (has_outer t)); congr (_ + _); rewrite /face_ones /live_ones count_filter.
apply/eqP/count1P => [f /andP[_]|]; first exact: face_below.
have [[f [[lf E] one]] _] := low_f1 low; exists f; split.
  by rewrite /= lf andbT /has_outer; move: E; rewrite /outer heardE // => ->.
move=> g /andP[/= n lg]; apply: one; split=> //; rewrite /outer heardE //.
by move: n; rewrite /has_outer; case: (says_outer t g).
Qed.

(** *** T1 *)

Lemma neighboursP v u : u \in neighbours t v <-> exists x : dart t, org x = v /\ org (tw x) = u.
Proof.
rewrite /neighbours; case L: (leaving t v) => [l|]; last first.
  split=> // -[x [xv _]]; have [y E _] := kept_org low x.
  by move: L; rewrite -xv E.
have lv := heard_live L; case: (vertexP low lv) => [x Ex xv|b]; last by rewrite L.
move: Ex; rewrite L => -[lx]; rewrite lx in L *.
have E := around_kept lv; have trip : round_trip (half_edge_slots t) (around_step t) (num x) = Some (read (degrees t) v).
  by move: E; rewrite /around (says_leavingE L); case: ifP.
have [x0 _ fwd back] := round_tripP trip; rewrite E /=.
have same h : on_orbit (around_step t) (num x) h -> on_orbit (turn t) (num x) h.
  case=> k; elim: k h => [|k IH] h /=; first by case=> <-; exists 0.
  case Eg: (iter k _ _) => [g|] //= st; have [j gj] := IH g Eg.
  have /dartP[z zg] : half_edge t g by apply: (on_orbit_live (@half_edge_below t) (turn_total map) (x := x)); exists j.
  by exists j.+1; rewrite iterS gj /= -zg -around_stepE zg.
have inn (y : dart t) : num y \in traject (fun h => odflt 0 (around_step t h)) (num x) (read (degrees t) v) <-> org y = v.
  split=> [/back[_ on]|yv].
    have {}on : fconnect (@tn t) x y by apply/(on_rotationE map)/same.
    by have := rotationE map (low_v2 low) x y; rewrite on xv => /esym/eqP.
  have : fconnect (@tn t) x y by rewrite (rotationE map (low_v2 low)) xv yv.
  move/iter_findex <-; elim: (findex _ _ _) => //= k IH; have [z] := fwd _ IH.
  by rewrite around_stepE (turnE map) => -[<-].
split=> [/mapP[h hs ->]|[y [yv <-]]].
  have [y yh] : exists y : dart t, num y = h.
    have [_ /same on] := back h hs.
    exact: dartP (on_orbit_live (@half_edge_below t) (turn_total map) on).
  exists y; rewrite -yh in hs *; split; first exact/inn.
  by rewrite says_twinE /= says_originE.
apply/mapP; exists (num y); first exact/inn.
by rewrite says_twinE /= says_originE.
Qed.

Lemma neighbours_live v u : vertex t v -> u \in neighbours t v -> vertex t u.
Proof. by move=> _ /neighboursP[x [_ <-]]; apply: org_live. Qed.

Lemma neighbours_sym v u : vertex t v -> u \in neighbours t v -> v \in neighbours t u.
Proof. by move=> _ /neighboursP[x [xv xu]]; apply/neighboursP; exists (tw x); rewrite (twK map). Qed.

Lemma neighbours_enough : sumn [seq size (neighbours t v) | v <- iota 0 (vertex_slots t)] + 1 < (half_edge_slots t).+2.
Proof.
have [/eqP total _ _ _ _] := and5P complete_kept.
have le : sumn [seq size (neighbours t v) | v <- iota 0 (vertex_slots t)] <= sumn [seq odflt 0 (around t v) | v <- vertex_ones t].
  rewrite /vertex_ones /live_ones; elim: (iota _ _) => //= v s IH.
  case lv: (vertex t v) => /=; last by rewrite /neighbours /leaving /heard lv.
  apply: leq_add => //; rewrite /neighbours; case: (leaving t v) => // l; by rewrite size_map size_traject.
have le' : size (half_edge_ones t) <= half_edge_slots t.
  by rewrite /half_edge_ones /live_ones size_filter -[X in _ <= X](size_iota 0); apply: count_size.
by arith.
Qed.

Lemma reached_connected v u : vertex t v -> reached (neighbours t) v u <-> connected t v u.
Proof.
move=> lv; split.
  elim=> [|w x _ vw /neighboursP[y [yw <-]]]; first exact: connected_self.
  by apply: connected_trans vw _; rewrite -yw; apply: connected_step.
elim=> [|h w x _ IH /(originP map)[y yh yw]]; first exact: reached_self.
rewrite -yh (targetE map) => -[<-]; apply: reached_near IH _.
by apply/neighboursP; exists y.
Qed.

Lemma componentE v u : vertex t v -> vertex t u -> component t v = component t u <-> connected t v u.
Proof.
move=> lv lu; rewrite -(reached_connected u lv).
exact: (flood_allE (@vertex_below t) neighbours_live neighbours_sym neighbours_enough lv lu).
Qed.

Lemma component_total v : vertex t v -> exists r, component t v = Some r.
Proof. exact: (flood_all_live (@vertex_below t) neighbours_live neighbours_sym neighbours_enough). Qed.

Lemma vertex_at_kept b : boundary t b -> exists v, [/\ says_vertex_at t b = Some v, vertex_at t b = Some v & vertex t v].
Proof.
move=> lb; rewrite /says_vertex_at -(@heardE _ (boundary t) (says_boundary_start t) b lb) -/(boundary_start t b).
case: (boundaryP low lb) => [x S _|v S lv _ _].
  by rewrite (vertex_at_cycle low S) S says_originE; exists (org x); split=> //; apply: org_live.
by rewrite (vertex_at_vertex S) S; exists v.
Qed.

Lemma outside_componentE v b : vertex t v -> boundary t b ->
  outside_component t b = component t v <-> outside_of t v b.
Proof.
move=> lv lb; have [w [Ew Ew' lw]] := vertex_at_kept lb; have [r vr] := component_total lv.
rewrite /outside_component Ew -(@heardE _ (boundary t) (says_boundary_place t) b lb) -/(boundary_place t b).
split=> [|[[i ->] [u]]].
  case P: (boundary_place t b) => [[|i]|]; rewrite ?vr //= -vr => E; split; first by exists i.
  by exists w => //; apply/componentE.
by rewrite Ew' => -[<-] vw; apply/esym/componentE.
Qed.

Lemma one_outside_kept : one_outside_each t <-> t1_outside t.
Proof.
have count1 v : vertex t v ->
    reflect (exists! b, outside_of t v b) (count (fun b => outside_component t b == component t v) (boundary_ones t) == 1).
  move=> lv; rewrite /boundary_ones /live_ones count_filter.
  have P b : predI (fun b => outside_component t b == component t v) (boundary t) b <-> outside_of t v b.
    split=> [/andP[/= /eqP E lb]|o]; first exact/outside_componentE.
    have lb : boundary t b by case: (o) => -[i E] _; apply: heard_live E.
    by rewrite /= lb andbT; apply/eqP/outside_componentE.
  apply: (iffP (count1P _)) => [b /andP[_]|[b [/P o u]]|[b [/P o u]]]; first exact: boundary_below.
    by exists b; split=> // c /P/u.
  by exists b; split=> // c /P/u.
split=> [/andP[_ /allP H] v lv|t1].
  by apply/count1 => //; apply: H; rewrite vertex_onesP.
apply/andP; split; apply/allP => i.
  rewrite boundary_onesP => lb; have [w [-> _ lw]] := vertex_at_kept lb => /=.
  by have [r E] := component_total lw; rewrite /read E.
by rewrite vertex_onesP => lv; apply/count1 => //; apply: t1.
Qed.

End Kept.

(** ** The fast path accepts a view if and only if R1 to T1 hold *)

Theorem fast_path_accepts : fast_path t <-> holds_before t T2.
Proof.
split=> [/and4P[/allP A /allP B counts ones]|H].
  have low : lower t.
    apply: accepted_lower => // [v lv|b lb].
      by have := A v; rewrite vertex_onesP => /(_ lv); case: (around t v) => [k|] // _; exists k.
    have := B b; rewrite boundary_onesP => /(_ lb)/andP[+ ->]; case: (along t b) => [k|] // _; split=> //; by exists k.
  have t1 := (one_outside_kept low).1 ones.
  move=> r; rewrite ltnS leq_eqVlt => /orP[/eqP E|/low //].
  by case: r E.
have low : lower t by move=> q lt; apply: H; apply: leq_trans lt _.
apply/and4P; split.
- by apply/allP=> v; rewrite vertex_onesP => lv; rewrite around_kept.
- by apply/allP=> b; rewrite boundary_onesP => lb; rewrite along_kept // stands_kept.
- exact: complete_kept.
by apply/(one_outside_kept low); apply: (H T1).
Qed.

End FastPathProof.
