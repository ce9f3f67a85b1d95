  FUNC robtarget tcAtOne(robtarget tcP,pose tcC{*,*},num tcRow{*})
    ! Of some targets the one that it is, with its correction; tcRow: which one, by a sum over its pose
    VAR num tcBest:=0;
    tcUpdate;
    tcBest:=@BEST@;
    IF Distance(tcP.trans,tcC{tcBest,1}.trans)>tcRow{1} OR @ALIKE_BEST@<@SAME@ RETURN tcAtNear(tcP,tcC);
    RETURN tcAtSame(tcP,@OF_BEST@);
  ENDFUNC

  LOCAL FUNC robtarget tcAtNear(robtarget tcP,pose tcC{*,*})
    ! The same for one that was touched up: the nearest one; any other as it stands
    VAR num tcBest:=0;
    VAR num tcFar:=@NEAR@;
    FOR tcN FROM 1 TO Dim(tcC,1) DO
      IF Distance(tcP.trans,tcC{tcN,1}.trans)<tcFar AND @ALIKE_N@>0.999 THEN
        tcBest:=tcN;
        tcFar:=Distance(tcP.trans,tcC{tcN,1}.trans);
      ENDIF
    ENDFOR
    IF tcBest>0 RETURN tcAtSame(tcP,@OF_BEST@);
    tcSay "A target is none of those that were known: it stays as it is";
    RETURN tcP;
  ENDFUNC
