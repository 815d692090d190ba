| Comparison: ffp_compare sets the condition codes for the signed conditions (EQ NE LT LE GT GE) on
| D7 - D6; then BLT branches where D7 < D6.
|
| D4 and D5 are destroyed, all else stays.
        .global ffp_compare
        .text

| Low bytes compare as signed bytes unless both are negative, mantissas as signed words of 32 bits
| where both are normalised.
ffp_compare:
        tst.b   d6
        bmi.s   negative
        cmp.b   d6,d7
        bne.s   1f
        tst.b   d6
        beq.s   perhaps_zero
        cmp.l   d6,d7
1:      rts
negative:
        tst.b   d7
        bpl.s   2f
        cmp.b   d7,d6
        bne.s   1b
        cmp.l   d7,d6
        rts
2:      cmp.b   d6,d7
        rts
perhaps_zero:
        move.l  d6,d4
        lsr.l   #1,d4
        move.l  d7,d5
        lsr.l   #1,d5
        cmp.l   d4,d5
        rts
