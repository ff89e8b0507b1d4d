(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Sums over translates by at most n vectors, n large: what the counts of torus_count.v and torus_count_3.v need.

   - eventually   from some n on
   - shifted      a function of integers that is 0 far down and g far up: its sum over a range that is t farther is larger by t times g *)
Require Import Reals ZArith Lra Lia Psatz List.
From Annulus Require Import sums torus_powers.
Import ListNotations.
Open Scope R_scope.

Definition eventually (Q : Z -> Prop) : Prop := exists m, forall n, (m <= n)%Z -> Q n.

Lemma eventually_and Q Q' : eventually Q -> eventually Q' -> eventually (fun n => Q n /\ Q' n).
Proof. intros (m & H) (m' & H'). exists (Z.max m m'). intros n K. split; [apply H|apply H']; lia. Qed.

Lemma eventually_impl (Q Q' : Z -> Prop) : (forall n, Q n -> Q' n) -> eventually Q -> eventually Q'.
Proof. intros I (m & H). exists m. intros n K. now apply I, H. Qed.

Lemma eventually_all {S : Type} (Q : S -> Z -> Prop) l : (forall s, eventually (Q s)) -> eventually (fun n => forall s, In s l -> Q s n).
Proof.
  intro H. induction l as [|s l IH]; [exists 0%Z; now intros|]. apply (eventually_impl (fun n => Q s n /\ forall r, In r l -> Q r n)).
  - intros n [A B] r [<-|I]; [exact A|now apply B].
  - apply eventually_and; [apply H|exact IH].
Qed.

Lemma eventually_some Q : eventually Q -> exists n, Q n.
Proof. intros (m & H). exists m. apply H. lia. Qed.

Definition over (n : Z) (f : Z -> R) : R := sum f (up_to n).

Lemma over_ext n f g : (forall i, f i = g i) -> over n f = over n g.
Proof. intro H. apply sum_ext. intros i _. apply H. Qed.

Lemma over_plus n f g : over n (fun i => f i + g i) = over n f + over n g.
Proof. apply sum_plus. Qed.

Lemma over_scale n k f : over n (fun i => k * f i) = k * over n f.
Proof. apply sum_scale. Qed.

Lemma telescope (h : nat -> R) k : sum (fun i => h (S i) - h i) (seq 0 k) = h k - h O.
Proof. induction k as [|k IH]; [simpl; ring|]. rewrite seq_S, sum_app, IH. simpl. ring. Qed.

Lemma one_farther n f : (0 <= n)%Z -> over n (fun i => f (i + 1)%Z) = over n f + (f (n + 1)%Z - f (- n)%Z).
Proof.
  intro N. assert (E := telescope (fun k => f (Z.of_nat k - n)%Z) (Z.to_nat (2 * n + 1))). cbv beta in E.
  replace (Z.of_nat (Z.to_nat (2 * n + 1)) - n)%Z with (n + 1)%Z in E by lia. replace (Z.of_nat 0 - n)%Z with (- n)%Z in E by lia.
  rewrite <- E. unfold over, up_to. rewrite !sum_map, <- sum_plus. apply sum_ext. intros k _.
  replace (Z.of_nat k - n + 1)%Z with (Z.of_nat (S k) - n)%Z by lia. ring.
Qed.

(* 0 far down, g far up. *)
Definition settles (m : Z) (f : Z -> R) (g : R) : Prop := forall i, ((i < - m)%Z -> f i = 0) /\ ((m < i)%Z -> f i = g).

Lemma shifted_up m f g n k : settles m f g -> (m + Z.of_nat k < n)%Z -> (0 <= m)%Z ->
  over n (fun i => f (i + Z.of_nat k)%Z) = over n f + INR k * g.
Proof.
  intros S K M. induction k as [|k IH].
  - simpl INR. rewrite Rmult_0_l, Rplus_0_r. apply over_ext. intro i. f_equal. lia.
  - assert (E := one_farther n (fun i => f (i + Z.of_nat k)%Z)). cbv beta in E.
    rewrite (proj2 (S (n + 1 + Z.of_nat k)%Z)), (proj1 (S (- n + Z.of_nat k)%Z)), IH in E by lia.
    rewrite S_INR. replace (over n f + (INR k + 1) * g) with (over n f + INR k * g + (g - 0)) by ring. rewrite <- E by lia.
    apply over_ext. intro i. f_equal. lia.
Qed.

Lemma shifted m f g n t : settles m f g -> (m + 2 * Z.abs t < n)%Z -> (0 <= m)%Z -> over n (fun i => f (i + t)%Z) = over n f + IZR t * g.
Proof.
  intros S K M. destruct (Z_le_gt_dec 0 t) as [T|T].
  - assert (E := shifted_up m f g n (Z.to_nat t) S). rewrite INR_IZR_INZ, Z2Nat.id in E by lia. apply E; lia.
  - assert (S' : settles (m + Z.abs t) (fun i => f (i + t)%Z) g) by (intro i; split; intro H; apply S; lia).
    assert (E := shifted_up _ _ g n (Z.to_nat (- t)) S'). cbv beta in E. rewrite INR_IZR_INZ, Z2Nat.id, opp_IZR in E by lia.
    rewrite (over_ext n (fun i => f (i + - t + t)%Z) f) in E by (intro i; f_equal; lia). rewrite E by lia. ring.
Qed.

Lemma sum_list_prod {S U : Type} (f : S * U -> R) l k : sum f (list_prod l k) = sum (fun a => sum (fun b => f (a, b)) k) l.
Proof. induction l as [|a l IH]; simpl; [reflexivity|]. now rewrite sum_app, sum_map, IH. Qed.

Lemma two_of {S : Type} (f : S -> R) l a b : (forall s, In s l -> 0 <= f s) -> In a l -> In b l -> a <> b -> f a + f b <= sum f l.
Proof.
  intros N A B D. induction l as [|s l IH]; [destruct A|]. assert (Ns := N s (or_introl eq_refl)).
  assert (Nl : forall r, In r l -> 0 <= f r) by (intros r I; apply N; now right).
  assert (One : forall r, In r l -> f r <= sum f l).
  { clear - Nl. intros r I. induction l as [|q l IH]; [destruct I|]. simpl. assert (Nq := Nl q (or_introl eq_refl)).
    assert (0 <= sum f l) by (apply sum_nonneg; intros p J; apply Nl; now right).
    destruct I as [<-|I]; [lra|]. assert (f r <= sum f l); [apply IH; trivial; intros p J; apply Nl; now right|lra]. }
  simpl. destruct A as [<-|A], B as [<-|B]; [now elim D|generalize (One b B); lra|generalize (One a A); lra|].
  assert (f a + f b <= sum f l) by now apply IH. lra.
Qed.

Lemma multiple r D : 0 < D -> exists m, (0 <= m)%Z /\ Rabs r <= IZR m * D.
Proof.
  intro H. destruct (archimed (Rabs r / D)) as [U _]. exists (up (Rabs r / D)). assert (K : 0 <= Rabs r / D).
  { apply Rmult_le_pos; [apply Rabs_pos|]. now apply Rlt_le, Rinv_0_lt_compat. }
  split; [apply le_IZR; lra|]. apply Rlt_le. replace (Rabs r) with (Rabs r / D * D) at 1 by (field; lra). now apply Rmult_lt_compat_r.
Qed.
