(** * ExpectationsCheck: a checker that names the first broken rule, for every expectation

    It decides each rule by itself, as reference/rules.rs does, and the first rule that is broken is the answer. It is slow, O(n⁴)
    where every rule holds, and meant for small tables. ExpectationsProof.v proves it right for every expectation and every
    structure. *)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import View Rules Loops Reference Expectations.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** ** Sets of numbers, as lists *)

Definition member (x : nat) (s : seq nat) := has (fun y => y == x) s.

(** [known], and what [near] leads to from there: one more with each step. *)
Fixpoint close fuel (near : nat -> seq nat) (known : seq nat) : seq nat :=
  if fuel is less.+1 then
    if ohead [seq y <- flatten (map near known) | ~~ member y known] is Some y then close less near (y :: known) else known
  else known.

(** True if exactly one has the property, or none has and that is legal. *)
Definition one_or_none_in A (p : A -> bool) (all : seq A) (legal : bool) :=
  match count p all with 0 => legal | 1 => true | _ => false end.

(** The list has no smaller number than [x]. *)
Definition is_least x (same : seq nat) := all (fun y => x <= y) same.

Definition asks (number : option nat) (p : nat -> bool) := if number is Some n then p n else true.

Section Check.
Variables (e : expectation) (s : structure).

Notation t := (seen e s).

Definition vertex_list := [seq v <- iota 0 (vertex_slots t) | vertex t v].
Definition half_edge_list := [seq h <- iota 0 (half_edge_slots t) | half_edge t h].
Definition boundary_list := [seq b <- iota 0 (boundary_slots t) | boundary t b].
Definition face_list := [seq f <- iota 0 (face_slots t) | face t f].

Definition entry_list : seq (nat * place) :=
  flatten [seq (f, Outer) :: [seq (f, Inner i) | i <- iota 0 (inner_count t f)] | f <- face_list].

(** All that [f] leads to from [h], and that of the other walks. *)
Definition orbit_of (f : nat -> link) h := close (half_edge_slots t).+2 (fun g => push (f g) [::]) [:: h].
Definition leaving_list v := [seq h <- half_edge_list | same_link (origin t h) (Some v)].
Definition bare_at v := if leaving_list v is [::] then true else false.
Definition ends_at v := pmap (end_of e s) (leaving_list v).
Definition linked_list v := close (half_edge_slots t).+2 ends_at [:: v].
Definition followers g := [seq h <- half_edge_list | on_border e s h &&
  (if end_of e s g is Some u then same_link (origin t h) (Some u) else false)].
Definition border_of h := close (half_edge_slots t).+2 followers [:: h].

(** ** R1 *)

Definition check_half_edge h :=
  [&& leads (vertex t) (origin t h), leads (half_edge t) (twin t h) || on_border e s h, leads (half_edge t) (next t h),
      ~~ has_prev s || leads (half_edge t) (prev t h)
    & [|| ~~ has_faces s, leads (is_side e s) (side e s h) | [&& is_open e, ~~ is_nil (twin t h) & is_nil (side e s h)]]].
Definition check_vertex v :=
  (~~ has_leaving s || (leads (half_edge t) (leaving t v) || is_nil (leaving t v) && bare_at v)) &&
  (is_nil (isolated t v) || leads (boundary t) (isolated t v)).
Definition check_face f :=
  (~~ has_outer e s f || if has_records s then leads (boundary t) (outer t f) else start_lives t (entry_start e s f Outer)) &&
  all (fun i => if has_records s then leads (boundary t) (inner t f i) else start_lives t (entry_start e s f (Inner i)))
    (iota 0 (inner_count t f)).
Definition check_short := sumn [seq inner_count t f | f <- iota 0 (face_slots t)] <= 2 * is_listable e s + 16.

(** The lengths of the lists are asked first, so that no list is read that is too long. *)
Definition decide_r1 :=
  [&& check_short, all check_half_edge half_edge_list, all check_vertex vertex_list,
      all (fun b => leads (face t) (boundary_face t b) && start_lives t (boundary_start t b)) boundary_list
    & all check_face face_list].

(** ** L1 to V2 *)

Definition decide_l1 := all (fun h => on_border e s h ||
  same_link (twin t h >>= twin t) (Some h) && ~~ same_link (twin t h) (Some h)) half_edge_list.
Definition decide_l2 := if has_prev s then check_l2 t else
  all (fun g => all (fun h => ~~ same_link (next t g) (next t h) || (g == h)) half_edge_list) half_edge_list.
Definition decide_l3 := all (fun h => on_border e s h ||
  same_link (next t h >>= origin t) (twin t h >>= origin t)) half_edge_list.
Definition decide_v2 := all (fun g =>
    let there := orbit_of (turn t) g in
    let back := if is_open e then orbit_of (turn_back e s) g else [::] in
    all (fun h => (member h there || member h back) == same_link (origin t g) (origin t h)) half_edge_list)
  half_edge_list.

(** ** B1 to F2 *)

Definition decide_b1 :=
  (~~ has_faces s || all (fun h => same_link (next t h >>= side e s) (side e s h)) half_edge_list) &&
  if has_records s then
    all (fun b =>
        let cycle := if boundary_start t b is Some (AtHalfEdge g) then orbit_of (next t) g else [::] in
        all (fun h => same_link (boundary_of t h) (Some b) == member h cycle) half_edge_list)
      boundary_list
  else all (fun entry => if entry_start e s entry.1 entry.2 is Some (AtHalfEdge h)
    then same_link (side e s h) (Some entry.1) else true) entry_list.

Definition at_entry v (entry : nat * place) := starts_at v (entry_start e s entry.1 entry.2).
Definition at_boundary v b := starts_at v (boundary_start t b).
Definition decide_b2 := ~~ has_holes e s || all (fun v =>
    if has_records s then
      (if bare_at v then one_or_none_in (at_boundary v) boundary_list (~~ has_unbounded e s)
       else ~~ has (at_boundary v) boundary_list) &&
      (if isolated t v is Some b then at_boundary v b else true) &&
      all (fun b => ~~ at_boundary v b || same_link (isolated t v) (Some b)) boundary_list
    else if bare_at v then one_or_none_in (at_entry v) entry_list (~~ has_unbounded e s)
    else ~~ has (at_entry v) entry_list)
  vertex_list.

Definition decide_f1 := ~~ has_faces s ||
  (count (fun f => ~~ has_outer e s f) face_list == if has_unbounded e s then 1 else 0) &&
  all (fun f => if entry_start e s f Outer is Some (AtVertex _) then false else true) face_list.

Definition check_listed b :=
  match boundary_face t b with
  | None => false
  | Some f => has (fun entry => [&& entry.1 == f, ~~ has_places s || same_place (boundary_place t b) entry.2 &
        same_link (listed t entry.1 entry.2) (Some b)]) entry_list &&
      (count (fun entry => same_link (listed t entry.1 entry.2) (Some b)) entry_list == 1)
  end.
Definition on_list cycle (entry : nat * place) :=
  if entry_start e s entry.1 entry.2 is Some (AtHalfEdge g) then member g cycle else false.
Definition decide_f2 :=
  if has_records s then all check_listed boundary_list else
  ~~ has_faces s || all (fun h =>
    let cycle := orbit_of (next t) h in one_or_none_in (on_list cycle) entry_list (is_nil (side e s h))) half_edge_list.

(** ** T1 to T4 *)

Definition is_at (vs : seq nat) (l : link) := if l is Some w then member w vs else false.
Definition component_list vs := [seq h <- half_edge_list | is_at vs (origin t h)].
Definition is_inner_place (p : place) := if p is Inner _ then true else false.
Definition is_outside vs (entry : nat * place) :=
  is_inner_place entry.2 && is_at vs (vertex_of e s (entry_start e s entry.1 entry.2)).

Definition decide_t1 := ~~ has_holes e s || all (fun v =>
    let vs := linked_list v in
    one_or_none_in (is_outside vs) entry_list
      (~~ has_unbounded e s || has (fun h => on_border e s h || lacks_face e s h) (component_list vs)))
  vertex_list.

Definition containers v := let vs := linked_list v in
  pmap (fun entry : nat * place => vertex_of e s (entry_start e s entry.1 Outer)) [seq entry <- entry_list | is_outside vs entry].
Definition container_list v := close (size entry_list).+1 containers (containers v).
Definition decide_t2 := ~~ has_holes e s || all (fun v =>
  ~~ has (fun w => member v (linked_list w)) (container_list v)) vertex_list.

Definition least_edges hs := [seq h <- hs | if twin t h is Some g then h <= g else true].
Definition least_cycles hs := [seq h <- hs | is_least h (orbit_of (next t) h)].
Definition least_borders hs := [seq h <- hs | on_border e s h && is_least h (border_of h)].

(** The numbers of vertices, of edges, and of cycles and borders of the component of [v]. *)
Definition counted v :=
  let vs := linked_list v in
  let hs := component_list vs in
  let edges := size (least_edges hs) in
  (size vs, edges, size (least_cycles hs) + size (least_borders hs) + (edges == 0)).

(** The genus of the component of [v], if there is one. *)
Definition genus_at v : option nat :=
  let: (V, E, cycles) := counted v in
  if (V + cycles <= 2 + E) && ~~ odd (2 + E - (V + cycles)) then Some (half (2 + E - (V + cycles))) else None.

Definition decide_t3 := all (fun v =>
  if genus_at v is Some g then ~~ on_plane e || (g == 0) else false) vertex_list.

Definition both (k l : link) (m n : link) := same_link k m && same_link l n.
Definition decide_simple := all (fun g =>
    match origin t g, end_of e s g with
    | Some u, Some w => (u != w) && all (fun h =>
        ~~ (both (origin t h) (end_of e s h) (Some u) (Some w) || both (origin t h) (end_of e s h) (Some w) (Some u)) ||
        ((g == h) || same_link (twin t g) (Some h))) half_edge_list
    | _, _ => true
    end)
  half_edge_list.

Definition decide_t4 := ~~ on_plane e || ~~ decide_simple ||
  let V := size vertex_list in
  (V < 3) || (size (least_edges half_edge_list) + 6 <= 3 * V) && (size face_list + 4 <= 2 * V).

(** ** M1 to M8 *)

Definition decide_m1 := ~~ no_unused_vertices e || all (fun v => ~~ bare_at v) vertex_list.
Definition decide_m2 := ~~ no_loops_nor_parallels e || decide_simple.
Definition decide_m3 := asks (sides_asked e) (fun n =>
  if has_faces s then all (fun f => ~~ has_outer e s f ||
    (size [seq h <- half_edge_list | same_link (face_of e s h) (Some f)] == n)) face_list
  else all (fun h => size (orbit_of (next t) h) == n) half_edge_list).
Definition decide_m4 := ~~ without_border e ||
  all (fun h => ~~ is_nil (twin t h) && ~~ lacks_face e s h) half_edge_list.
Definition decide_m5 := asks (components_asked e) (fun n =>
  size [seq v <- vertex_list | let vs := linked_list v in is_least v vs && ~~ nilp (component_list vs)] == n).
Definition decide_m6 := asks (borders_asked e) (fun n =>
  size [seq h <- half_edge_list | lacks_face e s h && is_least h (orbit_of (next t) h)] + size (least_borders half_edge_list) == n).
Definition decide_m7 := asks (genus_asked e) (fun n =>
  let vs := [seq v <- vertex_list | is_least v (linked_list v)] in
  all (fun v => isSome (genus_at v)) vs && (sumn [seq odflt 0 (genus_at v) | v <- vs] == n)).
Definition decide_m8 := ~~ border_kept e || ~~ has_leaving s || all (fun h =>
  if origin t h is Some v then ~~ at_border e s h || (if leaving t v is Some g then at_border e s g else true) else true)
  half_edge_list.

Definition decide (r : any_rule) : bool :=
  match r with
  | Basic R1 => decide_r1 | Basic L1 => decide_l1 | Basic L2 => decide_l2 | Basic L3 => decide_l3
  | Basic V1 => check_v1 t | Basic V2 => decide_v2
  | Basic B1 => decide_b1 | Basic B2 => decide_b2 | Basic F1 => decide_f1 | Basic F2 => decide_f2
  | Basic T1 => decide_t1 | Basic T2 => decide_t2 | Basic T3 => decide_t3 | Basic T4 => decide_t4
  | Mesh M1 => decide_m1 | Mesh M2 => decide_m2 | Mesh M3 => decide_m3 | Mesh M4 => decide_m4
  | Mesh M5 => decide_m5 | Mesh M6 => decide_m6 | Mesh M7 => decide_m7 | Mesh M8 => decide_m8
  end.

Fixpoint first_refused rules : option any_rule :=
  if rules is r :: rest then if decide r then first_refused rest else Some r else None.

Definition first_broken_of : option any_rule := first_refused ladder.

End Check.
