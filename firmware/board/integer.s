| Integer arithmetic that the 68000 has not and the compiler calls: operands on the stack, result in
| D0; D1, A0 and A1 are used up.

        .globl  __mulsi3, __udivsi3, __umodsi3, __divsi3, __modsi3

        .section .text.__mulsi3,"ax"
__mulsi3:
        move.w  4(%sp),%d0
        mulu.w  10(%sp),%d0
        move.w  6(%sp),%d1
        mulu.w  8(%sp),%d1
        add.w   %d1,%d0
        swap    %d0
        clr.w   %d0
        move.w  6(%sp),%d1
        mulu.w  10(%sp),%d1
        add.l   %d1,%d0
        rts

        .section .text.__udivsi3,"ax"
__udivsi3:
        move.l  4(%sp),%d0
        move.l  8(%sp),%d1
        jmp     divide

| Quotient in D0 and remainder in D1 of D0 by D1, without sign. A divisor of 16 bits takes two steps
| of the processor; a larger one leaves a quotient of 16 bits, found bit by bit.
        .section .text.divide,"ax"
        .globl  divide
divide:
        cmpi.l  #0xFFFF,%d1
        bhi.s   1f
        movea.l %d0,%a0
        clr.w   %d0
        swap    %d0
        divu.w  %d1,%d0
        movea.w %d0,%a1
        move.w  %a0,%d0
        divu.w  %d1,%d0
        move.w  %d0,%d1
        swap    %d0
        exg     %d0,%d1
        swap    %d0
        move.w  %a1,%d0
        swap    %d0
        andi.l  #0xFFFF,%d1
        rts
1:      movem.l %d2-%d3,-(%sp)
        move.l  %d1,%d2
        move.l  %d0,%d1
        clr.w   %d1
        swap    %d1
        swap    %d0
        clr.w   %d0
        moveq   #15,%d3
2:      add.l   %d0,%d0
        addx.l  %d1,%d1
        bcs.s   3f
        cmp.l   %d2,%d1
        bcs.s   4f
3:      sub.l   %d2,%d1
        addq.w  #1,%d0
4:      dbra    %d3,2b
        movem.l (%sp)+,%d2-%d3
        rts

        .section .text.__umodsi3,"ax"
__umodsi3:
        move.l  4(%sp),%d0
        move.l  8(%sp),%d1
        jsr     divide
        move.l  %d1,%d0
        rts

        .section .text.__divsi3,"ax"
__divsi3:
        move.l  8(%sp),%d1
        bpl.s   1f
        neg.l   %d1
1:      move.l  4(%sp),%d0
        bpl.s   2f
        neg.l   %d0
2:      jsr     divide
        move.b  4(%sp),%d1
        eor.b   %d1,8(%sp)
        bpl.s   3f
        neg.l   %d0
3:      rts

        .section .text.__modsi3,"ax"
__modsi3:
        move.l  8(%sp),%d1
        bpl.s   1f
        neg.l   %d1
1:      move.l  4(%sp),%d0
        bpl.s   2f
        neg.l   %d0
2:      jsr     divide
        move.l  %d1,%d0
        tst.b   4(%sp)
        bpl.s   3f
        neg.l   %d0
3:      rts
