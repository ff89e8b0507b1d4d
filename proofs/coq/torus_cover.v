(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Glued, positive cells of degree 1 in a periodic box of the plane cover it once: docs/theory.md 8.3.

   - torus_covered       each point is in a translate of a cell
   - torus_disjoint      a point strictly inside one is in no other
   - torus_listed_once   and no cell is listed twice
   - star_covers         the cells at a corner cover all directions from there, whatever the degree is *)
Require Import Reals ZArith Lra Lia Psatz List Permutation.
From Annulus Require Import sums small width_2 plane_mesh plane_crossings plane_embedding torus_2 torus_powers torus_count.
Import ListNotations.
Open Scope R_scope.

Section placed.
Variables (x : nat -> point_2) (L : box_2).
Hypothesis box_positive : 0 < det_2 L.
Variable T : list torus_cell_2.
Hypothesis gluing : glued_torus_2 T.
Hypothesis cells_positive : positive_torus_2 x L T.
Hypothesis once : covers_2 T = 2%Z.
Notation spot := (spot x L).
Notation in_torus_cell := (in_torus_cell x L).
Notation "'rotated' r k" := (In r (rotations_2 (instance k))) (at level 10, r at level 9, k at level 9).

Definition inside_torus_cell (z : point_2) (c : torus_cell_2) : Prop := let '(a, b, q) := c in strictly_in z (spot a) (spot b) (spot q).
Definition torus_middle (c : torus_cell_2) : point_2 := let '(a, b, q) := c in centre (spot a) (spot b) (spot q).

Lemma box_not_flat : fst (fst L) <> 0 \/ snd (fst L) <> 0.
Proof.
  destruct (Req_dec (fst (fst L)) 0) as [E|E]; [right|now left]. intro E'. assert (P := box_positive). unfold det_2 in P. rewrite E, E' in P. lra.
Qed.

Lemma middle_is_inside k : In (fst k) T -> inside_torus_cell (torus_middle (instance k)) (instance k).
Proof.
  intro I. assert (P : 0 < area_of x L (instance k)) by (unfold instance; rewrite area_moved; now apply cells_positive).
  destruct (instance k) as ((a, b), q). now apply centre_strictly.
Qed.

Lemma once_or_not z k : In (fst k) T -> (crossings_at x L z (instance k) = 0 \/ crossings_at x L z (instance k) = 1) /\
  (inside_torus_cell z (instance k) -> crossings_at x L z (instance k) = 1) /\ (crossings_at x L z (instance k) = 1 -> in_torus_cell z (instance k)).
Proof.
  intro I. assert (P : 0 < area_of x L (instance k)) by (unfold instance; rewrite area_moved; now apply cells_positive).
  destruct (instance k) as ((a, b), q). destruct (crossing_once (fst L) z (spot a) (spot b) (spot q) P) as (A & B & C).
  split; [exact A|]. split; [exact (B box_not_flat)|exact C].
Qed.

Definition cell_dec (c c' : torus_cell_2) : {c = c'} + {c <> c'}.
Proof. repeat decide equality. Defined.

Lemma count_is_one z : eventually (fun n => sum (fun k => crossings_at x L z (instance k)) (instances T n) = 1).
Proof.
  apply (eventually_impl (fun n => 2 * sum (fun k => crossings_at x L z (instance k)) (instances T n) = IZR (covers_2 T))); [|now apply counted].
  intros n E. rewrite once in E. lra.
Qed.

Lemma of_instances n k : In k (instances T n) -> In (fst k) T.
Proof. destruct k. intro I. now apply in_prod_iff in I. Qed.

Lemma in_instances_at_last k : In (fst k) T -> eventually (fun n => In k (instances T n)).
Proof.
  destruct k as (c, (i, j)). intro I. exists (Z.max (Z.abs i) (Z.abs j)). intros n N. apply in_instances; [exact I|]. cbn [fst snd]. lia.
Qed.

Theorem torus_covered z : exists c u, In c T /\ in_torus_cell z (moved_cell_2 u c).
Proof.
  destruct (eventually_some _ (count_is_one z)) as (n & E).
  destruct (sum_negative (fun k => -1 * crossings_at x L z (instance k)) (instances T n)) as ((c, u) & I & N); [rewrite sum_scale; lra|].
  apply of_instances in I. exists c, u. split; [exact I|]. destruct (once_or_not z (c, u) I) as ([A|A] & _ & B); [exfalso|now apply B].
  cbv beta in N. rewrite A in N. lra.
Qed.

Lemma inside_both z k k' : In (fst k) T -> In (fst k') T -> inside_torus_cell z (instance k) -> inside_torus_cell z (instance k') -> k = k'.
Proof.
  intros I I' H H'. assert (dec : {k = k'} + {k <> k'}) by (repeat decide equality). destruct dec as [E|D]; [exact E|exfalso].
  assert (Z := eventually_and _ _ (in_instances_at_last k I) (in_instances_at_last k' I')).
  destruct (eventually_some _ (eventually_and _ _ (count_is_one z) Z)) as (n & E & A & B).
  destruct (once_or_not z k I) as (_ & C & _), (once_or_not z k' I') as (_ & C' & _).
  assert (K := two_of (fun k => crossings_at x L z (instance k)) (instances T n) k k'). cbv beta in K. rewrite E, (C H), (C' H') in K.
  assert (2 <= 1); [|lra]. replace 2 with (1 + 1) by ring. apply K; trivial.
  intros s S. apply of_instances in S. destruct (once_or_not z s S) as ([->| ->] & _); lra.
Qed.

Lemma inside_nearby z y c : inside_torus_cell z c -> small (fun e => inside_torus_cell (mix e z y) c).
Proof.
  destruct c as ((a, b), q). intros (A & B & C).
  apply (small_impl (fun e => 0 < (1 - e) * turning (spot a) (spot b) z + e * turning (spot a) (spot b) y /\
    (0 < (1 - e) * turning (spot b) (spot q) z + e * turning (spot b) (spot q) y /\ 0 < (1 - e) * turning (spot q) (spot a) z + e *
    turning (spot q) (spot a) y))).
  - intros e _ H. unfold inside_torus_cell, strictly_in. now rewrite !turning_mix.
  - apply small_and; [|apply small_and]; now apply small_positive.
Qed.

Lemma to_the_middle z k : In (fst k) T -> in_torus_cell z (instance k) -> forall e, 0 < e <= 1 ->
  inside_torus_cell (mix e z (torus_middle (instance k))) (instance k).
Proof.
  intros I H e E. assert (M := middle_is_inside k I). destruct (instance k) as ((a, b), q). now apply mix_strictly.
Qed.

Theorem torus_disjoint z k k' : In (fst k) T -> In (fst k') T -> inside_torus_cell z (instance k) -> in_torus_cell z (instance k') -> k = k'.
Proof.
  intros I I' H H'.
  destruct (small_exists _ (small_and _ _ (inside_nearby z (torus_middle (instance k')) _ H) (small_below 1 Rlt_0_1))) as (e & E & A & B).
  apply (inside_both _ k k' I I' A). apply to_the_middle; trivial. lra.
Qed.

(* Nor is a cell listed twice. *)
Theorem torus_listed_once : NoDup T.
Proof.
  apply (NoDup_count_occ' cell_dec). intros c I. apply Nat.le_antisymm; [|now apply (count_occ_In cell_dec)].
  apply Nat.nlt_ge. intro Twice. set (z := torus_middle (instance (c, (0, 0)%Z))). assert (M := middle_is_inside (c, (0, 0)%Z) I). fold z in M.
  destruct (eventually_some _ (eventually_and _ _ (count_is_one z) (in_instances_at_last (c, (0, 0)%Z) I))) as (n & E & K).
  unfold instances in E, K. rewrite sum_list_prod in E.
  set (g := fun c => sum (fun t => crossings_at x L z (instance (c, t))) (list_prod (up_to n) (up_to n))) in E.
  assert (N : forall c' t, In c' T -> 0 <= crossings_at x L z (instance (c', t))) by (intros c' t I';
  destruct (once_or_not z (c', t) I') as ([->| ->] & _); lra).
  assert (One : 1 <= g c).
  { apply in_prod_iff in K. destruct K as [_ K]. apply in_split in K. destruct K as (l & l' & S). unfold g. rewrite S, sum_app, sum_cons.
    assert (C := proj1 (proj2 (once_or_not z (c, (0, 0)%Z) I)) M). unfold offset_2 in *. rewrite C.
    assert (0 <= sum (fun t => crossings_at x L z (instance (c, t))) l) by (apply sum_nonneg; intros t _; exact (N c t I)).
    assert (0 <= sum (fun t => crossings_at x L z (instance (c, t))) l') by (apply sum_nonneg; intros t _; exact (N c t I)). unfold offset_2 in *. lra. }
  assert (Many : forall l, incl l T -> INR (count_occ cell_dec l c) <= sum g l).
  { induction l as [|c' l IH]; intro H; [simpl; lra|]. assert (Hl := IH (fun s J => H s (or_intror J))).
    assert (Hc : 0 <= g c'). { unfold g. apply sum_nonneg. intros t _. exact (N c' t (H c' (or_introl eq_refl))). }
    cbn [count_occ sum]. destruct (cell_dec c' c) as [E'|_]; [|lra]. rewrite S_INR, E'. lra. }
  assert (A := Many T (fun s J => J)). apply (le_INR 2) in Twice. replace (INR 2) with 2 in Twice by (simpl; ring). lra.
Qed.

(* ---- The cells at a corner cover all directions ---- *)

Lemma turning_corner a y : turning a y a = 0 /\ turning y a a = 0 /\ turning a a y = 0.
Proof. unfold turning, turn. repeat split; ring. Qed.

Lemma cotangents a b p y : 0 < turning b a y -> 0 < turning p a y -> 0 < turning a p b ->
  apex_dot b y a / turning b a y < apex_dot p y a / turning p a y.
Proof.
  intros B P H. apply Rminus_gt_0_lt.
  assert (N : 0 < apex_dot y y a).
  { unfold apex_dot. destruct (Req_dec (fst y) (fst a)) as [F|F]; [destruct (Req_dec (snd y) (snd a)) as [S|S]|].
    - exfalso. unfold turning, turn in B. rewrite F, S in B. lra.
    - assert (Y := Rsqr_pos_lt (snd y - snd a)). assert (X := Rle_0_sqr (fst y - fst a)). unfold Rsqr in *. lra.
    - assert (X := Rsqr_pos_lt (fst y - fst a)). assert (Y := Rle_0_sqr (snd y - snd a)). unfold Rsqr in *. lra. }
  replace (_ - _) with (apex_dot y y a * turning a p b / (turning b a y * turning p a y)).
  - apply Rdiv_lt_0_compat; now apply Rmult_lt_0_compat.
  - replace (apex_dot y y a * turning a p b) with (apex_dot p y a * turning b a y - apex_dot b y a * turning p a y) by
    (unfold apex_dot, turning, turn; ring).
    field. lra.
Qed.

Definition toward (y : point_2) (r : torus_cell_2) : Prop := let '(a, b, q) := r in 0 <= turning (spot a) (spot b) y /\ 0 <= turning (spot q) (spot a) y.
Definition star_covers_to (a : site_2) (y : point_2) : Prop := exists k b q, In (fst k) T /\ rotated (a, b, q) k /\ toward y (a, b, q).

Lemma star_list a : exists l, (forall r, In r l -> exists k, In (fst k) T /\ rotated r k) /\
  forall k b q, In (fst k) T -> rotated (a, b, q) k -> In (a, b, q) l.
Proof.
  destruct (finitely_many x L box_positive T (spot a) 1 cells_positive) as (l & A & B). exists l. split; [exact A|].
  intros k b q I R. apply (B k); trivial. unfold power_of. replace (beyond _ _ _ _) with 0; [unfold Rdiv; lra|]. unfold beyond, incircle, turn. ring.
Qed.

Lemma site_dec (s t : site_2) : {s = t} + {s <> t}.
Proof. repeat decide equality. Qed.

Lemma clockwise a y k b q : In (fst k) T -> rotated (a, b, q) k -> turning (spot a) (spot b) y < 0 -> star_covers_to a y.
Proof.
  intros I R N. destruct (star_list a) as (l & Back & All).
  set (bad := fun r : torus_cell_2 => let '(s, b, _) := r in s = a /\ turning (spot a) (spot b) y < 0).
  set (f := fun r : torus_cell_2 => let '(_, b, _) := r in - (apex_dot (spot b) y (spot a) / turning (spot b) (spot a) y)).
  apply (descend f bad l) with (a, b, q); [| |now apply (All k)|now split].
  - intros ((s, v), w). unfold bad. destruct (site_dec s a), (Rlt_dec (turning (spot a) (spot v) y) 0); (left; now split) || (right; tauto).
  - clear k b q I R N. intros ((s, b), q) Il [-> N]. destruct (Back _ Il) as (k & I & R).
    destruct (neighbour T k a b q gluing I R) as (k' & p & I' & R'). assert (R2 := rotation_turns _ _ R'). simpl in R2.
    assert (P := instance_positive x L T k' _ cells_positive I' R2). change (0 < turning (spot a) (spot p) (spot b)) in P.
    assert (S : turning (spot b) (spot a) y = - turning (spot a) (spot b) y) by (unfold turning, turn; ring).
    destruct (Rlt_dec (turning (spot a) (spot p) y) 0) as [N2|N2].
    + right. exists (a, p, b). split; [now apply (All k')|]. split; [now split|]. unfold f. apply Ropp_lt_contravar. apply cotangents; trivial; [lra|].
      rewrite turning_swap. lra.
    + left. exists k', p, b. split; [exact I'|]. split; [exact R2|]. simpl. lra.
Qed.

Lemma counterclockwise a y k b q : In (fst k) T -> rotated (a, b, q) k -> turning (spot q) (spot a) y < 0 -> star_covers_to a y.
Proof.
  intros I R N. destruct (star_list a) as (l & Back & All).
  set (bad := fun r : torus_cell_2 => let '(s, _, q) := r in s = a /\ turning (spot q) (spot a) y < 0).
  set (f := fun r : torus_cell_2 => let '(_, _, q) := r in apex_dot (spot q) y (spot a) / turning (spot q) (spot a) y).
  apply (descend f bad l) with (a, b, q); [| |now apply (All k)|now split].
  - intros ((s, v), w). unfold bad. destruct (site_dec s a), (Rlt_dec (turning (spot w) (spot a) y) 0); (left; now split) || (right; tauto).
  - clear k b q I R N. intros ((s, b), q) Il [-> N]. destruct (Back _ Il) as (k & I & R). assert (R1 := rotation_turns _ _ R).
    assert (R2 := rotation_turns _ _ R1). simpl in R1, R2.
    destruct (neighbour T k q a b gluing I R2) as (k' & p & I' & R').
    assert (P := instance_positive x L T k' _ cells_positive I' R'). change (0 < turning (spot a) (spot q) (spot p)) in P.
    assert (S : turning (spot a) (spot q) y = - turning (spot q) (spot a) y) by (unfold turning, turn; ring).
    destruct (Rlt_dec (turning (spot p) (spot a) y) 0) as [N2|N2].
    + right. exists (a, q, p). split; [now apply (All k')|]. split; [now split|]. unfold f.
      set (m := (2 * fst (spot a) - fst y, 2 * snd (spot a) - snd y)).
      assert (M : forall v, turning v (spot a) m = - turning v (spot a) y /\ apex_dot v m (spot a) = - apex_dot v y (spot a))
        by (intro v; unfold turning, turn, apex_dot, m; cbn [fst snd]; split; ring).
      destruct (M (spot p)) as [P1 P2], (M (spot q)) as [Q1 Q2].
      assert (K : apex_dot (spot p) m (spot a) / turning (spot p) (spot a) m < apex_dot (spot q) m (spot a) / turning (spot q) (spot a) m) by
      (apply cotangents; lra).
      rewrite P1, P2, Q1, Q2 in K. unfold Rdiv in *. rewrite !Rinv_opp in K. lra.
    + left. exists k', q, p. split; [exact I'|]. split; [exact R'|]. simpl. lra.
Qed.

Lemma star_covers a y k b q : In (fst k) T -> rotated (a, b, q) k -> star_covers_to a y.
Proof.
  intros I R. destruct (Rlt_dec (turning (spot a) (spot b) y) 0) as [N|N]; [now apply (clockwise a y k b q)|].
  destruct (Rlt_dec (turning (spot q) (spot a) y) 0) as [N'|N']; [now apply (counterclockwise a y k b q)|].
  exists k, b, q. split; [exact I|]. split; [exact R|]. simpl. lra.
Qed.
End placed.
