(* Reads tables as text, one a line, and says of each which rule the proved checker finds broken first.

     judge < tables                prints the verdict of each line: a rule, or ok
     judge --fast-path < tables    prints what the proved fast path says, and of T2, which it leaves, the checker: accepted or refused
     judge [--fast-path] --compare < tables
                                   takes lines that end in a verdict, prints those that differ, and counts

   Both ask of live records only: a question about any other slot would end the program.

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

let broken_first view =
  match first_broken view with
  | None -> "ok"
  | Some R1 -> "R1" | Some L1 -> "L1" | Some L2 -> "L2" | Some L3 -> "L3" | Some V1 -> "V1" | Some V2 -> "V2"
  | Some B1 -> "B1" | Some B2 -> "B2" | Some F1 -> "F1" | Some F2 -> "F2"
  | Some T1 -> "T1" | Some T2 -> "T2" | Some T3 -> "T3" | Some T4 -> "T4"

let fast_path_says view = if fast_path view && check_t2 view (labels view) then "accepted" else "refused"

let each_line judge =
  let number = ref 0 in
  try
    while true do
      let line = input_line stdin in
      incr number;
      try if line <> "" && line.[0] <> '#' then judge line
      with Unreadable word ->
        Printf.eprintf "judge: line %d cannot be read: %s\n" !number word;
        exit 2
    done
  with End_of_file -> ()

let compare_all verdict verdicts =
  let counts = Hashtbl.create 16 and tables = ref 0 and differences = ref 0 in
  each_line (fun line ->
      let word = reader line in
      let ours = verdict (read_view word) in
      while word () <> "=" do () done;
      let theirs = word () in
      incr tables;
      Hashtbl.replace counts ours (1 + Stdlib.Option.value ~default:0 (Hashtbl.find_opt counts ours));
      if ours <> theirs then begin
        incr differences;
        if !differences <= 10 then Printf.printf "%s, but the proved checker says %s\n" line ours
      end);
  List.iter
    (fun said -> Printf.printf "%-3s%12d\n" said (Stdlib.Option.value ~default:0 (Hashtbl.find_opt counts said)))
    verdicts;
  Printf.printf "%d tables, %d differences\n" !tables !differences;
  if !differences > 0 then exit 1

let rules = [ "R1"; "L1"; "L2"; "L3"; "V1"; "V2"; "B1"; "B2"; "F1"; "F2"; "T1"; "T2"; "T3"; "ok" ]

let () =
  let print_all verdict = each_line (fun line -> print_endline (verdict (read_view (reader line)))) in
  match List.tl (Array.to_list Sys.argv) with
  | [] -> print_all broken_first
  | [ "--fast-path" ] -> print_all fast_path_says
  | [ "--compare" ] -> compare_all broken_first rules
  | [ "--fast-path"; "--compare" ] -> compare_all fast_path_says [ "accepted"; "refused" ]
  | _ ->
      prerr_endline "usage: judge [--fast-path] [--compare] < tables";
      exit 2
