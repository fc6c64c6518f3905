(** * Near: what may be left unchecked after a change (near/mod.rs)

    A structure kept the rules, and half-edges have changed since. [changed] has all of those whose links differ, or that are new or
    gone. It is enough to look at these, and at the half-edges that led to them as their twins or their next.

<<
      before:  p ──► h ──►          now:  p ──► n ──► h ──►        n is new, and p and h have changed; no other half-edge is looked at

      around a vertex:   · · m · · m' · ·     the members m, m' are new there, or are followed by another one: if they are on one
                                              orbit, and one was there before (if any is left of those before), all are
>>
*)

From mathcomp Require Import all_ssreflect all_fingroup.
From twinedge Require Import View Rules Loops LoopsProof Reference ReferenceProof Map Table.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** ** Half-edges *)

(** R1 of a half-edge, L1, L3, the constancy of boundary components, and of L2 that `prev(next(h)) = h`. *)
Record fine t h : Prop := Fine {
  origin_lives : leads_to (vertex t) (origin t h);
  twin_lives : leads_to (half_edge t) (twin t h);
  next_lives : leads_to (half_edge t) (next t h);
  prev_lives : leads_to (half_edge t) (prev t h);
  boundary_lives : leads_to (boundary t) (boundary_of t h);
  twin_back : twin t h >>= twin t = Some h;
  twin_differs : twin t h <> Some h;
  next_back : next t h >>= prev t = Some h;
  next_meets : next t h >>= origin t = twin t h >>= origin t;
  next_labelled : next t h >>= boundary_of t = boundary_of t h
}.

(** The half-edge is live before and now, or neither, and has the same links. *)
Definition same_half_edge t t' h :=
  half_edge t h = half_edge t' h /\
  [/\ origin t h = origin t' h, twin t h = twin t' h, next t h = next t' h, prev t h = prev t' h & boundary_of t h = boundary_of t' h].

Section Near.
Variables (t t' : view) (changed : pred nat).

Hypothesis before : forall h, half_edge t h -> fine t h.
Hypothesis unchanged : forall h, ~~ changed h -> same_half_edge t t' h.

(** Looked at are those that may have changed, and those that led to one of them. *)
Hypothesis looked_at : forall h, half_edge t' h -> changed h -> fine t' h.
Hypothesis led_there : forall g h, changed h -> half_edge t g -> ~~ changed g -> twin t g = Some h \/ next t g = Some h -> fine t' g.

(** Vertices and boundary components that are gone have no half-edges. *)
Hypothesis vertices_gone : forall v, vertex t v -> ~~ vertex t' v -> bare t' v.
Hypothesis boundaries_gone : forall b h, boundary t b -> ~~ boundary t' b -> half_edge t' h -> boundary_of t' h <> Some b.

Lemma kept_live h : ~~ changed h -> half_edge t' h = half_edge t h.
Proof. by case/unchanged. Qed.

(** All links of half-edges are right but that `prev` leads to a live one, which is seen at the end. *)
Lemma next_twin_right h : half_edge t' h ->
  [/\ leads_to (vertex t') (origin t' h), leads_to (half_edge t') (twin t' h), leads_to (half_edge t') (next t' h),
      leads_to (boundary t') (boundary_of t' h)
    & [/\ twin t' h >>= twin t' = Some h, twin t' h <> Some h, next t' h >>= prev t' = Some h,
          next t' h >>= origin t' = twin t' h >>= origin t' & next t' h >>= boundary_of t' = boundary_of t' h]].
Proof.
have done_if g : fine t' g -> half_edge t' g ->
  [/\ leads_to (vertex t') (origin t' g), leads_to (half_edge t') (twin t' g), leads_to (half_edge t') (next t' g),
      leads_to (boundary t') (boundary_of t' g)
    & [/\ twin t' g >>= twin t' = Some g, twin t' g <> Some g, next t' g >>= prev t' = Some g,
          next t' g >>= origin t' = twin t' g >>= origin t' & next t' g >>= boundary_of t' = boundary_of t' g]] by case.
move=> lh; case ch: (changed h); first by apply: done_if => //; apply: looked_at.
have lb : half_edge t h by rewrite -kept_live ?ch.
have [_ [Eo Et En Ep Eb]] := unchanged (negbT ch); have F := before lb.
have [k Tk lk] := twin_lives F; have [n Nn ln] := next_lives F.
case ck: (changed k); first by apply: done_if => //; apply: (led_there ck) => //; [rewrite ch | left].
case cn: (changed n); first by apply: done_if => //; apply: (led_there cn) => //; [rewrite ch | right].
have [_ [Ko Kt _ _ _]] := unchanged (negbT ck); have [_ [No _ _ Np Nb]] := unchanged (negbT cn).
have := (twin_back F, twin_differs F, next_back F, next_meets F, next_labelled F).
rewrite -!Eo -!Et -!En -!Eb Tk Nn /= -!Ko -!Kt -!No -!Np -!Nb => -[[[[tb td] nb] nm] nl]; split.
- have [v V lv] := origin_lives F; exists v => //; apply/negPn/negP=> gone.
  by apply: (vertices_gone lv gone lh); rewrite -Eo.
- by exists k; rewrite // kept_live ?ck.
- by exists n; rewrite // kept_live ?cn.
- have [b B lb'] := boundary_lives F; exists b => //; apply/negPn/negP=> gone.
  by apply: (boundaries_gone lb' gone lh); rewrite -Eb.
by split.
Qed.

(** R1 of half-edges, L1, L2 and L3 hold now, and so does what B1 says of `next`. That each half-edge is the next of its `prev` is
    a count: no two have the same next, so each is the next of one. *)
Theorem near_half_edges : is_map t' /\ forall h, half_edge t' h -> next t' h >>= boundary_of t' = boundary_of t' h.
Proof.
have right h := @next_twin_right h.
pose dart' := [finType of slot (half_edge_slots t') (half_edge t')].
have total h : half_edge t' h -> exists2 n, next t' h = Some n & half_edge t' n by case/right=> _ _ [n N l]; exists n.
pose nx' : dart' -> dart' := step (next t').
have nextN x : next t' (num x) = Some (num (nx' x)) := says_step (@half_edge_below t') total x.
have prevN x : prev t' (num (nx' x)) = Some (num x).
  by have [_ _ _ _ [_ _ + _ _]] := right _ (num_live x); rewrite nextN.
have inj : injective nx' by move=> x y E; have := prevN x; rewrite E prevN => -[/num_inj].
have onto h : half_edge t' h -> exists2 x : dart', prev t' h = Some (num x) & next t' (num x) = Some h.
  by case/(slotP (@half_edge_below t'))=> y <-; rewrite -(f_invF inj y); exists (invF inj y).
split; last by move=> h /right[_ _ _ _ []].
split.
- move=> h lh; have [O T N B _] := right h lh; split=> //.
  by have [x P _] := onto h lh; exists (num x) => //; apply: num_live.
- by move=> h /right[_ _ _ _ []].
- move=> h lh; have [x P N] := onto h lh; rewrite P /= N; split=> //.
  by have [_ _ _ _ []] := right h lh.
by move=> h /right[_ _ _ _ []].
Qed.

End Near.

(** ** Orbits: V2, and B1 of half-edges

    [f] is `turn` and [key] is `origin`, or [f] is `next` and [key] is `boundary_of`. *)

Section Orbits.
Variables (live live' : nat -> bool) (f f' key key' : nat -> link).

Hypothesis before : forall g h, live g -> live h -> (on_orbit f g h <-> key g = key h).

(** Now [f'] is a permutation, and [key'] is the same along it. *)
Hypothesis total : forall h, live' h -> exists2 g, f' h = Some g & live' g.
Hypothesis same_key : forall h, live' h -> f' h >>= key' = key' h.
Hypothesis sym : forall g h, live' g -> live' h -> on_orbit f' g h -> on_orbit f' h g.

(** A member is new, or has another key, or is followed by another one. *)
Definition was_here h := live h /\ key h = key' h.
Definition member h := live' h /\ ~ (was_here h /\ f h = f' h).

Hypothesis member_dec : forall h, live' h -> member h \/ was_here h /\ f h = f' h.

(** Members with one key are on one orbit. *)
Hypothesis members_meet : forall g h, member g -> member h -> key' g = key' h -> on_orbit f' g h.

(** If one remains of those that had the key, and there is a member, then some member had it. *)
Hypothesis members_join : forall h m, live' h -> was_here h -> member m -> key' m = key' h ->
  exists m', [/\ member m', was_here m' & key' m' = key' h].

Lemma orbit_kept g h : live' g -> on_orbit f' g h -> live' h /\ key' h = key' g.
Proof.
move=> lg [n]; elim: n h => [|n IH] h /=; first by case=> <-.
case E: (iter _ _ _) => [k|] //= kh; have [lk ke] := IH k E; have [j J lj] := total lk.
move: kh; rewrite J => -[<-]; split=> //; by rewrite -ke -(same_key lk) J.
Qed.

(** Without member an orbit is one of before. *)
Lemma orbit_old g : live' g -> (forall h, on_orbit f' g h -> ~ member h) -> forall h, on_orbit f' g h -> on_orbit f g h /\ was_here h.
Proof.
move=> lg none h gh; have [lh _] := orbit_kept lg gh.
have old k : on_orbit f' g k -> was_here k /\ f k = f' k.
  by move=> gk; have [lk _] := orbit_kept lg gk; case: (member_dec lk) => // /(none k gk).
split; last by case: (old h gh).
case: gh => n; elim: n h lh => [|n IH] h lh /=; first by case=> <-; exists 0.
case E: (iter _ _ _) => [k|] //= kh; have gk : on_orbit f' g k by exists n.
have [lk _] := orbit_kept lg gk; have [m M] := IH k lk E; exists m.+1; rewrite /= M /=.
by have [_ ->] := old k gk.
Qed.

(** One of before that has kept its key is on an orbit of before, all of which is there. *)
Lemma orbit_whole g : live' g -> (forall h, on_orbit f' g h -> ~ member h) -> forall h, was_here h -> key' h = key' g -> on_orbit f' g h.
Proof.
move=> lg none h [lh kh] E; have [] := orbit_old lg none (h := g); first by exists 0.
move=> _ [lbg kg]; have /(before lbg lh)[n] : key g = key h by rewrite kg kh E.
suff: forall k, iter n (obind f) (Some g) = Some k -> on_orbit f' g k by apply.
elim: n => [|n IH] k /=; first by case=> <-; exists 0.
case I: (iter _ _ _) => [j|] //= jk; have [m M] := IH j I; exists m.+1; rewrite /= M /=.
have gj : on_orbit f' g j by exists m.
have [lj _] := orbit_kept lg gj; by case: (member_dec lj) => [/(none j gj)|[_ <-]].
Qed.

Hypothesis meets_dec : forall g, live' g -> (exists2 m, on_orbit f' g m & member m) \/ forall h, on_orbit f' g h -> ~ member h.

Lemma orbit_trans' (a b c : nat) : on_orbit f' a b -> on_orbit f' b c -> on_orbit f' a c.
Proof. by case=> m Em [n En]; exists (n + m); rewrite iterD Em. Qed.

Theorem near_orbits g h : live' g -> live' h -> (on_orbit f' g h <-> key' g = key' h).
Proof.
move=> lg lh; split=> [gh|E]; first by have [_ ->] := orbit_kept lg gh.
have joins a b : live' a -> live' b -> key' a = key' b -> (forall k, on_orbit f' a k -> ~ member k) ->
    (exists2 m, on_orbit f' b m & member m) -> False.
  move=> la lb ab none [m bm M]; have [_ mb] := orbit_kept lb bm.
  have [_ oa] := orbit_old la none (h := a) (ex_intro _ 0 erefl).
  have [m' [M' o' k']] := members_join la oa M (etrans mb (esym ab)).
  exact: none m' (orbit_whole la none o' k') M'.
case: (meets_dec lg) => [mg|ng]; case: (meets_dec lh) => [mh|nh].
- case: mg mh => [m gm M] [n hn N]; have [lm km] := orbit_kept lg gm; have [ln kn] := orbit_kept lh hn.
  apply: orbit_trans' gm _; apply: orbit_trans' (members_meet M N _) _; first by rewrite km kn.
  exact: sym.
- by case: (joins h g lh lg (esym E) nh mg).
- by case: (joins g h lg lh E ng mh).
have [_ oh] := orbit_old lh nh (h := h) (ex_intro _ 0 erefl).
by apply: (orbit_whole lg ng oh); rewrite E.
Qed.

End Orbits.

(** ** Of views: members are what has changed around a vertex, or along a cycle *)

Section Views.
Variables t t' : view.
Hypothesis map' : is_map t'.

Section Walk.
Variables (f f' key key' : nat -> link) (step' : dart t' -> dart t').
Hypothesis leads : forall x, f' (num x) = Some (num (step' x)).
Hypothesis inj : injective step'.
Hypothesis constant : forall x, key' (num (step' x)) = key' (num x).

Notation member := (member (half_edge t) (half_edge t') f f' key key').
Notation was_here := (was_here (half_edge t) key key').

Definition stayed h := [&& half_edge t h, same_link (key h) (key' h) & same_link (f h) (f' h)].

Lemma stayedP h : reflect (was_here h /\ f h = f' h) (stayed h).
Proof. by apply: (iffP and3P) => [[l /same_linkP k /same_linkP s]|[[l /same_linkP k] /same_linkP s]]. Qed.

Lemma walk_total h : half_edge t' h -> exists2 g, f' h = Some g & half_edge t' g.
Proof. by case/dartP=> x <-; exists (num (step' x)); rewrite ?dart_live. Qed.

Lemma on_walk x y : on_orbit f' (num x) (num y) <-> fconnect step' x y.
Proof.
rewrite (on_orbit_step (@half_edge_below t') walk_total) (@eq_fconnect _ _ step') // => z; exact: stepP.
Qed.

Lemma near_walk :
  (forall g h, half_edge t g -> half_edge t h -> (on_orbit f g h <-> key g = key h)) ->
  (forall g h, member g -> member h -> key' g = key' h -> on_orbit f' g h) ->
  (forall h m, half_edge t' h -> was_here h -> member m -> key' m = key' h -> exists m', [/\ member m', was_here m' & key' m' = key' h]) ->
  forall g h, half_edge t' g -> half_edge t' h -> (on_orbit f' g h <-> key' g = key' h).
Proof.
move=> old meet join; apply: (near_orbits old walk_total _ _ _ meet join).
- by move=> h /dartP[x <-]; rewrite leads /= constant.
- by move=> g h /dartP[x <-] /dartP[y <-]; rewrite !on_walk fconnect_sym.
- by move=> h lh; case: (stayedP h) => H; [right | left].
move=> g /dartP[x <-]; case: (pickP [pred y | fconnect step' x y && ~~ stayed (num y)]) => [y /andP[xy /stayedP ny]|none].
  by left; exists (num y); [apply/on_walk | split; [apply: dart_live|]].
right=> h xh [/dartP[y yh] ny]; rewrite -yh in xh ny; have := none y; rewrite /= (on_walk x y).1 //.
by case: stayedP.
Qed.

End Walk.

(** V2 holds now if it held before, if the members at each vertex are on one orbit, and if one of them was there before
    where any half-edge of before is left. *)
Theorem near_rotations : let member := member (half_edge t) (half_edge t') (turn t) (turn t') (origin t) (origin t') in
  let was_here := was_here (half_edge t) (origin t) (origin t') in
  v2_rotation t ->
  (forall g h, member g -> member h -> origin t' g = origin t' h -> on_orbit (turn t') g h) ->
  (forall h m, half_edge t' h -> was_here h -> member m -> origin t' m = origin t' h ->
     exists m', [/\ member m', was_here m' & origin t' m' = origin t' h]) -> v2_rotation t'.
Proof.
move=> m w; apply: (near_walk (turnE map') (tn_inj map')) => x.
by rewrite !(originE map') (org_tn map').
Qed.

(** The half-edges of a boundary component are one cycle. *)
Definition one_cycle_each v := forall g h, half_edge v g -> half_edge v h -> (on_cycle v g h <-> boundary_of v g = boundary_of v h).

Theorem near_cycles : let member := member (half_edge t) (half_edge t') (next t) (next t') (boundary_of t) (boundary_of t') in
  let was_here := was_here (half_edge t) (boundary_of t) (boundary_of t') in
  one_cycle_each t -> (forall h, half_edge t' h -> next t' h >>= boundary_of t' = boundary_of t' h) ->
  (forall g h, member g -> member h -> boundary_of t' g = boundary_of t' h -> on_cycle t' g h) ->
  (forall h m, half_edge t' h -> was_here h -> member m -> boundary_of t' m = boundary_of t' h ->
     exists m', [/\ member m', was_here m' & boundary_of t' m' = boundary_of t' h]) -> one_cycle_each t'.
Proof.
move=> m w old const; apply: (near_walk (nextE map') (nx_inj map')) old => x.
by have := const _ (dart_live x); rewrite (nextE map').
Qed.

End Views.

(** With constancy that is B1, if each boundary component that has half-edges starts at one of them. *)
Theorem one_cycle_b1 t : is_map t -> (forall h, half_edge t h -> next t h >>= boundary_of t = boundary_of t h) ->
  b1_cycle t <-> one_cycle_each t /\ forall b, boundary t b ->
    (forall h, half_edge t h -> boundary_of t h = Some b -> exists2 g, boundary_start t b = Some (AtHalfEdge g) & half_edge t g) /\
    forall g, boundary_start t b = Some (AtHalfEdge g) -> half_edge t g -> boundary_of t g = Some b.
Proof.
move=> map const; have same (x y : dart t) : on_cycle t (num x) (num y) -> boundary_of t (num x) = boundary_of t (num y).
  move/(on_cycleE map)/iter_findex<-; elim: (findex _ _ _) => //= n ->.
  by have := const _ (dart_live (iter n (@nx t) x)); rewrite (nextE map).
have start_live g h : half_edge t h -> on_cycle t g h -> half_edge t g.
  move=> lh [[|n]]; first by case=> ->.
  rewrite iterSr /=; case E: (next t g) => [k|]; first by move=> _; apply: heard_live E.
  by rewrite (_ : iter n _ None = None) //; elim: n => //= n ->.
split=> [[_ B]|[one B]].
  split=> [g h lg lh|b lb].
    case: (dartP lg) (dartP lh) => x <- [y <-]; split=> [/same //|E].
    have [H _] := B _ (num x) (bnd_live map x) (dart_live x); have [s S sx] := H (boundaryE map x).
    have [H' _] := B _ (num y) (bnd_live map x) (dart_live y); rewrite -E in H'; have [s' S' sy] := H' (boundaryE map x).
    move: S'; rewrite S => -[ss]; rewrite -ss in sy; have ls := start_live _ _ (dart_live x) sx.
    exact: orbit_trans (cycle_sym map ls (dart_live x) sx) sy.
  split=> [h lh E|g S lg]; last by apply/(B b g lb lg); exists g => //; exists 0.
  by have [H _] := B b h lb lh; have [g S gh] := H E; exists g => //; apply: start_live gh.
split=> // b h lb lh; have [has own] := B b lb; split=> [E|[g S gh]].
  have [g S lg] := has h lh E; exists g => //; apply/(one g h lg lh); rewrite E; exact: own.
have lg := start_live g h lh gh; rewrite -((one g h lg lh).1 gh); exact: own.
Qed.

(** ** A member must have been there before

    A loop is added at a vertex that has an edge, and is linked with itself alone. Its half-edges are the only members, and they are
    on one orbit; but the half-edge that was there before is on another.

<<
        0 ───h0──► 1              before: h0 and h1 alone
       h2                         now: turn h2 = h3 and turn h3 = h2, at vertex 0, too
>>
*)

Definition edge_alone := view_of {|
  vertex_rows := [:: Some (VertexRow #0 'nil); Some (VertexRow #1 'nil)];
  half_edge_rows := [:: Some (HalfEdgeRow #0 #1 #1 #1 #0); Some (HalfEdgeRow #1 #0 #0 #0 #0)];
  boundary_rows := [:: Some (BoundaryRow #0 (Some (AtHalfEdge 0)) (Some (Inner 0)))];
  face_rows := [:: Some (FaceRow 'nil [:: #0])] |}.

Definition loop_apart := view_of {|
  vertex_rows := [:: Some (VertexRow #0 'nil); Some (VertexRow #1 'nil)];
  half_edge_rows := [:: Some (HalfEdgeRow #0 #1 #1 #1 #0); Some (HalfEdgeRow #1 #0 #0 #0 #0);
                        Some (HalfEdgeRow #0 #3 #2 #2 #0); Some (HalfEdgeRow #0 #2 #3 #3 #0)];
  boundary_rows := [:: Some (BoundaryRow #0 (Some (AtHalfEdge 0)) (Some (Inner 0)))];
  face_rows := [:: Some (FaceRow 'nil [:: #0])] |}.

Definition new_around := member (half_edge edge_alone) (half_edge loop_apart) (turn edge_alone) (turn loop_apart)
  (origin edge_alone) (origin loop_apart).

Example loop_apart_meets : is_map loop_apart /\
  (forall g h, new_around g -> new_around h -> origin loop_apart g = origin loop_apart h -> on_orbit (turn loop_apart) g h) /\
  ~ v2_rotation loop_apart.
Proof.
split; [|split].
- have [L _ _ _] : links_live loop_apart by apply/check_linksP; vm_compute.
  by split=> //; [apply/check_l1P|apply/check_l2P|apply/check_l3P]; vm_compute.
- move=> [|[|[|[|g]]]] h; last (by case=> /half_edge_below); move=> [_ ng]; try by case: ng.
  + by case: h => [|[|[|[|h]]]] // [] // _ nh _; try (by case: nh); [exists 0 | exists 1].
  by case: h => [|[|[|[|h]]]] // [] // _ nh _; try (by case: nh); [exists 1 | exists 0].
move=> H; have [_ /(_ erefl)[n]] := H 0 2 isT isT.
by rewrite (_ : iter n _ _ = Some 0) //; elim: n => //= n ->.
Qed.

(** ** Lists: F2 by their lengths

    Of a list it is enough that each entry is a boundary component that says so, and that the list is as long as there are boundary
    components that say that the face lists them inside: then none is missing, and none is there twice. *)

Definition says_inside t f b := same_link (boundary_face t b) (Some f) && if boundary_place t b is Some (Inner _) then true else false.

Theorem lists_by_length t :
  (forall b, boundary t b -> exists f p, boundary_face t b = Some f /\ boundary_place t b = Some p) ->
  (forall f i, i < inner_count t f -> exists b,
     [/\ inner t f i = Some b, boundary_face t b = Some f & boundary_place t b = Some (Inner i)]) ->
  (forall f, inner_count t f = count (says_inside t f) (iota 0 (boundary_slots t))) ->
  (forall f b, outer t f = Some b <-> boundary_face t b = Some f /\ boundary_place t b = Some Outer) -> f2_listed t.
Proof.
move=> placed entries lengths outers.
have names f p b : listed t f p = Some b -> boundary_face t b = Some f /\ boundary_place t b = Some p.
  case: p => [/outers //|i] /= E; have [c [Ec F P]] := entries f i (inner_lt E).
  by move: E; rewrite Ec => -[<-].
move=> b lb; have [f [p [F P]]] := placed b lb; exists f, p; split=> // f' p'; split=> [/names[F' P']|[-> ->]].
  by move: F' P'; rewrite F P => -[->] [->].
case: p P => [|i] P; first exact/outers.
pose all_of := [seq odflt 0 (inner t f j) | j <- iota 0 (inner_count t f)].
have allP c : c \in all_of -> exists2 j, inner t f j = Some c & boundary_face t c = Some f /\ boundary_place t c = Some (Inner j).
  case/mapP=> j; rewrite mem_iota => lt ->; have [d [E Fd Pd]] := entries f j lt; by exists j; rewrite E.
have u : uniq all_of.
  rewrite map_inj_in_uniq ?iota_uniq // => j k; rewrite !mem_iota => lj lk.
  have [c [-> _ Pc]] := entries f j lj; have [d [-> _ Pd]] := entries f k lk => /= cd.
  by move: Pd; rewrite -cd Pc => -[].
have sub : {subset all_of <= [seq c <- iota 0 (boundary_slots t) | says_inside t f c]}.
  move=> c /allP[j _ [Fc Pc]]; rewrite mem_filter mem_iota (boundary_below (heard_live Fc)) andbT.
  by rewrite /says_inside Fc Pc /= eqxx.
have sz : size [seq c <- iota 0 (boundary_slots t) | says_inside t f c] <= size all_of.
  by rewrite size_map size_iota lengths size_filter.
have [_ same] := uniq_min_size u sub sz; have : b \in all_of.
  by rewrite same mem_filter mem_iota (boundary_below lb) andbT /says_inside F P /= eqxx.
by case/allP=> j E [_]; rewrite P => -[->].
Qed.

Example edge_alone_lists : f2_listed edge_alone.
Proof.
apply: lists_by_length.
- by move=> [|b] // _; exists 0, (Inner 0).
- by move=> [|f] [|i] // _; exists 0.
- by move=> [|f].
by move=> [|f] [|b]; split=> // -[].
Qed.
