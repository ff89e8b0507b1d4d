(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The five points of a bi-cell in space and the numbers from which the code computes half widths: docs/theory.md, section 4.

   Facet a b c, opposite vertices p and q. Everything is computed from the vectors from a to the others, without a division:
   - lambda i       the affine dependence of the five points, lambda p and lambda q the (6-fold) volumes of the two cells
   - det            the insphere determinant; the certificate of the bi-cell is det > 0
   - U i            2 lambda_i times the centre of the sphere through the four points other than i
   - Lam B, N B     the sums of lambda and of U over a set B of the five

   level       one function, Lam |z|^2 - N.z, is constant on the points outside B, and on those of B larger by det
   equidistant N / 2 Lam is the centre of the annulus of the partition
   radii       the difference of its squared radii is det / Lam
   width       half the width is det / (|N - 2 Lam x_A| + |N - 2 Lam x_B|); where Lam = 0, of a slab (bicell_slab.v) *)
Require Import Reals Lra Psatz.
From Annulus Require Export vectors.
Open Scope R_scope.

Inductive vertex := a | b | c | p | q.
Definition placement := vertex -> vec.

Definition sum (f : vertex -> R) := f a + f b + f c + f p + f q.
Definition vsum (f : vertex -> vec) := f a ⊕ f b ⊕ f c ⊕ f p ⊕ f q.
Definition among (B : vertex -> bool) (f : vertex -> R) i := if B i then f i else 0.
Definition vamong (B : vertex -> bool) (f : vertex -> vec) i := if B i then f i else zero.

Section numbers.
Variable x : placement.

Definition rel i := x i ⊖ x a.
Let xb := rel b. Let xc := rel c. Let xp := rel p. Let xq := rel q.

Definition lambda_b := vol xc xp xq.
Definition lambda_c := - vol xb xp xq.
Definition lambda_p := vol xb xc xq.
Definition lambda_q := - vol xb xc xp.
Definition lambda i :=
  match i with
  | a => - (lambda_b + lambda_c + lambda_p + lambda_q)
  | b => lambda_b | c => lambda_c | p => lambda_p | q => lambda_q
  end.

Definition det := lambda_b * sq xb + lambda_c * sq xc + lambda_p * sq xp + lambda_q * sq xq.

(* 2 [u v w] times the centre of the sphere through 0, u, v, w. *)
Definition twice_centre u v w := sq u ⊙ (v ✕ w) ⊕ sq v ⊙ (w ✕ u) ⊕ sq w ⊙ (u ✕ v).
Definition U_b := twice_centre xc xp xq.
Definition U_c := (-1) ⊙ twice_centre xb xp xq.
Definition U_p := twice_centre xb xc xq.
Definition U_q := (-1) ⊙ twice_centre xb xc xp.
Definition U i :=
  match i with
  | a => (-1) ⊙ (U_b ⊕ U_c ⊕ U_p ⊕ U_q)
  | b => U_b | c => U_c | p => U_p | q => U_q
  end.

Definition Lam B := sum (among B lambda).
Definition N B := vsum (vamong B U).
(* 2 Lam times the vector from x_i to the centre. *)
Definition arm B i := N B ⊖ (2 * Lam B) ⊙ rel i.
End numbers.

(* Opens definitions down to the coordinates of the vectors from a. *)
Ltac open_numbers x :=
  unfold det, lambda, lambda_b, lambda_c, lambda_p, lambda_q, U, U_b, U_c, U_p, U_q, twice_centre in *;
  try replace (rel x a) with zero in * by (unfold rel; vector);
  generalize (rel x b) (rel x c) (rel x p) (rel x q).

Section facts.
Variable x : placement.

Lemma rel_a : rel x a = zero.
Proof. unfold rel. vector. Qed.

Lemma dependence : sum (lambda x) = 0.
Proof. unfold sum. simpl. ring. Qed.

Lemma dependence_rel : vsum (fun i => lambda x i ⊙ rel x i) = zero.
Proof. unfold vsum. rewrite rel_a. generalize (lambda x a). open_numbers x. vector. Qed.

Lemma dependence_points : vsum (fun i => lambda x i ⊙ x i) = zero.
Proof.
  replace (vsum (fun i => lambda x i ⊙ x i))
    with (vsum (fun i => lambda x i ⊙ rel x i) ⊕ sum (lambda x) ⊙ x a)
    by (unfold vsum, sum, rel; generalize (lambda x); vector).
  rewrite dependence_rel, dependence. vector.
Qed.

(* Whatever the centre, the dependence adds the squared distances, or powers, up to the determinant. *)
Lemma det_rel : det x = sum (fun i => lambda x i * sq (rel x i)).
Proof. unfold sum, det. rewrite rel_a. simpl. unfold sq at 5. coordinates. ring. Qed.

Lemma linear f : (forall u v, f (u ⊕ v) = f u + f v) -> (forall k u, f (k ⊙ u) = k * f u) ->
  sum (fun i => lambda x i * f (x i)) = 0.
Proof.
  intros A S. unfold sum. rewrite <- !S, <- !A.
  fold (vsum (fun i => lambda x i ⊙ x i)). rewrite dependence_points.
  replace zero with (0 ⊙ zero) by vector. rewrite S. ring.
Qed.

(* The same for any function Lam |z|^2 - n.z - t: spheres, and planes where k is 0. *)
Definition quadric k (n : vec) t o z := k * sq (z ⊖ o) - n · (z ⊖ o) - t.

Theorem powers k n t o : sum (fun i => lambda x i * quadric k n t o (x i)) = k * det x.
Proof.
  assert (E : forall z, quadric k n t o z
    = k * sq (z ⊖ x a) + (2 * k) * ((x a ⊖ o) · z) + (-1) * (n · z) + (k * (sq (x a ⊖ o) - 2 * ((x a ⊖ o) · x a)) + n · o - t)).
  { intro. unfold quadric. coordinates. ring. }
  unfold sum. rewrite !E. rewrite det_rel.
  generalize (linear (fun z => (x a ⊖ o) · z) ltac:(vector) ltac:(vector)).
  generalize (linear (fun z => n · z) ltac:(vector) ltac:(vector)).
  generalize dependence. unfold sum. fold (rel x a) (rel x b) (rel x c) (rel x p) (rel x q).
  generalize (lambda x a) (lambda x b) (lambda x c) (lambda x p) (lambda x q).
  set (t' := k * _ + _ - t). clearbody t'. 
  intros la lb lc lp lq S E1 E2.
  replace la with (- (lb + lc + lp + lq)) in * by lra. clear S.
  match goal with |- ?l = ?r => replace l with (r + 2 * k * 0 + (-1) * 0) by (rewrite <- E1 at 2; rewrite <- E2; ring) end.
  ring.
Qed.

(* What the certificate says: where both cells are positive, det > 0 exactly if q is outside the sphere of a, b, c, p. *)
Theorem empty_sphere o r2 : sq (x a ⊖ o) = r2 -> sq (x b ⊖ o) = r2 -> sq (x c ⊖ o) = r2 -> sq (x p ⊖ o) = r2 ->
  lambda x q * (sq (x q ⊖ o) - r2) = det x.
Proof.
  intros A B C P. generalize (powers 1 zero r2 o). unfold sum, quadric. rewrite A, B, C, P.
  assert (E : forall v, zero · v = 0) by vector. rewrite !E. lra.
Qed.

(* lambda_i |z|^2 - U_i.z is constant on the four points other than i, and larger by det at x_i. *)
Definition one (B : vertex -> bool) i := if B i then det x else 0.

Lemma centre_dot u v w z : twice_centre u v w · z = sq u * vol z v w - sq v * vol z u w + sq w * vol z u v.
Proof. unfold twice_centre. generalize (sq u) (sq v) (sq w). vector. Qed.

Lemma sphere i j : i <> a ->
  lambda x i * sq (rel x j) - U x i · rel x j = if match i, j with a, a | b, b | c, c | p, p | q, q => true | _, _ => false end then det x else 0.
Proof.
  assert (Z : sq zero = 0 /\ forall v, v · zero = 0) by (split; vector). destruct Z as (Z & Z').
  assert (M : forall v w, ((-1) ⊙ v) · w = - (v · w)) by vector.
  assert (S : forall u v w, vol u v w = - vol v u w) by vector. assert (T : forall u v w, vol u v w = vol v w u) by vector.
  assert (E : forall u w, vol u u w = 0 /\ vol u w u = 0) by (split; vector).
  intros ia. destruct i; [now elim ia| | | |]; unfold det; cbn [lambda U];
    unfold lambda_b, lambda_c, lambda_p, lambda_q, U_b, U_c, U_p, U_q; rewrite ?M;
    (destruct j; cbn match; [rewrite rel_a, Z, Z'; ring| | | |]);
    rewrite centre_dot, ?(fun u w => proj1 (E u w)), ?(fun u w => proj2 (E u w)), ?(T (rel x q)), ?(T (rel x p) (rel x b) (rel x c)),
      ?(S (rel x p)), ?(S (rel x c) (rel x b)); ring.
Qed.

Lemma sphere_a j : lambda x a * sq (rel x j) - U x a · rel x j = match j with a => 0 | _ => - det x end.
Proof.
  generalize (sphere b j) (sphere c j) (sphere p j) (sphere q j). intros Eb Ec Ep Eq.
  specialize (Eb ltac:(discriminate)). specialize (Ec ltac:(discriminate)).
  specialize (Ep ltac:(discriminate)). specialize (Eq ltac:(discriminate)).
  assert (E : U x a · rel x j = - (U x b · rel x j + U x c · rel x j + U x p · rel x j + U x q · rel x j))
    by (simpl; generalize (U_b x) (U_c x) (U_p x) (U_q x) (rel x j); vector).
  rewrite E. simpl lambda in *. destruct j; simpl in *; lra.
Qed.

(* One function for a partition: constant outside B, and on B larger by det. *)
Theorem level B j : Lam x B * sq (rel x j) - N x B · rel x j = one B j - one B a.
Proof.
  assert (E : Lam x B * sq (rel x j) - N x B · rel x j =
    sum (among B (fun i => lambda x i * sq (rel x j) - U x i · rel x j))).
  { assert (D : forall i, among B (fun i => lambda x i * sq (rel x j) - U x i · rel x j) i =
      among B (lambda x) i * sq (rel x j) - vamong B (U x) i · rel x j) by (intro; unfold among, vamong; destruct (B i); vector).
    unfold Lam, N, sum, vsum. rewrite !D. generalize (among B (lambda x)) (vamong B (U x)) (sq (rel x j)) (rel x j). vector. }
  rewrite E. unfold sum, among, one. rewrite sphere_a, !sphere by discriminate.
  assert (Z : forall t : bool, (if t then 0 else 0) = 0) by now intros [].
  assert (M : forall t : bool, (if t then - det x else 0) = - if t then det x else 0) by (intros []; ring).
  destruct j; cbn match; rewrite ?Z, ?M; ring.
Qed.
End facts.

(* The partition of the five points into B and the rest; i is a point of the rest and j one of B. *)
Section partition.
Variable x : placement.
Variable B : vertex -> bool.

Lemma arm_sq i : sq (arm x B i) = sq (N x B) + 4 * Lam x B * (one x B i - one x B a).
Proof. rewrite <- level. unfold arm. generalize (N x B) (Lam x B) (rel x i). vector. Qed.

Lemma arm_a : arm x B a = N x B.
Proof. unfold arm. rewrite rel_a. generalize (N x B). vector. Qed.

(* On either side the arms are equally long. *)
Lemma equal_arms i k : B i = B k -> norm (arm x B i) = norm (arm x B k).
Proof. intro E. apply norm_of_sq. rewrite !arm_sq. unfold one. now rewrite E. Qed.

(* |M|^2 - |N|^2 = 4 Lam det *)
Theorem radii i j : B i = false -> B j = true ->
  norm (arm x B j) * norm (arm x B j) - norm (arm x B i) * norm (arm x B i) = 4 * Lam x B * det x.
Proof. intros Hi Hj. rewrite !norm_sq, !arm_sq. unfold one. rewrite Hi, Hj. ring. Qed.

(* The centre of the annulus, where there is one. *)
Definition centre := x a ⊕ / (2 * Lam x B) ⊙ N x B.

Lemma distance_arm m : Lam x B <> 0 -> norm (centre ⊖ x m) = norm (arm x B m) / (2 * Rabs (Lam x B)).
Proof.
  intro H. replace (centre ⊖ x m) with (/ (2 * Lam x B) ⊙ arm x B m).
  - rewrite norm_scale, Rabs_inv, Rabs_mult. rewrite (Rabs_pos_eq 2) by lra. field. now apply Rabs_no_R0.
  - unfold centre, arm, rel. generalize (N x B) (x a) (x m). intros.
    apply vec_eq; coordinates; field; exact H.
Qed.

Theorem equidistant i k : Lam x B <> 0 -> B i = B k -> norm (centre ⊖ x i) = norm (centre ⊖ x k).
Proof. intros H E. rewrite !distance_arm by exact H. now rewrite (equal_arms i k E). Qed.

Variables i j : vertex.
Hypothesis outside : B i = false.
Hypothesis inside : B j = true.

Definition arms := norm (arm x B i) + norm (arm x B j).
Definition half_width := det x / arms.

Lemma arms_nonneg : 0 <= arms.
Proof. unfold arms. generalize (norm_nonneg (arm x B i)) (norm_nonneg (arm x B j)). lra. Qed.

(* Where the determinant is not 0 the formula does not divide by 0, also when Lam is 0. *)
Theorem arms_pos : det x <> 0 -> 0 < arms.
Proof.
  intro H. destruct (Rle_lt_or_eq_dec _ _ arms_nonneg) as [L|E]; [exact L | exfalso; apply H].
  unfold arms in E. generalize (norm_nonneg (arm x B i)) (norm_nonneg (arm x B j)). intros.
  assert (Ei : arm x B i = zero) by (apply norm_zero; lra).
  assert (Ej : arm x B j = zero) by (apply norm_zero; lra).
  generalize (level x B i) (level x B j). unfold one. rewrite outside, inside. intros Li Lj.
  assert (Lam x B * (sq (rel x i) - sq (rel x j)) = N x B · (rel x i ⊖ rel x j) - det x).
  { replace (N x B · (rel x i ⊖ rel x j)) with (N x B · rel x i - N x B · rel x j)
      by (generalize (N x B) (rel x i) (rel x j); vector). lra. }
  assert (Ni : N x B = (2 * Lam x B) ⊙ rel x i) by (replace (N x B) with (arm x B i ⊕ (2 * Lam x B) ⊙ rel x i)
    by (unfold arm; generalize (N x B) (rel x i); vector); rewrite Ei; vector).
  assert (Nj : N x B = (2 * Lam x B) ⊙ rel x j) by (replace (N x B) with (arm x B j ⊕ (2 * Lam x B) ⊙ rel x j)
    by (unfold arm; generalize (N x B) (rel x j); vector); rewrite Ej; vector).
  (* N.(x_i - x_j) = Lam (x_i + x_j).(x_i - x_j), as N is 2 Lam times either *)
  assert (N x B · (rel x i ⊖ rel x j) = Lam x B * (sq (rel x i) - sq (rel x j))); [|lra].
  replace (N x B) with ((1 / 2) ⊙ (N x B ⊕ N x B)) by (generalize (N x B); intro; apply vec_eq; coordinates; field).
  rewrite Ni at 1. rewrite Nj. generalize (rel x i) (rel x j) (Lam x B). intros. coordinates. field.
Qed.

(* The difference of the radii of the annulus. Its sphere through B is the outer one exactly if Lam is positive. *)
Theorem width : Lam x B <> 0 ->
  norm (centre ⊖ x j) - norm (centre ⊖ x i) = Lam x B / Rabs (Lam x B) * (2 * half_width).
Proof.
  intro H. rewrite !distance_arm by exact H. assert (L : 0 < Rabs (Lam x B)) by now apply Rabs_pos_lt.
  generalize (radii i j outside inside). intro E.
  destruct (Rle_lt_or_eq_dec _ _ arms_nonneg) as [S|S].
  - assert (D : norm (arm x B j) - norm (arm x B i) = 4 * Lam x B * det x / arms).
    { apply Rmult_eq_reg_r with arms; [|lra]. unfold Rdiv at 1. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
      rewrite <- E. unfold arms. ring. }
    unfold half_width. replace (norm (arm x B j) / (2 * Rabs (Lam x B)) - norm (arm x B i) / (2 * Rabs (Lam x B)))
      with ((norm (arm x B j) - norm (arm x B i)) / (2 * Rabs (Lam x B))) by (field; lra).
    rewrite D. field. split; lra.
  - unfold arms in S. generalize (norm_nonneg (arm x B i)) (norm_nonneg (arm x B j)). intros.
    replace (norm (arm x B i)) with 0 in * by lra. replace (norm (arm x B j)) with 0 in * by lra.
    assert (D : det x = 0) by (apply Rmult_eq_reg_l with (4 * Lam x B); lra).
    unfold half_width. rewrite D. unfold Rdiv. ring.
Qed.
End partition.

(* The four partitions of the code, the facet's points on the left; half_width with the point that gives |N| itself and one
   of the other side. *)
Definition pq i := match i with p | q => true | _ => false end.
Definition cpq i := match i with c | p | q => true | _ => false end.
Definition bpq i := match i with b | p | q => true | _ => false end.
Definition apq i := match i with a | p | q => true | _ => false end.

Section code.
Variable x : placement.
Let n := rel x b ✕ rel x c.

Lemma abc_pq : Lam x pq = lambda_p x + lambda_q x /\ N x pq = U_p x ⊕ U_q x.
Proof. split; [unfold Lam, sum, among; simpl; ring|]. unfold N, vsum, vamong. simpl. generalize (U_p x) (U_q x). vector. Qed.

Lemma ab_cpq : Lam x cpq = lambda_c x + lambda_p x + lambda_q x /\ N x cpq = U_c x ⊕ U_p x ⊕ U_q x.
Proof. split; [unfold Lam, sum, among; simpl; ring|]. unfold N, vsum, vamong. simpl. generalize (U_c x) (U_p x) (U_q x). vector. Qed.

Lemma ca_bpq : Lam x bpq = lambda_b x + lambda_p x + lambda_q x /\ N x bpq = U_b x ⊕ U_p x ⊕ U_q x.
Proof. split; [unfold Lam, sum, among; simpl; ring|]. unfold N, vsum, vamong. simpl. generalize (U_b x) (U_p x) (U_q x). vector. Qed.

Lemma bc_apq : Lam x apq = - (lambda_b x + lambda_c x) /\ N x apq = (-1) ⊙ (U_b x ⊕ U_c x).
Proof.
  split; [unfold Lam, sum, among; simpl; ring|]. unfold N, vsum, vamong. simpl.
  generalize (U_b x) (U_c x) (U_p x) (U_q x). vector.
Qed.

(* The sum of the volumes of the cells is the facet's area vector times the way from p to q. *)
Lemma sum_of_cells : Lam x pq = n · (rel x q ⊖ rel x p).
Proof. rewrite (proj1 abc_pq). unfold lambda_p, lambda_q, n. generalize (rel x b) (rel x c) (rel x p) (rel x q). vector. Qed.

(* The form with the circumcentre of the facet, u / 2 |n|^2, is the same for a b c | p q, multiplied by |n|^2. *)
Definition facet_u := sq (rel x b) ⊙ (rel x c ✕ n) ⊕ sq (rel x c) ⊙ (n ✕ rel x b).
Definition facet_s := sq n * (sq (rel x q) - sq (rel x p)) - facet_u · (rel x q ⊖ rel x p).

Theorem facet_form : Lam x pq ⊙ facet_u ⊕ facet_s ⊙ n = sq n ⊙ N x pq.
Proof.
  rewrite sum_of_cells, (proj2 abc_pq). unfold facet_s, facet_u, n, U_p, U_q, twice_centre.
  generalize (rel x b) (rel x c) (rel x p) (rel x q). vector.
Qed.
End code.
