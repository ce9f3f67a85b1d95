  FUNC robtarget tcAt(robtarget tcP,@POSES@)
    ! The target as it stands, shifted and turned by as much of its correction as has come
    tcUpdate;
    RETURN tcAtSame(tcP,@CORRECTIONS@);
  ENDFUNC

  FUNC robtarget tcAtSame(robtarget tcP,@POSES@)
    ! The same at the moment of the motion's other point
    IF NOT tcOn RETURN tcP;
@TARGET@
    RETURN tcP;
  ENDFUNC
