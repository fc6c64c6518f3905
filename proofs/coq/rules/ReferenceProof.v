(** * ReferenceProof: the checker names the first broken rule, whatever the view *)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import Arith View Rules Loops LoopsProof Reference Map Counting.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** ** Places can be compared *)

Definition code (p : place) : option nat := if p is Inner i then Some i else None.
Definition uncode (c : option nat) : place := if c is Some i then Inner i else Outer.

Lemma codeK : cancel code uncode. Proof. by case. Qed.

Definition place_eqMixin := CanEqMixin codeK.
Canonical place_eqType := EqType place place_eqMixin.

Section Checks.
Variable t : view.

Lemma leadsP live l : reflect (leads_to live l) (leads live l).
Proof.
case: l => [i|] /=; last by constructor=> -[].
by apply: (iffP idP) => [|[j [->]]] //; exists i.
Qed.

Lemma nil_or_leadsP live l : reflect (nil_or_leads_to live l) (is_nil l || leads live l).
Proof.
case: l => [i|]; last by constructor; left.
by apply: (iffP (leadsP _ _)) => [|[]] //; right.
Qed.

Lemma same_linkP k l : reflect (k = l) (same_link k l).
Proof. by case: k l => [i|] [j|] /=; apply: (iffP idP) => // [/eqP->|[->]]. Qed.

Lemma each_half_edgeP (p : pred nat) : reflect (forall h, half_edge t h -> p h) (each_half_edge t p).
Proof. exact: each_liveP (@half_edge_below t). Qed.
Lemma each_vertexP (p : pred nat) : reflect (forall v, vertex t v -> p v) (each_vertex t p).
Proof. exact: each_liveP (@vertex_below t). Qed.
Lemma each_boundaryP (p : pred nat) : reflect (forall b, boundary t b -> p b) (each_boundary t p).
Proof. exact: each_liveP (@boundary_below t). Qed.
Lemma each_faceP (p : pred nat) : reflect (forall f, face t f -> p f) (each_face t p).
Proof. exact: each_liveP (@face_below t). Qed.

(** ** R1 *)

Lemma degree0P v : reflect (bare t v) (read (degrees t) v == 0).
Proof.
rewrite tallyE -leqn0 leqNgt -has_count; apply: (iffP hasPn) => H h; last first.
  by move=> _; apply/eqP=> E; apply: (H h (heard_live E) E).
move=> lh E; move: (H h); rewrite mem_iota add0n half_edge_below // => /(_ isT).
by rewrite E eqxx.
Qed.

Lemma start_livesP s : reflect (starts_live t s) (start_lives t s).
Proof. by case: s => [[h|v]|] /=; [apply: idP|apply: idP|constructor]. Qed.

Lemma fold_sum n (p : nat -> nat) a : fold_below n (fun sum i => sum + p i) a = a + sumn [seq p i | i <- iota 0 n].
Proof.
elim: n a => [|n IH] a; first by rewrite addn0.
by rewrite iotaS_cat map_cat sumn_cat /= IH; arith.
Qed.

Lemma fold_count n (p : pred nat) a : fold_below n (fun sum i => if p i then sum.+1 else sum) a = a + count p (iota 0 n).
Proof.
elim: n a => [|n IH] a; first by rewrite addn0.
by rewrite iotaS_cat count_cat /= IH; case: (p n); arith.
Qed.

Lemma check_lists_shortP : reflect (lists_short t) (check_lists_short t).
Proof. by rewrite /check_lists_short fold_sum fold_count; apply: idP. Qed.

Lemma check_linksP : reflect (links_live t) (check_links t (degrees t)).
Proof.
apply: (iffP and4P) => [[/each_half_edgeP H /each_vertexP V /each_boundaryP B /each_faceP F]|[H V B F]]; split.
- by move=> h /H /and5P[/leadsP ? /leadsP ? /leadsP ? /leadsP ? /leadsP ?].
- move=> v /V /andP[L /nil_or_leadsP I]; split=> //; case/orP: L => [/leadsP|/andP[N /degree0P]]; first by left.
  by case: (leaving t v) N => // _; right.
- by move=> b /B /andP[/leadsP ? /start_livesP].
- move=> f /F /andP[/nil_or_leadsP ? /all_belowP I]; split=> // i /I /leadsP //.
- by apply/each_half_edgeP=> h /H [? ? ? ? ?]; apply/and5P; split; apply/leadsP.
- apply/each_vertexP=> v /V [L /nil_or_leadsP ->]; rewrite andbT; apply/orP.
  by case: L => [/leadsP|[-> /degree0P]]; [left|right].
- by apply/each_boundaryP=> b /B [/leadsP-> /start_livesP].
- apply/each_faceP=> f /F [/nil_or_leadsP-> I]; apply/all_belowP=> i /I /leadsP //.
Qed.

Lemma check_r1P : reflect (r1_live t) (check_r1 t (degrees t)).
Proof.
by apply: (iffP andP) => [[/check_lists_shortP S /check_linksP L]|[/check_linksP L /check_lists_shortP S]].
Qed.

(** ** L1, L2, L3, V1 *)

Lemma check_l1P : reflect (l1_twin t) (check_l1 t).
Proof.
apply: (iffP (each_half_edgeP _)) => H h /H; first by case/andP=> /same_linkP-> /same_linkP.
by case=> /same_linkP-> /same_linkP.
Qed.

Lemma check_l2P : reflect (l2_next_prev t) (check_l2 t).
Proof.
apply: (iffP (each_half_edgeP _)) => H h /H; first by case/andP=> /same_linkP-> /same_linkP->.
by case=> /same_linkP-> /same_linkP->.
Qed.

Lemma check_l3P : reflect (l3_target t) (check_l3 t).
Proof. by apply: (iffP (each_half_edgeP _)) => H h /H /same_linkP. Qed.

Lemma check_v1P : reflect (v1_leaving t) (check_v1 t).
Proof.
apply: (iffP (each_vertexP _)) => [H v h /H + E|H v lv]; first by rewrite E => /same_linkP.
by case E: (leaving t v) => [h|] //; apply/same_linkP; apply: H.
Qed.

(** ** V2: a rotation has all half-edges with an origin if it has as many *)

Hypothesis r1 : links_live t.
Hypothesis map : is_map t.

Lemma degreeE v : read (degrees t) v = #|[pred x : dart t | org x == v]|.
Proof.
rewrite tallyE (@count_slots _ _ (@half_edge_below t)) => [|h /eqP]; last exact: heard_live.
by apply: eq_card => x; rewrite !inE (originE map).
Qed.

Lemma check_v2P : v1_leaving t -> reflect (v2_rotation t) (check_v2 t (degrees t)).
Proof.
move=> v1; have [_ V _ _] := r1.
have round x : round_trip (half_edge_slots t) (turn t) (num x) = Some (order (@tn t) x).
  have inj : injective (step (turn t) : dart t -> dart t).
    by move=> y z; rewrite !(step_turn map) => /(tn_inj map).
  rewrite (round_tripE (@half_edge_below t) (turn_total map) inj); congr Some.
  by apply: eq_card => y; rewrite !inE; apply: eq_fconnect; apply: step_turn.
have full x := orbit_fullP x (org_tn map).
have key : reflect (forall v x, vertex t v -> leaving t v = Some (num x) ->
    forall y, org y = org x -> fconnect (@tn t) x y) (check_v2 t (degrees t)).
  apply: (iffP (each_vertexP _)) => [H v x lv E|H v lv].
    have := H v lv; have ov := v1 v _ lv E; rewrite (originE map) in ov; case: ov => ov.
    rewrite E round => /same_linkP[]; rewrite degreeE -ov => /eqP /full //.
  case E: (leaving t v) => [h|] //; have ov := v1 v _ lv E.
  case/(originP map): (ov) => x xh xv; rewrite -xh round; apply/same_linkP; congr Some.
  by apply/eqP; rewrite degreeE -xv; apply/full; apply: (H v) => //; rewrite xh.
apply: (iffP key) => H.
  move=> g h /dartP[x <-] /dartP[y <-]; rewrite (on_rotationE map) !(originE map).
  split=> [/iter_findex<-|[E]]; first by congr Some; elim: (findex _ _ _) => //= k ->; rewrite org_tn.
  have lv := org_live map x; case: (V _ lv) => [[[l E' ll]|[_ b]] _]; last first.
    by case: (b (num x)); rewrite ?dart_live // (originE map).
  case/dartP: ll => z zl; have := v1 _ _ lv E'; rewrite -zl (originE map) => -[oz].
  have c := H _ z lv; rewrite E' zl in c.
  by apply: connect_trans (c erefl y _); rewrite ?oz // fconnect_sym ?c ?oz //; apply: tn_inj.
move=> v x lv E y oy; apply/(on_rotationE map)/H; rewrite ?dart_live //.
by rewrite !(originE map) oy.
Qed.

(** ** B1: a cycle has all half-edges of a boundary component if it has as many *)

Lemma lengthE b : read (lengths t) b = #|[pred x : dart t | bnd x == b]|.
Proof.
rewrite tallyE (@count_slots _ _ (@half_edge_below t)) => [|h /eqP]; last exact: heard_live.
by apply: eq_card => x; rewrite !inE (boundaryE map).
Qed.

Lemma check_b1P : reflect (b1_cycle t) (check_b1 t (lengths t)).
Proof.
have round x : round_trip (half_edge_slots t) (next t) (num x) = Some (order (@nx t) x).
  exact: (round_tripE (@half_edge_below t) (next_total map) (nx_inj map)).
have [_ _ B _] := r1.
have constP : reflect (forall h, half_edge t h -> next t h >>= boundary_of t = boundary_of t h)
    (each_half_edge t (fun h => same_link (next t h >>= boundary_of t) (boundary_of t h))).
  by apply: (iffP (each_half_edgeP _)) => H h /H /same_linkP.
have stay (C : forall h, half_edge t h -> next t h >>= boundary_of t = boundary_of t h) (x : dart t) : bnd (nx x) = bnd x.
  by have := C _ (dart_live x); rewrite (nextE map) /= !(boundaryE map) => -[].
apply: (iffP andP) => [[/constP C /each_boundaryP H]|[C H]]; split=> //; last 2 first.
- exact/constP.
- apply/each_boundaryP => b lb; have full x := orbit_fullP x (stay C).
  have none : (forall g, boundary_start t b <> Some (AtHalfEdge g)) -> read (lengths t) b == 0.
    move=> no; rewrite lengthE; apply/eqP; apply: eq_card0 => x; rewrite !inE; apply/eqP=> E.
    have [+ _] := H b (num x) lb (dart_live x); rewrite (boundaryE map) E.
    by case=> // g /no.
  have [_ sl] := B b lb; case E: (boundary_start t b) sl none => [[g|v]|] //= lg none; last by apply: none.
  case/dartP: lg => x xg; rewrite -xg round.
  have bx : bnd x = b.
    have [_ H2] := H b (num x) lb (dart_live x); rewrite (boundaryE map) in H2.
    have [//] : Some (bnd x) = Some b by apply: H2; exists g; rewrite // xg; exists 0.
  rewrite (boundaryE map) bx; apply/andP; split; first exact/same_linkP.
  apply/same_linkP; congr Some; rewrite lengthE -bx; apply/eqP/full => y yb.
  have [+ _] := H b (num y) lb (dart_live y); rewrite (boundaryE map) yb bx => -[] // g'.
  by rewrite E => -[<-]; rewrite -xg => /(on_cycleE map).
move=> b h lb /dartP[y <-]; have := H b lb; have full x := orbit_fullP x (stay C); rewrite (boundaryE map).
have [_ sl] := B b lb; case E: (boundary_start t b) sl => [[g|v]|] //= lg.
  case/dartP: lg => x <-; rewrite round (boundaryE map) => /andP[/same_linkP[bx] /same_linkP[]].
  rewrite lengthE -bx => /eqP /full F; split=> [[yb]|[_ [<-]]].
    by exists (num x) => //; apply/(on_cycleE map)/F.
  by move/(on_cycleE map)/iter_findex<-; congr Some; elim: (findex _ _ _) => //= k IH; rewrite stay.
rewrite lengthE => /eqP/card0_eq/(_ y); rewrite !inE => /eqP ne; split=> [[/ne]|[]] //.
Qed.

(** ** B2, F1, F2 *)

Lemma check_b2P : reflect (b2_isolated t) (check_b2 t (degrees t)).
Proof.
have [_ V B _] := r1.
apply: (iffP andP) => [[/each_boundaryP HB /each_vertexP HV]|H].
  move=> v lv; have := HV v lv; case: degree0P => b; last first.
    case E: (isolated t v) => //= _; split=> // _; split=> // c sc.
    have := HB c (heard_live sc); rewrite sc; case: degree0P => //.
  case E: (isolated t v) => [c|] // sc; split=> // _; exists c; split=> // d.
  have sv : starts_at_vertex t v c.
    by move: sc; rewrite /starts_at_vertex; case: (boundary_start t c) => [[|u]|] //= /eqP->.
  split=> [sd|->] //; have := HB d (heard_live sd); rewrite sd E.
  by case/andP=> _ /same_linkP[].
split.
  apply/each_boundaryP => b lb; have [_] := B b lb.
  case E: (boundary_start t b) => [[|v]|] //= lv; have [H1 H2] := H v lv.
  case: degree0P => bv; last by have [_ /(_ b)] := H2 bv.
  have [c [-> /(_ b)[+ _]]] := H1 bv; rewrite /starts_at_vertex E => /(_ erefl) ->.
  exact/same_linkP.
apply/each_vertexP => v lv; have [H1 H2] := H v lv; case: degree0P => bv; last by have [-> _] := H2 bv.
by have [c [-> /(_ c)[_ /(_ erefl)]]] := H1 bv; rewrite /starts_at_vertex => -> /=.
Qed.

Lemma check_f1P : reflect (f1_outer t) (check_f1 t).
Proof.
apply: (iffP andP) => [[one /each_faceP H]|[one H]]; last split; try split.
- move: one; rewrite tallyE => /count1P[|f [un U]].
    by move=> f; case: ifP => // /andP[/face_below].
  have P g : unbounded t g <-> (if face t g && is_nil (outer t g) then Some 0 else None) == Some 0.
    by rewrite /unbounded; case: (face t g); case: (outer t g) => //=; split=> // -[].
  by exists f; split=> [|g /P/U //]; apply/P.
- move=> f b v E sv; have := H f (heard_live E); rewrite E sv //.
- rewrite tallyE; apply/count1P => [f|]; first by case: ifP => // /andP[/face_below].
  have P g : unbounded t g <-> (if face t g && is_nil (outer t g) then Some 0 else None) == Some 0.
    by rewrite /unbounded; case: (face t g); case: (outer t g) => //=; split=> // -[].
  by case: one => f [/P pf U]; exists f; split=> // g /P/U.
- apply/each_faceP => f lf; case E: (outer t f) => [b|] //.
  by case S: (boundary_start t b) => [[|v]|] //; case: (H f b v E).
Qed.

Lemma same_placeP p q : reflect (p = Some q) (same_place p q).
Proof. by case: p q => [[|i]|] [|j] /=; apply: (iffP idP) => // [/eqP->|[->]]. Qed.

Lemma inner_lt f i b : inner t f i = Some b -> i < inner_count t f.
Proof. by rewrite /inner; case: ifP. Qed.

Lemma listed_face f p b : listed t f p = Some b -> face t f.
Proof.
case: p => [|i] /=; first exact: heard_live.
move/inner_lt; rewrite /inner_count; case: ifP => //.
Qed.

Lemma check_f2P : reflect (f2_listed t) (check_f2 t).
Proof.
have [_ _ _ F] := r1.
apply: (iffP andP) => [[/each_boundaryP HB /each_faceP HF]|H].
  move=> b lb; have := HB b lb; case Ef: (boundary_face t b) => [f|] //; case Ep: (boundary_place t b) => [p|] //.
  move/same_linkP=> E; exists f, p; split=> // f' p'; split=> [E'|[-> ->] //].
  have /andP[out /all_belowP inn] := HF f' (listed_face E').
  suff: names_place t f' p' (Some b) by rewrite /= Ef Ep => /andP[/same_linkP[] + /same_placeP[]].
  case: p' E' => [E'|i E']; first by rewrite -E'.
  by have := inn i (inner_lt E'); rewrite -E'.
split.
  apply/each_boundaryP => b lb; have [f [p [-> -> /(_ f p)[_ ]]]] := H b lb.
  by move=> -> //; apply/same_linkP.
have names f p b : listed t f p = Some b -> boundary t b -> names_place t f p (Some b).
  move=> E lb; have [f' [p' [Ef Ep /(_ f p)[/(_ E)[-> ->] _]]]] := H b lb.
  by rewrite /= Ef Ep; apply/andP; split; [apply/same_linkP|apply/same_placeP].
apply/each_faceP => f lf; have [O I] := F f lf; apply/andP; split.
  by case: O => [->|[b E lb]] //; have := names f Outer b E lb; rewrite /= E.
by apply/all_belowP => i /I[b E lb]; have := names f (Inner i) b E lb; rewrite /= E.
Qed.

End Checks.
