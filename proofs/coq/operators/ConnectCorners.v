(** * ConnectCorners: a new edge between two corners of cycles (`attach` in dcel/operators/connect.rs)

    A corner of a cycle is where one half-edge of it ends and the next one begins. The new edge goes from the corner after
    the half-edge [a] to the corner after the half-edge [b]. It is put in, and nothing else changes yet: whether two
    boundary components become one or one becomes two is settled afterwards.

<<
       ──a──► · ──next a──►               ──a──► · ──next a──►       half-edge h: after a, before next b, twin k
                                                h│▲                  half-edge k: after b, before next a, twin h
                                   ──►           ▼│k
       ◄─next b── · ◄──b──                ◄─next b── · ◄──b──
>>

    Both corners may be the same, [a = b]: then the edge is a loop. The cycle goes on along [h], and [k] is alone. *)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import View Rules Map Lists NewEdge.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** The view [t] with the edge [h], [k] between the corners after [a] and after [b]. No boundary component of it is named
    yet. *)
Definition attach t a b h k : view := {|
  vertex_slots := vertex_slots t;
  half_edge_slots := maxn (half_edge_slots t) (maxn h.+1 k.+1);
  boundary_slots := boundary_slots t;
  face_slots := face_slots t;
  is_vertex := is_vertex t;
  is_half_edge := fun i => [|| i == h, i == k | half_edge t i];
  is_boundary := is_boundary t;
  is_face := is_face t;
  says_origin := fun i => if i == h then target t a else if i == k then target t b else says_origin t i;
  says_twin := fun i => if i == h then Some k else if i == k then Some h else says_twin t i;
  says_next := fun i => if i == h then next t b else if i == k then (if a == b then Some k else next t a) else
    if i == a then Some h else if i == b then Some k else says_next t i;
  says_prev := fun i => if i == h then Some a else if i == k then (if a == b then Some k else Some b) else
    if Some i == next t b then Some h else if Some i == next t a then Some k else says_prev t i;
  says_boundary := says_boundary t;
  says_leaving := says_leaving t;
  says_isolated := says_isolated t;
  says_boundary_face := says_boundary_face t;
  says_boundary_start := says_boundary_start t;
  says_boundary_place := says_boundary_place t;
  says_outer := says_outer t;
  says_inner_count := says_inner_count t;
  says_inner := says_inner t
|}.

(** [t'] is [t] with this edge, as far as the links between half-edges and vertices go. *)
Record attached t t' a b h k : Prop := Attached {
  half_edgeE : forall i, half_edge t' i = [|| i == h, i == k | half_edge t i];
  originE : forall i, origin t' i = if i == h then target t a else if i == k then target t b else origin t i;
  twinE : forall i, twin t' i = if i == h then Some k else if i == k then Some h else twin t i;
  nextE : forall i, next t' i = if i == h then next t b else if i == k then (if a == b then Some k else next t a) else
    if i == a then Some h else if i == b then Some k else next t i;
  prevE : forall i, prev t' i = if i == h then Some a else if i == k then (if a == b then Some k else Some b) else
    if Some i == next t b then Some h else if Some i == next t a then Some k else prev t i
}.

Lemma attach_attached t a b h k : links_live t -> half_edge t a -> half_edge t b -> attached t (attach t a b h k) a b h k.
Proof.
case=> H _ _ _ la lb.
have halfE i : half_edge (attach t a b h k) i = [|| i == h, i == k | half_edge t i] by exact: two_more (@half_edge_below t).
have live_next c i : half_edge t c -> Some i == next t c -> half_edge t i.
  by move=> lc; have [_ _ [m -> lm] _ _] := H c lc => /eqP[->].
split=> // i; rewrite [LHS]/heard halfE /=; case: (i =P h) => //= _; case: (i =P k) => //= _.
  by case: (i =P a) => [->|_]; [rewrite la|case: (i =P b) => [->|//]; rewrite lb].
rewrite /prev /heard; case: ifP => // no; case: ifP => [/(live_next b i lb)|_]; first by rewrite no.
by case: ifP => // /(live_next a i la); rewrite no.
Qed.

(** ** Boundary components along a cycle *)

(** If B1 is kept, a cycle has one boundary component, and a boundary component has one cycle. *)
Section Cycles.
Variable t : view.
Hypothesis keeps : rules t.

Lemma next_boundary i n : next t i = Some n -> boundary_of t n = boundary_of t i.
Proof. by move=> N; have [C _] := keeps B1; rewrite -(C i (heard_live N)) N. Qed.

Lemma start_of_cycle i c : boundary_of t i = Some c ->
  exists2 g, boundary_start t c = Some (AtHalfEdge g) & on_cycle t g i.
Proof.
move=> B; have li := heard_live B; have [[H _ _ _] _] := keeps R1; have [_ _ _ _ [d D ld]] := H i li.
have [_ D'] := keeps B1; apply/(D' c i _ li) => //; by move: D ld; rewrite B => -[->].
Qed.

Lemma start_on_cycle g c : boundary_start t c = Some (AtHalfEdge g) -> boundary_of t g = Some c.
Proof.
move=> S; have [_ D] := keeps B1; apply/(D c g (heard_live S) (start_live keeps S)).
by exists g => //; apply: orbit_refl.
Qed.

Lemma cycle_of c i j : boundary_of t i = Some c -> boundary_of t j = Some c -> on_cycle t i j.
Proof.
move=> Bi Bj; have [g S Ci] := start_of_cycle Bi; have [g' + Cj] := start_of_cycle Bj; rewrite S => -[gg].
have map : is_map t by apply: low_map => q _; apply: keeps.
apply: orbit_trans (cycle_sym map (start_live keeps S) (heard_live Bi) Ci) _; by rewrite gg.
Qed.

End Cycles.

(** If the boundary component stays the same from each half-edge to the next one, it does so along the cycle. *)
Lemma constant_on_cycle t g i : (forall j, half_edge t j -> next t j >>= boundary_of t = boundary_of t j) ->
  on_cycle t g i -> boundary_of t i = boundary_of t g.
Proof.
move=> C [m]; elim: m i => [|m IH] i /=; first by case=> <-.
by case E: (iter m _ _) => [u|] //= U; rewrite -(IH u E) -(C u (heard_live U)) U.
Qed.

(** ** Half-edges and vertices with the new edge *)

Section Corners.
Variables (t t' : view) (a b h k : nat).
Hypothesis keeps : rules t.
Hypothesis free_h : ~~ half_edge t h.
Hypothesis free_k : ~~ half_edge t k.
Hypothesis hk : h != k.
Hypothesis new : attached t t' a b h k.
Variables (na nb oa ob : nat).
Hypothesis live_a : half_edge t a.
Hypothesis live_b : half_edge t b.
Hypothesis next_a : next t a = Some na.
Hypothesis next_b : next t b = Some nb.
Hypothesis target_a : target t a = Some oa.
Hypothesis target_b : target t b = Some ob.

Let half_edgeE := half_edgeE new.
Let originE := originE new.
Let twinE := twinE new.
Let nextE := nextE new.
Let prevE := prevE new.
Let old_h := NewEdge.old_h free_h.
Let old_k := NewEdge.old_k free_k.
Let links_of := NewEdge.links_of keeps.
Let up_half_edge := NewEdge.up_half_edge half_edgeE.
Let half_edgeP := NewEdge.half_edgeP free_h free_k half_edgeE.
Let newE := NewEdge.newE hk.

Lemma live_new : half_edge t' h /\ half_edge t' k. Proof. by rewrite !half_edgeE !eqxx orbT. Qed.

Lemma live_next c n : half_edge t c -> next t c = Some n -> half_edge t n.
Proof. by move/links_of=> [_ _ [m + l] _ _] => -> [<-]. Qed.

Let live_na : half_edge t na := live_next live_a next_a.
Let live_nb : half_edge t nb := live_next live_b next_b.

Lemma prev_next c n : half_edge t c -> next t c = Some n -> prev t n = Some c.
Proof. by move=> lc N; have [+ _] := keeps L2 c lc; rewrite N. Qed.

Lemma origin_next c n : half_edge t c -> next t c = Some n -> origin t n = target t c.
Proof. by move=> lc N; have := keeps L3 c lc; rewrite N. Qed.

(** Different half-edges have different next ones. *)
Lemma next_one c d n : half_edge t c -> half_edge t d -> next t c = Some n -> next t d = Some n -> c = d.
Proof. by move=> lc ld /(prev_next lc) C /(prev_next ld); rewrite C => -[]. Qed.

Lemma origin_up i v : origin t i = Some v -> origin t' i = Some v.
Proof. by move=> O; rewrite originE old_h ?old_k ?(heard_live O). Qed.

(** ** R1, L1, L2, L3 *)

Lemma attached_links i : half_edge t' i -> [/\ leads_to (vertex t) (origin t' i), leads_to (half_edge t') (twin t' i),
  leads_to (half_edge t') (next t' i) & leads_to (half_edge t') (prev t' i)].
Proof.
have [lh lk] := live_new; have L2' c n := fun l N => up_half_edge (@live_next c n l N).
have target_live c v : half_edge t c -> target t c = Some v -> vertex t v.
  by move/links_of=> [_ [g G lg] _ _ _]; have [[u U lu] _ _ _ _] := links_of lg; rewrite /target G /= U => -[<-].
case/half_edgeP=> [||{}i li ih ik]; rewrite originE twinE nextE prevE ?newE.
- split; [exists oa|exists k|exists nb|exists a] => //; [exact: target_live target_a|exact: L2' next_b|exact: up_half_edge].
- split; [exists ob|exists h| |] => //; first exact: target_live target_b.
    by case: eqP => _; [exists k|exists na] => //; exact: L2' next_a.
  by case: eqP => _; [exists k|exists b] => //; exact: up_half_edge.
rewrite ih ik; have [[u U lu] [g G lg] [m M lm] [p P lp] _] := links_of li; split.
- by exists u.
- by exists g; rewrite ?up_half_edge.
- case: ifP => _; first by exists h.
  by case: ifP => _; [exists k|exists m; rewrite ?up_half_edge].
case: ifP => _; first by exists h.
by case: ifP => _; [exists k|exists p; rewrite ?up_half_edge].
Qed.

Lemma attached_l1 : l1_twin t'. Proof. exact: new_l1 keeps free_h free_k hk half_edgeE twinE. Qed.

Lemma attached_l2 : l2_next_prev t'.
Proof.
move=> i /half_edgeP[||{}i li ih ik]; rewrite nextE prevE ?newE /=.
- by rewrite next_b /= prevE nextE next_b !old_h ?old_k ?eqxx.
- case: (a =P b) => [ab|ab] /=; first by rewrite prevE nextE !newE ab eqxx.
  rewrite next_a /= prevE nextE !old_h ?old_k // next_b next_a !eqxx.
  have -> : (b == a) = false by apply/eqP=> /esym.
  by case: eqP => // -[E]; case: ab; apply: next_one live_a live_b next_a _; rewrite E.
rewrite ih ik; have [E D] := keeps L2 i li; have [_ _ [m M lm] [p P lp] _] := links_of li; split.
  case: (i =P a) => [->|ia] /=; first by rewrite prevE !newE.
  case: (i =P b) => [ib|ib] /=.
    by rewrite prevE !newE; case: eqP => [ab|_]; [case: ia; rewrite ib ab|rewrite ib].
  rewrite M /= prevE old_h ?old_k // next_b next_a.
  case: eqP => [[mn]|_]; first by case: ib; apply: next_one li live_b M _; rewrite mn.
  case: eqP => [[mn]|_]; first by case: ia; apply: next_one li live_a M _; rewrite mn.
  by move: E; rewrite M.
rewrite next_b next_a; case: eqP => [[->]|inb] /=; first by rewrite nextE eqxx.
case: eqP => [[ia]|ina] /=.
  rewrite nextE !newE; case: eqP => [ab|_]; last by rewrite next_a ia.
  by case: inb; rewrite ia -next_a ab next_b.
rewrite P /= nextE old_h ?old_k //; move: D; rewrite P /= => D.
case: eqP => [pa|_]; first by case: ina; rewrite -next_a -pa D.
by case: eqP => [pb|//]; case: inb; rewrite -next_b -pb D.
Qed.

Lemma attached_l3 : l3_target t'.
Proof.
move=> i /half_edgeP[||{}i li ih ik]; rewrite nextE twinE ?newE /=.
- by rewrite next_b /= !originE !newE old_h ?old_k // (origin_next live_b next_b).
- rewrite originE eqxx; case: (a =P b) => [->|_] /=; first by rewrite originE !newE.
  by rewrite next_a /= originE old_h ?old_k // (origin_next live_a next_a).
rewrite ih ik; have [_ [g G lg] [m M lm] _ _] := links_of li; have := keeps L3 i li; rewrite G M /= => E.
rewrite (originE g) old_h ?old_k //; case: (i =P a) => [ia|_] /=.
  by rewrite originE eqxx /target -ia G.
case: (i =P b) => [ib|_] /=; first by rewrite originE !newE /target -ib G.
by rewrite originE old_h ?old_k.
Qed.

(** ** V2 *)

Hypothesis map' : is_map t'.

(** A half-edge that was there, with the same origin: [next a] for [h], [next b] for [k]. *)
Definition around i := if i == h then na else if i == k then nb else i.

Lemma around_live i : half_edge t' i -> half_edge t (around i).
Proof. by rewrite /around => /half_edgeP[||{}i li ih ik]; rewrite ?newE // ih ik. Qed.

Lemma around_origin i : half_edge t' i -> origin t' i = origin t (around i).
Proof.
rewrite /around originE => /half_edgeP[||{}i li ih ik]; rewrite ?newE.
- by rewrite (origin_next live_a next_a).
- by rewrite (origin_next live_b next_b).
by rewrite ih ik.
Qed.

Lemma turn_k : turn t' k = Some nb. Proof. by rewrite /turn twinE !newE /= nextE eqxx. Qed.
Lemma turn_h : turn t' h = Some (if a == b then k else na).
Proof. by rewrite /turn twinE eqxx /= nextE !newE; case: (a == b). Qed.

Lemma turn_to x y : on_orbit (turn t') x h -> y = na -> on_orbit (turn t') x y.
Proof.
move=> C ->; have := turn_h; case: (a =P b) => [ab|_] T; last exact: orbit_step C T.
have -> : na = nb by move: next_a; rewrite ab next_b => -[].
exact: orbit_step (orbit_step C T) turn_k.
Qed.

Lemma around_turn i : half_edge t' i -> on_orbit (turn t') i (around i).
Proof.
rewrite /around => /half_edgeP[||{}i li ih ik]; rewrite ?newE.
- by apply: turn_to => //; apply: orbit_refl.
- exact: orbit_step (orbit_refl _ _) turn_k.
by rewrite ih ik; apply: orbit_refl.
Qed.

Lemma turn_up g x : on_orbit (turn t) g x -> on_orbit (turn t') g x.
Proof.
apply: orbit_sub => u w z; rewrite {1}/turn; case G: (twin t u) => [g'|] //= N C.
have lu := heard_live G; have lg := heard_live N.
have T : turn t' u = if g' == a then Some h else if g' == b then Some k else next t g'.
  by rewrite /turn twinE old_h ?old_k // G /= nextE old_h ?old_k.
case: (g' =P a) T => [E|_] T.
  by apply: turn_to (orbit_step C T) _; move: N; rewrite E next_a => -[].
case: (g' =P b) T => [E|_] T; last by apply: orbit_step C _; rewrite T.
by apply: orbit_step (orbit_step C T) _; rewrite turn_k -N E next_b.
Qed.

Lemma attached_v2 : v2_rotation t'.
Proof.
move=> g x lg lx; split=> [/(on_rotation_origin attached_l1 attached_l3) ->//|].
rewrite !around_origin // => /(keeps V2 _ _ (around_live lg) (around_live lx))/turn_up C.
apply: orbit_trans (around_turn lg) (orbit_trans C _).
by apply: (turn_sym map') (around_turn lx) => //; apply/up_half_edge/around_live.
Qed.

(** ** Other cycles are as they were *)

Lemma cycle_away g i c : boundary_of t g = Some c -> boundary_of t a <> Some c -> boundary_of t b <> Some c ->
  on_cycle t g i -> on_cycle t' g i.
Proof.
move=> Bg nota notb [m]; suff H : iter m (obind (next t)) (Some g) = Some i -> boundary_of t i = Some c /\ on_cycle t' g i.
  by case/H.
elim: m i => [|m IH] i /=; first by case=> <-; split=> //; apply: orbit_refl.
case E: (iter m _ _) => [u|] //= U; have [Bu Cu] := IH u E; split; first by rewrite (next_boundary keeps U).
apply: orbit_step Cu _; rewrite nextE old_h ?old_k ?(heard_live U) //.
by case: (u =P a) => [ua|_]; [case: nota; rewrite -ua|case: (u =P b) => // ub; case: notb; rewrite -ub].
Qed.

(** ** Vertices and edges *)

Lemma not_bare_corner c v : half_edge t c -> target t c = Some v -> ~ bare t v.
Proof.
move/links_of=> [_ [g G lg] _ _ _]; rewrite /target G /= => O /(_ g lg); exact.
Qed.

Lemma bare_attached v : bare t' v <-> bare t v.
Proof.
split=> B i li; first by have := B i (up_half_edge li); rewrite originE old_h ?old_k.
case/half_edgeP: li => [||{}i li ih ik]; rewrite originE ?newE; last by rewrite ih ik; apply: B.
  by move=> E; apply: not_bare_corner live_a E B.
by move=> E; apply: not_bare_corner live_b E B.
Qed.

Lemma edges_attached es : lists_one_of_each es (same_edge t) (half_edge t) ->
  lists_one_of_each (h :: es) (same_edge t') (half_edge t').
Proof. exact: (edges_more keeps free_h free_k half_edgeE twinE). Qed.

(** ** What is connected *)

Lemma connected_up u w : connected t u w -> connected t' u w.
Proof.
elim=> [|i x y _ IH X Y]; first exact: connected_self.
apply: connected_edge IH (origin_up X) _; move: Y; rewrite /target twinE old_h ?old_k ?(heard_live X) //.
by case: (twin t i) => [g|] //= /origin_up.
Qed.

Lemma connected_new : connected t' oa ob /\ connected t' ob oa.
Proof.
split; [apply: (@connected_edge t' _ h oa)|apply: (@connected_edge t' _ k ob)]; try exact: connected_self;
  by rewrite /target ?twinE ?newE /= originE ?newE.
Qed.

Lemma connectedE u w : connected t' u w <->
  [\/ connected t u w, connected t u oa /\ connected t ob w | connected t u ob /\ connected t oa w].
Proof.
have [ab ba] := connected_new; have trans := @connected_trans t'.
split; last first.
  case=> [/connected_up //|[/connected_up A /connected_up B]|[/connected_up A /connected_up B]].
    exact: trans (trans _ _ _ A ab) B.
  exact: trans (trans _ _ _ A ba) B.
have self := @connected_self t.
elim=> [|i x y _ IH X Y]; first by constructor 1; apply: self.
have li : half_edge t' i := heard_live X; case: (half_edgeP li) X Y => [||{}i {}li ih ik].
- rewrite /target twinE eqxx /= !originE !newE target_a target_b => -[xa] [yb]; rewrite -xa in IH; rewrite -yb.
  by case: IH => [C|[C _]|[C _]]; [constructor 2|constructor 2|constructor 1]; rewrite ?C //; split=> //; apply: self.
- rewrite /target twinE !newE /= !originE !newE target_a target_b => -[xb] [ya]; rewrite -xb in IH; rewrite -ya.
  by case: IH => [C|[C _]|[C _]]; [constructor 3|constructor 1|constructor 3]; rewrite ?C //; split=> //; apply: self.
rewrite originE ih ik => X; rewrite /target twinE ih ik; have [_ [g G lg] _ _ _] := links_of li.
rewrite G /= originE old_h ?old_k // => Y; have step u' : connected t u' x -> connected t u' y.
  by move=> C; apply: connected_edge C X _; rewrite /target G.
by case: IH => [C|[C D]|[C D]]; [constructor 1|constructor 2|constructor 3]; auto.
Qed.

End Corners.
