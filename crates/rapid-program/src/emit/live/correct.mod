    ! Tool: its lever, then its axes
    tcDx:=tcDx+tcRy*tcTool.tframe.trans.z-tcRz*tcTool.tframe.trans.y;
    tcDy:=tcDy+tcRz*tcTool.tframe.trans.x-tcRx*tcTool.tframe.trans.z;
    tcDz:=tcDz+tcRx*tcTool.tframe.trans.y-tcRy*tcTool.tframe.trans.x;
    tcA:=@FACTOR@;
    tcTo.rot:=tcTool.tframe.rot;
    tcTo:=PoseInv(tcTo);
    tcBy.trans.x:=tcA*tcRx;
    tcBy.trans.y:=tcA*tcRy;
    tcBy.trans.z:=tcA*tcRz;
    tcTurn:=PoseMult(tcTo,tcBy);
    tcBy.trans.x:=tcA*tcDx;
    tcBy.trans.y:=tcA*tcDy;
    tcBy.trans.z:=tcA*tcDz;
    tcBy:=PoseMult(tcTo,tcBy);
    tcA:=tcBy.trans.x*tcBy.trans.x+tcBy.trans.y*tcBy.trans.y+tcBy.trans.z*tcBy.trans.z;
    tcB:=tcTurn.trans.x*tcTurn.trans.x+tcTurn.trans.y*tcTurn.trans.y+tcTurn.trans.z*tcTurn.trans.z;
    IF tcA>@CAP_MM2@ OR tcB>@CAP_RAD2@ THEN
      tcWarn "A correction of more than @CAP_MM@ mm or @CAP_DEG@ deg: original target";
      RETURN FALSE;
    ENDIF
    ! As a quaternion of length 1; half the turn is its vector
    tcBy.rot.q2:=tcTurn.trans.x/2;
    tcBy.rot.q3:=tcTurn.trans.y/2;
    tcBy.rot.q4:=tcTurn.trans.z/2;
    tcBy.rot.q1:=Sqrt(1-tcB/4);
    tcTo.trans:=tcGoal.trans;
    tcTo.rot:=tcGoal.rot;
    tcTo:=PoseMult(tcTo,tcBy);
    tcGoal.trans:=tcTo.trans;
    tcGoal.rot:=tcTo.rot;
    RETURN TRUE;
  ENDFUNC
