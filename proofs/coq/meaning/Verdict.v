(** * Verdict: the three main theorems

    What was proved of single rules, put together. *)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import View Rules Loops Reference Map Counting Lists ReferenceProof TopologyProof.
From twinedge Require Import Genus WholeEuler Bounds Drawing Subdivision Represented Represents.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Lemma lower_of t n : 9 < n -> upto t n -> lower t.
Proof. by move=> lt up q lq; apply: up; apply: leq_trans lq lt. Qed.

(** T4 is never the first broken rule: it follows from those before it.

<<
      3 · cycles ≤ 2E  and  V + cycles = 2 + E    give    E ≤ 3V − 6
>>
*)

Theorem t4_follows t : holds_before t T4 -> t4_bounds t.
Proof.
move=> H V E F counts plain V3; have low : lower t by apply: lower_of H.
exact: (bounds low (H T3 isT) plain (H T1 isT) counts plain V3).
Qed.

(** ** The checker

    `first_broken_rule(view)` is `Some(rule)` if and only if that rule is broken and all rules before it hold, and it is
    `None` if and only if all rules hold: for every view whatever.

<<
      R1  L1  L2  L3  V1  V2  B1  B2  …
      ✓   ✓   ✓   ✗   ?   ?   ?   ?         first_broken t = Some L3
>>
*)

Theorem first_broken_some t r : first_broken t = Some r <-> ~ holds t r /\ forall q, index q < index r -> holds t q.
Proof.
have S := first_broken_sound t; split=> [E|B]; first by move: S; rewrite E => -[].
case E: (first_broken t) S => [q|] S; first by case: S => _ B'; rewrite (first_broken_unique B' B).
case: B => nr _; case: nr; case: (leqP (index r) (index T3)) => [le|]; first by apply: S.
by case: r {E} => // _; apply: t4_follows.
Qed.

Theorem first_broken_none t : first_broken t = None <-> rules t.
Proof.
split=> [E|H].
  have := first_broken_sound t; rewrite E => up r.
  case: (leqP (index r) (index T3)) => [le|]; first by apply: up.
  by case: r => // _; apply: t4_follows.
case E: (first_broken t) => [r|] //; have [nr _] := (first_broken_some t r).1 E.
by case: nr.
Qed.

(** ** What the rules mean

    A view keeps all rules if and only if it represents a planar subdivision: one that can be drawn edge by edge, and
    put down piece by piece. So whatever the checker accepts can be drawn, and it accepts whatever can be drawn.

<<
      V 3 1 - x - 2 H 4 x 0 3 1 1 0 …      ◄── represents ──►      ┌──────────┐
                                                                   │     ·    │
      R1 … T4 hold                                                 └── · ─────┘
>>
*)

Theorem rules_mean_subdivision t : rules t <-> exists s, represents t s.
Proof.
split=> [H|[s [nv [nd [nf [nw [ni rep]]]]]] r]; first by apply: rules_represent => r _; apply: H.
case: (leqP (index r) (index T3)) => [le|]; first by apply: (represented_holds rep).
case: r => // _; apply: t4_follows => q lt; exact: (represented_holds rep).
Qed.

Corollary checker_means_subdivision t : first_broken t = None <-> exists s, represents t s.
Proof. by rewrite first_broken_none; apply: rules_mean_subdivision. Qed.

(** ** Euler's formula

    For a component, where R1 to F2 hold: [V − E + cycles = 2 − 2g] for a natural number [g]. The proof takes for [g] the
    number of edges that need a handle, which is the same in whatever order the edges are drawn ([Euler.genus]).

<<
      ·────·      V − E + cycles = 4 − 4 + 2 = 2          │        V − E + cycles = 1 − 2 + 1 = 0
      │    │      g = 0                                 ──·──      g = 1: two loops that cross at their vertex,
      ·────·                                              │               as on a torus
>>
*)

Theorem component_euler t v V E cycles : holds_before t T1 -> vertex t v -> has_counts t v V E cycles ->
  exists g, V + cycles + 2 * g = 2 + E.
Proof.
move=> low lv H; have [g eq] := euler_component low lv H; by exists g; rewrite mul2n.
Qed.

(** For the whole, where R1 to T1 hold: [V − E + F = 1 + C − 2g], and so [V − E + F = 1 + C] exactly if T3 holds. [cs]
    lists one vertex of each component. *)

Theorem map_euler t V E F cs : holds_before t T2 -> map_has_counts t V E F ->
  lists_one_of_each cs (connected t) (vertex t) ->
  (exists g, V + F + 2 * g = 1 + size cs + E) /\ (t3_euler t <-> V + F = 1 + size cs + E).
Proof.
move=> H counts Hc; have low : lower t by apply: lower_of H.
have t1 : t1_outside t := H T1 isT; split; last exact: (euler_plane low t1 counts Hc).
by have [g [eq _]] := euler_whole low t1 counts Hc; exists g; rewrite mul2n.
Qed.

(** These counts exist, so that the theorems are about something. *)

Theorem component_counts_exist t v : holds_before t T1 -> vertex t v -> exists V E cycles, has_counts t v V E cycles.
Proof.
move=> low lv; case: (vertexP low lv) => [x _ <-|b _ bv _ _]; first exact: component_counts.
by exists 1, 0, 1; apply/(has_counts_bare low _ _ _ bv).
Qed.

Theorem map_counts_exist t : holds_before t T1 -> exists V E F, map_has_counts t V E F.
Proof.
move=> low; have [es He] := edges_each low.
exists (size [seq v <- iota 0 (vertex_slots t) | vertex t v]), (size es), (size [seq f <- iota 0 (face_slots t) | face t f]).
exists [seq v <- iota 0 (vertex_slots t) | vertex t v], es, [seq f <- iota 0 (face_slots t) | face t f]; split=> //.
  exact: lists_filter (@vertex_below t) (fun v => iff_refl (vertex t v)).
exact: lists_filter (@face_below t) (fun f => iff_refl (face t f)).
Qed.
