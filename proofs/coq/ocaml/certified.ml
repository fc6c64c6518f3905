(* Says whether a folder is a certificate: see ../CERTIFICATE.md.

     certified FOLDER     exit code 0: valid; 1: not, with the tests that fail; 2: unreadable

   The verdict is that of the proved functions [judge], [judge_drawing] and [judge_surface]. The rest of this file reads the files and prints. *)

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

type claim = Plane_claim | Drawing_claim | Surface_claim

(* The claim to be judged; whether it is this one is for [judge] and its like to say. *)
let claim_of folder =
  let claim = content folder "claim.txt" in
  let claims line =
    let start = "twinedge certificate 1\n" ^ line ^ "\n" in
    String.length claim >= String.length start && String.sub claim 0 (String.length start) = start
  in
  if claims "drawing" then Drawing_claim else if claims "surface" then Surface_claim else Plane_claim

let read claim folder =
  let column name = content folder (name ^ ".u32") in
  let rows file = String.length file / 4 in
  let half_edge_origin = column "half_edge_origin" and vertex_leaving = column "vertex_leaving" in
  let boundary_face_column = column "boundary_face" and face_outer = column "face_outer" in
  let of_plane name = if claim = Surface_claim then "" else column name in
  let face_inner = of_plane "face_inner" in
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
    vertex_isolated = of_plane "vertex_isolated";
    boundary_face_column;
    boundary_start_column = column "boundary_start";
    boundary_vertex_column = of_plane "boundary_vertex";
    boundary_place_column = of_plane "boundary_place";
    face_outer;
    face_end = of_plane "face_end";
    face_inner;
  }

let read_surface folder surface_topology =
  let column name = content folder (name ^ ".u32") in
  {
    surface_topology;
    half_edge_turn = column "half_edge_turn";
    half_edge_step = column "half_edge_step";
    half_edge_component = column "half_edge_component";
    vertex_border = column "vertex_border";
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

(* Beyond the end of its file [ranks_in] is 0, which is lower than others; CERTIFICATE.md says that nil fails. *)
let rank_of folder h = if h < folder.half_edge_rows then ranks_in folder h else 1 lsl 32

(* The tests that fail, for a reader of the verdict "invalid": nothing depends on this. *)
let each view kind slots live tests =
  List.iter
    (fun (name, test) ->
      let failing = ref 0 and first = ref (-1) in
      for i = slots - 1 downto 0 do
        if live view i && not (test i) then begin incr failing; first := i end
      done;
      if !failing > 0 then Printf.printf "%s: %d of the %s, the first is %d\n" name !failing kind !first)
    tests

let explain_surface surface =
  let folder = surface.surface_topology and view = surface_view_in surface in
  let each kind = each view kind and border = borders_in surface and component = components_in surface and genus = surface_genus surface in
  each "half-edges" folder.half_edge_rows half_edge
    [ ("twin_ok", twin_ok view); ("next_ok", next_ok view); ("target_ok", target_ok view); ("origin_ok", origin_ok view);
      ("cycle_ok", cycle_ok view); ("turn_ok", turn_ok view (turns_in surface) genus); ("step_ok", step_ok view (steps_in surface) genus);
      ("component_ok", component_ok view component (rank_of folder)); ("border_ok", border_ok view border) ];
  each "vertices" folder.vertex_rows vertex [ ("surface_vertex_ok", surface_vertex_ok view) ];
  each "boundary components" folder.boundary_rows boundary [ ("surface_boundary_ok", surface_boundary_ok view) ];
  each "faces" folder.face_rows face [ ("surface_face_ok", surface_face_ok view) ];
  if 2 * (rotation_count view + cycle_count view) + 4 * surface_genus surface
     <> half_edge_count view + 4 * surface_components surface
  then print_endline "genus_ok"

let explain folder drawing =
  let view = view_in folder and rank = rank_of folder in
  let each kind = each view kind in
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

(* The claim in words, and why it is not so. *)
let judged name = function
  | Plane_claim ->
      let folder = read Plane_claim name in
      (judge folder, (fun () -> "a plane subdivision"), fun () -> explain folder None)
  | Drawing_claim ->
      let folder = read Drawing_claim name in
      let drawing = read_drawing name folder in
      (judge_drawing drawing, (fun () -> "a plane subdivision, drawn without crossings"), fun () -> explain folder (Some drawing))
  | Surface_claim ->
      let surface = read_surface name (read Surface_claim name) in
      let counted n what = Printf.sprintf "%d %s%s" n what (if n = 1 then "" else "s") in
      let words () =
        let holes = surface_holes surface in
        Printf.sprintf "a surface of genus %d with %s, %s" (surface_genus surface)
          (counted (surface_components surface) "component")
          (if holes = 0 then "closed" else "open at " ^ counted holes "hole")
      in
      (judge_surface surface, words, fun () -> explain_surface surface)

let () =
  match Sys.argv with
  | [| _; name |] -> (
      match judged name (claim_of name) with
      | Valid, words, _ -> print_endline ("valid: " ^ words ())
      | Invalid, _, explain ->
          print_endline "not valid";
          explain ();
          exit 1
      | Unreadable, _, _ ->
          prerr_endline "unreadable: the claim, the length of a column, a point that is not there, or a coordinate out of range";
          exit 2)
  | _ ->
      prerr_endline "usage: certified FOLDER";
      exit 2
