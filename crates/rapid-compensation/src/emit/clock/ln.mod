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
