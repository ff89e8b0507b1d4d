(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Cells in a periodic box of the plane, and how often they cover it: docs/theory.md 8.3.

   A cell is three sites; a site is a vertex with an offset, at the vertex's place moved by so many vectors of the box. Nothing is said of which site is where.

   - degree_2        glued cells: the sum of twice their signed areas is an integer times det L, wherever the vertices are and whatever the box is, inverted cells included.
                     The integer depends on vertices and offsets alone, so moves and changes of the box keep it
   - covers_even     that integer is even: twice the degree, the number of cells over a point if all are positive
   - covers_wrapped, covers_in_basis, covers_replaced    so do wrapping a vertex, another basis of the lattice, and replacing cells by others with the same border, a flip *)
Require Import Reals ZArith Lra Lia List Permutation.
From Annulus Require Import sums width_2.
From Annulus Require Export points_2.
Import ListNotations.
Open Scope R_scope.

Definition offset_2 : Type := Z * Z.
Definition site_2 : Type := nat * offset_2.
Definition side_2 : Type := site_2 * site_2.
Definition torus_cell_2 : Type := site_2 * site_2 * site_2.

Definition moved_2 (t : offset_2) (s : site_2) : site_2 := let '(v, (i, j)) := s in (v, (fst t + i, snd t + j)%Z).
Definition sides_2 (c : torus_cell_2) : list side_2 := let '(a, b, c) := c in [(a, b); (b, c); (c, a)].
(* A side and what it is glued to: the same two sites in the other order, moved by a vector of the lattice. *)
Definition both_sides_2 (k : side_2 * offset_2) : list side_2 := let '((a, b), t) := k in [(a, b); (moved_2 t b, moved_2 t a)].
Definition glued_torus_2 (T : list torus_cell_2) : Prop := exists pairs, Permutation (flat_map sides_2 T) (flat_map both_sides_2 pairs).

Definition box_2 : Type := point_2 * point_2.
Definition det_2 (L : box_2) : R := fst (fst L) * snd (snd L) - snd (fst L) * fst (snd L).
Definition site_at (x : nat -> point_2) (L : box_2) (s : site_2) : point_2 :=
  let '(v, (i, j)) := s in (fst (x v) + IZR i * fst (fst L) + IZR j * fst (snd L), snd (x v) + IZR i * snd (fst L) + IZR j * snd (snd L)).
Definition torus_area (x : nat -> point_2) (L : box_2) (c : torus_cell_2) : R :=
  let '(a, b, c) := c in turning (site_at x L a) (site_at x L b) (site_at x L c).

(* The same determinant of offsets alone. *)
Definition offset_turn (c : torus_cell_2) : Z :=
  let '((_, (i, j)), (_, (k, l)), (_, (m, n))) := c in ((k - i) * (n - j) - (l - j) * (m - i))%Z.
Fixpoint covers_2 (T : list torus_cell_2) : Z := match T with [] => 0%Z | c :: T' => (offset_turn c + covers_2 T')%Z end.

(* ---- Moves ---- *)

(* Twice the signed area that a side sweeps from p q to p' q'. *)
Definition swept (p q p' q' : point_2) : R :=
  (fst p * snd q - snd p * fst q) + (fst q * snd q' - snd q * fst q') + (fst q' * snd p' - snd q' * fst p') + (fst p' * snd p - snd p' * fst p).

Lemma swept_sides a b c a' b' c' :
  turning a b c - turning a' b' c' = swept a b a' b' + swept b c b' c' + swept c a c' a'.
Proof. unfold turning, turn, swept. ring. Qed.

Section moves.
Variables (x y : nat -> point_2) (L : box_2).
Definition swept_by (s : side_2) : R := swept (site_at x L (fst s)) (site_at x L (snd s)) (site_at y L (fst s)) (site_at y L (snd s)).

Lemma swept_both k : sum swept_by (both_sides_2 k) = 0.
Proof.
  destruct k as (((v, (i, j)), (w, (k, l))), (t, u)). unfold swept_by. simpl. unfold swept. simpl. rewrite !plus_IZR. ring.
Qed.

Lemma swept_cell c : torus_area x L c - torus_area y L c = sum swept_by (sides_2 c).
Proof. destruct c as ((a, b), c). unfold torus_area. rewrite swept_sides. unfold swept_by. simpl. ring. Qed.

Lemma area_kept T : glued_torus_2 T -> sum (torus_area x L) T = sum (torus_area y L) T.
Proof.
  intros (pairs & P). apply Rminus_diag_uniq.
  assert (E : sum (torus_area x L) T - sum (torus_area y L) T = sum swept_by (flat_map sides_2 T)).
  { rewrite sum_flat_map. transitivity (sum (fun c => torus_area x L c + (-1) * torus_area y L c) T).
    - rewrite sum_plus, sum_scale. ring.
    - apply sum_ext. intros c _. rewrite <- swept_cell. ring. }
  rewrite E, (sum_permutation _ _ _ P), sum_flat_map, (sum_ext _ (fun _ => 0)), sum_zero; [reflexivity|]. intros k _. apply swept_both.
Qed.
End moves.

Lemma area_at_origin L c : torus_area (fun _ => (0, 0)) L c = IZR (offset_turn c) * det_2 L.
Proof.
  destruct c as (((v, (i, j)), (w, (k, l))), (u, (m, n))). destruct L as ((a, b), (c, d)). unfold torus_area, offset_turn, det_2. simpl.
  rewrite minus_IZR, !mult_IZR, !minus_IZR. unfold turning, turn. simpl. ring.
Qed.

Lemma areas_at_origin L T : sum (torus_area (fun _ => (0, 0)) L) T = IZR (covers_2 T) * det_2 L.
Proof. induction T as [|c T IH]; simpl; [ring|]. rewrite IH, area_at_origin, plus_IZR. ring. Qed.

Theorem degree_2 T : glued_torus_2 T -> forall x L, sum (torus_area x L) T = IZR (covers_2 T) * det_2 L.
Proof. intros G x L. rewrite (area_kept x (fun _ => (0, 0)) L T G). apply areas_at_origin. Qed.

(* ---- The degree is an integer ---- *)

(* Up to even numbers: whether both ends have offsets that are equal up to even numbers. *)
Definition odd_side (s : side_2) : Z := let '((_, (i, j)), (_, (k, l))) := s in ((k - i) + (l - j) + (k - i) * (l - j))%Z.
Fixpoint odd_sides (l : list side_2) : Z := match l with [] => 0%Z | s :: l' => (odd_side s + odd_sides l')%Z end.

Lemma odd_sides_app l k : odd_sides (l ++ k) = (odd_sides l + odd_sides k)%Z.
Proof. induction l as [|s l IH]; simpl; [reflexivity|]. rewrite IH. ring. Qed.

Lemma odd_sides_permutation l k : Permutation l k -> odd_sides l = odd_sides k.
Proof. induction 1; simpl; lia. Qed.

Lemma odd_pairs pairs : exists n, odd_sides (flat_map both_sides_2 pairs) = (2 * n)%Z.
Proof.
  induction pairs as [|k pairs (n & IH)]; [now exists 0%Z|]. cbn [flat_map]. rewrite odd_sides_app, IH.
  destruct k as (((v, (i, j)), (w, (k, l))), (t, u)). exists ((k - i) * (l - j) + n)%Z.
  cbn [both_sides_2 moved_2 odd_sides odd_side fst snd]. ring.
Qed.

Lemma odd_cells T : exists n, covers_2 T = (odd_sides (flat_map sides_2 T) + 2 * n)%Z.
Proof.
  induction T as [|c T (n & IH)]; [now exists 0%Z|]. cbn [covers_2 flat_map]. rewrite odd_sides_app, IH.
  destruct c as (((v, (i, j)), (w, (k, l))), (u, (p, q))).
  exists ((k - i) * (q - j) - (k - i) * (l - j) - (p - i) * (q - j) + n)%Z.
  cbn [sides_2 odd_sides odd_side offset_turn]. ring.
Qed.

Theorem covers_even T : glued_torus_2 T -> exists N, covers_2 T = (2 * N)%Z.
Proof.
  intros (pairs & P). destruct (odd_cells T) as (n & E). destruct (odd_pairs pairs) as (k & E'). exists (k + n)%Z.
  rewrite E, (odd_sides_permutation _ _ P), E'. ring.
Qed.

(* ---- Wrapping ---- *)

(* Every corner of v gets the offset less k, and the place of v is k vectors of the box farther on: no site moves. *)
Definition wrapped_site_2 (v : nat) (k : offset_2) (s : site_2) : site_2 :=
  let '(w, (i, j)) := s in if Nat.eq_dec w v then (w, (i - fst k, j - snd k)%Z) else s.
Definition wrapped_2 (v : nat) (k : offset_2) (c : torus_cell_2) : torus_cell_2 :=
  let '(a, b, c) := c in (wrapped_site_2 v k a, wrapped_site_2 v k b, wrapped_site_2 v k c).

Definition back_2 (v : nat) (k : offset_2) (L : box_2) (x : nat -> point_2) : nat -> point_2 := fun w =>
  if Nat.eq_dec w v then (fst (x w) - IZR (fst k) * fst (fst L) - IZR (snd k) * fst (snd L), snd (x w) - IZR (fst k) * snd (fst L) - IZR (snd k) * snd (snd L)) else x w.

Lemma wrapped_site_stays v k L x s : site_at x L (wrapped_site_2 v k s) = site_at (back_2 v k L x) L s.
Proof.
  destruct s as (w, (i, j)). unfold wrapped_site_2, back_2. simpl. destruct (Nat.eq_dec w v); simpl; [|reflexivity].
  rewrite !minus_IZR. f_equal; ring.
Qed.

Lemma unit_areas T : sum (torus_area (fun _ => (0, 0)) ((1, 0), (0, 1))) T = IZR (covers_2 T).
Proof. rewrite areas_at_origin. unfold det_2. simpl. ring. Qed.

Theorem covers_wrapped v k T : glued_torus_2 T -> covers_2 (map (wrapped_2 v k) T) = covers_2 T.
Proof.
  intro G. apply eq_IZR. rewrite <- unit_areas, sum_map.
  rewrite (sum_ext _ (torus_area (back_2 v k ((1, 0), (0, 1)) (fun _ => (0, 0))) ((1, 0), (0, 1)))).
  - rewrite (degree_2 T G). unfold det_2. simpl. ring.
  - intros ((a, b), c) _. unfold torus_area, wrapped_2. now rewrite !wrapped_site_stays.
Qed.

(* ---- Another basis ---- *)

(* The old vectors are integer combinations m of the new ones. *)
Definition basis_2 : Type := offset_2 * offset_2.
Definition basis_det (m : basis_2) : Z := (fst (fst m) * snd (snd m) - snd (fst m) * fst (snd m))%Z.
Definition rebased_site_2 (m : basis_2) (s : site_2) : site_2 :=
  let '(v, (i, j)) := s in (v, (i * fst (fst m) + j * fst (snd m), i * snd (fst m) + j * snd (snd m))%Z).
Definition rebased_2 (m : basis_2) (c : torus_cell_2) : torus_cell_2 := let '(a, b, c) := c in (rebased_site_2 m a, rebased_site_2 m b, rebased_site_2 m c).
Definition combined_2 (m : basis_2) (L : box_2) : box_2 :=
  let combination (t : offset_2) := (IZR (fst t) * fst (fst L) + IZR (snd t) * fst (snd L), IZR (fst t) * snd (fst L) + IZR (snd t) * snd (snd L)) in
  (combination (fst m), combination (snd m)).

Lemma rebased_site_stays m L x s : site_at x L (rebased_site_2 m s) = site_at x (combined_2 m L) s.
Proof. destruct s as (v, (i, j)). unfold combined_2. simpl. rewrite !plus_IZR, !mult_IZR. f_equal; ring. Qed.

Theorem covers_in_basis m T : basis_det m = 1%Z -> covers_2 (map (rebased_2 m) T) = covers_2 T.
Proof.
  intro D. induction T as [|c T IH]; simpl; [reflexivity|]. rewrite IH. f_equal.
  destruct c as (((v, (i, j)), (w, (k, l))), (u, (p, q))). destruct m as ((a, b), (c, d)). unfold basis_det in D. simpl in *.
  transitivity ((a * d - b * c) * ((k - i) * (q - j) - (l - j) * (p - i)))%Z; [ring|]. rewrite D. ring.
Qed.

(* ---- Flips, and regions that are triangulated anew ---- *)

Lemma covers_app T U : covers_2 (T ++ U) = (covers_2 T + covers_2 U)%Z.
Proof. induction T as [|c T IH]; simpl; [reflexivity|]. rewrite IH. ring. Qed.

(* Both are in one frame: a side of one of them that is not inside it is a side of the other, and inside of each sides are met from both cells. *)
Definition and_back (s : side_2) : list side_2 := [s; (snd s, fst s)].
Definition same_border_2 (A B : list torus_cell_2) : Prop :=
  exists inside_A inside_B, Permutation (flat_map sides_2 A ++ flat_map and_back inside_B) (flat_map sides_2 B ++ flat_map and_back inside_A).

Definition offset_cross (s : side_2) : R := let '((_, (i, j)), (_, (k, l))) := s in IZR i * IZR l - IZR j * IZR k.

Lemma covers_by_sides T : IZR (covers_2 T) = sum offset_cross (flat_map sides_2 T).
Proof.
  induction T as [|c T IH]; [reflexivity|]. simpl covers_2. simpl flat_map. rewrite plus_IZR, IH, sum_app. f_equal.
  destruct c as (((v, (i, j)), (w, (k, l))), (u, (m, n))). simpl. rewrite minus_IZR, !mult_IZR, !minus_IZR. ring.
Qed.

Lemma insides_cancel l : sum offset_cross (flat_map and_back l) = 0.
Proof.
  rewrite sum_flat_map, (sum_ext _ (fun _ => 0)), sum_zero; [reflexivity|]. intros ((v, (i, j)), (w, (k, n))) _. simpl. ring.
Qed.

Theorem covers_replaced A B T : same_border_2 A B -> covers_2 (A ++ T) = covers_2 (B ++ T).
Proof.
  intros (inside_A & inside_B & P). rewrite !covers_app. f_equal. apply eq_IZR. rewrite !covers_by_sides.
  generalize (sum_permutation offset_cross _ _ P). rewrite !sum_app, !insides_cancel. lra.
Qed.

Ltac is_at n := match goal with |- Permutation (?x :: ?l) ?r =>
  let before := eval simpl in (firstn n r) in let after := eval simpl in (skipn (S n) r) in
  change (Permutation (x :: l) (before ++ x :: after)); apply Permutation_cons_app; simpl end.

Example flip_keeps_border a b p q : same_border_2 [(a, b, q); (b, a, p)] [(a, p, q); (b, q, p)].
Proof. exists [(a, b)], [(p, q)]. simpl. is_at 6%nat. is_at 3%nat. is_at 2%nat. is_at 4%nat. is_at 0%nat. is_at 2%nat. is_at 0%nat. is_at 0%nat. constructor. Qed.

(* One vertex in a square, and the two cells of docs/theory.md 8.3 that cover their box twice, though both are glued. *)
Definition of_one_vertex (i j k l m n : Z) : torus_cell_2 := ((0%nat, (i, j)), (0%nat, (k, l)), (0%nat, (m, n))).
Definition square_2 := [of_one_vertex 0 0 1 0 1 1; of_one_vertex 0 0 1 1 0 1].
Definition twice_2 := [of_one_vertex 0 0 2 0 0 1; of_one_vertex 2 0 2 1 0 1].
Definition one_edge (i j k l : Z) : side_2 := ((0%nat, (i, j)), (0%nat, (k, l))).

Example square_once : glued_torus_2 square_2 /\ covers_2 square_2 = 2%Z.
Proof.
  split; [|reflexivity]. exists [(one_edge 0 0 1 0, (0, 1)%Z); (one_edge 1 0 1 1, (-1, 0)%Z); (one_edge 1 1 0 0, (0, 0)%Z)]. simpl.
  is_at 0%nat. is_at 1%nat. is_at 2%nat. is_at 2%nat. is_at 0%nat. is_at 0%nat. constructor.
Qed.

Example covered_twice : glued_torus_2 twice_2 /\ covers_2 twice_2 = 4%Z.
Proof.
  split; [|reflexivity]. exists [(one_edge 0 0 2 0, (0, 1)%Z); (one_edge 2 0 0 1, (0, 0)%Z); (one_edge 0 1 0 0, (2, 0)%Z)]. simpl.
  is_at 0%nat. is_at 1%nat. is_at 2%nat. is_at 2%nat. is_at 0%nat. is_at 0%nat. constructor.
Qed.
