; SPDX-License-Identifier: Apache-2.0
; Karma's mission of figure VI.8 (T VI.2.3): take off, look at P1 for 20 s, detect over Z2 for 300 s, land.
; Plan it with the world and the vehicle beside this file:
;   skein plan comets.lisp karma.lisp --world seeds.yaml --vehicle seeds-uav.yaml --taskreq
(defproblem karma comets-domain2
  ; initial state
  ((current-plan main)
   (takeoffloc zero)
   (landloc zero)
   (uavloc grounded zero)
   (my-write-time uavloc ((num 0) (num 0)) end none)
   (my-read-time uavloc ((num 0) (num 0)) end none)
   (perception-device free 'singlecam)
   (my-write-time perception-device 'singlecam ((num 0) (num 0)) end none)
   (my-read-time perception-device 'singlecam ((num 0) (num 0)) end none)
   (task-id 100))
  ; goals
  ((:task general-takeoff nil 700)
   (:task general-combined-goto-and-takeshot P1 20 nil 701)
   (:task perform-detection Z2 P2 300 nil 702)
   (:task general-land nil 703)))
