; SPDX-License-Identifier: Apache-2.0
; Errors on purpose, for what a reader says of them.
(defdomain wrong (
  (:operator (!take ?x) ((here ?x)) ((here ?x)) ((held ?x)) (cheapest ?x))
  (:method (get ?x) ((here ?x)))))
(defproblem p wrong ((here box) (here ?y)) ((get box)))
