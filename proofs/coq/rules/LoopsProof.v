(** * LoopsProof: what each loop of the checker computes *)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import Arith View Loops.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** ** For loops *)

Lemma all_belowP n (p : pred nat) : reflect (forall i, i < n -> p i) (all_below n p).
Proof.
elim: n => [|n IH] /=; first by constructor.
case pn: (p n); last by constructor=> H; rewrite H in pn.
apply: (iffP IH) => H i; last by move=> ?; apply: H; apply: leqW.
by rewrite ltnS leq_eqVlt => /orP[/eqP->|/H].
Qed.

(** A loop over live slots. *)
Lemma each_liveP n (live p : pred nat) : (forall i : nat, live i -> i < n) ->
  reflect (forall i, live i -> p i) (all_below n (fun i => if live i then p i else true)).
Proof.
move=> below; apply: (iffP (all_belowP _ _)) => H i.
  by move=> l; have := H i (below i l); rewrite l.
by move=> _; case: ifP => // /H.
Qed.

Lemma iotaS_cat n : iota 0 n.+1 = iota 0 n ++ [:: n].
Proof. by rewrite -addn1 iotaD. Qed.

Lemma tallyE n key k : read (tally n key) k = count (fun i => key i == Some k) (iota 0 n).
Proof.
rewrite /tally /read; set f := fun _ _ => _.
suff H m : fold_below n f m k = count (fun i => key i == Some k) (iota 0 n) + m k by rewrite H addn0.
elim: n m => [|n IH] m; first by [].
rewrite iotaS_cat count_cat /= IH addn0 -addnA; congr (_ + _).
rewrite /f; case E: (key n) => [j|] //=; rewrite /write /read.
by rewrite -[Some j == _]/(j == k) eq_sym; case: eqP => [->|] //=; rewrite addn1.
Qed.

(** The value that is recalled is that of some number with that key, and there is a value if there is such a number. *)
Lemma recallP n key value k :
  if has (fun i => key i == Some k) (iota 0 n)
  then exists i, [/\ i < n, key i = Some k & read (recall n key value) k = value i]
  else read (recall n key value) k = None.
Proof.
suff H m : if has (fun i => key i == Some k) (iota 0 n)
  then exists i, [/\ i < n, key i = Some k &
    fold_below n (fun m i => if key i is Some k then write m k (value i) else m) m k = value i]
  else fold_below n (fun m i => if key i is Some k then write m k (value i) else m) m k = m k.
  exact: H.
elim: n m => [|n IH] m; first by [].
rewrite iotaS_cat has_cat [has _ [:: n]]/= orbF [fold_below _ _ _]/=.
move: (IH (if key n is Some k then write m k (value n) else m)).
case: ifP => ha.
  by case=> i [lt keyi e]; exists i; split=> //; apply: leqW.
move=> ->; rewrite ?ha /=.
case E: (key n) => [j|] //=; rewrite /write.
case: eqP => [[jk]|ne]; first by exists n; split; rewrite ?E ?jk ?eqxx.
by case: eqP => // kj; case: ne; rewrite kj.
Qed.

(** ** Live slots as a finite type

    [step says x] is where the answer leads, or [x] itself where it leads nowhere. *)

Section Slots.
Variables (n : nat) (live : nat -> bool).
Hypothesis below : forall i, live i -> i < n.

Definition slot : predArgType := {i : 'I_n | live i}.
Definition num (x : slot) : nat := val (val x).

Lemma num_inj : injective num.
Proof. by move=> x y /val_inj/val_inj. Qed.

Lemma num_live x : live (num x).
Proof. exact: (valP x). Qed.

Definition at_slot i (l : live i) : slot := exist (fun o : 'I_n => live o) (Ordinal (below l)) l.

Lemma num_at i (l : live i) : num (at_slot l) = i.
Proof. by []. Qed.

Lemma slotP i : live i -> exists x, num x = i.
Proof. by move=> l; exists (at_slot l). Qed.

Definition pick_slot (l : link) : option slot :=
  if l is Some i then (if insub i : option 'I_n is Some o then insub o else None) else None.

Lemma pick_num x : pick_slot (Some (num x)) = Some x.
Proof. by rewrite /pick_slot /num valK valK. Qed.

Lemma pick_live i x : pick_slot (Some i) = Some x -> num x = i.
Proof. by rewrite /pick_slot; case: insubP => // o _ <-; case: insubP => // y _ yo [<-]; rewrite /num yo. Qed.

Lemma card_slot : #|{: slot}| <= n.
Proof. by rewrite card_sub; apply: leq_trans (max_card _) _; rewrite card_ord. Qed.

(** Counting below [n] is counting slots. *)
Lemma count_slots (p : nat -> bool) : (forall i, p i -> live i) ->
  count p (iota 0 n) = #|[pred x : slot | p (num x)]|.
Proof.
move=> pl; rewrite cardE -size_filter -(size_map num); apply: perm_size; apply: uniq_perm.
- exact: filter_uniq (iota_uniq _ _).
- by rewrite (map_inj_uniq num_inj) enum_uniq.
move=> i; rewrite mem_filter mem_iota add0n /=; apply/andP/mapP => [[pi _]|[x]].
  by exists (at_slot (pl _ pi)); rewrite ?mem_enum.
by rewrite mem_enum inE => px ->; split=> //; apply: below; apply: num_live.
Qed.

Section Step.
Variable says : nat -> link.

Definition step (x : slot) : slot := odflt x (pick_slot (says (num x))).

Lemma stepP x y : says (num x) = Some (num y) -> step x = y.
Proof. by rewrite /step => ->; rewrite pick_num. Qed.

Hypothesis total : forall i, live i -> exists2 j, says i = Some j & live j.

Lemma says_step x : says (num x) = Some (num (step x)).
Proof.
case: (total (num_live x)) => j E l; rewrite E; case: (slotP l) => y yj.
by rewrite (@stepP x y) ?E ?yj.
Qed.

Lemma iter_step k x : iter k (obind says) (Some (num x)) = Some (num (iter k step x)).
Proof. by elim: k => //= k ->; rewrite /= says_step. Qed.

Lemma on_orbit_step x y : on_orbit says (num x) (num y) <-> fconnect step x y.
Proof.
split=> [[k]|/iter_findex <-]; last by exists (findex step x y); rewrite iter_step.
by rewrite iter_step => -[] /num_inj <-; apply: fconnect_iter.
Qed.

Lemma on_orbit_live x i : on_orbit says (num x) i -> live i.
Proof. by case=> k; rewrite iter_step => -[] <-; apply: num_live. Qed.

(** *** A walk that returns takes as many steps as its orbit has elements *)

Hypothesis back : injective step.

Lemma round_tripE x : round_trip n says (num x) = Some (order step x).
Proof.
suff H fuel i : i < order step x -> order step x <= fuel + i ->
    walk fuel says (num x) (num (iter i step x)) i = Some (order step x).
  by apply: (H n 0); rewrite ?order_gt0 // addn0 (leq_trans (max_card _)) ?card_slot.
elim: fuel i => [|fuel IH] i lt; first by rewrite add0n leqNgt lt.
rewrite addSnnS /= says_step -iterS => le; case: eqP => [/num_inj E|ne].
  congr Some; apply/eqP; rewrite eqn_leq lt leqNgt /=; apply/negP=> lt'.
  by have := findex_iter lt'; rewrite E findex0.
apply: IH => //; rewrite ltn_neqAle lt andbT; apply/eqP=> E; apply: ne.
by rewrite E iter_order.
Qed.

End Step.
End Slots.

(** ** An orbit with one key is all that has the key if it is as large *)

Lemma orbit_fullP (T : finType) (K : eqType) (f : T -> T) (key : T -> K) x : (forall y, key (f y) = key y) ->
  reflect (forall y, key y = key x -> fconnect f x y) (order f x == #|[pred y | key y == key x]|).
Proof.
move=> const.
have sub : fconnect f x \subset [pred y | key y == key x].
  apply/subsetP=> y; rewrite inE => /iter_findex <-; rewrite inE; apply/eqP.
  by elim: (findex _ _ _) => //= k <-; apply: const.
rewrite /order; apply: (iffP eqP) => [eq y k|full].
  by have := elimT (subset_cardP eq) sub y; rewrite !inE k eqxx.
apply: eq_card => y; rewrite !inE; apply/idP/eqP => [c|/full //].
by have := subsetP sub y; rewrite inE => /(_ c); rewrite inE => /eqP.
Qed.

(** ** Flood *)

Section Flood.
Variables (fuel n : nat) (live : pred nat) (near : nat -> seq nat).
Hypothesis below : forall i, live i -> i < n.
Hypothesis near_live : forall x y, live x -> y \in near x -> live y.
Hypothesis near_sym : forall x y, live x -> y \in near x -> x \in near y.
Hypothesis enough : sumn [seq size (near x) | x <- iota 0 n] + 1 < fuel.

Inductive reached r : nat -> Prop :=
  | reached_self : reached r r
  | reached_near x y : reached r x -> y \in near x -> reached r y.

Lemma reached_trans x y z : reached x y -> reached y z -> reached x z.
Proof. by move=> xy; elim=> // u w _ xu uw; apply: reached_near xu uw. Qed.

Lemma reached_live x y : live x -> reached x y -> live y.
Proof. by move=> lx; elim=> // u w _ lu uw; apply: near_live lu uw. Qed.

Lemma reached_sym x y : live x -> reached x y -> reached y x.
Proof.
move=> lx; elim=> [|u w xu ux uw]; first exact: reached_self.
by apply: reached_trans ux; apply: reached_near (reached_self _) _; apply: near_sym uw; apply: reached_live xu.
Qed.

(** Each labelled number has the label of one that reaches it; each of its neighbours is labelled, too, or it waits on the stack. *)
Definition sound (label : memory link) := forall x r, label x = Some r -> [/\ live x, live r & reached r x].
Definition waits root (stack : seq nat) (label : memory link) := forall x y r, label x = Some r -> y \in near x ->
  label y = Some r \/ [/\ label y = None, r = root & y \in stack].
(** The numbers that may still be pushed. *)
Definition weight (label : memory link) := sumn [seq (if label i is Some _ then 0 else size (near i)) | i <- iota 0 n].

Lemma weight_write label x r : x < n -> label x = None ->
  weight label = weight (write label x (Some r)) + size (near x).
Proof.
move=> lt none; rewrite /weight /write.
have -> : iota 0 n = iota 0 x ++ x :: iota x.+1 (n - x.+1).
  by rewrite -[x in iota x.+1 _]add0n -[x :: _]/(iota x (n - x.+1).+1) subnSK // -{2}[x]add0n -iotaD subnKC // ltnW.
have f m k : x < m \/ m + k <= x ->
    [seq (if (if i == x then Some r else label i) is Some _ then 0 else size (near i)) | i <- iota m k]
    = [seq (if label i is Some _ then 0 else size (near i)) | i <- iota m k].
  move=> out; apply/eq_in_map => i; rewrite mem_iota => /andP[mi im].
  by case: (i =P x) => // e; rewrite e in mi im; case: out; [rewrite ltnNge mi | rewrite leqNgt im].
rewrite !map_cat !sumn_cat /= none !eqxx /= add0n.
by rewrite (f 0 x); [rewrite (f x.+1) //; [arith|left] | right].
Qed.

Lemma flood_spec k root stack label :
  live root -> sound label -> waits root stack label -> (forall x, x \in stack -> live x /\ reached root x) ->
  weight label + size stack < k ->
  let after := flood k near root stack label in
  [/\ sound after, waits root [::] after, forall x r, label x = Some r -> after x = Some r
    & forall x, x \in stack -> after x <> None].
Proof.
move=> lroot; elim: k stack label => // k IH [|h rest] label ok wait on lt /=; first by split.
have [lh rh] := on h (mem_head _ _).
case lab: (read label h) => [r|]; rewrite /read in lab.
  have [|||s1 s2 s3 s4] := IH rest label ok _ _ _.
  - move=> x y s sx xy; case: (wait x y s sx xy) => [|[none -> ]]; first by left.
    by rewrite inE => /orP[/eqP e|]; [rewrite e lab in none | right].
  - by move=> x xr; apply: on; rewrite inE xr orbT.
  - by move: lt; rewrite /= addnS ltnS.
  by split=> // x; rewrite inE => /orP[/eqP->|/s4 //]; rewrite (s3 _ _ lab).
set label' := write label h (Some root).
have same x : x != h -> label' x = label x by rewrite /label' /write => /negPf->.
have self : label' h = Some root by rewrite /label' /write eqxx.
have [||||s1 s2 s3 s4] := IH (catrev (near h) rest) label' _ _ _ _.
- move=> x r; case: (eqVneq x h) => [->|/same->]; last exact: ok.
  by rewrite self => -[<-].
- move=> x y r lx xy; rewrite catrevE mem_cat mem_rev.
  case: (eqVneq x h) lx => [e|ne]; rewrite ?e in xy *.
    rewrite self => -[<-]; rewrite xy.
    case: (eqVneq y h) => [->|/same e']; first by left.
    rewrite e'; case ly: (label y) => [s|]; last by right.
    left; have := wait y h s ly (near_sym lh xy).
    by rewrite lab => -[//|[_ -> _]].
  rewrite (same _ ne) => lx; case: (wait x y r lx xy) => [ly|[ly er]].
    by left; rewrite same //; apply/eqP=> e; rewrite -e ly in lab.
  rewrite inE; case: (eqVneq y h) => [-> _|ney /= yr]; first by left; rewrite self er.
  by right; rewrite same // yr orbT.
- move=> x; rewrite catrevE mem_cat mem_rev => /orP[xh|xr]; last by apply: on; rewrite inE xr orbT.
  by split; [apply: near_live xh | apply: reached_near rh xh].
- by move: lt; rewrite (weight_write root (below lh) lab) -/label' /= catrevE size_cat size_rev; arith.
split=> // x; last first.
  rewrite inE => /orP[/eqP->|xr]; first by rewrite (s3 _ _ self).
  by apply: s4; rewrite catrevE mem_cat xr orbT.
by move=> r lx; apply: s3; rewrite same //; apply/eqP=> e; rewrite e lab in lx.
Qed.

Definition closed (label : memory link) := forall x y r, label x = Some r -> y \in near x -> label y = Some r.

Lemma flood_allP : let label := flood_all fuel n live near in
  [/\ forall x, live x -> exists r, label x = Some r, sound label & closed label].
Proof.
rewrite /flood_all; set f := fun _ _ => _.
suff H m label : m <= n -> sound label -> closed label ->
    let after := fold_below m f label in
    [/\ sound after, closed after, forall x r, label x = Some r -> after x = Some r
      & forall x, x < m -> live x -> after x <> None].
  have [||s1 s2 _ s4] := H n (blank None) (leqnn n) _ _; [by []|by []|].
  by split=> // x lx; case E: (_ x) (s4 x (below lx) lx) => [r|//] _; exists r.
elim: m label => [|m IH] label le ok cl; first by split.
rewrite [fold_below _ _ _]/=.
have [b1 b2 b3 b4] : [/\ sound (f label m), closed (f label m), forall x r, label x = Some r -> f label m x = Some r
      & live m -> f label m m <> None].
  rewrite /f; case lm: (live m); last by split.
  case E: (read label m) => [r|]; first by split=> // _; rewrite /read in E; rewrite E.
  have [|||s1 s2 s3 s4] := @flood_spec fuel m [:: m] label lm ok _ _ _.
  - by move=> x y r lx xy; left; apply: cl lx xy.
  - by move=> x; rewrite inE => /eqP->; split; [|apply: reached_self].
  - apply: leq_ltn_trans enough; rewrite leq_add2r /weight; elim: (iota 0 n) => //= i s le'.
    by apply: leq_add => //; case: (label i).
  split=> // [x y r lx xy|_]; last by apply: s4; rewrite inE.
  by case: (s2 x y r lx xy) => // -[].
have [s1 s2 s3 s4] := IH _ (ltnW le) b1 b2.
split=> // [x r /b3/s3 //|x]; rewrite ltnS leq_eqVlt => /orP[/eqP->|/s4 //] lm.
by case E: (f label m m) (b4 lm) => [r|//] _; rewrite (s3 _ _ E).
Qed.

(** Live numbers are labelled, and labels are the same where one is reached from the other. *)
Theorem flood_allE x y : live x -> live y ->
  flood_all fuel n live near x = flood_all fuel n live near y <-> reached x y.
Proof.
have [lab ok cl] := flood_allP => lx ly; split.
  case: (lab x lx) => r xr; rewrite xr => /esym yr.
  have [_ lr rx] := ok x r xr; have [_ _ ry] := ok y r yr.
  by apply: reached_trans ry; apply: reached_sym rx.
case: (lab x lx) => r xr xy; rewrite xr; apply/esym.
by elim: xy => // u w _ ur uw; apply: cl ur uw.
Qed.

Theorem flood_all_live x : live x -> exists r, flood_all fuel n live near x = Some r.
Proof. by case: flood_allP => + _ _ => /[apply]. Qed.

Theorem flood_all_label x r : flood_all fuel n live near x = Some r -> [/\ live x, live r & flood_all fuel n live near r = Some r].
Proof.
case: flood_allP => lab ok cl xr; have [lx lr rx] := ok x r xr; split=> //.
by rewrite (flood_allE lr lx).2.
Qed.

End Flood.

(** ** Climb *)

Section Climb.
Variables (n : nat) (live : nat -> bool) (up : nat -> link).
Hypothesis below : forall i, live i -> i < n.
Hypothesis up_live : forall x y, live x -> up x = Some y -> live y.

(** Steps upwards end. *)
Inductive climbs : nat -> Prop :=
  | climbs_top x : up x = None -> climbs x
  | climbs_up x y : up x = Some y -> climbs y -> climbs x.

Lemma climb_sound fuel (good : memory bool) (path : seq nat) x path' :
  (forall y, read good y -> climbs y) -> (forall y, y \in path -> climbs x -> climbs y) ->
  climb fuel up good path x = Some path' -> climbs x /\ forall y, y \in path' -> climbs y.
Proof.
move=> ok; elim: fuel path x => [|fuel IH] path x on /=; case: ifP => [/ok cx [<-]|_]; try by split=> // y /on; apply.
  case E: (up x) => [//|] [<-]; have cx := climbs_top E.
  by split=> // y; rewrite inE => /orP[/eqP-> //|/on]; apply.
case E: (up x) => [z|]; last first.
  move=> [<-]; have cx := climbs_top E.
  by split=> // y; rewrite inE => /orP[/eqP-> //|/on]; apply.
move/IH => [|cz all]; last by split=> //; apply: climbs_up cz.
move=> y; rewrite inE => /orP[/eqP->|yp] cz; first exact: climbs_up cz.
by apply: on yp _; apply: climbs_up cz.
Qed.

(** So many steps upwards are enough. *)
Fixpoint climbs_in k x := if up x is Some y then if k is j.+1 then climbs_in j y else false else true.

Lemma climb_complete fuel good path x : climbs_in fuel x -> climb fuel up good path x <> None.
Proof.
elim: fuel path x => [|fuel IH] path x /=; case: ifP => // _; case: (up x) => // y; exact: IH.
Qed.

Lemma climbs_steps x : live x -> climbs x -> climbs_in n x.
Proof.
move=> lx cx.
pose T := slot n live; pose U := @step n live up.
have [u ux] := slotP below lx.
have total y : up (num y) = None \/ up (num y) = Some (num (U y)).
  case E: (up (num y)) => [z|]; [right|by left].
  have [w wz] := slotP below (up_live (num_live y) E).
  by rewrite -wz in E *; congr Some; rewrite /U (stepP E).
have stays y : up (num y) = None -> U y = y by rewrite /U /step => ->.
have top i (y : T) : up (num (iter i U y)) = None -> climbs_in i (num y).
  elim: i y => [|i IH] y /=; first by move=> ->.
  by case: (total y) => -> //; rewrite -iterS iterSr; apply: IH.
have more i k (y : T) : climbs_in i (num y) -> i <= k -> climbs_in k (num y).
  elim: i k y => [|i IH] [|k] y //=; case: (total y) => -> //; exact: IH.
have [v uv vt] : exists2 v, fconnect U u v & up (num v) = None.
  rewrite -ux in cx; elim: {x lx ux} (num u) / cx {-2}u (erefl (num u)) => [x E|x y E _ IH] w ew.
    by exists w; rewrite ?ew.
  rewrite -ew in E; case: (total w); rewrite E // => -[wy].
  by have [v cv vt] := IH (U w) (esym wy); exists v => //; apply: connect_trans cv; apply: fconnect1.
rewrite -ux; apply: (more (findex U u v)); first by apply: top; rewrite iter_findex.
apply: leq_trans (card_slot n live).
by apply: leq_trans (max_card _); apply: ltnW; apply: findex_max.
Qed.

Lemma mark_sound (path : seq nat) (good : memory bool) : (forall y, read good y -> climbs y) -> (forall y, y \in path -> climbs y) ->
  forall y, read (mark path good) y -> climbs y.
Proof.
elim: path good => [|x path IH] good ok on //=; apply: IH; last by move=> y yp; apply: on; rewrite inE yp orbT.
by rewrite /read /write => y; case: eqP => [-> _|_ /ok //]; apply: on; apply: mem_head.
Qed.

Theorem all_climbP m : reflect (forall x, x < m -> live x -> climbs x) (all_climb n m live up (blank false)).
Proof.
have : forall y, read (blank false) y -> climbs y by [].
elim: m (blank false) => [|m IH] good ok /=; first by constructor.
case lm: (live m); last first.
  apply: (iffP (IH _ ok)) => H x; last by move=> ?; apply: H; apply: leqW.
  by rewrite ltnS leq_eqVlt => /orP[/eqP->|/H //]; rewrite lm.
case E: (climb _ _ _ _ _) => [path|].
  have [|cm on] := climb_sound ok _ E; first by [].
  apply: (iffP (IH _ (mark_sound ok on))) => H x; last by move=> ?; apply: H; apply: leqW.
  by rewrite ltnS leq_eqVlt => /orP[/eqP->|/H //].
constructor=> H; apply: (climb_complete _ E); apply: climbs_steps => //.
by apply: H.
Qed.

End Climb.

(** ** Any walk that returns visits different numbers, each of which leads to one of them *)

Section Circuit.
Variable step : nat -> link.
Let after y := odflt 0 (step y).

Lemma round_tripP fuel x k : round_trip fuel step x = Some k ->
  let s := traject after x k in
  [/\ x \in s, uniq s, forall y, y \in s -> exists2 z, step y = Some z & z \in s
    & forall y, y \in s -> (exists2 z, step z = Some y & z \in s) /\ on_orbit step x y].
Proof.
have main n i : walk n step x (iter i after x) i = Some k ->
    [/\ i < k, forall j, i <= j < k -> step (iter j after x) = Some (iter j.+1 after x), iter k after x = x
      & forall j, i < j < k -> iter j after x != x].
  elim: n i => //= n IH i; case E: (step (iter i after x)) => [y|] //.
  have yE : y = iter i.+1 after x by rewrite /= /after E.
  have only j : i <= j < i.+1 -> j = i by move=> ?; arith.
  case: eqP => [yx [<-]|/eqP yx].
    split=> [|j /only->|//|j]; [exact: leqnn|by rewrite E yE|by rewrite -yE yx|].
    by case/andP=> a; rewrite ltnS leqNgt a.
  rewrite yE => /IH[lt st back no]; split=> // [|j /andP[ij jk]|j /andP[ij jk]].
  - exact: ltnW.
  - case: (ltngtP i j) ij => // [ij _|ij _]; first by apply: st; rewrite ij.
    by rewrite -ij E yE.
  - case: (ltngtP i.+1 j) ij => // [ij _|<- _]; first by apply: no; rewrite ij.
    by rewrite -yE.
move/(main fuel 0)=> [k0 st back no] s.
have mem y : y \in s -> exists2 j, j < k & y = iter j after x by move/trajectP=> [j jk ->]; exists j.
have inn j : j < k -> iter j after x \in s by move=> jk; apply/trajectP; exists j.
split.
- exact: (inn 0).
- rewrite /s -(prednK k0) looping_uniq; apply/negP=> /trajectP[i lt E].
  have := no i.+1; rewrite /= -E -iterS prednK // back eqxx => H.
  have lt' : i.+1 < k by arith.
  by have := H lt'.
- move=> y /mem[j jk ->]; exists (iter j.+1 after x); first by apply: st.
  by case: (ltngtP j.+1 k) jk => // [/inn //|e _]; rewrite e back; apply: (inn 0).
move=> y /mem[j jk ->]; split.
  case: j jk => [|j] jk; last by exists (iter j after x); [apply: st; apply: ltnW | apply: inn; apply: ltnW].
  exists (iter k.-1 after x); last by apply: inn; arith.
  by rewrite st ?prednK ?back // leq0n /=; arith.
exists j; elim: j jk => //= j IH jk; rewrite IH //=; last exact: ltnW.
by rewrite st //; apply: ltnW.
Qed.

End Circuit.

(** Two steps that agree on the orbit make the same walk. *)
Lemma round_trip_eq fuel step step' x : (forall y, on_orbit step x y -> step y = step' y) ->
  round_trip fuel step x = round_trip fuel step' x.
Proof.
move=> same; rewrite /round_trip.
suff H y i : on_orbit step x y -> walk fuel step x y i = walk fuel step' x y i by apply: H; exists 0.
elim: fuel y i => //= fuel IH y i xy; rewrite -same //; case E: (step y) => [z|] //.
case: eqP => // _; apply: IH; case: xy => n En; exists n.+1; by rewrite iterS En.
Qed.
