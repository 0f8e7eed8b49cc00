; made from integrator.py and stepping.py, sha256 a870088fc24c8dbd647591d09022a7fa5bd54a918d72e50a5ad8094850f90704
@v22 = private unnamed_addr constant [4 x double] [double 3.860000e-01, double 2.100000e-01, double 6.300000e-01, double 1.000000e+00], align 8
declare i64 @llvm.smax.i64(i64, i64)
declare i64 @llvm.smin.i64(i64, i64)
define internal fastcc void @v36(ptr noalias nonnull writeonly %retptr, i64 %arg.update, double %arg.t, double %arg.start, ptr readonly %arg.c.4, ptr %arg.x.4, i64 %arg.u.2, ptr %arg.u.4, ptr %arg.p.4, i64 %arg.z.2, ptr %arg.z.4, ptr %arg.tt.4, i64 %arg.fired.2, ptr %arg.fired.4, ptr %arg.after.4, ptr readonly %arg.acting.4) unnamed_addr {
B0.endif:
  %.5.i = fmul double %arg.t, 0x3D06849B86A12B9B
  %.6.i = fadd double %.5.i, 1.000000e-15
  %.180 = fadd double %arg.t, %.6.i
  %.10362.not.i7 = icmp eq i64 %arg.fired.2, 0
  br i1 %.10362.not.i7, label %B0.endif.endif, label %B58.backedge.preheader.i8
B136:
  %.319394396 = phi i64 [ %.326.1, %B136 ], [ 0, %B136.preheader ]
  %sunkaddr50 = shl i64 %.319394396, 3
  %sunkaddr51 = getelementptr i8, ptr %arg.z.4, i64 %sunkaddr50
  %.384 = load double, ptr %sunkaddr51, align 8
  %.386 = fcmp ole double %.384, %.180
  %"$phi168.1.2.2" = select i1 %.386, double 1.000000e+00, double 0.000000e+00
  %sunkaddr53 = getelementptr i8, ptr %arg.fired.4, i64 %sunkaddr50
  store double %"$phi168.1.2.2", ptr %sunkaddr53, align 8
  %.326.1 = add nuw i64 %.319394396, 2
  %sunkaddr55 = getelementptr i8, ptr %sunkaddr51, i64 8
  %.384.1 = load double, ptr %sunkaddr55, align 8
  %.386.1 = fcmp ole double %.384.1, %.180
  %"$phi168.1.2.2.1" = select i1 %.386.1, double 1.000000e+00, double 0.000000e+00
  %sunkaddr58 = getelementptr i8, ptr %sunkaddr53, i64 8
  store double %"$phi168.1.2.2.1", ptr %sunkaddr58, align 8
  %niter.ncmp.1 = icmp eq i64 %unroll_iter, %.326.1
  br i1 %niter.ncmp.1, label %B178.loopexit.unr-lcssa, label %B136
B178.loopexit.unr-lcssa:
  br i1 %11, label %B178, label %B136.epil.preheader
B136.epil.preheader:
  %.384.epil = load double, ptr %sunkaddr60, align 8
  %.386.epil = fcmp ole double %.384.epil, %.180
  %"$phi168.1.2.2.epil" = select i1 %.386.epil, double 1.000000e+00, double 0.000000e+00
  store double %"$phi168.1.2.2.epil", ptr %sunkaddr62, align 8
  br label %B178
B178:
  store double %arg.t, ptr %arg.tt.4, align 8
  br i1 %7, label %B178.endif.endif, label %B56.i
B56.i:
  %lsr.iv.i = phi ptr [ %scevgep1.i, %B316.i ], [ %scevgep.i, %B178 ]
  %.138222224.i = phi i64 [ %.145.i, %B316.i ], [ 0, %B178 ]
  %.145.i = add nuw nsw i64 %.138222224.i, 1
  %scevgep6.i = getelementptr i8, ptr %lsr.iv.i, i64 -40
  %.227.i = load double, ptr %scevgep6.i, align 8, !noalias !0
  %scevgep5.i = getelementptr i8, ptr %lsr.iv.i, i64 -32
  %.282.i = load double, ptr %scevgep5.i, align 8, !noalias !0
  %.284.i = fmul double %.40.i, %.282.i
  %.285.i = fadd double %.227.i, %.284.i
  %scevgep4.i = getelementptr i8, ptr %lsr.iv.i, i64 -24
  %.347.i = load double, ptr %scevgep4.i, align 8, !noalias !0
  %.348.i = fcmp une double %.347.i, 0.000000e+00
  br i1 %.348.i, label %B134.i, label %B316.i
B134.i:
  %scevgep3.i = getelementptr i8, ptr %lsr.iv.i, i64 -16
  %.405.i = load double, ptr %scevgep3.i, align 8, !noalias !0
  %scevgep2.i = getelementptr i8, ptr %lsr.iv.i, i64 -8
  %.460.i = load double, ptr %scevgep2.i, align 8, !noalias !0
  %.461.i = fmul double %.460.i, 5.000000e-01
  %.463.i = fmul double %.40.i, %.461.i
  %.464.i = fadd double %.405.i, %.463.i
  %.465.i = fmul double %.464.i, 0x401921FB54442D18
  %.467.i = fmul double %.40.i, %.465.i
  %.522.i = load double, ptr %lsr.iv.i, align 8, !noalias !0
  %.523.i = fadd double %.522.i, %.467.i
  %.586.le.i = tail call double @llvm.sin.f64(double %.523.i)
  %.591.i = fmul double %.347.i, %.586.le.i
  %.593.i = fadd double %.285.i, %.591.i
  br label %B316.i
B316.i:
  %value.2.1.i = phi double [ %.593.i, %B134.i ], [ %.285.i, %B56.i ]
  %0 = shl i64 %.138222224.i, 3
  %scevgep7.i = getelementptr i8, ptr %arg.u.4, i64 %0
  store double %value.2.1.i, ptr %scevgep7.i, align 8, !noalias !0
  %scevgep1.i = getelementptr i8, ptr %lsr.iv.i, i64 48
  %exitcond.not.i = icmp eq i64 %arg.u.2, %.145.i
  br i1 %exitcond.not.i, label %B178.endif.endif, label %B56.i
B308:
  %changed.3.1404 = phi i1 [ %changed.5.2.1, %B366.1 ], [ %changed.4.0, %B178.endif.endif ]
  %.645400402 = phi i64 [ %.652.1, %B366.1 ], [ 0, %B178.endif.endif ]
  %sunkaddr63 = getelementptr i8, ptr %arg.acting.4, i64 %.645400402
  %.714 = load i8, ptr %sunkaddr63, align 1
  %.715.not = icmp eq i8 %.714, 0
  %sunkaddr64 = shl i64 %.645400402, 3
  %sunkaddr65 = getelementptr i8, ptr %arg.after.4, i64 %sunkaddr64
  %.824.pre = load double, ptr %sunkaddr65, align 8
  br i1 %.715.not, label %B366, label %B326
B326:
  %sunkaddr67 = getelementptr i8, ptr %arg.z.4, i64 %sunkaddr64
  %.783 = load double, ptr %sunkaddr67, align 8
  %.784 = fcmp une double %.824.pre, %.783
  br i1 %.784, label %B362, label %B366
B362:
  br label %B366
B366:
  %changed.5.2 = phi i1 [ true, %B362 ], [ %changed.3.1404, %B326 ], [ %changed.3.1404, %B308 ]
  %sunkaddr69 = getelementptr i8, ptr %arg.z.4, i64 %sunkaddr64
  store double %.824.pre, ptr %sunkaddr69, align 8
  %.652.1 = add nuw i64 %.645400402, 2
  %sunkaddr71 = getelementptr i8, ptr %sunkaddr63, i64 1
  %.714.1 = load i8, ptr %sunkaddr71, align 1
  %.715.not.1 = icmp eq i8 %.714.1, 0
  %sunkaddr74 = getelementptr i8, ptr %sunkaddr65, i64 8
  %.824.pre.1 = load double, ptr %sunkaddr74, align 8
  br i1 %.715.not.1, label %B366.1, label %B326.1
B326.1:
  %sunkaddr77 = getelementptr i8, ptr %sunkaddr69, i64 8
  %.783.1 = load double, ptr %sunkaddr77, align 8
  %.784.1 = fcmp une double %.824.pre.1, %.783.1
  br i1 %.784.1, label %B362.1, label %B366.1
B362.1:
  br label %B366.1
B366.1:
  %changed.5.2.1 = phi i1 [ true, %B362.1 ], [ %changed.5.2, %B326.1 ], [ %changed.5.2, %B366 ]
  %sunkaddr80 = getelementptr i8, ptr %sunkaddr69, i64 8
  store double %.824.pre.1, ptr %sunkaddr80, align 8
  %niter57.ncmp.1 = icmp eq i64 %unroll_iter56, %.652.1
  br i1 %niter57.ncmp.1, label %B390.loopexit.unr-lcssa, label %B308
B390.loopexit.unr-lcssa:
  br i1 %13, label %B390, label %B308.epil.preheader
B308.epil.preheader:
  %changed.3.1404.epil.init = phi i1 [ %changed.4.0, %B178.endif.endif ], [ %changed.5.2.1, %B390.loopexit.unr-lcssa ]
  %.714.epil = load i8, ptr %sunkaddr81, align 1
  %.715.not.epil = icmp eq i8 %.714.epil, 0
  %.824.pre.epil = load double, ptr %sunkaddr83, align 8
  br i1 %.715.not.epil, label %B366.epil, label %B326.epil
B326.epil:
  %.783.epil = load double, ptr %sunkaddr85, align 8
  %.784.epil = fcmp une double %.824.pre.epil, %.783.epil
  br i1 %.784.epil, label %B362.epil, label %B366.epil
B362.epil:
  br label %B366.epil
B366.epil:
  %changed.5.2.epil = phi i1 [ true, %B362.epil ], [ %changed.3.1404.epil.init, %B326.epil ], [ %changed.3.1404.epil.init, %B308.epil.preheader ]
  store double %.824.pre.epil, ptr %sunkaddr87, align 8
  br label %B390
B390:
  %changed.3.1.lcssa = phi i1 [ %changed.4.0, %B178.endif.endif ], [ %changed.5.2.1, %B390.loopexit.unr-lcssa ], [ %changed.5.2.epil, %B366.epil ]
  br i1 %.10362.not.i7, label %B390.endif, label %B58.backedge.preheader.i
B58.backedge.preheader.i:
  br i1 %14, label %B58.backedge.epil.preheader.i, label %B58.backedge.i
B58.backedge.i:
  %first.2.065.i = phi double [ %.13.i.3.i, %B58.backedge.i ], [ 0x7FF0000000000000, %B58.backedge.preheader.i ]
  %.1096163.i = phi i64 [ %.116.3.i, %B58.backedge.i ], [ 0, %B58.backedge.preheader.i ]
  %sunkaddr88 = shl i64 %.1096163.i, 3
  %sunkaddr89 = getelementptr i8, ptr %arg.z.4, i64 %sunkaddr88
  %.170.i = load double, ptr %sunkaddr89, align 8, !noalias !3
  %.12.i.i = fcmp olt double %.170.i, %first.2.065.i
  %.13.i.i = select i1 %.12.i.i, double %.170.i, double %first.2.065.i
  %sunkaddr92 = getelementptr i8, ptr %sunkaddr89, i64 8
  %.170.1.i = load double, ptr %sunkaddr92, align 8, !noalias !3
  %.12.i.1.i = fcmp olt double %.170.1.i, %.13.i.i
  %.13.i.1.i = select i1 %.12.i.1.i, double %.170.1.i, double %.13.i.i
  %sunkaddr95 = getelementptr i8, ptr %sunkaddr89, i64 16
  %.170.2.i = load double, ptr %sunkaddr95, align 8, !noalias !3
  %.12.i.2.i = fcmp olt double %.170.2.i, %.13.i.1.i
  %.13.i.2.i = select i1 %.12.i.2.i, double %.170.2.i, double %.13.i.1.i
  %sunkaddr98 = getelementptr i8, ptr %sunkaddr89, i64 24
  %.170.3.i = load double, ptr %sunkaddr98, align 8, !noalias !3
  %.12.i.3.i = fcmp olt double %.170.3.i, %.13.i.2.i
  %.13.i.3.i = select i1 %.12.i.3.i, double %.170.3.i, double %.13.i.2.i
  %.116.3.i = add nuw nsw i64 %.1096163.i, 4
  %niter.ncmp.3.i = icmp eq i64 %unroll_iter.i, %.116.3.i
  br i1 %niter.ncmp.3.i, label %common.ret.loopexit.unr-lcssa.i, label %B58.backedge.i
common.ret.loopexit.unr-lcssa.i:
  br i1 %15, label %B390.endif, label %B58.backedge.epil.preheader.i
B58.backedge.epil.preheader.i:
  %first.2.065.epil.init.i = phi double [ 0x7FF0000000000000, %B58.backedge.preheader.i ], [ %.13.i.3.i, %common.ret.loopexit.unr-lcssa.i ]
  %.1096163.epil.init.i = phi i64 [ 0, %B58.backedge.preheader.i ], [ %unroll_iter.i, %common.ret.loopexit.unr-lcssa.i ]
  %1 = shl i64 %.1096163.epil.init.i, 3
  %scevgep.i5 = getelementptr i8, ptr %arg.z.4, i64 %1
  br label %B58.backedge.epil.i
B58.backedge.epil.i:
  %first.2.065.epil.i = phi double [ %.13.i.epil.i, %B58.backedge.epil.i ], [ %first.2.065.epil.init.i, %B58.backedge.epil.preheader.i ]
  %epil.iter.i = phi i64 [ %epil.iter.next.i, %B58.backedge.epil.i ], [ 0, %B58.backedge.epil.preheader.i ]
  %2 = shl i64 %epil.iter.i, 3
  %scevgep89 = getelementptr i8, ptr %scevgep.i5, i64 %2
  %.170.epil.i = load double, ptr %scevgep89, align 8, !noalias !3
  %.12.i.epil.i = fcmp olt double %.170.epil.i, %first.2.065.epil.i
  %.13.i.epil.i = select i1 %.12.i.epil.i, double %.170.epil.i, double %first.2.065.epil.i
  %epil.iter.next.i = add i64 %epil.iter.i, 1
  %epil.iter.cmp.not.i = icmp eq i64 %xtraiter.i, %epil.iter.next.i
  br i1 %epil.iter.cmp.not.i, label %B390.endif, label %B58.backedge.epil.i, !llvm.loop !6
common.ret:
  %changed.2.1 = phi i8 [ 0, %B0.endif.endif ], [ %3, %B440.loopexit ]
  store i8 %changed.2.1, ptr %retptr, align 1
  ret void
B440.loopexit:
  %3 = zext i1 %changed.3.1.lcssa to i8
  br label %common.ret
B58.backedge.preheader.i8:
  %xtraiter.i9 = and i64 %arg.fired.2, 3
  %4 = icmp ult i64 %arg.fired.2, 4
  br i1 %4, label %B58.backedge.epil.preheader.i36, label %B58.backedge.preheader.new.i10
B58.backedge.preheader.new.i10:
  %unroll_iter.i11 = and i64 %arg.fired.2, 9223372036854775804
  br label %B58.backedge.i12
B58.backedge.i12:
  %first.2.065.i13 = phi double [ 0x7FF0000000000000, %B58.backedge.preheader.new.i10 ], [ %.13.i.3.i31, %B58.backedge.i12 ]
  %.1096163.i14 = phi i64 [ 0, %B58.backedge.preheader.new.i10 ], [ %.116.3.i32, %B58.backedge.i12 ]
  %sunkaddr99 = shl i64 %.1096163.i14, 3
  %sunkaddr100 = getelementptr i8, ptr %arg.z.4, i64 %sunkaddr99
  %.170.i17 = load double, ptr %sunkaddr100, align 8, !noalias !8
  %.12.i.i18 = fcmp olt double %.170.i17, %first.2.065.i13
  %.13.i.i19 = select i1 %.12.i.i18, double %.170.i17, double %first.2.065.i13
  %sunkaddr103 = getelementptr i8, ptr %sunkaddr100, i64 8
  %.170.1.i21 = load double, ptr %sunkaddr103, align 8, !noalias !8
  %.12.i.1.i22 = fcmp olt double %.170.1.i21, %.13.i.i19
  %.13.i.1.i23 = select i1 %.12.i.1.i22, double %.170.1.i21, double %.13.i.i19
  %sunkaddr106 = getelementptr i8, ptr %sunkaddr100, i64 16
  %.170.2.i25 = load double, ptr %sunkaddr106, align 8, !noalias !8
  %.12.i.2.i26 = fcmp olt double %.170.2.i25, %.13.i.1.i23
  %.13.i.2.i27 = select i1 %.12.i.2.i26, double %.170.2.i25, double %.13.i.1.i23
  %sunkaddr109 = getelementptr i8, ptr %sunkaddr100, i64 24
  %.170.3.i29 = load double, ptr %sunkaddr109, align 8, !noalias !8
  %.12.i.3.i30 = fcmp olt double %.170.3.i29, %.13.i.2.i27
  %.13.i.3.i31 = select i1 %.12.i.3.i30, double %.170.3.i29, double %.13.i.2.i27
  %.116.3.i32 = add nuw nsw i64 %.1096163.i14, 4
  %niter.ncmp.3.i33 = icmp eq i64 %unroll_iter.i11, %.116.3.i32
  br i1 %niter.ncmp.3.i33, label %common.ret.loopexit.unr-lcssa.i34, label %B58.backedge.i12
common.ret.loopexit.unr-lcssa.i34:
  %lcmp.mod.not.i35 = icmp eq i64 %xtraiter.i9, 0
  br i1 %lcmp.mod.not.i35, label %B0.endif.endif, label %B58.backedge.epil.preheader.i36
B58.backedge.epil.preheader.i36:
  %first.2.065.epil.init.i37 = phi double [ 0x7FF0000000000000, %B58.backedge.preheader.i8 ], [ %.13.i.3.i31, %common.ret.loopexit.unr-lcssa.i34 ]
  %.1096163.epil.init.i38 = phi i64 [ 0, %B58.backedge.preheader.i8 ], [ %unroll_iter.i11, %common.ret.loopexit.unr-lcssa.i34 ]
  %5 = shl i64 %.1096163.epil.init.i38, 3
  %scevgep.i39 = getelementptr i8, ptr %arg.z.4, i64 %5
  br label %B58.backedge.epil.i40
B58.backedge.epil.i40:
  %first.2.065.epil.i41 = phi double [ %.13.i.epil.i46, %B58.backedge.epil.i40 ], [ %first.2.065.epil.init.i37, %B58.backedge.epil.preheader.i36 ]
  %epil.iter.i42 = phi i64 [ %epil.iter.next.i47, %B58.backedge.epil.i40 ], [ 0, %B58.backedge.epil.preheader.i36 ]
  %6 = shl i64 %epil.iter.i42, 3
  %scevgep90 = getelementptr i8, ptr %scevgep.i39, i64 %6
  %.170.epil.i44 = load double, ptr %scevgep90, align 8, !noalias !8
  %.12.i.epil.i45 = fcmp olt double %.170.epil.i44, %first.2.065.epil.i41
  %.13.i.epil.i46 = select i1 %.12.i.epil.i45, double %.170.epil.i44, double %first.2.065.epil.i41
  %epil.iter.next.i47 = add i64 %epil.iter.i42, 1
  %epil.iter.cmp.not.i48 = icmp eq i64 %xtraiter.i9, %epil.iter.next.i47
  br i1 %epil.iter.cmp.not.i48, label %B0.endif.endif, label %B58.backedge.epil.i40, !llvm.loop !6
B0.endif.endif:
  %first.2.0.lcssa.i49 = phi double [ 0x7FF0000000000000, %B0.endif ], [ %.13.i.3.i31, %common.ret.loopexit.unr-lcssa.i34 ], [ %.13.i.epil.i46, %B58.backedge.epil.i40 ]
  %.220 = fcmp ugt double %first.2.0.lcssa.i49, %.180
  br i1 %.220, label %common.ret, label %B94.endif.preheader
B94.endif.preheader:
  %.40.i = fsub double %arg.t, %arg.start
  %scevgep.i = getelementptr i8, ptr %arg.c.4, i64 40
  %xtraiter.i = and i64 %arg.fired.2, 3
  %unroll_iter.i = and i64 %arg.fired.2, 9223372036854775804
  %unroll_iter = and i64 %arg.fired.2, 9223372036854775806
  %unroll_iter56 = and i64 %arg.z.2, 9223372036854775806
  %7 = icmp eq i64 %arg.u.2, 0
  %8 = inttoptr i64 %arg.update to ptr
  %9 = icmp eq i64 %arg.fired.2, 1
  %10 = and i64 %arg.fired.2, 1
  %11 = icmp eq i64 %10, 0
  %sunkaddr59 = shl i64 %unroll_iter, 3
  %sunkaddr60 = getelementptr i8, ptr %arg.z.4, i64 %sunkaddr59
  %sunkaddr62 = getelementptr i8, ptr %arg.fired.4, i64 %sunkaddr59
  %12 = and i64 %arg.z.2, 1
  %13 = icmp eq i64 %12, 0
  %sunkaddr81 = getelementptr i8, ptr %arg.acting.4, i64 %unroll_iter56
  %sunkaddr82 = shl i64 %unroll_iter56, 3
  %sunkaddr83 = getelementptr i8, ptr %arg.after.4, i64 %sunkaddr82
  %sunkaddr85 = getelementptr i8, ptr %arg.z.4, i64 %sunkaddr82
  %sunkaddr87 = getelementptr i8, ptr %arg.z.4, i64 %sunkaddr82
  %14 = icmp ult i64 %arg.fired.2, 4
  %15 = icmp eq i64 %xtraiter.i, 0
  br label %B94.endif
B94.endif:
  %changed.4.0 = phi i1 [ %changed.3.1.lcssa, %B390.endif ], [ false, %B94.endif.preheader ]
  br i1 %.10362.not.i7, label %B178, label %B136.preheader
B136.preheader:
  br i1 %9, label %B136.epil.preheader, label %B136
B178.endif.endif:
  tail call void %8(ptr nonnull %arg.tt.4, ptr %arg.x.4, ptr %arg.u.4, ptr %arg.p.4, ptr %arg.fired.4, ptr %arg.after.4)
  switch i64 %arg.z.2, label %B308 [
    i64 0, label %B390
    i64 1, label %B308.epil.preheader
  ]
B390.endif:
  %first.2.0.lcssa.i = phi double [ 0x7FF0000000000000, %B390 ], [ %.13.i.3.i, %common.ret.loopexit.unr-lcssa.i ], [ %.13.i.epil.i, %B58.backedge.epil.i ]
  %.907 = fcmp ugt double %first.2.0.lcssa.i, %.180
  br i1 %.907, label %B440.loopexit, label %B94.endif
}
declare double @llvm.sin.f64(double)
declare double @llvm.fabs.f64(double)
declare double @llvm.cos.f64(double)
declare double @llvm.pow.f64(double, double)
define internal fastcc void @v37(ptr noalias nonnull writeonly %retptr, i64 %arg.outputs, double %arg.t, double %arg.h, double %arg.until, double %arg.start, ptr readonly %arg.c.4, ptr readonly %arg.x.4, ptr readonly %arg.x1.4, ptr readonly %arg.dense.4, i64 %arg.row.2, ptr %arg.row.4, i64 %arg.u.2, ptr %arg.u.4, ptr %arg.p.4, ptr %arg.tt.4, i64 %arg.y.2, ptr %arg.y.4, i64 %arg.grid.2, ptr readonly %arg.grid.4, i64 %arg.grid.5.0, ptr writeonly %arg.table.4, i64 %arg.table.5.1, ptr %arg.counts.4) unnamed_addr {
B0.endif:
  %.5.i = fmul double %arg.until, 0x3D06849B86A12B9B
  %.6.i = fadd double %.5.i, 1.000000e-15
  %.224 = fsub double %arg.until, %.6.i
  %.256 = getelementptr i8, ptr %arg.counts.4, i64 16
  %.257 = load i64, ptr %.256, align 8
  %.265 = icmp slt i64 %.257, %arg.grid.2
  br i1 %.265, label %B74, label %common.ret
B74:
  %.310 = icmp slt i64 %.257, 0
  %.311 = select i1 %.310, i64 %arg.grid.5.0, i64 0
  %0 = getelementptr double, ptr %arg.grid.4, i64 %.257
  %.325 = getelementptr double, ptr %0, i64 %.311
  %.326 = load double, ptr %.325, align 8
  %.328 = fcmp olt double %.326, %.224
  br i1 %.328, label %B110.endif.endif.preheader, label %common.ret
B110.endif.endif.preheader:
  %invariant.gep.i = getelementptr double, ptr %arg.dense.4, i64 %arg.row.2
  %scevgep.i15 = getelementptr i8, ptr %arg.c.4, i64 40
  %xtraiter.i = and i64 %arg.y.2, 3
  %unroll_iter.i = and i64 %arg.y.2, 9223372036854775804
  %1 = mul i64 %arg.table.5.1, 24
  %2 = shl i64 %arg.table.5.1, 5
  %3 = shl i64 %arg.table.5.1, 4
  %sunkaddr22.i = shl i64 %arg.table.5.1, 3
  %4 = add nsw i64 %unroll_iter.i, -4
  %5 = lshr exact i64 %4, 2
  %6 = add nuw nsw i64 %5, 1
  %7 = and i64 %6, 9223372036854775806
  %8 = icmp slt i64 %arg.row.2, 1
  %9 = icmp eq i64 %arg.u.2, 0
  %10 = icmp eq i64 %arg.y.2, 0
  %11 = inttoptr i64 %arg.outputs to ptr
  %12 = icmp ult i64 %arg.y.2, 4
  %13 = icmp eq i64 %4, 0
  %14 = and i64 %4, 4
  %15 = icmp eq i64 %14, 0
  %16 = icmp eq i64 %xtraiter.i, 0
  br label %B110.endif.endif
B420:
  %.838 = icmp slt i64 %.724, -1
  %.839 = select i1 %.838, i64 %arg.grid.5.0, i64 0
  %17 = getelementptr double, ptr %arg.grid.4, i64 %.725
  %.853 = getelementptr double, ptr %17, i64 %.839
  %.854 = load double, ptr %.853, align 8
  %.856 = fcmp olt double %.854, %.224
  br i1 %.856, label %B110.endif.endif, label %common.ret
common.ret:
  store ptr null, ptr %retptr, align 8
  ret void
B110.endif.endif:
  %.363 = phi i64 [ %.725, %B420 ], [ %.257, %B110.endif.endif.preheader ]
  %.377 = icmp slt i64 %.363, 0
  %.378 = select i1 %.377, i64 %arg.grid.5.0, i64 0
  %18 = getelementptr double, ptr %arg.grid.4, i64 %.363
  %.392 = getelementptr double, ptr %18, i64 %.378
  %.393 = load double, ptr %.392, align 8
  %.395 = fsub double %.393, %arg.t
  %.400 = fdiv double %.395, %arg.h
  %.12.i = fcmp ogt double %.400, 0.000000e+00
  %.13.i = select i1 %.12.i, double %.400, double 0.000000e+00
  %.64.i = fsub double 1.000000e+00, %.13.i
  br i1 %8, label %B110.endif.endif.endif, label %B60.i
B60.i:
  %.166146148.i = phi i64 [ %.173.i, %B60.i ], [ 0, %B110.endif.endif ]
  %.173.i = add nuw nsw i64 %.166146148.i, 1
  %19 = shl i64 %.166146148.i, 3
  %scevgep4.i = getelementptr i8, ptr %arg.x.4, i64 %19
  %.227.i = load double, ptr %scevgep4.i, align 8, !noalias !11
  %.229.i = fmul double %.64.i, %.227.i
  %scevgep3.i = getelementptr i8, ptr %arg.x1.4, i64 %19
  %.259.i = load double, ptr %scevgep3.i, align 8, !noalias !11
  %scevgep5 = getelementptr i8, ptr %arg.dense.4, i64 %19
  %.289.i = load double, ptr %scevgep5, align 8, !noalias !11
  %scevgep4 = getelementptr i8, ptr %invariant.gep.i, i64 %19
  %.321.i = load double, ptr %scevgep4, align 8, !noalias !11
  %.323.i = fmul double %.13.i, %.321.i
  %.324.i = fadd double %.289.i, %.323.i
  %.326.i = fmul double %.64.i, %.324.i
  %.327.i = fadd double %.259.i, %.326.i
  %.329.i = fmul double %.13.i, %.327.i
  %.330.i = fadd double %.229.i, %.329.i
  %scevgep = getelementptr i8, ptr %arg.row.4, i64 %19
  store double %.330.i, ptr %scevgep, align 8, !noalias !11
  %exitcond.not.i = icmp eq i64 %arg.row.2, %.173.i
  br i1 %exitcond.not.i, label %B110.endif.endif.endif.loopexit, label %B60.i
B110.endif.endif.endif.loopexit:
  %.495.pre = load i64, ptr %.256, align 8
  br label %B110.endif.endif.endif
B110.endif.endif.endif:
  %.495 = phi i64 [ %.495.pre, %B110.endif.endif.endif.loopexit ], [ %.363, %B110.endif.endif ]
  %.509 = icmp slt i64 %.495, 0
  %.510 = select i1 %.509, i64 %arg.grid.5.0, i64 0
  %20 = getelementptr double, ptr %arg.grid.4, i64 %.495
  %.524 = getelementptr double, ptr %20, i64 %.510
  %.525 = load double, ptr %.524, align 8
  %.40.i = fsub double %.525, %arg.start
  br i1 %9, label %B110.endif.endif.endif.endif, label %B56.i
B56.i:
  %lsr.iv.i = phi ptr [ %scevgep1.i18, %B316.i ], [ %scevgep.i15, %B110.endif.endif.endif ]
  %.138222224.i = phi i64 [ %.145.i, %B316.i ], [ 0, %B110.endif.endif.endif ]
  %.145.i = add nuw nsw i64 %.138222224.i, 1
  %scevgep6.i = getelementptr i8, ptr %lsr.iv.i, i64 -40
  %.227.i16 = load double, ptr %scevgep6.i, align 8, !noalias !14
  %scevgep5.i = getelementptr i8, ptr %lsr.iv.i, i64 -32
  %.282.i = load double, ptr %scevgep5.i, align 8, !noalias !14
  %.284.i = fmul double %.40.i, %.282.i
  %.285.i = fadd double %.227.i16, %.284.i
  %scevgep4.i17 = getelementptr i8, ptr %lsr.iv.i, i64 -24
  %.347.i = load double, ptr %scevgep4.i17, align 8, !noalias !14
  %.348.i = fcmp une double %.347.i, 0.000000e+00
  br i1 %.348.i, label %B134.i, label %B316.i
B134.i:
  %scevgep3.i20 = getelementptr i8, ptr %lsr.iv.i, i64 -16
  %.405.i = load double, ptr %scevgep3.i20, align 8, !noalias !14
  %scevgep2.i21 = getelementptr i8, ptr %lsr.iv.i, i64 -8
  %.460.i = load double, ptr %scevgep2.i21, align 8, !noalias !14
  %.461.i = fmul double %.460.i, 5.000000e-01
  %.463.i = fmul double %.40.i, %.461.i
  %.464.i = fadd double %.405.i, %.463.i
  %.465.i = fmul double %.464.i, 0x401921FB54442D18
  %.467.i = fmul double %.40.i, %.465.i
  %.522.i = load double, ptr %lsr.iv.i, align 8, !noalias !14
  %.523.i = fadd double %.522.i, %.467.i
  %.586.le.i = tail call double @llvm.sin.f64(double %.523.i)
  %.591.i = fmul double %.347.i, %.586.le.i
  %.593.i = fadd double %.285.i, %.591.i
  br label %B316.i
B316.i:
  %value.2.1.i = phi double [ %.593.i, %B134.i ], [ %.285.i, %B56.i ]
  %21 = shl i64 %.138222224.i, 3
  %scevgep7.i = getelementptr i8, ptr %arg.u.4, i64 %21
  store double %value.2.1.i, ptr %scevgep7.i, align 8, !noalias !14
  %scevgep1.i18 = getelementptr i8, ptr %lsr.iv.i, i64 48
  %exitcond.not.i19 = icmp eq i64 %arg.u.2, %.145.i
  br i1 %exitcond.not.i19, label %B110.endif.endif.endif.endif.loopexit, label %B56.i
B110.endif.endif.endif.endif.loopexit:
  %.589.pre = load i64, ptr %.256, align 8
  br label %B110.endif.endif.endif.endif
B110.endif.endif.endif.endif:
  %.589 = phi i64 [ %.589.pre, %B110.endif.endif.endif.endif.loopexit ], [ %.495, %B110.endif.endif.endif ]
  %.603 = icmp slt i64 %.589, 0
  %.604 = select i1 %.603, i64 %arg.grid.5.0, i64 0
  %22 = getelementptr double, ptr %arg.grid.4, i64 %.589
  %.618 = getelementptr double, ptr %22, i64 %.604
  %.619 = load double, ptr %.618, align 8
  store double %.619, ptr %arg.tt.4, align 8, !noalias !17
  tail call void %11(ptr nonnull %arg.tt.4, ptr %arg.row.4, ptr %arg.u.4, ptr %arg.p.4, ptr %arg.y.4), !noalias !17
  br i1 %10, label %B110.endif.endif.endif.endif.endif, label %B96.lr.ph.i
B96.lr.ph.i:
  %.350.i = select i1 %.603, i64 %arg.table.5.1, i64 0
  br i1 %12, label %B96.epil.preheader.i, label %B96.lr.ph.new.i
B96.lr.ph.new.i:
  %invariant.gep.i22 = getelementptr double, ptr %arg.table.4, i64 %.589
  %invariant.gep159.i = getelementptr double, ptr %invariant.gep.i22, i64 %.350.i
  br i1 %13, label %B96.i.epil.preheader, label %B96.i
B96.i:
  %lsr.iv = phi i64 [ %lsr.iv.next, %B96.i ], [ %7, %B96.lr.ph.new.i ]
  %lsr.iv13.i = phi ptr [ %scevgep55, %B96.i ], [ %invariant.gep159.i, %B96.lr.ph.new.i ]
  %.259154156.i = phi i64 [ %.266.3.i.1, %B96.i ], [ 0, %B96.lr.ph.new.i ]
  %sunkaddr24 = shl i64 %.259154156.i, 3
  %sunkaddr25 = getelementptr i8, ptr %arg.y.4, i64 %sunkaddr24
  %.320.i = load double, ptr %sunkaddr25, align 8, !noalias !17
  store double %.320.i, ptr %lsr.iv13.i, align 8, !noalias !17
  %sunkaddr28 = getelementptr i8, ptr %sunkaddr25, i64 8
  %.320.1.i = load double, ptr %sunkaddr28, align 8, !noalias !17
  %sunkaddr23.i = getelementptr i8, ptr %lsr.iv13.i, i64 %sunkaddr22.i
  store double %.320.1.i, ptr %sunkaddr23.i, align 8, !noalias !17
  %sunkaddr31 = getelementptr i8, ptr %sunkaddr25, i64 16
  %.320.2.i = load double, ptr %sunkaddr31, align 8, !noalias !17
  %scevgep49 = getelementptr i8, ptr %sunkaddr23.i, i64 %sunkaddr22.i
  store double %.320.2.i, ptr %scevgep49, align 8, !noalias !17
  %sunkaddr34 = getelementptr i8, ptr %sunkaddr25, i64 24
  %.320.3.i = load double, ptr %sunkaddr34, align 8, !noalias !17
  %scevgep50 = getelementptr i8, ptr %scevgep49, i64 %sunkaddr22.i
  store double %.320.3.i, ptr %scevgep50, align 8, !noalias !17
  %sunkaddr37 = getelementptr i8, ptr %sunkaddr25, i64 32
  %.320.i.1 = load double, ptr %sunkaddr37, align 8, !noalias !17
  %scevgep51 = getelementptr i8, ptr %scevgep50, i64 %sunkaddr22.i
  store double %.320.i.1, ptr %scevgep51, align 8, !noalias !17
  %sunkaddr40 = getelementptr i8, ptr %sunkaddr25, i64 40
  %.320.1.i.1 = load double, ptr %sunkaddr40, align 8, !noalias !17
  %scevgep52 = getelementptr i8, ptr %scevgep51, i64 %sunkaddr22.i
  store double %.320.1.i.1, ptr %scevgep52, align 8, !noalias !17
  %sunkaddr43 = getelementptr i8, ptr %sunkaddr25, i64 48
  %.320.2.i.1 = load double, ptr %sunkaddr43, align 8, !noalias !17
  %scevgep53 = getelementptr i8, ptr %scevgep52, i64 %sunkaddr22.i
  store double %.320.2.i.1, ptr %scevgep53, align 8, !noalias !17
  %.266.3.i.1 = add i64 %.259154156.i, 8
  %sunkaddr44 = shl i64 %.266.3.i.1, 3
  %sunkaddr45 = getelementptr i8, ptr %arg.y.4, i64 %sunkaddr44
  %sunkaddr46 = getelementptr i8, ptr %sunkaddr45, i64 -8
  %.320.3.i.1 = load double, ptr %sunkaddr46, align 8, !noalias !17
  %scevgep54 = getelementptr i8, ptr %scevgep53, i64 %sunkaddr22.i
  store double %.320.3.i.1, ptr %scevgep54, align 8, !noalias !17
  %scevgep55 = getelementptr i8, ptr %scevgep54, i64 %sunkaddr22.i
  %lsr.iv.next = add i64 %lsr.iv, -2
  %niter.ncmp.1 = icmp eq i64 %lsr.iv.next, 0
  br i1 %niter.ncmp.1, label %B126.loopexit.unr-lcssa.i.unr-lcssa, label %B96.i
B126.loopexit.unr-lcssa.i.unr-lcssa:
  %scevgep14.i = getelementptr i8, ptr %lsr.iv13.i, i64 %2
  %scevgep14.i.1 = getelementptr i8, ptr %scevgep14.i, i64 %2
  br i1 %15, label %B96.i.epil.preheader, label %B126.loopexit.unr-lcssa.i
B96.i.epil.preheader:
  %lsr.iv13.i.epil.init = phi ptr [ %invariant.gep159.i, %B96.lr.ph.new.i ], [ %scevgep14.i.1, %B126.loopexit.unr-lcssa.i.unr-lcssa ]
  %.259154156.i.epil.init = phi i64 [ 0, %B96.lr.ph.new.i ], [ %.266.3.i.1, %B126.loopexit.unr-lcssa.i.unr-lcssa ]
  %sunkaddr.i.epil = shl i64 %.259154156.i.epil.init, 3
  %sunkaddr18.i.epil = getelementptr i8, ptr %arg.y.4, i64 %sunkaddr.i.epil
  %.320.i.epil = load double, ptr %sunkaddr18.i.epil, align 8, !noalias !17
  store double %.320.i.epil, ptr %lsr.iv13.i.epil.init, align 8, !noalias !17
  %sunkaddr21.i.epil = getelementptr i8, ptr %sunkaddr18.i.epil, i64 8
  %.320.1.i.epil = load double, ptr %sunkaddr21.i.epil, align 8, !noalias !17
  %sunkaddr23.i.epil = getelementptr i8, ptr %lsr.iv13.i.epil.init, i64 %sunkaddr22.i
  store double %.320.1.i.epil, ptr %sunkaddr23.i.epil, align 8, !noalias !17
  %sunkaddr26.i.epil = getelementptr i8, ptr %sunkaddr18.i.epil, i64 16
  %.320.2.i.epil = load double, ptr %sunkaddr26.i.epil, align 8, !noalias !17
  %scevgep16.i.epil = getelementptr i8, ptr %lsr.iv13.i.epil.init, i64 %3
  store double %.320.2.i.epil, ptr %scevgep16.i.epil, align 8, !noalias !17
  %sunkaddr29.i.epil = getelementptr i8, ptr %sunkaddr18.i.epil, i64 24
  %.320.3.i.epil = load double, ptr %sunkaddr29.i.epil, align 8, !noalias !17
  %scevgep15.i.epil = getelementptr i8, ptr %lsr.iv13.i.epil.init, i64 %1
  store double %.320.3.i.epil, ptr %scevgep15.i.epil, align 8, !noalias !17
  br label %B126.loopexit.unr-lcssa.i
B126.loopexit.unr-lcssa.i:
  br i1 %16, label %B110.endif.endif.endif.endif.endif, label %B96.epil.preheader.i
B96.epil.preheader.i:
  %.259154156.epil.init.i = phi i64 [ %unroll_iter.i, %B126.loopexit.unr-lcssa.i ], [ 0, %B96.lr.ph.i ]
  %23 = mul i64 %.259154156.epil.init.i, %arg.table.5.1
  %24 = add i64 %.350.i, %.589
  %25 = add i64 %24, %23
  %26 = shl i64 %25, 3
  %scevgep.i23 = getelementptr i8, ptr %arg.table.4, i64 %26
  %27 = shl i64 %.259154156.epil.init.i, 3
  %scevgep3.i24 = getelementptr i8, ptr %arg.y.4, i64 %27
  br label %B96.epil.i
B96.epil.i:
  %lsr.iv.i25 = phi ptr [ %scevgep2.i27, %B96.epil.i ], [ %scevgep.i23, %B96.epil.preheader.i ]
  %epil.iter.i = phi i64 [ %epil.iter.next.i, %B96.epil.i ], [ 0, %B96.epil.preheader.i ]
  %28 = shl i64 %epil.iter.i, 3
  %scevgep56 = getelementptr i8, ptr %scevgep3.i24, i64 %28
  %.320.epil.i = load double, ptr %scevgep56, align 8, !noalias !17
  store double %.320.epil.i, ptr %lsr.iv.i25, align 8, !noalias !17
  %epil.iter.next.i = add i64 %epil.iter.i, 1
  %scevgep2.i27 = getelementptr i8, ptr %lsr.iv.i25, i64 %sunkaddr22.i
  %epil.iter.cmp.not.i = icmp eq i64 %xtraiter.i, %epil.iter.next.i
  br i1 %epil.iter.cmp.not.i, label %B110.endif.endif.endif.endif.endif, label %B96.epil.i, !llvm.loop !20
B110.endif.endif.endif.endif.endif:
  %.724 = load i64, ptr %.256, align 8
  %.725 = add nsw i64 %.724, 1
  store i64 %.725, ptr %.256, align 8
  %.793 = icmp slt i64 %.725, %arg.grid.2
  br i1 %.793, label %B420, label %common.ret
}
declare i64 @llvm.umin.i64(i64, i64)
define i64 @integrate(ptr readonly %a0, ptr readonly %a1, ptr %a2, ptr %a3, ptr readonly %a4, ptr readonly %a5, ptr readonly %a6, ptr readonly %a7, ptr readonly %a8, ptr readonly %a9, ptr readonly %a10, ptr readonly %a11, ptr readonly %a12, ptr readonly %a13, ptr writeonly %a14, ptr %a15, ptr %a16, ptr %a17, ptr %a18, ptr %a19) local_unnamed_addr {
  %.362.i.i = alloca i8, align 1
  %.1023.i.i = alloca ptr, align 8
  %.468.i.i.i.i = alloca ptr, align 8
  %.578.i2.i.i.i = alloca i8, align 1
  %.1003.i.i.i = alloca ptr, align 8
  %.4389.i.i = alloca i8, align 1
  %.4705.i = alloca i8, align 1
  call void @llvm.lifetime.start.p0(ptr nonnull %.4705.i)
  store i8 0, ptr %.4705.i, align 1, !noalias !21
  %.25.i = load i64, ptr %a1, align 8, !noalias !21
  %.26.i = getelementptr i8, ptr %a1, i64 8
  %.27.i = load i64, ptr %.26.i, align 8, !noalias !21
  %.28.i = getelementptr i8, ptr %a1, i64 16
  %.29.i = load i64, ptr %.28.i, align 8, !noalias !21
  %.30.i = getelementptr i8, ptr %a1, i64 24
  %.31.i = load i64, ptr %.30.i, align 8, !noalias !21
  %.32.i = getelementptr i8, ptr %a1, i64 32
  %.33.i = load i64, ptr %.32.i, align 8, !noalias !21
  %.70.i = getelementptr i8, ptr %a1, i64 40
  %.71.i = load i64, ptr %.70.i, align 8, !noalias !21
  %.72.i = getelementptr i8, ptr %a1, i64 48
  %.73.i = load i64, ptr %.72.i, align 8, !noalias !21
  %.74.i = getelementptr i8, ptr %a1, i64 56
  %.75.i = load i64, ptr %.74.i, align 8, !noalias !21
  %.76.i = getelementptr i8, ptr %a1, i64 64
  %.77.i = load i64, ptr %.76.i, align 8, !noalias !21
  %.108.i = getelementptr i8, ptr %a1, i64 80
  %.109.i = load i64, ptr %.108.i, align 8, !noalias !21
  %.110.i = getelementptr i8, ptr %a1, i64 88
  %.111.i = load i64, ptr %.110.i, align 8, !noalias !21
  %.112.i = getelementptr i8, ptr %a1, i64 96
  %.113.i = load i64, ptr %.112.i, align 8, !noalias !21
  %.16.i.i = shl i64 %.71.i, 3
  %.936.i = add nsw i64 %.111.i, %.109.i
  %.976.i = getelementptr i8, ptr %a1, i64 72
  %.977.i = load i64, ptr %.976.i, align 8, !noalias !21
  %.1083.i = icmp slt i64 %.109.i, 0
  %.1084.i = select i1 %.1083.i, i64 %.936.i, i64 0
  %.1085.i = add i64 %.1084.i, %.109.i
  %.1088.i = icmp slt i64 %.1085.i, 0
  br i1 %.1088.i, label %B0.endif.endif.endif.endi...else.if.i, label %B0.endif.endif.endif.endi...else.endif.i, !prof !24
B1334.i:
  %lsr.iv451.i = phi ptr [ %scevgep452.i, %B1334.i ], [ %scevgep450.i, %B1334.lr.ph.new.i ]
  %lsr.iv447.i = phi ptr [ %scevgep448.i, %B1334.i ], [ %scevgep446.i, %B1334.lr.ph.new.i ]
  %.403831443146.i = phi i64 [ %.4045.1.i, %B1334.i ], [ 0, %B1334.lr.ph.new.i ]
  %scevgep449.i = getelementptr i8, ptr %lsr.iv447.i, i64 -8
  %.4099.i = load double, ptr %scevgep449.i, align 8, !noalias !21
  %scevgep453.i = getelementptr i8, ptr %lsr.iv451.i, i64 -8
  store double %.4099.i, ptr %scevgep453.i, align 8, !noalias !21
  %sunkaddr461.i = getelementptr i8, ptr %lsr.iv451.i, i64 %sunkaddr.i
  %sunkaddr462.i = getelementptr i8, ptr %sunkaddr461.i, i64 -8
  store double %.4099.i, ptr %sunkaddr462.i, align 8, !noalias !21
  %scevgep458.i = getelementptr i8, ptr %lsr.iv451.i, i64 %.idx.i
  %scevgep459.i = getelementptr i8, ptr %scevgep458.i, i64 -8
  store double 0.000000e+00, ptr %scevgep459.i, align 8, !noalias !21
  %.4045.1.i = add nuw i64 %.403831443146.i, 2
  %.4099.1.i = load double, ptr %lsr.iv447.i, align 8, !noalias !21
  store double %.4099.1.i, ptr %lsr.iv451.i, align 8, !noalias !21
  store double %.4099.1.i, ptr %sunkaddr461.i, align 8, !noalias !21
  store double 0.000000e+00, ptr %scevgep458.i, align 8, !noalias !21
  %scevgep448.i = getelementptr i8, ptr %lsr.iv447.i, i64 16
  %scevgep452.i = getelementptr i8, ptr %lsr.iv451.i, i64 16
  %niter.ncmp.1.i = icmp eq i64 %unroll_iter.i, %.4045.1.i
  br i1 %niter.ncmp.1.i, label %B1412.endif.loopexit.unr-lcssa.i, label %B1334.i
B1500.i:
  %h.3.03166.i = phi double [ 0.000000e+00, %B1500.lr.ph.i ], [ %h.4.13102.i, %B2242.i ]
  %.441531563164.i = phi i64 [ 0, %B1500.lr.ph.i ], [ %.4422.i, %B2242.i ]
  %.4422.i = add nuw nsw i64 %.441531563164.i, 1
  %1 = getelementptr double, ptr %a4, i64 %.441531563164.i
  %.4486.i = load double, ptr %1, align 8, !noalias !21
  %.4493.i = icmp slt i64 %.4422.i, %.33.i
  %2 = getelementptr double, ptr %a4, i64 %.4422.i
  %"$phi1578.1.2.1.in.i" = select i1 %.4493.i, ptr %2, ptr %.4561.i
  %"$phi1578.1.2.1.i" = load double, ptr %"$phi1578.1.2.1.in.i", align 8, !noalias !21
  br i1 %48, label %B1592.i, label %B1688.i
B1592.i:
  %.4604.i = load i64, ptr %sunkaddr465.i, align 8, !noalias !21
  %.4655.i = mul i64 %.441531563164.i, %.1277.i
  %.4657.i = getelementptr double, ptr %a5, i64 %.4655.i
  store i8 0, ptr %.4705.i, align 1, !noalias !21
  call fastcc void @v36(ptr nonnull %.4705.i, i64 %.4604.i, double %.4486.i, double %.4486.i, ptr readonly %.4657.i, ptr %a2, i64 %.1806.i, ptr %.1822.i, ptr %a3, i64 %.1170.i, ptr %.1186.i, ptr %.2336.i, i64 %.3526.i, ptr %.3542.i, ptr %.3715.i, ptr readonly %a13)
  br label %B1688.i
B1688.i:
  br i1 %49, label %B1700.i, label %B1884.i
B1700.i:
  %.40.i.i = fsub double %.4486.i, %.4486.i
  br i1 %50, label %B1700.endif.i, label %B56.preheader.i.i
B56.preheader.i.i:
  %.4817.i = mul i64 %.441531563164.i, %.1277.i
  %.4819.i = getelementptr double, ptr %a5, i64 %.4817.i
  %scevgep.i.i = getelementptr i8, ptr %.4819.i, i64 40
  br label %B56.i.i
B56.i.i:
  %lsr.iv443.i = phi i64 [ %lsr.iv.next444.i, %B316.i.i ], [ %.1709.sroa.0.3.i, %B56.preheader.i.i ]
  %lsr.iv.i.i = phi ptr [ %scevgep1.i.i, %B316.i.i ], [ %scevgep.i.i, %B56.preheader.i.i ]
  %scevgep6.i.i = getelementptr i8, ptr %lsr.iv.i.i, i64 -40
  %.227.i.i = load double, ptr %scevgep6.i.i, align 8, !noalias !25
  %scevgep5.i.i = getelementptr i8, ptr %lsr.iv.i.i, i64 -32
  %.282.i.i = load double, ptr %scevgep5.i.i, align 8, !noalias !25
  %.284.i.i = fmul double %.40.i.i, %.282.i.i
  %.285.i.i = fadd double %.227.i.i, %.284.i.i
  %scevgep4.i.i = getelementptr i8, ptr %lsr.iv.i.i, i64 -24
  %.347.i.i = load double, ptr %scevgep4.i.i, align 8, !noalias !25
  %.348.i.i = fcmp une double %.347.i.i, 0.000000e+00
  br i1 %.348.i.i, label %B134.i.i, label %B316.i.i
B134.i.i:
  %scevgep3.i.i = getelementptr i8, ptr %lsr.iv.i.i, i64 -16
  %.405.i.i = load double, ptr %scevgep3.i.i, align 8, !noalias !25
  %scevgep2.i.i = getelementptr i8, ptr %lsr.iv.i.i, i64 -8
  %.460.i.i = load double, ptr %scevgep2.i.i, align 8, !noalias !25
  %.461.i.i = fmul double %.460.i.i, 5.000000e-01
  %.463.i.i = fmul double %.40.i.i, %.461.i.i
  %.464.i.i = fadd double %.405.i.i, %.463.i.i
  %.465.i.i = fmul double %.464.i.i, 0x401921FB54442D18
  %.467.i.i = fmul double %.40.i.i, %.465.i.i
  %.522.i.i = load double, ptr %lsr.iv.i.i, align 8, !noalias !25
  %.523.i.i = fadd double %.522.i.i, %.467.i.i
  %.586.le.i.i = tail call double @llvm.sin.f64(double %.523.i.i)
  %.591.i.i = fmul double %.347.i.i, %.586.le.i.i
  %.593.i.i = fadd double %.285.i.i, %.591.i.i
  br label %B316.i.i
B316.i.i:
  %value.2.1.i.i = phi double [ %.593.i.i, %B134.i.i ], [ %.285.i.i, %B56.i.i ]
  %3 = shl i64 %lsr.iv443.i, 3
  %scevgep445.i = getelementptr i8, ptr %.1637.i, i64 %3
  store double %value.2.1.i.i, ptr %scevgep445.i, align 8, !noalias !25
  %scevgep1.i.i = getelementptr i8, ptr %lsr.iv.i.i, i64 48
  %lsr.iv.next444.i = add nuw i64 %lsr.iv443.i, 1
  %exitcond.not.i.i = icmp eq i64 %.1709.sroa.13.0.i, %lsr.iv.next444.i
  br i1 %exitcond.not.i.i, label %B1700.endif.i, label %B56.i.i
B1884.i:
  %4 = getelementptr i8, ptr %a6, i64 %.441531563164.i
  %.5190.i = load i8, ptr %4, align 1, !noalias !21
  %.5191.not.i = icmp eq i8 %.5190.i, 0
  %.5194.i = fneg double %h.3.03166.i
  %"$phi1908.1.2.1.i" = select i1 %.5191.not.i, double %h.3.03166.i, double %.5194.i
  %.5267.i = mul i64 %.441531563164.i, %.1277.i
  %.5269.i = getelementptr double, ptr %a5, i64 %.5267.i
  br i1 %51, label %B1922.i, label %B2088.i
B1922.i:
  call void @llvm.lifetime.start.p0(ptr nonnull %.4389.i.i), !noalias !21
  store i8 0, ptr %.4389.i.i, align 1, !noalias !28
  br i1 %55, label %B0.endif.else.endif.endif.endif.i.i, label %B0.endif.else.endif.if.i.i, !prof !31
B534.i.i:
  %.2404.i.i = fcmp olt double %.4486.i, %"$phi1578.1.2.1.i"
  br i1 %.2404.i.i, label %B548.preheader.i.i, label %_ZN6poppet6engine10integrator8_segmentB3v14B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
B548.preheader.i.i:
  %.5.i.i.i = fmul double %"$phi1578.1.2.1.i", 0x3D06849B86A12B9B
  %.6.i.i.i = fadd double %.5.i.i.i, 1.000000e-15
  %.4331.i.i = fsub double %"$phi1578.1.2.1.i", %.6.i.i.i
  %5 = fcmp ogt double %.1909.i.i, 0.000000e+00
  %invariant.gep.i.i3.i.i.i = getelementptr double, ptr %.1408.i.i, i64 %.1076.i.i
  %6 = icmp slt i64 %.1067.i.i, 1
  br label %B548.i.i
B548.i.i:
  %t.2.0.i.i = phi double [ %t.3.1.i.i, %B2324.else.if.i.i ], [ %.4486.i, %B548.preheader.i.i ]
  %h.6.0.i.i = phi double [ %h.7.1.i.i, %B2324.else.if.i.i ], [ %"$phi1908.1.2.1.i", %B548.preheader.i.i ]
  %error_before.2.0.i.i = phi double [ %error_before.3.1.i.i, %B2324.else.if.i.i ], [ 1.000000e-02, %B548.preheader.i.i ]
  %step_before.3.0.i.i = phi double [ %step_before.4.1.i.i, %B2324.else.if.i.i ], [ 0.000000e+00, %B548.preheader.i.i ]
  %rejected.3.0.i.i = phi i1 [ %rejected.4.1.i.i, %B2324.else.if.i.i ], [ false, %B548.preheader.i.i ]
  %fresh.3.0.i.i = phi i1 [ %fresh.4.1.i.i, %B2324.else.if.i.i ], [ true, %B548.preheader.i.i ]
  %window.2.0.i.i = phi double [ %window.3.1.i.i, %B2324.else.if.i.i ], [ %.4486.i, %B548.preheader.i.i ]
  %calm.2.0.i.i = phi double [ %calm.3.1.i.i, %B2324.else.if.i.i ], [ %.4486.i, %B548.preheader.i.i ]
  %first.3.0.i.i = phi double [ %first.4.1.i.i, %B2324.else.if.i.i ], [ 0.000000e+00, %B548.preheader.i.i ]
  %has_changed.3.0.i.i = phi i1 [ %has_changed.4.1.i.i, %B2324.else.if.i.i ], [ true, %B548.preheader.i.i ]
  %has_acted.4.0.i.i = phi i1 [ %has_acted.5.1.i.i, %B2324.else.if.i.i ], [ %.1974.i.i, %B548.preheader.i.i ]
  br i1 %fresh.3.0.i.i, label %B552.i.i, label %B646.i.i
B552.i.i:
  %.2456.i.i = load i64, ptr %a0, align 8, !noalias !28
  store double %t.2.0.i.i, ptr %.2336.i, align 8, !noalias !32
  %.40.i.i.i.i = fsub double %t.2.0.i.i, %.4486.i
  br i1 %50, label %B0.endif.i.i.i, label %B56.i.i.i.i
B56.i.i.i.i:
  %lsr.iv.i.i.i.i = phi ptr [ %scevgep1.i.i.i.i, %B316.i.i.i.i ], [ %scevgep.i172.i.i, %B552.i.i ]
  %.138222224.i.i.i.i = phi i64 [ %.145.i.i.i.i, %B316.i.i.i.i ], [ 0, %B552.i.i ]
  %.145.i.i.i.i = add nuw nsw i64 %.138222224.i.i.i.i, 1
  %scevgep6.i.i.i.i = getelementptr i8, ptr %lsr.iv.i.i.i.i, i64 -40
  %.227.i.i.i.i = load double, ptr %scevgep6.i.i.i.i, align 8, !noalias !35
  %scevgep5.i.i.i.i = getelementptr i8, ptr %lsr.iv.i.i.i.i, i64 -32
  %.282.i.i.i.i = load double, ptr %scevgep5.i.i.i.i, align 8, !noalias !35
  %.284.i.i.i.i = fmul double %.40.i.i.i.i, %.282.i.i.i.i
  %.285.i.i.i.i = fadd double %.227.i.i.i.i, %.284.i.i.i.i
  %scevgep4.i.i.i.i = getelementptr i8, ptr %lsr.iv.i.i.i.i, i64 -24
  %.347.i.i.i.i = load double, ptr %scevgep4.i.i.i.i, align 8, !noalias !35
  %.348.i.i.i.i = fcmp une double %.347.i.i.i.i, 0.000000e+00
  br i1 %.348.i.i.i.i, label %B134.i.i.i.i, label %B316.i.i.i.i
B134.i.i.i.i:
  %scevgep3.i.i.i.i = getelementptr i8, ptr %lsr.iv.i.i.i.i, i64 -16
  %.405.i.i.i.i = load double, ptr %scevgep3.i.i.i.i, align 8, !noalias !35
  %scevgep2.i.i.i.i = getelementptr i8, ptr %lsr.iv.i.i.i.i, i64 -8
  %.460.i.i.i.i = load double, ptr %scevgep2.i.i.i.i, align 8, !noalias !35
  %.461.i.i.i.i = fmul double %.460.i.i.i.i, 5.000000e-01
  %.463.i.i.i.i = fmul double %.40.i.i.i.i, %.461.i.i.i.i
  %.464.i.i.i.i = fadd double %.405.i.i.i.i, %.463.i.i.i.i
  %.465.i.i.i.i = fmul double %.464.i.i.i.i, 0x401921FB54442D18
  %.467.i.i.i.i = fmul double %.40.i.i.i.i, %.465.i.i.i.i
  %.522.i.i.i.i = load double, ptr %lsr.iv.i.i.i.i, align 8, !noalias !35
  %.523.i.i.i.i = fadd double %.522.i.i.i.i, %.467.i.i.i.i
  %.586.le.i.i.i.i = tail call double @llvm.sin.f64(double %.523.i.i.i.i)
  %.591.i.i.i.i = fmul double %.347.i.i.i.i, %.586.le.i.i.i.i
  %.593.i.i.i.i = fadd double %.285.i.i.i.i, %.591.i.i.i.i
  br label %B316.i.i.i.i
B316.i.i.i.i:
  %value.2.1.i.i.i.i = phi double [ %.593.i.i.i.i, %B134.i.i.i.i ], [ %.285.i.i.i.i, %B56.i.i.i.i ]
  %7 = shl i64 %.138222224.i.i.i.i, 3
  %scevgep7.i.i.i.i = getelementptr i8, ptr %.1822.i, i64 %7
  store double %value.2.1.i.i.i.i, ptr %scevgep7.i.i.i.i, align 8, !noalias !35
  %scevgep1.i.i.i.i = getelementptr i8, ptr %lsr.iv.i.i.i.i, i64 48
  %exitcond.not.i.i.i.i = icmp eq i64 %.1797.i, %.145.i.i.i.i
  br i1 %exitcond.not.i.i.i.i, label %B0.endif.i.i.i, label %B56.i.i.i.i
B148.i.i.i:
  %.356.i.i.i = fsub double %"$phi1578.1.2.1.i", %t.2.0.i.i
  %.56.i.i.i.i = fdiv double 2.000000e+01, %.356.i.i.i
  br i1 %60, label %B148.endif.i.i.i, label %B66.backedge.i.i.i.i
B66.backedge.i.i.i.i:
  %fastest.2.0128.i.i.i.i = phi double [ %.13.i.i.i.i.i, %B66.backedge.i.i.i.i ], [ %.56.i.i.i.i, %B148.i.i.i ]
  %.162124126.i.i.i.i = phi i64 [ %.169.i.i.i.i, %B66.backedge.i.i.i.i ], [ 0, %B148.i.i.i ]
  %8 = shl i64 %.162124126.i.i.i.i, 3
  %scevgep3.i1.i.i.i = getelementptr i8, ptr %.1465.i, i64 %8
  %.223.i.i.i.i = load double, ptr %scevgep3.i1.i.i.i, align 8, !noalias !38
  %.224.i.i.i.i = tail call double @llvm.fabs.f64(double %.223.i.i.i.i)
  %.225.i.i.i.i = fmul double %.224.i.i.i.i, 2.000000e+01
  %scevgep2.i2.i.i.i = getelementptr i8, ptr %a2, i64 %8
  %.255.i.i.i.i = load double, ptr %scevgep2.i2.i.i.i, align 8, !noalias !38
  %.256.i.i.i.i = tail call double @llvm.fabs.f64(double %.255.i.i.i.i)
  %scevgep228.i.i = getelementptr i8, ptr %57, i64 %8
  %.310.i.i.i.i = load double, ptr %scevgep228.i.i, align 8, !noalias !38
  %.311.i.i.i.i = fadd double %.256.i.i.i.i, %.310.i.i.i.i
  %.315.i.i.i.i = fdiv double %.225.i.i.i.i, %.311.i.i.i.i
  %.12.i.i.i.i.i = fcmp ogt double %.315.i.i.i.i, %fastest.2.0128.i.i.i.i
  %.13.i.i.i.i.i = select i1 %.12.i.i.i.i.i, double %.315.i.i.i.i, double %fastest.2.0128.i.i.i.i
  %.169.i.i.i.i = add nuw nsw i64 %.162124126.i.i.i.i, 1
  %exitcond.not.i4.i.i.i = icmp eq i64 %.27.i, %.169.i.i.i.i
  br i1 %exitcond.not.i4.i.i.i, label %B148.endif.i.i.i, label %B66.backedge.i.i.i.i
B202.i.i.i:
  %.420.i.i.i = fneg double %h.6.0.i.i
  %.12.i.i.i.i = fcmp olt double %.373.i.i.i.i, %.420.i.i.i
  %.13.i.i.i.i = select i1 %.12.i.i.i.i, double %.373.i.i.i.i, double %.420.i.i.i
  br label %B646.i.i
B0.endif.i.i.i:
  br i1 %59, label %B0.endif.endif.i.i.i, label %B56.i8.i.i.i
B56.i8.i.i.i:
  %lsr.iv.i9.i.i.i = phi ptr [ %scevgep1.i15.i.i.i, %B370.i.i.i.i ], [ %scevgep.i172.i.i, %B0.endif.i.i.i ]
  %.138242244.i.i.i.i = phi i64 [ %.145.i10.i.i.i, %B370.i.i.i.i ], [ 0, %B0.endif.i.i.i ]
  %.145.i10.i.i.i = add nuw nsw i64 %.138242244.i.i.i.i, 1
  %scevgep5.i11.i.i.i = getelementptr i8, ptr %lsr.iv.i9.i.i.i, i64 -32
  %.227.i12.i.i.i = load double, ptr %scevgep5.i11.i.i.i, align 8, !noalias !41
  %scevgep4.i13.i.i.i = getelementptr i8, ptr %lsr.iv.i9.i.i.i, i64 -24
  %.289.i.i.i.i = load double, ptr %scevgep4.i13.i.i.i, align 8, !noalias !41
  %.290.i.i.i.i = fcmp une double %.289.i.i.i.i, 0.000000e+00
  br i1 %.290.i.i.i.i, label %B106.i.i.i.i, label %B370.i.i.i.i
B106.i.i.i.i:
  %scevgep3.i17.i.i.i = getelementptr i8, ptr %lsr.iv.i9.i.i.i, i64 -16
  %.347.i18.i.i.i = load double, ptr %scevgep3.i17.i.i.i, align 8, !noalias !41
  %scevgep2.i19.i.i.i = getelementptr i8, ptr %lsr.iv.i9.i.i.i, i64 -8
  %.402.i.i.i.i = load double, ptr %scevgep2.i19.i.i.i, align 8, !noalias !41
  %.403.i.i.i.i = fmul double %.402.i.i.i.i, 5.000000e-01
  %.405.i20.i.i.i = fmul double %.40.i.i.i.i, %.403.i.i.i.i
  %.406.i.i.i.i = fadd double %.347.i18.i.i.i, %.405.i20.i.i.i
  %.407.i.i.i.i = fmul double %.406.i.i.i.i, 0x401921FB54442D18
  %.409.i.i.i.i = fmul double %.40.i.i.i.i, %.407.i.i.i.i
  %.464.i21.i.i.i = load double, ptr %lsr.iv.i9.i.i.i, align 8, !noalias !41
  %.465.i22.i.i.i = fadd double %.464.i21.i.i.i, %.409.i.i.i.i
  %.578.i.i.i.i = fmul double %.40.i.i.i.i, %.402.i.i.i.i
  %.579.i.i.i.i = fadd double %.347.i18.i.i.i, %.578.i.i.i.i
  %.580.i.i.i.i = fmul double %.579.i.i.i.i, 0x401921FB54442D18
  %.636.i.i.i.i = fmul double %.289.i.i.i.i, %.580.i.i.i.i
  %.644.le.i.i.i.i = tail call double @llvm.cos.f64(double %.465.i22.i.i.i)
  %.649.i.i.i.i = fmul double %.636.i.i.i.i, %.644.le.i.i.i.i
  %.651.i.i.i.i = fadd double %.227.i12.i.i.i, %.649.i.i.i.i
  br label %B370.i.i.i.i
B370.i.i.i.i:
  %slope.2.1.i.i.i.i = phi double [ %.651.i.i.i.i, %B106.i.i.i.i ], [ %.227.i12.i.i.i, %B56.i8.i.i.i ]
  %9 = shl i64 %.138242244.i.i.i.i, 3
  %scevgep6.i14.i.i.i = getelementptr i8, ptr %.2165.i, i64 %9
  store double %slope.2.1.i.i.i.i, ptr %scevgep6.i14.i.i.i, align 8, !noalias !41
  %scevgep1.i15.i.i.i = getelementptr i8, ptr %lsr.iv.i9.i.i.i, i64 48
  %exitcond.not.i16.i.i.i = icmp eq i64 %.2140.i, %.145.i10.i.i.i
  br i1 %exitcond.not.i16.i.i.i, label %B0.endif.endif.i.i.i, label %B56.i8.i.i.i
B0.endif.endif.i.i.i:
  %.304.i.i.i = inttoptr i64 %.2456.i.i to ptr
  tail call void %.304.i.i.i(ptr nonnull %.2336.i, ptr %a2, ptr %.1822.i, ptr %.2165.i, ptr %a3, ptr %.1465.i, ptr %.2818.i, ptr %.748.i.i), !noalias !32
  %.325.i.i.i = fcmp ogt double %h.6.0.i.i, 0.000000e+00
  br i1 %.325.i.i.i, label %B646.i.i, label %B148.i.i.i
B148.endif.i.i.i:
  %fastest.2.0.lcssa.i.i.i.i = phi double [ %.56.i.i.i.i, %B148.i.i.i ], [ %.13.i.i.i.i.i, %B66.backedge.i.i.i.i ]
  %.373.i.i.i.i = fdiv double 1.000000e+00, %fastest.2.0.lcssa.i.i.i.i
  %.417.i.i.i = fcmp olt double %h.6.0.i.i, 0.000000e+00
  br i1 %.417.i.i.i, label %B202.i.i.i, label %B646.i.i
B646.i.i:
  %h.9.1.i.i = phi double [ %h.6.0.i.i, %B548.i.i ], [ %.13.i.i.i.i, %B202.i.i.i ], [ %.373.i.i.i.i, %B148.endif.i.i.i ], [ %h.6.0.i.i, %B0.endif.endif.i.i.i ]
  %.2558.i.i = load double, ptr %a10, align 8, !noalias !28
  %.12.i.i3.i.i = fcmp olt double %.2558.i.i, %h.9.1.i.i
  %.13.i.i4.i.i = select i1 %.12.i.i3.i.i, double %.2558.i.i, double %h.9.1.i.i
  br i1 %.not.i.i, label %_ZN6poppet6engine10integrator6_reachB3v20B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdddddb5ArrayIdLi1E1C7mutable7alignedEx.exit.i.i, label %B58.backedge.preheader.i.i.i.i
B58.backedge.preheader.i.i.i.i:
  br i1 %53, label %B58.backedge.epil.preheader.i.i.i.i, label %B58.backedge.i.i.i.i
B58.backedge.i.i.i.i:
  %first.2.065.i.i.i.i = phi double [ %.13.i.3.i.i.i.i, %B58.backedge.i.i.i.i ], [ 0x7FF0000000000000, %B58.backedge.preheader.i.i.i.i ]
  %.1096163.i.i.i.i = phi i64 [ %.116.3.i.i.i.i, %B58.backedge.i.i.i.i ], [ 0, %B58.backedge.preheader.i.i.i.i ]
  %sunkaddr.i.i.i = shl i64 %.1096163.i.i.i.i, 3
  %sunkaddr10.i.i.i = getelementptr i8, ptr %.1186.i, i64 %sunkaddr.i.i.i
  %.170.i.i.i.i = load double, ptr %sunkaddr10.i.i.i, align 8, !noalias !44
  %.12.i.i.i5.i.i = fcmp olt double %.170.i.i.i.i, %first.2.065.i.i.i.i
  %.13.i.i.i6.i.i = select i1 %.12.i.i.i5.i.i, double %.170.i.i.i.i, double %first.2.065.i.i.i.i
  %sunkaddr13.i.i.i = getelementptr i8, ptr %sunkaddr10.i.i.i, i64 8
  %.170.1.i.i.i.i = load double, ptr %sunkaddr13.i.i.i, align 8, !noalias !44
  %.12.i.1.i.i.i.i = fcmp olt double %.170.1.i.i.i.i, %.13.i.i.i6.i.i
  %.13.i.1.i.i.i.i = select i1 %.12.i.1.i.i.i.i, double %.170.1.i.i.i.i, double %.13.i.i.i6.i.i
  %sunkaddr16.i.i.i = getelementptr i8, ptr %sunkaddr10.i.i.i, i64 16
  %.170.2.i.i.i.i = load double, ptr %sunkaddr16.i.i.i, align 8, !noalias !44
  %.12.i.2.i.i.i.i = fcmp olt double %.170.2.i.i.i.i, %.13.i.1.i.i.i.i
  %.13.i.2.i.i.i.i = select i1 %.12.i.2.i.i.i.i, double %.170.2.i.i.i.i, double %.13.i.1.i.i.i.i
  %sunkaddr19.i.i.i = getelementptr i8, ptr %sunkaddr10.i.i.i, i64 24
  %.170.3.i.i.i.i = load double, ptr %sunkaddr19.i.i.i, align 8, !noalias !44
  %.12.i.3.i.i.i.i = fcmp olt double %.170.3.i.i.i.i, %.13.i.2.i.i.i.i
  %.13.i.3.i.i.i.i = select i1 %.12.i.3.i.i.i.i, double %.170.3.i.i.i.i, double %.13.i.2.i.i.i.i
  %.116.3.i.i.i.i = add nuw nsw i64 %.1096163.i.i.i.i, 4
  %niter.ncmp.3.i.i.i.i = icmp eq i64 %unroll_iter.i.i.i, %.116.3.i.i.i.i
  br i1 %niter.ncmp.3.i.i.i.i, label %common.ret.loopexit.unr-lcssa.i.i.i.i, label %B58.backedge.i.i.i.i
common.ret.loopexit.unr-lcssa.i.i.i.i:
  br i1 %54, label %B52.endif.endif.i.i.i, label %B58.backedge.epil.preheader.i.i.i.i
B58.backedge.epil.preheader.i.i.i.i:
  %first.2.065.epil.init.i.i.i.i = phi double [ 0x7FF0000000000000, %B58.backedge.preheader.i.i.i.i ], [ %.13.i.3.i.i.i.i, %common.ret.loopexit.unr-lcssa.i.i.i.i ]
  %.1096163.epil.init.i.i.i.i = phi i64 [ 0, %B58.backedge.preheader.i.i.i.i ], [ %unroll_iter.i.i.i, %common.ret.loopexit.unr-lcssa.i.i.i.i ]
  %10 = shl i64 %.1096163.epil.init.i.i.i.i, 3
  %scevgep.i.i.i.i = getelementptr i8, ptr %.1186.i, i64 %10
  br label %B58.backedge.epil.i.i.i.i
B58.backedge.epil.i.i.i.i:
  %first.2.065.epil.i.i.i.i = phi double [ %.13.i.epil.i.i.i.i, %B58.backedge.epil.i.i.i.i ], [ %first.2.065.epil.init.i.i.i.i, %B58.backedge.epil.preheader.i.i.i.i ]
  %epil.iter.i.i.i.i = phi i64 [ %epil.iter.next.i.i.i.i, %B58.backedge.epil.i.i.i.i ], [ 0, %B58.backedge.epil.preheader.i.i.i.i ]
  %11 = shl i64 %epil.iter.i.i.i.i, 3
  %scevgep.i.i.i = getelementptr i8, ptr %scevgep.i.i.i.i, i64 %11
  %.170.epil.i.i.i.i = load double, ptr %scevgep.i.i.i, align 8, !noalias !44
  %.12.i.epil.i.i.i.i = fcmp olt double %.170.epil.i.i.i.i, %first.2.065.epil.i.i.i.i
  %.13.i.epil.i.i.i.i = select i1 %.12.i.epil.i.i.i.i, double %.170.epil.i.i.i.i, double %first.2.065.epil.i.i.i.i
  %epil.iter.next.i.i.i.i = add i64 %epil.iter.i.i.i.i, 1
  %epil.iter.cmp.not.i.i.i.i = icmp eq i64 %xtraiter.i.i.i, %epil.iter.next.i.i.i.i
  br i1 %epil.iter.cmp.not.i.i.i.i, label %B52.endif.endif.i.i.i, label %B58.backedge.epil.i.i.i.i, !llvm.loop !49
B152.i.i.i:
  %.169.i.i.i = fsub double %first.2.0.lcssa.i.i.i.i, %t.2.0.i.i
  %.172.i.i.i = fsub double %t.2.0.i.i, %calm.2.0.i.i
  %.173.i.i.i = fcmp ult double %.169.i.i.i, %.172.i.i.i
  br i1 %.173.i.i.i, label %B184.i8.i.i, label %_ZN6poppet6engine10integrator6_reachB3v20B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdddddb5ArrayIdLi1E1C7mutable7alignedEx.exit.i.i
B184.i8.i.i:
  %.12.i1.i9.i.i = fcmp olt double %.172.i.i.i, %.13.i.i4.i.i
  %.13.i2.i10.i.i = select i1 %.12.i1.i9.i.i, double %.172.i.i.i, double %.13.i.i4.i.i
  br label %_ZN6poppet6engine10integrator6_reachB3v20B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdddddb5ArrayIdLi1E1C7mutable7alignedEx.exit.i.i
B52.endif.endif.i.i.i:
  %first.2.0.lcssa.i.i.i.i = phi double [ %.13.i.3.i.i.i.i, %common.ret.loopexit.unr-lcssa.i.i.i.i ], [ %.13.i.epil.i.i.i.i, %B58.backedge.epil.i.i.i.i ]
  %.159.i.i.i = fcmp uge double %first.2.0.lcssa.i.i.i.i, %.4331.i.i
  %12 = or i1 %49, %.159.i.i.i
  %brmerge68.i.i = select i1 %12, i1 true, i1 %.1945.i.i
  %arg.stop.mux.i.i = select i1 %.159.i.i.i, double %"$phi1578.1.2.1.i", double %first.2.0.lcssa.i.i.i.i
  br i1 %brmerge68.i.i, label %_ZN6poppet6engine10integrator6_reachB3v20B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdddddb5ArrayIdLi1E1C7mutable7alignedEx.exit.i.i, label %B152.i.i.i
_ZN6poppet6engine10integrator6_reachB3v20B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdddddb5ArrayIdLi1E1C7mutable7alignedEx.exit.i.i:
  %wanted.2.0.sink.i.i.i = phi double [ %.13.i2.i10.i.i, %B184.i8.i.i ], [ %.13.i.i4.i.i, %B152.i.i.i ], [ %.13.i.i4.i.i, %B646.i.i ], [ %.13.i.i4.i.i, %B52.endif.endif.i.i.i ]
  %arg.stop.sink.i.i.i = phi double [ %"$phi1578.1.2.1.i", %B184.i8.i.i ], [ %first.2.0.lcssa.i.i.i.i, %B152.i.i.i ], [ %"$phi1578.1.2.1.i", %B646.i.i ], [ %arg.stop.mux.i.i, %B52.endif.endif.i.i.i ]
  br i1 %5, label %B722.i.i, label %B774.i.i
B722.i.i:
  %.2647.i.i = load i64, ptr %a17, align 8, !noalias !28
  %.2650.i.i = fsub double %arg.stop.sink.i.i.i, %t.2.0.i.i
  %.13.i.i147.i.i = tail call i64 @llvm.smin.i64(i64 %.26.i.i.i, i64 %.2647.i.i)
  %.69.i.i.i = icmp slt i64 %.13.i.i147.i.i, 0
  %.70.i.i.i = select i1 %.69.i.i.i, i64 %.977.i, i64 0
  %13 = getelementptr double, ptr %a19, i64 %.13.i.i147.i.i
  %.84.i.i.i = getelementptr double, ptr %13, i64 %.70.i.i.i
  %.85.i.i.i = load double, ptr %.84.i.i.i, align 8, !noalias !50
  %.93.i.i.i = fcmp ole double %.85.i.i.i, 0.000000e+00
  %.97.i.i.i = fcmp oge double %.85.i.i.i, %.2650.i.i
  %or.cond.i.i.i = select i1 %.93.i.i.i, i1 true, i1 %.97.i.i.i
  %"$phi94.0.2.0.i.i.i" = select i1 %or.cond.i.i.i, double %.2650.i.i, double %.85.i.i.i
  br label %B820.i.i
B774.i.i:
  %.2684.i.i = fsub double %arg.stop.sink.i.i.i, %t.2.0.i.i
  %.11.i.i.i = fmul double %.2684.i.i, 5.000000e-01
  %.13.i.i.i = fcmp olt double %wanted.2.0.sink.i.i.i, %.11.i.i.i
  %.24.i.i.i = fcmp olt double %wanted.2.0.sink.i.i.i, %.2684.i.i
  %"$phi50.0.2.0.i.i.i" = select i1 %.24.i.i.i, double %.11.i.i.i, double %.2684.i.i
  %storemerge.i148.i.i = select i1 %.13.i.i.i, double %wanted.2.0.sink.i.i.i, double %"$phi50.0.2.0.i.i.i"
  br label %B820.i.i
B820.i.i:
  %"$phi820.0.2.1.in.sroa.speculated.i.i" = phi double [ %"$phi94.0.2.0.i.i.i", %B722.i.i ], [ %storemerge.i148.i.i, %B774.i.i ]
  br i1 %exitcond.not.i169.i.i, label %B980.i.i, label %switch.lookup.i.i
B980.i.i:
  %.3106.i.i = fsub double %arg.stop.sink.i.i.i, %t.2.0.i.i
  %.3107.i.i = fmul double %.3106.i.i, 0x3FEFFFFFFFFFDCD1
  %.3109.i.i = fcmp oge double %"$phi820.0.2.1.in.sroa.speculated.i.i", %.3107.i.i
  %.3118.i.i = fadd double %t.2.0.i.i, %"$phi820.0.2.1.in.sroa.speculated.i.i"
  %"$phi1016.0.2.1.i.i" = select i1 %.3109.i.i, double %arg.stop.sink.i.i.i, double %.3118.i.i
  store double %t.2.0.i.i, ptr %.2336.i, align 8, !noalias !28
  store double %"$phi820.0.2.1.in.sroa.speculated.i.i", ptr %sunkaddr.i2.i, align 8, !noalias !28
  %.3219.i.i = load i64, ptr %sunkaddr234.i.i, align 8, !noalias !28
  %.3290.i.i = inttoptr i64 %.3219.i.i to ptr
  tail call void %.3290.i.i(ptr nonnull %.2336.i, ptr %a2, ptr %.1993.i, ptr %a3, ptr %.1465.i, ptr %.2818.i, ptr %.748.i.i, ptr %.3186.i, ptr %.1579.i.i, ptr %.920.i.i), !noalias !28
  br i1 %60, label %B1016.endif.thread234.i.i, label %B62.i.i.i
B1016.endif.thread234.i.i:
  %.3365236.i.i = load i64, ptr %sunkaddr246.i.i, align 8, !noalias !28
  %.3366237.i.i = add nsw i64 %.3365236.i.i, 1
  store i64 %.3366237.i.i, ptr %sunkaddr246.i.i, align 8, !noalias !28
  br label %B1262.i.i
B62.i.i.i:
  %worst.2.0263.i.i.i = phi double [ %worst.3.1.i.i.i, %B176.endif.i.i.i ], [ 0.000000e+00, %B980.i.i ]
  %.185258261.i.i.i = phi i64 [ %.192.i.i.i, %B176.endif.i.i.i ], [ 0, %B980.i.i ]
  %.192.i.i.i = add nuw nsw i64 %.185258261.i.i.i, 1
  %14 = shl i64 %.185258261.i.i.i, 3
  %scevgep5.i.i.i = getelementptr i8, ptr %.920.i.i, i64 %14
  %.250.i.i.i = load double, ptr %scevgep5.i.i.i, align 8, !noalias !53
  %.262.le.i.i.i = fsub double %.250.i.i.i, %.250.i.i.i
  %.263.le.i.i.i = fcmp ord double %.262.le.i.i.i, 0.000000e+00
  br i1 %.263.le.i.i.i, label %B120.i.i.i, label %B1016.endif.thread.i.i
B120.i.i.i:
  %15 = getelementptr i8, ptr %a9, i64 %.185258261.i.i.i
  %.308.i.i.i = load i8, ptr %15, align 1, !noalias !53
  %.309.i.i.i = icmp ne i8 %.308.i.i.i, 0
  %.312.i.i.i = fcmp ole double %.250.i.i.i, 0.000000e+00
  %or.cond.i151.i.i = and i1 %.312.i.i.i, %.309.i.i.i
  br i1 %or.cond.i151.i.i, label %B1016.endif.thread.i.i, label %B176.endif.i.i.i
B176.endif.i.i.i:
  %scevgep232.i.i = getelementptr i8, ptr %.1750.i.i, i64 %14
  %.385.i.i.i = load double, ptr %scevgep232.i.i, align 8, !noalias !53
  %scevgep231.i.i = getelementptr i8, ptr %scevgep230.i.i, i64 %14
  %.441.i.i.i = load double, ptr %scevgep231.i.i, align 8, !noalias !53
  %scevgep229.i.i = getelementptr i8, ptr %a8, i64 %14
  %.496.i.i.i = load double, ptr %scevgep229.i.i, align 8, !noalias !53
  %scevgep.i3.i = getelementptr i8, ptr %a2, i64 %14
  %.527.i.i.i = load double, ptr %scevgep.i3.i, align 8, !noalias !53
  %.530.i.i.i = tail call double @llvm.fabs.f64(double %.527.i.i.i)
  %.532.i.i.i = tail call double @llvm.fabs.f64(double %.250.i.i.i)
  %.12.i.i153.i.i = fcmp ogt double %.532.i.i.i, %.530.i.i.i
  %.13.i.i154.i.i = select i1 %.12.i.i153.i.i, double %.532.i.i.i, double %.530.i.i.i
  %.386.i.i.i = tail call double @llvm.fabs.f64(double %.385.i.i.i)
  %.563.i.i.i = fmul double %.496.i.i.i, %.13.i.i154.i.i
  %.564.i.i.i = fadd double %.441.i.i.i, %.563.i.i.i
  %.568.i.i.i = fdiv double %.386.i.i.i, %.564.i.i.i
  %.574.i.i.i = fcmp ole double %.568.i.i.i, %worst.2.0263.i.i.i
  %worst.3.1.i.i.i = select i1 %.574.i.i.i, double %worst.2.0263.i.i.i, double %.568.i.i.i
  %exitcond.not.i.i.i = icmp eq i64 %.27.i, %.192.i.i.i
  br i1 %exitcond.not.i.i.i, label %B1016.endif.i.i, label %B62.i.i.i
B1214.i.i:
  %storemerge.i150232.i.i = phi double [ 0x7FF0000000000000, %B1016.endif.thread.i.i ], [ %worst.3.1.i.i.i, %B1016.endif.i.i ]
  %.3410.le.i.i = fsub double %storemerge.i150232.i.i, %storemerge.i150232.i.i
  %.3411.le.i.i = fcmp ord double %.3410.le.i.i, 0.000000e+00
  %or.cond3295.i.i = select i1 %5, i1 %.3411.le.i.i, i1 false
  br i1 %or.cond3295.i.i, label %B1340.i.i, label %for.end.1.i.i
B1262.i.i:
  %storemerge.i150239.i.i = phi double [ 0.000000e+00, %B1016.endif.thread234.i.i ], [ %worst.3.1.i.i.i, %B1016.endif.i.i ]
  %.3457.i.i = load i64, ptr %a17, align 8, !noalias !28
  %.3465.i.i = icmp sge i64 %.3457.i.i, %.977.i
  %brmerge.i.i = or i1 %5, %.3465.i.i
  br i1 %brmerge.i.i, label %B1340.i.i, label %B1300.i.i
B1300.i.i:
  %.3471.i.i = fcmp oeq double %"$phi1016.0.2.1.i.i", %arg.stop.sink.i.i.i
  %.3476.i.i = fneg double %"$phi820.0.2.1.in.sroa.speculated.i.i"
  %"$phi1320.0.2.2.i.i" = select i1 %.3471.i.i, double %.3476.i.i, double %"$phi820.0.2.1.in.sroa.speculated.i.i"
  %.3529.i.i = icmp slt i64 %.3457.i.i, 0
  %.3530.i.i = select i1 %.3529.i.i, i64 %.977.i, i64 0
  %16 = getelementptr double, ptr %a19, i64 %.3457.i.i
  %.3544.i.i = getelementptr double, ptr %16, i64 %.3530.i.i
  store double %"$phi1320.0.2.2.i.i", ptr %.3544.i.i, align 8, !noalias !28
  br label %B1340.i.i
B1340.i.i:
  %storemerge.i150233.i.i = phi double [ %storemerge.i150232.i.i, %B1214.i.i ], [ %storemerge.i150239.i.i, %B1262.i.i ], [ %storemerge.i150239.i.i, %B1300.i.i ]
  call void @llvm.lifetime.start.p0(ptr nonnull %.1003.i.i.i), !noalias !28
  br i1 %.not.i.i, label %B126.i.i.i, label %B58.backedge.preheader.i.i11.i.i
B58.backedge.preheader.i.i11.i.i:
  br i1 %53, label %B58.backedge.epil.preheader.i.i38.i.i, label %B58.backedge.i.i15.i.i
B58.backedge.i.i15.i.i:
  %first.2.065.i.i16.i.i = phi double [ %.13.i.3.i.i33.i.i, %B58.backedge.i.i15.i.i ], [ 0x7FF0000000000000, %B58.backedge.preheader.i.i11.i.i ]
  %.1096163.i.i17.i.i = phi i64 [ %.116.3.i.i34.i.i, %B58.backedge.i.i15.i.i ], [ 0, %B58.backedge.preheader.i.i11.i.i ]
  %sunkaddr.i18.i.i = shl i64 %.1096163.i.i17.i.i, 3
  %sunkaddr13.i19.i.i = getelementptr i8, ptr %.1186.i, i64 %sunkaddr.i18.i.i
  %.170.i.i20.i.i = load double, ptr %sunkaddr13.i19.i.i, align 8, !noalias !56
  %.12.i.i.i21.i.i = fcmp olt double %.170.i.i20.i.i, %first.2.065.i.i16.i.i
  %.13.i.i.i22.i.i = select i1 %.12.i.i.i21.i.i, double %.170.i.i20.i.i, double %first.2.065.i.i16.i.i
  %sunkaddr16.i23.i.i = getelementptr i8, ptr %sunkaddr13.i19.i.i, i64 8
  %.170.1.i.i24.i.i = load double, ptr %sunkaddr16.i23.i.i, align 8, !noalias !56
  %.12.i.1.i.i25.i.i = fcmp olt double %.170.1.i.i24.i.i, %.13.i.i.i22.i.i
  %.13.i.1.i.i26.i.i = select i1 %.12.i.1.i.i25.i.i, double %.170.1.i.i24.i.i, double %.13.i.i.i22.i.i
  %sunkaddr19.i27.i.i = getelementptr i8, ptr %sunkaddr13.i19.i.i, i64 16
  %.170.2.i.i28.i.i = load double, ptr %sunkaddr19.i27.i.i, align 8, !noalias !56
  %.12.i.2.i.i29.i.i = fcmp olt double %.170.2.i.i28.i.i, %.13.i.1.i.i26.i.i
  %.13.i.2.i.i30.i.i = select i1 %.12.i.2.i.i29.i.i, double %.170.2.i.i28.i.i, double %.13.i.1.i.i26.i.i
  %sunkaddr22.i.i.i = getelementptr i8, ptr %sunkaddr13.i19.i.i, i64 24
  %.170.3.i.i31.i.i = load double, ptr %sunkaddr22.i.i.i, align 8, !noalias !56
  %.12.i.3.i.i32.i.i = fcmp olt double %.170.3.i.i31.i.i, %.13.i.2.i.i30.i.i
  %.13.i.3.i.i33.i.i = select i1 %.12.i.3.i.i32.i.i, double %.170.3.i.i31.i.i, double %.13.i.2.i.i30.i.i
  %.116.3.i.i34.i.i = add nuw nsw i64 %.1096163.i.i17.i.i, 4
  %niter.ncmp.3.i.i35.i.i = icmp eq i64 %unroll_iter.i.i.i, %.116.3.i.i34.i.i
  br i1 %niter.ncmp.3.i.i35.i.i, label %common.ret.loopexit.unr-lcssa.i.i36.i.i, label %B58.backedge.i.i15.i.i
common.ret.loopexit.unr-lcssa.i.i36.i.i:
  br i1 %54, label %B26.endif.endif.i.i.i, label %B58.backedge.epil.preheader.i.i38.i.i
B58.backedge.epil.preheader.i.i38.i.i:
  %first.2.065.epil.init.i.i39.i.i = phi double [ 0x7FF0000000000000, %B58.backedge.preheader.i.i11.i.i ], [ %.13.i.3.i.i33.i.i, %common.ret.loopexit.unr-lcssa.i.i36.i.i ]
  %.1096163.epil.init.i.i40.i.i = phi i64 [ 0, %B58.backedge.preheader.i.i11.i.i ], [ %unroll_iter.i.i.i, %common.ret.loopexit.unr-lcssa.i.i36.i.i ]
  %17 = shl i64 %.1096163.epil.init.i.i40.i.i, 3
  %scevgep.i.i41.i.i = getelementptr i8, ptr %.1186.i, i64 %17
  br label %B58.backedge.epil.i.i42.i.i
B58.backedge.epil.i.i42.i.i:
  %first.2.065.epil.i.i43.i.i = phi double [ %.13.i.epil.i.i47.i.i, %B58.backedge.epil.i.i42.i.i ], [ %first.2.065.epil.init.i.i39.i.i, %B58.backedge.epil.preheader.i.i38.i.i ]
  %epil.iter.i.i44.i.i = phi i64 [ %epil.iter.next.i.i48.i.i, %B58.backedge.epil.i.i42.i.i ], [ 0, %B58.backedge.epil.preheader.i.i38.i.i ]
  %18 = shl i64 %epil.iter.i.i44.i.i, 3
  %scevgep7.i.i.i = getelementptr i8, ptr %scevgep.i.i41.i.i, i64 %18
  %.170.epil.i.i45.i.i = load double, ptr %scevgep7.i.i.i, align 8, !noalias !56
  %.12.i.epil.i.i46.i.i = fcmp olt double %.170.epil.i.i45.i.i, %first.2.065.epil.i.i43.i.i
  %.13.i.epil.i.i47.i.i = select i1 %.12.i.epil.i.i46.i.i, double %.170.epil.i.i45.i.i, double %first.2.065.epil.i.i43.i.i
  %epil.iter.next.i.i48.i.i = add i64 %epil.iter.i.i44.i.i, 1
  %epil.iter.cmp.not.i.i49.i.i = icmp eq i64 %xtraiter.i.i.i, %epil.iter.next.i.i48.i.i
  br i1 %epil.iter.cmp.not.i.i49.i.i, label %B26.endif.endif.i.i.i, label %B58.backedge.epil.i.i42.i.i, !llvm.loop !61
B126.i.i.i:
  %"$phi126.0.2.0.i.i.i" = phi i1 [ %.423.i.i.i, %B26.endif.endif.i.i.i ], [ false, %B1340.i.i ]
  %.478.i.i.i = load i64, ptr %sunkaddr468.i, align 8, !noalias !62
  %brmerge.i53.i.i = select i1 %49, i1 true, i1 %"$phi126.0.2.0.i.i.i"
  br i1 %brmerge.i53.i.i, label %B302.i.i.i, label %B200.i.i.i
B200.i.i.i:
  %.522.i54.i.i = load i64, ptr %sunkaddr.i6.i, align 8, !noalias !62
  %.536.i.i.i = icmp slt i64 %.522.i54.i.i, 0
  %.537.i.i.i = select i1 %.536.i.i.i, i64 %.71.i, i64 0
  %19 = getelementptr double, ptr %a7, i64 %.522.i54.i.i
  %.551.i.i.i = getelementptr double, ptr %19, i64 %.537.i.i.i
  %.552.i.i.i = load double, ptr %.551.i.i.i, align 8, !noalias !62
  %.554.i.i.i = fcmp olt double %.552.i.i.i, %"$phi1016.0.2.1.i.i"
  br i1 %.554.i.i.i, label %B302.i.i.i, label %B426.i.i.i
B302.i.i.i:
  %.585.i.i.i = load i64, ptr %.584.i.i.i, align 8, !noalias !62
  %.600.i.i.i = inttoptr i64 %.585.i.i.i to ptr
  tail call void %.600.i.i.i(ptr %.1579.i.i, ptr %.1408.i.i), !noalias !62
  br i1 %49, label %B306.i.i.i, label %B426.i.i.i
B306.i.i.i:
  %.556.i.i.i.i = fmul double %.3118.i.i, 4.000000e-16
  %20 = inttoptr i64 %.478.i.i.i to ptr
  br label %B18.outer.i.i.i.i
B18.outer.i.i.i.i:
  %low.4.1.ph.i.i.i.i = phi double [ 0.000000e+00, %B306.i.i.i ], [ %low.3.2.i.i.i.i, %B240.i.i.i.i ]
  %high.3.1.ph.i.i.i.i = phi double [ 5.000000e-01, %B306.i.i.i ], [ %.544.i.i.i.i, %B240.i.i.i.i ]
  %event.2.1.ph.i.i.i.i = phi i64 [ -1, %B306.i.i.i ], [ %event.4.2.i.i.i.i, %B240.i.i.i.i ]
  %theta.2.1.ph.i.i.i.i = phi double [ 0.000000e+00, %B306.i.i.i ], [ %theta.1.2.i.i.i.i, %B240.i.i.i.i ]
  br label %B18.i.i.i.i
B18.i.i.i.i:
  %low.4.1.i.i.i.i = phi double [ 5.000000e-01, %B186.i.i.i.i ], [ %low.4.1.ph.i.i.i.i, %B18.outer.i.i.i.i ]
  %high.3.1.i.i.i.i = phi double [ 1.000000e+00, %B186.i.i.i.i ], [ %high.3.1.ph.i.i.i.i, %B18.outer.i.i.i.i ]
  %event.2.1.i.i.i.i = phi i64 [ -1, %B186.i.i.i.i ], [ %event.2.1.ph.i.i.i.i, %B18.outer.i.i.i.i ]
  %.64.i.i.i.i.i = fsub double 1.000000e+00, %high.3.1.i.i.i.i
  br i1 %6, label %B18.endif.i.i.i.i, label %B60.i.i.i.i.i
B60.i.i.i.i.i:
  %.166146148.i.i.i.i.i = phi i64 [ %.173.i.i.i.i.i, %B60.i.i.i.i.i ], [ 0, %B18.i.i.i.i ]
  %.173.i.i.i.i.i = add nuw nsw i64 %.166146148.i.i.i.i.i, 1
  %21 = shl i64 %.166146148.i.i.i.i.i, 3
  %scevgep4.i.i.i.i.i = getelementptr i8, ptr %a2, i64 %21
  %.227.i.i.i.i.i = load double, ptr %scevgep4.i.i.i.i.i, align 8, !noalias !63
  %.229.i.i.i.i.i = fmul double %.64.i.i.i.i.i, %.227.i.i.i.i.i
  %scevgep3.i.i.i.i.i = getelementptr i8, ptr %.920.i.i, i64 %21
  %.259.i.i.i.i.i = load double, ptr %scevgep3.i.i.i.i.i, align 8, !noalias !63
  %scevgep70.i.i.i.i = getelementptr i8, ptr %.1408.i.i, i64 %21
  %.289.i.i.i.i.i = load double, ptr %scevgep70.i.i.i.i, align 8, !noalias !63
  %scevgep69.i.i.i.i = getelementptr i8, ptr %invariant.gep.i.i3.i.i.i, i64 %21
  %.321.i.i.i.i.i = load double, ptr %scevgep69.i.i.i.i, align 8, !noalias !63
  %.323.i.i.i.i.i = fmul double %high.3.1.i.i.i.i, %.321.i.i.i.i.i
  %.324.i.i.i.i.i = fadd double %.289.i.i.i.i.i, %.323.i.i.i.i.i
  %.326.i.i.i.i.i = fmul double %.64.i.i.i.i.i, %.324.i.i.i.i.i
  %.327.i.i.i.i.i = fadd double %.259.i.i.i.i.i, %.326.i.i.i.i.i
  %.329.i.i.i.i.i = fmul double %high.3.1.i.i.i.i, %.327.i.i.i.i.i
  %.330.i.i.i.i.i = fadd double %.229.i.i.i.i.i, %.329.i.i.i.i.i
  %scevgep68.i.i.i.i = getelementptr i8, ptr %.1092.i.i, i64 %21
  store double %.330.i.i.i.i.i, ptr %scevgep68.i.i.i.i, align 8, !noalias !63
  %exitcond.not.i.i.i.i.i = icmp eq i64 %.1067.i.i, %.173.i.i.i.i.i
  br i1 %exitcond.not.i.i.i.i.i, label %B18.endif.i.i.i.i, label %B60.i.i.i.i.i
B186.i.i.i.i:
  %.381.i.i.i.i = fcmp oeq double %high.3.1.i.i.i.i, 1.000000e+00
  br i1 %.381.i.i.i.i, label %_ZN6poppet6engine8stepping11stop_insideB3v26B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE.exit.i.i.i, label %B18.i.i.i.i
B240.i.i.i.i:
  %low.3.2.i.i.i.i = phi double [ %low.4.1.i.i.i.i, %B252.1.i.i.i.i.i ], [ %high.3.1.i.i.i.i, %B18.endif.endif.endif.thread13.i.i.i.i ]
  %theta.1.2.i.i.i.i = phi double [ %high.3.1.i.i.i.i, %B252.1.i.i.i.i.i ], [ %theta.2.1.ph.i.i.i.i, %B18.endif.endif.endif.thread13.i.i.i.i ]
  %event.4.2.i.i.i.i = phi i64 [ %.284326331.i.i.i.i.i, %B252.1.i.i.i.i.i ], [ %event.2.1.i.i.i.i, %B18.endif.endif.endif.thread13.i.i.i.i ]
  %.543.i.i.i.i = fadd double %low.3.2.i.i.i.i, %theta.1.2.i.i.i.i
  %.544.i.i.i.i = fmul double %.543.i.i.i.i, 5.000000e-01
  %.550.i.i.i.i = fsub double %theta.1.2.i.i.i.i, %low.3.2.i.i.i.i
  %.552.i.i.i.i = fmul double %"$phi820.0.2.1.in.sroa.speculated.i.i", %.550.i.i.i.i
  %.557.i.i.i.i = fcmp ole double %.552.i.i.i.i, %.556.i.i.i.i
  %.561.i.i.i.i = fcmp ole double %.544.i.i.i.i, %low.3.2.i.i.i.i
  %or.cond.i.i.i.i = or i1 %.557.i.i.i.i, %.561.i.i.i.i
  %.565.i.i.i.i = fcmp oge double %.544.i.i.i.i, %theta.1.2.i.i.i.i
  %or.cond319.i.i.i.i = or i1 %.565.i.i.i.i, %or.cond.i.i.i.i
  br i1 %or.cond319.i.i.i.i, label %B316.i.i65.i.i, label %B18.outer.i.i.i.i
B316.i.i65.i.i:
  %.64.i18.i.i.i.i = fsub double 1.000000e+00, %theta.1.2.i.i.i.i
  br i1 %6, label %_ZN6poppet6engine8stepping11stop_insideB3v26B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE.exit.i.i.i, label %B60.i22.i.i.i.i
B60.i22.i.i.i.i:
  %.166146148.i23.i.i.i.i = phi i64 [ %.173.i24.i.i.i.i, %B60.i22.i.i.i.i ], [ 0, %B316.i.i65.i.i ]
  %.173.i24.i.i.i.i = add nuw nsw i64 %.166146148.i23.i.i.i.i, 1
  %22 = shl i64 %.166146148.i23.i.i.i.i, 3
  %scevgep4.i25.i.i.i.i = getelementptr i8, ptr %a2, i64 %22
  %.227.i26.i.i.i.i = load double, ptr %scevgep4.i25.i.i.i.i, align 8, !noalias !68
  %.229.i27.i.i.i.i = fmul double %.64.i18.i.i.i.i, %.227.i26.i.i.i.i
  %scevgep3.i28.i.i.i.i = getelementptr i8, ptr %.920.i.i, i64 %22
  %.259.i29.i.i.i.i = load double, ptr %scevgep3.i28.i.i.i.i, align 8, !noalias !68
  %scevgep67.i.i.i.i = getelementptr i8, ptr %.1408.i.i, i64 %22
  %.289.i31.i.i.i.i = load double, ptr %scevgep67.i.i.i.i, align 8, !noalias !68
  %scevgep66.i.i.i.i = getelementptr i8, ptr %invariant.gep.i.i3.i.i.i, i64 %22
  %.321.i33.i.i.i.i = load double, ptr %scevgep66.i.i.i.i, align 8, !noalias !68
  %.323.i34.i.i.i.i = fmul double %theta.1.2.i.i.i.i, %.321.i33.i.i.i.i
  %.324.i35.i.i.i.i = fadd double %.289.i31.i.i.i.i, %.323.i34.i.i.i.i
  %.326.i36.i.i.i.i = fmul double %.64.i18.i.i.i.i, %.324.i35.i.i.i.i
  %.327.i37.i.i.i.i = fadd double %.259.i29.i.i.i.i, %.326.i36.i.i.i.i
  %.329.i38.i.i.i.i = fmul double %theta.1.2.i.i.i.i, %.327.i37.i.i.i.i
  %.330.i39.i.i.i.i = fadd double %.229.i27.i.i.i.i, %.329.i38.i.i.i.i
  %scevgep.i1.i.i.i = getelementptr i8, ptr %.1092.i.i, i64 %22
  store double %.330.i39.i.i.i.i, ptr %scevgep.i1.i.i.i, align 8, !noalias !68
  %exitcond.not.i41.i.i.i.i = icmp eq i64 %.1067.i.i, %.173.i24.i.i.i.i
  br i1 %exitcond.not.i41.i.i.i.i, label %_ZN6poppet6engine8stepping11stop_insideB3v26B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE.exit.i.i.i, label %B60.i22.i.i.i.i
B18.endif.i.i.i.i:
  %.275.i.i.i.i = fmul double %"$phi820.0.2.1.in.sroa.speculated.i.i", %high.3.1.i.i.i.i
  %.277.i.i.i.i = fadd double %t.2.0.i.i, %.275.i.i.i.i
  %.40.i.i.i.i.i = fsub double %.277.i.i.i.i, %.4486.i
  br i1 %50, label %B18.endif.endif.i.i.i.i, label %B56.i.i.i.i.i
B56.i.i.i.i.i:
  %lsr.iv.i.i.i.i.i = phi ptr [ %scevgep1.i46.i.i.i.i, %B316.i.i.i.i.i ], [ %scevgep.i172.i.i, %B18.endif.i.i.i.i ]
  %.138222224.i.i.i.i.i = phi i64 [ %.145.i.i.i.i.i, %B316.i.i.i.i.i ], [ 0, %B18.endif.i.i.i.i ]
  %.145.i.i.i.i.i = add nuw nsw i64 %.138222224.i.i.i.i.i, 1
  %scevgep6.i.i.i.i.i = getelementptr i8, ptr %lsr.iv.i.i.i.i.i, i64 -40
  %.227.i44.i.i.i.i = load double, ptr %scevgep6.i.i.i.i.i, align 8, !noalias !71
  %scevgep5.i.i.i.i.i = getelementptr i8, ptr %lsr.iv.i.i.i.i.i, i64 -32
  %.282.i.i.i.i.i = load double, ptr %scevgep5.i.i.i.i.i, align 8, !noalias !71
  %.284.i.i.i.i.i = fmul double %.40.i.i.i.i.i, %.282.i.i.i.i.i
  %.285.i.i.i.i.i = fadd double %.227.i44.i.i.i.i, %.284.i.i.i.i.i
  %scevgep4.i45.i.i.i.i = getelementptr i8, ptr %lsr.iv.i.i.i.i.i, i64 -24
  %.347.i.i.i.i.i = load double, ptr %scevgep4.i45.i.i.i.i, align 8, !noalias !71
  %.348.i.i.i.i.i = fcmp une double %.347.i.i.i.i.i, 0.000000e+00
  br i1 %.348.i.i.i.i.i, label %B134.i.i.i.i.i, label %B316.i.i.i.i.i
B134.i.i.i.i.i:
  %scevgep3.i48.i.i.i.i = getelementptr i8, ptr %lsr.iv.i.i.i.i.i, i64 -16
  %.405.i.i.i.i.i = load double, ptr %scevgep3.i48.i.i.i.i, align 8, !noalias !71
  %scevgep2.i49.i.i.i.i = getelementptr i8, ptr %lsr.iv.i.i.i.i.i, i64 -8
  %.460.i.i.i.i.i = load double, ptr %scevgep2.i49.i.i.i.i, align 8, !noalias !71
  %.461.i.i.i.i.i = fmul double %.460.i.i.i.i.i, 5.000000e-01
  %.463.i.i.i.i.i = fmul double %.40.i.i.i.i.i, %.461.i.i.i.i.i
  %.464.i.i.i.i.i = fadd double %.405.i.i.i.i.i, %.463.i.i.i.i.i
  %.465.i.i.i.i.i = fmul double %.464.i.i.i.i.i, 0x401921FB54442D18
  %.467.i.i.i.i.i = fmul double %.40.i.i.i.i.i, %.465.i.i.i.i.i
  %.522.i.i.i.i.i = load double, ptr %lsr.iv.i.i.i.i.i, align 8, !noalias !71
  %.523.i.i.i.i.i = fadd double %.522.i.i.i.i.i, %.467.i.i.i.i.i
  %.586.le.i.i.i.i.i = tail call double @llvm.sin.f64(double %.523.i.i.i.i.i)
  %.591.i.i.i.i.i = fmul double %.347.i.i.i.i.i, %.586.le.i.i.i.i.i
  %.593.i.i.i.i.i = fadd double %.285.i.i.i.i.i, %.591.i.i.i.i.i
  br label %B316.i.i.i.i.i
B316.i.i.i.i.i:
  %value.2.1.i.i.i.i.i = phi double [ %.593.i.i.i.i.i, %B134.i.i.i.i.i ], [ %.285.i.i.i.i.i, %B56.i.i.i.i.i ]
  %23 = shl i64 %.138222224.i.i.i.i.i, 3
  %scevgep7.i.i.i.i.i = getelementptr i8, ptr %.1822.i, i64 %23
  store double %value.2.1.i.i.i.i.i, ptr %scevgep7.i.i.i.i.i, align 8, !noalias !71
  %scevgep1.i46.i.i.i.i = getelementptr i8, ptr %lsr.iv.i.i.i.i.i, i64 48
  %exitcond.not.i47.i.i.i.i = icmp eq i64 %.1797.i, %.145.i.i.i.i.i
  br i1 %exitcond.not.i47.i.i.i.i, label %B18.endif.endif.i.i.i.i, label %B56.i.i.i.i.i
B18.endif.endif.i.i.i.i:
  store double %.277.i.i.i.i, ptr %.2336.i, align 8, !noalias !74
  tail call void %20(ptr nonnull %.2336.i, ptr %.1092.i.i, ptr %.1822.i, ptr %a3, ptr %.3887.i), !noalias !74
  br label %B108.endif.endif.i.i.i.i.i
B106.i.i.i.i.i:
  %.291.i.i.i.i.i = add nuw nsw i64 %.284326331.i.i.i.i.i, 1
  %scevgep1.i54.i.i.i.i = getelementptr i8, ptr %lsr.iv.i52.i.i.i.i, i64 16
  %scevgep5.i55.i.i.i.i = getelementptr i8, ptr %lsr.iv4.i.i.i.i.i, i64 24
  %exitcond.not.i56.i.i.i.i = icmp eq i64 %.73.i, %.291.i.i.i.i.i
  br i1 %exitcond.not.i56.i.i.i.i, label %B18.endif.endif.endif.thread13.i.i.i.i, label %B108.endif.endif.i.i.i.i.i
B192.i.i.i.i.i:
  %sunkaddr.i.i.i.i.i = getelementptr i8, ptr %lsr.iv4.i.i.i.i.i, i64 -16
  %.612.i.i.i.i.i = load double, ptr %sunkaddr.i.i.i.i.i, align 8, !noalias !74
  %.701.i.i.i.i.i = getelementptr double, ptr %.3887.i, i64 %.554.i.i.i.i.i
  %.702.i.i.i.i.i = load double, ptr %.701.i.i.i.i.i, align 8, !noalias !74
  %.703.i.i.i.i.i = fmul double %.612.i.i.i.i.i, %.702.i.i.i.i.i
  %.705.i.i.i.i.i = fadd double %.373.i.i.i.i.i, %.703.i.i.i.i.i
  br label %B252.i.i.i.i.i
B252.i.i.i.i.i:
  %value.3.2.i.i.i.i.i = phi double [ %.705.i.i.i.i.i, %B192.i.i.i.i.i ], [ %.373.i.i.i.i.i, %B108.endif.endif.i.i.i.i.i ]
  %.554.1.i.i.i.i.i = load i64, ptr %lsr.iv.i52.i.i.i.i, align 8, !noalias !74
  %.557.1.i.i.i.i.i = icmp sgt i64 %.554.1.i.i.i.i.i, -1
  br i1 %.557.1.i.i.i.i.i, label %B192.1.i.i.i.i.i, label %B252.1.i.i.i.i.i
B192.1.i.i.i.i.i:
  %scevgep6.i57.i.i.i.i = getelementptr i8, ptr %lsr.iv4.i.i.i.i.i, i64 -8
  %.612.1.i.i.i.i.i = load double, ptr %scevgep6.i57.i.i.i.i, align 8, !noalias !74
  %.701.1.i.i.i.i.i = getelementptr double, ptr %.3887.i, i64 %.554.1.i.i.i.i.i
  %.702.1.i.i.i.i.i = load double, ptr %.701.1.i.i.i.i.i, align 8, !noalias !74
  %.703.1.i.i.i.i.i = fmul double %.612.1.i.i.i.i.i, %.702.1.i.i.i.i.i
  %.705.1.i.i.i.i.i = fadd double %value.3.2.i.i.i.i.i, %.703.1.i.i.i.i.i
  br label %B252.1.i.i.i.i.i
B252.1.i.i.i.i.i:
  %value.3.2.1.i.i.i.i.i = phi double [ %.705.1.i.i.i.i.i, %B192.1.i.i.i.i.i ], [ %value.3.2.i.i.i.i.i, %B252.i.i.i.i.i ]
  %.724.i.i.i.i.i = fcmp ogt double %value.3.2.1.i.i.i.i.i, 0.000000e+00
  br i1 %.724.i.i.i.i.i, label %B240.i.i.i.i, label %B106.i.i.i.i.i
B108.endif.endif.i.i.i.i.i:
  %lsr.iv4.i.i.i.i.i = phi ptr [ %scevgep5.i55.i.i.i.i, %B106.i.i.i.i.i ], [ %scevgep3.i146.i, %B18.endif.endif.i.i.i.i ]
  %lsr.iv.i52.i.i.i.i = phi ptr [ %scevgep1.i54.i.i.i.i, %B106.i.i.i.i.i ], [ %scevgep.i145.i, %B18.endif.endif.i.i.i.i ]
  %.284326331.i.i.i.i.i = phi i64 [ %.291.i.i.i.i.i, %B106.i.i.i.i.i ], [ 0, %B18.endif.endif.i.i.i.i ]
  %.373.i.i.i.i.i = load double, ptr %lsr.iv4.i.i.i.i.i, align 8, !noalias !74
  %scevgep2.i53.i.i.i.i = getelementptr i8, ptr %lsr.iv.i52.i.i.i.i, i64 -8
  %.554.i.i.i.i.i = load i64, ptr %scevgep2.i53.i.i.i.i, align 8, !noalias !74
  %.557.i.i.i.i.i = icmp sgt i64 %.554.i.i.i.i.i, -1
  br i1 %.557.i.i.i.i.i, label %B192.i.i.i.i.i, label %B252.i.i.i.i.i
B18.endif.endif.endif.thread13.i.i.i.i:
  %.37115.i.i.i.i = icmp slt i64 %event.2.1.i.i.i.i, 0
  br i1 %.37115.i.i.i.i, label %B186.i.i.i.i, label %B240.i.i.i.i
_ZN6poppet6engine8stepping11stop_insideB3v26B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE.exit.i.i.i:
  %event.4.2.lcssa.sink.i.i.i.i = phi i64 [ -1, %B186.i.i.i.i ], [ %event.4.2.i.i.i.i, %B316.i.i65.i.i ], [ %event.4.2.i.i.i.i, %B60.i22.i.i.i.i ]
  %theta.1.2.lcssa.sink.i.i.i.i = phi double [ 1.000000e+00, %B186.i.i.i.i ], [ %theta.1.2.i.i.i.i, %B316.i.i65.i.i ], [ %theta.1.2.i.i.i.i, %B60.i22.i.i.i.i ]
  %.741.i.i.i = fmul double %"$phi820.0.2.1.in.sroa.speculated.i.i", %theta.1.2.lcssa.sink.i.i.i.i
  %.745.i.i.i = fadd double %t.2.0.i.i, %.741.i.i.i
  %.734793.i.i.i = icmp slt i64 %event.4.2.lcssa.sink.i.i.i.i, 0
  %"$phi412.1.2.0.i.i.i" = select i1 %.734793.i.i.i, double %"$phi1016.0.2.1.i.i", double %.745.i.i.i
  store i64 %event.4.2.lcssa.sink.i.i.i.i, ptr %.4258.i, align 8, !noalias !62
  br label %B536.i.i.i
B426.i.i.i:
  br i1 %"$phi126.0.2.0.i.i.i", label %B430.i.i.i, label %B536.i.i.i
B430.i.i.i:
  %.848.i.i.i = load i64, ptr %sunkaddr465.i, align 8, !noalias !62
  call void @llvm.lifetime.start.p0(ptr nonnull %.468.i.i.i.i), !noalias !62
  call void @llvm.lifetime.start.p0(ptr nonnull %.578.i2.i.i.i), !noalias !62
  store i8 0, ptr %.578.i2.i.i.i, align 1, !noalias !77
  %.5.i.i.i.i.i = fmul double %"$phi1016.0.2.1.i.i", 0x3D06849B86A12B9B
  %.6.i.i.i.i.i = fadd double %.5.i.i.i.i.i, 1.000000e-15
  %.340.i.i.i.i = fsub double %"$phi1016.0.2.1.i.i", %.6.i.i.i.i.i
  br label %B6.i.i.i.i
B6.i.i.i.i:
  br i1 %.not.i.i, label %B6.endif.endif.i.i.i.i, label %B58.backedge.preheader.i.i.i.i.i
B58.backedge.preheader.i.i.i.i.i:
  br i1 %53, label %B58.backedge.epil.preheader.i.i.i.i.i, label %B58.backedge.i.i.i.i.i
B58.backedge.i.i.i.i.i:
  %first.2.065.i.i.i.i.i = phi double [ %.13.i.3.i.i.i.i.i, %B58.backedge.i.i.i.i.i ], [ 0x7FF0000000000000, %B58.backedge.preheader.i.i.i.i.i ]
  %.1096163.i.i.i.i.i = phi i64 [ %.116.3.i.i.i.i.i, %B58.backedge.i.i.i.i.i ], [ 0, %B58.backedge.preheader.i.i.i.i.i ]
  %sunkaddr53.i.i.i.i = shl i64 %.1096163.i.i.i.i.i, 3
  %sunkaddr54.i.i.i.i = getelementptr i8, ptr %.1186.i, i64 %sunkaddr53.i.i.i.i
  %.170.i.i.i.i.i = load double, ptr %sunkaddr54.i.i.i.i, align 8, !noalias !80
  %.12.i.i.i.i.i.i = fcmp olt double %.170.i.i.i.i.i, %first.2.065.i.i.i.i.i
  %.13.i.i.i.i.i.i = select i1 %.12.i.i.i.i.i.i, double %.170.i.i.i.i.i, double %first.2.065.i.i.i.i.i
  %sunkaddr57.i.i.i.i = getelementptr i8, ptr %sunkaddr54.i.i.i.i, i64 8
  %.170.1.i.i.i.i.i = load double, ptr %sunkaddr57.i.i.i.i, align 8, !noalias !80
  %.12.i.1.i.i.i.i.i = fcmp olt double %.170.1.i.i.i.i.i, %.13.i.i.i.i.i.i
  %.13.i.1.i.i.i.i.i = select i1 %.12.i.1.i.i.i.i.i, double %.170.1.i.i.i.i.i, double %.13.i.i.i.i.i.i
  %sunkaddr59.i.i.i.i = getelementptr i8, ptr %sunkaddr54.i.i.i.i, i64 16
  %.170.2.i.i.i.i.i = load double, ptr %sunkaddr59.i.i.i.i, align 8, !noalias !80
  %.12.i.2.i.i.i.i.i = fcmp olt double %.170.2.i.i.i.i.i, %.13.i.1.i.i.i.i.i
  %.13.i.2.i.i.i.i.i = select i1 %.12.i.2.i.i.i.i.i, double %.170.2.i.i.i.i.i, double %.13.i.1.i.i.i.i.i
  %sunkaddr62.i.i.i.i = getelementptr i8, ptr %sunkaddr54.i.i.i.i, i64 24
  %.170.3.i.i.i.i.i = load double, ptr %sunkaddr62.i.i.i.i, align 8, !noalias !80
  %.12.i.3.i.i.i.i.i = fcmp olt double %.170.3.i.i.i.i.i, %.13.i.2.i.i.i.i.i
  %.13.i.3.i.i.i.i.i = select i1 %.12.i.3.i.i.i.i.i, double %.170.3.i.i.i.i.i, double %.13.i.2.i.i.i.i.i
  %.116.3.i.i.i.i.i = add nuw nsw i64 %.1096163.i.i.i.i.i, 4
  %niter.ncmp.3.i.i.i.i.i = icmp eq i64 %unroll_iter.i.i.i, %.116.3.i.i.i.i.i
  br i1 %niter.ncmp.3.i.i.i.i.i, label %common.ret.loopexit.unr-lcssa.i.i.i.i.i, label %B58.backedge.i.i.i.i.i
common.ret.loopexit.unr-lcssa.i.i.i.i.i:
  br i1 %54, label %B6.endif.endif.i.i.i.i, label %B58.backedge.epil.preheader.i.i.i.i.i
B58.backedge.epil.preheader.i.i.i.i.i:
  %first.2.065.epil.init.i.i.i.i.i = phi double [ 0x7FF0000000000000, %B58.backedge.preheader.i.i.i.i.i ], [ %.13.i.3.i.i.i.i.i, %common.ret.loopexit.unr-lcssa.i.i.i.i.i ]
  %.1096163.epil.init.i.i.i.i.i = phi i64 [ 0, %B58.backedge.preheader.i.i.i.i.i ], [ %unroll_iter.i.i.i, %common.ret.loopexit.unr-lcssa.i.i.i.i.i ]
  %24 = shl i64 %.1096163.epil.init.i.i.i.i.i, 3
  %scevgep.i.i.i.i.i = getelementptr i8, ptr %.1186.i, i64 %24
  br label %B58.backedge.epil.i.i.i.i.i
B58.backedge.epil.i.i.i.i.i:
  %first.2.065.epil.i.i.i.i.i = phi double [ %.13.i.epil.i.i.i.i.i, %B58.backedge.epil.i.i.i.i.i ], [ %first.2.065.epil.init.i.i.i.i.i, %B58.backedge.epil.preheader.i.i.i.i.i ]
  %epil.iter.i.i.i.i.i = phi i64 [ %epil.iter.next.i.i.i.i.i, %B58.backedge.epil.i.i.i.i.i ], [ 0, %B58.backedge.epil.preheader.i.i.i.i.i ]
  %25 = shl i64 %epil.iter.i.i.i.i.i, 3
  %scevgep70.i4.i.i.i = getelementptr i8, ptr %scevgep.i.i.i.i.i, i64 %25
  %.170.epil.i.i.i.i.i = load double, ptr %scevgep70.i4.i.i.i, align 8, !noalias !80
  %.12.i.epil.i.i.i.i.i = fcmp olt double %.170.epil.i.i.i.i.i, %first.2.065.epil.i.i.i.i.i
  %.13.i.epil.i.i.i.i.i = select i1 %.12.i.epil.i.i.i.i.i, double %.170.epil.i.i.i.i.i, double %first.2.065.epil.i.i.i.i.i
  %epil.iter.next.i.i.i.i.i = add i64 %epil.iter.i.i.i.i.i, 1
  %epil.iter.cmp.not.i.i.i.i.i = icmp eq i64 %xtraiter.i.i.i, %epil.iter.next.i.i.i.i.i
  br i1 %epil.iter.cmp.not.i.i.i.i.i, label %B6.endif.endif.i.i.i.i, label %B58.backedge.epil.i.i.i.i.i, !llvm.loop !83
B96.i.i.i.i:
  call fastcc void @v37(ptr nonnull %.468.i.i.i.i, i64 %.478.i.i.i, double %t.2.0.i.i, double %"$phi820.0.2.1.in.sroa.speculated.i.i", double %first.2.0.lcssa.i.i.i.i.i, double %.4486.i, ptr readonly %.5269.i, ptr readonly %a2, ptr readonly %.920.i.i, ptr readonly %.1408.i.i, i64 %.732.i.i, ptr %.748.i.i, i64 %.1806.i, ptr %.1822.i, ptr %a3, ptr nonnull %.2336.i, i64 %.3871.i, ptr %.3887.i, i64 %.71.i, ptr readonly %a7, i64 %.71.i, ptr %a14, i64 %.71.i, ptr nonnull %a17)
  %.523.i.i64.i.i = fsub double %first.2.0.lcssa.i.i.i.i.i, %t.2.0.i.i
  %.528.i.i.i.i = fdiv double %.523.i.i64.i.i, %"$phi820.0.2.1.in.sroa.speculated.i.i"
  %.64.i.i5.i.i.i = fsub double 1.000000e+00, %.528.i.i.i.i
  br i1 %6, label %B96.endif.endif.endif.i.i.i.i, label %B60.i.i6.i.i.i
B6.endif.endif.i.i.i.i:
  %first.2.0.lcssa.i.i.i.i.i = phi double [ 0x7FF0000000000000, %B6.i.i.i.i ], [ %.13.i.3.i.i.i.i.i, %common.ret.loopexit.unr-lcssa.i.i.i.i.i ], [ %.13.i.epil.i.i.i.i.i, %B58.backedge.epil.i.i.i.i.i ]
  %.342.i.i.i.i = fcmp ult double %first.2.0.lcssa.i.i.i.i.i, %.340.i.i.i.i
  br i1 %.342.i.i.i.i, label %B96.i.i.i.i, label %_ZN6poppet6engine8stepping10act_insideB3v28B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExxdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i.i.i
B60.i.i6.i.i.i:
  %.166146148.i.i7.i.i.i = phi i64 [ %.173.i.i8.i.i.i, %B60.i.i6.i.i.i ], [ 0, %B96.i.i.i.i ]
  %.173.i.i8.i.i.i = add nuw nsw i64 %.166146148.i.i7.i.i.i, 1
  %26 = shl i64 %.166146148.i.i7.i.i.i, 3
  %scevgep4.i24.i.i.i.i = getelementptr i8, ptr %a2, i64 %26
  %.227.i.i9.i.i.i = load double, ptr %scevgep4.i24.i.i.i.i, align 8, !noalias !84
  %.229.i.i10.i.i.i = fmul double %.64.i.i5.i.i.i, %.227.i.i9.i.i.i
  %scevgep3.i.i11.i.i.i = getelementptr i8, ptr %.920.i.i, i64 %26
  %.259.i.i12.i.i.i = load double, ptr %scevgep3.i.i11.i.i.i, align 8, !noalias !84
  %scevgep52.i.i.i.i = getelementptr i8, ptr %.1408.i.i, i64 %26
  %.289.i.i13.i.i.i = load double, ptr %scevgep52.i.i.i.i, align 8, !noalias !84
  %scevgep51.i.i.i.i = getelementptr i8, ptr %invariant.gep.i.i3.i.i.i, i64 %26
  %.321.i.i14.i.i.i = load double, ptr %scevgep51.i.i.i.i, align 8, !noalias !84
  %.323.i.i15.i.i.i = fmul double %.528.i.i.i.i, %.321.i.i14.i.i.i
  %.324.i.i16.i.i.i = fadd double %.289.i.i13.i.i.i, %.323.i.i15.i.i.i
  %.326.i.i17.i.i.i = fmul double %.64.i.i5.i.i.i, %.324.i.i16.i.i.i
  %.327.i.i18.i.i.i = fadd double %.259.i.i12.i.i.i, %.326.i.i17.i.i.i
  %.329.i.i19.i.i.i = fmul double %.528.i.i.i.i, %.327.i.i18.i.i.i
  %.330.i.i20.i.i.i = fadd double %.229.i.i10.i.i.i, %.329.i.i19.i.i.i
  %scevgep50.i.i.i.i = getelementptr i8, ptr %.1092.i.i, i64 %26
  store double %.330.i.i20.i.i.i, ptr %scevgep50.i.i.i.i, align 8, !noalias !84
  %exitcond.not.i.i21.i.i.i = icmp eq i64 %.1067.i.i, %.173.i.i8.i.i.i
  br i1 %exitcond.not.i.i21.i.i.i, label %B96.endif.endif.endif.i.i.i.i, label %B60.i.i6.i.i.i
B96.endif.endif.endif.i.i.i.i:
  store i8 0, ptr %.578.i2.i.i.i, align 1, !noalias !77
  call fastcc void @v36(ptr nonnull %.578.i2.i.i.i, i64 %.848.i.i.i, double %first.2.0.lcssa.i.i.i.i.i, double %.4486.i, ptr readonly %.5269.i, ptr %.1092.i.i, i64 %.1806.i, ptr %.1822.i, ptr %a3, i64 %.1170.i, ptr %.1186.i, ptr nonnull %.2336.i, i64 %.3526.i, ptr %.3542.i, ptr %.3715.i, ptr readonly %a13)
  %.612.i.i.i.i = load i8, ptr %.578.i2.i.i.i, align 1, !noalias !77
  %.615.not.i.i.i.i = icmp eq i8 %.612.i.i.i.i, 0
  br i1 %.615.not.i.i.i.i, label %B6.i.i.i.i, label %_ZN6poppet6engine8stepping10act_insideB3v28B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExxdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i.i.i
_ZN6poppet6engine8stepping10act_insideB3v28B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExxdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i.i.i:
  %storemerge.i.i.i.i = phi double [ %"$phi1016.0.2.1.i.i", %B6.endif.endif.i.i.i.i ], [ %first.2.0.lcssa.i.i.i.i.i, %B96.endif.endif.endif.i.i.i.i ]
  call void @llvm.lifetime.end.p0(ptr nonnull %.468.i.i.i.i), !noalias !62
  call void @llvm.lifetime.end.p0(ptr nonnull %.578.i2.i.i.i), !noalias !62
  br label %B536.i.i.i
B536.i.i.i:
  %reached.3.0.i.i.i = phi double [ %"$phi412.1.2.0.i.i.i", %_ZN6poppet6engine8stepping11stop_insideB3v26B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE.exit.i.i.i ], [ %storemerge.i.i.i.i, %_ZN6poppet6engine8stepping10act_insideB3v28B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExxdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i.i.i ], [ %"$phi1016.0.2.1.i.i", %B426.i.i.i ]
  call fastcc void @v37(ptr nonnull %.1003.i.i.i, i64 %.478.i.i.i, double %t.2.0.i.i, double %"$phi820.0.2.1.in.sroa.speculated.i.i", double %reached.3.0.i.i.i, double %.4486.i, ptr readonly %.5269.i, ptr %a2, ptr readonly %.920.i.i, ptr %.1408.i.i, i64 %.732.i.i, ptr %.748.i.i, i64 %.1806.i, ptr %.1822.i, ptr %a3, ptr nonnull %.2336.i, i64 %.3871.i, ptr %.3887.i, i64 %.71.i, ptr readonly %a7, i64 %.71.i, ptr %a14, i64 %.71.i, ptr nonnull %a17)
  %.1141.i.i.i = load i64, ptr %.4258.i, align 8, !noalias !62
  %.1142.i.i.i = icmp sgt i64 %.1141.i.i.i, -1
  %.1164.i.i.i = fcmp olt double %reached.3.0.i.i.i, %"$phi1016.0.2.1.i.i"
  %or.cond.i55.i.i = select i1 %.1142.i.i.i, i1 true, i1 %.1164.i.i.i
  %arg.xi.4.arg.x1.4.i.i.i = select i1 %or.cond.i55.i.i, ptr %.1092.i.i, ptr %.920.i.i
  br label %B50.endif.endif.i.i.i.i
B26.endif.endif.i.i.i:
  %first.2.0.lcssa.i.i50.i.i = phi double [ %.13.i.3.i.i33.i.i, %common.ret.loopexit.unr-lcssa.i.i36.i.i ], [ %.13.i.epil.i.i47.i.i, %B58.backedge.epil.i.i42.i.i ]
  %.5.i.i51.i.i = fmul double %"$phi1016.0.2.1.i.i", 0x3D06849B86A12B9B
  %.6.i.i52.i.i = fadd double %.5.i.i51.i.i, 1.000000e-15
  %.422.i.i.i = fsub double %"$phi1016.0.2.1.i.i", %.6.i.i52.i.i
  %.423.i.i.i = fcmp olt double %first.2.0.lcssa.i.i50.i.i, %.422.i.i.i
  br label %B126.i.i.i
B50.endif.endif.i.i.i.i:
  %.158230233.i.i.i.i = phi i64 [ 0, %B536.i.i.i ], [ %.165.i.i.i.i, %B50.endif.endif.i.i.i.i ]
  %.165.i.i.i.i = add nuw nsw i64 %.158230233.i.i.i.i, 1
  %27 = shl i64 %.158230233.i.i.i.i, 3
  %scevgep9.i.i.i.i = getelementptr i8, ptr %arg.xi.4.arg.x1.4.i.i.i, i64 %27
  %.219.i.i.i.i = load double, ptr %scevgep9.i.i.i.i, align 8, !noalias !87
  %scevgep6.i.i57.i.i = getelementptr i8, ptr %invariant.gep.i.i.i.i, i64 %27
  %.252.i.i.i.i = load double, ptr %scevgep6.i.i57.i.i, align 8, !noalias !87
  %scevgep8.i.i.i.i = getelementptr i8, ptr %a2, i64 %27
  %.282.i.i58.i.i = load double, ptr %scevgep8.i.i.i.i, align 8, !noalias !87
  %.283.i.i.i.i = fsub double %.219.i.i.i.i, %.282.i.i58.i.i
  %.284.i.i59.i.i = tail call double @llvm.fabs.f64(double %.283.i.i.i.i)
  %.285.i.i60.i.i = fadd double %.252.i.i.i.i, %.284.i.i59.i.i
  store double %.285.i.i60.i.i, ptr %scevgep6.i.i57.i.i, align 8, !noalias !87
  store double %.219.i.i.i.i, ptr %scevgep8.i.i.i.i, align 8, !noalias !87
  %scevgep3.i.i.i = getelementptr i8, ptr %a15, i64 %27
  %.375.i.i.i.i = load double, ptr %scevgep3.i.i.i, align 8, !noalias !87
  %.12.i.i1.i.i.i = fcmp olt double %.219.i.i.i.i, %.375.i.i.i.i
  %.13.i.i2.i.i.i = select i1 %.12.i.i1.i.i.i, double %.219.i.i.i.i, double %.375.i.i.i.i
  %scevgep.i61.i.i = getelementptr i8, ptr %invariant.gep242.i.i.i.i, i64 %27
  %.435.i.i.i.i = load double, ptr %scevgep.i61.i.i, align 8, !noalias !87
  %.12.i4.i.i.i.i = fcmp ogt double %.219.i.i.i.i, %.435.i.i.i.i
  %.13.i5.i.i.i.i = select i1 %.12.i4.i.i.i.i, double %.219.i.i.i.i, double %.435.i.i.i.i
  store double %.13.i.i2.i.i.i, ptr %scevgep3.i.i.i, align 8, !noalias !87
  store double %.13.i5.i.i.i.i, ptr %scevgep.i61.i.i, align 8, !noalias !87
  %exitcond.not.i.i62.i.i = icmp eq i64 %.25.i, %.165.i.i.i.i
  br i1 %exitcond.not.i.i62.i.i, label %_ZN6poppet6engine10integrator7_acceptB3v25B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i.i, label %B50.endif.endif.i.i.i.i
_ZN6poppet6engine10integrator7_acceptB3v25B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i.i:
  %.577.i.i.i.i = load i64, ptr %a17, align 8, !noalias !87
  %.578.i.i63.i.i = add nsw i64 %.577.i.i.i.i, 1
  store i64 %.578.i.i63.i.i, ptr %a17, align 8, !noalias !87
  call void @llvm.lifetime.end.p0(ptr nonnull %.1003.i.i.i), !noalias !28
  store double %reached.3.0.i.i.i, ptr %a16, align 8, !noalias !28
  %.3718.i.i = load i64, ptr %.4258.i, align 8, !noalias !28
  %.3719.i.i = icmp sgt i64 %.3718.i.i, -1
  br i1 %.3719.i.i, label %_ZN6poppet6engine10integrator8_segmentB3v14B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B1474.endif.i.i
B1678.i.i:
  %first.2.1.i.i = phi double [ %.4133.i.i, %B1608.endif.endif.i.i ], [ %first.3.0.i.i, %B1474.endif.endif.endif.i.i ]
  %.4141.i.i = fcmp olt double %"$phi820.0.2.1.in.sroa.speculated.i.i", %wanted.2.0.sink.i.i.i
  br i1 %.4141.i.i, label %B1690.i.i, label %B1728.i.i
B1690.i.i:
  %.4147.i.i = fmul double %"$phi820.0.2.1.in.sroa.speculated.i.i", %.13.i4.i.i.i
  %.12.i158.i.i = fcmp ogt double %.4147.i.i, %wanted.2.0.sink.i.i.i
  %.13.i159.i.i = select i1 %.12.i158.i.i, double %.4147.i.i, double %wanted.2.0.sink.i.i.i
  br label %B1772.i.i
B1728.i.i:
  %.12.i160.i.i = fcmp olt double %.13.i4.i.i.i, 1.000000e+00
  %.13.i161.i.i = select i1 %.12.i160.i.i, double %.13.i4.i.i.i, double 1.000000e+00
  %"$phi1768.1.2.1.i.i" = select i1 %rejected.3.0.i.i, double %.13.i161.i.i, double %.13.i4.i.i.i
  %.4242.i.i = fmul double %"$phi820.0.2.1.in.sroa.speculated.i.i", %"$phi1768.1.2.1.i.i"
  br label %B1772.i.i
B1772.i.i:
  %"$phi1772.0.2.1.i.i" = phi double [ %.4242.i.i, %B1728.i.i ], [ %.13.i159.i.i, %B1690.i.i ]
  %.4333.i.i = fcmp olt double %reached.3.0.i.i.i, %.4331.i.i
  %or.cond277.i.i = select i1 %.1974.i.i, i1 %.4333.i.i, i1 false
  br i1 %or.cond277.i.i, label %B1854.i.i, label %B2208.i.i
B1854.i.i:
  %.4377.i.i = load i64, ptr %sunkaddr465.i, align 8, !noalias !28
  store i8 0, ptr %.4389.i.i, align 1, !noalias !28
  call fastcc void @v36(ptr nonnull %.4389.i.i, i64 %.4377.i.i, double %reached.3.0.i.i.i, double %.4486.i, ptr readonly %.5269.i, ptr %a2, i64 %.1806.i, ptr %.1822.i, ptr %a3, i64 %.1170.i, ptr %.1186.i, ptr nonnull %.2336.i, i64 %.3526.i, ptr %.3542.i, ptr %.3715.i, ptr readonly %a13)
  %.4423.i.i = load i8, ptr %.4389.i.i, align 1, !noalias !28
  %.4426.i.i = icmp ne i8 %.4423.i.i, 0
  %or.cond1.i.i = select i1 %.4426.i.i, i1 true, i1 %.1164.i.i.i
  br i1 %or.cond1.i.i, label %B1946.endif.i.i, label %B2208.i.i
B2144.i.i:
  %"$phi2144.1.2.2.i.i" = phi double [ 1.500000e-01, %for.end.1.i.i ], [ %.13.i227.i.i, %B2040.endif.i.i ]
  %.4716.i.i = fmul double %"$phi820.0.2.1.in.sroa.speculated.i.i", %"$phi2144.1.2.2.i.i"
  %.4729.i.i = fadd double %t.2.0.i.i, %.4716.i.i
  %.4731.i.i = fcmp ole double %.4729.i.i, %t.2.0.i.i
  %.4734.i.i = fcmp olt double %.4716.i.i, 1.000000e-300
  %or.cond.i.i = or i1 %.4734.i.i, %.4731.i.i
  %brmerge2685.i.i = or i1 %5, %or.cond.i.i
  br i1 %brmerge2685.i.i, label %_ZN6poppet6engine10integrator8_segmentB3v14B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B2208.i.i
B2208.i.i:
  %t.3.1.i.i = phi double [ %t.2.0.i.i, %B2144.i.i ], [ %reached.3.0.i.i.i, %B1946.endif.i.i ], [ %reached.3.0.i.i.i, %B1772.i.i ], [ %reached.3.0.i.i.i, %B1854.i.i ]
  %h.7.1.i.i = phi double [ %.4716.i.i, %B2144.i.i ], [ %.13.i163.i.i, %B1946.endif.i.i ], [ %"$phi1772.0.2.1.i.i", %B1772.i.i ], [ %"$phi1772.0.2.1.i.i", %B1854.i.i ]
  %error_before.3.1.i.i = phi double [ %error_before.2.0.i.i, %B2144.i.i ], [ %.13.i223.i.i, %B1946.endif.i.i ], [ %.13.i223.i.i, %B1772.i.i ], [ %.13.i223.i.i, %B1854.i.i ]
  %step_before.4.1.i.i = phi double [ %step_before.3.0.i.i, %B2144.i.i ], [ 0.000000e+00, %B1946.endif.i.i ], [ %"$phi820.0.2.1.in.sroa.speculated.i.i", %B1772.i.i ], [ %"$phi820.0.2.1.in.sroa.speculated.i.i", %B1854.i.i ]
  %rejected.4.1.i.i = phi i1 [ true, %B2144.i.i ], [ false, %B1946.endif.i.i ], [ false, %B1772.i.i ], [ false, %B1854.i.i ]
  %fresh.4.1.i.i = phi i1 [ false, %B2144.i.i ], [ true, %B1946.endif.i.i ], [ true, %B1772.i.i ], [ true, %B1854.i.i ]
  %calm.3.1.i.i = phi double [ %calm.2.0.i.i, %B2144.i.i ], [ %reached.3.0.i.i.i, %B1946.endif.i.i ], [ %calm.2.0.i.i, %B1772.i.i ], [ %calm.2.0.i.i, %B1854.i.i ]
  %first.4.1.i.i = phi double [ %first.3.0.i.i, %B2144.i.i ], [ %first.2.1.i.i, %B1946.endif.i.i ], [ %first.2.1.i.i, %B1772.i.i ], [ %first.2.1.i.i, %B1854.i.i ]
  %has_changed.4.1.i.i = phi i1 [ %has_changed.3.0.i.i, %B2144.i.i ], [ true, %B1946.endif.i.i ], [ false, %B1772.i.i ], [ false, %B1854.i.i ]
  %has_acted.3.1.i.i = phi i1 [ %has_acted.4.0.i.i, %B2144.i.i ], [ true, %B1946.endif.i.i ], [ %has_acted.4.0.i.i, %B1772.i.i ], [ true, %B1854.i.i ]
  %.5092.i.i = load double, ptr %sunkaddr237.i.i, align 8, !noalias !28
  %.94.i.i.i = load i64, ptr %sunkaddr246.i.i, align 8, !noalias !90
  %.114.i.i.i = srem i64 %.94.i.i.i, 400
  %.135.i.i.i = icmp eq i64 %.114.i.i.i, 0
  br i1 %.135.i.i.i, label %B44.i.i.i, label %B184.i.i.i
B44.i.i.i:
  %.5062.i.i = load double, ptr %sunkaddr241.i.i, align 8, !noalias !28
  %.139.i.i.i = fsub double %t.3.1.i.i, %window.2.0.i.i
  %.144.i.i.i = fsub double %.5062.i.i, %window.2.0.i.i
  %.149.i.i.i = fmul double %.144.i.i.i, 1.000000e-04
  %.150.i.i.i = fcmp uge double %.139.i.i.i, %.149.i.i.i
  %"$phi78.0.2.0.not135.i.i.i" = select i1 %.150.i.i.i, i1 true, i1 %has_acted.3.1.i.i
  %.199.i.i.i = load i64, ptr %a17, align 8, !noalias !90
  %.229.i.i.i = load i64, ptr %sunkaddr242.i.i, align 8, !noalias !90
  %.230.i.i.i = sub nsw i64 %.199.i.i.i, %.229.i.i.i
  %.272.i.i.i = icmp sgt i64 %.230.i.i.i, 279
  %brmerge.i.i.i = or i1 %"$phi78.0.2.0.not135.i.i.i", %.272.i.i.i
  br i1 %brmerge.i.i.i, label %B162.i.i.i, label %_ZN6poppet6engine10integrator8_segmentB3v14B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
B162.i.i.i:
  store i64 %.199.i.i.i, ptr %sunkaddr242.i.i, align 8, !noalias !90
  br label %B184.i.i.i
B184.i.i.i:
  %28 = fcmp une double %.5092.i.i, 0.000000e+00
  %.427.i.i.i = load double, ptr %sunkaddr244.i.i, align 8, !noalias !90
  %.433.i.i.i = sitofp i64 %.94.i.i.i to double
  %.434.i.i.i = fcmp ole double %.427.i.i.i, %.433.i.i.i
  %brmerge246.i.i = select i1 %.434.i.i.i, i1 true, i1 %28
  br i1 %brmerge246.i.i, label %B2314.split.loop.exit.i.i, label %B2324.else.if.i.i
B2314.split.loop.exit.i.i:
  %.mux.le.i.i = select i1 %.434.i.i.i, i64 3, i64 5
  br label %_ZN6poppet6engine10integrator8_segmentB3v14B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
B0.endif.else.endif.if.i.i:
  br label %B0.endif.else.endif.endif.endif.i.i
B0.endif.else.endif.endif.endif.i.i:
  %.635.sroa.0.3.i.i = phi i64 [ %.1449.i, %B0.endif.else.endif.if.i.i ], [ %.25.i, %B1922.i ]
  br i1 %.672.not.i.i, label %B0.endif.endif.else.i.i, label %B0.endif.else.endif.endif.endif.if.i.i, !prof !31
B0.endif.else.endif.endif.endif.if.i.i:
  br label %B0.endif.endif.else.i.i
B0.endif.endif.else.i.i:
  %.635.sroa.13.0.i.i = phi i64 [ %.609.i.i, %B0.endif.else.endif.endif.endif.i.i ], [ %.1449.i, %B0.endif.else.endif.endif.endif.if.i.i ]
  %.723.i.i = sub nsw i64 %.635.sroa.13.0.i.i, %.635.sroa.0.3.i.i
  %.732.i.i = tail call i64 @llvm.smax.i64(i64 %.723.i.i, i64 0)
  %.748.i.i = getelementptr double, ptr %.1465.i, i64 %.635.sroa.0.3.i.i
  br i1 %.672.not.i.i, label %B0.endif.endif.else.endif.endif.endif.i.i, label %B0.endif.endif.else.endif.if.i.i, !prof !31
B0.endif.endif.else.endif.if.i.i:
  br label %B0.endif.endif.else.endif.endif.endif.i.i
B0.endif.endif.else.endif.endif.endif.i.i:
  %.807.sroa.0.3.i.i = phi i64 [ %.1449.i, %B0.endif.endif.else.endif.if.i.i ], [ %.609.i.i, %B0.endif.endif.else.i.i ]
  %.920.i.i = getelementptr double, ptr %.1465.i, i64 %.807.sroa.0.3.i.i
  br i1 %.844.not.i.i, label %B0.endif.endif.endif.else.endif.endif.endif.i.i, label %B0.endif.endif.endif.else.endif.if.i.i, !prof !31
B0.endif.endif.endif.else.endif.if.i.i:
  br label %B0.endif.endif.endif.else.endif.endif.endif.i.i
B0.endif.endif.endif.else.endif.endif.endif.i.i:
  %.979.sroa.0.3.i.i = phi i64 [ %.1449.i, %B0.endif.endif.endif.else.endif.if.i.i ], [ %.781.i.i, %B0.endif.endif.else.endif.endif.endif.i.i ]
  br i1 %.1016.not.i.i, label %B0.endif.endif.endif.endif.else.i.i, label %B0.endif.endif.endif.else.endif.endif.endif.if.i.i, !prof !31
B0.endif.endif.endif.else.endif.endif.endif.if.i.i:
  br label %B0.endif.endif.endif.endif.else.i.i
B0.endif.endif.endif.endif.else.i.i:
  %.979.sroa.13.0.i.i = phi i64 [ %.953.i.i, %B0.endif.endif.endif.else.endif.endif.endif.i.i ], [ %.1449.i, %B0.endif.endif.endif.else.endif.endif.endif.if.i.i ]
  %.1067.i.i = sub nsw i64 %.979.sroa.13.0.i.i, %.979.sroa.0.3.i.i
  %.1076.i.i = tail call i64 @llvm.smax.i64(i64 %.1067.i.i, i64 0)
  %.1092.i.i = getelementptr double, ptr %.1465.i, i64 %.979.sroa.0.3.i.i
  br i1 %.1016.not.i.i, label %B0.endif.endif.endif.endif.else.endif.endif.endif.i.i, label %B0.endif.endif.endif.endif.else.endif.if.i.i, !prof !31
B0.endif.endif.endif.endif.else.endif.if.i.i:
  br label %B0.endif.endif.endif.endif.else.endif.endif.endif.i.i
B0.endif.endif.endif.endif.else.endif.endif.endif.i.i:
  %.1295.sroa.0.3.i.i = phi i64 [ %.1449.i, %B0.endif.endif.endif.endif.else.endif.if.i.i ], [ %.953.i.i, %B0.endif.endif.endif.endif.else.i.i ]
  %.1408.i.i = getelementptr double, ptr %.1465.i, i64 %.1295.sroa.0.3.i.i
  br i1 %.1332.not.i.i, label %B0.endif.endif.endif.endif.endif.endif.else.i.i, label %B0.endif.endif.endif.endif.endif.else.endif.if.i.i, !prof !31
B0.endif.endif.endif.endif.endif.else.endif.if.i.i:
  br label %B0.endif.endif.endif.endif.endif.endif.else.i.i
B0.endif.endif.endif.endif.endif.endif.else.i.i:
  %.1466.sroa.0.3.i.i = phi i64 [ %.1449.i, %B0.endif.endif.endif.endif.endif.else.endif.if.i.i ], [ %.1269.i.i, %B0.endif.endif.endif.endif.else.endif.endif.endif.i.i ]
  %.1579.i.i = getelementptr double, ptr %.1465.i, i64 %.1466.sroa.0.3.i.i
  br i1 %.1657.not.i.i, label %B0.endif.endif.endif.endif.endif.endif.endif.i.i, label %B0.endif.endif.endif.endif.endif.endif.else.endif.if.i.i, !prof !31
B0.endif.endif.endif.endif.endif.endif.endif.i.i:
  %.1637.sroa.0.3.i.i = phi i64 [ %.1449.i, %B0.endif.endif.endif.endif.endif.endif.else.endif.if.i.i ], [ %.1611.i.i, %B0.endif.endif.endif.endif.endif.endif.else.i.i ]
  %.1750.i.i = getelementptr double, ptr %.1465.i, i64 %.1637.sroa.0.3.i.i
  %scevgep.i168.i.i = getelementptr i8, ptr %.5269.i, i64 16
  br label %B56.i.i.i
B56.i.i.i:
  %lsr.iv3.i.i.i = phi i64 [ %lsr.iv.next.i.i.i, %B88.i.i.i ], [ %56, %B0.endif.endif.endif.endif.endif.endif.endif.i.i ]
  %lsr.iv.i.i.i = phi ptr [ %scevgep1.i.i.i, %B88.i.i.i ], [ %scevgep.i168.i.i, %B0.endif.endif.endif.endif.endif.endif.endif.i.i ]
  %scevgep1.i.i.i = getelementptr i8, ptr %lsr.iv.i.i.i, i64 48
  %lsr.iv.next.i.i.i = add i64 %lsr.iv3.i.i.i, -1
  %exitcond.not.i169.i.i = icmp eq i64 %lsr.iv.next.i.i.i, 0
  br i1 %exitcond.not.i169.i.i, label %B0.endif.endif.endif.endif.endif.endif.endif.endif.endif.i.i, label %B58.i.i.i
B58.i.i.i:
  %scevgep2.i170.i.i = getelementptr i8, ptr %lsr.iv.i.i.i, i64 -8
  %.215.i.i.i = load double, ptr %scevgep2.i170.i.i, align 8, !noalias !93
  %.216.i.i.i = fcmp une double %.215.i.i.i, 0.000000e+00
  br i1 %.216.i.i.i, label %B0.endif.endif.endif.endif.endif.endif.endif.endif.endif.i.i, label %B88.i.i.i
B88.i.i.i:
  %.274.i.i.i = load double, ptr %lsr.iv.i.i.i, align 8, !noalias !93
  %.275.i.i.i = fcmp une double %.274.i.i.i, 0.000000e+00
  br i1 %.275.i.i.i, label %B0.endif.endif.endif.endif.endif.endif.endif.endif.endif.i.i, label %B56.i.i.i
B0.endif.endif.endif.endif.endif.endif.else.endif.if.i.i:
  br label %B0.endif.endif.endif.endif.endif.endif.endif.i.i
B0.endif.endif.endif.endif.endif.endif.endif.endif.endif.i.i:
  %.1909.i.i = load double, ptr %.1908.i.i, align 8, !noalias !28
  %.40.i.i.i = fsub double %.4486.i, %.4486.i
  %scevgep.i172.i.i = getelementptr i8, ptr %.5269.i, i64 40
  br label %B450.else.i.i
B450.else.i.i:
  %.208128522854.i.i = phi i64 [ 0, %B0.endif.endif.endif.endif.endif.endif.endif.endif.endif.i.i ], [ %.2088.i.i, %B450.endif.endif.i.i ]
  %.2088.i.i = add nuw nsw i64 %.208128522854.i.i, 1
  %.2114.i.i = mul nuw nsw i64 %.208128522854.i.i, %.1806.i
  %.2117.i.i = mul nuw nsw i64 %.2088.i.i, %.1806.i
  %.2164.not.i.i = icmp sgt i64 %.1968.i, %.2114.i.i
  br i1 %.2164.not.i.i, label %B450.else.endif.endif.endif.i.i, label %B450.else.endif.if.i.i, !prof !31
B450.endif.i.i:
  %.2144.sroa.13.0.i.i = phi i64 [ %.2117.i.i, %B450.else.endif.endif.endif.i.i ], [ %.1977.i, %B450.else.endif.endif.endif.if.i.i ]
  %.132223.not.i.not.i.i = icmp sgt i64 %.2144.sroa.13.0.i.i, %.2144.sroa.0.3.i.i
  br i1 %.132223.not.i.not.i.i, label %B56.i173.i.i, label %B450.endif.endif.i.i
B56.i173.i.i:
  %lsr.iv455.i.i = phi i64 [ %lsr.iv.next456.i.i, %B316.i.i.i ], [ %.2144.sroa.0.3.i.i, %B450.endif.i.i ]
  %lsr.iv.i174.i.i = phi ptr [ %scevgep1.i177.i.i, %B316.i.i.i ], [ %scevgep.i172.i.i, %B450.endif.i.i ]
  %scevgep6.i.i.i = getelementptr i8, ptr %lsr.iv.i174.i.i, i64 -40
  %.227.i.i.i = load double, ptr %scevgep6.i.i.i, align 8, !noalias !96
  %scevgep5.i175.i.i = getelementptr i8, ptr %lsr.iv.i174.i.i, i64 -32
  %.282.i.i.i = load double, ptr %scevgep5.i175.i.i, align 8, !noalias !96
  %.284.i.i.i = fmul double %.40.i.i.i, %.282.i.i.i
  %.285.i.i.i = fadd double %.227.i.i.i, %.284.i.i.i
  %scevgep4.i176.i.i = getelementptr i8, ptr %lsr.iv.i174.i.i, i64 -24
  %.347.i.i.i = load double, ptr %scevgep4.i176.i.i, align 8, !noalias !96
  %.348.i.i.i = fcmp une double %.347.i.i.i, 0.000000e+00
  br i1 %.348.i.i.i, label %B134.i.i.i, label %B316.i.i.i
B134.i.i.i:
  %scevgep3.i179.i.i = getelementptr i8, ptr %lsr.iv.i174.i.i, i64 -16
  %.405.i.i.i = load double, ptr %scevgep3.i179.i.i, align 8, !noalias !96
  %scevgep2.i180.i.i = getelementptr i8, ptr %lsr.iv.i174.i.i, i64 -8
  %.460.i.i.i = load double, ptr %scevgep2.i180.i.i, align 8, !noalias !96
  %.461.i.i.i = fmul double %.460.i.i.i, 5.000000e-01
  %.463.i.i.i = fmul double %.40.i.i.i, %.461.i.i.i
  %.464.i.i.i = fadd double %.405.i.i.i, %.463.i.i.i
  %.465.i.i.i = fmul double %.464.i.i.i, 0x401921FB54442D18
  %.467.i.i.i = fmul double %.40.i.i.i, %.465.i.i.i
  %.522.i.i.i = load double, ptr %lsr.iv.i174.i.i, align 8, !noalias !96
  %.523.i.i.i = fadd double %.522.i.i.i, %.467.i.i.i
  %.586.le.i.i.i = tail call double @llvm.sin.f64(double %.523.i.i.i)
  %.591.i.i.i = fmul double %.347.i.i.i, %.586.le.i.i.i
  %.593.i.i.i = fadd double %.285.i.i.i, %.591.i.i.i
  br label %B316.i.i.i
B316.i.i.i:
  %value.2.1.i.i.i = phi double [ %.593.i.i.i, %B134.i.i.i ], [ %.285.i.i.i, %B56.i173.i.i ]
  %29 = shl i64 %lsr.iv455.i.i, 3
  %scevgep457.i.i = getelementptr i8, ptr %.1993.i, i64 %29
  store double %value.2.1.i.i.i, ptr %scevgep457.i.i, align 8, !noalias !96
  %scevgep1.i177.i.i = getelementptr i8, ptr %lsr.iv.i174.i.i, i64 48
  %lsr.iv.next456.i.i = add i64 %lsr.iv455.i.i, 1
  %exitcond.not.i178.i.i = icmp eq i64 %.2144.sroa.13.0.i.i, %lsr.iv.next456.i.i
  br i1 %exitcond.not.i178.i.i, label %B450.endif.endif.i.i, label %B56.i173.i.i
B450.else.endif.if.i.i:
  br label %B450.else.endif.endif.endif.i.i
B450.else.endif.endif.endif.i.i:
  %.2144.sroa.0.3.i.i = phi i64 [ %.1977.i, %B450.else.endif.if.i.i ], [ %.2114.i.i, %B450.else.i.i ]
  %.2181.not.i.i = icmp sgt i64 %.1968.i, %.2117.i.i
  br i1 %.2181.not.i.i, label %B450.endif.i.i, label %B450.else.endif.endif.endif.if.i.i, !prof !31
B450.else.endif.endif.endif.if.i.i:
  br label %B450.endif.i.i
B450.endif.endif.i.i:
  %exitcond.not.i1.i = icmp eq i64 %.2088.i.i, 4
  br i1 %exitcond.not.i1.i, label %B534.i.i, label %B450.else.i.i
switch.lookup.i.i:
  %.282128582861.i.i = phi i64 [ %.2828.i.i, %switch.end.endif.endif.i.i ], [ 0, %B820.i.i ]
  %.2828.i.i = add nuw nsw i64 %.282128582861.i.i, 1
  %switch.gep.i.i = getelementptr inbounds double, ptr @v22, i64 %.282128582861.i.i
  %switch.load.i.i = load double, ptr %switch.gep.i.i, align 8, !noalias !28
  %.2885.i.i = fmul double %"$phi820.0.2.1.in.sroa.speculated.i.i", %switch.load.i.i
  %.2887.i.i = fadd double %t.2.0.i.i, %.2885.i.i
  %.2889.i.i = mul nuw nsw i64 %.282128582861.i.i, %.1806.i
  %.2892.i.i = mul nuw nsw i64 %.2828.i.i, %.1806.i
  %.2939.not.i.i = icmp sgt i64 %.1968.i, %.2889.i.i
  br i1 %.2939.not.i.i, label %switch.end.else.endif.endif.endif.i.i, label %switch.end.else.endif.if.i.i, !prof !31
switch.end.endif.i.i:
  %.2919.sroa.13.0.i.i = phi i64 [ %.2892.i.i, %switch.end.else.endif.endif.endif.i.i ], [ %.1977.i, %switch.end.else.endif.endif.endif.if.i.i ]
  %.40.i182.i.i = fsub double %.2887.i.i, %.4486.i
  %.132223.not.i183.not.i.i = icmp sgt i64 %.2919.sroa.13.0.i.i, %.2919.sroa.0.3.i.i
  br i1 %.132223.not.i183.not.i.i, label %B56.i186.i.i, label %switch.end.endif.endif.i.i
B56.i186.i.i:
  %lsr.iv.i4.i = phi i64 [ %lsr.iv.next.i.i, %B316.i199.i.i ], [ %.2919.sroa.0.3.i.i, %switch.end.endif.i.i ]
  %lsr.iv.i187.i.i = phi ptr [ %scevgep1.i202.i.i, %B316.i199.i.i ], [ %scevgep.i172.i.i, %switch.end.endif.i.i ]
  %scevgep6.i190.i.i = getelementptr i8, ptr %lsr.iv.i187.i.i, i64 -40
  %.227.i191.i.i = load double, ptr %scevgep6.i190.i.i, align 8, !noalias !99
  %scevgep5.i192.i.i = getelementptr i8, ptr %lsr.iv.i187.i.i, i64 -32
  %.282.i193.i.i = load double, ptr %scevgep5.i192.i.i, align 8, !noalias !99
  %.284.i194.i.i = fmul double %.40.i182.i.i, %.282.i193.i.i
  %.285.i195.i.i = fadd double %.227.i191.i.i, %.284.i194.i.i
  %scevgep4.i196.i.i = getelementptr i8, ptr %lsr.iv.i187.i.i, i64 -24
  %.347.i197.i.i = load double, ptr %scevgep4.i196.i.i, align 8, !noalias !99
  %.348.i198.i.i = fcmp une double %.347.i197.i.i, 0.000000e+00
  br i1 %.348.i198.i.i, label %B134.i204.i.i, label %B316.i199.i.i
B134.i204.i.i:
  %scevgep3.i205.i.i = getelementptr i8, ptr %lsr.iv.i187.i.i, i64 -16
  %.405.i206.i.i = load double, ptr %scevgep3.i205.i.i, align 8, !noalias !99
  %scevgep2.i207.i.i = getelementptr i8, ptr %lsr.iv.i187.i.i, i64 -8
  %.460.i208.i.i = load double, ptr %scevgep2.i207.i.i, align 8, !noalias !99
  %.461.i209.i.i = fmul double %.460.i208.i.i, 5.000000e-01
  %.463.i210.i.i = fmul double %.40.i182.i.i, %.461.i209.i.i
  %.464.i211.i.i = fadd double %.405.i206.i.i, %.463.i210.i.i
  %.465.i212.i.i = fmul double %.464.i211.i.i, 0x401921FB54442D18
  %.467.i213.i.i = fmul double %.40.i182.i.i, %.465.i212.i.i
  %.522.i214.i.i = load double, ptr %lsr.iv.i187.i.i, align 8, !noalias !99
  %.523.i215.i.i = fadd double %.522.i214.i.i, %.467.i213.i.i
  %.586.le.i216.i.i = tail call double @llvm.sin.f64(double %.523.i215.i.i)
  %.591.i217.i.i = fmul double %.347.i197.i.i, %.586.le.i216.i.i
  %.593.i218.i.i = fadd double %.285.i195.i.i, %.591.i217.i.i
  br label %B316.i199.i.i
B316.i199.i.i:
  %value.2.1.i200.i.i = phi double [ %.593.i218.i.i, %B134.i204.i.i ], [ %.285.i195.i.i, %B56.i186.i.i ]
  %30 = shl i64 %lsr.iv.i4.i, 3
  %scevgep449.i.i = getelementptr i8, ptr %.1993.i, i64 %30
  store double %value.2.1.i200.i.i, ptr %scevgep449.i.i, align 8, !noalias !99
  %scevgep1.i202.i.i = getelementptr i8, ptr %lsr.iv.i187.i.i, i64 48
  %lsr.iv.next.i.i = add i64 %lsr.iv.i4.i, 1
  %exitcond.not.i203.i.i = icmp eq i64 %.2919.sroa.13.0.i.i, %lsr.iv.next.i.i
  br i1 %exitcond.not.i203.i.i, label %switch.end.endif.endif.i.i, label %B56.i186.i.i
switch.end.else.endif.if.i.i:
  br label %switch.end.else.endif.endif.endif.i.i
switch.end.else.endif.endif.endif.i.i:
  %.2919.sroa.0.3.i.i = phi i64 [ %.1977.i, %switch.end.else.endif.if.i.i ], [ %.2889.i.i, %switch.lookup.i.i ]
  %.2956.not.i.i = icmp sgt i64 %.1968.i, %.2892.i.i
  br i1 %.2956.not.i.i, label %switch.end.endif.i.i, label %switch.end.else.endif.endif.endif.if.i.i, !prof !31
switch.end.else.endif.endif.endif.if.i.i:
  br label %switch.end.endif.i.i
switch.end.endif.endif.i.i:
  %exitcond.not312.i.i = icmp eq i64 %.2828.i.i, 4
  br i1 %exitcond.not312.i.i, label %B980.i.i, label %switch.lookup.i.i
B1016.endif.thread.i.i:
  %.3365229.i.i = load i64, ptr %sunkaddr246.i.i, align 8, !noalias !28
  %.3366230.i.i = add nsw i64 %.3365229.i.i, 1
  store i64 %.3366230.i.i, ptr %sunkaddr246.i.i, align 8, !noalias !28
  br label %B1214.i.i
B1016.endif.i.i:
  %.3365.i.i = load i64, ptr %sunkaddr246.i.i, align 8, !noalias !28
  %.3366.i.i = add nsw i64 %.3365.i.i, 1
  store i64 %.3366.i.i, ptr %sunkaddr246.i.i, align 8, !noalias !28
  %.3398.i.i = fcmp ugt double %worst.3.1.i.i.i, 1.000000e+00
  br i1 %.3398.i.i, label %B1214.i.i, label %B1262.i.i
B1474.endif.i.i:
  %.12.i.i.i = fcmp olt double %storemerge.i150233.i.i, 1.000000e-10
  %.13.i155.i.i = select i1 %.12.i.i.i, double 1.000000e-10, double %storemerge.i150233.i.i
  %.17.i.i.i = tail call double @llvm.pow.f64(double %.13.i155.i.i, double -2.500000e-01)
  %.18.i.i.i = fmul double %.17.i.i.i, 9.000000e-01
  %.27.i.i.i = fcmp ogt double %step_before.3.0.i.i, 0.000000e+00
  br i1 %.27.i.i.i, label %B42.endif.i.i.i, label %B1474.endif.endif.endif.i.i
B42.endif.i.i.i:
  %.34.i.i.i = fdiv double %"$phi820.0.2.1.in.sroa.speculated.i.i", %step_before.3.0.i.i
  %.39.i.i.i = fmul double %.34.i.i.i, 9.000000e-01
  %.42.i.i.i = fmul double %.13.i155.i.i, %.13.i155.i.i
  %.49.i.i.i = fdiv double %error_before.2.0.i.i, %.42.i.i.i
  %.52.i.i.i = tail call double @llvm.pow.f64(double %.49.i.i.i, double 2.500000e-01)
  %.53.i.i.i = fmul double %.39.i.i.i, %.52.i.i.i
  %.12.i1.i.i.i = fcmp olt double %.53.i.i.i, %.18.i.i.i
  %.13.i2.i.i.i = select i1 %.12.i1.i.i.i, double %.53.i.i.i, double %.18.i.i.i
  br label %B1474.endif.endif.endif.i.i
B1474.endif.endif.endif.i.i:
  %factor.2.0.i.i.i = phi double [ %.18.i.i.i, %B1474.endif.i.i ], [ %.13.i2.i.i.i, %B42.endif.i.i.i ]
  %.12.i.i220.i.i = fcmp ogt double %factor.2.0.i.i.i, 1.500000e-01
  %.13.i.i221.i.i = select i1 %.12.i.i220.i.i, double %factor.2.0.i.i.i, double 1.500000e-01
  %.12.i3.i.i.i = fcmp olt double %.13.i.i221.i.i, 6.000000e+00
  %.13.i4.i.i.i = select i1 %.12.i3.i.i.i, double %.13.i.i221.i.i, double 6.000000e+00
  %.12.i222.i.i = fcmp ogt double %.13.i155.i.i, 1.000000e-02
  %.13.i223.i.i = select i1 %.12.i222.i.i, double %.13.i155.i.i, double 1.000000e-02
  br i1 %has_changed.3.0.i.i, label %B1608.endif.endif.i.i, label %B1678.i.i
B1608.endif.endif.i.i:
  %.12.i156.i.i = fcmp ogt double %.13.i4.i.i.i, 5.000000e-01
  %.13.i157.i.i = select i1 %.12.i156.i.i, double %.13.i4.i.i.i, double 5.000000e-01
  %.12.i224.i.i = fcmp olt double %.13.i157.i.i, 2.000000e+00
  %.13.i225.i.i = select i1 %.12.i224.i.i, double %.13.i157.i.i, double 2.000000e+00
  %.4133.i.i = fmul double %"$phi820.0.2.1.in.sroa.speculated.i.i", %.13.i225.i.i
  br label %B1678.i.i
B1946.endif.i.i:
  %.12.i162.i.i = fcmp olt double %first.2.1.i.i, %"$phi1772.0.2.1.i.i"
  %.13.i163.i.i = select i1 %.12.i162.i.i, double %first.2.1.i.i, double %"$phi1772.0.2.1.i.i"
  br label %B2208.i.i
for.end.1.i.i:
  br i1 %.3411.le.i.i, label %B2040.endif.i.i, label %B2144.i.i
B2040.endif.i.i:
  %.4645.i.i = tail call double @llvm.pow.f64(double %storemerge.i150232.i.i, double -2.500000e-01)
  %.4648.i.i = fmul double %.4645.i.i, 9.000000e-01
  %.12.i164.i.i = fcmp olt double %.4648.i.i, 8.000000e-01
  %.13.i165.i.i = select i1 %.12.i164.i.i, double %.4648.i.i, double 8.000000e-01
  %.12.i226.i.i = fcmp ogt double %.13.i165.i.i, 1.500000e-01
  %.13.i227.i.i = select i1 %.12.i226.i.i, double %.13.i165.i.i, double 1.500000e-01
  br label %B2144.i.i
B2324.else.if.i.i:
  %.5441.i.i = icmp ne i64 %.114.i.i.i, 0
  %window.3.1.i.i = select i1 %.5441.i.i, double %window.2.0.i.i, double %t.3.1.i.i
  %has_acted.5.1.i.i = select i1 %.5441.i.i, i1 %has_acted.3.1.i.i, i1 false
  %.5510.i.i = fcmp olt double %t.3.1.i.i, %"$phi1578.1.2.1.i"
  br i1 %.5510.i.i, label %B548.i.i, label %_ZN6poppet6engine10integrator8_segmentB3v14B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
_ZN6poppet6engine10integrator8_segmentB3v14B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i:
  %.5501.sroa.12.2.i = phi double [ %"$phi1908.1.2.1.i", %B534.i.i ], [ %h.7.1.i.i, %B2314.split.loop.exit.i.i ], [ %"$phi820.0.2.1.in.sroa.speculated.i.i", %_ZN6poppet6engine10integrator7_acceptB3v25B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i.i ], [ %.4716.i.i, %B2144.i.i ], [ %h.7.1.i.i, %B44.i.i.i ], [ %h.7.1.i.i, %B2324.else.if.i.i ]
  %.5501.sroa.7.2.i = phi double [ %.4486.i, %B534.i.i ], [ %t.3.1.i.i, %B2314.split.loop.exit.i.i ], [ %reached.3.0.i.i.i, %_ZN6poppet6engine10integrator7_acceptB3v25B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i.i ], [ %t.2.0.i.i, %B2144.i.i ], [ %t.3.1.i.i, %B44.i.i.i ], [ %t.3.1.i.i, %B2324.else.if.i.i ]
  %.5501.sroa.0.2.i = phi i64 [ 0, %B534.i.i ], [ %.mux.le.i.i, %B2314.split.loop.exit.i.i ], [ 1, %_ZN6poppet6engine10integrator7_acceptB3v25B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i.i ], [ 2, %B2144.i.i ], [ 2, %B44.i.i.i ], [ 0, %B2324.else.if.i.i ]
  call void @llvm.lifetime.end.p0(ptr nonnull %.4389.i.i), !noalias !21
  %.5936.not.i = icmp eq i64 %.5501.sroa.0.2.i, 0
  br i1 %.5936.not.i, label %B2242.i, label %B2246.i
B2088.i:
  call void @llvm.lifetime.start.p0(ptr nonnull %.362.i.i), !noalias !21
  call void @llvm.lifetime.start.p0(ptr nonnull %.1023.i.i), !noalias !21
  %.287.i.i = load i64, ptr %sunkaddr468.i, align 8, !noalias !102
  %.299.i.i = fcmp olt double %.4486.i, %"$phi1578.1.2.1.i"
  br i1 %.299.i.i, label %B48.preheader.i.i, label %_ZN6poppet6engine10integrator15_without_statesB3v34B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i
B48.preheader.i.i:
  %.5.i14.i.i = fmul double %"$phi1578.1.2.1.i", 0x3D06849B86A12B9B
  %.6.i15.i.i = fadd double %.5.i14.i.i, 1.000000e-15
  %.480.i.i = fsub double %"$phi1578.1.2.1.i", %.6.i15.i.i
  %scevgep.i43.i.i.i = getelementptr i8, ptr %.5269.i, i64 40
  %31 = inttoptr i64 %.287.i.i to ptr
  br label %B48.i.i
B48.i.i:
  %t.2.0.i7.i = phi double [ %end.5.1.i.i, %B736.i.i ], [ %.4486.i, %B48.preheader.i.i ]
  br i1 %.not.i.i, label %B272.i.i, label %B74.i.i
B74.i.i:
  %.350.i8.i = load i64, ptr %sunkaddr465.i, align 8, !noalias !102
  call fastcc void @v36(ptr nonnull %.362.i.i, i64 %.350.i8.i, double %t.2.0.i7.i, double %.4486.i, ptr readonly %.5269.i, ptr %a2, i64 %.1806.i, ptr %.1822.i, ptr %a3, i64 %.1170.i, ptr %.1186.i, ptr %.2336.i, i64 %.3526.i, ptr %.3542.i, ptr %.3715.i, ptr readonly %a13)
  br i1 %53, label %B58.backedge.epil.preheader.i.i.i, label %B58.backedge.i.i.i
B268.i.i:
  br label %B272.i.i
B272.i.i:
  %end.4.1.i.i = phi double [ %"$phi1578.1.2.1.i", %B48.i.i ], [ %"$phi1578.1.2.1.i", %B268.i.i ], [ %first.2.0.lcssa.i.i.i, %B74.endif.endif.endif.endif.i.i ]
  br i1 %49, label %B306.i.i, label %B736.i.i
B306.i.i:
  %.555.i.i = load i64, ptr %sunkaddr.i6.i, align 8, !noalias !102
  %.572.i.i = icmp slt i64 %.555.i.i, %.570.i.i
  br i1 %.572.i.i, label %B350.endif.i.i, label %B520.endif.i.i
B416.i.i:
  %row.2.3.i.i = phi i64 [ %.647.i.i, %B454.endif.i.i ], [ %.555.i.i, %B350.endif.i.i ]
  %exitcond.not.i50.i = icmp eq i64 %52, %row.2.3.i.i
  br i1 %exitcond.not.i50.i, label %B520.endif.i.i, label %B454.endif.i.i
B736.i.i:
  %end.5.1.i.i = phi double [ %"$phi724.1.2.2.i.i", %_ZN6poppet6engine8stepping11stop_insideB3v26B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE.exit.i.i ], [ %end.4.1.i.i, %B272.i.i ]
  %.1006.i.i = fsub double %end.5.1.i.i, %t.2.0.i7.i
  call fastcc void @v37(ptr nonnull %.1023.i.i, i64 %.287.i.i, double %t.2.0.i7.i, double %.1006.i.i, double %end.5.1.i.i, double %.4486.i, ptr readonly %.5269.i, ptr %a2, ptr %a2, ptr %a2, i64 %.25.i, ptr %a2, i64 %.1806.i, ptr %.1822.i, ptr %a3, ptr %.2336.i, i64 %.3871.i, ptr %.3887.i, i64 %.71.i, ptr readonly %a7, i64 %.71.i, ptr %a14, i64 %.71.i, ptr %a17)
  %.1112.i.i = load i64, ptr %.4258.i, align 8, !noalias !102
  %.1113.i.i = icmp slt i64 %.1112.i.i, 0
  %.1223.i.i = fcmp olt double %end.5.1.i.i, %"$phi1578.1.2.1.i"
  %or.cond.i12.i = select i1 %.1113.i.i, i1 %.1223.i.i, i1 false
  br i1 %or.cond.i12.i, label %B48.i.i, label %_ZN6poppet6engine10integrator15_without_statesB3v34B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i
B58.backedge.i.i.i:
  %first.2.065.i.i.i = phi double [ %.13.i.3.i.i.i, %B58.backedge.i.i.i ], [ 0x7FF0000000000000, %B74.i.i ]
  %.1096163.i.i.i = phi i64 [ %.116.3.i.i.i, %B58.backedge.i.i.i ], [ 0, %B74.i.i ]
  %sunkaddr40.i.i = shl i64 %.1096163.i.i.i, 3
  %sunkaddr41.i.i = getelementptr i8, ptr %.1186.i, i64 %sunkaddr40.i.i
  %.170.i.i.i = load double, ptr %sunkaddr41.i.i, align 8, !noalias !105
  %.12.i.i.i9.i = fcmp olt double %.170.i.i.i, %first.2.065.i.i.i
  %.13.i.i.i10.i = select i1 %.12.i.i.i9.i, double %.170.i.i.i, double %first.2.065.i.i.i
  %sunkaddr44.i.i = getelementptr i8, ptr %sunkaddr41.i.i, i64 8
  %.170.1.i.i.i = load double, ptr %sunkaddr44.i.i, align 8, !noalias !105
  %.12.i.1.i.i.i = fcmp olt double %.170.1.i.i.i, %.13.i.i.i10.i
  %.13.i.1.i.i.i = select i1 %.12.i.1.i.i.i, double %.170.1.i.i.i, double %.13.i.i.i10.i
  %sunkaddr47.i.i = getelementptr i8, ptr %sunkaddr41.i.i, i64 16
  %.170.2.i.i.i = load double, ptr %sunkaddr47.i.i, align 8, !noalias !105
  %.12.i.2.i.i.i = fcmp olt double %.170.2.i.i.i, %.13.i.1.i.i.i
  %.13.i.2.i.i.i = select i1 %.12.i.2.i.i.i, double %.170.2.i.i.i, double %.13.i.1.i.i.i
  %sunkaddr50.i.i = getelementptr i8, ptr %sunkaddr41.i.i, i64 24
  %.170.3.i.i.i = load double, ptr %sunkaddr50.i.i, align 8, !noalias !105
  %.12.i.3.i.i.i = fcmp olt double %.170.3.i.i.i, %.13.i.2.i.i.i
  %.13.i.3.i.i.i = select i1 %.12.i.3.i.i.i, double %.170.3.i.i.i, double %.13.i.2.i.i.i
  %.116.3.i.i.i = add nuw nsw i64 %.1096163.i.i.i, 4
  %niter.ncmp.3.i.i.i = icmp eq i64 %unroll_iter.i.i.i, %.116.3.i.i.i
  br i1 %niter.ncmp.3.i.i.i, label %common.ret.loopexit.unr-lcssa.i.i.i, label %B58.backedge.i.i.i
common.ret.loopexit.unr-lcssa.i.i.i:
  br i1 %54, label %B74.endif.endif.endif.endif.i.i, label %B58.backedge.epil.preheader.i.i.i
B58.backedge.epil.preheader.i.i.i:
  %first.2.065.epil.init.i.i.i = phi double [ 0x7FF0000000000000, %B74.i.i ], [ %.13.i.3.i.i.i, %common.ret.loopexit.unr-lcssa.i.i.i ]
  %.1096163.epil.init.i.i.i = phi i64 [ 0, %B74.i.i ], [ %unroll_iter.i.i.i, %common.ret.loopexit.unr-lcssa.i.i.i ]
  %32 = shl i64 %.1096163.epil.init.i.i.i, 3
  %scevgep.i.i11.i = getelementptr i8, ptr %.1186.i, i64 %32
  br label %B58.backedge.epil.i.i.i
B58.backedge.epil.i.i.i:
  %first.2.065.epil.i.i.i = phi double [ %.13.i.epil.i.i.i, %B58.backedge.epil.i.i.i ], [ %first.2.065.epil.init.i.i.i, %B58.backedge.epil.preheader.i.i.i ]
  %epil.iter.i.i.i = phi i64 [ %epil.iter.next.i.i.i, %B58.backedge.epil.i.i.i ], [ 0, %B58.backedge.epil.preheader.i.i.i ]
  %33 = shl i64 %epil.iter.i.i.i, 3
  %scevgep49.i.i = getelementptr i8, ptr %scevgep.i.i11.i, i64 %33
  %.170.epil.i.i.i = load double, ptr %scevgep49.i.i, align 8, !noalias !105
  %.12.i.epil.i.i.i = fcmp olt double %.170.epil.i.i.i, %first.2.065.epil.i.i.i
  %.13.i.epil.i.i.i = select i1 %.12.i.epil.i.i.i, double %.170.epil.i.i.i, double %first.2.065.epil.i.i.i
  %epil.iter.next.i.i.i = add i64 %epil.iter.i.i.i, 1
  %epil.iter.cmp.not.i.i.i = icmp eq i64 %xtraiter.i.i.i, %epil.iter.next.i.i.i
  br i1 %epil.iter.cmp.not.i.i.i, label %B74.endif.endif.endif.endif.i.i, label %B58.backedge.epil.i.i.i, !llvm.loop !108
B74.endif.endif.endif.endif.i.i:
  %first.2.0.lcssa.i.i.i = phi double [ %.13.i.3.i.i.i, %common.ret.loopexit.unr-lcssa.i.i.i ], [ %.13.i.epil.i.i.i, %B58.backedge.epil.i.i.i ]
  %.482.i.i = fcmp olt double %first.2.0.lcssa.i.i.i, %.480.i.i
  br i1 %.482.i.i, label %B272.i.i, label %B268.i.i
B350.endif.i.i:
  %.595.i.i = icmp slt i64 %.555.i.i, 0
  %.596.i.i = select i1 %.595.i.i, i64 %.71.i, i64 0
  %34 = getelementptr double, ptr %a7, i64 %.555.i.i
  %.610.i.i = getelementptr double, ptr %34, i64 %.596.i.i
  %.611.i.i = load double, ptr %.610.i.i, align 8, !noalias !102
  %.5.i.i48.i = fmul double %t.2.0.i7.i, 0x3D06849B86A12B9B
  %.6.i.i49.i = fadd double %.5.i.i48.i, 1.000000e-15
  %.640.i.i = fadd double %t.2.0.i7.i, %.6.i.i49.i
  %.641.i.i = fcmp ugt double %.611.i.i, %.640.i.i
  br i1 %.641.i.i, label %B520.endif.i.i, label %B416.i.i
B454.endif.i.i:
  %.647.i.i = add i64 %row.2.3.i.i, 1
  %.687.i.i = icmp slt i64 %row.2.3.i.i, -1
  %35 = select i1 %.687.i.i, i64 %.16.i.i, i64 0
  %36 = shl i64 %row.2.3.i.i, 3
  %scevgep37.i.i = getelementptr i8, ptr %scevgep36.i.i, i64 %35
  %scevgep38.i.i = getelementptr i8, ptr %scevgep37.i.i, i64 %36
  %.703.i51.i = load double, ptr %scevgep38.i.i, align 8, !noalias !102
  %.733.i.i = fcmp ugt double %.703.i51.i, %.640.i.i
  br i1 %.733.i.i, label %B520.endif.i.i, label %B416.i.i
B520.endif.i.i:
  %row.3.2.i.i = phi i64 [ %.555.i.i, %B350.endif.i.i ], [ %.555.i.i, %B306.i.i ], [ %.570.i.i, %B416.i.i ], [ %.647.i.i, %B454.endif.i.i ]
  %.760.i.i = icmp slt i64 %row.3.2.i.i, 0
  %.761.i.i = select i1 %.760.i.i, i64 %.71.i, i64 0
  %37 = getelementptr double, ptr %a7, i64 %row.3.2.i.i
  %.775.i.i = getelementptr double, ptr %37, i64 %.761.i.i
  %.776.i.i = load double, ptr %.775.i.i, align 8, !noalias !102
  %.5.i12.i.i = fmul double %end.4.1.i.i, 0x3D06849B86A12B9B
  %.6.i13.i.i = fadd double %.5.i12.i.i, 1.000000e-15
  %.803.i.i = fsub double %end.4.1.i.i, %.6.i13.i.i
  %.804.i.i = fcmp olt double %.776.i.i, %.803.i.i
  %"$phi604.0.2.2.i.i" = select i1 %.804.i.i, double %.776.i.i, double %end.4.1.i.i
  %.861.i.i = fsub double %"$phi604.0.2.2.i.i", %t.2.0.i7.i
  %.555.i.i.i = fadd double %t.2.0.i7.i, %.861.i.i
  %.556.i.i.i = fmul double %.555.i.i.i, 4.000000e-16
  br label %B18.outer.i.i.i
B18.outer.i.i.i:
  %low.4.1.ph.i.i.i = phi double [ 0.000000e+00, %B520.endif.i.i ], [ %low.3.2.i.i.i, %B240.i.i.i ]
  %high.3.1.ph.i.i.i = phi double [ 5.000000e-01, %B520.endif.i.i ], [ %.544.i.i.i, %B240.i.i.i ]
  %event.2.1.ph.i.i.i = phi i64 [ -1, %B520.endif.i.i ], [ %event.4.2.i.i.i, %B240.i.i.i ]
  %theta.2.1.ph.i.i.i = phi double [ 0.000000e+00, %B520.endif.i.i ], [ %theta.1.2.i.i.i, %B240.i.i.i ]
  br label %B18.i.i.i
B18.i.i.i:
  %low.4.1.i.i.i = phi double [ 5.000000e-01, %B186.i.i.i ], [ %low.4.1.ph.i.i.i, %B18.outer.i.i.i ]
  %high.3.1.i.i.i = phi double [ 1.000000e+00, %B186.i.i.i ], [ %high.3.1.ph.i.i.i, %B18.outer.i.i.i ]
  %event.2.1.i.i.i = phi i64 [ -1, %B186.i.i.i ], [ %event.2.1.ph.i.i.i, %B18.outer.i.i.i ]
  %.275.i.i13.i = fmul double %.861.i.i, %high.3.1.i.i.i
  %.277.i.i.i = fadd double %t.2.0.i7.i, %.275.i.i13.i
  %.40.i.i.i14.i = fsub double %.277.i.i.i, %.4486.i
  br i1 %50, label %B18.endif.endif.i.i.i, label %B56.i.i.i15.i
B186.i.i.i:
  %.381.i.i.i = fcmp oeq double %high.3.1.i.i.i, 1.000000e+00
  br i1 %.381.i.i.i, label %_ZN6poppet6engine8stepping11stop_insideB3v26B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE.exit.i.i, label %B18.i.i.i
B240.i.i.i:
  %low.3.2.i.i.i = phi double [ %low.4.1.i.i.i, %B252.1.i.i.i.i ], [ %high.3.1.i.i.i, %B18.endif.endif.endif.thread13.i.i.i ]
  %theta.1.2.i.i.i = phi double [ %high.3.1.i.i.i, %B252.1.i.i.i.i ], [ %theta.2.1.ph.i.i.i, %B18.endif.endif.endif.thread13.i.i.i ]
  %event.4.2.i.i.i = phi i64 [ %.284326331.i.i.i.i, %B252.1.i.i.i.i ], [ %event.2.1.i.i.i, %B18.endif.endif.endif.thread13.i.i.i ]
  %.543.i.i.i = fadd double %low.3.2.i.i.i, %theta.1.2.i.i.i
  %.544.i.i.i = fmul double %.543.i.i.i, 5.000000e-01
  %.550.i.i.i = fsub double %theta.1.2.i.i.i, %low.3.2.i.i.i
  %.552.i.i32.i = fmul double %.861.i.i, %.550.i.i.i
  %.557.i.i.i = fcmp ole double %.552.i.i32.i, %.556.i.i.i
  %.561.i.i.i = fcmp ole double %.544.i.i.i, %low.3.2.i.i.i
  %or.cond.i.i33.i = or i1 %.557.i.i.i, %.561.i.i.i
  %.565.i.i.i = fcmp oge double %.544.i.i.i, %theta.1.2.i.i.i
  %or.cond319.i.i.i = or i1 %.565.i.i.i, %or.cond.i.i33.i
  br i1 %or.cond319.i.i.i, label %_ZN6poppet6engine8stepping11stop_insideB3v26B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE.exit.i.i, label %B18.outer.i.i.i
B56.i.i.i15.i:
  %lsr.iv.i.i.i16.i = phi ptr [ %scevgep1.i46.i.i.i, %B316.i.i.i26.i ], [ %scevgep.i43.i.i.i, %B18.i.i.i ]
  %.138222224.i.i.i17.i = phi i64 [ %.145.i.i.i18.i, %B316.i.i.i26.i ], [ 0, %B18.i.i.i ]
  %.145.i.i.i18.i = add nuw nsw i64 %.138222224.i.i.i17.i, 1
  %scevgep6.i.i.i19.i = getelementptr i8, ptr %lsr.iv.i.i.i16.i, i64 -40
  %.227.i44.i.i.i = load double, ptr %scevgep6.i.i.i19.i, align 8, !noalias !109
  %scevgep5.i.i.i20.i = getelementptr i8, ptr %lsr.iv.i.i.i16.i, i64 -32
  %.282.i.i.i21.i = load double, ptr %scevgep5.i.i.i20.i, align 8, !noalias !109
  %.284.i.i.i22.i = fmul double %.40.i.i.i14.i, %.282.i.i.i21.i
  %.285.i.i.i23.i = fadd double %.227.i44.i.i.i, %.284.i.i.i22.i
  %scevgep4.i45.i.i.i = getelementptr i8, ptr %lsr.iv.i.i.i16.i, i64 -24
  %.347.i.i.i24.i = load double, ptr %scevgep4.i45.i.i.i, align 8, !noalias !109
  %.348.i.i.i25.i = fcmp une double %.347.i.i.i24.i, 0.000000e+00
  br i1 %.348.i.i.i25.i, label %B134.i.i.i35.i, label %B316.i.i.i26.i
B134.i.i.i35.i:
  %scevgep3.i48.i.i.i = getelementptr i8, ptr %lsr.iv.i.i.i16.i, i64 -16
  %.405.i.i.i36.i = load double, ptr %scevgep3.i48.i.i.i, align 8, !noalias !109
  %scevgep2.i49.i.i.i = getelementptr i8, ptr %lsr.iv.i.i.i16.i, i64 -8
  %.460.i.i.i37.i = load double, ptr %scevgep2.i49.i.i.i, align 8, !noalias !109
  %.461.i.i.i38.i = fmul double %.460.i.i.i37.i, 5.000000e-01
  %.463.i.i.i39.i = fmul double %.40.i.i.i14.i, %.461.i.i.i38.i
  %.464.i.i.i40.i = fadd double %.405.i.i.i36.i, %.463.i.i.i39.i
  %.465.i.i.i41.i = fmul double %.464.i.i.i40.i, 0x401921FB54442D18
  %.467.i.i.i42.i = fmul double %.40.i.i.i14.i, %.465.i.i.i41.i
  %.522.i.i.i43.i = load double, ptr %lsr.iv.i.i.i16.i, align 8, !noalias !109
  %.523.i.i.i44.i = fadd double %.522.i.i.i43.i, %.467.i.i.i42.i
  %.586.le.i.i.i45.i = tail call double @llvm.sin.f64(double %.523.i.i.i44.i)
  %.591.i.i.i46.i = fmul double %.347.i.i.i24.i, %.586.le.i.i.i45.i
  %.593.i.i.i47.i = fadd double %.285.i.i.i23.i, %.591.i.i.i46.i
  br label %B316.i.i.i26.i
B316.i.i.i26.i:
  %value.2.1.i.i.i27.i = phi double [ %.593.i.i.i47.i, %B134.i.i.i35.i ], [ %.285.i.i.i23.i, %B56.i.i.i15.i ]
  %38 = shl i64 %.138222224.i.i.i17.i, 3
  %scevgep7.i.i.i28.i = getelementptr i8, ptr %.1822.i, i64 %38
  store double %value.2.1.i.i.i27.i, ptr %scevgep7.i.i.i28.i, align 8, !noalias !109
  %scevgep1.i46.i.i.i = getelementptr i8, ptr %lsr.iv.i.i.i16.i, i64 48
  %exitcond.not.i47.i.i.i = icmp eq i64 %.1797.i, %.145.i.i.i18.i
  br i1 %exitcond.not.i47.i.i.i, label %B18.endif.endif.i.i.i, label %B56.i.i.i15.i
B18.endif.endif.i.i.i:
  store double %.277.i.i.i, ptr %.2336.i, align 8, !noalias !114
  tail call void %31(ptr nonnull %.2336.i, ptr %a2, ptr %.1822.i, ptr %a3, ptr %.3887.i), !noalias !114
  br label %B108.endif.endif.i.i.i.i
B106.i.i.i31.i:
  %.291.i.i.i.i = add nuw nsw i64 %.284326331.i.i.i.i, 1
  %scevgep1.i54.i.i.i = getelementptr i8, ptr %lsr.iv.i52.i.i.i, i64 16
  %scevgep5.i55.i.i.i = getelementptr i8, ptr %lsr.iv4.i.i.i.i, i64 24
  %exitcond.not.i56.i.i.i = icmp eq i64 %.73.i, %.291.i.i.i.i
  br i1 %exitcond.not.i56.i.i.i, label %B18.endif.endif.endif.thread13.i.i.i, label %B108.endif.endif.i.i.i.i
B192.i.i.i.i:
  %sunkaddr.i.i.i.i = getelementptr i8, ptr %lsr.iv4.i.i.i.i, i64 -16
  %.612.i.i.i34.i = load double, ptr %sunkaddr.i.i.i.i, align 8, !noalias !114
  %.701.i.i.i.i = getelementptr double, ptr %.3887.i, i64 %.554.i.i.i.i
  %.702.i.i.i.i = load double, ptr %.701.i.i.i.i, align 8, !noalias !114
  %.703.i.i.i.i = fmul double %.612.i.i.i34.i, %.702.i.i.i.i
  %.705.i.i.i.i = fadd double %.373.i.i.i29.i, %.703.i.i.i.i
  br label %B252.i.i.i.i
B252.i.i.i.i:
  %value.3.2.i.i.i.i = phi double [ %.705.i.i.i.i, %B192.i.i.i.i ], [ %.373.i.i.i29.i, %B108.endif.endif.i.i.i.i ]
  %.554.1.i.i.i.i = load i64, ptr %lsr.iv.i52.i.i.i, align 8, !noalias !114
  %.557.1.i.i.i.i = icmp sgt i64 %.554.1.i.i.i.i, -1
  br i1 %.557.1.i.i.i.i, label %B192.1.i.i.i.i, label %B252.1.i.i.i.i
B192.1.i.i.i.i:
  %scevgep6.i57.i.i.i = getelementptr i8, ptr %lsr.iv4.i.i.i.i, i64 -8
  %.612.1.i.i.i.i = load double, ptr %scevgep6.i57.i.i.i, align 8, !noalias !114
  %.701.1.i.i.i.i = getelementptr double, ptr %.3887.i, i64 %.554.1.i.i.i.i
  %.702.1.i.i.i.i = load double, ptr %.701.1.i.i.i.i, align 8, !noalias !114
  %.703.1.i.i.i.i = fmul double %.612.1.i.i.i.i, %.702.1.i.i.i.i
  %.705.1.i.i.i.i = fadd double %value.3.2.i.i.i.i, %.703.1.i.i.i.i
  br label %B252.1.i.i.i.i
B252.1.i.i.i.i:
  %value.3.2.1.i.i.i.i = phi double [ %.705.1.i.i.i.i, %B192.1.i.i.i.i ], [ %value.3.2.i.i.i.i, %B252.i.i.i.i ]
  %.724.i.i.i.i = fcmp ogt double %value.3.2.1.i.i.i.i, 0.000000e+00
  br i1 %.724.i.i.i.i, label %B240.i.i.i, label %B106.i.i.i31.i
B108.endif.endif.i.i.i.i:
  %lsr.iv4.i.i.i.i = phi ptr [ %scevgep5.i55.i.i.i, %B106.i.i.i31.i ], [ %scevgep3.i146.i, %B18.endif.endif.i.i.i ]
  %lsr.iv.i52.i.i.i = phi ptr [ %scevgep1.i54.i.i.i, %B106.i.i.i31.i ], [ %scevgep.i145.i, %B18.endif.endif.i.i.i ]
  %.284326331.i.i.i.i = phi i64 [ %.291.i.i.i.i, %B106.i.i.i31.i ], [ 0, %B18.endif.endif.i.i.i ]
  %.373.i.i.i29.i = load double, ptr %lsr.iv4.i.i.i.i, align 8, !noalias !114
  %scevgep2.i53.i.i.i = getelementptr i8, ptr %lsr.iv.i52.i.i.i, i64 -8
  %.554.i.i.i.i = load i64, ptr %scevgep2.i53.i.i.i, align 8, !noalias !114
  %.557.i.i.i30.i = icmp sgt i64 %.554.i.i.i.i, -1
  br i1 %.557.i.i.i30.i, label %B192.i.i.i.i, label %B252.i.i.i.i
B18.endif.endif.endif.thread13.i.i.i:
  %.37115.i.i.i = icmp slt i64 %event.2.1.i.i.i, 0
  br i1 %.37115.i.i.i, label %B186.i.i.i, label %B240.i.i.i
_ZN6poppet6engine8stepping11stop_insideB3v26B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE.exit.i.i:
  %event.4.2.lcssa.sink.i.i.i = phi i64 [ -1, %B186.i.i.i ], [ %event.4.2.i.i.i, %B240.i.i.i ]
  %theta.1.2.lcssa.sink.i.i.i = phi double [ 1.000000e+00, %B186.i.i.i ], [ %theta.1.2.i.i.i, %B240.i.i.i ]
  %.946.i.i = fmul double %.861.i.i, %theta.1.2.lcssa.sink.i.i.i
  %.950.i.i = fadd double %t.2.0.i7.i, %.946.i.i
  %.935731.i.i = icmp slt i64 %event.4.2.lcssa.sink.i.i.i, 0
  %"$phi724.1.2.2.i.i" = select i1 %.935731.i.i, double %"$phi604.0.2.2.i.i", double %.950.i.i
  store i64 %event.4.2.lcssa.sink.i.i.i, ptr %.4258.i, align 8, !noalias !102
  br label %B736.i.i
_ZN6poppet6engine10integrator15_without_statesB3v34B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i:
  %t.3.1.i5.i = phi double [ %.4486.i, %B2088.i ], [ %end.5.1.i.i, %B736.i.i ]
  call void @llvm.lifetime.end.p0(ptr nonnull %.362.i.i), !noalias !21
  call void @llvm.lifetime.end.p0(ptr nonnull %.1023.i.i), !noalias !21
  %.5909.i = load i64, ptr %.4258.i, align 8, !noalias !21
  %.5910.i = icmp sgt i64 %.5909.i, -1
  br i1 %.5910.i, label %B2246.i, label %B2242.i
B2242.i:
  %h.4.13102.i = phi double [ %.5501.sroa.12.2.i, %_ZN6poppet6engine10integrator8_segmentB3v14B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ], [ %"$phi1908.1.2.1.i", %_ZN6poppet6engine10integrator15_without_statesB3v34B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i ]
  %t.6.13101.i = phi double [ %.5501.sroa.7.2.i, %_ZN6poppet6engine10integrator8_segmentB3v14B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ], [ %t.3.1.i5.i, %_ZN6poppet6engine10integrator15_without_statesB3v34B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i ]
  %exitcond3188.not.i = icmp eq i64 %.4422.i, %.33.i
  br i1 %exitcond3188.not.i, label %B2246.i, label %B1500.i
B2246.i:
  %status.5.1.i = phi i64 [ 0, %B1412.endif.i ], [ 1, %B1700.endif.endif.i ], [ 1, %_ZN6poppet6engine10integrator15_without_statesB3v34B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i ], [ %.5501.sroa.0.2.i, %_ZN6poppet6engine10integrator8_segmentB3v14B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ], [ 0, %B2242.i ]
  %t.4.1.i = phi double [ %.4289.i, %B1412.endif.i ], [ %.4486.i, %B1700.endif.endif.i ], [ %t.3.1.i5.i, %_ZN6poppet6engine10integrator15_without_statesB3v34B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i ], [ %.5501.sroa.7.2.i, %_ZN6poppet6engine10integrator8_segmentB3v14B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ], [ %t.6.13101.i, %B2242.i ]
  %k.2.1.i = phi i64 [ 0, %B1412.endif.i ], [ %.441531563164.i, %B1700.endif.endif.i ], [ %.441531563164.i, %_ZN6poppet6engine10integrator8_segmentB3v14B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ], [ %.441531563164.i, %_ZN6poppet6engine10integrator15_without_statesB3v34B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i ], [ %.441531563164.i, %B2242.i ]
  %switch.i = icmp ult i64 %status.5.1.i, 2
  br i1 %switch.i, label %B2290.i, label %_ZN6poppet6engine10integrator9integrateB2v1B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAg6cJqBrMeIZJFEGM0QQAE8int64_2a8int64_2a10float64_2a10float64_2a10float64_2a10float64_2a8uint8_2a10float64_2a10float64_2a8uint8_2a10float64_2a8int64_2a10float64_2a8uint8_2a10float64_2a10float64_2a10float64_2a8int64_2a10float64_2a10float64_2a.exit
B2290.i:
  %39 = getelementptr double, ptr %a4, i64 %k.2.1.i
  %.6229.i = load double, ptr %39, align 8, !noalias !21
  %.40.i8.i = fsub double %t.4.1.i, %.6229.i
  %.132223.not.i9.i = icmp slt i64 %.1797.i, 1
  br i1 %.132223.not.i9.i, label %B2290.endif.endif.i, label %B56.preheader.i10.i
B56.preheader.i10.i:
  %.6285.i = mul i64 %k.2.1.i, %.1277.i
  %.6287.i = getelementptr double, ptr %a5, i64 %.6285.i
  %scevgep.i11.i = getelementptr i8, ptr %.6287.i, i64 40
  br label %B56.i12.i
B56.i12.i:
  %lsr.iv440.i = phi i64 [ %lsr.iv.next441.i, %B316.i25.i ], [ %.1709.sroa.0.3.i, %B56.preheader.i10.i ]
  %lsr.iv.i13.i = phi ptr [ %scevgep1.i28.i, %B316.i25.i ], [ %scevgep.i11.i, %B56.preheader.i10.i ]
  %scevgep6.i16.i = getelementptr i8, ptr %lsr.iv.i13.i, i64 -40
  %.227.i17.i = load double, ptr %scevgep6.i16.i, align 8, !noalias !117
  %scevgep5.i18.i = getelementptr i8, ptr %lsr.iv.i13.i, i64 -32
  %.282.i19.i = load double, ptr %scevgep5.i18.i, align 8, !noalias !117
  %.284.i20.i = fmul double %.40.i8.i, %.282.i19.i
  %.285.i21.i = fadd double %.227.i17.i, %.284.i20.i
  %scevgep4.i22.i = getelementptr i8, ptr %lsr.iv.i13.i, i64 -24
  %.347.i23.i = load double, ptr %scevgep4.i22.i, align 8, !noalias !117
  %.348.i24.i = fcmp une double %.347.i23.i, 0.000000e+00
  br i1 %.348.i24.i, label %B134.i30.i, label %B316.i25.i
B134.i30.i:
  %scevgep3.i31.i = getelementptr i8, ptr %lsr.iv.i13.i, i64 -16
  %.405.i32.i = load double, ptr %scevgep3.i31.i, align 8, !noalias !117
  %scevgep2.i33.i = getelementptr i8, ptr %lsr.iv.i13.i, i64 -8
  %.460.i34.i = load double, ptr %scevgep2.i33.i, align 8, !noalias !117
  %.461.i35.i = fmul double %.460.i34.i, 5.000000e-01
  %.463.i36.i = fmul double %.40.i8.i, %.461.i35.i
  %.464.i37.i = fadd double %.405.i32.i, %.463.i36.i
  %.465.i38.i = fmul double %.464.i37.i, 0x401921FB54442D18
  %.467.i39.i = fmul double %.40.i8.i, %.465.i38.i
  %.522.i40.i = load double, ptr %lsr.iv.i13.i, align 8, !noalias !117
  %.523.i41.i = fadd double %.522.i40.i, %.467.i39.i
  %.586.le.i42.i = tail call double @llvm.sin.f64(double %.523.i41.i)
  %.591.i43.i = fmul double %.347.i23.i, %.586.le.i42.i
  %.593.i44.i = fadd double %.285.i21.i, %.591.i43.i
  br label %B316.i25.i
B316.i25.i:
  %value.2.1.i26.i = phi double [ %.593.i44.i, %B134.i30.i ], [ %.285.i21.i, %B56.i12.i ]
  %40 = shl i64 %lsr.iv440.i, 3
  %scevgep442.i = getelementptr i8, ptr %.1637.i, i64 %40
  store double %value.2.1.i26.i, ptr %scevgep442.i, align 8, !noalias !117
  %scevgep1.i28.i = getelementptr i8, ptr %lsr.iv.i13.i, i64 48
  %lsr.iv.next441.i = add nuw i64 %lsr.iv440.i, 1
  %exitcond.not.i29.i = icmp eq i64 %.1709.sroa.13.0.i, %lsr.iv.next441.i
  br i1 %exitcond.not.i29.i, label %B2290.endif.endif.i, label %B56.i12.i
B0.endif.endif.endif.endi...else.if.i:
  br label %B0.endif.endif.endif.endi...else.endif.i
B0.endif.endif.endif.endi...else.endif.i:
  %.1073.sroa.0.1.i = phi i64 [ 0, %B0.endif.endif.endif.endi...else.if.i ], [ %.1085.i, %0 ]
  %.1093.not.i = icmp slt i64 %.1085.i, %.936.i
  br i1 %.1093.not.i, label %B0.endif.endif.endif.endi...endif.3.endif.endif.else.i, label %B0.endif.endif.endif.endi...else.endif.if.i, !prof !31
B0.endif.endif.endif.endi...else.endif.if.i:
  br label %B0.endif.endif.endif.endi...endif.3.endif.endif.else.i
B0.endif.endif.endif.endi...endif.3.endif.endif.else.i:
  %.1073.sroa.0.3.i = phi i64 [ %.936.i, %B0.endif.endif.endif.endi...else.endif.if.i ], [ %.1073.sroa.0.1.i, %B0.endif.endif.endif.endi...else.endif.i ]
  %.1161.i = sub i64 %.936.i, %.1073.sroa.0.3.i
  %.1170.i = tail call i64 @llvm.smax.i64(i64 %.1161.i, i64 0)
  %.1186.i = getelementptr double, ptr %a3, i64 %.1073.sroa.0.3.i
  %.1276.i = mul nsw i64 %.25.i, 12
  %.1277.i = mul i64 %.29.i, 6
  %.1278.i = or i64 %.1276.i, 2
  %.1279.i = add i64 %.1278.i, %.1277.i
  %.1280.i = add i64 %.1279.i, %.31.i
  %.1281.i = add nsw i64 %.1280.i, %.75.i
  %.1282.i = add nsw i64 %.1281.i, %.77.i
  %.1283.i = add nsw i64 %.1282.i, %.111.i
  %.1285.i = add nsw i64 %.1283.i, %.113.i
  %.1372.i = icmp slt i64 %.1285.i, 1
  br i1 %.1372.i, label %B0.endif.endif.endif.endi...endif.4.if.i, label %B0.endif.endif.endif.endi...endif.4.endif.i, !prof !24
B0.endif.endif.endif.endi...endif.4.if.i:
  br label %B0.endif.endif.endif.endi...endif.4.endif.i
B0.endif.endif.endif.endi...endif.4.endif.i:
  %.1352.sroa.0.3.i = phi i64 [ %.1285.i, %B0.endif.endif.endif.endi...endif.4.if.i ], [ 0, %B0.endif.endif.endif.endi...endif.3.endif.endif.else.i ]
  %.1379.i = icmp slt i64 %.25.i, 0
  %.1380.i = select i1 %.1379.i, i64 %.1285.i, i64 0
  %.1381.i = add i64 %.1380.i, %.1276.i
  %.1384.i = icmp slt i64 %.1381.i, 0
  br i1 %.1384.i, label %B0.endif.endif.endif.endi...endif.4.endif.if.i, label %B0.endif.endif.endif.endi...endif.4.endif.endif.i, !prof !24
B0.endif.endif.endif.endi...endif.4.endif.if.i:
  br label %B0.endif.endif.endif.endi...endif.4.endif.endif.i
B0.endif.endif.endif.endi...endif.4.endif.endif.i:
  %.1352.sroa.13.1.i = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.4.endif.if.i ], [ %.1381.i, %B0.endif.endif.endif.endi...endif.4.endif.i ]
  %.1389.not.i = icmp slt i64 %.1381.i, %.1285.i
  br i1 %.1389.not.i, label %B0.endif.endif.endif.endi...else.1.i, label %B0.endif.endif.endif.endi...endif.4.endif.endif.if.i, !prof !31
B0.endif.endif.endif.endi...endif.4.endif.endif.if.i:
  br label %B0.endif.endif.endif.endi...else.1.i
B0.endif.endif.endif.endi...else.1.i:
  %.1352.sroa.13.0.i = phi i64 [ %.1352.sroa.13.1.i, %B0.endif.endif.endif.endi...endif.4.endif.endif.i ], [ %.1285.i, %B0.endif.endif.endif.endi...endif.4.endif.endif.if.i ]
  %.1440.i = sub i64 %.1352.sroa.13.0.i, %.1352.sroa.0.3.i
  %.1449.i = tail call i64 @llvm.smax.i64(i64 %.1440.i, i64 0)
  %.1465.i = getelementptr double, ptr %a18, i64 %.1352.sroa.0.3.i
  br i1 %.1384.i, label %B0.endif.endif.endif.endi...else.1.if.i, label %B0.endif.endif.endif.endi...else.1.endif.i, !prof !24
B0.endif.endif.endif.endi...else.1.if.i:
  br label %B0.endif.endif.endif.endi...else.1.endif.i
B0.endif.endif.endif.endi...else.1.endif.i:
  %.1524.sroa.0.1.i = phi i64 [ 0, %B0.endif.endif.endif.endi...else.1.if.i ], [ %.1381.i, %B0.endif.endif.endif.endi...else.1.i ]
  br i1 %.1389.not.i, label %B0.endif.endif.endif.endi...endif.6.else.i, label %B0.endif.endif.endif.endi...else.1.endif.if.i, !prof !31
B0.endif.endif.endif.endi...else.1.endif.if.i:
  br label %B0.endif.endif.endif.endi...endif.6.else.i
B0.endif.endif.endif.endi...endif.6.else.i:
  %.1524.sroa.0.3.i = phi i64 [ %.1285.i, %B0.endif.endif.endif.endi...else.1.endif.if.i ], [ %.1524.sroa.0.1.i, %B0.endif.endif.endif.endi...else.1.endif.i ]
  %.1612.i = sub i64 %.1285.i, %.1524.sroa.0.3.i
  %.1621.i = tail call i64 @llvm.smax.i64(i64 %.1612.i, i64 0)
  %.1637.i = getelementptr double, ptr %a18, i64 %.1524.sroa.0.3.i
  %.1729.i = icmp slt i64 %.1612.i, 1
  br i1 %.1729.i, label %B0.endif.endif.endif.endi...endif.6.else.endif.if.i, label %B0.endif.endif.endif.endi...endif.6.else.endif.endif.i, !prof !24
B0.endif.endif.endif.endi...endif.6.else.endif.if.i:
  br label %B0.endif.endif.endif.endi...endif.6.else.endif.endif.i
B0.endif.endif.endif.endi...endif.6.else.endif.endif.i:
  %.1709.sroa.0.3.i = phi i64 [ %.1621.i, %B0.endif.endif.endif.endi...endif.6.else.endif.if.i ], [ 0, %B0.endif.endif.endif.endi...endif.6.else.i ]
  %.1736.i = icmp slt i64 %.29.i, 0
  %.1737.i = select i1 %.1736.i, i64 %.1621.i, i64 0
  %.1738.i = add i64 %.1737.i, %.29.i
  %.1741.i = icmp slt i64 %.1738.i, 0
  br i1 %.1741.i, label %B0.endif.endif.endif.endi...if.8.i, label %B0.endif.endif.endif.endi...endif.8.i, !prof !24
B0.endif.endif.endif.endi...if.8.i:
  br label %B0.endif.endif.endif.endi...endif.8.i
B0.endif.endif.endif.endi...endif.8.i:
  %.1709.sroa.13.1.i = phi i64 [ 0, %B0.endif.endif.endif.endi...if.8.i ], [ %.1738.i, %B0.endif.endif.endif.endi...endif.6.else.endif.endif.i ]
  %.1746.not.i = icmp slt i64 %.1738.i, %.1621.i
  br i1 %.1746.not.i, label %B0.endif.endif.endif.endi...endif.6.endif.else.i, label %B0.endif.endif.endif.endi...endif.8.if.i, !prof !31
B0.endif.endif.endif.endi...endif.8.if.i:
  br label %B0.endif.endif.endif.endi...endif.6.endif.else.i
B0.endif.endif.endif.endi...endif.6.endif.else.i:
  %.1709.sroa.13.0.i = phi i64 [ %.1709.sroa.13.1.i, %B0.endif.endif.endif.endi...endif.8.i ], [ %.1621.i, %B0.endif.endif.endif.endi...endif.8.if.i ]
  %.1797.i = sub nsw i64 %.1709.sroa.13.0.i, %.1709.sroa.0.3.i
  %.1806.i = tail call i64 @llvm.smax.i64(i64 %.1797.i, i64 0)
  %.1822.i = getelementptr double, ptr %.1637.i, i64 %.1709.sroa.0.3.i
  %.1854.i = mul nsw i64 %.29.i, 5
  br i1 %.1741.i, label %B0.endif.endif.endif.endi...endif.6.endif.else.if.i, label %B0.endif.endif.endif.endi...endif.6.endif.else.endif.i, !prof !24
B0.endif.endif.endif.endi...endif.6.endif.else.if.i:
  br label %B0.endif.endif.endif.endi...endif.6.endif.else.endif.i
B0.endif.endif.endif.endi...endif.6.endif.else.endif.i:
  %.1880.sroa.0.1.i = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.6.endif.else.if.i ], [ %.1738.i, %B0.endif.endif.endif.endi...endif.6.endif.else.i ]
  br i1 %.1746.not.i, label %B0.endif.endif.endif.endi...endif.10.i, label %B0.endif.endif.endif.endi...if.10.i, !prof !31
B0.endif.endif.endif.endi...if.10.i:
  br label %B0.endif.endif.endif.endi...endif.10.i
B0.endif.endif.endif.endi...endif.10.i:
  %.1880.sroa.0.3.i = phi i64 [ %.1621.i, %B0.endif.endif.endif.endi...if.10.i ], [ %.1880.sroa.0.1.i, %B0.endif.endif.endif.endi...endif.6.endif.else.endif.i ]
  %.1909.i = add i64 %.1737.i, %.1854.i
  %.1912.i = icmp slt i64 %.1909.i, 0
  br i1 %.1912.i, label %B0.endif.endif.endif.endi...endif.10.if.i, label %B0.endif.endif.endif.endi...endif.10.endif.i, !prof !24
B0.endif.endif.endif.endi...endif.10.if.i:
  br label %B0.endif.endif.endif.endi...endif.10.endif.i
B0.endif.endif.endif.endi...endif.10.endif.i:
  %.1880.sroa.13.1.i = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.10.if.i ], [ %.1909.i, %B0.endif.endif.endif.endi...endif.10.i ]
  %.1917.not.i = icmp slt i64 %.1909.i, %.1621.i
  br i1 %.1917.not.i, label %B0.endif.endif.endif.endi...endif.6.endif.endif.else.i, label %B0.endif.endif.endif.endi...endif.10.endif.if.i, !prof !31
B0.endif.endif.endif.endi...endif.10.endif.if.i:
  br label %B0.endif.endif.endif.endi...endif.6.endif.endif.else.i
B0.endif.endif.endif.endi...endif.6.endif.endif.else.i:
  %.1880.sroa.13.0.i = phi i64 [ %.1880.sroa.13.1.i, %B0.endif.endif.endif.endi...endif.10.endif.i ], [ %.1621.i, %B0.endif.endif.endif.endi...endif.10.endif.if.i ]
  %.1968.i = sub nsw i64 %.1880.sroa.13.0.i, %.1880.sroa.0.3.i
  %.1977.i = tail call i64 @llvm.smax.i64(i64 %.1968.i, i64 0)
  %.1993.i = getelementptr double, ptr %.1637.i, i64 %.1880.sroa.0.3.i
  br i1 %.1912.i, label %B0.endif.endif.endif.endi...if.12.i, label %B0.endif.endif.endif.endi...endif.12.i, !prof !24
B0.endif.endif.endif.endi...if.12.i:
  br label %B0.endif.endif.endif.endi...endif.12.i
B0.endif.endif.endif.endi...endif.12.i:
  %.2052.sroa.0.1.i = phi i64 [ 0, %B0.endif.endif.endif.endi...if.12.i ], [ %.1909.i, %B0.endif.endif.endif.endi...endif.6.endif.endif.else.i ]
  br i1 %.1917.not.i, label %B0.endif.endif.endif.endi...endif.12.endif.i, label %B0.endif.endif.endif.endi...endif.12.if.i, !prof !31
B0.endif.endif.endif.endi...endif.12.if.i:
  br label %B0.endif.endif.endif.endi...endif.12.endif.i
B0.endif.endif.endif.endi...endif.12.endif.i:
  %.2052.sroa.0.3.i = phi i64 [ %.1621.i, %B0.endif.endif.endif.endi...endif.12.if.i ], [ %.2052.sroa.0.1.i, %B0.endif.endif.endif.endi...endif.12.i ]
  %.2081.i = add i64 %.1737.i, %.1277.i
  %.2084.i = icmp slt i64 %.2081.i, 0
  br i1 %.2084.i, label %B0.endif.endif.endif.endi...endif.12.endif.if.i, label %B0.endif.endif.endif.endi...endif.12.endif.endif.i, !prof !24
B0.endif.endif.endif.endi...endif.12.endif.if.i:
  br label %B0.endif.endif.endif.endi...endif.12.endif.endif.i
B0.endif.endif.endif.endi...endif.12.endif.endif.i:
  %.2052.sroa.13.1.i = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.12.endif.if.i ], [ %.2081.i, %B0.endif.endif.endif.endi...endif.12.endif.i ]
  %.2089.not.i = icmp slt i64 %.2081.i, %.1621.i
  br i1 %.2089.not.i, label %B0.endif.endif.endif.endi...else.2.i, label %B0.endif.endif.endif.endi...endif.12.endif.endif.if.i, !prof !31
B0.endif.endif.endif.endi...endif.12.endif.endif.if.i:
  br label %B0.endif.endif.endif.endi...else.2.i
B0.endif.endif.endif.endi...else.2.i:
  %.2052.sroa.13.0.i = phi i64 [ %.2052.sroa.13.1.i, %B0.endif.endif.endif.endi...endif.12.endif.endif.i ], [ %.1621.i, %B0.endif.endif.endif.endi...endif.12.endif.endif.if.i ]
  %.2140.i = sub nsw i64 %.2052.sroa.13.0.i, %.2052.sroa.0.3.i
  %.2165.i = getelementptr double, ptr %.1637.i, i64 %.2052.sroa.0.3.i
  br i1 %.2084.i, label %B0.endif.endif.endif.endi...else.2.if.i, label %B0.endif.endif.endif.endi...else.2.endif.i, !prof !24
B0.endif.endif.endif.endi...else.2.if.i:
  br label %B0.endif.endif.endif.endi...else.2.endif.i
B0.endif.endif.endif.endi...else.2.endif.i:
  %.2223.sroa.0.1.i = phi i64 [ 0, %B0.endif.endif.endif.endi...else.2.if.i ], [ %.2081.i, %B0.endif.endif.endif.endi...else.2.i ]
  br i1 %.2089.not.i, label %B0.endif.endif.endif.endi...endif.14.else.endif.i, label %B0.endif.endif.endif.endi...else.2.endif.if.i, !prof !31
B0.endif.endif.endif.endi...else.2.endif.if.i:
  br label %B0.endif.endif.endif.endi...endif.14.else.endif.i
B0.endif.endif.endif.endi...endif.14.else.endif.i:
  %.2223.sroa.0.3.i = phi i64 [ %.1621.i, %B0.endif.endif.endif.endi...else.2.endif.if.i ], [ %.2223.sroa.0.1.i, %B0.endif.endif.endif.endi...else.2.endif.i ]
  %.2311.i = sub nsw i64 %.1621.i, %.2223.sroa.0.3.i
  %.2320.i = tail call i64 @llvm.smax.i64(i64 %.2311.i, i64 0)
  %.2336.i = getelementptr double, ptr %.1637.i, i64 %.2223.sroa.0.3.i
  %.26793190.i = add nsw i64 %.75.i, 2
  %41 = tail call i64 @llvm.umin.i64(i64 %.2320.i, i64 2)
  %.2732.i = icmp slt i64 %.75.i, -2
  %.2733.i = select i1 %.2732.i, i64 %.2320.i, i64 0
  %.2734.i = add i64 %.26793190.i, %.2733.i
  %.2737.i = icmp slt i64 %.2734.i, 0
  %.2742.not.i = icmp slt i64 %.2734.i, %.2320.i
  %.2818.i = getelementptr double, ptr %.2336.i, i64 %41
  br i1 %.2737.i, label %B0.endif.endif.endif.endi...if.21.i, label %B0.endif.endif.endif.endi...endif.21.i, !prof !24
B0.endif.endif.endif.endi...if.21.i:
  br label %B0.endif.endif.endif.endi...endif.21.i
B0.endif.endif.endif.endi...endif.21.i:
  %.2876.sroa.0.1.i = phi i64 [ 0, %B0.endif.endif.endif.endi...if.21.i ], [ %.2734.i, %B0.endif.endif.endif.endi...endif.14.else.endif.i ]
  br i1 %.2742.not.i, label %B0.endif.endif.endif.endi...else.3.i, label %B0.endif.endif.endif.endi...endif.21.if.i, !prof !31
B0.endif.endif.endif.endi...endif.21.if.i:
  br label %B0.endif.endif.endif.endi...else.3.i
B0.endif.endif.endif.endi...else.3.i:
  %.2876.sroa.0.3.i = phi i64 [ %.2320.i, %B0.endif.endif.endif.endi...endif.21.if.i ], [ %.2876.sroa.0.1.i, %B0.endif.endif.endif.endi...endif.21.i ]
  %.2964.i = sub nsw i64 %.2320.i, %.2876.sroa.0.3.i
  %.2973.i = tail call i64 @llvm.smax.i64(i64 %.2964.i, i64 0)
  %.2989.i = getelementptr double, ptr %.2336.i, i64 %.2876.sroa.0.3.i
  %.3093.i = icmp slt i64 %.2964.i, 1
  br i1 %.3093.i, label %B0.endif.endif.endif.endi...else.3.endif.if.i, label %B0.endif.endif.endif.endi...else.3.endif.endif.i, !prof !24
B0.endif.endif.endif.endi...else.3.endif.if.i:
  br label %B0.endif.endif.endif.endi...else.3.endif.endif.i
B0.endif.endif.endif.endi...else.3.endif.endif.i:
  %.3073.sroa.0.3.i = phi i64 [ %.2973.i, %B0.endif.endif.endif.endi...else.3.endif.if.i ], [ 0, %B0.endif.endif.endif.endi...else.3.i ]
  %.3100.i = icmp slt i64 %.77.i, 0
  %.3101.i = select i1 %.3100.i, i64 %.2973.i, i64 0
  %.3102.i = add i64 %.3101.i, %.77.i
  %.3105.i = icmp slt i64 %.3102.i, 0
  %.3110.not.i = icmp slt i64 %.3102.i, %.2973.i
  %.3186.i = getelementptr double, ptr %.2989.i, i64 %.3073.sroa.0.3.i
  br i1 %.3105.i, label %B0.endif.endif.endif.endi...endif.23.else.if.i, label %B0.endif.endif.endif.endi...endif.23.else.endif.i, !prof !24
B0.endif.endif.endif.endi...endif.23.else.if.i:
  br label %B0.endif.endif.endif.endi...endif.23.else.endif.i
B0.endif.endif.endif.endi...endif.23.else.endif.i:
  %.3243.sroa.0.1.i = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.23.else.if.i ], [ %.3102.i, %B0.endif.endif.endif.endi...else.3.endif.endif.i ]
  br i1 %.3110.not.i, label %B0.endif.endif.endif.endi...endif.23.endif.else.i, label %B0.endif.endif.endif.endi...endif.23.else.endif.if.i, !prof !31
B0.endif.endif.endif.endi...endif.23.else.endif.if.i:
  br label %B0.endif.endif.endif.endi...endif.23.endif.else.i
B0.endif.endif.endif.endi...endif.23.endif.else.i:
  %.3243.sroa.0.3.i = phi i64 [ %.2973.i, %B0.endif.endif.endif.endi...endif.23.else.endif.if.i ], [ %.3243.sroa.0.1.i, %B0.endif.endif.endif.endi...endif.23.else.endif.i ]
  %.3331.i = sub nsw i64 %.2973.i, %.3243.sroa.0.3.i
  %.3340.i = tail call i64 @llvm.smax.i64(i64 %.3331.i, i64 0)
  %.3356.i = getelementptr double, ptr %.2989.i, i64 %.3243.sroa.0.3.i
  %.3449.i = icmp slt i64 %.3331.i, 1
  br i1 %.3449.i, label %B0.endif.endif.endif.endi...if.28.i, label %B0.endif.endif.endif.endi...endif.28.i, !prof !24
B0.endif.endif.endif.endi...if.28.i:
  br label %B0.endif.endif.endif.endi...endif.28.i
B0.endif.endif.endif.endi...endif.28.i:
  %.3429.sroa.0.3.i = phi i64 [ %.3340.i, %B0.endif.endif.endif.endi...if.28.i ], [ 0, %B0.endif.endif.endif.endi...endif.23.endif.else.i ]
  %.3456.i = icmp slt i64 %.113.i, 0
  %.3457.i = select i1 %.3456.i, i64 %.3340.i, i64 0
  %.3458.i = add i64 %.3457.i, %.113.i
  %.3461.i = icmp slt i64 %.3458.i, 0
  br i1 %.3461.i, label %B0.endif.endif.endif.endi...endif.28.if.i, label %B0.endif.endif.endif.endi...endif.28.endif.i, !prof !24
B0.endif.endif.endif.endi...endif.28.if.i:
  br label %B0.endif.endif.endif.endi...endif.28.endif.i
B0.endif.endif.endif.endi...endif.28.endif.i:
  %.3429.sroa.13.1.i = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.28.if.i ], [ %.3458.i, %B0.endif.endif.endif.endi...endif.28.i ]
  %.3466.not.i = icmp slt i64 %.3458.i, %.3340.i
  br i1 %.3466.not.i, label %B0.endif.endif.endif.endi...endif.23.endif.endif.else.i, label %B0.endif.endif.endif.endi...endif.28.endif.if.i, !prof !31
B0.endif.endif.endif.endi...endif.28.endif.if.i:
  br label %B0.endif.endif.endif.endi...endif.23.endif.endif.else.i
B0.endif.endif.endif.endi...endif.23.endif.endif.else.i:
  %.3429.sroa.13.0.i = phi i64 [ %.3429.sroa.13.1.i, %B0.endif.endif.endif.endi...endif.28.endif.i ], [ %.3340.i, %B0.endif.endif.endif.endi...endif.28.endif.if.i ]
  %.3517.i = sub nsw i64 %.3429.sroa.13.0.i, %.3429.sroa.0.3.i
  %.3526.i = tail call i64 @llvm.smax.i64(i64 %.3517.i, i64 0)
  %.3542.i = getelementptr double, ptr %.3356.i, i64 %.3429.sroa.0.3.i
  %.3575.i = add nsw i64 %.113.i, %.111.i
  br i1 %.3461.i, label %B0.endif.endif.endif.endi...if.30.i, label %B0.endif.endif.endif.endi...endif.30.i, !prof !24
B0.endif.endif.endif.endi...if.30.i:
  br label %B0.endif.endif.endif.endi...endif.30.i
B0.endif.endif.endif.endi...endif.30.i:
  %.3602.sroa.0.1.i = phi i64 [ 0, %B0.endif.endif.endif.endi...if.30.i ], [ %.3458.i, %B0.endif.endif.endif.endi...endif.23.endif.endif.else.i ]
  br i1 %.3466.not.i, label %B0.endif.endif.endif.endi...endif.30.endif.i, label %B0.endif.endif.endif.endi...endif.30.if.i, !prof !31
B0.endif.endif.endif.endi...endif.30.if.i:
  br label %B0.endif.endif.endif.endi...endif.30.endif.i
B0.endif.endif.endif.endi...endif.30.endif.i:
  %.3602.sroa.0.3.i = phi i64 [ %.3340.i, %B0.endif.endif.endif.endi...endif.30.if.i ], [ %.3602.sroa.0.1.i, %B0.endif.endif.endif.endi...endif.30.i ]
  %.3629.i = icmp slt i64 %.3575.i, 0
  %.3630.i = select i1 %.3629.i, i64 %.3340.i, i64 0
  %.3631.i = add i64 %.3630.i, %.3575.i
  %.3634.i = icmp slt i64 %.3631.i, 0
  %.3639.not.i = icmp slt i64 %.3631.i, %.3340.i
  %.3715.i = getelementptr double, ptr %.3356.i, i64 %.3602.sroa.0.3.i
  br i1 %.3634.i, label %B0.endif.endif.endif.endi...else.4.if.i, label %B0.endif.endif.endif.endi...else.4.endif.i, !prof !24
B0.endif.endif.endif.endi...else.4.if.i:
  br label %B0.endif.endif.endif.endi...else.4.endif.i
B0.endif.endif.endif.endi...else.4.endif.i:
  %.3774.sroa.0.1.i = phi i64 [ 0, %B0.endif.endif.endif.endi...else.4.if.i ], [ %.3631.i, %B0.endif.endif.endif.endi...endif.30.endif.i ]
  br i1 %.3639.not.i, label %B0.endif.endif.endif.endi...endif.32.endif.i, label %B0.endif.endif.endif.endi...else.4.endif.if.i, !prof !31
B0.endif.endif.endif.endi...else.4.endif.if.i:
  br label %B0.endif.endif.endif.endi...endif.32.endif.i
B0.endif.endif.endif.endi...endif.32.endif.i:
  %.3774.sroa.0.3.i = phi i64 [ %.3340.i, %B0.endif.endif.endif.endi...else.4.endif.if.i ], [ %.3774.sroa.0.1.i, %B0.endif.endif.endif.endi...else.4.endif.i ]
  %.3862.i = sub nsw i64 %.3340.i, %.3774.sroa.0.3.i
  %.3871.i = tail call i64 @llvm.smax.i64(i64 %.3862.i, i64 0)
  %.3887.i = getelementptr double, ptr %.3356.i, i64 %.3774.sroa.0.3.i
  %.40323145.not.i = icmp slt i64 %.25.i, 1
  br i1 %.40323145.not.i, label %B1412.endif.i, label %B1334.lr.ph.i
B1334.lr.ph.i:
  %invariant.gep.i = getelementptr double, ptr %a15, i64 %.25.i
  %.idx.i = shl i64 %.25.i, 4
  %invariant.gep3212.i = getelementptr i8, ptr %a15, i64 %.idx.i
  %42 = icmp eq i64 %.25.i, 1
  br i1 %42, label %B1334.epil.preheader.i, label %B1334.lr.ph.new.i
B1334.lr.ph.new.i:
  %unroll_iter.i = and i64 %.25.i, 9223372036854775806
  %scevgep446.i = getelementptr i8, ptr %a2, i64 8
  %scevgep450.i = getelementptr i8, ptr %a15, i64 8
  %sunkaddr.i = shl i64 %.25.i, 3
  br label %B1334.i
B1412.endif.loopexit.unr-lcssa.i:
  %43 = and i64 %.25.i, 1
  %lcmp.mod.not.i = icmp eq i64 %43, 0
  br i1 %lcmp.mod.not.i, label %B1412.endif.i, label %B1334.epil.preheader.i
B1334.epil.preheader.i:
  %.403831443146.epil.init.i = phi i64 [ 0, %B1334.lr.ph.i ], [ %unroll_iter.i, %B1412.endif.loopexit.unr-lcssa.i ]
  %44 = getelementptr double, ptr %a2, i64 %.403831443146.epil.init.i
  %.4099.epil.i = load double, ptr %44, align 8, !noalias !21
  %45 = getelementptr double, ptr %a15, i64 %.403831443146.epil.init.i
  store double %.4099.epil.i, ptr %45, align 8, !noalias !21
  %gep.epil.i = getelementptr double, ptr %invariant.gep.i, i64 %.403831443146.epil.init.i
  store double %.4099.epil.i, ptr %gep.epil.i, align 8, !noalias !21
  %gep3213.epil.i = getelementptr double, ptr %invariant.gep3212.i, i64 %.403831443146.epil.init.i
  store double 0.000000e+00, ptr %gep3213.epil.i, align 8, !noalias !21
  br label %B1412.endif.i
B1412.endif.i:
  %.4258.i = getelementptr i8, ptr %a17, i64 24
  store i64 -1, ptr %.4258.i, align 8, !noalias !21
  %.4289.i = load double, ptr %a4, align 8, !noalias !21
  %.44093163.not.i = icmp slt i64 %.33.i, 1
  br i1 %.44093163.not.i, label %B2246.i, label %B1500.lr.ph.i
B1500.lr.ph.i:
  %.4547.i = tail call i64 @llvm.smin.i64(i64 %.71.i, i64 0)
  %46 = getelementptr double, ptr %a7, i64 %.71.i
  %47 = getelementptr i8, ptr %46, i64 -8
  %.4561.i = getelementptr double, ptr %47, i64 %.4547.i
  %scevgep.i145.i = getelementptr i8, ptr %a11, i64 8
  %scevgep3.i146.i = getelementptr i8, ptr %a12, i64 16
  %48 = icmp sgt i64 %.113.i, 0
  %sunkaddr465.i = getelementptr i8, ptr %a0, i64 32
  %49 = icmp sgt i64 %.73.i, 0
  %50 = icmp slt i64 %.1797.i, 1
  %sunkaddr468.i = getelementptr i8, ptr %a0, i64 24
  %51 = icmp sgt i64 %.25.i, 0
  %.570.i.i = add i64 %.71.i, -1
  %xtraiter.i.i.i = and i64 %.3526.i, 3
  %unroll_iter.i.i.i = and i64 %.3526.i, 9223372036854775804
  %52 = add i64 %.71.i, -2
  %scevgep36.i.i = getelementptr i8, ptr %a7, i64 8
  %.not.i.i = icmp slt i64 %.3517.i, 1
  %53 = icmp slt i64 %.3517.i, 4
  %54 = icmp eq i64 %xtraiter.i.i.i, 0
  %sunkaddr.i6.i = getelementptr i8, ptr %a17, i64 16
  %.609.i.i = shl nuw nsw i64 %.25.i, 1
  %55 = icmp sgt i64 %.1440.i, %.25.i
  %.672.not.i.i = icmp sgt i64 %.1440.i, %.609.i.i
  %.781.i.i = mul nuw nsw i64 %.25.i, 3
  %.844.not.i.i = icmp sgt i64 %.1440.i, %.781.i.i
  %.953.i.i = shl nsw i64 %.25.i, 2
  %.1016.not.i.i = icmp sgt i64 %.1440.i, %.953.i.i
  %.1269.i.i = mul nuw nsw i64 %.25.i, 6
  %.1332.not.i.i = icmp sgt i64 %.1440.i, %.1269.i.i
  %.1611.i.i = mul nuw nsw i64 %.25.i, 11
  %.1657.not.i.i = icmp sgt i64 %.1440.i, %.1611.i.i
  %.arg.coefficients.5.0.i.i.i = tail call i64 @llvm.smax.i64(i64 %.29.i, i64 0)
  %56 = add nuw i64 %.arg.coefficients.5.0.i.i.i, 1
  %.1908.i.i = getelementptr i8, ptr %a10, i64 16
  %.1974.i.i = icmp sgt i64 %.3517.i, 0
  %.1945.i.i = icmp sgt i64 %.977.i, 0
  %.idx.i.i.i.i = shl i64 %.27.i, 4
  %57 = getelementptr i8, ptr %a8, i64 %.idx.i.i.i.i
  %.26.i.i.i = add nsw i64 %.977.i, -1
  %58 = shl i64 %.27.i, 3
  %scevgep230.i.i = getelementptr i8, ptr %a8, i64 %58
  %59 = icmp slt i64 %.2140.i, 1
  %60 = icmp slt i64 %.27.i, 1
  %sunkaddr.i2.i = getelementptr i8, ptr %.2336.i, i64 8
  %sunkaddr234.i.i = getelementptr i8, ptr %a0, i64 8
  %sunkaddr246.i.i = getelementptr i8, ptr %a17, i64 8
  %.584.i.i.i = getelementptr i8, ptr %a0, i64 16
  %.idx.i.i56.i.i = shl i64 %.25.i, 4
  %invariant.gep.i.i.i.i = getelementptr i8, ptr %a15, i64 %.idx.i.i56.i.i
  %invariant.gep242.i.i.i.i = getelementptr double, ptr %a15, i64 %.25.i
  %sunkaddr237.i.i = getelementptr i8, ptr %a16, i64 8
  %sunkaddr240.i.i = getelementptr i8, ptr %a7, i64 %.16.i.i
  %sunkaddr241.i.i = getelementptr i8, ptr %sunkaddr240.i.i, i64 -8
  %sunkaddr242.i.i = getelementptr i8, ptr %a17, i64 32
  %sunkaddr244.i.i = getelementptr i8, ptr %a10, i64 8
  br label %B1500.i
B1700.endif.i:
  %.4924.i = load i64, ptr %sunkaddr468.i, align 8, !noalias !21
  store double %.4486.i, ptr %.2336.i, align 8, !noalias !120
  %.168.i.i = inttoptr i64 %.4924.i to ptr
  tail call void %.168.i.i(ptr nonnull %.2336.i, ptr %a2, ptr %.1822.i, ptr %a3, ptr %.3887.i), !noalias !120
  br label %B108.endif.endif.i.i
B106.i.i:
  %.291.i.i = add nuw i64 %.284326331.i.i, 1
  %scevgep1.i149.i = getelementptr i8, ptr %lsr.iv.i147.i, i64 16
  %scevgep5.i150.i = getelementptr i8, ptr %lsr.iv4.i.i, i64 24
  %exitcond.not.i151.i = icmp eq i64 %.73.i, %.291.i.i
  br i1 %exitcond.not.i151.i, label %B1700.endif.endif.thread.i, label %B108.endif.endif.i.i
B192.i.i:
  %sunkaddr.i.i = getelementptr i8, ptr %lsr.iv4.i.i, i64 -16
  %.612.i.i = load double, ptr %sunkaddr.i.i, align 8, !noalias !120
  %.701.i.i = getelementptr double, ptr %.3887.i, i64 %.554.i.i
  %.702.i.i = load double, ptr %.701.i.i, align 8, !noalias !120
  %.703.i.i = fmul double %.612.i.i, %.702.i.i
  %.705.i.i = fadd double %.373.i.i, %.703.i.i
  br label %B252.i.i
B252.i.i:
  %value.3.2.i.i = phi double [ %.705.i.i, %B192.i.i ], [ %.373.i.i, %B108.endif.endif.i.i ]
  %.554.1.i.i = load i64, ptr %lsr.iv.i147.i, align 8, !noalias !120
  %.557.1.i.i = icmp sgt i64 %.554.1.i.i, -1
  br i1 %.557.1.i.i, label %B192.1.i.i, label %B252.1.i.i
B192.1.i.i:
  %scevgep6.i152.i = getelementptr i8, ptr %lsr.iv4.i.i, i64 -8
  %.612.1.i.i = load double, ptr %scevgep6.i152.i, align 8, !noalias !120
  %.701.1.i.i = getelementptr double, ptr %.3887.i, i64 %.554.1.i.i
  %.702.1.i.i = load double, ptr %.701.1.i.i, align 8, !noalias !120
  %.703.1.i.i = fmul double %.612.1.i.i, %.702.1.i.i
  %.705.1.i.i = fadd double %value.3.2.i.i, %.703.1.i.i
  br label %B252.1.i.i
B252.1.i.i:
  %value.3.2.1.i.i = phi double [ %.705.1.i.i, %B192.1.i.i ], [ %value.3.2.i.i, %B252.i.i ]
  %.724.i.i = fcmp ogt double %value.3.2.1.i.i, 0.000000e+00
  br i1 %.724.i.i, label %B1700.endif.endif.i, label %B106.i.i
B108.endif.endif.i.i:
  %lsr.iv4.i.i = phi ptr [ %scevgep3.i146.i, %B1700.endif.i ], [ %scevgep5.i150.i, %B106.i.i ]
  %lsr.iv.i147.i = phi ptr [ %scevgep.i145.i, %B1700.endif.i ], [ %scevgep1.i149.i, %B106.i.i ]
  %.284326331.i.i = phi i64 [ 0, %B1700.endif.i ], [ %.291.i.i, %B106.i.i ]
  %.373.i.i = load double, ptr %lsr.iv4.i.i, align 8, !noalias !120
  %scevgep2.i148.i = getelementptr i8, ptr %lsr.iv.i147.i, i64 -8
  %.554.i.i = load i64, ptr %scevgep2.i148.i, align 8, !noalias !120
  %.557.i.i = icmp sgt i64 %.554.i.i, -1
  br i1 %.557.i.i, label %B192.i.i, label %B252.i.i
B1700.endif.endif.thread.i:
  store i64 -1, ptr %.4258.i, align 8, !noalias !21
  br label %B1884.i
B1700.endif.endif.i:
  store i64 %.284326331.i.i, ptr %.4258.i, align 8, !noalias !21
  br label %B2246.i
B2290.endif.endif.i:
  %.6401.i = getelementptr i8, ptr %a17, i64 16
  %.6402.i = load i64, ptr %.6401.i, align 8, !noalias !21
  %.6404.i = add nsw i64 %.71.i, -1
  %.13.i.i = tail call i64 @llvm.smin.i64(i64 %.6404.i, i64 %.6402.i)
  store i64 %.13.i.i, ptr %.6401.i, align 8, !noalias !21
  %.6493.i = getelementptr i8, ptr %a0, i64 24
  %.6494.i = load i64, ptr %.6493.i, align 8, !noalias !21
  store double %t.4.1.i, ptr %.2336.i, align 8, !noalias !123
  %.151.i.i = inttoptr i64 %.6494.i to ptr
  tail call void %.151.i.i(ptr nonnull %.2336.i, ptr %a2, ptr %.1822.i, ptr %a3, ptr %.3887.i), !noalias !123
  %.253155.not.i.i = icmp slt i64 %.3862.i, 1
  br i1 %.253155.not.i.i, label %B2290.endif.endif.endif.i, label %B96.lr.ph.i.i
B96.lr.ph.i.i:
  %.349.i.i = icmp slt i64 %.13.i.i, 0
  %.350.i.i = select i1 %.349.i.i, i64 %.71.i, i64 0
  %xtraiter.i.i = and i64 %.3871.i, 3
  %61 = icmp ult i64 %.3862.i, 4
  br i1 %61, label %B96.epil.preheader.i.i, label %B96.lr.ph.new.i.i
B96.lr.ph.new.i.i:
  %invariant.gep.i.i = getelementptr double, ptr %a14, i64 %.13.i.i
  %invariant.gep159.i.i = getelementptr double, ptr %invariant.gep.i.i, i64 %.350.i.i
  %unroll_iter.i.i = and i64 %.3871.i, 9223372036854775804
  %62 = mul i64 %.71.i, 24
  %63 = shl i64 %.71.i, 5
  %64 = shl i64 %.71.i, 4
  %65 = add nsw i64 %.3871.i, -4
  %66 = lshr i64 %65, 2
  %67 = icmp eq i64 %66, 0
  br i1 %67, label %B96.i.epil.preheader.i, label %B96.lr.ph.new.i.new.i
B96.lr.ph.new.i.new.i:
  %68 = add nuw nsw i64 %66, 1
  %unroll_iter402.i = and i64 %68, 9223372036854775806
  %69 = add i64 %.2223.sroa.0.3.i, %.1524.sroa.0.3.i
  %70 = add i64 %69, %.2876.sroa.0.3.i
  %71 = add i64 %70, %.3243.sroa.0.3.i
  %72 = add i64 %71, %.3774.sroa.0.3.i
  %73 = shl i64 %72, 3
  %74 = getelementptr i8, ptr %a18, i64 %73
  %scevgep417.i = getelementptr i8, ptr %74, i64 56
  br label %B96.i.i
B96.i.i:
  %lsr.iv.i = phi i64 [ %lsr.iv.next.i, %B96.i.i ], [ %unroll_iter402.i, %B96.lr.ph.new.i.new.i ]
  %lsr.iv13.i.i = phi ptr [ %scevgep439.i, %B96.i.i ], [ %invariant.gep159.i.i, %B96.lr.ph.new.i.new.i ]
  %.259154156.i.i = phi i64 [ %.266.3.i.1.i, %B96.i.i ], [ 0, %B96.lr.ph.new.i.new.i ]
  %sunkaddr.i153.i = shl i64 %.259154156.i.i, 3
  %scevgep431.i = getelementptr i8, ptr %scevgep417.i, i64 %sunkaddr.i153.i
  %scevgep432.i = getelementptr i8, ptr %scevgep431.i, i64 -56
  %.320.i.i = load double, ptr %scevgep432.i, align 8, !noalias !123
  store double %.320.i.i, ptr %lsr.iv13.i.i, align 8, !noalias !123
  %scevgep430.i = getelementptr i8, ptr %scevgep431.i, i64 -48
  %.320.1.i.i = load double, ptr %scevgep430.i, align 8, !noalias !123
  %sunkaddr23.i.i = getelementptr i8, ptr %lsr.iv13.i.i, i64 %.16.i.i
  store double %.320.1.i.i, ptr %sunkaddr23.i.i, align 8, !noalias !123
  %scevgep428.i = getelementptr i8, ptr %scevgep431.i, i64 -40
  %.320.2.i.i = load double, ptr %scevgep428.i, align 8, !noalias !123
  %scevgep433.i = getelementptr i8, ptr %sunkaddr23.i.i, i64 %.16.i.i
  store double %.320.2.i.i, ptr %scevgep433.i, align 8, !noalias !123
  %scevgep426.i = getelementptr i8, ptr %scevgep431.i, i64 -32
  %.320.3.i.i = load double, ptr %scevgep426.i, align 8, !noalias !123
  %scevgep434.i = getelementptr i8, ptr %scevgep433.i, i64 %.16.i.i
  store double %.320.3.i.i, ptr %scevgep434.i, align 8, !noalias !123
  %scevgep424.i = getelementptr i8, ptr %scevgep431.i, i64 -24
  %.320.i.1.i = load double, ptr %scevgep424.i, align 8, !noalias !123
  %scevgep435.i = getelementptr i8, ptr %scevgep434.i, i64 %.16.i.i
  store double %.320.i.1.i, ptr %scevgep435.i, align 8, !noalias !123
  %scevgep422.i = getelementptr i8, ptr %scevgep431.i, i64 -16
  %.320.1.i.1.i = load double, ptr %scevgep422.i, align 8, !noalias !123
  %scevgep436.i = getelementptr i8, ptr %scevgep435.i, i64 %.16.i.i
  store double %.320.1.i.1.i, ptr %scevgep436.i, align 8, !noalias !123
  %scevgep420.i = getelementptr i8, ptr %scevgep431.i, i64 -8
  %.320.2.i.1.i = load double, ptr %scevgep420.i, align 8, !noalias !123
  %scevgep437.i = getelementptr i8, ptr %scevgep436.i, i64 %.16.i.i
  store double %.320.2.i.1.i, ptr %scevgep437.i, align 8, !noalias !123
  %.266.3.i.1.i = add nuw i64 %.259154156.i.i, 8
  %.320.3.i.1.i = load double, ptr %scevgep431.i, align 8, !noalias !123
  %scevgep438.i = getelementptr i8, ptr %scevgep437.i, i64 %.16.i.i
  store double %.320.3.i.1.i, ptr %scevgep438.i, align 8, !noalias !123
  %lsr.iv.next.i = add i64 %lsr.iv.i, -2
  %niter403.ncmp.1.i = icmp eq i64 %lsr.iv.next.i, 0
  %scevgep439.i = getelementptr i8, ptr %scevgep438.i, i64 %.16.i.i
  br i1 %niter403.ncmp.1.i, label %B126.loopexit.unr-lcssa.i.unr-lcssa.i, label %B96.i.i
B126.loopexit.unr-lcssa.i.unr-lcssa.i:
  %scevgep14.i.i = getelementptr i8, ptr %lsr.iv13.i.i, i64 %63
  %scevgep14.i.1.i = getelementptr i8, ptr %scevgep14.i.i, i64 %63
  %75 = and i64 %65, 4
  %lcmp.mod400.not.not.i = icmp eq i64 %75, 0
  br i1 %lcmp.mod400.not.not.i, label %B96.i.epil.preheader.i, label %B126.loopexit.unr-lcssa.i.i
B96.i.epil.preheader.i:
  %lsr.iv13.i.epil.init.i = phi ptr [ %invariant.gep159.i.i, %B96.lr.ph.new.i.i ], [ %scevgep14.i.1.i, %B126.loopexit.unr-lcssa.i.unr-lcssa.i ]
  %.259154156.i.epil.init.i = phi i64 [ 0, %B96.lr.ph.new.i.i ], [ %.266.3.i.1.i, %B126.loopexit.unr-lcssa.i.unr-lcssa.i ]
  %sunkaddr.i153.epil.i = shl i64 %.259154156.i.epil.init.i, 3
  %sunkaddr18.i.epil.i = getelementptr i8, ptr %.3887.i, i64 %sunkaddr.i153.epil.i
  %.320.i.epil.i = load double, ptr %sunkaddr18.i.epil.i, align 8, !noalias !123
  store double %.320.i.epil.i, ptr %lsr.iv13.i.epil.init.i, align 8, !noalias !123
  %sunkaddr21.i.epil.i = getelementptr i8, ptr %sunkaddr18.i.epil.i, i64 8
  %.320.1.i.epil.i = load double, ptr %sunkaddr21.i.epil.i, align 8, !noalias !123
  %sunkaddr23.i.epil.i = getelementptr i8, ptr %lsr.iv13.i.epil.init.i, i64 %.16.i.i
  store double %.320.1.i.epil.i, ptr %sunkaddr23.i.epil.i, align 8, !noalias !123
  %sunkaddr26.i.epil.i = getelementptr i8, ptr %sunkaddr18.i.epil.i, i64 16
  %.320.2.i.epil.i = load double, ptr %sunkaddr26.i.epil.i, align 8, !noalias !123
  %scevgep16.i.epil.i = getelementptr i8, ptr %lsr.iv13.i.epil.init.i, i64 %64
  store double %.320.2.i.epil.i, ptr %scevgep16.i.epil.i, align 8, !noalias !123
  %sunkaddr29.i.epil.i = getelementptr i8, ptr %sunkaddr18.i.epil.i, i64 24
  %.320.3.i.epil.i = load double, ptr %sunkaddr29.i.epil.i, align 8, !noalias !123
  %scevgep15.i.epil.i = getelementptr i8, ptr %lsr.iv13.i.epil.init.i, i64 %62
  store double %.320.3.i.epil.i, ptr %scevgep15.i.epil.i, align 8, !noalias !123
  br label %B126.loopexit.unr-lcssa.i.i
B126.loopexit.unr-lcssa.i.i:
  %lcmp.mod.not.i.i = icmp eq i64 %xtraiter.i.i, 0
  br i1 %lcmp.mod.not.i.i, label %B2290.endif.endif.endif.i, label %B96.epil.preheader.i.i
B96.epil.preheader.i.i:
  %.259154156.epil.init.i.i = phi i64 [ %unroll_iter.i.i, %B126.loopexit.unr-lcssa.i.i ], [ 0, %B96.lr.ph.i.i ]
  %76 = mul i64 %.259154156.epil.init.i.i, %.71.i
  %77 = add i64 %.350.i.i, %.13.i.i
  %78 = add i64 %77, %76
  %79 = shl i64 %78, 3
  %scevgep.i154.i = getelementptr i8, ptr %a14, i64 %79
  %80 = add i64 %.2223.sroa.0.3.i, %.1524.sroa.0.3.i
  %81 = add i64 %80, %.2876.sroa.0.3.i
  %82 = add i64 %81, %.3243.sroa.0.3.i
  %83 = add i64 %82, %.3774.sroa.0.3.i
  %84 = add i64 %83, %.259154156.epil.init.i.i
  %85 = shl i64 %84, 3
  %scevgep.i = getelementptr i8, ptr %a18, i64 %85
  br label %B96.epil.i.i
B96.epil.i.i:
  %lsr.iv.i156.i = phi ptr [ %scevgep2.i158.i, %B96.epil.i.i ], [ %scevgep.i154.i, %B96.epil.preheader.i.i ]
  %epil.iter.i.i = phi i64 [ %epil.iter.next.i.i, %B96.epil.i.i ], [ 0, %B96.epil.preheader.i.i ]
  %86 = shl i64 %epil.iter.i.i, 3
  %scevgep416.i = getelementptr i8, ptr %scevgep.i, i64 %86
  %.320.epil.i.i = load double, ptr %scevgep416.i, align 8, !noalias !123
  store double %.320.epil.i.i, ptr %lsr.iv.i156.i, align 8, !noalias !123
  %epil.iter.next.i.i = add i64 %epil.iter.i.i, 1
  %scevgep2.i158.i = getelementptr i8, ptr %lsr.iv.i156.i, i64 %.16.i.i
  %epil.iter.cmp.not.i.i = icmp eq i64 %xtraiter.i.i, %epil.iter.next.i.i
  br i1 %epil.iter.cmp.not.i.i, label %B2290.endif.endif.endif.i, label %B96.epil.i.i, !llvm.loop !126
B2290.endif.endif.endif.i:
  %.6636.i = load i64, ptr %.6401.i, align 8, !noalias !21
  %.6637.i = add nsw i64 %.6636.i, 1
  store i64 %.6637.i, ptr %.6401.i, align 8, !noalias !21
  br label %_ZN6poppet6engine10integrator9integrateB2v1B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAg6cJqBrMeIZJFEGM0QQAE8int64_2a8int64_2a10float64_2a10float64_2a10float64_2a10float64_2a8uint8_2a10float64_2a10float64_2a8uint8_2a10float64_2a8int64_2a10float64_2a8uint8_2a10float64_2a10float64_2a10float64_2a8int64_2a10float64_2a10float64_2a.exit
_ZN6poppet6engine10integrator9integrateB2v1B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAg6cJqBrMeIZJFEGM0QQAE8int64_2a8int64_2a10float64_2a10float64_2a10float64_2a10float64_2a8uint8_2a10float64_2a10float64_2a8uint8_2a10float64_2a8int64_2a10float64_2a8uint8_2a10float64_2a10float64_2a10float64_2a8int64_2a10float64_2a10float64_2a.exit:
  store double %t.4.1.i, ptr %a16, align 8, !noalias !21
  call void @llvm.lifetime.end.p0(ptr nonnull %.4705.i)
  ret i64 %status.5.1.i
}
declare void @llvm.lifetime.start.p0(ptr)
declare void @llvm.lifetime.end.p0(ptr)
!0 = !{!1}
!1 = distinct !{!1, !2, !"_ZN6poppet6engine8stepping9inputs_atB3v12B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!2 = distinct !{!2, !"_ZN6poppet6engine8stepping9inputs_atB3v12B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!3 = !{!4}
!4 = distinct !{!4, !5, !"_ZN6poppet6engine8stepping12next_instantB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!5 = distinct !{!5, !"_ZN6poppet6engine8stepping12next_instantB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedEx"}
!6 = distinct !{!6, !7}
!7 = !{!"llvm.loop.unroll.disable"}
!8 = !{!9}
!9 = distinct !{!9, !10, !"_ZN6poppet6engine8stepping12next_instantB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!10 = distinct !{!10, !"_ZN6poppet6engine8stepping12next_instantB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedEx"}
!11 = !{!12}
!12 = distinct !{!12, !13, !"_ZN6poppet6engine8stepping11interpolateB3v27B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!13 = distinct !{!13, !"_ZN6poppet6engine8stepping11interpolateB3v27B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!14 = !{!15}
!15 = distinct !{!15, !16, !"_ZN6poppet6engine8stepping9inputs_atB3v12B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!16 = distinct !{!16, !"_ZN6poppet6engine8stepping9inputs_atB3v12B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!17 = !{!18}
!18 = distinct !{!18, !19, !"_ZN6poppet6engine8stepping5writeB3v30B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedEx: %retptr"}
!19 = distinct !{!19, !"_ZN6poppet6engine8stepping5writeB3v30B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedEx"}
!20 = distinct !{!20, !7}
!21 = !{!22}
!22 = distinct !{!22, !23, !"_ZN6poppet6engine10integrator9integrateB2v1B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAg6cJqBrMeIZJFEGM0QQAE8int64_2a8int64_2a10float64_2a10float64_2a10float64_2a10float64_2a8uint8_2a10float64_2a10float64_2a8uint8_2a10float64_2a8int64_2a10float64_2a8uint8_2a10float64_2a10float64_2a10float64_2a8int64_2a10float64_2a10float64_2a: %retptr"}
!23 = distinct !{!23, !"_ZN6poppet6engine10integrator9integrateB2v1B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAg6cJqBrMeIZJFEGM0QQAE8int64_2a8int64_2a10float64_2a10float64_2a10float64_2a10float64_2a8uint8_2a10float64_2a10float64_2a8uint8_2a10float64_2a8int64_2a10float64_2a8uint8_2a10float64_2a10float64_2a10float64_2a8int64_2a10float64_2a10float64_2a"}
!24 = !{!"branch_weights", i32 1, i32 99}
!25 = !{!26, !22}
!26 = distinct !{!26, !27, !"_ZN6poppet6engine8stepping9inputs_atB3v12B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!27 = distinct !{!27, !"_ZN6poppet6engine8stepping9inputs_atB3v12B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!28 = !{!29, !22}
!29 = distinct !{!29, !30, !"_ZN6poppet6engine10integrator8_segmentB3v14B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!30 = distinct !{!30, !"_ZN6poppet6engine10integrator8_segmentB3v14B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!31 = !{!"branch_weights", i32 99, i32 1}
!32 = !{!33, !29, !22}
!33 = distinct !{!33, !34, !"_ZN6poppet6engine8stepping5beginB3v16B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!34 = distinct !{!34, !"_ZN6poppet6engine8stepping5beginB3v16B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE"}
!35 = !{!36, !33, !29, !22}
!36 = distinct !{!36, !37, !"_ZN6poppet6engine8stepping9inputs_atB3v12B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!37 = distinct !{!37, !"_ZN6poppet6engine8stepping9inputs_atB3v12B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!38 = !{!39, !33, !29, !22}
!39 = distinct !{!39, !40, !"_ZN6poppet6engine8stepping10first_stepB3v18B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedEd: %retptr"}
!40 = distinct !{!40, !"_ZN6poppet6engine8stepping10first_stepB3v18B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedEd"}
!41 = !{!42, !33, !29, !22}
!42 = distinct !{!42, !43, !"_ZN6poppet6engine8stepping15input_slopes_atB3v17B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!43 = distinct !{!43, !"_ZN6poppet6engine8stepping15input_slopes_atB3v17B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!44 = !{!45, !47, !29, !22}
!45 = distinct !{!45, !46, !"_ZN6poppet6engine8stepping12next_instantB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!46 = distinct !{!46, !"_ZN6poppet6engine8stepping12next_instantB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedEx"}
!47 = distinct !{!47, !48, !"_ZN6poppet6engine10integrator6_reachB3v20B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdddddb5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!48 = distinct !{!48, !"_ZN6poppet6engine10integrator6_reachB3v20B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdddddb5ArrayIdLi1E1C7mutable7alignedEx"}
!49 = distinct !{!49, !7}
!50 = !{!51, !29, !22}
!51 = distinct !{!51, !52, !"_ZN6poppet6engine10integrator6_againB3v21B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExd: %retptr"}
!52 = distinct !{!52, !"_ZN6poppet6engine10integrator6_againB3v21B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExd"}
!53 = !{!54, !29, !22}
!54 = distinct !{!54, !55, !"_ZN6poppet6engine8stepping5errorB3v24B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE: %retptr"}
!55 = distinct !{!55, !"_ZN6poppet6engine8stepping5errorB3v24B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE"}
!56 = !{!57, !59, !29, !22}
!57 = distinct !{!57, !58, !"_ZN6poppet6engine8stepping12next_instantB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!58 = distinct !{!58, !"_ZN6poppet6engine8stepping12next_instantB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedEx"}
!59 = distinct !{!59, !60, !"_ZN6poppet6engine10integrator7_acceptB3v25B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE: %retptr"}
!60 = distinct !{!60, !"_ZN6poppet6engine10integrator7_acceptB3v25B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE"}
!61 = distinct !{!61, !7}
!62 = !{!59, !29, !22}
!63 = !{!64, !66, !59, !29, !22}
!64 = distinct !{!64, !65, !"_ZN6poppet6engine8stepping11interpolateB3v27B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!65 = distinct !{!65, !"_ZN6poppet6engine8stepping11interpolateB3v27B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!66 = distinct !{!66, !67, !"_ZN6poppet6engine8stepping11stop_insideB3v26B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!67 = distinct !{!67, !"_ZN6poppet6engine8stepping11stop_insideB3v26B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE"}
!68 = !{!69, !66, !59, !29, !22}
!69 = distinct !{!69, !70, !"_ZN6poppet6engine8stepping11interpolateB3v27B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!70 = distinct !{!70, !"_ZN6poppet6engine8stepping11interpolateB3v27B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!71 = !{!72, !66, !59, !29, !22}
!72 = distinct !{!72, !73, !"_ZN6poppet6engine8stepping9inputs_atB3v12B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!73 = distinct !{!73, !"_ZN6poppet6engine8stepping9inputs_atB3v12B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!74 = !{!75, !66, !59, !29, !22}
!75 = distinct !{!75, !76, !"_ZN6poppet6engine8stepping14stop_conditionB3v13B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!76 = distinct !{!76, !"_ZN6poppet6engine8stepping14stop_conditionB3v13B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE"}
!77 = !{!78, !59, !29, !22}
!78 = distinct !{!78, !79, !"_ZN6poppet6engine8stepping10act_insideB3v28B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExxdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE: %retptr"}
!79 = distinct !{!79, !"_ZN6poppet6engine8stepping10act_insideB3v28B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExxdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE"}
!80 = !{!81, !78, !59, !29, !22}
!81 = distinct !{!81, !82, !"_ZN6poppet6engine8stepping12next_instantB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!82 = distinct !{!82, !"_ZN6poppet6engine8stepping12next_instantB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedEx"}
!83 = distinct !{!83, !7}
!84 = !{!85, !78, !59, !29, !22}
!85 = distinct !{!85, !86, !"_ZN6poppet6engine8stepping11interpolateB3v27B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!86 = distinct !{!86, !"_ZN6poppet6engine8stepping11interpolateB3v27B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!87 = !{!88, !59, !29, !22}
!88 = distinct !{!88, !89, !"_ZN6poppet6engine8stepping4takeB3v31B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE: %retptr"}
!89 = distinct !{!89, !"_ZN6poppet6engine8stepping4takeB3v31B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE"}
!90 = !{!91, !29, !22}
!91 = distinct !{!91, !92, !"_ZN6poppet6engine8stepping7verdictB3v33B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEddd5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEbb: %retptr"}
!92 = distinct !{!92, !"_ZN6poppet6engine8stepping7verdictB3v33B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEddd5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEbb"}
!93 = !{!94, !29, !22}
!94 = distinct !{!94, !95, !"_ZN6poppet6engine8stepping6variesB3v15B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!95 = distinct !{!95, !"_ZN6poppet6engine8stepping6variesB3v15B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi2E1C7mutable7alignedE"}
!96 = !{!97, !29, !22}
!97 = distinct !{!97, !98, !"_ZN6poppet6engine8stepping9inputs_atB3v12B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!98 = distinct !{!98, !"_ZN6poppet6engine8stepping9inputs_atB3v12B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!99 = !{!100, !29, !22}
!100 = distinct !{!100, !101, !"_ZN6poppet6engine8stepping9inputs_atB3v12B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!101 = distinct !{!101, !"_ZN6poppet6engine8stepping9inputs_atB3v12B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!102 = !{!103, !22}
!103 = distinct !{!103, !104, !"_ZN6poppet6engine10integrator15_without_statesB3v34B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE: %retptr"}
!104 = distinct !{!104, !"_ZN6poppet6engine10integrator15_without_statesB3v34B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE"}
!105 = !{!106, !103, !22}
!106 = distinct !{!106, !107, !"_ZN6poppet6engine8stepping12next_instantB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!107 = distinct !{!107, !"_ZN6poppet6engine8stepping12next_instantB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedEx"}
!108 = distinct !{!108, !7}
!109 = !{!110, !112, !103, !22}
!110 = distinct !{!110, !111, !"_ZN6poppet6engine8stepping9inputs_atB3v12B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!111 = distinct !{!111, !"_ZN6poppet6engine8stepping9inputs_atB3v12B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!112 = distinct !{!112, !113, !"_ZN6poppet6engine8stepping11stop_insideB3v26B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!113 = distinct !{!113, !"_ZN6poppet6engine8stepping11stop_insideB3v26B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE"}
!114 = !{!115, !112, !103, !22}
!115 = distinct !{!115, !116, !"_ZN6poppet6engine8stepping14stop_conditionB3v13B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!116 = distinct !{!116, !"_ZN6poppet6engine8stepping14stop_conditionB3v13B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE"}
!117 = !{!118, !22}
!118 = distinct !{!118, !119, !"_ZN6poppet6engine8stepping9inputs_atB3v12B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!119 = distinct !{!119, !"_ZN6poppet6engine8stepping9inputs_atB3v12B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!120 = !{!121, !22}
!121 = distinct !{!121, !122, !"_ZN6poppet6engine8stepping14stop_conditionB3v13B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!122 = distinct !{!122, !"_ZN6poppet6engine8stepping14stop_conditionB3v13B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE"}
!123 = !{!124, !22}
!124 = distinct !{!124, !125, !"_ZN6poppet6engine8stepping5writeB3v30B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedEx: %retptr"}
!125 = distinct !{!125, !"_ZN6poppet6engine8stepping5writeB3v30B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedEx"}
!126 = distinct !{!126, !7}
