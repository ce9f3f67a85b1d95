  PROC tcSelfTest()
    ! Moves nothing: compares the controller's kinematics with those assumed, and times a correction
    VAR num tcJoint:=0;
    VAR num tcWay:=0;
    VAR bool tcOther:=FALSE;
    VAR bool tcTold:=FALSE;
    VAR robtarget tcGoal;
    IF C_PROGDISP.pdisp.trans.x<>0 OR C_PROGDISP.pdisp.trans.y<>0 OR C_PROGDISP.pdisp.trans.z<>0
      OR C_PROGDISP.pdisp.rot.q2<>0 OR C_PROGDISP.pdisp.rot.q3<>0 OR C_PROGDISP.pdisp.rot.q4<>0 THEN
      TPWrite "tcSelfTest: not measured, a program displacement is on";
      RETURN;
    ENDIF
@TESTS@
    TPWrite "tcSelfTest: joints differ by deg "\Num:=tcJoint;
    TPWrite "tcSelfTest: there and back differs by mm "\Num:=tcWay;
    tcTold:=TRUE;
    IF NOT (tcJoint<=@SAME_DEG@ AND tcWay<=@SAME_MM@) THEN
      TPWrite "tcSelfTest: NOT the kinematics assumed, do not use corrections";
    ELSEIF tcOther THEN
      TPWrite "tcSelfTest: not measured, a tool or work object is not as in its motion";
    ELSE
      TPWrite "tcSelfTest: the kinematics are those assumed";
    ENDIF
    tcGoal:=tcLive(tcTestP1,@FIRST@);
    IF NOT tcOn THEN
      TPWrite "tcSelfTest: no time of a correction, original targets are in use now";
      RETURN;
    ENDIF
    ClkReset tcTimer;
    ClkStart tcTimer;
    FOR tcN FROM 1 TO 1000 DO
      tcGoal:=tcLive(tcTestP1,@FIRST@);
    ENDFOR
    ClkStop tcTimer;
    TPWrite "tcSelfTest: ms for a correction "\Num:=ClkRead(tcTimer\HighRes);
  ERROR
    IF tcTold THEN
      TPWrite "tcSelfTest: no time of a correction, error "\Num:=ERRNO;
    ELSEIF ERRNO=ERR_ROBLIMIT OR ERRNO=ERR_OUTSIDE_REACH THEN
      TPWrite "tcSelfTest: NOT the kinematics assumed, a target has no joints";
    ELSE
      TPWrite "tcSelfTest: not measured, error "\Num:=ERRNO;
    ENDIF
    RETURN;
  ENDPROC

  LOCAL PROC tcTest(robtarget tcP,robjoint tcQ,pose tcHeldAt,pose tcOnAt,INOUT num tcJoint,INOUT num tcWay,
    INOUT bool tcOther,PERS tooldata tcTool\PERS wobjdata WObj)
    ! The largest differences so far, or that tool and work object are others than those that the joints are for
    VAR jointtarget tcJ;
    VAR robtarget tcGoal;
    VAR bool tcSame;
    tcSame:=tcIsAt(tcTool.tframe,tcHeldAt);
    IF tcSame AND Present(WObj) tcSame:=tcIsAt(PoseMult(WObj.uframe,WObj.oframe),tcOnAt);
    IF NOT tcSame THEN
      tcOther:=TRUE;
      RETURN;
    ENDIF
    tcJ:=CalcJointT(tcP,tcTool\WObj?WObj);
    tcGoal:=CalcRobT(tcJ,tcTool\WObj?WObj);
    tcMost tcJoint,tcJ.robax.rax_1-tcQ.rax_1;
    tcMost tcJoint,tcJ.robax.rax_2-tcQ.rax_2;
    tcMost tcJoint,tcJ.robax.rax_3-tcQ.rax_3;
    tcMost tcJoint,tcJ.robax.rax_4-tcQ.rax_4;
    tcMost tcJoint,tcJ.robax.rax_5-tcQ.rax_5;
    tcMost tcJoint,tcJ.robax.rax_6-tcQ.rax_6;
    tcMost tcWay,tcGoal.trans.x-tcP.trans.x;
    tcMost tcWay,tcGoal.trans.y-tcP.trans.y;
    tcMost tcWay,tcGoal.trans.z-tcP.trans.z;
  ENDPROC

  LOCAL FUNC bool tcIsAt(pose tcA,pose tcB)
    ! The same frame but for what single precision rounds; a quaternion and its opposite are one turn
    VAR num tcTurn;
    tcTurn:=tcA.rot.q1*tcB.rot.q1+tcA.rot.q2*tcB.rot.q2+tcA.rot.q3*tcB.rot.q3+tcA.rot.q4*tcB.rot.q4;
    RETURN Abs(tcA.trans.x-tcB.trans.x)<@SAME_MM@ AND Abs(tcA.trans.y-tcB.trans.y)<@SAME_MM@
      AND Abs(tcA.trans.z-tcB.trans.z)<@SAME_MM@ AND Abs(tcTurn)>0.999999;
  ENDFUNC

  LOCAL PROC tcMost(INOUT num tcSoFar,num tcOff)
    IF Abs(tcOff)>tcSoFar tcSoFar:=Abs(tcOff);
  ENDPROC
