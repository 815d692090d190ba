| Addition and subtraction.
|
| ffp_add       D7 = D7 + D6
| ffp_subtract  D7 = D7 - D6
|
| D3 to D5 are destroyed, D6 and all else stays; the condition codes are undefined.
        .include "magnitudes.inc"
        .include "sum.inc"
        .include "difference.inc"
        .global ffp_add, ffp_subtract
        .text

        difference_far add, 0x80, 0
        far_entries 0x80, 0, 25, add_difference_far, add_difference_far_take
        cancellation add
        difference_near add, 0x80, 0
ffp_add:
        move.b  d6,d5
        eor.b   d7,d5
        bmi.s   add_difference
        sum_near add, 0, 0
        far_entries 0, 0, 24, add_sum_far, add_sum_far_add
        sum_round add, 0
        sum_far add, 0, 0

| A carry out of the low word of the mantissa in D7.
ripple:
        swap    d7
        addq.w  #1,d7
        bcs.s   1f
        swap    d7
        rts
1:      move.w  #0x8000,d7
        swap    d7
        addq.b  #1,d7
        bvs.s   saturate_plus
        bcs.s   saturate_minus
        rts

| The largest magnitude with the sign opposite to that of D4, an exponent that has run over.
saturate:
        tst.b   d4
        bmi.s   saturate_plus
saturate_minus:
        moveq   #-1,d7
        rts
saturate_plus:
        moveq   #-1,d7
        bclr    #7,d7
        rts

| D7 = the mantissa D7, of top bit zero and not zero itself, normalised, with the low byte D4 less
| what the shift takes; zero where the exponent does not reach.
normalise:
        moveq   #127,d5
        and.b   d4,d5
        subq.w  #1,d5
        bcs.s   2f
1:      add.l   d7,d7
        dbmi    d5,1b
        bpl.s   2f
        andi.b  #0x80,d4
        or.b    d5,d4
        move.b  d4,d7
        rts
2:      moveq   #0,d7
        rts

        difference_far subtract, 0, 1
        far_entries 0, 1, 25, subtract_difference_far, subtract_difference_far_take
        cancellation subtract
        difference_near subtract, 0, 1
ffp_subtract:
        move.b  d6,d5
        eor.b   d7,d5
        bpl.s   subtract_difference
        sum_near subtract, 0x80, 1
        far_entries 0x80, 1, 24, subtract_sum_far, subtract_sum_far_add
        sum_round subtract, 1
        sum_far subtract, 0x80, 1
