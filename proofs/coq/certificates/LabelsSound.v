(** * LabelsSound: what is accepted with some ranks keeps all rules

    The tests of single records give R1 to L3, V1, B2, F1 and F2. For V2, B1, T1 and T3 four numbers are compared:

<<
      rotation_count + cycle_count ≤ rotations + cycles        different vertices are on different rotations,
                                                               different boundary components have different cycles
      rotations + cycles = E + 2 · components − 2 · handles    Euler's formula
      components ≤ root_count                                  from each half-edge the ranks lead down to a root
      E + 2 · root_count = rotation_count + cycle_count        euler_ok
>>

    So all of them are equal, and there are no handles. *)

From mathcomp Require Import all_ssreflect all_fingroup.
From twinedge Require Import Arith View Rules Loops LoopsProof Reference Map Counting Lists ReferenceProof TopologyProof.
From twinedge Require Import Drawing Euler Numbered Genus WholeEuler Bounds Verdict Labels OneOfEach Orbits.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** ** What the tests say of single records *)

Section Sound.
Variables (t : view) (rank : nat -> nat).
Hypothesis ok : accepts t rank.

Lemma sound_half_edge h : half_edge t h -> half_edge_ok t rank h.
Proof. by case/and5P: ok => /each_half_edgeP H _ _ _ _ /H. Qed.
Let vertices v : vertex t v -> vertex_ok t v.
Proof. by case/and5P: ok => _ /each_vertexP H _ _ _ /H. Qed.
Let boundaries b : boundary t b -> boundary_ok t b.
Proof. by case/and5P: ok => _ _ /each_boundaryP H _ _ /H. Qed.
Let faces f : face t f -> face_ok t f.
Proof. by case/and5P: ok => _ _ _ /each_faceP H _ /H. Qed.

Lemma sound_map : is_map t.
Proof.
by apply: map_tests => h /sound_half_edge /and5P[-> -> -> -> /andP[-> _]].
Qed.

Let map := sound_map.

Lemma sound_leaving v h : leaving t v = Some h -> [/\ half_edge t h, origin t h = Some v & isolated t v = None].
Proof.
move=> E; have := vertices (heard_live E); rewrite /vertex_ok E => /and3P[lh /same_linkP o /is_nilP i].
by split.
Qed.

Lemma sound_origin (x : dart t) : exists h, leaving t (org x) = Some h.
Proof.
have /and5P[_ _ _ + _] := sound_half_edge (dart_live x).
by rewrite /origin_ok (originE map) /=; case: (leaving t (org x)) => [h|] // _; exists h.
Qed.

Lemma sound_bare v : vertex t v -> bare t v <-> leaving t v = None.
Proof.
move=> lv; split=> [bv|E].
  by case E: (leaving t v) => [h|] //; have [lh o _] := sound_leaving E; case: (bv h lh).
by apply/bareP => // x xv; have [h] := sound_origin x; rewrite xv E.
Qed.

Lemma sound_start b h : boundary_start t b = Some (AtHalfEdge h) -> half_edge t h /\ boundary_of t h = Some b.
Proof.
move=> E; have /andP[+ _] := boundaries (heard_live E); rewrite /start_ok E => /andP[lh /same_linkP].
by split.
Qed.

Lemma sound_isolated b v : boundary_start t b = Some (AtVertex v) ->
  [/\ vertex t v, leaving t v = None, isolated t v = Some b & is_inner t b].
Proof.
move=> E; have /andP[+ _] := boundaries (heard_live E); rewrite /start_ok E.
case/and4P=> lv /is_nilP n /same_linkP i; rewrite /listed_inner; case P: (boundary_place t b) => [[|j]|] // _.
by split=> //; exists j.
Qed.

Lemma sound_cycle (x : dart t) : bnd (nx x) = bnd x /\ exists h, boundary_start t (bnd x) = Some (AtHalfEdge h).
Proof.
have /and5P[_ _ _ _ /andP[/andP[+ +] _]] := sound_half_edge (dart_live x).
rewrite (nextE map) /= !(boundaryE map) => /same_linkP[-> /=]; split=> //.
by move: b; rewrite /cycle_start; case: (boundary_start t (bnd x)) => [[h|v]|] // _; exists h.
Qed.

Lemma sound_entry f p b : listed t f p = Some b ->
  [/\ boundary t b, boundary_face t b = Some f & boundary_place t b = Some p].
Proof.
move=> L; have /andP[O /all_belowP I] := faces (listed_face L).
suff : entry_ok t f p (Some b) by case/and3P=> lb /same_linkP Ef /same_placeP Ep.
case: p L => [|i] /= L; first by move: O; rewrite L.
by have := I i (inner_lt L); rewrite L.
Qed.

Lemma sound_place b : boundary t b -> exists f p,
  [/\ face t f, boundary_face t b = Some f, boundary_place t b = Some p & listed t f p = Some b].
Proof.
case/boundaries/andP=> _; rewrite /place_ok; case: (boundary_face t b) => [f|] //.
by case: (boundary_place t b) => [[|i]|] // /andP[lf /same_linkP L]; [exists f, Outer|exists f, (Inner i)].
Qed.

(** *** R1, V1, B2, F1, F2 *)

Lemma sound_links : links_live t.
Proof.
split.
- by case: map.
- move=> v lv; case E: (leaving t v) => [h|].
    by have [lh o i] := sound_leaving E; split; [left; exists h|left].
  have := vertices lv; rewrite /vertex_ok E; case: (isolated t v) => [b|] // /andP[lb _].
  by split; [right; split=> //; apply/sound_bare|right; exists b].
- move=> b lb; have [f [p [lf -> _ _]]] := sound_place lb; split; first by exists f.
  have := boundaries lb; rewrite /boundary_ok /start_ok; case E: (boundary_start t b) => [[h|v]|] //= _.
    by have [] := sound_start E.
  by have [] := sound_isolated E.
move=> f lf; have /andP[O /all_belowP I] := faces lf; split=> [|i /I].
  by case E: (outer t f) => [b|]; [right; exists b => //; have [] := @sound_entry f Outer b E|left].
by case: (inner t f i) => [b|] // /andP[lb _]; exists b.
Qed.

Lemma sound_f2 : f2_listed t.
Proof.
apply: f2_if => [b lb|f p b L]; last by have [] := sound_entry L.
by have [f [p [_ Ef Ep L]]] := sound_place lb; exists f, p.
Qed.

Lemma sound_r1 : r1_live t.
Proof. by split; [apply: sound_links|apply: lists_short_listed sound_links sound_f2]. Qed.

Lemma sound_v1 : v1_leaving t.
Proof. by move=> v h _ /sound_leaving[]. Qed.

Lemma sound_b2 : b2_isolated t.
Proof.
move=> v lv; split=> [/(sound_bare lv) E|nb].
  have := vertices lv; rewrite /vertex_ok E; case: (isolated t v) (@sound_isolated ^~ v) => [b|] // st /andP[lb sb].
  have Sb : starts_at_vertex t v b.
    by move: sb; rewrite /starts_at_vertex; case: (boundary_start t b) => [[|u]|] //= /eqP->.
  exists b; split=> // c; split=> [/st[_ _ [] //]|-> //].
case E: (leaving t v) => [h|]; last by case: nb; apply/sound_bare.
have [_ _ i] := sound_leaving E; split=> // b /sound_isolated[_]; rewrite E.
by [].
Qed.

Lemma sound_f1 : f1_outer t.
Proof.
split=> [|f b v E S].
  have /and5P[_ _ _ _ /andP[+ _]] := ok; rewrite /one_unbounded /unbounded_count numberE => /count1P[f /andP[/face_below //]|].
  move=> f [/andP[lf /is_nilP E] one]; exists f; split=> // g [lg Eg]; apply: one.
  by rewrite lg Eg.
have [_ _ Ep] := @sound_entry f Outer b E; have [_ _ _ [i]] := sound_isolated S.
by rewrite Ep.
Qed.

Lemma sound_basics : basics t.
Proof.
split; [exact: sound_map| |exact: sound_start|by move=> x; case: (sound_cycle x)].
by move=> v h /sound_leaving[].
Qed.

End Sound.

(** ** The four numbers *)

Section Ranks.
Variables (t : view) (rank : nat -> nat).
Hypothesis ok : accepts t rank.

Let basic := sound_basics ok.
Let map := basic_map basic.

(** *** The ranks lead down to a root *)

(** A root is the start of an inner boundary component, which lies in the unbounded face or in one whose outer cycle
    starts with a lower rank. *)
Lemma is_rootP h : is_root t rank h -> exists b, [/\ boundary_start t b = Some (AtHalfEdge h), is_inner t b, h \in roots_of t
  & exists2 f, boundary_face t b = Some f & outer t f = None \/
    exists c g, [/\ outer t f = Some c, boundary_start t c = Some (AtHalfEdge g) & rank g < rank h]].
Proof.
rewrite /is_root; case B: (boundary_of t h) => [b|] // /and3P[/same_linkP S I].
have S' : boundary_start t b = Some (AtHalfEdge h).
  by move: S; rewrite /cycle_start; case: (boundary_start t b) => [[g|]|] // -[->].
case Ef: (boundary_face t b) => [f|] // O; exists b; split=> //.
- by move: I; rewrite /listed_inner /is_inner; case: (boundary_place t b) => [[|i]|] // _; exists i.
- apply/mapP; exists b; last by rewrite /start_of S'.
  by rewrite mem_filter S I mem_iota add0n /= boundary_below //; apply: heard_live S'.
exists f => //; case E: (outer t f) O => [c|] /= O; [right|by left].
move: O; rewrite /cycle_start; case Sc: (boundary_start t c) => [[g|]|] //= lt.
by exists c, g.
Qed.

Lemma descends (x : dart t) : exists2 h, is_root t rank h & rank h <= rank (num x) /\ reached (near t) (num x) h.
Proof.
move: {2}(rank _).+1 (ltnSn (rank (num x))) => n; elim: n x => // n IH x lt.
have /and5P[_ _ _ _ /andP[_]] := sound_half_edge ok (dart_live x).
have step (y : dart t) : num y \in near t (num x) -> rank (num y) < rank (num x) ->
    exists2 h, is_root t rank h & rank h <= rank (num x) /\ reached (near t) (num x) h.
  move=> near_y lower; have [|h rh [le r]] := IH y; first exact: leq_trans lower lt.
  exists h => //; split; first exact: leq_trans le (ltnW lower).
  by apply: reached_trans r; apply: reached_near near_y; apply: reached_self.
rewrite /rank_ok (nextE map) (prevE map) (twinE map) /= => /or4P[lower|lower|lower|root].
- by apply: (step (nx x)) => //; rewrite (near_dart map) !inE eqxx.
- by apply: (step (pv x)) => //; rewrite (near_dart map) !inE eqxx orbT.
- by apply: (step (tw x)) => //; rewrite (near_dart map) !inE eqxx !orbT.
by exists (num x) => //; split=> //; apply: reached_self.
Qed.

Lemma roots_live h : h \in roots_of t -> half_edge t h.
Proof. exact: starts_live basic _ _ (@inner_cyclic t). Qed.

Lemma roots_cover h : half_edge t h -> exists2 g, g \in roots_of t & reached (near t) g h.
Proof.
case/dartP=> x <-; have [g /is_rootP[b [_ _ gs _]] [_ r]] := descends x; exists g => //.
by have := reached_back basic (dart_live x) (roots_live gs) r.
Qed.

(** *** All are equal *)

Lemma sound_counts : [/\ lists_one_of_each (rotations t) (on_orbit (turn t)) (half_edge t),
  lists_one_of_each (cycles t) (on_cycle t) (half_edge t), lists_one_of_each (roots_of t) (reached (near t)) (half_edge t)
  & exists2 es, lists_one_of_each es (same_edge t) (half_edge t) &
      size (rotations t) + size (cycles t) = size es + (size (pieces t)).*2].
Proof.
have [vs [cs [es [g [Hv Hc He E formula]]]]] := orbit_formula basic; have Hp := piece_list basic.
have rl := rotations_half_edge basic; have cl := starts_half_edge basic.
have ru := rotations_uniq basic; have cu := starts_uniq basic (@cyclic_start t); have ou := starts_uniq basic (@inner_cyclic t).
have rd := rotations_differ basic; have cd := cycles_differ basic; have back := reached_back basic.
have le1 : size (rotations t) <= size vs by have := different_le (turn_sym map) (@orbit_trans (turn t)) Hv ru rl rd.
have le2 : size (cycles t) <= size cs by have := different_le (cycle_sym map) (@orbit_trans (next t)) Hc cu cl cd.
have tr : forall g h k, reached (near t) g h -> reached (near t) h k -> reached (near t) g k by move=> *; apply: reached_trans; eauto.
have le3 : size (pieces t) <= size (roots_of t) by have := cover_le back tr Hp roots_live roots_cover.
have /and5P[_ _ _ _ /andP[_ /eqP]] := ok; rewrite rotations_count cycles_count roots_count E => sums.
have e1 : size vs <= size (rotations t) by arith.
have e2 : size cs <= size (cycles t) by arith.
have e3 : size (roots_of t) <= size (pieces t) by arith.
split; last by exists es => //; arith.
- by have := different_all (turn_sym map) (@orbit_trans (turn t)) Hv (orbit_decided (on_rotationE map)) ru rl rd e1.
- by have := different_all (cycle_sym map) (@orbit_trans (next t)) Hc (orbit_decided (on_cycleE map)) cu cl cd e2.
by have := cover_all back tr Hp ou roots_live roots_cover e3.
Qed.

End Ranks.

(** ** The rules *)

Section Rules.
Variables (t : view) (rank : nat -> nat).
Hypothesis ok : accepts t rank.

Let basic := sound_basics ok.
Let map := basic_map basic.

Lemma sound_v2 : v2_rotation t.
Proof.
have [[_ _ _ all] _ _ _] := sound_counts ok => g h /dartP[x <-] /dartP[y <-].
rewrite (on_rotationE map) !(originE map); split=> [/(org_orbit basic)-> //|[xy]].
have [g' /mapP[v /(kept_dart basic)[x' Ex xv] ->]] := all _ (dart_live x).
have [h' /mapP[w /(kept_dart basic)[y' Ey yw] ->]] := all _ (dart_live y).
rewrite Ex Ey !(on_rotationE map) => yy xx.
have E : num x' = num y' by rewrite -Ex -Ey -xv -yw (org_orbit basic xx) (org_orbit basic yy) xy.
by apply: connect_trans yy; rewrite -(num_inj E) fconnect_sym //; apply: tn_inj.
Qed.

Lemma sound_b1 : b1_cycle t.
Proof.
have [_ [_ _ _ all] _ _] := sound_counts ok; split=> [h /dartP[x <-]|b h lb /dartP[x <-]].
  by rewrite (nextE map) /= !(boundaryE map); have [-> _] := sound_cycle ok x.
rewrite (boundaryE map); split=> [[xb]|[g S]]; last first.
  have [/dartP[y yg]] := sound_start ok S; rewrite -yg (boundaryE map) => -[yb] /(on_cycleE map)/(bnd_orbit basic) yx.
  by rewrite -yx yb.
have [g /mapP[c + ->]] := all _ (dart_live x); rewrite mem_filter cyclicE => /andP[cyc _].
have [y Ey yc] := start_dart basic cyc; rewrite Ey => yx; exists (num y) => //.
have E : c = b by rewrite -yc -xb; apply: (bnd_orbit basic); apply/(on_cycleE map).
rewrite -E; move: cyc Ey; rewrite /cycle_start /start_of.
by case: (boundary_start t c) => [[k|]|] // _ ->.
Qed.

Lemma sound_lower : lower t.
Proof.
have [_ l1 l2 l3] := map.
by case=> // _; [exact: sound_r1 ok|exact: sound_v1 ok|exact: sound_v2|exact: sound_b1|exact: sound_b2 ok|
  exact: sound_f1 ok|exact: sound_f2 ok].
Qed.

Let low := sound_lower.

Lemma sound_t3 : t3_euler t.
Proof. by have [_ _ _ [es He eq]] := sound_counts ok; apply/(t3_sums low He). Qed.

(** *** The outside of a component is where its root starts *)

Lemma root_outside (x : dart t) b : is_inner t b /\ (exists2 y : dart t, boundary_start t b = Some (AtHalfEdge (num y)) & joined x y)
  <-> exists h, [/\ h \in roots_of t, reached (near t) h (num x) & boundary_start t b = Some (AtHalfEdge h)].
Proof.
split=> [[[i P] [y S xy]]|[h [/mapP[c + hc] hx S]]].
  exists (num y); split=> //; last exact: joined_sym xy.
  apply/mapP; exists b; last by rewrite /start_of S.
  by rewrite mem_filter /cycle_start S /listed_inner P mem_iota add0n /= boundary_below //; apply: heard_live S.
rewrite mem_filter => /andP[/andP[cyc I] _]; have [y Ey yc] := start_dart basic cyc.
have bc : b = c.
  have [lh] := sound_start ok S; rewrite hc Ey (boundaryE map) => -[<-].
  by rewrite yc.
split; first by move: I; rewrite bc /listed_inner /is_inner; case: (boundary_place t c) => [[|i]|] // _; exists i.
by exists y; [rewrite -Ey -hc|apply: (joined_sym map); rewrite /joined -Ey -hc].
Qed.

Lemma sound_t1 : t1_outside t.
Proof.
have [_ _ [_ _ one all] _] := sound_counts ok => v lv.
case: (vertexP low lv) => [x _ <-|b _ bv I _]; last by exists b; split=> [|c]; rewrite (outside_bare low) // I => -[].
have [h hs hx] := all _ (dart_live x).
have [b S] : exists b, boundary_start t b = Some (AtHalfEdge h).
  case/mapP: (hs) => b; rewrite mem_filter => /andP[/andP[cyc _] _] hb; exists b; move: cyc hb.
  by rewrite /cycle_start /start_of; case: (boundary_start t b) => [[k|]|] // _ ->.
exists b; split=> [|c /(outside_dart low)/root_outside[g [gs gx Sg]]].
  by apply/(outside_dart low)/root_outside; exists h.
have E : h = g by apply: one => //; exact: reached_trans hx (reached_back basic (roots_live ok gs) (dart_live x) gx).
have [_ B] := sound_start ok S; have [_] := sound_start ok Sg.
by rewrite -E B => -[].
Qed.

(** The face in which the component of a half-edge lies is rooted. *)
Lemma sound_rooted n (x : dart t) b f : rank (num x) < n -> outside_of t (org x) b -> boundary_face t b = Some f -> rooted t f.
Proof.
elim: n x b f => // n IH x b f lt Ob Ef; have [h rh [le hx]] := descends ok x.
have [c [S I hs [g Eg O]]] := is_rootP rh.
have bc : b = c.
  have [d [_ one]] := sound_t1 (org_live map x); rewrite -(one b Ob); apply: one.
  apply/(outside_dart low)/root_outside; exists h; split=> //.
  by have := reached_back basic (dart_live x) (roots_live ok hs) hx.
move: Ef; rewrite bc Eg => -[<-]; have lf : face t g by have [f' [p [lf' + _ _]]] := sound_place ok (heard_live S); rewrite Eg => -[->].
case: O => [E|[e [k [Oe Se lower]]]]; first exact: rooted_here.
have [/dartP[y yk] _] := sound_start ok Se; rewrite -yk in Se lower.
have [b' [Ob' _]] := sound_t1 (org_live map y); have [f' Ef' lf'] := outside_face low Ob'.
apply: (rooted_out Oe (vertex_at_cycle low Se) Ob' Ef').
by apply: (IH y b' f') => //; apply: leq_trans lower _; apply: leq_trans le _.
Qed.

Lemma sound_t2 : t2_nesting t.
Proof.
move=> v b f lv Ob Ef; have [g Eg lg] := outside_face low Ob; move: Ef; rewrite Eg => -[gf].
rewrite gf in lg Eg; case: (faceP low lg) => [E|x E S]; first exact: rooted_here.
have [c [Oc _]] := sound_t1 (org_live map x); have [f' Ef' _] := outside_face low Oc.
by apply: (rooted_out E (vertex_at_cycle low S) Oc Ef'); apply: sound_rooted (ltnSn _) Oc Ef'.
Qed.

End Rules.

(** ** What is accepted keeps all rules, whatever the ranks are *)

Theorem labels_sound t rank : accepts t rank -> Rules.rules t.
Proof.
move=> ok; have low := sound_lower ok.
have up : holds_before t T4.
  move=> q lt; case: (ltnP (index q) (index T1)) => [/low //|].
  by case: q lt => // _ _; [exact: sound_t1 ok|exact: sound_t2 ok|exact: sound_t3 ok].
by case=> //; try (by apply: up); apply: t4_follows.
Qed.
