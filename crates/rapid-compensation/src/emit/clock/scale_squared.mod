  LOCAL PROC tcScale(num tcOf)
    ! What corrections have of second order in the share is met as well: one is right at 1, the other at 0.5
    tcF1:=tcOf*(2*tcOf-1);
    tcF2:=4*tcOf*(1-tcOf);
    tcShare:=tcOf;
    tcOn:=tcOf<>0;
  ENDPROC
