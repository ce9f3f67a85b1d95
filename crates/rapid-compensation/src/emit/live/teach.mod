  PROC tcTeach(INOUT robtarget tcP,PERS tooldata tcTool\PERS wobjdata WObj)
    ! Where the arm stands now, as the target that tcLive brings it back to, cold or warm
    VAR robtarget tcGoal;
    VAR jointtarget tcJ;
    tcUpdate;
    tcGoal:=CRobT(\Tool:=tcTool\WObj?WObj);
    IF tcFits(tcTool\WObj?WObj) THEN
      tcJ:=CJointT();
      IF NOT tcCorrect(tcGoal,tcJ.robax,tcTool,1@WOBJ@) TPWrite "It is stored as it stands";
    ENDIF
    tcP:=tcGoal;
  ENDPROC
