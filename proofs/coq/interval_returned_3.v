(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The interval stage in space, for finite doubles of the coordinate domain and the very operations that are replayed (interval_3.v), overflow,
   underflow and the scale within the theorem.

   - orientation_3_interval_returned, empty_sphere_3_interval_returned   a sign is right; a tolerance is a finite number, at most the half widths *)
From Coq Require Import Reals Lra ZArith List Bool.
From Flocq Require Import Core IEEE754.BinarySingleNaN.
From Coq Require Import Floats.
From Annulus Require Import vectors bicell tetrahedron sign_tolerance_3.
From Annulus Require Import operations bridge connect filter_2 stages float_directed interval_2 interval_3 float_interval interval_tail.
From Annulus Require Import integers_2 integers_3 real_terms_3 scaled_3 interval_terms_3 returned_2 interval_returned_2 returned_3.
Import ListNotations vectors bicell tetrahedron filter_3.
Close Scope float_scope.
Open Scope R_scope.
Notation half := integers_2.half_width.

Lemma vector_3_encloses s v w : good_scale s -> coordinates_3 v -> coordinates_3 w ->
  holds_vector_3 (i_vector_3 s v w) (to_reals (scale_factor s ⊙ (at_3 v ⊖ at_3 w))).
Proof.
  intros G (A & B & C) (D & E & F). unfold holds_vector_3, to_reals, scale. cbn [x3 y3 z3].
  split; [|split]; cbn [X1 X2 X3]; rewrite Rmult_comm; apply holds_difference; trivial; first [apply A|apply B|apply C|apply D|apply E|apply F].
Qed.
Lemma pairs_3_coordinates v w i j : coordinates_3 v -> coordinates_3 w -> In (i, j) (pairs_3 v w) -> coordinate i /\ coordinate j.
Proof. intros (A & B & C) (D & E & F) [H|[H|[H|[]]]]; injection H as <- <-; auto. Qed.

(* ---- A tetrahedron ---- *)

Section orientation.
Variable f : corner -> vector_3 machine.
Hypothesis domain : forall k, coordinates_3 (f k).
Let x : corners := fun k => at_3 (f k).

Theorem orientation_3_interval_returned :
  right_answer (orientation_3_interval (f o) (f tetrahedron.u) (f v) (f w)) (volume x) (half_width_simplex x).
Proof.
  unfold orientation_3_interval. cbv zeta. set (s := scale_of _). assert (G : good_scale s).
  { apply scale_good. intros i j I. apply in_app_or in I.
    destruct I as [I|I]; [|apply in_app_or in I; destruct I as [I|I]]; revert I; apply pairs_3_coordinates; apply domain. }
  assert (K : 0 < scale_factor s) by (apply Rmult_lt_0_compat; apply G). set (k := scale_factor s) in *.
  assert (E := tetrahedron_encloses _ _ _ _ _ _ (vector_3_encloses s _ _ G (domain tetrahedron.u) (domain o)) (vector_3_encloses s _ _ G (domain v) (domain o))
    (vector_3_encloses s _ _ G (domain w) (domain o))). fold k in E. cbv zeta in E.
  assert (D : forall i j, scaled k x i ⊖ scaled k x j = k ⊙ (at_3 (f i) ⊖ at_3 (f j))) by (intros i j; unfold scaled, x; generalize (at_3 (f i)) (at_3 (f j)); vector).
  rewrite <- !D in E. destruct (tetrahedron_half (scaled k x)) as (V & I & O & H). rewrite volume_scaled in V, H. rewrite simplex_scaled in H by exact K.
  assert (K3 : 0 < k * k * k) by (apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat|]; exact K).
  apply right_unscaled with (1 := K3). rewrite <- V. apply accept_right; trivial. rewrite V. intro P. destruct (H P) as [W R].
  split; [rewrite W; apply Rmult_comm|exact R].
Qed.
End orientation.

(* ---- A bi-cell ---- *)

Definition real_roots (k : partition reals) : R := R_sqrt.sqrt (inner_3 _ k) + R_sqrt.sqrt (outer_3 _ k).

Lemma roots_above k k' : holds_partition k k' -> 0 <= inner_3 _ k' -> 0 <= outer_3 _ k' -> above (roots upper k) (real_roots k').
Proof. intros ([_ I] & [_ O] & _) PI PO. now apply sum_of_roots_above. Qed.

(* The lower end of a quotient by the greatest sum is at most each quotient. *)
Lemma smaller_quotient d r m s : 0 < d -> 0 < r -> r <= m -> s <= d / m -> s <= d / r.
Proof. intros D P L H. apply Rle_trans with (1 := H). unfold Rdiv. apply Rmult_le_compat_l; [lra|]. now apply Rinv_le. Qed.

Section accept.
Variables (t : bicell_terms intervals) (x : placement) (k : R) (s : option (double * double)).
Hypothesis good : good_scale s.
Hypothesis factor : k = scale_factor s.
Variable t' : bicell_terms reals.                    (* a variable, so that nothing computes it *)
Hypothesis is_real : real_bicell (scaled k x) = t'.
Hypothesis encloses : holds (insphere _ t) (insphere _ t') /\
  (holds_partition (abc_pq _ t) (abc_pq _ t') /\ holds_partition (ab_cpq _ t) (ab_cpq _ t') /\
   holds_partition (ca_bpq _ t) (ca_bpq _ t') /\ holds_partition (bc_apq _ t) (bc_apq _ t')) /\
  (holds (cell_p _ t) (cell_p _ t') /\ holds (cell_q _ t) (cell_q _ t')) /\
  (holds (cell_p_slab _ t) (cell_p_slab _ t') /\ holds (cell_q_slab _ t) (cell_q_slab _ t')).

Lemma factor_positive : 0 < k.
Proof. rewrite factor. apply Rmult_lt_0_compat; apply good. Qed.

Lemma Rmin_factor r e : Rmin (r * k) (e * k) = Rmin r e * k.
Proof. assert (K := factor_positive). unfold Rmin. destruct (Rle_dec r e) as [L|L], (Rle_dec (r * k) (e * k)) as [M|M]; trivial; nra. Qed.

(* The annuli. *)
Lemma annuli_lower low : below nought (lower (insphere _ t)) = true ->
  quotient_lower_in_slack (insphere _ t) (greatest (roots upper) t) (greatest (roots lower) t) = Some low ->
  0 < det x /\ is_finite low = true /\ 0 <= B2R low <= annuli_half_width x * k.
Proof.
  intros P T. destruct encloses as (D & (E1 & E2 & E3 & E4) & _). destruct (positive_end _ _ P D) as (_ & L). assert (K := factor_positive).
  assert (Num := proj1 (terms_are_numbers (scaled k x))). rewrite is_real in Num.
  assert (Di : 0 < insphere _ t') by lra. assert (D' : 0 < det (scaled k x)) by (rewrite <- Num; exact Di).
  assert (Dx : 0 < det x). { rewrite det_scaled in D' by exact K. destruct (powers_positive k K) as (_ & _ & K4).
  apply Rmult_lt_reg_l with (k * (k * k * k * k)); [now apply Rmult_lt_0_compat|]. now rewrite Rmult_0_r. }
  split; [exact Dx|]. assert (A := annuli_half (scaled k x) D'). rewrite is_real in A.
  destruct (A (abc_pq _ t') ltac:(simpl; tauto)) as (I1 & O1 & R1). destruct (A (ab_cpq _ t') ltac:(simpl; tauto)) as (I2 & O2 & R2).
  destruct (A (ca_bpq _ t') ltac:(simpl; tauto)) as (I3 & O3 & R3). destruct (A (bc_apq _ t') ltac:(simpl; tauto)) as (I4 & O4 & R4).
  fold (real_roots (abc_pq _ t')) in R1. fold (real_roots (ab_cpq _ t')) in R2. fold (real_roots (ca_bpq _ t')) in R3. fold (real_roots (bc_apq _ t')) in R4.
  set (M := Rmax (Rmax (Rmax (Rmax 0 (real_roots (abc_pq _ t'))) (real_roots (ab_cpq _ t'))) (real_roots (ca_bpq _ t'))) (real_roots (bc_apq _ t'))).
  assert (G : above (greatest (roots upper) t) M).
  { unfold greatest. simpl fold_left. unfold M. repeat apply above_most; try (apply roots_above; assumption). left. split; [reflexivity|apply Rle_refl]. }
  assert (M1 : real_roots (abc_pq _ t') <= M) by (unfold M; leaf). assert (M2 : real_roots (ab_cpq _ t') <= M) by (unfold M; leaf).
  assert (M3 : real_roots (ca_bpq _ t') <= M) by (unfold M; leaf). assert (M4 : real_roots (bc_apq _ t') <= M) by (unfold M; leaf).
  destruct (in_slack_lower _ _ _ _ _ M P D ltac:(lra) G T) as (F & Q0 & Q). split; [exact F|]. split; [exact Q0|].
  assert (H : B2R low <= annuli_half_width (scaled k x)).
  { rewrite annuli_are by exact D'. rewrite is_real. repeat apply Rmin_glb; apply (smaller_quotient (insphere _ t') _ M _ Di); assumption. }
  apply Rle_trans with (1 := H). right. unfold annuli_half_width. rewrite !half_width_scaled by exact K. rewrite <- !Rmin_factor, !(Rmult_comm k). reflexivity.
Qed.

(* A cell. *)
Lemma cell_lower d l (y : corners) low : holds d (volume (scaled k y)) -> (exists l', holds l l' /\ 0 <= l' /\ R_sqrt.sqrt l' = largest (scaled k y)) ->
  width_lower d l = Some low -> is_finite low = true /\ 0 <= B2R low <= half_width_simplex y * k.
Proof.
  intros D (l' & L & P & E) W. assert (K := factor_positive). unfold width_lower in W. destruct (below nought (lower d)) eqn:Pos; [|discriminate].
  destruct (positive_end _ _ Pos D) as (_ & V). destruct (cell_half (scaled k y) _ l' eq_refl E ltac:(lra)) as [H R].
  destruct (in_slack_lower _ _ _ _ _ _ Pos D R (sum_of_roots_above _ _ _ _ P P (proj2 L) (proj2 L)) W) as (F & Q0 & Q).
  split; [exact F|]. split; [exact Q0|]. unfold integers_2.half_width, of_cell in H. cbn [determinant inner outer] in H. rewrite H in Q.
  rewrite simplex_scaled in Q by exact K. lra.
Qed.

Lemma least_of_two (g h : double) r e : is_finite g = true -> is_finite h = true -> 0 <= B2R g <= r -> 0 <= B2R h <= e ->
  is_finite (least g h) = true /\ 0 <= B2R (least g h) <= Rmin r e.
Proof.
  intros G H R E. unfold least, below. rewrite Bltb_correct by assumption. case Rlt_bool_spec; intro L; (split; [assumption|]); (split; [lra|]); apply Rmin_glb; lra.
Qed.
Lemma cells_lower low_p low_q : width_lower (cell_p _ t) (cell_p_slab _ t) = Some low_p -> width_lower (cell_q _ t) (cell_q_slab _ t) = Some low_q ->
  is_finite (least low_p low_q) = true /\ 0 <= B2R (least low_p low_q) <= cells_half_width x * k.
Proof.
  intros P Q. destruct encloses as (_ & _ & (Ep & Eq) & (Sp & Sq)).
  assert (H := cells_half (scaled k x)). rewrite is_real in H. destruct H as (Vp & Vq & Lp & Lq & Rp & Rq). rewrite Vp in Ep. rewrite Vq in Eq.
  destruct (cell_lower _ _ (sign_tolerance_3.cell_p x) low_p Ep (ex_intro _ _ (conj Sp (conj Lp Rp))) P) as [Fp Hp].
  destruct (cell_lower _ _ (sign_tolerance_3.cell_q x) low_q Eq (ex_intro _ _ (conj Sq (conj Lq Rq))) Q) as [Fq Hq].
  unfold cells_half_width. rewrite <- Rmin_factor. now apply least_of_two.
Qed.

Theorem accept_bicell_right use : right_answer (accept_bicell s t use) (det x) (certified_width use x).
Proof.
  assert (K := factor_positive). unfold accept_bicell. cbv zeta. set (back' := existsb _ _). set (sure := existsb _ _).
  assert (Back : back' = false -> 0 < Lam x cpq /\ 0 < Lam x bpq /\ 0 < Lam x apq).
  { destruct encloses as (_ & (_ & (_ & _ & S2) & (_ & _ & S3) & (_ & _ & S4)) & _). assert (H := terms_are_numbers (scaled k x)). rewrite is_real in H.
    destruct H as (_ & L2 & L3 & L4).
    rewrite L2 in S2. rewrite L3 in S3. rewrite L4 in S4. rewrite !Lam_scaled in *.
    unfold back'. simpl. intro B. apply orb_false_elim in B. destruct B as [B2 B]. apply orb_false_elim in B. destruct B as [B3 B]. apply orb_false_elim in B.
    destruct B as [B4 _].
    apply negb_false_iff in B2. apply negb_false_iff in B3. apply negb_false_iff in B4. destruct (powers_positive k K) as (_ & K3 & _).
    destruct (positive_end _ _ B2 S2) as (_ & H2). destruct (positive_end _ _ B3 S3) as (_ & H3). destruct (positive_end _ _ B4 S4) as (_ & H4).
    repeat split; apply Rmult_lt_reg_l with (1 := K3); lra. }
  destruct (below nought _) eqn:P.
  - destruct (quotient_lower_in_slack _ _ _) as [low|] eqn:T; [|exact Logic.I]. destruct (annuli_lower low P T) as (D & F & H). rewrite factor in H.
    set (taken := match use with never => false | where_needed => back' | always => true end).
    assert (Al : use = always -> taken = true) by (now intros ->). assert (Wh : use = where_needed -> taken = false -> 0 < Lam x cpq /\ 0 < Lam x bpq /\ 0 < Lam x apq).
    { intros -> N. now apply Back. }
    destruct taken eqn:Tk.
    + destruct (width_lower (cell_p _ t) _) as [lp|] eqn:Wp; [|exact Logic.I]. destruct (width_lower (cell_q _ t) _) as [lq|] eqn:Wq; [|exact Logic.I].
      match goal with |- context [if ?c then refused else _] => destruct c; [exact Logic.I|] end.
      destruct (cells_lower lp lq Wp Wq) as [Fc Hc]. rewrite factor in Hc.
      destruct (least_of_two _ _ _ _ F Fc H Hc) as [Fl Hl]. rewrite <- factor, Rmin_factor, factor in Hl.
      destruct (back_lower s _ _ good Fl Hl) as [Fb [B0 B1]]. simpl. split; [exact Fb|]. split; [exact D|]. split; [exact B0|].
      apply certified_width_is with true; trivial; [|intros _]; apply Rle_trans with (1 := B1); [apply Rmin_l|apply Rmin_r].
    + destruct (back_lower s low _ good F H) as [Fb [B0 B1]]. simpl. split; [exact Fb|]. split; [exact D|]. split; [exact B0|].
      apply certified_width_is with false; trivial. discriminate.
  - destruct (below (upper _) nought) eqn:N; [|exact Logic.I]. simpl. destruct encloses as (E & _).
    assert (L := negative_end _ _ N E). assert (Num := proj1 (terms_are_numbers (scaled k x))). rewrite is_real in Num. rewrite Num, det_scaled in L by exact K.
    destruct (powers_positive k K) as (_ & _ & K4). assert (Q : 0 < k * (k * k * k * k)) by now apply Rmult_lt_0_compat.
    apply Rmult_lt_reg_l with (1 := Q). now rewrite Rmult_0_r.
Qed.
End accept.

Theorem empty_sphere_3_interval_returned (f : vertex -> vector_3 machine) use : (forall k, coordinates_3 (f k)) ->
  right_answer (empty_sphere_3_interval (f a) (f b) (f c) (f p) (f q) use) (det (fun k => at_3 (f k))) (certified_width use (fun k => at_3 (f k))).
Proof.
  intro Dom. unfold empty_sphere_3_interval. cbv zeta. set (s := scale_of _). assert (G : good_scale s).
  { apply scale_good. intros i j I. repeat (apply in_app_or in I; destruct I as [I|I]); revert I; apply pairs_3_coordinates; apply Dom. }
  apply (accept_bicell_right _ _ (scale_factor s) s G eq_refl _ eq_refl). assert (V := fun i => vector_3_encloses s _ _ G (Dom i) (Dom a)).
  assert (E := bicell_encloses _ _ _ _ _ _ _ _ (V b) (V c) (V p) (V q)). unfold real_bicell. rewrite !rel_scaled. exact E.
Qed.
