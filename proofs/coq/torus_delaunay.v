(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Glued, positive and strictly locally Delaunay in a periodic box of the plane: docs/theory.md 8.3.

   - least_power       each point of the plane is in a translate of a cell, and the circle of that cell has the least power there of all translates of cells.
                       So the translates cover the plane; that they do so once is not said
   - torus_delaunay    where a vertex is in a cell only as a corner of it, as it is if the degree is 1, no vertex is inside the circle of a cell *)
Require Import Reals ZArith Lra Lia Psatz List Permutation.
From Annulus Require plane_mesh plane_delaunay.
From Annulus Require Import width_2 torus_2.
Import ListNotations.
Open Scope R_scope.

Section placed.
Variables (x : nat -> point_2) (L : box_2).
Hypothesis box_positive : 0 < det_2 L.

Definition spot (s : site_2) : point_2 := site_at x L s.
(* Positive for z outside of the circle of a, b, q. *)
Definition beyond (a b q z : point_2) : R := incircle (fst a) (snd a) (fst b) (snd b) (fst z) (snd z) (fst q) (snd q).
Definition rotations_2 (c : torus_cell_2) : list torus_cell_2 := let '(a, b, c) := c in [(a, b, c); (b, c, a); (c, a, b)].
Definition moved_cell_2 (t : offset_2) (c : torus_cell_2) : torus_cell_2 := let '(a, b, c) := c in (moved_2 t a, moved_2 t b, moved_2 t c).
Definition area_of (c : torus_cell_2) : R := torus_area x L c.
Definition power_of (z : point_2) (c : torus_cell_2) : R := let '(a, b, q) := c in beyond (spot a) (spot b) (spot q) z / area_of c.
Definition in_torus_cell (z : point_2) (c : torus_cell_2) : Prop := let '(a, b, q) := c in
  0 <= turning (spot a) (spot b) z /\ 0 <= turning (spot b) (spot q) z /\ 0 <= turning (spot q) (spot a) z.

Definition positive_torus_2 (T : list torus_cell_2) : Prop := forall c, In c T -> 0 < area_of c.
(* Cells on both sides of a b, the second one in its own frame, which is t away. *)
Definition strictly_delaunay_2 (T : list torus_cell_2) : Prop := forall c c' a b q p t, In c T -> In c' T ->
  In (a, b, q) (rotations_2 c) -> In (moved_2 t b, moved_2 t a, moved_2 t p) (rotations_2 c') -> 0 < beyond (spot a) (spot b) (spot q) (spot p).

(* ---- Frames ---- *)

Definition lattice_2 (t : offset_2) : point_2 := (IZR (fst t) * fst (fst L) + IZR (snd t) * fst (snd L), IZR (fst t) * snd (fst L) + IZR (snd t) * snd (snd L)).
Definition less_2 (z w : point_2) : point_2 := (fst z - fst w, snd z - snd w).

Lemma spot_moved t s : spot (moved_2 t s) = (fst (lattice_2 t) + fst (spot s), snd (lattice_2 t) + snd (spot s)).
Proof. destruct s as (v, (i, j)). unfold spot, lattice_2. simpl. rewrite !plus_IZR. f_equal; ring. Qed.

Lemma moved_twice t u s : moved_2 t (moved_2 u s) = moved_2 (fst t + fst u, snd t + snd u)%Z s.
Proof. destruct s as (v, (i, j)). simpl. f_equal. f_equal; ring. Qed.

Lemma moved_zero s : moved_2 (0, 0)%Z s = s.
Proof. destruct s as (v, (i, j)). reflexivity. Qed.

Lemma moved_back t s : moved_2 t (moved_2 (- fst t, - snd t)%Z s) = s.
Proof. rewrite moved_twice. simpl. replace (fst t + - fst t)%Z with 0%Z by ring. replace (snd t + - snd t)%Z with 0%Z by ring. apply moved_zero. Qed.

Lemma area_moved t c : area_of (moved_cell_2 t c) = area_of c.
Proof.
  destruct c as ((a, b), q). unfold area_of, torus_area, moved_cell_2. fold (spot (moved_2 t a)) (spot (moved_2 t b)) (spot (moved_2 t q)) (spot a) (spot b) (spot q).
  rewrite !spot_moved. unfold turning, turn. cbn [fst snd]. ring.
Qed.

Lemma power_moved t c z : power_of z (moved_cell_2 t c) = power_of (less_2 z (lattice_2 t)) c.
Proof.
  unfold power_of. destruct c as ((a, b), q). rewrite area_moved. cbn [moved_cell_2]. f_equal. rewrite !spot_moved.
  unfold beyond, incircle, turn, less_2. cbn [fst snd]. ring.
Qed.

Lemma rotated_area r c : In r (rotations_2 c) -> area_of r = area_of c.
Proof. destruct c as ((a, b), q). intros [<-|[<-|[<-|[]]]]; unfold area_of, torus_area, turning, turn; ring. Qed.

Lemma rotated_power r c z : In r (rotations_2 c) -> power_of z r = power_of z c.
Proof.
  intro I. assert (A := rotated_area r c I). unfold power_of. destruct c as ((a, b), q). destruct r as ((a', b'), q'). rewrite A. f_equal.
  destruct I as [[=<- <- <-]|[[=<- <- <-]|[[=<- <- <-]|[]]]]; unfold beyond, incircle, turn; ring.
Qed.

(* ---- Across a side ---- *)

Lemma side_of_rotation a b c : In (a, b) (sides_2 c) -> exists q, In (a, b, q) (rotations_2 c).
Proof. destruct c as ((u, v), w). intros [[=<- <-]|[[=<- <-]|[[=<- <-]|[]]]]; [exists w|exists u|exists v]; simpl; tauto. Qed.

Lemma other_side T a b q c : glued_torus_2 T -> In c T -> In (a, b, q) (rotations_2 c) ->
  exists c' p t, In c' T /\ In (moved_2 t b, moved_2 t a, moved_2 t p) (rotations_2 c').
Proof.
  intros (pairs & P) Ic Ir.
  assert (S : In (a, b) (flat_map sides_2 T)).
  { apply in_flat_map. exists c. split; [exact Ic|]. destruct c as ((u, v), w). destruct Ir as [[=<- <- <-]|[[=<- <- <-]|[[=<- <- <-]|[]]]]; simpl; tauto. }
  assert (O : forall side, In side (flat_map sides_2 T) -> exists c', In c' T /\ exists p, In (fst side, snd side, p) (rotations_2 c')).
  { intros (u, v) I. apply in_flat_map in I. destruct I as (c' & I & J). exists c'. split; [exact I|]. now apply side_of_rotation. }
  assert (S' := Permutation_in _ P S). apply in_flat_map in S'. destruct S' as (((u, v), t) & Ik & [[=-> ->]|[[=<- <-]|[]]]).
  - destruct (O (moved_2 t b, moved_2 t a)) as (c' & Ic' & p & Ip).
    { apply Permutation_in with (1 := Permutation_sym P). apply in_flat_map. exists ((a, b), t). simpl. tauto. }
    exists c', (moved_2 (- fst t, - snd t)%Z p), t. split; [exact Ic'|]. rewrite moved_back. exact Ip.
  - destruct (O (u, v)) as (c' & Ic' & p & Ip).
    { apply Permutation_in with (1 := Permutation_sym P). apply in_flat_map. exists ((u, v), t). simpl. tauto. }
    exists c', (moved_2 t p), (- fst t, - snd t)%Z. split; [exact Ic'|].
    assert (B : forall s, moved_2 (- fst t, - snd t)%Z (moved_2 t s) = s).
    { intro s. rewrite moved_twice. simpl. replace (- fst t + fst t)%Z with 0%Z by ring. replace (- snd t + snd t)%Z with 0%Z by ring. apply moved_zero. }
    rewrite !B. exact Ip.
Qed.

(* The difference of the powers of two circles through a and b. *)
Lemma power_across a b q p z : turning b a p * beyond a b q z - turning a b q * beyond b a p z = beyond a b q p * turning b a z.
Proof. unfold turning, beyond, incircle, turn. ring. Qed.

Lemma power_falls a b q p z : 0 < area_of (a, b, q) -> 0 < area_of (b, a, p) -> 0 < beyond (spot a) (spot b) (spot q) (spot p) ->
  turning (spot a) (spot b) z < 0 -> power_of z (b, a, p) < power_of z (a, b, q).
Proof.
  intros A A' B N. unfold power_of. assert (E := power_across (spot a) (spot b) (spot q) (spot p) z).
  change (turning (spot a) (spot b) (spot q)) with (area_of (a, b, q)) in E. change (turning (spot b) (spot a) (spot p)) with (area_of (b, a, p)) in E.
  assert (F : 0 < beyond (spot a) (spot b) (spot q) (spot p) * turning (spot b) (spot a) z).
  { apply Rmult_lt_0_compat; [exact B|]. replace (turning (spot b) (spot a) z) with (- turning (spot a) (spot b) z) by (unfold turning, turn; ring). lra. }
  apply Rmult_lt_reg_r with (area_of (a, b, q) * area_of (b, a, p)); [now apply Rmult_lt_0_compat|].
  replace (beyond (spot b) (spot a) (spot p) z / area_of (b, a, p) * (area_of (a, b, q) * area_of (b, a, p))) with (area_of (a, b, q) * beyond (spot b) (spot a) (spot p) z) by (field; lra).
  replace (beyond (spot a) (spot b) (spot q) z / area_of (a, b, q) * (area_of (a, b, q) * area_of (b, a, p))) with (area_of (b, a, p) * beyond (spot a) (spot b) (spot q) z) by (field; lra).
  lra.
Qed.

(* ---- Finitely many translates have a small power at a point ---- *)

Lemma power_is c : 0 < area_of c -> exists o rho, forall z, power_of z c = d2 (fst z) (snd z) (fst o) (snd o) - rho.
Proof.
  destruct c as ((a, b), q). intro P. unfold area_of, torus_area in P. fold (spot a) (spot b) (spot q) in P.
  destruct (plane_delaunay.circle_of (fun v => match v with 0%nat => spot a | 1%nat => spot b | _ => spot q end) 0 1 2 P) as (o & rho & A & B & Q).
  exists o, rho. intro z. unfold power_of. apply Rmult_eq_reg_l with (area_of (a, b, q)); [|unfold area_of, torus_area; fold (spot a) (spot b) (spot q); lra].
  transitivity (beyond (spot a) (spot b) (spot q) z); [field; unfold area_of, torus_area; fold (spot a) (spot b) (spot q); lra|].
  unfold beyond. rewrite <- (powers _ _ _ _ _ _ _ _ (fst o) (snd o) rho). unfold plane_mesh.dist2 in A, B, Q. rewrite A, B, Q.
  unfold area_of, torus_area. fold (spot a) (spot b) (spot q). unfold turning. ring.
Qed.

Lemma square_bound s k : s * s < k -> Rabs s <= 1 + Rabs k.
Proof. intro H. assert (K := Rle_abs k). unfold Rabs at 1. destruct (Rcase_abs s); nra. Qed.

Lemma product_bound a b m : Rabs a <= m -> Rabs (a * b) <= m * Rabs b.
Proof. intro H. rewrite Rabs_mult. apply Rmult_le_compat_r; [apply Rabs_pos|exact H]. Qed.

Lemma integer_bound i b : Rabs (IZR i) <= b -> (Z.abs i <= up b)%Z.
Proof.
  intro H. rewrite <- abs_IZR in H. apply le_IZR. destruct (archimed b) as [U _]. lra.
Qed.

Lemma few_translates c z k : 0 < area_of c -> exists n, forall u, power_of z (moved_cell_2 u c) < k -> (Z.abs (fst u) <= n /\ Z.abs (snd u) <= n)%Z.
Proof.
  intro P. destruct (power_is c P) as (o & rho & E). assert (Positive := box_positive). unfold det_2 in Positive.
  set (a := fst (fst L)) in *. set (b := snd (fst L)) in *. set (e := fst (snd L)) in *. set (f := snd (snd L)) in *.
  set (D := a * f - b * e) in Positive.
  set (m := 1 + Rabs (k + rho) + Rabs (fst z - fst o)). set (m' := 1 + Rabs (k + rho) + Rabs (snd z - snd o)).
  set (n := up ((m * Rabs f + m' * Rabs e) / D)). set (n' := up ((m * Rabs b + m' * Rabs a) / D)).
  exists (Z.max n n'). intros (i, j) H. rewrite power_moved, E in H. unfold d2, less_2, lattice_2 in H. cbn [fst snd] in H. fold a b e f in H. cbn [fst snd].
  remember (IZR i * a + IZR j * e) as s eqn:Is. remember (IZR i * b + IZR j * f) as t eqn:It.
  assert (S : Rabs s <= m).
  { assert (Near : Rabs (fst z - s - fst o) <= 1 + Rabs (k + rho)) by (apply square_bound; generalize (Rle_0_sqr (snd z - t - snd o)); unfold Rsqr; intro; lra).
    replace s with ((fst z - fst o) - (fst z - s - fst o)) by ring. eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp. unfold m. lra. }
  assert (S' : Rabs t <= m').
  { assert (Near : Rabs (snd z - t - snd o) <= 1 + Rabs (k + rho)) by (apply square_bound; generalize (Rle_0_sqr (fst z - s - fst o)); unfold Rsqr; intro; lra).
    replace t with ((snd z - snd o) - (snd z - t - snd o)) by ring. eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp. unfold m'. lra. }
  assert (Over : forall y w, Rabs (y * D) <= w -> Rabs y <= w / D).
  { intros y w W. rewrite Rabs_mult, (Rabs_pos_eq D) in W by lra. apply Rmult_le_reg_r with D; [exact Positive|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra. }
  assert (I : (Z.abs i <= n)%Z).
  { apply integer_bound, Over. replace (IZR i * D) with (s * f - t * e) by (rewrite Is, It; unfold D; ring).
    eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp. apply Rplus_le_compat; now apply product_bound. }
  assert (J : (Z.abs j <= n')%Z).
  { apply integer_bound, Over. replace (IZR j * D) with (- (s * b) + t * a) by (rewrite Is, It; unfold D; ring).
    eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp. apply Rplus_le_compat; now apply product_bound. }
  lia.
Qed.

Lemma few_cells T z k : positive_torus_2 T ->
  exists n, forall c u, In c T -> power_of z (moved_cell_2 u c) < k -> (Z.abs (fst u) <= n /\ Z.abs (snd u) <= n)%Z.
Proof.
  induction T as [|c T IH]; intro P; [now exists 0%Z|].
  destruct IH as (n & H); [intros c' I; apply P; now right|]. destruct (few_translates c z k (P c (or_introl eq_refl))) as (n' & H').
  exists (Z.max n n'). intros c' u [<-|I] Q; [generalize (H' u Q)|generalize (H c' u I Q)]; lia.
Qed.

Definition up_to (n : Z) : list Z := map (fun k => (Z.of_nat k - n)%Z) (seq 0 (Z.to_nat (2 * n + 1))).
Lemma in_up_to n i : (Z.abs i <= n)%Z -> In i (up_to n).
Proof. intro H. unfold up_to. apply in_map_iff. exists (Z.to_nat (i + n)). split; [lia|]. apply in_seq. lia. Qed.

Lemma least {I} (f : I -> R) l i : In i l -> exists j, In j l /\ forall k, In k l -> f j <= f k.
Proof.
  revert i. induction l as [|j l IH]; intros i H; [destruct H|]. destruct l as [|j' l].
  - exists j. split; [now left|]. intros k [<-|[]]. lra.
  - destruct (IH j' (or_introl eq_refl)) as (n & In' & M). destruct (Rle_dec (f j) (f n)) as [E|E].
    + exists j. split; [now left|]. intros k [<-|K]; [lra|]. generalize (M k K). lra.
    + exists n. split; [now right|]. intros k [<-|K]; [lra|]. now apply M.
Qed.

Lemma least_translate T z c0 : positive_torus_2 T -> In c0 T ->
  exists c u, In c T /\ forall c' u', In c' T -> power_of z (moved_cell_2 u c) <= power_of z (moved_cell_2 u' c').
Proof.
  intros P I0. set (f := fun k : torus_cell_2 * offset_2 => power_of z (moved_cell_2 (snd k) (fst k))).
  destruct (few_cells T z (f (c0, (0, 0)%Z) + 1) P) as (n & N).
  set (l := list_prod T (list_prod (up_to n) (up_to n))).
  assert (Small : forall k, In (fst k) T -> f k < f (c0, (0, 0)%Z) + 1 -> In k l).
  { intros (c, (i, j)) I H. destruct (N c (i, j) I H). apply in_prod; [exact I|]. apply in_prod; now apply in_up_to. }
  assert (I : In (c0, (0, 0)%Z) l) by (apply Small; [exact I0|lra]).
  destruct (least f l _ I) as ((c, u) & Il & M). exists c, u. split; [now apply in_prod_iff in Il|].
  intros c' u' I'. change (f (c, u) <= f (c', u')). destruct (Rlt_dec (f (c', u')) (f (c0, (0, 0)%Z) + 1)) as [S|S].
  - apply M. now apply Small.
  - generalize (M _ I). lra.
Qed.

(* ---- Every point is in a cell whose circle has the least power there ---- *)

Lemma across T c u a b q z : glued_torus_2 T -> positive_torus_2 T -> strictly_delaunay_2 T -> In c T -> In (a, b, q) (rotations_2 c) ->
  turning (spot a) (spot b) (less_2 z (lattice_2 u)) < 0 -> exists c' u', In c' T /\ power_of z (moved_cell_2 u' c') < power_of z (moved_cell_2 u c).
Proof.
  intros G P S Ic Ir N. destruct (other_side T a b q c G Ic Ir) as (c' & p & t & Ic' & Ip).
  assert (B := S c c' a b q p t Ic Ic' Ir Ip).
  assert (A : 0 < area_of (a, b, q)) by (rewrite (rotated_area _ c Ir); now apply P).
  assert (A' : 0 < area_of (b, a, p)).
  { rewrite <- (area_moved t). cbn [moved_cell_2]. rewrite (rotated_area _ c' Ip). now apply P. }
  assert (F := power_falls a b q p _ A A' B N).
  exists c', (fst u - fst t, snd u - snd t)%Z. split; [exact Ic'|].
  rewrite !power_moved, <- (rotated_power _ c _ Ir), <- (rotated_power _ c' _ Ip).
  change (moved_2 t b, moved_2 t a, moved_2 t p) with (moved_cell_2 t (b, a, p)). rewrite power_moved.
  replace (less_2 (less_2 z (lattice_2 (fst u - fst t, snd u - snd t)%Z)) (lattice_2 t)) with (less_2 z (lattice_2 u)); [exact F|].
  unfold less_2, lattice_2. cbn [fst snd]. rewrite !minus_IZR. f_equal; ring.
Qed.

Theorem least_power T z c0 : glued_torus_2 T -> positive_torus_2 T -> strictly_delaunay_2 T -> In c0 T ->
  exists c u, In c T /\ in_torus_cell z (moved_cell_2 u c) /\ forall c' u', In c' T -> power_of z (moved_cell_2 u c) <= power_of z (moved_cell_2 u' c').
Proof.
  intros G P S I0. destruct (least_translate T z c0 P I0) as (c & u & Ic & M). exists c, u. split; [exact Ic|]. split; [|exact M].
  assert (Right : forall a b q, In (a, b, q) (rotations_2 c) -> 0 <= turning (spot (moved_2 u a)) (spot (moved_2 u b)) z).
  { intros a b q Ir. destruct (Rle_dec 0 (turning (spot (moved_2 u a)) (spot (moved_2 u b)) z)) as [E|E]; [exact E|exfalso].
    destruct (across T c u a b q z G P S Ic Ir) as (c' & u' & Ic' & F); [|generalize (M c' u' Ic'); lra].
    apply Rnot_le_lt in E. rewrite !spot_moved in E. unfold turning, turn, less_2 in *. cbn [fst snd] in *. lra. }
  destruct c as ((a, b), q). cbn [moved_cell_2 in_torus_cell]. repeat split; eapply Right; simpl; eauto.
Qed.

Definition corner_of_torus (s : site_2) (c : torus_cell_2) : Prop := let '(a, b, q) := c in s = a \/ s = b \/ s = q.

Lemma power_at_corner s c : corner_of_torus s c -> power_of (spot s) c = 0.
Proof.
  destruct c as ((a, b), q). unfold power_of. intro H. replace (beyond (spot a) (spot b) (spot q) (spot s)) with 0; [unfold Rdiv; ring|].
  destruct H as [->|[->| ->]]; unfold beyond, incircle, turn; ring.
Qed.

Theorem torus_delaunay T : glued_torus_2 T -> positive_torus_2 T -> strictly_delaunay_2 T ->
  forall vertex : nat -> Prop, (forall c s, In c T -> vertex (fst s) -> in_torus_cell (spot s) c -> corner_of_torus s c) ->
  forall c, In c T -> exists o r2, (forall s, corner_of_torus s c -> d2 (fst (spot s)) (snd (spot s)) (fst o) (snd o) = r2) /\
    forall s, vertex (fst s) -> r2 <= d2 (fst (spot s)) (snd (spot s)) (fst o) (snd o).
Proof.
  intros G P S vertex Alone c Ic. destruct (power_is c (P c Ic)) as (o & r2 & E). exists o, r2. split.
  - intros s C. generalize (E (spot s)). rewrite (power_at_corner s c C). lra.
  - intros s V. destruct (least_power T (spot s) c G P S Ic) as (c' & u & Ic' & I & M).
    assert (Z : power_of (spot s) (moved_cell_2 u c') = 0).
    { rewrite power_moved. assert (B : less_2 (spot s) (lattice_2 u) = spot (moved_2 (- fst u, - snd u)%Z s)).
      { rewrite spot_moved. unfold less_2, lattice_2. cbn [fst snd]. rewrite !opp_IZR. f_equal; ring. }
      rewrite B. apply power_at_corner. apply Alone; [exact Ic'|now destruct s as (v, (i, j))|]. rewrite <- B.
      destruct c' as ((a, b), q). cbn [moved_cell_2 in_torus_cell] in *. rewrite !spot_moved in I. unfold turning, turn, less_2 in *. cbn [fst snd] in *. lra. }
    generalize (M c (0, 0)%Z Ic) (E (spot s)). rewrite Z, power_moved.
    replace (less_2 (spot s) (lattice_2 (0, 0)%Z)) with (spot s); [lra|]. unfold less_2, lattice_2. cbn [fst snd]. destruct (spot s). cbn [fst snd]. f_equal; ring.
Qed.
End placed.
