| Copying and filling, as the compiler calls them: operands on the stack, the destination in D0 as
| the result; D1, A0 and A1 are used up. Structures lie on even addresses, so that words can be moved.

        .section .text.memcpy,"ax"
        .globl  memcpy
memcpy:
        movea.l 4(%sp),%a1
        movea.l 8(%sp),%a0
        move.l  12(%sp),%d0
        lsr.l   #2,%d0
        bra.s   2f
1:      move.l  (%a0)+,(%a1)+
2:      dbra    %d0,1b
        btst    #1,15(%sp)
        beq.s   3f
        move.w  (%a0)+,(%a1)+
3:      btst    #0,15(%sp)
        beq.s   4f
        move.b  (%a0),(%a1)
4:      move.l  4(%sp),%d0
        rts

        .section .text.memset,"ax"
        .globl  memset
memset:
        movea.l 4(%sp),%a0
        move.b  11(%sp),%d1
        move.l  12(%sp),%d0
        bra.s   2f
1:      move.b  %d1,(%a0)+
2:      dbra    %d0,1b
        move.l  4(%sp),%d0
        rts
