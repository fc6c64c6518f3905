(** * Lists: what R1 to F2 say of boundary components, vertices and faces

    Each boundary component is one cycle or one isolated vertex, and each stands at one place in one face. *)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import Arith View Rules Loops LoopsProof Map Counting.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** R1 to F2 hold. *)
Definition lower t := holds_before t T1.

Section Lists.
Variable t : view.
Hypothesis low : lower t.

Lemma low_r1 : links_live t. Proof. by have [] := low (q := R1). Qed.
Lemma low_map : is_map t.
Proof.
by case: low_r1 => H _ _ _; split; [|exact: (low (q := L1))|exact: (low (q := L2))|exact: (low (q := L3))].
Qed.
Lemma low_v1 : v1_leaving t. Proof. exact: (low (q := V1)). Qed.
Lemma low_v2 : v2_rotation t. Proof. exact: (low (q := V2)). Qed.
Lemma low_b1 : b1_cycle t. Proof. exact: (low (q := B1)). Qed.
Lemma low_b2 : b2_isolated t. Proof. exact: (low (q := B2)). Qed.
Lemma low_f1 : f1_outer t. Proof. exact: (low (q := F1)). Qed.
Lemma low_f2 : f2_listed t. Proof. exact: (low (q := F2)). Qed.

Let map := low_map.

(** ** Vertices *)

(** A vertex has a half-edge that it keeps, or it is bare. *)
Variant vertex_is v : Prop :=
  | VertexWith (x : dart t) of leaving t v = Some (num x) & org x = v
  | VertexBare b of leaving t v = None & bare t v & isolated t v = Some b & starts_at_vertex t v b.

Lemma vertexP v : vertex t v -> vertex_is v.
Proof.
move=> lv; have [_ V _ _] := low_r1; case: (V v lv) => [[[h E lh]|[E b]] _].
  by case: (dartP lh) => x xh; apply: (VertexWith (x := x)); [rewrite xh | have := low_v1 lv E; rewrite -xh (originE map) => -[]].
have [H _] := low_b2 lv; have [c [E' S]] := H b.
exact: VertexBare E b E' ((S c).2 erefl).
Qed.

Lemma not_bare (x : dart t) : ~ bare t (org x).
Proof. by move/bareP => /(_ map x). Qed.

Lemma bare_unique v b : vertex t v -> isolated t v = Some b -> forall c, starts_at_vertex t v c -> c = b.
Proof.
move=> lv E c S; case: (vertexP lv) => [x _ xv|d _ bv E' _].
  have [_ H] := low_b2 lv; have nb : ~ bare t v by rewrite -xv; apply: not_bare.
  by have [_ /(_ c)] := H nb.
by have [H _] := low_b2 lv; have [e [E'' /(_ c)[/(_ S)-> _]]] := H bv; move: E; rewrite E'' => -[].
Qed.

(** ** Boundary components *)

Lemma bnd_nx (x : dart t) : bnd (nx x) = bnd x.
Proof. by have [C _] := low_b1; have := C _ (dart_live x); rewrite (nextE map) /= !(boundaryE map) => -[]. Qed.

Lemma start_bnd (x : dart t) : exists2 g : dart t, boundary_start t (bnd x) = Some (AtHalfEdge (num g)) & fconnect (@nx t) g x.
Proof.
have [_ H] := low_b1; have [+ _] := H _ (num x) (bnd_live map x) (dart_live x).
rewrite (boundaryE map) => /(_ erefl)[h E c].
have [_ _ B _] := low_r1; have [_] := B _ (bnd_live map x); rewrite E => /= /dartP[g gh].
by exists g; rewrite ?gh //; apply/(on_cycleE map); rewrite gh.
Qed.

Lemma cycle_bnd x y : fconnect (@nx t) x y -> bnd x = bnd y.
Proof. by move/iter_findex=> <-; elim: (findex _ _ _) => //= k ->; rewrite bnd_nx. Qed.

Lemma bndE (x y : dart t) : (bnd x == bnd y) = fconnect (@nx t) x y.
Proof.
apply/eqP/idP => [E|/cycle_bnd //].
have [g Eg gx] := start_bnd x; have [h Eh hy] := start_bnd y.
move: Eg; rewrite E Eh => -[/num_inj hg]; rewrite hg in hy.
by apply: connect_trans hy; rewrite fconnect_sym //; exact: nx_inj.
Qed.

Variant boundary_is b : Prop :=
  | BoundaryCycle (x : dart t) of boundary_start t b = Some (AtHalfEdge (num x)) & bnd x = b
  | BoundaryVertex v of boundary_start t b = Some (AtVertex v) & vertex t v & bare t v & isolated t v = Some b.

Lemma boundaryP b : boundary t b -> boundary_is b.
Proof.
move=> lb; have [_ _ B _] := low_r1; have [_] := B b lb; case E: (boundary_start t b) => [[h|v]|] //= l.
  case: (dartP l) => x xh; rewrite -xh in E; apply: (BoundaryCycle (x := x)) => //.
  have [_ H] := low_b1; have [_ H2] := H b (num x) lb (dart_live x); rewrite (boundaryE map) in H2.
  by have [] // : Some (bnd x) = Some b by apply: H2; exists (num x); [exact: E|exists 0].
case: (vertexP l) => [x _ xv|c _ bv I S].
  have [_ H] := low_b2 l; have nb : ~ bare t v by rewrite -xv; apply: not_bare.
  by have [_ /(_ b)] := H nb.
by apply: (BoundaryVertex (v := v)) => //; rewrite (bare_unique l I E).
Qed.

(** ** Places *)

Lemma placeP b : boundary t b -> exists f p,
  [/\ face t f, boundary_face t b = Some f, boundary_place t b = Some p & listed t f p = Some b].
Proof.
move=> lb; have [f [p [Ef Ep /(_ f p)[_ L]]]] := low_f2 lb; exists f, p; split=> //; last exact: L.
by have [_ _ B _] := low_r1; have [[g Eg lg] _] := B b lb; move: Ef; rewrite Eg => -[<-].
Qed.

Lemma listed_live f p b : listed t f p = Some b -> boundary t b.
Proof.
have [_ _ _ F] := low_r1; case: p => [|i] E.
  by case: (F f (heard_live E)) => [[E'|[c E' lc]] _]; move: E; rewrite /= E' => // -[<-].
have lt : i < inner_count t f by move: E; rewrite /= /inner; case: ifP.
have lf : face t f by move: lt; rewrite /inner_count; case: ifP.
by case: (F f lf) => _ /(_ i lt)[c E' lc]; move: E; rewrite /= E' => -[<-].
Qed.

Lemma listed_names f p b : listed t f p = Some b -> boundary_face t b = Some f /\ boundary_place t b = Some p.
Proof.
move=> L; have [f' [p' [Ef Ep /(_ f p)[H _]]]] := low_f2 (listed_live L).
by have [-> ->] := H L.
Qed.

(** A face is the unbounded one, or a cycle bounds it. *)
Variant face_is f : Prop :=
  | FaceUnbounded of outer t f = None
  | FaceWithin (x : dart t) of outer t f = Some (bnd x) & boundary_start t (bnd x) = Some (AtHalfEdge (num x)).

Lemma faceP f : face t f -> face_is f.
Proof.
move=> lf; have [_ _ _ F] := low_r1; case: (F f lf) => [[E|[b E lb]] _]; first exact: FaceUnbounded.
case: (boundaryP lb) => [x S xb|v S _ _ _]; first by apply: (FaceWithin (x := x)); rewrite xb.
by have [_ H] := low_f1; case: (H f b v E).
Qed.

(** An isolated vertex lies inside a face. *)
Lemma vertex_inner v b : boundary_start t b = Some (AtVertex v) -> is_inner t b.
Proof.
move=> S; have lb := heard_live S; have [f [p [_ _ Ep L]]] := placeP lb.
case: p Ep L => [|i] Ep L; last by exists i.
by have [_ H] := low_f1; case: (H f b v L).
Qed.

Lemma vertex_at_cycle (x : dart t) b : boundary_start t b = Some (AtHalfEdge (num x)) -> vertex_at t b = Some (org x).
Proof. by rewrite /vertex_at => ->; rewrite (originE map). Qed.

Lemma vertex_at_vertex v b : boundary_start t b = Some (AtVertex v) -> vertex_at t b = Some v.
Proof. by rewrite /vertex_at => ->. Qed.

(** ** The outside of a component *)

(** An isolated vertex is its own component, and the boundary component that it is, is its outside. *)
Lemma outside_bare v b : vertex t v -> bare t v -> outside_of t v b <-> isolated t v = Some b.
Proof.
move=> lv bv; case: (vertexP lv) => [x _ xv|c L _ I S]; first by case: (@not_bare x); rewrite xv.
split=> [[_ [w W uw]]|E].
  have wv := connected_bare map low_v2 bv uw; rewrite wv in W.
  have lb : boundary t b by move: W; rewrite /vertex_at; case E: (boundary_start t b) => [s|] // _; apply: heard_live E.
  case: (boundaryP lb) => [x Sx _|u Su _ _ Iu]; last by move: W; rewrite (vertex_at_vertex Su) => -[<-].
  by move: W; rewrite (vertex_at_cycle Sx) => -[xv]; case: (@not_bare x); rewrite xv.
by move: E; rewrite I => -[<-]; split; [apply: vertex_inner S | exists v; [apply: vertex_at_vertex|apply: connected_self]].
Qed.

(** The outside of a component with half-edges is one of its cycles. *)
Lemma outside_dart (x : dart t) b :
  outside_of t (org x) b <-> is_inner t b /\ exists2 y : dart t, boundary_start t b = Some (AtHalfEdge (num y)) & joined x y.
Proof.
split=> [[I [w W xw]]|[I [y S xy]]]; split=> //; last first.
  by exists (org y); [apply: vertex_at_cycle | apply: joined_connected].
have lb : boundary t b by move: W; rewrite /vertex_at; case E: (boundary_start t b) => [s|] // _; apply: heard_live E.
case: (boundaryP lb) => [y S _|v S lv bv _].
  exists y => //; apply: (connected_joined map low_v2); move: W; rewrite (vertex_at_cycle S) => -[->] //.
move: W; rewrite (vertex_at_vertex S) => -[vw]; rewrite -vw in xw.
by case: (@not_bare x); rewrite (connected_bare map low_v2 bv (connected_sym map xw)).
Qed.

(** A boundary component is on a side of each half-edge that names it: it starts at the same component. *)
Lemma on_side i b w : boundary_of t i = Some b -> origin t i = Some w ->
  (exists g, boundary_start t b = Some (AtHalfEdge g)) /\ exists2 v, vertex_at t b = Some v & connected t v w.
Proof.
move=> B; have li := heard_live B; case: (dartP li) B => x <-; rewrite (originE map) (boundaryE map) => -[<-] [<-].
have [g S gx] := start_bnd x; split; first by exists (num g).
exists (org g); first exact: vertex_at_cycle.
by apply: (joined_connected map); apply: joined_orbit gx; apply: joined_nx.
Qed.

(** ** The list of a face *)

(** The inner boundary components of the face [f], in order. *)
Definition inner_list f := [seq odflt 0 (inner t f i) | i <- iota 0 (inner_count t f)].

Lemma inner_listP f b : b \in inner_list f <-> is_inner t b /\ boundary_face t b = Some f.
Proof.
split=> [/mapP[i]|[[i P] F]].
  rewrite mem_iota add0n => lt ->; have [_ _ _ Fl] := low_r1.
  have lf : face t f by move: lt; rewrite /inner_count; case: ifP.
  have [_ /(_ i lt)[c E _]] := Fl f lf; rewrite E /=; have [Ef Ep] := @listed_names f (Inner i) c E.
  by split=> //; exists i.
have [g [p [_ Ef Ep L]]] := placeP (heard_live P); move: Ef Ep L; rewrite F P => -[<-] [<-] /= E.
apply/mapP; exists i; last by rewrite E.
by rewrite mem_iota add0n; move: E; rewrite /inner; case: ifP.
Qed.

Lemma inner_list_uniq f : uniq (inner_list f).
Proof.
rewrite map_inj_in_uniq ?iota_uniq // => i j; rewrite !mem_iota !add0n => li lj.
have lf : face t f by move: li; rewrite /inner_count; case: ifP.
have [_ _ _ /(_ f lf)[_ I]] := low_r1; have [b Eb _] := I i li; have [c Ec _] := I j lj; rewrite Eb Ec /= => bc.
have [_] := @listed_names f (Inner i) b Eb; have [_] := @listed_names f (Inner j) c Ec.
by rewrite bc => -> -[].
Qed.

End Lists.

(** F2 holds where each boundary component is listed at the place it names, and what is listed names its place. *)
Lemma f2_if t : (forall b, boundary t b -> exists f p,
    [/\ boundary_face t b = Some f, boundary_place t b = Some p & listed t f p = Some b]) ->
  (forall f p b, listed t f p = Some b -> boundary_face t b = Some f /\ boundary_place t b = Some p) -> f2_listed t.
Proof.
move=> all names b /all[f [p [Ef Ep L]]]; exists f, p; split=> // f' p'; split=> [/names|[-> ->] //].
by rewrite Ef Ep => -[[->] [->]].
Qed.

(** The demand of a view on a list without repetition: each is at the place of its index. *)
Lemma listed_at (s : seq nat) i b : uniq s ->
  (if i < size s then nth None [seq Some c | c <- s] i else None) = Some b <-> b \in s /\ seq.index b s = i.
Proof.
move=> u; split=> [|[bs <-]]; last by rewrite index_mem bs (nth_map 0) ?index_mem // nth_index.
by case: ifP => // lt; rewrite (nth_map 0) // => -[<-]; rewrite mem_nth // index_uniq.
Qed.
