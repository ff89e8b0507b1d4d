(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The invariant of `filter` (algorithm_filter.v), and what one operation does to all that it is not about.

   - good           of a certificate: what its record promises (sane), that its points are near its reference (close), that lists contain it
                    (listed), that the test of a step includes it (tested). An expiry is below what is allowed, or below the base: overdue, or clipped by rebase
   - advance        what anchoring and writing do to all else: displacement budgets go on, lists and tests keep what they contain
   - good_carried   so what is good stays good
   - anchor_advance, put_at_advance    two that do
   - evaluated_good a certificate that was evaluated at x, written down, is good *)
Require Import Reals Lra Lia ZArith List Bool.
From Annulus Require Import algorithm_listed truncated_double algorithm_filter.
Import ListNotations.
Open Scope R_scope.

Section keep.
Context {W : world} {L : laws}.
Notation Valid x := (forall v, valid (x v)).

(* Expiry::lower, with the names of truncated_double.v. *)
Lemma half_range (b : num) : (0 <= half b <= never)%Z. Proof. rewrite half_lower. apply lower_range. Qed.
Lemma half_below (b : num) : 0 <= b -> value (half b) <= b. Proof. rewrite half_lower. apply lower_below. Qed.
Lemma half_clips (b : num) : b <= 0 -> half b = 0%Z. Proof. rewrite half_lower. apply lower_clips. Qed.
Lemma half_not_reached (b : num) e : 0 <= b -> (e <= never)%Z -> (half b < e)%Z -> b < value e. Proof. rewrite half_lower. apply not_reached. Qed.

Definition fixed_of (s : state) : placement := fun v => fixed (at_ s v).
Definition touched (s : state) (v : vertex) : Prop := stamp (at_ s v) = epoch s.
Definition protects (o : budget) (own : Z) : Prop :=
  forall p, valid p -> below (fixed o) p (room o) = true -> base o + dist (fixed o) p < value own.
Definition in_use (e : Z) : Prop := (0 <= e <= never)%Z.

Record fine (s : state) (v : vertex) : Prop := {
  base_number : number (base (at_ s v));
  base_pos : 0 <= base (at_ s v);
  fixed_valid : valid (fixed (at_ s v));
  list_proper : proper capacity (listing (at_ s v));
  stamp_range : (0 <= stamp (at_ s v) <= epoch s)%Z }.

Record sane (s : state) (i : Z) (c : certificate) : Prop := {
  an_id : is_id i;
  promise : sound c (reference (record s i)) (allowance (record s i));
  used : forall v, In v (points c) -> in_use (expiry (record s i) v);
  path : forall v, In v (points c) -> dist (reference (record s i) v) (fixed (at_ s v)) <= base (at_ s v) - origin (record s i) v;
  expires : forall v, In v (points c) -> value (expiry (record s i) v) <= origin (record s i) v + allowance (record s i) \/
                                         value (expiry (record s i) v) <= base (at_ s v) }.
Definition close (s : state) (x : placement) i c : Prop := forall v, In v (points c) ->
  near x (reference (record s i)) (allowance (record s i)) v /\ near (fixed_of s) (reference (record s i)) (allowance (record s i)) v.
Definition listed (s : state) i c : Prop := forall v, In v (points c) -> kept (listing (at_ s v)) i (expiry (record s i) v).
Definition tested (s : state) (open : vertex -> Prop) i c : Prop :=
  forall v, In v (points c) -> open v \/ protects (at_ s v) (expiry (record s i) v).
Record good (s : state) (x : placement) (open : vertex -> Prop) (i : Z) (c : certificate) : Prop := {
  is_sane : sane s i c; is_close : close s x i c; is_listed : listed s i c; is_tested : tested s open i c }.

Definition at_x (s : state) (x : placement) : Prop := forall v, touched s v -> fixed (at_ s v) = x v /\ In v (anchored s).

(* ---- What operations do to all else ---- *)

Record follow (x : placement) (ids : Z -> Prop) (e : Z) (v : vertex) (o o' : budget) : Prop := {
  path_grows : (fixed o' = fixed o /\ base o' = base o) \/ (fixed o' = x v /\ base o + dist (fixed o) (x v) <= base o');
  stays_touched : stamp o = e -> stamp o' = e;
  keeps : forall j own, in_use own -> ~ ids j -> kept (listing o) j own ->
    kept (listing o') j own /\ (stamp o' = e \/ (protects o own -> protects o' own)) }.
Record advance (x : placement) (ids : Z -> Prop) (s t : state) : Prop := {
  same_mesh : mesh t = mesh s;
  same_epoch : epoch t = epoch s;
  same_moving : moving t = moving s;
  follows : forall v, follow x ids (epoch s) v (at_ s v) (at_ t v);
  same_record : forall j, ~ ids j -> record t j = record s j;
  all_fine : forall v, fine t v;
  stays_at_x : at_x s x -> at_x t x }.

Lemma follow_refl x ids e v o : follow x ids e v o o.
Proof. split; [left; easy|easy|]. intros j own _ _ K. split; [exact K|right; trivial]. Qed.

Lemma advance_refl x ids s : (forall v, fine s v) -> advance x ids s s.
Proof. intro F. split; trivial. intro v. apply follow_refl. Qed.

Lemma follow_trans x ids e v a b c : follow x ids e v a b -> follow x ids e v b c -> follow x ids e v a c.
Proof.
  intros [P T K] [P' T' K']. split.
  - destruct P as [[A B]|[A B]], P' as [[A' B']|[A' B']].
    + left. split; congruence.
    + right. rewrite <- A, <- B. now split.
    + right. rewrite A', B'. now split.
    + right. split; [exact A'|]. rewrite A, dist_zero in B'. lra.
  - intro E. now apply T', T.
  - intros j own U N H. destruct (K j own U N H) as [H1 T1]. destruct (K' j own U N H1) as [H2 T2]. split; [exact H2|].
    destruct T2 as [T2|T2]; [now left|]. destruct T1 as [T1|T1]; [left; now apply T'|right]. intro Q. now apply T2, T1.
Qed.

Lemma advance_trans x ids s t u : advance x ids s t -> advance x ids t u -> advance x ids s u.
Proof.
  intros [A B C D E F G] [A' B' C' D' E' F' G']. split; try congruence; trivial.
  - intro v. apply follow_trans with (at_ t v); [apply D|]. rewrite <- B. apply D'.
  - intros j N. rewrite E', E; trivial.
  - intro H. now apply G', G.
Qed.

Lemma advance_more x (ids ids' : Z -> Prop) s t : (forall j, ids j -> ids' j) -> advance x ids s t -> advance x ids' s t.
Proof.
  intros I [A B C D E F G]. split; trivial.
  - intro v. destruct (D v) as [P T K]. split; trivial. intros j own U N. apply K; [exact U|]. intro Q. now apply N, I.
  - intros j N. apply E. intro Q. now apply N, I.
Qed.

Section carried.
Variables (x : placement) (ids : Z -> Prop) (s t : state).
Hypothesis A : advance x ids s t.

Lemma base_grows v : base (at_ s v) <= base (at_ t v).
Proof. destruct (path_grows _ _ _ _ _ _ (follows _ _ _ _ A v)) as [[_ ->]|[_ B]]; [lra|]. generalize (dist_nonneg (fixed (at_ s v)) (x v)). lra. Qed.

Lemma path_carried r o v : dist (r v) (fixed (at_ s v)) <= base (at_ s v) - o -> dist (r v) (fixed (at_ t v)) <= base (at_ t v) - o.
Proof.
  destruct (path_grows _ _ _ _ _ _ (follows _ _ _ _ A v)) as [[-> ->]|[-> B]]; [trivial|].
  generalize (dist_triangle (r v) (fixed (at_ s v)) (x v)). lra.
Qed.

Lemma near_fixed_carried r a v : near x r a v -> near (fixed_of s) r a v -> near (fixed_of t) r a v.
Proof. unfold near, fixed_of. destruct (path_grows _ _ _ _ _ _ (follows _ _ _ _ A v)) as [[-> _]|[-> _]]; trivial. Qed.

Lemma sane_carried i c : ~ ids i -> sane s i c -> sane t i c.
Proof.
  intros N [B C E F G]. split; rewrite ?(same_record _ _ _ _ A i N); trivial.
  - intros v H. now apply path_carried, F.
  - intros v H. destruct (G v H) as [K|K]; [now left|right]. generalize (base_grows v). lra.
Qed.

Lemma close_carried i c : ~ ids i -> close s x i c -> close t x i c.
Proof.
  intros N C v H. rewrite (same_record _ _ _ _ A i N). destruct (C v H) as [P Q]. split; [exact P|]. now apply near_fixed_carried.
Qed.

Lemma good_carried i c : ~ ids i -> good s x (touched s) i c -> good t x (touched t) i c.
Proof.
  intros N [B C D E]. assert (S := sane_carried i c N B). split; [exact S|now apply close_carried| |]; intros v H;
    rewrite (same_record _ _ _ _ A i N); destruct (keeps _ _ _ _ _ _ (follows _ _ _ _ A v) i _ (used _ _ _ B v H) N (D v H)) as [K T].
  - exact K.
  - unfold touched. rewrite (same_epoch _ _ _ _ A). destruct T as [T|T]; [now left|].
    destruct (E v H) as [O|O]; [left; now apply (stays_touched _ _ _ _ _ _ (follows _ _ _ _ A v))|right; now apply T].
Qed.
End carried.

(* ---- One vertex is changed ---- *)

Lemma put_at_advance x i e v s : (forall w, fine s w) -> is_id i -> in_use e -> advance x (eq i) s (put_at i e v s).
Proof.
  intros F I U. split; trivial; simpl.
  - intro w. unfold set. destruct (same_vertex v w) as [<-|_]; [|apply follow_refl]. split; simpl; [left; easy|easy|].
    intros j own _ N K. split; [|right; trivial]. apply put_kept; [exact I|left; split; [intros ->; now apply N|exact K]].
  - intro w. destruct (F w) as [B P X P' S]. unfold put_at. split; simpl; unfold set; destruct (same_vertex v w) as [<-|_]; simpl; trivial.
    now apply put_proper.
  - intros A w. unfold touched. simpl. unfold set. destruct (same_vertex v w) as [<-|_]; [exact (A v)|exact (A w)].
Qed.

Lemma anchor_touched x s v : touched (anchor x s v) v.
Proof.
  unfold anchor, touched. destruct (stamp (at_ s v) =? epoch s)%Z eqn:E; [now apply Z.eqb_eq|]. simpl. rewrite set_same.
  destruct (same_position _ _); reflexivity.
Qed.

Lemma anchor_advance x s v : (forall w, fine s w) -> Valid x -> advance x (fun _ => False) s (anchor x s v).
Proof.
  intros F X. unfold anchor. destruct (stamp (at_ s v) =? epoch s)%Z eqn:E; [now apply advance_refl|].
  destruct (F v) as [B P X' P' S]. destruct (path_length_above (base (at_ s v)) (fixed (at_ s v)) (x v) B P X' (X v)) as [R R'].
  assert (Q := dist_nonneg (fixed (at_ s v)) (x v)).
  split; trivial; simpl.
  - intro w. unfold set. destruct (same_vertex v w) as [<-|_]; [|apply follow_refl].
    destruct (same_position _ _); (split; simpl; [|easy|]).
    + left. easy.
    + intros j own _ _ K. split; [exact K|now left].
    + right. split; [reflexivity|exact R'].
    + intros j own _ _ K. split; [exact K|now left].
  - intro w. destruct (F w) as [B1 P1 X1 P1' S1].
    split; simpl; unfold set; destruct (same_vertex v w) as [<-|_]; trivial; destruct (same_position _ _); simpl; trivial;
      unfold path_length; try lra; try lia.
  - intros A w. unfold touched. simpl. unfold set. destruct (same_vertex v w) as [<-|_].
    + intros _. destruct (same_position _ _) eqn:D; simpl; (split; [|now left]); [symmetry; now apply same_position_right|reflexivity].
    + intro T. destruct (A w T). now split; [|right].
Qed.

Lemma advance_touched x ids s t v : advance x ids s t -> touched s v -> touched t v.
Proof. intros A T. unfold touched. rewrite (same_epoch _ _ _ _ A). now apply (stays_touched _ _ _ _ _ _ (follows _ _ _ _ A v)). Qed.

(* ---- Writing a certificate at x ---- *)

Lemma half_of_sum b t : number b -> number t -> 0 <= b -> 0 <= t -> value (half (sum_lower b t)) <= b + t.
Proof.
  intros B T B0 T0. generalize (sum_lower_below b t B T B0 T0). intro S. destruct (Rlt_le_dec 0 (sum_lower b t)) as [P|P].
  - apply Rle_trans with (2 := S), half_below. lra.
  - rewrite half_clips, value_0; lra.
Qed.

Section writing.
Variables (x : placement) (i : Z) (t : num).
Hypothesis X : Valid x.
Hypothesis I : is_id i.

Lemma write_point_advance s v : (forall w, fine s w) -> advance x (eq i) s (write_point x i t s v).
Proof.
  intro F. unfold write_point. assert (A := anchor_advance x s v F X).
  apply advance_trans with (anchor x s v); [now apply advance_more with (2 := A)|].
  apply put_at_advance; [exact (all_fine _ _ _ _ A)|exact I|apply half_range].
Qed.

Lemma write_point_done s v : let u := write_point x i t s v in
  touched u v /\ kept (listing (at_ u v)) i (half (sum_lower (base (at_ u v)) t)).
Proof.
  unfold write_point. simpl. split.
  - unfold touched. simpl. rewrite set_same. simpl. apply anchor_touched.
  - rewrite !set_same. simpl. apply put_kept; [exact I|right]. split; [reflexivity|lia].
Qed.

(* Of another vertex, or of the same again, it stays done. *)
Lemma write_point_stays s v w : touched s w -> kept (listing (at_ s w)) i (half (sum_lower (base (at_ s w)) t)) ->
  let u := write_point x i t s v in touched u w /\ kept (listing (at_ u w)) i (half (sum_lower (base (at_ u w)) t)).
Proof.
  intros T K. destruct (same_vertex v w) as [<-|N]; [apply write_point_done|]. cbv zeta.
  assert (E : at_ (write_point x i t s v) w = at_ s w).
  { unfold write_point, put_at, anchor. simpl. destruct (stamp (at_ s v) =? epoch s)%Z; simpl; rewrite !set_other by congruence; reflexivity. }
  unfold touched. rewrite E. split; [|exact K]. unfold write_point, anchor. simpl. destruct (stamp (at_ s v) =? epoch s)%Z; exact T.
Qed.

Lemma write_points l : forall s, (forall w, fine s w) -> let u := fold_left (write_point x i t) l s in
  advance x (eq i) s u /\
  forall w, In w l \/ (touched s w /\ kept (listing (at_ s w)) i (half (sum_lower (base (at_ s w)) t))) ->
    touched u w /\ kept (listing (at_ u w)) i (half (sum_lower (base (at_ u w)) t)).
Proof.
  induction l as [|v l IH]; intros s F; simpl.
  - split; [now apply advance_refl|]. intros w [[]|H]. exact H.
  - assert (A := write_point_advance s v F). destruct (IH _ (all_fine _ _ _ _ A)) as [B C]. split; [now apply advance_trans with (1 := A)|].
    intros w H. apply C. destruct H as [[<-|H]|[T K]]; [right; apply write_point_done|now left|right; now apply write_point_stays].
Qed.

Lemma set_record_advance s r : (forall w, fine s w) -> advance x (eq i) s (set_record s i r).
Proof.
  intro F. split; trivial; simpl.
  - intro v. apply follow_refl.
  - intros j N. apply set_other. congruence.
  - intro v. destruct (F v). now split.
Qed.
End writing.

Theorem evaluated_good x s k : Valid x -> is_id (id k) -> evaluated x k -> (forall w, fine s w) -> at_x s x -> let t := commit_evaluated x s k in
  advance x (eq (id k)) s t /\ good t x (touched t) (id k) (of k).
Proof.
  intros X I [S P N] F A. cbv zeta. unfold commit_evaluated, set_written. destruct (write_points x (id k) (bound k) X I (points (of k)) s F) as [B D].
  set (u := fold_left _ _ s) in *. set (r := {| expiry := _ |}).
  assert (C := set_record_advance x (id k) u r (all_fine _ _ _ _ B)). split; [now apply advance_trans with (1 := B)|].
  assert (E : record (set_record u (id k) r) (id k) = r) by (simpl; apply set_same).
  assert (at_u := stays_at_x _ _ _ _ B A).
  assert (G : forall v, In v (points (of k)) -> fixed (at_ u v) = x v).
  { intros v H. destruct (D v (or_introl H)) as [T _]. apply (at_u v T). }
  split; [split|..]; rewrite ?E; trivial.
  - intros v _. apply half_range.
  - intros v H. simpl. rewrite (G v H), dist_zero. lra.
  - intros v H. left. simpl. destruct (all_fine _ _ _ _ B v). now apply half_of_sum.
  - intros v H. rewrite E. split; right; [reflexivity|]. exact (G v H).
  - intros v H. rewrite E. exact (proj2 (D v (or_introl H))).
  - intros v H. left. exact (proj1 (D v (or_introl H))).
Qed.
End keep.
