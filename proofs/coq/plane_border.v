(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The border of a mesh in the plane: docs/theory.md 1.2, lemma 2.

   - crossed_once   where the border winds once, every level ray crosses it at most once, counted with signs
   - border_left    where it is also convex at every ridge, all of it is on the left of each of its edges *)
Require Import Reals Lra Psatz List Permutation.
From Annulus Require Import sums width_2 plane_mesh plane_paths plane_crossings.
Import ListNotations.
Open Scope R_scope.

Definition level : point_2 := (1, 0).

Lemma cross_level u : cross level u = snd u.
Proof. unfold cross, level. simpl. ring. Qed.

Lemma up_not_lower u v : points_up u v = true -> snd u <= snd v.
Proof. unfold points_up. destruct (Rlt_dec _ _); [lra|]. destruct (Req_EM_T _ _); [lra|discriminate]. Qed.

Lemma down_not_higher u v : points_up u v = false -> snd v <= snd u.
Proof. unfold points_up. destruct (Rlt_dec _ _); [discriminate|]. lra. Qed.

Section placed.
Variable m : placement.

Definition passes_at x (s : nat * nat) : R := let '(u, v) := s in passes level x (m u) (m v).
Definition crossing_at x (s : nat * nat) : R := let '(u, v) := s in crossing level x (m u) (m v).

Lemma rises_cons u v p : rises m (u :: v :: p) -> points_up (m u) (m v) = true /\ rises m (v :: p).
Proof. intro H. split; [apply H; now left|]. intros a b I. apply H. now right. Qed.

Lemma climb_above x p : forall u, rises m (u :: p) -> snd x < snd (m u) -> sum (passes_at x) (steps (u :: p)) = 0.
Proof.
  induction p as [|v p IH]; intros u H L; [reflexivity|]. destruct (rises_cons u v p H) as (U & R). apply up_not_lower in U.
  rewrite steps_cons, sum_cons, (IH v R) by lra. unfold passes_at. rewrite passes_none; [ring|]. rewrite !cross_level. now left.
Qed.

Lemma climb x p : forall u, rises m (u :: p) -> sum (passes_at x) (steps (u :: p)) <= 1.
Proof.
  induction p as [|v p IH]; intros u H; [simpl; lra|]. destruct (rises_cons u v p H) as (_ & R).
  rewrite steps_cons, sum_cons. specialize (IH v R). unfold passes_at at 1, passes. rewrite !cross_level.
  destruct (Rle_dec (snd (m u)) (snd x)); [|lra]. destruct (Rle_dec (snd (m v)) (snd x)); [lra|].
  rewrite (climb_above x p v R) by lra. destruct (Rlt_dec _ _); lra.
Qed.

Lemma falls_none x p : falls m p -> sum (passes_at x) (steps p) = 0.
Proof.
  intro H. rewrite (sum_ext _ (fun _ => 0)); [apply sum_zero|]. intros [u v] I. simpl. apply passes_none.
  rewrite !cross_level. right. now apply down_not_higher, H.
Qed.

Theorem crossed_once x l : winds_once m l -> sum (crossing_at x) (ring l) <= 1.
Proof.
  intro W. destruct (rise_and_fall m l W) as (v & p & P & _ & k1 & t & k2 & E & R & F).
  apply Rle_trans with (sum (passes_at x) (ring l)).
  - apply sum_le. intros [a b] _. simpl. unfold crossing. generalize (passes_nonneg level x (m b) (m a)). lra.
  - rewrite (sum_permutation _ _ _ P), E, steps_app, sum_app, (falls_none x (t :: k2) F).
    destruct k1 as [|u k1]; [simpl; lra|]. generalize (climb x (k1 ++ [t]) u R). simpl. lra.
Qed.

(* ---- Convex ---- *)

Definition upward (e : point_2) : Prop := 0 < snd e \/ (snd e = 0 /\ 0 < fst e).
Definition downward (e : point_2) : Prop := snd e < 0 \/ (snd e = 0 /\ fst e < 0).

Lemma upward_order e f g : upward e -> upward f -> upward g -> 0 <= cross e f -> 0 <= cross f g -> 0 <= cross e g.
Proof.
  unfold upward, cross. destruct e as [x1 y1], f as [x2 y2], g as [x3 y3]. simpl. intros U1 U2 U3 H1 H2.
  assert (E : (x1 * y3 - y1 * x3) * y2 = (x1 * y2 - y1 * x2) * y3 + (x2 * y3 - y2 * x3) * y1) by ring.
  assert (0 <= y1) by lra. assert (0 <= y3) by lra. destruct U2 as [U2|[U2 V2]].
  - apply Rmult_le_reg_r with y2; [exact U2|]. rewrite Rmult_0_l, E. apply Rplus_le_le_0_compat; now apply Rmult_le_pos.
  - subst y2. assert (y1 = 0) by nra. subst y1. destruct U1 as [U1|[_ U1]]; [lra|]. nra.
Qed.

Lemma downward_opposite e : downward e -> upward (- fst e, - snd e).
Proof. unfold downward, upward. simpl. lra. Qed.

Lemma downward_order e f g : downward e -> downward f -> downward g -> 0 <= cross e f -> 0 <= cross f g -> 0 <= cross e g.
Proof.
  intros U V W H K. generalize (upward_order _ _ _ (downward_opposite e U) (downward_opposite f V) (downward_opposite g W)).
  unfold cross in *. simpl. intro L. assert (0 <= - fst e * - snd g - - snd e * - fst g); [apply L|]; nra.
Qed.

(* Seen from e, what goes down goes away first and comes back then. *)
Lemma upward_once e f g : upward e -> downward f -> downward g -> 0 <= cross f g -> cross e f < 0 -> cross e g <= 0.
Proof.
  intros U V W H K. generalize (upward_order e _ _ U (downward_opposite f V) (downward_opposite g W)).
  unfold cross in *. simpl. intro L. assert (0 <= fst e * - snd g - snd e * - fst g); [apply L|]; nra.
Qed.

Lemma downward_once e f g : downward e -> upward f -> upward g -> 0 <= cross f g -> cross e f < 0 -> cross e g <= 0.
Proof.
  intros U V W H K. generalize (upward_order _ f g (downward_opposite e U) V W).
  unfold cross in *. simpl. intro L. assert (0 <= - fst e * snd g - - snd e * fst g); [apply L|]; nra.
Qed.

Definition along (s : nat * nat) : point_2 := let '(u, v) := s in vector (m u) (m v).
Definition in_order (s r : nat * nat) : Prop := 0 <= cross (along s) (along r).
Definition bends_left (p : list nat) : Prop := forall u v w, In (u, v, w) (bends p) -> convex_at m u v w.

Lemma convex_order u v w : convex_at m u v w -> in_order (u, v) (v, w).
Proof.
  unfold convex_at, in_order, along, turn_at, turning, turn, cross, vector. simpl. intros [H|[H _]]; nra.
Qed.

Lemma chain_sorted (side : point_2 -> Prop) p : (forall e f g, side e -> side f -> side g -> 0 <= cross e f -> 0 <= cross f g -> 0 <= cross e g) ->
  (forall s, In s (steps p) -> side (along s)) -> bends_left p -> ForallOrdPairs in_order (steps p).
Proof.
  intro Trans. induction p as [|a p IH]; intros S B; [constructor|]. destruct p as [|b p]; [constructor|]. rewrite steps_cons in *.
  assert (Rest : ForallOrdPairs in_order (steps (b :: p))).
  { apply IH; [intros s I; apply S; now right|]. intros u v w I. apply B. destruct p as [|c p]; [easy|]. rewrite bends_cons. now right. }
  constructor; [|exact Rest]. destruct p as [|c p]; [constructor|]. rewrite steps_cons in *.
  assert (First : in_order (a, b) (b, c)) by (apply convex_order, B; now left).
  constructor; [exact First|]. inversion Rest as [|x l' Next _]. subst. rewrite Forall_forall in *. intros s I.
  apply (Trans _ (along (b, c))); [apply S; now left | apply S; right; now left | apply S; right; now right | exact First | now apply Next].
Qed.

Lemma turn_along a b u v : turn_at m a b v - turn_at m a b u = cross (along (a, b)) (along (u, v)).
Proof. unfold turn_at, turning, turn, along, cross, vector. simpl. ring. Qed.

Lemma pairs_split {S : Type} (Q : S -> S -> Prop) l1 x l2 : ForallOrdPairs Q (l1 ++ x :: l2) -> (forall y, In y l1 -> Q y x) /\ (forall y, In y l2 -> Q x y).
Proof.
  induction l1 as [|y l1 IH]; simpl; intro H; inversion H as [|z l' F H']; subst; rewrite Forall_forall in F.
  - split; [easy|exact F].
  - destruct (IH H') as [I J]. split; [|exact J]. intros z [<-|Z]; [apply F, in_or_app; right; now left | now apply I].
Qed.

Lemma pairs_impl {S : Type} (Q Q' : S -> S -> Prop) l : (forall x y, In x l -> In y l -> Q x y -> Q' x y) ->
  ForallOrdPairs Q l -> ForallOrdPairs Q' l.
Proof.
  intros H P. induction P as [|x l F P IH]; constructor.
  - rewrite Forall_forall in *. intros y Y. apply H; [now left | now right | now apply F].
  - apply IH. intros y z Y Z. apply H; now right.
Qed.

Lemma never_below_head (F : nat -> R) p : (forall u v, In (u, v) (steps p) -> F u <= F v) -> forall w, In w p -> F (hd O p) <= F w.
Proof.
  induction p as [|a p IH]; intros H w W; [easy|]. destruct W as [<-|W]; [simpl; lra|]. destruct p as [|b p]; [easy|].
  apply Rle_trans with (F b); [apply H; now left|]. apply IH; [|exact W]. intros u v I. apply H. now right.
Qed.

Lemma never_below_last (F : nat -> R) p : (forall u v, In (u, v) (steps p) -> F v <= F u) -> forall w, In w p -> F (last p O) <= F w.
Proof.
  induction p as [|a p IH]; intros H w W; [easy|]. destruct p as [|b p]; [destruct W as [<-|[]]; simpl; lra|].
  change (last (a :: b :: p) O) with (last (b :: p) O). assert (K : forall w, In w (b :: p) -> F (last (b :: p) O) <= F w)
    by (apply IH; intros u v I; apply H; now right).
  destruct W as [<-|W]; [|now apply K]. apply Rle_trans with (F b); [apply K; now left | apply H; now left].
Qed.

(* What first rises and then falls is least at its ends. *)
Lemma never_below_ends (F : nat -> R) p : ForallOrdPairs (fun s r => F (snd s) < F (fst s) -> F (snd r) <= F (fst r)) (steps p) ->
  0 <= F (hd O p) -> 0 <= F (last p O) -> forall w, In w p -> 0 <= F w.
Proof.
  induction p as [|a p IH]; intros S A L w W; [easy|]. destruct p as [|b p]; [destruct W as [<-|[]]; exact A|].
  rewrite steps_cons in S. inversion S as [|s l' First Rest]. subst. rewrite Forall_forall in First. cbn [fst snd] in First.
  destruct W as [<-|W]; [exact A|]. change (last (a :: b :: p) O) with (last (b :: p) O) in L.
  destruct (Rlt_dec (F b) (F a)) as [D|D].
  - apply Rle_trans with (F (last (b :: p) 0%nat)); [exact L|]. apply never_below_last; [|exact W]. intros u v I. now apply (First (u, v) I).
  - apply IH; trivial. simpl in *. lra.
Qed.

Lemma chain_left p a b : ForallOrdPairs in_order (steps p) -> In (a, b) (steps p) -> forall w, In w p -> 0 <= turn_at m a b w.
Proof.
  intros S I w W. destruct (steps_split p a b I) as (q1 & q2 & ->).
  replace (q1 ++ a :: b :: q2) with ((q1 ++ [a]) ++ b :: q2) in W by now rewrite <- app_assoc.
  rewrite steps_app, steps_cons in S. destruct (pairs_split _ _ _ _ S) as [Before After].
  assert (Za : turn_at m a b a = 0) by (unfold turn_at, turning, turn; ring).
  assert (Zb : turn_at m a b b = 0) by (unfold turn_at, turning, turn; ring).
  apply in_app_or in W. destruct W as [W|W].
  - assert (N := never_below_last (turn_at m a b) (q1 ++ [a])). rewrite last_last, Za in N. apply N; [|exact W].
    intros u v J. generalize (turn_along a b u v) (Before _ J). unfold in_order, cross. lra.
  - rewrite <- Zb at 1. apply (never_below_head (turn_at m a b) (b :: q2)); [|exact W].
    intros u v J. generalize (turn_along a b u v) (After _ J). unfold in_order. lra.
Qed.

(* Two chains, one up and one down, from the end of each to the other's beginning. *)
Lemma chains_left (side other : point_2 -> Prop) p r a b :
  (forall e f g, side e -> other f -> other g -> 0 <= cross f g -> cross e f < 0 -> cross e g <= 0) ->
  (forall s, In s (steps p) -> side (along s)) -> (forall s, In s (steps r) -> other (along s)) ->
  ForallOrdPairs in_order (steps p) -> ForallOrdPairs in_order (steps r) ->
  In (hd O r) p -> In (last r O) p -> In (a, b) (steps p) -> forall w, In w p \/ In w r -> 0 <= turn_at m a b w.
Proof.
  intros Once P R Op Or H L I w [W|W]; [now apply chain_left with p|].
  apply (never_below_ends (turn_at m a b) r); [|now apply chain_left with p|now apply chain_left with p|exact W].
  apply pairs_impl with (2 := Or). intros [u v] [u' v'] J K Q. simpl fst. simpl snd. intro D.
  assert (C := Once (along (a, b)) _ _ (P _ I) (R _ J) (R _ K) Q).
  generalize (turn_along a b u v) (turn_along a b u' v'). lra.
Qed.

(* ---- The whole border ---- *)

Lemma convex_no_point l u v : convex m l -> winds_once m l -> In (u, v) (ring l) -> fst (m u) <> fst (m v) \/ snd (m u) <> snd (m v).
Proof.
  intros C W I. destruct l as [|a [|b r]]; [discriminate W|discriminate W|]. rewrite ring_ridges in I. apply in_map_iff in I.
  destruct I as ([[u' v'] w] & E & I). injection E as -> ->. specialize (C u v w I).
  destruct (Req_EM_T (fst (m u)) (fst (m v))) as [X|X]; [|now left]. destruct (Req_EM_T (snd (m u)) (snd (m v))) as [Y|Y]; [|now right].
  exfalso. unfold convex_at, turn_at, turning, turn, dot, vector in C. simpl in C. rewrite X, Y in C. lra.
Qed.

Lemma up_upward u v : points_up u v = true -> upward (vector u v).
Proof.
  unfold points_up, upward, vector. simpl. destruct (Rlt_dec _ _); [lra|]. destruct (Req_EM_T _ _); [|discriminate].
  destruct (Rlt_dec _ _); [lra|discriminate].
Qed.

Lemma down_downward u v : points_up u v = false -> fst u <> fst v \/ snd u <> snd v -> downward (vector u v).
Proof.
  unfold points_up, downward, vector. simpl. destruct (Rlt_dec _ _); [discriminate|]. destruct (Req_EM_T _ _).
  - destruct (Rlt_dec _ _); [discriminate|]. lra.
  - lra.
Qed.

Lemma last_cut (k : list nat) t r : last (k ++ t :: r) O = last (t :: r) O.
Proof. induction k as [|a k IH]; [reflexivity|]. cbn [app]. rewrite <- IH. destruct k; reflexivity. Qed.

Lemma last_in (k : list nat) t : In (last (t :: k) O) (t :: k).
Proof. revert t. induction k as [|u k IH]; intro t; [now left|]. right. apply IH. Qed.

Theorem border_left l a b u v : convex m l -> winds_once m l -> In (a, b) (ring l) -> In (u, v) (ring l) ->
  0 <= turn_at m a b u /\ 0 <= turn_at m a b v.
Proof.
  intros C W Ie Is. destruct (rise_and_fall m l W) as (v0 & q & P & B & k1 & t & k2 & E & R & F).
  assert (NoPoint : forall s, In s (steps (v0 :: q ++ [v0])) -> fst (m (fst s)) <> fst (m (snd s)) \/ snd (m (fst s)) <> snd (m (snd s))).
  { intros [c d] J. apply (convex_no_point l c d C W). now rewrite P. }
  rewrite P, E in Ie, Is. rewrite E in B, NoPoint. rewrite steps_app in Ie, NoPoint. apply steps_in in Is.
  assert (First : forall s, In s (steps (k1 ++ [t])) -> upward (along s)) by (intros [c d] J; now apply up_upward, R).
  assert (Then : forall s, In s (steps (t :: k2)) -> downward (along s))
    by (intros [c d] J; apply down_downward; [now apply F|]; apply (NoPoint (c, d)), in_or_app; now right).
  assert (Op : ForallOrdPairs in_order (steps (k1 ++ [t]))).
  { apply (chain_sorted upward); [exact upward_order|exact First|]. intros c d e J. now apply C, B, bends_head. }
  assert (Or : ForallOrdPairs in_order (steps (t :: k2))).
  { apply (chain_sorted downward); [exact downward_order|exact Then|]. intros c d e J. now apply C, B, bends_tail. }
  assert (Ends : In (last (t :: k2) O) (k1 ++ [t]) /\ In (hd O (k1 ++ [t])) (t :: k2)).
  { assert (L : last (t :: k2) O = v0) by (rewrite <- (last_cut k1), <- E; change (v0 :: q ++ [v0]) with ((v0 :: q) ++ [v0]); apply last_last).
    assert (H : hd O (k1 ++ [t]) = v0) by (destruct k1; injection E as -> _; reflexivity).
    split; [rewrite L, <- H; destruct k1; now left|]. rewrite H, <- L. apply last_in. }
  assert (All : forall w, In w (k1 ++ t :: k2) -> In w (k1 ++ [t]) \/ In w (t :: k2)).
  { intro w. rewrite !in_app_iff. simpl. tauto. }
  assert (Left : forall w, In w (k1 ++ t :: k2) -> 0 <= turn_at m a b w).
  { intros w J. apply All in J. apply in_app_or in Ie. destruct Ie as [Ie|Ie].
    - apply (chains_left upward downward (k1 ++ [t]) (t :: k2)); trivial; [exact upward_once| |tauto]. simpl. apply in_or_app. right. now left.
    - apply (chains_left downward upward (t :: k2) (k1 ++ [t])); trivial; [exact downward_once|tauto| |tauto]. rewrite last_last. now left. }
  split; apply Left, Is.
Qed.
End placed.
