  FUNC num tcK()
    ! The element in force: 1 the original targets, k+1 those of bucket k
    tcUpdate;
    RETURN tcI;
  ENDFUNC

  LOCAL PROC tcChoose(bool tcGood)
    VAR num tcNew:=-1;
    IF tcMode=-1 AND tcGood THEN
      TEST Trunc(@PARTS@@INDEX@)
@CASES@
      ENDTEST
    ELSEIF tcMode>=0 AND tcMode<@COUNT@ AND tcMode=Trunc(tcMode) THEN
      tcNew:=tcMode;
      tcSay "tcMode holds one bucket of targets";
    ELSEIF tcMode<>-1 AND tcMode<>-2 THEN
      tcSay "tcMode is none of -2..@LAST@: original targets";
    ENDIF
    tcBucket:=tcNew;
    tcI:=tcNew+2;
  ENDPROC
