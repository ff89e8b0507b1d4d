(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* bridge.v for the vectors and terms in space: from differences up to 2^100 no operation overflows, and the terms in primitive floats stand for
   those in rounded reals.

   - orientation_terms_3_stand, bicell_stands   with a power of two above each term *)
From Coq Require Import Reals ZArith Lia Lra Bool.
From Flocq Require Import Core IEEE754.BinarySingleNaN IEEE754.PrimFloat.
From Coq Require Import Floats.
From Annulus Require Import operations bridge bridge_decide filter_2 filter_3.
Close Scope float_scope.
Open Scope R_scope.

(* ---- Vectors, all coordinates up to 2^a ---- *)

Definition stands_vector_3 (a : Z) (v : vector_3 machine) (w : vector_3 rounded) :=
  stands a (x3 _ v) (x3 _ w) /\ stands a (y3 _ v) (y3 _ w) /\ stands a (z3 _ v) (z3 _ w).

Lemma value_range_3 : value filter_range_3 = power 100.
Proof. exact (value_power filter_range_3 48 eq_refl). Qed.

Ltac each := split; [|split].   (* coordinate *)

Lemma vector_wider : forall a b v w, (a <= b)%Z -> stands_vector_3 a v w -> stands_vector_3 b v w.
Proof. intros a b v w H (A & B & C). each; now apply (stands_wider a b). Qed.

Lemma vector_plus : forall a v w v' w', (0 <= a < 1000)%Z -> stands_vector_3 a v v' -> stands_vector_3 a w w' ->
  stands_vector_3 (a + 1) (plus_3 machine v w) (plus_3 rounded v' w').
Proof. intros a v w v' w' H (A & B & C) (D & E & F). each; apply stands_add_same; trivial; lia. Qed.

Lemma vector_difference : forall a v w v' w', (0 <= a < 1000)%Z -> stands_vector_3 a v v' -> stands_vector_3 a w w' ->
  stands_vector_3 (a + 1) (difference_3 machine v w) (difference_3 rounded v' w').
Proof. intros a v w v' w' H (A & B & C) (D & E & F). each; apply stands_sub_same; trivial; lia. Qed.

Lemma vector_minus : forall a v v', stands_vector_3 a v v' -> stands_vector_3 a (minus_3 machine v) (minus_3 rounded v').
Proof. intros a v v' (A & B & C). each; now apply stands_opp. Qed.

Lemma vector_cross : forall a b v w v' w', (0 <= a)%Z -> (0 <= b)%Z -> (a + b < 1000)%Z -> stands_vector_3 a v v' -> stands_vector_3 b w w' ->
  stands_vector_3 (a + b + 1) (cross machine v w) (cross rounded v' w').
Proof.
  intros a b v w v' w' Ha Hb H (A & B & C) (D & E & F).
  each; apply stands_sub_same; try lia; apply stands_mul; trivial; lia.
Qed.

Lemma stands_dot : forall a b v w v' w', (0 <= a)%Z -> (0 <= b)%Z -> (a + b < 1000)%Z -> stands_vector_3 a v v' -> stands_vector_3 b w w' ->
  stands (a + b + 1 + 1) (dot machine v w) (dot rounded v' w').
Proof.
  intros a b v w v' w' Ha Hb H (A & B & C) (D & E & F). apply stands_add_same; [lia| |].
  - apply stands_add_same; [lia| |]; apply stands_mul; trivial; lia.
  - apply stands_wider with (a + b)%Z; [lia|]. apply stands_mul; trivial; lia.
Qed.

Lemma stands_square_3 : forall a v v', (0 <= a < 450)%Z -> stands_vector_3 a v v' ->
  stands (a + a + 2) (square_3 machine v) (square_3 rounded v') /\ 0 <= square_3 rounded v'.
Proof.
  intros a v v' H V. split.
  - replace (a + a + 2)%Z with (a + a + 1 + 1)%Z by lia. apply (stands_dot a a v v v' v'); trivial; lia.
  - assert (S : forall r, 0 <= rnd (r * r)) by (intro; apply rnd_nonneg, Rle_0_sqr).
    apply rnd_nonneg, Rplus_le_le_0_compat; [|apply S]. apply rnd_nonneg, Rplus_le_le_0_compat; apply S.
Qed.

Lemma vector_combination : forall a b r u s v t w r' u' s' v' t' w', (0 <= a)%Z -> (0 <= b)%Z -> (a + b < 1000)%Z ->
  stands a r r' -> stands_vector_3 b u u' -> stands a s s' -> stands_vector_3 b v v' -> stands a t t' -> stands_vector_3 b w w' ->
  stands_vector_3 (a + b + 1 + 1) (combination machine r u s v t w) (combination rounded r' u' s' v' t' w').
Proof.
  intros a b r u s v t w r' u' s' v' t' w' Ha Hb H R (U & U1 & U2) S (V & V1 & V2) T (W & W1 & W2).
  assert (K : forall i i' j j' k k', stands b i i' -> stands b j j' -> stands b k k' ->
    stands (a + b + 1 + 1) (r * i - s * j + t * k)%float (rnd (rnd (rnd (r' * i') - rnd (s' * j')) + rnd (t' * k')))).
  { intros i i' j j' k k' I J L. apply stands_add_same; [lia| |].
    - apply stands_sub_same; [lia| |]; apply stands_mul; trivial; lia.
    - apply stands_wider with (a + b)%Z; [lia|]. apply stands_mul; trivial; lia. }
  each; now apply K.
Qed.

Lemma vector_minus_twice : forall a b n l v n' l' v', (0 <= a)%Z -> (0 <= b)%Z -> (a + b < 1000)%Z ->
  stands_vector_3 (a + 1 + b) n n' -> stands a l l' -> stands_vector_3 b v v' ->
  stands_vector_3 (a + 1 + b + 1) (minus_twice machine n l v) (minus_twice rounded n' l' v').
Proof.
  intros a b n l v n' l' v' Ha Hb H (N & N1 & N2) L (V & V1 & V2).
  assert (K : forall i i' j j', stands (a + 1 + b) i i' -> stands b j j' ->
    stands (a + 1 + b + 1) (i - (l + l) * j)%float (rnd (i' - rnd (rnd (l' + l') * j')))).
  { intros i i' j j' I J. apply stands_sub_same; [lia|exact I|]. apply stands_mul; [lia| |exact J]. apply stands_add_same; trivial; lia. }
  each; now apply K.
Qed.

Lemma stands_slab : forall a u v w u' v' w', (0 <= a < 400)%Z -> stands_vector_3 a u u' -> stands_vector_3 a v v' -> stands_vector_3 a w w' ->
  stands (a + a + 6) (largest_slab machine u v w) (largest_slab rounded u' v' w') /\ 0 <= largest_slab rounded u' v' w'.
Proof.
  intros a u v w u' v' w' H U V W. unfold largest_slab. cbv zeta.
  pose proof (vector_plus a _ _ _ _ ltac:(lia) U V) as A. pose proof (vector_plus a _ _ _ _ ltac:(lia) V W) as B.
  pose proof (vector_plus a _ _ _ _ ltac:(lia) W U) as C.
  pose proof (vector_plus (a + 1) _ _ _ _ ltac:(lia) A (vector_wider a (a + 1) _ _ ltac:(lia) W)) as D.
  assert (S : forall b f g, (0 <= b <= a + 1 + 1)%Z -> stands_vector_3 b f g -> stands (a + a + 6) (square_3 machine f) (square_3 rounded g)).
  { intros b f g L F. apply stands_wider with (b + b + 2)%Z; [lia|]. now apply stands_square_3; [lia|]. }
  split.
  - repeat apply stands_max_same; (eapply S; [|eassumption]); lia.
  - apply Rle_trans with (2 := max_ge_l _ _). apply Rle_trans with (2 := max_ge_l _ _). apply Rle_trans with (2 := max_ge_l _ _).
    apply (stands_square_3 a u u'); trivial. lia.
Qed.

(* ---- The terms ---- *)

Lemma orientation_terms_3_stand : forall u v w u' v' w', stands_vector_3 100 u u' -> stands_vector_3 100 v v' -> stands_vector_3 100 w w' ->
  let t := orientation_terms_3 machine u v w in let t' := orientation_terms_3 rounded u' v' w' in
  stands 303 (determinant _ t) (determinant _ t') /\ stands 408 (inner _ t) (inner _ t') /\ 0 <= inner _ t'.
Proof.
  intros u v w u' v' w' U V W.
  pose proof (vector_cross 100 100 _ _ _ _ ltac:(lia) ltac:(lia) ltac:(lia) U V) as uv.
  pose proof (vector_cross 100 100 _ _ _ _ ltac:(lia) ltac:(lia) ltac:(lia) V W) as vw.
  pose proof (vector_cross 100 100 _ _ _ _ ltac:(lia) ltac:(lia) ltac:(lia) W U) as wu.
  split; [exact (stands_dot 201 100 _ _ _ _ ltac:(lia) ltac:(lia) ltac:(lia) uv W)|].
  exact (stands_slab 201 _ _ _ _ _ _ ltac:(lia) uv vw wu).
Qed.

Definition partition_stands (k : partition machine) (k' : partition rounded) :=
  (stands 818 (inner_3 _ k) (inner_3 _ k') /\ 0 <= inner_3 _ k') /\ (stands 818 (outer_3 _ k) (outer_3 _ k') /\ 0 <= outer_3 _ k') /\
  stands 306 (side _ k) (side _ k').

Section bicell.
Variables (b c p q : vector_3 machine) (b' c' p' q' : vector_3 rounded).
Hypothesis Hb : stands_vector_3 100 b b'.
Hypothesis Hc : stands_vector_3 100 c c'.
Hypothesis Hp : stands_vector_3 100 p p'.
Hypothesis Hq : stands_vector_3 100 q q'.
Let t := bicell machine b c p q.
Let t' := bicell rounded b' c' p' q'.

Lemma bicell_stands :
  stands 507 (insphere _ t) (insphere _ t') /\
  (partition_stands (abc_pq _ t) (abc_pq _ t') /\ partition_stands (ab_cpq _ t) (ab_cpq _ t') /\
   partition_stands (ca_bpq _ t) (ca_bpq _ t') /\ partition_stands (bc_apq _ t) (bc_apq _ t')) /\
  (stands 303 (cell_p _ t) (cell_p _ t') /\ stands 408 (cell_p_slab _ t) (cell_p_slab _ t') /\ 0 <= cell_p_slab _ t') /\
  (stands 303 (cell_q _ t) (cell_q _ t') /\ stands 408 (cell_q_slab _ t) (cell_q_slab _ t') /\ 0 <= cell_q_slab _ t').
Proof.
  pose proof (vector_cross 100 100 _ _ _ _ ltac:(lia) ltac:(lia) ltac:(lia) Hb Hc) as bc.
  pose proof (vector_cross 100 100 _ _ _ _ ltac:(lia) ltac:(lia) ltac:(lia) Hb Hp) as bp.
  pose proof (vector_cross 100 100 _ _ _ _ ltac:(lia) ltac:(lia) ltac:(lia) Hb Hq) as bq.
  pose proof (vector_cross 100 100 _ _ _ _ ltac:(lia) ltac:(lia) ltac:(lia) Hc Hp) as cp.
  pose proof (vector_cross 100 100 _ _ _ _ ltac:(lia) ltac:(lia) ltac:(lia) Hc Hq) as cq.
  pose proof (vector_cross 100 100 _ _ _ _ ltac:(lia) ltac:(lia) ltac:(lia) Hp Hq) as pq.
  destruct (stands_square_3 100 _ _ ltac:(lia) Hb) as [bb _]. destruct (stands_square_3 100 _ _ ltac:(lia) Hc) as [cc _].
  destruct (stands_square_3 100 _ _ ltac:(lia) Hp) as [pp _]. destruct (stands_square_3 100 _ _ ltac:(lia) Hq) as [qq _].
  pose proof (stands_dot 201 100 _ _ _ _ ltac:(lia) ltac:(lia) ltac:(lia) cp Hq) as lb.
  pose proof (stands_dot 201 100 _ _ _ _ ltac:(lia) ltac:(lia) ltac:(lia) bq Hp) as lc.
  pose proof (stands_dot 201 100 _ _ _ _ ltac:(lia) ltac:(lia) ltac:(lia) bc Hq) as lp.
  pose proof (stands_dot 201 100 _ _ _ _ ltac:(lia) ltac:(lia) ltac:(lia) bc Hp) as nq.
  pose proof (stands_add_same 506 _ _ _ _ ltac:(lia)
    (stands_add_same 505 _ _ _ _ ltac:(lia) (stands_mul 303 202 _ _ _ _ ltac:(lia) lb bb) (stands_mul 303 202 _ _ _ _ ltac:(lia) lc cc))
    (stands_sub_same 505 _ _ _ _ ltac:(lia) (stands_mul 303 202 _ _ _ _ ltac:(lia) lp pp) (stands_mul 303 202 _ _ _ _ ltac:(lia) nq qq))) as det.
  pose proof (vector_combination 202 201 _ _ _ _ _ _ _ _ _ _ _ _ ltac:(lia) ltac:(lia) ltac:(lia) bb cq cc bq qq bc) as up.
  pose proof (vector_combination 202 201 _ _ _ _ _ _ _ _ _ _ _ _ ltac:(lia) ltac:(lia) ltac:(lia) bb cp cc bp pp bc) as vq.
  pose proof (vector_combination 202 201 _ _ _ _ _ _ _ _ _ _ _ _ ltac:(lia) ltac:(lia) ltac:(lia) cc pq pp cq qq cp) as ub.
  pose proof (vector_combination 202 201 _ _ _ _ _ _ _ _ _ _ _ _ ltac:(lia) ltac:(lia) ltac:(lia) bb pq pp bq qq bp) as vc.
  assert (wide : forall f r, stands 303 f r -> stands 304 f r) by (intros; apply stands_wider with 303%Z; [lia|assumption]).
  assert (wide' : forall v w, stands_vector_3 405 v w -> stands_vector_3 406 v w) by (intros; apply vector_wider with 405%Z; [lia|assumption]).
  pose proof (stands_sub_same 303 _ _ _ _ ltac:(lia) lp nq) as l1. pose proof (vector_difference 405 _ _ _ _ ltac:(lia) up vq) as n1.
  pose proof (vector_minus_twice 305 100 _ _ _ _ _ _ ltac:(lia) ltac:(lia) ltac:(lia) n1 (stands_wider 304 305 _ _ ltac:(lia) l1) Hp) as m1.
  pose proof (stands_add_same 304 _ _ _ _ ltac:(lia) l1 (wide _ _ lc)) as l2.
  pose proof (vector_difference 406 _ _ _ _ ltac:(lia) n1 (wide' _ _ vc)) as n2.
  pose proof (vector_minus_twice 306 100 _ _ _ _ _ _ ltac:(lia) ltac:(lia) ltac:(lia) n2 (stands_wider 305 306 _ _ ltac:(lia) l2) Hc) as m2.
  pose proof (stands_add_same 304 _ _ _ _ ltac:(lia) l1 (wide _ _ lb)) as l3.
  pose proof (vector_plus 406 _ _ _ _ ltac:(lia) n1 (wide' _ _ ub)) as n3.
  pose proof (vector_minus_twice 306 100 _ _ _ _ _ _ ltac:(lia) ltac:(lia) ltac:(lia) n3 (stands_wider 305 306 _ _ ltac:(lia) l3) Hb) as m3.
  pose proof (stands_add_same 303 _ _ _ _ ltac:(lia) lb lc) as l4. pose proof (vector_difference 405 _ _ _ _ ltac:(lia) ub vc) as n4.
  pose proof (vector_minus_twice 305 100 _ _ _ _ _ _ ltac:(lia) ltac:(lia) ltac:(lia) n4 (stands_wider 304 305 _ _ ltac:(lia) l4) Hb) as m4.
  assert (Q : forall k v w, (0 <= k <= 408)%Z -> stands_vector_3 k v w ->
    stands 818 (square_3 machine v) (square_3 rounded w) /\ 0 <= square_3 rounded w).
  { intros k v w L V. apply (stands_square_3 408); [lia|]. now apply vector_wider with k. }
  assert (L : forall f r k, (k <= 306)%Z -> stands k f r -> stands 306 f r) by (intros; eapply stands_wider; eassumption).
  split; [exact det|]. split; [|split].
  - split; [|split; [|split]].
    + exact (conj (Q 406%Z _ _ ltac:(lia) n1) (conj (Q 407%Z _ _ ltac:(lia) m1) (L _ _ 304%Z ltac:(lia) l1))).
    + exact (conj (Q 407%Z _ _ ltac:(lia) n2) (conj (Q 408%Z _ _ ltac:(lia) m2) (L _ _ 305%Z ltac:(lia) l2))).
    + exact (conj (Q 407%Z _ _ ltac:(lia) n3) (conj (Q 408%Z _ _ ltac:(lia) m3) (L _ _ 305%Z ltac:(lia) l3))).
    + exact (conj (Q 407%Z _ _ ltac:(lia) m4) (conj (Q 406%Z _ _ ltac:(lia) n4) (stands_opp _ _ _ (L _ _ 304%Z ltac:(lia) l4)))).
  - split; [exact (stands_opp _ _ _ nq)|].
    exact (stands_slab 201 _ _ _ _ _ _ ltac:(lia) (vector_minus _ _ _ bc) bp (vector_minus _ _ _ cp)).
  - split; [exact lp|]. exact (stands_slab 201 _ _ _ _ _ _ ltac:(lia) bc cq (vector_minus _ _ _ bq)).
Qed.
End bicell.
