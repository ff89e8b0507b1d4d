(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The expiry list of a vertex (docs/theory.md 5.2, (I3); src/annulus/relocation/expiry_list.h): a few entries, sorted, and `rest`, a bound for all others.

   - kept        the invariant: each certificate of the vertex is listed with an expiry not above its own, or `rest` is not above it
   - earliest_below   so `earliest` is not above any expiry: what algorithm_filter.v asks for under `listed`, `relisted`
   - put_kept, put_new_kept   `put` and `put_new` keep it for all others and establish it for the certificate that is put
   - drop_kept   an entry may be taken off when its certificate is put back or gone
   - below_rest_listed   what expires below `rest` is on the list: no tour is needed while the reading stays below
   - tour_kept   a tour makes the list anew from any list of all certificates
   - tour_below_kept   and so does one that lists only what is below some bound, whatever the bound (`put_new` of many)
   - sorted_put, fits    the list stays sorted and within its capacity

   Two programs: `put_new` ignores what is not below `rest`, `put_sorted` takes it in and lets the last entry fall out. Expiries are real numbers here; in
   the code 32 bits whose order is theirs. *)
Require Import Reals Lra List Lia Arith.
Import ListNotations.
Open Scope R_scope.

Section list.
Variable certificate : Type.
Hypothesis same : forall a b : certificate, {a = b} + {a <> b}.
Variable capacity : nat.

Record expiries := { entries : list (certificate * R); rest : R }.

Definition kept (own : certificate -> R) (l : expiries) (c : certificate) : Prop :=
  (exists e, In (c, e) (entries l) /\ e <= own c) \/ rest l <= own c.

Definition least (l : list (certificate * R)) (r : R) : R := fold_right (fun x m => Rmin (snd x) m) r l.
Definition earliest (l : expiries) : R := least (entries l) (rest l).

Lemma least_below l r : least l r <= r /\ forall c e, In (c, e) l -> least l r <= e.
Proof.
  induction l as [|[d x] l [A B]]; simpl; [split; [lra|intros _ _ []]|]. split.
  - apply Rle_trans with (least l r); [apply Rmin_r|exact A].
  - intros c e [E|H]; [injection E as -> ->; apply Rmin_l|]. apply Rle_trans with (least l r); [apply Rmin_r|now apply B with c].
Qed.

Theorem earliest_below own l c : kept own l c -> earliest l <= own c.
Proof.
  unfold earliest. destruct (least_below (entries l) (rest l)) as [A B].
  intros [(e & H & L)|L]; [generalize (B c e H)|]; lra.
Qed.

Theorem below_rest_listed own l c reading : kept own l c -> own c <= reading -> reading < rest l ->
  exists e, In (c, e) (entries l) /\ e <= reading.
Proof. intros [(e & H & L)|L] A B; [exists e; split; [exact H|lra]|lra]. Qed.

(* In its place among entries in order. *)
Fixpoint insert (c : certificate) (e : R) (l : list (certificate * R)) : list (certificate * R) :=
  match l with
  | [] => [(c, e)]
  | x :: l' => if Rlt_dec e (snd x) then (c, e) :: l else x :: insert c e l'
  end.

Definition remove (c : certificate) (l : list (certificate * R)) := filter (fun x => if same (fst x) c then false else true) l.

(* The last entry falls out of a list that is too long. *)
Definition overflow (l : list (certificate * R)) (r : R) : expiries :=
  if le_lt_dec (length l) capacity then {| entries := l; rest := r |}
  else match rev l with
       | [] => {| entries := l; rest := r |}
       | x :: l' => {| entries := rev l'; rest := Rmin r (snd x) |}
       end.

Definition put_sorted c e (l : expiries) : expiries := overflow (insert c e (entries l)) (rest l).
Definition put_new c e (l : expiries) : expiries := if Rlt_dec e (rest l) then put_sorted c e l else l.
Definition put (program : certificate -> R -> expiries -> expiries) c e (l : expiries) : expiries :=
  program c e {| entries := remove c (entries l); rest := rest l |}.
Definition cleared (top : R) : expiries := {| entries := []; rest := top |}.

Lemma in_insert c e l x : In x (insert c e l) <-> x = (c, e) \/ In x l.
Proof.
  induction l as [|y l IH]; simpl; [intuition congruence|].
  destruct (Rlt_dec e (snd y)); simpl; [intuition congruence|]. rewrite IH. tauto.
Qed.

Lemma overflow_kept own l r c : kept own {| entries := l; rest := r |} c -> kept own (overflow l r) c.
Proof.
  unfold overflow. destruct (le_lt_dec (length l) capacity) as [_|_]; [trivial|].
  destruct (rev l) as [|x l'] eqn:E; [trivial|]. intros [(e & H & L)|L]; simpl in *.
  - rewrite in_rev, E in H. destruct H as [->|H].
    + right. simpl. apply Rle_trans with e; [apply Rmin_r|exact L].
    + left. exists e. split; [simpl; now apply -> in_rev|exact L].
  - right. simpl. apply Rle_trans with r; [apply Rmin_l|exact L].
Qed.

Section programs.
Variable own : certificate -> R.

(* For every certificate that was kept, and for the one that is put. *)
Lemma put_sorted_kept c e l d : (kept own l d \/ (d = c /\ e <= own c)) -> kept own (put_sorted c e l) d.
Proof.
  intro H. apply overflow_kept. destruct H as [[(x & I & L)|L]|[-> L]].
  - left. exists x. split; [apply in_insert; now right|exact L].
  - now right.
  - left. exists e. split; [apply in_insert; now left|exact L].
Qed.

Theorem put_new_kept c e l d : (kept own l d \/ (d = c /\ e <= own c)) -> kept own (put_new c e l) d.
Proof.
  unfold put_new. destruct (Rlt_dec e (rest l)) as [_|N]; [apply put_sorted_kept|].
  intros [K|[-> L]]; [exact K|right; lra].
Qed.

Lemma remove_kept c l d : d <> c -> kept own l d -> kept own {| entries := remove c (entries l); rest := rest l |} d.
Proof.
  intros N [(e & H & L)|L]; [left|now right]. exists e. split; [|exact L].
  apply filter_In. split; [exact H|]. simpl. destruct (same d c); [contradiction|reflexivity].
Qed.

Theorem put_kept program c e l d : program = put_new \/ program = put_sorted ->
  ((d <> c /\ kept own l d) \/ (d = c /\ e <= own c)) -> kept own (put program c e l) d.
Proof.
  intros P H. assert (K : kept own {| entries := remove c (entries l); rest := rest l |} d \/ (d = c /\ e <= own c)).
  { destruct H as [[N K]|K]; [left; now apply remove_kept|now right]. }
  destruct P as [Q|Q]; rewrite Q; [now apply put_new_kept|now apply put_sorted_kept].
Qed.

(* What is taken off, with all it has there: the others keep their entries. *)
Theorem drop_kept c l d : d <> c -> kept own l d -> kept own {| entries := remove c (entries l); rest := rest l |} d.
Proof. apply remove_kept. Qed.

(* A tour: all certificates of the vertex put on an empty list. *)
Theorem tour_kept program top all d : program = put_new \/ program = put_sorted -> In d all ->
  kept own (fold_right (fun c l => program c (own c) l) (cleared top) all) d.
Proof.
  intros P. induction all as [|c all IH]; [intros []|]. intros [E|H]; simpl.
  - subst c. destruct P as [Q|Q]; rewrite Q; [apply put_new_kept|apply put_sorted_kept]; right; (split; [reflexivity|lra]).
  - destruct P as [Q|Q]; rewrite Q in *; [apply put_new_kept|apply put_sorted_kept]; left; now apply IH.
Qed.

(* What is not below a bound is left to `rest`. *)
Definition put_below bound c e (l : expiries) : expiries :=
  if Rlt_dec e bound then put_sorted c e l else {| entries := entries l; rest := Rmin (rest l) e |}.

Theorem put_below_kept bound c e l d : (kept own l d \/ (d = c /\ e <= own c)) -> kept own (put_below bound c e l) d.
Proof.
  unfold put_below. destruct (Rlt_dec e bound) as [_|_]; [apply put_sorted_kept|]. intros [[(x & I & L)|L]|[-> L]].
  - left. now exists x.
  - right. simpl. apply Rle_trans with (rest l); [apply Rmin_l|exact L].
  - right. simpl. apply Rle_trans with e; [apply Rmin_r|exact L].
Qed.

Theorem tour_below_kept bound top all d : In d all ->
  kept own (fold_right (fun c l => put_below bound c (own c) l) (cleared top) all) d.
Proof.
  induction all as [|c all IH]; [intros []|]. intros [E|H]; simpl; apply put_below_kept.
  - subst c. right. split; [reflexivity|lra].
  - left. now apply IH.
Qed.
End programs.

(* Order: the first entry is the least, and `earliest` need look at no other. *)
Fixpoint sorted (l : list (certificate * R)) : Prop :=
  match l with [] => True | x :: l' => (forall y, In y l' -> snd x <= snd y) /\ sorted l' end.

Lemma sorted_insert c e l : sorted l -> sorted (insert c e l).
Proof.
  induction l as [|x l IH]; simpl; [intros _; split; [intros _ []|trivial]|]. intros [A B].
  destruct (Rlt_dec e (snd x)) as [L|L].
  - simpl. split; [|now split]. intros y [<-|H]; [simpl; lra|]. generalize (A y H). simpl. lra.
  - simpl. split; [|now apply IH]. intros y H. apply in_insert in H. destruct H as [->|H]; [simpl; lra|now apply A].
Qed.

Lemma sorted_prefix l x : sorted (l ++ [x]) -> sorted l.
Proof.
  induction l as [|y l IH]; simpl; [trivial|]. intros [A B]. split; [|now apply IH].
  intros z H. apply A, in_or_app. now left.
Qed.

Theorem sorted_put c e l : sorted (entries l) -> sorted (entries (put_sorted c e l)).
Proof.
  intro H. apply (sorted_insert c e) in H. unfold put_sorted, overflow.
  destruct (le_lt_dec _ capacity) as [_|_]; [exact H|].
  destruct (rev (insert c e (entries l))) as [|x l'] eqn:E; [exact H|].
  assert (F : insert c e (entries l) = rev l' ++ [x]) by (rewrite <- (rev_involutive (insert c e (entries l))), E; reflexivity).
  rewrite F in H. simpl. now apply sorted_prefix with x.
Qed.

Theorem earliest_is_first x l r : sorted (x :: l) -> earliest {| entries := x :: l; rest := r |} = Rmin (snd x) r.
Proof.
  intros [A _]. unfold earliest. simpl.
  assert (H : forall l, (forall y, In y l -> snd x <= snd y) -> Rmin (snd x) (least l r) = Rmin (snd x) r).
  { clear. induction l as [|y l IH]; intro A; [reflexivity|]. simpl. rewrite Rmin_assoc, (Rmin_left (snd x)).
    - apply IH. intros z H. apply A. now right.
    - apply A. now left. }
  now apply H.
Qed.

Lemma length_insert c e l : length (insert c e l) = S (length l).
Proof. induction l as [|x l IH]; simpl; [reflexivity|]. destruct (Rlt_dec e (snd x)); simpl; [reflexivity|now rewrite IH]. Qed.

Theorem fits c e l : (length (entries l) <= capacity)%nat -> (length (entries (put_sorted c e l)) <= capacity)%nat.
Proof.
  intro H. unfold put_sorted, overflow. destruct (le_lt_dec _ capacity) as [L|_]; [exact L|].
  destruct (rev (insert c e (entries l))) as [|x l'] eqn:E.
  - apply (f_equal (@length _)) in E. rewrite rev_length, length_insert in E. discriminate.
  - apply (f_equal (@length _)) in E. rewrite rev_length, length_insert in E. simpl in *. rewrite rev_length. lia.
Qed.
End list.
