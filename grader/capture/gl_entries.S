// One exported entry for every GL and GLX function. An entry jumps through its slot; a slot starts at
// the entry's lazy stub, which asks gg_resolveSlot for the target, with all arguments kept.
// A slot whose function exists is overwritten by then, so later calls cost one indirect jump.
// Entries are 16 bytes apart (gl_hooks.cpp computes their addresses).

#if defined(__x86_64__)

    .text
    .balign 16
    .globl gg_glEntries
    .hidden gg_glEntries
gg_glEntries:
    .macro gg_entry index, name
    .globl \name
    .type \name, @function
    .balign 16
\name:
    endbr64
    jmp *gg_glSlots + 8 * \index(%rip)
    .size \name, . - \name
    .endm
#define GG_GL_NAME(index, name) gg_entry index, name
#include "gl_names.inc"
#undef GG_GL_NAME

    .balign 16
gg_glLazyStubs:
    .macro gg_lazy index
    .balign 16
    movl $\index, %r11d
    jmp gg_glResolve
    .endm
#define GG_GL_NAME(index, name) gg_lazy index
#include "gl_names.inc"
#undef GG_GL_NAME

    .balign 16
gg_glResolve:
    .cfi_startproc
    pushq %rdi
    pushq %rsi
    pushq %rdx
    pushq %rcx
    pushq %r8
    pushq %r9
    pushq %rax
    .cfi_adjust_cfa_offset 56
    subq $128, %rsp
    .cfi_adjust_cfa_offset 128
    movdqa %xmm0, (%rsp)
    movdqa %xmm1, 16(%rsp)
    movdqa %xmm2, 32(%rsp)
    movdqa %xmm3, 48(%rsp)
    movdqa %xmm4, 64(%rsp)
    movdqa %xmm5, 80(%rsp)
    movdqa %xmm6, 96(%rsp)
    movdqa %xmm7, 112(%rsp)
    movl %r11d, %edi
    call gg_resolveSlot
    movq %rax, %r11
    movdqa (%rsp), %xmm0
    movdqa 16(%rsp), %xmm1
    movdqa 32(%rsp), %xmm2
    movdqa 48(%rsp), %xmm3
    movdqa 64(%rsp), %xmm4
    movdqa 80(%rsp), %xmm5
    movdqa 96(%rsp), %xmm6
    movdqa 112(%rsp), %xmm7
    addq $128, %rsp
    .cfi_adjust_cfa_offset -128
    popq %rax
    popq %r9
    popq %r8
    popq %rcx
    popq %rdx
    popq %rsi
    popq %rdi
    .cfi_adjust_cfa_offset -56
    jmp *%r11
    .cfi_endproc

    .macro gg_slot index
    .quad gg_glLazyStubs + 16 * \index
    .endm

#elif defined(__aarch64__)

    .text
    .balign 16
    .globl gg_glEntries
    .hidden gg_glEntries
gg_glEntries:
    .macro gg_entry index, name
    .globl \name
    .type \name, %function
    .balign 16
\name:
    adrp x16, gg_glSlots + 8 * \index
    ldr x16, [x16, #:lo12:gg_glSlots + 8 * \index]
    br x16
    .size \name, . - \name
    .endm
#define GG_GL_NAME(index, name) gg_entry index, name
#include "gl_names.inc"
#undef GG_GL_NAME

    .balign 16
gg_glLazyStubs:
    .macro gg_lazy index
    .balign 16
    mov w17, #\index
    b gg_glResolve
    .endm
#define GG_GL_NAME(index, name) gg_lazy index
#include "gl_names.inc"
#undef GG_GL_NAME

    .balign 16
gg_glResolve:
    .cfi_startproc
    stp x29, x30, [sp, #-224]!
    .cfi_def_cfa_offset 224
    .cfi_offset x29, -224
    .cfi_offset x30, -216
    stp x0, x1, [sp, #16]
    stp x2, x3, [sp, #32]
    stp x4, x5, [sp, #48]
    stp x6, x7, [sp, #64]
    str x8, [sp, #80]
    stp q0, q1, [sp, #96]
    stp q2, q3, [sp, #128]
    stp q4, q5, [sp, #160]
    stp q6, q7, [sp, #192]
    mov w0, w17
    bl gg_resolveSlot
    mov x16, x0
    ldp x0, x1, [sp, #16]
    ldp x2, x3, [sp, #32]
    ldp x4, x5, [sp, #48]
    ldp x6, x7, [sp, #64]
    ldr x8, [sp, #80]
    ldp q0, q1, [sp, #96]
    ldp q2, q3, [sp, #128]
    ldp q4, q5, [sp, #160]
    ldp q6, q7, [sp, #192]
    ldp x29, x30, [sp], #224
    br x16
    .cfi_endproc

    .macro gg_slot index
    .quad gg_glLazyStubs + 16 * \index
    .endm

#else
#error "the capture library has entries for x86-64 and aarch64 only"
#endif

    .data
    .balign 8
    .globl gg_glSlots
    .hidden gg_glSlots
gg_glSlots:
#define GG_GL_NAME(index, name) gg_slot index
#include "gl_names.inc"
#undef GG_GL_NAME

    .section .note.GNU-stack, "", %progbits
