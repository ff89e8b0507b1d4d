(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Floating point and geometry together in space: a tolerance returned by the filter stage certifies. Over rounded reals; returned_3.v says the
   same of primitive floats.

   - filter_certifies_tetrahedron   an answer 1 with tolerance v: the tetrahedron is positive at every placement in which each
                                    point is closer than v to where it was
   - filter_certifies_sphere        the same of an empty sphere whose cells are positive at the reference and at the placement
   - filter_certifies_bicell        with `always`: nothing is required of the cells at the placement, they are positive there too

   A placement gives each vertex its point. Nothing about rounding is left to believe but that the code computes these filters. *)
Require Import Reals Lra ZArith List Bool.
From Annulus Require Import vectors bicell tetrahedron sign_tolerance_3.
From Annulus Require float_terms_3 float_width_3 float_filter_3 float_sphere_3 float_bicell_3 float_filter.
Open Scope R_scope.

Module T := float_terms_3.
Module W := float_width_3.
Module S := float_sphere_3.

(* A point, or a difference, as the filter takes it. *)
Definition numbers (u : vec) : T.vector R := T.Vector (X1 u) (X2 u) (X3 u).
Definition F_numbers (u : vec) : Prop := float_filter_3.F_point (numbers u).

Lemma norm_is u : W.R_norm (numbers u) = norm u.
Proof. reflexivity. Qed.
Lemma norm_minus u : norm ((-1) ⊙ u) = norm u.
Proof. apply norm_of_sq. vector. Qed.

(* ---- Terms of the code are numbers of the geometry ---- *)

Section bicell.
Variable x : placement.
Let t := T.R_bicell (numbers (rel x b)) (numbers (rel x c)) (numbers (rel x p)) (numbers (rel x q)).

Lemma truth_is : S.bicell_truth (numbers (x a)) (numbers (x b)) (numbers (x c)) (numbers (x p)) (numbers (x q)) = t.
Proof. reflexivity. Qed.

(* The terms as they are computed, in the operations of geometry. *)
Let B := rel x b. Let C := rel x c. Let P := rel x p. Let Q := rel x q.

Ltac componentwise := unfold numbers, T.combination, T.vadd, T.vsub, T.minus_twice; coordinates; cbn [T.x T.y T.z]; f_equal; ring.

Lemma combination_is u v w : T.combination R Rplus Rminus Rmult (sq u) (numbers (v ✕ w)) (sq v) (numbers (u ✕ w)) (sq w) (numbers (u ✕ v)) =
  numbers (twice_centre u v w).
Proof.
  unfold twice_centre. generalize (sq u) (sq v) (sq w). destruct u, v, w. intros. componentwise.
Qed.
Lemma minus_is u v : T.vsub R Rminus (numbers u) (numbers v) = numbers (u ⊕ (-1) ⊙ v).
Proof. destruct u, v. componentwise. Qed.
Lemma minus_twice_is D i : T.minus_twice R Rplus Rminus Rmult (numbers (N x D)) (Lam x D) (numbers (rel x i)) = numbers (arm x D i).
Proof. unfold arm. generalize (N x D) (Lam x D) (rel x i). intros. componentwise. Qed.
Lemma third_is : vol B Q P = lambda_c x.
Proof. unfold lambda_c. fold B P Q. generalize B P Q. vector. Qed.

Lemma determinant_is : T.determinant t = det x.
Proof.
  change (T.determinant t) with (vol C P Q * sq B + vol B Q P * sq C + (vol B C Q * sq P - vol B C P * sq Q)).
  rewrite third_is. unfold det, lambda_b, lambda_p, lambda_q. fold B C P Q. ring.
Qed.
Lemma cells_are : T.cell_p t = lambda x q /\ T.cell_q t = lambda x p. Proof. now split. Qed.
Lemma l1_is : T.l1 t = Lam x pq.
Proof. change (T.l1 t) with (vol B C Q - vol B C P). rewrite (proj1 (abc_pq x)). unfold lambda_p, lambda_q. fold B C P Q. ring. Qed.
Lemma sides_are : T.l2 t = Lam x cpq /\ T.l3 t = Lam x bpq /\ T.minus_l4 t = Lam x apq.
Proof.
  change (T.l2 t) with (T.l1 t + vol B Q P). change (T.l3 t) with (T.l1 t + lambda_b x). change (T.minus_l4 t) with (- (lambda_b x + vol B Q P)).
  rewrite l1_is, third_is, (proj1 (abc_pq x)), (proj1 (ab_cpq x)), (proj1 (ca_bpq x)), (proj1 (bc_apq x)). repeat split; ring.
Qed.

Lemma arms_pq : T.n1 t = numbers (N x pq) /\ T.m1 t = numbers (arm x pq p).
Proof.
  assert (E : T.n1 t = numbers (N x pq)).
  { rewrite (proj2 (abc_pq x)). unfold U_p, U_q. rewrite <- minus_is, <- !combination_is. reflexivity. }
  split; [exact E|]. change (T.m1 t) with (T.minus_twice R Rplus Rminus Rmult (T.n1 t) (T.l1 t) (numbers P)).
  rewrite E, l1_is. apply minus_twice_is.
Qed.
Lemma arms_cpq : T.n2 t = numbers (N x cpq) /\ T.m2 t = numbers (arm x cpq c).
Proof.
  assert (E : T.n2 t = numbers (N x cpq)).
  { transitivity (numbers (N x pq ⊕ U_c x)).
    - unfold U_c. rewrite <- minus_is, <- (proj1 arms_pq), <- combination_is. reflexivity.
    - rewrite (proj2 (abc_pq x)), (proj2 (ab_cpq x)). f_equal. generalize (U_p x) (U_q x) (U_c x). vector. }
  split; [exact E|]. change (T.m2 t) with (T.minus_twice R Rplus Rminus Rmult (T.n2 t) (T.l2 t) (numbers C)).
  rewrite E, (proj1 sides_are). apply minus_twice_is.
Qed.
Lemma arms_bpq : T.n3 t = numbers (N x bpq) /\ T.m3 t = numbers (arm x bpq b).
Proof.
  assert (E : T.n3 t = numbers (N x bpq)).
  { transitivity (T.vadd R Rplus (numbers (N x pq)) (numbers (U_b x))).
    - unfold U_b. rewrite <- (proj1 arms_pq), <- combination_is. reflexivity.
    - rewrite (proj2 (abc_pq x)), (proj2 (ca_bpq x)). generalize (U_p x) (U_q x) (U_b x). intros. componentwise. }
  split; [exact E|]. change (T.m3 t) with (T.minus_twice R Rplus Rminus Rmult (T.n3 t) (T.l3 t) (numbers B)).
  rewrite E, (proj1 (proj2 sides_are)). apply minus_twice_is.
Qed.
Lemma arms_apq : T.n4 t = numbers ((-1) ⊙ N x apq) /\ T.m4 t = numbers ((-1) ⊙ arm x apq b).
Proof.
  assert (E : T.n4 t = numbers ((-1) ⊙ N x apq)).
  { transitivity (numbers (U_b x ⊕ U_c x)).
    - unfold U_b, U_c. rewrite <- minus_is, <- !combination_is. reflexivity.
    - rewrite (proj2 (bc_apq x)). f_equal. generalize (U_b x) (U_c x). vector. }
  split; [exact E|]. change (T.m4 t) with (T.minus_twice R Rplus Rminus Rmult (T.n4 t) (lambda_b x + vol B Q P) (numbers B)).
  rewrite E, third_is. unfold arm. rewrite (proj1 (bc_apq x)). fold B. generalize (N x apq) (lambda_b x) (lambda_c x) B.
  intros. componentwise.
Qed.
End bicell.

Lemma root_of_largest l : sqrt (W.largest T.R_square l) = fold_right (fun v r => Rmax (W.R_norm v) r) 0 l.
Proof.
  induction l as [|v l IH]; [apply sqrt_0|]. cbn [W.largest fold_right]. rewrite W.sqrt_max. fold (W.largest T.R_square l). now rewrite IH.
Qed.

Lemma slabs_are (y : corners) : let u' := y u ⊖ y o in let v' := y v ⊖ y o in let w' := y w ⊖ y o in
  sqrt (W.largest T.R_square (T.slabs R Rplus (numbers (u' ✕ v')) (numbers (v' ✕ w')) (numbers (w' ✕ u')))) = largest y.
Proof.
  intros. rewrite root_of_largest. unfold T.slabs, largest. fold u' v' w'. cbn [fold_right].
  assert (E : forall m n : vec, T.vadd R Rplus (numbers m) (numbers n) = numbers (m ⊕ n)) by (intros [? ? ?] [? ? ?]; reflexivity).
  rewrite !E, !norm_is. set (A := u' ✕ v'). set (B := v' ✕ w'). set (C := w' ✕ u').
  rewrite (Rmax_left (norm (B ⊕ C)) 0) by apply norm_nonneg.
  apply Rle_antisym; repeat apply Rmax_lub; leaf.
Qed.

Section cells.
Variable x : placement.
Let t := S.bicell_truth (numbers (x a)) (numbers (x b)) (numbers (x c)) (numbers (x p)) (numbers (x q)).

Lemma slabs_p_are : sqrt (W.largest T.R_square (T.slabs_p t)) = largest (cell_p x).
Proof.
  rewrite <- slabs_are. f_equal. f_equal. unfold t. rewrite truth_is. unfold T.R_bicell, T.bicell_terms. cbn [T.slabs_p].
  cbv zeta. f_equal; unfold numbers, T.vopp, T.cross, cell_p, corner_p, rel; cbn [T.x T.y T.z];
    generalize (x a) (x b) (x c) (x p); intros [? ? ?] [? ? ?] [? ? ?] [? ? ?]; coordinates; f_equal; ring.
Qed.
Lemma slabs_q_are : sqrt (W.largest T.R_square (T.slabs_q t)) = largest (cell_q x).
Proof.
  rewrite <- slabs_are. f_equal. f_equal. unfold t. rewrite truth_is. unfold T.R_bicell, T.bicell_terms. cbn [T.slabs_q].
  cbv zeta. f_equal; unfold numbers, T.vopp, T.cross, cell_q, corner_q, rel; cbn [T.x T.y T.z];
    generalize (x a) (x b) (x c) (x q); intros [? ? ?] [? ? ?] [? ? ?] [? ? ?]; coordinates; f_equal; ring.
Qed.
End cells.

(* ---- Tetrahedron ---- *)

Definition tetrahedron_filter (x : corners) : option (Z * R) :=
  float_filter_3.orientation_filter_3 (numbers (x o)) (numbers (x u)) (numbers (x v)) (numbers (x w)) true.

Lemma tetrahedron_sound (x : corners) : (forall k, F_numbers (x k)) ->
  float_filter.sound (tetrahedron_filter x) true (volume x) (2 * largest x).
Proof.
  intro F. rewrite <- slabs_are. exact (float_filter_3.orientation_filter_3_sound _ _ _ _ true (F o) (F u) (F v) (F w)).
Qed.

Theorem filter_certifies_tetrahedron (x y : corners) tolerance : (forall k, F_numbers (x k)) ->
  tetrahedron_filter x = Some (1%Z, tolerance) -> (forall k, norm (y k ⊖ x k) < tolerance) -> 0 < volume y.
Proof.
  intros F A Near. destruct (tetrahedron_sound x F _ _ A) as [(_ & D & C)|(N & _)]; [|discriminate].
  exact (orientation_tolerance x y tolerance D (proj2 (C eq_refl)) Near).
Qed.

(* ---- Empty sphere ---- *)

Section sphere.
Variable x : placement.
Hypothesis F : forall k, F_numbers (x k).
Definition sphere_filter (use : S.cells) : option (Z * R) :=
  S.bicell_filter (numbers (x a)) (numbers (x b)) (numbers (x c)) (numbers (x p)) (numbers (x q)) true use.
Definition sphere_needs (use : S.cells) : bool :=
  S.cells_needed (numbers (x a)) (numbers (x b)) (numbers (x c)) (numbers (x p)) (numbers (x q)) use.

(* A sign is right, a tolerance at most the half width of the annuli and, where they are needed, of the cells. *)
Theorem sphere_sound use sign tolerance : sphere_filter use = Some (sign, tolerance) ->
  sign = 1%Z /\ 0 < det x /\ 0 <= tolerance <= annuli_half_width x /\ (sphere_needs use = true -> tolerance <= cells_half_width x) \/
  sign = (-1)%Z /\ det x < 0.
Proof.
  intro A. generalize (float_bicell_3.bicell_answer_sound _ _ _ _ _ true use (F a) (F b) (F c) (F p) (F q) _ _ A).
  assert (P := slabs_p_are x). assert (Q := slabs_q_are x). rewrite truth_is in *. rewrite determinant_is. intros [(E & D & _ & C)|N]; [left|now right].
  destruct (C eq_refl) as (C0 & C1 & C2 & C3 & C4 & CC). repeat (split; [assumption|]). split; [split; [exact C0|]|].
  - rewrite (proj1 (arms_pq x)), (proj2 (arms_pq x)) in C1. rewrite (proj1 (arms_cpq x)), (proj2 (arms_cpq x)) in C2.
    rewrite (proj1 (arms_bpq x)), (proj2 (arms_bpq x)) in C3. rewrite (proj1 (arms_apq x)), (proj2 (arms_apq x)) in C4.
    rewrite !norm_is in *. rewrite !norm_minus in C4.
    unfold annuli_half_width, half_width, arms. rewrite !arm_a, (Rplus_comm (norm (arm x apq b))).
    repeat apply Rmin_glb; assumption.
  - intro Need. destruct (CC Need) as (P' & Q'). rewrite P in P'. rewrite Q in Q'.
    rewrite (proj1 (cells_are x)) in P'. rewrite (proj2 (cells_are x)) in Q'.
    unfold cells_half_width, half_width_simplex. rewrite volume_p, volume_q. now apply Rmin_glb.
Qed.

(* Where the cells are left out every partition is certainly the right way round. *)
Lemma forward sign tolerance : sphere_filter S.where_needed = Some (sign, tolerance) -> sphere_needs S.where_needed = false ->
  0 < Lam x cpq /\ 0 < Lam x bpq /\ 0 < Lam x apq.
Proof.
  intros A Need.
  assert (I : float_filter.in_range 100 (S.bicell_m (numbers (x a)) (numbers (x b)) (numbers (x c)) (numbers (x p)) (numbers (x q)))).
  { unfold sphere_filter, S.bicell_filter in A. destruct (float_filter.in_range_dec 100 _) as [I|]; [exact I|discriminate]. }
  destruct (float_bicell_3.bicell_filter_sound _ _ _ _ _ true S.where_needed (F a) (F b) (F c) (F p) (F q) I) as (_ & B2 & B3 & B4).
  rewrite truth_is in B2, B3, B4. destruct (sides_are x) as (L2 & L3 & L4). rewrite L2 in B2. rewrite L3 in B3. rewrite L4 in B4.
  unfold sphere_needs, S.cells_needed in Need. apply orb_false_elim in Need. destruct Need as [Need N4]. apply orb_false_elim in Need.
  destruct Need as [N2 N3]. auto.
Qed.

Lemma where_needed_own sign tolerance : sphere_filter S.where_needed = Some (sign, tolerance) ->
  sign = 1%Z -> tolerance <= own_tolerance_3 x.
Proof.
  intros A E. destruct (sphere_sound _ _ _ A) as [(_ & _ & (_ & An) & C)|(N & _)]; [|congruence].
  unfold own_tolerance_3. destruct Rle_dec as [L|L]; [exact An|]. unfold tolerance_3. apply Rmin_glb; [exact An|].
  destruct (sphere_needs S.where_needed) eqn:Need; [auto|]. exfalso. apply L.
  destruct (forward _ _ A Need) as (? & ? & ?). repeat apply Rmin_glb; lra.
Qed.

Theorem filter_certifies_sphere tolerance (y : placement) : sphere_filter S.where_needed = Some (1%Z, tolerance) ->
  0 < lambda x p -> 0 < lambda x q -> 0 < lambda y p -> 0 < lambda y q ->
  (forall k, norm (y k ⊖ x k) < tolerance) -> 0 < det y.
Proof.
  intros A Xp Xq Yp Yq Near. destruct (sphere_sound _ _ _ A) as [(_ & D & _)|(N & _)]; [|discriminate].
  apply (sign_tolerance_3_own x y tolerance Near Xp Xq D Yp Yq). now apply where_needed_own with (1 := A).
Qed.

Theorem filter_certifies_bicell tolerance (y : placement) : sphere_filter S.always = Some (1%Z, tolerance) ->
  0 < lambda x p -> 0 < lambda x q -> (forall k, norm (y k ⊖ x k) < tolerance) -> 0 < det y /\ 0 < lambda y p /\ 0 < lambda y q.
Proof.
  intros A Xp Xq Near. destruct (sphere_sound _ _ _ A) as [(_ & D & (_ & An) & C)|(N & _)]; [|discriminate].
  apply (sign_tolerance_3 x y tolerance Near Xp Xq D). apply Rmin_glb; [exact An|now apply C].
Qed.
End sphere.
