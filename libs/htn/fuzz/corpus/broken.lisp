(defdomain broken ((:operator (drop ?x) () (held ?x)) (:method (?task) ((a) ())) (:op)
  (:method (get ?x) (not (a) (b)) ((fetch ?x)
  (:- (near ?x . ?y) (forall ?x (a) (b) (c)))
  (:metod (get)) #+sbcl (:operator) #-(or x (not y)) "str\"ing" `(a ,b ,@c) #\( #x1F 1/0 ... ( . a) (a . b c)
(defproblem p broken ((on ?x) on 5 (5)) ((get . x) :unordered)))) #| never |# | open
