(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* From the certificates of the plane to a Delaunay triangulation, with nothing in between: docs/theory.md 1.2.

   - regular                heights of vertices that are convex across each bi-cell are convex: no vertex is below a cell
   - plane_delaunay         cells positive, border convex and winding once, circles empty: then no vertex is strictly inside any circle
   - plane_delaunay_strict  with strict certificates all others are strictly outside

   Heights are any numbers. The squares of the distances from the origin give circles (the lifting), perturbed they give
   strictness. *)
Require Import Reals Lra Psatz List Permutation Arith.
From Annulus Require Import sums small width_2 plane_mesh plane_crossings plane_border plane_embedding plane_heights.
Import ListNotations.
Open Scope R_scope.

Section placed.
Variables (T : mesh) (m : placement).
Hypothesis gluing : glued T.
Hypothesis cells_positive : positive m T.
Hypothesis border_convex : convex m (border T).
Hypothesis border_once : winds_once m (border T).


(* ---- Convex heights ---- *)

Theorem regular f : (forall a b p q, In (a, b, p, q) (bicells T) -> 0 <= fold m f a b p q) ->
  forall t v, In t (cells T) -> vertex_of T v -> plane_through m f (m v) t <= f v.
Proof.
  intros Convex t v It (u & Iu & Cv). assert (Corner := plane_corner m f u v (positive_cell T m cells_positive u Iu) Cv).
  set (x := middle m t). set (y := middle m u). rewrite <- Corner. apply Rminus_le, Ropp_le_cancel. rewrite Ropp_0.
  apply small_limit with (- (plane_through m f y t - plane_through m f y u)).
  apply (small_impl (fun e => e < 1)); [|apply small_below; lra]. intros e E L.
  assert (Hx : inside_cell m x t) by now apply middle_inside with T.
  assert (Hy : inside_cell m (mix e (m v) y) u) by (apply mix_inside with T; trivial; [lra|]; now apply corner_in with T).
  assert (Goal : 0 <= plane_through m f (mix e (m v) y) u - plane_through m f (mix e (m v) y) t); [|rewrite !plane_mix in Goal; lra].
  destruct (zero_or_not (vector x (mix e (m v) y))) as [Z|D].
  - replace u with t; [lra|]. apply (same_cell T m gluing cells_positive border_once x); trivial.
    apply inside_in. rewrite <- (same_place _ _ Z). exact Hy.
  - rewrite (planes_change T m gluing cells_positive border_convex border_once f x _ t u D It Iu Hx Hy). apply sum_nonneg.
    intros [[[a b] p] q] I. destruct (cells_of_bicell T m gluing cells_positive a b p q I) as [Q P].
    assert (B : 0 <= bend m f a b p q) by (apply Rmult_le_pos; [now apply Convex|]; apply Rlt_le, Rinv_0_lt_compat; now apply Rmult_lt_0_compat).
    generalize (step_cases m x (mix e (m v) y) a b). unfold kept_or_crossed. intros [->|[(-> & H & _)|(-> & H & _)]]; nra.
Qed.

(* ---- Circles ---- *)

Definition lift v : R := fst (m v) * fst (m v) + snd (m v) * snd (m v).

Lemma power_lift a b c o r2 z : 0 < turn_at m a b c -> dist2 (m a) o = r2 -> dist2 (m b) o = r2 -> dist2 (m c) o = r2 ->
  dist2 (m z) o - r2 = lift z - plane_through m lift (m z) (a, b, c).
Proof.
  intros P A B C. apply (Rmult_eq_reg_l (turn_at m a b c)); [|lra].
  transitivity (turn_at m a b c * dist2 (m z) o - (turning (m b) (m c) (m z) * dist2 (m a) o + turning (m c) (m a) (m z) * dist2 (m b) o
    + turning (m a) (m b) (m z) * dist2 (m c) o)).
  - rewrite A, B, C. unfold turn_at. rewrite <- (turning_sum (m a) (m b) (m c) (m z)). ring.
  - unfold plane_through. field_simplify; [|lra]. unfold lift, dist2, d2, turn_at, turning, turn. ring.
Qed.

Lemma circle_of a b c : 0 < turn_at m a b c -> exists o r2, dist2 (m a) o = r2 /\ dist2 (m b) o = r2 /\ dist2 (m c) o = r2.
Proof.
  unfold turn_at, turning, turn. destruct (m a) as [x y], (m b) as [x' y'], (m c) as [x'' y'']. cbn [fst snd].
  set (D := (x' - x) * (y'' - y) - (y' - y) * (x'' - x)). intro P.
  exists (x + (((x' - x) * (x' - x) + (y' - y) * (y' - y)) * (y'' - y) - ((x'' - x) * (x'' - x) + (y'' - y) * (y'' - y)) * (y' - y)) / (2 * D),
    y + (((x'' - x) * (x'' - x) + (y'' - y) * (y'' - y)) * (x' - x) - ((x' - x) * (x' - x) + (y' - y) * (y' - y)) * (x'' - x)) / (2 * D)).
  eexists. split; [reflexivity|]. unfold dist2, d2, D in *. cbn [fst snd]. split; field; lra.
Qed.

Theorem plane_delaunay : locally_delaunay m T -> delaunay m T.
Proof.
  intros L a b c It. destruct (circle_of a b c (cells_positive a b c It)) as (o & r2 & A & B & C). exists o, r2. repeat split; trivial.
  intros z Vz. generalize (power_lift a b c o r2 z (cells_positive a b c It) A B C).
  assert (H : plane_through m lift (m z) (a, b, c) <= lift z); [|lra].
  apply regular; trivial. intros a' b' p q I. unfold lift. rewrite fold_incircle. now apply L.
Qed.

(* A vertex that is lowered a little keeps strict certificates. *)
Definition lowered (z : nat) (e : R) (v : nat) : R := lift v - (if Nat.eq_dec v z then e else 0).

Lemma lowered_fold z a b p q : 0 < incircle_at m a b p q -> small (fun e => 0 <= fold m (lowered z e) a b p q).
Proof.
  intro P. set (k := fold m (fun v => if Nat.eq_dec v z then 1 else 0) a b p q).
  apply (small_impl (fun e => 0 < (1 - e) * incircle_at m a b p q + e * (incircle_at m a b p q - k))); [|now apply small_positive].
  intros e _ H. replace (fold m (lowered z e) a b p q) with (incircle_at m a b p q - e * k); [lra|].
  assert (E : forall v, (if Nat.eq_dec v z then e else 0) = e * (if Nat.eq_dec v z then 1 else 0)) by (intro v; destruct (Nat.eq_dec v z); ring).
  rewrite <- fold_incircle. unfold k, fold, lowered, lift. rewrite !E. ring.
Qed.

Theorem plane_delaunay_strict : (forall a b p q, In (a, b, p, q) (bicells T) -> 0 < incircle_at m a b p q) ->
  forall a b c z o r2, In (a, b, c) (cells T) -> vertex_of T z -> ~ corner z (a, b, c) ->
  dist2 (m a) o = r2 -> dist2 (m b) o = r2 -> dist2 (m c) o = r2 -> r2 < dist2 (m z) o.
Proof.
  intros L a b c z o r2 It Vz N A B C. generalize (power_lift a b c o r2 z (cells_positive a b c It) A B C).
  assert (S : small (fun e => forall k, In k (bicells T) -> let '(a, b, p, q) := k in 0 <= fold m (lowered z e) a b p q)).
  { apply small_all. intros [[[a' b'] p] q] I. now apply lowered_fold, L. }
  destruct (small_exists _ S) as (e & E & F).
  assert (H : plane_through m (lowered z e) (m z) (a, b, c) <= lowered z e z).
  { apply regular; trivial. intros a' b' p q I. apply (F _ I). }
  replace (plane_through m (lowered z e) (m z) (a, b, c)) with (plane_through m lift (m z) (a, b, c)) in H.
  - unfold lowered in H. destruct (Nat.eq_dec z z); [lra|contradiction].
  - unfold plane_through, lowered. simpl in N. destruct (Nat.eq_dec a z), (Nat.eq_dec b z), (Nat.eq_dec c z); try (exfalso; subst; tauto).
    now rewrite !Rminus_0_r.
Qed.
End placed.
