(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The certificates of a mesh of the plane under the numbers that the program has for them.

   - lists                certificates and numbers are those of the mesh
   - circles_counted      the cells that a circle counts on are among them
   - certified_vertices   what is in a certificate is a vertex of the mesh *)
From Coq Require Import Reals ZArith List Bool Lra Lia Permutation.
From Annulus Require plane_table_glued plane_audit.
From Annulus Require Import points_2 algorithm_list filter_plane plane_mesh plane_certificates.
Import ListNotations.
Open Scope R_scope.

(* The certificates of a mesh under their numbers. *)
Definition lists (m : Z -> option certificate_2) (T : plane_mesh.mesh) : Prop :=
  (forall c, In c (certificates T) <-> exists i, m i = Some c) /\ forall i c, m i = Some c -> is_id i.

(* ---- Cells that circles count on ---- *)

Definition corners_differ (t : nat * nat * nat) : Prop := let '(a, b, c) := t in a <> b /\ b <> c /\ a <> c.

Lemma least_turned a b c : corners_differ (a, b, c) -> least_first a b c = least_first b c a.
Proof.
  intros (A & B & C). unfold least_first.
  destruct (Nat.leb_spec a b), (Nat.leb_spec a c), (Nat.leb_spec b a), (Nat.leb_spec b c), (Nat.leb_spec c b), (Nat.leb_spec c a); cbn [andb]; try reflexivity; lia.
Qed.

Lemma positive_differ m a b c : 0 < turn_at m a b c -> corners_differ (a, b, c).
Proof. unfold turn_at, turning, width_2.turn. intro P. repeat split; intros ->; lra. Qed.

Lemma side_of_cell T a b c : (forall t, In t (cells T) -> corners_differ t) -> In (a, b, c) (flat_map sides (cells T)) ->
  In (least_first a b c) (certificates T).
Proof.
  intros D I. apply in_flat_map in I. destruct I as ([[x y] z] & I & S). assert (K := D _ I).
  assert (E : least_first a b c = least_first x y z).
  { destruct S as [S|[S|[S|[]]]]; injection S as <- <- <-; [reflexivity|symmetry; now apply least_turned|].
    apply least_turned. unfold corners_differ in *. intuition congruence. }
  rewrite E. apply in_or_app. left. apply in_map_iff. now exists (x, y, z).
Qed.

Lemma circle_listed T a b p q : In (circle a b p q) (certificates T) -> In (a, b, p, q) (bicells T).
Proof.
  unfold certificates. rewrite !in_app_iff, !in_map_iff. intros [(t & E & _)|[(r & E & _)|(k & E & I)]].
  - destruct t as [[x y] z]. unfold least_first in E. destruct (_ && _); [discriminate|]. now destruct (_ && _).
  - now destruct r as [[x y] z].
  - destruct k as [[[x y] z] w]. now injection E as -> -> -> ->.
Qed.

Lemma cell_listed T t : In t (cells T) -> In (let '(a, b, c) := t in least_first a b c) (certificates T).
Proof. intro I. apply in_or_app. left. apply in_map_iff. now exists t. Qed.

Lemma circles_counted m T : lists m T -> glued T -> (forall t, In t (cells T) -> corners_differ t) ->
  forall i c d, m i = Some c -> counts_on_2 d c -> exists j, m j = Some d.
Proof.
  intros [L _] [G _] D i c d M Q. destruct c as [| |a b p q]; try contradiction. apply L.
  assert (I : In (a, b, p, q) (bicells T)) by (apply circle_listed, L; now exists i).
  assert (S : forall s, In s (shared_sides (a, b, p, q)) -> In s (flat_map sides (cells T))).
  { intros s K. apply (Permutation_in s (Permutation_sym G)), in_or_app. left. apply in_flat_map. now exists (a, b, p, q). }
  destruct Q as [->| ->]; apply side_of_cell; trivial; apply S; [now left|right; now left].
Qed.
Lemma ridge_listed m T u v w : lists m T -> In (u, v, w) (ridges (border T)) -> exists i, m i = Some (ridge u v w).
Proof. intros [L _] I. apply L, in_or_app. right. apply in_or_app. left. apply in_map_iff. now exists (u, v, w). Qed.

(* ---- Vertices ---- *)

(* A vertex of a certificate is in a cell. *)
Lemma side_vertices T a b c : glued T -> In (a, b, c) (flat_map shared_sides (bicells T) ++ outer T) -> vertex_of T a /\ vertex_of T b /\ vertex_of T c.
Proof.
  intros [G _] I. apply (Permutation_in _ (Permutation_sym G)), in_flat_map in I. destruct I as ([[x y] z] & I & S).
  assert (K : forall v, v = x \/ v = y \/ v = z -> vertex_of T v) by (intros v V; now exists (x, y, z)).
  destruct S as [S|[S|[S|[]]]]; injection S as <- <- <-; repeat split; apply K; tauto.
Qed.
Lemma border_vertices T v : glued T -> In v (border T) -> vertex_of T v.
Proof.
  intros G I. rewrite <- (plane_table_glued.ring_begins (border T)) in I. apply (Permutation_in _ (Permutation_map fst (Permutation_sym (proj2 G)))) in I.
  rewrite map_map in I. apply in_map_iff in I. destruct I as ([[a b] c] & <- & I).
  apply (side_vertices T a b c G), in_or_app. now right.
Qed.
Lemma certified_vertices T c v : glued T -> In c (certificates T) -> In v (points_2 c) -> vertex_of T v.
Proof.
  intros G I V. unfold certificates in I. rewrite !in_app_iff, !in_map_iff in I. destruct I as [(t & <- & I)|[(r & <- & I)|(k & <- & I)]].
  - exists t. split; [exact I|]. destruct t as [[x y] z]. unfold least_first in V.
    destruct (_ && _); [|destruct (_ && _)]; cbn [points_2] in V; cbn [plane_mesh.corner]; cbn [In] in V; intuition congruence.
  - destruct r as [[x y] z]. destruct (plane_audit.ridge_in (border T) _ _ _ I) as (X & Y & Z). destruct V as [<-|[<-|[<-|[]]]]; now apply border_vertices.
  - destruct k as [[[a b] p] q]. assert (S : forall s, In s (shared_sides (a, b, p, q)) -> In s (flat_map shared_sides (bicells T) ++ outer T)).
    { intros s K. apply in_or_app. left. apply in_flat_map. now exists (a, b, p, q). }
    destruct (side_vertices T a b q G) as (A & B & Q); [apply S; now left|]. destruct (side_vertices T b a p G) as (_ & _ & P); [apply S; right; now left|].
    destruct V as [<-|[<-|[<-|[<-|[]]]]]; trivial.
Qed.
