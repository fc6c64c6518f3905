(* Reads what operators of `Dcel` did, one a line, and holds each against the operator that is proved.

     operate < steps

   A line: the operator with its arguments, the table before, and the table after, with semicolons between them, as
   crates/trials/examples/steps.rs prints it.

     connect v0 v1 left = h0 ; V 2 - 0 - 1 H 0 B 2 0 v0 i0 0 v1 i1 F 1 - 2 0 1 ; V 2 0 - 1 - H 2 0 1 1 1 1 1 0 0 0 1 B 2 x 0 h0 i0 F 1 - 1 1

   The arguments that the proved operator has beside these, such as free slots and which of two cycles is relabelled, are
   taken from the table after. Some operators of `Dcel` are several operations, and some keep other half-edges than the proved one
   does (Keep.v). The arguments of each operation must be right (is_right), all rules must hold before, and the view after the last
   one must be the table after: all links of all records. The lists of inner boundary components may have another order, and
   where it is said two vertices may have exchanged their numbers (Renaming.v).

   A line that begins with "refused" has the same table twice, and the proved operator must refuse, too. *)

open Checker
open Tables

exception Differs of string

let fail format = Printf.ksprintf (fun said -> raise (Differs said)) format

(* The answer to a question that the table must answer. *)
let said what = function Some answer -> answer | None -> fail "the table does not say %s" what

(* A view must be a table, but that its vertex v is rv v there, and that lists may have another order. *)
let same name rv view table =
  let records kind slots live number links =
    for i = 0 to max (slots view) (slots table) - 1 do
      let j = number i in
      if live view i <> live table j then fail "%s: %s %d is vacant in one of both" name kind j;
      if live view i then links i j
    done
  in
  let link kind j what ours theirs = if ours <> theirs then fail "%s: %s %d: %s differs" name kind j what in
  let self i = i in
  records "vertex" (fun t -> t.vertex_slots) vertex rv (fun i j ->
      let link = link "vertex" j in
      link "leaving" (leaving view i) (leaving table j);
      link "isolated" (isolated view i) (isolated table j));
  records "half-edge" (fun t -> t.half_edge_slots) half_edge self (fun i j ->
      let link = link "half-edge" j in
      link "origin" (Stdlib.Option.map rv (origin view i)) (origin table j);
      link "twin" (twin view i) (twin table j);
      link "next" (next view i) (next table j);
      link "prev" (prev view i) (prev table j);
      link "boundary" (boundary_of view i) (boundary_of table j));
  let start t b = match boundary_start t b with Some (AtVertex v) -> Some (AtVertex (rv v)) | start -> start in
  (* A component is where it says that it is; where that is in the list may differ. *)
  let place t b =
    match boundary_place t b with
    | Some (Inner i) ->
        let f = said "the face of a boundary component" (boundary_face t b) in
        if inner t f i <> Some b then fail "%s: boundary component %d is not listed" name b;
        Some (Inner 0)
    | place -> place
  in
  records "boundary component" (fun t -> t.boundary_slots) boundary self (fun i j ->
      if start view i <> boundary_start table j then fail "%s: boundary component %d: start differs" name j;
      if boundary_face view i <> boundary_face table j then fail "%s: boundary component %d: face differs" name j;
      if place view i <> place table j then fail "%s: boundary component %d: place differs" name j);
  let list t f = List.init (inner_count t f) (fun i -> inner t f i) in
  records "face" (fun t -> t.face_slots) face self (fun i j ->
      if outer view i <> outer table j then fail "%s: face %d: outer differs" name j;
      if List.sort compare (list view i) <> List.sort compare (list table j) then
        fail "%s: face %d: inner differs" name j)

(* The records that are live. *)
let numbers slots live t = List.filter (live t) (List.init (slots t) Fun.id)
let half_edges = numbers (fun t -> t.half_edge_slots) half_edge
let boundaries = numbers (fun t -> t.boundary_slots) boundary
let faces = numbers (fun t -> t.face_slots) face

(* The only record that is live in one table and not in the other. *)
let only kind slots live one other =
  match List.filter (fun i -> not (live other i)) (numbers slots live one) with
  | [ i ] -> i
  | found -> fail "%d instead of one new or old %s" (List.length found) kind

let only_vertex = only "vertex" (fun t -> t.vertex_slots) vertex
let only_boundary = only "boundary component" (fun t -> t.boundary_slots) boundary
let only_face = only "face" (fun t -> t.face_slots) face

type corner = At of int | Isolated of int

let corner word =
  match word.[0] with
  | 'h' -> At (tail word)
  | 'v' -> Isolated (tail word)
  | _ -> raise (Unreadable word)

let boundary_at t = function
  | At h -> said "the boundary component of a half-edge" (boundary_of t h)
  | Isolated v -> said "the boundary component of an isolated vertex" (isolated t v)

let face_at t b = said "the face of a boundary component" (boundary_face t b)
let prev_at t h = said "the half-edge before another" (prev t h)

(* An operator of `Dcel`: the name of the case, the operations, and the numbers of the vertices in the table after. *)
let operations name list = (name, list, fun v -> v)

(* The half-edges that are kept in the table after, where the vertex v is rv v. *)
let keep ?(rv = fun v -> v) t' =
  KeepOthers ((fun v -> leaving t' (rv v)), fun b -> match boundary_start t' b with Some (AtHalfEdge h) -> Some h | _ -> None)

let connect t t' from into side inner h =
  let k = said "the twin of a half-edge" (twin t' h) in
  let ba = boundary_at t from and bb = boundary_at t into in
  let f = face_at t ba in
  if ba <> bb then
    match (from, into) with
    | At a, At b ->
        let dropped = only_boundary t t' in
        let kept = if dropped = ba then bb else ba in
        operations "connect two cycles" [ Bridge (prev_at t a, prev_at t b, h, k, f, kept, dropped) ]
    | At a, Isolated v ->
        let a = prev_at t a in
        operations "connect a cycle to a vertex" [ Remove (v, bb); SplitVertex (a, a, v, h, k) ]
    | Isolated v, At b ->
        let b = prev_at t b in
        operations "connect a vertex to a cycle" [ Remove (v, ba); SplitVertex (b, b, v, k, h) ]
    | Isolated v, Isolated o ->
        operations "connect two vertices" [ Remove (v, ba); AttachToIsolated (o, v, bb, k, h); keep t' ]
  else
    let made = only_boundary t' t and g = only_face t' t in
    let made_left = boundary_of t' h = Some made and new_left = side = "left" in
    let moved = List.map (boundary_at t) inner in
    let moves b = List.mem b moved in
    match (from, into) with
    | At a, At b ->
        let a = prev_at t a and b = prev_at t b in
        operations "connect corners of a cycle" [ SplitFace (a, b, h, k, f, g, ba, made, made_left, new_left, moves) ]
    | Isolated v, Isolated _ ->
        operations "connect a vertex to itself" [ LoopAtIsolated (v, h, k, f, g, ba, made, made_left, new_left, moves) ]
    | _ -> fail "one corner of a boundary component is isolated, and another is not"

(* The new vertex may have what leaves it counter-clockwise between the corners, or the rest. *)
let split_vertex t t' from into h =
  let k = said "the twin of a half-edge" (twin t' h) and v = only_vertex t' t in
  match (from, into) with
  | At a, At b ->
      let a = prev_at t a and b = prev_at t b in
      let split = if origin t' k = Some v then SplitVertex (a, b, v, h, k) else SplitVertex (b, a, v, k, h) in
      operations "split_vertex" [ split; keep t' ]
  | Isolated o, _ -> operations "split_vertex of no degree" [ AttachToIsolated (o, v, boundary_at t from, h, k) ]
  | _ -> fail "one corner of a vertex is isolated, and another is not"

(* The end of the edge is split. If it has no other edge, it is the new vertex that is the end, and the old one is on the edge. *)
let split_edge t t' e h =
  let k = said "the twin of a half-edge" (twin t' h) and v = only_vertex t' t in
  let d = said "the twin of a half-edge" (twin t e) in
  if next t e = Some d then
    let b = said "the origin of a half-edge" (origin t d) in
    let rv u = if u = b then v else if u = v then b else u in
    ("split_edge", [ SplitVertex (e, e, v, h, k); keep ~rv t' ], rv)
  else operations "split_edge" [ SplitVertex (e, prev_at t d, v, k, h); keep t' ]

let contract name t t' n =
  let m = said "the twin of a half-edge" (twin t n) and dropped = only_vertex t t' in
  let un = said "an origin" (origin t n) and um = said "an origin" (origin t m) in
  operations name [ ContractEdge (n, m, (if un = dropped then um else un), dropped); keep t' ]

(* An inner boundary component that starts at a vertex to which half-edges lead from u, but those of the edge of n and m; and
   these half-edges. *)
let way_out t n m u =
  let outsides =
    List.filter_map
      (fun b ->
        match (boundary_place t b, boundary_start t b) with
        | Some (Inner _), Some (AtVertex w) -> Some (w, b)
        | Some (Inner _), Some (AtHalfEdge i) -> Some (said "an origin" (origin t i), b)
        | _ -> None)
      (boundaries t)
  in
  let edges = List.filter (fun i -> i <> n && i <> m) (half_edges t) in
  let rec search met = function
    | [] -> fail "no way leads to the outside of a part"
    | (w, way) :: waiting -> (
        match List.assoc_opt w outsides with
        | Some b -> (b, List.rev way)
        | None ->
            let leaving = List.filter (fun i -> origin t i = Some w) edges in
            let reached = List.map (fun i -> (said "a target" (Stdlib.Option.bind (twin t i) (origin t)), i :: way)) leaving in
            let reached = List.filter (fun (x, _) -> not (List.mem x met)) reached in
            search (List.map fst reached @ met) (waiting @ reached))
  in
  search [ u ] [ (u, []) ]

let part t t' n m kept =
  let made = only_boundary t' t in
  (* The boundary component of an end afterwards. *)
  let at_end n m =
    match next t m with
    | Some i when i <> n -> boundary_at t' (At i)
    | _ -> boundary_at t' (Isolated (said "an origin" (origin t n)))
  in
  let at_n = at_end n m and at_m = at_end m n in
  let stays = if boundary_place t' at_m = Some Outer then at_m else at_n in
  let outside, way =
    if boundary_place t kept = Some Outer then way_out t n m (said "an origin" (origin t (if stays = at_n then n else m)))
    else (kept, [])
  in
  operations "remove a bridge" [ PartComponent (n, m, face_at t kept, kept, made, at_n, at_m, stays, outside, way) ]

let remove t t' n =
  let m = said "the twin of a half-edge" (twin t n) in
  let bn = boundary_at t (At n) and bm = boundary_at t (At m) in
  if bn = bm then part t t' n m bn
  else
    let dropped = only_boundary t t' and g = only_face t t' in
    let kept = if dropped = bn then bm else bn in
    let f = match List.filter (( <> ) g) (List.map (face_at t) [ bn; bm ]) with [ f ] -> f | _ -> fail "one face is merged with itself" in
    operations "remove an edge of two faces" [ MergeFaces (n, m, f, g, kept, dropped) ]

(* The edge is taken out, and put back: from the corner after one half-edge to that after another. *)
let flip t t' n turn =
  let m = said "the twin of a half-edge" (twin t n) in
  let bn = boundary_at t (At n) and bm = boundary_at t (At m) in
  let next t i = said "the half-edge after another" (next t i) in
  let outer b = boundary_place t b = Some Outer in
  let clockwise = turn = "clockwise" in
  (* The half-edge before another one when the edge is taken out. *)
  let before i = match prev_at t i with p when p = n -> prev_at t m | p when p = m -> prev_at t n | p -> p in
  let turned n m bn bm a b =
    let g, f, new_left = if outer bm then (face_at t bm, face_at t bn, false) else (face_at t bn, face_at t bm, true) in
    let moved c = boundary_face t c = Some g in
    operations "flip_edge" [ MergeFaces (n, m, f, g, bn, bm); SplitFace (a, b, n, m, f, g, bn, bm, false, new_left, moved); keep t' ]
  in
  (* A loop that is alone on its cycle slides along the other one. *)
  let slide lone n blone bn =
    let last = if clockwise then (match prev_at t (prev_at t n) with p when p = n -> prev_at t n | p -> p) else next t n in
    turned n lone bn blone last last
  in
  match (next t n = n, next t m = m) with
  | true, true -> operations "flip_edge of a loop alone" []
  | true, false -> slide n m bn bm
  | false, true -> slide m n bm bn
  | false, false ->
      if clockwise then turned n m bn bm (before (prev_at t n)) (before (prev_at t m)) else turned n m bn bm (next t m) (next t n)

let move t corner g =
  let b = boundary_at t corner in
  let f = face_at t b in
  match boundary_place t b with
  | _ when f = g -> operations "move_inner to its own face" []
  | Some (Inner i) -> operations "move_inner" [ Move (b, f, i, g) ]
  | _ -> fail "an outer boundary component was moved"

let proved t t' = function
  | [ "add_isolated_vertex"; f ] -> operations "add_isolated_vertex" [ Add (only_vertex t' t, only_boundary t' t, tail f) ]
  | [ "remove_isolated_vertex"; v ] -> operations "remove_isolated_vertex" [ Remove (tail v, boundary_at t (corner v)) ]
  | [ "move_inner"; inner; g ] -> move t (corner inner) (tail g)
  | [ "split_edge"; e; "="; h ] -> split_edge t t' (tail e) (tail h)
  | [ "join_edges"; e ] -> contract "join_edges" t t' (said "the half-edge after another" (next t (tail e)))
  | [ "remove_edge"; n ] -> remove t t' (tail n)
  | [ "split_vertex"; from; into; "="; h ] -> split_vertex t t' (corner from) (corner into) (tail h)
  | [ "contract_edge"; n ] -> contract "contract_edge" t t' (tail n)
  | [ "flip_edge"; n; turn ] -> flip t t' (tail n) turn
  | "connect" :: from :: into :: side :: rest ->
      let inner, h =
        match List.rev rest with
        | h :: "=" :: inner -> (List.rev_map corner inner, tail h)
        | _ -> raise (Unreadable "connect without a half-edge")
      in
      connect t t' (corner from) (corner into) side inner h
  | _ -> raise (Unreadable "an operator")

(* Operations that must be refused where an operator of `Dcel` was: none if its test is about keys or sizes, or if the proved operator
   does more. *)
let refused t words =
  let boundary_at = function At h -> boundary_of t h | Isolated v -> isolated t v in
  let free_h = t.half_edge_slots and free_k = t.half_edge_slots + 1 in
  match words with
  | [ "remove_isolated_vertex"; v ] ->
      List.map (fun b -> Remove (tail v, b)) (boundaries t)
  | [ "move_inner"; inner; g ] -> (
      match boundary_at (corner inner) with
      | None -> []
      | Some b ->
          let i = match boundary_place t b with Some (Inner i) -> i | _ -> 0 in
          [ Move (b, face_at t b, i, tail g) ])
  | [ "contract_edge"; n ] ->
      let n = tail n in
      let m = said "a twin" (twin t n) in
      let un = said "an origin" (origin t n) and um = said "an origin" (origin t m) in
      [ ContractEdge (n, m, un, um); ContractEdge (n, m, um, un) ]
  | [ "flip_edge"; n; _ ] ->
      let n = tail n in
      let m = said "a twin" (twin t n) and b = said "a component" (boundary_of t n) in
      List.concat_map (fun f -> List.map (fun g -> MergeFaces (n, m, f, g, b, b)) (faces t)) (faces t)
  | [ "split_vertex"; a; b ] -> (
      match (corner a, corner b) with
      | At a, At b -> [ SplitVertex (prev_at t a, prev_at t b, t.vertex_slots, free_h, free_k) ]
      | _ -> [])
  | [ "connect"; a; b; _ ] -> (
      match (corner a, corner b) with
      | At a, At b when boundary_of t a <> boundary_of t b ->
          let kept = said "a component" (boundary_of t a) and dropped = said "a component" (boundary_of t b) in
          List.map (fun f -> Bridge (prev_at t a, prev_at t b, free_h, free_k, f, kept, dropped)) [ face_at t kept; face_at t dropped ]
      | _ -> [])
  | _ -> []

(* An operator that was refused has changed nothing, and is refused here, too. *)
let compare_refused words t t' =
  same "refused" (fun v -> v) t t';
  let right = List.filter (is_right t) (refused t words) in
  if right <> [] then fail "refused, though the arguments are those of the theorem";
  if refused t words = [] then "refused, nothing else compared" else "refused: " ^ List.hd words

let compare_step words t t' =
  let name, list, rv = proved t t' words in
  if first_broken t <> None then fail "a rule is broken before";
  let operate view operation =
    if not (is_right view operation) then fail "%s: the arguments are not those of the theorem" name;
    after view operation
  in
  same name rv (List.fold_left operate t list) t';
  name

let () =
  let compared = Hashtbl.create 16 and differences = ref 0 and steps = ref 0 in
  let count name = Hashtbl.replace compared name (1 + Stdlib.Option.value ~default:0 (Hashtbl.find_opt compared name)) in
  each_line (fun line ->
      match String.split_on_char ';' line with
      | [ step; t; t' ] -> (
          let words = List.filter (( <> ) "") (String.split_on_char ' ' step) in
          incr steps;
          let t = read_view (reader t) and t' = read_view (reader t') in
          try count (match words with "refused" :: words -> compare_refused words t t' | _ -> compare_step words t t')
          with Differs said ->
            incr differences;
            if !differences <= 10 then Printf.printf "%s: %s\n" line said)
      | _ -> raise (Unreadable "no three parts"));
  List.iter (fun (name, n) -> Printf.printf "  %-30s%12d\n" name n) (List.sort compare (List.of_seq (Hashtbl.to_seq compared)));
  Printf.printf "%d steps, %d differences\n" !steps !differences;
  if !differences > 0 then exit 1
