(* Reads certificates of plane subdivisions as text, one a line, and judges each by the proved checker.

     certificates --compare < lines   takes lines that end in the tests that fail, prints those that differ, and counts

   A line: the columns in the order of ../CERTIFICATE.md, each after its number of entries, then = and the names of the tests that
   fail, in the order of that page. *)

open Certificate

let unreadable line word =
  Printf.eprintf "certificates: line %d cannot be read: %s\n" line word;
  exit 2

(* A column as the content of its file. *)
let column words =
  let count = int_of_string (words ()) in
  let bytes = Bytes.create (4 * count) in
  for i = 0 to count - 1 do
    Bytes.set_int32_le bytes (4 * i) (Int32.of_int (int_of_string (words ())))
  done;
  Bytes.unsafe_to_string bytes

let read words =
  let rows file = String.length file / 4 in
  let next () = column words in
  let half_edge_origin = next () in
  let half_edge_twin = next () in
  let half_edge_next = next () in
  let half_edge_prev = next () in
  let half_edge_boundary = next () in
  let half_edge_rank = next () in
  let vertex_leaving = next () in
  let vertex_isolated = next () in
  let boundary_face_column = next () in
  let boundary_start_column = next () in
  let boundary_vertex_column = next () in
  let boundary_place_column = next () in
  let face_outer = next () in
  let face_end = next () in
  let face_inner = next () in
  {
    claim = "twinedge certificate 1\nplane\n";
    half_edge_rows = rows half_edge_origin;
    vertex_rows = rows vertex_leaving;
    boundary_rows = rows boundary_face_column;
    face_rows = rows face_outer;
    inner_rows = rows face_inner;
    half_edge_origin; half_edge_twin; half_edge_next; half_edge_prev; half_edge_boundary; half_edge_rank;
    vertex_leaving; vertex_isolated;
    boundary_face_column; boundary_start_column; boundary_vertex_column; boundary_place_column;
    face_outer; face_end; face_inner;
  }

(* The tests that fail, by the definitions that [judge] is made of. *)
let failing folder =
  let view = view_in folder in
  (* Beyond the end of its file [ranks_in] is 0, which is lower than others; the page says that nil fails. The verdict is the same: a link
     that leads there fails another test. *)
  let rank h = if h < folder.half_edge_rows then ranks_in folder h else 1 lsl 32 in
  let fails slots live (name, test) =
    let rec any i = i < slots && ((live view i && not (test i)) || any (i + 1)) in
    if any 0 then [ name ] else []
  in
  let each slots live tests = List.concat_map (fails slots live) tests in
  each folder.half_edge_rows half_edge
    [ ("twin_ok", twin_ok view); ("next_ok", next_ok view); ("target_ok", target_ok view);
      ("origin_ok", origin_ok view); ("cycle_ok", cycle_ok view); ("rank_ok", rank_ok view rank) ]
  @ each folder.vertex_rows vertex [ ("vertex_ok", vertex_ok view) ]
  @ each folder.boundary_rows boundary [ ("start_ok", start_ok view); ("place_ok", place_ok view) ]
  @ each folder.face_rows face [ ("face_ok", face_ok view) ]
  @ (if one_unbounded view then [] else [ "one_unbounded" ])
  @ if euler_ok view then [] else [ "euler_ok" ]

let judged folder =
  match judge folder with
  | Valid -> [ "valid" ]
  | Unreadable -> [ "unreadable" ]
  | Invalid -> ( match failing folder with [] -> [ "not"; "valid" ] | tests -> tests)

let () =
  if Sys.argv <> [| Sys.argv.(0); "--compare" |] then begin
    prerr_endline "usage: certificates --compare < lines";
    exit 2
  end;
  let counts = Hashtbl.create 16 and lines = ref 0 and differences = ref 0 in
  (try
     while true do
       let line = input_line stdin in
       if line <> "" && line.[0] <> '#' then begin
         incr lines;
         let rest = ref (List.filter (( <> ) "") (String.split_on_char ' ' line)) in
         let words () = match !rest with [] -> unreadable !lines "end of line" | word :: more -> rest := more; word in
         let folder = try read words with Failure _ | Invalid_argument _ -> unreadable !lines line in
         if words () <> "=" then unreadable !lines line;
         let theirs = if !rest = [] then [ "valid" ] else !rest and ours = judged folder in
         List.iter (fun name -> Hashtbl.replace counts name (1 + Stdlib.Option.value ~default:0 (Hashtbl.find_opt counts name))) ours;
         if ours <> theirs then begin
           incr differences;
           if !differences <= 10 then Printf.printf "%s, but the proved checker says %s\n" line (String.concat " " ours)
         end
       end
     done
   with End_of_file -> ());
  let names = List.sort Stdlib.compare (Hashtbl.fold (fun name count all -> (name, count) :: all) counts []) in
  List.iter (fun (name, count) -> Printf.printf "%-14s%12d\n" name count) names;
  Printf.printf "%d certificates, %d differences\n" !lines !differences;
  if !differences > 0 then exit 1
