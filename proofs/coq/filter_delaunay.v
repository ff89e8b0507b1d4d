(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The chain in the plane put together: from the doubles that come in, over what the filter writes down and looks at, to a Delaunay triangulation.

   - is_answer               of a verdict: it is what the filtered predicate answers of these doubles, operation by operation
   - answer_evaluated          such a verdict promises what the filter requires of one
   - same_record_certifies   a ridge that was not evaluated anew between two states is certified at both by one tolerance
   - filter_delaunay         after any calls of the filter: if the border winds once, the cells triangulate the hull and are Delaunay;
                             when the program counts that, and why that is enough, is in filter_calls.v *)
From Coq Require Import Reals ZArith Lra List.
From Coq Require Import Floats.
From Annulus Require Import points_2 width_2 operations connect filter_2 filter_doubles returned_2 stages predicate_2.
From Annulus Require Import algorithm_list algorithm_filter algorithm_keep algorithm_check algorithm_run filter_world filter_plane.
From Annulus Require Import plane_mesh plane_triangulation plane_delaunay plane_certificates flat_ridges plane_motion.
Import ListNotations.
Close Scope float_scope.
Open Scope R_scope.

Definition doubles : Type := nat -> filter_2.vector machine.
Definition at_doubles (f : doubles) : placement := fun v => at_2 (f v).

Lemma coordinates_valid p : coordinates_2 p -> valid_2 (at_2 p).
Proof. intros [[_ X] [_ Y]]. split; (split; [apply value_format|]); assumption. Qed.

Section filter.
Context {o : options}.
#[global] Instance the_plane : world := plane list_length stamps_there_are worn_out no_fold.
Definition answered_2 := answered list_length stamps_there_are worn_out no_fold.

(* ---- Verdicts ---- *)

(* What the filtered predicate answers of these doubles, in whichever stage and mode. *)
Definition is_answer (f : doubles) (k : verdict) : Prop := exists correctly_rounded,
  match of k with
  | cell a b c => says (orientation_predicate correctly_rounded (f a) (f b) (f c)) False (bound k)
  | ridge a b c => says (orientation_predicate correctly_rounded (f a) (f b) (f c)) (flat_ridge_holds (f a) (f b) (f c) = true) (bound k)
  | circle a b p q => says (empty_sphere_predicate correctly_rounded (f a) (f b) (f p) (f q)) True (bound k)
  end.

(* Coordinates are compared only where the determinant is 0. *)
Lemma ridge_rule f correctly_rounded a b c r : (forall v, In v [a; b; c] -> coordinates_2 (f v)) ->
  says (orientation_predicate correctly_rounded (f a) (f b) (f c)) (flat_ridge_holds (f a) (f b) (f c) = true) r ->
  says (orientation_predicate correctly_rounded (f a) (f b) (f c)) (no_fold (ridge a b c) (at_doubles f)) r.
Proof.
  intros D. destruct (orientation_2_right f correctly_rounded a b c D) as [R _]. revert R. destruct (orientation_predicate _ _ _ _); trivial.
  intros Z [H ->]. split; [|reflexivity]. now apply flat_ridge_right.
Qed.

Lemma answer_holds f k : (forall v, coordinates_2 (f v)) ->
  match of k with circle a b p q => 0 < turn_at (at_doubles f) a b q /\ 0 < turn_at (at_doubles f) b a p | _ => True end ->
  is_answer f k -> answered_2 (at_doubles f) k.
Proof.
  intros D P [correctly_rounded H]. destruct k as [i c t]. cbn [of bound] in *. destruct c as [a b c|a b c|a b p q].
  - apply (triangle_answered _ _ _ no_fold f i correctly_rounded a b c t); [now intros|exact H].
  - apply (triangle_answered _ _ _ no_fold f i correctly_rounded a b c t); [now intros|]. apply (ridge_rule f correctly_rounded); [now intros|exact H].
  - destruct P. apply (circle_answered _ _ _ no_fold f i correctly_rounded a b p q t); trivial; now intros.
Qed.

Theorem answer_evaluated f k : (forall v, coordinates_2 (f v)) ->
  match of k with circle a b p q => 0 < turn_at (at_doubles f) a b q /\ 0 < turn_at (at_doubles f) b a p | _ => True end ->
  is_answer f k -> evaluated (at_doubles f) k.
Proof. intros D P H. apply (verdict_evaluated _ _ _ no_fold no_fold_local). now apply answer_holds. Qed.

Lemma answer_cell f k a b c : (forall v, coordinates_2 (f v)) -> of k = least_first a b c -> is_answer f k -> 0 < turn_at (at_doubles f) a b c.
Proof.
  intros D E H. apply (cell_of_circle no_fold). rewrite <- E. assert (A : answered_2 (at_doubles f) k).
  { apply answer_holds; trivial. rewrite E. unfold least_first. destruct (_ && _)%bool; [exact I|]. destruct (_ && _)%bool; exact I. }
  destruct A as [(_ & _ & A & _)|(_ & A)]; exact A.
Qed.

Lemma near_squares (m x : placement) a n : near m x a n <-> dist2 (m n) (x n) < Rmax 0 a * Rmax 0 a \/ m n = x n.
Proof.
  unfold near. change (@dist the_plane (x n) (m n)) with (R_sqrt.sqrt (dist2 (m n) (x n))). assert (N := d2_nonneg (fst (m n)) (snd (m n)) (fst (x n)) (snd (x n))).
  change (d2 (fst (m n)) (snd (m n)) (fst (x n)) (snd (x n))) with (dist2 (m n) (x n)) in N. assert (S := sqrt_pos (dist2 (m n) (x n))).
  assert (E := sqrt_sqrt _ N). revert N S E. generalize (R_sqrt.sqrt (dist2 (m n) (x n))).
  intros r N S E. unfold Rmax. destruct (Rle_dec 0 a) as [A|A]; split; (intros [H|H]; [left|now right]); try lra.
  - rewrite <- E. now apply Rmult_le_0_lt_compat.
  - apply Rnot_le_lt. intro L. apply (Rlt_not_le _ _ H). rewrite <- E. now apply Rmult_le_compat.
Qed.

(* ---- A start: everything evaluated where the doubles are ---- *)

Record start (f : doubles) (m : Z -> option certificate_2) (verdicts : list verdict) : Prop := {
  in_domain : forall v, coordinates_2 (f v);
  answers_right : forall k, In k verdicts -> m (id k) = Some (of k) /\ is_answer f k;
  all_answered : forall i c, m i = Some c -> In i (map id verdicts);
  ids : forall i c, m i = Some c -> is_id i;
  with_cells : forall i c d, m i = Some c -> counts_on_2 d c -> exists j, m j = Some d }.

Lemma start_answered f m verdicts k : start f m verdicts -> In k verdicts -> answered_2 (at_doubles f) k.
Proof.
  intros [D R A _ C] I. destruct (R k I) as [M H]. apply answer_holds; trivial.
  destruct (of k) as [| |a b p q] eqn:E; trivial.
  assert (P : forall u v w, counts_on_2 (least_first u v w) (circle a b p q) -> 0 < turn_at (at_doubles f) u v w).
  { intros u v w Q. destruct (C _ _ _ M Q) as (j & J). assert (V := A j _ J). apply in_map_iff in V. destruct V as (h & <- & V).
    destruct (R h V) as [M' H']. apply (answer_cell f h); trivial. congruence. }
  split; apply P; [now left|now right].
Qed.

(* The filter right after it evaluated everything: from whatever was before. *)
Definition recomputed (f : doubles) m verdicts (s : state) : system := {| of_filter := recompute (at_doubles f) s m verdicts; tracks := true |}.
Definition places (y : system) : placement := moving (of_filter y).
Definition watches (y : system) (T : plane_mesh.mesh) : Prop :=
  forall c, In c (certificates T) -> exists i, algorithm_filter.mesh (of_filter y) i = Some c.

Theorem filter_holds f m verdicts s z : start f m verdicts -> (0 <= epoch s)%Z -> calls (recomputed f m verdicts s) z ->
  forall i c, algorithm_filter.mesh (of_filter z) i = Some c -> holds_2 no_fold c (places z).
Proof.
  intros S E. assert (B := start_answered f m verdicts). destruct (S) as [D R A I C].
  apply (plane_filter_is_right _ _ _ stamps_positive no_fold no_fold_local); trivial.
  - intro v. apply coordinates_valid, D.
  - intros k K. destruct (R k K). split; [assumption|now apply B].
Qed.

(* A ridge that neither of two states evaluated again is certified at both: the winding is not needed for it. *)
Theorem same_record_certifies y z i u v w : right y -> right z -> tracks y = true -> tracks z = true ->
  algorithm_filter.mesh (of_filter y) i = Some (ridge u v w) -> algorithm_filter.mesh (of_filter z) i = Some (ridge u v w) ->
  reference (record (of_filter z) i) = reference (record (of_filter y) i) -> allowance (record (of_filter z) i) = allowance (record (of_filter y) i) ->
  certified_ridge (places y) (places z) u v w.
Proof.
  unfold right. intros V V' Y Z M M' Er Ea. rewrite Y in V. rewrite Z in V'. destruct V as [_ _ G _], V' as [_ _ G' _]. destruct (G i _ M) as [S C _ _], (G' i _ M') as [_ C' _ _].
  set (a := allowance (record (of_filter y) i)) in *. set (x := reference (record (of_filter y) i)) in *.
  exists x, (fun _ => Rmax 0 a * Rmax 0 a).
  assert (Near : forall m n, near m x a n <-> dist2 (m n) (x n) < Rmax 0 a * Rmax 0 a \/ m n = x n) by (intros; apply near_squares).
  split; [|split].
  - intros n N. apply (promise _ _ _ S n); [|now intros]. intros z' I. apply Near. now apply N.
  - intros n I. apply Near. now apply C.
  - intros n I. apply Near. destruct (C' n I) as [N _]. rewrite Er, Ea in N. exact N.
Qed.

Theorem filter_delaunay f m verdicts s z T : start f m verdicts -> (0 <= epoch s)%Z -> calls (recomputed f m verdicts s) z ->
  glued T -> watches z T -> winds_once (places z) (border T) -> triangulation (places z) T /\ delaunay (places z) T.
Proof.
  intros S E R G A W. apply (certificates_delaunay T (algorithm_filter.mesh (of_filter z))); trivial. exact (filter_holds f m verdicts s z S E R).
Qed.
End filter.
