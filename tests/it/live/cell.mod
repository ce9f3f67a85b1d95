  LOCAL VAR bool tcOn:=TRUE;
  LOCAL VAR bool tcSaid:=FALSE;
  VAR num tcUpdates:=0;
  VAR num k:=1;
  PERS tooldata tOut:=[FALSE,[[400,0,400],[1,0,0,0]],[1,[0,0,1],[1,0,0,0],0,0,0]];
  PERS wobjdata wHeld:=[TRUE,TRUE,"",[[0,0,0],[1,0,0,0]],[[0,0,0],[1,0,0,0]]];
  PERS wobjdata wMoved:=[FALSE,FALSE,"STN1",[[0,0,0],[1,0,0,0]],[[0,0,0],[1,0,0,0]]];
  CONST robtarget good:=[[400,150,250],[0.70710678,0,0.70710678,0.00000001],[0,0,-1,1],[9E9,9E9,9E9,9E9,9E9,9E9]];
  CONST jointtarget unused:=[[10,9E9,20,0,30,0],[1,2,9E9,9E9,9E9,9E9]];
  CONST jointtarget straight:=[[10,20,20,9E9,30,0],[1,2,9E9,9E9,9E9,9E9]];
  CONST jointtarget singular:=[[10,20,20,105,0.001,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  CONST jointtarget flipped:=[[10,20,20,105,0.2,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  CONST jointtarget stretched:=[[3,60,-89.9,5,30,-40],[9E9,9E9,9E9,9E9,9E9,9E9]];
  CONST jointtarget atLimit:=[[3,110,-60,5,30,5],[9E9,9E9,9E9,9E9,9E9,9E9]];
  CONST jointtarget halfRound:=[[-180,0,0,5,30,5],[9E9,9E9,9E9,9E9,9E9,9E9]];
  VAR jointtarget flippedIs;
  VAR jointtarget unusedIs;
  VAR jointtarget straightIs;
  VAR jointtarget singularIs;
  VAR robtarget given;
  VAR robtarget is;
  VAR robtarget plainly;

  PROC tcUpdate()
    tcUpdates:=tcUpdates+1;
  ENDPROC

  LOCAL PROC tcSay(string tcText)
    IF NOT tcSaid TPWrite tcText;
    tcSaid:=TRUE;
  ENDPROC

  PROC plain()
    PDispOff;
    EOffsOff;
    given:=good;
    is:=tcLive(given,tT\WObj:=wW);
  ENDPROC

  PROC ownTool()
    is:=tcLive(good,tool0);
  ENDPROC

  PROC ownToolAndObject()
    is:=tcLive(good,tool0\WObj:=wobj0);
  ENDPROC

  PROC same()
    is:=tcLiveSame(given,tT\WObj:=wW);
  ENDPROC

  PROC tooFar()
    given:=Offs(good,2000,0,0);
    is:=tcLive(given,tT\WObj:=wW);
    is:=tcLive(given,tT\WObj:=wW);
  ENDPROC

  PROC atSingular()
    given:=CalcRobT(singular,tT\WObj:=wW);
    is:=tcLive(given,tT\WObj:=wW);
  ENDPROC

  PROC atFlipped()
    given:=CalcRobT(flipped,tT\WObj:=wW);
    is:=tcLive(given,tT\WObj:=wW);
  ENDPROC

  PROC atStretched()
    given:=CalcRobT(stretched,tT\WObj:=wW);
    is:=tcLive(given,tT\WObj:=wW);
  ENDPROC

  PROC atAtLimit()
    given:=CalcRobT(atLimit,tT\WObj:=wW);
    is:=tcLive(given,tT\WObj:=wW);
  ENDPROC

  PROC atHalfRound()
    given:=CalcRobT(halfRound,tT\WObj:=wW);
    is:=tcLive(given,tT\WObj:=wW);
  ENDPROC

  PROC wrongConf()
    given:=good;
    given.robconf:=[3,3,3,0];
    is:=tcLive(given,tT\WObj:=wW);
  ENDPROC

  PROC displaced()
    PDispSet [[0,0,10],[1,0,0,0]];
    given:=good;
    is:=tcLive(given,tT\WObj:=wW);
  ENDPROC

  PROC displacedOn()
    MoveAbsJ [[41.845157,44.625236,25.881200,43.530476,-75.605869,-13.287258],[9E9,9E9,9E9,9E9,9E9,9E9]],v100,fine,tT;
    given:=good;
    PDispOn given,tT;
    is:=tcLive(given,tT\WObj:=wW);
  ENDPROC

  PROC axisOffset()
    EOffsSet [0,0,0,5,0,0];
    given:=good;
    is:=tcLive(given,tT\WObj:=wW);
  ENDPROC

  PROC stationary()
    given:=good;
    is:=tcLive(given,tOut\WObj:=wHeld);
    is:=tcLive(given,tOut\WObj:=wHeld);
  ENDPROC

  PROC objectHeld()
    given:=good;
    is:=tcLive(given,tT\WObj:=wHeld);
  ENDPROC

  PROC objectMoved()
    given:=good;
    is:=tcLive(given,tT\WObj:=wMoved);
  ENDPROC

  PROC notNormalised()
    given:=good;
    given.rot:=[1,1,0,0];
    is:=tcLive(given,tT\WObj:=wW);
  ENDPROC

  PROC oneJ()
    unusedIs:=tcLiveJ(unused,tT);
    straightIs:=tcLiveJ(straight,tT);
  ENDPROC

  PROC singularJ()
    singularIs:=tcLiveJ(singular,tT);
  ENDPROC

  PROC flippedJ()
    flippedIs:=tcLiveJ(flipped,tT);
  ENDPROC

