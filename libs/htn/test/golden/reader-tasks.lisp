(defdomain errands
  ((:operator (!walk ?to) () () ((at ?to)))
   (:method (shop) () walk-there!)
   (:method (shop) () ((!walk market) 5 (7 up) "sing"))
   (:method (shop) () (:orderd (!walk market)))
   (:method (shop) () (:unordered (:task) (:task :immediate) (:immediate (!walk x))))
   (:method (shop) () `((!walk market) ,(more)))))
