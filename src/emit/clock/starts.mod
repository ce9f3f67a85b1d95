  PROC tcColdStart()
    ! To be called when the robot is cold
    tcBegin 0;
  ENDPROC

  PROC tcWarmStart()
    ! To be called when the robot is fully warm
    tcBegin @WARM@;
  ENDPROC

  LOCAL PROC tcBegin(num tcValue)
    tcNow;
    tcDay:=tcDayNumber();
    tcState:=[tcValue,@SECOND@,tcDay,tcSec,tcDay,tcSec];
    tcDateSeen:="";
    tcTick;
  ENDPROC
