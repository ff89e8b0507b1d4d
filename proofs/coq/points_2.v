(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Points of the plane that have names, and their determinants. *)
Require Import Reals.
From Annulus Require Import width_2.
Open Scope R_scope.

Definition point_2 : Type := R * R.

(* Twice the signed area of u v w: positive when w is on the left of uv. *)
Definition turning (u v w : point_2) : R := turn (fst u) (snd u) (fst v) (snd v) (fst w) (snd w).
Definition turn_at (m : nat -> point_2) a b c : R := turning (m a) (m b) (m c).
(* Positive when p is outside the circle of a, b, q and q outside that of b, a, p: q left of ab, p right. *)
Definition incircle_at (m : nat -> point_2) a b p q : R :=
  incircle (fst (m a)) (snd (m a)) (fst (m b)) (snd (m b)) (fst (m p)) (snd (m p)) (fst (m q)) (snd (m q)).
