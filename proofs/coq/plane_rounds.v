(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* How often a border winds, counted at the vertices: docs/theory.md 1.3, (1).

   `rounds` is how often the cells go round an inner vertex. Of a vertex of the border `extra` are the rounds beyond what its ridge requires.

   - rounds_formula   (1): the border winds once, and as often more as inner vertices have rounds beyond their first and border vertices extra ones
   - wound_once       none of these is negative (plane_corners.v), so the border winds once exactly if each inner vertex has one round, and each of the
                      border none in excess *)
Require Import Reals Lra Lia List Permutation Bool Arith.
From Annulus Require Import sums width_2 plane_mesh plane_paths plane_winding plane_corners.
Import ListNotations.
Open Scope R_scope.

Lemma nodup_end {S} (l k : list S) : NoDup (l ++ k) -> NoDup k.
Proof. induction l as [|a l IH]; [trivial|]. intro N. inversion N. now apply IH. Qed.

Lemma sum_none {S} (f : S -> R) l : (forall s, In s l -> 0 <= f s) -> (sum f l = 0 <-> forall s, In s l -> f s = 0).
Proof.
  intro P. split.
  - intros Z s I. destruct (Rle_lt_or_eq_dec 0 (f s) (P s I)) as [L|L]; [|now symmetry]. generalize (sum_pos f l s P I L). lra.
  - intro Z. rewrite <- (sum_zero l). now apply sum_ext.
Qed.

Section rounds.
Variables (T : mesh) (m : placement).
Hypothesis gluing : glued T.
Hypothesis all_positive : positive m T.

Notation corners := (flat_map sides (cells T)).
Notation up := (up m).
Notation one_up := (one_up m).
Notation entered := (entered m).
Notation left_ := (left_ m).
Notation descends := (descends m).
Notation rounds := (rounds T m).
Notation needed := (needed T m).
Notation extra := (extra T m).

Definition entries : nat := length (filter (enters m) (ridges (border T))).
Definition ups : R := sum (fun e => let '(u, v) := e in one_up u v) (ring (border T)).

Lemma all_entered : 2 * sum (fun s => one_if (entered s)) corners = INR (length (cells T)) + INR (length (border T)) - 2 * ups.
Proof.
  assert (F : sum (crosses m) corners = INR (length (cells T))).
  { rewrite sum_flat_map, <- sum_const. apply sum_ext. now apply corners_of_cell. }
  assert (D : sum (fun s => one_if (entered s) + -1 * one_if (left_ s)) corners = INR (length (border T)) - 2 * ups).
  { rewrite (sum_ext _ (fun s => let '(v, b, c) := s in one_up v c - one_up v b)).
    - rewrite (around T gluing), <- ring_length, <- sum_const. unfold ups.
      replace (_ - _) with (sum (fun _ => 1) (ring (border T)) + -2 * sum (fun e => let '(u, v) := e in one_up u v) (ring (border T))) by ring.
      rewrite <- sum_scale, <- sum_plus. apply sum_ext. intros [u v] I. unfold one_up. rewrite (up_swap m u v) by now apply (ring_apart T m).
      destruct (up u v); cbn [negb one_if]; ring.
    - intros [[v b] c] _. rewrite <- (entered_left m (v, b, c)). ring. }
  rewrite <- F. unfold crosses. rewrite !sum_plus, sum_scale in *. lra.
Qed.

(* ---- Vertex by vertex ---- *)

Lemma one_of {S} (at_ : S -> nat) (f : S -> bool) l vs : NoDup vs -> (forall s, In s l -> In (at_ s) vs) ->
  sum (fun v => INR (length (filter (fun s => (at_ s =? v)%nat && f s) l))) vs = sum (fun s => one_if (f s)) l.
Proof.
  intros N I. rewrite (sum_ext _ (fun v => sum (fun s => one_if ((at_ s =? v)%nat && f s)) l)) by (intros; apply count_sum).
  rewrite sum_swap. apply sum_ext. intros s K. specialize (I s K). clear K. generalize (f s). intro e.
  induction N as [|v vs Nv N IH]; [easy|]. rewrite sum_cons. destruct (Nat.eqb_spec (at_ s) v) as [E|E]; cbn [andb].
  - rewrite (sum_ext _ (fun _ => 0)); [rewrite sum_zero; ring|]. intros w W. destruct (Nat.eqb_spec (at_ s) w) as [E'|E']; [congruence|reflexivity].
  - rewrite IH by (destruct I as [I|I]; [congruence|exact I]). cbn [one_if]. ring.
Qed.

Variable inner : list nat.
(* A triangulated sphere with infinity: Euler's relation; the border is simple. *)
Hypothesis each_once : NoDup (inner ++ border T).
Hypothesis all_there : forall v, vertex_of T v <-> In v (inner ++ border T).
Hypothesis euler : (length (cells T) + length (border T) + 2 = 2 * length (inner ++ border T))%nat.

Lemma corner_there s : In s corners -> In (at_corner s) (inner ++ border T).
Proof.
  intro I. apply in_flat_map in I. destruct I as ([[a b] c] & I & S). apply all_there. exists (a, b, c). split; [exact I|].
  destruct S as [<-|[<-|[<-|[]]]]; simpl; tauto.
Qed.

Lemma ridge_there r : In r (ridges (border T)) -> In (at_ridge r) (border T).
Proof.
  intro I. assert (E : In (edge r) (ring (border T))).
  { destruct (border T) as [|a [|b l]]; [easy|easy|]. rewrite ring_ridges. now apply in_map. }
  destruct r as [[u v] w]. unfold ring in E. apply steps_in in E. destruct E as [_ E]. apply in_app_or in E. destruct E as [E|E]; [exact E|].
  rewrite <- (firstn_skipn 1). apply in_or_app. now left.
Qed.

Lemma all_needed : sum (fun v => INR (needed v)) (border T) = INR (length (border T)) - ups - INR entries.
Proof.
  unfold needed. rewrite one_of; [|exact (nodup_end _ _ each_once)|exact ridge_there].
  unfold entries. rewrite count_sum, <- ring_length, <- sum_const. unfold ups. rewrite !(ring_edges T m) by trivial.
  match goal with |- _ = ?a - ?b - ?c => replace (a - b - c) with (a + -1 * b + -1 * c) by ring end.
  rewrite <- !sum_scale, <- !sum_plus. apply sum_ext. intros [[u v] w] I. cbn [edge descends enters]. unfold one_up. fold (up u v) (up v w).
  destruct (up u v), (up v w); cbn [negb andb one_if]; ring.
Qed.

Theorem rounds_formula : INR entries - 1 = sum (fun v => INR (rounds v) - 1) inner + sum extra (border T).
Proof.
  assert (A : sum (fun v => INR (rounds v)) (inner ++ border T) = sum (fun s => one_if (entered s)) corners)
    by (apply one_of; [exact each_once|exact corner_there]).
  assert (E := all_entered). assert (N := all_needed). rewrite sum_app in A.
  assert (X : sum extra (border T) = sum (fun v => INR (rounds v)) (border T) + -1 * sum (fun v => INR (needed v)) (border T)).
  { rewrite <- sum_scale, <- sum_plus. apply sum_ext. intros v _. unfold extra. ring. }
  assert (Y : sum (fun v => INR (rounds v) - 1) inner = sum (fun v => INR (rounds v)) inner - INR (length inner)).
  { rewrite <- sum_const. replace (_ - _) with (sum (fun v => INR (rounds v)) inner + -1 * sum (fun _ => 1) inner) by ring.
    rewrite <- sum_scale, <- sum_plus. apply sum_ext. intros; ring. }
  assert (Eu : INR (length (cells T)) + INR (length (border T)) + 2 = 2 * (INR (length inner) + INR (length (border T)))).
  { generalize (f_equal INR euler). rewrite app_length, mult_INR, !plus_INR. cbn [INR]. lra. }
  rewrite X, Y, N. lra.
Qed.

Theorem wound_once : winds_once m (border T) <->
  (forall v, In v inner -> rounds v = 1%nat) /\ forall v, In v (border T) -> rounds v = needed v.
Proof.
  assert (F := rounds_formula). assert (N := each_once). assert (Nb := nodup_end _ _ N).
  assert (I : forall v, In v inner -> 0 <= INR (rounds v) - 1).
  { intros v K. assert (1 <= rounds v)%nat; [|apply le_INR in H; simpl in H; lra]. apply (inner_once T m); trivial; [|apply all_there, in_or_app; now left].
    intro B. revert N K B. clear. induction inner as [|a l IH]; [easy|]. intros N [->|K] B; inversion N; subst; [|now apply IH].
    apply H1, in_or_app. now right. }
  assert (O : forall v, In v (border T) -> 0 <= extra v) by (intros; now apply (no_fewer T m)).
  assert (SI := sum_nonneg _ _ I). assert (SO := sum_nonneg _ _ O).
  transitivity (sum (fun v => INR (rounds v) - 1) inner = 0 /\ sum extra (border T) = 0).
  - unfold winds_once. fold entries. split.
    + intro W. rewrite W in F. cbn [INR] in F. lra.
    + intros [A B]. apply INR_eq. cbn [INR]. lra.
  - rewrite (sum_none _ _ I), (sum_none _ _ O). unfold extra. split; intros [A B]; split; intros v K.
    + apply INR_eq. specialize (A v K). simpl. lra.
    + apply INR_eq. specialize (B v K). lra.
    + rewrite (A v K). simpl. ring.
    + rewrite (B v K). ring.
Qed.
End rounds.
