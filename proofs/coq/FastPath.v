(** * FastPath: two walks that settle R1 to T1 at once (fast_path.rs)

    The fast path walks once around every vertex and once along every boundary component, remembers little, and counts.
    This file is the algorithm; FastPathAccepted.v and FastPathProof.v prove that it accepts exactly the views that keep R1 to T1.

<<
      around v, from leaving(v):        along b, from start(b):

           \   |   /                    ┌──► h ──► n ──► · ──┐    twin(twin(h)) = h, prev(n) = h,
        ◄── \  |  / ──►                 └────────────────────┘    origin(n) = origin(twin(h)),
      ─────── v ───────                   face(b) lists b         boundary(h) = b, all of them live
>>

    Like the Rust code it asks of any slot that there is, live or not, and so it hears what vacant slots say ([says_twin]
    and not [twin]). It differs in this: vertices are visited in the order of their numbers, and components are found
    afterwards and not on the way; and a walk may take as many steps as there are slots, not only as many as the walks
    before it left. Neither changes what is accepted: the walks are the same ones, and the sum of their steps is compared
    with the number of half-edges in the end. Nothing is said here of the figures that the Rust code notes on the way. *)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import View Rules Loops Reference.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section FastPath.
Variable t : view.

(** The link, if the slot that it leads to exists. *)
Definition existing n (l : link) : link := if l is Some i then if i < n then Some i else None else None.

(** ** Around every vertex *)

Definition around_step h : link :=
  if existing (half_edge_slots t) (says_twin t h) is Some w then
    if says_origin t w is Some u then
      if vertex t u then existing (half_edge_slots t) (says_next t w) else None
    else None
  else None.

Definition names_its_boundary v :=
  if says_isolated t v is Some b then boundary t b && starts_at v (says_boundary_start t b) else false.

(** How many half-edges the walk around [v] visits, if it finds nothing wrong. *)
Definition around v : option nat :=
  if says_leaving t v is Some l then
    if [&& half_edge t l, same_link (says_origin t l) (Some v) & is_nil (says_isolated t v)]
    then round_trip (half_edge_slots t) around_step l else None
  else if names_its_boundary v then Some 0 else None.

(** The vertices that the walk around [v] sees. *)
Definition neighbours v : seq nat :=
  if leaving t v is Some l then
    [seq odflt 0 (says_twin t h >>= says_origin t) |
      h <- traject (fun h => odflt 0 (around_step h)) l (odflt 0 (around v))]
  else [::].

(** ** Along every boundary component *)

Definition along_step b h : link :=
  match existing (half_edge_slots t) (says_twin t h), existing (half_edge_slots t) (says_next t h) with
  | Some w, Some n =>
    if [&& half_edge t h, half_edge t w, same_link (says_boundary t h) (Some b), w != h,
           same_link (says_twin t w) (Some h), same_link (says_prev t n) (Some h), ~~ is_nil (says_origin t n)
         & same_link (says_origin t n) (says_origin t w)]
    then Some n else None
  | _, _ => None
  end.

(** How many half-edges the walk along [b] visits, if it finds nothing wrong. *)
Definition along b : option nat :=
  match says_boundary_start t b with
  | Some (AtHalfEdge h) => if h < half_edge_slots t then round_trip (half_edge_slots t) (along_step b) h else None
  | Some (AtVertex _) => if says_boundary_place t b is Some Outer then None else Some 0
  | None => None
  end.

(** The face that [b] names lists it at the place it says. *)
Definition stands_there b :=
  match says_boundary_face t b, says_boundary_place t b with
  | Some f, Some p => face t f && same_link (listed t f p) (Some b)
  | _, _ => false
  end.

(** The vertex where [b] starts. *)
Definition says_vertex_at b : link :=
  match says_boundary_start t b with
  | Some (AtHalfEdge h) => says_origin t h | Some (AtVertex v) => Some v | None => None
  end.

(** ** Counting *)

Definition live_ones n live := [seq i <- iota 0 n | live i].
Definition vertex_ones := live_ones (vertex_slots t) (vertex t).
Definition half_edge_ones := live_ones (half_edge_slots t) (half_edge t).
Definition boundary_ones := live_ones (boundary_slots t) (boundary t).
Definition face_ones := live_ones (face_slots t) (face t).

Definition is_isolated v := is_nil (says_leaving t v).
Definition is_at_vertex b := if says_boundary_start t b is Some (AtVertex _) then true else false.
Definition has_outer f := ~~ is_nil (says_outer t f).

Definition complete :=
  [&& sumn [seq odflt 0 (around v) | v <- vertex_ones] == size half_edge_ones,
      sumn [seq odflt 0 (along b) | b <- boundary_ones] == size half_edge_ones,
      count is_at_vertex boundary_ones == count is_isolated vertex_ones,
      count has_outer face_ones + sumn [seq says_inner_count t f | f <- face_ones] == size boundary_ones
    & size face_ones == count has_outer face_ones + 1].

(** ** Every component has one outside *)

Definition component : memory link :=
  flood_all (half_edge_slots t).+2 (vertex_slots t) (vertex t) neighbours.

Definition outside_component b : link :=
  if says_boundary_place t b is Some (Inner _) then says_vertex_at b >>= read component else None.

Definition one_outside_each :=
  all (fun b => ~~ is_nil (says_vertex_at b >>= read component)) boundary_ones
  && all (fun v => count (fun b => outside_component b == read component v) boundary_ones == 1) vertex_ones.

Definition fast_path :=
  [&& all (fun v => ~~ is_nil (around v)) vertex_ones,
      all (fun b => ~~ is_nil (along b) && stands_there b) boundary_ones,
      complete & one_outside_each].

End FastPath.
