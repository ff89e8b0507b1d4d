(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* How often glued cells cover a periodic box of space is an integer: docs/theory.md 8.3.

   - covers_six   covers_3, six times the degree, is a multiple of six

   The volume between a facet and the plane of the second and third axis is a third of the sum of its first coordinates, times the area of its
   shadow there. At the offsets, facets that are glued t vectors away have one shadow, so covers_3 is a sum of t_1 times areas. An area is a sum over
   edges, and may be changed there by what turns over with the edge and is the same in all frames (rounding): in a cell each edge is in two facets,
   once each way, so that the changes, times the first coordinates of their ends, cancel. Changed so that they are integers (under), areas give six
   times an integer. *)
Require Import Reals ZArith Lra Lia List Permutation Bool.
From Annulus Require Import sums torus_2 torus_3.
Import ListNotations.
Open Scope R_scope.

(* Twice the area below an edge in the second and third coordinate, made even: it is turned with the edge, and what is added does not change with the frame. *)
Definition half_under (x y : Z) : Z := if (0 <? x)%Z || (x =? 0)%Z && (0 <? y)%Z then (x * y)%Z else 0%Z.
Definition under (a b : site_3) : Z := let '((_, (_, j, k)), (_, (_, m, n))) := (a, b) in (j * (n - k) + half_under (m - j) (n - k))%Z.
Definition around (f : site_3 -> site_3 -> R) (s : facet_3) : R := let '(a, b, c) := s in f a b + f b c + f c a.
Definition first_of (a : site_3) : R := let '(_, (i, _, _)) := a in IZR i.
Definition exact_under (a b : site_3) : R := let '((_, (_, j, k)), (_, (_, m, n))) := (a, b) in (IZR j + IZR m) * (IZR n - IZR k).
Definition rounding (a b : site_3) : R := 2 * IZR (under a b) - exact_under a b.

Lemma half_under_back x y : (half_under x y + half_under (- x) (- y))%Z = (x * y)%Z.
Proof. unfold half_under. destruct (Z.ltb_spec 0 x), (Z.ltb_spec 0 (- x)), (Z.eqb_spec x 0), (Z.eqb_spec (- x) 0), (Z.ltb_spec 0 y),
  (Z.ltb_spec 0 (- y)); simpl; try lia; subst; nia. Qed.

Lemma rounding_back a b : rounding b a = - rounding a b.
Proof.
  destruct a as (v, ((i, j), k)), b as (w, ((l, m), n)). unfold rounding, under, exact_under.
  assert (E := half_under_back (m - j) (n - k)). replace (- (m - j))%Z with (j - m)%Z in E by ring. replace (- (n - k))%Z with (k - n)%Z in E by ring.
  assert (E' : IZR (half_under (j - m) (k - n)) = (IZR m - IZR j) * (IZR n - IZR k) - IZR (half_under (m - j) (n - k))).
  { rewrite <- !minus_IZR, <- mult_IZR, <- minus_IZR. f_equal. lia. }
  rewrite !plus_IZR, !mult_IZR, !minus_IZR, E'. ring.
Qed.

Lemma rounding_moved t a b : rounding (moved_3 t a) (moved_3 t b) = rounding a b.
Proof.
  destruct t as ((t1, t2), t3), a as (v, ((i, j), k)), b as (w, ((l, m), n)). unfold rounding, under, exact_under, moved_3.
  replace (t2 + m - (t2 + j))%Z with (m - j)%Z by ring. replace (t3 + n - (t3 + k))%Z with (n - k)%Z by ring.
  rewrite !plus_IZR, !mult_IZR, !minus_IZR, !plus_IZR. ring.
Qed.

Definition wide (f : site_3 -> site_3 -> R) (a b : site_3) : R := (first_of a + first_of b) * f a b.
Definition wedge_of (s : facet_3) : R := let '(a, b, c) := s in (first_of a + first_of b + first_of c) * around exact_under s.

Lemma around_turned f s s' : turned_facet s s' -> around f s' = around f s.
Proof. intros []; unfold around; ring. Qed.
Lemma wedge_turned s s' : turned_facet s s' -> wedge_of s' = wedge_of s.
Proof. intros []; unfold wedge_of, around; ring. Qed.

Lemma sum_by_pairs (g : facet_3 -> R) T l pairs : (forall s s', turned_facet s s' -> g s' = g s) ->
  Forall2 turned_facet (flat_map facets_3 T) l -> Permutation l (flat_map both_sides_3 pairs) ->
  sum (fun c => sum g (facets_3 c)) T = sum (fun k => sum g (both_sides_3 k)) pairs.
Proof.
  intros Turned F P. rewrite <- !sum_flat_map, <- (sum_permutation g _ _ P). clear P. induction F as [|s s' k k' H F IH]; simpl; [reflexivity|].
  now rewrite IH, (Turned s s' H).
Qed.

Lemma first_moved t a : first_of (moved_3 t a) = IZR (fst (fst t)) + first_of a.
Proof. destruct t as ((t1, t2), t3), a as (v, ((i, j), k)). simpl. apply plus_IZR. Qed.

Lemma rounding_cell c : sum (around (wide rounding)) (facets_3 c) = 0.
Proof.
  destruct c as (((a, b), c), d). cbn [facets_3 sum around]. unfold wide.
  rewrite (rounding_back c d), (rounding_back b d), (rounding_back c b), (rounding_back a d), (rounding_back c a), (rounding_back b a). ring_simplify.
  rewrite ?(rounding_back a c), ?(rounding_back a b). ring.
Qed.

Lemma rounding_pair k : sum (around (wide rounding)) (both_sides_3 k) = -2 * (IZR (fst (fst (snd k))) * around rounding (fst k)).
Proof.
  destruct k as (((a, b), c), t). cbn [both_sides_3 sum around fst snd]. unfold wide. rewrite !first_moved, !rounding_moved.
  rewrite (rounding_back a b), (rounding_back b c), (rounding_back c a). ring.
Qed.

Lemma wedge_pair k : sum wedge_of (both_sides_3 k) = -3 * (IZR (fst (fst (snd k))) * around exact_under (fst k)).
Proof.
  destruct k as ((((v, ((a1, a2), a3)), (w, ((b1, b2), b3))), (u, ((c1, c2), c3))), ((t1, t2), t3)). unfold wedge_of, around, exact_under. simpl.
  rewrite !plus_IZR. ring.
Qed.

Lemma wedge_cell c : IZR (offset_volume c) = - sum wedge_of (facets_3 c).
Proof.
  destruct c as ((((v, ((a1, a2), a3)), (w, ((b1, b2), b3))), (u, ((c1, c2), c3))), (n, ((d1, d2), d3))).
  unfold wedge_of, around, exact_under, offset_volume, offset_less, offset_det.
  cbn [facets_3 sum first_of]. rewrite !plus_IZR, !mult_IZR, !minus_IZR, !mult_IZR, !minus_IZR. ring.
Qed.

Lemma whole_sum {S : Type} (f : S -> Z) l : exists n, sum (fun s => IZR (f s)) l = IZR n.
Proof. induction l as [|s l (n & E)]; [now exists 0%Z|]. exists (f s + n)%Z. simpl. now rewrite E, plus_IZR. Qed.

Theorem covers_six T : glued_torus_3 T -> exists N, covers_3 T = (6 * N)%Z.
Proof.
  intros (l & pairs & F & P).
  assert (Z : sum (fun k => -2 * (IZR (fst (fst (snd k))) * around rounding (fst k))) pairs = 0).
  { rewrite (sum_ext _ (fun k => sum (around (wide rounding)) (both_sides_3 k))) by (intros; now rewrite rounding_pair).
    rewrite <- (sum_by_pairs _ T l pairs (around_turned _) F P), (sum_ext _ (fun _ => 0)) by (intros; apply rounding_cell). apply sum_zero. }
  assert (C : IZR (covers_3 T) = 3 * sum (fun k => IZR (fst (fst (snd k))) * around exact_under (fst k)) pairs).
  { replace 3 with (-1 * -3) by ring. rewrite Rmult_assoc, <- sum_scale, (sum_ext _ (fun k => sum wedge_of (both_sides_3 k))) by (intros;
    now rewrite wedge_pair).
    rewrite <- (sum_by_pairs _ T l pairs wedge_turned F P). clear. induction T as [|c T IH]; [simpl; ring|]. cbn [covers_3 sum].
    rewrite plus_IZR, IH, wedge_cell. ring. }
  destruct (whole_sum (fun k : facet_3 * offset_3 => let '((a, b, c), t) := k in (fst (fst t) * (under a b + under b c + under c a))%Z) pairs) as (N & E).
  assert (D : sum (fun k => IZR (fst (fst (snd k))) * around exact_under (fst k)) pairs
    = 2 * IZR N + -1 * sum (fun k => IZR (fst (fst (snd k))) * around rounding (fst k)) pairs).
  { rewrite <- E, <- !sum_scale, <- sum_plus. apply sum_ext. intros (((a, b), c), t) _. unfold around, rounding. cbn [fst snd].
    rewrite mult_IZR, !plus_IZR. ring. }
  exists N. apply eq_IZR. rewrite mult_IZR, C, D. rewrite sum_scale in Z. lra.
Qed.
