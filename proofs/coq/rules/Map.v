(** * Map: half-edges as a finite type

    Where R1 to L3 hold, the links between half-edges are total functions on a finite type, and `next`, `prev`, `twin`
    and `turn` are permutations of it. All that follows is said of this type, [dart]. *)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import Arith View Rules Loops LoopsProof Reference.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Lemma half_edge_below t h : half_edge t h -> h < half_edge_slots t. Proof. by case/andP. Qed.
Lemma vertex_below t v : vertex t v -> v < vertex_slots t. Proof. by case/andP. Qed.
Lemma boundary_below t b : boundary t b -> b < boundary_slots t. Proof. by case/andP. Qed.
Lemma face_below t f : face t f -> f < face_slots t. Proof. by case/andP. Qed.

Lemma heard_live T live (says : nat -> option T) i x : heard live says i = Some x -> live i.
Proof. by rewrite /heard; case: ifP. Qed.

(** The demands of R1 to L3 on half-edges. *)
Definition is_map t := [/\ half_edges_live t, l1_twin t, l2_next_prev t & l3_target t].

Section Map.
Variable t : view.
Hypothesis map : is_map t.

Definition dart : finType := [finType of slot (half_edge_slots t) (half_edge t)].
Implicit Types x y : dart.

Definition tw : dart -> dart := step (twin t).
Definition nx : dart -> dart := step (next t).
Definition pv : dart -> dart := step (prev t).
Definition tn x : dart := nx (tw x).
Definition org x : nat := odflt 0 (origin t (num x)).
Definition bnd x : nat := odflt 0 (boundary_of t (num x)).

Lemma dart_live x : half_edge t (num x). Proof. exact: num_live. Qed.

Lemma dartP h : half_edge t h -> exists x : dart, num x = h.
Proof. exact: slotP (@half_edge_below t) h. Qed.

Lemma twin_total h : half_edge t h -> exists2 g, twin t h = Some g & half_edge t g.
Proof. by case: map => H _ _ _ /H[_ ? _ _ _]. Qed.
Lemma next_total h : half_edge t h -> exists2 g, next t h = Some g & half_edge t g.
Proof. by case: map => H _ _ _ /H[_ _ ? _ _]. Qed.
Lemma prev_total h : half_edge t h -> exists2 g, prev t h = Some g & half_edge t g.
Proof. by case: map => H _ _ _ /H[_ _ _ ? _]. Qed.

Lemma twinE x : twin t (num x) = Some (num (tw x)).
Proof. exact: (says_step (@half_edge_below t) twin_total). Qed.
Lemma nextE x : next t (num x) = Some (num (nx x)).
Proof. exact: (says_step (@half_edge_below t) next_total). Qed.
Lemma prevE x : prev t (num x) = Some (num (pv x)).
Proof. exact: (says_step (@half_edge_below t) prev_total). Qed.

Lemma originE x : origin t (num x) = Some (org x).
Proof. by case: map => /(_ _ (dart_live x))[[v E _] _ _ _ _] _ _ _; rewrite /org E. Qed.
Lemma boundaryE x : boundary_of t (num x) = Some (bnd x).
Proof. by case: map => /(_ _ (dart_live x))[_ _ _ _ [b E _]] _ _ _; rewrite /bnd E. Qed.

Lemma org_live x : vertex t (org x).
Proof. by case: map => /(_ _ (dart_live x))[[v E l] _ _ _ _] _ _ _; rewrite /org E. Qed.
Lemma bnd_live x : boundary t (bnd x).
Proof. by case: map => /(_ _ (dart_live x))[_ _ _ _ [b E l]] _ _ _; rewrite /bnd E. Qed.

Lemma originP h v : origin t h = Some v <-> exists2 x : dart, num x = h & org x = v.
Proof.
split=> [E|[x <- <-]]; last exact: originE.
by case: (dartP (heard_live E)) => x xh; exists x => //; move: E; rewrite -xh originE => -[].
Qed.

Lemma twK : involutive tw.
Proof. by case: map => _ H _ _ x; have [] := H _ (dart_live x); rewrite twinE /= twinE => -[/num_inj]. Qed.
Lemma tw_neq x : tw x != x.
Proof. by case: map => _ H _ _; have [_ ne] := H _ (dart_live x); apply/eqP=> E; case: ne; rewrite twinE E. Qed.
Lemma nxK : cancel nx pv.
Proof. by case: map => _ _ H _ x; have [] := H _ (dart_live x); rewrite nextE /= prevE => -[/num_inj]. Qed.
Lemma pvK : cancel pv nx.
Proof. by case: map => _ _ H _ x; have [_] := H _ (dart_live x); rewrite prevE /= nextE => -[/num_inj]. Qed.
Lemma org_nx x : org (nx x) = org (tw x).
Proof. by case: map => _ _ _ H; have := H _ (dart_live x); rewrite nextE twinE /= !originE => -[]. Qed.

Lemma tw_inj : injective tw. Proof. exact: inv_inj twK. Qed.
Lemma nx_inj : injective nx. Proof. exact: can_inj nxK. Qed.
Lemma tn_inj : injective tn. Proof. by move=> x y /nx_inj/tw_inj. Qed.

Lemma turnE x : turn t (num x) = Some (num (tn x)).
Proof. by rewrite /turn twinE /= nextE. Qed.
Lemma targetE x : target t (num x) = Some (org (tw x)).
Proof. by rewrite /target twinE /= originE. Qed.
Lemma org_tn x : org (tn x) = org x.
Proof. by rewrite /tn org_nx twK. Qed.
Lemma turn_total h : half_edge t h -> exists2 g, turn t h = Some g & half_edge t g.
Proof. by case/dartP=> x <-; rewrite turnE; exists (num (tn x)); rewrite ?dart_live. Qed.
Lemma step_turn x : step (turn t) x = tn x.
Proof. exact: stepP (turnE x). Qed.

Lemma on_cycleE x y : on_cycle t (num x) (num y) <-> fconnect nx x y.
Proof. exact: (on_orbit_step (@half_edge_below t) next_total). Qed.

Lemma on_rotationE x y : on_orbit (turn t) (num x) (num y) <-> fconnect tn x y.
Proof. by rewrite (on_orbit_step (@half_edge_below t) turn_total) (eq_fconnect step_turn). Qed.

Lemma cycle_sym g h : half_edge t g -> half_edge t h -> on_cycle t g h -> on_cycle t h g.
Proof. by case/dartP=> x <- /dartP[y <-]; rewrite !on_cycleE fconnect_sym //; apply: nx_inj. Qed.

Lemma turn_sym g h : half_edge t g -> half_edge t h -> on_orbit (turn t) g h -> on_orbit (turn t) h g.
Proof. by case/dartP=> x <- /dartP[y <-]; rewrite !on_rotationE fconnect_sym //; apply: tn_inj. Qed.

Lemma orbit_trans says (i j k : nat) : on_orbit says i j -> on_orbit says j k -> on_orbit says i k.
Proof. by case=> m Em [n En]; exists (n + m); rewrite iterD Em. Qed.

(** ** Pieces: the half-edges that `next`, `prev` and `twin` lead to *)

Lemma near_dart x : near t (num x) = [:: num (nx x); num (pv x); num (tw x)].
Proof. by rewrite /near nextE prevE twinE. Qed.

Lemma near_live h g : half_edge t h -> g \in near t h -> half_edge t g.
Proof. by case/dartP=> x <-; rewrite near_dart !inE => /or3P[] /eqP->; apply: dart_live. Qed.

Lemma near_sym h g : half_edge t h -> g \in near t h -> h \in near t g.
Proof.
case/dartP=> x <-; rewrite near_dart !inE => /or3P[] /eqP->; rewrite near_dart !inE.
- by rewrite nxK eqxx orbT.
- by rewrite pvK eqxx.
- by rewrite twK eqxx !orbT.
Qed.

Lemma near_size h : size (near t h) <= 3.
Proof. by rewrite /near; case: (next t h); case: (prev t h); case: (twin t h). Qed.

Lemma near_enough : sumn [seq size (near t h) | h <- iota 0 (half_edge_slots t)] + 1 < (4 * half_edge_slots t).+2.
Proof.
have: sumn [seq size (near t h) | h <- iota 0 (half_edge_slots t)] <= 3 * size (iota 0 (half_edge_slots t)).
  by elim: (iota _ _) => //= h s; have := near_size h; arith.
by rewrite size_iota; arith.
Qed.

Definition joined x y := reached (near t) (num x) (num y).

Lemma joined_refl x : joined x x. Proof. exact: reached_self. Qed.
Lemma joined_sym x y : joined x y -> joined y x.
Proof. exact: reached_sym near_live near_sym _ _ (dart_live x). Qed.
Lemma joined_trans x y z : joined x y -> joined y z -> joined x z.
Proof. exact: reached_trans. Qed.
Lemma joined_nx x : joined x (nx x).
Proof. by apply: reached_near (reached_self _ _) _; rewrite near_dart mem_head. Qed.
Lemma joined_tw x : joined x (tw x).
Proof. by apply: reached_near (reached_self _ _) _; rewrite near_dart !inE eqxx !orbT. Qed.
Lemma joined_tn x : joined x (tn x).
Proof. exact: joined_trans (joined_tw x) (joined_nx _). Qed.
Lemma joined_orbit (f : dart -> dart) x y : (forall z, joined z (f z)) -> fconnect f x y -> joined x y.
Proof.
move=> H /iter_findex <-; elim: (findex _ _ _) => [|k IH]; first exact: joined_refl.
exact: joined_trans IH (H _).
Qed.

(** A property that passes from a half-edge to all that are near to it holds of all that are joined to it. *)
Lemma joined_ind (P : dart -> Prop) x y : (forall z, P z -> [/\ P (nx z), P (pv z) & P (tw z)]) ->
  joined x y -> P x -> P y.
Proof.
move=> H xy px; suff: forall h, reached (near t) (num x) h -> forall y, num y = h -> P y by apply; [exact: xy|].
move=> h; elim=> {xy y h} [y /num_inj-> //|h g xh IH hg y yg].
have [z zh] := dartP (reached_live near_live (dart_live x) xh).
have [p1 p2 p3] := H z (IH z zh); move: hg; rewrite -zh near_dart -yg !inE.
by case/or3P=> /eqP/num_inj->.
Qed.

(** ** Components: where V2 holds, pieces are components *)

Hypothesis rotation : v2_rotation t.

Lemma rotationE x y : fconnect tn x y = (org x == org y).
Proof.
have [H1 H2] := rotation (dart_live x) (dart_live y); rewrite !originE in H1 H2.
apply/idP/eqP => [/on_rotationE/H1[] //|E]; by apply/on_rotationE/H2; rewrite E.
Qed.

Lemma same_org_joined x y : org x = org y -> joined x y.
Proof. by move=> E; apply: joined_orbit joined_tn _; rewrite rotationE E. Qed.

Lemma connected_trans u v w : connected t u v -> connected t v w -> connected t u w.
Proof. by move=> uv; elim=> // h x y _ ux hx hy; apply: connected_edge ux hx hy. Qed.

Lemma connected_step x : connected t (org x) (org (tw x)).
Proof. exact: connected_edge (connected_self _ _) (originE x) (targetE x). Qed.

Lemma connected_sym u v : connected t u v -> connected t v u.
Proof.
elim=> [|h v' w uv IH]; first exact: connected_self.
case/originP=> x <- xv; rewrite targetE => -[<-]; apply: connected_trans IH; rewrite -xv.
by have := connected_step (tw x); rewrite twK.
Qed.

Lemma joined_connected x y : joined x y -> connected t (org x) (org y).
Proof.
move/(@joined_ind (fun y => connected t (org x) (org y))); apply; last exact: connected_self.
move=> z xz; have zt := connected_trans xz (connected_step z); split=> //; first by rewrite org_nx.
apply: connected_trans xz _; have := connected_step (tw (pv z)).
by rewrite twK -org_nx pvK.
Qed.

Lemma connected_joined x y : connected t (org x) (org y) -> joined x y.
Proof.
suff: forall v, connected t (org x) v -> forall y, org y = v -> joined x y by move=> H /H; apply.
move=> v {y}; elim=> [y /esym/same_org_joined //|h v' w _ IH /originP[z zh zv]].
rewrite -zh targetE => -[<-] y /esym/same_org_joined; apply: joined_trans.
exact: joined_trans (IH z zv) (joined_tw z).
Qed.

(** A vertex that is connected to another has half-edges. *)
Lemma connected_dart u v : connected t u v -> u = v \/ exists x y, [/\ org x = u, org y = v & joined x y].
Proof.
move=> uv; elim: {v} uv (uv) => [_|h v w uv IH /originP[z zh zv] + uw]; first by left.
rewrite -zh targetE => -[zw]; case: (IH uv) => [->|[x [y [xu yv xy]]]]; right.
  by exists z, (tw z); split=> //; apply: joined_tw.
exists x, (tw z); split=> //; apply: joined_trans xy _.
by apply: joined_trans (joined_tw z); apply: same_org_joined; rewrite yv.
Qed.

Lemma bareP v : (forall x, org x <> v) <-> bare t v.
Proof.
split=> [H h _ /originP[x _ /H] //|H x xv].
by apply: (H (num x)); rewrite ?dart_live // originE xv.
Qed.

Lemma connected_bare u v : bare t u -> connected t u v -> v = u.
Proof. by move=> /bareP H /connected_dart[-> //|[x [y [/H]]]]. Qed.

(** ** Labels *)

Lemma label_total x : exists r, labels t (num x) = Some r.
Proof. exact: flood_all_live (@half_edge_below t) near_live near_sym near_enough _ (dart_live x). Qed.

Lemma labelE x y : labels t (num x) = labels t (num y) <-> joined x y.
Proof.
have H := flood_allE (@half_edge_below t) near_live near_sym near_enough.
exact: (H _ _ (dart_live x) (dart_live y)).
Qed.

Lemma label_connected x y : labels t (num x) = labels t (num y) <-> connected t (org x) (org y).
Proof. by rewrite labelE; split; [apply: joined_connected | apply: connected_joined]. Qed.

Lemma label_live h r : labels t h = Some r -> half_edge t h.
Proof. by case/(flood_all_label (@half_edge_below t) near_live near_sym near_enough). Qed.

End Map.
