  LOCAL FUNC bool tcAdvance(num tcDay,num tcSec)
    ! tcState: the minute at a start; 0; day and second of the start; of the last motion that asked
    VAR num tcA:=0;
    VAR num tcRun:=0;
    VAR num tcGap:=0;
    tcA:=tcState{1};
    tcRun:=tcSpan(tcState{3},tcState{4},tcState{5},tcState{6});
    tcGap:=tcSpan(tcState{5},tcState{6},tcDay,tcSec);
    IF NOT (tcA>=0 AND tcRun>=0) RETURN FALSE;
    IF tcDay<1 OR tcSec<0 OR tcState{3}<1 OR tcGap<-1500 RETURN FALSE;
    IF tcGap<0 THEN
      ! The clock was set back: that counts as no time
      tcA:=tcA+tcRun;
      tcState:=[tcA,0,tcDay,tcSec,tcDay,tcSec];
      tcRun:=0;
    ELSE
      tcRun:=tcSpan(tcState{3},tcState{4},tcDay,tcSec);
      tcState:=[tcA,0,tcState{3},tcState{4},tcDay,tcSec];
    ENDIF
    tcMinute:=tcA+tcRun;
@GROWN@
    RETURN TRUE;
  ENDFUNC
