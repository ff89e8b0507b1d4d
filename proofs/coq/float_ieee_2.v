(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The filter of the empty circle on IEEE 754 binary64 data: for all finite coordinates of the library's domain, |x| <= 2^500, it
   gives what the model of float_circle_2.v gives. Its answers are therefore right (circle_b_sound), and its tolerances certify
   (circle_b_certifies). *)
Require Import Reals Lra Psatz ZArith List Rgeom.
From Flocq Require Import Core IEEE754.BinarySingleNaN.
From Annulus Require Import float_model float_error float_terms_2 float_tail float_filter float_circle_2 float_ieee.
From Annulus Require width_2 float_certifies_2.
Import ListNotations.
Open Scope R_scope.

Definition mag_b (x y : bin) : bin := bmax (Babs x) (Babs y).
Definition in_range_b (m : bin) : bool :=
  (Bleb m (constant 1 120) && Bleb (constant 1 0) (bmul m (constant 1 120)))%bool.
Definition B_annulus := annulus_terms bin badd bsub bmul.

(* As the code has it. *)
Definition circle_b (ax ay bx by' px py qx qy : bin) : option (Z * bin) :=
  let b_x := bsub bx ax in let b_y := bsub by' ay in
  let p_x := bsub px ax in let p_y := bsub py ay in
  let q_x := bsub qx ax in let q_y := bsub qy ay in
  let e_x := bsub qx px in let e_y := bsub qy py in
  let m := bmax (bmax (mag_b b_x b_y) (mag_b p_x p_y)) (bmax (mag_b q_x q_y) (mag_b e_x e_y)) in
  if in_range_b m then
    let t := B_annulus b_x b_y p_x p_y q_x q_y e_x e_y in
    let m2 := bmul m m in
    decide_b (incircle t) (badd (bsqrt (inner t)) (bsqrt (outer t)))
      (bmul (constant 177 (-53)) (bmul m2 m2)) (bmul (constant 273 (-53)) (bmul m2 m))
  else None.

Definition coordinate (x : bin) : Prop := is_finite x = true /\ Rabs (B2R x) <= bpow radix2 500.

Lemma coordinate_rep (x : bin) : coordinate x -> rep x (B2R x) 500.
Proof. intros [A B]. now repeat split. Qed.

Lemma coordinate_F (x : bin) : F (B2R x).
Proof. exact (generic_format_B2R 53 1024 x). Qed.

Lemma rep_narrow x r k l : Rabs r <= bpow radix2 l -> rep x r k -> rep x r l.
Proof. intros L (A & B & _). now repeat split. Qed.

Lemma power_constant k : (-1074 <= k <= 1023)%Z -> rep (constant 1 k) (bpow radix2 k) k.
Proof.
  intro K. rewrite <- (Rmult_1_l (bpow radix2 k)). apply constant_rep; try lia.
  rewrite Rmult_1_l, Rabs_pos_eq by apply bpow_ge_0. apply Rle_refl.
Qed.

Lemma in_range_ieee m M : rep m M 501 -> in_range_b m = true <-> in_range 120 M.
Proof.
  intro H. unfold in_range_b, in_range. rewrite (rep_le _ _ _ _ _ _ H (power_constant 120 ltac:(lia))).
  rewrite (rep_le _ _ _ _ _ _ (power_constant 0 ltac:(lia)) (rep_mul _ _ _ _ 501 120 ltac:(lia) H (power_constant 120 ltac:(lia)))).
  rewrite Bool.andb_true_iff. change (bpow radix2 0) with 1.
  destruct (Rle_bool_spec M (bpow radix2 120)); destruct (Rle_bool_spec 1 (fmul M (bpow radix2 120)));
    (split; [intros [A B]; try discriminate; split; assumption | intros [A B]; split; try reflexivity; exfalso; lra]).
Qed.

Lemma error_bound_ieee C k p P l : (0 <= C < 2 ^ 20)%Z -> IZR C <= bpow radix2 k -> (0 <= k)%Z -> (0 <= l <= 1000 - k)%Z -> rep p P l ->
  rep (bmul (constant C (-53)) p) (error_bound C P) (k - 53 + l).
Proof.
  intros HC K K0 L H. unfold error_bound.
  replace (fmul (IZR C) u) with (IZR C * bpow radix2 (-53)).
  - apply rep_mul; [lia | | exact H]. apply constant_rep; [lia | lia | lia |].
    rewrite Rabs_pos_eq by (apply Rmult_le_pos; [apply IZR_le; lia | apply bpow_ge_0]).
    unfold Zminus. rewrite bpow_plus. apply Rmult_le_compat_r; [apply bpow_ge_0 | exact K].
  - symmetry. apply rnd_F. change u with (bpow radix2 (-53)). apply F_int; lia.
Qed.

(* Data are not to be unfolded when terms are compared. *)
Local Opaque badd bsub bmul bsqrt constant.

Theorem circle_ieee (ax ay bx by' px py qx qy : bin) :
  coordinate ax -> coordinate ay -> coordinate bx -> coordinate by' ->
  coordinate px -> coordinate py -> coordinate qx -> coordinate qy ->
  circle_filter (B2R ax) (B2R ay) (B2R bx) (B2R by') (B2R px) (B2R py) (B2R qx) (B2R qy) true =
  match circle_b ax ay bx by' px py qx qy with Some (s, v) => Some (s, B2R v) | None => None end.
Proof.
  intros Cax Cay Cbx Cby Cpx Cpy Cqx Cqy.
  apply coordinate_rep in Cax, Cay, Cbx, Cby, Cpx, Cpy, Cqx, Cqy. unfold circle_filter, circle_b. cbv zeta.
  generalize (rep_sub _ _ _ _ 500 ltac:(lia) Cbx Cax) (rep_sub _ _ _ _ 500 ltac:(lia) Cby Cay)
    (rep_sub _ _ _ _ 500 ltac:(lia) Cpx Cax) (rep_sub _ _ _ _ 500 ltac:(lia) Cpy Cay)
    (rep_sub _ _ _ _ 500 ltac:(lia) Cqx Cax) (rep_sub _ _ _ _ 500 ltac:(lia) Cqy Cay)
    (rep_sub _ _ _ _ 500 ltac:(lia) Cqx Cpx) (rep_sub _ _ _ _ 500 ltac:(lia) Cqy Cpy).
  change (500 + 1)%Z with 501%Z.
  set (b_x := fsub (B2R bx) (B2R ax)). set (b_y := fsub (B2R by') (B2R ay)).
  set (p_x := fsub (B2R px) (B2R ax)). set (p_y := fsub (B2R py) (B2R ay)).
  set (q_x := fsub (B2R qx) (B2R ax)). set (q_y := fsub (B2R qy) (B2R ay)).
  set (e_x := fsub (B2R qx) (B2R px)). set (e_y := fsub (B2R qy) (B2R py)).
  set (b_x' := bsub bx ax). set (b_y' := bsub by' ay). set (p_x' := bsub px ax). set (p_y' := bsub py ay).
  set (q_x' := bsub qx ax). set (q_y' := bsub qy ay). set (e_x' := bsub qx px). set (e_y' := bsub qy py).
  intros Hbx Hby Hpx Hpy Hqx Hqy Hex Hey.
  assert (magnitudes : forall x y X Y, rep x X 501 -> rep y Y 501 -> rep (mag_b x y) (mag X Y) 501).
  { intros. apply rep_max; now apply rep_abs. }
  generalize (rep_max _ _ _ _ _ (rep_max _ _ _ _ _ (magnitudes _ _ _ _ Hbx Hby) (magnitudes _ _ _ _ Hpx Hpy))
                                (rep_max _ _ _ _ _ (magnitudes _ _ _ _ Hqx Hqy) (magnitudes _ _ _ _ Hex Hey))).
  set (m' := bmax _ (bmax _ _)). set (m := Rmax (Rmax (mag b_x b_y) (mag p_x p_y)) (Rmax (mag q_x q_y) (mag e_x e_y))).
  intro Hm. generalize (in_range_ieee m' m Hm). intro Range.
  destruct (in_range_dec 120 m) as [In | Out].
  2: { destruct (in_range_b m'); [exfalso; tauto | reflexivity]. }
  rewrite (proj2 Range In). clear Range.
  assert (M : bpow radix2 (-120) <= m) by (apply (in_range_lower 120); [lia | now apply rep_F with (1 := Hm) | exact In]).
  generalize (m_positive m M) u_bounds. intros M0 U.
  assert (Hm' : rep m' m 120) by (apply rep_narrow with (2 := Hm); rewrite Rabs_pos_eq by lra; apply In).
  assert (Bb : mag b_x b_y <= m) by (apply Rle_trans with (2 := Rmax_l _ _); apply Rmax_l).
  assert (Bp : mag p_x p_y <= m) by (apply Rle_trans with (2 := Rmax_l _ _); apply Rmax_r).
  assert (Bq : mag q_x q_y <= m) by (apply Rle_trans with (2 := Rmax_r _ _); apply Rmax_l).
  assert (Be : mag e_x e_y <= m) by (apply Rle_trans with (2 := Rmax_r _ _); apply Rmax_r).
  generalize (Rabs_le_mag b_x b_y) (Rabs_le_mag p_x p_y) (Rabs_le_mag q_x q_y) (Rabs_le_mag e_x e_y) (proj1 In).
  intros [Bbx Bby] [Bpx Bpy] [Bqx Bqy] [Bex Bey] Top.
  (* terms *)
  set (x := fun n => nth n [b_x'; b_y'; p_x'; p_y'; q_x'; q_y'; e_x'; e_y'] (constant 0 0)).
  set (r := env [b_x; b_y; p_x; p_y; q_x; q_y; e_x; e_y]).
  assert (R : forall n, rep (x n) (r n) 120).
  { intro n. unfold x, r, env. do 8 (destruct n as [| n]; [cbn [nth]; eapply rep_narrow; [| eassumption]; lra |]).
    assert (Z : rep (constant 0 0) 0 120).
    { split; [reflexivity |]. split; [reflexivity |]. rewrite Rabs_R0. apply bpow_ge_0. }
    destruct n; exact Z. }
  generalize (ieee_terms 120 x r ltac:(lia) R (incircle E_annulus) ltac:(vm_compute; discriminate))
    (ieee_terms 120 x r ltac:(lia) R (inner E_annulus) ltac:(vm_compute; discriminate))
    (ieee_terms 120 x r ltac:(lia) R (outer E_annulus) ltac:(vm_compute; discriminate)).
  change (ieee x (incircle E_annulus)) with (incircle (B_annulus b_x' b_y' p_x' p_y' q_x' q_y' e_x' e_y')).
  change (ieee x (inner E_annulus)) with (inner (B_annulus b_x' b_y' p_x' p_y' q_x' q_y' e_x' e_y')).
  change (ieee x (outer E_annulus)) with (outer (B_annulus b_x' b_y' p_x' p_y' q_x' q_y' e_x' e_y')).
  change (rounded r (incircle E_annulus)) with (incircle (F_annulus b_x b_y p_x p_y q_x q_y e_x e_y)).
  change (rounded r (inner E_annulus)) with (inner (F_annulus b_x b_y p_x p_y q_x q_y e_x e_y)).
  change (rounded r (outer E_annulus)) with (outer (F_annulus b_x b_y p_x p_y q_x q_y e_x e_y)).
  set (t' := B_annulus b_x' b_y' p_x' p_y' q_x' q_y' e_x' e_y'). set (t := F_annulus b_x b_y p_x p_y q_x q_y e_x e_y).
  intros Ti Tn To.
  assert (I0 : 0 <= inner t) by (apply rnd_pos; generalize (fmul_square_pos (nx t)) (fmul_square_pos (ny t)); apply Rplus_le_le_0_compat).
  assert (O0 : 0 <= outer t) by (apply rnd_pos; generalize (fmul_square_pos (mx t)) (fmul_square_pos (my t)); apply Rplus_le_le_0_compat).
  assert (Sn : rep (bsqrt (inner t')) (rnd (sqrt (inner t))) 370).
  { apply rep_sqrt; [lia | exact I0 |]. eapply rep_wider; [| exact Tn]. vm_compute. discriminate. }
  assert (So : rep (bsqrt (outer t')) (rnd (sqrt (outer t))) 370).
  { apply rep_sqrt; [lia | exact O0 |]. eapply rep_wider; [| exact To]. vm_compute. discriminate. }
  generalize (rep_mul _ _ _ _ 120 120 ltac:(lia) Hm' Hm'). intro H2.
  generalize (rep_mul _ _ _ _ (120 + 120) (120 + 120) ltac:(lia) H2 H2) (rep_mul _ _ _ _ (120 + 120) 120 ltac:(lia) H2 Hm'). intros H4 H3.
  assert (K8 : IZR 177 <= bpow radix2 8) by (change (bpow radix2 8) with 256; lra).
  assert (K9 : IZR 273 <= bpow radix2 9) by (change (bpow radix2 9) with 512; lra).
  apply decide_ieee.
  - eapply rep_wider; [| exact Ti]. vm_compute. discriminate.
  - apply rep_wider with (370 + 1)%Z; [lia |]. apply rep_add; [lia | exact Sn | exact So].
  - eapply rep_wider; [| exact (error_bound_ieee 177 8 _ _ (120 + 120 + (120 + 120)) ltac:(lia) K8 ltac:(lia) ltac:(lia) H4)]. lia.
  - eapply rep_wider; [| exact (error_bound_ieee 273 9 _ _ (120 + 120 + 120) ltac:(lia) K9 ltac:(lia) ltac:(lia) H3)]. lia.
  - apply rnd_pos. apply Rplus_le_le_0_compat; apply rnd_pos, sqrt_pos.
  - generalize (error_bound_range m M 273 _ 3 ltac:(lia) ltac:(lia) (widen m M _ _ 4 4 ltac:(lra) ltac:(lra) (power_3_range m M))).
    intros [L _]. apply Rle_trans with (2 := L).
    assert (P3 : bpow radix2 (-360) <= m ^ 3) by exact (pow_large m M 3).
    apply Rle_trans with (bpow radix2 (-53) * bpow radix2 (-360)).
    + rewrite <- bpow_plus. apply bpow_le. lia.
    + apply mul_below; try apply bpow_ge_0; [change (bpow radix2 (-53)) with u; unfold u; lra | exact P3].
Qed.

Theorem circle_b_sound (ax ay bx by' px py qx qy : bin) sign value :
  coordinate ax -> coordinate ay -> coordinate bx -> coordinate by' ->
  coordinate px -> coordinate py -> coordinate qx -> coordinate qy ->
  circle_b ax ay bx by' px py qx qy = Some (sign, value) ->
  let t := circle_truth (B2R ax) (B2R ay) (B2R bx) (B2R by') (B2R px) (B2R py) (B2R qx) (B2R qy) in
  sign = 1%Z /\ 0 < incircle t /\ 0 <= B2R value <= incircle t / (sqrt (inner t) + sqrt (outer t)) \/
  sign = (-1)%Z /\ incircle t < 0.
Proof.
  intros A B C D E G H I S t. generalize (circle_ieee _ _ _ _ _ _ _ _ A B C D E G H I). rewrite S. intro J.
  destruct (circle_filter_sound (B2R ax) (B2R ay) (B2R bx) (B2R by') (B2R px) (B2R py) (B2R qx) (B2R qy) true
    (coordinate_F _) (coordinate_F _) (coordinate_F _) (coordinate_F _) (coordinate_F _) (coordinate_F _) (coordinate_F _)
    (coordinate_F _) _ _ J) as [(P & Q & V) | ?]; [left | now right].
  split; [exact P |]. split; [exact Q | now apply V].
Qed.

Theorem circle_b_certifies (fax fay fbx fby fpx fpy fqx fqy tolerance : bin) (ax ay bx by' px py qx qy : R) :
  coordinate fax -> coordinate fay -> coordinate fbx -> coordinate fby ->
  coordinate fpx -> coordinate fpy -> coordinate fqx -> coordinate fqy ->
  circle_b fax fay fbx fby fpx fpy fqx fqy = Some (1%Z, tolerance) ->
  0 < width_2.turn (B2R fax) (B2R fay) (B2R fbx) (B2R fby) (B2R fqx) (B2R fqy) ->
  0 < width_2.turn (B2R fbx) (B2R fby) (B2R fax) (B2R fay) (B2R fpx) (B2R fpy) ->
  0 < width_2.turn ax ay bx by' qx qy -> 0 < width_2.turn bx by' ax ay px py ->
  dist_euc ax ay (B2R fax) (B2R fay) < B2R tolerance -> dist_euc bx by' (B2R fbx) (B2R fby) < B2R tolerance ->
  dist_euc px py (B2R fpx) (B2R fpy) < B2R tolerance -> dist_euc qx qy (B2R fqx) (B2R fqy) < B2R tolerance ->
  0 < width_2.incircle ax ay bx by' px py qx qy.
Proof.
  intros A B C D E G H I S. generalize (circle_ieee _ _ _ _ _ _ _ _ A B C D E G H I). rewrite S. intro J.
  apply (float_certifies_2.filter_certifies_circle _ _ _ _ _ _ _ _ (B2R tolerance)); try apply coordinate_F. exact J.
Qed.
