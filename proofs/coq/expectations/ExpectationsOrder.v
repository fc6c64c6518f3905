(** * ExpectationsOrder: nested faces can be put down, one component after another

    The depth of components that `nested` asks for is there if and only if they can be put down in some order: each into a face that is
    there, which a component bounds that was put down before, or into none. That is how Subdivision.v says it. *)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import View Rules Map Expectations ExpectationsCheck ExpectationsLists ExpectationsOpenCounts ExpectationsBorder.
From twinedge Require Import ExpectationsNested.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section Order.
Variables (t : view) (entry : nat -> place -> option start).
Hypothesis keeps : open_rules t.

(** The vertices in the order of their components: the face in which that of [v] lies is bounded by one that was there before. *)
Definition one_after_another (order : seq nat) := (forall v, vertex t v -> v \in order) /\
  forall before v after, order = before ++ v :: after -> forall f i u x, start_vertex t (entry f Outer) = Some u ->
    start_vertex t (entry f (Inner i)) = Some x -> same_piece t v x -> exists2 u', u' \in before & same_piece t u' u.

Definition some_depth := exists depth : nat -> nat, (forall u v, same_piece t u v -> depth u = depth v) /\
  forall f i u v, start_vertex t (entry f Outer) = Some u -> start_vertex t (entry f (Inner i)) = Some v -> depth u < depth v.

(** Each entry starts at a vertex that is there. *)
Hypothesis starts : forall f p v, start_vertex t (entry f p) = Some v -> vertex t v.

(** It can be decided if vertices are in one piece: the structure without faces says so. *)
Let s := Structure t (Parts true true false false false false false) (fun _ => None) (fun _ => None) (fun _ _ => None).
Definition in_piece u v := v \in linked_list (open_on true) s u.

Lemma in_pieceP u v : in_piece u v <-> same_piece t u v.
Proof.
have step x y : edge_step (open_on true) s x y <-> edge_leads t x y.
  split=> -[h O E]; exists h => //; [rewrite -E; apply/esym|rewrite -E];
    exact: (end_ofE true false false false false false (fun _ => None) (fun _ => None) (fun _ _ => None) keeps (heard_live (O : origin t h = Some x))).
split=> [/linkedP H|H]; first by apply/(walks_iff _ _ step).
by apply/linkedP; apply/(walks_iff _ _ step).
Qed.

Lemma same_piece_sym u v : same_piece t u v -> same_piece t v u.
Proof. exact: (@piece_sym t false false false (fun _ => None) (fun _ => None) (fun _ _ => None) keeps u v). Qed.

Theorem depth_is_order : some_depth <-> exists order, one_after_another order.
Proof.
split=> [[depth [same deeper]]|[order [all puts]]].
  pose order := sort (fun u v => depth u <= depth v) [seq v <- iota 0 (vertex_slots t) | vertex t v].
  have mem v : (v \in order) = vertex t v by rewrite mem_sort mem_filter mem_iota andb_idr // => /vertex_below.
  exists order; split=> [v lv|before v after E f i u x U X vx]; first by rewrite mem.
  exists u; last exact: walks_nowhere.
  have lt : depth u < depth v by rewrite (same _ _ vx); apply: deeper U X.
  have: u \in order by rewrite mem (starts U).
  rewrite E mem_cat inE => /or3P[//|/eqP uv|ua]; first by rewrite uv ltnn in lt.
  have sorted_order : sorted (fun u v => depth u <= depth v) order by apply: sort_sorted => a b; apply: leq_total.
  have trans : transitive (fun u v => depth u <= depth v) by move=> a b c; apply: leq_trans.
  have : sorted (fun u v => depth u <= depth v) (v :: after) by move: sorted_order; rewrite E => /cat_sorted2[].
  by rewrite /= => /(order_path_min trans)/allP/(_ u ua); rewrite leqNgt lt.
pose depth v := find (in_piece v) order; exists depth; split=> [u v uv|f i u v U V].
  apply: eq_find => x; apply/idP/idP => /in_pieceP H; apply/in_pieceP; last exact: walks_trans uv H.
  exact: walks_trans (same_piece_sym uv) H.
have hasv : has (in_piece v) order by apply/hasP; exists v; [apply: all; apply: starts V | apply/in_pieceP; apply: walks_nowhere].
have [before [w [after [E sz vw]]]] : exists before w after, [/\ order = before ++ w :: after, size before = depth v & in_piece v w].
  have lt : depth v < size order by rewrite -has_find.
  exists (take (depth v) order), (nth 0 order (depth v)), (drop (depth v).+1 order); split; last exact: nth_find.
    by rewrite -(drop_nth 0 lt) cat_take_drop.
  by rewrite size_takel // ltnW.
have [u' ub uu] := puts before w after E f i u v U V (same_piece_sym ((in_pieceP v w).1 vw)).
rewrite -sz /depth E find_cat ifT -?has_find; apply/hasP; exists u' => //; apply/in_pieceP; exact: same_piece_sym uu.
Qed.

End Order.

(** So the components of nested faces can be put down one after another. *)
Corollary nested_in_order t unbounded side entry : open_rules t -> nested t unbounded side entry ->
  exists order, one_after_another t entry order.
Proof.
move=> keeps n; apply/(depth_is_order keeps); last exact: nested_depth n.
move=> f p v; case E: (entry f p) => [[h|u]|] //= O; last by have [_ lu _ _] := entry_vertex n E; case: O => <-.
by have [[x X lx] _ _ _] := lives keeps (heard_live O); move: O; rewrite X => -[<-].
Qed.
