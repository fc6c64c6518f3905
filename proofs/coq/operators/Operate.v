(** * Operate: the operators as a program that runs beside the Rust code (dcel/operators/)

    Programs.v has a relation between views. Here is a step as data: an operation, which is an operator with its arguments. It has a
    test of its arguments. Where the test passes, it is a step of a program, and so it keeps all rules; where it fails, the
    operation is refused, and the table stays as it is. ocaml/operate.ml runs this on what `Dcel` did. *)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import View Rules Reference Verdict AddVertex RemoveVertex MoveInner Renaming AnyInner.
From twinedge Require Import ConnectIsolated ConnectBridge ConnectSplit ConnectLoop RemoveMerge RemovePart Skip Contract SplitVertex Keep.
From twinedge Require Import Programs.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** An operator with its arguments: those of the constructors of [step]. *)
Inductive operation :=
  | KeepOthers of (nat -> link) & (nat -> link)
  | Add of nat & nat & nat
  | Remove of nat & nat
  | Move of nat & nat & nat & nat
  | AttachToIsolated of nat & nat & nat & nat & nat
  | Bridge of nat & nat & nat & nat & nat & nat & nat
  | SplitFace of nat & nat & nat & nat & nat & nat & nat & nat & bool & bool & pred nat
  | LoopAtIsolated of nat & nat & nat & nat & nat & nat & nat & bool & bool & pred nat
  | MergeFaces of nat & nat & nat & nat & nat & nat
  | PartComponent of nat & nat & nat & nat & nat & nat & nat & nat & nat & seq nat
  | SplitVertex of nat & nat & nat & nat & nat
  | ContractEdge of nat & nat & nat & nat.

Definition after t o : view :=
  match o with
  | KeepOthers leaves starts => keep_others t leaves starts
  | Add v b f => add_isolated_vertex t v b f
  | Remove v b => remove_isolated_vertex t v b
  | Move b f i g => move_inner (exchange t f i (inner_count t f).-1) b f g
  | AttachToIsolated o v b h k => attach_to_isolated t o v b h k
  | Bridge a b h k f kept dropped => bridge t a b h k f kept dropped
  | SplitFace a b h k f g kept made made_left new_left moved => split_face t a b h k f g kept made made_left new_left moved
  | LoopAtIsolated v h k f g kept made made_left new_left moved =>
      loop_at_isolated t v h k f g kept made made_left new_left moved
  | MergeFaces n m f g kept dropped => merge_faces t n m f g kept dropped
  | PartComponent n m f kept made at_n at_m stays _ _ => part_component t n m f kept made at_n at_m stays
  | SplitVertex a b v h k => split_vertex t a b v h k
  | ContractEdge n m kept dropped => contract_edge t n m kept dropped
  end.

Definition is_free_edge t h k := [&& ~~ half_edge t h, ~~ half_edge t k & h != k].
Definition is_inner t b i := if boundary_place t b is Some (Inner j) then j == i else false.

(** The arguments are right. For [Move] the rules are asked what comes of it: they hold exactly if the new face is not inside
    what is moved. *)
Definition is_right t o : bool :=
  match o with
  | KeepOthers _ _ => true
  | Add v b f => [&& ~~ vertex t v, ~~ boundary t b & face t f]
  | Remove v b => isolated t v == Some b
  | Move b f i g => [&& boundary_face t b == Some f, is_inner t b i, face t g, g != f & ~~ first_broken (after t o)]
  | AttachToIsolated o v b h k => [&& isolated t o == Some b, ~~ vertex t v & is_free_edge t h k]
  | Bridge a b h k f kept dropped =>
      [&& (boundary_of t a == Some kept) && (boundary_of t b == Some dropped)
          || (boundary_of t a == Some dropped) && (boundary_of t b == Some kept),
          kept != dropped, boundary_face t kept == Some f, boundary_face t dropped == Some f & is_free_edge t h k]
  | SplitFace a b h k f g kept made _ _ _ =>
      [&& boundary_of t a == Some kept, boundary_of t b == Some kept, boundary_face t kept == Some f,
          is_free_edge t h k, ~~ boundary t made & ~~ face t g]
  | LoopAtIsolated v h k f g kept made _ _ _ =>
      [&& isolated t v == Some kept, boundary_face t kept == Some f, is_free_edge t h k, ~~ boundary t made & ~~ face t g]
  | MergeFaces n m f g kept dropped => is_seam t n m f g kept dropped
  | PartComponent n m f kept made at_n at_m stays bo way => is_bridge t n m f kept made at_n at_m stays bo way
  | SplitVertex a b v h k => is_splittable t a b v h k
  | ContractEdge n m kept dropped => is_contractible t n m kept dropped
  end.

Lemma free_edgeP t h k : is_free_edge t h k -> free_edge t h k.
Proof. by case/and3P. Qed.

(** An operation is a step of a program. *)
Theorem operation_is_step t o : rules t -> is_right t o -> step t (after t o).
Proof.
case: o => /= [leaves starts|v b f|v b|b f i g|o v b h k|a b h k f kept dropped|
  a b h k f g kept made ml nl moved|v h k f g kept made ml nl moved|n m f g kept dropped|
  n m f kept made at_n at_m stays bo way|a b v h k|n m kept dropped] keeps.
- by move=> _; apply: step_keep_others.
- by case/and3P=> *; apply: step_add.
- by move/eqP; apply: step_remove.
- case/and5P=> /eqP E I lg gf B.
  have P : boundary_place t b = Some (Inner i).
    by move: I; rewrite /is_inner; case: boundary_place => [[|j]|] // /eqP->.
  apply: (step_move E P lg gf); apply/(move_any_inner_keeps_rules keeps E P lg gf)/first_broken_none.
  by case: first_broken B.
- by case/and3P=> /eqP I fv /free_edgeP fe; apply: step_attach.
- case/and5P=> ab /eqP kd /eqP kf /eqP df /free_edgeP fe; apply: step_bridge => //.
  by case/orP: ab => /andP[/eqP A /eqP B]; [left | right].
- by case/and5P=> /eqP A /eqP B /eqP kf /free_edgeP fe /andP[fm fg]; exact: (step_split_face _ _ _ A B kf fe fm fg).
- by case/and5P=> /eqP I /eqP kf /free_edgeP fe fm fg; exact: (step_loop _ _ _ I kf fe fm fg).
- exact: step_merge_faces.
- exact: step_part_component.
- exact: step_split_vertex.
exact: step_contract_edge.
Qed.

(** ** Refusals *)

(** The view that is there after an operation: the same as before if it is refused. *)
Definition operate t o : view := if is_right t o then after t o else t.

(** A refused operation changes nothing. *)
Lemma refused_changes_nothing t o : ~~ is_right t o -> operate t o = t.
Proof. by rewrite /operate => /negPf->. Qed.

(** Whatever the arguments, all rules hold after an operation if they held before. *)
Theorem operate_keeps_rules t o : rules t -> rules (operate t o).
Proof. by rewrite /operate; case: ifP => // right keeps; apply: step_keeps_rules (operation_is_step keeps right) keeps. Qed.

(** So they do after any number of operations, some of which may be refused. *)
Corollary operate_all_keeps_rules t os : rules t -> rules (foldl operate t os).
Proof. by elim: os t => //= o os IH t keeps; apply/IH/operate_keeps_rules. Qed.
