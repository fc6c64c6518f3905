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
From twinedge Require Import Drawing Euler Numbered Genus WholeEuler Bounds Verdict Labels.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** ** Lists with one of each, by their length *)

Section OneOfEach.
Variables (same : nat -> nat -> Prop) (P : nat -> Prop) (s' : seq nat).
Hypothesis sym : forall x y, P x -> P y -> same x y -> same y x.
Hypothesis trans : forall x y z, same x y -> same y z -> same x z.
Hypothesis each : lists_one_of_each s' same P.

Lemma one_of_each_refl x : P x -> same x x.
Proof.
have [_ sP _ all] := each => Px; have [z zs zx] := all x Px.
by apply: (trans _ zx); apply: sym zx => //; apply: sP.
Qed.

Lemma different_le s : uniq s -> (forall x, x \in s -> P x) ->
  (forall x y, x \in s -> y \in s -> same x y -> x = y) -> size s <= size s'.
Proof.
have [_ sP' _ all] := each => u sP one.
apply: (@rel_size_le s s' (fun x y => y \in s' /\ same y x)) => // [x xs|x y z xs ys [zs zx] [_ zy]].
  by have [y ys yx] := all x (sP x xs); exists y.
by apply: one => //; apply: (trans _ zy); apply: sym zx; [apply: sP'|apply: sP].
Qed.

(** As many different ones as there are: they are one of each. *)
Lemma different_all s : (forall x y, P x -> P y -> same x y \/ ~ same x y) -> uniq s -> (forall x, x \in s -> P x) ->
  (forall x y, x \in s -> y \in s -> same x y -> x = y) -> size s' <= size s -> lists_one_of_each s same P.
Proof.
move=> dec u sP one ge; split=> // x Px.
have [//|none] : (exists2 y, y \in s & same y x) \/ (forall y, y \in s -> ~ same y x).
  elim: (s) sP => [|y r IH] sP; first by right.
  have [|[z zr zx]|none] := IH; first by move=> z zr; apply: sP; rewrite inE zr orbT.
    by left; exists z => //; rewrite inE zr orbT.
  have [yx|yx] := dec y x (sP y (mem_head _ _)) Px; first by left; exists y; rewrite ?mem_head.
  by right=> z; rewrite inE => /orP[/eqP->|/none].
suff : size (x :: s) <= size s' by rewrite /= => lt; have := leq_ltn_trans ge lt; rewrite ltnn.
apply: different_le => /=.
- by rewrite u andbT; apply/negP=> /none; apply; apply: one_of_each_refl.
- by move=> y; rewrite inE => /orP[/eqP->|/sP].
move=> y z; rewrite !inE => /orP[/eqP->|ys] /orP[/eqP->|zs] // yz; last exact: one.
  by case: (none z zs); apply: sym yz => //; apply: sP.
by case: (none y ys).
Qed.

(** Some of which each is one of are no fewer than there are. *)
Lemma cover_le s : (forall x, x \in s -> P x) -> (forall x, P x -> exists2 y, y \in s & same y x) -> size s' <= size s.
Proof.
have [u sP' one _] := each => sP cover.
apply: (@rel_size_le s' s (fun x y => y \in s /\ same y x)) => // [x xs|x y z xs ys [zs zx] [_ zy]].
  by have [y ys yx] := cover x (sP' x xs); exists y.
by apply: one => //; apply: (trans _ zy); apply: sym zx; [apply: sP|apply: sP'].
Qed.

(** As few as there are: they are different. *)
Lemma cover_all s : uniq s -> (forall x, x \in s -> P x) -> (forall x, P x -> exists2 y, y \in s & same y x) ->
  size s <= size s' -> lists_one_of_each s same P.
Proof.
move=> u sP cover le; split=> // x y xs ys xy; apply/eqP; case: (x =P y) => // /eqP ne.
suff : size s' <= size (rem y s).
  by rewrite size_rem // => le'; have := leq_trans le le'; case: (s) ys => //= a r _; rewrite ltnn.
have mem z : z \in s -> z != y -> z \in rem y s by move=> zs zy; rewrite mem_rem_uniq // inE zy.
apply: cover_le => [z /mem_rem/sP //|z Pz]; have [w ws wz] := cover z Pz.
case: (w =P y) wz => [->|/eqP wy] wz; last by exists w => //; apply: mem.
by exists x; [apply: mem|apply: trans wz].
Qed.
End OneOfEach.

(** ** What the tests say of single records *)

(** Five tests of the half-edges say that the links between them are permutations. *)
Lemma map_tests t : (forall h, half_edge t h -> [&& twin_ok t h, next_ok t h, target_ok t h, origin_ok t h & cycle_ok t h]) ->
  is_map t.
Proof.
move=> tests.
have live (on : pred nat) T (asked : nat -> option T) l x : (forall i x, asked i = Some x -> on i) ->
    l >>= asked = Some x -> leads_to on l.
  by move=> H; case: l => [i|] //= E; exists i => //; apply: H E.
have nonnil l : ~~ is_nil l -> exists x, l = Some x by case: l => [x|] // _; exists x.
have heardL T (on : pred nat) (says : nat -> option T) i x : heard on says i = Some x -> on i by apply: heard_live.
split=> h /tests /and5P[/andP[/same_linkP tt /same_linkP nt] /andP[/same_linkP pn /same_linkP np] /same_linkP ta o /andP[_ c]] //.
have [x ox] := nonnil _ o; have [y cy] := nonnil _ c; split.
- exact: live (@heardL _ _ _) ox.
- exact: live (@heardL _ _ _) tt.
- exact: live (@heardL _ _ _) pn.
- exact: live (@heardL _ _ _) np.
apply: live cy => i z; rewrite /cycle_start; case S: (boundary_start t i) => [s|] // _.
exact: heard_live S.
Qed.

(** What the rotations, the cycles and their counts rest on. *)
Record basics t : Prop := Basics {
  basic_map : is_map t;
  basic_leaving : forall v h, leaving t v = Some h -> half_edge t h /\ origin t h = Some v;
  basic_start : forall b h, boundary_start t b = Some (AtHalfEdge h) -> half_edge t h /\ boundary_of t h = Some b;
  basic_cycle : forall x : dart t, bnd (nx x) = bnd x
}.

Lemma is_nilP l : reflect (l = None) (is_nil l).
Proof. by case: l => [i|]; constructor. Qed.

Lemma numberE n (p : pred nat) : number n p = count p (iota 0 n).
Proof. by rewrite /number fold_count. Qed.

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

Definition roots_of t := [seq start_of t b | b <- iota 0 (boundary_slots t) & ~~ is_nil (cycle_start t b) && listed_inner t b].

Section Counts.
Variable t : view.
Hypothesis basic : basics t.

Let map := basic_map basic.

Lemma orbits_exist (f : dart t -> dart t) says : injective f ->
  (forall x y : dart t, on_orbit says (num x) (num y) <-> fconnect f x y) ->
  exists s, lists_one_of_each s (on_orbit says) (half_edge t).
Proof.
move=> inj onE; have sym := fconnect_sym inj; exists [seq num x | x <- enum (roots (frel f))]; split.
- by rewrite (map_inj_uniq (@num_inj _ _)) enum_uniq.
- by move=> h /mapP[x _ ->]; apply: dart_live.
- move=> g h /mapP[x + ->] /mapP[y + ->]; rewrite !mem_enum => /eqP rx /eqP ry /onE xy.
  by rewrite -rx -ry; congr num; apply/(rootP sym).
move=> h /dartP[x <-]; exists (num (root (frel f) x)).
  by apply: map_f; rewrite mem_enum; apply: roots_root.
by apply/onE; rewrite sym; apply: connect_root.
Qed.

Lemma edge_list : exists es, lists_one_of_each es (same_edge t) (half_edge t) /\ half_edge_count t = (size es).*2.
Proof.
have [edges every] := every_edge_exists (twK map) (tw_neq map); have [u all] := every.
have sameE (x y : dart t) : same_edge t (num x) (num y) <-> x = y \/ tw x = y.
  by rewrite /same_edge (twinE map); split=> [[/num_inj|[/num_inj]]|[->|->]]; by [left|right].
exists [seq num x | x <- edges]; split; last first.
  rewrite size_map (size_every every) /half_edge_count numberE (@count_slots _ _ (@half_edge_below t)) //.
  by apply: eq_card => x; rewrite !inE dart_live.
move: u; rewrite cat_uniq => /and3P[ue /hasPn no ut]; split.
- by rewrite (map_inj_uniq (@num_inj _ _)).
- by move=> h /mapP[x _ ->]; apply: dart_live.
- move=> g h /mapP[x xs ->] /mapP[y ys ->] /sameE[-> //|xy].
  by case/negP: (no (tw x) (map_f _ xs)); rewrite xy.
move=> h /dartP[x <-]; have := all x; rewrite mem_cat => /orP[xs|/mapP[y ys ->]].
  by exists (num x); [apply: map_f|left].
by exists (num y); [apply: map_f|apply/sameE; right].
Qed.

Lemma piece_list : lists_one_of_each (pieces t) (reached (near t)) (half_edge t).
Proof.
have piece h : h \in pieces t <-> labels t h = Some h.
  rewrite mem_filter mem_iota add0n; split=> [/andP[/eqP]//|E].
  by rewrite E eqxx half_edge_below // (label_live map E).
split; first exact: filter_uniq (iota_uniq _ _).
- by move=> h /piece/(label_live map).
- move=> g h /piece gp /piece hp; have [x xg] := dartP (label_live map gp); have [y yh] := dartP (label_live map hp).
  rewrite -xg -yh => /(labelE map); rewrite xg yh gp hp => -[] //.
move=> h /dartP[x <-]; have [r xr] := label_total map x; exists r.
  apply/piece; by case: (flood_all_label (@half_edge_below t) (near_live map) (near_sym map) (near_enough t) xr).
have [_ lr rr] := flood_all_label (@half_edge_below t) (near_live map) (near_sym map) (near_enough t) xr.
have [y yr] := dartP lr; rewrite -yr; apply/(labelE map).
by rewrite xr -yr; move: rr; rewrite -yr.
Qed.

(** *** The lists of the records *)

Lemma rotations_count : rotation_count t = size (rotations t).
Proof.
rewrite size_map size_filter /rotation_count numberE; apply: eq_count => v.
by case: (leaving t v).
Qed.

Lemma cycles_count : cycle_count t = size (cycles t).
Proof.
rewrite size_map size_filter /cycle_count numberE; apply: eq_count => b.
by rewrite /cycle_start /cyclic; case: (boundary_start t b) => [[|]|].
Qed.

Lemma roots_count : root_count t = size (roots_of t).
Proof. by rewrite size_map size_filter /root_count numberE. Qed.

Lemma kept_dart v : v \in with_edges t -> exists2 x : dart t, kept t v = num x & org x = v.
Proof.
rewrite mem_filter => /andP[+ _]; rewrite /kept; case E: (leaving t v) => [h|] // _.
by have [lh /(originP map)[x <- <-]] := basic_leaving basic E; exists x.
Qed.

Lemma start_dart b : ~~ is_nil (cycle_start t b) -> exists2 x : dart t, start_of t b = num x & bnd x = b.
Proof.
rewrite /cycle_start /start_of; case E: (boundary_start t b) => [[h|]|] // _.
have [/dartP[x xh] bh] := basic_start basic E; exists x; first by rewrite xh.
by move: bh; rewrite -xh (boundaryE map) => -[].
Qed.

Lemma cyclicE b : cyclic t b = ~~ is_nil (cycle_start t b).
Proof. by rewrite /cyclic /cycle_start; case: (boundary_start t b) => [[|]|]. Qed.

Lemma org_orbit (x y : dart t) : fconnect (@tn t) x y -> org x = org y.
Proof. by move/iter_findex <-; elim: (findex _ _ _) => //= k ->; rewrite org_tn. Qed.

Lemma bnd_orbit (x y : dart t) : fconnect (@nx t) x y -> bnd x = bnd y.
Proof. by move/iter_findex <-; elim: (findex _ _ _) => //= k ->; rewrite (basic_cycle basic). Qed.

Lemma rotations_differ g h : g \in rotations t -> h \in rotations t -> on_orbit (turn t) g h -> g = h.
Proof.
case/mapP=> v /kept_dart[x Ex xv] -> /mapP[w /kept_dart[y Ey yw] ->].
rewrite Ex Ey (on_rotationE map) => /org_orbit; rewrite xv yw => vw.
by rewrite -Ex -Ey vw.
Qed.

Lemma cycles_differ g h : g \in cycles t -> h \in cycles t -> on_cycle t g h -> g = h.
Proof.
have mem b : b \in [seq b <- iota 0 (boundary_slots t) | cyclic t b] -> exists2 x : dart t, start_of t b = num x & bnd x = b.
  by rewrite mem_filter cyclicE => /andP[/start_dart].
case/mapP=> b /mem[x Ex xb] -> /mapP[c /mem[y Ey yc] ->].
rewrite Ex Ey (on_cycleE map) => /bnd_orbit; rewrite xb yc => bc.
by rewrite -Ex -Ey bc.
Qed.

Lemma rotations_uniq : uniq (rotations t).
Proof.
rewrite map_inj_in_uniq ?filter_uniq ?iota_uniq // => v w /kept_dart[x -> <-] /kept_dart[y -> <-] /num_inj-> //.
Qed.

Lemma starts_uniq (p : pred nat) : (forall b, p b -> ~~ is_nil (cycle_start t b)) ->
  uniq [seq start_of t b | b <- iota 0 (boundary_slots t) & p b].
Proof.
move=> cyc; rewrite map_inj_in_uniq ?filter_uniq ?iota_uniq // => b c; rewrite !mem_filter.
by move=> /andP[/cyc/start_dart[x -> <-] _] /andP[/cyc/start_dart[y -> <-] _] /num_inj->.
Qed.

Lemma starts_live (p : pred nat) h : (forall b, p b -> ~~ is_nil (cycle_start t b)) ->
  h \in [seq start_of t b | b <- iota 0 (boundary_slots t) & p b] -> half_edge t h.
Proof. by move=> cyc /mapP[b]; rewrite mem_filter => /andP[/cyc/start_dart[x -> _] _] ->; apply: dart_live. Qed.

Lemma inner_cyclic b : ~~ is_nil (cycle_start t b) && listed_inner t b -> ~~ is_nil (cycle_start t b).
Proof. by case/andP. Qed.

Lemma cyclic_start b : cyclic t b -> ~~ is_nil (cycle_start t b).
Proof. by rewrite cyclicE. Qed.

(** *** Euler's formula

    Different vertices are on different rotations, different boundary components have different cycles. *)

Lemma starts_half_edge h : h \in cycles t -> half_edge t h.
Proof. exact: starts_live cyclic_start. Qed.

Lemma rotations_half_edge h : h \in rotations t -> half_edge t h.
Proof. by move=> /mapP[v /kept_dart[x -> _] ->]; apply: dart_live. Qed.

Lemma orbit_decided says (f : dart t -> dart t) : (forall x y : dart t, on_orbit says (num x) (num y) <-> fconnect f x y) ->
  forall g h, half_edge t g -> half_edge t h -> on_orbit says g h \/ ~ on_orbit says g h.
Proof.
move=> onE _ _ /dartP[x <-] /dartP[y <-]; rewrite onE.
by case: (fconnect f x y); [left|right].
Qed.

Lemma orbit_formula : exists vs cs es g, [/\ lists_one_of_each vs (on_orbit (turn t)) (half_edge t),
  lists_one_of_each cs (on_cycle t) (half_edge t), lists_one_of_each es (same_edge t) (half_edge t),
  half_edge_count t = (size es).*2 & size vs + size cs + g.*2 = size es + (size (pieces t)).*2].
Proof.
have [vs Hv] := orbits_exist (tn_inj map) (on_rotationE map); have [cs Hc] := orbits_exist (nx_inj map) (on_cycleE map).
have [es [He E]] := edge_list; have Hp := piece_list.
have [g formula] : exists g, size vs + size cs + g.*2 = size es + (size (pieces t)).*2.
  by apply: (@part_euler t (half_edge t) map) Hv Hc He Hp => // x _; split; apply: dart_live.
by exists vs, cs, es, g.
Qed.

Lemma reached_back g h : half_edge t g -> half_edge t h -> reached (near t) g h -> reached (near t) h g.
Proof. by move=> lg _; apply: (reached_sym (near_live map) (near_sym map) lg). Qed.

End Counts.

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
