; SPDX-License-Identifier: Apache-2.0
; What the UAVs of COMETS may be asked to do, and what it comes down to (spec 3.3 to 3.5, T VI.2.3).
; docs/comets-domain.md explains it: tasks, facts, the functions of the host, how to add a task.
;
; Every task is (NAME ARGUMENT... TIME-CONSTRAINTS ORIGIN). Time constraints are nil or (START-BEFORE START-AFTER
; END-BEFORE END-AFTER), each nil or seconds since the plan's origin; all sub-tasks inherit them. ORIGIN is the number of
; the high-level task.

; --- intervals: ((num LEAST) (num MOST)), MOST may be `unlimited`

(defun low (interval) (cadr (first interval)))
(defun high (interval) (cadr (second interval)))
(defun interval (least most) (list (list 'num least) (list 'num most)))
(defun later (a b) (cond ((eq a 'unlimited) a) ((eq b 'unlimited) b) (t (max a b))))
(defun plus (a b) (if (or (eq a 'unlimited) (eq b 'unlimited)) 'unlimited (+ a b)))
(defun after (start duration)
  (interval (plus (low start) (low duration)) (plus (high start) (high duration))))
(defun latest (a b)
  (interval (max (low a) (low b)) (later (high a) (high b))))
; Reads are (INTERVAL EVENT TASK).
(defun latest-of (written reads)
  (let ((all written))
    (dolist (one reads) (setq all (latest all (first one))))
    all))
; Not before START-AFTER, and so late that it cannot end before END-AFTER.
(defun not-before (start duration constraints)
  (let ((bound (low start)))
    (when (second constraints) (setq bound (max bound (second constraints))))
    (when (fourth constraints) (setq bound (max bound (- (fourth constraints) (low duration)))))
    (interval bound (later (high start) bound))))

; --- dependences: ((ended 102) ...)

(defun dependence (event task)
  (if (eq task 'none) nil
    (list (list (case event (over 'over) (running 'running) (t 'ended)) task))))
(defun dependences-of (reads)
  (let ((all nil))
    (dolist (one reads) (setq all (append (dependence (second one) (third one)) all)))
    all))

; All of the first, and what the second has beside them.
(defun joined (a b)
  (let ((all a))
    (dolist (one b) (unless (member one a :test 'equal) (setq all (append all (list one)))))
    all))

; Those of the order first, and in it; then what it does not know.
(defun in-order (all order)
  (append (remove-if-not (lambda (one) (member one all)) order)
          (remove-if (lambda (one) (member one order)) all)))

; --- what was done of a high-level task before: ((looked DEVICE LOC S) (reached LOC) (waited S) (synchronised ID)
; --- (rest DEVICE LOC...))

(defun total (kind done)
  (let ((all 0))
    (dolist (one done) (when (eq (first one) kind) (setq all (+ all (first (last one))))))
    all))
; What is less than half a second is done.
(defun left-of (wanted before) (if (< (- wanted before) 0.5d0) 0 (- wanted before)))
(defun left-to-look (wanted done) (left-of wanted (total 'looked done)))
(defun left-to-wait (wanted done) (if (numberp wanted) (left-of wanted (total 'waited done)) wanted))
; From near places it looks the same: what drives looks from nearer than what flies.
(defun is-near (how a b)
  (let ((x (- (second a) (second b))) (y (- (third a) (third b))))
    (< (+ (* x x) (* y y)) (if (eq how 'driving) 25 400))))
(defun is-look-from (how at one) (and (eq (first one) 'looked) (is-near how (third one) at)))
(defun left-to-look-from (how at wanted done)
  (left-of wanted (total 'looked (remove-if-not (lambda (one) (is-look-from how at one)) done))))
(defun done-elsewhere (how at done) (remove-if (lambda (one) (is-look-from how at one)) done))
(defun reached-before (done)
  (mapcar (lambda (one) (second one)) (remove-if-not (lambda (one) (eq (first one) 'reached)) done)))
(defun has-met (sync done) (member (list 'synchronised sync) done :test 'equal))
; What is left of lanes is another than it was.
(defun with-rest (device way done)
  (cons (cons 'rest (cons device way)) (remove-if (lambda (one) (eq (first one) 'rest)) done)))
(defun at-most (count all) (if (and all (> count 0)) (cons (first all) (at-most (- count 1) (rest all))) nil))

; --- answers of refiners: ((destination LOC) (duration LEAST MOST) (energy E) (cost C) (params (NAME VALUE...)...))

(defun get-destination (data) (second (assoc 'destination data)))
(defun get-duration (data)
  (interval (second (assoc 'duration data)) (third (assoc 'duration data))))
(defun get-entry (data) (second (assoc 'way (rest (assoc 'params data)))))
(defun get-beyond (data) (rest (assoc 'beyond data)))
(defun get-aim (data) (second (assoc 'aim data)))
(defun from-then-on (when) (list 'suited (interval (low when) 'unlimited)))
(defun get-cost (data) (second (assoc 'cost data)))
(defun get-params (type data)
  (cons (list 'type type) (cons (assoc 'energy data) (rest (assoc 'params data)))))

(defdomain comets-domain2 (

  ; ================ what may be asked: (high-level-task NAME (KIND...) (USE...))

  (:- (high-level-task general-takeoff () ()) ())
  (:- (high-level-task general-land () ()) ())
  (:- (high-level-task leave-closed-air () ()) ())
  (:- (high-level-task general-gotoxyz (place) ()) ())
  (:- (high-level-task general-combined-goto-and-takeshot (place duration) (perception)) ())
  (:- (high-level-task general-combined-goto-and-synchro-and-takeshot (sync-id uavs uavs place duration) (perception)) ())
  (:- (high-level-task perceive (place duration) (perception)) ())
  (:- (high-level-task perform-detection (zone place duration) (detection)) ())
  (:- (high-level-task perform-mapping (zone) (mapping)) ())
  (:- (high-level-task map-part (zone number number) (mapping)) ())
  (:- (high-level-task perform-tour (places) ()) ())
  (:- (high-level-task perform-monitoring (place duration) (perception)) ())
  (:- (high-level-task monitor-until (place sync-id uavs sync-id uav) (perception)) ())
  (:- (high-level-task send-signal (sync-id uavs) ()) ())
  (:- (high-level-task takeshot-while-waiting (duration) (perception)) ())
  (:- (high-level-task synchro (sync-id uavs uavs) ()) ())
  (:- (high-level-task wait-until-synchro (sync-id uavs uavs) ()) ())
  (:- (high-level-task general-wait (duration) ()) ())
  (:- (high-level-task wait-for-orders () ()) ())
  (:- (high-level-task monitoring-with-relay (place place place duration uavs) ()) ())
  (:- (high-level-task cooperative-mapping (zone place place duration uavs) ()) ())
  (:- (high-level-task vehicle-pursuit (place place duration uavs) ()) ())

  ; ================ which device serves what, and which is better for it

  (:- (device-serves visible perception) ())
  (:- (device-serves ir perception) ())
  (:- (device-serves singlecam perception) ())
  (:- (device-serves mapping perception) ())
  (:- (device-serves fire-sensor perception) ())
  (:- (device-serves fire-sensor detection) ())
  (:- (device-serves ir detection) ())
  (:- (device-serves visible detection) ())
  (:- (device-serves singlecam detection) ())
  (:- (device-serves mapping detection) ())
  (:- (device-serves mapping mapping) ())
  (:- (device-serves singlecam mapping) ())

  (:- (best-first perception (visible ir singlecam mapping fire-sensor)) ())
  (:- (best-first detection (fire-sensor ir visible singlecam mapping)) ())
  (:- (best-first mapping (mapping singlecam)) ())

  ; Those on board that work, the best first; at least one. What is done with a device takes the first of them that its
  ; refiners agree to: (devices-for USE ?devices) (assign* ?device ?devices) at the head of a `:first`.
  (:- (devices-for ?use ?devices)
    ((setof ?d (working-device ?use ?d) ?all) (best-first ?use ?order) (assign ?devices (in-order ?all ?order))))
  (:- (working-device ?use ?device)
    ((perception-device free '?device) (device-serves ?device ?use)))

  ; ================ what was done of a task before it was interrupted

  ; Told by the problem, as facts; of most tasks nothing is, which is no warning.
  (:- (progress ?_origin ?_done) ((call null t)))
  (:- (done-before ?origin ?done)
    some ((progress ?origin ?done))
    none ((assign ?done nil)))

  ; ================ where to look from: the best side that there is a way to

  ; In air that is open until it has looked; else where air is open at some other time, that is waited for.
  (:- (view-for ?from ?place ?device ?when ?seconds ?to)
    best ((view-of ?from ?place ?device ?when ?when ?seconds ?to))
    another-side ((sides-for ?from ?place ?device ?when ?seconds 6 ?sides) (assign ?to (first ?sides)))
    after-a-wait ((assign ?open (from-then-on ?when)) (view-of ?from ?place ?device ?open ?when ?seconds ?to)))
  (:- (view-of ?from ?place ?device ?open ?when ?seconds ?to)
    ((assign ?view (compute-viewpoint ?place (list ?device) ?open ?seconds)) (call consp ?view)
     (assign ?there (within-reach ?from (rest ?view) ?when ?seconds)) (call consp ?there) (assign ?to (first ?there))))
  (:- (sides-for ?from ?place ?device ?when ?seconds ?count ?there)
    ((assign ?views (compute-angles ?place (list ?device) ?count ?when ?seconds)) (call consp ?views)
     (assign ?there (within-reach ?from (rest ?views) ?when ?seconds)) (call consp ?there)))
  ; Where this vehicle waits for its partners, and where they do: all reckon alike, whenever they come.
  (:- (meeting-for ?from ?place ?device ?senders ?receivers ?when ?to ?others)
    best ((meeting-at ?from ?place ?device ?senders ?receivers () ?when ?to ?others))
    after-a-wait
    ((assign ?open (from-then-on '((num 0) (num 0))))
     (meeting-at ?from ?place ?device ?senders ?receivers ?open ?when ?to ?others)))
  (:- (meeting-at ?from ?place ?device ?senders ?receivers ?open ?when ?to ?others)
    ((best-first perception ?order)
     (assign ?meeting (compute-meeting ?place ?device ?order ?senders ?receivers ?open)) (call consp ?meeting)
     (assign ?there (within-reach ?from (list (first ?meeting)) ?when 0)) (call consp ?there)
     (assign ?to (first ?there)) (assign ?others (rest ?meeting))))
  ; Up to three sides; others when there is no way to some of the best.
  (:- (three-sides-for ?from ?place ?device ?when ?seconds ?points)
    best ((assign ?views (compute-angles ?place (list ?device) 3 ?when ?seconds)) (call consp ?views)
          (assign ?points (within-reach ?from (rest ?views) ?when 0)) (call = (length ?points) (length (rest ?views))))
    others ((sides-for ?from ?place ?device ?when ?seconds 6 ?sides) (assign ?points (at-most 3 ?sides))))

  ; ================ what moves from where it is: what flies, and what keeps to the ground

  (:- (may-move flying) ())
  (:- (may-move driving) ())

  ; ================ air that is closed for a time

  ; Of a wait what can be spent before it takes off.
  (:- (spent-waiting flying ?_place ?_when ?wait ?wait) ((call numberp ?wait)))
  (:- (spent-waiting driving ?_place ?_when ?wait ?wait) ((call numberp ?wait)))
  (:- (spent-waiting grounded ?place ?when ?wait ?spent)
    may-take-off
    ((call numberp ?wait) (assign ?data (compute-takeoff ?place ?when)) (call consp ?data)
     (assign ?spent (- ?wait (second (assoc 'duration ?data)))) (call > ?spent 1))
    closed-over-it ((call numberp ?wait) (assign ?data (compute-takeoff ?place ?when)) (call null ?data) (assign ?spent ?wait)))

  ; ================ timelines: when a task may start, and what it depends on

  ; Who moves the vehicle, or keeps it where it is, waits for who did so last and for all who relied on it since.
  (:- (move-after ?earliest ?dependences)
    ((my-write-time uavloc ?written ?event ?task)
     (uavloc-reads ?reads)
     (assign ?earliest (latest-of ?written ?reads))
     (assign ?dependences (append (dependences-of ?reads) (dependence ?event ?task)))))
  (:- (uavloc-reads ?reads)
    some ((setof (?i ?e ?t) (my-read-time uavloc ?i ?e ?t) ?reads))
    none ((assign ?reads nil)))
  ; In which interval the next motion may begin.
  (:- (may-begin ?tc ?when)
    ((move-after ?earliest ?_dependences) (assign ?when (not-before ?earliest (interval 0 0) ?tc))))
  ; Who relies on what the vehicle is doing runs with it, and counts as done when that is.
  (:- (rely-on-motion ?earliest ?dependences)
    ((my-write-time uavloc ?earliest ?_event ?task)
     (assign ?dependences (dependence 'running ?task))))
  ; Who uses a device waits for its last use and for what was to come before the next one.
  (:- (use-after ?device ?earliest ?dependences)
    ((my-write-time perception-device '?device ?written ?event ?task)
     (device-reads ?device ?reads)
     (assign ?earliest (latest-of ?written ?reads))
     (assign ?dependences (append (dependences-of ?reads) (dependence ?event ?task)))))
  (:- (device-reads ?device ?reads)
    some ((setof (?i ?e ?t) (my-read-time perception-device '?device ?i ?e ?t) ?reads))
    none ((assign ?reads nil)))

  ; Where it is to land; the nearest ground that serves where that place does not.
  (:- (landing-place ?from ?tc ?place)
    ((landloc ?wanted) (may-begin ?tc ?when)
     (assign ?place (compute-landing-place ?from ?wanted ?when)) (not (call null ?place))))

  ; ================ convenience operators: refiners are asked, their answer is kept until a task uses it

  (:operator (!!lcompute-takeoff ?place ?when)
    ((assign ?data (compute-takeoff ?place ?when)) (call consp ?data))
    () ((eval-ok takeoff ?data)) 0)
  (:operator (!!lcompute-land ?from ?place)
    ((assign ?data (compute-land ?from ?place)) (call consp ?data))
    () ((eval-ok land ?data)) 0)
  (:operator (!!lcompute-way-out ?from)
    ((assign ?data (compute-way-out ?from)) (call consp ?data))
    () ((eval-ok gotoxyz ?data)) 0)
  (:operator (!!lcompute-gotoxyz ?from ?to ?when)
    ((assign ?data (compute-gotoxyz ?from ?to ?when)) (call consp ?data))
    () ((eval-ok gotoxyz ?data)) 0)
  (:operator (!!lcompute-gotoxyz-among ?from ?to ?others ?when)
    ((assign ?data (compute-gotoxyz-among ?from ?to ?others ?when)) (call consp ?data))
    () ((eval-ok gotoxyz ?data)) 0)
  (:operator (!!lcompute-patrol ?from ?zone ?device ?seconds ?when)
    ((assign ?data (compute-patrol ?from ?zone ?device ?seconds ?when)) (call consp ?data))
    () ((eval-ok gotoxyz ?data)) 0)
  ; What was set out for WHEN, and meets no closed air now that it is there.
  (:operator (!!lcompute-sweep ?from ?zone ?device ?when ?tc)
    ((assign ?data (compute-sweep ?from ?zone ?device ?when)) (call consp ?data) (may-begin ?tc ?now) (call is-open ?data ?now))
    () ((eval-ok gotoxyz ?data)) 0)
  (:operator (!!lcompute-rest ?from ?zone ?device ?before ?way ?when ?tc)
    ((assign ?data (compute-rest ?from ?zone ?device ?before ?way ?when)) (call consp ?data)
     (may-begin ?tc ?now) (call is-open ?data ?now))
    () ((eval-ok gotoxyz ?data)) 0)
  ; A part of lanes that were set out before, which leaves the others to the goal.
  (:operator (!!take-part ?part ?tc)
    ((may-begin ?tc ?now) (call is-open ?part ?now))
    () ((eval-ok gotoxyz ?part)) 0)
  (:operator (!!leave-rest ?goal ?device ?part)
    ((done-before ?goal ?done) (assign ?left (with-rest ?device (get-beyond ?part) ?done)))
    ((progress ?goal ?done)) ((progress ?goal ?left)) 0)
  (:operator (!!lcompute-stay ?seconds)
    ((assign ?data (compute-stay ?seconds)) (call consp ?data))
    () ((eval-ok stay ?data)) 0)
  ; What the next perception looks with, and at what: nil or ((target LOC)).
  (:operator (!!aim ?device ?target)
    () () ((aimed ?device ?target)) 0)
  ; Who synchronises next, and how long that takes.
  (:operator (!!agree ?sync ?senders ?receivers ?duration)
    () () ((agreed ?sync ?senders ?receivers ?duration)) 0)

  ; ================ actual operators: (!task-NAME ID DEPENDENCES PARAMS START DURATION TIME-CONSTRAINTS ORIGIN)

  (:operator (!task-takeoff ?id ?dependences ?params ?start ?duration ?tc ?origin)
    ((uavloc grounded ?from) (task-id ?id) (eval-ok takeoff ?data)
     (move-after ?earliest ?dependences)
     (assign ?params (get-params 'takeoff ?data))
     (assign ?duration (get-duration ?data))
     (assign ?start (not-before ?earliest ?duration ?tc))
     (call in-time 'takeoff ?origin ?start ?duration ?tc)
     (assign ?end (after ?start ?duration))
     (assign ?there (get-destination ?data))
     (assign ?next (+ ?id 1))
     (my-write-time uavloc ?w ?we ?wt))
    ((uavloc grounded ?from) (task-id ?id) (eval-ok takeoff ?data) (my-write-time uavloc ?w ?we ?wt)
     (forall (?r ?re ?rt) ((my-read-time uavloc ?r ?re ?rt)) ((my-read-time uavloc ?r ?re ?rt))))
    ((uavloc flying ?there) (task-id ?next) (my-write-time uavloc ?end end ?id))
    (get-cost ?data))

  (:operator (!task-land ?id ?dependences ?params ?start ?duration ?tc ?origin)
    ((uavloc flying ?from) (task-id ?id) (eval-ok land ?data)
     (move-after ?earliest ?dependences)
     (assign ?params (get-params 'land ?data))
     (assign ?duration (get-duration ?data))
     (assign ?start (not-before ?earliest ?duration ?tc))
     (call in-time 'land ?origin ?start ?duration ?tc)
     (assign ?end (after ?start ?duration))
     (assign ?there (get-destination ?data))
     (assign ?next (+ ?id 1))
     (my-write-time uavloc ?w ?we ?wt))
    ((uavloc flying ?from) (task-id ?id) (eval-ok land ?data) (my-write-time uavloc ?w ?we ?wt)
     (forall (?r ?re ?rt) ((my-read-time uavloc ?r ?re ?rt)) ((my-read-time uavloc ?r ?re ?rt))))
    ((uavloc grounded ?there) (task-id ?next) (my-write-time uavloc ?end end ?id))
    (get-cost ?data))

  (:operator (!task-gotoxyz ?id ?dependences ?params ?start ?duration ?tc ?origin)
    ((uavloc ?how ?from) (may-move ?how) (task-id ?id) (eval-ok gotoxyz ?data)
     (move-after ?earliest ?dependences)
     (assign ?params (get-params 'goto ?data))
     (assign ?duration (get-duration ?data))
     (assign ?start (not-before ?earliest ?duration ?tc))
     (call in-time 'gotoxyz ?origin ?start ?duration ?tc)
     (assign ?end (after ?start ?duration))
     (assign ?there (get-destination ?data))
     (assign ?next (+ ?id 1))
     (my-write-time uavloc ?w ?we ?wt))
    ((uavloc ?how ?from) (task-id ?id) (eval-ok gotoxyz ?data) (my-write-time uavloc ?w ?we ?wt)
     (forall (?r ?re ?rt) ((my-read-time uavloc ?r ?re ?rt)) ((my-read-time uavloc ?r ?re ?rt))))
    ((uavloc ?how ?there) (task-id ?next) (my-write-time uavloc ?end end ?id))
    (get-cost ?data))

  ; Waits some seconds, or as long as its stop says.
  (:operator (!task-wait ?id ?dependences ?params ?start ?duration ?tc ?origin)
    ((task-id ?id) (eval-ok stay ?data)
     (move-after ?earliest ?dependences)
     (assign ?params (get-params 'wait ?data))
     (assign ?duration (get-duration ?data))
     (assign ?start (not-before ?earliest ?duration ?tc))
     (uavloc ?_how ?at) (call stays-open ?at ?start ?duration)
     (call in-time 'wait ?origin ?start ?duration ?tc)
     (assign ?end (after ?start ?duration))
     (assign ?next (+ ?id 1))
     (my-write-time uavloc ?w ?we ?wt))
    ((task-id ?id) (eval-ok stay ?data) (my-write-time uavloc ?w ?we ?wt)
     (forall (?r ?re ?rt) ((my-read-time uavloc ?r ?re ?rt)) ((my-read-time uavloc ?r ?re ?rt))))
    ((task-id ?next) (my-write-time uavloc ?end end ?id))
    (get-cost ?data))

  ; The wait is over when what relied on it last is: then it was as long as it took.
  (:operator (!stop-wait ?wait ?dependences () ?start ?duration ?_tc ?_origin)
    ((my-write-time uavloc ?w end ?wait)
     (my-read-time uavloc ?start end ?what)
     (assign ?duration (interval 0 0))
     (assign ?dependences (dependence 'end ?what)))
    ((my-write-time uavloc ?w end ?wait)
     (forall (?r ?re ?rt) ((my-read-time uavloc ?r ?re ?rt)) ((my-read-time uavloc ?r ?re ?rt))))
    ((my-write-time uavloc ?start end ?wait))
    0)

  ; Pictures all along the motion that goes on; the stop follows. It runs with a task whose times were checked: its place
  ; on the timelines is the end of that.
  (:operator (!task-takeshot ?id ?dependences ?params ?start ?duration ?_tc ?_origin)
    ((task-id ?id) (aimed ?device ?target)
     (rely-on-motion ?moved ?running)
     (use-after ?device ?used ?uses)
     (assign ?start (latest ?moved ?used))
     (assign ?duration (interval 0 0))
     (assign ?dependences (joined ?running ?uses))
     (assign ?params (append (list (list 'type 'takeshot) (list 'device ?device)) ?target))
     (assign ?next (+ ?id 1))
     (my-write-time perception-device '?device ?w ?we ?wt))
    ((task-id ?id) (aimed ?device ?target) (my-write-time perception-device '?device ?w ?we ?wt)
     (forall (?q ?qe ?qt) ((my-read-time perception-device '?device ?q ?qe ?qt))
       ((my-read-time perception-device '?device ?q ?qe ?qt))))
    ((task-id ?next) (my-read-time uavloc ?start end ?id) (shooting ?id)
     (my-write-time perception-device '?device ?start end ?id))
    0)
  (:operator (!stop-takeshot ?shot ?dependences () ?start ?duration ?_tc ?_origin)
    ((shooting ?shot)
     (my-read-time uavloc ?start end ?shot)
     (my-write-time uavloc ?_written ?event ?motion)
     (assign ?duration (interval 0 0))
     (assign ?dependences (dependence ?event ?motion)))
    ((shooting ?shot)) () 0)

  ; Perceives for some seconds from where the vehicle is, which stays there.
  (:operator (!task-perception ?id ?dependences ?params ?start ?duration ?tc ?origin)
    ((task-id ?id) (eval-ok stay ?data) (aimed ?device ?target)
     (move-after ?moved ?moves)
     (use-after ?device ?used ?uses)
     (assign ?dependences (joined ?moves ?uses))
     (assign ?params (append (list (list 'type 'perceive) (list 'device ?device)) ?target (list (assoc 'energy ?data))
                             (rest (assoc 'params ?data))))
     (assign ?duration (get-duration ?data))
     (assign ?start (not-before (latest ?moved ?used) ?duration ?tc))
     (uavloc ?_how ?at) (call stays-open ?at ?start ?duration)
     (call in-time 'perception ?origin ?start ?duration ?tc)
     (assign ?end (after ?start ?duration))
     (assign ?next (+ ?id 1))
     (my-write-time uavloc ?w ?we ?wt)
     (my-write-time perception-device '?device ?v ?ve ?vt))
    ((task-id ?id) (eval-ok stay ?data) (aimed ?device ?target)
     (my-write-time uavloc ?w ?we ?wt) (my-write-time perception-device '?device ?v ?ve ?vt)
     (forall (?r ?re ?rt) ((my-read-time uavloc ?r ?re ?rt)) ((my-read-time uavloc ?r ?re ?rt)))
     (forall (?q ?qe ?qt) ((my-read-time perception-device '?device ?q ?qe ?qt))
       ((my-read-time perception-device '?device ?q ?qe ?qt))))
    ((task-id ?next) (my-write-time uavloc ?end end ?id) (my-write-time perception-device '?device ?end end ?id))
    (get-cost ?data))

  ; Likewise, until its stop.
  (:operator (!task-monitoring ?id ?dependences ?params ?start ?duration ?tc ?origin)
    ((task-id ?id) (aimed ?device ?target)
     (move-after ?moved ?moves)
     (use-after ?device ?used ?uses)
     (assign ?dependences (joined ?moves ?uses))
     (assign ?params (append (list (list 'type 'monitor) (list 'device ?device)) ?target))
     (assign ?duration (interval 0 0))
     (assign ?start (not-before (latest ?moved ?used) ?duration ?tc))
     (call in-time 'monitoring ?origin ?start ?duration ?tc)
     (assign ?next (+ ?id 1))
     (my-write-time uavloc ?w ?we ?wt)
     (my-write-time perception-device '?device ?v ?ve ?vt))
    ((task-id ?id) (aimed ?device ?target)
     (my-write-time uavloc ?w ?we ?wt) (my-write-time perception-device '?device ?v ?ve ?vt)
     (forall (?r ?re ?rt) ((my-read-time uavloc ?r ?re ?rt)) ((my-read-time uavloc ?r ?re ?rt)))
     (forall (?q ?qe ?qt) ((my-read-time perception-device '?device ?q ?qe ?qt))
       ((my-read-time perception-device '?device ?q ?qe ?qt))))
    ((task-id ?next) (my-write-time uavloc ?start end ?id) (my-write-time perception-device '?device ?start end ?id)
     (monitoring ?id ?device))
    0)
  (:operator (!stop-monitoring ?shot ?dependences () ?start ?duration ?_tc ?_origin)
    ((monitoring ?shot ?device)
     (my-write-time uavloc ?w end ?shot)
     (my-read-time uavloc ?start end ?what)
     (assign ?duration (interval 0 0))
     (assign ?dependences (dependence 'end ?what))
     (my-write-time perception-device '?device ?v end ?shot))
    ((monitoring ?shot ?device) (my-write-time uavloc ?w end ?shot)
     (my-write-time perception-device '?device ?v end ?shot)
     (forall (?r ?re ?rt) ((my-read-time uavloc ?r ?re ?rt)) ((my-read-time uavloc ?r ?re ?rt))))
    ((my-write-time uavloc ?start end ?shot) (my-write-time perception-device '?device ?start end ?shot))
    0)

  ; Synchronises while something else keeps the vehicle where it is; no perception begins before it is done.
  (:operator (!task-synchro ?id ?dependences ?params ?start ?duration ?tc ?origin)
    ((task-id ?id) (agreed ?sync ?senders ?receivers ?duration)
     (rely-on-motion ?earliest ?dependences)
     (assign ?params (list (list 'type 'synchronise) (list 'sync ?sync ?senders ?receivers)))
     (assign ?start (not-before ?earliest ?duration ?tc))
     (call in-time 'synchro ?origin ?start ?duration ?tc)
     (assign ?end (after ?start ?duration))
     (assign ?next (+ ?id 1)))
    ((task-id ?id) (agreed ?sync ?senders ?receivers ?duration))
    ((task-id ?next) (my-read-time uavloc ?end end ?id)
     (forall (?d) ((perception-device free '?d)) ((my-read-time perception-device '?d ?end end ?id))))
    0)

  ; Synchronises by itself: the vehicle stays where it is, and what follows waits for it.
  (:operator (!task-rendezvous ?id ?dependences ?params ?start ?duration ?tc ?origin)
    ((task-id ?id) (agreed ?sync ?senders ?receivers ?duration)
     (move-after ?earliest ?dependences)
     (assign ?params (list (list 'type 'rendezvous) (list 'sync ?sync ?senders ?receivers)))
     (assign ?start (not-before ?earliest ?duration ?tc))
     (call in-time 'rendezvous ?origin ?start ?duration ?tc)
     (assign ?end (after ?start ?duration))
     (assign ?next (+ ?id 1))
     (my-write-time uavloc ?w ?we ?wt))
    ((task-id ?id) (agreed ?sync ?senders ?receivers ?duration) (my-write-time uavloc ?w ?we ?wt)
     (forall (?r ?re ?rt) ((my-read-time uavloc ?r ?re ?rt)) ((my-read-time uavloc ?r ?re ?rt))))
    ((task-id ?next) (my-write-time uavloc ?end end ?id))
    0)

  ; What needs others is refined with them, when it is loaded: the roles are not known yet, so whoever takes part reckons
  ; with what the longest of them takes. The vehicle is over ?to then.
  (:operator (!task-joint ?id ?dependences ?params ?start ?duration ?tc ?origin)
    ((uavloc flying ?from) (task-id ?id) (joint ?type ?about ?duration ?to) (eval-ok stay ?data)
     (move-after ?earliest ?dependences)
     (assign ?params (append (list (list 'type ?type) (assoc 'energy ?data)) ?about))
     (assign ?start (not-before ?earliest ?duration ?tc))
     (call in-time ?type ?origin ?start ?duration ?tc)
     (assign ?end (after ?start ?duration))
     (assign ?next (+ ?id 1))
     (my-write-time uavloc ?w ?we ?wt))
    ((uavloc flying ?from) (task-id ?id) (joint ?type ?about ?duration ?to) (eval-ok stay ?data)
     (my-write-time uavloc ?w ?we ?wt)
     (forall (?r ?re ?rt) ((my-read-time uavloc ?r ?re ?rt)) ((my-read-time uavloc ?r ?re ?rt))))
    ((uavloc flying ?to) (task-id ?next) (my-write-time uavloc ?end end ?id))
    0)
  (:operator (!!join ?type ?about ?duration ?to) () () ((joint ?type ?about ?duration ?to)) 0)

  ; ================ methods: motion

  (:method (take-off ?tc ?origin)
    in-the-air ((uavloc flying ?_loc)) ()
    wait-for-open-air
    ((uavloc grounded ?place) (may-begin ?tc ?when) (assign ?wait (compute-wait ?place ?place ?when 0)) (call numberp ?wait))
      ((!!lcompute-stay ?wait) (!task-wait ?_i ?_d ?_p ?_s ?_u ?tc ?origin) (take-off ?tc ?origin))
    take-off ((uavloc grounded ?place) (may-begin ?tc ?when))
      ((!!lcompute-takeoff ?place ?when) (!task-takeoff ?_i ?_d ?_p ?_s ?_u ?tc ?origin)))

  ; To stay there for so many seconds.
  (:method (go ?to ?stay ?tc ?origin)
    ; air that is closed for a time is waited for when that leads there earlier than a way around it
    wait-for-open-air
    ((uavloc ?how ?from) (may-begin ?tc ?when) (assign ?wait (compute-wait ?from ?to ?when ?stay))
      (spent-waiting ?how ?from ?when ?wait ?spent))
      ((!!lcompute-stay ?spent) (!task-wait ?_i ?_d ?_p ?_s ?_u ?tc ?origin) (go ?to ?stay ?tc ?origin))
    take-off-first ((uavloc grounded ?_place)) ((take-off ?tc ?origin) (go ?to ?stay ?tc ?origin))
    fly ((uavloc ?how ?from) (may-move ?how) (may-begin ?tc ?when))
      ((!!lcompute-gotoxyz ?from ?to ?when) (!task-gotoxyz ?_i ?_d ?_p ?_s ?_u ?tc ?origin)))
  ; Another method, and so tried when no plan is found for what comes behind.
  (:method (go ?to ?stay ?tc ?origin)
    later ((uavloc grounded ?_place) (may-begin ?tc ?when) (assign ?wait (compute-next-opening ?when)) (call numberp ?wait))
      ((!!lcompute-stay ?wait) (!task-wait ?_i ?_d ?_p ?_s ?_u ?tc ?origin) (go ?to ?stay ?tc ?origin)))

  ; To one's place at a meeting: around those where partners may wait already.
  (:method (go-among ?to ?others ?tc ?origin)
    wait-for-open-air
    ((uavloc ?how ?from) (may-begin ?tc ?when) (assign ?wait (compute-wait ?from ?to ?when 0))
      (spent-waiting ?how ?from ?when ?wait ?spent))
      ((!!lcompute-stay ?spent) (!task-wait ?_i ?_d ?_p ?_s ?_u ?tc ?origin) (go-among ?to ?others ?tc ?origin))
    take-off-first ((uavloc grounded ?_place)) ((take-off ?tc ?origin) (go-among ?to ?others ?tc ?origin))
    fly ((uavloc ?how ?from) (may-move ?how) (may-begin ?tc ?when))
      ((!!lcompute-gotoxyz-among ?from ?to ?others ?when) (!task-gotoxyz ?_i ?_d ?_p ?_s ?_u ?tc ?origin)))

  (:method (go-unless-there ?to ?tc ?origin)
    already-there ((uavloc ?how ?from) (may-move ?how) (call is-at ?from ?to)) ()
    elsewhere () ((go ?to 0 ?tc ?origin)))

  (:method (go-to-meet ?to ?others ?tc ?origin)
    already-there ((uavloc ?how ?from) (may-move ?how) (call is-at ?from ?to)) ()
    elsewhere () ((go-among ?to ?others ?tc ?origin)))

  (:method (go-through ?places ?tc ?origin)
    all-visited ((call null ?places)) ()
    next-one ((assign ?to (first ?places)) (assign ?others (rest ?places)))
      ((go-unless-there ?to ?tc ?origin) (go-through ?others ?tc ?origin)))

  (:method (touch-down ?place ?tc ?origin)
    touch-down ((uavloc flying ?from))
      ((!!lcompute-land ?from ?place) (!task-land ?_i ?_d ?_p ?_s ?_u ?tc ?origin)))

  (:method (general-takeoff ?tc ?origin)
    general-takeoff () ((take-off ?tc ?origin)))

  (:method (general-land ?tc ?origin)
    on-the-ground ((uavloc grounded ?_place)) ()
    ; nothing to land: it comes home
    drive-home ((uavloc driving ?_from) (landloc ?home)) ((go-unless-there ?home ?tc ?origin))
    land-here
      ((uavloc flying ?from) (landing-place ?from ?tc ?place) (call is-over ?from ?place)) ((touch-down ?place ?tc ?origin))
    come-back-and-land
      ((uavloc flying ?from) (landing-place ?from ?tc ?place)) ((go ?place 0 ?tc ?origin) (touch-down ?place ?tc ?origin)))

  ; Out of air that was closed around it; nothing to do where it may stay.
  (:method (leave-closed-air ?tc ?origin)
    on-the-ground ((uavloc grounded ?_place)) ()
    in-free-air ((uavloc flying ?from) (call is-free ?from)) ()
    leave ((uavloc flying ?from)) ((!!lcompute-way-out ?from) (!task-gotoxyz ?_i ?_d ?_p ?_s ?_u ?tc ?origin)))

  (:method (general-gotoxyz ?place ?tc ?origin)
    general-gotoxyz () ((go-unless-there ?place ?tc ?origin)))

  (:method (perform-tour ?places ?tc ?origin)
    all-reached ((done-before ?origin ?done) (call null (not-reached ?places (reached-before ?done)))) ()
    tour ((done-before ?origin ?done) (assign ?left (not-reached ?places (reached-before ?done)))
          (uavloc ?_how ?from) (assign ?order (compute-tour ?from ?left)) (call consp ?order))
      ((go-through ?order ?tc ?origin)))

  ; ================ methods: perception

  (:method (shoot-along ?device ?target ?tc ?origin)
    takeshot-until-it-ends ()
      ((!!aim ?device ?target) (!task-takeshot ?shot ?_d ?_p ?_s ?_u ?tc ?origin)
       (!stop-takeshot ?shot ?_e ?_q ?_t ?_v ?tc ?origin)))

  ; What was interrupted goes on: only the seconds still to come are planned. The device is the first that can do it.
  (:- (all-looked ?seconds ?origin)
    ((done-before ?origin ?done) (call = (left-to-look ?seconds ?done) 0)))
  (:- (still-to-look ?seconds ?origin ?left)
    ((done-before ?origin ?done) (assign ?left (left-to-look ?seconds ?done))))
  (:method (stay-and-shoot ?device ?place ?seconds ?tc ?origin)
    wait-and-takeshot ((assign ?target (target-of ?place)))
      ((!!lcompute-stay ?seconds) (!task-wait ?_i ?_d ?_p ?_s ?_u ?tc ?origin) (shoot-along ?device ?target ?tc ?origin)))

  (:method (general-combined-goto-and-takeshot ?place ?seconds ?tc ?origin)
    all-looked ((all-looked ?seconds ?origin)) ()
    goto-and-takeshot
    (:first (still-to-look ?seconds ?origin ?left) (uavloc ?_how ?from)
      (devices-for perception ?devices) (assign* ?device ?devices)
      (may-begin ?tc ?when) (view-for ?from ?place ?device ?when ?left ?to))
      ((go ?to ?left ?tc ?origin) (stay-and-shoot ?device ?place ?left ?tc ?origin)))

  (:method (perceive ?place ?seconds ?tc ?origin)
    all-looked ((all-looked ?seconds ?origin)) ()
    goto-and-perceive
    (:first (still-to-look ?seconds ?origin ?left) (uavloc ?_how ?from)
      (devices-for perception ?devices) (assign* ?device ?devices)
      (may-begin ?tc ?when) (view-for ?from ?place ?device ?when ?left ?to) (assign ?target (target-of ?place)))
      ((go ?to ?left ?tc ?origin) (!!lcompute-stay ?left) (!!aim ?device ?target)
       (!task-perception ?_i ?_d ?_p ?_s ?_u ?tc ?origin)))

  (:method (takeshot-while-waiting ?seconds ?tc ?origin)
    all-looked ((all-looked ?seconds ?origin)) ()
    takeshot-while-waiting
    (:first (still-to-look ?seconds ?origin ?left) (devices-for perception ?devices) (assign* ?device ?devices))
      ((!!lcompute-stay ?left) (!task-wait ?_i ?_d ?_p ?_s ?_u ?tc ?origin) (shoot-along ?device () ?tc ?origin)))

  (:method (perform-detection ?zone ?place ?seconds ?tc ?origin)
    all-looked ((all-looked ?seconds ?origin)) ()
    ; where it is, rather than over the zone while the air there is still closed
    wait-for-open-air
    (:first (detection-with ?zone ?place ?seconds ?tc ?origin ?device ?left) (uavloc ?how ?from) (may-begin ?tc ?when)
      (assign ?wait (compute-wait-for-patrol ?from ?place ?zone ?device ?left ?when))
      (spent-waiting ?how ?from ?when ?wait ?spent))
      ((!!lcompute-stay ?spent) (!task-wait ?_i ?_d ?_p ?_s ?_u ?tc ?origin)
       (perform-detection ?zone ?place ?seconds ?tc ?origin))
    detection
    (:first (detection-with ?zone ?place ?seconds ?tc ?origin ?device ?left))
      ((go ?place 0 ?tc ?origin) (detect ?zone ?device ?left ?tc ?origin)))
  ; The first device that can have the zone in sight at some time from now on.
  (:- (detection-with ?zone ?place ?seconds ?tc ?origin ?device ?left)
    ((still-to-look ?seconds ?origin ?left) (assign ?at (compute-entry ?place)) (may-begin ?tc ?when)
      (devices-for detection ?devices) (assign* ?device ?devices)
      (assign ?pattern (compute-patrol ?at ?zone ?device ?left (from-then-on ?when))) (call consp ?pattern)))
  (:method (detect ?zone ?device ?seconds ?tc ?origin)
    pattern ((uavloc flying ?from) (may-begin ?tc ?when)
             (assign ?target (get-aim (compute-patrol ?from ?zone ?device ?seconds ?when))))
      ((!!lcompute-patrol ?from ?zone ?device ?seconds ?when) (!task-gotoxyz ?_i ?_d ?_p ?_s ?_u ?tc ?origin)
       (shoot-along ?device ?target ?tc ?origin)))

  ; What is left of the lanes when they can be flown with a device that sees as much; else all of them.
  (:- (lanes-left ?origin ?before ?way)
    ((done-before ?origin ?done) (assign ?rest (assoc 'rest ?done)) (call consp ?rest)
     (assign ?before (second ?rest)) (assign ?way (rest (rest ?rest)))))
  (:method (perform-mapping ?zone ?tc ?origin)
    all-flown ((lanes-left ?origin ?_before ?way) (call null ?way)) ()
    wait-for-open-air-over-what-is-left
    (:first (lanes-left ?origin ?before ?way) (uavloc ?how ?from) (may-begin ?tc ?when)
      (devices-for mapping ?devices) (assign* ?device ?devices)
      (assign ?wait (compute-wait-for-rest ?from ?zone ?device ?before ?way ?when))
      (spent-waiting ?how ?from ?when ?wait ?spent))
      ((!!lcompute-stay ?spent) (!task-wait ?_i ?_d ?_p ?_s ?_u ?tc ?origin) (perform-mapping ?zone ?tc ?origin))
    lanes-left
    (:first (lanes-left ?origin ?before ?way) (uavloc ?_how ?from) (may-begin ?tc ?when)
      (devices-for mapping ?devices) (assign* ?device ?devices)
      (assign ?data (compute-rest ?from ?zone ?device ?before ?way ?when)) (call consp ?data) (assign ?entry (get-entry ?data)))
      ((go ?entry 0 ?tc ?origin) (!!lcompute-rest ?from ?zone ?device ?before ?way ?when ?tc)
       (!task-gotoxyz ?_i ?_d ?_p ?_s ?_u ?tc ?origin) (shoot-along ?device () ?tc ?origin))
    wait-for-open-air
    (:first (uavloc ?how ?from) (may-begin ?tc ?when) (devices-for mapping ?devices) (assign* ?device ?devices)
      (assign ?wait (compute-wait-for-sweep ?from ?zone ?device ?when)) (spent-waiting ?how ?from ?when ?wait ?spent))
      ((!!lcompute-stay ?spent) (!task-wait ?_i ?_d ?_p ?_s ?_u ?tc ?origin) (perform-mapping ?zone ?tc ?origin))
    mapping
    (:first (uavloc ?_how ?from) (may-begin ?tc ?when) (devices-for mapping ?devices) (assign* ?device ?devices)
      (assign ?entry (compute-sweep-entry ?from ?zone ?device ?when)) (call consp ?entry))
      ((go ?entry 0 ?tc ?origin) (!!lcompute-sweep ?from ?zone ?device ?when ?tc) (!task-gotoxyz ?_i ?_d ?_p ?_s ?_u ?tc ?origin)
       (shoot-along ?device () ?tc ?origin))
    ; what is closed while it climbs may be open then
    take-off-first ((uavloc grounded ?_place)) ((take-off ?tc ?origin) (perform-mapping ?zone ?tc ?origin)))

  ; What a mapping does before something that has no other place: that share of the lanes it would fly now, as nearly as they
  ; can be parted. The mapping, which comes behind, has the others left.
  (:- (lanes-of ?goal ?zone ?device ?from ?when ?lanes)
    what-is-left
    ((lanes-left ?goal ?before ?way)
     (assign ?lanes (compute-rest ?from ?zone ?device ?before ?way ?when)) (call consp ?lanes))
    all ((assign ?lanes (compute-sweep ?from ?zone ?device ?when)) (call consp ?lanes)))
  (:method (map-part ?zone ?share ?goal ?tc ?origin)
    part
    (:first (uavloc ?_how ?from) (may-begin ?tc ?when) (devices-for mapping ?devices) (assign* ?device ?devices)
      (lanes-of ?goal ?zone ?device ?from ?when ?lanes)
      (assign ?part (compute-part ?lanes ?share)) (call consp ?part) (assign ?entry (get-entry ?part)))
      ((go ?entry 0 ?tc ?origin) (!!take-part ?part ?tc) (!task-gotoxyz ?_i ?_d ?_p ?_s ?_u ?tc ?origin)
       (shoot-along ?device () ?tc ?origin) (!!leave-rest ?goal ?device ?part))
    nothing-to-part () ())

  ; From several angles in turn.
  (:method (perform-monitoring ?place ?seconds ?tc ?origin)
    monitoring
    (:first (uavloc ?_how ?from)
      (devices-for perception ?devices) (assign* ?device ?devices) (may-begin ?tc ?when)
      (three-sides-for ?from ?place ?device ?when ?seconds ?points)
      (assign ?each (/ (* 1.0d0 ?seconds) (length ?points))) (done-before ?origin ?done))
      ((monitor-from ?points ?place ?device ?each ?done ?tc ?origin)))
  ; A look from between two angles counts for one of them.
  (:method (monitor-from ?points ?place ?device ?seconds ?done ?tc ?origin)
    all-angles ((call null ?points)) ()
    seen-before
    ((uavloc ?how ?_from) (assign ?to (first ?points)) (assign ?others (rest ?points))
      (call = (left-to-look-from ?how ?to ?seconds ?done) 0) (assign ?elsewhere (done-elsewhere ?how ?to ?done)))
      ((monitor-from ?others ?place ?device ?seconds ?elsewhere ?tc ?origin))
    next-angle
    ((uavloc ?how ?_from) (assign ?to (first ?points)) (assign ?others (rest ?points))
      (assign ?left (left-to-look-from ?how ?to ?seconds ?done)) (assign ?elsewhere (done-elsewhere ?how ?to ?done)))
      ((go ?to ?left ?tc ?origin) (stay-and-shoot ?device ?place ?left ?tc ?origin)
       (monitor-from ?others ?place ?device ?seconds ?elsewhere ?tc ?origin)))

  ; ================ methods: synchronisation

  ; Partners that have met do not wait for each other again.
  (:- (has-met ?sync ?origin)
    ((done-before ?origin ?done) (call has-met ?sync ?done)))
  (:method (wait-for-partners ?sync ?senders ?receivers ?tc ?origin)
    have-met ((has-met ?sync ?origin)) ()
    wait-until-synchro ()
      ((!!lcompute-stay stopped) (!task-wait ?wait ?_d ?_p ?_s ?_u ?tc ?origin)
       (!!agree ?sync ?senders ?receivers ((num 0) (num 30))) (!task-synchro ?_i ?_e ?_q ?_t ?_v ?tc ?origin)
       (!stop-wait ?wait ?_f ?_r ?_x ?_w ?tc ?origin)))

  (:method (general-combined-goto-and-synchro-and-takeshot ?sync ?senders ?receivers ?place ?seconds ?tc ?origin)
    all-looked ((has-met ?sync ?origin) (all-looked ?seconds ?origin)) ()
    goto-and-synchro-and-takeshot
    (:first (still-to-look ?seconds ?origin ?left) (uavloc ?_how ?from)
      (devices-for perception ?devices) (assign* ?device ?devices)
      (may-begin ?tc ?when)
      (meeting-for ?from ?place ?device ?senders ?receivers ?when ?to ?others))
      ((go-among ?to ?others ?tc ?origin) (wait-for-partners ?sync ?senders ?receivers ?tc ?origin)
       (stay-and-shoot ?device ?place ?left ?tc ?origin)))

  (:method (meet ?sync ?senders ?receivers ?tc ?origin)
    have-met ((has-met ?sync ?origin)) ()
    rendezvous ()
      ((!!agree ?sync ?senders ?receivers ((num 0) (num 30))) (!task-rendezvous ?_i ?_d ?_p ?_s ?_u ?tc ?origin)))

  (:method (monitor-until ?place ?sync ?partners ?signal ?from ?tc ?origin)
    monitor-until
    (:first (assign ?team (with-me ?partners)) (uavloc ?_how ?here)
      (devices-for perception ?devices) (assign* ?device ?devices) (may-begin ?tc ?when)
      (meeting-for ?here ?place ?device ?team ?team ?when ?to ?others)
      (assign ?target (target-of ?place)))
      ((go-to-meet ?to ?others ?tc ?origin) (meet ?sync ?team ?team ?tc ?origin)
       (!!aim ?device ?target) (!task-monitoring ?shot ?_e ?_q ?_t ?_v ?tc ?origin)
       (!!agree ?signal (?from) ?team ((num 0) (num unlimited))) (!task-synchro ?_j ?_f ?_r ?_x ?_w ?tc ?origin)
       (!stop-monitoring ?shot ?_g ?_k ?_y ?_z ?tc ?origin)))

  (:method (send-signal ?sync ?receivers ?tc ?origin)
    send-signal ((assign ?me (with-me ()))) ((meet ?sync ?me ?receivers ?tc ?origin)))

  (:method (synchro ?sync ?senders ?receivers ?tc ?origin)
    synchro () ((meet ?sync ?senders ?receivers ?tc ?origin)))

  (:method (wait-until-synchro ?sync ?senders ?receivers ?tc ?origin)
    wait-until-synchro () ((wait-for-partners ?sync ?senders ?receivers ?tc ?origin)))

  ; ================ methods: waiting, and what needs others

  ; Seconds, or the word `unlimited`.
  (:method (general-wait ?seconds ?tc ?origin)
    all-waited ((done-before ?origin ?done) (call eq (left-to-wait ?seconds ?done) 0)) ()
    general-wait ((done-before ?origin ?done) (assign ?left (left-to-wait ?seconds ?done)))
      ((!!lcompute-stay ?left) (!task-wait ?_i ?_d ?_p ?_s ?_u ?tc ?origin)))

  (:method (wait-for-orders ?tc ?origin)
    wait-for-orders () ((!!lcompute-stay unlimited) (!task-wait ?_i ?_d ?_p ?_s ?_u ?tc ?origin)))

  ; There and back, and as long as it is to last; at the most as long again as the ways, and ten minutes, for partners that
  ; come later, negotiations, and moves with what is watched.
  (:method (monitoring-with-relay ?front ?center ?control ?seconds ?uavs ?tc ?origin)
    take-off-first ((uavloc grounded ?_place))
      ((take-off ?tc ?origin) (monitoring-with-relay ?front ?center ?control ?seconds ?uavs ?tc ?origin))
    monitoring-with-relay
    ((uavloc flying ?from) (may-begin ?tc ?when)
      (assign ?there (compute-gotoxyz ?from ?front ?when)) (call consp ?there)
      (assign ?back (compute-gotoxyz ?from ?control ?when)) (call consp ?back)
      (assign ?ways (+ (high (get-duration ?there)) (high (get-duration ?back))))
      (assign ?expected (+ ?seconds ?ways)) (assign ?most (+ ?expected ?ways 600))
      (assign ?about (list (list 'p0 ?front) (list 'p1 ?center) (list 'p2 ?control) (list 'p3 ?seconds) (list 'p4 ?uavs)))
      (assign ?duration (interval ?seconds ?most)) (assign ?to (get-destination ?back)))
      ((!!lcompute-stay ?expected) (!!join "joint:monitoring-with-relay" ?about ?duration ?to)
       (!task-joint ?_i ?_d ?_p ?_s ?_u ?tc ?origin)))

  ; How long it takes follows from who takes part, and is agreed when it begins: ?seconds is what is reckoned with.
  (:method (cooperative-mapping ?area ?center ?home ?seconds ?uavs ?tc ?origin)
    take-off-first ((uavloc grounded ?_place))
      ((take-off ?tc ?origin) (cooperative-mapping ?area ?center ?home ?seconds ?uavs ?tc ?origin))
    cooperative-mapping
    ((uavloc flying ?from) (may-begin ?tc ?when)
      (assign ?there (compute-gotoxyz ?from ?center ?when)) (call consp ?there)
      (assign ?back (compute-gotoxyz ?from ?home ?when)) (call consp ?back)
      (assign ?ways (+ (high (get-duration ?there)) (high (get-duration ?back))))
      (assign ?expected (+ ?seconds ?ways)) (assign ?most (+ ?expected ?expected 600))
      (assign ?about
        (list (list 'area ?area) (list 'center ?center) (list 'home ?home) (list 'duration ?seconds) (list 'uavs ?uavs)))
      (assign ?duration (interval 10 ?most)) (assign ?to (get-destination ?back)))
      ((!!lcompute-stay ?expected) (!!join "joint:cooperative-mapping" ?about ?duration ?to)
       (!task-joint ?_i ?_d ?_p ?_s ?_u ?tc ?origin)))

  ; As monitoring: there and back, and as long as it is to last.
  (:method (vehicle-pursuit ?vehicle ?home ?seconds ?uavs ?tc ?origin)
    take-off-first ((uavloc grounded ?_place))
      ((take-off ?tc ?origin) (vehicle-pursuit ?vehicle ?home ?seconds ?uavs ?tc ?origin))
    vehicle-pursuit
    ((uavloc flying ?from) (may-begin ?tc ?when)
      (assign ?there (compute-gotoxyz ?from ?vehicle ?when)) (call consp ?there)
      (assign ?back (compute-gotoxyz ?from ?home ?when)) (call consp ?back)
      (assign ?ways (+ (high (get-duration ?there)) (high (get-duration ?back))))
      (assign ?expected (+ ?seconds ?ways)) (assign ?most (+ ?expected ?ways 600))
      (assign ?about (list (list 'vehicle ?vehicle) (list 'home ?home) (list 'duration ?seconds) (list 'uavs ?uavs)))
      (assign ?duration (interval ?seconds ?most)) (assign ?to (get-destination ?back)))
      ((!!lcompute-stay ?expected) (!!join "joint:vehicle-pursuit" ?about ?duration ?to)
       (!task-joint ?_i ?_d ?_p ?_s ?_u ?tc ?origin)))
  ))
