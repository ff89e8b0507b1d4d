(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The transcription run against the code: answers of the compiled empty_sphere_filter of src/annulus/certificate/ladder_2.h, which
   circle_b gives bit for bit. Coordinates of magnitude 1, 1e20 and 1e-30, and two cases that are negative. *)
Require Import ZArith.
From Flocq Require Import IEEE754.BinarySingleNaN.
From Annulus Require Import float_ieee float_ieee_2.
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
