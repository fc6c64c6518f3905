(** * FastPathAccepted: what the fast path accepts keeps R1 to F2

    What is listed is live, different, and as much as there are boundary components: hence all of them are listed. The
    walks along them and those around the vertices return to where they set out, and each kind visits as many half-edges
    as there are. As no half-edge is visited twice, every half-edge is visited. In the same way isolated vertices are
    counted, and not looked up. *)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import Arith View Rules Loops LoopsProof Reference Map Counting Lists ReferenceProof Genus WholeEuler.
From twinedge Require Import FastPath.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** ** Lists *)

(** As many different ones as there are: hence all. *)
Lemma all_met (A : eqType) (s s' : seq A) : uniq s -> {subset s <= s'} -> size s = size s' -> s =i s'.
Proof. by move=> u sub E; have [] := uniq_min_size u sub _; rewrite ?E. Qed.

Lemma live_onesP n (live : pred nat) i : (live i -> i < n) -> (i \in live_ones n live) = live i.
Proof. by move=> lt; rewrite mem_filter mem_iota add0n andbC; case: (live i) lt => [->|_]; rewrite ?andbF. Qed.

Section FastPathAccepted.
Variable t : view.

Lemma vertex_onesP v : (v \in vertex_ones t) = vertex t v. Proof. exact: live_onesP (@vertex_below t v). Qed.
Lemma half_edge_onesP h : (h \in half_edge_ones t) = half_edge t h. Proof. exact: live_onesP (@half_edge_below t h). Qed.
Lemma boundary_onesP b : (b \in boundary_ones t) = boundary t b. Proof. exact: live_onesP (@boundary_below t b). Qed.
Lemma face_onesP f : (f \in face_ones t) = face t f. Proof. exact: live_onesP (@face_below t f). Qed.

Lemma ones_uniq n (live : pred nat) : uniq (live_ones n live). Proof. exact: filter_uniq (iota_uniq _ _). Qed.

Lemma heardE T (live : pred nat) (says : nat -> option T) i : live i -> heard live says i = says i.
Proof. by rewrite /heard => ->. Qed.

Lemma existingP n l i : existing n l = Some i <-> l = Some i /\ i < n.
Proof.
case: l => [j|] /=; last by split=> [|[]].
by case: ifP => [lt|ge]; split=> [|[]] //; case=> E; [rewrite -E | rewrite -E ge].
Qed.

(** ** What the scan and one step see *)

Lemma scannedP h : scanned t h -> exists w n,
  [/\ says_twin t h = Some w, half_edge t w, w <> h & says_twin t w = Some h] /\
  [/\ says_next t h = Some n, half_edge t n, says_prev t n = Some h & exists2 u, says_origin t n = Some u & says_origin t w = Some u].
Proof.
rewrite /scanned; case Ew: (existing _ _) => [w|] //; case En: (existing _ _) => [n|] //.
case/and5P=> /eqP wh lw /same_linkP tw ln /and3P[on /same_linkP ow /same_linkP pn].
have [Ew' _] := (existingP _ _ _).1 Ew; have [En' _] := (existingP _ _ _).1 En; exists w, n; split; split=> //.
by case O: (says_origin t n) on ow => [u|] // _ ow; exists u.
Qed.

Lemma along_stepP b h n : along_step t b h = Some n ->
  says_next t h = Some n /\ says_boundary t h = Some b.
Proof. by rewrite /along_step; case: ifP => // /same_linkP bh /existingP[]. Qed.

Lemma around_stepP h n : around_step t h = Some n ->
  exists w u, [/\ says_twin t h = Some w, says_origin t w = Some u & says_next t w = Some n].
Proof.
rewrite /around_step; case Ew: (existing _ _) => [w|] //; case Eu: (existing _ _) => [u|] // /existingP[En _].
by have [Ew' _] := (existingP _ _ _).1 Ew; have [Eu' _] := (existingP _ _ _).1 Eu; exists w, u.
Qed.

(** ** The places in the lists of the faces *)

Lemma entriesP f p : (f, p) \in entries t <->
  face t f /\ (if p is Inner i then i < says_inner_count t f : Prop else has_outer t f).
Proof.
split=> [/flattenP[s /mapP[g + ->]]|[lf]].
  rewrite face_onesP mem_cat => lg /orP[/mapP[i + [-> ->]]|/mapP[i + [-> ->]]]; rewrite mem_iota add0n => H; split=> //.
  by case: (has_outer t g) H.
case: p => [|i] H; apply/flattenP; exists (entries_of t f); rewrite ?map_f ?face_onesP // mem_cat; apply/orP.
  by left; rewrite H /=; apply: mem_head.
by right; apply: map_f; rewrite mem_iota.
Qed.

Lemma entries_uniq : uniq (entries t).
Proof.
apply: uniq_flatten; first exact: ones_uniq.
  move=> f _; rewrite cat_uniq; apply/and3P; split; first by case: (has_outer t f).
    by apply/hasPn=> x /mapP[i _ ->]; apply/negP=> /mapP[j _].
  by rewrite map_inj_uniq ?iota_uniq // => i j [].
by move=> f g x _ _; rewrite !mem_cat => /orP[]/mapP[i _ ->] /orP[]/mapP[j _ []].
Qed.

Lemma listed_entry f p b : listed t f p = Some b -> (f, p) \in entries t.
Proof.
move=> L; have lf := listed_face L; apply/entriesP; split=> //; case: p L => [|i] /=.
  by rewrite /outer heardE // /has_outer => ->.
by rewrite /inner /inner_count lf; case: ifP.
Qed.

Lemma listedE f p : (f, p) \in entries t -> listed t f p = says_listed t (f, p).
Proof. by case/entriesP=> lf; case: p => [|i] H /=; [rewrite /outer heardE | rewrite /inner /inner_count lf H]. Qed.

(** The half-edges that the walk along [b] visits, and those that the walk around [v] visits. *)
Definition along_list b : seq nat :=
  if says_boundary_start t b is Some (AtHalfEdge h) then
    traject (fun h => odflt 0 (along_step t b h)) h (odflt 0 (along t b)) else [::].
Definition around_list v : seq nat :=
  if says_leaving t v is Some l then traject (fun h => odflt 0 (around_step t h)) l (odflt 0 (around t v)) else [::].

Lemma size_along_list b : size (along_list b) = odflt 0 (along t b).
Proof.
rewrite /along_list /along; case: (says_boundary_start t b) => [[h|v]|] //; first by rewrite size_traject.
by case: (says_boundary_place t b) => [[|]|].
Qed.

Lemma size_around_list v : size (around_list v) = odflt 0 (around t v).
Proof.
rewrite /around_list /around; case: (says_leaving t v) => [l|]; first by rewrite size_traject.
by case: ifP.
Qed.

(** ** What is accepted keeps R1 to F2 *)

Section Accepted.
Hypothesis scan_ok : forall h, half_edge t h -> scanned t h.
Hypothesis entries_ok : forall e, e \in entries t -> entry_ok t e.
Hypothesis once : listed_once t.
Hypothesis vertices_ok : forall v, vertex t v -> exists k, around t v = Some k.
Hypothesis counts : complete t.

(** *** What is listed *)

Lemma entryP f p : (f, p) \in entries t -> exists b,
  [/\ boundary t b, says_boundary_face t b = Some f, says_boundary_place t b = Some p, listed t f p = Some b
    & exists k, along t b = Some k].
Proof.
move=> e; have := entries_ok e; rewrite /entry_ok (listedE e); case: (says_listed t (f, p)) => [b|] //.
case/and5P=> lb /same_linkP Ef /same_placeP Ep _; case K: (along t b) => [k|] // _.
by exists b; split=> //; exists k.
Qed.

(** Every boundary component is listed. *)
Lemma listed_all : perm_eq (listed_ones t) (boundary_ones t).
Proof.
have /andP[u /eqP total] := once; apply: uniq_perm => //; first exact: ones_uniq.
apply: all_met => //; last by rewrite size_map.
move=> b /mapP[[f p] e ->]; have [c [lc _ _ L _]] := entryP e.
by rewrite -(listedE e) L boundary_onesP.
Qed.

Lemma namedP b : boundary t b -> exists f p, [/\ says_boundary_face t b = Some f, says_boundary_place t b = Some p,
  face t f & listed t f p = Some b] /\ exists k, along t b = Some k.
Proof.
rewrite -boundary_onesP -(perm_mem listed_all) => /mapP[[f p] e Eb]; have [lf _] := (entriesP f p).1 e.
by have [c [lc Ef Ep L K]] := entryP e; move: Eb; rewrite -(listedE e) L /= => ->; exists f, p.
Qed.

Lemma listed_named f p b : listed t f p = Some b ->
  [/\ boundary t b, says_boundary_face t b = Some f & says_boundary_place t b = Some p].
Proof.
by move=> L; have [c [lc Ef Ep + _]] := entryP (listed_entry L); rewrite L => -[->].
Qed.

(** *** Along the boundary components *)

Lemma along_orbit_live b l h : half_edge t l -> on_orbit (along_step t b) l h -> half_edge t h.
Proof.
move=> ll [k]; elim: k h => [|k IH] h /=; first by case=> <-.
case E: (iter k _ _) => [g|] //= /along_stepP[nx _].
by have [w [n [_ [nx' ln _ _]]]] := scannedP (scan_ok (IH g E)); move: nx; rewrite nx' => -[<-].
Qed.

Lemma along_listP b : boundary t b -> uniq (along_list b) /\ forall h, h \in along_list b ->
  [/\ half_edge t h, exists2 n, along_step t b h = Some n & n \in along_list b,
      exists2 g, along_step t b g = Some h & g \in along_list b
    & exists2 l, says_boundary_start t b = Some (AtHalfEdge l) & l \in along_list b /\ on_orbit (along_step t b) l h].
Proof.
case/namedP=> f [p [_ [k E]]]; rewrite /along_list E; move: E; rewrite /along.
case: (says_boundary_start t b) => [[l|v]|] //; case: ifP => // ll /round_tripP[l0 u fwd back]; split=> // h hs.
have [pre on] := back h hs; split=> //; [exact: along_orbit_live on|exact: fwd|by exists l].
Qed.

Lemma along_start b l : boundary t b -> says_boundary_start t b = Some (AtHalfEdge l) -> half_edge t l /\ l \in along_list b.
Proof.
case/namedP=> f [p [_ [k E]]] S; rewrite /along_list E S; move: E; rewrite /along S.
by case: ifP => // ll /round_tripP[].
Qed.

Lemma along_list_half_edge b h : boundary t b -> h \in along_list b -> half_edge t h /\ says_boundary t h = Some b.
Proof. by case/along_listP=> _ /[apply] -[lh [n /along_stepP[_ bh] _] _ _]. Qed.

(** The walks along the boundary components visit every half-edge. *)
Lemma all_along h : half_edge t h -> exists2 b, boundary t b & h \in along_list b.
Proof.
move=> lh; have [/eqP total _ _ _] := and4P counts; rewrite (perm_sumn (perm_map _ listed_all)) in total.
have : h \in flatten [seq along_list b | b <- boundary_ones t].
  rewrite (@all_met _ _ (half_edge_ones t)) ?half_edge_onesP //.
  - apply: uniq_flatten; first exact: ones_uniq.
      by move=> b; rewrite boundary_onesP => /along_listP[].
    move=> b c g; rewrite !boundary_onesP => lb lc gb gc.
    have [_ Eb] := along_list_half_edge lb gb; have [_] := along_list_half_edge lc gc.
    by rewrite Eb => -[].
  - move=> g /flattenP[s /mapP[b + ->] gb]; rewrite boundary_onesP half_edge_onesP => lb.
    by case: (along_list_half_edge lb gb).
  rewrite size_flatten_map -total; congr sumn; apply: eq_map => b; exact: size_along_list.
by case/flattenP=> s /mapP[b + ->] hb; rewrite boundary_onesP; exists b.
Qed.

(** So every half-edge is as it should be. *)
Lemma half_edge_ok h : half_edge t h -> exists w n g b,
  [/\ [/\ says_twin t h = Some w, half_edge t w, w <> h & says_twin t w = Some h],
      [/\ says_next t h = Some n, half_edge t n & says_prev t n = Some h],
      [/\ says_prev t h = Some g, half_edge t g & says_next t g = Some h],
      exists2 u, says_origin t n = Some u & says_origin t w = Some u
    & [/\ says_boundary t h = Some b, boundary t b, says_boundary t n = Some b & h \in along_list b]].
Proof.
case/all_along=> b lb hb; have [_ /(_ h hb)[lh [n En nb] [g Eg gb] _]] := along_listP lb.
have [w [m [T [nx' _ pv o]]]] := scannedP (scan_ok lh); have [nx bh] := along_stepP En; have [gx _] := along_stepP Eg.
have [ln bn] := along_list_half_edge lb nb; have [lg _] := along_list_half_edge lb gb.
move: nx'; rewrite nx => -[nm]; rewrite -nm in o pv.
have gp : says_prev t h = Some g.
  by have [_ [m' [_ [gx' _ + _]]]] := scannedP (scan_ok lg); move: gx'; rewrite gx => -[<-].
by exists w, n, g, b.
Qed.

(** The walk around a vertex visits half-edges that leave it. *)
Lemma around_listP v : vertex t v -> uniq (around_list v) /\ forall h, h \in around_list v ->
  [/\ half_edge t h, says_origin t h = Some v & exists2 l, says_leaving t v = Some l & on_orbit (turn t) l h].
Proof.
case/vertices_ok=> k E; rewrite /around_list E; move: E; rewrite /around.
case L: (says_leaving t v) => [l|] //; case: ifP => // /and3P[ll /same_linkP ol _] /round_tripP[l0 u fwd back]; split=> // h hs.
suff [lh oh on] : [/\ half_edge t h, says_origin t h = Some v & on_orbit (turn t) l h] by split=> //; exists l.
have [_ [j]] := back h hs; elim: j h {hs} => [|j IH] h /=; first by case=> <-; split=> //; exists 0.
case Eg: (iter j _ _) => [g|] //= /around_stepP[w [x [gw _ wh]]].
have [lg og [i ig]] := IH g Eg.
have [w' [_ [_ [_ [[gw' lw' _ tw'] _ _ _ _]]]]] := half_edge_ok lg.
move: gw; rewrite gw' => -[ww]; rewrite ww in lw' tw' gw'.
have [g' [n [_ [_ [[gg _ _ _] [wn ln _] _ [z oz oz'] _]]]]] := half_edge_ok lw'.
move: wh; rewrite wn => -[nh]; move: gg; rewrite tw' => -[gg].
rewrite -nh; split=> //; first by rewrite oz -oz' -gg og.
by exists i.+1; rewrite iterS ig /= /turn /twin heardE // gw' /= /next heardE // wn.
Qed.

(** The walks around the vertices visit every half-edge. *)
Lemma all_around h : half_edge t h -> exists2 v, vertex t v & h \in around_list v.
Proof.
move=> lh; have [_ /eqP total _ _] := and4P counts.
have : h \in flatten [seq around_list v | v <- vertex_ones t].
  rewrite (@all_met _ _ (half_edge_ones t)) ?half_edge_onesP //.
  - apply: uniq_flatten; first exact: ones_uniq.
      by move=> v; rewrite vertex_onesP => /around_listP[].
    move=> v w g; rewrite !vertex_onesP => /around_listP[_ Hv] /around_listP[_ Hw] /Hv[_ Ev _] /Hw[_].
    by rewrite Ev => -[].
  - move=> g /flattenP[s /mapP[v + ->]]; rewrite vertex_onesP half_edge_onesP => /around_listP[_ H] /H[].
    by [].
  rewrite size_flatten_map -total; congr sumn; apply: eq_map => v; exact: size_around_list.
by case/flattenP=> s /mapP[v + ->] hv; rewrite vertex_onesP; exists v.
Qed.

Lemma origin_ok h : half_edge t h -> exists2 v, says_origin t h = Some v & vertex t v /\ h \in around_list v.
Proof. by case/all_around=> v lv hv; have [_ /(_ h hv)[_ oh _]] := around_listP lv; exists v. Qed.

(** A vertex that keeps no half-edge has none. *)
Lemma no_leaving_bare v : vertex t v -> says_leaving t v = None <-> bare t v.
Proof.
move=> lv; split=> [none h lh|bv].
  rewrite /origin heardE // => E; have [w E' [lw hw]] := origin_ok lh; move: E; rewrite E' => -[wv].
  by move: hw; rewrite wv /around_list none.
case L: (says_leaving t v) => [l|] //; have [k] := vertices_ok lv; rewrite /around L.
by case: ifP => // /and3P[ll /same_linkP ol _] _; case: (bv l ll); rewrite /origin heardE.
Qed.

(** The isolated vertices name all boundary components that start at a vertex. *)
Lemma all_isolated b v : boundary t b -> says_boundary_start t b = Some (AtVertex v) ->
  [/\ vertex t v, says_leaving t v = None & says_isolated t v = Some b].
Proof.
move=> lb S; have [_ _ /eqP total _] := and4P counts; rewrite (permP listed_all) in total.
pose I := [seq v <- vertex_ones t | is_isolated t v]; pose A := [seq b <- boundary_ones t | is_at_vertex t b].
pose name v := odflt 0 (says_isolated t v).
have names u : u \in I -> [/\ vertex t u, says_leaving t u = None, says_isolated t u = Some (name u), boundary t (name u)
    & says_boundary_start t (name u) = Some (AtVertex u)].
  rewrite mem_filter vertex_onesP /is_isolated => /andP[+ lu]; case L: (says_leaving t u) => [//|] _.
  have [k] := vertices_ok lu; rewrite /around L /names_its_boundary /name; case E: (says_isolated t u) => [c|] //=.
  case: ifP => // /andP[lc]; case: (says_boundary_start t c) => [[|w]|] //= /eqP -> _.
  by split.
have : b \in A by rewrite mem_filter boundary_onesP lb /is_at_vertex S.
rewrite -(@all_met _ [seq name u | u <- I] A).
- by case/mapP=> u /names[lu L E _ S'] bu; rewrite bu S' in S; case: S => <-; rewrite L E bu.
- rewrite map_inj_in_uniq; first by apply: filter_uniq; apply: ones_uniq.
  move=> u w /names[_ _ _ _ Su] /names[_ _ _ _ Sw] E.
  by move: Su; rewrite E Sw => -[].
- by move=> c /mapP[u /names[_ _ _ lc Sc] ->]; rewrite mem_filter boundary_onesP lc /is_at_vertex Sc.
by rewrite size_map !size_filter.
Qed.

(** *** The rules *)

Lemma accepted_links : links_live t.
Proof.
split.
- move=> h lh; have [w [n [g [b [[tw lw _ _] [nx ln _] [pv lg _] _ [bh lb _ _]]]]]] := half_edge_ok lh.
  have [u oh [lu _]] := origin_ok lh.
  rewrite /origin /twin /next /prev /boundary_of !heardE // oh tw nx pv bh.
  by split; [exists u|exists w|exists n|exists g|exists b].
- move=> v lv; rewrite /leaving /isolated !heardE //; have [k] := vertices_ok lv; rewrite /around.
  case L: (says_leaving t v) => [l|].
    case: ifP => // /and3P[ll _]; case: (says_isolated t v) => // _ _; split; last by left.
    by left; exists l.
  rewrite /names_its_boundary; case E: (says_isolated t v) => [b|] //=; case: ifP => // /andP[lb _] _; split.
    by right; split=> //; apply/no_leaving_bare.
  by right; exists b.
- move=> b lb; have [f [p [[Ef _ lf _] [k K]]]] := namedP lb; rewrite /boundary_face /boundary_start !heardE // Ef.
  split; first by exists f.
  case S: (says_boundary_start t b) => [[l|v]|] /=.
  + by case: (along_start lb S).
  + by case: (all_isolated lb S).
  by move: K; rewrite /along S.
move=> f lf; split.
  case E: (outer t f) => [b|]; [right|by left].
  by exists b => //; have [] := @listed_named f Outer b E.
move=> i lt; have lt' : i < says_inner_count t f by move: lt; rewrite /inner_count lf.
have [b [lb _ _ L _]] := entryP ((entriesP f (Inner i)).2 (conj lf lt')).
by exists b.
Qed.

Lemma accepted_r1 : r1_live t.
Proof.
split; first exact: accepted_links.
apply: lists_short_if => f i lf lt.
have lt' : i < says_inner_count t f by move: lt; rewrite /inner_count lf.
have [b [lb Ef Ep L _]] := entryP ((entriesP f (Inner i)).2 (conj lf lt')).
by exists b; rewrite /boundary_face /boundary_place !heardE.
Qed.

Lemma accepted_map : is_map t.
Proof.
split; first by case: accepted_links.
- move=> h lh; have [w [_ [_ [_ [[tw lw wh tw'] _ _ _ _]]]]] := half_edge_ok lh.
  by rewrite /twin heardE // tw /= heardE // tw'; split=> // -[].
- move=> h lh; have [_ [n [g [_ [_ [nx ln pn] [pv lg gn] _ _]]]]] := half_edge_ok lh.
  by rewrite /next /prev heardE // nx /= !heardE // pn pv /= heardE // gn.
move=> h lh; have [w [n [_ [_ [[tw lw _ _] [nx ln _] _ [u on ow] _]]]]] := half_edge_ok lh.
by rewrite /next /twin /origin !heardE // nx tw /= !heardE // on ow.
Qed.

Lemma accepted_v1 : v1_leaving t.
Proof.
move=> v l lv; rewrite /leaving heardE // => L; have [k] := vertices_ok lv; rewrite /around L.
by case: ifP => // /and3P[ll /same_linkP ol _] _; rewrite /origin heardE.
Qed.

Lemma accepted_v2 : v2_rotation t.
Proof.
have map := accepted_map; move=> g h /dartP[x <-] /dartP[y <-]; rewrite (on_rotationE map) !(originE map).
split=> [/iter_findex <-|[E]]; first by congr Some; elim: (findex _ _ _) => //= k ->; rewrite org_tn.
have orgE (z : dart t) v : says_origin t (num z) = Some v -> org z = v.
  by move=> o; have := originE map z; rewrite /origin heardE ?dart_live // o => -[].
have [v ov [lv xv]] := origin_ok (dart_live x); have [w ow [lw yw]] := origin_ok (dart_live y).
have vw : w = v by rewrite -(orgE _ _ ow) -(orgE _ _ ov).
rewrite vw in yw; have [_ H] := around_listP lv; have [_ _ [l L lx]] := H _ xv; have [_ _ [l' L' ly]] := H _ yw.
move: L' ly; rewrite L => -[<-] ly.
have ll : half_edge t l.
  by have [k] := vertices_ok lv; rewrite /around L; case: ifP => // /and3P[].
have [z zl] := dartP ll; rewrite -zl in lx ly.
move/(on_rotationE map): lx => zx; move/(on_rotationE map): ly => zy.
by apply: connect_trans zy; rewrite fconnect_sym //; apply: tn_inj.
Qed.

Lemma accepted_b1 : b1_cycle t.
Proof.
split=> [h lh|b h lb lh].
  have [_ [n [_ [b [_ [nx ln _] _ _ [bh _ bn _]]]]]] := half_edge_ok lh.
  by rewrite /next /boundary_of !heardE // nx /= heardE // bn bh.
rewrite /boundary_of /boundary_start !heardE //; have [_ H] := along_listP lb; split=> [bh|[g S [k]]].
  have [c lc hc] := all_along lh; have [_ bc] := along_list_half_edge lc hc; move: bc; rewrite bh => -[bc].
  rewrite -bc in hc; have [_ _ _ [l S [hl [k Ek]]]] := H h hc; exists l => //; exists k; have [ll _] := along_start lb S.
  elim: k h Ek {lh bh hc} => //= k IH h; case E: (iter k _ _) => [g|] //= st; rewrite (IH g) //=.
  have lg : half_edge t g by apply: (along_orbit_live ll); exists k; exact: E.
  by have [nx _] := along_stepP st; rewrite /next heardE.
have : forall j i, iter j (obind (next t)) (Some g) = Some i -> i \in along_list b.
  elim=> [|j IH] i /=; first by case=> <-; case: (along_start lb S).
  case E: (iter j _ _) => [x|] //=; have [lx [n st nb] _ _] := H x (IH x E).
  by have [nx _] := along_stepP st; rewrite /next heardE // nx => -[<-].
by move=> /[apply] hb; case: (along_list_half_edge lb hb).
Qed.

Lemma accepted_b2 : b2_isolated t.
Proof.
move=> v lv; rewrite /isolated heardE //.
have starts b : starts_at_vertex t v b -> [/\ boundary t b, says_leaving t v = None & says_isolated t v = Some b].
  move=> S; have lb := heard_live S; move: S; rewrite /starts_at_vertex /boundary_start heardE // => S.
  by have [] := all_isolated lb S.
have [k Ek] := vertices_ok lv; move: Ek; rewrite /around => Ek; split=> [bv|nb].
  have L := (no_leaving_bare lv).2 bv; move: Ek; rewrite L /names_its_boundary.
  case E: (says_isolated t v) => [b|] //=; case: ifP => // /andP[lb] sv _; exists b; split=> // c.
  split=> [/starts[_ _]|->]; first by rewrite E => -[].
  by rewrite /starts_at_vertex /boundary_start heardE //; case: (says_boundary_start t b) sv => [[|u]|] //= /eqP->.
case L: (says_leaving t v) Ek => [l|]; last by case: nb; apply/no_leaving_bare.
case: ifP => // /and3P[_ _]; case: (says_isolated t v) => // _ _; split=> // b /starts[_].
by rewrite L.
Qed.

Lemma accepted_f1 : f1_outer t.
Proof.
have [_ _ _ /eqP one] := and4P counts; split=> [|f b v E S].
  have : count (predC (has_outer t)) (face_ones t) == 1.
    by move: one; rewrite -(count_predC (has_outer t)); arith.
  rewrite /face_ones /live_ones count_filter => /count1P[f /andP[_]|f [/andP[/= n lf] u]]; first exact: face_below.
  exists f; split; first by split=> //; rewrite /outer heardE //; move: n; rewrite /has_outer; case: (says_outer t f).
  by move=> g [lg E]; apply: u; rewrite /= lg andbT /has_outer; move: E; rewrite /outer heardE // => ->.
have [lb _ Ep] := @listed_named f Outer b E; have [_ [_ [_ [k]]]] := namedP lb.
by move: S; rewrite /starts_at_vertex /boundary_start heardE // /along => ->; rewrite Ep.
Qed.

Lemma accepted_f2 : f2_listed t.
Proof.
move=> b lb; have [f [p [[Ef Ep lf L] _]]] := namedP lb; exists f, p.
rewrite /boundary_face /boundary_place !heardE //; split=> // g q; split=> [/listed_named[_]|[-> ->] //].
by rewrite Ef Ep => -[->] [->].
Qed.

Lemma accepted_lower : lower t.
Proof.
have [_ l1 l2 l3] := accepted_map.
by case=> // _; [exact: accepted_r1|exact: accepted_v1|exact: accepted_v2|exact: accepted_b1|exact: accepted_b2|
  exact: accepted_f1|exact: accepted_f2].
Qed.

End Accepted.

End FastPathAccepted.
