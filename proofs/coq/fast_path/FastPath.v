(** * FastPath: a scan and two walks that settle R1 to T1, and T3, at once

    The fast path of the Rust code took these steps until 2026-11-28. Since then it takes fewer (fast_path/mod.rs): it checks the
    links at each step around a vertex, without a scan by index, and in the plane it does not walk along the cycles, because where
    as many components are found as Euler's formula needs for the cycles that are listed, there are no others. That argument is not
    proved here. Both accept the same tables, as far as [compare --fast-path] runs them.

    The fast path reads the links of every half-edge, walks along every boundary component from where a face lists it and
    around every vertex, remembers little, and counts. Then it joins vertices along edges until as few sets of them are
    left as Euler's formula allows. This file is the algorithm; FastPathAccepted.v, FastPathKept.v, FastPathComponents.v
    and FastPathProof.v prove that it accepts exactly the views that keep R1 to T1, and T3.

<<
      scan, by index:               along each cycle:             around v, from leaving(v):

           h          n             ┌──► h ──► n ──► · ──┐              \   |   /
      ·────────►w────────►·         └────────────────────┘           ◄── \  |  / ──►
      ·◄────────w                   boundary(h) = b,                ─────── v ───────
           t                        face(b) lists b
      twin(t) = h ≠ t,
      origin(n) = origin(t),
      prev(n) = h
>>

    Like the Rust code it asks first whether a record is live, and never what a vacant slot says, or one that is not there: the
    extracted program would end there. So it need not hear nil of these ([says_twin], and not [twin]). It is about structures
    that have every part, in the plane. It differs from that Rust code in this:

    - Everything is looked at, where the Rust code stops at the first fault. A walk may take as many steps as there are
      slots, not only as many as are left of the live half-edges, and the lists of the faces are read to their ends,
      though they may have more entries than there are boundary components. Neither changes what is accepted: the walks
      are the same ones, and their steps and the entries are counted in the end.
    - That no boundary component is listed twice is said of the list of them: [uniq]. The Rust code marks them as they are
      listed, but where they say their places, as here, it need not: what is listed at two places are two.
    - A set of vertices is kept as the number that all of its vertices have, and [join] gives those of one set the number
      of the other; sets are counted when it is asked how many there are, which makes it quadratic. The Rust code keeps a forest
      of disjoint sets, and their number. Both have the same sets after the same joins, and nothing else is asked of them: which number
      stands for a set does not matter.
    - A nil is read as 0 where it has been excluded before: of what is listed ([entry_ok]), of the twins and origins of
      half-edges ([scanned]), and of the vertices where boundary components start ([enters]).
    - Subtraction of naturals ends at 0: where there are fewer vertices and cycles than edges, [twice] is 0, and the Rust code has a negative
      number. Both refuse then: of a structure with edges at least one set is left, so that the genus is not 0, and this is the plane.
      Other surfaces, where the sign matters, are not modelled.
    - It accepts or refuses. The Rust code asks the same in another order, the vertices before the cycles, and where something
      is wrong it keeps what holds in spite of that, and has the rest looked at by the rules.

    Nothing is said here of that, of the figures that the Rust code notes on the way, and of memory that runs out. *)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import View Rules Loops Reference.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section FastPath.
Variable t : view.

(** The link, if the slot that it leads to exists. *)
Definition existing n (l : link) : link := if l is Some i then if i < n then Some i else None else None.

Definition live_ones n live := [seq i <- iota 0 n | live i].
Definition vertex_ones := live_ones (vertex_slots t) (vertex t).
Definition half_edge_ones := live_ones (half_edge_slots t) (half_edge t).
Definition boundary_ones := live_ones (boundary_slots t) (boundary t).
Definition face_ones := live_ones (face_slots t) (face t).

(** ** The scan over the half-edges (links.rs) *)

Definition scanned h : bool :=
  match existing (half_edge_slots t) (says_twin t h), existing (half_edge_slots t) (says_next t h) with
  | Some w, Some n =>
    [&& w != h, half_edge t w, same_link (says_twin t w) (Some h), half_edge t n, ~~ is_nil (says_origin t n),
        same_link (says_origin t n) (says_origin t w) & same_link (says_prev t n) (Some h)]
  | _, _ => false
  end.

(** ** Along every boundary component, from where a face lists it (boundaries.rs) *)

Definition along_step b h : link :=
  if same_link (says_boundary t h) (Some b) then existing (half_edge_slots t) (says_next t h) else None.

(** The number of half-edges that the walk along [b] visits, if it finds nothing wrong. *)
Definition along b : option nat :=
  match says_boundary_start t b with
  | Some (AtHalfEdge h) => if half_edge t h then round_trip (half_edge_slots t) (along_step b) h else None
  | Some (AtVertex _) => if says_boundary_place t b is Some Outer then None else Some 0
  | None => None
  end.

(** The vertex where [b] starts. *)
Definition says_vertex_at b : link :=
  match says_boundary_start t b with
  | Some (AtHalfEdge h) => if half_edge t h then says_origin t h else None
  | Some (AtVertex v) => if vertex t v then Some v else None
  | None => None
  end.

(** That vertex is there; of an outer boundary component it need only be named. *)
Definition enters p b : bool :=
  match p with
  | Outer => ~~ is_nil (says_vertex_at b)
  | Inner _ => ~~ is_nil (existing (vertex_slots t) (says_vertex_at b))
  end.

(** The room that the lists of the faces have: at this place of this face. *)
Definition has_outer f := ~~ is_nil (says_outer t f).
Definition entries_of f : seq (nat * place) :=
  [seq (f, Outer) | _ <- iota 0 (has_outer f)] ++ [seq (f, Inner i) | i <- iota 0 (says_inner_count t f)].
Definition entries : seq (nat * place) := flatten [seq entries_of f | f <- face_ones].

Definition says_listed (e : nat * place) : link :=
  match e.2 with Outer => says_outer t e.1 | Inner i => says_inner t e.1 i end.

(** The boundary component that is listed there is live, says so itself, and can be walked along. *)
Definition entry_ok (e : nat * place) : bool :=
  if says_listed e is Some b then
    [&& boundary t b, same_link (says_boundary_face t b) (Some e.1), same_place (says_boundary_place t b) e.2,
        enters e.2 b & ~~ is_nil (along b)]
  else false.

Definition listed_ones : seq nat := [seq odflt 0 (says_listed e) | e <- entries].

(** Each is listed once, and there are as many as there are boundary components. *)
Definition listed_once := uniq listed_ones && (size entries == size boundary_ones).

(** ** Around every vertex (rotations.rs) *)

Definition around_step h : link :=
  if existing (half_edge_slots t) (says_twin t h) is Some w then
    if existing (vertex_slots t) (says_origin t w) is Some _ then existing (half_edge_slots t) (says_next t w) else None
  else None.

Definition names_its_boundary v :=
  if says_isolated t v is Some b then boundary t b && starts_at v (says_boundary_start t b) else false.

(** The number of half-edges that the walk around [v] visits, if it finds nothing wrong. *)
Definition around v : option nat :=
  if says_leaving t v is Some l then
    if [&& half_edge t l, same_link (says_origin t l) (Some v) & is_nil (says_isolated t v)]
    then round_trip (half_edge_slots t) around_step l else None
  else if names_its_boundary v then Some 0 else None.

(** The vertices that the walk around [v] sees, and that with the smallest number of these and [v]. *)
Definition neighbours v : seq nat :=
  if leaving t v is Some l then
    [seq odflt 0 (says_twin t h >>= says_origin t) |
      h <- traject (fun h => odflt 0 (around_step h)) l (odflt 0 (around v))]
  else [::].
Definition nearest v := foldr minn v (neighbours v).

(** ** Counting (mod.rs) *)

Definition is_isolated v := is_nil (says_leaving t v).
Definition is_at_vertex b := if says_boundary_start t b is Some (AtVertex _) then true else false.

Definition complete :=
  [&& sumn [seq odflt 0 (along b) | b <- listed_ones] == size half_edge_ones,
      sumn [seq odflt 0 (around v) | v <- vertex_ones] == size half_edge_ones,
      count is_at_vertex listed_ones == count is_isolated vertex_ones
    & size face_ones == count has_outer face_ones + 1].

(** ** The components, joined edge by edge (rotations.rs)

<<
      each vertex to its nearest:           then edge by edge, until as few sets are left as can be:

        7 ──► 3 ──► 1      6 ──► 2            {1 3 7}  {2 6}   ── edge 7–6 ──►   {1 3 7 2 6}   stop
>>
*)

(** The number of sets, if vertices are in the same set that have the same number. *)
Definition sets (number : memory nat) := size (undup [seq read number v | v <- vertex_ones]).

(** Each vertex has the number that [f] gives it. *)
Definition numbered (f : nat -> nat) : memory nat :=
  fold_below (vertex_slots t) (fun number v => write number v (f v)) (blank 0).

(** The set of [u] and that of [v] become one. *)
Definition join (number : memory nat) u v : memory nat :=
  numbered (fun w => if read number w == read number u then read number v else read number w).

Definition hooked : memory nat := foldl (fun number v => join number v (nearest v)) (numbered id) vertex_ones.

Definition edge_ends : seq (nat * nat) :=
  [seq (odflt 0 (says_origin t h), odflt 0 (says_twin t h >>= says_origin t)) |
    h <- half_edge_ones & h < odflt 0 (says_twin t h)].

Fixpoint join_until fewest (ends : seq (nat * nat)) number :=
  if ends is (u, v) :: rest then if sets number <= fewest then number else join_until fewest rest (join number u v)
  else number.

(** Euler's formula, where an isolated vertex has one cycle: this less the edges is twice the number of components, at
    genus 0. *)
Definition vertices_and_cycles :=
  size vertex_ones + count (predC is_at_vertex) listed_ones + count is_isolated vertex_ones.
Definition edge_number := (size half_edge_ones)./2.
Definition twice := vertices_and_cycles - edge_number.

Definition set_of : memory nat := join_until (maxn twice./2 1) edge_ends hooked.

(** T3: there are as few sets as can be. *)
Definition as_few_as_can_be number := [&& edge_number <= vertices_and_cycles, ~~ odd twice & sets number == twice./2].

(** T1: each set has one inner boundary component. *)
Definition is_listed_inner b := if says_boundary_place t b is Some (Inner _) then true else false.
Definition outsides (number : memory nat) :=
  [seq read number (odflt 0 (says_vertex_at b)) | b <- listed_ones & is_listed_inner b].
Definition one_outside_each number := uniq (outsides number) && (size (outsides number) == sets number).

Definition fast_path :=
  [&& all scanned half_edge_ones, all entry_ok entries && listed_once, all (fun v => ~~ is_nil (around v)) vertex_ones,
      complete & let number := set_of in as_few_as_can_be number && one_outside_each number].

End FastPath.
