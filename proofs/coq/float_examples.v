(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The transcription run against the code: answers of the compiled empty_sphere_filter of src/annulus/certificate/ladder_2.h, which
   circle_b gives bit for bit, and terms in space. Coordinates of magnitude 1, 1e20 and 1e-30, and two cases that are negative. *)
Require Import ZArith List.
From Flocq Require Import IEEE754.BinarySingleNaN.
From Annulus Require Import float_terms_3 float_ieee float_ieee_2.
Import ListNotations.
Open Scope Z_scope.

Definition bits (answer : option (Z * bin)) :=
  match answer with Some (sign, tolerance) => Some (sign, B2SF tolerance) | None => None end.

Lemma code_1 :
  bits (circle_b (constant 3602879701896397 (-55)) (constant 3602879701896397 (-54)) (constant 5854679515581645 (-52))
  (constant 1 (-2)) (constant 5404319552844595 (-53)) (constant (-3152519739159347) (-52)) (constant 2476979795053773
  (-52)) (constant 4278419646001971 (-51))) = bits (Some (1, (constant 5364212846228673 (-54)))).
Proof. vm_compute. reflexivity. Qed.
Lemma code_2 :
  bits (circle_b (constant 3602879701896397 (-55)) (constant 3602879701896397 (-54)) (constant 5854679515581645 (-52))
  (constant 1 (-2)) (constant 5404319552844595 (-53)) (constant 3602879701896397 (-55)) (constant 3152519739159347 (-52))
  (constant 8106479329266893 (-53))) = bits (Some (-1, constant 0 0)).
Proof. vm_compute. reflexivity. Qed.
Lemma code_3 :
  bits (circle_b (constant 3602879701896397 (-55)) (constant 3602879701896397 (-54)) (constant 5854679515581645 (-52))
  (constant 1 (-2)) (constant 5404319552844595 (-53)) (constant 3422735716801577 (-54)) (constant 5404319552844595 (-53))
  (constant 5404319552844595 (-54))) = bits (Some (-1, constant 0 0)).
Proof. vm_compute. reflexivity. Qed.
Lemma code_4 :
  bits (circle_b (constant 95367431640625 (20)) (constant 57220458984375 (19)) (constant (-95367431640625) (21)) (constant
  26702880859375 (18)) (constant (-19073486328125) (21)) (constant 858306884765625 (20)) (constant (-95367431640625) (19))
  (constant (-286102294921875) (20))) = bits (Some (1, (constant 8560402659984083 (14)))).
Proof. vm_compute. reflexivity. Qed.
Lemma code_5 :
  bits (circle_b (constant 178405961588245 (-147)) (constant 6850788924988607 (-154)) (constant (-178405961588245) (-146))
  (constant 7992587079153375 (-153)) (constant (-35681192317649) (-146)) (constant 6422614617176819 (-149)) (constant
  (-178405961588245) (-148)) (constant (-8563486156235759) (-151))) = bits (Some (1, (constant 1094571503900847 (-149)))).
Proof. vm_compute. reflexivity. Qed.

(* In space: the terms of annulus_terms in src/annulus/certificate/width_terms_3.h, the squared norms of each partition (of n, then
   of m), the sums of lambda, the cells and their largest slabs. *)
Definition squared_norm := square bin badd bmul.
Definition largest_norm (l : list (vector bin)) : bin := fold_right (fun v r => bmax (squared_norm v) r) (constant 0 0) l.
Definition space (t : bicell bin) : list bin :=
  [determinant t; squared_norm (n1 t); squared_norm (m1 t); squared_norm (n2 t); squared_norm (m2 t); squared_norm (n3 t);
   squared_norm (m3 t); squared_norm (n4 t); squared_norm (m4 t); l1 t; l2 t; l3 t; minus_l4 t; cell_p t; cell_q t;
   largest_norm (slabs_p t); largest_norm (slabs_q t)].

Lemma code_space :
  map B2SF (space (bicell_terms bin badd bsub bmul Bopp (Vector (constant (2476979795053773) (-51)) (constant
  (3602879701896397) (-54)) (constant (-5404319552844595) (-54))) (Vector (constant (5404319552844595) (-55)) (constant
  (8106479329266893) (-53)) (constant (1261007895663739) (-54))) (Vector (constant (3602879701896397) (-53)) (constant
  (5404319552844595) (-54)) (constant (-7656119366529843) (-52))) (Vector (constant (3152519739159347) (-53)) (constant
  (8106479329266893) (-54)) (constant (2589569785738035) (-50))))) = map B2SF [constant (3717972005123617) (-48); constant
  (1232604454817165) (-45); constant (2077673414892813) (-43); constant (61752723383243) (-38); constant
  (6306115322271443) (-44); constant (7009437109138657) (-46); constant (8463563716402953) (-45); constant
  (6624354938963419) (-44); constant (8759258681740069) (-45); constant (8573727790606583) (-51); constant
  (1425670757039473) (-49); constant (750834500375675) (-48); constant (2719048275024937) (-50); constant
  (3501548710280561) (-51); constant (2536089540163011) (-50); constant (4834208876015765) (-50); constant
  (8886568931346989) (-50)].
Proof. vm_compute. reflexivity. Qed.
