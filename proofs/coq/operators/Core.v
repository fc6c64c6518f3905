(** * Core: what a table cannot do without, and the rest, which follows

    An operator decides what is live, the origin, twin and next of each half-edge, the boundary component on each side, the
    face of each boundary component, and which of these are inner ones: that is the *core* of a table. The rest says the same
    once more, so that it can be found fast: [prev], the half-edges that vertices and boundary components keep, the places
    and the lists. If the core is right, and the rest says the same, all rules hold. Tidy.v makes the rest anew.

<<
      core     origin, twin, next, boundary_of; isolated; boundary_face, inner or outer
      rest     prev; leaving; boundary_start; boundary_place; outer, inner lists
>>

    So whoever proves that an operator keeps the rules has to look at the core only, and may have the rest made anew:
    [core_rules], [core_of_rules], and [tidy_rules] of Tidy.v. *)

From mathcomp Require Import all_ssreflect all_fingroup.
From twinedge Require Import Arith View Rules Loops LoopsProof Map Counting Lists TopologyProof.
From twinedge Require Import Drawing Euler Numbered Genus WholeEuler Verdict FastPathComponents NewEdge ConnectCorners.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** The same edges, counted by their half-edges. *)
Lemma edges_twice t es hs : is_map t -> lists_one_of_each es (same_edge t) (half_edge t) -> lists hs (half_edge t) -> size hs = (size es).*2.
Proof.
move=> map [u live one all] [uh H]; pose tw i := odflt 0 (twin t i).
have twE i : half_edge t i -> twin t i = Some (tw i) /\ half_edge t (tw i).
  by move=> /(twin_total map)[g G lg]; rewrite /tw G.
have twK i : half_edge t i -> tw (tw i) = i /\ tw i <> i.
  move=> li; have [E _] := twE i li; have [_ l1 _ _] := map; have [+ n] := l1 i li; rewrite E /= => T.
  by split; [rewrite /tw T|move=> F; apply: n; rewrite E F].
have -> : size hs = size (es ++ [seq tw i | i <- es]); last by rewrite size_cat size_map addnn.
apply: perm_size; apply: uniq_perm => //.
  rewrite cat_uniq u /= map_inj_in_uniq => [|i j /live li /live lj E].
    rewrite u andbT; apply/hasPn=> j /mapP[i ei ->]; apply/negP=> ej; have li := live i ei.
    have [E n] := twK i li; apply: n; apply: one => //; right; have [-> _] := twE _ (live _ ej).
    by rewrite E.
  by have [<- _] := twK i li; have [<- _] := twK j lj; rewrite E.
move=> i; rewrite mem_cat; apply/idP/orP => [/H li|[/live/H|/mapP[j /live lj ->]]] //; last first.
  by apply/H; have [] := twE j lj.
have [j ej [<-|T]] := all i li; [by left|right].
by apply/mapP; exists j => //; rewrite /tw T.
Qed.

(** ** The core *)

Section Core.
Variables (t : view) (inn : pred nat).

(** The boundary component [b] passes the vertex [v], or is the isolated vertex [v]. *)
Definition passes b v := (exists2 h, boundary_of t h = Some b & origin t h = Some v) \/ isolated t v = Some b.

(** No outer boundary component is of the face [f]. *)
Definition no_outer f := forall b, boundary_face t b = Some f -> inn b.

(** From the face one steps out to the unbounded one: [rooted], of the core. *)
Inductive steps_out f : Prop :=
  | out_here of face t f & no_outer f
  | out_through b v c w g of boundary_face t b = Some f & ~~ inn b & passes b v & inn c & passes c w & connected t v w
      & boundary_face t c = Some g & steps_out g.

(** Vertices, faces, inner boundary components and edges: V + F = 1 + I + E. *)
Definition core_count := exists vs hs fs bs,
  [/\ lists vs (vertex t), lists hs (half_edge t), lists fs (face t), lists bs (fun b => boundary t b /\ inn b)
    & (size vs + size fs).*2 = 2 + (size bs).*2 + size hs].

Record core : Prop := Core {
  core_live : forall h, half_edge t h -> [/\ leads_to (vertex t) (origin t h), leads_to (half_edge t) (twin t h),
    leads_to (half_edge t) (next t h) & leads_to (boundary t) (boundary_of t h)];
  core_twin : l1_twin t;
  core_next : forall g h, half_edge t g -> half_edge t h -> next t g = next t h -> g = h;
  core_target : l3_target t;
  core_rotation : forall g h, half_edge t g -> half_edge t h -> origin t g = origin t h -> on_orbit (turn t) g h;
  core_side : forall h, half_edge t h -> next t h >>= boundary_of t = boundary_of t h;
  core_cycle : forall g h, half_edge t g -> half_edge t h -> boundary_of t g = boundary_of t h -> on_cycle t g h;
  core_bare : forall v, vertex t v -> bare t v -> leads_to (boundary t) (isolated t v);
  core_isolated : forall v b, isolated t v = Some b -> [/\ bare t v, inn b & forall h, boundary_of t h <> Some b];
  core_one : forall v w b, isolated t v = Some b -> isolated t w = Some b -> v = w;
  core_used : forall b, boundary t b -> exists v, passes b v;
  core_face : forall b, boundary t b -> leads_to (face t) (boundary_face t b);
  core_outer : forall b c, ~~ inn b -> ~~ inn c -> boundary_face t b = boundary_face t c -> boundary t b -> b = c;
  core_unbounded : exists! f, face t f /\ no_outer f;
  core_inside : forall v, vertex t v -> exists b w, [/\ boundary t b, inn b, passes b w & connected t v w];
  core_out : forall f, face t f -> steps_out f;
  core_counts : core_count
}.

(** ** The rest *)

Record rest : Prop := Rest {
  rest_prev : forall h, half_edge t h -> leads_to (half_edge t) (prev t h) /\ prev t h >>= next t = Some h;
  rest_leaving : forall v, vertex t v ->
    (exists2 h, leaving t v = Some h & origin t h = Some v) \/ leaving t v = None /\ bare t v;
  rest_start : forall b, boundary t b ->
    (exists2 h, boundary_start t b = Some (AtHalfEdge h) & boundary_of t h = Some b) \/
    exists2 v, boundary_start t b = Some (AtVertex v) & isolated t v = Some b;
  rest_place : forall b, boundary t b -> exists f p, [/\ boundary_face t b = Some f, boundary_place t b = Some p,
    listed t f p = Some b & inn b <-> p <> Outer];
  rest_listed : forall f p b, listed t f p = Some b -> boundary_face t b = Some f /\ boundary_place t b = Some p;
  rest_lists : forall f i, i < inner_count t f -> inner t f i <> None
}.

Hypothesis c : core.
Hypothesis r : rest.

Lemma core_links : links_live t.
Proof.
split.
- move=> h lh; have [O T N B] := core_live c lh; split=> //; by have [] := rest_prev r lh.
- move=> v lv; split.
    case: (rest_leaving r lv) => [[h L O]|]; [left|by right].
    by exists h; rewrite ?(heard_live O).
  case I: (isolated t v) => [b|]; [right|by left]; have [B _ _] := core_isolated c I.
  by rewrite -I; apply: core_bare.
- move=> b lb; split; first exact: core_face.
  by case: (rest_start r lb) => [[h -> B]|[v -> I]] /=; [apply: heard_live B|apply: heard_live I].
move=> f lf; split=> [|i lt].
  case O: (outer t f) => [b|]; [right|by left]; exists b => //.
  by have [E _] := @rest_listed r f Outer b O; apply: heard_live E.
case I: (inner t f i) => [b|]; last by case: (rest_lists r lt).
by exists b => //; have [E _] := @rest_listed r f (Inner i) b I; apply: heard_live E.
Qed.

Lemma next_prev_core : l2_next_prev t.
Proof.
move=> h lh; have [_ P] := rest_prev r lh; split=> //.
have [_ _ [g N lg] _] := core_live c lh; rewrite N /=; have [[g' P' lg'] Q] := rest_prev r lg.
by rewrite P'; congr Some; apply: (core_next c) => //; move: Q; rewrite P' N.
Qed.

Lemma placed b : boundary t b -> inn b <-> is_inner t b.
Proof.
move=> lb; have [f [p [_ P _ I]]] := rest_place r lb; rewrite I /is_inner P.
by case: p {P I} => [|i]; split=> //; [case|exists i].
Qed.

Lemma outer_core f b : outer t f = Some b <-> boundary_face t b = Some f /\ ~~ inn b.
Proof.
split=> [O|[F I]].
  have [F P] := @rest_listed r f Outer b O; split=> //; apply/negP=> /(placed (heard_live F))[i].
  by rewrite P.
have [g [p [F' _ L PI]]] := rest_place r (heard_live F); move: F' L; rewrite F => -[<-].
by case: p PI => [//|i] PI; case/negP: I; apply/PI.
Qed.

Lemma unbounded_core f : unbounded t f <-> face t f /\ no_outer f.
Proof.
split=> -[lf H]; split=> //.
  move=> b F; apply/negPn/negP=> I; have/outer_core : boundary_face t b = Some f /\ ~~ inn b by [].
  by rewrite H.
by case O: (outer t f) => [b|] //; have [F] := (outer_core f b).1 O; rewrite H.
Qed.

Lemma core_low : lower t.
Proof.
have l3 := core_target c; have l1 := core_twin c; have links := core_links.
have f2 : f2_listed t.
  apply: f2_if => [b lb|f p b]; last exact: rest_listed.
  by have [f [p [F P L _]]] := rest_place r lb; exists f, p.
case=> // _.
- by split=> //; apply: lists_short_listed.
- exact: next_prev_core.
- move=> v h lv L; case: (rest_leaving r lv) => [[g]|[]]; rewrite L //.
  by case=> <-.
- move=> g h lg lh; split=> [/(on_rotation_origin l1 l3) -> //|]; exact: core_rotation.
- split=> [|b h lb lh]; first exact: core_side.
  case: (rest_start r lb) => [[g S Bg]|[v S I]].
    split=> [B|[g' + C]]; first by exists g => //; apply: core_cycle; rewrite ?(heard_live Bg) // B.
    by rewrite S => -[gg]; rewrite -gg in C; rewrite (constant_on_cycle (core_side c) C).
  by split=> [B|[g']]; [have [_ _ /(_ h)] := core_isolated c I|rewrite S].
- have at_v v b : starts_at_vertex t v b <-> isolated t v = Some b.
    split=> [S|I].
      have lb := heard_live S; move: S; rewrite /starts_at_vertex.
      by case: (rest_start r lb) => [[g -> _ //]|[w -> I] [<-]].
    have [B _ no] := core_isolated c I; have [b' Ib lb] := core_bare c (heard_live I) B.
    move: Ib; rewrite I => -[bb]; rewrite -bb in lb.
    case: (rest_start r lb) => [[g _ /no //]|[w S J]]; by rewrite /starts_at_vertex S (core_one c I J).
  move=> v lv; split=> [B|nB].
    have [b I _] := core_bare c lv B; exists b; split=> // d; split=> [/at_v|->]; last exact/at_v.
    by rewrite I => -[].
  case I: (isolated t v) => [b|]; first by have [/nB] := core_isolated c I.
  by split=> // b /at_v; rewrite I.
split=> [|f b v /outer_core[F I] S].
  have [f [U one]] := core_unbounded c; exists f; split; first exact/unbounded_core.
  by move=> g /unbounded_core; apply: one.
have : isolated t v = Some b.
  move: S; rewrite /starts_at_vertex; case: (rest_start r (heard_live F)) => [[g -> _ //]|[w -> J] [<-]] //.
by move/(core_isolated c)=> [_ Ib _]; rewrite Ib in I.
Qed.

Let low := core_low.
Let map := low_map low.
Let sym := connected_sym map.
Let trans := @connected_trans t.

Lemma passes_at b v : boundary t b -> passes b v -> exists2 w, vertex_at t b = Some w & connected t w v.
Proof.
move=> lb [[h B O]|I]; first by have [_] := on_side low B O.
have [_ _ no] := core_isolated c I; exists v; last exact: connected_self.
rewrite /vertex_at; case: (rest_start r lb) => [[g _ /no //]|[w -> J]]; by rewrite (core_one c I J).
Qed.

Lemma passes_outside u v b : boundary t b -> inn b -> passes b v -> connected t u v -> outside_of t u b.
Proof.
move=> lb I P C; split; first exact/placed.
by have [w W D] := passes_at lb P; exists w => //; apply: trans C (sym D).
Qed.

Lemma inner_lists (bs : seq nat) : lists bs (fun b => boundary t b /\ inn b) -> lists bs (is_inner t).
Proof.
apply: lists_iff => b; split=> [[lb]|I]; first by move/(placed lb).
have lb : boundary t b by case: I => i P; apply: heard_live P.
by split=> //; apply/placed.
Qed.

Lemma core_t1 : t1_outside t.
Proof.
have [es He] := edges_each low; have [vs [hs [fs [bs [Hv Hh Hf Hb eq]]]]] := core_counts c.
have two := edges_twice map He Hh; have Hi := inner_lists Hb.
have out v : vertex t v -> exists b, outside_of t v b.
  by move=> lv; have [b [w [lb I P C]]] := core_inside c lv; exists b; apply: passes_outside P C.
have [cs Hc] : exists cs, lists_one_of_each cs (connected t) (vertex t).
  exact: (components_exist low).
have [edges every] := every_edge_exists (twK map) (tw_neq map).
have whole := whole_euler low every (rotations_each low) (cycles_each low) He (pieces_each low).
have Vs := vertices_size Hv; have Fs := faces_size low Hf; have Bs := boundaries_sides low.
have Cs := components_size low Hc.
have Is : size bs = size (inner_ones t).
  by apply: lists_size Hi _; split=> [|b]; [rewrite !filter_uniq ?iota_uniq|apply: (inner_onesP low)].
have split : size (boundaries t) = size (outer_ones t) + size (inner_ones t) by exact: size_split.
have R : size (rotations t) = size (with_edges t) by exact: size_map.
have [ub inb] := Hi; have [uc cl co ca] := Hc.
have enough : size bs <= size cs by move: whole Vs Fs Bs Cs split R; arith.
move=> v lv; have [b O] := out v lv; exists b; split=> // d D; apply/eqP; case: eqP => // bd; exfalso.
have db : d \in bs by apply/inb; case: D.
suff: size cs <= size (rem d bs).
  by rewrite size_rem //; move: enough db; case: (bs) => [//|x s] /=; arith.
apply: (@rel_size_le _ _ (fun w b => outside_of t w b)) => // [w wc|w w' x wc w'c [_ [y Y C]] [_ [z]]]; last first.
  by rewrite Y => -[<-] C'; apply: co => //; apply: trans C (sym C').
have [x X] := out w (cl w wc); case: (x =P d) => [xd|xd]; last first.
  by exists x; rewrite // mem_rem_uniq // inE; apply/andP; split; [apply/eqP|apply/inb; case: X].
exists b; first by rewrite mem_rem_uniq // inE; apply/andP; split; [apply/eqP|apply/inb; case: O].
case: O => I [y Y C]; split=> //; exists y => //; move: X D => [_ [z Z Cz]] [_ [z']]; rewrite -xd Z => -[<-] Cd.
exact: trans Cz (trans (sym Cd) C).
Qed.

Lemma core_rooted f : steps_out f -> rooted t f.
Proof.
elim=> {f} [f lf U|f b v d w g Fb Ib Pb Id Pd C Fd _ IH]; first exact/rooted_here/unbounded_core.
have [x W D] := passes_at (heard_live Fb) Pb.
apply: (@rooted_out t f b x d g) => //; first exact/outer_core.
exact: passes_outside (heard_live Fd) Id Pd (trans D C).
Qed.

Theorem core_rules : rules t.
Proof.
have t1 := core_t1; have t2 : t2_nesting t.
  move=> v b f _ _ F; apply/core_rooted/(core_out c).
  by have [g G lg] := core_face c (heard_live F); move: G; rewrite F => -[->].
have t3 : t3_euler t.
  have [es He] := edges_each low; have [vs [hs [fs [bs [Hv Hh Hf Hb eq]]]]] := core_counts c.
  apply/(t3_counts low t1 Hv He Hf (inner_lists Hb)); have := edges_twice map He Hh.
  by move: eq; arith.
have H q : index q < index T4 -> holds t q.
  by case: (ltnP (index q) (index T1)) => [lt _|le lt]; [apply: low|case: q le lt].
by move=> q; case: (ltnP (index q) (index T4)) => [/H //|]; case: q => // _; apply: t4_follows => q; apply: H.
Qed.

End Core.

(** ** Where all rules hold, the core is right *)

Definition inn_of t : pred nat := fun b => if boundary_place t b is Some Outer then false else true.

Section OfRules.
Variable t : view.
Hypothesis keeps : rules t.

Let low : lower t. Proof. by move=> q _; apply: keeps. Qed.
Let map : is_map t := low_map low.
Notation inn := (inn_of t).

Lemma inn_inner b : boundary t b -> inn b <-> is_inner t b.
Proof.
move=> lb; have [f [p [_ _ P _]]] := placeP low lb; rewrite /inn_of /is_inner P.
by case: p {P} => [|i]; split=> //; [case|exists i].
Qed.

Lemma inn_outer f b : outer t f = Some b <-> boundary_face t b = Some f /\ ~~ inn b.
Proof.
split=> [O|[F I]]; first by have [F P] := @listed_names _ low f Outer b O; rewrite /inn_of P.
have [g [p [_ F' P L]]] := placeP low (heard_live F); move: F' L; rewrite F => -[<-].
by move: I; rewrite /inn_of P; case: p {P}.
Qed.

Lemma at_passes b w : vertex_at t b = Some w -> passes t b w.
Proof.
rewrite /vertex_at; case S: (boundary_start t b) => [[h|v]|] //.
  by left; exists h => //; apply: (start_on_cycle keeps).
by case=> <-; right; case: (boundaryP low (heard_live S)) => [x|u]; rewrite S // => -[<-].
Qed.

Lemma isolated_start v b : isolated t v = Some b -> boundary_start t b = Some (AtVertex v) /\ bare t v.
Proof.
move=> I; case: (vertexP low (heard_live I)) => [x _ xv|d _ B J S]; last by move: J; rewrite I => -[->].
have [_ N] := keeps B2 v (heard_live I); have [|E _] := N; first by rewrite -xv; apply: not_bare.
by move: E; rewrite I.
Qed.

Lemma steps_of_rooted f : rooted t f -> face t f -> steps_out t inn f.
Proof.
elim=> {f} [f [lf U] _|f b w b' g O W [[i P] [w' W' C]] F _ IH lf].
  apply: out_here => // b F; apply/negPn/negP=> I.
  by have/inn_outer : boundary_face t b = Some f /\ ~~ inn b by []; rewrite U.
have [Fb Ib] := (inn_outer f b).1 O; have [[_ _ B _] _] := keeps R1.
have [[g' + lg] _] := B b' (heard_live F); rewrite F => -[gg]; rewrite -gg in lg.
apply: (out_through (b := b) (v := w) (c := b') (w := w') (g := g)) => //; try exact: at_passes; last exact: IH.
by apply/(inn_inner (heard_live P)); exists i.
Qed.

Theorem core_of_rules : core t inn.
Proof.
have [[H V B F] _] := keeps R1; split.
- by move=> h /H[].
- exact: (keeps L1).
- move=> g h lg lh; have [+ _] := keeps L2 g lg; have [+ _] := keeps L2 h lh => + + E; rewrite E.
  by case: (next t h) => [n|] //= -> [].
- exact: (keeps L3).
- by move=> g h lg lh E; apply/(keeps V2).
- by have [] := keeps B1.
- move=> g h lg lh; have [_ _ _ _ [b E _]] := H g lg; rewrite E => E'.
  exact: (cycle_of keeps E (esym E')).
- move=> v lv bv; have [A _] := keeps B2 v lv; have [b [I _]] := A bv; exists b => //.
  by have [S _] := isolated_start I; apply: heard_live S.
- move=> v b I; have [S bv] := isolated_start I; split=> //; first exact/(inn_inner (heard_live S))/(vertex_inner low S).
  by move=> h Bh; have [g + _] := start_of_cycle keeps Bh; rewrite S.
- by move=> v w b /isolated_start[+ _] /isolated_start[+ _] => -> [].
- move=> b lb; case: (boundaryP low lb) => [x _ xb|v _ _ _ I]; last by exists v; right.
  by exists (org x); left; exists (num x); [rewrite (Map.boundaryE map) xb|apply: (Map.originE map)].
- by move=> b /B[].
- move=> b c Ib Ic Fbc lb; have [[f E _] _] := B b lb.
  have/inn_outer O : boundary_face t b = Some f /\ ~~ inn b by [].
  have/inn_outer : boundary_face t c = Some f /\ ~~ inn c by rewrite -Fbc.
  by rewrite O => -[].
- have unb f : unbounded t f <-> face t f /\ no_outer t inn f.
    split=> -[lf U]; split=> //.
      move=> b Fb; apply/negPn/negP=> I; have/inn_outer : boundary_face t b = Some f /\ ~~ inn b by [].
      by rewrite U.
    by case O: (outer t f) => [b|] //; have [/U-> ] := (inn_outer f b).1 O.
  have [[f [U one]] _] := keeps F1; exists f; split; first exact/unb.
  by move=> g /unb; apply: one.
- move=> v lv; have [b [[[i P] [w W C]] _]] := keeps T1 v lv; exists b, w; split=> //; first exact: heard_live P.
    by apply/(inn_inner (heard_live P)); exists i.
  exact: at_passes.
- by move=> f lf; apply: steps_of_rooted => //; apply: (face_rooted low (keeps T1) (keeps T2)).
have [es He] := edges_each low.
have Hv := lists_filter (@vertex_below t) (fun v => iff_refl (vertex t v)).
have Hh := lists_filter (@half_edge_below t) (fun h => iff_refl (half_edge t h)).
have Hf := lists_filter (@face_below t) (fun f => iff_refl (face t f)).
have Hb : lists (inner_ones t) (is_inner t).
  by split=> [|b]; [rewrite !filter_uniq ?iota_uniq|apply: (inner_onesP low)].
have Hb' : lists (inner_ones t) (fun b => boundary t b /\ inn b).
  apply: lists_iff Hb => b; split=> [I|[lb I]]; last exact/(inn_inner lb).
  have lb : boundary t b by case: I => i P; apply: heard_live P.
  by split=> //; apply/inn_inner.
exists [seq v <- iota 0 (vertex_slots t) | vertex t v], [seq h <- iota 0 (half_edge_slots t) | half_edge t h].
exists [seq f <- iota 0 (face_slots t) | face t f], (inner_ones t); split=> //.
have := (t3_counts low (keeps T1) Hv He Hf Hb).1 (keeps T3).
by rewrite (edges_twice map He Hh); arith.
Qed.

Lemma rest_of_rules : rest t inn.
Proof.
have [[H V B F] _] := keeps R1; split.
- move=> h lh; have [_ _ _ P _] := H h lh; split=> //; by have [] := keeps L2 h lh.
- move=> v lv; have [[[h L lh]|N] _] := V v lv; [left|by right].
  by exists h => //; apply: (keeps V1).
- move=> b lb; case: (boundaryP low lb) => [x S xb|v S lv bv I]; [left|by right; exists v].
  by exists (num x) => //; rewrite (Map.boundaryE map) xb.
- move=> b lb; have [f [p [_ F' P L]]] := placeP low lb; exists f, p; split=> //.
  by rewrite /inn_of P; case: p {P L} => [|i]; split=> //; case.
- by move=> f p b L; apply: listed_names.
move=> f i lt; have lf : face t f by move: lt; rewrite /inner_count; case: ifP.
by have [_ /(_ i lt)[b -> _]] := F f lf.
Qed.

(** The vertices that one boundary component passes are connected. *)
Lemma passes_connected b u w : boundary t b -> passes t b u -> passes t b w -> connected t u w.
Proof.
move=> lb P Q; have [c r] := (core_of_rules, rest_of_rules).
have [x X Cu] := passes_at c r lb P; have [y + Cw] := passes_at c r lb Q; rewrite X => -[xy].
by rewrite -xy in Cw; apply: connected_trans (connected_sym map Cu) Cw.
Qed.

(** T1: the inner boundary components of one component are one. *)
Lemma one_inner b d u w : inn b -> inn d -> passes t b u -> passes t d w -> connected t u w -> boundary t b -> boundary t d -> b = d.
Proof.
move=> Ib Id P Q C lb ld; have [c r] := (core_of_rules, rest_of_rules); have lu : vertex t u.
  case: P => [[i _ O]|I]; last exact: heard_live I.
  by have [[x X lx] _ _ _] := core_live c (heard_live O); move: X lx; rewrite O => -[->].
have [x [_ one]] := keeps T1 u lu.
have := one b (passes_outside c r lb Ib P (connected_self t u)).
by rewrite (one d (passes_outside c r ld Id Q C)).
Qed.

End OfRules.
