(** * ExpectationsOpenCounts: where open boundaries are legal, a structure and its whole have the same components and counts

    The whole (ExpectationsBorder.v) has a half-edge more for each that lacks a twin, but no edge and no vertex more; and a cycle more
    for each border. So T3 holds of the structure if and only if it holds of the whole, which is closed.

<<
      the structure:  V − E + cycles + borders        its whole:  V − E + (cycles + as many new ones as there are borders)
>>
*)

From mathcomp Require Import all_ssreflect all_fingroup.
From twinedge Require Import Arith View Rules Loops LoopsProof Reference ReferenceProof Map Counting Lists.
From twinedge Require Import Subdivision Genus Bounds RotationSystem.
From twinedge Require Import Expectations ExpectationsCheck ExpectationsLists ExpectationsVerdict ExpectationsPlane ExpectationsFaceless.
From twinedge Require Import ExpectationsBorder.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** Surfaces and planes where open boundaries are legal; no rule of meshes is asked for. *)
Definition open_on on := Expectation on true false false None false None None None false.

Section Open.
Variables (t : view) (on faces records places holes unbounded : bool) (sf so : nat -> link) (si : nat -> nat -> option start).

Let e := open_on on.
Let s := Structure t (Parts true true faces records places holes unbounded) sf so si.

(** The rules of links are those of structures without faces. *)
Lemma links_open : (forall r, index r < index B1 -> holds_of e s (Basic r)) -> open_rules t.
Proof.
move=> H; have [Hh Hv _ _ _] := H R1 isT; split; last 2 first.
- exact: (H V1 isT).
- move=> g h lg lh; have [A B] := H V2 isT g h lg lh; split; first by case=> o; apply: A; [left|right].
  by case/B=> [|[]]; [left|right].
- split=> [h lh|v lv]; last by have [A _] := Hv v lv; apply: A.
  have [O T N P _] := Hh h lh; split=> //; last exact: P.
  by case: T => T; [left|right]; move: T => //; rewrite /on_border /= -[twin _ h]/(twin t h); case: (twin t h).
have border h : twin t h <> None -> ~~ on_border e s h by rewrite -[on_border e s h]/(is_nil (twin t h)); case: (twin t h).
by split; [move=> h lh /border; exact: (H L1 isT h lh) | exact: (H L2 isT) | move=> h lh /border; exact: (H L3 isT h lh)].
Qed.

Section Kept.
Hypothesis keeps : open_rules t.

Notation w := (whole t).
(** The whole, as a closed structure without faces. *)
Let ec := Expectation on false false false None false None None None false.
Let sw := Structure w (Parts true true false false false false false) sf so si.

Let map := whole_map keeps.

Lemma on_borderE h : on_border e s h = is_nil (twin t h). Proof. by []. Qed.

Lemma end_ofE h : half_edge t h -> end_of e s h = end_at t h.
Proof.
move=> lh; rewrite /end_of on_borderE; case T: (twin t h) => [g|] //=.
have [_ [_ _ L3] _ _] := keeps; rewrite -[target _ h]/(twin t h >>= origin t) -L3 //; by rewrite T.
Qed.

Lemma cycle_old g h : half_edge t g -> on_cycle w g h <-> on_cycle t g h.
Proof.
move=> lg; suff E n : iter n (obind (next w)) (Some g) = iter n (obind (next t)) (Some g) by split=> -[n]; [rewrite E|rewrite -E]; exists n.
elim: n g lg => // n IH g lg; rewrite !iterSr /= next_old //.
by have [_ _ [k N lk] _] := lives keeps lg; rewrite N IH.
Qed.

Lemma cycle_live i j : half_edge w i -> on_cycle w i j -> half_edge w j.
Proof.
by case/(dartP (t := one_boundary w))=> x <-; apply: (on_orbit_live (@half_edge_below (one_boundary w)) (next_total map)).
Qed.

Lemma cycle_live_old i j : half_edge t i -> on_cycle t i j -> half_edge t j.
Proof.
move=> li [[|n]]; first by case=> <-.
rewrite iterS; case: (iter n _ _) => // k N; have {}N : next t k = Some j := N.
by have [_ _ [m M lm] _] := lives keeps (heard_live N); move: N; rewrite M => -[<-].
Qed.

Lemma along_linked g h u x : on_cycle t g h -> origin t g = Some u -> origin t h = Some x -> linked e s u x.
Proof.
case=> n; elim: n h x => [|n IH] h x; first by case=> -> -> [->]; apply: walks_nowhere.
rewrite iterS; case E: (iter n _ _) => [k|] // kh Og Oh; have {}kh : next t k = Some h := kh; have [[y O _] _ _ _] := lives keeps (heard_live kh).
by apply: walks_on (IH k y E Og O) _; exists k => //; rewrite end_ofE ?(heard_live kh) // /end_at kh.
Qed.

(** From the end of a half-edge its cycle leads back to its origin. *)
Lemma back_linked h u x : half_edge t h -> end_at t h = Some u -> origin t h = Some x -> linked e s u x.
Proof.
move=> lh E O; have [_ _ [n N ln] _] := lives keeps lh; apply: (@along_linked n h) => //; last by move: E; rewrite /end_at N.
apply/(cycle_old _ ln); apply: (cycle_sym map (live_old lh) (live_old ln)).
by exists 1; rewrite -[iter _ _ _]/(next w h) next_old.
Qed.

Lemma open_linked u x : linked e s u x <-> linked ec sw u x.
Proof.
split; elim=> [|y z _ IH [h O E]]; try exact: walks_nowhere.
  apply: walks_on IH _; have lh := heard_live O; exists h; first by rewrite -[origin _ h]/(origin w h) origin_old.
  rewrite -[end_of _ _ h]/(twin w h >>= origin w) -(whole_l3 keeps (live_old lh)) next_old //.
  move: E; rewrite end_ofE // /end_at; have [_ _ [n N ln] _] := lives keeps lh; by rewrite N /= origin_old.
case: (wholeP (heard_live O)) => [lh|[g bg hg]].
  apply: walks_on IH _; exists h; first by move: O; rewrite -[origin _ h]/(origin w h) origin_old.
  move: E; rewrite -[end_of _ _ h]/(twin w h >>= origin w) -(whole_l3 keeps (live_old lh)) next_old // end_ofE //.
  by rewrite /end_at; have [_ _ [n N ln] _] := lives keeps lh; rewrite N /= origin_old.
apply: (walks_trans IH); have [lg _] := andP bg; apply: (back_linked lg).
  by move: O; rewrite -[origin _ h]/(origin w h) hg origin_new.
by move: E; rewrite -[end_of _ _ h]/(twin w h >>= origin w) hg twin_new //= origin_old.
Qed.

Lemma component_old v h : half_edge t h -> of_component e s v h <-> of_component ec sw v h.
Proof.
move=> lh; rewrite /of_component -[origin _ h]/(origin t h) -[X in _ <-> X]/(exists2 x, origin w h = Some x & linked ec sw v x) origin_old //.
by split=> -[x O L]; exists x => //; apply/open_linked.
Qed.

Lemma component_new v h : lacks_twin t h -> of_component e s v h <-> of_component ec sw v (beside t h).
Proof.
move=> bh; have [lh _] := andP bh; have [k [u [N lk Ok E _]]] := lacks_end keeps bh; have [[x O _] _ _ _] := lives keeps lh.
rewrite /of_component -[origin _ h]/(origin t h) -[X in _ <-> X]/(exists2 x, origin w (beside t h) = Some x & linked ec sw v x) origin_new // E O.
split=> -[y [<-] L].
  by exists u => //; apply/open_linked; apply: walks_on L _; exists h; rewrite ?end_ofE.
by exists x => //; apply: walks_trans (back_linked lh E O); apply/open_linked.
Qed.

(** Along the border one walks the other way in the whole. *)
Lemma walks_beside b y : lacks_twin t b -> walks (follows e s) b y <-> lacks_twin t y /\ on_cycle w (beside t y) (beside t b).
Proof.
move=> bb; split=> [|[by_ [n]]].
  elim=> [|g h _ [bg [n IH]] [B [u E O]]]; first by split=> //; exists 0.
  have bh : lacks_twin t h by rewrite /lacks_twin (heard_live O : half_edge t h).
  split=> //; exists n.+1; rewrite iterSr [obind _ _]/=; have [k bk [-> Ek]] := next_beside keeps bh.
  have lg : half_edge t g by case/andP: bg.
  by rewrite (one_into keeps bk bg) // Ek -(end_ofE lg) E.
elim: n y by_ => [|n IH] y by_; first by case=> /beside_inj ->; apply: walks_nowhere.
rewrite iterSr [obind _ _]/=; have [k bk [-> Ek]] := next_beside keeps by_ => /(IH k bk) L; apply: walks_on L _.
have [lk _] := andP bk; have [ly T] := lacks_twinP _ _ by_; split; first by rewrite on_borderE T.
by have [[u O _] _ _ _] := lives keeps ly; exists u => //; rewrite end_ofE // Ek.
Qed.

Lemma least_edges_whole h : half_edge t h /\ least (same_edge t) h <-> half_edge w h /\ least (same_edge w) h.
Proof.
split=> -[lh L].
  split; first exact: live_old.
  move=> y lt [yh|]; first by move: lt; rewrite yh ltnn.
  rewrite twin_old //; case T: (twin t h) => [g|] [gy]; first by apply: (L y lt); right; rewrite -gy.
  by move: lt; rewrite -gy /beside ltnNge leq_addl.
case: (wholeP lh) => [lo|[b bb hb]].
  by split=> // y lt [yh|T]; [move: lt; rewrite yh ltnn | apply: (L y lt); right; rewrite twin_old // T].
have [lb _] := lacks_twinP _ _ bb; case: (L b); first by rewrite hb (leq_trans (half_edge_below lb)) ?leq_addr.
by right; rewrite hb twin_new.
Qed.

Lemma open_counts_whole v V E C : counts_of e s v V E C -> counts_of ec sw v V E C.
Proof.
case=> vs [es [cs [bs [Hv He [uc Hc] [ub Hb] [-> -> ->]]]]]; exists vs, es, (cs ++ [seq beside t b | b <- bs]), [::]; split.
- by apply: lists_iff Hv => x; apply: open_linked.
- apply: lists_iff He => h; split=> -[c L].
    have lh : half_edge t h := of_component_live c; have [_ L'] := (least_edges_whole h).1 (conj lh L).
    by split; [exact/component_old | exact: L'].
  have lw : half_edge w h := of_component_live c; have [lh L'] := (least_edges_whole h).2 (conj lw L).
  by split; [exact/component_old | exact: L'].
- split.
    rewrite cat_uniq uc (map_inj_uniq (@beside_inj t)) ub andbT /=; apply/hasPn=> x /mapP[b /Hb[c _] ->].
    by apply/negP=> /Hc[/of_component_live lb _]; case: (old_differs lb (erefl (beside t b))).
  move=> x; rewrite mem_cat; split.
    case/orP=> [/Hc[c L]|/mapP[b /Hb[c [B L]] ->]].
      have lx : half_edge t x := of_component_live c; split; first exact/component_old.
      by move=> y lt /(cycle_old _ lx); apply: L.
    have lb : half_edge t b := of_component_live c; have bb : lacks_twin t b by rewrite /lacks_twin lb.
    split; first exact/component_new.
    have lw : half_edge w (beside t b) by rewrite live_new.
    move=> y lt cy; have ly := cycle_live lw cy; have {}cy := cycle_sym map lw ly cy; case: (wholeP ly) => [lo|[a ba ya]].
      have old : half_edge t (beside t b) by apply: (cycle_live_old lo); apply/(cycle_old _ lo); exact: cy.
      by case: (old_differs old (erefl (beside t b))).
    apply: (L a); first by move: lt; rewrite ya ltn_add2l.
    by apply/(walks_beside _ bb); rewrite -ya.
  case=> c L; case: (wholeP (of_component_live c)) => [lx|[b bb xb]]; apply/orP; [left|right].
    by apply/Hc; split; [exact/component_old | move=> y lt /(cycle_old _ lx); apply: L].
  apply/mapP; exists b => //; apply/Hb; split; first by apply/component_new => //; rewrite -xb.
  split; first by have [_ T] := lacks_twinP _ _ bb; rewrite on_borderE T.
  move=> y lt /(walks_beside _ bb)[by_ cy]; apply: (L (beside t y)); first by rewrite xb ltn_add2l.
  have lw z : lacks_twin t z -> half_edge w (beside t z) by rewrite live_new.
  by rewrite xb; exact: (cycle_sym map (lw y by_) (lw b bb) cy).
- by split=> // h; split=> // -[_ []].
by rewrite size_cat size_map addn0.
Qed.

Lemma open_counts v V E C : counts_of e s v V E C <-> counts_of ec sw v V E C.
Proof.
split; first exact: open_counts_whole.
case N: (counted e s v) => [[V' E'] C'] H; have H' := (countedP e s v V' E' C').2 N.
move: H (open_counts_whole H') => /countedP + /countedP; by move=> -> -[-> -> ->].
Qed.

Lemma open_t3 : t3 e s <-> t3 ec sw.
Proof. by split=> H v lv; have [V [E [C [N G]]]] := H v lv; exists V, E, C; split=> //; apply/open_counts. Qed.

Lemma open_simple : simple_of e s -> simple_of ec sw.
Proof.
have old h : half_edge t h -> end_of ec sw h = end_of e s h.
  move=> lh; rewrite -[LHS]/(twin w h >>= origin w) -(whole_l3 keeps (live_old lh)) next_old // end_ofE // /end_at.
  by have [_ _ [n N ln] _] := lives keeps lh; rewrite N /= origin_old.
have new h : lacks_twin t h -> origin w (beside t h) = end_of e s h /\ end_of ec sw (beside t h) = origin t h.
  move=> bh; have [lh _] := andP bh; rewrite origin_new // end_ofE //; split=> //.
  by rewrite -[LHS]/(twin w (beside t h) >>= origin w) twin_new //= origin_old.
(* Every half-edge of the whole has an old one on the same edge, that says the same, or the other way round. *)
have some h u x : origin w h = Some u -> end_of ec sw h = Some x -> exists2 g, half_edge t g &
    (g = h /\ origin t g = Some u /\ end_of e s g = Some x) \/
    [/\ lacks_twin t g, h = beside t g, origin t g = Some x & end_of e s g = Some u].
  move=> O E; case: (wholeP (heard_live O)) => [lh|[g bg hg]]; [exists h => //; left|exists g; [by case/andP: bg|right]].
    by move: O E; rewrite origin_old // old // => -> ->.
  by move: O E; rewrite hg; have [-> ->] := new g bg => -> ->.
have same g h : half_edge t g -> same_edge t g h -> same_edge w g h.
  by move=> lg [->|T]; [left|right; rewrite twin_old // T].
move=> sim g u x O E; have [g0 lg0 G] := some g u x O E; have [ne par] : u <> x /\ forall h,
    origin t h = Some u /\ end_of e s h = Some x \/ origin t h = Some x /\ end_of e s h = Some u -> same_edge t g0 h.
  case: G => [[_ [Og Eg]]|[_ _ Og Eg]]; first exact: sim Og Eg.
  have [ne par] := sim g0 x u Og Eg; split=> [ux|h [H|H]]; [by case: ne|apply: par; by right|apply: par; by left].
split=> // h H; have [h0 lh0 K] : exists2 h0, half_edge t h0 & (h0 = h \/ lacks_twin t h0 /\ h = beside t h0) /\
    (origin t h0 = Some u /\ end_of e s h0 = Some x \/ origin t h0 = Some x /\ end_of e s h0 = Some u).
  case: H => -[Oh Eh]; have [h0 lh0 [[I [A B]]|[bb I A B]]] := some h _ _ Oh Eh; exists h0 => //.
  - by split; [left|left].
  - by split; [right|right].
  - by split; [left|right].
  by split; [right|left].
case: K => K /par S.
case: G => [[<- _]|[bg -> _ _]]; case: K => [<-|[bh ->]].
- exact: same.
- case: S => [->|T]; last by have [_ N] := lacks_twinP _ _ bh; move: N; rewrite (twin_back keeps T).
  by right; have [lh T] := lacks_twinP _ _ bh; rewrite -[twin _ _]/(twin w h0) twin_old // T.
- case: S => [<-|T]; last by have [_ N] := lacks_twinP _ _ bg; move: T; rewrite -[twin _ _]/(twin t g0) N.
  by right; rewrite -[twin _ _]/(twin w (beside t g0)) twin_new.
case: S => [<-|T]; first by left.
by have [_ N] := lacks_twinP _ _ bg; move: T; rewrite -[twin _ _]/(twin t g0) N.
Qed.

End Kept.
End Open.
