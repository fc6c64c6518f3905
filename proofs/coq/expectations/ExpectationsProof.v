(** * ExpectationsProof: the checker names the first broken rule, for every expectation and every structure

<<
      expectation, structure     R1  L1  …  T4  M1  …  M8
                                 ✓   ✓   ✗   ?   ?   ?   ?        first_broken_of e s = Some (Basic L2)
>>
*)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import Arith View Rules Loops Reference ReferenceProof Map Counting Expectations.
From twinedge Require Import ExpectationsCheck ExpectationsLists.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Lemma impP (a b : bool) (B : Prop) : reflect B b -> reflect (a -> B) (~~ a || b).
Proof. by case: a => /= r; [apply: (iffP r) => [|/(_ isT)] | left]. Qed.

Lemma is_nilP (l : link) : reflect (l = None) (is_nil l).
Proof. by case: l => [i|]; constructor. Qed.

Lemma orPP (a b : bool) (A B : Prop) : reflect A a -> reflect B b -> reflect (A \/ B) (a || b).
Proof. by move=> r q; apply: (iffP orP) => -[/r|/q]; auto; move/r || move/q; auto. Qed.

Lemma andPP (a b : bool) (A B : Prop) : reflect A a -> reflect B b -> reflect (A /\ B) (a && b).
Proof. by move=> r q; apply: (iffP andP) => -[/r ? /q ?]. Qed.

Lemma ifP_of (c a b : bool) (A B : Prop) : reflect A a -> reflect B b -> reflect (if c then A else B) (if c then a else b).
Proof. by case: c. Qed.

Section Rules.
Variables (e : expectation) (s : structure).
Notation t := (seen e s).

(** ** R1 *)

Lemma half_edge_liveP h : reflect (half_edge_live e s h) (check_half_edge e s h).
Proof.
apply: (iffP and5P) => -[o tw n p f]; split.
- exact/leadsP.
- by case/orP: tw => [/leadsP|]; [left|right].
- exact/leadsP.
- by move/(impP _ (leadsP _ _)): p.
- move: f; case: (has_faces s) => //= f _; case/orP: f => [/leadsP|/and3P[op tw' /is_nilP sd]]; [by left|right].
  by split=> //; move/is_nilP: tw'.
- exact/leadsP.
- by case: tw => [/leadsP->|->]; rewrite ?orbT.
- exact/leadsP.
- exact/(impP _ (leadsP _ _)).
case: (has_faces s) f => //= /(_ isT)[/leadsP-> //|[-> /is_nilP-> /is_nilP->]]; exact: orbT.
Qed.

Lemma vertex_liveP v : reflect (vertex_live e s v) (check_vertex e s v).
Proof.
apply: andPP (nil_or_leadsP _ _); apply: impP; apply: orPP (leadsP _ _) (andPP (is_nilP _) (bareP e s v)).
Qed.

Lemma face_liveP f : reflect (face_live e s f) (check_face e s f).
Proof.
apply: andPP; first by apply: impP; apply: ifP_of; [apply: leadsP | apply: start_livesP].
have each i : reflect (if has_records s then leads_to (boundary t) (inner t f i) else starts_live t (entry_start e s f (Inner i)))
    (if has_records s then leads (boundary t) (inner t f i) else start_lives t (entry_start e s f (Inner i))).
  by apply: ifP_of; [apply: leadsP | apply: start_livesP].
apply: (iffP allP) => H i; first by move=> lt; apply/each/H; rewrite mem_iota.
by rewrite mem_iota => lt; apply/each/H.
Qed.

Lemma decide_r1P : reflect (r1 e s) (decide_r1 e s).
Proof.
have HH := @each_half_edge e s _ _ (fun h _ => half_edge_liveP h).
have VV := @each_vertex e s _ _ (fun v _ => vertex_liveP v).
have BB := @each_boundary e s _ _ (fun b _ => andPP (leadsP (face t) (boundary_face t b)) (start_livesP t (boundary_start t b))).
have FF := @each_face e s _ _ (fun f _ => face_liveP f).
by apply: (iffP and5P) => [[S /HH ? /VV ? /BB ? /FF ?]|[/HH ? /VV ? /BB ? /FF ? S]].
Qed.

(** ** L1 to V2 *)

Lemma borderlessP h (a : bool) (A : Prop) : reflect A a -> reflect (~~ on_border e s h -> A) (on_border e s h || a).
Proof. by case: (on_border e s h) => r; [left | apply: (iffP r) => [|/(_ isT)]]. Qed.

Lemma decide_l1P : reflect (l1 e s) (decide_l1 e s).
Proof.
apply: each_half_edge => h _; apply: borderlessP; apply: andPP; first exact: same_linkP.
by apply: (iffP negP) => H /same_linkP.
Qed.

Lemma decide_l2P : reflect (l2 e s) (decide_l2 e s).
Proof.
rewrite /l2 /decide_l2; case: (has_prev s); first exact: check_l2P.
apply: (iffP allP) => H g; last first.
  rewrite mem_half_edges => lg; apply/allP=> h; rewrite mem_half_edges => lh.
  by apply/orP; case: (same_linkP (next t g) (next t h)) => [/(H g h lg lh)/eqP|]; [right|left].
move=> h lg lh E; have := H g; rewrite mem_half_edges => /(_ lg)/allP/(_ h); rewrite mem_half_edges => /(_ lh).
by rewrite E; case: same_linkP => //= _ /eqP.
Qed.

Lemma decide_l3P : reflect (l3 e s) (decide_l3 e s).
Proof. by apply: each_half_edge => h _; apply: borderlessP; apply: same_linkP. Qed.

Lemma decide_v2P : reflect (v2 e s) (decide_v2 e s).
Proof.
have rot g h : member h (orbit_of e s (turn t) g) || member h (if is_open e then orbit_of e s (turn_back e s) g else [::])
    <-> on_orbit (turn t) g h \/ is_open e /\ on_orbit (turn_back e s) g h.
  rewrite !memberE; split=> [/orP[/(orbitP _ _ (@turn_live e s))|]|[/(orbitP _ _ (@turn_live e s))->|[->]] //]; first by left.
    by case: (is_open e) => // /(orbitP _ _ (@turn_back_live e s)); right.
  by move/(orbitP _ _ (@turn_back_live e s))->; rewrite orbT.
apply: (iffP allP) => H g.
  move=> h lg lh; have := H g; rewrite mem_half_edges => /(_ lg)/allP/(_ h); rewrite mem_half_edges => /(_ lh)/eqP E.
  by rewrite -rot E; split=> /same_linkP.
rewrite mem_half_edges => lg; apply/allP=> h; rewrite mem_half_edges => lh; apply/eqP.
by apply/idP/same_linkP => [/rot|] /(H g h lg lh) // /rot.
Qed.

(** ** B1 to F2 *)

Lemma same_link_side h l : reflect (l = side e s h) (same_link l (side e s h)).
Proof. exact: same_linkP. Qed.

Lemma decide_b1P : reflect (b1 e s) (decide_b1 e s).
Proof.
apply: andPP; first by apply: impP; apply: each_half_edge => h _; apply: same_linkP.
case: (has_records s).
  have in_cycle b h : member h (if boundary_start t b is Some (AtHalfEdge g) then orbit_of e s (next t) g else [::])
      <-> exists2 g, boundary_start t b = Some (AtHalfEdge g) & on_cycle t g h.
    rewrite memberE; case: (boundary_start t b) => [[g|v]|]; [|by split=> // -[]..].
    by rewrite cycleP; split=> [c|[_ [<-]] //]; exists g.
  apply: (iffP allP) => H b.
    move=> h lb lh; have := H b; rewrite mem_boundaries => /(_ lb)/allP/(_ h); rewrite mem_half_edges => /(_ lh)/eqP E.
    by rewrite -in_cycle -E; split=> /same_linkP.
  rewrite mem_boundaries => lb; apply/allP=> h; rewrite mem_half_edges => lh; apply/eqP.
  by apply/same_linkP/idP => [|/in_cycle] /(H b h lb lh) // /in_cycle.
apply: (iffP allP) => H.
  move=> f p h E; have := H (f, p) (start_entry E); rewrite /= E; exact/same_linkP.
move=> [f p] _ /=; case E: (entry_start e s f p) => [[h|]|] //; apply/same_linkP; exact: H E.
Qed.

Lemma starts_atP v st : reflect (st = Some (AtVertex v)) (starts_at v st).
Proof. by case: st => [[h|u]|] /=; apply: (iffP idP) => // [/eqP->|[->]]. Qed.

Lemma decide_b2P : reflect (b2 e s) (decide_b2 e s).
Proof.
apply: impP; apply: each_vertex => v _; rewrite /b2_of.
have noneP (A : eqType) (p : pred A) (P : A -> Prop) (all_of : seq A) : (forall x, P x -> x \in all_of) ->
    (forall x, reflect (P x) (p x)) -> reflect (forall x, ~ P x) (~~ has p all_of).
  move=> inside pP; apply: (iffP hasPn) => H x; last by move=> _; apply/negP=> /pP; apply: H.
  by move=> Px; have := H x (inside x Px); move/pP: Px => ->.
have splitP (A : eqType) (p : pred A) (P : A -> Prop) (all_of : seq A) (legal : bool) : uniq all_of -> (forall x, P x -> x \in all_of) ->
    (forall x, reflect (P x) (p x)) ->
    reflect ((bare t v -> one_or_none P legal) /\ (~ bare t v -> forall x, ~ P x))
      (if bare_at e s v then one_or_none_in p all_of legal else ~~ has p all_of).
  move=> u inside pP; case: (bareP e s v) => b.
    by apply: (iffP (one_or_noneP u inside (fun x _ => conj (elimT (pP x)) (introT (pP x))) idP)) => [H|[H _]]; [split|apply: H].
  by apply: (iffP (noneP _ _ _ _ inside pP)) => [H|[_ H]]; [split|apply: H].
case: (has_records s).
  have startP b : reflect (starts_at_vertex t v b) (at_boundary e s v b) by apply: starts_atP.
  have inside b : starts_at_vertex t v b -> b \in boundary_list e s.
    by move=> E; rewrite mem_boundaries; apply: heard_live E.
  have u : uniq (boundary_list e s) by apply: filter_uniq (iota_uniq _ _).
  have S := splitP nat_eqType _ _ _ (~~ has_unbounded e s) u inside startP.
  rewrite -andbA; apply: (iffP (andPP S idP)) => [[[H1 H2] /andP[K L]]|[H1 [H2 H3]]].
    split=> //; split=> // b; split=> [E|E]; first by move: K; rewrite E => /startP.
    by have /allP/(_ b (inside b E)) := L; move/startP: E => -> /same_linkP.
  split; first by split.
  apply/andP; split; first by case E: (isolated t v) => [b|] //; apply/startP/H3.
  by apply/allP=> b _; case: startP => //= E; apply/same_linkP/H3.
apply: splitP (entries_uniq e s) _ _ => [[f p] E|[f p]]; first exact: start_entry E.
exact: starts_atP.
Qed.

Lemma decide_f1P : reflect (f1 e s) (decide_f1 e s).
Proof.
apply: impP; apply: andPP; last first.
  apply: (iffP allP) => H f; last by move=> _; case E: (entry_start e s f Outer) => [[|v]|] //; case: (H f v).
  move=> v E; have := H f; rewrite E => H'; suff: false by [].
  by apply: H'; rewrite mem_faces; move: (start_entry E); rewrite mem_entries => /andP[].
have filt f : f \in [seq f <- face_list e s | ~~ has_outer e s f] <-> is_unbounded e s f.
  by rewrite mem_filter mem_faces andbC; split=> [/andP[]|[-> ->]].
have u : uniq [seq f <- face_list e s | ~~ has_outer e s f] by do 2! apply: filter_uniq; apply: iota_uniq.
rewrite -size_filter; case: (has_unbounded e s); case: [seq f <- _ | _] filt u => [|f [|g rest]] filt u /=.
- by right=> -[f [/filt]].
- left; exists f; split=> [|g /filt]; first by apply/filt; rewrite mem_head.
  by rewrite inE => /eqP.
- right=> -[h [_ one]]; move: u; rewrite /= inE.
  by rewrite -(one f) ?(one g) ?eqxx //; apply/filt; rewrite !inE eqxx ?orbT.
- by left=> f /filt.
- by right=> /(_ f)[]; apply/filt; rewrite mem_head.
- by right=> /(_ f)[]; apply/filt; rewrite mem_head.
Qed.

Lemma check_listedP b : reflect (exists f p, [/\ boundary_face t b = Some f, (has_places s -> boundary_place t b = Some p)
    & forall f' p', listed t f' p' = Some b <-> f' = f /\ p' = p]) (check_listed e s b).
Proof.
rewrite /check_listed; case: (boundary_face t b) => [f|]; last by right=> -[f [p []]].
have mem f' p' : (f', p') \in [seq x <- entry_list e s | same_link (listed t x.1 x.2) (Some b)] <-> listed t f' p' = Some b.
  rewrite mem_filter /=; split=> [/andP[/same_linkP]//|E]; rewrite (listed_entry E) andbT; exact/same_linkP.
have u : uniq [seq x <- entry_list e s | same_link (listed t x.1 x.2) (Some b)] by apply: filter_uniq (entries_uniq e s).
rewrite -size_filter; apply: (iffP andP) => [[/hasP[[f' p] _ /and3P[/eqP/= -> P /same_linkP E]] /eqP one]|].
  exists f, p; split=> //; first by move: P; case: (has_places s) => //= /same_placeP.
  move=> g q; split=> [/mem|[-> ->] //]; move/mem: E; case: [seq x <- _ | _] one => [|x [|]] // _.
  by rewrite !inE => /eqP<- /eqP[-> ->].
case=> g [p [[fg] P L]]; rewrite -fg in L *; split.
  have E : listed t f p = Some b by apply/L.
  apply/hasP; exists (f, p); first exact: listed_entry E.
  rewrite /= eqxx /=; apply/andP; split; last exact/same_linkP.
  by case: (has_places s) P => //= /(_ isT)/same_placeP.
suff/perm_size-> : perm_eq [seq x <- entry_list e s | same_link (listed t x.1 x.2) (Some b)] [:: (f, p)] by [].
apply: uniq_perm => // -[f' p']; rewrite inE; apply/idP/eqP => [/mem/L[-> ->] //|[-> ->]].
by apply/mem/L.
Qed.

Lemma decide_f2P : reflect (f2 e s) (decide_f2 e s).
Proof.
rewrite /f2 /decide_f2; case: (has_records s); first by apply: each_boundary => b _; apply: check_listedP.
apply: impP; apply: each_half_edge => h _; apply: one_or_noneP; first exact: entries_uniq.
- by move=> [f p] [g E _]; apply: start_entry E.
- move=> [f p] _; rewrite /on_list /lists_cycle /=; case: (entry_start e s f p) => [[g|v]|]; [|by split=> // -[]..].
  by rewrite memberE cycleP; split=> [c|[_ [<-]] //]; exists g.
exact: is_nilP.
Qed.

End Rules.
