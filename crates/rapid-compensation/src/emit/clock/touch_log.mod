  LOCAL PROC tcLog(robtarget tcP)
    ! Writes where the point was found as a line that driftpost state reads; a file of its own from each cold start on
    VAR iodev tcFile;
    VAR jointtarget tcJ;
    VAR string tcTime:="";
    VAR bool tcIs:=TRUE;
    tcJ:=CalcJointT(tcP,@TOOL@);
    IF tcLogFile="" THEN
      tcTime:=CTime();
      tcLogFile:="tc@NAME@_"+CDate()+"_"+StrPart(tcTime,1,2)+StrPart(tcTime,4,2)+StrPart(tcTime,7,2)+".csv";
      tcLogged:=[tcState{5},tcState{6},0];
    ENDIF
    Open "HOME:"\File:=tcLogFile,tcFile\Append;
    IF tcLogged{3}=0 Write tcFile,"fixed_id,t_min,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg";
    Write tcFile,"@NAME@,"+NumToStr(tcSpan(tcLogged{1},tcLogged{2},tcState{5},tcState{6}),2)\NoNewLine;
    Write tcFile,","+NumToStr(tcJ.robax.rax_1,5)+","+NumToStr(tcJ.robax.rax_2,5)\NoNewLine;
    Write tcFile,","+NumToStr(tcJ.robax.rax_3,5)+","+NumToStr(tcJ.robax.rax_4,5)\NoNewLine;
    Write tcFile,","+NumToStr(tcJ.robax.rax_5,5)+","+NumToStr(tcJ.robax.rax_6,5);
    Close tcFile;
    IF tcIs THEN
      tcLogged{3}:=1;
      RETURN;
    ENDIF
    TPWrite "Touch not logged: "+tcLogFile;
  ERROR
    ! What is measured counts, logged or not
    tcIs:=FALSE;
    TRYNEXT;
  ENDPROC
