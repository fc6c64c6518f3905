(** * Loops: the loops and the memory of the checker

    What a Rust programmer writes as a `for` loop, as a walk with a limit, and as a vector that is written to. Each loop
    is tail-recursive, so that the extracted program runs in constant stack. What each one computes is proved in
    LoopsProof.v. *)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import View.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** ** Memory: a function from numbers

    The extracted program keeps it in a `Map` of OCaml's standard library: see Extraction.v. *)

Definition memory (A : Type) := nat -> A.
Definition blank A (a : A) : memory A := fun _ => a.
Definition read A (m : memory A) (i : nat) : A := m i.
Definition write A (m : memory A) (i : nat) (a : A) : memory A := fun j => if j == i then a else m j.

(** ** For loops, from [n - 1] down to [0] *)

(** `(0..n).all(p)` *)
Fixpoint all_below n (p : nat -> bool) : bool :=
  if n is m.+1 then if p m then all_below m p else false else true.

(** `(0..n).rev().fold(a, f)` *)
Fixpoint fold_below A n (f : A -> nat -> A) (a : A) : A :=
  if n is m.+1 then fold_below m f (f a m) else a.

(** The number of [i] below [n] with the key [k], for every [k]. *)
Definition tally n (key : nat -> link) : memory nat :=
  fold_below n (fun m i => if key i is Some k then write m k (read m k).+1 else m) (blank 0).

(** The value of some [i] below [n] that has the key [k], for every [k]. *)
Definition recall n (key value : nat -> link) : memory link :=
  fold_below n (fun m i => if key i is Some k then write m k (value i) else m) (blank None).

(** ** A walk that returns to where it set out: how many steps it takes, if no more than [fuel] *)

Fixpoint walk fuel (step : nat -> link) first x steps : option nat :=
  if fuel is less.+1 then
    if step x is Some y then if y == first then Some steps.+1 else walk less step first y steps.+1 else None
  else None.

Definition round_trip fuel step first := walk fuel step first first 0.

(** ** Flood: everything that is reached from [root] is labelled with it

<<
      stack   h │ …        label h, push its neighbours
>>
*)

Definition push (l : link) s := if l is Some x then x :: s else s.

Fixpoint flood fuel (near : nat -> seq nat) root (stack : seq nat) (label : memory link) : memory link :=
  if fuel is less.+1 then
    if stack is x :: rest then
      if read label x is Some _ then flood less near root rest label
      else flood less near root (catrev (near x) rest) (write label x (Some root))
    else label
  else label.

(** Every live number below [n] is labelled, those that are joined alike. *)
Definition flood_all fuel n (live : nat -> bool) near : memory link :=
  fold_below n (fun label x =>
    if live x then if read label x is Some _ then label else flood fuel near x [:: x] label else label) (blank None).

(** ** Climb: from each number upwards, until the top or what is known to lead there

    [climb] is the path up to there, if it takes no more than [fuel] steps. *)

Fixpoint climb fuel (up : nat -> link) (good : memory bool) (path : seq nat) x : option (seq nat) :=
  if read good x then Some path else
  if up x is Some y then if fuel is less.+1 then climb less up good (x :: path) y else None
  else Some (x :: path).

Fixpoint mark (path : seq nat) (good : memory bool) : memory bool :=
  if path is x :: rest then mark rest (write good x true) else good.

(** True if every live number below [m] leads to the top. [n] bounds the steps. *)
Fixpoint all_climb n m (live : nat -> bool) up (good : memory bool) : bool :=
  if m is k.+1 then
    if live k then if climb n up good [::] k is Some path then all_climb n k live up (mark path good) else false
    else all_climb n k live up good
  else true.
