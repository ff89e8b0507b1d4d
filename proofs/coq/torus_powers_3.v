(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The powers of a point to the spheres of all translates of cells in a periodic box of space: docs/theory.md 8.3. As torus_powers.v.

   - power_across_3      how the powers to the spheres of two neighbours differ
   - finitely_many_3     finitely many translates have a small power at a point
   - others_later        a straight way leaves a cell through one facet, if it begins in general position
   - across_facet        and it is inside of the next cell then

   Corners of cells are o, u, v, w as in tetrahedron.v, weights those of space_crossings.v. *)
Require Import Reals ZArith Lra Lia Psatz List Permutation.
From Annulus Require Import tetrahedron small torus_3.
From Annulus Require space_mesh space_crossings space_embedding space_delaunay general_position space_line torus_powers.
From Annulus Require Export torus_frames_3.
Import ListNotations.
Open Scope R_scope.

(* What goes down as long as it is bad ends. *)
Lemma descend_3 {I} (f : I -> R) (bad : I -> Prop) (l : list I) (Q : Prop) :
  (forall i, In i l -> bad i -> Q \/ exists j, In j l /\ bad j /\ f j < f i) -> forall i, In i l -> bad i -> Q.
Proof.
  intro Step. set (below i := filter (fun j => if Rlt_dec (f j) (f i) then true else false) l).
  assert (K : forall n i, (length (below i) <= n)%nat -> In i l -> bad i -> Q).
  { induction n as [|n IH]; intros i N Ii Bi; destruct (Step i Ii Bi) as [H|(j & Ij & Bj & F)]; trivial.
    - exfalso. assert (J : In j (below i)) by (apply filter_In; split; [exact Ij|destruct (Rlt_dec (f j) (f i)); easy]).
      destruct (below i); [destruct J|simpl in N; lia].
    - apply (IH j); trivial. assert (D : forall k, incl k l -> (length (filter (fun h => if Rlt_dec (f h) (f j) then true else false) k)
        + length (filter (fun h => if Req_EM_T (f h) (f j) then true else false) k) <= length (filter (fun h => if Rlt_dec (f h)
          (f i) then true else false) k))%nat).
      { clear - F. intros k _. induction k as [|h k IHk]; [simpl; lia|]. simpl.
        destruct (Rlt_dec (f h) (f j)), (Req_EM_T (f h) (f j)), (Rlt_dec (f h) (f i)); simpl; try lia; exfalso; lra. }
      assert (E := D l (fun h J => J)). fold (below j) (below i) in E.
      assert (J : In j (filter (fun h => if Req_EM_T (f h) (f j) then true else false) l)) by (apply filter_In; split;
      [exact Ij|destruct (Req_EM_T (f j) (f j)); easy]).
      destruct (filter (fun h => if Req_EM_T (f h) (f j) then true else false) l); [destruct J|simpl in E; lia]. }
  intros i Ii Bi. exact (K _ i (le_n _) Ii Bi).
Qed.

Definition t0 : space_mesh.four := (0, 1, 2, 3)%nat.
Definition instances_3 (T : list torus_cell_3) (n : Z) : list (torus_cell_3 * offset_3) :=
  list_prod T (list_prod (list_prod (torus_powers.up_to n) (torus_powers.up_to n)) (torus_powers.up_to n)).

Lemma in_instances_3 T n c i j k : In c T -> (Z.abs i <= n /\ Z.abs j <= n /\ Z.abs k <= n)%Z -> In (c, (i, j, k)) (instances_3 T n).
Proof. intros I (A & B & C). apply in_prod; [exact I|]. apply in_prod; [apply in_prod|]; now apply torus_powers.in_up_to. Qed.

Lemma of_instances_3 T n k : In k (instances_3 T n) -> In (fst k) T.
Proof. destruct k. intro I. now apply in_prod_iff in I. Qed.

Section placed.
Variables (x : nat -> vec) (L : box_3).
Hypothesis box_positive : 0 < det_3 L.
Notation spot := (site_at_3 x L).
Notation six_of := (six_of x L).

Definition places (r : torus_cell_3) : nat ->
  vec := let '(a, b, c, d) := r in fun n => match n with 0%nat => spot a | 1%nat => spot b | 2%nat => spot c | _ => spot d end.
(* The weights of the corners at z, times six volumes. *)
Definition weight (r : torus_cell_3) (z : vec) (i : corner) : R := space_crossings.bary (places r) t0 z i.
Definition in_torus_cell_3 (z : vec) (r : torus_cell_3) : Prop := forall i, 0 <= weight r z i.
Definition inside_torus_cell_3 (z : vec) (r : torus_cell_3) : Prop := forall i, 0 < weight r z i.
Definition power_3 (z : vec) (r : torus_cell_3) : R := sq z - space_delaunay.plane_3 (places r) (space_delaunay.lift_3 (places r)) t0 z.
(* The facet opposite to a corner first. *)
Definition view_at (r : torus_cell_3) (i : corner) : torus_cell_3 :=
  let '(a, b, c, d) := r in match i with o => (b, d, c, a) | u => (a, c, d, b) | v => (a, d, b, c) | w => (a, b, c, d) end.

Lemma size_is r : space_crossings.size (places r) t0 = six_of r.
Proof. now destruct r as (((a, b), c), d). Qed.

Lemma view_at_in r i c : In r (views_3 c) -> In (view_at r i) (views_3 c).
Proof. intro I. apply (views_again r c I). destruct r as (((a, b), c'), d), i; simpl; tauto. Qed.

Lemma weight_first r z i : weight (view_at r i) z w = weight r z i.
Proof. now destruct r as (((a, b), c), d), i. Qed.

Lemma view_back r c : In r (views_3 c) -> In c (views_3 r).
Proof. destruct c as (((a, b), c), d). simpl. intro H. repeat (destruct H as [<-|H]; [simpl; tauto|]). destruct H. Qed.

Ltac same_weight := intro; unfold weight, space_crossings.bary, space_crossings.side_of, space_mesh.facet_height, t0, space_mesh.orient; cbn [places];
  match goal with |- context [site_at_3 x L ?a] => generalize (site_at_3 x L a) end; intro;
  repeat match goal with |- context [site_at_3 x L ?a] => generalize (site_at_3 x L a); intro end; vector.

Lemma weight_of_view r c : In r (views_3 c) -> forall j, exists i, forall z, weight r z j = weight c z i.
Proof.
  destruct c as (((a, b), c), d). simpl. intros H j.
  assert (F : forall i, (forall z, weight r z j = weight (a, b, c, d) z i) -> exists i, forall z, weight r z j = weight (a, b, c, d) z i) by
  (intros i E; now exists i).
  repeat (destruct H as [<-|H]; [destruct j; first [solve [apply (F o); same_weight]|solve [apply (F u); same_weight]|
    solve [apply (F v); same_weight]|solve [apply (F w); same_weight]]|]). destruct H.
Qed.

(* ---- Spheres ---- *)

Definition on_sphere (r : torus_cell_3) (m : vec) (r2 : R) : Prop := forall s, is_corner_3 s r -> sq (spot s ⊖ m) = r2.

Lemma has_sphere r : 0 < six_of r -> exists m r2, on_sphere r m r2.
Proof.
  rewrite <- size_is. intro P. destruct (space_delaunay.sphere_of (places r) t0 P) as (m & r2 & H). exists m, r2. intros s C.
  destruct r as (((a, b), c), d). destruct C as [->|[->|[->| ->]]]; [apply (H o)|apply (H u)|apply (H v)|apply (H w)].
Qed.

Lemma power_by_sphere r m r2 y : 0 < six_of r -> on_sphere r m r2 -> power_3 y r = sq (y ⊖ m) - r2.
Proof.
  rewrite <- size_is. intros P H. unfold power_3. symmetry. apply space_delaunay.power_lift_3; [exact P|].
  intro i. destruct r as (((a, b), c), d). destruct i; apply H; simpl; tauto.
Qed.

Lemma power_at_corner_3 s r : 0 < six_of r -> is_corner_3 s r -> power_3 (spot s) r = 0.
Proof. intros P C. destruct (has_sphere r P) as (m & r2 & H). rewrite (power_by_sphere r m r2 _ P H), (H s C). ring. Qed.

Lemma power_of_view r c y : In r (views_3 c) -> 0 < six_of c -> power_3 y r = power_3 y c.
Proof.
  intros I P. destruct (has_sphere c P) as (m & r2 & H). rewrite (power_by_sphere c m r2 y P H).
  apply power_by_sphere; [now rewrite (six_of_view x L r c I)|].
  intros s C. apply H. now apply (view_corners r c s I).
Qed.

Lemma power_moved_3 t r y : 0 < six_of r -> power_3 y (moved_cell_3 t r) = power_3 (y ⊖ lattice_3 L t) r.
Proof.
  intro P. destruct (has_sphere r P) as (m & r2 & H). rewrite (power_by_sphere r m r2 _ P H), (power_by_sphere _ (lattice_3 L t ⊕ m) r2).
  - f_equal. generalize (lattice_3 L t). vector.
  - now rewrite six_moved.
  - intros s C. assert (K : exists s0, is_corner_3 s0 r /\ s = moved_3 t s0).
    { destruct r as (((a, b), c), d). destruct C as [->|[->|[->| ->]]]; [exists a|exists b|exists c|exists d]; simpl; tauto. }
    destruct K as (s0 & C0 & ->). rewrite <- (H s0 C0), site_moved. generalize (lattice_3 L t) (spot s0). vector.
Qed.

Lemma power_across_3 a b c q p y : 0 < six_of (a, b, c, q) -> 0 < six_of (b, a, c, p) ->
  six_of (a, b, c, q) * six_of (b, a, c, p) * (power_3 y (b, a, c, p) - power_3 y (a, b, c, q))
  = weight (a, b, c, q) y w * beyond_sphere (spot a) (spot b) (spot c) (spot q) (spot p).
Proof.
  intros P P'. set (m := fun n => match n with 0%nat => spot a | 1%nat => spot b | 2%nat => spot c | 3%nat => spot p | _ => spot q end).
  assert (E := space_delaunay.planes_apart m (space_delaunay.lift_3 m) 0%nat 1%nat 2%nat 3%nat 4%nat y P P').
  assert (B := space_delaunay.insphere_height m 0%nat 1%nat 2%nat 3%nat 4%nat P').
  change (space_delaunay.plane_3 m (space_delaunay.lift_3 m) (0, 1, 2, 4)%nat y)
    with (space_delaunay.plane_3 (places (a, b, c, q)) (space_delaunay.lift_3 (places (a, b, c, q))) t0 y) in E.
  change (space_delaunay.plane_3 m (space_delaunay.lift_3 m) (1, 0, 2, 3)%nat y)
    with (space_delaunay.plane_3 (places (b, a, c, p)) (space_delaunay.lift_3 (places (b, a, c, p))) t0 y) in E.
  change (space_delaunay.insphere_at m 0 1 2 3 4) with (beyond_sphere (spot a) (spot b) (spot c) (spot q) (spot p)) in B.
  change (space_crossings.size m (0, 1, 2, 4)%nat) with (six_of (a, b, c, q)) in E.
  change (space_crossings.size m (1, 0, 2, 3)%nat) with (six_of (b, a, c, p)) in B.
  change (space_mesh.facet_height m (0, 1, 2, 4)%nat y) with (weight (a, b, c, q) y w) in E. unfold power_3. rewrite <- B.
  transitivity (six_of (b, a, c, p) * (six_of (a, b, c, q) * (space_delaunay.plane_3 (places (a, b, c, q))
  (space_delaunay.lift_3 (places (a, b, c, q))) t0 y
    - space_delaunay.plane_3 (places (b, a, c, p)) (space_delaunay.lift_3 (places (b, a, c, p))) t0 y))); [ring|]. rewrite E.
      change (m 4%nat) with (spot q). ring.
Qed.

(* ---- Finitely many translates have a small power at a point ---- *)

Lemma linear_bound n d l k : sq (d ⊖ l) < k -> Rabs (l · n) <= Rabs (d · n) + (1 + Rabs k) * norm n.
Proof.
  intro H. assert (B : norm (d ⊖ l) <= 1 + Rabs k).
  { assert (N := torus_powers.square_bound (norm (d ⊖ l)) k). rewrite norm_sq in N. generalize (N H) (Rle_abs (norm (d ⊖ l))). lra. }
  replace (l · n) with (d · n - (d ⊖ l) · n) by vector. eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp. apply Rplus_le_compat_l.
  eapply Rle_trans; [apply cauchy|]. apply Rmult_le_compat_r; [apply norm_nonneg|exact B].
Qed.

Lemma few_translates_3 c y k : 0 < six_of c -> exists n, forall p q r, power_3 y (moved_cell_3 (p, q, r) c) < k -> (Z.abs p <= n /\ Z.abs q <= n /\
  Z.abs r <= n)%Z.
Proof.
  intro P. destruct (has_sphere c P) as (m & r2 & H). assert (D := box_positive). unfold det_3 in D.
  set (bound n := (Rabs ((y ⊖ m) · n) + (1 + Rabs (k + r2)) * norm n) / vol (L1 L) (L2 L) (L3 L)).
  set (n1 := up (bound (L2 L ✕ L3 L))). set (n2 := up (bound (L3 L ✕ L1 L))). set (n3 := up (bound (L1 L ✕ L2 L))).
  exists (Z.max n1 (Z.max n2 n3)). intros p q r E. rewrite (power_moved_3 _ _ _ P), (power_by_sphere c m r2 _ P H) in E.
  assert (F : sq ((y ⊖ m) ⊖ lattice_3 L (p, q, r)) < k + r2).
  { replace ((y ⊖ m) ⊖ lattice_3 L (p, q, r)) with ((y ⊖ lattice_3 L (p, q, r)) ⊖ m) by (generalize (lattice_3 L (p, q, r)); vector). lra. }
  assert (B : forall n i, lattice_3 L (p, q, r) · n = IZR i * vol (L1 L) (L2 L) (L3 L) -> Rabs (IZR i) <= bound n).
  { intros n i Ei. assert (K := linear_bound n _ _ _ F). rewrite Ei, Rabs_mult, (Rabs_pos_eq (vol _ _ _)) in K by lra. unfold bound.
    apply Rmult_le_reg_r with (vol (L1 L) (L2 L) (L3 L)); [exact D|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra. }
  assert (A1 : (Z.abs p <= n1)%Z) by (apply torus_powers.integer_bound, B; simpl; generalize (L1 L) (L2 L) (L3 L); vector).
  assert (A2 : (Z.abs q <= n2)%Z) by (apply torus_powers.integer_bound, B; simpl; generalize (L1 L) (L2 L) (L3 L); vector).
  assert (A3 : (Z.abs r <= n3)%Z) by (apply torus_powers.integer_bound, B; simpl; generalize (L1 L) (L2 L) (L3 L); vector). lia.
Qed.

Lemma few_cells_3 T y k : positive_torus_3 x L T -> exists n, forall c p q r, In c T -> power_3 y (moved_cell_3 (p, q, r) c) < k ->
  (Z.abs p <= n /\ Z.abs q <= n /\ Z.abs r <= n)%Z.
Proof.
  induction T as [|c T IH]; intro P; [now exists 0%Z|]. destruct IH as (n & H); [intros c' I; apply P; now right|].
  destruct (few_translates_3 c y k (P c (or_introl eq_refl))) as (n' & H'). exists (Z.max n n').
  intros c' p q r [<-|I] Q; [generalize (H' p q r Q)|generalize (H c' p q r I Q)]; lia.
Qed.

Lemma finitely_many_3 T y k : positive_torus_3 x L T -> exists l, (forall i, In i l -> In (fst i) T) /\ forall i, In (fst i) T ->
  power_3 y (instance_3 i) < k -> In i l.
Proof.
  intro P. destruct (few_cells_3 T y k P) as (n & N). exists (instances_3 T n). split; [intros i; apply of_instances_3|].
  intros (c, ((p, q), r)) I H. apply in_instances_3; [exact I|]. now apply (N c).
Qed.

Lemma least_translate_3 T y c0 : positive_torus_3 x L T -> In c0 T ->
  exists i, In (fst i) T /\ forall j, In (fst j) T -> power_3 y (instance_3 i) <= power_3 y (instance_3 j).
Proof.
  intros P I0. destruct (finitely_many_3 T y (power_3 y (instance_3 (c0, (0, 0, 0)%Z)) + 1) P) as (l & Back & All).
  assert (I : In (c0, (0, 0, 0)%Z) l) by (apply All; [exact I0|lra]).
  destruct (torus_powers.least (fun i => power_3 y (instance_3 i)) l _ I) as (i & Il & M). exists i. split; [now apply Back|].
  intros j Ij. destruct (Rlt_dec (power_3 y (instance_3 j)) (power_3 y (instance_3 (c0, (0, 0, 0)%Z)) + 1)) as [S|S]; [now apply M, All|].
  generalize (M _ I). lra.
Qed.

(* ---- A straight way through cells ---- *)

Definition way (p y : vec) (s : R) : vec := (1 - s) ⊙ p ⊕ s ⊙ y.
Lemma weight_on_way r p y s i : weight r (way p y s) i = (1 - s) * weight r p i + s * weight r y i.
Proof.
  destruct (space_crossings.bary_affine (places r) t0 i) as (n & k & F). unfold weight, way. rewrite !F. generalize n p y. vector.
Qed.

(* Where the way leaves the half-space of a facet. *)
Definition passed (p y : vec) (r : torus_cell_3) (i : corner) : R := if Rlt_dec (weight r y i) 0 then weight r p i / (weight r p i - weight r y i) else 1.
Definition leaves (p y : vec) (r : torus_cell_3) : R := Rmin (Rmin (passed p y r o) (passed p y r u)) (Rmin (passed p y r v) (passed p y r w)).

Lemma leaves_first p y r i : (forall j, passed p y r i <= passed p y r j) -> leaves p y r = passed p y r i.
Proof.
  intro M. unfold leaves. apply Rle_antisym; [|repeat apply Rmin_glb; apply M].
  assert (A := Rmin_l (Rmin (passed p y r o) (passed p y r u)) (Rmin (passed p y r v) (passed p y r w))).
  assert (B := Rmin_r (Rmin (passed p y r o) (passed p y r u)) (Rmin (passed p y r v) (passed p y r w))).
  assert (A1 := Rmin_l (passed p y r o) (passed p y r u)). assert (A2 := Rmin_r (passed p y r o) (passed p y r u)).
  assert (B1 := Rmin_l (passed p y r v) (passed p y r w)). assert (B2 := Rmin_r (passed p y r v) (passed p y r w)). destruct i; lra.
Qed.

Lemma passed_after p y r s i : 0 <= s <= 1 -> 0 < weight r (way p y s) i -> s <= passed p y r i /\ (weight r y i < 0 -> 0 < weight r p i /\
  s < passed p y r i < 1).
Proof.
  rewrite weight_on_way. intros S P. unfold passed. generalize dependent (weight r p i). generalize (weight r y i). intros c b P.
  destruct (Rlt_dec c 0) as [N|N]; [|split; [lra|intro; lra]].
  assert (Pos : 0 < b) by nra. assert (A : s < b / (b - c)).
  { apply Rmult_lt_reg_r with (b - c); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra. }
  assert (B : b / (b - c) < 1) by (apply Rmult_lt_reg_r with (b - c); [lra|]; unfold Rdiv; rewrite Rmult_assoc, Rinv_l by lra; lra).
  split; [lra|]. intros _. lra.
Qed.

Lemma weight_there p y r i : 0 < weight r p i -> weight r y i < 0 -> weight r (way p y (passed p y r i)) i = 0.
Proof. rewrite weight_on_way. unfold passed. intros P N. destruct (Rlt_dec _ 0); [field|]; lra. Qed.

(* No two facets are left at once. *)
Definition in_general_position (p y : vec) (r : torus_cell_3) : Prop :=
  forall i j, i <> j -> weight r y i < 0 -> weight r p i * weight r y j - weight r y i * weight r p j <> 0.

Lemma others_later p y r s i j : in_general_position p y r -> 0 <= s <= 1 -> (forall k, 0 < weight r (way p y s) k) -> weight r y i < 0 ->
  (forall k, passed p y r i <= passed p y r k) -> i <> j -> 0 < weight r (way p y (passed p y r i)) j.
Proof.
  intros G S I N M D. destruct (passed_after p y r s i S (I i)) as [_ K]. destruct (K N) as [Bi [Lo Hi]]. assert (Ij := I j). assert (Mj := M j).
  destruct (passed_after p y r s j S Ij) as [_ Kj]. assert (Gij := G i j D N). rewrite weight_on_way in *. revert Mj Kj Lo Hi. unfold passed.
  destruct (Rlt_dec (weight r y i) 0) as [_|]; [|lra]. revert Bi N Ij Gij. generalize (weight r p i) (weight r y i) (weight r p j) (weight r y j).
  intros b c b' c' Bi N Ij Gij.
  intros Mj Kj Lo Hi. assert (E : (1 - b / (b - c)) * b' + b / (b - c) * c' = (b * c' - c * b') / (b - c)) by (field; lra).
  destruct (Rlt_dec c' 0) as [N'|N'].
  - rewrite E. destruct (Kj N') as [Bj _]. apply Rdiv_lt_0_compat; [|lra].
    assert (0 <= b * c' - c * b'); [|lra]. assert (F : b * (b' - c') <= b' * (b - c)); [|lra].
    apply (Rmult_le_compat_r ((b - c) * (b' - c'))) in Mj; [|apply Rmult_le_pos; lra].
    replace (b / (b - c) * ((b - c) * (b' - c'))) with (b * (b' - c')) in Mj by (field; lra).
    replace (b' / (b' - c') * ((b - c) * (b' - c'))) with (b' * (b - c)) in Mj by (field; lra). exact Mj.
  - set (t := b / (b - c)) in *. clearbody t. clear E Mj Kj Gij. assert (0 < (1 - t) * ((1 - s) * b' + s * c')) by (apply Rmult_lt_0_compat; lra).
    assert (0 <= (t - s) * c') by (apply Rmult_le_pos; lra).
    assert (Z : (1 - s) * ((1 - t) * b' + t * c') = (1 - t) * ((1 - s) * b' + s * c') + (t - s) * c') by ring.
    assert (0 < 1 - s) by lra. apply Rmult_lt_reg_l with (1 - s); [assumption|]. rewrite Z, Rmult_0_r. lra.
Qed.

(* Across the facet that is left. *)
Lemma across_facet a b c q p z : 0 < six_of (a, b, c, q) -> weight (a, b, c, q) z w = 0 ->
  six_of (a, b, c, q) * weight (b, a, c, p) z o = weight (a, b, c, q) z u * six_of (b, a, c, p) /\
  six_of (a, b, c, q) * weight (b, a, c, p) z u = weight (a, b, c, q) z o * six_of (b, a, c, p) /\
  six_of (a, b, c, q) * weight (b, a, c, p) z v = weight (a, b, c, q) z v * six_of (b, a, c, p).
Proof.
  intros P Z. assert (E := fun i => space_crossings.affine_bary (places (a, b, c, q)) _ t0 z (space_crossings.bary_affine (places (b, a, c, p)) t0 i)). cbv beta in E.
  assert (Cd : forall i, space_crossings.bary (places (b, a, c, p)) t0 (places (b, a, c, p)
  (space_crossings.point_of t0 i)) i = space_crossings.size (places (b, a, c, p)) t0)
    by (intro i; rewrite space_crossings.bary_corner; destruct (space_line.corner_dec i i) as [_|N]; [reflexivity|now elim N]).
  assert (Cn : forall i j, i <> j -> space_crossings.bary (places (b, a, c, p)) t0 (places (b, a, c, p) (space_crossings.point_of t0 j)) i = 0)
    by (intros i j D; rewrite space_crossings.bary_corner; destruct (space_line.corner_dec i j) as [N|_]; [now elim D|reflexivity]).
  rewrite <- !size_is in *. unfold weight in *.
  assert (Eo := E o). assert (Eu := E u). assert (Ev := E v). clear E.
  change (places (a, b, c, q) (space_crossings.point_of t0 o)) with (places (b, a, c, p) (space_crossings.point_of t0 u)) in Eo, Eu, Ev.
  change (places (a, b, c, q) (space_crossings.point_of t0 u)) with (places (b, a, c, p) (space_crossings.point_of t0 o)) in Eo, Eu, Ev.
  change (places (a, b, c, q) (space_crossings.point_of t0 v)) with (places (b, a, c, p) (space_crossings.point_of t0 v)) in Eo, Eu, Ev.
  rewrite Z in Eo, Eu, Ev. rewrite Cd, (Cn o u), (Cn o v) in Eo by discriminate. rewrite Cd, (Cn u o), (Cn u v) in Eu by discriminate.
  rewrite Cd, (Cn v u), (Cn v o) in Ev by discriminate. rewrite Eo, Eu, Ev. repeat split; ring.
Qed.

Lemma weight_back a b c q p z : weight (b, a, c, p) z w = - weight (a, b, c, q) z w.
Proof. apply space_mesh.orient_swap. Qed.
End placed.
