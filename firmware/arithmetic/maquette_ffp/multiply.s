| Multiplication: ffp_multiply, D7 = D7 * D6.
|
| D3 to D5 are destroyed, D6 and all else stays; the condition codes are undefined.
|
| With mantissas a1:a0 and b1:b0 of 16 and 8 bits, three products give the upper half of the product
| but for what a0 * b0 may carry into it. That matters where the bits to be rounded are within two
| units of a half; only then the fourth is computed.
        .global ffp_multiply
        .text

| The exponents' sum is -1 or less, or 128 or more, with D7 as it came: zero, or the largest number
| with the sign of the product. At 128 it depends on the mantissas: so of half the product.
out_of_range:
        moveq   #127,d3
        and.b   d7,d3
        moveq   #127,d4
        and.b   d6,d4
        add.w   d4,d3
        subi.w  #64+128,d3
        bcs.s   zero
        bne.s   saturate
        subq.b  #1,d7
        bsr.s   ffp_multiply
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

ffp_multiply:
        move.l  d7,d5
        beq.s   1f
        move.l  d6,d4
        beq.s   zero
        eor.b   d7,d4
        add.b   d6,d5
        subi.b  #64,d5
        eor.b   d5,d4
        bmi.s   out_of_range
        clr.b   d4
        move.l  d7,d3
        swap    d3
        mulu    d4,d3           | a1 * b0
        swap    d4
        clr.b   d7
        mulu    d7,d4           | b1 * a0
        swap    d7
        swap    d6
        mulu    d6,d7           | a1 * b1
        swap    d6
        add.l   d4,d3
        subx.w  d3,d3
        neg.w   d3
        swap    d3
        add.l   d3,d7
        bpl.s   shift
        add.b   d7,d7
        bcs.s   up
        addq.b  #2,d7
        bcs.s   doubtful
        move.b  d5,d7
1:      rts
up:
        beq.s   doubtful
next:
        move.b  d5,d7
        addi.w  #0x100,d7
        bcs.s   ripple
        rts
shift:
        add.l   d7,d7
        subq.b  #1,d5
        bvs.s   below
        bcs.s   below
        add.b   d7,d7
        bcs.s   shift_up
        addq.b  #4,d7
        bcs.s   doubtful_shift
        move.b  d5,d7
        rts
shift_up:
        bne.s   next
doubtful_shift:
        addq.b  #1,d5
doubtful:
        bra.s   exact

| A carry out of the low word of the mantissa. The product of the largest mantissas is far from a
| power of two, so the exponent has room for one out of the high word.
ripple:
        swap    d7
        addq.w  #1,d7
        bcs.s   1f
        swap    d7
        rts
1:      move.w  #0x8000,d7
        swap    d7
        addq.b  #1,d7
        rts

| The result is below the smallest number unless rounding carries it there: so of twice the product.
below:
        move.l  d5,d7
        addi.b  #65,d7
        sub.b   d6,d7
        addq.b  #1,d7
        bsr.w   ffp_multiply
        subq.b  #1,d7
        bvs.s   1f
        bcs.s   1f
        rts
1:      moveq   #0,d7
        rts

| All of the product of D5's and D6's mantissas, D5 with the low byte of the result before a shift.
exact:
        move.l  d6,d4
        clr.b   d4
        move.w  d4,d3
        move.l  d5,d7
        clr.b   d7
        mulu    d7,d3
        swap    d3              | a0 * b0
        swap    d7
        mulu    d7,d4
        add.l   d4,d3           | a1 * b0
        move.l  d6,d4
        swap    d4
        swap    d7
        mulu    d7,d4
        add.l   d4,d3           | b1 * a0
        move.w  d3,d4
        subx.w  d3,d3
        neg.w   d3
        swap    d3
        swap    d7
        swap    d6
        mulu    d6,d7
        swap    d6
        add.l   d3,d7           | a1 * b1
        bmi.s   1f
        add.l   d7,d7
        subq.b  #1,d5
1:      tst.w   d4
        beq.s   2f
        ori.b   #1,d7
2:      add.b   d7,d7
        bcc.s   3f
        bne.w   next
        btst    #8,d7
        bne.w   next
3:      move.b  d5,d7
        rts
