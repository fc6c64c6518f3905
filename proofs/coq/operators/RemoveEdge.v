(** * RemoveEdge: taking out an edge (dcel/operators/remove.rs)

    The edge of the half-edge [n] and its twin [m] is taken out. What went on along it goes past it: around the vertex where [n]
    begins, the half-edge before [n] is followed by the one after [n]. Nothing else changes yet: whether two boundary components
    become one (RemoveMerge.v) or one becomes two (RemovePart.v) is settled afterwards.

<<
       ──────► · ──next m──►             ──────► · ──next m──►
              n│▲
               ▼│m                ──►
       ◄─next n─ · ◄───────              ◄─next n─ · ◄───────
>>

    An end that has no other edge becomes an isolated vertex. *)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import Arith View Rules Loops LoopsProof Map Counting Lists NewEdge ConnectCorners Core Collapse.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** The place to which [step] leads past the edge of [n] and [m]: [x] itself, if it is of another edge, or what follows around its vertex. *)
Definition past (step : nat -> link) n m x : link :=
  if x == n then (if step m == Some m then step n else step m) else
  if x == m then (if step n == Some n then step m else step n) else Some x.

(** Another half-edge that leaves the vertex where [x] begins, [x] being [n] or [m], if there is one. *)
Definition corner t n m x : link :=
  let l := past (next t) n m x in if (l == Some n) || (l == Some m) then None else l.

(** The start of the rest around the end of [x]: at a half-edge that leaves it, or at the vertex. *)
Definition start_left t n m x : option start :=
  if corner t n m x is Some y then Some (AtHalfEdge y) else omap AtVertex (origin t x).

Definition begins_at t x u := origin t x == Some u.

(** The view [t] without the edge of [n] and [m]. An end that becomes isolated is the boundary component [at_n], where [n]
    began, or [at_m]. *)
Definition take_out t n m at_n at_m : view := {|
  vertex_slots := vertex_slots t;
  half_edge_slots := half_edge_slots t;
  boundary_slots := boundary_slots t;
  face_slots := face_slots t;
  is_vertex := is_vertex t;
  is_half_edge := fun i => [&& i != n, i != m & is_half_edge t i];
  is_boundary := is_boundary t;
  is_face := is_face t;
  says_origin := says_origin t;
  says_twin := says_twin t;
  says_next := fun i => next t i >>= past (next t) n m;
  says_prev := fun i => prev t i >>= past (prev t) n m;
  says_boundary := says_boundary t;
  says_leaving := fun u => if begins_at t n u then corner t n m n else
    if begins_at t m u then corner t n m m else says_leaving t u;
  says_isolated := fun u => if begins_at t n u && ~~ isSome (corner t n m n) then Some at_n else
    if begins_at t m u && ~~ isSome (corner t n m m) then Some at_m else says_isolated t u;
  says_boundary_face := says_boundary_face t;
  says_boundary_start := says_boundary_start t;
  says_boundary_place := says_boundary_place t;
  says_outer := says_outer t;
  says_inner_count := says_inner_count t;
  says_inner := says_inner t
|}.

(** [t'] is [t] without this edge, as far as half-edges and vertices go. *)
Record taken_out t t' n m at_n at_m : Prop := TakenOut {
  half_edgeE : forall i, half_edge t' i = [&& i != n, i != m & half_edge t i];
  originE : forall i, half_edge t' i -> origin t' i = origin t i;
  twinE : forall i, half_edge t' i -> twin t' i = twin t i;
  nextE : forall i, half_edge t' i -> next t' i = next t i >>= past (next t) n m;
  prevE : forall i, half_edge t' i -> prev t' i = prev t i >>= past (prev t) n m;
  vertexE : forall u, vertex t' u = vertex t u;
  leavingE : forall u, vertex t u -> leaving t' u = if begins_at t n u then corner t n m n else
    if begins_at t m u then corner t n m m else leaving t u;
  isolatedE : forall u, vertex t u -> isolated t' u = if begins_at t n u && ~~ isSome (corner t n m n) then Some at_n else
    if begins_at t m u && ~~ isSome (corner t n m m) then Some at_m else isolated t u
}.

Lemma take_out_taken_out t n m at_n at_m : taken_out t (take_out t n m at_n at_m) n m at_n at_m.
Proof.
have halfE i : half_edge (take_out t n m at_n at_m) i = [&& i != n, i != m & half_edge t i].
  by rewrite /half_edge /=; case: (i != n); case: (i != m); rewrite /= ?andbF.
have down i : half_edge (take_out t n m at_n at_m) i -> half_edge t i by rewrite halfE => /and3P[].
split=> // i l; rewrite [LHS]/heard ?l //=.
- by rewrite /origin /heard (down i l).
- by rewrite /twin /heard (down i l).
- by rewrite -[vertex _ i]/(vertex t i) l; do 2?case: ifP => //; rewrite /leaving /heard l.
by rewrite -[vertex _ i]/(vertex t i) l; do 2?case: ifP => //; rewrite /isolated /heard l.
Qed.

(** If each step can be taken back, and each leads to something live, an orbit can be gone the other way round. *)
Lemma orbit_back k (live : nat -> bool) (f : nat -> link) x y : (forall i, live i -> i < k) ->
  (forall i, live i -> exists2 j, f i = Some j & live j) -> (forall i j, live i -> live j -> f i = f j -> i = j) ->
  live x -> on_orbit f x y -> on_orbit f y x.
Proof.
move=> below total inj lx O; have [a ax] := slotP below lx; rewrite -ax in O *.
have injective_step : injective (step f : slot k live -> slot k live).
  by move=> b c bc; apply/num_inj/inj; rewrite ?num_live // !(says_step below total) bc.
have [b by_] := slotP below (on_orbit_live below total O); rewrite -by_ in O *.
by move: O; rewrite !(on_orbit_step below total) fconnect_sym.
Qed.

(** [prev] is right if it takes back each step along [next]. *)
Lemma prev_of_next t' i : (forall i, half_edge t' i -> exists2 y, next t' i = Some y & half_edge t' y) ->
  (forall i y, half_edge t' i -> next t' i = Some y -> prev t' y = Some i) ->
  half_edge t' i -> leads_to (half_edge t') (prev t' i) /\ prev t' i >>= next t' = Some i.
Proof.
move=> total back l; have [y Y ly] := total i l; have C : on_cycle t' y i.
  apply: (orbit_back (@half_edge_below t') total _ l) (orbit_step (orbit_refl _ _) Y) => g j lg lj.
  by have [x X _] := total g lg; rewrite X => /esym/(back j x lj); rewrite (back g x lg X) => -[].
suff [x X lx] : exists2 x, next t' x = Some i & half_edge t' x by rewrite (back x i lx X) /=; split=> //; exists x.
case: C => -[|k] /=; first by case=> yi; exists i; rewrite // Y yi.
by case E: (iter k _ _) => [u|] //= U; exists u => //; apply: heard_live U.
Qed.

Section TakenOut.
Variables (t t' : view) (n m at_n at_m : nat).
Hypothesis keeps : rules t.
Hypothesis twin_n : twin t n = Some m.
Hypothesis out : taken_out t t' n m at_n at_m.

Notation past := (past (next t) n m).
Notation corner := (corner t n m).
Let half_edgeE := half_edgeE out.
Let originE := originE out.
Let twinE := twinE out.
Let nextE := nextE out.
Let prevE := prevE out.
Let links_of := NewEdge.links_of keeps.

Lemma twin_of i j : twin t i = Some j -> twin t j = Some i.
Proof. by move=> T; have [+ _] := keeps L1 i (heard_live T); rewrite T. Qed.
Lemma prev_of i j : next t i = Some j -> prev t j = Some i.
Proof. by move=> N; have [+ _] := keeps L2 i (heard_live N); rewrite N. Qed.
Lemma one_next i j x : next t i = Some x -> next t j = Some x -> i = j.
Proof. by move=> /prev_of P /prev_of; rewrite P => -[]. Qed.
Lemma one_twin i j x : twin t i = Some x -> twin t j = Some x -> i = j.
Proof. by move=> /twin_of P /twin_of; rewrite P => -[]. Qed.

Let twin_m : twin t m = Some n := twin_of twin_n.
Let live_n : half_edge t n := heard_live twin_n.
Let live_m : half_edge t m := heard_live twin_m.

Lemma n_not_m : n <> m. Proof. by move=> E; have [_ no] := keeps L1 n live_n; apply: no; rewrite twin_n E. Qed.
Let m_not_n : (m == n) = false. Proof. by apply/eqP/nesym/n_not_m. Qed.
Let n_not_m' : (n == m) = false. Proof. by apply/eqP/n_not_m. Qed.

Lemma leftP i : half_edge t' i -> [/\ half_edge t i, i <> n & i <> m].
Proof. by rewrite half_edgeE => /and3P[/eqP i_n /eqP im li]. Qed.
Lemma is_left i : half_edge t i -> i <> n -> i <> m -> half_edge t' i.
Proof. by move=> li /eqP i_n /eqP im; rewrite half_edgeE i_n im. Qed.

Lemma twin_left i g : half_edge t' i -> twin t i = Some g -> half_edge t' g.
Proof.
move=> /leftP[li i_n im] T; apply: is_left => [|E|E]; first exact: heard_live (twin_of T).
  by apply: im; apply: one_twin T _; rewrite E.
by apply: i_n; apply: one_twin T _; rewrite E.
Qed.

Lemma past_n : past n = if next t m == Some m then next t n else next t m.
Proof. by rewrite /RemoveEdge.past eqxx. Qed.
Lemma past_m : past m = if next t n == Some n then next t m else next t n.
Proof. by rewrite /RemoveEdge.past m_not_n eqxx. Qed.
Lemma past_left i : half_edge t' i -> past i = Some i.
Proof. by case/leftP=> _ i_n im; rewrite /RemoveEdge.past (introF eqP i_n) (introF eqP im). Qed.

Lemma next_some i : half_edge t i -> exists2 x, next t i = Some x & half_edge t x.
Proof. by case/links_of. Qed.

(** Past the edge of [n] and [m] is another half-edge, where one comes from another. *)
Lemma past_some i x : half_edge t' i -> next t i = Some x -> exists2 y, past x = Some y & half_edge t' y.
Proof.
move=> /leftP[li i_n im] N; have [a A la] := next_some live_n; have [b B lb] := next_some live_m.
case: (x =P n) => [xn|xn]; last case: (x =P m) => [xm|xm].
- rewrite xn past_n A B in N *; case: eqP => [[bm]|bm].
    exists a => //; apply: is_left => // E; first by apply: i_n; apply: one_next N _; rewrite A E.
    by apply: n_not_m; apply: one_next A _; rewrite B bm E.
  exists b => //; apply: is_left => // E; last by apply: bm; rewrite E.
  by apply: im; apply: one_next N _; rewrite B E.
- rewrite xm past_m A B in N *; case: eqP => [[an]|an].
    exists b => //; apply: is_left => // E; last by apply: im; apply: one_next N _; rewrite B E.
    by apply: n_not_m; apply: one_next A _; rewrite B an E.
  exists a => //; apply: is_left => // E; first by apply: an; rewrite E.
  by apply: i_n; apply: one_next N _; rewrite A E.
have lx : half_edge t' x by apply: is_left => //; have [y + ly] := next_some li; rewrite N => -[->].
by exists x; rewrite ?past_left.
Qed.

Lemma next_left i : half_edge t' i -> exists2 y, next t' i = Some y & half_edge t' y.
Proof. by move=> l; have [li _ _] := leftP l; have [x N _] := next_some li; rewrite nextE // N; apply: past_some N. Qed.

(** ** L1, L2, L3 *)

Lemma out_l1 : l1_twin t'.
Proof.
move=> i l; have [li _ _] := leftP l; rewrite twinE //; have [_ [g G lg] _ _ _] := links_of li.
by have [T no] := keeps L1 i li; split=> //; move: T; rewrite G /= twinE //; apply: twin_left G.
Qed.

Lemma out_prev_next i y : half_edge t' i -> next t' i = Some y -> prev t' y = Some i.
Proof.
move=> l; have [li i_n im] := leftP l; have [x N lx] := next_some li; have [a A la] := next_some live_n.
have [b B lb] := next_some live_m; have P := prev_of N; rewrite nextE // N /=.
have same z p : half_edge t' z -> prev t z = Some p -> prev t' z = RemoveEdge.past (prev t) n m p.
  by move=> lz E; rewrite prevE // E.
have [y' Y ly] := past_some l N; rewrite Y => -[yy]; rewrite -yy; move: Y.
have keep : RemoveEdge.past (prev t) n m i = Some i.
  by rewrite /RemoveEdge.past (introF eqP i_n) (introF eqP im).
have [Pa Pb] := (prev_of A, prev_of B); case: (x =P n) => [xn|xn]; last case: (x =P m) => [xm|xm].
- rewrite xn past_n A B in P *; case: eqP => [[bm]|bm] [E].
    rewrite -E in ly *; rewrite (same a n) // /RemoveEdge.past eqxx.
    by move: Pb; rewrite bm => ->; rewrite eqxx P.
  rewrite -E in ly *; rewrite (same b m) // /RemoveEdge.past m_not_n eqxx P.
  by case: eqP => [[]|//]; move/i_n.
- rewrite xm past_m A B in P *; case: eqP => [[an]|an] [E].
    rewrite -E in ly *; rewrite (same b m) // /RemoveEdge.past m_not_n eqxx.
    by move: Pa; rewrite an => ->; rewrite eqxx P.
  rewrite -E in ly *; rewrite (same a n) // /RemoveEdge.past eqxx P.
  by case: eqP => [[]|//]; move/im.
have lx' : half_edge t' x by apply: is_left.
by rewrite past_left // => -[E]; rewrite -E (same x i).
Qed.

Lemma out_next i j : half_edge t' i -> half_edge t' j -> next t' i = next t' j -> i = j.
Proof.
move=> li lj; have [y Y _] := next_left li; rewrite Y => /esym/(out_prev_next lj).
by rewrite (out_prev_next li Y) => -[].
Qed.

Lemma cycle_back i j : half_edge t' i -> on_cycle t' i j -> on_cycle t' j i.
Proof. exact: orbit_back (@half_edge_below t') next_left out_next. Qed.

Lemma out_prev i : half_edge t' i -> leads_to (half_edge t') (prev t' i) /\ prev t' i >>= next t' = Some i.
Proof. exact: prev_of_next next_left out_prev_next. Qed.

Lemma origin_next i x : next t i = Some x -> origin t x = target t i.
Proof. by move=> N; have := keeps L3 i (heard_live N); rewrite N. Qed.

Lemma target_n : target t n = origin t m. Proof. by rewrite /target twin_n. Qed.
Lemma target_m : target t m = origin t n. Proof. by rewrite /target twin_m. Qed.

Lemma past_origin x y : past x = Some y -> origin t y = origin t x.
Proof.
case: (x =P n) => [->|xn]; last case: (x =P m) => [->|xm].
- rewrite past_n; case: eqP => [E|_] /origin_next ->; last exact: target_m.
  by rewrite target_n (origin_next E) target_m.
- rewrite past_m; case: eqP => [E|_] /origin_next ->; last exact: target_n.
  by rewrite target_m (origin_next E) target_n.
by rewrite /RemoveEdge.past (introF eqP xn) (introF eqP xm) => -[->].
Qed.

Lemma out_l3 : l3_target t'.
Proof.
move=> i l; have [li _ _] := leftP l; have [x N _] := next_some li; have [y Y ly] := past_some l N.
have [_ [g G _] _ _ _] := links_of li; have lg := twin_left l G.
by rewrite twinE // G nextE // N /= Y /= !originE // (past_origin Y) (origin_next N) /target G.
Qed.

(** A cycle that is on neither side of the edge is as it was. *)
Lemma cycle_away i j b : boundary_of t n <> Some b -> boundary_of t m <> Some b ->
  boundary_of t i = Some b -> boundary_of t j = Some b -> on_cycle t' i j.
Proof.
move=> Bn Bm Bi Bj.
suff [] : on_cycle t' i j /\ boundary_of t j = Some b by [].
apply: (orbit_ind (P := fun u => on_cycle t' i u /\ boundary_of t u = Some b)) (cycle_of keeps Bi Bj).
  by split=> //; apply: orbit_refl.
move=> u w [Cu Bu] N; have Bw : boundary_of t w = Some b by rewrite (next_boundary keeps N).
have away x : boundary_of t x = Some b -> x <> n /\ x <> m.
  by move=> Bx; split=> E; rewrite E in Bx; [apply: Bn|apply: Bm].
have [[un um] [wn wm]] := (away u Bu, away w Bw); split=> //.
have lu : half_edge t' u by apply: is_left => //; apply: heard_live N.
by apply: orbit_step Cu _; rewrite nextE // N /= /RemoveEdge.past (introF eqP wn) (introF eqP wm).
Qed.

(** ** V2: the edge is left out of the rotations *)

Lemma past_turn x s w : x = n \/ x = m -> past x = Some s -> half_edge t' s -> turn t x = Some w -> past w = Some s.
Proof.
have [a A la] := next_some live_n; have [b B lb] := next_some live_m.
case=> ->.
- rewrite past_n /turn twin_n /= A B; case: eqP => [[bm] [<-]|bm [<-]] ls [<-]; last exact: past_left.
  rewrite bm past_m A; case: eqP => // -[E]; by have [_ /(_ E)] := leftP ls.
rewrite past_m /turn twin_m /= A B; case: eqP => [[an] [<-]|an [<-]] ls [<-]; last exact: past_left.
rewrite an past_n B; case: eqP => // -[E]; by have [_ _ /(_ E)] := leftP ls.
Qed.

Lemma turn_left i w : half_edge t' i -> turn t i = Some w -> exists2 s, past w = Some s & half_edge t' s /\ turn t' i = Some s.
Proof.
move=> l; have [li _ _] := leftP l; have [_ [g G _] _ _ _] := links_of li; have lg := twin_left l G.
rewrite /turn G /= => N; have [s S ls] := past_some lg N; exists s => //.
by split=> //; rewrite twinE // G /= nextE // N.
Qed.

Lemma rotation_left g i : half_edge t' g -> on_orbit (turn t) g i ->
  exists s, [/\ past i = Some s, half_edge t' s & on_orbit (turn t') g s].
Proof.
move=> lg [k]; elim: k i => [|k IH] i /=; first by case=> <-; exists g; rewrite past_left //; split=> //; apply: orbit_refl.
case E: (iter k _ _) => [x|] //= T; have [s [S ls C]] := IH x E.
have [xe|[xn xm]] : (x = n \/ x = m) \/ x <> n /\ x <> m.
  by case: (x =P n) => [->|xn]; [left; left|case: (x =P m) => [->|xm]; [left; right|right]].
  by exists s; rewrite (past_turn xe S ls T).
have lx : half_edge t' x by apply: is_left => //; move: T; rewrite /turn; case G: (twin t x) => [z|] // _; apply: heard_live G.
move: S; rewrite past_left // => -[xs]; have [s' S' [ls' T']] := turn_left lx T.
by exists s'; split=> //; rewrite -xs in C; apply: orbit_step C T'.
Qed.

Lemma out_rotation g i : half_edge t' g -> half_edge t' i -> origin t' g = origin t' i -> on_orbit (turn t') g i.
Proof.
move=> lg li; rewrite !originE // => O; have [Lg _ _] := leftP lg; have [Li _ _] := leftP li.
have/(rotation_left lg)[s [+ _ C]] : on_orbit (turn t) g i by apply/(keeps V2 g i Lg Li).
by rewrite past_left // => -[->].
Qed.

(** ** Ends that become isolated *)

Lemma corner_some x y : x = n \/ x = m -> corner x = Some y -> half_edge t' y /\ origin t' y = origin t x.
Proof.
have [a A la] := next_some live_n; have [b B lb] := next_some live_m; move=> xe; rewrite /RemoveEdge.corner.
case P: (past x) => [z|] //=; case: ifP => // no [zy]; rewrite zy in P no.
have {}no : y <> n /\ y <> m by split=> E; move: no; rewrite E eqxx ?orbT.
have ly : half_edge t' y.
  apply: is_left; try by case: no.
  by move: P; case: xe => ->; rewrite ?past_n ?past_m A B; case: ifP => _ [<-].
by rewrite originE // (past_origin P).
Qed.

Lemma corner_past x z : corner x = None -> past x = Some z -> z = n \/ z = m.
Proof.
by rewrite /RemoveEdge.corner => + P; rewrite P; case: eqP => [[]|_]; [left|case: eqP => // -[]; right].
Qed.

Lemma corner_none x i : x = n \/ x = m -> corner x = None -> half_edge t' i -> origin t i <> origin t x.
Proof.
have [a A la] := next_some live_n; have [b B lb] := next_some live_m => xe no l O.
have [li i_n im] := leftP l; have lx : half_edge t x by case: xe => ->.
have C : on_orbit (turn t) x i by apply/(keeps V2 x i lx li).
have turn_n : turn t n = Some b by rewrite /turn twin_n.
have turn_m : turn t m = Some a by rewrite /turn twin_m.
have only z := corner_past (z := z) no.
have both : b = m -> a = n -> False.
  move=> bm an; suff [/i_n|/im] : i = n \/ i = m by [].
  apply: (orbit_ind (P := fun u => u = n \/ u = m)) C => // u w.
  by case=> ->; rewrite ?turn_n ?turn_m => -[<-]; rewrite ?bm ?an; auto.
have differ : a <> b by move=> E; apply: n_not_m; apply: one_next A _; rewrite B E.
case: xe only C => ->; rewrite ?past_n ?past_m A B; case: eqP => [[E]|E] only C.
- by case: (only a) => // aE; [apply: both|case: differ; rewrite aE E].
- case: (only b) => // bE; last by case: E; rewrite bE.
  by apply: i_n; apply: (orbit_ind (P := fun u => u = n)) C => // u w ->; rewrite turn_n => -[<-].
- by case: (only b) => // bE; [case: differ; rewrite bE E|apply: both].
case: (only a) => // aE; first by case: E; rewrite aE.
by apply: im; apply: (orbit_ind (P := fun u => u = m)) C => // u w ->; rewrite turn_m => -[<-].
Qed.

Lemma begins x u : begins_at t x u -> origin t x = Some u. Proof. by move/eqP. Qed.

(** The face in which an isolated vertex lies. *)
Definition isolated_at u b := [\/ [/\ begins_at t n u, corner n = None & b = at_n],
  [/\ begins_at t m u, corner m = None & b = at_m] | bare t u /\ isolated t u = Some b].

Lemma bare_down u : bare t u -> bare t' u.
Proof. by move=> B i l; rewrite originE //; have [li _ _] := leftP l; apply: B. Qed.

Lemma not_begins x u : half_edge t x -> bare t u -> begins_at t x u = false.
Proof. by move=> lx B; apply/eqP; apply: B. Qed.

Lemma isolated_leftP u b : isolated t' u = Some b -> bare t' u /\ isolated_at u b.
Proof.
move=> I; have lu : vertex t u by rewrite -(vertexE out); apply: heard_live I.
have none x : x = n \/ x = m -> corner x = None -> begins_at t x u -> bare t' u.
  move=> xe no Bx i l; rewrite originE // => O; apply: (corner_none xe no l).
  by rewrite O (begins Bx).
move: I; rewrite (isolatedE out lu); case: ifP => [/andP[Bn]|_].
  by case K: (corner n) => [y|] // _ [<-]; split; [apply: (none n) => //; left|constructor 1].
case: ifP => [/andP[Bm]|_ I].
  by case K: (corner m) => [y|] // _ [<-]; split; [apply: (none m) => //; right|constructor 2].
have [B _ _] := core_isolated (core_of_rules keeps) I.
by split; [apply: bare_down|constructor 3].
Qed.

Lemma isolated_left u b : isolated_at u b -> exists c, isolated t' u = Some c.
Proof.
have l x : begins_at t x u -> half_edge t x -> vertex t u.
  by move/eqP=> O /links_of[[w + lw] _ _ _ _]; rewrite O => -[->].
case=> [[B K _]|[B K _]|[B I]].
- by exists at_n; rewrite (isolatedE out) ?(l n) // B K.
- by rewrite (isolatedE out) ?(l m) // B K; case: ifP => _; [exists at_n|exists at_m].
by exists b; rewrite (isolatedE out) ?(heard_live I) // !not_begins.
Qed.

Lemma isolated_still u b : isolated t u = Some b -> isolated t' u = Some b.
Proof.
move=> I; have [B _ _] := core_isolated (core_of_rules keeps) I.
by rewrite (isolatedE out) ?(heard_live I) // !not_begins.
Qed.

Lemma bare_left u : vertex t u -> bare t' u -> exists b, isolated_at u b.
Proof.
move=> lu B; have no x : x = n \/ x = m -> begins_at t x u -> corner x = None.
  move=> xe /begins Bx; case K: (corner x) => [y|] //; have [ly O] := corner_some xe K.
  by case: (B y ly); rewrite O.
case bn: (begins_at t n u); first by exists at_n; constructor 1; split=> //; apply: no bn; left.
case bm: (begins_at t m u); first by exists at_m; constructor 2; split=> //; apply: no bm; right.
have Bu : bare t u.
  move=> i li O; case: (i =P n) => [E|i_n]; first by move: bn; rewrite /begins_at -E O eqxx.
  case: (i =P m) => [E|im]; first by move: bm; rewrite /begins_at -E O eqxx.
  by apply: (B i (is_left li i_n im)); rewrite originE ?is_left.
have [b I _] := core_bare (core_of_rules keeps) lu Bu.
by exists b; constructor 3.
Qed.

Lemma out_leaving u : vertex t' u ->
  (exists2 g, leaving t' u = Some g & origin t' g = Some u) \/ leaving t' u = None /\ bare t' u.
Proof.
rewrite (vertexE out) => lu; rewrite (leavingE out) //.
have end_ x : x = n \/ x = m -> begins_at t x u ->
    (exists2 g, corner x = Some g & origin t' g = Some u) \/ corner x = None /\ bare t' u.
  move=> xe /begins Bx; case K: (corner x) => [y|]; [left|right].
    by have [ly O] := corner_some xe K; exists y; rewrite // O.
  by split=> // i l; rewrite originE // => O; apply: (corner_none xe K l); rewrite O.
case: ifP => [Bn|bn]; first by apply: end_ => //; left.
case: ifP => [Bm|bm]; first by apply: end_ => //; right.
case: (rest_leaving (rest_of_rules keeps) lu) => [[g L O]|[-> B]]; [left|right; split=> //; exact: bare_down].
exists g => //; rewrite originE //; apply: is_left; first exact: heard_live O.
  by move=> E; move: bn; rewrite /begins_at -E O eqxx.
by move=> E; move: bm; rewrite /begins_at -E O eqxx.
Qed.

(** ** What is connected *)

Variables (un um : nat).
Hypothesis origin_n : origin t n = Some un.
Hypothesis origin_m : origin t m = Some um.

Lemma connected_down u w : connected t' u w -> connected t u w.
Proof.
elim=> [|i x y _ IH X Y]; first exact: connected_self.
have l := heard_live X; rewrite originE // in X; apply: connected_edge IH X _.
have [li _ _] := leftP l; have [_ [g G _] _ _ _] := links_of li; have lg := twin_left l G.
by move: Y; rewrite /target twinE // G /= originE.
Qed.

Lemma connected_step i x y : half_edge t' i -> origin t i = Some x -> target t i = Some y -> connected t' x y.
Proof.
move=> l X Y; have [li _ _] := leftP l; have [_ [g G _] _ _ _] := links_of li; have lg := twin_left l G.
apply: (connected_edge (h := i) (connected_self _ _)); first by rewrite originE.
by move: Y; rewrite /target twinE // G /= originE.
Qed.

(** All that was connected is, unless the edge was on the way. *)
Lemma connected_cut u w : connected t u w ->
  [\/ connected t' u w, connected t' u un /\ connected t' um w | connected t' u um /\ connected t' un w].
Proof.
have self := @connected_self t'.
elim=> [|i x y _ IH X Y]; first by constructor 1.
case: (i =P n) => [E|i_n].
  move: X Y; rewrite E target_n origin_n origin_m => -[xE] [yE]; rewrite -xE in IH; rewrite -yE.
  by case: IH => [C|[C _]|[C _]]; [constructor 2|constructor 2|constructor 1].
case: (i =P m) => [E|im].
  move: X Y; rewrite E target_m origin_n origin_m => -[xE] [yE]; rewrite -xE in IH; rewrite -yE.
  by case: IH => [C|[C _]|[C _]]; [constructor 3|constructor 1|constructor 3].
have S := connected_step (is_left (heard_live X) i_n im) X Y; have trans := @connected_trans t'.
by case: IH => [C|[C D]|[C D]]; [constructor 1|constructor 2|constructor 3]; try split=> //; apply: trans S.
Qed.

(** Two half-edges less. *)
Lemma half_edges_less hs : lists hs (half_edge t) ->
  exists2 hs', lists hs' (half_edge t') & size hs = (size hs').+2.
Proof.
move=> H; exists (rem m (rem n hs)).
  apply: lists_iff (lists_rem m (lists_rem n H)) => i.
  by split=> [[im [i_n li]]|/leftP[]]; [apply: is_left|].
by rewrite (size_lists_rem H live_n) (size_lists_rem (lists_rem n H) (conj (nesym n_not_m) live_m)).
Qed.

End TakenOut.
