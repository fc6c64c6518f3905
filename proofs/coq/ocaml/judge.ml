(* Reads tables as text, one a line, and says of each which rule the proved checker finds broken first.

     judge < tables                prints the verdict of each line: a rule, or ok
     judge --fast-path < tables    prints what the proved fast path says, and of T2, which it leaves, the checker: accepted or refused
     judge [--fast-path] --compare < tables
                                   takes lines that end in a verdict, prints those that differ, and counts

   Both ask of live records only: a question about any other slot would end the program.

   tables.ml says what a line is. *)

open Checker
open Tables

let broken_first view =
  match first_broken view with
  | None -> "ok"
  | Some R1 -> "R1" | Some L1 -> "L1" | Some L2 -> "L2" | Some L3 -> "L3" | Some V1 -> "V1" | Some V2 -> "V2"
  | Some B1 -> "B1" | Some B2 -> "B2" | Some F1 -> "F1" | Some F2 -> "F2"
  | Some T1 -> "T1" | Some T2 -> "T2" | Some T3 -> "T3" | Some T4 -> "T4"

let fast_path_says view = if fast_path view && check_t2 view (labels view) then "accepted" else "refused"

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
