; SPDX-License-Identifier: Apache-2.0
; As many steps as the number says: plans of any length.

(defdomain counter (
  (:operator (!tick ?n) ((now ?n) (assign ?next (+ ?n 1))) ((now ?n)) ((now ?next)))
  (:method (count-to ?end)
    more ((now ?n) (eval (< ?n ?end))) (:ordered (!tick ?n) (count-to ?end))
    done () ())))

(defproblem ten counter ((now 0)) ((count-to 10)))
(defproblem thousand counter ((now 0)) ((count-to 1000)))
