; SPDX-License-Identifier: Apache-2.0
; Marvin's mission of figure VI.11 (T VI.2.3): already in the air, it monitors the alarm together with Heliv.
(defproblem marvin2 comets-domain2
  ; initial state
  ((current-plan main)
   (takeoffloc zero)
   (landloc zero)
   (uavloc flying (LOC 30.0 -30.0 40.0))
   (my-write-time uavloc ((num 0) (num 0)) end none)
   (my-read-time uavloc ((num 0) (num 0)) end none)
   (perception-device free 'singlecam)
   (my-write-time perception-device 'singlecam ((num 0) (num 0)) end none)
   (my-read-time perception-device 'singlecam ((num 0) (num 0)) end none)
   (task-id 40))
  ; goals
  ((:task general-combined-goto-and-synchro-and-takeshot 551 (20 21) (20 21) lousa-fire 120 nil 900)
   (:task general-land nil 901)))
