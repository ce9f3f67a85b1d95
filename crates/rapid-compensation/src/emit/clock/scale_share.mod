  LOCAL PROC tcScale(num tcOf)
    tcF1:=tcOf;
    tcShare:=tcOf;
    tcOn:=tcOf<>0;
  ENDPROC
