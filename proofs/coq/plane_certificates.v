(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What the filter keeps true (filter_plane.v) and what makes a mesh Delaunay (plane_delaunay.v) are the same certificates.

   - flat_ridge             the rule of the code for a ridge whose determinant is 0 (degenerate.h): its vertex is strictly between its neighbours
   - certificates_delaunay  all certificates of a mesh hold and its border winds once: then it is a triangulation, and Delaunay *)
Require Import Reals Lra Psatz ZArith List.
From Annulus Require Import points_2 filter_plane plane_mesh plane_triangulation plane_delaunay.
Import ListNotations.
Open Scope R_scope.

(* Ties: a border may not fold back; of four points on a circle either diagonal will do, whatever the perturbation prefers. *)
Definition no_fold (c : certificate_2) (m : placement) : Prop :=
  match c with ridge u v w => 0 < dot (vector (m u) (m v)) (vector (m v) (m w)) | _ => True end.

Definition certificates (T : mesh) : list certificate_2 :=
  map (fun t => let '(a, b, c) := t in least_first a b c) (cells T) ++
  map (fun r => let '(u, v, w) := r in ridge u v w) (ridges (border T)) ++
  map (fun k => let '(a, b, p, q) := k in circle a b p q) (bicells T).

(* What filter_plane.v requires of ties. *)
Lemma no_fold_local c m m' : (forall v, In v (points_2 c) -> m v = m' v) -> no_fold c m -> no_fold c m'.
Proof. intro E. destruct c as [|u v w|]; simpl in *; trivial. rewrite <- !E by tauto. trivial. Qed.

Definition before (u v : point_2) : Prop := fst u < fst v \/ (fst u = fst v /\ snd u < snd v).

Definition to_right (e : point_2) : Prop := 0 < fst e \/ (fst e = 0 /\ 0 < snd e).
Definition to_left (e : point_2) : Prop := fst e < 0 \/ (fst e = 0 /\ snd e < 0).

Lemma before_right u v : before u v <-> to_right (vector u v).
Proof. unfold before, to_right, vector. cbn [fst snd]. split; (intros [H|[H K]]; [left|right]; lra). Qed.
Lemma before_left u v : before v u <-> to_left (vector u v).
Proof. unfold before, to_left, vector. cbn [fst snd]. split; (intros [H|[H K]]; [left|right]; lra). Qed.

Lemma same_side e f : cross e f = 0 -> (0 < dot e f <-> (to_right e /\ to_right f) \/ (to_left e /\ to_left f)).
Proof.
  unfold cross, dot, to_right, to_left. destruct e as [x y], f as [p q]. cbn [fst snd]. intro C.
  assert (X : x * (x * p + y * q) = p * (x * x + y * y))
    by (replace (x * (x * p + y * q)) with (p * (x * x + y * y) + y * (x * q - y * p)) by ring; rewrite C; ring).
  assert (Y : y * (x * p + y * q) = q * (x * x + y * y))
    by (replace (y * (x * p + y * q)) with (q * (x * x + y * y) - x * (x * q - y * p)) by ring; rewrite C; ring).
  split.
  - intro D. destruct (Rtotal_order x 0) as [L|[->|L]].
    + right. assert (p < 0) by nra. split; now left.
    + assert (P : p = 0 \/ y = 0) by (apply Rmult_integral; lra). destruct (Rtotal_order y 0) as [K|[->|K]]; [|lra|].
      * right. destruct P as [->|P]; [|lra]. assert (q < 0) by nra. split; right; split; trivial.
      * left. destruct P as [->|P]; [|lra]. assert (0 < q) by nra. split; right; split; trivial.
    + left. assert (0 < p) by nra. split; now left.
  - intros [[[U|[-> U]] [V|[-> V]]]|[[U|[-> U]] [V|[-> V]]]]; try nra.
    + assert (0 < p * (x * x + y * y)) by (apply Rmult_lt_0_compat; nra). nra.
    + assert (0 < - p * (x * x + y * y)) by (apply Rmult_lt_0_compat; nra). nra.
Qed.

Lemma flat_ridge u v w : turning u v w = 0 ->
  (0 < dot (vector u v) (vector v w) <-> (before u v /\ before v w) \/ (before w v /\ before v u)).
Proof.
  intro Z.
  rewrite (same_side (vector u v) (vector v w)), (before_right u v), (before_right v w), (before_left v w), (before_left u v),
    (and_comm (to_left (vector v w))); [reflexivity|].
  rewrite <- Z. unfold cross, vector, turning, width_2.turn. cbn [fst snd]. ring.
Qed.

Lemma certificates_convex T (mesh : Z -> option certificate_2) m :
  (forall c, In c (certificates T) -> exists i, mesh i = Some c) -> (forall i c, mesh i = Some c -> holds_2 no_fold c m) -> convex m (border T).
Proof.
  intros A H u v w I. destruct (A (ridge u v w)) as (i & E); [|exact (H i _ E)].
  apply in_or_app. right. apply in_or_app. left. apply in_map_iff. now exists (u, v, w).
Qed.

(* The first hypothesis but one is what plane_filter_is_right says, with the tie no_fold; the last one is checked, or known from plane_motion.v. *)
Theorem certificates_delaunay T (mesh : Z -> option certificate_2) m : glued T ->
  (forall c, In c (certificates T) -> exists i, mesh i = Some c) -> (forall i c, mesh i = Some c -> holds_2 no_fold c m) ->
  winds_once m (border T) -> triangulation m T /\ delaunay m T.
Proof.
  intros G A H W. assert (K : forall c, In c (certificates T) -> holds_2 no_fold c m) by (intros c I; destruct (A c I) as (i & E); now apply (H i)).
  assert (P : positive m T).
  { intros a b c I. apply (cell_of_circle no_fold), K. apply in_or_app. left. apply in_map_iff. now exists (a, b, c). }
  assert (C := certificates_convex T mesh m A H).
  split; [now apply plane_triangulation|]. apply plane_delaunay; trivial. intros a b p q I.
  assert (Q : holds_2 no_fold (circle a b p q) m)
    by (apply K, in_or_app; right; apply in_or_app; right; apply in_map_iff; now exists (a, b, p, q)).
  simpl in Q. destruct Q as [Q|[Q _]]; [now apply Rlt_le | rewrite Q; apply Rle_refl].
Qed.
