(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Returned implies certifies, in space: for finite doubles of the coordinate domain, |x|, |y|, |z| <= 2^500, and the very operations that the
   compiled code carries out (filter_3.v in Coq's primitive floats, replayed by link/check), overflow and underflow within the theorem.

   - orientation_3_returned, empty_sphere_3_returned   a sign is right; a tolerance is a finite number, at most the half widths
   - orientation_3_returned_certifies    every placement in which each point is closer than the tolerance to where it was is positive
   - empty_sphere_3_returned_certifies   the same of an empty sphere whose cells are positive at the reference and at the placement
   - bicell_3_returned_certifies         with the cells' widths always in it: nothing is required of the cells at the placement *)
From Coq Require Import Reals ZArith Lra.
From Flocq Require Import Core.
From Coq Require Import Floats.
From Annulus Require float_certifies_3 float_filter float_sphere_3.
From Annulus Require Import operations bridge bridge_decide filter_2 filter_3 bridge_terms_3 bridge_3 connect connect_3.
From Annulus Require Import vectors bicell tetrahedron sign_tolerance_3.
Close Scope float_scope.
Open Scope R_scope.

Module C := float_certifies_3.

Definition at_3 (v : vector_3 machine) : vec := V (value (x3 _ v)) (value (y3 _ v)) (value (z3 _ v)).
Definition coordinates_3 (v : vector_3 machine) : Prop := coordinate (x3 _ v) /\ coordinate (y3 _ v) /\ coordinate (z3 _ v).

Lemma at_domain_3 : forall v, coordinates_3 v -> in_domain_3 v (real_3 (C.numbers (at_3 v))).
Proof. intros v (A & B & C). split; [|split]; now apply coordinate_stands. Qed.
Lemma at_format_3 : forall v, C.F_numbers (at_3 v).
Proof. intro v. split; [|split]; apply value_format. Qed.

(* ---- Orientation ---- *)

Section orientation.
Variable f : corner -> vector_3 machine.     (* what the code is given *)
Hypothesis domain : forall k, coordinates_3 (f k).
Let x : corners := fun k => at_3 (f k).      (* where that is *)
Let answer := orientation_filter_3 machine (f o) (f u) (f v) (f w) true.

Lemma orientation_3_stage : stands_answer answer (convert (C.tetrahedron_filter x)).
Proof. unfold C.tetrahedron_filter. rewrite <- orientation_3_is. apply (orientation_filter_3_stands true); apply at_domain_3, domain. Qed.

Theorem orientation_3_returned :
  match answer with
  | refused => True
  | positive t => finite t = true /\ 0 < volume x /\ 0 <= value t <= half_width_simplex x
  | negative _ => volume x < 0
  | filter_2.zero _ => False
  end.
Proof.
  assert (A := orientation_3_stage). assert (B := C.tetrahedron_sound x (fun k => at_format_3 (f k))). assert (S := sound_signed _ _ _ _ B).
  revert A. destruct answer as [|t|t|t]; intro A; [trivial| | |].
  - destruct (returned_negative _ t S A) as [r E]. destruct (B _ _ E) as [[N _]|[_ N]]; [discriminate|exact N].
  - exact (never_zero _ t A).
  - destruct (returned_positive _ t S A) as [F E]. destruct (B _ _ E) as [(_ & P & T)|[N _]]; [|discriminate].
    split; [exact F|]. split; [exact P|exact (T eq_refl)].
Qed.

Theorem orientation_3_returned_certifies : forall tolerance (y : corners), answer = positive tolerance ->
  (forall k, norm (y k ⊖ x k) < value tolerance) -> 0 < volume y.
Proof.
  intros tolerance y A Near. generalize orientation_3_returned. rewrite A. intros (_ & P & _ & H).
  exact (orientation_tolerance x y (value tolerance) P H Near).
Qed.
End orientation.

(* ---- Empty sphere ---- *)

Section empty_sphere.
Variable f : vertex -> vector_3 machine.
Hypothesis domain : forall k, coordinates_3 (f k).
Let x : placement := fun k => at_3 (f k).
Definition sphere_answer (use : cells) := bicell_filter machine (f a) (f b) (f c) (f p) (f q) true use.

Lemma sphere_stage use : stands_answer (sphere_answer use) (convert (C.sphere_filter x (use_of use))).
Proof. unfold C.sphere_filter. rewrite <- bicell_filter_is. apply (bicell_filter_stands true); apply at_domain_3, domain. Qed.

Lemma sphere_signed use : signed (C.sphere_filter x use).
Proof. intros s r E. destruct (C.sphere_sound x (fun k => at_format_3 (f k)) use s r E) as [(S & _)|(S & _)]; auto. Qed.

(* The tolerance is that of sign_tolerance_3.v: the annuli's, with the cells' where a partition may be on the wrong side, or always, or never. *)
Definition half_widths (use : cells) : R :=
  match use with never => annuli_half_width x | where_needed => own_tolerance_3 x | always => tolerance_3 x end.

Theorem empty_sphere_3_returned : forall use,
  match sphere_answer use with
  | refused => True
  | positive t => finite t = true /\ 0 < det x /\ 0 <= value t <= half_widths use
  | negative _ => det x < 0
  | filter_2.zero _ => False
  end.
Proof.
  intro use. assert (A := sphere_stage use). assert (S := sphere_signed (use_of use)). assert (Fx : forall k, C.F_numbers (x k)) by (intro; apply at_format_3).
  assert (B := C.sphere_sound x Fx (use_of use)). revert A. destruct (sphere_answer use) as [|t|t|t]; intro A; [trivial| | |].
  - destruct (returned_negative _ t S A) as [r E]. destruct (B _ _ E) as [[N _]|[_ N]]; [discriminate|exact N].
  - exact (never_zero _ t A).
  - destruct (returned_positive _ t S A) as [F E]. destruct (B _ _ E) as [(_ & P & (T0 & An) & Ce)|[N _]]; [|discriminate].
    split; [exact F|]. split; [exact P|]. split; [exact T0|]. destruct use; simpl use_of in *.
    + exact An.
    + exact (C.where_needed_own x Fx _ _ E eq_refl).
    + apply Rmin_glb; [exact An|exact (Ce eq_refl)].
Qed.

Theorem empty_sphere_3_returned_certifies : forall tolerance (y : placement), sphere_answer where_needed = positive tolerance ->
  0 < lambda x p -> 0 < lambda x q -> 0 < lambda y p -> 0 < lambda y q ->
  (forall k, norm (y k ⊖ x k) < value tolerance) -> 0 < det y.
Proof.
  intros tolerance y A Xp Xq Yp Yq Near. generalize (empty_sphere_3_returned where_needed). rewrite A. intros (_ & P & _ & H).
  exact (sign_tolerance_3_own x y (value tolerance) Near Xp Xq P Yp Yq H).
Qed.

Theorem bicell_3_returned_certifies : forall tolerance (y : placement), sphere_answer always = positive tolerance ->
  0 < lambda x p -> 0 < lambda x q -> (forall k, norm (y k ⊖ x k) < value tolerance) -> 0 < det y /\ 0 < lambda y p /\ 0 < lambda y q.
Proof.
  intros tolerance y A Xp Xq Near. generalize (empty_sphere_3_returned always). rewrite A. intros (_ & P & _ & H).
  exact (sign_tolerance_3 x y (value tolerance) Near Xp Xq P H).
Qed.
End empty_sphere.
