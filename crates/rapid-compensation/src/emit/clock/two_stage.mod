  LOCAL FUNC bool tcAdvance(num tcDay,num tcSec)
    ! tcState: both lags, 0 cold to 1 warm, at a start; day and second of the start; of the last motion that asked
    VAR num tcA:=0;
    VAR num tcB:=0;
    VAR num tcRun:=0;
    VAR num tcGap:=0;
    VAR num tcS:=0;
    VAR num tcE:=0;
    tcA:=tcState{1};
    tcB:=tcState{2};
    tcRun:=tcSpan(tcState{3},tcState{4},tcState{5},tcState{6});
    tcGap:=tcSpan(tcState{5},tcState{6},tcDay,tcSec);
    IF NOT (tcA>=0 AND tcA<=@MOST@ AND tcB>=0 AND tcB<=@MOST@ AND tcRun>=0) RETURN FALSE;
    IF tcDay<1 OR tcSec<0 OR tcState{3}<1 OR tcGap<-1500 RETURN FALSE;
    IF tcGap<0 OR tcGap>@GAP@ THEN
      ! Stood still, or clock set back: up to the last motion it worked, then it cooled
      tcS:=tcLags(tcRun,@TAU@);
      tcE:=Exp(-tcS);
touch#      tcTo:=tcBy;
touch#      tcCarry tcS,tcE,tcA,tcB,tcAmount,1;
      tcB:=tcPart(@FULL@+(tcB-@FULL@+(tcA-@FULL@)*tcS)*tcE);
      tcA:=tcPart(@FULL@+(tcA-@FULL@)*tcE);
      tcS:=tcLags(tcGap,@TAU_COOL@);
      tcE:=Exp(-tcS);
touch#      tcCarry tcS,tcE,tcA,tcB,0,0;
touch#      tcBy:=tcTo;
      tcB:=tcPart((tcB+tcA*tcS)*tcE);
      tcA:=tcA*tcE;
      tcState:=[tcA,tcB,tcDay,tcSec,tcDay,tcSec];
      tcRun:=0;
    ELSE
      tcRun:=tcSpan(tcState{3},tcState{4},tcDay,tcSec);
      tcState:=[tcA,tcB,tcState{3},tcState{4},tcDay,tcSec];
    ENDIF
    tcS:=tcLags(tcRun,@TAU@);
    tcE:=(@FULL@-tcB+(@FULL@-tcA)*tcS)*Exp(-tcS);
@MINUTE@
@GROWN@
    RETURN TRUE;
  ENDFUNC

  LOCAL FUNC num tcMinuteOf(num tcRest)
    ! The minute after a cold start at which this share is still to come: (1+s)*Exp(-s)=tcRest
    VAR num tcL:=0;
    VAR num tcS:=0;
    IF tcRest>=1 RETURN 0;
    tcL:=-tcLn(tcRest);
    tcS:=Sqrt(2*tcL);
    tcS:=tcS+tcS*tcS/3+tcS*tcS*tcS/36;
    IF tcS>0.05 THEN
      FOR tcN FROM 1 TO 3 DO
        tcS:=tcS-(tcS-tcLn(1+tcS)-tcL)*(1+tcS)/tcS;
      ENDFOR
    ENDIF
    RETURN @TABLE_TAU@*tcS;
  ENDFUNC
