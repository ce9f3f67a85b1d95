  LOCAL FUNC num tcLags(num tcSpanMin,num tcTau)
    ! A time in lags, as far as Exp of it can be held
    IF tcSpanMin<=0 RETURN 0;
    IF tcSpanMin>80*tcTau RETURN 80;
    RETURN tcSpanMin/tcTau;
  ENDFUNC

  LOCAL FUNC num tcPart(num tcValue)
    IF tcValue<0 RETURN 0;
    IF tcValue>@MOST@ RETURN @MOST@;
    RETURN tcValue;
  ENDFUNC

  LOCAL FUNC num tcLn(num tcOf)
    ! Natural logarithm: roots until near 1, then the series of the inverse hyperbolic tangent
    VAR num tcX:=1E-33;
    VAR num tcTimes:=2;
    VAR num tcW:=0;
    IF tcOf>tcX tcX:=tcOf;
    WHILE tcX<0.7 OR tcX>1.4 DO
      tcX:=Sqrt(tcX);
      tcTimes:=2*tcTimes;
    ENDWHILE
    tcW:=(tcX-1)/(tcX+1);
    RETURN tcTimes*tcW*(1+tcW*tcW/3+tcW*tcW*tcW*tcW/5);
  ENDFUNC
