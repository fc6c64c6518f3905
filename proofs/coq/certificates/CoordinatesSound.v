(** * CoordinatesSound: what is accepted is drawn without crossings (G1, G4)

    The darts are a triangulation (Triangulation.v), so that Plane.v says how it is drawn. Half-edges lie on darts, different
    ones on different ones, and vertices are where darts start. *)

From Coq Require Import ZArith Lia.
From mathcomp Require Import all_ssreflect.
From twinedge Require Import Arith View Rules Loops LoopsProof Reference ReferenceProof Map Orientation Triangulation Plane Coordinates.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** ** The darts of a triangle *)

Lemma dart_is n d : d < 3 * n -> exists i j, [/\ i < n, j < 3 & d = 3 * i + j].
Proof.
move=> lt; exists (d %/ 3), (d %% 3); split; last by rewrite mulnC -divn_eq.
  by rewrite ltn_divLR // mulnC.
exact: ltn_pmod.
Qed.

Lemma mod_is i j : j < 3 -> (3 * i + j) %% 3 = j.
Proof. by move=> lt; rewrite mulnC modnMDl modn_small. Qed.

(** The first three darts are those of triangle 0. *)
Lemma outer_dart i j : j < 3 -> (3 <= 3 * i + j) = (i != 0).
Proof.
move=> j3; case: i => [|i]; first by rewrite muln0 add0n leqNgt j3.
by rewrite mulnS -addnA leq_addr.
Qed.

Lemma next_0 i : next_dart (3 * i) = 3 * i + 1.
Proof. by rewrite /next_dart -{1}(addn0 (3 * i)) mod_is // addn1. Qed.
Lemma next_1 i : next_dart (3 * i + 1) = 3 * i + 2.
Proof. by rewrite /next_dart mod_is //= addn1 addn2. Qed.
Lemma next_2 i : next_dart (3 * i + 2) = 3 * i.
Proof. by rewrite /next_dart mod_is //= addnK. Qed.

Lemma next_below n d : d < 3 * n -> next_dart d < 3 * n.
Proof.
case/dart_is=> i [j [lt j3 ->]]; have : 3 * i + 2 < 3 * n by arith.
case: j j3 => [|[|[|//]]] _ le; rewrite ?addn0 ?next_0 ?next_1 ?next_2 //.
  by apply: leq_trans le; rewrite ltnS leq_add2l.
by apply: leq_trans le; rewrite ltnS leq_addr.
Qed.

Lemma next_three n d : d < 3 * n -> next_dart (next_dart (next_dart d)) = d.
Proof. by case/dart_is=> i [j [_ j3 ->]]; case: j j3 => [|[|[|//]]] _; rewrite ?addn0 ?(next_0, next_1, next_2). Qed.

Section Sound.
Variables (t : view) (r : refinement).
Hypothesis map : is_map t.
Hypothesis ok : drawn t r.

Definition dart_type : finType := [finType of 'I_(dart_count r)].
Implicit Types (x y : dart_type).

Definition tw_dart x : dart_type := insubd x (dart_twin r x).
Definition nx_dart x : dart_type := insubd x (next_dart x).
Definition is_inner x : bool := 3 <= x.
Definition pt x : point := dart_at r x.

Let darts d : d < dart_count r -> dart_ok t r d.
Proof. by case/and4P: ok => /all_belowP H _ _ _ /H. Qed.
Let triangles i : i < triangle_count r -> triangle_ok r i.
Proof. by case/and4P: ok => _ /all_belowP H _ _ /H. Qed.

Lemma tw_val x : val (tw_dart x) = dart_twin r x.
Proof. by rewrite /tw_dart val_insubd; case/and5P: (darts (ltn_ord x)) => /andP[-> _]. Qed.

Lemma nx_val x : val (nx_dart x) = next_dart x.
Proof. by rewrite /nx_dart val_insubd next_below. Qed.

Lemma nx_three x : nx_dart (nx_dart (nx_dart x)) = x.
Proof. by apply: val_inj; rewrite !nx_val (next_three (ltn_ord x)). Qed.

Lemma point_nx x : dart_point r (nx_dart x) = dart_point r (tw_dart x).
Proof. by rewrite tw_val nx_val; case/and5P: (darts (ltn_ord x)) => _ /eqP. Qed.

Lemma tw_twice x : tw_dart (tw_dart x) = x.
Proof. by apply: val_inj; rewrite !tw_val; case/and5P: (darts (ltn_ord x)) => /andP[_ /eqP]. Qed.

Lemma turning x : (if is_inner x then 0 < corners_turn nx_dart pt x else corners_turn nx_dart pt x < 0)%Z.
Proof.
rewrite /corners_turn /pt /is_inner !nx_val; have [i [j [lt j3 E]]] := dart_is (ltn_ord x); rewrite E.
rewrite outer_dart //; have ok_i := triangles lt; rewrite /triangle_ok in ok_i.
set a := dart_at r (3 * i) in ok_i *; set b := dart_at r (3 * i + 1) in ok_i *; set c := dart_at r (3 * i + 2) in ok_i *.
have T u v w : orient u v w = orient v w u by rewrite (orient_turn u v w).
have cases : if i != 0 then (0 < orient a b c)%Z else (orient a b c < 0)%Z.
  move: ok_i; case: eqP => _ /counter_clockwiseP //=.
  by rewrite -(T b a c) (orient_swap a b); lia.
case: j j3 {E} => [|[|[|//]]] _; rewrite ?addn0 ?(next_0, next_1, next_2) -/a -/b -/c //.
  by rewrite -T.
by rewrite T.
Qed.

Lemma is_triangulation : triangulation tw_dart nx_dart is_inner pt.
Proof.
split.
- exact: tw_twice.
- exact: nx_three.
- by move=> x; rewrite /pt /dart_at point_nx.
- move=> x; rewrite /is_inner nx_val; have [i [j [lt j3 ->]]] := dart_is (ltn_ord x); rewrite outer_dart //.
  case: j j3 => [|[|[|//]]] _; rewrite ?addn0 ?(next_0, next_1, next_2); first exact: outer_dart.
    exact: outer_dart.
  by rewrite -[3 * i]addn0 outer_dart.
- by move=> x i; have := turning x; rewrite i.
- by move=> x /negPf i; have := turning x; rewrite i.
- rewrite cardE -(size_map val); apply: (@uniq_leq_size _ _ (iota 0 3)).
    by rewrite (map_inj_uniq val_inj) enum_uniq.
  move=> d /mapP[x + ->]; rewrite mem_enum inE /is_inner -ltnNge mem_iota add0n => lt.
  exact: lt.
move=> x o; apply/negPn/negP=> o'.
have /or3P[] : [|| tw_dart x == x, tw_dart x == nx_dart x | tw_dart x == nx_dart (nx_dart x)].
  have v1 : nat_of_ord (nx_dart x) = next_dart x := nx_val x.
  have v2 : nat_of_ord (nx_dart (nx_dart x)) = next_dart (next_dart x) by rewrite -v1; exact: nx_val.
  rewrite -!(inj_eq (@ord_inj _)) v1 v2; move: o o'; rewrite /is_inner -!ltnNge.
  by case: (nat_of_ord x) => [|[|[|]]] //; case: (nat_of_ord (tw_dart x)) => [|[|[|]]].
all: move/eqP=> E; have := turning x; rewrite (negPf o) /corners_turn /pt /dart_at point_nx ?E.
- by rewrite /orient /cross /sub; cbn [fst snd]; lia.
- have -> : dart_point r (nx_dart (nx_dart x)) = dart_point r x by rewrite point_nx -E tw_twice.
  by rewrite /orient /cross /sub; cbn [fst snd]; lia.
by rewrite /orient /cross /sub; cbn [fst snd]; lia.
Qed.

(** ** The half-edges and the vertices of the view *)

Lemma dart_of d : d < dart_count r -> exists x : dart_type, val x = d.
Proof. by move=> lt; exists (Ordinal lt). Qed.

Lemma half_edge_lies h : half_edge t h -> exists x : dart_type, [/\ val x = half_edge_dart r h,
  dart_half_edge r x = Some h, origin t h = Some (dart_point r x)
  & exists2 g, twin t h = Some g & half_edge_dart r g = val (tw_dart x)].
Proof.
move=> lh; have /and4P[_ _ /each_half_edgeP /(_ h lh) /andP[/and4P[/dart_of[x xd] + + +] _] _] := ok.
rewrite -xd => /same_linkP E /same_linkP O; case T: (twin t h) => [g|] // /eqP G; exists x; split=> //.
by exists g => //; rewrite G tw_val.
Qed.

Lemma vertex_starts v : vertex t v -> exists x : dart_type, dart_point r x = v /\
  forall b, isolated t v = Some b -> boundary_face t b = Some (dart_face r x).
Proof.
move=> lv; have /and4P[_ _ _ /each_vertexP /(_ v lv) /and3P[/dart_of[x xd] /eqP E I]] := ok.
exists x; rewrite xd; split=> // b B; rewrite B in I.
exact/same_linkP.
Qed.

(** Darts at one point start at the same vertex. *)
Lemma point_turn x : dart_point r (turn tw_dart nx_dart x) = dart_point r x.
Proof. by rewrite /turn -point_nx nx_three. Qed.

(** The edge of a half-edge, from the point of its origin to that of its target; a point is on it, and not at its ends,
    in the drawing [k] times as large. *)
Definition on_half_edge (k : Z) (p : point) h := exists u w, [/\ origin t h = Some u, target t h = Some w
  & strictly_between (scaled k (point_at r u)) (scaled k (point_at r w)) p].

Lemma on_half_edge_dart k p h x : half_edge t h -> val x = half_edge_dart r h -> on_half_edge k p h ->
  on_edge nx_dart (fun d => scaled k (pt d)) p x.
Proof.
move=> lh xd [u [w [O T on]]]; have [y [yd _ Oy [g Tg G]]] := half_edge_lies lh.
have E : y = x by apply: val_inj; rewrite yd xd.
rewrite E in Oy G; move: O; rewrite Oy => -[uE]; rewrite -uE in on *.
have lg : half_edge t g.
  by move: T; rewrite /target Tg /= /origin /heard; case: ifP.
have [z [zd _ Oz _]] := half_edge_lies lg.
have zx : z = tw_dart x by apply: val_inj; rewrite zd G.
move: T; rewrite /target Tg /= Oz => -[wE]; rewrite -wE in on *.
by rewrite /on_edge /pt /dart_at point_nx -zx.
Qed.

(** G4: two edges with a common point are the same edge. At all rational points [p / k]. *)
Theorem drawn_edges k p g h : (0 < k)%Z -> half_edge t g -> half_edge t h -> on_half_edge k p g -> on_half_edge k p h ->
  h = g \/ twin t g = Some h.
Proof.
move=> pos lg lh og oh; have [x [xd xg _ [g' Tg G]]] := half_edge_lies lg; have [y [yd yh _ _]] := half_edge_lies lh.
have [E|E] := edges_disjoint (scaled_triangulation pos is_triangulation) (on_half_edge_dart lg xd og) (on_half_edge_dart lh yd oh).
  by left; move: yh; rewrite E xg => -[].
right; rewrite Tg; have [g'' Tg' lg'] := twin_total map lg; move: Tg'; rewrite Tg => -[gg]; rewrite -gg in lg'.
have [z [zd zg _ _]] := half_edge_lies lg'.
by have zy : z = y; [apply: val_inj; rewrite zd G E|move: zg; rewrite zy yh => -[->]].
Qed.

(** G4, too: no vertex lies on an edge. *)
Theorem drawn_vertices_off k v h : (0 < k)%Z -> vertex t v -> half_edge t h -> ~ on_half_edge k (scaled k (point_at r v)) h.
Proof.
move=> pos lv lh on; have [x [xd _ _ _]] := half_edge_lies lh; have [y [yv _]] := vertex_starts lv.
have := on_half_edge_dart lh xd on; rewrite -yv.
exact: (@vertex_off_edges _ _ _ _ _ (scaled_triangulation pos is_triangulation) y x).
Qed.

(** G4, too: different vertices are at different points. *)
Theorem drawn_vertices u v : vertex t u -> vertex t v -> point_at r u = point_at r v -> u = v.
Proof.
move=> lu lv; have [x [<- _]] := vertex_starts lu; have [y [<- _]] := vertex_starts lv => E.
have /iter_findex <- : fconnect (turn tw_dart nx_dart) x y by apply/(one_rotation is_triangulation).
by elim: (findex _ _ _) => //= n ->; rewrite point_turn.
Qed.

(** G1: no edge has length zero. *)
Theorem drawn_length h u w : half_edge t h -> origin t h = Some u -> target t h = Some w -> point_at r u <> point_at r w.
Proof.
move=> lh O T E; have [x [xd _ Ox [g Tg G]]] := half_edge_lies lh.
have [g' Tg' lg] := twin_total map lh; move: Tg'; rewrite Tg => -[gg]; rewrite -gg in lg.
have [z [zd _ Oz _]] := half_edge_lies lg; have zx : z = tw_dart x by apply: val_inj; rewrite zd G.
move: T O; rewrite /target Tg /= Oz Ox zx => -[wE] [uE]; rewrite -wE -uE in E.
have := edge_nonzero is_triangulation x; rewrite /nonzero /edge /pt /dart_at point_nx -E /sub; cbn [fst snd]; lia.
Qed.

(** ** G2: around a vertex the half-edges are in the order of the darts

    Plane.v says that the darts are in angular order ([angular_order]); so are the half-edges, which lie on some of them:
    the next half-edge, counter-clockwise, lies on the next dart on which one lies. *)

Notation turned := (turn tw_dart nx_dart).

Lemma turned_val x : val (turned x) = turn_dart r x.
Proof. by rewrite /turn tw_val !nx_val. Qed.

Lemma ahead_found x n h : dart_half_edge r (iter n turned x) = Some h -> (forall m, m < n -> dart_half_edge r (iter m turned x) = None) ->
  dart_ahead r x = h.
Proof.
elim: n x => [|n IH] x; have /and5P[_ _ _ /eqP + _] := darts (ltn_ord x).
  by move=> -> /= ->.
move=> -> E none; rewrite (none 0) // -turned_val; apply: IH => [|m lt]; first by rewrite -iterSr.
by rewrite -iterSr; apply: none.
Qed.

Theorem drawn_rotation h g : half_edge t h -> prev t h >>= twin t = Some g -> exists (x : dart_type) n,
  [/\ val x = half_edge_dart r h, val (iter n.+1 turned x) = half_edge_dart r g
    & forall m, m < n -> dart_half_edge r (iter m.+1 turned x) = None].
Proof.
move=> lh G; have [x [xd xh _ _]] := half_edge_lies lh; have inj := turn_inj is_triangulation.
have /and4P[_ _ /each_half_edgeP /(_ h lh) /andP[_ /same_linkP]] := ok; rewrite G -xd -turned_val => -[A] _.
have [n some none] : exists2 n, ~~ added r (iter n.+1 turned x) & forall m, m < n -> added r (iter m.+1 turned x).
  have ex : exists n, ~~ added r (iter n.+1 turned x).
    by exists (order turned x).-1; rewrite prednK ?order_gt0 // iter_order // /added xh.
  case: (ex_minnP ex) => n some least; exists n => // m lt; apply: contraT => /least.
  by rewrite leqNgt lt.
exists x, n; split=> // [|m /none]; last by rewrite /added; case: (dart_half_edge r _).
move: some; rewrite /added; case E: (dart_half_edge r _) => [g'|] // _.
have gg : g = g'.
  rewrite A; apply: (ahead_found (n := n)); first by rewrite -iterSr.
  by move=> m /none; rewrite -iterSr /added; case: (dart_half_edge r _).
have /and5P[_ _ + _ _] := darts (ltn_ord (iter n.+1 turned x)).
by rewrite /dart_half_edge_ok E gg => /andP[_ /eqP].
Qed.

(** ** G5: the faces are the regions between the edges

    A region is made of triangles, joined across added edges: it is all that one reaches without crossing a half-edge's edge.
    The darts of a region have one face, those of different regions have different ones, and the face of the dart on which a
    half-edge lies is that of the half-edge. *)

Definition beside_dart : rel dart_type :=
  [rel x y | [|| y == nx_dart x, x == nx_dart y | [&& added r x, added r y & y == tw_dart x]]].
Definition same_region := connect beside_dart.

Lemma beside_sym : connect_sym beside_dart.
Proof.
apply: sym_connect_sym => x y; apply/or3P/or3P => -[/eqP->|/eqP->|/and3P[a b /eqP E]];
  try (by constructor 1); try (by constructor 2); by constructor 3; rewrite a b E tw_twice eqxx.
Qed.

Lemma beside_face x y : beside_dart x y -> dart_face r x = dart_face r y.
Proof.
have next_face z : dart_face r (nx_dart z) = dart_face r z.
  by have /and5P[_ _ _ _ /andP[/andP[/eqP E _] _]] := darts (ltn_ord z); rewrite nx_val.
case/or3P=> [/eqP->|/eqP->|/and3P[a _ /eqP->]]; [by rewrite next_face|exact: next_face|].
have /and5P[_ _ _ _ /andP[/andP[_ +] _]] := darts (ltn_ord x); rewrite tw_val; move: a; rewrite /added.
by case: (dart_half_edge r x) => // _ /eqP.
Qed.

Lemma region_root x : exists2 y, same_region x y & val y = face_dart r (dart_face r x).
Proof.
move: {2}(dart_rank r x).+1 (ltnSn (dart_rank r x)) => n; elim: n x => // n IH x lt.
have down y : beside_dart x y -> dart_rank r y < dart_rank r x -> exists2 z, same_region x z & val z = face_dart r (dart_face r x).
  move=> xy low; have [|z yz E] := IH y; first exact: leq_trans low lt.
  by exists z; [apply: connect_trans (connect1 xy) yz|rewrite E (beside_face xy)].
have /and5P[_ _ H _ /andP[_ /or3P[]]] := darts (ltn_ord x).
- by rewrite -nx_val; apply: down; rewrite /beside_dart /= eqxx.
- case/andP=> a; rewrite -tw_val; apply: down; apply/or3P/Or33; rewrite a eqxx andbT /=.
  by move: H a; rewrite /dart_half_edge_ok -tw_val /added; case: (dart_half_edge r x).
by move/eqP=> E; exists x; [apply: connect0|].
Qed.

Theorem drawn_faces x y : same_region x y <-> dart_face r x = dart_face r y.
Proof.
split=> [/connectP[s]|E].
  by elim: s x => [|z s IH] x /=; [move=> _ ->|case/andP=> /beside_face-> /IH].
have [z xz zE] := region_root x; have [w yw wE] := region_root y.
have zw : z = w by apply: val_inj; rewrite zE wE E.
by apply: connect_trans xz _; rewrite beside_sym zw.
Qed.

Theorem drawn_half_edge_face h : half_edge t h -> exists2 x : dart_type, val x = half_edge_dart r h
  & boundary_of t h >>= boundary_face t = Some (dart_face r x).
Proof.
move=> lh; have [x [xd xh _ _]] := half_edge_lies lh; exists x => //.
have /and5P[_ _ _ _ /andP[/andP[_ +] _]] := darts (ltn_ord x).
by rewrite xh => /same_linkP.
Qed.

(** An isolated vertex is in its face. *)
Theorem drawn_isolated_face v b : vertex t v -> isolated t v = Some b -> exists2 x : dart_type, dart_point r x = v
  & boundary_face t b = Some (dart_face r x).
Proof. by move=> lv B; have [x [xv H]] := vertex_starts lv; exists x => //; apply: H. Qed.

End Sound.
