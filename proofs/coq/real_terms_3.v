(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* real_terms_2.v in space: the formulas of the code over the reals (filter_3.v) are numbers of the geometry.

   - tetrahedron_half, annuli_are, cells_half    determinants and half widths *)
From Coq Require Import Reals Lra ZArith List.
From Annulus Require float_width_3 float_certifies_3.
From Annulus Require Import operations filter_2 filter_3 connect_3 integers_2 integers_3 vectors bicell tetrahedron sign_tolerance_3.
Import ListNotations filter_3.   (* last: the terms of the code have the names of partitions *)
Open Scope R_scope.

Module C := float_certifies_3.
Notation half := integers_2.half_width.
Definition to_reals (u : vec) : vector_3 reals := {| x3 := X1 u : number reals; y3 := X2 u : number reals; z3 := X3 u : number reals |}.

(* ---- A tetrahedron ---- *)

Lemma slab_root (y : corners) : let u' := y u ⊖ y o in let v' := y v ⊖ y o in let w' := y w ⊖ y o in
  0 <= largest_slab reals (to_reals (u' ✕ v')) (to_reals (v' ✕ w')) (to_reals (w' ✕ u')) /\
  R_sqrt.sqrt (largest_slab reals (to_reals (u' ✕ v')) (to_reals (v' ✕ w')) (to_reals (w' ✕ u'))) = largest y.
Proof.
  intros. unfold largest. fold u' v' w'. set (A := u' ✕ v'). set (B := v' ✕ w'). set (D := w' ✕ u').
  assert (S : forall m, square_3 reals (to_reals m) = sq m) by reflexivity.
  assert (P : forall m n, plus_3 reals (to_reals m) (to_reals n) = to_reals (m ⊕ n)) by reflexivity.
  unfold largest_slab. cbv zeta. rewrite !P, !S. change (greater reals) with Rmax.
  split; [apply Rle_trans with (1 := sq_nonneg A); leaf|]. rewrite !float_width_3.sqrt_max. fold (norm A) (norm B) (norm D).
  fold (norm (A ⊕ B ⊕ D)) (norm (D ⊕ A)) (norm (A ⊕ B)) (norm (B ⊕ D)). apply Rle_antisym; repeat apply Rmax_lub; leaf.
Qed.

Section tetrahedron.
Variable y : corners.
Let t := orientation_terms_3 reals (to_reals (y u ⊖ y o)) (to_reals (y v ⊖ y o)) (to_reals (y w ⊖ y o)).

Theorem tetrahedron_half : determinant _ t = volume y /\ 0 <= inner _ t /\ 0 <= outer _ t /\
  (0 < volume y -> half t = half_width_simplex y /\ 0 < R_sqrt.sqrt (inner _ t) + R_sqrt.sqrt (outer _ t)).
Proof.
  destruct (slab_root y) as [P E]. split; [reflexivity|]. split; [exact P|]. split; [exact P|]. intro V. generalize (largest_pos y V). intro L.
  unfold half, half_width_simplex. change (outer _ t) with (inner _ t).
  change (inner _ t) with (largest_slab reals (to_reals ((y u ⊖ y o) ✕ (y v ⊖ y o))) (to_reals ((y v ⊖ y o) ✕ (y w ⊖ y o))) (to_reals ((y w ⊖ y o) ✕ (y u ⊖ y o)))).
  rewrite E. change (determinant _ t) with (volume y). split; [f_equal; ring|lra].
Qed.
End tetrahedron.

(* ---- A bi-cell ---- *)

Section bicell.
Variable x : placement.
Definition real_bicell := bicell reals (to_reals (rel x b)) (to_reals (rel x c)) (to_reals (rel x p)) (to_reals (rel x q)).
Let t := real_bicell.

Lemma terms_are_numbers : insphere _ t = det x /\ side _ (ab_cpq _ t) = Lam x cpq /\ side _ (ca_bpq _ t) = Lam x bpq /\ side _ (bc_apq _ t) = Lam x apq.
Proof.
  destruct (bicell_terms_are reals (fun a => eq_refl) (to_reals (rel x b)) (to_reals (rel x c)) (to_reals (rel x p)) (to_reals (rel x q)))
    as (D & _ & (_ & _ & S2) & (_ & _ & S3) & (_ & _ & S4) & _).
  destruct (C.sides_are x) as (L2 & L3 & L4).
  split; [exact (eq_trans D (C.determinant_is x))|]. split; [exact (eq_trans S2 L2)|]. split; [exact (eq_trans S3 L3)|exact (eq_trans S4 L4)].
Qed.

(* A partition by its two norms. *)
Definition norms_are (k : partition reals) (m n : vec) : Prop := inner_3 _ k = sq m /\ outer_3 _ k = sq n.
Lemma partition_norms : norms_are (abc_pq _ t) (arm x pq a) (arm x pq p) /\ norms_are (ab_cpq _ t) (arm x cpq a) (arm x cpq c) /\
  norms_are (ca_bpq _ t) (arm x bpq a) (arm x bpq b) /\ norms_are (bc_apq _ t) (arm x apq b) (arm x apq a).
Proof.
  destruct (bicell_terms_are reals (fun a => eq_refl) (to_reals (rel x b)) (to_reals (rel x c)) (to_reals (rel x p)) (to_reals (rel x q)))
    as (_ & (I1 & O1 & _) & (I2 & O2 & _) & (I3 & O3 & _) & (I4 & O4 & _) & _).
  destruct (C.arms_pq x) as [N1 M1], (C.arms_cpq x) as [N2 M2], (C.arms_bpq x) as [N3 M3], (C.arms_apq x) as [N4 M4].
  assert (M : forall v, sq ((-1) ⊙ v) = sq v) by vector. unfold norms_are. rewrite !arm_a, <- (M (arm x apq b)), <- (M (N x apq)).
  assert (Q : forall g v, g = C.numbers v -> float_terms_3.square R Rplus Rmult g = sq v) by (intros g v ->; reflexivity).
  repeat split; (etransitivity; [eassumption|]); apply Q; assumption.
Qed.

Lemma annulus_half k (B : vertex -> bool) i j : B i = false -> B j = true -> norms_are k (arm x B i) (arm x B j) -> 0 < det x ->
  0 <= inner_3 _ k /\ 0 <= outer_3 _ k /\ half (of_partition reals t k) = half_width x B i j /\ 0 < R_sqrt.sqrt (inner_3 _ k) + R_sqrt.sqrt (outer_3 _ k).
Proof.
  intros Hi Hj [I O] D. rewrite I, O. split; [apply sq_nonneg|]. split; [apply sq_nonneg|]. unfold half, of_partition. cbn [determinant inner outer].
  rewrite I, O, (proj1 terms_are_numbers). split; [reflexivity|]. apply (arms_pos x B i j Hi Hj). lra.
Qed.

Theorem annuli_half : 0 < det x -> forall k, In k [abc_pq _ t; ab_cpq _ t; ca_bpq _ t; bc_apq _ t] ->
  0 <= inner_3 _ k /\ 0 <= outer_3 _ k /\ 0 < R_sqrt.sqrt (inner_3 _ k) + R_sqrt.sqrt (outer_3 _ k).
Proof.
  intros D k I. destruct partition_norms as (N1 & N2 & N3 & N4). destruct I as [<-|[<-|[<-|[<-|[]]]]];
    [destruct (annulus_half _ pq a p eq_refl eq_refl N1 D)|destruct (annulus_half _ cpq a c eq_refl eq_refl N2 D)
    |destruct (annulus_half _ bpq a b eq_refl eq_refl N3 D)|destruct (annulus_half _ apq b a eq_refl eq_refl N4 D)]; tauto.
Qed.
Theorem annuli_are : 0 < det x -> annuli_half_width x =
  Rmin (Rmin (half (of_partition reals t (abc_pq _ t))) (half (of_partition reals t (ab_cpq _ t))))
       (Rmin (half (of_partition reals t (ca_bpq _ t))) (half (of_partition reals t (bc_apq _ t)))).
Proof.
  intro D. destruct partition_norms as (N1 & N2 & N3 & N4). unfold annuli_half_width.
  now rewrite (proj1 (proj2 (proj2 (annulus_half _ pq a p eq_refl eq_refl N1 D)))), (proj1 (proj2 (proj2 (annulus_half _ cpq a c eq_refl eq_refl N2 D)))),
    (proj1 (proj2 (proj2 (annulus_half _ bpq a b eq_refl eq_refl N3 D)))), (proj1 (proj2 (proj2 (annulus_half _ apq b a eq_refl eq_refl N4 D)))).
Qed.

(* The cells: their terms are those of their orientation. *)
Lemma minus_reals u' : minus_3 reals (to_reals u') = to_reals ((-1) ⊙ u').
Proof. destruct u'. unfold minus_3, to_reals, scale. simpl. f_equal; ring. Qed.
Lemma cross_reals u' v' : cross reals (to_reals u') (to_reals v') = to_reals (u' ✕ v').
Proof. reflexivity. Qed.

Lemma cells_half : cell_p _ t = volume (sign_tolerance_3.cell_p x) /\ cell_q _ t = volume (sign_tolerance_3.cell_q x) /\
  0 <= cell_p_slab _ t /\ 0 <= cell_q_slab _ t /\
  R_sqrt.sqrt (cell_p_slab _ t) = largest (sign_tolerance_3.cell_p x) /\ R_sqrt.sqrt (cell_q_slab _ t) = largest (sign_tolerance_3.cell_q x).
Proof.
  destruct (bicell_terms_are reals (fun a => eq_refl) (to_reals (rel x b)) (to_reals (rel x c)) (to_reals (rel x p)) (to_reals (rel x q)))
    as (_ & _ & _ & _ & _ & P & Q).
  rewrite volume_p, volume_q. split; [exact (eq_trans P (proj1 (C.cells_are x)))|]. split; [exact (eq_trans Q (proj2 (C.cells_are x)))|].
  change (cell_p_slab _ t) with (largest_slab reals (minus_3 reals (cross reals (to_reals (rel x b)) (to_reals (rel x c))))
    (cross reals (to_reals (rel x b)) (to_reals (rel x p))) (minus_3 reals (cross reals (to_reals (rel x c)) (to_reals (rel x p))))).
  change (cell_q_slab _ t) with (largest_slab reals (cross reals (to_reals (rel x b)) (to_reals (rel x c)))
    (cross reals (to_reals (rel x c)) (to_reals (rel x q))) (minus_3 reals (cross reals (to_reals (rel x b)) (to_reals (rel x q))))).
  rewrite !cross_reals, !minus_reals.
  destruct (slab_root (sign_tolerance_3.cell_p x)) as [P0 P1], (slab_root (sign_tolerance_3.cell_q x)) as [Q0 Q1].
  assert (S : forall u' v', (-1) ⊙ (u' ✕ v') = v' ✕ u') by vector. rewrite !S. auto.
Qed.

Lemma cell_half (y : corners) v l : v = volume y -> R_sqrt.sqrt l = largest y -> 0 < v ->
  half (of_cell reals v l) = half_width_simplex y /\ 0 < R_sqrt.sqrt l + R_sqrt.sqrt l.
Proof.
  intros -> E V. generalize (largest_pos y V). intro L. unfold half, of_cell, half_width_simplex. cbn [determinant inner outer]. rewrite E.
  split; [f_equal; ring|lra].
Qed.
End bicell.
