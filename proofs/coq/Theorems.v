(** * Theorems: the main theorems in one place

    Each is stated here once more, word for word, and Coq checks that it was proved as stated. *)

From Coq Require Import ZArith.
From mathcomp Require Import all_ssreflect all_fingroup.
From twinedge Require Import Expectations ExpectationsCheck ExpectationsVerdict ExpectationsPlane ExpectationsFaceless ExpectationsParts ExpectationsFaces ExpectationsBorder ExpectationsMissing ExpectationsOpenCounts ExpectationsOpen Near Merge.
From twinedge Require Import SearchOutside Encloses.
From twinedge Require Import ExpectationsNested ExpectationsHoles ExpectationsClosed ExpectationsBounds ExpectationsOrder NearWalks NearLists NearSum.
From twinedge Require Import RotationSystem View Rules Reference Drawing Euler Subdivision Verdict FastPath.
From twinedge Require Import FastPathComponents FastPathProof Labels LabelsSound LabelsComplete Fewer Columns Certified Surface SurfaceComplete AddVertex.
From twinedge Require Import RemoveVertex MoveInner Renaming Connect ConnectIsolated ConnectBridge ConnectSplit.
From twinedge Require Import ConnectLoop RemoveMerge RemovePart Skip Contract SplitVertex Flip Keep AnyInner Operate Core Tidy Programs Reach Orientation Triangulation Plane Coordinates CoordinatesSound.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** The checker names the first broken rule, and none if all hold. *)

Check first_broken_some : forall t r,
  first_broken t = Some r <-> ~ holds t r /\ forall q, index q < index r -> holds t q.

Check first_broken_none : forall t, first_broken t = None <-> rules t.

(** So does the checker of all expectations, whatever parts are stored, M1 to M8 included: it decides each rule. *)

Check decideP : forall e s r, reflect (holds_of e s r) (decide e s r).

Check first_broken_of_some : forall e s r, first_broken_of e s = Some r <->
  ~ holds_of e s r /\ forall q, Expectations.position q < Expectations.position r -> holds_of e s q.

Check first_broken_of_none : forall e s, first_broken_of e s = None <-> rules_of e s.

(** Of the closed plane, where every part is stored, these rules are those of Rules.v. *)

Check plane_rule : forall t sf so si r, holds_before t r ->
  holds_of Expectations.plane (Structure t all_parts sf so si) (Basic r) <-> holds t r.

Check plane_rules : forall t sf so si, rules_of Expectations.plane (Structure t all_parts sf so si) <-> rules t.

Check plane_first_broken : forall t sf so si,
  first_broken_of Expectations.plane (Structure t all_parts sf so si) = omap Basic (first_broken t).

(** If no faces are stored, they mean rotation systems on closed surfaces, and in the plane those that can be drawn edge by edge. *)

Check faceless_surface : forall t records places holes unbounded sf so si,
  rules_of Expectations.surface (Structure t (Parts true true false records places holes unbounded) sf so si) <->
  exists r, represents_rotations t r.

Check faceless_plane : forall t records places holes unbounded sf so si,
  rules_of Expectations.plane (Structure t (Parts true true false records places holes unbounded) sf so si) <->
  exists r, represents_rotations t r /\ plane_system r.

(** `prev`, the half-edges that vertices keep, and places need not be stored: they are filled in. *)

Check filled_rules : forall e s, ~~ border_kept e -> rules_of e s <-> rules_of e (filled e s).

Check filled_plane : forall v prev_stored leaving_stored places_stored sf so si,
  let s := Structure v (Parts prev_stored leaving_stored true true places_stored true true) sf so si in
  rules_of Expectations.plane s <-> exists u, represents (answers (filled Expectations.plane s)) u.

Check filled_faceless_surface : forall v prev_stored leaving_stored records places_stored holes unbounded sf so si,
  let s := Structure v (Parts prev_stored leaving_stored false records places_stored holes unbounded) sf so si in
  rules_of Expectations.surface s <-> exists r, represents_rotations (answers (filled Expectations.surface s)) r.

Check filled_faceless_plane : forall v prev_stored leaving_stored records places_stored holes unbounded sf so si,
  let s := Structure v (Parts prev_stored leaving_stored false records places_stored holes unbounded) sf so si in
  rules_of Expectations.plane s <-> exists r, represents_rotations (answers (filled Expectations.plane s)) r /\ plane_system r.

(** If faces are stored, the rules of closed surfaces mean that each face is one cycle of the rotation system, without records for
    boundary components and with them. *)

Check named_faces : forall t places holes unbounded sf so si,
  rules_of Expectations.surface (Structure t (Parts true true true false places holes unbounded) sf so si) <->
  surface_rules t /\ faces_are_cycles t sf so.

Check recorded_faces : forall t places holes unbounded sf so si,
  rules_of Expectations.surface (Structure t (Parts true true true true places holes unbounded) sf so si) <->
  surface_with_faces t places.

Check filled_named : forall v prev_stored leaving_stored places holes unbounded sf so si,
  let s := Structure v (Parts prev_stored leaving_stored true false places holes unbounded) sf so si in
  rules_of Expectations.surface s <->
  (exists r, represents_rotations (answers (filled Expectations.surface s)) r) /\ faces_are_cycles v sf so.

Check filled_recorded : forall v prev_stored leaving_stored places holes unbounded sf so si,
  let s := Structure v (Parts prev_stored leaving_stored true true places holes unbounded) sf so si in
  rules_of Expectations.surface s <-> surface_with_faces (answers (filled Expectations.surface s)) true.

(** So it is in the plane where no lists of inner boundary components are stored: the rotation system can be drawn, then. *)

Check named_faces_plane : forall t places unbounded sf so si,
  rules_of Expectations.plane (Structure t (Parts true true true false places false unbounded) sf so si) <->
  is_plane t /\ faces_are_cycles t sf so.

Check recorded_faces_plane : forall t places unbounded sf so si,
  rules_of Expectations.plane (Structure t (Parts true true true true places false unbounded) sf so si) <->
  is_plane t /\ surface_with_faces t places.

Check filled_named_plane : forall v prev_stored leaving_stored places unbounded sf so si,
  let s := Structure v (Parts prev_stored leaving_stored true false places false unbounded) sf so si in
  rules_of Expectations.plane s <-> is_plane (answers (filled Expectations.plane s)) /\ faces_are_cycles v sf so.

Check filled_recorded_plane : forall v prev_stored leaving_stored places unbounded sf so si,
  let s := Structure v (Parts prev_stored leaving_stored true true places false unbounded) sf so si in
  rules_of Expectations.plane s <->
  is_plane (answers (filled Expectations.plane s)) /\ surface_with_faces (answers (filled Expectations.plane s)) true.

(** If open boundaries are legal, they mean a rotation system from which some cycles may be missing, which do not meet; the structure
    stores the rest. Each cycle that is there has a face of its own, or none, and one that has a half-edge without twin has a face. *)

Check open_rules_mean_missing : forall t, open_rules t <-> exists r missing, @represents_without t r missing.

Check open_faceless : forall on t records places holes unbounded sf so si,
  rules_of (open_on on) (Structure t (Parts true true false records places holes unbounded) sf so si) <-> is_open_map on t.

Check open_named : forall on t places holes unbounded sf so si, holes && on = false ->
  rules_of (open_on on) (Structure t (Parts true true true false places holes unbounded) sf so si) <->
  is_open_map on t /\ open_faces t sf so.

Check open_recorded : forall on t places holes unbounded sf so si, holes && on = false ->
  rules_of (open_on on) (Structure t (Parts true true true true places holes unbounded) sf so si) <->
  is_open_map on t /\ open_boundaries t places.

Check filled_open_faceless : forall on v prev_stored leaving_stored places holes unbounded sf so si records,
  let s := Structure v (Parts prev_stored leaving_stored false records places holes unbounded) sf so si in
  rules_of (open_on on) s <-> is_open_map on (answers (filled (open_on on) s)).

Check filled_open_named : forall on v prev_stored leaving_stored places holes unbounded sf so si, holes && on = false ->
  let s := Structure v (Parts prev_stored leaving_stored true false places holes unbounded) sf so si in
  rules_of (open_on on) s <-> is_open_map on (answers (filled (open_on on) s)) /\ open_faces v sf so.

Check filled_open_recorded : forall on v prev_stored leaving_stored places holes unbounded sf so si, holes && on = false ->
  let s := Structure v (Parts prev_stored leaving_stored true true places holes unbounded) sf so si in
  rules_of (open_on on) s <->
  is_open_map on (answers (filled (open_on on) s)) /\ open_boundaries (answers (filled (open_on on) s)) true.

(** If lists of inner boundary components are stored, in the plane, the faces are nested, too: open, and closed. *)

Check open_holes_named : forall t places unbounded sf so si,
  let s := Structure t (Parts true true true false places true unbounded) sf so si in
  rules_of (open_on true) s <-> is_open_map true t /\ faces_nested (open_on true) s.

Check open_holes_recorded : forall t places unbounded sf so si,
  let s := Structure t (Parts true true true true places true unbounded) sf so si in
  rules_of (open_on true) s <-> [/\ is_open_map true t, faces_nested (open_on true) s & nested_records t places].

Check filled_open_holes_named : forall v prev_stored leaving_stored places unbounded sf so si,
  let s := Structure v (Parts prev_stored leaving_stored true false places true unbounded) sf so si in let u := filled (open_on true) s in
  rules_of (open_on true) s <-> is_open_map true (answers u) /\ faces_nested (open_on true) u.

Check filled_open_holes_recorded : forall v prev_stored leaving_stored places unbounded sf so si,
  let s := Structure v (Parts prev_stored leaving_stored true true places true unbounded) sf so si in let u := filled (open_on true) s in
  rules_of (open_on true) s <-> [/\ is_open_map true (answers u), faces_nested (open_on true) u & nested_records (answers u) true].

Check holes_named : forall t places unbounded sf so si,
  let s := Structure t (Parts true true true false places true unbounded) sf so si in
  rules_of Expectations.plane s <->
  [/\ is_plane t, faces_nested Expectations.plane s & forall h, half_edge t h -> face_of Expectations.plane s h <> None].

Check holes_recorded : forall t places unbounded sf so si,
  let s := Structure t (Parts true true true true places true unbounded) sf so si in
  rules_of Expectations.plane s <-> [/\ is_plane t, faces_nested Expectations.plane s, nested_records t places
    & forall h, half_edge t h -> boundary_of t h <> None].

Check filled_holes_named : forall v prev_stored leaving_stored places unbounded sf so si,
  let s := Structure v (Parts prev_stored leaving_stored true false places true unbounded) sf so si in let u := filled Expectations.plane s in
  rules_of Expectations.plane s <-> [/\ is_plane (answers u), faces_nested Expectations.plane u
    & forall h, half_edge (answers u) h -> face_of Expectations.plane u h <> None].

Check filled_holes_recorded : forall v prev_stored leaving_stored places unbounded sf so si,
  let s := Structure v (Parts prev_stored leaving_stored true true places true unbounded) sf so si in let u := filled Expectations.plane s in
  rules_of Expectations.plane s <-> [/\ is_plane (answers u), faces_nested Expectations.plane u, nested_records (answers u) true
    & forall h, half_edge (answers u) h -> boundary_of (answers u) h <> None].

(** With every part stored that is a planar subdivision; and nested faces can be put down, one component after another. *)

Check nested_means_subdivision : forall t sf so si, let s := Structure t all_parts sf so si in
  [/\ is_plane t, faces_nested Expectations.plane s, nested_records t true & forall h, half_edge t h -> boundary_of t h <> None] <->
  exists u, represents t u.

Check depth_is_order : forall t (entry : nat -> place -> option start), ExpectationsBorder.open_rules t ->
  (forall f p v, start_vertex t (entry f p) = Some v -> vertex t v) ->
  some_depth t entry <-> exists order, one_after_another t entry order.

Check nested_in_order : forall t unbounded side entry, ExpectationsBorder.open_rules t -> nested t unbounded side entry ->
  exists order, one_after_another t entry order.

(** The rules of meshes are asked for besides the others. *)

Check mesh_rules_apart : forall e s, rules_of e s <-> rules_of (unasked e) s /\ forall m, holds_of e s (Mesh m).

(** A closed structure is an open one in which each half-edge has a twin and, if faces are stored, a face. *)

Check closed_rules : forall t on faces records places holes unbounded sf so si,
  let s := Structure t (Parts true true faces records places holes unbounded) sf so si in
  rules_of (closed_on on) s <-> rules_of (open_on on) s /\ no_border t on faces records places holes unbounded sf so si.

(** T4 follows from the rules before it, under every expectation and whatever is stored. *)

Check t4_follows_of : forall e s, before_t4 e s -> holds_of e s (Basic T4).

Check t4_never_first : forall e s, first_broken_of e s <> Some (Basic T4).

(** After a change it is enough to look at the half-edges that have changed, and at those that led to them. *)

Check near_half_edges : forall t t' (changed : pred nat),
  (forall h, half_edge t h -> Near.fine t h) -> (forall h, ~~ changed h -> Near.same_half_edge t t' h) ->
  (forall h, half_edge t' h -> changed h -> Near.fine t' h) ->
  (forall g h, changed h -> half_edge t g -> ~~ changed g -> twin t g = Some h \/ next t g = Some h -> Near.fine t' g) ->
  (forall v, vertex t v -> ~~ vertex t' v -> bare t' v) ->
  (forall b h, boundary t b -> ~~ boundary t' b -> half_edge t' h -> boundary_of t' h <> Some b) ->
  Map.is_map t' /\ forall h, half_edge t' h -> next t' h >>= boundary_of t' = boundary_of t' h.

(** V2 holds if those that are new around a vertex, or are followed by another one, are on one orbit, and one of them was there
    before if any is left of those before; and so it is with B1 along cycles. *)

Check near_rotations : forall t t', Map.is_map t' ->
  let member := Near.member (half_edge t) (half_edge t') (View.turn t) (View.turn t') (origin t) (origin t') in
  let was_here := was_here (half_edge t) (origin t) (origin t') in
  v2_rotation t ->
  (forall g h, member g -> member h -> origin t' g = origin t' h -> on_orbit (View.turn t') g h) ->
  (forall h m, half_edge t' h -> was_here h -> member m -> origin t' m = origin t' h ->
     exists m', [/\ member m', was_here m' & origin t' m' = origin t' h]) -> v2_rotation t'.

Check near_cycles : forall t t', Map.is_map t' ->
  let member := Near.member (half_edge t) (half_edge t') (next t) (next t') (boundary_of t) (boundary_of t') in
  let was_here := was_here (half_edge t) (boundary_of t) (boundary_of t') in
  one_cycle_each t -> (forall h, half_edge t' h -> next t' h >>= boundary_of t' = boundary_of t' h) ->
  (forall g h, member g -> member h -> boundary_of t' g = boundary_of t' h -> on_cycle t' g h) ->
  (forall h m, half_edge t' h -> was_here h -> member m -> boundary_of t' m = boundary_of t' h ->
     exists m', [/\ member m', was_here m' & boundary_of t' m' = boundary_of t' h]) -> one_cycle_each t'.

Check one_cycle_b1 : forall t, Map.is_map t -> (forall h, half_edge t h -> next t h >>= boundary_of t = boundary_of t h) ->
  b1_cycle t <-> one_cycle_each t /\ forall b, boundary t b ->
    (forall h, half_edge t h -> boundary_of t h = Some b -> exists2 g, boundary_start t b = Some (AtHalfEdge g) & half_edge t g) /\
    forall g, boundary_start t b = Some (AtHalfEdge g) -> half_edge t g -> boundary_of t g = Some b.

(** Walks in step find whether members are on one orbit: what they find is so, and what is so they find, in as many steps as there
    are half-edges. So they decide V2 and B1 after a change, together with the question whether a member was there before. *)

Check on_one_sound : forall (T : eqType) (step : T -> option T) (members : seq T) limit, on_one step members limit -> uniq members ->
  forall g h, g \in members -> h \in members -> exists2 m, m \in members & NearWalks.leads step m g /\ NearWalks.leads step m h.

Check on_one_complete : forall (T : finType) (F : T -> T) (members : seq T), injective F -> uniq members ->
  (forall g h, g \in members -> h \in members -> fconnect F g h) ->
  forall limit, #|T| <= limit -> on_one (fun x => Some (F x)) members limit.

Check near_rotations_walked : forall t t', Map.is_map t' -> forall limit (ms : nat -> seq nat),
  Map.is_map t -> v2_rotation t -> half_edge_slots t' <= limit ->
  let member := Near.member (half_edge t) (half_edge t') (View.turn t) (View.turn t') (origin t) (origin t') in
  (forall v, uniq (ms v) /\ forall h, h \in ms v <-> member h /\ origin t' h = Some v) ->
  v2_rotation t' <-> (forall v, on_one (View.turn t') (ms v) limit) /\
    joins t t' (View.turn t) (View.turn t') (origin t) (origin t').

Check near_cycles_walked : forall t t', Map.is_map t' -> forall limit (ms : nat -> seq nat),
  Map.is_map t -> one_cycle_each t -> (forall h, half_edge t' h -> next t' h >>= boundary_of t' = boundary_of t' h) ->
  half_edge_slots t' <= limit ->
  let member := Near.member (half_edge t) (half_edge t') (next t) (next t') (boundary_of t) (boundary_of t') in
  (forall b, uniq (ms b) /\ forall h, h \in ms b <-> member h /\ boundary_of t' h = Some b) ->
  one_cycle_each t' <-> (forall b, on_one (next t') (ms b) limit) /\ joins t t' (next t) (next t') (boundary_of t) (boundary_of t').

(** The sum V - E + F = 1 + I says that there are as many inner boundary components as components, less the handles. If each
    component has one at least, that is T1 and T3. *)

Check sum_says : forall t, holds_before t T1 -> forall vs es fs cs bs : seq nat,
  lists vs (vertex t) -> lists_one_of_each es (same_edge t) (half_edge t) -> lists fs (face t) ->
  lists_one_of_each cs (connected t) (vertex t) -> lists bs (Rules.is_inner t) ->
  exists g, (g = 0 <-> t3_euler t) /\ (size vs + size fs = 1 + size bs + size es <-> size bs + g = size cs).

Check sum_enough : forall t, holds_before t T1 -> forall vs es fs cs bs : seq nat,
  lists vs (vertex t) -> lists_one_of_each es (same_edge t) (half_edge t) -> lists fs (face t) ->
  lists_one_of_each cs (connected t) (vertex t) -> lists bs (Rules.is_inner t) ->
  (forall v, vertex t v -> exists b, outside_of t v b) ->
  size vs + size fs = 1 + size bs + size es <-> t1_outside t /\ t3_euler t.

(** F2 is a count of each list, if each entry says so itself. *)

Check lists_by_length : forall t,
  (forall b, boundary t b -> exists f p, boundary_face t b = Some f /\ boundary_place t b = Some p) ->
  (forall f i, i < inner_count t f -> exists b,
     [/\ inner t f i = Some b, boundary_face t b = Some f & boundary_place t b = Some (Inner i)]) ->
  (forall f, inner_count t f = count (says_inside t f) (iota 0 (boundary_slots t))) ->
  (forall f b, outer t f = Some b <-> boundary_face t b = Some f /\ boundary_place t b = Some Outer) -> f2_listed t.

(** After a change, what is left to be read of lists are the entries that were written, and those of boundary components that have changed. *)

Check near_lists : forall t t', links_live t -> f2_listed t -> forall (changed written looked : pred nat) (read : nat -> nat -> Prop),
  (forall b, ~~ changed b -> [/\ boundary t' b = boundary t b, boundary_face t' b = boundary_face t b & boundary_place t' b = boundary_place t b]) ->
  (forall f, ~~ written f -> outer t' f = outer t f) ->
  (forall f i, i < inner_count t' f -> read f i \/ i < inner_count t f /\ inner t' f i = inner t f i) ->
  (forall f b, written f -> outer t f = Some b -> changed b) ->
  (forall b f, changed b -> boundary_face t b = Some f -> looked f) -> (forall f, written f -> looked f) ->
  (forall b f i, changed b -> boundary_face t b = Some f -> boundary_place t b = Some (Inner i) -> read f i) ->
  links_live t' ->
  f2_listed t' <-> [/\ changed_right t' changed, looked_right t' looked, read_right t' read & lengths_right t t' changed].

(** The rules mean planar subdivisions. *)

Check rules_mean_subdivision : forall t, rules t <-> exists s, represents t s.

Check checker_means_subdivision : forall t, first_broken t = None <-> exists s, represents t s.

(** Euler's formula: for what is drawn edge by edge, in whatever order; for a component; for the whole. *)

Check euler : forall (dart : finType) (turn : {perm dart}) (twin : dart -> dart),
  involutive twin -> (forall x, twin x != x) -> forall edges,
  #|porbits turn| + #|porbits (walk turn twin edges)| + (handles turn twin edges).*2
  = size edges + (n_comp (link_of turn twin edges) dart).*2.

Check genus : forall (dart : finType) (turn : {perm dart}) (twin : dart -> dart),
  involutive twin -> (forall x, twin x != x) -> forall edges edges',
  every_edge twin edges -> every_edge twin edges' -> handles turn twin edges = handles turn twin edges'.

Check component_euler : forall t v V E cycles, holds_before t T1 -> vertex t v -> has_counts t v V E cycles ->
  exists g, V + cycles + 2 * g = 2 + E.

Check map_euler : forall t V E F cs, holds_before t T2 -> map_has_counts t V E F ->
  lists_one_of_each cs (connected t) (vertex t) ->
  (exists g, V + F + 2 * g = 1 + size cs + E) /\ (t3_euler t <-> V + F = 1 + size cs + E).

Check component_counts_exist : forall t v, holds_before t T1 -> vertex t v ->
  exists V E cycles, has_counts t v V E cycles.

Check map_counts_exist : forall t, holds_before t T1 -> exists V E F, map_has_counts t V E F.

(** T4 follows from the rules before it. *)

Check t4_follows : forall t, holds_before t T4 -> t4_bounds t.

(** Sets of connected vertices are the components if there are as few as Euler's formula allows, and if every edge was used. *)

Check few_sets_are_components : forall t, holds_before t T1 -> forall number, within t number ->
  vertices_and_cycles t = edge_number t + (sets t number).*2 -> whole t number /\ t3_euler t.

Check all_edges_are_enough : forall t, holds_before t T1 -> forall number,
  (forall u v, (u, v) \in edge_ends t -> number u = number v) -> whole t number.

(** The fast path accepts exactly the views that keep R1 to T1, and T3; only T2 is left. *)

Check fast_path_accepts : forall t, fast_path t <-> holds_before t T2 /\ t3_euler t.

Check fast_path_leaves_t2 : forall t, rules t <-> fast_path t /\ t2_nesting t.

(** A table that is accepted with some ranks keeps all rules, and whatever keeps all rules has ranks with which it is accepted. *)

Check labels_sound : forall t rank, accepts t rank -> rules t.

(** A checker that only decides needs fewer tests: the others follow. *)

Check few_suffice : forall t rank, few_accept t rank -> accepts t rank.

Check prev_back : forall t, (forall h, half_edge t h -> next t h >>= prev t = Some h) -> forall h, half_edge t h -> next_ok t h.

Check labels_complete : forall t, rules t -> exists rank, accepts t rank.

Check labels_mean_subdivision : forall t, (exists rank, accepts t rank) <-> exists s, represents t s.

(** If vertices and half-edges are all that is stored, the rules of closed surfaces mean rotation systems. *)

Check surface_rules_mean_rotations : forall t, surface_rules t <-> exists s, represents_rotations t s.

(** Surfaces, whose genera add up to [genus]; some of their faces may be holes, which are their border. *)

Check surface_sound : forall t position step component rank border genus,
  surface_accepts t position step component rank border genus ->
  [/\ Map.is_map t, v1_leaving t, v2_rotation t, b1_cycle t
    & exists vs cs es ps, [/\ lists_one_of_each vs (on_orbit (View.turn t)) (half_edge t), lists_one_of_each cs (on_cycle t) (half_edge t),
        lists_one_of_each es (same_edge t) (half_edge t), lists_one_of_each ps (LoopsProof.reached (near t)) (half_edge t)
        & size ps = component_count t component /\ size vs + size cs + genus.*2 = size es + (component_count t component).*2]].

Check surface_border_sound : forall t position step component rank border genus,
  surface_accepts t position step component rank border genus ->
  [/\ forall f, face t f -> exists2 b, outer t f = Some b & boundary_face t b = Some f,
      forall b f, boundary_face t b = Some f -> outer t f = Some b,
      forall g h, half_edge t g -> half_edge t h -> in_hole t g -> in_hole t h -> origin t g = origin t h -> g = h
    & forall h g, in_hole t h -> twin t h = Some g -> ~~ in_hole t g].

Check surface_holes_sound : forall t position step component rank border genus,
  surface_accepts t position step component rank border genus ->
  exists hs, lists_one_of_each hs (on_cycle t) (fun h => half_edge t h /\ in_hole t h) /\ size hs = hole_count t.

(** A view is a surface if and only if it has a certificate; where nothing but vertices and half-edges is stored, if and only if it
    has one when its cycles have got faces. *)

Check surface_certificate : forall t,
  is_surface t <-> exists position step component rank border genus, surface_accepts t position step component rank border genus.

Check rotations_certificate : forall t,
  surface_rules t <-> exists position step component rank border genus, surface_accepts (with_faces t) position step component rank border genus.

(** The same of what is in a folder with the verdict "valid", and the genus, components and holes that are printed. *)

Check valid_is_surface : forall o, judge_surface o = Valid -> let t := surface_view_in o in
  [/\ Map.is_map t, v1_leaving t, v2_rotation t, b1_cycle t
    & exists vs cs es ps, [/\ lists_one_of_each vs (on_orbit (View.turn t)) (half_edge t), lists_one_of_each cs (on_cycle t) (half_edge t),
        lists_one_of_each es (same_edge t) (half_edge t), lists_one_of_each ps (LoopsProof.reached (near t)) (half_edge t)
        & size ps = surface_components o /\ size vs + size cs + (surface_genus o).*2 = size es + (surface_components o).*2]].

Check valid_has_border : forall o, judge_surface o = Valid -> let t := surface_view_in o in
  [/\ forall f, face t f -> exists2 b, outer t f = Some b & boundary_face t b = Some f,
      forall b f, boundary_face t b = Some f -> outer t f = Some b,
      forall g h, half_edge t g -> half_edge t h -> in_hole t g -> in_hole t h -> origin t g = origin t h -> g = h
    & forall h g, in_hole t h -> twin t h = Some g -> ~~ in_hole t g].

Check valid_has_holes : forall o, judge_surface o = Valid -> let t := surface_view_in o in
  exists hs, lists_one_of_each hs (on_cycle t) (fun h => half_edge t h /\ in_hole t h) /\ size hs = surface_holes o.

(** A table in a folder with the verdict "valid" keeps all rules, and represents a planar subdivision. *)

Check valid_is_plane : forall o, judge o = Valid -> rules (view_in o) /\ exists s, represents (view_in o) s.

(** Adding an isolated vertex to a face keeps all rules. *)

Check add_isolated_vertex_keeps_rules : forall t v b f, ~~ vertex t v -> ~~ boundary t b -> face t f ->
  rules t -> rules (add_isolated_vertex t v b f).

(** So does removing one. *)

Check remove_isolated_vertex_keeps_rules : forall t v b, isolated t v = Some b ->
  rules t -> rules (remove_isolated_vertex t v b).

(** Moving an inner boundary component keeps all rules exactly if its new face is not inside its component. *)

Check move_inner_keeps_rules : forall t b f g, rules t -> boundary_face t b = Some f ->
  boundary_place t b = Some (Inner (inner_count t f).-1) -> face t g -> g != f ->
  rules (move_inner t b f g) <-> ~ inside t b g.

(** A search tells if it is inside: across edges, and through all that lies in the faces that are met. *)

Check met_inside_faces : forall t b, rules t -> Rules.is_inner t b -> forall h,
  inside t b h <-> exists2 c, met t b c & outer t h = Some c.

Check move_inner_searched : forall t b f g, rules t -> boundary_face t b = Some f ->
  boundary_place t b = Some (Inner (inner_count t f).-1) -> face t g -> g != f ->
  rules (move_inner t b f g) <-> ~ exists2 c, met t b c & outer t g = Some c.

(** Wherever it is listed: it changes places with the last one of its list first, which keeps all rules. *)

Check move_any_inner_keeps_rules : forall t b f i g, rules t -> boundary_face t b = Some f ->
  boundary_place t b = Some (Inner i) -> face t g -> g != f ->
  rules (move_inner (exchange t f i (inner_count t f).-1) b f g) <-> ~ inside t b g.

(** The core of a table is what an operator decides; the rest says the same once more. If the core is right and the rest says so,
    or is made anew, all rules hold; and where all rules hold, the core is right. *)

Check core_rules : forall t inn, Core.core t inn -> Core.rest t inn -> rules t.

Check core_of_rules : forall t, rules t -> Core.core t (Core.inn_of t).

Check tidy_rules : forall n inn, Core.core n inn -> rules (Tidy.tidy n inn).

(** A table that keeps the rules keeps them under other numbers. *)

Check renaming_keeps : forall t t' rv rd rb rf rp, renaming t t' rv rd rb rf rp -> rules t -> rules t'.

(** The choice of the half-edge that a vertex or a boundary component keeps does not matter. *)

Check keep_others_keeps_rules : forall t leaves starts, rules t -> rules (keep_others t leaves starts).

(** Attaching a new vertex to an isolated one keeps all rules; so does connecting two isolated vertices, or a corner to one. *)

Check attach_to_isolated_keeps_rules : forall t o v b h k, isolated t o = Some b ->
  ~~ vertex t v -> ~~ half_edge t h -> ~~ half_edge t k -> h != k ->
  rules t -> rules (attach_to_isolated t o v b h k).

Check connect_two_isolated_keeps_rules : forall t o v b d h k, isolated t o = Some b -> isolated t v = Some d -> o != v ->
  ~~ half_edge t h -> ~~ half_edge t k -> h != k -> rules t -> rules (connect_two_isolated t o v b d h k).

Check connect_isolated_keeps_rules : forall t a v b h k, half_edge t a -> isolated t v = Some b ->
  ~~ half_edge t h -> ~~ half_edge t k -> h != k -> rules t -> rules (connect_isolated t a v b h k).

(** Connecting two cycles of a face keeps all rules, whichever of the two boundary components is kept. *)

Check bridge_keeps_rules : forall t a b h k f kept dropped,
  boundary_of t a = Some kept /\ boundary_of t b = Some dropped \/
  boundary_of t a = Some dropped /\ boundary_of t b = Some kept ->
  kept <> dropped -> boundary_face t kept = Some f -> boundary_face t dropped = Some f ->
  ~~ half_edge t h -> ~~ half_edge t k -> h != k ->
  rules t -> rules (bridge t a b h k f kept dropped).

(** Connecting two corners of one cycle keeps all rules, whichever of the two cycles is new, bounds the new face, and
    whatever goes there. *)

Check split_face_keeps_rules : forall t a b h k f g kept made made_left new_left moved,
  boundary_of t a = Some kept -> boundary_of t b = Some kept -> boundary_face t kept = Some f ->
  ~~ half_edge t h -> ~~ half_edge t k -> h != k -> ~~ boundary t made -> ~~ face t g ->
  rules t -> rules (split_face t a b h k f g kept made made_left new_left moved).

(** So does a loop at an isolated vertex. *)

Check loop_at_isolated_keeps_rules : forall t v h k f g kept made made_left new_left moved,
  isolated t v = Some kept -> boundary_face t kept = Some f ->
  ~~ half_edge t h -> ~~ half_edge t k -> h != k -> ~~ boundary t made -> ~~ face t g ->
  rules t -> rules (loop_at_isolated t v h k f g kept made made_left new_left moved).

(** Splitting a vertex keeps all rules, and so does contracting an edge that is no loop. *)

Check split_vertex_keeps_rules : forall t a b v h k, is_splittable t a b v h k -> rules t -> rules (split_vertex t a b v h k).

Check contract_edge_keeps_rules : forall t n m kept dropped, is_contractible t n m kept dropped ->
  rules t -> rules (contract_edge t n m kept dropped).

(** So does removing an edge with different boundary components on both sides: the two faces become one. *)

Check merge_faces_keeps_rules : forall t n m f g kept dropped, is_seam t n m f g kept dropped ->
  rules t -> rules (merge_faces t n m f g kept dropped).

(** So does removing an edge with the same one on both sides: the component falls into two. *)

Check part_component_keeps_rules : forall t n m f kept made at_n at_m stays bo way,
  is_bridge t n m f kept made at_n at_m stays bo way ->
  rules t -> rules (part_component t n m f kept made at_n at_m stays).

(** The part that keeps the outside is found by a search from either end, through outer cycles: one of them meets what is no outer one, and
    whichever does, the edge can be removed with that answer. *)

Check search_complete : forall t, rules t -> forall (a : Map.dart t) cut, Map.bnd a = cut -> Map.bnd (Map.tw a) = cut ->
  SearchOutside.is_outer t cut -> finds cut a || finds cut (Map.tw a).

Check search_keeps_rules : forall t, rules t -> forall (a : Map.dart t) cut, Map.bnd a = cut -> Map.bnd (Map.tw a) = cut ->
  SearchOutside.is_outer t cut -> forall f made at_n at_m (s : Map.dart t),
  boundary_face t cut = Some f -> ~~ boundary t made -> at_n = cut /\ at_m = made \/ at_n = made /\ at_m = cut ->
  SearchOutside.is_end a s -> finds cut s ->
  rules (part_component t (LoopsProof.num a) (LoopsProof.num (Map.tw a)) f cut made at_n at_m (if s == a then at_n else at_m)).

(** So does flipping an edge, and putting it anywhere between the corners of its two cycles. *)

Check flip_edge_keeps_rules : forall t n m f g kept dropped a b new_left moved, is_flip t n m f g kept dropped a b ->
  rules t -> rules (flip_edge t n m f g kept dropped a b new_left moved).

(** So does a program of these operators, whatever their arguments and their order; it makes subdivisions of subdivisions. *)

Check step_keeps_rules : forall t t', Programs.step t t' -> rules t -> rules t'.

Check program_keeps_rules : forall t t', program t t' -> rules t -> rules t'.

(** An operation, an operator with its arguments as data, is such a step if its arguments pass a test, and is refused otherwise.
    Whatever the operations and their arguments: all rules hold after them. [Operate.v] is run beside the Rust code. *)

Check operation_is_step : forall t o, rules t -> Operate.is_right t o -> Programs.step t (Operate.after t o).

Check refused_changes_nothing : forall t o, ~~ Operate.is_right t o -> Operate.operate t o = t.

Check operate_keeps_rules : forall t o, rules t -> rules (Operate.operate t o).

Check operate_all_keeps_rules : forall t os, rules t -> rules (foldl Operate.operate t os).

(** A program makes subdivisions of subdivisions. *)

Check program_makes_subdivision : forall t t', program t t' -> (exists s, represents t s) -> exists s, represents t' s.

(** Of nothing, programs make the planar subdivisions: all, and no other. *)

Check rules_are_made : forall t, rules t -> program nothing t.

Check programs_make_subdivisions : forall t, program nothing t <-> exists s, represents t s.

(** Positive triangles inside a negative one are drawn without crossings: at every rational point p / k. *)

Check triangulation_is_plane : forall (dart : finType) (twin next : dart -> dart) (inner : pred dart) (pt : dart -> point),
  triangulation twin next inner pt -> forall k, (0 < k)%Z -> let at_scale d := scaled k (pt d) in
  [/\ forall p d e, on_edge next at_scale p d -> on_edge next at_scale p e -> e = d \/ e = twin d,
      forall x e, ~ on_edge next at_scale (at_scale x) e,
      forall x y, at_scale x = at_scale y <-> fconnect (Plane.turn twin next) x y,
      forall p d e, inner d -> inner e -> in_triangle next at_scale p d -> in_triangle next at_scale p e ->
        e \in [:: d; next d; next (next d)]
    & forall p o, ~~ inner o -> (in_outer next inner at_scale p -> exists2 d, inner d & in_closed_triangle next at_scale p d) /\
        (forall d, inner d -> in_triangle next at_scale p d -> (orient (at_scale o) (at_scale (next o)) p <= 0)%Z)].

(** And around each vertex the darts are in angular order. *)

Check angular_order : forall (dart : finType) (twin next : dart -> dart) (inner : pred dart) (pt : dart -> point),
  triangulation twin next inner pt -> forall x y, inner x -> pt x = pt y ->
  ~ ((0 < cross (edge next pt x) (edge next pt y))%Z /\ (0 < cross (edge next pt y) (edge next pt (Plane.turn twin next x)))%Z).

(** A table in a folder with the claim "drawing" and the verdict "valid" keeps all rules, and is drawn without crossings: at
    each rational point p / k there is at most one edge, and no vertex if there is an edge. *)

Check valid_is_drawn : forall o, judge_drawing o = Valid -> let t := view_in (topology o) in let at_ := point_in o in
  let on k p h := exists u w, [/\ origin t h = Some u, target t h = Some w & strictly_between (scaled k (at_ u)) (scaled k (at_ w)) p] in
  [/\ rules t,
      forall k p g h, (0 < k)%Z -> half_edge t g -> half_edge t h -> on k p g -> on k p h -> h = g \/ twin t g = Some h,
      forall k v h, (0 < k)%Z -> vertex t v -> half_edge t h -> ~ on k (scaled k (at_ v)) h,
      forall u v, vertex t u -> vertex t v -> at_ u = at_ v -> u = v
    & forall h u w, half_edge t h -> origin t h = Some u -> target t h = Some w -> at_ u <> at_ w].

(** Its half-edges are in the order of the darts around each vertex, and its faces are the regions between the edges. *)

Check drawn_rotation : forall t r, drawn t r -> forall h g, half_edge t h -> prev t h >>= twin t = Some g ->
  exists (x : dart_type r) n, [/\ val x = half_edge_dart r h,
      val (iter n.+1 (Plane.turn (@tw_dart r) (@nx_dart r)) x) = half_edge_dart r g
    & forall m, m < n -> dart_half_edge r (iter m.+1 (Plane.turn (@tw_dart r) (@nx_dart r)) x) = None].

Check drawn_faces : forall t r, drawn t r -> forall x y : dart_type r, same_region x y <-> dart_face r x = dart_face r y.

Check drawn_half_edge_face : forall t r, drawn t r -> forall h, half_edge t h -> exists2 x : dart_type r,
  val x = half_edge_dart r h & boundary_of t h >>= boundary_face t = Some (dart_face r x).

Check drawn_isolated_face : forall t r, drawn t r -> forall v b, vertex t v -> isolated t v = Some b ->
  exists2 x : dart_type r, dart_point r x = v & boundary_face t b = Some (dart_face r x).

(** Summaries of tiles: merging gives the summary of both together. It is commutative and, as a border has two sides, associative;
    however the same tiles are merged, the result is the same. *)

Check merge_is_union : forall A B, two_sided (A ++ B) -> same (merge (summarize A) (summarize B)) (summarize (A ++ B)).

Check merge_commutes : forall a b, same (merge a b) (merge b a).

Check merge_associates : forall u v w, two_sided (contacts u ++ contacts v ++ contacts w) ->
  same (merge (result u) (merge (result v) (result w))) (merge (merge (result u) (result v)) (result w)).

Check merge_nothing : forall w, two_sided (contacts w) -> same (merge (result w) (summarize [::])) (result w).

Check merged_anyhow : forall v w, two_sided (contacts v) -> perm_eq (contacts v) (contacts w) -> same (result v) (result w).
