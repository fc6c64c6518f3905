(** * ExpectationsFaces: what the rules mean where each face has one cycle, on closed surfaces and in the closed plane

    Two half-edges bound the same face if and only if they are on the same cycle, and the face names one of them. There is nothing else
    to it. In the plane that is so where no lists of inner boundary components are stored, and the rotation system can be drawn.

<<
      face f ──► h ──next──► · ──next──► …        half-edges name f, or a boundary component that f lists as its outer one
>>
*)

From mathcomp Require Import all_ssreflect all_fingroup.
From twinedge Require Import View Rules Loops LoopsProof Reference Map Lists Subdivision Genus Bounds.
From twinedge Require Import RotationSystem Surface SurfaceComplete.
From twinedge Require Import Expectations ExpectationsPlane ExpectationsFaceless ExpectationsParts.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section Faces.
Variables (t : view) (on places holes unbounded : bool) (sf so : nat -> link) (si : nat -> nat -> option start).
Hypothesis off : holes && on = false.

(** The closed plane, or closed surfaces. *)
Let e := Expectation on false false false None false None None None false.

(** R1 to V2 make a rotation system, with faces or without. *)
Lemma rotations_of faces records : let s := Structure t (Parts true true faces records places holes unbounded) sf so si in
  (forall r, index r < index B1 -> holds_of e s (Basic r)) -> surface_rules t.
Proof.
move=> s H; have [Hh Hv _ _ _] := H R1 isT; split; last 2 first.
- exact: (H V1 isT).
- move=> g h lg lh; have [A B] := H V2 isT g h lg lh; split; first by move=> o; apply: A; left.
  by case/B=> [|[]].
- split=> [h lh|v lv]; last by have [A _] := Hv v lv; apply: A.
  by have [O [T|] // N P _] := Hh h lh; split=> //; apply: P.
split; [move=> h lh; exact: (H L1 isT h lh isT) | exact: (H L2 isT) | move=> h lh; exact: (H L3 isT h lh isT)].
Qed.

Section Kept.
Variable records : bool.
Let s := Structure t (Parts true true true records places holes unbounded) sf so si.
Hypothesis keeps : surface_rules t.

Lemma faces_t3 : on -> t3 e s <-> t3_euler (flat t).
Proof. exact: (faceless_t3 false false false false sf so si keeps). Qed.

Lemma all_t3 : (on -> t3_euler (flat t)) -> t3 e s.
Proof.
case O: on => t3; first by apply/faces_t3; [rewrite O | apply: t3].
move=> v lv; have [V [E [C [g [N eq]]]]] := has_genus keeps lv.
exists V, E, C; split; last by exists g; rewrite //= O.
exact/(faceless_counts false false false false sf so si on keeps).
Qed.

(** T4: there are no more faces than cycles, if some half-edge of each face has a cycle that has the key of the face. *)
Lemma all_t4 (key : nat -> nat) : t3_euler (flat t) ->
  (forall f, face t f -> exists2 h, half_edge t h & forall y, half_edge t y -> on_cycle t h y -> key y = f) -> t4 e s.
Proof.
move=> t3 named _ sim vs es fs Hv He Hf V3; have low := flat_lower keeps.
have plain : simple (flat t) by apply: (@same_simple (flat t) sf so si).
split; first exact: (edges_bound low t3 plain Hv (least_edges_each low He) V3).
apply: leq_trans (cycles_bound low t3 plain Hv V3); rewrite leq_add2r -[X in _ <= X](size_map key).
have [u mem] := Hf; have [_ live _ each] := cycles_each low; apply: uniq_leq_size => // f /mem lf.
have [h lh K] := named f lf; have [y yc c] := each h lh; apply/mapP; exists y => //.
by apply/esym/K; [apply: live | apply: (cycle_sym (flat_map keeps) (live y yc) lh c)].
Qed.

End Kept.

(** ** Faces that half-edges name *)

Section Named.
Let s := Structure t (Parts true true true false places holes unbounded) sf so si.

(** Each face is one cycle. *)
Definition faces_are_cycles :=
  [/\ forall h, half_edge t h -> exists2 f, sf h = Some f & face t f,
      forall g h, half_edge t g -> half_edge t h -> (sf g = sf h <-> on_cycle t g h)
    & forall f, face t f -> exists h, [/\ so f = Some h, half_edge t h & sf h = Some f]].

Lemma side_says h : half_edge t h -> side e s h = sf h.
Proof. by move=> lh; rewrite /side /heard /= -[half_edge _ h]/(half_edge t h) lh. Qed.

Lemma entry_outer f : face t f -> entry_start e s f Outer = omap AtHalfEdge (so f).
Proof. by move=> lf; rewrite /entry_start /heard /= -[face _ f]/(face t f) lf. Qed.

Lemma no_inner f : inner_count (seen e s) f = 0.
Proof.
rewrite /inner_count (_ : says_inner_count _ f = 0) ?if_same //.
by rewrite /seen /has_holes /= off.
Qed.

Lemma no_holes : has_holes e s = false.
Proof. by rewrite /has_holes /= off. Qed.

Lemma no_unbounded : has_unbounded e s = false.
Proof. by rewrite /has_unbounded no_holes. Qed.

Lemma entry_says f p h : entry_start e s f p = Some (AtHalfEdge h) -> [/\ p = Outer, face t f & so f = Some h].
Proof.
case: p => [|i]; last by rewrite /entry_start (_ : has_records s = false) // no_inner.
rewrite /entry_start /heard /= -[face _ f]/(face t f); case: (face t f) => //.
by case: (so f) => [k|] // [->].
Qed.

Lemma named_rules : rules_of e s <-> [/\ surface_rules t, faces_are_cycles & on -> t3_euler (flat t)].
Proof.
split=> [H|[keeps [live cycles listed] t3]].
  have keeps := rotations_of (fun r _ => H (Basic r)); split=> //; last by move=> pl; apply/(faces_t3 _ keeps pl)/(H (Basic T3)).
  have map := one_boundary_map keeps.
  have [Hh _ _ Hf _] := H (Basic R1); have [C E] := H (Basic B1); have [+ _] := H (Basic F1) isT; rewrite no_unbounded => none.
  have face_of h : half_edge t h -> exists2 f, sf h = Some f & face t f.
    by move=> lh; have [_ _ _ _ /(_ isT)[|[]//]] := Hh h lh; rewrite side_says.
  have kept f : face t f -> exists h, [/\ so f = Some h, half_edge t h & sf h = Some f].
    move=> lf; have : so f <> None.
      by move=> N; apply: (none f); split=> //; rewrite /has_outer /heard /= -[face _ f]/(face t f) lf N.
    case S: (so f) => [h|] // _; have En : entry_start e s f Outer = Some (AtHalfEdge h) by rewrite entry_outer // S.
    have lh : half_edge t h.
      have [+ _] := Hf f lf; rewrite En /=; apply.
      by rewrite /has_outer /heard /= -[face _ f]/(face t f) lf S.
    by exists h; split=> //; rewrite -(side_says lh); apply: (E f Outer h En).
  have along g h : half_edge t g -> on_cycle t g h -> half_edge t h /\ sf h = sf g.
    case/(dartP (t := one_boundary t))=> x <- [n]; elim: n h => [|n IH] h /=; first by case=> <-; split=> //; apply: dart_live.
    case I: (iter n _ _) => [k|] //= kh; have [lk sk] := IH k I.
    have lh : half_edge t h.
      have [y ky] := dartP (t := one_boundary t) lk; have N : next t (num y) = Some (num (nx y)) := nextE map y.
      by move: kh; rewrite -ky N => -[<-]; apply: (dart_live (nx y)).
    have := C isT k lk; rewrite -[next _ k]/(next t k) kh /= !side_says // sk; by split.
  split=> // g h lg lh; split=> [E1|/(along g h lg)[_ ->] //].
  have meets k : half_edge t k -> exists f h0, [/\ sf k = Some f, so f = Some h0 & on_cycle t k h0].
    move=> lk; have [f Ef lf] := face_of k lk; exists f.
    case: (H (Basic F2) isT k lk) => [[[f' p] [[h0 /= K c] _]]|[]]; last by rewrite side_says // Ef.
    have [_ lf' S] := entry_says K.
    have [l0 s0] := along k h0 lk c; have [h1 [S1 _ k1]] := kept f' lf'; move: S1; rewrite S => -[hh].
    by exists h0; split=> //; move: k1; rewrite -hh s0 Ef => -[->].
  have [f [h0 [Ef S c]]] := meets g lg; have [f' [h1 [Ef' S' c']]] := meets h lh.
  move: Ef'; rewrite -E1 Ef => -[ff]; move: S'; rewrite -ff S => -[hh]; rewrite -hh in c'.
  by have [l0 _] := along g h0 lg c; apply: (orbit_trans c); apply: (cycle_sym map lh l0 c').
have [[Hh Hv] [L1' L2' L3'] V1' V2'] := keeps; have map := one_boundary_map keeps.
have along h : half_edge t h -> exists2 n, next t h = Some n & half_edge t n /\ sf n = sf h.
  move=> lh; have [_ _ [n N ln] _] := Hh h lh; exists n => //; split=> //.
  by apply/esym/(cycles h n lh ln); exists 1; rewrite /= N.
case=> [[]|[] //] //.
- split=> // [h lh|v lv|f lf|].
  + have [O T N P] := Hh h lh; split=> //; first by left.
    by move=> _; left; rewrite side_says //; have [f E lf] := live h lh; exists f.
  + by split; [move=> _; apply: Hv | left; rewrite /isolated /heard; case: ifP].
  + have [h [S lh _]] := listed f lf; split; first by move=> _; rewrite entry_outer // S.
    by move=> i; rewrite no_inner.
  + rewrite /short /=; rewrite (_ : [seq _ | _ <- _] = [seq 0 | f <- iota 0 (face_slots t)]); last first.
      by apply: eq_map => f; apply: no_inner.
    by rewrite sumn_const.
- by move=> h lh _; apply: L1'.
- by move=> h lh _; apply: L3'.
- by move=> g h lg lh; split=> [[o|[]//]|o]; [exact: (V2' g h lg lh).1 o | left; exact: (V2' g h lg lh).2 o].
- split=> [_ h lh|f p h /entry_says[_ lf S]].
    by have [n N [ln E]] := along h lh; rewrite -[next _ h]/(next t h) N /= !side_says.
  by have [h' [S' lh E]] := listed f lf; move: S'; rewrite S => -[->]; rewrite side_says.
- by rewrite /= /b2 no_holes.
- rewrite /= /f1 no_unbounded => _; split=> [f [lf]|f v]; last by rewrite /entry_start (_ : has_records s = false) //; case: (heard _ _ _).
  have [h [S _ _]] := listed f lf; by rewrite /has_outer /heard /= -[face _ f]/(face t f) (lf : face t f) S.
- move=> _ h lh; left; have [f Ef lf] := live h lh; have [g [S lg Eg]] := listed f lf.
  exists (f, Outer); split; first by exists g; rewrite ?entry_outer ?S //; apply/(cycles h g lh lg); rewrite Ef.
  move=> [f' p] [k /= K c]; have [-> lf' S'] := entry_says K; have [k' [S2 lk E2]] := listed f' lf'; move: S2; rewrite S' => -[kk].
  by rewrite -kk in lk E2; have := (cycles h k lh lk).2 c; rewrite Ef E2 => -[->].
- by rewrite /= /t1 no_holes.
- by rewrite /= /t2 no_holes.
- exact: (all_t3 keeps t3).
move=> pl; apply: (all_t4 (key := fun y => odflt 0 (sf y)) keeps (t3 pl) _ pl) => f lf; have [h [_ lh E]] := listed f lf.
by exists h => // y ly c; rewrite -((cycles h y lh ly).2 c) E.
Qed.

End Named.

(** ** Faces with records for their boundary components: the surfaces of SurfaceComplete.v, without holes *)

Section Recorded.
Let s := Structure t (Parts true true true true places holes unbounded) sf so si.

Lemma recorded_holes : has_holes e s = false.
Proof. by rewrite /has_holes /= off. Qed.

Lemma recorded_unbounded : has_unbounded e s = false.
Proof. by rewrite /has_unbounded recorded_holes. Qed.

Lemma recorded_inner f : inner_count (seen e s) f = 0.
Proof.
rewrite /inner_count (_ : says_inner_count _ f = 0) ?if_same //.
by rewrite /seen /has_holes /= off.
Qed.

Lemma recorded_listed f p b : listed (seen e s) f p = Some b -> p = Outer /\ outer t f = Some b.
Proof. by case: p => [|i] //=; rewrite /inner recorded_inner. Qed.

Lemma recorded_start f : entry_start e s f Outer = outer t f >>= boundary_start t.
Proof. by []. Qed.

Definition surface_with_faces := [/\ is_surface t,
  forall b, boundary t b -> leads_to (face t) (boundary_face t b) & places -> forall b, boundary t b -> boundary_place t b = Some Outer].

Lemma is_surface_rotations : is_surface t -> surface_rules t.
Proof.
case=> map v1 bares v2 _ _ _ _ _ _; have [Hh L1' L2' L3'] := map; split=> //; split=> [h /Hh[]//|v lv].
case E: (leaving t v) => [h|]; last by right; split=> //; apply: bares.
by left; exists h => //; apply: heard_live (v1 v h lv E).
Qed.

Lemma recorded_rules : rules_of e s <-> surface_with_faces /\ (on -> t3_euler (flat t)).
Proof.
split=> [H|[[[map v1 bares v2 starts b1' faces boundaries apart beside] named at_outer] t3]].
  have keeps := rotations_of (fun r _ => H (Basic r)); have [[Hh Hv] [L1' L2' L3'] V1' V2'] := keeps.
  split; last by move=> pl; apply/(faces_t3 _ keeps pl)/(H (Basic T3)).
  have [Rh _ Rb Rf _] := H (Basic R1); have [+ no_vertex] := H (Basic F1) isT; rewrite recorded_unbounded => none.
  have F2' b : boundary t b -> exists2 f, boundary_face t b = Some f & outer t f = Some b /\ (places -> boundary_place t b = Some Outer).
    move=> lb; have [f [p [Ef P L]]] := H (Basic F2) b lb; exists f => //.
    have [pO O] := recorded_listed ((L f p).2 (conj erefl erefl)); split=> // pl; rewrite -pO; apply: P.
    by rewrite /has_places /has_records /= pl.
  have own b : boundary t b -> leads_to (face t) (boundary_face t b) by case/Rb.
  have no_hole h : half_edge t h -> in_hole t h = false.
    move=> lh; have [_ _ _ _ /(_ isT)[[b B lb]|[]//]] := Rh h lh; have [f Ef _] := F2' b lb.
    by rewrite /in_hole (B : boundary_of t h = Some b) Ef.
  split=> //; last by move=> pl b /F2'[f _ [_ /(_ pl)]].
  split=> //.
  - split=> // h lh; have [O T N P] := Hh h lh; split=> //.
    by have [_ _ _ _ /(_ isT)[|[]//]] := Rh h lh.
  - by move=> v lv E; case: (Hv v lv) => [[h]|[_ //]]; rewrite E.
  - move=> b lb; have [_] := Rb b lb; rewrite -[boundary_start _ b]/(boundary_start t b).
    case S: (boundary_start t b) => [[h|v]|] // lh; first by exists h.
    have [f _ [O _]] := F2' b lb; case: (no_vertex f v); by rewrite recorded_start O /= S.
  - by have [C B] := H (Basic B1); split=> // h lh; apply: (C isT).
  - move=> f lf; have : outer t f <> None.
      by move=> N; apply: (none f); split=> //; rewrite /has_outer /= -[outer _ f]/(outer t f) N.
    case O: (outer t f) => [b|] // _; exists b => //.
    have [+ _] := Rf f lf; rewrite /has_outer /= -[outer _ f]/(outer t f) O => /(_ isT)[b' [<-] lb].
    have [g [p [Eg _ L]]] := H (Basic F2) b lb; rewrite -[boundary_face _ b]/(boundary_face t b) in Eg.
    by rewrite Eg; have [<- _] := (L f Outer).1 O.
  - by move=> b f Ef; have [g Eg [O _]] := F2' b (heard_live Ef); move: Eg; rewrite Ef => -[->].
  - by move=> g h lg _; rewrite no_hole.
  move=> h g; case: (boolP (half_edge t h)) => [lh|no]; first by rewrite no_hole.
  by rewrite /in_hole /boundary_of /heard (negPf no).
have keeps : surface_rules t by apply: is_surface_rotations; split.
have [Hh L1' L2' L3'] := map; have [[_ Hv] _ _ _] := keeps; have [C B] := b1'.
case=> [[]|[] //] //.
- split=> // [h lh|v lv|b lb|f lf|].
  + have [O T N P D] := Hh h lh; split=> //; [by left|by left].
  + split; first by move=> _; apply: Hv.
    by left; rewrite /isolated /heard /= recorded_holes; case: ifP.
  + by split; [apply: named | rewrite -[boundary_start _ b]/(boundary_start t b); have [h -> lh] := starts b lb].
  + split; last by move=> i; rewrite recorded_inner.
    by move=> _; have [b O Ef] := faces f lf; exists b => //; apply: heard_live Ef.
  + rewrite /short (_ : [seq _ | _ <- _] = [seq 0 | f <- iota 0 (face_slots t)]); last first.
      by apply: eq_map => f; apply: recorded_inner.
    by rewrite sumn_const.
- by move=> h lh _; apply: L1'.
- by move=> h lh _; apply: L3'.
- by move=> g h lg lh; split=> [[o|[]//]|o]; [exact: (v2 g h lg lh).1 o | left; exact: (v2 g h lg lh).2 o].
- by rewrite /= /b2 recorded_holes.
- rewrite /= /f1 recorded_unbounded => _; split=> [f [lf]|f v].
    by rewrite /has_outer /= -[outer _ f]/(outer t f); have [b -> _] := faces f lf.
  rewrite recorded_start; case O: (outer t f) => [b|] //= S.
  by have [h S' _] := starts b (heard_live S); rewrite S' in S.
- move=> b lb; have [f Ef lf] := named b lb; exists f, Outer; split=> // [pl|f' p].
    by apply: at_outer => //; move: pl; rewrite /has_places; case/andP.
  split=> [/recorded_listed[-> O]|[-> ->]]; last exact: boundaries.
  have [b' O' Ef'] := faces f' (heard_live O); move: O'; rewrite O => -[bb].
  by move: Ef'; rewrite -bb Ef => -[->].
- by rewrite /= /t1 recorded_holes.
- by rewrite /= /t2 recorded_holes.
- exact: (all_t3 keeps t3).
move=> pl; apply: (all_t4 (key := fun y => odflt 0 (boundary_of t y >>= boundary_face t)) keeps (t3 pl) _ pl) => f lf.
have [b O Ef] := faces f lf; have [h S lh] := starts b (heard_live Ef); exists h => // y ly c.
by rewrite ((B b y (heard_live Ef) ly).2 (ex_intro2 _ _ h S c)) /= Ef.
Qed.

End Recorded.
End Faces.

(** ** On closed surfaces, and in the plane where no lists of inner boundary components are stored *)

Theorem named_faces t places holes unbounded sf so si :
  rules_of surface (Structure t (Parts true true true false places holes unbounded) sf so si) <->
  surface_rules t /\ faces_are_cycles t sf so.
Proof. by rewrite (named_rules t places unbounded sf so si (andbF holes)); split=> [[]|[]]. Qed.

Theorem recorded_faces t places holes unbounded sf so si :
  rules_of surface (Structure t (Parts true true true true places holes unbounded) sf so si) <-> surface_with_faces t places.
Proof. by rewrite (recorded_rules t places unbounded sf so si (andbF holes)); split=> [[]|]. Qed.

(** The rotation system can be drawn. *)
Definition is_plane t := exists r, represents_rotations t r /\ plane_system r.

Lemma plane_rotations t : surface_rules t -> t3_euler (flat t) <-> is_plane t.
Proof.
move=> keeps; split=> [t3|[r [rep d]]]; last by apply/(t3_drawn keeps rep).
by have [r rep] := (surface_rules_mean_rotations t).1 keeps; exists r; split=> //; apply/(t3_drawn keeps rep).
Qed.

Theorem named_faces_plane t places unbounded sf so si :
  rules_of plane (Structure t (Parts true true true false places false unbounded) sf so si) <->
  is_plane t /\ faces_are_cycles t sf so.
Proof.
rewrite (named_rules t places unbounded sf so si (erefl : false && true = false)).
split=> [[keeps H /(_ isT)/(plane_rotations keeps)]|[P H]] //.
have keeps : surface_rules t by case: P => r [rep _]; apply/surface_rules_mean_rotations; exists r.
by split=> // _; apply/(plane_rotations keeps).
Qed.

Theorem recorded_faces_plane t places unbounded sf so si :
  rules_of plane (Structure t (Parts true true true true places false unbounded) sf so si) <->
  is_plane t /\ surface_with_faces t places.
Proof.
rewrite (recorded_rules t places unbounded sf so si (erefl : false && true = false)).
have keeps : surface_with_faces t places -> surface_rules t by case=> /is_surface_rotations.
by split=> [[H /(_ isT)/(plane_rotations (keeps H))]|[P H]] //; split=> // _; apply/(plane_rotations (keeps H)).
Qed.

(** ** The same where `prev`, half-edges kept by vertices, or places are not stored *)

Section Filled.
Variables (v : view) (pr le pl ho un : bool) (sf so : nat -> link) (si : nat -> nat -> option start).

Theorem filled_named : let s := Structure v (Parts pr le true false pl ho un) sf so si in
  rules_of surface s <-> (exists r, represents_rotations (answers (filled surface s)) r) /\ faces_are_cycles v sf so.
Proof.
move=> s; rewrite (filled_rules s (isT : ~~ border_kept surface)) -surface_rules_mean_rotations.
by rewrite /s; case: pr s; case: le; case: pl => s; apply: named_faces.
Qed.

Theorem filled_recorded : let s := Structure v (Parts pr le true true pl ho un) sf so si in
  rules_of surface s <-> surface_with_faces (answers (filled surface s)) true.
Proof.
move=> s; rewrite (filled_rules s (isT : ~~ border_kept surface)).
by rewrite /s; case: pr s; case: le; case: pl => s; apply: recorded_faces.
Qed.

Theorem filled_named_plane : let s := Structure v (Parts pr le true false pl false un) sf so si in
  rules_of plane s <-> is_plane (answers (filled plane s)) /\ faces_are_cycles v sf so.
Proof.
move=> s; rewrite (filled_rules s (isT : ~~ border_kept plane)).
by rewrite /s; case: pr s; case: le; case: pl => s; apply: named_faces_plane.
Qed.

Theorem filled_recorded_plane : let s := Structure v (Parts pr le true true pl false un) sf so si in
  rules_of plane s <-> is_plane (answers (filled plane s)) /\ surface_with_faces (answers (filled plane s)) true.
Proof.
move=> s; rewrite (filled_rules s (isT : ~~ border_kept plane)).
by rewrite /s; case: pr s; case: le; case: pl => s; apply: recorded_faces_plane.
Qed.

End Filled.
