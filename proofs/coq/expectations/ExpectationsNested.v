(** * ExpectationsNested: lists of inner boundary components, in the plane, whose boundaries may be open

    What lists of holes say of a map that can be drawn. Each cycle has a face, which lists it once, or none. One of those that a face
    lists is its outer one; the others, and its isolated vertices, lie inside. A component lies inside one face at most, and deeper than
    the component that bounds this face.

<<
      ┌───────────────┐          depth 0: the outer square bounds the face f
      │ f   ┌───┐     │          depth 1: the small square and the vertex lie inside f
      │     └───┘  ·  │
      └───────────────┘
>>

    If the unbounded face is stored, it alone has no outer cycle, and each component without border lies inside some face. If it
    is not, each face has an outer cycle, and a component may lie nowhere: in the unbounded face. *)

From mathcomp Require Import all_ssreflect all_fingroup.
From twinedge Require Import View Rules Loops LoopsProof Reference ReferenceProof Map Counting Lists Subdivision Genus Bounds RotationSystem.
From twinedge Require Import Expectations ExpectationsCheck ExpectationsLists ExpectationsVerdict ExpectationsPlane ExpectationsFaceless.
From twinedge Require Import ExpectationsParts ExpectationsFaces ExpectationsBorder ExpectationsMissing ExpectationsOpenCounts ExpectationsOpen.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** ** Nested faces *)

Section Nested.
Variables (t : view) (unbounded : bool) (side : nat -> link) (entry : nat -> place -> option start).

(** Edges lead from one vertex to the other. *)
Definition edge_leads u w := exists2 h, origin t h = Some u & end_at t h = Some w.
Definition same_piece := walks edge_leads.

Definition start_vertex (st : option start) : link :=
  match st with Some (AtHalfEdge h) => origin t h | Some (AtVertex v) => Some v | None => None end.

(** The face [x.1] lists, inside, the component of [v]. *)
Definition lists_inside v (x : nat * place) := x.2 <> Outer /\ exists2 w, start_vertex (entry x.1 x.2) = Some w & same_piece v w.

(** The component of [v] has a half-edge without twin, or without face. *)
Definition has_border v := exists h w, [/\ origin t h = Some w, same_piece v w & twin t h = None \/ side h = None].

Definition is_place f p := face t f && (if p is Inner i then i < inner_count t f else true).

(** Each entry of a list is a cycle of the face or an isolated vertex; that may be no outer one. *)
Definition entry_fits f p :=
  match entry f p with
  | Some (AtHalfEdge h) => half_edge t h /\ side h = Some f
  | Some (AtVertex v) => [/\ vertex t v, bare t v & p <> Outer]
  | None => p = Outer
  end.

Record nested : Prop := Nested {
  nested_sides : forall h, half_edge t h -> leads_to (face t) (side h) \/ twin t h <> None /\ side h = None;
  nested_along : forall g h, half_edge t g -> half_edge t h -> on_cycle t g h -> side h = side g;
  nested_entries : forall f p, if is_place f p then entry_fits f p else entry f p = None;
  nested_once : forall h f, half_edge t h -> side h = Some f -> exists! p, exists2 g, entry f p = Some (AtHalfEdge g) & on_cycle t h g;
  nested_outer : if unbounded then exists! f, face t f /\ entry f Outer = None else forall f, face t f -> entry f Outer <> None;
  nested_inside : forall v, vertex t v -> one_or_none (lists_inside v) (~~ unbounded \/ has_border v);
  nested_depth : exists depth : nat -> nat, (forall u v, same_piece u v -> depth u = depth v) /\
    forall f i u v, start_vertex (entry f Outer) = Some u -> start_vertex (entry f (Inner i)) = Some v -> depth u < depth v
}.

End Nested.

(** The lists are no longer than what is listed, if nothing is listed twice. *)
Lemma lists_within (T : eqType) t (c : nat -> nat -> T) (A : seq T) :
  (forall f i, i < inner_count t f -> c f i \in A) ->
  (forall f i g j, i < inner_count t f -> j < inner_count t g -> c f i = c g j -> f = g /\ i = j) ->
  sumn [seq inner_count t f | f <- iota 0 (face_slots t)] <= size A.
Proof.
move=> inA inj; pose L f := [seq c f i | i <- iota 0 (inner_count t f)].
have u : uniq (flatten [seq L f | f <- iota 0 (face_slots t)]).
  apply: uniq_flatten; first exact: iota_uniq.
    move=> f _; rewrite map_inj_in_uniq ?iota_uniq // => i j; rewrite !mem_iota !add0n => li lj.
    by case/(inj f i f j li lj).
  move=> f g b _ _ /mapP[i]; rewrite mem_iota add0n => li -> /mapP[j]; rewrite mem_iota add0n => lj.
  by case/(inj f i g j li lj).
have sub : {subset flatten [seq L f | f <- iota 0 (face_slots t)] <= A}.
  by move=> b /flattenP[l /mapP[f _ ->] /mapP[i]]; rewrite mem_iota add0n => li ->; apply: inA.
have := uniq_leq_size u sub; rewrite size_flatten_map.
by have -> : [seq size (L f) | f <- iota 0 (face_slots t)] = [seq inner_count t f | f <- iota 0 (face_slots t)]
  by apply: eq_map => f; rewrite size_map size_iota.
Qed.

(** If each has a match of its own in a list, there are no more than the list has. *)
Lemma match_size (fs cs : seq nat) (R : nat -> nat -> Prop) : uniq fs -> (forall f, f \in fs -> exists2 y, y \in cs & R f y) ->
  (forall f g y, R f y -> R g y -> f = g) -> size fs <= size cs.
Proof.
elim: fs cs => //= f fs IH cs /andP[nf u] has_one own.
have [y yc fy] := has_one f (mem_head _ _); have := size_rem yc; have : 0 < size cs by case: (cs) yc.
have le : size fs <= size (rem y cs).
  apply: IH => // g gf; have [|z zc gz] := has_one g; first by rewrite inE gf orbT.
  exists z => //; move: zc; rewrite (perm_mem (perm_to_rem yc)) inE => /orP[/eqP zy|//].
  by rewrite zy in gz; move: nf; rewrite (own f g y) ?gf.
by move=> pos E; move: le; rewrite E -ltnS prednK.
Qed.

(** ** The number of faces *)

Section Bound.
Variables (t : view) (unbounded : bool) (side : nat -> link) (entry : nat -> place -> option start).
Hypothesis keeps : open_rules t.
Hypothesis n : nested t unbounded side entry.

Notation w := (whole t).
Let rotations := whole_rotations keeps.
Let low := flat_lower rotations.

Lemma entry_half_edge f p h : entry f p = Some (AtHalfEdge h) -> [/\ face t f, half_edge t h & side h = Some f].
Proof.
move=> E; have := nested_entries n f p; rewrite /entry_fits E; case P: (is_place t f p) => // -[lh S]; split=> //.
by case/andP: P.
Qed.

Lemma entry_vertex f p v : entry f p = Some (AtVertex v) -> [/\ face t f, vertex t v, bare t v & p <> Outer].
Proof.
move=> E; have := nested_entries n f p; rewrite /entry_fits E; case P: (is_place t f p) => // -[lv bv no]; split=> //.
by case/andP: P.
Qed.

(** No outer cycle passes along the half-edge of the whole. *)
Definition is_free h := half_edge w h /\ forall f g, entry f Outer = Some (AtHalfEdge g) -> ~ on_cycle w g h.

Lemma free_new h : lacks_twin t h -> is_free (beside t h).
Proof.
move=> bh; split; first by rewrite live_new.
move=> f g /entry_half_edge[_ lg _] /(cycle_old keeps _ lg)/(cycle_live_old keeps lg) l; exact: old_differs l (erefl _).
Qed.

Lemma free_old h : half_edge t h -> (forall f, side h = Some f -> entry f Outer = None) -> is_free h.
Proof.
move=> lh no; split; first exact: live_old.
move=> f g E; have [_ lg S] := entry_half_edge E => /(cycle_old keeps _ lg) c.
by rewrite (no f) // in E; rewrite (nested_along n lg lh c).
Qed.

Lemma piece_leaves v x h : origin t h = Some v -> same_piece t v x -> exists k, origin t k = Some x.
Proof.
move=> O; elim=> [|y z _ _ [k Ok E]]; first by exists h.
by move: E; rewrite /end_at; case: (next t k) => [m|] //= Em; exists m.
Qed.

(** If there are half-edges, and an unbounded face, one is free: at a border, or on the outermost component. *)
Lemma some_free h : unbounded -> half_edge t h -> exists h0, is_free h0.
Proof.
move=> ub; have [depth [same deeper]] := nested_depth n.
case B: (has (fun k => half_edge t k && (is_nil (twin t k) || is_nil (side k))) (iota 0 (half_edge_slots t))).
  case/hasP: B => k _ /andP[lk /orP[T|S]] _.
    by exists (beside t k); apply: free_new; rewrite /lacks_twin lk.
  by exists k; apply: free_old => // f E; rewrite E in S.
move: {2}(odflt 0 (omap depth (origin t h))) (leqnn (odflt 0 (omap depth (origin t h)))) => m.
elim/ltn_ind: m h => m IH h le lh; have [[v O lv] _ _ _] := lives keeps lh; rewrite O /= in le.
case: (nested_inside n lv) => [[[f [|i]] [[// _ [x X L]] _]]|[[nu|[k [x [Ok _ T]]]] _]]; last 2 first.
- by rewrite ub in nu.
- move/hasPn: (negbT B) => /(_ k); rewrite mem_iota half_edge_below ?(heard_live Ok) // => /(_ isT).
  by case: T => ->; rewrite ?orbT.
move: X; rewrite /= /start_vertex; case E: (entry f (Inner i)) => [[g|u]|] // X; last first.
  have [_ _ bu _] := entry_vertex E; have [k Ok] := piece_leaves O L; case: X => ux.
  by case: (bu k (heard_live Ok)); rewrite ux.
have [lf lg Sg] := entry_half_edge E.
case F: (entry f Outer) => [[g'|u]|].
- have [_ lg' _] := entry_half_edge F; have [[y Y _] _ _ _] := lives keeps lg'.
  have lt : depth y < m.
    apply: leq_trans le; rewrite (same _ _ L); apply: (deeper f i) => /=; by rewrite ?F ?E.
  by apply: (IH (depth y) lt g') => //; rewrite Y.
- by have [_ _ _] := entry_vertex F.
by exists g; apply: free_old => // f'; rewrite Sg => -[<-].
Qed.

Lemma face_bound fs : lists fs (face t) -> size fs <= maxn 1 (size (cycles (flat w))).
Proof.
move=> [u mem]; have [_ live _ each] := cycles_each low.
have rep h : half_edge w h -> exists2 y, y \in cycles (flat w) & on_cycle w y h by move=> lh; exact: each.
have back y h : y \in cycles (flat w) -> half_edge w h -> on_cycle w y h -> on_cycle w h y.
  by move=> yc lh; have ly : half_edge w y := live y yc; exact: (cycle_sym (whole_map keeps) ly lh).
pose outer_of f y := exists2 g, entry f Outer = Some (AtHalfEdge g) & on_cycle w g y.
have own f g y : outer_of f y -> outer_of g y -> f = g.
  move=> [h E c] [k K d]; have [_ lh Sh] := entry_half_edge E; have [_ lk Sk] := entry_half_edge K.
  have hk : on_cycle t h k.
    apply/(cycle_old keeps _ lh); apply: orbit_trans c _; have ly := cycle_live keeps (live_old lk) d.
    exact: (cycle_sym (whole_map keeps) (live_old lk) ly d).
  by have := nested_along n lh lk hk; rewrite Sh Sk => -[].
have bounded f : face t f -> entry f Outer <> None -> exists2 y, y \in cycles (flat w) & outer_of f y.
  move=> lf; case E: (entry f Outer) => [[g|v]|] // _; last by have [_ _ _] := entry_vertex E.
  have [_ lg _] := entry_half_edge E; have [y yc yg] := rep g (live_old lg); exists y => //; exists g => //.
  exact: back yc (live_old lg) yg.
have := nested_outer n; case ub: unbounded; last first.
  move=> all; rewrite leq_max (@match_size fs _ outer_of) ?orbT // => f /mem lf; exact: bounded lf (all f lf).
move=> [f0 [[l0 E0] one]].
case B: (has (half_edge t) (iota 0 (half_edge_slots t))); last first.
  have sub : {subset fs <= [:: f0]}.
    move=> f /mem lf; rewrite inE; apply/eqP/esym/one; split=> //; case E: (entry f Outer) => [[g|v]|] //.
      have [_ lg _] := entry_half_edge E; move/hasPn: (negbT B) => /(_ g); by rewrite mem_iota half_edge_below // lg => /(_ isT).
    by have [_ _ _] := entry_vertex E.
  by rewrite leq_max (uniq_leq_size u sub).
case/hasP: B => h _ lh; have [h0 [l free]] := some_free ub lh.
rewrite leq_max (@match_size fs _ (fun f y => outer_of f y \/ f = f0 /\ on_cycle w h0 y)) ?orbT // => [f /mem lf|f g y].
  case E: (entry f Outer) => [st|].
    by have [|y yc o] := bounded f lf; [rewrite E|exists y => //; left].
  have [y yc yh] := rep h0 l; exists y => //; right; split; last exact: back yc l yh.
  by apply/esym/one.
have clash f' : outer_of f' y -> ~ on_cycle w h0 y.
  move=> [k K c] d; have [_ lk _] := entry_half_edge K; apply: (free f' k K); apply: orbit_trans c _.
  have ly := cycle_live keeps l d; exact: (cycle_sym (whole_map keeps) l ly d).
case=> [o|[-> d]]; case=> [o'|[-> d']] //; [exact: own o o'|by case: (clash f o)|by case: (clash g o')].
Qed.

End Bound.

(** ** T1 and T2, with records for boundary components or without *)

Section Common.
Variables (t : view) (records places unbounded : bool) (sf so : nat -> link) (si : nat -> nat -> option start).
Let e := open_on true.
Let s := Structure t (Parts true true true records places true unbounded) sf so si.
Hypothesis keeps : open_rules t.

Variables (face_side : nat -> link).
Hypothesis side_nil : forall h, half_edge t h -> is_nil (side e s h) = is_nil (face_side h).

Lemma linked_piece u w : linked e s u w <-> same_piece t u w.
Proof.
apply: walks_iff => x y; split=> -[h O E]; exists h => //.
  by rewrite -E; apply/esym/(end_ofE _ _ _ _ _ _ _ _ _ keeps); apply: heard_live O.
by rewrite -E; apply: (end_ofE _ _ _ _ _ _ _ _ _ keeps); apply: heard_live O.
Qed.

Lemma piece_sym u w : same_piece t u w -> same_piece t w u.
Proof.
elim=> [|x y _ IH [h O E]]; first exact: walks_nowhere.
apply: walks_trans IH; apply/linked_piece; exact: (back_linked _ _ _ _ _ _ _ _ _ keeps (heard_live O) E O).
Qed.

Lemma outside_inside v x : outside_entry e s v x <-> lists_inside t (entry_start e s) v x.
Proof. by split=> -[I [w W L]]; split=> //; exists w => //; apply/linked_piece. Qed.

Lemma opens_border v : opens e s v <-> has_border t face_side v.
Proof.
split=> [[h [w O L] B]|[h [w [O L B]]]].
  exists h, w; split=> //; first exact/linked_piece.
  move: B; rewrite /lacks_face side_nil ?(heard_live (O : origin t h = Some w)) // -[on_border e s h]/(is_nil (twin t h)) /=.
  by case: (twin t h) (face_side h) => [a|] [b|] //= _; [right|left|left].
exists h; first by exists w => //; apply/linked_piece.
rewrite /lacks_face side_nil ?(heard_live (O : origin t h = Some w)) // -[on_border e s h]/(is_nil (twin t h)) /=.
by case: B => ->; rewrite ?orbT.
Qed.

Lemma nested_t1 : t1 e s <-> forall v, vertex t v -> one_or_none (lists_inside t (entry_start e s) v) (~~ unbounded \/ has_border t face_side v).
Proof.
have same v : one_or_none (outside_entry e s v) (~~ has_unbounded e s \/ opens e s v) <->
    one_or_none (lists_inside t (entry_start e s) v) (~~ unbounded \/ has_border t face_side v).
  split=> -[[x [X one]]|[legal none]].
  - by left; exists x; split=> [|y /outside_inside/one //]; apply/outside_inside.
  - right; split; first by case: legal => [|/opens_border]; [left|right].
    by move=> x /outside_inside; apply: none.
  - by left; exists x; split=> [|y /outside_inside/one //]; apply/outside_inside.
  right; split; first by case: legal => [|/opens_border]; [left|right].
  by move=> x /outside_inside; apply: none.
by split=> [H v lv|H _ v lv]; apply/same; apply: H.
Qed.

Definition has_depth := exists depth : nat -> nat, (forall u v, same_piece t u v -> depth u = depth v) /\
  forall f i u v, start_vertex t (entry_start e s f Outer) = Some u -> start_vertex t (entry_start e s f (Inner i)) = Some v -> depth u < depth v.

Lemma nested_t2 : (forall f u, start_vertex t (entry_start e s f Outer) = Some u -> vertex t u) -> t2 e s <-> has_depth.
Proof.
move=> live; split=> [H|[depth [same deeper]] _ v u w lv]; last first.
  have less x y : lies_in e s x y -> depth y < depth x.
    by case=> -[f [|i]] /= [// _ [z Z /linked_piece/same ->]] Y; apply: deeper Y Z.
  move=> /less lt uw /linked_piece/same E.
  suff: depth w <= depth u by rewrite E leqNgt lt.
  by elim: uw {E} => // x y _ IH /less/ltnW le; apply: leq_trans le IH.
pose depth v := size (undup (container_list e s v)); exists depth; split=> [u v uv|f i u v Eu Ev].
  have sub x y : same_piece t x y -> {subset container_list e s y <= container_list e s x}.
    move=> xy z /container_listP[a [en [no [b B yb]] A] az]; apply/container_listP; exists a => //; exists en => //.
    by split=> //; exists b => //; apply: walks_trans yb; apply/linked_piece.
  apply: perm_size; apply: uniq_perm; rewrite ?undup_uniq // => z; rewrite !mem_undup.
  by apply/idP/idP; apply: sub => //; apply: piece_sym.
have vu : lies_in e s v u by exists (f, Inner i) => //; split=> //; exists v => //; apply: walks_nowhere.
have sub : {subset u :: undup (container_list e s u) <= undup (container_list e s v)}.
  move=> z; rewrite inE !mem_undup => /orP[/eqP->|/container_listP[a ua az]]; apply/container_listP; exists u => //.
    exact: walks_nowhere.
  by apply: walks_trans az; apply: walks_on (walks_nowhere _ _) ua.
apply: uniq_leq_size sub; rewrite /= undup_uniq andbT mem_undup; apply/negP=> /container_listP[a ua au].
exact: (H isT u a u (live f u Eu) ua au (walks_nowhere _ _)).
Qed.

End Common.
