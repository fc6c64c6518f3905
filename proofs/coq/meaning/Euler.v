(** * Euler: Euler's formula, by drawing one edge after another

    Everything in this file is about a finite type of half-edges, a permutation [turn] of it, and an involution [twin]
    without fixed points.

<<
                                            vertices + walks + 2 · handles = edges + 2 · pieces
      before any edge is drawn                 n          n        0           0          n
      an edge within a walk splits it                    + 1                  + 1
      an edge between two pieces joins them              − 1                  + 1        − 1
      any other edge                                     − 1      + 1         + 1
>>
*)

From mathcomp Require Import all_ssreflect all_fingroup.
From twinedge Require Import Arith Drawing.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** ** A link between two pieces joins them, and another link changes nothing *)

Section Links.
Variables (T : finType) (e e' : rel T) (x y : T).
Hypothesis sym : connect_sym e.
Hypothesis sym' : connect_sym e'.
Hypothesis more : forall u v, e' u v = e u v || ((u == x) && (v == y)) || ((u == y) && (v == x)).

Lemma sub_connect : subrel (connect e) (connect e').
Proof. by apply: connect_sub => u v uv; apply: connect1; rewrite more uv. Qed.

Lemma connect_xy : connect e' x y.
Proof. by apply: connect1; rewrite more !eqxx /= orbT. Qed.

Lemma connect_more u v : connect e' u v =
  [|| connect e u v, connect e u x && connect e y v | connect e u y && connect e x v].
Proof.
apply/idP/idP => [|/or3P[/sub_connect //|/andP[ux yv]|/andP[uy xv]]]; last 2 first.
- by apply: connect_trans (sub_connect ux) _; apply: connect_trans connect_xy (sub_connect yv).
- apply: connect_trans (sub_connect uy) _; apply: connect_trans (sub_connect xv).
  by rewrite sym' connect_xy.
case/connectP=> p; elim: p u => [|w p IH] u /=; first by move=> _ ->; rewrite connect0.
rewrite more => /andP[uw /IH/[apply]]; case/orP: uw => [/orP[uw|/andP[/eqP-> /eqP->]]|/andP[/eqP-> /eqP->]].
- by rewrite !(same_connect sym (connect1 uw)).
- by rewrite !connect0 /=; case/or3P=> [->|/andP[_ ->]|->]; rewrite ?orbT.
- by rewrite !connect0 /=; case/or3P=> [->|->|/andP[_ ->]]; rewrite ?orbT.
Qed.

Lemma n_comp_more : n_comp e' T + ~~ connect e x y = n_comp e T.
Proof.
case xy: (connect e x y); rewrite /= ?addn0.
  apply: eq_n_comp => u v; rewrite connect_more; apply/idP/idP => [|->] //.
  case/or3P=> // /andP[a b]; first exact: connect_trans a (connect_trans xy b).
  by apply: connect_trans a _; apply: connect_trans b; rewrite sym.
pose a := [pred u | connect e u x || connect e u y].
have cl : closed e a.
  by apply: (intro_closed sym) => u v uv; rewrite !inE !(same_connect sym (connect1 uv)).
have cl' : closed e' a.
  apply: (intro_closed sym') => u v; rewrite more => /orP[/orP[uv|]|] /=.
  - by rewrite !inE !(same_connect sym (connect1 uv)).
  - by case/andP=> /eqP-> /eqP-> _; rewrite inE connect0 orbT.
  - by case/andP=> /eqP-> /eqP-> _; rewrite inE connect0.
rewrite (n_compC a) [RHS](n_compC a).
have -> : n_comp e a = 2.
  have -> : n_comp e a = n_comp e (closure e (pred2 x y)).
    apply: eq_n_comp_r => u; rewrite !inE; apply/orP/pred0Pn => [[ux|uy]|[v /andP[uv]]].
    - by exists x; rewrite /= 2!inE ux eqxx.
    - by exists y; rewrite /= 2!inE uy eqxx orbT.
    by rewrite !inE => /orP[]/eqP E; rewrite -E; [left|right].
  by rewrite n_comp_closure2 // xy.
have -> : n_comp e' a = 1.
  have -> : n_comp e' a = n_comp e' (connect e' x).
    apply: eq_n_comp_r => u; rewrite !inE sym' connect_more connect0 andbT.
    by case: (connect e u x).
  exact: n_comp_connect.
rewrite addnAC; congr (_ + _); apply: eq_card => u; rewrite !inE; case ua: (_ || _); rewrite ?andbF // !andbT.
rewrite /roots /=; congr (_ == _); rewrite /root; congr (odflt _ _); apply: eq_pick => v; rewrite connect_more.
by move/negbT: ua; rewrite negb_or => /andP[/negPf-> /negPf->]; rewrite orbF.
Qed.

End Links.

Section Euler.
Variables (dart : finType) (turn : {perm dart}) (twin : dart -> dart).
Hypothesis twK : involutive twin.
Hypothesis tw_neq : forall x, twin x != x.
Implicit Types (x y : dart) (edges : seq dart).

Notation walk := (walk turn twin).
Notation on_walk := (on_walk turn twin).
Notation link_of := (link_of turn twin).
Notation on_piece := (on_piece turn twin).
Notation drawn := (drawn turn twin).

Lemma link_ofE edges x y :
  link_of edges x y = (y == turn x) || (y == twin x) && ((x \in edges) || (y \in edges)).
Proof. by []. Qed.

(** The number of edges that need a handle. *)
Fixpoint handles edges : nat :=
  if edges is x :: before then (~~ on_walk before x (twin x) && on_piece before x (twin x)) + handles before else 0.

Lemma drawnP edges : drawn edges <-> handles edges = 0.
Proof.
elim: edges => //= x edges IH; rewrite IH; split=> [[[->|/negPf->] ->]|]; rewrite ?andbF //.
case: (on_walk _ _ _) => /=; first by move=> <-; split=> //; left.
by case: (on_piece _ _ _) => //= <-; split=> //; right.
Qed.

Lemma on_piece_turn edges x : on_piece edges x (turn x).
Proof. by apply: connect1; rewrite link_ofE eqxx. Qed.

Lemma on_piece_sym edges : connect_sym (link_of edges).
Proof.
suff H x y : connect (link_of edges) x y -> connect (link_of edges) y x.
  by move=> x y; apply/idP/idP; apply: H.
case/connectP=> p; elim: p x => [|z p IH] x /=; first by move=> _ ->; apply: connect0.
case/andP=> xz /IH/[apply] yz; apply: connect_trans yz _; case/orP: xz => [/eqP->|/andP[/eqP-> E]].
  have /porbitP[i] : x \in porbit turn (turn x) by rewrite porbit_sym (mem_porbit turn 1).
  move=> E; have {2}-> := E; elim: i {E} => [|i IHi]; first by rewrite expg0 perm1 connect0.
  by rewrite expgSr permM; apply: connect_trans IHi _; apply: on_piece_turn.
by apply: connect1; rewrite link_ofE twK eqxx [(twin x \in _) || _]orbC E orbT.
Qed.

Lemma link_more x edges u v :
  link_of (x :: edges) u v = link_of edges u v || ((u == x) && (v == twin x)) || ((u == twin x) && (v == x)).
Proof.
have A : (u == x) && (v == twin x) = (v == twin u) && (u == x).
  by case: (u =P x) => [->|_]; rewrite ?andbT ?andbF.
have B : (u == twin x) && (v == x) = (v == twin u) && (v == x).
  case: (v =P x) => [->|_]; rewrite ?andbF // !andbT.
  by apply/eqP/eqP => ->; rewrite twK.
rewrite !link_ofE !inE A B; move: (v == turn u) (v == twin u) (u == x) (v == x) (u \in edges) (v \in edges).
by do 6!case.
Qed.

(** A walk stays on its piece. *)
Lemma walk_piece edges x : on_piece edges x (walk edges x).
Proof.
elim: edges x => [|y edges IH] x; first exact: on_piece_turn.
have sub : subrel (on_piece edges) (on_piece (y :: edges)).
  by apply: connect_sub => u v uv; apply: connect1; rewrite link_more uv.
rewrite /= permM; apply: connect_trans (sub _ _ (IH _)).
case: tpermP => [->|->|_ _]; last exact: connect0.
  by apply: connect1; rewrite link_more !eqxx orbT.
by apply: connect1; rewrite link_more !eqxx !orbT.
Qed.

Lemma on_walk_piece edges x y : on_walk edges x y -> on_piece edges x y.
Proof.
case/porbitP=> i ->; elim: i => [|i IH]; first by rewrite expg0 perm1; apply: connect0.
by rewrite expgSr permM; apply: connect_trans IH _; apply: walk_piece.
Qed.

(** ** Euler's formula *)

Theorem euler edges :
  #|porbits turn| + #|porbits (walk edges)| + (handles edges).*2 = size edges + (n_comp (link_of edges) dart).*2.
Proof.
elim: edges => [|x edges IH].
  rewrite /= addn0 add0n addnn; congr _.*2.
  have E : link_of [::] =2 frel turn by move=> x y; rewrite link_ofE !in_nil andbF orbF eq_sym.
  rewrite (eq_n_comp (eq_connect E)) /n_comp_mem.
  have conn x y : fconnect turn x y = (y \in porbit turn x).
    apply/idP/porbitP => [/iter_findex <-|[i ->]]; last by rewrite permX fconnect_iter.
    by exists (findex turn x y); rewrite permX.
  have rootE x y : (porbit turn x == porbit turn y) = (froot turn x == froot turn y).
    by rewrite eq_porbit_mem porbit_sym -conn root_connect //; apply: fconnect_sym; apply: perm_inj.
  have -> : porbits turn = [set porbit turn x | x in [pred x | froots turn x]].
    apply/setP=> A; apply/imsetP/imsetP => -[x _ ->]; last by exists x.
    exists (froot turn x); first by rewrite inE; apply: roots_root; apply: fconnect_sym; apply: perm_inj.
    by apply/eqP; rewrite rootE root_root //; apply: fconnect_sym; apply: perm_inj.
  rewrite card_in_imset; first by apply: eq_card => x; rewrite !inE andbT.
  by move=> x y; rewrite !inE => /eqP rx /eqP ry /eqP; rewrite rootE rx ry => /eqP.
have T : #|porbits (walk (x :: edges))| + (~~ on_walk edges x (twin x)).*2 = #|porbits (walk edges)| + 1.
  by have := porbits_mul_tperm (walk edges) x (twin x); rewrite /= eq_sym tw_neq porbit_sym.
have P : n_comp (link_of (x :: edges)) dart + ~~ on_piece edges x (twin x) = n_comp (link_of edges) dart.
  exact: n_comp_more (on_piece_sym edges) (on_piece_sym (x :: edges)) (link_more x edges).
have Q := @on_walk_piece edges x (twin x).
rewrite [handles _]/= [size _]/=; move: T P Q.
case: (on_walk edges x (twin x)) (on_piece edges x (twin x)) => [] [] T P Q; cbn [negb andb] in *.
- by arith.
- by have := Q isT.
- by arith.
- by arith.
Qed.

(** ** When every edge is drawn *)

Definition after x : dart := turn (twin x).

Lemma every_cons y edges :
  perm_eq ((y :: edges) ++ map twin (y :: edges)) (y :: twin y :: edges ++ map twin edges).
Proof. by rewrite /= perm_cons -cat1s perm_catCA. Qed.

Lemma walkE edges x : uniq (edges ++ map twin edges) ->
  walk edges x = turn (if x \in edges ++ map twin edges then twin x else x).
Proof.
elim: edges x => // y edges IH x.
rewrite (perm_uniq (every_cons y edges)) (perm_mem (every_cons y edges)) !cons_uniq !inE negb_or.
case/and3P=> /andP[_ yn] tyn u; rewrite [walk _]/= permM IH //.
case: tpermP => [->|->|/eqP/negPf-> /eqP/negPf->] //; first by rewrite (negPf tyn) eqxx.
by rewrite (negPf yn) eqxx orbT twK.
Qed.

Lemma walk_every edges : every_edge twin edges -> walk edges =1 after.
Proof. by move=> [u all] x; rewrite walkE // all. Qed.

Lemma size_every edges : every_edge twin edges -> (size edges).*2 = #|dart|.
Proof.
case=> u all; rewrite cardE -addnn -{2}(size_map twin) -size_cat; apply: perm_size.
by apply: uniq_perm; rewrite ?enum_uniq // => x; rewrite all mem_enum.
Qed.

Definition links : rel dart := [rel x y | (y == turn x) || (y == twin x)].

Lemma link_every edges : every_edge twin edges -> link_of edges =2 links.
Proof.
case=> _ all x y; rewrite link_ofE /links [RHS]/=; case: (y =P twin x) => [yx|_] //=; congr (_ || _).
have := all x; rewrite mem_cat => /orP[->//|/mapP[z ze xz]].
by rewrite yx xz twK ze orbT.
Qed.

(** The genus: the number of edges that need a handle, which is the same in every order. *)
Theorem genus edges edges' : every_edge twin edges -> every_edge twin edges' -> handles edges = handles edges'.
Proof.
move=> H H'; have := euler edges; have := euler edges'.
rewrite (eq_n_comp (eq_connect (link_every H))) (eq_n_comp (eq_connect (link_every H'))).
have -> : walk edges' = walk edges by apply/permP=> x; rewrite !walk_every.
by have := size_every H; have := size_every H'; arith.
Qed.

(** There is an order. *)
Lemma every_edge_exists : exists edges, every_edge twin edges.
Proof.
suff [edges u all] : exists2 edges, uniq (edges ++ map twin edges) & forall x, x \in enum dart -> x \in edges ++ map twin edges.
  by exists edges; split=> // x; apply: all; rewrite mem_enum.
elim: (enum dart) => [|y s [edges u IH]]; first by exists [::].
case E: (y \in edges ++ map twin edges).
  by exists edges => // x; rewrite inE => /orP[/eqP->|/IH].
have E' : twin y \notin edges ++ map twin edges.
  rewrite mem_cat; apply/norP; move/negbT: E; rewrite mem_cat => /norP[E1 E2]; split.
    by apply: contra E2 => ty; apply/mapP; exists (twin y); rewrite ?twK.
  by apply: contra E1 => /mapP[z ze /(inv_inj twK)->].
exists (y :: edges) => [|x].
  by rewrite (perm_uniq (every_cons y edges)) !cons_uniq inE negb_or eq_sym tw_neq E E' u.
rewrite (perm_mem (every_cons y edges)) !inE => /orP[->|/IH->] //.
by rewrite !orbT.
Qed.

End Euler.
