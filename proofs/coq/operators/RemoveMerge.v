(** * RemoveMerge: removing an edge between two boundary components keeps all rules (`merge` in dcel/operators/remove.rs)

    The two sides of the edge are on two cycles, those of the boundary components [kept] and [dropped]. Without the edge these are
    one cycle, or one isolated vertex, which is that of [kept]. The two faces are one, [f]: the other one, [g], is gone, and what
    it listed is listed by [f].

<<
        ┌──────┬──────┐         ┌─────────────┐       both cycles are outer ones: so is what they become.
        │  f   │  g   │   ──►   │      f      │       one is an inner one, of the face f, which surrounds g:
        └──────┴──────┘         └─────────────┘       so is what they become.
>>

    That f and g are two faces is proved, and need not be asked. *)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import Arith View Rules Map Counting Lists NewEdge ConnectCorners Core Tidy Collapse RemoveEdge.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** The view [t] without the edge of [n] and [m], the boundary component [dropped] and the face [g]; places and lists are as
    they were. *)
Definition merged t n m f g kept dropped : view := let o := take_out t n m kept kept in {|
  vertex_slots := vertex_slots o;
  half_edge_slots := half_edge_slots o;
  boundary_slots := boundary_slots o;
  face_slots := face_slots o;
  is_vertex := is_vertex o;
  is_half_edge := is_half_edge o;
  is_boundary := fun c => (c != dropped) && is_boundary o c;
  is_face := fun x => (x != g) && is_face o x;
  says_origin := says_origin o;
  says_twin := says_twin o;
  says_next := says_next o;
  says_prev := says_prev o;
  says_boundary := fun i => if boundary_of t i == Some dropped then Some kept else says_boundary o i;
  says_leaving := says_leaving o;
  says_isolated := says_isolated o;
  says_boundary_face := fun c => if (c == kept) || (boundary_face t c == Some g) then Some f else says_boundary_face o c;
  says_boundary_start := fun c => if c == kept then start_left t n m n else says_boundary_start o c;
  says_boundary_place := says_boundary_place o;
  says_outer := says_outer o;
  says_inner_count := says_inner_count o;
  says_inner := says_inner o
|}.

(** The cycle that two become is an inner one if one of the two was. *)
Definition merged_inn t kept dropped c := if c == kept then inn_of t kept || inn_of t dropped else inn_of t c.

Definition merge_faces t n m f g kept dropped := relist (merged t n m f g kept dropped) (merged_inn t kept dropped).

Section Merge.
Variables (t : view) (n m f g kept dropped bn bm bf bg un um : nat).
Hypothesis keeps : rules t.
Hypothesis twin_n : twin t n = Some m.
Hypothesis boundary_n : boundary_of t n = Some bn.
Hypothesis boundary_m : boundary_of t m = Some bm.
Hypothesis sides : bn = kept /\ bm = dropped \/ bn = dropped /\ bm = kept.
Hypothesis differ : kept <> dropped.
Hypothesis faces : bf = kept /\ bg = dropped \/ bf = dropped /\ bg = kept.
Hypothesis face_f : boundary_face t bf = Some f.
Hypothesis face_g : boundary_face t bg = Some g.
Hypothesis outer_g : ~~ inn_of t bg.
Hypothesis origin_n : origin t n = Some un.
Hypothesis origin_m : origin t m = Some um.

Notation t' := (merged t n m f g kept dropped).
Notation inn := (inn_of t).
Notation inn' := (merged_inn t kept dropped).
Notation past := (past (next t) n m).
Notation corner := (corner t n m).
Let low : lower t. Proof. by move=> q _; apply: keeps. Qed.
Let map : is_map t := low_map low.
Let c : core t inn := core_of_rules keeps.
Let r : rest t inn := rest_of_rules keeps.
Let links_of := NewEdge.links_of keeps.
Let next_boundary := next_boundary keeps.

Lemma merged_out : taken_out t t' n m kept kept.
Proof. by case: (take_out_taken_out t n m kept kept). Qed.

Let out := merged_out.
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

(** The component [kept] and [dropped] become is [kept]. *)
Definition joint b := b = kept \/ b = dropped.
Definition now b := if b == dropped then kept else b.

Lemma joint_n : joint bn. Proof. by case: sides => -[-> _]; [left|right]. Qed.
Lemma joint_m : joint bm. Proof. by case: sides => -[_ ->]; [right|left]. Qed.
Lemma joint_f : joint bf. Proof. by case: faces => -[-> _]; [left|right]. Qed.
Lemma joint_g : joint bg. Proof. by case: faces => -[_ ->]; [right|left]. Qed.
Lemma joint_sides b : joint b -> b = bn \/ b = bm.
Proof. by case: sides => -[-> ->] []; auto. Qed.
Lemma joint_faces b : joint b -> b = bf \/ b = bg.
Proof. by case: faces => -[-> ->] []; auto. Qed.
Lemma now_joint b : joint b -> now b = kept.
Proof. by rewrite /now; case=> ->; case: eqP. Qed.
Lemma now_other b : ~ joint b -> now b = b.
Proof. by rewrite /now /joint; case: eqP => // -> []; right. Qed.
Lemma jointP b : joint b \/ ~ joint b.
Proof.
rewrite /joint; case: (b =P kept) => [->|bk]; first by left; left.
by case: (b =P dropped) => [->|bd]; [left; right|right; case].
Qed.
Lemma bn_not_bm : bn <> bm. Proof. by case: sides => -[-> ->] // /esym. Qed.
Lemma bf_not_bg : bf <> bg. Proof. by case: faces => -[-> ->] // /esym. Qed.

Lemma inn_joint : inn' kept = inn bf.
Proof.
by rewrite /merged_inn eqxx; case: faces outer_g => -[-> ->] /negPf->; rewrite ?orbF.
Qed.
Lemma inn_now b : inn b -> inn' (now b).
Proof.
move=> I; case: (jointP b) => J; last by rewrite now_other // /merged_inn; case: eqP => // bk; case: J; left.
rewrite now_joint // inn_joint; case: (joint_faces J) => E; first by rewrite -E.
by move: outer_g; rewrite -E I.
Qed.
Lemma inn_other b : ~ joint b -> inn' b = inn b.
Proof. by rewrite /merged_inn => J; case: eqP => // E; case: J; left. Qed.

(** ** What the view says *)

Lemma boundaryE b : boundary t' b = (b != dropped) && boundary t b. Proof. by rewrite {1}/boundary /= andbCA. Qed.
Lemma faceE x : face t' x = (x != g) && face t x. Proof. by rewrite {1}/face /= andbCA. Qed.

Lemma boundary_ofE i : half_edge t' i -> boundary_of t' i = omap now (boundary_of t i).
Proof.
move=> l; have [li _ _] := leftP l; rewrite {1}/boundary_of /heard l /=; case: eqP => [->|no].
  by rewrite /= /now eqxx.
have -> : says_boundary t i = boundary_of t i by rewrite /boundary_of /heard li.
by case B: (boundary_of t i) no => [b|] //= no; rewrite /now; case: eqP => // E; case: no; rewrite E.
Qed.

Lemma live_joint b : joint b -> boundary t b.
Proof. by move/joint_faces=> [->|->]; [apply: heard_live face_f|apply: heard_live face_g]. Qed.

Lemma boundary_now b : boundary t b -> boundary t' (now b).
Proof.
rewrite boundaryE => lb; case: (jointP b) => J.
  by rewrite now_joint // (live_joint (or_introl erefl)) andbT; apply/eqP.
by rewrite now_other // lb andbT; apply/eqP=> E; case: J; right.
Qed.

(** The rest is [kept], or neither of the two. *)
Lemma boundary_left b : boundary t' b -> b = kept \/ [/\ ~ joint b, boundary t b & now b = b].
Proof.
rewrite boundaryE => /andP[/eqP bd lb]; case: (jointP b) => J; first by left; case: J.
by right; split=> //; apply: now_other.
Qed.

(** ** The two faces are two, as no component lies in a face that it bounds *)

Lemma passes_joint b : joint b -> exists2 u, passes t b u & connected t un u.
Proof.
case/joint_sides=> ->; first by exists un; [left; exists n|apply: connected_self].
exists um; first by left; exists m.
by apply: (connected_edge (connected_self t un) origin_n); rewrite /target twin_n.
Qed.

Lemma joint_connected b v : joint b -> passes t b v -> connected t un v.
Proof.
move=> J P; have [u Q C] := passes_joint J.
exact: connected_trans C (passes_connected keeps (live_joint J) Q P).
Qed.

Lemma not_both_g : ~ (inn bf = false /\ f = g).
Proof.
by case=> I fg; apply: bf_not_bg; apply: (core_outer c); rewrite ?I // ?face_f ?face_g ?fg //; apply: live_joint joint_f.
Qed.

Lemma faces_differ : f <> g.
Proof.
have lg : face t g by have [x + lx] := core_face c (live_joint joint_g); rewrite face_g => -[->].
move=> fg; have If : inn bf by case I: (inn bf) => //; case: not_both_g.
suff H x : steps_out t inn x -> x <> g by case: (H g (core_out c lg)).
elim=> {x} [x _ no|x b v d w y F I P J Q C G _ IH] xg.
  by have := no bg; rewrite xg face_g (negPf outer_g) => /(_ erefl).
rewrite xg in F; have E : b = bg.
  by apply: (core_outer c) => //; rewrite ?F ?face_g //; apply: heard_live F.
rewrite E in P; have [u Pf Cu] := passes_joint joint_f; apply: IH.
have bd : bf = d.
  apply: (one_inner keeps If J Pf Q) (live_joint joint_f) (heard_live G).
  apply: connected_trans (connected_sym map Cu) (connected_trans (joint_connected joint_g P) C).
by move: G; rewrite -bd face_f fg => -[].
Qed.

Definition face_now x := if x == g then f else x.

Lemma live_f : face t f. Proof. by have [x + lx] := core_face c (live_joint joint_f); rewrite face_f => -[->]. Qed.

Lemma boundary_face_now b x : boundary_face t b = Some x -> boundary_face t' (now b) = Some (face_now x).
Proof.
move=> F; have lb := heard_live F; rewrite {1}/boundary_face /heard (boundary_now lb) /= /face_now.
case: (jointP b) => J.
  rewrite now_joint // eqxx /=; case: (joint_faces J) => E; move: F; rewrite E ?face_f ?face_g => -[<-].
    by case: eqP.
  by rewrite eqxx.
have bk : (b == kept) = false by apply/eqP=> E; case: J; left.
rewrite now_other // bk F /=; have -> : (Some x == Some g) = (x == g) by [].
by case: eqP => // _; move: F; rewrite /boundary_face /heard lb.
Qed.

(** ** Cycles *)

Lemma past_boundary x y : past x = Some y -> omap now (boundary_of t y) = omap now (boundary_of t x).
Proof.
have Bn : omap now (boundary_of t n) = Some kept by rewrite boundary_n /= now_joint //; apply: joint_n.
have Bm : omap now (boundary_of t m) = Some kept by rewrite boundary_m /= now_joint //; apply: joint_m.
case: (x =P n) => [->|xn]; last case: (x =P m) => [->|xm].
- by rewrite past_n; case: ifP => _ /next_boundary->; rewrite ?Bn ?Bm.
- by rewrite (past_m keeps twin_n); case: ifP => _ /next_boundary->; rewrite ?Bn ?Bm.
by rewrite /RemoveEdge.past (introF eqP xn) (introF eqP xm) => -[->].
Qed.

Lemma merge_side i : half_edge t' i -> next t' i >>= boundary_of t' = boundary_of t' i.
Proof.
move=> l; have [li _ _] := leftP l; have [x N _] := next_some li; have [y Y ly] := past_some l N.
by rewrite (nextE out) // N /= Y /= !boundary_ofE // (past_boundary Y) (next_boundary N).
Qed.

(** The rest of the cycle of an end leads to the half-edge that comes past it. *)
Lemma reach x i : x = n \/ x = m -> half_edge t' i -> boundary_of t i = boundary_of t x ->
  exists y, [/\ past x = Some y, half_edge t' y & on_cycle t' i y].
Proof.
move=> xe l B; have [li _ _] := leftP l.
pose good u := [/\ half_edge t' u, boundary_of t u = boundary_of t x & on_cycle t' i u].
have [b Bx] : exists b, boundary_of t x = Some b by case: xe => ->; [exists bn|exists bm].
have : good x \/ exists y, [/\ past x = Some y, half_edge t' y & on_cycle t' i y]; last first.
  by case=> // -[/leftP[_ xn xm]]; case: xe => E; [case: xn|case: xm].
have C : on_cycle t i x by apply: (cycle_of keeps (c := b)); rewrite ?B.
apply: (orbit_ind (P := fun u => good u \/ exists y, [/\ past x = Some y, half_edge t' y & on_cycle t' i y])) C.
  by left; split=> //; apply: orbit_refl.
move=> u w [[lu Bu Cu] N|]; last by auto.
have [y Y ly] := past_some lu N; have Cy : on_cycle t' i y by apply: orbit_step Cu _; rewrite (nextE out) // N.
case: (w =P x) => [wx|wx]; first by right; exists y; rewrite -wx.
have Bw : boundary_of t w = boundary_of t x by rewrite (next_boundary N).
have other : half_edge t' w.
  have [Lu _ _] := leftP lu; have [w' + lw] := next_some Lu; rewrite N => -[ww]; rewrite -ww in lw.
  apply: is_left => // E; move: wx Bw; rewrite E; case: xe => ->; rewrite ?boundary_n ?boundary_m // => _ [].
    by move/bn_not_bm.
  by move/esym/bn_not_bm.
by left; split=> //; move: Y; rewrite past_left // => -[->].
Qed.

Let cycle_back := cycle_back keeps twin_n out.

Lemma merge_cycle i j : half_edge t' i -> half_edge t' j -> boundary_of t' i = boundary_of t' j -> on_cycle t' i j.
Proof.
move=> l k; have [li _ _] := leftP l; have [lj _ _] := leftP k; rewrite !boundary_ofE //.
have [_ _ _ _ [b B _]] := links_of li; have [_ _ _ _ [d D _]] := links_of lj; rewrite B D /= => -[E].
case: (jointP b) => J; last first.
  have bd : b = d.
    move: E; rewrite now_other //; case: (jointP d) => [/now_joint-> bk|/now_other->] //.
    by case: J; rewrite bk; left.
  have no x e : boundary_of t x = Some e -> joint e -> boundary_of t x <> Some b.
    by move=> -> Je [eb]; apply: J; rewrite -eb.
  by apply: (cycle_away keeps out (no n _ boundary_n joint_n) (no m _ boundary_m joint_m) B); rewrite bd.
have Jd : joint d.
  move: E; rewrite (now_joint J); case: (jointP d) => // Jd; rewrite now_other // => dk.
  by case: Jd; left.
(* All of both cycles leads to one half-edge. *)
suff [z to_z] : exists z, forall u e, half_edge t' u -> boundary_of t u = Some e -> joint e -> on_cycle t' u z.
  by apply: orbit_trans (to_z i b l B J) (cycle_back k (to_z j d k D Jd)).
have [a A _] := next_some live_n; have [e Em _] := next_some live_m; have bm_bn := nesym bn_not_bm.
case: (e =P m) => [em|em].
  exists a => u x lu Bu /joint_sides[] xE.
    have [|y [Y _ C]] := reach (or_introl erefl) lu; first by rewrite Bu boundary_n xE.
    by move: Y C; rewrite past_n Em em eqxx A => -[->].
  have [k'] : on_cycle t m u by apply: (cycle_of keeps boundary_m); rewrite Bu xE.
  have stay : forall k', iter k' (obind (next t)) (Some m) = Some m by elim=> //= q ->; rewrite /= Em em.
  by rewrite stay => -[mu]; have [_ _] := leftP lu; rewrite mu.
have [y past_n_is] : exists y, past n = Some y by exists e; rewrite past_n Em; case: eqP => // -[].
have ye : y = e by move: past_n_is; rewrite past_n Em; case: eqP => [[]|_ []].
have Be : boundary_of t e = Some bm by rewrite (next_boundary Em).
have le : half_edge t' e.
  apply: is_left => //; first by have [x + lx] := next_some live_m; rewrite Em => -[->].
  by move=> en; move: Be; rewrite en boundary_n => -[/bn_not_bm].
have [|z [Z _ Cz]] := reach (or_intror erefl) le; first by rewrite Be boundary_m.
exists z => u x lu Bu /joint_sides[] xE.
  have [|y' [Y' _ C]] := reach (or_introl erefl) lu; first by rewrite Bu boundary_n xE.
  by move: Y'; rewrite past_n_is ye => -[ey]; rewrite -ey in C; apply: orbit_trans C Cz.
have [|z' [Z' _ C]] := reach (or_intror erefl) lu; first by rewrite Bu boundary_m xE.
by move: Z'; rewrite Z => -[->].
Qed.

(** ** Ends *)

(** An end without another edge is that of a loop with nothing else. *)
Lemma corner_loop x : x = n \/ x = m -> corner x = None -> next t n = Some n /\ next t m = Some m.
Proof.
have [a A _] := next_some live_n; have [b B _] := next_some live_m.
have Ba : boundary_of t a = Some bn by rewrite (next_boundary A).
have Bb : boundary_of t b = Some bm by rewrite (next_boundary B).
have am : a <> m by move=> E; move: Ba; rewrite E boundary_m => -[/esym/bn_not_bm].
have bn_ : b <> n by move=> E; move: Bb; rewrite E boundary_n => -[/bn_not_bm].
move=> xe no; have only z := corner_past (z := z) no; rewrite A B.
case: xe only {no} => ->; rewrite ?past_n ?(past_m keeps twin_n) A B; case: eqP => [[E]|E] only.
- by case: (only a) => // aE; rewrite aE E.
- by case: (only b) => // bE; case: E; rewrite bE.
- by case: (only b) => // bE; rewrite bE E.
by case: (only a) => // aE; case: E; rewrite aE.
Qed.

Lemma loop_ends : next t n = Some n -> un = um.
Proof. by move=> N; have := keeps L3 n live_n; rewrite N twin_n /= origin_n origin_m => -[]. Qed.

Lemma live_un : vertex t un.
Proof. by have [[u + l] _ _ _ _] := links_of live_n; rewrite origin_n => -[->]. Qed.

Lemma isolated_un : corner n = None -> isolated t' un = Some kept.
Proof. by move=> K; rewrite (isolatedE out live_un) /begins_at origin_n eqxx K. Qed.

(** An end that becomes isolated is [kept], which has no half-edge then and is an inner one. *)
Lemma isolated_end u b : isolated t' u = Some b -> isolated t u = Some b /\ ~ joint b \/
  [/\ u = un, b = kept, corner n = None & next t n = Some n /\ next t m = Some m].
Proof.
case/(isolated_leftP keeps twin_n out)=> _ [[/eqP O K ->]|[/eqP O K ->]|[B I]].
- by right; split=> //; [move: O; rewrite origin_n => -[]|apply: corner_loop K; left].
- have L : next t n = Some n /\ next t m = Some m by apply: corner_loop K; right.
  right; split=> //; first by rewrite loop_ends; [move: O; rewrite origin_m => -[]|case: L].
  by case: L => N M; rewrite /RemoveEdge.corner past_n M eqxx N eqxx.
left; split=> // J; have [_ _ no] := core_isolated c I.
by case: (joint_sides J) => E; [apply: (no n)|apply: (no m)]; rewrite ?boundary_n ?boundary_m E.
Qed.

Lemma loop_empty i : next t n = Some n -> next t m = Some m -> half_edge t' i -> boundary_of t' i <> Some kept.
Proof.
move=> N M l; have [li i_n im] := leftP l; rewrite boundary_ofE //; have [_ _ _ _ [b B _]] := links_of li.
rewrite B /= => -[E]; have J : joint b by case: (jointP b) => // /[dup] no /now_other nb; case: no; left; rewrite -nb.
have stay x : next t x = Some x -> on_cycle t x i -> i = x.
  by move=> X C; apply: (orbit_ind (P := fun u => u = x)) C => // u w -> ; rewrite X => -[].
case: (joint_sides J) => bE; first by apply: i_n; apply: (stay n N); apply: (cycle_of keeps boundary_n); rewrite B bE.
by apply: im; apply: (stay m M); apply: (cycle_of keeps boundary_m); rewrite B bE.
Qed.

(** The outside of a loop with nothing else is one of its two sides. *)
Lemma loop_inner : next t n = Some n -> next t m = Some m -> inn bf.
Proof.
move=> N M; have [b [w [lb I P C]]] := core_inside c live_un.
have around i : origin t i = Some un -> i = n \/ i = m.
  move=> O; have : on_orbit (turn t) n i by apply/(keeps V2 n i live_n (heard_live O)); rewrite O origin_n.
  apply: (orbit_ind (P := fun u => u = n \/ u = m)); first by left.
  by move=> u x [] ->; rewrite /turn ?twin_n ?twin_m /= ?N ?M => -[<-]; auto.
have at_un : w = un.
  elim: C => // i x y _ -> X; have [] := around i X => ->; rewrite /target ?twin_n ?twin_m /= ?origin_n ?origin_m => -[] //.
  by rewrite loop_ends.
have J : joint b.
  rewrite at_un in P; case: P => [[i B O]|Iu].
    by have [] := around i O => iE; move: B; rewrite iE ?boundary_n ?boundary_m => -[<-]; [apply: joint_n|apply: joint_m].
  by have [/(_ n live_n)] := core_isolated c Iu; rewrite origin_n.
by case: (joint_faces J) => E; [rewrite -E|move: outer_g; rewrite -E I].
Qed.

(** ** What is connected, and what boundary components pass *)

Lemma ends_connected : connected t' um un.
Proof.
have [a A la] := next_some live_n; have Oa : origin t a = Some um by rewrite (origin_next keeps A) /target twin_n.
have Ba : boundary_of t a = Some bn by rewrite (next_boundary A).
have C : on_cycle t a n by apply: (cycle_of keeps Ba).
suff [o O] : exists2 o, origin t n = Some o & connected t' um o by move: O; rewrite origin_n => -[->].
suff [] : (exists2 o, origin t n = Some o & connected t' um o) /\ boundary_of t n = Some bn by [].
apply: (orbit_ind (P := fun u => (exists2 o, origin t u = Some o & connected t' um o) /\ boundary_of t u = Some bn)) C.
  by split=> //; exists um => //; apply: connected_self.
move=> u w [[o O Co] Bu] N; split; last by rewrite (next_boundary N).
case: (u =P n) => [un_|un_].
  by move: N; rewrite un_ A => -[<-]; exists um => //; apply: connected_self.
have lu : half_edge t' u.
  by apply: is_left => //; [apply: heard_live N|move=> E; move: Bu; rewrite E boundary_m => -[/esym/bn_not_bm]].
have Ow := origin_next keeps N; have [x X _] : exists2 x, origin t w = Some x & vertex t x.
  by have [_ _ [w' + lw] _ _] := links_of (heard_live N); rewrite N => -[->]; have [] := links_of lw.
exists x => //; apply: connected_trans Co _; apply: (connected_step keeps twin_n out lu O).
by rewrite -Ow.
Qed.

Lemma connected_up u w : connected t u w -> connected t' u w.
Proof.
have back := connected_back out_l1 ends_connected.
case/(connected_cut keeps twin_n out origin_n origin_m)=> [//|[C D]|[C D]].
  exact: connected_trans C (connected_trans back D).
exact: connected_trans C (connected_trans ends_connected D).
Qed.

Lemma passes_up b u : passes t b u -> passes t' (now b) u.
Proof.
case=> [[i B O]|I]; last first.
  rewrite now_other; first by right; apply: (isolated_still keeps twin_n out).
  move=> J; have [_ _ no] := core_isolated c I.
  by case: (joint_sides J) => E; [apply: (no n)|apply: (no m)]; rewrite ?boundary_n ?boundary_m E.
have end_ x : x = n \/ x = m -> boundary_of t x = Some b -> origin t x = Some u -> passes t' (now b) u.
  move=> xe Bx Ox; have J : joint b.
    by case: xe Bx => ->; rewrite ?boundary_n ?boundary_m => -[<-]; [apply: joint_n|apply: joint_m].
  rewrite now_joint //; case K: (corner x) => [y|].
    have [ly Oy] := corner_some keeps twin_n out xe K; left; exists y; last by rewrite Oy.
    have Y : past x = Some y by move: K; rewrite /RemoveEdge.corner; case: ifP.
    by rewrite boundary_ofE // (past_boundary Y) Bx /= now_joint.
  have [N M] := corner_loop xe K; right.
  have -> : u = un by move: Ox; case: xe => ->; rewrite ?origin_n ?origin_m -?loop_ends // => -[].
  by apply: isolated_un; rewrite /RemoveEdge.corner past_n M eqxx N eqxx.
case: (i =P n) => [E|i_n]; first by apply: (end_ n); [left|rewrite -E|rewrite -E].
case: (i =P m) => [E|im]; first by apply: (end_ m); [right|rewrite -E|rewrite -E].
have l : half_edge t' i by apply: is_left => //; apply: heard_live B.
by left; exists i; rewrite ?boundary_ofE ?B ?originE.
Qed.

(** ** Faces *)

Lemma outer_in_g b : boundary_face t b = Some g -> ~~ inn b -> b = bg.
Proof. by move=> F I; apply: (core_outer c) => //; [rewrite F face_g|apply: heard_live F]. Qed.

Lemma face_left b x : boundary_face t' b = Some x ->
  b = kept /\ x = f \/ [/\ ~ joint b, inn' b = inn b & exists2 y, boundary_face t b = Some y & x = face_now y].
Proof.
move=> F; case: (boundary_left (heard_live F)) => [bk|[J lb nb]]; [left|right].
  split=> //; have := boundary_face_now face_f; rewrite (now_joint joint_f); move: F; rewrite bk => -> [->].
  by rewrite /face_now; case: eqP.
split=> //; first exact: inn_other.
have [y Y _] := core_face c lb; exists y => //.
by have := boundary_face_now Y; rewrite nb F => -[].
Qed.

Lemma no_outer_up x : no_outer t inn x -> no_outer t' inn' x.
Proof.
move=> no b /face_left[[-> xf]|[J Ib [y Y xy]]]; first by rewrite inn_joint; apply: no; rewrite face_f xf.
rewrite Ib; case: (y =P g) => [yg|yg].
  apply/negPn/negP=> I; case: J; rewrite (outer_in_g _ I) -?yg //; exact: joint_g.
by apply: no; rewrite Y xy /face_now (introF eqP yg).
Qed.

Lemma no_outer_down x : x <> g -> no_outer t' inn' x -> no_outer t inn x.
Proof.
move=> xg no b F; case: (jointP b) => J.
  case: (joint_faces J) => E; last by move: F; rewrite E face_g => -[/esym].
  have := no (now b); rewrite (boundary_face_now F) now_joint // /face_now (introF eqP xg) inn_joint -E.
  by apply.
have := no (now b); rewrite (boundary_face_now F) /face_now (introF eqP xg) now_other // inn_other //.
by apply.
Qed.

Lemma merge_steps x : steps_out t inn x -> steps_out t' inn' (face_now x).
Proof.
elim=> {x} [x lx no|x b v d w y F I P J Q C G _ IH].
  have xg : x <> g by move=> xg; have := no bg; rewrite xg face_g (negPf outer_g) => /(_ erefl).
  rewrite /face_now (introF eqP xg); apply: out_here; last exact: no_outer_up.
  by rewrite faceE lx andbT; apply/eqP.
have through : ~~ inn' (now b) -> steps_out t' inn' (face_now x).
  move=> I'; apply: (@out_through t' inn' (face_now x) (now b) v (now d) w (face_now y)) => //.
  - exact: boundary_face_now.
  - exact: passes_up.
  - exact: inn_now.
  - exact: passes_up.
  - exact: connected_up.
  exact: boundary_face_now.
case: (jointP b) => Jb; last by apply: through; rewrite now_other // inn_other.
rewrite now_joint // inn_joint in through; case If: (inn bf) through => through; last exact: through.
have E : b = bg by case: (joint_faces Jb) => // E; move: I; rewrite E If.
have xg : x = g by move: F; rewrite E face_g => -[].
have [u Pf Cu] := passes_joint joint_f.
have bd : bf = d.
  apply: (one_inner keeps If J Pf Q) (live_joint joint_f) (heard_live G).
  exact: connected_trans (connected_sym map Cu) (connected_trans (joint_connected Jb P) C).
move: IH; have -> : y = f by move: G; rewrite -bd face_f => -[].
by rewrite xg /face_now eqxx; case: eqP => [/faces_differ|].
Qed.

Lemma merge_counts : core_count t' inn'.
Proof.
have [vs [hs [fs [bs [Hv Hh Hf Hb eq]]]]] := core_counts c.
have [hs' Hh' sh] := half_edges_less keeps twin_n out Hh.
have lg : face t g by have [x + lx] := core_face c (live_joint joint_g); rewrite face_g => -[->].
have [ub inb] := Hb; have inj : {in bs &, injective now}.
  have joint_inner b : b \in bs -> joint b -> b = bf.
    by move=> /inb[_ I] /joint_faces[//|E]; move: outer_g; rewrite -E I.
  move=> b d bb dd; case: (jointP b) => J; case: (jointP d) => K.
  - by rewrite (joint_inner b bb J) (joint_inner d dd K).
  - by rewrite (now_joint J) (now_other K) => E; case: K; left.
  - by rewrite (now_joint K) (now_other J) => E; case: J; left.
  by rewrite !now_other.
exists vs, hs', (rem g fs), [seq now b | b <- bs]; split=> //.
- apply: lists_iff (lists_rem g Hf) => x; rewrite faceE.
  by split=> [[/eqP->]|/andP[/eqP]].
- split=> [|b]; first by rewrite map_inj_in_uniq.
  split=> [/mapP[d /inb[ld I] ->]|[lb I]]; first by rewrite inn_now // boundary_now.
  case: (boundary_left lb) => [bk|[J l nb]].
    apply/mapP; exists bf; last by rewrite now_joint //; apply: joint_f.
    by apply/inb; split; [apply: live_joint joint_f|move: I; rewrite bk inn_joint].
  by apply/mapP; exists b => //; apply/inb; rewrite -(inn_other J).
by move: eq; rewrite sh (@size_map nat nat) (size_lists_rem Hf lg); arith.
Qed.

Lemma merge_core : core t' inn'.
Proof.
split.
- move=> i l; have [li _ _] := leftP l; have [[u U lu] [e E _] _ _ [b B lb]] := links_of li; split.
  + by exists u; rewrite ?originE ?(vertexE out).
  + by exists e; rewrite ?(twinE out) //; apply: (twin_left keeps twin_n out l E).
  + exact: (next_left keeps twin_n out l).
  by exists (now b); rewrite ?boundary_ofE ?B ?boundary_now.
- exact: out_l1.
- exact: (out_next keeps twin_n out).
- exact: (out_l3 keeps twin_n out).
- exact: (out_rotation keeps twin_n out).
- exact: merge_side.
- exact: merge_cycle.
- move=> u; rewrite (vertexE out) => lu /(bare_left keeps twin_n out lu)[b /(isolated_left keeps twin_n out)[d I]].
  exists d => //; case: (isolated_end I) => [[I' J]|[_ -> _ _]].
    have [B _ _] := core_isolated c I'; have [b' + lb'] := core_bare c (heard_live I') B; rewrite I' => -[E].
    by have := boundary_now lb'; rewrite -E now_other.
  by have := boundary_now (live_joint joint_f); rewrite (now_joint joint_f).
- move=> u b I; have [B _] := isolated_leftP keeps twin_n out I; split=> //.
    case: (isolated_end I) => [[I' J]|[_ -> _ [N M]]]; last by rewrite inn_joint; apply: loop_inner.
    by rewrite inn_other //; have [] := core_isolated c I'.
  move=> i E; have l := heard_live E; case: (isolated_end I) E => [[I' J]|[_ -> _ [N M]]]; last exact: loop_empty.
  have [li _ _] := leftP l; have [_ _ no] := core_isolated c I'; rewrite boundary_ofE //.
  have [_ _ _ _ [d D _]] := links_of li; rewrite D /= => -[E]; apply: (no i); rewrite D -E; congr Some.
  by case: (jointP d) => [/now_joint dk|/now_other //]; case: J; left; rewrite -E.
- move=> u w b /isolated_end[[I J]|[-> bk _ _]] /isolated_end[[I' J']|[-> bk' _ _]] //; first exact: (core_one c I I').
    by case: J; left.
  by case: J'; left.
- move=> b /boundary_left[->|[J lb nb]]; last by have [v P] := core_used c lb; exists v; rewrite -nb; apply: passes_up.
  have [u P _] := passes_joint joint_f; exists u; have := passes_up P; by rewrite (now_joint joint_f).
- move=> b lb; have lf : face t' f by rewrite faceE live_f andbT; apply/eqP/faces_differ.
  have up d x : boundary_face t d = Some x -> face t x -> leads_to (face t') (boundary_face t' (now d)).
    move=> F lx; exists (face_now x); first exact: boundary_face_now.
    by rewrite /face_now; case: (x =P g) => // xg; rewrite faceE lx andbT; apply/eqP.
  case: (boundary_left lb) => [->|[J l nb]]; first by have := up _ _ face_f live_f; rewrite (now_joint joint_f).
  by have [x X lx] := core_face c l; rewrite -nb; apply: up X lx.
- move=> b d Ib Id F lb; have [x X _] : exists2 x, boundary_face t' b = Some x & True.
    case: (boundary_left lb) => [->|[_ l <-]].
      by exists (face_now f) => //; have := boundary_face_now face_f; rewrite (now_joint joint_f).
    by have [y Y _] := core_face c l; exists (face_now y) => //; apply: boundary_face_now.
  have no e y : ~ joint e -> boundary_face t e = Some y -> ~~ inn e -> y <> g.
    by move=> J Y I yg; case: J; rewrite (outer_in_g _ I) -?yg //; apply: joint_g.
  have clash e y : ~ joint e -> boundary_face t e = Some y -> ~~ inn e -> face_now y = f -> ~~ inn' kept -> False.
    move=> J Y I; have yg := no e y J Y I; rewrite /face_now (introF eqP yg) inn_joint => yf If; case: J.
    have -> : e = bf by apply: (core_outer c) => //; [rewrite Y yf face_f|apply: heard_live Y].
    exact: joint_f.
  have X' : boundary_face t' d = Some x by rewrite -F.
  case: (face_left X) => [[bk xf]|[J Jb [y Y xy]]]; case: (face_left X') => [[dk xf']|[K Kd [z Z xz]]].
  + by rewrite bk dk.
  + by rewrite bk in Ib; rewrite Kd in Id; case: (clash d z K Z Id) => //; rewrite -xz.
  + by rewrite dk in Id; rewrite Jb in Ib; case: (clash b y J Y Ib) => //; rewrite -xy.
  rewrite Jb in Ib; rewrite Kd in Id; apply: (core_outer c) => //; last exact: heard_live Y.
  have yg := no b y J Y Ib; have zg := no d z K Z Id; move: xz.
  by rewrite xy /face_now (introF eqP yg) (introF eqP zg) Y Z => ->.
- have [x [[lx no] one]] := core_unbounded c; have xg : x <> g.
    by move=> xg; have := no bg; rewrite xg face_g (negPf outer_g) => /(_ erefl).
  exists x; split; first by split; [rewrite faceE lx andbT; apply/eqP|apply: no_outer_up].
  by move=> y [+ no']; rewrite faceE => /andP[/eqP yg ly]; apply: one; split=> //; apply: no_outer_down no'.
- move=> v; rewrite (vertexE out) => /(core_inside c)[b [w [lb I P C]]]; exists (now b), w.
  by split; [apply: boundary_now|apply: inn_now|apply: passes_up|apply: connected_up].
- move=> x; rewrite faceE => /andP[/eqP xg lx]; have := merge_steps (core_out c lx).
  by rewrite /face_now (introF eqP xg).
exact: merge_counts.
Qed.

Lemma merge_start b : boundary t' b ->
  (exists2 i, boundary_start t' b = Some (AtHalfEdge i) & boundary_of t' i = Some b) \/
  exists2 u, boundary_start t' b = Some (AtVertex u) & isolated t' u = Some b.
Proof.
move=> lb; case: (boundary_left lb) => [bk|[J l nb]].
  have -> : boundary_start t' b = start_left t n m n by rewrite /boundary_start /heard lb /= bk eqxx.
  rewrite bk /start_left; case K: (corner n) => [y|]; [left|right].
    have [ly _] := corner_some keeps twin_n out (or_introl erefl) K; exists y => //.
    have Y : past n = Some y by move: K; rewrite /RemoveEdge.corner; case: ifP.
    by rewrite boundary_ofE // (past_boundary Y) boundary_n /= now_joint //; apply: joint_n.
  by exists un; [rewrite origin_n|apply: isolated_un].
have -> : boundary_start t' b = boundary_start t b.
  rewrite {1}/boundary_start /heard lb /= /boundary_start /heard l.
  by case: eqP => // bk; case: J; left.
case: (rest_start r l) => [[i S B]|[u S I]]; [left|right].
  exists i => //; have l' : half_edge t' i.
    apply: is_left; first exact: heard_live B.
      by move=> E; apply: J; move: B; rewrite E boundary_n => -[<-]; apply: joint_n.
    by move=> E; apply: J; move: B; rewrite E boundary_m => -[<-]; apply: joint_m.
  by rewrite boundary_ofE // B /= nb.
by exists u => //; apply: (isolated_still keeps twin_n out).
Qed.

Lemma merge_rules : rules (relist t' inn').
Proof.
apply: relist_rules merge_core _ _ merge_start => [i l|v lv]; first exact: (out_prev keeps twin_n out).
exact: (out_leaving keeps twin_n out).
Qed.

End Merge.

(** The condition for merging: the two sides of the edge are [kept] and [dropped], and one of these is the outer boundary component
    of [g], the other one is listed by [f]. *)
Definition is_seam t n m f g kept dropped :=
  [&& twin t n == Some m,
      (boundary_of t n == Some kept) && (boundary_of t m == Some dropped)
      || (boundary_of t n == Some dropped) && (boundary_of t m == Some kept), kept != dropped
    & [&& boundary_face t kept == Some f, boundary_face t dropped == Some g & ~~ inn_of t dropped]
      || [&& boundary_face t dropped == Some f, boundary_face t kept == Some g & ~~ inn_of t kept]].

(** If all rules held before, they hold after. *)
Theorem merge_faces_keeps_rules t n m f g kept dropped : is_seam t n m f g kept dropped ->
  rules t -> rules (merge_faces t n m f g kept dropped).
Proof.
case/and4P=> /eqP T sides /eqP kd faces keeps.
have [[un Un _] _ _ _ _] := links_of keeps (heard_live T).
have [[um Um _] _ _ _ _] := links_of keeps (heard_live (twin_of keeps T)).
by case/orP: sides => /andP[/eqP Bn /eqP Bm]; case/orP: faces => /and3P[/eqP Ff /eqP Fg og];
  apply: (merge_rules keeps T Bn Bm _ kd _ Ff Fg og Un Um); auto.
Qed.
