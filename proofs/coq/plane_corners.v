(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The corners of cells around a vertex, gone through counterclockwise: how often they enter the upper half-plane. For plane_rounds.v.

   - corners_of_cell   of a triangle, one corner in all enters or leaves the upper half-plane
   - around            what the corners at all vertices add up to: only the border is left
   - inner_once        around an inner vertex the cells go once at least
   - no_fewer          around a vertex of the border they enter the upper half-plane as often as its ridge requires, at least *)
Require Import Reals Lra Lia List Permutation Bool Arith.
From Annulus Require Import sums width_2 plane_mesh plane_paths plane_border plane_winding.
Import ListNotations.
Open Scope R_scope.

Section rounds.
Variables (T : mesh) (m : placement).
Hypothesis gluing : glued T.
Hypothesis all_positive : positive m T.

Definition up (u v : nat) : bool := points_up (m u) (m v).
Notation corners := (flat_map sides (cells T)).   (* v, b, c: at v, from b to c *)
Definition at_corner (s : nat * nat * nat) : nat := let '(v, _, _) := s in v.
Definition at_ridge (r : nat * nat * nat) : nat := let '(_, v, _) := r in v.
Definition entered (s : nat * nat * nat) : bool := let '(v, b, c) := s in negb (up v b) && up v c.
Definition left_ (s : nat * nat * nat) : bool := let '(v, b, c) := s in up v b && negb (up v c).
(* A ridge whose two edges both go down: seen from its vertex, the mesh begins below and ends above. *)
Definition descends (r : nat * nat * nat) : bool := let '(u, v, w) := r in negb (up u v) && negb (up v w).

Definition rounds (v : nat) : nat := length (filter (fun s => (at_corner s =? v)%nat && entered s) corners).
Definition needed (v : nat) : nat := length (filter (fun r => (at_ridge r =? v)%nat && descends r) (ridges (border T))).
Definition extra (v : nat) : R := INR (rounds v) - INR (needed v).

(* ---- One cell ---- *)

Lemma different u v : m u <> m v -> fst (m u) <> fst (m v) \/ snd (m u) <> snd (m v).
Proof. intro N. destruct (Req_EM_T (fst (m u)) (fst (m v))) as [X|X]; [right|now left]. intro Y. apply N. now apply injective_projections. Qed.

Lemma up_swap u v : m u <> m v -> up v u = negb (up u v).
Proof.
  intro N. now apply up_back, different.
Qed.

Lemma up_trans u v w : up u v = true -> up v w = true -> up u w = true.
Proof.
  unfold up, points_up. intros H K. destruct (Rlt_dec (snd (m u)) (snd (m v))), (Rlt_dec (snd (m v)) (snd (m w)));
    destruct (Req_EM_T (snd (m u)) (snd (m v))), (Req_EM_T (snd (m v)) (snd (m w))); try discriminate;
    destruct (Rlt_dec (fst (m u)) (fst (m v))), (Rlt_dec (fst (m v)) (fst (m w))); try discriminate;
    destruct (Rlt_dec (snd (m u)) (snd (m w))); trivial; try (exfalso; lra);
    destruct (Req_EM_T (snd (m u)) (snd (m w))); try (exfalso; lra); destruct (Rlt_dec (fst (m u)) (fst (m w))); trivial; exfalso; lra.
Qed.

Lemma apart a b c : In (a, b, c) (cells T) -> m a <> m b /\ m b <> m c /\ m c <> m a.
Proof.
  intro I. assert (P := all_positive a b c I). unfold turn_at, turning, turn in P. repeat split; intro E; rewrite E in P; lra.
Qed.

Definition crosses (s : nat * nat * nat) : R := one_if (entered s) + one_if (left_ s).
Lemma corners_of_cell t : In t (cells T) -> sum crosses (sides t) = 1.
Proof.
  destruct t as [[a b] c]. intro I. destruct (apart a b c I) as (N & N' & N''). unfold crosses. cbn [sides sum entered left_].
  rewrite (up_swap c a), (up_swap a b), (up_swap b c) by trivial.
  destruct (up a b) eqn:A, (up b c) eqn:B, (up c a) eqn:C; cbn [negb andb one_if]; try ring; exfalso.
  - assert (K := up_trans a b c A B). rewrite (up_swap c a), C in K by trivial. discriminate.
  - assert (K : up c a = true); [|congruence]. apply (up_trans c b a); rewrite up_swap by auto; now rewrite ?A, ?B.
Qed.

(* ---- Around all vertices ---- *)

Lemma turned_sides (g : nat -> nat -> R) t :
  sum (fun s => let '(v, b, c) := s in g v c) (sides t) = sum (fun s => let '(v, b, c) := s in g b v) (sides t).
Proof. destruct t as [[a b] c]. simpl. ring. Qed.

Theorem around (g : nat -> nat -> R) :
  sum (fun s => let '(v, b, c) := s in g v c - g v b) corners = sum (fun e => let '(u, v) := e in g v u - g u v) (ring (border T)).
Proof.
  destruct gluing as [G B].
  transitivity (sum (fun s => let '(v, b, c) := s in g b v + -1 * g v b) corners).
  - rewrite !sum_flat_map. apply sum_ext. intros t _. assert (E := turned_sides g t). destruct t as [[a b] c]. simpl in *. lra.
  - rewrite (sum_permutation _ _ _ G), sum_app, sum_flat_map, (sum_ext _ (fun _ => 0) (bicells T)), sum_zero, Rplus_0_l.
    + rewrite <- (sum_permutation _ _ _ B), sum_map. apply sum_ext. intros [[a b] c] _. cbn [edge]. ring.
    + intros [[[a b] p] q] _. simpl. ring.
Qed.

Definition one_up (u v : nat) : R := one_if (up u v).
Lemma entered_left s : one_if (entered s) - one_if (left_ s) = let '(v, b, c) := s in one_up v c - one_up v b.
Proof. destruct s as [[v b] c]. unfold entered, left_, one_up. destruct (up v b), (up v c); cbn [negb andb one_if]; ring. Qed.

Lemma ring_apart u v : In (u, v) (ring (border T)) -> m u <> m v.
Proof.
  intro I. destruct gluing as [G B]. apply (Permutation_in _ (Permutation_sym B)), in_map_iff in I. destruct I as ([[a b] c] & E & I).
  injection E as -> ->. assert (S : In (u, v, c) corners) by (apply (Permutation_in _ (Permutation_sym G)), in_or_app; now right).
  apply in_flat_map in S. destruct S as ([[x y] z] & K & S). destruct (apart x y z K) as (N & N' & N'').
  destruct S as [S|[S|[S|[]]]]; injection S as -> -> ->; trivial.
Qed.

Lemma sum_const {S} (l : list S) : sum (fun _ => 1) l = INR (length l).
Proof. induction l as [|a l IH]; [reflexivity|]. cbn [length]. rewrite sum_cons, IH, S_INR. ring. Qed.
Lemma steps_length a l : length (steps (a :: l)) = length l.
Proof. revert a. induction l as [|b l IH]; intro a; [reflexivity|]. rewrite steps_cons. cbn [length]. now rewrite IH. Qed.
Lemma ring_length l : length (ring l) = length l.
Proof. destruct l as [|a l]; [reflexivity|]. unfold ring. cbn [firstn app]. rewrite steps_length, app_length. cbn [length]. lia. Qed.

Lemma ring_edges (g : nat * nat -> R) : sum g (ring (border T)) = sum (fun r => g (edge r)) (ridges (border T)).
Proof.
  assert (A := ring_apart). destruct (border T) as [|a [|b r]]; [reflexivity| |now rewrite ring_ridges, sum_map]. exfalso. apply (A a a); [now left|reflexivity].
Qed.

(* ---- None is negative ---- *)

(* On either half-plane it grows counterclockwise. *)
Definition turn_of (e : point_2) (above : bool) : R := (if above then -1 else 1) * (fst e / (Rabs (fst e) + Rabs (snd e))).

Lemma further e f : upward e -> upward f -> 0 < cross e f -> fst f / (Rabs (fst f) + Rabs (snd f)) < fst e / (Rabs (fst e) + Rabs (snd e)).
Proof.
  destruct e as [x y], f as [p q]. unfold upward, cross. cbn [fst snd]. intros U V C.
  assert (Y : 0 <= y) by (destruct U; lra). assert (Q : 0 <= q) by (destruct V; lra). rewrite (Rabs_pos_eq y), (Rabs_pos_eq q) by assumption.
  assert (A := Rabs_pos x). assert (B := Rabs_pos p).
  assert (X : 0 < Rabs x + y) by (destruct U as [U|[_ U]]; [|rewrite Rabs_pos_eq]; lra).
  assert (P : 0 < Rabs p + q) by (destruct V as [V|[_ V]]; [|rewrite Rabs_pos_eq]; lra).
  assert (K : p * Rabs x <= x * Rabs p).
  { unfold Rabs. destruct (Rcase_abs x), (Rcase_abs p); nra. }
  apply (Rmult_lt_reg_r ((Rabs x + y) * (Rabs p + q))); [now apply Rmult_lt_0_compat|].
  replace (p / (Rabs p + q) * ((Rabs x + y) * (Rabs p + q))) with (p * (Rabs x + y)) by (field; lra).
  replace (x / (Rabs x + y) * ((Rabs x + y) * (Rabs p + q))) with (x * (Rabs p + q)) by (field; lra). lra.
Qed.

Definition bearing (v b : nat) : R := turn_of (vector (m v) (m b)) (up v b).
Lemma bearing_grows v b c : In (v, b, c) corners -> up v b = up v c -> bearing v b < bearing v c.
Proof.
  intros I E. apply in_flat_map in I. destruct I as ([[x y] z] & I & S).
  assert (P : 0 < cross (vector (m v) (m b)) (vector (m v) (m c))).
  { assert (Q := all_positive x y z I). unfold turn_at, turning, turn, cross, vector in *. cbn [fst snd].
    destruct S as [S|[S|[S|[]]]]; injection S as <- <- <-; lra. }
  assert (N : m v <> m b /\ m v <> m c).
  { split; intro Q; rewrite Q in P; unfold cross, vector in P; cbn [fst snd] in P; lra. }
  unfold bearing, turn_of. rewrite <- E. destruct (up v b) eqn:B.
  - assert (G := further _ _ (up_upward _ _ B) (up_upward _ _ (eq_sym E)) P). lra.
  - assert (U := downward_opposite _ (down_downward _ _ B (different _ _ (proj1 N)))).
    assert (V := downward_opposite _ (down_downward _ _ (eq_sym E) (different _ _ (proj2 N)))).
    assert (G := further _ _ U V). unfold cross in G, P. cbn [fst snd] in G. rewrite !Rabs_Ropp in G. unfold Rdiv in *. lra.
Qed.

(* `around`, of the corners at one vertex. *)
Lemma around_one v (g : nat -> R) :
  sum (fun s => let '(a, b, c) := s in if (a =? v)%nat then g c - g b else 0) corners =
  sum (fun e => let '(a, b) := e in (if (b =? v)%nat then g a else 0) - (if (a =? v)%nat then g b else 0)) (ring (border T)).
Proof.
  rewrite <- (around (fun a b => if (a =? v)%nat then g b else 0)). apply sum_ext. intros [[a b] c] _. destruct (a =? v)%nat; ring.
Qed.

Lemma off_border v (g : nat -> R) : ~ In v (border T) -> sum (fun s => let '(a, b, c) := s in if (a =? v)%nat then g c - g b else 0) corners = 0.
Proof.
  intro N. rewrite around_one, (sum_ext _ (fun _ => 0)); [apply sum_zero|]. intros [a b] I.
  assert (K : forall w, In w (border T ++ firstn 1 (border T)) -> (w =? v)%nat = false).
  { intros w W. apply Nat.eqb_neq. intros ->. apply N. apply in_app_or in W. destruct W as [W|W]; [exact W|].
    rewrite <- (firstn_skipn 1). apply in_or_app. now left. }
  apply steps_in in I. rewrite !K by apply I. ring.
Qed.

Definition departs (v : nat) : R := sum (fun s => one_if ((at_corner s =? v)%nat && left_ s)) corners.
Lemma rounds_departs v : INR (rounds v) - departs v =
  sum (fun s => let '(a, b, c) := s in if (a =? v)%nat then one_up v c - one_up v b else 0) corners.
Proof.
  unfold rounds, departs. rewrite count_sum.
  match goal with |- ?a - ?b = _ => replace (a - b) with (a + -1 * b) by ring end. rewrite <- sum_scale, <- sum_plus.
  apply sum_ext. intros [[a b] c] _. cbn [at_corner]. destruct (Nat.eqb_spec a v) as [->|]; cbn [andb one_if]; [|ring].
  rewrite <- (entered_left (v, b, c)). ring.
Qed.

Theorem inner_once v : ~ In v (border T) -> vertex_of T v -> (1 <= rounds v)%nat.
Proof.
  intros N ([[x y] z] & I & Q). destruct (rounds v) eqn:Z; [exfalso|lia].
  assert (D := rounds_departs v). rewrite off_border, Z in D by exact N.
  assert (Same : forall b c, In (v, b, c) corners -> up v b = up v c).
  { intros b c K. assert (E : entered (v, b, c) = false).
    { destruct (entered (v, b, c)) eqn:E; [exfalso|reflexivity]. unfold rounds in Z. apply length_zero_iff_nil in Z.
      assert (F : In (v, b, c) []) by (rewrite <- Z; apply filter_In; split; [exact K|]; cbn [at_corner]; now rewrite Nat.eqb_refl, E). exact F. }
    assert (L : left_ (v, b, c) = false).
    { destruct (left_ (v, b, c)) eqn:L; [exfalso|reflexivity].
      assert (0 < departs v); [|cbn [INR] in D; lra]. apply (sum_pos _ _ (v, b, c)); [|exact K|].
      - intros s _. destruct (_ && _); cbn [one_if]; lra.
      - cbn [at_corner]. rewrite Nat.eqb_refl, L. cbn [andb one_if]. lra. }
    unfold entered, left_ in E, L. destruct (up v b), (up v c); trivial; discriminate. }
  assert (P : 0 < sum (fun s => let '(a, b, c) := s in if (a =? v)%nat then bearing v c - bearing v b else 0) corners).
  { assert (Grow : forall b c, In (v, b, c) corners -> 0 < bearing v c - bearing v b).
    { intros b c K. generalize (bearing_grows v b c K (Same b c K)). lra. }
    assert (Own : exists b c, In (v, b, c) corners).
    { destruct Q as [->|[->| ->]]; [exists y, z|exists z, x|exists x, y]; apply in_flat_map; exists (x, y, z); (split; [exact I|]); simpl; tauto. }
    destruct Own as (b & c & K). apply (sum_pos _ _ (v, b, c)); [|exact K|rewrite Nat.eqb_refl; now apply Grow].
    intros [[a b'] c'] K'. destruct (Nat.eqb_spec a v) as [->|]; [apply Rlt_le; now apply Grow|lra]. }
  rewrite off_border in P by exact N. lra.
Qed.

Lemma ends_of_ridges a l b : map at_ridge (bends (a :: l ++ [b])) = l.
Proof.
  revert a. induction l as [|c l IH]; intro a; [reflexivity|]. cbn [app]. destruct (l ++ [b]) as [|d k] eqn:E; [now destruct l|].
  rewrite bends_cons. cbn [map at_ridge]. f_equal. apply IH.
Qed.

Lemma ridges_differ : NoDup (border T) -> NoDup (map at_ridge (ridges (border T))).
Proof.
  destruct (border T) as [|u [|v r]]; intro N; [constructor|constructor|]. unfold ridges. cbn [firstn app].
  change (v :: r ++ [u; v]) with ((v :: r) ++ [u] ++ [v]). rewrite app_assoc, ends_of_ridges.
  apply (Permutation_NoDup (Permutation_cons_append (v :: r) u)). exact N.
Qed.

Lemma same_by_name {S} (f : S -> nat) l a b : NoDup (map f l) -> In a l -> In b l -> f a = f b -> a = b.
Proof.
  induction l as [|c l IH]; [easy|]. cbn [map]. intros N [->|A] [->|B] E; inversion N as [|? ? N1 N2]; subst; trivial.
  - exfalso. apply N1. rewrite E. now apply in_map.
  - exfalso. apply N1. rewrite <- E. now apply in_map.
  - now apply IH.
Qed.

Definition ascends (r : nat * nat * nat) : bool := let '(u, v, w) := r in up u v && up v w.
Lemma rounds_at_border v : NoDup (border T) ->
  INR (rounds v) + sum (fun r => one_if ((at_ridge r =? v)%nat && ascends r)) (ridges (border T)) = INR (needed v) + departs v.
Proof.
  intro N. assert (R := rounds_departs v). rewrite around_one in R.
  assert (E : sum (fun e => let '(a, b) := e in (if (b =? v)%nat then one_up v a else 0) - (if (a =? v)%nat then one_up v b else 0)) (ring (border T)) =
    INR (needed v) + -1 * sum (fun r => one_if ((at_ridge r =? v)%nat && ascends r)) (ridges (border T))).
  { replace (sum _ (ring (border T))) with (sum (fun e => let '(a, b) := e in if (b =? v)%nat then one_up v a else 0) (ring (border T)) +
      -1 * sum (fun e => let '(a, b) := e in if (a =? v)%nat then one_up v b else 0) (ring (border T))).
    - unfold needed. rewrite count_sum, ring_edges.
      assert (P : Permutation (ring (border T)) (map ending (ridges (border T)))).
      { assert (A := ring_apart). destruct (border T) as [|a [|b r]]; [constructor| |apply ring_endings]. exfalso. apply (A a a); [now left|reflexivity]. }
      rewrite (sum_permutation _ _ _ P), sum_map, <- !sum_scale, <- !sum_plus. apply sum_ext. intros [[a b] c] I.
      cbn [edge ending at_ridge descends ascends]. destruct (Nat.eqb_spec b v) as [->|]; cbn [andb one_if]; [|ring].
      unfold one_up. rewrite (up_swap a v).
      + destruct (up a v), (up v c); cbn [negb andb one_if]; ring.
      + apply ring_apart. destruct (border T) as [|x [|y r]]; [easy|easy|]. rewrite ring_ridges. now apply (in_map edge _ (a, v, c)).
    - rewrite <- sum_scale, <- sum_plus. apply sum_ext. intros [a b] _. ring. }
  rewrite E in R. lra.
Qed.

Theorem no_fewer v : NoDup (border T) -> 0 <= extra v.
Proof.
  intro N. unfold extra. assert (R := rounds_at_border v N). assert (D : 0 <= departs v) by (apply sum_nonneg; intros s _; destruct (_ && _); cbn [one_if]; lra).
  set (A := sum (fun r => one_if ((at_ridge r =? v)%nat && ascends r)) (ridges (border T))) in *. destruct (Req_EM_T A 0) as [Z|Z]; [lra|].
  assert (P : exists r, In r (ridges (border T)) /\ at_ridge r = v /\ ascends r = true).
  { destruct (existsb (fun r => (at_ridge r =? v)%nat && ascends r) (ridges (border T))) eqn:E.
    - apply existsb_exists in E. destruct E as (r & I & E). apply andb_prop in E. exists r. now rewrite <- Nat.eqb_eq.
    - exfalso. apply Z. unfold A. rewrite <- (sum_zero (ridges (border T))). apply sum_ext. intros r I.
      destruct (_ && _) eqn:Q; [exfalso|reflexivity]. assert (existsb (fun r => (at_ridge r =? v)%nat && ascends r) (ridges (border T)) = true); [|congruence].
      apply existsb_exists. now exists r. }
  destruct P as (r & I & <- & P). replace (needed (at_ridge r)) with O; [cbn [INR]; generalize (pos_INR (rounds (at_ridge r))); lra|].
  symmetry. unfold needed. apply length_zero_iff_nil. destruct (filter _ _) as [|s l] eqn:F; [reflexivity|exfalso].
  assert (J : In s (s :: l)) by now left. rewrite <- F in J. apply filter_In in J. destruct J as [J Q]. apply andb_prop in Q. destruct Q as [Q Q'].
  apply Nat.eqb_eq in Q. assert (s = r) by (apply (same_by_name at_ridge (ridges (border T))); trivial; now apply ridges_differ). subst s.
  destruct r as [[a b] c]. unfold ascends, descends in *. destruct (up a b), (up b c); discriminate.
Qed.
End rounds.
