  FUNC robtarget tcAtOne(robtarget tcP,pose tcC{*,*})
    ! Of some targets the one that it is, touched up or not, with its correction; any other as it stands
    VAR num tcBest:=0;
    VAR num tcFar:=@NEAR@;
    FOR tcN FROM 1 TO Dim(tcC,1) DO
      IF Distance(tcP.trans,tcC{tcN,1}.trans)<tcFar AND Abs(tcP.rot.q1*tcC{tcN,1}.rot.q1+tcP.rot.q2*tcC{tcN,1}.rot.q2
        +tcP.rot.q3*tcC{tcN,1}.rot.q3+tcP.rot.q4*tcC{tcN,1}.rot.q4)>0.999 THEN
        tcBest:=tcN;
        tcFar:=Distance(tcP.trans,tcC{tcN,1}.trans);
      ENDIF
    ENDFOR
    IF tcBest>0 RETURN tcAt(tcP,@OF_BEST@);
    tcUpdate;
    tcSay "A target is none of those that were known: it stays as it is";
    RETURN tcP;
  ENDFUNC
