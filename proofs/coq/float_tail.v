(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The last operations of the filter stage, `detail::decide` of src/annulus/predicate/decide.h, and the norms they use: from
   error bounds of the terms to a tolerance that is not above the truth. *)
Require Import Reals Lra Psatz ZArith.
From Flocq Require Import Core.
From Annulus Require Import float_model float_error.
Open Scope R_scope.

(* 2^-10 and 1 - 16 u of bounds.h. *)
Definition filter_slack : R := / 1024.
Definition shrink : R := 1 - 16 * u.

Definition tolerance (det roots det_error norm_error : R) : R :=
  fmul (rnd (fsub det det_error / fadd roots norm_error)) shrink.

Lemma mul_below a b x y : 0 <= a -> 0 <= x -> a <= b -> x <= y -> a * x <= b * y.
Proof. intros. apply Rmult_le_compat; assumption. Qed.

Lemma fmul_lower a b l k : 0 <= l <= a -> 0 <= k <= b -> bpow radix2 (-1022) <= l * k ->
  l * k * (1 - u) <= fmul a b.
Proof.
  intros [L0 L] [K0 K] N. apply Rle_trans with (rnd (l * k)).
  - now apply rnd_normal_le.
  - apply rnd_le. apply mul_below; assumption.
Qed.

Lemma fmul_upper a b l k : 0 <= a <= l -> 0 <= b <= k -> bpow radix2 (-1022) <= l * k ->
  fmul a b <= l * k * (1 + u).
Proof.
  intros [A0 A] [B0 B] N. apply Rle_trans with (rnd (l * k)).
  - apply rnd_le. apply mul_below; assumption.
  - now apply rnd_normal_le.
Qed.

Lemma fmul_pos a b : 0 <= a -> 0 <= b -> 0 <= fmul a b.
Proof. intros. apply rnd_pos. now apply Rmult_le_pos. Qed.

Lemma fmul_square_pos a : 0 <= fmul a a.
Proof. apply rnd_pos. apply Rle_0_sqr. Qed.

(* Norms. A computed sum of squares loses a factor and what underflows. *)
Definition tiny : R := bpow radix2 (-536).

Lemma root_lower S L c t : 0 <= S -> 0 <= t -> 0 <= c * L -> (c * L) * (c * L) <= S + t * t -> c * L - t <= sqrt S.
Proof.
  intros HS Ht HL H. destruct (Rle_or_lt (c * L) t) as [Q | Q].
  - generalize (sqrt_pos S). lra.
  - rewrite <- (sqrt_square (c * L - t)) by lra. apply sqrt_le_1_alt. nra.
Qed.

Lemma tiny_square : tiny * tiny = 8 * eta.
Proof.
  unfold tiny, eta. rewrite <- bpow_plus. change 8 with (bpow radix2 3). rewrite <- bpow_plus. reflexivity.
Qed.

Lemma tiny_pos : 0 < tiny.
Proof. apply bpow_gt_0. Qed.

Lemma square_lower a : a * a * (1 - u) - eta <= fmul a a <= a * a * (1 + u) + eta.
Proof. apply rnd_any_le. apply Rle_0_sqr. Qed.

Lemma norm_2_lower a b : (1 - u) * sqrt (a * a + b * b) - tiny <= sqrt (fadd (fmul a a) (fmul b b)).
Proof.
  generalize (square_lower a) (square_lower b) (fmul_square_pos a) (fmul_square_pos b) u_bounds eta_pos.
  intros A B A0 B0 U H.
  assert (S : (fmul a a + fmul b b) * (1 - u) <= fadd (fmul a a) (fmul b b))
    by (apply rnd_add_le; [apply F_rnd | apply F_rnd | lra]).
  assert (P : 0 <= a * a + b * b) by nra.
  apply root_lower.
  - apply rnd_pos. lra.
  - left. apply tiny_pos.
  - apply Rmult_le_pos; [lra | apply sqrt_pos].
  - replace ((1 - u) * sqrt (a * a + b * b) * ((1 - u) * sqrt (a * a + b * b)))
      with ((1 - u) * (1 - u) * (sqrt (a * a + b * b) * sqrt (a * a + b * b))) by ring.
    rewrite sqrt_sqrt by exact P. rewrite tiny_square. nra.
Qed.

Lemma norm_3_lower a b c :
  (1 - 2 * u) * sqrt (a * a + b * b + c * c) - tiny <= sqrt (fadd (fadd (fmul a a) (fmul b b)) (fmul c c)).
Proof.
  generalize (square_lower a) (square_lower b) (square_lower c) (fmul_square_pos a) (fmul_square_pos b)
    (fmul_square_pos c) u_bounds eta_pos.
  intros A B C A0 B0 C0 U H.
  assert (S : (fmul a a + fmul b b) * (1 - u) <= fadd (fmul a a) (fmul b b))
    by (apply rnd_add_le; [apply F_rnd | apply F_rnd | lra]).
  assert (S0 : 0 <= fadd (fmul a a) (fmul b b)) by (apply rnd_pos; lra).
  assert (T : (fadd (fmul a a) (fmul b b) + fmul c c) * (1 - u) <= fadd (fadd (fmul a a) (fmul b b)) (fmul c c))
    by (apply rnd_add_le; [apply F_rnd | apply F_rnd | lra]).
  assert (P : 0 <= a * a + b * b + c * c) by nra.
  apply root_lower.
  - apply rnd_pos. lra.
  - left. apply tiny_pos.
  - apply Rmult_le_pos; [lra | apply sqrt_pos].
  - replace ((1 - 2 * u) * sqrt (a * a + b * b + c * c) * ((1 - 2 * u) * sqrt (a * a + b * b + c * c)))
      with ((1 - 2 * u) * (1 - 2 * u) * (sqrt (a * a + b * b + c * c) * sqrt (a * a + b * b + c * c))) by ring.
    rewrite sqrt_sqrt by exact P. rewrite tiny_square.
    set (r := fadd (fadd (fmul a a) (fmul b b)) (fmul c c)) in *. set (s := fadd (fmul a a) (fmul b b)) in *.
    assert (K : (1 - 2 * u) * (1 - 2 * u) <= (1 - u) * (1 - u) * (1 - u)) by (unfold u; lra).
    assert (V : a * a + b * b + c * c - 3 * eta <= (fmul a a + fmul b b + fmul c c) + u * (a * a + b * b + c * c)) by lra.
    assert (W : (1 - u) * ((1 - u) * (fmul a a + fmul b b + fmul c c)) <= r).
    { apply Rle_trans with (2 := T). rewrite (Rmult_comm _ (1 - u)). apply Rmult_le_compat_l; [lra |]. nra. }
    apply Rle_trans with ((1 - u) * (1 - u) * (1 - u) * (a * a + b * b + c * c)).
    + apply Rmult_le_compat_r; assumption.
    + apply Rle_trans with ((1 - u) * ((1 - u) * (fmul a a + fmul b b + fmul c c + 3 * eta))).
      * replace ((1 - u) * (1 - u) * (1 - u) * (a * a + b * b + c * c))
          with ((1 - u) * ((1 - u) * ((1 - u) * (a * a + b * b + c * c)))) by ring.
        apply Rmult_le_compat_l; [lra |]. apply Rmult_le_compat_l; lra.
      * assert ((1 - u) * (1 - u) <= 1) by nra.
        assert ((1 - u) * (1 - u) * (3 * eta) <= 1 * (3 * eta)) by (apply Rmult_le_compat_r; lra). lra.
Qed.

(* Crude, to exclude that the quotient underflows. *)
Lemma square_upper a K : Rabs a <= K -> bpow radix2 (-500) <= K -> fmul a a <= 2 * (K * K).
Proof.
  intros A N. generalize (bpow_gt_0 radix2 (-500)). intro P.
  assert (Q : a * a <= K * K) by (apply Rabs_le_inv in A; nra).
  apply Rle_trans with (rnd (K * K)); [now apply rnd_le |].
  assert (M : bpow radix2 (-1022) <= K * K).
  { apply Rle_trans with (bpow radix2 (-500) * bpow radix2 (-500)).
    - rewrite <- bpow_plus. apply bpow_le. lia.
    - apply mul_below; lra. }
  generalize (rnd_normal_le _ M) u_bounds. intros. assert (0 <= K * K) by nra. nra.
Qed.

Lemma norm_2_upper a b K : Rabs a <= K -> Rabs b <= K -> bpow radix2 (-500) <= K ->
  sqrt (fadd (fmul a a) (fmul b b)) <= 4 * K.
Proof.
  intros A B N. generalize (square_upper _ _ A N) (square_upper _ _ B N) (fmul_square_pos a) (fmul_square_pos b)
    (bpow_gt_0 radix2 (-500)) u_bounds. intros.
  rewrite <- (sqrt_square (4 * K)) by lra. apply sqrt_le_1_alt.
  assert (S : fadd (fmul a a) (fmul b b) <= (fmul a a + fmul b b) * (1 + u))
    by (apply rnd_add_le; [apply F_rnd | apply F_rnd | lra]).
  nra.
Qed.

Lemma norm_3_upper a b c K : Rabs a <= K -> Rabs b <= K -> Rabs c <= K -> bpow radix2 (-500) <= K ->
  sqrt (fadd (fadd (fmul a a) (fmul b b)) (fmul c c)) <= 4 * K.
Proof.
  intros A B C N. generalize (square_upper _ _ A N) (square_upper _ _ B N) (square_upper _ _ C N)
    (fmul_square_pos a) (fmul_square_pos b) (fmul_square_pos c) (bpow_gt_0 radix2 (-500)) u_bounds. intros.
  rewrite <- (sqrt_square (4 * K)) by lra. apply sqrt_le_1_alt.
  assert (S : fadd (fmul a a) (fmul b b) <= (fmul a a + fmul b b) * (1 + u))
    by (apply rnd_add_le; [apply F_rnd | apply F_rnd | lra]).
  assert (S0 : 0 <= fadd (fmul a a) (fmul b b)) by (apply rnd_pos; lra).
  assert (T : fadd (fadd (fmul a a) (fmul b b)) (fmul c c) <= (fadd (fmul a a) (fmul b b) + fmul c c) * (1 + u))
    by (apply rnd_add_le; [apply F_rnd | apply F_rnd | lra]).
  assert (fadd (fmul a a) (fmul b b) <= 5 * (K * K)) by nra. nra.
Qed.

(* The exact norm against that of the computed vector: sqrt 2 < 1.4143, sqrt 3 < 1.7321. *)
Lemma norm_2_close a b A B E : Rabs (a - A) <= E -> Rabs (b - B) <= E ->
  sqrt (A * A + B * B) - 14143 / 10000 * E <= sqrt (a * a + b * b).
Proof.
  intros HA HB. assert (E0 : 0 <= E) by (generalize (Rabs_pos (a - A)); lra).
  apply Rabs_le_inv in HA, HB.
  set (L := sqrt (A * A + B * B)).
  assert (L0 : 0 <= L) by apply sqrt_pos.
  assert (LL : L * L = A * A + B * B) by (apply sqrt_sqrt; nra).
  destruct (Rle_or_lt L (14143 / 10000 * E)) as [Q | Q]; [generalize (sqrt_pos (a * a + b * b)); lra |].
  set (l := sqrt (a * a + b * b)). assert (l0 : 0 <= l) by apply sqrt_pos.
  assert (ll : l * l = a * a + b * b) by (apply sqrt_sqrt; nra).
  assert (D : (a - A) * (a - A) + (b - B) * (b - B) <= 2 * (E * E)) by nra.
  (* A^2 + B^2 <= (l + r E)^2 by Cauchy *)
  assert (C : (a * (A - a) + b * (B - b)) <= 14143 / 10000 * E * l).
  { destruct (Rle_or_lt (a * (A - a) + b * (B - b)) 0) as [N | N]; [nra |].
    apply Rsqr_incr_0_var; [| nra]. unfold Rsqr.
    assert (Y : (a * (A - a) + b * (B - b)) * (a * (A - a) + b * (B - b))
                <= (a * a + b * b) * ((a - A) * (a - A) + (b - B) * (b - B))).
    { assert (0 <= (a * (B - b) - b * (A - a)) * (a * (B - b) - b * (A - a))) by apply Rle_0_sqr. nra. }
    apply Rle_trans with (1 := Y). rewrite <- ll.
    apply Rle_trans with (l * l * (2 * (E * E))); [apply Rmult_le_compat_l; nra | nra]. }
  assert (G : L * L <= (l + 14143 / 10000 * E) * (l + 14143 / 10000 * E)) by nra.
  assert (L <= l + 14143 / 10000 * E) by (apply Rsqr_incr_0_var; [exact G | nra]). lra.
Qed.

Lemma norm_3_close a b c A B C E : Rabs (a - A) <= E -> Rabs (b - B) <= E -> Rabs (c - C) <= E ->
  sqrt (A * A + B * B + C * C) - 17321 / 10000 * E <= sqrt (a * a + b * b + c * c).
Proof.
  intros HA HB HC. assert (E0 : 0 <= E) by (generalize (Rabs_pos (a - A)); lra).
  apply Rabs_le_inv in HA, HB, HC.
  set (L := sqrt (A * A + B * B + C * C)).
  assert (L0 : 0 <= L) by apply sqrt_pos.
  assert (LL : L * L = A * A + B * B + C * C) by (apply sqrt_sqrt; nra).
  set (l := sqrt (a * a + b * b + c * c)). assert (l0 : 0 <= l) by apply sqrt_pos.
  assert (ll : l * l = a * a + b * b + c * c) by (apply sqrt_sqrt; nra).
  set (x := A - a). set (y := B - b). set (z := C - c).
  assert (D : x * x + y * y + z * z <= 3 * (E * E)) by (unfold x, y, z; nra).
  assert (K : a * x + b * y + c * z <= 17321 / 10000 * E * l).
  { destruct (Rle_or_lt (a * x + b * y + c * z) 0) as [N | N]; [nra |].
    apply Rsqr_incr_0_var; [| nra]. unfold Rsqr.
    assert (Y : (a * x + b * y + c * z) * (a * x + b * y + c * z) <= (a * a + b * b + c * c) * (x * x + y * y + z * z)).
    { generalize (Rle_0_sqr (a * y - b * x)) (Rle_0_sqr (a * z - c * x)) (Rle_0_sqr (b * z - c * y)).
      unfold Rsqr. lra. }
    apply Rle_trans with (1 := Y). rewrite <- ll.
    apply Rle_trans with (l * l * (3 * (E * E))); [apply Rmult_le_compat_l; nra | nra]. }
  assert (V : L * L = l * l + 2 * (a * x + b * y + c * z) + (x * x + y * y + z * z))
    by (rewrite LL, ll; unfold x, y, z; ring).
  assert (G : L * L <= (l + 17321 / 10000 * E) * (l + 17321 / 10000 * E)) by nra.
  assert (L <= l + 17321 / 10000 * E) by (apply Rsqr_incr_0_var; [exact G | nra]). lra.
Qed.

(* The sign: nothing but the error bound. *)
Lemma negative_sound det computed det_error : Rabs (computed - det) <= det_error -> computed < - det_error -> det < 0.
Proof. intros H N. apply Rabs_le_inv in H. lra. Qed.

Lemma slack_sound x e : F e -> e < fmul x filter_slack -> 1024 * e < x.
Proof. intros Fe H. apply rnd_gt in H; [| exact Fe]. unfold filter_slack in H. lra. Qed.

(* The computed sum of two roots. *)
Definition root_sum (inner outer : R) : R := fadd (rnd (sqrt inner)) (rnd (sqrt outer)).

Lemma root_sum_range inner outer : F inner -> F outer ->
  (1 - 2 * u) * (sqrt inner + sqrt outer) <= root_sum inner outer <= 2 * (sqrt inner + sqrt outer).
Proof.
  intros Fi Fo. generalize u_bounds (sqrt_pos inner) (sqrt_pos outer) (rnd_sqrt_le _ Fi) (rnd_sqrt_le _ Fo).
  intros U I0 O0 Ri Ro.
  assert (Ri0 : 0 <= rnd (sqrt inner)) by now apply rnd_pos.
  assert (Ro0 : 0 <= rnd (sqrt outer)) by now apply rnd_pos.
  generalize (rnd_add_le _ _ (F_rnd (sqrt inner)) (F_rnd (sqrt outer)) ltac:(lra)).
  fold (fadd (rnd (sqrt inner)) (rnd (sqrt outer))). fold (root_sum inner outer). intros [L H]. split.
  - apply Rle_trans with (2 := L).
    apply Rle_trans with ((sqrt inner + sqrt outer) * (1 - u) * (1 - u)).
    + rewrite Rmult_assoc, (Rmult_comm (1 - 2 * u)). apply Rmult_le_compat_l; [lra | unfold u; lra].
    + apply Rmult_le_compat_r; lra.
  - apply Rle_trans with (1 := H).
    apply Rle_trans with ((sqrt inner + sqrt outer) * (1 + u) * (1 + u)).
    + apply Rmult_le_compat_r; lra.
    + rewrite Rmult_assoc, (Rmult_comm 2). apply Rmult_le_compat_l; [lra | unfold u; lra].
Qed.

(* The last five operations. `truth` is an exact sum of two norms, or twice a longest side; what the code has for it falls
   short by a factor and by at most norm_error. *)
Theorem tolerance_sound det truth computed roots det_error norm_error :
  F computed -> F roots -> F det_error -> F norm_error ->
  0 < det_error -> 0 <= norm_error -> 0 <= roots -> (0 < det -> 0 < truth) ->
  Rabs (computed - det) <= det_error ->
  (1 - 10 * u) * truth <= roots + norm_error ->
  bpow radix2 (-900) * (roots + norm_error) <= det_error ->
  det_error < fmul computed filter_slack ->
  0 < det /\ 0 <= tolerance computed roots det_error norm_error <= det / truth.
Proof.
  intros Fc Fr Fe Fn He Hn Hr Ht HE HR HU HS.
  apply slack_sound in HS; [| exact Fe]. apply Rabs_le_inv in HE.
  assert (Hdet : computed - det_error <= det) by lra.
  specialize (Ht ltac:(lra)). generalize u_bounds. intro U.
  set (A := roots + norm_error) in *.
  assert (A0 : 0 < A) by (apply Rlt_le_trans with (2 := HR); apply Rmult_lt_0_compat; lra).
  (* numerator and denominator *)
  assert (Num : (computed - det_error) * (1 - u) <= fsub computed det_error <= (computed - det_error) * (1 + u)).
  { unfold fsub. change (computed - det_error) with (computed + - det_error).
    apply rnd_add_le; [exact Fc | now apply F_opp | lra]. }
  generalize (rnd_add_le _ _ Fr Fn ltac:(lra)). fold (fadd roots norm_error). fold A.
  set (den := fadd roots norm_error). intros [Low High].
  assert (D0 : 0 < den) by (apply Rlt_le_trans with (2 := Low); apply Rmult_lt_0_compat; lra).
  assert (D2 : den <= 2 * A) by (apply Rle_trans with (1 := High); rewrite Rmult_comm; apply Rmult_le_compat_r; lra).
  set (num := fsub computed det_error) in *.
  assert (N0 : 2 * det_error <= num).
  { apply Rle_trans with (2 := proj1 Num). apply Rle_trans with ((4 * det_error) * / 2); [lra |].
    apply mul_below; lra. }
  (* quotient: far from underflow *)
  set (q := num / den). assert (Q : q * den = num) by (unfold q; field; lra).
  assert (Qlow : bpow radix2 (-900) <= q).
  { apply Rmult_le_reg_r with den; [exact D0 |]. rewrite Q.
    apply Rle_trans with (bpow radix2 (-900) * (2 * A)); [| lra].
    apply Rmult_le_compat_l; [apply bpow_ge_0 | exact D2]. }
  assert (big : bpow radix2 (-1022) <= bpow radix2 (-900) / 4).
  { unfold Rdiv. change 4 with (bpow radix2 2). rewrite <- bpow_opp, <- bpow_plus. apply bpow_le. lia. }
  assert (P900 : 0 < bpow radix2 (-900)) by apply bpow_gt_0.
  generalize (rnd_normal_le q ltac:(lra)). intro Rq.
  assert (sh : / 2 <= shrink <= 1) by (unfold shrink; lra).
  assert (Rt : rnd q * shrink * (1 - u) <= fmul (rnd q) shrink <= rnd q * shrink * (1 + u)).
  { apply rnd_normal_le. apply Rle_trans with (bpow radix2 (-900) / 2 * / 2); [lra |].
    assert (bpow radix2 (-900) * / 2 <= q * (1 - u)) by (apply mul_below; lra).
    apply mul_below; lra. }
  unfold tolerance. fold num den q.
  assert (q0 : 0 < q) by lra.
  split; [lra | split].
  - apply fmul_pos; [apply rnd_pos |]; lra.
  - apply Rmult_le_reg_r with truth; [exact Ht |].
    unfold Rdiv. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
    set (c := (1 - 10 * u) * (1 - u)).
    assert (C0 : 0 < c) by (unfold c, u; lra).
    assert (T1 : truth * c <= den).
    { apply Rle_trans with (2 := Low). unfold c. rewrite <- Rmult_assoc. apply Rmult_le_compat_r; lra. }
    assert (T2 : fmul (rnd q) shrink <= q * ((1 + u) * shrink * (1 + u))).
    { apply Rle_trans with (1 := proj2 Rt). rewrite <- !Rmult_assoc.
      do 2 (apply Rmult_le_compat_r; [lra |]). apply Rq. }
    apply Rmult_le_reg_r with c; [exact C0 |].
    apply Rle_trans with (q * ((1 + u) * shrink * (1 + u)) * (truth * c)).
    { rewrite Rmult_assoc. apply Rmult_le_compat_r; [apply Rmult_le_pos; lra | exact T2]. }
    apply Rle_trans with (q * ((1 + u) * shrink * (1 + u)) * den).
    { apply Rmult_le_compat_l; [| exact T1]. apply Rmult_le_pos; [lra |]. unfold shrink, u. lra. }
    replace (q * ((1 + u) * shrink * (1 + u)) * den) with (num * ((1 + u) * shrink * (1 + u))) by (rewrite <- Q; ring).
    apply Rle_trans with ((det * (1 + u)) * ((1 + u) * shrink * (1 + u))).
    { apply Rmult_le_compat_r; [unfold shrink, u; lra |]. apply Rle_trans with (1 := proj2 Num).
      apply Rmult_le_compat_r; lra. }
    rewrite Rmult_assoc. apply Rmult_le_compat_l; [lra |].
    unfold c, shrink, u. lra.
Qed.
