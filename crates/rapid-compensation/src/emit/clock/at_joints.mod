  FUNC jointtarget tcAtJ(jointtarget tcP,@ROBJOINTS@)
    ! The same for joints
    tcUpdate;
    IF NOT tcOn RETURN tcP;
@JOINTS@
    RETURN tcP;
  ENDFUNC
