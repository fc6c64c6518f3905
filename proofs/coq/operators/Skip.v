(** * Skip: an edge is contracted, and left out of its cycles and rotations

    What comes after what was before [n] is what came after [n]; so it is with [m]. Then the half-edges of both ends of the edge are
    around one vertex. What becomes of vertices, boundary components and faces is the matter of Contract.v. *)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import View Rules Map Lists NewEdge ConnectCorners Core RemoveEdge.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** The first from [x] on, along [step], that is neither [n] nor [m]. *)
Definition skip (step : nat -> link) n m x : link :=
  if x == n then (if step n == Some m then step m else step n) else
  if x == m then (if step m == Some n then step n else step m) else Some x.

(** Nothing but the edge is in its component. *)
Definition alone t n m := (next t n == Some m) && (next t m == Some n).

(** The start of a boundary component that started at [s]. *)
Definition skip_start t n m (s : option start) : option start :=
  if s is Some (AtHalfEdge i) then omap AtHalfEdge (skip (next t) n m i) else s.

(** The view [t] without the edge of [n] and [m] and without the vertex [dropped]. *)
Definition contract_edge t n m kept dropped : view := {|
  vertex_slots := vertex_slots t;
  half_edge_slots := half_edge_slots t;
  boundary_slots := boundary_slots t;
  face_slots := face_slots t;
  is_vertex := fun u => (u != dropped) && is_vertex t u;
  is_half_edge := fun i => [&& i != n, i != m & is_half_edge t i];
  is_boundary := is_boundary t;
  is_face := is_face t;
  says_origin := fun i => if origin t i == Some dropped then Some kept else says_origin t i;
  says_twin := says_twin t;
  says_next := fun i => next t i >>= skip (next t) n m;
  says_prev := fun i => prev t i >>= skip (prev t) n m;
  says_boundary := says_boundary t;
  says_leaving := fun u => if u == kept then (if alone t n m then None else skip (next t) n m m) else says_leaving t u;
  says_isolated := fun u => if (u == kept) && alone t n m then boundary_of t n else says_isolated t u;
  says_boundary_face := says_boundary_face t;
  says_boundary_start := fun b => if alone t n m && (boundary_of t n == Some b) then Some (AtVertex kept) else
    skip_start t n m (says_boundary_start t b);
  says_boundary_place := says_boundary_place t;
  says_outer := says_outer t;
  says_inner_count := says_inner_count t;
  says_inner := says_inner t
|}.

Section Skipping.
Variables (t : view) (n m kept dropped un um bn : nat).
Hypothesis keeps : rules t.
Hypothesis twin_n : twin t n = Some m.
Hypothesis origin_n : origin t n = Some un.
Hypothesis origin_m : origin t m = Some um.
Hypothesis ends : un = kept /\ um = dropped \/ un = dropped /\ um = kept.
Hypothesis differ : kept <> dropped.
Hypothesis boundary_n : boundary_of t n = Some bn.

Notation t' := (contract_edge t n m kept dropped).
Notation inn := (inn_of t).
Notation skip := (skip (next t) n m).
Notation alone := (alone t n m).
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
Let twin_m : twin t m = Some n := twin_of twin_n.
Let live_n : half_edge t n := heard_live twin_n.
Let live_m : half_edge t m := heard_live twin_m.
Let n_not_m : n <> m := n_not_m keeps twin_n.

(** [x] and [y] are the two half-edges of the edge. *)
Definition pair x y := x = n /\ y = m \/ x = m /\ y = n.

Lemma pair_sym x y : pair x y -> pair y x. Proof. by case=> -[-> ->]; [right|left]. Qed.
Lemma pair_twin x y : pair x y -> twin t x = Some y. Proof. by case=> -[-> ->]. Qed.
Lemma pair_differ x y : pair x y -> x <> y. Proof. by case=> -[-> ->] // /esym. Qed.
Lemma pair_live x y : pair x y -> half_edge t x. Proof. by case=> -[->]. Qed.

(** A half-edge is one of the two, or is another one. *)
Variant half_edge_is x : Prop := End y of pair x y | OtherHalfEdge of x <> n & x <> m.
Lemma half_edgeP x : half_edge_is x.
Proof.
case: (x =P n) => [->|xn]; first by apply: (End (y := m)); left.
by case: (x =P m) => [->|xm]; [apply: (End (y := n)); right|apply: OtherHalfEdge].
Qed.

Lemma skipE x y : pair x y -> skip x = if next t x == Some y then next t y else next t x.
Proof.
rewrite /Skip.skip; case=> -[-> ->]; first by rewrite eqxx.
by rewrite (introF eqP (nesym n_not_m)) eqxx.
Qed.

Lemma skip_other x : x <> n -> x <> m -> skip x = Some x.
Proof. by rewrite /Skip.skip => /eqP/negPf-> /eqP/negPf->. Qed.

(** ** What the view says *)

Lemma vertexE u : vertex t' u = (u != dropped) && vertex t u. Proof. by rewrite /vertex /= andbCA. Qed.
Lemma half_edgeE i : half_edge t' i = [&& i != n, i != m & half_edge t i].
Proof. by rewrite /half_edge /=; case: (i != n); case: (i != m); rewrite /= ?andbF. Qed.

Lemma leftP i : half_edge t' i -> [/\ half_edge t i, i <> n & i <> m].
Proof. by rewrite half_edgeE => /and3P[/eqP i_n /eqP im li]. Qed.
Lemma is_left i : half_edge t i -> i <> n -> i <> m -> half_edge t' i.
Proof. by move=> li /eqP i_n /eqP im; rewrite half_edgeE i_n im. Qed.
Lemma not_end x y : half_edge t' x -> ~ pair x y. Proof. by case/leftP=> _ xn xm [] []. Qed.

(** The vertex that a vertex becomes. *)
Definition col u := if u == dropped then kept else u.

Lemma originE i : half_edge t' i -> origin t' i = omap col (origin t i).
Proof.
move=> l; have [li _ _] := leftP l; have [[u U _] _ _ _ _] := links_of li; have S := U.
rewrite /origin /heard li in S; rewrite {1}/origin /heard l /= S U /col /=.
by have -> : (Some u == Some dropped) = (u == dropped) by []; case: (u =P dropped).
Qed.

Lemma twinE i : half_edge t' i -> twin t' i = twin t i.
Proof. by move=> l; have [li _ _] := leftP l; rewrite /twin /heard l li. Qed.
Lemma nextE i : half_edge t' i -> next t' i = next t i >>= skip. Proof. by move=> l; rewrite {1}/next /heard l. Qed.
Lemma boundary_ofE i : half_edge t' i -> boundary_of t' i = boundary_of t i.
Proof. by move=> l; have [li _ _] := leftP l; rewrite /boundary_of /heard l li. Qed.

Lemma is_end u : u = un \/ u = um <-> u = kept \/ u = dropped.
Proof. by case: ends => -[-> ->]; split=> -[]; auto. Qed.
Lemma col_end u : u = un \/ u = um -> col u = kept.
Proof. by rewrite is_end /col => -[->|->]; case: eqP. Qed.
Lemma col_other u : u <> un -> u <> um -> col u = u.
Proof.
by rewrite /col; case: eqP => // -> nu mu; have [] := (is_end dropped).2 (or_intror erefl).
Qed.
Lemma col_kept u : col u = kept -> u = un \/ u = um.
Proof. by rewrite is_end /col; case: eqP => [->|_ ->]; auto. Qed.
Lemma ends_differ : un <> um. Proof. by case: ends => -[-> ->] // /esym. Qed.

Lemma origin_end x y : pair x y -> exists u w, [/\ origin t x = Some u, origin t y = Some w, u <> w &
  (u = un /\ w = um) \/ (u = um /\ w = un)].
Proof.
case=> -[-> ->]; [exists un, um|exists um, un]; split; auto; first exact: ends_differ.
exact: nesym ends_differ.
Qed.

Lemma live_kept : vertex t kept.
Proof.
have [[u + lu] _ _ _ _] := links_of live_n; have [[w + lw] _ _ _ _] := links_of live_m.
by rewrite origin_n origin_m => -[E] [F]; case: ends => -[uE wE]; [rewrite -uE F|rewrite -wE E].
Qed.

(** ** Half-edges *)

Lemma twin_left i g : half_edge t' i -> twin t i = Some g -> half_edge t' g.
Proof.
move=> /leftP[li i_n im] T; apply: is_left => [|E|E]; first exact: heard_live (twin_of T).
  by apply: im; apply: one_twin T _; rewrite E.
by apply: i_n; apply: one_twin T _; rewrite E.
Qed.

(** Past the edge is another half-edge, where one comes from another. *)
Lemma skip_some i x : half_edge t' i -> next t i = Some x -> exists2 y, skip x = Some y & half_edge t' y.
Proof.
move=> l N; have [li i_n im] := leftP l; case: (half_edgeP x) => [y xy|xn xm]; last first.
  exists x; rewrite ?skip_other //; apply: is_left => //.
  by have [z + lz] := next_some li; rewrite N => -[->].
have no z : next t z <> Some x \/ z = i.
  by case E: (next t z == Some x); move/eqP: E; [right; apply: one_next E N|left].
have [a A la] := next_some (pair_live xy); have [b B lb] := next_some (pair_live (pair_sym xy)).
have left z w : half_edge t z -> z <> x -> z <> y -> half_edge t' z.
  by case: xy => -[-> ->] ? ? ?; apply: is_left.
have [xi yi] : x <> i /\ y <> i by case: xy => -[-> ->]; split; apply: nesym.
rewrite (skipE xy) A B; case: eqP => [[ay]|ay].
  exists b => //; apply: left => // E; first by case: (no y) => [[]|//]; rewrite B E.
  by apply: (pair_differ xy); apply: one_next A _; rewrite B E ay.
exists a => //; apply: left => // E; last by apply: ay; rewrite E.
by case: (no x) => [[]|//]; rewrite A E.
Qed.

Lemma next_left i : half_edge t' i -> exists2 y, next t' i = Some y & half_edge t' y.
Proof. by move=> l; have [li _ _] := leftP l; have [x N _] := next_some li; rewrite nextE // N; apply: skip_some N. Qed.

Lemma prev_next i y : half_edge t' i -> next t' i = Some y -> prev t' y = Some i.
Proof.
move=> l; have [li i_n im] := leftP l; have [x N lx] := next_some li; have P := prev_of N; rewrite nextE // N /=.
have [y' Y ly] := skip_some l N; rewrite Y => -[yy]; rewrite -yy {yy}.
have -> : prev t' y' = prev t y' >>= Skip.skip (prev t) n m by rewrite {1}/prev /heard ly.
case: (half_edgeP x) Y => [z xz|xn xm]; last first.
  rewrite skip_other // => -[<-]; rewrite P /=.
  by rewrite /Skip.skip (introF eqP i_n) (introF eqP im).
have back w v : pair w v -> Skip.skip (prev t) n m w = if prev t w == Some v then prev t v else prev t w.
  by rewrite /Skip.skip; case=> -[-> ->]; rewrite ?eqxx // (introF eqP (nesym n_not_m)).
have iz : i <> z by case: xz => -[_ ->].
rewrite (skipE xz); case: eqP => [A|A] /prev_of -> /=.
  by rewrite (back z x (pair_sym xz)) (prev_of A) eqxx P.
by rewrite (back x z xz) P; case: eqP => // -[/iz].
Qed.

Lemma contract_next i j : half_edge t' i -> half_edge t' j -> next t' i = next t' j -> i = j.
Proof.
move=> li lj; have [y Y _] := next_left li; rewrite Y => /esym/(prev_next lj).
by rewrite (prev_next li Y) => -[].
Qed.

Lemma contract_l1 : l1_twin t'.
Proof.
move=> i l; have [li _ _] := leftP l; rewrite twinE //; have [_ [g G lg] _ _ _] := links_of li.
by have [T no] := keeps L1 i li; split=> //; move: T; rewrite G /= twinE //; apply: twin_left G.
Qed.

Lemma end_col x y u : pair x y -> origin t x = Some u -> col u = kept.
Proof. by case=> -[-> _] O; apply: col_end; move: O; rewrite ?origin_n ?origin_m => -[->]; auto. Qed.

Lemma skip_origin x y : skip x = Some y -> omap col (origin t y) = omap col (origin t x).
Proof.
case: (half_edgeP x) => [z xz|xn xm]; last by rewrite skip_other // => -[->].
have [u [w [U W _ _]]] := origin_end xz; have uk := end_col xz U; have wk := end_col (pair_sym xz) W.
have T : target t x = Some w /\ target t z = Some u.
  by rewrite /target (pair_twin xz) (pair_twin (pair_sym xz)).
by case: T => Tx Tz; rewrite (skipE xz); case: eqP => _ /origin_next ->; rewrite ?Tx ?Tz U /= uk ?wk.
Qed.

Lemma contract_l3 : l3_target t'.
Proof.
move=> i l; have [li _ _] := leftP l; have [x N _] := next_some li; have [y Y ly] := skip_some l N.
have [_ [g G _] _ _ _] := links_of li; have lg := twin_left l G.
by rewrite twinE // G nextE // N /= Y /= !originE // (skip_origin Y) (origin_next N) /target G.
Qed.

(** ** V2: the rotations of the two ends become one *)

Lemma origin_turn i x : turn t i = Some x -> origin t x = origin t i.
Proof. by move=> T; apply: (on_rotation_origin (keeps L1) (keeps L3)); exists 1. Qed.

Lemma turn_end x y : pair x y -> turn t x = next t y. Proof. by move/pair_twin=> T; rewrite /turn T. Qed.

Lemma turn_live i x : turn t i = Some x -> half_edge t x.
Proof.
rewrite /turn; case G: (twin t i) => [g|] //= N.
by have [z Z lz] := next_some (heard_live N); move: Z lz; rewrite N => -[->].
Qed.

Lemma turnE i x : half_edge t' i -> turn t i = Some x -> exists2 s, skip x = Some s & half_edge t' s /\ turn t' i = Some s.
Proof.
move=> l; rewrite /turn twinE //; case G: (twin t i) => [g|] //= N; have lg := twin_left l G.
by have [s S ls] := skip_some lg N; exists s; rewrite // nextE // N.
Qed.

(** Both ends begin at different vertices. *)
Lemma same_end x y z w : pair x y -> pair z w -> origin t x = origin t z -> x = z.
Proof.
by case=> -[-> _] [] [-> _] //; rewrite origin_n origin_m => -[E]; case: ends_differ.
Qed.

(** Around its vertex, a half-edge that is left leads to the end of the edge there, and past it. *)
Lemma reach_end z x y : half_edge t' z -> pair x y -> origin t z = origin t x ->
  exists2 s, skip x = Some s & on_orbit (turn t') z s.
Proof.
move=> lz xy O; have [Lz _ _] := leftP lz; have lx := pair_live xy; pose past := exists2 s, skip x = Some s & on_orbit (turn t') z s.
have : [/\ half_edge t' x, origin t x = origin t x & on_orbit (turn t') z x] \/ past.
  apply: (orbit_ind (P := fun i => [/\ half_edge t' i, origin t i = origin t x & on_orbit (turn t') z i] \/ past))
    ((keeps V2 z x Lz lx).2 O); first by left; split=> //; apply: orbit_refl.
  move=> i j [[li Oi C] T|]; last by right.
  have Oj := origin_turn T; rewrite Oi in Oj; have [s S [ls T']] := turnE li T; have Cs := orbit_step C T'.
  case: (half_edgeP j) => [k jk|jn jm]; last first.
    by move: S; rewrite skip_other // => -[js]; rewrite -js in ls Cs; left.
  by right; exists s; rewrite -?(same_end jk xy Oj).
by case=> // -[lx' _ _]; case: (not_end lx' xy).
Qed.

Lemma other_left x y i : pair x y -> half_edge t i -> origin t i = origin t x -> i <> x -> half_edge t' i.
Proof.
by move=> xy li O ix; case: (half_edgeP i) => [j ij|i_n im]; [case: ix; apply: same_end ij xy O|apply: is_left].
Qed.

Lemma origin_side x y s : pair x y -> next t x = Some s -> origin t s = origin t y.
Proof. by move=> xy /origin_next->; rewrite /target (pair_twin xy). Qed.

(** Past an end is what comes after it around its vertex, if that is another half-edge. *)
Lemma past_end z x y s w : pair x y -> skip x = Some s -> on_orbit (turn t') z s -> turn t x = Some w -> w <> x ->
  half_edge t' w /\ on_orbit (turn t') z w.
Proof.
move=> xy S C T wx; have yx := pair_sym xy; have lw := turn_live T; have Ow := origin_turn T; rewrite (turn_end xy) in T.
have lw' := other_left xy lw Ow wx; split=> //; move: S; rewrite (skipE xy) T; case: eqP => [_ [->] //|ny N].
have Os := origin_side xy N; have [v V ls] := next_some (pair_live xy); move: V ls; rewrite N => -[<-] ls.
have ls' : half_edge t' s by apply: (other_left yx ls Os) => E; apply: ny; rewrite N E.
have [s' + C'] := reach_end ls' yx Os; rewrite (skipE yx) T; case: eqP => [[/wx]//|_ [ws]].
by apply: orbit_trans C _; rewrite ws.
Qed.

Lemma rotation_left z i : half_edge t' z -> on_orbit (turn t) z i -> half_edge t' i -> on_orbit (turn t') z i.
Proof.
move=> lz C li; suff [s] : exists2 s, skip i = Some s & on_orbit (turn t') z s.
  by have [_ i_n im] := leftP li; rewrite skip_other // => -[<-].
apply: (orbit_ind (P := fun i => exists2 s, skip i = Some s & on_orbit (turn t') z s)) C => [|{li}i w [s S C] T].
  by have [_ zn zm] := leftP lz; exists z; [apply: skip_other|apply: orbit_refl].
case: (half_edgeP i) => [y iy|i_n im].
  case: (w =P i) => [->|wi]; first by exists s.
  have [lw Cw] := past_end iy S C T wi; have [_ w_n wm] := leftP lw.
  by exists w; [apply: skip_other|].
have li : half_edge t i by move: T; rewrite /turn; case G: (twin t i) => [g|] // _; apply: heard_live G.
have [s' S' [_ T']] := turnE (is_left li i_n im) T; exists s' => //.
by move: S; rewrite skip_other // => -[is_]; rewrite -is_ in C; apply: orbit_step C T'.
Qed.

(** From one end's vertex to that of the other one. *)
Lemma rotation_across z i x y : pair x y -> half_edge t' z -> half_edge t' i -> origin t z = origin t x ->
  origin t i = origin t y -> on_orbit (turn t') z i.
Proof.
move=> xy lz li Oz Oi; have yx := pair_sym xy; have [Li _ _] := leftP li; have ly := pair_live yx.
have [s S C] := reach_end lz xy Oz; apply: orbit_trans C _; have [w W lw] := next_some (pair_live xy).
have wy : w <> y.
  move=> wy; have [k] : on_orbit (turn t) y i by apply/(keeps V2 y i ly Li); rewrite Oi.
  have stay q : iter q (obind (turn t)) (Some y) = Some y by elim: q => //= q ->; rewrite /= (turn_end yx) W wy.
  by rewrite stay => -[yi]; apply: (not_end li (y := x)); rewrite -yi.
move: S; rewrite (skipE xy) W; case: eqP => [[/wy]//|_ [ws]]; rewrite -ws.
have Ow := origin_side xy W; apply: rotation_left => //; first exact: (other_left yx lw Ow wy).
by apply/(keeps V2 w i lw Li); rewrite Ow.
Qed.

Lemma contract_rotation g i : half_edge t' g -> half_edge t' i -> origin t' g = origin t' i -> on_orbit (turn t') g i.
Proof.
move=> lg li; have [Lg _ _] := leftP lg; have [Li _ _] := leftP li; rewrite !originE //.
have [[u U _] _ _ _ _] := links_of Lg; have [[w W _] _ _ _ _] := links_of Li; rewrite U W /= => -[E].
have nm : pair n m by left; split.
case: (u =P w) => [uw|uw]; first by apply: rotation_left => //; apply/(keeps V2 g i Lg Li); rewrite U W uw.
have k : col u = kept.
  case: (u =P dropped) => [->|ud]; first by rewrite /col eqxx.
  case: (w =P dropped) => [wd|wd]; first by rewrite E wd /col eqxx.
  by case: uw; move: E; rewrite /col (introF eqP ud) (introF eqP wd).
have kw : col w = kept by rewrite -E.
case: (col_kept k) => uE; case: (col_kept kw) => wE; try by case: uw; rewrite uE wE.
  by apply: (rotation_across nm) => //; rewrite ?U ?W ?origin_n ?origin_m ?uE ?wE.
by apply: (rotation_across (pair_sym nm)) => //; rewrite ?U ?W ?origin_n ?origin_m ?uE ?wE.
Qed.

(** ** Cycles *)

Lemma skip_boundary x y : skip x = Some y -> boundary_of t y = boundary_of t x.
Proof.
case: (half_edgeP x) => [z xz|xn xm]; last by rewrite skip_other // => -[->].
by rewrite (skipE xz); case: eqP => [/next_boundary E /next_boundary->|_ /next_boundary].
Qed.

Lemma contract_side i : half_edge t' i -> next t' i >>= boundary_of t' = boundary_of t' i.
Proof.
move=> l; have [li _ _] := leftP l; have [x N _] := next_some li; have [y Y ly] := skip_some l N.
by rewrite nextE // N /= Y /= !boundary_ofE // (skip_boundary Y) (next_boundary N).
Qed.

(** The cycle of a half-edge that is left leads past the edge as it did before. *)
Lemma cycle_left z i : half_edge t' z -> on_cycle t z i -> exists s, [/\ skip i = Some s, half_edge t' s & on_cycle t' z s].
Proof.
move=> lz; apply: (orbit_ind (P := fun i => exists s, [/\ skip i = Some s, half_edge t' s & on_cycle t' z s])).
  by have [_ zn zm] := leftP lz; exists z; split=> //; [apply: skip_other|apply: orbit_refl].
move=> {}i w [s [S ls C]] N; case: (half_edgeP i) => [y iy|i_n im]; last first.
  have li := is_left (heard_live N) i_n im; have [s' S' ls'] := skip_some li N; exists s'; split=> //.
  move: S; rewrite skip_other // => -[is_]; rewrite -is_ in C.
  by apply: orbit_step C _; rewrite nextE // N.
exists s; split=> //; have [_ s_n sm] := leftP ls; have := S; rewrite (skipE iy) N; case: eqP => [[wy] M|_ [->]].
  rewrite wy (skipE (pair_sym iy)) M; case: eqP => [[E]|//].
  by case: (not_end ls (y := y)); rewrite E.
exact: skip_other.
Qed.

Lemma contract_cycle g i : half_edge t' g -> half_edge t' i -> boundary_of t' g = boundary_of t' i -> on_cycle t' g i.
Proof.
move=> lg li; have [Lg _ _] := leftP lg; have [Li i_n im] := leftP li; rewrite !boundary_ofE // => B.
have [s [+ _ C]] := cycle_left lg (core_cycle c Lg Li B); by rewrite skip_other // => -[->].
Qed.

End Skipping.
