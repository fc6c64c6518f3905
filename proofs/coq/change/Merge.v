(** * Merge: summaries of tiles add up, in any order (tile/merge.rs)

    An edge that a border cuts is a *contact* of the tiles on both sides: each lists its key and the label that the edge has there, be it
    of a component, a cycle or a face. A summary forgets the inside. It keeps the contacts that have one side only so far, and
    which labels are one. Merging matches the contacts of both; what it gives is the summary of both together.

<<
      one tile        another                     together
      ──── 3 | k      k | 8 ────                  3 and 8 are one; k is no longer open
      ──── 4 | j                                  ──── 4 | j
>>

    Labels of different tiles are different numbers, as after `beside`. Union-find is here what it computes: which labels are one.
    Not here: the faults of a contact that the other side lacks, which stays open, and what is summed. *)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import Arith.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** A key and a label. *)
Definition contact := (nat * nat)%type.

Record summary := Summary {
  is_open : contact -> Prop;
  are_one : nat -> nat -> Prop
}.

(** Labels that such pairs lead from one to the other. *)
Inductive joined (pair : nat -> nat -> Prop) x : nat -> Prop :=
  | joined_self : joined pair x x
  | joined_on y z : joined pair x y -> pair y z \/ pair z y -> joined pair x z.

(** The contacts with this key. *)
Definition sides (cs : seq contact) k := count (fun c => c.1 == k) cs.

Definition meet (cs : seq contact) x y := exists k, (k, x) \in cs /\ (k, y) \in cs.

(** The summary of tiles with these contacts. *)
Definition summarize (cs : seq contact) :=
  Summary (fun c => c \in cs /\ sides cs c.1 = 1) (joined (meet cs)).

Definition matched a b x y := exists k, is_open a (k, x) /\ is_open b (k, y).

(** It asks for nothing but the two summaries. *)
Definition merge a b := Summary
  (fun c => is_open a c /\ (forall x, ~ is_open b (c.1, x)) \/ is_open b c /\ forall x, ~ is_open a (c.1, x))
  (joined (fun x y => [\/ are_one a x y, are_one b x y | matched a b x y])).

(** Two summaries say the same. *)
Definition same a b := (forall c, is_open a c <-> is_open b c) /\ forall x y, are_one a x y <-> are_one b x y.

(** A border has two sides. *)
Definition two_sided cs := forall k, sides cs k <= 2.

(** ** Joining *)

Lemma joined_trans pair x y z : joined pair x y -> joined pair y z -> joined pair x z.
Proof. by move=> xy; elim=> // v w _ xv; apply: joined_on. Qed.

Lemma joined_pair (pair : nat -> nat -> Prop) x y : pair x y \/ pair y x -> joined pair x y.
Proof. by apply: joined_on; apply: joined_self. Qed.

Lemma joined_sym pair x y : joined pair x y -> joined pair y x.
Proof. by elim=> [|v w _ IH vw]; [left | apply: joined_trans IH; apply: joined_pair; case: vw; [right|left]]. Qed.

Lemma joined_within (P Q : nat -> nat -> Prop) x y : (forall v w, P v w -> joined Q v w) -> joined P x y -> joined Q x y.
Proof.
move=> PQ; elim=> [|v w _ IH vw]; first exact: joined_self.
by apply: joined_trans IH _; case: vw => /PQ // /joined_sym.
Qed.

Lemma joined_same (P Q : nat -> nat -> Prop) x y : (forall v w, P v w <-> Q v w) -> joined P x y <-> joined Q x y.
Proof. by move=> PQ; split; apply: joined_within => v w /PQ vw; apply: joined_pair; left. Qed.

(** ** Saying the same *)

Lemma same_refl a : same a a. Proof. by []. Qed.

Lemma same_sym a b : same a b -> same b a.
Proof. by case=> O J; split=> [c|x y]; [rewrite O | rewrite J]. Qed.

Lemma same_trans a b c : same a b -> same b c -> same a c.
Proof. by move=> [O J] [O' J']; split=> [d|x y]; [rewrite O O' | rewrite J J']. Qed.

Lemma merge_same a a' b b' : same a a' -> same b b' -> same (merge a b) (merge a' b').
Proof.
have half a1 a2 b1 b2 x y : same a1 a2 -> same b1 b2 -> are_one (merge a1 b1) x y -> are_one (merge a2 b2) x y.
  move=> [Oa Ja] [Ob Jb]; apply: joined_within => v w; case=> [/Ja o|/Jb o|[k [/Oa A /Ob B]]]; apply: joined_pair; left;
    [by constructor 1|by constructor 2|by constructor 3; exists k].
have open a1 a2 b1 b2 c : same a1 a2 -> same b1 b2 -> is_open (merge a1 b1) c -> is_open (merge a2 b2) c.
  by move=> [Oa _] [Ob _] [] [o none]; [left|right]; split; [exact/Oa|move=> x /Ob/none|exact/Ob|move=> x /Oa/none].
by move=> A B; have [A' B'] := (same_sym A, same_sym B); split=> [c|x y]; split; [apply: open|apply: open|apply: half|apply: half].
Qed.

Theorem merge_commutes a b : same (merge a b) (merge b a).
Proof.
split=> [c|x y] /=; first by split; case; [right|left|right|left].
by split; apply: joined_within => v w [o|o|[k [A B]]]; apply: joined_pair; [left; constructor 2|left; constructor 1
  |right; constructor 3; exists k|left; constructor 2|left; constructor 1|right; constructor 3; exists k].
Qed.

(** ** Merging is putting together *)

Lemma some_side cs c : c \in cs -> 0 < sides cs c.1.
Proof. by move=> in_; rewrite -has_count; apply/hasP; exists c. Qed.

Lemma side_some cs k : 0 < sides cs k -> exists x, (k, x) \in cs.
Proof. by rewrite -has_count => /hasP[[j x] in_ /eqP /= <-]; exists x. Qed.

Section Together.
Variables A B : seq contact.
Hypothesis two : two_sided (A ++ B).

Lemma sides_cat k : sides (A ++ B) k = sides A k + sides B k.
Proof. exact: count_cat. Qed.

Lemma one_each c d : c \in A -> d \in B -> c.1 = d.1 -> sides A c.1 = 1 /\ sides B c.1 = 1.
Proof.
move=> /some_side a /some_side + cd; rewrite -cd => b; have := two c.1; rewrite sides_cat.
by move: a b; case: (sides A _) => [|[|m]] //; case: (sides B _) => [|[|l]] //; rewrite ?addnS ?addSn.
Qed.

Theorem merge_is_union : same (merge (summarize A) (summarize B)) (summarize (A ++ B)).
Proof.
split=> [[k x]|x y] /=.
  rewrite mem_cat sides_cat; split.
    case=> -[[in_ one] none]; rewrite in_ one ?orbT; split=> //.
      case: (posnP (sides B k)) => [-> //|/side_some[z inB]].
      by have [_ oneB] := one_each in_ inB erefl; case: (none z).
    case: (posnP (sides A k)) => [-> //|/side_some[z inA]].
    by have [oneA _] := one_each inA in_ erefl; case: (none z).
  case=> /orP[] in_; have := some_side in_ => /= pos sum; [left|right].
    have [a b] : sides A k = 1 /\ sides B k = 0.
      by move: pos sum; rewrite /=; arith.
    by split=> // z [/some_side /=]; rewrite b.
  have [a b] : sides A k = 0 /\ sides B k = 1.
    by move: pos sum; rewrite /=; arith.
  by split=> // z [/some_side /=]; rewrite a.
split; apply: joined_within => v w.
  case; [| |move=> [k [[inA _] [inB _]]]; apply: joined_pair; left; exists k; by rewrite !mem_cat inA inB orbT].
    by apply: joined_within => p q [k [P Q]]; apply: joined_pair; left; exists k; rewrite !mem_cat P Q.
  by apply: joined_within => p q [k [P Q]]; apply: joined_pair; left; exists k; rewrite !mem_cat P Q !orbT.
case=> k []; rewrite !mem_cat => /orP[] P /orP[] Q; apply: joined_pair.
- by left; constructor 1; apply: joined_pair; left; exists k.
- by left; constructor 3; exists k; have [a b] := one_each P Q erefl.
- by right; constructor 3; exists k; have [a b] := one_each Q P erefl.
- by left; constructor 2; apply: joined_pair; left; exists k.
Qed.

End Together.

(** ** Any order *)

Lemma summarize_perm cs ds : perm_eq cs ds -> same (summarize cs) (summarize ds).
Proof.
move=> p; have mem := perm_mem p; split=> [c|x y] /=; first by rewrite mem /sides (permP p).
by apply: joined_same => v w; split=> -[k PQ]; exists k; move: PQ; rewrite !mem.
Qed.

(** A way of merging: a tile with its contacts, or two ways merged. *)
Inductive way := Tile of seq contact | Merged of way & way.

Fixpoint contacts w := match w with Tile cs => cs | Merged v w => contacts v ++ contacts w end.
Fixpoint result w := match w with Tile cs => summarize cs | Merged v w => merge (result v) (result w) end.

Theorem result_is_summary w : two_sided (contacts w) -> same (result w) (summarize (contacts w)).
Proof.
elim: w => [cs|v IHv w IHw] two /=; first exact: same_refl.
have le k := two k; apply: same_trans (merge_is_union two); apply: merge_same.
  by apply: IHv => k; apply: leq_trans (le k); rewrite /= sides_cat leq_addr.
by apply: IHw => k; apply: leq_trans (le k); rewrite /= sides_cat leq_addl.
Qed.

(** However the same tiles are merged, the result is the same. *)
Theorem merged_anyhow v w : two_sided (contacts v) -> perm_eq (contacts v) (contacts w) -> same (result v) (result w).
Proof.
move=> two p; have two' : two_sided (contacts w) by move=> k; have := two k; rewrite /sides (permP p).
apply: same_trans (result_is_summary two) (same_trans (summarize_perm p) _).
exact: same_sym (result_is_summary two').
Qed.

Theorem merge_associates u v w : two_sided (contacts u ++ contacts v ++ contacts w) ->
  same (merge (result u) (merge (result v) (result w))) (merge (merge (result u) (result v)) (result w)).
Proof.
move=> two; apply: (@merged_anyhow (Merged u (Merged v w)) (Merged (Merged u v) w) two).
by rewrite /= catA perm_refl.
Qed.

(** Tiles without contacts change nothing. *)
Theorem merge_nothing w : two_sided (contacts w) -> same (merge (result w) (summarize [::])) (result w).
Proof.
move=> two; apply: (@merged_anyhow (Merged w (Tile [::])) w); rewrite /= cats0 //.
Qed.

(** Without the hypothesis merging is not associative: of three sides with one key the third is left. *)
Example three_sides : let side x := summarize [:: (0, x)] in
  ~ same (merge (side 1) (merge (side 2) (side 3))) (merge (merge (side 1) (side 2)) (side 3)).
Proof.
move=> side [O _]; have one x y : is_open (side x) (0, y) <-> y = x.
  by rewrite /side /= inE; split=> [[/eqP[]]|->].
have none x y z : ~ is_open (merge (side x) (side y)) (0, z).
  by case=> -[_ H]; [apply: (H y)|apply: (H x)]; apply/one.
have [H _] := O (0, 1); case: H => [|[/none]|[/one]] //.
by left; split=> [|x /none]; first exact/one.
Qed.
