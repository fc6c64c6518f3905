(** * ExpectationsPlane: of the closed plane with every part, the rules over expectations are those of Rules.v *)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import Arith View Rules Loops LoopsProof Reference ReferenceProof Map Counting Lists.
From twinedge Require Import TopologyProof Verdict.
From twinedge Require Import Expectations ExpectationsCheck ExpectationsLists ExpectationsProof ExpectationsVerdict.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** ** Induction along steps that never return, in a finite set *)

Lemma walks_first step (x y : nat) : walks step x y -> x = y \/ exists2 z, step x z & walks step z y.
Proof.
elim=> [|u w xu [->|[z xz zu]] uw]; first by left.
  by right; exists w => //; apply: walks_nowhere.
by right; exists z => //; apply: walks_on zu uw.
Qed.

Lemma acyclic_ind (step : nat -> nat -> Prop) (all : seq nat) (P : nat -> Prop) :
  (forall x y, step x y -> ~ walks step y x) ->
  (forall x, x \in all -> (forall y, step x y -> y \in all -> P y) -> P x) -> forall x, x \in all -> P x.
Proof.
move=> acyclic ind.
suff H n x past : x \in all -> (forall z, z \in past -> exists2 y, step z y & walks step y x) -> uniq past -> {subset past <= all} ->
    size all <= n + size past -> P x by move=> x xa; apply: (H (size all) x [::]); rewrite ?addn0.
elim: n x past => [|n IH] x past xa led u sub le.
  have xp : x \notin past by apply/negP=> /led[y /acyclic].
  have: size (x :: past) <= size all by apply: uniq_leq_size; rewrite /= ?xp // => z; rewrite inE => /orP[/eqP->|/sub].
  by rewrite /= => lt; have := leq_trans lt le; rewrite ltnn.
have xp : x \notin past by apply/negP=> /led[y /acyclic].
apply: ind => // y xy ya; apply: (IH y (x :: past)) => //=.
- move=> z; rewrite inE => /orP[/eqP->|/led[w zw wx]]; last by exists w => //; apply: walks_on wx xy.
  by exists y => //; apply: walks_nowhere.
- by rewrite xp.
- by move=> z; rewrite inE => /orP[/eqP->|/sub].
by rewrite addnS.
Qed.

(** ** Least ones are one of each *)

Lemma least_one_of_each xs (same : nat -> nat -> Prop) (r : nat -> nat -> bool) (P : nat -> Prop) :
  (forall x y, reflect (same x y) (r x y)) -> (forall x, same x x) -> (forall x y, P x -> same x y -> P y /\ same y x) ->
  (forall x y z, same x y -> same y z -> same x z) ->
  lists xs (fun x => P x /\ least same x) -> lists_one_of_each xs same P.
Proof.
move=> dec refl sym trans [u mem]; split=> // [x /mem[] //|x y /mem[Px Lx] /mem[Py Ly] xy|x].
  case: (ltngtP x y) => // lt; last by case: (Lx y lt).
  by case: (Ly x lt); have [] := sym x y Px xy.
elim/ltn_ind: x => x IH Px; case E: (has (r x) (iota 0 x)).
  case/hasP: E => y; rewrite mem_iota => lt /dec xy; have [Py yx] := sym x y Px xy.
  by have [z zx zy] := IH y lt Py; exists z => //; apply: trans zy yx.
exists x => //; apply/mem; split=> // y lt /dec xy.
by move/hasPn: E => /(_ y); rewrite mem_iota lt xy => /(_ isT).
Qed.

Section Plane.
Variables (t : view) (sf so : nat -> link) (si : nat -> nat -> option start).
Let s := Structure t all_parts sf so si.
Notation agrees r := (holds_of plane s (Basic r) <-> holds t r).

Lemma same_r1 : agrees R1.
Proof.
split=> [[H V B F S]|[[H V B F] S]]; split=> //.
- split=> //.
  + by move=> h /H[O [T|] //] N /(_ isT)P /(_ isT)[D|[]//].
  + by move=> v /V[/(_ isT)].
  + move=> f /F[O I]; split=> //; move: O; rewrite /has_outer /= -[outer _ f]/(outer t f).
    by case: (outer t f) => [b|] O; [right; apply: O | left].
- by move=> h /H[O T N P D]; split=> //; left.
- by move=> v /V[L I].
move=> f /F[O I]; split=> // ; rewrite /has_outer /= -[outer _ f]/(outer t f).
by case: O => [->|].
Qed.

Lemma same_l1 : agrees L1. Proof. by split=> H h lh; [apply: H | move=> _; apply: H]. Qed.
Lemma same_l2 : agrees L2. Proof. by []. Qed.
Lemma same_l3 : agrees L3. Proof. by split=> H h lh; [apply: H | move=> _; apply: H]. Qed.
Lemma same_v1 : agrees V1. Proof. by []. Qed.

Lemma same_v2 : agrees V2.
Proof.
split=> H g h lg lh; split.
- by move=> o; apply/(H g h lg lh); left.
- by move/(H g h lg lh)=> [|[]].
- by case=> [|[]//]; move/(H g h lg lh).
- by move/(H g h lg lh); left.
Qed.

Lemma same_b1 : agrees B1.
Proof. by split=> -[C D]; split=> // h; apply: C. Qed.

Lemma same_b2 : agrees B2.
Proof.
split=> [H v lv|H _ v lv].
  have [one [none iso]] := H isT v lv; split=> bare_v; last first.
    by split; [case E: (isolated t v) => [c|] //; case: (none bare_v c); apply/(iso c) | apply: none].
  have [[c [S U]]|[]//] := one bare_v; exists c; split; first exact/iso.
  by move=> d; split=> [/U ->|->].
have [one none] := H v lv; split; [|split].
- by case/one=> b [_ S]; left; exists b; split=> [|c /S ->] //; apply/S.
- by case/none.
move=> b; have [bb|] := @bareP plane s v.
  have [c [I S]] := one bb; rewrite -[isolated _ v]/(isolated t v) I; split=> [[<-]|/S-> //]; exact/S.
by case/none=> I N; split=> [|/N //]; rewrite -[isolated _ v]/(isolated t v) I.
Qed.

Lemma same_f1 : agrees F1.
Proof.
have un f : is_unbounded plane s f <-> unbounded t f.
  rewrite /is_unbounded /has_outer /= -[outer _ f]/(outer t f) /unbounded.
  by split=> -[lf]; case: (outer t f).
split=> [/(_ isT)[[f [U one]] O]|[[f [U one]] O] _]; (split; [exists f; split=> [|g /un/one //]; exact/un|]).
  by move=> g b v E S; apply: (O g v); rewrite /entry_start /= -[outer _ g]/(outer t g) E.
move=> g v; rewrite /entry_start /= -[outer _ g]/(outer t g).
by case E: (outer t g) => [b|] //= S; apply: O E S.
Qed.

Lemma same_f2 : agrees F2.
Proof.
split=> H b lb; have [f [p [Ef Ep L]]] := H b lb; exists f, p; split=> //; exact: Ep.
Qed.

(** ** T1 to T4, where R1 to F2 hold *)

Section Lower.
Hypothesis low : lower t.
Let map := low_map low.

Lemma same_linked u w : linked plane s u w <-> connected t u w.
Proof.
split; first by elim=> [|v x _ IH [h Eo Et]]; [apply: connected_self | apply: connected_edge IH Eo Et].
by elim=> [|h v x _ IH Eo Et]; [apply: walks_nowhere | apply: walks_on IH _; exists h].
Qed.

Lemma outside_live v b : outside_of t v b -> boundary t b.
Proof. by case=> -[i P] _; apply: heard_live P. Qed.

Lemma same_entry_start f p b : listed t f p = Some b -> entry_start plane s f p = boundary_start t b.
Proof. by move=> L; rewrite -[entry_start _ _ _ _]/(listed t f p >>= boundary_start t) L. Qed.

Lemma vertex_of_listed f p b : listed t f p = Some b -> vertex_of plane s (entry_start plane s f p) = vertex_at t b.
Proof. by move/same_entry_start->. Qed.

(** An entry is the outside of a component if it is a boundary component that is. *)
Lemma same_outside v f p : outside_entry plane s v (f, p) <-> exists2 b, listed t f p = Some b & outside_of t v b.
Proof.
split=> [[inn [w W /same_linked vw]]|[b L [[i I] [w W vw]]]] /=.
  move: W; rewrite -[entry_start _ _ _ _]/(listed t f p >>= boundary_start t); case L: (listed t f p) => [b|] //= W; exists b => //.
  have [_ P] := listed_names low L; split; last by exists w.
  by move: P inn => /=; case: p L => [|i] //= L P _; exists i.
have [_ P] := listed_names low L; split; first by move: P; rewrite I => -[<-].
by exists w; [rewrite (vertex_of_listed L) | apply/same_linked].
Qed.

Lemma not_open v : ~ opens plane s v.
Proof.
case=> h [w E _]; have [x <-] := dartP (heard_live E).
by rewrite /lacks_face /on_border /side /= -[boundary_of _ _]/(boundary_of t (num x)) (boundaryE map).
Qed.

Lemma same_t1 : agrees T1.
Proof.
have place b : boundary t b -> exists x : nat * place, forall f p, listed t f p = Some b <-> (f, p) = x.
  move=> /(low_f2 low)[f [p [_ _ L]]]; exists (f, p) => f' p'.
  by rewrite L; split=> [[-> ->]|[-> ->]].
split=> [H v lv|H _ v lv].
  case: (H isT v lv) => [[[f p] [/same_outside[b L o] one]]|[[//|/not_open //] _]]; exists b; split=> // c o'.
  have lc := outside_live o'.
  have [[g q] /(_ g q)[_ /(_ erefl) L']] := place c lc.
  have [fg pq] : (f, p) = (g, q) by apply: one; apply/same_outside; exists c.
  by move: L; rewrite fg pq L' => -[].
have [b [o one]] := H v lv; left; have lb := outside_live o.
have [[f p] P] := place b lb; exists (f, p); split; first by apply/same_outside; exists b => //; apply/P.
by move=> [g q] /same_outside[c L o']; apply/esym/P; rewrite (one c o').
Qed.

Section Nesting.
Hypothesis outsides : t1_outside t.

Lemma same_lies_in v u : lies_in plane s v u <-> exists b f c,
  [/\ outside_of t v b, boundary_face t b = Some f, outer t f = Some c & vertex_at t c = Some u].
Proof.
split=> [[[f p] /same_outside[b L o]]|[b [f [c [o Ef Ec W]]]]] /=.
  rewrite -[entry_start _ _ _ _]/(outer t f >>= boundary_start t); case Ec: (outer t f) => [c|] //= W; exists b, f, c; split=> //.
  by have [] := listed_names low L.
have lb := outside_live o.
have [g [p [Eg Ep /(_ g p)[_ L]]]] := low_f2 low lb; have {}L := L (conj erefl erefl).
move: Eg; rewrite Ef => -[fg]; exists (f, p); first by apply/same_outside; exists b; rewrite // fg.
by rewrite (@vertex_of_listed f Outer c).
Qed.

Lemma lies_in_linked w v u : linked plane s w v -> lies_in plane s v u -> lies_in plane s w u.
Proof.
move=> wv [x [inn [y Y vy]] U]; exists x => //; split=> //; exists y => //; exact: walks_trans wv vy.
Qed.

(** A component in a rooted face does not lie inside itself. *)
Lemma rooted_acyclic f : rooted t f -> forall v b, vertex t v -> outside_of t v b -> boundary_face t b = Some f ->
  forall u w, lies_in plane s v u -> walks (lies_in plane s) u w -> ~ linked plane s w v.
Proof.
have same_face v b b' f' : vertex t v -> outside_of t v b -> outside_of t v b' -> boundary_face t b = Some f' -> boundary_face t b' = Some f'.
  by move=> lv o o' E; have [c [_ one]] := outsides lv; rewrite -(one b' o') (one b o).
elim=> {f} [f [lf E]|f b0 w0 b' f' E0 W0 o' Ef' _ IH] v b lv o Ef u w vu uw wv.
  have [b1 [f1 [c [o1 E1 Ec _]]]] := (same_lies_in v u).1 vu.
  by have := same_face v b b1 f lv o o1 Ef; rewrite E1 => -[f1f]; rewrite f1f E in Ec.
have [b1 [f1 [c [o1 E1 Ec W]]]] := (same_lies_in v u).1 vu.
have := same_face v b b1 f lv o o1 Ef; rewrite E1 => -[f1f]; rewrite f1f E0 in Ec; case: Ec => bc.
move: W; rewrite -bc W0 => -[w0u]; rewrite -{u}w0u in vu uw.
have lw0 : vertex t w0.
  case: (faceP low (heard_live E0)) => [E|x E S]; move: E0; rewrite E // => -[xb].
  by move: W0; rewrite -xb (vertex_at_cycle low S) => -[<-]; apply: org_live.
have wu := lies_in_linked wv vu.
case: (walks_first uw) => [E|[z uz zw]].
  by rewrite -E in wu; apply: (IH w0 b' lw0 o' Ef' w0 w0 wu); apply: walks_nowhere.
by apply: (IH w0 b' lw0 o' Ef' z w0) => //; [apply: walks_on zw wu | apply: walks_nowhere].
Qed.

Lemma same_t2 : agrees T2.
Proof.
split=> [H v b f lv o Ef|H _ v u w lv vu uw wv]; last first.
  have [b [f [_ [o Ef _ _]]]] := (same_lies_in v u).1 vu.
  exact: rooted_acyclic (H v b f lv o Ef) v b lv o Ef u w vu uw wv.
pose inside x y := vertex t x /\ lies_in plane s x y.
pose grounded x := forall b f, outside_of t x b -> boundary_face t b = Some f -> rooted t f.
suff: grounded v by apply; [exact: o | exact: Ef].
apply: (@acyclic_ind inside [seq x <- iota 0 (vertex_slots t) | vertex t x] grounded) => [x y [lx xy] yx|x|].
- apply: (H isT x y x lx xy); last exact: walks_nowhere.
  by elim: yx {H} => [|g h _ IH [_ gh]]; [apply: walks_nowhere | apply: walks_on IH gh].
- rewrite mem_filter => /andP[lx _] IH c g oc Eg; have [g' Eg' lg] := outside_face low oc.
  move: Eg'; rewrite Eg => -[gg]; rewrite -gg in lg.
  case: (faceP low lg) => [E|y E S]; first exact: rooted_here.
  have ly := org_live map y; have [d [od _]] := outsides ly; have [f' Ef' _] := outside_face low od.
  have W := vertex_at_cycle low S; apply: (rooted_out E W od Ef'); apply: (IH (org y)) od Ef'.
    by split=> //; apply/same_lies_in; exists c, g, (bnd y).
  by rewrite mem_filter ly mem_iota vertex_below.
by rewrite mem_filter lv mem_iota vertex_below.
Qed.

End Nesting.

(** *** Counts *)

Lemma half_edge_of_joined v (x y : dart t) : joined x y -> half_edge_of t v (num x) -> half_edge_of t v (num y).
Proof.
move=> xy [w]; rewrite (originE map) => -[<-] vx; exists (org y); first exact: originE.
exact: connected_trans vx (joined_connected map xy).
Qed.

Lemma half_edge_of_live v h : half_edge_of t v h -> half_edge t h.
Proof. by case=> w E _; apply: heard_live E. Qed.

Lemma same_edge_dec g h : reflect (same_edge t g h) ((g == h) || same_link (twin t g) (Some h)).
Proof. exact: orPP eqP (same_linkP _ _). Qed.

Lemma on_cycle_dec g h : reflect (on_cycle t g h) (h \in orbit_of plane s (next t) g).
Proof. by apply: (iffP idP) => /(cycleP plane s g h). Qed.

Lemma other_half (x : dart t) h : same_edge t (num x) h -> h = num x \/ h = num (tw x).
Proof. by case=> [<-|]; [left | rewrite (twinE map) => -[<-]; right]. Qed.

Lemma live_edge_sym g h : half_edge t g -> same_edge t g h -> half_edge t h /\ same_edge t h g.
Proof.
case/dartP=> x <- /other_half[->|->]; first by split; [apply: dart_live | left].
by split; [apply: dart_live | right; rewrite (twinE map) (twK map)].
Qed.

Lemma same_edge_sym v g h : half_edge_of t v g -> same_edge t g h -> half_edge_of t v h /\ same_edge t h g.
Proof.
move=> vg gh; have lg := half_edge_of_live vg; split; last by have [] := live_edge_sym lg gh.
case: (dartP lg) vg gh => x <- vg /other_half[->|->] //; exact: half_edge_of_joined (joined_tw map x) vg.
Qed.

Lemma same_edge_trans g h k : same_edge t g h -> same_edge t h k -> same_edge t g k.
Proof.
case=> [-> //|gh]; have [x xg] := dartP (heard_live gh); rewrite -xg in gh *; case: (other_half (or_intror gh)) => ->.
  by move=> /other_half[->|->]; [left | right; apply: twinE].
by case/other_half=> ->; [right; apply: twinE | left; rewrite (twK map)].
Qed.

Lemma on_cycle_sym v g h : half_edge_of t v g -> on_cycle t g h -> half_edge_of t v h /\ on_cycle t h g.
Proof.
move=> vg; case: (dartP (half_edge_of_live vg)) => x xg; rewrite -xg in vg * => c.
have := on_orbit_live (@half_edge_below t) (next_total map) c => /dartP[y yh]; rewrite -yh in c *.
split; last by apply: (cycle_sym map) c; apply: dart_live.
by apply: half_edge_of_joined vg; apply: (joined_orbit (joined_nx map)); apply/(on_cycleE map).
Qed.

Lemma same_component v h : of_component plane s v h <-> half_edge_of t v h.
Proof. by split=> -[w E /same_linked]; exists w. Qed.

Lemma counts_has v V E C : counts_of plane s v V E C -> has_counts t v V E C.
Proof.
case=> vs [es [cs [bs [Hv He Hc [_ Hb] [-> -> ->]]]]].
have none : bs = [::] by case: bs Hb => // h r /(_ h); rewrite mem_head => -[/(_ isT)[_ []]].
exists vs, es, cs; rewrite none addn0; split=> //.
- by apply: lists_iff Hv => w; apply: same_linked.
- apply: (least_one_of_each same_edge_dec) (@same_edge_sym v) same_edge_trans _; first by left.
  by apply: lists_iff He => h; rewrite same_component.
apply: (least_one_of_each on_cycle_dec) (@on_cycle_sym v) (@orbit_trans _) _; first by exists 0.
by apply: lists_iff Hc => h; rewrite same_component.
Qed.

Lemma has_counts_same v V E C V' E' C' : has_counts t v V E C -> has_counts t v V' E' C' -> [/\ V = V', E = E' & C = C'].
Proof.
case=> vs [es [cs [Hv He Hc [-> -> ->]]]] [vs' [es' [cs' [Hv' He' Hc' [-> -> ->]]]]].
have e : size es = size es'.
  apply: one_of_each_size He He'; last exact: same_edge_trans.
  by move=> g h vg _ /(same_edge_sym vg)[].
have c : size cs = size cs'.
  apply: one_of_each_size Hc Hc'; last exact: orbit_trans.
  by move=> g h vg _ /(on_cycle_sym vg)[].
by split=> //; [apply: lists_size Hv Hv' | rewrite c -!size_eq0 e].
Qed.

Lemma same_counts v V E C : counts_of plane s v V E C <-> has_counts t v V E C.
Proof.
split; first exact: counts_has.
case N: (counted plane s v) => [[V' E'] C'] H; have H' := (countedP plane s v V' E' C').2 N.
by have [-> -> ->] := has_counts_same H (counts_has H').
Qed.

Lemma same_t3 : agrees T3.
Proof.
split=> H v lv; have [V [E [C [N]]]] := H v lv.
  case=> g eq /(_ isT) g0; exists V, E, C; split; first exact/same_counts.
  by move: eq; rewrite g0 addn0.
by move=> eq; exists V, E, C; split; [apply/same_counts | exists 0; rewrite ?addn0].
Qed.

Lemma same_simple : simple_of plane s -> simple t.
Proof.
move=> sim g h u w Eu Ew; have [ne same] := sim g u w Eu Ew; split=> // Hu Hw.
case: (same h) => [|//|]; first by left.
by rewrite -[twin _ g]/(twin t g) => gh; move: Ew; rewrite /target gh /= Hu => -[].
Qed.

Lemma least_edges_each es : lists es (fun h => half_edge t h /\ least (same_edge t) h) ->
  lists_one_of_each es (same_edge t) (half_edge t).
Proof. by apply: (least_one_of_each same_edge_dec) live_edge_sym same_edge_trans; left. Qed.

Lemma same_t4 : t4_bounds t -> t4 plane s.
Proof.
move=> H _ sim vs es fs Hv He Hf; apply: H; last exact: same_simple.
by exists vs, es, fs; split=> //; apply: least_edges_each.
Qed.

End Lower.

(** ** All rules *)

(** Each rule is that of Rules.v if the rules before it hold. *)
Theorem plane_rule r : holds_before t r -> agrees r.
Proof.
have lower_if q : index T1 <= index q -> holds_before t q -> lower t.
  by move=> le up q' lt; apply: up; apply: leq_trans lt le.
case: r => up.
- exact: same_r1.
- exact: same_l1.
- exact: same_l2.
- exact: same_l3.
- exact: same_v1.
- exact: same_v2.
- exact: same_b1.
- exact: same_b2.
- exact: same_f1.
- exact: same_f2.
- exact: same_t1 (lower_if T1 isT up).
- exact: same_t2 (lower_if T2 isT up) (up T1 isT).
- exact: same_t3 (lower_if T3 isT up).
have H := t4_follows up; split=> _ //; exact: same_t4 (lower_if T4 isT up) H.
Qed.

Lemma plane_before r : (forall q, index q < index r -> holds_of plane s (Basic q)) <-> holds_before t r.
Proof.
split=> H; last by move=> q lt; apply/plane_rule; [move=> p lt'; apply: H; apply: ltn_trans lt' lt | apply: H].
suff A n : n <= index r -> forall q, index q < n -> holds t q by apply: A.
elim: n => // n IH le q; rewrite ltnS leq_eqVlt => /orP[/eqP E|]; last by apply: IH; apply: ltnW.
by apply/plane_rule; [move=> p; rewrite E; apply: IH; apply: ltnW | apply: H; rewrite E].
Qed.

Theorem plane_rules : rules_of plane s <-> rules t.
Proof.
split=> [H r|H]; first by apply/plane_rule; [apply/plane_before=> q _; apply: H | apply: H].
by case=> [r|[] //]; apply/plane_rule; [move=> q _; apply: H | apply: H].
Qed.

(** So both checkers say the same. *)
Corollary plane_first_broken : first_broken_of plane s = omap Basic (first_broken t).
Proof.
case E: (first_broken t) => [r|] /=; last by apply/first_broken_of_none/plane_rules/first_broken_none.
have [nr B] := (first_broken_some t r).1 E; apply/first_broken_of_some; split; first by move/(plane_rule B).
case=> [q|m] lt; first exact: (plane_before r).2 B q lt.
by case: r lt {E nr B} => //; case: m.
Qed.

End Plane.
