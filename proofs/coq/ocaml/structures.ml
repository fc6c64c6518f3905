(* Reads what Tables does not: the parts that are stored (P), the faces that half-edges name (HF), the half-edges and vertices that
   faces keep (FH), and expectations, as `# expect: surface open asking sides 3` says them. *)

open Checker
open Tables

let has_words word count row =
  if number (word ()) <> count then raise (Unreadable "another number of rows");
  Array.init count (fun _ -> match word () with "x" -> None | first -> Some (row first))

let all_words = [ "prev"; "leaving"; "faces"; "boundary_components"; "places"; "holes"; "unbounded_face" ]

(* The words between P and V, their number first; every part if there is no P. *)
let read_parts line word =
  let words =
    if line.[0] <> 'P' then all_words
    else begin
      ignore (word ());
      let count = number (word ()) in
      List.init count (fun _ -> word ())
    end
  in
  let has part = List.mem part words in
  List.iter (fun part -> if not (List.mem part all_words) then raise (Unreadable part)) words;
  {
    prev_part = has "prev";
    leaving_part = has "leaving";
    faces_part = has "faces";
    boundaries_part = has "boundary_components";
    places_part = has "places";
    holes_part = has "holes";
    unbounded_part = has "unbounded_face";
  }

(* The structure on a line, and the word after it. *)
let read_structure line =
  let word = reader line in
  let stored = read_parts line word in
  let view = read_view word in
  let next_word () = try word () with Unreadable _ -> "" in
  let after = next_word () in
  let faces, after =
    if after <> "HF" then ([||], after)
    else
      let faces = has_words word view.half_edge_slots link in
      (faces, next_word ())
  in
  let kept, after =
    if after <> "FH" then ([||], after)
    else
      let starts outer =
        let count = number (word ()) in
        if count > Sys.max_array_length then raise (Unreadable "too many inner");
        let starts = Array.make count None in
        for i = 0 to count - 1 do starts.(i) <- start (word ()) done;
        (link outer, starts)
      in
      let kept = has_words word view.face_slots starts in
      (kept, next_word ())
  in
  let kept_at f = if f < Array.length kept then kept.(f) else None in
  let starts f = match kept_at f with Some (_, starts) -> starts | None -> [||] in
  let answers =
    {
      view with
      says_inner_count = (fun f -> max (view.says_inner_count f) (Array.length (starts f)));
      says_inner = (fun f i -> if i < view.says_inner_count f then view.says_inner f i else None);
    }
  in
  ( {
      answers;
      stored;
      says_face = (fun h -> if h < Array.length faces then Stdlib.Option.join faces.(h) else None);
      says_outer_half_edge = (fun f -> match kept_at f with Some (outer, _) -> outer | None -> None);
      says_inner_start = (fun f i -> if i < Array.length (starts f) then (starts f).(i) else None);
    },
    after,
    word )

(* The words after `# expect:`. *)
let read_expectation words =
  let rec asking e = function
    | [] -> e
    | "no-unused-vertices" :: rest -> asking { e with no_unused_vertices = true } rest
    | "simple" :: rest -> asking { e with no_loops_nor_parallels = true } rest
    | "sides" :: n :: rest -> asking { e with sides_asked = Some (number n) } rest
    | "closed" :: rest -> asking { e with without_border = true } rest
    | "components" :: n :: rest -> asking { e with components_asked = Some (number n) } rest
    | "borders" :: n :: rest -> asking { e with borders_asked = Some (number n) } rest
    | "genus" :: n :: rest -> asking { e with genus_asked = Some (number n) } rest
    | "border-kept" :: rest -> asking { e with border_kept = true } rest
    | word :: _ -> raise (Unreadable word)
  in
  let opened e = function "open" :: rest -> ({ e with is_open = true }, rest) | rest -> (e, rest) in
  let kind, rest =
    match words with
    | "plane" :: rest -> opened plane rest
    | "surface" :: rest -> opened surface rest
    | _ -> raise (Unreadable "an expectation")
  in
  match rest with [] -> kind | "asking" :: rest -> asking kind rest | word :: _ -> raise (Unreadable word)

(* The expectation that a comment says, if it says one. *)
let expectation_of comment =
  match List.filter (( <> ) "") (String.split_on_char ' ' comment) with
  | "#" :: "expect:" :: words -> Some (read_expectation words)
  | _ -> None
