(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* A ridge of space whose determinant is 0, as the program looks at it: along an axis along which the plane of its facets has an area.

   - seen                 a point seen along an axis, as a point of the plane
   - flat_ridge_holds_3   degenerate.h: c and d are on different sides of the ridge u w, seen so
   - flat_ridge_right_3    which is that the border does not fold back there *)
From Coq Require Import Reals ZArith Lra List Bool Psatz.
From Coq Require Import Floats.
From Annulus Require Import points_2 operations connect filter_2 filter_3 stages returned_2 returned_3 interval_2 exact_2 exact_returned_2 plain_2 vectors space_mesh.
Import ListNotations.
Close Scope float_scope.
Open Scope R_scope.

Inductive axis := along_x | along_y | along_z.
Definition seen (i : axis) (p : vector_3 machine) : filter_2.vector machine :=
  match i with
  | along_x => Build_vector machine (y3 _ p) (z3 _ p)
  | along_y => Build_vector machine (z3 _ p) (x3 _ p)
  | along_z => Build_vector machine (x3 _ p) (y3 _ p)
  end.
(* The sign that the filtered predicate says when no tolerance is requested. *)
Definition side_sign (a b c : filter_2.vector machine) : Z :=
  match staged false (orientation_filter machine a b c false) (orientation_interval a b c) (orientation_exact a b c) with
  | negative _ => -1 | filter_2.positive _ => 1 | _ => 0
  end.
Fixpoint sides_differ (axes : list axis) (u w c d : vector_3 machine) : bool :=
  match axes with
  | [] => false
  | i :: others =>
      let s := side_sign (seen i u) (seen i w) (seen i c) in
      if (s =? 0)%Z then sides_differ others u w c d else (side_sign (seen i u) (seen i w) (seen i d) =? - s)%Z
  end.
Definition flat_ridge_holds_3 : vector_3 machine -> vector_3 machine -> vector_3 machine -> vector_3 machine -> bool :=
  sides_differ [along_x; along_y; along_z].

Definition coordinate_along (i : axis) (n : vec) : R := match i with along_x => X1 n | along_y => X2 n | along_z => X3 n end.

Lemma side_sign_right a b c : coordinates_2 a -> coordinates_2 b -> coordinates_2 c ->
  let t := turning (at_2 a) (at_2 b) (at_2 c) in
  (side_sign a b c = 0%Z /\ t = 0) \/ (side_sign a b c = 1%Z /\ 0 < t) \/ (side_sign a b c = (-1)%Z /\ t < 0).
Proof.
  intros A B C t. set (f := fun n => match n with 0%nat => a | 1%nat => b | _ => c end).
  assert (R := orientation_2_floating f 0%nat 1%nat 2%nat ltac:(intros v [<-|[<-|[<-|[]]]]; assumption)).
  destruct (orientation_exact_returned f 0%nat 1%nat 2%nat) as [_ N]. cbn [f] in R, N. change (turn_at _ _ _ _) with t in R.
  unfold side_sign. revert R. unfold staged, or_else, right_sign.
  destruct (orientation_filter machine a b c false); [|tauto..]. destruct (orientation_interval a b c); [|tauto..].
  destruct (orientation_exact a b c); [contradiction|tauto..].
Qed.

Lemma seen_coordinates i p : coordinates_3 p -> coordinates_2 (seen i p).
Proof. intros (X & Y & Z). destruct i; now split. Qed.
Lemma seen_turn i u w c : turning (at_2 (seen i u)) (at_2 (seen i w)) (at_2 (seen i c)) = coordinate_along i ((at_3 w ⊖ at_3 u) ✕ (at_3 c ⊖ at_3 u)).
Proof. destruct i; unfold turning, width_2.turn, at_2, at_3, seen; cbn; ring. Qed.

(* Normals of facets in one plane. *)
Lemma parallel i n k : n ✕ k = zero -> (n · k) * coordinate_along i n = sq n * coordinate_along i k.
Proof.
  destruct n as [a b c], k as [p q r]. unfold cross, zero. cbn. intro E. injection E as E1 E2 E3. unfold sq, dot. destruct i; cbn.
  - replace ((a * p + b * q + c * r) * a) with ((a * a + b * b + c * c) * p + b * (a * q - b * p) - c * (c * p - a * r)) by ring. rewrite E2, E3. ring.
  - replace ((a * p + b * q + c * r) * b) with ((a * a + b * b + c * c) * q - a * (a * q - b * p) + c * (b * r - c * q)) by ring. rewrite E1, E3. ring.
  - replace ((a * p + b * q + c * r) * c) with ((a * a + b * b + c * c) * r + a * (c * p - a * r) - b * (b * r - c * q)) by ring. rewrite E1, E2. ring.
Qed.

Lemma sides_differ_right u w c d axes : (forall p, In p [u; w; c; d] -> coordinates_3 p) ->
  let n := (at_3 w ⊖ at_3 u) ✕ (at_3 c ⊖ at_3 u) in let k := (at_3 w ⊖ at_3 u) ✕ (at_3 d ⊖ at_3 u) in n ✕ k = zero ->
  sides_differ axes u w c d = true <-> n · k < 0 /\ exists i, In i axes /\ coordinate_along i n <> 0.
Proof.
  intros D n k P. assert (U := D u ltac:(simpl; tauto)). assert (W := D w ltac:(simpl; tauto)). assert (C := D c ltac:(simpl; tauto)).
  assert (Q := D d ltac:(simpl; tauto)). induction axes as [|i axes IH]; cbn [sides_differ]; [split; [discriminate|now intros (_ & i & [] & _)]|].
  assert (S := side_sign_right _ _ _ (seen_coordinates i u U) (seen_coordinates i w W) (seen_coordinates i c C)).
  assert (S' := side_sign_right _ _ _ (seen_coordinates i u U) (seen_coordinates i w W) (seen_coordinates i d Q)).
  cbv zeta in S, S'. rewrite seen_turn in S, S'. fold n in S. fold k in S'. assert (E := parallel i n k P).
  destruct S as [[-> Z]|S]; cbn [Z.eqb].
  - rewrite IH. split; [intros (L & j & J & N); split; [exact L|exists j; split; [now right|exact N]]|].
    intros (L & j & [<-|J] & N); [contradiction|]. split; [exact L|]. now exists j.
  - assert (Pos : 0 < sq n).
    { apply sq_pos. intro O. rewrite O in S. destruct i; cbn in S; lra. }
    assert (H : n · k < 0 <-> side_sign (seen i u) (seen i w) (seen i d) = (- side_sign (seen i u) (seen i w) (seen i c))%Z).
    { destruct S as [[-> S]|[-> S]], S' as [[-> S']|[[-> S']|[-> S']]]; cbn; split; intro T; trivial; try discriminate T; nra. }
    replace ((side_sign (seen i u) (seen i w) (seen i c) =? 0)%Z) with false by (destruct S as [[-> _]|[-> _]]; reflexivity).
    rewrite Z.eqb_eq, H. split; [intro T; split; [exact T|]|tauto]. exists i. split; [now left|]. destruct S as [[_ S]|[_ S]]; lra.
Qed.

Theorem flat_ridge_right_3 u w c d : (forall p, In p [u; w; c; d] -> coordinates_3 p) -> orient (at_3 u) (at_3 w) (at_3 c) (at_3 d) = 0 ->
  flat_ridge_holds_3 u w c d = true <-> ((at_3 w ⊖ at_3 u) ✕ (at_3 c ⊖ at_3 u)) · ((at_3 w ⊖ at_3 u) ✕ (at_3 d ⊖ at_3 u)) < 0.
Proof.
  intros D Z. set (e := at_3 w ⊖ at_3 u). set (p := at_3 c ⊖ at_3 u). set (q := at_3 d ⊖ at_3 u). change (vol e p q = 0) in Z.
  unfold flat_ridge_holds_3. rewrite sides_differ_right by (trivial; fold e p q; replace ((e ✕ p) ✕ (e ✕ q)) with (scale (vol e p q) e) by vector; rewrite Z; vector).
  fold e p q. split; [tauto|]. intro L. split; [exact L|]. destruct (Req_dec (X1 (e ✕ p)) 0) as [A|A]; [|exists along_x; split; [now left|exact A]].
  destruct (Req_dec (X2 (e ✕ p)) 0) as [B|B]; [|exists along_y; split; [right; now left|exact B]].
  exists along_z. split; [simpl; tauto|]. intro C. cbn [coordinate_along] in C. revert L. unfold dot. rewrite A, B, C. lra.
Qed.
