(** * Extraction: the checker and the fast path as an OCaml program

    [first_broken] and [fast_path] become OCaml, and [check_t2], which the fast path leaves to be checked. What this file says of numbers and of memory is not proved but trusted, and it is all
    that is:

    - a number is an `int` of OCaml (63 bits), and the seven functions below are the machine's;
    - a memory, which is a function here, is a `Map` from OCaml's standard library with a default: ocaml/memory.ml. *)

From Coq Require Import ExtrOcamlBasic ExtrOcamlNatInt.
From mathcomp Require Import all_ssreflect.
From twinedge Require Import View Rules Loops Reference FastPath Expectations ExpectationsCheck.

Extract Constant addn => "(+)".
Extract Constant muln => "( * )".
Extract Constant double => "(fun n -> 2 * n)".
Extract Constant subn => "(fun m n -> if m < n then 0 else m - n)".
Extract Inlined Constant eqn => "(fun (m : int) n -> m = n)".
Extract Inlined Constant leq => "(fun (m : int) n -> m <= n)".
Extract Inductive nat => int [ "0" "succ" ] "(fun zero succ n -> if n = 0 then zero () else succ (n - 1))".

Extract Constant memory "'a" => "'a Memory.t".
Extract Inlined Constant blank => "Memory.blank".
Extract Inlined Constant read => "Memory.read".
Extract Inlined Constant write => "Memory.write".

Extraction "checker.ml" first_broken fast_path check_t2 labels first_broken_of plane surface.
