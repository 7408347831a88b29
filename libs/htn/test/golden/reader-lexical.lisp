(defproblem letters nil
  ((at . ) ( . b) (c . d e) (half 1/0) (many ...)
   (odd #<thing>) (tail ') (pkg shop::) (number #xZZ)
   (fine "text" |With Bars|))
  ())
#| never closed #| inner |#
