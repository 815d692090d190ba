| Division: ffp_divide, D7 = D7 / D6; of zero by zero zero, else by zero the largest number.
|
| D3 to D5 are destroyed, D6 and all else stays; the condition codes are undefined.
|
| With the divisor b1:b0 of 16 and 8 bits, D7's mantissa is divided by b1, the remainder corrected by
| b0, and divided by b1 again. That quotient of 32 bits is too large by less than two units, which
| matters where the bits to be rounded are a half or little more: only then the remainder is looked
| at. A quotient of two mantissas of 24 bits is never a tie.
        .global ffp_divide
        .text

| The exponents' difference is out of range, with D7 as it came: zero, or the largest number with the
| sign of the quotient. Where it is just too large it depends on the mantissas: so of half the
| quotient.
out_of_range:
        moveq   #127,d3
        and.b   d7,d3
        moveq   #127,d4
        and.b   d6,d4
        sub.w   d4,d3
        bmi.s   zero
        subi.w  #63,d3
        bne.s   saturate
        subq.b  #1,d7
        bsr.s   ffp_divide
        addq.b  #1,d7
        bvs.s   saturate_plus
        bcs.s   saturate_minus
        rts
saturate:
        eor.b   d6,d7
        bpl.s   saturate_plus
saturate_minus:
        moveq   #-1,d7
        rts
saturate_plus:
        moveq   #-1,d7
        bclr    #7,d7
        rts
zero:
        moveq   #0,d7
        rts

ffp_divide:
        move.l  d7,d5
        beq.s   1f
        move.l  d6,d3
        beq.s   saturate
        move.b  d6,d4
        eor.b   d7,d4
        sub.b   d6,d5
        addi.b  #65,d5
        eor.b   d5,d4
        bmi.s   out_of_range
        clr.b   d7
        lsr.l   #1,d7
        swap    d3
        divu    d3,d7
        swap    d5
        move.w  d7,d5
        move.w  d6,d4
        clr.b   d4
        mulu    d7,d4
        clr.w   d7
        sub.l   d4,d7
        bcc.s   remainder
        subq.w  #1,d5
        move.l  d6,d4
        clr.b   d4
        add.l   d4,d7
        bcs.s   remainder
        subq.w  #1,d5
        add.l   d4,d7
remainder:
        divu    d3,d7
        bvs.s   all_ones
quotient:
        swap    d5
        bpl.s   shift
        add.b   d7,d7
        bcs.s   up
        move.b  d5,d7
        move.w  d7,d5
        move.l  d5,d7
1:      rts
up:
        subq.b  #4,d7
        bcs.s   doubtful
next:
        move.b  d5,d7
        move.w  d7,d5
        addi.w  #0x100,d5
        bcs.s   ripple
        move.l  d5,d7
        rts
shift:
        move.b  d5,d4
        move.w  d7,d5
        add.l   d5,d5
        subq.b  #1,d4
        bvs.s   zero
        bcs.s   zero
        add.b   d5,d5
        bcs.s   shift_up
        move.b  d4,d5
        move.l  d5,d7
        rts
shift_up:
        subq.b  #8,d5
        bcs.s   doubtful_shift
shift_next:
        move.b  d4,d5
        addi.w  #0x100,d5
        bcs.s   ripple
        move.l  d5,d7
        rts

| A carry out of the low word of the mantissa; out of the high word there is none.
ripple:
        addi.l  #0x10000,d5
        move.l  d5,d7
        rts

| The remainder's high word is the divisor's: the quotient is within two units of the next.
all_ones:
        moveq   #-1,d7
        bra.s   quotient

| D7 = the second division's remainder and quotient q, whose bit 0 is what it has over h, the quotient
| with the bits to be rounded just a half. The true one is not less than h where that bit times b1,
| with the remainder, in the place of the high word, is not less than h * b0.
doubtful:
        addq.b  #4,d7
        lsr.b   #1,d7
        bset    #7,d7
        move.b  d5,d4
        move.w  d7,d5
doubtful_shift:
        move.b  d4,d5
        moveq   #0,d4
        bclr    #0,d7
        beq.s   1f
        move.w  d3,d4
        swap    d4
1:      move.w  d6,d3
        clr.b   d3
        mulu    d7,d3
        clr.w   d7
        add.l   d4,d7
        bcs.s   2f
        cmp.l   d3,d7
        bcs.s   3f
2:      addi.w  #0x100,d5
        bcs.s   ripple
3:      move.l  d5,d7
        rts
