(** * Plane: a triangulation is drawn in the plane without crossings

    What is said of points with integer coordinates is said of all rational ones: [p] divided by [k] is to the drawing as
    [p] is to the drawing scaled by [k], and a scaled triangulation is a triangulation.

    All follows from one fact: no point is in two triangles. To compare two things with a common point, we look from it in
    a direction that leads into a triangle of each; it is the same triangle. *)

From Coq Require Import ZArith Lia.
From mathcomp Require Import all_ssreflect.
From twinedge Require Import Orientation Triangulation.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Local Open Scope Z_scope.

(** ** Vectors *)

Definition quarter_turn (a : point) : point := (- a.2, a.1).
Definition nonzero (a : point) := a.1 <> 0 \/ a.2 <> 0.

Lemma nonzero_square a : nonzero a -> 0 < dot a a.
Proof. by rewrite /nonzero /dot; nia. Qed.

Lemma between_nonzero a b p : strictly_between a b p -> nonzero (sub b a).
Proof.
case=> _; rewrite /nonzero /dot /sub; cbn [fst snd] => lt.
case: (Z.eq_dec (b.1 - a.1) 0) => E; [right=> F|by left].
have E1 : b.1 = a.1 by lia.
have E2 : b.2 = a.2 by lia.
rewrite E1 E2 in lt; have := Z.square_nonneg (a.1 - p.1); have := Z.square_nonneg (a.2 - p.2); lia.
Qed.

(** Nearly in direction [b], a little towards [c], one looks along none of these vectors. *)
Lemma choose (es : seq point) b c : 0 < cross b c -> (forall e, List.In e es -> nonzero e) ->
  exists n, 0 < n /\ forall m, n <= m -> forall e, List.In e es -> cross e (plus (scaled m b) c) <> 0.
Proof.
move=> bc; elim: es => [|e es IH] nz; first by exists 1; split=> //; lia.
have [|n [n0 H]] := IH; first by move=> f fs; apply: nz; right.
exists (n + Z.abs (cross e c) + 1); split; first lia.
move=> m le f [<-|fs]; last by apply: H => //; lia.
have E : cross e (plus (scaled m b) c) = m * cross e b + cross e c.
  by rewrite /cross /plus /scaled; cbn [fst snd]; ring.
rewrite E; case: (Z.eq_dec (cross e b) 0) => eb; last by nia.
rewrite eb => zero; have ec : cross e c = 0 by lia.
have e1 : e.1 * cross b c = cross e c * b.1 - cross e b * c.1 by rewrite /cross; ring.
have e2 : e.2 * cross b c = cross e c * b.2 - cross e b * c.2 by rewrite /cross; ring.
case: (nz e (or_introl erefl)); rewrite eb ec in e1 e2; nia.
Qed.

(** On one side of a line, directions are in order. *)
Lemma cross_trans v a b c : 0 < cross a v -> 0 < cross b v -> 0 < cross c v -> 0 < cross a b -> 0 < cross b c -> 0 < cross a c.
Proof.
have E : cross a c * cross b v = cross a b * cross c v + cross b c * cross a v by rewrite /cross; ring.
move: E; move: (cross a c) (cross b v) (cross a b) (cross c v) (cross b c) (cross a v) => ? ? ? ? ? ?; nia.
Qed.

Section Plane.
Variables (dart : finType) (twin next : dart -> dart) (inner : pred dart) (pt : dart -> point).
Hypothesis ok : triangulation twin next inner pt.
Implicit Types (d e f o x y z : dart) (p v : point).

Definition edge d := sub (pt (next d)) (pt d).
Definition on_edge p d := strictly_between (pt d) (pt (next d)) p.

(** The dart before it around its origin, counter-clockwise the next one. *)
Definition turn d := twin (next (next d)).

Let n3 d : next (next (next d)) = d := next_thrice ok d.

Lemma pt_twin d : pt (twin d) = pt (next d). Proof. by rewrite (point_next ok). Qed.
Lemma pt_next_twin d : pt (next (twin d)) = pt d. Proof. by rewrite (point_next ok) (twin_back ok). Qed.
Lemma pt_turn d : pt (turn d) = pt d. Proof. by rewrite /turn pt_twin n3. Qed.
Lemma edge_turn d : edge (turn d) = sub (pt (next (next d))) (pt d).
Proof. by rewrite /edge pt_turn /turn pt_next_twin. Qed.

Lemma turn_inj : injective turn.
Proof.
move=> d e /(inv_inj (twin_back ok)) E.
by rewrite -(n3 d) -(n3 e) E.
Qed.

Lemma cross_edges d : cross (edge d) (edge (turn d)) = corners_turn next pt d.
Proof. by rewrite edge_turn /edge /corners_turn /orient /cross /sub; cbn [fst snd]; ring. Qed.

Lemma corners_nonzero d : corners_turn next pt d <> 0.
Proof.
case: (boolP (inner d)) => [/(inner_positive ok)|/(outer_negative ok)]; lia.
Qed.

Lemma edge_nonzero d : nonzero (edge d).
Proof.
case: (Z.eq_dec (edge d).1 0) => a; [right=> b|by left].
case: (@corners_nonzero d); rewrite -cross_edges /cross a b; lia.
Qed.

(** ** Looking from a point in a direction *)

(** A little from [p] in direction [v] is to the left of the dart. *)
Definition left p v d := 0 < orient (pt d) (pt (next d)) p \/ orient (pt d) (pt (next d)) p = 0 /\ 0 < cross (edge d) v.

(** A little from [p] in direction [v] is in the triangle. *)
Definition into p v d := left p v d /\ left p v (next d) /\ left p v (next (next d)).

Lemma left_near p v d n : left p v d -> Z.abs (cross (edge d) v) < n ->
  0 < orient (scaled n (pt d)) (scaled n (pt (next d))) (plus (scaled n p) v).
Proof.
rewrite orient_moved -/(edge d) /left; move: (orient (pt d) (pt (next d)) p) (cross (edge d) v) => s c.
by case=> [pos|[-> pos]] lt; nia.
Qed.

Definition far v d := 1 + Z.abs (cross (edge d) v) + Z.abs (cross (edge (next d)) v) + Z.abs (cross (edge (next (next d))) v).

Lemma far_positive v d : 0 < far v d. Proof. by rewrite /far; lia. Qed.

Lemma into_near p v d n : inner d -> into p v d -> far v d <= n ->
  covers next (fun d => scaled n (pt d)) (plus (scaled n p) v) d.
Proof.
rewrite /far => i [l1 [l2 l3]] le; have pos : 0 < n by lia.
have oks := scaled_triangulation pos ok.
apply: (covers_open oks) => //; try (apply: left_near => //; lia).
by have := left_near l3; rewrite n3; apply; lia.
Qed.

Lemma into_same p v d e : inner d -> inner e -> into p v d -> into p v e -> e \in [:: d; next d; next (next d)].
Proof.
move=> id ie pd pe; have fd := far_positive v d; have fe := far_positive v e.
have pos : 0 < far v d + far v e by lia.
have cd := @into_near p v d (far v d + far v e) id pd; have ce := @into_near p v e (far v d + far v e) ie pe.
by apply: (covered_once (scaled_triangulation pos ok) id ie); [apply: cd; lia|apply: ce; lia].
Qed.

Lemma into_within p v d o : inner d -> into p v d -> ~~ inner o -> ~ left p v o.
Proof.
move=> id pd io lo; have fd := far_positive v d; have fo := far_positive v o.
have pos : 0 < far v d + far v o by lia.
have cd := @into_near p v d (far v d + far v o) id pd.
have := covered_within (scaled_triangulation pos ok) id (cd _) io.
have lt : Z.abs (cross (edge o) v) < far v d + far v o by rewrite {2}/far; lia.
have := left_near lo lt; move=> near H; have := H _; lia.
Qed.

(** ** Edges *)

Lemma on_twin p d : on_edge p d -> on_edge p (twin d).
Proof.
rewrite /on_edge pt_next_twin pt_twin => -[o b]; split; first by rewrite orient_swap o.
by move: b; rewrite /dot; lia.
Qed.

Lemma edge_twin d : edge (twin d) = scaled (- 1) (edge d).
Proof. by rewrite /edge pt_next_twin pt_twin /sub /scaled; cbn [fst snd]; congr pair; ring. Qed.

(** From a point on an edge one looks to one of its sides. *)
Lemma edge_side p v e : on_edge p e -> cross (edge e) v <> 0 ->
  exists f, [/\ f = e \/ f = twin e, on_edge p f & left p v f].
Proof.
move=> on nz; case: (Z_lt_le_dec 0 (cross (edge e) v)) => s.
  by exists e; split=> //; [left|right; split=> //; case: on].
exists (twin e); split; [by right|exact: on_twin|right].
split; first by case: (on_twin on).
have -> : cross (edge (twin e)) v = - cross (edge e) v by rewrite edge_twin /cross /scaled; cbn [fst snd]; ring.
lia.
Qed.

Lemma edge_inner p e : on_edge p e -> exists f, [/\ f = e \/ f = twin e, on_edge p f & inner f].
Proof.
move=> on; case: (boolP (inner e)) => i; first by exists e; split=> //; left.
by exists (twin e); split; [right|apply: on_twin|apply: outer_twin ok _ i].
Qed.

(** A point on a side of a positive triangle is to the left of the other two. *)
Lemma on_edge_left p d : inner d -> on_edge p d ->
  0 < orient (pt (next d)) (pt (next (next d))) p /\ 0 < orient (pt (next (next d))) (pt d) p.
Proof.
move=> /(inner_positive ok); rewrite /corners_turn /on_edge /strictly_between.
move: (pt d) (pt (next d)) (pt (next (next d))) => a b c pos [zero neg].
set v := orient b c p; set w := orient c a p.
have total : 0 < v + w.
  suff -> : v + w = orient a b c - orient a b p by lia.
  by rewrite /v /w /orient /cross /sub; cbn [fst snd]; ring.
have ea : v * dot (sub a p) (sub a p) + w * dot (sub a p) (sub b p) + orient a b p * dot (sub a p) (sub c p) = 0.
  by rewrite /v /w /orient /cross /dot /sub; cbn [fst snd]; ring.
have eb : v * dot (sub a p) (sub b p) + w * dot (sub b p) (sub b p) + orient a b p * dot (sub b p) (sub c p) = 0.
  by rewrite /v /w /orient /cross /dot /sub; cbn [fst snd]; ring.
have pa : 0 < dot (sub a p) (sub a p).
  by apply: nonzero_square; move: neg; rewrite /nonzero /dot; nia.
have pb : 0 < dot (sub b p) (sub b p).
  by apply: nonzero_square; move: neg; rewrite /nonzero /dot; nia.
rewrite zero in ea eb; clear zero pos.
move: v w total (dot (sub a p) (sub a p)) (dot (sub b p) (sub b p)) (dot (sub a p) (sub b p)) ea eb pa pb neg.
move=> v w total aa bb ab ea eb pa pb neg; nia.
Qed.

(** The face into which one looks from a point on an edge has that edge as a side. *)
Lemma into_edge p v d e : inner d -> into p v d -> on_edge p e -> cross (edge e) v <> 0 ->
  exists f, [/\ f = e \/ f = twin e, on_edge p f & f \in [:: d; next d; next (next d)]].
Proof.
move=> id pd on nz; have [f [ef onf lf]] := edge_side on nz; exists f; split=> //.
case: (boolP (inner f)) => fi; last by case: (into_within id pd fi).
apply: (into_same id fi pd); have [l1 l2] := on_edge_left fi onf; split=> //; split; left=> //.
by rewrite n3.
Qed.

(** Two edges with a common point are the same edge. *)
Theorem edges_disjoint p d e : on_edge p d -> on_edge p e -> e = d \/ e = twin d.
Proof.
move=> od oe; have [d' [dd od' id]] := edge_inner od.
have turned : 0 < cross (edge d') (quarter_turn (edge d')).
  have := nonzero_square (edge_nonzero d'); rewrite /dot /cross /quarter_turn; cbn [fst snd]; lia.
have [u [<-|//]|n [n0 H]] := @choose [:: edge e] _ _ turned; first exact: edge_nonzero.
set v := plus (scaled n (edge d')) (quarter_turn (edge d')).
have nz : cross (edge e) v <> 0 by apply: H; [lia|left].
have [l1 l2] := on_edge_left id od'.
have pd : into p v d'.
  split; last by split; left=> //; rewrite n3.
  right; split; first by case: od'.
  suff -> : cross (edge d') v = cross (edge d') (quarter_turn (edge d')) by [].
  by rewrite /v /cross /plus /scaled; cbn [fst snd]; ring.
have [f [ef [onf _]]] := into_edge id pd oe nz; rewrite !inE => /or3P[] /eqP fd.
- move: ef; rewrite fd; case: dd => -> [E|E].
  + by left.
  + by right; rewrite E (twin_back ok).
  + by right.
  by left; apply: (inv_inj (twin_back ok)).
- by move: onf; rewrite fd; lia.
by move: onf; rewrite fd n3; lia.
Qed.

(** ** Corners *)

(** Looking from a corner into its triangle. *)
Lemma corner_into x v : inner x -> 0 < cross (edge x) v -> 0 < cross v (edge (turn x)) -> into (pt x) v x.
Proof.
move=> i l r; have pos := inner_positive ok i; split; [right|split; [left|right]].
- by split=> //; rewrite /orient /cross /sub; cbn [fst snd]; ring.
- by move: pos; rewrite /corners_turn -orient_turn.
rewrite n3; split; first by rewrite /orient /cross /sub; cbn [fst snd]; ring.
suff -> : cross (edge (next (next x))) v = cross v (edge (turn x)) by [].
by rewrite edge_turn /edge n3 /cross /sub; cbn [fst snd]; ring.
Qed.

(** Nearly along a dart, a little to the left. *)
Definition beside m x := plus (scaled m (edge x)) (edge (turn x)).

Lemma beside_into m x : 0 < m -> inner x -> into (pt x) (beside m x) x.
Proof.
move=> m0 i; have := inner_positive ok i; rewrite -cross_edges => pos; apply: corner_into => //.
  suff -> : cross (edge x) (beside m x) = cross (edge x) (edge (turn x)) by [].
  by rewrite /beside /cross /plus /scaled; cbn [fst snd]; ring.
suff -> : cross (beside m x) (edge (turn x)) = m * cross (edge x) (edge (turn x)) by nia.
by rewrite /beside /cross /plus /scaled; cbn [fst snd]; ring.
Qed.

(** One of these directions is along no dart. *)
Lemma beside_free x : inner x -> exists n, 0 < n /\ forall m, n <= m -> forall d, cross (edge d) (beside m x) <> 0.
Proof.
move=> i; have := inner_positive ok i; rewrite -cross_edges => pos.
have [e|n [n0 H]] := @choose [seq edge d | d <- enum dart] _ _ pos.
  by move=> /List.in_map_iff[d [<- _]]; apply: edge_nonzero.
exists n; split=> // m le d; apply: H => //; apply/List.in_map_iff; exists d; split=> //.
have : d \in enum dart by rewrite mem_enum.
elim: (enum dart) => //= y s IH; rewrite inE => /orP[/eqP->|/IH]; by [left|right].
Qed.

(** A dart that is inner starts there, too. *)
Lemma inner_corner x : exists y, [/\ inner y, pt y = pt x & y = x \/ y = turn x].
Proof.
case: (boolP (inner x)) => i; first by exists x; split=> //; left.
exists (turn x); split; [|exact: pt_turn|by right].
by apply: (outer_twin ok); rewrite !(inner_next ok).
Qed.

Lemma corner_off_sides x : inner x -> orient (pt (next x)) (pt (next (next x))) (pt x) <> 0 /\
  pt (next x) <> pt x /\ pt (next (next x)) <> pt x.
Proof.
move=> /(inner_positive ok); rewrite /corners_turn => pos; split; first by rewrite -orient_turn in pos; lia.
by split=> E; rewrite E /orient /cross /sub in pos; cbn [fst snd] in pos; lia.
Qed.

(** No vertex lies on an edge. *)
Theorem vertex_off_edges x e : ~ on_edge (pt x) e.
Proof.
have [y [i <- _]] := inner_corner x => on; have [n [n0 free]] := beside_free i.
have [f [_ onf]] := into_edge i (beside_into n0 i) on (free n (Z.le_refl n) e).
have [o _] := corner_off_sides i; case: onf => zero neg.
rewrite !inE => /or3P[] /eqP E; rewrite E ?n3 in zero neg => //.
  by move: neg; rewrite /dot /sub; cbn [fst snd]; lia.
by move: neg; rewrite /dot /sub; cbn [fst snd]; lia.
Qed.

(** ** Around a vertex *)

Let ahead v d : bool := 0 <? cross (edge d) v.

(** The triangles around a vertex cover every direction that is along no dart, and not outside. *)
Lemma corner_found v x : (forall d, cross (edge d) v <> 0) ->
  (forall o, ~~ inner o -> pt o = pt x -> cross (edge o) v < 0 /\ 0 < cross (edge (turn o)) v) ->
  exists2 z, fconnect turn x z & inner z /\ into (pt x) v z.
Proof.
move=> free out; have sym := fconnect_sym turn_inj.
have orbit z : fconnect turn x z -> pt z = pt x by move/iter_findex <-; elim: (findex _ _ _) => //= k <-; rewrite pt_turn.
case: (pickP (fun z => [&& fconnect turn x z, inner z, ahead v z & ~~ ahead v (turn z)])) => [z /and4P[xz i a b]|none].
  exists z => //; split=> //; rewrite -(orbit z xz); apply: corner_into => //; first by apply/Z.ltb_lt.
  have := free (turn z); move/negbTE/Z.ltb_ge: b.
  suff -> : cross v (edge (turn z)) = - cross (edge (turn z)) v by lia.
  by rewrite /cross; ring.
have onward z : fconnect turn x z -> inner z -> ahead v z -> ahead v (turn z).
  by move=> xz i a; have := none z; rewrite xz i a /= => /negbT; rewrite negbK.
(* Outside darts of the orbit look away, and what follows them looks ahead: so all look ahead. *)
have all z k : fconnect turn x z -> ahead v z -> ahead v (iter k turn z).
  move=> xz a; elim: k => //= k IH; set w := iter k turn z in IH *.
  have xw : fconnect turn x w by apply: connect_trans xz (fconnect_iter _ _ _).
  case: (boolP (inner w)) => i; first exact: onward.
  by have [neg _] := out w i (orbit w xw); move/Z.ltb_lt: IH; lia.
have const z w : fconnect turn x z -> fconnect turn x w -> ahead v z -> ahead v w.
  move=> xz xw a; have zw : fconnect turn z w by apply: connect_trans xw; rewrite sym.
  by rewrite -(iter_findex zw); apply: all.
have [i|o] := boolP [forall z, fconnect turn x z ==> inner z]; last first.
  case/forallPn: o => o; rewrite negb_imply => /andP[xo io]; have [neg pos] := out o io (orbit o xo).
  have xt : fconnect turn x (turn o) by apply: connect_trans xo (fconnect1 _ _).
  by have := const _ _ xt xo; rewrite /ahead (proj2 (Z.ltb_lt _ _) pos) => /(_ isT)/Z.ltb_lt; lia.
(* All look to one side: then they turn on and on, and do not come back. *)
have [s [s1 side]] : exists s, (s = 1 \/ s = - 1) /\ forall z, fconnect turn x z -> 0 < cross (edge z) (scaled s v).
  have sE s z : cross (edge z) (scaled s v) = s * cross (edge z) v by rewrite /cross /scaled; cbn [fst snd]; ring.
  case a: (ahead v x).
    exists 1; split=> [|z xz]; [by left|rewrite sE].
    by move/Z.ltb_lt: (const x z (connect0 _ _) xz a); lia.
  exists (- 1); split=> [|z xz]; [by right|rewrite sE].
  have : ~~ ahead v z by apply/negP=> /(const z x xz (connect0 _ _)); rewrite a.
  by move/negbTE/Z.ltb_ge; have := free z; lia.
have turns k : 0 < cross (edge x) (edge (iter k.+1 turn x)).
  elim: k => [|k IH].
    by rewrite /= cross_edges; apply: (inner_positive ok); move/forallP: i => /(_ x); rewrite connect0.
  have xk := fconnect_iter turn k.+1 x; move: xk IH; rewrite [iter k.+2 _ _]iterS; set w := iter k.+1 turn x => xk IH.
  have xt : fconnect turn x (turn w) by apply: connect_trans xk (fconnect1 _ _).
  have step : 0 < cross (edge w) (edge (turn w)).
    by rewrite cross_edges; apply: (inner_positive ok); move/forallP: i => /(_ w)/implyP; apply.
  exact: cross_trans (side x (connect0 _ _)) (side w xk) (side _ xt) IH step.
have := turns (order turn x).-1; rewrite prednK ?order_gt0 // iter_order; last exact: turn_inj.
by rewrite /cross; lia.
Qed.

(** Two darts start at one point exactly if they are of one rotation. *)
Theorem one_rotation x y : pt x = pt y <-> fconnect turn x y.
Proof.
split=> [xy|/iter_findex <-]; last by elim: (findex _ _ _) => //= k ->; rewrite pt_turn.
have [y' [i y'y yy]] := inner_corner y.
suff xy' : fconnect turn x y'.
  case: yy => E; first by rewrite -E.
  by apply: connect_trans xy' _; rewrite (fconnect_sym turn_inj) E; apply: fconnect1.
have [n [n0 free']] := beside_free i; have free := free' n (Z.le_refl n); have into_y := beside_into n0 i.
have [z xz [iz into_z]] : exists2 z, fconnect turn x z & inner z /\ into (pt x) (beside n y') z.
  apply: corner_found => // o io ox.
  have off l : ~~ inner l -> orient (pt l) (pt (next l)) (pt y') = 0 -> cross (edge l) (beside n y') < 0.
    move=> il zero; have := free l; have := into_within i into_y il; rewrite /left zero => H H'.
    by case: (Z_lt_le_dec 0 (cross (edge l) (beside n y'))) => ?; [case: H; right|lia].
  split; first by apply: off => //; rewrite y'y -xy -ox /orient /cross /sub; cbn [fst snd]; ring.
  have il : ~~ inner (next (next o)) by rewrite !(inner_next ok).
  have : cross (edge (next (next o))) (beside n y') < 0.
    by apply: off => //; rewrite n3 y'y -xy -ox /orient /cross /sub; cbn [fst snd]; ring.
  suff -> : cross (edge (turn o)) (beside n y') = - cross (edge (next (next o))) (beside n y') by lia.
  by rewrite edge_turn /edge n3 /cross /sub; cbn [fst snd]; ring.
rewrite xy -y'y in into_z; have := into_same i iz into_y into_z.
have pz : pt z = pt y' by rewrite y'y -xy -(iter_findex xz); elim: (findex _ _ _) => //= k IH; rewrite pt_turn.
have [_ [n1 n2]] := corner_off_sides i.
by rewrite !inE => /or3P[] /eqP E; rewrite E in pz xz; [exact: xz|case: n1|case: n2].
Qed.

(** Around a vertex the darts are in angular order: no dart leads into the corner between one and the next. *)
Theorem angular_order x y : inner x -> pt x = pt y ->
  ~ (0 < cross (edge x) (edge y) /\ 0 < cross (edge y) (edge (turn x))).
Proof.
move=> i xy [l r].
have into_x c m : 0 < m -> Z.abs (cross (edge x) c) < m -> Z.abs (cross c (edge (turn x))) < m ->
    into (pt x) (plus (scaled m (edge y)) c) x.
  move=> m0 a b; apply: corner_into => //.
    suff -> : cross (edge x) (plus (scaled m (edge y)) c) = m * cross (edge x) (edge y) + cross (edge x) c by nia.
    by rewrite /cross /plus /scaled; cbn [fst snd]; ring.
  suff -> : cross (plus (scaled m (edge y)) c) (edge (turn x)) = m * cross (edge y) (edge (turn x)) + cross c (edge (turn x)) by nia.
  by rewrite /cross /plus /scaled; cbn [fst snd]; ring.
case: (boolP (inner y)) => iy.
  set c := edge (turn y); set m := 1 + Z.abs (cross (edge x) c) + Z.abs (cross c (edge (turn x))).
  have m0 : 0 < m by rewrite /m; lia.
  have px : into (pt x) (beside m y) x by apply: (into_x c); rewrite /m; lia.
  have py := beside_into m0 iy; rewrite -xy in py.
  have := into_same i iy px py; have [_ [n1 n2]] := corner_off_sides i.
  rewrite !inE => /or3P[] /eqP E; rewrite E in xy l; [|by case: n1|by case: n2].
  by move: l; rewrite /cross; lia.
set c := quarter_turn (edge y); set m := 1 + Z.abs (cross (edge x) c) + Z.abs (cross c (edge (turn x))).
have px : into (pt x) (plus (scaled m (edge y)) c) x by apply: (into_x c); rewrite /m; lia.
apply: (into_within i px iy); right; split; first by rewrite xy /orient /cross /sub; cbn [fst snd]; ring.
have := nonzero_square (edge_nonzero y).
suff -> : cross (edge y) (plus (scaled m (edge y)) c) = dot (edge y) (edge y) by [].
by rewrite /c /quarter_turn /dot /cross /plus /scaled; cbn [fst snd]; ring.
Qed.

(** ** Points and triangles *)

Definition in_triangle p d := 0 < orient (pt d) (pt (next d)) p /\
  0 < orient (pt (next d)) (pt (next (next d))) p /\ 0 < orient (pt (next (next d))) (pt d) p.

Definition in_closed_triangle p d := 0 <= orient (pt d) (pt (next d)) p /\
  0 <= orient (pt (next d)) (pt (next (next d))) p /\ 0 <= orient (pt (next (next d))) (pt d) p.

(** The point is strictly inside the outer triangle, which runs clockwise. *)
Definition in_outer p := forall o, ~~ inner o -> orient (pt o) (pt (next o)) p < 0.

Lemma in_triangle_covers p d : inner d -> in_triangle p d -> covers next pt p d.
Proof. by move=> i [u [v w]]; have := covers_open ok i u v w. Qed.

Theorem triangles_disjoint p d e : inner d -> inner e -> in_triangle p d -> in_triangle p e ->
  e \in [:: d; next d; next (next d)].
Proof.
move=> id ie pd pe; have cd := in_triangle_covers id pd; have ce := in_triangle_covers ie pe.
by have := covered_once ok id ie cd ce.
Qed.

Theorem triangles_cover p o : ~~ inner o -> in_outer p -> exists2 d, inner d & in_closed_triangle p d.
Proof.
move=> io out; have io1 : ~~ inner (next o) by rewrite (inner_next ok).
have io2 : ~~ inner (next (next o)) by rewrite !(inner_next ok).
have co : covers next pt p o.
  have o0 := out o io; have o1 := out _ io1; have := out _ io2; rewrite n3 => o2.
  by have := outer_open ok io o0 o1 o2.
have [d i c] := covered_inside ok io co; exists d => //.
have i1 : inner (next d) by rewrite (inner_next ok).
have i2 : inner (next (next d)) by rewrite (inner_next ok).
have c1 : covers next pt p (next d) by rewrite (covers_next ok).
have c2 : covers next pt p (next (next d)) by rewrite (covers_next ok).
have := covers_closed ok i2 c2; rewrite n3 => l2.
by split; [by have := covers_closed ok i c|split=> //; have := covers_closed ok i1 c1].
Qed.

Theorem triangles_within p d o : inner d -> in_triangle p d -> ~~ inner o -> orient (pt o) (pt (next o)) p <= 0.
Proof. by move=> i pd io; have c := in_triangle_covers i pd; have := covered_within ok i c io. Qed.

End Plane.

(** ** The theorem

    At all rational points: [p / k] for a point [p] of integers and [k > 0]. *)

Theorem triangulation_is_plane (dart : finType) (twin next : dart -> dart) (inner : pred dart) (pt : dart -> point) :
  triangulation twin next inner pt -> forall k, 0 < k -> let at_scale d := scaled k (pt d) in
  [/\ (* no two open edges have a common point, and no vertex lies on an open edge; *)
      forall p d e, on_edge next at_scale p d -> on_edge next at_scale p e -> e = d \/ e = twin d,
      forall x e, ~ on_edge next at_scale (at_scale x) e,
      (* no two vertices are at one point; *)
      forall x y, at_scale x = at_scale y <-> fconnect (turn twin next) x y,
      (* no two open triangles have a common point, *)
      forall p d e, inner d -> inner e -> in_triangle next at_scale p d -> in_triangle next at_scale p e ->
        e \in [:: d; next d; next (next d)]
    & (* and the triangles are all that is inside the outer one. *)
      forall p o, ~~ inner o -> (in_outer next inner at_scale p -> exists2 d, inner d & in_closed_triangle next at_scale p d) /\
        (forall d, inner d -> in_triangle next at_scale p d -> orient (at_scale o) (at_scale (next o)) p <= 0)].
Proof.
move=> ok k pos at_scale; have oks := scaled_triangulation pos ok; split.
- exact: edges_disjoint oks.
- exact: vertex_off_edges oks.
- exact: one_rotation oks.
- exact: triangles_disjoint oks.
move=> p o io; split=> [out|d i pd]; first by have := triangles_cover oks io out.
by have := triangles_within oks i pd io.
Qed.
