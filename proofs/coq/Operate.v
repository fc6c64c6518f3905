(** * Operate: the operators as a program that runs beside the Rust code (dcel/operators/)

    Programs.v has a relation between views. Here is a step as data: an operator with its arguments. It has a view before, a
    view after, and a test of its arguments. Where the test passes, it is a step of a program, and so it keeps all rules.
    ocaml/operate.ml runs this on what `Dcel` did.

    Two operators take away an isolated vertex, and are stated on the view [t] without it: their view before is [t] with the
    vertex added. *)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import View Rules Reference Verdict AddVertex RemoveVertex MoveInner Renaming AnyInner.
From twinedge Require Import Connect ConnectIsolated ConnectCorners ConnectBridge ConnectSplit ConnectLoop SplitEdge JoinEdges.
From twinedge Require Import RemoveMerge RemovePart Programs.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** An operator with its arguments: those of the constructors of [step]. *)
Inductive operation :=
  | Add of nat & nat & nat
  | Remove of nat & nat & nat
  | Move of nat & nat & nat & nat
  | Attach of nat & nat & nat & nat
  | BridgeToIsolated of nat & nat & nat & nat & nat & nat
  | AttachToIsolated of nat & nat & nat & nat & nat
  | BridgeBetweenIsolated of nat & nat & nat & nat & nat & nat & nat
  | Bridge of nat & nat & nat & nat & nat & nat & nat
  | SplitFace of nat & nat & nat & nat & nat & nat & nat & nat & bool & bool & pred nat
  | LoopAtIsolated of nat & nat & nat & nat & nat & nat & nat & bool & bool & pred nat
  | SplitEdge of nat & nat & nat & nat
  | JoinEdges of nat & nat & nat & nat
  | MergeFaces of nat & nat & nat & nat & nat & nat
  | PartComponent of nat & nat & nat & nat & nat & nat & nat & nat & nat & seq nat.

Definition before t o : view :=
  match o with
  | Remove v b f | BridgeToIsolated _ v b f _ _ => add_isolated_vertex t v b f
  | BridgeBetweenIsolated _ v _ c f _ _ => add_isolated_vertex t v c f
  | _ => t
  end.

Definition after t o : view :=
  match o with
  | Add v b f => add_isolated_vertex t v b f
  | Remove _ _ _ => t
  | Move b f i g => move_inner (exchange t f i (inner_count t f).-1) b f g
  | Attach a v h k | BridgeToIsolated a v _ _ h k => attach_vertex t a v h k
  | AttachToIsolated o v b h k | BridgeBetweenIsolated o v b _ _ h k => attach_to_isolated t o v b h k
  | Bridge a b h k f kept dropped => bridge t a b h k f kept dropped
  | SplitFace a b h k f g kept made made_left new_left moved => split_face t a b h k f g kept made made_left new_left moved
  | LoopAtIsolated v h k f g kept made made_left new_left moved =>
      loop_at_isolated t v h k f g kept made made_left new_left moved
  | SplitEdge e v h k => split_edge t e v h k
  | JoinEdges e v h k => join_edges t e v h k
  | MergeFaces n m f g kept dropped => merge_faces t n m f g kept dropped
  | PartComponent n m f kept made at_n at_m stays _ _ => part_component t n m f kept made at_n at_m stays
  end.

Definition is_free_edge t h k := [&& ~~ half_edge t h, ~~ half_edge t k & h != k].
Definition is_inner t b i := if boundary_place t b is Some (Inner j) then j == i else false.

(** The arguments are right. For [Move] the rules are asked what comes of it: they hold exactly if the new face is not inside
    what is moved. *)
Definition is_right t o : bool :=
  match o with
  | Add v b f | Remove v b f => [&& ~~ vertex t v, ~~ boundary t b & face t f]
  | Move b f i g => [&& boundary_face t b == Some f, is_inner t b i, face t g, g != f & ~~ first_broken (after t o)]
  | Attach a v h k => [&& half_edge t a, ~~ vertex t v & is_free_edge t h k]
  | BridgeToIsolated a v b f h k => [&& half_edge t a, face t f, ~~ vertex t v, ~~ boundary t b & is_free_edge t h k]
  | AttachToIsolated o v b h k => [&& isolated t o == Some b, ~~ vertex t v & is_free_edge t h k]
  | BridgeBetweenIsolated o v b c f h k =>
      [&& isolated t o == Some b, face t f, ~~ vertex t v, ~~ boundary t c & is_free_edge t h k]
  | Bridge a b h k f kept dropped =>
      [&& (boundary_of t a == Some kept) && (boundary_of t b == Some dropped)
          || (boundary_of t a == Some dropped) && (boundary_of t b == Some kept),
          kept != dropped, boundary_face t kept == Some f, boundary_face t dropped == Some f & is_free_edge t h k]
  | SplitFace a b h k f g kept made _ _ _ =>
      [&& boundary_of t a == Some kept, boundary_of t b == Some kept, boundary_face t kept == Some f,
          is_free_edge t h k, ~~ boundary t made & ~~ face t g]
  | LoopAtIsolated v h k f g kept made _ _ _ =>
      [&& isolated t v == Some kept, boundary_face t kept == Some f, is_free_edge t h k, ~~ boundary t made & ~~ face t g]
  | SplitEdge e v h k => [&& half_edge t e, ~~ vertex t v & is_free_edge t h k]
  | JoinEdges e v h k => is_joint t e v h k
  | MergeFaces n m f g kept dropped => is_seam t n m f g kept dropped
  | PartComponent n m f kept made at_n at_m stays bo way => is_bridge t n m f kept made at_n at_m stays bo way
  end.

Lemma free_edgeP t h k : is_free_edge t h k -> free_edge t h k.
Proof. by case/and3P. Qed.

(** What is run is a step of a program. *)
Theorem operation_is_step t o : rules (before t o) -> is_right t o -> step (before t o) (after t o).
Proof.
case: o => /= [v b f|v b f|b f i g|a v h k|a v b f h k|o v b h k|o v b c f h k|a b h k f kept dropped|
  a b h k f g kept made ml nl moved|v h k f g kept made ml nl moved|e v h k|e v h k|
  n m f g kept dropped|n m f kept made at_n at_m stays bo way] keeps.
- by case/and3P=> *; apply: step_add.
- by case/and3P=> *; apply: step_remove.
- case/and5P=> /eqP E I lg gf B.
  have P : boundary_place t b = Some (Inner i).
    by move: I; rewrite /is_inner; case: boundary_place => [[|j]|] // /eqP->.
  apply: (step_move E P lg gf); apply/(move_any_inner_keeps_rules keeps E P lg gf)/first_broken_none.
  by case: first_broken B.
- by case/and3P=> la fv /free_edgeP fe; apply: step_attach.
- by case/and5P=> la lf fv fb /free_edgeP fe; apply: step_bridge_to_isolated.
- by case/and3P=> /eqP I fv /free_edgeP fe; apply: step_attach_to_isolated.
- by case/and5P=> /eqP I lf fv fc /free_edgeP fe; apply: step_bridge_between_isolated.
- case/and5P=> ab /eqP kd /eqP kf /eqP df /free_edgeP fe; apply: step_bridge => //.
  by case/orP: ab => /andP[/eqP A /eqP B]; [left | right].
- by case/and5P=> /eqP A /eqP B /eqP kf /free_edgeP fe /andP[fm fg]; exact: (step_split_face _ _ _ A B kf fe fm fg).
- by case/and5P=> /eqP I /eqP kf /free_edgeP fe fm fg; exact: (step_loop _ _ _ I kf fe fm fg).
- by case/and3P=> le fv /free_edgeP fe; apply: step_split_edge.
- exact: step_join_edges.
- exact: step_merge_faces.
exact: step_part_component.
Qed.

Corollary operation_keeps_rules t o : rules (before t o) -> is_right t o -> rules (after t o).
Proof. by move=> keeps right; apply: (step_keeps_rules (operation_is_step keeps right)). Qed.
