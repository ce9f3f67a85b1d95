  LOCAL FUNC num tcPart(num tcValue)
    IF tcValue<0 RETURN 0;
    IF tcValue>@MOST@ RETURN @MOST@;
    RETURN tcValue;
  ENDFUNC
