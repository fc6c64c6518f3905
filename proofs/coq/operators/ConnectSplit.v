(** * ConnectSplit: connecting two corners of one cycle keeps all rules (`split_face` in dcel/operators/connect.rs)

    The corners after [a] and after [b] are on one cycle, that of the boundary component [kept] of the face [f]. The new edge
    makes two cycles of it: one to the left of [h], from [next b] to [a] and back along [h], and one to the right, along
    [k]. One of the two is that of [kept], and the other that of the new boundary component [made]. One of the two bounds
    the new face [g].

<<
          ┌──────────◄─────────┐
          │   right   b        │          a ──► h ──► next b ──► … ──► a         the left cycle
          │      k ▲│ ───┐     │
          │        ││    │     │          b ──► k ──► next a ──► … ──► b         the right cycle
          │      h │▼    ▼     │
          └────── a   left ────┘
>>

    Which of the two is shorter, and so has [made]; which is to bound [g]; and which inner boundary components of [f] go to
    [g]: each is told, and it is right whatever is told. *)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import Arith View Rules Loops LoopsProof Map Counting Lists Genus Verdict NewEdge NewFace ConnectCorners Stretch.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** The half-edges to the left of the new edge. *)
Definition left_side t a b := if next t b is Some x then stretch (next t) (half_edge_slots t) x a else [::].

(** The view [t] with the edge [h], [k] between the corners after [a] and after [b], which are on the cycle of [kept], and
    with the boundary components [left] and [right], one of which is [kept], to its left and right. *)
Definition split_cycle t a b h k kept left right : view := let n := attach t a b h k in {|
  vertex_slots := vertex_slots n;
  half_edge_slots := half_edge_slots n;
  boundary_slots := boundary_slots n;
  face_slots := face_slots n;
  is_vertex := is_vertex n;
  is_half_edge := is_half_edge n;
  is_boundary := is_boundary n;
  is_face := is_face n;
  says_origin := says_origin n;
  says_twin := says_twin n;
  says_next := says_next n;
  says_prev := says_prev n;
  says_boundary := fun i => if (i == h) || (i \in left_side t a b) then Some left else
    if (i == k) || (boundary_of t i == Some kept) then Some right else says_boundary n i;
  says_leaving := says_leaving n;
  says_isolated := says_isolated n;
  says_boundary_face := says_boundary_face n;
  says_boundary_start := fun c => if c == left then Some (AtHalfEdge h) else
    if c == right then Some (AtHalfEdge k) else says_boundary_start n c;
  says_boundary_place := says_boundary_place n;
  says_outer := says_outer n;
  says_inner_count := says_inner_count n;
  says_inner := says_inner n
|}.

(** [made_left]: the left cycle has the new boundary component. [new_left]: the new face is to the left. [moved]: the inner
    boundary components that go to the new face. *)
Definition split_face t a b h k f g kept made (made_left new_left : bool) moved : view :=
  let left := if made_left then made else kept in
  let right := if made_left then kept else made in
  new_face t (split_cycle t a b h k kept left right) f g kept made
    (if new_left then right else left) (if new_left then left else right) moved.

Section Split.
Variables (t : view) (a b h k f g kept made left right of_old of_new : nat) (moved : pred nat).
Variables (na nb oa ob : nat).
Hypothesis keeps : rules t.
Hypothesis free_h : ~~ half_edge t h.
Hypothesis free_k : ~~ half_edge t k.
Hypothesis hk : h != k.
Hypothesis free_boundary : ~~ boundary t made.
Hypothesis free_face : ~~ face t g.
Hypothesis boundary_a : boundary_of t a = Some kept.
Hypothesis boundary_b : boundary_of t b = Some kept.
Hypothesis kept_in_f : boundary_face t kept = Some f.
Hypothesis sides : left = kept /\ right = made \/ left = made /\ right = kept.
Hypothesis faces : of_old = left /\ of_new = right \/ of_old = right /\ of_new = left.
Hypothesis next_a : next t a = Some na.
Hypothesis next_b : next t b = Some nb.
Hypothesis target_a : target t a = Some oa.
Hypothesis target_b : target t b = Some ob.

Notation t' := (new_face t (split_cycle t a b h k kept left right) f g kept made of_old of_new moved).
Let low : lower t. Proof. by move=> q _; apply: keeps. Qed.
Let map : is_map t := low_map low.
Let live_a : half_edge t a := heard_live boundary_a.
Let live_b : half_edge t b := heard_live boundary_b.

Lemma split_attached : attached t t' a b h k.
Proof. by have [] := attach_attached h k (low_r1 low) live_a live_b. Qed.

Let new := split_attached.
Let half_edgeE := ConnectCorners.half_edgeE new.
Let originE := ConnectCorners.originE new.
Let nextE := ConnectCorners.nextE new.
Let old_h := NewEdge.old_h free_h.
Let old_k := NewEdge.old_k free_k.
Let links_of := NewEdge.links_of keeps.
Let start_live := NewEdge.start_live keeps.
Let up_half_edge := NewEdge.up_half_edge half_edgeE.
Let half_edgeP := NewEdge.half_edgeP free_h free_k half_edgeE.
Let newE := NewEdge.newE hk.
Let next_boundary := next_boundary keeps.
Let origin_up := origin_up free_h free_k new.
Let bare_attached := bare_attached keeps free_h free_k hk new live_a live_b.

Let cut := split_cycle t a b h k kept left right.
Let boundaryE : forall c, boundary t' c = (c == made) || boundary t c.
Proof. exact: NewFace.boundaryE. Qed.
Let left_not_right : left <> right := left_not_right free_boundary kept_in_f sides.
Let live_left : boundary t' left. Proof. by apply: NewFace.live_left kept_in_f sides. Qed.
Let live_right : boundary t' right. Proof. by apply: NewFace.live_right kept_in_f sides. Qed.
Let startE c : boundary t' c -> boundary_start t' c =
  if c == left then Some (AtHalfEdge h) else if c == right then Some (AtHalfEdge k) else boundary_start t c.
Proof. by move=> lc; apply: (@NewFace.startE t cut f g kept made left right of_old of_new moved sides h k). Qed.
Let otherP c : boundary t' c -> c <> left -> c <> right -> other kept made c /\ boundary t c.
Proof. exact: (@NewFace.otherP t cut f g kept made left right of_old of_new moved sides). Qed.

(** ** The left side *)

Notation side := (left_side t a b).

Lemma side_facts :
  [/\ nb \in side, a \in side, forall i n, i \in side -> i <> a -> next t i = Some n -> n \in side,
      forall i n, n \in side -> next t i = Some n -> n = nb \/ i \in side /\ i <> a
    & (a <> b -> b \notin side) /\ forall i, i \in side -> boundary_of t i = Some kept].
Proof.
have Bnb : boundary_of t nb = Some kept by rewrite (next_boundary next_b).
have total i : half_edge t i -> exists2 n, next t i = Some n & half_edge t n by case/links_of.
have inj i j : half_edge t i -> half_edge t j -> next t i = next t j -> i = j.
  by move=> li lj; have [n N _] := total i li; rewrite N => /esym; apply: (next_one keeps).
have below := @half_edge_below t; have C := cycle_of keeps Bnb boundary_a; have live_nb := heard_live Bnb.
rewrite /left_side next_b; have [nb_in a_in] := stretch_ends below total live_nb C; split=> //.
- by move=> i n; apply: (stretch_step below total live_nb C).
- by move=> i n ns N; apply: (stretch_back below total inj live_nb C (heard_live N) ns N).
split=> [ab|i /(stretch_on below total live_nb C)]; first by apply: (stretch_before below total live_nb C) next_b; apply: nesym.
by move/(constant_on_cycle (keeps B1).1)=> ->.
Qed.

Let side_b : a <> b -> b \notin side. Proof. by have [_ _ _ _ []] := side_facts. Qed.
Let side_kept i : i \in side -> boundary_of t i = Some kept. Proof. by have [_ _ _ _ [_]] := side_facts; apply. Qed.

(** ** What the view says *)

Lemma boundary_ofE i : boundary_of t' i = if (i == h) || (i \in side) then Some left else
  if (i == k) || (boundary_of t i == Some kept) then Some right else boundary_of t i.
Proof.
rewrite {1}/boundary_of /heard half_edgeE /=; case: (i =P h) => //= _.
case: (i =P k) => [->|_] //=; case: (boolP (half_edge t i)) => [li|no].
  by case: (i \in side) => //; case: ifP => // _; rewrite /boundary_of /heard li.
have none : boundary_of t i = None by rewrite /boundary_of /heard (negPf no).
by case: ifP => [/side_kept|_]; rewrite none.
Qed.

Lemma not_made i : boundary_of t i <> Some made.
Proof.
move=> B; have [_ _ _ _ [c C lc]] := links_of (heard_live B); move: C lc; rewrite B => -[<-].
by rewrite (negPf free_boundary).
Qed.

(** ** R1 to V2 *)

Lemma split_half_edges : half_edges_live t'.
Proof.
move=> i li; have [A1 A2 A3 A4] := attached_links keeps free_h free_k hk new live_a live_b next_a next_b target_a target_b li.
split=> //; rewrite boundary_ofE; case: ifP => [_|n1]; first by exists left; rewrite ?live_left.
case: ifP => [_|n2]; first by exists right; rewrite ?live_right.
case/half_edgeP: li n1 n2 => [||{A1 A2 A3 A4}i li ih ik]; rewrite ?eqxx ?orbT // => _ _.
by have [_ _ _ _ [c C lc]] := links_of li; exists c; rewrite // boundaryE lc orbT.
Qed.

Lemma split_vertices : vertices_live t'.
Proof.
move=> u lu; have [[_ V _ _] _] := keeps R1; have [L I] := V u lu; split.
  by case: L => [[e E le]|[N Bu]]; [left; exists e; rewrite ?up_half_edge|right; split=> //; apply/bare_attached].
by case: I => [N|[c C lc]]; [left|right; exists c; rewrite // boundaryE lc orbT].
Qed.

Lemma split_l1 : l1_twin t'. Proof. exact: (attached_l1 keeps free_h free_k hk new). Qed.
Lemma split_l2 : l2_next_prev t'.
Proof. exact: (attached_l2 keeps free_h free_k hk new live_a live_b next_a next_b). Qed.
Lemma split_l3 : l3_target t'.
Proof. exact: (attached_l3 keeps free_h free_k hk new live_a live_b next_a next_b). Qed.

Let map' : is_map t'.
Proof. by split; [exact: split_half_edges|exact: split_l1|exact: split_l2|exact: split_l3]. Qed.

Lemma split_v1 : v1_leaving t'. Proof. by move=> u e lu E; apply: origin_up; apply: (keeps V1). Qed.

Lemma split_v2 : v2_rotation t'.
Proof. exact: (attached_v2 keeps free_h free_k hk new live_a live_b next_a next_b map'). Qed.

(** ** B1 *)

Lemma at_h : boundary_of t' h = Some left. Proof. by rewrite boundary_ofE eqxx. Qed.

Lemma at_k : boundary_of t' k = Some right.
Proof.
rewrite boundary_ofE newE /=; case: ifP => [ks|_]; last by rewrite eqxx.
by have := heard_live (side_kept ks); rewrite (negPf free_k).
Qed.

Lemma constant i : half_edge t' i -> next t' i >>= boundary_of t' = boundary_of t' i.
Proof.
have [S_nb S_a S_next S_prev _] := side_facts.
have in_side j : j \in side -> boundary_of t' j = Some left by move=> js; rewrite boundary_ofE js orbT.
have not_side j : half_edge t j -> j \notin side -> boundary_of t j = Some kept -> boundary_of t' j = Some right.
  by move=> lj /negPf js B; rewrite boundary_ofE old_h // js B eqxx orbT.
case/half_edgeP=> [||{}i li ih ik]; rewrite nextE ?newE.
- by rewrite next_b /= at_h; apply: in_side.
- rewrite at_k; case: (a =P b) => [_|ab] /=; first exact: at_k.
  rewrite next_a /=; apply: not_side; [exact: (live_next keeps live_a next_a)| |by rewrite (next_boundary next_a)].
  apply/negP=> ns; case: (S_prev a na ns next_a) => [E|[_ []//]].
  by apply: ab; apply: (next_one keeps live_a live_b next_a); rewrite E.
rewrite ih ik; case: (i =P a) => [->|ia] /=; first by rewrite at_h in_side.
case: (i =P b) => [ib|ib] /=.
  by rewrite at_k; apply/esym/not_side => //; rewrite ib //; apply: side_b => ab; apply: ia; rewrite ib.
have [_ _ [m M lm] _ _] := links_of li; rewrite M /= !boundary_ofE !old_h ?old_k // (next_boundary M).
have -> // : (m \in side) = (i \in side).
apply/idP/idP => [ms|is_]; last exact: S_next is_ ia M.
by case: (S_prev i m ms M) => [mn|[]//]; case: ib; apply: (next_one keeps li live_b M); rewrite mn.
Qed.

(** All that was on the cycle is on one of the two now. *)
Lemma on_either i : boundary_of t i = Some kept -> on_cycle t' h i \/ on_cycle t' k i.
Proof.
have H_nb : on_cycle t' h nb by apply: orbit_step (orbit_refl _ _) _; rewrite nextE eqxx.
have E_na : on_cycle t' h na \/ on_cycle t' k na.
  case: (a =P b) => [ab|ab]; [left|right].
    by have -> : na = nb by move: next_a; rewrite ab next_b => -[].
  by apply: orbit_step (orbit_refl _ _) _; rewrite nextE !newE (introF eqP ab).
move=> Bi; have [m] : on_cycle t na i by apply: (cycle_of keeps) Bi; rewrite (next_boundary next_a).
elim: m i {Bi} => [|m IH] i /=; first by case=> <-.
case E: (iter m _ _) => [u|] //= U; have := IH u E; have lu := heard_live U.
case: (u =P a) => [ua|ua]; first by move: U; rewrite ua next_a => -[<-].
case: (u =P b) => [ub|ub]; first by move: U; rewrite ub next_b => -[<-]; left.
have N : next t' u = Some i by rewrite nextE old_h ?old_k // (introF eqP ua) (introF eqP ub).
by case=> C; [left|right]; apply: orbit_step C N.
Qed.

Lemma split_b1 : b1_cycle t'.
Proof.
split=> [i /constant //|c i lc li]; have same g' := @constant_on_cycle t' g' i constant.
have lr := left_not_right; rewrite startE //.
split=> [Bi|[g' S C]]; last first.
  rewrite (same g' C); case: (c =P left) S => [-> [<-]|cl]; first exact: at_h.
  case: (c =P right) => [-> [<-]|cr S]; first exact: at_k.
  have [[ck _] lc0] := otherP lc cl cr; have Bg := start_on_cycle keeps S.
  rewrite boundary_ofE old_h ?old_k ?(start_live S) //= Bg.
  by case: ifP => [/side_kept|_]; [rewrite Bg => -[/ck]|case: eqP => // -[/ck]].
have two_sides : c = left \/ c = right -> boundary_of t i = Some kept \/ i = h /\ c = left \/ i = k /\ c = right.
  move: Bi; rewrite boundary_ofE; case: (i =P h) => [->|_] /=; first by case=> <-; auto.
  case: ifP => [/side_kept|_]; first by auto.
  case: (i =P k) => [->|_] /=; first by case=> <-; auto.
  case: eqP => [->|_]; first by auto.
  move=> Bi cc; left; have := @not_made i; rewrite Bi.
  by case: cc => ->; case: sides => -[E E']; rewrite ?E ?E'.
case: (c =P left) => [cl|cl].
  exists h => //; case: two_sides => [|Bk|[[-> _]|[ik cr]]]; [by left| |exact: orbit_refl|].
    by case: (on_either Bk) => // /same; rewrite Bi at_k cl => -[/lr].
  by case: lr; rewrite -cl.
case: (c =P right) => [cr|cr].
  exists k => //; case: two_sides => [|Bk|[[_ /cl//]|[-> _]]]; [by right| |exact: orbit_refl].
  by case: (on_either Bk) => // /same; rewrite Bi at_h cr => -[/esym/lr].
have [[ck _] lc0] := otherP lc cl cr; move: Bi; rewrite boundary_ofE.
case: ifP => [_ [/esym/cl]//|_]; case: ifP => [_ [/esym/cr]//|_ Bi].
have [g' S C] := start_of_cycle keeps Bi; exists g' => //.
by apply: (cycle_away keeps free_h free_k new (start_on_cycle keeps S) _ _ C); rewrite ?boundary_a ?boundary_b => -[/esym/ck].
Qed.

(** ** B2 *)

Lemma kept_start : exists2 e, boundary_start t kept = Some (AtHalfEdge e) & on_cycle t e a.
Proof. exact: (start_of_cycle keeps boundary_a). Qed.

Lemma starts_same u c : starts_at_vertex t' u c <-> starts_at_vertex t u c.
Proof.
have none : starts_at_vertex t u c -> c <> left /\ c <> right.
  have [e S _] := kept_start; rewrite /starts_at_vertex => Su.
  have ck : c <> kept by move=> ck; move: Su; rewrite ck S.
  have cm : c <> made by move=> cm; move: free_boundary; rewrite -cm (heard_live Su).
  by case: sides => -[-> ->].
split=> S; last first.
  have [cl cr] := none S; have lc : boundary t' c by rewrite boundaryE (heard_live S) orbT.
  by rewrite /starts_at_vertex startE // (introF eqP cl) (introF eqP cr).
by move: S; rewrite /starts_at_vertex => S; move: (S); rewrite startE ?(heard_live S) //; case: ifP => // _; case: ifP.
Qed.

Lemma split_b2 : b2_isolated t'.
Proof.
move=> u lu; have [A N] := keeps B2 u lu; split=> [/bare_attached /A[c [E S]]|nbare].
  by exists c; split=> // d; rewrite -S; apply: starts_same.
have [|E S] := N; first by move=> B; apply: nbare; apply/bare_attached.
by split=> // c /starts_same; apply: S.
Qed.

(** ** F1 to T3 *)

Lemma kept_at : exists v, [/\ vertex_at t kept = Some v, connected t v oa & connected t v ob].
Proof.
have O c n o : half_edge t c -> next t c = Some n -> target t c = Some o -> boundary_of t c = Some kept ->
    exists2 v, vertex_at t kept = Some v & connected t v o.
  move=> lc N T B; have On : origin t n = Some o by rewrite (origin_next keeps lc N).
  have Bn : boundary_of t n = Some kept by rewrite (next_boundary N).
  by have [_] := on_side low Bn On.
have [v V A] := O a na oa live_a next_a target_a boundary_a.
have [w W B] := O b nb ob live_b next_b target_b boundary_b.
by exists v; split=> //; move: W; rewrite V => -[->].
Qed.

Lemma connected_same u w : connected t' u w <-> connected t u w.
Proof.
have [v [_ A B]] := kept_at; have trans := @connected_trans t; have sym := connected_sym map.
apply: iff_trans (connectedE keeps free_h free_k hk new target_a target_b u w) _.
split=> [|C]; last by constructor 1.
case=> [//|[C D]|[C D]]; first exact: trans C (trans _ _ _ (sym _ _ A) (trans _ _ _ B D)).
exact: trans C (trans _ _ _ (sym _ _ B) (trans _ _ _ A D)).
Qed.

Lemma origin_sides : origin t' h = Some oa /\ origin t' k = Some ob.
Proof. by rewrite !originE !newE target_a target_b. Qed.

Lemma split_rules : rules t'.
Proof.
have [v0 [V A B]] := kept_at; have [Oh Ok] := origin_sides; have [lh lk] := live_new new.
have vE v : vertex t' v = vertex t v by [].
apply: (@new_face_rules t cut f g kept made left right of_old of_new moved keeps free_boundary free_face kept_in_f
  sides faces h k (fun c => erefl) vE connected_same origin_up v0 V).
- by exists oa.
- by exists ob.
- exact: split_half_edges.
- exact: split_vertices.
- exact: up_half_edge.
- exact: lh.
- exact: lk.
- exact: split_l1.
- exact: split_l2.
- exact: split_l3.
- exact: split_v1.
- exact: split_v2.
- exact: split_b1.
- exact: split_b2.
exact: (edges_attached keeps free_h free_k new).
Qed.

End Split.

(** Let [h] and [k], [made] and [g] be free slots, and the corners after [a] and after [b] be on one cycle: if all rules
    held before, they hold after, whatever is told. *)
Theorem split_face_keeps_rules t a b h k f g kept made made_left new_left moved :
  boundary_of t a = Some kept -> boundary_of t b = Some kept -> boundary_face t kept = Some f ->
  ~~ half_edge t h -> ~~ half_edge t k -> h != k -> ~~ boundary t made -> ~~ face t g ->
  rules t -> rules (split_face t a b h k f g kept made made_left new_left moved).
Proof.
move=> Ba Bb kf fh fk hk fm fg keeps.
have links c : boundary_of t c = Some kept -> exists n o, next t c = Some n /\ target t c = Some o.
  move=> B; have lc := heard_live B; have [_ [d D ld] [n N _] _ _] := links_of keeps lc.
  by have [[o O _] _ _ _ _] := links_of keeps ld; exists n, o; rewrite /target D.
have [na [oa [Na Ta]]] := links a Ba; have [nb [ob [Nb Tb]]] := links b Bb.
by rewrite /split_face; apply: (split_rules _ keeps fh fk hk fm fg Ba Bb kf _ _ Na Nb Ta Tb);
  [case: made_left; auto|case: new_left; auto].
Qed.
