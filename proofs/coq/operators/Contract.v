(** * Contract: contracting an edge keeps all rules (`contract_edge` in dcel/operators/split_vertex.rs)

    The edge of the half-edge [n] and its twin [m] is no loop. It shrinks to a point: of its two vertices one is [kept], the other one
    is [dropped], and what left that one leaves [kept]. What went on along the edge leaves it out. Boundary components and faces
    stay as they are; an edge that is a component of its own becomes an isolated vertex.

<<
       ╲    n     ╱             ╲ ╱
        · ─────► ·      ──►      ·          next of what came before n: next n, or next m where that is m
       ╱ ◄─────   ╲             ╱ ╲
            m
>>

    If [dropped] has degree 2, this joins its two edges (`join_edges` in dcel/operators/split_edge.rs). *)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import Arith View Rules Map Counting Lists NewEdge ConnectCorners Core Collapse RemoveEdge Skip.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section Contraction.
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
Notation pair := (pair n m).
Notation col := (col kept dropped).
Let c : core t inn := core_of_rules keeps.
Let r : rest t inn := rest_of_rules keeps.
Let links_of := NewEdge.links_of keeps.
Let next_boundary := next_boundary keeps.
Let next_some := RemoveEdge.next_some keeps.
Let twin_m : twin t m = Some n := twin_of keeps twin_n.
Let live_n : half_edge t n := heard_live twin_n.
Let live_m : half_edge t m := heard_live twin_m.
Let n_not_m : n <> m := n_not_m keeps twin_n.
Let half_edgeP := Skip.half_edgeP n m.
Let vertexE := Skip.vertexE t n m kept dropped.
Let is_left := Skip.is_left kept dropped (t := t) (n := n) (m := m).
Let originE := Skip.originE keeps (n := n) (m := m) (kept := kept) (dropped := dropped).
Let boundary_ofE := Skip.boundary_ofE (t := t) (n := n) (m := m) (kept := kept) (dropped := dropped).
Let is_end := Skip.is_end ends.
Let col_end := Skip.col_end ends.
Let col_other := Skip.col_other ends.
Let col_kept := Skip.col_kept ends.
Let live_kept := Skip.live_kept keeps twin_n origin_n origin_m ends.
Let twin_left := Skip.twin_left keeps twin_n (kept := kept) (dropped := dropped).
Let next_left := Skip.next_left keeps twin_n (kept := kept) (dropped := dropped).
Let origin_end := Skip.origin_end origin_n origin_m ends differ.
Let end_col := Skip.end_col origin_n origin_m ends (n := n) (m := m).
Let same_end := Skip.same_end origin_n origin_m ends differ.
Let origin_side := Skip.origin_side keeps twin_n.
Let pair_twin := Skip.pair_twin keeps twin_n.
Let pair_live := Skip.pair_live keeps twin_n.
Let pair_differ := Skip.pair_differ keeps twin_n.
Let skipE := Skip.skipE keeps twin_n.
Let skip_origin := Skip.skip_origin keeps twin_n origin_n origin_m ends differ.
Let skip_boundary := Skip.skip_boundary keeps twin_n.
Let turn_end := Skip.turn_end keeps twin_n.
Let contract_l1 := Skip.contract_l1 keeps twin_n (kept := kept) (dropped := dropped).

(** ** Vertices *)

Lemma aloneP : alone -> forall i, half_edge t' i -> boundary_of t i <> Some bn /\ (forall u, origin t i = Some u -> u <> un /\ u <> um).
Proof.
case/andP=> /eqP N /eqP M i li; have [Li i_n im] := leftP li; split=> [B|u U].
  have: i = n \/ i = m.
    apply: (orbit_ind (P := fun i => i = n \/ i = m)) (cycle_of keeps boundary_n B); first by left.
    by move=> x y [->|->]; rewrite ?N ?M => -[<-]; auto.
  by case.
have no x y : pair x y -> next t x = Some y -> next t y = Some x -> origin t i <> origin t x.
  move=> xy X Y O; have: i = x.
    apply: (orbit_ind (P := fun i => i = x)) ((keeps V2 x i (pair_live xy) Li).2 (esym O)) => // z w ->.
    by rewrite (turn_end xy) Y => -[].
  by move=> ix; apply: (not_end li (y := y)); rewrite ix.
split=> E; [apply: (@no n m)|apply: (@no m n)]; rewrite ?U ?E ?origin_n ?origin_m //; [by left|by right].
Qed.

(** If the edge is not alone, what comes after [m] begins at [kept]. *)
Lemma not_alone x y : ~~ alone -> pair x y -> exists2 s, skip x = Some s & half_edge t' s.
Proof.
move=> na xy; have [a A la] := next_some (pair_live xy); have [b B lb] := next_some (pair_live (pair_sym xy)).
have ax : a <> x.
  move=> ax; have := origin_side xy A; rewrite ax => O; have yx := pair_sym xy.
  by case: (pair_differ xy); apply: same_end xy yx O.
have bx : a = y -> b <> x.
  move=> ay E; case/negP: na; rewrite /Skip.alone; move: A B; rewrite ay E; case: xy => -[-> ->] -> ->; by rewrite !eqxx.
have by_ : b <> y.
  move=> E; have := origin_side (pair_sym xy) B; rewrite E => O; have yx := pair_sym xy.
  by case: (pair_differ xy); apply: same_end xy yx (esym O).
have left i : half_edge t i -> i <> x -> i <> y -> half_edge t' i by case: xy => -[-> ->] ? ? ?; apply: is_left.
rewrite (skipE xy) A B; case: eqP => [[ay]|ay]; [exists b => //; apply: left => //; exact: bx|].
by exists a => //; apply: left => // E; apply: ay; rewrite E.
Qed.

Lemma isolatedE u : vertex t' u -> isolated t' u = if (u == kept) && alone then Some bn else isolated t u.
Proof.
by rewrite vertexE {1}/isolated /heard vertexE => /= /[dup] /andP[_ lu] ->; rewrite boundary_n; case: ifP => // _; rewrite /isolated /heard lu.
Qed.

Lemma isolated_end u : u = un \/ u = um -> isolated t u = None.
Proof.
by move=> ue; case I: (isolated t u) => [b|] //; have [B _ _] := core_isolated c I; case: ue => E;
  [case: (B n live_n)|case: (B m live_m)]; rewrite E.
Qed.

(** An isolated vertex is what is left of the edge that was alone, or was isolated. *)
Lemma isolated_is u b : isolated t' u = Some b -> [/\ u = kept, alone & b = bn] \/ [/\ u <> un, u <> um & isolated t u = Some b].
Proof.
move=> I; have lu := heard_live I; move: I; rewrite isolatedE //; case: ifP => [/andP[/eqP-> al] [<-]|_ I]; [by left|right].
by split=> // E; move: I; rewrite isolated_end; auto.
Qed.

Lemma bare_other u : u <> un -> u <> um -> bare t' u <-> bare t u.
Proof.
move=> un_ um_; split=> B i li O.
  have [i_n im] : i <> n /\ i <> m by split=> E; move: O; rewrite E ?origin_n ?origin_m => -[/esym].
  by apply: (B i (is_left li i_n im)); rewrite originE ?O /= ?col_other //; apply: is_left.
have [Li _ _] := leftP li; have [[w W _] _ _ _ _] := links_of Li; move: O; rewrite originE // W /= => -[wu].
apply: (B i Li); rewrite W; congr Some; move: wu; rewrite /col; case: eqP => // _ ku.
by have [] := (is_end kept).2 (or_introl erefl); rewrite ku.
Qed.

Lemma bare_kept : bare t' kept <-> alone.
Proof.
split=> [B|al i li O].
  apply/negPn/negP=> /not_alone/(_ (or_introl (conj erefl erefl)))[s S ls]; apply: (B s ls).
  by rewrite originE // (skip_origin S) origin_n /= col_end //; left.
have [Li _ _] := leftP li; have [[w W _] _ _ _ _] := links_of Li; move: O; rewrite originE // W /= => -[/col_kept wE].
by have [_ /(_ w W)[wn wm]] := aloneP al li; case: wE.
Qed.

(** ** What is connected, and what boundary components pass *)

Lemma contract_connected u w : connected t u w -> connected t' (col u) (col w).
Proof.
elim=> [|i x y _ IH X Y]; first exact: connected_self.
have li := heard_live X; case: (half_edgeP i) => [j ij|i_n im].
  have [a [b [A B _ ab]]] := origin_end ij; move: X Y; rewrite /target (pair_twin ij) /= A B => -[ax] [yb].
  by move: IH; rewrite -ax -yb (end_col ij A) (end_col (pair_sym ij) B).
have l := is_left li i_n im; have [_ [g G _] _ _ _] := links_of li; have lg := twin_left l G.
apply: (connected_edge (h := i)) IH _ _; first by rewrite originE // X.
by move: Y; rewrite /target twinE // G /= originE // => ->.
Qed.

Lemma contract_passes b u : passes t b u -> passes t' b (col u).
Proof.
case=> [[i B O]|I]; last first.
  have [nu mu] : u <> un /\ u <> um by split=> E; move: I; rewrite isolated_end; auto.
  have lu : vertex t' u.
    rewrite vertexE (heard_live I) andbT; apply/eqP=> E.
    by have [] := (is_end dropped).2 (or_intror erefl); rewrite -E.
  right; rewrite col_other // isolatedE //; case: eqP => // E.
  by have [] := (is_end kept).2 (or_introl erefl); rewrite -E.
case: (half_edgeP i) => [j ij|i_n im]; last first.
  have l := is_left (heard_live B) i_n im; by left; exists i; rewrite ?boundary_ofE // originE // O.
case: (boolP alone) => [al|na].
  have -> : col u = kept := end_col ij O; have lk : vertex t' kept by rewrite vertexE live_kept andbT; apply/eqP.
  right; rewrite isolatedE // eqxx al; move: B; case: ij => -[-> _]; rewrite -?boundary_n //.
  by case/andP: al => /eqP/next_boundary->.
have [s S ls] := not_alone na ij; left; exists s; first by rewrite boundary_ofE // (skip_boundary S).
by rewrite originE // (skip_origin S) O.
Qed.

(** The boundary component of an edge that is alone is an inner one. *)
Lemma alone_inner : alone -> inn bn.
Proof.
move=> al; have [u [_ _]] : exists u, [/\ True, True & vertex t u /\ origin t n = Some u].
  by have [[u U lu] _ _ _ _] := links_of live_n; exists u.
case=> lu U; have [b [w [lb I P C]]] := core_inside c lu.
have Pn : passes t bn u by left; exists n.
have wE : w = un \/ w = um.
  elim: C => [|i x y _ xE X Y]; first by left; move: U; rewrite origin_n => -[].
  case: (half_edgeP i) => [j ij|i_n im]; last by have [_ /(_ x X)[xn xm]] := aloneP al (is_left (heard_live X) i_n im); case: xE.
  by move: Y; case: ij => -[-> _]; rewrite /target ?twin_n ?twin_m /= ?origin_n ?origin_m => -[<-]; auto.
case: P => [[i B O]|J]; last by move: J; rewrite isolated_end.
case: (half_edgeP i) => [j ij|i_n im]; last by have [_ /(_ w O)[wn wm]] := aloneP al (is_left (heard_live O) i_n im); case: wE.
suff -> : bn = b by []; move: B; case: ij => -[-> _]; first by rewrite boundary_n => -[].
by case/andP: al => /eqP/next_boundary-> _; rewrite boundary_n => -[].
Qed.

Lemma contract_counts : core_count t' inn.
Proof.
have [vs [hs [fs [bs [Hv Hh Hf Hb eq]]]]] := core_counts c.
have ld : vertex t dropped.
  have [[u + lu] _ _ _ _] := links_of live_n; have [[w + lw] _ _ _ _] := links_of live_m.
  by rewrite origin_n origin_m => -[E] [F]; case: ends => -[uE wE]; [rewrite -wE E|rewrite -uE F].
exists (rem dropped vs), (rem m (rem n hs)), fs, bs; split=> //.
- apply: lists_iff (lists_rem dropped Hv) => u; rewrite vertexE.
  by split=> [[/eqP->]|/andP[/eqP]].
- apply: lists_iff (lists_rem m (lists_rem n Hh)) => i.
  by split=> [[im [i_n li]]|/leftP[]]; [apply: is_left|].
move: eq; rewrite (size_lists_rem Hv ld) (size_lists_rem Hh live_n).
by rewrite (size_lists_rem (lists_rem n Hh) (conj (nesym n_not_m) live_m)); arith.
Qed.

Lemma contract_core : core t' inn.
Proof.
have other u : vertex t' u -> u <> kept -> u <> un /\ u <> um.
  rewrite vertexE => /andP[/eqP ud _] uk; split=> E.
    by have [] := (is_end u).1 (or_introl E).
  by have [] := (is_end u).1 (or_intror E).
split.
- move=> i l; have [li _ _] := leftP l; have [[u U lu] [g G _] _ _ [b B lb]] := links_of li; split.
  + exists (col u); first by rewrite originE // U.
    rewrite vertexE /col; case: (u =P dropped) => [_|/eqP-> //]; by rewrite live_kept andbT; apply/eqP.
  + by exists g; [rewrite twinE|apply: twin_left G].
  + exact: next_left.
  by exists b; rewrite ?boundary_ofE.
- exact: contract_l1.
- exact: (contract_next keeps twin_n).
- exact: (contract_l3 keeps twin_n origin_n origin_m ends differ).
- exact: (contract_rotation keeps twin_n origin_n origin_m ends differ).
- exact: (contract_side keeps twin_n).
- exact: (contract_cycle keeps twin_n).
- move=> u lu B; rewrite isolatedE //; case: (u =P kept) => [uk|uk] /=.
    rewrite uk in B; rewrite ((bare_kept).1 B); exists bn => //.
    by have [_ _ _ _ [b + lb]] := links_of live_n; rewrite boundary_n => -[->].
  have [nu mu] := other u lu uk; move: lu; rewrite vertexE => /andP[_ lu].
  by apply: (core_bare c lu); apply/bare_other.
- move=> u b /isolated_is[[-> al ->]|[nu mu I]].
    split; [exact/bare_kept|exact: alone_inner|move=> i B].
    by have l := heard_live B; have [/(_ _)] := aloneP al l; case; rewrite -boundary_ofE.
  have [B Ib no] := core_isolated c I; split=> //; first exact/bare_other.
  by move=> i E; have l := heard_live E; apply: (no i); rewrite -boundary_ofE.
- move=> u w b /isolated_is[[-> al ->]|[nu mu I]] /isolated_is[[-> al' bE]|[nw mw J]] //.
  + by have [_ _ /(_ n)] := core_isolated c J; rewrite boundary_n.
  + by rewrite bE in I; have [_ _ /(_ n)] := core_isolated c I; rewrite boundary_n.
  exact: (core_one c I J).
- by move=> b /(core_used c)[u /contract_passes P]; exists (col u).
- exact: (core_face c).
- exact: (core_outer c).
- exact: (core_unbounded c).
- apply: (@collapse_inside t t' inn (fun u w => w = col u) c) => //.
  + move=> u; rewrite vertexE => /andP[/eqP ud lu]; exists u => //; by rewrite /col (introF eqP ud).
  + by move=> u w _ _ C -> ->; apply: contract_connected.
  by move=> b u P; exists (col u) => //; apply: contract_passes.
- apply: (@collapse_out t t' inn (fun u w => w = col u) c) => //.
  + by move=> u w _ _ C -> ->; apply: contract_connected.
  by move=> b u P; exists (col u) => //; apply: contract_passes.
exact: contract_counts.
Qed.

(** ** The rest *)

Lemma contract_prev i : half_edge t' i -> leads_to (half_edge t') (prev t' i) /\ prev t' i >>= next t' = Some i.
Proof. exact: prev_of_next next_left (prev_next keeps twin_n). Qed.

Lemma contract_leaving u : vertex t' u ->
  (exists2 g, leaving t' u = Some g & origin t' g = Some u) \/ leaving t' u = None /\ bare t' u.
Proof.
move=> lu'; rewrite {1 2}/leaving /heard lu' /=; case: (u =P kept) => [->|uk].
  case: (boolP alone) => [al|na]; first by right; split=> //; apply/bare_kept.
  have [s S ls] := not_alone na (or_intror (conj erefl erefl)); left; exists s => //.
  by rewrite originE // (skip_origin S) origin_m /= col_end //; right.
move: (lu'); rewrite vertexE => /andP[/eqP ud lu].
have [nu mu] : u <> un /\ u <> um.
  by split=> E; [have [] := (is_end u).1 (or_introl E)|have [] := (is_end u).1 (or_intror E)].
have -> : says_leaving t u = leaving t u by rewrite /leaving /heard lu.
case: (rest_leaving r lu) => [[g -> O]|[-> B]]; [left|right; split=> //; exact/bare_other].
exists g => //; have lg : half_edge t' g.
  by apply: is_left; [apply: heard_live O|move=> E; move: O; rewrite E ?origin_n ?origin_m => -[/esym]..].
by rewrite originE // O /= col_other.
Qed.

Lemma contract_start b : boundary t' b ->
  (exists2 g, boundary_start t' b = Some (AtHalfEdge g) & boundary_of t' g = Some b) \/
  exists2 u, boundary_start t' b = Some (AtVertex u) & isolated t' u = Some b.
Proof.
move=> lb; have lb' : boundary t b := lb; rewrite {1 2}/boundary_start /heard lb /=.
have -> : says_boundary_start t b = boundary_start t b by rewrite /boundary_start /heard lb'.
have lk : vertex t' kept by rewrite vertexE live_kept andbT; apply/eqP.
rewrite boundary_n; case: ifP => [/andP[al /eqP[<-]]|no]; first by right; exists kept; rewrite // isolatedE // eqxx al.
case: (rest_start r lb') => [[g -> B]|[u -> I]] /=; [left|right]; last first.
  have [uk lu] : u <> kept /\ vertex t' u.
    have no_end e : e = kept \/ e = dropped -> u <> e.
      by move=> /is_end ee E; move: I; rewrite E isolated_end.
    by split; [apply: no_end; left|rewrite vertexE (heard_live I) andbT; apply/eqP/no_end; right].
  by exists u; rewrite // isolatedE // (introF eqP uk).
case: (half_edgeP g) => [y gy|g_n gm]; last first.
  by exists g; [rewrite skip_other|rewrite boundary_ofE //; apply: is_left (heard_live B) g_n gm].
have na : ~~ alone.
  apply/negP=> al; move: no; rewrite al /= => /eqP; apply; rewrite -B; case: gy => -[-> _] //.
  by case/andP: al => /eqP/next_boundary->.
by have [s S ls] := not_alone na gy; exists s; rewrite ?S // boundary_ofE // (skip_boundary S).
Qed.

Lemma contract_rest : rest t' inn.
Proof.
split.
- exact: contract_prev.
- exact: contract_leaving.
- exact: contract_start.
- exact: (rest_place r).
- exact: (rest_listed r).
exact: (rest_lists r).
Qed.

End Contraction.

(** The edge of [n] and [m] has the ends [kept] and [dropped], which are two. *)
Definition is_contractible t n m kept dropped := [&& twin t n == Some m, kept != dropped
  & (origin t n == Some kept) && (origin t m == Some dropped) || (origin t n == Some dropped) && (origin t m == Some kept)].

(** If all rules held before, they hold after. *)
Theorem contract_edge_keeps_rules t n m kept dropped : is_contractible t n m kept dropped ->
  rules t -> rules (contract_edge t n m kept dropped).
Proof.
case/and3P=> /eqP T /eqP kd ends keeps; have [_ _ _ _ [bn B _]] := links_of keeps (heard_live T).
case/orP: ends => /andP[/eqP On /eqP Om];
  apply: (core_rules (contract_core keeps T On Om _ kd B) (contract_rest keeps T On Om _ kd B)); auto.
Qed.
