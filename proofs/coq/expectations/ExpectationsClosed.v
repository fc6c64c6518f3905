(** * ExpectationsClosed: a closed structure is an open one without border, so what the rules mean there they mean here

    Where each half-edge has a twin and, if faces are stored, a face, it does not matter whether open boundaries would be legal. *)

From mathcomp Require Import all_ssreflect all_fingroup.
From twinedge Require Import View Rules Loops LoopsProof Reference ReferenceProof Map Counting Lists Subdivision RotationSystem Verdict.
From twinedge Require Import Expectations ExpectationsCheck ExpectationsLists ExpectationsVerdict ExpectationsPlane ExpectationsFaceless.
From twinedge Require Import ExpectationsParts ExpectationsFaces ExpectationsBorder ExpectationsMissing ExpectationsOpenCounts ExpectationsOpen.
From twinedge Require Import ExpectationsNested ExpectationsHoles.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Definition closed_on on := Expectation on false false false None false None None None false.

Section Closed.
Variables (t : view) (on faces records places holes unbounded : bool) (sf so : nat -> link) (si : nat -> nat -> option start).
Let s := Structure t (Parts true true faces records places holes unbounded) sf so si.
Let ec := closed_on on.
Let eo := open_on on.

Definition no_border := forall h, half_edge t h -> twin t h <> None /\ ~~ lacks_face eo s h.

Section Without.
Hypothesis none : no_border.

Lemma not_on_border h : half_edge t h -> on_border eo s h = false.
Proof. by move=> /none[T _]; rewrite /on_border -[twin (seen _ _) h]/(twin t h); case: (twin t h) T. Qed.

Lemma same_end h : end_of eo s h = end_of ec s h.
Proof.
rewrite /end_of /=; case: (boolP (half_edge t h)) => [lh|no]; first by rewrite not_on_border.
case: (on_border eo s h) => //; rewrite -[next (seen _ _) h]/(next t h) /next -[target _ h]/(twin t h >>= origin t) /twin /heard.
by rewrite (negPf no).
Qed.

Lemma same_closed_linked u w : linked eo s u w <-> linked ec s u w.
Proof. by apply: walks_iff => x y; rewrite /edge_step; split=> -[h O E]; exists h => //; rewrite -E same_end. Qed.

Lemma same_closed_component v h : of_component eo s v h <-> of_component ec s v h.
Proof. by split=> -[w O L]; exists w => //; apply/same_closed_linked. Qed.

Lemma same_entries v x : outside_entry eo s v x <-> outside_entry ec s v x.
Proof. by split=> -[I [w W L]]; split=> //; exists w => //; apply/same_closed_linked. Qed.

Lemma not_open_either v : ~ opens eo s v /\ ~ opens ec s v.
Proof.
split=> -[h c B].
  have lh : half_edge t h := of_component_live c; have [_ F] := none lh; by rewrite not_on_border // (negPf F) in B.
have lh : half_edge t h := of_component_live c; have [_ F] := none lh; move: B; rewrite /= -[lacks_face ec s h]/(lacks_face eo s h).
by rewrite (negPf F).
Qed.

Lemma same_closed_t1 : t1 eo s <-> t1 ec s.
Proof.
have same v : one_or_none (outside_entry eo s v) (~~ has_unbounded eo s \/ opens eo s v) <->
    one_or_none (outside_entry ec s v) (~~ has_unbounded ec s \/ opens ec s v).
  have [no no'] := not_open_either v; split=> -[[x [X one]]|[[] // legal not]].
  - by left; exists x; split=> [|y /same_entries/one //]; apply/same_entries.
  - by right; split=> [|x /same_entries]; [left|apply: not].
  - by left; exists x; split=> [|y /same_entries/one //]; apply/same_entries.
  by right; split=> [|x /same_entries]; [left|apply: not].
by split=> H hh v lv; apply/same; apply: H.
Qed.

Lemma same_closed_lies v u : lies_in eo s v u <-> lies_in ec s v u.
Proof. by split=> -[x X U]; exists x => //; apply/same_entries. Qed.

Lemma same_closed_t2 : t2 eo s <-> t2 ec s.
Proof.
split=> H hh v u w lv vu uw wv; apply: (H hh v u w lv); try exact/same_closed_lies; try exact/same_closed_linked;
  by apply/(walks_iff _ _ same_closed_lies).
Qed.

Lemma same_closed_counts v V E C : counts_of eo s v V E C <-> counts_of ec s v V E C.
Proof.
have H : forall V' E' C', counts_of eo s v V' E' C' -> counts_of ec s v V' E' C'.
  move=> V' E' C' [vs [es [cs [bs [Hv He Hc Hb S]]]]]; exists vs, es, cs, bs; split=> //.
  - by apply: lists_iff Hv => x; apply: same_closed_linked.
  - by apply: lists_iff He => h; rewrite same_closed_component.
  - by apply: lists_iff Hc => h; rewrite same_closed_component.
  apply: lists_iff Hb => h; split=> -[c [B _]] //.
  by have lh : half_edge t h := of_component_live c; rewrite not_on_border in B.
split; first exact: H.
case N: (counted eo s v) => [[V' E'] C'] K; have K' := (countedP eo s v V' E' C').2 N.
move: K (H _ _ _ K') => /countedP + /countedP; by move=> -> -[-> -> ->].
Qed.

Lemma same_closed_t3 : t3 eo s <-> t3 ec s.
Proof. by split=> H v lv; have [V [E [C [N G]]]] := H v lv; exists V, E, C; split=> //; apply/same_closed_counts. Qed.

Lemma same_closed_t4 : t4 eo s <-> t4 ec s.
Proof.
have sim : simple_of eo s <-> simple_of ec s.
  split=> H g u w O E.
    have E' : end_of eo s g = Some w by rewrite same_end.
    by have [ne par] := H g u w O E'; split=> // h K; apply: par; move: K; rewrite !same_end.
  have E' : end_of ec s g = Some w by rewrite -same_end.
  by have [ne par] := H g u w O E'; split=> // h K; apply: par; move: K; rewrite !same_end.
by split=> H pl /sim; apply: H.
Qed.

Lemma same_closed_v2 : open_rules t -> v2 ec s.
Proof.
move=> keeps; have [_ _ _ V2] := keeps; move=> g h lg lh; split=> [[o|[]//]|E]; first by apply/(V2 g h lg lh); left.
left; have O : origin (whole t) g = origin (whole t) h by rewrite !origin_old.
have [n N] := (whole_v2 keeps (live_old lg) (live_old lh)).2 O; exists n; rewrite -N.
elim: n {N} => // n IH; rewrite !iterS IH; case I: (iter n _ _) => [k|] //=.
have lk : half_edge t k.
  have I' : iter n (obind (turn t)) (Some g) = Some k by rewrite -I; exact: IH.
  by have [] := same_around_turn keeps lg I'.
have [T _] := none lk; rewrite /turn twin_old //; case T': (twin t k) T => [m|] // _ /=.
by rewrite -[twin _ k]/(twin t k) T' /= next_old // (heard_live (twin_back keeps T')).
Qed.

End Without.

Lemma closed_no_border : r1 ec s -> no_border.
Proof.
move=> [Hh _ _ _ _] h lh; have [_ T _ _ S] := Hh h lh; split.
  by case: T => // -[g]; rewrite -[twin _ h]/(twin t h) => ->.
rewrite /lacks_face; case hf: (has_faces s) => //=; case: (S hf) => [[f E _]|[]] //.
by rewrite -[side eo s h]/(side ec s h) E.
Qed.

Lemma closed_open_v2 : r1 ec s -> l1 ec s -> l2 ec s -> v2 ec s -> v2 eo s.
Proof.
move=> R L1 L2 V2 g h lg lh; split=> [[o|[_ o]]|/(V2 g h lg lh)[o|[]//]]; [by apply/(V2 g h lg lh); left| |by left].
apply/esym/(V2 h g lh lg); left; apply: orbit_reversed o => i j.
rewrite /turn_back; case P: (prev _ i) => [k|] //= T; have lk := heard_live T; have li := heard_live P.
have [B _] := L1 k lk isT; rewrite /turn; move: B; rewrite T /= => ->; rewrite /=.
by have [_] := L2 i li; rewrite P.
Qed.

Lemma closed_before : before_t4 ec s -> before_t4 eo s /\ no_border.
Proof.
move=> H; have R := H R1 isT; have none := closed_no_border R; split=> //.
case=> // _.
- have [Hh Hv Hb Hf S] := R; split=> // h lh; have [O [T|//] N P F] := Hh h lh; split=> // [|hf]; [by left|].
  by case: (F hf) => [|[]]; [left|].
- by move=> h lh _; apply: (H L1 isT h lh).
- exact: (H L2 isT).
- by move=> h lh _; apply: (H L3 isT h lh).
- exact: (H V1 isT).
- exact: closed_open_v2 R (H L1 isT) (H L2 isT) (H V2 isT).
- exact: (H B1 isT).
- exact: (H B2 isT).
- exact: (H F1 isT).
- exact: (H F2 isT).
- exact/(same_closed_t1 none)/(H T1 isT).
- exact/(same_closed_t2 none)/(H T2 isT).
exact/(same_closed_t3 none)/(H T3 isT).
Qed.

Lemma closed_rules : rules_of ec s <-> rules_of eo s /\ no_border.
Proof.
split=> [H|[H none]].
  have [B none] := closed_before (rules_before_t4 H); split=> //.
  case=> [r|[] //]; case: (ltnP (index r) (index T4)) => [/B //|]; case: r => // _.
  exact/(same_closed_t4 none)/(H (Basic T4)).
have keeps := links_open (fun r _ => H (Basic r)).
case=> [[]|[] //] //.
- have [Hh Hv Hb Hf S] := H (Basic R1); split=> // h lh; have [O T N P F] := Hh h lh; have [nt nf] := none h lh; split=> // [|hf].
    case: T => [|B]; first by left.
    by rewrite (not_on_border none lh) in B.
  case: (F hf) => [|[_ _ E]]; first by left.
  by move: nf; rewrite /lacks_face hf E.
- by move=> h lh _; apply: (H (Basic L1) h lh); rewrite (not_on_border none lh).
- exact: (H (Basic L2)).
- by move=> h lh _; apply: (H (Basic L3) h lh); rewrite (not_on_border none lh).
- exact: (H (Basic V1)).
- exact: same_closed_v2 none keeps.
- exact: (H (Basic B1)).
- exact: (H (Basic B2)).
- exact: (H (Basic F1)).
- exact: (H (Basic F2)).
- exact/(same_closed_t1 none)/(H (Basic T1)).
- exact/(same_closed_t2 none)/(H (Basic T2)).
- exact/(same_closed_t3 none)/(H (Basic T3)).
exact/(same_closed_t4 none)/(H (Basic T4)).
Qed.

End Closed.

(** If no half-edge lacks a twin, no cycle is missing. *)
Lemma open_map_closed t : is_open_map true t /\ (forall h, half_edge t h -> twin t h <> None) <-> is_plane t.
Proof.
split=> [[[r [missing [[may [nv [nd rep]]] d]]] twins]|[r [[nv [nd rep]] d]]].
  have none x : missing x = false.
    apply/negbTE/negP=> mx; have mo := apart_at_edges may mx; have [_ T _ _] := says_of_there rep mo.
    by apply: (twins (nd (opposite x)) (there rep mo)); rewrite T opposite_back mx.
  exists r; split; last exact: d; exists nv, nd; split; first exact: points_there rep.
  - split=> [x y|h]; first by apply: (arcs_differ rep); rewrite none.
    by rewrite (arcs_there rep); split=> [[x _ xh]|[x xh]]; exists x; rewrite ?none.
  - by move=> x; have [O T N P] := says_of_there rep (negbT (none x)); rewrite none in T; split.
  move=> v; case: (says_of_point_there rep v) => [[x _ [L E]]|]; [by left; exists x|by right].
split; last by move=> h /(arc_of rep)[x <-]; rewrite (twin_nd rep).
exists r, pred0; split=> //; split; first by split.
exists nv, nd; split=> //.
- exact: points_numbered rep.
- by move=> x y _ _; apply: (nd_inj rep).
- by move=> h; split=> [/(arc_of rep)[x xh]|[x _ <-]]; [exists x | apply: nd_live rep x].
- by move=> x _; exact: (says_of_arc rep x).
by move=> v; case: (says_of_point rep v) => [[x L E]|]; [left; exists x|right].
Qed.

(** ** The closed plane with lists of inner boundary components *)

Theorem holes_named t places unbounded sf so si :
  let s := Structure t (Parts true true true false places true unbounded) sf so si in
  rules_of plane s <-> [/\ is_plane t, faces_nested plane s & forall h, half_edge t h -> face_of plane s h <> None].
Proof.
move=> s; have C := closed_rules t true true false places true unbounded sf so si; have M := open_map_closed t.
have lacks h : ~~ lacks_face (open_on true) s h <-> face_of plane s h <> None.
  by rewrite /lacks_face /= -[side _ s h]/(face_of plane s h); case: (face_of plane s h).
split=> [/C[/open_holes_named[m n] none]|[/M[m twins] n faces]].
  by split=> // [|h /none[_ /lacks]] //; apply/M; split=> // h /none[].
apply/C; split; first by apply/open_holes_named.
by move=> h lh; split; [apply: twins | apply/lacks; apply: faces].
Qed.

Theorem holes_recorded t places unbounded sf so si :
  let s := Structure t (Parts true true true true places true unbounded) sf so si in
  rules_of plane s <->
  [/\ is_plane t, faces_nested plane s, nested_records t places & forall h, half_edge t h -> boundary_of t h <> None].
Proof.
move=> s; have C := closed_rules t true true true places true unbounded sf so si; have M := open_map_closed t.
have lacks h : ~~ lacks_face (open_on true) s h <-> boundary_of t h <> None.
  by rewrite /lacks_face /= -[side _ s h]/(boundary_of t h); case: (boundary_of t h).
split=> [/C[/open_holes_recorded[m n r] none]|[/M[m twins] n r faces]].
  by split=> // [|h /none[_ /lacks]] //; apply/M; split=> // h /none[].
apply/C; split; first by apply/open_holes_recorded.
by move=> h lh; split; [apply: twins | apply/lacks; apply: faces].
Qed.

(** The same where `prev`, half-edges kept by vertices, or places are not stored. *)

Theorem filled_holes_named v pr le pl un sf so si :
  let s := Structure v (Parts pr le true false pl true un) sf so si in let u := filled plane s in
  rules_of plane s <->
  [/\ is_plane (answers u), faces_nested plane u & forall h, half_edge (answers u) h -> face_of plane u h <> None].
Proof.
move=> s u; rewrite (filled_rules s (isT : ~~ border_kept plane)) /u /s {u s}.
by case: pr; case: le; case: pl; apply: holes_named.
Qed.

Theorem filled_holes_recorded v pr le pl un sf so si :
  let s := Structure v (Parts pr le true true pl true un) sf so si in let u := filled plane s in
  rules_of plane s <-> [/\ is_plane (answers u), faces_nested plane u, nested_records (answers u) true
    & forall h, half_edge (answers u) h -> boundary_of (answers u) h <> None].
Proof.
move=> s u; rewrite (filled_rules s (isT : ~~ border_kept plane)) /u /s {u s}.
by case: pr; case: le; case: pl; apply: holes_recorded.
Qed.

(** With every part stored, such nested faces are the planar subdivisions of Subdivision.v. *)
Theorem nested_means_subdivision t sf so si : let s := Structure t all_parts sf so si in
  [/\ is_plane t, faces_nested plane s, nested_records t true & forall h, half_edge t h -> boundary_of t h <> None] <->
  exists u, represents t u.
Proof. by move=> s; rewrite -rules_mean_subdivision -(plane_rules t sf so si) (holes_recorded t true true sf so si). Qed.

(** The rules of meshes are asked for besides: the others do not depend on them. *)
Definition unasked e := if is_open e then open_on (on_plane e) else closed_on (on_plane e).

Theorem mesh_rules_apart e s : rules_of e s <-> rules_of (unasked e) s /\ forall m, holds_of e s (Mesh m).
Proof.
case: e => on [] m1 m2 m3 m4 m5 m6 m7 m8; rewrite /unasked /=; set e := Expectation _ _ _ _ _ _ _ _ _ _.
  have same r : holds_of e s (Basic r) = holds_of (open_on on) s (Basic r) by case: r.
  by split=> [H|[H M]]; [split=> [|m]; [by case=> [r|[] //]; rewrite -same; exact: (H (Basic r))|exact: (H (Mesh m))]
    |case=> [r|m]; [rewrite same; exact: (H (Basic r))|exact: M]].
have same r : holds_of e s (Basic r) = holds_of (closed_on on) s (Basic r) by case: r.
by split=> [H|[H M]]; [split=> [|m]; [by case=> [r|[] //]; rewrite -same; exact: (H (Basic r))|exact: (H (Mesh m))]
    |case=> [r|m]; [rewrite same; exact: (H (Basic r))|exact: M]].
Qed.
