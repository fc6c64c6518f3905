(** * ExpectationsLists: the lists that the checker of expectations makes have what they should *)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import Arith View Rules Loops Reference ReferenceProof Map Counting Expectations ExpectationsCheck.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Lemma memberE x s : member x s = (x \in s).
Proof. by rewrite /member; elim: s => //= y s ->; rewrite inE eq_sym. Qed.

Lemma is_leastP x (ys : seq nat) (same : nat -> nat -> Prop) : (forall y, y \in ys <-> same x y) ->
  reflect (least same x) (is_least x ys).
Proof.
move=> H; apply: (iffP allP) => L y; first by move=> lt /H/L; rewrite leqNgt lt.
by move=> /H xy; rewrite leqNgt; apply/negP=> lt; apply: (L y).
Qed.

Lemma asksP number p (P : nat -> Prop) : (forall n, reflect (P n) (p n)) -> reflect (asked number P) (asks number p).
Proof. by case: number => [n|] H; [apply: H|left]. Qed.

(** ** Walks *)

Lemma walks_iff (step step' : nat -> nat -> Prop) x y : (forall u w, step u w <-> step' u w) -> walks step x y <-> walks step' x y.
Proof.
move=> H; split; (elim=> [|u w _ IH uw]; first exact: walks_nowhere); apply: walks_on IH _; exact/H.
Qed.

Lemma walks_trans step x y z : walks step x y -> walks step y z -> walks step x z.
Proof. by move=> xy; elim=> // u w _ xu uw; apply: walks_on xu uw. Qed.

Lemma on_orbit_walks f x y : on_orbit f x y <-> walks (fun u w => f u = Some w) x y.
Proof.
split=> [[n]|]; last first.
  by elim=> [|u w _ [n E] uw]; [exists 0 | exists n.+1; rewrite /= E].
elim: n y => [|n IH] y /=; first by case=> ->; apply: walks_nowhere.
by case E: (iter _ _ _) => [u|] //= uy; apply: walks_on uy; apply: IH.
Qed.

Section Close.
Variables (near : nat -> seq nat) (ends : seq nat).
Hypothesis near_ends : forall x y, y \in near x -> y \in ends.
Let step x y := y \in near x.

Lemma closeP fuel known y : count (fun x => x \notin known) ends < fuel ->
  y \in close fuel near known <-> exists2 x, x \in known & walks step x y.
Proof.
elim: fuel known y => // fuel IH known y lt /=.
case E: [seq _ <- _ | _] => [|z more] /=.
  split=> [yk|[x xk xy]]; first by exists y => //; apply: walks_nowhere.
  elim: {y} xy => // u w _ uk uw; apply/negPn/negP=> no.
  have: w \in [seq y <- flatten (map near known) | ~~ member y known].
    by rewrite mem_filter memberE no; apply/flattenP; exists (near u) => //; apply: map_f.
  by rewrite E.
have: z \in [seq y <- flatten (map near known) | ~~ member y known] by rewrite E mem_head.
rewrite mem_filter memberE => /andP[zk /flattenP[_ /mapP[x xk ->] xz]].
rewrite IH; last first.
  rewrite -ltnS; apply: leq_trans lt; rewrite ltnS.
  have -> : count (fun x => x \notin known) ends = count (pred1 z) ends + count (fun x => x \notin z :: known) ends.
    rewrite -(count_predUI (pred1 z)) addnC (@eq_count _ (predI _ _) pred0) ?count_pred0 ?add0n.
      by apply: eq_count => w; rewrite /= inE negb_or; case: eqP => //= ->.
    by move=> w; rewrite /= inE negb_or; case: eqP => //= ->.
  by rewrite -[X in X < _]add0n ltn_add2r -has_count has_pred1; apply: near_ends xz.
split=> [[u uk uy]|[u uk uy]]; last by exists u; rewrite // inE uk orbT.
move: uk; rewrite inE => /orP[/eqP uz|uk]; last by exists u.
exists x => //; apply: walks_trans uy; rewrite uz; exact: walks_on (walks_nowhere _ _) xz.
Qed.

Lemma close_uniq fuel known : uniq known -> uniq (close fuel near known).
Proof.
elim: fuel known => // fuel IH known u /=; case E: [seq _ <- _ | _] => [|z more] //=; apply: IH; rewrite /= u andbT.
have: z \in [seq y <- flatten (map near known) | ~~ member y known] by rewrite E mem_head.
by rewrite mem_filter memberE => /andP[].
Qed.

(** The same from one number. *)
Lemma close1P fuel x y (walk_step : nat -> nat -> Prop) : (forall u w, w \in near u <-> walk_step u w) -> size ends < fuel ->
  y \in close fuel near [:: x] <-> walks walk_step x y.
Proof.
move=> H lt; rewrite closeP; last by apply: leq_ltn_trans lt; apply: count_size.
rewrite -(walks_iff x y H); split=> [[u]|xy]; first by rewrite inE => /eqP->.
by exists x; rewrite ?mem_head.
Qed.

End Close.

(** ** Exactly one, or none *)

Lemma one_or_noneP (A : eqType) (p : pred A) (entries : seq A) legal (P : A -> Prop) (L : Prop) :
  uniq entries -> (forall x, P x -> x \in entries) -> (forall x, x \in entries -> p x <-> P x) -> reflect L legal ->
  reflect (one_or_none P L) (one_or_none_in p entries legal).
Proof.
move=> u inside pP legalP; rewrite /one_or_none_in -size_filter.
have mem x : x \in [seq x <- entries | p x] <-> P x.
  rewrite mem_filter; split=> [/andP[px xe]|Px]; first exact/(pP x xe).
  by rewrite inside // andbT; apply/(pP x (inside x Px)).
have {u inside pP}u : uniq [seq x <- entries | p x] by apply: filter_uniq.
case: [seq x <- entries | p x] mem u => [|x [|y rest]] mem u /=.
- apply: (iffP legalP) => [l|[[x [/mem]]|[]] //]; right; split=> // x /mem //.
- left; left; exists x; split=> [|y /mem]; first by apply/mem; rewrite mem_head.
  by rewrite inE => /eqP.
- right=> -[[z [_ one]]|[_ /(_ x)[]]]; last by apply/mem; rewrite mem_head.
  have xz : z = x by apply: one; apply/mem; rewrite mem_head.
  have yz : z = y by apply: one; apply/mem; rewrite !inE eqxx orbT.
  by move: u; rewrite /= inE -xz -yz eqxx.
Qed.

(** ** The lists of the checker *)

Section Lists.
Variables (e : expectation) (s : structure).
Notation t := (seen e s).

Lemma mem_vertices v : (v \in vertex_list e s) = vertex t v.
Proof. by rewrite mem_filter mem_iota andb_idr // => /vertex_below. Qed.
Lemma mem_half_edges h : (h \in half_edge_list e s) = half_edge t h.
Proof. by rewrite mem_filter mem_iota andb_idr // => /half_edge_below. Qed.
Lemma mem_boundaries b : (b \in boundary_list e s) = boundary t b.
Proof. by rewrite mem_filter mem_iota andb_idr // => /boundary_below. Qed.
Lemma mem_faces f : (f \in face_list e s) = face t f.
Proof. by rewrite mem_filter mem_iota andb_idr // => /face_below. Qed.

Lemma half_edges_uniq : uniq (half_edge_list e s). Proof. exact: filter_uniq (iota_uniq _ _). Qed.
Lemma vertices_uniq : uniq (vertex_list e s). Proof. exact: filter_uniq (iota_uniq _ _). Qed.
Lemma half_edges_size : size (half_edge_list e s) <= half_edge_slots t.
Proof. by rewrite size_filter -[X in _ <= X](size_iota 0); apply: count_size. Qed.

(** Loops over what is live. *)
Lemma eachP (live : nat -> bool) (all_live : seq nat) (p : pred nat) (P : nat -> Prop) :
  (forall x, (x \in all_live) = live x) -> (forall x, live x -> reflect (P x) (p x)) ->
  reflect (forall x, live x -> P x) (all p all_live).
Proof.
move=> mem H; apply: (iffP allP) => A x; first by move=> l; apply/(H x l)/A; rewrite mem.
by rewrite mem => l; apply/(H x l)/A.
Qed.

Definition each_half_edge p P := @eachP _ _ p P mem_half_edges.
Definition each_vertex p P := @eachP _ _ p P mem_vertices.
Definition each_boundary p P := @eachP _ _ p P mem_boundaries.
Definition each_face p P := @eachP _ _ p P mem_faces.

(** Filtered lists list what passes. *)
Lemma lists_half_edges (p : pred nat) (P : nat -> Prop) : (forall h, half_edge t h -> p h <-> P h) -> (forall h, P h -> half_edge t h) ->
  lists [seq h <- half_edge_list e s | p h] P.
Proof.
move=> pP live; split=> [|h]; first exact: filter_uniq half_edges_uniq.
rewrite mem_filter mem_half_edges; split=> [/andP[+ l]|Ph]; first by move/(pP h l).
by rewrite live // andbT; apply/(pP h (live h Ph)).
Qed.

Lemma mem_entries f p : ((f, p) \in entry_list e s) = face t f && (if p is Inner i then i < inner_count t f else true).
Proof.
apply/flattenP/andP => [[r /mapP[g + ->]]|[lf H]].
  rewrite mem_faces => lg; rewrite inE => /orP[/eqP[-> ->] //|/mapP[i]].
  by rewrite mem_iota => /= lt [-> ->].
exists ((f, Outer) :: [seq (f, Inner i) | i <- iota 0 (inner_count t f)]).
  by apply: map_f; rewrite mem_faces.
by rewrite inE; case: p H => [|i] lt; rewrite ?eqxx //; apply/orP; right; apply: map_f; rewrite mem_iota.
Qed.

Lemma entries_uniq : uniq (entry_list e s).
Proof.
rewrite /entry_list; have : uniq (face_list e s) by apply: filter_uniq (iota_uniq _ _).
elim: (face_list e s) => //= f fs IH /andP[ff u].
rewrite mem_cat cat_uniq IH // andbT negb_or -andbA; apply/and4P; split.
- by apply/mapP=> -[i _] [].
- apply/negP=> /flattenP[_ /mapP[g gf ->]]; rewrite inE => /orP[/eqP[fg]|/mapP[i _ []] //].
  by rewrite fg gf in ff.
- by rewrite map_inj_uniq ?iota_uniq // => i j [].
apply/hasPn=> x /flattenP[_ /mapP[g gf ->]] xg; apply/mapP=> -[i _ xf]; rewrite xf inE in xg.
by case/orP: xg => [/eqP[]|/mapP[j _ [fg _]]] //; rewrite fg gf in ff.
Qed.

(** All that a face lists is an entry. *)
Lemma listed_entry f p b : listed t f p = Some b -> (f, p) \in entry_list e s.
Proof.
move=> E; rewrite mem_entries (listed_face E); case: p E => // i /inner_lt //.
Qed.

Lemma inner_entry f i : i < inner_count t f -> (f, Inner i) \in entry_list e s.
Proof. by move=> lt; rewrite mem_entries lt andbT; move: lt; rewrite /inner_count; case: ifP. Qed.

Lemma start_entry f p st : entry_start e s f p = Some st -> (f, p) \in entry_list e s.
Proof.
rewrite /entry_start; case: (has_records s).
  by case E: (listed t f p) => [b|] // _; apply: listed_entry E.
case: p => [|i]; last by case: ifP => // lt _; apply: inner_entry.
by case E: (heard _ _ _) => [h|] // _; rewrite mem_entries (heard_live E).
Qed.

(** ** Orbits *)

Lemma orbitP f h g : (forall k, f k <> None -> half_edge t k) -> g \in orbit_of e s f h <-> on_orbit f h g.
Proof.
move=> live; rewrite on_orbit_walks.
have near k w : w \in push (f k) [::] <-> f k = Some w.
  by case: (f k) => [u|] //=; rewrite inE; split=> [/eqP->|[->]].
apply: (@close1P _ (pmap f (half_edge_list e s))) near _ => [k w|]; last first.
  by rewrite ltnS size_pmap; apply: leq_trans (count_size _ _) (leq_trans half_edges_size _).
case E: (f k) => [u|] //=; rewrite inE => /eqP->; rewrite mem_pmap; apply/mapP; exists k => //.
by rewrite mem_half_edges live // E.
Qed.

Lemma next_live k : next t k <> None -> half_edge t k.
Proof. by case E: (next t k) => // _; apply: heard_live E. Qed.
Lemma turn_live k : turn t k <> None -> half_edge t k.
Proof. by rewrite /turn; case E: (twin t k) => // _; apply: heard_live E. Qed.
Lemma turn_back_live k : turn_back e s k <> None -> half_edge t k.
Proof. by rewrite /turn_back; case E: (prev t k) => // _; apply: heard_live E. Qed.

Lemma cycleP h g : g \in orbit_of e s (next t) h <-> on_cycle t h g.
Proof. exact: orbitP next_live. Qed.

Lemma orbit_uniq f h : uniq (orbit_of e s f h).
Proof. exact: close_uniq. Qed.

(** ** Components *)

Lemma leavingP v h : (h \in leaving_list e s v) <-> origin t h = Some v.
Proof.
rewrite mem_filter mem_half_edges; split=> [/andP[/same_linkP //]|E].
by rewrite (heard_live E) andbT; apply/same_linkP.
Qed.

Lemma bareP v : reflect (bare t v) (bare_at e s v).
Proof.
rewrite /bare_at; case E: (leaving_list e s v) => [|h rest]; constructor.
  by move=> h lh /leavingP; rewrite E.
have/leavingP hv : h \in leaving_list e s v by rewrite E mem_head.
by move=> /(_ h (heard_live hv)).
Qed.

Lemma end_live h : end_of e s h <> None -> half_edge t h.
Proof.
rewrite /end_of /target; case: ifP => _; last by case E: (twin t h) => // _; apply: heard_live E.
by case E: (next t h) => // _; apply: heard_live E.
Qed.

Lemma endsP u w : w \in ends_at e s u <-> edge_step e s u w.
Proof.
rewrite /ends_at mem_pmap; split=> [/mapP[h /leavingP hu E]|[h /leavingP hu E]]; first by exists h.
by apply/mapP; exists h.
Qed.

Lemma linkedP v w : w \in linked_list e s v <-> linked e s v w.
Proof.
apply: (@close1P _ (pmap (end_of e s) (half_edge_list e s))) endsP _ => [u x|].
  rewrite !mem_pmap => /mapP[h /leavingP hu E]; apply/mapP; exists h => //.
  by rewrite mem_half_edges (heard_live hu).
by rewrite ltnS size_pmap; apply: leq_trans (count_size _ _) (leq_trans half_edges_size _).
Qed.

Lemma linked_lists v : lists (linked_list e s v) (linked e s v).
Proof. by split=> [|w]; [apply: close_uniq | apply: linkedP]. Qed.

Lemma is_atP v l : is_at (linked_list e s v) l <-> exists2 w, l = Some w & linked e s v w.
Proof.
case: l => [w|] /=; last by split=> // -[].
by rewrite memberE; split=> [/linkedP|[_ [<-] /linkedP //]]; exists w.
Qed.

Lemma componentP v h : is_at (linked_list e s v) (origin t h) <-> of_component e s v h.
Proof. exact: is_atP. Qed.

Lemma of_component_live v h : of_component e s v h -> half_edge t h.
Proof. by case=> w E _; apply: heard_live E. Qed.

(** ** Borders *)

Lemma followersP g h : h \in followers e s g <-> half_edge t h /\ follows e s g h.
Proof.
rewrite mem_filter mem_half_edges /follows; split=> [/andP[/andP[b]]|[lh [b [u Eg Eh]]]].
  by case E: (end_of e s g) => [u|] // /same_linkP Eh lh; split=> //; split=> //; exists u.
by rewrite lh b Eg /= andbT; apply/same_linkP.
Qed.

Lemma borderP h g : g \in border_of e s h <-> walks (follows e s) h g.
Proof.
apply: (@close1P _ (half_edge_list e s)) => [u w|u w|].
- by case/followersP=> lw _; rewrite mem_half_edges.
- rewrite followersP; split=> [[]//|H]; split=> //; case: H => _ [x _ E]; exact: heard_live E.
by rewrite ltnS; apply: leq_trans half_edges_size _.
Qed.

End Lists.
