  PROC tcTouch()
    ! Measures at a fixed point how warm the arm is, again where a touch surprises; one that is refused leaves the state as it is
    VAR robtarget tcWhere;
    VAR robtarget tcFound;
    VAR robtarget tcMeant;
    VAR bool tcIs:=FALSE;
    tcTouchSaid:="";
    tcSeen:=[0,0,0,0];
    tcUpdate;
    IF NOT tcAlive tcBegin tcPart(tcAmount/2),@SECOND_HALF@;
    IF NOT (tcAlive AND tcStands(@POINT@)) THEN
      tcRefuse "the arm is not where it should be";
      RETURN;
    ENDIF
    tcWhere:=Offs(@COLD@,@DX@*tcHas,@DY@*tcHas,@DZ@*tcHas);
    tcMeant:=@COLD@;
    FOR tcN FROM 1 TO @TRIES@ DO
      tcProbe tcWhere,tcFound,tcIs;
      tcUpdate;
      IF NOT tcIs THEN
        tcRefuse "the point was not found";
        RETURN;
      ELSEIF NOT (tcAlive AND tcStands(tcFound)) THEN
        tcRefuse "the arm is not where it should be";
        RETURN;
      ENDIF
log#      tcLog tcFound;
      tcLearn tcFound.trans.x-tcMeant.trans.x,tcFound.trans.y-tcMeant.trans.y,tcFound.trans.z-tcMeant.trans.z;
      IF tcTouchSaid="Touch taken" RETURN;
    ENDFOR
    TPWrite tcTouchSaid;
    IF tcSeen{4}=1 tcTouched:=[tcTouched{1},tcTouched{2},tcSeen{3},1,tcTouched{5}];
  ENDPROC

  LOCAL PROC tcRefuse(string tcWhy)
    tcTouchSaid:="Touch refused: "+tcWhy;
    TPWrite tcTouchSaid;
  ENDPROC

  LOCAL PROC tcForget()
    ! After a start the lags are as good as unknown; what was learnt of the robot stays
    tcBy:=[[1,0,0,0,0],[0,1,0,0,0]];
    FOR tcN FROM 1 TO 5 DO
      tcKnown{1,tcN}:=0;
      tcKnown{tcN,1}:=0;
      tcKnown{2,tcN}:=0;
      tcKnown{tcN,2}:=0;
    ENDFOR
    tcKnown{1,1}:=@P11@;
    tcKnown{1,2}:=@P12@;
    tcKnown{2,1}:=@P12@;
    tcKnown{2,2}:=@P22@;
    tcTouched:=[tcState{3},tcState{4},0,0,0];
  ENDPROC

  LOCAL PROC tcCarry(num tcS,num tcE,num tcA,num tcB,num tcU,num tcW)
    ! How lags tcA, tcB depend, so many lags later, on what tcTo has them depend on: towards tcU, working (tcW 1) or not (0)
    VAR num tcC:=0;
    VAR num tcD:=0;
    tcC:=tcS*tcE*(tcA-tcU);
    tcD:=tcS*tcE*(tcB-tcU+(tcA-tcU)*(tcS-1));
    tcTo:=[[tcE*tcTo{1,1},tcE*tcTo{1,2},tcE*tcTo{1,3}+tcW*(1-tcE),tcE*tcTo{1,4}+tcW*tcC,tcE*tcTo{1,5}+(1-tcW)*tcC],
      [tcE*(tcTo{2,1}+tcS*tcTo{1,1}),tcE*(tcTo{2,2}+tcS*tcTo{1,2}),
      tcE*(tcTo{2,3}+tcS*tcTo{1,3})+tcW*(1-(1+tcS)*tcE),
      tcE*(tcTo{2,4}+tcS*tcTo{1,4})+tcW*tcD,tcE*(tcTo{2,5}+tcS*tcTo{1,5})+(1-tcW)*tcD]];
  ENDPROC

  LOCAL PROC tcReach()
    ! From what was known last to now; tcLag1 is then the first lag
    VAR num tcS:=0;
    VAR num tcE:=0;
    tcS:=tcLags(tcSpan(tcState{3},tcState{4},tcState{5},tcState{6}),tcTau);
    tcE:=Exp(-tcS);
    tcTo:=tcBy;
    tcCarry tcS,tcE,tcState{1},tcState{2},tcAmount,1;
    tcLag1:=tcPart(tcAmount+(tcState{1}-tcAmount)*tcE);
    tcHours:=tcSpan(tcTouched{1},tcTouched{2},tcState{5},tcState{6})/60;
    IF tcHours<0 tcHours:=0;
    IF tcHours>24 tcHours:=24;
  ENDPROC

  LOCAL PROC tcShow()
    ! Minutes since the last touch, and one standard deviation where the drift is largest, mm
    IF tcTouched{5}=0 THEN
      tcTouchAge:=-1;
      tcTouchSigma:=-1;
      RETURN;
    ENDIF
    tcReach;
    tcTouchAge:=tcSpan(tcTouched{1},tcTouched{2},tcState{5},tcState{6});
    tcTouchSigma:=@LARGEST@*Sqrt(@QSEEN@*tcHours+@VARIANCE@);
  ENDPROC

  LOCAL PROC tcLearn(num tcX,num tcY,num tcZ)
    ! A step of an extended Kalman filter: both lags, the amount, the logarithms of both time constants; mm off the cold model
    VAR num tcM:=0;
    VAR num tcOff:=0;
    VAR num tcVar:=0;
    VAR num tcG{2,5};
    VAR num tcNow{5,5};
    tcM:=(@DX@*tcX+@DY@*tcY+@DZ@*tcZ)*@PER_SQUARE@;
    IF tcX*tcX+tcY*tcY+tcZ*tcZ-tcM*tcM*@SQUARE@>@ACROSS@ OR tcM<@LEAST@ OR tcM>@MOST@ THEN
      tcTouchSaid:="Touch refused: it is not where warmth could have brought it";
      RETURN;
    ENDIF
    tcReach;
    tcNow:=tcKnown;
    FOR tcN FROM 1 TO 5 DO
      FOR tcK0 FROM 1 TO 2 DO
        tcG{tcK0,tcN}:=tcTo{tcK0,1}*tcKnown{1,tcN}+tcTo{tcK0,2}*tcKnown{2,tcN}+tcTo{tcK0,3}*tcKnown{3,tcN}
          +tcTo{tcK0,4}*tcKnown{4,tcN}+tcTo{tcK0,5}*tcKnown{5,tcN};
        tcNow{tcK0,tcN}:=tcG{tcK0,tcN};
        tcNow{tcN,tcK0}:=tcG{tcK0,tcN};
      ENDFOR
    ENDFOR
    tcNow{1,1}:=tcAcross(tcG,1,1)+@Q11@*tcHours;
    tcNow{1,2}:=tcAcross(tcG,1,2);
    tcNow{2,1}:=tcNow{1,2};
    tcNow{2,2}:=tcAcross(tcG,2,2)+@Q22@*tcHours;
    tcNow{3,3}:=tcNow{3,3}+@Q33@*tcHours;
    tcNow{4,4}:=tcNow{4,4}+@Q44@*tcHours;
    tcNow{5,5}:=tcNow{5,5}+@Q55@*tcHours;
    tcOff:=tcM-tcHas;
    IF tcOff*tcOff>@GATE@*(tcNow{@SEEN@,@SEEN@}+@R@) THEN
      IF tcTouched{4}=0 OR (tcOff-tcTouched{3})*(tcOff-tcTouched{3})>@AGREE@ THEN
        tcSeen:=[tcSeen{1},tcSeen{2},tcOff,1];
        tcTouchSaid:="Touch refused: it is over three sigma from what is expected";
        RETURN;
      ENDIF
      ! Two calls in a row that agree: the state was wrong
      tcNow{1,1}:=tcNow{1,1}+tcOff*tcOff;
      tcNow{1,2}:=tcNow{1,2}+@RHO@*tcOff*tcOff;
      tcNow{2,1}:=tcNow{1,2};
      tcNow{2,2}:=tcNow{2,2}+tcOff*tcOff;
    ELSEIF tcOff*tcOff>@PLAIN@ THEN
      ! More than a touch's own noise: not without a second one that agrees
      IF tcSeen{2}=0 OR (tcOff-tcSeen{1})*(tcOff-tcSeen{1})>2*@PLAIN@ THEN
        tcSeen:=[tcOff,1,tcSeen{3},tcSeen{4}];
        tcTouchSaid:="Touch refused: no second touch agrees with it";
        RETURN;
      ENDIF
      tcOff:=(tcOff+tcSeen{1})/2;
    ENDIF
    tcVar:=tcNow{@SEEN@,@SEEN@}+@R@;
    FOR tcN FROM 1 TO 5 DO
      tcG{1,tcN}:=tcNow{@SEEN@,tcN};
      tcG{2,tcN}:=tcG{1,tcN}/tcVar;
    ENDFOR
    FOR tcN FROM 1 TO 5 DO
      FOR tcK0 FROM 1 TO 5 DO
        tcNow{tcN,tcK0}:=tcNow{tcN,tcK0}-tcG{2,tcN}*tcG{1,tcK0};
      ENDFOR
    ENDFOR
    tcKnown:=tcNow;
    tcBy:=[[1,0,0,0,0],[0,1,0,0,0]];
    tcTau:=tcHeld(tcTau*Exp(tcHeld(tcG{2,4}*tcOff,-1,1)),@TAU_LEAST@,@TAU_MOST@);
    tcTauCool:=tcHeld(tcTauCool*Exp(tcHeld(tcG{2,5}*tcOff,-1,1)),@COOL_LEAST@,@COOL_MOST@);
    tcAmount:=tcHeld(tcAmount+tcG{2,3}*tcOff,@AMOUNT_LEAST@,@MOST@);
    tcTouched:=[tcState{5},tcState{6},0,0,1];
    tcState:=[@LAG1@,@LAG2@,tcState{5},tcState{6},tcState{5},tcState{6}];
    tcTimeSeen:="";
    tcUpdate;
    tcTouchSaid:="Touch taken";
    TPWrite "Touch taken, sigma in mm where the drift is largest: "\Num:=tcTouchSigma;
  ENDPROC

  LOCAL FUNC num tcAcross(num tcG{*,*},num tcRow,num tcCol)
    RETURN tcG{tcRow,1}*tcTo{tcCol,1}+tcG{tcRow,2}*tcTo{tcCol,2}+tcG{tcRow,3}*tcTo{tcCol,3}
      +tcG{tcRow,4}*tcTo{tcCol,4}+tcG{tcRow,5}*tcTo{tcCol,5};
  ENDFUNC

  LOCAL FUNC num tcHeld(num tcValue,num tcLeast,num tcMost0)
    IF tcValue<tcLeast RETURN tcLeast;
    IF tcValue>tcMost0 RETURN tcMost0;
    RETURN tcValue;
  ENDFUNC
