(** * SplitVertex: splitting a vertex keeps all rules (`split_vertex` in dcel/operators/split_vertex.rs)

    The half-edges [a] and [b] end at one vertex. It is split between the corners after them: what leaves it from [next b] on,
    clockwise to the twin of [a], leaves the new vertex [v]. That is its *fan*. The new edge has the half-edges [h], to [v], and [k],
    from [v]. Boundary components and faces stay as they are. If the corners are one, the fan is empty, and [v] is a leaf.

<<
         a ╲   ╱ next b                a ╲   ╱ next b         b ──► h ──► next b
            ╲ ╱                           · v
             ·             ──►          k │▲ h
            ╱ ╲                           ▼│
       ... ╱   ╲ b                        ·                   a ──► k ──► next a
                                         ╱ ╲ b
>>

    If the fan is the twin of [a] alone, [v] lies on the edge of [a] (`split_edge` in dcel/operators/split_edge.rs). Contracting the
    new edge makes what was there (Contract.v). *)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import Arith View Rules Map Counting Lists NewEdge ConnectCorners Core Collapse RemoveEdge Fan.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** The view [t] with the vertex [v] and the edge [h], [k] to it, between the corners after [a] and after [b]. *)
Definition split_vertex t a b v h k : view := {|
  vertex_slots := maxn (vertex_slots t) v.+1;
  half_edge_slots := maxn (half_edge_slots t) (maxn h.+1 k.+1);
  boundary_slots := boundary_slots t;
  face_slots := face_slots t;
  is_vertex := fun i => (i == v) || vertex t i;
  is_half_edge := fun i => [|| i == h, i == k | half_edge t i];
  is_boundary := is_boundary t;
  is_face := is_face t;
  says_origin := fun i => if i == h then target t b else if (i == k) || (i \in fan t a b) then Some v else says_origin t i;
  says_twin := fun i => if i == h then Some k else if i == k then Some h else says_twin t i;
  says_next := fun i => if i == h then (if a == b then Some k else next t b) else if i == k then next t a else
    if i == b then Some h else if i == a then Some k else says_next t i;
  says_prev := fun i => if i == h then Some b else if i == k then (if a == b then Some h else Some a) else
    if Some i == next t a then Some k else if Some i == next t b then Some h else says_prev t i;
  says_boundary := fun i => if i == h then boundary_of t b else if i == k then boundary_of t a else says_boundary t i;
  says_leaving := fun u => if u == v then Some k else if has (fun i => leaving t u == Some i) (fan t a b) then Some h else
    says_leaving t u;
  says_isolated := fun u => if u == v then None else says_isolated t u;
  says_boundary_face := says_boundary_face t;
  says_boundary_start := says_boundary_start t;
  says_boundary_place := says_boundary_place t;
  says_outer := says_outer t;
  says_inner_count := says_inner_count t;
  says_inner := says_inner t
|}.

Section SplitVertex.
Variables (t : view) (a b v h k ta tb na nb o : nat).
Hypothesis keeps : rules t.
Hypothesis free_vertex : ~~ vertex t v.
Hypothesis free_h : ~~ half_edge t h.
Hypothesis free_k : ~~ half_edge t k.
Hypothesis hk : h != k.
Hypothesis twin_a : twin t a = Some ta.
Hypothesis twin_b : twin t b = Some tb.
Hypothesis next_a : next t a = Some na.
Hypothesis next_b : next t b = Some nb.
Hypothesis origin_ta : origin t ta = Some o.
Hypothesis origin_tb : origin t tb = Some o.

Notation t' := (split_vertex t a b v h k).
Notation inn := (inn_of t).
Notation fan := (fan t a b).
Let c : core t inn := core_of_rules keeps.
Let r : rest t inn := rest_of_rules keeps.
Let links_of := NewEdge.links_of keeps.
Let twin_of := twin_of keeps.
Let prev_of := prev_of keeps.
Let one_next := one_next keeps.
Let one_twin := one_twin keeps.
Let next_boundary := next_boundary keeps.
Let next_some := RemoveEdge.next_some keeps.
Let origin_next := RemoveEdge.origin_next keeps.
Let live_a : half_edge t a := heard_live twin_a.
Let live_b : half_edge t b := heard_live twin_b.
Let twin_ta : twin t ta = Some a := twin_of twin_a.
Let twin_tb : twin t tb = Some b := twin_of twin_b.
Let live_tb : half_edge t tb := heard_live twin_tb.
Let live_na : half_edge t na. Proof. by have [x + lx] := next_some live_a; rewrite next_a => -[->]. Qed.
Let live_nb : half_edge t nb. Proof. by have [x + lx] := next_some live_b; rewrite next_b => -[->]. Qed.
Let origin_na : origin t na = Some o. Proof. by rewrite (origin_next next_a) /target twin_a. Qed.
Let turn_ta : turn t ta = Some na. Proof. by rewrite /turn twin_ta. Qed.
Let turn_tb : turn t tb = Some nb. Proof. by rewrite /turn twin_tb. Qed.
Let old_h := NewEdge.old_h free_h.
Let old_k := NewEdge.old_k free_k.
Let newE := NewEdge.newE hk.

Let fan_ends := fan_ends keeps twin_a twin_b next_b origin_ta origin_tb.
Let fan_step := fan_step keeps twin_a twin_b next_b origin_ta origin_tb.
Let fan_tb : tb \notin fan := fan_tb keeps twin_a twin_b next_b origin_ta origin_tb.
Let fan_ind := fan_ind keeps twin_a twin_b next_b origin_ta origin_tb.
Let fan_origin := fan_origin keeps twin_a twin_b next_b origin_ta origin_tb.
Let fan_live := fan_live keeps twin_a twin_b next_b origin_ta origin_tb.
Let fan_na := fan_na keeps twin_a twin_b next_a next_b origin_ta origin_tb.
Let fan_turn := fan_turn keeps twin_a twin_b next_b origin_ta origin_tb.

(** ** What the view says *)

Lemma vertexE i : vertex t' i = (i == v) || vertex t i.
Proof. exact: one_more (@vertex_below t). Qed.

Lemma half_edgeE i : half_edge t' i = [|| i == h, i == k | half_edge t i].
Proof. exact: two_more (@half_edge_below t). Qed.

Let up_half_edge := NewEdge.up_half_edge half_edgeE.
Let half_edgeP := NewEdge.half_edgeP free_h free_k half_edgeE.
Ltac heard := rewrite /heard half_edgeE /=; case: (_ == h) => //=; case: (_ == k) => //=.

Lemma lh : half_edge t' h. Proof. by rewrite half_edgeE eqxx. Qed.
Lemma lk : half_edge t' k. Proof. by rewrite half_edgeE eqxx orbT. Qed.

Lemma originE i : origin t' i = if i == h then Some o else if (i == k) || (i \in fan) then Some v else origin t i.
Proof.
have T : target t b = Some o by rewrite /target twin_b.
rewrite {1}/origin; heard; rewrite ?T //.
by case: (boolP (i \in fan)) => [/fan_live->|] //.
Qed.

Lemma twinE i : twin t' i = if i == h then Some k else if i == k then Some h else twin t i.
Proof. by rewrite {1}/twin; heard. Qed.

Lemma nextE i : next t' i = if i == h then (if a == b then Some k else Some nb) else if i == k then Some na else
  if i == b then Some h else if i == a then Some k else next t i.
Proof.
rewrite {1}/next; heard; rewrite ?next_b ?next_a //.
by case: (i =P b) => [->|_]; [rewrite live_b|case: (i =P a) => [->|//]; rewrite live_a].
Qed.

Lemma prevE i : prev t' i = if i == h then Some b else if i == k then (if a == b then Some h else Some a) else
  if i == na then Some k else if i == nb then Some h else prev t i.
Proof.
rewrite {1}/prev; heard; rewrite next_a next_b -![Some i == Some _]/(i == _).
by case: (i =P na) => [->|_]; [rewrite live_na|case: (i =P nb) => [->|//]; rewrite live_nb].
Qed.

Lemma boundary_ofE i : boundary_of t' i = if i == h then boundary_of t b else if i == k then boundary_of t a else boundary_of t i.
Proof. by rewrite {1}/boundary_of; heard. Qed.

Lemma isolatedE u : isolated t' u = if u == v then None else isolated t u.
Proof. by rewrite {1}/isolated /heard vertexE /=; case: (u == v) => //=; case: (vertex t u). Qed.

(** ** Half-edges *)

Lemma old_next i j : half_edge t i -> next t i = Some j -> half_edge t j.
Proof. by move=> /next_some[x + lx] N; rewrite N => -[->]. Qed.

Lemma next_total i : half_edge t' i -> exists2 j, next t' i = Some j & half_edge t' j.
Proof.
case/half_edgeP=> [||{}i li ih ik]; rewrite nextE ?newE.
- by case: eqP => _; [exists k|exists nb]; rewrite ?lk ?up_half_edge.
- by exists na; rewrite ?up_half_edge.
rewrite ih ik; case: eqP => _; first by exists h; rewrite ?lh.
case: eqP => _; first by exists k; rewrite ?lk.
by have [j N lj] := next_some li; exists j; rewrite ?up_half_edge.
Qed.

Lemma prev_next i j : half_edge t' i -> next t' i = Some j -> prev t' j = Some i.
Proof.
case/half_edgeP=> [||{}i li ih ik]; rewrite nextE ?newE.
- case: (a =P b) => [ab|ab] [<-]; first by rewrite prevE !newE ab eqxx.
  rewrite prevE old_h ?old_k // eqxx; case: eqP => // E.
  by case: ab; apply: one_next next_a _; rewrite -E.
- by case=> <-; rewrite prevE old_h ?old_k // eqxx.
rewrite ih ik; case: (i =P b) => [-> [<-]|ib]; first by rewrite prevE eqxx.
case: (i =P a) => [ia [<-]|ia N]; first by rewrite prevE !newE ia; case: (a =P b) => // ab; case: ib; rewrite ia.
have lj := old_next li N; rewrite prevE old_h ?old_k //.
case: eqP => [jn|_]; first by case: ia; apply: one_next N _; rewrite jn.
case: eqP => [jn|_]; first by case: ib; apply: one_next N _; rewrite jn.
exact: prev_of.
Qed.

Lemma split_next i j : half_edge t' i -> half_edge t' j -> next t' i = next t' j -> i = j.
Proof.
move=> li lj; have [y Y _] := next_total li; rewrite Y => /esym/(prev_next lj).
by rewrite (prev_next li Y) => -[].
Qed.

Let split_l1 : l1_twin t' := new_l1 keeps free_h free_k hk half_edgeE twinE.

Lemma split_l3 : l3_target t'.
Proof.
have no_fan i : i \notin fan -> half_edge t i -> origin t' i = origin t i.
  by move=> /negPf F li; rewrite originE old_h ?old_k ?F.
have in_fan i : i \in fan -> origin t' i = Some v.
  by move=> F; have li := fan_live F; rewrite originE old_h ?old_k ?F.
move=> i; case/half_edgeP=> [||{}i li ih ik]; rewrite nextE twinE ?newE.
- case: (a =P b) => [ab|ab] //=; have [F _] := fan_ends ab.
  by rewrite (in_fan nb F) originE !newE.
- by rewrite /= (no_fan na) ?fan_na // originE eqxx origin_na.
rewrite ih ik; case: (i =P b) => [->|ib]; first by rewrite twin_b /= originE eqxx (no_fan tb) ?fan_tb ?origin_tb.
case: (i =P a) => [ia|ia].
  have ab : a <> b by move=> ab; apply: ib; rewrite ia.
  by have [_ F] := fan_ends ab; rewrite ia twin_a /= (in_fan ta F) originE !newE.
have [_ [g G lg] [j N lj] _ _] := links_of li; rewrite N G /= !originE !old_h ?old_k //=.
have [ga gb] : g <> ta /\ g <> tb.
  by split=> E; [apply: ia; apply: one_twin G _; rewrite E|apply: ib; apply: one_twin G _; rewrite E].
rewrite (fan_turn ga gb) ?/turn ?(twin_of G) //; case: ifP => // _.
by have := keeps L3 i li; rewrite N G.
Qed.

(** ** V2 *)

Lemma turn_h : turn t' h = Some na. Proof. by rewrite /turn twinE eqxx /= nextE !newE. Qed.
Lemma turn_k : turn t' k = if a == b then Some k else Some nb. Proof. by rewrite /turn twinE !newE /= nextE eqxx. Qed.

Lemma turnE i : half_edge t i -> turn t' i = if i == tb then Some h else if i == ta then Some k else turn t i.
Proof.
move=> li; have [_ [g G lg] _ _ _] := links_of li; rewrite /turn twinE old_h ?old_k // G /= nextE old_h ?old_k //.
have one x y : twin t y = Some x -> (g == x) = (i == y).
  by move=> T; apply/eqP/eqP => E; [apply: one_twin G _; rewrite E|move: G; rewrite E T => -[]].
by rewrite (one b tb) // (one a ta).
Qed.

Lemma turn_back i j : half_edge t' i -> on_orbit (turn t') i j -> on_orbit (turn t') j i.
Proof.
have twin_total g : half_edge t' g -> exists2 x, twin t' g = Some x & half_edge t' x.
  case/half_edgeP=> [||{}g lg gh gk]; rewrite twinE ?newE; [by exists k; rewrite ?lk|by exists h; rewrite ?lh|].
  by rewrite gh gk; have [_ [x X lx] _ _ _] := links_of lg; exists x; rewrite ?up_half_edge.
apply: (orbit_back (@half_edge_below t')) => [g /twin_total[x X lx]|g x lg lx]; first by rewrite /turn X; apply: next_total.
have [y Y ly] := twin_total g lg; have [z Z lz] := twin_total x lx; rewrite /turn Y Z /= => /(split_next ly lz) yz.
by have [+ _] := split_l1 lg; have [+ _] := split_l1 lx; rewrite Y Z yz /= => -> [].
Qed.

Lemma reach_k i : i \in fan -> on_orbit (turn t') k i.
Proof.
move=> F; have ab := fan_differ F; move: i F; apply: fan_ind => [|i j Fi ia C T].
  by apply: orbit_step (orbit_refl _ _) _; rewrite turn_k (introF eqP ab).
apply: orbit_step C _; rewrite (turnE (fan_live Fi)); case: eqP => [E|_]; first by move: fan_tb; rewrite -E Fi.
by rewrite (introF eqP ia).
Qed.

Lemma reach_h i : half_edge t i -> origin t i = Some o -> i \notin fan -> on_orbit (turn t') h i.
Proof.
move=> li O F; have C : on_orbit (turn t) na i by apply/(keeps V2 na i live_na li); rewrite origin_na.
have H_na : on_orbit (turn t') h na := orbit_step (orbit_refl _ _) turn_h.
suff [/(negP F)//|//] : i \in fan \/ on_orbit (turn t') h i.
apply: (orbit_ind (P := fun i => i \in fan \/ on_orbit (turn t') h i)) C => [|u w]; first by right.
case: (u =P ta) => [-> _|ua]; first by rewrite turn_ta => -[<-]; right.
case=> [Fu T|Cu]; first by left; apply: fan_step T.
case: (u =P tb) => [->|ub] T.
  move: T; rewrite turn_tb => -[<-]; case: (a =P b) => [ab|/fan_ends[]]; [right|by left].
  by have -> : nb = na by move: next_b; rewrite -ab next_a => -[].
right; apply: orbit_step Cu _; rewrite turnE ?(introF eqP ua) ?(introF eqP ub) //.
by move: T; rewrite /turn; case G: (twin t u) => [g|] // _; apply: heard_live G.
Qed.

Let live_o : vertex t o. Proof. by have [[u + lu] _ _ _ _] := links_of live_na; rewrite origin_na => -[->]. Qed.
Let o_not_v : o <> v. Proof. by move=> E; move: free_vertex; rewrite -E live_o. Qed.

(** A half-edge begins at the new vertex, at the old one, or elsewhere. *)
Variant begins i : Prop :=
  | AtNew of origin t' i = Some v & on_orbit (turn t') k i
  | AtOld of origin t' i = Some o & on_orbit (turn t') h i
  | Elsewhere u of half_edge t i & origin t i = Some u & origin t' i = Some u & u <> o & u <> v.

Lemma beginsP i : half_edge t' i -> begins i.
Proof.
case/half_edgeP=> [||{}i li ih ik].
- by apply: AtOld; [rewrite originE eqxx|apply: orbit_refl].
- by apply: AtNew; [rewrite originE !newE|apply: orbit_refl].
have E : origin t' i = if i \in fan then Some v else origin t i by rewrite originE ih ik.
case: (boolP (i \in fan)) E => [F|F] E; first by apply: AtNew (reach_k F).
have [[u U lu] _ _ _ _] := links_of li; case: (u =P o) => [uo|uo].
  by apply: AtOld; [rewrite E U uo|apply: reach_h; rewrite // U uo].
by apply: (@Elsewhere _ u); rewrite ?E // => uv; move: free_vertex; rewrite -uv lu.
Qed.

Lemma split_rotation g i : half_edge t' g -> half_edge t' i -> origin t' g = origin t' i -> on_orbit (turn t') g i.
Proof.
move=> lg li; case: (beginsP lg) => [Og Cg|Og Cg|u Lg Ug Og uo uv]; case: (beginsP li) => [Oi Ci|Oi Ci|w Li Wi Oi wo wv]; rewrite Og Oi.
- by move=> _; apply: orbit_trans (turn_back lk Cg) Ci.
- by case=> /esym/o_not_v.
- by case=> /esym/wv.
- by case=> /o_not_v.
- by move=> _; apply: orbit_trans (turn_back lh Cg) Ci.
- by case=> /esym/wo.
- by case=> /uv.
- by case=> /uo.
case=> E; suff [] : on_orbit (turn t') g i /\ origin t i = Some u by [].
apply: (orbit_ind (P := fun i => on_orbit (turn t') g i /\ origin t i = Some u)) ((keeps V2 g i Lg Li).2 _).
- by split=> //; apply: orbit_refl.
- move=> x y [C O] T; have -> : origin t y = Some u.
    by rewrite -O; apply: (on_rotation_origin (keeps L1) (keeps L3)); exists 1.
  split=> //; apply: orbit_step C _; rewrite (turnE (heard_live O)).
  case: eqP => [xb|_]; first by case: uo; move: O; rewrite xb origin_tb => -[].
  by case: eqP => // xa; case: uo; move: O; rewrite xa origin_ta => -[].
by rewrite Ug Wi E.
Qed.

(** ** Cycles *)

Lemma split_side i : half_edge t' i -> next t' i >>= boundary_of t' = boundary_of t' i.
Proof.
have old i' j : half_edge t i' -> next t i' = Some j -> boundary_of t' j = boundary_of t i'.
  by move=> li N; rewrite boundary_ofE old_h ?old_k ?(old_next li N) // (next_boundary N).
have at_h : boundary_of t' h = boundary_of t b by rewrite boundary_ofE eqxx.
have at_k : boundary_of t' k = boundary_of t a by rewrite boundary_ofE !newE.
case/half_edgeP=> [||{}i li ih ik]; rewrite nextE ?newE ?at_h ?at_k.
- by case: eqP => [ab|_] /=; [rewrite at_k ab|apply: old].
- exact: old.
rewrite [RHS]boundary_ofE ih ik; case: eqP => [->|_] //=; case: eqP => [->|_] //=.
by have [j N _] := next_some li; rewrite N; apply: old.
Qed.

Lemma cycle_up g i : on_cycle t g i -> on_cycle t' g i.
Proof.
have h_on z : on_cycle t' z h -> a = b -> on_cycle t' z na.
  move=> C ab; apply: orbit_step (orbit_step C _) _; first by rewrite nextE eqxx ab eqxx.
  by rewrite nextE !newE.
apply: orbit_sub => u w z N C; have lu := heard_live N; have E : next t' u = if u == b then Some h else if u == a then Some k else next t u.
  by rewrite nextE old_h ?old_k.
case: (u =P b) E => [ub|_] E.
  have Ch := orbit_step C E; have wE : w = nb by move: N; rewrite ub next_b => -[].
  case: (a =P b) => [ab|ab]; first by have -> : w = na by [move: next_a; rewrite ab next_b wE => -[]]; apply: h_on.
  by apply: orbit_step Ch _; rewrite nextE eqxx (introF eqP ab) wE.
case: (u =P a) E => [ua|_] E; last by apply: orbit_step C _; rewrite E.
by apply: orbit_step (orbit_step C E) _; rewrite nextE !newE -N ua next_a.
Qed.

(** A half-edge that was there, of the same boundary component, along whose cycle it lies. *)
Lemma on_old i : half_edge t' i -> exists j, [/\ half_edge t j, boundary_of t' i = boundary_of t j & on_cycle t' j i].
Proof.
have to_h : on_cycle t' b h by apply: orbit_step (orbit_refl _ _) _; rewrite nextE old_h ?old_k // eqxx.
case/half_edgeP=> [||{}i li ih ik].
- by exists b; rewrite boundary_ofE eqxx.
- case: (a =P b) => [ab|ab]; [exists b|exists a]; rewrite boundary_ofE !newE; split=> //; first by rewrite ab.
    by apply: orbit_step to_h _; rewrite nextE eqxx ab eqxx.
  by apply: orbit_step (orbit_refl _ _) _; rewrite nextE old_h ?old_k // (introF eqP ab) eqxx.
by exists i; rewrite boundary_ofE ih ik; split=> //; apply: orbit_refl.
Qed.

Lemma split_cycle g i : half_edge t' g -> half_edge t' i -> boundary_of t' g = boundary_of t' i -> on_cycle t' g i.
Proof.
move=> lg li; have [j [lj -> Cj]] := on_old lg; have [x [lx -> Cx]] := on_old li => B.
apply: orbit_trans (orbit_trans (cycle_up (core_cycle c lj lx B)) Cx).
exact: orbit_back (@half_edge_below t') next_total split_next (up_half_edge lj) Cj.
Qed.

(** ** Vertices *)

Lemma isolated_old u x : isolated t u = Some x -> u <> o /\ u <> v.
Proof.
move=> I; have [B _ _] := core_isolated c I; split=> E; first by case: (B na live_na); rewrite E.
by move: free_vertex; rewrite -E (heard_live I).
Qed.

Lemma bare_old u : u <> v -> bare t' u <-> bare t u.
Proof.
move=> uv; split=> B i li O.
  have lu := up_half_edge li; case: (boolP (i \in fan)) => [F|F]; last by apply: (B i lu); rewrite originE old_h ?old_k ?(negPf F).
  by apply: (B h lh); rewrite originE eqxx -(fan_origin F) O.
move: O; rewrite originE; case: eqP => [_ [ou]|ih]; first by apply: (B na live_na); rewrite origin_na ou.
case: ifP => [_ [/esym]//|ik]; apply: B.
by move: li; rewrite half_edgeE (introF eqP ih); case: eqP ik => // ->; rewrite eqxx.
Qed.

(** ** What is connected, and what boundary components pass *)

Notation hangs := (hangs v o).

Lemma twins_connected u w : hangs u = hangs w -> connected t' u w.
Proof.
have up : connected t' o v by apply: (connected_edge (h := h) (connected_self _ _)); rewrite ?/target ?originE ?twinE ?eqxx //= originE !newE.
have down := connected_back split_l1 up.
rewrite /NewEdge.hangs; case: (u =P v) => [->|_]; case: (w =P v) => [->|_] E; [apply: connected_self|by rewrite -E|by rewrite E|by rewrite E; apply: connected_self].
Qed.

Lemma origin_old i u : origin t i = Some u -> exists2 u', origin t' i = Some u' & hangs u' = u.
Proof.
move=> O; have li := heard_live O; have [[x X lx] _ _ _ _] := links_of li.
rewrite originE old_h ?old_k //=; case: (boolP (i \in fan)) => [F|_].
  by exists v => //; rewrite /NewEdge.hangs eqxx; move: O; rewrite (fan_origin F) => -[].
exists u => //; rewrite /NewEdge.hangs; case: eqP => // uv; move: free_vertex; rewrite -uv.
by move: X lx; rewrite O => -[<-] ->.
Qed.

Lemma split_connected u w u' w' : connected t u w -> hangs u' = u -> hangs w' = w -> connected t' u' w'.
Proof.
move=> C; elim: C w' => [|i x y _ IH X Y] w' uE wE; first by apply: twins_connected; rewrite uE.
have [x' X' xE] := origin_old X; have li := heard_live X; move: Y; rewrite /target; case G: (twin t i) => [g|] //= Y.
have [y' Y' yE] := origin_old Y; apply: connected_trans (twins_connected (u := y') _); last by rewrite yE.
by apply: connected_edge (IH x' uE xE) X' _; rewrite /target twinE old_h ?old_k // G.
Qed.

Lemma split_passes x u : passes t x u -> exists2 u', hangs u' = u & passes t' x u'.
Proof.
case=> [[i B O]|I].
  have [u' U E] := origin_old O; exists u' => //; left; exists i => //.
  by rewrite boundary_ofE old_h ?old_k ?(heard_live B).
have [_ uv] := isolated_old I; exists u; first by rewrite /NewEdge.hangs (introF eqP uv).
by right; rewrite isolatedE (introF eqP uv).
Qed.

Lemma split_counts : core_count t' inn.
Proof.
have [vs [hs [fs [bs [Hv Hh Hf Hb eq]]]]] := core_counts c.
exists (v :: vs), (h :: k :: hs), fs, bs; split=> //.
- apply: lists_iff (lists_cons (negP free_vertex) Hv) => u; rewrite vertexE.
  by split=> [[->|->]|/orP[/eqP|]]; rewrite ?eqxx ?orbT; auto.
- have no : ~ (h = k \/ half_edge t h) by case=> [/eqP|]; [rewrite (negPf hk)|rewrite (negPf free_h)].
  apply: lists_iff (lists_cons no (lists_cons (negP free_k) Hh)) => i; rewrite half_edgeE.
  by split=> [[->|[->|->]]|/or3P[/eqP|/eqP|]]; rewrite ?eqxx ?orbT; auto.
by move: eq => /=; arith.
Qed.

Lemma split_core : core t' inn.
Proof.
split.
- move=> i li; have [x B lx] : exists2 x, boundary_of t' i = Some x & boundary t x.
    by have [j [lj -> _]] := on_old li; have [_ _ _ _ E] := links_of lj.
  split; last by exists x.
  + case: (beginsP li) => [O _|O _|u Li U O _ _]; [exists v|exists o|exists u] => //; rewrite vertexE ?eqxx ?live_o ?orbT //.
    by have [[y + ly] _ _ _ _] := links_of Li; rewrite U => -[->]; rewrite ly orbT.
  + case/half_edgeP: li => [||{B lx}i li ih ik]; rewrite twinE ?newE; [by exists k; rewrite ?lk|by exists h; rewrite ?lh|].
    by rewrite ih ik; have [_ [g G lg] _ _ _] := links_of li; exists g; rewrite ?up_half_edge.
  exact: next_total.
- exact: split_l1.
- exact: split_next.
- exact: split_l3.
- exact: split_rotation.
- exact: split_side.
- exact: split_cycle.
- move=> u; rewrite vertexE isolatedE; case: (u =P v) => [-> _ /(_ k lk)|uv /= lu /(bare_old uv)]; last exact: (core_bare c).
  by rewrite originE !newE => /(_ erefl).
- move=> u x; rewrite isolatedE; case: eqP => // uv I; have [B Ix no] := core_isolated c I; split=> //; first exact/bare_old.
  by move=> i E; have [j [_ + _]] := on_old (heard_live E); rewrite E => /esym/no.
- by move=> u w x; rewrite !isolatedE; case: eqP => // _; case: eqP => // _; apply: (core_one c).
- by move=> x /(core_used c)[u /split_passes[w _ P]]; exists w.
- exact: (core_face c).
- exact: (core_outer c).
- exact: (core_unbounded c).
- apply: (@collapse_inside t t' inn (fun u w => hangs w = u) c) => //.
  + move=> u; rewrite vertexE => lu; exists (hangs u) => //; rewrite /NewEdge.hangs.
    by case: (u =P v) lu => [_ _|_]; [apply: live_o|].
  + exact: split_connected.
  exact: split_passes.
- apply: (@collapse_out t t' inn (fun u w => hangs w = u) c) => //; [exact: split_connected|exact: split_passes].
exact: split_counts.
Qed.

(** ** The rest *)

Lemma split_leaving u : vertex t' u ->
  (exists2 g, leaving t' u = Some g & origin t' g = Some u) \/ leaving t' u = None /\ bare t' u.
Proof.
move=> lu'; rewrite {1 2}/leaving /heard lu' /=; case: (u =P v) => [->|uv]; first by left; exists k; rewrite // originE !newE.
have lu : vertex t u by move: lu'; rewrite vertexE (introF eqP uv).
have L : says_leaving t u = leaving t u by rewrite /leaving /heard lu.
rewrite L; case: (rest_leaving r lu) => [[g G O]|[E B]]; [left|right]; rewrite ?G ?E; last first.
  by split; [case: hasP => // -[]|exact/bare_old].
have -> : has (fun i => Some g == Some i) fan = (g \in fan).
  by apply/hasP/idP => [[i F /eqP[->]]|F] //; exists g.
case: (boolP (g \in fan)) => F; [exists h|exists g] => //; rewrite originE; last by rewrite old_h ?old_k ?(negPf F) ?(heard_live O).
by rewrite eqxx -O (fan_origin F).
Qed.

Lemma split_start x : boundary t' x ->
  (exists2 g, boundary_start t' x = Some (AtHalfEdge g) & boundary_of t' g = Some x) \/
  exists2 u, boundary_start t' x = Some (AtVertex u) & isolated t' u = Some x.
Proof.
move=> lx; case: (rest_start r (lx : boundary t x)) => [[g S B]|[u S I]]; [left; exists g|right; exists u] => //.
  by rewrite boundary_ofE old_h ?old_k ?(heard_live B).
by have [_ uv] := isolated_old I; rewrite isolatedE (introF eqP uv).
Qed.

Lemma split_rest : rest t' inn.
Proof.
split.
- by move=> i; apply: prev_of_next next_total prev_next.
- exact: split_leaving.
- exact: split_start.
- exact: (rest_place r).
- exact: (rest_listed r).
exact: (rest_lists r).
Qed.

End SplitVertex.

(** The corners after [a] and after [b] are at one vertex, and [v], [h] and [k] are free slots. *)
Definition is_splittable t a b v h k := [&& isSome (target t a), target t a == target t b, ~~ vertex t v,
  ~~ half_edge t h, ~~ half_edge t k & h != k].

(** If all rules held before, they hold after. *)
Theorem split_vertex_keeps_rules t a b v h k : is_splittable t a b v h k -> rules t -> rules (split_vertex t a b v h k).
Proof.
case/and5P=> ends /eqP ab fv fh /andP[fk hk] keeps.
have links x : isSome (target t x) -> exists g n u, [/\ twin t x = Some g, next t x = Some n & origin t g = Some u].
  rewrite /target; case T: (twin t x) => [g|] //=; case O: (origin t g) => [u|] // _.
  by have [_ _ [n N _] _ _] := links_of keeps (heard_live T); exists g, n, u.
have [ta [na [o [Ta Na Oa]]]] := links a ends; have [|tb [nb [o' [Tb Nb Ob]]]] := links b; first by rewrite -ab.
have oo : o' = o by move: ab; rewrite /target Ta Tb /= Oa Ob => -[].
rewrite oo in Ob; exact: core_rules (split_core keeps fv fh fk hk Ta Tb Na Nb Oa Ob) (split_rest keeps fv fh fk hk Ta Tb Na Nb Oa Ob).
Qed.
