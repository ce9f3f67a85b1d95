  LOCAL FUNC bool tcAdvance(num tcDay,num tcSec)
    ! tcState: the lag, 0 cold to 1 warm, at a start; 0; day and second of the start; of the last motion that asked
    VAR num tcA:=0;
    VAR num tcRun:=0;
    VAR num tcGap:=0;
    VAR num tcE:=0;
    tcA:=tcState{1};
    tcRun:=tcSpan(tcState{3},tcState{4},tcState{5},tcState{6});
    tcGap:=tcSpan(tcState{5},tcState{6},tcDay,tcSec);
    IF NOT (tcA>=0 AND tcA<=@MOST@ AND tcRun>=0) RETURN FALSE;
    IF tcDay<1 OR tcSec<0 OR tcState{3}<1 OR tcGap<-1500 RETURN FALSE;
    IF tcGap<0 OR tcGap>@GAP@ THEN
      ! Stood still, or clock set back: up to the last motion it worked, then it cooled
touch#      tcTo:=tcBy;
touch#      tcCarry tcLags(tcRun,@TAU@),Exp(-tcLags(tcRun,@TAU@)),tcA,0,tcAmount,1;
      tcA:=tcPart(@FULL@+(tcA-@FULL@)*Exp(-tcLags(tcRun,@TAU@)));
touch#      tcCarry tcLags(tcGap,@TAU_COOL@),Exp(-tcLags(tcGap,@TAU_COOL@)),tcA,0,0,0;
touch#      tcBy:=tcTo;
      tcA:=tcA*Exp(-tcLags(tcGap,@TAU_COOL@));
      tcState:=[tcA,0,tcDay,tcSec,tcDay,tcSec];
      tcRun:=0;
    ELSE
      tcRun:=tcSpan(tcState{3},tcState{4},tcDay,tcSec);
      tcState:=[tcA,0,tcState{3},tcState{4},tcDay,tcSec];
    ENDIF
    tcE:=(@FULL@-tcA)*Exp(-tcLags(tcRun,@TAU@));
@MINUTE@
@GROWN@
    RETURN TRUE;
  ENDFUNC

  LOCAL FUNC num tcMinuteOf(num tcRest)
    ! The minute after a cold start at which this share is still to come: Exp(-s)=tcRest
    IF tcRest>=1 RETURN 0;
    RETURN -@TABLE_TAU@*tcLn(tcRest);
  ENDFUNC
