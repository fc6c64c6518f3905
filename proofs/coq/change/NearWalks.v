(** * NearWalks: walks in step find whether all members are on one orbit (near/check.rs)

    From each member a walk leads along the orbit, all of them one step at a time; each ends at the first member that it meets, and
    one need not end. If no two meet the same member, and those that are met form one chain, all members are on one orbit; and if
    they are, that is found after no more steps than the orbit has elements.

<<
      a ──► · ──► b ──► c ──► · ──► · ──► · ──► …        a meets b, b meets c: c leads back to a
>>

    In Rust the walks that have ended are swapped with the last ones, so that they advance in another order. *)

From mathcomp Require Import all_ssreflect all_fingroup.
From twinedge Require Import View Rules Loops LoopsProof Counting Map Near.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** ** The walks *)

Section Walks.
Variables (T : eqType) (step : T -> option T) (members : seq T).

(** A walk: the member from which it comes, and where it is. What has met what: a list of both. *)
Definition walk := (T * T)%type.

(** All walks advance by one step. Nothing if a step leads nowhere, or a member is met twice. *)
Fixpoint advance (walks meets : seq walk) : option (seq walk * seq walk) :=
  if walks is (from, at_) :: rest then
    if step at_ is Some next then
      if next \in members then
        if next \in map snd meets then None else advance rest ((from, next) :: meets)
      else if advance rest meets is Some (still, met) then Some ((from, next) :: still, met) else None
    else None
  else Some ([::], meets).

(** Until one at most is under way. Nothing after more than [left] steps of all together. *)
Fixpoint walk_on (rounds left : nat) (walks meets : seq walk) : option (seq walk) :=
  if size walks <= 1 then Some meets else
  if rounds is more.+1 then
    if size walks <= left then
      if advance walks meets is Some (still, met) then walk_on more (left - size walks) still met else None
    else None
  else None.

Definition met_by (meets : seq walk) (m : T) : option T := ohead [seq w.2 | w <- meets & w.1 == m].

(** So many more are met, one after another, from [at_] on, and none of these is the first. *)
Fixpoint chains (meets : seq walk) (first : T) (more : nat) (at_ : T) : bool :=
  if more is less.+1 then if met_by meets at_ is Some next then (next != first) && chains meets first less next else false else true.

(** The first that no walk has met, or the first of all. *)
Definition chain_first (meets : seq walk) (m : T) : T := head m [seq m <- members | m \notin map snd meets].

Definition on_one (limit : nat) : bool :=
  if members is m :: _ then
    if walk_on limit limit [seq (m, m) | m <- members] [::] is Some meets
    then chains meets (chain_first meets m) (size members).-1 (chain_first meets m) else false
  else true.

Lemma on_oneE limit m ms : members = m :: ms -> on_one limit =
  if walk_on limit limit [seq (m, m) | m <- members] [::] is Some meets
  then chains meets (chain_first meets m) (size members).-1 (chain_first meets m) else false.
Proof. by rewrite /on_one => ->. Qed.

(** ** All members are on one orbit if it says so *)

Definition leads x y := exists n, iter n (obind step) (Some x) = Some y.

Lemma leads_trans x y z : leads x y -> leads y z -> leads x z.
Proof. by case=> m Em [n En]; exists (n + m); rewrite iterD Em. Qed.

Lemma leads_step x y : step x = Some y -> leads x y.
Proof. by move=> E; exists 1. Qed.

Definition sound (walks meets : seq walk) :=
  [/\ forall w, w \in walks -> leads w.1 w.2, forall w, w \in meets -> w.2 \in members /\ leads w.1 w.2 & uniq (map snd meets)].

Lemma advance_sound walks meets still met : advance walks meets = Some (still, met) -> sound walks meets -> sound still met.
Proof.
elim: walks meets still met => [|[from at_] rest IH] meets still met /=.
  by case=> <- <- [W M U]; split.
case E: (step at_) => [next|] //; have here walks' : (forall w, w \in (from, at_) :: walks' -> leads w.1 w.2) -> leads from next.
  by move=> W; apply: leads_trans (leads_step E); apply: (W (from, at_)); rewrite mem_head.
case: ifP => [nm|_].
  case: ifP => // /negbT new A [W M U]; apply: (IH _ _ _ A); split=> /=.
  - by move=> w wr; apply: W; rewrite inE wr orbT.
  - by move=> w; rewrite inE => /orP[/eqP->|/M] //; split=> //; apply: here W.
  by rewrite new.
case A: (advance rest meets) => [[st me]|] // [<- <-] [W M U]; have [] := IH _ _ _ A.
  by split=> // w wr; apply: W; rewrite inE wr orbT.
by move=> W' M' U'; split=> // w; rewrite inE => /orP[/eqP->|/W'] //; apply: here W.
Qed.

Lemma walk_on_sound rounds left walks meets found : walk_on rounds left walks meets = Some found -> sound walks meets ->
  (forall w, w \in found -> w.2 \in members /\ leads w.1 w.2) /\ uniq (map snd found).
Proof.
elim: rounds left walks meets => [|rounds IH] left walks meets /=; case: ifP => // _; try by case=> <- [_].
case: ifP => // _; case A: (advance walks meets) => [[still met]|] // F S; exact: IH F (advance_sound A S).
Qed.

Lemma met_by_mem (meets : seq walk) m x : met_by meets m = Some x -> (m, x) \in meets.
Proof.
rewrite /met_by; case E: [seq w.2 | w <- meets & w.1 == m] => [|y ys] //= [<-].
have: y \in [seq w.2 | w <- meets & w.1 == m] by rewrite E mem_head.
by case/mapP=> -[a b]; rewrite mem_filter => /andP[/eqP /= <- i] ->.
Qed.

Lemma met_one (meets : seq walk) a b x : uniq (map snd meets) -> (a, x) \in meets -> (b, x) \in meets -> a = b.
Proof.
elim: meets => //= -[c y] meets IH /andP[no u]; rewrite !inE => A B.
have out d : (d, y) \in meets -> False by move=> dm; case/negP: no; apply/mapP; exists (d, y).
case/orP: A => [/eqP[ac xy]|am]; case/orP: B => [/eqP[bc xy']|bm]; rewrite ?ac ?bc //.
- by case: (out b); rewrite -xy.
- by case: (out a); rewrite -xy'.
exact: IH.
Qed.

Theorem on_one_sound limit : on_one limit -> uniq members -> forall g h, g \in members -> h \in members ->
  exists2 m, m \in members & leads m g /\ leads m h.
Proof.
rewrite /on_one; case M: members => [|m0 ms] //; rewrite -M; case W: (walk_on _ _ _ _) => [meets|] // C u.
have S : sound [seq (m, m) | m <- members] [::] by split=> // w /mapP[m _ ->]; exists 0.
have [met once] := walk_on_sound W S.
set first := chain_first meets m0 in C.
have first_in : first \in members.
  rewrite /first /chain_first; case E: [seq m <- members | _] => [|x xs] /=; first by rewrite M mem_head.
  have: x \in [seq m <- members | m \notin map snd meets] by rewrite E mem_head.
  by rewrite mem_filter => /andP[].
pose f x := odflt first (met_by meets x).
have chainP n x : chains meets first n x -> forall i, i < n -> met_by meets (iter i f x) = Some (iter i.+1 f x) /\ iter i.+1 f x <> first.
  elim: n x => // n IH x /=; case E: (met_by meets x) => [y|] // /andP[/eqP ne c]; have fx : f x = y by rewrite /f E.
  case=> [_|i lt]; first by rewrite /= fx.
  by have := IH y c i lt; rewrite -fx -!iterSr.
have {C}C := chainP _ _ C; set n := (size members).-1 in C.
have size_n : size members = n.+1 by rewrite /n M.
have injective i j : i < j -> j <= n -> iter i f first <> iter j f first.
  elim: i j => [|i IH] [|j] // lt le; first by have [_ /nesym] := C j le.
  have [Ei _] := C i (ltn_trans (lt : i < j) le); have [Ej _] := C j le => E; rewrite E in Ei.
  by apply: (IH j lt (ltnW le)); apply: met_one once (met_by_mem Ei) (met_by_mem Ej).
pose s := [seq iter i f first | i <- iota 0 n.+1].
have us : uniq s.
  rewrite map_inj_in_uniq ?iota_uniq // => i j; rewrite !mem_iota !add0n !ltnS => /= li lj E.
  by case: (ltngtP i j) => // lt; [case: (injective i j lt lj E) | case: (injective j i lt li (esym E))].
have reach i : i <= n -> iter i f first \in members /\ leads first (iter i f first).
  elim: i => [|i IH] le; first by split=> //; exists 0.
  have [_ L] := IH (ltnW le); have [E _] := C i le; have [m L'] := met _ (met_by_mem E); split=> //; exact: leads_trans L L'.
have sub : {subset s <= members} by move=> x /mapP[i]; rewrite mem_iota add0n ltnS => /= le ->; case: (reach i le).
have long : size members <= size s by rewrite size_map size_iota size_n.
have [_ all] := uniq_min_size us sub long.
have from_first x : x \in members -> leads first x.
  by rewrite -all => /mapP[i]; rewrite mem_iota add0n ltnS => /= le ->; case: (reach i le).
by move=> g h gm hm; exists first => //; split; apply: from_first.
Qed.

End Walks.

(** ** It says so if they are: nothing that is right is refused *)

Section Complete.
Variables (T : finType) (F : T -> T) (members : seq T).
Hypothesis inj : injective F.
Hypothesis u : uniq members.
Hypothesis one : forall g h, g \in members -> h \in members -> fconnect F g h.

Notation step := (fun x => Some (F x)).

(** So many steps, and one, lead from the member to the next one. *)
Definition far x := find (fun n => iter n.+1 F x \in members) (iota 0 #|T|).
Definition nxt x := iter (far x).+1 F x.

Lemma far_hits x : x \in members -> nxt x \in members.
Proof.
move=> mx; have H : has (fun n => iter n.+1 F x \in members) (iota 0 #|T|).
  apply/hasP; exists (fingraph.order F x).-1; last by rewrite prednK ?order_gt0 // iter_order.
  by rewrite mem_iota add0n prednK ?order_gt0 // max_card.
have := nth_find 0 H; rewrite nth_iota; last by rewrite -[X in _ < X](size_iota 0) -has_find.
by rewrite add0n.
Qed.

Lemma far_first x n : n < far x -> iter n.+1 F x \notin members.
Proof.
move=> lt; have := before_find 0 lt; rewrite nth_iota ?add0n => [/negbT //|].
by apply: leq_trans lt _; rewrite -[X in _ <= X](size_iota 0); apply: find_size.
Qed.

Lemma steps_inj n : injective (iter n F).
Proof. by elim: n => // n IH x y /= /inj/IH. Qed.

Lemma far_le x y i j : x \in members -> y \in members -> i <= j -> j <= far y -> iter i F x = iter j F y -> i = j /\ x = y.
Proof.
move=> mx my le lj E; have xy : x = iter (j - i) F y.
  by apply: (@steps_inj i); rewrite -iterD subnKC.
case D: (j - i) xy => [|k] xy; first by split=> //; apply/eqP; rewrite eqn_leq le -subn_eq0 D.
have: k < far y by rewrite -D; apply: leq_trans lj; apply: leq_subr.
by move/far_first; rewrite -xy mx.
Qed.

Lemma nxt_inj x y : x \in members -> y \in members -> nxt x = nxt y -> x = y.
Proof.
move=> mx my /inj E; case: (leqP (far x) (far y)) => [le|/ltnW le].
  by have [] := far_le mx my le (leqnn _) E.
by have [] := far_le my mx le (leqnn _) (esym E).
Qed.

Lemma iter_nxt x i : x \in members -> iter i nxt x \in members.
Proof. by move=> mx; elim: i => //= i; apply: far_hits. Qed.

Lemma nxt_reaches x h : x \in members -> h \in members -> exists i, iter i nxt x = h.
Proof.
move=> mx mh; have /iter_findex := one mx mh; move: (findex F x h) => k.
elim/ltn_ind: k x mx => -[|k] IH x mx E; first by exists 0.
case: (ltnP k (far x)) => [/far_first|le]; first by rewrite E mh.
have [||i I] := IH (k - far x) _ (nxt x) (far_hits mx); first by rewrite ltnS leq_subr.
  by rewrite /nxt -iterD addnS subnK.
by exists i.+1; rewrite iterSr.
Qed.

Lemma nxt_onto h : h \in members -> exists2 m, m \in members & nxt m = h.
Proof.
move=> mh; have [i I] := nxt_reaches (far_hits mh) mh; exists (iter i nxt h); first exact: iter_nxt.
by rewrite -iterS iterSr.
Qed.

Lemma nxt_returns x p : x \in members -> 0 < p -> p < size members -> iter p nxt x <> x.
Proof.
move=> mx p0 lt E; have reduce i : exists2 j, j < p & iter i nxt x = iter j nxt x.
  elim: i => [|i [j jp I]]; first by exists 0.
  case: (leqP p j.+1) => [le|lt']; last by exists j.+1; rewrite //= I.
  by exists 0 => //; rewrite iterS I -iterS; have <- : p = j.+1 by apply/eqP; rewrite eqn_leq le.
have sub : {subset members <= [seq iter j nxt x | j <- iota 0 p]}.
  move=> h mh; have [i <-] := nxt_reaches mx mh; have [j jp ->] := reduce i; apply/mapP; exists j => //; by rewrite mem_iota.
by have := uniq_leq_size u sub; rewrite size_map size_iota leqNgt lt.
Qed.

(** After so many rounds. *)
Definition under_way r ms := [seq (m, iter r F m) | m <- ms & r <= far m].
Definition have_met r (meets : seq (T * T)) := forall w, w \in meets <-> exists2 m, m \in members & far m < r /\ w = (m, nxt m).

Lemma advance_right r ms meets : uniq ms -> {subset ms <= members} -> (forall m, m \in ms -> r <= far m) ->
  (forall w, w \in meets -> exists2 m, m \in members & m \notin ms /\ w = (m, nxt m)) ->
  exists2 met, advance step members [seq (m, iter r F m) | m <- ms] meets = Some ([seq (m, iter r.+1 F m) | m <- ms & r < far m], met)
    & forall w, w \in met <-> w \in meets \/ exists2 m, m \in ms & far m = r /\ w = (m, nxt m).
Proof.
elim: ms meets => [|m ms IH] meets /=.
  by move=> _ _ _ _; exists meets => // w; split=> [|[//|[]//]]; left.
case/andP=> nm um sub le old; have mm : m \in members by apply: sub; rewrite mem_head.
have lm := le m (mem_head _ _); have sub' : {subset ms <= members} by move=> x xm; apply: sub; rewrite inE xm orbT.
have le' x : x \in ms -> r <= far x by move=> xm; apply: le; rewrite inE xm orbT.
have others w : w \in meets -> exists2 x, x \in members & x \notin ms /\ w = (x, nxt x).
  by case/old=> x xm [xn ->]; exists x => //; split=> //; move: xn; rewrite inE negb_or => /andP[].
case: (ltngtP r (far m)) lm => // [lt _|E _]; last first.
  have hit : iter r.+1 F m = nxt m by rewrite /nxt -E.
  rewrite -iterS hit far_hits // ifF; last first.
    apply/negP=> /mapP[w /old[x xm [xn ->]] /= /nxt_inj E']; move: xn; rewrite -(E' mm xm) mem_head //.
  have [|met -> M] := IH ((m, nxt m) :: meets) um sub' le' _.
    by move=> w; rewrite inE => /orP[/eqP->|/others//]; exists m.
  exists met => // w; rewrite M inE; split.
  - by case=> [/orP[/eqP->|wm]|[x xm [fx ->]]]; [right; exists m; rewrite ?mem_head|left|right; exists x; rewrite // inE xm orbT].
  case=> [wm|[x]]; first by left; rewrite wm orbT.
  rewrite inE => /orP[/eqP->|xm] [fx ->]; first by left; rewrite eqxx.
  by right; exists x.
rewrite -iterS (negPf (far_first lt)); have [met -> M] := IH meets um sub' le' others.
exists met => // w; rewrite M; split=> [[wm|[x xm W]]|[wm|[x]]]; [by left|by right; exists x; rewrite // inE xm orbT|by left|].
by rewrite inE => /orP[/eqP->|xm] [fx W]; [rewrite fx ltnn in lt|right; exists x].
Qed.

Definition remaining r := sumn [seq (far m).+1 - r | m <- members].

Lemma remaining_less r : remaining r = remaining r.+1 + size (under_way r members).
Proof.
rewrite /remaining /under_way size_map size_filter; elim: members => //= m ms ->; rewrite subSS addnACA; congr (_ + _).
by case: leqP => [le|lt]; [rewrite subSn // addn1|rewrite (eqP (_ : _ - r == 0)) ?subn_eq0 // addn0; apply/esym/eqP; rewrite subn_eq0 ltnW].
Qed.

Lemma remaining_fits : remaining 0 <= #|T|.
Proof.
case M: members => [|m0 ms]; first by rewrite /remaining M.
pose along i := [seq iter j F (nth m0 members i) | j <- iota 0 (far (nth m0 members i)).+1].
have nth_in i : i < size members -> nth m0 members i \in members by move=> lt; apply: mem_nth.
have uf : uniq (flatten [seq along i | i <- iota 0 (size members)]).
  apply: uniq_flatten; first exact: iota_uniq.
    move=> i; rewrite mem_iota add0n => /andP[_ lt]; rewrite map_inj_in_uniq ?iota_uniq // => j k; rewrite !mem_iota !add0n !ltnS => /= lj lk E.
    case: (leqP j k) => [le|/ltnW le]; first by have [] := far_le (nth_in i lt) (nth_in i lt) le lk E.
    by have [] := far_le (nth_in i lt) (nth_in i lt) le lj (esym E).
  move=> i k y; rewrite !mem_iota !add0n => /andP[_ li] /andP[_ lk] /mapP[a]; rewrite mem_iota add0n ltnS => /= la -> /mapP[b].
  rewrite mem_iota add0n ltnS => /= lb E; apply/eqP; rewrite -(nth_uniq m0 li lk u); apply/eqP.
  case: (leqP a b) => [le|/ltnW le]; first by have [] := far_le (nth_in i li) (nth_in k lk) le lb E.
  by have [_ ->] := far_le (nth_in k lk) (nth_in i li) le la (esym E).
have <- : size (flatten [seq along i | i <- iota 0 (size members)]) = remaining 0; last first.
  by rewrite -(card_uniqP uf) max_card.
rewrite size_flatten /shape -map_comp /remaining; congr sumn; rewrite -[X in _ = map _ X](mkseq_nth m0) /mkseq -map_comp.
by apply: eq_map => i /=; rewrite size_map size_iota subn0.
Qed.

Lemma walk_on_right rounds left r meets : have_met r meets -> remaining r <= left -> remaining r <= rounds ->
  exists r' found, [/\ walk_on step members rounds left (under_way r members) meets = Some found, have_met r' found
    & size (under_way r' members) <= 1].
Proof.
elim: rounds left r meets => [|rounds IH] left r meets H lel ler /=; case: ifP => [few|many]; try by exists r, meets.
  by move: ler many; rewrite remaining_less leqn0 addn_eq0 => /andP[_ /eqP->].
have size_le : size (under_way r members) <= remaining r by rewrite remaining_less leq_addl.
rewrite (leq_trans size_le lel).
have [||||met A M] := @advance_right r [seq m <- members | r <= far m] meets.
- exact: filter_uniq.
- by move=> m; rewrite mem_filter => /andP[].
- by move=> m; rewrite mem_filter => /andP[].
- by move=> w /H[m mm [lt ->]]; exists m => //; rewrite mem_filter leqNgt lt.
rewrite /under_way A; set still := [seq _ | m <- _ & r < far m].
have stillE : still = under_way r.+1 members.
  by rewrite /still /under_way -filter_predI; congr map; apply: eq_filter => m /=; case: (ltnP r (far m)) => // /ltnW->.
rewrite stillE; apply: IH.
- move=> w; rewrite M; split=> [[/H[m mm [lt ->]]|[m + [E ->]]]|[m mm [lt ->]]].
  + by exists m => //; rewrite ltnS ltnW.
  + by rewrite mem_filter => /andP[_ mm]; exists m => //; rewrite E.
  by move: lt; rewrite ltnS leq_eqVlt => /orP[/eqP E|lt]; [right; exists m; rewrite // mem_filter E leqnn|left; apply/H; exists m].
- by rewrite -[size _]/(size (under_way r members)) leq_subRL ?(leq_trans size_le lel) // addnC -remaining_less.
rewrite -ltnS; apply: leq_trans ler; rewrite [remaining r]remaining_less -addn1 leq_add2l; move/negbT: many; rewrite -ltnNge; exact: ltnW.
Qed.

Theorem on_one_complete limit : #|T| <= limit -> on_one step members limit.
Proof.
move=> lim; rewrite /on_one; case M: members => [|m0 ms] //; rewrite -M.
have [|||r [found [W H few]]] := @walk_on_right limit limit 0 [::].
- by move=> w; split=> // -[m _ []].
- exact: leq_trans remaining_fits lim.
- exact: leq_trans remaining_fits lim.
have E0 : under_way 0 members = [seq (m, m) | m <- members].
  by rewrite /under_way (eq_filter (a2 := predT)) ?filter_predT.
rewrite E0 in W; rewrite W; set first := chain_first members found m0.
have met m : m \in members -> far m < r -> met_by found m = Some (nxt m).
  move=> mm lt; rewrite /met_by; case E: [seq w.2 | w <- found & w.1 == m] => [|y ys] /=.
    have: nxt m \in [seq w.2 | w <- found & w.1 == m].
      by apply/mapP; exists (m, nxt m); rewrite // mem_filter eqxx; apply/H; exists m.
    by rewrite E.
  have: y \in [seq w.2 | w <- found & w.1 == m] by rewrite E mem_head.
  by case/mapP=> w; rewrite mem_filter => /andP[/eqP wm /H[m' _ [_ E']]] ->; rewrite E' in wm *; rewrite -wm.
have first_in : first \in members.
  rewrite /first /chain_first; case E: [seq m <- members | _] => [|x xs] /=; first by rewrite M mem_head.
  have: x \in [seq m <- members | m \notin map snd found] by rewrite E mem_head.
  by rewrite mem_filter => /andP[].
(* Whoever has not met the next one is before the first. *)
have last m : m \in members -> r <= far m -> nxt m = first.
  move=> mm le; have free : nxt m \notin map snd found.
    apply/negP=> /mapP[w /H[m' mm' [lt ->]] /= /(nxt_inj mm mm') E]; by rewrite -E ltnNge le in lt.
  have: first \in [seq x <- members | x \notin map snd found].
    rewrite /first /chain_first; case E: [seq x <- members | _] => [|x xs] /=; last by rewrite mem_head.
    have: nxt m \in [seq x <- members | x \notin map snd found] by rewrite mem_filter free far_hits.
    by rewrite E.
  rewrite mem_filter => /andP[free' _]; have [m' mm' E] := nxt_onto first_in; rewrite -E; congr nxt.
  case: (ltnP (far m') r) => [lt|le']; first by case/negP: free'; apply/mapP; exists (m', nxt m') => //; apply/H; exists m'.
  have mu : m \in [seq x <- members | r <= far x] by rewrite mem_filter le.
  have mu' : m' \in [seq x <- members | r <= far x] by rewrite mem_filter le'.
  move: few; rewrite size_map; case: [seq x <- members | _] mu mu' => [|a [|b c]] //.
  by rewrite !inE => /eqP-> /eqP->.
have returns i : i < (size members).-1 -> iter i.+1 nxt first <> first.
  by move=> lt; apply: nxt_returns => //; rewrite -ltnS prednK // in lt; rewrite M.
have chainP n x : (forall i, i < n -> met_by found (iter i nxt x) = Some (iter i.+1 nxt x) /\ iter i.+1 nxt x <> first) ->
    chains found first n x.
  elim: n x => // n IH x C /=; have [/= -> /eqP->] := C 0 isT; apply: IH => i lt.
  by have := C i.+1 lt; rewrite -!iterSr.
apply: chainP => i lt; split; last exact: returns.
have mi := iter_nxt i first_in; rewrite met //; case: ltnP => // le.
by case: (returns i lt); rewrite iterS; apply: last.
Qed.

End Complete.

(** ** The same of numbers *)

Section Renamed.
Variables (T U : eqType) (g : T -> U) (step : T -> option T) (step' : U -> option U) (members : seq T).
Hypothesis inj : injective g.
Hypothesis steps : forall x, step' (g x) = omap g (step x).

Let both (w : T * T) := (g w.1, g w.2).

Lemma map_both meets : map snd (map both meets) = map g (map snd meets).
Proof. by rewrite -!map_comp. Qed.

Lemma advance_renamed walks meets :
  advance step' (map g members) (map both walks) (map both meets) = omap (fun r => (map both r.1, map both r.2)) (advance step members walks meets).
Proof.
elim: walks meets => [|[from at_] rest IH] meets //=; rewrite steps; case: (step at_) => [next|] //=.
rewrite map_both !(mem_map inj); case: ifP => _; last by rewrite IH; case: (advance _ _ _ _) => [[st me]|].
by case: ifP => // _; rewrite -[(g from, g next) :: _]/(map both ((from, next) :: meets)) IH.
Qed.

Lemma walk_on_renamed rounds left walks meets :
  walk_on step' (map g members) rounds left (map both walks) (map both meets) = omap (map both) (walk_on step members rounds left walks meets).
Proof.
elim: rounds left walks meets => [|rounds IH] left walks meets /=; rewrite size_map; case: ifP => // _.
case: ifP => // _; rewrite advance_renamed; case: (advance _ _ _ _) => [[st me]|] //=; exact: IH.
Qed.

Lemma met_by_renamed meets m : met_by (map both meets) (g m) = omap g (met_by meets m).
Proof.
rewrite /met_by filter_map -map_comp (eq_filter (a2 := fun w => w.1 == m)) => [|w] /=; last by rewrite (inj_eq inj).
by case: [seq w <- meets | _].
Qed.

Lemma chains_renamed meets first n x : chains (map both meets) (g first) n (g x) = chains meets first n x.
Proof.
elim: n x => //= n IH x; rewrite met_by_renamed; case: (met_by meets x) => [y|] //=; by rewrite IH (inj_eq inj).
Qed.

Lemma on_one_renamed limit : on_one step' (map g members) limit = on_one step members limit.
Proof.
have [M|[m0 [ms M]]] : members = [::] \/ exists m0 ms, members = m0 :: ms.
- by case: members => [|m0 ms]; [left|right; exists m0, ms].
- by rewrite M.
have M' : map g members = g m0 :: map g ms by rewrite M.
rewrite (on_oneE _ _ M) (on_oneE _ _ M') size_map.
have -> : [seq (m, m) | m <- map g members] = map both [seq (m, m) | m <- members] by rewrite -!map_comp.
rewrite -[X in walk_on _ _ _ _ _ X]/(map both [::]) walk_on_renamed; case: (walk_on _ _ _ _ _ _) => [meets|] //=.
suff -> : chain_first (map g members) (map both meets) (g m0) = g (chain_first members meets m0) by rewrite chains_renamed.
rewrite /chain_first map_both filter_map; set a := preim _ _.
rewrite (eq_filter (a2 := fun m => m \notin map snd meets)) => [|m]; last by rewrite /a /= (mem_map inj).
by case: [seq m <- members | _].
Qed.

End Renamed.

(** ** V2, and B1 of half-edges, are decided by the members *)

Section Views.
Variables t t' : view.
Hypothesis map' : is_map t'.

Section Walk.
Variables (f f' key key' : nat -> link) (step' : dart t' -> dart t').
Hypothesis leads' : forall x, f' (num x) = Some (num (step' x)).
Hypothesis inj : injective step'.
Hypothesis constant : forall x, key' (num (step' x)) = key' (num x).
Hypothesis labelled : forall x : dart t', key' (num x) <> None.
Hypothesis total : forall h, half_edge t h -> exists2 k, f h = Some k & half_edge t k.
Hypothesis before : forall g h, half_edge t g -> half_edge t h -> (on_orbit f g h <-> key g = key h).

Notation member := (member (half_edge t) (half_edge t') f f' key key').
Notation was_here := (was_here (half_edge t) key key').

Variables (limit : nat) (ms : nat -> seq nat).
Hypothesis enough : half_edge_slots t' <= limit.
Hypothesis listed : forall v, uniq (ms v) /\ forall h, h \in ms v <-> member h /\ key' h = Some v.

(** If one that was there before is left, a member was there before. *)
Definition joins := forall h m, half_edge t' h -> was_here h -> member m -> key' m = key' h ->
  exists m', [/\ member m', was_here m' & key' m' = key' h].

Lemma walked_meet v : on_one f' (ms v) limit <-> forall g h, g \in ms v -> h \in ms v -> on_orbit f' g h.
Proof.
have [u mem] := listed v; have live h : h \in ms v -> half_edge t' h by move/mem => [[]].
have sym g h : half_edge t' g -> half_edge t' h -> on_orbit f' g h -> on_orbit f' h g.
  by move=> /dartP[x <-] /dartP[y <-]; rewrite !(on_walk leads') fconnect_sym.
split=> [S g h gm hm|meet].
  have [m mm [mg mh]] := on_one_sound S u gm hm.
  exact: leads_trans (sym m g (live m mm) (live g gm) mg) mh.
have [xs E] : exists xs : seq (dart t'), ms v = [seq num x | x <- xs].
  elim: (ms v) live => [|h hs IH] lv; first by exists [::].
  have [x <-] := dartP (lv h (mem_head _ _)); have [|xs ->] := IH; first by move=> k kh; apply: lv; rewrite inE kh orbT.
  by exists (x :: xs).
have inj_num : injective (fun x : dart t' => num x) by exact: num_inj.
rewrite E (on_one_renamed (step := fun x => Some (step' x)) xs inj_num leads').
apply: on_one_complete => //.
- by rewrite -(map_inj_uniq inj_num) -E.
- by move=> x y xm ym; apply/(on_walk leads'); apply: meet; rewrite E (map_f (fun x : dart t' => num x)).
by apply: leq_trans enough; apply: card_slot.
Qed.

Theorem walked : (forall g h, half_edge t' g -> half_edge t' h -> (on_orbit f' g h <-> key' g = key' h)) <->
  (forall v, on_one f' (ms v) limit) /\ joins.
Proof.
split=> [now|[walks join]].
  split=> [v|h m lh oh mm E].
    apply/walked_meet => g h /(listed v).2[[lg _] Eg] /(listed v).2[[lh _] Eh].
    by apply/(now g h lg lh); rewrite Eg Eh.
  have [lm nm] := mm; have [n] := (now h m lh lm).2 (esym E).
  suff old k i : iter i (obind f') (Some h) = Some k -> (exists m', [/\ member m', was_here m' & key' m' = key' h]) \/ was_here k /\ key' k = key' h.
    by case/old=> // -[om km]; exists m.
  elim: i k => [|i IH] k; first by case=> <-; right.
  rewrite iterS; case I: (iter i _ _) => [j|] // jk; have {}jk : f' j = Some k := jk.
  case: (IH j I) => [|[[lj kj] Ej]]; first by left.
  have lj' : half_edge t' j.
    case: i I {IH} => [|i]; first by case=> <-.
    rewrite iterS; case I: (iter i _ _) => [l|] // lj'; have {}lj' : f' l = Some j := lj'.
    have [l'|no] := boolP (half_edge t' l); first by case: (dartP l') lj' => x <-; rewrite leads' => -[<-]; apply: dart_live.
    have : exists x : dart t', on_orbit f' (num x) l by case: (dartP lh) => x xh; exists x, i; rewrite xh.
    case=> x xl; move: no; suff -> : half_edge t' l by [].
    by apply: (on_orbit_live (@half_edge_below t') (says := f') _ xl) => z /dartP[y <-]; exists (num (step' y)); rewrite ?leads' ?dart_live.
  case: (f j =P f' j) => [same|other]; last by left; exists j; split=> //; split=> // -[_ /other].
  right; have [k' K lk] := total lj; move: K; rewrite same jk => -[kk]; rewrite -{k'}kk in lk.
  have [y yj] := dartP lj'; have Ek : key' k = key' j by move: jk; rewrite -yj leads' => -[<-]; apply: constant.
  split; last by rewrite Ek.
  split=> //; rewrite Ek -kj; apply/esym/(before lj lk); by exists 1; rewrite /= same jk.
apply: (near_walk leads' inj constant before _ join) => g h mg mh E.
have [lg _] := mg; case: (dartP lg) E => x xg; case K: (key' g) => [v|]; last by move: (labelled (x := x)); rewrite xg K.
move=> /esym Eh; apply: (walked_meet v).1 (walks v) _ _ _ _; by apply/(listed v).2.
Qed.

End Walk.

(** V2 holds now if and only if the walks find, at each vertex, the members on one orbit, and none of before is left alone. *)
Theorem near_rotations_walked limit (ms : nat -> seq nat) : is_map t -> v2_rotation t -> half_edge_slots t' <= limit ->
  let member := member (half_edge t) (half_edge t') (turn t) (turn t') (origin t) (origin t') in
  (forall v, uniq (ms v) /\ forall h, h \in ms v <-> member h /\ origin t' h = Some v) ->
  v2_rotation t' <-> (forall v, on_one (turn t') (ms v) limit) /\ joins (turn t) (turn t') (origin t) (origin t').
Proof.
move=> map old enough member listed; apply: (walked (turnE map') (tn_inj map') _ _ (turn_total map) old enough listed) => x.
  by rewrite !(originE map') (org_tn map').
by rewrite (originE map').
Qed.

(** And so it is with the cycles of boundary components. *)
Theorem near_cycles_walked limit (ms : nat -> seq nat) : is_map t -> one_cycle_each t ->
  (forall h, half_edge t' h -> next t' h >>= boundary_of t' = boundary_of t' h) -> half_edge_slots t' <= limit ->
  let member := member (half_edge t) (half_edge t') (next t) (next t') (boundary_of t) (boundary_of t') in
  (forall b, uniq (ms b) /\ forall h, h \in ms b <-> member h /\ boundary_of t' h = Some b) ->
  one_cycle_each t' <-> (forall b, on_one (next t') (ms b) limit) /\ joins (next t) (next t') (boundary_of t) (boundary_of t').
Proof.
move=> map old const enough member listed; apply: (walked (nextE map') (nx_inj map') _ _ (next_total map) old enough listed) => x.
  by have := const _ (dart_live x); rewrite (nextE map').
by rewrite (boundaryE map').
Qed.

End Views.

(** Three members on a cycle of six are found on one orbit, after six steps and not after three; on two cycles of three they are not. *)
Example three_walks :
  let six n := Some (if n == 5 then 0 else n.+1) in
  let three n := Some (if n == 2 then 0 else if n == 5 then 3 else n.+1) in
  [/\ on_one six [:: 0; 2; 3] 6, ~~ on_one six [:: 0; 2; 3] 3 & ~~ on_one three [:: 0; 2; 3] 6].
Proof. by vm_compute. Qed.
