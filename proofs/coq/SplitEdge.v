(** * SplitEdge: splitting an edge keeps all rules (dcel/operators/split_edge.rs)

    The edge of the half-edge [e] and its twin [d] gets a new vertex [v] on it. [e] ends there now, [d] begins there, and the
    rest of the edge has the new half-edges [h], after [e], and [k], before [d].

<<
      a ·────e────────────► · b          a ·──e──► · v ──h──► · b        along the boundary: e, h, next e
        ◄────────────d─────                ◄──d───   ◄──k────                            and: prev d, k, d
>>
*)

From mathcomp Require Import all_ssreflect.
From twinedge Require Import Arith View Rules Map Counting Lists Genus WholeEuler Verdict NewEdge.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** The view [t] with the vertex [v] on the edge of [e], and its second half [h], [k]. *)
Definition split_edge t e v h k : view := {|
  vertex_slots := maxn (vertex_slots t) v.+1;
  half_edge_slots := maxn (half_edge_slots t) (maxn h.+1 k.+1);
  boundary_slots := boundary_slots t;
  face_slots := face_slots t;
  is_vertex := fun i => (i == v) || vertex t i;
  is_half_edge := fun i => [|| i == h, i == k | half_edge t i];
  is_boundary := is_boundary t;
  is_face := is_face t;
  says_origin := fun i => if i == h then Some v else if i == k then target t e else
    if Some i == twin t e then Some v else says_origin t i;
  says_twin := fun i => if i == h then Some k else if i == k then Some h else says_twin t i;
  says_next := fun i => if i == h then (if next t e == twin t e then Some k else next t e) else
    if i == k then twin t e else if i == e then Some h else if next t i == twin t e then Some k else says_next t i;
  says_prev := fun i => if i == h then Some e else
    if i == k then (if next t e == twin t e then Some h else twin t e >>= prev t) else
    if Some i == twin t e then Some k else if prev t i == Some e then Some h else says_prev t i;
  says_boundary := fun i => if i == h then boundary_of t e else if i == k then twin t e >>= boundary_of t else
    says_boundary t i;
  says_leaving := fun u => if u == v then Some h else if leaving t u == twin t e then Some k else says_leaving t u;
  says_isolated := fun u => if u == v then None else says_isolated t u;
  says_boundary_face := says_boundary_face t;
  says_boundary_start := says_boundary_start t;
  says_boundary_place := says_boundary_place t;
  says_outer := says_outer t;
  says_inner_count := says_inner_count t;
  says_inner := says_inner t
|}.

Section SplitEdge.
Variables (t : view) (e d v h k b ne pd : nat).
Hypothesis keeps : rules t.
Hypothesis free_vertex : ~~ vertex t v.
Hypothesis free_h : ~~ half_edge t h.
Hypothesis free_k : ~~ half_edge t k.
Hypothesis hk : h != k.
Hypothesis twin_e : twin t e = Some d.
Hypothesis origin_d : origin t d = Some b.
Hypothesis next_e : next t e = Some ne.
Hypothesis prev_d : prev t d = Some pd.

Notation t' := (split_edge t e v h k).
Let low : lower t. Proof. by move=> q _; apply: keeps. Qed.
Let map : is_map t := low_map low.
Let live_e : half_edge t e := heard_live twin_e.
Let live_d : half_edge t d := heard_live origin_d.
Let old_h := NewEdge.old_h free_h.
Let old_k := NewEdge.old_k free_k.
Let links_of := NewEdge.links_of keeps.
Let start_live := NewEdge.start_live keeps.
Let start_vertex := NewEdge.start_vertex keeps.
Let newE := NewEdge.newE hk.

Lemma twin_d : twin t d = Some e. Proof. by have [+ _] := keeps L1 e live_e; rewrite twin_e. Qed.
Lemma d_not_e : d <> e. Proof. by have [_ n] := keeps L1 e live_e; move=> E; apply: n; rewrite twin_e E. Qed.
Lemma next_pd : next t pd = Some d. Proof. by have [_ +] := keeps L2 d live_d; rewrite prev_d. Qed.
Lemma prev_ne : prev t ne = Some e. Proof. by have [+ _] := keeps L2 e live_e; rewrite next_e. Qed.
Lemma live_ne : half_edge t ne. Proof. by have [_ _ [g + l] _ _] := links_of live_e; rewrite next_e => -[->]. Qed.
Lemma live_pd : half_edge t pd. Proof. exact: heard_live next_pd. Qed.
Lemma live_b : vertex t b. Proof. by have [[u + l] _ _ _ _] := links_of live_d; rewrite origin_d => -[->]. Qed.

Lemma next_one i j n : half_edge t i -> half_edge t j -> next t i = Some n -> next t j = Some n -> i = j.
Proof. by move=> /(keeps L2)[+ _] /(keeps L2)[+ _] N N'; rewrite N N' /= => -> -[]. Qed.

Lemma ne_is_d : (ne == d) = (pd == e).
Proof.
apply/eqP/eqP => E; first by apply: (next_one live_pd live_e next_pd); rewrite next_e E.
by move: next_pd; rewrite E next_e => -[].
Qed.

(** ** What the view says *)

Lemma vertexE i : vertex t' i = (i == v) || vertex t i.
Proof.
rewrite {1}/vertex /= leq_max ltnS; case: eqP => [->|_] /=; first by rewrite leqnn orbT.
by case: (boolP (vertex t i)) => [/andP[-> _]|_]; rewrite ?andbF.
Qed.

Lemma half_edgeE i : half_edge t' i = [|| i == h, i == k | half_edge t i].
Proof.
rewrite {1}/half_edge /= !leq_max !ltnS; case: eqP => [->|_] /=; first by rewrite leqnn !orbT.
case: eqP => [->|_] /=; first by rewrite leqnn !orbT.
by case: (boolP (half_edge t i)) => [/andP[-> _]|_]; rewrite ?andbF.
Qed.

Let up_half_edge := NewEdge.up_half_edge half_edgeE.
Let up_vertex := NewEdge.up_vertex vertexE.
Let half_edgeP := NewEdge.half_edgeP free_h free_k half_edgeE.

Ltac heard := rewrite /heard half_edgeE /=; case: (_ == h) => //=; case: (_ == k) => //=.
Lemma someE (i j : nat) : (Some i == Some j) = (i == j). Proof. by []. Qed.

Lemma originE i : origin t' i = if i == h then Some v else if i == k then Some b else if i == d then Some v else origin t i.
Proof.
have T : target t e = Some b by rewrite /target twin_e.
rewrite {1}/origin; heard; rewrite ?T // twin_e someE.
by case: (i =P d) => [->|//]; rewrite live_d.
Qed.

Lemma twinE i : twin t' i = if i == h then Some k else if i == k then Some h else twin t i.
Proof. by rewrite {1}/twin; heard. Qed.

Lemma nextE i : next t' i = if i == h then (if ne == d then Some k else Some ne) else if i == k then Some d else
  if i == e then Some h else if i == pd then Some k else next t i.
Proof.
rewrite {1}/next; heard; rewrite ?next_e ?twin_e ?someE //.
case: (i =P e) => [->|_]; first by rewrite live_e.
case: (i =P pd) => [->|ip]; first by rewrite next_pd eqxx live_pd.
case: (boolP (half_edge t i)) => [li|no]; last by rewrite /next /heard (negPf no).
case: eqP => [N|_]; first by case: ip; apply: next_one li live_pd N next_pd.
by rewrite /next /heard li.
Qed.

Lemma prevE i : prev t' i = if i == h then Some e else if i == k then (if ne == d then Some h else Some pd) else
  if i == d then Some k else if i == ne then Some h else prev t i.
Proof.
rewrite {1}/prev; heard; rewrite ?next_e ?twin_e ?someE /= ?prev_d //.
case: (i =P d) => [->|_]; first by rewrite live_d.
case: (i =P ne) => [->|ip]; first by rewrite prev_ne eqxx live_ne.
case: (boolP (half_edge t i)) => [li|no]; last by rewrite /prev /heard (negPf no).
case: eqP => [P|_]; last by rewrite /prev /heard li.
by case: ip; have [_ +] := keeps L2 i li; rewrite P /= next_e => -[].
Qed.

(** The half-edge that was where a half-edge is now. *)
Definition was i := if i == h then e else if i == k then d else i.

Lemma boundary_was i : boundary_of t' i = boundary_of t (was i).
Proof. by rewrite {1}/boundary_of /was; heard; rewrite twin_e. Qed.

Lemma leavingE u : leaving t' u = if u == v then Some h else if leaving t u == Some d then Some k else leaving t u.
Proof.
rewrite {1}/leaving /heard vertexE /= twin_e; case: (u == v) => //=; case: (boolP (vertex t u)) => [lu|no] /=.
  by case: ifP => // _; rewrite /leaving /heard lu.
by rewrite /leaving /heard (negPf no).
Qed.

Lemma isolatedE u : isolated t' u = if u == v then None else isolated t u.
Proof. by rewrite {1}/isolated /heard vertexE /=; case: (u == v) => //=; case: (vertex t u). Qed.

Lemma live_h : half_edge t' h. Proof. by rewrite half_edgeE eqxx. Qed.
Lemma live_k : half_edge t' k. Proof. by rewrite half_edgeE eqxx orbT. Qed.
Lemma was_h : was h = e. Proof. by rewrite /was eqxx. Qed.
Lemma was_k : was k = d. Proof. by rewrite /was !newE. Qed.
Lemma was_old i : half_edge t i -> was i = i. Proof. by move=> l; rewrite /was old_h ?old_k. Qed.
Lemma was_live i : half_edge t' i -> half_edge t (was i).
Proof. by rewrite /was; case/half_edgeP=> [||{}i li ih ik]; rewrite ?newE // ih ik. Qed.
Lemma b_not_v : (b == v) = false. Proof. by apply/eqP=> E; move: live_b; rewrite E (negPf free_vertex). Qed.
Lemma not_at_v i u : origin t i = Some u -> u <> v.
Proof.
move=> O uv; have [[w W lw] _ _ _ _] := links_of (heard_live O).
by move: W lw; rewrite O uv => -[<-]; rewrite (negPf free_vertex).
Qed.

Lemma bare_old u : vertex t u -> bare t' u <-> bare t u.
Proof.
move=> lu; have uv : u <> v by move=> E; rewrite E (negPf free_vertex) in lu.
split=> B i li.
  case: (i =P d) => [->|id_]; first by have := B k live_k; rewrite originE !newE origin_d.
  by have := B i (up_half_edge li); rewrite originE old_h ?old_k // (introF eqP id_).
case/half_edgeP: li => [||{}i li ih ik]; rewrite originE ?newE ?ih ?ik.
- by case=> /esym.
- by rewrite -origin_d; apply: B.
by case: eqP => [_ [/esym]//|_]; apply: B.
Qed.

(** ** R1 to V1 *)

Lemma split_links : links_live t'.
Proof.
have [[H V B F] _] := keeps R1; split.
- move=> i li; rewrite boundary_was; have [_ _ _ _ C] := links_of (was_live li).
  have [lv lb] : vertex t' v /\ vertex t' b by rewrite !vertexE eqxx live_b orbT.
  have [lh lk] := (live_h, live_k); have [le ld] := (up_half_edge live_e, up_half_edge live_d).
  have [ln lp] := (up_half_edge live_ne, up_half_edge live_pd).
  case/half_edgeP: li C => [||{}i li ih ik] C; rewrite originE twinE nextE prevE ?newE ?ih ?ik.
  + split=> //; [by exists v|by exists k| |by exists e].
    by case: ifP => _; [exists k|exists ne].
  + split=> //; [by exists b|by exists h|by exists d|].
    by case: ifP => _; [exists h|exists pd].
  have [[u U lu] [g G lg] [m M lm] [p P lp'] _] := H i li; split=> //.
  + by case: ifP => _; [exists v|exists u; rewrite ?up_vertex].
  + by exists g; rewrite ?up_half_edge.
  + by do 2?[case: ifP => _]; [exists h|exists k|exists m; rewrite ?up_half_edge].
  by do 2?[case: ifP => _]; [exists k|exists h|exists p; rewrite ?up_half_edge].
- move=> u; rewrite leavingE isolatedE vertexE; case: (u =P v) => [_ _|_ /= lu].
    by split; left=> //; exists h; rewrite ?live_h.
  have [L I] := V u lu; split=> //; case: ifP => _; first by left; exists k; rewrite ?live_k.
  by case: L => [[g G lg]|[N Bu]]; [left; exists g; rewrite ?up_half_edge|right; split=> //; apply/bare_old].
- move=> c lc; have [L S] := B c lc; split=> //; rewrite -[boundary_start t' c]/(boundary_start t c).
  by case: (boundary_start t c) S => [[i|u]|] //= l; [apply: up_half_edge|apply: up_vertex].
exact: F.
Qed.

Lemma split_l1 : l1_twin t'. Proof. exact: new_l1 keeps free_h free_k hk half_edgeE twinE. Qed.

Lemma split_l2 : l2_next_prev t'.
Proof.
move=> i /half_edgeP[||{}i li ih ik]; rewrite nextE prevE ?newE.
- case: (boolP (ne == d)) => nd /=; first by rewrite prevE nextE !newE nd old_h ?old_k ?eqxx.
  by rewrite prevE nextE !old_h ?old_k ?live_ne ?eqxx // (negPf nd).
- rewrite /= prevE old_h ?old_k // eqxx; split=> //; case: (boolP (ne == d)) => nd /=; first by rewrite nextE eqxx nd.
  by rewrite ne_is_d in nd; rewrite nextE old_h ?old_k ?live_pd // (negPf nd) eqxx.
rewrite ih ik; have [E D] := keeps L2 i li; have [_ _ [m M lm] [p P lp] _] := links_of li; split.
  case: (i =P e) => [->|ie] /=; first by rewrite prevE eqxx.
  case: (i =P pd) => [ip|ip] /=; first by rewrite prevE !newE ne_is_d -ip (introF eqP ie).
  rewrite M /= prevE old_h ?old_k //; case: (m =P d) => [md|_].
    by case: ip; apply: next_one li live_pd _ next_pd; rewrite M md.
  case: (m =P ne) => [mn|_]; first by case: ie; apply: next_one li live_e _ next_e; rewrite M mn.
  by move: E; rewrite M.
case: (i =P d) => [->|id_] /=; first by rewrite nextE !newE.
case: (i =P ne) => [in_|in_] /=; first by rewrite nextE eqxx -in_ (introF eqP id_).
rewrite P /= nextE old_h ?old_k //; move: D; rewrite P /= => D.
case: (p =P e) => [pe|_]; first by case: in_; move: D; rewrite pe next_e => -[].
by case: (p =P pd) => [pp|//]; case: id_; move: D; rewrite pp next_pd => -[].
Qed.

Lemma origin_ne : origin t ne = Some b.
Proof. by have := keeps L3 e live_e; rewrite next_e twin_e /= origin_d. Qed.

Lemma split_l3 : l3_target t'.
Proof.
move=> i /half_edgeP[||{}i li ih ik]; rewrite nextE twinE ?newE /=.
- case: (boolP (ne == d)) => nd /=; rewrite !originE ?newE // old_h ?old_k ?live_ne // (negPf nd).
  exact: origin_ne.
- by rewrite !originE !newE old_h ?old_k // eqxx.
rewrite ih ik; have [_ [g G lg] [m M lm] _ _] := links_of li; have := keeps L3 i li; rewrite G M /= => E.
rewrite (originE g) old_h ?old_k //; case: (i =P e) => [ie|ie] /=.
  by rewrite originE eqxx; move: G; rewrite ie twin_e => -[<-]; rewrite eqxx.
have gd : (g == d) = false.
  apply/eqP=> gd; apply: ie; have [+ _] := keeps L1 i li; rewrite G gd /= twin_d => -[].
  by [].
rewrite gd; case: (i =P pd) => [ip|ip] /=.
  by rewrite originE !newE -E; move: M; rewrite ip next_pd => -[<-].
rewrite originE old_h ?old_k //; case: (m =P d) => // md.
by case: ip; apply: next_one li live_pd _ next_pd; rewrite M md.
Qed.

Lemma split_v1 : v1_leaving t'.
Proof.
move=> u g; rewrite vertexE leavingE; case: (u =P v) => [-> _ [<-]|_ /= lu]; first by rewrite originE eqxx.
case: eqP => [L [<-]|nd L].
  by rewrite originE !newE -origin_d; apply: (keeps V1).
have O := keeps V1 u g lu L; rewrite originE old_h ?old_k ?(heard_live O) //.
by case: eqP => // gd; case: nd; rewrite L gd.
Qed.

Let map' : is_map t'.
Proof. by have [H _ _ _] := split_links; split; [|exact: split_l1|exact: split_l2|exact: split_l3]. Qed.

(** ** V2: around [b], [k] is where [d] was; around [v] are [d] and [h] *)

Definition swap i := if i == d then k else i.

Lemma turn_swap i j : turn t i = Some j -> turn t' (swap i) = Some (swap j).
Proof.
rewrite /swap {1}/turn; case: (i =P d) => [->|id_].
  rewrite twin_d /= next_e => -[<-]; rewrite /turn twinE !newE /= nextE eqxx.
  by case: ifP.
case G: (twin t i) => [g|] //= N; have li := heard_live G; have lg := heard_live N.
rewrite /turn twinE old_h ?old_k // G /= nextE old_h ?old_k //.
have ge : g <> e.
  by move=> ge; apply: id_; have [+ _] := keeps L1 i li; rewrite G ge /= twin_e => -[].
rewrite (introF eqP ge); case: (g =P pd) => [gp|gp].
  by move: N; rewrite gp next_pd => -[<-]; rewrite eqxx.
by rewrite N; case: (j =P d) => // jd; case: gp; apply: next_one lg live_pd _ next_pd; rewrite N jd.
Qed.

Lemma orbit_swap i j : on_orbit (turn t) i j -> on_orbit (turn t') (swap i) (swap j).
Proof.
case=> m; elim: m j => [|m IH] j /=; first by case=> <-; apply: orbit_refl.
by case E: (iter m _ _) => [u|] //= U; apply: orbit_step (IH u E) (turn_swap U).
Qed.

Lemma split_v2 : v2_rotation t'.
Proof.
have d_h : turn t' d = Some h by rewrite /turn twinE old_h ?old_k // twin_d /= nextE old_h ?old_k ?eqxx.
have h_d : turn t' h = Some d by rewrite /turn twinE eqxx /= nextE !newE.
have dh : on_orbit (turn t') d h by apply: orbit_step (orbit_refl _ _) d_h.
have hd_ : on_orbit (turn t') h d by apply: orbit_step (orbit_refl _ _) h_d.
(* Around v, or around another vertex. *)
have cases i : half_edge t' i -> (i = d \/ i = h) /\ origin t' i = Some v \/
    exists j u, [/\ half_edge t j, swap j = i, origin t' i = Some u, origin t j = Some u & u <> v].
  rewrite /swap originE; case/half_edgeP=> [||{}i li ih ik]; rewrite ?newE; first by left; auto.
    by right; exists d, b; rewrite eqxx; split=> //; apply/eqP; rewrite b_not_v.
  rewrite ih ik; case: (i =P d) => [->|id_]; first by left; auto.
  have [[u U lu] _ _ _ _] := links_of li; right; exists i, u; split=> //; [by case: eqP|exact: not_at_v U].
move=> i j li lj; split=> [/(on_rotation_origin split_l1 split_l3) ->//|].
case: (cases i li) => [[ii ->]|[x [u [lx <- -> Ox uv]]]]; case: (cases j lj) => [[jj ->]|[y [w [ly <- -> Oy wv]]]].
- by case: ii => ->; case: jj => -> //; move=> _; apply: orbit_refl.
- by case=> /esym.
- by case.
by move=> uw; apply: orbit_swap; apply/(keeps V2 x y lx ly); rewrite Ox Oy.
Qed.

(** ** B1, B2 *)

Lemma cycle_up g x : on_cycle t g x -> on_cycle t' g x.
Proof.
apply: orbit_sub => u w z E ou; have lu := heard_live E.
have N : next t' u = if u == e then Some h else if u == pd then Some k else next t u by rewrite nextE old_h ?old_k.
have k_d : next t' k = Some d by rewrite nextE !newE.
case: (u =P e) N => [ue|ue] N.
  have ew : w = ne by move: E; rewrite ue next_e => -[].
  have H : next t' h = Some (if ne == d then k else ne) by rewrite nextE eqxx; case: ifP.
  case: (ne =P d) H => [nd|nd] H; last by rewrite ew; apply: orbit_step (orbit_step ou N) H.
  by rewrite ew nd; apply: orbit_step (orbit_step (orbit_step ou N) H) k_d.
case: (u =P pd) N => [up|up] N; last by apply: orbit_step ou _; rewrite N.
have -> : w = d by move: E; rewrite up next_pd => -[].
exact: orbit_step (orbit_step ou N) k_d.
Qed.

Lemma was_next i j : next t' i = Some j -> was j = was i \/ next t (was i) = Some (was j).
Proof.
move=> N; have li := heard_live N; move: N; rewrite nextE; case: (half_edgeP li) => [||{}i {}li ih ik]; rewrite ?newE.
- rewrite was_h next_e; case: (ne =P d) => [nd|_] [<-]; right; first by rewrite was_k nd.
  by rewrite was_old ?live_ne.
- by case=> <-; left; rewrite was_k was_old.
rewrite ih ik (was_old li); case: (i =P e) => [-> [<-]|_]; first by left; rewrite was_h.
case: (i =P pd) => [-> [<-]|_ N]; first by right; rewrite next_pd was_k.
have lj : half_edge t j by have [_ _ [m + lm] _ _] := links_of li; rewrite N => -[->].
by right; rewrite was_old.
Qed.

Lemma cycle_down g x : on_cycle t' g x -> on_cycle t (was g) (was x).
Proof.
case=> m; elim: m x => [|m IH] x /=; first by case=> <-; apply: orbit_refl.
case E: (iter m _ _) => [u|] //= /was_next[->|N]; first exact: IH.
exact: orbit_step (IH u E) N.
Qed.

Lemma cycle_on g x : half_edge t g -> half_edge t' x -> on_cycle t' g x <-> on_cycle t g (was x).
Proof.
move=> lg lx; split=> [/cycle_down|/cycle_up C]; first by rewrite was_old.
apply: orbit_trans C _; rewrite /was; case/half_edgeP: lx => [||{}x lx xh xk]; rewrite ?newE.
- by apply: orbit_step (orbit_refl _ _) _; rewrite nextE old_h ?old_k ?eqxx.
- apply: (cycle_sym map' live_k (up_half_edge live_d)); apply: orbit_step (orbit_refl _ _) _.
  by rewrite nextE !newE.
by rewrite xh xk; apply: orbit_refl.
Qed.

Lemma split_b1 : b1_cycle t'.
Proof.
have [C D] := keeps B1; have [H _ _ _] := split_links; split=> [i li|c i lc li].
  have [_ _ [j N lj] _ _] := H i li; rewrite N /= !boundary_was.
  by case: (was_next N) => [->//|M]; have := C _ (was_live li); rewrite M.
rewrite boundary_was; apply: iff_trans (D c _ lc (was_live li)) _.
by split=> -[g S O]; exists g => //; apply/(cycle_on (start_live S) li).
Qed.

Lemma split_b2 : b2_isolated t'.
Proof.
move=> u; rewrite vertexE isolatedE; case: (u =P v) => [-> _|_ /= lu].
  split=> [B|_]; first by have := B h live_h; rewrite originE eqxx.
  by split=> // c /start_vertex; rewrite (negPf free_vertex).
have [A N] := keeps B2 u lu; split=> [/(bare_old lu) /A //|nb]; apply: N => B; apply: nb; exact/bare_old.
Qed.

(** ** T1 to T3: what is connected to [v] is what is connected to [b] *)

Notation hangs := (hangs v b).
Let hangs_old := NewEdge.hangs_old b free_vertex.

Lemma hangs_v : hangs v = b. Proof. by rewrite /NewEdge.hangs eqxx. Qed.
Lemma hangs_b : hangs b = b. Proof. exact: hangs_old live_b. Qed.
Lemma hangs_end i u : origin t i = Some u -> hangs u = u.
Proof. by move/not_at_v=> uv; rewrite /NewEdge.hangs (introF eqP uv). Qed.

Lemma origin_other i : half_edge t i -> i <> d -> origin t' i = origin t i.
Proof. by move=> li id_; rewrite originE old_h ?old_k // (introF eqP id_). Qed.

(** Half-edges other than [e] and [d] lead from where to where they did. *)
Lemma target_other i : half_edge t i -> i <> e -> target t' i = target t i.
Proof.
move=> li ie; have [_ [g G lg] _ _ _] := links_of li; rewrite /target twinE old_h ?old_k // G /= origin_other // => gd.
by apply: ie; have [+ _] := keeps L1 i li; rewrite G gd /= twin_d => -[].
Qed.

Lemma target_e : target t' e = Some v.
Proof. by rewrite /target twinE old_h ?old_k // twin_e /= originE old_h ?old_k ?eqxx. Qed.

Lemma connected_down u w : connected t' u w -> connected t (hangs u) (hangs w).
Proof.
elim=> [|i x y _ IH X Y]; first exact: connected_self.
have li := heard_live X; case: (half_edgeP li) X Y => [||{}i {}li _ _].
- rewrite originE eqxx => -[xv]; rewrite /target twinE eqxx /= originE !newE => -[<-].
  by rewrite -xv hangs_v in IH; rewrite hangs_b.
- rewrite originE !newE => -[xb]; rewrite /target twinE !newE /= originE eqxx => -[<-].
  by rewrite -xb hangs_b in IH; rewrite hangs_v.
case: (i =P e) => [->|ie].
  rewrite origin_other //; last exact/nesym/d_not_e.
  move=> X; rewrite target_e => -[<-]; rewrite hangs_v; rewrite (hangs_end X) in IH.
  by apply: connected_edge IH X _; rewrite /target twin_e.
rewrite target_other //; case: (i =P d) => [->|id_] X Y; last first.
  rewrite origin_other // in X; rewrite (hangs_end X) in IH; have E : exists g, origin t g = Some y.
    by move: Y; rewrite /target; case: (twin t i) => [g|] //= O; exists g.
  by case: E => g O; rewrite (hangs_end O); apply: connected_edge IH X Y.
move: X; rewrite originE old_h ?old_k // eqxx => -[xv]; rewrite -xv hangs_v in IH.
have E : origin t e = Some y by move: Y; rewrite /target twin_d.
by rewrite (hangs_end E); apply: connected_edge IH origin_d Y.
Qed.

Lemma to_v u : connected t' u b -> connected t' u v.
Proof. by move=> C; apply: (@connected_edge t' u k b v C); rewrite /target ?originE ?twinE ?newE //= originE eqxx. Qed.
Lemma to_b u : connected t' u v -> connected t' u b.
Proof. by move=> C; apply: (@connected_edge t' u h v b C); rewrite /target ?originE ?twinE ?newE //= originE !newE. Qed.

Lemma connected_up u w : connected t u w -> connected t' u w.
Proof.
elim=> [|i x y _ IH X Y]; first exact: connected_self.
have li := heard_live X; case: (i =P e) => [ie|ie].
  have yb : y = b by move: Y; rewrite ie /target twin_e /= origin_d => -[].
  rewrite ie in X; rewrite yb; apply: to_b; apply: connected_edge IH _ target_e.
  by rewrite origin_other //; apply/nesym/d_not_e.
case: (i =P d) => [id_|id_].
  have xb : x = b by move: X; rewrite id_ origin_d => -[].
  rewrite xb in IH; rewrite id_ in Y; apply: (connected_edge (h := d) (to_v IH)).
    by rewrite originE old_h ?old_k // eqxx.
  by rewrite target_other //; apply: d_not_e.
by apply: (@connected_edge t' u i x y IH); [rewrite (origin_other li id_)|rewrite target_other].
Qed.

Lemma connectedE u w : connected t' u w <-> connected t (hangs u) (hangs w).
Proof.
split=> [|/connected_up]; first exact: connected_down.
rewrite /NewEdge.hangs; case: (w =P v) => [->|_]; case: (u =P v) => [->|_] //.
- by move=> _; apply: connected_self.
- exact: to_v.
by move=> C; apply: connected_trans C; apply: to_b; apply: connected_self.
Qed.

Lemma vertex_atE c w : vertex_at t c = Some w <-> exists2 w', vertex_at t' c = Some w' & hangs w' = w.
Proof.
rewrite /vertex_at -[boundary_start t' c]/(boundary_start t c); case S: (boundary_start t c) => [[i|u]|]; last 2 first.
- have hu := hangs_old (start_vertex S); split=> [[<-]|[w' [<-] <-]]; [by exists u|by rewrite hu].
- by split=> // -[].
have li := start_live S; case: (i =P d) => [->|id_].
  rewrite origin_d originE old_h ?old_k // eqxx; split=> [[<-]|[w' [<-] <-]]; last by rewrite hangs_v.
  by exists v => //; apply: hangs_v.
rewrite origin_other //; split=> [O|[w' O <-]]; last by rewrite (hangs_end O).
by exists w => //; apply: hangs_end O.
Qed.

Lemma split_t1 : t1_outside t'.
Proof. by apply: (hanging_t1 keeps live_b vertexE _ connectedE vertex_atE). Qed.

Lemma split_t2 : t2_nesting t'.
Proof. by apply: (hanging_t2 keeps live_b vertexE _ _ _ _ connectedE vertex_atE). Qed.

Lemma split_t3 : t3_euler t'.
Proof.
apply: (hanging_t3 keeps free_vertex live_b vertexE _ _ connectedE vertex_atE (h := h)) => //; last first.
  exact: (edges_more keeps free_h free_k half_edgeE twinE).
case=> // _; [by split; [exact: split_links|case: (keeps R1)]|exact: split_l1|exact: split_l2|exact: split_l3|
  exact: split_v1|exact: split_v2|exact: split_b1|exact: split_b2|exact: (keeps F1)|exact: (keeps F2)].
Qed.

Lemma split_rules : rules t'.
Proof.
have H r : index r < index T4 -> holds t' r.
  case: r => // _; [by split; [exact: split_links|case: (keeps R1)]|exact: split_l1|exact: split_l2|exact: split_l3|
    exact: split_v1|exact: split_v2|exact: split_b1|exact: split_b2|exact: (keeps F1)|exact: (keeps F2)|
    exact: split_t1|exact: split_t2|exact: split_t3].
by move=> r; case: (ltnP (index r) (index T4)) => [/H //|]; case: r => // _; apply: t4_follows => q; apply: H.
Qed.

End SplitEdge.

(** Where [v], [h] and [k] are free slots and [e] is a half-edge: if all rules held before, they hold after. *)
Theorem split_edge_keeps_rules t e v h k : half_edge t e ->
  ~~ vertex t v -> ~~ half_edge t h -> ~~ half_edge t k -> h != k ->
  rules t -> rules (split_edge t e v h k).
Proof.
move=> le fv fh fk hk keeps; have [_ [d D ld] [ne N _] _ _] := links_of keeps le.
have [[b B _] _ _ [pd P _] _] := links_of keeps ld.
exact: (split_rules keeps fv fh fk hk D B N P).
Qed.
