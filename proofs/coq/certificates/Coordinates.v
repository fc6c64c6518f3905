(** * Coordinates: a certificate that a view is drawn without crossings, and its checker

    The certificate is a triangulation that has the edges of the view among its own. Its darts are numbered: 3i, 3i + 1 and
    3i + 2 are those of triangle i, one after another; triangle 0 is the outer one and runs clockwise, all others
    counter-clockwise. All numbers are labels: nothing is assumed of them. Each test is local.

<<
      ┌──────────────┐       darts         twin, point; the half-edge that lies on it, or nil
      │ ╲    dart    │       points        x, y: those of the vertices have the numbers of the vertices
      │   v ───────► │       half-edges    the dart on which it lies
      │ ╱    h     ╲ │       vertices      a dart that starts there
      └──────────────┘
>>
*)

From Coq Require Import ZArith Lia.
From mathcomp Require Import all_ssreflect.
From twinedge Require Import View Loops Reference Orientation.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** ** The sign of a difference of products

    Coordinates are below 2^53, so that a product has twice as many bits as a machine has. So it is taken in parts. *)

Section Parts.
Local Open Scope Z_scope.

Definition limb : Z := 2 ^ 27.
Definition high (x : Z) : Z := x / limb.
Definition low (x : Z) : Z := x mod limb.

(** a · b > c · d *)
Definition greater_product (a b c d : Z) : bool :=
  let ah := high a in let al := low a in let bh := high b in let bl := low b in
  let ch := high c in let cl := low c in let dh := high d in let dl := low d in
  let w := al * bl - cl * dl in
  let y := ah * bl + al * bh - ch * dl - cl * dh + high w in
  let x := ah * bh - ch * dh + high y in
  (0 <? x) || (x =? 0) && ((0 <? low y) || (0 <? low w)).

Lemma partsE x : x = limb * high x + low x /\ 0 <= low x < limb.
Proof. by rewrite /high /low; split; [exact: Z.div_mod | exact: Z.mod_pos_bound]. Qed.

Lemma greater_productP a b c d : reflect (0 < a * b - c * d) (greater_product a b c d).
Proof.
rewrite /greater_product; cbv zeta; set w := low a * low b - low c * low d.
set y := high a * low b + low a * high b - high c * low d - low c * high d + high w.
set x := high a * high b - high c * high d + high y.
have E : a * b - c * d = limb * limb * x + limb * low y + low w.
  have [Ea _] := partsE a; have [Eb _] := partsE b; have [Ec _] := partsE c; have [Ed _] := partsE d.
  have [Ew _] := partsE w; have [Ey _] := partsE y.
  rewrite {1}Ea {1}Eb {1}Ec {1}Ed; transitivity (limb * limb * (high a * high b - high c * high d)
    + limb * (y - high w) + w); first by rewrite /y /w; ring.
  by rewrite {1}Ey {2}Ew /x; ring.
have [_ by_] := partsE y; have [_ bw] := partsE w; have l0 : 0 < limb by [].
rewrite E; clear E; move: x (low y) (low w) limb by_ bw l0 => {w y a b c d} x y w l by_ bw l0.
apply: (iffP idP) => [/orP[/Z.ltb_lt ?|/andP[/Z.eqb_eq -> /orP[/Z.ltb_lt ?|/Z.ltb_lt ?]]]|]; try nia.
case: (Z.ltb_spec 0 x) => //= le; case: (Z.eqb_spec x 0) => [->|ne] /=; last by nia.
by case: (Z.ltb_spec 0 y) => //= ?; case: (Z.ltb_spec 0 w) => //= ?; nia.
Qed.

(** The triangle runs counter-clockwise. *)
Definition counter_clockwise (a b c : point) : bool :=
  greater_product (a.1 - c.1) (b.2 - c.2) (b.1 - c.1) (a.2 - c.2).

Lemma counter_clockwiseP a b c : reflect (0 < orient a b c) (counter_clockwise a b c).
Proof. exact: greater_productP. Qed.

End Parts.

(** ** The labels *)

Record refinement := Refinement {
  triangle_count : nat;
  dart_twin : nat -> nat;
  dart_point : nat -> nat;
  dart_half_edge : nat -> link;
  dart_ahead : nat -> nat;
  dart_face : nat -> nat;
  dart_rank : nat -> nat;
  point_at : nat -> point;
  half_edge_dart : nat -> nat;
  vertex_dart : nat -> nat;
  face_dart : nat -> nat
}.

Section Tests.
Variables (t : view) (r : refinement).

Definition dart_count := 3 * triangle_count r.
Definition next_dart d := if d %% 3 == 2 then d - 2 else d.+1.
Definition dart_at d := point_at r (dart_point r d).

(** *** Tests of one dart, of one triangle *)

Definition dart_twin_ok d :=
  (dart_twin r d < dart_count) && (dart_twin r (dart_twin r d) == d).
Definition dart_point_ok d := dart_point r (next_dart d) == dart_point r (dart_twin r d).

(** The edge is added: no half-edge lies on it. *)
Definition added d := is_nil (dart_half_edge r d).

Definition dart_half_edge_ok d :=
  if dart_half_edge r d is Some h then half_edge t h && (half_edge_dart r h == d) else added (dart_twin r d).

(** The next dart counter-clockwise around the same point. *)
Definition turn_dart d := dart_twin r (next_dart (next_dart d)).

(** [ahead] is the half-edge that lies on the first dart from here, counter-clockwise, on which one lies. *)
Definition dart_ahead_ok d :=
  dart_ahead r d == if dart_half_edge r d is Some h then h else dart_ahead r (turn_dart d).

(** A triangle is part of a face, the same across added edges, and that of the half-edges on its sides. *)
Definition dart_face_ok d :=
  (dart_face r (next_dart d) == dart_face r d)
  && if dart_half_edge r d is Some h then same_link (boundary_of t h >>= boundary_face t) (Some (dart_face r d))
     else dart_face r (dart_twin r d) == dart_face r d.

(** The triangles of a face lead down to one of them. *)
Definition dart_rank_ok d :=
  [|| dart_rank r (next_dart d) < dart_rank r d, added d && (dart_rank r (dart_twin r d) < dart_rank r d)
    | face_dart r (dart_face r d) == d].

(** Triangle 0 runs clockwise, all others counter-clockwise. *)
Definition triangle_ok i :=
  let a := dart_at (3 * i) in let b := dart_at (3 * i + 1) in let c := dart_at (3 * i + 2) in
  if i == 0 then counter_clockwise a c b else counter_clockwise a b c.

(** *** Tests of one half-edge, of one vertex *)

(** It lies on a dart that knows it, and starts where it starts; its twin lies on the twin. *)
Definition half_edge_dart_ok h :=
  let d := half_edge_dart r h in
  [&& d < dart_count, same_link (dart_half_edge r d) (Some h), same_link (origin t h) (Some (dart_point r d))
    & if twin t h is Some g then half_edge_dart r g == dart_twin r d else false].

(** The next half-edge counter-clockwise around its origin lies on the next dart on which one lies. *)
Definition rotation_ok h := same_link (prev t h >>= twin t) (Some (dart_ahead r (turn_dart (half_edge_dart r h)))).

(** A dart starts there, and if it is isolated, that dart is in its face. *)
Definition vertex_dart_ok v :=
  [&& vertex_dart r v < dart_count, dart_point r (vertex_dart r v) == v
    & if isolated t v is Some b then same_link (boundary_face t b) (Some (dart_face r (vertex_dart r v))) else true].

Definition dart_ok d :=
  [&& dart_twin_ok d, dart_point_ok d, dart_half_edge_ok d, dart_ahead_ok d & dart_face_ok d && dart_rank_ok d].

Definition drawn :=
  [&& all_below dart_count dart_ok, all_below (triangle_count r) triangle_ok,
      each_half_edge t (fun h => half_edge_dart_ok h && rotation_ok h) & each_vertex t vertex_dart_ok].

End Tests.
