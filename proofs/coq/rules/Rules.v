(** * Rules: R1 to T4 as propositions (rule.rs, and the sentences of reference/rules.rs)

    Each rule is its sentence in the README's table, with quantifiers, over any [view] whatever. Nothing is computed
    here. The expectation is `Expectation::plane()`: every part is there, the surface is the plane, and it is closed.

<<
              next(h)                       a half-edge h, its twin t, and what each names
          ┌───────◄──────┐
          │       ┌──────┴───────┐          boundary_of(h) ── is listed by ──► face
          ▼     h │ ▲ t          │
                  ▼ │            │
>>
*)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import View.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Inductive rule := R1 | L1 | L2 | L3 | V1 | V2 | B1 | B2 | F1 | F2 | T1 | T2 | T3 | T4.

Section Rules.
Variable t : view.

(** ** R1 live: every link that a record needs is there, and every link leads to a live record *)

Definition leads_to (live : nat -> bool) (l : link) := exists2 i, l = Some i & live i.
Definition nil_or_leads_to live (l : link) := l = None \/ leads_to live l.

(** No half-edge leaves the vertex. *)
Definition bare v := forall h, half_edge t h -> origin t h <> Some v.

Definition starts_live (s : option start) : Prop :=
  match s with
  | Some (AtHalfEdge h) => half_edge t h
  | Some (AtVertex v) => vertex t v
  | None => False
  end.

Definition half_edges_live := forall h, half_edge t h ->
  [/\ leads_to (vertex t) (origin t h), leads_to (half_edge t) (twin t h), leads_to (half_edge t) (next t h),
      leads_to (half_edge t) (prev t h) & leads_to (boundary t) (boundary_of t h)].
Definition vertices_live := forall v, vertex t v ->
  (leads_to (half_edge t) (leaving t v) \/ leaving t v = None /\ bare v) /\
  nil_or_leads_to (boundary t) (isolated t v).
Definition boundaries_live := forall b, boundary t b ->
  leads_to (face t) (boundary_face t b) /\ starts_live (boundary_start t b).
Definition faces_live := forall f, face t f ->
  nil_or_leads_to (boundary t) (outer t f) /\
  forall i, i < inner_count t f -> leads_to (boundary t) (inner t f i).

Definition links_live := [/\ half_edges_live, vertices_live, boundaries_live & faces_live].

(** The lists of the faces together hold no more than twice as many entries as there are boundary components, and 16. The
    validator reads no further, and cannot say that what it did not read is live. *)
Definition lists_short :=
  sumn [seq inner_count t f | f <- iota 0 (face_slots t)] <= 2 * count (boundary t) (iota 0 (boundary_slots t)) + 16.

Definition r1_live := links_live /\ lists_short.

(** ** L1 twin: `twin(twin(h)) = h` and `twin(h) ≠ h` *)

Definition l1_twin := forall h, half_edge t h -> twin t h >>= twin t = Some h /\ twin t h <> Some h.

(** ** L2 next/prev: `prev(next(h)) = h` and `next(prev(h)) = h` *)

Definition l2_next_prev := forall h, half_edge t h ->
  next t h >>= prev t = Some h /\ prev t h >>= next t = Some h.

(** ** L3 target: `origin(next(h)) = origin(twin(h))` *)

Definition l3_target := forall h, half_edge t h -> next t h >>= origin t = twin t h >>= origin t.

(** ** V1 leaving: the half-edge kept by a vertex leaves that vertex *)

Definition v1_leaving := forall v h, vertex t v -> leaving t v = Some h -> origin t h = Some v.

(** ** V2 rotation: the rotation of a vertex is all half-edges with that origin *)

Definition v2_rotation := forall g h, half_edge t g -> half_edge t h ->
  (on_orbit (turn t) g h <-> origin t g = origin t h).

(** ** B1 cycle: the boundary component is constant along `next`, its start is on its own cycle, and it has one cycle

    So the half-edges of a boundary component are the cycle of its start; there are none if it starts at a vertex. *)

Definition on_cycle := on_orbit (next t).

Definition b1_cycle :=
  (forall h, half_edge t h -> next t h >>= boundary_of t = boundary_of t h) /\
  (forall b h, boundary t b -> half_edge t h ->
     (boundary_of t h = Some b <-> exists2 g, boundary_start t b = Some (AtHalfEdge g) & on_cycle g h)).

(** ** B2 isolated: a vertex has no half-edge if and only if exactly one boundary component starts at it, and they name
    each other

    At other vertices none starts, and they name none. *)

Definition starts_at_vertex v b := boundary_start t b = Some (AtVertex v).

Definition b2_isolated := forall v, vertex t v ->
  (bare v -> exists b, isolated t v = Some b /\ forall c, starts_at_vertex v c <-> c = b) /\
  (~ bare v -> isolated t v = None /\ forall b, ~ starts_at_vertex v b).

(** ** F1 outer: a bounded face has exactly one outer boundary component, a cycle; the one unbounded face has none

    A face keeps one link for it, so that there are never two. *)

Definition unbounded f := face t f /\ outer t f = None.

Definition f1_outer :=
  (exists! f, unbounded f) /\ (forall f b v, outer t f = Some b -> ~ starts_at_vertex v b).

(** ** F2 listed: every boundary component is listed exactly once, by the face it names, at the place it says *)

Definition listed f p : link := match p with Outer => outer t f | Inner i => inner t f i end.

Definition f2_listed := forall b, boundary t b -> exists f p,
  [/\ boundary_face t b = Some f, boundary_place t b = Some p & forall f' p', listed f' p' = Some b <-> f' = f /\ p' = p].

(** ** T1 outside: each component has exactly one inner boundary component, its outside

    [connected u v]: edges lead from vertex [u] to vertex [v]. The component of [v] is all that is connected to [v]. *)

Inductive connected u : nat -> Prop :=
  | connected_self : connected u u
  | connected_edge h v w : connected u v -> origin t h = Some v -> target t h = Some w -> connected u w.

(** The vertex where a boundary component starts. *)
Definition vertex_at b : link :=
  match boundary_start t b with Some (AtHalfEdge h) => origin t h | Some (AtVertex v) => Some v | None => None end.

Definition is_inner b := exists i, boundary_place t b = Some (Inner i).

(** [b] is an inner boundary component of the component of [v]. *)
Definition outside_of v b := is_inner b /\ exists2 w, vertex_at b = Some w & connected v w.

Definition t1_outside := forall v, vertex t v -> exists! b, outside_of v b.

(** ** T2 nesting: containment is a tree rooted at the unbounded face

    From the face in which a component lies one steps out to the component that bounds that face, to the face in which
    that one lies, and so on, and arrives at the unbounded face.

<<
      ┌───────────────── f'        v lies in f, its component is bounded by b,
      │  ┌────────────┐  lies in   w is on the component that bounds f,
      │  │ f   · v    │            w lies in f', and so on
      │  └─w──────────┘
>>
*)

Inductive rooted : nat -> Prop :=
  | rooted_here f : unbounded f -> rooted f
  | rooted_out f b w b' f' : outer t f = Some b -> vertex_at b = Some w ->
      outside_of w b' -> boundary_face t b' = Some f' -> rooted f' -> rooted f.

Definition t2_nesting := forall v b f, vertex t v -> outside_of v b -> boundary_face t b = Some f -> rooted f.

(** ** T3 Euler: per component `V − E + cycles = 2 − 2g`, with `g = 0` in the plane

    Counting is writing down a list without repetition. Cycles are counted by a list that has one half-edge of each
    cycle, and edges by a list that has one half-edge of each edge. An isolated vertex counts as a cycle. *)

Definition lists (s : seq nat) (P : nat -> Prop) := uniq s /\ forall x, x \in s <-> P x.

Definition lists_one_of_each (s : seq nat) (same : nat -> nat -> Prop) (P : nat -> Prop) :=
  [/\ uniq s, forall x, x \in s -> P x, forall x y, x \in s -> y \in s -> same x y -> x = y
    & forall x, P x -> exists2 y, y \in s & same y x].

Definition same_edge g h := g = h \/ twin t g = Some h.

(** The half-edges of the component of [v]. *)
Definition half_edge_of v h := exists2 w, origin t h = Some w & connected v w.

(** The component of [v] has so many vertices, edges and cycles. *)
Definition has_counts v V E cycles := exists vs es cs,
  [/\ lists vs (connected v), lists_one_of_each es same_edge (half_edge_of v),
      lists_one_of_each cs on_cycle (half_edge_of v)
    & [/\ V = size vs, E = size es & cycles = size cs + (es == [::])]].

Definition t3_euler := forall v, vertex t v -> exists V E cycles,
  has_counts v V E cycles /\ V + cycles = 2 + E.

(** ** T4 bounds: a simple map with `V ≥ 3` has `E ≤ 3V − 6` and `F ≤ 2V − 4` *)

Definition simple := forall g h u w,
  origin t g = Some u -> target t g = Some w ->
  u <> w /\ (origin t h = Some u -> target t h = Some w -> g = h).

Definition map_has_counts V E F := exists vs es fs,
  [/\ lists vs (vertex t), lists_one_of_each es same_edge (half_edge t), lists fs (face t)
    & [/\ V = size vs, E = size es & F = size fs]].

Definition t4_bounds := forall V E F, map_has_counts V E F -> simple -> 3 <= V -> E + 6 <= 3 * V /\ F + 4 <= 2 * V.

End Rules.

(** ** The ladder *)

Definition holds t (r : rule) : Prop :=
  match r with
  | R1 => r1_live t | L1 => l1_twin t | L2 => l2_next_prev t | L3 => l3_target t
  | V1 => v1_leaving t | V2 => v2_rotation t
  | B1 => b1_cycle t | B2 => b2_isolated t
  | F1 => f1_outer t | F2 => f2_listed t
  | T1 => t1_outside t | T2 => t2_nesting t | T3 => t3_euler t | T4 => t4_bounds t
  end.

(** The position of a rule in `Rule::ALL`. *)
Definition index (r : rule) : nat :=
  match r with
  | R1 => 0 | L1 => 1 | L2 => 2 | L3 => 3 | V1 => 4 | V2 => 5 | B1 => 6 | B2 => 7
  | F1 => 8 | F2 => 9 | T1 => 10 | T2 => 11 | T3 => 12 | T4 => 13
  end.

Definition holds_before t r := forall q, index q < index r -> holds t q.

(** All rules hold. *)
Definition rules t := forall r, holds t r.

(** [r] is the first broken rule. *)
Definition first_broken_is t r := ~ holds t r /\ holds_before t r.
