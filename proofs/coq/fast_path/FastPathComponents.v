(** * FastPathComponents: as few sets as Euler's formula allows are the components

    Vertices are joined along edges, so that a set never reaches beyond a component, and there are never fewer sets than
    components. Euler's formula says that the figure with which joining stops is the number of components less the handles.

<<
      components ≤ sets                                          as no set reaches beyond a component
      sets = (V + cycles − E) / 2 = components − handles         if as few sets are left as can be

      so there are no handles, and as many sets as components: the sets are the components
>>
*)

From mathcomp Require Import all_ssreflect all_fingroup.
From twinedge Require Import Arith View Rules Loops LoopsProof Reference Map Counting Lists ReferenceProof TopologyProof.
From twinedge Require Import Drawing Euler Numbered Genus WholeEuler FastPath FastPathAccepted FastPathKept.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** One of each number. *)
Lemma one_of_each_number (number : nat -> nat) s : uniq s -> exists cs,
  [/\ uniq cs, {subset cs <= s}, {in cs &, injective number}
    & forall v, v \in s -> exists2 u, u \in cs & number u = number v].
Proof.
elim: s => [|v s IH] /=; first by exists [::].
case/andP=> vs /IH[cs [u sub inj all]].
case: (boolP (has (fun w => number w == number v) cs)) => [/hasP[w wc /eqP wv]|/hasPn no].
  exists cs; split=> // [x /sub xs|x]; first by rewrite inE xs orbT.
  by rewrite inE => /orP[/eqP->|/all //]; exists w.
exists (v :: cs); split=> /=.
- by rewrite u andbT; apply/negP=> /sub; rewrite (negPf vs).
- by move=> x; rewrite !inE => /orP[->|/sub->] //; rewrite orbT.
- move=> x y; rewrite !inE => /orP[/eqP->|xc] /orP[/eqP->|yc] // E; [case/eqP: (no y yc)|case/eqP: (no x xc)|] => //.
  exact: inj.
move=> x; rewrite inE => /orP[/eqP->|/all[w wc wx]]; first by exists v; rewrite ?mem_head.
by exists w => //; rewrite inE wc orbT.
Qed.

(** If all numbers are different, so are the things that have them. *)
Lemma uniq_map_inj (f : nat -> nat) s : uniq [seq f x | x <- s] -> {in s &, injective f}.
Proof.
elim: s => //= x s IH /andP[n u] y z; rewrite !inE => /orP[/eqP->|ys] /orP[/eqP->|zs] // E.
- by case/negP: n; rewrite E map_f.
- by case/negP: n; rewrite -E map_f.
exact: IH.
Qed.

Section Components.
Variable t : view.
Hypothesis low : lower t.

Let map := low_map low.
Let rot := low_v2 low.

(** ** Joining

    [within]: vertices of one set are connected. [whole]: connected vertices are in one set. *)

Definition within (number : memory nat) := forall u v, vertex t u -> vertex t v -> number u = number v -> connected t u v.
Definition whole (number : memory nat) := forall u v, vertex t u -> connected t u v -> number u = number v.

Lemma numberedE f v : vertex t v -> numbered t f v = f v.
Proof.
move/(@vertex_below t); rewrite /numbered; set step := fun _ _ => _.
suff H m : forall n, fold_below n step m v = if v < n then f v else m v by rewrite H => ->.
move=> n; elim: n m => [|n IH] m //=; rewrite {}IH /step /write [v < n.+1]ltnS [v <= n]leq_eqVlt.
by case: (ltnP v n) => _; rewrite ?orbT // orbF; case: eqP => [->|].
Qed.

Lemma join_within number u v : vertex t u -> vertex t v -> connected t u v -> within number -> within (join t number u v).
Proof.
move=> lu lv uv ok x y lx ly; rewrite /join !numberedE // /read.
case: eqP => [xu|_]; case: eqP => [yu|_].
- by move=> _; apply: ok => //; rewrite xu yu.
- by move=> /ok vy; apply: connected_trans (vy lv ly); apply: connected_trans uv; apply: ok.
- move=> /ok xv; apply: connected_trans (xv lx lv) _; apply: connected_trans (connected_sym map uv) _.
  by apply: ok => //; rewrite yu.
exact: ok.
Qed.

Lemma join_keeps number u v x y : vertex t x -> vertex t y -> number x = number y ->
  join t number u v x = join t number u v y.
Proof. by move=> lx ly E; rewrite /join !numberedE // /read E. Qed.

Lemma join_same number u v : vertex t u -> vertex t v -> join t number u v u = join t number u v v.
Proof. by move=> lu lv; rewrite /join !numberedE // eqxx; case: eqP. Qed.

Definition joins_connected (ends : seq (nat * nat)) := forall u v, (u, v) \in ends ->
  [/\ vertex t u, vertex t v & connected t u v].

Lemma join_until_within fewest ends number : joins_connected ends -> within number ->
  within (join_until t fewest ends number).
Proof.
elim: ends number => [|[u v] ends IH] number on ok //=; case: ifP => // _; apply: IH.
  by move=> x y xy; apply: on; rewrite inE xy orbT.
by have [lu lv uv] := on u v (mem_head _ _); apply: join_within.
Qed.

Lemma join_until_keeps fewest ends number x y : vertex t x -> vertex t y -> number x = number y ->
  join_until t fewest ends number x = join_until t fewest ends number y.
Proof.
by move=> lx ly; elim: ends number => [|[u v] ends IH] number E //=; case: ifP => // _; apply/IH/join_keeps.
Qed.

(** It stops when few enough sets are left, or with every edge used. *)
Lemma join_until_end fewest ends number : joins_connected ends -> sets t (join_until t fewest ends number) <= fewest \/
  forall u v, (u, v) \in ends -> join_until t fewest ends number u = join_until t fewest ends number v.
Proof.
elim: ends number => [|[u v] ends IH] number on /=; first by right.
case: ifP => [few|_]; first by left.
case: (IH (join t number u v)) => [x y xy||used]; [by apply: on; rewrite inE xy orbT | by left | right].
have [lu lv _] := on u v (mem_head _ _).
move=> x y; rewrite inE => /orP[/eqP[-> ->]|]; last exact: used.
exact: join_until_keeps (join_same _ _ _).
Qed.

(** *** First to the nearest neighbour, then along the edges *)

Lemma nearest_of v : nearest t v = v \/ nearest t v \in neighbours t v.
Proof.
rewrite /nearest; elim: (neighbours t v) => [|u s IH] /=; first by left.
rewrite /minn; case: ifP => _; first by right; apply: mem_head.
by case: IH => [|IH]; [left | right; rewrite inE IH orbT].
Qed.

Lemma nearest_connected v : vertex t v -> vertex t (nearest t v) /\ connected t v (nearest t v).
Proof.
case: (nearest_of v) => [-> lv|/(neighboursP low)[x [<- <-]] _]; first by split=> //; apply: connected_self.
by split; [apply: org_live | apply: connected_step].
Qed.

Lemma hooked_within : within (hooked t).
Proof.
have: {subset vertex_ones t <= vertex t} by move=> v; rewrite vertex_onesP.
have: within (numbered t id) by move=> u v lu lv; rewrite !numberedE // => ->; apply: connected_self.
rewrite /hooked; elim: (vertex_ones t) (numbered t id) => [|v s IH] number ok sub //=; apply: IH; last first.
  by move=> x xs; apply: sub; rewrite inE xs orbT.
have lv : vertex t v by apply: sub; apply: mem_head.
by have [ln vn] := nearest_connected lv; apply: join_within.
Qed.

Lemma edge_endsP u v : (u, v) \in edge_ends t <-> exists x : dart t, [/\ num x < num (tw x), org x = u & org (tw x) = v].
Proof.
have E (x : dart t) :
    (odflt 0 (says_origin t (num x)), odflt 0 (says_twin t (num x) >>= says_origin t)) = (org x, org (tw x)).
  by rewrite (says_twinE low) /= !(says_originE low).
split=> [/mapP[h]|[x [lt <- <-]]].
  rewrite mem_filter half_edge_onesP => /andP[+ /dartP[x xh]]; rewrite -xh E => lt [-> ->]; exists x; split=> //.
  by move: lt; rewrite (says_twinE low).
rewrite -E; apply: map_f; rewrite mem_filter half_edge_onesP dart_live andbT (says_twinE low).
exact: lt.
Qed.

Lemma edge_ends_connected : joins_connected (edge_ends t).
Proof. by move=> u v /edge_endsP[x [_ <- <-]]; split; [apply: org_live|apply: org_live|apply: connected_step]. Qed.

(** If every edge is used, connected vertices are in one set. *)
Theorem all_edges_are_enough number : (forall u v, (u, v) \in edge_ends t -> number u = number v) -> whole number.
Proof.
move=> used u v lu; elim=> // h w x _ ->; move/(originP map) => [y <- <-]; rewrite (targetE map) => -[<-].
case: (ltngtP (num y) (num (tw y))) => [lt|lt|/num_inj E]; first by apply: used; apply/edge_endsP; exists y.
  by apply/esym/used/edge_endsP; exists (tw y); rewrite (twK map).
by case/eqP: (tw_neq map y).
Qed.

(** ** There are never fewer sets than components; with as many, the sets are the components *)

Section Sets.
Variables (number : memory nat) (cs : seq nat).
Hypothesis ok : within number.
Hypothesis each : lists_one_of_each cs (connected t) (vertex t).

Let u : uniq [seq number v | v <- cs].
Proof.
have [uc live one _] := each; rewrite map_inj_in_uniq // => v w vc wc E; apply: one => //.
by apply: ok => //; apply: live.
Qed.

Let sub : {subset [seq number v | v <- cs] <= undup [seq number v | v <- vertex_ones t]}.
Proof.
have [_ live _ _] := each; move=> k /mapP[v vc ->]; rewrite mem_undup; apply: map_f.
by rewrite vertex_onesP; apply: live.
Qed.

Lemma sets_least : size cs <= sets t number.
Proof. by rewrite -(size_map number); apply: uniq_leq_size. Qed.

Lemma sets_whole : sets t number <= size cs -> whole number.
Proof.
rewrite -(size_map number) => le v w lv vw; have [_ same] := uniq_min_size u sub le.
have lw : vertex t w.
  elim: vw => // h x y _ _ _; rewrite /target; case: (twin t h) => [k|] //= /(originP map)[z _ <-].
  exact: org_live.
have rep x : vertex t x -> exists2 c, c \in cs & number x = number c.
  move=> lx; have : number x \in undup [seq number v | v <- vertex_ones t] by rewrite mem_undup map_f ?vertex_onesP.
  by rewrite -same => /mapP[c cc E]; exists c.
have [c cc vc] := rep v lv; have [d dd wd] := rep w lw; have [_ live one _] := each.
rewrite vc wd; congr number; apply: one => //.
apply: connected_trans (ok (live _ cc) lv (esym vc)) _; apply: connected_trans vw _.
by apply: ok => //; apply: live.
Qed.

Lemma whole_sets : whole number -> sets t number = size cs.
Proof.
move=> all; apply/eqP; rewrite eqn_leq sets_least andbT -(size_map number); apply: uniq_leq_size; first exact: undup_uniq.
move=> k; rewrite mem_undup => /mapP[v + ->]; rewrite /read vertex_onesP => lv; have [_ live _ reps] := each.
by have [c cc cv] := reps v lv; rewrite -(all c v (live c cc) cv); apply: map_f.
Qed.

End Sets.

(** There is a list with one vertex of each component. *)
Lemma components_exist : exists cs, lists_one_of_each cs (connected t) (vertex t).
Proof.
pose number := join_until t 0 (edge_ends t) (hooked t).
have ok : within number := join_until_within edge_ends_connected hooked_within.
have all : whole number.
  case: (join_until_end 0 (hooked t) edge_ends_connected) => [|used]; last exact: all_edges_are_enough.
  rewrite leqn0 size_eq0 => /eqP none v w lv _.
  have : number v \in undup [seq number v | v <- vertex_ones t] by rewrite mem_undup map_f ?vertex_onesP.
  by rewrite none.
have [cs [uc sub inj reps]] := one_of_each_number number (ones_uniq (vertex_slots t) (vertex t)); exists cs; split=> //.
- by move=> v /sub; rewrite vertex_onesP.
- move=> v w vc wc vw; apply: inj => //; apply: all vw.
  by have := sub v vc; rewrite vertex_onesP.
move=> v; rewrite -vertex_onesP => vs; have [c cc cv] := reps v vs; exists c => //.
by apply: ok => //; [have := sub c cc; rewrite vertex_onesP | rewrite -vertex_onesP].
Qed.

(** ** Euler's formula: joining stops with the number of components less the handles *)

Lemma cycles_number : count (predC (is_at_vertex t)) (listed_ones t) = size (cycles t).
Proof.
rewrite (seq.permP (listed_kept low)) size_map size_filter /boundary_ones /live_ones count_filter.
apply: eq_count => b /=; rewrite /cyclic /is_at_vertex; case lb: (boundary t b); rewrite ?andbT ?andbF.
  case: (boundaryP low lb) => [x + _|v + _ _ _]; by rewrite /boundary_start heardE // => ->.
by rewrite /boundary_start /heard lb.
Qed.

Lemma isolated_number : count (is_isolated t) (vertex_ones t) = size (isolated_ones t).
Proof.
rewrite /vertex_ones /live_ones count_filter size_filter; apply: eq_count => v /=; rewrite /is_isolated andbC.
by case lv: (vertex t v) => //=; rewrite /leaving heardE //; case: (says_leaving t v).
Qed.

Lemma euler_number cs : lists_one_of_each cs (connected t) (vertex t) -> exists g,
  vertices_and_cycles t + g.*2 = edge_number t + (size cs).*2 /\ (g = 0 <-> t3_euler t).
Proof.
move=> Hc; have [edges every] := every_edge_exists (twK map) (tw_neq map); have [es He] := edges_each low.
exists (handles (turns low) (@tw t) edges); split; last by rewrite (t3_plane low every) drawnP.
have := whole_euler low every (rotations_each low) (cycles_each low) He (pieces_each low).
have : size (vertex_ones t) = size (with_edges t) + size (isolated_ones t).
  exact: vertices_size (lists_filter (@vertex_below t) (fun v => iff_refl (vertex t v))).
have := components_size low Hc; have : size (rotations t) = size (with_edges t) by exact: size_map.
have E : size (half_edge_ones t) = (size es).*2.
  rewrite size_filter; apply: (edges_half low) He => // [h|x _]; [exact: half_edge_below|exact: dart_live].
rewrite /vertices_and_cycles /edge_number E doubleK cycles_number isolated_number.
by arith.
Qed.

(** Any sets that do not reach beyond a component: if there are as few as Euler's formula allows, they are the components,
    and no component has a handle (T3). This is why joining may stop there, though edges are left that were not used.

<<
      {1 3 7 2 6}  {4 5}      2 sets,  V + cycles − E = 2 · 2:   no edge leads from one to the other, used or not
>>
*)

Theorem few_sets_are_components number : within number ->
  vertices_and_cycles t = edge_number t + (sets t number).*2 -> whole number /\ t3_euler t.
Proof.
move=> ok few; have [cs Hc] := components_exist; have [g [eq T3]] := euler_number Hc; have least := sets_least ok Hc.
have g0 : g = 0 by arith.
split; last exact/T3.
by apply: (sets_whole ok Hc); arith.
Qed.

(** ** T3: as few sets are left as can be if and only if it holds *)

Lemma set_of_within : within (set_of t).
Proof. exact: join_until_within edge_ends_connected hooked_within. Qed.

Lemma twice_number : t3_euler t -> exists2 cs, lists_one_of_each cs (connected t) (vertex t)
  & vertices_and_cycles t = edge_number t + (size cs).*2 /\ twice t = (size cs).*2.
Proof.
move=> t3; have [cs Hc] := components_exist; have [g [eq T3]] := euler_number Hc; have g0 : g = 0 by apply/T3.
by exists cs => //; rewrite /twice; move: eq; rewrite g0; split; arith.
Qed.

(** If T3 holds, every component is one set in the end, whether all edges are used or not. *)
Lemma set_of_whole : t3_euler t -> whole (set_of t).
Proof.
case/twice_number=> cs Hc [_ E].
case: (join_until_end (maxn (twice t)./2 1) (hooked t) edge_ends_connected) => [few|]; last exact: all_edges_are_enough.
move=> u v lu; apply: (sets_whole set_of_within Hc) => //; move: few; rewrite -/(set_of t) E doubleK.
by have [_ _ _ all] := Hc; have [c + _] := all u lu; case: (cs).
Qed.

Theorem as_few_as_can_be_means : as_few_as_can_be t (set_of t) <-> t3_euler t.
Proof.
split=> [/and3P[le even /eqP few]|t3].
  have E : (twice t)./2.*2 = twice t by rewrite -[RHS]odd_double_half (negPf even).
  suff /(few_sets_are_components set_of_within)[] : vertices_and_cycles t = edge_number t + (sets t (set_of t)).*2 by [].
  by rewrite few E /twice subnKC.
have [cs Hc [eq E]] := twice_number t3; apply/and3P; split; first by rewrite eq leq_addr.
  by rewrite E odd_double.
by rewrite E doubleK (whole_sets set_of_within Hc (set_of_whole t3)).
Qed.

(** ** T1 *)

(** If T3 holds, the sets are the components: so each has one inner boundary component if and only if T1 holds. *)
Theorem one_outside_means : t3_euler t -> one_outside_each t (set_of t) <-> t1_outside t.
Proof.
move=> /set_of_whole all; have ok := set_of_within.
pose inner_ones := [seq b <- listed_ones t | is_listed_inner t b]; pose at_ b := odflt 0 (says_vertex_at t b).
have innerP b : b \in inner_ones <-> is_inner t b.
  rewrite mem_filter (perm_mem (listed_kept low)) boundary_onesP /is_listed_inner; split=> [/andP[]|[i P]].
    by case P: (says_boundary_place t b) => [[|i]|] // _ lb; exists i; rewrite /boundary_place heardE.
  by have lb := heard_live P; move: P; rewrite /boundary_place heardE // => ->.
have atP b : b \in inner_ones -> [/\ vertex_at t b = Some (at_ b), vertex t (at_ b) & boundary t b].
  rewrite mem_filter (perm_mem (listed_kept low)) boundary_onesP => /andP[_ lb].
  by have [v [E E' lv]] := vertex_at_kept low lb; rewrite /at_ E.
have out v b : vertex t v -> outside_of t v b <-> b \in inner_ones /\ set_of t (at_ b) = set_of t v.
  move=> lv; split=> [[I [w W vw]]|[bi E]].
    have/innerP bi := I; have [W' lw _] := atP b bi; split=> //; move: W; rewrite W' => -[->].
    by apply/esym/all.
  have [W lw _] := atP b bi; split; first exact/innerP.
  by exists (at_ b) => //; apply: ok.
have ui : uniq inner_ones by rewrite filter_uniq // (perm_uniq (listed_kept low)) ones_uniq.
have sub : {subset outsides t (set_of t) <= undup [seq set_of t v | v <- vertex_ones t]}.
  move=> k /mapP[b /atP[_ lv _] ->]; rewrite mem_undup; apply: map_f.
  by rewrite vertex_onesP.
split=> [/andP[u /eqP n] v lv|t1].
  have same := all_met u sub n.
  have : set_of t v \in outsides t (set_of t) by rewrite same mem_undup map_f ?vertex_onesP.
  case/mapP=> b bi E; exists b; split; first by apply/out.
  move=> c /(out _ _ lv)[ci Ec].
  by apply: (uniq_map_inj u bi ci); apply: etrans (esym E) (esym Ec).
have u : uniq (outsides t (set_of t)).
  rewrite map_inj_in_uniq // => b c bi ci E; have [_ lb _] := atP b bi; have [d [_ one]] := t1 (at_ b) lb.
  by rewrite -(one b) ?(one c) //; apply/out.
rewrite /one_outside_each u /=; apply/eqP/perm_size/uniq_perm; rewrite ?undup_uniq // => k.
apply/idP/idP => [/sub //|]; rewrite mem_undup => /mapP[v]; rewrite /read vertex_onesP => lv ->.
by have [b [/(out _ _ lv)[bi <-] _]] := t1 v lv; apply: map_f.
Qed.

End Components.
