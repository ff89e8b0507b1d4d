(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Cells in a periodic box of space, and how often they cover it: docs/theory.md 8.3. As torus_2.v.

   - degree_3        glued cells: the sum of six times their signed volumes is an integer times det L, wherever the vertices are and whatever the box is
   - covers_wrapped_3, covers_in_basis_3, covers_replaced_3    the integer is kept by wrapping a vertex, another basis of the lattice, and replacing cells by others
                     with the same border: 2-3, 3-2 and 4-4 flips, regions *)
Require Import Reals ZArith Lra Lia List Permutation.
From Annulus Require Import sums torus_2.
From Annulus Require Export vectors.
Import ListNotations.
Open Scope R_scope.

Definition offset_3 : Type := Z * Z * Z.
Definition site_3 : Type := nat * offset_3.
Definition facet_3 : Type := site_3 * site_3 * site_3.
Definition torus_cell_3 : Type := site_3 * site_3 * site_3 * site_3.

Definition moved_3 (t : offset_3) (s : site_3) : site_3 :=
  let '(l, m, n) := t in let '(v, (i, j, k)) := s in (v, (l + i, m + j, n + k)%Z).
Definition facets_3 (c : torus_cell_3) : list facet_3 := let '(a, b, c, d) := c in [(b, d, c); (a, c, d); (a, d, b); (a, b, c)].
Inductive turned_facet : facet_3 -> facet_3 -> Prop :=
  | as_it_is a b c : turned_facet (a, b, c) (a, b, c)
  | one_on a b c : turned_facet (a, b, c) (b, c, a)
  | two_on a b c : turned_facet (a, b, c) (c, a, b).
Definition both_sides_3 (k : facet_3 * offset_3) : list facet_3 := let '((a, b, c), t) := k in [(a, b, c); (moved_3 t b, moved_3 t a, moved_3 t c)].
Definition glued_torus_3 (T : list torus_cell_3) : Prop :=
  exists l pairs, Forall2 turned_facet (flat_map facets_3 T) l /\ Permutation l (flat_map both_sides_3 pairs).

Record box_3 := Box_3 { L1 : vec; L2 : vec; L3 : vec }.
Definition det_3 (L : box_3) : R := vol (L1 L) (L2 L) (L3 L).
Definition lattice_3 (L : box_3) (o : offset_3) : vec := let '(i, j, k) := o in IZR i ⊙ L1 L ⊕ IZR j ⊙ L2 L ⊕ IZR k ⊙ L3 L.
Definition site_at_3 (x : nat -> vec) (L : box_3) (s : site_3) : vec := x (fst s) ⊕ lattice_3 L (snd s).
Definition six_volumes (a b c d : vec) : R := vol (b ⊖ a) (c ⊖ a) (d ⊖ a).
Definition torus_volume (x : nat -> vec) (L : box_3) (c : torus_cell_3) : R :=
  let '(a, b, c, d) := c in six_volumes (site_at_3 x L a) (site_at_3 x L b) (site_at_3 x L c) (site_at_3 x L d).

(* The same determinant of offsets alone. *)
Definition offset_det (a b c : offset_3) : Z :=
  let '(i, j, k) := a in let '(l, m, n) := b in let '(p, q, r) := c in (i * (m * r - n * q) + j * (n * p - l * r) + k * (l * q - m * p))%Z.
Definition offset_less (a b : offset_3) : offset_3 := let '(i, j, k) := a in let '(l, m, n) := b in (i - l, j - m, k - n)%Z.
Definition offset_volume (c : torus_cell_3) : Z :=
  let '((_, a), (_, b), (_, c), (_, d)) := c in offset_det (offset_less b a) (offset_less c a) (offset_less d a).
Fixpoint covers_3 (T : list torus_cell_3) : Z := match T with [] => 0%Z | c :: T' => (offset_volume c + covers_3 T')%Z end.

(* ---- Moves ---- *)

(* Six times the signed volume that a facet sweeps in a straight motion of its corners, p q r to p' q' r': the integral of its area vector times the sum of the ways. *)
Definition swept_3 (p q r p' q' r' : vec) : R :=
  let d := q ⊖ p in let f := r ⊖ p in let d' := (q' ⊖ p') ⊖ d in let f' := (r' ⊖ p') ⊖ f in
  (d ✕ f ⊕ (1 / 2) ⊙ (d ✕ f' ⊕ d' ✕ f) ⊕ (1 / 3) ⊙ (d' ✕ f')) · ((p' ⊖ p) ⊕ (q' ⊖ q) ⊕ (r' ⊖ r)).

Lemma swept_facets a b c d a' b' c' d' : six_volumes a b c d - six_volumes a' b' c' d' =
  swept_3 b d c b' d' c' + swept_3 a c d a' c' d' + swept_3 a d b a' d' b' + swept_3 a b c a' b' c'.
Proof.
  destruct a as [a1 a2 a3], b as [b1 b2 b3], c as [c1 c2 c3], d as [d1 d2 d3], a' as [e1 e2 e3], b' as [f1 f2 f3], c' as [g1 g2 g3], d' as [h1 h2 h3].
  unfold six_volumes, swept_3. coordinates. field.
Qed.

Lemma swept_turned p q r p' q' r' : swept_3 q r p q' r' p' = swept_3 p q r p' q' r'.
Proof. unfold swept_3. coordinates. field. Qed.

Lemma swept_back w p q r p' q' r' : swept_3 (w ⊕ q) (w ⊕ p) (w ⊕ r) (w ⊕ q') (w ⊕ p') (w ⊕ r') = - swept_3 p q r p' q' r'.
Proof. unfold swept_3. coordinates. field. Qed.

Lemma site_moved x L t s : site_at_3 x L (moved_3 t s) = lattice_3 L t ⊕ site_at_3 x L s.
Proof.
  destruct t as ((l, m), n), s as (v, ((i, j), k)). unfold site_at_3. simpl. rewrite !plus_IZR. generalize (x v) (L1 L) (L2 L) (L3 L). vector.
Qed.

Section moves.
Variables (x y : nat -> vec) (L : box_3).
Definition swept_by_3 (s : facet_3) : R := let '(a, b, c) := s in
  swept_3 (site_at_3 x L a) (site_at_3 x L b) (site_at_3 x L c) (site_at_3 y L a) (site_at_3 y L b) (site_at_3 y L c).

Lemma swept_both_3 k : sum swept_by_3 (both_sides_3 k) = 0.
Proof. destruct k as (((a, b), c), t). cbn [both_sides_3 sum swept_by_3]. rewrite !site_moved, swept_back. ring. Qed.

Lemma swept_by_turned s s' : turned_facet s s' -> swept_by_3 s' = swept_by_3 s.
Proof. intros []; cbn [swept_by_3]; [reflexivity|apply swept_turned|symmetry; apply swept_turned]. Qed.

Lemma sum_turned l l' : Forall2 turned_facet l l' -> sum swept_by_3 l' = sum swept_by_3 l.
Proof. induction 1 as [|s s' l l' E _ IH]; simpl; [reflexivity|]. now rewrite IH, (swept_by_turned s s' E). Qed.

Lemma swept_cell_3 c : torus_volume x L c - torus_volume y L c = sum swept_by_3 (facets_3 c).
Proof. destruct c as (((a, b), c), d). unfold torus_volume. rewrite swept_facets. cbn [facets_3 sum swept_by_3]. ring. Qed.

Lemma volume_kept T : glued_torus_3 T -> sum (torus_volume x L) T = sum (torus_volume y L) T.
Proof.
  intros (l & pairs & F & P). apply Rminus_diag_uniq.
  assert (E : sum (torus_volume x L) T - sum (torus_volume y L) T = sum swept_by_3 (flat_map facets_3 T)).
  { rewrite sum_flat_map. transitivity (sum (fun c => torus_volume x L c + (-1) * torus_volume y L c) T).
    - rewrite sum_plus, sum_scale. ring.
    - apply sum_ext. intros c _. rewrite <- swept_cell_3. ring. }
  rewrite E, <- (sum_turned _ _ F), (sum_permutation _ _ _ P), sum_flat_map, (sum_ext _ (fun _ => 0)), sum_zero; [reflexivity|].
  intros k _. apply swept_both_3.
Qed.
End moves.

Lemma volume_at_origin L c : torus_volume (fun _ => zero) L c = IZR (offset_volume c) * det_3 L.
Proof.
  destruct c as ((((v, ((a1, a2), a3)), (w, ((b1, b2), b3))), (u, ((c1, c2), c3))), (n, ((d1, d2), d3))).
  unfold torus_volume, offset_volume, det_3, site_at_3, six_volumes, offset_det, offset_less, lattice_3. cbn [fst snd].
  rewrite !plus_IZR, !mult_IZR, !minus_IZR, !mult_IZR, !minus_IZR. destruct L as [[x1 x2 x3] [y1 y2 y3] [z1 z2 z3]]. cbn [L1 L2 L3].
  coordinates. ring.
Qed.

Lemma volumes_at_origin L T : sum (torus_volume (fun _ => zero) L) T = IZR (covers_3 T) * det_3 L.
Proof. induction T as [|c T IH]; simpl; [ring|]. rewrite IH, volume_at_origin, plus_IZR. ring. Qed.

Theorem degree_3 T : glued_torus_3 T -> forall x L, sum (torus_volume x L) T = IZR (covers_3 T) * det_3 L.
Proof. intros G x L. rewrite (volume_kept x (fun _ => zero) L T G). apply volumes_at_origin. Qed.

(* ---- Wrapping ---- *)

(* Every corner of v gets the offset less k, and the place of v is k vectors of the box farther on: no site moves. *)
Definition wrapped_site_3 (v : nat) (k : offset_3) (s : site_3) : site_3 := if Nat.eq_dec (fst s) v then (fst s, offset_less (snd s) k) else s.
Definition wrapped_3 (v : nat) (k : offset_3) (c : torus_cell_3) : torus_cell_3 :=
  let '(a, b, c, d) := c in (wrapped_site_3 v k a, wrapped_site_3 v k b, wrapped_site_3 v k c, wrapped_site_3 v k d).
Definition back_3 (v : nat) (k : offset_3) (L : box_3) (x : nat -> vec) : nat -> vec := fun w => if Nat.eq_dec w v then x w ⊖ lattice_3 L k else x w.

Lemma wrapped_site_stays_3 v k L x s : site_at_3 x L (wrapped_site_3 v k s) = site_at_3 (back_3 v k L x) L s.
Proof.
  destruct s as (w, ((i, j), l)), k as ((m, n), o). unfold wrapped_site_3, back_3, site_at_3. simpl. destruct (Nat.eq_dec w v); simpl; [|reflexivity].
  rewrite !minus_IZR. generalize (x w) (L1 L) (L2 L) (L3 L). vector.
Qed.

Definition unit_box_3 : box_3 := Box_3 (V 1 0 0) (V 0 1 0) (V 0 0 1).
Lemma unit_det : det_3 unit_box_3 = 1.
Proof. unfold det_3, unit_box_3. simpl. coordinates. ring. Qed.

Theorem covers_wrapped_3 v k T : glued_torus_3 T -> covers_3 (map (wrapped_3 v k) T) = covers_3 T.
Proof.
  intro G. apply eq_IZR. apply Rmult_eq_reg_r with (det_3 unit_box_3); [|rewrite unit_det; lra].
  rewrite <- volumes_at_origin, sum_map, <- (degree_3 T G (back_3 v k unit_box_3 (fun _ => zero)) unit_box_3).
  apply sum_ext. intros (((a, b), c), d) _. unfold torus_volume, wrapped_3. now rewrite !wrapped_site_stays_3.
Qed.

(* ---- Another basis ---- *)

(* The old vectors are integer combinations m of the new ones. *)
Record basis_3 := Basis_3 { m1 : offset_3; m2 : offset_3; m3 : offset_3 }.
Definition combined_offset (m : basis_3) (o : offset_3) : offset_3 :=
  let '(i, j, k) := o in let '(a, b, c) := m1 m in let '(d, e, f) := m2 m in let '(g, h, l) := m3 m in
  (i * a + j * d + k * g, i * b + j * e + k * h, i * c + j * f + k * l)%Z.
Definition rebased_site_3 (m : basis_3) (s : site_3) : site_3 := (fst s, combined_offset m (snd s)).
Definition rebased_3 (m : basis_3) (c : torus_cell_3) : torus_cell_3 :=
  let '(a, b, c, d) := c in (rebased_site_3 m a, rebased_site_3 m b, rebased_site_3 m c, rebased_site_3 m d).
Definition combined_3 (m : basis_3) (L : box_3) : box_3 := Box_3 (lattice_3 L (m1 m)) (lattice_3 L (m2 m)) (lattice_3 L (m3 m)).

Lemma rebased_site_stays_3 m L x s : site_at_3 x L (rebased_site_3 m s) = site_at_3 x (combined_3 m L) s.
Proof.
  destruct s as (v, ((i, j), k)), m as [((a, b), c) ((d, e), f) ((g, h), l)]. unfold site_at_3, rebased_site_3, combined_3. simpl.
  rewrite !plus_IZR, !mult_IZR. generalize (x v) (L1 L) (L2 L) (L3 L). vector.
Qed.

Theorem covers_in_basis_3 m T : offset_det (m1 m) (m2 m) (m3 m) = 1%Z -> covers_3 (map (rebased_3 m) T) = covers_3 T.
Proof.
  intro D. induction T as [|c T IH]; simpl; [reflexivity|]. rewrite IH. f_equal.
  transitivity (offset_det (m1 m) (m2 m) (m3 m) * offset_volume c)%Z; [|rewrite D; ring]. clear D IH.
  destruct c as ((((v, ((a1, a2), a3)), (w, ((b1, b2), b3))), (u, ((c1, c2), c3))), (n, ((d1, d2), d3))), m as [((a, b), c) ((d, e), f) ((g, h), l)].
  unfold rebased_3, rebased_site_3, combined_offset, offset_volume, offset_less, offset_det. simpl. ring.
Qed.

(* ---- Flips, and regions that are triangulated anew ---- *)

Lemma covers_app_3 T U : covers_3 (T ++ U) = (covers_3 T + covers_3 U)%Z.
Proof. induction T as [|c T IH]; simpl; [reflexivity|]. rewrite IH. ring. Qed.

(* Both are in one frame: a facet of one of them that is not inside it is a facet of the other, and inside of each facets are met from both cells. *)
Definition and_back_3 (s : facet_3) : list facet_3 := let '(a, b, c) := s in [(a, b, c); (b, a, c)].
Definition same_border_3 (A B : list torus_cell_3) : Prop := exists inside_A inside_B l l',
  Forall2 turned_facet (flat_map facets_3 A) l /\ Forall2 turned_facet (flat_map facets_3 B) l' /\
  Permutation (l ++ flat_map and_back_3 inside_B) (l' ++ flat_map and_back_3 inside_A).

Definition facet_det (s : facet_3) : R := let '((_, a), (_, b), (_, c)) := s in IZR (offset_det a b c).

Lemma facet_turned s s' : turned_facet s s' -> facet_det s' = facet_det s.
Proof.
  intros [(v, ((a1, a2), a3)) (w, ((b1, b2), b3)) (u, ((c1, c2), c3))|(v, ((a1, a2), a3)) (w, ((b1, b2), b3)) (u, ((c1, c2), c3))|
    (v, ((a1, a2), a3)) (w, ((b1, b2), b3)) (u, ((c1, c2), c3))]; simpl; f_equal; ring.
Qed.

Lemma facets_turned l l' : Forall2 turned_facet l l' -> sum facet_det l' = sum facet_det l.
Proof. induction 1 as [|s s' l l' E _ IH]; simpl; [reflexivity|]. now rewrite IH, (facet_turned s s' E). Qed.

Lemma covers_by_facets T : IZR (covers_3 T) = - sum facet_det (flat_map facets_3 T).
Proof.
  induction T as [|c T IH]; [simpl; ring|]. cbn [covers_3 flat_map]. rewrite plus_IZR, IH, sum_app.
  enough (IZR (offset_volume c) = - sum facet_det (facets_3 c)) by lra.
  destruct c as ((((v, ((a1, a2), a3)), (w, ((b1, b2), b3))), (u, ((c1, c2), c3))), (n, ((d1, d2), d3))).
  cbn [facets_3 sum facet_det]. rewrite Rplus_0_r, <- !plus_IZR, <- opp_IZR. f_equal. unfold offset_volume, offset_less, offset_det. ring.
Qed.

Lemma insides_cancel_3 l : sum facet_det (flat_map and_back_3 l) = 0.
Proof.
  rewrite sum_flat_map, (sum_ext _ (fun _ => 0)), sum_zero; [reflexivity|].
  intros (((v, ((a1, a2), a3)), (w, ((b1, b2), b3))), (u, ((c1, c2), c3))) _. cbn [and_back_3 sum facet_det].
  rewrite Rplus_0_r, <- plus_IZR. apply (f_equal IZR). unfold offset_det. ring.
Qed.

Theorem covers_replaced_3 A B T : same_border_3 A B -> covers_3 (A ++ T) = covers_3 (B ++ T).
Proof.
  intros (inside_A & inside_B & l & l' & F & F' & P). rewrite !covers_app_3. f_equal. apply eq_IZR. rewrite !covers_by_facets.
  rewrite <- (facets_turned _ _ F), <- (facets_turned _ _ F'). generalize (sum_permutation facet_det _ _ P). rewrite !sum_app, !insides_cancel_3. lra.
Qed.

Example flip_2_3 a b c p q : covers_3 [(a, b, c, q); (b, a, c, p)] = covers_3 [(a, b, p, q); (b, c, p, q); (c, a, p, q)].
Proof.
  destruct a as (a, ((a1, a2), a3)), b as (b, ((b1, b2), b3)), c as (c, ((c1, c2), c3)), p as (p, ((p1, p2), p3)), q as (q, ((q1, q2), q3)).
  cbn [covers_3]. unfold offset_volume, offset_less, offset_det. ring.
Qed.
