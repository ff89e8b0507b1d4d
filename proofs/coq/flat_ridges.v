(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* A ridge of the plane whose determinant is 0, as the program looks at it: it compares coordinates, and computes nothing.

   - precedes           the order of points in the code, that of their coordinates one after another
   - flat_ridge_holds   degenerate.h: the vertex v of the ridge is between its neighbours u and w
   - flat_ridge_right    which is that the border does not fold back there *)
From Coq Require Import Reals Lra Bool List.
From Flocq Require Import Core IEEE754.BinarySingleNaN IEEE754.PrimFloat.
From Coq Require Import Floats.
From Annulus Require Import points_2 operations bridge filter_2 returned_2 plane_mesh filter_plane plane_certificates.
Import ListNotations.
Close Scope float_scope.
Open Scope R_scope.

Definition precedes (p q : filter_2.vector machine) : bool :=
  ((x _ p <? x _ q) || ((x _ p =? x _ q) && (y _ p <? y _ q)))%float.
Definition flat_ridge_holds (u v w : filter_2.vector machine) : bool :=
  (precedes u v && precedes v w) || (precedes w v && precedes v u).

Lemma precedes_before p q : coordinates_2 p -> coordinates_2 q -> precedes p q = true <-> before (at_2 p) (at_2 q).
Proof.
  intros [[X _] [Y _]] [[X' _] [Y' _]]. unfold precedes, before, at_2. cbn [fst snd].
  rewrite orb_true_iff, andb_true_iff, !less_of_values, eqb_equiv, Beqb_correct by assumption. fold (value (x _ p)) (value (x _ q)).
  case (Rlt_bool_spec (value (x _ p)) (value (x _ q))), (Rlt_bool_spec (value (y _ p)) (value (y _ q))),
    (Req_bool_spec (value (x _ p)) (value (x _ q))); intuition (lra || discriminate).
Qed.

Theorem flat_ridge_right (f : nat -> filter_2.vector machine) u v w : (forall z, In z [u; v; w] -> coordinates_2 (f z)) ->
  turn_at (fun z => at_2 (f z)) u v w = 0 ->
  flat_ridge_holds (f u) (f v) (f w) = true <-> no_fold (ridge u v w) (fun z => at_2 (f z)).
Proof.
  intros D Z. assert (U := D u ltac:(simpl; tauto)). assert (V := D v ltac:(simpl; tauto)). assert (W := D w ltac:(simpl; tauto)).
  unfold no_fold. rewrite flat_ridge by exact Z. unfold flat_ridge_holds. rewrite orb_true_iff, !andb_true_iff, !precedes_before by assumption. reflexivity.
Qed.
