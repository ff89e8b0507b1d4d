(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Floating point and geometry together, for the empty circle in the plane: a tolerance returned by the filter stage certifies.

   Where the filter answers 1 with tolerance v for four points in binary64, and both triangles are positive there, the
   certificate holds at every placement with positive triangles in which each point is closer than v to where it was. Nothing about
   rounding is left to believe but that the code computes circle_filter, and that the machine rounds as IEEE 754 says. *)
Require Import Reals Lra Psatz ZArith Rgeom.
From Annulus Require Import float_model float_filter float_terms_2 float_circle_2 width_2.
Open Scope R_scope.

Lemma distance_to_centre x y ax ay cx cy : dist_euc x y (ax + cx) (ay + cy) = sqrt (d2 (x - ax) (y - ay) cx cy).
Proof. unfold dist_euc, d2, Rsqr. f_equal. ring. Qed.

Lemma turn_bap ax ay bx by' px py :
  turn bx by' ax ay px py = (by' - ay) * (px - ax) - (bx - ax) * (py - ay).
Proof. unfold turn. ring. Qed.

Theorem filter_certifies_circle :
  forall fax fay fbx fby fpx fpy fqx fqy tolerance  ax ay bx by' px py qx qy,
  F fax -> F fay -> F fbx -> F fby -> F fpx -> F fpy -> F fqx -> F fqy ->
  circle_filter fax fay fbx fby fpx fpy fqx fqy true = Some (1%Z, tolerance) ->
  (* both triangles are positive at the reference, and now *)
  0 < turn fax fay fbx fby fqx fqy -> 0 < turn fbx fby fax fay fpx fpy ->
  0 < turn ax ay bx by' qx qy -> 0 < turn bx by' ax ay px py ->
  dist_euc ax ay fax fay < tolerance -> dist_euc bx by' fbx fby < tolerance ->
  dist_euc px py fpx fpy < tolerance -> dist_euc qx qy fqx fqy < tolerance ->
  0 < width_2.incircle ax ay bx by' px py qx qy.
Proof.
  intros fax fay fbx fby fpx fpy fqx fqy v ax ay bx by' px py qx qy
    F1 F2 F3 F4 F5 F6 F7 F8 A Tq Tp Uq Up Ma Mb Mp Mq.
  generalize (circle_filter_sound fax fay fbx fby fpx fpy fqx fqy true F1 F2 F3 F4 F5 F6 F7 F8 1%Z v A).
  set (t := circle_truth fax fay fbx fby fpx fpy fqx fqy).
  intros [(_ & P & V) | (N & _)]; [| discriminate]. specialize (V eq_refl).
  unfold turn in Tq. rewrite turn_bap in Tp.
  set (D := ((fbx - fax) * (fqy - fay) - (fby - fay) * (fqx - fax)) + ((fby - fay) * (fpx - fax) - (fbx - fax) * (fpy - fay))).
  assert (D0 : 0 < D) by (unfold D; lra).
  generalize (width_formula (fbx - fax) (fby - fay) (fpx - fax) (fpy - fay) (fqx - fax) (fqy - fay) D0).
  generalize (centre_equidistant_ab (fbx - fax) (fby - fay) (fpx - fax) (fpy - fay) (fqx - fax) (fqy - fay) ltac:(fold D; lra)).
  generalize (centre_equidistant_pq (fbx - fax) (fby - fay) (fpx - fax) (fpy - fay) (fqx - fax) (fqy - fay) ltac:(fold D; lra)).
  cbv zeta. fold D.
  set (s := (fqx - fax - (fpx - fax)) * (fqx - fax + (fpx - fax) - (fbx - fax)) +
            (fqy - fay - (fpy - fay)) * (fqy - fay + (fpy - fay) - (fby - fay))).
  set (Nx := D * (fbx - fax) - s * (fby - fay)). set (Ny := D * (fby - fay) + s * (fbx - fax)).
  set (cx := Nx / (2 * D)). set (cy := Ny / (2 * D)). intros Epq Eab W.
  (* the terms of the filter are those of width_formula *)
  assert (Ei : float_terms_2.incircle t = ((fpx - fax) * (fpx - fax - (fbx - fax)) + (fpy - fay) * (fpy - fay - (fby - fay))) *
      ((fbx - fax) * (fqy - fay) - (fby - fay) * (fqx - fax)) +
      ((fqx - fax) * (fqx - fax - (fbx - fax)) + (fqy - fay) * (fqy - fay - (fby - fay))) *
      ((fby - fay) * (fpx - fax) - (fbx - fax) * (fpy - fay))) by reflexivity.
  assert (En : inner t = Nx * Nx + Ny * Ny).
  { unfold t, circle_truth, R_annulus, annulus_terms, squared, Nx, Ny, s, D. cbn [inner]. ring. }
  assert (Em : outer t = (Nx - 2 * D * (fpx - fax)) * (Nx - 2 * D * (fpx - fax)) +
                         (Ny - 2 * D * (fpy - fay)) * (Ny - 2 * D * (fpy - fay))).
  { unfold t, circle_truth, R_annulus, annulus_terms, squared, Nx, Ny, s, D. cbn [outer]. ring. }
  rewrite <- Ei, <- Em, <- En in W. specialize (W P).
  apply (annulus_certifies ax ay bx by' px py qx qy fax fay fbx fby fpx fpy fqx fqy (fax + cx) (fay + cy)
    (sqrt (d2 0 0 cx cy)) (sqrt (d2 (fpx - fax) (fpy - fay) cx cy)) v v); try assumption.
  - rewrite distance_to_centre. right. f_equal. unfold d2. ring.
  - rewrite distance_to_centre. right. now rewrite <- Eab.
  - rewrite distance_to_centre. apply Rle_refl.
  - rewrite distance_to_centre. right. now rewrite Epq.
  - rewrite W. destruct V as [_ V]. unfold Rdiv in *. rewrite (Rplus_comm (sqrt (outer t))). lra.
Qed.
