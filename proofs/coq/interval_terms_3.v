(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The terms of the code in space, over intervals (interval_2.v) and over reals: the intervals hold the reals.

   - tetrahedron_encloses, bicell_encloses *)
From Coq Require Import Reals List.
From Annulus Require Import operations filter_2 filter_3 interval_2 float_interval.
Import ListNotations.
Open Scope R_scope.

Definition holds_vector_3 (v : vector_3 intervals) (w : vector_3 reals) : Prop :=
  holds (x3 _ v) (x3 _ w) /\ holds (y3 _ v) (y3 _ w) /\ holds (z3 _ v) (z3 _ w).

Lemma h_plus v w v' w' : holds_vector_3 v v' -> holds_vector_3 w w' -> holds_vector_3 (plus_3 intervals v w) (plus_3 reals v' w').
Proof. intros (A & B & C) (D & E & F). split; [|split]; now apply holds_add. Qed.
Lemma h_difference v w v' w' : holds_vector_3 v v' -> holds_vector_3 w w' -> holds_vector_3 (difference_3 intervals v w) (difference_3 reals v' w').
Proof. intros (A & B & C) (D & E & F). split; [|split]; now apply holds_sub. Qed.
Lemma h_minus v v' : holds_vector_3 v v' -> holds_vector_3 (minus_3 intervals v) (minus_3 reals v').
Proof. intros (A & B & C). split; [|split]; now apply holds_opp. Qed.
Lemma h_cross v w v' w' : holds_vector_3 v v' -> holds_vector_3 w w' -> holds_vector_3 (cross intervals v w) (cross reals v' w').
Proof. intros (A & B & C) (D & E & F). split; [|split]; apply holds_sub; now apply holds_mul. Qed.
Lemma h_dot v w v' w' : holds_vector_3 v v' -> holds_vector_3 w w' -> holds (dot intervals v w) (dot reals v' w').
Proof. intros (A & B & C) (D & E & F). apply holds_add; [apply holds_add|]; now apply holds_mul. Qed.
Lemma h_square v v' : holds_vector_3 v v' -> holds (square_3 intervals v) (square_3 reals v').
Proof. intros (A & B & C). apply holds_add; [apply holds_add|]; now apply holds_square. Qed.
Lemma h_combination r u s v t w r' u' s' v' t' w' : holds r r' -> holds_vector_3 u u' -> holds s s' -> holds_vector_3 v v' -> holds t t' ->
  holds_vector_3 w w' -> holds_vector_3 (combination intervals r u s v t w) (combination reals r' u' s' v' t' w').
Proof.
  intros R (U & U1 & U2) S (V & V1 & V2) T (W & W1 & W2). split; [|split]; (apply holds_add; [apply holds_sub|]); now apply holds_mul.
Qed.
Lemma h_minus_twice v l a v' l' a' : holds_vector_3 v v' -> holds l l' -> holds_vector_3 a a' ->
  holds_vector_3 (minus_twice intervals v l a) (minus_twice reals v' l' a').
Proof. intros (V & V1 & V2) L (A & A1 & A2). split; [|split]; (apply holds_sub; [assumption|]); apply holds_mul; trivial; now apply holds_add. Qed.
Lemma h_slab u v w u' v' w' : holds_vector_3 u u' -> holds_vector_3 v v' -> holds_vector_3 w w' ->
  holds (largest_slab intervals u v w) (largest_slab reals u' v' w').
Proof.
  intros U V W. unfold largest_slab. cbv zeta. assert (A := h_plus _ _ _ _ U V). assert (B := h_plus _ _ _ _ V W). assert (C := h_plus _ _ _ _ W U).
  assert (D := h_plus _ _ _ _ A W). apply holds_max; apply holds_max; try apply holds_max; now apply h_square.
Qed.

Lemma tetrahedron_encloses u v w u' v' w' : holds_vector_3 u u' -> holds_vector_3 v v' -> holds_vector_3 w w' ->
  let t := orientation_terms_3 intervals u v w in let t' := orientation_terms_3 reals u' v' w' in
  holds (determinant _ t) (determinant _ t') /\ holds (inner _ t) (inner _ t') /\ holds (outer _ t) (outer _ t').
Proof.
  intros U V W. assert (uv := h_cross _ _ _ _ U V). assert (S := h_slab _ _ _ _ _ _ uv (h_cross _ _ _ _ V W) (h_cross _ _ _ _ W U)).
  split; [exact (h_dot _ _ _ _ uv W)|]. now split.
Qed.

Definition holds_partition (k : partition intervals) (k' : partition reals) : Prop :=
  holds (inner_3 _ k) (inner_3 _ k') /\ holds (outer_3 _ k) (outer_3 _ k') /\ holds (side _ k) (side _ k').

Section bicell.
Variables (b d p q : vector_3 intervals) (b' d' p' q' : vector_3 reals).
Hypothesis Hb : holds_vector_3 b b'.
Hypothesis Hc : holds_vector_3 d d'.
Hypothesis Hp : holds_vector_3 p p'.
Hypothesis Hq : holds_vector_3 q q'.
Let t := bicell intervals b d p q.
Let t' := bicell reals b' d' p' q'.

Lemma bicell_encloses : holds (insphere _ t) (insphere _ t') /\
  (holds_partition (abc_pq _ t) (abc_pq _ t') /\ holds_partition (ab_cpq _ t) (ab_cpq _ t') /\
   holds_partition (ca_bpq _ t) (ca_bpq _ t') /\ holds_partition (bc_apq _ t) (bc_apq _ t')) /\
  (holds (cell_p _ t) (cell_p _ t') /\ holds (cell_q _ t) (cell_q _ t')) /\
  (holds (cell_p_slab _ t) (cell_p_slab _ t') /\ holds (cell_q_slab _ t) (cell_q_slab _ t')).
Proof.
  assert (bc := h_cross _ _ _ _ Hb Hc). assert (bp := h_cross _ _ _ _ Hb Hp). assert (bq := h_cross _ _ _ _ Hb Hq).
  assert (cp := h_cross _ _ _ _ Hc Hp). assert (cq := h_cross _ _ _ _ Hc Hq). assert (pq := h_cross _ _ _ _ Hp Hq).
  assert (bb := h_square _ _ Hb). assert (cc := h_square _ _ Hc). assert (pp := h_square _ _ Hp). assert (qq := h_square _ _ Hq).
  assert (lb := h_dot _ _ _ _ cp Hq). assert (lc := h_dot _ _ _ _ bq Hp). assert (lp := h_dot _ _ _ _ bc Hq). assert (nq := h_dot _ _ _ _ bc Hp).
  assert (det := holds_add _ _ _ _ (holds_add _ _ _ _ (holds_mul _ _ _ _ lb bb) (holds_mul _ _ _ _ lc cc))
                                   (holds_sub _ _ _ _ (holds_mul _ _ _ _ lp pp) (holds_mul _ _ _ _ nq qq))).
  assert (up := h_combination _ _ _ _ _ _ _ _ _ _ _ _ bb cq cc bq qq bc). assert (vq := h_combination _ _ _ _ _ _ _ _ _ _ _ _ bb cp cc bp pp bc).
  assert (ub := h_combination _ _ _ _ _ _ _ _ _ _ _ _ cc pq pp cq qq cp). assert (vc := h_combination _ _ _ _ _ _ _ _ _ _ _ _ bb pq pp bq qq bp).
  assert (l1 := holds_sub _ _ _ _ lp nq). assert (n1 := h_difference _ _ _ _ up vq). assert (m1 := h_minus_twice _ _ _ _ _ _ n1 l1 Hp).
  assert (l2 := holds_add _ _ _ _ l1 lc). assert (n2 := h_difference _ _ _ _ n1 vc). assert (m2 := h_minus_twice _ _ _ _ _ _ n2 l2 Hc).
  assert (l3 := holds_add _ _ _ _ l1 lb). assert (n3 := h_plus _ _ _ _ n1 ub). assert (m3 := h_minus_twice _ _ _ _ _ _ n3 l3 Hb).
  assert (l4 := holds_add _ _ _ _ lb lc). assert (n4 := h_difference _ _ _ _ ub vc). assert (m4 := h_minus_twice _ _ _ _ _ _ n4 l4 Hb).
  split; [exact det|]. unfold holds_partition. repeat match goal with |- _ /\ _ => split end;
    first [exact (h_square _ _ n1)|exact (h_square _ _ m1)|exact (h_square _ _ n2)|exact (h_square _ _ m2)|exact (h_square _ _ n3)|exact (h_square _ _ m3)
          |exact (h_square _ _ m4)|exact (h_square _ _ n4)|exact l1|exact l2|exact l3|exact (holds_opp _ _ l4)|exact (holds_opp _ _ nq)|exact lp
          |exact (h_slab _ _ _ _ _ _ (h_minus _ _ bc) bp (h_minus _ _ cp))|exact (h_slab _ _ _ _ _ _ bc cq (h_minus _ _ bq))].
Qed.
End bicell.
