(** * Reach: every planar subdivision is made by some program

    By induction on the number of vertices and half-edges: each table that keeps all rules has something that an operator removes,
    unless it is one face and nothing else, and another operator puts it back. If there is no edge, that is an isolated vertex.
    An edge that is no loop is contracted. A loop has two sides, and is removed.

<<
      nothing ──add──► · ──split vertex──► ·────· ──connect──► …  any planar subdivision
>>
*)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import Arith View Rules Reference Map Counting Lists Subdivision Verdict Table NewEdge Core Tidy Collapse Renaming.
From twinedge Require Import ConnectCorners NewFace ConnectSplit ConnectLoop AddVertex RemoveVertex ConnectIsolated RemoveEdge RemoveMerge RemovePart Skip Contract SplitVertex.
From twinedge Require Import Connect Programs Same Undo UndoMerge.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** One face, and nothing else. *)
Definition nothing := view_of {|
  vertex_rows := [::]; half_edge_rows := [::]; boundary_rows := [::]; face_rows := [:: Some (FaceRow None [::])] |}.

(** ** A loop has different boundary components on both sides *)

Lemma relist_connected n inn u w : connected n u w -> connected (relist n inn) u w.
Proof. by elim=> [|i x y _ IH X Y]; [apply: connected_self|apply: (@connected_edge (relist n inn) u i x y)]. Qed.

Lemma loop_sides t n m u b : rules t -> twin t n = Some m -> origin t n = Some u -> origin t m = Some u ->
  boundary_of t n = Some b -> boundary_of t m <> Some b.
Proof.
move=> keeps T On Om Bn Bm; have c := core_of_rules keeps; pose made := boundary_slots t.
have free : ~~ boundary t made by rewrite /boundary ltnn.
have lb : boundary t b by have [_ _ _ _ [d + ld]] := links_of keeps (heard_live T); rewrite Bn => -[->].
have lu : vertex t u by have [[x + lx] _ _ _ _] := links_of keeps (heard_live T); rewrite On => -[->].
have [f F _] := core_face c lb; have [bo [wo [lbo Io Po Co]]] := core_inside c lu.
(* Without it, the component would have two insides. *)
pose p := parted t n m f b made b made; pose inn' := parted_inn t b made b.
have parts : b = b /\ made = made \/ b = made /\ made = b by left.
have st : b = b \/ b = made by left.
have sn : n = n \/ n = m by left.
have at_n : at_end n b made n = b by rewrite /at_end eqxx.
have vE x : vertex_of n u u x = u by rewrite /vertex_of; case: ifP.
have connected_p x w : connected t x w -> connected p x w.
  by case/(connected_cut keeps T (parted_out t n m f b made b made) On Om)=> [//|[C D]|[C D]]; apply: connected_trans C D.
have out : ~~ inn_of t b -> [/\ inn_of t bo, passes t bo wo & connected p (vertex_of n u u n) wo].
  by move=> _; split; rewrite ?vE //; apply: connected_p.
have keeps' : rules (relist p inn') := part_rules keeps T Bn Bm free parts st F On Om sn at_n out.
have mn : (m == n) = false by apply/eqP/nesym/(n_not_m keeps T).
have at_m : at_end n b made m = made by rewrite /at_end mn.
have P x : x = n \/ x = m -> passes p (at_end n b made x) u.
  by move=> xe; have := passes_end f made b made keeps T Bn Bm On Om xe; rewrite vE.
have live d : (d == made) || boundary t d -> boundary (relist p inn') d.
  by move=> ld; rewrite -[boundary (relist p inn') d]/(boundary p d) RemovePart.boundaryE.
have bm : b <> made by move=> E; move: free; rewrite -E lb.
have inn_made : inn' made by rewrite /inn' /parted_inn eqxx orbT eq_sym (introF eqP bm) orbT.
have lm : boundary (relist p inn') made by apply: live; rewrite eqxx.
have Im : inn_of (relist p inn') made by rewrite relist_inn.
have Pm : passes (relist p inn') made u by rewrite -at_m; apply: (P m); right.
case: (boolP (inn_of t b)) => [I|no].
  have lb' : boundary (relist p inn') b by apply: live; rewrite lb orbT.
  apply: (bm); apply: (one_inner keeps' _ Im _ Pm (connected_self _ u) lb' lm).
    by rewrite relist_inn // /inn' /parted_inn eqxx I.
  by rewrite -at_n; apply: (P n); left.
have bob : bo <> b by move=> E; move: no; rewrite -E Io.
have bom : bo <> made by move=> E; move: free; rewrite -E lbo.
apply: (bom); have lbo' : boundary (relist p inn') bo by apply: live; rewrite lbo orbT.
apply: (one_inner keeps' _ Im _ Pm _ lbo' lm).
- by rewrite relist_inn // /inn' /parted_inn (introF eqP bob) (introF eqP bom).
- exact: (passes_up f made b made keeps T Bn Bm Po bob).
apply/relist_connected; apply: connected_back (connected_p _ _ Co).
exact: (out_l1 keeps T (parted_out t n m f b made b made)).
Qed.

(** ** One face, and nothing else, is made of nothing *)

Lemma nothing_renames t : rules t -> (forall u, ~~ vertex t u) -> program nothing t.
Proof.
move=> keeps no_vertex; have c := core_of_rules keeps; have low : lower t by move=> q _; apply: keeps.
have no_half_edge i : ~~ half_edge t i.
  by apply/negP=> /(links_of keeps)[[u _ lu] _ _ _ _]; move: (no_vertex u); rewrite lu.
have no_boundary b : ~~ boundary t b.
  apply/negP=> /(core_used c)[u [[i _ O]|I]]; last by move: (no_vertex u); rewrite (heard_live I).
  by move: (no_half_edge i); rewrite (heard_live O).
have [f [[lf no] one]] := core_unbounded c.
have only x : face t x -> f = x by move=> lx; apply: one; split=> // b F; move: (no_boundary b); rewrite (heard_live F).
have none (r : nat -> nat) (live live' : nat -> bool) : (forall i, ~~ live i) -> (forall i, ~~ live' i) -> renumbers r live live'.
  move=> H H'; split=> [i j l|j]; first by move: (H i); rewrite l.
  by split=> [l|[i l]]; [move: (H' j); rewrite l|move: (H i); rewrite l].
have face0 x : face nothing x -> x = 0 by case: x.
apply: program_step (program_nothing nothing) _.
apply: (@step_rename nothing t id id id (fun=> f) (fun _ i => i)).
have [_ _ _ /(_ f lf)[_ inner_live]] := low_r1 low.
have count0 : inner_count t f = 0.
  by case E: (inner_count t f) => [|k] //; have [|b _ lb] := inner_live 0; [rewrite E|move: (no_boundary b); rewrite lb].
have outer0 : outer t f = None.
  by case O: (outer t f) => [b|] //; have [_ _ _ /(_ f lf)[[E|[d E ld]] _]] := low_r1 low; [rewrite O in E|move: (no_boundary d); rewrite ld].
split=> //.
- by apply: none => // i; rewrite /vertex.
- by apply: none => // i; rewrite /half_edge.
- by apply: none => // i; rewrite /boundary.
- split=> [i j /face0-> /face0-> //|x]; split=> [/only <-|[i _ <-]] //; by exists 0.
- by move=> x /face0 ->; rewrite outer0 count0.
- by move=> x i /face0 ->.
by move=> x i /face0 ->.
Qed.

(** ** Every planar subdivision *)

(** The boundary components of an edge with different ones: one of them is the outer one of a face. *)
Lemma seam t n m bn bm un um : rules t -> twin t n = Some m -> origin t n = Some un -> origin t m = Some um ->
  boundary_of t n = Some bn -> boundary_of t m = Some bm -> bn <> bm ->
  exists f g bf bg, [/\ bf = bn /\ bg = bm \/ bf = bm /\ bg = bn, boundary_face t bf = Some f, boundary_face t bg = Some g & ~~ inn_of t bg].
Proof.
move=> keeps T On Om Bn Bm bb; have c := core_of_rules keeps.
have live i d : boundary_of t i = Some d -> boundary t d.
  by move=> B; have [_ _ _ _ [e + le]] := links_of keeps (heard_live B); rewrite B => -[->].
have [f F _] := core_face c (live n bn Bn); have [g G _] := core_face c (live m bm Bm).
case: (boolP (inn_of t bm)) => [Im|om]; last by exists f, g, bn, bm; split; auto.
case: (boolP (inn_of t bn)) => [In|on]; last by exists g, f, bm, bn; split; auto.
have Pn : passes t bn un by left; exists n.
have Pm : passes t bm um by left; exists m.
case: bb; apply: (one_inner keeps In Im Pn Pm _ (live n bn Bn) (live m bm Bm)).
by apply: (connected_edge (connected_self _ _) On); rewrite /target T.
Qed.

Section Reach.
Variables (t : view) (vs hs : seq nat) (k : nat).
Hypothesis keeps : rules t.
Hypothesis vertices : lists vs (vertex t).
Hypothesis half_edges : lists hs (half_edge t).
Hypothesis size_k : size vs + size hs <= k.+1.
Hypothesis smaller : forall t1 vs1 hs1, rules t1 -> lists vs1 (vertex t1) -> lists hs1 (half_edge t1) -> size vs1 + size hs1 <= k ->
  program nothing t1.

(** A step from something smaller is enough. *)
Lemma reach_by t1 t2 vs1 hs1 : rules t1 -> lists vs1 (vertex t1) -> lists hs1 (half_edge t1) -> size vs1 + size hs1 <= k ->
  (rules t1 -> step t1 t2) -> same_core t2 t -> program nothing t.
Proof.
move=> keeps1 V1 H1 le st same; have st' := st keeps1.
apply: (same_core_program (step_keeps_rules st' keeps1) keeps same).
exact: program_step (smaller keeps1 V1 H1 le) st'.
Qed.

Lemma reach_vertex v b : isolated t v = Some b -> program nothing t.
Proof.
move=> I; have c := core_of_rules keeps; have [B _ _] := core_isolated c I.
have lb : boundary t b by have [d + ld] := core_bare c (heard_live I) B; rewrite I => -[->].
have [f F lf] := core_face c lb; have lv := heard_live I.
apply: (@reach_by (remove_isolated_vertex t v b) _ (rem v vs) hs _ _ half_edges _ _ (undo_remove keeps I F)).
- exact: remove_isolated_vertex_keeps_rules.
- apply: lists_iff (lists_rem v vertices) => u.
  rewrite -[vertex (remove_isolated_vertex t v b) u]/(vertex (without t v b) u) RemoveVertex.vertexE.
  by split=> [[/eqP->]|/andP[/eqP]].
- have sv : size vs = (@size nat (rem v vs)).+1 := size_lists_rem vertices lv.
  by move: size_k; rewrite sv; arith.
move=> _; apply: step_add => //; first exact: Connect.removed_free.
by rewrite /boundary /= eqxx andbF.
Qed.

Lemma half_edges_rem n m t1 : twin t n = Some m -> (forall i, half_edge t1 i = [&& i != n, i != m & half_edge t i]) ->
  lists (rem m (rem n hs)) (half_edge t1) /\ size hs = (@size nat (rem m (rem n hs))).+2.
Proof.
move=> T E; have live_m := heard_live (twin_of keeps T); have mn := nesym (n_not_m keeps T); split.
  apply: lists_iff (lists_rem m (lists_rem n half_edges)) => i; rewrite E.
  by split=> [[/eqP-> [/eqP-> ->]]|/and3P[/eqP i_n /eqP im li]].
by rewrite (size_lists_rem half_edges (heard_live T)) (size_lists_rem (lists_rem n half_edges) (conj mn live_m)).
Qed.

Lemma reach_contract n m un um : twin t n = Some m -> origin t n = Some un -> origin t m = Some um -> un <> um ->
  alone t n m \/ next t m <> Some n -> program nothing t.
Proof.
move=> T On Om uu al; pose t1 := contract_edge t n m un um.
have keeps1 : rules t1 by apply: contract_edge_keeps_rules => //; rewrite /is_contractible T On Om !eqxx /= andbT; apply/eqP.
have [H sizes] := half_edges_rem T (Skip.half_edgeE t n m un um).
have lum : vertex t um by have [[x + lx] _ _ _ _] := links_of keeps (heard_live (twin_of keeps T)); rewrite Om => -[->].
have V : lists (rem um vs) (vertex t1).
  apply: lists_iff (lists_rem um vertices) => u; rewrite Skip.vertexE.
  by split=> [[/eqP->]|/andP[/eqP]].
have le : @size nat (rem um vs) + @size nat (rem m (rem n hs)) <= k.
  have sv : size vs = (@size nat (rem um vs)).+1 := size_lists_rem vertices lum.
  by move: size_k; rewrite sv sizes; arith.
have [fv fn fm nm] := contracted_free un um keeps T.
case: al => [al|M].
  have [_ _ _ _ [bn B _]] := links_of keeps (heard_live T).
  have [I same] := undo_contract_alone keeps T On Om uu B al.
  by apply: (reach_by keeps1 V H le _ same) => _; apply: step_attach I fv _.
apply: (reach_by keeps1 V H le _ (undo_contract keeps T On Om uu M)) => _.
exact/step_split_vertex/undo_splittable.
Qed.

Lemma reach_merge n m u bn bm : twin t n = Some m -> origin t n = Some u -> origin t m = Some u ->
  boundary_of t n = Some bn -> boundary_of t m = Some bm -> bn <> bm ->
  next t n = Some n /\ next t m = Some m \/ next t n <> Some n -> program nothing t.
Proof.
move=> T On Om Bn Bm bb alone; have [f [g [bf [bg [faces F G og]]]]] := seam keeps T On Om Bn Bm bb.
pose t1 := merge_faces t n m f g bn bm; have keeps1 : rules t1 := merged_keeps keeps T Bn Bm bb faces F G og.
have [H sizes] : lists (rem m (rem n hs)) (half_edge t1) /\ size hs = (@size nat (rem m (rem n hs))).+2.
  by apply: half_edges_rem T _ => i; apply: RemoveEdge.half_edgeE (merged_out t n m f g bn bm) i.
have V : lists vs (vertex t1) by apply: lists_iff vertices => u'.
have le : size vs + @size nat (rem m (rem n hs)) <= k by move: size_k; rewrite sizes; arith.
have [fn fm nm fb fg] := free_slots f g bn bm keeps T; have kf := kept_face n m bb faces F G.
case: alone => [[N M]|N].
  have [I same] := undo_merge_alone keeps T Bn Bm bb faces F G og On Om N M.
  by apply: (reach_by keeps1 V H le _ same) => _; apply: step_loop.
have [Ba Bb] := corners_kept f g keeps T Bn Bm bb N.
apply: (reach_by keeps1 V H le _ (undo_merge keeps T Bn Bm bb faces F G og On Om N)) => _.
exact: step_split_face.
Qed.

Lemma reach_step : program nothing t.
Proof.
have c := core_of_rules keeps; have [uv inv] := vertices; have [uh inh] := half_edges.
case E: hs => [|n s].
  have bare_all u : bare t u by move=> i /inh; rewrite E.
  case W: vs => [|v r]; first by apply: nothing_renames => // u; apply/negP=> /inv; rewrite W.
  have lv : vertex t v by apply/inv; rewrite W mem_head.
  by have [b I _] := core_bare c lv (bare_all v); apply: reach_vertex I.
have ln : half_edge t n by apply/inh; rewrite E mem_head.
have [[un On _] [m T lm] _ _ [bn Bn _]] := links_of keeps ln; have [[um Om _] _ _ _ [bm Bm _]] := links_of keeps lm.
have T' := twin_of keeps T; case: (un =P um) => [uu|uu].
  rewrite -uu in Om; have bb : bn <> bm by move=> E'; case: (loop_sides keeps T On Om Bn); rewrite E'.
  case: (next t n =P Some n) => [N|N]; last by apply: (reach_merge T On Om Bn Bm bb); right.
  case: (next t m =P Some m) => [M|M]; first by apply: (reach_merge T On Om Bn Bm bb); left.
  by apply: (reach_merge T' Om On Bm Bn (nesym bb)); right.
case: (next t m =P Some n) => [M|M]; last by apply: (reach_contract T On Om uu); right.
case: (next t n =P Some m) => [N|N]; last by apply: (reach_contract T' Om On (nesym uu)); right.
by apply: (reach_contract T On Om uu); left; rewrite /alone N M !eqxx.
Qed.

End Reach.

(** Every view that keeps all rules is made of nothing. *)
Theorem rules_are_made t : rules t -> program nothing t.
Proof.
have H := lists_filter (@vertex_below t) (fun u => iff_refl (vertex t u)).
have G := lists_filter (@half_edge_below t) (fun u => iff_refl (half_edge t u)).
move: H G; set vs := [seq _ <- _ | _]; set hs := [seq _ <- _ | _]; move: vs hs => vs hs.
have [k] := ubnP (size vs + size hs); elim: k t vs hs => // k IH t vs hs; rewrite ltnS => le H G keeps.
case: k IH le => [|k] IH le.
  apply: nothing_renames => // u; apply/negP=> /(proj2 H u); move: le; rewrite leqn0 addn_eq0 => /andP[/eqP/size0nil-> _].
  by [].
by apply: (reach_step keeps H G le) => t1 vs1 hs1 keeps1 H1 G1 le1; apply: (IH t1 vs1 hs1).
Qed.

(** So what programs make of nothing is the planar subdivisions: all, and no other. *)
Theorem programs_make_subdivisions t : program nothing t <-> exists s, represents t s.
Proof.
split=> [p|/rules_mean_subdivision/rules_are_made //].
apply: (program_makes_subdivision p); apply/rules_mean_subdivision/first_broken_none; by vm_compute.
Qed.
