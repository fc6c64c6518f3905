(** * Encloses: the search that tells if a face lies inside a component (dcel/operators/walk.rs)

    From an inner boundary component one goes across its edges to outer ones, and on across theirs; and from each face that is
    met so, across the edges of all that lies in it. The faces that are met are those inside the component, which
    MoveInner.v forbids.

<<
      b │ c ┌───┐ │        across b is c, the outer one of a face; the small square lies in that face, and across
        │   │ e │ │        its edges is e, the outer one of a face that is inside the component of b, too
        │   └───┘ │
>>

    In Rust the outer ones that are met wait in a queue; here each is what can be reached. *)

From mathcomp Require Import all_ssreflect all_fingroup.
From twinedge Require Import View Rules Loops LoopsProof Map Lists Core SearchOutside MoveInner.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section Encloses.
Variables (t : view) (b : nat).
Hypothesis keeps : rules t.
Hypothesis inner_b : is_inner t b.

Let low : lower t := fun r _ => keeps r.
Let map := low_map low.

(** Across an edge of [c] is the outer boundary component [d]. *)
Definition meets c d := exists x : dart t, [/\ bnd x = c, bnd (tw x) = d & is_outer t d].

Inductive met : nat -> Prop :=
  | met_first c of meets b c : met c
  | met_across c d of met c & meets c d : met d
  | met_inside c f d e of met c & boundary_face t c = Some f & is_inner t d & boundary_face t d = Some f & meets d e : met e.

Lemma inner_not_outer d : is_inner t d -> ~~ is_outer t d.
Proof. by case=> i P; rewrite (outer_inn keeps) ?(heard_live P) // negbK /inn_of P. Qed.

Lemma outer_face c : is_outer t c -> exists2 f, boundary_face t c = Some f & outer t f = Some c.
Proof. by rewrite /is_outer; case: (boundary_face t c) => [f|] //= /eqP O; exists f. Qed.

Lemma outer_is f c : outer t f = Some c -> is_outer t c.
Proof. by move=> O; have [F _] := @listed_names _ low f Outer c O; rewrite /is_outer F /= O. Qed.

Lemma met_outer c : met c -> is_outer t c.
Proof. by case=> [d [x []]|d e _ [x []]|d f e g _ _ _ _ [x []]]. Qed.

Lemma inside_cases h c w : inside t b h -> outer t h = Some c -> vertex_at t c = Some w ->
  outside_of t w b \/ exists d h', [/\ outside_of t w d, boundary_face t d = Some h' & inside t b h'].
Proof.
case=> [{}h c' w' O W out|{}h c' w' d h' O W out F I] O1 W1.
  by left; move: O1; rewrite O => -[cc]; move: W1; rewrite -cc W => -[<-].
by right; exists d, h'; move: O1; rewrite O => -[cc]; move: W1; rewrite -cc W => -[<-].
Qed.

(** The boundary component of a half-edge starts in its component. *)
Lemma starts_in (x : dart t) : exists2 w, vertex_at t (bnd x) = Some w & connected t (org x) w.
Proof.
have [g S gx] := start_bnd low x; have V := Lists.vertex_at_cycle low S; exists (org g); first exact: V.
apply: (joined_connected map); apply: (joined_sym map); apply: (joined_orbit (f := @nx t)) gx => z; exact: joined_nx map z.
Qed.

Lemma outside_step u v d : connected t u v -> outside_of t u d -> outside_of t v d.
Proof. by move=> uv [I [w W uw]]; split=> //; exists w => //; apply: connected_trans (connected_sym map uv) uw. Qed.

(** Both sides of an edge are of one component. *)
Lemma meets_piece c d w u : meets c d -> vertex_at t c = Some w -> vertex_at t d = Some u -> connected t w u.
Proof.
case=> x [xc xd _]; have [w' W xw] := starts_in x; have [u' U xu] := starts_in (tw x); rewrite xc in W; rewrite xd in U.
rewrite W U => -[<-] [<-]; apply: connected_trans (connected_sym map xw) _; exact: connected_trans (connected_step map x) xu.
Qed.

Lemma meets_starts c d : meets c d -> exists w u, vertex_at t c = Some w /\ vertex_at t d = Some u.
Proof.
by case=> x [<- <- _]; have [w W _] := starts_in x; have [u U _] := starts_in (tw x); exists w, u.
Qed.

(** All outer ones of a component are met if those across its outside are. *)
Lemma spreads d (x y : dart t) : is_inner t d -> bnd x = d -> (forall e, meets d e -> met e) -> joined x y ->
  bnd y = d \/ met (bnd y) /\ is_outer t (bnd y).
Proof.
move=> I xd first xy; pose P z := joined x z /\ (bnd z = d \/ met (bnd z) /\ is_outer t (bnd z)).
suff [] : P y by [].
have keep z w : P z -> joined z w -> bnd w = bnd z -> P w.
  by move=> [xz Pz] zw E; rewrite /P E; split=> //; apply: joined_trans xz zw.
apply: (@joined_ind _ map P x y) xy _; last by split; [apply: joined_refl|left].
move=> z Pz; split.
- by apply: keep Pz (joined_nx map z) _; apply: bnd_nx.
- apply: keep Pz _ _; last by rewrite -[in RHS](pvK map z) (bnd_nx low).
  by apply: (joined_sym map); have := joined_nx map (pv z); rewrite (pvK map).
have [xz Bz] := Pz; have xt := joined_trans xz (joined_tw map z); split=> //.
case: (boolP (is_outer t (bnd (tw z)))) => [o|no].
  right; split=> //; have M : meets (bnd z) (bnd (tw z)) by exists z.
  by case: Bz => [zd|[mz _]]; [apply: first; rewrite -zd | apply: met_across mz M].
left; have I' : is_inner t (bnd (tw z)).
  have [f [p [_ F Q L]]] := placeP low (bnd_live map (tw z)); case: p Q L => [|i] Q L; last by exists i.
  by case/negP: no; apply: (@outer_is f).
have side q : bnd (tw z) = bnd q \/ bnd q = d -> joined x q -> is_inner t (bnd q) -> outside_of t (org x) (bnd q).
  move=> _ xq Iq; split=> //; have [w W qw] := starts_in q; exists w => //.
  exact: connected_trans (joined_connected map xq) qw.
have [o [O one]] := (keeps T1 : t1_outside t) _ (org_live map x).
have Id : is_inner t (bnd x) by rewrite xd.
rewrite -(one _ (side (tw z) (or_introl erefl) xt I')) (one _ (side x (or_intror xd) (joined_refl x) Id)).
exact: xd.
Qed.

(** The faces that are met are those inside the component. *)
Theorem met_inside_faces h : inside t b h <-> exists2 c, met c & outer t h = Some c.
Proof.
split=> [|[c M O]].
  have all_met d c w : is_inner t d -> (forall e, meets d e -> met e) -> vertex_at t c = Some w -> is_outer t c -> outside_of t w d -> met c.
    move=> I first W o [_ [u U wu]]; have lc : boundary t c by move: W; rewrite /vertex_at; case S: (boundary_start t c) => [s|] // _; apply: heard_live S.
    have [y Sy yc] : exists2 y : dart t, boundary_start t c = Some (AtHalfEdge (num y)) & bnd y = c.
      case: (boundaryP low lc) => [y Sy yc|v S _ _ _]; first by exists y.
      by have := inner_not_outer (vertex_inner low S); rewrite o.
    have wy : w = org y by move: W; rewrite (Lists.vertex_at_cycle low Sy) => -[].
    have ld : boundary t d by case: I => i P; apply: heard_live P.
    case: (boundaryP low ld) => [x S xd|v S lv bv _]; last first.
      move: U; rewrite (Lists.vertex_at_vertex S) => -[vu]; rewrite -vu in wu.
      by case: (@not_bare _ low y); rewrite -wy (connected_bare map (low_v2 low) bv (connected_sym map wu)).
    have ux : u = org x by move: U; rewrite (Lists.vertex_at_cycle low S) => -[].
    have xy : joined x y by apply: (connected_joined map (low_v2 low)); rewrite -ux -wy; apply: connected_sym.
    case: (spreads I xd first xy) => [yd|[m _]]; last by rewrite -yc.
    by have := inner_not_outer I; rewrite -yd yc o.
  elim=> {h} [h c w O W out|h c w d h' O W out F _ [c' M O']]; exists c => //.
    by apply: (all_met b c w inner_b _ W (outer_is O) out) => e me; exact: met_first.
  have I : is_inner t d by case: out.
  have [Fc _] := @listed_names _ low h' Outer c' O'.
  by apply: (all_met d c w I _ W (outer_is O) out) => e me; exact: (met_inside M Fc I F me).
have step c' h' : met c' -> outer t h' = Some c' -> inside t b h'.
  move=> M'; elim: M' h' => {c' c M O h} [c M|c d Mc IH M|c f d e Mc IH F I Fd M] h O.
  - have [w [u [W U]]] := meets_starts M; apply: (inside_here O U); split=> //; exists w => //.
    exact: (connected_sym map (meets_piece M W U)).
  - have [w [u [W U]]] := meets_starts M; have wu := meets_piece M W U; have [f _ Of] := outer_face (met_outer Mc).
    case: (inside_cases (IH f Of) Of W) => [out|[o [h' [out Fo In]]]].
      by apply: (inside_here O U); apply: outside_step wu out.
    by apply: (inside_deeper O U _ Fo In); apply: outside_step wu out.
  have [w [u [W U]]] := meets_starts M; have [f' F' Of] := outer_face (met_outer Mc).
  move: F'; rewrite F => -[ff]; rewrite -{f'}ff in Of; apply: (inside_deeper O U _ Fd (IH f Of)).
  by split=> //; exists w => //; apply: (connected_sym map (meets_piece M W U)).
exact: step M O.
Qed.

End Encloses.

(** So an inner boundary component can be moved to another face if and only if the search does not meet the outer one of that face. *)
Corollary move_inner_searched t b f g : rules t -> boundary_face t b = Some f ->
  boundary_place t b = Some (Inner (inner_count t f).-1) -> face t g -> g != f ->
  rules (move_inner t b f g) <-> ~ exists2 c, met t b c & outer t g = Some c.
Proof.
move=> keeps F P lg gf; have I : is_inner t b by exists (inner_count t f).-1.
by rewrite (move_inner_keeps_rules keeps F P lg gf) (met_inside_faces keeps I).
Qed.
