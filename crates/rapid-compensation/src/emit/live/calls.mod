  FUNC robtarget tcLive(robtarget tcP,PERS tooldata tcTool\PERS wobjdata WObj)
    ! The target for which the arm, as warm as it is now, stands at tcP
    tcUpdate;
    RETURN tcLiveSame(tcP,tcTool\WObj?WObj);
  ENDFUNC

  FUNC robtarget tcLiveSame(robtarget tcP,PERS tooldata tcTool\PERS wobjdata WObj)
    ! The same at the moment of the last update: second point of an arc
    VAR robtarget tcGoal;
    VAR jointtarget tcJ;
    VAR jointtarget tcThere;
    IF NOT tcFits(tcTool\WObj?WObj) RETURN tcP;
    tcGoal:=tcP;
    tcJ:=CalcJointT(tcP,tcTool\WObj?WObj);
    IF NOT tcCorrect(tcGoal,tcJ.robax,tcTool,-1@WOBJ@) RETURN tcP;
    tcThere:=CalcJointT(tcGoal,tcTool\WObj?WObj);
    IF tcFar(tcThere.robax,tcJ.robax) RETURN tcP;
    RETURN tcGoal;
  ERROR
    IF ERRNO=ERR_ROBLIMIT OR ERRNO=ERR_OUTSIDE_REACH THEN
      tcWarn "No joints for a target as it is configured: original target";
      RETURN tcP;
    ENDIF
    RAISE;
  ENDFUNC

  FUNC jointtarget tcLiveJ(jointtarget tcP,PERS tooldata tcTool\PERS wobjdata WObj)
    ! The joints at which the arm, as warm as it is now, stands where the cold one does at tcP
    VAR robtarget tcGoal;
    VAR jointtarget tcJ;
    tcUpdate;
    IF Abs(tcP.robax.rax_1)>8.9E9 OR Abs(tcP.robax.rax_2)>8.9E9 OR Abs(tcP.robax.rax_3)>8.9E9 RETURN tcP;
    IF Abs(tcP.robax.rax_4)>8.9E9 OR Abs(tcP.robax.rax_5)>8.9E9 OR Abs(tcP.robax.rax_6)>8.9E9 RETURN tcP;
    IF NOT tcFits(tcTool\WObj?WObj) RETURN tcP;
    tcGoal:=CalcRobT(tcP,tcTool\WObj?WObj);
    IF NOT tcCorrect(tcGoal,tcP.robax,tcTool,-1@WOBJ@) RETURN tcP;
    tcJ:=CalcJointT(tcGoal,tcTool\WObj?WObj);
    IF tcFar(tcJ.robax,tcP.robax) RETURN tcP;
    tcP.robax:=tcJ.robax;
    RETURN tcP;
  ERROR
    IF ERRNO=ERR_ROBLIMIT OR ERRNO=ERR_OUTSIDE_REACH THEN
      tcWarn "No joints for a corrected joint target: original target";
      RETURN tcP;
    ENDIF
    RAISE;
  ENDFUNC

  LOCAL FUNC bool tcFar(robjoint tcIs,robjoint tcWas)
    ! Whether the joints would turn further than a correction turns them, degrees: near a singularity, or round to another turn
    IF Distance([tcIs.rax_1,tcIs.rax_2,tcIs.rax_3],[tcWas.rax_1,tcWas.rax_2,tcWas.rax_3])<=@CAP_JOINT@
      AND Distance([tcIs.rax_4,tcIs.rax_5,tcIs.rax_6],[tcWas.rax_4,tcWas.rax_5,tcWas.rax_6])<=@CAP_JOINT@ RETURN FALSE;
    tcWarn "A joint would turn too far, near a singularity: original target";
    RETURN TRUE;
  ENDFUNC

  LOCAL FUNC bool tcFits(PERS tooldata tcTool\PERS wobjdata WObj)
    ! Whether targets are corrected now, and the correction is that of an arm that holds the tool
    IF NOT tcOn RETURN FALSE;
fades#    IF @NONE@ RETURN FALSE;
    IF NOT tcTool.robhold THEN
      tcWarn "A stationary tool: original target";
      RETURN FALSE;
    ENDIF
    IF Present(WObj) THEN
      IF WObj.robhold OR (NOT WObj.ufprog) THEN
        tcWarn "A work object that moves: original target";
        RETURN FALSE;
      ENDIF
    ENDIF
    IF C_PROGDISP.pdisp.trans.x<>0 OR C_PROGDISP.pdisp.trans.y<>0 OR C_PROGDISP.pdisp.trans.z<>0
      OR C_PROGDISP.pdisp.rot.q2<>0 OR C_PROGDISP.pdisp.rot.q3<>0 OR C_PROGDISP.pdisp.rot.q4<>0
      OR C_PROGDISP.eoffs.eax_a<>0 OR C_PROGDISP.eoffs.eax_b<>0 OR C_PROGDISP.eoffs.eax_c<>0
      OR C_PROGDISP.eoffs.eax_d<>0 OR C_PROGDISP.eoffs.eax_e<>0 OR C_PROGDISP.eoffs.eax_f<>0 THEN
      tcWarn "A program displacement or axis offset is on: original target";
      RETURN FALSE;
    ENDIF
    RETURN TRUE;
  ENDFUNC

  LOCAL PROC tcWarn(string tcText)
    ! Once after each start of the program
    IF tcText<>tcWarned TPWrite tcText;
    tcWarned:=tcText;
  ENDPROC
