; two items that are not closed, and one parenthesis too many at the end
(defdomain garden (
  (:operator (!water ?bed)
    ((dry ?bed)
    ((dry ?bed)) ((wet ?bed)))
  (:method (tend ?bed)
    ((dry ?bed)) ((!water ?bed))
    nil ()
  (:- (green ?bed) ((wet ?bed)))))
(defproblem monday garden ((dry roses)) ((tend roses))))
