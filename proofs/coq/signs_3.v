(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* signs_2.v in space (circumsphere_3.h). Of a sphere k through a, b, c, d:

   - positive_3       sphere_positive k: the cell is positive
   - sides_of_sphere_3   and excludes_3 k p: p is outside of the sphere; contains_3 k p: it is inside
   - excludes_all_3_sound   excludes_all_3 k ps: the cell is positive, and each of ps outside *)
From Coq Require Import Reals ZArith Lia Lra Bool List.
From Flocq Require Import Core.
From Coq Require Import Floats.
From Annulus Require float_model float_error float_filter float_signs vectors bicell float_certifies_3.
From Annulus Require Import operations bridge bridge_decide filter_2 filter_3 bridge_terms_3 bridge_3 connect connect_3 returned_3.
Import ListNotations.
Close Scope float_scope.
Open Scope R_scope.

Lemma cell_error_is : forall m, cell_error rounded m = float_filter.error_bound 47 (float_filter.power_3 m).
Proof. exact width_error_is. Qed.
Lemma sphere_error_is : forall m, sphere_error rounded m = float_filter.error_bound 1123 (float_filter.power_5 m).
Proof.
  intro m. unfold sphere_error. change (constant rounded circumsphere_3_u) with (value circumsphere_3_u).
  replace (value circumsphere_3_u) with (float_error.fmul (IZR 1123) float_model.u); [reflexivity|].
  symmetry. eapply (v_units _ 1123 42); [reflexivity|reflexivity|reflexivity|lia].
Qed.

(* ---- No overflow ---- *)

Section terms.
Variables (a u v t w : vector_3 machine) (a' u' v' t' w' : vector_3 rounded).
Hypothesis Hu : stands_vector_3 100 u u'.
Hypothesis Hv : stands_vector_3 100 v v'.
Hypothesis Ht : stands_vector_3 100 t t'.

Lemma volume_stands : stands 303 (six_volume _ (circumsphere_from machine a u v t)) (six_volume _ (circumsphere_from rounded a' u' v' t')).
Proof.
  exact (stands_dot 201 100 _ _ _ _ ltac:(lia) ltac:(lia) ltac:(lia)
    (vector_cross 100 100 _ _ _ _ ltac:(lia) ltac:(lia) ltac:(lia) Hu Hv) Ht).
Qed.

Lemma normal_stands : stands_vector_3 405 (normal_3 _ (circumsphere_from machine a u v t)) (normal_3 _ (circumsphere_from rounded a' u' v' t')).
Proof.
  destruct (vector_cross 100 100 _ _ _ _ ltac:(lia) ltac:(lia) ltac:(lia) Hu Hv) as (Ux & Uy & Uz).
  destruct (vector_cross 100 100 _ _ _ _ ltac:(lia) ltac:(lia) ltac:(lia) Hv Ht) as (Vx & Vy & Vz).
  destruct (vector_cross 100 100 _ _ _ _ ltac:(lia) ltac:(lia) ltac:(lia) Ht Hu) as (Tx & Ty & Tz).
  destruct (stands_square_3 100 _ _ ltac:(lia) Hu) as [uu _]. destruct (stands_square_3 100 _ _ ltac:(lia) Hv) as [vv _].
  destruct (stands_square_3 100 _ _ ltac:(lia) Ht) as [tt _].
  assert (K : forall i i' j j' l l', stands 201 i i' -> stands 201 j j' -> stands 201 l l' ->
    stands 405 (square_3 machine u * i + square_3 machine v * j + square_3 machine t * l)%float
      (rnd (rnd (rnd (square_3 rounded u' * i') + rnd (square_3 rounded v' * j')) + rnd (square_3 rounded t' * l')))).
  { intros i i' j j' l l' I J L. apply (stands_add_same 404); [lia| |].
    - apply (stands_add_same 403); [lia| |]; apply (stands_mul 202 201); trivial; lia.
    - apply stands_wider with (202 + 201)%Z; [lia|]. apply stands_mul; trivial; lia. }
  split; [|split]; now apply K.
Qed.

Hypothesis Hw : stands_vector_3 100 w w'.
Lemma outside_stands_3 : stands 508 (outside_from_3 machine (circumsphere_from machine a u v t) w)
  (outside_from_3 rounded (circumsphere_from rounded a' u' v' t') w').
Proof.
  destruct (stands_square_3 100 _ _ ltac:(lia) Hw) as [ww _]. apply (stands_sub_same 507); [lia| |].
  - apply stands_wider with (202 + 303)%Z; [lia|]. apply stands_mul; [lia|exact ww|exact volume_stands].
  - exact (stands_dot 100 405 _ _ _ _ ltac:(lia) ltac:(lia) ltac:(lia) Hw normal_stands).
Qed.
End terms.

Lemma unit_circumsphere : stands_unit (-42) circumsphere_3_u.
Proof. unit_constant. Qed.
Lemma sphere_error_stands : forall m m', stands 501 m m' -> power (-120) <= m' -> m' <= power 100 ->
  stands 460 (sphere_error machine m) (sphere_error rounded m').
Proof.
  intros m m' M Low High.
  assert (M' : stands 100 m m') by (apply stands_tighter with (1 := M); rewrite Rabs_pos_eq; [exact High|apply Rle_trans with (2 := Low), bpow_ge_0]).
  pose proof (stands_mul 100 100 _ _ _ _ ltac:(lia) M' M') as M2. pose proof (stands_mul 200 200 _ _ _ _ ltac:(lia) M2 M2) as M4.
  apply stands_wider with (-42 + 500)%Z; [lia|].
  exact (stands_mul (-42) 500 _ _ _ _ ltac:(lia) (proj1 unit_circumsphere) (stands_mul 400 100 _ _ _ _ ltac:(lia) M4 M')).
Qed.

(* ---- Errors ---- *)

Definition E_vector (n : nat) : vector_3 float_signs.analysed :=
  {| x3 := float_error.Var n : number float_signs.analysed; y3 := float_error.Var (S n) : number float_signs.analysed;
     z3 := float_error.Var (S (S n)) : number float_signs.analysed |}.
Definition E_sphere := circumsphere_from float_signs.analysed (E_vector 0) (E_vector 0) (E_vector 3) (E_vector 6).
Definition E_outside := outside_from_3 float_signs.analysed E_sphere (E_vector 9).

(* In halves of u, below 47 and 1123; one u less than the latter is refused. *)
Lemma constants_signs_3 :
  float_error.error_below [] (six_volume _ E_sphere) 3 (8 * float_error.one) (8 * float_error.one) (93 * float_filter.half_u) = true /\
  float_error.error_below [] E_outside 5 (128 * float_error.one) (128 * float_error.one) (2245 * float_filter.half_u) = true /\
  float_error.error_below [] E_outside 5 (128 * float_error.one) (128 * float_error.one) (2244 * float_filter.half_u) = false.
Proof. split; [|split]; [vm_cast_no_check (eq_refl true)|vm_cast_no_check (eq_refl true)|vm_cast_no_check (eq_refl false)]. Qed.

(* The five points, p as the one that is tested. *)
Definition five (a b c d p : vectors.vec) : bicell.placement :=
  fun k => match k with bicell.a => a | bicell.b => b | bicell.c => c | bicell.p => p | bicell.q => d end.
(* Six times the volume of the cell; positive where p is outside of its sphere. *)
Definition volume_of (a b c d : vectors.vec) : R := vectors.vol (vectors.sub b a) (vectors.sub c a) (vectors.sub d a).
Definition beyond_3 (a b c d p : vectors.vec) : R := bicell.det (five a b c d p).

Local Strategy expand [float_error.fadd float_error.fsub float_error.fmul float_model.rnd].
Local Strategy opaque [Generic_fmt.round].

Section errors.
Variable m : R.
Hypothesis M : power (-120) <= m.
Variables a b c d p : vectors.vec.
Hypothesis formats : Forall C.F_numbers [a; b; c; d; p].
Let point (r : vectors.vec) : vector_3 rounded := real_3 (C.numbers r).
Let u := difference_3 rounded (point b) (point a).
Let v := difference_3 rounded (point c) (point a).
Let t := difference_3 rounded (point d) (point a).
Let w := difference_3 rounded (point p) (point a).
Hypothesis small : largest_3 rounded u <= m /\ largest_3 rounded v <= m /\ largest_3 rounded t <= m /\ largest_3 rounded w <= m.
Let k := circumsphere_from rounded (point a) u v t.

Definition listed (v : vector_3 rounded) : list R := [x3 _ v; y3 _ v; z3 _ v].
Definition listed_vec (v : vectors.vec) : list R := [vectors.X1 v; vectors.X2 v; vectors.X3 v].
Let computed : list R := listed u ++ listed v ++ listed t ++ listed w.
Let truth : list R := listed_vec (vectors.sub b a) ++ listed_vec (vectors.sub c a) ++ listed_vec (vectors.sub d a) ++ listed_vec (vectors.sub p a).

Lemma one_difference : forall r, C.F_numbers r -> C.F_numbers a -> largest_3 rounded (difference_3 rounded (point r) (point a)) <= m ->
  let l := listed (difference_3 rounded (point r) (point a)) in
  Forall float_model.F l /\ Forall (fun r => Rabs r <= m) l /\ Forall2 (fun r s => Rabs (r - s) <= float_model.u * m) l (listed_vec (vectors.sub r a)).
Proof.
  intros r (Fx & Fy & Fz) (Gx & Gy & Gz) L. rewrite largest_3_is in L. apply float_filter_3.magnitude_bounds in L. destruct L as (Lx & Ly & Lz).
  assert (close : forall r s, float_model.F r -> float_model.F s -> Rabs (float_model.rnd (r - s)) <= m ->
    Rabs (float_model.rnd (r - s) - (r - s)) <= float_model.u * m).
  { intros r' s Fr Fs L. apply Rle_trans with (1 := float_model.rnd_sub_result r' s Fr Fs). apply Rmult_le_compat_l; [|exact L].
    generalize float_model.u_bounds. lra. }
  split; [|split]; float_filter.each; try assumption; try apply float_model.F_rnd; apply close; assumption.
Qed.

Lemma differences : Forall float_model.F computed /\ Forall (fun r => Rabs r <= m) computed /\
  Forall2 (fun r s => Rabs (r - s) <= float_model.u * m) computed truth.
Proof.
  destruct small as (Su & Sv & St & Sw). rewrite Forall_forall in formats.
  assert (Fa : C.F_numbers a) by (apply formats; now left).
  destruct (one_difference b (formats b ltac:(simpl; tauto)) Fa Su) as (U1 & U2 & U3).
  destruct (one_difference c (formats c ltac:(simpl; tauto)) Fa Sv) as (V1 & V2 & V3).
  destruct (one_difference d (formats d ltac:(simpl; tauto)) Fa St) as (T1 & T2 & T3).
  destruct (one_difference p (formats p ltac:(simpl; tauto)) Fa Sw) as (W1 & W2 & W3).
  unfold computed, truth. rewrite !Forall_app. repeat split; try assumption. repeat apply Forall2_app; assumption.
Qed.

Lemma volume_near : Rabs (six_volume _ k - volume_of a b c d) <= 93 / 2 * float_model.u * m ^ 3.
Proof.
  destruct differences as (D1 & D2 & D3).
  replace (volume_of a b c d) with (float_error.exact (float_filter.env truth) (six_volume _ E_sphere)).
  - exact (float_signs.computed_near m M computed truth D1 D2 D3 (six_volume _ E_sphere) 3 8 93 (proj1 constants_signs_3)).
  - unfold volume_of, vectors.vol, vectors.dot, vectors.cross, vectors.sub. cbn. ring.
Qed.

Lemma outside_near_3 : Rabs (outside_from_3 rounded k w - beyond_3 a b c d p) <= 2245 / 2 * float_model.u * m ^ 5.
Proof.
  destruct differences as (D1 & D2 & D3).
  replace (beyond_3 a b c d p) with (float_error.exact (float_filter.env truth) E_outside).
  - exact (float_signs.computed_near m M computed truth D1 D2 D3 E_outside 5 128 2245 (proj1 (proj2 constants_signs_3))).
  - unfold beyond_3, bicell.det, bicell.lambda_b, bicell.lambda_c, bicell.lambda_p, bicell.lambda_q, bicell.rel, five.
    unfold vectors.sq, vectors.vol, vectors.dot, vectors.cross, vectors.sub. cbn. ring.
Qed.
End errors.

(* ---- Signs ---- *)

Section sphere.
Variables a b c d : vector_3 machine.
Hypothesis domain : coordinates_3 a /\ coordinates_3 b /\ coordinates_3 c /\ coordinates_3 d.
Let k := circumsphere_of machine a b c d.
Let point (v : vector_3 machine) : vector_3 rounded := real_3 (C.numbers (at_3 v)).
Let k' := circumsphere_of rounded (point a) (point b) (point c) (point d).
Let side_of := beyond_3 (at_3 a) (at_3 b) (at_3 c) (at_3 d).

Lemma largest_format_3 : forall v w, float_model.F (largest_3 rounded (difference_3 rounded (point v) (point w))).
Proof. intros. rewrite largest_3_is. apply float_filter_3.F_magnitude, float_filter_3.F_difference_point. Qed.

Lemma extent_stands_3 : stands 501 (extent_3 _ k) (extent_3 _ k') /\ float_model.F (extent_3 _ k').
Proof.
  destruct domain as (A & B & C & D). apply at_domain_3 in A, B, C, D. split.
  - apply (stands_max_same 501); [|apply (stands_max_same 501)]; apply stands_largest_3; now apply rounded_difference_3.
  - change (extent_3 _ k') with (greater rounded (largest_3 rounded (difference_3 rounded (point b) (point a)))
      (greater rounded (largest_3 rounded (difference_3 rounded (point c) (point a))) (largest_3 rounded (difference_3 rounded (point d) (point a))))).
    rewrite !greater_Rmax. repeat apply float_model.F_max; apply largest_format_3.
Qed.

Lemma range_bounds_3 : forall r, float_model.F r -> in_range_3 rounded r = true -> power (-120) <= r <= power 100.
Proof.
  intros r F H. split; [|now apply range_3_bounds]. apply (float_filter.in_range_lower 100); [lia|exact F|].
  unfold in_range_3 in H. apply andb_prop in H. destruct H as [L H]. revert L H.
  change (less_equal rounded) with Rle_bool. change (constant rounded filter_range_3) with (value filter_range_3).
  change (constant rounded 1%float) with (value 1%float). rewrite value_range_3, v_one.
  do 2 (case Rle_bool_spec; [|easy]). now split.
Qed.

Lemma positive_extent_3 : sphere_positive machine k = true -> power (-120) <= extent_3 _ k' <= power 100.
Proof.
  intro H. apply andb_prop in H. destruct H as [_ H]. destruct extent_stands_3 as [E F].
  rewrite (stands_range_3 _ _ E) in H. now apply range_bounds_3.
Qed.

Lemma extent_holds : forall m, extent_3 _ k' <= m -> largest_3 rounded (difference_3 rounded (point b) (point a)) <= m /\
  largest_3 rounded (difference_3 rounded (point c) (point a)) <= m /\ largest_3 rounded (difference_3 rounded (point d) (point a)) <= m.
Proof.
  intros m H. assert (H' := Rle_trans _ _ _ (max_ge_r _ _) H).
  exact (conj (Rle_trans _ _ _ (max_ge_l _ _) H) (conj (Rle_trans _ _ _ (max_ge_l _ _) H') (Rle_trans _ _ _ (max_ge_r _ _) H'))).
Qed.

Lemma difference_stands : forall v, coordinates_3 v -> largest_3 rounded (difference_3 rounded (point v) (point a)) <= power 100 ->
  stands_vector_3 100 (difference_3 machine v a) (difference_3 rounded (point v) (point a)).
Proof. intros v V H. eapply tighter_vector_3; [apply rounded_difference_3; apply at_domain_3; [exact V|apply domain]|exact H]. Qed.

Lemma sides_stand_3 : extent_3 _ k' <= power 100 ->
  stands_vector_3 100 (difference_3 machine b a) (difference_3 rounded (point b) (point a)) /\
  stands_vector_3 100 (difference_3 machine c a) (difference_3 rounded (point c) (point a)) /\
  stands_vector_3 100 (difference_3 machine d a) (difference_3 rounded (point d) (point a)).
Proof. intro H. destruct (extent_holds _ H) as (B & C & D). repeat (split; [now apply difference_stands|]). now apply difference_stands. Qed.

Theorem positive_3 : sphere_positive machine k = true -> 0 < volume_of (at_3 a) (at_3 b) (at_3 c) (at_3 d).
Proof.
  intro H. destruct (positive_extent_3 H) as [Low High]. apply andb_prop in H. destruct H as [H _].
  destruct (sides_stand_3 High) as (U & V & T). destruct extent_stands_3 as [E _].
  assert (E' : stands 100 (extent_3 _ k) (extent_3 _ k')).
  { apply stands_tighter with (1 := E). rewrite Rabs_pos_eq; [exact High|]. apply Rle_trans with (2 := Low), bpow_ge_0. }
  assert (Er : stands 260 (cell_error machine (extent_3 _ k)) (cell_error rounded (extent_3 _ k'))) by exact (width_error_stands _ _ E').
  assert (Vo : stands 303 (six_volume _ k) (six_volume _ k')) by (apply volume_stands; assumption).
  change (less machine) with PrimFloat.ltb in H. rewrite (stands_ltb _ _ _ _ _ _ Er Vo), cell_error_is in H.
  revert H. case Rlt_bool_spec; [|easy]. intros H _. revert H.
  apply (float_signs.sign_certain 47 93 (extent_3 _ k') _ 3); try assumption; try lia.
  - apply (float_filter.widen _ Low _ _ 4 4); try lra. now apply float_filter.power_3_range.
  - destruct (extent_holds _ (Rle_refl _)) as (B & C & D).
    exact (volume_near _ Low (at_3 a) (at_3 b) (at_3 c) (at_3 d) (at_3 b) ltac:(float_filter.each; apply at_format_3) (conj B (conj C (conj D B)))).
Qed.

(* A point, with a bound of its coordinates and the cell's. *)
Section point.
Variables (p : vector_3 machine) (m : float) (m' : R).
Hypothesis domain_p : coordinates_3 p.
Hypothesis M : stands 501 m m'.
Hypothesis Low : power (-120) <= m'.
Hypothesis High : m' <= power 100.
Hypothesis small : extent_3 _ k' <= m' /\ largest_3 rounded (difference_3 rounded (point p) (point a)) <= m'.

Lemma beyond_stands_3 : stands 508 (outside_of_3 machine k p) (outside_of_3 rounded k' (point p)).
Proof.
  destruct small as [Sk Sp]. destruct (sides_stand_3 (Rle_trans _ _ _ Sk High)) as (U & V & T). apply outside_stands_3; try assumption.
  exact (difference_stands p domain_p (Rle_trans _ _ _ Sp High)).
Qed.

Lemma beyond_certain_3 :
  ((sphere_error machine m <? outside_of_3 machine k p)%float = true -> 0 < side_of (at_3 p)) /\
  ((sphere_error machine m <? - outside_of_3 machine k p)%float = true -> side_of (at_3 p) < 0).
Proof.
  assert (O := beyond_stands_3). assert (E := sphere_error_stands m m' M Low High). destruct small as [Sk Sp].
  rewrite (stands_ltb _ _ _ _ _ _ E O), (stands_ltb _ _ _ _ _ _ E (stands_opp _ _ _ O)), sphere_error_is.
  destruct (float_signs.sign_certain 1123 2245 m' (float_filter.power_5 m') 5 (outside_of_3 rounded k' (point p)) (side_of (at_3 p))) as [P N];
    try assumption; try lia.
  - apply (float_filter.widen m' Low _ _ 5 6); try lra. now apply float_filter.power_5_range.
  - destruct (extent_holds _ Sk) as (B & C & D).
    exact (outside_near_3 m' Low (at_3 a) (at_3 b) (at_3 c) (at_3 d) (at_3 p) ltac:(float_filter.each; apply at_format_3) (conj B (conj C (conj D Sp)))).
  - split; (case Rlt_bool_spec; [|easy]); auto.
Qed.
End point.

Lemma raised_stands_3 : forall ps m m', (forall p, In p ps -> coordinates_3 p) -> stands 501 m m' ->
  let M := fold_left (raised_3 machine k) ps m in let M' := fold_left (raised_3 rounded k') (map point ps) m' in
  stands 501 M M' /\ m' <= M' /\ forall p, In p ps -> largest_3 rounded (difference_3 rounded (point p) (point a)) <= M'.
Proof.
  induction ps as [|p ps IH]; intros m m' D H; [split; [exact H|]; split; [apply Rle_refl|easy]|].
  assert (H' : stands 501 (raised_3 machine k m p) (raised_3 rounded k' m' (point p))).
  { apply (stands_max_same 501); [exact H|]. apply stands_largest_3, rounded_difference_3; apply at_domain_3; [apply D; now left|apply domain]. }
  destruct (IH _ _ (fun q I => D q (or_intror I)) H') as (S & L & A). cbn [fold_left map]. split; [exact S|].
  split; [exact (Rle_trans _ _ _ (max_ge_l _ _) L)|]. intros q [<- | I]; [exact (Rle_trans _ _ _ (max_ge_r _ _) L)|now apply A].
Qed.

Lemma below_range_3 : forall m m', stands 501 m m' -> less_equal machine m (constant machine filter_range_3) = true -> m' <= power 100.
Proof.
  intros m m' H L. assert (C : stands 100 filter_range_3 (value filter_range_3)) by (eapply stands_constant; [reflexivity| |]; vm_compute; easy).
  change (less_equal machine m (constant machine filter_range_3)) with (PrimFloat.leb m filter_range_3) in L.
  rewrite (stands_leb _ _ _ _ _ _ H C), value_range_3 in L. revert L. now case Rle_bool_spec.
Qed.

Theorem sides_of_sphere_3 : forall p, coordinates_3 p -> sphere_positive machine k = true ->
  (excludes_3 machine k p = true -> 0 < side_of (at_3 p)) /\ (contains_3 machine k p = true -> side_of (at_3 p) < 0).
Proof.
  intros p D P. destruct (positive_extent_3 P) as [Low _]. destruct extent_stands_3 as [E _].
  destruct (raised_stands_3 [p] _ _ ltac:(now intros q [<- | []]) E) as (S & L & A). specialize (A p (or_introl eq_refl)). cbn [fold_left map] in S, L, A.
  split; intro H; apply andb_prop in H; destruct H as [H R]; apply (below_range_3 _ _ S) in R;
    destruct (beyond_certain_3 p _ _ D S (Rle_trans _ _ _ Low L) R (conj L A)) as [B C]; [exact (B H)|exact (C H)].
Qed.

Theorem excludes_all_3_sound : forall ps, (forall p, In p ps -> coordinates_3 p) -> excludes_all_3 machine k ps = true ->
  0 < volume_of (at_3 a) (at_3 b) (at_3 c) (at_3 d) /\ forall p, In p ps -> 0 < side_of (at_3 p).
Proof.
  intros ps D H. apply andb_prop in H. destruct H as [H P]. split; [now apply positive_3|].
  destruct (positive_extent_3 P) as [Low _]. destruct extent_stands_3 as [E _]. destruct (raised_stands_3 ps _ _ D E) as (S & L & A).
  apply andb_prop in H. destruct H as [H R]. apply (below_range_3 _ _ S) in R. assert (Low' := Rle_trans _ _ _ Low L).
  assert (Fin : forall p, In p ps -> finite (outside_of_3 machine k p) = true)
    by (intros p I; exact (proj1 (beyond_stands_3 p _ (D p I) R (conj L (A p I))))).
  destruct (less_than_least _ (outside_of_3 machine k) ps _ infinity (proj1 (sphere_error_stands _ _ S Low' R)) Fin (or_introl eq_refl) H) as [_ Each].
  intros p I. destruct (beyond_certain_3 p _ _ (D p I) S Low' R (conj L (A p I))) as [B _]. exact (B (Each p I)).
Qed.
End sphere.
