(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Tolerances in a periodic box that moves: ways are taken relative to the box.

   The box of a certificate is taken to the present one by a linear map A, so its sites by A, too, and each vertex besides by a way d, seen in the old box: it is at A (x + d).
   Where A is a similarity times 1 + E, E of norm e at most, and the sites are within r of some point, the certificate has the tolerance that it had, less e r,
   for ways (1 + e) d. The offsets do not enter.

   - sphere_in_moving_box_3, circle_in_moving_box_2    for empty spheres and circles
   - orientation_in_moving_box_3, orientation_in_moving_box_2    for orientations nothing is lost, and A is any map that does not turn space over *)
Require Import Reals ZArith Lra Lia Psatz List.
From Annulus Require Import width_2 torus_2 torus_3 bicell tetrahedron.
Open Scope R_scope.

(* ---- In space ---- *)

Definition linear_3 (f : vec -> vec) : Prop := (forall u v, f (u ⊕ v) = f u ⊕ f v) /\ (forall k u, f (k ⊙ u) = k ⊙ f u).
Definition rotation_3 (Q : vec -> vec) : Prop :=
  linear_3 Q /\ (forall u v, Q u · Q v = u · v) /\ (forall u v w, vol (Q u) (Q v) (Q w) = vol u v w).
Definition small_3 (e : R) (E : vec -> vec) : Prop := linear_3 E /\ forall u, norm (E u) <= e * norm u.
(* A similarity, but for E. *)
Definition nearly_similar_3 (rho : R) (Q E : vec -> vec) (u : vec) : vec := rho ⊙ Q (u ⊕ E u).
Definition box_follows_3 (A : vec -> vec) (L0 L : box_3) : Prop := L1 L = A (L1 L0) /\ L2 L = A (L2 L0) /\ L3 L = A (L3 L0).
Definition vertices_follow_3 (A : vec -> vec) (d x0 x : nat -> vec) : Prop := forall v, x v = A (x0 v ⊕ d v).

Lemma sites_follow_3 A d x0 x L0 L s : linear_3 A -> box_follows_3 A L0 L -> vertices_follow_3 A d x0 x ->
  site_at_3 x L s = A (site_at_3 x0 L0 s ⊕ d (fst s)).
Proof.
  intros (P & S) (B1 & B2 & B3) F. destruct s as (v, ((i, j), k)). unfold site_at_3. simpl. rewrite F, B1, B2, B3, <- !S, <- !P.
  f_equal. generalize (x0 v) (d v) (L1 L0) (L2 L0) (L3 L0). vector.
Qed.

Lemma nearly_similar_linear rho Q E : rotation_3 Q -> linear_3 E -> linear_3 (nearly_similar_3 rho Q E).
Proof.
  intros ((P & S) & _) (P' & S'). unfold nearly_similar_3. split; intros.
  - rewrite P'. replace (u ⊕ v ⊕ (E u ⊕ E v)) with ((u ⊕ E u) ⊕ (v ⊕ E v)) by vector. rewrite P. vector.
  - rewrite S'. replace (k ⊙ u ⊕ k ⊙ E u) with (k ⊙ (u ⊕ E u)) by vector. rewrite S. vector.
Qed.

(* Whatever does not depend on similarities has a tolerance in the moving box. *)
Lemma moving_certificate_3 {I} (C : (I -> vec) -> Prop) rho Q E e c r s (y d : I -> vec) :
  rotation_3 Q -> small_3 e E -> 0 <= e ->
  (forall z t, C z -> C (fun i => t ⊕ rho ⊙ Q (z i))) ->
  (forall z, (forall i, norm (z i ⊖ y i) < s) -> C z) ->
  (forall i, norm (y i ⊖ c) <= r) -> (forall i, (1 + e) * norm (d i) + e * r < s) ->
  exists z, (forall i, nearly_similar_3 rho Q E (y i ⊕ d i) = z i) /\ C z.
Proof.
  intros ((P & S) & _) ((P' & S') & N) Pos Similar Tolerance Near Ways.
  pose (z i := y i ⊕ d i ⊕ E (d i) ⊕ E (y i ⊖ c)).
  exists (fun i => rho ⊙ Q (E c) ⊕ rho ⊙ Q (z i)). split.
  - intro i. unfold nearly_similar_3, z. rewrite P'. replace (y i ⊖ c) with (y i ⊕ (-1) ⊙ c) by vector. rewrite P', S'.
    replace (rho ⊙ Q (E c) ⊕ rho ⊙ Q (y i ⊕ d i ⊕ E (d i) ⊕ (E (y i) ⊕ (-1) ⊙ E c))) with (rho ⊙ Q (E c ⊕ (y i ⊕ d i ⊕ E (d i) ⊕ (E (y i) ⊕ (-1) ⊙ E c))))
      by (rewrite P; vector).
    f_equal. f_equal. vector.
  - apply Similar. apply Tolerance. intro i. unfold z.
    replace (y i ⊕ d i ⊕ E (d i) ⊕ E (y i ⊖ c) ⊖ y i) with (d i ⊕ E (d i) ⊕ E (y i ⊖ c)) by vector.
    assert (T := norm_add (d i ⊕ E (d i)) (E (y i ⊖ c))). assert (T' := norm_add (d i) (E (d i))).
    assert (N1 := N (d i)). assert (N2 := N (y i ⊖ c)). assert (e * norm (y i ⊖ c) <= e * r) by (apply Rmult_le_compat_l; trivial).
    generalize (Ways i). lra.
Qed.

Section similar.
Variables (rho : R) (Q : vec -> vec) (t : vec).
Hypothesis rotates : rotation_3 Q.

Lemma difference_turned u v : (t ⊕ rho ⊙ Q u) ⊖ (t ⊕ rho ⊙ Q v) = rho ⊙ Q (u ⊖ v).
Proof.
  destruct rotates as ((P & S) & _). replace (u ⊖ v) with (u ⊕ (-1) ⊙ v) by vector. rewrite P, S. generalize (Q u) (Q v). vector.
Qed.

Lemma vol_turned u v w : vol (rho ⊙ Q u) (rho ⊙ Q v) (rho ⊙ Q w) = rho ^ 3 * vol u v w.
Proof. destruct rotates as (_ & _ & D). rewrite <- (D u v w). generalize (Q u) (Q v) (Q w). vector. Qed.

Lemma sq_turned u : sq (rho ⊙ Q u) = rho ^ 2 * sq u.
Proof. destruct rotates as (_ & D & _). unfold sq at 2. rewrite <- (D u u). generalize (Q u). vector. Qed.

Variable y : bicell.placement.
Let y' : bicell.placement := fun i => t ⊕ rho ⊙ Q (y i).

Lemma rel_turned i : bicell.rel y' i = rho ⊙ Q (bicell.rel y i).
Proof. unfold bicell.rel, y'. apply difference_turned. Qed.

Lemma lambda_turned_p : bicell.lambda y' bicell.p = rho ^ 3 * bicell.lambda y bicell.p.
Proof. simpl. unfold bicell.lambda_p. now rewrite !rel_turned, vol_turned. Qed.

Lemma lambda_turned_q : bicell.lambda y' bicell.q = rho ^ 3 * bicell.lambda y bicell.q.
Proof. simpl. unfold bicell.lambda_q. rewrite !rel_turned, vol_turned. ring. Qed.

Lemma det_turned : bicell.det y' = rho ^ 5 * bicell.det y.
Proof.
  unfold bicell.det, bicell.lambda_b, bicell.lambda_c, bicell.lambda_p, bicell.lambda_q. rewrite !rel_turned, !vol_turned, !sq_turned. ring.
Qed.
End similar.

Definition sphere_holds (y : bicell.placement) : Prop := 0 < bicell.lambda y bicell.p -> 0 < bicell.lambda y bicell.q -> 0 < bicell.det y.

Lemma positive_factor k z : 0 < k -> 0 < k * z <-> 0 < z.
Proof. intro K. split; intro H; [|now apply Rmult_lt_0_compat]. apply Rmult_lt_reg_l with k; [exact K|]. lra. Qed.

Theorem sphere_in_moving_box_3 rho Q E e (x0 x d : nat -> vec) (L0 L : box_3) (site : bicell.vertex -> site_3) c r s :
  0 < rho -> rotation_3 Q -> 0 <= e -> small_3 e E ->
  box_follows_3 (nearly_similar_3 rho Q E) L0 L -> vertices_follow_3 (nearly_similar_3 rho Q E) d x0 x ->
  let y i := site_at_3 x0 L0 (site i) in
  (forall i, norm (y i ⊖ c) <= r) -> (forall i, (1 + e) * norm (d (fst (site i))) + e * r < s) ->
  (forall z, (forall i, norm (z i ⊖ y i) < s) -> sphere_holds z) -> sphere_holds (fun i => site_at_3 x L (site i)).
Proof.
  intros Pos R Pe Sm B F y Near Ways Tolerance.
  destruct (moving_certificate_3 sphere_holds rho Q E e c r s y (fun i => d (fst (site i)))) as (z & Z & H); trivial.
  - intros z t H. unfold sphere_holds. rewrite lambda_turned_p, lambda_turned_q, det_turned by exact R.
    assert (0 < rho ^ 3 /\ 0 < rho ^ 5) as (K & K') by (split; apply pow_lt, Pos). rewrite !positive_factor by assumption. exact H.
  - assert (S : forall i, site_at_3 x L (site i) = z i).
    { intro i. rewrite <- Z. apply sites_follow_3; trivial. now apply nearly_similar_linear; [|apply Sm]. }
    unfold sphere_holds, bicell.det, bicell.lambda, bicell.lambda_b, bicell.lambda_c, bicell.lambda_p, bicell.lambda_q, bicell.rel in *. rewrite !S. exact H.
Qed.

(* A linear map multiplies all volumes by one number. *)
Lemma linear_volumes A : linear_3 A -> exists k, forall u v w, vol (A u) (A v) (A w) = k * vol u v w.
Proof.
  intros (P & S). pose (e1 := V 1 0 0). pose (e2 := V 0 1 0). pose (e3 := V 0 0 1). exists (vol (A e1) (A e2) (A e3)).
  assert (D : forall u, A u = X1 u ⊙ A e1 ⊕ X2 u ⊙ A e2 ⊕ X3 u ⊙ A e3).
  { intro u. rewrite <- !S, <- !P. f_equal. unfold e1, e2, e3. vector. }
  intros u v w. rewrite (D u), (D v), (D w). generalize (A e1) (A e2) (A e3). vector.
Qed.

Theorem orientation_in_moving_box_3 A (x0 x d : nat -> vec) (L0 L : box_3) (site : tetrahedron.corner -> site_3) s :
  linear_3 A -> box_follows_3 A L0 L -> vertices_follow_3 A d x0 x -> 0 < det_3 L0 -> 0 < det_3 L ->
  (forall i, norm (d (fst (site i))) < s) ->
  (forall z, (forall i, norm (z i ⊖ site_at_3 x0 L0 (site i)) < s) -> 0 < tetrahedron.volume z) ->
  0 < tetrahedron.volume (fun i => site_at_3 x L (site i)).
Proof.
  intros Lin B F P0 P Ways Tolerance. destruct (linear_volumes A Lin) as (k & K).
  assert (Pk : 0 < k).
  { destruct B as (B1 & B2 & B3). unfold det_3 in *. rewrite B1, B2, B3, K in P. apply Rmult_lt_reg_r with (vol (L1 L0) (L2 L0) (L3 L0)); [exact P0|]. lra. }
  assert (T := Tolerance (fun i => site_at_3 x0 L0 (site i) ⊕ d (fst (site i)))).
  unfold tetrahedron.volume in *. rewrite !(sites_follow_3 A d x0 x L0 L _ Lin B F).
  assert (M : forall u v, A u ⊖ A v = A (u ⊖ v)).
  { intros u v. destruct Lin as (Pl & S). replace (u ⊖ v) with (u ⊕ (-1) ⊙ v) by vector. rewrite Pl, S. generalize (A u) (A v). vector. }
  rewrite !M, K. apply Rmult_lt_0_compat; [exact Pk|]. apply T. intro i.
  replace (site_at_3 x0 L0 (site i) ⊕ d (fst (site i)) ⊖ site_at_3 x0 L0 (site i)) with (d (fst (site i))) by vector. apply Ways.
Qed.

(* ---- In the plane ---- *)

Definition plus_2 (u v : point_2) : point_2 := (fst u + fst v, snd u + snd v).
Definition minus_2 (u v : point_2) : point_2 := (fst u - fst v, snd u - snd v).
Definition times_2 (k : R) (u : point_2) : point_2 := (k * fst u, k * snd u).
Definition length_2 (u : point_2) : R := sqrt (fst u * fst u + snd u * snd u).
Definition linear_2 (f : point_2 -> point_2) : Prop := (forall u v, f (plus_2 u v) = plus_2 (f u) (f v)) /\ (forall k u, f (times_2 k u) = times_2 k (f u)).
Definition small_2 (e : R) (E : point_2 -> point_2) : Prop := linear_2 E /\ forall u, length_2 (E u) <= e * length_2 u.
(* Rotation and scaling: the product with the complex number m. *)
Definition turned_by (m u : point_2) : point_2 := (fst m * fst u - snd m * snd u, snd m * fst u + fst m * snd u).
(* A similarity, but for E. *)
Definition nearly_similar_2 (m : point_2) (E : point_2 -> point_2) (u : point_2) : point_2 := turned_by m (plus_2 u (E u)).
Definition box_follows_2 (A : point_2 -> point_2) (L0 L : box_2) : Prop := fst L = A (fst L0) /\ snd L = A (snd L0).
Definition vertices_follow_2 (A : point_2 -> point_2) (d x0 x : nat -> point_2) : Prop := forall v, x v = A (plus_2 (x0 v) (d v)).

Ltac pairs := unfold plus_2, minus_2, times_2, turned_by; cbn [fst snd].
Ltac plane := intros; pairs; apply injective_projections; cbn [fst snd]; ring.

Lemma length_plus u v : length_2 (plus_2 u v) <= length_2 u + length_2 v.
Proof.
  assert (E : forall w, length_2 w = norm (V (fst w) (snd w) 0)) by (intro w; unfold length_2, norm; f_equal; unfold sq, dot; simpl; ring).
  rewrite !E. replace (V (fst (plus_2 u v)) (snd (plus_2 u v)) 0) with (V (fst u) (snd u) 0 ⊕ V (fst v) (snd v) 0); [apply norm_add|].
  apply vec_eq; simpl; ring.
Qed.

Lemma site_at_sum x L v i j : site_at x L (v, (i, j)) = plus_2 (x v) (plus_2 (times_2 (IZR i) (fst L)) (times_2 (IZR j) (snd L))).
Proof. destruct L as ((a, b), (c, d)). simpl. pairs. f_equal; ring. Qed.

Lemma sites_follow_2 A d x0 x L0 L s : linear_2 A -> box_follows_2 A L0 L -> vertices_follow_2 A d x0 x ->
  site_at x L s = A (plus_2 (site_at x0 L0 s) (d (fst s))).
Proof.
  intros (P & S) (B1 & B2) F. destruct s as (v, (i, j)). rewrite !site_at_sum, F, B1, B2, <- !S, <- !P. cbn [fst].
  f_equal. plane.
Qed.

Lemma nearly_similar_linear_2 m E : linear_2 E -> linear_2 (nearly_similar_2 m E).
Proof. intros (P & S). unfold nearly_similar_2. split; intros; [rewrite P|rewrite S]; plane. Qed.

Lemma circle_turned m t y a b p q : incircle_at (fun v : nat => plus_2 t (turned_by m (y v))) a b p q = (fst m * fst m + snd m * snd m) ^ 2 * incircle_at y a b p q.
Proof. unfold incircle_at, incircle, turn. pairs. ring. Qed.

Lemma turn_turned m t y a b c : turn_at (fun v : nat => plus_2 t (turned_by m (y v))) a b c = (fst m * fst m + snd m * snd m) * turn_at y a b c.
Proof. unfold turn_at, turning, turn. pairs. ring. Qed.

(* The points of an edge a b with q on its left and p on its right, by number. *)
Definition circle_holds (y : nat -> point_2) : Prop := 0 < turn_at y 0 1 3 -> 0 < turn_at y 1 0 2 -> 0 < incircle_at y 0 1 2 3.

Theorem circle_in_moving_box_2 m E e (x0 x d : nat -> point_2) (L0 L : box_2) (site : nat -> site_2) c r s :
  m <> (0, 0) -> 0 <= e -> small_2 e E ->
  box_follows_2 (nearly_similar_2 m E) L0 L -> vertices_follow_2 (nearly_similar_2 m E) d x0 x ->
  let y i := site_at x0 L0 (site i) in
  (forall i, (i < 4)%nat -> length_2 (minus_2 (y i) c) <= r) -> (forall i, (i < 4)%nat -> (1 + e) * length_2 (d (fst (site i))) + e * r < s) ->
  (forall z, (forall i, (i < 4)%nat -> length_2 (minus_2 (z i) (y i)) < s) -> circle_holds z) -> circle_holds (fun i => site_at x L (site i)).
Proof.
  intros M Pe (Lin & N) B F y Near Ways Tolerance. assert (Lin' := Lin). destruct Lin' as (P' & S').
  pose (w i := d (fst (site i))).
  pose (z i := plus_2 (plus_2 (plus_2 (y i) (w i)) (E (w i))) (E (minus_2 (y i) c))).
  assert (Es : forall i, site_at x L (site i) = plus_2 (turned_by m (E c)) (turned_by m (z i))).
  { intro i. rewrite (sites_follow_2 (nearly_similar_2 m E) d x0 x L0 L (site i)) by (trivial; now apply nearly_similar_linear_2).
    fold (y i) (w i). unfold nearly_similar_2, z. rewrite P'. replace (minus_2 (y i) c) with (plus_2 (y i) (times_2 (-1) c)) by plane.
    rewrite P', S'. plane. }
  assert (K : 0 < fst m * fst m + snd m * snd m).
  { destruct m as (u, v). simpl. destruct (Req_dec u 0) as [U|U], (Req_dec v 0) as [U'|U']; try nra. elim M. congruence. }
  assert (H : circle_holds z).
  { apply Tolerance. intros i I. unfold z. replace (minus_2 (plus_2 (plus_2 (plus_2 (y i) (w i)) (E (w i))) (E (minus_2 (y i) c))) (y i))
      with (plus_2 (plus_2 (w i) (E (w i))) (E (minus_2 (y i) c))) by plane.
    assert (T := length_plus (plus_2 (w i) (E (w i))) (E (minus_2 (y i) c))). assert (T' := length_plus (w i) (E (w i))).
    assert (N1 := N (w i)). assert (N2 := N (minus_2 (y i) c)). assert (e * length_2 (minus_2 (y i) c) <= e * r) by (apply Rmult_le_compat_l; [exact Pe|now apply Near]).
    generalize (Ways i I). unfold w in *. lra. }
  assert (G : circle_holds (fun i => plus_2 (turned_by m (E c)) (turned_by m (z i)))).
  { unfold circle_holds in *. rewrite !turn_turned, circle_turned. rewrite !positive_factor; trivial. now apply pow_lt. }
  unfold circle_holds, turn_at, incircle_at in *. rewrite !Es. exact G.
Qed.

Lemma linear_areas A : linear_2 A -> exists k, forall u v w, turning (A u) (A v) (A w) = k * turning u v w.
Proof.
  intros (P & S). pose (e1 := (1, 0)). pose (e2 := (0, 1)). exists (turning (0, 0) (A e1) (A e2)).
  assert (D : forall u, A u = plus_2 (times_2 (fst u) (A e1)) (times_2 (snd u) (A e2))).
  { intro u. rewrite <- !S, <- !P. f_equal. unfold e1, e2. plane. }
  intros u v w. rewrite (D u), (D v), (D w). generalize (A e1) (A e2). intros. unfold turning, turn. pairs. ring.
Qed.

Theorem orientation_in_moving_box_2 A (x0 x d : nat -> point_2) (L0 L : box_2) (site : nat -> site_2) s :
  linear_2 A -> box_follows_2 A L0 L -> vertices_follow_2 A d x0 x -> 0 < det_2 L0 -> 0 < det_2 L ->
  (forall i, (i < 3)%nat -> length_2 (d (fst (site i))) < s) ->
  (forall z, (forall i, (i < 3)%nat -> length_2 (minus_2 (z i) (site_at x0 L0 (site i))) < s) -> 0 < turn_at z 0 1 2) ->
  0 < turn_at (fun i => site_at x L (site i)) 0 1 2.
Proof.
  intros Lin B F P0 P Ways Tolerance. destruct (linear_areas A Lin) as (k & K).
  assert (Pk : 0 < k).
  { destruct B as (B1 & B2). apply Rmult_lt_reg_r with (det_2 L0); [exact P0|]. replace (k * det_2 L0) with (det_2 L); [lra|].
    assert (Z : A (0, 0) = (0, 0)) by (replace (0, 0) with (times_2 0 (0, 0)) at 1 by plane; rewrite (proj2 Lin); plane).
    generalize (K (0, 0) (fst L0) (snd L0)). rewrite Z, <- B1, <- B2. unfold det_2, turning, turn. cbn [fst snd]. lra. }
  assert (T := Tolerance (fun i => plus_2 (site_at x0 L0 (site i)) (d (fst (site i))))).
  unfold turn_at in *. rewrite !(sites_follow_2 A d x0 x L0 L _ Lin B F), K. apply Rmult_lt_0_compat; [exact Pk|]. apply T. intros i I.
  replace (minus_2 (plus_2 (site_at x0 L0 (site i)) (d (fst (site i)))) (site_at x0 L0 (site i))) with (d (fst (site i))) by plane. now apply Ways.
Qed.
