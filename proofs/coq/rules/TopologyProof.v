(** * TopologyProof: the checker's verdicts on T1, T2 and T3 are right
    (rules/outside.rs, nesting.rs and euler.rs) *)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import Arith View Rules Loops LoopsProof Reference Map Counting Lists ReferenceProof.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section Topology.
Variable t : view.
Hypothesis low : lower t.

Let map := low_map low.

(** ** T1 *)

Lemma outside_labelP (x : dart t) r b : labels t (num x) = Some r ->
  outside_label t (labels t) b = Some r <-> outside_of t (org x) b.
Proof.
move=> xr; rewrite (outside_dart low) /outside_label /label_at; split.
  case P: (boundary_place t b) => [[|i]|] //; case S: (boundary_start t b) => [[h|]|] // hr.
  split; first by exists i.
  have [y yh] := dartP (label_live map hr); exists y; first by rewrite yh.
  by apply/(labelE map); rewrite xr yh.
by case=> -[i ->] [y ->] /(labelE map); rewrite xr => ->.
Qed.

Lemma outside_label_below r b : outside_label t (labels t) b == Some r -> b < boundary_slots t.
Proof.
rewrite /outside_label; case P: (boundary_place t b) => [[|i]|] // _.
by apply: boundary_below; apply: heard_live P.
Qed.

Lemma check_t1P : reflect (t1_outside t) (check_t1 t (labels t)).
Proof.
have one (x : dart t) r : labels t (num x) = Some r ->
    reflect (exists! b, outside_of t (org x) b)
      (read (tally (boundary_slots t) (outside_label t (labels t))) r == 1).
  move=> xr; rewrite tallyE; apply: (iffP (count1P _)) => [b /outside_label_below //|[b [o u]]|[b [o u]]].
    exists b; split; first by apply/(outside_labelP _ xr)/eqP.
    by move=> c /(outside_labelP _ xr)/eqP/u.
  exists b; split; first by apply/eqP/(outside_labelP _ xr).
  by move=> c /eqP/(outside_labelP _ xr)/u.
apply: (iffP (each_half_edgeP _ _)) => [H v lv|H h /dartP[x <-]].
  case: (vertexP low lv) => [x _ <-|b _ bv I _].
    have [r xr] := label_total map x; have := H _ (dart_live x); rewrite /read in one *; rewrite xr.
    by move/(one x r xr).
  by exists b; split=> [|c]; rewrite (outside_bare low) // I => -[].
have [r xr] := label_total map x; rewrite /read in one *; rewrite xr; apply/(one x r xr).
exact: H _ (org_live map x).
Qed.

(** ** T2 *)

Section Nesting.
Hypothesis t1 : t1_outside t.

Definition lies_in := recall (boundary_slots t) (outside_label t (labels t)) (boundary_face t).
Notation up := (outwards t (labels t) lies_in).

Lemma lies_inE (x : dart t) r b : labels t (num x) = Some r -> outside_of t (org x) b ->
  read lies_in r = boundary_face t b.
Proof.
move=> xr o; have := recallP (boundary_slots t) (outside_label t (labels t)) (boundary_face t) r.
case: ifP => [_ [c [_ /(outside_labelP _ xr) o' ->]]|/negP none _].
  by have [d [_ u]] := t1 (org_live map x); rewrite -(u b o) -(u c o').
case: none; apply/hasP; exists b; last by apply/eqP/(outside_labelP _ xr).
by rewrite mem_iota add0n /=; apply: outside_label_below; apply/eqP/(outside_labelP _ xr).
Qed.

Lemma outside_face v b : outside_of t v b -> exists2 f, boundary_face t b = Some f & face t f.
Proof. by case=> -[i P] _; have [f [p [lf Ef _ _]]] := placeP low (heard_live P); exists f. Qed.

(** One step outwards, as rule T2 says it. *)
Lemma upP f : face t f -> outer t f = None /\ up f = None \/
  exists b w b' f', [/\ outer t f = Some b, vertex_at t b = Some w, outside_of t w b', boundary_face t b' = Some f'
    & up f = Some f' /\ face t f'].
Proof.
move=> lf; rewrite /outwards; case: (faceP low lf) => [->|x E S]; [by left | right].
have [r xr] := label_total map x; have [b' [o _]] := t1 (org_live map x).
have [f' Ef lf'] := outside_face o; exists (bnd x), (org x), b', f'; split=> //.
  exact: vertex_at_cycle.
by have L := lies_inE xr o; rewrite /read in L; rewrite E /= /label_at S /= /read xr /= L.
Qed.

Lemma rooted_climbs f : face t f -> rooted t f <-> climbs up f.
Proof.
move=> lf; split=> [H|H].
  elim: H lf => {f} [f [_ E] _|f b w b' f' E W o Ef _ IH lf].
    by apply: climbs_top; rewrite /outwards E.
  case: (upP lf) => [[]|[c [u [c' [g [E' U o' Eg [up lg]]]]]]]; first by rewrite E.
  move: E'; rewrite E => -[bc]; move: U; rewrite -bc W => -[wu]; rewrite -wu in o'.
  have lw : vertex t w.
    move: W; rewrite /vertex_at; case S: (boundary_start t b) => [[h|v]|] //.
      by case/(originP map)=> x _ <-; apply: org_live.
    by move=> -[<-]; have [_ _ B _] := low_r1 low; have [_] := B b (heard_live S); rewrite S.
  have [d [_ one]] := t1 lw; move: Eg; rewrite -(one _ o') (one _ o) Ef => -[fg].
  by apply: climbs_up up _; rewrite -fg in lg *; apply: IH.
elim: H lf => {f} [f E lf|f g E _ IH lf].
  by apply: rooted_here; split=> //; case: (upP lf) => [[]|[b [w [b' [f' [_ _ _ _ []]]]]]] //; rewrite E.
case: (upP lf) => [[_]|[b [w [b' [f' [O W o Ef [up lf']]]]]]]; first by rewrite E.
by move: E; rewrite up => -[fg]; apply: rooted_out O W o Ef _; rewrite fg in lf' *; apply: IH.
Qed.

(** Every face is rooted, as it is unbounded or its component lies in a face. *)
Lemma face_rooted : t2_nesting t -> forall f, face t f -> rooted t f.
Proof.
move=> t2 f lf; case: (faceP low lf) => [E|x E S]; first exact: rooted_here.
have [b' [o _]] := t1 (org_live map x); have [f' Ef _] := outside_face o.
exact: (rooted_out E (vertex_at_cycle low S) o Ef (t2 _ _ _ (org_live map x) o Ef)).
Qed.

(** A boundary component of a rooted face lies in a rooted face. *)
Lemma rooted_from f b w : rooted t f -> outer t f = Some b -> vertex_at t b = Some w ->
  exists c g, [/\ outside_of t w c, boundary_face t c = Some g & rooted t g].
Proof.
by case=> {f} [f [_ ->]|f b' w' c g -> W O Ec R] // [<-]; rewrite W => -[<-]; exists c, g.
Qed.

(** No component lies in a face that it bounds. *)
Lemma not_in_itself f b w c : rooted t f -> outer t f = Some b -> vertex_at t b = Some w -> vertex t w ->
  outside_of t w c -> boundary_face t c <> Some f.
Proof.
elim=> {f} [f [_ E]|f b' w' c' f' E W O Ef _ IH]; first by rewrite E.
move=> Eb Wb lw Oc; move: E; rewrite Eb => -[bb]; move: W; rewrite -bb Wb => -[ww]; rewrite -ww in O.
have [d [_ one]] := t1 lw; rewrite -(one c' O) (one c Oc) in Ef.
by move=> Fc; move: (Fc); rewrite Ef => -[ff]; rewrite ff in IH; apply: IH Eb Wb lw Oc Fc.
Qed.

Lemma check_t2P : reflect (t2_nesting t) (check_t2 t (labels t)).
Proof.
have up_live f g : face t f -> up f = Some g -> face t g.
  by move=> lf; case: (upP lf) => [[_ ->]|[b [w [b' [f' [_ _ _ _ [-> l]]]]]]] // -[<-].
apply: (iffP (all_climbP (@face_below t) up_live _)) => H.
  move=> v b f lv o Ef; have [g Eg lg] := outside_face o; move: Ef; rewrite Eg => -[<-].
  by apply/rooted_climbs => //; apply: H => //; apply: face_below.
by move=> f _ lf; apply/rooted_climbs => //; apply: face_rooted.
Qed.

End Nesting.

(** ** T3 *)

Lemma same_edge_dart (x y : dart t) : same_edge t (num x) (num y) <-> x = y \/ tw x = y.
Proof.
rewrite /same_edge (twinE map); split=> [[/num_inj|[/num_inj]]|[->|->]]; by [left|right].
Qed.

(** There are twice as many half-edges as edges. *)
Lemma edges_half n (p : pred nat) (P : nat -> Prop) es :
  (forall h, p h -> h < n) -> (forall h, p h <-> P h) -> (forall h, P h -> half_edge t h) ->
  (forall x : dart t, P (num x) -> P (num (tw x))) ->
  lists_one_of_each es (same_edge t) P -> count p (iota 0 n) = (size es).*2.
Proof.
move=> lt pP live twP [u esP one all].
pose twn h := odflt 0 (twin t h).
have twnE (x : dart t) : twn (num x) = num (tw x) by rewrite /twn (twinE map).
have dart_of h : h \in es -> exists2 x : dart t, num x = h & P (num x).
  by move=> /esP Ph; have [x xh] := dartP (live _ Ph); exists x; rewrite ?xh.
rewrite -addnn -{2}(size_map twn) -size_cat; apply/esym.
apply: (@lists_count n p _ P) => //; split.
  rewrite cat_uniq u /= map_inj_in_uniq ?u ?andbT.
    apply/hasPn=> h /mapP[g ge ->]; apply/negP=> he.
    have [x xg _] := dart_of g ge; rewrite -xg twnE in he.
    have E : num (tw x) = num x.
      by apply: (one _ _ he); rewrite ?xg //; rewrite -xg; apply/same_edge_dart; right; apply: (twK map).
    by move/num_inj/eqP: E; rewrite (negPf (tw_neq map x)).
  move=> g h /dart_of[x <- _] /dart_of[y <- _]; rewrite !twnE => /num_inj/(tw_inj map) -> //.
move=> h; rewrite mem_cat; split.
  case/orP=> [/esP //|/mapP[g /dart_of[x <- Px] ->]]; rewrite twnE; exact: twP.
move=> Ph; have [x xh] := dartP (live _ Ph); rewrite -xh in Ph *.
have [g ge] := all _ Ph; have [y yg _] := dart_of g ge; rewrite -yg; case/same_edge_dart=> <-.
  by rewrite yg ge.
by apply/orP; right; apply/mapP; exists (num y); rewrite ?yg // -yg twnE.
Qed.

(** One half-edge of each edge: that with the lower number. *)
Lemma edges_exist n (p : pred nat) (P : nat -> Prop) :
  (forall h, p h -> h < n) -> (forall h, p h <-> P h) -> (forall h, P h -> half_edge t h) ->
  (forall x : dart t, P (num x) -> P (num (tw x))) ->
  exists es, lists_one_of_each es (same_edge t) P.
Proof.
move=> lt pP live twP; exists [seq h <- iota 0 n | p h && (h < odflt 0 (twin t h))].
have mem h : (h \in [seq h <- iota 0 n | p h && (h < odflt 0 (twin t h))]) = p h && (h < odflt 0 (twin t h)).
  by rewrite mem_filter mem_iota add0n; case: (p h) (lt h) => //= ->; rewrite ?andbT.
split; first by rewrite filter_uniq ?iota_uniq.
- by move=> h; rewrite mem => /andP[/pP].
- move=> g h; rewrite !mem => /andP[/pP/live/dartP[x <-] lx] /andP[/pP/live/dartP[y <-] ly].
  case/same_edge_dart=> [-> //|xy]; move: lx ly; rewrite !(twinE map) /= -xy (twK map) => a b.
  by have := ltn_trans a b; rewrite ltnn.
move=> h Ph; have [x xh] := dartP (live _ Ph); rewrite -xh in Ph *.
case: (ltngtP (num x) (num (tw x))) => [l|l|/num_inj/esym/eqP].
- by exists (num x); [rewrite mem (twinE map) l andbT; apply/pP | left].
- exists (num (tw x)); last by right; rewrite (twinE map) (twK map).
  by rewrite mem (twinE map) /= (twK map) l andbT; apply/pP; apply: twP.
by rewrite (negPf (tw_neq map x)).
Qed.

(** The counts of the component with the label [r]. *)
Definition vertices_of := tally (vertex_slots t) (fun v => leaving t v >>= read (labels t)).
Definition half_edges_of := tally (half_edge_slots t) (fun h => if half_edge t h then read (labels t) h else None).
Definition cycles_of := tally (boundary_slots t) (label_at t (labels t)).

Section Component.
Variables (x : dart t) (r : nat).
Hypothesis xr : labels t (num x) = Some r.

Lemma leaving_label v : (leaving t v >>= read (labels t) == Some r) <-> connected t (org x) v.
Proof.
have leavingE w l : leaving t w = Some l -> exists2 y : dart t, num y = l & org y = w.
  by move=> E; apply/(originP map); apply: (low_v1 low _ E); apply: heard_live E.
split=> [|c].
  case E: (leaving t v) => [l|] //= /eqP lr; have [y yl <-] := leavingE v l E.
  by apply/(label_connected map (low_v2 low)); rewrite xr yl.
have [y yv] : exists y : dart t, org y = v.
  by case: (connected_dart map (low_v2 low) c) => [<-|[_ [y [_ <- _]]]]; [exists x|exists y].
have lv : vertex t v by rewrite -yv; apply: org_live.
case: (vertexP low lv) => [z E zv|b _ bv _ _]; last by case: (@not_bare _ low y); rewrite yv.
by rewrite E /=; apply/eqP; rewrite -xr; apply/(label_connected map (low_v2 low)); rewrite zv; apply: connected_sym.
Qed.

Lemma half_edge_label h :
  ((if half_edge t h then read (labels t) h else None) == Some r) <-> half_edge_of t (org x) h.
Proof.
split=> [|[w /(originP map)[y yh yw] c]].
  case: ifP => // /dartP[y <-] /eqP yr; exists (org y); first exact: originE.
  by apply/(label_connected map (low_v2 low)); rewrite xr -yr.
rewrite -yh dart_live; apply/eqP; rewrite -xr; apply/(label_connected map (low_v2 low)); rewrite yw.
exact: connected_sym.
Qed.

Lemma cycle_label_below b : label_at t (labels t) b == Some r -> b < boundary_slots t.
Proof. by rewrite /label_at; case S: (boundary_start t b) => [s|] // _; apply: boundary_below; apply: heard_live S. Qed.

Definition start_of b := if boundary_start t b is Some (AtHalfEdge h) then h else 0.

(** One half-edge of each cycle: where the boundary component starts. *)
Lemma cycles_exist : lists_one_of_each [seq start_of b | b <- [seq b <- iota 0 (boundary_slots t) | label_at t (labels t) b == Some r]]
  (on_cycle t) (half_edge_of t (org x)).
Proof.
have mem b : (b \in [seq b <- iota 0 (boundary_slots t) | label_at t (labels t) b == Some r]) = (label_at t (labels t) b == Some r).
  by rewrite mem_filter mem_iota add0n andbC; case: eqP (@cycle_label_below b) => [_ ->|_ _]; rewrite ?andbF.
have startE b : label_at t (labels t) b == Some r ->
    exists y : dart t, [/\ start_of b = num y, bnd y = b & half_edge_of t (org x) (num y)].
  move=> lab; have lb : boundary t b.
    by move: lab; rewrite /label_at; case S: (boundary_start t b) => [s|] // _; apply: heard_live S.
  move: lab; rewrite /label_at /start_of; case: (boundaryP low lb) => [y S yb|v -> //]; rewrite S => yr.
  by exists y; split=> //; apply/half_edge_label; rewrite dart_live.
split.
- rewrite map_inj_in_uniq ?filter_uniq ?iota_uniq // => b c; rewrite !mem => /startE[y [-> <- _]] /startE[z [-> <- _]].
  by move/num_inj->.
- by move=> h /mapP[b]; rewrite mem => /startE[y [-> _ H]] ->.
- move=> g h /mapP[b + ->] /mapP[c + ->]; rewrite !mem => /startE[y [Eb yb _]] /startE[z [Ec zc _]].
  rewrite Eb Ec (on_cycleE map) -(bndE low) yb zc => /eqP bc.
  by move: Eb Ec; rewrite bc => -> ->.
move=> h H; have := H => /half_edge_label; case: ifP => // /dartP[y yh] _.
rewrite -yh in H *; have [g S gy] := start_bnd low y; exists (num g); last exact/(on_cycleE map).
apply/mapP; exists (bnd y); last by rewrite /start_of S.
rewrite mem /label_at S; have /half_edge_label := H; rewrite dart_live => /eqP <-.
apply/eqP/(labelE map); exact: (joined_orbit (joined_nx map) gy).
Qed.

(** The tally under a label is that of its component. *)
Lemma has_countsP V E cycles : has_counts t (org x) V E cycles <->
  [/\ V = read vertices_of r, E.*2 = read half_edges_of r & cycles = read cycles_of r].
Proof.
have below_h h : ((if half_edge t h then read (labels t) h else None) == Some r) -> h < half_edge_slots t.
  by case: ifP => // /half_edge_below.
have below_v v : (leaving t v >>= read (labels t) == Some r) -> v < vertex_slots t.
  by case E': (leaving t v) => [l|] // _; apply: vertex_below; apply: heard_live E'.
have live_h h : half_edge_of t (org x) h -> half_edge t h by case=> w E0 _; apply: (heard_live E0).
have tw_h (y : dart t) : half_edge_of t (org x) (num y) -> half_edge_of t (org x) (num (tw y)).
  case=> w /(originP map)[z /num_inj-> <-] c; exists (org (tw y)); first exact: originE.
  exact: connected_trans c (connected_step map y).
have cyc_size cs : lists_one_of_each cs (on_cycle t) (half_edge_of t (org x)) -> size cs = read cycles_of r.
  rewrite tallyE -size_filter -[in RHS](size_map start_of) => H; apply: (one_of_each_size _ _ H cycles_exist) => [g h|g h k].
    case/live_h/dartP=> y <- /live_h/dartP[z <-]; rewrite !(on_cycleE map) fconnect_sym //; exact: nx_inj.
  case=> i Ei [j Ej]; exists (j + i); by rewrite iterD Ei.
have none es : lists_one_of_each es (same_edge t) (half_edge_of t (org x)) -> (es == [::]) = false.
  case=> _ _ _ all; apply/eqP=> E0; have [|y] := all (num x); last by rewrite E0.
  by exists (org x); [apply: originE | apply: connected_self].
split=> [[vs [es [cs [Hv He Hc [-> -> ->]]]]]|[-> E2 ->]].
  rewrite (none _ He) addn0 (cyc_size _ Hc); split=> //; first by rewrite tallyE; exact: lists_count below_v leaving_label Hv.
  by rewrite tallyE; apply/esym; exact: edges_half below_h half_edge_label live_h tw_h He.
have [es He] := edges_exist below_h half_edge_label live_h tw_h.
have := lists_filter below_v leaving_label; have := cycles_exist.
set cs := [seq _ | _ <- _]; set vs := filter _ _ => Hc Hv; exists vs, es, cs; split=> //.
rewrite (none _ He) addn0 (cyc_size _ Hc) tallyE -size_filter; split=> //.
by apply: double_inj; rewrite E2 tallyE (edges_half below_h half_edge_label live_h tw_h He).
Qed.

Lemma half_edges_even : exists E, E.*2 = read half_edges_of r.
Proof.
have below_h h : ((if half_edge t h then read (labels t) h else None) == Some r) -> h < half_edge_slots t.
  by case: ifP => // /half_edge_below.
have live_h h : half_edge_of t (org x) h -> half_edge t h by case=> w E0 _; apply: (heard_live E0).
have tw_h (y : dart t) : half_edge_of t (org x) (num y) -> half_edge_of t (org x) (num (tw y)).
  case=> w /(originP map)[z /num_inj-> <-] c; exists (org (tw y)); first exact: originE.
  exact: connected_trans c (connected_step map y).
have [es He] := edges_exist below_h half_edge_label live_h tw_h.
by exists (size es); rewrite tallyE (edges_half below_h half_edge_label live_h tw_h He).
Qed.

End Component.

(** A component without half-edges is one vertex, and counts one cycle. *)
Lemma has_counts_bare v V E cycles : bare t v -> has_counts t v V E cycles <-> [/\ V = 1, E = 0 & cycles = 1].
Proof.
move=> bv; have conn w : connected t v w <-> w = v.
  by split=> [/(connected_bare map (low_v2 low) bv) //|->]; apply: connected_self.
have no h : ~ half_edge_of t v h.
  by case=> w E' /conn wv; rewrite wv in E'; apply: (bv _ (heard_live E') E').
split=> [[vs [es [cs [Hv [_ He _ _] [_ Hc _ _] [-> -> ->]]]]]|[-> -> ->]].
  have -> : es = [::] by case: es He => // h es /(_ h (mem_head _ _))/no.
  have -> : cs = [::] by case: cs Hc => // h cs /(_ h (mem_head _ _))/no.
  split=> //; apply: (@lists_size vs [:: v]); first exact: Hv.
  by split=> // w; rewrite inE conn; split=> [/eqP|->].
exists [:: v], [::], [::]; split=> //; split=> //.
  by move=> w; rewrite inE conn; split=> [/eqP|->].
all: by move=> h /no.
Qed.

Lemma check_t3P : reflect (t3_euler t) (check_t3 t (labels t)).
Proof.
have euler (x : dart t) r : labels t (num x) = Some r ->
    reflect (exists V E cycles, has_counts t (org x) V E cycles /\ V + cycles = 2 + E)
      ((read vertices_of r + read cycles_of r).*2 == 4 + read half_edges_of r).
  move=> xr; apply: (iffP eqP) => [eq|[V [E' [c [/(has_countsP xr)[-> <- ->]]]]]].
    have [E E2] := half_edges_even xr.
    exists (read vertices_of r), E, (read cycles_of r); rewrite (has_countsP xr); split=> //.
    by move: eq; rewrite -E2; arith.
  by arith.
apply: (iffP (each_half_edgeP _ _)) => [H v lv|H h /dartP[x <-]].
  case: (vertexP low lv) => [x _ <-|b _ bv _ _].
    by have [r xr] := label_total map x; have := H _ (dart_live x); rewrite /read in euler *; rewrite xr => /(euler x r xr).
  by exists 1, 0, 1; split=> //; apply/has_counts_bare.
have [r xr] := label_total map x; rewrite /read in euler *; rewrite xr; apply/(euler x r xr).
exact: H _ (org_live map x).
Qed.

End Topology.

(** ** The whole checker *)

Definition upto t n := forall q, index q < n -> holds t q.

Lemma upto_next t r : upto t (index r) -> holds t r -> upto t (index r).+1.
Proof.
move=> up hr q; rewrite ltnS leq_eqVlt => /orP[/eqP E|/up //].
suff -> : q = r by []; by case: q r E {up hr} => -[].
Qed.

Lemma lower_map t : upto t (index V1) -> is_map t.
Proof.
by move=> up; case: (up R1 isT) => -[H _ _ _] _; split; [|exact: (up L1)|exact: (up L2)|exact: (up L3)].
Qed.

(** All that the checker says is true. *)
Lemma first_broken_sound t :
  if first_broken t is Some r then index r < index T4 /\ first_broken_is t r else upto t (index T4).
Proof.
rewrite /first_broken.
have up : upto t 0 by [].
case: (check_r1P t) => [h|h]; last by [].
have {}up := @upto_next t R1 up h; have r1 : links_live t := proj1 h.
case: (check_l1P t) => [{}h|{}h]; last by [].
have {}up := @upto_next t L1 up h.
case: (check_l2P t) => [{}h|{}h]; last by [].
have {}up := @upto_next t L2 up h.
case: (check_l3P t) => [{}h|{}h]; last by [].
have {}up := @upto_next t L3 up h; have map := lower_map up.
case: (check_v1P t) => [{}h|{}h]; last by [].
have {}up := @upto_next t V1 up h.
case: (check_v2P r1 map h) => [{}h|{}h]; last by [].
have {}up := @upto_next t V2 up h.
case: (check_b1P r1 map) => [{}h|{}h]; last by [].
have {}up := @upto_next t B1 up h.
case: (check_b2P r1) => [{}h|{}h]; last by [].
have {}up := @upto_next t B2 up h.
case: (check_f1P t) => [{}h|{}h]; last by [].
have {}up := @upto_next t F1 up h.
case: (check_f2P r1) => [{}h|{}h]; last by [].
have {}up := @upto_next t F2 up h; have low : lower t := up.
case: (check_t1P low) => [{}h|{}h]; last by [].
have {}up := @upto_next t T1 up h.
case: (check_t2P low h) => [{}h|{}h]; last by [].
have {}up := @upto_next t T2 up h.
case: (check_t3P low) => [{}h|{}h]; last by [].
exact: @upto_next t T3 up h.
Qed.

Lemma first_broken_unique t q r : first_broken_is t q -> first_broken_is t r -> q = r.
Proof.
move=> [nq bq] [nr br]; case: (ltngtP (index q) (index r)) => [/br/nq []|/bq/nr []|].
by case: q r {nq bq nr br} => -[].
Qed.
