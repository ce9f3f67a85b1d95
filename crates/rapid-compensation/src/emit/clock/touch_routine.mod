  LOCAL PROC tcProbe(robtarget tcWhere,INOUT robtarget tcFound,INOUT bool tcIs)
    ! By the routine that was given; any error of its own is a point that was not found
    tcFound:=tcWhere;
    tcIs:=TRUE;
    @ROUTINE@ tcWhere,tcFound;
  ERROR
    tcIs:=FALSE;
    TRYNEXT;
  ENDPROC
