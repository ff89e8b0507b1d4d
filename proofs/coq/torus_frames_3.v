(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Cells of a periodic box of space at their places, and their translates: docs/theory.md 8.3. As torus_frames.v.

   - locally_delaunay_torus_3   what is tested: no corner of a neighbour is strictly inside the sphere of a cell
   - neighbour_3                a translate of a cell has a translate of a cell beyond each of its facets
   - certified_3                what is tested of cells in their own frames holds of all such translates *)
Require Import Reals ZArith Lra Lia List Permutation.
From Annulus Require Import torus_3.
From Annulus Require bicell.
Import ListNotations.
Open Scope R_scope.

Definition moved_cell_3 (t : offset_3) (c : torus_cell_3) : torus_cell_3 :=
  let '(a, b, c, d) := c in (moved_3 t a, moved_3 t b, moved_3 t c, moved_3 t d).
Definition instance_3 (k : torus_cell_3 * offset_3) : torus_cell_3 := moved_cell_3 (snd k) (fst k).
(* The same cell written otherwise: any facet first, turned in any way, and the corner opposite to it. *)
Definition turns_3 (c : torus_cell_3) : list torus_cell_3 := let '(a, b, c, d) := c in [(a, b, c, d); (b, c, a, d); (c, a, b, d)].
Definition views_3 (c : torus_cell_3) : list torus_cell_3 :=
  let '(a, b, c, d) := c in flat_map turns_3 [(b, d, c, a); (a, c, d, b); (a, d, b, c); (a, b, c, d)].
Definition is_corner_3 (s : site_3) (c : torus_cell_3) : Prop := let '(a, b, c, d) := c in s = a \/ s = b \/ s = c \/ s = d.
Definition torus_vertex_3 (T : list torus_cell_3) (v : nat) : Prop := exists c s, In c T /\ is_corner_3 s c /\ fst s = v.
(* Positive for p outside of the sphere of a, b, c, q. *)
Definition beyond_sphere (a b c q p : vec) : R :=
  bicell.det (fun k => match k with bicell.a => a | bicell.b => b | bicell.c => c | bicell.p => p | bicell.q => q end).

Definition sum_3 (t u : offset_3) : offset_3 := let '(i, j, k) := t in let '(l, m, n) := u in (i + l, j + m, k + n)%Z.
Definition minus_3 (t : offset_3) : offset_3 := let '(i, j, k) := t in (- i, - j, - k)%Z.

Lemma moved_twice_3 t u s : moved_3 t (moved_3 u s) = moved_3 (sum_3 t u) s.
Proof. destruct t as ((i, j), k), u as ((l, m), n), s as (v, ((p, q), r)). simpl. f_equal. f_equal; [f_equal|]; ring. Qed.

Lemma moved_zero_3 s : moved_3 (0, 0, 0)%Z s = s.
Proof. destruct s as (v, ((i, j), k)). reflexivity. Qed.

Lemma minus_sum_3 t : sum_3 (minus_3 t) t = (0, 0, 0)%Z.
Proof. destruct t as ((i, j), k). simpl. f_equal; [f_equal|]; ring. Qed.

Lemma sum_minus_3 t u : sum_3 (sum_3 t (minus_3 u)) u = t.
Proof. destruct t as ((i, j), k), u as ((l, m), n). simpl. f_equal; [f_equal|]; ring. Qed.

Lemma cell_moved_twice_3 t u c : moved_cell_3 t (moved_cell_3 u c) = moved_cell_3 (sum_3 t u) c.
Proof. destruct c as (((a, b), c), d). cbn [moved_cell_3]. now rewrite !moved_twice_3. Qed.

Lemma instance_zero_3 c : instance_3 (c, (0, 0, 0)%Z) = c.
Proof. destruct c as (((a, b), c), d). unfold instance_3. cbn [fst snd moved_cell_3]. now rewrite !moved_zero_3. Qed.

Lemma view_moved t r c : In r (views_3 c) -> In (moved_cell_3 t r) (views_3 (moved_cell_3 t c)).
Proof. destruct c as (((a, b), c), d). simpl. intro H. repeat (destruct H as [<-|H]; [tauto|]). destruct H. Qed.

Lemma view_of_moved t r c : In r (views_3 (moved_cell_3 t c)) -> exists r0, In r0 (views_3 c) /\ r = moved_cell_3 t r0.
Proof.
  destruct c as (((a, b), c), d). intro H. change (views_3 (moved_cell_3 t (a, b, c, d))) with (map (moved_cell_3 t) (views_3 (a, b, c, d))) in H.
  apply in_map_iff in H. destruct H as (r0 & <- & I). now exists r0.
Qed.

Lemma own_view c : In c (views_3 c).
Proof. destruct c as (((a, b), c), d). simpl. tauto. Qed.

Lemma views_again r c : In r (views_3 c) -> incl (views_3 r) (views_3 c).
Proof. destruct c as (((a, b), c), d). simpl. intro H. repeat (destruct H as [<-|H]; [intros s; simpl; tauto|]). destruct H. Qed.

Lemma view_corners r c s : In r (views_3 c) -> is_corner_3 s r <-> is_corner_3 s c.
Proof. destruct c as (((a, b), c), d). simpl. intro H. repeat (destruct H as [<-|H]; [simpl; tauto|]). destruct H. Qed.

(* ---- Across a facet ---- *)

Lemma turned_back s s' : turned_facet s s' -> turned_facet s' s.
Proof. intros []; constructor. Qed.

Lemma turned_on s s' s'' : turned_facet s s' -> turned_facet s' s'' -> turned_facet s s''.
Proof. intros [a b c|a b c|a b c] H; inversion H; subst; constructor. Qed.

Lemma facet_of_view a b c q t : In (a, b, c, q) (views_3 t) -> exists s, In s (facets_3 t) /\ turned_facet s (a, b, c).
Proof.
  destruct t as (((u, v), w), y). simpl. intro H.
  assert (F : forall s s', In s (facets_3 (u, v, w, y)) -> turned_facet s s' -> exists s, In s (facets_3 (u, v, w, y)) /\ turned_facet s s')
    by (intros s s' I K; now exists s).
  repeat (destruct H as [[=<- <- <- <-]|H]; [first [apply (F (v, y, w)); [simpl; tauto|constructor]|apply (F (u, w, y)); [simpl; tauto|constructor]|
    apply (F (u, y, v)); [simpl; tauto|constructor]|apply (F (u, v, w)); [simpl; tauto|constructor]]|]). destruct H.
Qed.

Lemma view_of_facet s s' t : In s (facets_3 t) -> turned_facet s s' -> exists q, let '(a, b, c) := s' in In (a, b, c, q) (views_3 t).
Proof.
  destruct t as (((u, v), w), y). intros [<-|[<-|[<-|[<-|[]]]]] H; [exists u|exists v|exists w|exists y]; inversion H; subst; simpl; tauto.
Qed.

Lemma forall2_left {S U} (Q : S -> U -> Prop) l l' s : Forall2 Q l l' -> In s l -> exists s', In s' l' /\ Q s s'.
Proof. induction 1 as [|p p' l l' H _ IH]; [easy|]. intros [<-|I]; [exists p'; simpl;
  tauto|]. destruct (IH I) as (s' & I' & K). exists s'. simpl. tauto. Qed.

Lemma forall2_right {S U} (Q : S -> U -> Prop) l l' s' : Forall2 Q l l' -> In s' l' -> exists s, In s l /\ Q s s'.
Proof. induction 1 as [|p p' l l' H _ IH]; [easy|]. intros [<-|I]; [exists p; simpl; tauto|]. destruct (IH I) as (s & I' & K). exists s. simpl. tauto. Qed.

Definition mate (s : facet_3) (t : offset_3) : facet_3 := let '(a, b, c) := s in (moved_3 t b, moved_3 t a, moved_3 t c).

Lemma mate_turned s s' t : turned_facet s s' -> turned_facet (mate s t) (mate s' t).
Proof. intros []; simpl; constructor. Qed.

Lemma other_facet T c s : glued_torus_3 T -> In c T -> In s (facets_3 c) -> exists c' t s', In c' T /\ In s' (facets_3 c') /\ turned_facet s' (mate s t).
Proof.
  intros (l & pairs & F & P) Ic Is. destruct (forall2_left _ _ _ s F) as (s1 & I1 & H1); [apply in_flat_map; now exists c|].
  apply (Permutation_in _ P) in I1. apply in_flat_map in I1. destruct I1 as ((f, t) & Ik & I1). destruct f as ((u, v), w).
  assert (Found : forall g, In g (both_sides_3 ((u, v, w), t)) -> exists c' s', In c' T /\ In s' (facets_3 c') /\ turned_facet s' g).
  { intros g Ig. destruct (forall2_right _ _ _ g F) as (s' & I' & H').
    - apply (Permutation_in _ (Permutation_sym P)). apply in_flat_map. now exists ((u, v, w), t).
    - apply in_flat_map in I'. destruct I' as (c' & Ic' & I'). now exists c', s'. }
  destruct I1 as [<-|[<-|[]]].
  - destruct (Found (mate (u, v, w) t)) as (c' & s' & I' & J & H'); [simpl; tauto|]. exists c', t, s'. split; [exact I'|]. split; [exact J|].
    apply (turned_on _ _ _ H'). apply mate_turned. now apply turned_back.
  - destruct (Found (u, v, w)) as (c' & s' & I' & J & H'); [simpl; tauto|]. exists c', (minus_3 t), s'. split; [exact I'|]. split; [exact J|].
    apply (turned_on _ _ _ H'). apply turned_back. replace (u, v, w) with (mate (moved_3 t v, moved_3 t u, moved_3 t w) (minus_3 t));
    [now apply mate_turned|].
    cbn [mate]. now rewrite !moved_twice_3, !minus_sum_3, !moved_zero_3.
Qed.

Lemma neighbour_3 T k a b c q : glued_torus_3 T -> In (fst k) T -> In (a, b, c, q) (views_3 (instance_3 k)) ->
  exists k' p, In (fst k') T /\ In (b, a, c, p) (views_3 (instance_3 k')).
Proof.
  destruct k as (cell, u). intros G Ic Iv. destruct (view_of_moved _ _ _ Iv) as ((((a0, b0), c0), q0) & I0 & [=-> -> -> ->]).
  destruct (facet_of_view _ _ _ _ _ I0) as (s & Is & Hs). destruct (other_facet T cell s G Ic Is) as (cell' & t & s' & Ic' & Is' & Hs').
  assert (H := turned_on _ _ _ Hs' (mate_turned _ _ t Hs)). destruct (view_of_facet _ _ _ Is' H) as (p & Ip). cbn [mate] in Ip.
  exists (cell', sum_3 u (minus_3 t)), (moved_3 (sum_3 u (minus_3 t)) p). split; [exact Ic'|].
  assert (E : forall s, moved_3 (sum_3 u (minus_3 t)) (moved_3 t s) = moved_3 u s) by (intro; now rewrite moved_twice_3, sum_minus_3).
  rewrite <- !E. exact (view_moved _ _ _ Ip).
Qed.

Section placed.
Variables (x : nat -> vec) (L : box_3).
Notation spot := (site_at_3 x L).

Definition six_of (c : torus_cell_3) : R := torus_volume x L c.
Definition positive_torus_3 (T : list torus_cell_3) : Prop := forall c, In c T -> 0 < six_of c.
(* Cells on both sides of a b c, the second one in its own frame, which is t away. *)
Definition locally_delaunay_torus_3 (T : list torus_cell_3) : Prop := forall e e' a b c q p t, In e T -> In e' T ->
  In (a, b, c, q) (views_3 e) -> In (moved_3 t b, moved_3 t a, moved_3 t c, moved_3 t p) (views_3 e') ->
  0 <= beyond_sphere (spot a) (spot b) (spot c) (spot q) (spot p).

Lemma six_moved t c : six_of (moved_cell_3 t c) = six_of c.
Proof.
  destruct c as (((a, b), c), d). unfold six_of, torus_volume, moved_cell_3. rewrite !site_moved. unfold six_volumes.
  generalize (lattice_3 L t) (spot a) (spot b) (spot c) (spot d). vector.
Qed.

Lemma six_of_view r c : In r (views_3 c) -> six_of r = six_of c.
Proof.
  destruct c as (((a, b), c), d). simpl. unfold six_of. intro H.
  repeat (destruct H as [<-|H]; [unfold torus_volume, six_volumes; generalize (spot a) (spot b) (spot c) (spot d); vector|]). destruct H.
Qed.

Lemma view_positive T k r : positive_torus_3 T -> In (fst k) T -> In r (views_3 (instance_3 k)) -> 0 < six_of r.
Proof. intros P I H. rewrite (six_of_view r _ H). unfold instance_3. rewrite six_moved. now apply P. Qed.

Lemma certified_3 (Q : R -> Prop) T k k' a b c q p : (forall e e' a b c q p t, In e T -> In e' T -> In (a, b, c, q) (views_3 e) ->
    In (moved_3 t b, moved_3 t a, moved_3 t c, moved_3 t p) (views_3 e') -> Q (beyond_sphere (spot a) (spot b) (spot c) (spot q) (spot p))) ->
  In (fst k) T -> In (fst k') T -> In (a, b, c, q) (views_3 (instance_3 k)) -> In (b, a, c, p) (views_3 (instance_3 k')) ->
  Q (beyond_sphere (spot a) (spot b) (spot c) (spot q) (spot p)).
Proof.
  destruct k as (e, u), k' as (e', u'). intros C Ic Ic' Iv Iv'. destruct (view_of_moved _ _ _ Iv) as ((((a0, b0), c0), q0) & I0 & [=-> -> -> ->]).
  cbn [fst snd] in *. set (p0 := moved_3 (minus_3 u) p). assert (Bp : p = moved_3 u p0).
  { unfold p0. rewrite moved_twice_3. replace (sum_3 u (minus_3 u)) with (0, 0, 0)%Z; [now rewrite moved_zero_3|].
    destruct u as ((i, j), k). simpl. f_equal; [f_equal|]; ring. }
  rewrite Bp. replace (beyond_sphere _ _ _ _ _) with (beyond_sphere (spot a0) (spot b0) (spot c0) (spot q0) (spot p0)).
  2: { rewrite !site_moved. unfold beyond_sphere, bicell.det, bicell.lambda_b, bicell.lambda_c, bicell.lambda_p, bicell.lambda_q, bicell.rel.
    generalize (lattice_3 L u) (spot a0) (spot b0) (spot c0) (spot q0) (spot p0). vector. }
  apply (C e e' a0 b0 c0 q0 p0 (sum_3 (minus_3 u') u) Ic Ic' I0).
  assert (I := view_moved (minus_3 u') _ _ Iv'). unfold instance_3 in I. cbn [fst snd] in I. rewrite cell_moved_twice_3, minus_sum_3 in I.
  assert (Z : moved_cell_3 (0, 0, 0)%Z e' = e') by exact (instance_zero_3 e'). rewrite Z, Bp in I. cbn [moved_cell_3] in I.
  rewrite !moved_twice_3 in I. exact I.
Qed.
End placed.
