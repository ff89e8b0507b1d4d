(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Another basis of the lattice, whose first vector is along no facet: docs/theory.md 8.3.

   - along_nothing   there is one among L_1 + p L_2 + p^2 L_3, since a polynomial has finitely many roots
   - rebased_cells   cells in the new basis are glued, positive and cover space as often; no site moves *)
Require Import Reals ZArith Lra Lia Psatz List Permutation.
From Annulus Require Import tetrahedron small sums torus_2 torus_3.
From Annulus Require general_position.
From Annulus Require Import torus_frames_3 torus_powers_3 torus_ray_3.
Import ListNotations.
Open Scope R_scope.

Definition new_box (p : Z) (L : box_3) : box_3 := Box_3 (L1 L ⊕ IZR p ⊙ L2 L ⊕ IZR (p * p) ⊙ L3 L) (L2 L) (L3 L).
(* The old vectors in the new basis. *)
Definition new_basis (p : Z) : basis_3 := Basis_3 (1, - p, - (p * p))%Z (0, 1, 0)%Z (0, 0, 1)%Z.

Lemma old_box p L : combined_3 (new_basis p) (new_box p L) = L.
Proof.
  destruct L as [A B C]. unfold combined_3, new_basis, new_box, lattice_3. cbn [L1 L2 L3 m1 m2 m3]. rewrite !opp_IZR.
  f_equal; generalize (IZR p) (IZR (p * p)); intros; apply vec_eq; coordinates; ring.
Qed.

Lemma new_spot p x L s : site_at_3 x (new_box p L) (rebased_site_3 (new_basis p) s) = site_at_3 x L s.
Proof. now rewrite rebased_site_stays_3, old_box. Qed.

Lemma new_det p L : det_3 (new_box p L) = det_3 L.
Proof. unfold det_3, new_box. cbn [L1 L2 L3]. generalize (L1 L) (L2 L) (L3 L) (IZR p) (IZR (p * p)). vector. Qed.

Lemma new_moved p t s : rebased_site_3 (new_basis p) (moved_3 t s) = moved_3 (combined_offset (new_basis p) t) (rebased_site_3 (new_basis p) s).
Proof.
  destruct t as ((i, j), k), s as (n, ((a, b), c)). unfold rebased_site_3, combined_offset, new_basis. cbn [moved_3 fst snd m1 m2 m3].
  apply f_equal2; [reflexivity|]. apply f_equal2; [apply f_equal2|]; ring.
Qed.

Definition new_cell (p : Z) (c : torus_cell_3) : torus_cell_3 := rebased_3 (new_basis p) c.
Definition new_instance (p : Z) (k : torus_cell_3 * offset_3) : torus_cell_3 * offset_3 := (new_cell p (fst k), combined_offset (new_basis p) (snd k)).

Lemma new_instance_is p k : instance_3 (new_instance p k) = new_cell p (instance_3 k).
Proof. destruct k as ((((a, b), c), d), t). unfold instance_3, new_instance, new_cell. cbn [fst snd rebased_3 moved_cell_3]. now rewrite !new_moved. Qed.

Lemma new_offset_back p t t' : combined_offset (new_basis p) t = combined_offset (new_basis p) t' -> t = t'.
Proof.
  destruct t as ((i, j), k), t' as ((a, b), c). unfold combined_offset, new_basis. cbn [m1 m2 m3]. intro E. injection E as E1 E2 E3.
  assert (i = a) by lia. subst a. assert (j = b) by lia. subst b. assert (k = c) by lia. now subst c.
Qed.

Lemma new_site_back p s s' : rebased_site_3 (new_basis p) s = rebased_site_3 (new_basis p) s' -> s = s'.
Proof.
  destruct s as (n, t), s' as (n', t'). unfold rebased_site_3. cbn [fst snd]. intro E. injection E as En Et. subst n'. apply f_equal.
  exact (new_offset_back p t t' Et).
Qed.

Lemma new_instance_back p k k' : new_instance p k = new_instance p k' -> k = k'.
Proof.
  destruct k as ((((a, b), c), d), t), k' as ((((a', b'), c'), d'), t'). unfold new_instance, new_cell. cbn [fst snd rebased_3]. intro E.
  apply pair_equal_spec in E. destruct E as [E Et]. apply pair_equal_spec in E. destruct E as [E Ed]. apply pair_equal_spec in E. destruct E as [E Ec].
  apply pair_equal_spec in E. destruct E as [Ea Eb]. apply new_site_back in Ea, Eb, Ec, Ed. apply new_offset_back in Et. now subst.
Qed.

Lemma new_weight p x L r y i : weight x (new_box p L) (new_cell p r) y i = weight x L r y i.
Proof.
  destruct r as (((a, b), c), d). unfold weight, space_crossings.bary, t0, new_cell. cbn [rebased_3].
  destruct i; cbn [space_crossings.side_of space_mesh.facet_height places]; now rewrite !new_spot.
Qed.

Definition new_facet (p : Z) (s : facet_3) : facet_3 :=
  let '(a, b, c) := s in (rebased_site_3 (new_basis p) a, rebased_site_3 (new_basis p) b, rebased_site_3 (new_basis p) c).

Lemma new_facets p T : flat_map facets_3 (map (new_cell p) T) = map (new_facet p) (flat_map facets_3 T).
Proof. induction T as [|(((a, b), c), d) T IH]; [reflexivity|]. cbn [map flat_map app]. rewrite IH, map_app. reflexivity. Qed.

Lemma new_glued p T : glued_torus_3 T -> glued_torus_3 (map (new_cell p) T).
Proof.
  intros (l & pairs & F & P). exists (map (new_facet p) l), (map (fun k => (new_facet p (fst k), combined_offset (new_basis p) (snd k))) pairs). split.
  - rewrite new_facets. clear P. induction F as [|s s' l l' H F IH]; constructor; [destruct H; constructor|exact IH].
  - replace (flat_map both_sides_3 (map _ pairs)) with (map (new_facet p) (flat_map both_sides_3 pairs)); [now apply Permutation_map|]. clear.
    induction pairs as [|(((a, b), c), t) pairs IH]; [reflexivity|]. cbn [map flat_map both_sides_3 app fst snd]. rewrite IH.
    cbn [new_facet both_sides_3]. now rewrite !new_moved.
Qed.

Theorem rebased_cells p x L T : glued_torus_3 T -> positive_torus_3 x L T ->
  glued_torus_3 (map (new_cell p) T) /\ positive_torus_3 x (new_box p L) (map (new_cell p) T) /\ covers_3 (map (new_cell p) T) = covers_3 T.
Proof.
  intros G P. split; [now apply new_glued|]. split.
  - intros c I. apply in_map_iff in I. destruct I as (c0 & <- & I). assert (Q := P c0 I). destruct c0 as (((a, b), c), d).
    unfold six_of, torus_volume, new_cell in *. cbn [rebased_3]. now rewrite !new_spot.
  - apply covers_in_basis_3. unfold new_basis, offset_det. cbn [m1 m2 m3]. ring.
Qed.

Lemma small_integer Q : small Q -> exists p, (0 < p)%Z /\ Q (/ IZR p).
Proof.
  intros (e & E & H). destruct (archimed (/ e)) as [U _]. assert (I := Rinv_0_lt_compat e E). exists (up (/ e)).
  assert (Pp : 0 < IZR (up (/ e))) by lra. split; [now apply lt_IZR|]. apply H. split; [now apply Rinv_0_lt_compat|].
  rewrite <- (Rinv_inv e) at 2. apply Rinv_lt_contravar; [now apply Rmult_lt_0_compat|exact U].
Qed.

Theorem along_nothing x L T : 0 < det_3 L -> positive_torus_3 x L T -> exists p, forall c s, In c (map (new_cell p) T) -> In s (facets_3 c) ->
  leans x (new_box p L) s.
Proof.
  intros D P. set (f := fun s : facet_3 => let '(a, b, c) := s in (site_at_3 x L b ⊖ site_at_3 x L a) ✕ (site_at_3 x L c ⊖ site_at_3 x L a)).
  assert (S : small (fun e => forall s, In s (flat_map facets_3 T) -> general_position.polynomial [f s · L3 L; f s · L2 L; f s · L1 L] e <> 0)).
  { apply small_all. intros s I. apply general_position.polynomial_nonzero. apply in_flat_map in I. destruct I as (c & Ic & Is). assert (V := P c Ic).
    assert (N : f s <> zero).
    { intro Z. destruct c as (((a, b), c), d). unfold six_of, torus_volume, six_volumes in V.
      destruct Is as [<-|[<-|[<-|[<-|[]]]]]; unfold f in Z; revert V Z; generalize (site_at_3 x L a) (site_at_3 x L b) (site_at_3 x L c)
      (site_at_3 x L d); intros A B C E V Z.
      - assert (K : vol (B ⊖ A) (C ⊖ A) (E ⊖ A) = ((E ⊖ B) ✕ (C ⊖ B)) · (A ⊖ B)) by vector. rewrite K, Z in V. unfold zero, dot in V.
        cbn [X1 X2 X3] in V. lra.
      - assert (K : vol (B ⊖ A) (C ⊖ A) (E ⊖ A) = ((C ⊖ A) ✕ (E ⊖ A)) · (B ⊖ A)) by vector. rewrite K, Z in V. unfold zero, dot in V.
        cbn [X1 X2 X3] in V. lra.
      - assert (K : vol (B ⊖ A) (C ⊖ A) (E ⊖ A) = ((E ⊖ A) ✕ (B ⊖ A)) · (C ⊖ A)) by vector. rewrite K, Z in V. unfold zero, dot in V.
        cbn [X1 X2 X3] in V. lra.
      - unfold vol in V. rewrite Z in V. unfold zero, dot in V. cbn [X1 X2 X3] in V. lra. }
    destruct (Req_EM_T (f s · L1 L) 0) as [Z1|Z1]; [|exists (f s · L1 L); simpl; tauto].
    destruct (Req_EM_T (f s · L2 L) 0) as [Z2|Z2]; [|exists (f s · L2 L); simpl; tauto].
    destruct (Req_EM_T (f s · L3 L) 0) as [Z3|Z3]; [|exists (f s · L3 L); simpl; tauto].
    exfalso. apply N. apply sq_zero. apply Rmult_eq_reg_r with (det_3 L); [|lra]. rewrite Rmult_0_l.
    transitivity ((f s · L1 L) * (f s · (L2 L ✕ L3 L)) + (f s · L2 L) * (f s · (L3 L ✕ L1 L)) + (f s · L3 L) * (f s · (L1 L ✕ L2 L)));
      [unfold det_3; generalize (f s) (L1 L) (L2 L) (L3 L); vector|]. rewrite Z1, Z2, Z3. ring. }
  destruct (small_integer _ S) as (p & Pp & H). exists p. intros c s Ic Is. apply in_map_iff in Ic. destruct Ic as (c0 & <- & I0).
  assert (J : exists s0, In s0 (facets_3 c0) /\ s = new_facet p s0).
  { destruct c0 as (((a, b), c'), d). unfold new_cell in Is. cbn [rebased_3 facets_3] in Is.
    destruct Is as [<-|[<-|[<-|[<-|[]]]]]; [exists (b, d, c')|exists (a, c', d)|exists (a, d, b)|exists (a, b, c')]; simpl; tauto. }
  destruct J as (s0 & J0 & ->). assert (K := H s0 ltac:(apply in_flat_map; now exists c0)). assert (Pr := IZR_lt _ _ Pp).
  destruct s0 as ((a, b), c). unfold leans, new_facet, lean. rewrite !new_spot. unfold new_box. cbn [L1]. intro Z. apply K.
  unfold f. cbn [general_position.polynomial]. apply Rmult_eq_reg_r with (IZR p * IZR p); [|apply Rmult_integral_contrapositive_currified; lra].
  rewrite Rmult_0_l. etransitivity; [|exact Z]. rewrite mult_IZR.
  generalize (site_at_3 x L a) (site_at_3 x L b) (site_at_3 x L c) (L1 L) (L2 L) (L3 L). intros.
  set (q := IZR p) in *. clearbody q. coordinates. field. lra.
Qed.
