(* Writes certificates to try the checker with: grids whose cells hold islands and isolated vertices.

     grid WIDTH HEIGHT FOLDER             a grid; every other cell holds an island with a vertex inside, and a vertex
     grid --torus SIZE FOLDER             a torus of squares with a hole
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
  mutable places : (int * int) list; (* of each vertex, the last one first *)
  mutable triangles : (int * int * int) list; (* counter-clockwise; the outer corners are -1, -2 and -3 *)
}

let add_vertex d place =
  let directions = Array.make 4 (-1) in
  d.places <- place :: d.places;
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

let add_triangles d list = d.triangles <- list @ d.triangles

(* Returns the vertices, and of each cell the half-edge along its southern side. *)
let add_grid d (left, bottom) cell width height within =
  let at = Array.init (height + 1) (fun y -> Array.init (width + 1) (fun x -> add_vertex d (left + (cell * x), bottom + (cell * y)))) in
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
  (Array.map (Array.map fst) at, south)

(* A cell with an island, a vertex on the island, and a vertex south of it. *)
let add_island d (left, bottom) h (sw, se, ne, nw) =
  let at, south = add_grid d (left + 4, bottom + 4) 4 1 1 h in
  let inside = fst (add_vertex d (left + 6, bottom + 6)) and below = fst (add_vertex d (left + 6, bottom + 2)) in
  d.isolated <- (below, h) :: (inside, south.(0).(0)) :: d.isolated;
  let sw' = at.(0).(0) and se' = at.(0).(1) and ne' = at.(1).(1) and nw' = at.(1).(0) in
  add_triangles d
    [ (sw', se', inside); (se', ne', inside); (ne', nw', inside); (nw', sw', inside);
      (sw, se, below); (se, se', below); (se', sw', below); (sw', sw, below);
      (se, ne, ne'); (se, ne', se'); (ne, nw, nw'); (ne, nw', ne'); (nw, sw, sw'); (nw, sw', nw') ]

let draw width height =
  let d = { vertices = []; vertex_count = 0; edges = []; edge_count = 0; isolated = []; places = []; triangles = [] } in
  let at, south = add_grid d (0, 0) 12 width height (-1) in
  Array.iteri
    (fun y row ->
      Array.iteri
        (fun x h ->
          let sw = at.(y).(x) and se = at.(y).(x + 1) and ne = at.(y + 1).(x + 1) and nw = at.(y + 1).(x) in
          if (x + y) mod 2 = 0 then add_island d (12 * x, 12 * y) h (sw, se, ne, nw)
          else add_triangles d [ (sw, se, ne); (sw, ne, nw) ])
        row)
    south;
  for x = 0 to width - 1 do
    add_triangles d [ (at.(0).(x + 1), at.(0).(x), -1); (at.(height).(x), at.(height).(x + 1), -3) ]
  done;
  for y = 0 to height - 1 do
    add_triangles d [ (at.(y + 1).(width), at.(y).(width), -2); (at.(y).(0), at.(y + 1).(0), -1) ]
  done;
  add_triangles d [ (at.(0).(width), -1, -2); (at.(height).(width), -2, -3); (at.(height).(0), -3, -1) ];
  d

let write_file folder name bytes =
  let channel = open_out_bin (Filename.concat folder name) in
  output_bytes channel bytes;
  close_out channel

let write folder name column =
  let bytes = Bytes.create (4 * Array.length column) in
  Array.iteri (fun i n -> Bytes.set_int32_le bytes (4 * i) (Int32.of_int n)) column;
  write_file folder (name ^ ".u32") bytes

let write_long folder name column =
  let bytes = Bytes.create (8 * Array.length column) in
  Array.iteri (fun i n -> Bytes.set_int64_le bytes (8 * i) (Int64.of_int n)) column;
  write_file folder (name ^ ".i64") bytes

(* The triangulation, for a map whose half-edges have these links and faces; points are far apart, to have large numbers. *)
let certify_drawing d folder origin twin prev face_of_half_edge face_of_isolated faces =
  let corner p = if p < 0 then d.vertex_count - p else p in
  let triangles = Array.of_list ((-1, -3, -2) :: d.triangles) in
  let darts = 3 * Array.length triangles in
  let point = Array.make darts 0 in
  Array.iteri (fun i (p, q, r) -> List.iteri (fun j p -> point.((3 * i) + j) <- corner p) [ p; q; r ]) triangles;
  let next e = if e mod 3 = 2 then e - 2 else e + 1 in
  let at = Hashtbl.create darts in
  Array.iteri (fun e p -> Hashtbl.replace at (p, point.(next e)) e) point;
  let dart_twin = Array.init darts (fun e -> Hashtbl.find at (point.(next e), point.(e))) in
  let half_edge_dart = Array.mapi (fun h u -> Hashtbl.find at (u, origin.(twin.(h)))) origin in
  let dart_half_edge = Array.make darts nil in
  Array.iteri (fun h e -> dart_half_edge.(e) <- h) half_edge_dart;
  (* Backwards around the origin of each half-edge, until the half-edge before it. *)
  let ahead = Array.make darts 0 in
  Array.iteri
    (fun h e ->
      let rec back e = ahead.(e) <- h; let before = next dart_twin.(e) in if dart_half_edge.(before) = nil then back before in
      back e)
    half_edge_dart;
  (* The faces: from the darts of half-edges and isolated vertices over added edges. *)
  let vertex_dart = Array.make d.vertex_count 0 in
  Array.iteri (fun e p -> if p < d.vertex_count then vertex_dart.(p) <- e) point;
  let dart_face = Array.make darts nil and rank = Array.make darts 0 and face_dart = Array.make faces nil in
  let fill face first =
    if face_dart.(face) = nil then begin
      face_dart.(face) <- first;
      let queue = Queue.create () and taken = ref 0 in
      let put e = if dart_face.(e) = nil then begin dart_face.(e) <- face; Queue.add e queue end in
      put first;
      while not (Queue.is_empty queue) do
        let e = Queue.pop queue in
        rank.(e) <- !taken;
        incr taken;
        put (next (next e));
        if dart_half_edge.(e) = nil then put dart_twin.(e)
      done
    end
  in
  Array.iteri (fun h e -> fill (face_of_half_edge h) e) half_edge_dart;
  List.iter (fun (v, face) -> fill face vertex_dart.(v)) face_of_isolated;
  let longest = 4 * List.fold_left (fun m (x, y) -> max m (max x y)) 0 d.places in
  let places = Array.of_list (List.rev_append d.places [ (0, 0); (-longest, -longest); (2 * longest, -longest); (longest / 2, 3 * longest) ]) in
  let unit = 1 lsl 34 in
  List.iter
    (fun (name, column) -> write folder name column)
    [ ("dart_twin", dart_twin); ("dart_point", point); ("dart_half_edge", dart_half_edge); ("dart_ahead", ahead);
      ("dart_face", dart_face); ("dart_rank", rank); ("half_edge_dart", Array.append half_edge_dart [| 0 |]);
      ("vertex_dart", Array.append vertex_dart [| 0 |]); ("face_dart", Array.append face_dart [| 0 |]) ];
  write_long folder "point_x" (Array.map (fun (x, _) -> unit * x) places);
  write_long folder "point_y" (Array.map (fun (_, y) -> unit * y) places)

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
  write_file folder "claim.txt" (Bytes.of_string "twinedge certificate 1\ndrawing\n");
  (* With a vacant slot at the end of each kind. *)
  let first column = Array.append column [| vacant |] and other column = Array.append column [| 0 |] in
  List.iter
    (fun (name, column) -> write folder name column)
    [ ("half_edge_origin", first origin); ("half_edge_twin", other twin); ("half_edge_next", other next); ("half_edge_prev", other prev);
      ("half_edge_boundary", other boundary); ("half_edge_rank", other rank); ("vertex_leaving", first leaving); ("vertex_isolated", other isolated_in);
      ("boundary_face", first face_of); ("boundary_start", other start); ("boundary_vertex", other at_vertex); ("boundary_place", other place);
      ("face_outer", first face_outer); ("face_end", Array.append face_end [| !total |]);
      ("face_inner", Array.of_list (List.concat (Array.to_list lists))) ];
  certify_drawing d folder origin twin prev (fun h -> face_of.(boundary.(h)))
    (Array.to_list (Array.map (fun (v, h) -> (v, inside h)) isolated)) !faces

(* A torus of squares, of which number 0 is a hole, with a vertex that has no edges. Half-edge 4 f + i is side i of square f, counter-clockwise
   from its south. *)
let certify_torus n folder =
  let square x y = ((x + n) mod n) + (n * ((y + n) mod n)) in
  let squares = n * n in
  let of_side column = Array.init (4 * squares) (fun h -> column (h / 4 mod n) (h / 4 / n) (h mod 4)) in
  let origin = of_side (fun x y i -> square (x + [| 0; 1; 1; 0 |].(i)) (y + [| 0; 0; 1; 1 |].(i))) in
  let twin =
    of_side (fun x y i -> (4 * [| square x (y - 1); square (x + 1) y; square x (y + 1); square (x - 1) y |].(i)) + ((i + 2) mod 4)) in
  let next = Array.init (4 * squares) (fun h -> (h land lnot 3) + ((h + 1) land 3)) in
  let prev = Array.init (4 * squares) (fun h -> (h land lnot 3) + ((h + 3) land 3)) in
  let turn = Array.make (4 * squares) 0 in
  for v = 0 to squares - 1 do
    let rec walk h i = if h <> 4 * v || i = 0 then begin turn.(h) <- i; walk next.(twin.(h)) (i + 1) end in
    walk (4 * v) 0
  done;
  let rank = Array.make (4 * squares) nil and queue = Queue.create () and taken = ref 0 in
  let put h = if rank.(h) = nil then begin rank.(h) <- !taken; incr taken; Queue.add h queue end in
  put 0;
  while not (Queue.is_empty queue) do
    let h = Queue.pop queue in
    put next.(h); put prev.(h); put twin.(h)
  done;
  let border = Array.make (squares + 1) nil in
  for h = 0 to 3 do border.(origin.(h)) <- h done;
  if not (Sys.file_exists folder) then Sys.mkdir folder 0o755;
  write_file folder "claim.txt" (Bytes.of_string "twinedge certificate 1\nsurface\n");
  (* With a vacant slot at the end of each kind but vertices. *)
  let last number column = Array.append column [| number |] in
  List.iter
    (fun (name, column) -> write folder name column)
    [ ("half_edge_origin", last vacant origin); ("half_edge_twin", last 0 twin); ("half_edge_next", last 0 next); ("half_edge_prev", last 0 prev);
      ("half_edge_boundary", last 0 (of_side (fun x y _ -> square x y))); ("half_edge_turn", last 0 turn);
      ("half_edge_step", last 0 (of_side (fun _ _ i -> i))); ("half_edge_component", last 0 (Array.make (4 * squares) 0));
      ("half_edge_rank", last 0 rank); ("vertex_leaving", last nil (Array.init squares (fun v -> 4 * v))); ("vertex_border", border);
      ("boundary_face", last vacant (Array.init squares (fun b -> if b = 0 then nil else b - 1)));
      ("boundary_start", last 0 (Array.init squares (fun b -> 4 * b))); ("face_outer", last vacant (Array.init (squares - 1) succ)) ]

let set folder column row value =
  let long = Sys.file_exists (Filename.concat folder (column ^ ".i64")) in
  let name = column ^ if long then ".i64" else ".u32" in
  let channel = open_in_bin (Filename.concat folder name) in
  let bytes = Bytes.of_string (really_input_string channel (in_channel_length channel)) in
  close_in channel;
  if long then Bytes.set_int64_le bytes (8 * row) (Int64.of_int value)
  else Bytes.set_int32_le bytes (4 * row) (Int32.of_int value);
  write_file folder name bytes

let () =
  match Sys.argv with
  | [| _; "--set"; column; row; value; folder |] -> set folder column (int_of_string row) (int_of_string value)
  | [| _; "--torus"; size; folder |] -> certify_torus (int_of_string size) folder
  | [| _; width; height; folder |] -> certify (draw (int_of_string width) (int_of_string height)) folder
  | _ ->
      prerr_endline "usage: grid WIDTH HEIGHT FOLDER | grid --torus SIZE FOLDER | grid --set COLUMN ROW VALUE FOLDER";
      exit 2
