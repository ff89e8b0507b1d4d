(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The filter of filter_2.v says the same in primitive floats, which is what the binary computes (replay_2.v), and in rounded
   reals, which is what theorems are about: for all points of the coordinate domain, and further. No operation
   overflows that matters.

   - orientation_filter_stands, empty_sphere_filter_stands: same refusal, same sign, and the tolerance stands for the real one *)
From Coq Require Import Reals ZArith Lia Lra Bool.
From Flocq Require Import Core IEEE754.BinarySingleNaN IEEE754.PrimFloat.
From Coq Require Import Floats.
From Annulus_link Require Import operations bridge filter_2.
Close Scope float_scope.
Open Scope R_scope.

(* A constant: read off its mantissa and exponent. *)
Lemma stands_constant : forall a f m e, Prim2SF f = S754_finite false m e -> (e <= a)%Z -> (Z.pos m <= 2 ^ (a - e))%Z ->
  stands a f (value f).
Proof.
  intros a f m e H E M. unfold stands, finite, value, Prim2B.
  rewrite is_finite_SF2B, B2R_SF2B, H. repeat split. simpl.
  rewrite Rabs_pos_eq by (apply F2R_ge_0; easy).
  unfold F2R. simpl. replace (power a) with (power (a - e) * power e) by (rewrite <- bpow_plus; f_equal; lia).
  apply Rmult_le_compat_r; [apply bpow_ge_0|].
  rewrite <- IZR_Zpower by lia. apply IZR_le, M.
Qed.

Lemma stands_zero : forall a, stands a 0%float (value 0%float).
Proof.
  intro a. unfold stands, finite, value, Prim2B. rewrite is_finite_SF2B, B2R_SF2B. simpl.
  repeat split. rewrite Rabs_R0. apply bpow_ge_0.
Qed.

Lemma value_power : forall f e, Prim2SF f = S754_finite false 4503599627370496 e -> value f = power (52 + e).
Proof.
  intros f e H. unfold value, Prim2B. rewrite B2R_SF2B, H. rewrite bpow_plus. reflexivity.
Qed.

Lemma value_zero : value 0%float = 0.
Proof. unfold value, Prim2B. rewrite B2R_SF2B. reflexivity. Qed.

Definition stands_vector (a : Z) (v : vector machine) (w : vector rounded) :=
  stands a (x _ v) (x _ w) /\ stands a (y _ v) (y _ w).

Definition stands_answer (a : answer float) (b : answer R) :=
  match a, b with
  | refused, refused => True
  | negative s, negative t | zero s, zero t | positive s, positive t => finite s = true /\ value s = t
  | _, _ => False
  end.

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
  intros m r H. unfold in_range. simpl.
  assert (C : stands 120 filter_range (value filter_range)) by (eapply stands_constant; [reflexivity| |]; vm_compute; easy).
  assert (O : stands 0 1%float (value 1%float)) by (eapply stands_constant; [reflexivity| |]; vm_compute; easy).
  rewrite (stands_leb _ _ _ _ _ _ H C).
  now rewrite (stands_leb _ _ _ _ _ _ O (stands_mul 501 120 _ _ _ _ ltac:(lia) H C)).
Qed.

Lemma range_bound : forall r, in_range rounded r = true -> r <= power 120.
Proof.
  intros r H. unfold in_range in H. simpl in H. apply andb_prop in H. destruct H as [H _].
  revert H. case Rle_bool_spec; [|easy]. now rewrite (value_power filter_range 68 eq_refl).
Qed.

(* Signs and least positive numbers. *)
Lemma rnd_nonneg : forall r, 0 <= r -> 0 <= rnd r.
Proof. intros r H. rewrite <- (round_0 radix2 (FLT_exp (-1074) 53) ZnearestE). apply round_le; auto with typeclass_instances. Qed.

Lemma rnd_positive : forall r, 0 < rnd r -> 0 < r.
Proof.
  intros r H. apply Rnot_le_lt. intro N. apply (Rlt_not_le _ _ H).
  rewrite <- (round_0 radix2 (FLT_exp (-1074) 53) ZnearestE). apply round_le; auto with typeclass_instances.
Qed.

Lemma rnd_at_least : forall a r, (-1074 <= a)%Z -> power a <= r -> power a <= rnd r.
Proof. intros a r H L. rewrite <- (rnd_power a H). apply round_le; auto with typeclass_instances. Qed.

Lemma root_at_least : forall a f r, stands a f r -> 0 < r -> power (-537) <= rnd (R_sqrt.sqrt r).
Proof.
  intros a f r (_ & V & _) P. apply rnd_at_least; [lia|].
  replace (power (-537)) with (R_sqrt.sqrt (power (-1074))).
  - apply sqrt_le_1_alt. apply generic_format_ge_bpow with (FLT_exp (-1074) 53); trivial.
    + intro e. unfold FLT_exp. lia.
    + rewrite <- V. apply (generic_format_B2R prec emax).
  - change (-1074)%Z with (-537 + -537)%Z. rewrite bpow_plus. apply sqrt_square, bpow_ge_0.
Qed.

Section decide.
Variables (d r e n : float) (d' r' e' n' : R).
Hypothesis Hd : stands 484 d d'.
Hypothesis Hr : stands 367 r r'.
Hypothesis He : stands 440 e e'.
Hypothesis Hn : stands 320 n n'.
Hypothesis Pr : 0 < r' -> power (-537) <= r'.
Hypothesis Pn : 0 <= n'.

Lemma decide_stands : stands_answer (decide machine d r e n true) (decide rounded d' r' e' n' true).
Proof.
  assert (slack : stands (-10) filter_slack (value filter_slack)) by (eapply stands_constant; [reflexivity| |]; vm_compute; easy).
  assert (tail : stands 0 one_less_tail (value one_less_tail)) by (eapply stands_constant; [reflexivity| |]; vm_compute; easy).
  unfold decide. change (less machine) with PrimFloat.ltb. change (less rounded) with Rlt_bool.
  change (opposite machine e) with (- e)%float. change (opposite rounded e') with (- e').
  rewrite (stands_ltb _ _ _ _ _ _ Hd (stands_opp _ _ _ He)).
  case Rlt_bool. { split; reflexivity. }
  assert (dm : stands 474 (mul machine d (constant machine filter_slack)) (mul rounded d' (constant rounded filter_slack)))
    by exact (stands_mul 484 (-10) _ _ _ _ ltac:(lia) Hd slack).
  rewrite (stands_ltb _ _ _ _ _ _ He dm).
  case Rlt_bool; [|exact I]. cbv iota beta delta [negb].
  assert (rm : stands 357 (mul machine r (constant machine filter_slack)) (mul rounded r' (constant rounded filter_slack)))
    by exact (stands_mul 367 (-10) _ _ _ _ ltac:(lia) Hr slack).
  rewrite (stands_ltb _ _ _ _ _ _ Hn rm).
  case Rlt_bool_spec; [|intros; exact I]. intro K. cbv iota beta delta [negb].
  assert (P : 0 < r').
  { apply Rmult_lt_reg_r with (value filter_slack).
    - rewrite (value_power filter_slack (-62) eq_refl). apply bpow_gt_0.
    - rewrite Rmult_0_l. apply rnd_positive. apply Rle_lt_trans with (1 := Pn). exact K. }
  assert (L := Pr P).
  assert (num : stands 485 (sub machine d e) (sub rounded d' e'))
    by exact (stands_sub 484 440 _ _ _ _ ltac:(lia) Hd He).
  assert (den : stands 368 (add machine r n) (add rounded r' n'))
    by exact (stands_add 367 320 _ _ _ _ ltac:(lia) Hr Hn).
  assert (D : power (-537) <= add rounded r' n').
  { apply rnd_at_least; [lia|]. lra. }
  assert (quo : stands 1022 (div machine (sub machine d e) (add machine r n)) (div rounded (sub rounded d' e') (add rounded r' n'))).
  { apply (stands_div 485 368 1022 _ _ _ _ ltac:(lia) num den).
    - generalize (bpow_gt_0 radix2 (-537)). lra.
    - destruct num as (_ & _ & B). unfold Rdiv. rewrite Rabs_mult.
      change 1022%Z with (485 + 537)%Z. rewrite bpow_plus.
      apply Rmult_le_compat; [apply Rabs_pos|apply Rabs_pos|exact B|].
      rewrite Rabs_inv, Rabs_pos_eq by (generalize (bpow_gt_0 radix2 (-537)); lra).
      change 537%Z with (- (-537))%Z. rewrite bpow_opp.
      apply Rinv_le; [apply bpow_gt_0|exact D]. }
  destruct (stands_mul 1022 0 _ _ _ _ ltac:(lia) quo tail) as (F & V & _). split; [exact F|exact V].
Qed.
End decide.

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

Lemma annulus_terms_stand :
  let t := annulus_terms machine b p q e in let t' := annulus_terms rounded b' p' q' e' in
  stands 484 (determinant _ t) (determinant _ t') /\
  (stands 731 (inner _ t) (inner _ t') /\ 0 <= inner _ t') /\ (stands 731 (outer _ t) (outer _ t') /\ 0 <= outer _ t').
Proof.
  destruct Hb as [bx by'], Hp as [px py], Hq as [qx qy], He as [ex ey].
  pose proof (stands_sub 240 240 _ _ _ _ ltac:(lia) (stands_mul 120 120 _ _ _ _ ltac:(lia) bx qy)
                                                    (stands_mul 120 120 _ _ _ _ ltac:(lia) by' qx)) as ob.
  pose proof (stands_sub 240 240 _ _ _ _ ltac:(lia) (stands_mul 120 120 _ _ _ _ ltac:(lia) by' px)
                                                    (stands_mul 120 120 _ _ _ _ ltac:(lia) bx py)) as oa.
  pose proof (stands_add 241 241 _ _ _ _ ltac:(lia) ob oa) as D.
  pose proof (stands_sub 121 120 _ _ _ _ ltac:(lia) (stands_add 120 120 _ _ _ _ ltac:(lia) qx px) bx) as gx.
  pose proof (stands_sub 121 120 _ _ _ _ ltac:(lia) (stands_add 120 120 _ _ _ _ ltac:(lia) qy py) by') as gy.
  pose proof (stands_add 242 242 _ _ _ _ ltac:(lia) (stands_mul 120 122 _ _ _ _ ltac:(lia) ex gx)
                                                    (stands_mul 120 122 _ _ _ _ ltac:(lia) ey gy)) as s.
  pose proof (stands_sub 362 363 _ _ _ _ ltac:(lia) (stands_mul 242 120 _ _ _ _ ltac:(lia) D bx)
                                                    (stands_mul 243 120 _ _ _ _ ltac:(lia) s by')) as nx.
  pose proof (stands_add 362 363 _ _ _ _ ltac:(lia) (stands_mul 242 120 _ _ _ _ ltac:(lia) D by')
                                                    (stands_mul 243 120 _ _ _ _ ltac:(lia) s bx)) as ny.
  pose proof (stands_add 242 242 _ _ _ _ ltac:(lia) D D) as twice_D.
  pose proof (stands_sub 364 363 _ _ _ _ ltac:(lia) nx (stands_mul 243 120 _ _ _ _ ltac:(lia) twice_D px)) as mx.
  pose proof (stands_sub 364 363 _ _ _ _ ltac:(lia) ny (stands_mul 243 120 _ _ _ _ ltac:(lia) twice_D py)) as my.
  pose proof (stands_add 241 241 _ _ _ _ ltac:(lia)
    (stands_mul 120 121 _ _ _ _ ltac:(lia) px (stands_sub 120 120 _ _ _ _ ltac:(lia) px bx))
    (stands_mul 120 121 _ _ _ _ ltac:(lia) py (stands_sub 120 120 _ _ _ _ ltac:(lia) py by'))) as kp.
  pose proof (stands_add 241 241 _ _ _ _ ltac:(lia)
    (stands_mul 120 121 _ _ _ _ ltac:(lia) qx (stands_sub 120 120 _ _ _ _ ltac:(lia) qx bx))
    (stands_mul 120 121 _ _ _ _ ltac:(lia) qy (stands_sub 120 120 _ _ _ _ ltac:(lia) qy by'))) as kq.
  pose proof (stands_add 483 483 _ _ _ _ ltac:(lia) (stands_mul 242 241 _ _ _ _ ltac:(lia) kp ob)
                                                    (stands_mul 242 241 _ _ _ _ ltac:(lia) kq oa)) as incircle.
  pose proof (stands_squares 364 _ _ _ _ ltac:(lia) nx ny) as [inn Pi].
  pose proof (stands_squares 365 _ _ _ _ ltac:(lia) mx my) as [out Po].
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

(* The third side of a triangle is no test's concern in ladder_2.h: the other two bound it. *)
Lemma third_side : forall r s t, Rabs (rnd (s - r)) <= power 120 -> Rabs (rnd (t - r)) <= power 120 ->
  Rabs (rnd (t - s)) <= power 122.
Proof.
  intros r s t H K. apply rnd_bound; [lia|]. replace (t - s) with ((t - r) - (s - r)) by ring.
  apply Rle_trans with (1 := Rabs_triang _ _). rewrite Rabs_Ropp.
  change 122%Z with (121 + 1)%Z. rewrite bpow_plus. change (power 1) with 2.
  generalize (before_rounding _ H) (before_rounding _ K). lra.
Qed.

Theorem orientation_filter_stands : forall a b c a' b' c', in_domain a a' -> in_domain b b' -> in_domain c c' ->
  stands_answer (orientation_filter machine a b c true) (orientation_filter rounded a' b' c' true).
Proof.
  intros a b c a' b' c' A B C. unfold orientation_filter. cbv zeta.
  pose proof (rounded_difference _ _ _ _ B A) as U.
  pose proof (rounded_difference _ _ _ _ C A) as V.
  pose proof (rounded_difference _ _ _ _ C B) as W.
  pose proof (stands_max 501 501 _ _ _ _ (stands_largest _ _ _ U) (stands_largest _ _ _ V)) as M.
  fold (orientation_magnitude machine (difference machine b a) (difference machine c a)) in M.
  fold (orientation_magnitude rounded (difference rounded b' a') (difference rounded c' a')) in M.
  rewrite (stands_range _ _ M).
  destruct (in_range rounded (orientation_magnitude rounded (difference rounded b' a') (difference rounded c' a'))) eqn:R;
    [|exact I].
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
  apply decide_stands; try assumption.
  - apply stands_wider with (2 := D). lia.
  - apply stands_wider with (-49 + 240)%Z; [lia|].
    exact (stands_mul (-49) 240 _ _ _ _ ltac:(lia) K (stands_mul 120 120 _ _ _ _ ltac:(lia) M' M')).
  - apply stands_zero.
  - change (0 <= value 0%float). rewrite value_zero. apply Rle_refl.
Qed.

Theorem empty_sphere_filter_stands : forall a b p q a' b' p' q',
  in_domain a a' -> in_domain b b' -> in_domain p p' -> in_domain q q' ->
  stands_answer (empty_sphere_filter machine a b p q true) (empty_sphere_filter rounded a' b' p' q' true).
Proof.
  intros a b p q a' b' p' q' A B P Q. unfold empty_sphere_filter. cbv zeta.
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
  rewrite (stands_range _ _ M). destruct (in_range rounded m') eqn:R; [|exact I].
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
  apply decide_stands; try assumption.
  - apply stands_wider with (-45 + 480)%Z; [lia|].
    exact (stands_mul (-45) 480 _ _ _ _ ltac:(lia) Ki (stands_mul 240 240 _ _ _ _ ltac:(lia) M2 M2)).
  - apply stands_wider with (-44 + 360)%Z; [lia|].
    exact (stands_mul (-44) 360 _ _ _ _ ltac:(lia) Kn (stands_mul 240 120 _ _ _ _ ltac:(lia) M2 M')).
  - assert (0 <= m') by (eapply Rle_trans; [|apply max_ge_l]; eapply Rle_trans; [|apply max_ge_l];
                          eapply Rle_trans; [|apply max_ge_l]; apply Rabs_pos).
    apply rnd_nonneg, Rmult_le_pos.
    + change (0 <= value annulus_2_norms_u). unfold value, Prim2B. rewrite B2R_SF2B. apply F2R_ge_0. easy.
    + apply rnd_nonneg, Rmult_le_pos; [|assumption]. apply rnd_nonneg, Rmult_le_pos; assumption.
Qed.
