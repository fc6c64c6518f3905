(** * Tidy: a core, with the rest made anew

    Whatever the core of a table is (Core.v), there is a rest that says the same. [relist] makes the places and the lists of the
    boundary components anew, and [tidy] also [prev] and the half-edges that are kept: of two that would do, it keeps the one with
    the lower number. *)

From mathcomp Require Import all_ssreflect all_fingroup.
From twinedge Require Import View Rules Loops LoopsProof Map Counting Lists Core.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** The core of a view is these answers: another with the same ones has the same core. *)
Lemma core_same t t' inn : vertex t' = vertex t -> half_edge t' = half_edge t -> boundary t' = boundary t -> face t' = face t ->
  origin t' = origin t -> twin t' = twin t -> next t' = next t -> boundary_of t' = boundary_of t ->
  isolated t' = isolated t -> boundary_face t' = boundary_face t -> core t inn -> core t' inn.
Proof.
move=> V H B F O T N S I G c.
have C u w : connected t u w -> connected t' u w.
  elim=> [|h x y _ IH X Y]; first exact: connected_self.
  by apply: (@connected_edge t' u h x y IH); rewrite /target ?T ?O.
have P b v : passes t b v -> passes t' b v by rewrite /passes S O I.
have out f : steps_out t inn f -> steps_out t' inn f.
  elim=> {f} [f lf no|f b v d w g Fb Ib Pb Id Pd Cd Fd _ IH].
    by apply: out_here => [|b]; rewrite ?F ?G //; apply: no.
  by apply: (@out_through t' inn f b v d w g) => //; rewrite ?G //; auto.
have turns : turn t' = turn t by rewrite /turn T N.
case: c => live l1 inj l3 rot side cyc bare iso one used fc o unb inside steps counts; split.
- by rewrite H V B O T N S.
- by rewrite /l1_twin H T.
- by rewrite H N.
- by rewrite /l3_target H N T O.
- by rewrite H O turns.
- by rewrite H N S.
- by rewrite H S /on_cycle N.
- by rewrite V B I /Rules.bare H O.
- by rewrite I S /Rules.bare H O.
- by rewrite I.
- by rewrite B => b /used[v /P]; exists v.
- by rewrite B F G.
- by rewrite G B.
- by rewrite F /no_outer G.
- by rewrite V B => v /inside[b [w [lb Ib /P Pb /C Cw]]]; exists b, w.
- by rewrite F => f /steps /out.
by rewrite /core_count V H F B.
Qed.

(** The inner boundary components of a face, in the order of their numbers. *)
Definition inner_of n (inn : pred nat) f :=
  [seq b <- iota 0 (boundary_slots n) | [&& boundary n b, inn b & boundary_face n b == Some f]].

(** The first of so many numbers for which [p] holds. *)
Definition first n (p : pred nat) : link := ohead [seq i <- iota 0 n | p i].

(** The view [n], with places and lists that say what its core says. *)
Definition relist n (inn : pred nat) : view := {|
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
  says_prev := says_prev n;
  says_boundary := says_boundary n;
  says_leaving := says_leaving n;
  says_isolated := says_isolated n;
  says_boundary_face := says_boundary_face n;
  says_boundary_start := says_boundary_start n;
  says_boundary_place := fun b => if inn b then
    if boundary_face n b is Some f then Some (Inner (seq.index b (inner_of n inn f))) else None else Some Outer;
  says_outer := fun f => first (boundary_slots n) (fun b => ~~ inn b && (boundary_face n b == Some f));
  says_inner_count := fun f => size (inner_of n inn f);
  says_inner := fun f i => nth None [seq Some b | b <- inner_of n inn f] i
|}.

(** The inner ones are those that are told. *)
Lemma relist_inn n inn b : boundary n b -> inn_of (relist n inn) b = inn b.
Proof.
move=> lb; rewrite /inn_of /boundary_place /heard -[boundary (relist n inn) b]/(boundary n b) lb /=.
by case: (inn b) => //; case: boundary_face.
Qed.

(** The view [n], with [prev] and kept half-edges that say what its core says. *)
Definition refind n : view := {|
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
  says_boundary_place := says_boundary_place n;
  says_outer := says_outer n;
  says_inner_count := says_inner_count n;
  says_inner := says_inner n
|}.

(** The core of [n], with the rest made anew. *)
Definition tidy n inn : view := relist (refind n) inn.

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

Section Relist.
Variables (n : view) (inn : pred nat).
Hypothesis c : core n inn.
Hypothesis prev_right : forall h, half_edge n h -> leads_to (half_edge n) (prev n h) /\ prev n h >>= next n = Some h.
Hypothesis leaving_right : forall v, vertex n v ->
  (exists2 h, leaving n v = Some h & origin n h = Some v) \/ leaving n v = None /\ bare n v.
Hypothesis start_right : forall b, boundary n b ->
  (exists2 h, boundary_start n b = Some (AtHalfEdge h) & boundary_of n h = Some b) \/
  exists2 v, boundary_start n b = Some (AtVertex v) & isolated n v = Some b.

Notation t := (relist n inn).

Lemma inner_ofP f b : b \in inner_of n inn f <-> inn b /\ boundary_face n b = Some f.
Proof.
rewrite mem_filter mem_iota add0n; split=> [/andP[/and3P[_ I /eqP F] _] //|[I F]].
by rewrite (heard_live F) I F eqxx /= boundary_below ?(heard_live F).
Qed.

Lemma relist_rest : rest t inn.
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
split=> //.
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

(** If the core is right, [prev] and what is kept too, and places and lists are made anew, all rules hold. *)
Theorem relist_rules : rules t.
Proof. by apply: core_rules relist_rest; apply: core_same c. Qed.

End Relist.

Section Tidy.
Variables (n : view) (inn : pred nat).
Hypothesis c : core n inn.

Notation t := (refind n).

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

(** If the core is right, and the rest is made anew, all rules hold. *)
Theorem tidy_rules : rules (tidy n inn).
Proof.
apply: relist_rules => [|h lh|v lv|b lb]; first exact: core_same c.
- have [g lg N] := next_onto lh.
  have P : prev t h = first (half_edge_slots n) (fun g => next n g == Some h).
    by rewrite /prev /heard lh.
  rewrite P; case E: (first _ _) => [g'|]; first by have/eqP N' := first_some E; split=> //; exists g' => //; apply: heard_live N'.
  by have := first_none E (half_edge_below lg); rewrite N eqxx.
- have L : leaving t v = first (half_edge_slots n) (fun h => origin n h == Some v).
    by rewrite /leaving /heard lv.
  rewrite L; case E: (first _ _) => [h|]; first by left; exists h => //; apply/eqP/(first_some E).
  by right; split=> // h lh; apply/eqP; apply: first_none E (half_edge_below lh).
have S : boundary_start t b = says_boundary_start t b by rewrite /boundary_start /heard lb.
rewrite S /=; case E: (first _ _) => [h|]; first by left; exists h => //; apply/eqP/(first_some E).
right; case D: (first _ _) => [v|]; first by exists v => //; apply/eqP/(first_some D).
have [v [[h B _]|I]] := core_used c lb.
  by have := first_none E (half_edge_below (heard_live B)); rewrite B eqxx.
by have := first_none D (vertex_below (heard_live I)); rewrite I eqxx.
Qed.

End Tidy.
