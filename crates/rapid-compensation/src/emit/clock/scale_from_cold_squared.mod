  LOCAL PROC tcScale(num tcOf)
    ! The cold arm is off already, and what corrections have of second order is met: they are right at 1, 0.5 and 0
    tcF1:=tcOf*(2*tcOf-1);
    tcF2:=4*tcOf*(1-tcOf);
    tcF3:=(1-tcOf)*(1-2*tcOf);
    tcShare:=tcOf;
    tcOn:=TRUE;
  ENDPROC
