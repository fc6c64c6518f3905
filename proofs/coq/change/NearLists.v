(** * NearLists: which lists may be left unread after a change (near/check.rs)

    Boundary components and faces have changed. Read are the entries that were written, and those where a boundary component that
    has changed was listed; of each list the length is compared with what has come and gone. The rest of F2 follows.

<<
      before:  f lists  a b c        now:  f lists  a c        the entry of b was written, and says of c that it is there: read.
                                                               f has lost one, and its list is one shorter. a is not looked at
>>
*)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import Arith View Rules Map Lists Reference ReferenceProof Near.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** Beyond the slots there are none. *)
Lemma count_beyond n m (p : pred nat) : n <= m -> (forall i, p i -> i < n) -> count p (iota 0 m) = count p (iota 0 n).
Proof.
move=> le below; rewrite -(subnKC le) iotaD count_cat -[RHS]addn0; congr (_ + _).
apply/eqP; rewrite eqn0Ngt -has_count; apply/hasPn=> i; rewrite mem_iota add0n => /andP[ni _].
by apply/negP=> /below; rewrite ltnNge ni.
Qed.

Lemma count_split (c p : pred nat) s : count p s = count (fun b => c b && p b) s + count (fun b => ~~ c b && p b) s.
Proof. by elim: s => //= x s ->; rewrite addnACA; congr (_ + _); case: (c x); case: (p x). Qed.

Lemma says_below t f b : says_inside t f b -> b < boundary_slots t.
Proof. by case/andP=> /same_linkP F _; apply: boundary_below (heard_live F). Qed.

(** A list is as long as there are boundary components that say that they are in it. *)
Lemma length_of_list t f : links_live t -> f2_listed t -> inner_count t f = count (says_inside t f) (iota 0 (boundary_slots t)).
Proof.
move=> [_ _ _ F] f2; pose all_of := [seq odflt 0 (inner t f j) | j <- iota 0 (inner_count t f)].
have lf i : i < inner_count t f -> face t f by rewrite /inner_count; case: (face t f).
have entry i : i < inner_count t f -> exists b, [/\ inner t f i = Some b, boundary_face t b = Some f & boundary_place t b = Some (Inner i)].
  move=> lt; have [_ /(_ i lt)[b E lb]] := F f (lf i lt); exists b; have [g [p [Ef Ep L]]] := f2 b lb.
  by have [fg ip] := (L f (Inner i)).1 E; rewrite Ef Ep -fg -ip.
rewrite -size_filter -[LHS](size_iota 0) -(size_map (fun j => odflt 0 (inner t f j))); apply: perm_size; apply: uniq_perm.
- rewrite map_inj_in_uniq ?iota_uniq // => i j; rewrite !mem_iota !add0n => /entry[b [-> _ P]] /entry[c [-> _ Q]] /= bc.
  by move: P; rewrite bc Q => -[].
- exact: filter_uniq (iota_uniq _ _).
move=> b; rewrite mem_filter mem_iota add0n; apply/mapP/andP=> [[i]|[/andP[/same_linkP Eb P] _]].
  rewrite mem_iota add0n => /entry[c [-> Ef P]] /= ->; split; last exact: boundary_below (heard_live Ef).
  by rewrite /says_inside Ef P /= eqxx.
case P': (boundary_place t b) P => [[|i]|] // _; have [g [p [Eg Ep L]]] := f2 b (heard_live Eb).
move: Eg Ep; rewrite Eb P' => -[fg] [ip]; have I : inner t f i = Some b by apply/(L f (Inner i)); rewrite fg ip.
by exists i; rewrite ?I // mem_iota add0n (inner_lt I).
Qed.

Lemma says_listed t b f p : f2_listed t -> boundary_face t b = Some f -> boundary_place t b = Some p -> listed t f p = Some b.
Proof.
move=> f2 F P; have [g [q [Eg Eq L]]] := f2 b (heard_live F); move: Eg Eq; rewrite F P => -[fg] [pq].
by apply/L; rewrite fg pq.
Qed.

Lemma listed_says t f p b : links_live t -> f2_listed t -> listed t f p = Some b -> boundary_face t b = Some f /\ boundary_place t b = Some p.
Proof.
move=> [_ _ _ F] f2 L; have lb : boundary t b.
  case: p L => [|i] L.
    by have [[N|[c C lc]] _] := F f (heard_live (L : outer t f = Some b)); [rewrite /= N in L | move: L; rewrite /= C => -[<-]].
  have lt := inner_lt (L : inner t f i = Some b); have lf : face t f by move: lt; rewrite /inner_count; case: (face t f).
  by have [_ /(_ i lt)[c C lc]] := F f lf; move: L; rewrite /= C => -[<-].
have [g [q [Eg Eq U]]] := f2 b lb; have [-> ->] := (U f p).1 L; by split.
Qed.

Section Near.
Variables t t' : view.
Hypotheses (links : links_live t) (before : f2_listed t).

(** Boundary components that are looked at; faces whose outer boundary component may be another one, and that are looked at; entries
    that are read. *)
Variables (changed : pred nat) (written looked : pred nat) (read : nat -> nat -> Prop).

Hypothesis same_row : forall b, ~~ changed b ->
  [/\ boundary t' b = boundary t b, boundary_face t' b = boundary_face t b & boundary_place t' b = boundary_place t b].
Hypothesis same_outer : forall f, ~~ written f -> outer t' f = outer t f.
Hypothesis same_entry : forall f i, i < inner_count t' f -> read f i \/ i < inner_count t f /\ inner t' f i = inner t f i.

(** Looked at are those that the faces that were written had as their outer ones, and the faces of those that have changed. *)
Hypothesis outer_changed : forall f b, written f -> outer t f = Some b -> changed b.
Hypothesis face_looked : forall b f, changed b -> boundary_face t b = Some f -> looked f.
Hypothesis written_looked : forall f, written f -> looked f.

(** The entry of one that has changed is read. *)
Hypothesis entry_read : forall b f i, changed b -> boundary_face t b = Some f -> boundary_place t b = Some (Inner i) -> read f i.

(** They say a face and a place; who says that it is an outer one is. *)
Definition changed_right := forall b, changed b -> boundary t' b -> exists f p,
  [/\ boundary_face t' b = Some f, boundary_place t' b = Some p & p = Outer -> outer t' f = Some b].
Definition looked_right := forall f b, looked f -> outer t' f = Some b -> boundary_face t' b = Some f /\ boundary_place t' b = Some Outer.

(** Each entry that is read says so itself. *)
Definition read_right := forall f i, i < inner_count t' f -> read f i ->
  exists b, [/\ inner t' f i = Some b, boundary_face t' b = Some f & boundary_place t' b = Some (Inner i)].

(** The length of a list has changed by those that have come, less those that have gone. *)
Definition changed_inside v f := count (fun b => changed b && says_inside v f b) (iota 0 (boundary_slots v)).
Definition lengths_right := forall f, inner_count t' f + changed_inside t f = inner_count t f + changed_inside t' f.

(** Those that say that they are inside, and have changed or not: of those that have not, there are as many as before. *)
Lemma inside_parts f : exists rest, count (says_inside t f) (iota 0 (boundary_slots t)) = changed_inside t f + rest /\
  count (says_inside t' f) (iota 0 (boundary_slots t')) = changed_inside t' f + rest.
Proof.
pose N := maxn (boundary_slots t) (boundary_slots t').
have kept v : boundary_slots v <= N -> count (says_inside v f) (iota 0 (boundary_slots v)) =
    changed_inside v f + count (fun b => ~~ changed b && says_inside v f b) (iota 0 N).
  move=> le; rewrite /changed_inside -(count_beyond le) => [|b /says_below //]; rewrite (count_split changed); congr (_ + _).
  by apply: count_beyond le _ => b /andP[_ /says_below].
have rest : count (fun b => ~~ changed b && says_inside t' f b) (iota 0 N) = count (fun b => ~~ changed b && says_inside t f b) (iota 0 N).
  apply: eq_count => b; case: (boolP (changed b)) => //= /same_row[_ F P]; by rewrite /says_inside F P.
exists (count (fun b => ~~ changed b && says_inside t f b) (iota 0 N)); split; first exact: kept (leq_maxl _ _).
by rewrite -rest; apply: kept (leq_maxr _ _).
Qed.

Theorem near_lists_right : changed_right -> looked_right -> read_right -> lengths_right -> f2_listed t'.
Proof.
move=> changed_ok looked_ok read_ok lengths; apply: lists_by_length.
- move=> b lb; case: (boolP (changed b)) => [/changed_ok/(_ lb)[f [p [F P _]]]|/same_row[L F P]]; first by exists f, p.
  by rewrite L in lb; have [f [p [Ef Ep _]]] := before lb; exists f, p; rewrite F P.
- move=> f i lt; case: (same_entry lt) => [/(read_ok f i lt) //|[lt' E]].
  have lf : face t f by move: lt'; rewrite /inner_count; case: (face t f).
  have [_ _ _ /(_ f lf)[_ /(_ i lt')[b I lb]]] := links; have [F P] := listed_says links before (I : listed t f (Inner i) = Some b).
  case: (boolP (changed b)) => [cb|/same_row[_ F' P']]; first exact: (read_ok f i lt (entry_read cb F P)).
  by exists b; rewrite E I F' P'.
- move=> f; have [rest [E E']] := inside_parts f; have := lengths f.
  rewrite (length_of_list f links before) E E'; arith.
move=> f b; split=> [O|[F P]].
  case: (boolP (looked f)) => [/looked_ok/(_ O) //|nl].
  have nw : ~~ written f by apply/negP=> /written_looked; apply/negP.
  have [F P] := listed_says links before (etrans (esym (same_outer nw)) O : listed t f Outer = Some b).
  case: (boolP (changed b)) => [/face_looked/(_ F)|/same_row[_ -> ->]] //; by rewrite (negPf nl).
case: (boolP (changed b)) => [cb|nb].
  have [g [p [G Q O]]] := changed_ok b cb (heard_live F); move: G Q; rewrite F P => -[fg] [po].
  by rewrite fg O.
have [_ F' P'] := same_row nb; rewrite F' in F; rewrite P' in P; have O := says_listed before F P.
by rewrite same_outer //; apply/negP=> w; case/negP: nb; apply: outer_changed O.
Qed.

(** Nothing that is right is refused. *)
Theorem near_lists : links_live t' ->
  f2_listed t' <-> [/\ changed_right, looked_right, read_right & lengths_right].
Proof.
move=> links'; split=> [f2|[]]; last exact: near_lists_right.
split=> [b _ lb|f b _ O|f i lt _|f].
- have [f [p [F P L]]] := f2 b lb; exists f, p; split=> // po; have := (L f p).2 (conj erefl erefl); by rewrite po.
- exact: listed_says links' f2 (O : listed t' f Outer = Some b).
- have lf : face t' f by move: lt; rewrite /inner_count; case: (face t' f).
  have [_ _ _ /(_ f lf)[_ /(_ i lt)[b I lb]]] := links'; exists b.
  by have [F P] := listed_says links' f2 (I : listed t' f (Inner i) = Some b).
have [rest [E E']] := inside_parts f; rewrite (length_of_list f links' f2) (length_of_list f links before) E E'; arith.
Qed.

End Near.
