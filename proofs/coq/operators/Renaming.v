(** * Renaming: the numbers of records, and the order of lists, do not matter

    A view is a *renaming* of another one if its records are those of the other under other numbers, and each face lists
    the same boundary components, in whatever order. Two stores that give out slots in different ways make renamings of
    each other.

<<
      t    face 3 lists 5 8 2          rb 5 = 0, rb 8 = 1, rb 2 = 2, rf 3 = 7
      t'   face 7 lists 2 0 1          rp 3 0 = 1, rp 3 1 = 2, rp 3 2 = 0
>>
*)

From mathcomp Require Import all_ssreflect all_fingroup.
From twinedge Require Import View Rules Map Subdivision Represented Verdict.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** [r] gives other numbers to the live records. *)
Definition renumbers (r : nat -> nat) (live live' : nat -> bool) :=
  (forall i j, live i -> live j -> r i = r j -> i = j) /\ forall j, live' j <-> exists2 i, live i & r i = j.

Definition rename_start rd rv s := match s with AtHalfEdge h => AtHalfEdge (rd h) | AtVertex v => AtVertex (rv v) end.
Definition rename_place (rp : nat -> nat) p := match p with Outer => Outer | Inner i => Inner (rp i) end.

(** [rv], [rd], [rb] and [rf] give the new numbers of vertices, half-edges, boundary components and faces, and [rp f]
    the new places in the list of the face [f]. *)
Record renaming t t' (rv rd rb rf : nat -> nat) (rp : nat -> nat -> nat) : Prop := Renaming {
  of_vertices : renumbers rv (vertex t) (vertex t');
  of_half_edges : renumbers rd (half_edge t) (half_edge t');
  of_boundaries : renumbers rb (boundary t) (boundary t');
  of_faces : renumbers rf (face t) (face t');
  same_half_edge : forall h, half_edge t h ->
    [/\ origin t' (rd h) = omap rv (origin t h), twin t' (rd h) = omap rd (twin t h),
        next t' (rd h) = omap rd (next t h), prev t' (rd h) = omap rd (prev t h)
      & boundary_of t' (rd h) = omap rb (boundary_of t h)];
  same_vertex : forall v, vertex t v ->
    leaving t' (rv v) = omap rd (leaving t v) /\ isolated t' (rv v) = omap rb (isolated t v);
  same_boundary : forall b f, boundary t b -> boundary_face t b = Some f ->
    [/\ boundary_face t' (rb b) = Some (rf f), boundary_start t' (rb b) = omap (rename_start rd rv) (boundary_start t b)
      & boundary_place t' (rb b) = omap (rename_place (rp f)) (boundary_place t b)];
  same_face : forall f, face t f ->
    outer t' (rf f) = omap rb (outer t f) /\ inner_count t' (rf f) = inner_count t f;
  same_list : forall f i, face t f -> i < inner_count t f ->
    rp f i < inner_count t f /\ inner t' (rf f) (rp f i) = omap rb (inner t f i);
  every_place : forall f j, face t f -> j < inner_count t f -> exists2 i, i < inner_count t f & rp f i = j
}.

Section Renamed.
Variables (t t' : view) (rv rd rb rf : nat -> nat) (rp : nat -> nat -> nat).
Hypothesis same : renaming t t' rv rd rb rf rp.

Lemma renamed_numbers T (n : T -> nat) r live live' :
  renumbers r live live' -> numbers n live -> numbers (r \o n) live'.
Proof.
case=> inj all [n_inj n_all]; have ln x : live (n x) by apply/n_all; exists x.
split=> [x y /= /inj E|j]; first by apply/n_inj/E.
split=> [/all[i /n_all[x <-] <-]|[x <-]]; first by exists x.
by apply/all; exists (n x).
Qed.

Lemma renamed_stands b f io : face t f -> stands t b f io -> stands t' (rb b) (rf f) io.
Proof.
move=> lf [E]; have [E' _ P'] := same_boundary same (heard_live E) E.
case: io => [[i [P L]]|[P O]]; split=> //.
  have lt : i < inner_count t f by move: L; rewrite /inner; case: ifP.
  exists (rp f i); rewrite P' P /=; split=> //.
  by have [_ ->] := same_list same lf lt; rewrite L.
by rewrite P' P; split=> //; have [-> _] := same_face same lf; rewrite O.
Qed.

Lemma renamed_represents s : represents t s -> represents t' s.
Proof.
case=> nv [nd [nf [nw [ni rep]]]]; exists (rv \o nv), (rd \o nd), (rf \o nf), (rb \o nw), (rb \o ni).
have [rb_inj rb_all] := of_boundaries same.
have lw := boundary_nw rep; have li := boundary_ni rep; have lf := face_nf rep.
have lv := vertex_nv rep; have ld := half_edge_nd rep.
split.
- exact: renamed_numbers (of_vertices same) (vertices_numbered rep).
- exact: renamed_numbers (of_half_edges same) (darts_numbered rep).
- exact: renamed_numbers (of_faces same) (faces_numbered rep).
- move=> x y; rewrite -(walks_numbered rep) /=; split=> [/rb_inj|->] //; exact.
- by move=> v w av aw /= /rb_inj E; apply: (isolated_numbered rep) => //; apply: E; apply: li.
- by move=> x v av /= /rb_inj E; apply: (walk_or_isolated rep (x := x) av); apply: E; rewrite ?lw ?li.
- move=> b; rewrite rb_all; split=> [[c /(boundaries_numbered rep)[[x <-]|[v av <-]] <-]|[[x <-]|[v av <-]]].
  + by left; exists x.
  + by right; exists v.
  + by exists (nw x).
  by exists (ni v) => //; apply: li.
- move=> x; have [o w n p c] := says_of_dart rep x.
  have [-> -> -> _ ->] := same_half_edge same (ld x); rewrite o w n c; split=> //.
  by have [_ _ _ -> _] := same_half_edge same (ld (after x)); rewrite p.
- move=> v; have [/= -> ->] := same_vertex same (lv v); have := says_of_vertex rep v.
  case: (alone v) => [[-> ->]|[[x -> xv] ->]] //; split=> //; by exists x.
- move=> x; have [S [y E xy]] := says_of_walk rep x; split; first exact: renamed_stands.
  exists y => //; case: S => Ef _; have [_ /= -> _] := same_boundary same (lw x) Ef.
  by rewrite E.
- move=> v av; have [S E] := says_of_isolated rep av; split; first exact: renamed_stands.
  by case: S => Ef _; have [_ /= -> _] := same_boundary same (li v av) Ef; rewrite E.
- move=> f' b' E; have [_ all] := of_faces same; have [f l ff'] := (all f').1 (heard_live E).
  move: E; rewrite -ff'; have [-> _] := same_face same l; case O: (outer t f) => [b|] //= -[<-].
  have [Ef Ep] := lists_outer rep O; have [-> _ ->] := same_boundary same (heard_live Ef) Ef.
  by rewrite Ep.
move=> f' j lt; have l' : face t' f' by move: lt; rewrite /inner_count; case: ifP.
have [_ all] := of_faces same; have [f l ff'] := (all f').1 l'; move: lt; rewrite -ff'.
have [_ ->] := same_face same l; move/(every_place same l) => [i lt <-].
have [b [L Ef Ep]] := lists_inner rep lt; have [_ ->] := same_list same l lt; exists (rb b); rewrite L.
by have [-> _ ->] := same_boundary same (heard_live Ef) Ef; rewrite Ep.
Qed.

(** A table that keeps the rules keeps them under other numbers. *)
Theorem renaming_keeps : rules t -> rules t'.
Proof. by move/rules_mean_subdivision=> [s /renamed_represents rep]; apply/rules_mean_subdivision; exists s. Qed.

End Renamed.
