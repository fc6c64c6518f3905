(** * Fan: the half-edges that leave a vertex between two of its corners

    The half-edges [a] and [b] end at one vertex. The *fan* between the corners after them is what leaves it from [next b] on, clockwise
    to the twin of [a]; nothing if the corners are one. Splitting the vertex gives it to the new one (SplitVertex.v). *)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import View Rules Map Lists NewEdge ConnectCorners Core RemoveEdge Stretch.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Definition fan t a b : seq nat := if a == b then [::] else
  if next t b is Some x then (if twin t a is Some z then stretch (turn t) (half_edge_slots t) x z else [::]) else [::].

Section Fans.
Variables (t : view) (a b ta tb na nb o : nat).
Hypothesis keeps : rules t.
Hypothesis twin_a : twin t a = Some ta.
Hypothesis twin_b : twin t b = Some tb.
Hypothesis next_a : next t a = Some na.
Hypothesis next_b : next t b = Some nb.
Hypothesis origin_ta : origin t ta = Some o.
Hypothesis origin_tb : origin t tb = Some o.

Notation fan := (fan t a b).
Let map : is_map t. Proof. by apply: low_map => q _; apply: keeps. Qed.
Let c : core t (inn_of t) := core_of_rules keeps.
Let links_of := NewEdge.links_of keeps.
Let twin_of := twin_of keeps.
Let one_next := one_next keeps.
Let one_twin := one_twin keeps.
Let twin_ta : twin t ta = Some a := twin_of twin_a.
Let twin_tb : twin t tb = Some b := twin_of twin_b.
Let live_ta : half_edge t ta := heard_live twin_ta.
Let live_tb : half_edge t tb := heard_live twin_tb.
Let live_nb : half_edge t nb. Proof. by have [x + lx] := RemoveEdge.next_some keeps (heard_live twin_b); rewrite next_b => -[->]. Qed.
Let origin_nb : origin t nb = Some o. Proof. by rewrite (origin_next keeps next_b) /target twin_b. Qed.
Let turn_ta : turn t ta = Some na. Proof. by rewrite /turn twin_ta. Qed.
Let turn_tb : turn t tb = Some nb. Proof. by rewrite /turn twin_tb. Qed.

Lemma turn_total i : half_edge t i -> exists2 j, turn t i = Some j & half_edge t j.
Proof. exact: Map.turn_total map i. Qed.

Lemma turn_injective i j : half_edge t i -> half_edge t j -> turn t i = turn t j -> i = j.
Proof.
move=> /links_of[_ [g G lg] _ _ _] /links_of[_ [g' G' lg'] _ _ _]; rewrite /turn G G' /= => /(core_next c lg lg') gg.
by apply: one_twin G _; rewrite G' gg.
Qed.

Let around : on_orbit (turn t) nb ta.
Proof. by apply/(keeps V2 nb ta live_nb live_ta); rewrite origin_nb origin_ta. Qed.
Let below := @half_edge_below t.

Lemma fanE : a <> b -> fan = stretch (turn t) (half_edge_slots t) nb ta.
Proof. by rewrite /Fan.fan next_b twin_a => /eqP/negPf->. Qed.
Lemma fan_none : a = b -> fan = [::]. Proof. by rewrite /Fan.fan => ->; rewrite eqxx. Qed.
Lemma fan_differ i : i \in fan -> a <> b. Proof. by move=> + E; rewrite fan_none. Qed.

Lemma fan_ends : a <> b -> nb \in fan /\ ta \in fan.
Proof. by move/fanE->; apply: (stretch_ends below turn_total live_nb around). Qed.
Lemma fan_step i j : i \in fan -> i <> ta -> turn t i = Some j -> j \in fan.
Proof. by move=> F; move: (F); rewrite (fanE (fan_differ F)); apply: (stretch_step below turn_total live_nb around). Qed.
Lemma fan_back i j : j \in fan -> turn t i = Some j -> j = nb \/ i \in fan /\ i <> ta.
Proof.
move=> F T; have li : half_edge t i by move: T; rewrite /turn; case G: (twin t i) => [g|] // _; apply: heard_live G.
by move: (F) T; rewrite (fanE (fan_differ F)); apply: (stretch_back below turn_total turn_injective live_nb around).
Qed.
Lemma fan_tb : tb \notin fan.
Proof.
case: (a =P b) => [/fan_none-> //|ab]; rewrite fanE //.
apply: (stretch_before below turn_total live_nb around) turn_tb => E.
by apply: ab; apply: one_twin twin_a _; rewrite -E.
Qed.
Lemma fan_ind (P : nat -> Prop) : P nb -> (forall i j, i \in fan -> i <> ta -> P i -> turn t i = Some j -> P j) -> forall i, i \in fan -> P i.
Proof.
move=> Px keep i F; move: keep (F); rewrite (fanE (fan_differ F)) => keep.
exact: (stretch_ind below turn_total live_nb around Px keep).
Qed.
Lemma fan_origin i : i \in fan -> origin t i = Some o.
Proof.
move: i; apply: fan_ind => // i j _ _ O T; rewrite -O.
by apply: (on_rotation_origin (keeps L1) (keeps L3)); exists 1.
Qed.
Lemma fan_live i : i \in fan -> half_edge t i. Proof. by move=> F; apply: heard_live (fan_origin F). Qed.
Lemma fan_na : na \notin fan.
Proof.
apply/negP=> F; have ab := fan_differ F; case: (fan_back F turn_ta) => [E|[_ []//]].
by apply: ab; apply: one_next next_a _; rewrite E.
Qed.

(** Of a half-edge and the one that comes after its twin, one is in the fan if and only if the other is. *)
Lemma fan_turn i j : i <> ta -> i <> tb -> turn t i = Some j -> (j \in fan) = (i \in fan).
Proof.
move=> ia ib T; apply/idP/idP => [F|F]; last exact: fan_step T.
case: (fan_back F T) => [jn|[]//]; case: ib; apply: turn_injective; rewrite ?T ?turn_tb ?jn //.
by move: T; rewrite /turn; case G: (twin t i) => [g|] // _; apply: heard_live G.
Qed.

End Fans.
