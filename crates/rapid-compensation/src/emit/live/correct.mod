    ! Tool: its lever, then its axes
    tcTo:=[[0,0,0],tcTool.tframe.rot];
    tcTo:=PoseInv(tcTo);
    tcWas:=[tcGoal.trans,tcGoal.rot];
scaled#    tcE:=tcSign*tcF1;
twice#    FOR tcN FROM 1 TO 2 DO
    tcTurn:=[[@FACTOR@*tcRx,@FACTOR@*tcRy,@FACTOR@*tcRz],[1,0,0,0]];
    tcTurn:=PoseMult(tcTo,tcTurn);
    tcBy:=[[@FACTOR@*(tcDx+tcRy*tcTool.tframe.trans.z-tcRz*tcTool.tframe.trans.y),
      @FACTOR@*(tcDy+tcRz*tcTool.tframe.trans.x-tcRx*tcTool.tframe.trans.z),
      @FACTOR@*(tcDz+tcRx*tcTool.tframe.trans.y-tcRy*tcTool.tframe.trans.x)],[1,0,0,0]];
    tcBy:=PoseMult(tcTo,tcBy);
    tcB:=tcTurn.trans.x*tcTurn.trans.x+tcTurn.trans.y*tcTurn.trans.y+tcTurn.trans.z*tcTurn.trans.z;
    IF Distance(tcBy.trans,[0,0,0])>@CAP_MM@ OR tcB>@CAP_RAD2@ THEN
      tcWarn "A correction of more than @CAP_MM@ mm or @CAP_DEG@ deg: original target";
      RETURN FALSE;
    ENDIF
    ! As a quaternion of length 1; half the turn is its vector
    tcBy.rot:=[Sqrt(1-tcB/4),tcTurn.trans.x/2,tcTurn.trans.y/2,tcTurn.trans.z/2];
    tcBy:=PoseMult(tcWas,tcBy);
    tcGoal.trans:=tcBy.trans;
    tcGoal.rot:=tcBy.rot;
twice#    IF tcN=2 OR tcSign>0 RETURN TRUE;
twice#    ! What is steep, at the joints of the corrected target
twice#    IF NOT tcSolved(tcGoal,tcJ,tcTool\WObj?WObj) RETURN FALSE;
@AGAIN@
twice#    ENDFOR
    RETURN TRUE;
  ENDFUNC
twice#
twice#  LOCAL FUNC bool tcSolved(robtarget tcP,INOUT robjoint tcQ,PERS tooldata tcTool\PERS wobjdata WObj)
twice#    VAR jointtarget tcJ;
twice#    tcJ:=CalcJointT(tcP,tcTool\WObj?WObj);
twice#    tcQ:=tcJ.robax;
twice#    RETURN TRUE;
twice#  ERROR
twice#    IF ERRNO=ERR_ROBLIMIT OR ERRNO=ERR_OUTSIDE_REACH THEN
twice#      tcWarn "No joints for a corrected target: original target";
twice#      RETURN FALSE;
twice#    ENDIF
twice#    RAISE;
twice#  ENDFUNC
