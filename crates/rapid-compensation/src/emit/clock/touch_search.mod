  LOCAL PROC tcProbe(robtarget tcWhere,INOUT robtarget tcFound,INOUT bool tcIs)
    ! Searches the sphere from above and from two sides, along the axes of the work object
    VAR robtarget tcHit;
    tcFound:=tcWhere;
    MoveJ Offs(tcWhere,0,0,@FAR@),v100,fine,@TOOL@;
    tcSearch tcWhere,0,0,1,tcHit,tcIs;
    IF tcIs tcFound.trans.z:=tcHit.trans.z-@RADIUS@;
    IF tcIs tcSearch tcWhere,1,0,0,tcHit,tcIs;
    IF tcIs tcFound.trans.x:=tcHit.trans.x-@RADIUS@;
    IF tcIs tcSearch tcWhere,0,1,0,tcHit,tcIs;
    IF tcIs tcFound.trans.y:=tcHit.trans.y-@RADIUS@;
    MoveL Offs(tcWhere,0,0,@FAR@),v100,fine,@TOOL@;
  ENDPROC

  LOCAL PROC tcSearch(robtarget tcWhere,num tcX,num tcY,num tcZ,INOUT robtarget tcHit,INOUT bool tcIs)
    ! There from above, and back
    tcIs:=TRUE;
    MoveL Offs(tcWhere,@FAR@*tcX,@FAR@*tcY,@FAR@),v100,fine,@TOOL@;
    MoveL Offs(tcWhere,@FAR@*tcX,@FAR@*tcY,@FAR@*tcZ),v100,fine,@TOOL@;
    SearchL\Stop,@SIGNAL@,tcHit,Offs(tcWhere,@NEAR@*tcX,@NEAR@*tcY,@NEAR@*tcZ),v10,@TOOL@;
    MoveL Offs(tcWhere,@FAR@*tcX,@FAR@*tcY,@FAR@*tcZ),v100,fine,@TOOL@;
    MoveL Offs(tcWhere,@FAR@*tcX,@FAR@*tcY,@FAR@),v100,fine,@TOOL@;
  ERROR
    IF ERRNO=ERR_WHLSEARCH OR ERRNO=ERR_SIGSUPSEARCH THEN
      tcIs:=FALSE;
      TRYNEXT;
    ENDIF
    RAISE;
  ENDPROC
