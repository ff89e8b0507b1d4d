(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The tolerance of P. M. M. de Castro, J. Tournois, P. Alliez, O. Devillers, Filtering relocations on a Delaunay triangulation
   (2009), is too large in space: docs/theory.md, section 3.

   Five points: A, B = (0, 0, +-h), and P, Q, R at 120 degrees on the circle of radius r in z = 0. Before, h = 99/100 and r = 1;
   after, h = 997/1000 and r = 993/1000. The certificates of a triangulation of them are signs of the five tetrahedra
   (cells and ridges of the hull) and of the empty spheres of its inner facets.

   missing_annulus   the half width that the paper leaves out, smaller than all that it has *)
Require Import Reals Lra Psatz.
From Annulus Require Import vectors tetrahedron bicell.
Open Scope R_scope.

Definition s3 := sqrt 3.
Lemma s3_sq : s3 * s3 = 3.
Proof. apply sqrt_sqrt. lra. Qed.
Lemma s3_bounds : 1732 / 1000 < s3 < 17321 / 10000.
Proof.
  unfold s3. split.
  - rewrite <- (sqrt_square (1732 / 1000)) by lra. apply sqrt_lt_1; lra.
  - rewrite <- (sqrt_square (17321 / 10000)) by lra. apply sqrt_lt_1; lra.
Qed.

Record five := Five { North : vec; South : vec; P1 : vec; P2 : vec; P3 : vec }.
(* m is half of r *)
Definition bipyramid h m :=
  Five (V 0 0 h) (V 0 0 (- h)) (V (2 * m) 0 0) (V (- m) (m * s3) 0) (V (- m) (- (m * s3)) 0).
Definition before := bipyramid (99 / 100) (1 / 2).
Definition after := bipyramid (997 / 1000) (993 / 2000).

Definition tetra (t1 t2 t3 t4 : vec) : corners := fun k => match k with o => t1 | u => t2 | v => t3 | w => t4 end.
Definition bicell (t1 t2 t3 t4 t5 : vec) : placement :=
  fun k => match k with a => t1 | b => t2 | c => t3 | p => t4 | q => t5 end.

(* The five tetrahedra, positive order. Three around A B, which are also those of the three ridges of P, Q, R; and those of the
   ridges at A and at B, which are also the two cells at P Q R. *)
Definition tetrahedra f k := match k with
  | a => tetra (South f) (North f) (P1 f) (P2 f) | b => tetra (South f) (North f) (P2 f) (P3 f) | c => tetra (South f) (North f) (P3 f) (P1 f)
  | p => tetra (North f) (P1 f) (P3 f) (P2 f) | q => tetra (South f) (P1 f) (P2 f) (P3 f)
  end.

(* The three facets at A B, and the facet P Q R. *)
Inductive turned := first | second | third.
Definition around f k := match k with
  | first => bicell (North f) (South f) (P1 f) (P2 f) (P3 f)
  | second => bicell (North f) (South f) (P2 f) (P3 f) (P1 f)
  | third => bicell (North f) (South f) (P3 f) (P1 f) (P2 f)
  end.
Definition middle f := bicell (P1 f) (P2 f) (P3 f) (South f) (North f).

Ltac open_figure :=
  unfold volume, largest, det, Lam, N, sum, vsum, among, vamong, pq, cpq, lambda, U, U_b, U_c, U_p, U_q, twice_centre,
    lambda_b, lambda_c, lambda_p, lambda_q, rel, around, middle, tetrahedra, bicell, tetra, bipyramid in *;
  cbn [North South P1 P2 P3] in *; coordinates.
Ltac figure := open_figure; ring [s3_sq].

Section figure.
Variables h m : R.
Let f := bipyramid h m.
Let r := 2 * m.

Lemma volume_around k : match k with a | b | c => volume (tetrahedra f k) = s3 * h * r * r
  | _ => 2 * volume (tetrahedra f k) = 3 * s3 * h * r * r end.
Proof. destruct k; unfold f, r; figure. Qed.

Lemma around_lambda k : lambda (around f k) p = s3 * h * r * r /\ lambda (around f k) q = s3 * h * r * r.
Proof. destruct k; unfold f, r; split; figure. Qed.

Lemma around_det k : det (around f k) = 3 * s3 * h * (r * r) * (r * r - h * h).
Proof. destruct k; unfold f, r; figure. Qed.

Lemma middle_det : det (middle f) = - (3 * s3 * h * (r * r) * (r * r - h * h)).
Proof. unfold f, r; figure. Qed.

(* The standard annulus of the paper, facet | opposite vertices, and that of A B | P Q R, whose centre is 0. *)
Lemma around_Lam k : Lam (around f k) pq = 2 * s3 * h * r * r /\ Lam (around f k) cpq = 3 * s3 * h * r * r.
Proof.
  unfold Lam, sum, among, pq, cpq. generalize (around_lambda k). intros (-> & ->).
  replace (lambda (around f k) c) with (s3 * h * r * r) by (destruct k; unfold f, r; figure). split; ring.
Qed.

Lemma around_N k : N (around f k) pq = (2 * s3 * h * (r * r - h * h)) ⊙ around f k c ⊕ (- (4 * s3 * h * r * r)) ⊙ North f /\
  N (around f k) cpq = (- (6 * s3 * h * r * r)) ⊙ North f.
Proof.
  rewrite (proj2 (abc_pq _)), (proj2 (ab_cpq _)). unfold U_c, U_p, U_q.
  assert (B : rel (around f k) b = V 0 0 (- 2 * h)) by (destruct k; unfold f; apply vec_eq; open_figure; ring).
  set (A1 := V (2 * m) 0 (- h)). set (A2 := V (- m) (m * s3) (- h)). set (A3 := V (- m) (- (m * s3)) (- h)).
  assert (E1 : P1 f ⊖ North f = A1) by (unfold f; apply vec_eq; open_figure; unfold A1; ring).
  assert (E2 : P2 f ⊖ North f = A2) by (unfold f; apply vec_eq; open_figure; unfold A2; ring).
  assert (E3 : P3 f ⊖ North f = A3) by (unfold f; apply vec_eq; open_figure; unfold A3; ring).
  assert (S1 : sq A1 = r * r + h * h) by (unfold A1, r; coordinates; ring).
  assert (S2 : sq A2 = r * r + h * h) by (unfold A2, r; coordinates; ring [s3_sq]).
  assert (S3 : sq A3 = r * r + h * h) by (unfold A3, r; coordinates; ring [s3_sq]).
  rewrite B. destruct k; unfold rel, around, bicell, twice_centre; rewrite E1, E2, E3, S1, S2, S3;
    unfold f, r, bipyramid, A1, A2, A3; cbn [North South P1 P2 P3]; split; apply vec_eq; coordinates; ring [s3_sq].
Qed.

Lemma points_sq k : sq (around f k c) = r * r /\ sq (North f) = h * h /\ around f k c · North f = 0.
Proof. destruct k; unfold f, r; repeat split; figure. Qed.

Lemma around_sq k : sq (N (around f k) pq) = 12 * (h * h) * (r * r) * ((r * r + h * h) * (r * r + h * h)) /\
  sq (N (around f k) cpq) = 108 * (h * h * h * h) * (r * r * r * r).
Proof.
  destruct (around_N k) as (-> & ->). destruct (points_sq k) as (Ec & En & E0).
  assert (K : forall u v s t, sq (s ⊙ u ⊕ t ⊙ v) = s * s * sq u + 2 * s * t * (u · v) + t * t * sq v) by vector.
  assert (K1 : forall u s, sq (s ⊙ u) = s * s * sq u) by vector.
  rewrite K, K1, Ec, En, E0. split; ring [s3_sq].
Qed.
End figure.

Lemma norm_le v K : 0 <= K -> sq v <= K * K -> norm v <= K.
Proof. intros H0 H. unfold norm. rewrite <- (sqrt_square K) by exact H0. now apply sqrt_le_1_alt. Qed.

Theorem paper_annuli k : 74 / 10000 < half_width (around before k) pq a p.
Proof.
  destruct (around_Lam (99 / 100) (1 / 2) k) as (L & _). destruct (around_sq (99 / 100) (1 / 2) k) as (E & _). fold before in L, E. generalize s3_bounds. intros (S1 & S2).
  assert (D : 10236 / 100000 < det (around before k)) by (unfold before; rewrite around_det; lra).
  assert (Na : norm (arm (around before k) pq a) <= 68 / 10).
  { apply norm_le; [lra|]. rewrite arm_sq, E. unfold one. simpl pq. lra. }
  assert (Np : norm (arm (around before k) pq p) <= 69 / 10).
  { apply norm_le; [lra|]. rewrite arm_sq, E, L. unfold one. simpl pq. unfold before. rewrite around_det.
    generalize s3_sq. intro. lra. }
  assert (G := arms_pos (around before k) pq a p eq_refl eq_refl). specialize (G ltac:(lra)).
  unfold half_width. apply Rmult_lt_reg_r with (1 := G).
  unfold Rdiv at 2. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra. unfold arms. lra.
Qed.

(* What the paper leaves out. *)
Theorem missing_annulus k : half_width (around before k) cpq a c = 5 / 1000.
Proof.
  destruct (around_Lam (99 / 100) (1 / 2) k) as (_ & L). destruct (around_sq (99 / 100) (1 / 2) k) as (_ & E). fold before in L, E. generalize s3_bounds. intros (S1 & S2).
  assert (D : det (around before k) = 3 * s3 * (99 / 100) * (2 * (1 / 2) * (2 * (1 / 2))) * (2 * (1 / 2) * (2 * (1 / 2)) - 99 / 100 * (99 / 100))) by (unfold before; apply around_det).
  assert (K : forall v t, 0 <= t -> sq v = t * t -> norm v = t).
  { intros v t H0 H. unfold norm. rewrite H. now apply sqrt_square. }
  unfold half_width, arms.
  rewrite (K (arm (around before k) cpq a) (6 * s3 * (99 / 100) * (99 / 100))),
          (K (arm (around before k) cpq c) (6 * s3 * (99 / 100))); try lra.
  - rewrite D. field. lra.
  - rewrite arm_sq, E, L. unfold one. simpl cpq. rewrite D. generalize s3_sq. intro. lra.
  - rewrite arm_sq, E. unfold one. simpl cpq. generalize s3_sq. intro. lra.
Qed.

(* All slabs of all five tetrahedra, so those of the paper's infinite bi-cells among them, are far wider. *)
Theorem paper_slabs k : 1 / 5 < half_width_simplex (tetrahedra before k).
Proof.
  generalize s3_bounds s3_sq. intros (S1 & S2) S.
  assert (V : 17 / 10 < volume (tetrahedra before k)).
  { generalize (volume_around (99 / 100) (1 / 2) k). fold before. destruct k; intros; lra. }
  assert (M : largest (tetrahedra before k) <= 4).
  { unfold before. destruct k; open_figure; repeat apply Rmax_lub; (apply norm_le; [lra|]); coordinates; nra. }
  assert (P := largest_pos (tetrahedra before k)). specialize (P ltac:(lra)).
  unfold half_width_simplex. apply Rmult_lt_reg_r with (2 * largest (tetrahedra before k)); [lra|].
  unfold Rdiv at 2. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra. lra.
Qed.

Lemma moved_by (f g : five -> vec) : f = g -> (g = North \/ g = South \/ g = P1 \/ g = P2 \/ g = P3) ->
  norm (f after ⊖ g before) = 7 / 1000.
Proof.
  intros -> H. generalize s3_sq. intro S.
  assert (K : forall v, sq v = 7 / 1000 * (7 / 1000) -> norm v = 7 / 1000).
  { intros v E. unfold norm. rewrite E. apply sqrt_square. lra. }
  apply K. unfold after, before, bipyramid. destruct H as [ -> | [ -> | [ -> | [ -> | -> ]]]]; cbn [North South P1 P2 P3]; coordinates; lra.
Qed.

(* The paper's Proposition 1 says that a triangulation stays Delaunay while no vertex moves as far as the least half width of the
   delimiters of its bi-cells. *)
Theorem proposition_1_fails :
  (* before, the three cells around A B are Delaunay: all certificates hold *)
  (forall k, 0 < volume (tetrahedra before k)) /\ (forall k, 0 < det (around before k)) /\
  (* the paper's tolerance of every vertex is more than 74/10000 *)
  (forall k, 74 / 10000 < half_width (around before k) pq a p) /\
  (forall k, 74 / 10000 < half_width_simplex (tetrahedra before k)) /\
  (* every vertex moves by 70/10000 *)
  (forall g, (g = North \/ g = South \/ g = P1 \/ g = P2 \/ g = P3) -> norm (g after ⊖ g before) = 70 / 10000) /\
  (* after, each of the three facets at A B has its opposite vertex strictly inside the sphere *)
  (forall k, det (around after k) < 0) /\
  (* and the two cells at P Q R are the Delaunay ones *)
  (forall k, 0 < volume (tetrahedra after k)) /\ 0 < det (middle after).
Proof.
  generalize s3_bounds. intros (S1 & S2).
  assert (V : forall h m k, 0 < h -> 0 < m -> 0 < volume (tetrahedra (bipyramid h m) k)).
  { intros h m k Hh Hm. generalize (volume_around h m k). assert (0 < s3 * h * (2 * m) * (2 * m)) by (repeat apply Rmult_lt_0_compat; lra).
    destruct k; intros; lra. }
  repeat split.
  - intro. apply V; lra.
  - intro. unfold before. rewrite around_det. lra.
  - exact paper_annuli.
  - intro k. generalize (paper_slabs k). lra.
  - intros g H. rewrite (moved_by g g eq_refl H). field.
  - intro. unfold after. rewrite around_det. lra.
  - intro. apply V; lra.
  - unfold after. rewrite middle_det. lra.
Qed.
