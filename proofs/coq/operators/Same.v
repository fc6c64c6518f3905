(** * Same: a program makes of one table any other one with the same core

    Two tables with the same core (Core.v) represent the same subdivision, with the same records in the same slots. They may differ in
    the half-edges that are kept and in the order of lists. Keeping others (Keep.v) and ordering lists (Renaming.v) makes the one
    of the other. *)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import View Rules Map Lists Core Renaming Keep Programs.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** Both have the same core. *)
Record same_core t t' : Prop := SameCore {
  same_vertex : vertex t' =1 vertex t;
  same_half_edge : half_edge t' =1 half_edge t;
  same_boundary : boundary t' =1 boundary t;
  same_face : face t' =1 face t;
  same_origin : forall i, half_edge t i -> origin t' i = origin t i;
  same_twin : forall i, half_edge t i -> twin t' i = twin t i;
  same_next : forall i, half_edge t i -> next t' i = next t i;
  same_boundary_of : forall i, half_edge t i -> boundary_of t' i = boundary_of t i;
  same_isolated : forall v, vertex t v -> isolated t' v = isolated t v;
  same_boundary_face : forall b, boundary t b -> boundary_face t' b = boundary_face t b;
  same_inn : forall b, boundary t b -> inn_of t' b = inn_of t b
}.

Definition start_half_edge t b : link := if boundary_start t b is Some (AtHalfEdge h) then Some h else None.

Section Same.
Variables t t' : view.
Hypothesis keeps : rules t.
Hypothesis keeps' : rules t'.
Hypothesis same : same_core t t'.

Let low : lower t. Proof. by move=> q _; apply: keeps. Qed.
Let low' : lower t'. Proof. by move=> q _; apply: keeps'. Qed.
Let r : rest t (inn_of t) := rest_of_rules keeps.
Let r' : rest t' (inn_of t') := rest_of_rules keeps'.
Notation kept := (keep_others t (leaving t') (start_half_edge t')).

Lemma same_prev h : half_edge t h -> prev t' h = prev t h.
Proof.
move=> lh; have lh' : half_edge t' h by rewrite (same_half_edge same).
have [[g P lg] N] := rest_prev r' lh'; rewrite P /= in N; rewrite (same_half_edge same) in lg.
have [+ _] := keeps L2 g lg; rewrite -(same_next same lg) N /= => ->; exact: P.
Qed.

Lemma same_leaving v : vertex t v -> leaving kept v = leaving t' v.
Proof.
move=> lv; have lv' : vertex t' v by rewrite (same_vertex same).
rewrite {1}/leaving /heard [vertex kept v]lv /=; case: (rest_leaving r' lv') => [[h L O]|[L B]]; rewrite L /=.
  by rewrite -(same_origin same) ?O ?eqxx // -(same_half_edge same) (heard_live O).
have L' : says_leaving t v = leaving t v by rewrite /leaving /heard lv.
rewrite L'; case: (rest_leaving r lv) => [[h _ O]|[-> _]] //.
by case: (B h); rewrite ?(same_half_edge same) ?(same_origin same) ?(heard_live O).
Qed.

Lemma same_start b : boundary t b -> boundary_start kept b = boundary_start t' b.
Proof.
move=> lb; have lb' : boundary t' b by rewrite (same_boundary same).
rewrite {1}/boundary_start /heard [boundary kept b]lb /= /start_half_edge; case: (rest_start r' lb') => [[h S B]|[v S I]]; rewrite S /=.
  by rewrite -(same_boundary_of same) ?B ?eqxx // -(same_half_edge same) (heard_live B).
have lv : vertex t v by rewrite -(same_vertex same) (heard_live I).
rewrite (same_isolated same lv) in I; have S' : says_boundary_start t b = boundary_start t b by rewrite /boundary_start /heard lb.
by rewrite S'; have [-> _] := isolated_start keeps I.
Qed.

Lemma same_outer f : face t f -> outer t' f = outer t f.
Proof.
move=> lf; have iff b : outer t' f = Some b <-> outer t f = Some b.
  split=> [/(inn_outer keeps')[F I]|/(inn_outer keeps)[F I]].
    have lb : boundary t b by rewrite -(same_boundary same) (heard_live F).
    by apply/(inn_outer keeps); rewrite -(same_boundary_face same lb) -(same_inn same lb).
  have lb := heard_live F; apply/(inn_outer keeps'); by rewrite (same_boundary_face same lb) (same_inn same lb).
case O: (outer t f) => [b|]; first exact/iff.
by case O': (outer t' f) => [b|] //; have/iff := O'; rewrite O.
Qed.

Lemma same_list f : face t f -> inner_list t' f =i inner_list t f.
Proof.
have inner_iff u (k : rules u) (l : lower u) b : b \in inner_list u f <-> [/\ boundary u b, inn_of u b & boundary_face u b = Some f].
  apply: iff_trans (inner_listP l f b) _; split=> [[I F]|[lb I F]].
    by have lb := heard_live F; split=> //; apply/(inn_inner k lb).
  by split=> //; apply/(inn_inner k lb).
move=> lf b; apply/idP/idP => [/(inner_iff t' keeps' low')[lb I F]|/(inner_iff t keeps low)[lb I F]].
  rewrite (same_boundary same) in lb; apply/(inner_iff t keeps low).
  by rewrite -(same_inn same lb) -(same_boundary_face same lb).
by apply/(inner_iff t' keeps' low'); rewrite (same_boundary same) (same_inn same lb) (same_boundary_face same lb).
Qed.

Lemma list_size u f : size (inner_list u f) = inner_count u f. Proof. by rewrite size_map size_iota. Qed.

Lemma list_place u (l : lower u) b f i : boundary_face u b = Some f -> boundary_place u b = Some (Inner i) ->
  i < inner_count u f /\ nth 0 (inner_list u f) i = b.
Proof.
move=> F P; have [g [p [_ F' P' L]]] := placeP l (heard_live F); move: F' P' L; rewrite F P => -[<-] [<-] /= L.
have lt : i < inner_count u f by move: L; rewrite /inner; case: ifP.
by split=> //; rewrite (nth_map 0) ?size_iota // nth_iota // add0n L.
Qed.

Lemma list_inner u (l : lower u) f i : face u f -> i < inner_count u f -> inner u f i = Some (nth 0 (inner_list u f) i).
Proof.
move=> lf lt; have [_ _ _ /(_ f lf)[_ /(_ i lt)[b E _]]] := low_r1 l.
by rewrite (nth_map 0) ?size_iota // nth_iota // add0n E.
Qed.

(** The place in the list of [t'] of what the list of [t] has at [i]. *)
Definition place_in f i := seq.index (nth 0 (inner_list t f) i) (inner_list t' f).

Lemma kept_renames : renaming kept t' id id id id place_in.
Proof.
have id_renumbers (live live' : nat -> bool) : live' =1 live -> renumbers id live live'.
  by move=> E; split=> // j; rewrite E; split=> [l|[i l <-] //]; exists j.
have nothing (l : link) : omap id l = l by case: l.
have at_ f i : face t f -> i < inner_count t f -> nth 0 (inner_list t f) i \in inner_list t' f.
  by move=> lf lt; rewrite same_list // mem_nth // list_size.
have count f : face t f -> inner_count t' f = inner_count t f.
  by move=> lf; rewrite -!list_size; apply: perm_size; apply: uniq_perm (same_list lf); apply: inner_list_uniq.
split.
- exact: id_renumbers (same_vertex same).
- exact: id_renumbers (same_half_edge same).
- exact: id_renumbers (same_boundary same).
- exact: id_renumbers (same_face same).
- move=> h lh; rewrite !nothing (same_origin same lh) (same_twin same lh) (same_next same lh) (same_prev lh).
  by rewrite (same_boundary_of same lh).
- by move=> v lv; rewrite !nothing (same_leaving lv) (same_isolated same lv).
- move=> b f lb F0; have F : boundary_face t b = Some f := F0.
  rewrite (same_boundary_face same lb) (same_start lb) F; split=> //.
    by case: (boundary_start t' b) => [[]|].
  have lb' : boundary t' b by rewrite (same_boundary same).
  have I := same_inn same lb; have F' : boundary_face t' b = Some f by rewrite (same_boundary_face same lb).
  have P0 : boundary_place kept b = boundary_place t b by [].
  rewrite P0; move: I; rewrite /inn_of; have [_ [p [_ _ P _]]] := placeP low lb; have [_ [p' [_ _ P' _]]] := placeP low' lb'.
  rewrite P P' /=; case: p P => [|i] P; case: p' P' => [|j] P' // _; congr (Some (Inner _)).
  have [_ Ei] := list_place low F P; have [lt Ej] := list_place low' F' P'.
  by rewrite /place_in Ei -Ej index_uniq ?list_size // inner_list_uniq.
- by move=> f lf; rewrite nothing (same_outer lf) (count f lf).
- move=> f i lf lt; have in_ := at_ f i lf lt; have lf' : face t' f by rewrite (same_face same).
  have lt' : place_in f i < inner_count t' f by rewrite -list_size index_mem.
  split; first by rewrite -[inner_count kept f]/(inner_count t f) -(count f lf).
  rewrite (list_inner low' lf' lt') nth_index // nothing; have -> : inner kept f i = inner t f i by [].
  by rewrite (list_inner low lf lt).
move=> f j lf; rewrite -[inner_count kept f]/(inner_count t f) => lt; rewrite -(count f lf) in lt.
have in_ : nth 0 (inner_list t' f) j \in inner_list t f by rewrite -same_list // mem_nth // list_size.
exists (seq.index (nth 0 (inner_list t' f) j) (inner_list t f)).
  by rewrite -list_size index_mem.
by rewrite /place_in nth_index // index_uniq ?list_size // inner_list_uniq.
Qed.

Theorem same_core_program u : program u t -> program u t'.
Proof.
move=> P; apply: program_step (step_rename kept_renames); exact: program_step P (step_keep_others _ _ _).
Qed.

End Same.
