(* Writes certificates to try the checker with: grids whose cells hold islands and isolated vertices.

     grid WIDTH HEIGHT FOLDER             a grid; every other cell holds an island with a vertex inside, and a vertex
     grid --set COLUMN ROW VALUE FOLDER   changes one number of a certificate

   None of this is trusted: what it writes is what the checker judges. *)

let nil = 0xFFFFFFFF
let vacant = 0xFFFFFFFE

(* Vertices and half-edges, with directions: 0 east, 1 north, 2 west, 3 south. The twin of h is h lxor 1. *)
type drawing = {
  mutable vertices : int array list; (* of each vertex, the last one first: the half-edge that leaves it in each direction *)
  mutable vertex_count : int;
  mutable edges : (int * int * int * int) list; (* from, to, direction, the half-edge in whose face the component lies, or -1 *)
  mutable edge_count : int;
  mutable isolated : (int * int) list; (* a vertex, the half-edge in whose face it lies *)
}

let add_vertex d =
  let directions = Array.make 4 (-1) in
  d.vertices <- directions :: d.vertices;
  d.vertex_count <- d.vertex_count + 1;
  (d.vertex_count - 1, directions)

let add_edge d (u, u_directions) (v, v_directions) direction within =
  let h = 2 * d.edge_count in
  u_directions.(direction) <- h;
  v_directions.((direction + 2) mod 4) <- h + 1;
  d.edges <- (u, v, direction, within) :: d.edges;
  d.edge_count <- d.edge_count + 1;
  h

(* Returns, of each cell, the half-edge along its southern side. *)
let add_grid d width height within =
  let at = Array.init (height + 1) (fun _ -> Array.init (width + 1) (fun _ -> add_vertex d)) in
  let south = Array.make_matrix height width (-1) in
  for y = 0 to height do
    for x = 0 to width - 1 do
      let h = add_edge d at.(y).(x) at.(y).(x + 1) 0 within in
      if y < height then south.(y).(x) <- h
    done
  done;
  for y = 0 to height - 1 do
    for x = 0 to width do ignore (add_edge d at.(y).(x) at.(y + 1).(x) 1 within) done
  done;
  south

let draw width height =
  let d = { vertices = []; vertex_count = 0; edges = []; edge_count = 0; isolated = [] } in
  let south = add_grid d width height (-1) in
  Array.iteri
    (fun y row ->
      Array.iteri
        (fun x h ->
          if (x + y) mod 2 = 0 then begin
            let island = add_grid d 1 1 h in
            d.isolated <- (fst (add_vertex d), h) :: (fst (add_vertex d), island.(0).(0)) :: d.isolated
          end)
        row)
    south;
  d

let write_file folder name bytes =
  let channel = open_out_bin (Filename.concat folder name) in
  output_bytes channel bytes;
  close_out channel

let write folder name column =
  let bytes = Bytes.create (4 * Array.length column) in
  Array.iteri (fun i n -> Bytes.set_int32_le bytes (4 * i) (Int32.of_int n)) column;
  write_file folder (name ^ ".u32") bytes

let certify d folder =
  let around = Array.of_list (List.rev d.vertices) and edges = Array.of_list (List.rev d.edges) in
  let half_edges = 2 * d.edge_count in
  let origin = Array.make half_edges nil and towards = Array.make half_edges 0 and within = Array.make half_edges (-1) in
  Array.iteri
    (fun e (u, v, direction, inside) ->
      origin.(2 * e) <- u;
      origin.((2 * e) + 1) <- v;
      towards.(2 * e) <- direction;
      towards.((2 * e) + 1) <- (direction + 2) mod 4;
      within.(2 * e) <- inside;
      within.((2 * e) + 1) <- inside)
    edges;
  let twin = Array.init half_edges (fun h -> h lxor 1) in
  let next = Array.make half_edges nil and prev = Array.make half_edges nil in
  for h = 0 to half_edges - 1 do
    let directions = around.(origin.(twin.(h))) in
    let rec clockwise d = if directions.(d) >= 0 then directions.(d) else clockwise ((d + 3) mod 4) in
    let n = clockwise ((towards.(twin.(h)) + 3) mod 4) in
    next.(h) <- n;
    prev.(n) <- h
  done;
  (* The cycles; the counter-clockwise ones bound faces, from 1. *)
  let boundary = Array.make half_edges nil in
  let starts = ref [] and count = ref 0 and outers = ref [] and faces = ref 1 in
  for h = 0 to half_edges - 1 do
    if boundary.(h) = nil then begin
      let turns = ref 0 and g = ref h in
      while boundary.(!g) = nil do
        boundary.(!g) <- !count;
        let n = next.(!g) in
        (turns := !turns + match (towards.(n) - towards.(!g) + 4) mod 4 with 1 -> 1 | 2 -> -2 | 3 -> -1 | _ -> 0);
        g := n
      done;
      starts := (h, !turns > 0) :: !starts;
      if !turns > 0 then begin outers := !count :: !outers; incr faces end;
      incr count
    end
  done;
  let cycles = Array.of_list (List.rev !starts) and cycle_count = !count in
  let isolated = Array.of_list d.isolated in
  let boundaries = cycle_count + Array.length isolated in
  let face_outer = Array.append [| nil |] (Array.of_list (List.rev !outers)) in
  let face_of = Array.make boundaries 0 in
  Array.iteri (fun f b -> if b <> nil then face_of.(b) <- f) face_outer;
  let inside h = if h < 0 then 0 else face_of.(boundary.(h)) in
  let lists = Array.make !faces [] in
  let start = Array.make boundaries nil and at_vertex = Array.make boundaries nil and place = Array.make boundaries nil in
  Array.iteri (fun b (h, bounds) ->
      start.(b) <- h;
      if not bounds then begin face_of.(b) <- inside within.(h); lists.(face_of.(b)) <- b :: lists.(face_of.(b)) end) cycles;
  let leaving = Array.make d.vertex_count nil and isolated_in = Array.make d.vertex_count nil in
  Array.iteri (fun h v -> leaving.(v) <- h) origin;
  Array.iteri (fun i (v, h) ->
      let b = cycle_count + i in
      at_vertex.(b) <- v;
      isolated_in.(v) <- b;
      face_of.(b) <- inside h;
      lists.(face_of.(b)) <- b :: lists.(face_of.(b))) isolated;
  Array.iter (List.iteri (fun i b -> place.(b) <- i)) lists;
  let face_end = Array.make !faces 0 and total = ref 0 in
  Array.iteri (fun f list -> total := !total + List.length list; face_end.(f) <- !total) lists;
  (* The ranks, by a queue. *)
  let rank = Array.make half_edges nil and queue = Queue.create () and reached = Array.make half_edges false in
  let put h = if not reached.(h) then begin reached.(h) <- true; Queue.add h queue end in
  let put_inner f = List.iter (fun b -> if start.(b) <> nil then put start.(b)) lists.(f) in
  put_inner 0;
  let taken = ref 0 in
  while not (Queue.is_empty queue) do
    let h = Queue.pop queue in
    rank.(h) <- !taken;
    incr taken;
    put next.(h); put prev.(h); put twin.(h);
    let b = boundary.(h) in
    if start.(b) = h && place.(b) = nil then put_inner face_of.(b)
  done;
  if not (Sys.file_exists folder) then Sys.mkdir folder 0o755;
  write_file folder "claim.txt" (Bytes.of_string "twinedge certificate 1\nplane\n");
  (* With a vacant slot at the end of each kind. *)
  let first column = Array.append column [| vacant |] and other column = Array.append column [| 0 |] in
  List.iter
    (fun (name, column) -> write folder name column)
    [ ("half_edge_origin", first origin); ("half_edge_twin", other twin); ("half_edge_next", other next); ("half_edge_prev", other prev);
      ("half_edge_boundary", other boundary); ("half_edge_rank", other rank); ("vertex_leaving", first leaving); ("vertex_isolated", other isolated_in);
      ("boundary_face", first face_of); ("boundary_start", other start); ("boundary_vertex", other at_vertex); ("boundary_place", other place);
      ("face_outer", first face_outer); ("face_end", Array.append face_end [| !total |]);
      ("face_inner", Array.of_list (List.concat (Array.to_list lists))) ]

let set folder column row value =
  let name = column ^ ".u32" in
  let channel = open_in_bin (Filename.concat folder name) in
  let bytes = Bytes.of_string (really_input_string channel (in_channel_length channel)) in
  close_in channel;
  Bytes.set_int32_le bytes (4 * row) (Int32.of_int value);
  write_file folder name bytes

let () =
  match Sys.argv with
  | [| _; "--set"; column; row; value; folder |] -> set folder column (int_of_string row) (int_of_string value)
  | [| _; width; height; folder |] -> certify (draw (int_of_string width) (int_of_string height)) folder
  | _ ->
      prerr_endline "usage: grid WIDTH HEIGHT FOLDER | grid --set COLUMN ROW VALUE FOLDER";
      exit 2
