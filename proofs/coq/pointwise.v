(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The pointwise lemma (docs/theory.md 2.2) in any dimension.

   - every_sphere   P = sum of lambda |x|^2 is the sum of lambda times the power for every sphere
   - pointwise      both cells positive, and for every A in the facet with two points or more a sphere with A inside and the others outside:
                    then the empty sphere holds

   Points have their coordinates named by a list K, whatever it is. A bi-cell is a list F, the facet, and p, q. That the cells are positive is used as:
   F is independent, and an affine function vanishes on F, is negative at p and positive at q. That d + 2 points in R^d have an affine dependence is taken as known:
   `lambda` is one. *)
Require Import Reals Lra List.
From Annulus Require Import sums.
Import ListNotations.
Open Scope R_scope.

Section lemma_.
Variables (index coordinate : Type).
Hypothesis same : forall i j : index, {i = j} + {i <> j}.
Variable K : list coordinate.
Definition point := coordinate -> R.
Variable x : index -> point.

Definition square (u : point) := sum (fun k => u k * u k) K.
Definition minus (u v : point) : point := fun k => u k - v k.
Definition power (c : point) r2 i := square (minus (x i) c) - r2.
Definition affine (n : point) t i := sum (fun k => n k * x i k) K + t.

Section dependence.
Variable all : list index.
Variable lambda : index -> R.
Hypothesis zero_sum : sum lambda all = 0.
Hypothesis zero_mean : forall k, In k K -> sum (fun i => lambda i * x i k) all = 0.
Definition P := sum (fun i => lambda i * square (x i)) all.

Lemma no_affine n t : sum (fun i => lambda i * affine n t i) all = 0.
Proof.
  rewrite (sum_ext _ (fun i => sum (fun k => n k * (lambda i * x i k)) K + t * lambda i)).
  - rewrite sum_plus, sum_scale, zero_sum, sum_swap.
    rewrite (sum_ext _ (fun _ => 0)); [rewrite sum_zero; ring|].
    intros k H. rewrite sum_scale, zero_mean by exact H. ring.
  - intros i _. unfold affine. rewrite Rmult_plus_distr_l, <- sum_scale. f_equal; [|ring].
    apply sum_ext. intros k _. ring.
Qed.

Theorem every_sphere c r2 : sum (fun i => lambda i * power c r2 i) all = P.
Proof.
  unfold P.
  rewrite (sum_ext _ (fun i => lambda i * square (x i) + lambda i * affine (fun k => -2 * c k) (square c - r2) i)).
  - rewrite sum_plus, no_affine. ring.
  - intros i _. rewrite <- Rmult_plus_distr_l. f_equal. unfold power, affine, square, minus.
    rewrite (sum_ext _ (fun k => x i k * x i k + (-2 * c k * x i k + c k * c k))) by (intros; ring).
    rewrite !sum_plus. ring.
Qed.
End dependence.

Variables (F : list index) (p q : index).
Hypothesis distinct : ~ In p F /\ ~ In q F /\ p <> q.
Let all := p :: q :: F.

Hypothesis independent : forall mu, sum mu F = 0 -> (forall k, In k K -> sum (fun i => mu i * x i k) F = 0) ->
  forall i, In i F -> mu i = 0.
Variables (n : point) (t : R).
Hypothesis on_facet : forall i, In i F -> affine n t i = 0.
Hypothesis p_below : affine n t p < 0.
Hypothesis q_above : 0 < affine n t q.
Hypothesis spheres : forall A : index -> bool, (forall i, A i = true -> In i F) ->
  (exists i j, i <> j /\ A i = true /\ A j = true) ->
  exists c r2, forall i, In i all -> (A i = true -> power c r2 i < 0) /\ (A i = false -> 0 < power c r2 i).

Lemma opposite_signs lambda : sum lambda all = 0 -> (forall k, In k K -> sum (fun i => lambda i * x i k) all = 0) ->
  lambda p * affine n t p + lambda q * affine n t q = 0.
Proof.
  intros Z M. generalize (no_affine all lambda Z M n t). unfold all. simpl.
  rewrite (sum_ext _ (fun _ => 0)), sum_zero; [lra|]. intros i H. rewrite (on_facet i H). ring.
Qed.

(* The determinant, up to a positive factor, is P: here it is positive. *)
Lemma positive lambda : sum lambda all = 0 -> (forall k, In k K -> sum (fun i => lambda i * x i k) all = 0) ->
  0 < lambda p -> 0 < lambda q -> 0 < P all lambda.
Proof.
  intros Z M Lp Lq.
  assert (N : exists f, In f F /\ lambda f < 0).
  { apply sum_negative. unfold all in Z. simpl in Z. lra. }
  destruct N as (f & Ff & Nf).
  set (A := fun i => if in_dec same i F then if Rlt_dec (lambda i) 0 then true else false else false).
  assert (A_true : forall i, A i = true -> In i F /\ lambda i < 0).
  { intros i. unfold A. destruct (in_dec same i F), (Rlt_dec (lambda i) 0); try discriminate. tauto. }
  assert (A_false : forall i, In i all -> A i = false -> 0 <= lambda i).
  { intros i [<-|[<-|I]]; [lra|lra|]. unfold A. destruct (in_dec same i F), (Rlt_dec (lambda i) 0); try discriminate; try tauto; lra. }
  assert (Ap : A p = false) by (unfold A; destruct (in_dec same p F); tauto).
  destruct (List.Exists_dec (fun i => i <> f /\ lambda i < 0) F) as [E|E].
  { intro i. destruct (same i f), (Rlt_dec (lambda i) 0); (right; tauto) || (left; tauto). }
  - apply Exists_exists in E. destruct E as (g & Fg & Ng & Lg).
    destruct (spheres A) as (c & r2 & H); [intros i I; now apply A_true| |].
    + exists f, g. unfold A. destruct (in_dec same f F); [|tauto]. destruct (in_dec same g F); [|tauto].
      destruct (Rlt_dec (lambda f) 0); [|tauto]. destruct (Rlt_dec (lambda g) 0); [|tauto]. repeat split. congruence.
    + rewrite <- (every_sphere all lambda Z M c r2). apply (sum_pos _ _ p).
      * intros i I. destruct (H i I) as [H1 H2]. destruct (A i) eqn:E.
        -- destruct (A_true i E) as [_ L]. generalize (H1 eq_refl). intro. apply Rlt_le. nra.
        -- generalize (A_false i I E) (H2 eq_refl). intros. apply Rmult_le_pos; lra.
      * now left.
      * apply Rmult_lt_0_compat; [exact Lp|]. now apply (proj2 (H p (or_introl eq_refl))).
  - (* f is a mean of the others: the sphere of radius 0 around it. *)
    rewrite <- (every_sphere all lambda Z M (x f) 0).
    assert (Square : forall u, 0 <= square u) by (intro u; apply sum_nonneg; intros k _; apply Rle_0_sqr).
    assert (Self : power (x f) 0 f = 0).
    { unfold power, square, minus. rewrite (sum_ext _ (fun _ => 0)), sum_zero; [ring|]. intros; ring. }
    apply (sum_pos _ _ p).
    + intros i I. destruct (same i f) as [->|D]; [rewrite Self; lra|]. apply Rmult_le_pos; [|unfold power; rewrite Rminus_0_r; apply Square].
      destruct I as [<-|[<-|I]]; [lra|lra|]. apply Rnot_lt_le. intro L. apply E, Exists_exists. now exists i.
    + now left.
    + apply Rmult_lt_0_compat; [exact Lp|]. unfold power. rewrite Rminus_0_r.
      destruct (Rle_lt_or_eq_dec 0 (square (minus (x p) (x f))) (Square _)) as [S|S]; [exact S|exfalso].
      (* p would be at f, on the facet. *)
      assert (Same : forall k, In k K -> x p k = x f k).
      { intros k I. apply Rminus_diag_uniq. apply Rsqr_0_uniq. unfold Rsqr.
        apply Rle_antisym; [|apply Rle_0_sqr]. apply Rnot_lt_le. intro L.
        assert (0 < square (minus (x p) (x f))); [|lra]. unfold square, minus.
        apply (sum_pos _ _ k); [intros; apply Rle_0_sqr|exact I|exact L]. }
      generalize (on_facet f Ff). unfold affine in *. intro Z0.
      rewrite (sum_ext _ (fun k => n k * x p k)) in Z0; [lra|]. intros k I. now rewrite (Same k I).
Qed.

Theorem pointwise lambda : sum lambda all = 0 -> (forall k, In k K -> sum (fun i => lambda i * x i k) all = 0) ->
  (exists i, In i all /\ lambda i <> 0) ->
  forall c r2, (forall i, In i F -> power c r2 i = 0) -> power c r2 p = 0 -> 0 < power c r2 q.
Proof.
  intros Z M (i0 & I0 & L0) c r2 Hf Hp.
  assert (G : forall mu, sum mu all = 0 -> (forall k, In k K -> sum (fun i => mu i * x i k) all = 0) -> 0 < mu p -> 0 < mu q ->
    0 < power c r2 q).
  { intros mu Zm Mm Lp Lq. generalize (positive mu Zm Mm Lp Lq). rewrite <- (every_sphere all mu Zm Mm c r2).
    unfold all. simpl. rewrite Hp, (sum_ext _ (fun _ => 0)), sum_zero; [|intros i I; rewrite (Hf i I); ring].
    intro. apply Rmult_lt_reg_l with (mu q); [exact Lq|]. lra. }
  assert (S := opposite_signs lambda Z M).
  destruct (Rtotal_order (lambda p) 0) as [L|[L|L]].
  - apply (G (fun i => - lambda i)).
    + rewrite (sum_ext _ (fun i => (-1) * lambda i)) by (intros; ring). rewrite sum_scale, Z. ring.
    + intros k I. rewrite (sum_ext _ (fun i => (-1) * (lambda i * x i k))) by (intros; ring). rewrite sum_scale, (M k I). ring.
    + lra.
    + nra.
  - assert (Lq : lambda q = 0) by (rewrite L in S; nra). exfalso. apply L0.
    destruct I0 as [<-|[<-|I0]]; [exact L|exact Lq|].
    apply (independent lambda); trivial.
    + unfold all in Z. simpl in Z. lra.
    + intros k I. generalize (M k I). unfold all. simpl. rewrite L, Lq. lra.
  - apply (G lambda); trivial. nra.
Qed.
End lemma_.
