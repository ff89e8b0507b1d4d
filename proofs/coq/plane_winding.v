(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* How often a convex border winds does not change along a continuous motion: docs/theory.md 1.3, the proposition in the plane.

   - any_direction   the border enters the half-plane left of the direction (k, 1) as often as the upper one
   - clockwise       walked the other way round, as border_2.cpp does, it enters the upper half-plane as often
   - winding_kept    convex all along the motion and winding once at its beginning, it winds once at its end

   The number of entries is compared in a direction that no edge has at the moment: there it does not change for a while. *)
Require Import Reals Lra Psatz List Permutation Bool Arith.
From Annulus Require Import sums small width_2 plane_mesh plane_paths plane_border.
Import ListNotations.
Open Scope R_scope.

(* ---- Two half-planes ---- *)

(* On the left of (k, 1), or along it. *)
Definition leans (k : R) (u v : point_2) : bool :=
  if Rlt_dec (fst (vector u v)) (k * snd (vector u v)) then true
  else if Req_EM_T (fst (vector u v)) (k * snd (vector u v)) then if Rlt_dec 0 (snd (vector u v)) then true else false else false.
Definition enters_left (k : R) (m : placement) (r : nat * nat * nat) : bool :=
  let '(u, v, w) := r in negb (leans k (m u) (m v)) && leans k (m v) (m w).

Definition one_if (b : bool) : R := if b then 1 else 0.

Lemma count_sum {S : Type} (f : S -> bool) l : INR (length (filter f l)) = sum (fun s => one_if (f s)) l.
Proof.
  induction l as [|s l IH]; [reflexivity|]. cbn [filter]. rewrite sum_cons, <- IH. destruct (f s); cbn [length one_if]; [rewrite S_INR|]; ring.
Qed.

(* The quarter between the two directions, which is in the upper half-plane only. *)
Definition between (k : R) (u v : point_2) : R := one_if (points_up u v && negb (leans k u v)).

(* The four quarters of the plane between the directions. *)
Lemma quarters k u v : fst u <> fst v \/ snd u <> snd v ->
  let up := points_up u v in let left := leans k u v in let y := snd (vector u v) in let x := fst (vector u v) - k * y in
  (up = true /\ left = false /\ 0 < x /\ 0 <= y) \/ (up = true /\ left = true /\ x <= 0 /\ 0 < y) \/
  (up = false /\ left = true /\ x < 0 /\ y <= 0) \/ (up = false /\ left = false /\ 0 <= x /\ y < 0).
Proof.
  intros N. cbv zeta. unfold points_up, leans, vector. cbn [fst snd].
  assert (Z : snd u = snd v -> k * (snd v - snd u) = 0) by (intros ->; ring). revert Z. generalize (k * (snd v - snd u)). intros p Z.
  destruct (Rlt_dec (snd u) (snd v)); [|destruct (Req_EM_T (snd u) (snd v)) as [V|V]; [specialize (Z V); destruct (Rlt_dec (fst u) (fst v))|]];
    (destruct (Rlt_dec (fst v - fst u) p); [|destruct (Req_EM_T (fst v - fst u) p); [destruct (Rlt_dec 0 (snd v - snd u))|]]); lra.
Qed.

Lemma convex_vectors m u v w : convex_at m u v w -> (fst (m u) <> fst (m v) \/ snd (m u) <> snd (m v)) /\
  (fst (m v) <> fst (m w) \/ snd (m v) <> snd (m w)) /\ 0 <= cross (vector (m u) (m v)) (vector (m v) (m w)).
Proof.
  unfold convex_at, turn_at, turning, turn, dot, cross, vector. cbn [fst snd]. intro C. repeat split.
  - destruct (Req_EM_T (fst (m u)) (fst (m v))) as [X|X]; [|now left]. destruct (Req_EM_T (snd (m u)) (snd (m v))) as [Y|Y]; [|now right].
    rewrite X, Y in C. lra.
  - destruct (Req_EM_T (fst (m v)) (fst (m w))) as [X|X]; [|now left]. destruct (Req_EM_T (snd (m v)) (snd (m w))) as [Y|Y]; [|now right].
    rewrite X, Y in C. lra.
  - lra.
Qed.

Lemma entered_between k m u v w : convex_at m u v w ->
  one_if (enters m (u, v, w)) - one_if (enters_left k m (u, v, w)) = between k (m v) (m w) - between k (m u) (m v).
Proof.
  intro C. destruct (convex_vectors m u v w C) as (N & N' & X). unfold enters, enters_left, between, cross in *.
  assert (E : forall x y x' y', x * y' - y * x' = (x - k * y) * y' - y * (x' - k * y')) by (intros; ring). rewrite E in X. clear E.
  destruct (quarters k _ _ N) as [(-> & -> & H)|[(-> & -> & H)|[(-> & -> & H)|(-> & -> & H)]]];
    destruct (quarters k _ _ N') as [(-> & -> & H')|[(-> & -> & H')|[(-> & -> & H')|(-> & -> & H')]]]; cbn [one_if negb andb];
    try ring; exfalso; nra.
Qed.

(* ---- All ridges ---- *)

Definition ending (r : nat * nat * nat) : nat * nat := let '(_, v, w) := r in (v, w).

Lemma ending_bends a l : map ending (bends (a :: l)) = steps l.
Proof.
  revert a. induction l as [|u l IH]; intro a; [reflexivity|]. destruct l as [|v l]; [reflexivity|].
  rewrite bends_cons, steps_cons, <- (IH u). reflexivity.
Qed.

Lemma ring_endings u v r : Permutation (ring (u :: v :: r)) (map ending (ridges (u :: v :: r))).
Proof.
  unfold ring, ridges. cbn [firstn app]. rewrite ending_bends, steps_cons.
  change (v :: r ++ [u; v]) with ((v :: r) ++ u :: [v]). rewrite steps_app. apply Permutation_cons_append.
Qed.

Theorem any_direction k m l : convex m l -> length (filter (enters m) (ridges l)) = length (filter (enters_left k m) (ridges l)).
Proof.
  intro C. destruct l as [|u [|v r]]; [reflexivity|reflexivity|]. apply INR_eq. rewrite !count_sum. apply Rminus_diag_uniq.
  set (l := u :: v :: r) in *. set (g := fun s : nat * nat => let '(u, v) := s in between k (m u) (m v)).
  transitivity (sum g (map ending (ridges l)) - sum g (map edge (ridges l))).
  - rewrite !sum_map. apply Rminus_diag_uniq.
    replace (_ - _) with (sum (fun s => (one_if (enters m s) + -1 * one_if (enters_left k m s)) + -1 * (g (ending s) + -1 * g (edge s))) (ridges l))
      by (rewrite !sum_plus, !sum_scale, !sum_plus, !sum_scale; ring).
    rewrite (sum_ext _ (fun _ => 0)); [apply sum_zero|]. intros [[a b] c] I. unfold g. cbn [ending edge].
    generalize (entered_between k m a b c (C a b c I)). lra.
  - unfold l. rewrite <- (sum_permutation g _ _ (ring_endings u v r)), ring_ridges. ring.
Qed.

(* ---- The other way round ---- *)

Definition flipped (r : nat * nat * nat) : nat * nat * nat := let '(u, v, w) := r in (w, v, u).

Lemma bends_rev p : bends (rev p) = map flipped (rev (bends p)).
Proof.
  induction p as [|a p IH]; [reflexivity|]. destruct p as [|b [|c p]]; [reflexivity|reflexivity|].
  rewrite bends_cons. cbn [rev] in *. rewrite map_app, <- IH, <- !app_assoc. cbn [app]. now rewrite bends_app.
Qed.

Lemma one_later v w r : Permutation (ridges (v :: w :: r)) (ridges ((w :: r) ++ [v])).
Proof. destruct (begin_later v w r) as (x & k & -> & -> & _). apply Permutation_cons_append. Qed.

Lemma ridges_rev l : Permutation (ridges (rev l)) (map flipped (ridges l)).
Proof.
  destruct l as [|u [|v r]]; [constructor|constructor|]. transitivity (ridges (v :: u :: rev r)).
  - cbn [rev]. destruct (rev r) as [|a k]; [reflexivity|]. symmetry. rewrite one_later. cbn [app]. rewrite one_later. reflexivity.
  - unfold ridges. cbn [firstn app]. transitivity (map flipped (rev (bends (u :: v :: r ++ [u; v])))).
    + rewrite <- bends_rev. cbn [rev]. rewrite rev_app_distr. cbn [rev app]. now rewrite <- !app_assoc.
    + apply Permutation_map, Permutation_sym, Permutation_rev.
Qed.

Lemma up_back u v : fst u <> fst v \/ snd u <> snd v -> points_up v u = negb (points_up u v).
Proof.
  intro N. unfold points_up. destruct (Rlt_dec (snd u) (snd v)), (Rlt_dec (snd v) (snd u)); try (exfalso; lra);
    destruct (Req_EM_T (snd u) (snd v)), (Req_EM_T (snd v) (snd u)); try (exfalso; lra); trivial;
    destruct (Rlt_dec (fst u) (fst v)), (Rlt_dec (fst v) (fst u)); trivial; exfalso; lra.
Qed.

Theorem clockwise m l : convex m l -> (winds_once m (rev l) <-> winds_once m l).
Proof.
  intro C. unfold winds_once. enough (E : length (filter (enters m) (ridges (rev l))) = length (filter (enters m) (ridges l))) by now rewrite E.
  apply INR_eq. rewrite !count_sum, (sum_permutation _ _ _ (ridges_rev l)), sum_map. apply sum_ext. intros [[u v] w] I.
  destruct (convex_vectors m u v w (C u v w I)) as (N & N' & _). cbn [flipped enters]. rewrite (up_back (m v) (m w)), (up_back (m u) (m v)) by assumption.
  rewrite negb_involutive, andb_comm. reflexivity.
Qed.

(* ---- A motion ---- *)

Definition continuous_motion (m : R -> placement) : Prop :=
  forall v, continuity (fun t => fst (m t v)) /\ continuity (fun t => snd (m t v)).

Lemma small_slope x y : x <> 0 \/ y <> 0 -> small (fun k => x <> k * y).
Proof.
  intros N. destruct (Req_EM_T x 0) as [X|X].
  - exists 1. split; [lra|]. intros k K E. subst x. assert (y <> 0) by tauto. symmetry in E. apply Rmult_integral in E. lra.
  - apply (small_impl (fun k => 0 < (1 - k) * (x * x) + k * (x * x - x * y))); [|apply small_positive; nra].
    intros k K H E. assert (0 < x * (x - k * y)) by lra. nra.
Qed.

Lemma stays_positive f t : continuity f -> 0 < f t -> small (fun d => forall s, Rabs (s - t) < d -> 0 < f s).
Proof.
  intros C P. destruct (C t (f t) P) as (d & D & H). exists d. split; [exact D|]. intros e E s S. destruct (Req_EM_T s t) as [->|N]; [exact P|].
  assert (K : Rabs (f s - f t) < f t) by (apply H; split; [split; [exact I|congruence]|]; simpl; unfold R_dist; lra).
  apply Rabs_def2 in K. lra.
Qed.

Section motion.
Variables (m : R -> placement) (l : list nat).
Hypothesis moves : continuous_motion m.
Hypothesis always_convex : forall t, convex (m t) l.

Definition entries t : R := INR (length (filter (enters (m t)) (ridges l))).

Lemma slope_at t : (2 <= length l)%nat -> exists k, forall u v, In (u, v) (ring l) -> fst (vector (m t u) (m t v)) <> k * snd (vector (m t u) (m t v)).
Proof.
  intro L. assert (S : small (fun k => forall s, In s (ring l) -> let '(u, v) := s in fst (vector (m t u) (m t v)) <> k * snd (vector (m t u) (m t v)))).
  { apply small_all. intros [u v] I. apply small_slope. destruct l as [|a [|b r]]; [inversion L|inversion L as [|? L']; inversion L'|].
    rewrite ring_ridges in I. apply in_map_iff in I. destruct I as ([[u' v'] w] & E & I). injection E as -> ->.
    destruct (convex_vectors _ _ _ _ (always_convex t u v w I)) as (N & _). unfold vector. cbn [fst snd]. lra. }
  destruct (small_exists _ S) as (k & _ & H). exists k. intros u v I. apply (H (u, v) I).
Qed.

Lemma leans_for_a_while k t u v : fst (vector (m t u) (m t v)) <> k * snd (vector (m t u) (m t v)) ->
  small (fun d => forall s, Rabs (s - t) < d -> leans k (m s u) (m s v) = leans k (m t u) (m t v)).
Proof.
  intro N. set (f := fun s => fst (vector (m s u) (m s v)) - k * snd (vector (m s u) (m s v))).
  assert (C : continuity f).
  { unfold f, vector. cbn [fst snd]. apply (continuity_minus (fun s => fst (m s v) - fst (m s u)) (fun s => k * (snd (m s v) - snd (m s u)))).
    - apply (continuity_minus (fun s => fst (m s v)) (fun s => fst (m s u))); apply moves.
    - apply (continuity_scal (fun s => snd (m s v) - snd (m s u)) k). apply (continuity_minus (fun s => snd (m s v)) (fun s => snd (m s u))); apply moves. }
  destruct (Rdichotomy _ _ N) as [L|L].
  - apply (small_impl (fun d => forall s, Rabs (s - t) < d -> 0 < - f s)).
    + intros d _ H s S. specialize (H s S). unfold f in H. unfold leans. destruct (Rlt_dec _ _); [|lra]. destruct (Rlt_dec _ _); [reflexivity|lra].
    + apply stays_positive; [now apply (continuity_opp f)|]. unfold f. lra.
  - apply (small_impl (fun d => forall s, Rabs (s - t) < d -> 0 < f s)).
    + intros d _ H s S. specialize (H s S). unfold f in H. unfold leans. destruct (Rlt_dec _ _); [lra|]. destruct (Req_EM_T _ _); [lra|].
      destruct (Rlt_dec _ _); [lra|]. destruct (Req_EM_T _ _); [lra|reflexivity].
    + apply stays_positive; [exact C|]. unfold f. lra.
Qed.

Lemma entries_for_a_while t : small (fun d => forall s, Rabs (s - t) < d -> entries s = entries t).
Proof.
  destruct (le_lt_dec 2 (length l)) as [L|L].
  - destruct (slope_at t L) as (k & K).
    assert (S : small (fun d => forall e, In e (ring l) -> forall s, Rabs (s - t) < d -> let '(u, v) := e in leans k (m s u) (m s v) = leans k (m t u) (m t v))).
    { apply small_all. intros [u v] I. now apply leans_for_a_while, K. }
    apply (small_impl _ _) with (2 := S). intros d _ H s D. unfold entries. rewrite !(any_direction k) by apply always_convex. f_equal. f_equal.
    apply filter_ext_in. intros [[u v] w] I. unfold enters_left.
    destruct l as [|a [|b r]]; [easy|easy|]. 
    rewrite (H (u, v)), (H (v, w)); trivial.
    + rewrite ring_endings. now apply (in_map ending _ (u, v, w)).
    + rewrite ring_ridges. now apply (in_map edge _ (u, v, w)).
  - exists 1. split; [lra|]. intros d _ s _. unfold entries. destruct l as [|a [|b r]]; [reflexivity|reflexivity|]. simpl in L. 
    exfalso. apply (Nat.lt_irrefl 2). apply Nat.le_lt_trans with (2 := L). apply le_n_S, le_n_S, Nat.le_0_l.
Qed.

Lemma entries_continuous : continuity entries.
Proof.
  intros t e E. destruct (entries_for_a_while t) as (d & D & H). exists (d / 2). split; [lra|]. intros s [_ S]. simpl in *. unfold R_dist in *.
  rewrite (H (d / 2)) by lra. rewrite Rminus_diag_eq, Rabs_R0 by reflexivity. exact E.
Qed.

Lemma whole_between (n : nat) k : INR n = INR k + / 2 -> False.
Proof.
  intro E. destruct (le_lt_dec n k) as [L|L]; [apply le_INR in L; lra|].
  assert (S k <= n)%nat by exact L. apply le_INR in H. rewrite S_INR in H. lra.
Qed.

Lemma entries_stay : entries 0 = entries 1.
Proof.
  destruct (Rtotal_order (entries 0) (entries 1)) as [L|[E|L]]; [exfalso|exact E|exfalso].
  - assert (G : entries 0 + 1 <= entries 1).
    { unfold entries in *. apply INR_lt in L. rewrite <- S_INR. now apply le_INR. }
    destruct (IVT (fun t => entries t - (entries 0 + / 2)) 0 1) as (z & _ & Z); try lra.
    + apply (continuity_minus entries (fun _ => entries 0 + / 2)); [exact entries_continuous|]. apply continuity_const. now intros x y.
    + apply (whole_between (length (filter (enters (m z)) (ridges l))) (length (filter (enters (m 0)) (ridges l)))). unfold entries in Z. lra.
  - assert (G : entries 1 + 1 <= entries 0).
    { unfold entries in *. apply INR_lt in L. rewrite <- S_INR. now apply le_INR. }
    destruct (IVT (fun t => entries 1 + / 2 - entries t) 0 1) as (z & _ & Z); try lra.
    + apply (continuity_minus (fun _ => entries 1 + / 2) entries); [|exact entries_continuous]. apply continuity_const. now intros x y.
    + apply (whole_between (length (filter (enters (m z)) (ridges l))) (length (filter (enters (m 1)) (ridges l)))). unfold entries in Z. lra.
Qed.
End motion.

(* What is outside the time of the motion does not matter: there the motion is thought to rest. *)
Definition clamp t : R := (1 + Rabs t - Rabs (t - 1)) / 2.

Lemma clamp_in t : 0 <= clamp t <= 1.
Proof. unfold clamp, Rabs. destruct (Rcase_abs t), (Rcase_abs (t - 1)); lra. Qed.
Lemma clamp_at t : 0 <= t <= 1 -> clamp t = t.
Proof. unfold clamp, Rabs. destruct (Rcase_abs t), (Rcase_abs (t - 1)); lra. Qed.

Lemma clamp_continuous : continuity clamp.
Proof.
  unfold clamp. apply (continuity_mult (fun t => 1 + Rabs t - Rabs (t - 1)) (fun _ => / 2)); [|apply continuity_const; now intros x y].
  apply (continuity_minus (fun t => 1 + Rabs t) (fun t => Rabs (t - 1))).
  - apply (continuity_plus (fun _ => 1) Rabs); [apply continuity_const; now intros x y|exact Rcontinuity_abs].
  - apply (continuity_comp (fun t => t - 1) Rabs); [|exact Rcontinuity_abs].
    apply (continuity_minus (fun t => t) (fun _ => 1)); [apply derivable_continuous, derivable_id|apply continuity_const; now intros x y].
Qed.

Theorem winding_kept (m : R -> placement) l : continuous_motion m -> (forall t, 0 <= t <= 1 -> convex (m t) l) ->
  winds_once (m 0) l -> winds_once (m 1) l.
Proof.
  intros M C W. unfold winds_once in *. rewrite <- W. apply INR_eq. symmetry.
  assert (M' : continuous_motion (fun t => m (clamp t))).
  { intro v. destruct (M v) as [X Y]. split; [apply (continuity_comp clamp (fun t => fst (m t v))) | apply (continuity_comp clamp (fun t => snd (m t v)))];
      trivial; apply clamp_continuous. }
  assert (E := entries_stay (fun t => m (clamp t)) l M' (fun t => C _ (clamp_in t))).
  unfold entries in E. rewrite !clamp_at in E by lra. exact E.
Qed.
