(** * MoveInner: moving an inner boundary component keeps all rules, if its new face is not inside it (inner.rs)

    `move_inner(b, g)` takes an inner boundary component, a hole or an isolated vertex, out of the list of its face and
    appends it to that of another face. It is refused if that face is inside the component: then the component would lie
    inside itself, and T2 would be broken.

<<
      f ┌──────┐ g ┌──────┐          f ┌──────┐ g ┌──────┐
        │  □b  │   │      │    ──►     │      │   │  □b  │
        └──────┘   └──────┘            └──────┘   └──────┘
>>

    Here [b] is the last one that its face lists. The order of a list does not matter: see Renaming.v. *)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import View Rules Map Counting Lists TopologyProof Verdict.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** The view [t] with the boundary component [b], which the face [f] lists last, moved to the face [g]. *)
Definition move_inner t b f g : view := {|
  vertex_slots := vertex_slots t;
  half_edge_slots := half_edge_slots t;
  boundary_slots := boundary_slots t;
  face_slots := face_slots t;
  is_vertex := is_vertex t;
  is_half_edge := is_half_edge t;
  is_boundary := is_boundary t;
  is_face := is_face t;
  says_origin := says_origin t;
  says_twin := says_twin t;
  says_next := says_next t;
  says_prev := says_prev t;
  says_boundary := says_boundary t;
  says_leaving := says_leaving t;
  says_isolated := says_isolated t;
  says_boundary_face := fun c => if c == b then Some g else says_boundary_face t c;
  says_boundary_start := says_boundary_start t;
  says_boundary_place := fun c => if c == b then Some (Inner (inner_count t g)) else says_boundary_place t c;
  says_outer := says_outer t;
  says_inner_count := fun h => if h == f then (inner_count t f).-1 else
    if h == g then (inner_count t g).+1 else says_inner_count t h;
  says_inner := fun h i => if (h == g) && (i == inner_count t g) then Some b else says_inner t h i
|}.

(** The face [h] is inside the component whose outside is [b]: that component bounds it, or bounds a face in which the
    component that bounds [h] lies, and so on. *)
Inductive inside t b : nat -> Prop :=
  | inside_here h c w : outer t h = Some c -> vertex_at t c = Some w -> outside_of t w b -> inside t b h
  | inside_deeper h c w d h' : outer t h = Some c -> vertex_at t c = Some w ->
      outside_of t w d -> boundary_face t d = Some h' -> inside t b h' -> inside t b h.

Section MoveInner.
Variables (t : view) (b f g : nat).
Hypothesis keeps : rules t.
Hypothesis in_f : boundary_face t b = Some f.
Hypothesis last_of_f : boundary_place t b = Some (Inner (inner_count t f).-1).
Hypothesis live_g : face t g.
Hypothesis other_face : g != f.

Notation t' := (move_inner t b f g).
Let low : lower t. Proof. by move=> q _; apply: keeps. Qed.
Let live_b : boundary t b := heard_live in_f.

Lemma moved_face c : boundary_face t' c = if c == b then Some g else boundary_face t c.
Proof.
by rewrite /boundary_face /heard -[boundary t' c]/(boundary t c) /=; case: eqP => [->|_] //; rewrite live_b.
Qed.

Lemma moved_place c : boundary_place t' c = if c == b then Some (Inner (inner_count t g)) else boundary_place t c.
Proof.
by rewrite /boundary_place /heard -[boundary t' c]/(boundary t c) /=; case: eqP => [->|_] //; rewrite live_b.
Qed.

Lemma listed_b h p : listed t h p = Some b <-> h = f /\ p = Inner (inner_count t f).-1.
Proof.
have [f' [p' [Ef Ep L]]] := keeps F2 b live_b; rewrite L.
by move: Ef Ep; rewrite in_f last_of_f => -[->] [->].
Qed.

Lemma f_lists_b : inner t f (inner_count t f).-1 = Some b. Proof. exact: (listed_b f (Inner _)).2. Qed.

Lemma f_lists_some : (inner_count t f).-1 < inner_count t f.
Proof. by move: f_lists_b; rewrite /inner; case: ifP. Qed.

Lemma live_f : face t f. Proof. by move: f_lists_some; rewrite /inner_count; case: ifP. Qed.

Lemma moved_count h : inner_count t' h =
  if h == f then (inner_count t f).-1 else if h == g then (inner_count t g).+1 else inner_count t h.
Proof.
rewrite {1}/inner_count /= -[face t' h]/(face t h); case: eqP => [->|_]; first by rewrite live_f.
by case: eqP => [->|_] //; rewrite live_g.
Qed.

(** All that is listed elsewhere than [b] is listed where it was. *)
Lemma moved_listed h p c : listed t' h p = Some c <->
  (c <> b /\ listed t h p = Some c) \/ [/\ c = b, h = g & p = Inner (inner_count t g)].
Proof.
case: p => [|i].
  split=> [E|[[]//|[]//]]; left; split=> // cb.
  by have := (listed_b h Outer).1; rewrite -cb => /(_ E)[].
rewrite /= /inner moved_count /=; case: (h =P f) => [->|hf].
  rewrite eq_sym (negPf other_face) /=; split=> [|[[cb]|[_ fg]]]; last by case/eqP: other_face.
    case: ifP => // lt E; left; have lt' : i < inner_count t f := leq_trans lt (leq_pred _); rewrite lt'.
    split=> // cb; have [_ [ii]] : f = f /\ Inner i = Inner (inner_count t f).-1.
      by apply/listed_b; rewrite /= /inner lt' -cb.
    by move: lt; rewrite ii ltnn.
  case: ifP => // lt E; suff -> : i < (inner_count t f).-1 by [].
  rewrite ltn_neqAle -ltnS (ltn_predK lt) lt andbT; apply/eqP=> ii; apply: cb.
  by have := f_lists_b; rewrite /inner f_lists_some -ii E => -[].
have nb j : inner t h j <> Some b by move/(listed_b h (Inner j))=> [].
case: (h =P g) => [hg|hg] /=; last first.
  split=> [E|[[]//|[]//]]; left; split=> // cb; apply: (nb i); by rewrite -cb /inner.
case: (i =P inner_count t g) => [->|ii].
  rewrite ltnSn hg ltnn; split=> [[<-]|[[]//|[->]]] //; by right.
rewrite ltnS leq_eqVlt; case: eqP => //= _; rewrite hg; split=> [E|[[]//|[_ _ []]//]].
by left; split=> // cb; apply: (nb i); rewrite -cb /inner hg.
Qed.

Lemma move_links : links_live t'.
Proof.
have [[H V B F] _] := keeps R1; split=> // [c lc|h lh].
  have [L S] := B c lc; split=> //; rewrite moved_face; case: eqP => // _; by exists g.
have [O _] := F h lh; split=> // i lt; case E: (inner t' h i) => [c|].
  exists c => //; case: ((moved_listed h (Inner i) c).1 E) => [[_ /(listed_live low)]|[-> _ _]] //; exact: live_b.
move: E; rewrite /inner lt /=; case: ifP => // no E; have [_ I] := F h lh.
have [d] : leads_to (boundary t) (inner t h i).
  apply: I; move: lt; rewrite moved_count; case: eqP => [->|_]; first by move=> lt; apply: leq_trans lt (leq_pred _).
  by case: eqP no => //= -> /negbT ni; rewrite ltnS leq_eqVlt (negPf ni).
by rewrite /inner E; case: ifP.
Qed.

Lemma move_f2 : f2_listed t'.
Proof.
move=> c lc; rewrite moved_face moved_place; case: eqP => [->|cb].
  exists g, (Inner (inner_count t g)); split=> // h p; split=> [/moved_listed[[]|[]] //|[-> ->]].
  by apply/moved_listed; right.
have [h [p [Ef Ep L]]] := keeps F2 c lc; exists h, p; split=> // h' p'; rewrite -L; split=> [/moved_listed[[]|[]] //|E].
by apply/moved_listed; left.
Qed.

Lemma move_connected u w : connected t' u w <-> connected t u w.
Proof.
split; first by elim=> [|h x y _ IH O T]; [apply: connected_self|apply: connected_edge IH O T].
by elim=> [|h x y _ IH O T]; [apply: connected_self|apply: (@connected_edge t') IH O T].
Qed.

Lemma moved_inner c : is_inner t' c <-> is_inner t c.
Proof.
rewrite /is_inner moved_place; case: eqP => [->|_] //; split=> _; last by exists (inner_count t g).
by exists (inner_count t f).-1.
Qed.

Lemma move_outside u c : outside_of t' u c <-> outside_of t u c.
Proof.
split=> -[/moved_inner I [w W /move_connected C]]; first by split=> //; exists w.
by split; [apply/moved_inner; apply/moved_inner|exists w => //; apply/move_connected; apply/move_connected].
Qed.

Lemma move_t1 : t1_outside t'.
Proof.
move=> u lu; have [c [O one]] := keeps T1 u lu; exists c; split; first exact/move_outside.
by move=> d /move_outside; apply: one.
Qed.

Lemma move_rooted_outside h : rooted t h -> ~ inside t b h -> rooted t' h.
Proof.
elim=> [k U _|k c w d k' E W O D _ IH no]; first exact: (@rooted_here t').
apply: (@rooted_out t' k c w d k') => //; first exact/move_outside.
  by rewrite moved_face; case: eqP => // db; case: no; rewrite db in O; apply: inside_here E W O.
by apply: IH => deep; apply: no; apply: inside_deeper E W O D deep.
Qed.

Lemma move_rooted h : ~ inside t b g -> rooted t h -> rooted t' h.
Proof.
move=> no; elim=> [k U|k c w d k' E W O D _ IH]; first exact: (@rooted_here t').
case: (d =P b) => [db|db].
  apply: (@rooted_out t' k c w d g) => //; [exact/move_outside|by rewrite moved_face db eqxx|].
  exact: move_rooted_outside (face_rooted low (keeps T1) (keeps T2) live_g) no.
by apply: (@rooted_out t' k c w d k') => //; [exact/move_outside|rewrite moved_face; case: eqP].
Qed.

Lemma move_t2 : ~ inside t b g -> t2_nesting t'.
Proof.
move=> no u c h lu /move_outside O; rewrite moved_face => E; apply: (move_rooted no); apply: (face_rooted low (keeps T1) (keeps T2)).
case: eqP E => [_ [<-] //|_ E]; have [[_ _ B _] _] := keeps R1.
by have [[h' + lh] _] := B c (heard_live E); rewrite E => -[->].
Qed.

Lemma lists_iff (s : seq nat) (P Q : nat -> Prop) : (forall x, P x <-> Q x) -> lists s P -> lists s Q.
Proof. by move=> PQ [u all]; split=> // x; rewrite all. Qed.

Lemma lists_one_iff (s : seq nat) same (P Q : nat -> Prop) : (forall x, P x <-> Q x) ->
  lists_one_of_each s same P -> lists_one_of_each s same Q.
Proof. by move=> PQ [u ok one all]; split=> // [x /ok/PQ|x /PQ/all]. Qed.

Lemma move_half_edge_of u h : half_edge_of t u h <-> half_edge_of t' u h.
Proof. by split=> -[w O C]; exists w => //; apply/move_connected. Qed.

Lemma move_t3 : t3_euler t'.
Proof.
move=> u lu; have [V [E [cycles [[vs [es [cs [Vs Es Cs N]]]] eq]]]] := keeps T3 u lu.
exists V, E, cycles; split=> //; exists vs, es, cs; split=> //.
- by apply: lists_iff Vs => x; apply: iff_sym; apply: move_connected.
- exact: lists_one_iff (move_half_edge_of u) Es.
exact: lists_one_iff (move_half_edge_of u) Cs.
Qed.

Lemma insideP h c w : inside t b h -> outer t h = Some c -> vertex_at t c = Some w ->
  outside_of t w b \/ exists d h', [/\ outside_of t w d, boundary_face t d = Some h' & inside t b h'].
Proof.
by case=> [k c' w' E W O|k c' w' d k' E W O D I]; rewrite E => -[<-]; rewrite W => -[<-]; [left|right; exists d, k'].
Qed.

(** If the component is moved to a face inside it, no face inside it is rooted any more. *)
Lemma move_unrooted h : inside t b g -> rooted t' h -> ~ inside t b h.
Proof.
move=> in_g; elim=> [k [_ U] k_in|k c w d k' E W O D _ IH k_in].
  by case: k_in U => [h' c w|h' c w d h''] E; rewrite -[outer t' h']/(outer t h') E.
have lw : vertex t w.
  have [[H _ B _] _] := keeps R1; move: W; rewrite -[vertex_at t' c]/(vertex_at t c) /vertex_at.
  case S: (boundary_start t c) => [[x|x]|] //= W; last by case: W => <-; have [_] := B c (heard_live S); rewrite S.
  by have [[u + lu] _ _ _ _] := H x (heard_live W); rewrite W => -[->].
have one e : outside_of t w e -> d = e.
  by move=> Oe; have [a [_ un]] := keeps T1 w lw; rewrite -(un e Oe); apply/esym/un/move_outside.
apply: IH; case: (insideP k_in (E : outer t k = Some c) (W : vertex_at t c = Some w)) D => [/one->|[e [h' [/one-> De in_h]]]].
  by rewrite moved_face eqxx => -[<-].
by rewrite moved_face; case: eqP => [_ [<-] //|_]; rewrite De => -[<-].
Qed.

(** If the other face is not inside the component, all rules hold after the move; otherwise T2 is broken. *)
Theorem move_inner_keeps_rules : rules t' <-> ~ inside t b g.
Proof.
split=> [ok in_g|no].
  have [w W lw] : exists2 w, vertex_at t b = Some w & vertex t w.
    have [[H _ B _] _] := keeps R1; have [_] := B b live_b; rewrite /vertex_at.
    case: (boundary_start t b) => [[k|x]|] //= l; last by exists x.
    by have [[w W lw] _ _ _ _] := H k l; exists w.
  apply: (move_unrooted in_g) in_g; apply: (ok T2 w b g lw); last by rewrite moved_face eqxx.
  by apply/move_outside; split; [exists (inner_count t f).-1|exists w => //; apply: connected_self].
have H r : index r < index T4 -> holds t' r.
  case: r => // _; [by split; [exact: move_links|exact: lists_short_listed move_links move_f2]|exact: (keeps L1)|exact: (keeps L2)|exact: (keeps L3)|exact: (keeps V1)|
    exact: (keeps V2)|exact: (keeps B1)|exact: (keeps B2)|exact: (keeps F1)|exact: move_f2|exact: move_t1|
    exact: move_t2|exact: move_t3].
by move=> r; case: (ltnP (index r) (index T4)) => [/H //|]; case: r => // _; apply: t4_follows => q; apply: H.
Qed.

End MoveInner.
