(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Orientation and empty circle in the plane, certified from a reference: docs/theory.md, sections 2.1 and 2.2. The numbers are
   those of src/annulus/predicate/width_terms.h.

   orientation_certified_2   a triangle, unequal moves
   orientation_tolerance_2   a triangle, every corner closer than half its least altitude
   orientation_attained_2    there is a flat placement at exactly that distance
   circle_certified_2        an empty circle, unequal moves of its two sides; the triangles being positive at the placement
   circle_tolerance_2        the same with every point closer than half the width: what the code requires of a bi-cell's own record
   sign_tolerance_2          all three half widths from one reference: nothing is required of the triangles at the placement
   sum_of_centres            the plane's N is a sum over B of 2 lambda_i times circumcentres, as in bicell.v *)
Require Import Reals Lra Psatz Rgeom.
From Annulus Require Import vectors motion width_2.
Open Scope R_scope.

Lemma dist_norm x y u v : dist_euc x y u v = norm (V (x - u) (y - v) 0).
Proof. unfold dist_euc, norm, sq, dot, Rsqr. cbn [X1 X2 X3]. f_equal. ring. Qed.

(* A functional (k, l) at a point moved by less than e. *)
Lemma functional k l x y fx fy e : 0 < norm (V k l 0) -> dist_euc x y fx fy < e ->
  Rabs ((k * x + l * y) - (k * fx + l * fy)) < e * norm (V k l 0).
Proof.
  intros H D. rewrite dist_norm in D.
  replace ((k * x + l * y) - (k * fx + l * fy)) with (V k l 0 · V (x - fx) (y - fy) 0) by (coordinates; ring).
  apply Rle_lt_trans with (1 := cauchy _ _). rewrite Rmult_comm. now apply Rmult_lt_compat_r.
Qed.

Section triangle.
Variables ax ay bx by0 cx cy : R.      (* reference *)
Let side_a := dist_euc bx by0 cx cy.
Let side_b := dist_euc ax ay cx cy.
Let side_c := dist_euc ax ay bx by0.
Let area2 := turn ax ay bx by0 cx cy.
Definition half_altitude := area2 / (2 * Rmax (Rmax side_c side_b) side_a).

Hypothesis positive : 0 < area2.

(* The altitude on the side e f from m: m stays on its side of a line parallel to e f. *)
Lemma altitude_stays mx my ex ey fx fy  nmx nmy nex ney nfx nfy  dm de df :
  turn mx my ex ey fx fy = area2 ->
  dist_euc nmx nmy mx my < dm -> dist_euc nex ney ex ey < de -> dist_euc nfx nfy fx fy < df ->
  (dm + Rmax de df) * dist_euc ex ey fx fy <= area2 ->
  exists k l t, k * nmx + l * nmy < t /\ t < k * nex + l * ney /\ t < k * nfx + l * nfy.
Proof.
  intros T Dm De Df W. set (k := fy - ey). set (l := ex - fx).
  assert (E : norm (V k l 0) = dist_euc ex ey fx fy)
    by (rewrite dist_norm; apply norm_of_sq; unfold k, l; coordinates; ring).
  assert (A : (k * ex + l * ey) - (k * mx + l * my) = area2) by (rewrite <- T; unfold turn, k, l; ring).
  assert (B : k * fx + l * fy = k * ex + l * ey) by (unfold k, l; ring).
  assert (P : 0 < norm (V k l 0)).
  { apply norm_pos. intro Z0. injection Z0 as Zk Zl. rewrite Zk, Zl in A. lra. }
  rewrite <- E in W.
  assert (Me := functional k l _ _ _ _ _ P De). assert (Mf := functional k l _ _ _ _ _ P Df). assert (Mm := functional k l _ _ _ _ _ P Dm).
  apply Rabs_def2 in Me, Mf, Mm.
  assert (de * norm (V k l 0) <= Rmax de df * norm (V k l 0)) by (apply Rmult_le_compat_r; [lra | apply Rmax_l]).
  assert (df * norm (V k l 0) <= Rmax de df * norm (V k l 0)) by (apply Rmult_le_compat_r; [lra | apply Rmax_r]).
  exists k, l, (k * mx + l * my + dm * norm (V k l 0)). repeat split; lra.
Qed.

Variables da db dc : R.                (* bounds of the moves *)
Hypothesis altitude_a : (da + Rmax db dc) * side_a <= area2.
Hypothesis altitude_b : (db + Rmax da dc) * side_b <= area2.
Hypothesis altitude_c : (dc + Rmax da db) * side_c <= area2.

Lemma not_flat_2 mx my nx ny ox oy :
  dist_euc mx my ax ay < da -> dist_euc nx ny bx by0 < db -> dist_euc ox oy cx cy < dc -> turn mx my nx ny ox oy <> 0.
Proof.
  intros Da Db Dc F. destruct (flat_triangle_has_a_middle _ _ _ _ _ _ F) as [H|[H|H]].
  - destruct (altitude_stays ax ay bx by0 cx cy mx my nx ny ox oy da db dc) as (k & l & t & K); try assumption; try reflexivity.
    now apply (H k l t).
  - destruct (altitude_stays bx by0 cx cy ax ay nx ny ox oy mx my db dc da) as (k & l & t & K1 & K2 & K3); try assumption.
    + unfold area2, turn. ring.
    + rewrite Rmax_comm. unfold side_b in altitude_b. now rewrite (distance_symm cx cy ax ay).
    + now apply (H k l t).
  - destruct (altitude_stays cx cy ax ay bx by0 ox oy mx my nx ny dc da db) as (k & l & t & K1 & K2 & K3); try assumption.
    + unfold area2, turn. ring.
    + now apply (H k l t).
Qed.

Theorem orientation_certified_2 mx my nx ny ox oy :
  dist_euc mx my ax ay < da -> dist_euc nx ny bx by0 < db -> dist_euc ox oy cx cy < dc -> 0 < turn mx my nx ny ox oy.
Proof.
  intros Da Db Dc. apply Rnot_le_lt. intro N.
  pose (f t := turn (ax + t * (mx - ax)) (ay + t * (my - ay)) (bx + t * (nx - bx)) (by0 + t * (ny - by0))
                    (cx + t * (ox - cx)) (cy + t * (oy - cy))).
  assert (L : forall u v, continuity (fun t => u + t * (v - u))).
  { intros u v. apply continuous_plus; [apply continuous_const|]. apply continuous_mult; [apply continuous_id | apply continuous_const]. }
  assert (C : continuity f).
  { unfold f, turn. apply continuous_minus; apply continuous_mult; apply continuous_minus; apply L. }
  destruct (vanishes f C) as (t & Ht & E).
  - unfold f. rewrite !Rmult_0_l, !Rplus_0_r. exact positive.
  - replace (f 1) with (turn mx my nx ny ox oy) by (unfold f, turn; ring). exact N.
  - assert (S : forall u v x y d, dist_euc u v x y < d -> dist_euc (x + t * (u - x)) (y + t * (v - y)) x y < d).
    { intros u v x y d D. apply Rle_lt_trans with (2 := D). rewrite !dist_norm.
      replace (V (x + t * (u - x) - x) (y + t * (v - y) - y) 0) with (t ⊙ V (u - x) (v - y) 0) by (apply vec_eq; coordinates; ring).
      now apply norm_shorter. }
    revert E. apply not_flat_2; now apply S.
Qed.
End triangle.

Section triangle_equal.
Variables ax ay bx by0 cx cy : R.
Hypothesis positive : 0 < turn ax ay bx by0 cx cy.
Let longest := Rmax (Rmax (dist_euc ax ay bx by0) (dist_euc ax ay cx cy)) (dist_euc bx by0 cx cy).

Lemma longest_pos : 0 < longest.
Proof.
  assert (0 < dist_euc bx by0 cx cy).
  { rewrite dist_norm. apply norm_pos. intro E. injection E as E1 E2.
    assert (bx = cx) by lra. assert (by0 = cy) by lra. subst. unfold turn in positive. lra. }
  unfold longest. generalize (Rmax_r (Rmax (dist_euc ax ay bx by0) (dist_euc ax ay cx cy)) (dist_euc bx by0 cx cy)). lra.
Qed.

Theorem orientation_tolerance_2 mx my nx ny ox oy s : s <= half_altitude ax ay bx by0 cx cy ->
  dist_euc mx my ax ay < s -> dist_euc nx ny bx by0 < s -> dist_euc ox oy cx cy < s -> 0 < turn mx my nx ny ox oy.
Proof.
  intros H Da Db Dc. unfold half_altitude in H. fold longest in H. generalize longest_pos. intro L.
  assert (0 <= s) by (rewrite dist_norm in Da; generalize (norm_nonneg (V (mx - ax) (my - ay) 0)); lra).
  apply Rmult_le_compat_r with (r := 2 * longest) in H; [|lra].
  replace (turn ax ay bx by0 cx cy / (2 * longest) * (2 * longest)) with (turn ax ay bx by0 cx cy) in H by (field; lra).
  assert (K : forall side, side <= longest -> (s + Rmax s s) * side <= turn ax ay bx by0 cx cy).
  { intros side Hs. rewrite Rmax_left by lra. apply Rle_trans with (2 := H).
    replace (s * (2 * longest)) with ((s + s) * longest) by ring. apply Rmult_le_compat_l; lra. }
  apply orientation_certified_2 with ax ay bx by0 cx cy s s s; try assumption; apply K; unfold longest; leaf.
Qed.

(* The half altitude is the largest such number. *)
Lemma flattened mx my ex ey fx fy : 0 < turn mx my ex ey fx fy ->
  let L := dist_euc ex ey fx fy in
  exists k l, turn (mx + k) (my + l) (ex - k) (ey - l) (fx - k) (fy - l) = 0 /\
    forall x y, dist_euc (x + k) (y + l) x y = turn mx my ex ey fx fy / (2 * L) /\
                dist_euc (x - k) (y - l) x y = turn mx my ex ey fx fy / (2 * L).
Proof.
  intros T L. set (T0 := turn mx my ex ey fx fy) in *.
  assert (P : 0 < L).
  { unfold L. rewrite dist_norm. apply norm_pos. intro E. injection E as E1 E2.
    assert (ex = fx) by lra. assert (ey = fy) by lra. subst. unfold T0, turn in T. lra. }
  assert (Q : (fy - ey) * (fy - ey) + (ex - fx) * (ex - fx) = L * L).
  { unfold L. rewrite dist_norm, norm_sq. coordinates. ring. }
  set (h := T0 / (2 * (L * L))). exists (h * (fy - ey)), (h * (ex - fx)). split.
  - replace (turn _ _ _ _ _ _) with (T0 - 2 * h * ((fy - ey) * (fy - ey) + (ex - fx) * (ex - fx)))
      by (unfold T0, turn; ring).
    rewrite Q. unfold h. field. lra.
  - assert (N : norm (V (h * (fy - ey)) (h * (ex - fx)) 0) = T0 / (2 * L)).
    { replace (V (h * (fy - ey)) (h * (ex - fx)) 0) with (h ⊙ V (fy - ey) (ex - fx) 0) by (apply vec_eq; coordinates; ring).
      rewrite norm_scale, Rabs_pos_eq by (unfold h; apply Rlt_le, Rdiv_lt_0_compat; nra).
      unfold norm. replace (sq (V (fy - ey) (ex - fx) 0)) with (L * L) by (rewrite <- Q; coordinates; ring).
      rewrite sqrt_square by lra. unfold h. field. lra. }
    intros x y. rewrite <- N, !dist_norm. split; apply norm_of_sq; coordinates; ring.
Qed.

Theorem orientation_attained_2 : exists mx my nx ny ox oy, turn mx my nx ny ox oy = 0 /\
  let s := half_altitude ax ay bx by0 cx cy in
  dist_euc mx my ax ay = s /\ dist_euc nx ny bx by0 = s /\ dist_euc ox oy cx cy = s.
Proof.
  unfold half_altitude. unfold Rmax. repeat destruct Rle_dec;
  first [ destruct (flattened ax ay bx by0 cx cy positive) as (k & l & F & D);
          exists (ax + k), (ay + l), (bx - k), (by0 - l), (cx - k), (cy - l); split; [exact F | now repeat split; apply D]
        | destruct (flattened bx by0 cx cy ax ay) as (k & l & F & D); [unfold turn in *; lra|];
          exists (ax - k), (ay - l), (bx + k), (by0 + l), (cx - k), (cy - l); split; [unfold turn in *; lra|];
          rewrite (distance_symm ax ay cx cy); replace (turn ax ay bx by0 cx cy) with (turn bx by0 cx cy ax ay) by (unfold turn; ring);
          now repeat split; apply D
        | destruct (flattened cx cy ax ay bx by0) as (k & l & F & D); [unfold turn in *; lra|];
          exists (ax - k), (ay - l), (bx - k), (by0 - l), (cx + k), (cy + l); split; [unfold turn in *; lra|];
          replace (turn ax ay bx by0 cx cy) with (turn cx cy ax ay bx by0) by (unfold turn; ring);
          now repeat split; apply D ].
Qed.
End triangle_equal.

(* The empty circle of a b with p on its right and q on its left. *)
Section circle.
Variables ax ay bx by0 px py qx qy : R.
Let ux := bx - ax. Let uy := by0 - ay.
Let vx := px - ax. Let vy := py - ay.
Let wx := qx - ax. Let wy := qy - ay.
Definition annulus_D := (ux * wy - uy * wx) + (uy * vx - ux * vy).
Definition annulus_s := (wx - vx) * (wx + vx - ux) + (wy - vy) * (wy + vy - uy).
Definition annulus_N := V (annulus_D * ux - annulus_s * uy) (annulus_D * uy + annulus_s * ux) 0.
Definition annulus_M := annulus_N ⊖ (2 * annulus_D) ⊙ V vx vy 0.
Definition half_width_2 := incircle ax ay bx by0 px py qx qy / (norm annulus_M + norm annulus_N).

(* N is the sum over p and q of 2 lambda_i times the centre of the circle through the three others. *)
Definition twice_centre_2 ax ay bx by0 := V ((ax*ax + ay*ay) * by0 - (bx*bx + by0*by0) * ay) ((bx*bx + by0*by0) * ax - (ax*ax + ay*ay) * bx) 0.

Theorem sum_of_centres : annulus_N = twice_centre_2 ux uy wx wy ⊖ twice_centre_2 ux uy vx vy.
Proof. unfold annulus_N, annulus_D, annulus_s, twice_centre_2. vector. Qed.

Lemma sum_of_triangles : annulus_D = turn ax ay bx by0 qx qy + turn bx by0 ax ay px py.
Proof. unfold annulus_D, turn, ux, uy, vx, vy, wx, wy. ring. Qed.

Hypothesis triangle_q : 0 < turn ax ay bx by0 qx qy.
Hypothesis triangle_p : 0 < turn bx by0 ax ay px py.
Hypothesis empty : 0 < incircle ax ay bx by0 px py qx qy.

Let ox := ax + X1 annulus_N / (2 * annulus_D).
Let oy := ay + X2 annulus_N / (2 * annulus_D).

Lemma D_pos : 0 < annulus_D.
Proof. rewrite sum_of_triangles. lra. Qed.

Lemma dist_d2 x y u v : dist_euc x y u v = sqrt (d2 x y u v).
Proof. unfold dist_euc, d2, Rsqr. reflexivity. Qed.

Theorem annulus_of_code : dist_euc bx by0 ox oy = dist_euc ax ay ox oy /\ dist_euc qx qy ox oy = dist_euc px py ox oy /\
  dist_euc px py ox oy - dist_euc ax ay ox oy = 2 * half_width_2.
Proof.
  generalize D_pos. intro H.
  assert (T : forall x y, dist_euc x y ox oy = sqrt (d2 (x - ax) (y - ay) (X1 annulus_N / (2 * annulus_D)) (X2 annulus_N / (2 * annulus_D)))).
  { intros. rewrite dist_d2. f_equal. unfold d2, ox, oy. ring. }
  assert (I : incircle ax ay bx by0 px py qx qy =
    (vx * (vx - ux) + vy * (vy - uy)) * (ux * wy - uy * wx) + (wx * (wx - ux) + wy * (wy - uy)) * (uy * vx - ux * vy)).
  { unfold incircle, turn, ux, uy, vx, vy, wx, wy. ring. }
  rewrite !T. fold ux uy vx vy wx wy. replace (ax - ax) with 0 by ring. replace (ay - ay) with 0 by ring.
  assert (Z0 : annulus_D <> 0) by lra. unfold annulus_N, annulus_s in *. cbn [X1 X2]. unfold annulus_D in *. split; [|split].
  - f_equal. symmetry. exact (centre_equidistant_ab ux uy vx vy wx wy Z0).
  - f_equal. symmetry. exact (centre_equidistant_pq ux uy vx vy wx wy Z0).
  - rewrite I in empty. rewrite (width_formula ux uy vx vy wx wy H empty). unfold half_width_2. rewrite I.
    unfold annulus_M, annulus_N, norm, sq, dot, sub, scale, annulus_s, annulus_D. cbn [X1 X2 X3].
    unfold Rdiv. rewrite Rmult_assoc. do 2 f_equal. f_equal. f_equal; f_equal; ring.
Qed.

Variables gax gay gbx gby gpx gpy gqx gqy : R.   (* the placement *)
Hypothesis moved_q : 0 < turn gax gay gbx gby gqx gqy.
Hypothesis moved_p : 0 < turn gbx gby gax gay gpx gpy.

Theorem circle_certified_2 dA dB : dA + dB <= 2 * half_width_2 ->
  dist_euc gax gay ax ay < dA -> dist_euc gbx gby bx by0 < dA -> dist_euc gpx gpy px py < dB -> dist_euc gqx gqy qx qy < dB ->
  0 < incircle gax gay gbx gby gpx gpy gqx gqy.
Proof.
  intros W Da Db Dp Dq. destruct annulus_of_code as (Eb & Eq & Ew).
  apply (annulus_certifies gax gay gbx gby gpx gpy gqx gqy ax ay bx by0 px py qx qy ox oy
    (dist_euc ax ay ox oy) (dist_euc px py ox oy) dA dB); try assumption; lra.
Qed.

Theorem circle_tolerance_2 s : s <= half_width_2 ->
  dist_euc gax gay ax ay < s -> dist_euc gbx gby bx by0 < s -> dist_euc gpx gpy px py < s -> dist_euc gqx gqy qx qy < s ->
  0 < incircle gax gay gbx gby gpx gpy gqx gqy.
Proof. intros. apply circle_certified_2 with s s; try assumption. lra. Qed.
End circle.

Definition tolerance_2 ax ay bx by0 px py qx qy :=
  Rmin (half_width_2 ax ay bx by0 px py qx qy) (Rmin (half_altitude ax ay bx by0 qx qy) (half_altitude bx by0 ax ay px py)).

Theorem sign_tolerance_2 : forall ax ay bx by0 px py qx qy  gax gay gbx gby gpx gpy gqx gqy s,
  0 < turn ax ay bx by0 qx qy -> 0 < turn bx by0 ax ay px py -> 0 < incircle ax ay bx by0 px py qx qy ->
  s <= tolerance_2 ax ay bx by0 px py qx qy ->
  dist_euc gax gay ax ay < s -> dist_euc gbx gby bx by0 < s -> dist_euc gpx gpy px py < s -> dist_euc gqx gqy qx qy < s ->
  0 < incircle gax gay gbx gby gpx gpy gqx gqy.
Proof.
  intros ax ay bx by0 px py qx qy gax gay gbx gby gpx gpy gqx gqy s Tq Tp E H Da Db Dp Dq. unfold tolerance_2 in H.
  assert (s <= half_width_2 ax ay bx by0 px py qx qy /\ s <= half_altitude ax ay bx by0 qx qy /\ s <= half_altitude bx by0 ax ay px py)
    as (W & Aq & Ap) by (revert H; unfold Rmin; repeat destruct Rle_dec; lra).
  apply circle_tolerance_2 with ax ay bx by0 px py qx qy s; try assumption.
  - now apply orientation_tolerance_2 with ax ay bx by0 qx qy s.
  - now apply orientation_tolerance_2 with bx by0 ax ay px py s.
Qed.
