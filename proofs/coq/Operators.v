(** * Operators: what an operator makes of a view that keeps the rules keeps them, too (dcel/)

    The numbers that an operator gives to new records are arguments here, and may be any that no live record has. *)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import View Rules Map Lists TopologyProof Verdict.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** ** Adding an isolated vertex

    `add_isolated_vertex(face)` makes a vertex without half-edges and the boundary component that it is, and appends
    that one to the list of the face. Nothing else changes.

<<
      ┌───────────┐            ┌───────────┐
      │ f         │     ──►    │ f    · v  │        f lists b, b starts at v, v names b
      │           │            │        b  │
      └───────────┘            └───────────┘
>>
*)

Definition add_isolated_vertex t f v b : view := {|
  vertex_slots := maxn (vertex_slots t) v.+1;
  half_edge_slots := half_edge_slots t;
  boundary_slots := maxn (boundary_slots t) b.+1;
  face_slots := face_slots t;
  is_vertex := fun u => vertex t u || (u == v);
  is_half_edge := is_half_edge t;
  is_boundary := fun c => boundary t c || (c == b);
  is_face := is_face t;
  says_origin := says_origin t;
  says_twin := says_twin t;
  says_next := says_next t;
  says_prev := says_prev t;
  says_boundary := says_boundary t;
  says_leaving := fun u => if u == v then None else says_leaving t u;
  says_isolated := fun u => if u == v then Some b else says_isolated t u;
  says_boundary_face := fun c => if c == b then Some f else says_boundary_face t c;
  says_boundary_start := fun c => if c == b then Some (AtVertex v) else says_boundary_start t c;
  says_boundary_place := fun c => if c == b then Some (Inner (inner_count t f)) else says_boundary_place t c;
  says_outer := says_outer t;
  says_inner_count := fun g => if g == f then (inner_count t f).+1 else says_inner_count t g;
  says_inner := fun g i => if (g == f) && (i == inner_count t f) then Some b else says_inner t g i
|}.

Section AddIsolatedVertex.
Variables (t : view) (f v b : nat).
Hypotheses (keeps : rules t) (lf : face t f) (new_v : ~~ vertex t v) (new_b : ~~ boundary t b).

Let t' := add_isolated_vertex t f v b.
Let r1 : r1_live t := keeps R1.
Let low : lower t. Proof. by move=> q _; apply: keeps. Qed.
Let map : is_map t := low_map low.

(** What half-edges say, what faces say of their outer boundary, and so all cycles and rotations, are the same. *)

Lemma live_more n (live : pred nat) i j : (forall k, live k -> k < n) ->
  (i < maxn n j.+1) && (live i || (i == j)) = live i || (i == j).
Proof.
move=> below; case: (i =P j) => [->|_]; first by rewrite orbT andbT leq_max ltnSn orbT.
by rewrite orbF leq_max; case E: (live i); rewrite ?andbF // (below _ E).
Qed.

Lemma vertexE u : vertex t' u = vertex t u || (u == v).
Proof. by apply: live_more => k; apply: vertex_below. Qed.

Lemma boundaryE c : boundary t' c = boundary t c || (c == b).
Proof. by apply: live_more => k; apply: boundary_below. Qed.

Lemma heard_vertex T (says : nat -> option T) x u :
  heard (vertex t') (fun u => if u == v then x else says u) u = if u == v then x else heard (vertex t) says u.
Proof. by rewrite /heard vertexE; case: (u == v); rewrite ?orbT ?orbF. Qed.

Lemma heard_boundary T (says : nat -> option T) x c :
  heard (boundary t') (fun c => if c == b then x else says c) c = if c == b then x else heard (boundary t) says c.
Proof. by rewrite /heard boundaryE; case: (c == b); rewrite ?orbT ?orbF. Qed.

Lemma leavingE u : leaving t' u = leaving t u.
Proof. by rewrite /leaving heard_vertex; case: (u =P v) => // ->; rewrite /heard (negPf new_v). Qed.

Lemma isolatedE u : isolated t' u = if u == v then Some b else isolated t u. Proof. exact: heard_vertex. Qed.
Lemma boundary_faceE c : boundary_face t' c = if c == b then Some f else boundary_face t c.
Proof. exact: heard_boundary. Qed.
Lemma boundary_startE c : boundary_start t' c = if c == b then Some (AtVertex v) else boundary_start t c.
Proof. exact: heard_boundary. Qed.
Lemma boundary_placeE c : boundary_place t' c = if c == b then Some (Inner (inner_count t f)) else boundary_place t c.
Proof. exact: heard_boundary. Qed.

Lemma inner_countE g : inner_count t' g = inner_count t g + (g == f).
Proof.
rewrite {1}/inner_count /=; case: (g =P f) => [->|_]; last by rewrite addn0.
by rewrite (_ : face t' f = face t f) // lf addn1.
Qed.

Lemma innerE g i : inner t' g i = if (g == f) && (i == inner_count t f) then Some b else inner t g i.
Proof.
rewrite /inner inner_countE /=; case: (g =P f) => [->|_]; last by rewrite addn0.
by rewrite addn1 ltnS leq_eqVlt /=; case: (i =P inner_count t f) => [->|_] //=.
Qed.

Lemma new_boundary c : boundary t c -> c == b = false.
Proof. by move=> lc; apply/eqP=> cb; move: new_b; rewrite -cb lc. Qed.

Lemma new_vertex u : vertex t u -> u == v = false.
Proof. by move=> lu; apply/eqP=> uv; move: new_v; rewrite -uv lu. Qed.

Lemma bare_v : bare t v.
Proof.
have [H _ _ _] := r1; move=> h lh E; have [[u E' lu] _ _ _ _] := H h lh.
by move: E' lu; rewrite E => -[<-]; rewrite (negPf new_v).
Qed.

(** ** R1 to F2 *)

Lemma up_vertex u : vertex t u -> vertex t' u. Proof. by rewrite vertexE => ->. Qed.
Lemma up_boundary c : boundary t c -> boundary t' c. Proof. by rewrite boundaryE => ->. Qed.

Lemma up (P Q : nat -> bool) l : (forall i, P i -> Q i) -> leads_to P l -> leads_to Q l.
Proof. by move=> PQ [i -> Pi]; exists i => //; apply: PQ. Qed.

Lemma add_r1 : r1_live t'.
Proof.
have [H V B F] := r1; split.
- move=> h lh; have [o w n p c] := H h lh; split=> //; [exact: (up up_vertex o)|exact: (up up_boundary c)].
- move=> u; rewrite vertexE isolatedE leavingE; case: (u =P v) => [-> _|_].
    split; last by right; exists b; rewrite // boundaryE eqxx orbT.
    by right; split; [rewrite /leaving /heard (negPf new_v)|apply: bare_v].
  rewrite orbF => lu; have [L I] := V u lu; split; first by case: L => [L|L]; [left|right].
  by case: I => [->|I]; [left|right; apply: (up up_boundary I)].
- move=> c; rewrite boundaryE boundary_faceE boundary_startE; case: (c =P b) => [_ _|_].
    by split; [exists f|rewrite /= vertexE eqxx orbT].
  rewrite orbF => lc; have [L S] := B c lc; split=> //.
  by case: (boundary_start t c) S => [[h|u]|] //=; apply: up_vertex.
move=> g lg; have [O I] := F g lg; split.
  by case: O => [O|O]; [left|right; apply: (up up_boundary O)].
move=> i; rewrite inner_countE innerE; case: (g =P f) => [gf|_] /=; last by rewrite addn0 => /I; apply: (up up_boundary).
rewrite addn1 ltnS leq_eqVlt gf; case: (i =P inner_count t f) => [_ _|_ /=].
  by exists b; rewrite // boundaryE eqxx orbT.
by rewrite -gf => /I; apply: (up up_boundary).
Qed.

Lemma add_b1 : b1_cycle t'.
Proof.
have [C D] := keeps B1; split=> // c h; rewrite boundaryE boundary_startE; case: (c =P b) => [-> _ lh|_].
  split=> [E|[] //]; have [H _ _ _] := r1; have [_ _ _ _ [d E' ld]] := H h lh.
  by move: E' ld; rewrite (E : boundary_of t h = Some b) => -[<-]; rewrite (negPf new_b).
by rewrite orbF; apply: D.
Qed.

(** What starts at a vertex of [t], or is listed by it, is of [t]. *)

Lemma start_old c u : boundary_start t c = Some (AtVertex u) -> vertex t u.
Proof. by move=> E; have [_ _ B _] := r1; have [_] := B c (heard_live E); rewrite E. Qed.

Lemma listed_old g p c : listed t g p = Some c -> boundary t c.
Proof. exact: listed_live low _ _ _. Qed.

Lemma add_b2 : b2_isolated t'.
Proof.
move=> u; rewrite vertexE isolatedE; case: (u =P v) => [-> _|uv].
  split=> [_|[]]; last exact: bare_v.
  exists b; split=> // c; rewrite /starts_at_vertex boundary_startE; case: (c =P b) => // cb; split=> // /start_old.
  by rewrite (negPf new_v).
rewrite orbF => lu; have [A N] := keeps B2 u lu; split=> [/A[c [E S]]|/N[E S]].
  exists c; split=> // d; rewrite /starts_at_vertex boundary_startE; case: (d =P b) => [->|_]; last exact: S.
  split=> [[vu]|bc]; first by case: uv.
  by have := new_boundary (heard_live ((S b).2 bc)); rewrite eqxx.
split=> // d; rewrite /starts_at_vertex boundary_startE; case: (d =P b) => [_ [vu]|_]; last exact: S.
by case: uv.
Qed.

Lemma add_f1 : f1_outer t'.
Proof.
have [U O] := keeps F1; split=> // g c u E; rewrite /starts_at_vertex boundary_startE new_boundary; first exact: O E.
exact: (@listed_old g Outer).
Qed.

Lemma add_listed g p c : listed t' g p = Some c <-> listed t g p = Some c \/ [/\ c = b, g = f & p = Inner (inner_count t f)].
Proof.
case: p => [|i] /=; first by split=> [|[|[]]] //; left.
rewrite innerE; case: (g =P f) => [->|gf] /=; last by split=> [|[|[]]] //; left.
case: (i =P inner_count t f) => [->|ni]; last by split=> [|[|[_ _ []]]] //; left.
split=> [[<-]|[E|[-> _ _]]] //; first by right.
by move: E; rewrite /inner ltnn.
Qed.

Lemma add_f2 : f2_listed t'.
Proof.
move=> c; rewrite boundaryE boundary_faceE boundary_placeE; case: (c =P b) => [-> _|cb].
  exists f, (Inner (inner_count t f)); split=> // g p; split=> [/add_listed[/listed_old|[_ -> ->]] //|[-> ->]].
    by rewrite (negPf new_b).
  by apply/add_listed; right.
rewrite orbF => lc; have [g [p [E P L]]] := keeps F2 c lc; exists g, p; split=> // g' p'.
by split=> [/add_listed[/L|[]]|/L E'] //; apply/add_listed; left.
Qed.

(** ** T1 *)

Lemma connectedE u w : connected t' u w <-> connected t u w.
Proof.
split; first by elim=> [|h x y _ IH O T]; [apply: connected_self|apply: connected_edge IH O T].
by elim=> [|h x y _ IH O T]; [apply: connected_self|apply: (@connected_edge t') IH O T].
Qed.

Lemma vertex_atE c : vertex_at t' c = if c == b then Some v else vertex_at t c.
Proof. by rewrite /vertex_at boundary_startE; case: (c == b). Qed.

Lemma connected_v u : connected t u v -> u = v.
Proof.
case/(connected_dart map (low_v2 low)) => [//|[x [y [_ yv _]]]].
by have := org_live map y; rewrite yv (negPf new_v).
Qed.

Lemma outside_ofE u c : outside_of t' u c <-> outside_of t u c \/ c = b /\ u = v.
Proof.
rewrite /outside_of /is_inner boundary_placeE vertex_atE; case: (c =P b) => [->|cb].
  split=> [[_ [w [<-] /connectedE/connected_v->]]|[[[i P] _]|[_ ->]]]; first by right.
    by have := heard_live P; rewrite (negPf new_b).
  by split; [exists (inner_count t f)|exists v => //; apply: connected_self].
split=> [[P [w W /connectedE uw]]|[[P [w W uw]]|[]]] //; first by left; split=> //; exists w.
by split=> //; exists w => //; apply/connectedE.
Qed.

Lemma add_t1 : t1_outside t'.
Proof.
move=> u; rewrite vertexE; case: (u =P v) => [-> _|uv].
  exists b; split; first by apply/outside_ofE; right.
  move=> c /outside_ofE[[[i P] [w W]]|[-> //]].
  move/(connected_bare map (low_v2 low) bare_v) => wv; rewrite wv in W.
  have [_ _ B _] := r1; have [_] := B c (heard_live P); move: W; rewrite /vertex_at.
  case S: (boundary_start t c) => [[h|x]|] //= W; last by case: W => -> lv; case/negP: new_v.
  by move=> lh; case: (bare_v lh W).
rewrite orbF => lu; have [c [O one]] := keeps T1 u lu; exists c; split; first by apply/outside_ofE; left.
by move=> d /outside_ofE[/one|[_]] // /uv.
Qed.

(** ** T2 *)

Lemma face_rooted g : face t g -> rooted t g.
Proof.
move=> lg; case E: (outer t g) => [c|]; last exact: rooted_here.
have lc : boundary t c by apply: (@listed_old g Outer).
have [w W lw] : exists2 w, vertex_at t c = Some w & vertex t w.
  have [H _ B _] := r1; have [_] := B c lc; rewrite /vertex_at; case: (boundary_start t c) => [[h|x]|] //= l.
    by have [[w W lw] _ _ _ _] := H h l; exists w.
  by exists x.
have [d [O _]] := keeps T1 w lw; have [g' D lg'] := outside_face low O.
exact: rooted_out E W O D (keeps T2 w d g' lw O D).
Qed.

Lemma add_rooted g : rooted t g -> rooted t' g.
Proof.
elim=> [h U|h c w d h' E W O D _ IH]; first exact: (@rooted_here t').
have lc : boundary t c by apply: (@listed_old h Outer).
apply: (@rooted_out t' h c w d h') => //.
- by rewrite vertex_atE new_boundary.
- by apply/outside_ofE; left.
by rewrite boundary_faceE new_boundary // (heard_live D).
Qed.

Lemma add_t2 : t2_nesting t'.
Proof.
move=> u c g lu /outside_ofE[O|[-> _]]; rewrite boundary_faceE.
  have lc : boundary t c by case: O => -[i P] _; apply: heard_live P.
  rewrite new_boundary // => D; apply/add_rooted/face_rooted.
  by have [_ _ B _] := r1; have [[g' D' lg] _] := B c lc; move: D'; rewrite D => -[->].
by rewrite eqxx => -[<-]; apply/add_rooted/face_rooted.
Qed.

(** ** T3 *)

Lemma lists_iff (s : seq nat) (P Q : nat -> Prop) : (forall x, P x <-> Q x) -> lists s P -> lists s Q.
Proof. by move=> PQ [u all]; split=> // x; rewrite all. Qed.

Lemma lists_one_iff (s : seq nat) same (P Q : nat -> Prop) : (forall x, P x <-> Q x) ->
  lists_one_of_each s same P -> lists_one_of_each s same Q.
Proof. by move=> PQ [u ok one all]; split=> // [x /ok/PQ|x /PQ/all]. Qed.

Lemma half_edge_ofE u h : half_edge_of t u h <-> half_edge_of t' u h.
Proof. by split=> -[w O C]; exists w => //; apply/connectedE. Qed.

Lemma add_t3 : t3_euler t'.
Proof.
move=> u; rewrite vertexE; case: (u =P v) => [-> _|_].
  exists 1, 0, 1; split=> //; exists [:: v], [::], [::]; split=> //.
  - split=> // x; rewrite inE; split=> [/eqP->|/connectedE/(connected_bare map (low_v2 low) bare_v)->] //.
    exact: connected_self.
  - split=> // h [w O /connectedE/(connected_bare map (low_v2 low) bare_v) wv].
    by rewrite wv in O; case: (bare_v (heard_live O) O).
  split=> // h [w O /connectedE/(connected_bare map (low_v2 low) bare_v) wv].
  by rewrite wv in O; case: (bare_v (heard_live O) O).
rewrite orbF => lu; have [V [E [cycles [[vs [es [cs [Vs Es Cs N]]]] eq]]]] := keeps T3 u lu.
exists V, E, cycles; split=> //; exists vs, es, cs; split=> //.
- by apply: lists_iff Vs => x; apply: iff_sym; apply: connectedE.
- exact: lists_one_iff (half_edge_ofE u) Es.
exact: lists_one_iff (half_edge_ofE u) Cs.
Qed.

Theorem add_isolated_vertex_keeps : rules (add_isolated_vertex t f v b).
Proof.
have H r : index r < index T4 -> holds t' r.
  case: r => // _; [exact: add_r1|exact: (keeps L1)|exact: (keeps L2)|exact: (keeps L3)|idtac|exact: (keeps V2)|
    exact: add_b1|exact: add_b2|exact: add_f1|exact: add_f2|exact: add_t1|exact: add_t2|exact: add_t3].
  by move=> u h _; rewrite leavingE => E; apply: (keeps V1 u h) (heard_live E) E.
by move=> r; case: (ltnP (index r) (index T4)) => [/H //|]; case: r => // _; apply: t4_follows => q; apply: H.
Qed.

End AddIsolatedVertex.
