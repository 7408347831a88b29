; SPDX-License-Identifier: Apache-2.0
; Crates of relief goods by drone or by van: routes of different costs, so that the first plan, the
; cheapest and the shallowest differ.

(defdomain relief (
  (:operator (!load ?c ?v ?p)
    ((crate-at ?c ?p) (vehicle-at ?v ?p))
    ((crate-at ?c ?p))
    ((aboard ?c ?v)))
  (:operator (!unload ?c ?v ?p)
    ((aboard ?c ?v) (vehicle-at ?v ?p))
    ((aboard ?c ?v))
    ((crate-at ?c ?p)))
  (:operator (!drive ?v ?from ?to)
    ((vehicle-at ?v ?from) (link road ?from ?to ?km))
    ((vehicle-at ?v ?from))
    ((vehicle-at ?v ?to))
    (* 2 ?km))
  (:operator (!hop ?v ?from ?to)
    ((vehicle-at ?v ?from) (link air ?from ?to ?km))
    ((vehicle-at ?v ?from))
    ((vehicle-at ?v ?to))
    (+ 3.5 ?km))
  (:operator (!!seen ?v ?p) () () ((seen ?v ?p)) 0)
  (:operator (!!forget ?v) () ((forall (?p) ((seen ?v ?p)) ((seen ?v ?p)))) () 0)

  (:method (deliver ?c ?goal)
    done
    ((crate-at ?c ?goal))
    ()
    carry
    ((crate-at ?c ?p) (vehicle ?v ?_kind))
    (:ordered (move ?v ?p) (!load ?c ?v ?p) (move ?v ?goal) (!unload ?c ?v ?goal)))

  (:method (move ?v ?goal)
    start
    ((vehicle-at ?v ?here))
    (:ordered (!!seen ?v ?here) (travel ?v ?goal) (!!forget ?v)))

  (:method (travel ?v ?goal)
    there
    ((vehicle-at ?v ?goal))
    ()
    on
    ((vehicle-at ?v ?here) (vehicle ?v ?kind) (link ?kind ?here ?next ?_km) (not (seen ?v ?next)))
    (:ordered (step ?kind ?v ?here ?next) (!!seen ?v ?next) (travel ?v ?goal)))

  (:method (step road ?v ?from ?to) () ((!drive ?v ?from ?to)))
  (:method (step air ?v ?from ?to) () ((!hop ?v ?from ?to)))

  (:- (link ?kind ?a ?b ?km) ((way ?kind ?a ?b ?km)))
  (:- (link ?kind ?a ?b ?km) ((way ?kind ?b ?a ?km)))))

(defproblem one-crate relief
  ((vehicle van road) (vehicle-at van depot) (vehicle drone air) (vehicle-at drone depot)
   (crate-at tents depot)
   (way road depot bridge 4) (way road bridge camp 5) (way road depot camp 12) (way air depot camp 7))
  ((deliver tents camp)))

(defproblem two-crates relief
  ((vehicle van road) (vehicle-at van depot)
   (crate-at tents depot) (crate-at water bridge)
   (way road depot bridge 4) (way road bridge camp 5) (way road depot camp 12))
  ((deliver tents camp) (deliver water camp)))

(defproblem island relief
  ((vehicle van road) (vehicle-at van depot) (crate-at tents depot)
   (way road depot bridge 4) (way air depot island 9))
  ((deliver tents island)))
