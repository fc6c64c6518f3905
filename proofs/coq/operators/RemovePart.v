(** * RemovePart: removing a bridge keeps all rules (`part` in dcel/operators/remove.rs)

    Both sides of the edge are on the cycle of one boundary component, [kept]. Without the edge the component falls into two, and
    so does the cycle: one part is what goes on from where [n] began, the other one what goes on from where it ended. The boundary
    component of the first is [at_n], that of the other one is [at_m]; one of the two is [kept], the other one is new, [made].

<<
        ┌───┐   n   ┌───┐         ┌───┐       ┌───┐       an inner one: both parts are inner ones.
        │   ├───────┤   │   ──►   │   │       │   │       an outer one: the part that has the outside of the component
        └───┘       └───┘         └───┘       └───┘       stays the outer one, and the other part is an inner one.
>>

    A part may be a vertex alone, which is isolated then. Which part has the outside is told by a way that leads there without the
    edge. *)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import Arith View Rules Map Counting Lists NewEdge ConnectCorners ConnectSplit Core Tidy Collapse RemoveEdge.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** The view [t] without the edge of [n] and [m], with the boundary component [made] in the face [f]; places and lists are as they
    were. *)
Definition parted t n m f kept made at_n at_m : view := let o := take_out t n m at_n at_m in {|
  vertex_slots := vertex_slots o;
  half_edge_slots := half_edge_slots o;
  boundary_slots := maxn (boundary_slots o) made.+1;
  face_slots := face_slots o;
  is_vertex := is_vertex o;
  is_half_edge := is_half_edge o;
  is_boundary := fun b => (b == made) || boundary t b;
  is_face := is_face o;
  says_origin := says_origin o;
  says_twin := says_twin o;
  says_next := says_next o;
  says_prev := says_prev o;
  says_boundary := fun i => if boundary_of t i == Some kept then Some (if i \in left_side t m n then at_m else at_n) else
    says_boundary o i;
  says_leaving := says_leaving o;
  says_isolated := says_isolated o;
  says_boundary_face := fun b => if b == made then Some f else says_boundary_face o b;
  says_boundary_start := fun b => if b == at_n then start_left t n m n else if b == at_m then start_left t n m m else
    says_boundary_start o b;
  says_boundary_place := says_boundary_place o;
  says_outer := says_outer o;
  says_inner_count := says_inner_count o;
  says_inner := says_inner o
|}.

(** Both parts are inner ones if the cycle was; otherwise all but [stays]. *)
Definition parted_inn t kept made stays b :=
  if (b == kept) || (b == made) then inn_of t kept || (b != stays) else inn_of t b.

Definition part_component t n m f kept made at_n at_m stays :=
  relist (parted t n m f kept made at_n at_m) (parted_inn t kept made stays).

(** The end of a way that begins at [u] and goes along these half-edges, none of which is of the edge of [n] and [m]. *)
Fixpoint way_ends t n m u way : link :=
  if way is i :: rest then
    if [&& i != n, i != m & origin t i == Some u] then (if target t i is Some w then way_ends t n m w rest else None) else None
  else Some u.

Section Part.
Variables (t : view) (n m f kept made at_n at_m stays un um : nat).
Hypothesis keeps : rules t.
Hypothesis twin_n : twin t n = Some m.
Hypothesis boundary_n : boundary_of t n = Some kept.
Hypothesis boundary_m : boundary_of t m = Some kept.
Hypothesis free_made : ~~ boundary t made.
Hypothesis parts : at_n = kept /\ at_m = made \/ at_n = made /\ at_m = kept.
Hypothesis stays_is : stays = at_n \/ stays = at_m.
Hypothesis face_kept : boundary_face t kept = Some f.
Hypothesis origin_n : origin t n = Some un.
Hypothesis origin_m : origin t m = Some um.

Notation t' := (parted t n m f kept made at_n at_m).
Notation inn := (inn_of t).
Notation inn' := (parted_inn t kept made stays).
Notation past := (past (next t) n m).
Notation corner := (corner t n m).
Notation side := (left_side t m n).
Let low : lower t. Proof. by move=> q _; apply: keeps. Qed.
Let map : is_map t := low_map low.
Let c : core t inn := core_of_rules keeps.
Let r : rest t inn := rest_of_rules keeps.
Let links_of := NewEdge.links_of keeps.
Let next_boundary := next_boundary keeps.

Lemma parted_out : taken_out t t' n m at_n at_m.
Proof. by case: (take_out_taken_out t n m at_n at_m). Qed.

Let out := parted_out.
Let twin_m : twin t m = Some n := twin_of keeps twin_n.
Let live_n : half_edge t n := heard_live twin_n.
Let live_m : half_edge t m := heard_live twin_m.
Let leftP := leftP out.
Let is_left := is_left out.
Let past_left := past_left out.
Let past_some := past_some keeps twin_n out.
Let next_some := next_some keeps.
Let out_l1 := out_l1 keeps twin_n out.
Let originE := originE out.
Let cycle_back := cycle_back keeps twin_n out.
Let n_not_m := n_not_m keeps twin_n.
Let live_kept : boundary t kept := heard_live face_kept.

(** The ends of the edge, and their boundary components. *)
Definition at_end x := if x == n then at_n else at_m.
Definition vertex_of x := if x == n then un else um.

Lemma at_end_n : at_end n = at_n. Proof. by rewrite /at_end eqxx. Qed.
Lemma at_end_m : at_end m = at_m. Proof. by rewrite /at_end; case: eqP => // /esym/n_not_m. Qed.
Lemma origin_end x : x = n \/ x = m -> origin t x = Some (vertex_of x).
Proof. by rewrite /vertex_of; case=> ->; [rewrite eqxx|case: eqP => // /esym/n_not_m]. Qed.
Lemma boundary_end x : x = n \/ x = m -> boundary_of t x = Some kept. Proof. by case=> ->. Qed.

Lemma kept_not_made : kept <> made. Proof. by move=> E; move: free_made; rewrite -E live_kept. Qed.
Lemma at_differ : at_n <> at_m. Proof. by case: parts => -[-> ->]; [|apply: nesym]; apply: kept_not_made. Qed.
Lemma at_is x : x = n \/ x = m -> at_end x = kept \/ at_end x = made.
Proof. by case=> ->; rewrite ?at_end_n ?at_end_m; case: parts => -[nE mE]; rewrite ?nE ?mE; auto. Qed.
Lemma an_end b : b = kept \/ b = made -> exists2 x, x = n \/ x = m & at_end x = b.
Proof.
by case: parts => -[nE mE] [->|->]; [exists n|exists m|exists m|exists n]; rewrite ?at_end_n ?at_end_m; auto.
Qed.

(** ** What the view says *)

Lemma boundaryE b : boundary t' b = (b == made) || boundary t b.
Proof. exact: one_more (@boundary_below t). Qed.

Lemma boundary_up b : boundary t b -> boundary t' b. Proof. by rewrite boundaryE orbC => ->. Qed.

Lemma live_at x : x = n \/ x = m -> boundary t' (at_end x).
Proof. by move/at_is=> [->|->]; rewrite boundaryE ?live_kept ?eqxx ?orbT. Qed.

(** A boundary component is one of the two parts, or was there and is none of them. *)
Variant which b : Prop :=
  | Part x of x = n \/ x = m & b = at_end x
  | Other of boundary t b & b <> kept & b <> made.

Lemma whichP b : boundary t' b -> which b.
Proof.
rewrite boundaryE => lb; case: (b =P kept) => [bk|bk]; first by have [x xe E] := an_end (or_introl bk); apply: Part xe _.
case: (b =P made) => [bm|bm]; first by have [x xe E] := an_end (or_intror bm); apply: Part xe _.
by apply: Other => //; move: lb; rewrite (introF eqP bm).
Qed.

Lemma old_not_made b : boundary t b -> b <> made. Proof. by move=> lb E; move: free_made; rewrite -E lb. Qed.

Lemma boundary_ofE i : half_edge t' i -> boundary_of t' i =
  if boundary_of t i == Some kept then Some (if i \in side then at_m else at_n) else boundary_of t i.
Proof.
move=> l; have [li _ _] := leftP l; rewrite {1}/boundary_of /heard l /=; case: ifP => // _.
by rewrite /boundary_of /heard li.
Qed.

Lemma faceE b x : boundary_face t b = Some x -> boundary_face t' b = Some x.
Proof.
move=> F; have lb := heard_live F; rewrite {1}/boundary_face /heard (boundary_up lb) /=.
by case: eqP => [/(old_not_made lb)//|_]; move: F; rewrite /boundary_face /heard lb.
Qed.

Lemma face_at x : x = n \/ x = m -> boundary_face t' (at_end x) = Some f.
Proof.
case/at_is=> ->; first exact: faceE.
by rewrite /boundary_face /heard boundaryE eqxx /= eqxx.
Qed.

Lemma face_down b x : boundary_face t' b = Some x -> b <> kept -> b <> made -> boundary_face t b = Some x.
Proof.
move=> F bk bm; case: (whichP (heard_live F)) => [y /at_is[] + bE|lb _ _]; rewrite -?bE //.
by have [y Y _] := core_face c lb; rewrite Y -F (faceE Y).
Qed.

Lemma inn_at x : x = n \/ x = m -> inn' (at_end x) = inn kept || (at_end x != stays).
Proof. by move/at_is=> [] ->; rewrite /parted_inn eqxx ?orbT. Qed.
Lemma inn_other b : b <> kept -> b <> made -> inn' b = inn b.
Proof. by rewrite /parted_inn => /eqP/negPf-> /eqP/negPf->. Qed.

(** ** The side of [m]: all from [next n] to [m] *)

Lemma side_n : n \notin side.
Proof.
have [b B _] := next_some live_m; have [a A _] := next_some live_n.
by have [_ _ _ _ [S _]] := side_facts keeps boundary_m boundary_n A; apply: S; apply: nesym.
Qed.
Lemma side_m : m \in side.
Proof.
have [b B _] := next_some live_m; have [a A _] := next_some live_n.
by have [_ S _ _ _] := side_facts keeps boundary_m boundary_n A.
Qed.

Lemma side_step i x : i <> n -> i <> m -> next t i = Some x -> (x \in side) = (i \in side).
Proof.
have [b B _] := next_some live_m; have [a A _] := next_some live_n.
have [_ _ S P _] := side_facts keeps boundary_m boundary_n A; move=> i_n im N; apply/idP/idP => [xs|is_]; last exact: S N.
by case: (P i x xs N) => [xa|[]//]; case: i_n; apply: (one_next keeps N); rewrite A xa.
Qed.

Lemma side_next_n x : next t n = Some x -> x \in side.
Proof.
have [b B _] := next_some live_m; have [a A _] := next_some live_n.
by have [S _ _ _ _] := side_facts keeps boundary_m boundary_n A; rewrite A => -[<-].
Qed.
Lemma side_next_m x : next t m = Some x -> x \notin side.
Proof.
have [b B _] := next_some live_m; have [a A _] := next_some live_n.
have [_ _ _ P _] := side_facts keeps boundary_m boundary_n A; move=> M; apply/negP=> xs.
by case: (P m x xs M) => [xa|[]//]; apply: n_not_m; apply: (one_next keeps A); rewrite M xa.
Qed.

Lemma past_n_is : past n = next t m.
Proof.
by rewrite past_n; case: eqP => // /side_next_m; rewrite side_m.
Qed.
Lemma past_m_is : past m = next t n.
Proof.
rewrite (past_m keeps twin_n); case: eqP => // /side_next_n; by rewrite (negPf side_n).
Qed.

Lemma past_side x y : past x = Some y -> (y \in side) = (x \in side).
Proof.
case: (x =P n) => [->|xn]; last case: (x =P m) => [->|xm].
- by rewrite past_n_is => /side_next_m/negPf->; rewrite (negPf side_n).
- by rewrite past_m_is => /side_next_n->; rewrite side_m.
by rewrite /RemoveEdge.past (introF eqP xn) (introF eqP xm) => -[->].
Qed.

Lemma past_boundary x y : past x = Some y -> boundary_of t y = boundary_of t x.
Proof.
case: (x =P n) => [->|xn]; last case: (x =P m) => [->|xm].
- by rewrite past_n_is => /next_boundary ->; rewrite boundary_n.
- by rewrite past_m_is => /next_boundary ->; rewrite boundary_n.
by rewrite /RemoveEdge.past (introF eqP xn) (introF eqP xm) => -[->].
Qed.

(** The end on whose side a half-edge is. *)
Definition end_of i := if i \in side then m else n.

Lemma end_ofP i : end_of i = n \/ end_of i = m. Proof. by rewrite /end_of; case: ifP; auto. Qed.
Lemma end_side i j : (end_of i == end_of j) = ((i \in side) == (j \in side)).
Proof.
rewrite /end_of; case: (i \in side); case: (j \in side); rewrite ?eqxx //; apply/eqP => //; exact: nesym.
Qed.
Lemma end_end x : x = n \/ x = m -> end_of x = x.
Proof. by rewrite /end_of; case=> ->; rewrite ?side_m ?(negPf side_n). Qed.

Lemma boundary_side i : half_edge t' i -> boundary_of t i = Some kept -> boundary_of t' i = Some (at_end (end_of i)).
Proof.
move=> l B; rewrite boundary_ofE // B eqxx /end_of; case: ifP => _; by rewrite ?at_end_n ?at_end_m.
Qed.

Lemma at_end_inj x y : x = n \/ x = m -> y = n \/ y = m -> at_end x = at_end y -> x = y.
Proof. by case=> -> [] ->; rewrite ?at_end_n ?at_end_m // => E; case: at_differ. Qed.

(** ** Cycles *)

Lemma part_side i : half_edge t' i -> next t' i >>= boundary_of t' = boundary_of t' i.
Proof.
move=> l; have [li i_n im] := leftP l; have [x N _] := next_some li; have [y Y ly] := past_some l N.
rewrite (nextE out) // N /= Y /= !boundary_ofE // (past_boundary Y) (next_boundary N) (past_side Y).
by rewrite (side_step i_n im N).
Qed.

(** The rest of the cycle leads to the half-edge that comes past the end on its side. *)
Lemma reach i : half_edge t' i -> boundary_of t i = Some kept ->
  exists y, [/\ past (end_of i) = Some y, half_edge t' y & on_cycle t' i y].
Proof.
move=> l B; pose good u := [/\ half_edge t' u, boundary_of t u = Some kept, (u \in side) = (i \in side) & on_cycle t' i u].
pose done := exists y, [/\ past (end_of i) = Some y, half_edge t' y & on_cycle t' i y].
have : good (end_of i) \/ done; last first.
  by case=> // -[/leftP[_ xn xm]]; case: (end_ofP i) => E; [case: xn|case: xm].
have C : on_cycle t i (end_of i) by apply: (cycle_of keeps B); apply: boundary_end; apply: end_ofP.
apply: (orbit_ind (P := fun u => good u \/ done)) C; first by left; split=> //; apply: orbit_refl.
move=> u w [[lu Bu Su Cu] N|]; last by auto.
have [y Y ly] := past_some lu N; have Cy : on_cycle t' i y by apply: orbit_step Cu _; rewrite (nextE out) // N.
have [Lu u_n um_] := leftP lu; have Sw : (w \in side) = (i \in side) by rewrite (side_step u_n um_ N).
case: (w =P end_of i) => [wE|wE]; first by right; exists y; rewrite -wE.
have lw : half_edge t' w.
  have [w' + lw] := next_some Lu; rewrite N => -[ww]; rewrite -ww in lw.
  have ends x : x = n \/ x = m -> w <> x.
    by move=> xe wx; apply: wE; rewrite wx -(end_end xe) -wx; apply/eqP; rewrite end_side Sw.
  by apply: is_left => //; apply: ends; auto.
left; split=> //; first by rewrite (next_boundary N).
by move: Y; rewrite past_left // => -[->].
Qed.

Lemma part_cycle i j : half_edge t' i -> half_edge t' j -> boundary_of t' i = boundary_of t' j -> on_cycle t' i j.
Proof.
move=> l k; have [li _ _] := leftP l; have [lj _ _] := leftP k.
have [_ _ _ _ [b B lb]] := links_of li; have [_ _ _ _ [d D ld]] := links_of lj.
have apart e x : boundary t e -> e <> kept -> x = n \/ x = m -> e <> at_end x.
  by move=> le ek /at_is[] ->; [|apply: old_not_made].
case: (b =P kept) => [bk|bk]; case: (d =P kept) => [dk|dk].
- rewrite bk in B; rewrite dk in D; rewrite (boundary_side l B) (boundary_side k D) => -[E].
  have [y [Y ly Cy]] := reach l B; have [z [Z _ Cz]] := reach k D.
  have ij := at_end_inj (end_ofP i) (end_ofP j) E; move: Y; rewrite ij Z => -[zy]; rewrite -zy in Cy.
  exact: orbit_trans Cy (cycle_back k Cz).
- rewrite bk in B; rewrite (boundary_side l B) boundary_ofE // D; case: eqP => [[/dk]//|_] [E].
  by case: (apart d (end_of i) ld dk (end_ofP i)).
- rewrite dk in D; rewrite (boundary_side k D) boundary_ofE // B; case: eqP => [[/bk]//|_] [E].
  by case: (apart b (end_of j) lb bk (end_ofP j)).
rewrite !boundary_ofE // B D; case: eqP => [[/bk]//|_]; case: eqP => [[/dk]//|_] [E].
by apply: (cycle_away keeps out _ _ B); rewrite ?boundary_n ?boundary_m ?E // => -[/esym]; rewrite -?E.
Qed.

(** ** Ends *)

Lemma vertex_n : vertex_of n = un. Proof. by rewrite /vertex_of eqxx. Qed.
Lemma vertex_m : vertex_of m = um. Proof. by rewrite /vertex_of; case: eqP => // /esym/n_not_m. Qed.

Lemma live_end x : x = n \/ x = m -> vertex t (vertex_of x).
Proof.
move=> xe; have O := origin_end xe.
by have [[u + lu] _ _ _ _] := links_of (heard_live O); rewrite O => -[->].
Qed.

(** An end without another edge begins no half-edge of the other end. *)
Lemma end_alone : corner n = None -> un <> um.
Proof.
move=> no E; have [b B _] := next_some live_m.
have bn : b = n.
  have [//|bm] := corner_past no (etrans past_n_is B).
  by have := side_next_m B; rewrite bm side_m.
have [k] : on_orbit (turn t) n m by apply/(keeps V2 n m live_n live_m); rewrite origin_n origin_m E.
have stay q : iter q (obind (turn t)) (Some n) = Some n.
  by elim: q => //= q ->; rewrite /= /turn twin_n /= B bn.
by rewrite stay => -[/n_not_m].
Qed.

(** The boundary component of an end passes it. *)
Lemma passes_end x : x = n \/ x = m -> passes t' (at_end x) (vertex_of x).
Proof.
move=> xe; case K: (corner x) => [y|].
  have [ly Oy] := corner_some keeps twin_n out xe K; left; exists y; last by rewrite Oy; apply: origin_end.
  have Y : past x = Some y by move: K; rewrite /RemoveEdge.corner; case: ifP.
  have By : boundary_of t y = Some kept by rewrite (past_boundary Y); apply: boundary_end.
  rewrite (boundary_side ly By); congr (Some (at_end _)); rewrite -[RHS](end_end xe).
  by apply/eqP; rewrite end_side (past_side Y).
right; rewrite (isolatedE out (live_end xe)) /begins_at origin_n origin_m.
case: xe K => -> K; first by rewrite vertex_n eqxx K at_end_n.
rewrite vertex_m eqxx K at_end_m andbC; case L: (corner n) => [y|] //=.
by case: eqP => // -[/(end_alone L)].
Qed.

(** An end without another edge has no half-edges on its side. *)
Lemma end_empty x i : x = n \/ x = m -> corner x = None -> half_edge t' i -> boundary_of t i = Some kept -> end_of i <> x.
Proof.
move=> xe K l B E; have [y [Y ly _]] := reach l B; rewrite E in Y.
by have [_ yn ym] := leftP ly; have [/yn|/ym] := corner_past K Y.
Qed.

Lemma isolated_end u b : isolated t' u = Some b ->
  (exists x, [/\ x = n \/ x = m, corner x = None, u = vertex_of x & b = at_end x]) \/
  [/\ isolated t u = Some b, b <> kept & b <> made].
Proof.
case/(isolated_leftP keeps twin_n out)=> _ [[/eqP O K ->]|[/eqP O K ->]|[B I]].
- by left; exists n; rewrite at_end_n vertex_n; split; auto; move: O; rewrite origin_n => -[].
- by left; exists m; rewrite at_end_m vertex_m; split; auto; move: O; rewrite origin_m => -[].
right; have [_ _ no] := core_isolated c I; split=> // [bk|]; first by apply: (no n); rewrite bk.
by have [b' + lb] := core_bare c (heard_live I) B; rewrite I => -[->]; apply: old_not_made.
Qed.

(** ** Passing and connecting without the edge *)

Lemma passes_up b u : passes t b u -> b <> kept -> passes t' b u.
Proof.
case=> [[i B O] bk|I _]; last by right; apply: (isolated_still keeps twin_n out).
have l : half_edge t' i.
  by apply: is_left; [apply: heard_live B|move=> E; apply: bk..]; move: B; rewrite E ?boundary_n ?boundary_m => -[].
by left; exists i; rewrite ?originE // boundary_ofE // B; case: eqP => // -[/bk].
Qed.

Lemma passes_kept u : passes t kept u -> exists2 x, x = n \/ x = m & passes t' (at_end x) u.
Proof.
case=> [[i B O]|I]; last by have [_ _ /(_ n)] := core_isolated c I; rewrite boundary_n.
case: (i =P n) => [E|i_n].
  exists n; first by left. move: O; rewrite E origin_n => -[<-]; rewrite -vertex_n; apply: passes_end; by left.
case: (i =P m) => [E|im].
  exists m; first by right. move: O; rewrite E origin_m => -[<-]; rewrite -vertex_m; apply: passes_end; by right.
have l : half_edge t' i by apply: is_left => //; apply: heard_live B.
by exists (end_of i); [apply: end_ofP|left; exists i; rewrite ?originE // boundary_side].
Qed.

Lemma connected_ends u w : connected t u w -> connected t' u w \/
  exists x y, [/\ x = n \/ x = m, y = n \/ y = m, connected t' u (vertex_of x) & connected t' (vertex_of y) w].
Proof.
case/(connected_cut keeps twin_n out origin_n origin_m)=> [|[C D]|[C D]]; [by left|right; exists n, m|right; exists m, n];
  by rewrite vertex_n vertex_m; split; auto.
Qed.

Lemma end_connected x u : x = n \/ x = m -> passes t kept u -> connected t u (vertex_of x).
Proof.
by move=> xe P; apply: (passes_connected keeps live_kept P); left; exists x; [apply: boundary_end|apply: origin_end].
Qed.

Lemma passes_kept_end x : x = n \/ x = m -> passes t kept (vertex_of x).
Proof. by move=> xe; left; exists x; [apply: boundary_end|apply: origin_end]. Qed.

(** ** The outside of the component *)

(** If the cycle was an outer one, the outside [bo] is passed by the part that stays the outer one. *)
Variables (bo wo s : nat).
Hypothesis s_end : s = n \/ s = m.
Hypothesis s_stays : at_end s = stays.
Hypothesis outside_bo : ~~ inn kept -> [/\ inn bo, passes t bo wo & connected t' (vertex_of s) wo].

Lemma bo_not_kept : ~~ inn kept -> bo <> kept.
Proof. by move=> no; have [I _ _] := outside_bo no; move=> E; move: no; rewrite -E I. Qed.

Lemma live_passes b u : passes t b u -> boundary t b.
Proof.
case=> [[i B _]|I]; first by have [_ _ _ _ [d + ld]] := links_of (heard_live B); rewrite B => -[->].
have [B _ _] := core_isolated c I; have [d + ld] := core_bare c (heard_live I) B; by rewrite I => -[->].
Qed.

Lemma not_made b u : passes t b u -> b <> made. Proof. by move/live_passes/old_not_made. Qed.

Lemma inn_end x : x = n \/ x = m -> inn' (at_end x) = inn kept || (x != s).
Proof.
move=> xe; rewrite inn_at // -s_stays; congr (_ || ~~ _); apply/eqP/eqP => [|-> //]; exact: at_end_inj.
Qed.

Lemma end_inner x : x = n \/ x = m -> exists b w, [/\ boundary t' b, inn' b, passes t' b w & connected t' (vertex_of x) w].
Proof.
move=> xe; case: (boolP (inn kept || (x != s))) => [I|]; first exists (at_end x), (vertex_of x).
  by split; [apply: live_at|rewrite inn_end|apply: passes_end|apply: connected_self].
rewrite negb_or negbK => /andP[no /eqP->]; have [I P C] := outside_bo no; have bk := bo_not_kept no.
exists bo, wo; split=> //; [exact/boundary_up/(live_passes P)|rewrite inn_other //; exact: not_made P|exact: passes_up].
Qed.

Lemma part_inside v : vertex t' v -> exists b w, [/\ boundary t' b, inn' b, passes t' b w & connected t' v w].
Proof.
rewrite (vertexE out) => /(core_inside c)[b [w [lb I P C]]].
have [D|[x [y [xe ye D _]]]] := connected_ends C; last first.
  by have [d [z [ld Id Pd Cd]]] := end_inner xe; exists d, z; split=> //; apply: connected_trans D Cd.
case: (b =P kept) => [bk|bk].
  rewrite bk in P I; have [x xe P'] := passes_kept P; exists (at_end x), w.
  by split=> //; [apply: live_at|rewrite inn_end // I].
by exists b, w; split=> //; [apply: boundary_up|rewrite inn_other // ; apply: not_made P|apply: passes_up].
Qed.

Lemma face_end_down b x : boundary_face t' b = Some x -> b = kept \/ b = made -> x = f.
Proof. by move=> F /an_end[y ye E]; move: F; rewrite -E (face_at ye) => -[]. Qed.

Lemma no_outer_iff x : no_outer t' inn' x <-> no_outer t inn x.
Proof.
split=> no b F; last first.
  case: (whichP (heard_live F)) => [y ye E|lb bk bm].
    rewrite E inn_end // no ?face_kept //; move: F; rewrite E (face_at ye) => -[->] //.
  by rewrite inn_other //; apply: no; apply: face_down.
have bm := old_not_made (heard_live F); case: (b =P kept) => [bk|bk].
  have := no (at_end s); rewrite (face_at s_end) inn_end // eqxx orbF bk; apply.
  by rewrite -F bk face_kept.
by rewrite -(inn_other bk bm); apply: no; apply: faceE.
Qed.

(** Out of the face of an outer cycle that was parted. *)
Lemma steps_f d w y : ~~ inn kept -> inn d -> passes t d w -> connected t (vertex_of s) w -> boundary_face t d = Some y ->
  steps_out t' inn' y -> d = bo /\ steps_out t' inn' f.
Proof.
move=> no I P C G S; have [Io Po Co] := outside_bo no; have db : d = bo.
  have Co' := connected_down keeps twin_n out Co.
  apply: (one_inner keeps I Io P Po) (live_passes P) (live_passes Po).
  exact: connected_trans (connected_sym map C) Co'.
split=> //; rewrite db in G; have bk := bo_not_kept no.
apply: (@out_through t' inn' f (at_end s) (vertex_of s) bo wo y) => //.
- exact: face_at.
- by rewrite inn_end // eqxx orbF.
- exact: passes_end.
- by rewrite inn_other //; apply: not_made Po.
- exact: passes_up.
exact: faceE.
Qed.

Lemma part_steps x : steps_out t inn x -> steps_out t' inn' x.
Proof.
elim=> {x} [x lx no|x b v d w y F I P J Q C G _ IH]; first by apply: out_here => //; apply/no_outer_iff.
have bm := not_made P; have dm := not_made Q; have sym := connected_back out_l1.
have kept_face : b = kept -> x = f by move=> bk; move: F; rewrite bk face_kept => -[].
(* Through an end that is on an inner part, into the face of the cycle. *)
have by_end z : b <> kept -> (z = n \/ z = m) -> inn' (at_end z) -> connected t' v (vertex_of z) -> steps_out t' inn' f ->
    steps_out t' inn' x.
  move=> bk ze Iz Cz S; apply: (@out_through t' inn' x b v (at_end z) (vertex_of z) f) => //.
  - exact: faceE.
  - by rewrite inn_other.
  - exact: passes_up.
  - exact: passes_end.
  exact: face_at.
have by_way e z : b <> kept -> e <> kept -> e <> made -> inn e -> passes t e z -> connected t' v z -> boundary_face t e = Some y ->
    steps_out t' inn' x.
  move=> bk ek em Ie Pe Ce Fe; apply: (@out_through t' inn' x b v e z y) => //; try exact: passes_up; try exact: faceE.
    by rewrite inn_other.
  by rewrite inn_other.
case: (boolP (inn kept)) => [Ik|no].
  have bk : b <> kept by move=> E; move: I; rewrite E Ik.
  case: (d =P kept) => [dk|dk].
    have yf : y = f by move: G; rewrite dk face_kept => -[].
    rewrite yf in IH; rewrite dk in Q; have [D|[z [z' [ze _ D _]]]] := connected_ends C.
      have [z ze Qz] := passes_kept Q; apply: (@out_through t' inn' x b v (at_end z) w f) => //.
      + exact: faceE.
      + by rewrite inn_other.
      + exact: passes_up.
      + by rewrite inn_end // Ik.
      exact: face_at.
    by apply: (by_end z) => //; rewrite inn_end // Ik.
  have [D|[z [z' [ze _ D _]]]] := connected_ends C; first exact: (by_way d w).
  case: dk; apply/esym; apply: (one_inner keeps Ik J (passes_kept_end ze) Q _ live_kept (live_passes Q)).
  exact: connected_trans (connected_sym map (connected_down keeps twin_n out D)) C.
have dk : d <> kept by move=> E; move: no; rewrite -E J.
have to_s z : (z = n \/ z = m) -> connected t v (vertex_of z) -> connected t (vertex_of s) w.
  move=> ze Cz; apply: connected_trans (end_connected s_end (passes_kept_end ze)) _ || idtac.
  have Cs := connected_sym map (end_connected s_end (passes_kept_end ze)).
  exact: connected_trans Cs (connected_trans (connected_sym map Cz) C).
case: (b =P kept) => [bk|bk].
  rewrite (kept_face bk); rewrite bk in P; have Cv := end_connected s_end P.
  by have [] := steps_f no J Q (connected_trans (connected_sym map Cv) C) G IH.
have [D|[z [z' [ze _ D _]]]] := connected_ends C; first exact: (by_way d w).
have [db S] := steps_f no J Q (to_s z ze (connected_down keeps twin_n out D)) G IH.
case: (z =P s) => [zs|zs].
  have [Io Po Co] := outside_bo no; rewrite db in G dk dm; rewrite zs in D.
  by apply: (by_way bo wo) => //; apply: connected_trans D Co.
by apply: (by_end z) => //; rewrite inn_end // (introF eqP zs) orbT.
Qed.

(** The other end than that of the part that stays. *)
Lemma part_counts : core_count t' inn'.
Proof.
have [vs [hs [fs [bs [Hv Hh Hf Hb eq]]]]] := core_counts c.
have [hs' Hh' sh] := half_edges_less keeps twin_n out Hh.
pose o := if s == n then m else n; have oe : o = n \/ o = m by rewrite /o; case: ifP; auto.
have os : o <> s by rewrite /o; case: eqP => [->|/nesym] //; apply: nesym.
have se x : x = n \/ x = m -> x = s \/ x = o.
  by rewrite /o; case: s_end => ->; rewrite ?eqxx; [|case: eqP => [/esym/n_not_m//|_]] => -[]; auto.
pose z := if inn kept then made else at_end o.
have zP b : boundary t' b /\ inn' b <-> b = z \/ boundary t b /\ inn b.
  rewrite /z; split=> [[lb I]|].
    case: (whichP lb) I => [x xe ->|l bk bm]; last by rewrite inn_other //; right.
    rewrite inn_end //; case: (boolP (inn kept)) => Ik /= I; last by left; case: (se x xe) => [E|->] //; rewrite E eqxx in I.
    by case: (at_is xe) => ->; [right|left].
  case=> [->|[lb I]].
    case Ik: (inn kept); last by rewrite live_at // inn_end // (introF eqP os) orbT.
    by rewrite boundaryE eqxx /parted_inn eqxx orbT Ik.
  split; first exact: boundary_up.
  case: (b =P kept) => [bk|bk]; first by rewrite bk in I *; rewrite /parted_inn eqxx I.
  by rewrite inn_other //; apply: old_not_made.
have z_new : ~ (boundary t z /\ inn z).
  rewrite /z; case Ik: (inn kept); first by case=> l; case: (old_not_made l).
  by case: (at_is oe) => -> [l I]; [rewrite Ik in I|case: (old_not_made l)].
exists vs, hs', fs, (z :: bs); split=> //.
  by apply: lists_iff (lists_cons z_new Hb) => b; apply: iff_sym.
by move: eq; rewrite sh /=; arith.
Qed.

Lemma part_core : core t' inn'.
Proof.
split.
- move=> i l; have [li _ _] := leftP l; have [[u U lu] [e E _] _ _ [b B lb]] := links_of li; split.
  + by exists u; rewrite ?originE.
  + by exists e; rewrite ?(twinE out) //; apply: (twin_left keeps twin_n out l E).
  + exact: (next_left keeps twin_n out l).
  case: (b =P kept) => [bk|bk].
    by rewrite bk in B; rewrite boundary_side //; exists (at_end (end_of i)) => //; apply/live_at/end_ofP.
  by exists b; rewrite ?boundary_up // boundary_ofE // B; case: eqP => // -[/bk].
- exact: out_l1.
- exact: (out_next keeps twin_n out).
- exact: (out_l3 keeps twin_n out).
- exact: (out_rotation keeps twin_n out).
- exact: part_side.
- exact: part_cycle.
- move=> u lu /(bare_left keeps twin_n out lu)[b /(isolated_left keeps twin_n out)[d I]]; exists d => //.
  case: (isolated_end I) => [[x [xe _ _ ->]]|[I' _ _]]; first exact: live_at.
  by apply/boundary_up/(@live_passes d u); right.
- move=> u b I; have [B _] := isolated_leftP keeps twin_n out I; split=> //.
    case: (isolated_end I) => [[x [xe K uE ->]]|[I' bk bm]]; last by rewrite inn_other //; have [] := core_isolated c I'.
    rewrite inn_end //; case: (boolP (inn kept)) => //= no; apply/eqP=> xs.
    have [Io Po Co] := outside_bo no; rewrite -xs -uE in Co.
    have alone w : connected t' u w -> w = u.
      elim=> // i y y' _ -> Oi _; by case: (B i (heard_live Oi)).
    rewrite (alone _ Co) in Po; case: (passes_up Po (bo_not_kept no)) => [[i _ Oi]|I2].
      by case: (B i (heard_live Oi)).
    case: (isolated_end I2) => [[y [ye _ _ E]]|[I3 _ _]].
      by case: (at_is ye) => F; [case: (bo_not_kept no)|case: (not_made Po)]; rewrite E.
    have [B' _ _] := core_isolated c I3; apply: (B' x); last by rewrite uE; apply: origin_end.
    exact: heard_live (origin_end xe).
  move=> i E; have l := heard_live E; have [li _ _] := leftP l; have [_ _ _ _ [d D ld]] := links_of li.
  case: (d =P kept) => [dk|dk].
    rewrite dk in D; move: E; rewrite (boundary_side l D) => -[E].
    case: (isolated_end I) => [[x [xe K _ bE]]|[_ bk bm]].
      by apply: (end_empty xe K l D); apply: (at_end_inj (end_ofP i) xe); rewrite E.
    by case: (at_is (end_ofP i)) => F; [apply: bk|apply: bm]; rewrite -E.
  move: E; rewrite boundary_ofE // D; case: eqP => [[/dk]//|_] [E].
  case: (isolated_end I) => [[x [xe _ _ bE]]|[I' _ _]]; last by have [_ _ /(_ i)] := core_isolated c I'; rewrite D E.
  by case: (at_is xe) => F; [apply: dk|apply: (old_not_made ld)]; rewrite E bE.
- move=> u w b /isolated_end[[x [xe _ -> bx]]|[I bk bm]] /isolated_end[[y [ye _ -> by_]]|[I' bk' bm']].
  + by rewrite (at_end_inj xe ye) // -bx.
  + by case: (at_is xe) => F; [case: bk'|case: bm']; rewrite bx.
  + by case: (at_is ye) => F; [case: bk|case: bm]; rewrite by_.
  exact: (core_one c I I').
- move=> b /whichP[x xe ->|lb bk bm]; first by exists (vertex_of x); apply: passes_end.
  by have [v P] := core_used c lb; exists v; apply: passes_up.
- move=> b /whichP[x xe ->|lb bk bm].
    by have [y + ly] := core_face c live_kept; rewrite face_kept => -[E]; exists f; [apply: face_at|rewrite E].
  by have [y Y ly] := core_face c lb; exists y => //; apply: faceE.
- move=> b d Ib Id F lb; have ld : boundary t' d.
    have [y Y] : exists y, boundary_face t' b = Some y.
      case: (whichP lb) => [x xe ->|l _ _]; first by exists f; apply: face_at.
      by have [y Y _] := core_face c l; exists y; apply: faceE.
    by move: F; rewrite Y => /esym Y'; apply: heard_live Y'.
  have stays_outer x : x = n \/ x = m -> ~~ inn' (at_end x) -> ~~ inn kept /\ at_end x = at_end s.
    by move=> xe; rewrite inn_end // negb_or negbK => /andP[-> /eqP->].
  have clash e x : x = n \/ x = m -> ~~ inn' (at_end x) -> boundary t e -> e <> kept -> e <> made -> ~~ inn' e ->
      boundary_face t' e <> Some f.
    move=> xe Ix le ek em; rewrite (inn_other ek em) => Ie Fe; have [Ik _] := stays_outer x xe Ix.
    by apply: (ek); apply: (core_outer c Ie Ik) => //; rewrite face_kept; apply: face_down.
  case: (whichP lb) F Ib => [x xe ->|l bk bm] F Ib; case: (whichP ld) F Id => [y ye ->|l' dk dm] F Id.
  + by have [_ ->] := stays_outer x xe Ib; have [_ ->] := stays_outer y ye Id.
  + by case: (clash d x xe Ib l' dk dm Id); rewrite -F; apply: face_at.
  + by case: (clash b y ye Id l bk bm Ib); rewrite F; apply: face_at.
  have [y Y _] := core_face c l; have [z Z _] := core_face c l'; move: F; rewrite (faceE Y) (faceE Z) => -[E].
  rewrite (inn_other bk bm) in Ib; rewrite (inn_other dk dm) in Id; by apply: (core_outer c Ib Id) => //; rewrite Y Z E.
- have [x [[lx no] one]] := core_unbounded c; exists x; split; first by split=> //; apply/no_outer_iff.
  by move=> y [ly /no_outer_iff no']; apply: one.
- exact: part_inside.
- by move=> x lx; apply/part_steps/(core_out c).
exact: part_counts.
Qed.

Lemma part_start b : boundary t' b ->
  (exists2 i, boundary_start t' b = Some (AtHalfEdge i) & boundary_of t' i = Some b) \/
  exists2 u, boundary_start t' b = Some (AtVertex u) & isolated t' u = Some b.
Proof.
move=> lb; case: (whichP lb) => [x xe bE|l bk bm].
  have -> : boundary_start t' b = start_left t n m x.
    rewrite /boundary_start /heard lb /= bE; case: xe => ->; rewrite ?at_end_n ?at_end_m ?eqxx //.
    by case: eqP => // /esym/at_differ.
  rewrite bE /start_left; case K: (corner x) => [y|]; [left|right].
    have [ly _] := corner_some keeps twin_n out xe K; exists y => //.
    have Y : past x = Some y by move: K; rewrite /RemoveEdge.corner; case: ifP.
    rewrite boundary_side //; last by rewrite (past_boundary Y); apply: boundary_end.
    by congr (Some (at_end _)); rewrite -[RHS](end_end xe); apply/eqP; rewrite end_side (past_side Y).
  exists (vertex_of x); first by rewrite (origin_end xe).
  case: (passes_end xe) => // -[i B O]; have lx := heard_live B; rewrite (originE lx) in O.
  by case: (corner_none keeps twin_n out xe K lx); rewrite O (origin_end xe).
have -> : boundary_start t' b = boundary_start t b.
  rewrite {1}/boundary_start /heard lb /= /boundary_start /heard l.
  have no x : x = n \/ x = m -> b == at_end x = false by move/at_is=> [] ->; apply/eqP.
  by rewrite -at_end_n -at_end_m !no; auto.
case: (rest_start r l) => [[i S B]|[u S I]]; [left|right]; last by exists u => //; apply: (isolated_still keeps twin_n out).
exists i => //; have l' : half_edge t' i.
  by apply: is_left; [apply: heard_live B|move=> E; apply: bk..]; move: B; rewrite E ?boundary_n ?boundary_m => -[].
by rewrite boundary_ofE // B; case: eqP => // -[/bk].
Qed.

Lemma part_rules : rules (relist t' inn').
Proof.
apply: relist_rules part_core _ _ part_start => [i l|v lv]; first exact: (out_prev keeps twin_n out).
exact: (out_leaving keeps twin_n out).
Qed.

End Part.

(** The condition for parting: both sides of the edge are [kept], of the face [f]; and if that is an outer one, [way] leads, without
    the edge, from the end that [stays] belongs to, to where the inner boundary component [bo] is. *)
Definition is_bridge t n m f kept made at_n at_m stays bo way :=
  [&& twin t n == Some m, boundary_of t n == Some kept, boundary_of t m == Some kept, ~~ boundary t made,
      (at_n == kept) && (at_m == made) || (at_n == made) && (at_m == kept),
      (stays == at_n) || (stays == at_m), boundary_face t kept == Some f
    & inn_of t kept || [&& inn_of t bo, isSome (vertex_at t bo)
      & obind (fun u => way_ends t n m u way) (origin t (if stays == at_n then n else m)) == vertex_at t bo]].

(** A way that is there without the edge connects. *)
Lemma way_connects t t' n m at_n at_m u w way : rules t -> twin t n = Some m -> taken_out t t' n m at_n at_m ->
  way_ends t n m u way = Some w -> connected t' u w.
Proof.
move=> keeps T out; elim: way u => [|i way IH] u /=; first by case=> ->; apply: connected_self.
case: ifP => // /and3P[/eqP i_n /eqP im /eqP O]; case G: (target t i) => [x|] // /IH; apply: connected_trans.
exact: (connected_step keeps T out (is_left out (heard_live O) i_n im) O G).
Qed.

(** If all rules held before, they hold after. *)
Theorem part_component_keeps_rules t n m f kept made at_n at_m stays bo way :
  is_bridge t n m f kept made at_n at_m stays bo way ->
  rules t -> rules (part_component t n m f kept made at_n at_m stays).
Proof.
case/and5P=> /eqP T /eqP Bn /eqP Bm fm /and4P[parts st /eqP F ok] keeps.
have [[un Un _] _ _ _ _] := links_of keeps (heard_live T).
have [[um Um _] _ _ _ _] := links_of keeps (heard_live (twin_of keeps T)).
have parts' : at_n = kept /\ at_m = made \/ at_n = made /\ at_m = kept.
  by case/orP: parts => /andP[/eqP-> /eqP->]; auto.
pose s := if stays == at_n then n else m.
have se : s = n \/ s = m by rewrite /s; case: ifP; auto.
have ss : at_end n at_n at_m s = stays.
  rewrite /at_end /s; case: (stays =P at_n) => [->|ne]; first by rewrite eqxx.
  case: eqP => [E|_]; first by case: (n_not_m keeps T).
  by case/orP: st => /eqP.
pose wo := odflt 0 (vertex_at t bo).
suff outside : ~~ inn_of t kept -> [/\ inn_of t bo, passes t bo wo
    & connected (parted t n m f kept made at_n at_m) (vertex_of n un um s) wo].
  have st' : stays = at_n \/ stays = at_m by case/orP: st => /eqP; auto.
  exact: (part_rules keeps T Bn Bm fm parts' st' F Un Um se ss outside).
move=> no; move: ok; rewrite (negPf no) /= => /and3P[I V /eqP W]; have Vw : vertex_at t bo = Some wo.
  by rewrite /wo; case: (vertex_at t bo) V.
split=> //; first exact: (at_passes keeps Vw).
have O : origin t s = Some (vertex_of n un um s) := origin_end keeps T Un Um se.
by move: W; rewrite -/s O Vw /=; apply: (way_connects keeps T (parted_out t n m f kept made at_n at_m)).
Qed.
