(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* machine_steps.v put together: any sequence of calls of the program, on primitive floats and on reals.

   - deed, done       what a call does to the state of the filter; `done` is one function for any numbers
   - done_same        one call
   - runs_same        whole runs of less than 2^49 calls: what the state of the machine stands for is the state of the model *)
From Coq Require Import Reals ZArith Lia Lra List Bool FunctionalExtensionality.
From Flocq Require Import Core.
From Coq Require Import Floats.
From Annulus Require float_model float_sums bridge_decide.
From Annulus Require Import operations bridge.
From Annulus_traces Require Import machine machine_rounds machine_never.
From Annulus Require Import algorithm_list truncated_double filter_doubles filter_world algorithm_filter algorithm_run.
From Annulus_traces Require Import machine_state machine_reach machine_steps machine_writes.
Import ListNotations.
Notation real := operations.value.
Close Scope float_scope.
Open Scope R_scope.
#[local] Opaque bpow.

(* What a call does, given what Repair, CGAL and the caller decide. All vertices pass; a step; one that is refused; vertices are inserted; all is recomputed; signs
   alone; tolerances are given up. *)
Section deeds.
Context {W : world}.
Inductive deed :=
  | pass (x : placement)
  | move (x : placement) (movers : list vertex) (m : Z -> option certificate) (verdicts : list verdict)
  | refuse (x : placement) (movers : list vertex)
  | refresh (placed : list (vertex * position)) (m : Z -> option certificate) (verdicts : list verdict)
  | recompute_all (x : placement) (m : Z -> option certificate) (verdicts : list verdict)
  | sign_all (x : placement) (m : Z -> option certificate)
  | stop.
Definition done (s : state) (d : deed) : state :=
  match d with
  | pass x => move_to x s
  | move x movers m verdicts => stepped s x (find_failed s x movers) m verdicts
  | refuse x movers => undo_anchoring (begin_anchoring s) (fst (find_expired s x (find_failed s x movers))) (find_failed s x movers)
  | refresh placed m verdicts => let t := fold_left place placed s in stepped t (moving t) [] m verdicts
  | recompute_all x m verdicts => recompute x s m verdicts
  | sign_all x m => move_to x (with_mesh s m)
  | stop => s
  end.
End deeds.

Section runs.
Variables (capacity : nat) (stamps : Z) (ratio : float).
Hypothesis ratio_least : 1 <= real ratio.
Hypothesis ratio_stands : stands 20 ratio (real ratio).
Variables (D : metric) (K : family (site D)) (G : grounded D).
Notation floats := (floats capacity stamps ratio D K G).
Notation reals := (reals capacity stamps ratio D K).
Notation state_of := (state_of capacity stamps ratio D K G).
Notation places_of := (places_of capacity stamps ratio D K G).
Notation verdict_of := (verdict_of capacity stamps ratio D K G).
Notation tame := (tame capacity stamps ratio D K G).
Notation small := (small capacity stamps ratio D K G).
Notation proper_verdict := (proper_verdict capacity stamps ratio D K G).
Notation bounded := (in_bounds_all D G).
Notation placed_of := (placed_of capacity stamps ratio D K G).

(* ---- A call ---- *)

Definition deed_of (d : @deed floats) : @deed reals :=
  match d with
  | pass x => pass (places_of x)
  | move x movers m verdicts => @move reals (places_of x) movers m (map verdict_of verdicts)
  | refuse x movers => @refuse reals (places_of x) movers
  | refresh placed m verdicts => @refresh reals (map placed_of placed) m (map verdict_of verdicts)
  | recompute_all x m verdicts => @recompute_all reals (places_of x) m (map verdict_of verdicts)
  | sign_all x m => @sign_all reals (places_of x) m
  | stop => stop
  end.
(* Coordinates in the domain, tolerances that are numbers below 2^900, and numbers of certificates. *)
Definition written_right (m : Z -> option (@certificate floats)) (verdicts : list (@verdict floats)) : Prop :=
  (forall i c, m i = Some c -> is_id i) /\ forall k, In k verdicts -> proper_verdict k.
Definition fit (d : @deed floats) : Prop :=
  match d with
  | pass x | refuse x _ => forall v, bounded (x v)
  | move x _ m verdicts | recompute_all x m verdicts => (forall v, bounded (x v)) /\ written_right m verdicts
  | refresh placed m verdicts => (forall n, In n placed -> bounded (snd n)) /\ written_right m verdicts
  | sign_all x m => (forall v, bounded (x v)) /\ written_right m []
  | stop => True
  end.

Theorem done_same (B : reach) (s : @state floats) d : tame B s -> small B s -> fit d -> tame B (done s d) /\ state_of (done s d) = done (state_of s) (deed_of d).
Proof.
  intros T S F. destruct d as [x|x movers m verdicts|x movers|placed m verdicts|x m verdicts|x m|]; cbn [done deed_of fit] in *.
  - now apply moved_same.
  - destruct F as [X [M V]]. assert (E := failed_same _ _ _ _ _ _ B s x movers T X). change (@vertex floats) with nat in E. change (@vertex reals) with nat in E.
    rewrite <- E. now apply stepped_same.
  - assert (E := failed_same _ _ _ _ _ _ B s x movers T F). change (@vertex floats) with nat in E. change (@vertex reals) with nat in E.
    rewrite <- E. destruct (expired_same _ _ _ _ _ _ _ s x (find_failed s x movers) T S F) as (A & Q & _ & N). rewrite <- Q.
    rewrite <- begun_same. apply undone_same; [now apply begun_tame|exact A|now symmetry].
  - destruct F as [P [M V]]. destruct (places_same _ _ _ _ _ _ _ placed s T S P) as (A & N & E). cbv zeta. rewrite <- E.
    apply (stepped_same _ _ _ ratio_least ratio_stands _ _ _ _ (moving (fold_left place placed s))); trivial. apply (tame_moving _ _ _ _ _ _ _ _ A).
  - destruct F as [X [M V]]. apply recomputed_same; trivial. apply (tame_expiry _ _ _ _ _ _ _ s T).
  - destruct F as [X [M _]]. apply (moved_same _ _ _ _ _ _ _ x); [exact X|]. now apply mesh_same.
  - now split.
Qed.

(* ---- Whole runs ---- *)

(* From one call to the next. *)
Lemma tame_next (B B' : reach) (s : @state floats) : tame B s -> gone B' = going B -> tame B' s /\ small B' s.
Proof.
  intros [A A' C E F H I] N. assert (Q : forall v, moderate capacity stamps ratio D K G (at_ s v) (gone B')).
  { intro v. destruct (C v) as [C1 [C2 C3]]. split; [exact C1|split; [exact C2|]]. rewrite N. apply Rle_trans with (1 := C3).
    destruct (going_bounds B). destruct (_ =? _)%Z; lra. }
  split; [|intro v; apply (Q v)]. split; trivial. intro v. destruct (Q v) as [C1 [C2 C3]]. split; [exact C1|split; [exact C2|]].
  apply Rle_trans with (1 := C3). destruct (going_bounds B'). destruct (_ =? _)%Z; lra.
Qed.

Lemma within_less n : within_reach (S n) -> within_reach n.
Proof. unfold within_reach. rewrite S_INR. lra. Qed.

Section run.
Variables (s : nat -> @state floats) (d : nat -> @deed floats) (n : nat).
Hypothesis begins : forall B, tame B (s O).
Hypothesis does : forall i, (i < n)%nat -> fit (d i) /\ s (S i) = done (s i) (d i).

Lemma run_tame i : (i <= n)%nat -> forall (H : within_reach (S i)) (H' : within_reach (S (S i))),
  tame (reach_after (S i) H H') (s i) /\ small (reach_after (S i) H H') (s i).
Proof.
  induction i as [|i IH]; intros L H H'.
  - exact (tame_next (reach_after 0 (within_less 0 H) H) (reach_after 1 H H') _ (begins _) eq_refl).
  - destruct (IH ltac:(lia) (within_less _ H) H) as [T S]. destruct (does i L) as [F E].
    apply (tame_next (reach_after (Datatypes.S i) (within_less _ H) H) (reach_after (Datatypes.S (Datatypes.S i)) H H')); [|reflexivity]. rewrite E.
    now apply done_same.
Qed.

Theorem runs_same i : (i < n)%nat -> within_reach (S (S i)) -> state_of (s (S i)) = done (state_of (s i)) (deed_of (d i)).
Proof.
  intros L H. destruct (run_tame i ltac:(lia) (within_less _ H) H) as [T S]. destruct (does i L) as [F E]. rewrite E.
  exact (proj2 (done_same _ _ _ T S F)).
Qed.
End run.
End runs.
