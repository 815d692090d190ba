| Conversions of a 32-bit two's complement integer.
|
| ffp_from_integer  D7 = the integer D7, rounded to nearest even
| ffp_to_integer    D7 = the number D7 truncated towards zero; beyond the integers the nearest one
|
| D4 and D5 are destroyed, all else stays; the condition codes are undefined.
        .global ffp_from_integer, ffp_to_integer
        .text

| D5 = sign and exponent, of an integer below 2^16.
ffp_from_integer:
        tst.l   d7
        beq.s   done
        bmi.s   from_negative
        moveq   #80,d5
magnitude:
        cmpi.l  #0xffff,d7
        bhi.s   large
        cmpi.w  #0xff,d7
        bhi.s   1f
        lsl.w   #8,d7
        subq.b  #8,d5
1:      cmpi.w  #0xfff,d7
        bhi.s   2f
        lsl.w   #4,d7
        subq.b  #4,d5
2:      tst.w   d7
        dbmi    d5,3f
        swap    d7
        move.b  d5,d7
done:
        rts
3:      add.w   d7,d7
        dbmi    d5,3b
        swap    d7
        move.b  d5,d7
        rts
from_negative:
        moveq   #80-128,d5
        neg.l   d7
        bra.s   magnitude
large:
        addi.b  #16,d5
        cmpi.l  #0xffffff,d7
        bhi.s   more_than_24_bits
        lsl.l   #8,d7
        subq.b  #8,d5
        tst.l   d7
        dbmi    d5,1f
        move.b  d5,d7
        rts
1:      add.l   d7,d7
        dbmi    d5,1b
        move.b  d5,d7
        rts
more_than_24_bits:
        tst.l   d7
        bra.s   2f
1:      add.l   d7,d7
2:      dbmi    d5,1b
        add.b   d7,d7
        bcs.s   4f
3:      move.b  d5,d7
        rts
4:      bne.s   5f
        btst    #8,d7
        beq.s   3b
5:      move.b  d5,d7
        addi.l  #0x100,d7
        bcs.s   6f
        rts
6:      addq.b  #1,d7
        bset    #31,d7
        rts

| D4 = 80 - the exponent: the shift of the mantissa's high word.
ffp_to_integer:
        move.b  d7,d5
        bmi.s   to_negative
        moveq   #80,d4
        sub.b   d5,d4
        bcs.s   high
        cmpi.b  #16,d4
        bcc.s   no_integer
        clr.w   d7
        swap    d7
        lsr.w   d4,d7
        rts
high:
        clr.b   d7
        addi.b  #16,d4
        ble.s   1f
        lsr.l   d4,d7
        rts
1:      moveq   #-1,d7
        lsr.l   #1,d7
        rts
to_negative:
        moveq   #80-128,d4
        sub.b   d5,d4
        bcs.s   high_negative
        cmpi.b  #16,d4
        bcc.s   no_integer
        clr.w   d7
        swap    d7
        lsr.w   d4,d7
        neg.l   d7
        rts
high_negative:
        clr.b   d7
        addi.b  #16,d4
        ble.s   1f
        lsr.l   d4,d7
        neg.l   d7
        rts
1:      moveq   #1,d7
        ror.l   #1,d7
        rts
no_integer:
        moveq   #0,d7
        rts
