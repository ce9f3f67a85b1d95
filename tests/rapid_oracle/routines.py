"""RAPID text of the routines that every random program has; the braces are filled in by the generator."""

HELPERS = """
  FUNC num Fold(num x)
    RETURN x-{width}*Trunc(x/{width});
  ENDFUNC

  FUNC num Turn(num x\\num by\\switch twice|switch thrice)
    VAR num r;
    r:=x+{c1};
    IF Present(by) r:=r*by-{c2};
    IF Present(twice) THEN
      r:=Fold(r*2+{i1});
    ELSEIF Present(thrice) THEN
      r:=Fold(r*3-{i2});
    ENDIF
    RETURN Fold(r);
  ENDFUNC

  FUNC num Through(num x\\num by\\switch twice)
    RETURN Turn(x-{c3}\\by?by\\twice?twice)+1;
  ENDFUNC

  FUNC num Deep(num n)
    IF n<=0 RETURN {c4};
    RETURN Fold(n*Deep(n-1)+{c2});
  ENDFUNC

  FUNC num Safe(num x,num y)
    RETURN x/y;
  ERROR
    IF ERRNO=ERR_DIVZERO THEN
      y:={i3};
      RETRY;
    ENDIF
    RETURN {c1};
  ENDFUNC

  FUNC num Total(num list{{*}})
    VAR num sum:={c5};
    FOR i FROM 1 TO Dim(list,1) DO
      sum:=sum+list{{i}};
      list{{i}}:=0;
    ENDFOR
    RETURN Fold(sum);
  ENDFUNC

  PROC Shift(INOUT num list{{*}},VAR num n)
    VAR num first;
    first:=list{{1}};
    FOR i FROM 1 TO Dim(list,1)-1 DO
      list{{i}}:=list{{i+1}};
    ENDFOR
    list{{Dim(list,1)}}:=Fold(first+n);
    n:=Fold(n*{c6}+{i1});
  ENDPROC

  PROC Swap(INOUT num x,INOUT num y)
    VAR num a;
    a:=x;
    x:=y;
    y:=Fold(a-{c3});
  ENDPROC

  PROC Mark(PERS num store,num by)
    store:=Fold(store+by*{c4});
    by:=0;
  ENDPROC

  PROC Risky(INOUT num r,num q)
    VAR num z;
    r:=Fold(r+{c6});
    IF q>{i1} RAISE {e1};
    r:=Fold(r+q/z);
    IF r>{i2} RAISE {e2};
    r:=r-{c1};
  ERROR
    TEST ERRNO
    CASE {e1},{e3}:
      r:=r+{i3};
      TRYNEXT;
    CASE ERR_DIVZERO:
      z:={i2};
      RETRY;
    DEFAULT:
      RAISE;
    ENDTEST
  ENDPROC

  PROC Walk(num n,INOUT num found{{*}})
    VAR num none;
    FOR i FROM 1 TO Dim(found,1) DO
      FOR j FROM i TO 1 DO
        IF j=2 AND i>n MOD 3+1 RETURN;
        found{{i}}:=Fold(found{{i}}*{c5}-j);
        IF i=2 THEN
          found{{j}}:=found{{j}}/none;
          found{{j}}:=found{{j}}+{i3};
        ENDIF
        WHILE found{{i}}>{i1} AND j<3 DO
          found{{i}}:=found{{i}}-{i2};
        ENDWHILE
      ENDFOR
    ENDFOR
  ERROR
    found{{1}}:=Fold(found{{1}}+{c6});
    TRYNEXT;
  ENDPROC

  FUNC num Cells(num cells{{*,*}},num by)
    VAR num sum;
    FOR row FROM Dim(cells,1) TO 1 DO
      FOR column FROM 1 TO Dim(cells,2) STEP 2 DO
        sum:=sum*{c3}+cells{{row,column}}*by;
      ENDFOR
    ENDFOR
    RETURN Fold(sum);
  ENDFUNC

  FUNC pos Bent(pos bend,num x\switch back)
    IF Present(back) bend:=-bend;
    bend.y:=Fold(bend.y*{c1}-x);
    RETURN bend;
  ENDFUNC

  PROC Guarded(INOUT num r,VAR num tries)
    VAR num at;
    Risky r,{q};
    r:=r+{c2};
  ERROR ({e2})
    Incr tries;
    at:=at+1;
    IF at<=2 THEN
      r:=r-{i2};
      RETRY;
    ENDIF
    TRYNEXT;
  ENDPROC
"""
TURNS = """
  PROC late1()
    a:=Fold(a+{c1});
  ENDPROC

  PROC late2()
    b:=Fold(b*{c2}-a);
    IF b<0 RETURN;
    b:=b+{i1};
  ENDPROC

  PROC late3()
    Swap a,c;
    Decr c;
  ENDPROC
"""
LIBRARY = """MODULE Library
  LOCAL VAR num hidden:={c1};
  LOCAL CONST num{dims} steps{{3}}:=[{i1},{c2},-{i2}];

  LOCAL FUNC num Twist(num x)
    hidden:=Fold(hidden+{c3});
    RETURN x-hidden;
  ENDFUNC

  FUNC num Foreign(num x)
    VAR num r;
    FOR i FROM 3 TO 1 DO
      r:=r*{c4}+Twist(x)*steps{{i}};
    ENDFOR
    RETURN Fold(r);
  ENDFUNC
ENDMODULE
"""
