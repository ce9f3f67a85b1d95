  TASK PERS num tcBucket:=-1;
  VAR num tcI:=1;
