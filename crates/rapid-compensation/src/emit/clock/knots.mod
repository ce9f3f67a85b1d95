  LOCAL PROC tcScaleAt(num tcAtMinute,num tcPart0)
    ! Linear between knots
    VAR num tcLow:=1;
    VAR num tcHigh:=@KNOTS@;
    VAR num tcMid:=0;
    VAR num tcS:=0;
    WHILE tcHigh-tcLow>1 DO
      tcMid:=(tcLow+tcHigh) DIV 2;
      IF tcKnot{tcMid,1}>tcAtMinute THEN
        tcHigh:=tcMid;
      ELSE
        tcLow:=tcMid;
      ENDIF
    ENDWHILE
    IF tcHigh>tcLow tcS:=tcPart((tcAtMinute-tcKnot{tcLow,1})/(tcKnot{tcHigh,1}-tcKnot{tcLow,1}));
@FUNCTIONS@
    tcShare:=tcPart0*@SHOWN_SHARE@;
    tcOn:=tcPart0<>0;
  ENDPROC
