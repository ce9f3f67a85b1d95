  LOCAL FUNC num tcLags(num tcSpanMin,num tcTau)
    ! A time in lags, as far as Exp of it can be held
    IF tcSpanMin<=0 RETURN 0;
    IF tcSpanMin>80*tcTau RETURN 80;
    RETURN tcSpanMin/tcTau;
  ENDFUNC
