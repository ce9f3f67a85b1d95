  TASK PERS num tcMode:=-1;
  TASK PERS num @SHOWN@:=0;
  LOCAL PERS num tcState{6}:=[0,0,0,0,0,0];
  LOCAL VAR num tcModeSeen:=-1;
  LOCAL VAR string tcDateSeen:="";
  LOCAL VAR string tcTimeSeen:="";
  LOCAL VAR string tcSaid:="";
