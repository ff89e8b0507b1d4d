(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The powers of a point to the circles of all translates of cells in a periodic box of the plane: docs/theory.md 8.3.

   - least_power   glued, positive, locally Delaunay, ties or not: each point of the plane is in a translate of a cell, and the circle of that cell has the
                   least power there of all translates of cells. So the translates cover the plane, whatever the degree is

   The point is beyond a side of a cell that does not have it, and the power to the circle beyond is not larger.
   It is smaller, or both circles are the same;
   then the angle opposite to the side that is crossed gets smaller and smaller. *)
Require Import Reals ZArith Lra Lia Psatz List Permutation.
From Annulus Require plane_mesh plane_delaunay.
From Annulus Require Import width_2 torus_2.
From Annulus Require Export torus_frames.
Import ListNotations.
Open Scope R_scope.

Section placed.
Variables (x : nat -> point_2) (L : box_2).
Hypothesis box_positive : 0 < det_2 L.
Notation spot := (spot x L).
Notation area_of := (area_of x L).
Notation in_torus_cell := (in_torus_cell x L).
Notation positive_torus_2 := (positive_torus_2 x L).
Notation locally_delaunay_2 := (locally_delaunay_2 x L).
Notation lattice_2 := (lattice_2 L).
Notation spot_moved := (spot_moved x L).
Notation area_moved := (area_moved x L).
Notation rotated_area := (rotated_area x L).
Notation instance_positive := (instance_positive x L).
Notation in_rotated := (in_rotated x L).
Notation certified := (certified x L).

Definition power_of (z : point_2) (c : torus_cell_2) : R := let '(a, b, q) := c in beyond (spot a) (spot b) (spot q) z / area_of c.

Lemma power_moved t c z : power_of z (moved_cell_2 t c) = power_of (less_2 z (lattice_2 t)) c.
Proof.
  unfold power_of. destruct c as ((a, b), q). rewrite area_moved. cbn [moved_cell_2]. f_equal. rewrite !spot_moved.
  unfold beyond, incircle, turn, less_2. cbn [fst snd]. ring.
Qed.

Lemma rotated_power r c z : In r (rotations_2 c) -> power_of z r = power_of z c.
Proof.
  intro I. assert (A := rotated_area r c I). unfold power_of. destruct c as ((a, b), q). destruct r as ((a', b'), q'). rewrite A. f_equal.
  destruct I as [[=<- <- <-]|[[=<- <- <-]|[[=<- <- <-]|[]]]]; unfold beyond, incircle, turn; ring.
Qed.

Lemma power_at_corner s c : corner_of_torus s c -> power_of (spot s) c = 0.
Proof.
  destruct c as ((a, b), q). unfold power_of. intro H. replace (beyond (spot a) (spot b) (spot q) (spot s)) with 0; [unfold Rdiv; ring|].
  destruct H as [->|[->| ->]]; unfold beyond, incircle, turn; ring.
Qed.

(* The difference of the powers of two circles through a and b. *)
Lemma power_across a b q p z : turning b a p * beyond a b q z - turning a b q * beyond b a p z = beyond a b q p * turning b a z.
Proof. unfold turning, beyond, incircle, turn. ring. Qed.

Lemma power_differs a b q p z : 0 < area_of (a, b, q) -> 0 < area_of (b, a, p) -> power_of z (a, b, q) - power_of z (b, a, p)
  = beyond (spot a) (spot b) (spot q) (spot p) * (turning (spot b) (spot a) z / (area_of (a, b, q) * area_of (b, a, p))).
Proof.
  intros A A'. unfold power_of. assert (E := power_across (spot a) (spot b) (spot q) (spot p) z).
  change (turning (spot a) (spot b) (spot q)) with (area_of (a, b, q)) in E. change (turning (spot b) (spot a) (spot p)) with (area_of (b, a, p)) in E.
  apply Rmult_eq_reg_r with (area_of (a, b, q) * area_of (b, a, p)); [|apply Rmult_integral_contrapositive_currified; lra].
  field_simplify; [|lra|lra]. lra.
Qed.

Lemma ratio_across a b q p z : 0 < area_of (a, b, q) -> 0 < area_of (b, a, p) -> turning (spot a) (spot b) z < 0 ->
  0 < turning (spot b) (spot a) z / (area_of (a, b, q) * area_of (b, a, p)).
Proof.
  intros A A' N. apply Rdiv_lt_0_compat; [|now apply Rmult_lt_0_compat].
  replace (turning (spot b) (spot a) z) with (- turning (spot a) (spot b) z) by (unfold turning, turn; ring). lra.
Qed.

(* ---- Finitely many translates have a small power at a point ---- *)

Lemma power_is c : 0 < area_of c -> exists o rho, forall z, power_of z c = d2 (fst z) (snd z) (fst o) (snd o) - rho.
Proof.
  destruct c as ((a, b), q). intro P. unfold area_of, torus_area in P. fold (spot a) (spot b) (spot q) in P.
  destruct (plane_delaunay.circle_of (fun v => match v with 0%nat => spot a | 1%nat => spot b | _ => spot q end) 0 1 2 P) as (o & rho & A & B & Q).
  exists o, rho. intro z. unfold power_of. apply Rmult_eq_reg_l with (area_of (a, b, q)); [|unfold area_of, torus_area;
  fold (spot a) (spot b) (spot q); lra].
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
  exists (Z.max n n'). intros (i, j) H. rewrite power_moved, E in H. unfold d2, less_2, lattice_2 in H. cbn [fst snd] in H. fold a b e f in H.
  cbn [fst snd].
  remember (IZR i * a + IZR j * e) as s eqn:Is. remember (IZR i * b + IZR j * f) as t eqn:It.
  assert (S : Rabs s <= m).
  { assert (Near : Rabs (fst z - s - fst o) <= 1 + Rabs (k + rho)) by (apply square_bound; generalize (Rle_0_sqr (snd z - t - snd o)); unfold Rsqr;
    intro; lra).
    replace s with ((fst z - fst o) - (fst z - s - fst o)) by ring. eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp. unfold m. lra. }
  assert (S' : Rabs t <= m').
  { assert (Near : Rabs (snd z - t - snd o) <= 1 + Rabs (k + rho)) by (apply square_bound; generalize (Rle_0_sqr (fst z - s - fst o)); unfold Rsqr;
    intro; lra).
    replace t with ((snd z - snd o) - (snd z - t - snd o)) by ring. eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp. unfold m'. lra. }
  assert (Over : forall y w, Rabs (y * D) <= w -> Rabs y <= w / D).
  { intros y w W. rewrite Rabs_mult, (Rabs_pos_eq D) in W by lra. apply Rmult_le_reg_r with D; [exact Positive|]. unfold Rdiv.
    rewrite Rmult_assoc, Rinv_l by lra. lra. }
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

(* What goes down as long as it is bad ends. *)
Lemma descend {I} (f : I -> R) (bad : I -> Prop) (l : list I) (Q : Prop) : (forall i, {bad i} + {~ bad i}) ->
  (forall i, In i l -> bad i -> Q \/ exists j, In j l /\ bad j /\ f j < f i) -> forall i, In i l -> bad i -> Q.
Proof.
  intros dec Step i Ii Bi. set (l' := filter (fun j => if dec j then true else false) l).
  assert (E : forall j, In j l' <-> In j l /\ bad j) by (intro j; unfold l'; rewrite filter_In; destruct (dec j); intuition discriminate).
  destruct (least f l' i) as (j & Ij & M); [now apply E|]. apply E in Ij. destruct Ij as [Ij Bj].
  destruct (Step j Ij Bj) as [H|(k & Ik & Bk & F)]; [exact H|]. assert (K := M k (proj2 (E k) (conj Ik Bk))). lra.
Qed.

(* ---- Every point is in a cell whose circle has the least power there ---- *)

(* The cotangent of the angle at q. *)
Definition apex_dot (a b q : point_2) : R := (fst a - fst q) * (fst b - fst q) + (snd a - snd q) * (snd b - snd q).
Definition apex (r : torus_cell_2) : R := let '(a, b, q) := r in apex_dot (spot a) (spot b) (spot q) / area_of r.

Lemma opposite_angles a b q p : beyond a b q p = apex_dot a b q * turning b a p + apex_dot a b p * turning a b q.
Proof. unfold beyond, incircle, apex_dot, turning, turn. ring. Qed.

Lemma apex_next a b q p : 0 < area_of (a, b, q) -> 0 < area_of (b, a, p) -> beyond (spot a) (spot b) (spot q) (spot p) = 0 ->
  apex (a, b, q) < apex (a, p, b) /\ apex (a, b, q) < apex (p, b, a).
Proof.
  intros A A' Z. rewrite opposite_angles in Z.
  change (turning (spot b) (spot a) (spot p)) with (area_of (b, a, p)) in Z. change (turning (spot a) (spot b) (spot q)) with (area_of (a, b, q)) in Z.
  assert (E1 : area_of (a, p, b) = area_of (b, a, p)) by (unfold area_of, torus_area, turning, turn; ring).
  assert (E2 : area_of (p, b, a) = area_of (b, a, p)) by (unfold area_of, torus_area, turning, turn; ring).
  assert (K : apex (a, b, q) = - (apex_dot (spot a) (spot b) (spot p) / area_of (b, a, p))).
  { unfold apex. apply Rmult_eq_reg_r with (area_of (a, b, q) * area_of (b, a, p)); [|apply Rmult_integral_contrapositive_currified; lra].
    field_simplify; lra. }
  assert (N : forall v w : point_2, 0 < turning (spot b) (spot a) (spot p) -> (v = spot b \/ v = spot a) -> w = spot p -> 0 < apex_dot v v w).
  { intros v w H V ->. unfold apex_dot. destruct (Req_dec (fst v) (fst (spot p))) as [F|F]; [destruct (Req_dec (snd v) (snd (spot p))) as [S|S]|].
    - exfalso. unfold turning, turn in H. destruct V; subst v; rewrite F, S in H; lra.
    - assert (Y := Rsqr_pos_lt (snd v - snd (spot p))). assert (X := Rle_0_sqr (fst v - fst (spot p))). unfold Rsqr in *. lra.
    - assert (X := Rsqr_pos_lt (fst v - fst (spot p))). assert (Y := Rle_0_sqr (snd v - snd (spot p))). unfold Rsqr in *. lra. }
  rewrite K. unfold apex. rewrite E1, E2. assert (H := Rinv_0_lt_compat _ A'). unfold Rdiv.
  split; apply Rminus_gt_0_lt.
  - replace (_ - _) with (apex_dot (spot b) (spot b) (spot p) * / area_of (b, a, p)) by (unfold apex_dot; ring).
    apply Rmult_lt_0_compat; [apply N; tauto|exact H].
  - replace (_ - _) with (apex_dot (spot a) (spot a) (spot p) * / area_of (b, a, p)) by (unfold apex_dot; ring).
    apply Rmult_lt_0_compat; [apply N; tauto|exact H].
Qed.

Definition instances (T : list torus_cell_2) (n : Z) : list (torus_cell_2 * offset_2) := list_prod T (list_prod (up_to n) (up_to n)).
Lemma in_instances T n k : In (fst k) T -> (Z.abs (fst (snd k)) <= n /\ Z.abs (snd (snd k)) <= n)%Z -> In k (instances T n).
Proof. destruct k as (c, (i, j)). intros I [A B]. apply in_prod; [exact I|]. apply in_prod; now apply in_up_to. Qed.

(* The rotations of all translates whose circles have a power below k at z. *)
Lemma finitely_many T z k : positive_torus_2 T -> exists l, (forall r, In r l -> exists i, In (fst i) T /\ In r (rotations_2 (instance i))) /\
  forall i r, In (fst i) T -> In r (rotations_2 (instance i)) -> power_of z r < k -> In r l.
Proof.
  intro P. destruct (few_cells T z k P) as (n & N). exists (flat_map (fun i => rotations_2 (instance i)) (instances T n)). split.
  - intros r I. apply in_flat_map in I. destruct I as (i & I & R). exists i. split; [|exact R]. destruct i. now apply in_prod_iff in I.
  - intros i r I R S. apply in_flat_map. exists i. split; [|exact R]. apply in_instances; [exact I|]. apply (N (fst i)); [exact I|].
    now rewrite (rotated_power r _ z R) in S.
Qed.

Theorem least_power T z c0 : glued_torus_2 T -> positive_torus_2 T -> locally_delaunay_2 T -> In c0 T ->
  exists c u, In c T /\ in_torus_cell z (moved_cell_2 u c) /\ forall c' u', In c' T -> power_of z (moved_cell_2 u c) <= power_of z (moved_cell_2 u' c').
Proof.
  intros G P D I0. destruct (least_translate T z c0 P I0) as (c & u & Ic & M). set (m := power_of z (moved_cell_2 u c)) in *.
  destruct (finitely_many T z (m + 1) P) as (l & Back & All).
  set (bad := fun r : torus_cell_2 => let '(a, b, q) := r in power_of z r = m /\ turning (spot a) (spot b) z < 0).
  assert (dec : forall r, {bad r} + {~ bad r}).
  { intros ((a, b), q). unfold bad. destruct (Req_EM_T (power_of z (a, b, q)) m), (Rlt_dec (turning (spot a) (spot b) z) 0); (left;
    now split) || (right; tauto). }
  assert (Good : forall i r, In (fst i) T -> In r (rotations_2 (instance i)) -> power_of z r = m -> in_torus_cell z r ->
    exists c u, In c T /\ in_torus_cell z (moved_cell_2 u c) /\ forall c' u', In c' T -> power_of z (moved_cell_2 u c) <= power_of z (moved_cell_2 u' c')).
  { intros (c', u') r I R E Z. exists c', u'. split; [exact I|]. split; [exact (in_rotated z r _ R Z)|]. intros c'' u'' I''.
    rewrite (rotated_power r _ z R) in E. unfold instance in E. cbn [fst snd] in E. rewrite E. now apply M. }
  assert (Down : forall r, In r l -> bad r -> exists c u, In c T /\ in_torus_cell z (moved_cell_2 u c) /\
    forall c' u', In c' T -> power_of z (moved_cell_2 u c) <= power_of z (moved_cell_2 u' c')).
  { intros r. apply (descend (fun r => - apex r) bad l); [exact dec|]. clear r. intros ((a, b), q) Il [E N].
    destruct (Back _ Il) as (i & Ii & R). destruct (neighbour T i a b q G Ii R) as (i' & p & Ii' & R').
    assert (A := instance_positive T i _ P Ii R). assert (A' := instance_positive T i' _ P Ii' R').
    assert (B := certified (Rle 0) T i i' a b q p D Ii Ii' R R'). assert (F := ratio_across a b q p z A A' N). assert (Eq := power_differs a b q p z A A').
    assert (Low : m <= power_of z (b, a, p)) by (rewrite (rotated_power _ _ z R'); now apply (M (fst i') (snd i'))).
    assert (Same : power_of z (b, a, p) = m) by nra. assert (Z : beyond (spot a) (spot b) (spot q) (spot p) = 0) by nra.
    destruct (apex_next a b q p A A' Z) as [Up Up']. assert (R2 := rotation_turns _ _ R'). assert (R3 := rotation_turns _ _ R2). simpl in R2, R3.
    assert (S2 : power_of z (a, p, b) = m) by (rewrite (rotated_power _ _ z R2), <- (rotated_power _ _ z R'); exact Same).
    assert (S3 : power_of z (p, b, a) = m) by (rewrite (rotated_power _ _ z R3), <- (rotated_power _ _ z R'); exact Same).
    destruct (Rlt_dec (turning (spot a) (spot p) z) 0) as [N2|N2]; [right; exists (a, p, b); split; [apply (All i'); trivial; lra|]; split;
    [now split|lra]|].
    destruct (Rlt_dec (turning (spot p) (spot b) z) 0) as [N3|N3]; [right; exists (p, b, a); split; [apply (All i'); trivial; lra|]; split;
    [now split|lra]|].
    left. apply (Good i' (b, a, p)); trivial. simpl.
    replace (turning (spot b) (spot a) z) with (- turning (spot a) (spot b) z) by (unfold turning, turn; ring). lra. }
  assert (Start : forall r, In r (rotations_2 (instance (c, u))) -> In r l /\ power_of z r = m).
  { intros r R. assert (E : power_of z r = m) by (rewrite (rotated_power r _ z R); reflexivity). split; [|exact E]. apply (All (c, u)); trivial. lra. }
  destruct (instance (c, u)) as ((a, b), q) eqn:C.
  destruct (Start (a, b, q)) as [I1 E1]; [simpl; tauto|]. destruct (Start (b, q, a)) as [I2 E2]; [simpl; tauto|].
  destruct (Start (q, a, b)) as [I3 E3]; [simpl; tauto|].
  destruct (Rlt_dec (turning (spot a) (spot b) z) 0) as [B1|B1]; [apply (Down (a, b, q)); now try split|].
  destruct (Rlt_dec (turning (spot b) (spot q) z) 0) as [B2|B2]; [apply (Down (b, q, a)); now try split|].
  destruct (Rlt_dec (turning (spot q) (spot a) z) 0) as [B3|B3]; [apply (Down (q, a, b)); now try split|].
  apply (Good (c, u) (a, b, q)); trivial; [rewrite C; simpl; tauto|]. simpl. lra.
Qed.
End placed.
