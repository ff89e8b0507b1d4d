(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The border of a mesh of space, seen from afar: docs/theory.md 1.2, lemma 3. It falls into an upper and a lower sheet, meshes of the plane with one common
   border, the silhouette. Where sheets are glued, their images positive, the silhouette turns left and winds once, and ridges are convex,

   - nothing_beyond   no vertex of either sheet is beyond a facet of either

   p, q, 1 is the direction of sight. Facets of the lower sheet turn left as seen from within, those of the upper sheet as seen from outside. *)
Require Import Reals Lra Psatz List Permutation.
From Annulus Require Import vectors space_mesh width_2 plane_mesh plane_crossings plane_embedding plane_heights plane_delaunay plane_exit.
Import ListNotations.
Open Scope R_scope.

Section seen.
Variables (p q : R) (m : placement_3).

Definition seen (x : vec) : point_2 := (X1 x - p * X3 x, X2 x - q * X3 x).
Definition image : placement := fun v => seen (m v).
Definition height (v : nat) : R := X3 (m v).

Lemma above_facet f s a b c v : 0 < turn_at image a b c -> (forall v, f v = s * height v) ->
  s * orient (m a) (m b) (m c) (m v) = turn_at image a b c * (f v - plane_through image f (image v) (a, b, c)).
Proof.
  intros P F. unfold plane_through. rewrite !F. transitivity (turn_at image a b c * (s * height v) - s * (turning (image b) (image c) (image v) * height a
    + turning (image c) (image a) (image v) * height b + turning (image a) (image b) (image v) * height c)); [|field; lra].
  unfold height, image, turn_at, turning, turn, seen, orient. cbn [fst snd]. generalize (m a) (m b) (m c) (m v). intros [? ? ?] [? ? ?] [? ? ?] [? ? ?]. coordinates. ring.
Qed.

Lemma fold_facet f s a b x y : (forall v, f v = s * height v) -> fold image f a b x y = s * orient (m a) (m b) (m y) (m x).
Proof.
  intro F. unfold fold. rewrite !F. unfold height, image, turn_at, turning, turn, seen, orient. cbn [fst snd].
  generalize (m a) (m b) (m x) (m y). intros [? ? ?] [? ? ?] [? ? ?] [? ? ?]. coordinates. ring.
Qed.

Lemma plane_affine_2 (f : nat -> R) a b c : exists n k, forall y, plane_through image f y (a, b, c) = dot n y + k.
Proof.
  set (D := turn_at image a b c).
  exists (((snd (image b) - snd (image c)) * f a + (snd (image c) - snd (image a)) * f b + (snd (image a) - snd (image b)) * f c) / D,
    ((fst (image c) - fst (image b)) * f a + (fst (image a) - fst (image c)) * f b + (fst (image b) - fst (image a)) * f c) / D),
    (((fst (image b) * snd (image c) - snd (image b) * fst (image c)) * f a + (fst (image c) * snd (image a) - snd (image c) * fst (image a)) * f b
      + (fst (image a) * snd (image b) - snd (image a) * fst (image b)) * f c) / D).
  intro y. unfold plane_through, dot, Rdiv. fold D. cbn [fst snd]. unfold turning, turn. ring.
Qed.

(* ---- One sheet, and another with the same border ---- *)

(* s is 1 for the lower sheet, which is convex, and -1 for the upper one. *)
Record sheet (s : R) (S : mesh) : Prop := {
  sheet_glued : glued S;
  sheet_positive : positive image S;
  sheet_turns : convex image (border S);
  sheet_once : winds_once image (border S);
  sheet_ridges : forall a b x y, In (a, b, x, y) (bicells S) -> 0 <= s * orient (m a) (m b) (m y) (m x) }.

Lemma sheet_below s S a b c v : sheet s S -> In (a, b, c) (cells S) -> vertex_of S v -> 0 <= s * orient (m a) (m b) (m c) (m v).
Proof.
  intros [G P C W R] I V. set (f := fun v => s * height v). rewrite (above_facet f s) by (trivial; now apply P).
  apply Rmult_le_pos; [now apply Rlt_le, P|]. assert (K : plane_through image f (image v) (a, b, c) <= f v); [|lra].
  apply (regular S image); trivial. intros a' b' x y I'. rewrite (fold_facet f s) by trivial. now apply R.
Qed.

Lemma border_vertex S v : glued S -> In v (border S) -> vertex_of S v.
Proof.
  intros [G H] I. assert (E : exists b, In (v, b) (ring (border S))).
  { clear G H. destruct (border S) as [|a l]; [easy|]. unfold ring. cbn [firstn]. revert I. generalize (a :: l). intros k. revert a.
    induction k as [|c k IH]; intros a I; [easy|]. destruct I as [->|I].
    - destruct k as [|d k]; [exists a|exists d]; now left.
    - destruct (IH a I) as (b & B). exists b. destruct k as [|d k]; [easy|]. now right. }
  destruct E as (b & B). rewrite <- H in B. apply in_map_iff in B. destruct B as ([[a' b'] c] & E & B). injection E as -> ->.
  assert (K : In (v, b, c) (flat_map sides (cells S))) by (rewrite G; apply in_or_app; now right).
  apply in_flat_map in K. destruct K as ([[x y] z] & It & K). exists (x, y, z). split; [exact It|].
  destruct K as [K|[K|[K|[]]]]; injection K as -> _ _; simpl; tauto.
Qed.

Lemma sheets_apart s S S' a b c v : sheet s S -> sheet (- s) S' -> border S' = border S ->
  In (a, b, c) (cells S) -> vertex_of S' v -> 0 <= s * orient (m a) (m b) (m c) (m v).
Proof.
  intros H H' E I (t & It & C). destruct (H) as [G P _ _ _], (H') as [G' P' C' W' R']. set (f := fun v => s * height v). set (g := fun v => - s * height v).
  rewrite (above_facet f s) by (trivial; now apply P). apply Rmult_le_pos; [now apply Rlt_le, P|].
  destruct t as [[x y] z]. destruct (plane_affine_2 f a b c) as (n & k & A), (plane_affine_2 g x y z) as (n' & k' & B).
  assert (Z : dot (fst n + fst n', snd n + snd n') (image v) + (k + k') <= 0).
  { apply (border_bounds S' image G' P'); [|now exists (x, y, z)]. intros w Iw.
    assert (V' := border_vertex S' w G' Iw). rewrite E in Iw. assert (V := border_vertex S w G Iw).
    assert (L : 0 <= s * orient (m a) (m b) (m c) (m w)) by now apply (sheet_below s S).
    assert (L' : 0 <= - s * orient (m x) (m y) (m z) (m w)) by now apply (sheet_below (- s) S').
    rewrite (above_facet f s) in L by (trivial; now apply P). rewrite (above_facet g (- s)) in L' by (trivial; now apply P').
    assert (D := P a b c I). assert (D' := P' x y z It). rewrite A in L. rewrite B in L'.
    assert (F : 0 <= f w - (dot n (image w) + k)) by (apply (Rmult_le_reg_l (turn_at image a b c)); lra).
    assert (F' : 0 <= g w - (dot n' (image w) + k')) by (apply (Rmult_le_reg_l (turn_at image x y z)); lra).
    unfold f, g, dot in *. cbn [fst snd]. lra. }
  assert (K := plane_corner image g (x, y, z) v (P' x y z It) C). rewrite B in K. rewrite A. unfold f, g, dot in *. cbn [fst snd] in *. lra.
Qed.

Theorem nothing_beyond U L v : sheet (-1) U -> sheet 1 L -> border U = border L -> vertex_of U v \/ vertex_of L v ->
  (forall a b c, In (a, b, c) (cells U) -> orient (m a) (m b) (m c) (m v) <= 0) /\
  (forall a b c, In (a, b, c) (cells L) -> 0 <= orient (m a) (m b) (m c) (m v)).
Proof.
  intros HU HL E V. assert (HU' : sheet (- (1)) U) by exact HU. assert (HL' : sheet (- -1) L) by (replace (- -1) with 1 by ring; exact HL).
  split; intros a b c I; destruct V as [V|V].
  - generalize (sheet_below (-1) U a b c v HU I V). lra.
  - generalize (sheets_apart (-1) U L a b c v HU HL' (eq_sym E) I V). lra.
  - generalize (sheets_apart 1 L U a b c v HL HU' E I V). lra.
  - generalize (sheet_below 1 L a b c v HL I V). lra.
Qed.
End seen.
