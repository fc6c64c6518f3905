(* A function from numbers that is changed at one number at a time: the realisation of Loops.memory. *)

module Numbers = Map.Make (Int)

type 'a t = { elsewhere : 'a; at : 'a Numbers.t }

let blank a = { elsewhere = a; at = Numbers.empty }
let read m i = match Numbers.find_opt i m.at with Some a -> a | None -> m.elsewhere
let write m i a = { m with at = Numbers.add i a m.at }
