(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The filter of filter_2.v says the same in primitive floats, which is what the binary computes (replay_2.v), and in rounded
   reals, which is what theorems are about: for all points of the coordinate domain, and further. No operation
   overflows that matters.

   - orientation_filter_stands, empty_sphere_filter_stands: same refusal, same sign, and the tolerance stands for the real one *)
From Coq Require Import Reals ZArith Lia Lra Bool.
From Flocq Require Import Core IEEE754.BinarySingleNaN IEEE754.PrimFloat.
From Coq Require Import Floats.
From Annulus Require Import operations bridge bridge_decide filter_2.
Close Scope float_scope.
Open Scope R_scope.

Definition stands_vector (a : Z) (v : vector machine) (w : vector rounded) :=
  stands a (x _ v) (x _ w) /\ stands a (y _ v) (y _ w).

Lemma stands_difference : forall a v w v' w', (-1074 <= a + 1 < 1024)%Z -> stands_vector a v v' -> stands_vector a w w' ->
  stands_vector (a + 1) (difference machine v w) (difference rounded v' w').
Proof.
  intros a v w v' w' H [A B] [C D]. split; simpl; rewrite <- (Z.max_id a) at 1; apply stands_sub; trivial; rewrite Z.max_id; lia.
Qed.

Lemma stands_largest : forall a v w, stands_vector a v w -> stands a (largest machine v) (largest rounded w).
Proof.
  intros a v w [A B]. rewrite <- (Z.max_id a). apply stands_max; apply stands_abs; assumption.
Qed.

Lemma largest_bounds : forall (w : vector rounded) b, largest rounded w <= b -> Rabs (x _ w) <= b /\ Rabs (y _ w) <= b.
Proof.
  intros w b H. split; (eapply Rle_trans; [|exact H]); [apply max_ge_l|apply max_ge_r].
Qed.

Lemma tighter_vector : forall a b v w, stands_vector a v w -> largest rounded w <= power b -> stands_vector b v w.
Proof.
  intros a b v w [A B] H. destruct (largest_bounds _ _ H). split; eapply stands_tighter; eassumption.
Qed.

Lemma stands_range : forall m r, stands 501 m r -> in_range machine m = in_range rounded r.
Proof.
  intros m r H. apply (stands_in_range filter_range 120); [eapply stands_constant; [reflexivity| |]; vm_compute; easy|lia|exact H].
Qed.

Lemma range_bound : forall r, in_range rounded r = true -> r <= power 120.
Proof.
  intros r H. unfold in_range in H. simpl in H. apply andb_prop in H. destruct H as [H _].
  revert H. case Rle_bool_spec; [|easy]. now rewrite (value_power filter_range 68 eq_refl).
Qed.

(* In the plane roots are 0 or at least the root of the least positive number. *)
Lemma roots_below : forall r n, 0 <= n -> (0 < r -> power (-537) <= r) -> n < rnd (r * value filter_slack) -> power (-537) <= r + n.
Proof.
  intros r n Pn Pr K. assert (P : 0 < r).
  { apply Rmult_lt_reg_r with (value filter_slack).
    - rewrite (value_power filter_slack (-62) eq_refl). apply bpow_gt_0.
    - rewrite Rmult_0_l. apply rnd_positive. apply Rle_lt_trans with (1 := Pn). exact K. }
  specialize (Pr P). lra.
Qed.

(* Sums of roots of two squared norms, and twice one root. *)
Lemma stands_roots : forall f g r s, stands 732 f r -> stands 732 g s -> 0 <= r -> 0 <= s ->
  let sum := rnd (rnd (R_sqrt.sqrt r) + rnd (R_sqrt.sqrt s)) in
  stands 367 (PrimFloat.sqrt f + PrimFloat.sqrt g)%float sum /\ (0 < sum -> power (-537) <= sum).
Proof.
  intros f g r s F G Pr Ps sum. split.
  - apply (stands_add 366 366); [lia| |]; apply stands_sqrt; trivial; lia.
  - intro H. generalize (rnd_positive _ H). intro S. apply rnd_at_least; [lia|].
    generalize (rnd_nonneg _ (sqrt_pos r)) (rnd_nonneg _ (sqrt_pos s)). intros I O.
    destruct (Rle_lt_or_eq_dec _ _ Pr) as [L|L].
    + generalize (root_at_least _ _ _ F L). lra.
    + destruct (Rle_lt_or_eq_dec _ _ Ps) as [M|M].
      * generalize (root_at_least _ _ _ G M). lra.
      * exfalso. rewrite <- L, <- M, sqrt_0, round_0 in S; auto with typeclass_instances. lra.
Qed.

Lemma stands_twice_root : forall f r, stands 732 f r -> 0 <= r ->
  let sum := rnd (value 2%float * rnd (R_sqrt.sqrt r)) in
  stands 367 (2 * PrimFloat.sqrt f)%float sum /\ (0 < sum -> power (-537) <= sum).
Proof.
  intros f r F Pr sum.
  assert (T : stands 1 2%float (value 2%float)) by (eapply stands_constant; [reflexivity| |]; vm_compute; easy).
  assert (V : value 2%float = 2) by (rewrite (value_power 2%float (-51) eq_refl); reflexivity).
  split.
  - apply (stands_mul 1 366); [lia|exact T|]. apply stands_sqrt; trivial; lia.
  - intro H. generalize (rnd_positive _ H). rewrite V. intro S. unfold sum. rewrite V. apply rnd_at_least; [lia|].
    destruct (Rle_lt_or_eq_dec _ _ Pr) as [L|L].
    + generalize (root_at_least _ _ _ F L) (bpow_gt_0 radix2 (-537)). lra.
    + exfalso. rewrite <- L, sqrt_0, round_0 in S; auto with typeclass_instances. lra.
Qed.

Lemma stands_squares : forall a f g r s, (0 <= a < 500)%Z -> stands a f r -> stands a g s ->
  stands (2 * a + 1) (f * f + g * g)%float (rnd (rnd (r * r) + rnd (s * s))) /\ 0 <= rnd (rnd (r * r) + rnd (s * s)).
Proof.
  intros a f g r s H F G. split.
  - replace (2 * a + 1)%Z with (Z.max (a + a) (a + a) + 1)%Z by lia.
    apply (stands_add (a + a) (a + a)); [lia| |]; apply stands_mul; trivial; lia.
  - apply rnd_nonneg. generalize (rnd_nonneg _ (Rle_0_sqr r)) (rnd_nonneg _ (Rle_0_sqr s)). unfold Rsqr. intros. lra.
Qed.

(* The hypotheses of decide_stands for both certificates: exponents of every operation. *)
Section orientation.
Variables (u v w : vector machine) (u' v' w' : vector rounded).
Hypothesis Hu : stands_vector 120 u u'.
Hypothesis Hv : stands_vector 120 v v'.
Hypothesis Hw : stands_vector 122 w w'.

Lemma orientation_terms_stand :
  let t := orientation_terms machine u v w in let t' := orientation_terms rounded u' v' w' in
  stands 241 (determinant _ t) (determinant _ t') /\
  (stands 245 (inner _ t) (inner _ t') /\ 0 <= inner _ t') /\ (stands 245 (outer _ t) (outer _ t') /\ 0 <= outer _ t').
Proof.
  destruct Hu as [ux uy], Hv as [vx vy], Hw as [wx wy].
  destruct (stands_squares 120 _ _ _ _ ltac:(lia) ux uy) as [uu Pu].
  destruct (stands_squares 120 _ _ _ _ ltac:(lia) vx vy) as [vv Pv].
  destruct (stands_squares 122 _ _ _ _ ltac:(lia) wx wy) as [ww Pw].
  assert (L : stands 245 (inner _ (orientation_terms machine u v w)) (inner _ (orientation_terms rounded u' v' w')) /\
              0 <= inner _ (orientation_terms rounded u' v' w')).
  { split.
    - exact (stands_max _ 245 _ _ _ _ (stands_max 241 241 _ _ _ _ uu vv) ww).
    - apply Rle_trans with (2 := max_ge_r _ _). exact Pw. }
  split; [|split; exact L].
  exact (stands_sub 240 240 _ _ _ _ ltac:(lia) (stands_mul 120 120 _ _ _ _ ltac:(lia) ux vy)
                                                (stands_mul 120 120 _ _ _ _ ltac:(lia) uy vx)).
Qed.
End orientation.

Section annulus.
Variables (b p q e : vector machine) (b' p' q' e' : vector rounded).
Hypothesis Hb : stands_vector 120 b b'.
Hypothesis Hp : stands_vector 120 p p'.
Hypothesis Hq : stands_vector 120 q q'.
Hypothesis He : stands_vector 120 e e'.

(* Its two numbers get names, so that what is built from them stays short. *)
Ltac named H := match type of H with stands _ ?m ?n => let f := fresh in let r := fresh in set (f := m) in H; set (r := n) in H end.

Lemma annulus_terms_stand :
  let t := annulus_terms machine b p q e in let t' := annulus_terms rounded b' p' q' e' in
  stands 484 (determinant _ t) (determinant _ t') /\
  (stands 731 (inner _ t) (inner _ t') /\ 0 <= inner _ t') /\ (stands 731 (outer _ t) (outer _ t') /\ 0 <= outer _ t').
Proof.
  destruct Hb as [bx by'], Hp as [px py], Hq as [qx qy], He as [ex ey].
  pose proof (stands_sub 240 240 _ _ _ _ ltac:(lia) (stands_mul 120 120 _ _ _ _ ltac:(lia) bx qy)
                                                    (stands_mul 120 120 _ _ _ _ ltac:(lia) by' qx)) as ob; named ob.
  pose proof (stands_sub 240 240 _ _ _ _ ltac:(lia) (stands_mul 120 120 _ _ _ _ ltac:(lia) by' px)
                                                    (stands_mul 120 120 _ _ _ _ ltac:(lia) bx py)) as oa; named oa.
  pose proof (stands_add 241 241 _ _ _ _ ltac:(lia) ob oa) as D; named D.
  pose proof (stands_sub 121 120 _ _ _ _ ltac:(lia) (stands_add 120 120 _ _ _ _ ltac:(lia) qx px) bx) as gx; named gx.
  pose proof (stands_sub 121 120 _ _ _ _ ltac:(lia) (stands_add 120 120 _ _ _ _ ltac:(lia) qy py) by') as gy; named gy.
  pose proof (stands_add 242 242 _ _ _ _ ltac:(lia) (stands_mul 120 122 _ _ _ _ ltac:(lia) ex gx)
                                                    (stands_mul 120 122 _ _ _ _ ltac:(lia) ey gy)) as s; named s.
  pose proof (stands_sub 362 363 _ _ _ _ ltac:(lia) (stands_mul 242 120 _ _ _ _ ltac:(lia) D bx)
                                                    (stands_mul 243 120 _ _ _ _ ltac:(lia) s by')) as nx; named nx.
  pose proof (stands_add 362 363 _ _ _ _ ltac:(lia) (stands_mul 242 120 _ _ _ _ ltac:(lia) D by')
                                                    (stands_mul 243 120 _ _ _ _ ltac:(lia) s bx)) as ny; named ny.
  pose proof (stands_add 242 242 _ _ _ _ ltac:(lia) D D) as twice_D; named twice_D.
  pose proof (stands_sub 364 363 _ _ _ _ ltac:(lia) nx (stands_mul 243 120 _ _ _ _ ltac:(lia) twice_D px)) as mx; named mx.
  pose proof (stands_sub 364 363 _ _ _ _ ltac:(lia) ny (stands_mul 243 120 _ _ _ _ ltac:(lia) twice_D py)) as my; named my.
  pose proof (stands_add 241 241 _ _ _ _ ltac:(lia)
    (stands_mul 120 121 _ _ _ _ ltac:(lia) px (stands_sub 120 120 _ _ _ _ ltac:(lia) px bx))
    (stands_mul 120 121 _ _ _ _ ltac:(lia) py (stands_sub 120 120 _ _ _ _ ltac:(lia) py by'))) as kp; named kp.
  pose proof (stands_add 241 241 _ _ _ _ ltac:(lia)
    (stands_mul 120 121 _ _ _ _ ltac:(lia) qx (stands_sub 120 120 _ _ _ _ ltac:(lia) qx bx))
    (stands_mul 120 121 _ _ _ _ ltac:(lia) qy (stands_sub 120 120 _ _ _ _ ltac:(lia) qy by'))) as kq; named kq.
  pose proof (stands_add 483 483 _ _ _ _ ltac:(lia) (stands_mul 242 241 _ _ _ _ ltac:(lia) kp ob)
                                                    (stands_mul 242 241 _ _ _ _ ltac:(lia) kq oa)) as incircle; named incircle.
  pose proof (stands_squares 364 _ _ _ _ ltac:(lia) nx ny) as [inn Pi]; named inn.
  pose proof (stands_squares 365 _ _ _ _ ltac:(lia) mx my) as [out Po]; named out.
  split; [exact incircle|split; split; [|exact Pi| |exact Po]].
  - apply stands_wider with 729%Z; [lia|exact inn].
  - exact out.
Qed.
End annulus.

(* A point of the coordinate domain, |x|, |y| <= 2^500, and the real point it is. *)
Definition in_domain (v : vector machine) (w : vector rounded) := stands_vector 500 v w.

Lemma rounded_difference : forall v w v' w', in_domain v v' -> in_domain w w' ->
  stands_vector 501 (difference machine v w) (difference rounded v' w').
Proof. intros. apply (stands_difference 500); trivial; lia. Qed.

(* What a rounded difference of at most 2^120 says of the difference. *)
Lemma before_rounding : forall r, Rabs (rnd r) <= power 120 -> Rabs r <= power 121.
Proof.
  intros r H. apply Rnot_lt_le. intro N. apply (Rlt_not_le _ _ (bpow_lt radix2 120 121 ltac:(lia))).
  apply Rle_trans with (2 := H). rewrite <- round_NE_abs by auto with typeclass_instances.
  apply rnd_at_least; [lia|]. apply Rlt_le, N.
Qed.

(* The third side of a triangle is no test's concern in filtered_2.h: the other two bound it. *)
Lemma third_side : forall r s t, Rabs (rnd (s - r)) <= power 120 -> Rabs (rnd (t - r)) <= power 120 ->
  Rabs (rnd (t - s)) <= power 122.
Proof.
  intros r s t H K. apply rnd_bound; [lia|]. replace (t - s) with ((t - r) - (s - r)) by ring.
  apply Rle_trans with (1 := Rabs_triang _ _). rewrite Rabs_Ropp.
  change 122%Z with (121 + 1)%Z. rewrite bpow_plus. change (power 1) with 2.
  generalize (before_rounding _ H) (before_rounding _ K). lra.
Qed.

Theorem orientation_filter_stands : forall certified a b c a' b' c', in_domain a a' -> in_domain b b' -> in_domain c c' ->
  stands_said certified (orientation_filter machine a b c certified) (orientation_filter rounded a' b' c' certified).
Proof.
  intros certified a b c a' b' c' A B C. unfold orientation_filter. cbv zeta.
  pose proof (rounded_difference _ _ _ _ B A) as U.
  pose proof (rounded_difference _ _ _ _ C A) as V.
  pose proof (rounded_difference _ _ _ _ C B) as W.
  pose proof (stands_max 501 501 _ _ _ _ (stands_largest _ _ _ U) (stands_largest _ _ _ V)) as M.
  fold (orientation_magnitude machine (difference machine b a) (difference machine c a)) in M.
  fold (orientation_magnitude rounded (difference rounded b' a') (difference rounded c' a')) in M.
  rewrite (stands_range _ _ M).
  destruct (in_range rounded (orientation_magnitude rounded (difference rounded b' a') (difference rounded c' a'))) eqn:R;
    [|now destruct certified].
  apply range_bound in R.
  pose proof (Rle_trans _ _ _ (max_ge_l _ _) R) as Ru. pose proof (Rle_trans _ _ _ (max_ge_r _ _) R) as Rv.
  apply (tighter_vector _ 120) in U; [|exact Ru]. apply (tighter_vector _ 120) in V; [|exact Rv].
  assert (W' : stands_vector 122 (difference machine c b) (difference rounded c' b')).
  { destruct U as [(_ & _ & Ux) (_ & _ & Uy)], V as [(_ & _ & Vx) (_ & _ & Vy)], W as [Wx Wy].
    split; (eapply stands_tighter; [eassumption|]).
    - exact (third_side (x _ a') (x _ b') (x _ c') Ux Vx).
    - exact (third_side (y _ a') (y _ b') (y _ c') Uy Vy). }
  destruct (orientation_terms_stand _ _ _ _ _ _ U V W') as (D & (I & Pi) & (O & Po)).
  assert (M' : stands 120 (orientation_magnitude machine (difference machine b a) (difference machine c a))
                 (orientation_magnitude rounded (difference rounded b' a') (difference rounded c' a')))
    by exact (stands_max 120 120 _ _ _ _ (stands_largest _ _ _ U) (stands_largest _ _ _ V)).
  assert (K : stands (-49) orientation_2_u (value orientation_2_u)) by (eapply stands_constant; [reflexivity| |]; vm_compute; easy).
  apply (stands_wider _ 732) in I; [|lia].
  destruct (stands_twice_root _ _ I Pi) as [Rt Pt].
  apply (decide_said 484 367 (-537)); [lia| |exact Rt|..].
  - apply stands_wider with (2 := D). lia.
  - apply stands_wider with (-49 + 240)%Z; [lia|].
    exact (stands_mul (-49) 240 _ _ _ _ ltac:(lia) K (stands_mul 120 120 _ _ _ _ ltac:(lia) M' M')).
  - apply stands_zero.
  - apply roots_below; [|exact Pt]. change (0 <= value 0%float). rewrite value_zero. apply Rle_refl.
Qed.

Theorem empty_sphere_filter_stands : forall certified a b p q a' b' p' q',
  in_domain a a' -> in_domain b b' -> in_domain p p' -> in_domain q q' ->
  stands_said certified (empty_sphere_filter machine a b p q certified) (empty_sphere_filter rounded a' b' p' q' certified).
Proof.
  intros certified a b p q a' b' p' q' A B P Q. unfold empty_sphere_filter. cbv zeta.
  pose proof (rounded_difference _ _ _ _ B A) as U.
  pose proof (rounded_difference _ _ _ _ P A) as V.
  pose proof (rounded_difference _ _ _ _ Q A) as W.
  pose proof (rounded_difference _ _ _ _ Q P) as E.
  pose proof (stands_max 501 501 _ _ _ _
    (stands_max 501 501 _ _ _ _ (stands_largest _ _ _ U) (stands_largest _ _ _ V))
    (stands_max 501 501 _ _ _ _ (stands_largest _ _ _ W) (stands_largest _ _ _ E))) as M.
  set (m := annulus_magnitude machine (difference machine b a) (difference machine p a) (difference machine q a)
              (difference machine q p)).
  set (m' := annulus_magnitude rounded (difference rounded b' a') (difference rounded p' a') (difference rounded q' a')
              (difference rounded q' p')).
  change (stands 501 m m') in M.
  rewrite (stands_range _ _ M). destruct (in_range rounded m') eqn:R; [|now destruct certified].
  apply range_bound in R.
  pose proof (Rle_trans _ _ _ (max_ge_l _ _) R) as R1. pose proof (Rle_trans _ _ _ (max_ge_r _ _) R) as R2.
  apply (tighter_vector _ 120) in U; [|exact (Rle_trans _ _ _ (max_ge_l _ _) R1)].
  apply (tighter_vector _ 120) in V; [|exact (Rle_trans _ _ _ (max_ge_r _ _) R1)].
  apply (tighter_vector _ 120) in W; [|exact (Rle_trans _ _ _ (max_ge_l _ _) R2)].
  apply (tighter_vector _ 120) in E; [|exact (Rle_trans _ _ _ (max_ge_r _ _) R2)].
  destruct (annulus_terms_stand _ _ _ _ _ _ _ _ U V W E) as (D & (I & Pi) & (O & Po)).
  assert (M' : stands 120 m m')
    by exact (stands_max 120 120 _ _ _ _
      (stands_max 120 120 _ _ _ _ (stands_largest _ _ _ U) (stands_largest _ _ _ V))
      (stands_max 120 120 _ _ _ _ (stands_largest _ _ _ W) (stands_largest _ _ _ E))).
  pose proof (stands_mul 120 120 _ _ _ _ ltac:(lia) M' M') as M2.
  assert (Ki : stands (-45) annulus_2_incircle_u (value annulus_2_incircle_u))
    by (eapply stands_constant; [reflexivity| |]; vm_compute; easy).
  assert (Kn : stands (-44) annulus_2_norms_u (value annulus_2_norms_u))
    by (eapply stands_constant; [reflexivity| |]; vm_compute; easy).
  apply (stands_wider _ 732) in I; [|lia]. apply (stands_wider _ 732) in O; [|lia].
  destruct (stands_roots _ _ _ _ I O Pi Po) as [Rt Pt].
  apply (decide_said 484 367 (-537)); [lia|exact D|exact Rt|..].
  - apply stands_wider with (-45 + 480)%Z; [lia|].
    exact (stands_mul (-45) 480 _ _ _ _ ltac:(lia) Ki (stands_mul 240 240 _ _ _ _ ltac:(lia) M2 M2)).
  - apply stands_wider with (-44 + 360)%Z; [lia|].
    exact (stands_mul (-44) 360 _ _ _ _ ltac:(lia) Kn (stands_mul 240 120 _ _ _ _ ltac:(lia) M2 M')).
  - apply roots_below; [|exact Pt]. assert (0 <= m') by (eapply Rle_trans; [|apply max_ge_l]; eapply Rle_trans; [|apply max_ge_l];
                          eapply Rle_trans; [|apply max_ge_l]; apply Rabs_pos).
    apply rnd_nonneg, Rmult_le_pos.
    + change (0 <= value annulus_2_norms_u). unfold value, Prim2B. rewrite B2R_SF2B. apply F2R_ge_0. easy.
    + apply rnd_nonneg, Rmult_le_pos; [|assumption]. apply rnd_nonneg, Rmult_le_pos; assumption.
Qed.
