(** * Undo: what an operator removes, another one puts back

    Removing an isolated vertex is undone by adding it, and contracting an edge by splitting its vertex: the table after has the
    same core as the one before. *)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import View Rules Map Lists NewEdge ConnectCorners Core Tidy AddVertex RemoveVertex ConnectIsolated RemoveEdge Skip Contract.
From twinedge Require Import Fan SplitVertex Same.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** ** An isolated vertex *)

Lemma undo_remove t v b f : rules t -> isolated t v = Some b -> boundary_face t b = Some f ->
  same_core (add_isolated_vertex (remove_isolated_vertex t v b) v b f) t.
Proof.
move=> keeps I F; have c := core_of_rules keeps; have [bv Ib no] := core_isolated c I.
pose t1 := remove_isolated_vertex t v b; pose t2 := add_isolated_vertex t1 v b f.
have lv := heard_live I; have lb := heard_live F.
have vE : vertex t2 =1 vertex t.
  by move=> u; rewrite /t2 vertex_more -[vertex t1 u]/(vertex (without t v b) u) RemoveVertex.vertexE; case: (u =P v) => [->|].
have bE : boundary t2 =1 boundary t.
  by move=> d; rewrite /t2 boundary_more -[boundary t1 d]/(boundary (without t v b) d) RemoveVertex.boundaryE; case: (d =P b) => [->|].
split=> //.
- move=> u lu; have lu' : vertex t u by rewrite -vE.
  rewrite {2}/isolated /heard lu /=; case: (u =P v) => [-> //|uv].
  by rewrite /isolated /heard lu'.
- move=> d ld; have ld' : boundary t d by rewrite -bE.
  by rewrite {2}/boundary_face /heard ld /=; case: (d =P b) => [-> //|db]; rewrite /boundary_face /heard ld'.
move=> d ld; have ld' : boundary t d by rewrite -bE.
rewrite {2}/inn_of /boundary_place /heard ld /=; case: (d =P b) => [-> //|db].
case J: (inn_of t d) => //; have [x X _] := core_face c ld'.
have -> : boundary_face (without t v b) d = Some x by rewrite /boundary_face /heard boundaryE (introF eqP db) ld' /= -X /boundary_face /heard ld'.
by [].
Qed.

(** ** A contracted edge *)

Section Contracted.
Variables (t : view) (n m kept dropped : nat).
Hypothesis keeps : rules t.
Hypothesis twin_n : twin t n = Some m.
Hypothesis origin_n : origin t n = Some kept.
Hypothesis origin_m : origin t m = Some dropped.
Hypothesis differ : kept <> dropped.

Notation t1 := (contract_edge t n m kept dropped).
Let links_of := NewEdge.links_of keeps.
Let twin_m : twin t m = Some n := twin_of keeps twin_n.
Let live_n : half_edge t n := heard_live twin_n.
Let live_m : half_edge t m := heard_live twin_m.
Let n_not_m : n <> m := n_not_m keeps twin_n.
Let leftE := Skip.half_edgeE t n m kept dropped.

Lemma contracted_half_edges i : [|| i == n, i == m | half_edge t1 i] = half_edge t i.
Proof.
by rewrite leftE; case: (i =P n) => [->|_]; [rewrite live_n|case: (i =P m) => [->|_]; rewrite ?live_m].
Qed.

Lemma contracted_vertices u : (u == dropped) || vertex t1 u = vertex t u.
Proof.
rewrite Skip.vertexE; case: (u =P dropped) => [->|] //=.
by have [[x + lx] _ _ _ _] := links_of live_m; rewrite origin_m => -[->].
Qed.

(** The slots of the edge and the vertex are free. *)
Lemma contracted_free : [/\ ~~ vertex t1 dropped, ~~ half_edge t1 n, ~~ half_edge t1 m & n != m].
Proof.
by rewrite Skip.vertexE !leftE !eqxx andbF; split=> //; apply/eqP.
Qed.

(** The edge that was alone is put back between two isolated vertices. *)
Lemma undo_contract_alone bn : boundary_of t n = Some bn -> alone t n m ->
  isolated t1 kept = Some bn /\ same_core (attach_to_isolated t1 kept dropped bn n m) t.
Proof.
move=> B al; have lk : vertex t1 kept.
  have lk0 : vertex t kept by have [[x + lx] _ _ _ _] := links_of live_n; rewrite origin_n => -[->].
  by rewrite Skip.vertexE lk0 andbT; apply/eqP.
have Ik : isolated t1 kept = Some bn by rewrite (Contract.isolatedE B lk) eqxx al.
split=> //; have [N M] : next t n = Some m /\ next t m = Some n by case/andP: al => /eqP-> /eqP->.
have Bm : boundary_of t m = Some bn by rewrite (next_boundary keeps N).
have none := aloneP keeps twin_n origin_n origin_m B al; have end_none := isolated_end keeps twin_n origin_n origin_m.
have hE i : half_edge (attach_to_isolated t1 kept dropped bn n m) i = half_edge t i.
  by rewrite ConnectIsolated.half_edgeE contracted_half_edges.
have vE u : vertex (attach_to_isolated t1 kept dropped bn n m) u = vertex t u.
  by rewrite ConnectIsolated.vertexE contracted_vertices.
have left i : half_edge t i -> i <> n -> i <> m -> half_edge t1 i by move=> li /eqP i_n /eqP im; rewrite leftE i_n im.
split=> //; try by [move=> i; rewrite hE|move=> u; rewrite vE].
- move=> i; rewrite hE ConnectIsolated.originE => li; case: (i =P n) => [-> //|i_n]; case: (i =P m) => [-> //|im].
  have l := left i li i_n im; have [[u U _] _ _ _ _] := links_of li; rewrite (Skip.originE keeps l) U /= /col.
  by have [_ /(_ u U)[_ /eqP/negPf->]] := none _ _ i l.
- move=> i; rewrite hE ConnectIsolated.twinE => li; case: (i =P n) => [-> //|i_n]; case: (i =P m) => [-> //|im].
  by rewrite (Skip.twinE (left i li i_n im)).
- move=> i; rewrite hE ConnectIsolated.nextE => li; case: (i =P n) => [-> //|i_n]; case: (i =P m) => [-> //|im].
  rewrite (Skip.nextE (left i li i_n im)); have [_ _ [x X _] _ _] := links_of li; rewrite X /= skip_other // => E.
    by apply: im; apply: (one_next keeps X); rewrite E.
  by apply: i_n; apply: (one_next keeps X); rewrite E.
- move=> i; rewrite hE ConnectIsolated.boundary_ofE => li; case: (i =P n) => [-> //|i_n]; case: (i =P m) => [-> //|im] /=.
  by rewrite (Skip.boundary_ofE (left i li i_n im)).
move=> u; rewrite vE ConnectIsolated.isolatedE => lu; case: (u =P dropped) => [->|ud] /=; first by rewrite end_none; auto.
case: (u =P kept) => [->|uk]; first by rewrite end_none; auto.
rewrite (Contract.isolatedE B) ?(introF eqP uk) //.
by rewrite Skip.vertexE lu andbT; apply/eqP.
Qed.

(** Otherwise [kept] has another half-edge than [n], if it is not the one of [m] that has none; and the corners are there. *)
Hypothesis next_m_n : next t m <> Some n.

Definition corner_n := odflt 0 (prev t n).
Definition corner_m := if next t n == Some m then corner_n else odflt 0 (prev t m).
Notation a := corner_m.
Notation b := corner_n.

Let prev_is i : half_edge t i -> next t (odflt 0 (prev t i)) = Some i.
Proof. by move=> li; have [_ +] := keeps L2 i li; case: (prev t i). Qed.
Let next_b : next t b = Some n. Proof. exact: prev_is live_n. Qed.
Let next_a : next t n <> Some m -> next t a = Some m. Proof. by rewrite /corner_m => /eqP/negPf->; apply: prev_is live_m. Qed.
Let a_is_b : next t n = Some m -> a = b. Proof. by rewrite /corner_m => ->; rewrite eqxx. Qed.

Lemma left_b : half_edge t1 b.
Proof.
rewrite leftE (heard_live next_b) andbT; apply/andP; split; apply/eqP=> E; last by apply: next_m_n; rewrite -{1}E.
have := origin_next keeps next_b; rewrite E /target twin_n /= origin_n origin_m => -[].
by move/differ.
Qed.

Lemma left_a : half_edge t1 a.
Proof.
case: (next t n =P Some m) => [N|N]; first by rewrite a_is_b // left_b.
have A := next_a N; rewrite leftE (heard_live A) andbT; apply/andP; split; apply/eqP=> E; first by apply: N; rewrite -{1}E.
have := origin_next keeps A; rewrite E /target twin_m /= origin_n origin_m => -[/esym].
by move/differ.
Qed.

Lemma a_not_b : next t n <> Some m -> a <> b.
Proof. by move=> N E; have := next_a N; rewrite E next_b => -[]. Qed.

Lemma next_a1 : exists2 x, next t m = Some x & next t1 a = Some x.
Proof.
have [x X _] := next_some keeps live_m; exists x => //; rewrite (Skip.nextE left_a).
case: (next t n =P Some m) => [N|N].
  by rewrite (a_is_b N) next_b /= (skipE keeps twin_n (or_introl (conj erefl erefl))) N eqxx.
rewrite (next_a N) /= (skipE keeps twin_n (or_intror (conj erefl erefl))) X; case: eqP => // E.
by case: next_m_n; rewrite X E.
Qed.

Lemma next_b1 : next t n <> Some m -> next t1 b = next t n.
Proof. by move=> /eqP/negPf N; rewrite (Skip.nextE left_b) next_b /= (skipE keeps twin_n (or_introl (conj erefl erefl))) N. Qed.

Lemma target_left i : half_edge t1 i -> target t1 i = omap (col kept dropped) (target t i).
Proof.
move=> l; rewrite /target (Skip.twinE l); case T: (twin t i) => [g|] //=.
by rewrite (Skip.originE keeps) // (Skip.twin_left keeps twin_n l T).
Qed.

Lemma target_ab : target t1 a = Some kept /\ target t1 b = Some kept.
Proof.
have Tb : target t1 b = Some kept.
  by rewrite (target_left left_b) -(origin_next keeps next_b) origin_n /= /col (introF eqP differ).
split=> //; case: (next t n =P Some m) => [N|N]; first by rewrite a_is_b.
by rewrite (target_left left_a) -(origin_next keeps (next_a N)) origin_m /= /col eqxx.
Qed.

Lemma undo_splittable : is_splittable t1 a b dropped n m.
Proof.
have [Ta Tb] := target_ab; have [fv fn fm nm] := contracted_free.
by rewrite /is_splittable Ta Tb eqxx fv fn fm nm.
Qed.

(** The fan is what left [dropped]. *)
Lemma undo_fan i : half_edge t1 i -> (i \in fan t1 a b) = (origin t i == Some dropped).
Proof.
have keeps1 : rules t1.
  by apply: contract_edge_keeps_rules => //; rewrite /is_contractible twin_n origin_n origin_m !eqxx /= andbT; apply/eqP.
have turn_m : turn t m = next t n by rewrite /turn twin_m.
have at_dropped j : half_edge t j -> origin t j = Some dropped -> on_orbit (turn t) m j.
  by move=> lj O; apply/(keeps V2 m j live_m lj); rewrite origin_m O.
move=> l; have [li i_n im] := Skip.leftP l; case: (next t n =P Some m) => [N|N].
  rewrite (@fan_none t1 a b (a_is_b N)) in_nil; apply/esym/eqP=> /(at_dropped i li)[k].
  have stay q : iter q (obind (turn t)) (Some m) = Some m by elim: q => //= q ->; rewrite /= turn_m N.
  by rewrite stay => -[/esym].
have [y Y ly] := next_some keeps live_n; have Yb := next_b1 N; rewrite Y in Yb; have A := next_a N.
have [ga Ga _] : exists2 g, twin t a = Some g & half_edge t g by have [_ T _ _ _] := links_of (heard_live A).
have [gb Gb _] : exists2 g, twin t b = Some g & half_edge t g by have [_ T _ _ _] := links_of (heard_live next_b).
have Ta : twin t1 a = Some ga by rewrite (Skip.twinE left_a).
have Tb : twin t1 b = Some gb by rewrite (Skip.twinE left_b).
have [x _ Xa] := next_a1; have [] := target_ab; rewrite /target Ta Tb /= => Oa Ob.
have Oy : origin t y = Some dropped by rewrite (origin_next keeps Y) /target twin_n.
have fan_y : y \in fan t1 a b by have [] := fan_ends keeps1 Ta Tb Yb Oa Ob (a_not_b N).
(* Around [dropped], but for [m], all is as it was. *)
have turn1 u w : half_edge t1 u -> origin t u = Some dropped -> u <> ga -> turn t u = Some w ->
    [/\ turn t1 u = Some w, half_edge t1 w & origin t w = Some dropped].
  move=> lu Ou uga T; have Ow : origin t w = Some dropped by rewrite (origin_turn keeps T).
  have [s S [ls T']] := Skip.turnE keeps twin_n lu T; have wm : w <> m.
    move=> wm; apply: uga; move: T; rewrite wm /turn; case G: (twin t u) => [g|] //= M.
    by apply: (one_twin keeps G); rewrite (twin_of keeps Ga) (one_next keeps M A).
  have wn : w <> n by move=> E; move: Ow; rewrite E origin_n => -[].
  by move: S; rewrite skip_other // => -[E]; rewrite -E in ls T'.
have ly1 : half_edge t1 y := fan_live keeps1 Ta Tb Yb Oa Ob fan_y.
apply/idP/eqP=> [|O].
  suff H j : j \in fan t1 a b -> half_edge t1 j /\ origin t j = Some dropped by move=> /H[].
  move: j; apply: (fan_ind keeps1 Ta Tb Yb Oa Ob) => // u w _ uga [lu Ou] T.
  have [v V lv] : exists2 v, turn t u = Some v & half_edge t v.
    by have [Lu _ _] := Skip.leftP lu; have [_ [g G lg] _ _ _] := links_of Lu; rewrite /turn G; apply: next_some.
  by have [T1 lv1 Ov] := turn1 u v lu Ou uga V; move: T; rewrite T1 => -[<-].
suff [[]//|//] : i \in fan t1 a b /\ origin t i = Some dropped \/ i = m.
apply: (orbit_ind (P := fun u => u \in fan t1 a b /\ origin t u = Some dropped \/ u = m)) (at_dropped i li O) => [|u w]; first by right.
case=> [[F Ou]|->] T; last by left; move: T; rewrite turn_m Y => -[<-].
case: (u =P ga) => [uga|uga]; first by right; move: T; rewrite uga /turn (twin_of keeps Ga) /= A => -[].
have lu := fan_live keeps1 Ta Tb Yb Oa Ob F; have [T1 _ Ow] := turn1 u w lu Ou uga T.
by left; split=> //; apply: (fan_step keeps1 Ta Tb Yb Oa Ob) F uga T1.
Qed.

Lemma undo_contract : same_core (split_vertex t1 a b dropped n m) t.
Proof.
have keeps1 : rules t1.
  by apply: contract_edge_keeps_rules => //; rewrite /is_contractible twin_n origin_n origin_m !eqxx /= andbT; apply/eqP.
have link c : half_edge t1 c -> exists g x, [/\ twin t1 c = Some g & next t1 c = Some x].
  by move=> lc; have [_ [g G _] [x X _] _ _] := NewEdge.links_of keeps1 lc; exists g, x.
have [ga [xa [Ga Xa]]] := link a left_a; have [gb [xb [Gb Xb]]] := link b left_b.
have [] := target_ab; rewrite /target Ga Gb /= => Oa Ob.
pose t2 := split_vertex t1 a b dropped n m.
have hE i : half_edge t2 i = half_edge t i by rewrite SplitVertex.half_edgeE contracted_half_edges.
have vE u : vertex t2 u = vertex t u by rewrite SplitVertex.vertexE contracted_vertices.
have left i : half_edge t i -> i <> n -> i <> m -> half_edge t1 i by move=> li /eqP i_n /eqP im; rewrite leftE i_n im.
split; try by [move=> i; rewrite -/t2 hE|move=> u; rewrite -/t2 vE|].
- move=> i; rewrite -/t2 hE (SplitVertex.originE dropped n m keeps1 Ga Gb Xb Oa Ob) => li.
  case: (i =P n) => [-> //|i_n]; case: (i =P m) => [-> //|im] /=; have l := left i li i_n im; rewrite (undo_fan l).
  case: eqP => [//|no]; rewrite (Skip.originE keeps l); have [[u U _] _ _ _ _] := links_of li; rewrite U /= /col.
  by case: eqP => // E; case: no; rewrite U E.
- move=> i; rewrite -/t2 hE SplitVertex.twinE => li; case: (i =P n) => [-> //|i_n]; case: (i =P m) => [-> //|im].
  by rewrite (Skip.twinE (left i li i_n im)).
- move=> i; rewrite -/t2 hE (SplitVertex.nextE dropped n m Ga Gb Xa Xb) => li.
  case: (i =P n) => [->|i_n].
    case: (a =P b) => [ab|ab]; first by case: (next t n =P Some m) => // /a_not_b.
    by rewrite -next_b1 // => /a_is_b.
  case: (i =P m) => [->|im]; first by have [x X] := next_a1; rewrite Xa X => ->.
  case: (i =P b) => [->|ib]; first exact: next_b.
  have other j : next t i = Some j -> j <> n by move=> N E; apply: ib; apply: (one_next keeps N); rewrite next_b E.
  have [_ _ [x X _] _ _] := links_of li; case: (i =P a) => [ia|ia].
    rewrite ia; apply: next_a => N; apply: ib; by rewrite ia a_is_b.
  rewrite (Skip.nextE (left i li i_n im)) X /= skip_other //; first exact: other.
  move=> xm; case: (next t n =P Some m) => [N|N]; first by apply: i_n; apply: (one_next keeps X); rewrite xm.
  by apply: ia; apply: (one_next keeps X); rewrite xm next_a.
- move=> i; rewrite -/t2 hE SplitVertex.boundary_ofE => li; case: (i =P n) => [->|i_n].
    by rewrite (Skip.boundary_ofE left_b) (next_boundary keeps next_b).
  case: (i =P m) => [->|im]; last by rewrite (Skip.boundary_ofE (left i li i_n im)).
  rewrite (Skip.boundary_ofE left_a); case: (next t n =P Some m) => [N|N]; last by rewrite (next_boundary keeps (next_a N)).
  by rewrite (a_is_b N) (next_boundary keeps N) (next_boundary keeps next_b).
move=> u; rewrite -/t2 vE SplitVertex.isolatedE => lu; have end_none := isolated_end keeps twin_n origin_n origin_m.
case: (u =P dropped) => [->|ud]; first by rewrite end_none; auto.
have [bn B] : exists bn, boundary_of t n = Some bn by have [_ _ _ _ [bn B _]] := links_of live_n; exists bn.
have lu1 : vertex t1 u by rewrite Skip.vertexE lu andbT; apply/eqP.
rewrite (Contract.isolatedE B lu1); case: ifP => // /andP[/eqP-> /andP[_ /eqP M]].
by case: next_m_n.
Qed.

End Contracted.
