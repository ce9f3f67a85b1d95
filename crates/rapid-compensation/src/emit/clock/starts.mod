  PROC tcColdStart()
    ! To be called once, when the robot is cold
log#    tcLogFile:="";
    tcBegin 0,0;
  ENDPROC

  PROC tcWarmStart()
    ! To be called when the robot is fully warm
    tcBegin @WARM@;
  ENDPROC

  PROC tcStartAt(num tcRunMinutes)
    ! To be called when the robot was cold so many minutes of work ago
    @START_AT@
  ENDPROC

  LOCAL PROC tcBegin(num tcFirst,num tcSecond0)
    VAR string tcDate:="";
    VAR string tcTime:="";
    tcDate:=CDate();
    tcTime:=CTime();
    IF CDate()<>tcDate THEN
      tcDate:=CDate();
      tcTime:=CTime();
    ENDIF
    IF tcFirst=0 THEN
      ! Set back to cold: what is lost is told
      IF tcAdvance(tcDayNumber(tcDate),tcSecond(tcTime)) THEN
        IF tcMinute>=1 TPWrite "Warm-up clock set to 0, it stood at minute "\Num:=Round(tcMinute);
      ENDIF
    ENDIF
    tcState:=[tcFirst,tcSecond0,tcDayNumber(tcDate),tcSecond(tcTime),tcDayNumber(tcDate),tcSecond(tcTime)];
touch#    tcForget;
    tcTimeSeen:="";
    tcUpdate;
  ENDPROC
