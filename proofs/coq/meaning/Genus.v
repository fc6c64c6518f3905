(** * Genus: Euler's formula for views that keep R1 to F2

    Per component [V + cycles + 2g = 2 + E], where [g] is the number of edges that need a handle when the component is
    drawn. The components are plane (T3) exactly if no edge of the whole map needs one. *)

From mathcomp Require Import all_ssreflect all_fingroup.
From twinedge Require Import Arith View Rules Loops LoopsProof Reference Map Counting Lists TopologyProof.
From twinedge Require Import Drawing Euler Numbered.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** ** Sums over lists *)

Section Sums.
Variable A : eqType.
Implicit Types (s : seq A) (f g : A -> nat).

Lemma sumn_add s f g : sumn (map (fun r => f r + g r) s) = sumn (map f s) + sumn (map g s).
Proof. by elim: s => //= r s ->; arith. Qed.

Lemma sumn_const s k : sumn (map (fun _ : A => k) s) = k * size s.
Proof. by elim: s => //= [|_ s ->]; rewrite ?muln0 // mulnS. Qed.

Lemma sumn_le s f g : (forall r, r \in s -> f r <= g r) -> sumn (map f s) <= sumn (map g s).
Proof.
elim: s => //= r s IH H; apply: leq_add; first by apply: H; apply: mem_head.
by apply: IH => q qs; apply: H; rewrite inE qs orbT.
Qed.

Lemma sumn_eq s f g : (forall r, r \in s -> f r <= g r) -> sumn (map f s) = sumn (map g s) ->
  forall r, r \in s -> f r = g r.
Proof.
elim: s => //= q s IH H E r.
have Hs : forall r, r \in s -> f r <= g r by move=> u us; apply: H; rewrite inE us orbT.
have Hq := H q (mem_head _ _); have L := sumn_le Hs; rewrite inE => /orP[/eqP->|]; first by arith.
by apply: IH => //; arith.
Qed.
End Sums.

(** Each is counted at its key. *)
Lemma sumn_parts (s ps : seq nat) (key : nat -> link) : uniq ps ->
  (forall h, h \in s -> exists2 r, key h = Some r & r \in ps) ->
  sumn [seq size [seq h <- s | key h == Some r] | r <- ps] = size s.
Proof.
move=> u; elim: s => [|h s IH] H /=; first by rewrite sumn_const.
rewrite -[RHS]add1n -IH; last by move=> g gs; apply: H; rewrite inE gs orbT.
have [r hr rp] := H h (mem_head _ _).
rewrite [LHS](_ : _ = sumn [seq (r == q) + size [seq h <- s | key h == Some q] | q <- ps]); last first.
  congr sumn; apply: eq_map => q; rewrite hr -[Some r == Some q]/(r == q).
  by case: (r == q).
rewrite sumn_add; congr (_ + _); elim: ps u rp {H IH hr} => //= q ps IH /andP[nq u].
rewrite inE; case: eqP => [-> _|_ /=]; last by move=> rp; rewrite IH.
rewrite (_ : map _ ps = map (fun _ => 0) ps) ?sumn_const //; apply/eq_in_map => k kp.
by case: eqP nq => // ->; rewrite kp.
Qed.

Lemma bij_size (s s' : seq nat) (f : nat -> nat) : uniq s -> uniq s' -> {in s &, injective f} ->
  (forall x, x \in s -> f x \in s') -> (forall y, y \in s' -> exists2 x, x \in s & f x = y) -> size s = size s'.
Proof.
move=> u u' inj into onto; rewrite -(size_map f); apply: perm_size; apply: uniq_perm => //.
  by rewrite map_inj_in_uniq.
by move=> y; apply/mapP/idP => [[x /into + ->] //|/onto[x xs <-]]; exists x.
Qed.

Lemma one_of_each_filter s (same : nat -> nat -> Prop) (P : nat -> Prop) (q : pred nat) :
  (forall x y, same x y -> q x = q y) ->
  lists_one_of_each s same P -> lists_one_of_each [seq x <- s | q x] same (fun x => P x /\ q x).
Proof.
move=> inv [u sP one all]; split; first exact: filter_uniq.
- by move=> x; rewrite mem_filter => /andP[qx /sP].
- by move=> x y; rewrite !mem_filter => /andP[_ xs] /andP[_ ys]; apply: one.
by move=> x [/all[y ys yx] qx]; exists y => //; rewrite mem_filter ys (inv _ _ yx) qx.
Qed.

(** ** Some half-edges, closed under the links, are a rotation system of their own *)

Section Part.
Variables (t : view) (p : pred nat).
Hypothesis map : is_map t.
Hypothesis live : forall h, p h -> half_edge t h.
Hypothesis closed : forall x : dart t, p (num x) -> p (num (nx x)) /\ p (num (tw x)).

Lemma part_euler vs cs es ps :
  lists_one_of_each vs (on_orbit (turn t)) p -> lists_one_of_each cs (on_cycle t) p ->
  lists_one_of_each es (same_edge t) p -> lists_one_of_each ps (reached (near t)) p ->
  exists g, size vs + size cs + g.*2 = size es + (size ps).*2.
Proof.
have below h : p h -> h < half_edge_slots t by move/live/half_edge_below.
have twins_total h : p h -> exists2 g, twin t h = Some g & p g.
  by move=> ph; have [x xh] := dartP (live ph); rewrite -xh in ph *; exists (num (tw x)); [apply: twinE|case: (closed ph)].
have turns_total h : p h -> exists2 g, turn t h = Some g & p g.
  move=> ph; have [x xh] := dartP (live ph); rewrite -xh in ph *; exists (num (tn x)); first exact: turnE.
  by have [_ pt] := closed ph; case: (closed pt).
pose part := [finType of slot (half_edge_slots t) p].
pose twins : part -> part := step (twin t); pose turns : part -> part := step (turn t).
have twinN x : twin t (num x) = Some (num (twins x)) by apply: (says_step below twins_total).
have turnN x : turn t (num x) = Some (num (turns x)) by apply: (says_step below turns_total).
have dart_of (x : part) : exists y : dart t, num y = num x by apply: dartP; apply: live; apply: num_live.
have twinsK : involutive twins.
  move=> x; have [y yx] := dart_of x; apply: num_inj; apply: Some_inj; rewrite -twinN.
  have <- : num (tw y) = num (twins x) by apply: Some_inj; rewrite -twinE // yx twinN.
  by rewrite twinE // twK // yx.
have tw_neq x : twins x != x.
  have [y yx] := dart_of x; apply/eqP=> E; have := tw_neq map y; rewrite -(inj_eq (@num_inj _ _)).
  have [->] : Some (num (tw y)) = Some (num (twins x)) by rewrite -twinE // yx twinN.
  by rewrite E yx eqxx.
have inj : injective turns.
  move=> x x' E; have [y yx] := dart_of x; have [y' yx'] := dart_of x'; apply: num_inj; rewrite -yx -yx'; congr num.
  apply: (tn_inj map); apply: num_inj; apply: Some_inj; rewrite -!turnE // yx yx' !turnN E //.
have [edges every] := every_edge_exists twinsK tw_neq; exists (handles (perm inj) twins edges).
have nextN x : next t (num x) = Some (num (perm inj (twins x))).
  rewrite permE -turnN; have [y yx] := dart_of x; have [yt] : Some (num (tw y)) = Some (num (twins x)).
    by rewrite -twinE // yx twinN.
  by rewrite -yt turnE // /tn twK // -yx nextE.
apply: (@numbered_euler t part (perm inj) twins (@num _ p) p) => //.
- exact: num_inj.
- by move=> h; split=> [ph|[x <-]]; [exists (at_slot below ph) | apply: num_live].
move=> x; have [y yx] := dart_of x; have := nextN x; rewrite -yx nextE // => -[<-].
by rewrite prevE // nxK.
Qed.

End Part.

(** ** The whole map, and its components *)

Section Whole.
Variable t : view.
Hypothesis low : lower t.

Let map := low_map low.
Let rot := low_v2 low.

Definition turns : {perm dart t} := perm (tn_inj map).

Lemma turnsE x : turns x = tn x. Proof. exact: permE. Qed.

Lemma next_turns (x : dart t) : next t (num x) = Some (num (turns (tw x))).
Proof. by rewrite turnsE /tn twK // nextE. Qed.

Lemma prev_turns (x : dart t) : prev t (num (turns (tw x))) = Some (num x).
Proof. by rewrite turnsE /tn twK // prevE // nxK. Qed.

Lemma whole_euler edges vs cs es ps : every_edge (@tw t) edges ->
  lists_one_of_each vs (on_orbit (turn t)) (half_edge t) -> lists_one_of_each cs (on_cycle t) (half_edge t) ->
  lists_one_of_each es (same_edge t) (half_edge t) -> lists_one_of_each ps (reached (near t)) (half_edge t) ->
  size vs + size cs + (handles turns (@tw t) edges).*2 = size es + (size ps).*2.
Proof.
apply: (@numbered_euler t (dart t) turns (@tw t) (@num _ _) (half_edge t)).
- exact: twK.
- exact: tw_neq.
- exact: num_inj.
- by move=> h; split=> [/dartP[x xh]|[x <-]]; [exists x | apply: dart_live].
- exact: twinE.
- exact: next_turns.
- exact: prev_turns.
Qed.

(** *** Lists of the whole *)

Definition kept v := odflt 0 (leaving t v).

Lemma keptP v h : leaving t v = Some h -> exists2 x : dart t, kept v = num x & org x = v.
Proof.
rewrite /kept => E; have := low_v1 low (heard_live E) E; rewrite E => /(originP map)[x xh xv].
by exists x.
Qed.

Lemma kept_org (x : dart t) : exists2 y : dart t, leaving t (org x) = Some (num y) & org y = org x.
Proof.
case: (vertexP low (org_live map x)) => [y E yx|b _ bv]; first by exists y.
by case: (not_bare low bv).
Qed.

Definition with_edges := [seq v <- iota 0 (vertex_slots t) | isSome (leaving t v)].

Lemma with_edgesP v : v \in with_edges <-> exists x : dart t, org x = v.
Proof.
rewrite mem_filter mem_iota add0n; split=> [/andP[]|[x <-]].
  by case E: (leaving t v) => [h|] // _ _; have [x _ xv] := keptP E; exists x.
by have [y -> _] := kept_org x; rewrite vertex_below ?org_live.
Qed.

Lemma kept_one_of_each vs (P : nat -> Prop) :
  uniq vs -> (forall h, P h -> half_edge t h) -> (forall x : dart t, P (num x) <-> org x \in vs) ->
  (forall v, v \in vs -> exists x : dart t, org x = v) ->
  lists_one_of_each [seq kept v | v <- vs] (on_orbit (turn t)) P.
Proof.
move=> u live PE ex.
have keptE v : v \in vs -> exists2 x : dart t, kept v = num x & org x = v.
  by move=> /ex[x <-]; have [y E yx] := kept_org x; apply: (keptP E).
split.
- rewrite map_inj_in_uniq // => v w /keptE[x -> <-] /keptE[y -> <-] /num_inj-> //.
- by move=> h /mapP[v vs' ->]; have [x -> xv] := keptE v vs'; apply/PE; rewrite xv.
- move=> g h /mapP[v vv ->] /mapP[w ww ->]; have [x Ex xv] := keptE v vv; have [y Ey yw] := keptE w ww.
  rewrite Ex Ey (on_rotationE map) (rotationE map rot) xv yw => /eqP vw.
  by move: Ex Ey; rewrite vw => -> ->.
move=> h Ph; have [x xh] := dartP (live _ Ph); rewrite -xh in Ph *.
have xvs : org x \in vs by apply/PE.
have [y Ey yx] := keptE _ xvs; exists (kept (org x)); first exact: map_f.
by rewrite Ey (on_rotationE map) (rotationE map rot) yx.
Qed.

Definition rotations := [seq kept v | v <- with_edges].

Lemma rotations_each : lists_one_of_each rotations (on_orbit (turn t)) (half_edge t).
Proof.
apply: kept_one_of_each => // [|x|v /with_edgesP //]; first exact: filter_uniq (iota_uniq _ _).
by split=> _; [apply/with_edgesP; exists x | apply: dart_live].
Qed.

Definition cyclic b := if boundary_start t b is Some (AtHalfEdge _) then true else false.
Definition cycles := [seq start_of t b | b <- iota 0 (boundary_slots t) & cyclic b].

Lemma cyclicP b : cyclic b -> exists2 x : dart t, start_of t b = num x & bnd x = b.
Proof.
rewrite /cyclic /start_of; case S: (boundary_start t b) => [[h|]|] // _.
by case: (boundaryP low (heard_live S)) => [x|v]; rewrite S // => -[->] xb; exists x.
Qed.

Lemma cycles_each : lists_one_of_each cycles (on_cycle t) (half_edge t).
Proof.
have mem b : b \in [seq b <- iota 0 (boundary_slots t) | cyclic b] -> cyclic b by rewrite mem_filter => /andP[].
split.
- rewrite map_inj_in_uniq ?filter_uniq ?iota_uniq // => b c /mem/cyclicP[x -> <-] /mem/cyclicP[y -> <-] /num_inj-> //.
- by move=> h /mapP[b /mem/cyclicP[x -> _] ->]; apply: dart_live.
- move=> g h /mapP[b + ->] /mapP[c + ->] => /mem/cyclicP[x Eb xb] /mem/cyclicP[y Ec yc].
  rewrite Eb Ec (on_cycleE map) -(bndE low) xb yc => /eqP bc.
  by move: Eb Ec; rewrite bc => -> ->.
move=> h /dartP[x <-]; have [g S gx] := start_bnd low x; exists (num g); last exact/(on_cycleE map).
apply/mapP; exists (bnd x); last by rewrite /start_of S.
by rewrite mem_filter /cyclic S mem_iota add0n boundary_below ?bnd_live.
Qed.

Lemma edges_each : exists es, lists_one_of_each es (same_edge t) (half_edge t).
Proof.
apply: (edges_exist low (p := half_edge t) (n := half_edge_slots t)) => // [h|x _]; first exact: half_edge_below.
exact: dart_live.
Qed.

Definition pieces := [seq h <- iota 0 (half_edge_slots t) | labels t h == Some h].

Lemma piecesP h : h \in pieces <-> labels t h = Some h.
Proof.
rewrite mem_filter mem_iota add0n; split=> [/andP[/eqP]//|E].
by rewrite E eqxx half_edge_below // (label_live map E).
Qed.

Lemma label_piece (x : dart t) : exists2 r, labels t (num x) = Some r & r \in pieces.
Proof.
have [r xr] := label_total map x; exists r => //; apply/piecesP.
by case: (flood_all_label (@half_edge_below t) (near_live map) (near_sym map) (near_enough t) xr).
Qed.

Lemma pieces_each : lists_one_of_each pieces (reached (near t)) (half_edge t).
Proof.
have live h : h \in pieces -> half_edge t h by move/piecesP/(label_live map).
split; first exact: filter_uniq (iota_uniq _ _).
- exact: live.
- move=> g h gp hp; have [x xg] := dartP (live _ gp); have [y yh] := dartP (live _ hp).
  rewrite -xg -yh => /(labelE map); rewrite xg yh.
  by move/piecesP: gp => ->; move/piecesP: hp => -> -[].
move=> h /dartP[x <-]; have [r xr rp] := label_piece x; exists r => //.
have [y yr] := dartP (live _ rp); rewrite -yr; apply/(labelE map).
by rewrite xr -yr; move/piecesP: rp; rewrite -yr.
Qed.

(** *** One component *)

Definition part r : pred nat := fun h => labels t h == Some r.

Lemma part_live r h : part r h -> half_edge t h.
Proof. by move/eqP/(label_live map). Qed.

Lemma part_closed r (x : dart t) : part r (num x) -> part r (num (nx x)) /\ part r (num (tw x)).
Proof.
by rewrite /part => /eqP <-; split; apply/eqP/(labelE map)/(joined_sym map); [apply: joined_nx|apply: joined_tw].
Qed.

Lemma part_piece (x : dart t) r : labels t (num x) = Some r -> lists_one_of_each [:: num x] (reached (near t)) (part r).
Proof.
move=> xr; split=> //.
- by move=> h; rewrite inE => /eqP->; apply/eqP.
- by move=> g h; rewrite !inE => /eqP-> /eqP->.
move=> h /eqP hr; have [y yh] := dartP (label_live map hr); rewrite -yh in hr *.
by exists (num x); rewrite ?mem_head //; apply/(labelE map); rewrite xr hr.
Qed.

Lemma part_half_edge_of (x : dart t) r h : labels t (num x) = Some r -> half_edge_of t (org x) h <-> part r h.
Proof.
move=> xr; rewrite -(half_edge_label low xr) /part /read; split; first by case: ifP.
by move=> /eqP E; rewrite (label_live map E) E.
Qed.

(** The lists of a component, once all are lists of half-edges. *)
Lemma component_lists (x : dart t) r vs : labels t (num x) = Some r -> lists vs (connected t (org x)) ->
  lists_one_of_each [seq kept v | v <- vs] (on_orbit (turn t)) (part r).
Proof.
move=> xr [u H]; apply: kept_one_of_each => // [h /part_live //|y|v /H c].
  rewrite /part; split=> [/eqP yr|/H c]; first by apply/H/(label_connected map rot); rewrite xr yr.
  by apply/eqP; rewrite -xr; apply/(label_connected map rot); apply: connected_sym c.
by case: (connected_dart map rot c) => [<-|[_ [y [_ <- _]]]]; [exists x | exists y].
Qed.

(** Euler's formula for a component: [g] edges need a handle. *)
Theorem euler_component v V E C : vertex t v -> has_counts t v V E C -> exists g, V + C + g.*2 = 2 + E.
Proof.
move=> lv; case: (vertexP low lv) => [x _ <-|b _ bv _ _]; last first.
  by case/(has_counts_bare low _ _ _ bv) => -> -> ->; exists 0.
have [r xr] := label_total map x; case=> vs [es [cs [Hv He Hc [-> -> ->]]]].
have HP h := part_half_edge_of h xr.
have nonempty : (es == [::]) = false.
  apply/eqP=> E0; case: He => _ _ _ /(_ (num x)); rewrite E0; case=> //.
  by exists (org x); [apply: originE | apply: connected_self].
have := @part_euler t (part r) map (@part_live r) (@part_closed r) _ cs es [:: num x]
  (component_lists xr Hv) (one_of_each_iff HP Hc) (one_of_each_iff HP He) (part_piece xr).
by case=> g; rewrite size_map nonempty /= => eq; exists g; arith.
Qed.

(** *** The components are plane if and only if the whole is *)

Definition in_part r s := [seq h <- s | labels t h == Some r].

Lemma in_part_each (s : seq nat) (same : nat -> nat -> Prop) r : (forall h g, same h g -> labels t h = labels t g) ->
  lists_one_of_each s same (half_edge t) -> lists_one_of_each (in_part r s) same (part r).
Proof.
move=> inv /(@one_of_each_filter s same _ (part r)) H; apply: one_of_each_iff (H _) => [h|h g /inv E].
  by split=> [[]//|ph]; split=> //; apply: part_live ph.
by rewrite /part E.
Qed.

Lemma same_label_orbit says (f : dart t -> dart t) g h : (forall x, says (num x) = Some (num (f x))) ->
  (forall x, joined x (f x)) -> (forall i j, says i = Some j -> half_edge t i) ->
  on_orbit says g h -> labels t g = labels t h.
Proof.
move=> saysE jf live [k]; elim: k g => [|k IH] g; first by case=> ->.
rewrite iterSr; case E: (obind says (Some g)) => [j|]; last first.
  by suff -> : iter k (obind says) None = None by []; elim: k {IH} => //= k ->.
move/IH <-; have [x xg] := dartP (live _ _ E); move: E; rewrite -xg /= saysE => -[<-].
by apply/(labelE map).
Qed.

Lemma label_turn g h : on_orbit (turn t) g h -> labels t g = labels t h.
Proof.
apply: (@same_label_orbit (turn t) (@tn t)); [exact: turnE | exact: joined_tn|].
move=> i j; rewrite /turn; case E: (twin t i) => [k|] // _; exact: heard_live E.
Qed.

Lemma label_cycle g h : on_cycle t g h -> labels t g = labels t h.
Proof.
apply: (@same_label_orbit (next t) (@nx t)); [exact: nextE | exact: joined_nx|].
by move=> i j; apply: heard_live.
Qed.

Lemma label_edge g h : same_edge t g h -> labels t g = labels t h.
Proof.
case=> [-> //|E]; have [x xg] := dartP (heard_live E); move: E; rewrite -xg (twinE map) => -[<-].
by apply/(labelE map); apply: joined_tw.
Qed.

Lemma edge_sym g h : half_edge t g -> half_edge t h -> same_edge t g h -> same_edge t h g.
Proof.
case/dartP=> x <- /dartP[y <-]; rewrite !(same_edge_dart low) => -[->|<-]; first by left.
by right; apply: twK.
Qed.

(** Not transitive of itself: so edges are compared through twice their number. *)
Lemma edges_twice r s : lists_one_of_each s (same_edge t) (part r) ->
  (size s).*2 = count (part r) (iota 0 (half_edge_slots t)).
Proof.
move=> H; apply/esym; apply: (edges_half low) H => // h; try exact: part_live.
  by move/part_live/half_edge_below.
by case/part_closed.
Qed.

Lemma component_sizes (x : dart t) r es V E C : labels t (num x) = Some r ->
  lists_one_of_each es (same_edge t) (half_edge t) -> has_counts t (org x) V E C ->
  [/\ V = size (in_part r rotations), E = size (in_part r es) & C = size (in_part r cycles)].
Proof.
move=> xr Hes [vs [es' [cs [Hv He Hc [-> -> ->]]]]]; have HP h := part_half_edge_of h xr.
have nonempty : (es' == [::]) = false.
  apply/eqP=> E0; case: He => _ _ _ /(_ (num x)); rewrite E0; case=> //.
  by exists (org x); [apply: originE | apply: connected_self].
rewrite nonempty addn0; split.
- rewrite -(size_map kept); apply: (one_of_each_size _ _ (component_lists xr Hv) (in_part_each _ label_turn rotations_each)).
    by move=> g h /part_live lg /part_live lh; apply: turn_sym.
  exact: orbit_trans.
- apply: double_inj; rewrite (edges_twice (one_of_each_iff HP He)).
  by rewrite (edges_twice (in_part_each _ label_edge Hes)).
apply: (one_of_each_size _ _ (one_of_each_iff HP Hc) (in_part_each _ label_cycle cycles_each)).
  by move=> g h /part_live lg /part_live lh; apply: cycle_sym.
exact: orbit_trans.
Qed.

Lemma component_counts (x : dart t) : exists V E C, has_counts t (org x) V E C.
Proof.
have [r xr] := label_total map x; have [E E2] := half_edges_even low xr.
by exists (read (vertices_of t) r), E, (read (cycles_of t) r); apply/(has_countsP low xr).
Qed.

Lemma sum_parts s : (forall h, h \in s -> half_edge t h) -> sumn [seq size (in_part r s) | r <- pieces] = size s.
Proof.
move=> live; apply: sumn_parts; first exact: filter_uniq (iota_uniq _ _).
by move=> h /live/dartP[x <-]; apply: label_piece.
Qed.

Lemma part_le es r : lists_one_of_each es (same_edge t) (half_edge t) -> r \in pieces ->
  exists g, size (in_part r rotations) + size (in_part r cycles) + g.*2 = size (in_part r es) + 2.
Proof.
move=> Hes /piecesP rr; have [x xr] := dartP (label_live map rr); rewrite -xr in rr.
have := @part_euler t (part (num x)) map (@part_live _) (@part_closed _) _ _ _ [:: num x]
  (in_part_each _ label_turn rotations_each) (in_part_each _ label_cycle cycles_each) (in_part_each _ label_edge Hes)
  (part_piece rr).
by rewrite -xr.
Qed.

(** T3 holds if and only if the formula without handles holds for the whole. *)
Lemma t3_sums es : lists_one_of_each es (same_edge t) (half_edge t) ->
  t3_euler t <-> size rotations + size cycles = size es + (size pieces).*2.
Proof.
move=> Hes.
have [_ liveV _ _] := rotations_each; have [_ liveC _ _] := cycles_each; have [_ liveE _ _] := Hes.
have sums : sumn [seq size (in_part r rotations) + size (in_part r cycles) | r <- pieces] = size rotations + size cycles.
  by rewrite sumn_add !sum_parts.
have sums' : sumn [seq size (in_part r es) + 2 | r <- pieces] = size es + 2 * size pieces.
  by rewrite sumn_add sum_parts // sumn_const.
have part_of r : r \in pieces -> exists2 x : dart t, num x = r & labels t (num x) = Some r.
  by move=> /piecesP rr; have [x xr] := dartP (label_live map rr); exists x; rewrite ?xr.
split=> [T3|plane].
  have eq r : r \in pieces -> size (in_part r rotations) + size (in_part r cycles) = size (in_part r es) + 2.
    move=> /part_of[x _ xr]; have [V [E [C [H VC]]]] := T3 _ (org_live map x).
    by have [<- <- <-] := component_sizes xr Hes H; arith.
  have E : [seq size (in_part r rotations) + size (in_part r cycles) | r <- pieces] = [seq size (in_part r es) + 2 | r <- pieces].
    exact/eq_in_map.
  by move: sums; rewrite E sums' => sums; arith.
have eq r : r \in pieces -> size (in_part r rotations) + size (in_part r cycles) = size (in_part r es) + 2.
  apply: (@sumn_eq _ pieces (fun r => size (in_part r rotations) + size (in_part r cycles)) (fun r => size (in_part r es) + 2)).
    by move=> q /(part_le Hes)[g] <-; apply: leq_addr.
  by rewrite sums sums'; arith.
move=> v lv; case: (vertexP low lv) => [x _ <-|b _ bv _ _]; last first.
  by exists 1, 0, 1; split=> //; apply/(has_counts_bare low _ _ _ bv).
have [V [E [C H]]] := component_counts x; exists V, E, C; split=> //.
have [r xr rp] := label_piece x; have [-> -> ->] := component_sizes xr Hes H.
by rewrite eq // addnC.
Qed.

(** T3 holds if and only if no edge of the map needs a handle, in whatever order the edges are drawn. *)
Theorem t3_plane edges : every_edge (@tw t) edges -> t3_euler t <-> drawn turns (@tw t) edges.
Proof.
move=> every; have [es Hes] := edges_each; rewrite drawnP (t3_sums Hes).
have := whole_euler every rotations_each cycles_each Hes pieces_each.
by split; arith.
Qed.

End Whole.
