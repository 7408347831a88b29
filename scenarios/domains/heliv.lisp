; SPDX-License-Identifier: Apache-2.0
; Heliv's mission of figure VI.11 (T VI.2.3): confirm the alarm alone, then monitor it together with Marvin. 20 is Marvin,
; 21 is Heliv.
(defproblem heliv1 comets-domain2
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
   (task-id 20))
  ; goals
  ((:task general-takeoff nil 800)
   (:task general-combined-goto-and-takeshot lousa-fire 30 nil 801)
   (:task general-combined-goto-and-synchro-and-takeshot 551 (20 21) (20 21) lousa-fire 120 nil 802)
   (:task general-land nil 803)))
