(** * Drawing: edges, one after another

    How vertices and edges are drawn, in words that do not mention the rules. Each vertex begins as a star of stubs, one
    for each half-edge that leaves it. [turn x] is the stub that comes after [x], clockwise, around the vertex of [x].
    An edge is drawn by joining the tips of two stubs, [x] and [twin x].

<<
      turn x                      A walk along the boundary has the face to its left. From the tip of the stub x it comes
        │                         inwards along x, and goes out along [turn x] to the tip of that stub.
        │
        ·──────── x               Once x and its twin are joined, it does not turn back at the tip of x, but goes on
         \                        along the twin of x, and then to the stub after the twin.
          \
>>
*)

From mathcomp Require Import all_ssreflect all_fingroup.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section Drawing.
Variables (dart : finType) (turn : {perm dart}) (twin : dart -> dart).

(** The walk along the boundary once these edges are drawn, the last one first. *)
Fixpoint walk (edges : seq dart) : {perm dart} :=
  if edges is x :: before then (tperm x (twin x) * walk before)%g else turn.

(** Two stubs are on the same walk. So one can get from tip to tip without crossing an edge. *)
Definition on_walk edges x y := y \in porbit (walk edges) x.

(** Two stubs are on the same piece: vertices and edges lead from one to the other. *)
Definition link_of (edges : seq dart) : rel dart :=
  [rel x y | (y == turn x) || (y == twin x) && ((x \in edges) || (y \in edges))].
Definition on_piece edges := connect (link_of edges).

(** Each edge is drawn *within* one walk, which it splits, or *between* two pieces, which it joins. Any other edge would
    have to cross what is drawn, or would need a handle.

<<
      within:  ┌─────────┐          between:  ┌────┐      ┌───┐
               ·----x----·                    │    ·---x--·   │
               └─────────┘                    └────┘      └───┘
>>
*)

Fixpoint drawn (edges : seq dart) : Prop :=
  if edges is x :: before then (on_walk before x (twin x) \/ ~~ on_piece before x (twin x)) /\ drawn before else True.

(** Every edge, once. *)
Definition every_edge (edges : seq dart) :=
  uniq (edges ++ map twin edges) /\ forall x, x \in edges ++ map twin edges.

End Drawing.
