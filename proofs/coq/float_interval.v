(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The interval stage encloses: Boost.Interval's operations under the policy of src/annulus/arithmetic/interval.h, in which every
   operation is rounded upward and a lower end is the opposite of an upper one.

   `holds_add` and its like: the result of an operation on intervals that hold two numbers holds the result of the operation on them.
   `encloses`: so the value of any expression of these operations, which is what the templates of width_terms.h and width_terms_3.h
   compute; their tails are in float_directed.v.

   Numbers are reals in any format; RU is the rounding upward in it. Of it nothing is used but that it is not below its argument, so
   underflow needs no care. There are no infinities: the stage scales its input (with_scale of interval_stage.h). The cases are those
   of boost/numeric/interval/arith.hpp, arith2.hpp and utility.hpp, and the formulas of the lower ends those of rounded_arith.hpp
   (rounded_arith_opp), transcribed by hand. *)
Require Import Reals Lra Psatz ZArith.
From Flocq Require Import Core.
Open Scope R_scope.

Section interval.
Variable beta : radix.
Variable fexp : Z -> Z.
Context { valid : Valid_exp fexp }.
Definition RU x := round beta fexp Zceil x.

Lemma RU_ge x : x <= RU x.
Proof. now apply round_UP_pt. Qed.

(* rounded_arith_opp: add_up and the others are the operation, rounded. *)
Definition add_down x y := - RU (- x - y).
Definition sub_down x y := - RU (y - x).
Definition mul_down x y := - RU (x * - y).

Lemma add_down_le x y : add_down x y <= x + y.
Proof. unfold add_down. generalize (RU_ge (- x - y)). lra. Qed.
Lemma sub_down_le x y : sub_down x y <= x - y.
Proof. unfold sub_down. generalize (RU_ge (y - x)). lra. Qed.
Lemma mul_down_le x y : mul_down x y <= x * y.
Proof. unfold mul_down. generalize (RU_ge (x * - y)). lra. Qed.

Record interval := I { lower : R; upper : R }.
Definition holds (a : interval) (x : R) := lower a <= x <= upper a.

Definition exactly x := I x x.
Definition i_add a b := I (add_down (lower a) (lower b)) (RU (upper a + upper b)).
Definition i_sub a b := I (sub_down (lower a) (upper b)) (RU (upper a - lower b)).
Definition i_opp a := I (- upper a) (- lower a).
Definition i_max a b := I (Rmax (lower a) (lower b)) (Rmax (upper a) (upper b)).

Definition i_mul a b :=
  let xl := lower a in let xu := upper a in let yl := lower b in let yu := upper b in
  if Rlt_dec xl 0 then
    if Rlt_dec 0 xu then
      if Rlt_dec yl 0 then
        if Rlt_dec 0 yu then I (Rmin (mul_down xl yu) (mul_down xu yl)) (Rmax (RU (xl * yl)) (RU (xu * yu)))
        else I (mul_down xu yl) (RU (xl * yl))
      else
        if Rlt_dec 0 yu then I (mul_down xl yu) (RU (xu * yu)) else I 0 0
    else
      if Rlt_dec yl 0 then
        if Rlt_dec 0 yu then I (mul_down xl yu) (RU (xl * yl)) else I (mul_down xu yu) (RU (xl * yl))
      else
        if Rlt_dec 0 yu then I (mul_down xl yu) (RU (xu * yl)) else I 0 0
  else
    if Rlt_dec 0 xu then
      if Rlt_dec yl 0 then
        if Rlt_dec 0 yu then I (mul_down xu yl) (RU (xu * yu)) else I (mul_down xu yl) (RU (xl * yu))
      else
        if Rlt_dec 0 yu then I (mul_down xl yl) (RU (xu * yu)) else I 0 0
    else I 0 0.

Definition i_square a :=
  let xl := lower a in let xu := upper a in
  if Rlt_dec xu 0 then I (mul_down xu xu) (RU (xl * xl))
  else if Rlt_dec 0 xl then I (mul_down xl xl) (RU (xu * xu))
  else I 0 (if Rlt_dec xu (- xl) then RU (xl * xl) else RU (xu * xu)).

Theorem holds_exactly x : holds (exactly x) x.
Proof. split; simpl; lra. Qed.

Theorem holds_add a b x y : holds a x -> holds b y -> holds (i_add a b) (x + y).
Proof.
  intros [A A'] [B B']. split; simpl.
  - generalize (add_down_le (lower a) (lower b)). lra.
  - generalize (RU_ge (upper a + upper b)). lra.
Qed.

Theorem holds_sub a b x y : holds a x -> holds b y -> holds (i_sub a b) (x - y).
Proof.
  intros [A A'] [B B']. split; simpl.
  - generalize (sub_down_le (lower a) (upper b)). lra.
  - generalize (RU_ge (upper a - lower b)). lra.
Qed.

Theorem holds_opp a x : holds a x -> holds (i_opp a) (- x).
Proof. intros [A A']. split; simpl; lra. Qed.

Theorem holds_max a b x y : holds a x -> holds b y -> holds (i_max a b) (Rmax x y).
Proof.
  intros [A A'] [B B']. split; simpl.
  - apply Rmax_lub; [apply Rle_trans with (1 := A), Rmax_l | apply Rle_trans with (1 := B), Rmax_r].
  - apply Rmax_lub; [apply Rle_trans with (1 := A'), Rmax_l | apply Rle_trans with (1 := B'), Rmax_r].
Qed.

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

(* The signs of the ends, and which corner is least and greatest. *)
Lemma mul_by_corners a b l h x y : holds a x -> holds b y ->
  (l <= lower a * lower b /\ l <= lower a * upper b /\ l <= upper a * lower b /\ l <= upper a * upper b) ->
  (lower a * lower b <= h /\ lower a * upper b <= h /\ upper a * lower b <= h /\ upper a * upper b <= h) -> holds (I l h) (x * y).
Proof.
  intros A B (L1 & L2 & L3 & L4) (H1 & H2 & H3 & H4). split; simpl.
  - now apply above_corners with (1 := A) (2 := B).
  - now apply below_corners with (1 := A) (2 := B).
Qed.

Theorem holds_mul a b x y : holds a x -> holds b y -> holds (i_mul a b) (x * y).
Proof.
  intros A B. assert (O : lower a <= upper a) by (destruct A; lra). assert (Q : lower b <= upper b) by (destruct B; lra).
  generalize (mul_by_corners a b). intro M. unfold i_mul. cbv zeta.
  set (xl := lower a) in *. set (xu := upper a) in *. set (yl := lower b) in *. set (yu := upper b) in *.
  generalize (RU_ge (xl * yl)) (RU_ge (xl * yu)) (RU_ge (xu * yl)) (RU_ge (xu * yu)). intros U1 U2 U3 U4.
  generalize (mul_down_le xl yl) (mul_down_le xl yu) (mul_down_le xu yl) (mul_down_le xu yu). intros D1 D2 D3 D4.
  clearbody xl xu yl yu.
  repeat destruct Rlt_dec; apply M; trivial; clear M;
    try (generalize (Rmin_l (mul_down xl yu) (mul_down xu yl)) (Rmin_r (mul_down xl yu) (mul_down xu yl))
           (Rmax_l (RU (xl * yl)) (RU (xu * yu))) (Rmax_r (RU (xl * yl)) (RU (xu * yu))); intros);
    repeat split;
    first [ nra
          | assert (xl = 0) as -> by lra; assert (xu = 0) as -> by lra; lra
          | assert (yl = 0) as -> by lra; assert (yu = 0) as -> by lra; lra ].
Qed.

Theorem holds_square a x : holds a x -> holds (i_square a) (x * x).
Proof.
  intros [A A']. unfold i_square. cbv zeta. set (xl := lower a) in *. set (xu := upper a) in *.
  generalize (RU_ge (xl * xl)) (RU_ge (xu * xu)) (mul_down_le xl xl) (mul_down_le xu xu). intros.
  repeat destruct Rlt_dec; split; simpl; nra.
Qed.

(* What the templates are made of. *)
Inductive expr :=
  | Var (n : nat)
  | Plus (e f : expr)
  | Minus (e f : expr)
  | Times (e f : expr)
  | Opp (e : expr)
  | Square (e : expr)
  | Max (e f : expr).

Fixpoint exact (X : nat -> R) (e : expr) : R :=
  match e with
  | Var n => X n
  | Plus e f => exact X e + exact X f
  | Minus e f => exact X e - exact X f
  | Times e f => exact X e * exact X f
  | Opp e => - exact X e
  | Square e => exact X e * exact X e
  | Max e f => Rmax (exact X e) (exact X f)
  end.

Fixpoint computed (B : nat -> interval) (e : expr) : interval :=
  match e with
  | Var n => B n
  | Plus e f => i_add (computed B e) (computed B f)
  | Minus e f => i_sub (computed B e) (computed B f)
  | Times e f => i_mul (computed B e) (computed B f)
  | Opp e => i_opp (computed B e)
  | Square e => i_square (computed B e)
  | Max e f => i_max (computed B e) (computed B f)
  end.

Theorem encloses X B e : (forall n, holds (B n) (X n)) -> holds (computed B e) (exact X e).
Proof.
  intro H. induction e; simpl;
    auto using holds_add, holds_sub, holds_mul, holds_opp, holds_square, holds_max.
Qed.

(* The variables are coordinates, whose difference is an interval; `scaled_difference` multiplies it by powers of two. *)
Corollary encloses_coordinates X e : holds (computed (fun n => exactly (X n)) e) (exact X e).
Proof. apply encloses. intro. apply holds_exactly. Qed.

(* What interval_sign and backward conclude from the ends. *)
Corollary positive_certain X B e : (forall n, holds (B n) (X n)) -> 0 < lower (computed B e) -> 0 < exact X e.
Proof. intros H P. destruct (encloses X B e H). lra. Qed.
Corollary negative_certain X B e : (forall n, holds (B n) (X n)) -> upper (computed B e) < 0 -> exact X e < 0.
Proof. intros H P. destruct (encloses X B e H). lra. Qed.
End interval.
