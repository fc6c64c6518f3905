(** * Represents: a view that keeps R1 to T3 represents a planar subdivision *)

From mathcomp Require Import all_ssreflect all_fingroup.
From twinedge Require Import Arith View Rules Loops LoopsProof Reference Map Counting Lists TopologyProof.
From twinedge Require Import Drawing Euler Numbered Genus Subdivision Represented.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section Represents.
Variable t : view.
Hypothesis low : lower t.
Hypothesis t1 : t1_outside t.
Hypothesis t2 : t2_nesting t.
Hypothesis t3 : t3_euler t.

Let map := low_map low.
Let rot := low_v2 low.

(** ** The parts *)

Definition vertex_type : finType := [finType of slot (vertex_slots t) (vertex t)].
Definition face_type : finType := [finType of slot (face_slots t) (face t)].

Definition tail_of (x : dart t) : vertex_type := at_slot (@vertex_below t) (org_live map x).

Lemma num_tail x : num (tail_of x) = org x. Proof. by []. Qed.

Notation edge := (edge_between (@tw t) tail_of).

Lemma edgeP v w : reflect (exists x : dart t, org x = num v /\ org (tw x) = num w) (edge v w).
Proof.
apply: (iffP existsP) => -[x].
  by case/andP=> /eqP <- /eqP <-; exists x.
case=> xv xw; exists x; apply/andP; split; apply/eqP; apply: num_inj; by rewrite num_tail.
Qed.

Lemma edge_sym_connect : connect_sym edge.
Proof.
apply: sym_connect_sym => v w; apply/edgeP/edgeP => -[x [xv xw]]; exists (tw x); by rewrite twK.
Qed.

Lemma connect_edge (v w : vertex_type) : connect edge v w <-> connected t (num v) (num w).
Proof.
split=> [/connectP[p]|].
  elim: p v => [|u p IH] v /=; first by move=> _ ->; apply: connected_self.
  case/andP=> /edgeP[x [xv xu]] /IH/[apply]; apply: connected_trans.
  by rewrite -xv -xu; apply: connected_step.
suff: forall w', connected t (num v) w' -> forall w : vertex_type, num w = w' -> connect edge v w by move=> H /H; apply.
move=> z {w}; elim=> [w /num_inj-> //|h u w' vu IH /(originP map)[x xh xu] + w ww].
rewrite -xh targetE // => -[xw]; have := IH (tail_of x); rewrite num_tail => /(_ xu) vx.
by apply: connect_trans vx _; apply: connect1; apply/edgeP; exists x; rewrite ww.
Qed.

Definition piece_type : finType := [finType of {v : vertex_type | roots edge v}].
Definition piece_of (v : vertex_type) : piece_type := exist _ (fingraph.root edge v) (roots_root edge_sym_connect v).

Lemma piece_ofP v w : (piece_of v == piece_of w) = connect edge v w.
Proof. by rewrite -(root_connect edge_sym_connect) -(inj_eq val_inj). Qed.

Lemma piece_val (p : piece_type) : piece_of (val p) = p.
Proof. by apply: val_inj; apply/eqP; apply: (valP p). Qed.

Lemma piece_joined (x y : dart t) : piece_of (tail_of x) = piece_of (tail_of y) <-> joined x y.
Proof.
rewrite (rwP eqP) piece_ofP connect_edge !num_tail.
by split; [apply: connected_joined | apply: joined_connected].
Qed.

Definition is_outside : pred (dart t) := fun x => if boundary_place t (bnd x) is Some (Inner _) then true else false.

Lemma is_outsideP x : is_outside x <-> is_inner t (bnd x).
Proof. rewrite /is_outside /is_inner; split=> [|[i ->]] //; case: (boundary_place t _) => [[|i]|] // _; by exists i. Qed.

Lemma follow_nx x : follow (turns low) (@tw t) x = nx x.
Proof. by rewrite /follow turnsE /tn twK. Qed.

Lemma same_walk_bnd x y : same_walk (turns low) (@tw t) x y = (bnd x == bnd y).
Proof. by rewrite bndE //; apply: eq_fconnect; apply: follow_nx. Qed.

Lemma outside_connected v w b : connected t v w -> outside_of t v b -> outside_of t w b.
Proof.
move=> vw [I [u U vu]]; split=> //; exists u => //.
exact: connected_trans (connected_sym map vw) vu.
Qed.

Lemma outside_of_bnd (x y : dart t) : outside_of t (org x) (bnd y) <-> is_outside y /\ joined x y.
Proof.
rewrite (outside_dart low) is_outsideP; split=> -[I]; last first.
  move=> xy; split=> //; have [g S gy] := start_bnd low y; exists g => //.
  by apply: joined_trans xy _; apply: (joined_sym map); apply: joined_orbit gy; apply: joined_nx.
case=> z S xz; split=> //; have [g S' gy] := start_bnd low y; move: S; rewrite S' => -[/num_inj gz].
by apply: joined_trans xz _; rewrite -gz; apply: joined_orbit gy; apply: joined_nx.
Qed.

Variables (left_of : dart t -> face_type) (lies_of : piece_type -> face_type).
Hypothesis left_ofE : forall x, boundary_face t (bnd x) = Some (num (left_of x)).
Hypothesis lies_ofE : forall p b, outside_of t (num (val p)) b -> boundary_face t b = Some (num (lies_of p)).

Lemma lies_piece (v : vertex_type) b : outside_of t (num v) b -> boundary_face t b = Some (num (lies_of (piece_of v))).
Proof.
move=> o; apply: lies_ofE; apply: outside_connected o; apply/connect_edge.
exact: connect_root.
Qed.

Lemma inside_outer x : ~~ is_outside x -> outer t (num (left_of x)) = Some (bnd x).
Proof.
rewrite /is_outside; have [f [p [_ Ef Ep L]]] := placeP low (bnd_live map x).
move: Ef; rewrite left_ofE Ep => -[->]; case: p {Ep} L => // _ [].
Qed.

Variable unbounded_of : face_type.
Hypothesis unbounded_ofE : outer t (num unbounded_of) = None.
Hypothesis unbounded_one : forall f, unbounded t f -> num unbounded_of = f.

Notation there := (is_there tail_of piece_of is_outside left_of unbounded_of).
Notation put := (put_down tail_of piece_of is_outside left_of lies_of unbounded_of).

(** ** The pieces can be put down *)

Lemma there_more (ps qs : seq piece_type) f : {subset ps <= qs} -> there ps f -> there qs f.
Proof. by move=> sub [->|[x [no xf /sub xp]]]; [left | right; exists x]. Qed.

Lemma put_cat ps qs : put ps -> put qs -> put (ps ++ qs).
Proof.
elim: ps => //= p ps IH [th /IH/[apply] down]; split=> //.
by apply: there_more th => q qp; rewrite mem_cat qp.
Qed.

Lemma put_undup ps : put ps -> put (undup ps).
Proof.
elim: ps => //= p ps IH [th /IH down]; case: (p \in ps) => //=; split=> //.
by apply: there_more th => q; rewrite mem_undup.
Qed.

Lemma rooted_there f : rooted t f -> forall g : face_type, num g = f -> exists2 ps, put ps & there ps g.
Proof.
elim=> {f} [f un g gf|f b w b' f' E W o Ef _ IH g gf].
  exists [::] => //; left; apply: num_inj; by rewrite gf (unbounded_one un).
have lf' : face t f' by case: (outside_face low o) => h; rewrite Ef => -[->].
have [g' g'f] := slotP (@face_below t) lf'; have [ps down th] := IH g' g'f.
rewrite -gf in E; case: (faceP low (num_live g)) => [|x Ex S]; first by rewrite E.
have bx : b = bnd x by move: E; rewrite Ex => -[].
have wx : org x = w by move: W; rewrite bx (vertex_at_cycle low S) => -[].
have [Eg Ep] := listed_names low (p := Outer) Ex.
rewrite -wx -(num_tail x) in o; have := lies_piece o; rewrite Ef => -[lp].
exists (piece_of (tail_of x) :: ps) => /=.
  split=> //; suff -> : lies_of (piece_of (tail_of x)) = g' by [].
  by apply: num_inj; rewrite -lp.
right; exists x; split; last exact: mem_head.
  by rewrite /is_outside Ep.
by apply: num_inj; move: Eg; rewrite left_ofE => -[].
Qed.

Lemma all_put : exists2 ps, uniq ps /\ (forall p, p \in ps) & put ps.
Proof.
suff [ps all down] : exists2 ps, (forall p, p \in enum piece_type -> p \in ps) & put ps.
  exists (undup ps); last exact: put_undup.
  by split=> [|p]; rewrite ?undup_uniq // mem_undup all // mem_enum.
elim: (enum piece_type) => [|p s [ps all down]]; first by exists [::].
have [b [o _]] := t1 (num_live (val p)); have r := t2 (num_live (val p)) o (lies_ofE o).
have [qs down' th] := rooted_there r (erefl (num (lies_of p))).
exists ((p :: qs) ++ ps) => [q|]; last by apply: put_cat.
by rewrite mem_cat !inE => /orP[->|/all->] //; rewrite orbT.
Qed.

(** ** The subdivision *)

Lemma around_turns x y : (y \in porbit (turns low) x) = (tail_of x == tail_of y).
Proof.
rewrite -(inj_eq (@num_inj _ _)) !num_tail -(rotationE map rot).
have E z : turns low z = tn z by apply: turnsE.
apply/porbitP/idP => [[i ->]|/iter_findex <-].
  by elim: i => [|i IH]; rewrite ?expg0 ?perm1 ?connect0 // expgSr permM E; apply: connect_trans IH (fconnect1 _ _).
exists (findex (@tn t) x y); elim: (findex _ _ _) => [|i IH]; first by rewrite expg0 perm1.
by rewrite expgSr permM E iterS -IH.
Qed.

Lemma drawn_turns : exists2 edges, every_edge (@tw t) edges & drawn (turns low) (@tw t) edges.
Proof.
have [edges every] := every_edge_exists (twK map) (tw_neq map).
by exists edges => //; apply/(t3_plane low every).
Qed.

Lemma outside_nx x : is_outside (follow (turns low) (@tw t) x) = is_outside x.
Proof. by rewrite follow_nx /is_outside bnd_nx. Qed.

Lemma one_outside_of x : exists2 y, is_outside y /\ piece_of (tail_of y) = piece_of (tail_of x) &
  forall z, is_outside z -> piece_of (tail_of z) = piece_of (tail_of x) -> same_walk (turns low) (@tw t) y z.
Proof.
have [b [o one]] := t1 (org_live map x); have [I [y S xy]] := (outside_dart low x b).1 o.
have yb : bnd y = b by case: (boundaryP low (heard_live S)) => [z|v]; rewrite S // => -[/num_inj->].
rewrite -yb in o one I; exists y; first by split; [apply/is_outsideP | apply/piece_joined; apply: joined_sym].
move=> z oz /piece_joined zx; rewrite same_walk_bnd; apply/eqP; apply: one; apply/outside_of_bnd; split=> //.
exact: joined_sym.
Qed.

Lemma left_outside_of x : is_outside x -> left_of x = lies_of (piece_of (tail_of x)).
Proof.
move=> ox; apply: num_inj; apply: Some_inj; rewrite -left_ofE; apply: lies_piece; rewrite num_tail.
by apply/outside_of_bnd; split=> //; apply: joined_refl.
Qed.

Lemma left_inside_of x : ~~ is_outside x -> left_of x != unbounded_of.
Proof. by move/inside_outer; apply: contra_eqN => /eqP->; rewrite unbounded_ofE. Qed.

Lemma left_own_of x y : ~~ is_outside x -> ~~ is_outside y -> (left_of x == left_of y) = same_walk (turns low) (@tw t) x y.
Proof.
move=> nx ny; rewrite same_walk_bnd; apply/eqP/eqP => [E|E].
  by have := inside_outer nx; rewrite E (inside_outer ny) => -[].
by apply: num_inj; apply: Some_inj; rewrite -!left_ofE E.
Qed.

Lemma bounded_of f : f != unbounded_of -> exists2 x, ~~ is_outside x & left_of x = f.
Proof.
move=> ne; case: (faceP low (num_live f)) => [E|x Ex S].
  by case/eqP: ne; apply: num_inj; rewrite (unbounded_one (conj (num_live f) E)).
have [Ef Ep] := listed_names low (p := Outer) Ex; exists x; first by rewrite /is_outside Ep.
by apply: num_inj; move: Ef; rewrite left_ofE => -[].
Qed.

Definition subdivision_of : subdivision :=
  @Subdivision vertex_type (dart t) piece_type face_type (turns low) (@tw t) tail_of (twK map) (tw_neq map) around_turns
    piece_of piece_ofP (fun p => ex_intro _ (val p) (piece_val p)) drawn_turns is_outside outside_nx one_outside_of
    unbounded_of left_of lies_of left_outside_of left_inside_of left_own_of bounded_of all_put.

Lemma alone_of (v : vertex_type) : alone (s := subdivision_of) v <-> bare t (num v).
Proof.
split=> [/forallP H|/(bareP map) H].
  by apply/(bareP map) => x xv; move: (H x); rewrite /= -(inj_eq (@num_inj _ _)) num_tail xv eqxx.
by apply/forallP=> x; rewrite /= -(inj_eq (@num_inj _ _)) num_tail; apply/eqP/H.
Qed.

Definition isolated_of (v : vertex_type) := odflt 0 (isolated t (num v)).

Lemma isolated_ofE (v : vertex_type) : bare t (num v) ->
  isolated t (num v) = Some (isolated_of v) /\ starts_at_vertex t (num v) (isolated_of v).
Proof.
move=> bv; case: (vertexP low (num_live v)) => [x _ xv|b _ _ E S].
  by case: (@not_bare _ low x); rewrite xv.
by rewrite /isolated_of E.
Qed.

Lemma numbered (n : nat) (live : pred nat) (below : forall i : nat, live i -> i < n) :
  numbers (@num n live) live.
Proof.
by split=> [|i]; [apply: num_inj | split=> [l|[x <-]]; [exists (at_slot below l) | apply: num_live]].
Qed.

Lemma represents_it : represents t subdivision_of.
Proof.
exists (@num _ _), (@num _ _), (@num _ _), (fun x : dart t => bnd x), isolated_of.
have iso v : bare t (num v) -> outside_of t (num v) (isolated_of v).
  by move=> bv; apply/(outside_bare low) => //; [apply: num_live | case: (isolated_ofE bv)].
split=> /=.
- exact: numbered (@vertex_below t).
- exact: numbered (@half_edge_below t).
- exact: numbered (@face_below t).
- by move=> x y; rewrite same_walk_bnd; split=> [->|/eqP].
- move=> v w /alone_of/isolated_ofE[_ Sv] /alone_of/isolated_ofE[_ Sw] E; rewrite E in Sv.
  by move: Sv; rewrite /starts_at_vertex Sw => -[/num_inj].
- move=> x v /alone_of/isolated_ofE[_ S] E; have [g S' _] := start_bnd low x.
  by move: S; rewrite /starts_at_vertex -E S'.
- move=> b; split=> [lb|[[x <-]|[v /alone_of/isolated_ofE[_ S] <-]]].
  + case: (boundaryP low lb) => [x _ xb|v S lv bv E]; [by left; exists x | right].
    have [u uv] := slotP (@vertex_below t) lv; rewrite -uv in bv E.
    by exists u; [apply/alone_of | rewrite /isolated_of E].
  + exact: (bnd_live map).
  exact: heard_live S.
- move=> x; rewrite /after /= follow_nx; split; [exact: originE|exact: twinE|exact: nextE| |exact: boundaryE].
  by rewrite prevE // nxK.
- move=> v; case a: (alone _).
    have/alone_of bv := a; case: (isolated_ofE bv) => -> _; split=> //.
    by case: (vertexP low (num_live v)) => [x _ xv|]; [case: (@not_bare _ low x); rewrite xv|].
  have nb : ~ bare t (num v) by move/alone_of; rewrite a.
  have [_ H] := low_b2 low (num_live v); have [E _] := H nb; split=> //.
  case: (vertexP low (num_live v)) => [x Ex xv|b _ bv]; last by case: nb.
  by exists x => //; apply: num_inj; rewrite num_tail.
- move=> x; split; last first.
    have [g S gx] := start_bnd low x; exists g => //; rewrite same_walk_bnd bndE // fconnect_sym //; exact: nx_inj.
  split; first exact: left_ofE.
  case ox: (is_outside x); last first.
    move/negbT: ox => /inside_outer E; split=> //.
    by have [] := listed_names low (p := Outer) E.
  have [i P] := (is_outsideP x).1 ox; exists i; split=> //.
  have [f [p [_ Ef Ep L]]] := placeP low (bnd_live map x).
  by move: Ep Ef L; rewrite P left_ofE => -[<-] [<-].
- move=> v /alone_of bv; have [_ S] := isolated_ofE bv; split=> //; split; first exact: lies_piece (iso v bv).
  have [i P] := vertex_inner low S; exists i; split=> //.
  have [f [p [_ Ef Ep L]]] := placeP low (heard_live S).
  by move: Ep Ef L; rewrite P (lies_piece (iso v bv)) => -[<-] [<-].
- by move=> f b E; apply: (listed_names low (p := Outer)).
move=> f i lt; have [_ _ _ Fl] := low_r1 low.
have lf : face t f by move: lt; rewrite /inner_count; case: ifP.
have [_ /(_ i lt)[b E _]] := Fl f lf; exists b; split=> //; by have [] := listed_names low (p := Inner i) E.
Qed.

End Represents.

(** ** The rules mean planar subdivisions *)

Theorem rules_represent t : holds_before t T4 -> exists s, represents t s.
Proof.
move=> H; have low : lower t by move=> q lt; apply: H; apply: leq_trans lt _.
have t1 : t1_outside t := H T1 isT; have t2 : t2_nesting t := H T2 isT; have t3 : t3_euler t := H T3 isT.
have [left_of left_ofE] : exists left_of, forall x : dart t, boundary_face t (bnd x) = Some (num (left_of x : face_type t)).
  apply: (@fin_all_exists (dart t) (fun _ => face_type t) (fun x f => boundary_face t (bnd x) = Some (num f))) => x.
  have [f [p [lf Ef _ _]]] := placeP low (bnd_live (low_map low) x).
  by have [g gf] := slotP (@face_below t) lf; exists g; rewrite gf.
have [lies_of lies_ofE] : exists lies_of, forall p : piece_type low, forall b, outside_of t (num (val p)) b ->
    boundary_face t b = Some (num (lies_of p : face_type t)).
  apply: (@fin_all_exists (piece_type low) (fun _ => face_type t) (fun p f =>
    forall b, outside_of t (num (val p)) b -> boundary_face t b = Some (num f))) => p.
  have [b [o one]] := t1 _ (num_live (val p)); have [f Ef lf] := outside_face low o.
  by have [g gf] := slotP (@face_below t) lf; exists g => c /one <-; rewrite gf.
have [[f [[lf E] one]] _] := low_f1 low; have [g gf] := slotP (@face_below t) lf; rewrite -gf in E one.
by exists (subdivision_of t1 t2 t3 left_ofE lies_ofE E one); apply: represents_it.
Qed.
