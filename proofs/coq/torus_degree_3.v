(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* How often glued cells cover a periodic box of space is an integer: docs/theory.md 8.3.

   - covers_by_pairs   covers_3 is six times a sum over pairs of facets: of t_1, for facets that are glued t vectors away, times an area of the facet's shadow
   - covers_six        areas of integers will do, so covers_3, six times the degree, is a multiple of six

   The shadow is that in the plane of the second and third axis. The volume between facet and shadow is a third of the sum of its first coordinates times
   the area; facets that are glued have one shadow, so that covers_3 is a sum of t_1 times areas, at the offsets or any places that move with them. An
   area is a sum over edges. It may be changed there by what turns over with the edge and is the same in all frames (rounding): in a cell each edge is in
   two facets, once each way, so that the changes, times the first coordinates of their ends, cancel. *)
Require Import Reals ZArith Lra Lia List Permutation Bool.
From Annulus Require Import sums torus_2 torus_3.
Import ListNotations.
Open Scope R_scope.

Definition around (f : site_3 -> site_3 -> R) (s : facet_3) : R := let '(a, b, c) := s in f a b + f b c + f c a.
Definition first_of (a : site_3) : R := let '(_, (i, _, _)) := a in IZR i.
Definition second_of (a : site_3) : R := let '(_, (_, j, _)) := a in IZR j.

Lemma around_turned f s s' : turned_facet s s' -> around f s' = around f s.
Proof. intros []; unfold around; ring. Qed.

Lemma first_moved t a : first_of (moved_3 t a) = IZR (fst (fst t)) + first_of a.
Proof. destruct t as ((t1, t2), t3), a as (v, ((i, j), k)). simpl. apply plus_IZR. Qed.

Lemma second_moved t a : second_of (moved_3 t a) = IZR (snd (fst t)) + second_of a.
Proof. destruct t as ((t1, t2), t3), a as (v, ((i, j), k)). simpl. apply plus_IZR. Qed.

Lemma sum_by_pairs (g : facet_3 -> R) T l pairs : (forall s s', turned_facet s s' -> g s' = g s) ->
  Forall2 turned_facet (flat_map facets_3 T) l -> Permutation l (flat_map both_sides_3 pairs) ->
  sum (fun c => sum g (facets_3 c)) T = sum (fun k => sum g (both_sides_3 k)) pairs.
Proof.
  intros Turned F P. rewrite <- !sum_flat_map, <- (sum_permutation g _ _ P). clear P.
  induction F as [|s s' k k' H F IH]; simpl; [reflexivity|]. now rewrite IH, (Turned s s' H).
Qed.

(* ---- Areas of shadows, changed at their edges ---- *)

Section areas.
Variables (h : nat -> R) (e : site_3 -> site_3 -> R).
Hypothesis e_back : forall a b, e b a = - e a b.

Definition third_of (a : site_3) : R := let '(v, (_, _, k)) := a in h v + IZR k.
(* Twice the area below an edge. *)
Definition exact_under (a b : site_3) : R := (second_of a + second_of b) * (third_of b - third_of a).
Definition rounding (a b : site_3) : R := 2 * e a b - exact_under a b.
Definition moves_along (t : offset_3) (a b : site_3) : Prop :=
  e (moved_3 t a) (moved_3 t b) = e a b + IZR (snd (fst t)) * (third_of b - third_of a).

Lemma third_moved t a : third_of (moved_3 t a) = IZR (snd t) + third_of a.
Proof. destruct t as ((t1, t2), t3), a as (v, ((i, j), k)). simpl. rewrite plus_IZR. ring. Qed.

Lemma rounding_back a b : rounding b a = - rounding a b.
Proof. unfold rounding, exact_under. rewrite e_back. ring. Qed.

Lemma rounding_moved t a b : moves_along t a b -> rounding (moved_3 t a) (moved_3 t b) = rounding a b.
Proof. unfold rounding, exact_under. intros ->. rewrite !second_moved, !third_moved. ring. Qed.

Definition wide (f : site_3 -> site_3 -> R) (a b : site_3) : R := (first_of a + first_of b) * f a b.
Definition wedge_of (s : facet_3) : R := let '(a, b, c) := s in (first_of a + first_of b + first_of c) * around exact_under s.

Lemma wedge_turned s s' : turned_facet s s' -> wedge_of s' = wedge_of s.
Proof. intros []; unfold wedge_of, around; ring. Qed.

Lemma rounding_cell c : sum (around (wide rounding)) (facets_3 c) = 0.
Proof.
  destruct c as (((a, b), c), d). cbn [facets_3 sum around]. unfold wide.
  rewrite (rounding_back c d), (rounding_back b d), (rounding_back c b), (rounding_back a d), (rounding_back c a), (rounding_back b a). ring_simplify.
  rewrite ?(rounding_back a c), ?(rounding_back a b). ring.
Qed.

Definition moves_so (k : facet_3 * offset_3) : Prop := let '((a, b, c), t) := k in moves_along t a b /\ moves_along t b c /\ moves_along t c a.

Lemma rounding_pair k : moves_so k -> sum (around (wide rounding)) (both_sides_3 k) = -2 * (IZR (fst (fst (snd k))) * around rounding (fst k)).
Proof.
  destruct k as (((a, b), c), t). intros (A & B & C). cbn [both_sides_3 sum around fst snd]. unfold wide. rewrite !first_moved.
  rewrite (rounding_back (moved_3 t a) (moved_3 t b)), (rounding_back (moved_3 t b) (moved_3 t c)), (rounding_back (moved_3 t c) (moved_3 t a)).
  rewrite (rounding_moved t a b A), (rounding_moved t b c B), (rounding_moved t c a C). ring.
Qed.

Lemma wedge_pair k : sum wedge_of (both_sides_3 k) = -3 * (IZR (fst (fst (snd k))) * around exact_under (fst k)).
Proof.
  destruct k as (((a, b), c), t). cbn [both_sides_3 sum fst snd]. unfold wedge_of, around, exact_under.
  rewrite !first_moved, !second_moved, !third_moved. ring.
Qed.

Definition raised (v : nat) : vec := V 0 0 (h v).
Lemma wedge_cell c : torus_volume raised unit_box_3 c = - sum wedge_of (facets_3 c).
Proof.
  destruct c as ((((v, ((a1, a2), a3)), (w, ((b1, b2), b3))), (u, ((c1, c2), c3))), (n, ((d1, d2), d3))).
  unfold torus_volume, six_volumes, wedge_of, around, exact_under, site_at_3, lattice_3, unit_box_3, raised.
  cbn [facets_3 sum first_of second_of third_of L1 L2 L3 fst snd]. coordinates. ring.
Qed.

Theorem covers_by_pairs T l pairs : Forall2 turned_facet (flat_map facets_3 T) l -> Permutation l (flat_map both_sides_3 pairs) ->
  (forall k, In k pairs -> moves_so k) -> IZR (covers_3 T) = 6 * sum (fun k => IZR (fst (fst (snd k))) * around e (fst k)) pairs.
Proof.
  intros F P M. assert (G : glued_torus_3 T) by now exists l, pairs.
  assert (Z : sum (fun k => -2 * (IZR (fst (fst (snd k))) * around rounding (fst k))) pairs = 0).
  { rewrite (sum_ext _ (fun k => sum (around (wide rounding)) (both_sides_3 k))) by (intros k I; now rewrite rounding_pair by now apply M).
    rewrite <- (sum_by_pairs _ T l pairs (around_turned _) F P), (sum_ext _ (fun _ => 0)) by (intros; apply rounding_cell). apply sum_zero. }
  assert (C : IZR (covers_3 T) = 3 * sum (fun k => IZR (fst (fst (snd k))) * around exact_under (fst k)) pairs).
  { replace 3 with (-1 * -3) by ring. rewrite Rmult_assoc, <- sum_scale, (sum_ext _ (fun k => sum wedge_of (both_sides_3 k))) by (intros;
    now rewrite wedge_pair).
    rewrite <- (sum_by_pairs _ T l pairs wedge_turned F P), <- sum_scale. transitivity (sum (torus_volume raised unit_box_3) T).
    - rewrite (degree_3 T G), unit_det. ring.
    - apply sum_ext. intros c _. rewrite wedge_cell. ring. }
  assert (D : sum (fun k => IZR (fst (fst (snd k))) * around exact_under (fst k)) pairs
    = 2 * sum (fun k => IZR (fst (fst (snd k))) * around e (fst k)) pairs + -1 * sum (fun k => IZR (fst (fst (snd k))) * around rounding (fst k)) pairs).
  { rewrite <- !sum_scale, <- sum_plus. apply sum_ext. intros (((a, b), c), t) _. unfold around, rounding. cbn [fst snd]. ring. }
  rewrite C, D. rewrite sum_scale in Z. lra.
Qed.
End areas.

(* ---- Integers ---- *)

Definition half_under (x y : Z) : Z := if (0 <? x)%Z || (x =? 0)%Z && (0 <? y)%Z then (x * y)%Z else 0%Z.
Definition under (a b : site_3) : Z := let '((_, (_, j, k)), (_, (_, m, n))) := (a, b) in (j * (n - k) + half_under (m - j) (n - k))%Z.

Lemma half_under_back x y : (half_under x y + half_under (- x) (- y))%Z = (x * y)%Z.
Proof.
  unfold half_under. destruct (Z.ltb_spec 0 x), (Z.ltb_spec 0 (- x)), (Z.eqb_spec x 0), (Z.eqb_spec (- x) 0), (Z.ltb_spec 0 y), (Z.ltb_spec 0 (- y));
    simpl; try lia; subst; nia.
Qed.

Lemma under_back a b : (under b a = - under a b)%Z.
Proof.
  destruct a as (v, ((i, j), k)), b as (w, ((l, m), n)). unfold under. assert (E := half_under_back (m - j) (n - k)).
  replace (- (m - j))%Z with (j - m)%Z in E by ring. replace (- (n - k))%Z with (k - n)%Z in E by ring. nia.
Qed.

Lemma under_moved t a b : moves_along (fun _ => 0) (fun a b => IZR (under a b)) t a b.
Proof.
  destruct t as ((t1, t2), t3), a as (v, ((i, j), k)), b as (w, ((l, m), n)). unfold moves_along, under, moved_3, third_of. cbn [fst snd].
  replace (t2 + m - (t2 + j))%Z with (m - j)%Z by ring. replace (t3 + n - (t3 + k))%Z with (n - k)%Z by ring.
  rewrite !plus_IZR, !mult_IZR, !minus_IZR, !plus_IZR. ring.
Qed.

Lemma whole_sum {S : Type} (f : S -> Z) l : exists n, sum (fun s => IZR (f s)) l = IZR n.
Proof. induction l as [|s l (n & E)]; [now exists 0%Z|]. exists (f s + n)%Z. simpl. now rewrite E, plus_IZR. Qed.

Theorem covers_six T : glued_torus_3 T -> exists N, covers_3 T = (6 * N)%Z.
Proof.
  intros (l & pairs & F & P).
  destruct (whole_sum (fun k : facet_3 * offset_3 => let '((a, b, c), t) := k in (fst (fst t) * (under a b + under b c + under c a))%Z) pairs) as (N & E).
  exists N. apply eq_IZR. rewrite mult_IZR, <- E.
  rewrite (covers_by_pairs (fun _ => 0) (fun a b => IZR (under a b))) with (l := l) (pairs := pairs); trivial.
  - f_equal. apply sum_ext. intros (((a, b), c), t) _. unfold around. cbn [fst snd]. now rewrite mult_IZR, !plus_IZR.
  - intros a b. now rewrite under_back, opp_IZR.
  - intros (((a, b), c), t) _. repeat split; apply under_moved.
Qed.
