  LOCAL PROC tcScale(num tcOf)
    ! The cold arm is off already: one correction is right at 1, the other at 0
    tcF1:=tcOf;
    tcF2:=1-tcOf;
    tcShare:=tcOf;
    tcOn:=TRUE;
  ENDPROC
