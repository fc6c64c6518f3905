(** * CertifiedExtraction: the checker of certificates as an OCaml program

    [judge], [judge_drawing] and [judge_surface] become OCaml. What this file says is trusted, and it is all that is: a number, natural or
    integer, is an `int` of OCaml (63 bits), on which the functions below are the machine's; the content of a file is a
    `string`. Coordinates are below 2^53 ([in_range]), differences below 2^54, their parts ([high], [low]) at most 2^27, and
    sums of four products of these below 2^57. *)

From Coq Require Import ExtrOcamlBasic ExtrOcamlNatInt ExtrOcamlZInt ZArith.
From mathcomp Require Import all_ssreflect.
From twinedge Require Import View Loops Reference Labels Surface Coordinates Columns Certified.

Extract Constant addn => "(+)".
Extract Constant muln => "( * )".
Extract Constant subn => "(fun m n -> if m < n then 0 else m - n)".
Extract Inlined Constant eqn => "(fun (m : int) n -> m = n)".
Extract Inlined Constant leq => "(fun (m : int) n -> m <= n)".
Extract Inductive nat => int [ "0" "succ" ] "(fun zero succ n -> if n = 0 then zero () else succ (n - 1))".

Extract Constant modn => "(mod)".
Extract Constant divn => "(fun m n -> if n = 0 then 0 else m / n)".
Extract Constant Z.of_nat => "(fun n -> n)".
Extract Constant wrap => "(1 lsl 56)".
Extract Constant high => "(fun x -> x asr 27)".
Extract Constant low => "(fun x -> x land 0x7FFFFFF)".

Extract Constant file => "string".
Extract Inlined Constant bytes_in => "String.length".
Extract Constant byte => "(fun f i -> if 0 <= i && i < String.length f then Char.code (String.unsafe_get f i) else 0)".

Extraction "certificate.ml" judge view_in ranks_in twin_ok next_ok target_ok origin_ok cycle_ok rank_ok
  vertex_ok start_ok place_ok face_ok one_unbounded euler_ok half_edge vertex boundary face
  judge_drawing refinement_in dart_count triangle_count dart_twin_ok dart_point_ok dart_half_edge_ok dart_ahead_ok dart_face_ok
  dart_rank_ok triangle_ok half_edge_dart_ok rotation_ok vertex_dart_ok
  judge_surface surface_view_in turns_in steps_in components_in surface_ranks_in borders_in surface_genus surface_components
  surface_holes turn_ok step_ok component_ok border_ok surface_vertex_ok surface_boundary_ok surface_face_ok rotation_count
  cycle_count half_edge_count.
