(** * Connect: connecting to an isolated vertex keeps all rules (`bridge` in dcel/operators/connect.rs)

    The isolated vertex [v] and its boundary component are removed first. Then there is a new vertex at the end of a new edge: a
    leaf, which splits off at a corner (SplitVertex.v), or at another isolated vertex (ConnectIsolated.v).

<<
      f ┌──────────┐         f ┌──────────┐        half-edge h: from the corner after a, twin k
        │    · v   │           │   ┌─· v  │        half-edge k: from v, twin h
        │          │   ──►     │  h│k     │        along the boundary: a, h, k, next(a)
        └──►───·───┘           └──►┴──────┘        vertex v: leaving k, no longer isolated
           a                      a
>>

    Both corners may even be of different faces. Then the edge could not be drawn where [v] lies, but what is there after is right all
    the same. *)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import View Rules Core RemoveVertex ConnectIsolated SplitVertex.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** Without the isolated vertex [v] its slot is free. *)
Lemma removed_free t v b : ~~ vertex (remove_isolated_vertex t v b) v.
Proof. by rewrite /vertex /= eqxx andbF. Qed.

(** The edge from the corner after [a] to the isolated vertex [v]. *)
Definition connect_isolated t a v b h k := split_vertex (remove_isolated_vertex t v b) a a v h k.

Theorem connect_isolated_keeps_rules t a v b h k : half_edge t a -> isolated t v = Some b ->
  ~~ half_edge t h -> ~~ half_edge t k -> h != k -> rules t -> rules (connect_isolated t a v b h k).
Proof.
move=> la I fh fk hk keeps; have keeps' := remove_isolated_vertex_keeps_rules I keeps.
apply: split_vertex_keeps_rules keeps'; rewrite /is_splittable removed_free eqxx hk.
have -> : isSome (target (remove_isolated_vertex t v b) a); last by rewrite /= fh fk.
have c := core_of_rules keeps; have [_ [g G lg] _ _] := core_live c la; have [[u U _] _ _ _] := core_live c lg.
have -> : target (remove_isolated_vertex t v b) a = target t a by [].
by rewrite /target G /= U.
Qed.

(** The edge from the isolated vertex [o] to the isolated vertex [v], which is another one. *)
Definition connect_two_isolated t o v b d h k := attach_to_isolated (remove_isolated_vertex t v d) o v b h k.

Theorem connect_two_isolated_keeps_rules t o v b d h k : isolated t o = Some b -> isolated t v = Some d -> o != v ->
  ~~ half_edge t h -> ~~ half_edge t k -> h != k -> rules t -> rules (connect_two_isolated t o v b d h k).
Proof.
move=> Io Iv ov fh fk hk keeps; have keeps' := remove_isolated_vertex_keeps_rules Iv keeps.
apply: attach_to_isolated_keeps_rules => //; last exact: removed_free.
have E : isolated (remove_isolated_vertex t v d) o = isolated (without t v d) o by [].
by rewrite E RemoveVertex.isolatedE (negPf ov).
Qed.
