| Sign of a number in D7, which alone changes.
|
| ffp_negate    D7 = -D7; the condition codes are undefined
| ffp_absolute  D7 = |D7|; the condition codes are undefined
| ffp_test      sets N for a negative number, Z for zero, and clears V and C
        .global ffp_negate, ffp_absolute, ffp_test
        .text

ffp_negate:
        tst.l   d7
        beq.s   1f
        eori.b  #0x80,d7
1:      rts

ffp_absolute:
        andi.b  #0x7f,d7
        rts

| Only of a low byte that is zero the mantissa is looked at, whose top bit is no sign.
ffp_test:
        tst.b   d7
        beq.s   1f
        rts
1:      tst.l   d7
        beq.s   2f
        move.w  #0,ccr
2:      rts
