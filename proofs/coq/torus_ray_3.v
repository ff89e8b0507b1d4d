(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* A ray along the first vector of a periodic box of space, and one cell: docs/theory.md 8.3.

   - ray_cell    a ray in general position crosses the facets of a positive cell once, counted with signs, if it begins inside, and otherwise as often
                 outward as inward
   - ray_settles, ray_misses   it crosses no translates of a facet far behind, all or none of those far ahead in one row, and none in rows far aside
   - shadow_crossed            whether it does in a row is whether its shadow is in that of the facet, as torus_count.v counts it *)
Require Import Reals ZArith Lra Lia Psatz List.
From Annulus Require Import tetrahedron sums torus_2 torus_3.
From Annulus Require plane_mesh plane_crossings space_mesh space_crossings space_line torus_ranges.
From Annulus Require Import torus_frames_3 torus_powers_3.
Import ListNotations.
Open Scope R_scope.

Notation half := space_crossings.half.
Notation one_side := space_line.one_side.
Notation orient := space_mesh.orient.

Section placed.
Variables (x : nat -> vec) (L : box_3).
Hypothesis box_positive : 0 < det_3 L.
Notation spot := (site_at_3 x L).
Notation weight := (weight x L).
Notation places := (places x L).
Notation six_of := (six_of x L).

Definition across (y a b : vec) : R := vol (L1 L) (a ⊖ y) (b ⊖ y).
(* How fast one gets inward along the ray. *)
Definition lean (a b c : vec) : R := vol (b ⊖ a) (c ⊖ a) (L1 L).
Definition hits (y a b c : vec) : R := one_side (across y a b) (across y b c) (across y c a).
Definition ray (y a b c : vec) : R := hits y a b c * (half (orient a b c y) - half (lean a b c)).
Definition ray_of (y : vec) (s : facet_3) : R := let '(a, b, c) := s in ray y (spot a) (spot b) (spot c).

Lemma across_back y a b : across y b a = - across y a b.
Proof. unfold across. generalize (L1 L). vector. Qed.

Lemma ray_back y a b c : ray y b a c = - ray y a b c.
Proof.
  unfold ray, hits. rewrite (across_back y a b), (across_back y c a), (across_back y b c), space_crossings.one_side_neg, space_crossings.one_side_turned.
  rewrite space_mesh.orient_swap. replace (lean b a c) with (- lean a b c) by (unfold lean; generalize (L1 L); vector).
  rewrite !space_crossings.half_opp. ring.
Qed.

Lemma ray_turn y a b c : ray y b c a = ray y a b c.
Proof.
  unfold ray, hits. replace (orient b c a y) with (orient a b c y) by (unfold orient; vector).
  replace (lean b c a) with (lean a b c) by (unfold lean; generalize (L1 L); vector). f_equal.
  rewrite (space_crossings.one_side_turn (across y a b)). now rewrite space_crossings.one_side_turned.
Qed.

Lemma ray_of_turned y s s' : turned_facet s s' -> ray_of y s' = ray_of y s.
Proof. intros []; unfold ray_of; [reflexivity|apply ray_turn|symmetry; apply ray_turn]. Qed.

(* ---- One cell ---- *)

Definition generic_edges (y : vec) (s : facet_3) : Prop := let '(a, b, c) := s in
  across y (spot a) (spot b) <> 0 /\ across y (spot b) (spot c) <> 0 /\ across y (spot c) (spot a) <> 0.
Definition leans (s : facet_3) : Prop := let '(a, b, c) := s in lean (spot a) (spot b) (spot c) <> 0.
Definition generic_ray (y : vec) (r : torus_cell_3) : Prop := (forall i, weight r y i <> 0) /\ forall s, In s (facets_3 r) -> generic_edges y s.

Definition lean_at (r : torus_cell_3) (i : corner) : R := let '(a, b, c, _) := view_at r i in lean (spot a) (spot b) (spot c).

Lemma weight_ahead r y k i : weight r (y ⊕ k ⊙ L1 L) i = weight r y i + k * lean_at r i.
Proof.
  destruct r as (((a, b), c), d). unfold torus_powers_3.weight, space_crossings.bary, lean_at, t0, lean.
  destruct i; cbn [space_crossings.side_of space_mesh.facet_height torus_powers_3.places view_at]; unfold orient;
    generalize (spot a) (spot b) (spot c) (spot d) (L1 L); vector.
Qed.

Lemma far_enough (b e : R) : e <> 0 -> exists k0, forall k, k0 <= k -> 0 < k -> half (b + k * e) = half e /\ (0 < b + k * e <-> 0 < e) /\ b + k * e <> 0.
Proof.
  intro N. exists (Rabs b / Rabs e + 1). intros k K P. assert (Pe := Rabs_pos_lt e N). assert (Q : Rabs b < k * Rabs e).
  { apply Rlt_le_trans with ((Rabs b / Rabs e + 1) * Rabs e); [|apply Rmult_le_compat_r; lra].
    replace ((Rabs b / Rabs e + 1) * Rabs e) with (Rabs b + Rabs e) by (field; lra). lra. }
  assert (B1 := Rle_abs b). assert (B2 := Rle_abs (- b)). rewrite Rabs_Ropp in B2.
  destruct (Rdichotomy _ _ N) as [M|M].
  - rewrite (Rabs_left e M) in Q. assert (S : b + k * e < 0) by lra. split; [|split; [split; intro; lra|lra]].
    rewrite !space_crossings.half_nonzero by lra. unfold space_line.pos. destruct (Rlt_dec 0 (b + k * e)), (Rlt_dec 0 e); lra.
  - rewrite (Rabs_pos_eq e) in Q by lra. assert (S : 0 < b + k * e) by lra. split; [|split; [split; intro; lra|lra]].
    rewrite !space_crossings.half_nonzero by lra. unfold space_line.pos. destruct (Rlt_dec 0 (b + k * e)), (Rlt_dec 0 e); lra.
Qed.

Lemma line_ahead y k a b c : 0 < k -> let p := y ⊕ k ⊙ L1 L in one_side (orient p y a b) (orient p y b c) (orient p y c a) = hits y a b c.
Proof.
  intros K p. assert (E : forall a b, orient p y a b = - (k * across y a b)) by (intros; unfold p, across, orient; generalize (L1 L); vector).
  rewrite !E, space_crossings.one_side_neg. now apply space_crossings.one_side_scale.
Qed.

Lemma ray_cell y r : 0 < six_of r -> generic_ray y r -> (forall s, In s (facets_3 r) -> leans s) ->
  sum (ray_of y) (facets_3 r) = space_line.inside_all (weight r y).
Proof.
  intros P [G E] N. assert (Nl : forall i, lean_at r i <> 0).
  { intro i. destruct r as (((a, b), c), d). destruct i; [apply (N (b, d, c))|apply (N (a, c, d))|apply (N (a, d, b))|apply (N (a, b, c))]; simpl; tauto. }
  destruct (far_enough (weight r y o) _ (Nl o)) as (ko & Ko). destruct (far_enough (weight r y u) _ (Nl u)) as (ku & Ku).
  destruct (far_enough (weight r y v) _ (Nl v)) as (kv & Kv). destruct (far_enough (weight r y w) _ (Nl w)) as (kw & Kw).
  set (k := Rmax 1 (Rmax (Rmax ko ku) (Rmax kv kw))).
  assert (M1 := Rmax_l 1 (Rmax (Rmax ko ku) (Rmax kv kw))). assert (M2 := Rmax_r 1 (Rmax (Rmax ko ku) (Rmax kv kw))). fold k in M1, M2.
  assert (M3 := Rmax_l (Rmax ko ku) (Rmax kv kw)). assert (M4 := Rmax_r (Rmax ko ku) (Rmax kv kw)).
  assert (M5 := Rmax_l ko ku). assert (M6 := Rmax_r ko ku). assert (M7 := Rmax_l kv kw). assert (M8 := Rmax_r kv kw).
  assert (Far : forall i, half (weight r y i + k * lean_at r i) = half (lean_at r i) /\ (0 < weight r y i + k * lean_at r i <-> 0 < lean_at r i) /\
    weight r y i + k * lean_at r i <> 0) by (intros []; [apply Ko|apply Ku|apply Kv|apply Kw]; lra).
  clear Ko Ku Kv Kw M3 M4 M5 M6 M7 M8 M2. assert (Pk : 0 < k) by lra. set (p := y ⊕ k ⊙ L1 L). assert (W := fun i => weight_ahead r y k i). fold p in W.
  assert (Out : space_line.inside_all (weight r p) = 0).
  { assert (T : lean_at r o + lean_at r u + lean_at r v + lean_at r w = 0).
    { assert (A := space_crossings.bary_total (places r) t0 p). assert (B := space_crossings.bary_total (places r) t0 y). rewrite <- B in A.
      change (weight r p o + weight r p u + weight r p v + weight r p w = weight r y o + weight r y u + weight r y v + weight r y w) in A.
      rewrite !W in A. nra. }
    assert (Q : exists i, lean_at r i < 0).
    { assert (No := Nl o). assert (Nu := Nl u). assert (Nv := Nl v). assert (Nw := Nl w).
      destruct (Rlt_dec (lean_at r o) 0); [now exists o|]. destruct (Rlt_dec (lean_at r u) 0); [now exists u|].
      destruct (Rlt_dec (lean_at r v) 0); [now exists v|].
      exists w. assert (0 < lean_at r o) by lra. lra. }
    destruct Q as (i & Q). destruct (Far i) as (_ & F & _). unfold space_line.inside_all.
    assert (Z : space_line.pos (weight r p i) = 0) by (rewrite W; unfold space_line.pos; destruct (Rlt_dec 0 _); [apply F in r0; lra|reflexivity]).
    destruct i; rewrite Z; ring. }
  assert (Gp : space_crossings.general_position (places r) t0 p y).
  { split; [intro i; change (weight r p i <> 0); rewrite W; apply Far|]. split; [exact G|].
    assert (Edge : forall a b, (exists c, In (a, b, c) (facets_3 r) \/ In (b, c, a) (facets_3 r) \/ In (c, a, b) (facets_3 r)) ->
    orient p y (spot a) (spot b) <> 0).
    { intros a b K. replace (orient p y (spot a) (spot b)) with (- (k * across y (spot a) (spot b))) by (unfold p, across, orient; generalize (L1 L)
      (spot a) (spot b); vector).
      assert (across y (spot a) (spot b) <> 0) by (destruct K as (c & [K|[K|K]]); destruct (E _ K) as (K1 & K2 & K3); assumption).
      apply Ropp_neq_0_compat, Rmult_integral_contrapositive_currified; lra. }
    destruct r as (((a, b), c), d). unfold torus_frames_3.six_of in P.
    destruct (space_crossings.at_edges (spot a) (spot b) (spot c) (spot d) p y) as (OU & OV & OW & UV & UW & VW).
    assert (S : orient (spot a) (spot b) (spot c) (spot d) <> 0) by (change (0 < orient (spot a) (spot b) (spot c) (spot d)) in P; lra).
    assert (Ne : forall e f q, q = - (orient (spot a) (spot b) (spot c) (spot d) * orient p y (spot e) (spot f)) -> orient p y (spot e)
    (spot f) <> 0 -> q <> 0)
      by (intros e f q -> K; apply Ropp_neq_0_compat, Rmult_integral_contrapositive_currified; assumption).
    assert (Eou : space_line.order (weight (a, b, c, d) p) (weight (a, b, c, d) y) o u <> 0) by (apply (Ne d c _ OU), Edge; exists b; simpl; tauto).
    assert (Eov : space_line.order (weight (a, b, c, d) p) (weight (a, b, c, d) y) o v <> 0) by (apply (Ne b d _ OV), Edge; exists c; simpl; tauto).
    assert (Eow : space_line.order (weight (a, b, c, d) p) (weight (a, b, c, d) y) o w <> 0) by (apply (Ne c b _ OW), Edge; exists d; simpl; tauto).
    assert (Euv : space_line.order (weight (a, b, c, d) p) (weight (a, b, c, d) y) u v <> 0) by (apply (Ne d a _ UV), Edge; exists c; simpl; tauto).
    assert (Euw : space_line.order (weight (a, b, c, d) p) (weight (a, b, c, d) y) u w <> 0) by (apply (Ne a c _ UW), Edge; exists d; simpl; tauto).
    assert (Evw : space_line.order (weight (a, b, c, d) p) (weight (a, b, c, d) y) v w <> 0) by (apply (Ne b a _ VW), Edge; exists d; simpl; tauto).
    intros i j Dij. change (space_line.order (weight (a, b, c, d) p) (weight (a, b, c, d) y) i j <> 0).
    destruct i, j; try congruence; rewrite space_line.order_swap; apply Ropp_neq_0_compat; assumption. }
  assert (C := space_crossings.cell_steps (places r) t0 p y). rewrite size_is in C. specialize (C P Gp).
  change (space_crossings.bary (places r) t0 y) with (weight r y) in C. change (space_crossings.bary (places r) t0 p) with (weight r p) in C.
  rewrite Out, Rminus_0_r in C.
  rewrite <- C. assert (Wo := W o). assert (Wu := W u). assert (Wv := W v). assert (Ww := W w).
  destruct (Far o) as (Fo & _), (Far u) as (Fu & _), (Far v) as (Fv & _), (Far w) as (Fw & _). rewrite <- Wo in Fo. rewrite <- Wu in Fu.
  rewrite <- Wv in Fv. rewrite <- Ww in Fw.
  destruct r as (((a, b), c), d). cbn [facets_3 sum ray_of]. unfold t0. cbn [space_mesh.sides sum]. unfold space_crossings.step_3, space_crossings.line.
  cbn [torus_powers_3.places]. unfold ray, p. rewrite !(line_ahead y k) by exact Pk.
  change (half (orient (spot b) (spot d) (spot c) p) = half (lean (spot b) (spot d) (spot c))) in Fo.
  change (half (orient (spot a) (spot c) (spot d) p) = half (lean (spot a) (spot c) (spot d))) in Fu.
  change (half (orient (spot a) (spot d) (spot b) p) = half (lean (spot a) (spot d) (spot b))) in Fv.
  change (half (orient (spot a) (spot b) (spot c) p) = half (lean (spot a) (spot b) (spot c))) in Fw.
  fold p. unfold space_mesh.facet_height. cbv beta iota. now rewrite Fo, Fu, Fv, Fw.
Qed.

(* ---- Rows of translates ---- *)

Definition translate (t : offset_3) (s : facet_3) : facet_3 := let '(a, b, c) := s in (moved_3 t a, moved_3 t b, moved_3 t c).
Definition hits_of (y : vec) (s : facet_3) : R := let '(a, b, c) := s in hits y (spot a) (spot b) (spot c).
Definition lean_of (s : facet_3) : R := let '(a, b, c) := s in lean (spot a) (spot b) (spot c).
(* Places in the box, times its volume. *)
Definition first_place (p : vec) : R := vol p (L2 L) (L3 L).
Definition second_place (p : vec) : R := vol (L1 L) p (L3 L).
Definition third_place (p : vec) : R := vol (L1 L) (L2 L) p.
Definition within_reach_3 (y : vec) (m : Z) (s : site_3) : Prop :=
  Rabs (first_place (y ⊖ spot s)) <= IZR m * det_3 L /\ Rabs (second_place (y ⊖ spot s)) <= IZR m * det_3 L /\
  Rabs (third_place (y ⊖ spot s)) <= IZR m * det_3 L.

Lemma place_moved t s y : first_place (y ⊖ spot (moved_3 t s)) = first_place (y ⊖ spot s) - IZR (fst (fst t)) * det_3 L /\
  second_place (y ⊖ spot (moved_3 t s)) = second_place (y ⊖ spot s) - IZR (snd (fst t)) * det_3 L /\
  third_place (y ⊖ spot (moved_3 t s)) = third_place (y ⊖ spot s) - IZR (snd t) * det_3 L.
Proof.
  rewrite site_moved. destruct t as ((i, j), k). unfold first_place, second_place, third_place, det_3, lattice_3. cbn [fst snd].
  generalize (spot s) (L1 L) (L2 L) (L3 L). repeat split; vector.
Qed.

Lemma across_moved i j k a b y : across y (spot (moved_3 (i, j, k) a)) (spot (moved_3 (i, j, k) b)) = across y (spot (moved_3 (0%Z, j, k) a))
  (spot (moved_3 (0%Z, j, k) b)).
Proof. rewrite !site_moved. unfold across, lattice_3. generalize (spot a) (spot b) (L1 L) (L2 L) (L3 L). vector. Qed.

Lemma lean_moved t s : lean_of (translate t s) = lean_of s.
Proof. destruct s as ((a, b), c). unfold lean_of, translate, lean. rewrite !site_moved. generalize (lattice_3 L t) (spot a) (spot b) (spot c)
  (L1 L). vector. Qed.

Lemma hits_moved y i j k s : hits_of y (translate (i, j, k) s) = hits_of y (translate (0%Z, j, k) s).
Proof. destruct s as ((a, b), c). unfold hits_of, translate, hits. now rewrite (across_moved i j k a b), (across_moved i j k b c), (across_moved i j k c a). Qed.

Lemma hits_cases y a b c : hits y a b c = 0 \/ (hits y a b c = 1 /\ ((0 < across y a b /\ 0 < across y b c /\ 0 < across y c a) \/
  (across y a b < 0 /\ across y b c < 0 /\ across y c a < 0))).
Proof.
  unfold hits, space_line.one_side. repeat match goal with |- context [Rlt_dec ?p ?q] => destruct (Rlt_dec p q) end; tauto.
Qed.

Lemma lean_is y a b c : lean a b c = across y a b + across y b c + across y c a.
Proof. unfold lean, across. generalize (L1 L). vector. Qed.

Lemma height_by_places y a b c : det_3 L * orient a b c y
  = across y b c * first_place (y ⊖ a) + across y c a * first_place (y ⊖ b) + across y a b * first_place (y ⊖ c).
Proof. unfold det_3, first_place, across, orient. generalize (L1 L) (L2 L) (L3 L). vector. Qed.

Lemma aside_by_places y a b c :
  across y b c * second_place (y ⊖ a) + across y c a * second_place (y ⊖ b) + across y a b * second_place (y ⊖ c) = 0 /\
  across y b c * third_place (y ⊖ a) + across y c a * third_place (y ⊖ b) + across y a b * third_place (y ⊖ c) = 0.
Proof. unfold second_place, third_place, across. generalize (L1 L) (L2 L) (L3 L). split; vector. Qed.

(* A side of all three corners. *)
Lemma same_side p q r a b c : (0 < p /\ 0 < q /\ 0 < r) \/ (p < 0 /\ q < 0 /\ r < 0) -> 0 < a /\ 0 < b /\ 0 < c -> q * a + r * b + p * c <> 0 /\
  (0 < q * a + r * b + p * c <-> 0 < p + q + r).
Proof.
  intros [(P & Q & S)|(P & Q & S)] (A & B & C).
  - assert (0 < q * a) by now apply Rmult_lt_0_compat. assert (0 < r * b) by now apply Rmult_lt_0_compat.
    assert (0 < p * c) by now apply Rmult_lt_0_compat. split; [lra|split; lra].
  - assert (0 < - q * a) by (apply Rmult_lt_0_compat; lra). assert (0 < - r * b) by (apply Rmult_lt_0_compat; lra).
    assert (0 < - p * c) by (apply Rmult_lt_0_compat; lra). split; [lra|split; lra].
Qed.

Lemma half_sign a b : a <> 0 -> (0 < a <-> 0 < b) -> b <> 0 -> half a = half b.
Proof.
  intros A S B. rewrite !space_crossings.half_nonzero by assumption. unfold space_line.pos. destruct (Rlt_dec 0 a), (Rlt_dec 0 b); lra || tauto.
Qed.

Lemma ray_settles y m s : (forall c, In c [fst (fst s); snd (fst s); snd s] -> within_reach_3 y m c) -> leans s ->
  forall j k, torus_ranges.settles m (fun i => ray_of y (translate (i, j, k) s)) (- (hits_of y (translate (0%Z, j, k) s) * (2 * half (lean_of s)))).
Proof.
  destruct s as ((a, b), c). cbn [fst snd]. intros W N j k i. set (s := (a, b, c)) in *.
  assert (H := hits_moved y i j k s). assert (Le := lean_moved (i, j, k) s). rewrite <- H.
  assert (Ra := proj1 (W a ltac:(simpl; tauto))). assert (Rb := proj1 (W b ltac:(simpl; tauto))). assert (Rc := proj1 (W c ltac:(simpl; tauto))).
  assert (Pa := proj1 (place_moved (i, j, k) a y)). assert (Pb := proj1 (place_moved (i, j, k) b y)). assert (Pc := proj1 (place_moved (i, j, k) c y)).
  cbn [fst snd] in Pa, Pb, Pc. unfold s, hits_of, lean_of, ray_of, translate, leans in *. unfold ray.
  set (A := spot (moved_3 (i, j, k) a)) in *. set (B := spot (moved_3 (i, j, k) b)) in *. set (C := spot (moved_3 (i, j, k) c)) in *.
  assert (E := height_by_places y A B C). assert (F := lean_is y A B C). rewrite Pa, Pb, Pc in E.
  assert (B1 := Rle_abs (first_place (y ⊖ spot a))). assert (B2 := Rle_abs (- first_place (y ⊖ spot a))). rewrite Rabs_Ropp in B2.
  assert (B3 := Rle_abs (first_place (y ⊖ spot b))). assert (B4 := Rle_abs (- first_place (y ⊖ spot b))). rewrite Rabs_Ropp in B4.
  assert (B5 := Rle_abs (first_place (y ⊖ spot c))). assert (B6 := Rle_abs (- first_place (y ⊖ spot c))). rewrite Rabs_Ropp in B6.
  rewrite <- Le in N |- *. destruct (hits_cases y A B C) as [Z|(Z & S)]; [rewrite Z; split; intro; ring|]. rewrite Z.
  split; intro I; apply IZR_lt in I; try rewrite opp_IZR in I.
  - assert (G : 0 < first_place (y ⊖ spot a) - IZR i * det_3 L /\ 0 < first_place (y ⊖ spot b) - IZR i * det_3 L /\
    0 < first_place (y ⊖ spot c) - IZR i * det_3 L).
    { assert (IZR m * det_3 L < - (IZR i * det_3 L)) by nra. lra. }
    destruct (same_side _ _ _ _ _ _ S G) as (G1 & G2). rewrite <- E in G1, G2. rewrite <- F in G2.
    rewrite (half_sign (orient A B C y) (lean A B C)); [ring| |split; intro K|exact N].
    + intro K. apply G1. rewrite K. ring.
    + apply G2. now apply Rmult_lt_0_compat.
    + apply G2 in K. apply Rmult_lt_reg_l with (det_3 L); [exact box_positive|]. now rewrite Rmult_0_r.
  - assert (G : 0 < - (first_place (y ⊖ spot a) - IZR i * det_3 L) /\ 0 < - (first_place (y ⊖ spot b) - IZR i * det_3 L) /\
      0 < - (first_place (y ⊖ spot c) - IZR i * det_3 L)).
    { assert (IZR m * det_3 L < IZR i * det_3 L) by nra. lra. }
    destruct (same_side _ _ _ _ _ _ S G) as (G1 & G2). rewrite <- F in G2.
    assert (E' : det_3 L * - orient A B C y = across y B C * - (first_place (y ⊖ spot a) - IZR i * det_3 L) +
    across y C A * - (first_place (y ⊖ spot b) - IZR i * det_3 L)
      + across y A B * - (first_place (y ⊖ spot c) - IZR i * det_3 L)) by lra.
    rewrite <- E' in G1, G2. assert (Hs : half (- orient A B C y) = half (lean A B C)).
    { apply half_sign; [|split; intro K|exact N].
      + intro K. apply G1. rewrite K. ring.
      + apply G2. now apply Rmult_lt_0_compat.
      + apply G2 in K. apply Rmult_lt_reg_l with (det_3 L); [exact box_positive|]. now rewrite Rmult_0_r. }
    rewrite space_crossings.half_opp in Hs. lra.
Qed.

Lemma ray_misses y m s j k : (forall c, In c [fst (fst s); snd (fst s); snd s] -> within_reach_3 y m c) ->
  (m < Z.abs j \/ m < Z.abs k)%Z -> hits_of y (translate (0%Z, j, k) s) = 0.
Proof.
  destruct s as ((a, b), c). cbn [fst snd]. intros W Far. unfold hits_of, translate.
  destruct (W a ltac:(simpl; tauto)) as (_ & Ra & Ta). destruct (W b ltac:(simpl; tauto)) as (_ & Rb & Tb).
  destruct (W c ltac:(simpl; tauto)) as (_ & Rc & Tc).
  destruct (place_moved (0%Z, j, k) a y) as (_ & Pa & Qa). destruct (place_moved (0%Z, j, k) b y) as (_ & Pb & Qb).
  destruct (place_moved (0%Z, j, k) c y) as (_ & Pc & Qc).
  cbn [fst snd] in *. set (A := spot (moved_3 (0%Z, j, k) a)) in *. set (B := spot (moved_3 (0%Z, j, k) b)) in *.
  set (C := spot (moved_3 (0%Z, j, k) c)) in *.
  destruct (hits_cases y A B C) as [Z|(_ & S)]; [exact Z|exfalso]. destruct (aside_by_places y A B C) as (E & F). rewrite Pa, Pb, Pc in E.
  rewrite Qa, Qb, Qc in F.
  assert (Out : forall p q r n, Rabs p <= IZR m * det_3 L -> Rabs q <= IZR m * det_3 L -> Rabs r <= IZR m * det_3 L -> (m < Z.abs n)%Z ->
    across y B C * (p - IZR n * det_3 L) + across y C A * (q - IZR n * det_3 L) + across y A B * (r - IZR n * det_3 L) <> 0).
  { intros p q r n Hp Hq Hr Hn. assert (B1 := Rle_abs p). assert (B2 := Rle_abs (- p)). rewrite Rabs_Ropp in B2. assert (B3 := Rle_abs q).
    assert (B4 := Rle_abs (- q)). rewrite Rabs_Ropp in B4. assert (B5 := Rle_abs r). assert (B6 := Rle_abs (- r)). rewrite Rabs_Ropp in B6.
    destruct (Z_lt_le_dec n 0) as [Ln|Ln].
    - assert (I : (m < - n)%Z) by lia. apply IZR_lt in I. rewrite opp_IZR in I. assert (IZR m * det_3 L < - (IZR n * det_3 L)) by nra.
      apply (same_side _ _ _ (p - IZR n * det_3 L) (q - IZR n * det_3 L) (r - IZR n * det_3 L) S). lra.
    - assert (I : (m < n)%Z) by lia. apply IZR_lt in I. assert (IZR m * det_3 L < IZR n * det_3 L) by nra.
      assert (G : 0 < - (p - IZR n * det_3 L) /\ 0 < - (q - IZR n * det_3 L) /\ 0 < - (r - IZR n * det_3 L)) by lra.
      assert (K := proj1 (same_side _ _ _ _ _ _ S G)). intro Q. apply K. lra. }
  destruct Far as [Far|Far]; [now apply (Out _ _ _ j Ra Rb Rc Far)|now apply (Out _ _ _ k Ta Tb Tc Far)].
Qed.
End placed.
