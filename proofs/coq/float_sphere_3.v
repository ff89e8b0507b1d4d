(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The filter of the empty sphere in space (empty_sphere_filter of src/annulus/certificate/ladder_3.h), from coordinates to
   answer: signs are right; a certified tolerance is at most the exact half width of each of the four annuli, and of the two
   cells where they are asked for; a partition that is not reported as backward has a positive sum of lambda. *)
Require Import Reals Lra Psatz ZArith List Bool.
From Flocq Require Import Core.
From Annulus Require Import float_model float_error float_tail float_filter float_terms_3 float_constants_3 float_width_3
  float_filter_3.
Import ListNotations.
Open Scope R_scope.

(* ---- As the code has it ---- *)

Inductive cells := never | where_needed | always.

(* The lesser of two tolerances where both signs are certainly positive. *)
Definition both (l r : option (Z * R)) : option (Z * R) :=
  match l with
  | Some (1%Z, t) => match r with Some (1%Z, s) => Some (1%Z, Rmin t s) | _ => None end
  | _ => l
  end.

Section code.
Variables a b c p q : vector R.
Variable certified : bool.
Variable use : cells.
Let vb := F_difference b a.
Let vc := F_difference c a.
Let vp := F_difference p a.
Let vq := F_difference q a.
Definition bicell_m : R := Rmax (Rmax (magnitude vb) (magnitude vc)) (Rmax (magnitude vp) (magnitude vq)).
Definition bicell_computed : bicell R := F_bicell vb vc vp vq.
Let m := bicell_m.
Let t := bicell_computed.

Definition norm_sum (n k : vector R) : R := root_sum (F_square n) (F_square k).

(* Partitions 1, 2, 3: ab|cpq, ca|bpq, bc|apq. *)
Definition is_backward (side : bicell R -> R) : bool :=
  if Rlt_dec (error_bound 169 (power_3 m)) (side t) then false else true.

Definition cells_needed : bool :=
  match use with
  | never => false
  | always => true
  | where_needed => is_backward l2 || is_backward l3 || is_backward minus_l4
  end.

(* A tolerance that the cells lower is no answer where a sum may be positive or not, and none is certainly not. *)
Definition certainly_backward (side : bicell R -> R) : bool :=
  if Rlt_dec (side t) (- error_bound 169 (power_3 m)) then true else false.
Definition lowered (annuli whole : option (Z * R)) : bool :=
  match annuli, whole with
  | Some (1%Z, v), Some (1%Z, w) => if Rlt_dec w v then true else false
  | _, _ => false
  end.
Definition in_doubt (annuli whole : option (Z * R)) : bool :=
  match use with
  | where_needed => certified && negb (certainly_backward l2 || certainly_backward l3 || certainly_backward minus_l4) && lowered annuli whole
  | _ => false
  end.

Definition bicell_filter : option (Z * R) :=
  if in_range_dec 100 m then
    let roots := Rmax (Rmax (norm_sum (n1 t) (m1 t)) (norm_sum (n2 t) (m2 t)))
                      (Rmax (norm_sum (n3 t) (m3 t)) (norm_sum (n4 t) (m4 t))) in
    let annuli := decide (determinant t) roots (error_bound 1105 (power_5 m)) (error_bound 3246 (power_4 m)) certified in
    if cells_needed
    then let whole := both (both annuli (decide_width (cell_p t) (slabs_p t) m certified)) (decide_width (cell_q t) (slabs_q t) m certified) in
         if in_doubt annuli whole then None else whole
    else annuli
  else None.
End code.

(* ---- As it is meant ---- *)

Definition bicell_truth a b c p q := R_bicell (R_difference b a) (R_difference c a) (R_difference p a) (R_difference q a).

(* An answer for the bi-cell, and which partitions are certainly not backward. *)
Definition bicell_sound (answer : option (Z * R)) (certified needed : bool) (t : bicell R) : Prop :=
  forall sign value, answer = Some (sign, value) ->
  sign = 1%Z /\ 0 < determinant t /\ (needed = true -> 0 < cell_p t /\ 0 < cell_q t) /\
  (certified = true -> 0 <= value /\
    value <= determinant t / (R_norm (n1 t) + R_norm (m1 t)) /\
    value <= determinant t / (R_norm (n2 t) + R_norm (m2 t)) /\
    value <= determinant t / (R_norm (n3 t) + R_norm (m3 t)) /\
    value <= determinant t / (R_norm (n4 t) + R_norm (m4 t)) /\
    (needed = true ->
      value <= cell_p t / (2 * sqrt (largest R_square (slabs_p t))) /\
      value <= cell_q t / (2 * sqrt (largest R_square (slabs_q t)))))
  \/ sign = (-1)%Z /\ determinant t < 0.

Lemma both_some l r sign value : both l r = Some (sign, value) ->
  l = Some (sign, value) /\ sign <> 1%Z \/
  sign = 1%Z /\ exists v w, l = Some (1%Z, v) /\ r = Some (1%Z, w) /\ value = Rmin v w.
Proof.
  unfold both. intro H. destruct l as [[s v] |]; [| discriminate].
  destruct (Z.eq_dec s 1) as [-> | N].
  - right. destruct r as [[s' w] |]; [| discriminate].
    destruct (Z.eq_dec s' 1) as [-> | N'].
    + injection H as <- <-. split; [reflexivity |]. exists v, w. auto.
    + exfalso. destruct s' as [| [ | | ] |]; congruence.
  - left. assert (E : Some (s, v) = Some (sign, value)) by (destruct s as [| [ | | ] |]; congruence).
    split; [exact E |]. congruence.
Qed.

(* The determinant of a partition vanishes with its norms: 2 P = -+ (N + M).x, x the point that is not a. *)
Lemma norms_positive n k v det s : 2 * det = s * (x n * x v + y n * y v + z n * z v + (x k * x v + y k * y v + z k * z v)) ->
  0 < det -> 0 < R_norm n + R_norm k.
Proof.
  intros E P. generalize (sqrt_pos (R_square n)) (sqrt_pos (R_square k)). fold (R_norm n) (R_norm k). intros N K.
  destruct (Rle_lt_or_eq_dec _ _ (Rplus_le_le_0_compat _ _ N K)) as [L | Z]; [exact L | exfalso].
  destruct (R_norm_zero n) as (X1 & Y1 & Z1); [lra |]. destruct (R_norm_zero k) as (X2 & Y2 & Z2); [lra |].
  rewrite X1, Y1, Z1, X2, Y2, Z2 in E. replace (s * _) with 0 in E by ring. lra.
Qed.

Lemma annuli_positive b c p q : let t := R_bicell b c p q in
  (0 < determinant t -> 0 < R_norm (n1 t) + R_norm (m1 t)) /\
  (0 < determinant t -> 0 < R_norm (n2 t) + R_norm (m2 t)) /\
  (0 < determinant t -> 0 < R_norm (n3 t) + R_norm (m3 t)) /\
  (0 < determinant t -> 0 < R_norm (n4 t) + R_norm (m4 t)).
Proof.
  intro t. split; [| split; [| split]].
  - apply (norms_positive _ _ p _ (-1)). unfold t, R_bicell, bicell_terms.
    cbv [determinant n1 m1 x y z vadd vsub vopp cross dot square squared combination minus_twice]. ring.
  - apply (norms_positive _ _ c _ (-1)). unfold t, R_bicell, bicell_terms.
    cbv [determinant n2 m2 x y z vadd vsub vopp cross dot square squared combination minus_twice]. ring.
  - apply (norms_positive _ _ b _ (-1)). unfold t, R_bicell, bicell_terms.
    cbv [determinant n3 m3 x y z vadd vsub vopp cross dot square squared combination minus_twice]. ring.
  - apply (norms_positive _ _ b _ (-1)). unfold t, R_bicell, bicell_terms.
    cbv [determinant n4 m4 x y z vadd vsub vopp cross dot square squared combination minus_twice]. ring.
Qed.

Lemma forall2_4 {A B} (Q : A -> B -> Prop) a b c d a' b' c' d' :
  Forall2 Q [a; b; c; d] [a'; b'; c'; d'] -> Q a a' /\ Q b b' /\ Q c c' /\ Q d d'.
Proof.
  intro H. inversion_clear H as [| ? ? ? ? H1 H']. inversion_clear H' as [| ? ? ? ? H2 H'']. inversion_clear H'' as [| ? ? ? ? H3 H'].
  inversion_clear H' as [| ? ? ? ? H4 _]. auto.
Qed.

Theorem bicell_filter_sound a b c p q certified use :
  F_point a -> F_point b -> F_point c -> F_point p -> F_point q ->
  let t := bicell_truth a b c p q in
  in_range 100 (bicell_m a b c p q) ->
  bicell_sound (bicell_filter a b c p q certified use) certified (cells_needed a b c p q use) t /\
  (is_backward a b c p q l2 = false -> 0 < l2 t) /\
  (is_backward a b c p q l3 = false -> 0 < l3 t) /\
  (is_backward a b c p q minus_l4 = false -> 0 < minus_l4 t).
Proof.
  intros Fa Fb Fc Fp Fq t Range.
  set (v1 := F_difference b a). set (v2 := F_difference c a). set (v3 := F_difference p a). set (v4 := F_difference q a).
  set (w1 := R_difference b a). set (w2 := R_difference c a). set (w3 := R_difference p a). set (w4 := R_difference q a).
  set (m := bicell_m a b c p q) in *.
  assert (M : bpow radix2 (-120) <= m).
  { apply (in_range_lower 100); [lia | | exact Range].
    apply F_max; apply F_max; apply F_magnitude, F_difference_point. }
  assert (B1 : magnitude v1 <= m) by (apply Rle_trans with (2 := Rmax_l _ _); apply Rmax_l).
  assert (B2 : magnitude v2 <= m) by (apply Rle_trans with (2 := Rmax_l _ _); apply Rmax_r).
  assert (B3 : magnitude v3 <= m) by (apply Rle_trans with (2 := Rmax_r _ _); apply Rmax_l).
  assert (B4 : magnitude v4 <= m) by (apply Rle_trans with (2 := Rmax_r _ _); apply Rmax_r).
  set (l := [v1; v2; v3; v4]). set (k := [w1; w2; w3; w4]).
  assert (lF : Forall F_point l) by (unfold l; each; apply F_difference_point).
  assert (lk : Forall2 (near_vector m (u * m)) l k) by (unfold l, k; each; now apply difference_close).
  set (s := env (flat l)). set (S := env (flat k)).
  set (f := bicell_computed a b c p q).
  generalize u_bounds (m_positive m M). intros U M0.
  (* the two cells *)
  assert (Kp : Rabs (cell_p f - cell_p t) <= 93 / 2 * u * m ^ 3 /\ Rabs (cell_q f - cell_q t) <= 93 / 2 * u * m ^ 3).
  { generalize constants_cells. intro K. rewrite forallb_forall in K. split.
    - exact (proj2 (near m M l k lF lk 3 8 93 (cell_p E_bicell) (K _ (or_intror (or_introl eq_refl))))).
    - exact (proj2 (near m M l k lF lk 3 8 93 (cell_q E_bicell) (K _ (or_intror (or_intror (or_introl eq_refl)))))). }
  assert (Sp : forall es, (forall e, In e es -> In e (E_slabs ++ slabs_p E_bicell ++ slabs_q E_bicell)) ->
    Forall2 (near_vector (16 * m ^ 2) (69 / 2 * u * m ^ 2)) (map (evaluated (rounded s)) es) (map (evaluated (exact S)) es)).
  { intros es I. apply (near_vectors m M l k lF lk 2 16 69). apply forallb_forall. intros e J.
    generalize constants_slabs. rewrite forallb_forall. intro K. apply K.
    unfold all_coordinates in *. apply in_concat in J. destruct J as (d & J & J'). apply in_concat.
    apply in_map_iff in J. destruct J as (v & <- & J). exists (coordinates v). split; [| exact J']. apply in_map. now apply I. }
  generalize (Sp (slabs_p E_bicell) ltac:(intros; apply in_or_app; right; apply in_or_app; now left))
    (Sp (slabs_q E_bicell) ltac:(intros; apply in_or_app; right; apply in_or_app; now right)). clear Sp.
  change (map (evaluated (rounded s)) (slabs_p E_bicell)) with (slabs_p f).
  change (map (evaluated (rounded s)) (slabs_q E_bicell)) with (slabs_q f).
  change (map (evaluated (exact S)) (slabs_p E_bicell)) with (slabs_p t).
  change (map (evaluated (exact S)) (slabs_q E_bicell)) with (slabs_q t). intros Sp Sq.
  assert (Fcell : F (cell_p f) /\ F (cell_q f)) by (split; [apply F_opp |]; apply F_rnd).
  assert (Pp : 0 < cell_p t -> 0 < sqrt (largest R_square (slabs_p t))).
  { apply largest_positive with (v := vopp R Ropp (cross R Rminus Rmult w1 w2)); [now left |].
    intros (X & Y & Z). cbn [x y z vopp] in X, Y, Z.
    change (cell_p t) with (- dot R Rplus Rmult (cross R Rminus Rmult w1 w2) w3).
    set (n := cross R Rminus Rmult w1 w2) in *. unfold dot.
    replace (x n) with 0 by lra. replace (y n) with 0 by lra. replace (z n) with 0 by lra. lra. }
  assert (Pq : 0 < cell_q t -> 0 < sqrt (largest R_square (slabs_q t))).
  { apply largest_positive with (v := cross R Rminus Rmult w1 w2); [now left |].
    intros (X & Y & Z). change (cell_q t) with (dot R Rplus Rmult (cross R Rminus Rmult w1 w2) w4).
    unfold dot. rewrite X, Y, Z. lra. }
  generalize (decide_width_sound m _ _ _ _ certified M (proj1 Fcell) (proj1 Kp) Sp Pp)
    (decide_width_sound m _ _ _ _ certified M (proj2 Fcell) (proj2 Kp) Sq Pq). intros Wp Wq.
  (* powers and error bounds *)
  assert (P3 : bpow radix2 (-360) <= m ^ 3) by exact (pow_large m M 3).
  assert (P4 : bpow radix2 (-480) <= m ^ 4) by exact (pow_large m M 4).
  assert (P5 : bpow radix2 (-600) <= m ^ 5) by exact (pow_large m M 5).
  generalize (bpow_gt_0 radix2 (-360)) (bpow_gt_0 radix2 (-480)) (bpow_gt_0 radix2 (-600)). intros B360 B480 B600.
  generalize (error_bound_range m M 1105 _ 5 ltac:(lia) ltac:(lia) (widen m M _ _ 5 6 ltac:(lra) ltac:(lra) (power_5_range m M))).
  generalize (error_bound_range m M 3246 _ 4 ltac:(lia) ltac:(lia) (widen m M _ _ 4 4 ltac:(lra) ltac:(lra) (power_4_range m M))).
  generalize (error_bound_range m M 169 _ 3 ltac:(lia) ltac:(lia) (widen m M _ _ 4 4 ltac:(lra) ltac:(lra) (power_3_range m M))).
  set (e := error_bound 1105 (power_5 m)). set (n := error_bound 3246 (power_4 m)). set (es := error_bound 169 (power_3 m)).
  intros [SL SH] [NL NH] [EL EH].
  (* the sums of lambda *)
  assert (side : forall e C, In e [l1 E_bicell; l2 E_bicell; l3 E_bicell; minus_l4 E_bicell] ->
    rounded s e = C -> es < C -> 0 < exact S e).
  { intros x0 C I E L. generalize constants_sides. intro K. rewrite forallb_forall in K.
    destruct (near m M l k lF lk 3 32 337 x0 (K _ I)) as [_ H]. fold s S in H. rewrite E in H. apply Rabs_le_inv in H.
    assert (337 / 2 * u * m ^ 3 <= 169 * u * (1 - 8 * u) * m ^ 3) by (apply Rmult_le_compat_r; [lra | unfold u; lra]).
    lra. }
  split; [| unfold is_backward; fold m es f; split; [| split]; destruct Rlt_dec as [L |]; try discriminate; intros _].
  2: exact (side (l2 E_bicell) _ (or_intror (or_introl eq_refl)) eq_refl L).
  2: exact (side (l3 E_bicell) _ (or_intror (or_intror (or_introl eq_refl))) eq_refl L).
  2: exact (side (minus_l4 E_bicell) _ (or_intror (or_intror (or_intror (or_introl eq_refl)))) eq_refl L).
  clear side.
  (* the annuli *)
  generalize (near_vectors m M l k lF lk 4 64 1381 _ constants_n) (near_vectors m M l k lF lk 4 128 2365 _ constants_m).
  fold s S. intros HN HM.
  change (map (evaluated (rounded s)) [n1 E_bicell; n2 E_bicell; n3 E_bicell; n4 E_bicell]) with [n1 f; n2 f; n3 f; n4 f] in HN.
  change (map (evaluated (exact S)) [n1 E_bicell; n2 E_bicell; n3 E_bicell; n4 E_bicell]) with [n1 t; n2 t; n3 t; n4 t] in HN.
  change (map (evaluated (rounded s)) [m1 E_bicell; m2 E_bicell; m3 E_bicell; m4 E_bicell]) with [m1 f; m2 f; m3 f; m4 f] in HM.
  change (map (evaluated (exact S)) [m1 E_bicell; m2 E_bicell; m3 E_bicell; m4 E_bicell]) with [m1 t; m2 t; m3 t; m4 t] in HM.
  assert (HD : Rabs (determinant f - determinant t) <= 2209 / 2 * u * m ^ 5)
    by exact (proj2 (near m M l k lF lk 5 128 2209 (determinant E_bicell) constants_determinant)).
  apply forall2_4 in HN, HM. destruct HN as (N1 & N2 & N3 & N4). destruct HM as (M1 & M2 & M3 & M4).
  set (w := u * m ^ 4) in *.
  assert (w0 : 0 <= w) by (apply Rmult_le_pos; lra).
  assert (N0 : 32455 / 10 * w <= n).
  { unfold w. rewrite <- Rmult_assoc. apply Rle_trans with (2 := NL). apply Rmult_le_compat_r; [lra | unfold u; lra]. }
  assert (N9 : n <= 1 * m ^ 4) by (apply Rle_trans with (1 := NH); apply Rmult_le_compat_r; [lra | unfold u; lra]).
  assert (E0 : u * m ^ 5 <= e) by (apply Rle_trans with (2 := EL); apply Rmult_le_compat_r; [lra | unfold u; lra]).
  assert (tiny_small : tiny <= / 5 * w).
  { apply Rle_trans with (bpow radix2 (-3) * (u * bpow radix2 (-480))).
    - change u with (bpow radix2 (-53)). rewrite <- !bpow_plus. apply bpow_le. lia.
    - apply mul_below; [apply bpow_ge_0 | apply Rmult_le_pos; lra | change (bpow radix2 (-3)) with (/ 8); lra |].
      apply Rmult_le_compat_l; lra. }
  assert (big : bpow radix2 (-500) <= 64 * m ^ 4).
  { apply Rle_trans with (bpow radix2 (-480)); [apply bpow_le; lia | lra]. }
  (* one partition: computed norms against exact ones *)
  assert (partition : forall g h G H, near_vector (64 * m ^ 4) (1381 / 2 * u * m ^ 4) g G ->
    near_vector (128 * m ^ 4) (2365 / 2 * u * m ^ 4) h H ->
    (1 - 10 * u) * (R_norm G + R_norm H) <= norm_sum g h + n /\ 0 <= norm_sum g h <= 2048 * m ^ 4).
  { intros g h G H HG HH.
    assert (E1 : 0 <= 1381 / 2 * u * m ^ 4) by (apply Rmult_le_pos; lra).
    assert (E2 : 0 <= 2365 / 2 * u * m ^ 4) by (apply Rmult_le_pos; lra).
    assert (big' : bpow radix2 (-500) <= 128 * m ^ 4) by lra.
    generalize (F_norm_lower _ _ _ _ E1 HG) (F_norm_lower _ _ _ _ E2 HH)
      (F_norm_upper _ _ _ _ big HG) (F_norm_upper _ _ _ _ big' HH).
    generalize (root_sum_range (F_square g) (F_square h) (F_rnd _) (F_rnd _)).
    fold (F_norm g) (F_norm h). fold (norm_sum g h). intros [RL RH] LG LH UG UH.
    assert (0 <= F_norm g) by apply sqrt_pos. assert (0 <= F_norm h) by apply sqrt_pos.
    split; [| split; [apply Rle_trans with (2 := RL); apply Rmult_le_pos |]; lra].
    set (L := R_norm G + R_norm H).
    assert (L0 : 0 <= L) by (apply Rplus_le_le_0_compat; apply sqrt_pos).
    assert (D : (1 - 2 * u) * (L - 324425 / 100 * w) - 2 * tiny <= F_norm g + F_norm h).
    { replace (1381 / 2 * u * m ^ 4) with (1381 / 2 * w) in LG by (unfold w; ring).
      replace (2365 / 2 * u * m ^ 4) with (2365 / 2 * w) in LH by (unfold w; ring).
      assert (0 <= u * w) by (apply Rmult_le_pos; lra). assert (u * w <= / 1000 * w) by (apply Rmult_le_compat_r; lra).
      unfold L. lra. }
    apply (Rmult_le_compat_l (1 - 2 * u)) in D; [| lra].
    assert (0 <= u * w) by (apply Rmult_le_pos; lra). assert (0 <= u * (u * w)) by (apply Rmult_le_pos; lra).
    assert (u * w <= / 100000 * w) by (apply Rmult_le_compat_r; lra).
    assert (u * (u * w) <= 1 * (u * w)) by (apply Rmult_le_compat_r; lra).
    assert (0 <= u * L) by (apply Rmult_le_pos; lra). assert (0 <= u * (u * L)) by (apply Rmult_le_pos; lra).
    assert (u * (u * L) <= 1 * (u * L)) by (apply Rmult_le_compat_r; lra).
    assert (0 <= u * tiny) by (apply Rmult_le_pos; [lra | left; apply tiny_pos]). lra. }
  generalize (partition _ _ _ _ N1 M1) (partition _ _ _ _ N2 M2) (partition _ _ _ _ N3 M3) (partition _ _ _ _ N4 M4).
  intros [A1 R1] [A2 R2] [A3 R3] [A4 R4]. clear partition.
  set (roots := Rmax (Rmax (norm_sum (n1 f) (m1 f)) (norm_sum (n2 f) (m2 f)))
                     (Rmax (norm_sum (n3 f) (m3 f)) (norm_sum (n4 f) (m4 f)))).
  assert (Q1 : norm_sum (n1 f) (m1 f) <= roots) by (apply Rle_trans with (2 := Rmax_l _ _); apply Rmax_l).
  assert (Q2 : norm_sum (n2 f) (m2 f) <= roots) by (apply Rle_trans with (2 := Rmax_l _ _); apply Rmax_r).
  assert (Q3 : norm_sum (n3 f) (m3 f) <= roots) by (apply Rle_trans with (2 := Rmax_r _ _); apply Rmax_l).
  assert (Q4 : norm_sum (n4 f) (m4 f) <= roots) by (apply Rle_trans with (2 := Rmax_r _ _); apply Rmax_r).
  assert (Qm : roots <= 2048 * m ^ 4) by (repeat apply Rmax_lub; tauto).
  assert (Froots : F roots) by (apply F_max; apply F_max; apply F_rnd).
  assert (annulus : forall T, (0 < determinant t -> 0 < T) -> (1 - 10 * u) * T <= roots + n ->
    sound (decide (determinant f) roots e n certified) certified (determinant t) T).
  { intros T HT HR. apply decide_sound; try assumption.
    - apply F_rnd.
    - apply F_error_bound.
    - apply F_error_bound.
    - apply Rlt_le_trans with (2 := E0). apply Rmult_lt_0_compat; lra.
    - lra.
    - lra.
    - apply Rle_trans with (1 := HD). apply Rle_trans with (2 := EL). apply Rmult_le_compat_r; [lra | unfold u; lra].
    - apply Rle_trans with (2 := E0). apply Rle_trans with (bpow radix2 (-900) * (4096 * m ^ 4)).
      + apply Rmult_le_compat_l; [apply bpow_ge_0 | lra].
      + replace (u * m ^ 5) with (u * m * m ^ 4) by ring. rewrite <- Rmult_assoc. apply Rmult_le_compat_r; [lra |].
        apply Rle_trans with (u * bpow radix2 (-120)).
        * change u with (bpow radix2 (-53)). change 4096 with (bpow radix2 12). rewrite <- !bpow_plus. apply bpow_le. lia.
        * apply Rmult_le_compat_l; lra. }
  generalize (annuli_positive w1 w2 w3 w4). change (R_bicell w1 w2 w3 w4) with t. intros (T1 & T2 & T3 & T4).
  generalize (annulus _ T1 ltac:(lra)) (annulus _ T2 ltac:(lra)) (annulus _ T3 ltac:(lra)) (annulus _ T4 ltac:(lra)).
  clear annulus. intros Z1 Z2 Z3 Z4.
  assert (whole : forall sign value, decide (determinant f) roots e n certified = Some (sign, value) ->
    sign = 1%Z /\ 0 < determinant t /\ (certified = true -> 0 <= value /\
      value <= determinant t / (R_norm (n1 t) + R_norm (m1 t)) /\
      value <= determinant t / (R_norm (n2 t) + R_norm (m2 t)) /\
      value <= determinant t / (R_norm (n3 t) + R_norm (m3 t)) /\
      value <= determinant t / (R_norm (n4 t) + R_norm (m4 t)))
    \/ sign = (-1)%Z /\ determinant t < 0).
  { intros sign value A. generalize (Z1 _ _ A) (Z2 _ _ A) (Z3 _ _ A) (Z4 _ _ A).
    intros [(? & ? & Y1) | N] [(? & ? & Y2) | ?] [(? & ? & Y3) | ?] [(? & ? & Y4) | ?]; try (right; assumption).
    left. split; [assumption |]. split; [assumption |]. intro C.
    specialize (Y1 C). specialize (Y2 C). specialize (Y3 C). specialize (Y4 C). tauto. }
  clear Z1 Z2 Z3 Z4.
  intros sign value A. unfold bicell_filter in A. fold m f e n roots in A.
  destruct (in_range_dec 100 m) as [_ |]; [| discriminate].
  destruct (cells_needed a b c p q use).
  - destruct in_doubt; [discriminate |]. apply both_some in A. destruct A as [(A & N) | (-> & v & w' & A & A' & ->)].
    + apply both_some in A. destruct A as [(A & _) | (-> & _)]; [| congruence].
      destruct (whole _ _ A) as [(? & _) | ?]; [congruence | now right].
    + apply both_some in A. destruct A as [(_ & N) | (_ & v' & w'' & A & A'' & ->)]; [congruence |].
      destruct (whole _ _ A) as [(_ & D & C) | (? & _)]; [| discriminate].
      destruct (Wp _ _ A'') as [(_ & Dp & Cp) | (? & _)]; [| discriminate].
      destruct (Wq _ _ A') as [(_ & Dq & Cq) | (? & _)]; [| discriminate].
      left. split; [reflexivity |]. split; [exact D |]. split; [tauto |]. intro CC.
      specialize (C CC). specialize (Cp CC). specialize (Cq CC).
      generalize (Rmin_l (Rmin v' w'') w') (Rmin_r (Rmin v' w'') w') (Rmin_l v' w'') (Rmin_r v' w''). intros.
      assert (0 <= Rmin (Rmin v' w'') w') by (repeat apply Rmin_glb; tauto).
      repeat split; try lra; try assumption.
  - destruct (whole _ _ A) as [(-> & D & C) | ?]; [| now right].
    left. split; [reflexivity |]. split; [exact D |]. split; [discriminate |]. intro CC. specialize (C CC).
    destruct C as (C0 & C1 & C2 & C3 & C4). repeat (split; [assumption |]). discriminate.
Qed.

(* Whoever has an answer was in the range. *)
Theorem bicell_answer_sound a b c p q certified use :
  F_point a -> F_point b -> F_point c -> F_point p -> F_point q ->
  bicell_sound (bicell_filter a b c p q certified use) certified (cells_needed a b c p q use) (bicell_truth a b c p q).
Proof.
  intros Fa Fb Fc Fp Fq sign value A. generalize A. intro A'. unfold bicell_filter in A'.
  destruct (in_range_dec 100 (bicell_m a b c p q)) as [I |]; [clear A' | discriminate].
  exact (proj1 (bicell_filter_sound a b c p q certified use Fa Fb Fc Fp Fq I) sign value A).
Qed.
