(** * ExpectationsMissing: rotation systems from which some cycles are missing, and what stores the rest of them

    A surface with a border is a closed one from which some discs are cut out. Their cycles are missing: these do not meet, neither at
    a vertex nor along an edge. A structure may store the rest. A half-edge whose other one is missing has no twin there.

<<
              x                         x is there, and the opposite of x is missing, as is all of the cycle on which it lies;
      ·──────────────►·                 at each of these vertices that is the only one that is missing
      ◄ · · · · · · · ·
>>
*)

From mathcomp Require Import all_ssreflect all_fingroup.
From twinedge Require Import View Rules Loops LoopsProof Map Subdivision RotationSystem ExpectationsBorder.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** The cycle on which an arc lies: see RotationSystem.v. *)
Definition ahead r (x : arcs r) : arcs r := follow (@around r) (@opposite r) x.

Record may_miss r (missing : pred (arcs r)) : Prop := MayMiss {
  whole_cycles : forall x, missing (ahead x) = missing x;
  apart_at_points : forall x y, missing x -> missing y -> from x = from y -> x = y;
  apart_at_edges : forall x, missing x -> ~~ missing (opposite x)
}.

(** The view has the numbers of the arcs that are not missing, and says of them what is so. *)
Record numbered_without t r (missing : pred (arcs r)) (nv : points r -> nat) (nd : arcs r -> nat) : Prop := NumberedWithout {
  points_there : numbers nv (vertex t);
  arcs_differ : forall x y, ~~ missing x -> ~~ missing y -> nd x = nd y -> x = y;
  arcs_there : forall h, half_edge t h <-> exists2 x, ~~ missing x & nd x = h;
  says_of_there : forall x, ~~ missing x ->
    [/\ origin t (nd x) = Some (nv (from x)), twin t (nd x) = if missing (opposite x) then None else Some (nd (opposite x)),
        next t (nd x) = Some (nd (ahead x)) & prev t (nd (ahead x)) = Some (nd x)];
  says_of_point_there : forall v, (exists2 x, ~~ missing x & leaving t (nv v) = Some (nd x) /\ from x = v) \/
    leaving t (nv v) = None /\ forall x, from x <> v
}.

Definition represents_without t r missing := @may_miss r missing /\ exists nv nd, @numbered_without t r missing nv nd.

(** ** A structure that keeps the rules stores such a rest *)

Section Kept.
Variables (t : view) (r : rotation_system) (nv : points r -> nat) (nd : arcs r -> nat).
Hypothesis keeps : open_rules t.
Hypothesis rep : @numbered (whole t) r nv nd.

Notation w := (whole t).
Definition is_new (x : arcs r) := half_edge_slots t <= nd x.

Lemma oldP x : ~~ is_new x -> half_edge t (nd x).
Proof. by rewrite /is_new -ltnNge => lt; rewrite -old_half_edge //; apply: nd_live rep x. Qed.

Lemma newP x : is_new x -> exists2 h, lacks_twin t h & nd x = beside t h.
Proof.
move=> new; case: (wholeP (nd_live rep x)) => // lx; by move: new; rewrite /is_new leqNgt half_edge_below.
Qed.

Lemma is_old x : half_edge t (nd x) -> ~~ is_new x.
Proof. by move=> lx; rewrite /is_new -ltnNge half_edge_below. Qed.

Lemma is_beside x h : nd x = beside t h -> is_new x.
Proof. by rewrite /is_new => ->; apply: leq_addr. Qed.

Lemma whole_without : represents_without t is_new.
Proof.
have cyc x : is_new (ahead x) = is_new x.
  have N : next w (nd x) = Some (nd (ahead x)) := next_nd rep x.
  case: (boolP (is_new x)) => [/newP[h bh E]|/oldP lx].
    by have [g bg []] := next_beside keeps bh; rewrite -E N => -[/is_beside].
  apply/negbTE/is_old; move: N; rewrite next_old //; have [_ _ [n -> ln] _] := lives keeps lx; by move=> [<-].
split; first split=> //.
- move=> x y /newP[g bg Eg] /newP[h bh Eh] E; apply: (nd_inj rep); rewrite Eg Eh; congr beside; apply: (one_into keeps) => //.
  by rewrite -!origin_new // -Eg -Eh !(origin_nd rep) E.
- move=> x /newP[g bg Eg]; apply: is_old; have := twin_nd rep x; rewrite Eg twin_new // => -[<-].
  by case/andP: bg.
exists nv, nd; split.
- exact: points_numbered rep.
- by move=> x y _ _ /(nd_inj rep).
- move=> h; split=> [lh|[x /oldP lx <-]] //.
  by have [x E] := arc_of rep (live_old lh); exists x => //; apply: is_old; rewrite E.
- move=> x ox; have lx := oldP ox; have la : half_edge t (nd (ahead x)) by apply: oldP; rewrite cyc.
  have [O T N P] := says_of_arc rep x; rewrite origin_old // in O; rewrite next_old // in N; rewrite prev_old // in P; split=> //.
  move: T; rewrite twin_old //; case T: (twin t (nd x)) => [g|] [E]; last by rewrite (is_beside (esym E)).
  by rewrite -E ifF //; apply/negbTE/is_old; rewrite -E; apply: heard_live (twin_back keeps T).
move=> v; have lv : vertex t (nv v) := nv_live rep v; have [[_ Hv] _ _ _] := keeps.
case: (says_of_point rep v) => [[x L E]|]; [left|by right]; exists x => //; apply: is_old.
have {}L : leaving t (nv v) = Some (nd x) := L.
by case: (Hv _ lv) => [[h]|[]]; rewrite L // => -[->].
Qed.

End Kept.

(** ** Such a rest keeps the rules, and its whole is the rotation system *)

Section Stored.
Variables (t : view) (r : rotation_system) (missing : pred (arcs r)) (nv : points r -> nat) (nd : arcs r -> nat).
Hypothesis may : may_miss missing.
Hypothesis rep : numbered_without t missing nv nd.

Lemma from_turn (x : arcs r) : from (around r x) = from x.
Proof. by apply/eqP; rewrite eq_sym -around_from porbit_fconnect fconnect1. Qed.

Lemma ahead_opposite (x : arcs r) : ahead (opposite x) = around r x.
Proof. by rewrite /ahead /follow opposite_back. Qed.

Lemma from_ahead (x : arcs r) : from (ahead x) = from (opposite x).
Proof. by rewrite /ahead /follow from_turn. Qed.

Lemma missing_turn x : missing (around r x) = missing (opposite x).
Proof. by rewrite -ahead_opposite whole_cycles. Qed.

Lemma behind x : exists2 y : arcs r, ahead y = x & missing y = missing x.
Proof.
exists (opposite ((around r)^-1%g x)); first by rewrite ahead_opposite permKV.
by rewrite -(whole_cycles may) ahead_opposite permKV.
Qed.

Lemma there x : ~~ missing x -> half_edge t (nd x).
Proof. by move=> mx; apply/(arcs_there rep); exists x. Qed.

Lemma turn_there x : ~~ missing x -> ~~ missing (around r x) -> turn t (nd x) = Some (nd (around r x)).
Proof.
move=> mx; rewrite missing_turn => mo; rewrite /turn; have [_ -> _ _] := says_of_there rep mx; rewrite (negPf mo) /=.
by have [_ _ -> _] := says_of_there rep mo; rewrite ahead_opposite.
Qed.

Lemma turn_missing x : ~~ missing x -> missing (around r x) -> turn t (nd x) = None.
Proof. by move=> mx; rewrite missing_turn => mo; rewrite /turn; have [_ -> _ _] := says_of_there rep mx; rewrite mo. Qed.

Notation other := (fun h => prev t h >>= twin t).

Lemma turn_other_there x : ~~ missing x -> ~~ missing (around r x) -> other (nd (around r x)) = Some (nd x).
Proof.
move=> mx; rewrite missing_turn => mo; rewrite -ahead_opposite; have [_ _ _ ->] := says_of_there rep mo.
by have [_ /= -> _ _] := says_of_there rep mo; rewrite opposite_back (negPf mx).
Qed.

Lemma turn_other_live x h : ~~ missing x -> other (nd x) = Some h -> exists2 y, ~~ missing y & nd y = h /\ from y = from x.
Proof.
move=> mx; have [z zx mz] := behind x; have {}mz : ~~ missing z by rewrite mz.
have [_ T _ P] := says_of_there rep mz; rewrite -zx P /= T; case: ifP => // mo [<-].
by exists (opposite z); rewrite ?mo // from_ahead.
Qed.

Lemma orbit_there n x h : ~~ missing x ->
  iter n (obind (turn t)) (Some (nd x)) = Some h \/ iter n (obind other) (Some (nd x)) = Some h ->
  exists2 y, ~~ missing y & nd y = h /\ from y = from x.
Proof.
move=> mx; elim: n h => [|n IH] h; first by case=> -[<-]; exists x.
rewrite !iterS; case; case E: (iter n _ _) => [k|] // kh.
  have [y my [yk yx]] := IH k (or_introl E); rewrite -yk in kh; case: (boolP (missing (around r y))) => ma.
    by move: kh; rewrite -[obind _ _]/(turn t (nd y)) turn_missing.
  move: kh; rewrite -[obind _ _]/(turn t (nd y)) turn_there // => -[<-]; exists (around r y) => //.
  by rewrite from_turn.
have [y my [yk yx]] := IH k (or_intror E); rewrite -yk in kh.
by have [z mz [zh zy]] := turn_other_live my kh; exists z; rewrite // zy.
Qed.

(** If none is missing on the way, the turns lead there and back. *)
Lemma way_there k x : (forall j, j <= k -> ~~ missing (iter j (around r) x)) ->
  on_orbit (turn t) (nd x) (nd (iter k (around r) x)) /\ on_orbit other (nd (iter k (around r) x)) (nd x).
Proof.
elim: k => [|k IH] free; first by split; exists 0.
have [|[m M] [n N]] := IH; first by move=> j le; apply: free; apply: leqW.
have mk := free k (leqnSn k); have mk1 := free k.+1 (leqnn _); rewrite iterS in mk1 *.
split; first by exists m.+1; rewrite iterS M [obind _ _]/= turn_there.
by exists n.+1; rewrite iterSr [obind _ _]/= turn_other_there.
Qed.

Lemma same_from (x : arcs r) j : from (iter j (around r) x) = from x.
Proof. by elim: j => //= j <-; apply: from_turn. Qed.

Lemma around_connect (x y : arcs r) : from x = from y -> fconnect (around r) x y.
Proof. by move=> E; rewrite -porbit_fconnect around_from E. Qed.

Lemma one_way (x y : arcs r) : ~~ missing x -> ~~ missing y -> from x = from y ->
  exists k, (iter k (around r) x = y /\ forall j, j <= k -> ~~ missing (iter j (around r) x)) \/
            (iter k (around r) y = x /\ forall j, j <= k -> ~~ missing (iter j (around r) y)).
Proof.
move=> mx my E; case: (pickP [pred m | missing m && (from m == from x)]) => [m /andP[mm /eqP mE]|none]; last first.
  exists (findex (around r) x y); left; split; first by apply: iter_findex; apply: around_connect.
  by move=> j _; have /= := none (iter j (around r) x); rewrite same_from eqxx andbT => ->.
have cx := around_connect mE; have cy := around_connect (etrans mE E).
have free a b : ~~ missing a -> from a = from m -> fconnect (around r) m a -> fconnect (around r) m b ->
    findex (around r) m a <= findex (around r) m b ->
    iter (findex (around r) m b - findex (around r) m a) (around r) a = b /\
    forall j, j <= findex (around r) m b - findex (around r) m a -> ~~ missing (iter j (around r) a).
  move=> ma Ea ca cb le; split; first by rewrite -{2}(iter_findex ca) -iterD subnK // iter_findex.
  move=> j lj; apply/negP=> mj; have jm : iter j (around r) a = m.
    by apply: (apart_at_points may) => //; rewrite same_from.
  have : findex (around r) m (iter (j + findex (around r) m a) (around r) m) = j + findex (around r) m a.
    apply: findex_iter; apply: leq_ltn_trans (findex_max cb); rewrite -(subnK le) leq_add2r //.
  rewrite iterD iter_findex // jm findex0 => /esym/eqP; rewrite addn_eq0 => /andP[_ /eqP z].
  by move: (iter_findex ca) ma; rewrite z /= => <-; rewrite mm.
case: (leqP (findex (around r) m x) (findex (around r) m y)) => [le|/ltnW le].
  by eexists; left; apply: free.
by eexists; right; apply: free; rewrite // -E.
Qed.

Lemma without_rules : open_rules t.
Proof.
split; [split| | |].
- move=> h /(arcs_there rep)[x mx <-]; have [O T N P] := says_of_there rep mx; rewrite O T N; split.
  + by exists (nv (from x)) => //; have [_ H] := points_there rep; apply/H; exists (from x).
  + by case: ifP => mo; [right|left; exists (nd (opposite x)) => //; apply: there; rewrite mo].
  + by exists (nd (ahead x)) => //; apply: there; rewrite whole_cycles.
  have [y yx my] := behind x; have {}my : ~~ missing y by rewrite my.
  by have [_ _ _] := says_of_there rep my; rewrite yx => ->; exists (nd y) => //; apply: there.
- move=> v; have [_ H] := points_there rep => /H[p <-].
  case: (says_of_point_there rep p) => [[x mx [L _]]|[L no]]; [left|right; split=> //].
    by exists (nd x) => //; apply: there.
  move=> h /(arcs_there rep)[x mx <-]; have [-> _ _ _] := says_of_there rep mx => -[]; have [inj _] := points_there rep.
  by move/inj/no.
- split=> h /(arcs_there rep)[x mx <-]; have [O T N P] := says_of_there rep mx.
  + rewrite T; case: ifP => // /negbT mo _ /=; have [_ -> _ _] := says_of_there rep mo; rewrite opposite_back (negPf mx).
    by split=> // -[/(arcs_differ rep mo mx) E]; have := opposite_differs x; rewrite E eqxx.
  + have [y yx my] := behind x; have {}my : ~~ missing y by rewrite my.
    have [_ _ Ny Py] := says_of_there rep my; rewrite yx in Ny Py; by rewrite N /= P Py /= Ny.
  rewrite T N; case: ifP => // /negbT mo _ /=; have [-> _ _ _] := says_of_there rep mo.
  have ma : ~~ missing (ahead x) by rewrite whole_cycles.
  by have [-> _ _ _] := says_of_there rep ma; rewrite from_ahead.
- move=> v h; have [inj H] := points_there rep => /H[p <-] L.
  case: (says_of_point_there rep p) => [[x mx [L' E]]|[L' _]]; move: L'; rewrite L // => -[->].
  by have [-> _ _ _] := says_of_there rep mx; rewrite E.
move=> g h /(arcs_there rep)[x mx <-] /(arcs_there rep)[y my <-].
have [-> _ _ _] := says_of_there rep mx; have [-> _ _ _] := says_of_there rep my.
have [inj _] := points_there rep; split=> [o|[/inj E]].
  have [n N] : exists n, iter n (obind (turn t)) (Some (nd x)) = Some (nd y) \/ iter n (obind other) (Some (nd x)) = Some (nd y).
    by case: o => -[n N]; exists n; [left|right].
  by have [z mz [/(arcs_differ rep mz my) <- ->]] := orbit_there mx N.
have [k [[<- free]|[<- free]]] := one_way mx my E; first by left; have [] := way_there free.
by right; have [] := way_there free.
Qed.

Let keeps := without_rules.

Lemma lacks_there x : ~~ missing x -> lacks_twin t (nd x) = missing (opposite x).
Proof.
by move=> mx; rewrite /lacks_twin there //=; have [_ -> _ _] := says_of_there rep mx; case: ifP.
Qed.

Lemma end_there x : ~~ missing x -> end_at t (nd x) = Some (nv (from (opposite x))).
Proof.
move=> mx; rewrite /end_at; have [_ _ -> _] := says_of_there rep mx.
have ma : ~~ missing (ahead x) by rewrite whole_cycles.
by rewrite /=; have [-> _ _ _] := says_of_there rep ma; rewrite from_ahead.
Qed.

Definition whole_number x := if missing x then beside t (nd (opposite x)) else nd x.

Lemma missing_number x : missing x -> exists2 z, z = opposite x /\ ~~ missing z & lacks_twin t (nd z) /\ whole_number x = beside t (nd z).
Proof.
move=> mx; have mo := apart_at_edges may mx; exists (opposite x) => //; rewrite lacks_there // opposite_back mx.
by rewrite /whole_number mx.
Qed.

Lemma there_number x : ~~ missing x -> whole_number x = nd x.
Proof. by rewrite /whole_number => /negPf->. Qed.

Lemma without_whole : represents_rotations (whole t) r.
Proof.
exists nv, whole_number; split.
- exact: points_there rep.
- split=> [x y|i].
    case: (boolP (missing x)) => [/missing_number[z [-> mz] [_ ->]]|mx]; case: (boolP (missing y)) => [/missing_number[u [uE mu] [_ ->]]|my].
    + by move/beside_inj/(arcs_differ rep mz mu); rewrite uE => /(can_inj (@opposite_back r)).
    + by rewrite there_number // => /esym/old_differs; case; apply: there.
    + by rewrite there_number // => /old_differs; case; apply: there.
    by rewrite !there_number //; apply: (arcs_differ rep).
  split=> [/wholeP[/(arcs_there rep)[x mx <-]|[h bh ->]]|[x <-]].
  + by exists x; rewrite there_number.
  + have [/(arcs_there rep)[x mx xh] _] := andP bh; rewrite -xh lacks_there // in bh; exists (opposite x).
    by rewrite /whole_number bh opposite_back xh.
  case: (boolP (missing x)) => [/missing_number[z _ [bz ->]]|mx]; first by rewrite live_new.
  by rewrite there_number //; apply: live_old; apply: there.
- move=> x; rewrite -/(ahead x); case: (boolP (missing x)) => mx; last first.
    have ma : ~~ missing (ahead x) by rewrite whole_cycles.
    have [O T N P] := says_of_there rep mx; have lx := there mx; have la := there ma.
    rewrite !(there_number mx) (there_number ma) origin_old // next_old // prev_old // twin_old // O N P T.
    by split=> //; rewrite /whole_number; case: ifP; rewrite ?opposite_back.
  have ma : missing (ahead x) by rewrite whole_cycles.
  have [z [zE mz] [bz ->]] := missing_number mx; have [u [uE mu] [bu ->]] := missing_number ma.
  have [Oz _ _ _] := says_of_there rep mz; have Eu : end_at t (nd u) = Some (nv (from z)).
    by rewrite end_there // uE opposite_back from_ahead zE.
  rewrite origin_new // twin_new // next_new // prev_new // Oz Eu (border_into_at keeps bu Eu) (border_from_at keeps bz Oz) end_there //.
  by rewrite zE opposite_back there_number // -zE.
move=> v; case: (says_of_point_there rep v) => [[x mx [L E]]|]; [left|by right].
by exists x => //; rewrite there_number.
Qed.

End Stored.

(** So the rules mean such a rest: of some rotation system, which is that of the whole. *)
Theorem open_rules_mean_missing t :
  open_rules t <-> exists r missing, @represents_without t r missing.
Proof.
split=> [keeps|[r [missing [may [nv [nd rep]]]]]]; last exact: without_rules may rep.
have [r [nv [nd rep]]] := (surface_rules_mean_rotations _).1 (whole_rotations keeps).
exists r, (is_new t nd); exact: (whole_without keeps rep).
Qed.
