(** * Subdivision: what a planar subdivision is, without the rules

    A planar subdivision is what can be drawn in the plane in two stages.

    - Each *piece* is an isolated vertex, or is drawn edge by edge, each edge within one walk or between two pieces that
      are not joined yet (Drawing.v). One walk along its boundary is then its *outside*, and each other walk bounds a face
      of its own.
    - The pieces are *put down* one after another, each into a face that is there: the unbounded face, or one that a
      piece put down before bounds.

<<
        ┌───────────┐          the piece p is put down in the unbounded face. Its outside is one walk;
        │ f    ·v   │          the other bounds the face f. Then the piece v, an isolated vertex,
        │  p        │          is put down in f, which is there.
        └───────────┘
>>

    This definition is of finite types, not of tables, and none of the rules R1 to T4 occurs in it. *)

From mathcomp Require Import all_ssreflect all_fingroup.
From twinedge Require Import View Drawing.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** ** Planar subdivisions *)

Section Parts.
Variables (vertices darts pieces faces : finType).
Variables (rotation : {perm darts}) (other : darts -> darts) (tail : darts -> vertices) (piece : vertices -> pieces).
Variables (outside : pred darts) (left : darts -> faces) (lies_in : pieces -> faces) (unbounded_face : faces).

(** The half-edge after [x] on its walk, once all edges are drawn. *)
Definition follow (x : darts) := rotation (other x).
Definition same_walk (x y : darts) := fconnect follow x y.

Definition edge_between (v w : vertices) := [exists x, (tail x == v) && (tail (other x) == w)].

(** The face [f] is there once these pieces are put down. *)
Definition is_there (before : seq pieces) f :=
  f = unbounded_face \/ exists x, [/\ ~~ outside x, left x = f & piece (tail x) \in before].

(** Pieces are put down one after another; the last one comes first in the list. *)
Fixpoint put_down (ps : seq pieces) : Prop :=
  if ps is p :: before then is_there before (lies_in p) /\ put_down before else True.
End Parts.

Record subdivision := Subdivision {
  vertices : finType;
  darts : finType;
  pieces : finType;
  faces : finType;

  (** The next half-edge, clockwise, around the same vertex; the other half-edge of the same edge; where it begins. *)
  rotation : {perm darts};
  other : darts -> darts;
  tail : darts -> vertices;
  other_back : involutive other;
  other_differs : forall x, other x != x;
  rotation_tail : forall x y, (y \in porbit rotation x) = (tail x == tail y);

  (** The piece of a vertex is all that edges lead to. *)
  piece : vertices -> pieces;
  piece_connected : forall v w, (piece v == piece w) = connect (edge_between other tail) v w;
  piece_inhabited : forall p, exists v, piece v = p;

  (** The pieces are drawn edge by edge. *)
  edge_by_edge : exists2 edges, every_edge other edges & drawn rotation other edges;

  (** One walk of each piece that has edges is around its outside, and each other walk bounds a face of its own. *)
  outside : pred darts;
  outside_walk : forall x, outside (follow rotation other x) = outside x;
  one_outside : forall x, exists2 y, outside y /\ piece (tail y) = piece (tail x) &
    forall z, outside z -> piece (tail z) = piece (tail x) -> same_walk rotation other y z;
  unbounded_face : faces;
  left : darts -> faces;
  lies_in : pieces -> faces;
  left_outside : forall x, outside x -> left x = lies_in (piece (tail x));
  left_inside : forall x, ~~ outside x -> left x != unbounded_face;
  left_own : forall x y, ~~ outside x -> ~~ outside y -> (left x == left y) = same_walk rotation other x y;
  bounded : forall f, f != unbounded_face -> exists2 x, ~~ outside x & left x = f;

  (** The pieces are put down one after another, each into a face that is there. *)
  one_by_one : exists2 ps, uniq ps /\ (forall p, p \in ps) & put_down tail piece outside left lies_in unbounded_face ps
}.

(** ** A view represents a subdivision

    The parts of the subdivision can be numbered so that the view has exactly these numbers and says of them what is so.
    [nv], [nd] and [nf] number vertices, half-edges and faces. Boundary components are the walks, numbered by [nw], and
    the isolated vertices, numbered by [ni]. *)

Definition numbers T (n : T -> nat) (live : nat -> bool) := injective n /\ forall i, live i <-> exists x, n x = i.

Definition alone s (v : vertices s) := [forall x : darts s, tail x != v].

Definition after s (x : darts s) := follow (@rotation s) (@other s) x.

(** The view says that the boundary component [b] is of the face [f], and lists it there. *)
Definition stands t b f (inner_one : bool) := boundary_face t b = Some f /\
  if inner_one then exists i, boundary_place t b = Some (Inner i) /\ inner t f i = Some b
  else boundary_place t b = Some Outer /\ outer t f = Some b.

Record represented t s (nv : vertices s -> nat) (nd : darts s -> nat) (nf : faces s -> nat) (nw : darts s -> nat)
    (ni : vertices s -> nat) : Prop := Represented {
  vertices_numbered : numbers nv (vertex t);
  darts_numbered : numbers nd (half_edge t);
  faces_numbered : numbers nf (face t);
  walks_numbered : forall x y, nw x = nw y <-> same_walk (@rotation s) (@other s) x y;
  isolated_numbered : forall v w, alone v -> alone w -> ni v = ni w -> v = w;
  walk_or_isolated : forall x v, alone v -> nw x <> ni v;
  boundaries_numbered : forall b, boundary t b <-> (exists x, nw x = b) \/ (exists2 v, alone v & ni v = b);

  says_of_dart : forall x,
    [/\ origin t (nd x) = Some (nv (tail x)), twin t (nd x) = Some (nd (other x)),
        next t (nd x) = Some (nd (after x)), prev t (nd (after x)) = Some (nd x) & boundary_of t (nd x) = Some (nw x)];
  says_of_vertex : forall v, if alone v then leaving t (nv v) = None /\ isolated t (nv v) = Some (ni v)
    else (exists2 x, leaving t (nv v) = Some (nd x) & tail x = v) /\ isolated t (nv v) = None;
  says_of_walk : forall x, stands t (nw x) (nf (left x)) (outside x) /\
    exists2 y, boundary_start t (nw x) = Some (AtHalfEdge (nd y)) & same_walk (@rotation s) (@other s) x y;
  says_of_isolated : forall v, alone v -> stands t (ni v) (nf (lies_in (piece v))) true /\
    boundary_start t (ni v) = Some (AtVertex (nv v));
  lists_outer : forall f b, outer t f = Some b -> boundary_face t b = Some f /\ boundary_place t b = Some Outer;
  lists_inner : forall f i, i < inner_count t f -> exists b,
    [/\ inner t f i = Some b, boundary_face t b = Some f & boundary_place t b = Some (Inner i)]
}.

Definition represents t s := exists nv nd nf nw ni, @represented t s nv nd nf nw ni.
