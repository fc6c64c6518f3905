(** * Counting: two lists that list the same are equally long *)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import Arith View Rules.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Lemma lists_size (s s' : seq nat) (P : nat -> Prop) : lists s P -> lists s' P -> size s = size s'.
Proof.
case=> u H [u' H']; apply: perm_size; apply: uniq_perm => // x.
by apply/idP/idP => [/H/H'|/H'/H].
Qed.

Lemma lists_iff (s : seq nat) (P Q : nat -> Prop) : (forall x, P x <-> Q x) -> lists s P -> lists s Q.
Proof. by move=> PQ [u H]; split=> // x; rewrite H. Qed.

(** One less, and one more. *)
Lemma lists_rem (s : seq nat) (P : nat -> Prop) x : lists s P -> lists (rem x s) (fun y => y <> x /\ P y).
Proof.
case=> u H; split=> [|y]; first exact: rem_uniq.
by rewrite mem_rem_uniq // !inE; split=> [/andP[/eqP yx /H]|[/eqP-> /H]].
Qed.

Lemma lists_cons (s : seq nat) (P : nat -> Prop) x : ~ P x -> lists s P -> lists (x :: s) (fun y => y = x \/ P y).
Proof.
move=> no [u H]; split=> [|y]; first by rewrite /= u andbT; apply/negP=> /H.
by rewrite inE; split=> [/orP[/eqP|/H]|[->|/H ->]]; rewrite ?eqxx ?orbT; auto.
Qed.

Lemma size_lists_rem (s : seq nat) (P : nat -> Prop) x : lists s P -> P x -> size s = (@size nat (rem x s)).+1.
Proof. by case=> _ H /H xs; rewrite size_rem //; case: s xs {H}. Qed.

Lemma lists_filter n (p : pred nat) (P : nat -> Prop) : (forall x, p x -> x < n) -> (forall x, p x <-> P x) ->
  lists [seq x <- iota 0 n | p x] P.
Proof.
move=> lt pP; split=> [|x]; first exact: filter_uniq (iota_uniq _ _).
by rewrite mem_filter mem_iota add0n -pP; split=> [/andP[]//|px]; rewrite px lt.
Qed.

Lemma lists_count n (p : pred nat) (s : seq nat) (P : nat -> Prop) : (forall x, p x -> x < n) -> (forall x, p x <-> P x) ->
  lists s P -> size s = count p (iota 0 n).
Proof. by move=> lt pP H; rewrite (lists_size H (lists_filter lt pP)) size_filter. Qed.

(** A list that has one of each is no longer than another that does. *)
Lemma one_of_each_size_le (s s' : seq nat) (same : nat -> nat -> Prop) (P : nat -> Prop) :
  (forall x y, P x -> P y -> same x y -> same y x) -> (forall x y z, same x y -> same y z -> same x z) ->
  lists_one_of_each s same P -> lists_one_of_each s' same P -> size s <= size s'.
Proof.
move=> sym trans [u sP one _] [_ sP' _ all'].
pose rep (x y : nat) := y \in s' /\ same y x.
suff: forall r, uniq r -> {subset r <= s} -> exists r', [/\ size r' = size r, uniq r' & forall y, y \in r' ->
    exists2 x, x \in r & rep x y].
  move=> /(_ s u (fun x H => H))[r' [<- u' H]]; apply: uniq_leq_size => // y /H[x _ []] //.
elim=> [|x r IH] /=; first by exists [::].
case/andP=> xr ur sub; case: IH => // [y yr|r' [sz u' H]]; first by apply: sub; rewrite inE yr orbT.
have xs : x \in s by apply: sub; apply: mem_head.
case: (all' x (sP x xs)) => y ys' yx; exists (y :: r'); split=> /=; first by rewrite sz.
  rewrite u' andbT; apply/negP=> /H[z zr [_ yz]]; move: xr; rewrite (one x z) ?zr //.
    by apply: sub; rewrite inE zr orbT.
  by apply: trans yz; apply: sym => //; [apply: sP'|apply: sP].
move=> z; rewrite inE => /orP[/eqP->|/H[w wr wz]]; first by exists x; rewrite ?mem_head.
by exists w; rewrite // inE wr orbT.
Qed.

Lemma one_of_each_size (s s' : seq nat) (same : nat -> nat -> Prop) (P : nat -> Prop) :
  (forall x y, P x -> P y -> same x y -> same y x) -> (forall x y z, same x y -> same y z -> same x z) ->
  lists_one_of_each s same P -> lists_one_of_each s' same P -> size s = size s'.
Proof. by move=> sym trans a b; apply/eqP; rewrite eqn_leq !(one_of_each_size_le sym trans). Qed.

Lemma one_of_each_iff (s : seq nat) (same : nat -> nat -> Prop) (P Q : nat -> Prop) : (forall x, P x <-> Q x) ->
  lists_one_of_each s same P -> lists_one_of_each s same Q.
Proof. by move=> PQ [u H1 H2 H3]; split=> // [x /H1/PQ //|x /PQ/H3]. Qed.

(** Exactly one of them. *)
Lemma count1P n (p : pred nat) : (forall i, p i -> i < n) -> reflect (exists! i, p i) (count p (iota 0 n) == 1).
Proof.
move=> lt; rewrite -size_filter.
have mem i : (i \in [seq i <- iota 0 n | p i]) = p i.
  by rewrite mem_filter mem_iota add0n andbC; case E: (p i); rewrite ?andbF // andbT lt.
have u : uniq [seq i <- iota 0 n | p i] by rewrite filter_uniq ?iota_uniq.
move: {-2}(filter _ _) (erefl [seq i <- iota 0 n | p i]) => s E; rewrite -E in mem u.
apply: (iffP eqP) => [|[i [pi one]]].
  case: s mem {u E} => [//|i [|//]] mem _; exists i; split; first by rewrite -mem mem_head.
  by move=> j; rewrite -mem inE => /eqP.
have/perm_size-> // : perm_eq s [:: i].
by apply: uniq_perm => // j; rewrite mem inE; apply/idP/eqP => [/one|->].
Qed.

(** ** Lists of lists *)

(** Lists without repetition that have nothing in common make one without repetition. *)
Lemma uniq_flatten (A : eqType) (s : seq nat) (T : nat -> seq A) : uniq s -> (forall b, b \in s -> uniq (T b)) ->
  (forall b c x, b \in s -> c \in s -> x \in T b -> x \in T c -> b = c) -> uniq (flatten [seq T b | b <- s]).
Proof.
elim: s => //= b s IH /andP[bs u] each one; rewrite cat_uniq each ?mem_head //= IH //; first last.
- by move=> c d x cs ds; apply: one; rewrite inE ?cs ?ds orbT.
- by move=> c cs; apply: each; rewrite inE cs orbT.
rewrite andbT; apply/hasPn=> x /flattenP[t /mapP[c cs ->] xc]; apply/negP=> xb.
by move: bs; rewrite (one b c x) ?cs ?mem_head // inE cs orbT.
Qed.

Lemma size_flatten_map (A : eqType) (s : seq nat) (T : nat -> seq A) :
  size (flatten [seq T b | b <- s]) = sumn [seq size (T b) | b <- s].
Proof. by elim: s => //= b s IH; rewrite size_cat IH. Qed.

(** Lists of different boundary components are short. *)
Lemma lists_short_if t : (forall f i, face t f -> i < inner_count t f -> exists b,
    [/\ inner t f i = Some b, boundary_face t b = Some f & boundary_place t b = Some (Inner i)]) -> lists_short t.
Proof.
move=> H; pose T f := [seq odflt 0 (inner t f i) | i <- iota 0 (inner_count t f)].
have TP f b : b \in T f -> exists i, boundary_face t b = Some f /\ boundary_place t b = Some (Inner i).
  case/mapP=> i; rewrite mem_iota add0n => lt ->; have lf : face t f by move: lt; rewrite /inner_count; case: ifP.
  by have [c [-> Ef Ep]] := H f i lf lt; exists i.
have u : uniq (flatten [seq T f | f <- iota 0 (face_slots t)]).
  apply: uniq_flatten; first exact: iota_uniq.
    move=> f _; rewrite map_inj_in_uniq ?iota_uniq // => i j; rewrite !mem_iota !add0n => li lj.
    have lf : face t f by move: li; rewrite /inner_count; case: ifP.
    have [b [-> _ P]] := H f i lf li; have [c [-> _ Q]] := H f j lf lj; rewrite /= => bc.
    by move: P; rewrite bc Q => -[].
  by move=> f g b _ _ /TP[i [Ef _]] /TP[j [Eg _]]; move: Ef; rewrite Eg => -[].
have sub : {subset flatten [seq T f | f <- iota 0 (face_slots t)] <= [seq b <- iota 0 (boundary_slots t) | boundary t b]}.
  move=> b /flattenP[s /mapP[f _ ->] /TP[i [E _]]]; rewrite mem_filter mem_iota add0n.
  have lb : boundary t b by move: E; rewrite /boundary_face /heard; case: ifP.
  by rewrite lb; case/andP: lb.
have := uniq_leq_size u sub; rewrite size_flatten_map size_filter /lists_short.
have -> : [seq size (T f) | f <- iota 0 (face_slots t)] = [seq inner_count t f | f <- iota 0 (face_slots t)].
  by apply: eq_map => f; rewrite size_map size_iota.
move=> le; apply: leq_trans le _; apply: leq_trans (leq_addr _ _).
by rewrite leq_pmull.
Qed.

(** So they are where all that is listed is live, and listed once. *)
Lemma lists_short_listed t : links_live t -> f2_listed t -> lists_short t.
Proof.
case=> _ _ _ F f2; apply: lists_short_if => f i lf lt; have [_ I] := F f lf; have [b E lb] := I i lt; exists b.
have [f' [p' [Ef Ep L]]] := f2 b lb; have [ff ip] := (L f (Inner i)).1 E.
by split=> //; [rewrite ff|rewrite ip].
Qed.
