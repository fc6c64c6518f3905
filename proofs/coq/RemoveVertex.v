(** * RemoveVertex: removing an isolated vertex keeps all rules (isolated.rs)

    Removing is adding backwards: if a view with the isolated vertex [v] keeps all rules, then so does the view without.

<<
      f ┌────────────┐          f ┌────────────┐
        │    · v     │    ──►     │            │
        └────────────┘            └────────────┘
>>

    Here [v] is the last one that its face lists. Wherever it is listed, and whether the last one takes its place or the
    others move up: the order of a list does not matter (Renaming.v). *)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import View Rules Map Counting Lists TopologyProof Verdict AddVertex.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section RemoveVertex.
Variables (t : view) (v b f : nat).
Hypothesis free_vertex : ~~ vertex t v.
Hypothesis free_boundary : ~~ boundary t b.
Hypothesis live_face : face t f.

Notation t' := (add_isolated_vertex t v b f).
Hypothesis keeps : rules t'.

Let low : lower t'. Proof. by move=> q _; apply: keeps. Qed.
Let map : is_map t' := low_map low.

(** What half-edges say, and what faces say of their outer boundary components, is the same in both. *)

Lemma vertex_heard T (says : nat -> option T) x u :
  heard (vertex t') (fun u => if u == v then x else says u) u = if u == v then x else heard (vertex t) says u.
Proof. by rewrite /heard vertex_more; case: (u == v). Qed.

Lemma boundary_heard T (says : nat -> option T) x c :
  heard (boundary t') (fun c => if c == b then x else says c) c = if c == b then x else heard (boundary t) says c.
Proof. by rewrite /heard boundary_more; case: (c == b). Qed.

Lemma leaving_same u : leaving t' u = leaving t u.
Proof. by rewrite /leaving vertex_heard; case: (u =P v) => // ->; rewrite /heard (negPf free_vertex). Qed.

Lemma isolated_less u : isolated t' u = if u == v then Some b else isolated t u. Proof. exact: vertex_heard. Qed.
Lemma face_less c : boundary_face t' c = if c == b then Some f else boundary_face t c.
Proof. exact: boundary_heard. Qed.
Lemma start_less c : boundary_start t' c = if c == b then Some (AtVertex v) else boundary_start t c.
Proof. exact: boundary_heard. Qed.
Lemma place_less c : boundary_place t' c = if c == b then Some (Inner (inner_count t f)) else boundary_place t c.
Proof. exact: boundary_heard. Qed.

Lemma vertexE u : vertex t' u = (u == v) || vertex t u. Proof. exact: vertex_more. Qed.
Lemma boundaryE c : boundary t' c = (c == b) || boundary t c. Proof. exact: boundary_more. Qed.
Lemma old_v u : vertex t u -> u == v = false. Proof. exact: old_vertex. Qed.
Lemma old_b c : boundary t c -> c == b = false. Proof. exact: old_boundary. Qed.
Lemma live_v : vertex t' v. Proof. by rewrite vertex_more // eqxx. Qed.
Lemma live_b : boundary t' b. Proof. by rewrite boundary_more // eqxx. Qed.
Lemma up_vertex u : vertex t u -> vertex t' u. Proof. by rewrite vertex_more // orbC => ->. Qed.
Lemma up_boundary c : boundary t c -> boundary t' c. Proof. by rewrite boundary_more // orbC => ->. Qed.

Lemma listed_less g p c : c <> b -> listed t' g p = Some c <-> listed t g p = Some c.
Proof.
move=> cb; case: p => [//|i] /=; rewrite inner_more //; case: andP => // -[/eqP-> /eqP->].
by split=> [[bc]|]; [case: cb | rewrite /inner ltnn].
Qed.

(** ** Nothing else leads to [v] or [b] *)

Lemma bare_v : bare t v.
Proof.
have [_ N] := keeps B2 v live_v; case: (vertexP low live_v) => [x _ xv|//].
have [|I _] := N; first by rewrite -xv; apply: not_bare low x.
by move: I; rewrite isolated_less eqxx.
Qed.

Lemma only_b c : starts_at_vertex t' v c -> c = b.
Proof.
have [A _] := keeps B2 v live_v; have [d [E S]] := A bare_v => /(S c).1 ->.
by move: E; rewrite isolated_less eqxx => -[->].
Qed.

Lemma not_on_b h : half_edge t h -> boundary_of t h <> Some b.
Proof. by move=> lh; have [_ C] := keeps B1; move/(C b h live_b lh).1=> [g]; rewrite start_less eqxx. Qed.

Lemma listed_once g p : listed t' g p = Some b -> g = f /\ p = Inner (inner_count t f).
Proof.
have [g' [p' [_ _ L]]] := keeps F2 b live_b.
have [fg fp] : f = g' /\ Inner (inner_count t f) = p' by apply/L; rewrite /= inner_more // !eqxx.
by move/L=> [-> ->]; rewrite -fg -fp.
Qed.

Lemma not_connected u : vertex t u -> ~ connected t' u v.
Proof.
move=> lu /(connected_sym map) /(connected_bare map (low_v2 low) bare_v) uv.
by move: lu; rewrite uv (negPf free_vertex).
Qed.

Lemma down (P Q : nat -> bool) l i : (forall j, Q j = (j == i) || P j) -> l <> Some i -> leads_to Q l -> leads_to P l.
Proof. by move=> QP li [j E]; rewrite QP => /orP[/eqP ji|Pj]; [case: li; rewrite E ji | exists j]. Qed.

(** ** R1 to F2 *)

Lemma remove_links : links_live t.
Proof.
have [[H V B F] _] := keeps R1; split.
- move=> h lh; have [o w n p c] := H h lh; split=> //.
    exact: (down (i := v) vertexE) (bare_v lh) o.
  exact: (down (i := b) boundaryE) (not_on_b lh) c.
- move=> u lu; have [L I] := V u (up_vertex lu); rewrite leaving_same in L.
  split; first by case: L => [L|L]; [left|right].
  move: I; rewrite isolated_less old_v // => -[->|I]; [by left|right].
  apply: (down (i := b) boundaryE) I => E; have S : starts_at_vertex t' u b.
    have E' : isolated t' u = Some b by rewrite isolated_less old_v.
    case: (vertexP low (up_vertex lu)) => [x _ xu|c _ _ + S]; last by rewrite E' => -[/esym cb]; rewrite cb in S.
    have [_ N] := keeps B2 u (up_vertex lu); have [|I _] := N; first by rewrite -xu; apply: not_bare low x.
    by move: E'; rewrite I.
  by move: S; rewrite /starts_at_vertex start_less eqxx => -[vu]; move: lu; rewrite -vu (negPf free_vertex).
- move=> c lc; have [] := B c (up_boundary lc); rewrite face_less start_less old_b // => L S; split=> //.
  case E: (boundary_start t c) S => [[h|u]|] //=; rewrite vertex_more // => /orP[/eqP uv|] //.
  have /only_b cb : starts_at_vertex t' v c by rewrite /starts_at_vertex start_less old_b // E uv.
  by move: lc; rewrite cb (negPf free_boundary).
move=> g lg; have [O I] := F g lg; split.
  case: O => [O|O]; [by left|right]; apply: (down (i := b) boundaryE) O => E.
  by have [_] := @listed_once g Outer E.
move=> i lt; have lt' : i < inner_count t' g by rewrite inner_count_more //; case: eqP lt => // -> /ltnW.
have ni : (g == f) && (i == inner_count t f) = false.
  by case: (g =P f) lt => //= -> lt; rewrite ltn_eqF.
have E : inner t' g i = inner t g i by rewrite inner_more // ni.
rewrite -E; apply: (down (i := b) boundaryE) (I i lt') => /(@listed_once g (Inner i))[gf [ii]].
by move: ni; rewrite gf ii !eqxx.
Qed.

Lemma remove_b1 : b1_cycle t.
Proof.
have [C D] := keeps B1; split=> // c h lc lh; have := D c h (up_boundary lc) lh.
by rewrite start_less old_b.
Qed.

Lemma starts_less u c : u <> v -> starts_at_vertex t' u c <-> starts_at_vertex t u c.
Proof.
move=> uv; rewrite /starts_at_vertex start_less; case: (c =P b) => [->|_] //; split=> [[vu]|S]; first by case: uv.
by have := old_b (heard_live S); rewrite eqxx.
Qed.

Lemma remove_b2 : b2_isolated t.
Proof.
move=> u lu; have uv : u <> v by move=> uv; move: lu; rewrite uv (negPf free_vertex).
have [A N] := keeps B2 u (up_vertex lu); rewrite isolated_less old_v // in A N; split=> [/A|/N] [].
  by move=> c [E S]; exists c; split=> // d; rewrite -S; apply: iff_sym; apply: starts_less.
by move=> E S; split=> // c /(starts_less _ uv); apply: S.
Qed.

Lemma remove_f1 : f1_outer t.
Proof.
have [U O] := keeps F1; split=> // g c u E S; apply: (O g c u E).
by rewrite /starts_at_vertex start_less old_b // (heard_live S).
Qed.

Lemma remove_f2 : f2_listed t.
Proof.
move=> c lc; have cb : c <> b by move=> cb; move: lc; rewrite cb (negPf free_boundary).
have [g [p [E P L]]] := keeps F2 c (up_boundary lc); exists g, p; move: E P.
rewrite face_less place_less old_b // => -> ->; split=> // g' p'; rewrite -L; apply: iff_sym; exact: listed_less.
Qed.

(** ** T1 *)

Lemma connected_less u w : connected t' u w <-> connected t u w.
Proof.
split; first by elim=> [|h x y _ IH O T]; [apply: connected_self|apply: connected_edge IH O T].
by elim=> [|h x y _ IH O T]; [apply: connected_self|apply: (@connected_edge t') IH O T].
Qed.

Lemma vertex_at_less c : vertex_at t' c = if c == b then Some v else vertex_at t c.
Proof. by rewrite /vertex_at start_less; case: (c == b). Qed.

Lemma outside_less u c : vertex t u -> outside_of t' u c <-> outside_of t u c.
Proof.
move=> lu; rewrite /outside_of /is_inner place_less vertex_at_less; case: (c =P b) => [->|_]; last first.
  by split=> -[P [w W /connected_less uw]]; split=> //; exists w => //; apply/connected_less; apply/connected_less.
split=> [[_ [w [<-] /(not_connected lu)]]|[[i P] _]] //.
by have := old_b (heard_live P); rewrite eqxx.
Qed.

Lemma remove_t1 : t1_outside t.
Proof.
move=> u lu; have [c [O one]] := keeps T1 u (up_vertex lu); exists c; split; first exact/outside_less.
by move=> d /(outside_less _ lu); apply: one.
Qed.

(** ** T2 *)

Lemma rooted_less g : rooted t' g -> rooted t g.
Proof.
elim=> [h U|h c w d h' E W O D _ IH]; first exact: rooted_here.
have cb : c == b = false by apply/eqP=> cb; rewrite cb in E; have [_] := @listed_once h Outer E.
rewrite vertex_at_less cb in W.
have lw : vertex t w.
  have [H _ B _] := remove_links; move: W; rewrite /vertex_at; case S: (boundary_start t c) => [[k|x]|] //=.
    by move=> K; have [[x + lx] _ _ _ _] := H k (heard_live K); rewrite K => -[->].
  by case=> <-; have [_] := B c (heard_live S); rewrite S.
have O' : outside_of t w d by apply/outside_less.
have db : boundary t d by case: O' => -[i P] _; apply: heard_live P.
by rewrite face_less old_b // in D; apply: (@rooted_out t h c w d h') IH.
Qed.

Lemma remove_t2 : t2_nesting t.
Proof.
move=> u c g lu O D; apply: rooted_less; apply: (keeps T2 u c g (up_vertex lu)).
  exact/outside_less.
by rewrite face_less old_b // (heard_live D).
Qed.

(** ** T3 *)

Lemma lists_iff (s : seq nat) (P Q : nat -> Prop) : (forall x, P x <-> Q x) -> lists s P -> lists s Q.
Proof. by move=> PQ [u all]; split=> // x; rewrite all. Qed.

Lemma lists_one_iff (s : seq nat) same (P Q : nat -> Prop) : (forall x, P x <-> Q x) ->
  lists_one_of_each s same P -> lists_one_of_each s same Q.
Proof. by move=> PQ [u ok one all]; split=> // [x /ok/PQ|x /PQ/all]. Qed.

Lemma half_edge_of_less u h : half_edge_of t' u h <-> half_edge_of t u h.
Proof. by split=> -[w O C]; exists w => //; apply/connected_less. Qed.

Lemma remove_t3 : t3_euler t.
Proof.
move=> u lu; have [V [E [cycles [[vs [es [cs [Vs Es Cs N]]]] eq]]]] := keeps T3 u (up_vertex lu).
exists V, E, cycles; split=> //; exists vs, es, cs; split=> //.
- exact: lists_iff (connected_less u) Vs.
- exact: lists_one_iff (half_edge_of_less u) Es.
exact: lists_one_iff (half_edge_of_less u) Cs.
Qed.

(** Where [v] and [b] are free slots of [t] and [f] is a face: if all rules hold with the isolated vertex, they hold
    without. *)
Theorem remove_isolated_vertex_keeps_rules : rules t.
Proof.
have H r : index r < index T4 -> holds t r.
  case: r => // _; [by split; [exact: remove_links|exact: lists_short_listed remove_links remove_f2]|exact: (keeps L1)|exact: (keeps L2)|exact: (keeps L3)|idtac|exact: (keeps V2)|
    exact: remove_b1|exact: remove_b2|exact: remove_f1|exact: remove_f2|exact: remove_t1|exact: remove_t2|
    exact: remove_t3].
  by move=> u h lu; rewrite -leaving_same; apply: (keeps V1 u h) (up_vertex lu).
by move=> r; case: (ltnP (index r) (index T4)) => [/H //|]; case: r => // _; apply: t4_follows => q; apply: H.
Qed.

End RemoveVertex.
