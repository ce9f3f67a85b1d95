  LOCAL FUNC bool tcAdvance(num tcDay,num tcSec)
    ! tcState: the lag, 0 cold to 1 warm, at a start; 0; day and second of the start; of the last motion that asked
    VAR num tcA:=0;
    VAR num tcRun:=0;
    VAR num tcGap:=0;
    VAR num tcE:=0;
    tcA:=tcState{1};
    tcRun:=tcSpan(tcState{3},tcState{4},tcState{5},tcState{6});
    tcGap:=tcSpan(tcState{5},tcState{6},tcDay,tcSec);
    IF NOT (tcA>=0 AND tcA<=1 AND tcRun>=0) RETURN FALSE;
    IF tcDay<1 OR tcSec<0 OR tcState{3}<1 OR tcGap<-1500 RETURN FALSE;
    IF tcGap<0 OR tcGap>@GAP@ THEN
      ! Stood still, or clock set back: up to the last motion it worked, then it cooled
      tcA:=tcPart(1+(tcA-1)*Exp(-tcLags(tcRun,@TAU@)));
      tcA:=tcA*Exp(-tcLags(tcGap,@TAU_COOL@));
      tcState:=[tcA,0,tcDay,tcSec,tcDay,tcSec];
      tcRun:=0;
    ELSE
      tcRun:=tcSpan(tcState{3},tcState{4},tcDay,tcSec);
      tcState:=[tcA,0,tcState{3},tcState{4},tcDay,tcSec];
    ENDIF
    tcE:=(1-tcA)*Exp(-tcLags(tcRun,@TAU@));
    tcMinute:=tcMinuteOf(tcE);
@GROWN@
    RETURN TRUE;
  ENDFUNC

  LOCAL FUNC num tcMinuteOf(num tcRest)
    ! The minute after a cold start at which this share is still to come: Exp(-s)=tcRest
    IF tcRest>=1 RETURN 0;
    RETURN -@TAU@*tcLn(tcRest);
  ENDFUNC
