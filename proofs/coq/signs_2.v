(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Signs and nothing else, in the plane (circumcircle_2.h): for finite doubles of the coordinate domain and the operations of the compiled code in
   Coq's primitive floats, overflow and underflow within the theorem. Of a circle k through a, b, c:

   - positive_2       circle_positive k: the triangle is positive
   - sides_of_circle_2   and excludes k p: p is outside of the circle; contains k p: it is inside
   - excludes_all_2   excludes_all k ps: the triangle is positive, and each of ps outside *)
From Coq Require Import Reals ZArith Lia Lra Bool List.
From Flocq Require Import Core.
From Coq Require Import Floats.
From Annulus Require float_model float_error float_filter float_signs width_2.
From Annulus Require Import operations bridge bridge_decide filter_2 bridge_2 connect connect_2 returned_2.
Import ListNotations.
Close Scope float_scope.
Open Scope R_scope.

Lemma circle_error_is : forall m, circle_error rounded m = float_filter.error_bound 129 (float_filter.power_4 m).
Proof.
  intro m. unfold circle_error. change (constant rounded circumcircle_2_u) with (value circumcircle_2_u).
  replace (value circumcircle_2_u) with (float_error.fmul (IZR 129) float_model.u); [reflexivity|].
  symmetry. eapply (v_units _ 129 45); [reflexivity|reflexivity|reflexivity|lia].
Qed.
Lemma orientation_error_is : forall m, orientation_error rounded m = float_filter.error_bound 9 (float_filter.power_2 m).
Proof. intro m. unfold orientation_error. change (constant rounded orientation_2_u) with (value orientation_2_u). now rewrite v_orientation. Qed.

(* ---- No overflow ---- *)

Section terms.
Variables (a u v w : vector machine) (a' u' v' w' : vector rounded).
Hypothesis Hu : stands_vector 120 u u'.
Hypothesis Hv : stands_vector 120 v v'.

Lemma area_stands : stands 241 (twice_area _ (circumcircle_from machine a u v)) (twice_area _ (circumcircle_from rounded a' u' v')).
Proof.
  destruct Hu as [ux uy], Hv as [vx vy]. apply (stands_sub_same 240); [lia| |]; apply (stands_mul 120 120); trivial; lia.
Qed.

Hypothesis Hw : stands_vector 120 w w'.
Lemma outside_stands : stands 484 (outside_from machine (circumcircle_from machine a u v) w) (outside_from rounded (circumcircle_from rounded a' u' v') w').
Proof.
  assert (A := area_stands). destruct Hu as [ux uy], Hv as [vx vy], Hw as [wx wy].
  assert (S : forall f g r s, stands 120 f r -> stands 120 g s -> stands 241 (f * f + g * g)%float (rnd (rnd (r * r) + rnd (s * s))))
    by (intros; apply (stands_add_same 240); [lia| |]; apply (stands_mul 120 120); trivial; lia).
  assert (P : forall f g h k r s t q, stands 120 f r -> stands 241 g s -> stands 120 h t -> stands 241 k q ->
    stands 362 (f * g - h * k)%float (rnd (rnd (r * s) - rnd (t * q))))
    by (intros; apply (stands_sub_same 361); [lia| |]; apply (stands_mul 120 241); trivial; lia).
  assert (X := P _ _ _ _ _ _ _ _ uy (S _ _ _ _ vx vy) vy (S _ _ _ _ ux uy)).
  assert (Y := P _ _ _ _ _ _ _ _ vx (S _ _ _ _ ux uy) ux (S _ _ _ _ vx vy)).
  apply (stands_add_same 483); [lia| |].
  - apply (stands_add_same 482); [lia| |]; apply (stands_mul 120 362); trivial; lia.
  - apply stands_wider with (241 + 241)%Z; [lia|]. apply stands_mul; [lia|now apply S|exact A].
Qed.
End terms.

Lemma circle_error_stands : forall m m', stands 501 m m' -> power (-120) <= m' -> m' <= power 120 ->
  stands 440 (circle_error machine m) (circle_error rounded m').
Proof.
  intros m m' M Low High.
  assert (M' : stands 120 m m') by (apply stands_tighter with (1 := M); rewrite Rabs_pos_eq; [exact High|apply Rle_trans with (2 := Low), bpow_ge_0]).
  assert (K : stands (-45) circumcircle_2_u (value circumcircle_2_u)) by (eapply stands_constant; [reflexivity| |]; vm_compute; easy).
  pose proof (stands_mul 120 120 _ _ _ _ ltac:(lia) M' M') as M2. apply stands_wider with (-45 + 480)%Z; [lia|].
  exact (stands_mul (-45) 480 _ _ _ _ ltac:(lia) K (stands_mul 240 240 _ _ _ _ ltac:(lia) M2 M2)).
Qed.

(* ---- Errors ---- *)

Definition E_vector (n : nat) : vector float_signs.analysed :=
  {| x := float_error.Var n : number float_signs.analysed; y := float_error.Var (S n) : number float_signs.analysed |}.
Definition E_circle := circumcircle_from float_signs.analysed (E_vector 0) (E_vector 0) (E_vector 2).
Definition E_outside := outside_from float_signs.analysed E_circle (E_vector 4).

(* In halves of u, below 9 and 129; one u less than these is refused. *)
Lemma constants_signs_2 :
  float_error.error_below [] (twice_area _ E_circle) 2 (3 * float_error.one) (3 * float_error.one) (17 * float_filter.half_u) = true /\
  float_error.error_below [] E_outside 4 (13 * float_error.one) (13 * float_error.one) (257 * float_filter.half_u) = true /\
  float_error.error_below [] E_outside 4 (13 * float_error.one) (13 * float_error.one) (256 * float_filter.half_u) = false.
Proof. repeat split; vm_compute; reflexivity. Qed.

Local Strategy expand [float_error.fadd float_error.fsub float_error.fmul float_model.rnd].
Local Strategy opaque [Generic_fmt.round].

Section errors.
Variable m : R.
Hypothesis M : power (-120) <= m.
Variables a b c p : R * R.
Hypothesis formats : Forall (fun r => float_model.F (fst r) /\ float_model.F (snd r)) [a; b; c; p].
Let point (r : R * R) : vector rounded := real (fst r) (snd r).
Let u := difference rounded (point b) (point a).
Let v := difference rounded (point c) (point a).
Let w := difference rounded (point p) (point a).
Hypothesis small : largest rounded u <= m /\ largest rounded v <= m /\ largest rounded w <= m.
Let k := circumcircle_from rounded (point a) u v.

Let computed : list R := [x _ u; y _ u; x _ v; y _ v; x _ w; y _ w].
Let truth : list R := [fst b - fst a; snd b - snd a; fst c - fst a; snd c - snd a; fst p - fst a; snd p - snd a].

Lemma differences : Forall float_model.F computed /\ Forall (fun r => Rabs r <= m) computed /\
  Forall2 (fun r s => Rabs (r - s) <= float_model.u * m) computed truth.
Proof.
  destruct small as (Su & Sv & Sw). destruct (largest_bounds _ _ Su), (largest_bounds _ _ Sv), (largest_bounds _ _ Sw).
  assert (close : forall r s, float_model.F r -> float_model.F s -> Rabs (float_model.rnd (r - s)) <= m ->
    Rabs (float_model.rnd (r - s) - (r - s)) <= float_model.u * m).
  { intros r s Fr Fs L. apply Rle_trans with (1 := float_model.rnd_sub_result r s Fr Fs). apply Rmult_le_compat_l; [|exact L].
    generalize float_model.u_bounds. lra. }
  inversion_clear formats as [|? ? [Fax Fay] G]. inversion_clear G as [|? ? [Fbx Fby] G']. inversion_clear G' as [|? ? [Fcx Fcy] G].
  inversion_clear G as [|? ? [Fpx Fpy] _].
  split; [|split]; float_filter.each; try assumption; try apply float_model.F_rnd; apply close; assumption.
Qed.

Lemma area_near : Rabs (twice_area _ k - width_2.turn (fst a) (snd a) (fst b) (snd b) (fst c) (snd c)) <= 17 / 2 * float_model.u * m ^ 2.
Proof.
  destruct differences as (D1 & D2 & D3).
  replace (width_2.turn _ _ _ _ _ _) with (float_error.exact (float_filter.env truth) (twice_area _ E_circle)).
  - exact (float_signs.computed_near m M computed truth D1 D2 D3 (twice_area _ E_circle) 2 3 17 (proj1 constants_signs_2)).
  - unfold width_2.turn. cbn. ring.
Qed.

Lemma outside_near : Rabs (outside_from rounded k w - width_2.incircle (fst a) (snd a) (fst b) (snd b) (fst p) (snd p) (fst c) (snd c)) <=
  257 / 2 * float_model.u * m ^ 4.
Proof.
  destruct differences as (D1 & D2 & D3).
  replace (width_2.incircle _ _ _ _ _ _ _ _) with (float_error.exact (float_filter.env truth) E_outside).
  - exact (float_signs.computed_near m M computed truth D1 D2 D3 E_outside 4 13 257 (proj1 (proj2 constants_signs_2))).
  - unfold width_2.incircle, width_2.turn. cbn. ring.
Qed.
End errors.

(* ---- Signs ---- *)

Definition turn_2 (a b c : R * R) : R := width_2.turn (fst a) (snd a) (fst b) (snd b) (fst c) (snd c).
(* Positive where p is outside of the circle through a, b, c. *)
Definition beyond_2 (a b c p : R * R) : R := width_2.incircle (fst a) (snd a) (fst b) (snd b) (fst p) (snd p) (fst c) (snd c).

Section circle.
Variables a b c : vector machine.
Hypothesis domain : coordinates_2 a /\ coordinates_2 b /\ coordinates_2 c.
Let k := circumcircle_of machine a b c.
Let point (v : vector machine) : vector rounded := connect_2.real (fst (at_2 v)) (snd (at_2 v)).
Let k' := circumcircle_of rounded (point a) (point b) (point c).

Lemma point_format : forall v, float_model.F (fst (at_2 v)) /\ float_model.F (snd (at_2 v)).
Proof. intro v. split; apply value_format. Qed.

Lemma largest_format : forall v w, float_model.F (largest rounded (difference rounded (point v) (point w))).
Proof. intros. unfold largest. rewrite greater_Rmax. apply float_model.F_max; apply float_model.F_abs, float_model.F_rnd. Qed.

Lemma extent_stands : stands 501 (extent _ k) (extent _ k') /\ float_model.F (extent _ k').
Proof.
  destruct domain as (A & B & C). apply at_domain_2 in A, B, C. split.
  - apply (stands_max_same 501); apply stands_largest; now apply rounded_difference.
  - change (float_model.F (greater rounded (largest rounded (difference rounded (point b) (point a)))
      (largest rounded (difference rounded (point c) (point a))))).
    rewrite greater_Rmax. apply float_model.F_max; apply largest_format.
Qed.

(* In the range m is as the analysis requires. *)
Lemma range_bounds : forall r, float_model.F r -> in_range rounded r = true -> power (-120) <= r <= power 120.
Proof.
  intros r F H. split; [|now apply range_bound]. apply (float_filter.in_range_lower 120); [lia|exact F|].
  unfold in_range in H. apply andb_prop in H. destruct H as [L H]. revert L H.
  change (less_equal rounded) with Rle_bool. change (constant rounded filter_range) with (value filter_range).
  change (constant rounded 1%float) with (value 1%float). rewrite v_range, v_one.
  do 2 (case Rle_bool_spec; [|easy]). now split.
Qed.

Lemma positive_extent : circle_positive machine k = true -> power (-120) <= extent _ k' <= power 120.
Proof.
  intro H. apply andb_prop in H. destruct H as [_ H]. destruct extent_stands as [E F].
  rewrite (stands_range _ _ E) in H. now apply range_bounds.
Qed.

Lemma sides_stand : extent _ k' <= power 120 ->
  stands_vector 120 (difference machine b a) (difference rounded (point b) (point a)) /\
  stands_vector 120 (difference machine c a) (difference rounded (point c) (point a)).
Proof.
  intro H. destruct domain as (A & B & C). apply at_domain_2 in A, B, C.
  split; (eapply tighter_vector; [now apply rounded_difference|]); (eapply Rle_trans; [|exact H]); [apply max_ge_l|apply max_ge_r].
Qed.

Theorem positive_2 : circle_positive machine k = true -> 0 < turn_2 (at_2 a) (at_2 b) (at_2 c).
Proof.
  intro H. destruct (positive_extent H) as [Low High]. apply andb_prop in H. destruct H as [H _].
  destruct (sides_stand High) as [U V]. destruct extent_stands as [E F].
  assert (E' : stands 120 (extent _ k) (extent _ k')).
  { apply stands_tighter with (1 := E). rewrite Rabs_pos_eq; [exact High|]. apply Rle_trans with (2 := Low), bpow_ge_0. }
  assert (K : stands (-49) orientation_2_u (value orientation_2_u)) by (eapply stands_constant; [reflexivity| |]; vm_compute; easy).
  assert (Er : stands (-49 + 240) (orientation_error machine (extent _ k)) (orientation_error rounded (extent _ k')))
    by exact (stands_mul (-49) 240 _ _ _ _ ltac:(lia) K (stands_mul 120 120 _ _ _ _ ltac:(lia) E' E')).
  assert (Ar : stands 241 (twice_area _ k) (twice_area _ k')) by (apply area_stands; assumption).
  change (less machine) with PrimFloat.ltb in H. rewrite (stands_ltb _ _ _ _ _ _ Er Ar), orientation_error_is in H.
  revert H. case Rlt_bool_spec; [|easy]. intros H _. revert H.
  apply (float_signs.sign_certain 9 17 (extent _ k') _ 2); try assumption; try lia; [now apply float_filter.power_2_range_6|].
  exact (area_near _ Low (at_2 a) (at_2 b) (at_2 c) (at_2 b)
    ltac:(float_filter.each; apply point_format) (conj (max_ge_l _ _) (conj (max_ge_r _ _) (max_ge_l _ _)))).
Qed.

(* A point, with a bound of its coordinates and the triangle's. *)
Section point.
Variables (p : vector machine) (m : float) (m' : R).
Hypothesis domain_p : coordinates_2 p.
Hypothesis M : stands 501 m m'.
Hypothesis Low : power (-120) <= m'.
Hypothesis High : m' <= power 120.
Hypothesis small : extent _ k' <= m' /\ largest rounded (difference rounded (point p) (point a)) <= m'.

Lemma beyond_stands : stands 484 (outside_of machine k p) (outside_of rounded k' (point p)).
Proof.
  destruct small as [Sk Sp]. destruct (sides_stand (Rle_trans _ _ _ Sk High)) as [U V]. apply outside_stands; try assumption.
  eapply tighter_vector; [apply rounded_difference; apply at_domain_2; [exact domain_p|apply domain]|].
  exact (Rle_trans _ _ _ Sp High).
Qed.

Lemma beyond_certain :
  ((circle_error machine m <? outside_of machine k p)%float = true -> 0 < beyond_2 (at_2 a) (at_2 b) (at_2 c) (at_2 p)) /\
  ((circle_error machine m <? - outside_of machine k p)%float = true -> beyond_2 (at_2 a) (at_2 b) (at_2 c) (at_2 p) < 0).
Proof.
  assert (O := beyond_stands). assert (E := circle_error_stands m m' M Low High). destruct small as [Sk Sp].
  rewrite (stands_ltb _ _ _ _ _ _ E O), (stands_ltb _ _ _ _ _ _ E (stands_opp _ _ _ O)), circle_error_is.
  destruct (float_signs.sign_certain 129 257 m' (float_filter.power_4 m') 4 (outside_of rounded k' (point p))
    (beyond_2 (at_2 a) (at_2 b) (at_2 c) (at_2 p))) as [P N]; try assumption; try lia.
  - apply (float_filter.widen m' Low _ _ 4 4); try lra. now apply float_filter.power_4_range.
  - exact (outside_near m' Low (at_2 a) (at_2 b) (at_2 c) (at_2 p) ltac:(float_filter.each; apply point_format)
      (conj (Rle_trans _ _ _ (max_ge_l _ _) Sk) (conj (Rle_trans _ _ _ (max_ge_r _ _) Sk) Sp))).
  - split; (case Rlt_bool_spec; [|easy]); auto.
Qed.
End point.

(* m of some points: raised one by one. *)
Lemma raised_stands : forall ps m m', (forall p, In p ps -> coordinates_2 p) -> stands 501 m m' ->
  let M := fold_left (raised machine k) ps m in let M' := fold_left (raised rounded k') (map point ps) m' in
  stands 501 M M' /\ m' <= M' /\ forall p, In p ps -> largest rounded (difference rounded (point p) (point a)) <= M'.
Proof.
  induction ps as [|p ps IH]; intros m m' D H; [split; [exact H|]; split; [apply Rle_refl|easy]|].
  assert (H' : stands 501 (raised machine k m p) (raised rounded k' m' (point p))).
  { apply (stands_max_same 501); [exact H|]. apply stands_largest, rounded_difference; apply at_domain_2; [apply D; now left|apply domain]. }
  destruct (IH _ _ (fun q I => D q (or_intror I)) H') as (S & L & A). cbn [fold_left map]. split; [exact S|].
  split; [exact (Rle_trans _ _ _ (max_ge_l _ _) L)|]. intros q [<- | I]; [exact (Rle_trans _ _ _ (max_ge_r _ _) L)|now apply A].
Qed.

Lemma below_range : forall m m', stands 501 m m' -> less_equal machine m (constant machine filter_range) = true -> m' <= power 120.
Proof.
  intros m m' H L. assert (C : stands 120 filter_range (value filter_range)) by (eapply stands_constant; [reflexivity| |]; vm_compute; easy).
  change (less_equal machine m (constant machine filter_range)) with (PrimFloat.leb m filter_range) in L.
  rewrite (stands_leb _ _ _ _ _ _ H C), v_range in L. revert L. now case Rle_bool_spec.
Qed.

Theorem sides_of_circle_2 : forall p, coordinates_2 p -> circle_positive machine k = true ->
  (excludes machine k p = true -> 0 < beyond_2 (at_2 a) (at_2 b) (at_2 c) (at_2 p)) /\
  (contains machine k p = true -> beyond_2 (at_2 a) (at_2 b) (at_2 c) (at_2 p) < 0).
Proof.
  intros p D P. destruct (positive_extent P) as [Low _]. destruct extent_stands as [E _].
  destruct (raised_stands [p] _ _ ltac:(now intros q [<- | []]) E) as (S & L & A). specialize (A p (or_introl eq_refl)). cbn [fold_left map] in S, L, A.
  split; intro H; apply andb_prop in H; destruct H as [H R]; apply (below_range _ _ S) in R;
    destruct (beyond_certain p _ _ D S (Rle_trans _ _ _ Low L) R (conj L A)) as [B C]; [exact (B H)|exact (C H)].
Qed.

Theorem excludes_all_2 : forall ps, (forall p, In p ps -> coordinates_2 p) -> excludes_all machine k ps = true ->
  0 < turn_2 (at_2 a) (at_2 b) (at_2 c) /\ forall p, In p ps -> 0 < beyond_2 (at_2 a) (at_2 b) (at_2 c) (at_2 p).
Proof.
  intros ps D H. apply andb_prop in H. destruct H as [H P]. split; [now apply positive_2|].
  destruct (positive_extent P) as [Low _]. destruct extent_stands as [E _]. destruct (raised_stands ps _ _ D E) as (S & L & A).
  apply andb_prop in H. destruct H as [H R]. apply (below_range _ _ S) in R. assert (Low' := Rle_trans _ _ _ Low L).
  assert (Fin : forall p, In p ps -> finite (outside_of machine k p) = true)
    by (intros p I; exact (proj1 (beyond_stands p _ (D p I) R (conj L (A p I))))).
  destruct (less_than_least _ (outside_of machine k) ps _ infinity (proj1 (circle_error_stands _ _ S Low' R)) Fin (or_introl eq_refl) H) as [_ Each].
  intros p I. destruct (beyond_certain p _ _ (D p I) S Low' R (conj L (A p I))) as [B _]. exact (B (Each p I)).
Qed.
End circle.
