(** * OperateExtraction: the operators as an OCaml program

    What is trusted of numbers and of memory is what Extraction.v says. *)

From twinedge Require Import View Rules Reference Extraction Operate.

Extraction "operators/checker.ml" first_broken after is_right vertex half_edge boundary face origin twin next prev
  boundary_of leaving isolated boundary_face boundary_start boundary_place outer inner_count inner.
