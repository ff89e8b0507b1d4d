(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The geometry of a certificate in the plane: docs/theory.md, sections 2 and 4. Standard library only.

   - flat_triangle_has_a_middle  three points on a line: some line-and-side condition on one of them must fail
   - pointwise_2          the pointwise lemma: positive triangles and one circle around a, b that leaves p, q outside
                          make the bi-cell strictly locally Delaunay
   - annulus_certifies    the same from an annulus at a reference position and two ways shorter than its width together
   - pencil               a disc with a, b inside and p, q outside can be exchanged for one through a and b
   - width_formula        the half width without a division by D *)
Require Import Reals Lra Psatz Rgeom.
Open Scope R_scope.

Definition d2 (x y u v : R) := (x-u)*(x-u) + (y-v)*(y-v).
(* Twice the signed area of x y z. *)
Definition turn (xx xy yx yy zx zy : R) := (yx-xx)*(zy-xy) - (yy-xy)*(zx-xx).

(* The determinant of the code, width_terms.h, for a at (ax, ay). *)
Definition incircle (ax ay bx by0 px py qx qy : R) :=
  ((px-ax)*(px-bx) + (py-ay)*(py-by0)) * turn ax ay bx by0 qx qy
  + ((qx-ax)*(qx-bx) + (qy-ay)*(qy-by0)) * turn bx by0 ax ay px py.

Section pointwise.
Variables ax ay bx by0 px py qx qy : R.
Let lp := turn ax ay bx by0 qx qy.   (* coefficient of p in the affine dependence *)
Let lq := turn bx by0 ax ay px py.
Let la := turn bx by0 px py qx qy.
Let lb := - turn ax ay px py qx qy.

(* Whatever the circle, the powers with these coefficients add up to the determinant. *)
Lemma powers : forall ox oy rho2,
  la*(d2 ax ay ox oy - rho2) + lb*(d2 bx by0 ox oy - rho2) + lp*(d2 px py ox oy - rho2) + lq*(d2 qx qy ox oy - rho2)
  = incircle ax ay bx by0 px py qx qy.
Proof. intros. unfold la, lb, lp, lq, incircle, turn, d2. ring. Qed.

Lemma d2_nonneg : forall x y u v, 0 <= d2 x y u v.
Proof. intros. unfold d2. generalize (Rle_0_sqr (x-u)) (Rle_0_sqr (y-v)). unfold Rsqr. lra. Qed.

Theorem pointwise_2 : forall ox oy rho2,
  0 < turn ax ay bx by0 qx qy -> 0 < turn bx by0 ax ay px py ->
  d2 ax ay ox oy < rho2 -> d2 bx by0 ox oy < rho2 -> rho2 < d2 px py ox oy -> rho2 < d2 qx qy ox oy ->
  0 < incircle ax ay bx by0 px py qx qy.
Proof.
  intros ox oy rho2 Hp Hq Ha Hb HP HQ. fold lp in Hp. fold lq in Hq.
  assert (positive_p : forall z, 0 < z -> 0 < lp * z) by (intros; now apply Rmult_lt_0_compat).
  assert (positive_q : forall z, 0 < z -> 0 < lq * z) by (intros; now apply Rmult_lt_0_compat).
  destruct (Rlt_dec 0 la) as [Ka|Ka].
  - (* a is not between: b is the single point, and the circle of radius 0 around b serves *)
    rewrite <- (powers bx by0 0).
    replace (d2 bx by0 bx by0) with 0 by (unfold d2; ring).
    assert (P0 : 0 < d2 px py bx by0).
    { destruct (Rle_lt_or_eq_dec _ _ (d2_nonneg px py bx by0)) as [H|H]; [exact H|exfalso].
      assert (px = bx /\ py = by0) as [-> ->].
      { unfold d2 in H. generalize (Rle_0_sqr (px-bx)) (Rle_0_sqr (py-by0)). unfold Rsqr. intros. split; nra. }
      unfold lq, turn in Hq. lra. }
    generalize (positive_p _ P0). generalize (d2_nonneg ax ay bx by0) (d2_nonneg qx qy bx by0). intros.
    assert (0 <= la * d2 ax ay bx by0) by (apply Rmult_le_pos; lra).
    assert (0 <= lq * d2 qx qy bx by0) by (apply Rmult_le_pos; lra).
    lra.
  - destruct (Rlt_dec 0 lb) as [Kb|Kb].
    + rewrite <- (powers ax ay 0).
      replace (d2 ax ay ax ay) with 0 by (unfold d2; ring).
      assert (P0 : 0 < d2 px py ax ay).
      { destruct (Rle_lt_or_eq_dec _ _ (d2_nonneg px py ax ay)) as [H|H]; [exact H|exfalso].
        assert (px = ax /\ py = ay) as [-> ->].
        { unfold d2 in H. generalize (Rle_0_sqr (px-ax)) (Rle_0_sqr (py-ay)). unfold Rsqr. intros. split; nra. }
        unfold lq, turn in Hq. lra. }
      generalize (positive_p _ P0). generalize (d2_nonneg bx by0 ax ay) (d2_nonneg qx qy ax ay). intros.
      assert (0 <= lb * d2 bx by0 ax ay) by (apply Rmult_le_pos; lra).
      assert (0 <= lq * d2 qx qy ax ay) by (apply Rmult_le_pos; lra).
      lra.
    + (* the segment pq meets ab *)
      rewrite <- (powers ox oy rho2).
      generalize (positive_p _ (Rlt_Rminus _ _ HP)) (positive_q _ (Rlt_Rminus _ _ HQ)). intros.
      assert (0 <= (- la) * (rho2 - d2 ax ay ox oy)) by (apply Rmult_le_pos; lra).
      assert (0 <= (- lb) * (rho2 - d2 bx by0 ox oy)) by (apply Rmult_le_pos; lra).
      lra.
Qed.
End pointwise.

(* From an annulus about (ox, oy) at reference positions F to positions at a distance. *)
Lemma far_in : forall x y fx fy ox oy r dA, dist_euc fx fy ox oy <= r -> dist_euc x y fx fy < dA ->
  dist_euc x y ox oy < r + dA.
Proof. intros. generalize (triangle x y ox oy fx fy). lra. Qed.
Lemma far_out : forall x y fx fy ox oy r dB, r <= dist_euc fx fy ox oy -> dist_euc x y fx fy < dB ->
  r - dB < dist_euc x y ox oy.
Proof. intros. generalize (triangle fx fy ox oy x y). rewrite (distance_symm fx fy x y). lra. Qed.
Lemma d2_of_dist : forall x y u v, d2 x y u v = dist_euc x y u v * dist_euc x y u v.
Proof. intros. unfold dist_euc. rewrite sqrt_sqrt. - unfold d2, Rsqr. ring.
  - generalize (Rle_0_sqr (x-u)) (Rle_0_sqr (y-v)). lra. Qed.

Theorem annulus_certifies :
  forall ax ay bx by0 px py qx qy  fax fay fbx fby fpx fpy fqx fqy  ox oy r1 r2 dA dB,
  0 < turn ax ay bx by0 qx qy -> 0 < turn bx by0 ax ay px py ->
  dist_euc fax fay ox oy <= r1 -> dist_euc fbx fby ox oy <= r1 ->
  r2 <= dist_euc fpx fpy ox oy -> r2 <= dist_euc fqx fqy ox oy ->
  dist_euc ax ay fax fay < dA -> dist_euc bx by0 fbx fby < dA ->
  dist_euc px py fpx fpy < dB -> dist_euc qx qy fqx fqy < dB ->
  dA + dB <= r2 - r1 ->
  0 < incircle ax ay bx by0 px py qx qy.
Proof.
  intros ax ay bx by0 px py qx qy fax fay fbx fby fpx fpy fqx fqy ox oy r1 r2 dA dB T1 T2 A B P Q MA MB MP MQ W.
  generalize (far_in _ _ _ _ _ _ _ _ A MA) (far_in _ _ _ _ _ _ _ _ B MB)
             (far_out _ _ _ _ _ _ _ _ P MP) (far_out _ _ _ _ _ _ _ _ Q MQ). intros HA HB HP HQ.
  assert (Npos : forall x y u v, 0 <= dist_euc x y u v) by (intros; unfold dist_euc; apply sqrt_pos).
  generalize (Npos ax ay ox oy) (Npos bx by0 ox oy) (Npos px py ox oy) (Npos qx qy ox oy). intros.
  apply pointwise_2 with ox oy ((r1+dA)*(r1+dA)); try assumption; rewrite d2_of_dist;
    apply Rmult_le_0_lt_compat; lra.
Qed.

(* Orientation: a linear functional that keeps one vertex above and two below a level, for each of the three vertices,
   excludes that the triangle is flat. *)
Section slab.
Variables ax ay bx by0 cx cy : R.
Theorem flat_triangle_has_a_middle :
  turn ax ay bx by0 cx cy = 0 ->
  (forall nx ny t, ~ (nx*ax+ny*ay < t /\ t < nx*bx+ny*by0 /\ t < nx*cx+ny*cy)) \/
  (forall nx ny t, ~ (nx*bx+ny*by0 < t /\ t < nx*ax+ny*ay /\ t < nx*cx+ny*cy)) \/
  (forall nx ny t, ~ (nx*cx+ny*cy < t /\ t < nx*ax+ny*ay /\ t < nx*bx+ny*by0)).
Proof.
  intro flat.
  (* order along the line by the dot product with b - a, or c - a when b = a *)
  set (dx := bx-ax). set (dy := by0-ay). set (ex := cx-ax). set (ey := cy-ay).
  assert (F : dx*ey = dy*ex) by (unfold dx, dy, ex, ey, turn in *; lra).
  set (dd := dx*dx+dy*dy). set (de := dx*ex+dy*ey).
  assert (Hdd : 0 <= dd) by (unfold dd; nra).
  assert (Fx : dd*ex - de*dx = dy*(dy*ex - dx*ey)) by (unfold dd, de; ring).
  assert (Fy : dd*ey - de*dy = dx*(dx*ey - dy*ex)) by (unfold dd, de; ring).
  rewrite F in Fx, Fy. replace (dy*(dy*ex - dy*ex)) with 0 in Fx by ring.
  replace (dx*(dy*ex - dy*ex)) with 0 in Fy by ring.
  assert (K : forall nx ny, dd*(nx*ex+ny*ey) = de*(nx*dx+ny*dy)).
  { intros nx ny. replace (dd*(nx*ex+ny*ey)) with (nx*(dd*ex)+ny*(dd*ey)) by ring.
    replace (dd*ex) with (de*dx) by lra. replace (dd*ey) with (de*dy) by lra. ring. }
  destruct (Rle_lt_or_eq_dec _ _ Hdd) as [Pos|Zero].
  - destruct (Rlt_dec de 0) as [L|L]; [left|destruct (Rlt_dec dd de) as [G|G]; [right; left|right; right]];
    intros nx ny t (H1 & H2 & H3); specialize (K nx ny).
    + (* a between b and c *)
      assert (P : 0 < nx*dx+ny*dy) by (unfold dx, dy; lra). assert (Q : 0 < nx*ex+ny*ey) by (unfold ex, ey; lra).
      generalize (Rmult_lt_0_compat _ _ Pos Q) (Rmult_lt_0_compat (- de) _ ltac:(lra) P). lra.
    + (* b between a and c *)
      assert (P : 0 < - (nx*dx+ny*dy)) by (unfold dx, dy; lra).
      assert (Q : 0 < (nx*ex+ny*ey) - (nx*dx+ny*dy)) by (unfold ex, ey, dx, dy; lra).
      generalize (Rmult_lt_0_compat _ _ Pos Q) (Rmult_lt_0_compat (de - dd) _ ltac:(lra) P). lra.
    + (* c between a and b *)
      assert (P : 0 < - (nx*ex+ny*ey)) by (unfold ex, ey; lra).
      assert (Q : 0 < (nx*dx+ny*dy) - (nx*ex+ny*ey)) by (unfold ex, ey, dx, dy; lra).
      generalize (Rmult_lt_0_compat _ _ Pos Q) (Rmult_lt_0_compat _ _ Pos P). intros.
      destruct (Rle_dec 0 (nx*dx+ny*dy)) as [S|S].
      * generalize (Rmult_le_pos de _ ltac:(lra) S). lra.
      * generalize (Rmult_le_pos (dd - de) (- (nx*dx+ny*dy)) ltac:(lra) ltac:(lra)). lra.
  - left. intros nx ny t (H1 & H2 & H3).
    assert (dx = 0 /\ dy = 0) as [Zx Zy] by (unfold dd in Zero; split; nra).
    unfold dx, dy in *. replace bx with ax in H2 by lra. replace by0 with ay in H2 by lra. lra.
Qed.
End slab.

(* If some disk has a,b strictly inside and p,q strictly outside, then some circle
   THROUGH a and b leaves p and q strictly outside (the pencil lemma, 2D). *)
Section pencil.
Variables ax ay bx by0 ox oy px py qx qy rho2 : R.

Lemma shrink_to_a :
  forall dx dy ex ey k, (* d = o-a , e = x-a *)
  0 < k <= 1 -> ex*ex + ey*ey > 2*(ex*dx+ey*dy) -> ex*ex+ey*ey > 2*k*(ex*dx+ey*dy).
Proof. intros dx dy ex ey k [Hk Hk1] H.
  destruct (Rle_dec (ex*dx+ey*dy) 0) as [n|n].
  - assert (0 <= ex*ex) by nra. assert (0 <= ey*ey) by nra.
    assert (2*k*(ex*dx+ey*dy) <= 0) by nra.
    destruct (Req_dec (ex*dx+ey*dy) 0); nra.
  - nra.
Qed.

Lemma pencil_aux : (* a is at least as far from o as b *)
  d2 ax ay ox oy < rho2 -> d2 bx by0 ox oy <= d2 ax ay ox oy ->
  (ax <> bx \/ ay <> by0) ->
  rho2 < d2 px py ox oy -> rho2 < d2 qx qy ox oy ->
  exists cx cy r2, d2 ax ay cx cy = r2 /\ d2 bx by0 cx cy = r2 /\
                   d2 px py cx cy > r2 /\ d2 qx qy cx cy > r2.
Proof.
  unfold d2; intros Ha Hb Hne Hp Hq.
  set (dx := ox-ax); set (dy := oy-ay).
  set (fx := bx-ax); set (fy := by0-ay).
  assert (Hf : 0 < fx*fx + fy*fy).
  { unfold fx, fy. generalize (Rle_0_sqr (bx-ax)) (Rle_0_sqr (by0-ay)). unfold Rsqr. intros.
    destruct Hne as [H'|H'].
    - assert (H1 := Rsqr_pos_lt _ (Rminus_eq_contra _ _ (not_eq_sym H'))). unfold Rsqr in H1. lra.
    - assert (H1 := Rsqr_pos_lt _ (Rminus_eq_contra _ _ (not_eq_sym H'))). unfold Rsqr in H1. lra. }
  assert (Hfd : fx*fx+fy*fy <= 2*(fx*dx+fy*dy)).
  { unfold fx, fy, dx, dy. nra. }
  set (k := (fx*fx+fy*fy) / (2*(fx*dx+fy*dy))).
  assert (Hk : 0 < k <= 1).
  { unfold k. split.
    - apply Rdiv_lt_0_compat; lra.
    - apply Rmult_le_reg_r with (2*(fx*dx+fy*dy)); [lra|].
      unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra. }
  assert (Hkb : 2*k*(fx*dx+fy*dy) = fx*fx+fy*fy).
  { unfold k. field. lra. }
  exists (ax + k*dx), (ay + k*dy), (k*k*(dx*dx+dy*dy)).
  assert (Hout : forall x y, rho2 < (x-ox)*(x-ox)+(y-oy)*(y-oy) ->
     (x-(ax+k*dx))*(x-(ax+k*dx)) + (y-(ay+k*dy))*(y-(ay+k*dy)) > k*k*(dx*dx+dy*dy)).
  { intros x y H.
    assert (Hs : (x-ax)*(x-ax)+(y-ay)*(y-ay) > 2*((x-ax)*dx+(y-ay)*dy)) by (unfold dx, dy; nra).
    generalize (shrink_to_a dx dy (x-ax) (y-ay) k Hk Hs). intros; nra. }
  repeat split.
  - ring.
  - unfold fx, fy in Hkb. nra.
  - now apply Hout.
  - now apply Hout.
Qed.
End pencil.

Theorem pencil : forall ax ay bx by0 ox oy px py qx qy rho2,
  d2 ax ay ox oy < rho2 -> d2 bx by0 ox oy < rho2 ->
  (ax <> bx \/ ay <> by0) ->
  rho2 < d2 px py ox oy -> rho2 < d2 qx qy ox oy ->
  exists cx cy r2, d2 ax ay cx cy = r2 /\ d2 bx by0 cx cy = r2 /\
                   d2 px py cx cy > r2 /\ d2 qx qy cx cy > r2.
Proof.
  intros ax ay bx by0 ox oy px py qx qy rho2 Ha Hb Hne Hp Hq.
  destruct (Rle_dec (d2 bx by0 ox oy) (d2 ax ay ox oy)) as [Hle|Hle].
  - exact (pencil_aux ax ay bx by0 ox oy px py qx qy rho2 Ha Hle Hne Hp Hq).
  - destruct (pencil_aux bx by0 ax ay ox oy px py qx qy rho2) as (cx & cy & r2 & H4 & H5 & H6 & H7);
      [exact Hb | lra | destruct Hne; [left|right]; congruence | exact Hp | exact Hq |].
    exists cx, cy, r2. repeat split; assumption.
Qed.

(* The width formula without the centre:  R - r = 2 inc / (|M| + |N|),
   M = N - 2 D p, N = D b + s b_perp (local origin a). D>0 since p,q lie on opposite sides. *)
Section width.
Variables bx by0 px py qx qy : R.
Let ob := bx*qy - by0*qx.
Let oa := by0*px - bx*py.
Let D  := ob + oa.
Let s  := (qx-px)*(qx+px-bx) + (qy-py)*(qy+py-by0).
Let Nx := D*bx - s*by0.  Let Ny := D*by0 + s*bx.
Let Mx := Nx - 2*D*px.   Let My := Ny - 2*D*py.
Let inc := (px*(px-bx)+py*(py-by0))*ob + (qx*(qx-bx)+qy*(qy-by0))*oa.

Lemma power_identity : (Mx*Mx+My*My) - (Nx*Nx+Ny*Ny) = 4*D*inc.
Proof. unfold Mx, My, Nx, Ny, inc, D, s, ob, oa. ring. Qed.

Lemma centre_equidistant_ab : D <> 0 -> d2 0 0 (Nx/(2*D)) (Ny/(2*D)) = d2 bx by0 (Nx/(2*D)) (Ny/(2*D)).
Proof. intro. unfold d2, Nx, Ny. field. assumption. Qed.

Lemma centre_equidistant_pq : D <> 0 -> d2 px py (Nx/(2*D)) (Ny/(2*D)) = d2 qx qy (Nx/(2*D)) (Ny/(2*D)).
Proof. intro H. unfold d2, Nx, Ny, s, D, ob, oa in *. field. exact H. Qed.

Lemma sqrt_scale : forall X, 0 <= X -> 0 < D -> sqrt (X / (4*D*D)) = sqrt X / (2*D).
Proof. intros X HX HD.
  replace (4*D*D) with ((2*D)*(2*D)) by ring.
  rewrite sqrt_div_alt by nra. rewrite sqrt_square by lra. reflexivity. Qed.

Theorem width_formula : 0 < D -> 0 < inc ->
  sqrt (d2 px py (Nx/(2*D)) (Ny/(2*D))) - sqrt (d2 0 0 (Nx/(2*D)) (Ny/(2*D)))
  = 2*inc / (sqrt (Mx*Mx+My*My) + sqrt (Nx*Nx+Ny*Ny)).
Proof.
  intros HD Hi.
  replace (d2 px py (Nx/(2*D)) (Ny/(2*D))) with ((Mx*Mx+My*My)/(4*D*D)) by (unfold d2, Mx, My; field; lra).
  replace (d2 0 0 (Nx/(2*D)) (Ny/(2*D))) with ((Nx*Nx+Ny*Ny)/(4*D*D)) by (unfold d2; field; lra).
  assert (0 <= Mx*Mx+My*My) by nra. assert (0 <= Nx*Nx+Ny*Ny) by nra.
  rewrite !sqrt_scale by assumption.
  assert (HA : 0 < Mx*Mx+My*My). { generalize power_identity. assert (0 < D*inc) by nra. nra. }
  assert (HsA : 0 < sqrt (Mx*Mx+My*My)) by now apply sqrt_lt_R0.
  assert (HsB : 0 <= sqrt (Nx*Nx+Ny*Ny)) by apply sqrt_pos.
  generalize (sqrt_sqrt _ H) (sqrt_sqrt _ H0) power_identity. intros E1 E2 E3.
  set (u := sqrt (Mx*Mx+My*My)) in *. set (v := sqrt (Nx*Nx+Ny*Ny)) in *.
  rewrite <- E1, <- E2 in E3.
  apply Rmult_eq_reg_r with (2*D*(u+v)); [|nra].
  field_simplify; [|lra|lra]. nra.
Qed.
End width.
