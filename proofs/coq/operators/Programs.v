(** * Programs: what operators make of a planar subdivision, one after another, is one (dcel/operators/)

    A step is one operator with arguments for which it is not refused, or a renaming: other numbers, and lists in another
    order; or other half-edges are kept. A program is any number of steps. Each keeps all rules, so a program does.

<<
      nothing ──add──► · v ──attach──► ·────· ──split──► ·──·──· ──bridge──► …        each represents a planar subdivision
>>

    Some operators of the Rust code are several steps here. Connecting to an isolated vertex removes it first (Connect.v), and
    flipping an edge takes it out and puts it back (Flip.v). Splitting an edge is splitting one of its ends, and joining two is
    contracting one of them. *)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import View Rules Subdivision Verdict AddVertex RemoveVertex MoveInner Renaming AnyInner.
From twinedge Require Import ConnectIsolated ConnectBridge ConnectSplit ConnectLoop RemoveMerge RemovePart Skip Contract SplitVertex Keep.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** Slots for an edge: they are free, and they are two. *)
Definition free_edge t h k := [/\ ~~ half_edge t h, ~~ half_edge t k & h != k].

Inductive step : view -> view -> Prop :=
  | step_rename t t' rv rd rb rf rp : renaming t t' rv rd rb rf rp -> step t t'
  | step_keep_others t leaves starts : step t (keep_others t leaves starts)
  | step_add t v b f : ~~ vertex t v -> ~~ boundary t b -> face t f -> step t (add_isolated_vertex t v b f)
  | step_remove t v b : isolated t v = Some b -> step t (remove_isolated_vertex t v b)
  | step_move t b f i g : boundary_face t b = Some f -> boundary_place t b = Some (Inner i) -> face t g -> g != f ->
      ~ inside t b g -> step t (move_inner (exchange t f i (inner_count t f).-1) b f g)
  | step_attach t o v b h k : isolated t o = Some b -> ~~ vertex t v -> free_edge t h k -> step t (attach_to_isolated t o v b h k)
  | step_bridge t a b h k f kept dropped :
      boundary_of t a = Some kept /\ boundary_of t b = Some dropped \/
      boundary_of t a = Some dropped /\ boundary_of t b = Some kept ->
      kept <> dropped -> boundary_face t kept = Some f -> boundary_face t dropped = Some f -> free_edge t h k ->
      step t (bridge t a b h k f kept dropped)
  | step_split_face t a b h k f g kept made made_left new_left moved :
      boundary_of t a = Some kept -> boundary_of t b = Some kept -> boundary_face t kept = Some f -> free_edge t h k ->
      ~~ boundary t made -> ~~ face t g -> step t (split_face t a b h k f g kept made made_left new_left moved)
  | step_loop t v h k f g kept made made_left new_left moved :
      isolated t v = Some kept -> boundary_face t kept = Some f -> free_edge t h k -> ~~ boundary t made -> ~~ face t g ->
      step t (loop_at_isolated t v h k f g kept made made_left new_left moved)
  | step_merge_faces t n m f g kept dropped : is_seam t n m f g kept dropped -> step t (merge_faces t n m f g kept dropped)
  | step_part_component t n m f kept made at_n at_m stays bo way : is_bridge t n m f kept made at_n at_m stays bo way ->
      step t (part_component t n m f kept made at_n at_m stays)
  | step_split_vertex t a b v h k : is_splittable t a b v h k -> step t (split_vertex t a b v h k)
  | step_contract_edge t n m kept dropped : is_contractible t n m kept dropped -> step t (contract_edge t n m kept dropped).

Theorem step_keeps_rules t t' : step t t' -> rules t -> rules t'.
Proof.
case=> {t t'} => [t t' rv rd rb rf rp same|t leaves starts|t v b f fv fb lf|t v b I|t b f i g E P lg gf no keeps|
  t o v b h k I fv [fh fk hk]|t a b h k f kept dropped ab kd kf df [fh fk hk]|
  t a b h k f g kept made ml nl moved ak bk kf [fh fk hk] fm fg|t v h k f g kept made ml nl moved I kf [fh fk hk] fm fg|
  t n m f g kept dropped seam|t n m f kept made at_n at_m stays bo way bridge|t a b v h k right|t n m kept dropped right].
- exact: renaming_keeps same.
- exact: keep_others_keeps_rules.
- exact: add_isolated_vertex_keeps_rules.
- exact: remove_isolated_vertex_keeps_rules.
- exact/(move_any_inner_keeps_rules keeps E P lg gf).
- exact: attach_to_isolated_keeps_rules.
- exact: bridge_keeps_rules.
- exact: split_face_keeps_rules.
- exact: loop_at_isolated_keeps_rules.
- exact: merge_faces_keeps_rules.
- exact: part_component_keeps_rules bridge.
- exact: split_vertex_keeps_rules.
exact: contract_edge_keeps_rules.
Qed.

Inductive program t : view -> Prop :=
  | program_nothing : program t t
  | program_step u w : program t u -> step u w -> program t w.

Theorem program_keeps_rules t t' : program t t' -> rules t -> rules t'.
Proof. by move=> p keeps; elim: p => [//|u w _ IH /step_keeps_rules]; apply. Qed.

(** So what a program makes of a planar subdivision is one. *)
Corollary program_makes_subdivision t t' : program t t' -> (exists s, represents t s) -> exists s, represents t' s.
Proof. by move=> p /rules_mean_subdivision /(program_keeps_rules p) /rules_mean_subdivision. Qed.
