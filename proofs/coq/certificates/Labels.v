(** * Labels: a certificate that a view keeps all rules, and the checker of it

    A certificate is one number for each half-edge, its *rank*. Nothing is assumed of the ranks. Each test looks at one
    record and at the records that its links name, once; beside the tests there are two counts. There is no walk, no
    set and no order, so that the check can be a scan, a stream, or queries in SQL: CERTIFICATE.md says the same without
    Coq. LabelsSound.v proves that what is accepted keeps all rules, LabelsComplete.v that whatever keeps all rules has
    ranks that are accepted.

<<
                     rank 3
              ·◄────────────────·         the rank of a half-edge is greater than that of a neighbour
       rank 2 │                 ▲         (next, prev or twin), until the *root*: the start of the outside
              ▼                 │ rank 3  of the component, which lies in the unbounded face, or in a face
              ·────────────────►·         whose outer cycle starts with a lower rank
              root: rank 1
>>

    Why the ranks and two counts are enough for V2, B1, T1, T2 and T3. From every half-edge the ranks lead down to a
    root, so that there are at most as many components as roots. There are at least as many rotations as vertices with
    half-edges, and as many cycles as boundary components of half-edges. Euler's formula bounds the number of rotations
    and cycles by that of the edges and components. If the counts of the records fit it with one component for each
    root, then all these are equal: each vertex has one rotation, each boundary component one cycle, each component one
    root and no handle. *)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import View Loops Reference.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section Labels.
Variables (t : view) (rank : nat -> nat).

(** ** Tests of one half-edge

    That its links are live needs no test of its own: what is not live answers nothing. *)

Definition twin_ok h := same_link (twin t h >>= twin t) (Some h) && ~~ same_link (twin t h) (Some h).

Definition next_ok h := same_link (next t h >>= prev t) (Some h) && same_link (prev t h >>= next t) (Some h).

Definition target_ok h := same_link (next t h >>= origin t) (twin t h >>= origin t).

(** Its origin keeps a half-edge. *)
Definition origin_ok h := ~~ is_nil (origin t h >>= leaving t).

(** The half-edge with which a boundary component starts, if it is a cycle. *)
Definition cycle_start b : link := if boundary_start t b is Some (AtHalfEdge h) then Some h else None.

(** The next one has the same boundary component, which is a cycle. *)
Definition cycle_ok h :=
  same_link (next t h >>= boundary_of t) (boundary_of t h) && ~~ is_nil (boundary_of t h >>= cycle_start).

(** *** The rank *)

Definition lower_than h (l : link) : bool := if l is Some g then rank g < rank h else false.

Definition listed_inner b : bool := if boundary_place t b is Some (Inner _) then true else false.

(** It is the start of the outside of its component, which lies in the unbounded face, or in a face whose outer cycle
    starts with a lower rank. *)
Definition is_root h : bool :=
  if boundary_of t h is Some b then
    [&& same_link (cycle_start b) (Some h), listed_inner b
      & if boundary_face t b is Some f then
          is_nil (outer t f) || lower_than h (outer t f >>= cycle_start)
        else false]
  else false.

Definition rank_ok h :=
  [|| lower_than h (next t h), lower_than h (prev t h), lower_than h (twin t h) | is_root h].

Definition half_edge_ok h :=
  [&& twin_ok h, next_ok h, target_ok h, origin_ok h & cycle_ok h && rank_ok h].

(** ** Tests of one vertex, of one boundary component, of one face *)

(** It keeps a half-edge that leaves it, or names the boundary component that it is. *)
Definition vertex_ok v :=
  if leaving t v is Some h then
    [&& half_edge t h, same_link (origin t h) (Some v) & is_nil (isolated t v)]
  else if isolated t v is Some b then boundary t b && starts_at v (boundary_start t b) else false.

(** It starts with one of its half-edges, or is an isolated vertex, and then an inner one. *)
Definition start_ok b :=
  match boundary_start t b with
  | Some (AtHalfEdge h) => half_edge t h && same_link (boundary_of t h) (Some b)
  | Some (AtVertex v) =>
    [&& vertex t v, is_nil (leaving t v), same_link (isolated t v) (Some b) & listed_inner b]
  | None => false
  end.

(** Its face lists it at its place. *)
Definition place_ok b :=
  match boundary_face t b, boundary_place t b with
  | Some f, Some Outer => face t f && same_link (outer t f) (Some b)
  | Some f, Some (Inner i) => face t f && same_link (inner t f i) (Some b)
  | _, _ => false
  end.

Definition boundary_ok b := start_ok b && place_ok b.

(** Each boundary component that it lists names it, and the place. *)
Definition entry_ok f p (l : link) := leads (boundary t) l && names_place t f p l.

Definition face_ok f :=
  (is_nil (outer t f) || entry_ok f Outer (outer t f))
  && all_below (inner_count t f) (fun i => entry_ok f (Inner i) (inner t f i)).

(** ** Counts *)

Definition number n (p : nat -> bool) : nat := fold_below n (fun sum i => if p i then sum.+1 else sum) 0.

Definition half_edge_count := number (half_edge_slots t) (half_edge t).
Definition rotation_count := number (vertex_slots t) (fun v => ~~ is_nil (leaving t v)).
Definition cycle_count := number (boundary_slots t) (fun b => ~~ is_nil (cycle_start b)).
Definition root_count := number (boundary_slots t) (fun b => ~~ is_nil (cycle_start b) && listed_inner b).
Definition unbounded_count := number (face_slots t) (fun f => face t f && is_nil (outer t f)).

(** V + cycles = E + 2 · roots, twice, as an edge is two half-edges. *)
Definition euler_ok := 2 * (rotation_count + cycle_count) == half_edge_count + 4 * root_count.

Definition one_unbounded := unbounded_count == 1.

(** ** The checker *)

Definition accepts :=
  [&& each_half_edge t half_edge_ok, each_vertex t vertex_ok, each_boundary t boundary_ok, each_face t face_ok
    & one_unbounded && euler_ok].

End Labels.
