(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Signs and a border that winds once make an embedding: docs/theory.md 1.2, lemma 1.

   - interiors_disjoint   a point strictly inside a cell is in no other
   - cells_left           every cell is on the left of each edge of the border
   - cells_cover          what is on the left of each edge of the border is in a cell
   - change               from a point to another, each strictly inside a cell, a function of cells changes by its steps across the bi-cells between *)
Require Import Reals Lra Psatz List Permutation Arith.
From Annulus Require Import sums small width_2 plane_mesh plane_paths plane_crossings plane_border.
Import ListNotations.
Open Scope R_scope.

Definition is_zero (d : point_2) : Prop := fst d = 0 /\ snd d = 0.

Lemma zero_or_not d : is_zero d \/ fst d <> 0 \/ snd d <> 0.
Proof. unfold is_zero. destruct (Req_EM_T (fst d) 0), (Req_EM_T (snd d) 0); tauto. Qed.

Lemma same_place x y : is_zero (vector x y) -> y = x.
Proof. destruct x, y. unfold is_zero, vector. cbn [fst snd]. intros [H K]. f_equal; lra. Qed.

Lemma turning_weights a b c u v x : turning b c x * turning u v a + turning c a x * turning u v b + turning a b x * turning u v c
  = turning a b c * turning u v x.
Proof. unfold turning, turn. ring. Qed.

Lemma turning_height u v x : turning u v x = cross (vector u v) x - cross (vector u v) u.
Proof. unfold turning, turn, cross, vector. simpl. ring. Qed.

Definition centre (a b c : point_2) : point_2 := ((fst a + fst b + fst c) / 3, (snd a + snd b + snd c) / 3).

Lemma centre_strictly a b c : 0 < turning a b c -> strictly_in (centre a b c) a b c.
Proof.
  intro P. unfold strictly_in. assert (E : forall u v, turning u v (centre a b c) = (turning u v a + turning u v b + turning u v c) / 3)
    by (intros; unfold turning, turn, centre; simpl; field).
  rewrite !E. unfold turning, turn in *. repeat split; lra.
Qed.

Lemma mix_strictly e x y a b c : 0 < e <= 1 -> within x a b c -> strictly_in y a b c -> strictly_in (mix e x y) a b c.
Proof.
  intros E (H1 & H2 & H3) (K1 & K2 & K3). unfold strictly_in. rewrite !turning_mix. repeat split; nra.
Qed.

Section placed.
Variables (T : mesh) (m : placement).
Hypothesis gluing : glued T.
Hypothesis cells_positive : positive m T.
Hypothesis border_once : winds_once m (border T).

Notation in_cell := (in_cell m).
Notation inside_cell := (inside_cell m).
Definition middle (t : nat * nat * nat) : point_2 := let '(a, b, c) := t in centre (m a) (m b) (m c).

Lemma middle_inside t : In t (cells T) -> inside_cell (middle t) t.
Proof. destruct t as [[a b] c]. intro H. now apply centre_strictly, cells_positive. Qed.

Lemma mix_inside e x t : 0 < e <= 1 -> In t (cells T) -> in_cell x t -> inside_cell (mix e x (middle t)) t.
Proof. destruct t as [[a b] c]. intros E H W. apply mix_strictly; trivial. now apply (middle_inside (a, b, c)). Qed.

Lemma inside_in x t : inside_cell x t -> in_cell x t.
Proof. destruct t as [[a b] c]. unfold inside_cell, in_cell, strictly_in, within. intuition lra. Qed.

Lemma corner_in v t : In t (cells T) -> corner v t -> in_cell (m v) t.
Proof.
  destruct t as [[a b] c]. intros H C. generalize (cells_positive a b c H). unfold in_cell, within, turn_at, turning, turn.
  intro P. destruct C as [->|[->| ->]]; repeat split; lra.
Qed.

Lemma crossings_count d x t : In t (cells T) -> (crossings_of m d x t = 0 \/ crossings_of m d x t = 1) /\
  (fst d <> 0 \/ snd d <> 0 -> inside_cell x t -> crossings_of m d x t = 1) /\ (crossings_of m d x t = 1 -> in_cell x t).
Proof. destruct t as [[a b] c]. intro H. now apply crossing_once, cells_positive. Qed.

Lemma crossings_nonneg d x t : In t (cells T) -> 0 <= crossings_of m d x t.
Proof. intro H. destruct (crossings_count d x t H) as ([E|E] & _); lra. Qed.

Lemma near_inside x y t : inside_cell x t -> small (fun e => inside_cell (mix e x y) t).
Proof.
  destruct t as [[a b] c]. intros (H1 & H2 & H3). unfold inside_cell, strictly_in.
  apply (small_impl (fun e => 0 < (1 - e) * turning (m a) (m b) x + e * turning (m a) (m b) y /\
    0 < (1 - e) * turning (m b) (m c) x + e * turning (m b) (m c) y /\ 0 < (1 - e) * turning (m c) (m a) x + e * turning (m c) (m a) y)).
  - intros e _ H. now rewrite !turning_mix.
  - repeat apply small_and; now apply small_positive.
Qed.

(* ---- No point twice ---- *)

Lemma at_most_once x t u rest : Permutation (cells T) (t :: rest) -> In u rest -> inside_cell x t -> inside_cell x u -> False.
Proof.
  intros P I Ht Hu. assert (L : fst level <> 0 \/ snd level <> 0) by (left; simpl; lra).
  assert (In_t : In t (cells T)) by (rewrite P; now left). assert (In_u : In u (cells T)) by (rewrite P; now right).
  assert (S : sum (crossings_of m level x) (cells T) <= 1) by (rewrite (covered T m gluing); now apply crossed_once).
  rewrite (sum_permutation _ _ _ P), sum_cons in S. destruct (crossings_count level x t In_t) as (_ & C & _). rewrite (C L Ht) in S.
  assert (0 < sum (crossings_of m level x) rest); [|lra]. apply sum_pos with u; trivial.
  - intros s K. apply crossings_nonneg. rewrite P. now right.
  - destruct (crossings_count level x u In_u) as (_ & D & _). rewrite (D L Hu). lra.
Qed.

Theorem interiors_disjoint x t u rest : Permutation (cells T) (t :: rest) -> In u rest -> inside_cell x t -> in_cell x u -> False.
Proof.
  intros P I Ht Hu. assert (In_u : In u (cells T)) by (rewrite P; now right).
  destruct (small_exists _ (small_and _ _ (near_inside x (middle u) t Ht) (small_below 1 Rlt_0_1))) as (e & E & H & L).
  apply (at_most_once (mix e x (middle u)) t u rest P I H). apply mix_inside; trivial. lra.
Qed.

Lemma same_cell x t u : In t (cells T) -> In u (cells T) -> inside_cell x t -> in_cell x u -> t = u.
Proof.
  intros It Iu Ht Hu. apply in_split in It. destruct It as (l1 & l2 & E). rewrite E in Iu. apply in_elt_inv in Iu.
  destruct Iu as [Q|Iu]; [now symmetry|exfalso]. apply (interiors_disjoint x t u (l1 ++ l2)); trivial.
  rewrite E. symmetry. apply Permutation_middle.
Qed.

(* A ray from a point inside a cell begins in this cell only. *)
Lemma counted_once d x t (w : nat * nat * nat -> R) : fst d <> 0 \/ snd d <> 0 -> In t (cells T) -> inside_cell x t ->
  sum (fun u => w u * crossings_of m d x u) (cells T) = w t.
Proof.
  intros D It Ht. assert (K := It). apply in_split in It. destruct It as (l1 & l2 & E).
  assert (P : Permutation (cells T) (t :: l1 ++ l2)) by (rewrite E; symmetry; apply Permutation_middle).
  rewrite (sum_permutation _ _ _ P), sum_cons. destruct (crossings_count d x t K) as (_ & C & _). rewrite (C D Ht).
  rewrite (sum_ext _ (fun _ => 0)), sum_zero; [ring|]. intros u Iu.
  destruct (crossings_count d x u) as ([Z|O] & _ & I); [rewrite P; now right | rewrite Z; ring |].
  exfalso. apply (interiors_disjoint x t u (l1 ++ l2)); trivial. now apply I.
Qed.

(* ---- Inside the border ---- *)

Hypothesis border_convex : convex m (border T).

Lemma corners_left a b t v : In (a, b) (ring (border T)) -> In t (cells T) -> corner v t -> 0 <= turn_at m a b v.
Proof.
  intros Ie It C. apply Rnot_lt_le. intro N. set (d := vector (m a) (m b)).
  assert (D : fst d <> 0 \/ snd d <> 0) by (generalize (convex_no_point m _ _ _ border_convex border_once Ie); unfold d, vector; simpl; lra).
  assert (B : small (fun e => 0 < (1 - e) * - turn_at m a b v + e * - turning (m a) (m b) (middle t))) by (apply small_positive; lra).
  destruct (small_exists _ (small_and _ _ B (small_below 1 Rlt_0_1))) as (e & E & Below & L). set (x := mix e (m v) (middle t)).
  assert (X : turning (m a) (m b) x < 0) by (unfold x; rewrite turning_mix; fold (turn_at m a b v); lra).
  assert (P : 0 < sum (crossings_of m d x) (cells T)).
  { apply sum_pos with t; trivial; [intros s K; now apply crossings_nonneg|]. destruct (crossings_count d x t It) as (_ & K & _).
    rewrite K; [lra|exact D|]. apply mix_inside; trivial; [lra|]. now apply corner_in. }
  rewrite (covered T m gluing), (sum_ext _ (fun _ => 0)), sum_zero in P; [lra|]. intros [u w] I.
  destruct (border_left m _ a b u w border_convex border_once Ie I) as [U W]. unfold turn_at in U, W. rewrite turning_height in U, W, X.
  fold d in U, W, X. unfold crossing. rewrite !passes_none by (left; lra). ring.
Qed.

Lemma cells_left a b t x : In (a, b) (ring (border T)) -> In t (cells T) -> in_cell x t -> 0 <= turning (m a) (m b) x.
Proof.
  intros Ie It W. destruct t as [[p q] r]. destruct W as (W1 & W2 & W3). generalize (turning_weights (m p) (m q) (m r) (m a) (m b) x).
  assert (K := fun v => corners_left a b (p, q, r) v Ie It). assert (P := cells_positive p q r It). unfold turn_at in *.
  generalize (K p ltac:(now left)) (K q ltac:(right; now left)) (K r ltac:(right; now right)). intros. nra.
Qed.

Lemma cells_strictly_left a b t x : In (a, b) (ring (border T)) -> In t (cells T) -> inside_cell x t -> 0 < turning (m a) (m b) x.
Proof.
  intros Ie It W. destruct (Rle_lt_or_eq_dec _ _ (cells_left a b t x Ie It (inside_in x t W))) as [L|L]; [exact L|exfalso].
  destruct t as [[p q] r]. generalize (turning_weights (m p) (m q) (m r) (m a) (m b) x). rewrite <- L, Rmult_0_r. intro S.
  assert (K := fun v => corners_left a b (p, q, r) v Ie It). assert (P := cells_positive p q r It). unfold turn_at in *.
  assert (Kp := K p ltac:(now left)). assert (Kq := K q ltac:(right; now left)). assert (Kr := K r ltac:(right; now right)).
  assert (W' := W). destruct W' as (W1 & W2 & W3).
  assert (Zp : turning (m a) (m b) (m p) = 0) by nra. assert (Zq : turning (m a) (m b) (m q) = 0) by nra.
  assert (Zr : turning (m a) (m b) (m r) = 0) by nra. rewrite turning_height in L, Zp, Zq, Zr.
  apply (all_right (vector (m a) (m b)) (m p) (m q) (m r) x); trivial; try lra.
  generalize (convex_no_point m _ _ _ border_convex border_once Ie). unfold vector. simpl. lra.
Qed.

(* ---- From one point to another ---- *)

Definition left_of_border (x : point_2) : Prop := forall a b, In (a, b) (ring (border T)) -> 0 < turning (m a) (m b) x.

Definition step (x y : point_2) (a b : nat) : R := crossing (vector x y) y (m a) (m b) - crossing (vector x y) x (m a) (m b).

Lemma step_swap x y a b : step x y b a = - step x y a b.
Proof. unfold step. rewrite !(crossing_swap _ _ (m a)). ring. Qed.

Lemma step_cases x y a b : kept_or_crossed x y (m a) (m b) (step x y a b).
Proof. apply crossing_step. Qed.

Lemma by_steps x y (w : nat * nat * nat -> R) : left_of_border x -> left_of_border y -> (forall a b c, w (b, c, a) = w (a, b, c)) ->
  sum (fun t => w t * crossings_of m (vector x y) y t) (cells T) - sum (fun t => w t * crossings_of m (vector x y) x t) (cells T)
  = sum (fun k => let '(a, b, p, q) := k in step x y a b * (w (a, b, q) - w (b, a, p))) (bicells T).
Proof.
  intros X Y C. generalize (by_sides T (step x y) w gluing (step_swap x y) C).
  rewrite (sum_ext (fun s => let '(a, b, c) := s in step x y a b * w s) (fun _ => 0)), sum_zero, Rplus_0_r.
  - intros <-. transitivity (sum (fun t => w t * crossings_of m (vector x y) y t + -1 * (w t * crossings_of m (vector x y) x t)) (cells T)).
    + rewrite sum_plus, sum_scale. ring.
    + apply sum_ext. intros [[a b] c] _. unfold crossings_of, crossings, step. ring.
  - intros [[a b] c] I. assert (Ie : In (a, b) (ring (border T))) by (rewrite <- (proj2 gluing); now apply (in_map edge _ (a, b, c))).
    generalize (X a b Ie) (Y a b Ie) (step_cases x y a b). unfold kept_or_crossed. intros Hx Hy [->|[H|H]]; [ring|lra|lra].
Qed.

Lemma inside_left x t : In t (cells T) -> inside_cell x t -> left_of_border x.
Proof. intros It Ht a b I. now apply cells_strictly_left with t. Qed.

Theorem change x y t u (w : nat * nat * nat -> R) : fst (vector x y) <> 0 \/ snd (vector x y) <> 0 ->
  In t (cells T) -> In u (cells T) -> inside_cell x t -> inside_cell y u -> (forall a b c, w (b, c, a) = w (a, b, c)) ->
  w u - w t = sum (fun k => let '(a, b, p, q) := k in step x y a b * (w (a, b, q) - w (b, a, p))) (bicells T).
Proof.
  intros D It Iu Ht Hu C. rewrite <- (by_steps x y w (inside_left x t It Ht) (inside_left y u Iu Hu) C).
  now rewrite (counted_once _ y u w D Iu Hu), (counted_once _ x t w D It Ht).
Qed.

(* ---- Every point ---- *)

Lemma some_cell : exists t, In t (cells T).
Proof.
  destruct (cells T) as [|t l] eqn:E; [exfalso|exists t; now left]. destruct gluing as [G H]. rewrite E in G. apply Permutation_nil in G.
  apply app_eq_nil in G. destruct G as [_ G]. rewrite G in H. apply Permutation_nil in H.
  destruct (border T) as [|a [|b l]]; [discriminate border_once|discriminate H|discriminate H].
Qed.

Lemma cover_strictly x : left_of_border x -> exists t, In t (cells T) /\ in_cell x t.
Proof.
  intro X. destruct some_cell as (u & Iu). assert (Hu := middle_inside u Iu). set (y := middle u) in *.
  destruct (zero_or_not (vector x y)) as [Z|D].
  - exists u. split; [exact Iu|]. rewrite <- (same_place x y Z). now apply inside_in.
  - assert (S := by_steps x y (fun _ => 1) X (inside_left y u Iu Hu) (fun _ _ _ => eq_refl)).
    cbv beta in S. rewrite (counted_once _ y u (fun _ => 1) D Iu Hu) in S.
    rewrite (sum_ext (fun k => let '(a, b, p, q) := k in step x y a b * (1 - 1)) (fun _ => 0)), sum_zero in S
      by (intros [[[a b] p] q] _; ring).
    destruct (sum_negative (fun t => -1 * (1 * crossings_of m (vector x y) x t)) (cells T)) as (t & It & N); [rewrite sum_scale; lra|].
    exists t. split; [exact It|]. destruct (crossings_count (vector x y) x t It) as ([O|O] & _ & I); [lra|now apply I].
Qed.

Lemma near_outside x y t : ~ in_cell x t -> small (fun e => ~ in_cell (mix e x y) t).
Proof.
  destruct t as [[a b] c]. unfold in_cell, within. intro N.
  assert (H : forall u v, turning u v x < 0 -> small (fun e => turning u v (mix e x y) < 0)).
  { intros u v L. apply (small_impl (fun e => 0 < (1 - e) * - turning u v x + e * - turning u v y)); [|apply small_positive; lra].
    intros e _ K. rewrite turning_mix. lra. }
  destruct (Rlt_dec (turning (m a) (m b) x) 0) as [L|L]; [|destruct (Rlt_dec (turning (m b) (m c) x) 0) as [L'|L'];
    [|destruct (Rlt_dec (turning (m c) (m a) x) 0) as [L''|L'']; [|exfalso; apply N; lra]]].
  - apply (small_impl _ _ (fun e _ K => fun W => Rlt_not_le _ _ K (proj1 W)) (H _ _ L)).
  - apply (small_impl _ _ (fun e _ K => fun W => Rlt_not_le _ _ K (proj1 (proj2 W))) (H _ _ L')).
  - apply (small_impl _ _ (fun e _ K => fun W => Rlt_not_le _ _ K (proj2 (proj2 W))) (H _ _ L'')).
Qed.

Theorem cells_cover x : (forall a b, In (a, b) (ring (border T)) -> 0 <= turning (m a) (m b) x) -> exists t, In t (cells T) /\ in_cell x t.
Proof.
  intro X. destruct some_cell as (u & Iu). assert (Hu := middle_inside u Iu). set (y := middle u) in *.
  assert (S : small (fun e => forall t, In t (cells T) -> in_cell (mix e x y) t -> in_cell x t)).
  { apply small_all. intros t _. assert (Dec : in_cell x t \/ ~ in_cell x t) by apply Classical_Prop.classic.
    destruct Dec as [I|N]; [exists 1; split; [lra|trivial]|]. apply (small_impl (fun e => ~ in_cell (mix e x y) t)); [tauto | now apply near_outside]. }
  destruct (small_exists _ (small_and _ _ S (small_below 1 Rlt_0_1))) as (e & E & H & L).
  destruct (cover_strictly (mix e x y)) as (t & It & W); [|exists t; split; [exact It | now apply H]].
  intros a b I. rewrite turning_mix. generalize (X a b I) (inside_left y u Iu Hu a b I). intros. nra.
Qed.
End placed.
