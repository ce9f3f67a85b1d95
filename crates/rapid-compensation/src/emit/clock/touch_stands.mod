  LOCAL FUNC bool tcStands(robtarget tcP)
    ! Whether a target means the joints that were reckoned with, and nothing shifts it
    VAR jointtarget tcJ;
    IF C_PROGDISP.pdisp.trans.x<>0 OR C_PROGDISP.pdisp.trans.y<>0 OR C_PROGDISP.pdisp.trans.z<>0
      OR C_PROGDISP.pdisp.rot.q2<>0 OR C_PROGDISP.pdisp.rot.q3<>0 OR C_PROGDISP.pdisp.rot.q4<>0
      RETURN FALSE;
    tcJ:=CalcJointT(tcP,@TOOL@);
    RETURN Abs(tcJ.robax.rax_1-@Q1@)<1 AND Abs(tcJ.robax.rax_2-@Q2@)<1 AND Abs(tcJ.robax.rax_3-@Q3@)<1
      AND Abs(tcJ.robax.rax_4-@Q4@)<1 AND Abs(tcJ.robax.rax_5-@Q5@)<1 AND Abs(tcJ.robax.rax_6-@Q6@)<1;
  ERROR
    RETURN FALSE;
  ENDFUNC
