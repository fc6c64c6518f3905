(** * Numbered: Euler's formula for numbered half-edges

    What Euler.v says of a finite type is said here of numbers: the half-edges of a view, or some of them, closed under
    the links. *)

From mathcomp Require Import all_ssreflect all_fingroup.
From twinedge Require Import Arith View Rules Loops LoopsProof Reference Counting Drawing Euler.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section Numbered.
Variables (t : view) (dart : finType) (turns : {perm dart}) (twins : dart -> dart) (num : dart -> nat).
Variable p : nat -> Prop.
Hypothesis twK : involutive twins.
Hypothesis tw_neq : forall x, twins x != x.
Hypothesis num_inj : injective num.
Hypothesis numP : forall h, p h <-> exists x, num x = h.
Hypothesis twinN : forall x, twin t (num x) = Some (num (twins x)).
Hypothesis nextN : forall x, next t (num x) = Some (num (turns (twins x))).
Hypothesis prevN : forall x, prev t (num (turns (twins x))) = Some (num x).

Lemma turnN x : turn t (num x) = Some (num (turns x)).
Proof. by rewrite /turn twinN /= nextN twK. Qed.

Lemma num_p x : p (num x). Proof. by apply/numP; exists x. Qed.

(** A list of numbers of half-edges is the list of their numbers. *)
Lemma unnumber (s : seq nat) : (forall h, h \in s -> p h) -> exists s', s = map num s'.
Proof.
elim: s => [|h s IH] H; first by exists [::].
case: IH => [g gs|s' ->]; first by apply: H; rewrite inE gs orbT.
by have /numP[x <-] := H h (mem_head _ _); exists (x :: s').
Qed.

(** One of each orbit: as many as orbits. *)
Lemma orbits_size (f : {perm dart}) says s : (forall x, says (num x) = Some (num (f x))) ->
  lists_one_of_each s (on_orbit says) p -> size s = #|porbits f|.
Proof.
move=> saysN [u sp one all]; have [s' E] := unnumber sp; rewrite E size_map.
have orbitE x y : on_orbit says (num x) (num y) <-> y \in porbit f x.
  have iterE k : iter k (obind says) (Some (num x)) = Some (num ((f ^+ k)%g x)).
    by elim: k => [|k IH] /=; rewrite ?expg0 ?perm1 // IH /= saysN expgSr permM.
  by split=> [[k]|/porbitP[k ->]]; [rewrite iterE => -[/num_inj<-]; apply: mem_porbit | exists k].
have us : uniq (map (porbit f) s').
  rewrite map_inj_in_uniq; first by move: u; rewrite E (map_inj_uniq num_inj).
  move=> x y xs ys /eqP; rewrite eq_porbit_mem => xy; apply: num_inj; apply: one; rewrite ?E ?map_f //.
  by apply/orbitE; rewrite porbit_sym.
rewrite -(size_map (porbit f)) -(card_uniqP us); apply: eq_card => A; apply/mapP/imsetP => [[x xs ->]|[x _ ->]].
  by exists x.
have [h hs] := all _ (num_p x); move: hs; rewrite E => /mapP[y ys ->] /orbitE yx.
by exists y => //; apply/eqP; rewrite eq_porbit_mem.
Qed.

(** One of each piece: as many as pieces. *)
Lemma pieces_size s : lists_one_of_each s (reached (near t)) p -> size s = n_comp (links turns twins) dart.
Proof.
case=> [u sp one all]; have [s' E] := unnumber sp; rewrite E size_map.
have nearN x : near t (num x) = [seq num y | y <- [:: turns (twins x); twins (turns^-1 x)%g; twins x]].
  have := prevN (twins (turns^-1 x)%g); rewrite twK permKV => E'.
  by rewrite /near nextN twinN E'.
have sym : connect_sym (links turns twins).
  have [edges every] := every_edge_exists twK tw_neq.
  have H := on_piece_sym turns twK edges.
  by move=> x y; rewrite -!(eq_connect (link_every turns twK every)) H.
have linksE x y : links turns twins x y = (y == turns x) || (y == twins x) by [].
have pieceE x y : reached (near t) (num x) (num y) <-> connect (links turns twins) x y.
  split=> [|/connectP[q]].
    suff: forall h, reached (near t) (num x) h -> exists2 z, num z = h & connect (links turns twins) x z.
      by move=> H /H[z /num_inj->].
    move=> h; elim=> [|g k _ [z <- xz]]; first by exists x.
    rewrite nearN => /mapP[w wz ->]; exists w => //; apply: connect_trans xz _.
    have tw v : connect (links turns twins) v (twins v) by apply: connect1; rewrite linksE eqxx orbT.
    have tn v : connect (links turns twins) v (turns v) by apply: connect1; rewrite linksE eqxx.
    move: wz; rewrite !inE => /or3P[] /eqP->; [exact: connect_trans (tw z) (tn _)| |exact: tw].
    apply: connect_trans (tw _); by rewrite sym -{2}[z](permKV turns).
  elim: q x => [|z q IH] x /=; first by move=> _ ->; apply: reached_self.
  case/andP=> xz /IH/[apply]; apply: reached_trans.
  have tw v : reached (near t) (num v) (num (twins v)).
    by apply: reached_near (reached_self _ _) _; rewrite nearN !inE eqxx !orbT.
  have nx v : reached (near t) (num v) (num (turns (twins v))).
    by apply: reached_near (reached_self _ _) _; rewrite nearN !inE eqxx.
  case/orP: xz => /eqP-> //; apply: reached_trans (tw x) _.
  by have := nx (twins x); rewrite twK.
have rootE x y : connect (links turns twins) x y = (root (links turns twins) x == root (links turns twins) y).
  by rewrite root_connect.
have us : uniq (map (root (links turns twins)) s').
  rewrite map_inj_in_uniq; first by move: u; rewrite E (map_inj_uniq num_inj).
  move=> x y xs ys /eqP; rewrite -rootE => xy; apply: num_inj; apply: one; rewrite ?E ?map_f //.
  exact/pieceE.
have -> : n_comp (links turns twins) dart = #|[pred z | roots (links turns twins) z]|.
  by apply: eq_card => z; rewrite !inE andbT.
rewrite -(size_map (root (links turns twins))) -(card_uniqP us); apply: eq_card => z.
rewrite [RHS]inE; apply/mapP/idP => [[x xs ->]|rz]; first exact: roots_root.
have [h hs] := all _ (num_p z); move: hs; rewrite E => /mapP[y ys ->] /pieceE yz.
by exists y => //; apply/eqP; rewrite eq_sym -(eqP rz) -rootE.
Qed.

(** One of each edge: half as many as half-edges. *)
Lemma edges_size s : lists_one_of_each s (same_edge t) p -> (size s).*2 = #|dart|.
Proof.
case=> [u sp one all]; have [s' E] := unnumber sp; rewrite E size_map; apply: (@size_every _ twins) => //.
have edgeE x y : same_edge t (num x) (num y) <-> x = y \/ twins x = y.
  by rewrite /same_edge twinN; split=> [[/num_inj|[/num_inj]]|[->|->]]; by [left|right].
split.
  rewrite cat_uniq; move: (u); rewrite E (map_inj_uniq num_inj) => us; rewrite us (map_inj_uniq (inv_inj twK)) us andbT /=.
  apply/hasPn=> x /mapP[y ys ->]; apply/negP=> tys.
  have /num_inj yE : num (twins y) = num y.
    by apply: one; rewrite ?E ?map_f //; apply/edgeE; right.
  by have := tw_neq y; rewrite yE eqxx.
move=> x; have [h hs] := all _ (num_p x); move: hs; rewrite E mem_cat => /mapP[y ys ->] /edgeE[<-|<-].
  by rewrite ys.
by rewrite map_f ?orbT.
Qed.

(** Euler's formula. *)
Theorem numbered_euler edges vs cs es ps : every_edge twins edges ->
  lists_one_of_each vs (on_orbit (turn t)) p -> lists_one_of_each cs (on_orbit (next t)) p ->
  lists_one_of_each es (same_edge t) p -> lists_one_of_each ps (reached (near t)) p ->
  size vs + size cs + (handles turns twins edges).*2 = size es + (size ps).*2.
Proof.
move=> every /(orbits_size turnN)-> Hc /edges_size He /pieces_size->.
have W x : next t (num x) = Some (num (walk turns twins edges x)) by rewrite walk_every // nextN.
rewrite (orbits_size W Hc).
have := euler turns twK tw_neq edges; rewrite (eq_n_comp (eq_connect (link_every turns twK every))).
by have := size_every every; rewrite -He => /double_inj->.
Qed.

End Numbered.
