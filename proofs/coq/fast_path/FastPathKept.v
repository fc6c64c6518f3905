(** * FastPathKept: what keeps R1 to F2 is scanned and walked through without a fault

    The converse of FastPathAccepted.v: no step of the fast path goes wrong before the components are asked for, and its
    figures are those that are compared. *)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import Arith View Rules Loops LoopsProof Reference Map Counting Lists ReferenceProof Genus WholeEuler.
From twinedge Require Import FastPath FastPathAccepted.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section Kept.
Variable t : view.
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

Lemma existing_org (x : dart t) : existing (vertex_slots t) (Some (org x)) = Some (org x).
Proof. by rewrite /= vertex_below ?org_live. Qed.

(** *** The scan *)

Lemma scan_kept h : half_edge t h -> scanned t h.
Proof.
case/dartP=> x <-; rewrite /scanned says_twinE says_nextE !existing_num says_twinE !says_originE says_prevE !dart_live.
by rewrite (twK map) (org_nx map) (nxK map) /= !eqxx (inj_eq (@num_inj _ _)) (tw_neq map).
Qed.

(** *** The walks *)

Lemma around_stepE (x : dart t) : around_step t (num x) = turn t (num x).
Proof.
by rewrite (turnE map) /around_step says_twinE existing_num says_originE existing_org says_nextE existing_num.
Qed.

Lemma along_stepE (x : dart t) : along_step t (bnd x) (num x) = next t (num x).
Proof.
by rewrite (nextE map) /along_step says_nextE existing_num says_boundaryE /= !eqxx.
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
  rewrite dart_live -xb along_trip; congr Some; rewrite (lengthE map).
  by apply/eqP/(orbit_fullP x (bnd_nx low)) => y yx; rewrite -(bndE low) yx.
have [i P] := vertex_inner low S; move: P; rewrite /boundary_place heardE // => ->; congr Some.
rewrite (lengthE map); apply/esym; apply: eq_card0 => x; rewrite !inE; apply/eqP=> xb.
by have [g S' _] := start_bnd low x; move: S; rewrite -xb S'.
Qed.

(** The vertex where a boundary component starts. *)
Lemma vertex_at_kept b : boundary t b -> exists v, [/\ says_vertex_at t b = Some v, vertex_at t b = Some v & vertex t v].
Proof.
move=> lb; rewrite /says_vertex_at -(@heardE _ (boundary t) (says_boundary_start t) b lb) -/(boundary_start t b).
case: (boundaryP low lb) => [x S _|v S lv _ _].
  by rewrite (vertex_at_cycle low S) S dart_live says_originE; exists (org x); split=> //; apply: org_live.
by rewrite (vertex_at_vertex S) S lv; exists v.
Qed.

(** *** What is listed *)

Lemma entry_listed e : e \in entries t -> exists2 b, says_listed t e = Some b & listed t e.1 e.2 = Some b.
Proof.
case: e => f p e; rewrite -(listedE e) /=; have [lf] := (entriesP t f p).1 e; case: p {e} => [|i] /= H.
  by move: H; rewrite /outer heardE // /has_outer; case: (says_outer t f) => [b|] // _; exists b.
have lt : i < inner_count t f by rewrite /inner_count lf.
by have [_ _ _ /(_ f lf)[_ /(_ i lt)[b E _]]] := low_r1 low; exists b.
Qed.

Lemma entry_kept e : e \in entries t -> entry_ok t e.
Proof.
case/entry_listed=> b; rewrite /entry_ok => -> L; have lb := listed_live low L; have [Ef Ep] := listed_names low L.
have [v [Ev _ lv]] := vertex_at_kept lb; rewrite /boundary_face heardE // in Ef; rewrite /boundary_place heardE // in Ep.
apply/and5P; split=> //; [exact/same_linkP|exact/same_placeP| |by rewrite along_kept].
by rewrite /enters Ev; case: (e.2) => [|i] //=; rewrite vertex_below.
Qed.

Lemma listed_kept : perm_eq (listed_ones t) (boundary_ones t).
Proof.
apply: uniq_perm; last 1 first.
- move=> b; rewrite boundary_onesP; apply/mapP/idP => [[e /entry_listed[c E L] ->]|lb].
    by rewrite E; apply: listed_live L.
  have [f [p [_ _ _ L]]] := placeP low lb; have e := listed_entry L; exists (f, p) => //.
  by rewrite -(listedE e) L.
- rewrite map_inj_in_uniq ?entries_uniq // => -[f p] [g q] /entry_listed[b E L] /entry_listed[c E' L'].
  rewrite E E' /= => bc; rewrite -bc in L'; have [Ef Ep] := listed_names low L; have [] := listed_names low L'.
  by rewrite Ef Ep /= => -[->] [->].
exact: ones_uniq.
Qed.

Lemma once_kept : listed_once t.
Proof.
apply/andP; split; first by rewrite (perm_uniq listed_kept) ones_uniq.
by rewrite -(perm_size listed_kept) size_map.
Qed.

(** *** The figures *)

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
apply/and4P; split; apply/eqP.
- rewrite (perm_sumn (perm_map _ listed_kept)).
  have -> : [seq odflt 0 (along t b) | b <- boundary_ones t] = [seq read (lengths t) b | b <- boundary_ones t].
    by apply/eq_in_map => b; rewrite boundary_onesP => /along_kept ->.
  apply: sum_tally => [h /dartP[x <-]|h v E]; last exact: heard_live E.
  by exists (bnd x); [apply: boundaryE | rewrite -/(boundary_ones t) boundary_onesP; apply: bnd_live].
- have -> : [seq odflt 0 (around t v) | v <- vertex_ones t] = [seq read (degrees t) v | v <- vertex_ones t].
    by apply/eq_in_map => v; rewrite vertex_onesP => /around_kept ->.
  apply: sum_tally => [h /dartP[x <-]|h v E]; last exact: heard_live E.
  by exists (org x); [apply: originE | rewrite -/(vertex_ones t) vertex_onesP; apply: org_live].
- rewrite (permP listed_kept) -!size_filter; apply: (@rel_size _ _ (fun b v => starts_at_vertex t v b)).
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
rewrite -(count_predC (has_outer t)); congr (_ + _); rewrite /face_ones /live_ones count_filter.
apply/eqP/count1P => [f /andP[_]|]; first exact: face_below.
have [[f [[lf E] one]] _] := low_f1 low; exists f; split.
  by rewrite /= lf andbT /has_outer; move: E; rewrite /outer heardE // => ->.
move=> g /andP[/= n lg]; apply: one; split=> //; rewrite /outer heardE //.
by move: n; rewrite /has_outer; case: (says_outer t g).
Qed.

(** *** The neighbours *)

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

End Kept.
