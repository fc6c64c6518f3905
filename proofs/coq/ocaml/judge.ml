(* Reads tables as text, one a line, and says of each which rule the proved checker finds broken first.

     judge < tables                prints the verdict of each line: a rule, or ok
     judge --fast-path < tables    prints what the proved fast path says, and of T2, which it leaves, the checker: accepted or refused
     judge --expectations < tables prints the first broken rule of the expectation that the last line `# expect: ...` says (plane, if
                                   none does), of the parts that the table stores
     judge [--fast-path | --expectations] --compare < tables
                                   takes lines that end in a verdict, prints those that differ, and counts

   All ask of live records only: a question about any other slot would end the program.

   tables.ml says what a line is. *)

open Checker
open Tables
open Structures

let basic = function
  | R1 -> "R1" | L1 -> "L1" | L2 -> "L2" | L3 -> "L3" | V1 -> "V1" | V2 -> "V2"
  | B1 -> "B1" | B2 -> "B2" | F1 -> "F1" | F2 -> "F2"
  | T1 -> "T1" | T2 -> "T2" | T3 -> "T3" | T4 -> "T4"

let mesh = function
  | M1 -> "M1" | M2 -> "M2" | M3 -> "M3" | M4 -> "M4" | M5 -> "M5" | M6 -> "M6" | M7 -> "M7" | M8 -> "M8"

let broken_first line =
  let word = reader line in
  let said = first_broken (read_view word) in
  ((match said with None -> "ok" | Some rule -> basic rule), word)

let fast_path_says line =
  let word = reader line in
  let view = read_view word in
  ((if fast_path view && check_t2 view (labels view) then "accepted" else "refused"), word)

(* The expectation of the lines that follow, and those met so far, each with the parts that are stored. *)
let expectation = ref plane
let forms = Hashtbl.create 128
let comment line = Stdlib.Option.iter (( := ) expectation) (expectation_of line)

let broken_of_expectation line =
  let structure, after, word = read_structure line in
  Hashtbl.replace forms (!expectation, structure.stored) ();
  let said = match first_broken_of !expectation structure with None -> "ok" | Some (Basic rule) -> basic rule | Some (Mesh rule) -> mesh rule in
  let pending = ref (Some after) in
  (said, fun () -> match !pending with Some first -> pending := None; first | None -> word ())

let compare_all verdict verdicts =
  let counts = Hashtbl.create 16 and tables = ref 0 and differences = ref 0 in
  each_line ~comment (fun line ->
      let ours, word = verdict line in
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
  if Hashtbl.length forms > 0 then Printf.printf "%d expectations with their parts\n" (Hashtbl.length forms);
  Printf.printf "%d tables, %d differences\n" !tables !differences;
  if !differences > 0 then exit 1

let rules = List.map basic [ R1; L1; L2; L3; V1; V2; B1; B2; F1; F2; T1; T2; T3 ]
let mesh_rules = List.map mesh [ M1; M2; M3; M4; M5; M6; M7; M8 ]

let () =
  let print_all verdict = each_line ~comment (fun line -> print_endline (fst (verdict line))) in
  match List.tl (Array.to_list Sys.argv) with
  | [] -> print_all broken_first
  | [ "--fast-path" ] -> print_all fast_path_says
  | [ "--expectations" ] -> print_all broken_of_expectation
  | [ "--compare" ] -> compare_all broken_first (rules @ [ "ok" ])
  | [ "--fast-path"; "--compare" ] -> compare_all fast_path_says [ "accepted"; "refused" ]
  | [ "--expectations"; "--compare" ] -> compare_all broken_of_expectation (rules @ [ basic T4 ] @ mesh_rules @ [ "ok" ])
  | _ ->
      prerr_endline "usage: judge [--fast-path | --expectations] [--compare] < tables";
      exit 2
