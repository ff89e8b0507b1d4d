(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Rays that cross the sides of triangles.

   - crossing_once   a ray from x crosses the sides of a positive triangle 1 or 0 times, counted with signs: 1 when x is strictly inside, and only
                     when x is inside
   - crossing_step   what changes between two points of the ray
   - by_sides        a sum over cells is one over bi-cells and the border: what two cells have in common cancels
   - covered         hence x is in as many cells as its ray crosses the border

   The ray from x goes in direction d. Whether the ends of a side are to its right is defined so that a ray through a vertex needs no case of its own. *)
Require Import Reals Lra Psatz List Permutation.
From Annulus Require Import sums width_2 plane_mesh.
Import ListNotations.
Open Scope R_scope.

(* ---- Points ---- *)

Lemma turning_mix e u v x y : turning u v (mix e x y) = (1 - e) * turning u v x + e * turning u v y.
Proof. unfold turning, turn, mix. simpl. ring. Qed.

Lemma turning_swap u v x : turning v u x = - turning u v x.
Proof. unfold turning, turn. ring. Qed.

Lemma turning_cycle u v x : turning v x u = turning u v x.
Proof. unfold turning, turn. ring. Qed.

Lemma turning_sum a b c x : turning a b x + turning b c x + turning c a x = turning a b c.
Proof. unfold turning, turn. ring. Qed.

(* x with the weights that turning gives it: for anything linear. *)
Lemma turning_cross a b c d x :
  turning b c x * cross d a + turning c a x * cross d b + turning a b x * cross d c = turning a b c * cross d x.
Proof. unfold turning, turn, cross. ring. Qed.

Lemma turning_vector u v x y : turning u v y = turning u v x - cross (vector x y) (vector u v).
Proof. unfold turning, turn, cross, vector. simpl. ring. Qed.

(* ---- One triangle ---- *)

(* The side from u to v begins on the right of the ray or on it, ends on its left, and has x on its left. *)
Definition passes (d x u v : point_2) : R :=
  if Rle_dec (cross d u) (cross d x) then if Rle_dec (cross d v) (cross d x) then 0 else if Rlt_dec 0 (turning u v x) then 1 else 0 else 0.
Definition crossing (d x u v : point_2) : R := passes d x u v - passes d x v u.
Definition crossings (d x a b c : point_2) : R := crossing d x a b + crossing d x b c + crossing d x c a.

Lemma crossing_swap d x u v : crossing d x v u = - crossing d x u v.
Proof. unfold crossing. ring. Qed.

Lemma passes_nonneg d x u v : 0 <= passes d x u v.
Proof. unfold passes. destruct (Rle_dec _ _); [|lra]. destruct (Rle_dec _ _); [lra|]. destruct (Rlt_dec _ _); lra. Qed.

Lemma passes_none d x u v : cross d x < cross d u \/ cross d v <= cross d u -> passes d x u v = 0.
Proof. intro H. unfold passes. destruct (Rle_dec _ _); [|lra]. destruct (Rle_dec _ _); [lra|]. exfalso. lra. Qed.

(* a is the only corner on its side of the ray: to the right of it or on it, or to the left of it. *)
Lemma alone_right A B C a b c : A * a + B * b + C * c = 0 -> 0 < A + B + C -> a <= 0 -> 0 < b -> 0 < c ->
  (0 < C -> 0 <= B -> 0 <= A) /\ (C <= 0 -> 0 <= B).
Proof.
  intros E S Ha Hb Hc. split.
  - intros HC HB. apply Rnot_lt_le. intro HA. assert (0 <= A * a) by nra. assert (0 < C * c) by nra. assert (0 <= B * b) by nra. lra.
  - intro HC. apply Rnot_lt_le. intro HB. assert (B * b < 0) by nra. assert (C * c <= 0) by nra. assert (0 < A * a) by lra. nra.
Qed.

Lemma alone_left A B C a b c : A * a + B * b + C * c = 0 -> 0 < A + B + C -> 0 < a -> b <= 0 -> c <= 0 ->
  (0 < B -> 0 <= C -> 0 <= A) /\ (B <= 0 -> 0 <= C).
Proof.
  intros E S Ha Hb Hc. split.
  - intros HB HC. assert (B * b <= 0) by nra. assert (C * c <= 0) by nra. nra.
  - intro HB. apply Rnot_lt_le. intro HC. assert (0 <= B * b) by nra. assert (0 <= C * c) by nra. assert (A <= 0) by nra. lra.
Qed.

(* All corners to the right of a ray or on it: then a positive triangle has no point strictly inside at its beginning. *)
Lemma all_right d a b c x : 0 < turning a b c -> (fst d <> 0 \/ snd d <> 0) -> strictly_in x a b c ->
  cross d a <= cross d x -> cross d b <= cross d x -> cross d c <= cross d x -> False.
Proof.
  intros P D (HC & HA & HB) Ha Hb Hc. generalize (turning_cross a b c d x) (turning_sum a b c x). intros E S.
  assert (Z : turning b c x * (cross d a - cross d x) + turning c a x * (cross d b - cross d x) + turning a b x * (cross d c - cross d x) = 0)
    by (rewrite <- S in E; lra).
  assert (Za : cross d a = cross d x) by nra. assert (Zb : cross d b = cross d x) by nra. assert (Zc : cross d c = cross d x) by nra.
  assert (F1 : fst d * turning a b c = 0).
  { replace (fst d * turning a b c) with ((fst b - fst a) * (cross d c - cross d a) - (fst c - fst a) * (cross d b - cross d a))
      by (unfold turning, turn, cross; ring). rewrite Za, Zb, Zc. ring. }
  assert (F2 : snd d * turning a b c = 0).
  { replace (snd d * turning a b c) with ((snd b - snd a) * (cross d c - cross d a) - (snd c - snd a) * (cross d b - cross d a))
      by (unfold turning, turn, cross; ring). rewrite Za, Zb, Zc. ring. }
  destruct D as [D|D]; apply D; nra.
Qed.

Definition one_or_none (d x a b c : point_2) : Prop :=
  (crossings d x a b c = 0 \/ crossings d x a b c = 1) /\
  ((fst d <> 0 \/ snd d <> 0) -> strictly_in x a b c -> crossings d x a b c = 1) /\
  (crossings d x a b c = 1 -> within x a b c).

Lemma one_or_none_cycle d x a b c : one_or_none d x b c a -> one_or_none d x a b c.
Proof.
  unfold one_or_none, strictly_in, within. replace (crossings d x b c a) with (crossings d x a b c) by (unfold crossings; ring). tauto.
Qed.

Ltac decide_sides :=
  repeat match goal with |- context [Rlt_dec 0 ?e] => destruct (Rlt_dec 0 e) end.

Lemma crossing_alone_right d x a b c : 0 < turning a b c -> cross d a <= cross d x -> cross d x < cross d b -> cross d x < cross d c ->
  one_or_none d x a b c.
Proof.
  intros P Ha Hb Hc. generalize (turning_cross a b c d x) (turning_sum a b c x). intros E S.
  destruct (alone_right (turning b c x) (turning c a x) (turning a b x) (cross d a - cross d x) (cross d b - cross d x) (cross d c - cross d x))
    as [K1 K2]; [rewrite <- S in E; lra | lra | lra | lra | lra |].
  unfold one_or_none, crossings, crossing, strictly_in, within, passes.
  destruct (Rle_dec (cross d a) (cross d x)); [|lra]. destruct (Rle_dec (cross d b) (cross d x)); [lra|].
  destruct (Rle_dec (cross d c) (cross d x)); [lra|].
  generalize (turning_swap c a x). decide_sides; intro W; repeat split; intros; lra.
Qed.

Lemma crossing_alone_left d x a b c : 0 < turning a b c -> cross d x < cross d a -> cross d b <= cross d x -> cross d c <= cross d x ->
  one_or_none d x a b c.
Proof.
  intros P Ha Hb Hc. generalize (turning_cross a b c d x) (turning_sum a b c x). intros E S.
  destruct (alone_left (turning b c x) (turning c a x) (turning a b x) (cross d a - cross d x) (cross d b - cross d x) (cross d c - cross d x))
    as [K1 K2]; [rewrite <- S in E; lra | lra | lra | lra | lra |].
  unfold one_or_none, crossings, crossing, strictly_in, within, passes.
  destruct (Rle_dec (cross d a) (cross d x)); [lra|]. destruct (Rle_dec (cross d b) (cross d x)); [|lra].
  destruct (Rle_dec (cross d c) (cross d x)); [|lra].
  generalize (turning_swap a b x). decide_sides; intro W; repeat split; intros; lra.
Qed.

Theorem crossing_once d x a b c : 0 < turning a b c -> one_or_none d x a b c.
Proof.
  intro P. assert (Pb : 0 < turning b c a) by (now rewrite turning_cycle).
  assert (Pc : 0 < turning c a b) by (now rewrite <- turning_cycle).
  destruct (Rle_dec (cross d a) (cross d x)) as [Ha|Ha]; destruct (Rle_dec (cross d b) (cross d x)) as [Hb|Hb];
    destruct (Rle_dec (cross d c) (cross d x)) as [Hc|Hc]; try (apply Rnot_le_lt in Ha); try (apply Rnot_le_lt in Hb); try (apply Rnot_le_lt in Hc).
  - assert (Z : crossings d x a b c = 0).
    { unfold crossings, crossing, passes. destruct (Rle_dec (cross d a) _), (Rle_dec (cross d b) _), (Rle_dec (cross d c) _); lra. }
    unfold one_or_none. rewrite Z. repeat split; try lra. intros D I. now elim (all_right d a b c x).
  - apply one_or_none_cycle, one_or_none_cycle. now apply crossing_alone_left.
  - apply one_or_none_cycle. now apply crossing_alone_left.
  - now apply crossing_alone_right.
  - now apply crossing_alone_left.
  - apply one_or_none_cycle. now apply crossing_alone_right.
  - apply one_or_none_cycle, one_or_none_cycle. now apply crossing_alone_right.
  - assert (Z : crossings d x a b c = 0).
    { unfold crossings, crossing, passes. destruct (Rle_dec (cross d a) _), (Rle_dec (cross d b) _), (Rle_dec (cross d c) _); lra. }
    unfold one_or_none. rewrite Z. repeat split; try lra. intros D (HC & HA & HB). exfalso.
    generalize (turning_cross a b c d x) (turning_sum a b c x). intros E S. rewrite <- S in E. nra.
Qed.

(* ---- Two points of a ray ---- *)

(* From x to y a side is left behind, crossed from the left or from the right, or keeps both on one side. *)
Definition kept_or_crossed (x y u v : point_2) (k : R) : Prop :=
  k = 0 \/ (k = -1 /\ turning u v y <= 0 /\ 0 < turning u v x) \/ (k = 1 /\ 0 <= turning u v y /\ turning u v x < 0).

Lemma passes_step x y u v : let d := vector x y in let k := passes d y u v - passes d x u v in
  k = 0 \/ (k = -1 /\ turning u v y <= 0 /\ 0 < turning u v x).
Proof.
  intros d k. unfold k, passes. assert (L : cross d y = cross d x) by (unfold d, cross, vector; simpl; ring). rewrite L.
  destruct (Rle_dec (cross d u) (cross d x)); [|lra]. destruct (Rle_dec (cross d v) (cross d x)); [lra|].
  generalize (turning_vector u v x y). fold d.
  replace (cross d (vector u v)) with (cross d v - cross d u) by (unfold cross, vector; simpl; ring). intro E.
  decide_sides; lra.
Qed.

Theorem crossing_step x y u v : let d := vector x y in kept_or_crossed x y u v (crossing d y u v - crossing d x u v).
Proof.
  intro d. unfold kept_or_crossed, crossing. generalize (passes_step x y u v) (passes_step x y v u). cbv zeta. fold d.
  rewrite !(turning_swap u v). intros [H|H] [K|K]; lra.
Qed.

(* ---- All cells ---- *)

Lemma by_sides T (g : nat -> nat -> R) (w : nat * nat * nat -> R) : glued T ->
  (forall a b, g b a = - g a b) -> (forall a b c, w (b, c, a) = w (a, b, c)) ->
  sum (fun t => let '(a, b, c) := t in w t * (g a b + g b c + g c a)) (cells T)
  = sum (fun k => let '(a, b, p, q) := k in g a b * (w (a, b, q) - w (b, a, p))) (bicells T)
    + sum (fun s => let '(a, b, c) := s in g a b * w s) (outer T).
Proof.
  intros [G _] Swap Cycle. set (f := fun s : nat * nat * nat => let '(a, b, c) := s in g a b * w s).
  transitivity (sum f (flat_map sides (cells T))).
  - rewrite sum_flat_map. apply sum_ext. intros [[a b] c] _. cbn. rewrite (Cycle b c a), (Cycle a b c). ring.
  - rewrite (sum_permutation f _ _ G), sum_app, sum_flat_map. f_equal. apply sum_ext. intros [[[a b] p] q] _. cbn. rewrite (Swap a b). ring.
Qed.

Section placed.
Variables (T : mesh) (m : placement).
Hypothesis gluing : glued T.

Definition crossings_of (d x : point_2) (t : nat * nat * nat) : R := let '(a, b, c) := t in crossings d x (m a) (m b) (m c).

Theorem covered d x : sum (crossings_of d x) (cells T) = sum (fun s => let '(u, v) := s in crossing d x (m u) (m v)) (ring (border T)).
Proof.
  generalize (by_sides T (fun u v => crossing d x (m u) (m v)) (fun _ => 1) gluing (fun u v => crossing_swap d x (m u) (m v)) (fun _ _ _ => eq_refl)).
  intro E. transitivity (sum (fun s => let '(u, v) := s in crossing d x (m u) (m v)) (map edge (outer T))).
  - rewrite sum_map. transitivity (0 + sum (fun s => let '(a, b, _) := s in crossing d x (m a) (m b) * 1) (outer T)).
    + rewrite <- (sum_zero (bicells T)). rewrite (sum_ext (fun _ => 0) (fun k => let '(a, b, p, q) := k in crossing d x (m a) (m b) * (1 - 1)))
        by (intros [[[a b] p] q] _; ring).
      rewrite <- E. apply sum_ext. intros [[a b] c] _. simpl. unfold crossings. ring.
    + rewrite Rplus_0_l. apply sum_ext. intros [[a b] c] _. simpl. ring.
  - apply sum_permutation, gluing.
Qed.
End placed.
