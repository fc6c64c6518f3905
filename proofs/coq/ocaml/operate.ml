(* Reads what operators of `Dcel` did, one a line, and holds each against the operator that is proved.

     operate < steps

   A line: the operator with its arguments, the table before, and the table after, with semicolons between them, as
   trials/examples/steps.rs prints it.

     connect v0 v1 left = h0 ; V 2 - 0 - 1 H 0 B 2 0 v0 i0 0 v1 i1 F 1 - 2 0 1 ; V 2 0 - 1 - H 2 0 1 1 1 1 1 0 0 0 1 B 2 x 0 h0 i0 F 1 - 1 1

   The arguments that the proved operator has beside these, such as free slots and which of two cycles is relabelled, are
   taken from the table after. Then its arguments must be right (is_right), all rules must hold before, its view before must
   be the table before, and its view after the table after: all links of all records. The lists of inner boundary components
   may have another order (Renaming.v). Where nothing is proved of the operator, the line is passed over, and counted. *)

open Checker
open Tables

exception Differs of string

let fail format = Printf.ksprintf (fun said -> raise (Differs said)) format

(* The answer to a question that the table must answer. *)
let said what = function Some answer -> answer | None -> fail "the table does not say %s" what

(* A view must be a table, but that its boundary component b is rb b there, and that lists may have another order. *)
let same name rb view table =
  let rename = Stdlib.Option.map rb in
  let records kind slots live number links =
    for i = 0 to max (slots view) (slots table) - 1 do
      let j = number i in
      if live view i <> live table j then fail "%s: %s %d is vacant in one of both" name kind j;
      if live view i then links i j
    done
  in
  let link kind j what ours theirs = if ours <> theirs then fail "%s: %s %d: %s differs" name kind j what in
  let self i = i in
  records "vertex" (fun t -> t.vertex_slots) vertex self (fun i j ->
      let link = link "vertex" j in
      link "leaving" (leaving view i) (leaving table j);
      link "isolated" (rename (isolated view i)) (isolated table j));
  records "half-edge" (fun t -> t.half_edge_slots) half_edge self (fun i j ->
      let link = link "half-edge" j in
      link "origin" (origin view i) (origin table j);
      link "twin" (twin view i) (twin table j);
      link "next" (next view i) (next table j);
      link "prev" (prev view i) (prev table j);
      link "boundary" (rename (boundary_of view i)) (boundary_of table j));
  (* A component is where it says that it is; where that is in the list may differ. *)
  let place t b =
    match boundary_place t b with
    | Some (Inner i) ->
        let f = said "the face of a boundary component" (boundary_face t b) in
        if inner t f i <> Some b then fail "%s: boundary component %d is not listed" name b;
        Some (Inner 0)
    | place -> place
  in
  records "boundary component" (fun t -> max t.boundary_slots table.boundary_slots) boundary rb (fun i j ->
      if boundary_start view i <> boundary_start table j then fail "%s: boundary component %d: start differs" name j;
      if boundary_face view i <> boundary_face table j then fail "%s: boundary component %d: face differs" name j;
      if place view i <> place table j then fail "%s: boundary component %d: place differs" name j);
  let list t f = List.init (inner_count t f) (fun i -> inner t f i) in
  records "face" (fun t -> t.face_slots) face self (fun i j ->
      if rename (outer view i) <> outer table j then fail "%s: face %d: outer differs" name j;
      if List.sort compare (List.map rename (list view i)) <> List.sort compare (list table j) then
        fail "%s: face %d: inner differs" name j)

(* The view without the isolated vertex v, whose boundary component is b, in the face f. *)
let without t v b f =
  let row = Array.of_list (List.filter (( <> ) (Some b)) (List.init (inner_count t f) (fun i -> inner t f i))) in
  let places = Hashtbl.create 16 in
  Array.iteri (fun i c -> Hashtbl.replace places c (Inner i)) row;
  let place c = match Hashtbl.find_opt places (Some c) with None -> t.says_boundary_place c | listed -> listed in
  {
    t with
    is_vertex = (fun i -> i <> v && t.is_vertex i);
    is_boundary = (fun c -> c <> b && t.is_boundary c);
    says_boundary_place = place;
    says_inner_count = (fun g -> if g = f then Array.length row else t.says_inner_count g);
    says_inner = (fun g i -> if g = f then row.(i) else t.says_inner g i);
  }

(* The only record that is live in one table and not in the other. *)
let only kind slots live one other =
  match List.filter (fun i -> live one i && not (live other i)) (List.init (slots one) Fun.id) with
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

(* What is proved of an operator. *)
type proved =
  | Nothing
  (* The name of the case, the view that the operator is stated on, the operation, and the numbers of boundary components in
     the table after. *)
  | Operation of string * view * operation * (int -> int)
  (* Nothing is changed. *)
  | Unchanged of string

let number_itself b = b
let operation name t operation = Operation (name, t, operation, number_itself)

let connect t t' from into side inner h =
  let k = said "the twin of a half-edge" (twin t' h) in
  let ba = boundary_at t from and bb = boundary_at t into in
  let f = face_at t ba in
  if ba <> bb then
    match (from, into) with
    | At a, At b ->
        let dropped = only_boundary t t' in
        let kept = if dropped = ba then bb else ba in
        operation "connect two cycles" t (Bridge (prev_at t a, prev_at t b, h, k, f, kept, dropped))
    | At a, Isolated v ->
        operation "connect a cycle to a vertex" (without t v bb f) (BridgeToIsolated (prev_at t a, v, bb, f, h, k))
    | Isolated v, At b ->
        operation "connect a vertex to a cycle" (without t v ba f) (BridgeToIsolated (prev_at t b, v, ba, f, k, h))
    | Isolated o, Isolated v ->
        (* That of the first vertex is kept in the proof, under the number of the other one here. *)
        let exchanged b = if b = ba then bb else if b = bb then ba else b in
        Operation ("connect two vertices", without t v bb f, BridgeBetweenIsolated (o, v, ba, bb, f, h, k), exchanged)
  else
    let made = only_boundary t' t and g = only_face t' t in
    let made_left = boundary_of t' h = Some made and new_left = side = "left" in
    let moved = List.map (boundary_at t) inner in
    let moves b = List.mem b moved in
    match (from, into) with
    | At a, At b ->
        let a = prev_at t a and b = prev_at t b in
        operation "connect corners of a cycle" t (SplitFace (a, b, h, k, f, g, ba, made, made_left, new_left, moves))
    | Isolated v, Isolated _ ->
        operation "connect a vertex to itself" t (LoopAtIsolated (v, h, k, f, g, ba, made, made_left, new_left, moves))
    | _ -> fail "one corner of a boundary component is isolated, and another is not"

(* A vertex at the end of a new edge, from one that was isolated. One that has edges is passed over, though the new edge may be
   one to a vertex of degree 1: `Dcel` lets the old vertex keep the new half-edge, and attach_vertex leaves it what it had. *)
let attach_to_isolated t t' o h =
  let k = said "the twin of a half-edge" (twin t' h) in
  operation "split_vertex of no degree" t (AttachToIsolated (o, only_vertex t' t, boundary_at t (Isolated o), h, k))

(* An inner boundary component that starts at a vertex to which half-edges lead from u, but those of the edge of n and m; and
   these half-edges. *)
let way_out t n m u =
  let live is slots = List.filter (is t) (List.init (slots t) Fun.id) in
  let outsides =
    List.filter_map
      (fun b ->
        match (boundary_place t b, boundary_start t b) with
        | Some (Inner _), Some (AtVertex w) -> Some (w, b)
        | Some (Inner _), Some (AtHalfEdge i) -> Some (said "an origin" (origin t i), b)
        | _ -> None)
      (live boundary (fun t -> t.boundary_slots))
  in
  let edges = List.filter (fun i -> i <> n && i <> m) (live half_edge (fun t -> t.half_edge_slots)) in
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
  (* What the boundary component of an end is afterwards. *)
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
  operation "remove a bridge" t (PartComponent (n, m, face_at t kept, kept, made, at_n, at_m, stays, outside, way))

let remove t t' n =
  let m = said "the twin of a half-edge" (twin t n) in
  let bn = boundary_at t (At n) and bm = boundary_at t (At m) in
  if bn = bm then part t t' n m bn
  else
    let dropped = only_boundary t t' and g = only_face t t' in
    let kept = if dropped = bn then bm else bn in
    let f = match List.filter (( <> ) g) (List.map (face_at t) [ bn; bm ]) with [ f ] -> f | _ -> fail "one face is merged with itself" in
    operation "remove an edge of two faces" t (MergeFaces (n, m, f, g, kept, dropped))

let move t corner g =
  let b = boundary_at t corner in
  let f = face_at t b in
  match boundary_place t b with
  | _ when f = g -> Unchanged "move_inner to its own face"
  | Some (Inner i) -> operation "move_inner" t (Move (b, f, i, g))
  | _ -> fail "an outer boundary component was moved"

let proved t t' = function
  | [ "add_isolated_vertex"; f ] ->
      operation "add_isolated_vertex" t (Add (only_vertex t' t, only_boundary t' t, tail f))
  | [ "remove_isolated_vertex"; v ] ->
      let b = boundary_at t (corner v) in
      let f = face_at t b in
      operation "remove_isolated_vertex" (without t (tail v) b f) (Remove (tail v, b, f))
  | [ "move_inner"; inner; g ] -> move t (corner inner) (tail g)
  | [ "split_edge"; e; "="; h ] ->
      let h = tail h in
      operation "split_edge" t (SplitEdge (tail e, only_vertex t' t, h, said "the twin of a half-edge" (twin t' h)))
  | [ "join_edges"; e ] ->
      let e = tail e in
      let h = said "the half-edge after another" (next t e) in
      let k = said "the twin of a half-edge" (twin t h) and v = said "the origin of a half-edge" (origin t h) in
      operation "join_edges" t (JoinEdges (e, v, h, k))
  | [ "remove_edge"; n ] -> remove t t' (tail n)
  | [ "split_vertex"; from; _; "="; h ] when from.[0] = 'v' -> attach_to_isolated t t' (tail from) (tail h)
  | "connect" :: from :: into :: side :: rest ->
      let inner, h =
        match List.rev rest with
        | h :: "=" :: inner -> (List.rev_map corner inner, tail h)
        | _ -> raise (Unreadable "connect without a half-edge")
      in
      connect t t' (corner from) (corner into) side inner h
  | _ -> Nothing

let compare_step words t t' =
  match proved t t' words with
  | Nothing -> None
  | Unchanged name ->
      same "after" number_itself t t';
      Some name
  | Operation (name, u, operation, number) ->
      if not (is_right u operation) then fail "%s: the arguments are not those of the theorem" name;
      if first_broken t <> None then fail "a rule is broken before";
      same "before" number_itself (before u operation) t;
      same "after" number (after u operation) t';
      Some name

let () =
  let compared = Hashtbl.create 16 and passed_over = Hashtbl.create 16 and differences = ref 0 and steps = ref 0 in
  let count counts name = Hashtbl.replace counts name (1 + Stdlib.Option.value ~default:0 (Hashtbl.find_opt counts name)) in
  each_line (fun line ->
      match String.split_on_char ';' line with
      | [ step; t; t' ] -> (
          let words = List.filter (( <> ) "") (String.split_on_char ' ' step) in
          incr steps;
          try
            match compare_step words (read_view (reader t)) (read_view (reader t')) with
            | Some name -> count compared name
            | None -> count passed_over (List.hd words)
          with Differs said ->
            incr differences;
            if !differences <= 10 then Printf.printf "%s: %s\n" line said)
      | _ -> raise (Unreadable "no three parts"));
  let print title counts =
    print_endline title;
    List.iter (fun (name, n) -> Printf.printf "  %-30s%12d\n" name n) (List.sort compare (List.of_seq (Hashtbl.to_seq counts)))
  in
  print "compared with the proved operator" compared;
  print "passed over, as nothing is proved" passed_over;
  let all = Hashtbl.fold (fun _ n sum -> n + sum) compared 0 in
  Printf.printf "%d steps, %d compared, %d differences\n" !steps all !differences;
  if !differences > 0 then exit 1
