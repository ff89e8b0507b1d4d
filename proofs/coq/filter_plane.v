(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* algorithm_run.v with the certificates of the plane and the arithmetic of the code: nothing of `world` and `laws` is left to believe, and what
   is required of a verdict is what the filtered predicate answers, a number that is at most half a least altitude or half a width (docs/theory.md 2.1, 2.2).

   - verdict_evaluated      such a verdict promises what the model needs
   - plane_filter_is_right  after any calls every triangle is positive, every circle empty, every ridge of the border convex

   Vertices are numbers. A cell is written with its least vertex first, so that the circle of a facet can name its two cells. Where a determinant is 0 the
   certificate may hold by a rule (degenerate.h: the perturbation, a border that does not fold back): `tie`, any statement about the points. *)
Require Import Reals Lra Psatz ZArith Rgeom List Bool Arith.
From Annulus Require Import points_2 float_model float_displacement float_sums width_2 sign_tolerance_2 truncated_double filter_doubles.
From Annulus Require Import algorithm_list algorithm_filter algorithm_check algorithm_run filter_world.
Import ListNotations.
Open Scope R_scope.

Inductive certificate_2 := cell (a b c : nat) | ridge (a b c : nat) | circle (a b p q : nat).   (* circle: q left of ab, p right *)

Definition points_2 (c : certificate_2) : list nat :=
  match c with cell a b c | ridge a b c => [a; b; c] | circle a b p q => [a; b; p; q] end.
Definition least_first a b c : certificate_2 :=
  if ((a <=? b) && (a <=? c))%nat then cell a b c else if ((b <=? a) && (b <=? c))%nat then cell b c a else cell c a b.
Definition counts_on_2 (d c : certificate_2) : Prop :=
  match c with circle a b p q => d = least_first a b q \/ d = least_first b a p | _ => False end.

Definition same_point (p q : point_2) : bool := if Req_EM_T (fst p) (fst q) then if Req_EM_T (snd p) (snd q) then true else false else false.
Lemma same_point_right p q : same_point p q = true -> p = q.
Proof.
  destruct p as [a b], q as [c d]. unfold same_point. simpl. destruct (Req_EM_T a c) as [->|]; [|discriminate].
  now destruct (Req_EM_T b d) as [->|].
Qed.

Lemma counts_on_2_wf : well_founded counts_on_2.
Proof.
  assert (H : forall a b c, Acc counts_on_2 (cell a b c)) by (intros; constructor; intros d []).
  assert (K : forall a b c, Acc counts_on_2 (least_first a b c)).
  { intros. unfold least_first. destruct (_ && _)%bool; [apply H|]. destruct (_ && _)%bool; apply H. }
  intros [a b c|a b c|a b p q]; [apply H|constructor; intros d []|constructor]. intros d [->| ->]; apply K.
Qed.

Definition metric_2 : metric := {|
  site := point_2; same_site := same_point; distance := dist_2; in_box := valid_2; read := path_length_2; is_below := below_2;
  same_site_right := same_point_right; distance_nonneg := fun p q => sqrt_pos _; distance_zero := distance_zero_2;
  distance_triangle := distance_triangle_2; read_above := path_length_above_2; threshold_holds := threshold_below_2 |}.

Section plane.
Variables (capacity : nat) (stamps : Z) (worn : R -> expiry_list -> bool).
Hypothesis stamps_pos : (0 < stamps)%Z.
Variable tie : certificate_2 -> (nat -> point_2) -> Prop.
Hypothesis tie_local : forall c m m', (forall v, In v (points_2 c) -> m v = m' v) -> tie c m -> tie c m'.

Definition holds_2 (c : certificate_2) (m : nat -> point_2) : Prop :=
  match c with
  | cell a b c => 0 < turn_at m a b c
  | ridge a b r => 0 < turn_at m a b r \/ (turn_at m a b r = 0 /\ tie c m)
  | circle a b p q => 0 < incircle_at m a b p q \/ (incircle_at m a b p q = 0 /\ tie c m)
  end.

Lemma holds_2_local c m m' : (forall v, In v (points_2 c) -> m v = m' v) -> holds_2 c m -> holds_2 c m'.
Proof.
  intro E. assert (T := tie_local c m m' E).
  destruct c as [a b c|a b c|a b p q]; simpl; unfold turn_at, incircle_at; rewrite <- !E by (simpl; tauto); tauto.
Qed.

Definition family_2 : family point_2 := {|
  kind := certificate_2; points_of := points_2; is_true := holds_2; relies_on := counts_on_2 |}.

#[local] Instance plane : world := numbered capacity stamps worn metric_2 family_2.
#[local] Instance plane_laws : laws := numbered_laws capacity stamps worn metric_2 family_2 stamps_pos counts_on_2_wf holds_2_local.

Lemma cell_of_circle a b c m : holds_2 (least_first a b c) m -> 0 < turn_at m a b c.
Proof.
  unfold least_first. destruct (_ && _)%bool; [trivial|]. destruct (_ && _)%bool; simpl; unfold turn_at, turning, turn; lra.
Qed.

(* ---- What the filtered predicate answers ---- *)

Definition half_altitude_at (x : nat -> point_2) a b c : R := half_altitude (fst (x a)) (snd (x a)) (fst (x b)) (snd (x b)) (fst (x c)) (snd (x c)).
Definition half_width_at (x : nat -> point_2) a b p q : R :=
  half_width_2 (fst (x a)) (snd (x a)) (fst (x b)) (snd (x b)) (fst (x p)) (snd (x p)) (fst (x q)) (snd (x q)).
(* A sign, and a number: at most the truth, and 0 where the determinant is. *)
Definition answered (x : nat -> point_2) (k : verdict) : Prop :=
  0 <= bound k /\ F (bound k) /\ holds_2 (of k) x /\
  match of k with
  | cell a b c | ridge a b c => 0 < turn_at x a b c /\ bound k <= half_altitude_at x a b c
  | circle a b p q => 0 < turn_at x a b q /\ 0 < turn_at x b a p /\ 0 < incircle_at x a b p q /\ bound k <= half_width_at x a b p q
  end \/
  (bound k = 0 /\ holds_2 (of k) x).

Lemma triangle_sound x a b c t m : 0 <= t -> 0 < turn_at x a b c -> t <= half_altitude_at x a b c ->
  (forall v, In v [a; b; c] -> near m x t v) -> 0 < turn_at m a b c.
Proof.
  intros T P H N. destruct (near_or_same _ _ _ metric_2 family_2 (cell a b c) m x t T N) as [D|E].
  - apply (orientation_tolerance_2 _ _ _ _ _ _ P _ _ _ _ _ _ t H); [apply (D a)|apply (D b)|apply (D c)]; simpl; tauto.
  - unfold turn_at. rewrite <- (E a), <- (E b), <- (E c) by (simpl; tauto). exact P.
Qed.

Lemma circle_sound x a b p q t m : 0 <= t -> 0 < turn_at x a b q -> 0 < turn_at x b a p -> 0 < incircle_at x a b p q -> t <= half_width_at x a b p q ->
  (forall v, In v [a; b; p; q] -> near m x t v) -> 0 < turn_at m a b q -> 0 < turn_at m b a p -> 0 < incircle_at m a b p q.
Proof.
  intros T Tq Tp P H N Mq Mp. destruct (near_or_same _ _ _ metric_2 family_2 (circle a b p q) m x t T N) as [D|E].
  - apply (circle_tolerance_2 _ _ _ _ _ _ _ _ Tq Tp P _ _ _ _ _ _ _ _ Mq Mp t H); [apply (D a)|apply (D b)|apply (D p)|apply (D q)]; simpl; tauto.
  - unfold incircle_at in *. rewrite <- (E a), <- (E b), <- (E p), <- (E q) by (simpl; tauto). exact P.
Qed.

Theorem verdict_evaluated x k : answered x k -> evaluated x k.
Proof.
  destruct k as [i c t]. unfold answered. cbn [of bound]. intros [(T & N & H & A)|(-> & H)].
  - assert (W : sound c x t).
    { destruct c as [a b c|a b c|a b p q]; intros m M Cells.
      - now apply (triangle_sound x a b c t).
      - left. now apply (triangle_sound x a b c t).
      - left. destruct A as (Tq & Tp & P & A). apply (circle_sound x a b p q t); trivial; apply cell_of_circle, Cells; [now left|now right]. }
    split; cbn [of bound]; trivial.
  - split; cbn [of bound]; [now apply (holds_sound _ _ _ metric_2 family_2 holds_2_local)|exact (Rle_refl 0)|exact F_0].
Qed.

(* Whatever is repaired, inserted, recomputed in between. *)
Theorem plane_filter_is_right s x m verdicts z :
  (nat -> (0 <= epoch s)%Z) -> (forall v, valid_2 (x v)) ->
  (forall k, In k verdicts -> m (id k) = Some (of k) /\ answered x k) -> (forall i c, m i = Some c -> In i (map id verdicts)) ->
  (forall i c, m i = Some c -> is_id i) -> (forall i c d, m i = Some c -> counts_on_2 d c -> exists j, m j = Some d) ->
  calls {| of_filter := recompute x s m verdicts; tracks := true |} z ->
  forall i c, mesh (of_filter z) i = Some c -> holds_2 c (moving (of_filter z)).
Proof.
  intros E X K A I C R. apply (evaluated_holds _ _ _ metric_2 family_2 stamps_pos counts_on_2_wf holds_2_local s x m verdicts z); trivial.
  intros k H. destruct (K k H). split; [assumption|now apply verdict_evaluated].
Qed.
End plane.
