| Square root: ffp_square_root, D7 = the root of D7; of a negative number zero.
|
| D3 to D5 are destroyed, all else stays; the condition codes are undefined.
|
| With x the mantissa at an even exponent, shifted right by two: a line gives a first root of x to
| 1 in 100, a step of Newton's 15 bits s of it, a second, of two divisions, 31 bits. With s and the
| first quotient q1 added instead of averaged they are a root of 4x, too large by less than four
| units; only where the bits to be rounded are a half or little more is it looked at further. A root
| of a mantissa of 24 bits is never a tie.
        .global ffp_square_root
        .text

special:
        bmi.s   1f
        tst.l   d7
        bne.s   positive
1:      moveq   #0,d7
        rts

ffp_square_root:
        move.b  d7,d5
        ble.s   special
positive:
        clr.b   d7
        addi.b  #65,d5
        lsr.b   #1,d5
        bcc.s   odd
        lsr.l   #2,d7
        move.l  d7,d4
        swap    d4
        move.w  d4,d3
        lsr.w   #3,d3
        add.w   d3,d4
        lsr.w   #1,d3
        add.w   d3,d4
        addi.w  #13582,d4       | 1.1875 x + 0.4145
        move.l  d7,d3
        divu    d4,d3
        add.w   d3,d4
        roxr.w  #1,d4
        divu    d4,d7
        move.w  d7,d3
        clr.w   d7
        divu    d4,d7
        add.w   d4,d3
        swap    d3
        move.w  d7,d3
        add.b   d3,d3
        bcs.s   up
        move.b  d5,d3
        move.l  d3,d7
        rts
odd:
        lsr.l   #3,d7
        move.l  d7,d4
        swap    d4
        move.w  d4,d3
        lsr.w   #1,d3
        add.w   d3,d4
        lsr.w   #2,d3
        add.w   d3,d4
        addi.w  #9895,d4        | 1.625 x + 0.302
        move.l  d7,d3
        divu    d4,d3
        add.w   d3,d4
        roxr.w  #1,d4
        divu    d4,d7
        move.w  d7,d3
        clr.w   d7
        divu    d4,d7
        add.w   d4,d3
        swap    d3
        move.w  d7,d3
        add.b   d3,d3
        bcs.s   up
        move.b  d5,d3
        move.l  d3,d7
        rts
up:
        subq.b  #8,d3
        bcs.s   doubtful
next:
        move.b  d5,d3
        addi.w  #0x100,d3
        bcs.s   ripple
        move.l  d3,d7
        rts

| A carry out of the low word of the mantissa; out of the high word there is none.
ripple:
        addi.l  #0x10000,d3
        move.l  d3,d7
        rts

| D3 = the root's words h and l, the latter in D7 too, below the second division's remainder. The
| first had the remainder r = (s * l + that) / 2^16, and 4x - h^2 = 4r - (s - q1)^2. With the bits to
| be rounded just a half in l the true root is not less where 2^15 of this exceed h * l + l^2 / 2^17.
doubtful:
        swap    d5
        move.w  d7,d5
        swap    d7
        move.w  d7,d3
        move.w  d5,d7
        mulu    d4,d7
        add.w   d3,d7
        bcc.s   1f
        addi.l  #0x10000,d7
1:      swap    d7
        swap    d3
        add.w   d4,d4
        sub.w   d3,d4
        muls    d4,d4
        lsl.l   #2,d7
        sub.l   d4,d7
        swap    d7
        ror.l   #1,d7
        move.b  #0x80,d5
        move.w  d5,d4
        mulu    d4,d4
        swap    d4
        lsr.w   #1,d4
        swap    d4
        move.w  d3,d4
        swap    d4
        mulu    d5,d3
        sub.l   d3,d7
        bcs.s   3f
        swap    d7
        tst.w   d7
        bne.s   2f
        swap    d7
        cmp.w   d4,d7
        bls.s   3f
2:      move.w  d5,d4
        move.l  d4,d3
        swap    d5
        bra.s   next
3:      move.w  d5,d4
        swap    d5
        move.b  d5,d4
        move.l  d4,d7
        rts
