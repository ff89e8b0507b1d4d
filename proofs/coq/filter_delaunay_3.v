(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The chain in space put together: from the doubles that come in, over what the filter writes down and looks at, to Delaunay. The silhouette of
   the border is looked at, as the plane's border is (silhouette_once).

   - answer_evaluated_3     a verdict that is what the filtered predicate answers of these doubles promises what the filter requires of one
   - filter_holds_3       after any calls of the filter every certificate holds where the vertices are
   - certificates_delaunay_3, filter_delaunay_3   hence the cells triangulate the convex hull, and are Delaunay *)
From Coq Require Import Reals ZArith Lra List Permutation.
From Coq Require Import Floats.
From Annulus Require tetrahedron bicell plane_mesh.
From Annulus Require Import vectors operations connect filter_2 filter_3 filter_doubles returned_3 stages predicate_3 flat_ridges_3.
From Annulus Require Import algorithm_list algorithm_filter algorithm_check algorithm_run filter_world filter_space.
From Annulus Require Import space_mesh space_crossings space_delaunay space_triangulation space_silhouette.
Import ListNotations.
Close Scope float_scope.
Open Scope R_scope.

Definition doubles_3 : Type := nat -> vector_3 machine.
Definition at_doubles_3 (f : doubles_3) : placement_3 := fun v => at_3 (f v).

Lemma coordinates_valid_3 p : coordinates_3 p -> valid_3 (at_3 p).
Proof. intros ([_ X] & [_ Y] & [_ Z]). split; [|split]; (split; [apply value_format|]); assumption. Qed.

(* Ties: the facets at a flat ridge lie on different sides of it; of points on a sphere any cells will do, whatever the perturbation prefers. *)
Definition no_fold_3 (c : certificate_3) (m : placement_3) : Prop :=
  match c with ridge_3 u w p q => ((m w ⊖ m u) ✕ (m p ⊖ m u)) · ((m w ⊖ m u) ✕ (m q ⊖ m u)) < 0 | _ => True end.
Lemma no_fold_3_local c m m' : (forall v, In v (points_3 c) -> m v = m' v) -> no_fold_3 c m -> no_fold_3 c m'.
Proof. intro E. destruct c as [|u w p q|]; simpl in *; trivial. rewrite <- !E by tauto. trivial. Qed.

(* ---- From certificates to Delaunay ---- *)

(* The sheets of the border: U from above, L from below (space_silhouette.v). *)
Definition certificates_3 (T : mesh_3) (U L : plane_mesh.mesh) : list certificate_3 :=
  map (fun t => let '(a, b, c, d) := t in least_first_3 a b c d) (cells T) ++
  map (fun k => let '(a, b, c, p, q) := k in sphere a b c p q) (bicells T) ++
  map (fun k => let '(a, b, x, y) := k in ridge_3 b a y x) (plane_mesh.bicells U) ++
  map (fun k => let '(a, b, x, y) := k in ridge_3 a b y x) (plane_mesh.bicells L).

Theorem certificates_delaunay_3 T U L (mesh : Z -> option certificate_3) m : glued_3 T ->
  (forall c, In c (certificates_3 T U L) -> exists i, mesh i = Some c) -> (forall i c, mesh i = Some c -> holds_3 no_fold_3 c m) ->
  silhouette_once m T U L -> triangulation_3 m T /\ delaunay_3 m T.
Proof.
  intros G A H S. assert (K : forall c, In c (certificates_3 T U L) -> holds_3 no_fold_3 c m) by (intros c I; destruct (A c I) as (i & E); now apply (H i)).
  assert (P : positive_3 m T).
  { intros a b c d I. apply (positive_cell no_fold_3 m a b c d), K, in_or_app. left. apply in_map_iff. now exists (a, b, c, d). }
  assert (R : ridges_convex m U L).
  { split; intros a b x y I.
    - assert (Q : holds_3 no_fold_3 (ridge_3 b a y x) m)
        by (apply K, in_or_app; right; apply in_or_app; right; apply in_or_app; left; apply in_map_iff; now exists (a, b, x, y)).
      cbn [holds_3] in Q. unfold orient_at in Q. rewrite orient_swap in Q. lra.
    - assert (Q : holds_3 no_fold_3 (ridge_3 a b y x) m)
        by (apply K, in_or_app; right; apply in_or_app; right; apply in_or_app; right; apply in_map_iff; now exists (a, b, x, y)).
      cbn [holds_3] in Q. unfold orient_at in Q. lra. }
  split.
  - now apply (silhouette_triangulation T m U L).
  - apply (silhouette_delaunay T m U L); trivial. intros a b c p q I.
    assert (Q : holds_3 no_fold_3 (sphere a b c p q) m)
      by (apply K, in_or_app; right; apply in_or_app; left; apply in_map_iff; now exists (a, b, c, p, q)).
    destruct Q as [Q|[Q _]]; [now apply Rlt_le|rewrite Q; apply Rle_refl].
Qed.

Section filter.
Context {o : options}.
#[local] Instance the_space : world := space list_length stamps_there_are worn_out no_fold_3.
Definition answered_in_space := answered_3 list_length stamps_there_are worn_out no_fold_3.

(* ---- Verdicts ---- *)

(* What the filtered predicate answers of these doubles, in whichever stage and mode. *)
Definition is_answer_in_space (f : doubles_3) (k : verdict) : Prop := exists correctly_rounded,
  match of k with
  | cell_3 a b c d => says (orientation_predicate_3 correctly_rounded (f a) (f b) (f c) (f d)) False (bound k)
  | ridge_3 a b c d => says (orientation_predicate_3 correctly_rounded (f a) (f b) (f c) (f d)) (flat_ridge_holds_3 (f a) (f b) (f c) (f d) = true) (bound k)
  | sphere a b c p q => says (empty_sphere_predicate_3 correctly_rounded (f a) (f b) (f c) (f p) (f q) where_needed) True (bound k)
  end.
Definition its_cells_positive (x : placement_3) (k : verdict) : Prop :=
  match of k with sphere a b c p q => 0 < orient_at x a b c q /\ 0 < orient_at x b a c p | _ => True end.

Lemma tetrahedron_says f correctly_rounded a b c d rule r : (forall v, coordinates_3 (f v)) -> says (orientation_predicate_3 correctly_rounded (f a) (f b) (f c) (f d)) rule r ->
  0 <= r /\ float_model.F r /\ 0 < orient_at (at_doubles_3 f) a b c d /\ r <= tetrahedron.half_width_simplex (corners_at (at_doubles_3 f) a b c d) \/
  r = 0 /\ orient_at (at_doubles_3 f) a b c d = 0 /\ rule.
Proof.
  intros D S. destruct (orientation_3_right (fun k => f (point_of (a, b, c, d) k)) (fun k => D _) correctly_rounded) as [R _]. cbn [point_of] in R. revert R S.
  destruct (orientation_predicate_3 _ _ _ _ _) as [|t|t|t]; simpl; try contradiction.
  - intros Z [Q ->]. right. split; [reflexivity|]. split; [exact Z|exact Q].
  - intros (_ & P & T0 & T) ->. left. split; [exact T0|]. split; [apply value_format|]. split; [exact P|exact T].
Qed.

Lemma sphere_says f correctly_rounded a b c p q rule r : (forall v, coordinates_3 (f v)) ->
  says (empty_sphere_predicate_3 correctly_rounded (f a) (f b) (f c) (f p) (f q) where_needed) rule r ->
  0 <= r /\ float_model.F r /\ 0 < insphere_at (at_doubles_3 f) a b c p q /\
    r <= Rmax 0 (sign_tolerance_3.own_tolerance_3 (bicell_at (at_doubles_3 f) a b c p q)) \/
  r = 0 /\ insphere_at (at_doubles_3 f) a b c p q = 0 /\ rule.
Proof.
  intros D S. destruct (empty_sphere_3_right (fun k =>
    match k with bicell.a => f a | bicell.b => f b | bicell.c => f c | bicell.p => f p | bicell.q => f q end)
    ltac:(intros []; apply D) correctly_rounded where_needed) as [R _]. unfold sphere_predicate in R.
  replace (fun k => at_3 _) with (bicell_at (at_doubles_3 f) a b c p q) in R by (apply FunctionalExtensionality.functional_extensionality; now intros []).
  revert R S. destruct (empty_sphere_predicate_3 _ _ _ _ _ _ _) as [|t|t|t]; simpl; try contradiction.
  - intros Z [Q ->]. right. split; [reflexivity|]. split; [exact Z|exact Q].
  - intros (_ & P & T0 & T) ->. left. split; [exact T0|]. split; [apply value_format|]. split; [exact P|exact T].
Qed.

Lemma answer_holds_3 f k : (forall v, coordinates_3 (f v)) -> its_cells_positive (at_doubles_3 f) k ->
  is_answer_in_space f k -> answered_in_space (at_doubles_3 f) k.
Proof.
  intros D P [correctly_rounded H]. destruct k as [i c t]. unfold its_cells_positive in P. cbn [of bound] in *. destruct c as [a b c d|a b c d|a b c p q].
  - destruct (tetrahedron_says f correctly_rounded a b c d _ t D H) as [(T0 & T1 & V & T)|(-> & Z & Q)]; [left; split; [exact T0|]; split; [exact T1|]; split; [exact V|exact T]|contradiction].
  - destruct (tetrahedron_says f correctly_rounded a b c d _ t D H) as [(T0 & T1 & V & T)|(-> & Z & Q)]; [left; split; [exact T0|]; split; [exact T1|]; split; [exact V|exact T]|].
    right. split; [reflexivity|]. right. split; [exact Z|]. apply flat_ridge_right_3; [|exact Z|exact Q]. intros v [<-|[<-|[<-|[<-|[]]]]]; apply D.
  - destruct P as [P1 P2]. destruct (sphere_says f correctly_rounded a b c p q _ t D H) as [(T0 & T1 & V & T)|(-> & Z & _)].
    + revert T. unfold Rmax. destruct (Rle_dec 0 _); intro T.
      * left. split; [exact T0|]. split; [exact T1|]. repeat split; trivial.
      * right. split; [now apply Rle_antisym|]. now left.
    + right. split; [reflexivity|]. right. now split.
Qed.

Theorem answer_evaluated_3 f k : (forall v, coordinates_3 (f v)) -> its_cells_positive (at_doubles_3 f) k -> is_answer_in_space f k -> evaluated (at_doubles_3 f) k.
Proof. intros D P H. apply (verdict_evaluated_3 _ _ _ no_fold_3 no_fold_3_local). now apply answer_holds_3. Qed.

Lemma answer_cell_3 f k a b c d : (forall v, coordinates_3 (f v)) -> of k = least_first_3 a b c d -> is_answer_in_space f k -> 0 < orient_at (at_doubles_3 f) a b c d.
Proof.
  destruct k as [i k t]. cbn [of]. intros D E H. apply (positive_cell no_fold_3). destruct (least_first_cell a b c d) as (a' & b' & c' & d' & E').
  rewrite E' in *. subst k. assert (A := answer_holds_3 f (Build_verdict i (cell_3 a' b' c' d') t) D I H). destruct A as [(_ & _ & A)|(_ & A)]; apply A.
Qed.

(* ---- A start: everything evaluated where the doubles are ---- *)

Record start_in_space (f : doubles_3) (m : Z -> option certificate_3) (verdicts : list verdict) : Prop := {
  in_domain_3 : forall v, coordinates_3 (f v);
  answers_right_3 : forall k, In k verdicts -> m (id k) = Some (of k) /\ is_answer_in_space f k;
  all_answered_3 : forall i c, m i = Some c -> In i (map id verdicts);
  ids_3 : forall i c, m i = Some c -> is_id i;
  with_cells_3 : forall i c d, m i = Some c -> counts_on_3 d c -> exists j, m j = Some d }.

Lemma start_answered_3 f m verdicts k : start_in_space f m verdicts -> In k verdicts -> answered_in_space (at_doubles_3 f) k.
Proof.
  intros [D R A _ C] I. destruct (R k I) as [M H]. apply answer_holds_3; trivial. unfold its_cells_positive.
  destruct (of k) as [| |a b c p q] eqn:E; trivial.
  assert (P : forall u v w x, counts_on_3 (least_first_3 u v w x) (sphere a b c p q) -> 0 < orient_at (at_doubles_3 f) u v w x).
  { intros u v w x Q. destruct (C _ _ _ M Q) as (j & J). assert (V := A j _ J). apply in_map_iff in V. destruct V as (h & <- & V).
    destruct (R h V) as [M' H']. apply (answer_cell_3 f h); trivial. congruence. }
  split; apply P; [now left|now right].
Qed.

(* The filter right after it evaluated everything: from whatever was before. *)
Definition recomputed_in_space (f : doubles_3) m verdicts (s : state) : system := {| of_filter := recompute (at_doubles_3 f) s m verdicts; tracks := true |}.
Definition places_3 (y : system) : placement_3 := moving (of_filter y).
Definition watches_3 (y : system) (T : mesh_3) (U L : plane_mesh.mesh) : Prop :=
  forall c, In c (certificates_3 T U L) -> exists i, algorithm_filter.mesh (of_filter y) i = Some c.

Theorem filter_holds_3 f m verdicts s z : start_in_space f m verdicts -> (0 <= epoch s)%Z -> calls (recomputed_in_space f m verdicts s) z ->
  forall i c, algorithm_filter.mesh (of_filter z) i = Some c -> holds_3 no_fold_3 c (places_3 z).
Proof.
  intros S E. assert (B := start_answered_3 f m verdicts). destruct (S) as [D R A I C].
  apply (space_filter_is_right _ _ _ stamps_positive no_fold_3 no_fold_3_local); trivial.
  - intro v. apply coordinates_valid_3, D.
  - intros k K. destruct (R k K). split; [assumption|now apply B].
Qed.

Theorem filter_delaunay_3 f m verdicts s z T U L : start_in_space f m verdicts -> (0 <= epoch s)%Z -> calls (recomputed_in_space f m verdicts s) z ->
  glued_3 T -> watches_3 z T U L -> silhouette_once (places_3 z) T U L -> triangulation_3 (places_3 z) T /\ delaunay_3 (places_3 z) T.
Proof.
  intros S E R G A B. apply (certificates_delaunay_3 T U L (algorithm_filter.mesh (of_filter z))); trivial. exact (filter_holds_3 f m verdicts s z S E R).
Qed.
End filter.
