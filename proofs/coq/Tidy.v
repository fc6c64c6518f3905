(** * Tidy: a core, with the rest made anew

    Whatever the core of a table is (Core.v), there is a rest that says the same. Of two half-edges that would do, the one with
    the lower number is kept. *)

From mathcomp Require Import all_ssreflect all_fingroup.
From twinedge Require Import View Rules Loops LoopsProof Map Counting Lists Core.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** The first of so many numbers for which [p] holds. *)
Definition first n (p : pred nat) : link := ohead [seq i <- iota 0 n | p i].

Lemma first_some n p i : first n p = Some i -> p i.
Proof.
rewrite /first; case E: [seq i <- iota 0 n | p i] => [|j s] //= -[<-].
suff : j \in [seq i <- iota 0 n | p i] by rewrite mem_filter => /andP[].
by rewrite E mem_head.
Qed.

Lemma first_none n (p : pred nat) i : first n p = None -> i < n -> ~~ p i.
Proof.
rewrite /first; case E: [seq i <- iota 0 n | p i] => [|//] _ lt; apply/negP=> pi.
by have : i \in [seq i <- iota 0 n | p i]; [rewrite mem_filter mem_iota pi lt|rewrite E].
Qed.

(** The inner boundary components of a face, in the order of their numbers. *)
Definition inner_of n (inn : pred nat) f :=
  [seq b <- iota 0 (boundary_slots n) | [&& boundary n b, inn b & boundary_face n b == Some f]].

(** The core of [n], with the rest made anew: of two that would do, the one with the lower number is kept or listed first. *)
Definition tidy n (inn : pred nat) : view := {|
  vertex_slots := vertex_slots n;
  half_edge_slots := half_edge_slots n;
  boundary_slots := boundary_slots n;
  face_slots := face_slots n;
  is_vertex := is_vertex n;
  is_half_edge := is_half_edge n;
  is_boundary := is_boundary n;
  is_face := is_face n;
  says_origin := says_origin n;
  says_twin := says_twin n;
  says_next := says_next n;
  says_prev := fun h => first (half_edge_slots n) (fun g => next n g == Some h);
  says_boundary := says_boundary n;
  says_leaving := fun v => first (half_edge_slots n) (fun h => origin n h == Some v);
  says_isolated := says_isolated n;
  says_boundary_face := says_boundary_face n;
  says_boundary_start := fun b =>
    if first (half_edge_slots n) (fun h => boundary_of n h == Some b) is Some h then Some (AtHalfEdge h) else
    if first (vertex_slots n) (fun v => isolated n v == Some b) is Some v then Some (AtVertex v) else None;
  says_boundary_place := fun b => if inn b then
    if boundary_face n b is Some f then Some (Inner (seq.index b (inner_of n inn f))) else None else Some Outer;
  says_outer := fun f => first (boundary_slots n) (fun b => ~~ inn b && (boundary_face n b == Some f));
  says_inner_count := fun f => size (inner_of n inn f);
  says_inner := fun f i => nth None [seq Some b | b <- inner_of n inn f] i
|}.

Section Tidy.
Variables (n : view) (inn : pred nat).
Hypothesis c : core n inn.

Notation t := (tidy n inn).

(** The core is the same. *)
Lemma tidy_connected u v : connected n u v -> connected t u v.
Proof. by elim=> [|h x y _ IH O T]; [apply: connected_self|apply: (@connected_edge t u h x y IH)]. Qed.

Lemma tidy_steps f : steps_out n inn f -> steps_out t inn f.
Proof.
elim=> {f} [f lf no|f b v d w g F I P J Q C G _ IH]; first exact: (@out_here t).
exact: (@out_through t inn f b v d w g) (tidy_connected C) G IH.
Qed.

Lemma tidy_core : core t inn.
Proof.
case: c => live l1 inj l3 rot side cyc bare iso one used fc out unb inside steps counts; split=> //.
  by move=> v /inside[b [w [lb I P C]]]; exists b, w; split=> //; apply: tidy_connected.
by move=> f /steps; apply: tidy_steps.
Qed.

Lemma inner_ofP f b : b \in inner_of n inn f <-> inn b /\ boundary_face n b = Some f.
Proof.
rewrite mem_filter mem_iota add0n; split=> [/andP[/and3P[_ I /eqP F] _] //|[I F]].
by rewrite (heard_live F) I F eqxx /= boundary_below ?(heard_live F).
Qed.

Lemma next_onto h : half_edge n h -> exists2 g, half_edge n g & next n g = Some h.
Proof.
pose dart := [finType of slot (half_edge_slots n) (half_edge n)]; move=> lh.
have total g : half_edge n g -> exists2 g', next n g = Some g' & half_edge n g' by move/(core_live c)=> [].
have E x : next n (num x) = Some (num (step (next n) x : dart)) := says_step (@half_edge_below n) total x.
have inj : injective (step (next n) : dart -> dart).
  by move=> x y xy; apply: num_inj; apply: (core_next c); rewrite ?num_live // !E xy.
have [x xh] : exists x : dart, num x = h := slotP (@half_edge_below n) lh.
exists (num (invF inj x)); first exact: num_live.
by rewrite E f_invF xh.
Qed.

Lemma tidy_rest : rest t inn.
Proof.
have placeE b f : boundary_face n b = Some f -> boundary_place t b =
    Some (if inn b then Inner (seq.index b (inner_of n inn f)) else Outer).
  by move=> F; rewrite /boundary_place /heard -[boundary t b]/(boundary n b) (heard_live F) /= F; case: (inn b).
have uniq_of f : uniq (inner_of n inn f) by rewrite filter_uniq ?iota_uniq.
have innerE f i b : face n f -> inner t f i = Some b <-> b \in inner_of n inn f /\ seq.index b (inner_of n inn f) = i.
  move=> lf; rewrite /inner /inner_count -[face t f]/(face n f) lf /=; exact: listed_at.
have outerE f b : face n f -> outer t f = Some b <-> ~~ inn b /\ boundary_face n b = Some f.
  move=> lf; rewrite /outer /heard -[face t f]/(face n f) lf /=; split=> [/first_some/andP[I /eqP F] //|[I F]].
  case E: (first _ _) => [d|].
    have/andP[Id /eqP Fd] := first_some E; congr Some; apply: (core_outer c) => //; rewrite ?Fd //; exact: heard_live Fd.
  by have := first_none E (boundary_below (heard_live F)); rewrite I F eqxx.
split.
- move=> h lh; have [g lg N] := next_onto lh.
  have P : prev t h = first (half_edge_slots n) (fun g => next n g == Some h).
    by rewrite /prev /heard lh.
  rewrite P; case E: (first _ _) => [g'|]; first by have/eqP N' := first_some E; split=> //; exists g' => //; apply: heard_live N'.
  by have := first_none E (half_edge_below lg); rewrite N eqxx.
- move=> v lv; have L : leaving t v = first (half_edge_slots n) (fun h => origin n h == Some v).
    by rewrite /leaving /heard lv.
  rewrite L; case E: (first _ _) => [h|]; first by left; exists h => //; apply/eqP/(first_some E).
  by right; split=> // h lh O; have := first_none E (half_edge_below lh); rewrite -[origin n h]/(origin t h) O eqxx.
- move=> b lb; have S : boundary_start t b = says_boundary_start t b.
    by rewrite /boundary_start /heard lb.
  rewrite S /=; case E: (first _ _) => [h|]; first by left; exists h => //; apply/eqP/(first_some E).
  right; case D: (first _ _) => [v|]; first by exists v => //; apply/eqP/(first_some D).
  have [v [[h B _]|I]] := core_used c lb.
    by have := first_none E (half_edge_below (heard_live B)); rewrite B eqxx.
  by have := first_none D (vertex_below (heard_live I)); rewrite I eqxx.
- move=> b lb; have [f F lf] := core_face c lb; exists f, (if inn b then Inner (seq.index b (inner_of n inn f)) else Outer).
  rewrite (placeE b f F); split=> //; last by case: (inn b).
  case I: (inn b); first by apply/innerE => //; split=> //; apply/inner_ofP.
  by apply/outerE; rewrite ?I.
- move=> f p b L; have lf : face n f.
    by case: p L => [|i] L; [exact: heard_live L|move: L; rewrite /= /inner /inner_count -[face t f]/(face n f); case: (face n f)].
  case: p L => [/(outerE f b lf)[I F]|i /(innerE f i b lf)[/inner_ofP[I F] <-]]; by rewrite (placeE b f F) ?I ?(negPf I).
move=> f i; rewrite /inner => lt; rewrite lt /=; move: lt; rewrite /inner_count -[face t f]/(face n f); case: (face n f) => //= lt.
by rewrite (nth_map 0).
Qed.

(** If the core is right, and the rest is made anew, all rules hold. *)
Theorem tidy_rules : rules t. Proof. exact: core_rules tidy_core tidy_rest. Qed.

End Tidy.
