  LOCAL FUNC bool tcAdvance(num tcDay,num tcSec)
    ! tcState: last good and last reading; day and second of the last good one; of the last change
    VAR num tcNew:=0;
    tcNew:=tcRead();
    IF tcDay<1 OR tcSec<0 RETURN FALSE;
    IF tcState{3}>0 THEN
      ! The clock was set back: that counts as no time
      IF tcSpan(tcState{3},tcState{4},tcDay,tcSec)<0 tcState:=[tcState{1},tcState{2},tcDay,tcSec,tcState{5},tcState{6}];
      IF tcSpan(tcState{5},tcState{6},tcDay,tcSec)<0 tcState:=[tcState{1},tcState{2},tcState{3},tcState{4},tcDay,tcSec];
    ENDIF
    IF tcNew>=@LOW@ AND tcNew<=@HIGH@ THEN
      IF tcNew<>tcState{2} OR tcState{5}<1 THEN
        tcState:=[tcNew,tcNew,tcDay,tcSec,tcDay,tcSec];
      ELSEIF tcSpan(tcState{5},tcState{6},tcDay,tcSec)<=@STALE@ THEN
        tcState:=[tcNew,tcNew,tcDay,tcSec,tcState{5},tcState{6}];
      ENDIF
    ENDIF
    IF tcState{3}<1 RETURN FALSE;
    IF tcSpan(tcState{3},tcState{4},tcDay,tcSec)>@HOLD@ RETURN FALSE;
    tcDegrees:=tcState{1};
    RETURN TRUE;
  ENDFUNC

  LOCAL FUNC num tcRead()
    ! Degrees Celsius; where the unit is down, what no robot can have
    RETURN @READ@;
  ERROR
    RETURN 9999;
  ENDFUNC

  LOCAL FUNC num tcAbove()
    ! Degrees above the coldest of the table
    IF tcDegrees<@FROM@ RETURN 0;
    RETURN tcDegrees-@FROM@;
  ENDFUNC
