(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* A segment and a tetrahedron, in barycentric coordinates: what it enters and leaves.

   - entered   a segment in general position enters or leaves a tetrahedron through the facets that its line hits: counted with signs that is whether
               its end is inside less whether its beginning is

   With b and c the coordinates of the ends, the line hits the facet opposite to corner i when the pair (b_i, c_i) is the first or the last of the
   four in the order of directions: such a pair is called a source or a sink. There is at most one of each. *)
Require Import Reals Lra Psatz List.
From Annulus Require Import tetrahedron.
Import ListNotations.
Open Scope R_scope.

Definition corner_list := [o; u; v; w].
Lemma corner_dec (i j : corner) : {i = j} + {i <> j}.
Proof. decide equality. Defined.
Lemma in_corners (i : corner) : In i corner_list.
Proof. destruct i; simpl; tauto. Qed.

Definition wedge (p q : R * R) : R := fst p * snd q - snd p * fst q.

Section line.
Variables b c : corner -> R.
Definition pair i : R * R := (b i, c i).
Definition order i j : R := wedge (pair i) (pair j).
Hypothesis total_b : 0 < b o + b u + b v + b w.
Hypothesis total_c : b o + b u + b v + b w = c o + c u + c v + c w.
Hypothesis generic_b : forall i, b i <> 0.
Hypothesis generic_c : forall i, c i <> 0.
Hypothesis generic : forall i j, i <> j -> order i j <> 0.

Lemma order_swap i j : order j i = - order i j.
Proof. unfold order, wedge. ring. Qed.

Definition source i : Prop := forall j, j <> i -> 0 < order i j.
Definition sink i : Prop := forall j, j <> i -> 0 < order j i.

Lemma order_sum i : order i o + order i u + order i v + order i w = (b i - c i) * (b o + b u + b v + b w).
Proof. unfold order, wedge, pair. cbn [fst snd]. transitivity (b i * (c o + c u + c v + c w) - c i * (b o + b u + b v + b w)); [ring|]. rewrite <- total_c. ring. Qed.

Lemma order_self i : order i i = 0.
Proof. unfold order, wedge. ring. Qed.

Lemma source_leaves i : source i -> c i < b i.
Proof.
  intro S. apply Rnot_le_lt. intro L. assert (K := order_sum i). assert (E := order_self i).
  assert (0 < order i o + order i u + order i v + order i w).
  { generalize (S o) (S u) (S v) (S w). intros A B C D. destruct i; try (rewrite E); 
    repeat match goal with H : ?x <> ?y -> _ |- _ => first [specialize (H ltac:(discriminate)) | clear H] end; lra. }
  nra.
Qed.

Lemma sink_enters i : sink i -> b i < c i.
Proof.
  intro S. apply Rnot_le_lt. intro L. assert (K := order_sum i). assert (E := order_self i).
  assert (order i o + order i u + order i v + order i w < 0).
  { generalize (S o) (S u) (S v) (S w). rewrite !(order_swap i). intros A B C D. destruct i; try (rewrite E);
    repeat match goal with H : ?x <> ?y -> _ |- _ => first [specialize (H ltac:(discriminate)) | clear H] end; lra. }
  nra.
Qed.

Lemma one_source i j : source i -> source j -> i = j.
Proof.
  intros S K. destruct (corner_dec i j) as [E|N]; [exact E|exfalso]. generalize (S j ltac:(congruence)) (K i N). rewrite (order_swap i j). lra.
Qed.

Lemma one_sink i j : sink i -> sink j -> i = j.
Proof.
  intros S K. destruct (corner_dec i j) as [E|N]; [exact E|exfalso]. generalize (S j ltac:(congruence)) (K i N). rewrite (order_swap i j). lra.
Qed.

(* In a half-plane directions are in order. *)
Lemma order_trans h i j k : 0 < wedge h (pair i) -> 0 < wedge h (pair j) -> 0 < wedge h (pair k) -> 0 < order i j -> 0 < order j k -> 0 < order i k.
Proof.
  intros I J K A B. assert (E : wedge h (pair j) * order i k = wedge h (pair i) * order j k + wedge h (pair k) * order i j)
    by (unfold order, wedge; ring).
  apply (Rmult_lt_reg_l (wedge h (pair j))); [exact J|]. rewrite Rmult_0_r, E. apply Rplus_lt_0_compat; now apply Rmult_lt_0_compat.
Qed.

Lemma last_of h l : l <> [] -> (forall i, In i l -> 0 < wedge h (pair i)) -> exists k, In k l /\ forall j, In j l -> j <> k -> 0 < order j k.
Proof.
  induction l as [|i l IH]; intros N H; [easy|]. destruct l as [|j l].
  - exists i. split; [now left|]. intros j [->|[]] D. now elim D.
  - destruct IH as (k & K & L); [discriminate|intros p P; apply H; now right|].
    destruct (corner_dec i k) as [->|D]; [exists k; split; [now left|]; intros p [->|P] Q; [now elim Q|now apply L]|].
    destruct (Rdichotomy _ _ (generic i k D)) as [G|G].
    + exists i. split; [now left|]. intros p [->|P] Q; [now elim Q|]. destruct (corner_dec p k) as [->|R]; [rewrite (order_swap i k); lra|].
      apply (order_trans h p k i); [apply H; now right|apply H; now right|apply H; now left|now apply L|rewrite (order_swap i k); lra].
    + exists k. split; [now right|]. intros p [->|P] Q; [exact G|now apply L].
Qed.

Definition all_positive (f : corner -> R) : Prop := forall i, 0 < f i.
Definition enters_at i : Prop := sink i /\ b i < 0 < c i.
Definition leaves_at i : Prop := source i /\ c i < 0 < b i.

Lemma enters_from_outside j : all_positive c -> b j < 0 -> exists i, enters_at i.
Proof.
  intros C B. destruct (last_of (1, 0) corner_list) as (k & _ & K); [discriminate|intros i _; unfold wedge, pair; simpl; generalize (C i); lra|].
  assert (S : sink k) by (intros i D; apply K; [apply in_corners|exact D]). exists k. split; [exact S|]. split; [|apply C].
  destruct (corner_dec j k) as [<-|D]; [exact B|]. generalize (S j D) (C j) (C k). unfold order, wedge, pair. cbn [fst snd]. intros. nra.
Qed.

Lemma enters_before_leaving i j : leaves_at i -> b j < 0 -> exists k, enters_at k.
Proof.
  intros (S & C & B) J. destruct (last_of (pair i) (remove corner_dec i corner_list)) as (k & I & K).
  - destruct i; simpl; repeat destruct (corner_dec _ _); congruence.
  - intros p P. apply in_remove in P. now apply S.
  - apply in_remove in I. destruct I as [_ I]. exists k. assert (Sk : sink k).
    { intros p P. destruct (corner_dec p i) as [->|D]; [now apply S|]. apply K; [|exact P]. apply in_in_remove; [exact D|apply in_corners]. }
    assert (Nj : j <> i) by (intros ->; lra). assert (Sj := S j Nj). assert (Si := Sk i ltac:(congruence)).
    assert (Cj : 0 < c j) by (unfold order, wedge, pair in Sj; cbn [fst snd] in Sj; nra).
    assert (Bk : b k < 0).
    { destruct (corner_dec j k) as [<-|D]; [exact J|]. apply Rnot_le_lt. intro L. assert (Kj := Sk j D).
      assert (P : 0 < b k) by (generalize (generic_b k); lra).
      assert (E : wedge (pair i) (pair j) * b k = wedge (pair i) (pair k) * b j - order j k * b i) by (unfold order, wedge, pair; cbn [fst snd]; ring).
      unfold order in Sj, Si. fold (order j k) in *. nra. }
    split; [exact Sk|]. split; [exact Bk|]. unfold order, wedge, pair in Si. cbn [fst snd] in Si. nra.
Qed.
End line.

Lemma order_reversed b c i j : order c b i j = order b c j i.
Proof. unfold order, wedge, pair. cbn [fst snd]. ring. Qed.

Lemma sink_reversed b c i : sink c b i <-> source b c i.
Proof. unfold source, sink, order, wedge, pair. cbn [fst snd]. split; intros H j D; generalize (H j D); lra. Qed.

Lemma reversed b c i : enters_at c b i <-> leaves_at b c i.
Proof. unfold enters_at, leaves_at. rewrite sink_reversed. reflexivity. Qed.

(* ---- Counted ---- *)

Definition pos (x : R) : R := if Rlt_dec 0 x then 1 else 0.
Definition one_side (p q r : R) : R :=
  if Rlt_dec 0 p then if Rlt_dec 0 q then if Rlt_dec 0 r then 1 else 0 else 0
  else if Rlt_dec p 0 then if Rlt_dec q 0 then if Rlt_dec r 0 then 1 else 0 else 0 else 0.
Definition others (i : corner) : corner * corner * corner := match i with o => (u, v, w) | u => (o, v, w) | v => (o, u, w) | w => (o, u, v) end.
Definition hit b c i : R := let '(j, k, l) := others i in one_side (order b c i j) (order b c i k) (order b c i l).
Definition inside_all (f : corner -> R) : R := pos (f o) * pos (f u) * pos (f v) * pos (f w).

Lemma pos_cases x : (pos x = 1 /\ 0 < x) \/ (pos x = 0 /\ x <= 0).
Proof. unfold pos. destruct (Rlt_dec 0 x); lra. Qed.

Lemma hit_cases b c i : (hit b c i = 1 /\ (source b c i \/ sink b c i)) \/ (hit b c i = 0 /\ ~ source b c i /\ ~ sink b c i).
Proof.
  assert (K : forall j k l, others i = (j, k, l) -> (forall p, p <> i -> p = j \/ p = k \/ p = l) /\ j <> i /\ k <> i /\ l <> i).
  { intros j k l. destruct i; intro E; injection E as <- <- <-; (split; [intros []; tauto|]); repeat split; discriminate. }
  unfold hit. destruct (others i) as [[j k] l]. destruct (K j k l eq_refl) as (All & J & K' & L). unfold one_side.
  assert (S : source b c i <-> 0 < order b c i j /\ 0 < order b c i k /\ 0 < order b c i l).
  { split; [intro H; repeat split; now apply H|]. intros (A & B & C) p P. destruct (All p P) as [->|[->| ->]]; trivial. }
  assert (S' : sink b c i <-> order b c i j < 0 /\ order b c i k < 0 /\ order b c i l < 0).
  { split; [intro H; generalize (H j J) (H k K') (H l L); rewrite !(order_swap b c i); lra|].
    intros (A & B & C) p P. rewrite (order_swap b c i p). destruct (All p P) as [->|[->| ->]]; lra. }
  rewrite S, S'. repeat match goal with |- context [Rlt_dec ?x ?y] => destruct (Rlt_dec x y) end; lra.
Qed.

Lemma at_most_one (f : corner -> R) (P : corner -> Prop) : (forall i, (f i = 1 /\ P i) \/ (f i = 0 /\ ~ P i)) -> (forall i j, P i -> P j -> i = j) ->
  (f o + f u + f v + f w = 1 /\ exists i, P i) \/ (f o + f u + f v + f w = 0 /\ forall i, ~ P i).
Proof.
  intros C U. assert (D : forall i j, i <> j -> P i -> ~ P j) by (intros i j N I J; now apply N, U).
  destruct (C o) as [[Eo Po]|[Eo Po]]; [|destruct (C u) as [[Eu Pu]|[Eu Pu]]; [|destruct (C v) as [[Ev Pv]|[Ev Pv]]; [|destruct (C w) as [[Ew Pw]|[Ew Pw]]]]].
  - left. split; [|now exists o]. destruct (C u) as [[_ K]|[-> _]]; [now elim (D o u)|]. destruct (C v) as [[_ K]|[-> _]]; [now elim (D o v)|].
    destruct (C w) as [[_ K]|[-> _]]; [now elim (D o w)|]. lra.
  - left. split; [|now exists u]. destruct (C v) as [[_ K]|[-> _]]; [now elim (D u v)|]. destruct (C w) as [[_ K]|[-> _]]; [now elim (D u w)|]. lra.
  - left. split; [|now exists v]. destruct (C w) as [[_ K]|[-> _]]; [now elim (D v w)|]. lra.
  - left. split; [|now exists w]. lra.
  - right. split; [lra|]. intros []; trivial.
Qed.

Section counted.
Variables b c : corner -> R.
Hypothesis total_b : 0 < b o + b u + b v + b w.
Hypothesis total_c : b o + b u + b v + b w = c o + c u + c v + c w.
Hypothesis generic_b : forall i, b i <> 0.
Hypothesis generic_c : forall i, c i <> 0.
Hypothesis generic : forall i j, i <> j -> order b c i j <> 0.

Lemma generic_reversed i j : i <> j -> order c b i j <> 0.
Proof. rewrite order_reversed. intro N. apply generic. congruence. Qed.

Lemma all_or_not (f : corner -> R) : (forall i, f i <> 0) -> (inside_all f = 1 /\ all_positive f) \/ (inside_all f = 0 /\ exists i, f i < 0).
Proof.
  intro N. unfold inside_all. destruct (pos_cases (f o)) as [[-> Po]|[-> Po]]; [|right; split; [ring|exists o; generalize (N o); lra]].
  destruct (pos_cases (f u)) as [[-> Pu]|[-> Pu]]; [|right; split; [ring|exists u; generalize (N u); lra]].
  destruct (pos_cases (f v)) as [[-> Pv]|[-> Pv]]; [|right; split; [ring|exists v; generalize (N v); lra]].
  destruct (pos_cases (f w)) as [[-> Pw]|[-> Pw]]; [|right; split; [ring|exists w; generalize (N w); lra]].
  left. split; [ring|]. intros []; trivial.
Qed.

Definition entering i : R := if Rlt_dec (b i) 0 then if Rlt_dec 0 (c i) then hit b c i else 0 else 0.
Definition leaving i : R := if Rlt_dec (c i) 0 then if Rlt_dec 0 (b i) then hit b c i else 0 else 0.

Lemma entering_cases i : (entering i = 1 /\ enters_at b c i) \/ (entering i = 0 /\ ~ enters_at b c i).
Proof.
  unfold entering, enters_at. destruct (Rlt_dec (b i) 0); [|right; tauto]. destruct (Rlt_dec 0 (c i)); [|right; tauto].
  destruct (hit_cases b c i) as [[-> [S|S]]|[-> [_ S]]]; [exfalso|left; tauto|right; tauto].
  generalize (source_leaves b c total_b total_c i S). lra.
Qed.

Lemma leaving_cases i : (leaving i = 1 /\ leaves_at b c i) \/ (leaving i = 0 /\ ~ leaves_at b c i).
Proof.
  unfold leaving, leaves_at. destruct (Rlt_dec (c i) 0); [|right; tauto]. destruct (Rlt_dec 0 (b i)); [|right; tauto].
  destruct (hit_cases b c i) as [[-> [S|S]]|[-> [S _]]]; [left; tauto|exfalso|right; tauto].
  generalize (sink_enters b c total_b total_c i S). lra.
Qed.

Lemma term i : hit b c i * (pos (c i) - pos (b i)) = entering i - leaving i.
Proof.
  unfold entering, leaving, pos. destruct (Rdichotomy _ _ (generic_b i)), (Rdichotomy _ _ (generic_c i));
  repeat match goal with |- context [Rlt_dec ?x ?y] => destruct (Rlt_dec x y) end; lra.
Qed.

Theorem entered : hit b c o * (pos (c o) - pos (b o)) + hit b c u * (pos (c u) - pos (b u)) + hit b c v * (pos (c v) - pos (b v))
  + hit b c w * (pos (c w) - pos (b w)) = inside_all c - inside_all b.
Proof.
  rewrite !term.
  destruct (at_most_one entering (enters_at b c) entering_cases) as [[E I]|[E I]]; [intros i j [S _] [S' _]; now apply (one_sink b c)| |];
  (destruct (at_most_one leaving (leaves_at b c) leaving_cases) as [[L J]|[L J]]; [intros i j [S _] [S' _]; now apply (one_source b c)| |]);
  (destruct (all_or_not b generic_b) as [[-> B]|[-> (p & B)]]; destruct (all_or_not c generic_c) as [[-> C]|[-> (q & C)]]); try lra; exfalso.
  - destruct I as (i & _ & I). generalize (B i). lra.
  - destruct J as (i & _ & J). generalize (C i). lra.
  - destruct I as (i & _ & I). generalize (B i). lra.
  - destruct I as (i & _ & I). generalize (B i). lra.
  - destruct I as (i & I). destruct (enters_before_leaving c b generic_c generic_reversed i q) as (k & K); [now apply reversed|exact C|].
    apply (J k). now apply reversed.
  - destruct J as (i & _ & J). generalize (C i). lra.
  - destruct J as (i & _ & J). generalize (C i). lra.
  - destruct J as (i & J). destruct (enters_before_leaving b c generic_b generic i p J B) as (k & K). now apply (I k).
  - destruct (enters_from_outside c b generic_reversed q B C) as (k & K). apply (J k). now apply reversed.
  - destruct (enters_from_outside b c generic p C B) as (k & K). now apply (I k).
Qed.
End counted.
