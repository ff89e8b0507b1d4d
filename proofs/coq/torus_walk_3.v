(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* A cell with the least power at a point, in a periodic box of space: docs/theory.md 8.3.

   - least_power_3   glued, positive, locally Delaunay, ties or not: each point of space is in a translate of a cell, and the sphere of that cell has the
                     least power there of all translates of cells. So the translates cover space, whatever the degree is

   A straight way from inside of a cell to the point leaves the cell through one facet, if it begins in general position, and the power of the point to
   the sphere of the next cell is not larger. Cells with the same power are finitely many, and each is left later than the one before. *)
Require Import Reals ZArith Lra Lia Psatz List Permutation.
From Annulus Require Import tetrahedron small torus_3 general_position.
From Annulus Require space_mesh space_crossings space_embedding space_line torus_powers.
From Annulus Require Import torus_powers_3.
Import ListNotations.
Open Scope R_scope.

Section placed.
Variables (x : nat -> vec) (L : box_3).
Hypothesis box_positive : 0 < det_3 L.
Notation six_of := (six_of x L).
Notation weight := (weight x L).
Notation power_3 := (power_3 x L).
Notation places := (places x L).
Notation in_torus_cell_3 := (in_torus_cell_3 x L).
Notation inside_torus_cell_3 := (inside_torus_cell_3 x L).

(* ---- Points inside of a cell ---- *)

Definition middle_3 (r : torus_cell_3) : vec := space_embedding.centre_3 (places r) t0.

Lemma middle_inside_3 r : 0 < six_of r -> inside_torus_cell_3 (middle_3 r) r.
Proof.
  rewrite <- (size_is x L). intros P i. apply (space_embedding.centre_inside (space_mesh.Mesh_3 [t0] [] []) (places r)); [|simpl; tauto].
  intros a b c d [[=<- <- <- <-]|[]]. exact P.
Qed.

Lemma near_inside_torus z g r : (forall i, 0 < weight r z i \/ (weight r z i = 0 /\ 0 < weight r g i)) ->
  small (fun e => inside_torus_cell_3 (curve z g e) r).
Proof. apply (space_embedding.near_inside_3 (places r) z g t0). Qed.

Lemma general_near z g y r : 0 < six_of r -> small (fun e => in_general_position x L (curve z g e) y r).
Proof.
  intro P. apply (small_impl (fun e => forall i, In i space_line.corner_list -> forall j, In j space_line.corner_list -> i <> j -> weight r y i < 0 ->
    weight r (curve z g e) i * weight r y j - weight r y i * weight r (curve z g e) j <> 0)).
  - intros e _ H i j. apply H; apply space_line.in_corners.
  - apply small_all. intros i _. apply small_all. intros j _. destruct (space_line.corner_dec i j) as [->|D]; [exists 1; split; [lra|tauto]|].
    destruct (Rlt_dec (weight r y i) 0) as [N|N]; [|exists 1; split; [lra|tauto]].
    apply (small_impl (fun e => weight r y j * weight r (curve z g e) i + - weight r y i * weight r (curve z g e) j <> 0)); [intros e _ H _ _; lra|].
    apply (near_nonzero (fun p => weight r y j * weight r p i + - weight r y i * weight r p j)); [apply affine_sum; apply space_crossings.bary_affine|].
    exists (places r (space_crossings.point_of t0 j)). unfold torus_powers_3.weight in *. rewrite !space_crossings.bary_corner, size_is.
    destruct (space_line.corner_dec i j) as [|_]; [contradiction|]. destruct (space_line.corner_dec j j) as [_|C]; [|now elim C].
    rewrite Rmult_0_r, Rplus_0_l. apply Rmult_integral_contrapositive_currified; lra.
Qed.

(* ---- One step ---- *)

Section walk.
Variables (T : list torus_cell_3) (y p : vec) (m : R) (l : list torus_cell_3).
Hypothesis gluing : glued_torus_3 T.
Hypothesis cells_positive : positive_torus_3 x L T.
Hypothesis local : locally_delaunay_torus_3 x L T.
Hypothesis lowest : forall k, In (fst k) T -> m <= power_3 y (instance_3 k).
Hypothesis listed : forall k r, In (fst k) T -> In r (views_3 (instance_3 k)) -> power_3 y r = m -> In r l.
Hypothesis general : forall r, In r l -> in_general_position x L p y r.

Definition met (r : torus_cell_3) : Prop :=
  (exists k, In (fst k) T /\ In r (views_3 (instance_3 k))) /\ power_3 y r = m /\ exists s, 0 <= s <= 1 /\ inside_torus_cell_3 (way p y s) r.
Definition arrived : Prop := exists k, In (fst k) T /\ in_torus_cell_3 y (instance_3 k) /\ power_3 y (instance_3 k) = m.

Lemma some_negative r : in_torus_cell_3 y r \/ exists i, weight r y i < 0.
Proof.
  destruct (Rlt_dec (weight r y o) 0); [right; now exists o|]. destruct (Rlt_dec (weight r y u) 0); [right; now exists u|].
  destruct (Rlt_dec (weight r y v) 0); [right; now exists v|]. destruct (Rlt_dec (weight r y w) 0); [right; now exists w|].
  left. intros []; lra.
Qed.

Lemma step_on r : met r -> arrived \/ exists r', met r' /\ leaves x L p y r < leaves x L p y r'.
Proof.
  intros ((k & I & V) & E & s & S & H). assert (P := view_positive x L T k r cells_positive I V).
  assert (Pk : 0 < six_of (instance_3 k)) by (unfold instance_3; rewrite six_moved; now apply cells_positive).
  destruct (some_negative r) as [A|(j0 & N0)].
  { left. exists k. split; [exact I|]. split; [|now rewrite <- (power_of_view x L r _ y V)]. intro i.
    destruct (weight_of_view x L _ _ (view_back r _ V) i) as (j & Ej). rewrite Ej. apply A. }
  destruct (torus_powers.least (passed x L p y r) space_line.corner_list o (space_line.in_corners o)) as (i & _ & M).
  assert (M' : forall j, passed x L p y r i <= passed x L p y r j) by (intro j; apply M, space_line.in_corners). clear M.
  assert (N : weight r y i < 0).
  { destruct (passed_after x L p y r s j0 S (H j0)) as [_ K]. destruct (K N0) as [_ [_ Hi]]. generalize (M' j0). intro Le.
    unfold passed in Le at 1. destruct (Rlt_dec (weight r y i) 0); [assumption|lra]. }
  assert (First := leaves_first x L p y r i M').
  (* the view with that facet first *)
  assert (Vv := view_at_in r i _ V). assert (W := weight_of_view x L _ _ (view_at_in r i r (own_view r))). assert (Wf := fun z => weight_first x L r z i).
  assert (Hv : inside_torus_cell_3 (way p y s) (view_at r i)) by (intro j; destruct (W j) as (h & Eh); rewrite Eh; apply H).
  assert (Pass : passed x L p y (view_at r i) w = passed x L p y r i) by (unfold passed; now rewrite !Wf).
  assert (Mv : forall j, passed x L p y (view_at r i) w <= passed x L p y (view_at r i) j).
  { intro j. destruct (W j) as (h & Eh). rewrite Pass. unfold passed at 2. rewrite !Eh. apply M'. }
  assert (Nv : weight (view_at r i) y w < 0) by now rewrite Wf.
  assert (Ev : power_3 y (view_at r i) = m) by now rewrite (power_of_view x L _ _ y Vv Pk), <- (power_of_view x L r _ y V Pk).
  rewrite <- Pass in First. clear Pass M' N N0 H E W Wf. destruct (view_at r i) as (((a, b), c), q). clear V P j0 i.
  destruct (neighbour_3 T k a b c q gluing I Vv) as (k' & n & I' & V').
  assert (P := view_positive x L T k _ cells_positive I Vv). assert (P' := view_positive x L T k' _ cells_positive I' V').
  assert (Pk' : 0 < six_of (instance_3 k')) by (unfold instance_3; rewrite six_moved; now apply cells_positive).
  assert (B := certified_3 x L (Rle 0) T k k' a b c q n local I I' Vv V'). assert (A := power_across_3 x L a b c q n y P P').
  assert (Low : m <= power_3 y (b, a, c, n)) by (rewrite (power_of_view x L _ _ y V' Pk'); now apply lowest).
  assert (Same : power_3 y (b, a, c, n) = m).
  { assert (D : six_of (a, b, c, q) * six_of (b, a, c, n) * (power_3 y (b, a, c, n) - m) <= 0).
    { rewrite <- Ev at 1. rewrite A. assert (0 <= - weight (a, b, c, q) y w * beyond_sphere (site_at_3 x L a) (site_at_3 x L b) (site_at_3 x L c)
      (site_at_3 x L q) (site_at_3 x L n));
      [apply Rmult_le_pos; lra|lra]. }
    assert (0 < six_of (a, b, c, q) * six_of (b, a, c, n)) by now apply Rmult_lt_0_compat. nra. }
  right. exists (b, a, c, n). set (t := passed x L p y (a, b, c, q) w) in *.
  destruct (passed_after x L p y (a, b, c, q) s w S (Hv w)) as [_ K]. destruct (K Nv) as [Pw [Lo Hi]]. fold t in Lo, Hi. clear K.
  assert (Later : forall j, w <> j -> 0 < weight (a, b, c, q) (way p y t) j).
  { intros j D. apply (others_later x L p y (a, b, c, q) s w j); trivial. apply general. now apply (listed k). }
  assert (Zero := weight_there x L p y (a, b, c, q) w Pw Nv). fold t in Zero.
  destruct (across_facet x L a b c q n (way p y t) P Zero) as (Ao & Au & Av).
  assert (Next : forall j, w <> j -> 0 < weight (b, a, c, n) (way p y t) j).
  { assert (R : forall h j, 0 < weight (a, b, c, q) (way p y t) h ->
      six_of (a, b, c, q) * weight (b, a, c, n) (way p y t) j = weight (a, b, c, q) (way p y t) h * six_of (b, a, c, n) -> 0 < weight (b, a, c, n)
      (way p y t) j).
    { intros h j Ph Eh. apply Rmult_lt_reg_l with (six_of (a, b, c, q)); [exact P|]. rewrite Rmult_0_r, Eh. now apply Rmult_lt_0_compat. }
    intros j D. destruct j; [apply (R u o)|apply (R o u)|apply (R v v)|now elim D]; trivial; apply Later; discriminate. }
  assert (On : forall e, way p y ((1 - e) * t + e) = way (way p y t) y e) by (intro e; unfold way; generalize p y; vector).
  assert (Sm : small (fun e => (forall j, In j space_line.corner_list -> w <> j -> 0 < (1 - e) * weight (b, a, c, n) (way p y t) j +
  e * weight (b, a, c, n) y j) /\ e < 1)).
  { apply small_and; [|apply small_below; lra]. apply small_all. intros j _.
    destruct (space_line.corner_dec w j) as [D|D]; [exists 1; split; [lra|tauto]|].
    apply (small_impl (fun e => 0 < (1 - e) * weight (b, a, c, n) (way p y t) j + e * weight (b, a, c, n) y j)); [tauto|]. apply small_positive.
    now apply Next. }
  destruct (small_exists _ Sm) as (e & Pe & Pos & Le). set (s' := (1 - e) * t + e).
  assert (S' : t < s' /\ 0 <= s' <= 1) by (unfold s'; split; [nra|split; nra]).
  assert (In' : inside_torus_cell_3 (way p y s') (b, a, c, n)).
  { intro j. unfold s'. rewrite On, (weight_on_way x L).
    destruct (space_line.corner_dec w j) as [<-|D]; [|apply Pos; [apply space_line.in_corners|exact D]].
    rewrite !(weight_back x L a b c q n), Zero. assert (0 < e * - weight (a, b, c, q) y w) by (apply Rmult_lt_0_compat; lra). lra. }
  split.
  - split; [now exists k'|]. split; [exact Same|]. exists s'. split; [apply S'|exact In'].
  - rewrite First. apply Rlt_le_trans with s'; [apply S'|]. unfold leaves.
    assert (Ps : forall j, s' <= passed x L p y (b, a, c, n) j) by (intro j; exact (proj1 (passed_after x L p y (b, a, c, n) s' j (proj2 S') (In' j)))).
    repeat apply Rmin_glb; apply Ps.
Qed.

Lemma walk r : met r -> arrived.
Proof.
  intro M. assert (In_l : forall r, met r -> In r l) by (intros r' ((k & I & V) & E & _); now apply (listed k)).
  apply (descend_3 (fun r => - leaves x L p y r) met l arrived) with r; [|now apply In_l|exact M].
  intros r' _ M'. destruct (step_on r' M') as [A|(r'' & M'' & F)]; [now left|right]. exists r''. split; [now apply In_l|]. split; [exact M''|lra].
Qed.
End walk.

Theorem least_power_3 T y c0 : glued_torus_3 T -> positive_torus_3 x L T -> locally_delaunay_torus_3 x L T -> In c0 T ->
  exists k, In (fst k) T /\ in_torus_cell_3 y (instance_3 k) /\ forall j, In (fst j) T -> power_3 y (instance_3 k) <= power_3 y (instance_3 j).
Proof.
  intros G P D I0. destruct (least_translate_3 x L box_positive T y c0 P I0) as (i & Ii & M). set (m := power_3 y (instance_3 i)) in *.
  destruct (finitely_many_3 x L box_positive T y (m + 1) P) as (l & Back & All). set (views := flat_map (fun k => views_3 (instance_3 k)) l).
  assert (Pi : 0 < six_of (instance_3 i)) by (unfold instance_3; rewrite six_moved; now apply P).
  assert (Ci := middle_inside_3 _ Pi). set (g := middle_3 (instance_3 i)) in *.
  assert (S : small (fun e => inside_torus_cell_3 (curve g g e) (instance_3 i) /\ forall r, In r views -> in_general_position x L (curve g g e) y r)).
  { apply small_and; [apply near_inside_torus; intro j; left; apply Ci|]. apply small_all. intros r R. apply general_near.
    apply in_flat_map in R. destruct R as (k & Ik & V). apply (view_positive x L T k r P); [now apply Back|exact V]. }
  destruct (small_exists _ S) as (e & _ & H & Gen). set (p := curve g g e) in *.
  assert (Listed : forall k r, In (fst k) T -> In r (views_3 (instance_3 k)) -> power_3 y r = m -> In r views).
  { intros k r Ik V E. apply in_flat_map. exists k. split; [|exact V]. apply All; [exact Ik|]. rewrite <- (power_of_view x L r _ y V); [lra|].
    unfold instance_3. rewrite six_moved. now apply P. }
  destruct (walk T y p m views G P D M Listed Gen (instance_3 i)) as (k & Ik & A & E).
  - split; [exists i; split; [exact Ii|apply own_view]|]. split; [reflexivity|]. exists 0. split; [lra|]. intro j. rewrite (weight_on_way x L).
    generalize (H j). lra.
  - exists k. split; [exact Ik|]. split; [exact A|]. intros j Ij. rewrite E. now apply M.
Qed.
End placed.
