(* Says whether a folder is a certificate: see ../CERTIFICATE.md.

     certified FOLDER     exit code 0: valid; 1: not, with the tests that fail; 2: unreadable

   The verdict is that of the proved function [judge]. The rest of this file reads the files and prints. *)

open Certificate

(* A file, as a string. *)
let content folder name =
  let path = Filename.concat folder name in
  try
    let channel = open_in_bin path in
    let bytes = really_input_string channel (in_channel_length channel) in
    close_in channel;
    bytes
  with Sys_error _ | End_of_file | Invalid_argument _ ->
    Printf.eprintf "unreadable: %s\n" path;
    exit 2

let read folder =
  let column name = content folder (name ^ ".u32") in
  let rows file = String.length file / 4 in
  let half_edge_origin = column "half_edge_origin" and vertex_leaving = column "vertex_leaving" in
  let boundary_face_column = column "boundary_face" and face_outer = column "face_outer" in
  let face_inner = column "face_inner" in
  {
    claim = content folder "claim.txt";
    (* [readable] compares these with every column. *)
    half_edge_rows = rows half_edge_origin;
    vertex_rows = rows vertex_leaving;
    boundary_rows = rows boundary_face_column;
    face_rows = rows face_outer;
    inner_rows = rows face_inner;
    half_edge_origin;
    half_edge_twin = column "half_edge_twin";
    half_edge_next = column "half_edge_next";
    half_edge_prev = column "half_edge_prev";
    half_edge_boundary = column "half_edge_boundary";
    half_edge_rank = column "half_edge_rank";
    vertex_leaving;
    vertex_isolated = column "vertex_isolated";
    boundary_face_column;
    boundary_start_column = column "boundary_start";
    boundary_vertex_column = column "boundary_vertex";
    boundary_place_column = column "boundary_place";
    face_outer;
    face_end = column "face_end";
    face_inner;
  }

let read_drawing folder topology =
  let column name = content folder (name ^ ".u32") in
  let dart_twin_column = column "dart_twin" and point_x = content folder "point_x.i64" in
  {
    topology;
    triangle_rows = String.length dart_twin_column / 12;
    point_rows = String.length point_x / 8;
    dart_twin_column;
    dart_point_column = column "dart_point";
    dart_half_edge_column = column "dart_half_edge";
    dart_ahead_column = column "dart_ahead";
    dart_face_column = column "dart_face";
    dart_rank_column = column "dart_rank";
    point_x;
    point_y = content folder "point_y.i64";
    half_edge_dart_column = column "half_edge_dart";
    vertex_dart_column = column "vertex_dart";
    face_dart_column = column "face_dart";
  }

(* The tests that fail, for a reader of the verdict "invalid": nothing depends on this. *)
let explain folder drawing =
  let view = view_in folder and rank = ranks_in folder in
  let each kind slots live tests =
    List.iter
      (fun (name, test) ->
        let failing = ref 0 and first = ref (-1) in
        for i = slots - 1 downto 0 do
          if live view i && not (test i) then begin incr failing; first := i end
        done;
        if !failing > 0 then Printf.printf "%s: %d of the %s, the first is %d\n" name !failing kind !first)
      tests
  in
  each "half-edges" folder.half_edge_rows half_edge
    [ ("twin_ok", twin_ok view); ("next_ok", next_ok view); ("target_ok", target_ok view);
      ("origin_ok", origin_ok view); ("cycle_ok", cycle_ok view); ("rank_ok", rank_ok view rank) ];
  each "vertices" folder.vertex_rows vertex [ ("vertex_ok", vertex_ok view) ];
  each "boundary components" folder.boundary_rows boundary [ ("start_ok", start_ok view); ("place_ok", place_ok view) ];
  each "faces" folder.face_rows face [ ("face_ok", face_ok view) ];
  if not (one_unbounded view) then print_endline "one_unbounded";
  if not (euler_ok view) then print_endline "euler_ok";
  match drawing with
  | None -> ()
  | Some drawing ->
      let r = refinement_in drawing in
      let always _ _ = true in
      each "darts" (dart_count r) always
        [ ("dart_twin_ok", dart_twin_ok r); ("dart_point_ok", dart_point_ok r);
          ("dart_half_edge_ok", dart_half_edge_ok view r); ("dart_ahead_ok", dart_ahead_ok r);
          ("dart_face_ok", dart_face_ok view r); ("dart_rank_ok", dart_rank_ok r) ];
      each "triangles" r.triangle_count always [ ("triangle_ok", triangle_ok r) ];
      each "half-edges" folder.half_edge_rows half_edge
        [ ("half_edge_dart_ok", half_edge_dart_ok view r); ("rotation_ok", rotation_ok view r) ];
      each "vertices" folder.vertex_rows vertex [ ("vertex_dart_ok", vertex_dart_ok view r) ]

let claims_drawing folder =
  let start = "twinedge certificate 1\ndrawing\n" in
  String.length folder.claim >= String.length start && String.sub folder.claim 0 (String.length start) = start

let () =
  match Sys.argv with
  | [| _; name |] -> (
      let folder = read name in
      (* Which claim is to be judged; whether it is this one is for [judge] and [judge_drawing] to say. *)
      let drawing = if claims_drawing folder then Some (read_drawing name folder) else None in
      match match drawing with Some drawing -> judge_drawing drawing | None -> judge folder with
      | Valid -> print_endline (if drawing = None then "valid: a plane subdivision" else "valid: a plane subdivision, drawn without crossings")
      | Invalid ->
          print_endline "not valid";
          explain folder drawing;
          exit 1
      | Unreadable ->
          prerr_endline "unreadable: the claim, the length of a column, a point that is not there, or a coordinate out of range";
          exit 2)
  | _ ->
      prerr_endline "usage: certified FOLDER";
      exit 2
