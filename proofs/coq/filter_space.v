(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* algorithm_run.v with the certificates of space and the arithmetic of the code, as filter_plane.v for the plane: what is required of a verdict is what the
   filtered predicate answers, a number that is at most half the width of a tetrahedron or the tolerance of an empty sphere whose cells have records of their own
   (docs/theory.md 2.1, 2.2; sign_tolerance_3.v, own_tolerance_3).

   - least_first_turned     a cell has one name, however its corners are turned
   - verdict_evaluated_3    such a verdict promises what the model needs
   - space_filter_is_right  after any calls every tetrahedron is positive, every sphere empty, every ridge of the border convex

   Where a determinant is 0 the certificate may hold by a rule (degenerate.h): `tie`, any statement about the points. *)
Require Import Reals Lra Lia Psatz ZArith List Bool Arith.
From Annulus Require bicell tetrahedron sign_tolerance_3.
From Annulus Require Import vectors float_model filter_doubles space_mesh space_crossings space_delaunay.
From Annulus Require Import algorithm_list algorithm_filter algorithm_run filter_world.
Import ListNotations.
Open Scope R_scope.

(* ridge_3: u w is the edge; u w c and w u d are facets of the border, turning left as seen from within. sphere: q is left of a b c, p right of it. *)
Inductive certificate_3 := cell_3 (a b c d : nat) | ridge_3 (u w c d : nat) | sphere (a b c p q : nat).

Definition points_3 (c : certificate_3) : list nat :=
  match c with cell_3 a b c d | ridge_3 a b c d => [a; b; c; d] | sphere a b c p q => [a; b; c; p; q] end.

(* A cell is written with its least vertex first and the least of the others second, so that the sphere of a facet can name its two cells. *)
Definition least_second a b c d : certificate_3 :=
  if ((b <=? c) && (b <=? d))%nat then cell_3 a b c d else if ((c <=? b) && (c <=? d))%nat then cell_3 a c d b else cell_3 a d b c.
Definition least_first_3 a b c d : certificate_3 :=
  if ((a <=? b) && (a <=? c) && (a <=? d))%nat then least_second a b c d
  else if ((b <=? c) && (b <=? d))%nat then least_second b a d c
  else if (c <=? d)%nat then least_second c d a b else least_second d c b a.
Definition counts_on_3 (d c : certificate_3) : Prop :=
  match c with sphere a b c p q => d = least_first_3 a b c q \/ d = least_first_3 b a c p | _ => False end.

Theorem least_first_turned a b c d : NoDup [a; b; c; d] ->
  least_first_3 b c a d = least_first_3 a b c d /\ least_first_3 a c d b = least_first_3 a b c d.
Proof.
  intro N. assert (a <> b /\ a <> c /\ a <> d /\ b <> c /\ b <> d /\ c <> d) as (? & ? & ? & ? & ? & ?).
  { rewrite !NoDup_cons_iff in N. simpl in N. intuition congruence. }
  assert (E : forall k l, k <> l -> (l <=? k)%nat = negb (k <=? l)%nat) by (intros; destruct (Nat.leb_spec l k), (Nat.leb_spec k l); trivial; lia).
  unfold least_first_3, least_second.
  rewrite (E a b), (E a c), (E a d), (E b c), (E b d), (E c d) by assumption.
  repeat match goal with |- context [(?k <=? ?l)%nat] => destruct (Nat.leb_spec k l); cbn [andb negb]; try (split; reflexivity) end; exfalso; lia.
Qed.

Lemma least_first_cell a b c d : exists a' b' c' d', least_first_3 a b c d = cell_3 a' b' c' d'.
Proof.
  assert (K : forall a b c d, exists a' b' c' d', least_second a b c d = cell_3 a' b' c' d')
    by (intros; unfold least_second; destruct (_ && _)%bool; [|destruct (_ && _)%bool]; eauto).
  unfold least_first_3. destruct (_ && _ && _)%bool; [apply K|]. destruct (_ && _)%bool; [apply K|]. destruct (_ <=? _)%nat; apply K.
Qed.

Lemma counts_on_3_wf : well_founded counts_on_3.
Proof.
  assert (H : forall a b c d, Acc counts_on_3 (cell_3 a b c d)) by (intros; constructor; intros e []).
  assert (K : forall a b c d, Acc counts_on_3 (least_first_3 a b c d)) by (intros; destruct (least_first_cell a b c d) as (? & ? & ? & ? & ->); apply H).
  intros [a b c d|a b c d|a b c p q]; [apply H|constructor; intros e []|constructor]. intros e [->| ->]; apply K.
Qed.

Definition same_point_3 (p q : vec) : bool :=
  if Req_EM_T (X1 p) (X1 q) then if Req_EM_T (X2 p) (X2 q) then if Req_EM_T (X3 p) (X3 q) then true else false else false else false.
Lemma same_point_3_right p q : same_point_3 p q = true -> p = q.
Proof.
  unfold same_point_3. destruct (Req_EM_T _ _); [|discriminate]. destruct (Req_EM_T _ _); [|discriminate]. destruct (Req_EM_T _ _); [|discriminate].
  intros _. now apply vec_eq.
Qed.

Definition metric_3 : metric := {|
  site := vec; same_site := same_point_3; distance := dist_3; in_box := valid_3; read := path_length_3; is_below := below_3;
  same_site_right := same_point_3_right; distance_nonneg := fun p q => sqrt_pos _; distance_zero := distance_zero_3;
  distance_triangle := distance_triangle_3; read_above := path_length_above_3; threshold_holds := threshold_below_3 |}.

Definition orient_at (m : placement_3) a b c d : R := orient (m a) (m b) (m c) (m d).

Section space.
Variables (capacity : nat) (stamps : Z) (worn : R -> expiry_list -> bool).
Hypothesis stamps_pos : (0 < stamps)%Z.
Variable tie : certificate_3 -> placement_3 -> Prop.
Hypothesis tie_local : forall c m m', (forall v, In v (points_3 c) -> m v = m' v) -> tie c m -> tie c m'.

Definition holds_3 (c : certificate_3) (m : placement_3) : Prop :=
  match c with
  | cell_3 a b c d => 0 < orient_at m a b c d
  | ridge_3 u w p q => 0 < orient_at m u w p q \/ (orient_at m u w p q = 0 /\ tie c m)
  | sphere a b r p q => 0 < insphere_at m a b r p q \/ (insphere_at m a b r p q = 0 /\ tie c m)
  end.

Lemma holds_3_local c m m' : (forall v, In v (points_3 c) -> m v = m' v) -> holds_3 c m -> holds_3 c m'.
Proof.
  intro E. assert (T := tie_local c m m' E).
  destruct c as [a b c d|a b c d|a b c p q]; simpl; unfold orient_at, insphere_at; rewrite <- !E by (simpl; tauto); tauto.
Qed.

Definition family_3 : family vec := {|
  kind := certificate_3; points_of := points_3; is_true := holds_3; relies_on := counts_on_3 |}.

#[local] Instance space : world := numbered capacity stamps worn metric_3 family_3.
#[local] Instance space_laws : laws := numbered_laws capacity stamps worn metric_3 family_3 stamps_pos counts_on_3_wf holds_3_local.

Lemma positive_cell m a b c d : holds_3 (least_first_3 a b c d) m -> 0 < orient_at m a b c d.
Proof.
  assert (K : forall a b c d, holds_3 (least_second a b c d) m -> 0 < orient_at m a b c d).
  { clear. intros a b c d. unfold least_second, orient_at. destruct (_ && _)%bool; [trivial|].
    destruct (_ && _)%bool; simpl; unfold orient_at; intro H; apply Rlt_le_trans with (1 := H), Req_le; unfold orient; vector. }
  unfold least_first_3, orient_at. destruct (_ && _ && _)%bool; [apply K|]. destruct (_ && _)%bool; [|destruct (_ <=? _)%nat];
    intro H; apply K in H; apply Rlt_le_trans with (1 := H), Req_le; unfold orient_at, orient; vector.
Qed.

(* ---- What the filtered predicate answers ---- *)

Definition corners_at (x : placement_3) a b c d : tetrahedron.corners := fun k => x (point_of (a, b, c, d) k).
Definition bicell_at (x : placement_3) a b c p q : bicell.placement := fun k =>
  match k with bicell.a => x a | bicell.b => x b | bicell.c => x c | bicell.p => x p | bicell.q => x q end.
(* A sign, and a number: at most the truth, and 0 where the determinant is. *)
Definition answered_3 (x : placement_3) (k : verdict) : Prop :=
  0 <= bound k /\ F (bound k) /\
  match of k with
  | cell_3 a b c d | ridge_3 a b c d => 0 < orient_at x a b c d /\ bound k <= tetrahedron.half_width_simplex (corners_at x a b c d)
  | sphere a b c p q => 0 < orient_at x a b c q /\ 0 < orient_at x b a c p /\
      0 < insphere_at x a b c p q /\ bound k <= sign_tolerance_3.own_tolerance_3 (bicell_at x a b c p q)
  end \/
  (bound k = 0 /\ holds_3 (of k) x).

Lemma cells_of_bicell x a b c p q : bicell.lambda (bicell_at x a b c p q) bicell.p = orient_at x a b c q /\
  bicell.lambda (bicell_at x a b c p q) bicell.q = orient_at x b a c p.
Proof.
  unfold bicell.lambda, bicell.lambda_p, bicell.lambda_q, bicell.rel, bicell_at, orient_at. split; [reflexivity|].
  unfold orient. generalize (x a) (x b) (x c) (x p). vector.
Qed.

Lemma tetrahedron_sound x a b c d t m : 0 <= t -> 0 < orient_at x a b c d -> t <= tetrahedron.half_width_simplex (corners_at x a b c d) ->
  (forall v, In v [a; b; c; d] -> near m x t v) -> 0 < orient_at m a b c d.
Proof.
  intros T P H N. destruct (near_or_same _ _ _ metric_3 family_3 (cell_3 a b c d) m x t T N) as [D|E].
  - apply (tetrahedron.orientation_tolerance (corners_at x a b c d) (corners_at m a b c d) t P H). intro k. rewrite <- dist_3_norm.
    destruct k; unfold corners_at, point_of; apply D; simpl; tauto.
  - unfold orient_at. rewrite <- (E a), <- (E b), <- (E c), <- (E d) by (simpl; tauto). exact P.
Qed.

Lemma sphere_sound x a b c p q t m : 0 <= t -> 0 < orient_at x a b c q -> 0 < orient_at x b a c p -> 0 < insphere_at x a b c p q ->
  t <= sign_tolerance_3.own_tolerance_3 (bicell_at x a b c p q) -> (forall v, In v [a; b; c; p; q] -> near m x t v) ->
  0 < orient_at m a b c q -> 0 < orient_at m b a c p -> 0 < insphere_at m a b c p q.
Proof.
  intros T Q P S H N. destruct (near_or_same _ _ _ metric_3 family_3 (sphere a b c p q) m x t T N) as [D|E].
  - rewrite <- (proj1 (cells_of_bicell x a b c p q)) in Q. rewrite <- (proj2 (cells_of_bicell x a b c p q)) in P.
    rewrite <- (proj1 (cells_of_bicell m a b c p q)), <- (proj2 (cells_of_bicell m a b c p q)). intros Q' P'.
    apply (sign_tolerance_3.sign_tolerance_3_own (bicell_at x a b c p q) (bicell_at m a b c p q) t); trivial. intro k. rewrite <- dist_3_norm.
    destruct k; unfold bicell_at; apply D; simpl; tauto.
  - intros _ _. unfold insphere_at. rewrite <- (E a), <- (E b), <- (E c), <- (E p), <- (E q) by (simpl; tauto). exact S.
Qed.

Theorem verdict_evaluated_3 x k : answered_3 x k -> evaluated x k.
Proof.
  destruct k as [i c t]. unfold answered_3. cbn [of bound]. intros [(T & N & A)|(-> & H)].
  - assert (W : sound c x t).
    { destruct c as [a b c d|a b c d|a b c p q]; intros m M Cells.
      - now apply (tetrahedron_sound x a b c d t).
      - left. now apply (tetrahedron_sound x a b c d t).
      - left. destruct A as (Q & P & S & H). apply (sphere_sound x a b c p q t); trivial; apply positive_cell, Cells; [now left|now right]. }
    split; cbn [of bound]; trivial.
  - split; cbn [of bound]; [now apply (holds_sound _ _ _ metric_3 family_3 holds_3_local)|exact (Rle_refl 0)|exact F_0].
Qed.

Theorem space_filter_is_right s x m verdicts z :
  (nat -> (0 <= epoch s)%Z) -> (forall v, valid_3 (x v)) ->
  (forall k, In k verdicts -> m (id k) = Some (of k) /\ answered_3 x k) -> (forall i c, m i = Some c -> In i (map id verdicts)) ->
  (forall i c, m i = Some c -> is_id i) -> (forall i c d, m i = Some c -> counts_on_3 d c -> exists j, m j = Some d) ->
  calls {| of_filter := recompute x s m verdicts; tracks := true |} z ->
  forall i c, mesh (of_filter z) i = Some c -> holds_3 c (moving (of_filter z)).
Proof.
  intros E X K A I C R.
  apply (evaluated_holds _ _ _ metric_3 family_3 stamps_pos counts_on_3_wf holds_3_local s x m verdicts z); trivial.
  intros k H. destruct (K k H). split; [assumption|now apply verdict_evaluated_3].
Qed.
End space.
