; A drone drops a crate at each place, over roads that may be closed meanwhile (docs/planning.md).
(defdomain relay (
  (:operator (!go ?from ?to) ((at ?from) (road ?from ?to)) ((at ?from)) ((at ?to)) 1.5)
  (:operator (!drop ?place) ((at ?place)) () ((dropped ?place)))
  (:method (bring ?place) ((at ?here)) ((go ?here ?place) (!drop ?place)))
  (:method (go ?here ?place) straight ((road ?here ?place)) ((!go ?here ?place)))
  (:method (go ?here ?place) over ((road ?here ?other) (road ?other ?place))
    ((!go ?here ?other) (!go ?other ?place)))))

(defproblem crates relay
  ((at a) (road a b) (road b c) (road b e) (road e c))
  ((bring b) (bring c)))
