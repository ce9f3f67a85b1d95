  LOCAL FUNC bool tcStands(robtarget tcP)
    ! Whether a target means the joints that were reckoned with, by its pose, tool and work object, and nothing shifts it
    VAR pose tcOn0;
    IF C_PROGDISP.pdisp.trans.x<>0 OR C_PROGDISP.pdisp.trans.y<>0 OR C_PROGDISP.pdisp.trans.z<>0
      OR C_PROGDISP.pdisp.rot.q2<>0 OR C_PROGDISP.pdisp.rot.q3<>0 OR C_PROGDISP.pdisp.rot.q4<>0
      RETURN FALSE;
    IF tcP.robconf.cf1<>@CF1@ OR tcP.robconf.cf4<>@CF4@ OR tcP.robconf.cf6<>@CF6@ OR tcP.robconf.cfx<>@CFX@
      RETURN FALSE;
    tcOn0:=PoseMult(@ON@.uframe,@ON@.oframe);
    RETURN tcNear(tcP.trans,tcP.rot,tcTouchAt) AND tcNear(@HELD@.tframe.trans,@HELD@.tframe.rot,tcTouchTool)
      AND tcNear(tcOn0.trans,tcOn0.rot,tcTouchOn);
  ENDFUNC

  LOCAL FUNC bool tcNear(pos tcPlace,orient tcTurn,pose tcWas)
    ! Within 5 mm and some 0.7 deg: the joints that were reckoned with are good for that
    RETURN Abs(tcPlace.x-tcWas.trans.x)<5 AND Abs(tcPlace.y-tcWas.trans.y)<5 AND Abs(tcPlace.z-tcWas.trans.z)<5
      AND Abs(tcTurn.q1*tcWas.rot.q1+tcTurn.q2*tcWas.rot.q2+tcTurn.q3*tcWas.rot.q3+tcTurn.q4*tcWas.rot.q4)>0.99998;
  ENDFUNC
