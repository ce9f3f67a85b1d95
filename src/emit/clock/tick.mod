  PROC tcTick()
    ! Brings @WHAT@ up to date and chooses the targets
    VAR num tcK:=-1;
    VAR bool tcGood:=FALSE;
    tcNow;
    IF tcMode=tcModeSeen AND tcDate=tcDateSeen AND tcSec>=tcSecSeen AND tcSec<tcSecSeen+@EVERY_S@ RETURN;
    tcDay:=tcDayNumber();
    tcGood:=tcUpdate();
    tcModeSeen:=tcMode;
    tcDateSeen:=tcDate;
    tcSecSeen:=tcSec;
    IF tcMode=-1 THEN
      IF tcGood THEN
        TEST Trunc(@PARTS@@INDEX@)
@CASES@
        ENDTEST
      ELSEIF tcState{3}=0 THEN
        tcSay "@UNKNOWN@";
      ELSE
        tcSay "@CANNOT@";
      ENDIF
    ELSEIF tcMode>=0 AND tcMode<@COUNT@ AND tcMode=Trunc(tcMode) THEN
      tcK:=tcMode;
    ELSEIF tcMode<>-2 THEN
      tcSay "tcMode is none of -2..@LAST@: original targets";
    ENDIF
@LOAD@
    IF tcK>=0 tcSaid:=FALSE;
    tcBucket:=tcK;
    tcI:=tcK+2;
  ENDPROC
