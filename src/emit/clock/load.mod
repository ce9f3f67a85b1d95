  LOCAL FUNC num tcLoad(num tcWanted)
    ! The bucket whose module is loaded when this is done; -1 for none, whatever went wrong
    VAR num tcIs:=-1;
    VAR num tcMade:=0;
    IF tcWanted=tcLoaded RETURN tcLoaded;
    IF tcWanted=tcFailed RETURN -1;
    tcFailed:=tcWanted;
    IF tcLoaded>=0 UnLoad tcFile(tcLoaded);
    tcLoaded:=-1;
    Load\Dynamic,tcFile(tcWanted);
    %"tcWho"% tcIs,tcMade;
    IF tcIs=tcWanted AND tcMade=@ID@ THEN
      tcLoaded:=tcWanted;
      tcFailed:=-1;
      RETURN tcLoaded;
    ENDIF
    tcSay "The module of a bucket is of another program: original targets";
    UnLoad tcFile(tcWanted);
    RETURN -1;
  ERROR
    IF ERRNO=ERR_LOADED TRYNEXT;
    IF ERRNO=ERR_UNLOAD AND tcLoaded>=0 THEN
      IF NOT ModExist("@STEM@"+ValToStr(tcLoaded)) TRYNEXT;
      ! It is in execution and goes on being used
      tcFailed:=-1;
      RETURN tcLoaded;
    ENDIF
    tcSay "The module of a bucket does not load: original targets";
    RETURN -1;
  ENDFUNC

  LOCAL FUNC string tcFile(num tcOf)
    RETURN "HOME:/@STEM@"+ValToStr(tcOf)+".mod";
  ENDFUNC
