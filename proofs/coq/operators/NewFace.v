(** * NewFace: one boundary component becomes two, and one face two (`split_face` in dcel/operators/connect.rs)

    An edge that splits a cycle splits its face. Of the two boundary components, [kept] and [made], one bounds the new face
    [g], and the other stays where [kept] was: it bounds the old face [f], or it is an inner one of [f]. The other inner
    boundary components of [f] go to [g] as told.

<<
      f ┌─────────┐         f ┌────┬────┐          kept bounded f: one bounds f, the other g
        │ □     · │   ──►     │ □  │  · │ g
        └─────────┘           └────┴────┘

      f   ┌──┐              f   ┌──┬──┐            kept was an inner one of f: one is an inner one of f, the other
          │                     │  │g │            bounds g
          └──                   └──┴──┘
>>

    This file is about the boundary components and faces. How a cycle becomes two is the matter of the files that use it. *)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import Arith View Rules Map Counting Lists TopologyProof Genus WholeEuler Verdict NewEdge.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** The lists of the old face and of the new one. *)
Definition bounds t f kept := outer t f == Some kept.
Definition old_list t f kept of_old (moved : pred nat) :=
  [seq c <- inner_list t f | (c != kept) && ~~ moved c] ++ (if bounds t f kept then [::] else [:: of_old]).
Definition new_list t f kept (moved : pred nat) := [seq c <- inner_list t f | (c != kept) && moved c].

(** The view [n] with the new face [g] and the boundary component [made], where [t] is what was before. *)
Definition new_face t n f g kept made of_old of_new moved : view := {|
  vertex_slots := vertex_slots n;
  half_edge_slots := half_edge_slots n;
  boundary_slots := maxn (boundary_slots t) made.+1;
  face_slots := maxn (face_slots t) g.+1;
  is_vertex := is_vertex n;
  is_half_edge := is_half_edge n;
  is_boundary := fun c => (c == made) || boundary t c;
  is_face := fun x => (x == g) || face t x;
  says_origin := says_origin n;
  says_twin := says_twin n;
  says_next := says_next n;
  says_prev := says_prev n;
  says_boundary := says_boundary n;
  says_leaving := says_leaving n;
  says_isolated := says_isolated n;
  says_boundary_face := fun c => if c == of_new then Some g else if c == of_old then Some f else
    if c \in new_list t f kept moved then Some g else says_boundary_face t c;
  says_boundary_start := says_boundary_start n;
  says_boundary_place := fun c => if c == of_new then Some Outer else
    if (c == of_old) && bounds t f kept then Some Outer else
    if c \in old_list t f kept of_old moved then Some (Inner (seq.index c (old_list t f kept of_old moved))) else
    if c \in new_list t f kept moved then Some (Inner (seq.index c (new_list t f kept moved))) else says_boundary_place t c;
  says_outer := fun x => if x == g then Some of_new else if (x == f) && bounds t f kept then Some of_old else says_outer t x;
  says_inner_count := fun x => if x == g then size (new_list t f kept moved) else
    if x == f then size (old_list t f kept of_old moved) else says_inner_count t x;
  says_inner := fun x i => if x == g then nth None [seq Some c | c <- new_list t f kept moved] i else
    if x == f then nth None [seq Some c | c <- old_list t f kept of_old moved] i else says_inner t x i
|}.

Section NewFace.
Variables (t n : view) (f g kept made left right of_old of_new : nat) (moved : pred nat).
Hypothesis keeps : rules t.
Hypothesis free_boundary : ~~ boundary t made.
Hypothesis free_face : ~~ face t g.
Hypothesis kept_in_f : boundary_face t kept = Some f.
Hypothesis two_cycles : left = kept /\ right = made \/ left = made /\ right = kept.
Hypothesis two_faces : of_old = left /\ of_new = right \/ of_old = right /\ of_new = left.

Notation t' := (new_face t n f g kept made of_old of_new moved).
Notation olds := (old_list t f kept of_old moved).
Notation news := (new_list t f kept moved).
Notation bounding := (bounds t f kept).
Let low : lower t. Proof. by move=> q _; apply: keeps. Qed.
Let map : is_map t := low_map low.
Let live_kept : boundary t kept := heard_live kept_in_f.

Let sides : of_old = kept /\ of_new = made \/ of_old = made /\ of_new = kept.
Proof. by case: two_faces => -[-> ->]; case: two_cycles => -[-> ->]; auto. Qed.

Lemma boundaryE c : boundary t' c = (c == made) || boundary t c.
Proof. exact: one_more (@boundary_below t). Qed.

Lemma faceE x : face t' x = (x == g) || face t x.
Proof. exact: one_more (@face_below t). Qed.

Lemma old_face x : face t x -> x == g = false.
Proof. by move=> l; apply/eqP=> E; rewrite E (negPf free_face) in l. Qed.
Lemma old_made c : boundary t c -> c == made = false.
Proof. by move=> l; apply/eqP=> E; rewrite E (negPf free_boundary) in l. Qed.

Lemma live_f : face t f.
Proof. by have [[_ _ B _] _] := keeps R1; have [[x + lx] _] := B kept live_kept; rewrite kept_in_f => -[->]. Qed.

Lemma kept_not_made : kept <> made. Proof. by move/eqP; rewrite old_made. Qed.
Lemma old_not_new : of_old <> of_new. Proof. by case: sides => -[-> ->]; [|apply: nesym]; apply: kept_not_made. Qed.
Lemma live_old : boundary t' of_old.
Proof. by rewrite boundaryE; case: sides => -[-> _]; rewrite ?eqxx ?live_kept ?orbT. Qed.
Lemma live_new : boundary t' of_new.
Proof. by rewrite boundaryE; case: sides => -[_ ->]; rewrite ?eqxx ?live_kept ?orbT. Qed.

(** A boundary component that is neither [kept] nor [made]. *)
Definition other c := c <> kept /\ c <> made.
Lemma other_old c : other c -> c == of_old = false.
Proof. by case=> ck cm; apply/eqP; case: sides => -[-> _]. Qed.
Lemma other_new c : other c -> c == of_new = false.
Proof. by case=> ck cm; apply/eqP; case: sides => -[_ ->]. Qed.

Variant which : nat -> Prop := IsOld : which of_old | IsNew : which of_new | IsOther c of other c & boundary t c : which c.
Lemma whichP c : boundary t' c -> which c.
Proof.
rewrite boundaryE; case: (c =P kept) => [ck _|ck].
  by case: sides => -[E E']; [have -> : c = of_old by rewrite ck|have -> : c = of_new by rewrite ck]; constructor.
case: (c =P made) => [cm _|cm /= lc]; last exact: IsOther.
by case: sides => -[E E']; [have -> : c = of_new by rewrite cm|have -> : c = of_old by rewrite cm]; constructor.
Qed.

(** ** The lists *)

Lemma outer_not_inner x c : outer t x = Some c -> ~ is_inner t c.
Proof. by move=> E [i]; have [_ ->] := @listed_names _ low x Outer c E. Qed.

Lemma kept_inner : is_inner t kept <-> ~~ bounding.
Proof.
split=> [I|no]; first by apply/negP=> /eqP/outer_not_inner.
have [x [p [_ Ef Ep L]]] := placeP low live_kept; move: Ef L; rewrite kept_in_f => -[<-].
by case: p Ep => [|i] Ep L; [move/eqP: no|exists i].
Qed.

Lemma newsP c : c \in news <-> [/\ other c, moved c, is_inner t c & boundary_face t c = Some f].
Proof.
rewrite mem_filter; split=> [/andP[/andP[/eqP ck m] /(inner_listP low)[I F]]|[[ck _] m I F]].
  by split=> //; split=> //; apply/eqP; rewrite old_made // (heard_live F).
by apply/andP; split; [rewrite m andbT; apply/eqP|apply/(inner_listP low)].
Qed.

Lemma oldsP c : c \in olds <->
  [/\ other c, ~~ moved c, is_inner t c & boundary_face t c = Some f] \/ ~~ bounding /\ c = of_old.
Proof.
rewrite mem_cat mem_filter; split=> [/orP[|]|[[[ck _] m I F]|[no ->]]].
- case/andP=> /andP[/eqP ck m] /(inner_listP low)[I F]; left; split=> //; split=> //.
  by apply/eqP; rewrite old_made // (heard_live F).
- by case: ifP => // no; rewrite inE => /eqP; right.
- by apply/orP; left; apply/andP; split; [rewrite m andbT; apply/eqP|apply/(inner_listP low)].
by rewrite (negPf no) mem_head orbT.
Qed.

Lemma news_uniq : uniq news. Proof. exact: filter_uniq (inner_list_uniq low f). Qed.

Lemma olds_uniq : uniq olds.
Proof.
rewrite cat_uniq filter_uniq ?inner_list_uniq //=; case: ifP => //= _; rewrite orbF andbT.
rewrite mem_filter; apply/negP=> /andP[/andP[/eqP ck _] /(inner_listP low)[_ F]].
by case: sides => -[E _]; rewrite E in ck F; [|move: (heard_live F); rewrite (negPf free_boundary)].
Qed.

(** ** What the view says *)

Lemma boundary_faceE c : boundary t' c -> boundary_face t' c =
  if c == of_new then Some g else if c == of_old then Some f else if c \in news then Some g else boundary_face t c.
Proof.
move=> lc; rewrite {1}/boundary_face /heard lc /=; case: (whichP lc) => [||{lc}c oc lc]; rewrite ?eqxx //.
by rewrite other_old ?other_new // /boundary_face /heard lc.
Qed.

Lemma placeE c : boundary t' c -> boundary_place t' c =
  if c == of_new then Some Outer else if (c == of_old) && bounding then Some Outer else
  if c \in olds then Some (Inner (seq.index c olds)) else
  if c \in news then Some (Inner (seq.index c news)) else boundary_place t c.
Proof.
move=> lc; rewrite {1}/boundary_place /heard lc /=; case: (whichP lc) => [||{lc}c oc lc]; rewrite ?eqxx //=.
  case: (boolP bounding) => // no; case: (of_old =P of_new) => // _.
  by have -> : of_old \in olds by apply/oldsP; right.
by rewrite other_old ?other_new // /boundary_place /heard lc.
Qed.

Lemma outerE x : outer t' x = if x == g then Some of_new else if (x == f) && bounding then Some of_old else outer t x.
Proof.
rewrite {1}/outer /heard faceE /=; case: (x == g) => //=.
by case: (boolP ((x == f) && bounding)) => [/andP[/eqP-> _]|_] //; rewrite live_f.
Qed.

Lemma countE x : inner_count t' x = if x == g then size news else if x == f then size olds else inner_count t x.
Proof.
by rewrite {1}/inner_count faceE /=; case: (x == g) => //=; case: (x =P f) => [->|_] //; rewrite live_f.
Qed.

Lemma innerE x i c : inner t' x i = Some c <-> if x == g then c \in news /\ seq.index c news = i else
  if x == f then c \in olds /\ seq.index c olds = i else inner t x i = Some c.
Proof.
rewrite {1}/inner countE /=; case: (x == g); first exact: listed_at news_uniq.
by case: (x == f); first exact: listed_at olds_uniq.
Qed.

(** ** F2 *)

Lemma listed_new x p c : listed t' x p = Some c ->
  [/\ boundary t' c, boundary_face t' c = Some x & boundary_place t' c = Some p].
Proof.
have up d : boundary t d -> boundary t' d by rewrite boundaryE orbC => ->.
have [lo ln] := (live_old, live_new); have on : (of_old == of_new) = false by apply/eqP/old_not_new.
have no_news : of_old \in news = false by apply/negP=> /newsP[/other_old]; rewrite eqxx.
case: p => [|i] /=.
  rewrite outerE; case: (x =P g) => [-> [<-]|xg].
    by rewrite boundary_faceE // placeE // eqxx.
  case: ifP => [/andP[/eqP-> b] [<-]|no O].
    by rewrite boundary_faceE // placeE // on eqxx b.
  have [Fc Pc] := @listed_names _ low x Outer c O; have lc := heard_live Fc; have ni := outer_not_inner O.
  have oc : other c.
    split; last by apply/eqP; rewrite old_made.
    move=> ck; move: no Fc; rewrite ck kept_in_f => no [xf]; move: no.
    by rewrite -xf eqxx /bounds -ck xf O eqxx.
  have nn : c \in news = false by apply/negP=> /newsP[].
  have no' : c \in olds = false by apply/negP=> /oldsP[[]//|[_ /eqP]]; rewrite other_old.
  by rewrite boundary_faceE ?placeE ?up // other_new ?other_old // nn no'.
move/innerE; case: (x =P g) => [->|xg].
  case=> cn <-; have [oc m I Fc] := (newsP c).1 cn; have lc := up c (heard_live Fc).
  have no' : c \in olds = false by apply/negP=> /oldsP[[_]|[_ /eqP]]; rewrite ?m ?other_old.
  by rewrite boundary_faceE ?placeE // other_new ?other_old // cn no'.
case: (x =P f) => [->|xf].
  case=> co <-; case: ((oldsP c).1 co) => [[oc m I Fc]|[nb cE]].
    have lc := up c (heard_live Fc).
    have nn : c \in news = false by apply/negP=> /newsP[_]; rewrite (negPf m).
    by rewrite boundary_faceE ?placeE // other_new ?other_old // nn co.
  rewrite cE in co *; by rewrite boundary_faceE ?placeE // on eqxx (negPf nb) co.
move=> E; have [Fc Pc] := @listed_names _ low x (Inner i) c E; have lc := heard_live Fc.
have oc : other c.
  split; last by apply/eqP; rewrite old_made.
  by move=> ck; move: Fc; rewrite ck kept_in_f => -[/esym].
have nn : c \in news = false by apply/negP=> /newsP[_ _ _]; rewrite Fc => -[].
have no : c \in olds = false.
  by apply/negP=> /oldsP[[_ _ _]|[_ /eqP]]; [rewrite Fc => -[]|rewrite other_old].
by rewrite boundary_faceE ?placeE ?up // other_new ?other_old // nn no.
Qed.

Lemma new_f2 : f2_listed t'.
Proof.
apply: f2_if => [c lc|x p c /listed_new[]//].
suff [x [p L]] : exists x p, listed t' x p = Some c.
  by have [_ Fc Pc] := listed_new L; exists x, p.
have gf : (f == g) = false by apply: old_face live_f.
case: (whichP lc) => [||{lc}c oc lc].
- case: (boolP bounding) => b; first by exists f, Outer; rewrite /= outerE gf eqxx b.
  exists f, (Inner (seq.index of_old olds)); apply/innerE; rewrite gf eqxx; split=> //.
  by apply/oldsP; right.
- by exists g, Outer; rewrite /= outerE eqxx.
have [x [p [lx Fc Pc L]]] := placeP low lc; have xg := old_face lx.
case: p L Pc => [|i] L Pc.
  exists x, Outer; rewrite /= outerE xg; case: ifP => // /andP[/eqP xf b].
  by move: L; rewrite xf /= (eqP b) => -[ck]; case: oc => nk _; case: nk.
case: (x =P f) => [xf|xf]; last by exists x, (Inner i); apply/innerE; rewrite xg; case: eqP.
have I : is_inner t c by exists i.
rewrite xf in Fc; case m: (moved c).
  by exists g, (Inner (seq.index c news)); apply/innerE; rewrite eqxx; split=> //; apply/newsP.
exists f, (Inner (seq.index c olds)); apply/innerE; rewrite gf eqxx; split=> //; apply/oldsP; left.
by split=> //; rewrite m.
Qed.


Lemma faces_of_boundaries c : boundary t' c -> leads_to (face t') (boundary_face t' c).
Proof.
move=> lc; have lf : face t' f by rewrite faceE live_f orbT.
have lg : face t' g by rewrite faceE eqxx.
rewrite boundary_faceE //; case: ifP => [_|on]; first by exists g.
case: ifP => [_|oo]; first by exists f.
case: ifP => _; first by exists g.
case: (whichP lc) on oo => [||{lc}c _ lc] on oo; [by rewrite eqxx in oo|by rewrite eqxx in on|].
by have [x [_ [lx -> _ _]]] := placeP low lc; exists x; rewrite ?faceE ?lx ?orbT.
Qed.

Lemma lists_of_faces : faces_live t'.
Proof.
move=> x lx; split=> [|i lt].
  by case O: (outer t' x) => [c|]; [right; exists c => //; have [] := @listed_new x Outer c O|left].
case I: (inner t' x i) => [c|]; first by exists c => //; have [] := @listed_new x (Inner i) c I.
move: I; rewrite /inner lt /=; move: lt; rewrite countE; case: (x =P g) => [_ lt|xg].
  by rewrite (nth_map 0).
case: (x =P f) => [_ lt|xf lt]; first by rewrite (nth_map 0).
have lx0 : face t x by move: lx; rewrite faceE; case: eqP.
have [[_ _ _ F] _] := keeps R1; have [_ /(_ i lt)[c E _]] := F x lx0; by move: E; rewrite /inner lt => ->.
Qed.

(** ** Where boundary components start: [left] at [h], [right] at [k] *)

Variables (h k : nat).
Hypothesis starts : forall c, says_boundary_start n c =
  if c == left then Some (AtHalfEdge h) else if c == right then Some (AtHalfEdge k) else says_boundary_start t c.

Lemma left_not_right : left <> right.
Proof. by case: two_cycles => -[-> ->]; [|apply: nesym]; apply: kept_not_made. Qed.

Lemma live_left : boundary t' left.
Proof. by rewrite boundaryE; case: two_cycles => -[-> _]; rewrite ?eqxx ?live_kept ?orbT. Qed.
Lemma live_right : boundary t' right.
Proof. by rewrite boundaryE; case: two_cycles => -[_ ->]; rewrite ?eqxx ?live_kept ?orbT. Qed.

Lemma otherP c : boundary t' c -> c <> left -> c <> right -> other c /\ boundary t c.
Proof.
rewrite boundaryE => lc cl cr; have [ck cm] : c <> kept /\ c <> made by case: two_cycles => -[l r]; rewrite -l -r.
by move: lc; case: eqP.
Qed.

Lemma startE c : boundary t' c -> boundary_start t' c =
  if c == left then Some (AtHalfEdge h) else if c == right then Some (AtHalfEdge k) else boundary_start t c.
Proof.
move=> lc; rewrite {1}/boundary_start /heard lc /= starts; case: (c =P left) => // cl; case: (c =P right) => // cr.
by have [_ lc0] := otherP lc cl cr; rewrite /boundary_start /heard lc0.
Qed.

Lemma start_other c : other c -> boundary t c -> boundary_start t' c = boundary_start t c.
Proof.
move=> [ck cm] lc; have [cl cr] : c <> left /\ c <> right by case: two_cycles => -[-> ->].
by rewrite startE ?boundaryE ?lc ?orbT // (introF eqP cl) (introF eqP cr).
Qed.

Lemma start_cycles v : ~ starts_at_vertex t' v of_old /\ ~ starts_at_vertex t' v of_new.
Proof.
have no c : c = left \/ c = right -> ~ starts_at_vertex t' v c.
  case=> ->; rewrite /starts_at_vertex startE ?live_left ?live_right // eqxx //.
  by case: ifP.
by case: two_faces => -[-> ->]; split; apply: no; auto.
Qed.

(** ** F1, T1, T2, T3: the same components, and their outsides where they were *)

Hypothesis vertexE : forall v, vertex t' v = vertex t v.
Hypothesis connectedE : forall u w, connected t' u w <-> connected t u w.
Hypothesis origin_up : forall i v, origin t i = Some v -> origin t' i = Some v.
Variable v0 : nat.
Hypothesis at_kept : vertex_at t kept = Some v0.
Hypothesis at_h : exists2 w, origin t' h = Some w & connected t v0 w.
Hypothesis at_k : exists2 w, origin t' k = Some w & connected t v0 w.

Lemma at_cycles : (exists2 w, vertex_at t' of_old = Some w & connected t v0 w) /\
  exists2 w, vertex_at t' of_new = Some w & connected t v0 w.
Proof.
have [hw Wh Ch] := at_h; have [kw Wk Ck] := at_k.
have L : vertex_at t' left = Some hw by rewrite /vertex_at startE ?live_left // eqxx.
have R : vertex_at t' right = Some kw.
  by rewrite /vertex_at startE ?live_right // eqxx; case: eqP => // /esym/left_not_right.
by case: two_faces => -[-> ->]; split; [exists hw|exists kw|exists kw|exists hw].
Qed.

Let at_old : exists2 w, vertex_at t' of_old = Some w & connected t v0 w. Proof. by case: at_cycles. Qed.
Let at_new : exists2 w, vertex_at t' of_new = Some w & connected t v0 w. Proof. by case: at_cycles. Qed.

Lemma at_other c : other c -> boundary t c -> vertex_at t' c = vertex_at t c.
Proof.
move=> oc lc; rewrite /vertex_at start_other //; case S: (boundary_start t c) => [[e|//]|//].
have [[H _ _ _] _] := keeps R1; have [[w W _] _ _ _ _] := H e (start_live keeps S).
by rewrite W; apply: origin_up.
Qed.

Let trans := @connected_trans t.
Let sym := connected_sym map.

Lemma unboundedE x : unbounded t' x <-> unbounded t x.
Proof.
rewrite /unbounded outerE faceE; case: (x =P g) => [->|_] /=.
  by split=> -[] //; rewrite (negPf free_face).
by case: ifP => // /andP[/eqP-> /eqP->]; split=> -[].
Qed.

Lemma new_f1 : f1_outer t'.
Proof.
have [[x [U one]] O] := keeps F1; split.
  by exists x; split; [apply/unboundedE|move=> y /unboundedE; apply: one].
move=> y c v E S; have [lc Fc _] := @listed_new y Outer c E; have [no nn] := start_cycles v.
case: (whichP lc) E S Fc => [||{lc}c oc lc] E S Fc //; move: S; rewrite /starts_at_vertex start_other //.
move: E; rewrite outerE; case: ifP => [_ [/eqP]|_]; first by rewrite eq_sym other_new.
by case: ifP => [_ [/eqP]|_]; [rewrite eq_sym other_old|apply: O].
Qed.

Lemma is_innerE c : is_inner t' c <-> (other c /\ is_inner t c) \/ (~~ bounding /\ c = of_old).
Proof.
have on : (of_old == of_new) = false by apply/eqP/old_not_new.
split=> [[i P]|].
  move: (P); rewrite (placeE (heard_live P)); case: (whichP (heard_live P)) => [||{P}c oc lc]; rewrite ?eqxx ?on //.
    by case: (boolP bounding) => // b _; right.
  rewrite other_new ?other_old //=; case: ifP => [/oldsP[[_ _ I _]|[_ /eqP]]|_]; [by left|by rewrite other_old|].
  by case: ifP => [/newsP[_ _ I _]|_ P]; left; split=> //; exists i.
case=> [[oc [i P]]|[nb ->]]; last first.
  rewrite /is_inner placeE ?live_old // on eqxx (negPf nb) /=.
  have -> : of_old \in olds by apply/oldsP; right.
  by exists (seq.index of_old olds).
have lc : boundary t' c by rewrite boundaryE (heard_live P) orbT.
rewrite /is_inner placeE // other_new ?other_old //=; case: ifP => _; first by exists (seq.index c olds).
by case: ifP => _; [exists (seq.index c news)|exists i].
Qed.

(** An outside afterwards, and the same before. *)
Definition later c := if c == kept then of_old else c.
Definition earlier c := if c == of_old then kept else c.

Lemma outside_later u c : outside_of t u c -> outside_of t' u (later c).
Proof.
move=> [I [w W C]]; have lc : boundary t c by case: I => i P; apply: heard_live P.
rewrite /later; case: (c =P kept) => ck.
  rewrite ck in I W; split; first by apply/is_innerE; right; split=> //; apply/kept_inner.
  have [w' W' C'] := at_old; exists w' => //; apply/connectedE; apply: trans C _.
  by move: W; rewrite at_kept => -[<-].
have oc : other c by split=> //; apply/eqP; rewrite old_made.
by split; [apply/is_innerE; left|exists w; [rewrite at_other|apply/connectedE]].
Qed.

Lemma outside_earlier u c : outside_of t' u c -> outside_of t u (earlier c) /\ (c = of_old \/ other c).
Proof.
move=> [/is_innerE I [w W /connectedE C]]; rewrite /earlier; case: I => [[oc I]|[nb cE]].
  have lc : boundary t c by case: I => i P; apply: heard_live P.
  rewrite other_old //; split; last by right.
  by split=> //; exists w => //; rewrite -at_other.
rewrite cE eqxx in W *; split; last by left.
split; first exact/kept_inner; exists v0 => //; apply: trans C _; apply: sym.
by have [w' W' C'] := at_old; move: W; rewrite W' => -[<-].
Qed.

Lemma new_t1 : t1_outside t'.
Proof.
move=> u; rewrite vertexE => lu; have [c [O one]] := keeps T1 u lu; exists (later c); split; first exact: outside_later.
move=> e /outside_earlier[/one -> e_is]; rewrite /later /earlier; case: (e =P of_old) => [-> |eo]; first by rewrite eqxx.
by case: e_is => [//|[ek _]]; case: eqP.
Qed.

(** If the old face is rooted, so is the new one: it is bounded by the same component, or by one that lies in the old one. *)
Lemma rooted_new : rooted t' f -> rooted t' g.
Proof.
move=> R; have [wn Wn Cn] := at_new; have On : outer t' g = Some of_new by rewrite outerE eqxx.
have same w : connected t v0 w -> connected t' wn w by move=> C; apply/connectedE; apply: trans (sym Cn) C.
have [wo Wo Co] := at_old; case: (boolP bounding) => b.
  have Oo : outer t' f = Some of_old by rewrite outerE (old_face live_f) eqxx b.
  have [d [y [[I [v V C]] Fd Ry]]] := rooted_from R Oo Wo; apply: (@rooted_out t' g of_new wn d y) => //.
  by split=> //; exists v => //; apply: same; apply: trans Co _; apply/connectedE.
apply: (@rooted_out t' g of_new wn of_old f) => //; last first.
  rewrite boundary_faceE ?live_old // eqxx; case: eqP => // /old_not_new [].
by split; [apply/is_innerE; right|exists wo => //; apply: same].
Qed.

Lemma rooted_up x : rooted t x -> rooted t' x.
Proof.
elim=> {x} [x /unboundedE U|x c w d y O W Od Fd _ IH]; first exact: rooted_here.
have [c' [w' [O' W' C']]] : exists c' w', [/\ outer t' x = Some c', vertex_at t' c' = Some w' & connected t' w' w].
  rewrite outerE (old_face (heard_live O)); case: ifP => [/andP[/eqP xf /eqP b]|no].
    have [wo Wo Co] := at_old; exists of_old, wo; split=> //; apply/connectedE; apply: sym.
    by move: O W; rewrite xf b => -[<-]; rewrite at_kept => -[<-].
  have [Fc _] := @listed_names _ low x Outer c O; have lc := heard_live Fc; exists c, w; split=> //.
    rewrite at_other //; split; last by apply/eqP; rewrite old_made.
    move=> ck; move: no Fc; rewrite ck kept_in_f => no [xf]; move: no.
    by rewrite -xf eqxx /bounds xf O ck eqxx.
  exact: connected_self.
have ld := heard_live Fd; have [I [v V C]] := outside_later Od.
have out z : boundary_face t' (later d) = Some z -> rooted t' z -> rooted t' x.
  move=> Fz; apply: (@rooted_out t' x c' w' (later d) z) => //.
  by split=> //; exists v => //; apply: connected_trans C' C.
rewrite /later in out; case: (d =P kept) out => [dk|dk] out.
  apply: (out y) => //; rewrite boundary_faceE ?live_old // eqxx; case: eqP => [/old_not_new []|_].
  by move: Fd; rewrite dk kept_in_f.
have od : other d by split=> //; apply/eqP; rewrite old_made.
have Fd' : boundary_face t' d = if d \in news then Some g else Some y.
  by rewrite boundary_faceE ?other_new ?other_old ?boundaryE ?ld ?orbT // Fd.
move: Fd'; case: ifP => [/newsP[_ _ _]|_ E]; last exact: out E IH.
by rewrite Fd => -[yf] E; rewrite yf in IH; apply: out E (rooted_new IH).
Qed.

Lemma new_t2 : t2_nesting t'.
Proof.
have R x : face t x -> rooted t' x by move=> lx; apply: rooted_up; apply: (face_rooted low (keeps T1) (keeps T2)).
move=> u c x _ [[i P] _] Fc; have [y Fy ly] := faces_of_boundaries (heard_live P).
move: Fc ly; rewrite Fy faceE => -[->] /orP[/eqP->|/R //]; apply: rooted_new; exact: R live_f.
Qed.

(** One edge, one face and no component more. *)
Lemma new_t3 : lower t' -> (forall es, lists_one_of_each es (same_edge t) (half_edge t) ->
  lists_one_of_each (h :: es) (same_edge t') (half_edge t')) -> t3_euler t'.
Proof.
move=> low' edge_more; have [es He] := edges_each low; have He' := edge_more es He; pose vs := [seq v <- iota 0 (vertex_slots t) | vertex t v].
have Hv : lists vs (vertex t) := lists_filter (@vertex_below t) (fun v => iff_refl (vertex t v)).
have Hv' : lists vs (vertex t') by apply: lists_iff Hv => v; rewrite vertexE.
pose fs := [seq x <- iota 0 (face_slots t) | face t x].
have Hf : lists fs (face t) := lists_filter (@face_below t) (fun x => iff_refl (face t x)).
have Hf' : lists (g :: fs) (face t').
  have [uf inf] := Hf; split=> [|x]; first by rewrite /= uf andbT; apply/negP=> /inf; rewrite (negPf free_face).
  rewrite inE faceE; case: (x == g) => //=; exact: inf.
have Hb : lists (inner_ones t) (is_inner t).
  by split=> [|c]; [rewrite !filter_uniq ?iota_uniq|apply: (inner_onesP low)].
have later_inj : {in inner_ones t &, injective later}.
  have lb c : c \in inner_ones t -> c <> made by move/(inner_onesP low)=> [i P]; apply/eqP; rewrite old_made ?(heard_live P).
  move=> c d /lb cm /lb dm; rewrite /later; case: (c =P kept) => [->|ck]; case: (d =P kept) => [->|dk] // E.
    by case: sides => -[o _]; rewrite o in E; [case: dk|case: dm].
  by case: sides => -[o _]; rewrite o in E; [case: ck|case: cm].
have Hb' : lists [seq later c | c <- inner_ones t] (is_inner t').
  have [ub inb] := Hb; split=> [|c]; first by rewrite map_inj_in_uniq.
  split=> [/mapP[d /inb I ->]|/is_innerE[[[ck cm] I]|[nb ->]]].
  - apply/is_innerE; rewrite /later; case: (d =P kept) => [dk|dk]; [right|left].
      by split=> //; apply/kept_inner; rewrite -dk.
    by split=> //; split=> //; case: I => i P; apply/eqP; rewrite old_made ?(heard_live P).
  - by apply/mapP; exists c; [apply/inb|rewrite /later; case: eqP].
  by apply/mapP; exists kept; [apply/inb/kept_inner|rewrite /later eqxx].
have eq := (t3_counts low (keeps T1) Hv He Hf Hb).1 (keeps T3).
apply/(t3_counts low' new_t1 Hv' He' Hf' Hb'); rewrite size_map /=; arith.
Qed.

(** ** All rules hold, if those of half-edges and vertices do *)

Lemma new_face_rules : half_edges_live t' -> vertices_live t' ->
  (forall i, half_edge t i -> half_edge t' i) -> half_edge t' h -> half_edge t' k ->
  l1_twin t' -> l2_next_prev t' -> l3_target t' -> v1_leaving t' -> v2_rotation t' -> b1_cycle t' -> b2_isolated t' ->
  (forall es, lists_one_of_each es (same_edge t) (half_edge t) ->
    lists_one_of_each (h :: es) (same_edge t') (half_edge t')) -> rules t'.
Proof.
move=> live_h live_v up lh lk l1 l2 l3 v1 v2 b1 b2 edge_more.
have links : links_live t'.
  split=> // [c lc|]; last exact: lists_of_faces.
  split; first exact: faces_of_boundaries.
  rewrite startE //; case: eqP => [//|cl]; case: eqP => [//|cr]; have [_ lc0] := otherP lc cl cr.
  by have [[_ _ B _] _] := keeps R1; have [_] := B c lc0; case: (boundary_start t c) => [[i|u]|] //=;
    [apply: up|rewrite vertexE].
have r1 : r1_live t' by split=> //; exact: lists_short_listed links new_f2.
have [f1 f2 t1 t2] := And4 new_f1 new_f2 new_t1 new_t2.
have low' : lower t' by case.
have t3 := new_t3 low' edge_more.
have H r : index r < index T4 -> holds t' r by case: r.
by move=> r; case: (ltnP (index r) (index T4)) => [/H //|]; case: r => // _; apply: t4_follows => q; apply: H.
Qed.

End NewFace.
