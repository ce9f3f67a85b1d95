  PROC tcUpdate()
    ! Brings @WHAT@ up to date; asked again in the same second it does nothing
    IF CTime()<>tcTimeSeen OR CDate()<>tcDateSeen OR tcMode<>tcModeSeen tcRenew;
  ENDPROC

  LOCAL PROC tcRenew()
    VAR string tcDate:="";
    VAR string tcTime:="";
    VAR bool tcGood:=FALSE;
    ! Date, time, and the date again: midnight may pass between the two
    tcDate:=CDate();
    tcTime:=CTime();
    IF CDate()<>tcDate THEN
      tcDate:=CDate();
      tcTime:=CTime();
    ENDIF
    ! From here on a trap that asks uses what is there
    tcDateSeen:=tcDate;
    tcModeSeen:=tcMode;
    tcTimeSeen:=tcTime;
    tcGood:=tcAdvance(tcDayNumber(tcDate),tcSecond(tcTime));
touch#    tcAlive:=tcGood;
touch#    IF tcGood tcShow;
    IF tcMode=-1 AND (NOT tcGood) THEN
      IF tcState{3}=0 THEN
        tcSay "@UNKNOWN@";
      ELSE
        tcSay "@CANNOT@";
      ENDIF
    ELSEIF tcMode=-1 THEN
      tcSaid:="";
    ELSEIF tcMode=-2 THEN
      tcSay "tcMode is -2: original targets";
    ENDIF
    tcChoose tcGood;
  ENDPROC
