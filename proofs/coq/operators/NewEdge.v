(** * NewEdge: a new vertex at the end of a new edge

    A new vertex [v] is given an edge: its half-edges are [h], from a vertex [o] to [v], and [k], back. Whatever is connected to
    [v] is what is connected to [o], and so T1 to T3 hold (ConnectIsolated.v). What is said of half-edges serves every operator
    that makes an edge.

<<
      o ·   v       o ·─────· v       h: from o, twin k
                       h   k          k: from v, twin h
>>
*)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import Arith View Rules Map Counting Lists Genus WholeEuler.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** One live slot more, and two. *)
Lemma one_more n (live : nat -> bool) v i : (forall j, live j -> j < n) ->
  (i < maxn n v.+1) && ((i == v) || live i) = (i == v) || live i.
Proof.
move=> below; rewrite leq_max ltnS; case: eqP => [->|_] /=; first by rewrite leqnn orbT.
by case: (boolP (live i)) => [/below->|_]; rewrite ?andbF.
Qed.

Lemma two_more n (live : nat -> bool) h k i : (forall j, live j -> j < n) ->
  (i < maxn n (maxn h.+1 k.+1)) && [|| i == h, i == k | live i] = [|| i == h, i == k | live i].
Proof.
move=> below; rewrite !leq_max !ltnS; case: eqP => [->|_] /=; first by rewrite leqnn !orbT.
case: eqP => [->|_] /=; first by rewrite leqnn !orbT.
by case: (boolP (live i)) => [/below->|_]; rewrite ?andbF.
Qed.

(** A half-edge begins where the one before it around its vertex does, and so does all on its rotation. *)
Lemma on_rotation_origin t g x : l1_twin t -> l3_target t -> on_orbit (turn t) g x -> origin t x = origin t g.
Proof.
move=> L1 L3 [n]; elim: n x => [|n IH] x /=; first by case=> <-.
case E: (iter n _ _) => [y|] //= Y; rewrite -(IH y E); move: Y; rewrite /turn; case T: (twin t y) => [z|] //= N.
have := L3 z (heard_live N); rewrite N /= => ->; have [] := L1 y (heard_live T).
by rewrite T /= => ->.
Qed.

Lemma orbit_refl f x : on_orbit f x x. Proof. by exists 0. Qed.

Lemma orbit_step f x y z : on_orbit f x y -> f y = Some z -> on_orbit f x z.
Proof. by case=> n E F; exists n.+1; rewrite /= E. Qed.

(** A property that each step keeps holds on the whole orbit. *)
Lemma orbit_ind (P : nat -> Prop) f x y : P x -> (forall u w, P u -> f u = Some w -> P w) -> on_orbit f x y -> P y.
Proof.
move=> Px keep [n]; elim: n y => [|n IH] y /=; first by case=> <-.
by case E: (iter n _ _) => [u|] //= /keep; apply; apply: IH E.
Qed.

(** If each step of one leads along the other, orbits do. *)
Lemma orbit_sub (f f' : nat -> link) x y : (forall u w z, f u = Some w -> on_orbit f' z u -> on_orbit f' z w) ->
  on_orbit f x y -> on_orbit f' x y.
Proof.
move=> sub [n]; elim: n y => [|n IH] y /=; first by case=> <-; apply: orbit_refl.
by case E: (iter n _ _) => [u|] //= U; apply: sub U _; apply: IH.
Qed.

(** Along [next] all is live. *)
Lemma orbit_live t e i : rules t -> half_edge t e -> on_cycle t e i -> half_edge t i.
Proof.
move=> keeps le [m]; elim: m i => [|m IH] i /=; first by case=> <-.
case E: (iter m _ _) => [u|] //= N; have [[H _ _ _] _] := keeps R1; have [_ _ [j + lj] _ _] := H u (IH u E).
by rewrite N => -[->].
Qed.

(** ** A new vertex hangs at another one: T1 to T3

    What is connected to the new vertex [v] is what is connected to [o], and boundary components start where they did, or
    at [v] where they started at [o]. *)

(** The vertex on which [v] hangs is [o]. *)
Definition hangs (v o u : nat) := if u == v then o else u.

Section Hanging.
Variables (t t' : view) (v o h : nat).
Hypothesis keeps : rules t.
Hypothesis free_vertex : ~~ vertex t v.
Hypothesis live_o : vertex t o.
Hypothesis vertexE : forall i, vertex t' i = (i == v) || vertex t i.
Hypothesis face_same : forall f, face t' f = face t f.
Hypothesis outer_same : forall f, outer t' f = outer t f.
Hypothesis boundary_face_same : forall c, boundary_face t' c = boundary_face t c.
Hypothesis inner_same : forall c, is_inner t' c <-> is_inner t c.
Hypothesis connectedE : forall u w, connected t' u w <-> connected t (hangs v o u) (hangs v o w).
Hypothesis vertex_atE : forall c w, vertex_at t c = Some w <-> exists2 w', vertex_at t' c = Some w' & hangs v o w' = w.

Lemma hangs_live u : vertex t' u -> vertex t (hangs v o u).
Proof. by rewrite vertexE /hangs; case: (u =P v) => // _ _; apply: live_o. Qed.

Lemma outsideE u c : outside_of t' u c <-> outside_of t (hangs v o u) c.
Proof.
split=> -[/inner_same I [w W C]]; split=> //.
  by exists (hangs v o w); [apply/vertex_atE; exists w|apply/connectedE].
by have [w' W' ww] := (vertex_atE c w).1 W; exists w' => //; apply/connectedE; rewrite ww.
Qed.

Lemma hanging_t1 : t1_outside t'.
Proof.
move=> u lu; have [c [O one]] := keeps T1 _ (hangs_live lu); exists c; split; first exact/outsideE.
by move=> d /outsideE; apply: one.
Qed.

Lemma rooted_up f : rooted t f -> rooted t' f.
Proof.
elim=> [g U|g c w d g' E W O D _ IH]; first by apply: rooted_here; rewrite /unbounded face_same outer_same.
have [w' W' ww] := (vertex_atE c w).1 W.
apply: (@rooted_out t' g c w' d g') => //; rewrite ?outer_same ?boundary_face_same //.
by apply/outsideE; rewrite ww.
Qed.

Lemma hanging_t2 : t2_nesting t'.
Proof.
move=> u c f lu /outsideE O; rewrite boundary_face_same => E; apply: rooted_up.
exact: (keeps T2 _ c f (hangs_live lu) O E).
Qed.

(** One vertex and one edge more. *)
Lemma hanging_t3 : lower t' -> (forall es, lists_one_of_each es (same_edge t) (half_edge t) ->
  lists_one_of_each (h :: es) (same_edge t') (half_edge t')) -> t3_euler t'.
Proof.
move=> low' edge_more; have low : lower t by move=> q _; apply: keeps.
have [es He] := edges_each low; have [uv inv] := lists_filter (@vertex_below t) (fun u => iff_refl (vertex t u)).
have Hv' : lists (v :: [seq u <- iota 0 (vertex_slots t) | vertex t u]) (vertex t').
  split=> [|u]; first by rewrite /= uv andbT; apply/negP=> /inv; rewrite (negPf free_vertex).
  by rewrite inE vertexE; case: (u == v) => //=; apply: inv.
have Hf := lists_filter (@face_below t) (fun f => iff_refl (face t f)).
have Hf' : lists [seq f <- iota 0 (face_slots t) | face t f] (face t') by apply: lists_iff Hf => f; rewrite face_same.
have Hb : lists (inner_ones t) (is_inner t).
  by split=> [|c]; [rewrite !filter_uniq ?iota_uniq|apply: (inner_onesP low)].
have Hb' : lists (inner_ones t) (is_inner t') by apply: lists_iff Hb => c; apply: iff_sym.
have eq := (t3_counts low (keeps T1) (conj uv inv) He Hf Hb).1 (keeps T3).
by apply/(t3_counts low' hanging_t1 Hv' (edge_more es He) Hf' Hb'); move: eq => /=; arith.
Qed.

End Hanging.

(** ** Two views, one with the new edge *)

Section NewEdge.
Variables (t t' : view) (v h k o : nat).
Hypothesis keeps : rules t.
Hypothesis free_vertex : ~~ vertex t v.
Hypothesis free_h : ~~ half_edge t h.
Hypothesis free_k : ~~ half_edge t k.
Hypothesis hk : h != k.
Hypothesis live_o : vertex t o.

Hypothesis vertexE : forall i, vertex t' i = (i == v) || vertex t i.
Hypothesis half_edgeE : forall i, half_edge t' i = [|| i == h, i == k | half_edge t i].
Hypothesis originE : forall i, origin t' i = if i == h then Some o else if i == k then Some v else origin t i.
Hypothesis twinE : forall i, twin t' i = if i == h then Some k else if i == k then Some h else twin t i.
Hypothesis face_same : forall f, face t' f = face t f.
Hypothesis outer_same : forall f, outer t' f = outer t f.
Hypothesis boundary_face_same : forall c, boundary_face t' c = boundary_face t c.
Hypothesis inner_same : forall c, is_inner t' c <-> is_inner t c.
Hypothesis vertex_atE : forall c, vertex_at t' c = vertex_at t c.

Lemma k_not_h : (k == h) = false. Proof. by rewrite eq_sym (negPf hk). Qed.

Lemma old_h i : half_edge t i -> i == h = false.
Proof. by move=> l; apply/eqP=> E; rewrite E (negPf free_h) in l. Qed.
Lemma old_k i : half_edge t i -> i == k = false.
Proof. by move=> l; apply/eqP=> E; rewrite E (negPf free_k) in l. Qed.
Lemma old_v i : vertex t i -> i == v = false.
Proof. by move=> l; apply/eqP=> E; rewrite E (negPf free_vertex) in l. Qed.
Lemma up_half_edge i : half_edge t i -> half_edge t' i. Proof. by rewrite half_edgeE => ->; rewrite !orbT. Qed.
Lemma up_vertex i : vertex t i -> vertex t' i. Proof. by rewrite vertexE orbC => ->. Qed.

Lemma links_of i : half_edge t i -> [/\ exists2 u, origin t i = Some u & vertex t u,
  exists2 g, twin t i = Some g & half_edge t g, exists2 g, next t i = Some g & half_edge t g,
  exists2 g, prev t i = Some g & half_edge t g & exists2 c, boundary_of t i = Some c & boundary t c].
Proof. by have [[H _ _ _] _] := keeps R1; apply: H. Qed.

Definition newE := (eqxx, k_not_h, negPf hk).

Variant half_edge_is : nat -> Prop :=
  | IsH : half_edge_is h
  | IsK : half_edge_is k
  | IsOld i of half_edge t i & i == h = false & i == k = false : half_edge_is i.

Lemma half_edgeP i : half_edge t' i -> half_edge_is i.
Proof.
by rewrite half_edgeE => /or3P[/eqP->|/eqP->|l]; [exact: IsH|exact: IsK|apply: IsOld; rewrite ?old_h ?old_k].
Qed.

Lemma bare_old u : vertex t u -> u <> o -> bare t' u <-> bare t u.
Proof.
move=> lu uo; split=> [B i li|B i /half_edgeP[||{}i li ih ik]].
- by move=> E; apply: (B i (up_half_edge li)); rewrite originE old_h ?old_k.
- by rewrite originE eqxx => -[/esym].
- by rewrite originE !newE => -[vu]; move: lu; rewrite -vu (negPf free_vertex).
by rewrite originE ih ik; apply: B.
Qed.

Lemma new_l1 : l1_twin t'.
Proof.
move=> i /half_edgeP[||{}i li ih ik]; rewrite twinE ?newE.
- by rewrite /= twinE !newE; split=> // -[/eqP]; rewrite newE.
- by rewrite /= twinE !newE; split=> // -[/eqP]; rewrite newE.
rewrite ih ik; have [E D] := keeps L1 i li; split=> //.
by have [_ [g G lg] _ _ _] := links_of li; rewrite G /= in E *; rewrite twinE old_h ?old_k.
Qed.

Lemma start_live c g : boundary_start t c = Some (AtHalfEdge g) -> half_edge t g.
Proof. by move=> S; have [[_ _ B _] _] := keeps R1; have [_] := B c (heard_live S); rewrite S. Qed.

Lemma start_vertex c u : boundary_start t c = Some (AtVertex u) -> vertex t u.
Proof. by move=> S; have [[_ _ B _] _] := keeps R1; have [_] := B c (heard_live S); rewrite S. Qed.

(** ** What is connected *)

Notation hangs := (hangs v o).

Lemma hangs_old u : vertex t u -> hangs u = u. Proof. by move=> l; rewrite /hangs old_v. Qed.

Lemma connected_down u w : connected t' u w -> connected t (hangs u) (hangs w).
Proof.
elim=> [|i x y _ IH]; first exact: connected_self.
rewrite originE /target twinE; case: (i =P h) => [_|_] /=.
  by rewrite originE !newE => -[xo] [<-]; move: IH; rewrite -xo (hangs_old live_o) /hangs eqxx.
case: (i =P k) => [_|_] /=.
  by rewrite originE eqxx => -[xv] [<-]; move: IH; rewrite -xv (hangs_old live_o) /hangs eqxx.
move=> X; have li := heard_live X; have [[x' X' lx] [g G lg] _ _ _] := links_of li.
have [[y' Y ly] _ _ _ _] := links_of lg; rewrite G /= originE old_h ?old_k // => Y'.
have xx : x' = x by move: X; rewrite X' => -[].
have yy : y' = y by move: Y'; rewrite Y => -[].
rewrite xx in lx; rewrite yy in ly; rewrite (hangs_old lx) in IH; rewrite (hangs_old ly).
by apply: connected_edge IH X _; rewrite /target G.
Qed.

Lemma connected_up u w : connected t u w -> connected t' u w.
Proof.
elim=> [|i x y _ IH X Y]; first exact: connected_self.
have li : half_edge t i := heard_live X; have [_ [g G lg] _ _ _] := links_of li.
apply: (@connected_edge t' u i x y IH); first by rewrite originE old_h ?old_k.
by move: Y; rewrite /target twinE old_h ?old_k // G /= originE old_h ?old_k.
Qed.

Lemma o_to_v u : connected t' u o -> connected t' u v.
Proof. by move=> C; apply: (@connected_edge t' u h o v C); rewrite /target ?originE ?twinE ?newE //= originE !newE. Qed.

Lemma v_to_o u : connected t' u v -> connected t' u o.
Proof. by move=> C; apply: (@connected_edge t' u k v o C); rewrite /target ?originE ?twinE ?newE //= originE !newE. Qed.

Lemma connectedE u w : connected t' u w <-> connected t (hangs u) (hangs w).
Proof.
split=> [|/connected_up]; first exact: connected_down.
rewrite /hangs; case: (w =P v) => [->|_]; case: (u =P v) => [->|_] //.
- by move=> _; apply: connected_self.
- exact: o_to_v.
have vo : connected t' v o by apply: v_to_o; apply: connected_self.
elim=> [//|i x y _ IH X Y]; exact: connected_edge IH X Y.
Qed.

Lemma vertex_at_live c w : vertex_at t c = Some w -> vertex t w.
Proof.
rewrite /vertex_at; case S: (boundary_start t c) => [[g|u]|] //; last by case=> <-; apply: start_vertex S.
by move=> O; have [[u + l] _ _ _ _] := links_of (heard_live O); rewrite O => -[->].
Qed.

(** ** Edges *)

Lemma same_edge_old i j : half_edge t i -> same_edge t' i j <-> same_edge t i j.
Proof. by move=> li; rewrite /same_edge twinE old_h ?old_k. Qed.

(** One edge more. *)
Lemma edges_more es : lists_one_of_each es (same_edge t) (half_edge t) ->
  lists_one_of_each (h :: es) (same_edge t') (half_edge t').
Proof.
case=> u ok one all; have no_edge i j : half_edge t i -> (j == h) || (j == k) -> ~ same_edge t i j.
  move=> li jn [ij|T]; first by move: jn; rewrite -ij old_h ?old_k.
  have [_ [g + lg] _ _ _] := links_of li; rewrite T => -[jg].
  by move: jn; rewrite jg old_h ?old_k.
split=> [|i|i j|i].
- by rewrite /= u andbT; apply/negP=> /ok; rewrite (negPf free_h).
- by rewrite inE => /orP[/eqP->|/ok/up_half_edge//]; rewrite half_edgeE eqxx.
- rewrite !inE => /orP[/eqP->|/[dup] ei /ok li] /orP[/eqP->|/[dup] ej /ok lj] //.
  + by case=> [E|]; [rewrite E|rewrite twinE eqxx => -[E]; rewrite -E (negPf free_k) in lj].
  + by move/(same_edge_old _ li)/no_edge; rewrite eqxx; case.
  by move/(same_edge_old _ li); apply: one.
case/half_edgeP=> [||{}i li _ _]; [by exists h; [apply: mem_head|left]|
  by exists h; [apply: mem_head|right; rewrite twinE eqxx]|].
have [j ej S] := all i li; exists j; first by rewrite inE ej orbT.
by apply/(same_edge_old _ (ok j ej)).
Qed.

(** ** T1 to T3 *)

Lemma starts_still c w : vertex_at t c = Some w <-> exists2 w', vertex_at t' c = Some w' & hangs w' = w.
Proof.
rewrite vertex_atE; split=> [W|[w' W <-]]; last by rewrite (hangs_old (vertex_at_live W)).
by exists w => //; apply: hangs_old (vertex_at_live W).
Qed.

Lemma new_t1 : t1_outside t'.
Proof. exact: hanging_t1 keeps live_o vertexE inner_same connectedE starts_still. Qed.

Lemma new_t2 : t2_nesting t'.
Proof.
exact: hanging_t2 keeps live_o vertexE face_same outer_same boundary_face_same inner_same connectedE starts_still.
Qed.

Lemma new_t3 : lower t' -> t3_euler t'.
Proof.
move=> low'; apply: (hanging_t3 keeps free_vertex live_o vertexE face_same inner_same connectedE starts_still low').
exact: edges_more.
Qed.

Lemma connected_live u w : vertex t u -> connected t u w -> vertex t w.
Proof.
move=> lu; elim=> // i x y _ _ _; rewrite /target; case: (twin t i) => [g|] //= O.
by have [[z + l] _ _ _ _] := links_of (heard_live O); rewrite O => -[->].
Qed.

End NewEdge.
