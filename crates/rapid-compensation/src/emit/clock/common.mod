  LOCAL PROC tcSay(string tcText)
    IF tcText<>tcSaid TPWrite tcText;
    tcSaid:=tcText;
  ENDPROC

  LOCAL FUNC num tcDayNumber(string tcDate)
    ! Day 1 is 2000-01-01; a year is counted from March
    VAR num tcYear:=0;
    VAR num tcMonth:=0;
    tcYear:=tcNumber(tcDate,1,4);
    tcMonth:=tcNumber(tcDate,6,2);
    IF tcYear<2000 OR tcMonth<1 OR tcMonth>12 RETURN -1;
    IF tcMonth<3 THEN
      tcYear:=tcYear-1;
      tcMonth:=tcMonth+12;
    ENDIF
    RETURN tcNumber(tcDate,9,2)+(153*tcMonth-457) DIV 5+365*(tcYear-2000)
        +tcYear DIV 4-tcYear DIV 100+tcYear DIV 400-425;
  ENDFUNC

  LOCAL FUNC num tcSecond(string tcTime)
    ! Of the day
    RETURN 3600*tcNumber(tcTime,1,2)+60*tcNumber(tcTime,4,2)+tcNumber(tcTime,7,2);
  ENDFUNC

  LOCAL FUNC num tcNumber(string tcText,num tcFrom,num tcLength)
    VAR num tcValue:=0;
    IF StrToVal(StrPart(tcText,tcFrom,tcLength),tcValue) RETURN tcValue;
    RETURN -9999;
  ENDFUNC

  LOCAL FUNC num tcSpan(num tcDay0,num tcSec0,num tcDay1,num tcSec1)
    ! Minutes; days first, so that single precision is enough
    RETURN 1440*(tcDay1-tcDay0)+(tcSec1-tcSec0)/60;
  ENDFUNC
