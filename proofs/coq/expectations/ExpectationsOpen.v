(** * ExpectationsOpen: what the rules mean where open boundaries are legal, and no lists of inner boundary components are looked at

    A rotation system from which some cycles may be missing (ExpectationsMissing.v), in the plane one that can be drawn edge by edge.
    Where faces are stored, each cycle that is there has a face of its own, or none; it has one if a half-edge of it lacks a twin.

<<
        ──h──►         h has a face and no twin, or
        ──h──►         h has a face, and its twin k has none: two ways to say that there is nothing on the other side
        ◄──k──
>>
*)

From mathcomp Require Import all_ssreflect all_fingroup.
From twinedge Require Import View Rules Loops LoopsProof Reference Map Counting Lists Subdivision Genus Bounds RotationSystem.
From twinedge Require Import Expectations ExpectationsLists ExpectationsPlane ExpectationsFaceless ExpectationsParts ExpectationsFaces.
From twinedge Require Import ExpectationsBorder ExpectationsMissing ExpectationsOpenCounts.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** The view stores a rotation system, but for cycles that are missing; in the plane it can be drawn, with these. *)
Definition is_open_map (on : bool) t := exists r missing, @represents_without t r missing /\ (on -> plane_system r).

(** Each cycle has a face of its own, which names it, or none. *)
Definition open_faces t (sf so : nat -> link) :=
  [/\ forall h, half_edge t h -> leads_to (face t) (sf h) \/ twin t h <> None /\ sf h = None,
      forall g h f, half_edge t g -> half_edge t h -> sf g = Some f -> (sf h = Some f <-> on_cycle t g h)
    & forall f, face t f -> exists h, [/\ so f = Some h, half_edge t h & sf h = Some f]].

(** The same with records: each cycle has a boundary component of its own, or none, and each of these a face. *)
Definition open_boundaries t (places : bool) :=
  [/\ forall h, half_edge t h -> leads_to (boundary t) (boundary_of t h) \/ twin t h <> None /\ boundary_of t h = None,
      forall g h b, half_edge t g -> half_edge t h -> boundary_of t g = Some b -> (boundary_of t h = Some b <-> on_cycle t g h),
      forall b, boundary t b -> exists h, [/\ boundary_start t b = Some (AtHalfEdge h), half_edge t h & boundary_of t h = Some b],
      (forall b, boundary t b -> leads_to (face t) (boundary_face t b)) /\ (forall f, face t f -> leads_to (boundary t) (outer t f))
    & (forall b f, boundary_face t b = Some f <-> outer t f = Some b) /\
      (places -> forall b, boundary t b -> boundary_place t b = Some Outer)].

(** The rules before T4. *)
Definition before_t4 e s := forall r, index r < index T4 -> holds_of e s (Basic r).

Lemma rules_before_t4 e s : rules_of e s -> before_t4 e s.
Proof. by move=> H r _; apply: H. Qed.

Lemma before_b1 e s : before_t4 e s -> forall r, index r < index B1 -> holds_of e s (Basic r).
Proof. by move=> H r lt; apply: H; apply: ltn_trans lt _. Qed.

Section Open.
Variables (t : view) (on places holes unbounded : bool) (sf so : nat -> link) (si : nat -> nat -> option start).
Hypothesis off : holes && on = false.
Let e := open_on on.

Notation w := (whole t).

(** ** T3 and T4 *)

Section Kept.
Variables faces records : bool.
Let s := Structure t (Parts true true faces records places holes unbounded) sf so si.
Hypothesis keeps : open_rules t.

Let rotations := whole_rotations keeps.
Let low := flat_lower rotations.

Lemma open_t3_plane : on -> t3 e s <-> t3_euler (flat w).
Proof.
move=> pl; rewrite -(faceless_t3 false false false false sf so si rotations pl).
exact: (open_t3 on faces records places holes unbounded sf so si keeps).
Qed.

Lemma open_all_t3 : (on -> t3_euler (flat w)) -> t3 e s.
Proof.
move=> T; apply/(open_t3 on faces records places holes unbounded sf so si keeps).
exact: (@all_t3 w on false false false sf so si false rotations T).
Qed.

(** T4: if there is more than one face, there are no more faces than cycles of the whole. *)
Lemma open_t4_if : t3_euler (flat w) ->
  (forall fs, lists fs (face (seen e s)) -> size fs <= maxn 1 (size (cycles (flat w)))) -> t4 e s.
Proof.
move=> T few _ sim vs es fs Hv He Hf V3.
have plain : simple (flat w).
  by apply: (@same_simple (flat w) sf so si); exact: (open_simple keeps sim).
split.
  apply: (edges_bound low T plain Hv _ V3); apply: (least_edges_each low).
  by apply: (lists_iff _ He) => h; exact: (least_edges_whole t h).
have := few fs Hf; rewrite leq_max => /orP[le|le].
  by apply: leq_trans (leq_mul (leqnn 2) V3); rewrite -[2 * 3]/(1 + 5) (leq_add le).
by apply: leq_trans (cycles_bound low T plain Hv V3); rewrite leq_add2r.
Qed.

Lemma open_all_t4 (key : nat -> nat) : t3_euler (flat w) ->
  (forall f, face (seen e s) f -> exists2 h, half_edge t h & forall y, half_edge t y -> on_cycle t h y -> key y = f) -> t4 e s.
Proof.
move=> T named; apply: open_t4_if T _ => fs Hf; rewrite leq_max -[X in _ || (_ <= X)](size_map key).
have [u mem] := Hf; have [_ live _ each] := cycles_each low; apply/orP; right; apply: uniq_leq_size => // f /mem lf.
have [h lh K] := named f lf; have lw : half_edge w h := live_old lh.
have [y yc c] := each h lw; have lyw : half_edge w y := live y yc; apply/mapP; exists y => //.
have hy : on_cycle w h y := cycle_sym (whole_map keeps) lyw lw c.
have {}hy : on_cycle t h y by apply/(cycle_old keeps _ lh).
by rewrite (K y) //; apply: (cycle_live_old keeps lh hy).
Qed.

Lemma open_cycle_sym g h : half_edge t g -> half_edge t h -> on_cycle t g h -> on_cycle t h g.
Proof.
move=> lg lh /(cycle_old keeps _ lg) c; apply/(cycle_old keeps _ lh).
exact: (cycle_sym (whole_map keeps) (live_old lg) (live_old lh) c).
Qed.

(** R1, L1, L2, L3, V1, V2 of half-edges and vertices. *)
Lemma open_l1 : l1 e s.
Proof. have [_ [L1 _ _] _ _] := keeps; by move=> h lh b; apply: (L1 h lh) => T; move: b; rewrite /on_border -[twin _ h]/(twin t h) T. Qed.

Lemma open_l3 : l3 e s.
Proof. have [_ [_ _ L3] _ _] := keeps; by move=> h lh b; apply: (L3 h lh) => T; move: b; rewrite /on_border -[twin _ h]/(twin t h) T. Qed.

Lemma open_v2 : v2 e s.
Proof.
have [_ _ _ V2] := keeps; move=> g h lg lh; split=> [[o|[_ o]]|/(V2 g h lg lh)[o|o]].
- by apply/(V2 g h lg lh); left.
- by apply/(V2 g h lg lh); right.
- by left.
by right.
Qed.

Lemma open_border h : twin t h = None -> on_border e s h.
Proof. by rewrite /on_border -[twin (seen _ _) h]/(twin t h) => ->. Qed.

Lemma open_half_edge h : half_edge t h -> [/\ leads_to (vertex t) (origin t h), leads_to (half_edge t) (twin t h) \/ on_border e s h,
  leads_to (half_edge t) (next t h) & leads_to (half_edge t) (prev t h)].
Proof. by move=> lh; have [O T N P] := lives keeps lh; split=> //; case: T => [|/open_border]; [left|right]. Qed.

End Kept.

Lemma open_maps : open_rules t /\ (on -> t3_euler (flat w)) <-> is_open_map on t.
Proof.
split=> [[keeps T]|[r [missing [[may [nv [nd rep]]] d]]]].
  have [r [nv [nd rep]]] := (surface_rules_mean_rotations _).1 (whole_rotations keeps).
  exists r, (is_new t nd); split; first exact: (whole_without keeps rep).
  by move=> pl; apply/(t3_drawn (whole_rotations keeps) _).1; [exists nv, nd | apply: T].
have keeps := without_rules may rep; split=> // pl.
exact: (t3_drawn (whole_rotations keeps) (without_whole may rep)).2 (d pl).
Qed.

(** ** No faces *)

Lemma open_faceless_before records : before_t4 e (Structure t (Parts true true false records places holes unbounded) sf so si) ->
  open_rules t /\ (on -> t3_euler (flat w)).
Proof.
move=> H; have keeps := links_open (before_b1 H); split=> // pl.
by apply/(open_t3_plane _ _ keeps pl)/(H T3 isT).
Qed.

Theorem open_faceless_rules records : rules_of e (Structure t (Parts true true false records places holes unbounded) sf so si) <->
  open_rules t /\ (on -> t3_euler (flat w)).
Proof.
set s := Structure _ _ _ _ _; split=> [/rules_before_t4/open_faceless_before|[keeps T]] //.
have [[Hh Hv] [_ L2 _] V1 _] := keeps.
case=> [[]|[] //] //.
- split=> // [h lh|v lv]; first by have [O T' N P] := open_half_edge false records keeps lh; split.
  by split; [move=> _; apply: Hv | left; rewrite /isolated /heard; case: ifP].
- exact: open_l1.
- exact: open_l3.
- exact: open_v2.
- by split=> //= f [|i] h.
- exact: open_all_t3.
by move=> pl; apply: (open_all_t4 (key := id) keeps (T pl)).
Qed.

(** ** Faces that half-edges name *)

Section Named.
Let s := Structure t (Parts true true true false places holes unbounded) sf so si.

Let no_holes : has_holes e s = false. Proof. by rewrite /has_holes /= off. Qed.
Let no_unbounded : has_unbounded e s = false. Proof. by rewrite /has_unbounded no_holes. Qed.

Lemma open_side h : half_edge t h -> side e s h = sf h.
Proof. by move=> lh; rewrite /side /heard /= -[half_edge _ h]/(half_edge t h) lh. Qed.

Lemma open_entry_outer f : face t f -> entry_start e s f Outer = omap AtHalfEdge (so f).
Proof. by move=> lf; rewrite /entry_start /heard /= -[face _ f]/(face t f) lf. Qed.

Lemma open_no_inner f : inner_count (seen e s) f = 0.
Proof. by rewrite /inner_count (_ : says_inner_count _ f = 0) ?if_same // /seen no_holes. Qed.

Lemma open_entry f p h : entry_start e s f p = Some (AtHalfEdge h) -> [/\ p = Outer, face t f & so f = Some h].
Proof.
case: p => [|i]; last by rewrite /entry_start (_ : has_records s = false) // open_no_inner.
rewrite /entry_start /heard /= -[face _ f]/(face t f); case: (face t f) => //.
by case: (so f) => [k|] // [->].
Qed.

Lemma open_named_before : before_t4 e s -> [/\ open_rules t, open_faces t sf so & on -> t3_euler (flat w)].
Proof.
move=> H.
have keeps := links_open (before_b1 H); split=> //; last by move=> pl; apply/(open_t3_plane _ _ keeps pl)/(H T3 isT).
have [Hh _ _ Hf _] := H R1 isT; have [C E] := H B1 isT; have [+ _] := H F1 isT isT; rewrite no_unbounded => none.
have kept f : face t f -> exists h, [/\ so f = Some h, half_edge t h & sf h = Some f].
  move=> lf; have : so f <> None.
    by move=> N; apply: (none f); split=> //; rewrite /has_outer /heard /= -[face _ f]/(face t f) lf N.
  case S: (so f) => [h|] // _; have En : entry_start e s f Outer = Some (AtHalfEdge h) by rewrite open_entry_outer // S.
  have lh : half_edge t h.
    have [+ _] := Hf f lf; rewrite En /=; apply.
    by rewrite /has_outer /heard /= -[face _ f]/(face t f) lf S.
  by exists h; split=> //; rewrite -(open_side lh); apply: (E f Outer h En).
have along g h : half_edge t g -> on_cycle t g h -> half_edge t h /\ sf h = sf g.
  move=> lg [n]; elim: n h => [|n IH] h; first by case=> <-.
  rewrite iterS; case I: (iter n _ _) => [k|] // kh; have {}kh : next t k = Some h := kh; have [lk sk] := IH k I.
  have lh : half_edge t h by have [_ _ [m M lm] _] := lives keeps lk; move: kh; rewrite M => -[<-].
  by have := C isT k lk; rewrite -[next _ k]/(next t k) kh /= !open_side // sk.
split=> // [h lh|g h f lg lh Ef].
  have [_ _ _ _ /(_ isT)[]] := Hh h lh; first by rewrite open_side //; left.
  by case=> _ T; rewrite open_side //; right.
split=> [Ef'|/(along g h lg)[_ ->] //].
have meets k : half_edge t k -> sf k = Some f -> exists2 h0, so f = Some h0 & on_cycle t k h0.
  move=> lk Ek; case: (H F2 isT isT k lk) => [[[f' p] [[h0 /= K c] _]]|[]]; last by rewrite open_side // Ek.
  have [_ lf' S] := open_entry K.
  have [l0 s0] := along k h0 lk c; have [h1 [S1 _ k1]] := kept f' lf'; move: S1; rewrite S => -[hh].
  by exists h0 => //; move: k1; rewrite -hh s0 Ek => -[->].
have [h0 S c] := meets g lg Ef; have [h1 S' c'] := meets h lh Ef'; move: S'; rewrite S => -[hh]; rewrite -hh in c'.
by have [l0 _] := along g h0 lg c; apply: (orbit_trans c); apply: (open_cycle_sym keeps lh l0 c').
Qed.

Theorem open_named_rules : rules_of e s <-> [/\ open_rules t, open_faces t sf so & on -> t3_euler (flat w)].
Proof.
split=> [/rules_before_t4/open_named_before|[keeps [live cycles listed] T]] //.
have [[Hh Hv] [_ L2 _] V1 _] := keeps.
have same g h : half_edge t g -> half_edge t h -> on_cycle t g h -> sf h = sf g.
  move=> lg lh c; case Eg: (sf g) => [f|]; first by apply/(cycles g h f lg lh Eg).
  case Eh: (sf h) => [f|] //; have /(cycles h g f lh lg Eh) := open_cycle_sym keeps lg lh c; by rewrite Eg.
case=> [[]|[] //] //.
- split=> // [h lh|v lv|f lf|].
  + have [O T' N P] := open_half_edge true false keeps lh; split=> // _.
    by rewrite open_side //; case: (live h lh) => [|[]]; [left|right].
  + by split; [move=> _; apply: Hv | left; rewrite /isolated /heard; case: ifP].
  + have [h [S lh _]] := listed f lf; split; first by move=> _; rewrite open_entry_outer // S.
    by move=> i; rewrite open_no_inner.
  + rewrite /short /=; rewrite (_ : [seq _ | _ <- _] = [seq 0 | f <- iota 0 (face_slots t)]); last first.
      by apply: eq_map => f; apply: open_no_inner.
    by rewrite sumn_const.
- exact: open_l1.
- exact: open_l3.
- exact: open_v2.
- split=> [_ h lh|f p h /open_entry[_ lf S]].
    have [_ _ [n N ln] _] := lives keeps lh; rewrite -[next _ h]/(next t h) N /= !open_side //.
    by apply: same => //; exists 1; rewrite /= N.
  by have [h' [S' lh E]] := listed f lf; move: S'; rewrite S => -[->]; rewrite open_side.
- by rewrite /= /b2 no_holes.
- rewrite /= /f1 no_unbounded => _; split=> [f [lf]|f v]; last by rewrite /entry_start (_ : has_records s = false) //; case: (heard _ _ _).
  have [h [S _ _]] := listed f lf; by rewrite /has_outer /heard /= -[face _ f]/(face t f) (lf : face t f) S.
- move=> _ h lh; case Ef: (sf h) => [f|].
    left; have lf : face t f by case: (live h lh) => [[f']|[_]]; rewrite Ef // => -[->].
    have [g [S lg Eg]] := listed f lf.
    exists (f, Outer); split; first by exists g; rewrite ?open_entry_outer ?S //; apply/(cycles h g f lh lg Ef).
    move=> [f' p] [k /= K c]; have [-> lf' S'] := open_entry K; have [k' [S2 lk E2]] := listed f' lf'; move: S2; rewrite S' => -[kk].
    by rewrite -kk in lk E2; move: E2; rewrite (same h k lh lk c) Ef => -[->].
  right; split; first by rewrite open_side.
  move=> [f' p] [k /= K c]; have [_ lf' S'] := open_entry K; have [k' [S2 lk E2]] := listed f' lf'; move: S2; rewrite S' => -[kk].
  by rewrite -kk in lk E2; move: E2; rewrite (same h k lh lk c) Ef.
- by rewrite /= /t1 no_holes.
- by rewrite /= /t2 no_holes.
- exact: open_all_t3.
move=> pl; apply: (open_all_t4 (key := fun y => odflt 0 (sf y)) keeps (T pl) _ pl) => f lf; have [h [_ lh E]] := listed f lf.
by exists h => // y ly c; rewrite (same h y lh ly c) E.
Qed.

End Named.

(** ** Faces with records for their boundary components *)

Section Recorded.
Let s := Structure t (Parts true true true true places holes unbounded) sf so si.

Let no_holes : has_holes e s = false. Proof. by rewrite /has_holes /= off. Qed.
Let no_unbounded : has_unbounded e s = false. Proof. by rewrite /has_unbounded no_holes. Qed.

Lemma open_recorded_inner f : inner_count (seen e s) f = 0.
Proof. by rewrite /inner_count (_ : says_inner_count _ f = 0) ?if_same // /seen no_holes. Qed.

Lemma open_listed f p b : listed (seen e s) f p = Some b -> p = Outer /\ outer t f = Some b.
Proof. by case: p => [|i] //=; rewrite /inner open_recorded_inner. Qed.

Lemma open_start f : entry_start e s f Outer = outer t f >>= boundary_start t.
Proof. by []. Qed.

Lemma open_recorded_before : before_t4 e s -> [/\ open_rules t, open_boundaries t places & on -> t3_euler (flat w)].
Proof.
move=> H.
have keeps := links_open (before_b1 H); split=> //; last by move=> pl; apply/(open_t3_plane _ _ keeps pl)/(H T3 isT).
have [Rh _ Rb Rf _] := H R1 isT; have [C B] := H B1 isT.
have [+ no_vertex] := H F1 isT isT; rewrite no_unbounded => none.
have F2' b : boundary t b -> exists2 f, boundary_face t b = Some f & outer t f = Some b /\ (places -> boundary_place t b = Some Outer).
  move=> lb; have [f [p [Ef P L]]] := H F2 isT b lb; exists f => //.
  have [pO O] := open_listed ((L f p).2 (conj erefl erefl)); split=> // pl; rewrite -pO; apply: P.
  by rewrite /has_places /has_records /= pl.
have sides h : half_edge t h -> leads_to (boundary t) (boundary_of t h) \/ twin t h <> None /\ boundary_of t h = None.
  by move=> lh; have [_ _ _ _ /(_ isT)[|[]]] := Rh h lh; [left|right].
have startE b : boundary t b -> exists2 h, boundary_start t b = Some (AtHalfEdge h) & half_edge t h.
  move=> lb; have [_] := Rb b lb; rewrite -[boundary_start _ b]/(boundary_start t b).
  case S: (boundary_start t b) => [[h|v]|] // lh; first by exists h.
  have [f _ [O _]] := F2' b lb; case: (no_vertex f v); by rewrite open_start O /= S.
have outersE f : face t f -> leads_to (boundary t) (outer t f).
  move=> lf; have : outer t f <> None.
    by move=> N; apply: (none f); split=> //; rewrite /has_outer /= -[outer _ f]/(outer t f) N.
  case O: (outer t f) => [b|] // _; have [+ _] := Rf f lf.
  by rewrite /has_outer /= -[outer _ f]/(outer t f) O => /(_ isT).
split=> //.
- move=> g h b lg lh Eg; have lb : boundary t b by case: (sides g lg) => [[c]|[_]]; rewrite Eg // => -[->].
  have [k S kg] := (B b g lb lg).1 Eg; have {}S : boundary_start t b = Some (AtHalfEdge k) := S.
  have [h0 S' lk] := startE b lb; move: S'; rewrite S => -[kk]; rewrite -{h0}kk in lk.
  split=> [/(B b h lb lh)[k' S']|gh].
    have {}S' : boundary_start t b = Some (AtHalfEdge k') := S'; move: S'; rewrite S => -[<-].
    apply: orbit_trans; exact: (open_cycle_sym keeps lk lg kg).
  by apply/(B b h lb lh); exists k => //; apply: orbit_trans kg gh.
- move=> b lb; have [h S lh] := startE b lb; exists h; split=> //; apply/(B b h lb lh); exists h => //; by exists 0.
- by split=> // b /Rb[].
split=> [b f|pl b /F2'[f _ [_ /(_ pl)]] //]; split=> [Ef|O].
  by have [g Eg [O _]] := F2' b (heard_live Ef); move: Eg; rewrite Ef => -[->].
have [c O' lb] := outersE f (heard_live O); move: O'; rewrite O => -[bc]; rewrite -bc in lb.
have [g [p [Eg _ L]]] := H F2 isT b lb; rewrite -[boundary_face _ b]/(boundary_face t b) in Eg.
by rewrite Eg; have [<- _] := (L f Outer).1 O.
Qed.

Theorem open_recorded_rules : rules_of e s <-> [/\ open_rules t, open_boundaries t places & on -> t3_euler (flat w)].
Proof.
split=> [/rules_before_t4/open_recorded_before|[keeps [live cycles starts [faced outers] [same at_outer]] T]] //.
have [[Hh Hv] [_ L2 _] V1 _] := keeps.
have along g h : half_edge t g -> half_edge t h -> on_cycle t g h -> boundary_of t h = boundary_of t g.
  move=> lg lh c; case Eg: (boundary_of t g) => [b|]; first by apply/(cycles g h b lg lh Eg).
  case Eh: (boundary_of t h) => [b|] //; have /(cycles h g b lh lg Eh) := open_cycle_sym keeps lg lh c; by rewrite Eg.
case=> [[]|[] //] //.
- split=> // [h lh|v lv|b lb|f lf|].
  + have [O T' N P] := open_half_edge true true keeps lh; split=> // _.
    by case: (live h lh) => [|[]]; [left|right].
  + split; first by move=> _; apply: Hv.
    by left; rewrite /isolated /heard /= no_holes; case: ifP.
  + by split; [apply: faced | rewrite -[boundary_start _ b]/(boundary_start t b); have [h [-> lh _]] := starts b lb].
  + by split; [move=> _; apply: outers | move=> i; rewrite open_recorded_inner].
  + rewrite /short (_ : [seq _ | _ <- _] = [seq 0 | f <- iota 0 (face_slots t)]); last first.
      by apply: eq_map => f; apply: open_recorded_inner.
    by rewrite sumn_const.
- exact: open_l1.
- exact: open_l3.
- exact: open_v2.
- split=> [_ h lh|b h lb lh].
    have [_ _ [n N ln] _] := lives keeps lh; rewrite -[next _ h]/(next t h) N /=.
    by apply: along => //; exists 1; rewrite /= N.
  have [g [S lg Eg]] := starts b lb; split=> [/(cycles g h b lg lh Eg)|[g' S' c]]; first by exists g.
  have {}S' : boundary_start t b = Some (AtHalfEdge g') := S'; move: S'; rewrite S => -[gg]; rewrite -gg in c.
  by apply/(cycles g h b lg lh Eg).
- by rewrite /= /b2 no_holes.
- rewrite /= /f1 no_unbounded => _; split=> [f [lf]|f v].
    by rewrite /has_outer /= -[outer _ f]/(outer t f); have [b -> _] := outers f lf.
  rewrite open_start; case O: (outer t f) => [b|] //= S.
  by have [h [S' _ _]] := starts b (heard_live S); rewrite S' in S.
- move=> b lb; have [f Ef lf] := faced b lb; exists f, Outer; split=> // [pl|f' p].
    by apply: at_outer => //; move: pl; rewrite /has_places; case/andP.
  split=> [/open_listed[-> /same]|[-> ->]]; last exact/same.
  by rewrite Ef => -[->].
- by rewrite /= /t1 no_holes.
- by rewrite /= /t2 no_holes.
- exact: open_all_t3.
move=> pl; apply: (open_all_t4 (key := fun y => odflt 0 (boundary_of t y >>= boundary_face t)) keeps (T pl) _ pl) => f lf.
have [b O lb] := outers f lf; have [h [S lh Eh]] := starts b lb; exists h => // y ly c.
by rewrite (along h y lh ly c) Eh /= ((same b f).2 O).
Qed.

End Recorded.
End Open.

(** ** So the rules mean surfaces with a border, and those that can be drawn in the plane *)

Theorem open_faceless on t records places holes unbounded sf so si :
  rules_of (open_on on) (Structure t (Parts true true false records places holes unbounded) sf so si) <-> is_open_map on t.
Proof. by rewrite open_faceless_rules open_maps. Qed.

Theorem open_named on t places holes unbounded sf so si : holes && on = false ->
  rules_of (open_on on) (Structure t (Parts true true true false places holes unbounded) sf so si) <->
  is_open_map on t /\ open_faces t sf so.
Proof. by move=> off; rewrite open_named_rules // -open_maps; split=> [[]|[[]]]. Qed.

Theorem open_recorded on t places holes unbounded sf so si : holes && on = false ->
  rules_of (open_on on) (Structure t (Parts true true true true places holes unbounded) sf so si) <->
  is_open_map on t /\ open_boundaries t places.
Proof. by move=> off; rewrite open_recorded_rules // -open_maps; split=> [[]|[[]]]. Qed.

(** ** The same where `prev`, half-edges kept by vertices, or places are not stored *)

Section Filled.
Variables (on : bool) (v : view) (pr le pl ho un : bool) (sf so : nat -> link) (si : nat -> nat -> option start).

Theorem filled_open_faceless bo : let s := Structure v (Parts pr le false bo pl ho un) sf so si in
  rules_of (open_on on) s <-> is_open_map on (answers (filled (open_on on) s)).
Proof.
move=> s; rewrite (filled_rules s (isT : ~~ border_kept (open_on on))).
by rewrite /s; case: pr s; case: le; case: pl => s; apply: open_faceless.
Qed.

Theorem filled_open_named : ho && on = false -> let s := Structure v (Parts pr le true false pl ho un) sf so si in
  rules_of (open_on on) s <-> is_open_map on (answers (filled (open_on on) s)) /\ open_faces v sf so.
Proof.
move=> off s; rewrite (filled_rules s (isT : ~~ border_kept (open_on on))).
by rewrite /s; case: pr s; case: le; case: pl => s; apply: open_named.
Qed.

Theorem filled_open_recorded : ho && on = false -> let s := Structure v (Parts pr le true true pl ho un) sf so si in
  rules_of (open_on on) s <-> is_open_map on (answers (filled (open_on on) s)) /\ open_boundaries (answers (filled (open_on on) s)) true.
Proof.
move=> off s; rewrite (filled_rules s (isT : ~~ border_kept (open_on on))).
by rewrite /s; case: pr s; case: le; case: pl => s; apply: open_recorded.
Qed.

End Filled.
