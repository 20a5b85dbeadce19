	.file	"<string>"
	.section	.ltext,"axl",@progbits
	.globl	_ZN15granular_fronts5chain6strain5stageB2v3B68c8tJTIeFIjxB2IKSgI4CrvQClYb5wBbdC9Xqyfl5JUWJySXqtZrAkCyC6NAEAA_3d_3dE53Law_28int64_2c_20float64_2c_20float64_2c_20float64_2923Size_28int64_20x_202_29317State_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_298UniTupleIdLi9EE8UniTupleIdLi9EEddx
	.p2align	4
	.type	_ZN15granular_fronts5chain6strain5stageB2v3B68c8tJTIeFIjxB2IKSgI4CrvQClYb5wBbdC9Xqyfl5JUWJySXqtZrAkCyC6NAEAA_3d_3dE53Law_28int64_2c_20float64_2c_20float64_2c_20float64_2923Size_28int64_20x_202_29317State_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_298UniTupleIdLi9EE8UniTupleIdLi9EEddx,@function
_ZN15granular_fronts5chain6strain5stageB2v3B68c8tJTIeFIjxB2IKSgI4CrvQClYb5wBbdC9Xqyfl5JUWJySXqtZrAkCyC6NAEAA_3d_3dE53Law_28int64_2c_20float64_2c_20float64_2c_20float64_2923Size_28int64_20x_202_29317State_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_298UniTupleIdLi9EE8UniTupleIdLi9EEddx:
	.cfi_startproc
	pushq	%rbp
	.cfi_def_cfa_offset 16
	pushq	%r15
	.cfi_def_cfa_offset 24
	pushq	%r14
	.cfi_def_cfa_offset 32
	pushq	%r13
	.cfi_def_cfa_offset 40
	pushq	%r12
	.cfi_def_cfa_offset 48
	pushq	%rbx
	.cfi_def_cfa_offset 56
	subq	$2408, %rsp
	.cfi_def_cfa_offset 2464
	.cfi_offset %rbx, -56
	.cfi_offset %r12, -48
	.cfi_offset %r13, -40
	.cfi_offset %r14, -32
	.cfi_offset %r15, -24
	.cfi_offset %rbp, -16
	movq	2680(%rsp), %r13
	movq	2624(%rsp), %rbp
	movq	2568(%rsp), %rbx
	movq	2512(%rsp), %r12
	movabsq	$NRT_incref, %r15
	movq	%rdi, 504(%rsp)
	movq	%r9, %rdi
	vmovapd	%xmm7, 16(%rsp)
	vmovapd	%xmm6, 96(%rsp)
	vmovapd	%xmm5, 80(%rsp)
	vmovapd	%xmm4, 64(%rsp)
	vmovapd	%xmm3, 48(%rsp)
	movq	%r8, %r14
	movq	%rcx, 352(%rsp)
	vmovsd	%xmm2, 8(%rsp)
	vmovsd	%xmm1, 32(%rsp)
	vmovsd	%xmm0, (%rsp)
	movq	%rdx, 360(%rsp)
	movq	%rsi, 328(%rsp)
	movq	%r9, 336(%rsp)
	callq	*%r15
	movq	%r12, %rdi
	callq	*%r15
	movq	%rbx, %rdi
	callq	*%r15
	movq	%rbp, %rdi
	callq	*%r15
	movq	%r13, %rdi
	callq	*%r15
	movq	2736(%rsp), %rdi
	callq	*%r15
	movq	2792(%rsp), %rdi
	callq	*%r15
	movq	2864(%rsp), %rdi
	callq	*%r15
	movq	360(%rsp), %rbx
	movq	%r13, %rdi
	callq	*%r15
	movq	2736(%rsp), %rdi
	callq	*%r15
	vmovsd	3048(%rsp), %xmm13
	movq	3056(%rsp), %rcx
	movq	%r14, 344(%rsp)
	vmulsd	8(%rsp), %xmm13, %xmm1
	cmpq	%rcx, %r14
	cmovlq	%r14, %rcx
	testq	%rbx, %rbx
	je	.LBB0_11
	cmpq	$1, %rbx
	jne	.LBB0_33
	vmovapd	16(%rsp), %xmm3
	vmovapd	96(%rsp), %xmm4
	vmovapd	80(%rsp), %xmm5
	vmovapd	64(%rsp), %xmm6
	vmovapd	48(%rsp), %xmm7
	vmovsd	2952(%rsp), %xmm8
	vmovsd	2944(%rsp), %xmm9
	vmovsd	2936(%rsp), %xmm10
	vmovsd	2960(%rsp), %xmm11
	movq	2544(%rsp), %r8
	testq	%rcx, %rcx
	jle	.LBB0_3
	vmulsd	%xmm13, %xmm13, %xmm0
	vmulsd	3040(%rsp), %xmm13, %xmm12
	vmulsd	2976(%rsp), %xmm0, %xmm13
	vmulsd	2984(%rsp), %xmm0, %xmm14
	vmulsd	2968(%rsp), %xmm0, %xmm2
	movq	%rcx, %rax
	movq	2840(%rsp), %rcx
	movl	$1, %r12d
	movq	%rax, %rdi
	leaq	(,%rcx,8), %r15
	movq	%rcx, %r9
	shlq	$4, %r9
	imulq	$56, %rcx, %rsi
	movq	%rcx, %r11
	movq	%rcx, %rbx
	shlq	$6, %rbx
	shlq	$5, %r11
	leaq	(%r9,%r9,2), %rbp
	movq	%rbx, 448(%rsp)
	leaq	(%r15,%r15,2), %r10
	leaq	(%r15,%r15,4), %r13
	movq	%rsi, 464(%rsp)
	vfmadd213sd	%xmm13, %xmm1, %xmm6
	vmulsd	2992(%rsp), %xmm0, %xmm13
	vfmadd213sd	%xmm14, %xmm1, %xmm5
	vmulsd	3000(%rsp), %xmm0, %xmm14
	vfmadd213sd	%xmm2, %xmm1, %xmm7
	vmovapd	%xmm12, 256(%rsp)
	vmovapd	%xmm5, 80(%rsp)
	vmovapd	%xmm6, 64(%rsp)
	vmovapd	%xmm7, 48(%rsp)
	vfmadd213sd	%xmm13, %xmm1, %xmm4
	vmulsd	3008(%rsp), %xmm0, %xmm13
	vfmadd213sd	%xmm14, %xmm1, %xmm3
	vmulsd	3016(%rsp), %xmm0, %xmm14
	vmovapd	%xmm3, 16(%rsp)
	vmovapd	%xmm4, 96(%rsp)
	vfmadd213sd	%xmm13, %xmm1, %xmm10
	vmulsd	3024(%rsp), %xmm0, %xmm13
	vmulsd	3032(%rsp), %xmm0, %xmm0
	vfmadd213sd	%xmm14, %xmm1, %xmm9
	vmovapd	%xmm9, 304(%rsp)
	vmovapd	%xmm10, 288(%rsp)
	vfmadd213sd	%xmm13, %xmm1, %xmm8
	vfmadd213sd	%xmm0, %xmm1, %xmm11
	vmovapd	%xmm8, 32(%rsp)
	vmovapd	%xmm11, 272(%rsp)
	cmpq	$16, %rax
	jb	.LBB0_28
	movq	2712(%rsp), %rdx
	movq	%rdx, %rax
	subq	2488(%rsp), %rax
	movq	%rdx, %rcx
	cmpq	$64, %rax
	setb	%al
	subq	%r8, %rcx
	cmpq	$64, %rcx
	setb	%cl
	orb	%al, %cl
	movq	%rdx, %rax
	subq	2824(%rsp), %rax
	movq	%rax, %rdx
	subq	%rbx, %rdx
	cmpq	$64, %rdx
	setb	%dl
	orb	%cl, %dl
	movq	%rax, %rcx
	subq	%rsi, %rcx
	movq	%rax, %rsi
	cmpq	$64, %rcx
	setb	%cl
	orb	%dl, %cl
	movq	%rax, %rdx
	subq	%rbp, %rdx
	cmpq	$64, %rdx
	setb	%dl
	subq	%r13, %rsi
	cmpq	$64, %rsi
	setb	%sil
	orb	%dl, %sil
	movq	%rax, %rdx
	orb	%cl, %sil
	movq	%rax, %rcx
	subq	%r11, %rcx
	cmpq	$64, %rcx
	setb	%cl
	subq	%r10, %rdx
	cmpq	$64, %rdx
	setb	%dl
	orb	%cl, %dl
	movq	%rax, %rcx
	subq	%r9, %rcx
	cmpq	$64, %rcx
	setb	%cl
	orb	%dl, %cl
	movq	%rax, %rdx
	subq	%r15, %rdx
	orb	%sil, %cl
	cmpq	$64, %rdx
	setb	%dl
	cmpq	$64, %rax
	setb	%al
	orb	%dl, %al
	orb	%cl, %al
	testb	$1, %al
	jne	.LBB0_28
	vbroadcastsd	%xmm7, %zmm0
	movq	%r13, 368(%rsp)
	movabsq	$9223372036854775800, %r13
	vbroadcastsd	%xmm6, %zmm2
	movq	%r15, %rbx
	movq	2488(%rsp), %r15
	vbroadcastsd	%xmm12, %zmm1
	movabsq	$pow, %r14
	movq	%rbp, 152(%rsp)
	movq	%r11, 400(%rsp)
	movq	%r10, 416(%rsp)
	movq	%r9, 432(%rsp)
	xorl	%ebp, %ebp
	movq	%rdi, 8(%rsp)
	andq	%rdi, %r13
	vmovupd	%zmm0, 992(%rsp)
	vbroadcastsd	%xmm5, %zmm0
	leaq	1(%r13), %rax
	vmovupd	%zmm2, 1120(%rsp)
	vbroadcastsd	%xmm4, %zmm2
	vmovupd	%zmm1, 1056(%rsp)
	movq	%rax, 384(%rsp)
	movq	2824(%rsp), %rax
	vmovupd	%zmm0, 704(%rsp)
	vbroadcastsd	%xmm3, %zmm0
	vmovupd	%zmm2, 640(%rsp)
	vbroadcastsd	%xmm10, %zmm2
	vmovupd	%zmm0, 576(%rsp)
	vbroadcastsd	%xmm9, %zmm0
	vmovupd	%zmm2, 512(%rsp)
	vbroadcastsd	%xmm8, %zmm2
	vmovupd	%zmm0, 864(%rsp)
	vbroadcastsd	%xmm11, %zmm0
	leaq	8(%rax), %r12
	vmovupd	%zmm2, 800(%rsp)
	vmovupd	%zmm0, 928(%rsp)
	.p2align	4
.LBB0_26:
	movq	2544(%rsp), %rax
	vmovupd	1056(%rsp), %zmm1
	vmovupd	8(%rax,%rbp,8), %zmm0
	leaq	(%r12,%rbp,8), %rax
	vfmadd213pd	8(%r15,%rbp,8), %zmm1, %zmm0
	vmovupd	992(%rsp), %zmm1
	vfmadd231pd	(%r12,%rbp,8), %zmm1, %zmm0
	vmovupd	1120(%rsp), %zmm1
	vfmadd231pd	(%rbx,%rax), %zmm1, %zmm0
	addq	%rbx, %rax
	vmovupd	704(%rsp), %zmm1
	vfmadd231pd	(%rbx,%rax), %zmm1, %zmm0
	addq	%rbx, %rax
	vmovupd	640(%rsp), %zmm1
	vfmadd231pd	(%rbx,%rax), %zmm1, %zmm0
	addq	%rbx, %rax
	vmovupd	576(%rsp), %zmm1
	vfmadd231pd	(%rbx,%rax), %zmm1, %zmm0
	addq	%rbx, %rax
	vmovupd	512(%rsp), %zmm1
	vfmadd231pd	(%rbx,%rax), %zmm1, %zmm0
	addq	%rbx, %rax
	vmovupd	864(%rsp), %zmm1
	vfmadd231pd	(%rbx,%rax), %zmm1, %zmm0
	addq	%rbx, %rax
	vmovupd	800(%rsp), %zmm1
	vfmadd231pd	(%rbx,%rax), %zmm1, %zmm0
	addq	%rbx, %rax
	vmovupd	928(%rsp), %zmm1
	vfmadd231pd	(%rbx,%rax), %zmm1, %zmm0
	vxorpd	%xmm1, %xmm1, %xmm1
	vmaxpd	%zmm0, %zmm1, %zmm0
	vshufpd	$1, %xmm0, %xmm0, %xmm1
	vmovapd	%xmm1, 128(%rsp)
	vextractf128	$1, %ymm0, %xmm1
	vmovapd	%xmm1, 192(%rsp)
	vshufpd	$1, %xmm1, %xmm1, %xmm1
	vmovapd	%xmm1, 160(%rsp)
	vextractf32x4	$2, %zmm0, %xmm1
	vmovapd	%xmm1, 176(%rsp)
	vshufpd	$1, %xmm1, %xmm1, %xmm1
	vmovapd	%xmm1, 208(%rsp)
	vextractf32x4	$3, %zmm0, %xmm1
	vmovapd	%xmm1, 112(%rsp)
	vshufpd	$1, %xmm1, %xmm1, %xmm1
	vmovapd	%xmm1, 224(%rsp)
	vmovsd	(%rsp), %xmm1
	vzeroupper
	callq	*%r14
	vmovaps	%xmm0, 240(%rsp)
	vmovaps	128(%rsp), %xmm0
	vmovsd	(%rsp), %xmm1
	callq	*%r14
	vmovaps	%xmm0, 128(%rsp)
	vmovaps	192(%rsp), %xmm0
	vmovsd	(%rsp), %xmm1
	callq	*%r14
	vmovaps	%xmm0, 192(%rsp)
	vmovaps	160(%rsp), %xmm0
	vmovsd	(%rsp), %xmm1
	callq	*%r14
	vmovaps	%xmm0, 160(%rsp)
	vmovaps	176(%rsp), %xmm0
	vmovsd	(%rsp), %xmm1
	callq	*%r14
	vmovaps	%xmm0, 176(%rsp)
	vmovaps	208(%rsp), %xmm0
	vmovsd	(%rsp), %xmm1
	callq	*%r14
	vmovaps	%xmm0, 208(%rsp)
	vmovaps	112(%rsp), %xmm0
	vmovsd	(%rsp), %xmm1
	callq	*%r14
	vmovaps	%xmm0, 112(%rsp)
	vmovapd	224(%rsp), %xmm0
	vmovsd	(%rsp), %xmm1
	callq	*%r14
	vmovapd	112(%rsp), %xmm1
	vmovapd	240(%rsp), %xmm2
	movq	2712(%rsp), %rax
	vunpcklpd	128(%rsp), %xmm2, %xmm2
	vunpcklpd	%xmm0, %xmm1, %xmm0
	vmovapd	176(%rsp), %xmm1
	vunpcklpd	208(%rsp), %xmm1, %xmm1
	vinsertf128	$1, %xmm0, %ymm1, %ymm0
	vmovapd	192(%rsp), %xmm1
	vunpcklpd	160(%rsp), %xmm1, %xmm1
	vinsertf128	$1, %xmm1, %ymm2, %ymm1
	vinsertf64x4	$1, %ymm0, %zmm1, %zmm0
	vmovupd	%zmm0, 8(%rax,%rbp,8)
	addq	$8, %rbp
	cmpq	%rbp, %r13
	jne	.LBB0_26
	movq	8(%rsp), %rdi
	vmovapd	16(%rsp), %xmm3
	vmovapd	96(%rsp), %xmm4
	vmovapd	80(%rsp), %xmm5
	vmovapd	64(%rsp), %xmm6
	vmovapd	48(%rsp), %xmm7
	vmovapd	32(%rsp), %xmm8
	vmovapd	304(%rsp), %xmm9
	vmovapd	288(%rsp), %xmm10
	vmovapd	272(%rsp), %xmm11
	vmovapd	256(%rsp), %xmm12
	movq	%rbx, %r15
	movq	432(%rsp), %r9
	movq	416(%rsp), %r10
	movq	400(%rsp), %r11
	movq	384(%rsp), %r12
	movq	152(%rsp), %rbp
	cmpq	%r13, %rdi
	movq	368(%rsp), %r13
	je	.LBB0_3
.LBB0_28:
	movq	%r12, %rbx
	movq	%rdi, %r14
	testb	$1, %dil
	je	.LBB0_30
	movq	2544(%rsp), %rax
	movq	2488(%rsp), %rcx
	movq	448(%rsp), %rdx
	vxorpd	%xmm1, %xmm1, %xmm1
	leaq	1(%r12), %rbx
	vmovsd	(%rax,%r12,8), %xmm0
	vfmadd213sd	(%rcx,%r12,8), %xmm12, %xmm0
	movq	2824(%rsp), %rcx
	leaq	(%rcx,%r12,8), %rax
	vfmadd231sd	(%rcx,%r12,8), %xmm7, %xmm0
	movq	2840(%rsp), %rcx
	vfmadd231sd	(%rax,%rcx,8), %xmm6, %xmm0
	movq	464(%rsp), %rcx
	vfmadd231sd	(%r9,%rax), %xmm5, %xmm0
	vfmadd231sd	(%r10,%rax), %xmm4, %xmm0
	vfmadd231sd	(%r11,%rax), %xmm3, %xmm0
	vfmadd231sd	(%r13,%rax), %xmm10, %xmm0
	vfmadd231sd	(%rbp,%rax), %xmm9, %xmm0
	vfmadd231sd	(%rcx,%rax), %xmm8, %xmm0
	vfmadd231sd	(%rdx,%rax), %xmm11, %xmm0
	movabsq	$pow, %rax
	vmaxsd	%xmm0, %xmm1, %xmm0
	vmovsd	(%rsp), %xmm1
	vzeroupper
	callq	*%rax
	vmovapd	256(%rsp), %xmm12
	vmovapd	272(%rsp), %xmm11
	vmovapd	288(%rsp), %xmm10
	vmovapd	304(%rsp), %xmm9
	vmovapd	32(%rsp), %xmm8
	vmovapd	48(%rsp), %xmm7
	vmovapd	64(%rsp), %xmm6
	vmovapd	80(%rsp), %xmm5
	vmovapd	96(%rsp), %xmm4
	vmovapd	16(%rsp), %xmm3
	movq	2712(%rsp), %rax
	vmovsd	%xmm0, (%rax,%r12,8)
.LBB0_30:
	movq	2544(%rsp), %rcx
	cmpq	%r12, %r14
	je	.LBB0_3
	movq	2824(%rsp), %rax
	leaq	8(%rcx,%rbx,8), %rcx
	movq	2488(%rsp), %rdx
	subq	%rbx, %r14
	xorl	%ebp, %ebp
	incq	%r14
	movq	%rcx, 224(%rsp)
	movq	2712(%rsp), %rcx
	movq	%r14, 8(%rsp)
	leaq	8(%rax,%rbx,8), %rax
	movq	%rax, 240(%rsp)
	leaq	8(%rdx,%rbx,8), %rax
	movq	%rax, 128(%rsp)
	leaq	8(%rcx,%rbx,8), %rax
	movq	%rax, 112(%rsp)
	.p2align	4
.LBB0_32:
	movq	224(%rsp), %rax
	movq	128(%rsp), %rcx
	movq	240(%rsp), %rdx
	vxorpd	%xmm1, %xmm1, %xmm1
	vmovsd	-8(%rax,%rbp,8), %xmm0
	vfmadd213sd	-8(%rcx,%rbp,8), %xmm12, %xmm0
	leaq	(%rdx,%rbp,8), %rcx
	movq	%rcx, %rax
	movq	%rcx, 208(%rsp)
	vfmadd231sd	-8(%rdx,%rbp,8), %xmm7, %xmm0
	movq	2840(%rsp), %rdx
	vfmadd231sd	-8(%rax,%rdx,8), %xmm6, %xmm0
	leaq	-8(%rcx,%rdx,8), %rcx
	leaq	(%rcx,%r15), %rax
	movq	%rcx, 192(%rsp)
	leaq	(%rax,%r15), %r14
	movq	%rax, 176(%rsp)
	vfmadd231sd	(%r15,%rcx), %xmm5, %xmm0
	leaq	(%r14,%r15), %r13
	leaq	(%r13,%r15), %rbx
	leaq	(%rbx,%r15), %r12
	vfmadd231sd	(%r15,%rax), %xmm4, %xmm0
	leaq	(%r12,%r15), %rax
	movq	%rax, 160(%rsp)
	vfmadd231sd	(%r15,%r14), %xmm3, %xmm0
	vfmadd231sd	(%r15,%r13), %xmm10, %xmm0
	vfmadd231sd	(%r15,%rbx), %xmm9, %xmm0
	vfmadd231sd	(%r15,%r12), %xmm8, %xmm0
	vfmadd231sd	(%r15,%rax), %xmm11, %xmm0
	movabsq	$pow, %rax
	vmaxsd	%xmm0, %xmm1, %xmm0
	vmovsd	(%rsp), %xmm1
	vzeroupper
	callq	*%rax
	movq	112(%rsp), %rax
	movq	224(%rsp), %rcx
	movq	128(%rsp), %rdx
	vmovapd	256(%rsp), %xmm1
	vmovsd	%xmm0, -8(%rax,%rbp,8)
	movq	192(%rsp), %rax
	vmovsd	(%rcx,%rbp,8), %xmm0
	movq	240(%rsp), %rcx
	vfmadd213sd	(%rdx,%rbp,8), %xmm1, %xmm0
	vmovapd	48(%rsp), %xmm1
	movq	208(%rsp), %rdx
	vfmadd231sd	(%rcx,%rbp,8), %xmm1, %xmm0
	movq	2840(%rsp), %rcx
	vmovapd	64(%rsp), %xmm1
	vfmadd231sd	(%rdx,%rcx,8), %xmm1, %xmm0
	vmovapd	80(%rsp), %xmm1
	vfmadd231sd	8(%r15,%rax), %xmm1, %xmm0
	movq	176(%rsp), %rax
	vmovapd	96(%rsp), %xmm1
	vfmadd231sd	8(%r15,%rax), %xmm1, %xmm0
	vmovapd	16(%rsp), %xmm1
	movq	160(%rsp), %rax
	vfmadd231sd	8(%r15,%r14), %xmm1, %xmm0
	vmovapd	288(%rsp), %xmm1
	vfmadd231sd	8(%r15,%r13), %xmm1, %xmm0
	vmovapd	304(%rsp), %xmm1
	vfmadd231sd	8(%r15,%rbx), %xmm1, %xmm0
	vmovapd	32(%rsp), %xmm1
	vfmadd231sd	8(%r15,%r12), %xmm1, %xmm0
	vmovapd	272(%rsp), %xmm1
	vfmadd231sd	8(%r15,%rax), %xmm1, %xmm0
	movabsq	$pow, %rax
	vxorpd	%xmm1, %xmm1, %xmm1
	vmaxsd	%xmm0, %xmm1, %xmm0
	vmovsd	(%rsp), %xmm1
	callq	*%rax
	vmovapd	256(%rsp), %xmm12
	vmovapd	272(%rsp), %xmm11
	vmovapd	288(%rsp), %xmm10
	vmovapd	304(%rsp), %xmm9
	vmovapd	32(%rsp), %xmm8
	vmovapd	48(%rsp), %xmm7
	vmovapd	64(%rsp), %xmm6
	vmovapd	80(%rsp), %xmm5
	vmovapd	96(%rsp), %xmm4
	vmovapd	16(%rsp), %xmm3
	movq	112(%rsp), %rax
	vmovsd	%xmm0, (%rax,%rbp,8)
	addq	$2, %rbp
	cmpq	%rbp, 8(%rsp)
	jne	.LBB0_32
	jmp	.LBB0_3
.LBB0_11:
	vmovapd	16(%rsp), %xmm14
	vmovapd	96(%rsp), %xmm15
	vmovapd	80(%rsp), %xmm16
	vmovapd	64(%rsp), %xmm17
	vmovapd	48(%rsp), %xmm18
	vmovsd	2952(%rsp), %xmm19
	vmovsd	2944(%rsp), %xmm20
	vmovsd	2936(%rsp), %xmm21
	vmovsd	2960(%rsp), %xmm22
	movq	2544(%rsp), %r14
	testq	%rcx, %rcx
	jle	.LBB0_3
	vmulsd	%xmm13, %xmm13, %xmm2
	vmulsd	2976(%rsp), %xmm2, %xmm4
	vmulsd	2984(%rsp), %xmm2, %xmm5
	vmulsd	2968(%rsp), %xmm2, %xmm3
	vmulsd	3040(%rsp), %xmm13, %xmm0
	movq	2840(%rsp), %r11
	movq	%rcx, %rbx
	movl	$1, %r9d
	movq	%rbx, %rdx
	leaq	(,%r11,8), %rax
	movq	%r11, %rcx
	shlq	$4, %rcx
	imulq	$56, %r11, %r10
	movq	%r11, %rsi
	shlq	$5, %rsi
	shlq	$6, %r11
	leaq	(%rcx,%rcx,2), %r8
	leaq	(%rax,%rax,2), %rdi
	leaq	(%rax,%rax,4), %r13
	vfmadd213sd	%xmm4, %xmm1, %xmm17
	vmulsd	2992(%rsp), %xmm2, %xmm4
	vfmadd213sd	%xmm5, %xmm1, %xmm16
	vmulsd	3000(%rsp), %xmm2, %xmm5
	vfmadd213sd	%xmm3, %xmm1, %xmm18
	vfmadd213sd	%xmm4, %xmm1, %xmm15
	vmulsd	3008(%rsp), %xmm2, %xmm4
	vfmadd213sd	%xmm5, %xmm1, %xmm14
	vmulsd	3016(%rsp), %xmm2, %xmm5
	vfmadd213sd	%xmm4, %xmm1, %xmm21
	vmulsd	3024(%rsp), %xmm2, %xmm4
	vmulsd	3032(%rsp), %xmm2, %xmm2
	vfmadd213sd	%xmm5, %xmm1, %xmm20
	vfmadd213sd	%xmm4, %xmm1, %xmm19
	vfmadd213sd	%xmm2, %xmm1, %xmm22
	cmpq	$16, %rbx
	jae	.LBB0_14
	movq	%rdx, %rbp
	jmp	.LBB0_18
.LBB0_33:
	vmovapd	16(%rsp), %xmm2
	vmovapd	96(%rsp), %xmm3
	vmovapd	80(%rsp), %xmm4
	vmovapd	64(%rsp), %xmm5
	vmovapd	48(%rsp), %xmm0
	vmovsd	2952(%rsp), %xmm6
	vmovsd	2944(%rsp), %xmm7
	vmovsd	2936(%rsp), %xmm8
	vmovsd	2960(%rsp), %xmm9
	movq	2544(%rsp), %r10
	testq	%rcx, %rcx
	jle	.LBB0_3
	vmulsd	%xmm1, %xmm0, %xmm11
	vmulsd	%xmm13, %xmm13, %xmm0
	vmulsd	3040(%rsp), %xmm13, %xmm10
	vmulsd	%xmm1, %xmm5, %xmm13
	vmulsd	%xmm1, %xmm4, %xmm14
	vmulsd	%xmm1, %xmm3, %xmm15
	vmulsd	%xmm1, %xmm2, %xmm16
	vmulsd	%xmm1, %xmm7, %xmm19
	vmulsd	2968(%rsp), %xmm0, %xmm12
	vmulsd	2976(%rsp), %xmm0, %xmm5
	vmulsd	2984(%rsp), %xmm0, %xmm4
	vmulsd	2992(%rsp), %xmm0, %xmm3
	vmulsd	3000(%rsp), %xmm0, %xmm17
	vmulsd	3008(%rsp), %xmm0, %xmm18
	vmulsd	3016(%rsp), %xmm0, %xmm7
	vmulsd	3024(%rsp), %xmm0, %xmm2
	vmulsd	3032(%rsp), %xmm0, %xmm21
	movq	2912(%rsp), %rdx
	movq	2840(%rsp), %rdi
	vmulsd	%xmm1, %xmm9, %xmm9
	vmulsd	%xmm1, %xmm8, %xmm8
	vmulsd	%xmm1, %xmm6, %xmm20
	movq	%rcx, %rax
	movl	$1, %ecx
	movq	%rax, 8(%rsp)
	vmovapd	%xmm9, 96(%rsp)
	vmovapd	%xmm11, 64(%rsp)
	vmovapd	%xmm13, 304(%rsp)
	vmovapd	%xmm14, 272(%rsp)
	vmovapd	%xmm15, 240(%rsp)
	vmovapd	%xmm16, 128(%rsp)
	vmovapd	%xmm8, 208(%rsp)
	vmovapd	%xmm19, 176(%rsp)
	vmovapd	%xmm20, 1056(%rsp)
	leaq	(,%rdx,8), %rbx
	leaq	(,%rdi,8), %r13
	vmovapd	%xmm10, 80(%rsp)
	vmovapd	%xmm12, 48(%rsp)
	vmovapd	%xmm5, 288(%rsp)
	vmovapd	%xmm4, 256(%rsp)
	vmovapd	%xmm3, 224(%rsp)
	vmovapd	%xmm17, 112(%rsp)
	vmovapd	%xmm18, 192(%rsp)
	vmovapd	%xmm7, 160(%rsp)
	vmovapd	%xmm2, 1120(%rsp)
	vmovapd	%xmm21, 992(%rsp)
	cmpq	$24, %rax
	jae	.LBB0_36
	vmovsd	(%rsp), %xmm1
	movq	8(%rsp), %rdx
	jmp	.LBB0_40
.LBB0_14:
	movq	2712(%rsp), %r15
	movq	%r15, %rbx
	subq	2488(%rsp), %rbx
	movq	%r15, %r14
	cmpq	$64, %rbx
	setb	%bl
	subq	2544(%rsp), %r14
	cmpq	$64, %r14
	setb	%bpl
	orb	%bl, %bpl
	movq	%r15, %rbx
	subq	2824(%rsp), %rbx
	movq	%rbx, %r14
	subq	%r11, %r14
	movq	%rbx, %r15
	movq	%rbx, %r12
	cmpq	$64, %r14
	setb	%r14b
	subq	%r10, %r15
	orb	%bpl, %r14b
	cmpq	$64, %r15
	movq	%rbx, %r15
	setb	%bpl
	orb	%r14b, %bpl
	movq	%rbx, %r14
	subq	%r8, %r14
	cmpq	$64, %r14
	setb	%r14b
	subq	%r13, %r15
	cmpq	$64, %r15
	setb	%r15b
	orb	%r14b, %r15b
	movq	%rbx, %r14
	subq	%rsi, %r14
	orb	%bpl, %r15b
	cmpq	$64, %r14
	movq	%rbx, %r14
	setb	%bpl
	subq	%rdi, %r14
	cmpq	$64, %r14
	setb	%r14b
	subq	%rcx, %r12
	orb	%bpl, %r14b
	cmpq	$64, %r12
	setb	%bpl
	orb	%r14b, %bpl
	movq	%rbx, %r14
	subq	%rax, %r14
	orb	%r15b, %bpl
	cmpq	$64, %r14
	setb	%r14b
	cmpq	$64, %rbx
	setb	%bl
	orb	%r14b, %bl
	movq	2544(%rsp), %r14
	orb	%bpl, %bl
	movq	%rdx, %rbp
	testb	$1, %bl
	jne	.LBB0_18
	movabsq	$9223372036854775800, %rbx
	movq	2824(%rsp), %r12
	movq	2712(%rsp), %r13
	vbroadcastsd	%xmm0, %zmm1
	vbroadcastsd	%xmm18, %zmm2
	vbroadcastsd	%xmm17, %zmm3
	vbroadcastsd	%xmm16, %zmm4
	vbroadcastsd	%xmm15, %zmm5
	vbroadcastsd	%xmm14, %zmm6
	vbroadcastsd	%xmm21, %zmm7
	vbroadcastsd	%xmm20, %zmm8
	vbroadcastsd	%xmm19, %zmm9
	vbroadcastsd	%xmm22, %zmm10
	movq	%r14, %rdi
	xorl	%r15d, %r15d
	vxorpd	%xmm11, %xmm11, %xmm11
	andq	%rbp, %rbx
	movq	2488(%rsp), %rbp
	leaq	1(%rbx), %r9
	leaq	8(%r12), %r14
	.p2align	4
.LBB0_16:
	vmovupd	8(%rdi,%r15,8), %zmm12
	leaq	(%r14,%r15,8), %r12
	vfmadd213pd	8(%rbp,%r15,8), %zmm1, %zmm12
	vfmadd231pd	(%r14,%r15,8), %zmm2, %zmm12
	vfmadd231pd	(%rax,%r12), %zmm3, %zmm12
	addq	%rax, %r12
	vfmadd231pd	(%rax,%r12), %zmm4, %zmm12
	addq	%rax, %r12
	vfmadd231pd	(%rax,%r12), %zmm5, %zmm12
	addq	%rax, %r12
	vfmadd231pd	(%rax,%r12), %zmm6, %zmm12
	addq	%rax, %r12
	vfmadd231pd	(%rax,%r12), %zmm7, %zmm12
	addq	%rax, %r12
	vfmadd231pd	(%rax,%r12), %zmm8, %zmm12
	addq	%rax, %r12
	vfmadd231pd	(%rax,%r12), %zmm9, %zmm12
	addq	%rax, %r12
	vfmadd231pd	(%rax,%r12), %zmm10, %zmm12
	vmaxpd	%zmm12, %zmm11, %zmm12
	vsqrtpd	%zmm12, %zmm13
	vmulpd	%zmm13, %zmm12, %zmm12
	vmovupd	%zmm12, 8(%r13,%r15,8)
	addq	$8, %r15
	cmpq	%r15, %rbx
	jne	.LBB0_16
	movq	%rdi, %r14
	leaq	(%rax,%rax,2), %rdi
	leaq	(%rax,%rax,4), %r13
	movq	%rdx, %rbp
	cmpq	%rbx, %rdx
	je	.LBB0_3
.LBB0_18:
	movq	%r9, %rbx
	testb	$1, %bpl
	je	.LBB0_20
	movq	2488(%rsp), %rdx
	vmovsd	(%r14,%r9,8), %xmm1
	movq	2824(%rsp), %r14
	vxorpd	%xmm2, %xmm2, %xmm2
	vfmadd213sd	(%rdx,%r9,8), %xmm0, %xmm1
	leaq	(%r14,%r9,8), %rbx
	vfmadd231sd	(%r14,%r9,8), %xmm18, %xmm1
	movq	2840(%rsp), %r14
	vfmadd231sd	(%rbx,%r14,8), %xmm17, %xmm1
	movq	2544(%rsp), %r14
	vfmadd231sd	(%rcx,%rbx), %xmm16, %xmm1
	movq	2712(%rsp), %rcx
	vfmadd231sd	(%rdi,%rbx), %xmm15, %xmm1
	vfmadd231sd	(%rsi,%rbx), %xmm14, %xmm1
	vfmadd231sd	(%r13,%rbx), %xmm21, %xmm1
	vfmadd231sd	(%r8,%rbx), %xmm20, %xmm1
	vfmadd231sd	(%r10,%rbx), %xmm19, %xmm1
	vfmadd231sd	(%r11,%rbx), %xmm22, %xmm1
	leaq	1(%r9), %rbx
	vmaxsd	%xmm1, %xmm2, %xmm1
	vsqrtsd	%xmm1, %xmm1, %xmm2
	vmulsd	%xmm2, %xmm1, %xmm1
	vmovsd	%xmm1, (%rcx,%r9,8)
.LBB0_20:
	cmpq	%r9, %rbp
	je	.LBB0_3
	movq	2824(%rsp), %rcx
	movq	2488(%rsp), %rsi
	movq	2712(%rsp), %rdi
	movq	%rbp, %rdx
	subq	%rbx, %rdx
	leaq	8(%r14,%rbx,8), %rbp
	xorl	%r8d, %r8d
	vxorpd	%xmm1, %xmm1, %xmm1
	incq	%rdx
	movq	%rdx, 8(%rsp)
	leaq	8(%rcx,%rbx,8), %rcx
	leaq	8(%rsi,%rbx,8), %rsi
	leaq	8(%rdi,%rbx,8), %rdi
	.p2align	4
.LBB0_22:
	vmovsd	-8(%rbp,%r8,8), %xmm2
	movq	2840(%rsp), %rdx
	leaq	(%rcx,%r8,8), %r9
	vfmadd213sd	-8(%rsi,%r8,8), %xmm0, %xmm2
	vfmadd231sd	-8(%rcx,%r8,8), %xmm18, %xmm2
	leaq	-8(%r9,%rdx,8), %r10
	leaq	(%r10,%rax), %r11
	leaq	(%r11,%rax), %rbx
	vfmadd231sd	-8(%r9,%rdx,8), %xmm17, %xmm2
	leaq	(%rbx,%rax), %r14
	leaq	(%r14,%rax), %r15
	leaq	(%r15,%rax), %r12
	leaq	(%r12,%rax), %r13
	vfmadd231sd	(%rax,%r10), %xmm16, %xmm2
	vfmadd231sd	(%rax,%r11), %xmm15, %xmm2
	vfmadd231sd	(%rax,%rbx), %xmm14, %xmm2
	vfmadd231sd	(%rax,%r14), %xmm21, %xmm2
	vfmadd231sd	(%rax,%r15), %xmm20, %xmm2
	vfmadd231sd	(%rax,%r12), %xmm19, %xmm2
	vfmadd231sd	(%rax,%r13), %xmm22, %xmm2
	vmaxsd	%xmm2, %xmm1, %xmm2
	vsqrtsd	%xmm2, %xmm2, %xmm3
	vmulsd	%xmm3, %xmm2, %xmm2
	vmovsd	%xmm2, -8(%rdi,%r8,8)
	vmovsd	(%rbp,%r8,8), %xmm2
	vfmadd213sd	(%rsi,%r8,8), %xmm0, %xmm2
	vfmadd231sd	(%rcx,%r8,8), %xmm18, %xmm2
	vfmadd231sd	(%r9,%rdx,8), %xmm17, %xmm2
	vfmadd231sd	8(%rax,%r10), %xmm16, %xmm2
	vfmadd231sd	8(%rax,%r11), %xmm15, %xmm2
	vfmadd231sd	8(%rax,%rbx), %xmm14, %xmm2
	vfmadd231sd	8(%rax,%r14), %xmm21, %xmm2
	vfmadd231sd	8(%rax,%r15), %xmm20, %xmm2
	vfmadd231sd	8(%rax,%r12), %xmm19, %xmm2
	vfmadd231sd	8(%rax,%r13), %xmm22, %xmm2
	vmaxsd	%xmm2, %xmm1, %xmm2
	vsqrtsd	%xmm2, %xmm2, %xmm3
	vmulsd	%xmm3, %xmm2, %xmm2
	vmovsd	%xmm2, (%rdi,%r8,8)
	addq	$2, %r8
	cmpq	%r8, 8(%rsp)
	jne	.LBB0_22
	jmp	.LBB0_3
.LBB0_36:
	movq	%rdi, %rax
	shlq	$4, %rax
	movq	2712(%rsp), %rcx
	movq	2768(%rsp), %r11
	movq	%rdx, %r10
	movq	%rdx, %r8
	imulq	$56, %rdx, %rsi
	shlq	$4, %r8
	imulq	$56, %rdi, %r9
	shlq	$5, %r10
	shlq	$6, %rdx
	vmovsd	(%rsp), %xmm1
	movq	%rax, 512(%rsp)
	movq	%rdi, %rax
	shlq	$5, %rax
	shlq	$6, %rdi
	leaq	(%r8,%r8,2), %r12
	movq	%rax, 576(%rsp)
	movq	2488(%rsp), %rax
	movq	%r12, 704(%rsp)
	movq	%r9, 16(%rsp)
	movq	%rsi, 640(%rsp)
	subq	%rcx, %r11
	movq	%rcx, %r14
	cmpq	$64, %r11
	setb	%r11b
	subq	%rax, %r14
	movq	2896(%rsp), %rax
	cmpq	$64, %r14
	setb	%bpl
	orb	%r11b, %bpl
	movq	%rcx, %r11
	subq	2544(%rsp), %r11
	cmpq	$64, %r11
	movq	%rcx, %r11
	setb	%r14b
	subq	%rax, %r11
	leaq	(%rbx,%rbx,4), %rax
	movq	%r11, %r15
	subq	%rdx, %r15
	orb	%bpl, %r14b
	cmpq	$64, %r15
	movq	%r11, %r15
	setb	%bpl
	orb	%r14b, %bpl
	movq	%r11, %r14
	subq	%rsi, %r14
	movq	2768(%rsp), %rsi
	cmpq	$64, %r14
	setb	%r14b
	subq	%r12, %r15
	movq	%r11, %r12
	orb	%bpl, %r14b
	cmpq	$64, %r15
	movq	%r11, %r15
	setb	%bpl
	subq	%rax, %r15
	leaq	(%rbx,%rbx,2), %rax
	cmpq	$64, %r15
	setb	%r15b
	orb	%bpl, %r15b
	orb	%r14b, %r15b
	movq	%r11, %r14
	subq	%r10, %r14
	cmpq	$64, %r14
	movq	%r11, %r14
	setb	%bpl
	subq	%rax, %r14
	movq	%rcx, %rax
	movq	2824(%rsp), %rcx
	cmpq	$64, %r14
	setb	%r14b
	subq	%r8, %r12
	orb	%bpl, %r14b
	cmpq	$64, %r12
	setb	%bpl
	orb	%r14b, %bpl
	movq	%r11, %r14
	subq	%rbx, %r14
	orb	%r15b, %bpl
	cmpq	$64, %r14
	setb	%r14b
	cmpq	$64, %r11
	setb	%r11b
	subq	%rcx, %rax
	movq	%rax, %r15
	subq	%rdi, %r15
	orb	%r14b, %r11b
	movq	%rax, %r14
	cmpq	$64, %r15
	setb	%r15b
	orb	%r11b, %r15b
	movq	%rax, %r11
	subq	%r9, %r11
	movq	512(%rsp), %r9
	cmpq	$64, %r11
	setb	%r11b
	orb	%r15b, %r11b
	movq	%rax, %r15
	leaq	(%r9,%r9,2), %rcx
	subq	%rcx, %r15
	leaq	(%r13,%r13,4), %rcx
	cmpq	$64, %r15
	movq	%rax, %r15
	setb	%r12b
	subq	%rcx, %r15
	orb	%r11b, %r12b
	movq	576(%rsp), %r11
	cmpq	$64, %r15
	setb	%r15b
	orb	%r12b, %r15b
	movq	%rax, %r12
	orb	%bpl, %r15b
	leaq	(%r13,%r13,2), %rbp
	subq	%r11, %r12
	cmpq	$64, %r12
	setb	%r12b
	subq	%rbp, %r14
	cmpq	$64, %r14
	setb	%r14b
	orb	%r12b, %r14b
	movq	%rax, %r12
	subq	%r9, %r12
	cmpq	$64, %r12
	setb	%r12b
	orb	%r14b, %r12b
	movq	%rax, %r14
	subq	%r13, %r14
	cmpq	$64, %r14
	setb	%cl
	orb	%r12b, %cl
	cmpq	$64, %rax
	movq	%rsi, %rax
	setb	%r14b
	subq	2488(%rsp), %rax
	orb	%cl, %r14b
	movq	%rsi, %rcx
	orb	%r15b, %r14b
	movq	%rsi, %r15
	cmpq	$64, %rax
	setb	%al
	subq	2544(%rsp), %rcx
	cmpq	$64, %rcx
	setb	%cl
	subq	2896(%rsp), %r15
	orb	%al, %cl
	movq	%r15, %r12
	subq	%rdx, %r12
	movq	%r15, %rdx
	cmpq	$64, %r12
	leaq	(%rbx,%rbx,4), %r12
	setb	%al
	subq	640(%rsp), %rdx
	orb	%cl, %al
	cmpq	$64, %rdx
	movq	%r15, %rdx
	setb	%cl
	subq	704(%rsp), %rdx
	orb	%al, %cl
	cmpq	$64, %rdx
	movq	%r15, %rdx
	setb	%al
	subq	%r12, %rdx
	orb	%cl, %al
	cmpq	$64, %rdx
	movq	%r15, %rdx
	setb	%cl
	subq	%r10, %rdx
	leaq	(%rbx,%rbx,2), %r10
	orb	%al, %cl
	cmpq	$64, %rdx
	movq	%r15, %rax
	setb	%dl
	subq	%r10, %rax
	movq	2544(%rsp), %r10
	orb	%cl, %dl
	cmpq	$64, %rax
	movq	%r15, %rcx
	setb	%al
	subq	%r8, %rcx
	orb	%dl, %al
	movq	%r15, %rdx
	orb	%r14b, %al
	cmpq	$64, %rcx
	setb	%cl
	subq	%rbx, %rdx
	cmpq	$64, %rdx
	setb	%dl
	orb	%cl, %dl
	cmpq	$64, %r15
	setb	%cl
	subq	2824(%rsp), %rsi
	orb	%dl, %cl
	movq	%rsi, %r8
	subq	%rdi, %r8
	movq	%rsi, %rdi
	cmpq	$64, %r8
	leaq	(%r9,%r9,2), %r8
	setb	%dl
	subq	16(%rsp), %rdi
	orb	%cl, %dl
	cmpq	$64, %rdi
	movq	%rsi, %rdi
	setb	%cl
	subq	%r8, %rdi
	leaq	(%r13,%r13,4), %r8
	orb	%dl, %cl
	cmpq	$64, %rdi
	movq	%rsi, %rdi
	setb	%dl
	subq	%r8, %rdi
	orb	%cl, %dl
	cmpq	$64, %rdi
	movq	%rsi, %rdi
	setb	%cl
	subq	%r11, %rdi
	orb	%dl, %cl
	cmpq	$64, %rdi
	movq	%rsi, %rdi
	setb	%dl
	subq	%rbp, %rdi
	orb	%cl, %dl
	cmpq	$64, %rdi
	movq	%rsi, %rdi
	setb	%cl
	subq	%r9, %rdi
	orb	%dl, %cl
	movq	%rsi, %rdx
	orb	%al, %cl
	cmpq	$64, %rdi
	setb	%al
	subq	%r13, %rdx
	cmpq	$64, %rdx
	setb	%dl
	orb	%al, %dl
	cmpq	$64, %rsi
	setb	%al
	orb	%dl, %al
	movq	8(%rsp), %rdx
	orb	%cl, %al
	movl	$1, %ecx
	testb	$1, %al
	jne	.LBB0_40
	movabsq	$9223372036854775800, %rax
	vbroadcastsd	%xmm5, %zmm5
	vbroadcastsd	%xmm3, %zmm3
	vbroadcastsd	%xmm11, %zmm6
	movq	2712(%rsp), %r15
	movq	2488(%rsp), %r12
	vbroadcastsd	%xmm9, %zmm0
	vbroadcastsd	%xmm10, %zmm9
	movabsq	$pow, %r14
	xorl	%ebp, %ebp
	andq	%rdx, %rax
	movq	%rax, 152(%rsp)
	incq	%rax
	vmovupd	%zmm5, 2016(%rsp)
	vbroadcastsd	%xmm4, %zmm5
	vbroadcastsd	%xmm15, %zmm4
	vmovupd	%zmm3, 1760(%rsp)
	vbroadcastsd	%xmm17, %zmm3
	vmovupd	%zmm6, 2208(%rsp)
	vbroadcastsd	%xmm13, %zmm6
	vmovupd	%zmm9, 2272(%rsp)
	vbroadcastsd	%xmm12, %zmm9
	vmovupd	%zmm0, 2336(%rsp)
	movq	%rax, 480(%rsp)
	movq	2896(%rsp), %rax
	vmovupd	%zmm4, 1824(%rsp)
	vbroadcastsd	%xmm16, %zmm4
	vmovupd	%zmm3, 1632(%rsp)
	vbroadcastsd	%xmm18, %zmm3
	vmovupd	%zmm6, 2080(%rsp)
	vbroadcastsd	%xmm14, %zmm6
	vmovupd	%zmm9, 2144(%rsp)
	vmovupd	%zmm5, 1888(%rsp)
	vmovupd	%zmm4, 1696(%rsp)
	vbroadcastsd	%xmm8, %zmm4
	vmovupd	%zmm3, 1504(%rsp)
	vbroadcastsd	%xmm7, %zmm3
	vmovupd	%zmm6, 1952(%rsp)
	leaq	8(%rax), %rax
	vmovupd	%zmm4, 1568(%rsp)
	vbroadcastsd	%xmm19, %zmm4
	vmovupd	%zmm3, 1376(%rsp)
	vbroadcastsd	%xmm2, %zmm3
	vbroadcastsd	%xmm21, %zmm2
	movq	%rax, 496(%rsp)
	movq	2824(%rsp), %rax
	vmovupd	%zmm4, 1440(%rsp)
	vbroadcastsd	%xmm20, %zmm4
	vmovupd	%zmm3, 1248(%rsp)
	vmovupd	%zmm2, 1184(%rsp)
	vmovupd	%zmm4, 1312(%rsp)
	addq	$8, %rax
	movq	%rax, 488(%rsp)
	.p2align	4
.LBB0_38:
	movq	488(%rsp), %rdx
	vmovupd	2016(%rsp), %zmm0
	vmovupd	1888(%rsp), %zmm2
	vmovupd	1632(%rsp), %zmm3
	movq	496(%rsp), %rcx
	vmovupd	1504(%rsp), %zmm4
	vmovupd	1376(%rsp), %zmm5
	vmovupd	1248(%rsp), %zmm6
	vmovupd	1184(%rsp), %zmm7
	vmovupd	2080(%rsp), %zmm8
	vmovupd	1952(%rsp), %zmm9
	vmovupd	1824(%rsp), %zmm11
	movq	2544(%rsp), %rsi
	leaq	(%rdx,%rbp,8), %rax
	vmulpd	(%r13,%rax), %zmm0, %zmm0
	leaq	(%rax,%r13), %rax
	vmulpd	(%r13,%rax), %zmm2, %zmm10
	leaq	(%rax,%r13), %rax
	vmovupd	1760(%rsp), %zmm2
	vmulpd	(%r13,%rax), %zmm2, %zmm2
	leaq	(%rax,%r13), %rax
	vmulpd	(%r13,%rax), %zmm3, %zmm3
	leaq	(%rax,%r13), %rax
	vmulpd	(%r13,%rax), %zmm4, %zmm4
	leaq	(%rax,%r13), %rax
	vmulpd	(%r13,%rax), %zmm5, %zmm5
	leaq	(%rax,%r13), %rax
	vmulpd	(%r13,%rax), %zmm6, %zmm6
	leaq	(%rax,%r13), %rax
	vmulpd	(%r13,%rax), %zmm7, %zmm7
	leaq	(%rcx,%rbp,8), %rax
	vfmadd231pd	(%rbx,%rax), %zmm8, %zmm0
	leaq	(%rax,%rbx), %rax
	vmovupd	8(%rsi,%rbp,8), %zmm8
	vfmadd231pd	(%rbx,%rax), %zmm9, %zmm10
	leaq	(%rax,%rbx), %rax
	vmovupd	1696(%rsp), %zmm9
	vfmadd231pd	(%rbx,%rax), %zmm11, %zmm2
	leaq	(%rax,%rbx), %rax
	vmovupd	1568(%rsp), %zmm11
	vfmadd231pd	(%rbx,%rax), %zmm9, %zmm3
	leaq	(%rax,%rbx), %rax
	vmovupd	1440(%rsp), %zmm9
	vfmadd231pd	(%rbx,%rax), %zmm11, %zmm4
	leaq	(%rax,%rbx), %rax
	vmovupd	1312(%rsp), %zmm11
	vfmadd231pd	(%rbx,%rax), %zmm9, %zmm5
	leaq	(%rax,%rbx), %rax
	vmovupd	2336(%rsp), %zmm9
	vfmadd231pd	(%rbx,%rax), %zmm11, %zmm6
	leaq	(%rax,%rbx), %rax
	vmovupd	2144(%rsp), %zmm11
	vfmadd231pd	(%rbx,%rax), %zmm9, %zmm7
	vmovupd	2272(%rsp), %zmm9
	vfmadd213pd	8(%r12,%rbp,8), %zmm9, %zmm8
	vmulpd	(%rdx,%rbp,8), %zmm11, %zmm9
	vmovupd	2208(%rsp), %zmm11
	vfmadd231pd	(%rcx,%rbp,8), %zmm11, %zmm9
	vaddpd	%zmm9, %zmm8, %zmm8
	vaddpd	%zmm0, %zmm8, %zmm0
	vaddpd	%zmm10, %zmm0, %zmm0
	vaddpd	%zmm2, %zmm0, %zmm0
	vxorpd	%xmm2, %xmm2, %xmm2
	vaddpd	%zmm3, %zmm0, %zmm0
	vaddpd	%zmm4, %zmm0, %zmm0
	vaddpd	%zmm5, %zmm0, %zmm0
	vaddpd	%zmm6, %zmm0, %zmm0
	vaddpd	%zmm7, %zmm0, %zmm0
	vmaxpd	%zmm0, %zmm2, %zmm2
	vshufpd	$1, %xmm2, %xmm2, %xmm0
	vmovupd	%zmm2, 928(%rsp)
	vmovapd	%xmm0, 800(%rsp)
	vextractf128	$1, %ymm2, %xmm0
	vmovapd	%xmm0, 864(%rsp)
	vshufpd	$1, %xmm0, %xmm0, %xmm0
	vmovapd	%xmm0, 512(%rsp)
	vextractf32x4	$2, %zmm2, %xmm0
	vmovapd	%xmm0, 576(%rsp)
	vshufpd	$1, %xmm0, %xmm0, %xmm0
	vmovapd	%xmm0, 640(%rsp)
	vextractf32x4	$3, %zmm2, %xmm0
	vmovapd	%xmm0, 704(%rsp)
	vshufpd	$1, %xmm0, %xmm0, %xmm0
	vmovapd	%xmm0, 16(%rsp)
	vmovapd	%xmm2, %xmm0
	vzeroupper
	callq	*%r14
	vmovapd	%xmm0, 464(%rsp)
	vmovaps	800(%rsp), %xmm0
	vmovsd	(%rsp), %xmm1
	callq	*%r14
	vmovaps	%xmm0, 448(%rsp)
	vmovaps	864(%rsp), %xmm0
	vmovsd	(%rsp), %xmm1
	callq	*%r14
	vmovaps	%xmm0, 432(%rsp)
	vmovaps	512(%rsp), %xmm0
	vmovsd	(%rsp), %xmm1
	callq	*%r14
	vmovaps	%xmm0, 416(%rsp)
	vmovaps	576(%rsp), %xmm0
	vmovsd	(%rsp), %xmm1
	callq	*%r14
	vmovaps	%xmm0, 400(%rsp)
	vmovaps	640(%rsp), %xmm0
	vmovsd	(%rsp), %xmm1
	callq	*%r14
	vmovaps	%xmm0, 384(%rsp)
	vmovaps	704(%rsp), %xmm0
	vmovsd	(%rsp), %xmm1
	callq	*%r14
	vmovaps	%xmm0, 368(%rsp)
	vmovaps	16(%rsp), %xmm0
	vmovsd	(%rsp), %xmm1
	callq	*%r14
	vmovaps	368(%rsp), %xmm1
	vmovaps	464(%rsp), %xmm2
	vunpcklpd	448(%rsp), %xmm2, %xmm2
	vmovlhps	%xmm0, %xmm1, %xmm0
	vmovaps	400(%rsp), %xmm1
	vunpcklpd	384(%rsp), %xmm1, %xmm1
	vinsertf128	$1, %xmm0, %ymm1, %ymm0
	vmovaps	432(%rsp), %xmm1
	vunpcklpd	416(%rsp), %xmm1, %xmm1
	vinsertf128	$1, %xmm1, %ymm2, %ymm1
	vinsertf64x4	$1, %ymm0, %zmm1, %zmm0
	vmovsd	32(%rsp), %xmm1
	vmovups	%zmm0, 8(%r15,%rbp,8)
	vmovups	928(%rsp), %zmm0
	vzeroupper
	callq	*%r14
	vmovaps	%xmm0, 928(%rsp)
	vmovaps	800(%rsp), %xmm0
	vmovsd	32(%rsp), %xmm1
	callq	*%r14
	vmovaps	%xmm0, 800(%rsp)
	vmovaps	864(%rsp), %xmm0
	vmovsd	32(%rsp), %xmm1
	callq	*%r14
	vmovaps	%xmm0, 864(%rsp)
	vmovaps	512(%rsp), %xmm0
	vmovsd	32(%rsp), %xmm1
	callq	*%r14
	vmovaps	%xmm0, 512(%rsp)
	vmovaps	576(%rsp), %xmm0
	vmovsd	32(%rsp), %xmm1
	callq	*%r14
	vmovaps	%xmm0, 576(%rsp)
	vmovaps	640(%rsp), %xmm0
	vmovsd	32(%rsp), %xmm1
	callq	*%r14
	vmovaps	%xmm0, 640(%rsp)
	vmovaps	704(%rsp), %xmm0
	vmovsd	32(%rsp), %xmm1
	callq	*%r14
	vmovaps	%xmm0, 704(%rsp)
	vmovapd	16(%rsp), %xmm0
	vmovsd	32(%rsp), %xmm1
	callq	*%r14
	vmovapd	704(%rsp), %xmm2
	vmovsd	(%rsp), %xmm1
	movq	2768(%rsp), %rax
	vunpcklpd	%xmm0, %xmm2, %xmm0
	vmovapd	576(%rsp), %xmm2
	vunpcklpd	640(%rsp), %xmm2, %xmm2
	vinsertf128	$1, %xmm0, %ymm2, %ymm0
	vmovapd	864(%rsp), %xmm2
	vunpcklpd	512(%rsp), %xmm2, %xmm3
	vmovapd	928(%rsp), %xmm2
	vunpcklpd	800(%rsp), %xmm2, %xmm2
	vinsertf128	$1, %xmm3, %ymm2, %ymm2
	vinsertf64x4	$1, %ymm0, %zmm2, %zmm0
	vmovupd	%zmm0, 8(%rax,%rbp,8)
	addq	$8, %rbp
	cmpq	%rbp, 152(%rsp)
	jne	.LBB0_38
	vmovapd	96(%rsp), %xmm9
	vmovapd	80(%rsp), %xmm10
	vmovapd	64(%rsp), %xmm11
	vmovapd	48(%rsp), %xmm12
	vmovapd	304(%rsp), %xmm13
	vmovapd	288(%rsp), %xmm5
	vmovapd	272(%rsp), %xmm14
	vmovapd	256(%rsp), %xmm4
	vmovapd	240(%rsp), %xmm15
	vmovapd	224(%rsp), %xmm3
	vmovapd	128(%rsp), %xmm16
	vmovapd	112(%rsp), %xmm17
	vmovapd	208(%rsp), %xmm8
	vmovapd	192(%rsp), %xmm18
	vmovapd	176(%rsp), %xmm19
	vmovapd	160(%rsp), %xmm7
	vmovapd	1056(%rsp), %xmm20
	vmovapd	992(%rsp), %xmm21
	movq	8(%rsp), %rax
	movq	2544(%rsp), %r10
	movq	480(%rsp), %rcx
	movq	%rax, %rdx
	cmpq	152(%rsp), %rax
	je	.LBB0_3
.LBB0_40:
	movq	2896(%rsp), %rdi
	movq	2824(%rsp), %rax
	leaq	(%r10,%rcx,8), %rsi
	subq	%rcx, %rdx
	movabsq	$pow, %r12
	xorl	%r14d, %r14d
	incq	%rdx
	movq	%rsi, 704(%rsp)
	movq	2712(%rsp), %rsi
	movq	%rdx, 8(%rsp)
	movq	2768(%rsp), %rdx
	leaq	(%rdi,%rcx,8), %r15
	movq	2488(%rsp), %rdi
	leaq	(%rax,%rcx,8), %rbp
	leaq	(%rdi,%rcx,8), %rax
	movq	%rax, 640(%rsp)
	leaq	(%rsi,%rcx,8), %rax
	movq	%rax, 576(%rsp)
	leaq	(%rdx,%rcx,8), %rax
	movq	%rax, 512(%rsp)
	.p2align	4
.LBB0_41:
	movq	2840(%rsp), %rcx
	leaq	(%rbp,%r14,8), %rax
	vmovapd	1120(%rsp), %xmm6
	leaq	(%r15,%r14,8), %rsi
	movq	704(%rsp), %rdx
	vmulsd	(%rax,%rcx,8), %xmm5, %xmm0
	leaq	(%rax,%rcx,8), %rax
	movq	2912(%rsp), %rcx
	vmulsd	(%r13,%rax), %xmm4, %xmm22
	addq	%r13, %rax
	vmulsd	(%r13,%rax), %xmm3, %xmm2
	leaq	(%rax,%r13), %rax
	vmulsd	(%r13,%rax), %xmm17, %xmm3
	leaq	(%rax,%r13), %rax
	vmulsd	(%r13,%rax), %xmm18, %xmm4
	leaq	(%rax,%r13), %rax
	vfmadd231sd	(%rsi,%rcx,8), %xmm13, %xmm0
	vmulsd	(%r13,%rax), %xmm7, %xmm5
	leaq	(%rax,%r13), %rax
	vmulsd	(%r13,%rax), %xmm6, %xmm6
	leaq	(%rax,%r13), %rax
	vmulsd	(%r13,%rax), %xmm21, %xmm7
	leaq	(%rsi,%rcx,8), %rax
	movq	640(%rsp), %rcx
	vfmadd231sd	(%rbx,%rax), %xmm14, %xmm22
	leaq	(%rax,%rbx), %rax
	vfmadd231sd	(%rbx,%rax), %xmm15, %xmm2
	leaq	(%rax,%rbx), %rax
	vfmadd231sd	(%rbx,%rax), %xmm16, %xmm3
	leaq	(%rax,%rbx), %rax
	vfmadd231sd	(%rbx,%rax), %xmm8, %xmm4
	leaq	(%rax,%rbx), %rax
	vmovsd	(%rdx,%r14,8), %xmm8
	vfmadd231sd	(%rbx,%rax), %xmm19, %xmm5
	leaq	(%rax,%rbx), %rax
	vfmadd213sd	(%rcx,%r14,8), %xmm10, %xmm8
	vfmadd231sd	(%rbx,%rax), %xmm20, %xmm6
	leaq	(%rax,%rbx), %rax
	vfmadd231sd	(%rbx,%rax), %xmm9, %xmm7
	vmulsd	(%rbp,%r14,8), %xmm12, %xmm9
	vfmadd231sd	(%r15,%r14,8), %xmm11, %xmm9
	vaddsd	%xmm9, %xmm8, %xmm8
	vaddsd	%xmm0, %xmm8, %xmm0
	vaddsd	%xmm22, %xmm0, %xmm0
	vaddsd	%xmm2, %xmm0, %xmm0
	vxorpd	%xmm2, %xmm2, %xmm2
	vaddsd	%xmm3, %xmm0, %xmm0
	vaddsd	%xmm4, %xmm0, %xmm0
	vaddsd	%xmm5, %xmm0, %xmm0
	vaddsd	%xmm6, %xmm0, %xmm0
	vaddsd	%xmm7, %xmm0, %xmm0
	vmaxsd	%xmm0, %xmm2, %xmm0
	vmovsd	%xmm0, 16(%rsp)
	vzeroupper
	callq	*%r12
	movq	576(%rsp), %rax
	vmovsd	32(%rsp), %xmm1
	vmovsd	%xmm0, (%rax,%r14,8)
	vmovsd	16(%rsp), %xmm0
	callq	*%r12
	vmovsd	(%rsp), %xmm1
	vmovapd	992(%rsp), %xmm21
	vmovapd	1056(%rsp), %xmm20
	vmovapd	160(%rsp), %xmm7
	vmovapd	176(%rsp), %xmm19
	vmovapd	192(%rsp), %xmm18
	vmovapd	208(%rsp), %xmm8
	vmovapd	112(%rsp), %xmm17
	vmovapd	128(%rsp), %xmm16
	vmovapd	224(%rsp), %xmm3
	vmovapd	240(%rsp), %xmm15
	vmovapd	256(%rsp), %xmm4
	vmovapd	272(%rsp), %xmm14
	vmovapd	288(%rsp), %xmm5
	vmovapd	304(%rsp), %xmm13
	vmovapd	48(%rsp), %xmm12
	vmovapd	64(%rsp), %xmm11
	vmovapd	80(%rsp), %xmm10
	vmovapd	96(%rsp), %xmm9
	movq	512(%rsp), %rax
	vmovsd	%xmm0, (%rax,%r14,8)
	incq	%r14
	cmpq	%r14, 8(%rsp)
	jne	.LBB0_41
.LBB0_3:
	movq	2792(%rsp), %rbp
	movabsq	$NRT_incref, %rax
	movq	%rbp, %rdi
	vzeroupper
	callq	*%rax
	movq	2840(%rsp), %r10
	movq	2824(%rsp), %rcx
	leaq	(%r10,%r10,8), %rax
	leaq	(%rcx,%rax,8), %rax
	subq	$8, %rsp
	.cfi_adjust_cfa_offset 8
	movq	2688(%rsp), %r15
	movq	2696(%rsp), %rcx
	movq	2704(%rsp), %r8
	movq	2712(%rsp), %r9
	movabsq	$_ZN15granular_fronts5chain6strain9laplacianB2v4B68c8tJTIeFIjxB2IKSgI4CrvQClYb5wBbdC9Xqyfl5JUWJySXqtZrAkCyC6NAEAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE23Size_28int64_20x_202_29x, %r14
	leaq	800(%rsp), %rdi
	leaq	792(%rsp), %rsi
	movq	%r15, %rdx
	pushq	3064(%rsp)
	.cfi_adjust_cfa_offset 8
	pushq	360(%rsp)
	.cfi_adjust_cfa_offset 8
	pushq	376(%rsp)
	.cfi_adjust_cfa_offset 8
	pushq	2888(%rsp)
	.cfi_adjust_cfa_offset 8
	pushq	%r10
	.cfi_adjust_cfa_offset 8
	pushq	%rax
	.cfi_adjust_cfa_offset 8
	pushq	2872(%rsp)
	.cfi_adjust_cfa_offset 8
	pushq	%r10
	.cfi_adjust_cfa_offset 8
	pushq	2872(%rsp)
	.cfi_adjust_cfa_offset 8
	pushq	%rbp
	.cfi_adjust_cfa_offset 8
	pushq	2816(%rsp)
	.cfi_adjust_cfa_offset 8
	pushq	2816(%rsp)
	.cfi_adjust_cfa_offset 8
	pushq	2816(%rsp)
	.cfi_adjust_cfa_offset 8
	callq	*%r14
	addq	$112, %rsp
	.cfi_adjust_cfa_offset -112
	cmpl	$-2, %eax
	je	.LBB0_5
	movl	%eax, %r13d
	testl	%eax, %eax
	jne	.LBB0_9
.LBB0_5:
	movabsq	$NRT_decref, %rbx
	movq	%r15, %rdi
	callq	*%rbx
	movq	%rbp, %rdi
	callq	*%rbx
	cmpq	$2, 360(%rsp)
	jne	.LBB0_42
	movq	2912(%rsp), %r10
	movq	2896(%rsp), %rdx
	movq	2760(%rsp), %r9
	movq	2752(%rsp), %r8
	movq	2744(%rsp), %rcx
	leaq	(%r10,%r10,8), %rax
	leaq	(%rdx,%rax,8), %rax
	subq	$8, %rsp
	.cfi_adjust_cfa_offset 8
	movq	2744(%rsp), %r12
	leaq	784(%rsp), %rdi
	leaq	776(%rsp), %rsi
	movq	%r12, %rdx
	pushq	3064(%rsp)
	.cfi_adjust_cfa_offset 8
	pushq	360(%rsp)
	.cfi_adjust_cfa_offset 8
	pushq	376(%rsp)
	.cfi_adjust_cfa_offset 8
	pushq	2960(%rsp)
	.cfi_adjust_cfa_offset 8
	pushq	%r10
	.cfi_adjust_cfa_offset 8
	pushq	%rax
	.cfi_adjust_cfa_offset 8
	pushq	2944(%rsp)
	.cfi_adjust_cfa_offset 8
	pushq	%r10
	.cfi_adjust_cfa_offset 8
	pushq	2944(%rsp)
	.cfi_adjust_cfa_offset 8
	movq	2944(%rsp), %r15
	pushq	%r15
	.cfi_adjust_cfa_offset 8
	pushq	2872(%rsp)
	.cfi_adjust_cfa_offset 8
	pushq	2872(%rsp)
	.cfi_adjust_cfa_offset 8
	pushq	2872(%rsp)
	.cfi_adjust_cfa_offset 8
	callq	*%r14
	addq	$112, %rsp
	.cfi_adjust_cfa_offset -112
	movq	336(%rsp), %rdi
	movl	%eax, %r13d
	callq	*%rbx
	movq	2512(%rsp), %rdi
	callq	*%rbx
	movq	2568(%rsp), %rdi
	callq	*%rbx
	movq	2624(%rsp), %rdi
	callq	*%rbx
	movq	2680(%rsp), %rdi
	callq	*%rbx
	movq	%r12, %rdi
	callq	*%rbx
	movq	%rbp, %rdi
	callq	*%rbx
	movq	%r12, %rdi
	testl	%r13d, %r13d
	je	.LBB0_7
	cmpl	$-2, %r13d
	je	.LBB0_7
.LBB0_9:
	movq	328(%rsp), %rax
	jmp	.LBB0_10
.LBB0_42:
	movq	336(%rsp), %rdi
	callq	*%rbx
	movq	2512(%rsp), %rdi
	callq	*%rbx
	movq	2568(%rsp), %rdi
	callq	*%rbx
	movq	2624(%rsp), %rdi
	callq	*%rbx
	movq	%r15, %rdi
	callq	*%rbx
	movq	2736(%rsp), %r15
	movq	%r15, %rdi
	callq	*%rbx
	movq	%rbp, %rdi
	callq	*%rbx
	movq	2864(%rsp), %rdi
.LBB0_7:
	callq	*%rbx
	movq	%r15, %rdi
	callq	*%rbx
	movq	504(%rsp), %rax
	xorl	%r13d, %r13d
.LBB0_10:
	movq	$0, (%rax)
	movl	%r13d, %eax
	addq	$2408, %rsp
	.cfi_def_cfa_offset 56
	popq	%rbx
	.cfi_def_cfa_offset 48
	popq	%r12
	.cfi_def_cfa_offset 40
	popq	%r13
	.cfi_def_cfa_offset 32
	popq	%r14
	.cfi_def_cfa_offset 24
	popq	%r15
	.cfi_def_cfa_offset 16
	popq	%rbp
	.cfi_def_cfa_offset 8
	retq
.Lfunc_end0:
	.size	_ZN15granular_fronts5chain6strain5stageB2v3B68c8tJTIeFIjxB2IKSgI4CrvQClYb5wBbdC9Xqyfl5JUWJySXqtZrAkCyC6NAEAA_3d_3dE53Law_28int64_2c_20float64_2c_20float64_2c_20float64_2923Size_28int64_20x_202_29317State_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_298UniTupleIdLi9EE8UniTupleIdLi9EEddx, .Lfunc_end0-_ZN15granular_fronts5chain6strain5stageB2v3B68c8tJTIeFIjxB2IKSgI4CrvQClYb5wBbdC9Xqyfl5JUWJySXqtZrAkCyC6NAEAA_3d_3dE53Law_28int64_2c_20float64_2c_20float64_2c_20float64_2923Size_28int64_20x_202_29317State_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_298UniTupleIdLi9EE8UniTupleIdLi9EEddx
	.cfi_endproc

	.globl	_ZN7cpython15granular_fronts5chain6strain5stageB2v3B68c8tJTIeFIjxB2IKSgI4CrvQClYb5wBbdC9Xqyfl5JUWJySXqtZrAkCyC6NAEAA_3d_3dE53Law_28int64_2c_20float64_2c_20float64_2c_20float64_2923Size_28int64_20x_202_29317State_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_298UniTupleIdLi9EE8UniTupleIdLi9EEddx
	.p2align	4
	.type	_ZN7cpython15granular_fronts5chain6strain5stageB2v3B68c8tJTIeFIjxB2IKSgI4CrvQClYb5wBbdC9Xqyfl5JUWJySXqtZrAkCyC6NAEAA_3d_3dE53Law_28int64_2c_20float64_2c_20float64_2c_20float64_2923Size_28int64_20x_202_29317State_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_298UniTupleIdLi9EE8UniTupleIdLi9EEddx,@function
_ZN7cpython15granular_fronts5chain6strain5stageB2v3B68c8tJTIeFIjxB2IKSgI4CrvQClYb5wBbdC9Xqyfl5JUWJySXqtZrAkCyC6NAEAA_3d_3dE53Law_28int64_2c_20float64_2c_20float64_2c_20float64_2923Size_28int64_20x_202_29317State_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_298UniTupleIdLi9EE8UniTupleIdLi9EEddx:
	.cfi_startproc
	pushq	%rbp
	.cfi_def_cfa_offset 16
	pushq	%r15
	.cfi_def_cfa_offset 24
	pushq	%r14
	.cfi_def_cfa_offset 32
	pushq	%r13
	.cfi_def_cfa_offset 40
	pushq	%r12
	.cfi_def_cfa_offset 48
	pushq	%rbx
	.cfi_def_cfa_offset 56
	subq	$1080, %rsp
	.cfi_def_cfa_offset 1136
	.cfi_offset %rbx, -56
	.cfi_offset %r12, -48
	.cfi_offset %r13, -40
	.cfi_offset %r14, -32
	.cfi_offset %r15, -24
	.cfi_offset %rbp, -16
	leaq	480(%rsp), %r10
	movq	%rsi, %rdi
	xorl	%ebx, %ebx
	leaq	488(%rsp), %r11
	leaq	496(%rsp), %r14
	leaq	504(%rsp), %r15
	leaq	512(%rsp), %r12
	leaq	520(%rsp), %r13
	movabsq	$.const.stage, %rsi
	movabsq	$PyArg_UnpackTuple, %rbp
	leaq	536(%rsp), %r8
	leaq	528(%rsp), %r9
	movl	$8, %edx
	movl	$8, %ecx
	xorl	%eax, %eax
	pushq	%r10
	.cfi_adjust_cfa_offset 8
	pushq	%r11
	.cfi_adjust_cfa_offset 8
	pushq	%r14
	.cfi_adjust_cfa_offset 8
	pushq	%r15
	.cfi_adjust_cfa_offset 8
	pushq	%r12
	.cfi_adjust_cfa_offset 8
	pushq	%r13
	.cfi_adjust_cfa_offset 8
	callq	*%rbp
	addq	$48, %rsp
	.cfi_adjust_cfa_offset -48
	vxorps	%xmm0, %xmm0, %xmm0
	vmovups	%ymm0, 896(%rsp)
	vmovups	%ymm0, 832(%rsp)
	vmovups	%ymm0, 1024(%rsp)
	vmovups	%ymm0, 960(%rsp)
	vmovups	%ymm0, 608(%rsp)
	vmovups	%ymm0, 544(%rsp)
	vmovups	%ymm0, 920(%rsp)
	vmovups	%ymm0, 856(%rsp)
	vmovups	%ymm0, 1048(%rsp)
	vmovups	%ymm0, 984(%rsp)
	vmovups	%ymm0, 632(%rsp)
	vmovups	%ymm0, 568(%rsp)
	vxorps	%xmm0, %xmm0, %xmm0
	vmovups	%zmm0, 752(%rsp)
	movq	$0, 816(%rsp)
	vmovups	%zmm0, 672(%rsp)
	movq	$0, 736(%rsp)
	movq	$0, 472(%rsp)
	movq	$0, 88(%rsp)
	testl	%eax, %eax
	je	.LBB1_114
	movabsq	$_ZN08NumbaEnv15granular_fronts5chain6strain5stageB2v3B68c8tJTIeFIjxB2IKSgI4CrvQClYb5wBbdC9Xqyfl5JUWJySXqtZrAkCyC6NAEAA_3d_3dE53Law_28int64_2c_20float64_2c_20float64_2c_20float64_2923Size_28int64_20x_202_29317State_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_298UniTupleIdLi9EE8UniTupleIdLi9EEddx, %rax
	cmpq	$0, (%rax)
	je	.LBB1_2
	movq	536(%rsp), %rbx
	movabsq	$PyTuple_Size, %rax
	movq	%rbx, %rdi
	vzeroupper
	callq	*%rax
	cmpq	$4, %rax
	setne	%bpl
	jne	.LBB1_5
.LBB1_6:
	movabsq	$PyTuple_GetItem, %r12
	xorl	%r15d, %r15d
	movq	%rbx, %rdi
	xorl	%esi, %esi
	callq	*%r12
	movabsq	$PyNumber_Long, %rcx
	movq	%rax, %rdi
	callq	*%rcx
	movq	%rax, %r14
	movabsq	$Py_DecRef, %r13
	movabsq	$PyLong_AsLongLong, %rax
	testq	%r14, %r14
	je	.LBB1_8
	movq	%r14, %rdi
	callq	*%rax
	movq	%r14, %rdi
	movq	%rax, %r15
	callq	*%r13
.LBB1_8:
	movq	%r15, 24(%rsp)
	movabsq	$PyErr_Occurred, %r15
	callq	*%r15
	testq	%rax, %rax
	jne	.LBB1_9
.LBB1_10:
	movl	$1, %esi
	movq	%rbx, %rdi
	movb	%bpl, 16(%rsp)
	callq	*%r12
	movabsq	$PyNumber_Float, %rbp
	movq	%rax, %rdi
	callq	*%rbp
	movq	%rax, %r14
	movabsq	$PyFloat_AsDouble, %rax
	movq	%r14, %rdi
	callq	*%rax
	movabsq	$Py_DecRef, %r13
	movq	%r14, %rdi
	vmovsd	%xmm0, 464(%rsp)
	callq	*%r13
	callq	*%r15
	testq	%rax, %rax
	jne	.LBB1_11
.LBB1_12:
	movl	$2, %esi
	movq	%rbx, %rdi
	callq	*%r12
	movq	%rax, %rdi
	callq	*%rbp
	movq	%rax, %r14
	movq	%rax, %rdi
	movabsq	$PyFloat_AsDouble, %rax
	callq	*%rax
	movq	%r14, %rdi
	vmovsd	%xmm0, 456(%rsp)
	callq	*%r13
	callq	*%r15
	testq	%rax, %rax
	jne	.LBB1_13
.LBB1_14:
	movl	$3, %esi
	movq	%rbx, %rdi
	callq	*%r12
	movq	%rax, %rdi
	callq	*%rbp
	movabsq	$PyFloat_AsDouble, %r14
	movq	%rax, %rdi
	movq	%rax, %rbx
	callq	*%r14
	movq	%rbx, %rdi
	vmovsd	%xmm0, 448(%rsp)
	callq	*%r13
	callq	*%r15
	xorl	%ebx, %ebx
	cmpb	$0, 16(%rsp)
	jne	.LBB1_114
	testq	%rax, %rax
	jne	.LBB1_114
	movq	528(%rsp), %rbx
	movabsq	$PyTuple_Size, %rax
	movq	%rbx, %rdi
	callq	*%rax
	cmpq	$2, %rax
	setne	%bpl
	jne	.LBB1_17
.LBB1_18:
	movabsq	$PyTuple_GetItem, %r12
	xorl	%r15d, %r15d
	movq	%rbx, %rdi
	xorl	%esi, %esi
	callq	*%r12
	movabsq	$PyNumber_Long, %r14
	movq	%rax, %rdi
	callq	*%r14
	movabsq	$PyLong_AsLongLong, %r13
	testq	%rax, %rax
	je	.LBB1_20
	movq	%rax, %rdi
	movq	%rax, %r14
	callq	*%r13
	movq	%r14, %rdi
	movabsq	$Py_DecRef, %r14
	movq	%rax, %r15
	callq	*%r14
.LBB1_20:
	movabsq	$PyErr_Occurred, %rax
	callq	*%rax
	testq	%rax, %rax
	jne	.LBB1_21
.LBB1_22:
	movl	$1, %esi
	movq	%rbx, %rdi
	callq	*%r12
	movabsq	$PyNumber_Long, %rbx
	movq	%rax, %rdi
	callq	*%rbx
	movabsq	$Py_DecRef, %r14
	testq	%rax, %rax
	je	.LBB1_23
	movq	%rax, %rdi
	movq	%rax, %rbx
	callq	*%r13
	movq	%rbx, %rdi
	movq	%rax, %r13
	callq	*%r14
.LBB1_25:
	movabsq	$PyErr_Occurred, %rax
	callq	*%rax
	testq	%rax, %rax
	setne	%al
	orb	%al, %bpl
	jne	.LBB1_113
	movq	%r13, 432(%rsp)
	movq	520(%rsp), %r13
	movabsq	$PyTuple_Size, %rax
	movq	%r15, 440(%rsp)
	movq	%r13, %rdi
	callq	*%rax
	cmpq	$8, %rax
	setne	%bpl
	jne	.LBB1_27
.LBB1_28:
	movq	%r13, %rdi
	xorl	%esi, %esi
	callq	*%r12
	movabsq	$NRT_adapt_ndarray_from_python, %r15
	leaq	896(%rsp), %rsi
	vxorps	%xmm0, %xmm0, %xmm0
	vmovups	%ymm0, 896(%rsp)
	movq	%rax, %rdi
	vmovups	%ymm0, 920(%rsp)
	vzeroupper
	callq	*%r15
	testl	%eax, %eax
	jne	.LBB1_30
	cmpq	$8, 920(%rsp)
	jne	.LBB1_30
.LBB1_31:
	movq	896(%rsp), %rax
	movq	928(%rsp), %rbx
	movl	$1, %esi
	movq	%r13, %rdi
	movq	%rax, 80(%rsp)
	callq	*%r12
	leaq	832(%rsp), %rsi
	vxorps	%xmm0, %xmm0, %xmm0
	vmovups	%ymm0, 832(%rsp)
	movq	%rax, %rdi
	vmovups	%ymm0, 856(%rsp)
	vzeroupper
	callq	*%r15
	testl	%eax, %eax
	jne	.LBB1_33
	cmpq	$8, 856(%rsp)
	jne	.LBB1_33
.LBB1_34:
	movq	832(%rsp), %rax
	movq	864(%rsp), %rcx
	movl	$2, %esi
	movq	%r13, %rdi
	movq	%rax, 72(%rsp)
	movq	%rcx, 424(%rsp)
	callq	*%r12
	leaq	1024(%rsp), %rsi
	vxorps	%xmm0, %xmm0, %xmm0
	vmovups	%ymm0, 1024(%rsp)
	movq	%rax, %rdi
	vmovups	%ymm0, 1048(%rsp)
	vzeroupper
	callq	*%r15
	testl	%eax, %eax
	jne	.LBB1_36
	cmpq	$8, 1048(%rsp)
	jne	.LBB1_36
.LBB1_37:
	movq	1024(%rsp), %rax
	movl	$3, %esi
	movq	%r13, %rdi
	movq	%rax, 64(%rsp)
	callq	*%r12
	leaq	960(%rsp), %rsi
	vxorps	%xmm0, %xmm0, %xmm0
	vmovups	%ymm0, 960(%rsp)
	movq	%rax, %rdi
	vmovups	%ymm0, 984(%rsp)
	vzeroupper
	callq	*%r15
	testl	%eax, %eax
	jne	.LBB1_39
	cmpq	$8, 984(%rsp)
	jne	.LBB1_39
.LBB1_40:
	movq	960(%rsp), %rax
	movl	$4, %esi
	movq	%r13, %rdi
	movq	%rax, 56(%rsp)
	callq	*%r12
	leaq	608(%rsp), %rsi
	vxorps	%xmm0, %xmm0, %xmm0
	vmovups	%ymm0, 608(%rsp)
	movq	%rax, %rdi
	vmovups	%ymm0, 632(%rsp)
	vzeroupper
	callq	*%r15
	movq	632(%rsp), %rcx
	movq	%rcx, 416(%rsp)
	testl	%eax, %eax
	jne	.LBB1_42
	cmpq	$8, %rcx
	jne	.LBB1_42
.LBB1_43:
	movq	616(%rsp), %rcx
	movq	624(%rsp), %rdx
	movq	608(%rsp), %rax
	movl	$5, %esi
	movq	%r13, %rdi
	movq	%rcx, 408(%rsp)
	movq	640(%rsp), %rcx
	movq	%rdx, 400(%rsp)
	movq	648(%rsp), %rdx
	movq	%rax, 48(%rsp)
	movq	%rcx, 392(%rsp)
	movq	656(%rsp), %rcx
	movq	%rdx, 384(%rsp)
	movq	%rcx, 376(%rsp)
	callq	*%r12
	leaq	544(%rsp), %rsi
	vxorps	%xmm0, %xmm0, %xmm0
	vmovups	%ymm0, 544(%rsp)
	movq	%rax, %rdi
	vmovups	%ymm0, 568(%rsp)
	vzeroupper
	callq	*%r15
	movq	568(%rsp), %rcx
	movq	%rcx, 368(%rsp)
	testl	%eax, %eax
	jne	.LBB1_45
	cmpq	$8, %rcx
	jne	.LBB1_45
.LBB1_46:
	movq	552(%rsp), %rcx
	movq	560(%rsp), %rdx
	movq	544(%rsp), %rax
	movl	$6, %esi
	movq	%r13, %rdi
	movq	%rcx, 360(%rsp)
	movq	576(%rsp), %rcx
	movq	%rdx, 352(%rsp)
	movq	584(%rsp), %rdx
	movq	%rax, 16(%rsp)
	movq	%rcx, 344(%rsp)
	movq	592(%rsp), %rcx
	movq	%rdx, 336(%rsp)
	movq	%rcx, 328(%rsp)
	callq	*%r12
	leaq	752(%rsp), %rsi
	vxorps	%xmm0, %xmm0, %xmm0
	movq	%rax, %rdi
	vmovups	%zmm0, 752(%rsp)
	movq	$0, 816(%rsp)
	vzeroupper
	callq	*%r15
	movq	776(%rsp), %rcx
	cmpq	$8, %rcx
	movq	%rcx, 320(%rsp)
	setne	%cl
	testl	%eax, %eax
	setne	%r14b
	orb	%cl, %r14b
	cmpb	$1, %r14b
	je	.LBB1_47
	testb	%r14b, %r14b
	jne	.LBB1_49
.LBB1_50:
	movq	760(%rsp), %rdx
	movq	784(%rsp), %rcx
	movq	752(%rsp), %rax
	movl	$7, %esi
	movq	%r13, %rdi
	movq	%rdx, 312(%rsp)
	movq	%rcx, 304(%rsp)
	movq	800(%rsp), %rdx
	movq	816(%rsp), %rcx
	movq	%rax, 40(%rsp)
	movq	%rdx, 296(%rsp)
	movq	%rcx, 288(%rsp)
	callq	*%r12
	leaq	672(%rsp), %rsi
	vxorps	%xmm0, %xmm0, %xmm0
	movq	%rax, %rdi
	vmovups	%zmm0, 672(%rsp)
	movq	$0, 736(%rsp)
	vzeroupper
	callq	*%r15
	cmpq	$8, 696(%rsp)
	setne	%cl
	testl	%eax, %eax
	setne	%r15b
	orb	%cl, %r15b
	cmpb	$1, %r15b
	je	.LBB1_51
	orb	%r15b, %bpl
	jne	.LBB1_113
.LBB1_53:
	movq	680(%rsp), %rdx
	movq	704(%rsp), %rcx
	movq	672(%rsp), %rax
	movq	512(%rsp), %rbp
	movq	%rbx, 280(%rsp)
	movq	%rdx, 264(%rsp)
	movq	%rcx, 256(%rsp)
	movq	720(%rsp), %rdx
	movq	736(%rsp), %rcx
	movq	%rax, 32(%rsp)
	movabsq	$PyTuple_Size, %rax
	movq	%rbp, %rdi
	movq	%rdx, 248(%rsp)
	movq	%rcx, 240(%rsp)
	callq	*%rax
	cmpq	$9, %rax
	setne	8(%rsp)
	jne	.LBB1_54
.LBB1_55:
	movq	%rbp, %rdi
	xorl	%esi, %esi
	callq	*%r12
	movabsq	$PyNumber_Float, %r13
	movq	%rax, %rdi
	callq	*%r13
	movabsq	$PyFloat_AsDouble, %r12
	movq	%rax, %rdi
	movq	%rax, %r15
	callq	*%r12
	movabsq	$Py_DecRef, %r14
	movq	%r15, %rdi
	vmovsd	%xmm0, 272(%rsp)
	callq	*%r14
	movabsq	$PyErr_Occurred, %rbx
	callq	*%rbx
	testq	%rax, %rax
	jne	.LBB1_56
.LBB1_57:
	movl	$1, %esi
	movabsq	$PyTuple_GetItem, %rax
	movq	%rbp, %rdi
	callq	*%rax
	movq	%rax, %rdi
	callq	*%r13
	movq	%rax, %rdi
	movq	%rax, %r15
	callq	*%r12
	movq	%r15, %rdi
	vmovsd	%xmm0, 232(%rsp)
	callq	*%r14
	callq	*%rbx
	testq	%rax, %rax
	jne	.LBB1_58
.LBB1_59:
	movl	$2, %esi
	movabsq	$PyTuple_GetItem, %rax
	movq	%rbp, %rdi
	callq	*%rax
	movq	%rax, %rdi
	callq	*%r13
	movq	%rax, %rdi
	movq	%rax, %r15
	callq	*%r12
	movq	%r15, %rdi
	vmovsd	%xmm0, 224(%rsp)
	callq	*%r14
	callq	*%rbx
	testq	%rax, %rax
	jne	.LBB1_60
.LBB1_61:
	movl	$3, %esi
	movabsq	$PyTuple_GetItem, %rax
	movq	%rbp, %rdi
	callq	*%rax
	movq	%rax, %rdi
	callq	*%r13
	movq	%rax, %rdi
	movq	%rax, %r15
	callq	*%r12
	movq	%r15, %rdi
	vmovsd	%xmm0, 216(%rsp)
	callq	*%r14
	callq	*%rbx
	testq	%rax, %rax
	jne	.LBB1_62
.LBB1_63:
	movl	$4, %esi
	movabsq	$PyTuple_GetItem, %rax
	movq	%rbp, %rdi
	callq	*%rax
	movq	%rax, %rdi
	callq	*%r13
	movq	%rax, %rdi
	movq	%rax, %r15
	callq	*%r12
	movq	%r15, %rdi
	vmovsd	%xmm0, 208(%rsp)
	callq	*%r14
	callq	*%rbx
	testq	%rax, %rax
	jne	.LBB1_64
.LBB1_65:
	movl	$5, %esi
	movabsq	$PyTuple_GetItem, %rax
	movq	%rbp, %rdi
	callq	*%rax
	movq	%rax, %rdi
	callq	*%r13
	movq	%rax, %rdi
	movq	%rax, %r15
	callq	*%r12
	movq	%r15, %rdi
	vmovsd	%xmm0, 200(%rsp)
	callq	*%r14
	callq	*%rbx
	testq	%rax, %rax
	jne	.LBB1_66
.LBB1_67:
	movl	$6, %esi
	movabsq	$PyTuple_GetItem, %rax
	movq	%rbp, %rdi
	callq	*%rax
	movq	%rax, %rdi
	callq	*%r13
	movq	%rax, %rdi
	movq	%rax, %r15
	callq	*%r12
	movq	%r15, %rdi
	vmovsd	%xmm0, 192(%rsp)
	callq	*%r14
	callq	*%rbx
	testq	%rax, %rax
	jne	.LBB1_68
.LBB1_69:
	movl	$7, %esi
	movabsq	$PyTuple_GetItem, %rax
	movq	%rbp, %rdi
	callq	*%rax
	movq	%rax, %rdi
	callq	*%r13
	movq	%rax, %rdi
	movq	%rax, %r15
	callq	*%r12
	movq	%r15, %rdi
	vmovsd	%xmm0, 184(%rsp)
	callq	*%r14
	callq	*%rbx
	testq	%rax, %rax
	jne	.LBB1_70
.LBB1_71:
	movl	$8, %esi
	movabsq	$PyTuple_GetItem, %rax
	movq	%rbp, %rdi
	callq	*%rax
	movq	%rax, %rdi
	callq	*%r13
	movq	%rax, %rdi
	movq	%rax, %r15
	callq	*%r12
	movq	%r15, %rdi
	vmovsd	%xmm0, 176(%rsp)
	callq	*%r14
	callq	*%rbx
	testq	%rax, %rax
	jne	.LBB1_112
	cmpb	$0, 8(%rsp)
	jne	.LBB1_112
	movq	504(%rsp), %rbp
	movabsq	$PyTuple_Size, %rax
	movq	%rbp, %rdi
	callq	*%rax
	cmpq	$9, %rax
	setne	8(%rsp)
	jne	.LBB1_74
.LBB1_75:
	movabsq	$PyTuple_GetItem, %r14
	movq	%rbp, %rdi
	xorl	%esi, %esi
	callq	*%r14
	movabsq	$PyNumber_Float, %r13
	movq	%rax, %rdi
	callq	*%r13
	movabsq	$PyFloat_AsDouble, %r12
	movq	%rax, %rdi
	movq	%rax, %r15
	callq	*%r12
	movabsq	$Py_DecRef, %r14
	movq	%r15, %rdi
	vmovsd	%xmm0, 168(%rsp)
	callq	*%r14
	movabsq	$PyErr_Occurred, %rbx
	callq	*%rbx
	testq	%rax, %rax
	jne	.LBB1_76
.LBB1_77:
	movl	$1, %esi
	movabsq	$PyTuple_GetItem, %rax
	movq	%rbp, %rdi
	callq	*%rax
	movq	%rax, %rdi
	callq	*%r13
	movq	%rax, %rdi
	movq	%rax, %r15
	callq	*%r12
	movq	%r15, %rdi
	vmovsd	%xmm0, 160(%rsp)
	callq	*%r14
	callq	*%rbx
	testq	%rax, %rax
	jne	.LBB1_78
.LBB1_79:
	movl	$2, %esi
	movabsq	$PyTuple_GetItem, %rax
	movq	%rbp, %rdi
	callq	*%rax
	movq	%rax, %rdi
	callq	*%r13
	movq	%rax, %rdi
	movq	%rax, %r15
	callq	*%r12
	movq	%r15, %rdi
	vmovsd	%xmm0, 152(%rsp)
	callq	*%r14
	callq	*%rbx
	testq	%rax, %rax
	jne	.LBB1_80
.LBB1_81:
	movl	$3, %esi
	movabsq	$PyTuple_GetItem, %rax
	movq	%rbp, %rdi
	callq	*%rax
	movq	%rax, %rdi
	callq	*%r13
	movq	%rax, %rdi
	movq	%rax, %r15
	callq	*%r12
	movq	%r15, %rdi
	vmovsd	%xmm0, 144(%rsp)
	callq	*%r14
	callq	*%rbx
	testq	%rax, %rax
	jne	.LBB1_82
.LBB1_83:
	movl	$4, %esi
	movabsq	$PyTuple_GetItem, %rax
	movq	%rbp, %rdi
	callq	*%rax
	movq	%rax, %rdi
	callq	*%r13
	movq	%rax, %rdi
	movq	%rax, %r15
	callq	*%r12
	movq	%r15, %rdi
	vmovsd	%xmm0, 136(%rsp)
	callq	*%r14
	callq	*%rbx
	testq	%rax, %rax
	jne	.LBB1_84
.LBB1_85:
	movl	$5, %esi
	movabsq	$PyTuple_GetItem, %rax
	movq	%rbp, %rdi
	callq	*%rax
	movq	%rax, %rdi
	callq	*%r13
	movq	%rax, %rdi
	movq	%rax, %r15
	callq	*%r12
	movq	%r15, %rdi
	vmovsd	%xmm0, 128(%rsp)
	callq	*%r14
	callq	*%rbx
	testq	%rax, %rax
	jne	.LBB1_86
.LBB1_87:
	movl	$6, %esi
	movabsq	$PyTuple_GetItem, %rax
	movq	%rbp, %rdi
	callq	*%rax
	movq	%rax, %rdi
	callq	*%r13
	movq	%rax, %rdi
	movq	%rax, %r15
	callq	*%r12
	movq	%r15, %rdi
	vmovsd	%xmm0, 120(%rsp)
	callq	*%r14
	callq	*%rbx
	testq	%rax, %rax
	jne	.LBB1_88
.LBB1_89:
	movl	$7, %esi
	movabsq	$PyTuple_GetItem, %rax
	movq	%rbp, %rdi
	callq	*%rax
	movq	%rax, %rdi
	callq	*%r13
	movq	%rax, %rdi
	movq	%rax, %r15
	callq	*%r12
	movq	%r15, %rdi
	vmovsd	%xmm0, 112(%rsp)
	callq	*%r14
	callq	*%rbx
	testq	%rax, %rax
	jne	.LBB1_90
.LBB1_91:
	movl	$8, %esi
	movabsq	$PyTuple_GetItem, %rax
	movq	%rbp, %rdi
	callq	*%rax
	movq	%rax, %rdi
	callq	*%r13
	movq	%rax, %rdi
	movq	%rax, %r15
	callq	*%r12
	movq	%r15, %rdi
	vmovsd	%xmm0, 104(%rsp)
	callq	*%r14
	callq	*%rbx
	testq	%rax, %rax
	jne	.LBB1_112
	cmpb	$0, 8(%rsp)
	jne	.LBB1_112
	movq	496(%rsp), %rdi
	callq	*%r13
	movq	%rax, %rdi
	movq	%rax, %r15
	callq	*%r12
	movq	%r15, %rdi
	vmovsd	%xmm0, 8(%rsp)
	callq	*%r14
	callq	*%rbx
	testq	%rax, %rax
	jne	.LBB1_112
	movq	488(%rsp), %rdi
	callq	*%r13
	movq	%rax, %rdi
	movq	%rax, %r15
	callq	*%r12
	movq	%r15, %rdi
	vmovsd	%xmm0, 96(%rsp)
	callq	*%r14
	callq	*%rbx
	testq	%rax, %rax
	jne	.LBB1_112
	movq	480(%rsp), %rdi
	movabsq	$PyNumber_Long, %rax
	callq	*%rax
	testq	%rax, %rax
	je	.LBB1_96
	movabsq	$PyLong_AsLongLong, %rbx
	movq	%rax, %rdi
	movq	%rax, %rbp
	callq	*%rbx
	movq	%rbp, %rdi
	movq	%rax, %r15
	callq	*%r14
	movabsq	$PyErr_Occurred, %rax
	callq	*%rax
	testq	%rax, %rax
	jne	.LBB1_112
.LBB1_99:
	subq	$608, %rsp
	.cfi_adjust_cfa_offset 608
	vmovsd	704(%rsp), %xmm0
	movq	856(%rsp), %rcx
	movq	864(%rsp), %rdx
	vmovsd	1064(%rsp), %xmm1
	vmovsd	1056(%rsp), %xmm2
	vmovsd	880(%rsp), %xmm3
	vmovsd	840(%rsp), %xmm4
	vmovsd	832(%rsp), %xmm5
	vmovsd	824(%rsp), %xmm6
	vmovsd	816(%rsp), %xmm7
	movq	848(%rsp), %rax
	movq	%r15, 592(%rsp)
	movq	656(%rsp), %r15
	movq	664(%rsp), %rbp
	movq	672(%rsp), %r13
	movq	680(%rsp), %r12
	movq	688(%rsp), %r14
	movq	1040(%rsp), %r8
	leaq	1080(%rsp), %rdi
	leaq	696(%rsp), %rsi
	movq	$8, 424(%rsp)
	movq	%rcx, 448(%rsp)
	movq	872(%rsp), %rcx
	movq	%rdx, 432(%rsp)
	movq	896(%rsp), %rdx
	movq	%rax, 464(%rsp)
	movabsq	$_ZN15granular_fronts5chain6strain5stageB2v3B68c8tJTIeFIjxB2IKSgI4CrvQClYb5wBbdC9Xqyfl5JUWJySXqtZrAkCyC6NAEAA_3d_3dE53Law_28int64_2c_20float64_2c_20float64_2c_20float64_2923Size_28int64_20x_202_29317State_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_298UniTupleIdLi9EE8UniTupleIdLi9EEddx, %rax
	movq	%r15, 216(%rsp)
	movq	%rbp, 160(%rsp)
	movq	%r13, 104(%rsp)
	movq	%r12, 48(%rsp)
	movq	%r14, %r9
	vmovsd	%xmm0, 584(%rsp)
	vmovsd	616(%rsp), %xmm0
	movq	%rcx, 408(%rsp)
	movq	904(%rsp), %rcx
	movq	%rdx, 392(%rsp)
	movq	912(%rsp), %rdx
	movq	%rcx, 376(%rsp)
	movq	928(%rsp), %rcx
	movq	%rdx, 360(%rsp)
	movq	920(%rsp), %rdx
	vmovsd	%xmm0, 576(%rsp)
	vmovsd	712(%rsp), %xmm0
	movq	%rcx, 352(%rsp)
	movq	936(%rsp), %rcx
	movq	%rdx, 336(%rsp)
	movq	944(%rsp), %rdx
	vmovsd	%xmm0, 568(%rsp)
	vmovsd	720(%rsp), %xmm0
	movq	%rcx, 320(%rsp)
	movq	952(%rsp), %rcx
	movq	%rdx, 312(%rsp)
	movq	976(%rsp), %rdx
	movq	%rcx, 304(%rsp)
	movq	960(%rsp), %rcx
	movq	%rdx, 296(%rsp)
	movq	968(%rsp), %rdx
	vmovsd	%xmm0, 560(%rsp)
	vmovsd	728(%rsp), %xmm0
	movq	%rcx, 288(%rsp)
	movq	984(%rsp), %rcx
	movq	%rdx, 280(%rsp)
	movq	992(%rsp), %rdx
	vmovsd	%xmm0, 552(%rsp)
	vmovsd	736(%rsp), %xmm0
	movq	%rcx, 264(%rsp)
	movq	1000(%rsp), %rcx
	movq	%rdx, 256(%rsp)
	movq	1024(%rsp), %rdx
	movq	%rcx, 248(%rsp)
	movq	1008(%rsp), %rcx
	movq	%rdx, 240(%rsp)
	movq	640(%rsp), %rdx
	vmovsd	%xmm0, 544(%rsp)
	vmovsd	744(%rsp), %xmm0
	movq	%rcx, 232(%rsp)
	movq	648(%rsp), %rcx
	movq	%rdx, 400(%rsp)
	movq	624(%rsp), %rdx
	movq	%rcx, 328(%rsp)
	movq	1016(%rsp), %rcx
	movq	%rdx, 272(%rsp)
	movq	1032(%rsp), %rdx
	vmovsd	%xmm0, 536(%rsp)
	vmovsd	752(%rsp), %xmm0
	movq	%rcx, 224(%rsp)
	movq	888(%rsp), %rcx
	movq	%rdx, 80(%rsp)
	movq	632(%rsp), %rdx
	vmovsd	%xmm0, 528(%rsp)
	vmovsd	760(%rsp), %xmm0
	movq	%rcx, 24(%rsp)
	movq	1048(%rsp), %rcx
	vmovsd	%xmm0, 520(%rsp)
	vmovsd	768(%rsp), %xmm0
	vmovsd	%xmm0, 512(%rsp)
	vmovsd	776(%rsp), %xmm0
	vmovsd	%xmm0, 504(%rsp)
	vmovsd	784(%rsp), %xmm0
	vmovsd	%xmm0, 496(%rsp)
	vmovsd	792(%rsp), %xmm0
	vmovsd	%xmm0, 488(%rsp)
	vmovsd	800(%rsp), %xmm0
	vmovsd	%xmm0, 480(%rsp)
	vmovsd	808(%rsp), %xmm0
	vmovsd	%xmm0, 472(%rsp)
	vmovsd	1072(%rsp), %xmm0
	callq	*%rax
	addq	$608, %rsp
	.cfi_adjust_cfa_offset -608
	movq	88(%rsp), %rcx
	movabsq	$NRT_decref, %rbx
	movq	%r14, %rdi
	movl	%eax, 8(%rsp)
	movq	%rcx, 24(%rsp)
	callq	*%rbx
	movq	%r12, %rdi
	callq	*%rbx
	movq	%r13, %rdi
	callq	*%rbx
	movq	%rbp, %rdi
	callq	*%rbx
	movq	%r15, %rdi
	callq	*%rbx
	movq	16(%rsp), %rdi
	callq	*%rbx
	movq	40(%rsp), %rdi
	callq	*%rbx
	movq	32(%rsp), %rdi
	callq	*%rbx
	movl	8(%rsp), %eax
	testl	%eax, %eax
	jne	.LBB1_100
	movabsq	$_Py_NoneStruct, %rbx
	movabsq	$Py_IncRef, %rax
	movq	%rbx, %rdi
	callq	*%rax
.LBB1_114:
	movq	%rbx, %rax
	addq	$1080, %rsp
	.cfi_def_cfa_offset 56
	popq	%rbx
	.cfi_def_cfa_offset 48
	popq	%r12
	.cfi_def_cfa_offset 40
	popq	%r13
	.cfi_def_cfa_offset 32
	popq	%r14
	.cfi_def_cfa_offset 24
	popq	%r15
	.cfi_def_cfa_offset 16
	popq	%rbp
	.cfi_def_cfa_offset 8
	vzeroupper
	retq
.LBB1_100:
	.cfi_def_cfa_offset 1136
	movq	24(%rsp), %r14
	jle	.LBB1_104
	movabsq	$PyErr_Clear, %rax
	callq	*%rax
	movl	8(%r14), %esi
	movq	(%r14), %rdi
	cmpl	$0, 32(%r14)
	jle	.LBB1_107
	movslq	%esi, %rsi
	movabsq	$PyBytes_FromStringAndSize, %rax
	callq	*%rax
	movq	16(%r14), %rdi
	movq	%rax, %rbx
	callq	*24(%r14)
	testq	%rax, %rax
	je	.LBB1_103
	movabsq	$numba_runtime_build_excinfo_struct, %rcx
	movq	%rbx, %rdi
	movq	%rax, %rsi
	callq	*%rcx
	movabsq	$NRT_Free, %r15
	movq	%r14, %rdi
	movq	%rax, %rbx
	callq	*%r15
	jmp	.LBB1_108
.LBB1_2:
	movabsq	$PyExc_RuntimeError, %rdi
	movabsq	$".const.missing Environment: _ZN08NumbaEnv15granular_fronts5chain6strain5stageB2v3B68c8tJTIeFIjxB2IKSgI4CrvQClYb5wBbdC9Xqyfl5JUWJySXqtZrAkCyC6NAEAA_3d_3dE53Law_28int64_2c_20float64_2c_20float64_2c_20float64_2923Size_28int64_20x_202_29317State_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_298UniTupleIdLi9EE8UniTupleIdLi9EEddx", %rsi
.LBB1_3:
	movabsq	$PyErr_SetString, %rax
	vzeroupper
	callq	*%rax
	jmp	.LBB1_113
.LBB1_5:
	movabsq	$PyExc_ValueError, %rdi
	movabsq	$".const.size mismatch for tuple, expected 4 element(s) but got %zd", %rsi
	movabsq	$PyErr_Format, %rcx
	movq	%rax, %rdx
	xorl	%eax, %eax
	callq	*%rcx
	jmp	.LBB1_6
.LBB1_9:
	movb	$1, %bpl
	jmp	.LBB1_10
.LBB1_11:
	movb	$1, 16(%rsp)
	jmp	.LBB1_12
.LBB1_13:
	movb	$1, 16(%rsp)
	jmp	.LBB1_14
.LBB1_17:
	movabsq	$PyExc_ValueError, %rdi
	movabsq	$".const.size mismatch for tuple, expected 2 element(s) but got %zd", %rsi
	movabsq	$PyErr_Format, %rcx
	movq	%rax, %rdx
	xorl	%eax, %eax
	callq	*%rcx
	jmp	.LBB1_18
.LBB1_21:
	movb	$1, %bpl
	jmp	.LBB1_22
.LBB1_23:
	xorl	%r13d, %r13d
	jmp	.LBB1_25
.LBB1_30:
	movabsq	$PyExc_TypeError, %rdi
	movabsq	$".const.can't unbox array from PyObject into native value.  The object maybe of a different type", %rsi
	movabsq	$PyErr_SetString, %rax
	callq	*%rax
	movb	$1, %bpl
	jmp	.LBB1_31
.LBB1_33:
	movabsq	$PyExc_TypeError, %rdi
	movabsq	$".const.can't unbox array from PyObject into native value.  The object maybe of a different type", %rsi
	movabsq	$PyErr_SetString, %rax
	callq	*%rax
	movb	$1, %bpl
	jmp	.LBB1_34
.LBB1_36:
	movabsq	$PyExc_TypeError, %rdi
	movabsq	$".const.can't unbox array from PyObject into native value.  The object maybe of a different type", %rsi
	movabsq	$PyErr_SetString, %rax
	callq	*%rax
	movb	$1, %bpl
	jmp	.LBB1_37
.LBB1_39:
	movabsq	$PyExc_TypeError, %rdi
	movabsq	$".const.can't unbox array from PyObject into native value.  The object maybe of a different type", %rsi
	movabsq	$PyErr_SetString, %rax
	callq	*%rax
	movb	$1, %bpl
	jmp	.LBB1_40
.LBB1_42:
	movabsq	$PyExc_TypeError, %rdi
	movabsq	$".const.can't unbox array from PyObject into native value.  The object maybe of a different type", %rsi
	movabsq	$PyErr_SetString, %rax
	callq	*%rax
	movb	$1, %bpl
	jmp	.LBB1_43
.LBB1_45:
	movabsq	$PyExc_TypeError, %rdi
	movabsq	$".const.can't unbox array from PyObject into native value.  The object maybe of a different type", %rsi
	movabsq	$PyErr_SetString, %rax
	callq	*%rax
	movb	$1, %bpl
	jmp	.LBB1_46
.LBB1_27:
	movabsq	$PyExc_ValueError, %rdi
	movabsq	$".const.size mismatch for tuple, expected 8 element(s) but got %zd", %rsi
	movabsq	$PyErr_Format, %rcx
	movq	%rax, %rdx
	xorl	%eax, %eax
	callq	*%rcx
	jmp	.LBB1_28
.LBB1_47:
	movabsq	$PyExc_TypeError, %rdi
	movabsq	$".const.can't unbox array from PyObject into native value.  The object maybe of a different type", %rsi
	movabsq	$PyErr_SetString, %rax
	callq	*%rax
	testb	%r14b, %r14b
	je	.LBB1_50
.LBB1_49:
	movb	$1, %bpl
	jmp	.LBB1_50
.LBB1_51:
	movabsq	$PyExc_TypeError, %rdi
	movabsq	$".const.can't unbox array from PyObject into native value.  The object maybe of a different type", %rsi
	movabsq	$PyErr_SetString, %rax
	callq	*%rax
	orb	%r15b, %bpl
	je	.LBB1_53
	jmp	.LBB1_113
.LBB1_54:
	movabsq	$PyExc_ValueError, %rdi
	movabsq	$".const.size mismatch for tuple, expected 9 element(s) but got %zd", %rsi
	movabsq	$PyErr_Format, %rcx
	movq	%rax, %rdx
	xorl	%eax, %eax
	callq	*%rcx
	jmp	.LBB1_55
.LBB1_56:
	movb	$1, 8(%rsp)
	jmp	.LBB1_57
.LBB1_58:
	movb	$1, 8(%rsp)
	jmp	.LBB1_59
.LBB1_60:
	movb	$1, 8(%rsp)
	jmp	.LBB1_61
.LBB1_62:
	movb	$1, 8(%rsp)
	jmp	.LBB1_63
.LBB1_64:
	movb	$1, 8(%rsp)
	jmp	.LBB1_65
.LBB1_66:
	movb	$1, 8(%rsp)
	jmp	.LBB1_67
.LBB1_68:
	movb	$1, 8(%rsp)
	jmp	.LBB1_69
.LBB1_70:
	movb	$1, 8(%rsp)
	jmp	.LBB1_71
.LBB1_74:
	movabsq	$PyExc_ValueError, %rdi
	movabsq	$".const.size mismatch for tuple, expected 9 element(s) but got %zd", %rsi
	movabsq	$PyErr_Format, %rcx
	movq	%rax, %rdx
	xorl	%eax, %eax
	callq	*%rcx
	jmp	.LBB1_75
.LBB1_76:
	movb	$1, 8(%rsp)
	jmp	.LBB1_77
.LBB1_78:
	movb	$1, 8(%rsp)
	jmp	.LBB1_79
.LBB1_80:
	movb	$1, 8(%rsp)
	jmp	.LBB1_81
.LBB1_82:
	movb	$1, 8(%rsp)
	jmp	.LBB1_83
.LBB1_84:
	movb	$1, 8(%rsp)
	jmp	.LBB1_85
.LBB1_86:
	movb	$1, 8(%rsp)
	jmp	.LBB1_87
.LBB1_88:
	movb	$1, 8(%rsp)
	jmp	.LBB1_89
.LBB1_90:
	movb	$1, 8(%rsp)
	jmp	.LBB1_91
.LBB1_96:
	xorl	%r15d, %r15d
	movabsq	$PyErr_Occurred, %rax
	callq	*%rax
	testq	%rax, %rax
	je	.LBB1_99
.LBB1_112:
	movq	80(%rsp), %rdi
	movabsq	$NRT_decref, %rbx
	callq	*%rbx
	movq	72(%rsp), %rdi
	callq	*%rbx
	movq	64(%rsp), %rdi
	callq	*%rbx
	movq	56(%rsp), %rdi
	callq	*%rbx
	movq	48(%rsp), %rdi
	callq	*%rbx
	movq	16(%rsp), %rdi
	callq	*%rbx
	movq	40(%rsp), %rdi
	callq	*%rbx
	movq	32(%rsp), %rdi
	callq	*%rbx
.LBB1_113:
	xorl	%ebx, %ebx
	jmp	.LBB1_114
.LBB1_104:
	cmpl	$-3, %eax
	je	.LBB1_111
	cmpl	$-1, %eax
	je	.LBB1_113
	movabsq	$PyExc_SystemError, %rdi
	movabsq	$".const.unknown error when calling native function", %rsi
	jmp	.LBB1_3
.LBB1_107:
	movq	16(%r14), %rdx
	movabsq	$numba_unpickle, %rax
	callq	*%rax
	movq	%rax, %rbx
.LBB1_108:
	testq	%rbx, %rbx
	je	.LBB1_113
	movabsq	$numba_do_raise, %rax
	movq	%rbx, %rdi
	callq	*%rax
	jmp	.LBB1_113
.LBB1_111:
	movabsq	$PyExc_StopIteration, %rdi
	movabsq	$PyErr_SetNone, %rax
	callq	*%rax
	jmp	.LBB1_113
.LBB1_103:
	movabsq	$PyExc_RuntimeError, %rdi
	movabsq	$".const.Error creating Python tuple from runtime exception arguments", %rsi
	jmp	.LBB1_3
.Lfunc_end1:
	.size	_ZN7cpython15granular_fronts5chain6strain5stageB2v3B68c8tJTIeFIjxB2IKSgI4CrvQClYb5wBbdC9Xqyfl5JUWJySXqtZrAkCyC6NAEAA_3d_3dE53Law_28int64_2c_20float64_2c_20float64_2c_20float64_2923Size_28int64_20x_202_29317State_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_298UniTupleIdLi9EE8UniTupleIdLi9EEddx, .Lfunc_end1-_ZN7cpython15granular_fronts5chain6strain5stageB2v3B68c8tJTIeFIjxB2IKSgI4CrvQClYb5wBbdC9Xqyfl5JUWJySXqtZrAkCyC6NAEAA_3d_3dE53Law_28int64_2c_20float64_2c_20float64_2c_20float64_2923Size_28int64_20x_202_29317State_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_298UniTupleIdLi9EE8UniTupleIdLi9EEddx
	.cfi_endproc

	.globl	cfunc._ZN15granular_fronts5chain6strain5stageB2v3B68c8tJTIeFIjxB2IKSgI4CrvQClYb5wBbdC9Xqyfl5JUWJySXqtZrAkCyC6NAEAA_3d_3dE53Law_28int64_2c_20float64_2c_20float64_2c_20float64_2923Size_28int64_20x_202_29317State_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_298UniTupleIdLi9EE8UniTupleIdLi9EEddx
	.p2align	4
	.type	cfunc._ZN15granular_fronts5chain6strain5stageB2v3B68c8tJTIeFIjxB2IKSgI4CrvQClYb5wBbdC9Xqyfl5JUWJySXqtZrAkCyC6NAEAA_3d_3dE53Law_28int64_2c_20float64_2c_20float64_2c_20float64_2923Size_28int64_20x_202_29317State_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_298UniTupleIdLi9EE8UniTupleIdLi9EEddx,@function
cfunc._ZN15granular_fronts5chain6strain5stageB2v3B68c8tJTIeFIjxB2IKSgI4CrvQClYb5wBbdC9Xqyfl5JUWJySXqtZrAkCyC6NAEAA_3d_3dE53Law_28int64_2c_20float64_2c_20float64_2c_20float64_2923Size_28int64_20x_202_29317State_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_298UniTupleIdLi9EE8UniTupleIdLi9EEddx:
	.cfi_startproc
	pushq	%rbp
	.cfi_def_cfa_offset 16
	pushq	%r15
	.cfi_def_cfa_offset 24
	pushq	%r14
	.cfi_def_cfa_offset 32
	pushq	%r13
	.cfi_def_cfa_offset 40
	pushq	%r12
	.cfi_def_cfa_offset 48
	pushq	%rbx
	.cfi_def_cfa_offset 56
	subq	$632, %rsp
	.cfi_def_cfa_offset 688
	.cfi_offset %rbx, -56
	.cfi_offset %r12, -48
	.cfi_offset %r13, -40
	.cfi_offset %r14, -32
	.cfi_offset %r15, -24
	.cfi_offset %rbp, -16
	vmovups	888(%rsp), %zmm8
	vmovups	952(%rsp), %zmm9
	vmovaps	1024(%rsp), %xmm10
	vmovups	1064(%rsp), %xmm11
	vmovups	1096(%rsp), %xmm12
	vmovups	1144(%rsp), %ymm13
	vmovups	1176(%rsp), %zmm14
	vmovsd	1240(%rsp), %xmm15
	vmovaps	1248(%rsp), %xmm16
	movq	%rcx, %r9
	movq	%rdx, %r8
	movq	%rsi, %rcx
	movq	%rdi, %rdx
	movq	1264(%rsp), %r13
	movq	696(%rsp), %rax
	movq	720(%rsp), %rsi
	movq	752(%rsp), %rdi
	movq	1048(%rsp), %rbx
	movq	1080(%rsp), %r14
	movq	1120(%rsp), %r15
	movq	1136(%rsp), %r12
	movq	776(%rsp), %r10
	movq	832(%rsp), %r11
	movq	$0, 624(%rsp)
	movq	$0, 616(%rsp)
	movq	%r13, 592(%rsp)
	vmovups	%xmm16, 576(%rsp)
	vmovsd	%xmm15, 568(%rsp)
	vmovups	%zmm14, 504(%rsp)
	vmovups	%ymm13, 472(%rsp)
	movq	%r12, 464(%rsp)
	movq	%r15, 448(%rsp)
	vmovups	%xmm12, 424(%rsp)
	movq	%r14, 408(%rsp)
	vmovups	%xmm11, 392(%rsp)
	movq	%rbx, 376(%rsp)
	vmovups	%xmm10, 352(%rsp)
	vmovups	%zmm9, 280(%rsp)
	vmovups	%zmm8, 216(%rsp)
	movq	%rdi, 80(%rsp)
	movq	%rsi, 48(%rsp)
	movq	%rax, 24(%rsp)
	movabsq	$_ZN15granular_fronts5chain6strain5stageB2v3B68c8tJTIeFIjxB2IKSgI4CrvQClYb5wBbdC9Xqyfl5JUWJySXqtZrAkCyC6NAEAA_3d_3dE53Law_28int64_2c_20float64_2c_20float64_2c_20float64_2923Size_28int64_20x_202_29317State_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_298UniTupleIdLi9EE8UniTupleIdLi9EEddx, %rax
	leaq	624(%rsp), %rdi
	leaq	616(%rsp), %rsi
	movq	%r11, 160(%rsp)
	movq	%r10, 104(%rsp)
	vzeroupper
	callq	*%rax
	movl	%eax, %ecx
	movq	616(%rsp), %rbx
	movq	624(%rsp), %rax
	movl	$0, 612(%rsp)
	testl	%ecx, %ecx
	jne	.LBB2_1
.LBB2_8:
	addq	$632, %rsp
	.cfi_def_cfa_offset 56
	popq	%rbx
	.cfi_def_cfa_offset 48
	popq	%r12
	.cfi_def_cfa_offset 40
	popq	%r13
	.cfi_def_cfa_offset 32
	popq	%r14
	.cfi_def_cfa_offset 24
	popq	%r15
	.cfi_def_cfa_offset 16
	popq	%rbp
	.cfi_def_cfa_offset 8
	retq
.LBB2_1:
	.cfi_def_cfa_offset 688
	movabsq	$numba_gil_ensure, %r14
	leaq	612(%rsp), %rdi
	movq	%rax, %r15
	movl	%ecx, %ebp
	callq	*%r14
	testl	%ebp, %ebp
	jle	.LBB2_9
	movabsq	$PyErr_Clear, %rax
	callq	*%rax
	movl	8(%rbx), %esi
	movq	(%rbx), %rdi
	cmpl	$0, 32(%rbx)
	jle	.LBB2_12
	movslq	%esi, %rsi
	movabsq	$PyBytes_FromStringAndSize, %rax
	callq	*%rax
	movq	16(%rbx), %rdi
	movq	%rax, %r14
	callq	*24(%rbx)
	testq	%rax, %rax
	je	.LBB2_4
	movabsq	$numba_runtime_build_excinfo_struct, %rcx
	movq	%r14, %rdi
	movq	%rax, %rsi
	callq	*%rcx
	movabsq	$NRT_Free, %r12
	movq	%rbx, %rdi
	movq	%rax, %r14
	callq	*%r12
	jmp	.LBB2_13
.LBB2_9:
	movl	%ebp, %eax
	cmpl	$-3, %ebp
	je	.LBB2_5
	cmpl	$-1, %eax
	je	.LBB2_7
	movabsq	$PyExc_SystemError, %rdi
	movabsq	$".const.unknown error when calling native function.2", %rsi
	movabsq	$PyErr_SetString, %rax
	callq	*%rax
	jmp	.LBB2_7
.LBB2_12:
	movq	16(%rbx), %rdx
	movabsq	$numba_unpickle, %rax
	callq	*%rax
	movq	%rax, %r14
.LBB2_13:
	testq	%r14, %r14
	je	.LBB2_7
	movabsq	$numba_do_raise, %rax
	movq	%r14, %rdi
.LBB2_6:
	callq	*%rax
.LBB2_7:
	movabsq	$".const.<numba.core.cpu.CPUContext>", %rdi
	movabsq	$PyUnicode_FromString, %rax
	callq	*%rax
	movabsq	$PyErr_WriteUnraisable, %r14
	movq	%rax, %rbx
	movq	%rbx, %rdi
	callq	*%r14
	movabsq	$Py_DecRef, %rax
	movq	%rbx, %rdi
	callq	*%rax
	movabsq	$numba_gil_release, %rax
	leaq	612(%rsp), %rdi
	callq	*%rax
	movq	%r15, %rax
	jmp	.LBB2_8
.LBB2_5:
	movabsq	$PyExc_StopIteration, %rdi
	movabsq	$PyErr_SetNone, %rax
	jmp	.LBB2_6
.LBB2_4:
	movabsq	$PyExc_RuntimeError, %rdi
	movabsq	$".const.Error creating Python tuple from runtime exception arguments.1", %rsi
	movabsq	$PyErr_SetString, %rax
	callq	*%rax
	xorl	%eax, %eax
	jmp	.LBB2_8
.Lfunc_end2:
	.size	cfunc._ZN15granular_fronts5chain6strain5stageB2v3B68c8tJTIeFIjxB2IKSgI4CrvQClYb5wBbdC9Xqyfl5JUWJySXqtZrAkCyC6NAEAA_3d_3dE53Law_28int64_2c_20float64_2c_20float64_2c_20float64_2923Size_28int64_20x_202_29317State_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_298UniTupleIdLi9EE8UniTupleIdLi9EEddx, .Lfunc_end2-cfunc._ZN15granular_fronts5chain6strain5stageB2v3B68c8tJTIeFIjxB2IKSgI4CrvQClYb5wBbdC9Xqyfl5JUWJySXqtZrAkCyC6NAEAA_3d_3dE53Law_28int64_2c_20float64_2c_20float64_2c_20float64_2923Size_28int64_20x_202_29317State_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_298UniTupleIdLi9EE8UniTupleIdLi9EEddx
	.cfi_endproc

	.weak	NRT_decref
	.p2align	4
	.type	NRT_decref,@function
NRT_decref:
	.cfi_startproc
	testq	%rdi, %rdi
	je	.LBB3_2
	#MEMBARRIER
	lock		decq	(%rdi)
	je	.LBB3_3
.LBB3_2:
	retq
.LBB3_3:
	movabsq	$NRT_MemInfo_call_dtor, %rax
	#MEMBARRIER
	jmpq	*%rax
.Lfunc_end3:
	.size	NRT_decref, .Lfunc_end3-NRT_decref
	.cfi_endproc

	.weak	NRT_incref
	.p2align	4
	.type	NRT_incref,@function
NRT_incref:
	testq	%rdi, %rdi
	je	.LBB4_2
	lock		incq	(%rdi)
.LBB4_2:
	retq
.Lfunc_end4:
	.size	NRT_incref, .Lfunc_end4-NRT_incref

	.section	.rodata.cst8,"aM",@progbits,8
	.p2align	3, 0x0
.LCPI5_0:
	.quad	0x4000000000000000
.LCPI5_1:
	.quad	0xc000000000000000
	.section	.ltext,"axl",@progbits
	.weak	_ZN15granular_fronts5chain6strain9laplacianB2v4B68c8tJTIeFIjxB2IKSgI4CrvQClYb5wBbdC9Xqyfl5JUWJySXqtZrAkCyC6NAEAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE23Size_28int64_20x_202_29x
	.p2align	4
	.type	_ZN15granular_fronts5chain6strain9laplacianB2v4B68c8tJTIeFIjxB2IKSgI4CrvQClYb5wBbdC9Xqyfl5JUWJySXqtZrAkCyC6NAEAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE23Size_28int64_20x_202_29x,@function
_ZN15granular_fronts5chain6strain9laplacianB2v4B68c8tJTIeFIjxB2IKSgI4CrvQClYb5wBbdC9Xqyfl5JUWJySXqtZrAkCyC6NAEAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE23Size_28int64_20x_202_29x:
	movq	104(%rsp), %rax
	movq	96(%rsp), %rdx
	movq	8(%rsp), %rcx
	cmpq	88(%rsp), %rdx
	jne	.LBB5_2
	movq	16(%rsp), %rsi
	movq	%rdx, %r8
	sarq	$63, %r8
	leaq	(%rcx,%rdx,8), %r9
	andq	%rsi, %r8
	vmovsd	(%r9,%r8,8), %xmm0
	xorl	%r8d, %r8d
	cmpq	$-1, %rdx
	cmovlq	%rsi, %r8
	vmovsd	%xmm0, (%rcx)
	vmovsd	8(%rcx), %xmm0
	vmovsd	%xmm0, 8(%r9,%r8,8)
.LBB5_2:
	testq	%rax, %rax
	jle	.LBB5_12
	movq	64(%rsp), %rdx
	movl	$1, %esi
	cmpq	$4, %rax
	jb	.LBB5_18
	leaq	16(%rcx,%rax,8), %r9
	leaq	8(%rdx), %r10
	leaq	8(%rdx,%rax,8), %r8
	cmpq	%r9, %r10
	setb	%r9b
	cmpq	%r8, %rcx
	setb	%r8b
	testb	%r8b, %r9b
	jne	.LBB5_18
	movabsq	$9223372036854775776, %r8
	cmpq	$32, %rax
	jae	.LBB5_13
	xorl	%esi, %esi
	jmp	.LBB5_7
.LBB5_13:
	movabsq	$.LCPI5_0, %r10
	movq	%rax, %rsi
	andq	%r8, %rsi
	xorl	%r9d, %r9d
	vbroadcastsd	(%r10), %zmm0
	.p2align	4
.LBB5_14:
	vmovupd	8(%rcx,%r9,8), %zmm1
	vmovupd	72(%rcx,%r9,8), %zmm2
	vmovupd	136(%rcx,%r9,8), %zmm3
	vmovupd	200(%rcx,%r9,8), %zmm4
	vfnmadd213pd	(%rcx,%r9,8), %zmm0, %zmm1
	vfnmadd213pd	64(%rcx,%r9,8), %zmm0, %zmm2
	vfnmadd213pd	128(%rcx,%r9,8), %zmm0, %zmm3
	vfnmadd213pd	192(%rcx,%r9,8), %zmm0, %zmm4
	vaddpd	16(%rcx,%r9,8), %zmm1, %zmm1
	vaddpd	80(%rcx,%r9,8), %zmm2, %zmm2
	vaddpd	144(%rcx,%r9,8), %zmm3, %zmm3
	vaddpd	208(%rcx,%r9,8), %zmm4, %zmm4
	vmovupd	%zmm1, 8(%rdx,%r9,8)
	vmovupd	%zmm2, 72(%rdx,%r9,8)
	vmovupd	%zmm3, 136(%rdx,%r9,8)
	vmovupd	%zmm4, 200(%rdx,%r9,8)
	addq	$32, %r9
	cmpq	%r9, %rsi
	jne	.LBB5_14
	cmpq	%rsi, %rax
	je	.LBB5_12
	testb	$28, %al
	je	.LBB5_17
.LBB5_7:
	movabsq	$.LCPI5_1, %r9
	addq	$28, %r8
	vbroadcastsd	(%r9), %ymm0
	andq	%rax, %r8
	.p2align	4
.LBB5_8:
	vmovupd	8(%rcx,%rsi,8), %ymm1
	vfmadd213pd	(%rcx,%rsi,8), %ymm0, %ymm1
	vaddpd	16(%rcx,%rsi,8), %ymm1, %ymm1
	vmovupd	%ymm1, 8(%rdx,%rsi,8)
	addq	$4, %rsi
	cmpq	%rsi, %r8
	jne	.LBB5_8
	cmpq	%r8, %rax
	je	.LBB5_12
	orq	$1, %r8
	movq	%r8, %rsi
.LBB5_18:
	movl	%eax, %r9d
	subl	%esi, %r9d
	movq	%rax, %r8
	subq	%rsi, %r8
	incl	%r9d
	andl	$7, %r9d
	je	.LBB5_21
	movabsq	$.LCPI5_1, %r10
	vmovsd	(%r10), %xmm0
	.p2align	4
.LBB5_20:
	vmovsd	(%rcx,%rsi,8), %xmm1
	decq	%r9
	vfmadd213sd	-8(%rcx,%rsi,8), %xmm0, %xmm1
	vaddsd	8(%rcx,%rsi,8), %xmm1, %xmm1
	vmovsd	%xmm1, (%rdx,%rsi,8)
	leaq	1(%rsi), %rsi
	jne	.LBB5_20
.LBB5_21:
	cmpq	$7, %r8
	jb	.LBB5_12
	movabsq	$.LCPI5_0, %r8
	leaq	56(%rdx,%rsi,8), %rdx
	subq	%rsi, %rax
	leaq	64(%rcx,%rsi,8), %rcx
	movq	$-1, %rsi
	vmovsd	(%r8), %xmm0
	.p2align	4
.LBB5_11:
	vmovsd	-56(%rcx,%rsi,8), %xmm1
	vfnmadd213sd	-64(%rcx,%rsi,8), %xmm0, %xmm1
	vaddsd	-48(%rcx,%rsi,8), %xmm1, %xmm1
	vmovsd	%xmm1, -48(%rdx,%rsi,8)
	vmovsd	-48(%rcx,%rsi,8), %xmm1
	vfnmadd213sd	-56(%rcx,%rsi,8), %xmm0, %xmm1
	vaddsd	-40(%rcx,%rsi,8), %xmm1, %xmm1
	vmovsd	%xmm1, -40(%rdx,%rsi,8)
	vmovsd	-40(%rcx,%rsi,8), %xmm1
	vfnmadd213sd	-48(%rcx,%rsi,8), %xmm0, %xmm1
	vaddsd	-32(%rcx,%rsi,8), %xmm1, %xmm1
	vmovsd	%xmm1, -32(%rdx,%rsi,8)
	vmovsd	-32(%rcx,%rsi,8), %xmm1
	vfnmadd213sd	-40(%rcx,%rsi,8), %xmm0, %xmm1
	vaddsd	-24(%rcx,%rsi,8), %xmm1, %xmm1
	vmovsd	%xmm1, -24(%rdx,%rsi,8)
	vmovsd	-24(%rcx,%rsi,8), %xmm1
	vfnmadd213sd	-32(%rcx,%rsi,8), %xmm0, %xmm1
	vaddsd	-16(%rcx,%rsi,8), %xmm1, %xmm1
	vmovsd	%xmm1, -16(%rdx,%rsi,8)
	vmovsd	-16(%rcx,%rsi,8), %xmm1
	vfnmadd213sd	-24(%rcx,%rsi,8), %xmm0, %xmm1
	vaddsd	-8(%rcx,%rsi,8), %xmm1, %xmm1
	vmovsd	%xmm1, -8(%rdx,%rsi,8)
	vmovsd	-8(%rcx,%rsi,8), %xmm1
	vfnmadd213sd	-16(%rcx,%rsi,8), %xmm0, %xmm1
	vaddsd	(%rcx,%rsi,8), %xmm1, %xmm1
	vmovsd	%xmm1, (%rdx,%rsi,8)
	vmovsd	(%rcx,%rsi,8), %xmm1
	vfnmadd213sd	-8(%rcx,%rsi,8), %xmm0, %xmm1
	vaddsd	8(%rcx,%rsi,8), %xmm1, %xmm1
	vmovsd	%xmm1, 8(%rdx,%rsi,8)
	addq	$8, %rsi
	cmpq	%rsi, %rax
	jne	.LBB5_11
.LBB5_12:
	xorl	%eax, %eax
	movq	$0, (%rdi)
	vzeroupper
	retq
.LBB5_17:
	orq	$1, %rsi
	jmp	.LBB5_18
.Lfunc_end5:
	.size	_ZN15granular_fronts5chain6strain9laplacianB2v4B68c8tJTIeFIjxB2IKSgI4CrvQClYb5wBbdC9Xqyfl5JUWJySXqtZrAkCyC6NAEAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE23Size_28int64_20x_202_29x, .Lfunc_end5-_ZN15granular_fronts5chain6strain9laplacianB2v4B68c8tJTIeFIjxB2IKSgI4CrvQClYb5wBbdC9Xqyfl5JUWJySXqtZrAkCyC6NAEAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE23Size_28int64_20x_202_29x

	.type	.const.stage,@object
	.section	.lrodata,"al",@progbits
.const.stage:
	.asciz	"stage"
	.size	.const.stage, 6

	.type	_ZN08NumbaEnv15granular_fronts5chain6strain5stageB2v3B68c8tJTIeFIjxB2IKSgI4CrvQClYb5wBbdC9Xqyfl5JUWJySXqtZrAkCyC6NAEAA_3d_3dE53Law_28int64_2c_20float64_2c_20float64_2c_20float64_2923Size_28int64_20x_202_29317State_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_298UniTupleIdLi9EE8UniTupleIdLi9EEddx,@object
	.comm	_ZN08NumbaEnv15granular_fronts5chain6strain5stageB2v3B68c8tJTIeFIjxB2IKSgI4CrvQClYb5wBbdC9Xqyfl5JUWJySXqtZrAkCyC6NAEAA_3d_3dE53Law_28int64_2c_20float64_2c_20float64_2c_20float64_2923Size_28int64_20x_202_29317State_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_298UniTupleIdLi9EE8UniTupleIdLi9EEddx,8,8
	.type	".const.missing Environment: _ZN08NumbaEnv15granular_fronts5chain6strain5stageB2v3B68c8tJTIeFIjxB2IKSgI4CrvQClYb5wBbdC9Xqyfl5JUWJySXqtZrAkCyC6NAEAA_3d_3dE53Law_28int64_2c_20float64_2c_20float64_2c_20float64_2923Size_28int64_20x_202_29317State_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_298UniTupleIdLi9EE8UniTupleIdLi9EEddx",@object
	.p2align	4, 0x0
".const.missing Environment: _ZN08NumbaEnv15granular_fronts5chain6strain5stageB2v3B68c8tJTIeFIjxB2IKSgI4CrvQClYb5wBbdC9Xqyfl5JUWJySXqtZrAkCyC6NAEAA_3d_3dE53Law_28int64_2c_20float64_2c_20float64_2c_20float64_2923Size_28int64_20x_202_29317State_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_298UniTupleIdLi9EE8UniTupleIdLi9EEddx":
	.asciz	"missing Environment: _ZN08NumbaEnv15granular_fronts5chain6strain5stageB2v3B68c8tJTIeFIjxB2IKSgI4CrvQClYb5wBbdC9Xqyfl5JUWJySXqtZrAkCyC6NAEAA_3d_3dE53Law_28int64_2c_20float64_2c_20float64_2c_20float64_2923Size_28int64_20x_202_29317State_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_298UniTupleIdLi9EE8UniTupleIdLi9EEddx"
	.size	".const.missing Environment: _ZN08NumbaEnv15granular_fronts5chain6strain5stageB2v3B68c8tJTIeFIjxB2IKSgI4CrvQClYb5wBbdC9Xqyfl5JUWJySXqtZrAkCyC6NAEAA_3d_3dE53Law_28int64_2c_20float64_2c_20float64_2c_20float64_2923Size_28int64_20x_202_29317State_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_298UniTupleIdLi9EE8UniTupleIdLi9EEddx", 582

	.type	".const.size mismatch for tuple, expected 4 element(s) but got %zd",@object
	.p2align	4, 0x0
".const.size mismatch for tuple, expected 4 element(s) but got %zd":
	.asciz	"size mismatch for tuple, expected 4 element(s) but got %zd"
	.size	".const.size mismatch for tuple, expected 4 element(s) but got %zd", 59

	.type	".const.size mismatch for tuple, expected 2 element(s) but got %zd",@object
	.p2align	4, 0x0
".const.size mismatch for tuple, expected 2 element(s) but got %zd":
	.asciz	"size mismatch for tuple, expected 2 element(s) but got %zd"
	.size	".const.size mismatch for tuple, expected 2 element(s) but got %zd", 59

	.type	".const.size mismatch for tuple, expected 8 element(s) but got %zd",@object
	.p2align	4, 0x0
".const.size mismatch for tuple, expected 8 element(s) but got %zd":
	.asciz	"size mismatch for tuple, expected 8 element(s) but got %zd"
	.size	".const.size mismatch for tuple, expected 8 element(s) but got %zd", 59

	.type	".const.can't unbox array from PyObject into native value.  The object maybe of a different type",@object
	.p2align	4, 0x0
".const.can't unbox array from PyObject into native value.  The object maybe of a different type":
	.asciz	"can't unbox array from PyObject into native value.  The object maybe of a different type"
	.size	".const.can't unbox array from PyObject into native value.  The object maybe of a different type", 89

	.type	".const.size mismatch for tuple, expected 9 element(s) but got %zd",@object
	.p2align	4, 0x0
".const.size mismatch for tuple, expected 9 element(s) but got %zd":
	.asciz	"size mismatch for tuple, expected 9 element(s) but got %zd"
	.size	".const.size mismatch for tuple, expected 9 element(s) but got %zd", 59

	.type	".const.Error creating Python tuple from runtime exception arguments",@object
	.p2align	4, 0x0
".const.Error creating Python tuple from runtime exception arguments":
	.asciz	"Error creating Python tuple from runtime exception arguments"
	.size	".const.Error creating Python tuple from runtime exception arguments", 61

	.type	".const.unknown error when calling native function",@object
	.p2align	4, 0x0
".const.unknown error when calling native function":
	.asciz	"unknown error when calling native function"
	.size	".const.unknown error when calling native function", 43

	.type	".const.Error creating Python tuple from runtime exception arguments.1",@object
	.p2align	4, 0x0
".const.Error creating Python tuple from runtime exception arguments.1":
	.asciz	"Error creating Python tuple from runtime exception arguments"
	.size	".const.Error creating Python tuple from runtime exception arguments.1", 61

	.type	".const.unknown error when calling native function.2",@object
	.p2align	4, 0x0
".const.unknown error when calling native function.2":
	.asciz	"unknown error when calling native function"
	.size	".const.unknown error when calling native function.2", 43

	.type	".const.<numba.core.cpu.CPUContext>",@object
	.p2align	4, 0x0
".const.<numba.core.cpu.CPUContext>":
	.asciz	"<numba.core.cpu.CPUContext>"
	.size	".const.<numba.core.cpu.CPUContext>", 28

	.type	_ZN08NumbaEnv5numba7cpython8builtins6ol_min12_3clocals_3e4implB2v4B68c8tJTIeFIjxB2IKSgI4CrvQClYb5wBbdC9Xqyfl5JUWJySXqtZrAkMSIa6gBwLACszQBE15StarArgUniTupleIxLi2EE,@object
	.comm	_ZN08NumbaEnv5numba7cpython8builtins6ol_min12_3clocals_3e4implB2v4B68c8tJTIeFIjxB2IKSgI4CrvQClYb5wBbdC9Xqyfl5JUWJySXqtZrAkMSIa6gBwLACszQBE15StarArgUniTupleIxLi2EE,8,8
	.type	_ZN08NumbaEnv15granular_fronts5chain6strain11stage_valueB3v34B70c8tJTIeFIjxB2IKSgI4CrvQClYb5wBbdC9Xqyfl5JUWJySXqtZpAdYi4h_2boEBhKYpQkAE317State_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_298UniTupleIdLi9EE8UniTupleIdLi9EEdddy,@object
	.comm	_ZN08NumbaEnv15granular_fronts5chain6strain11stage_valueB3v34B70c8tJTIeFIjxB2IKSgI4CrvQClYb5wBbdC9Xqyfl5JUWJySXqtZpAdYi4h_2boEBhKYpQkAE317State_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_298UniTupleIdLi9EE8UniTupleIdLi9EEdddy,8,8
	.type	_ZN08NumbaEnv5numba7cpython8builtins6ol_max12_3clocals_3e4implB2v5B68c8tJTIeFIjxB2IKSgI4CrvQClYb5wBbdC9Xqyfl5JUWJySXqtZrAkMSIa6gBwLACszQBE15StarArgUniTupleIdLi2EE,@object
	.comm	_ZN08NumbaEnv5numba7cpython8builtins6ol_max12_3clocals_3e4implB2v5B68c8tJTIeFIjxB2IKSgI4CrvQClYb5wBbdC9Xqyfl5JUWJySXqtZrAkMSIa6gBwLACszQBE15StarArgUniTupleIdLi2EE,8,8
	.type	_ZN08NumbaEnv15granular_fronts5chain6strain16stage_value_pairB3v35B70c8tJTIeFIjxB2IKSgI4CrvQClYb5wBbdC9Xqyfl5JUWJySXqtZpAdYi4h_2boEBhKYpQkAE317State_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_298UniTupleIdLi9EE8UniTupleIdLi9EEdddy,@object
	.comm	_ZN08NumbaEnv15granular_fronts5chain6strain16stage_value_pairB3v35B70c8tJTIeFIjxB2IKSgI4CrvQClYb5wBbdC9Xqyfl5JUWJySXqtZpAdYi4h_2boEBhKYpQkAE317State_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_298UniTupleIdLi9EE8UniTupleIdLi9EEdddy,8,8
	.type	_ZN08NumbaEnv15granular_fronts5chain6strain9laplacianB2v4B68c8tJTIeFIjxB2IKSgI4CrvQClYb5wBbdC9Xqyfl5JUWJySXqtZrAkCyC6NAEAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE23Size_28int64_20x_202_29x,@object
	.comm	_ZN08NumbaEnv15granular_fronts5chain6strain9laplacianB2v4B68c8tJTIeFIjxB2IKSgI4CrvQClYb5wBbdC9Xqyfl5JUWJySXqtZrAkCyC6NAEAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE23Size_28int64_20x_202_29x,8,8
	.section	".note.GNU-stack","",@progbits
