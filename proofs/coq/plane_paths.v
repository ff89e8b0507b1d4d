(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Closed paths as lists of vertices.

   - begin_at        a closed path may begin at any of its ridges
   - rise_and_fall   one that enters the upper half-plane once goes up, then down *)
Require Import Reals List Permutation Bool Arith.
From Annulus Require Import plane_mesh.
Import ListNotations.

Lemma steps_cons u v l : steps (u :: v :: l) = (u, v) :: steps (v :: l).
Proof. reflexivity. Qed.
Lemma bends_cons u v w l : bends (u :: v :: w :: l) = (u, v, w) :: bends (v :: w :: l).
Proof. reflexivity. Qed.

Lemma steps_app l v r : steps (l ++ v :: r) = steps (l ++ [v]) ++ steps (v :: r).
Proof.
  induction l as [|u l IH]; [reflexivity|]. destruct l as [|w l]; [reflexivity|].
  cbn [app] in *. rewrite !steps_cons, IH. reflexivity.
Qed.

Lemma bends_app l u v r : bends (l ++ u :: v :: r) = bends (l ++ [u; v]) ++ bends (u :: v :: r).
Proof.
  induction l as [|a l IH]; [reflexivity|]. destruct l as [|b [|c l]]; [reflexivity|reflexivity|].
  cbn [app] in *. rewrite !(bends_cons a), IH. reflexivity.
Qed.

Lemma bends_head l v r : incl (bends (l ++ [v])) (bends (l ++ v :: r)).
Proof.
  intros x. destruct r as [|w r]; [trivial|]. induction l as [|a l IH]; [easy|]. destruct l as [|b [|c l]].
  - easy.
  - intros [E|[]]. now left.
  - cbn [app] in *. rewrite !(bends_cons a). intros [E|H]; [now left|right; now apply IH].
Qed.

Lemma bends_tail l r : incl (bends r) (bends (l ++ r)).
Proof.
  intros x H. induction l as [|a l IH]; [exact H|]. cbn [app]. destruct (l ++ r) as [|b [|c k]]; [easy|easy|]. now right.
Qed.

Lemma steps_split p a b : In (a, b) (steps p) -> exists q1 q2, p = q1 ++ a :: b :: q2.
Proof.
  induction p as [|u p IH]; [easy|]. destruct p as [|v p]; [easy|]. rewrite steps_cons. intros [E|H].
  - injection E as -> ->. now exists [], p.
  - destruct (IH H) as (q1 & q2 & ->). now exists (u :: q1), q2.
Qed.

Lemma steps_in p a b : In (a, b) (steps p) -> In a p /\ In b p.
Proof. intro H. destruct (steps_split p a b H) as (q1 & q2 & ->). rewrite !in_app_iff. simpl. tauto. Qed.

Lemma edge_bends l b : map edge (bends (l ++ [b])) = steps l.
Proof.
  induction l as [|u l IH]; [reflexivity|]. destruct l as [|v l]; [reflexivity|].
  rewrite steps_cons, <- IH. destruct l as [|w l]; reflexivity.
Qed.

Lemma ring_ridges u v r : ring (u :: v :: r) = map edge (ridges (u :: v :: r)).
Proof. unfold ring, ridges. cbn [firstn]. rewrite <- (edge_bends _ v), <- app_assoc. reflexivity. Qed.

(* ---- Where a closed path begins ---- *)

Lemma begin_later v w r : exists x k, ridges (v :: w :: r) = x :: k /\ ridges ((w :: r) ++ [v]) = k ++ [x] /\
  Permutation (ring (v :: w :: r)) (ring ((w :: r) ++ [v])).
Proof.
  assert (P : Permutation (ring (v :: w :: r)) (ring ((w :: r) ++ [v]))).
  { unfold ring. cbn [firstn app]. rewrite steps_cons. rewrite <- app_assoc. cbn [app].
    change (w :: r ++ [v; w]) with ((w :: r) ++ v :: [w]). rewrite steps_app. apply Permutation_cons_append. }
  destruct r as [|a r].
  - exists (v, w, v), [(w, v, w)]. repeat split. exact P.
  - exists (v, w, a), (bends ((w :: a :: r) ++ [v; w])). repeat split; [|exact P].
    unfold ridges. cbn [firstn app]. rewrite <- app_assoc. cbn [app].
    change (w :: a :: r ++ [v; w; a]) with ((w :: a :: r) ++ v :: w :: [a]). rewrite bends_app. reflexivity.
Qed.

Lemma ridges_long l x k : ridges l = x :: k -> exists u v r w, l = u :: v :: r /\ x = (u, v, w).
Proof.
  destruct l as [|u [|v r]]; [discriminate|discriminate|]. unfold ridges. cbn [firstn app]. intro H.
  exists u, v, r. destruct r as [|w r]; injection H as <- _; eexists; split; reflexivity.
Qed.

Lemma begin_at b1 : forall x b2 l, ridges l = b1 ++ x :: b2 -> exists l', ridges l' = x :: b2 ++ b1 /\ Permutation (ring l) (ring l').
Proof.
  induction b1 as [|y b1 IH]; intros x b2 l H.
  - exists l. rewrite app_nil_r. now split.
  - destruct (ridges_long l _ _ H) as (v & w & r & _ & -> & _). destruct (begin_later v w r) as (y' & k & E & E' & P).
    rewrite E in H. injection H as -> ->. destruct (IH x (b2 ++ [y]) ((w :: r) ++ [v])) as (l' & R & Q).
    { rewrite E', <- app_assoc. reflexivity. }
    exists l'. split; [rewrite R, <- app_assoc; reflexivity|]. now rewrite P.
Qed.

(* ---- Up, then down ---- *)

Definition rises (m : placement) (p : list nat) : Prop := forall u v, In (u, v) (steps p) -> points_up (m u) (m v) = true.
Definition falls (m : placement) (p : list nat) : Prop := forall u v, In (u, v) (steps p) -> points_up (m u) (m v) = false.

Lemma stays_down m p : forall a b, points_up (m a) (m b) = false -> (forall r, In r (bends (a :: b :: p)) -> enters m r = false) ->
  falls m (a :: b :: p).
Proof.
  induction p as [|c p IH]; intros a b D N u v; rewrite steps_cons; intros [E|H]; try (injection E as <- <-; exact D); [easy|].
  apply (IH b c); trivial.
  - specialize (N (a, b, c) (or_introl eq_refl)). simpl in N. now rewrite D in N.
  - intros r R. apply N. rewrite bends_cons. now right.
Qed.

Lemma up_then_down m p : forall a b, points_up (m a) (m b) = true -> (forall r, In r (bends (a :: b :: p)) -> enters m r = false) ->
  exists k1 t k2, a :: b :: p = k1 ++ t :: k2 /\ rises m (k1 ++ [t]) /\ falls m (t :: k2).
Proof.
  induction p as [|c p IH]; intros a b U N.
  - exists [a], b, []. repeat split; [|easy]. intros u v [E|[]]. now injection E as <- <-.
  - destruct (points_up (m b) (m c)) eqn:V.
    + destruct (IH b c V) as (k1 & t & k2 & E & R & F); [intros r H; apply N; rewrite bends_cons; now right|].
      exists (a :: k1), t, k2. split; [simpl; now rewrite E|]. split; [|exact F].
      assert (Head : exists q, k1 ++ [t] = b :: q) by (destruct k1; injection E as <- _; eexists; reflexivity).
      destruct Head as (q & Q). cbn [app]. rewrite Q in R |- *. intros u v. rewrite steps_cons.
      intros [K|K]; [now injection K as <- <- | now apply R].
    + exists [a], b, (c :: p). repeat split.
      * intros u v [E|[]]. now injection E as <- <-.
      * apply stays_down; [exact V|]. intros r H. apply N. rewrite bends_cons. now right.
Qed.

Theorem rise_and_fall m l : winds_once m l -> exists v p, Permutation (ring l) (steps (v :: p ++ [v])) /\
  incl (bends (v :: p ++ [v])) (ridges l) /\ exists k1 t k2, v :: p ++ [v] = k1 ++ t :: k2 /\ rises m (k1 ++ [t]) /\ falls m (t :: k2).
Proof.
  unfold winds_once. intro O.
  assert (X : exists x, In x (filter (enters m) (ridges l))) by (destruct (filter _ _) as [|x f]; [discriminate|exists x; now left]).
  destruct X as (x & X). apply filter_In in X. destruct X as (X & En). apply in_split in X. destruct X as (b1 & b2 & B).
  destruct (begin_at b1 x b2 l B) as (l' & R & P). destruct (ridges_long l' _ _ R) as (u & v & r & w & -> & ->).
  assert (S : bends (u :: v :: r ++ [u; v]) = (u, v, w) :: bends (v :: r ++ [u; v])).
  { unfold ridges in R. cbn [firstn app] in R. destruct r as [|c r]; cbn [app] in *; rewrite bends_cons in *; injection R as -> _; reflexivity. }
  assert (Rest : bends (v :: r ++ [u; v]) = b2 ++ b1).
  { unfold ridges in R. cbn [firstn app] in R. rewrite S in R. now injection R. }
  exists v, (r ++ [u]). rewrite <- app_assoc. cbn [app]. split; [|split].
  - rewrite P. unfold ring. cbn [firstn app]. rewrite steps_cons.
    change (v :: r ++ [u; v]) with ((v :: r) ++ u :: [v]). rewrite steps_app. apply Permutation_cons_append.
  - intros s. rewrite Rest, B, !in_app_iff. simpl. tauto.
  - assert (N : forall s, In s (bends (v :: r ++ [u; v])) -> enters m s = false).
    { intros s. rewrite Rest. intro I. destruct (enters m s) eqn:E; [exfalso|reflexivity].
      assert (K : In s (filter (enters m) (b2 ++ b1))) by (apply filter_In; now split).
      rewrite B in O. rewrite filter_app, app_length in O. cbn [filter] in O. rewrite En in O. cbn [length] in O.
      rewrite <- plus_n_Sm, <- app_length, <- filter_app in O. injection O as O.
      rewrite filter_app, app_length, Nat.add_comm, <- app_length, <- filter_app in O. now destruct (filter _ (b2 ++ b1)). }
    simpl in En. apply andb_prop in En. destruct En as (_ & U).
    destruct r as [|c r]; cbn [app] in *; rewrite !bends_cons in S; injection S as ->; now apply up_then_down.
Qed.
