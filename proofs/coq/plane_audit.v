(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* An audit of a triangulation in the plane that is proved: a function that computes with integers, and nothing to believe when it says yes.

   - paired, closed_border   an edge map and a walk along the border, as src/annulus/mesh/audit_2.cpp makes them
   - glued_by_edges          where they come out even, the mesh is glued
   - audited                 the whole audit, of doubles and cells: it can be run
   - audited_delaunay        what it accepts is a triangulation of all the points, and Delaunay

   traces/audits.v runs it on tables of the engine, and on tables that are damaged. *)
From Coq Require Import Reals ZArith List Bool Permutation Lia Lra.
From Flocq Require Import Core IEEE754.BinarySingleNaN IEEE754.PrimFloat.
From Coq Require Import Floats.
From Annulus Require Import points_2 width_2 operations bridge filter_2 returned_2 filter_delaunay.
From Annulus Require Import plane_mesh plane_triangulation plane_delaunay.
Import ListNotations.
Close Scope float_scope.
Open Scope R_scope.
Open Scope lazy_bool_scope.   (* &&& stops at the first false *)

(* ---- Edges ---- *)

Definition same_side (s t : nat * nat * nat) : bool :=
  let '(a, b, c) := s in let '(x, y, z) := t in ((a =? x) &&& ((b =? y) &&& (c =? z)))%nat.
Definition same_edge (s t : nat * nat) : bool := ((fst s =? fst t) &&& (snd s =? snd t))%nat.

Lemma same_side_right s t : same_side s t = true -> s = t.
Proof.
  destruct s as [[a b] c], t as [[x y] z]. unfold same_side. rewrite <- !andb_lazy_alt, !andb_true_iff, !Nat.eqb_eq. now intros (-> & -> & ->).
Qed.
Lemma same_edge_right s t : same_edge s t = true -> s = t.
Proof. destruct s, t. unfold same_edge. cbn [fst snd]. rewrite <- andb_lazy_alt, andb_true_iff, !Nat.eqb_eq. now intros [-> ->]. Qed.

Section lists.
Context {A : Type} (same : A -> A -> bool).
Hypothesis right : forall a b, same a b = true -> a = b.
Hypothesis reflexive : forall a, same a a = true.

Fixpoint all_differ (l : list A) : bool := match l with [] => true | a :: l => negb (existsb (same a) l) && all_differ l end.
(* The same elements as often: no two of the first are the same, all are in the second, which is not longer. *)
Definition rearranged (l k : list A) : bool := all_differ l && (length k <=? length l)%nat && forallb (fun a => existsb (same a) k) l.

Lemma all_differ_right l : all_differ l = true -> NoDup l.
Proof.
  induction l as [|a l IH]; [constructor|]. cbn [all_differ]. rewrite andb_true_iff, negb_true_iff. intros [N D]. constructor; [|now apply IH].
  intro I. assert (existsb (same a) l = true) by (apply existsb_exists; now exists a). congruence.
Qed.

Lemma rearranged_right l k : rearranged l k = true -> Permutation l k.
Proof.
  unfold rearranged. rewrite !andb_true_iff, Nat.leb_le, forallb_forall. intros [[D L] I].
  apply NoDup_Permutation_bis; [now apply all_differ_right|exact L|]. intros a Ia. specialize (I a Ia). apply existsb_exists in I.
  destruct I as (b & Ib & E). apply right in E. now subst b.
Qed.
End lists.

(* The corner opposite to the edge a b of a cell. *)
Definition opposite_of (s : list (nat * nat * nat)) (a b : nat) : option nat :=
  match find (fun t => same_edge (edge t) (a, b)) s with Some (_, _, c) => Some c | None => None end.
Definition paired (s : list (nat * nat * nat)) : list (nat * nat * nat * nat) :=
  flat_map (fun t => let '(a, b, c) := t in
    if (a <? b)%nat then match opposite_of s b a with Some d => [(a, b, d, c)] | None => [] end else []) s.
Definition unpaired (s : list (nat * nat * nat)) : list (nat * nat * nat) :=
  filter (fun t => let '(a, b, c) := t in match opposite_of s b a with Some _ => false | None => true end) s.
Fixpoint walk (steps : nat) (edges : list (nat * nat)) (first a : nat) : list nat :=
  match steps with
  | O => []
  | S steps => match find (fun e => fst e =? a)%nat edges with
               | Some (_, b) => a :: if (b =? first)%nat then [] else walk steps edges first b
               | None => [a]
               end
  end.
Definition closed_border (edges : list (nat * nat)) : list nat := match edges with [] => [] | (a, _) :: _ => walk (length edges) edges a a end.

Definition mesh_of (cells : list (nat * nat * nat)) : plane_mesh.mesh :=
  let s := flat_map sides cells in let o := unpaired s in {|
  plane_mesh.cells := cells; bicells := paired s; outer := o; border := closed_border (map edge o) |}.
Definition even (T : plane_mesh.mesh) : bool :=
  rearranged same_side (flat_map sides (plane_mesh.cells T)) (flat_map shared_sides (bicells T) ++ outer T) &&
  rearranged same_edge (map edge (outer T)) (ring (border T)).

Lemma same_side_refl s : same_side s s = true.
Proof. destruct s as [[a b] c]. unfold same_side. now rewrite !Nat.eqb_refl. Qed.
Lemma same_edge_refl s : same_edge s s = true.
Proof. unfold same_edge. now rewrite !Nat.eqb_refl. Qed.

Theorem glued_by_edges T : even T = true -> glued T.
Proof.
  unfold even. rewrite andb_true_iff. intros [S E]. split.
  - exact (rearranged_right same_side same_side_right same_side_refl _ _ S).
  - exact (rearranged_right same_edge same_edge_right same_edge_refl _ _ E).
Qed.

Lemma bends_in p u v w : In (u, v, w) (bends p) -> In u p /\ In v p /\ In w p.
Proof.
  induction p as [|a p IH]; [easy|]. destruct p as [|b [|c p]]; [easy|easy|]. rewrite plane_paths.bends_cons. intros [E|I].
  - injection E as <- <- <-. simpl. tauto.
  - destruct (IH I) as (U & V & X). split; [now right|split; now right].
Qed.
Lemma ridge_in l u v w : In (u, v, w) (ridges l) -> In u l /\ In v l /\ In w l.
Proof.
  assert (Q : forall x, In x (l ++ firstn 2 l) -> In x l).
  { intros x I. apply in_app_or in I. destruct I as [I|I]; [exact I|]. rewrite <- (firstn_skipn 2 l). apply in_or_app. now left. }
  intro I. destruct (bends_in _ u v w I) as (U & V & X). repeat split; now apply Q.
Qed.

(* ---- Integers ---- *)

Definition point_z : Type := Z * Z.
Definition turn_z (a b c : point_z) : Z := ((fst b - fst a) * (snd c - snd a) - (snd b - snd a) * (fst c - fst a))%Z.
Definition dot_z (a b c : point_z) : Z := ((fst b - fst a) * (fst c - fst b) + (snd b - snd a) * (snd c - snd b))%Z.
Definition power_z (a b p : point_z) : Z := ((fst p - fst a) * (fst p - fst b) + (snd p - snd a) * (snd p - snd b))%Z.
Definition incircle_z (a b p q : point_z) : Z := (power_z a b p * turn_z a b q + power_z a b q * turn_z b a p)%Z.
Definition up_z (a b : point_z) : bool := ((snd a <? snd b) || ((snd a =? snd b) && (fst a <? fst b)))%Z.

Section judge.
Variable z : nat -> point_z.
Definition positive_z (t : nat * nat * nat) : bool := let '(a, b, c) := t in (0 <? turn_z (z a) (z b) (z c))%Z.
Definition convex_z (r : nat * nat * nat) : bool :=
  let '(u, v, w) := r in let t := turn_z (z u) (z v) (z w) in ((0 <? t) || ((t =? 0) && (0 <? dot_z (z u) (z v) (z w))))%Z.
Definition enters_z (r : nat * nat * nat) : bool := let '(u, v, w) := r in negb (up_z (z u) (z v)) && up_z (z v) (z w).
Definition empty_z (k : nat * nat * nat * nat) : bool := let '(a, b, p, q) := k in (0 <=? incircle_z (z a) (z b) (z p) (z q))%Z.
Definition judged (T : plane_mesh.mesh) : bool :=
  forallb positive_z (plane_mesh.cells T) &&& forallb convex_z (ridges (border T)) &&&
  (length (filter enters_z (ridges (border T))) =? 1)%nat &&& forallb empty_z (bicells T).

(* A placement that is these integers, each times s. *)
Variables (m : placement) (s : R).
Hypothesis scale : 0 < s.
Definition here (v : nat) : Prop := m v = (s * IZR (fst (z v)), s * IZR (snd (z v))).

Ltac to_reals := rewrite ?plus_IZR, ?minus_IZR, ?mult_IZR, ?plus_IZR, ?minus_IZR, ?mult_IZR, ?plus_IZR, ?minus_IZR, ?mult_IZR.

Lemma turn_here a b c : here a -> here b -> here c -> turn_at m a b c = s * s * IZR (turn_z (z a) (z b) (z c)).
Proof. unfold here, turn_at, turning, turn, turn_z. intros -> -> ->. cbn [fst snd]. to_reals. ring. Qed.
Lemma dot_here a b c : here a -> here b -> here c -> dot (vector (m a) (m b)) (vector (m b) (m c)) = s * s * IZR (dot_z (z a) (z b) (z c)).
Proof. unfold here, dot, vector, dot_z. intros -> -> ->. cbn [fst snd]. to_reals. ring. Qed.
Lemma incircle_here a b p q : here a -> here b -> here p -> here q -> incircle_at m a b p q = s * s * (s * s) * IZR (incircle_z (z a) (z b) (z p) (z q)).
Proof.
  unfold here, incircle_at, incircle, turn, incircle_z, power_z, turn_z. intros -> -> -> ->. cbn [fst snd].
  repeat (rewrite ?plus_IZR, ?minus_IZR, ?mult_IZR). ring.
Qed.

Lemma up_here a b : here a -> here b -> points_up (m a) (m b) = up_z (z a) (z b).
Proof.
  unfold here, points_up, up_z. intros -> ->. cbn [fst snd].
  assert (L : forall x y, s * IZR x < s * IZR y <-> (x < y)%Z).
  { intros x y. split; intro H; [apply lt_IZR; now apply (Rmult_lt_reg_l s)|apply Rmult_lt_compat_l; [exact scale|now apply IZR_lt]]. }
  destruct (Z.ltb_spec (snd (z a)) (snd (z b))) as [Y|Y].
  - cbn [orb]. destruct (Rlt_dec _ _) as [H|H]; [reflexivity|]. exfalso. now apply H, L.
  - cbn [orb]. destruct (Rlt_dec _ _) as [H|H]; [apply L in H; lia|]. destruct (Z.eqb_spec (snd (z a)) (snd (z b))) as [E|E]; cbn [andb].
    + rewrite E. destruct (Req_EM_T _ _) as [_|N]; [|now contradiction N]. destruct (Z.ltb_spec (fst (z a)) (fst (z b))) as [X|X].
      * destruct (Rlt_dec _ _) as [K|K]; [reflexivity|]. exfalso. now apply K, L.
      * destruct (Rlt_dec _ _) as [K|K]; [apply L in K; lia|reflexivity].
    + destruct (Req_EM_T _ _) as [N|_]; [|reflexivity]. exfalso. apply E, eq_IZR. now apply (Rmult_eq_reg_l s); [|lra].
Qed.

Lemma scaled_pos k : (0 < k)%Z -> 0 < s * s * IZR k.
Proof. intro K. apply IZR_lt in K. repeat apply Rmult_lt_0_compat; trivial. Qed.

(* All vertices that the mesh names are below n. *)
Variable n : nat.
Definition below_n (v : nat) : bool := (v <? n)%nat.
Definition inside_n (T : plane_mesh.mesh) : bool :=
  forallb (fun t => let '(a, b, c) := t in below_n a && below_n b && below_n c) (plane_mesh.cells T) && forallb below_n (border T) &&
  forallb (fun k => let '(a, b, p, q) := k in below_n a && below_n b && below_n p && below_n q) (bicells T).

Theorem judged_delaunay T : (forall v, (v < n)%nat -> here v) -> glued T -> inside_n T = true -> judged T = true -> triangulation m T /\ delaunay m T.
Proof.
  intros H G. unfold inside_n, judged, below_n. rewrite <- !andb_lazy_alt, !andb_true_iff, !forallb_forall. intros [[Nc Nb] Nk] [[[P C] W] E].
  assert (Pos : positive m T).
  { intros a b c I. specialize (Nc _ I). cbn beta iota in Nc. rewrite !andb_true_iff, !Nat.ltb_lt in Nc.
    rewrite turn_here by (apply H; tauto). apply scaled_pos, Z.ltb_lt. exact (P _ I). }
  assert (Ridge : forall u v w, In (u, v, w) (ridges (border T)) -> here u /\ here v /\ here w).
  { intros u v w I. destruct (ridge_in _ u v w I) as (U & V & X). repeat split; apply H, Nat.ltb_lt; now apply Nb. }
  assert (Con : convex m (border T)).
  { intros u v w I. destruct (Ridge u v w I) as (U & V & X). unfold convex_at. rewrite turn_here, dot_here by trivial. specialize (C _ I). cbn [convex_z] in C.
    rewrite orb_true_iff, andb_true_iff, !Z.ltb_lt, Z.eqb_eq in C. destruct C as [C|[Z0 C]]; [left; now apply scaled_pos|right].
    rewrite Z0. split; [ring|now apply scaled_pos]. }
  assert (Win : winds_once m (border T)).
  { apply Nat.eqb_eq in W. unfold winds_once. rewrite <- W. f_equal. apply filter_ext_in. intros [[u v] w] I. destruct (Ridge u v w I) as (U & V & X).
    unfold enters, enters_z. now rewrite !up_here. }
  split; [now apply plane_triangulation|]. apply plane_delaunay; trivial. intros a b p q I. specialize (Nk _ I). cbn beta iota in Nk.
  rewrite !andb_true_iff, !Nat.ltb_lt in Nk. rewrite incircle_here by (apply H; tauto). specialize (E _ I). cbn [empty_z] in E. apply Z.leb_le, IZR_le in E.
  apply Rmult_le_pos; [|exact E]. apply Rlt_le. repeat apply Rmult_lt_0_compat; exact scale.
Qed.
End judge.

(* ---- Doubles ---- *)

(* A double as an integer times 2^e, where it is one. Coq reads mantissa and exponent of each coordinate once: that takes it long. *)
Definition integer (e : Z) (x : spec_float) : Z := match x with S754_finite s m f => (cond_Zopp s (Zpos m) * 2 ^ (f - e))%Z | _ => 0%Z end.
Definition is_integer (e : Z) (x : spec_float) : bool :=
  match x with S754_zero _ => true | S754_finite _ _ f => (e <=? f)%Z | _ => false end.
Definition exponent (x : spec_float) (e : Z) : Z := match x with S754_finite _ _ f => Z.min f e | _ => e end.

Lemma integer_value e x : is_integer e (Prim2SF x) = true -> finite x = true /\ value x = power e * IZR (integer e (Prim2SF x)).
Proof.
  unfold is_integer, integer, finite, value. rewrite <- SF2R_B2SF, <- is_finite_SF_B2SF, B2SF_Prim2B.
  destruct (Prim2SF x) as [s| | |s m f]; try discriminate; intro H; (split; [reflexivity|]); cbn [SF2R]; [ring|]. apply Z.leb_le in H.
  unfold F2R. cbn [Fnum Fexp]. rewrite mult_IZR, (IZR_Zpower radix2) by lia.
  replace f with (e + (f - e))%Z at 1 by lia. rewrite bpow_plus. ring.
Qed.

Definition read (p : filter_2.vector machine) : spec_float * spec_float := (Prim2SF (x _ p), Prim2SF (y _ p)).
Definition coordinates_of (l : list (spec_float * spec_float)) : list spec_float := flat_map (fun p => [fst p; snd p]) l.
Definition point_of (e : Z) (p : spec_float * spec_float) : point_z := (integer e (fst p), integer e (snd p)).
Definition all_used (n : nat) (cells : list (nat * nat * nat)) : bool :=
  forallb (fun v => existsb (fun t => let '(a, b, c) := t in ((v =? a) || (v =? b) || (v =? c))%nat) cells) (seq 0 n).

(* Vertices are 0 to n - 1. *)
Definition audited (n : nat) (f : doubles) (cells : list (nat * nat * nat)) : bool :=
  let places := map (fun v => read (f v)) (seq 0 n) in
  let e := fold_right exponent 1024%Z (coordinates_of places) in
  let points := map (point_of e) places in
  let z v := nth v points (0, 0)%Z in
  let T := mesh_of cells in
  forallb (is_integer e) (coordinates_of places) &&& all_used n cells &&& inside_n n T &&& even T &&& judged z T.

Theorem audited_delaunay n f cells : audited n f cells = true -> exists T, plane_mesh.cells T = cells /\
  (forall v, vertex_of T v <-> (v < n)%nat) /\ (forall v, (v < n)%nat -> finite (x _ (f v)) = true /\ finite (y _ (f v)) = true) /\
  triangulation (at_doubles f) T /\ delaunay (at_doubles f) T.
Proof.
  unfold audited. set (places := map _ _). set (e := fold_right _ _ _). set (points := map (point_of e) places). rewrite <- !andb_lazy_alt, !andb_true_iff. intros [[[[I U] N] E] J].
  rewrite forallb_forall in I. exists (mesh_of cells). split; [reflexivity|].
  assert (Own : forall v, (v < n)%nat -> is_integer e (Prim2SF (x _ (f v))) = true /\ is_integer e (Prim2SF (y _ (f v))) = true).
  { intros v V. split; apply I, in_flat_map; exists (read (f v)); (split; [apply in_map_iff; exists v; split; [reflexivity|apply in_seq; lia]|]); simpl; tauto. }
  split; [|split; [intros v V; split; apply (integer_value e); now apply Own|]].
  - intro v. split.
    + intros ([[a b] c] & K & Q). unfold inside_n, below_n in N. rewrite !andb_true_iff, !forallb_forall in N. destruct N as [[Nc _] _].
      specialize (Nc _ K). cbn beta iota in Nc. rewrite !andb_true_iff, !Nat.ltb_lt in Nc. destruct Q as [->|[->| ->]]; tauto.
    + intro V. unfold all_used in U. rewrite forallb_forall in U. specialize (U v). rewrite in_seq in U. specialize (U ltac:(lia)).
      apply existsb_exists in U. destruct U as ([[a b] c] & K & Q). exists (a, b, c). split; [exact K|]. cbn [corner].
      rewrite !orb_true_iff, !Nat.eqb_eq in Q. tauto.
  - apply (judged_delaunay (fun v => nth v points (0, 0)%Z) (at_doubles f) (power e) (bpow_gt_0 radix2 e) n); trivial; [|now apply glued_by_edges].
    intros v V. unfold here, at_doubles, at_2. destruct (Own v V) as [X Y]. rewrite (proj2 (integer_value e _ X)), (proj2 (integer_value e _ Y)).
    unfold points, places. rewrite map_map, (nth_indep _ _ (point_of e (read (f 0%nat)))) by now rewrite map_length, seq_length.
    rewrite (map_nth (fun v => point_of e (read (f v)))), seq_nth by exact V. reflexivity.
Qed.
