(* Reads tables as text, one a line.

   A line: the four kinds of records, each with the number of its slots and what each slot holds; x is a vacant slot,
   - is nil.

     V 2 0 - 1 - H 2 2 2 2 2 0 2 2 2 2 0 B 1 0 h0 i0 F 1 - 1 0 = R1
     V  leaving isolated
     H  origin twin next prev boundary
     B  face, start (h0 or v0), place (o or i0)
     F  outer, how many inner, each of these

   Sections after F (HF, FH) are passed over: they hold what a structure with boundary components is not asked for.
   Empty lines and lines that begin with # are passed over. *)

open Checker

exception Unreadable of string

(* Numbers too large for OCaml lead nowhere, like all that are larger than the number of slots. *)
let nowhere = 1 lsl 60

let number word =
  if word = "" || not (String.for_all (fun c -> '0' <= c && c <= '9') word) then raise (Unreadable word)
  else if String.length word > 15 then nowhere
  else int_of_string word

let link = function "-" -> None | word -> Some (number word)
let tail word = number (String.sub word 1 (String.length word - 1))

let start = function
  | "-" -> None
  | word when word.[0] = 'h' -> Some (AtHalfEdge (tail word))
  | word when word.[0] = 'v' -> Some (AtVertex (tail word))
  | word -> raise (Unreadable word)

let place = function
  | "-" -> None
  | "o" -> Some Outer
  | word when word.[0] = 'i' -> Some (Inner (tail word))
  | word -> raise (Unreadable word)

type vertex_row = { leaving : link; isolated : link }
type half_edge_row = { origin : link; twin : link; next : link; prev : link; boundary : link }
type boundary_row = { face : link; start : start option; place : place option }
type face_row = { outer : link; inner : link array }

(* The words of a line, one after another. *)
let reader line =
  let rest = ref (List.filter (( <> ) "") (String.split_on_char ' ' line)) in
  fun () -> match !rest with [] -> raise (Unreadable "end of line") | word :: more -> rest := more; word

let table word letter row =
  if word () <> letter then raise (Unreadable ("no " ^ letter));
  let count = number (word ()) in
  if count > Sys.max_array_length then raise (Unreadable "too many slots");
  let rows = Array.make count None in
  for i = 0 to count - 1 do
    match word () with "x" -> () | first -> rows.(i) <- Some (row first)
  done;
  rows

let read_view word =
  let next_link () = link (word ()) in
  let vertices = table word "V" (fun first -> let isolated = next_link () in { leaving = link first; isolated }) in
  let half_edges =
    table word "H" (fun first ->
        let twin = next_link () in
        let next = next_link () in
        let prev = next_link () in
        let boundary = next_link () in
        { origin = link first; twin; next; prev; boundary })
  in
  let boundaries =
    table word "B" (fun first ->
        let start = start (word ()) in
        let place = place (word ()) in
        { face = link first; start; place })
  in
  let faces =
    table word "F" (fun first ->
        let count = number (word ()) in
        if count > Sys.max_array_length then raise (Unreadable "too many inner");
        let inner = Array.make count None in
        for i = 0 to count - 1 do inner.(i) <- next_link () done;
        { outer = link first; inner })
  in
  let is rows i = rows.(i) <> None in
  let ask rows field i = match rows.(i) with Some row -> field row | None -> invalid_arg "a vacant slot is asked" in
  {
    vertex_slots = Array.length vertices;
    half_edge_slots = Array.length half_edges;
    boundary_slots = Array.length boundaries;
    face_slots = Array.length faces;
    is_vertex = is vertices;
    is_half_edge = is half_edges;
    is_boundary = is boundaries;
    is_face = is faces;
    says_origin = ask half_edges (fun row -> row.origin);
    says_twin = ask half_edges (fun row -> row.twin);
    says_next = ask half_edges (fun row -> row.next);
    says_prev = ask half_edges (fun row -> row.prev);
    says_boundary = ask half_edges (fun row -> row.boundary);
    says_leaving = ask vertices (fun row -> row.leaving);
    says_isolated = ask vertices (fun row -> row.isolated);
    says_boundary_face = ask boundaries (fun row -> row.face);
    says_boundary_start = ask boundaries (fun row -> row.start);
    says_boundary_place = ask boundaries (fun row -> row.place);
    says_outer = ask faces (fun row -> row.outer);
    says_inner_count = ask faces (fun row -> Array.length row.inner);
    says_inner = (fun f i -> ask faces (fun row -> row.inner.(i)) f);
  }

let each_line ?(comment = ignore) judge =
  let number = ref 0 in
  try
    while true do
      let line = input_line stdin in
      incr number;
      try if line <> "" then if line.[0] = '#' then comment line else judge line
      with Unreadable word ->
        Printf.eprintf "line %d cannot be read: %s\n" !number word;
        exit 2
    done
  with End_of_file -> ()
