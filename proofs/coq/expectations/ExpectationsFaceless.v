(** * ExpectationsFaceless: what the rules mean where no faces are stored, of closed surfaces and of the plane

    A combinatorial map has vertices and half-edges alone. On closed surfaces it keeps the rules if and only if it represents a rotation
    system, and in the plane if and only if it represents one that can be drawn edge by edge.

<<
      flat t: one unbounded face, in which all cycles and isolated vertices are listed. It keeps R1 … F2, so that what Genus.v
      and Bounds.v prove of such views is true of the map.
>>
*)

From mathcomp Require Import all_ssreflect all_fingroup.
From twinedge Require Import Arith View Rules Loops LoopsProof Reference ReferenceProof Map Counting Lists.
From twinedge Require Import TopologyProof Drawing Euler Numbered.
From twinedge Require Import Subdivision Genus Bounds RotationSystem SurfaceComplete.
From twinedge Require Import Expectations ExpectationsCheck ExpectationsLists ExpectationsPlane.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** ** One face for all *)

Definition bare_vertex t v := vertex t v && ~~ has (fun h => same_link (origin t h) (Some v)) (iota 0 (half_edge_slots t)).

Definition flat_live t b :=
  if b < half_edge_slots t then numbers_cycle t b else bare_vertex t (b - half_edge_slots t).

Definition flat_list t := [seq b <- iota 0 (half_edge_slots t + vertex_slots t) | flat_live t b].

Definition flat t : view := {|
  vertex_slots := vertex_slots t;
  half_edge_slots := half_edge_slots t;
  boundary_slots := half_edge_slots t + vertex_slots t;
  face_slots := 1;
  is_vertex := is_vertex t;
  is_half_edge := is_half_edge t;
  is_boundary := flat_live t;
  is_face := fun _ => true;
  says_origin := says_origin t;
  says_twin := says_twin t;
  says_next := says_next t;
  says_prev := says_prev t;
  says_boundary := fun h => Some (cycle_number t h);
  says_leaving := says_leaving t;
  says_isolated := fun v => if bare_vertex t v then Some (half_edge_slots t + v) else None;
  says_boundary_face := fun _ => Some 0;
  says_boundary_start := fun b =>
    Some (if b < half_edge_slots t then AtHalfEdge b else AtVertex (b - half_edge_slots t));
  says_boundary_place := fun b => Some (Inner (seq.index b (flat_list t)));
  says_outer := fun _ => None;
  says_inner_count := fun _ => size (flat_list t);
  says_inner := fun _ i => nth None (map Some (flat_list t)) i
|}.

Section Flat.
Variable t : view.
Hypothesis keeps : surface_rules t.

Notation u := (flat t).

Let inj : injective (@nx t). Proof. exact: (nx_inj (one_boundary_map keeps)). Qed.
Let sym : connect_sym (frel (@nx t)). Proof. exact: fconnect_sym inj. Qed.

Lemma bare_vertexP v : reflect (vertex t v /\ bare t v) (bare_vertex t v).
Proof.
apply: (iffP andP) => -[lv H]; split=> //.
  by move=> h lh E; move/hasPn: H => /(_ h); rewrite mem_iota half_edge_below // => /(_ isT); rewrite E /= eqxx.
by apply/hasPn=> h _; apply/negP=> /same_linkP E; apply: (H h (heard_live E) E).
Qed.

Lemma flat_boundary b : boundary u b = flat_live t b.
Proof.
rewrite /boundary /=; case E: (flat_live t b); last by rewrite andbF.
rewrite andbT; move: E; rewrite /flat_live; case: ltnP => [lt _|le /bare_vertexP[/vertex_below lt _]].
  exact: leq_trans lt (leq_addr _ _).
by rewrite -(subnKC le) ltn_add2l.
Qed.

Lemma flat_cycle (x : dart t) : boundary u (num (root (frel (@nx t)) x)).
Proof.
rewrite flat_boundary /flat_live half_edge_below ?dart_live // /numbers_cycle dart_live cycle_numberE (root_root sym).
exact: eqxx.
Qed.

Lemma flat_boundary_of (x : dart t) : boundary_of u (num x) = Some (num (root (frel (@nx t)) x)).
Proof. by rewrite /boundary_of /heard (dart_live x : half_edge u (num x)) /= cycle_numberE. Qed.

Lemma flat_isolated v b : vertex t v -> isolated u v = Some b <-> bare t v /\ b = half_edge_slots t + v.
Proof.
move=> lv; rewrite /isolated /heard (lv : vertex u v) /=; case: bare_vertexP => [[_ bv]|nb].
  by split=> [[<-]|[_ ->]].
by split=> // -[bv _]; case: nb.
Qed.

Lemma flat_start b : boundary u b -> boundary_start u b =
  Some (if b < half_edge_slots t then AtHalfEdge b else AtVertex (b - half_edge_slots t)).
Proof. by rewrite /boundary_start /heard => ->. Qed.

Lemma flat_starts_at v b : starts_at_vertex u v b <-> [/\ vertex t v, bare t v & b = half_edge_slots t + v].
Proof.
split=> [S|[lv bv ->]].
  have lb := heard_live S; move: S; rewrite /starts_at_vertex flat_start //; case: ltnP => // le [bv].
  move: lb; rewrite flat_boundary /flat_live ltnNge le /= bv => /bare_vertexP[lv b0].
  by split=> //; rewrite -bv subnKC.
have lb : boundary u (half_edge_slots t + v).
  by rewrite flat_boundary /flat_live ltnNge leq_addr /= addKn; apply/bare_vertexP.
by rewrite /starts_at_vertex flat_start // ltnNge leq_addr /= addKn.
Qed.

Lemma mem_flat b : (b \in flat_list t) = boundary u b.
Proof. by rewrite mem_filter mem_iota add0n -flat_boundary andb_idr // => /boundary_below. Qed.

Lemma flat_map : is_map u.
Proof.
have [[H _] [L1 L2 L3] _ _] := keeps; split=> // h lh; have [O T N P] := H h lh; split=> //.
have [x <-] := dartP (t := t) lh; exists (num (root (frel (@nx t)) x)); [exact: flat_boundary_of|exact: flat_cycle].
Qed.

Let map := flat_map.

Lemma flat_b1 : b1_cycle u.
Proof.
split=> [h lh|b h lb lh]; have [x xh] := dartP (t := t) lh; rewrite -xh.
  rewrite (nextE map x) /= !flat_boundary_of; congr (Some (num _)); apply/eqP; rewrite (root_connect sym) sym.
  exact: fconnect1.
rewrite flat_boundary_of (flat_start lb); case: ltnP => lt; last first.
  split=> [[E]|[]//]; move: lt; rewrite -E leqNgt => /negP[]; exact: half_edge_below (dart_live _).
have [y yb ry] : exists2 y : dart t, num y = b & root (frel (@nx t)) y = y.
  move: lb; rewrite flat_boundary /flat_live lt => /andP[/dartP[y yb] /eqP E]; exists y => //.
  by apply: num_inj; rewrite -cycle_numberE yb.
rewrite -yb; split=> [[/num_inj xy]|[_ [<-] /(on_cycleE map y x) yx]].
  exists (num y) => //; apply/(on_cycleE map y x); change (fconnect (@nx t) y x); rewrite sym -xy; exact: connect_root.
by congr (Some (num _)); rewrite -[RHS]ry; apply/esym/eqP; rewrite (root_connect sym).
Qed.

Lemma flat_links : links_live u.
Proof.
have [[_ V] _ v1 _] := keeps; split; first by case: map.
- move=> v lv; split; first exact: (V v lv).
  case E: (isolated u v) => [b|]; [right|by left]; exists b => //.
  by case/(flat_isolated b lv): E => bv ->; apply: (heard_live (proj2 (flat_starts_at v _) _)).
- move=> b lb; split; first by exists 0; rewrite // /boundary_face /heard lb.
  rewrite flat_start //; move: lb; rewrite flat_boundary /flat_live; case: ltnP => _ /=; first by case/andP.
  by case/bare_vertexP.
move=> f lf; split; first by left; rewrite /outer /heard; case: ifP.
move=> i; rewrite /inner /inner_count lf /= => lt; rewrite lt (nth_map 0) //; exists (nth 0 (flat_list t) i) => //.
by rewrite -mem_flat mem_nth.
Qed.

Lemma flat_f2 : f2_listed u.
Proof.
move=> b lb; exists 0, (Inner (seq.index b (flat_list t))); split.
- by rewrite /boundary_face /heard lb.
- by rewrite /boundary_place /heard lb.
have bf : b \in flat_list t by rewrite mem_flat.
have un : uniq (flat_list t) by apply: filter_uniq (iota_uniq _ _).
move=> f [|i] /=; first by split=> [|[]//]; rewrite /outer /heard; case: ifP.
rewrite /inner /inner_count /face /=; case: f => [|f] /=; last by split=> // -[].
case: ltnP => lt; last first.
  by split=> // -[_ [ii]]; move: lt; rewrite ii leqNgt index_mem bf.
rewrite (nth_map 0) //; split=> [[<-]|[_ [->]]]; first by rewrite index_uniq.
by rewrite nth_index.
Qed.

Lemma flat_lower : lower u.
Proof.
have [_ [L1 L2 L3] v1 v2] := keeps.
case=> // _; [split; [exact: flat_links | exact: lists_short_listed flat_links flat_f2]|exact: flat_b1| | |exact: flat_f2].
- move=> v lv; split=> bv.
    exists (half_edge_slots t + v); split; first exact/flat_isolated.
    by move=> c; rewrite flat_starts_at; split=> [[]|->].
  split; first by case E: (isolated u v) => [b|] //; case: bv; case/(flat_isolated b lv): E.
  by move=> b /flat_starts_at[_ /bv].
split; last by move=> f b v; rewrite /outer /heard; case: ifP.
exists 0; split; first by split.
by move=> [|f] [] //.
Qed.

End Flat.

(** ** The rules of structures without faces *)

(** A rotation system that can be drawn edge by edge: if in one order, then in every order (`genus` in Euler.v). *)
Definition plane_system r := exists2 edges, every_edge (@opposite r) edges & Drawing.drawn (@around r) (@opposite r) edges.

Section Faceless.
Variables (t : view) (records places holes unbounded : bool) (sf so : nat -> link) (si : nat -> nat -> option start).

(** It may say something of the other parts, but does not store them. *)
Let s := Structure t (Parts true true false records places holes unbounded) sf so si.

(** The closed plane, or closed surfaces; no rule of meshes is asked for. *)
Section Closed.
Variable on : bool.
Let e := Expectation on false false false None false None None None false.

Lemma no_boundary b : boundary (seen e s) b = false. Proof. by []. Qed.
Lemma no_face f : face (seen e s) f = false. Proof. by []. Qed.

Lemma no_entry f p : entry_start e s f p = None.
Proof. by case: p. Qed.

Lemma rules_before_t3 : (forall r, index r < index T3 -> holds_of e s (Basic r)) <-> surface_rules t.
Proof.
split=> [H|[[Hh Hv] [L1' L2' L3'] V1' V2']].
  have [Hh Hv _ _ _] := H R1 isT; split; last 2 first.
  - exact: (H V1 isT).
  - move=> g h lg lh; have [A B] := H V2 isT g h lg lh; split; first by move=> o; apply: A; left.
    by case/B=> [|[]].
  - split=> [h lh|v lv]; last by have [A _] := Hv v lv; apply: A.
    by have [O [T|] // N P _] := Hh h lh; split=> //; apply: P.
  split; [move=> h lh; exact: (H L1 isT h lh isT) | exact: (H L2 isT) | move=> h lh; exact: (H L3 isT h lh isT)].
case=> // _.
- split=> // [h lh|v lv]; first by have [O T N P] := Hh h lh; split=> //; left.
  by split; [move=> _; apply: Hv | left; rewrite /isolated /heard; case: ifP].
- by move=> h lh _; apply: L1'.
- by move=> h lh _; apply: L3'.
- by move=> g h lg lh; split=> [[o|[]//]|o]; [exact: (V2' g h lg lh).1 o | left; exact: (V2' g h lg lh).2 o].
by split=> //= f p h; rewrite no_entry.
Qed.

Section Kept.
Hypothesis keeps : surface_rules t.
Let low := flat_lower keeps.

Lemma faceless_counts v V E C : counts_of e s v V E C <-> has_counts (flat t) v V E C.
Proof. exact: (same_counts sf so si low). Qed.

Lemma has_genus v : vertex t v -> exists V E C g, has_counts (flat t) v V E C /\ V + C + 2 * g = 2 + E.
Proof.
move=> lv; have [V [E [C H]]] : exists V E C, has_counts (flat t) v V E C.
  case: (vertexP low (lv : vertex (flat t) v)) => [x _ <-|b _ bv _ _]; first exact: component_counts.
  by exists 1, 0, 1; apply/(has_counts_bare low _ _ _ bv).
by have [g eq] := euler_component low (lv : vertex (flat t) v) H; exists V, E, C, g; rewrite mul2n.
Qed.

Lemma faceless_t3 : on -> t3 e s <-> t3_euler (flat t).
Proof.
move=> pl; split=> H v lv; have [V [E [C [N]]]] := H v lv.
  by case=> g eq /(_ pl) g0; exists V, E, C; split; [apply/faceless_counts | move: eq; rewrite g0 addn0].
by move=> eq; exists V, E, C; split; [apply/faceless_counts | exists 0; rewrite ?addn0].
Qed.

(** In the plane T4 follows from T3. *)
Lemma faceless_t4 : t3_euler (flat t) -> t4 e s.
Proof.
move=> t3 _ sim vs es fs Hv He Hf V3; split.
  have plain : simple (flat t) by apply: (@same_simple (flat t) sf so si).
  exact: (edges_bound low t3 plain Hv (least_edges_each low He) V3).
have -> : fs = [::] by case: fs Hf => // f fs [_ /(_ f)]; rewrite mem_head => -[/(_ isT)].
by rewrite /=; arith.
Qed.

(** T3 says that the rotation system can be drawn. *)
Lemma t3_drawn r : represents_rotations t r -> t3_euler (flat t) <-> plane_system r.
Proof.
case=> nv [nd rep]; have [es Hes] := edges_each low; rewrite (t3_sums low Hes).
have formula edges : every_edge (@opposite r) edges ->
    size (rotations (flat t)) + size (cycles (flat t)) + (handles (@around r) (@opposite r) edges).*2
    = size es + (size (pieces (flat t))).*2.
  move=> every; apply: (@numbered_euler (flat t) (arcs r) (@around r) (@opposite r) nd (half_edge t)) every
    (rotations_each low) (cycles_each low) Hes (pieces_each low).
  - exact: opposite_back.
  - exact: opposite_differs.
  - exact: nd_inj rep.
  - by move=> h; split=> [/(arc_of rep)|[x <-]]; [|apply: nd_live rep x].
  - by move=> x; case: (says_of_arc rep x).
  - by move=> x; case: (says_of_arc rep x).
  by move=> x; case: (says_of_arc rep x).
split=> [eq|[edges every /drawnP d]]; last by rewrite -(formula _ every) d addn0.
have [edges every] := every_edge_exists (@opposite_back r) (@opposite_differs r); exists edges => //.
by apply/drawnP; have := formula _ every; arith.
Qed.

End Kept.
End Closed.

(** On closed surfaces the rules mean rotation systems: the genus of a component is a number whatever it is. *)
Theorem faceless_surface : rules_of surface s <-> exists r, represents_rotations t r.
Proof.
rewrite -surface_rules_mean_rotations -(rules_before_t3 false); split=> [H r _|/rules_before_t3 keeps]; first exact: H.
have H := (rules_before_t3 false).2 keeps; case=> [r|[] //]; case: (ltnP (index r) (index T3)) => [/H //|].
case: r => // _ v lv; have [V [E [C [g [N eq]]]]] := has_genus keeps lv.
by exists V, E, C; split; [apply/(faceless_counts false keeps) | exists g].
Qed.

(** In the plane they mean rotation systems that can be drawn, edge by edge. *)
Theorem faceless_plane : rules_of plane s <-> exists r, represents_rotations t r /\ plane_system r.
Proof.
split=> [H|[r [rep d]]].
  have keeps := (rules_before_t3 true).1 (fun r _ => H (Basic r)).
  have [r rep] := (surface_rules_mean_rotations t).1 keeps; exists r; split=> //.
  by apply/(t3_drawn keeps rep)/(faceless_t3 keeps isT)/(H (Basic T3)).
have keeps : surface_rules t by apply/surface_rules_mean_rotations; exists r.
have H := (rules_before_t3 true).2 keeps; have t3 := (t3_drawn keeps rep).2 d.
case=> [q|[] //]; case: (ltnP (index q) (index T3)) => [/H //|]; case: q => // _.
  exact/(faceless_t3 keeps isT).
exact: (faceless_t4 keeps t3).
Qed.

End Faceless.
