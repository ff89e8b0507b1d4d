(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Error bounds of the terms of width_terms_3.h: the constants of bounds.h for space, and that smaller ones are refused. *)
Require Import Reals Lra Psatz ZArith List.
From Flocq Require Import Core.
From Annulus Require Import float_model float_error_sound float_filter float_terms_3.
Import ListNotations.
Open Scope R_scope.

Definition coordinates {T} (v : vector T) : list T := [x v; y v; z v].
Definition all_coordinates {T} (l : list (vector T)) : list T := concat (map coordinates l).

(* Magnitudes that the tree of operations does not show: in N_1 = U_p + U_q the terms |q|^2 (b x c) - |p|^2 (b x c) are at most
   3 m^2 2 m^2 together, and so in N_4. That makes 30 m^4 of 36. *)
Definition three_squares : Z := 3 * prod exact_one exact_one.
Definition thirty : Z := 5 * prod three_squares two_products.
Definition hints_3 : hints := map (fun e => (e, thirty)) (all_coordinates [n1 E_bicell; n4 E_bicell]).

Definition within (k : nat) (C E : Z) (e : expr) : bool := error_below hints_3 e k (C * one) (C * one) (E * half_u).

(* In halves of u, half a u below bounds.h: 47, 35, 1105, 691, 1183, 169. *)
Lemma constants_slabs : forallb (within 2 16 69) (all_coordinates (E_slabs ++ slabs_p E_bicell ++ slabs_q E_bicell)) = true.
Proof. vm_compute. reflexivity. Qed.
Lemma constants_cells : forallb (within 3 8 93) [E_tetrahedron; cell_p E_bicell; cell_q E_bicell] = true.
Proof. vm_compute. reflexivity. Qed.
Lemma constants_determinant : within 5 128 2209 (determinant E_bicell) = true.
Proof. vm_compute. reflexivity. Qed.
Lemma constants_sides : forallb (within 3 32 337) [l1 E_bicell; l2 E_bicell; l3 E_bicell; minus_l4 E_bicell] = true.
Proof. vm_compute. reflexivity. Qed.
Lemma constants_n : forallb (within 4 64 1381) (all_coordinates [n1 E_bicell; n2 E_bicell; n3 E_bicell; n4 E_bicell]) = true.
Proof. vm_compute. reflexivity. Qed.
Lemma constants_m : forallb (within 4 128 2365) (all_coordinates [m1 E_bicell; m2 E_bicell; m3 E_bicell; m4 E_bicell]) = true.
Proof. vm_compute. reflexivity. Qed.

(* The least integers that this analysis proves, in u. *)
Lemma constants_3_least :
  map (least_error hints_3) [x (nth 3 E_slabs (E_vector 0)); E_tetrahedron; determinant E_bicell; l1 E_bicell; l2 E_bicell;
                             x (n1 E_bicell); x (n2 E_bicell); x (m1 E_bicell); x (m2 E_bicell)]
  = map Some [35; 47; 1105; 105; 169; 439; 691; 749; 1183]%Z.
Proof. vm_compute. reflexivity. Qed.

Section hints.
Variable m : R.
Hypothesis m_large : bpow radix2 (-120) <= m.
Variable X : nat -> R.
Hypothesis X_small : forall n, Rabs (X n) <= IZR exact_one * scale m 1.

Lemma combination_small s c bb cc pp qq cq cp bq bp bc :
  0 <= bb <= s -> 0 <= cc <= s -> 0 <= pp <= s -> 0 <= qq <= s ->
  Rabs cq <= c -> Rabs cp <= c -> Rabs bq <= c -> Rabs bp <= c -> Rabs bc <= c ->
  Rabs (((bb * cq - cc * bq) + qq * bc) - ((bb * cp - cc * bp) + pp * bc)) <= 5 * (s * c).
Proof.
  intros B C P Q H1 H2 H3 H4 H5.
  assert (K : forall a t, 0 <= a <= s -> Rabs t <= c -> - (s * c) <= a * t <= s * c).
  { intros a t A T. apply Rabs_le_inv. rewrite Rabs_mult, (Rabs_pos_eq a) by apply A.
    apply Rmult_le_compat; try apply A; [apply Rabs_pos | exact T]. }
  assert (D : - (s * c) <= (qq - pp) * bc <= s * c).
  { apply Rabs_le_inv. rewrite Rabs_mult. apply Rmult_le_compat; try apply Rabs_pos; [apply Rabs_le; lra | exact H5]. }
  generalize (K bb cq B H1) (K cc bq C H3) (K bb cp B H2) (K cc bp C H4). intros. apply Rabs_le. lra.
Qed.

Lemma combination_small' s c bb cc pp qq pq cq cp bq bp :
  0 <= bb <= s -> 0 <= cc <= s -> 0 <= pp <= s -> 0 <= qq <= s ->
  Rabs pq <= c -> Rabs cq <= c -> Rabs cp <= c -> Rabs bq <= c -> Rabs bp <= c ->
  Rabs (((cc * pq - pp * cq) + qq * cp) - ((bb * pq - pp * bq) + qq * bp)) <= 5 * (s * c).
Proof.
  intros. replace (((cc * pq - pp * cq) + qq * cp) - ((bb * pq - pp * bq) + qq * bp))
    with (((qq * cp - pp * cq) + cc * pq) - ((qq * bp - pp * bq) + bb * pq)) by ring.
  now apply combination_small.
Qed.

Lemma hints_3_hold : hints_hold m X hints_3.
Proof.
  set (V := IZR exact_one * scale m 1) in *.
  assert (VV : V * V <= IZR (prod exact_one exact_one) * scale m 2).
  { apply (prod_le m m_large exact_one exact_one 1 1); split; try apply Rle_refl;
      apply Rle_trans with (2 := X_small 0); apply Rabs_pos. }
  assert (P2 : forall i j, Rabs (X i * X j) <= IZR (prod exact_one exact_one) * scale m 2).
  { intros i j. rewrite Rabs_mult. apply Rle_trans with (2 := VV). apply Rmult_le_compat; auto using Rabs_pos. }
  assert (C : forall i j k l, Rabs (X i * X j - X k * X l) <= IZR two_products * scale m 2).
  { intros i j k l. unfold two_products. rewrite mult_IZR. generalize (P2 i j) (P2 k l). intros A B.
    generalize (Rabs_triang (X i * X j) (- (X k * X l))). rewrite Rabs_Ropp. unfold Rminus. lra. }
  assert (S : forall i j k, 0 <= X i * X i + X j * X j + X k * X k <= IZR three_squares * scale m 2).
  { intros i j k. unfold three_squares. rewrite mult_IZR.
    assert (Q : forall n, 0 <= X n * X n <= IZR (prod exact_one exact_one) * scale m 2).
    { intro n. split; [apply Rle_0_sqr |]. rewrite <- (Rabs_pos_eq (X n * X n)) by apply Rle_0_sqr. apply P2. }
    generalize (Q i) (Q j) (Q k). lra. }
  assert (T : 5 * ((IZR three_squares * scale m 2) * (IZR two_products * scale m 2)) <= IZR thirty * scale m 4).
  { unfold thirty. rewrite mult_IZR, (Rmult_assoc 5 (IZR (prod three_squares two_products))). apply Rmult_le_compat_l; [lra |].
    apply (prod_le m m_large three_squares two_products 2 2); split; try apply Rle_refl.
    - apply Rle_trans with (2 := proj2 (S 0%nat 0%nat 0%nat)). apply S.
    - apply Rle_trans with (2 := C 0%nat 0%nat 0%nat 0%nat). apply Rabs_pos. }
  assert (degree : forall e k, (match bound hints_3 e with Some b => deg b = k | None => False end) ->
    forall b, bound hints_3 e = Some b -> deg b = k) by (intros e k H b Q; now rewrite Q in H).
  assert (plain : forall e, Rabs (exact X e) <= IZR thirty * scale m 4 ->
    (match bound hints_3 e with Some b => deg b = 4%nat | None => False end) ->
    forall b, bound hints_3 e = Some b -> Rabs (exact X e) <= IZR thirty * scale m (deg b)).
  { intros e H D b Q. now rewrite (degree e 4%nat D b Q). }
  unfold hints_hold, hints_3, all_coordinates, coordinates. cbn [map concat app]. each; cbn [fst snd];
    (apply plain; [| vm_compute; reflexivity]);
    apply Rle_trans with (2 := T).
  1-3: apply (combination_small (IZR three_squares * scale m 2) (IZR two_products * scale m 2));
       first [apply S | apply C].
  all: apply (combination_small' (IZR three_squares * scale m 2) (IZR two_products * scale m 2));
       first [apply S | apply C].
Qed.
End hints.
