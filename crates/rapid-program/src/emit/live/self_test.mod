  PROC tcSelfTest()
    ! Moves nothing: compares the controller's kinematics with those assumed, and times a correction
    VAR num tcJoint:=0;
    VAR num tcWay:=0;
    VAR robtarget tcGoal;
@TESTS@
    TPWrite "tcSelfTest: joints differ by deg "\Num:=tcJoint;
    TPWrite "tcSelfTest: there and back differs by mm "\Num:=tcWay;
    IF tcJoint>@SAME_DEG@ OR tcWay>@SAME_MM@ THEN
      TPWrite "tcSelfTest: NOT the kinematics assumed, do not use corrections";
    ELSE
      TPWrite "tcSelfTest: the kinematics are those assumed";
    ENDIF
    IF NOT tcOn TPWrite "tcSelfTest: original targets are in use now";
    ClkReset tcTimer;
    ClkStart tcTimer;
    FOR tcN FROM 1 TO 1000 DO
      tcGoal:=tcLive(tcTestP1,@FIRST@);
    ENDFOR
    ClkStop tcTimer;
    TPWrite "tcSelfTest: ms for a correction "\Num:=ClkRead(tcTimer\HighRes);
  ERROR
    IF ERRNO=ERR_ROBLIMIT OR ERRNO=ERR_OUTSIDE_REACH THEN
      TPWrite "tcSelfTest: NOT the kinematics assumed, a target has no joints";
      RETURN;
    ENDIF
    RAISE;
  ENDPROC

  LOCAL PROC tcTest(robtarget tcP,robjoint tcQ,INOUT num tcJoint,INOUT num tcWay,PERS tooldata tcTool\PERS wobjdata WObj)
    ! The largest differences so far
    VAR jointtarget tcJ;
    VAR robtarget tcGoal;
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

  LOCAL PROC tcMost(INOUT num tcSoFar,num tcOff)
    IF Abs(tcOff)>tcSoFar tcSoFar:=Abs(tcOff);
  ENDPROC
