(** * SearchOutside: which part of a component keeps the outside when a bridge is removed (dcel/operators/walk.rs)

    From each end of the bridge the faces of its part are searched: along the stretch of the cycle that is cut, and then along every
    outer cycle that is met across an edge. One of the two searches meets the inner boundary component of the component, and it can be
    reached from that end without the bridge: so [stays] and [way] of RemovePart.v are found.

<<
         ┌───────┐   n    ┌────┐        both sides of the bridge are on the cycle that is cut.
         │   f   ├────────┤    │        The outside is across an edge of one of the parts
         └───────┘    m   └────┘
>>

    In Rust the searches go on in step, each with a queue, and end at the first answer; here each is what it can reach. *)

From mathcomp Require Import all_ssreflect all_fingroup.
From twinedge Require Import View Rules Loops LoopsProof Map Lists Core RemovePart.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section Search.
Variable t : view.
Hypothesis keeps : rules t.

Let low : lower t := fun r _ => keeps r.
Let map := low_map low.

(** The test of the search: the boundary component is the outer one of its face. *)
Definition is_outer b := boundary_face t b >>= outer t == Some b.

Lemma outer_inn b : boundary t b -> is_outer b = ~~ inn_of t b.
Proof.
move=> lb; have [f [p [_ F P L]]] := placeP low lb; rewrite /is_outer /inn_of F P /=.
case: p P L => [|i] P L /=; first by apply/eqP.
by apply/eqP=> O; have [_] := @listed_names _ low f Outer b O; rewrite P.
Qed.

Variables (a : dart t) (cut : nat).
Notation b := (tw a).
Hypothesis bnd_a : bnd a = cut.
Hypothesis bnd_b : bnd b = cut.
Hypothesis outer_cut : is_outer cut.

(** The search from the end [s] of the bridge. *)
Definition stretch (s x : dart t) := (bnd x == cut) && (findex (@nx t) (nx (tw s)) x < findex (@nx t) (nx (tw s)) s).
Definition across (x y : dart t) := [&& bnd (tw x) != cut, is_outer (bnd (tw x)) & bnd y == bnd (tw x)].
Definition walked s y := [exists x, stretch s x && connect across x y].
Definition finds s := [exists y, walked s y && ~~ is_outer (bnd (tw y))].

Definition is_end (s : dart t) := s = a \/ s = b.

Lemma end_cut s : is_end s -> bnd s = cut /\ bnd (tw s) = cut.
Proof. by case=> ->; rewrite ?(twK map). Qed.

Lemma cycle_of (x y : dart t) : bnd x = bnd y -> fconnect (@nx t) x y.
Proof. by move=> E; rewrite -(bndE low) E. Qed.

(** *** All that is searched can be reached without the bridge *)

Definition reaches (s : dart t) v := exists way, way_ends t (num a) (num b) (org s) way = Some v.

Lemma reaches_on s (x : dart t) : reaches s (org x) -> x <> a -> x <> b -> reaches s (org (tw x)).
Proof.
case=> way W xa xb; exists (way ++ [:: num x]).
have last u w : way_ends t (num a) (num b) u w = Some (org x) -> way_ends t (num a) (num b) u (w ++ [:: num x]) = Some (org (tw x)).
  elim: w u => [|i w IH] u /=.
    move=> [->]; rewrite (originE map) (targetE map) eqxx !andbT ifT //.
    by apply/andP; split; apply/eqP=> /num_inj.
  by case: ifP => // _; case: (target t i) => // v; apply: IH.
exact: last.
Qed.

Lemma reaches_next s (x : dart t) : reaches s (org x) -> x <> a -> x <> b -> reaches s (org (nx x)).
Proof. by rewrite (org_nx map); apply: reaches_on. Qed.

Lemma stretch_reached s x : is_end s -> stretch s x -> [/\ reaches s (org x), x <> a & x <> b].
Proof.
move=> es /andP[/eqP xc lt]; have [sc tc] := end_cut es.
have nc : bnd (nx (tw s)) = cut by rewrite (bnd_nx low).
have cx : fconnect (@nx t) (nx (tw s)) x by apply: cycle_of; rewrite nc.
have cs : fconnect (@nx t) (nx (tw s)) s by apply: cycle_of; rewrite nc.
have free j : j < findex (@nx t) (nx (tw s)) s -> iter j (@nx t) (nx (tw s)) <> s /\ iter j (@nx t) (nx (tw s)) <> tw s.
  move=> lj; split=> E.
    have := findex_iter (ltn_trans lj (findex_max cs)); rewrite E => jj; by rewrite jj ltnn in lj.
  have := findex_iter (leq_ltn_trans lj (findex_max cs)); rewrite iterS E findex0 => jj; by [].
have both y : y <> s -> y <> tw s -> y <> a /\ y <> b.
  by case: es => ->; rewrite ?(twK map).
have go j : j <= findex (@nx t) (nx (tw s)) x -> reaches s (org (iter j (@nx t) (nx (tw s)))).
  elim: j => [|j IH] le; first by rewrite /= (org_nx map) (twK map); exists [::].
  have [ns nt] := free j (ltn_trans le lt); have [na nb] := both _ ns nt.
  exact: reaches_next (IH (ltnW le)) na nb.
rewrite -(iter_findex cx); have [ns nt] := free _ lt; have [na nb] := both _ ns nt; split=> //; exact: go.
Qed.

Lemma cycle_reached s (x y : dart t) : bnd x <> cut -> fconnect (@nx t) x y -> reaches s (org x) -> reaches s (org y).
Proof.
move=> xc /iter_findex <-; elim: (findex _ _ _) => //= k IH X.
have bk : bnd (iter k (@nx t) x) = bnd x by elim: (k) => //= j <-; apply: bnd_nx.
by apply: reaches_next (IH X) _ _ => E; apply: xc; rewrite -bk E.
Qed.

Lemma walked_reached s y : is_end s -> walked s y -> [/\ reaches s (org y), y <> a & y <> b].
Proof.
move=> es /existsP[x /andP[/(stretch_reached es) X /connectP[p]]]; elim: p x X => [|z p IH] x X /=; first by move=> _ ->.
case/andP=> /and3P[nc _ /eqP bz] path E; apply: (IH z) => //; have [R xa xb] := X; have bc : bnd (tw x) <> cut by apply/eqP.
split=> [|za|zb].
- by apply: (cycle_reached bc) (reaches_on R xa xb); apply: cycle_of; rewrite bz.
- by apply: bc; rewrite -bz za.
by apply: bc; rewrite -bz zb.
Qed.

Theorem search_sound s : is_end s -> finds s -> exists bo way,
  [/\ inn_of t bo, isSome (vertex_at t bo) & way_ends t (num a) (num b) (org s) way = vertex_at t bo].
Proof.
move=> es /existsP[y /andP[/(walked_reached es)[R ya yb] no]]; exists (bnd (tw y)).
have bc : bnd (tw y) <> cut by move=> E; rewrite E outer_cut in no.
have [g S gy] := start_bnd low (tw y); have V := vertex_at_cycle low S.
have [way W] : reaches s (org g).
  by apply: (cycle_reached bc) (reaches_on R ya yb); rewrite (fconnect_sym (nx_inj map)).
by exists way; rewrite V; split=> //; rewrite -[inn_of _ _]negbK -outer_inn //; apply: bnd_live.
Qed.

(** *** One of the two searches finds it *)

Lemma orders_same (x y : dart t) : fconnect (@nx t) x y -> fingraph.order (@nx t) x = fingraph.order (@nx t) y.
Proof.
move=> c; apply: eq_card => z; rewrite !inE; apply: same_connect c z; exact: fconnect_sym (nx_inj map).
Qed.

(** The cycle that is cut consists of the bridge and of the two stretches. *)
Lemma cut_parts (x : dart t) : bnd x = cut -> x <> a -> x <> b -> stretch a x || stretch b x.
Proof.
move=> xc xa xb; rewrite /stretch xc eqxx (twK map) /=; set f := @nx t; set u := f b; set v := f a.
have cyc y z : bnd y = cut -> bnd z = cut -> fconnect f y z by move=> yc zc; apply: cycle_of; rewrite yc zc.
have uc : bnd u = cut by rewrite (bnd_nx low). have vc : bnd v = cut by rewrite (bnd_nx low).
case: ltnP => //= le; have ux := cyc u x uc xc; have ua := cyc u a uc bnd_a; have ub := cyc u b uc bnd_b.
set p := findex f u a in le; set q := findex f u x in le.
have px : iter q f u = x := iter_findex ux; have pa : iter p f u = a := iter_findex ua.
have lt : p < q by rewrite ltn_neqAle le andbT; apply/eqP=> E; apply: xa; rewrite -px -pa E.
have back : iter (fingraph.order f u).-1 f u = b.
  apply: (nx_inj map); rewrite -/f -/u -iterS prednK ?order_gt0 // iter_order //; exact: nx_inj.
have qo : q < fingraph.order f u := findex_max ux.
have qb : q < (fingraph.order f u).-1.
  rewrite ltn_neqAle -ltnS prednK ?order_gt0 // qo andbT; apply/eqP=> E; apply: xb; by rewrite -px E back.
have ov : fingraph.order f v = fingraph.order f u by apply: orders_same; apply: cyc.
have at_v k : p < k -> iter k f u = iter (k - p.+1) f v.
  by move=> pk; rewrite /v -pa -iterS -iterD subnK.
rewrite -px -back !at_v //; last exact: ltn_trans lt qb.
have e1 : findex f v (iter (q - p.+1) f v) = q - p.+1 by apply: findex_iter; rewrite ov; exact: leq_ltn_trans (leq_subr _ _) qo.
have e2 : findex f v (iter ((fingraph.order f u).-1 - p.+1) f v) = (fingraph.order f u).-1 - p.+1.
  by apply: findex_iter; rewrite ov; apply: leq_ltn_trans (leq_subr _ _) _; rewrite prednK ?order_gt0.
by rewrite e1 e2; apply: ltn_sub2r => //; apply: leq_ltn_trans lt qb.
Qed.

Lemma walked_side s y : walked s y -> bnd y = cut \/ is_outer (bnd y).
Proof.
case/existsP=> x /andP[/andP[/eqP xc _] /connectP[p]].
have: bnd x = cut \/ is_outer (bnd x) by left.
elim: p x {xc} => [|z p IH] x X /=; first by move=> _ ->.
by case/andP=> /and3P[_ o /eqP bz] path E; apply: (IH z) => //; right; rewrite bz.
Qed.

Lemma walked_along s x y : walked s x -> bnd y = bnd x -> bnd x <> cut -> walked s y.
Proof.
case/existsP=> z /andP[st /connectP[p]]; case/lastP: p => [|p l]; first by case/andP: st => /eqP zc _ _ /= -> _ [].
rewrite rcons_path last_rcons => /andP[path lx] xl E _; rewrite -xl in lx.
have ly : across (last z p) y by move: lx; rewrite /across E.
apply/existsP; exists z; rewrite st; apply: connect_trans (connect1 ly); apply/connectP; by exists p.
Qed.

Theorem search_complete : finds a || finds b.
Proof.
apply/negPn/negP; rewrite negb_or => /andP[/existsPn na /existsPn nb].
pose P x := [|| bnd x == cut, walked a x | walked b x].
have onward s x y : walked s x -> across x y -> walked s y.
  case/existsP=> z /andP[st c] xy; apply/existsP; exists z; rewrite st; exact: connect_trans c (connect1 xy).
have along x y : P x -> bnd y = bnd x -> P y.
  rewrite /P => Px E; rewrite E; case: (bnd x =P cut) Px => //= xc /orP[W|W]; rewrite (walked_along W E xc) ?orbT //.
have over x : P x -> P (tw x).
  have one s : is_end s -> (forall y, ~~ (walked s y && ~~ is_outer (bnd (tw y)))) -> (forall y, walked s y -> P y) -> walked s x -> P (tw x).
    move=> es ns sP W; have := ns x; rewrite W negbK => o; case: (boolP (bnd (tw x) == cut)) => nc; first by rewrite /P nc.
    by apply: sP; apply: onward W _; rewrite /across nc o eqxx.
  case/or3P=> [/eqP xc|W|W]; last 2 first.
  - by apply: (one a) => //; [left|move=> y; rewrite /P => ->; rewrite orbT].
  - by apply: (one b) => //; [right|move=> y; rewrite /P => ->; rewrite !orbT].
  case: (x =P a) => [->|xa]; first by rewrite /P bnd_b eqxx.
  case: (x =P b) => [->|xb]; first by rewrite /P (twK map) bnd_a eqxx.
  case/orP: (cut_parts xc xa xb) => st.
    apply: (one a) => //; [by left|by move=> y; rewrite /P => ->; rewrite orbT|].
    by apply/existsP; exists x; rewrite st connect0.
  apply: (one b) => //; [by right|by move=> y; rewrite /P => ->; rewrite !orbT|].
  by apply/existsP; exists x; rewrite st connect0.
have all x : joined a x -> P x.
  move=> ax; apply: (@joined_ind _ map P a x) ax _; last by rewrite /P bnd_a eqxx.
  move=> z Pz; split; [|apply: along Pz _|exact: over].
    by apply: along Pz _; apply: bnd_nx.
  by rewrite -[in RHS](pvK map z) (bnd_nx low).
have [bo [O _]] := (keeps T1 : t1_outside t) _ (org_live map a); have [I [y S ay]] := (outside_dart low a bo).1 O.
have lb : boundary t bo := heard_live S.
have yb : bnd y = bo.
  by case: (boundaryP low lb) => [x S' xb|v S' _ _ _]; move: S'; rewrite S // => -[/num_inj->].
have no : ~~ is_outer bo by rewrite outer_inn // negbK /inn_of; case: I => i ->.
case/or3P: (all y ay) => [/eqP E|W|W]; first by move: no; rewrite -yb E outer_cut.
  by case: (walked_side W); rewrite yb => E; [move: no; rewrite E outer_cut|rewrite E in no].
by case: (walked_side W); rewrite yb => E; [move: no; rewrite E outer_cut|rewrite E in no].
Qed.

(** *** So the edge can be removed with the answer of either search *)

Theorem search_keeps_rules f made at_n at_m s : boundary_face t cut = Some f -> ~~ boundary t made ->
  at_n = cut /\ at_m = made \/ at_n = made /\ at_m = cut -> is_end s -> finds s ->
  rules (part_component t (num a) (num b) f cut made at_n at_m (if s == a then at_n else at_m)).
Proof.
move=> F free ends es fs; have [bo [way [I V W]]] := search_sound es fs; apply: (@part_component_keeps_rules _ _ _ _ _ _ _ _ _ bo way) keeps.
have differ : at_m == at_n = false.
  have lc : boundary t cut by rewrite -bnd_a; apply: bnd_live.
  by apply/eqP=> E; case/negP: free; case: ends => -[n m]; rewrite -?m -?n; [rewrite E n|rewrite -E m].
rewrite /is_bridge (Map.twinE map) !(Map.boundaryE map) bnd_a bnd_b F I V free !eqxx /=.
apply/and3P; split.
- by case: ends => -[-> ->]; rewrite !eqxx ?orbT.
- by case: ifP => _; rewrite eqxx ?orbT.
apply/orP; right; case: es W => ->.
  by rewrite !eqxx (originE map) /= => ->.
by rewrite (negPf (tw_neq map a)) differ (originE map) /= => ->.
Qed.

End Search.
