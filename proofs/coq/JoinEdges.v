(** * JoinEdges: joining two edges at a vertex of degree two keeps all rules (`join_edges` in dcel/operators/split_edge.rs)

    The vertex [v], at which the half-edge [e] ends and [h] begins, has no other edge. It is taken away, and so is the edge of
    [h] and its twin [k]: [e] ends where [h] did, and its twin [d] begins there. Splitting the edge of [e] makes the same again.

<<
      a ·──e──► · v ──h──► · b          a ·────e────────────► · b        along the boundary: e, next h
        ◄──d───   ◄──k────                ◄────────────d─────                            and: prev k, d
>>
*)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import Arith View Rules Map Counting Lists NewEdge ConnectCorners Core Collapse.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** What a boundary component that started at [gone] starts at instead. *)
Definition starts_instead (gone : nat) (other : link) (s : option start) : option start :=
  if s is Some (AtHalfEdge i) then (if i == gone then omap AtHalfEdge other else s) else s.

(** The view [t] without the vertex [v] and the edge of [h] and [k], which follows [e] there. *)
Definition join_edges t e v h k : view := {|
  vertex_slots := vertex_slots t;
  half_edge_slots := half_edge_slots t;
  boundary_slots := boundary_slots t;
  face_slots := face_slots t;
  is_vertex := fun i => (i != v) && is_vertex t i;
  is_half_edge := fun i => [&& i != h, i != k & is_half_edge t i];
  is_boundary := is_boundary t;
  is_face := is_face t;
  says_origin := fun i => if Some i == twin t e then origin t k else says_origin t i;
  says_twin := says_twin t;
  says_next := fun i => if i == e then (if next t h == Some k then twin t e else next t h) else
    if next t i == Some k then twin t e else says_next t i;
  says_prev := fun i => if Some i == twin t e then (if next t h == Some k then Some e else prev t k) else
    if prev t i == Some h then Some e else says_prev t i;
  says_boundary := says_boundary t;
  says_leaving := fun u => if leaving t u == Some k then twin t e else says_leaving t u;
  says_isolated := says_isolated t;
  says_boundary_face := says_boundary_face t;
  says_boundary_start := fun c => starts_instead h (Some e) (starts_instead k (twin t e) (says_boundary_start t c));
  says_boundary_place := says_boundary_place t;
  says_outer := says_outer t;
  says_inner_count := says_inner_count t;
  says_inner := says_inner t
|}.

Section JoinEdges.
Variables (t : view) (e d v h k b nh pk : nat).
Hypothesis keeps : rules t.
Hypothesis twin_e : twin t e = Some d.
Hypothesis next_e : next t e = Some h.
Hypothesis twin_h : twin t h = Some k.
Hypothesis next_k : next t k = Some d.
Hypothesis origin_h : origin t h = Some v.
Hypothesis origin_k : origin t k = Some b.
Hypothesis next_h : next t h = Some nh.
Hypothesis prev_k : prev t k = Some pk.
Hypothesis hd : h <> d.
Hypothesis he : h <> e.
Hypothesis ke : k <> e.

Notation t' := (join_edges t e v h k).
Notation inn := (inn_of t).
Let low : lower t. Proof. by move=> q _; apply: keeps. Qed.
Let map : is_map t := low_map low.
Let c : core t inn := core_of_rules keeps.
Let links_of := NewEdge.links_of keeps.
Let live_e : half_edge t e := heard_live twin_e.
Let live_h : half_edge t h := heard_live twin_h.
Let live_k : half_edge t k := heard_live next_k.

Lemma twin_of i j : twin t i = Some j -> twin t j = Some i.
Proof. by move=> T; have [+ _] := keeps L1 i (heard_live T); rewrite T. Qed.

Lemma next_of i j : next t i = Some j -> prev t j = Some i.
Proof. by move=> N; have [+ _] := keeps L2 i (heard_live N); rewrite N. Qed.

Lemma one_next i j n : next t i = Some n -> next t j = Some n -> i = j.
Proof. by move=> /next_of P /next_of; rewrite P => -[]. Qed.

Lemma one_twin i j n : twin t i = Some n -> twin t j = Some n -> i = j.
Proof. by move=> /twin_of P /twin_of; rewrite P => -[]. Qed.

Let twin_d : twin t d = Some e := twin_of twin_e.
Let twin_k : twin t k = Some h := twin_of twin_h.
Let live_d : half_edge t d := heard_live twin_d.

Lemma next_pk : next t pk = Some k.
Proof. by have [_ +] := keeps L2 k live_k; rewrite prev_k. Qed.

Lemma e_not_d : e <> d. Proof. by move=> E; have [_ n] := keeps L1 e live_e; apply: n; rewrite twin_e E. Qed.
Lemma h_not_k : h <> k. Proof. by move=> E; have [_ n] := keeps L1 h live_h; apply: n; rewrite twin_h E. Qed.
Lemma k_not_d : k <> d. Proof. by move=> E; apply: he; apply: (one_twin twin_h); rewrite E. Qed.

Lemma origin_d : origin t d = Some v.
Proof. by have := keeps L3 e live_e; rewrite next_e twin_e /= => <-. Qed.

(** Around [v] are [d] and [h] alone. *)
Lemma around_v i : origin t i = Some v -> i = d \/ i = h.
Proof.
move=> O; have [m] : on_orbit (turn t) d i by apply/(keeps V2 d i live_d (heard_live O)); rewrite O origin_d.
elim: m i {O} => [|m IH] i /=; first by case=> <-; left.
case E: (iter m _ _) => [u|] //=; rewrite /turn; case: (IH u E) => ->.
  by rewrite twin_d /= next_e => -[<-]; right.
by rewrite twin_h /= next_k => -[<-]; left.
Qed.

Lemma b_not_v : b <> v.
Proof. by move=> E; case: (@around_v k) => [|/k_not_d|/esym/h_not_k] //; rewrite origin_k E. Qed.

(** ** What the view says *)

Lemma vertexE i : vertex t' i = (i != v) && vertex t i. Proof. by rewrite /vertex /= andbCA. Qed.
Lemma half_edgeE i : half_edge t' i = [&& i != h, i != k & half_edge t i].
Proof. by rewrite /half_edge /=; case: (i != h); case: (i != k); rewrite /= ?andbF. Qed.

Lemma leftP i : half_edge t' i -> [/\ half_edge t i, i <> h & i <> k].
Proof. by rewrite half_edgeE => /and3P[/eqP ih /eqP ik li]. Qed.
Lemma is_left i : half_edge t i -> i <> h -> i <> k -> half_edge t' i.
Proof. by move=> li /eqP ih /eqP ik; rewrite half_edgeE ih ik. Qed.

Lemma someE (i j : nat) : (Some i == Some j) = (i == j). Proof. by []. Qed.

Lemma originE i : half_edge t' i -> origin t' i = if i == d then Some b else origin t i.
Proof.
move=> l; have [li _ _] := leftP l; rewrite {1}/origin /heard l /= twin_e someE origin_k.
by case: eqP => // _; rewrite /origin /heard li.
Qed.

Lemma twinE i : half_edge t' i -> twin t' i = twin t i.
Proof. by move=> l; have [li _ _] := leftP l; rewrite /twin /heard l li. Qed.

Lemma nextE i : half_edge t' i ->
  next t' i = if i == e then (if nh == k then Some d else Some nh) else if i == pk then Some d else next t i.
Proof.
move=> l; have [li _ _] := leftP l; rewrite {1}/next /heard l /= next_h twin_e !someE; case: (i =P e) => // ie.
case: (i =P pk) => [->|ip]; first by rewrite next_pk eqxx.
case: eqP => [N|_]; first by case: ip; apply: one_next N next_pk.
by rewrite /next /heard li.
Qed.

Lemma boundary_ofE i : half_edge t' i -> boundary_of t' i = boundary_of t i.
Proof. by move=> l; have [li _ _] := leftP l; rewrite /boundary_of /heard l li. Qed.

Lemma isolated_v : isolated t v = None.
Proof. by case I: (isolated t v) => [x|] //; have [/(_ h live_h)] := core_isolated c I; rewrite origin_h. Qed.

Lemma isolatedE u : isolated t' u = isolated t u.
Proof.
rewrite {1}/isolated /heard vertexE /=; case: eqP => [->|_] /=; first by rewrite isolated_v.
by rewrite /isolated /heard.
Qed.

Lemma live_e' : half_edge t' e. Proof. by apply: is_left => //; apply: nesym. Qed.
Lemma live_d' : half_edge t' d. Proof. by apply: is_left => //; apply: nesym => //; apply: k_not_d. Qed.

(** ** Half-edges *)

Lemma nh_live : half_edge t nh. Proof. by have [_ _ [g + l] _ _] := links_of live_h; rewrite next_h => -[->]. Qed.
Lemma nh_not_h : nh <> h. Proof. by move=> E; apply: he; apply: one_next next_e; rewrite next_h E. Qed.

(** Where a half-edge ends that is not [e] or [h] is not [v]. *)
Lemma twin_left i g : half_edge t' i -> twin t i = Some g -> half_edge t' g.
Proof.
move=> l T; have [li ih ik] := leftP l; have lg : half_edge t g := heard_live (twin_of T); apply: is_left => // E.
  by apply: ik; apply: one_twin T _; rewrite E.
by apply: ih; apply: one_twin T _; rewrite E.
Qed.

Lemma next_some i : half_edge t' i -> exists2 n, next t' i = Some n & half_edge t' n.
Proof.
move=> l; have [li ih ik] := leftP l; rewrite nextE //; case: (i =P e) => [_|ie].
  case: (nh =P k) => [_|nk]; [by exists d; [|apply: live_d']|exists nh => //].
  by apply: is_left => //; [apply: nh_live|apply: nh_not_h].
case: (i =P pk) => [_|ip]; first by exists d; [|apply: live_d'].
have [_ _ [m M lm] _ _] := links_of li; exists m => //; apply: is_left => // E.
  by apply: ie; apply: one_next next_e; rewrite M E.
by apply: ip; apply: one_next next_pk; rewrite M E.
Qed.

Lemma origin_left i u : half_edge t' i -> origin t' i = Some u -> u <> v.
Proof.
move=> l; have [li ih ik] := leftP l; rewrite originE //; case: eqP => [_ [<-]|id_ O uv]; first exact: b_not_v.
by case: (@around_v i) => //; rewrite O uv.
Qed.

Lemma join_l1 : l1_twin t'.
Proof.
move=> i l; have [li ih ik] := leftP l; rewrite twinE //; have [_ [g G lg] _ _ _] := links_of li.
by have [T n] := keeps L1 i li; split=> //; move: T; rewrite G /= twinE //; apply: twin_left G.
Qed.

Lemma join_next : forall g i, half_edge t' g -> half_edge t' i -> next t' g = next t' i -> g = i.
Proof.
have nd : nh <> d by move=> E; case: h_not_k; apply: one_next next_h _; rewrite E.
have d_no g : half_edge t' g -> next t g <> Some d by move=> /leftP[_ _ gk] N; apply: gk; apply: one_next N next_k.
have nh_no g : half_edge t' g -> next t g <> Some nh by move=> /leftP[_ gh _] N; apply: gh; apply: one_next N next_h.
have pkh : nh = k -> pk = h by move=> E; apply: one_next next_pk _; rewrite next_h E.
move=> g i lg li; have [Lg gh gk] := leftP lg; have [Li ih ik] := leftP li; rewrite !nextE //.
case: (g =P e) => [->|ge]; case: (i =P e) => [->|ie] //.
- case: (i =P pk) => [ip|_]; case: (nh =P k) => [E|_] //.
  + by case: ih; rewrite ip pkh.
  + by case=> /nd.
  + by move/esym/d_no; case.
  by move/esym/nh_no; case.
- case: (g =P pk) => [ip|_]; case: (nh =P k) => [E|_] //.
  + by case: gh; rewrite ip pkh.
  + by case=> /esym/nd.
  + by move/d_no; case.
  by move/nh_no; case.
case: (g =P pk) => [->|gp]; case: (i =P pk) => [->|ip] //; first by move/esym/d_no; case.
  by move/d_no; case.
exact: (core_next c).
Qed.

Lemma origin_nh : origin t nh = Some b.
Proof. by have := keeps L3 h live_h; rewrite next_h twin_h /= origin_k. Qed.

Lemma join_l3 : l3_target t'.
Proof.
move=> i l; have [li ih ik] := leftP l; rewrite twinE //; have [_ [g G lg] _ _ _] := links_of li.
rewrite G /= (originE (twin_left l G)); have [n N ln] := next_some l; rewrite N /= (originE ln).
have := keeps L3 i li; rewrite G /= => E; move: N; rewrite nextE //.
case: (i =P e) => [ie|ie].
  have -> : g = d by move: G; rewrite ie twin_e => -[].
  rewrite eqxx; case: (nh =P k) => [_|_] [<-]; first by rewrite eqxx.
  by case: eqP => // _; rewrite origin_nh.
have gd : (g == d) = false by apply/eqP=> gd; apply: ie; apply: one_twin G _; rewrite gd.
rewrite gd; case: (i =P pk) => [ip [<-]|ip M]; first by rewrite eqxx -E ip next_pk.
move: E; rewrite M /=; case: eqP => // nd; case: ik; apply: one_next M _; by rewrite nd.
Qed.

(** ** V2: around [b], [d] is where [k] was *)

Definition now i := if i == k then d else i.

Lemma join_turn i j : half_edge t i -> i <> d -> i <> h -> turn t i = Some j ->
  [/\ half_edge t j, j <> d, j <> h & turn t' (now i) = Some (now j)].
Proof.
move=> li id_ ih; rewrite {1}/turn /now; case: (i =P k) => [->|ik].
  rewrite twin_k /= next_h => -[<-]; split; [exact: nh_live|by apply: nesym => E; case: h_not_k; apply: one_next next_h _; rewrite -E|exact: nh_not_h|].
  by rewrite /turn twinE ?live_d' // twin_d /= nextE ?live_e' // eqxx; case: eqP.
case G: (twin t i) => [g|] //= N; have lg := heard_live N; have [_ _ [j' + lj] _ _] := links_of lg; rewrite N => -[jj].
rewrite -jj in lj; have jd : j <> d.
  by move=> jd; case: ih; apply: one_twin G _; rewrite twin_h; congr Some; apply: one_next next_k _; rewrite N jd.
have jh : j <> h.
  by move=> jh; case: id_; apply: one_twin G _; rewrite twin_d; congr Some; apply: one_next next_e _; rewrite N jh.
split=> //; have l : half_edge t' i by apply: is_left.
rewrite /turn twinE // G /= nextE ?(twin_left l G) //.
case: (g =P e) => [ge|_]; first by case: id_; apply: one_twin G _; rewrite ge.
case: (g =P pk) => [gp|gp]; first by move: N; rewrite gp next_pk => -[<-]; rewrite eqxx.
by rewrite N; case: eqP => // jk; case: gp; apply: one_next next_pk; rewrite N jk.
Qed.

Lemma join_rotation g i : half_edge t' g -> half_edge t' i -> origin t' g = origin t' i -> on_orbit (turn t') g i.
Proof.
pose was i := if i == d then k else i.
have wasE j : half_edge t' j -> [/\ half_edge t (was j), was j <> d, was j <> h, now (was j) = j & origin t' j = origin t (was j)].
  move=> l; have [lj jh jk] := leftP l; rewrite originE // /was /now; case: (j =P d) => [->|jd].
    by rewrite eqxx origin_k; split=> //; [apply: k_not_d|apply/nesym/h_not_k].
  by split=> //; case: eqP.
move=> /wasE[lg gd gh ng Og] /wasE[li _ _ ni Oi]; rewrite Og Oi => /(core_rotation c lg li).
case=> m; rewrite -{2}ng -{2}ni; move: (was g) (was i) lg gd gh => {g i ng Og li ni Oi} x y lx xd xh.
suff: iter m (obind (turn t)) (Some x) = Some y -> [/\ half_edge t y, y <> d, y <> h & on_orbit (turn t') (now x) (now y)].
  by move=> H E; have [] := H E.
elim: m y => [|m IH] y /=; first by case=> <-; split=> //; apply: orbit_refl.
case E: (iter m _ _) => [u|] //= T; have [lu ud uh C] := IH u E; have [ly yd yh T'] := join_turn lu ud uh T.
by split=> //; apply: orbit_step C T'.
Qed.

(** ** Cycles *)

Lemma join_side i : half_edge t' i -> next t' i >>= boundary_of t' = boundary_of t' i.
Proof.
move=> l; have [n N ln] := next_some l; rewrite N /= !boundary_ofE //; move: N; rewrite nextE //.
have same := next_boundary keeps; have Bd := same _ _ next_k; case: (i =P e) => [->|_].
  case: (nh =P k) => [E|_] [<-]; last by rewrite (same _ _ next_h) (same _ _ next_e).
  by rewrite Bd -E (same _ _ next_h) (same _ _ next_e).
case: (i =P pk) => [-> [<-]|_]; [by rewrite Bd (same _ _ next_pk)|exact: same].
Qed.

(** The half-edge that has the side of one. *)
Definition side_of i := if i == h then e else if i == k then d else i.

Lemma side_left i : half_edge t i -> half_edge t' (side_of i).
Proof.
by rewrite /side_of; case: (i =P h) => [_ _|ih]; [apply: live_e'|case: (i =P k) => [_ _|ik li]; [apply: live_d'|apply: is_left]].
Qed.

Lemma side_boundary i : half_edge t i -> boundary_of t' (side_of i) = boundary_of t i.
Proof.
move=> li; rewrite (boundary_ofE (side_left li)) /side_of; have same := next_boundary keeps.
by case: (i =P h) => [->|_]; [rewrite (same _ _ next_e)|case: (i =P k) => [->|//]; rewrite (same _ _ next_k)].
Qed.

Lemma side_next i j z : half_edge t i -> next t i = Some j -> on_cycle t' z (side_of i) -> on_cycle t' z (side_of j).
Proof.
have e_on : next t' e = Some (side_of nh).
  rewrite nextE ?live_e' // eqxx /side_of; case: (nh =P h) => [/nh_not_h //|_]; by case: ifP.
move=> li N; rewrite {1}/side_of; case: (i =P h) => [ih|ih] C.
  by move: N; rewrite ih next_h => -[<-]; apply: orbit_step C e_on.
move: C; case: (i =P k) => [ik|ik] C.
  move: N C; rewrite ik next_k => -[<-]; rewrite /side_of; case: eqP => [dh|_]; first by case: hd.
  by case: eqP => // /esym/k_not_d.
case: (i =P e) => [ie|ie].
  by move: N C; rewrite ie next_e => -[<-]; rewrite /side_of eqxx.
have l : half_edge t' i by apply: is_left.
have N' : next t' i = if i == pk then Some d else next t i by rewrite nextE // (introF eqP ie).
apply: orbit_step C _; rewrite N' /side_of; case: (i =P pk) => [ip|ip].
  move: N; rewrite ip next_pk => -[<-]; rewrite eqxx; case: eqP => // /esym/h_not_k [].
rewrite N; case: (j =P h) => [jh|_]; first by case: ie; apply: one_next next_e; rewrite N jh.
by case: (j =P k) => [jk|//]; case: ip; apply: one_next next_pk; rewrite N jk.
Qed.

Lemma join_cycle g i : half_edge t' g -> half_edge t' i -> boundary_of t' g = boundary_of t' i -> on_cycle t' g i.
Proof.
move=> lg li; have [Lg gh gk] := leftP lg; have [Li ih ik] := leftP li; rewrite !boundary_ofE // => B.
have own j : j <> h -> j <> k -> side_of j = j by rewrite /side_of => /eqP/negPf-> /eqP/negPf->.
suff H j : on_cycle t g j -> on_cycle t' (side_of g) (side_of j) by have := H i (core_cycle c Lg Li B); rewrite !own.
case=> m; elim: m j => [|m IH] j /=; first by case=> <-; apply: orbit_refl.
by case E: (iter m _ _) => [u|] //= N; exact: side_next (heard_live N) N (IH u E).
Qed.

(** ** Vertices, boundary components and faces *)

Lemma bare_left u : u <> v -> bare t' u <-> bare t u.
Proof.
move=> uv; split=> B i li O.
  case: (i =P k) => [ik|ik].
    by apply: (B d live_d'); rewrite originE ?live_d' // eqxx -origin_k -ik.
  have ih : i <> h by move=> ih; move: O; rewrite ih origin_h => -[/esym].
  have l : half_edge t' i by apply: is_left.
  apply: (B i l); rewrite originE //; case: (i =P d) => // id_.
  by move: O; rewrite id_ origin_d => -[/esym].
have [Li _ _] := leftP li; move: O; rewrite originE //; case: eqP => [_ bu|_]; last exact: B.
by apply: (B k live_k); rewrite origin_k.
Qed.

(** The vertex that a vertex hangs at then. *)
Definition col u := if u == v then b else u.

Lemma col_other u : u <> v -> col u = u. Proof. by rewrite /col => /eqP/negPf->. Qed.

Lemma target_e : target t' e = Some b.
Proof. by rewrite /target twinE ?live_e' // twin_e /= originE ?live_d' // eqxx. Qed.

Lemma join_connected u w : connected t u w -> connected t' (col u) (col w).
Proof.
elim=> [|i x y _ IH X Y]; first exact: connected_self.
have li := heard_live X; case: (i =P h) => [ih|ih].
  move: X Y; rewrite ih /target twin_h /= origin_h origin_k => -[xv] [yb]; rewrite -xv -yb in IH *.
  by move: IH; rewrite /col eqxx (introF eqP b_not_v).
case: (i =P k) => [ik|ik].
  move: X Y; rewrite ik /target twin_k /= origin_h origin_k => -[xb] [yv]; rewrite -xb -yv in IH *.
  by move: IH; rewrite /col eqxx (introF eqP b_not_v).
have l : half_edge t' i by apply: is_left.
have [_ [g G _] _ _ _] := links_of li; have lg := twin_left l G; move: Y; rewrite /target G /= => Y.
have end_ j z : half_edge t' j -> origin t j = Some z -> origin t' j = Some (col z).
  move=> lj O; rewrite originE //; case: (j =P d) => [jd|jd]; first by move: O; rewrite jd origin_d /col => -[<-]; rewrite eqxx.
  rewrite O col_other // => zv; have [_ jh _] := leftP lj.
  by case: (@around_v j) => //; rewrite O zv.
by apply: connected_edge IH (end_ i x l X) _; rewrite /target twinE // G /=; apply: end_.
Qed.

Lemma join_passes x u : passes t x u -> exists2 w, passes t' x w & connected t' (col u) w.
Proof.
case=> [[i B O]|I]; last first.
  have uv : u <> v by move=> uv; move: I; rewrite uv isolated_v.
  by exists u; [right; rewrite isolatedE|rewrite col_other //; apply: connected_self].
have li := heard_live B; case: (i =P h) => [ih|ih].
  have [[w W _] _ _ _ _] := links_of live_e; have l := live_e'.
  have W' : origin t' e = Some w by rewrite originE //; case: eqP => // /e_not_d.
  exists w; first by left; exists e; rewrite // boundary_ofE // -(next_boundary keeps next_e) -ih.
  move: O; rewrite ih origin_h /col => -[<-]; rewrite eqxx; apply: (connected_back join_l1).
  exact: connected_edge (connected_self _ _) W' target_e.
have [j [lj Bj Oj]] : exists j, [/\ half_edge t' j, boundary_of t j = Some x & origin t' j = Some (col u)].
  case: (i =P k) => [ik|ik].
    exists d; rewrite originE ?live_d' // eqxx; split=> //.
      by rewrite (next_boundary keeps next_k) -ik.
    by move: O; rewrite ik origin_k => -[<-]; rewrite col_other //; apply: b_not_v.
  have l : half_edge t' i by apply: is_left.
  exists i; split=> //; rewrite originE //; case: (i =P d) => [id_|id_].
    by move: O; rewrite id_ origin_d /col => -[<-]; rewrite eqxx.
  by rewrite O col_other // => uv; case: (@around_v i) => //; rewrite O uv.
by exists (col u); [left; exists j; rewrite // boundary_ofE|apply: connected_self].
Qed.

Lemma join_counts : core_count t' inn.
Proof.
have [vs [hs [fs [bs [Hv Hh Hf Hb eq]]]]] := core_counts c.
have lv : vertex t v by have [[u + lu] _ _ _ _] := links_of live_h; rewrite origin_h => -[->].
exists (rem v vs), (rem k (rem h hs)), fs, bs; split=> //.
- apply: lists_iff (lists_rem v Hv) => u; rewrite vertexE.
  by split=> [[/eqP->]|/andP[/eqP]].
- apply: lists_iff (lists_rem k (lists_rem h Hh)) => i.
  by split=> [[ik [ih li]]|/leftP[]]; [apply: is_left|].
have k_left := conj (nesym h_not_k) live_k; move: eq.
by rewrite (size_lists_rem Hv lv) (size_lists_rem Hh live_h) (size_lists_rem (lists_rem h Hh) k_left); arith.
Qed.

Lemma join_core : core t' inn.
Proof.
split.
- move=> i l; have [li _ _] := leftP l; have [[u U lu] [g G _] _ _ [x B lx]] := links_of li.
  split; last by exists x; rewrite ?boundary_ofE.
  + have [w W lw] : exists2 w, origin t' i = Some w & vertex t w.
      rewrite originE //; case: eqP => _; [exists b|exists u] => //.
      by have [[w + lw] _ _ _ _] := links_of live_k; rewrite origin_k => -[->].
    by exists w => //; rewrite vertexE lw andbT; apply/eqP/(origin_left l).
  + by exists g; [rewrite twinE|apply: twin_left G].
  exact: next_some.
- exact: join_l1.
- exact: join_next.
- exact: join_l3.
- exact: join_rotation.
- exact: join_side.
- exact: join_cycle.
- move=> u; rewrite vertexE isolatedE => /andP[/eqP uv lu] /(bare_left uv); exact: (core_bare c).
- move=> u x; rewrite isolatedE => /[dup] I /(core_isolated c)[B Ix no].
  have uv : u <> v by move=> uv; move: I; rewrite uv isolated_v.
  split=> //; first exact/bare_left.
  by move=> i E; have l := heard_live E; apply: (no i); rewrite -boundary_ofE.
- by move=> u w x; rewrite !isolatedE; apply: (core_one c).
- by move=> x /(core_used c)[u /join_passes[w P _]]; exists w.
- exact: (core_face c).
- exact: (core_outer c).
- exact: (core_unbounded c).
- apply: (collapse_inside c _ join_connected join_passes) => // u; rewrite vertexE => /andP[/eqP uv lu].
  by rewrite col_other.
- by apply: (collapse_out c join_l1 join_connected join_passes).
exact: join_counts.
Qed.

(** ** The rest *)

Lemma prevE i : half_edge t' i -> prev t' i = if i == d then (if nh == k then Some e else Some pk) else
  if prev t i == Some h then Some e else prev t i.
Proof.
move=> l; have [li _ _] := leftP l; rewrite {1}/prev /heard l /= next_h twin_e !someE prev_k; case: eqP => // _.
by case: ifP => // _; rewrite /prev /heard li.
Qed.

Lemma join_prev i : half_edge t' i -> leads_to (half_edge t') (prev t' i) /\ prev t' i >>= next t' = Some i.
Proof.
move=> l; have [li ih ik] := leftP l; have [_ _ _ [p P lp] _] := links_of li.
have N : next t p = Some i by have [_ +] := keeps L2 i li; rewrite P.
rewrite prevE // P someE; case: (i =P d) => [->|id_].
  case: (nh =P k) => [E|E] /=; first by split; [exists e; rewrite ?live_e'|rewrite nextE ?live_e' // eqxx E eqxx].
  have lpk : half_edge t' pk.
    apply: is_left; first exact: heard_live next_pk.
      by move=> F; apply: E; move: next_pk; rewrite F next_h => -[].
    by move=> F; apply: k_not_d; move: next_pk; rewrite F next_k => -[].
  split; first by exists pk.
  by rewrite nextE // eqxx; case: eqP => // F; case: h_not_k; move: next_pk; rewrite F next_e => -[].
case: (p =P h) => [ph|ph] /=.
  move: N; rewrite ph next_h => -[E]; split; first by exists e; rewrite ?live_e'.
  by rewrite nextE ?live_e' // eqxx E (introF eqP ik).
have l' : half_edge t' p by apply: is_left => // pk_; case: id_; move: N; rewrite pk_ next_k => -[].
split; first by exists p.
rewrite nextE //; case: (p =P e) => [pe|_]; first by case: ih; move: N; rewrite pe next_e => -[].
by case: (p =P pk) => [pp|//]; case: ik; move: N; rewrite pp next_pk => -[].
Qed.

Lemma join_leaving u : vertex t' u ->
  (exists2 g, leaving t' u = Some g & origin t' g = Some u) \/ leaving t' u = None /\ bare t' u.
Proof.
move=> lu'; have : (u != v) && vertex t u by rewrite -vertexE.
case/andP=> /eqP uv lu; have -> : leaving t' u = if leaving t u == Some k then Some d else leaving t u.
  by rewrite {1}/leaving /heard lu' /= twin_e; case: ifP => // _; rewrite /leaving /heard lu.
case: (rest_leaving (rest_of_rules keeps) lu) => [[g L O]|[-> B]]; last by right; split=> //; apply/bare_left.
left; rewrite L someE; case: (g =P k) => [gk|gk].
  by exists d; rewrite // originE ?live_d' // eqxx -origin_k -gk.
have gv : origin t g <> Some v by rewrite O => -[].
have lg : half_edge t' g by apply: is_left gk; [apply: heard_live O|move=> gh; apply: gv; rewrite gh].
by exists g; rewrite // originE //; case: (g =P d) => // gd; case: gv; rewrite gd origin_d.
Qed.

Lemma join_start x : boundary t' x ->
  (exists2 g, boundary_start t' x = Some (AtHalfEdge g) & boundary_of t' g = Some x) \/
  exists2 u, boundary_start t' x = Some (AtVertex u) & isolated t' u = Some x.
Proof.
move=> lx; have -> : boundary_start t' x = starts_instead h (Some e) (starts_instead k (Some d) (boundary_start t x)).
  by rewrite {1}/boundary_start /heard lx /= twin_e /boundary_start /heard (lx : boundary t x).
case: (rest_start (rest_of_rules keeps) lx) => [[g -> B]|[u -> I]]; [left|right]; last by exists u; rewrite ?isolatedE.
exists (side_of g); last by rewrite side_boundary // (heard_live B).
rewrite /side_of /=; case: (g =P k) => [->|_] /=; last by case: eqP.
by case: eqP => [dh|_]; [case: hd|case: eqP => // /esym/h_not_k].
Qed.

Lemma join_rest : rest t' inn.
Proof.
have R := rest_of_rules keeps; split.
- exact: join_prev.
- exact: join_leaving.
- exact: join_start.
- exact: (rest_place R).
- exact: (rest_listed R).
exact: (rest_lists R).
Qed.

End JoinEdges.

(** What makes joining right: [e] ends at a vertex with no other edge than that of [h], which is another one. *)
Definition is_joint t e v h k := [&& next t e == Some h, twin t h == Some k, next t k == twin t e, origin t h == Some v,
  Some h != twin t e, h != e & k != e].

(** If all rules held before, they hold after. *)
Theorem join_edges_keeps_rules t e v h k : is_joint t e v h k -> rules t -> rules (join_edges t e v h k).
Proof.
case/and5P=> /eqP N /eqP T /eqP K /eqP O /and3P[/eqP hd /eqP he /eqP ke] keeps.
have [_ [d D _] _ _ _] := links_of keeps (heard_live N); rewrite D in K hd.
have [_ _ [nh H _] _ _] := links_of keeps (heard_live T).
have [[b B _] _ _ [pk P _] _] := links_of keeps (heard_live K).
have {}hd : h <> d by move=> E; apply: hd; rewrite E.
exact: core_rules (join_core keeps D N T K O B H P hd he ke) (join_rest keeps D N T K O B H P hd he ke).
Qed.
