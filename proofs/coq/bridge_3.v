(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* bridge_2.v in space: the filter of filter_3.v says the same in primitive floats and in rounded reals, for all points of the coordinate domain.
   No operation overflows that matters.

   - orientation_filter_3_stands, bicell_filter_stands: same refusal, same sign, and a certified tolerance stands for the real one *)
From Coq Require Import Reals ZArith Lia Lra Bool.
From Flocq Require Import Core IEEE754.BinarySingleNaN IEEE754.PrimFloat.
From Coq Require Import Floats.
From Annulus Require Import operations bridge bridge_decide filter_2 filter_3 bridge_terms_3.
Close Scope float_scope.
Open Scope R_scope.

(* ---- Range and error bounds ---- *)

Definition in_domain_3 (v : vector_3 machine) (w : vector_3 rounded) := stands_vector_3 500 v w.

Lemma rounded_difference_3 : forall v w v' w', in_domain_3 v v' -> in_domain_3 w w' ->
  stands_vector_3 501 (difference_3 machine v w) (difference_3 rounded v' w').
Proof. intros. apply (vector_difference 500); trivial; lia. Qed.

Lemma stands_largest_3 : forall a v w, stands_vector_3 a v w -> stands a (largest_3 machine v) (largest_3 rounded w).
Proof. intros a v w (A & B & C). repeat apply stands_max_same; now apply stands_abs. Qed.

Lemma tighter_vector_3 : forall a b v w, stands_vector_3 a v w -> largest_3 rounded w <= power b -> stands_vector_3 b v w.
Proof.
  intros a b v w (A & B & C) H. assert (H' := Rle_trans _ _ _ (max_ge_l _ _) H).
  each; (eapply stands_tighter; [eassumption|]).
  - exact (Rle_trans _ _ _ (max_ge_l _ _) H').
  - exact (Rle_trans _ _ _ (max_ge_r _ _) H').
  - exact (Rle_trans _ _ _ (max_ge_r _ _) H).
Qed.

Lemma stands_range_3 : forall m r, stands 501 m r -> in_range_3 machine m = in_range_3 rounded r.
Proof.
  intros m r H. apply (stands_in_range filter_range_3 100); [eapply stands_constant; [reflexivity| |]; vm_compute; easy|lia|exact H].
Qed.

(* In the range m is at most 2^100, and 2^-101 at least. *)
Lemma range_3_bounds : forall r, in_range_3 rounded r = true -> power (-101) <= r <= power 100.
Proof.
  intros r H. unfold in_range_3 in H. simpl in H. apply andb_prop in H. destruct H as [H L]. rewrite value_range_3 in H, L.
  split; [|revert H; case Rle_bool_spec; easy]. apply Rnot_lt_le. intro N. revert L. case Rle_bool_spec; [|easy]. intros L _.
  apply (Rle_not_lt _ _ L). rewrite (value_power 1%float (-52) eq_refl). apply Rle_lt_trans with (power (-1)); [|apply bpow_lt; lia].
  rewrite <- (rnd_power (-1)) by lia. apply round_le; auto with typeclass_instances.
  change (-1)%Z with (-101 + 100)%Z. rewrite bpow_plus. apply Rmult_le_compat_r; [apply bpow_ge_0|now apply Rlt_le].
Qed.

(* A constant times u, at least 2^-53. *)
Definition stands_unit (a : Z) (f : float) := stands a f (value f) /\ power (-53) <= value f.

Lemma unit_stands : forall a f m e, Prim2SF f = S754_finite false m e -> (e <= a)%Z -> (Z.pos m <= 2 ^ (a - e))%Z -> (-105 <= e)%Z ->
  (2 ^ 52 <= Z.pos m)%Z -> stands_unit a f.
Proof.
  intros a f m e H E M L N. split; [now apply stands_constant with m e|]. rewrite (value_of f m e H).
  change (-53)%Z with (52 + -105)%Z. rewrite bpow_plus. apply Rmult_le_compat; try apply bpow_ge_0; [|now apply bpow_le].
  change (power 52) with (IZR (2 ^ 52)). now apply IZR_le.
Qed.

Ltac unit_constant := eapply unit_stands; [reflexivity| | | |]; vm_compute; easy.
Lemma unit_orientation : stands_unit (-47) orientation_3_u. Proof. unit_constant. Qed.
Lemma unit_orientation_norms : stands_unit (-46) orientation_3_norms_u. Proof. unit_constant. Qed.
Lemma unit_insphere : stands_unit (-42) annulus_3_insphere_u. Proof. unit_constant. Qed.
Lemma unit_norms : stands_unit (-41) annulus_3_norms_u. Proof. unit_constant. Qed.
Lemma unit_side : stands_unit (-45) annulus_3_side_u. Proof. unit_constant. Qed.

Section powers.
Variables (m : float) (m' : R).
Hypothesis M : stands 100 m m'.
Hypothesis M' : power (-101) <= m'.

Lemma power_at_least : forall i j r s, (-1074 <= i + j)%Z -> power i <= r -> power j <= s -> power (i + j) <= rnd (r * s).
Proof.
  intros i j r s H R S. apply rnd_at_least; [exact H|]. rewrite bpow_plus. apply Rmult_le_compat; trivial; apply bpow_ge_0.
Qed.

Let M2 : stands 200 (m * m)%float (rnd (m' * m')). Proof. exact (stands_mul 100 100 _ _ _ _ ltac:(lia) M M). Qed.
Let P2 : power (-202) <= rnd (m' * m'). Proof. exact (power_at_least (-101) (-101) _ _ ltac:(lia) M' M'). Qed.
Let M3 : stands 300 (m * m * m)%float (rnd (rnd (m' * m') * m')). Proof. exact (stands_mul 200 100 _ _ _ _ ltac:(lia) M2 M). Qed.
Let M4 : stands 400 (m * m * (m * m))%float (rnd (rnd (m' * m') * rnd (m' * m'))). Proof. exact (stands_mul 200 200 _ _ _ _ ltac:(lia) M2 M2). Qed.

Lemma width_error_stands : stands 260 (width_error machine m) (width_error rounded m').
Proof. apply stands_wider with (-47 + 300)%Z; [lia|]. exact (stands_mul (-47) 300 _ _ _ _ ltac:(lia) (proj1 unit_orientation) M3). Qed.
Lemma width_norms_stands : stands 160 (width_norms machine m) (width_norms rounded m') /\ power (-460) <= width_norms rounded m'.
Proof.
  split.
  - apply stands_wider with (-46 + 200)%Z; [lia|]. exact (stands_mul (-46) 200 _ _ _ _ ltac:(lia) (proj1 unit_orientation_norms) M2).
  - apply Rle_trans with (power (-53 + -202)); [apply bpow_le; lia|].
    exact (power_at_least (-53) (-202) _ _ ltac:(lia) (proj2 unit_orientation_norms) P2).
Qed.
Lemma bicell_error_stands : stands 460 (bicell_error machine m) (bicell_error rounded m').
Proof.
  apply stands_wider with (-42 + 500)%Z; [lia|].
  exact (stands_mul (-42) 500 _ _ _ _ ltac:(lia) (proj1 unit_insphere) (stands_mul 400 100 _ _ _ _ ltac:(lia) M4 M)).
Qed.
Lemma bicell_norms_stands : stands 360 (bicell_norms machine m) (bicell_norms rounded m') /\ power (-460) <= bicell_norms rounded m'.
Proof.
  split.
  - apply stands_wider with (-41 + 400)%Z; [lia|]. exact (stands_mul (-41) 400 _ _ _ _ ltac:(lia) (proj1 unit_norms) M4).
  - apply Rle_trans with (power (-53 + (-202 + -202))); [apply bpow_le; lia|].
    exact (power_at_least (-53) (-202 + -202) _ _ ltac:(lia) (proj2 unit_norms) (power_at_least (-202) (-202) _ _ ltac:(lia) P2 P2)).
Qed.
Lemma side_error_stands : stands 260 (side_error machine m) (side_error rounded m').
Proof. apply stands_wider with (-45 + 300)%Z; [lia|]. exact (stands_mul (-45) 300 _ _ _ _ ltac:(lia) (proj1 unit_side) M3). Qed.

Lemma decide_width_stands : forall certified d l d' l', stands 303 d d' -> stands 408 l l' /\ 0 <= l' ->
  stands_said certified (decide_width machine d l m certified) (decide_width rounded d' l' m' certified).
Proof.
  intros certified d l d' l' D [L L0]. destruct width_norms_stands as [N N0].
  assert (T : stands 1 2%float (value 2%float)) by (eapply stands_constant; [reflexivity| |]; vm_compute; easy).
  pose proof (stands_mul 1 204 _ _ _ _ ltac:(lia) T (stands_sqrt 204 _ _ ltac:(lia) L L0)) as Rt.
  apply (decide_said 303 205 (-460)); try assumption.
  - lia.
  - apply stands_wider with 260%Z; [lia|]. exact width_error_stands.
  - apply stands_wider with 160%Z; [lia|]. exact N.
  - intros _. apply Rle_trans with (1 := N0). rewrite <- (Rplus_0_l (width_norms rounded m')) at 1. apply Rplus_le_compat_r.
    apply rnd_nonneg, Rmult_le_pos; [|apply rnd_nonneg, sqrt_pos].
    change (0 <= value 2%float). rewrite (value_power 2%float (-51) eq_refl). apply bpow_ge_0.
Qed.

Lemma norms_stand : forall k k', partition_stands k k' -> stands 410 (norms machine k) (norms rounded k') /\ 0 <= norms rounded k'.
Proof.
  intros k k' ((I & I0) & (O & O0) & _). split.
  - apply (stands_add_same 409); [lia| |]; apply stands_sqrt; trivial; lia.
  - apply rnd_nonneg, Rplus_le_le_0_compat; apply rnd_nonneg, sqrt_pos.
Qed.

Lemma wrong_side_stands : forall k k', partition_stands k k' -> wrong_side machine m k = wrong_side rounded m' k'.
Proof. intros k k' (_ & _ & S). unfold wrong_side. f_equal. exact (stands_ltb _ _ _ _ _ _ side_error_stands S). Qed.

Lemma certainly_wrong_side_stands : forall k k', partition_stands k k' -> certainly_wrong_side machine m k = certainly_wrong_side rounded m' k'.
Proof. intros k k' (_ & _ & S). exact (stands_ltb _ _ _ _ _ _ S (stands_opp _ _ _ side_error_stands)). Qed.
End powers.

(* ---- Answers ---- *)

Lemma both_stands : forall certified needed l r l' r', stands_said certified l l' -> stands_said certified r r' ->
  stands_said certified (both machine needed l r) (both rounded needed l' r').
Proof.
  intros certified needed [|s|s|s] [|t|t|t] [|s'|s'|s'] [|t'|t'|t'] L R; destruct certified; try contradiction; destruct needed; try exact I; try exact L.
  destruct L as [F <-], R as [G <-]. simpl. rewrite less_of_values by assumption. case Rlt_bool; split; trivial.
Qed.

(* Without certified tolerances nothing is in doubt. *)
Lemma unless_stands : forall certified doubt l r l' r', (certified = false -> doubt = false) -> stands_said certified l l' -> stands_said certified r r' ->
  stands_said certified (unless machine doubt l r) (unless rounded doubt l' r').
Proof.
  intros certified doubt [|s|s|s] [|t|t|t] [|s'|s'|s'] [|t'|t'|t'] N L R; destruct certified; try contradiction; try exact I; try exact R.
  - destruct L as [F <-], R as [G <-]. simpl. rewrite less_of_values by assumption. case (_ && _)%bool; [exact I|]. split; trivial.
  - rewrite N by reflexivity. exact I.
Qed.

Theorem orientation_filter_3_stands : forall certified a b c d a' b' c' d',
  in_domain_3 a a' -> in_domain_3 b b' -> in_domain_3 c c' -> in_domain_3 d d' ->
  stands_said certified (orientation_filter_3 machine a b c d certified) (orientation_filter_3 rounded a' b' c' d' certified).
Proof.
  intros certified a b c d a' b' c' d' A B C D. unfold orientation_filter_3. cbv zeta.
  pose proof (rounded_difference_3 _ _ _ _ B A) as U. pose proof (rounded_difference_3 _ _ _ _ C A) as V.
  pose proof (rounded_difference_3 _ _ _ _ D A) as W.
  set (u := difference_3 machine b a) in *. set (v := difference_3 machine c a) in *. set (w := difference_3 machine d a) in *.
  set (u' := difference_3 rounded b' a') in *. set (v' := difference_3 rounded c' a') in *. set (w' := difference_3 rounded d' a') in *.
  assert (magnitude : forall k, stands_vector_3 k u u' -> stands_vector_3 k v v' -> stands_vector_3 k w w' ->
    stands k (orientation_magnitude_3 machine u v w) (orientation_magnitude_3 rounded u' v' w')).
  { intros. apply stands_max_same; [apply stands_max_same|]; now apply stands_largest_3. }
  rewrite (stands_range_3 _ _ (magnitude _ U V W)).
  destruct (in_range_3 rounded (orientation_magnitude_3 rounded u' v' w')) eqn:E; [|now destruct certified].
  apply range_3_bounds in E. destruct E as [Low High].
  assert (H := Rle_trans _ _ _ (max_ge_l _ _) High).
  apply (tighter_vector_3 _ 100) in U; [|exact (Rle_trans _ _ _ (max_ge_l _ _) H)].
  apply (tighter_vector_3 _ 100) in V; [|exact (Rle_trans _ _ _ (max_ge_r _ _) H)].
  apply (tighter_vector_3 _ 100) in W; [|exact (Rle_trans _ _ _ (max_ge_r _ _) High)].
  destruct (orientation_terms_3_stand _ _ _ _ _ _ U V W) as [Det Slab].
  exact (decide_width_stands _ _ (magnitude _ U V W) Low _ _ _ _ _ Det Slab).
Qed.

Section empty_sphere.
Variables (b c p q : vector_3 machine) (b' c' p' q' : vector_3 rounded).
Hypothesis Hb : stands_vector_3 100 b b'.
Hypothesis Hc : stands_vector_3 100 c c'.
Hypothesis Hp : stands_vector_3 100 p p'.
Hypothesis Hq : stands_vector_3 100 q q'.
Let m := bicell_magnitude machine b c p q.
Let m' := bicell_magnitude rounded b' c' p' q'.
Hypothesis M : stands 100 m m'.
Hypothesis M' : power (-101) <= m'.
Let t := bicell machine b c p q.
Let t' := bicell rounded b' c' p' q'.

Definition largest_norms o (t : bicell_terms o) :=
  greater o (greater o (norms o (abc_pq o t)) (norms o (ab_cpq o t))) (greater o (norms o (ca_bpq o t)) (norms o (bc_apq o t))).

Lemma annuli_stand : forall certified, stands_said certified
  (decide machine (insphere _ t) (largest_norms _ t) (bicell_error machine m) (bicell_norms machine m) certified)
  (decide rounded (insphere _ t') (largest_norms _ t') (bicell_error rounded m') (bicell_norms rounded m') certified).
Proof.
  intro certified.
  destruct (bicell_stands _ _ _ _ _ _ _ _ Hb Hc Hp Hq) as (Det & (K1 & K2 & K3 & K4) & _).
  destruct (norms_stand _ _ K1) as [N1 P1]. destruct (norms_stand _ _ K2) as [N2 P2].
  destruct (norms_stand _ _ K3) as [N3 P3]. destruct (norms_stand _ _ K4) as [N4 P4].
  destruct (bicell_norms_stands _ _ M M') as [N N0].
  apply (decide_said 507 410 (-460)).
  - lia.
  - exact Det.
  - exact (stands_max_same _ _ _ _ _ (stands_max_same _ _ _ _ _ N1 N2) (stands_max_same _ _ _ _ _ N3 N4)).
  - apply stands_wider with 460%Z; [lia|]. exact (bicell_error_stands _ _ M).
  - apply stands_wider with 360%Z; [lia|]. exact N.
  - intros _. apply Rle_trans with (1 := N0). rewrite <- (Rplus_0_l (bicell_norms rounded m')) at 1. apply Rplus_le_compat_r.
    apply Rle_trans with (1 := P1). apply Rle_trans with (2 := max_ge_l _ _). apply max_ge_l.
Qed.
End empty_sphere.

Theorem bicell_filter_stands : forall certified a b c p q a' b' c' p' q' cells,
  in_domain_3 a a' -> in_domain_3 b b' -> in_domain_3 c c' -> in_domain_3 p p' -> in_domain_3 q q' ->
  stands_said certified (bicell_filter machine a b c p q certified cells) (bicell_filter rounded a' b' c' p' q' certified cells).
Proof.
  intros certified a b c p q a' b' c' p' q' cells A B C P Q. unfold bicell_filter. cbv zeta.
  apply (rounded_difference_3 _ _ _ _ B) in A as B1. apply (rounded_difference_3 _ _ _ _ C) in A as C1.
  apply (rounded_difference_3 _ _ _ _ P) in A as P1. apply (rounded_difference_3 _ _ _ _ Q) in A as Q1.
  set (vb := difference_3 machine b a) in *. set (vc := difference_3 machine c a) in *.
  set (vp := difference_3 machine p a) in *. set (vq := difference_3 machine q a) in *.
  set (wb := difference_3 rounded b' a') in *. set (wc := difference_3 rounded c' a') in *.
  set (wp := difference_3 rounded p' a') in *. set (wq := difference_3 rounded q' a') in *.
  assert (magnitude : forall k, stands_vector_3 k vb wb -> stands_vector_3 k vc wc -> stands_vector_3 k vp wp -> stands_vector_3 k vq wq ->
    stands k (bicell_magnitude machine vb vc vp vq) (bicell_magnitude rounded wb wc wp wq)).
  { intros. apply stands_max_same; apply stands_max_same; now apply stands_largest_3. }
  rewrite (stands_range_3 _ _ (magnitude _ B1 C1 P1 Q1)).
  destruct (in_range_3 rounded (bicell_magnitude rounded wb wc wp wq)) eqn:E; [|now destruct certified].
  apply range_3_bounds in E. destruct E as [Low High].
  assert (H := Rle_trans _ _ _ (max_ge_l _ _) High). assert (H' := Rle_trans _ _ _ (max_ge_r _ _) High).
  apply (tighter_vector_3 _ 100) in B1; [|exact (Rle_trans _ _ _ (max_ge_l _ _) H)].
  apply (tighter_vector_3 _ 100) in C1; [|exact (Rle_trans _ _ _ (max_ge_r _ _) H)].
  apply (tighter_vector_3 _ 100) in P1; [|exact (Rle_trans _ _ _ (max_ge_l _ _) H')].
  apply (tighter_vector_3 _ 100) in Q1; [|exact (Rle_trans _ _ _ (max_ge_r _ _) H')].
  assert (M := magnitude _ B1 C1 P1 Q1). clear magnitude.
  pose proof (annuli_stand _ _ _ _ _ _ _ _ B1 C1 P1 Q1 M Low certified) as Annuli.
  destruct (bicell_stands _ _ _ _ _ _ _ _ B1 C1 P1 Q1) as (_ & (_ & K2 & K3 & K4) & (Dp & Lp) & (Dq & Lq)).
  pose proof (decide_width_stands _ _ M Low certified _ _ _ _ Dp Lp) as Wp. pose proof (decide_width_stands _ _ M Low certified _ _ _ _ Dq Lq) as Wq.
  rewrite (wrong_side_stands _ _ M _ _ K2), (wrong_side_stands _ _ M _ _ K3), (wrong_side_stands _ _ M _ _ K4).
  rewrite (certainly_wrong_side_stands _ _ M _ _ K2), (certainly_wrong_side_stands _ _ M _ _ K3), (certainly_wrong_side_stands _ _ M _ _ K4).
  apply unless_stands; [now intros ->; destruct cells|exact Annuli|]. apply both_stands; [|exact Wq]. apply both_stands; [exact Annuli|exact Wp].
Qed.
