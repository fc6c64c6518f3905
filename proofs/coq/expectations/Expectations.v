(** * Expectations: the rules of every expectation (expectation.rs, and all sentences of reference/rules.rs)

    Rules.v has the rules of one expectation, the closed plane, of structures that store every part. Here are those of all:
    on the plane or on surfaces of any genus, closed or with open boundaries, whichever parts are stored, and with the rules
    M1 to M8 of meshes, which are asked for one by one. ExpectationsPlane.v proves that they agree with Rules.v.

<<
      open boundary, in two ways:   ──h──►              h has no twin
                                    ──h──►
                                    ◄──k──              k, the twin of h, has no face
>>
*)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import View Rules Loops Reference.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** ** Expectations, and structures with parts *)

(** `Parts`. A part that needs another counts only if that one is stored, too: [has_holes] and the like below. *)
Record parts := Parts {
  prev_part : bool;
  leaving_part : bool;
  faces_part : bool;
  boundaries_part : bool;
  places_part : bool;
  holes_part : bool;
  unbounded_part : bool
}.

Definition all_parts := Parts true true true true true true true.

(** `Expectation`. A rule that is asked for with a number has that number. *)
Record expectation := Expectation {
  on_plane : bool;
  is_open : bool;
  no_unused_vertices : bool;
  no_loops_nor_parallels : bool;
  sides_asked : option nat;
  without_border : bool;
  components_asked : option nat;
  borders_asked : option nat;
  genus_asked : option nat;
  border_kept : bool
}.

(** `Expectation::plane()` and `Expectation::surface()`. *)
Definition plane := Expectation true false false false None false None None None false.
Definition surface := Expectation false false false false None false None None None false.

(** The trait `View`, with the answers of structures that lack records for boundary components: the face that a half-edge
    names, and where the boundary components of a face start. *)
Record structure := Structure {
  answers : view;
  stored : parts;
  says_face : nat -> link;
  says_outer_half_edge : nat -> link;
  says_inner_start : nat -> nat -> option start
}.

(** A walk along [step] leads to these. *)
Inductive walks (step : nat -> nat -> Prop) x : nat -> Prop :=
  | walks_nowhere : walks step x x
  | walks_on y z : walks step x y -> step y z -> walks step x z.

(** Things of one kind are counted by the one with the least number. *)
Definition least (same : nat -> nat -> Prop) x := forall y, y < x -> ~ same x y.

Section Rules.
Variables (e : expectation) (s : structure).

(** ** The parts that are looked at *)

Definition has_faces := faces_part (stored s).
Definition has_records := has_faces && boundaries_part (stored s).
Definition has_places := has_records && places_part (stored s).
Definition has_holes := [&& has_faces, holes_part (stored s) & on_plane e].
Definition has_unbounded := has_holes && unbounded_part (stored s).
Definition has_prev := prev_part (stored s).
Definition has_leaving := leaving_part (stored s).

(** The half-edge before [h], where `prev` is not stored: the first whose next is [h]. *)
Definition before h : link := let v := answers s in
  ohead [seq g <- iota 0 (half_edge_slots v) | half_edge v g && same_link (next v g) (Some h)].

(** The structure without the answers that are not looked at. *)
Definition seen : view := let v := answers s in {|
  vertex_slots := vertex_slots v;
  half_edge_slots := half_edge_slots v;
  boundary_slots := if has_records then boundary_slots v else 0;
  face_slots := if has_faces then face_slots v else 0;
  is_vertex := is_vertex v;
  is_half_edge := is_half_edge v;
  is_boundary := is_boundary v;
  is_face := is_face v;
  says_origin := says_origin v;
  says_twin := says_twin v;
  says_next := says_next v;
  says_prev := fun h => if has_prev then says_prev v h else before h;
  says_boundary := fun h => if has_records then says_boundary v h else None;
  says_leaving := fun w => if has_leaving then says_leaving v w else None;
  says_isolated := fun w => if has_records && has_holes then says_isolated v w else None;
  says_boundary_face := says_boundary_face v;
  says_boundary_start := says_boundary_start v;
  says_boundary_place := says_boundary_place v;
  says_outer := fun f => if has_records then says_outer v f else None;
  says_inner_count := fun f => if has_holes then says_inner_count v f else 0;
  says_inner := fun f i => if has_records then says_inner v f i else None
|}.

Notation t := seen.

(** The boundary component that the half-edge names, or its face where there are no records for boundary components. *)
Definition side h : link := if has_records then boundary_of t h else heard (half_edge t) (says_face s) h.
Definition is_side i := if has_records then boundary t i else face t i.

(** The face that the half-edge bounds. *)
Definition face_of h : link := if has_records then side h >>= boundary_face t else if has_faces then side h else None.
Definition lacks_face h := has_faces && is_nil (side h).

(** The half-edge legally has no twin. *)
Definition on_border h := is_open e && is_nil (twin t h).

(** The vertex at which the half-edge ends. *)
Definition end_of h : link := if on_border h then next t h >>= origin t else target t h.

(** An entry is a face and a place in its list; this is where the boundary component starts that is listed there. *)
Definition entry_start (f : nat) (p : place) : option start :=
  if has_records then listed t f p >>= boundary_start t else
  match p with
  | Outer => omap AtHalfEdge (heard (face t) (says_outer_half_edge s) f)
  | Inner i => if i < inner_count t f then says_inner_start s f i else None
  end.

(** The face has an outer boundary component. *)
Definition has_outer f := if has_records then ~~ is_nil (outer t f) else
  ~~ is_nil (heard (face t) (says_outer_half_edge s) f).

Definition vertex_of (st : option start) : link :=
  match st with Some (AtHalfEdge h) => origin t h | Some (AtVertex v) => Some v | None => None end.

(** ** R1 live *)

Definition half_edge_live h :=
  [/\ leads_to (vertex t) (origin t h), leads_to (half_edge t) (twin t h) \/ on_border h,
      leads_to (half_edge t) (next t h), (has_prev -> leads_to (half_edge t) (prev t h))
    & has_faces -> leads_to is_side (side h) \/ [/\ is_open e, twin t h <> None & side h = None]].
Definition vertex_live v :=
  (has_leaving -> leads_to (half_edge t) (leaving t v) \/ leaving t v = None /\ bare t v) /\
  nil_or_leads_to (boundary t) (isolated t v).
Definition boundary_live b := leads_to (face t) (boundary_face t b) /\ starts_live t (boundary_start t b).
Definition face_live f :=
  (has_outer f -> if has_records then leads_to (boundary t) (outer t f) else starts_live t (entry_start f Outer)) /\
  forall i, i < inner_count t f ->
    if has_records then leads_to (boundary t) (inner t f i) else starts_live t (entry_start f (Inner i)).

(** The lists of the faces are short. Without records for boundary components, vertices and half-edges count. *)
Definition is_listable := if has_records then count (boundary t) (iota 0 (boundary_slots t)) else
  count (half_edge t) (iota 0 (half_edge_slots t)) + count (vertex t) (iota 0 (vertex_slots t)).
Definition short := sumn [seq inner_count t f | f <- iota 0 (face_slots t)] <= 2 * is_listable + 16.

Definition r1 :=
  [/\ forall h, half_edge t h -> half_edge_live h, forall v, vertex t v -> vertex_live v,
      forall b, boundary t b -> boundary_live b, forall f, face t f -> face_live f & short].

(** ** L1 to V2 *)

Definition l1 := forall h, half_edge t h -> ~~ on_border h -> twin t h >>= twin t = Some h /\ twin t h <> Some h.

(** Without `prev`: no two half-edges have the same next. *)
Definition l2 := if has_prev then l2_next_prev t else
  forall g h, half_edge t g -> half_edge t h -> next t g = next t h -> g = h.

Definition l3 := forall h, half_edge t h -> ~~ on_border h -> next t h >>= origin t = twin t h >>= origin t.

(** Around a vertex one turns clockwise, and, as that may end at an open boundary, counter-clockwise. *)
Definition turn_back h : link := prev t h >>= twin t.
Definition v2 := forall g h, half_edge t g -> half_edge t h ->
  (on_orbit (turn t) g h \/ is_open e /\ on_orbit turn_back g h <-> origin t g = origin t h).

(** ** B1 and B2 *)

(** Without records for boundary components: the face is constant along `next`, and a face lists half-edges of its own. *)
Definition b1 :=
  (has_faces -> forall h, half_edge t h -> next t h >>= side = side h) /\
  if has_records then
    forall b h, boundary t b -> half_edge t h ->
      (boundary_of t h = Some b <-> exists2 g, boundary_start t b = Some (AtHalfEdge g) & on_cycle t g h)
  else forall f p h, entry_start f p = Some (AtHalfEdge h) -> side h = Some f.

(** Exactly one, or none where that is legal. *)
Definition one_or_none A (P : A -> Prop) (legal : Prop) := (exists! x, P x) \/ legal /\ forall x, ~ P x.

(** The list of a face has an isolated vertex. *)
Definition lists_vertex v (entry : nat * place) := entry_start entry.1 entry.2 = Some (AtVertex v).

(** Without a record of the unbounded face, an isolated vertex may lie there, where no boundary component starts. *)
Definition b2_of v :=
  if has_records then
    (bare t v -> one_or_none (starts_at_vertex t v) (~~ has_unbounded)) /\
    (~ bare t v -> forall b, ~ starts_at_vertex t v b) /\
    forall b, isolated t v = Some b <-> starts_at_vertex t v b
  else
    (bare t v -> one_or_none (lists_vertex v) (~~ has_unbounded)) /\
    (~ bare t v -> forall entry, ~ lists_vertex v entry).
Definition b2 := has_holes -> forall v, vertex t v -> b2_of v.

(** ** F1 and F2 *)

Definition is_unbounded f := face t f /\ ~~ has_outer f.
Definition f1 := has_faces ->
  (if has_unbounded then exists! f, is_unbounded f else forall f, ~ is_unbounded f) /\
  forall f v, entry_start f Outer <> Some (AtVertex v).

(** The list of a face has a half-edge of the cycle of [h]. *)
Definition lists_cycle h (entry : nat * place) :=
  exists2 g, entry_start entry.1 entry.2 = Some (AtHalfEdge g) & on_cycle t h g.

(** Without records for boundary components: every cycle that has a face is listed exactly once, one that has none at most once
    (and then B1 is broken). *)
Definition f2 :=
  if has_records then
    forall b, boundary t b -> exists f p, [/\ boundary_face t b = Some f, (has_places -> boundary_place t b = Some p)
      & forall f' p', listed t f' p' = Some b <-> f' = f /\ p' = p]
  else has_faces -> forall h, half_edge t h -> one_or_none (lists_cycle h) (side h = None).

(** ** T1 to T4 *)

(** An edge leads from [u] to [w]. *)
Definition edge_step u w := exists2 h, origin t h = Some u & end_of h = Some w.
Definition linked := walks edge_step.

(** The half-edges of the component of [v]. *)
Definition of_component v h := exists2 w, origin t h = Some w & linked v w.

(** The component of [v] has an open boundary. *)
Definition opens v := exists2 h, of_component v h & on_border h || lacks_face h.

(** The entry is an inner boundary component of the component of [v]. *)
Definition outside_entry v (entry : nat * place) := entry.2 <> Outer /\
  exists2 w, vertex_of (entry_start entry.1 entry.2) = Some w & linked v w.

Definition t1 := has_holes -> forall v, vertex t v ->
  one_or_none (outside_entry v) (~~ has_unbounded \/ opens v).

(** The component of [v] lies in a face that is bounded by the component of [w]. *)
Definition lies_in v w := exists2 entry, outside_entry v entry & vertex_of (entry_start entry.1 Outer) = Some w.

(** No component lies, through others, inside itself. *)
Definition t2 := has_holes -> forall v u w, vertex t v -> lies_in v u -> walks lies_in u w -> ~ linked w v.

(** Along an open boundary whose half-edges have no twins, [h] follows [g]. *)
Definition follows g h := on_border h /\ exists2 u, end_of g = Some u & origin t h = Some u.
Definition least_on_border h := on_border h /\ least (walks follows) h.

(** The component of [v] has so many vertices, edges, and cycles and borders. An isolated vertex counts as a cycle. *)
Definition counts_of v V E cycles := exists vs es cs bs,
  [/\ lists vs (linked v), lists es (fun h => of_component v h /\ least (same_edge t) h),
      lists cs (fun h => of_component v h /\ least (on_cycle t) h), lists bs (fun h => of_component v h /\ least_on_border h)
    & [/\ V = size vs, E = size es & cycles = size cs + size bs + (es == [::])]].

Definition t3 := forall v, vertex t v -> exists V E cycles,
  counts_of v V E cycles /\ exists2 g, V + cycles + 2 * g = 2 + E & on_plane e -> g = 0.

(** No edge is a loop, and no two join the same vertices. *)
Definition simple_of := forall g u w, origin t g = Some u -> end_of g = Some w ->
  u <> w /\ forall h, origin t h = Some u /\ end_of h = Some w \/ origin t h = Some w /\ end_of h = Some u -> same_edge t g h.

Definition t4 := on_plane e -> simple_of -> forall vs es fs,
  lists vs (vertex t) -> lists es (fun h => half_edge t h /\ least (same_edge t) h) -> lists fs (face t) -> 3 <= size vs ->
  size es + 6 <= 3 * size vs /\ size fs + 4 <= 2 * size vs.

(** ** M1 to M8 *)

Definition asked (number : option nat) (P : nat -> Prop) := if number is Some n then P n else True.

Definition m1 := no_unused_vertices e -> forall v, vertex t v -> exists h, origin t h = Some v.
Definition m2 := no_loops_nor_parallels e -> simple_of.

(** The sides of a face are the half-edges that bound it. Without faces, each cycle is one. *)
Definition m3 := asked (sides_asked e) (fun n =>
  if has_faces then forall f, face t f -> has_outer f -> exists2 hs, lists hs (fun h => face_of h = Some f) & size hs = n
  else forall h, half_edge t h -> exists2 hs, lists hs (on_cycle t h) & size hs = n).

Definition m4 := without_border e -> forall h, half_edge t h -> twin t h <> None /\ ~~ lacks_face h.

Definition m5 := asked (components_asked e) (fun n =>
  exists2 vs, lists vs (fun v => [/\ vertex t v, least linked v & exists h, of_component v h]) & size vs = n).

(** A border loop is a cycle without face, or half-edges without twin that follow one another. *)
Definition m6 := asked (borders_asked e) (fun n => exists cs bs,
  [/\ lists cs (fun h => [/\ half_edge t h, lacks_face h & least (on_cycle t) h]),
      lists bs (fun h => half_edge t h /\ least_on_border h) & size cs + size bs = n]).

Definition m7 := asked (genus_asked e) (fun n => exists vs genus,
  [/\ lists vs (fun v => vertex t v /\ least linked v),
      (forall v, v \in vs -> exists V E cycles, counts_of v V E cycles /\ V + cycles + 2 * genus v = 2 + E)
    & sumn [seq genus v | v <- vs] = n]).

(** The half-edge lacks a twin or a face. *)
Definition at_border h := is_nil (twin t h) || lacks_face h.
Definition m8 := border_kept e -> has_leaving -> forall v h, origin t h = Some v -> at_border h ->
  if leaving t v is Some g then at_border g else true.

End Rules.

(** ** The ladder *)

Inductive mesh_rule := M1 | M2 | M3 | M4 | M5 | M6 | M7 | M8.
Inductive any_rule := Basic of rule | Mesh of mesh_rule.

Definition holds_of e s (r : any_rule) : Prop :=
  match r with
  | Basic R1 => r1 e s | Basic L1 => l1 e s | Basic L2 => l2 e s | Basic L3 => l3 e s
  | Basic V1 => v1_leaving (seen e s) | Basic V2 => v2 e s
  | Basic B1 => b1 e s | Basic B2 => b2 e s | Basic F1 => f1 e s | Basic F2 => f2 e s
  | Basic T1 => t1 e s | Basic T2 => t2 e s | Basic T3 => t3 e s | Basic T4 => t4 e s
  | Mesh M1 => m1 e s | Mesh M2 => m2 e s | Mesh M3 => m3 e s | Mesh M4 => m4 e s
  | Mesh M5 => m5 e s | Mesh M6 => m6 e s | Mesh M7 => m7 e s | Mesh M8 => m8 e s
  end.

(** The rules in the order of `Rule::ALL`, and the position of each. *)
Definition ladder := map Basic [:: R1; L1; L2; L3; V1; V2; B1; B2; F1; F2; T1; T2; T3; T4]
  ++ map Mesh [:: M1; M2; M3; M4; M5; M6; M7; M8].

Definition position (r : any_rule) : nat :=
  match r with
  | Basic r => index r
  | Mesh m => 14 + match m with M1 => 0 | M2 => 1 | M3 => 2 | M4 => 3 | M5 => 4 | M6 => 5 | M7 => 6 | M8 => 7 end
  end.

Definition rules_of e s := forall r, holds_of e s r.
