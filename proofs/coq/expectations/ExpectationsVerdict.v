(** * ExpectationsVerdict: T1 to M8 are decided rightly, too, and so is which rule is broken first *)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import Arith View Rules Loops Reference ReferenceProof Map Counting Expectations.
From twinedge Require Import ExpectationsCheck ExpectationsLists ExpectationsProof.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section Rules.
Variables (e : expectation) (s : structure).
Notation t := (seen e s).

(** ** T1 and T2 *)

Lemma is_outsideP v x : is_outside e s (linked_list e s v) x <-> outside_entry e s v x.
Proof.
rewrite /is_outside /outside_entry -is_atP; case: x.2 => [|i] /=; split=> //; first by case.
by case.
Qed.

Lemma outside_inside v x : outside_entry e s v x -> x \in entry_list e s.
Proof.
case: x => f p [_ [w + _]] /=; rewrite /vertex_of; case E: (entry_start e s f p) => [st|] // _; exact: start_entry E.
Qed.

Lemma component_lists v : lists (component_list e s (linked_list e s v)) (of_component e s v).
Proof. by apply: lists_half_edges => h; [move=> _; apply: componentP | apply: of_component_live]. Qed.

Lemma opensP v : reflect (opens e s v) (has (fun h => on_border e s h || lacks_face e s h) (component_list e s (linked_list e s v))).
Proof. by have [_ mem] := component_lists v; apply: (iffP hasP) => -[h /mem hv B]; exists h. Qed.

Lemma decide_t1P : reflect (t1 e s) (decide_t1 e s).
Proof.
apply: impP; apply: each_vertex => v _; apply: one_or_noneP (entries_uniq e s) (@outside_inside v) _ _.
- by move=> x _; apply: is_outsideP.
- exact: orPP idP (opensP v).
Qed.

Lemma containersP v w : w \in containers e s v <-> lies_in e s v w.
Proof.
rewrite /containers mem_pmap; split=> [/mapP[x]|[x o W]].
  by rewrite mem_filter => /andP[/is_outsideP o _] W; exists x.
by apply/mapP; exists x; rewrite // mem_filter (outside_inside o) andbT; apply/is_outsideP.
Qed.

Lemma container_listP v w : w \in container_list e s v <-> exists2 u, lies_in e s v u & walks (lies_in e s) u w.
Proof.
pose ends := pmap (fun x : nat * place => vertex_of e s (entry_start e s x.1 Outer)) (entry_list e s).
rewrite /container_list (@closeP _ ends) => [|x y|].
- by split=> -[u /containersP vu /(walks_iff _ _ (containersP)) uw]; exists u.
- rewrite !mem_pmap => /mapP[z]; rewrite mem_filter => /andP[_ zi] E; by apply/mapP; exists z.
by rewrite ltnS; apply: leq_trans (count_size _ _) _; rewrite size_pmap count_size.
Qed.

Lemma decide_t2P : reflect (t2 e s) (decide_t2 e s).
Proof.
have outward v : reflect (forall w, w \in container_list e s v -> ~ linked e s w v)
    (~~ has (fun w => member v (linked_list e s w)) (container_list e s v)).
  apply: (iffP hasPn) => H w /H; rewrite memberE => n; first by move/linkedP; apply/negP.
  by apply/negP=> /linkedP.
apply: impP; apply: (iffP (each_vertex (fun v _ => outward v))) => H v.
  by move=> u w lv vu uw; apply: (H v lv); apply/container_listP; exists u.
by move=> lv w /container_listP[u vu uw]; apply: (H v u w).
Qed.

(** ** Counts *)

Lemma lists_sub hs (P Q : nat -> Prop) (q : pred nat) : lists hs P -> (forall h, P h -> q h <-> Q h) ->
  lists [seq h <- hs | q h] (fun h => P h /\ Q h).
Proof.
move=> [u mem] qQ; split=> [|h]; first exact: filter_uniq.
by rewrite mem_filter; split=> [/andP[/[swap]/mem Ph /(qQ h Ph)]|[Ph /(qQ h Ph)->]] //; apply/mem.
Qed.

Lemma least_edgeP h : is_true (if twin t h is Some g then h <= g else true) <-> least (same_edge t) h.
Proof.
rewrite /least /same_edge; case: (twin t h) => [g|]; last first.
  by split=> // _ g gh [hg|//]; rewrite hg ltnn in gh.
split=> [le k kh [hk|[gk]]|H]; [by rewrite hk ltnn in kh|by rewrite gk leqNgt kh in le|].
by rewrite leqNgt; apply/negP=> lt; apply: (H g lt); right.
Qed.

Lemma least_cycleP h : is_least h (orbit_of e s (next t) h) <-> least (on_cycle t) h.
Proof. by split=> /(is_leastP (cycleP e s h)). Qed.

Lemma least_borderP h : on_border e s h && is_least h (border_of e s h) <-> least_on_border e s h.
Proof. by split=> [/andP[b /(is_leastP (borderP e s h))]|[b /(is_leastP (borderP e s h))->]]; rewrite ?b. Qed.

Lemma least_lists hs (P : nat -> Prop) : lists hs P ->
  [/\ lists (least_edges e s hs) (fun h => P h /\ least (same_edge t) h),
      lists (least_cycles e s hs) (fun h => P h /\ least (on_cycle t) h)
    & lists (least_borders e s hs) (fun h => P h /\ least_on_border e s h)].
Proof.
move=> H; split; apply: lists_sub H _ => h _.
- exact: least_edgeP.
- exact: least_cycleP.
exact: least_borderP.
Qed.

Lemma countedP v V E cycles : counts_of e s v V E cycles <-> counted e s v = (V, E, cycles).
Proof.
have Lv := linked_lists e s v; have [Le Lc Lb] := least_lists (component_lists v).
rewrite /counted; split=> [[vs [es [cs [bs [Hv He Hc Hb [-> -> ->]]]]]]|].
  rewrite (lists_size Hv Lv) (lists_size Hc Lc) (lists_size Hb Lb) -size_eq0 -(lists_size He Le) //.
move=> [<- <- <-]; do 4!eexists; split; [exact: Lv|exact: Le|exact: Lc|exact: Lb|by rewrite -size_eq0].
Qed.

Lemma genus_atP v g : genus_at e s v = Some g <-> exists V E cycles,
  counts_of e s v V E cycles /\ V + cycles + 2 * g = 2 + E.
Proof.
rewrite /genus_at; case C: (counted e s v) => [[V E] cycles]; split.
  case: ifP => // /andP[le ev] [<-]; exists V, E, cycles; split; first exact/countedP.
  have := odd_double_half (2 + E - (V + cycles)); rewrite (negPf ev) add0n -mul2n => ->; exact: subnKC.
case=> V' [E' [cycles' [/countedP]]]; rewrite C => -[-> -> ->] eq.
rewrite -eq leq_addr addKn oddM /=; congr Some; by rewrite mul2n doubleK.
Qed.

Lemma decide_t3P : reflect (t3 e s) (decide_t3 e s).
Proof.
apply: each_vertex => v _; case G: (genus_at e s v) => [g|].
  apply: (iffP (impP _ eqP)) => [g0|[V [E [c [C [g' eq g0]]]]] pl].
    by have [V [E [c [C eq]]]] := (genus_atP v g).1 G; exists V, E, c; split=> //; exists g.
  have: genus_at e s v = Some g' by apply/genus_atP; exists V, E, c.
  by rewrite G => -[->]; apply: g0.
right=> -[V [E [c [C [g eq _]]]]].
by have: genus_at e s v = Some g; [apply/genus_atP; exists V, E, c | rewrite G].
Qed.

(** ** Simple maps, and T4 *)

Lemma bothP k l m n : reflect (k = m /\ l = n) (both k l m n).
Proof. exact: andPP (same_linkP _ _) (same_linkP _ _). Qed.

Lemma simpleP : reflect (simple_of e s) (decide_simple e s).
Proof.
have sameP g h : reflect (same_edge t g h) ((g == h) || same_link (twin t g) (Some h)).
  exact: orPP eqP (same_linkP _ _).
have joinP h u w : reflect (origin t h = Some u /\ end_of e s h = Some w \/ origin t h = Some w /\ end_of e s h = Some u)
    (both (origin t h) (end_of e s h) (Some u) (Some w) || both (origin t h) (end_of e s h) (Some w) (Some u)).
  exact: orPP (bothP _ _ _ _) (bothP _ _ _ _).
apply: (iffP allP) => H g.
  move=> u w Eu Ew; have := H g; rewrite mem_half_edges (heard_live Eu) Eu Ew => /(_ isT)/andP[/eqP ne A]; split=> // h J.
  have lh : half_edge t h by case: J => -[E _]; apply: heard_live E.
  move/allP/(_ h): A; rewrite mem_half_edges => /(_ lh).
  by case/orP=> [/joinP|/sameP].
move=> _; case Eu: (origin t g) => [u|] //; case Ew: (end_of e s g) => [w|] //; have [ne A] := H g u w Eu Ew.
apply/andP; split; first exact/eqP.
by apply/allP=> h _; case: joinP => //= /A/sameP.
Qed.

Lemma half_edge_lists : lists (half_edge_list e s) (half_edge t).
Proof. by split=> [|h]; [apply: half_edges_uniq | rewrite mem_half_edges]. Qed.
Lemma vertex_lists : lists (vertex_list e s) (vertex t).
Proof. by split=> [|v]; [apply: vertices_uniq | rewrite mem_vertices]. Qed.
Lemma face_lists : lists (face_list e s) (face t).
Proof. by split=> [|f]; [apply: filter_uniq (iota_uniq _ _) | rewrite mem_faces]. Qed.

Lemma decide_t4P : reflect (t4 e s) (decide_t4 e s).
Proof.
have [Le _ _] := least_lists half_edge_lists.
set V := size (vertex_list e s); set E := size (least_edges e s (half_edge_list e s)); set F := size (face_list e s).
have bounded : reflect (3 <= V -> E + 6 <= 3 * V /\ F + 4 <= 2 * V) ((V < 3) || (E + 6 <= 3 * V) && (F + 4 <= 2 * V)).
  by rewrite [V < 3]ltnNge; apply: impP; apply: andP.
rewrite /decide_t4 -orbA; apply: impP; case: simpleP => sim /=; last by left.
apply: (iffP bounded) => [H _ vs es fs Hv He Hf|H].
  by rewrite (lists_size Hv vertex_lists) (lists_size He Le) (lists_size Hf face_lists).
exact: (H sim _ _ _ vertex_lists Le face_lists).
Qed.

(** ** M1 to M8 *)

Lemma decide_m1P : reflect (m1 e s) (decide_m1 e s).
Proof.
apply: impP; apply: each_vertex => v _; case: (bareP e s v) => b.
  by right=> -[h E]; apply: (b h (heard_live E) E).
left; move: b; rewrite /bare => b; case E: (leaving_list e s v) => [|h rest]; last by exists h; apply/leavingP; rewrite E mem_head.
by case: b => h _ /leavingP; rewrite E.
Qed.

Lemma decide_m2P : reflect (m2 e s) (decide_m2 e s).
Proof. exact: impP simpleP. Qed.

(** A number that is asked for is that of a list. *)
Lemma size_askedP (xs : seq nat) (P : nat -> Prop) n : lists xs P -> reflect (exists2 ys, lists ys P & size ys = n) (size xs == n).
Proof. by move=> H; apply: (iffP eqP) => [<-|[ys Hy <-]]; [exists xs | apply: lists_size H Hy]. Qed.

Lemma decide_m3P : reflect (m3 e s) (decide_m3 e s).
Proof.
apply: asksP => n; apply: ifP_of; last first.
  by apply: each_half_edge => h _; apply: size_askedP; split=> [|g]; [apply: orbit_uniq | apply: cycleP].
apply: each_face => f _; apply: impP; apply: size_askedP; apply: lists_half_edges => h; first by split=> /same_linkP.
rewrite /face_of /side; case: (has_records s); first by case E: (boundary_of t h) => [b|] // _; apply: heard_live E.
by case: (has_faces s) => //; apply: heard_live.
Qed.

Lemma decide_m4P : reflect (m4 e s) (decide_m4 e s).
Proof.
apply: impP; apply: each_half_edge => h _; apply: andPP idP.
by apply: (iffP negP) => n /is_nilP.
Qed.

Lemma decide_m5P : reflect (m5 e s) (decide_m5 e s).
Proof.
apply: asksP => n; apply: size_askedP.
have H := @lists_sub _ _ (fun v => least (linked e s) v /\ exists h, of_component e s v h)
  (fun v => let vs := linked_list e s v in is_least v vs && ~~ nilp (component_list e s vs)) vertex_lists.
apply: lists_iff (H _) => v; first by split=> [[? []]|[]].
move=> _ /=; have [_ mem] := component_lists v; split=> [/andP[/(is_leastP (linkedP e s v)) L N]|[/(is_leastP (linkedP e s v))-> [h hv]]].
  by split=> //; case: (component_list _ _ _) mem N => // h r mem _; exists h; apply/mem; rewrite mem_head.
by move/mem: hv; case: (component_list _ _ _).
Qed.

Lemma decide_m6P : reflect (m6 e s) (decide_m6 e s).
Proof.
apply: asksP => n; have [_ _ Lb] := least_lists half_edge_lists.
have Lc : lists [seq h <- half_edge_list e s | lacks_face e s h && is_least h (orbit_of e s (next t) h)]
    (fun h => [/\ half_edge t h, lacks_face e s h & least (on_cycle t) h]).
  apply: lists_half_edges => [h lh|h []//].
  by split=> [/andP[-> /least_cycleP]|[_ -> /least_cycleP]].
apply: (iffP eqP) => [eq|[cs [bs [Hc Hb <-]]]]; last by rewrite (lists_size Hc Lc) (lists_size Hb Lb).
by do 2!eexists; split; [exact: Lc|exact: Lb|exact: eq].
Qed.

Lemma decide_m7P : reflect (m7 e s) (decide_m7 e s).
Proof.
apply: asksP => n; set ws := [seq v <- _ | _].
have Lw : lists ws (fun v => vertex t v /\ least (linked e s) v).
  by apply: lists_sub vertex_lists _ => v _; split=> /(is_leastP (linkedP e s v)).
apply: (iffP andP) => [[/allP A /eqP sum]|[vs [genus [Hv G <-]]]].
  exists ws, (fun v => odflt 0 (genus_at e s v)); split=> // v /A.
  by case E: (genus_at e s v) => [g|] // _; apply/genus_atP.
have same v : v \in ws -> genus_at e s v = Some (genus v).
  by move=> vw; apply/genus_atP/G; apply/(Hv.2 v)/(Lw.2 v).
split; first by apply/allP=> v /same->.
have -> : [seq odflt 0 (genus_at e s v) | v <- ws] = [seq genus v | v <- ws].
  by apply/eq_in_map => v /same->.
rewrite !sumnE !big_map; apply/eqP/perm_big; apply: uniq_perm => [||v]; [exact: Lw.1|exact: Hv.1|].
by apply/idP/idP => [/(Lw.2 v)/(Hv.2 v)|/(Hv.2 v)/(Lw.2 v)].
Qed.

Lemma decide_m8P : reflect (m8 e s) (decide_m8 e s).
Proof.
rewrite /decide_m8 -orbA; apply: impP; apply: impP; apply: (iffP allP) => H.
  move=> v h E B; have := H h; rewrite mem_half_edges (heard_live E) E B /= => /(_ isT).
  by case: (leaving t v).
move=> h _; case E: (origin t h) => [v|] //; case B: (at_border e s h) => //=.
by have := H v h E B; case: (leaving t v).
Qed.

(** ** The ladder *)

Theorem decideP r : reflect (holds_of e s r) (decide e s r).
Proof.
case: r => [[]|[]]; [exact: decide_r1P|exact: decide_l1P|exact: decide_l2P|exact: decide_l3P|exact: check_v1P|exact: decide_v2P
  |exact: decide_b1P|exact: decide_b2P|exact: decide_f1P|exact: decide_f2P|exact: decide_t1P|exact: decide_t2P|exact: decide_t3P
  |exact: decide_t4P|exact: decide_m1P|exact: decide_m2P|exact: decide_m3P|exact: decide_m4P|exact: decide_m5P|exact: decide_m6P
  |exact: decide_m7P|exact: decide_m8P].
Qed.

End Rules.

(** The rules are on the ladder in their order. *)
Lemma ladder_position r : nth r ladder (position r) = r /\ position r < size ladder.
Proof. by case: r => [[]|[]]. Qed.

Lemma position_ladder d i : i < size ladder -> position (nth d ladder i) = i.
Proof. by do 22!case: i => [|i] //. Qed.

Lemma first_refused_position e s rs d :
  if first_refused e s rs is Some r then
    exists2 i, i < size rs & [/\ nth d rs i = r, ~~ decide e s r & forall j, j < i -> decide e s (nth d rs j)]
  else forall i, i < size rs -> decide e s (nth d rs i).
Proof.
elim: rs => //= r rs; case D: (decide e s r); last by exists 0; rewrite ?D.
case: (first_refused e s rs) => [q [i lt [E nq H]]|H]; last by case.
by exists i.+1 => //; split=> // -[|j] //; apply: H.
Qed.

(** The checker returns the first broken rule, and none if all hold: for every expectation, whatever parts are stored, and for
    every structure, whatever its links. *)
Theorem first_broken_of_some e s r : first_broken_of e s = Some r <->
  ~ holds_of e s r /\ forall q, position q < position r -> holds_of e s q.
Proof.
have := first_refused_position e s ladder r; rewrite -/(first_broken_of e s); case: (first_broken_of e s) => [q|] H.
  case: H => i lt [E nq below]; have pq : position q = i by rewrite -E position_ladder.
  have before p : position p < i -> holds_of e s p.
    have [Ep lp] := ladder_position p => lt'; rewrite -Ep; apply/decideP.
    by rewrite (set_nth_default r) //; apply: below.
  have broken : ~ holds_of e s q by move/decideP; apply/negP.
  split=> [[<-]|[nr B]]; first by rewrite pq.
  congr Some; have [Eq lq] := ladder_position q; have [Er lr] := ladder_position r.
  have same : position q = position r by case: (ltngtP (position q) (position r)) => // [/B //|]; rewrite pq => /before.
  by rewrite -Eq -Er same; apply: set_nth_default.
split=> // -[nr _]; case: nr; have [E lt] := ladder_position r; rewrite -E; exact/decideP/H.
Qed.

Theorem first_broken_of_none e s : first_broken_of e s = None <-> rules_of e s.
Proof.
split=> [E r|H].
  have := first_refused_position e s ladder r; rewrite -/(first_broken_of e s) E => A.
  by have [Er lt] := ladder_position r; rewrite -Er; apply/decideP/A.
by case E: (first_broken_of e s) => [r|] //; have [nr _] := (first_broken_of_some e s r).1 E; case: nr.
Qed.
