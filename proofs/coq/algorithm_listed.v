(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What is true of the expiry list of a vertex (algorithm_list.v; docs/theory.md 5.2, (I3)).

   - kept        the invariant: a certificate is listed with an expiry not above its own, or `rest` is not above it
   - put_new_kept, put_kept, put_many_kept    put, put_new, put_new of many keep it for all others and establish it
     for what is put
   - put_many_kept_any    whatever the bound that is found by counting
   - take_kept, take_finds   take_reached visits every certificate that expired, unless `rest` has expired too; what it does not
     visit stays listed
   - earliest_below, below_rest    nothing expires before `earliest`; what is kept and has expired while `rest` has not is an entry
   - put_proper, put_new_proper, put_many_proper, take_proper, cleared_proper    entries are as many as ever, in order, in range *)
Require Import ZArith List Sorting.Sorted Bool Lia.
From Annulus Require Export algorithm_list.
Import ListNotations.
Open Scope Z_scope.

Section listed.
Variable capacity : nat.
Local Notation cleared := (cleared capacity).
Local Notation bound_of := (bound_of capacity).
Local Notation put_many := (put_many capacity).

Definition ordered := StronglySorted Z.le.
Record tidy (l : expiry_list) : Prop := { full : length (entries l) = capacity; in_order : ordered (entries l) }.
Definition kept (l : expiry_list) (id own : Z) : Prop :=
  (exists e, In e (entries l) /\ id_of e = id /\ expiry_of e <= own) \/ rest l <= own.

Lemma upper_half e : expiry_of e = e / 2 ^ 32.
Proof. unfold expiry_of. now rewrite Z.shiftr_div_pow2. Qed.
Lemma lower_half e : id_of e = e mod 2 ^ 32.
Proof. unfold id_of. now rewrite <- Z.land_ones. Qed.
Lemma entry_expiry expiry id : is_id id -> expiry_of (entry expiry id) = expiry.
Proof.
  intros [A B]. rewrite upper_half. unfold entry, none in *. rewrite Z.div_add_l by lia. rewrite Z.div_small by lia. lia.
Qed.
Lemma entry_id expiry id : is_id id -> id_of (entry expiry id) = id.
Proof.
  intros [A B]. rewrite lower_half. unfold entry, none in *. rewrite Z.add_comm, Z.mod_add by lia. apply Z.mod_small. lia.
Qed.
Lemma expiry_le e f : e <= f -> expiry_of e <= expiry_of f.
Proof. intro H. rewrite !upper_half. apply Z.div_le_mono; lia. Qed.
Lemma entry_parts e : e = entry (expiry_of e) (id_of e).
Proof. unfold entry. rewrite upper_half, lower_half. generalize (Z.div_mod e (2 ^ 32) ltac:(lia)). lia. Qed.
Lemma id_bounds e : 0 <= id_of e < 2 ^ 32.
Proof. rewrite lower_half. apply Z.mod_pos_bound. lia. Qed.

(* Nothing is lost on the way through the array. *)
Lemma exchange_in l : forall moving m out, exchange moving l = (m, out) -> forall x, In x (moving :: l) <-> In x m \/ x = out.
Proof.
  induction l as [|e l IH]; intros moving m out; simpl; [intro E; inversion E; subst; intro x; simpl; intuition congruence|].
  destruct (moving <? e); destruct (exchange _ l) as [m' out'] eqn:F; intro E; inversion E; subst; intro x; specialize (IH _ _ _ F x);
    simpl in *; intuition (subst; tauto).
Qed.

Lemma exchange_length l : forall moving, length (fst (exchange moving l)) = length l.
Proof.
  induction l as [|e l IH]; intro moving; simpl; [reflexivity|].
  destruct (moving <? e); destruct (exchange _ l) as [m out] eqn:F; simpl; f_equal; [rewrite <- (IH e)|rewrite <- (IH moving)]; now rewrite F.
Qed.

Lemma exchange_ordered l : forall moving m out, ordered l -> exchange moving l = (m, out) -> ordered m.
Proof.
  induction l as [|e l IH]; intros moving m out O; simpl; [intro E; inversion E; constructor|]. inversion O as [|? ? O' B]; subst.
  rewrite Forall_forall in B.
  destruct (moving <? e) eqn:L; [apply Z.ltb_lt in L|apply Z.ltb_ge in L]; destruct (exchange _ l) as [m' out'] eqn:F; intro E;
    inversion E; subst; (constructor; [now apply (IH _ _ _ O' F)|]); apply Forall_forall; intros x H;
    destruct (exchange_in l _ _ _ F x) as [_ K]; destruct (K (or_introl H)) as [->|K']; try (specialize (B _ K')); lia.
Qed.

Lemma put_new_tidy id expiry l : tidy l -> tidy (put_new id expiry l).
Proof.
  intros [A B]. unfold put_new. destruct (exchange (entry expiry id) (entries l)) as [m out] eqn:E. split; simpl.
  - rewrite <- A, <- (exchange_length (entries l) (entry expiry id)). now rewrite E.
  - exact (exchange_ordered _ _ _ _ B E).
Qed.

Theorem put_new_kept id expiry l i own : is_id id -> kept l i own \/ (i = id /\ expiry <= own) -> kept (put_new id expiry l) i own.
Proof.
  intros I H. unfold put_new. destruct (exchange (entry expiry id) (entries l)) as [m out] eqn:E.
  assert (K : (exists e, In e (entry expiry id :: entries l) /\ id_of e = i /\ expiry_of e <= own) \/ rest l <= own).
  { destruct H as [[(e & A & B)|H]|[-> H]]; [left; exists e; simpl; tauto|now right|].
    left. exists (entry expiry id). rewrite entry_id, entry_expiry by exact I. simpl. tauto. }
  unfold kept. simpl. destruct K as [(e & A & B & C)|K]; [|right; lia].
  apply (exchange_in _ _ _ _ E) in A. destruct A as [A|A]; [left; now exists e|right; subst; lia].
Qed.

Lemma close_gap_length id l : forall found, length (close_gap id found l) = length l.
Proof. induction l as [|e l IH]; intro found; simpl; [reflexivity|]. now rewrite IH. Qed.

Lemma close_gap_in id l : forall found e, In e (close_gap id found l) -> In e l \/ e = empty_entry.
Proof.
  induction l as [|x l IH]; intros found e; simpl; [tauto|]. intros [H|H]; [|destruct (IH _ _ H); tauto].
  destruct (found || _); [|tauto]. destruct l; simpl in *; [right|]; intuition.
Qed.

(* All but one entry of `id` stay. *)
Lemma close_gap_others id l : forall found e, In e l -> id_of e <> id -> In e (close_gap id found l) \/ (found = true /\ hd empty_entry l = e).
Proof.
  induction l as [|x l IH]; intros found e; simpl; [tauto|]. intros [->|H] N.
  - destruct found; [right; split; reflexivity|]. left. left.
    destruct (id_of e =? id) eqn:Q; [apply Z.eqb_eq in Q; contradiction|reflexivity].
  - left. destruct (IH (found || (id_of x =? id)) e H N) as [K|[K E]]; [now right|left]. now rewrite K.
Qed.

Lemma close_gap_ordered id l : forall found, (forall e, In e l -> e <= empty_entry) -> ordered l -> ordered (close_gap id found l).
Proof.
  induction l as [|x l IH]; intros found V O; simpl; [constructor|]. inversion O as [|? ? O' B]; subst. rewrite Forall_forall in B.
  constructor; [apply IH; [intros e H; apply V; now right|exact O']|]. apply Forall_forall. intros e H.
  destruct (found || (id_of x =? id)) eqn:F.
  - (* what is behind the next one *)
    clear IH. revert H. destruct l as [|y l]; [intros []|]. simpl. inversion O' as [|? ? O'' B']; subst. rewrite Forall_forall in B'.
    intros [<-|H].
    + destruct l as [|z l]; simpl; [apply V; simpl; tauto|apply B'; now left].
    + apply close_gap_in in H. destruct H as [H| ->]; [now apply B'|apply V; simpl; tauto].
  - apply close_gap_in in H. destruct H as [H| ->]; [now apply B|apply V; simpl; tauto].
Qed.

(* Nothing is above an empty place. *)
Definition in_range (l : expiry_list) : Prop := 0 <= rest l /\ forall e, In e (entries l) -> 0 <= e <= empty_entry.

Lemma entry_range expiry id : is_id id -> 0 <= expiry <= never -> 0 <= entry expiry id <= empty_entry.
Proof. unfold empty_entry, entry, is_id, none. nia. Qed.

Lemma put_new_range id expiry l : is_id id -> 0 <= expiry <= never -> in_range l -> in_range (put_new id expiry l).
Proof.
  intros I N [A B]. unfold put_new. destruct (exchange (entry expiry id) (entries l)) as [m out] eqn:E.
  assert (C : forall e, In e m \/ e = out -> 0 <= e <= empty_entry).
  { intros e H. destruct (exchange_in _ _ _ _ E e) as [_ K]. destruct (K H) as [<-|K']; [now apply entry_range|now apply B]. }
  split; simpl.
  - apply Z.min_glb; [exact A|]. rewrite upper_half. apply Z.div_pos; [now apply C; right|lia].
  - intros e H. apply C. now left.
Qed.

Definition proper (l : expiry_list) : Prop := tidy l /\ in_range l.

Theorem put_new_proper id expiry l : is_id id -> 0 <= expiry <= never -> proper l -> proper (put_new id expiry l).
Proof. intros I N [A B]. split; [now apply put_new_tidy|now apply put_new_range]. Qed.

Theorem put_proper id expiry l : is_id id -> 0 <= expiry <= never -> proper l -> proper (put id expiry l).
Proof.
  intros I N P. unfold put. destruct (_ || _); [|exact P]. destruct P as [[A C] [D B]].
  apply put_new_proper; trivial. split; [split|split]; simpl; trivial.
  - now rewrite close_gap_length.
  - apply close_gap_ordered; [intros e H; now apply B|exact C].
  - intros e H. apply close_gap_in in H. destruct H as [H| ->]; [now apply B|unfold empty_entry, entry, never, none; lia].
Qed.

Theorem put_kept id expiry l i own : is_id id -> (i <> id /\ kept l i own) \/ (i = id /\ expiry <= own) -> kept (put id expiry l) i own.
Proof.
  intros I H. unfold put. destruct (_ || _) eqn:L.
  2: { apply orb_false_iff in L. destruct L as [_ L]. apply Z.ltb_ge in L. destruct H as [[_ H]|[_ H]]; [exact H|right; lia]. }
  apply put_new_kept; [exact I|]. destruct H as [[N [(e & A & B & C)|H]]|H]; [left|left; now right|now right].
  left. exists e. split; [|tauto]. simpl. subst i. destruct (close_gap_others id (entries l) false e A N) as [K|[K _]]; [exact K|discriminate].
Qed.

Lemma repeat_in {A} (x y : A) n : In y (repeat x n) -> y = x.
Proof. apply repeat_spec. Qed.

Lemma ordered_empty l n : (forall e, In e l -> e <= empty_entry) -> ordered l -> ordered (l ++ repeat empty_entry n).
Proof.
  intros V. induction 1 as [|x l O IH B]; simpl.
  - induction n as [|n IH]; simpl; constructor; [exact IH|]. apply Forall_forall. intros y H. apply repeat_in in H. lia.
  - constructor; [apply IH; intros e H; apply V; now right|]. rewrite Forall_forall in B. apply Forall_forall. intros y H.
    apply in_app_iff in H. destruct H as [H|H]; [now apply B|]. apply repeat_in in H. subst. apply V. now left.
Qed.

Theorem cleared_proper : proper cleared.
Proof.
  split; [split|split]; simpl.
  - apply repeat_length.
  - change (repeat empty_entry capacity) with ([] ++ repeat empty_entry capacity). apply ordered_empty; [intros _ []|constructor].
  - unfold never. lia.
  - intros e H. apply repeat_in in H. subst. unfold empty_entry, entry, never, none. lia.
Qed.

Lemma put_below_kept bound l x i own : is_id (snd x) -> kept l i own \/ (i = snd x /\ fst x <= own) -> kept (put_below bound l x) i own.
Proof.
  intros I H. unfold put_below. destruct (fst x <? bound); [now apply put_new_kept|].
  destruct H as [[(e & A)|H]|[_ H]]; [left; now exists e| |]; right; simpl; lia.
Qed.

Lemma put_below_proper bound l x : is_id (snd x) -> 0 <= fst x <= never -> proper l -> proper (put_below bound l x).
Proof. intros I N S. unfold put_below. destruct (fst x <? bound); [now apply put_new_proper|]. destruct S as [[A B] [C D]]. split; [now split|]. split; [simpl; lia|exact D]. Qed.

Theorem put_many_kept_any bound new : forall l i own, (forall x, In x new -> is_id (snd x)) ->
  kept l i own \/ (exists x, In x new /\ snd x = i /\ fst x <= own) -> kept (fold_left (put_below bound) new l) i own.
Proof.
  induction new as [|x new IH]; intros l i own I H; simpl.
  - destruct H as [H|(x & [] & _)]. exact H.
  - apply IH; [intros y Y; apply I; now right|]. destruct H as [H|(y & [->|Y] & H)].
    + left. apply put_below_kept; [apply I; now left|now left].
    + left. apply put_below_kept; [apply I; now left|]. right. split; [now symmetry|apply H].
    + right. now exists y.
Qed.

Theorem put_many_kept new l i own : (forall x, In x new -> is_id (snd x)) ->
  kept l i own \/ (exists x, In x new /\ snd x = i /\ fst x <= own) -> kept (put_many new l) i own.
Proof. apply put_many_kept_any. Qed.

Theorem put_many_proper new l : (forall x, In x new -> is_id (snd x) /\ 0 <= fst x <= never) -> proper l -> proper (put_many new l).
Proof.
  unfold put_many. generalize (bound_of (map fst new)). intro bound. revert l.
  induction new as [|x new IH]; intros l H S; simpl; [exact S|]. apply IH; [intros y Y; apply H; now right|].
  destruct (H x (or_introl eq_refl)). now apply put_below_proper.
Qed.

(* What is below a bound comes first. *)
Lemma reached_first path_length l : ordered l ->
  firstn (length (filter (is_reached path_length) l)) l = filter (is_reached path_length) l /\
  skipn (length (filter (is_reached path_length) l)) l = filter (fun e => negb (is_reached path_length e)) l.
Proof.
  induction 1 as [|x l O [IH IH'] B]; simpl; [easy|]. destruct (is_reached path_length x) eqn:R; simpl; [rewrite IH, IH'; easy|].
  assert (N : forall e, In e l -> is_reached path_length e = false).
  { intros e H. rewrite Forall_forall in B. specialize (B e H). unfold is_reached in *. apply andb_false_iff in R. apply andb_false_iff.
    destruct R as [R|R]; [left|right]; apply Z.ltb_ge in R; apply Z.ltb_ge; lia. }
  assert (E : filter (is_reached path_length) l = []).
  { clear - N. induction l as [|y l IH]; simpl; [easy|]. rewrite N by now left. apply IH. intros; apply N; now right. }
  rewrite E in *. simpl in *. now rewrite <- IH'.
Qed.

Lemma take_proper path_length l : proper l -> proper (snd (take path_length l)).
Proof.
  intros [[A O] [B0 B]]. unfold take. simpl. destruct (reached_first path_length _ O) as [_ E].
  assert (V : forall e, In e (skipn (length (filter (is_reached path_length) (entries l))) (entries l)) -> 0 <= e <= empty_entry).
  { intros e H. rewrite E in H. apply filter_In in H. now apply B. }
  assert (L : (length (filter (is_reached path_length) (entries l)) <= length (entries l))%nat).
  { clear. induction (entries l) as [|x m IH]; simpl; [lia|]. destruct (is_reached path_length x); simpl; lia. }
  split; [split|split]; simpl; trivial.
  - rewrite app_length, repeat_length, skipn_length, <- A. lia.
  - apply ordered_empty; [intros e H; now apply V|]. rewrite E. clear - O. induction O as [|x m O IH F]; simpl; [constructor|].
    destruct (negb _); [|exact IH]. constructor; [exact IH|]. rewrite Forall_forall in *. intros y H. apply filter_In in H. now apply F.
  - intros e H. apply in_app_iff in H. destruct H as [H|H]; [now apply V|]. apply repeat_in in H. subst. unfold empty_entry, entry, never, none. lia.
Qed.

(* What is not visited stays. *)
Theorem take_kept path_length l i own : proper l -> kept l i own -> In i (fst (take path_length l)) \/ kept (snd (take path_length l)) i own.
Proof.
  intros [[_ O] _] [(e & A & B & C)|H]; [|right; now right]. unfold take. simpl. destruct (reached_first path_length _ O) as [E F].
  destruct (is_reached path_length e) eqn:R.
  - left. rewrite E. apply in_map_iff. exists e. split; [exact B|]. now apply filter_In.
  - right. left. exists e. split; [|tauto]. simpl. apply in_app_iff. left. rewrite F. apply filter_In. now rewrite R.
Qed.

(* What has expired is visited, unless all that is not listed may have. *)
Theorem take_finds path_length l i own : proper l -> is_id i -> own <= never -> kept l i own -> own <= path_length ->
  In i (fst (take path_length l)) \/ rest l <= path_length.
Proof.
  intros [[_ O] _] I N [(e & A & B & C)|H] L; [left|right; lia]. unfold take. simpl. destruct (reached_first path_length _ O) as [E _].
  rewrite E. apply in_map_iff. exists e. split; [exact B|]. apply filter_In. split; [exact A|].
  generalize (entry_parts e) (id_bounds e). unfold is_id in I. rewrite B. intros P Q. unfold is_reached, empty_entry, entry in *.
  apply andb_true_iff. rewrite !Z.ltb_lt. nia.
Qed.

Theorem earliest_below l i own : proper l -> kept l i own -> earliest l <= own.
Proof.
  intros [[_ O] _] [(e & A & _ & C)|H]; unfold earliest; [|lia]. apply Z.le_trans with (expiry_of e); [|exact C].
  apply Z.le_trans with (expiry_of (hd empty_entry (entries l))); [lia|]. apply expiry_le.
  destruct O as [|x m O B]; [destruct A|]. simpl. destruct A as [->|A]; [lia|]. rewrite Forall_forall in B. now apply B.
Qed.

Theorem earliest_range l : proper l -> 0 <= earliest l.
Proof.
  intros [_ [A B]]. unfold earliest. apply Z.min_glb; [exact A|]. rewrite upper_half. apply Z.div_pos; [|lia].
  destruct (entries l) as [|e m]; simpl; [unfold empty_entry, entry, never, none; lia|]. apply B. now left.
Qed.

Theorem below_rest l i own path_length : kept l i own -> own <= path_length -> path_length < rest l ->
  exists e, In e (entries l) /\ id_of e = i /\ expiry_of e <= path_length.
Proof. intros [(e & A & B & C)|H] L M; [exists e; repeat split; trivial; lia|lia]. Qed.
End listed.

(* ---- What it does ---- *)

Example example_full : run 2 [Put 7 30; Put 8 10; Put 9 20] = (30, [(10, 8); (20, 9)]).
Proof. vm_compute. reflexivity. Qed.
Example example_moved : run 2 [Put 7 30; Put 8 10; Put 8 40; Put 9 20] = (40, [(20, 9); (30, 7)]).
Proof. vm_compute. reflexivity. Qed.
Example example_taken : run 2 [Put 7 30; Put 8 10; Put 9 20; Take 20] = (30, []).
Proof. vm_compute. reflexivity. Qed.
Example example_visited : fst (take 20 (fold_left (apply_operation 2) [Put 7 30; Put 8 10; Put 9 20] (cleared 2))) = [8; 9].
Proof. vm_compute. reflexivity. Qed.
Example example_many : run 2 [Put_many [(30, 1); (10, 2); (50, 3); (20, 4); (40, 5)]] = (30, [(10, 2); (20, 4)]).
Proof. vm_compute. reflexivity. Qed.
