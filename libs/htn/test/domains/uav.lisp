; SPDX-License-Identifier: Apache-2.0
; Photographs of given places by UAVs that start and land at their bases. Places are shared among
; the UAVs first; each then flies its own tour while the others fly theirs.

(defdomain uav (
  ;; --- what the vehicles do

  (:operator (!takeoff ?u)
    ((on-ground ?u) (base ?u ?b))
    ((on-ground ?u))
    ((flying ?u) (at ?u ?b))
    10)

  (:operator (!land ?u)
    ((flying ?u) (base ?u ?b) (at ?u ?b))
    ((flying ?u) (at ?u ?b))
    ((on-ground ?u))
    5)

  ;; Moving costs the energy of the distance, and that much time.
  (:operator (!goto ?u ?from ?to)
    ((flying ?u) (at ?u ?from) (reach ?u ?from ?to ?d ?left) (energy ?u ?e))
    ((at ?u ?from) (energy ?u ?e))
    ((at ?u ?to) (energy ?u ?left))
    ?d)

  (:operator (!charge ?u ?station)
    ((at ?u ?station) (station ?station) (energy ?u ?e) (capacity ?u ?full))
    ((energy ?u ?e))
    ((energy ?u ?full))
    (* 0.5 (- ?full ?e)))

  ;; Nothing moves the vehicle while its shutter is open.
  (:operator (!open-shutter ?u ?p)
    ((at ?u ?p))
    ()
    ((:protection (at ?u ?p)) (exposing ?u ?p))
    0)

  (:operator (!close-shutter ?u ?p ?seconds)
    ((exposing ?u ?p))
    ((:protection (at ?u ?p)) (exposing ?u ?p))
    ((shot ?p))
    ?seconds)

  (:operator (!!give ?p ?u) () () ((job ?u ?p)) 0)

  ;; --- what they are told

  (:method (mission ?places)
    tours
    ()
    (:ordered (share ?places) (fly-all)))

  ;; Each place goes to the UAV whose base is nearest.
  (:method (share ())
    nothing-left () ())
  (:method (share (?p . ?rest))
    to-the-nearest
    (:sort-by ?d #'< ((base ?u ?b) (distance ?b ?p ?d)))
    (:ordered (!!give ?p ?u) (share ?rest)))

  ;; All tours, in any order of their tasks.
  (:method (fly-all)
    two
    ((before ?u ?v))
    (:unordered (fly ?u) (fly ?v))
    one
    ((base ?u ?_b))
    ((fly ?u)))

  (:method (fly ?u)
    stay-home
    ((not (job ?u ?_p)))
    ()
    tour
    ()
    (:ordered (!takeoff ?u) (visit ?u) (come-back ?u)))

  (:method (visit ?u)
    next
    (:first (job ?u ?p) (not (shot ?p)))
    (:ordered (go ?u ?p) (:immediate shoot ?u ?p) (visit ?u))
    done
    ()
    ())

  (:method (shoot ?u ?p)
    exposure
    ((exposure ?p ?seconds))
    (:ordered (!open-shutter ?u ?p) (!close-shutter ?u ?p ?seconds)))

  (:method (go ?u ?p)
    there
    ((at ?u ?p))
    ()
    direct
    ((at ?u ?here) (reach ?u ?here ?p ?_d ?_left))
    ((!goto ?u ?here ?p)))

  (:method (go ?u ?p)
    by-a-station
    ((at ?u ?here) (station ?s) (different ?s ?here) (different ?s ?p)
     (reach ?u ?here ?s ?_d ?_left))
    (:ordered (!goto ?u ?here ?s) (!charge ?u ?s) (go ?u ?p)))

  (:method (come-back ?u)
    home
    ((base ?u ?b))
    (:ordered (go ?u ?b) (:immediate !land ?u)))

  ;; --- what is true

  ;; The table of distances is given one way.
  (:- (distance ?a ?b ?d)
    forth ((road ?a ?b ?d))
    back ((road ?b ?a ?d)))

  (:- (reach ?u ?from ?to ?d ?left)
    enough-energy
    ((distance ?from ?to ?d) (energy ?u ?e) (assign ?left (- ?e ?d)) (eval (>= ?left 0))))

  (:- (different ?x ?y) ((not (same ?x ?y))))
  (:- (same ?x ?x) ())))

(defproblem one-uav uav
  ((base karma ground) (on-ground karma) (energy karma 100) (capacity karma 100)
   (exposure lake 20)
   (road ground lake 12))
  ((mission (lake))))

(defproblem two-uavs uav
  ((base karma ground) (on-ground karma) (energy karma 60) (capacity karma 60)
   (base marvin hill) (on-ground marvin) (energy marvin 40) (capacity marvin 40)
   (before karma marvin)
   (exposure lake 20) (exposure wood 15) (exposure village 30)
   (station tower)
   (road ground lake 12) (road ground wood 40) (road ground village 50) (road ground tower 9)
   (road hill lake 30) (road hill wood 18) (road hill village 22) (road hill tower 25)
   (road lake wood 20) (road lake village 35) (road lake tower 8)
   (road wood village 10) (road wood tower 30) (road village tower 6))
  ((mission (lake wood village))))

; Karma's energy does not reach, and there is no station.
(defproblem too-far uav
  ((base karma ground) (on-ground karma) (energy karma 30) (capacity karma 30)
   (exposure lake 20) (exposure village 30)
   (road ground lake 12) (road ground village 50) (road lake village 35))
  ((mission (lake village))))
