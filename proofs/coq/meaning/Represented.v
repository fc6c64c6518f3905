(** * Represented: a view that represents a planar subdivision keeps R1 to T3 *)

From mathcomp Require Import all_ssreflect all_fingroup.
From twinedge Require Import Arith View Rules Loops LoopsProof Reference Map Counting Lists TopologyProof.
From twinedge Require Import Drawing Euler Numbered Genus Subdivision.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section Represented.
Variables (t : view) (s : subdivision).
Variables (nv : vertices s -> nat) (nd : darts s -> nat) (nf : faces s -> nat) (nw : darts s -> nat) (ni : vertices s -> nat).
Hypothesis rep : represented t nv nd nf nw ni.

Let Nv := vertices_numbered rep.
Let Nd := darts_numbered rep.
Let Nf := faces_numbered rep.

Lemma vertex_nv v : vertex t (nv v). Proof. by case: Nv => _ H; apply/H; exists v. Qed.
Lemma half_edge_nd x : half_edge t (nd x). Proof. by case: Nd => _ H; apply/H; exists x. Qed.
Lemma face_nf f : face t (nf f). Proof. by case: Nf => _ H; apply/H; exists f. Qed.
Lemma boundary_nw x : boundary t (nw x).
Proof. by apply/(boundaries_numbered rep); left; exists x. Qed.
Lemma boundary_ni v : alone v -> boundary t (ni v).
Proof. by move=> a; apply/(boundaries_numbered rep); right; exists v. Qed.

Lemma vertex_is_nv v : vertex t v -> exists u, nv u = v. Proof. by case: Nv => _ /[apply]. Qed.
Lemma half_edge_is_nd h : half_edge t h -> exists x, nd x = h. Proof. by case: Nd => _ /[apply]. Qed.
Lemma face_is_nf f : face t f -> exists g, nf g = f. Proof. by case: Nf => _ /[apply]. Qed.

Lemma origin_nd x : origin t (nd x) = Some (nv (tail x)). Proof. by case: (says_of_dart rep x). Qed.
Lemma twin_nd x : twin t (nd x) = Some (nd (other x)). Proof. by case: (says_of_dart rep x). Qed.
Lemma next_nd x : next t (nd x) = Some (nd (after x)). Proof. by case: (says_of_dart rep x). Qed.
Lemma prev_nd x : prev t (nd (after x)) = Some (nd x). Proof. by case: (says_of_dart rep x). Qed.
Lemma boundary_nd x : boundary_of t (nd x) = Some (nw x). Proof. by case: (says_of_dart rep x). Qed.

Lemma turn_nd x : turn t (nd x) = Some (nd (rotation s x)).
Proof. by rewrite /turn twin_nd /= next_nd /after /follow other_back. Qed.

Lemma tail_after (x : darts s) : tail (after x) = tail (other x).
Proof.
apply/esym/eqP; rewrite -rotation_tail /after /follow.
exact: (mem_porbit (rotation s) 1).
Qed.

Lemma after_onto (x : darts s) : exists y, after y = x.
Proof. by exists (other ((rotation s)^-1 x)%g); rewrite /after /follow other_back permKV. Qed.

Lemma nv_inj : injective nv. Proof. by case: Nv. Qed.
Lemma nd_inj : injective nd. Proof. by case: Nd. Qed.
Lemma nf_inj : injective nf. Proof. by case: Nf. Qed.

Lemma aloneP (v : vertices s) : reflect (forall x : darts s, tail x <> v) (alone v).
Proof. by apply: (iffP forallP) => H x; [apply/eqP|apply/eqP]. Qed.

Lemma bare_nv v : bare t (nv v) <-> alone v.
Proof.
split=> [H|/aloneP H h lh].
  by apply/aloneP=> x xv; apply: (H (nd x)); rewrite ?half_edge_nd // origin_nd xv.
by case: (half_edge_is_nd lh) => x <-; rewrite origin_nd => -[/nv_inj]; apply: H.
Qed.

(** A boundary component is a walk or an isolated vertex. *)
Variant side b : Prop :=
  | SideWalk x y of nw x = b & boundary_start t b = Some (AtHalfEdge (nd y)) & same_walk (rotation s) (@other s) x y
      & stands t b (nf (left x)) (outside x)
  | SideAlone v of ni v = b & alone v & boundary_start t b = Some (AtVertex (nv v))
      & stands t b (nf (lies_in (piece v))) true.

Lemma sideP b : boundary t b -> side b.
Proof.
move/(boundaries_numbered rep)=> [[x xb]|[v a vb]].
  by have [S [y E xy]] := says_of_walk rep x; rewrite xb in S E; apply: (SideWalk (x := x) (y := y)).
by have [S E] := says_of_isolated rep a; rewrite vb in S E; apply: (SideAlone (v := v)).
Qed.

(** ** R1 to F2 *)

Lemma rep_links : links_live t.
Proof.
split.
- move=> h /half_edge_is_nd[x <-]; have [y yx] := after_onto x.
  split; [exists (nv (tail x))|exists (nd (other x))|exists (nd (after x))|exists (nd y)|exists (nw x)];
    rewrite ?origin_nd ?twin_nd ?next_nd ?boundary_nd ?vertex_nv ?half_edge_nd ?boundary_nw //.
  by rewrite -yx prev_nd.
- move=> v /vertex_is_nv[u <-]; have := says_of_vertex rep u; case a: (alone u).
    case=> -> ->; split; first by right; split=> //; apply/bare_nv.
    by right; exists (ni u) => //; apply: boundary_ni.
  case=> -[x -> _] ->; split; last by left.
  by left; exists (nd x) => //; apply: half_edge_nd.
- move=> b /sideP[x y _ -> _ [-> _]|v _ _ -> [-> _]]; rewrite /= ?half_edge_nd ?vertex_nv; split=> //.
    by exists (nf (left x)) => //; apply: face_nf.
  by exists (nf (lies_in (piece v))) => //; apply: face_nf.
move=> f lf; split=> [|i /(lists_inner rep)[b [-> E _]]]; last by exists b => //; apply: heard_live E.
case E: (outer t f) => [b|]; [right|by left].
by exists b => //; have [E' _] := lists_outer rep E; apply: heard_live E'.
Qed.

Lemma rep_r1 : r1_live t.
Proof. by split; [exact: rep_links | apply: lists_short_if => f i _ /(lists_inner rep)]. Qed.

Lemma rep_l1 : l1_twin t.
Proof.
move=> h /half_edge_is_nd[x <-]; rewrite twin_nd /= twin_nd other_back; split=> // -[/nd_inj/eqP].
by rewrite (negPf (other_differs x)).
Qed.

Lemma rep_l2 : l2_next_prev t.
Proof.
move=> h /half_edge_is_nd[x <-]; rewrite next_nd /= prev_nd; split=> //.
by have [y <-] := after_onto x; rewrite prev_nd /= next_nd.
Qed.

Lemma rep_l3 : l3_target t.
Proof. by move=> h /half_edge_is_nd[x <-]; rewrite next_nd twin_nd /= !origin_nd tail_after. Qed.

Lemma rep_v1 : v1_leaving t.
Proof.
move=> v h /vertex_is_nv[u <-]; have := says_of_vertex rep u; case: (alone u) => [[-> _] //|[[x -> xu] _]] -[<-].
by rewrite origin_nd xu.
Qed.

Lemma rep_v2 : v2_rotation t.
Proof.
move=> g h /half_edge_is_nd[x <-] /half_edge_is_nd[y <-]; rewrite !origin_nd.
have iterE k : iter k (obind (turn t)) (Some (nd x)) = Some (nd (((rotation s) ^+ k)%g x)).
  by elim: k => [|k IH] /=; rewrite ?expg0 ?perm1 // IH /= turn_nd expgSr permM.
split=> [[k]|[/nv_inj/eqP]].
  by rewrite iterE => -[/nd_inj <-]; congr (Some (nv _)); apply/eqP; rewrite -rotation_tail mem_porbit.
by rewrite -rotation_tail => /porbitP[k ->]; exists k.
Qed.

Lemma on_cycle_nd x y : on_cycle t (nd x) (nd y) <-> same_walk (rotation s) (@other s) x y.
Proof.
have iterE k : iter k (obind (next t)) (Some (nd x)) = Some (nd (iter k (follow (rotation s) (@other s)) x)).
  by elim: k => //= k ->; rewrite /= next_nd.
split=> [[k]|/iter_findex E]; first by rewrite iterE => -[/nd_inj<-]; apply: fconnect_iter.
by exists (findex (follow (rotation s) (@other s)) x y); rewrite iterE E.
Qed.

Lemma follow_inj : injective (follow (rotation s) (@other s)).
Proof. by move=> x y /perm_inj /(inv_inj (@other_back s)). Qed.

Lemma same_walk_sym x y : same_walk (rotation s) (@other s) x y = same_walk (rotation s) (@other s) y x.
Proof. by apply: fconnect_sym; apply: follow_inj. Qed.

Lemma rep_b1 : b1_cycle t.
Proof.
split=> [h /half_edge_is_nd[x <-]|b h lb /half_edge_is_nd[x <-]].
  rewrite next_nd /= !boundary_nd; congr Some; apply/esym/(walks_numbered rep); exact: fconnect1.
rewrite boundary_nd; case: (sideP lb) => [y z yb E yz _|v vb a E _]; rewrite E.
  rewrite -yb; split=> [[/(walks_numbered rep) xy]|[_ [<-]] /on_cycle_nd zx].
    by exists (nd z) => //; apply/on_cycle_nd; rewrite same_walk_sym; apply: connect_trans yz.
  by congr Some; apply/esym/(walks_numbered rep); apply: connect_trans zx.
by split=> [[xb]|[]//]; case: (@walk_or_isolated _ _ _ _ _ _ _ rep x v a); rewrite vb.
Qed.

Lemma starts_at_nv v b : starts_at_vertex t (nv v) b <-> alone v /\ b = ni v.
Proof.
split=> [E|[a ->]]; last by have [_] := says_of_isolated rep a.
have lb : boundary t b := heard_live E; move: E; rewrite /starts_at_vertex.
by case: (sideP lb) => [x y _ -> //|w wb a -> _ [/nv_inj <-]].
Qed.

Lemma rep_b2 : b2_isolated t.
Proof.
move=> v /vertex_is_nv[u <-]; have := says_of_vertex rep u; case a: (alone u).
  case=> _ ->; split=> [_|[]]; last exact/bare_nv.
  by exists (ni u); split=> // c; split=> [/starts_at_nv[] //|->]; apply/starts_at_nv.
case=> _ ->; split=> [/bare_nv|_]; first by rewrite a.
by split=> // b /starts_at_nv[]; rewrite a.
Qed.

Lemma outer_walk f b : outer t (nf f) = Some b -> exists x, [/\ nw x = b, left x = f & ~~ outside x].
Proof.
move=> E; have [Ef Ep] := lists_outer rep E; case: (sideP (heard_live Ef)) => [x y xb _ _ [E' P]|v vb a _ [_ [i []]]].
  move: E'; rewrite Ef => -[/nf_inj ff]; exists x; split=> //; case: (outside x) P => // -[i [P _]].
  by move: P; rewrite Ep.
by rewrite Ep.
Qed.

Lemma rep_f1 : f1_outer t.
Proof.
split=> [|f b v E S].
  exists (nf (unbounded_face s)); split.
    split; first exact: face_nf.
    case E: (outer _ _) => [b|] //; have [x [_ xu /left_inside]] := outer_walk E.
    by rewrite xu eqxx.
  move=> f [/face_is_nf[g <-] none]; case: (eqVneq g (unbounded_face s)) => [-> //|/bounded[x no xg]].
  have [[_ +] _] := says_of_walk rep x; rewrite (negPf no) xg => -[_].
  by rewrite none.
have lv : vertex t v by have [_ _ B _] := rep_links; have [_] := B b (heard_live S); rewrite S.
case: (vertex_is_nv lv) => u uv; rewrite -uv in S; case/starts_at_nv: S => a bu.
have [_ Ep] := lists_outer rep E; have [[_ [i [P _]]] _] := says_of_isolated rep a.
by move: Ep; rewrite bu P.
Qed.

Lemma listed_rep f p b : listed t f p = Some b -> boundary_face t b = Some f /\ boundary_place t b = Some p.
Proof.
case: p => [/(lists_outer rep) //|i] /= E.
have lt : i < inner_count t f by move: E; rewrite /inner; case: ifP.
by have [c [E' Ef Ep]] := lists_inner rep lt; move: E; rewrite E' => -[<-].
Qed.

Lemma stands_listed b f io : stands t b f io -> exists2 p, boundary_place t b = Some p & listed t f p = Some b.
Proof. by case: io => -[_ []] => [i []|]; [exists (Inner i)|exists Outer]. Qed.

Lemma rep_f2 : f2_listed t.
Proof.
have H b f io : stands t b f io -> exists f p,
    [/\ boundary_face t b = Some f, boundary_place t b = Some p & forall f' p', listed t f' p' = Some b <-> f' = f /\ p' = p].
  move=> st; have [p Ep L] := stands_listed st; case: st => Ef _; exists f, p; split=> // f' p'; split=> [|[-> ->] //].
  by case/listed_rep; rewrite Ef Ep => -[->] [->].
by move=> b /sideP[x y _ _ _ /H|v _ _ _ /H].
Qed.

Lemma rep_low : lower t.
Proof.
by case=> // _; [exact: rep_r1|exact: rep_l1|exact: rep_l2|exact: rep_l3|exact: rep_v1|exact: rep_v2|
  exact: rep_b1|exact: rep_b2|exact: rep_f1|exact: rep_f2].
Qed.

(** ** T1 *)

Notation edge := (edge_between (@other s) (@tail s)).

Lemma connected_nv (u : vertices s) w : connected t (nv u) w <-> exists2 v, w = nv v & piece u = piece v.
Proof.
split=> [|[v -> /eqP]].
  elim=> [|h v w' _ [v' -> uv] E]; first by exists u.
  have [x xh] := half_edge_is_nd (heard_live E); move: E; rewrite -xh origin_nd => -[/nv_inj xv].
  rewrite /target twin_nd /= origin_nd => -[<-]; exists (tail (other x)) => //; rewrite uv; apply/eqP.
  by rewrite piece_connected; apply: connect1; apply/existsP; exists x; rewrite xv !eqxx.
rewrite piece_connected => /connectP[p]; elim/last_ind: p v => [|p z IH] v /=; first by move=> _ ->; apply: connected_self.
rewrite rcons_path last_rcons => /andP[pp /existsP[x /andP[/eqP xv /eqP xw]]] ->.
apply: (@connected_edge _ _ (nd x) (nv (tail x))); first by rewrite xv; apply: IH.
  exact: origin_nd.
by rewrite /target twin_nd /= origin_nd xw.
Qed.

Lemma same_piece (x y : darts s) : same_walk (rotation s) (@other s) x y -> piece (tail x) = piece (tail y).
Proof.
move/iter_findex <-; elim: (findex _ _ _) => //= k ->; apply/eqP; rewrite piece_connected; apply: connect1.
by apply/existsP; exists (iter k (follow (rotation s) (@other s)) x); rewrite eqxx -tail_after /after eqxx.
Qed.

Lemma alone_piece (v w : vertices s) : alone v -> piece v = piece w -> v = w.
Proof.
move=> /aloneP a /eqP; rewrite piece_connected => /connectP[[|u p] /=]; first by move=> _ ->.
by case/andP=> /existsP[x /andP[/eqP /a]].
Qed.

Lemma outside_same (x y : darts s) : same_walk (rotation s) (@other s) x y -> outside x = outside y.
Proof. by move/iter_findex <-; elim: (findex _ _ _) => //= k ->; rewrite outside_walk. Qed.

(** The outside of a component is the outside walk of its piece, or the isolated vertex that it is. *)
Lemma outside_ofP (u : vertices s) b : outside_of t (nv u) b <->
  (exists x, [/\ nw x = b, outside x & piece (tail x) = piece u]) \/ alone u /\ b = ni u.
Proof.
split=> [[[i P] [w W /connected_nv[v wv uv]]]|[[x [<- ox xu]]|[a ->]]].
- have lb : boundary t b := heard_live P; move: W; rewrite /vertex_at.
  case: (sideP lb) => [x y xb -> xy [_ Q]|v' vb a -> _ [v'w]].
    have ox : outside x by case: (outside x) Q => // -[]; rewrite P.
    rewrite origin_nd wv => -[/nv_inj yv]; left; exists x; split=> //.
    by rewrite (same_piece xy) yv uv.
  right; rewrite wv in v'w; move/nv_inj: v'w => v'v; rewrite v'v in a vb.
  by have vu := alone_piece a (esym uv); rewrite -vu.
- have [[_ +] [y E xy]] := says_of_walk rep x; rewrite ox => -[i [P _]]; split; first by exists i.
  exists (nv (tail y)); first by rewrite /vertex_at E origin_nd.
  by apply/connected_nv; exists (tail y) => //; rewrite -(same_piece xy).
have [[_ [i [P _]]] E] := says_of_isolated rep a; split; first by exists i.
by exists (nv u); [rewrite /vertex_at E | apply: connected_self].
Qed.

Lemma rep_t1 : t1_outside t.
Proof.
move=> v /vertex_is_nv[u <-]; case a: (alone u).
  exists (ni u); split; first by apply/outside_ofP; right.
  move=> b /outside_ofP[[x [_ _ xu]]|[]//]; have := alone_piece a (esym xu).
  by move/aloneP: a => a ux; case: (a x).
have [x xu] : exists x, tail x = u.
  by move/negbT: a; rewrite negb_forall => /existsP[x]; rewrite negbK => /eqP; exists x.
have [y [oy yx] one] := one_outside x; exists (nw y); split.
  by apply/outside_ofP; left; exists y; rewrite yx xu.
move=> b /outside_ofP[[z [<- oz zu]]|[]]; last by rewrite a.
by apply/(walks_numbered rep); apply: one; rewrite // zu xu.
Qed.

Lemma outside_face_nf (u : vertices s) b : outside_of t (nv u) b -> boundary_face t b = Some (nf (lies_in (piece u))).
Proof.
case/outside_ofP=> [[x [<- ox xu]]|[a ->]].
  by have [[-> _] _] := says_of_walk rep x; rewrite (left_outside ox) xu.
by have [[-> _] _] := says_of_isolated rep a.
Qed.

(** ** T2 *)

Lemma there_rooted (before : seq (pieces s)) (f : faces s) : (forall p, p \in before -> rooted t (nf (lies_in p))) ->
  is_there (@tail s) (@piece s) (@outside s) (@left s) (unbounded_face s) before f -> rooted t (nf f).
Proof.
move=> ok [->|[x [no <- xp]]].
  apply: rooted_here; split; first exact: face_nf.
  case E: (outer _ _) => [b|] //; have [x [_ xu /left_inside]] := outer_walk E.
  by rewrite xu eqxx.
have [[_ +] [y E xy]] := says_of_walk rep x; rewrite (negPf no) => -[_ O].
have [b [o _]] := rep_t1 (vertex_nv (tail y)).
apply: (@rooted_out t (nf (left x)) (nw x) (nv (tail y)) b (nf (lies_in (piece (tail y))))) => //.
- by rewrite /vertex_at E origin_nd.
- exact: outside_face_nf.
by apply: ok; rewrite -(same_piece xy).
Qed.

Lemma rep_t2 : t2_nesting t.
Proof.
have [ps [_ all] down] := one_by_one s.
have H qs : put_down (@tail s) (@piece s) (@outside s) (@left s) (@lies_in s) (unbounded_face s) qs ->
    forall p, p \in qs -> rooted t (nf (lies_in p)).
  elim: qs => //= q qs IH [th /IH ok] p; rewrite inE => /orP[/eqP->|/ok //].
  exact: there_rooted th.
move=> v b f /vertex_is_nv[u <-] /outside_face_nf -> [<-].
exact: (H _ down).
Qed.

(** ** T3 *)

Lemma rep_t3 : t3_euler t.
Proof.
have low := rep_low; have [es Hes] := edges_each low; apply/(t3_sums low Hes).
have [edges every draw] := edge_by_edge s.
have := @numbered_euler t (darts s) (rotation s) (@other s) nd (half_edge t) (@other_back s) (@other_differs s) nd_inj
  _ twin_nd next_nd prev_nd edges _ _ _ _ every (rotations_each low) (cycles_each low) Hes (pieces_each low).
have/drawnP -> := draw; rewrite addn0; apply.
by case: Nd.
Qed.

Theorem represented_holds r : index r < index T4 -> holds t r.
Proof.
case: r => // _; [exact: rep_r1|exact: rep_l1|exact: rep_l2|exact: rep_l3|exact: rep_v1|exact: rep_v2|
  exact: rep_b1|exact: rep_b2|exact: rep_f1|exact: rep_f2|exact: rep_t1|exact: rep_t2|exact: rep_t3].
Qed.

End Represented.
