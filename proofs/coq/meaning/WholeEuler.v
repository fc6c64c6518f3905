(** * WholeEuler: V − E + F = 1 + C − 2g for the whole map *)

From mathcomp Require Import all_ssreflect all_fingroup.
From twinedge Require Import Arith View Rules Loops LoopsProof Reference Map Counting Lists TopologyProof.
From twinedge Require Import Drawing Euler Numbered Genus.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** ** Two lists whose elements belong together one to one are equally long *)

Lemma rel_size_le (s s' : seq nat) (R : nat -> nat -> Prop) : uniq s ->
  (forall x, x \in s -> exists2 y, y \in s' & R x y) ->
  (forall x x' y, x \in s -> x' \in s -> R x y -> R x' y -> x = x') -> size s <= size s'.
Proof.
move=> u tot inj.
suff: forall r, uniq r -> {subset r <= s} -> exists r', [/\ size r' = size r, uniq r' & forall y, y \in r' ->
    y \in s' /\ exists2 x, x \in r & R x y].
  by move=> /(_ s u (fun x H => H))[r' [<- u' H]]; apply: uniq_leq_size => // y /H[].
elim=> [|x r IH] /=; first by exists [::].
case/andP=> xr ur sub; have xs : x \in s by apply: sub; apply: mem_head.
case: IH => // [y yr|r' [sz u' H]]; first by apply: sub; rewrite inE yr orbT.
case: (tot x xs) => y ys' xy; exists (y :: r'); split=> /=; first by rewrite sz.
  rewrite u' andbT; apply/negP=> /H[_ [z zr zy]]; move: xr; rewrite (inj x z y) ?zr //.
  by apply: sub; rewrite inE zr orbT.
move=> z; rewrite inE => /orP[/eqP->|/H[zs [w wr wz]]]; first by split=> //; exists x; rewrite ?mem_head.
by split=> //; exists w; rewrite // inE wr orbT.
Qed.

Lemma rel_size (s s' : seq nat) (R : nat -> nat -> Prop) : uniq s -> uniq s' ->
  (forall x, x \in s -> exists2 y, y \in s' & R x y) -> (forall y, y \in s' -> exists2 x, x \in s & R x y) ->
  (forall x x' y, x \in s -> x' \in s -> R x y -> R x' y -> x = x') ->
  (forall x y y', y \in s' -> y' \in s' -> R x y -> R x y' -> y = y') -> size s = size s'.
Proof.
move=> u u' tot onto inj fn; apply/eqP; rewrite eqn_leq (rel_size_le u tot inj) /=.
apply: (@rel_size_le s' s (fun y x => R x y) u' onto) => y y' x ys ys'; exact: fn.
Qed.

Lemma size_split (s : seq nat) (p : pred nat) : size s = size (filter p s) + size (filter (predC p) s).
Proof. by rewrite !size_filter count_predC. Qed.

Section Whole.
Variable t : view.
Hypothesis low : lower t.

Let map := low_map low.
Let rot := low_v2 low.

Definition isolated_ones := [seq v <- iota 0 (vertex_slots t) | vertex t v && ~~ isSome (leaving t v)].

Lemma isolated_onesP v : v \in isolated_ones <-> vertex t v /\ bare t v.
Proof.
rewrite mem_filter mem_iota add0n; split=> [/andP[/andP[lv]]|[lv bv]].
  by case: (vertexP low lv) => [x -> //|b -> bv _ _].
rewrite lv vertex_below //= andbT; case: (vertexP low lv) => [x _ xv|b -> //].
by case: (@not_bare _ low x); rewrite xv.
Qed.

Lemma vertices_size vs : lists vs (vertex t) -> size vs = size (with_edges t) + size isolated_ones.
Proof.
move=> H; rewrite (lists_size H (lists_filter (@vertex_below t) (fun v => iff_refl (vertex t v)))).
rewrite (size_split _ (fun v => isSome (leaving t v))) -!filter_predI; congr (_ + _); congr size.
  by apply: eq_filter => v /=; case E: (leaving t v) => [h|] //=; rewrite (heard_live E).
by apply: eq_filter => v /=; rewrite andbC.
Qed.

(** *** Boundary components *)

Definition boundaries := [seq b <- iota 0 (boundary_slots t) | boundary t b].
Definition outer_ones := [seq b <- boundaries | if boundary_place t b is Some Outer then true else false].
Definition inner_ones := [seq b <- boundaries | ~~ if boundary_place t b is Some Outer then true else false].

Lemma boundariesP b : b \in boundaries <-> boundary t b.
Proof. by rewrite mem_filter mem_iota add0n; split=> [/andP[]//|l]; rewrite l boundary_below. Qed.

Lemma inner_onesP b : b \in inner_ones <-> is_inner t b.
Proof.
rewrite mem_filter; split=> [/andP[+ /boundariesP lb]|[i P]].
  by have [f [p [_ _ Ep _]]] := placeP low lb; rewrite Ep; case: p Ep => // i Ep _; exists i.
by rewrite P; apply/boundariesP; apply: heard_live P.
Qed.

Lemma outer_onesP b : b \in outer_ones <-> boundary_place t b = Some Outer.
Proof.
rewrite mem_filter; split=> [/andP[]|P]; first by case: (boundary_place t b) => [[|i]|].
by rewrite P; apply/boundariesP; apply: heard_live P.
Qed.

Lemma boundaries_sides : size boundaries = size (cycles t) + size isolated_ones.
Proof.
rewrite (size_split _ (cyclic t)); congr (_ + _).
  rewrite size_map; congr size; rewrite -filter_predI; apply: eq_filter => b /=.
  rewrite andbC; case lb: (boundary t b) => //=; rewrite /cyclic.
  by case S: (boundary_start t b) => [s|] //; rewrite (heard_live S) in lb.
apply: (@rel_size _ _ (fun b v => starts_at_vertex t v b)).
- by rewrite !filter_uniq ?iota_uniq.
- by rewrite filter_uniq ?iota_uniq.
- move=> b; rewrite mem_filter => /andP[/= c /boundariesP/(boundaryP low)[x S _|v S lv bv _]].
    by move: c; rewrite /cyclic S.
  by exists v => //; apply/isolated_onesP.
- move=> v /isolated_onesP[lv bv]; case: (vertexP low lv) => [x _ xv|b _ _ _ S].
    by case: (@not_bare _ low x); rewrite xv.
  exists b => //; rewrite mem_filter /= /cyclic S /=; apply/boundariesP; exact: heard_live S.
- move=> b c v _; rewrite mem_filter => /andP[_ /boundariesP lc] Sb Sc.
  case: (boundaryP low lc) => [x S|w S lw _ I]; first by move: Sc; rewrite /starts_at_vertex S.
  move: Sc; rewrite /starts_at_vertex S => -[wv]; rewrite -wv in Sb.
  exact: (bare_unique low lw I Sb).
by move=> b v w _ _; rewrite /starts_at_vertex => -> -[].
Qed.

Lemma faces_size fs : lists fs (face t) -> size fs = 1 + size outer_ones.
Proof.
move=> H; rewrite (lists_size H (lists_filter (@face_below t) (fun v => iff_refl (face t v)))).
rewrite (size_split _ (fun f => is_nil (outer t f))); congr (_ + _).
  rewrite -filter_predI size_filter; apply/eqP/count1P => [f /andP[_]|]; first exact: face_below.
  have [[f [[lf E] one]] _] := low_f1 low; exists f; split; first by rewrite /= E lf.
  by move=> g /andP[/= n lg]; apply: one; split=> //; case: (outer t g) n.
apply: (@rel_size _ _ (fun f b => outer t f = Some b)).
- by rewrite !filter_uniq ?iota_uniq.
- by rewrite !filter_uniq ?iota_uniq.
- move=> f; rewrite mem_filter /=; case E: (outer t f) => [b|] // _; exists b => //; apply/outer_onesP.
  by have [] := listed_names low (p := Outer) E.
- move=> b /outer_onesP P; have [f [p [lf Ef Ep L]]] := placeP low (heard_live P).
  move: Ep L; rewrite P => -[<-] L; exists f => //.
  by rewrite mem_filter /= [outer t f]L mem_filter lf mem_iota face_below.
- move=> f g b _ _ /(listed_names low (p := Outer))[Ef _] /(listed_names low (p := Outer))[].
  by rewrite Ef => -[].
by move=> f b c _ _ -> [].
Qed.

(** *** Components *)

Hypothesis t1 : t1_outside t.

Lemma components_inner cs : lists_one_of_each cs (connected t) (vertex t) -> size cs = size inner_ones.
Proof.
case=> u live one all; apply: (@rel_size _ _ (fun v b => vertex t v /\ outside_of t v b)) => //.
- by rewrite !filter_uniq ?iota_uniq.
- by move=> v /live lv; have [b [o _]] := t1 lv; exists b => //; apply/inner_onesP; case: o.
- move=> b /inner_onesP I; have lb : boundary t b by case: I => i P; apply: heard_live P.
  have [v W lv] : exists2 v, vertex_at t b = Some v & vertex t v.
    case: (boundaryP low lb) => [x S _|v S lv _ _].
      by exists (org x); [apply: vertex_at_cycle | apply: org_live].
    by exists v => //; apply: vertex_at_vertex.
  have [w ws wv] := all v lv; exists w => //; split; first exact: live.
  by split=> //; exists v.
- move=> v w b vs ws [_ [_ [x W vx]]] [_ [_ [y]]]; rewrite W => -[<-] wx; apply: one => //.
  by apply: connected_trans vx _; apply: connected_sym.
by move=> v b c _ _ [lv ob] [_ oc]; have [d [_ o]] := t1 lv; rewrite -(o b ob) -(o c oc).
Qed.

Lemma components_size cs : lists_one_of_each cs (connected t) (vertex t) ->
  size cs = size (pieces t) + size isolated_ones.
Proof.
case=> u live one all; rewrite (size_split _ (fun v => isSome (leaving t v))); congr (_ + _).
  apply: (@rel_size _ _ (fun v r => exists2 x : dart t, connected t v (org x) & labels t (num x) = Some r)).
  - by rewrite filter_uniq.
  - by rewrite filter_uniq ?iota_uniq.
  - move=> v; rewrite mem_filter => /andP[]; case E: (leaving t v) => [h|] // _ _.
    have [x _ xv] := keptP low E; have [r xr rp] := label_piece low x; exists r => //; exists x => //.
    by rewrite xv; apply: connected_self.
  - move=> r /(piecesP low) rr; have [x xr] := dartP (label_live map rr); rewrite -xr in rr.
    have [v vs vx] := all _ (org_live map x); exists v; last by exists x; rewrite -?xr.
    rewrite mem_filter vs andbT; case: (connected_dart map rot vx) => [->|[y [_ [<- _ _]]]].
      by have [y -> _] := kept_org low x.
    by have [z -> _] := kept_org low y.
  - move=> v w r; rewrite !mem_filter => /andP[_ vs] /andP[_ ws] [x vx xr] [y wy yr]; apply: one => //.
    apply: connected_trans vx _; apply: connected_trans (connected_sym map wy).
    by apply/(label_connected map rot); rewrite xr yr.
  move=> v r q _ _ [x vx xr] [y vy yq].
  have/(label_connected map rot) : connected t (org x) (org y) by apply: connected_trans vy; apply: connected_sym.
  by rewrite xr yq => -[].
apply: perm_size; apply: uniq_perm; rewrite ?filter_uniq ?iota_uniq // => v.
rewrite mem_filter /=; apply/idP/idP => [/andP[n /live lv]|/isolated_onesP[lv bv]].
  by apply/isolated_onesP; split=> //; case: (vertexP low lv) n => [x ->|].
have [w ws wv] := all v lv; have vw := connected_bare map rot bv (connected_sym map wv); rewrite -vw ws andbT.
by rewrite vw; case: (vertexP low lv) => [x _ xv|b ->] //; case: (@not_bare _ low x); rewrite xv.
Qed.

(** *** The whole *)

(** V − E + F = 1 + C − 2g, where [g] edges need a handle; and [g = 0] exactly if T3 holds. *)
Theorem euler_whole V E F cs : map_has_counts t V E F -> lists_one_of_each cs (connected t) (vertex t) ->
  exists g, V + F + g.*2 = 1 + size cs + E /\ (g = 0 <-> t3_euler t).
Proof.
case=> vs [es [fs [Hv He Hf [-> -> ->]]]] Hc.
have [edges every] := every_edge_exists (twK map) (tw_neq map).
exists (handles (turns low) (@tw t) edges); split; last by rewrite (t3_plane low every) drawnP.
have := whole_euler low every (rotations_each low) (cycles_each low) He (pieces_each low).
have := vertices_size Hv; have := faces_size Hf; have := boundaries_sides; have := components_size Hc.
have := components_inner Hc; have : size boundaries = size outer_ones + size inner_ones by exact: size_split.
have : size (rotations t) = size (with_edges t) by exact: size_map.
by arith.
Qed.

(** V − E + F = 1 + C exactly if T3 holds. *)
Corollary euler_plane V E F cs : map_has_counts t V E F -> lists_one_of_each cs (connected t) (vertex t) ->
  t3_euler t <-> V + F = 1 + size cs + E.
Proof. by move=> H Hc; have [g [eq <-]] := euler_whole H Hc; split; arith. Qed.

(** There are as many components as inner boundary components. So T3 holds if and only if four lists fit together. *)
Corollary t3_counts vs es fs bs : lists vs (vertex t) -> lists_one_of_each es (same_edge t) (half_edge t) ->
  lists fs (face t) -> lists bs (is_inner t) -> t3_euler t <-> size vs + size fs = 1 + size bs + size es.
Proof.
move=> Hv He Hf [ub Hb]; pose at_vertex b := odflt 0 (vertex_at t b).
have atE b : b \in bs -> [/\ vertex_at t b = Some (at_vertex b), vertex t (at_vertex b) & outside_of t (at_vertex b) b].
  move/Hb=> I; have [v W lv] : exists2 v, vertex_at t b = Some v & vertex t v.
    have lb : boundary t b by case: I => i P; apply: heard_live P.
    case: (boundaryP low lb) => [x S _|v S lv _ _].
      by exists (org x); [apply: vertex_at_cycle | apply: org_live].
    by exists v => //; apply: vertex_at_vertex.
  rewrite /at_vertex W; split=> //; split=> //; exists v => //; exact: connected_self.
have same b c : b \in bs -> c \in bs -> connected t (at_vertex b) (at_vertex c) -> b = c.
  move=> bb cc C; have [_ lv O] := atE b bb; have [W _ [I _]] := atE c cc; have [d [_ one]] := t1 lv.
  by rewrite -(one b O) (one c) //; split=> //; exists (at_vertex c).
have Hc : lists_one_of_each [seq at_vertex b | b <- bs] (connected t) (vertex t).
  split=> [|v /mapP[b bb ->]|v w /mapP[b bb ->] /mapP[c cc ->] C|v lv].
  - by rewrite map_inj_in_uniq // => b c bb cc E; apply: same => //; rewrite E; apply: connected_self.
  - by have [] := atE b bb.
  - by rewrite (same b c).
  have [b [[I [w W C]] _]] := t1 lv; have bb : b \in bs by apply/Hb.
  exists (at_vertex b); first exact: map_f.
  by apply: (connected_sym map); rewrite /at_vertex W.
have := @euler_plane (size vs) (size es) (size fs) _ (ex_intro _ vs (ex_intro _ es (ex_intro _ fs
  (And4 Hv He Hf (And3 erefl erefl erefl))))) Hc.
by rewrite size_map.
Qed.

End Whole.
