(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Doubles as integers times one power of two, and the formulas of the plane over them: src/annulus/arithmetic/exact.h, Scaled_integers. The exponent here is
   at most 0, that of the code the least of the exponents: a power of two more or less.

   - value_integer                           a double is its integer times the power
   - orientation_scaled, annulus_scaled      so are the terms, times powers of it *)
From Coq Require Import Reals ZArith List Lra Psatz.
From Flocq Require Import Core IEEE754.BinarySingleNaN IEEE754.PrimFloat.
From Coq Require Import Floats.
From Annulus Require Import operations filter_2.
Import ListNotations.
Close Scope float_scope.
Open Scope R_scope.

(* Exact arithmetic. *)
Definition integers : operations := {|
  number := Z; add := Z.add; sub := Z.sub; mul := Z.mul; square x := (x * x)%Z; greater := Z.max;
  div a _ := a; root a := a; opposite := Z.opp; magnitude := Z.abs; less := Z.ltb; less_equal := Z.leb;
  constant _ := 0%Z (* division, roots and constants are not used *) |}.

Definition half_width (t : width_terms reals) : R := determinant _ t / (R_sqrt.sqrt (inner _ t) + R_sqrt.sqrt (outer _ t)).

(* A finite double as an integer times 2^k, for k at most its exponent. *)
Definition exponent (f : float) : Z := match Prim2SF f with S754_finite _ _ e => e | _ => 0%Z end.
Definition integer (k : Z) (f : float) : Z :=
  match Prim2SF f with S754_finite s m e => ((if s then Z.neg m else Z.pos m) * 2 ^ (e - k))%Z | _ => 0%Z end.
Definition common (l : list float) : Z := fold_right (fun f k => Z.min (exponent f) k) 0%Z l.

Lemma common_le : forall f l, In f l -> (common l <= exponent f)%Z.
Proof.
  intros f l. induction l as [|g l IH]; simpl; [easy|]. intros [->|H]; [apply Z.le_min_l|].
  apply Z.le_trans with (2 := IH H). apply Z.le_min_r.
Qed.

Lemma value_integer : forall k f, (k <= exponent f)%Z -> value f = IZR (integer k f) * bpow radix2 k.
Proof.
  intros k f. unfold value, Prim2B, exponent, integer. rewrite B2R_SF2B.
  destruct (Prim2SF f) as [s|s| |s m e]; intro H; try (unfold SF2R; simpl; ring).
  unfold SF2R, F2R. simpl Fnum. simpl Fexp.
  rewrite mult_IZR. change 2%Z with (radix_val radix2). rewrite IZR_Zpower by (apply Zle_minus_le_0, H).
  rewrite Rmult_assoc, <- bpow_plus. replace (e - k + k)%Z with e by ring. now destruct s.
Qed.

Definition real_point (a b : float) : vector reals := {| x := value a : number reals; y := value b : number reals |}.
Definition integer_point (k : Z) (a b : float) : vector integers :=
  {| x := integer k a : number integers; y := integer k b : number integers |}.

Definition orientation_of o (a b c : vector o) := orientation_terms o (difference o b a) (difference o c a) (difference o c b).
Definition annulus_of o (a b p q : vector o) :=
  annulus_terms o (difference o b a) (difference o p a) (difference o q a) (difference o q p).

(* Coordinates c times integers: the terms are c g, g^2 and g^2 times integers, with g = c or g = c^3. *)
Definition scaled_vector (c : R) (v : vector integers) (w : vector reals) := x _ w = IZR (x _ v) * c /\ y _ w = IZR (y _ v) * c.
Definition scaled_terms (c g : R) (t : width_terms integers) (t' : width_terms reals) :=
  determinant _ t' = IZR (determinant _ t) * (c * g) /\
  inner _ t' = IZR (inner _ t) * (g * g) /\ outer _ t' = IZR (outer _ t) * (g * g).

Lemma add_scaled k r s m n : r = IZR m * k -> s = IZR n * k -> r + s = IZR (m + n) * k.
Proof. intros -> ->. rewrite plus_IZR. ring. Qed.
Lemma sub_scaled k r s m n : r = IZR m * k -> s = IZR n * k -> r - s = IZR (m - n) * k.
Proof. intros -> ->. rewrite minus_IZR. ring. Qed.
Lemma mul_scaled k l r s m n : r = IZR m * k -> s = IZR n * l -> r * s = IZR (m * n) * (k * l).
Proof. intros -> ->. rewrite mult_IZR. ring. Qed.

Lemma scaled_difference : forall c v w v' w', scaled_vector c v v' -> scaled_vector c w w' ->
  scaled_vector c (difference integers v w) (difference reals v' w').
Proof. intros c v w v' w' [A B] [C D]. split; now apply sub_scaled. Qed.

Lemma annulus_scaled : forall c b p q e b' p' q' e',
  scaled_vector c b b' -> scaled_vector c p p' -> scaled_vector c q q' -> scaled_vector c e e' ->
  scaled_terms c (c * c * c) (annulus_terms integers b p q e) (annulus_terms reals b' p' q' e').
Proof.
  intros c b p q e b' p' q' e' [Bx By] [Px Py] [Qx Qy] [Ex Ey].
  unfold scaled_terms, annulus_terms, squared. simpl. replace (c * (c * c * c)) with (c * c * (c * c)) by ring.
  repeat split; repeat first [assumption|apply mul_scaled|apply sub_scaled|apply add_scaled].
Qed.

Lemma Rmax_scaled : forall c m n, 0 <= c -> Rmax (IZR m * c) (IZR n * c) = IZR (Z.max m n) * c.
Proof.
  intros c m n H. rewrite (Rmult_comm (IZR m)), (Rmult_comm (IZR n)), RmaxRmult, Rmult_comm by exact H. f_equal.
  destruct (Z.max_spec m n) as [[L ->]|[L ->]]; [apply Rmax_right, IZR_le, Z.lt_le_incl, L|apply Rmax_left, IZR_le, L].
Qed.

Lemma orientation_scaled : forall c u v w u' v' w',
  scaled_vector c u u' -> scaled_vector c v v' -> scaled_vector c w w' ->
  scaled_terms c c (orientation_terms integers u v w) (orientation_terms reals u' v' w').
Proof.
  intros c u v w u' v' w' [Ux Uy] [Vx Vy] [Wx Wy].
  unfold scaled_terms, orientation_terms, squared. simpl. rewrite Ux, Uy, Vx, Vy, Wx, Wy.
  assert (S : forall m n, IZR m * c * (IZR m * c) + IZR n * c * (IZR n * c) = IZR (m * m + n * n) * (c * c)).
  { intros m n. rewrite plus_IZR, !mult_IZR. ring. }
  rewrite !S, !Rmax_scaled by apply Rle_0_sqr. repeat split.
  rewrite minus_IZR, !mult_IZR. ring.
Qed.

(* Of coordinates. *)
Lemma scaled_point : forall k a b, (k <= exponent a)%Z -> (k <= exponent b)%Z ->
  scaled_vector (bpow radix2 k) (integer_point k a b) (real_point a b).
Proof. intros k a b A B. split; apply value_integer; assumption. Qed.
