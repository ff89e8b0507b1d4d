(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* algorithm_run.v with the certificates of the plane and the arithmetic of the code: nothing of `world` and `laws` is left to believe, and what
   is asked of a verdict is what the ladder answers, a number that is at most half a least altitude or half a width (docs/theory.md 2.1, 2.2).

   - verdict_evaluated      such a verdict promises what the model needs: also a width that two sides share (unequal moves)
   - kept_circle_certifies  a safe region: how far the points are from a circle that is kept
   - plane_filter_is_right  after any calls every triangle is positive, every circle empty, every ridge of the border convex
   - plane_filter_alone_is_right   the same without second looks, where nothing is left but what Repair promises

   Vertices are numbers. A cell is written with its least vertex first, so that the circle of a facet can name its two cells. Where a determinant is 0 the
   certificate may hold by a rule (degenerate.h: the perturbation, a border that does not fold back): `tie`, any statement about the points. *)
Require Import Reals Lra Psatz ZArith Rgeom List Bool Arith.
From Annulus Require Import points_2 float_model float_displacement float_sums width_2 sign_tolerance_2 high_word filter_doubles.
From Annulus Require Import algorithm_list algorithm_filter algorithm_look algorithm_run filter_world.
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
  site := point_2; same_site := same_point; distance := dist_2; in_box := valid_2; read := reading_2; is_below := below_2;
  same_site_right := same_point_right; distance_nonneg := fun p q => sqrt_pos _; distance_zero := distance_zero_2;
  distance_triangle := distance_triangle_2; read_above := reading_above_2; threshold_holds := threshold_below_2 |}.

Section plane.
Variables (capacity : nat) (stamps : Z) (worn : R -> expiry_list -> bool) (chosen : second_looks).
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
  kind := certificate_2; points_of := points_2; is_true := holds_2; relies_on := counts_on_2;
  of_two_sides := fun c => match c with circle _ _ _ _ => true | _ => false end;
  on_inner_side := fun c v => match c with circle a b _ _ => (v =? a)%nat || (v =? b)%nat | _ => false end |}.

#[local] Instance plane : world := numbered capacity stamps worn chosen metric_2 family_2.
#[local] Instance plane_laws : laws := numbered_laws capacity stamps worn chosen metric_2 family_2 stamps_pos counts_on_2_wf holds_2_local.

Definition moved (m x : nat -> point_2) v : R := dist_euc (fst (m v)) (snd (m v)) (fst (x v)) (snd (x v)).

Lemma moved_pos m x v : 0 <= moved m x v.
Proof. apply sqrt_pos. Qed.
Lemma near_moved m x (e : nat -> R) v : near m x e v -> moved m x v < e v \/ (m v = x v /\ moved m x v = 0).
Proof.
  intros [N|N]; [left; exact N|right]. split; [exact N|]. unfold moved. rewrite N. apply distance_refl.
Qed.

Lemma cell_of_circle a b c m : holds_2 (least_first a b c) m -> 0 < turn_at m a b c.
Proof.
  unfold least_first. destruct (_ && _)%bool; [trivial|]. destruct (_ && _)%bool; simpl; unfold turn_at, turning, turn; lra.
Qed.

(* ---- What the ladder answers ---- *)

Definition half_altitude_at (x : nat -> point_2) a b c : R := half_altitude (fst (x a)) (snd (x a)) (fst (x b)) (snd (x b)) (fst (x c)) (snd (x c)).
Definition half_width_at (x : nat -> point_2) a b p q : R :=
  half_width_2 (fst (x a)) (snd (x a)) (fst (x b)) (snd (x b)) (fst (x p)) (snd (x p)) (fst (x q)) (snd (x q)).
(* A sign, and a number: at most the truth, and 0 where the determinant is. *)
Definition answered (x : nat -> point_2) (k : verdict) : Prop :=
  0 <= bound k /\ F (bound k) /\ holds_2 (of k) x /\
  match of k with
  | cell a b c | ridge a b c => 0 < turn_at x a b c /\ bound k <= half_altitude_at x a b c
  | circle a b p q => NoDup [a; b; p; q] /\ 0 < turn_at x a b q /\ 0 < turn_at x b a p /\
      0 < incircle_at x a b p q /\ bound k <= half_width_at x a b p q
  end \/
  (bound k = 0 /\ holds_2 (of k) x /\ match of k with circle a b p q => NoDup [a; b; p; q] | _ => True end).

Lemma triangle_sound x a b c t m : 0 <= t -> 0 < turn_at x a b c -> t <= half_altitude_at x a b c ->
  (forall v, In v [a; b; c] -> near m x (fun _ => t) v) -> 0 < turn_at m a b c.
Proof.
  intros T P H N. destruct (near_or_same _ _ _ _ metric_2 family_2 (cell a b c) m x t T N) as [D|E].
  - apply (orientation_tolerance_2 _ _ _ _ _ _ P _ _ _ _ _ _ t H); [apply (D a)|apply (D b)|apply (D c)]; simpl; tauto.
  - unfold turn_at. rewrite <- (E a), <- (E b), <- (E c) by (simpl; tauto). exact P.
Qed.

Section circles.
Variables (x : nat -> point_2) (a b p q : nat).
Hypothesis different : NoDup [a; b; p; q].

Lemma sides_of : inside (circle a b p q) a = true /\ inside (circle a b p q) b = true /\
  inside (circle a b p q) p = false /\ inside (circle a b p q) q = false.
Proof.
  inversion different as [|? ? Na Nb']; subst. inversion Nb' as [|? ? Nb Np]; subst. simpl in *.
  rewrite !Nat.eqb_refl, orb_true_r. repeat split; apply orb_false_iff; rewrite !Nat.eqb_neq; intuition congruence.
Qed.

(* With nothing to share all are at their references. *)
Lemma nothing_to_share (e : nat -> R) m : (forall v, In v [a; b; p; q] -> 0 <= e v) ->
  (forall v w, In v [a; b; p; q] -> In w [a; b; p; q] -> inside (circle a b p q) v = true -> inside (circle a b p q) w = false -> e v + e w <= 2 * 0) ->
  (forall v, In v [a; b; p; q] -> near m x e v) -> forall v, In v [a; b; p; q] -> x v = m v.
Proof.
  intros P S N v V. destruct sides_of as (Ia & Ib & Ip & Iq).
  assert (Z : e v = 0).
  { generalize (P v V). intro. assert (Pa := P a ltac:(simpl; tauto)). assert (Pp := P p ltac:(simpl; tauto)).
    destruct (@inside plane (circle a b p q) v) eqn:I.
    - generalize (S v p V ltac:(simpl; tauto) I Ip). lra.
    - generalize (S a v ltac:(simpl; tauto) V Ia I). lra. }
  destruct (near_moved _ _ _ _ (N v V)) as [K|[K _]]; [generalize (moved_pos m x v); lra|now symmetry].
Qed.

Theorem circle_wide t : 0 <= t -> 0 < turn_at x a b q -> 0 < turn_at x b a p -> 0 < incircle_at x a b p q -> t <= half_width_at x a b p q ->
  wide (circle a b p q) x t.
Proof.
  intros T Tq Tp E H e P S m N K. change (@points plane (circle a b p q)) with [a; b; p; q] in *. left.
  assert (Mq : 0 < turn_at m a b q) by (apply cell_of_circle, K; now left).
  assert (Mp : 0 < turn_at m b a p) by (apply cell_of_circle, K; now right).
  destruct (Rle_lt_or_eq_dec 0 t T) as [T'|T'].
  - destruct sides_of as (Ia & Ib & Ip & Iq).
    assert (L : forall v w, In v [a; b; p; q] -> In w [a; b; p; q] -> @inside plane (circle a b p q) v = true -> @inside plane (circle a b p q) w = false ->
      moved m x v + moved m x w < 2 * t).
    { intros v w V V' I I'. generalize (S v w V V' I I') (P v V) (P w V').
      destruct (near_moved _ _ _ _ (N v V)) as [|[_ ->]], (near_moved _ _ _ _ (N w V')) as [|[_ ->]]; lra. }
    set (da := Rmax (moved m x a) (moved m x b)). set (dp := Rmax (moved m x p) (moved m x q)).
    assert (Sum : da + dp < 2 * t).
    { unfold da, dp, Rmax. repeat destruct (Rle_dec _ _); apply L; simpl; tauto. }
    set (r := (2 * t - (da + dp)) / 2).
    assert (A : moved m x a <= da /\ moved m x b <= da) by (unfold da; split; [apply Rmax_l|apply Rmax_r]).
    assert (B : moved m x p <= dp /\ moved m x q <= dp) by (unfold dp; split; [apply Rmax_l|apply Rmax_r]).
    unfold moved in A, B.
    apply (circle_certified_2 _ _ _ _ _ _ _ _ Tq Tp E _ _ _ _ _ _ _ _ Mq Mp (da + r) (dp + r)); unfold r; try lra.
    fold (half_width_at x a b p q). lra.
  - subst t. unfold incircle_at in *. rewrite <- !(nothing_to_share e m P S N) by (simpl; tauto). exact E.
Qed.

Theorem tie_wide : holds_2 (circle a b p q) x -> wide (circle a b p q) x 0.
Proof. intros H e P S m N _. apply (holds_2_local _ x); [|exact H]. exact (nothing_to_share e m P S N). Qed.

(* A circle with centre o: each of the inner points may go as far as it is from it, and each of the outer ones. *)
Theorem kept_circle_certifies (o : point_2) r (e : nat -> R) :
  let far v := dist_euc (fst (x v)) (snd (x v)) (fst o) (snd o) in
  far a + e a <= r -> far b + e b <= r -> r <= far p - e p -> r <= far q - e q ->
  (forall v, In v [a; b; p; q] -> 0 < e v) -> sound (circle a b p q) x e.
Proof.
  intros far A B P Q Pos m N K. change (@points plane (circle a b p q)) with [a; b; p; q] in *. left.
  assert (Mq : 0 < turn_at m a b q) by (apply cell_of_circle, K; now left).
  assert (Mp : 0 < turn_at m b a p) by (apply cell_of_circle, K; now right).
  assert (D : forall v, In v [a; b; p; q] -> moved m x v < e v).
  { intros v V. generalize (Pos v V). destruct (near_moved _ _ _ _ (N v V)) as [|[_ ->]]; lra. }
  assert (In' : forall v, In v [a; b; p; q] -> dist_euc (fst (m v)) (snd (m v)) (fst o) (snd o) < far v + e v).
  { intros v V. generalize (triangle (fst (m v)) (snd (m v)) (fst o) (snd o) (fst (x v)) (snd (x v))) (D v V). unfold moved, far. lra. }
  assert (Out : forall v, In v [a; b; p; q] -> far v - e v < dist_euc (fst (m v)) (snd (m v)) (fst o) (snd o)).
  { intros v V. generalize (triangle (fst (x v)) (snd (x v)) (fst o) (snd o) (fst (m v)) (snd (m v))) (D v V).
    unfold moved, far. rewrite (distance_symm (fst (x v)) (snd (x v)) (fst (m v)) (snd (m v))). lra. }
  assert (Ia := In' a ltac:(simpl; tauto)). assert (Ib := In' b ltac:(simpl; tauto)).
  assert (Op := Out p ltac:(simpl; tauto)). assert (Oq := Out q ltac:(simpl; tauto)).
  assert (Ra : 0 <= dist_euc (fst (m a)) (snd (m a)) (fst o) (snd o)) by apply sqrt_pos.
  (* the placement is its own reference, with nothing moved by the least distance to the circle *)
  set (w := Rmin (Rmin (r - dist_euc (fst (m a)) (snd (m a)) (fst o) (snd o)) (r - dist_euc (fst (m b)) (snd (m b)) (fst o) (snd o)))
                 (Rmin (dist_euc (fst (m p)) (snd (m p)) (fst o) (snd o) - r) (dist_euc (fst (m q)) (snd (m q)) (fst o) (snd o) - r))).
  assert (W : 0 < w) by (unfold w, Rmin; repeat destruct (Rle_dec _ _); lra).
  assert (W' : w <= r - dist_euc (fst (m a)) (snd (m a)) (fst o) (snd o) /\ w <= r - dist_euc (fst (m b)) (snd (m b)) (fst o) (snd o) /\
               w <= dist_euc (fst (m p)) (snd (m p)) (fst o) (snd o) - r /\ w <= dist_euc (fst (m q)) (snd (m q)) (fst o) (snd o) - r)
    by (unfold w, Rmin; repeat destruct (Rle_dec _ _); lra).
  apply (annulus_certifies _ _ _ _ _ _ _ _ (fst (m a)) (snd (m a)) (fst (m b)) (snd (m b)) (fst (m p)) (snd (m p)) (fst (m q)) (snd (m q))
    (fst o) (snd o) (r - w) (r + w) w w); try lra; try exact Mq; try exact Mp; rewrite distance_refl; exact W.
Qed.
End circles.

Theorem verdict_evaluated x k : answered x k -> evaluated x k.
Proof.
  destruct k as [i c t]. unfold answered. cbn [of bound]. intros [(T & N & H & A)|(-> & H & D)].
  - assert (W : match c with circle _ _ _ _ => wide c x t | _ => sound c x (fun _ => t) end).
    { destruct c as [a b c|a b c|a b p q].
      - intros m M _. now apply (triangle_sound x a b c t).
      - intros m M _. left. now apply (triangle_sound x a b c t).
      - now apply circle_wide. }
    split; cbn [of bound]; trivial; destruct c; try discriminate; trivial. now apply (of_wide _ _ _ _ metric_2 family_2).
  - assert (W := holds_sound _ _ _ _ metric_2 family_2 holds_2_local c x H).
    split; cbn [of bound]; trivial; [|exact (Rle_refl 0)|exact F_0]. destruct c as [| |a b p q]; try discriminate. intros _. now apply tie_wide.
Qed.

(* Whatever is found by second looks, repaired, inserted, settled in between. *)
Theorem plane_filter_is_right second_look s x m verdicts z : second_look_right second_look ->
  (nat -> (0 <= epoch s)%Z) -> (forall v, valid_2 (x v)) ->
  (forall k, In k verdicts -> m (id k) = Some (of k) /\ answered x k) -> (forall i c, m i = Some c -> In i (map id verdicts)) ->
  (forall i c, m i = Some c -> is_id i) -> (forall i c d, m i = Some c -> counts_on_2 d c -> exists j, m j = Some d) ->
  calls second_look {| of_filter := settle x s m verdicts; tracks := true |} z ->
  forall i c, mesh (of_filter z) i = Some c -> holds_2 c (moving (of_filter z)).
Proof.
  intros L E X K A I C R. apply (evaluated_holds _ _ _ _ metric_2 family_2 stamps_pos counts_on_2_wf holds_2_local second_look s x m verdicts z); trivial.
  intros k H. destruct (K k H). split; [assumption|now apply verdict_evaluated].
Qed.

(* Without second looks, which is how it comes, they promise nothing. *)
Corollary plane_filter_alone_is_right s x m verdicts z :
  (nat -> (0 <= epoch s)%Z) -> (forall v, valid_2 (x v)) ->
  (forall k, In k verdicts -> m (id k) = Some (of k) /\ answered x k) -> (forall i c, m i = Some c -> In i (map id verdicts)) ->
  (forall i c, m i = Some c -> is_id i) -> (forall i c d, m i = Some c -> counts_on_2 d c -> exists j, m j = Some d) ->
  calls (fun _ _ _ => None) {| of_filter := settle x s m verdicts; tracks := true |} z ->
  forall i c, mesh (of_filter z) i = Some c -> holds_2 c (moving (of_filter z)).
Proof. apply plane_filter_is_right, without_second_looks. Qed.
End plane.
