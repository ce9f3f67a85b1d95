  TASK PERS num tcShare:=0;
  LOCAL VAR bool tcOn:=FALSE;
