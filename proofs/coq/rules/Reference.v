(** * Reference: a checker that names the first broken rule (reference/rules.rs)

    It says the same as the reference validator of the Rust code: the first broken rule in the order of the ladder, or
    none. It asks of each rule no more than is needed where the rules before it hold, so that it is linear (but for the
    memory, which costs a factor of log n). ReferenceProof.v proves it right for every view. *)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import View Rules Loops.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section Checker.
Variable t : view.

(** ** Questions about links *)

Definition leads (live : nat -> bool) (l : link) : bool := if l is Some i then live i else false.
Definition is_nil (l : link) : bool := if l is None then true else false.
Definition same_link (k l : link) : bool :=
  match k, l with Some i, Some j => i == j | None, None => true | _, _ => false end.

Definition each_vertex p := all_below (vertex_slots t) (fun v => if vertex t v then p v else true).
Definition each_half_edge p := all_below (half_edge_slots t) (fun h => if half_edge t h then p h else true).
Definition each_boundary p := all_below (boundary_slots t) (fun b => if boundary t b then p b else true).
Definition each_face p := all_below (face_slots t) (fun f => if face t f then p f else true).

(** ** What is counted *)

(** The number of half-edges that leave a vertex. *)
Definition degrees : memory nat := tally (half_edge_slots t) (origin t).

(** The number of half-edges that name a boundary component. *)
Definition lengths : memory nat := tally (half_edge_slots t) (boundary_of t).

(** ** R1 to F2 *)

Definition start_lives (s : option start) : bool :=
  match s with Some (AtHalfEdge h) => half_edge t h | Some (AtVertex v) => vertex t v | None => false end.

Definition check_lists_short :=
  fold_below (face_slots t) (fun sum f => sum + inner_count t f) 0
  <= 2 * fold_below (boundary_slots t) (fun sum b => if boundary t b then sum.+1 else sum) 0 + 16.

Definition check_links (degree : memory nat) :=
  [&& each_half_edge (fun h =>
        [&& leads (vertex t) (origin t h), leads (half_edge t) (twin t h), leads (half_edge t) (next t h),
            leads (half_edge t) (prev t h) & leads (boundary t) (boundary_of t h)]),
      each_vertex (fun v =>
        (leads (half_edge t) (leaving t v) || is_nil (leaving t v) && (read degree v == 0))
        && (is_nil (isolated t v) || leads (boundary t) (isolated t v))),
      each_boundary (fun b => leads (face t) (boundary_face t b) && start_lives (boundary_start t b))
    & each_face (fun f =>
        (is_nil (outer t f) || leads (boundary t) (outer t f))
        && all_below (inner_count t f) (fun i => leads (boundary t) (inner t f i)))].

Definition check_r1 (degree : memory nat) := check_lists_short && check_links degree.

Definition check_l1 := each_half_edge (fun h =>
  same_link (twin t h >>= twin t) (Some h) && ~~ same_link (twin t h) (Some h)).

Definition check_l2 := each_half_edge (fun h =>
  same_link (next t h >>= prev t) (Some h) && same_link (prev t h >>= next t) (Some h)).

Definition check_l3 := each_half_edge (fun h => same_link (next t h >>= origin t) (twin t h >>= origin t)).

Definition check_v1 := each_vertex (fun v =>
  if leaving t v is Some h then same_link (origin t h) (Some v) else true).

(** The rotation of a vertex has as many half-edges as leave the vertex. *)
Definition check_v2 (degree : memory nat) := each_vertex (fun v =>
  if leaving t v is Some h then same_link (round_trip (half_edge_slots t) (turn t) h) (Some (read degree v)) else true).

(** The cycle of a boundary component has as many half-edges as name the boundary component. *)
Definition check_b1 (length : memory nat) :=
  each_half_edge (fun h => same_link (next t h >>= boundary_of t) (boundary_of t h))
  && each_boundary (fun b =>
       if boundary_start t b is Some (AtHalfEdge h) then
         same_link (boundary_of t h) (Some b)
         && same_link (round_trip (half_edge_slots t) (next t) h) (Some (read length b))
       else read length b == 0).

Definition starts_at v (s : option start) : bool := if s is Some (AtVertex u) then u == v else false.

Definition check_b2 (degree : memory nat) :=
  each_boundary (fun b =>
    if boundary_start t b is Some (AtVertex v) then (read degree v == 0) && same_link (isolated t v) (Some b) else true)
  && each_vertex (fun v =>
    if read degree v == 0 then if isolated t v is Some b then starts_at v (boundary_start t b) else false
    else is_nil (isolated t v)).

Definition check_f1 :=
  (read (tally (face_slots t) (fun f => if face t f && is_nil (outer t f) then Some 0 else None)) 0 == 1)
  && each_face (fun f =>
       if outer t f is Some b then if boundary_start t b is Some (AtVertex _) then false else true else true).

Definition same_place (p : option place) q : bool :=
  match p, q with Some Outer, Outer => true | Some (Inner i), Inner j => i == j | _, _ => false end.

Definition names_place f p (l : link) : bool :=
  if l is Some b then same_link (boundary_face t b) (Some f) && same_place (boundary_place t b) p else true.

Definition check_f2 :=
  each_boundary (fun b =>
    match boundary_face t b, boundary_place t b with
    | Some f, Some p => same_link (listed t f p) (Some b)
    | _, _ => false
    end)
  && each_face (fun f =>
    names_place f Outer (outer t f) && all_below (inner_count t f) (fun i => names_place f (Inner i) (inner t f i))).

(** ** T1 to T3: with a label for each half-edge, the same throughout a component and nowhere else *)

Definition near h := push (next t h) (push (prev t h) (push (twin t h) [::])).
Definition labels : memory link := flood_all (4 * half_edge_slots t).+2 (half_edge_slots t) (half_edge t) near.

(** The label of the component that the boundary component is part of, if it has half-edges. *)
Definition label_at (label : memory link) b : link :=
  if boundary_start t b is Some (AtHalfEdge h) then read label h else None.

Definition outside_label label b : link :=
  if boundary_place t b is Some (Inner _) then label_at label b else None.

Definition check_t1 label :=
  let outsides := tally (boundary_slots t) (outside_label label) in
  each_half_edge (fun h => if read label h is Some r then read outsides r == 1 else false).

(** From a face, over the component that bounds it, to the face in which that component lies. *)
Definition outwards (label lies_in : memory link) f : link := outer t f >>= label_at label >>= read lies_in.

Definition check_t2 label :=
  let lies_in := recall (boundary_slots t) (outside_label label) (boundary_face t) in
  all_climb (face_slots t) (face_slots t) (face t) (outwards label lies_in) (blank false).

Definition check_t3 label :=
  let vertices := tally (vertex_slots t) (fun v => leaving t v >>= read label) in
  let half_edges := tally (half_edge_slots t) (fun h => if half_edge t h then read label h else None) in
  let cycles := tally (boundary_slots t) (label_at label) in
  each_half_edge (fun h => if read label h is Some r
    then (read vertices r + read cycles r).*2 == 4 + read half_edges r else false).

(** ** The ladder. T4 is not on it: it is never the first broken rule, as it follows from the others. *)

Definition first_broken : option rule :=
  let degree := degrees in
  if ~~ check_r1 degree then Some R1 else
  if ~~ check_l1 then Some L1 else
  if ~~ check_l2 then Some L2 else
  if ~~ check_l3 then Some L3 else
  if ~~ check_v1 then Some V1 else
  if ~~ check_v2 degree then Some V2 else
  if ~~ check_b1 lengths then Some B1 else
  if ~~ check_b2 degree then Some B2 else
  if ~~ check_f1 then Some F1 else
  if ~~ check_f2 then Some F2 else
  let label := labels in
  if ~~ check_t1 label then Some T1 else
  if ~~ check_t2 label then Some T2 else
  if ~~ check_t3 label then Some T3 else
  None.

End Checker.
