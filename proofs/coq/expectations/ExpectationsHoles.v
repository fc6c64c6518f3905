(** * ExpectationsHoles: what the rules mean in the plane where lists of inner boundary components are stored, and boundaries may be open

    A map that can be drawn, from which some cycles may be missing (ExpectationsOpen.v), and whose faces are nested
    (ExpectationsNested.v); with records, each boundary component is a cycle or an isolated vertex, and listed once. *)

From mathcomp Require Import all_ssreflect all_fingroup.
From twinedge Require Import View Rules Loops LoopsProof Reference ReferenceProof Map Counting Lists Subdivision Genus Bounds RotationSystem.
From twinedge Require Import Expectations ExpectationsCheck ExpectationsLists ExpectationsVerdict ExpectationsPlane ExpectationsFaceless.
From twinedge Require Import ExpectationsParts ExpectationsFaces ExpectationsBorder ExpectationsMissing ExpectationsOpenCounts ExpectationsOpen.
From twinedge Require Import ExpectationsNested.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** ** Faces that half-edges name *)

Section Named.
Variables (t : view) (places unbounded : bool) (sf so : nat -> link) (si : nat -> nat -> option start).
Let e := open_on true.
Let s := Structure t (Parts true true true false places true unbounded) sf so si.
Notation w := (whole t).
Notation entry := (entry_start e s).
Notation is_nested := (nested t unbounded (face_of e s) entry).

Lemma face_says h : half_edge t h -> face_of e s h = sf h.
Proof. by move=> lh; rewrite /face_of /side /heard /= -[half_edge _ h]/(half_edge t h) lh. Qed.

Lemma nested_side_says h : half_edge t h -> side e s h = sf h.
Proof. exact: face_says. Qed.

Lemma place_entry f p st : entry f p = Some st -> is_place t f p.
Proof. by move/start_entry; rewrite mem_entries. Qed.

Lemma outer_entry f : face t f -> has_outer e s f = isSome (entry f Outer).
Proof. by move=> lf; rewrite /has_outer /entry_start /=; case: (heard _ _ f). Qed.

(** The vertices of a component without half-edges. *)
Lemma bare_piece v x : bare t v -> same_piece t v x -> x = v.
Proof.
move=> bv; elim=> // y z _ -> [h O _]; by case: (bv h (heard_live O)).
Qed.

Lemma nested_named_before : before_t4 e s -> [/\ open_rules t, is_nested & t3_euler (flat w)].
Proof.
move=> H.
have keeps := links_open (before_b1 H); split=> //; last by apply/(@open_t3_plane t true places true unbounded sf so si true false keeps isT)/(H T3 isT).
have [Hh _ _ Hf _] := H R1 isT; have [C E] := H B1 isT; have [F1' F1v] := H F1 isT isT.
have along g h : half_edge t g -> on_cycle t g h -> half_edge t h /\ sf h = sf g.
  move=> lg [m]; elim: m h => [|m IH] h; first by case=> <-.
  rewrite iterS; case I: (iter m _ _) => [k|] // kh; have {}kh : next t k = Some h := kh; have [lk sk] := IH k I.
  have lh : half_edge t h by have [_ _ [j M lm] _] := lives keeps lk; move: kh; rewrite M => -[<-].
  by have := C isT k lk; rewrite -[next _ k]/(next t k) kh /= !nested_side_says // sk.
have starts f p st : entry f p = Some st -> starts_live (seen e s) (Some st).
  move=> En; have := place_entry En; case: p En => [|i] En /andP[lf lt]; have [O I] := Hf f lf.
    by rewrite -En; apply: O; rewrite outer_entry // En.
  by rewrite -En; apply: I.
have half f p h : entry f p = Some (AtHalfEdge h) -> half_edge t h /\ sf h = Some f.
  by move=> En; have lh : half_edge t h := starts f p _ En; split=> //; rewrite -nested_side_says //; apply: E En.
split.
- move=> h lh; rewrite face_says //; have [_ _ _ _ /(_ isT)[]] := Hh h lh; rewrite nested_side_says //; first by left.
  by case; right.
- by move=> g h lg lh /(along g h lg)[_]; rewrite !face_says.
- move=> f p; case P: (is_place t f p); last by case En: (entry f p) => [st|] //; rewrite (place_entry En) in P.
  rewrite /entry_fits; case En: (entry f p) => [[h|v]|].
  + by have [lh S] := half f p h En; rewrite face_says.
  + have lv : vertex t v := starts f p _ En; split=> // [|pO]; last by apply: (F1v f v); rewrite -pO.
    case: (bareP e s v) => // no; have [_ none] := H B2 isT isT v lv; by case: (none no (f, p)).
  case: p P En => // i /andP[lf lt] En; have [_ I] := Hf f lf; by have := I i lt; rewrite /= -[entry_start _ _ _ _]/(entry f (Inner i)) En.
- move=> h f lh; rewrite face_says // => Ef; case: (H F2 isT isT h lh) => [[[f' p] [[g /= En c] one]]|[]]; last by rewrite nested_side_says // Ef.
  have [lg Sg] := half f' p g En; have [_ Sc] := along h g lh c; have ff : f' = f by move: Sg; rewrite Sc Ef => -[->].
  exists p; rewrite -ff; split=> [|q [k Ek ck]]; first by exists g.
  by have /one[] : lists_cycle e s h (f', q) by exists k.
- have same f : is_unbounded e s f <-> face t f /\ entry f Outer = None.
    rewrite /is_unbounded; split=> -[lf E0]; split=> //; move: E0; rewrite (outer_entry (lf : face t f)).
      by case: (entry f Outer).
    by move=> ->.
  move: F1'; rewrite (_ : has_unbounded e s = unbounded) //; case: unbounded => [[f [/same U one]]|none].
    by exists f; split=> // g /same/one.
  by move=> f lf N; apply: (none f); apply/same.
- by apply: (nested_t1 keeps _).1 (H T1 isT) => h lh; rewrite nested_side_says ?face_says.
apply: (nested_t2 keeps _).1 (H T2 isT) => f u; case En: (entry f Outer) => [[g|v]|] //= O; last by case: (F1v f v).
have [lg _] := half f Outer g En; by have [[x X lx] _ _ _] := lives keeps lg; move: O; rewrite X => -[<-].
Qed.

Theorem nested_named_rules : rules_of e s <-> [/\ open_rules t, is_nested & t3_euler (flat w)].
Proof.
split=> [/rules_before_t4/nested_named_before|[keeps n T]] //.
have [[Hh Hv] [_ L2 _] V1 _] := keeps.
have half f p h : entry f p = Some (AtHalfEdge h) -> [/\ face t f, half_edge t h & sf h = Some f].
  by move=> En; have [lf lh S] := entry_half_edge n En; rewrite face_says // in S.
have along g h : half_edge t g -> half_edge t h -> on_cycle t g h -> sf h = sf g.
  by move=> lg lh c; have := nested_along n lg lh c; rewrite !face_says.
have unb : has_unbounded e s = unbounded by [].
have alone v f p : vertex t v -> entry f p = Some (AtVertex v) -> lists_inside t entry v (f, p).
  by move=> lv En; have [_ _ _ no] := entry_vertex n En; split=> //; exists v; rewrite /= ?En //; apply: walks_nowhere.
have once v f p g q : entry f p = Some (AtVertex v) -> entry g q = Some (AtVertex v) -> (f, p) = (g, q).
  move=> En Em; have [_ lv _ _] := entry_vertex n En; case: (nested_inside n lv) => [[x [_ one]]|[_ none]].
    by rewrite -(one _ (alone v f p lv En)) -(one _ (alone v g q lv Em)).
  by case: (none _ (alone v f p lv En)).
case=> [[]|[] //] //.
- split=> // [h lh|v lv|f lf|].
  + have [O T' N P] := open_half_edge true places true unbounded sf so si true false keeps lh; split=> // _.
    by have := nested_sides n lh; rewrite face_says // nested_side_says //; case=> [|[]]; [left|right].
  + by split; [move=> _; apply: Hv | left; rewrite /isolated /heard; case: ifP].
  + split=> [|i lt].
      rewrite outer_entry // => O; rewrite /= -[entry_start _ _ _ _]/(entry f Outer); case En: (entry f Outer) O => [[h|v]|] // _.
        by have [] := half f Outer h En.
      by have [_ _ _] := entry_vertex n En.
    have := nested_entries n f (Inner i); rewrite /is_place (lf : face t f) (lt : i < inner_count t f) /entry_fits /=.
    by rewrite -[entry_start _ _ _ _]/(entry f (Inner i)); case: (entry f (Inner i)) => [[h|v]|] // [].
  + apply: leq_trans (leq_addr _ _); apply: leq_trans (leq_pmull _ _) => //.
    pose A : seq (nat + nat) := [seq inl h | h <- iota 0 (half_edge_slots t) & half_edge t h] ++ [seq inr v | v <- iota 0 (vertex_slots t) & vertex t v].
    pose c f i : nat + nat := match entry f (Inner i) with Some (AtHalfEdge h) => inl h | Some (AtVertex v) => inr v | None => inl 0 end.
    have here f i : i < inner_count (seen e s) f -> is_place t f (Inner i).
      move=> lt; rewrite /is_place (lt : i < inner_count t f) andbT; by move: lt; rewrite /inner_count -[face _ f]/(face t f); case: (face t f).
    apply: leq_trans (lists_within (A := A) (c := c) _ _) _ => [f i lt|f i g j lf lg|].
    * have := nested_entries n f (Inner i); rewrite here // /entry_fits /c /A mem_cat.
      case: (entry f (Inner i)) => [[h [L _]|v [L _ _]]|//]; apply/orP; [left|right]; apply: map_f; rewrite mem_filter mem_iota L /=.
        exact: half_edge_below L.
      exact: vertex_below L.
    * have := nested_entries n f (Inner i); have := nested_entries n g (Inner j); rewrite !here // /entry_fits /c.
      case Ef: (entry f (Inner i)) => [[h|v]|] //; case Eg: (entry g (Inner j)) => [[k|u]|] // _ _ [E].
        have [_ lh Sh] := half f (Inner i) h Ef; have [_ _ Sk] := half g (Inner j) k Eg.
        have fg : f = g by move: Sk; rewrite -E Sh => -[].
        have [|p [_ one]] := nested_once n lh (f := f); first by rewrite face_says.
        split=> //; suff: Inner i = Inner j by case.
        rewrite -(one (Inner i)); last by exists h => //; exists 0.
        by apply: one; exists k; rewrite ?fg // -E; exists 0.
      by have := once v f (Inner i) g (Inner j) Ef; rewrite {1}E Eg => /(_ erefl)[].
    by rewrite size_cat !size_map !size_filter.
- exact: open_l1.
- exact: open_l3.
- exact: open_v2.
- split=> [_ h lh|f p h /half[_ lh]]; last by rewrite nested_side_says.
  have [_ _ [m N ln] _] := lives keeps lh; rewrite -[next _ h]/(next t h) N /= !nested_side_says //.
  by apply: along => //; exists 1; rewrite /= N.
- move=> _ v lv; split=> [bv|nb x En]; last by have [_ _ bv _] := entry_vertex n En; apply: nb.
  have {}bv : bare t v := bv.
  have same x : lists_inside t entry v x <-> lists_vertex e s v x.
    split=> [[_ [y Y L]]|En]; last by case: x En => f p; exact: alone.
    have yv := bare_piece bv L; move: Y; rewrite yv /start_vertex /lists_vertex.
    case: (entry_start e s x.1 x.2) => [[h O|u [->]]|] //; by case: (bv h (heard_live O)).
  case: (nested_inside n lv) => [[x [/same X one]]|[legal none]].
    by left; exists x; split=> // y /same/one.
  right; split=> [|x /same]; last exact: none.
  rewrite unb; case: legal => // -[h [x [O L _]]]; by case: (bv h (heard_live O)); rewrite O (bare_piece bv L).
- move=> _; rewrite unb; split; last by move=> f v /(entry_vertex n)[].
  have same f : is_unbounded e s f <-> face t f /\ entry f Outer = None.
    rewrite /is_unbounded; split=> -[lf E0]; split=> //; move: E0; rewrite (outer_entry (lf : face t f)).
      by case: (entry f Outer).
    by move=> ->.
  have := nested_outer n; case: unbounded => [[f [U one]]|all].
    by exists f; split=> [|g /same/one //]; apply/same.
  by move=> f /same[lf]; apply: all.
- move=> _ h lh; case Ef: (sf h) => [f|].
    left; have [|p [[g En c] one]] := nested_once n lh (f := f); first by rewrite face_says.
    exists (f, p); split=> [|[f' q] [k Ek ck]]; first by exists g.
    have [_ lk Sk] := half f' q k Ek; have ff : f' = f by move: Sk; rewrite (along h k lh lk ck) Ef => -[->].
    by rewrite ff (one q) //; exists k; rewrite // -ff.
  right; split; first by rewrite nested_side_says.
  by move=> [f p] [g En c]; have [_ lg Sg] := half f p g En; move: Sg; rewrite (along h g lh lg c) Ef.
- by apply/(nested_t1 keeps (face_side := face_of e s)) => [h lh|]; [rewrite nested_side_says ?face_says | exact: nested_inside n].
- apply: (nested_t2 keeps _).2 (nested_depth n) => f u; case En: (entry f Outer) => [[g|v]|] //= O; last by have [_ _ _] := entry_vertex n En.
  have [_ lg _] := half f Outer g En; by have [[x X lx] _ _ _] := lives keeps lg; move: O; rewrite X => -[<-].
- exact: (open_all_t3 keeps (fun _ => T)).
apply: (open_t4_if keeps T) => fs Hf; exact: (face_bound keeps n Hf).
Qed.

End Named.

(** ** Faces with records for their boundary components *)

(** A boundary component is a cycle or an isolated vertex, and is listed once. *)
Record nested_records t (places : bool) : Prop := NestedRecords {
  records_sides : forall h, half_edge t h -> leads_to (boundary t) (boundary_of t h) \/ twin t h <> None /\ boundary_of t h = None;
  records_cycles : forall g h b, half_edge t g -> half_edge t h -> boundary_of t g = Some b -> (boundary_of t h = Some b <-> on_cycle t g h);
  records_start : forall b, boundary t b ->
    (exists h, [/\ boundary_start t b = Some (AtHalfEdge h), half_edge t h & boundary_of t h = Some b]) \/
    exists v, [/\ boundary_start t b = Some (AtVertex v), vertex t v & forall h, boundary_of t h <> Some b];
  records_isolated : forall v b, vertex t v -> (isolated t v = Some b <-> boundary_start t b = Some (AtVertex v));
  records_live : forall f p b, listed t f p = Some b -> boundary t b;
  records_listed : forall b, boundary t b -> exists f p, [/\ boundary_face t b = Some f, (places -> boundary_place t b = Some p)
    & forall f' p', listed t f' p' = Some b <-> f' = f /\ p' = p]
}.

Section Recorded.
Variables (t : view) (places unbounded : bool) (sf so : nat -> link) (si : nat -> nat -> option start).
Let e := open_on true.
Let s := Structure t (Parts true true true true places true unbounded) sf so si.
Notation w := (whole t).
Notation entry := (entry_start e s).
Notation is_nested := (nested t unbounded (face_of e s) entry).

Lemma record_entry f p : entry f p = listed t f p >>= boundary_start t. Proof. by []. Qed.

Lemma record_face h : face_of e s h = boundary_of t h >>= boundary_face t. Proof. by []. Qed.

Lemma record_place f p b : listed t f p = Some b -> is_place t f p.
Proof.
case: p => [|i] L; first by rewrite /is_place (heard_live (L : outer t f = Some b)).
have lt := inner_lt (L : inner t f i = Some b); rewrite /is_place lt andbT.
by move: lt; rewrite /inner_count; case: (face t f).
Qed.

Lemma nested_recorded_before : before_t4 e s -> [/\ open_rules t, is_nested, nested_records t places & t3_euler (flat w)].
Proof.
move=> H.
have keeps := links_open (before_b1 H).
have T : t3_euler (flat w) by apply/(@open_t3_plane t true places true unbounded sf so si true true keeps isT)/(H T3 isT).
suff [n R] : is_nested /\ nested_records t places by split.
have [Rh _ Rb Rf _] := H R1 isT; have [C B] := H B1 isT; have [F1' F1v] := H F1 isT isT.
have sides h : half_edge t h -> leads_to (boundary t) (boundary_of t h) \/ twin t h <> None /\ boundary_of t h = None.
  by move=> lh; have [_ _ _ _ /(_ isT)[|[]]] := Rh h lh; [left|right].
have owner b : boundary t b -> leads_to (face t) (boundary_face t b) by case/Rb.
have live f p b : listed t f p = Some b -> boundary t b.
  case: p => [|i] L.
    have [+ _] := Rf f (heard_live (L : outer t f = Some b)); rewrite /has_outer /= -[outer _ f]/(listed t f Outer) L.
    by move=> /(_ isT)[c [<-]].
  have lt := inner_lt (L : inner t f i = Some b).
  have lf : face t f by move: lt; rewrite /inner_count; case: (face t f).
  by have [_ /(_ i lt)] := Rf f lf; rewrite -[inner _ f i]/(listed t f (Inner i)) L => -[c [<-]].
have starts b : boundary t b -> (exists h, [/\ boundary_start t b = Some (AtHalfEdge h), half_edge t h & boundary_of t h = Some b]) \/
    exists v, [/\ boundary_start t b = Some (AtVertex v), vertex t v & forall h, boundary_of t h <> Some b].
  move=> lb; have [_] := Rb b lb; rewrite -[boundary_start _ b]/(boundary_start t b).
  case S: (boundary_start t b) => [[h|v]|] // lx; [left; exists h; split=> //|right; exists v; split=> // h Eh].
    by apply/(B b h lb lx); exists h => //; exists 0.
  have [g S' _] := (B b h lb (heard_live Eh)).1 Eh; have {}S' : boundary_start t b = Some (AtHalfEdge g) := S'.
  by rewrite S in S'.
have cycles g h b : half_edge t g -> half_edge t h -> boundary_of t g = Some b -> (boundary_of t h = Some b <-> on_cycle t g h).
  move=> lg lh Eg; have lb : boundary t b by case: (sides g lg) => [[c]|[_]]; rewrite Eg // => -[->].
  have [k S kg] := (B b g lb lg).1 Eg; have {}S : boundary_start t b = Some (AtHalfEdge k) := S.
  have lk : half_edge t k by case: (starts b lb) => [[m [S' lm _]]|[v [S' _ _]]]; move: S'; rewrite S // => -[->].
  split=> [/(B b h lb lh)[k' S']|gh]; last by apply/(B b h lb lh); exists k => //; apply: orbit_trans kg gh.
  have {}S' : boundary_start t b = Some (AtHalfEdge k') := S'; move: S'; rewrite S => -[<-].
  apply: orbit_trans; exact: (open_cycle_sym keeps lk lg kg).
have lists_of b : boundary t b -> exists f p, [/\ boundary_face t b = Some f, (places -> boundary_place t b = Some p)
    & forall f' p', listed t f' p' = Some b <-> f' = f /\ p' = p] by exact: (H F2 isT b).
have names f p b : listed t f p = Some b -> boundary_face t b = Some f.
  by move=> L; have [f' [p' [Ef _ U]]] := lists_of b (live f p b L); have [-> _] := (U f p).1 L.
split.
- split.
  + move=> h lh; rewrite record_face; case: (sides h lh) => [[b -> lb]|[nt ->]]; [left|by right].
    exact: owner.
  + move=> g h lg lh c; rewrite !record_face; case Eg: (boundary_of t g) => [b|]; first by have -> : boundary_of t h = Some b by apply/(cycles g h b lg lh Eg).
    case Eh: (boundary_of t h) => [b|] //; have := (cycles h g b lh lg Eh).2 (open_cycle_sym keeps lg lh c); by rewrite Eg.
  + move=> f p; case P: (is_place t f p); last first.
      rewrite record_entry; case L: (listed t f p) => [b|] //; by rewrite (record_place L) in P.
    rewrite /entry_fits; case En: (entry f p) => [[h|v]|].
    * move: En; rewrite record_entry record_face; case L: (listed t f p) => [b|] //= S.
      case: (starts b (live _ _ _ L)) => [[m [S' lm Em]]|[v [S' _ _]]]; move: S'; rewrite S // => -[->]; rewrite Em; split=> //.
      exact: names L.
    * have [b [L S]] : exists b, listed t f p = Some b /\ boundary_start t b = Some (AtVertex v).
        by move: En; rewrite record_entry; case L: (listed t f p) => [b|] //= S; exists b.
      case: (starts b (live _ _ _ L)) => [[m [S' _ _]]|[u [S' lu _]]]; move: S'; rewrite S // => -[vu]; rewrite -{u}vu in lu.
      split=> // [|pO]; last by apply: (F1v f v); rewrite -pO.
      case: (bareP e s v) => // no; have [_ [none _]] := H B2 isT isT v lu; by case: (none no b).
    case: p P En => // i /andP[lf lt]; rewrite record_entry; have [_ /(_ i lt)] := Rf f lf.
    rewrite -[inner _ f i]/(listed t f (Inner i)) => -[b -> lb] /=; by case: (starts b lb) => [[m [-> _ _]]|[u [-> _ _]]].
  + move=> h f lh; rewrite record_face; case Eb: (boundary_of t h) => [b|] //= Ef.
    have lb := heard_live Ef; have [f' [p [Ef' _ U]]] := lists_of b lb; move: Ef'; rewrite Ef => -[ff]; rewrite -{f'}ff in U.
    have L : listed t f p = Some b by apply/U.
    case: (starts b lb) => [[k [S lk Ek]]|[v [_ _ /(_ h)]]] //; exists p; split.
      by exists k; [rewrite record_entry L | apply/(cycles h k b lh lk Eb)].
    move=> q [k' + ck]; rewrite record_entry; case L': (listed t f q) => [b'|] //= S'.
    case: (starts b' (live _ _ _ L')) => [[m [S2 lm Em]]|[v [S2 _ _]]]; move: S2; rewrite S' // => -[km]; rewrite -{m}km in lm Em.
    have := (cycles h k' b lh lm Eb).2 ck; rewrite Em => -[bb]; rewrite bb in L'.
    by have [_ ->] := (U f q).1 L'.
  + have same f : is_unbounded e s f <-> face t f /\ entry f Outer = None.
      have out : has_outer e s f = isSome (entry f Outer).
        rewrite /has_outer /= record_entry -[outer _ f]/(listed t f Outer); case L: (listed t f Outer) => [b|] //=.
        by case: (starts b (live _ _ _ L)) => [[m [-> _ _]]|[u [-> _ _]]].
      by rewrite /is_unbounded out; split=> -[lf E0]; split=> //; move: E0; case: (entry f Outer).
    move: F1'; rewrite (_ : has_unbounded e s = unbounded) //; case: unbounded => [[f [/same U one]]|none].
      by exists f; split=> // g /same/one.
    by move=> f lf N; apply: (none f); apply/same.
  + apply: (nested_t1 keeps _).1 (H T1 isT) => h lh; rewrite record_face -[side _ _ h]/(boundary_of t h).
    by case: (sides h lh) => [[b -> lb]|[_ ->]] //=; have [f -> _] := owner b lb.
  apply: (nested_t2 keeps _).1 (H T2 isT) => f u; case En: (entry f Outer) => [[g|v]|] //= O; last by case: (F1v f v).
  by have [[x X lx] _ _ _] := lives keeps (heard_live O : half_edge t g); move: O; rewrite X => -[<-].
split=> //; exact: (fun v b lv => (H B2 isT isT v lv).2.2 b).
Qed.

Theorem nested_recorded_rules : rules_of e s <-> [/\ open_rules t, is_nested, nested_records t places & t3_euler (flat w)].
Proof.
split=> [/rules_before_t4/nested_recorded_before|[keeps n R T]] //.
have [[Hh Hv] [_ L2 _] V1 _] := keeps.
have along g h : half_edge t g -> half_edge t h -> on_cycle t g h -> boundary_of t h = boundary_of t g.
  move=> lg lh c; case Eg: (boundary_of t g) => [b|]; first by apply/(records_cycles R lg lh Eg).
  case Eh: (boundary_of t h) => [b|] //; have /(records_cycles R lh lg Eh) := open_cycle_sym keeps lg lh c; by rewrite Eg.
have unb : has_unbounded e s = unbounded by [].
have owner b : boundary t b -> exists f p, [/\ boundary_face t b = Some f, face t f & listed t f p = Some b].
  move=> lb; have [f [p [Ef _ U]]] := records_listed R lb; have L := (U f p).2 (conj erefl erefl); exists f, p; split=> //.
  by case/andP: (record_place L).
have at_vertex v b : starts_at_vertex t v b -> exists f p, listed t f p = Some b /\ entry f p = Some (AtVertex v).
  by move=> S; have [f [p [_ _ L]]] := owner b (heard_live S); exists f, p; rewrite record_entry L.
case=> [[]|[] //] //.
- split=> // [h lh|v lv|b lb|f lf|].
  + have [O T' N P] := open_half_edge true places true unbounded sf so si true true keeps lh; split=> // _.
    by case: (records_sides R lh) => [|[]]; [left|right].
  + split; first by move=> _; apply: Hv.
    rewrite -[isolated _ v]/(isolated t v); case I: (isolated t v) => [b|]; [right|by left]; exists b => //.
    exact: heard_live ((records_isolated R b lv).1 I).
  + have [f [p [Ef lf _]]] := owner b lb; split; first by exists f.
    by rewrite -[boundary_start _ b]/(boundary_start t b); case: (records_start R lb) => [[m [-> lm _]]|[u [-> lu _]]].
  + split=> [|i lt].
      rewrite /has_outer /= -[outer _ f]/(listed t f Outer); case L: (listed t f Outer) => [b|] // _; exists b => //.
      have lb := records_live R L; exact: lb.
    have := nested_entries n f (Inner i); rewrite /is_place (lf : face t f) (lt : i < inner_count t f) /entry_fits record_entry /=.
    rewrite -[inner _ f i]/(listed t f (Inner i)) -/(listed t f (Inner i)); case L: (listed t f (Inner i)) => [b|] //= _.
    by have lb := records_live R L; exists b.
  + apply: leq_trans (leq_addr _ _); apply: leq_trans (leq_pmull _ _) => //.
    have here f i : i < inner_count (seen e s) f -> exists2 b, listed t f (Inner i) = Some b & boundary t b.
      move=> lt; have lf : face t f by move: lt; rewrite /inner_count -[face _ f]/(face t f); case: (face t f).
      have := nested_entries n f (Inner i); rewrite /is_place lf (lt : i < inner_count t f) /entry_fits record_entry.
      by case L: (listed t f (Inner i)) => [b|] //= _; by have lb := records_live R L; exists b.
    apply: leq_trans (lists_within (A := [seq b <- iota 0 (boundary_slots t) | boundary t b]) (c := fun f i => odflt 0 (listed t f (Inner i))) _ _) _.
    * by move=> f i /here[b -> lb]; rewrite /= mem_filter lb mem_iota boundary_below.
    * move=> f i g j /here[b L lb] /here[c K lc]; rewrite L K /= => bc; rewrite -bc in K.
      have [f' [p [_ _ U]]] := records_listed R lb.
      by have [-> ip] := (U _ _).1 L; have [-> jp] := (U _ _).1 K; split=> //; move: jp; rewrite -ip => -[].
    by rewrite size_filter.
- exact: open_l1.
- exact: open_l3.
- exact: open_v2.
- split=> [_ h lh|b h lb lh].
    have [_ _ [m N ln] _] := lives keeps lh; rewrite -[next _ h]/(next t h) N /=.
    by apply: along => //; exists 1; rewrite /= N.
  rewrite -[boundary_of _ h]/(boundary_of t h) -[boundary_start _ b]/(boundary_start t b).
  case: (records_start R lb) => [[g [S lg Eg]]|[v [S _ no]]]; rewrite S.
    by split=> [/(records_cycles R lg lh Eg)|[g' [<-] c]]; [exists g|apply/(records_cycles R lg lh Eg)].
  by split=> [/no|[]].
- move=> _ v lv; split; [|split] => [bv|nb b S|b].
  + have {}bv : bare t v := bv.
    have inside b f p : starts_at_vertex t v b -> listed t f p = Some b -> lists_inside t entry v (f, p).
      move=> S L; have En : entry f p = Some (AtVertex v) by rewrite record_entry L.
      have [_ _ _ no] := entry_vertex n En; split=> //; exists v; rewrite ?En //; exact: walks_nowhere.
    case: (nested_inside n lv) => [[[f p] [[no [y Y L]] one]]|[legal none]].
      have yv := bare_piece bv L; move: Y; rewrite yv /= record_entry; case K: (listed t f p) => [b|] //=.
      case S: (boundary_start t b) => [[h|u]|] //= O; first by case: (bv h (heard_live O)).
      case: O => uv; rewrite uv in S; left; exists b; split=> // c Sc; have [g [q [K' En]]] := at_vertex v c Sc.
      have [fg pq] : (f, p) = (g, q) by apply: one; exact: inside Sc K'.
      by move: K'; rewrite -fg -pq K => -[].
    right; split=> [|b S]; last by have [f [p [L _]]] := at_vertex v b S; exact: none (inside b f p S L).
    rewrite unb; case: legal => // -[h [x [O L _]]]; by case: (bv h (heard_live O)); rewrite O (bare_piece bv L).
  + have [f [p [_ En]]] := at_vertex v b S; have [_ _ bv _] := entry_vertex n En; exact: nb.
  have I := records_isolated R b lv; exact: I.
- move=> _; rewrite unb; split; last by move=> f v /(entry_vertex n)[].
  have same f : is_unbounded e s f <-> face t f /\ entry f Outer = None.
    have out : has_outer e s f = isSome (entry f Outer).
      rewrite /has_outer /= record_entry -[outer _ f]/(listed t f Outer); case L: (listed t f Outer) => [b|] //=.
      by case: (records_start R (records_live R L)) => [[m [-> _ _]]|[u [-> _ _]]].
    by rewrite /is_unbounded out; split=> -[lf E0]; split=> //; move: E0; case: (entry f Outer).
  have := nested_outer n; case: unbounded => [[f [U one]]|all].
    by exists f; split=> [|g /same/one //]; apply/same.
  by move=> f /same[lf]; apply: all.
- have L := records_listed R; exact: L.
- apply/(nested_t1 keeps (face_side := face_of e s)) => [h lh|]; last exact: nested_inside n.
  rewrite record_face -[side _ _ h]/(boundary_of t h).
  by case: (records_sides R lh) => [[b -> lb]|[_ ->]] //=; have [f [p [-> _ _]]] := owner b lb.
- apply: (nested_t2 keeps _).2 (nested_depth n) => f u; case En: (entry f Outer) => [[g|v]|] //= O; last by have [_ _ _] := entry_vertex n En.
  by have [[x X lx] _ _ _] := lives keeps (heard_live O : half_edge t g); move: O; rewrite X => -[<-].
- exact: (open_all_t3 keeps (fun _ => T)).
apply: (open_t4_if keeps T) => fs Hf; exact: (face_bound keeps n Hf).
Qed.

End Recorded.

(** ** So the rules mean nested faces *)

Definition faces_nested e s := nested (answers s) (unbounded_part (stored s)) (face_of e s) (entry_start e s).

Theorem open_holes_named t places unbounded sf so si :
  let s := Structure t (Parts true true true false places true unbounded) sf so si in
  rules_of (open_on true) s <-> is_open_map true t /\ faces_nested (open_on true) s.
Proof. by move=> s; rewrite nested_named_rules -(open_maps t true); split=> [[]|[[] + /(_ isT)]]. Qed.

Theorem open_holes_recorded t places unbounded sf so si :
  let s := Structure t (Parts true true true true places true unbounded) sf so si in
  rules_of (open_on true) s <-> [/\ is_open_map true t, faces_nested (open_on true) s & nested_records t places].
Proof.
move=> s; have M := open_maps t true; split=> [/nested_recorded_rules[k n r T]|[/M[k T] n r]].
  by split=> //; apply/M.
by apply/nested_recorded_rules; split=> //; apply: T.
Qed.

(** The same where `prev`, half-edges kept by vertices, or places are not stored. *)

Theorem filled_open_holes_named v pr le pl un sf so si :
  let s := Structure v (Parts pr le true false pl true un) sf so si in let u := filled (open_on true) s in
  rules_of (open_on true) s <-> is_open_map true (answers u) /\ faces_nested (open_on true) u.
Proof.
move=> s u; rewrite (filled_rules s (isT : ~~ border_kept (open_on true))) /u /s {u s}.
by case: pr; case: le; case: pl; apply: open_holes_named.
Qed.

Theorem filled_open_holes_recorded v pr le pl un sf so si :
  let s := Structure v (Parts pr le true true pl true un) sf so si in let u := filled (open_on true) s in
  rules_of (open_on true) s <-> [/\ is_open_map true (answers u), faces_nested (open_on true) u & nested_records (answers u) true].
Proof.
move=> s u; rewrite (filled_rules s (isT : ~~ border_kept (open_on true))) /u /s {u s}.
by case: pr; case: le; case: pl; apply: open_holes_recorded.
Qed.
