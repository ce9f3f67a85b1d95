  LOCAL PROC tcChoose(bool tcGood)
    IF tcMode=-1 AND tcGood THEN
      @SCALE@;
    ELSEIF tcMode>=0 AND tcMode<=100 THEN
      @FORCED@;
      tcSay "tcMode holds a share of the drift";
    ELSE
      IF tcMode<>-1 AND tcMode<>-2 tcSay "tcMode is none of -2..100: original targets";
      tcOn:=FALSE;
      tcShare:=0;
    ENDIF
  ENDPROC
