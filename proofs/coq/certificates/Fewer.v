(** * Fewer: tests that follow from the others, for a checker that decides only

    A checker that names the tests that fail runs them all. One that only decides may leave out some, as they follow:

    - [next (prev h) = h], by counting: where [prev (next h) = h] for all half-edges, [next] is injective, so that it reaches each of them.
    - That the origin keeps a half-edge, and that the boundary component starts with one: in the plane, and on surfaces of genus 0 ([few_spheres]). The view without vertices and boundary
      components ([skeleton]) has the same rotations, cycles and pieces, and Euler's formula holds in it. So if the sums fit, each rotation
      has a half-edge that a vertex keeps, and each cycle one with which a boundary component starts.
    - What a face lists, by counting: different boundary components say different places, and each of these lists them. Where there
      are no more entries than boundary components, no entry is left. *)

From mathcomp Require Import all_ssreflect all_fingroup.
From twinedge Require Import Arith View Rules Loops LoopsProof Reference Map Counting ReferenceProof TopologyProof.
From twinedge Require Import Drawing Euler Numbered Genus WholeEuler Labels OneOfEach Orbits LabelsSound.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** ** Half-edges *)

(** The half-edges alone: all start at one vertex, and have one boundary component. *)
Definition skeleton t : view := {|
  vertex_slots := 1; half_edge_slots := half_edge_slots t; boundary_slots := 1; face_slots := 0;
  is_vertex := predT; is_half_edge := is_half_edge t; is_boundary := predT; is_face := predT;
  says_origin := fun _ => Some 0; says_twin := says_twin t; says_next := says_next t; says_prev := says_prev t;
  says_boundary := fun _ => Some 0; says_leaving := fun _ => None; says_isolated := fun _ => None;
  says_boundary_face := fun _ => None; says_boundary_start := fun _ => None; says_boundary_place := fun _ => None;
  says_outer := fun _ => None; says_inner_count := fun _ => 0; says_inner := fun _ _ => None |}.

Section Fewer.
Variable t : view.
Hypothesis twins : forall h, half_edge t h -> twin_ok t h.
Hypothesis nexts : forall h, half_edge t h -> next t h >>= prev t = Some h.

Lemma next_lives h : half_edge t h -> exists2 g, next t h = Some g & half_edge t g.
Proof.
move=> /nexts; case: (next t h) => [g|] //= E; exists g => //; exact: heard_live E.
Qed.

(** By counting. *)
Lemma prev_back h : half_edge t h -> next_ok t h.
Proof.
move=> lh; rewrite /next_ok nexts // /same_link eqxx /=.
pose T := [finType of slot (half_edge_slots t) (half_edge t)].
pose f : T -> T := step (next t).
have fE (x : T) : next t (num x) = Some (num (f x)) := says_step (@half_edge_below t) next_lives x.
have inj : injective f.
  move=> x y xy; apply/num_inj; have := nexts (num_live x); have := nexts (num_live y).
  by rewrite !fE /= xy => -> [->].
have [x xh] := slotP (@half_edge_below t) lh.
have /codomP[y yx] := injF_onto inj x.
have := nexts (num_live y); rewrite fE /= -yx xh => ->.
by rewrite /= fE -yx xh.
Qed.

Lemma skeleton_map : is_map (skeleton t).
Proof.
have twinL h : half_edge t h -> exists2 k, twin t h = Some k & half_edge t k.
  move=> /twins/andP[/same_linkP tt _]; case E: (twin t h) tt => [k|] //= tt; exists k => //; exact: heard_live tt.
have prevL h : half_edge t h -> exists2 k, prev t h = Some k & half_edge t k.
  move=> /prev_back/andP[_ /same_linkP pn]; case E: (prev t h) pn => [k|] //= pn; exists k => //; exact: heard_live pn.
have org0 h : half_edge t h -> origin (skeleton t) h = Some 0 by move=> lh; rewrite /origin /heard (lh : half_edge (skeleton t) h).
have bnd0 h : half_edge t h -> boundary_of (skeleton t) h = Some 0.
  by move=> lh; rewrite /boundary_of /heard (lh : half_edge (skeleton t) h).
split=> h lh.
- split; [|exact: twinL lh|exact: next_lives lh|exact: prevL lh|].
  + by exists 0 => //; apply: org0.
  by exists 0 => //; apply: bnd0.
- by have /andP[/same_linkP tt /same_linkP ne] := twins (lh : half_edge t h).
- by have /andP[/same_linkP a /same_linkP b] := prev_back (lh : half_edge t h).
have [g ng lg] := next_lives (lh : half_edge t h); have [k tk lk] := twinL h lh.
by rewrite (ng : next (skeleton t) h = Some g) (tk : twin (skeleton t) h = Some k) /= !org0.
Qed.

Lemma skeleton_basics : basics (skeleton t).
Proof.
split; first exact: skeleton_map.
- by move=> v h; rewrite /leaving /heard; case: ifP.
- by move=> b h; rewrite /boundary_start /heard; case: ifP.
move=> x; rewrite /bnd /boundary_of /heard (dart_live x).
by rewrite (dart_live (nx x)).
Qed.

(** *** Ranks lead to roots *)

Lemma roots_reach (rank : nat -> nat) (roots : seq nat) : (forall h, h \in roots -> half_edge t h) ->
  (forall h, half_edge t h -> h \in roots \/ [|| lower_than rank h (next t h), lower_than rank h (prev t h) | lower_than rank h (twin t h)]) ->
  forall h, half_edge t h -> exists2 g, g \in roots & reached (near t) g h.
Proof.
move=> live down; have map := skeleton_map; have basic := skeleton_basics.
have reach (x : dart (skeleton t)) : exists2 g, g \in roots & reached (near t) (num x) g.
  move: {2}(rank _).+1 (ltnSn (rank (num x))) => n; elim: n x => // n IH x lt.
  have step (y : dart (skeleton t)) : num y \in near (skeleton t) (num x) -> rank (num y) < rank (num x) ->
      exists2 g, g \in roots & reached (near t) (num x) g.
    move=> near_y lower; have [|g gr r] := IH y; first exact: leq_trans lower lt.
    by exists g => //; apply: reached_trans r; apply: reached_near near_y; apply: reached_self.
  have := down _ (dart_live x : half_edge t (num x)).
  rewrite (nextE map x : next t (num x) = _) (prevE map x : prev t (num x) = _) (twinE map x : twin t (num x) = _) /=.
  case=> [xr|/or3P[lower|lower|lower]].
  - by exists (num x) => //; apply: reached_self.
  - by apply: (step (nx x)) => //; rewrite (near_dart map) !inE eqxx.
  - by apply: (step (pv x)) => //; rewrite (near_dart map) !inE eqxx orbT.
  by apply: (step (tw x)) => //; rewrite (near_dart map) !inE eqxx !orbT.
move=> h lh; have [x xh] := dartP (lh : half_edge (skeleton t) h); have [g gr r] := reach x; exists g => //.
by rewrite -xh; apply: (reached_back basic) r; [exact: dart_live|exact: live].
Qed.

(** *** Each rotation has a vertex, each cycle a boundary component *)

Hypothesis targets : forall h, half_edge t h -> next t h >>= origin t = twin t h >>= origin t.
Hypothesis same : forall h, half_edge t h -> next t h >>= boundary_of t = boundary_of t h.
Hypothesis keeps : forall v h, leaving t v = Some h -> half_edge t h /\ origin t h = Some v.
Hypothesis starts : forall b h, boundary_start t b = Some (AtHalfEdge h) -> half_edge t h /\ boundary_of t h = Some b.
Variable roots : seq nat.
Hypothesis roots_live : forall h, h \in roots -> half_edge t h.
Hypothesis roots_cover : forall h, half_edge t h -> exists2 g, g \in roots & reached (near t) g h.
Hypothesis sums : 2 * (rotation_count t + cycle_count t) = half_edge_count t + 4 * size roots.

Lemma orbit_says (T : Type) (says : nat -> option T) step : (forall g h, step g = Some h -> half_edge t g -> half_edge t h /\ says h = says g) ->
  forall g h, half_edge t g -> on_orbit step g h -> half_edge t h /\ says h = says g.
Proof.
move=> H g h lg [n]; elim: n h => [|n IH] h /=; first by case=> <-.
case E: (iter n _ _) => [k|] //= kh; have [lk <-] := IH k E; exact: H kh lk.
Qed.

Lemma origin_orbit g h : half_edge t g -> on_orbit (turn t) g h -> half_edge t h /\ origin t h = origin t g.
Proof.
apply: orbit_says => {g h} g h + lg; rewrite /turn; have /andP[/same_linkP tt _] := twins lg.
case E: (twin t g) tt => [k|] //= tt kh; have lk := heard_live tt; have [l E' ll] := next_lives lk.
by move: kh (targets lk); rewrite E' tt /= => -[<-].
Qed.

Lemma boundary_orbit g h : half_edge t g -> on_cycle t g h -> half_edge t h /\ boundary_of t h = boundary_of t g.
Proof.
apply: orbit_says => {g h} g h E lg; have [k E' lk] := next_lives lg.
by move: E (same lg); rewrite E' /= => -[<-].
Qed.

Lemma rotation_kept v : v \in with_edges t -> leaving t v = Some (kept t v).
Proof. by rewrite mem_filter /kept => /andP[+ _]; case: (leaving t v). Qed.

Lemma cycle_started b : b \in [seq b <- iota 0 (boundary_slots t) | cyclic t b] -> boundary_start t b = Some (AtHalfEdge (start_of t b)).
Proof. by rewrite mem_filter /cyclic /start_of => /andP[+ _]; case: (boundary_start t b) => [[]|]. Qed.

Lemma every_orbit h : half_edge t h ->
  (exists v g, [/\ leaving t v = Some g, origin t h = Some v & on_orbit (turn t) g h]) /\
  (exists b g, [/\ boundary_start t b = Some (AtHalfEdge g), boundary_of t h = Some b & on_cycle t g h]).
Proof.
have map := skeleton_map; have basic := skeleton_basics.
have [vs [cs [es [g [Hv Hc _ E formula]]]]] := orbit_formula basic; have Hp := piece_list basic.
have rl x : x \in rotations t -> half_edge t x by case/mapP=> v /rotation_kept/keeps[l _] ->.
have cl x : x \in cycles t -> half_edge t x by case/mapP=> b /cycle_started/starts[l _] ->.
have ru : uniq (rotations t).
  rewrite map_inj_in_uniq ?filter_uniq ?iota_uniq // => v w /rotation_kept/keeps[_ ov] /rotation_kept/keeps[_ ow] vw.
  by move: ov; rewrite vw ow => -[].
have cu : uniq (cycles t).
  rewrite map_inj_in_uniq ?filter_uniq ?iota_uniq // => b c /cycle_started/starts[_ ob] /cycle_started/starts[_ oc] bc.
  by move: ob; rewrite bc oc => -[].
have rd x y : x \in rotations t -> y \in rotations t -> on_orbit (turn t) x y -> x = y.
  case/mapP=> v /rotation_kept kv -> /mapP[w /rotation_kept kw ->] xy; have [lv ov] := keeps kv; have [_ ow] := keeps kw.
  by have [_] := origin_orbit lv xy; rewrite ow ov => -[->].
have cd x y : x \in cycles t -> y \in cycles t -> on_cycle t x y -> x = y.
  case/mapP=> v /cycle_started kv -> /mapP[w /cycle_started kw ->] xy; have [lv ov] := starts kv; have [_ ow] := starts kw.
  by have [_] := boundary_orbit lv xy; rewrite ow ov => -[->].
have le1 : size (rotations t) <= size vs by have := different_le (turn_sym map) (@orbit_trans (turn t)) Hv ru rl rd.
have le2 : size (cycles t) <= size cs by have := different_le (cycle_sym map) (@orbit_trans (next t)) Hc cu cl cd.
have tr : forall g h k, reached (near t) g h -> reached (near t) h k -> reached (near t) g k by move=> *; apply: reached_trans; eauto.
have le3 : size (pieces (skeleton t)) <= size roots by have := cover_le (reached_back basic) tr Hp roots_live roots_cover.
have E' : half_edge_count t = (size es).*2 := E.
move: sums; rewrite rotations_count cycles_count E' => sums'.
have e1 : size vs <= size (rotations t) by arith.
have e2 : size cs <= size (cycles t) by arith.
have [_ _ _ allv] := different_all (turn_sym map) (@orbit_trans (turn t)) Hv (orbit_decided (on_rotationE map)) ru rl rd e1.
have [_ _ _ allc] := different_all (cycle_sym map) (@orbit_trans (next t)) Hc (orbit_decided (on_cycleE map)) cu cl cd e2.
move=> lh; split.
  have [_ /mapP[v /rotation_kept kv ->] xh] := allv h lh; have [lv ov] := keeps kv.
  by exists v, (kept t v); split=> //; have [_ ->] := origin_orbit lv xh.
have [_ /mapP[b /cycle_started kb ->] xh] := allc h lh; have [lb ob] := starts kb.
by exists b, (start_of t b); split=> //; have [_ ->] := boundary_orbit lb xh.
Qed.

Lemma every_origin h : half_edge t h -> origin_ok t h.
Proof. by case/every_orbit=> -[v [g [Ev Eo _]]] _; rewrite /origin_ok Eo /= Ev. Qed.

Lemma every_cycle h : half_edge t h -> cycle_ok t h.
Proof.
move=> lh; have [_ [b [g [Eb Ec _]]]] := every_orbit lh; rewrite /cycle_ok same //.
by apply/andP; split; [apply/same_linkP|rewrite Ec /cycle_start /= Eb].
Qed.

End Fewer.

(** ** Lists of faces *)

Definition entry_count t := sumn [seq ~~ is_nil (outer t f) + inner_count t f | f <- iota 0 (face_slots t)].

Section Lists.
Variable t : view.
Hypothesis boundaries : forall b, boundary t b -> place_ok t b.
Hypothesis count : entry_count t <= number (boundary_slots t) (boundary t).

(** An entry is a face and a number: 0 for the outer boundary component, i + 1 for inner ones. *)
Definition codes f := (if is_nil (outer t f) then [::] else [:: 0]) ++ iota 1 (inner_count t f).
Definition entries := [seq (f, k) | f <- iota 0 (face_slots t), k <- codes f].
Definition coded k : place := if k is i.+1 then Inner i else Outer.
Definition named b := (odflt 0 (boundary_face t b), if boundary_place t b is Some (Inner i) then i.+1 else 0).
Definition boundary_list := [seq b <- iota 0 (boundary_slots t) | boundary t b].

Lemma boundary_entry b : boundary t b ->
  [/\ face t (named b).1, boundary_face t b = Some (named b).1, boundary_place t b = Some (coded (named b).2)
    & listed t (named b).1 (coded (named b).2) = Some b].
Proof.
move/boundaries; rewrite /place_ok /named; case: (boundary_face t b) => [f|] //.
by case: (boundary_place t b) => [[|i]|] // /andP[lf /same_linkP L].
Qed.

Lemma entries_named : [seq named b | b <- boundary_list] =i entries.
Proof.
have live b : b \in boundary_list -> boundary t b by rewrite mem_filter => /andP[].
have u : uniq [seq named b | b <- boundary_list].
  rewrite map_inj_in_uniq ?filter_uniq ?iota_uniq // => b c /live/boundary_entry[_ _ _ Lb] /live/boundary_entry[_ _ _ Lc] bc.
  by move: Lb; rewrite bc Lc => -[].
have sub : {subset [seq named b | b <- boundary_list] <= entries}.
  move=> _ /mapP[b /live/boundary_entry[lf _ _ L] ->]; case: (named b) lf L => f k /= lf L.
  apply/allpairsPdep; exists f, k; split=> //; first by rewrite mem_iota add0n face_below.
  rewrite mem_cat; case: k L => [|i] /= L; first by rewrite L.
  by apply/orP; right; rewrite mem_iota add1n /= ltnS; apply: inner_lt L.
have le : size entries <= size [seq named b | b <- boundary_list].
  rewrite size_map size_filter -numberE; apply: leq_trans count; rewrite size_allpairs_dep /entry_count.
  rewrite (@eq_map _ _ (fun f => size (codes f)) (fun f => ~~ is_nil (outer t f) + inner_count t f)) // => f.
  by rewrite /codes size_cat size_iota; case: (is_nil _).
by have [_] := uniq_min_size u sub le.
Qed.

Lemma every_face f : face t f -> face_ok t f.
Proof.
move=> lf; have lists k : k \in codes f -> entry_ok t f (coded k) (listed t f (coded k)).
  move=> kf; have : (f, k) \in entries.
    by apply/allpairsPdep; exists f, k; split=> //; rewrite mem_iota add0n face_below.
  rewrite -entries_named => /mapP[b]; rewrite mem_filter => /andP[lb _] E.
  have := boundary_entry lb; rewrite -E => -[_ Ef Ep ->]; move: Ef Ep => /= Ef Ep.
  rewrite /entry_ok /leads lb /= /names_place Ef Ep; apply/andP; split; first exact/same_linkP.
  by case: (k) => /=.
apply/andP; split.
  case E: (is_nil (outer t f)) => //=; apply: (lists 0).
  by rewrite mem_cat E inE.
apply/all_belowP=> i lt; apply: (lists i.+1); rewrite mem_cat; apply/orP; right.
by rewrite mem_iota add1n /= ltnS.
Qed.

End Lists.

(** ** The plane *)

Section Plane.
Variables (t : view) (rank : nat -> nat).

Definition few_half_edge_ok h :=
  [&& twin_ok t h, same_link (next t h >>= prev t) (Some h), target_ok t h,
      same_link (next t h >>= boundary_of t) (boundary_of t h) & rank_ok t rank h].

Definition few_accept :=
  [&& each_half_edge t few_half_edge_ok, each_vertex t (vertex_ok t), each_boundary t (boundary_ok t),
      entry_count t <= number (boundary_slots t) (boundary t) & one_unbounded t && euler_ok t].

Theorem few_suffice : few_accept -> accepts t rank.
Proof.
case/and5P=> /each_half_edgeP H /each_vertexP V /each_boundaryP B count /andP[unbounded euler].
have twins h : half_edge t h -> twin_ok t h by case/H/and5P.
have nexts h : half_edge t h -> next t h >>= prev t = Some h by case/H/and5P=> _ /same_linkP.
have targets h : half_edge t h -> next t h >>= origin t = twin t h >>= origin t by case/H/and5P=> _ _ /same_linkP.
have same h : half_edge t h -> next t h >>= boundary_of t = boundary_of t h by case/H/and5P=> _ _ _ /same_linkP.
have keeps v h : leaving t v = Some h -> half_edge t h /\ origin t h = Some v.
  by move=> E; have := V v (heard_live E); rewrite /vertex_ok E => /and3P[lh /same_linkP].
have starts b h : boundary_start t b = Some (AtHalfEdge h) -> half_edge t h /\ boundary_of t h = Some b.
  by move=> E; have /andP[+ _] := B b (heard_live E); rewrite /start_ok E => /andP[lh /same_linkP].
have roots_live h : h \in roots_of t -> half_edge t h.
  case/mapP=> b; rewrite mem_filter /cycle_start /start_of => /andP[/andP[+ _] _].
  by case E: (boundary_start t b) => [[g|]|] //= _ ->; case: (starts _ _ E).
have roots_cover : forall h, half_edge t h -> exists2 g, g \in roots_of t & reached (near t) g h.
  apply: (roots_reach (rank := rank) twins nexts roots_live) => h lh; have /and5P[_ _ _ _] := H h lh.
  by case/or4P=> [->|->|->|/is_rootP[b [_ _ hr _]]]; rewrite ?orbT; [right|right|right|left].
have sums : 2 * (rotation_count t + cycle_count t) = half_edge_count t + 4 * size (roots_of t).
  by rewrite -roots_count; apply/eqP.
apply/and5P; split; last by rewrite unbounded euler.
- apply/each_half_edgeP=> h lh; have /and5P[tw _ ta _ ra] := H h lh.
  rewrite /half_edge_ok tw ta ra (prev_back nexts lh) (every_origin twins nexts targets same keeps starts roots_live roots_cover sums lh).
  by rewrite (every_cycle twins nexts targets same keeps starts roots_live roots_cover sums lh).
- exact/each_vertexP.
- exact/each_boundaryP.
by apply/each_faceP=> f lf; apply: (every_face _ count lf) => b /B/andP[].
Qed.

End Plane.
