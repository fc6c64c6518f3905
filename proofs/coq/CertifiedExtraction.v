(** * CertifiedExtraction: the checker of certificates as an OCaml program

    [judge] becomes OCaml. What this file says is trusted, and it is all that is: a number is an `int` of OCaml (63 bits),
    on which the functions below are the machine's; the content of a file is a `string`. *)

From Coq Require Import ExtrOcamlBasic ExtrOcamlNatInt.
From mathcomp Require Import all_ssreflect.
From twinedge Require Import View Loops Reference Labels Columns Certified.

Extract Constant addn => "(+)".
Extract Constant muln => "( * )".
Extract Constant subn => "(fun m n -> if m < n then 0 else m - n)".
Extract Inlined Constant eqn => "(fun (m : int) n -> m = n)".
Extract Inlined Constant leq => "(fun (m : int) n -> m <= n)".
Extract Inductive nat => int [ "0" "succ" ] "(fun zero succ n -> if n = 0 then zero () else succ (n - 1))".

Extract Constant file => "string".
Extract Inlined Constant bytes_in => "String.length".
Extract Constant byte => "(fun f i -> if 0 <= i && i < String.length f then Char.code (String.unsafe_get f i) else 0)".

Extraction "certificate.ml" judge view_in ranks_in twin_ok next_ok target_ok origin_ok cycle_ok rank_ok
  vertex_ok start_ok place_ok face_ok one_unbounded euler_ok half_edge vertex boundary face.
