(** * Orientation: points with integer coordinates, and one triangle

    Points are pairs of integers. Doubles are integers, too, once all are multiplied by one power of two. What is said here
    of one triangle is decided by signs alone: heights above the point that is asked for, and signed areas. *)

From Coq Require Import ZArith Lia.
From mathcomp Require Import all_ssreflect.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Local Open Scope Z_scope.

Definition point : Type := (Z * Z)%type.

Definition sub (a b : point) : point := (a.1 - b.1, a.2 - b.2).
Definition plus (a b : point) : point := (a.1 + b.1, a.2 + b.2).
Definition scaled (k : Z) (a : point) : point := (k * a.1, k * a.2).
Definition cross (a b : point) : Z := a.1 * b.2 - b.1 * a.2.
Definition dot (a b : point) : Z := a.1 * b.1 + a.2 * b.2.

(** Twice the signed area of the triangle: positive if [p] is to the left of the line from [a] to [b]. *)
Definition orient (a b p : point) : Z := cross (sub a p) (sub b p).

(** The point is on the segment, and not at its ends. *)
Definition strictly_between (a b p : point) : Prop := orient a b p = 0 /\ dot (sub a p) (sub b p) < 0.

(** ** Where the ray to the right of a point is crossed

    1 upwards, −1 downwards. It is half open, as if the point were moved by (ε, ε²), so that it is defined for all points. *)

Definition crossing (p a b : point) : Z :=
  if a.2 <=? p.2 then if b.2 <=? p.2 then 0 else if 0 <? orient a b p then 1 else 0
  else if b.2 <=? p.2 then if orient a b p <? 0 then - 1 else 0 else 0.

(** The number of times that the triangle runs around the point. *)
Definition around (p a b c : point) : Z := crossing p a b + crossing p b c + crossing p c a.

Lemma orient_swap a b p : orient b a p = - orient a b p.
Proof. by rewrite /orient /cross /sub /=; ring. Qed.

Lemma orient_turn a b c : orient b c a = orient a b c.
Proof. by rewrite /orient /cross /sub /=; ring. Qed.

Lemma crossing_swap p a b : crossing p b a = - crossing p a b.
Proof.
rewrite /crossing (orient_swap a b); set o := orient a b p.
case: (Z.leb_spec a.2 p.2) => _; case: (Z.leb_spec b.2 p.2) => _ //.
  by case: (Z.ltb_spec (- o) 0) => ?; case: (Z.ltb_spec 0 o) => ? //; lia.
by case: (Z.ltb_spec 0 (- o)) => ?; case: (Z.ltb_spec o 0) => ? //; lia.
Qed.

(** ** A triangle that runs counter-clockwise

    With the heights of its corners and the signed areas at the point as numbers. *)

Section Numbers.
Variables (ha hb hc u v w : Z).
Hypothesis total : 0 < u + v + w.
Hypothesis balance : v * ha + w * hb + u * hc = 0.
Hypothesis flat : ha = 0 -> hb = 0 -> u = 0.

Definition step (h k s : Z) : Z :=
  if h <=? 0 then if k <=? 0 then 0 else if 0 <? s then 1 else 0
  else if k <=? 0 then if s <? 0 then - 1 else 0 else 0.

Lemma steps : let n := step ha hb u + step hb hc v + step hc ha w in
  (n = 0 \/ n = 1) /\ (n = 1 -> 0 <= u /\ 0 <= v /\ 0 <= w) /\ (0 < u -> 0 < v -> 0 < w -> n = 1).
Proof.
rewrite /step.
case: (Z.leb_spec ha 0) => Ha; case: (Z.leb_spec hb 0) => Hb; case: (Z.leb_spec hc 0) => Hc.
all: repeat (let H := fresh in case: (Z.ltb_spec _ _) => H); cbn.
all: try (exfalso; lia).
all: split; [try lia; exfalso; nia|split; [try lia; move=> _; nia|try lia; move=> ? ? ?; exfalso; nia]].
Qed.
End Numbers.

(** The triangle runs around a point once or not at all; if once, the point is not to the right of a side; and once, if it
    is to the left of all. *)
Lemma around_once a b c p : 0 < orient a b c -> let n := around p a b c in
  (n = 0 \/ n = 1) /\ (n = 1 -> 0 <= orient a b p /\ 0 <= orient b c p /\ 0 <= orient c a p) /\
  (0 < orient a b p -> 0 < orient b c p -> 0 < orient c a p -> n = 1).
Proof.
move=> pos.
have stepE x y : crossing p x y = step (x.2 - p.2) (y.2 - p.2) (orient x y p).
  rewrite /crossing /step.
  have leE z : (z - p.2 <=? 0) = (z <=? p.2) by case: (Z.leb_spec z p.2); case: (Z.leb_spec (z - p.2) 0) => //; lia.
  by rewrite !leE.
rewrite /around !stepE; apply: steps.
- suff <- : orient a b c = orient a b p + orient b c p + orient c a p by [].
  by rewrite /orient /cross /sub /=; ring.
- by rewrite /orient /cross /sub /=; ring.
move=> ha hb; rewrite /orient /cross /sub; cbn [fst snd]; rewrite ha hb; ring.
Qed.

Lemma around_turn a b c p : around p b c a = around p a b c.
Proof. by rewrite /around; ring. Qed.

Lemma around_swap a b c p : around p a c b = - around p a b c.
Proof. by rewrite /around (crossing_swap p c a) (crossing_swap p b c) (crossing_swap p a b); ring. Qed.

(** ** Scaling *)

Lemma orient_scaled k a b p : orient (scaled k a) (scaled k b) (scaled k p) = k * k * orient a b p.
Proof. by rewrite /orient /cross /sub /scaled; cbn [fst snd]; ring. Qed.

(** A point that is moved by [v], seen [n] times larger. *)
Lemma orient_moved n a b p v :
  orient (scaled n a) (scaled n b) (plus (scaled n p) v) = n * (n * orient a b p + cross (sub b a) v).
Proof. by rewrite /orient /cross /sub /scaled /plus; cbn [fst snd]; ring. Qed.
