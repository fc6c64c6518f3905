(** * ExpectationsBorder: an open boundary is filled with half-edges that run the other way

    Where half-edges may lack a twin, each of these gets one. It is followed by that of the half-edge that ends where this one
    begins, so that the new half-edges run along the border. The whole is a rotation system: around a vertex of the border, what was
    a row of half-edges is now closed by one that is new.

<<
             ▲ ▲            h has no twin: h' is new, from the end of h to its origin. g is the half-edge without twin that ends
      k ◄─── · ───► h       where h begins, and k its next. Around the vertex: k, …, h, and now g', which k follows.
           ╱   ◄─── h'
       g ╱ ╱ g'             next h' = g'
>>
*)

From mathcomp Require Import all_ssreflect all_fingroup.
From twinedge Require Import Arith View Rules Loops LoopsProof Reference ReferenceProof Map Subdivision RotationSystem ExpectationsParts.
From twinedge Require Import Expectations.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section Border.
Variable t : view.

Definition lacks_twin h := half_edge t h && is_nil (twin t h).
Definition end_at h : link := next t h >>= origin t.

(** The half-edge without twin that ends, or begins, at the vertex: the first one. *)
Definition border_into (v : link) : link := ohead [seq g <- iota 0 (half_edge_slots t) | lacks_twin g && same_link (end_at g) v].
Definition border_from (v : link) : link := ohead [seq g <- iota 0 (half_edge_slots t) | lacks_twin g && same_link (origin t g) v].

(** The new half-edge beside [h] has the number [half_edge_slots t + h]. *)
Definition beside h := half_edge_slots t + h.
Definition old_or T (old new : nat -> T) i := if i < half_edge_slots t then old i else new (i - half_edge_slots t).

Definition whole : view := {|
  vertex_slots := vertex_slots t;
  half_edge_slots := half_edge_slots t + half_edge_slots t;
  boundary_slots := boundary_slots t;
  face_slots := face_slots t;
  is_vertex := is_vertex t;
  is_half_edge := old_or (is_half_edge t) lacks_twin;
  is_boundary := is_boundary t;
  is_face := is_face t;
  says_origin := old_or (says_origin t) end_at;
  says_twin := old_or (fun h => if twin t h is Some g then Some g else Some (beside h)) Some;
  says_next := old_or (says_next t) (fun h => omap beside (border_into (origin t h)));
  says_prev := old_or (says_prev t) (fun h => omap beside (border_from (end_at h)));
  says_boundary := says_boundary t;
  says_leaving := says_leaving t;
  says_isolated := says_isolated t;
  says_boundary_face := says_boundary_face t;
  says_boundary_start := says_boundary_start t;
  says_boundary_place := says_boundary_place t;
  says_outer := says_outer t;
  says_inner_count := says_inner_count t;
  says_inner := says_inner t
|}.

Notation w := whole.

Lemma lacks_twinP h : reflect (half_edge t h /\ twin t h = None) (lacks_twin h).
Proof. by apply: (iffP andP) => -[lh]; case: (twin t h) => [g|]. Qed.

Lemma old_half_edge h : h < half_edge_slots t -> half_edge w h = half_edge t h.
Proof. by move=> lt; rewrite /half_edge /= /old_or lt (leq_trans lt (leq_addr _ _)). Qed.

Lemma live_old h : half_edge t h -> half_edge w h.
Proof. by move=> lh; rewrite old_half_edge // half_edge_below. Qed.

Lemma beside_new h : (beside h < half_edge_slots t) = false.
Proof. by rewrite /beside ltnNge leq_addr. Qed.

Lemma live_new h : half_edge w (beside h) = lacks_twin h.
Proof.
rewrite /half_edge /= /old_or beside_new /beside ltn_add2l addKn andb_idl //.
by case/lacks_twinP=> /half_edge_below.
Qed.

Lemma wholeP i : half_edge w i -> half_edge t i \/ exists2 h, lacks_twin h & i = beside h.
Proof.
move=> li; case: (ltnP i (half_edge_slots t)) => lt; first by left; rewrite -old_half_edge.
by right; exists (i - half_edge_slots t); rewrite /beside ?subnKC // -live_new /beside subnKC.
Qed.

Lemma beside_inj : injective beside.
Proof. by move=> g h; apply: addnI. Qed.

Lemma old_differs g h : half_edge t g -> g <> beside h.
Proof. by move=> /half_edge_below lt E; rewrite E beside_new in lt. Qed.

(** The answers of the whole about half-edges that were there, and about new ones. *)

Lemma heard_old T (old new : nat -> option T) h : half_edge t h -> heard (half_edge w) (old_or old new) h = old h.
Proof. by move=> lh; rewrite /heard live_old // /old_or half_edge_below. Qed.

Lemma heard_new T (old new : nat -> option T) h : lacks_twin h -> heard (half_edge w) (old_or old new) (beside h) = new h.
Proof. by move=> lh; rewrite /heard live_new lh /old_or beside_new /beside addKn. Qed.

Lemma origin_old h : half_edge t h -> origin w h = origin t h.
Proof. by move=> lh; rewrite /origin heard_old // /heard lh. Qed.
Lemma next_old h : half_edge t h -> next w h = next t h.
Proof. by move=> lh; rewrite /next heard_old // /heard lh. Qed.
Lemma prev_old h : half_edge t h -> prev w h = prev t h.
Proof. by move=> lh; rewrite /prev heard_old // /heard lh. Qed.
Lemma twin_old h : half_edge t h -> twin w h = if twin t h is Some g then Some g else Some (beside h).
Proof. by move=> lh; rewrite [LHS]heard_old. Qed.

Lemma origin_new h : lacks_twin h -> origin w (beside h) = end_at h.
Proof. by move=> lh; rewrite [LHS]heard_new. Qed.
Lemma twin_new h : lacks_twin h -> twin w (beside h) = Some h.
Proof. by move=> lh; rewrite [LHS]heard_new. Qed.
Lemma next_new h : lacks_twin h -> next w (beside h) = omap beside (border_into (origin t h)).
Proof. by move=> lh; rewrite [LHS]heard_new. Qed.
Lemma prev_new h : lacks_twin h -> prev w (beside h) = omap beside (border_from (end_at h)).
Proof. by move=> lh; rewrite [LHS]heard_new. Qed.

(** ** The rules where half-edges may lack a twin, and each has `prev` *)

Definition open_rules :=
  [/\ (forall h, half_edge t h -> [/\ leads_to (vertex t) (origin t h), leads_to (half_edge t) (twin t h) \/ twin t h = None,
         leads_to (half_edge t) (next t h) & leads_to (half_edge t) (prev t h)]) /\
      (forall v, vertex t v -> leads_to (half_edge t) (leaving t v) \/ leaving t v = None /\ bare t v),
      [/\ forall h, half_edge t h -> twin t h <> None -> twin t h >>= twin t = Some h /\ twin t h <> Some h, l2_next_prev t
        & forall h, half_edge t h -> twin t h <> None -> next t h >>= origin t = twin t h >>= origin t],
      v1_leaving t
    & forall g h, half_edge t g -> half_edge t h ->
        (on_orbit (turn t) g h \/ on_orbit (fun h => prev t h >>= twin t) g h <-> origin t g = origin t h)].

Lemma iter_nil (f : nat -> link) k : iter k (obind f) None = None.
Proof. by elim: k => //= k ->. Qed.

Lemma orbit_reversed (f b : nat -> link) : (forall i j, f i = Some j -> b j = Some i) -> forall i j, on_orbit f i j -> on_orbit b j i.
Proof.
move=> undo i j [n]; elim: n j => [|n IH] j; first by case=> ->; exists 0.
rewrite iterS; case E: (iter n _ _) => [k|] // kj; have [m M] := IH k E.
by exists m.+1; rewrite iterSr /= (undo k j kj).
Qed.

(** A walk along a function that can be undone ends where nothing came before its start. *)
Lemma walk_ends n (f b : nat -> link) x : (forall i j, f i = Some j -> b j = Some i) -> b x = None ->
  (forall k i, iter k (obind f) (Some x) = Some i -> i < n) ->
  exists k i, iter k (obind f) (Some x) = Some i /\ f i = None.
Proof.
move=> undo start below.
have back k i : iter k (obind f) (Some x) = Some i -> iter k (obind b) (Some i) = Some x.
  elim: k i => [|k IH] i; first by case=> ->.
  rewrite iterS; case E: (iter k _ _) => [j|] // ji; by rewrite iterSr /= (undo j i ji); apply: IH.
suff: exists k, iter k.+1 (obind f) (Some x) = None.
  case=> k; elim: k => [|k IH]; first by move=> E; exists 0, x.
  rewrite iterS; case E: (iter k.+1 _ _) => [i|]; [by move=> N; exists k.+1, i | by move=> _; apply: IH].
case E: (iter n.+1 (obind f) (Some x)) => [i|]; last by exists n.
have some k : k <= n.+1 -> exists2 j, iter k (obind f) (Some x) = Some j & j < n.
  move=> le; case I: (iter k (obind f) (Some x)) => [j|]; first by exists j => //; apply: below I.
  by move: E; rewrite -(subnK le) iterD I iter_nil.
pose s := [seq odflt 0 (iter k (obind f) (Some x)) | k <- iota 0 n.+1].
have sub : {subset s <= iota 0 n}.
  move=> j /mapP[k]; rewrite mem_iota => /andP[_ lt] ->.
  by have [i' -> lt'] := some k (ltnW lt); rewrite mem_iota.
have distinct k m i' : k < m -> iter k (obind f) (Some x) = Some i' -> iter m (obind f) (Some x) = Some i' -> False.
  move=> lt I J; have := back m i' J; rewrite -(subnK (ltnW lt)) iterD (back k i' I) -(subnSK lt) iterSr /= start.
  by rewrite iter_nil.
have u : uniq s.
  rewrite map_inj_in_uniq ?iota_uniq // => k m; rewrite !mem_iota !add0n => /andP[_ lk] /andP[_ lm].
  have [i' I _] := some k (ltnW lk); have [j J _] := some m (ltnW lm); rewrite I J /= => e; rewrite -{j}e in J.
  case: (ltngtP k m) => // lt; [case: (distinct k m i' lt I J) | case: (distinct m k i' lt J I)].
by have := uniq_leq_size u sub; rewrite size_map !size_iota ltnn.
Qed.

Section Kept.
Hypothesis keeps : open_rules.

Lemma lives h : half_edge t h -> [/\ leads_to (vertex t) (origin t h), leads_to (half_edge t) (twin t h) \/ twin t h = None,
  leads_to (half_edge t) (next t h) & leads_to (half_edge t) (prev t h)].
Proof. by case: keeps => -[H _] _ _ _ /H. Qed.

Lemma next_prev g h : next t g = Some h -> prev t h = Some g.
Proof. by move=> N; have [_ [_ L2 _] _ _] := keeps; have [] := L2 g (heard_live N); rewrite N. Qed.
Lemma prev_next g h : prev t h = Some g -> next t g = Some h.
Proof. by move=> P; have [_ [_ L2 _] _ _] := keeps; have [_] := L2 h (heard_live P); rewrite P. Qed.
Lemma twin_back g h : twin t g = Some h -> twin t h = Some g.
Proof.
by move=> T; have [_ [L1 _ _] _ _] := keeps; have [] := L1 g (heard_live T); rewrite T.
Qed.

Definition turn_other h : link := prev t h >>= twin t.

Lemma turn_undone g h : turn t g = Some h <-> turn_other h = Some g.
Proof.
rewrite /turn /turn_other; split.
  by case T: (twin t g) => [k|] //= /next_prev ->; apply: twin_back.
by case P: (prev t h) => [k|] //= /twin_back ->; apply: prev_next.
Qed.

Lemma orbit_undone g h : on_orbit turn_other g h <-> on_orbit (turn t) h g.
Proof. by split; apply: orbit_reversed => i j /turn_undone. Qed.

Lemma turn_lacks h : lacks_twin h -> turn t h = None.
Proof. by case/lacks_twinP=> _; rewrite /turn => ->. Qed.

Lemma lacks_end g : lacks_twin g -> exists k v, [/\ next t g = Some k, half_edge t k, origin t k = Some v, end_at g = Some v & turn_other k = None].
Proof.
case/lacks_twinP=> lg T; have [_ _ [k N lk] _] := lives lg; have [[v O _] _ _ _] := lives lk; exists k, v.
by rewrite /end_at N /= O /turn_other (next_prev N) /=.
Qed.

(** Around a vertex one half-edge at most lacks its twin, and one at most comes after a half-edge without twin. *)
Lemma one_from g h : lacks_twin g -> lacks_twin h -> origin t g = origin t h -> g = h.
Proof.
move=> bg bh E; have [lg _] := andP bg; have [lh _] := andP bh; have [_ _ _ V2] := keeps.
have stays a b : lacks_twin a -> on_orbit (turn t) a b -> a = b.
  by move=> ba [[|n]]; [case|rewrite iterSr /= turn_lacks // iter_nil].
case: ((V2 g h lg lh).2 E) => [/(stays _ _ bg)//|/orbit_undone/(stays _ _ bh)//].
Qed.

Lemma one_into g h : lacks_twin g -> lacks_twin h -> end_at g = end_at h -> g = h.
Proof.
move=> bg bh; have [k [v [Nk lk Ok -> Bk]]] := lacks_end bg; have [m [u [Nm lm Om -> Bm]]] := lacks_end bh => -[uv].
have [_ _ _ V2] := keeps; rewrite -{u}uv in Om.
have stays a b : turn_other a = None -> on_orbit turn_other a b -> a = b.
  by move=> ba [[|n]]; [case|rewrite iterSr /= ba iter_nil].
suff km : k = m by have := next_prev Nk; rewrite km (next_prev Nm) => -[].
case: ((V2 k m lk lm).2 (etrans Ok (esym Om))) => [/orbit_undone|] o; last exact: stays Bk o.
by apply/esym/(stays m k Bm).
Qed.

Lemma same_around n g h : half_edge t g -> iter n (obind turn_other) (Some g) = Some h -> half_edge t h /\ origin t h = origin t g.
Proof.
move=> lg E; have [_ _ _ V2] := keeps.
have lh : half_edge t h.
  case: n E => [|n]; first by case=> <-.
  rewrite iterS; case: (iter n _ _) => [k|] //; rewrite -[obind _ _]/(turn_other k) => /turn_undone.
  by rewrite /turn; case T: (twin t h) => //; rewrite (heard_live T).
by split=> //; apply/esym/(V2 g h lg lh); right; exists n.
Qed.

Lemma same_around_turn n g h : half_edge t g -> iter n (obind (turn t)) (Some g) = Some h -> half_edge t h /\ origin t h = origin t g.
Proof.
move=> lg E; have [_ _ _ V2] := keeps.
have lh : half_edge t h.
  case: n E => [|n]; first by case=> <-.
  rewrite iterS; case: (iter n _ _) => [k|] //; rewrite -[obind _ _]/(turn t k) => /turn_undone.
  by rewrite /turn_other; case P: (prev t h) => //; rewrite (heard_live P).
by split=> //; apply/esym/(V2 g h lg lh); left; exists n.
Qed.

Lemma border_into_at g v : lacks_twin g -> end_at g = Some v -> border_into (Some v) = Some g.
Proof.
move=> bg E; have [lg _] := andP bg; rewrite /border_into; case F: (ohead _) => [k|].
  by have [/andP[bk /same_linkP Ek] _] := first_some F; congr Some; apply: one_into => //; rewrite E.
by have := first_none F (half_edge_below lg); rewrite bg E /= eqxx.
Qed.

Lemma border_from_at g v : lacks_twin g -> origin t g = Some v -> border_from (Some v) = Some g.
Proof.
move=> bg E; have [lg _] := andP bg; rewrite /border_from; case F: (ohead _) => [k|].
  by have [/andP[bk /same_linkP Ek] _] := first_some F; congr Some; apply: one_from => //; rewrite E.
by have := first_none F (half_edge_below lg); rewrite bg E /= eqxx.
Qed.

(** A half-edge without twin begins where another one ends, and ends where another one begins. *)
Lemma some_into h : lacks_twin h -> exists g v, [/\ lacks_twin g, origin t h = Some v & end_at g = Some v].
Proof.
move=> bh; have [lh _] := andP bh; have [[v O _] _ _ _] := lives lh.
have [||n [k [E N]]] := @walk_ends (half_edge_slots t) turn_other (turn t) h _ (turn_lacks bh).
- by move=> i j /turn_undone.
- by move=> n i /(same_around lh)[/half_edge_below].
have [lk Ok] := same_around lh E; have [_ _ _ [g P lg]] := lives lk; exists g, v.
rewrite /end_at (prev_next P) /= Ok O; split=> //; apply/lacks_twinP; split=> //.
by move: N; rewrite /turn_other P.
Qed.

Lemma some_from g : lacks_twin g -> exists h v, [/\ lacks_twin h, end_at g = Some v & origin t h = Some v].
Proof.
move=> bg; have [k [v [N lk O E B]]] := lacks_end bg.
have [||n [h [I T]]] := @walk_ends (half_edge_slots t) (turn t) turn_other k _ B.
- by move=> i j /turn_undone.
- by move=> n i /(same_around_turn lk)[/half_edge_below].
have [lh Oh] := same_around_turn lk I; exists h, v; rewrite Oh O; split=> //; apply/lacks_twinP; split=> //.
by move: T; rewrite /turn; case T: (twin t h) => [m|] //=; have [_ _ [j J _] _] := lives (heard_live (twin_back T)); rewrite J.
Qed.

(** Each new half-edge is followed by a new one, beside a half-edge that ends where the first begins. *)
Lemma next_beside h : lacks_twin h -> exists2 g, lacks_twin g & next w (beside h) = Some (beside g) /\ end_at g = origin t h.
Proof.
by move=> bh; have [g [v [bg O E]]] := some_into bh; exists g => //; rewrite next_new // O (border_into_at bg E) E.
Qed.

Lemma prev_beside g : lacks_twin g -> exists2 h, lacks_twin h & prev w (beside g) = Some (beside h) /\ origin t h = end_at g.
Proof.
by move=> bg; have [h [v [bh E O]]] := some_from bg; exists h => //; rewrite prev_new // E (border_from_at bh O) O.
Qed.

(** ** The whole is a rotation system *)

Lemma whole_links : surface_links_live w.
Proof.
have [[_ Hv] _ V1 _] := keeps; split=> [i /wholeP[li|[h bh ->]]|v lv].
- have [O [[g T lg]|T] [n N ln] [p P lp]] := lives li; rewrite origin_old // twin_old // next_old // prev_old // N P T.
    by split=> //; [exists g|exists n|exists p] => //; apply: live_old.
  split=> //; [exists (beside i)|exists n|exists p] => //; try exact: live_old.
  by rewrite live_new; apply/lacks_twinP.
- have [lh _] := andP bh; have [g bg [N _]] := next_beside bh; have [p bp [P _]] := prev_beside bh.
  have [k [v [_ lk O E _]]] := lacks_end bh.
  rewrite origin_new // twin_new // N P E; split;
    [|by exists h; rewrite ?live_old|by exists (beside g); rewrite ?live_new|by exists (beside p); rewrite ?live_new].
  by exists v => //; have [[u U lu] _ _ _] := lives lk; move: U; rewrite O => -[->].
case: (Hv v lv) => [[h L lh]|[L no]]; [left; exists h => //; exact: live_old|right; split=> //].
move=> i /wholeP[li|[h bh ->]]; first by rewrite origin_old //; apply: no.
by rewrite origin_new //; have [k [u [_ lk O -> _]]] := lacks_end bh; rewrite -O; apply: no.
Qed.

Lemma whole_l1 : l1_twin w.
Proof.
have [_ [L1 _ _] _ _] := keeps; move=> i /wholeP[li|[h bh ->]]; last first.
  have [lh T] := lacks_twinP _ bh; rewrite twin_new //= twin_old // T; split=> // -[E]; exact: old_differs lh E.
rewrite twin_old //; case T: (twin t i) => [g|] /=.
  have [B n] : twin t i >>= twin t = Some i /\ twin t i <> Some i by apply: L1; rewrite // T.
  rewrite T /= in B n; split=> //.
  by rewrite twin_old ?B // (heard_live B).
by rewrite twin_new; [split=> // -[/esym E]; apply: old_differs li E | apply/lacks_twinP].
Qed.

Lemma whole_l2 : l2_next_prev w.
Proof.
move=> i /wholeP[li|[h bh ->]].
  have [_ _ [n N ln] [p P lp]] := lives li; rewrite next_old // prev_old // N P /= prev_old // next_old //.
  by rewrite (next_prev N) (prev_next P).
have [g bg [N E]] := next_beside bh; have [p bp [P O]] := prev_beside bh; rewrite N P /=; split.
  by have [q bq [-> Oq]] := prev_beside bg; rewrite (one_from bq bh) // Oq.
by have [q bq [-> Eq]] := next_beside bp; rewrite (one_into bq bh) // Eq.
Qed.

Lemma whole_l3 : l3_target w.
Proof.
have [_ [_ _ L3] _ _] := keeps; move=> i /wholeP[li|[h bh ->]].
  have [_ _ [n N ln] _] := lives li; rewrite next_old // twin_old // N /= origin_old //.
  case T: (twin t i) => [g|] /=; last by rewrite origin_new; [rewrite /end_at N|apply/lacks_twinP].
  by rewrite origin_old ?(heard_live (twin_back T)) //; have := L3 i li; rewrite N T /= => ->.
have [lh _] := andP bh; have [g bg [-> E]] := next_beside bh.
by rewrite twin_new //= origin_new // origin_old.
Qed.

Lemma whole_map : is_map (one_boundary w).
Proof.
have [H _] := whole_links; split; [|exact: whole_l1|exact: whole_l2|exact: whole_l3].
by move=> h lh; have [O T N P] := H h lh; split=> //; exists 0; rewrite // /boundary_of /heard lh.
Qed.

Lemma turn_whole g h : turn t g = Some h -> turn w g = Some h.
Proof.
rewrite /turn; case T: (twin t g) => [k|] //= N; rewrite twin_old ?(heard_live T) // T /= next_old //; exact: heard_live N.
Qed.

Lemma orbit_whole g h : on_orbit (turn t) g h -> on_orbit (turn w) g h.
Proof.
case=> n; elim: n h => [|n IH] h; first by case=> ->; exists 0.
rewrite iterS; case E: (iter n _ _) => [k|] // kh; have [m M] := IH k E.
by exists m.+1; rewrite iterS M; apply: turn_whole.
Qed.

Lemma whole_v2 : v2_rotation w.
Proof.
have map := whole_map; have [_ _ _ V2] := keeps.
have near_old i : half_edge w i -> exists2 h, half_edge t h & on_orbit (turn w) i h /\ origin w i = origin t h.
  case/wholeP=> [li|[g bg ->]]; first by exists i => //; split; [exists 0 | rewrite origin_old].
  have [k [v [N lk O E _]]] := lacks_end bg; exists k => //; rewrite origin_new // E O; split=> //.
  by exists 1; rewrite /= /turn twin_new //= next_old ?N //; case/andP: bg.
move=> i j li lj; split=> [|E].
  case: (dartP (t := one_boundary w) li) => x <-; case: (dartP (t := one_boundary w) lj) => y <- /(on_rotationE map) o.
  have -> : origin w (num x) = Some (org x) := originE map x; have -> : origin w (num y) = Some (org y) := originE map y.
  move/iter_findex: o => <-; elim: (findex _ _ _) => //= m ->; by rewrite (org_tn map).
have [g lg [ig Og]] := near_old i li; have [h lh [jh Oh]] := near_old j lj.
have back a b : half_edge w a -> half_edge w b -> on_orbit (turn w) a b -> on_orbit (turn w) b a by exact: (turn_sym map).
apply: orbit_trans ig _; apply: orbit_trans (back _ _ lj (live_old lh) jh).
case: ((V2 g h lg lh).2 _) => [||/orbit_undone]; first by rewrite -Og -Oh.
  exact: orbit_whole.
by move/orbit_whole; apply: back; apply: live_old.
Qed.

Theorem whole_rotations : surface_rules w.
Proof.
split; [exact: whole_links|by split; [exact: whole_l1|exact: whole_l2|exact: whole_l3]| |exact: whole_v2].
have [_ _ V1 _] := keeps; move=> v h lv L; have O := V1 v h lv L; by rewrite origin_old // (heard_live O).
Qed.

End Kept.
End Border.
