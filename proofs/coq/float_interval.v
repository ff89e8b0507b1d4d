(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The interval stage encloses: Boost.Interval's operations under the policy of src/annulus/arithmetic/interval.h, in doubles, as interval_2.v has them
   and link/check replays. An end may be infinite: then it bounds nothing, and overflow needs no care; nor does underflow.

   - holds_add .. holds_square   the result of an operation on intervals that hold two numbers holds the result of the operation on them
   What the stage does with them is in interval_tail.v. *)
From Coq Require Import Reals Lra Psatz ZArith Bool.
From Flocq Require Import Core IEEE754.BinarySingleNaN IEEE754.PrimFloat.
From Coq Require Import Floats.
From Annulus Require Import operations float_directed filter_2 interval_2.
Close Scope float_scope.
Open Scope R_scope.
Notation is_finite := BinarySingleNaN.is_finite.
Notation is_nan := BinarySingleNaN.is_nan.

Definition holds (a : interval) (x : R) : Prop := under (lower a) x /\ above (upper a) x.

(* A double stands for a number; an infinite one for any of its sign. *)
Definition means (e : double) (r : R) : Prop :=
  is_finite e = true /\ B2R e = r \/ e = B754_infinity false /\ 0 < r \/ e = B754_infinity true /\ r < 0.

Lemma ends a x : holds a x -> exists l u, means (lower a) l /\ means (upper a) u /\ l <= x <= u /\
  (0 <= l -> is_finite (lower a) = true) /\ (u <= 0 -> is_finite (upper a) = true).
Proof.
  intros [LO UP].
  assert (L : exists l, means (lower a) l /\ l <= x /\ (0 <= l -> is_finite (lower a) = true)).
  { destruct LO as [[A L]|A]; [exists (B2R (lower a)); unfold means; intuition|]. exists (Rmin x (-1)). generalize (Rmin_l x (-1)) (Rmin_r x (-1)). intros.
    split; [right; right; split; [exact A|lra]|]. split; [assumption|]. intro. exfalso. lra. }
  assert (U : exists u, means (upper a) u /\ x <= u /\ (u <= 0 -> is_finite (upper a) = true)).
  { destruct UP as [[A U]|A]; [exists (B2R (upper a)); unfold means; intuition|]. exists (Rmax x 1). generalize (Rmax_l x 1) (Rmax_r x 1). intros.
    split; [right; left; split; [exact A|lra]|]. split; [assumption|]. intro. exfalso. lra. }
  destruct L as (l & L & L' & F), U as (u & U & U' & F'). exists l, u. tauto.
Qed.

Lemma below_nought e r : means e r -> below e nought = Rlt_bool r 0.
Proof.
  intros [[F <-]|[[-> H]|[-> H]]]; [unfold below; now rewrite Bltb_correct|symmetry; apply Rlt_bool_false|symmetry; apply Rlt_bool_true]; lra.
Qed.
Lemma nought_below e r : means e r -> below nought e = Rlt_bool 0 r.
Proof.
  intros [[F <-]|[[-> H]|[-> H]]]; [unfold below; now rewrite Bltb_correct|symmetry; apply Rlt_bool_true|symmetry; apply Rlt_bool_false]; lra.
Qed.

Lemma means_opp e r : means e r -> means (Bopp e) (- r).
Proof. unfold means. rewrite is_finite_Bopp, B2R_Bopp. intros [[F <-]|[[-> H]|[-> H]]]; simpl; intuition lra. Qed.

Lemma means_sign e r : means e r -> r <> 0 -> Bsign e = Rlt_bool r 0 /\ is_nan e = false /\ (is_finite e = true -> is_finite_strict e = true).
Proof.
  intros [[F E]|[[-> H]|[-> H]]] N; [|simpl; rewrite Rlt_bool_false by lra; easy|simpl; rewrite Rlt_bool_true by lra; easy].
  destruct e as [s|s| |s m x B]; try easy.
  - now elim N.
  - split; [|easy]. simpl. subst r. destruct s; symmetry; [apply Rlt_bool_true|apply Rlt_bool_false; left]; [apply F2R_lt_0|apply F2R_gt_0]; easy.
Qed.

(* A product upward is an upper bound, if it is finite or positive. *)
Lemma times_above e f r s : means e r -> means f s -> is_finite e = true /\ is_finite f = true \/ 0 < r * s -> above (times mode_UP e f) (r * s).
Proof.
  intros A B C. destruct (bool_dec (is_finite e && is_finite f) true) as [H|H].
  - apply andb_prop in H. destruct H as [E F].
    assert (B2R e = r) as <- by (destruct A as [[_ A]|[[A _]|[A _]]]; [exact A|now rewrite A in E|now rewrite A in E]).
    assert (B2R f = s) as <- by (destruct B as [[_ B]|[[B _]|[B _]]]; [exact B|now rewrite B in F|now rewrite B in F]).
    now apply rounded_up, times_rounded.
  - right. destruct C as [[E F]|C]; [now rewrite E, F in H|]. assert (R0 : r <> 0) by nra. assert (S0 : s <> 0) by nra.
    destruct (means_sign e r A R0) as (Se & Ne & Ee), (means_sign f s B S0) as (Sf & Nf & Ef).
    assert (X : xorb (Rlt_bool r 0) (Rlt_bool s 0) = false).
    { do 2 (case Rlt_bool_spec; intro); try reflexivity; exfalso; nra. }
    rewrite <- Se, <- Sf in X. destruct e as [s0|s0| |s0 m0 x0 B0], f as [s1|s1| |s1 m1 x1 B1]; simpl in *; try easy; try (now destruct (Ee eq_refl)); try (now destruct (Ef eq_refl)); now rewrite X.
Qed.
Lemma mul_down_under e f r s : means e r -> means f s -> is_finite e = true /\ is_finite f = true \/ r * s < 0 -> under (mul_down e f) (r * s).
Proof.
  intros A B C. apply opp_under. replace (- (r * s)) with (r * - s) by ring. apply times_above; [exact A|now apply means_opp|].
  rewrite is_finite_Bopp. destruct C as [C|C]; [now left|right]. lra.
Qed.

Lemma under_least a b x y : under a x -> under b y -> under (least a b) (Rmin x y).
Proof.
  intros [[A X]| ->] [[B Y]| ->]; unfold least, below.
  - rewrite Bltb_correct by assumption. case Rlt_bool_spec; intro L; left; (split; [assumption|apply Rmin_glb; lra]).
  - right. now destruct a.
  - right. now destruct b.
  - now right.
Qed.
Lemma above_most a b x y : above a x -> above b y -> above (most a b) (Rmax x y).
Proof.
  intros [[A X]| ->] [[B Y]| ->]; unfold most, below.
  - rewrite Bltb_correct by assumption. case Rlt_bool_spec; intro L; left; (split; [assumption|apply Rmax_lub; lra]).
  - right. now destruct a.
  - right. now destruct b.
  - now right.
Qed.
Lemma under_most a b x y : under a x -> under b y -> under (most a b) (Rmax x y).
Proof.
  assert (L := Rmax_l x y). assert (U := Rmax_r x y). intros [[A X]| ->] [[B Y]| ->]; unfold most, below.
  - rewrite Bltb_correct by assumption. case Rlt_bool_spec; intro; left; (split; [assumption|lra]).
  - left. replace (Bltb a _) with false by now destruct a. split; [exact A|lra].
  - left. replace (Bltb _ b) with true by now destruct b. split; [exact B|lra].
  - now right.
Qed.

Theorem holds_exactly e : is_finite e = true -> holds (exactly e) (B2R e).
Proof. intro F. split; left; (split; [exact F|apply Rle_refl]). Qed.
Theorem holds_add a b x y : holds a x -> holds b y -> holds (i_add a b) (x + y).
Proof.
  intros [A A'] [B B']. split; [|now apply above_plus]. apply opp_under. replace (- (x + y)) with (- x - y) by ring. apply above_minus; [now apply under_opp|exact B].
Qed.
Theorem holds_sub a b x y : holds a x -> holds b y -> holds (i_sub a b) (x - y).
Proof.
  intros [A A'] [B B']. split; [|now apply above_minus]. apply opp_under. replace (- (x - y)) with (y - x) by ring. now apply above_minus.
Qed.
Theorem holds_opp a x : holds a x -> holds (i_opp a) (- x).
Proof. intros [A A']. split; [apply opp_under; now rewrite Ropp_involutive|now apply under_opp]. Qed.
Theorem holds_max a b x y : holds a x -> holds b y -> holds (i_max a b) (Rmax x y).
Proof. intros [A A'] [B B']. split; [now apply under_most|now apply above_most]. Qed.

(* A product is between the products of the ends. *)
Lemma above_corners l a b c d x y : a <= x <= b -> c <= y <= d -> l <= a * c -> l <= a * d -> l <= b * c -> l <= b * d -> l <= x * y.
Proof.
  intros [A B] [C D] H1 H2 H3 H4. destruct (Rle_dec 0 y) as [Y | Y].
  - apply Rle_trans with (a * y); [| now apply Rmult_le_compat_r]. destruct (Rle_dec 0 a) as [S | S].
    + apply Rle_trans with (1 := H1). now apply Rmult_le_compat_l.
    + apply Rle_trans with (1 := H2). apply Rmult_le_compat_neg_l; lra.
  - apply Rle_trans with (b * y); [| rewrite (Rmult_comm b), (Rmult_comm x); apply Rmult_le_compat_neg_l; lra].
    destruct (Rle_dec 0 b) as [S | S].
    + apply Rle_trans with (1 := H3). now apply Rmult_le_compat_l.
    + apply Rle_trans with (1 := H4). apply Rmult_le_compat_neg_l; lra.
Qed.
Lemma below_corners h a b c d x y : a <= x <= b -> c <= y <= d -> a * c <= h -> a * d <= h -> b * c <= h -> b * d <= h -> x * y <= h.
Proof.
  intros X Y H1 H2 H3 H4. apply Ropp_le_cancel. rewrite Ropp_mult_distr_l. apply above_corners with (- b) (- a) c d; lra.
Qed.

Lemma holds_nothing : holds (exactly nought) 0.
Proof. apply (holds_exactly nought eq_refl). Qed.

Theorem holds_mul a b x y : holds a x -> holds b y -> holds (i_mul a b) (x * y).
Proof.
  intros A B. destruct (ends a x A) as (l & u & L & U & X & Fl & Fu), (ends b y B) as (m & w & M & W & Y & Fm & Fw).
  unfold i_mul. cbv zeta. rewrite (below_nought _ _ L), (nought_below _ _ U), (below_nought _ _ M), (nought_below _ _ W).
  assert (Up : forall e f r s, means e r -> means f s -> (is_finite e = true /\ is_finite f = true \/ 0 < r * s) ->
    l * m <= r * s -> l * w <= r * s -> u * m <= r * s -> u * w <= r * s -> above (times mode_UP e f) (x * y)).
  { intros e f r s E F C H1 H2 H3 H4. apply above_le with (r * s); [now apply below_corners with l u m w|now apply times_above]. }
  assert (Down : forall e f r s, means e r -> means f s -> (is_finite e = true /\ is_finite f = true \/ r * s < 0) ->
    r * s <= l * m -> r * s <= l * w -> r * s <= u * m -> r * s <= u * w -> under (mul_down e f) (x * y)).
  { intros e f r s E F C H1 H2 H3 H4. apply under_le with (r * s); [now apply above_corners with l u m w|now apply mul_down_under]. }
  case Rlt_bool_spec; intro Nl; case Rlt_bool_spec; intro Pu; try (case Rlt_bool_spec; intro Nm; case Rlt_bool_spec; intro Pw).
  all: try (assert (x = 0 \/ y = 0) as [-> | ->] by (first [left; lra|right; lra]); rewrite ?Rmult_0_l, ?Rmult_0_r; exact holds_nothing).
  - split; cbn [lower upper].
    + assert (H1 := Rmin_l (l * w) (u * m)). assert (H2 := Rmin_r (l * w) (u * m)).
      apply under_le with (Rmin (l * w) (u * m)); [apply above_corners with l u m w; trivial; nra|].
      apply under_least; (apply mul_down_under; [assumption|assumption|right; nra]).
    + assert (H1 := Rmax_l (l * m) (u * w)). assert (H2 := Rmax_r (l * m) (u * w)).
      apply above_le with (Rmax (l * m) (u * w)); [apply below_corners with l u m w; trivial; nra|].
      apply above_most; (apply times_above; [assumption|assumption|right; nra]).
  - split; [apply Down with u m|apply Up with l m]; trivial; nra.
  - split; [apply Down with l w|apply Up with u w]; trivial; nra.
  - split; [apply Down with l w|apply Up with l m]; trivial; nra.
  - split; [apply Down with u w|apply Up with l m]; trivial; try nra; left; auto.
  - split; [apply Down with l w|apply Up with u m]; trivial; try nra; left; auto.
  - split; [apply Down with u m|apply Up with u w]; trivial; nra.
  - split; [apply Down with u m|apply Up with l w]; trivial; try nra; left; auto.
  - split; [apply Down with l m|apply Up with u w]; trivial; try nra; left; auto.
Qed.

Theorem holds_square a x : holds a x -> holds (i_square a) (x * x).
Proof.
  intro A. destruct (ends a x A) as (l & u & L & U & X & Fl & Fu). unfold i_square. cbv zeta.
  rewrite (below_nought _ _ U), (nought_below _ _ L).
  assert (Up : forall e r, means e r -> x * x <= r * r -> 0 < r * r \/ is_finite e = true -> above (times mode_UP e e) (x * x)).
  { intros e r E H C. apply above_le with (r * r); [exact H|]. apply times_above; trivial. destruct C; auto. }
  case Rlt_bool_spec; intro Nu; [|case Rlt_bool_spec; intro Pl].
  - split; cbn [lower upper]; [|apply Up with l; trivial; [nra|left; nra]]. apply under_le with (u * u); [nra|].
    apply mul_down_under; trivial. left. split; apply Fu; lra.
  - split; cbn [lower upper]; [|apply Up with u; trivial; [nra|left; nra]]. apply under_le with (l * l); [nra|].
    apply mul_down_under; trivial. left. split; apply Fl; lra.
  - split; cbn [lower upper]; [apply under_le with 0; [nra|left; split; [reflexivity|apply Rle_refl]]|].
    destruct A as [[[Fl' L']|E] [[Fu' U']|E']].
    + unfold below. rewrite Bltb_correct by (rewrite ?is_finite_Bopp; assumption). rewrite B2R_Bopp.
      case Rlt_bool_spec; intro H; (eapply above_le; [|apply rounded_up, times_rounded; easy]); nra.
    + right. rewrite E'. now destruct (lower a).
    + right. rewrite E. now destruct (upper a).
    + right. now rewrite E, E'.
Qed.
