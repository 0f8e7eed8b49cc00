; made from integrator.py and stepping.py, sha256 75082747f0eb3d4e020a088fad18ac1737e16e2e7fbdc373acb5e1b307f09c9b
@v25 = private unnamed_addr constant [4 x double] [double 3.860000e-01, double 2.100000e-01, double 6.300000e-01, double 1.000000e+00], align 8
declare i64 @llvm.smax.i64(i64, i64)
declare i64 @llvm.smin.i64(i64, i64)
declare double @llvm.sin.f64(double)
define internal fastcc void @v34(ptr noalias nonnull writeonly %retptr, i64 %arg.update, double %arg.t, double %arg.start, ptr readonly %arg.c.4, ptr %arg.x.4, i64 %arg.u.2, ptr %arg.u.4, ptr %arg.p.4, i64 %arg.z.2, ptr %arg.z.4, ptr %arg.tt.4, i64 %arg.fired.2, ptr %arg.fired.4, ptr %arg.after.4, ptr readonly %arg.acting.4) unnamed_addr {
B0.endif:
  %.5.i = fmul double %arg.t, 0x3D06849B86A12B9B
  %.6.i = fadd double %.5.i, 1.000000e-15
  %.180 = fadd double %arg.t, %.6.i
  %.10362.not.i7 = icmp eq i64 %arg.fired.2, 0
  br i1 %.10362.not.i7, label %B0.endif.endif, label %B58.backedge.preheader.i8
B136:
  %.319394396 = phi i64 [ %.326.1, %B136 ], [ 0, %B136.preheader ]
  %sunkaddr = shl i64 %.319394396, 3
  %sunkaddr51 = getelementptr i8, ptr %arg.z.4, i64 %sunkaddr
  %.384 = load double, ptr %sunkaddr51, align 8
  %.386 = fcmp ole double %.384, %.180
  %"$phi168.1.2.2" = select i1 %.386, double 1.000000e+00, double 0.000000e+00
  %sunkaddr53 = getelementptr i8, ptr %arg.fired.4, i64 %sunkaddr
  store double %"$phi168.1.2.2", ptr %sunkaddr53, align 8
  %.326.1 = add nuw i64 %.319394396, 2
  %sunkaddr56 = getelementptr i8, ptr %sunkaddr51, i64 8
  %.384.1 = load double, ptr %sunkaddr56, align 8
  %.386.1 = fcmp ole double %.384.1, %.180
  %"$phi168.1.2.2.1" = select i1 %.386.1, double 1.000000e+00, double 0.000000e+00
  %sunkaddr61 = getelementptr i8, ptr %sunkaddr53, i64 8
  store double %"$phi168.1.2.2.1", ptr %sunkaddr61, align 8
  %niter.ncmp.1 = icmp eq i64 %unroll_iter, %.326.1
  br i1 %niter.ncmp.1, label %B178.loopexit.unr-lcssa, label %B136
B178.loopexit.unr-lcssa:
  br i1 %11, label %B178, label %B136.epil.preheader
B136.epil.preheader:
  %.384.epil = load double, ptr %sunkaddr65, align 8
  %.386.epil = fcmp ole double %.384.epil, %.180
  %"$phi168.1.2.2.epil" = select i1 %.386.epil, double 1.000000e+00, double 0.000000e+00
  store double %"$phi168.1.2.2.epil", ptr %sunkaddr67, align 8
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
  %sunkaddr68 = getelementptr i8, ptr %arg.acting.4, i64 %.645400402
  %.714 = load i8, ptr %sunkaddr68, align 1
  %.715.not = icmp eq i8 %.714, 0
  %sunkaddr69 = shl i64 %.645400402, 3
  %sunkaddr70 = getelementptr i8, ptr %arg.after.4, i64 %sunkaddr69
  %.824.pre = load double, ptr %sunkaddr70, align 8
  br i1 %.715.not, label %B366, label %B326
B326:
  %sunkaddr72 = getelementptr i8, ptr %arg.z.4, i64 %sunkaddr69
  %.783 = load double, ptr %sunkaddr72, align 8
  %.784 = fcmp une double %.824.pre, %.783
  br i1 %.784, label %B362, label %B366
B362:
  br label %B366
B366:
  %changed.5.2 = phi i1 [ true, %B362 ], [ %changed.3.1404, %B326 ], [ %changed.3.1404, %B308 ]
  %sunkaddr74 = getelementptr i8, ptr %arg.z.4, i64 %sunkaddr69
  store double %.824.pre, ptr %sunkaddr74, align 8
  %.652.1 = add nuw i64 %.645400402, 2
  %sunkaddr76 = getelementptr i8, ptr %sunkaddr68, i64 1
  %.714.1 = load i8, ptr %sunkaddr76, align 1
  %.715.not.1 = icmp eq i8 %.714.1, 0
  %sunkaddr79 = getelementptr i8, ptr %sunkaddr70, i64 8
  %.824.pre.1 = load double, ptr %sunkaddr79, align 8
  br i1 %.715.not.1, label %B366.1, label %B326.1
B326.1:
  %sunkaddr86 = getelementptr i8, ptr %sunkaddr74, i64 8
  %.783.1 = load double, ptr %sunkaddr86, align 8
  %.784.1 = fcmp une double %.824.pre.1, %.783.1
  br i1 %.784.1, label %B362.1, label %B366.1
B362.1:
  br label %B366.1
B366.1:
  %changed.5.2.1 = phi i1 [ true, %B362.1 ], [ %changed.5.2, %B326.1 ], [ %changed.5.2, %B366 ]
  %sunkaddr90 = getelementptr i8, ptr %sunkaddr74, i64 8
  store double %.824.pre.1, ptr %sunkaddr90, align 8
  %niter57.ncmp.1 = icmp eq i64 %unroll_iter56, %.652.1
  br i1 %niter57.ncmp.1, label %B390.loopexit.unr-lcssa, label %B308
B390.loopexit.unr-lcssa:
  br i1 %13, label %B390, label %B308.epil.preheader
B308.epil.preheader:
  %changed.3.1404.epil.init = phi i1 [ %changed.4.0, %B178.endif.endif ], [ %changed.5.2.1, %B390.loopexit.unr-lcssa ]
  %.714.epil = load i8, ptr %sunkaddr91, align 1
  %.715.not.epil = icmp eq i8 %.714.epil, 0
  %.824.pre.epil = load double, ptr %sunkaddr93, align 8
  br i1 %.715.not.epil, label %B366.epil, label %B326.epil
B326.epil:
  %.783.epil = load double, ptr %sunkaddr95, align 8
  %.784.epil = fcmp une double %.824.pre.epil, %.783.epil
  br i1 %.784.epil, label %B362.epil, label %B366.epil
B362.epil:
  br label %B366.epil
B366.epil:
  %changed.5.2.epil = phi i1 [ true, %B362.epil ], [ %changed.3.1404.epil.init, %B326.epil ], [ %changed.3.1404.epil.init, %B308.epil.preheader ]
  store double %.824.pre.epil, ptr %sunkaddr97, align 8
  br label %B390
B390:
  %changed.3.1.lcssa = phi i1 [ %changed.4.0, %B178.endif.endif ], [ %changed.5.2.1, %B390.loopexit.unr-lcssa ], [ %changed.5.2.epil, %B366.epil ]
  br i1 %.10362.not.i7, label %B390.endif, label %B58.backedge.preheader.i
B58.backedge.preheader.i:
  br i1 %14, label %B58.backedge.epil.preheader.i, label %B58.backedge.i
B58.backedge.i:
  %first.2.065.i = phi double [ %.13.i.3.i, %B58.backedge.i ], [ 0x7FF0000000000000, %B58.backedge.preheader.i ]
  %.1096163.i = phi i64 [ %.116.3.i, %B58.backedge.i ], [ 0, %B58.backedge.preheader.i ]
  %sunkaddr98 = shl i64 %.1096163.i, 3
  %sunkaddr100 = getelementptr i8, ptr %arg.z.4, i64 %sunkaddr98
  %.170.i = load double, ptr %sunkaddr100, align 8, !noalias !3
  %.12.i.i = fcmp olt double %.170.i, %first.2.065.i
  %.13.i.i = select i1 %.12.i.i, double %.170.i, double %first.2.065.i
  %sunkaddr103 = getelementptr i8, ptr %sunkaddr100, i64 8
  %.170.1.i = load double, ptr %sunkaddr103, align 8, !noalias !3
  %.12.i.1.i = fcmp olt double %.170.1.i, %.13.i.i
  %.13.i.1.i = select i1 %.12.i.1.i, double %.170.1.i, double %.13.i.i
  %sunkaddr106 = getelementptr i8, ptr %sunkaddr100, i64 16
  %.170.2.i = load double, ptr %sunkaddr106, align 8, !noalias !3
  %.12.i.2.i = fcmp olt double %.170.2.i, %.13.i.1.i
  %.13.i.2.i = select i1 %.12.i.2.i, double %.170.2.i, double %.13.i.1.i
  %sunkaddr109 = getelementptr i8, ptr %sunkaddr100, i64 24
  %.170.3.i = load double, ptr %sunkaddr109, align 8, !noalias !3
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
  %sunkaddr110 = shl i64 %.1096163.i14, 3
  %sunkaddr111 = getelementptr i8, ptr %arg.z.4, i64 %sunkaddr110
  %.170.i17 = load double, ptr %sunkaddr111, align 8, !noalias !8
  %.12.i.i18 = fcmp olt double %.170.i17, %first.2.065.i13
  %.13.i.i19 = select i1 %.12.i.i18, double %.170.i17, double %first.2.065.i13
  %sunkaddr114 = getelementptr i8, ptr %sunkaddr111, i64 8
  %.170.1.i21 = load double, ptr %sunkaddr114, align 8, !noalias !8
  %.12.i.1.i22 = fcmp olt double %.170.1.i21, %.13.i.i19
  %.13.i.1.i23 = select i1 %.12.i.1.i22, double %.170.1.i21, double %.13.i.i19
  %sunkaddr117 = getelementptr i8, ptr %sunkaddr111, i64 16
  %.170.2.i25 = load double, ptr %sunkaddr117, align 8, !noalias !8
  %.12.i.2.i26 = fcmp olt double %.170.2.i25, %.13.i.1.i23
  %.13.i.2.i27 = select i1 %.12.i.2.i26, double %.170.2.i25, double %.13.i.1.i23
  %sunkaddr120 = getelementptr i8, ptr %sunkaddr111, i64 24
  %.170.3.i29 = load double, ptr %sunkaddr120, align 8, !noalias !8
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
  %sunkaddr63 = shl i64 %unroll_iter, 3
  %sunkaddr65 = getelementptr i8, ptr %arg.z.4, i64 %sunkaddr63
  %sunkaddr67 = getelementptr i8, ptr %arg.fired.4, i64 %sunkaddr63
  %12 = and i64 %arg.z.2, 1
  %13 = icmp eq i64 %12, 0
  %sunkaddr91 = getelementptr i8, ptr %arg.acting.4, i64 %unroll_iter56
  %sunkaddr92 = shl i64 %unroll_iter56, 3
  %sunkaddr93 = getelementptr i8, ptr %arg.after.4, i64 %sunkaddr92
  %sunkaddr95 = getelementptr i8, ptr %arg.z.4, i64 %sunkaddr92
  %sunkaddr97 = getelementptr i8, ptr %arg.z.4, i64 %sunkaddr92
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
declare double @llvm.fabs.f64(double)
declare double @llvm.cos.f64(double)
declare double @llvm.pow.f64(double, double)
define internal fastcc void @v35(ptr noalias nonnull writeonly %retptr, i64 %arg.outputs, double %arg.t, double %arg.h, double %arg.until, double %arg.start, ptr readonly %arg.c.4, ptr readonly %arg.x.4, ptr readonly %arg.x1.4, ptr readonly %arg.dense.4, i64 %arg.row.2, ptr %arg.row.4, i64 %arg.u.2, ptr %arg.u.4, ptr %arg.p.4, ptr %arg.tt.4, i64 %arg.y.2, ptr %arg.y.4, i64 %arg.grid.2, ptr readonly %arg.grid.4, i64 %arg.grid.5.0, ptr writeonly %arg.table.4, i64 %arg.table.5.1, ptr %arg.counts.4) unnamed_addr {
B0:
  %.227 = getelementptr i8, ptr %arg.counts.4, i64 16
  %.228 = load i64, ptr %.227, align 8
  %.236 = icmp slt i64 %.228, %arg.grid.2
  br i1 %.236, label %B38, label %common.ret
B38:
  %.281 = icmp slt i64 %.228, 0
  %.282 = select i1 %.281, i64 %arg.grid.5.0, i64 0
  %0 = getelementptr double, ptr %arg.grid.4, i64 %.228
  %.296 = getelementptr double, ptr %0, i64 %.282
  %.297 = load double, ptr %.296, align 8
  %.299 = fcmp olt double %.297, %arg.until
  br i1 %.299, label %B74.preheader, label %common.ret
B74.preheader:
  %invariant.gep.i = getelementptr double, ptr %arg.dense.4, i64 %arg.row.2
  %scevgep.i10 = getelementptr i8, ptr %arg.c.4, i64 40
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
  %8 = icmp eq i64 %arg.row.2, 0
  %9 = icmp eq i64 %arg.u.2, 0
  %10 = icmp eq i64 %arg.y.2, 0
  %11 = inttoptr i64 %arg.outputs to ptr
  %12 = icmp ult i64 %arg.y.2, 4
  %13 = icmp eq i64 %4, 0
  %14 = and i64 %4, 4
  %15 = icmp eq i64 %14, 0
  %16 = icmp eq i64 %xtraiter.i, 0
  br label %B74
B74:
  %.334 = phi i64 [ %.670, %B356 ], [ %.228, %B74.preheader ]
  %.348 = icmp slt i64 %.334, 0
  %.349 = select i1 %.348, i64 %arg.grid.5.0, i64 0
  %17 = getelementptr double, ptr %arg.grid.4, i64 %.334
  %.363 = getelementptr double, ptr %17, i64 %.349
  %.364 = load double, ptr %.363, align 8
  %.366 = fsub double %.364, %arg.t
  %.371 = fdiv double %.366, %arg.h
  %.64.i = fsub double 1.000000e+00, %.371
  br i1 %8, label %B74.endif.endif, label %B60.i
B60.i:
  %.166146148.i = phi i64 [ %.173.i, %B60.i ], [ 0, %B74 ]
  %.173.i = add nuw nsw i64 %.166146148.i, 1
  %18 = shl i64 %.166146148.i, 3
  %scevgep4.i = getelementptr i8, ptr %arg.x.4, i64 %18
  %.227.i = load double, ptr %scevgep4.i, align 8, !noalias !11
  %.229.i = fmul double %.64.i, %.227.i
  %scevgep3.i = getelementptr i8, ptr %arg.x1.4, i64 %18
  %.259.i = load double, ptr %scevgep3.i, align 8, !noalias !11
  %scevgep5 = getelementptr i8, ptr %arg.dense.4, i64 %18
  %.289.i = load double, ptr %scevgep5, align 8, !noalias !11
  %scevgep4 = getelementptr i8, ptr %invariant.gep.i, i64 %18
  %.321.i = load double, ptr %scevgep4, align 8, !noalias !11
  %.323.i = fmul double %.371, %.321.i
  %.324.i = fadd double %.289.i, %.323.i
  %.326.i = fmul double %.64.i, %.324.i
  %.327.i = fadd double %.259.i, %.326.i
  %.329.i = fmul double %.371, %.327.i
  %.330.i = fadd double %.229.i, %.329.i
  %scevgep = getelementptr i8, ptr %arg.row.4, i64 %18
  store double %.330.i, ptr %scevgep, align 8, !noalias !11
  %exitcond.not.i = icmp eq i64 %arg.row.2, %.173.i
  br i1 %exitcond.not.i, label %B74.endif.endif.loopexit, label %B60.i
B356:
  %.783 = icmp slt i64 %.669, -1
  %.784 = select i1 %.783, i64 %arg.grid.5.0, i64 0
  %19 = getelementptr double, ptr %arg.grid.4, i64 %.670
  %.798 = getelementptr double, ptr %19, i64 %.784
  %.799 = load double, ptr %.798, align 8
  %.801 = fcmp olt double %.799, %arg.until
  br i1 %.801, label %B74, label %common.ret
common.ret:
  store ptr null, ptr %retptr, align 8
  ret void
B74.endif.endif.loopexit:
  %.440.pre = load i64, ptr %.227, align 8
  br label %B74.endif.endif
B74.endif.endif:
  %.440 = phi i64 [ %.440.pre, %B74.endif.endif.loopexit ], [ %.334, %B74 ]
  %.454 = icmp slt i64 %.440, 0
  %.455 = select i1 %.454, i64 %arg.grid.5.0, i64 0
  %20 = getelementptr double, ptr %arg.grid.4, i64 %.440
  %.469 = getelementptr double, ptr %20, i64 %.455
  %.470 = load double, ptr %.469, align 8
  %.40.i = fsub double %.470, %arg.start
  br i1 %9, label %B74.endif.endif.endif, label %B56.i
B56.i:
  %lsr.iv.i = phi ptr [ %scevgep1.i13, %B316.i ], [ %scevgep.i10, %B74.endif.endif ]
  %.138222224.i = phi i64 [ %.145.i, %B316.i ], [ 0, %B74.endif.endif ]
  %.145.i = add nuw nsw i64 %.138222224.i, 1
  %scevgep6.i = getelementptr i8, ptr %lsr.iv.i, i64 -40
  %.227.i11 = load double, ptr %scevgep6.i, align 8, !noalias !14
  %scevgep5.i = getelementptr i8, ptr %lsr.iv.i, i64 -32
  %.282.i = load double, ptr %scevgep5.i, align 8, !noalias !14
  %.284.i = fmul double %.40.i, %.282.i
  %.285.i = fadd double %.227.i11, %.284.i
  %scevgep4.i12 = getelementptr i8, ptr %lsr.iv.i, i64 -24
  %.347.i = load double, ptr %scevgep4.i12, align 8, !noalias !14
  %.348.i = fcmp une double %.347.i, 0.000000e+00
  br i1 %.348.i, label %B134.i, label %B316.i
B134.i:
  %scevgep3.i15 = getelementptr i8, ptr %lsr.iv.i, i64 -16
  %.405.i = load double, ptr %scevgep3.i15, align 8, !noalias !14
  %scevgep2.i16 = getelementptr i8, ptr %lsr.iv.i, i64 -8
  %.460.i = load double, ptr %scevgep2.i16, align 8, !noalias !14
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
  %scevgep1.i13 = getelementptr i8, ptr %lsr.iv.i, i64 48
  %exitcond.not.i14 = icmp eq i64 %arg.u.2, %.145.i
  br i1 %exitcond.not.i14, label %B74.endif.endif.endif.loopexit, label %B56.i
B74.endif.endif.endif.loopexit:
  %.534.pre = load i64, ptr %.227, align 8
  br label %B74.endif.endif.endif
B74.endif.endif.endif:
  %.534 = phi i64 [ %.534.pre, %B74.endif.endif.endif.loopexit ], [ %.440, %B74.endif.endif ]
  %.548 = icmp slt i64 %.534, 0
  %.549 = select i1 %.548, i64 %arg.grid.5.0, i64 0
  %22 = getelementptr double, ptr %arg.grid.4, i64 %.534
  %.563 = getelementptr double, ptr %22, i64 %.549
  %.564 = load double, ptr %.563, align 8
  store double %.564, ptr %arg.tt.4, align 8, !noalias !17
  tail call void %11(ptr nonnull %arg.tt.4, ptr %arg.row.4, ptr %arg.u.4, ptr %arg.p.4, ptr %arg.y.4), !noalias !17
  br i1 %10, label %B74.endif.endif.endif.endif, label %B96.lr.ph.i
B96.lr.ph.i:
  %.350.i = select i1 %.548, i64 %arg.table.5.1, i64 0
  br i1 %12, label %B96.epil.preheader.i, label %B96.lr.ph.new.i
B96.lr.ph.new.i:
  %invariant.gep.i17 = getelementptr double, ptr %arg.table.4, i64 %.534
  %invariant.gep159.i = getelementptr double, ptr %invariant.gep.i17, i64 %.350.i
  br i1 %13, label %B96.i.epil.preheader, label %B96.i
B96.i:
  %lsr.iv = phi i64 [ %lsr.iv.next, %B96.i ], [ %7, %B96.lr.ph.new.i ]
  %lsr.iv13.i = phi ptr [ %scevgep50, %B96.i ], [ %invariant.gep159.i, %B96.lr.ph.new.i ]
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
  %scevgep44 = getelementptr i8, ptr %sunkaddr23.i, i64 %sunkaddr22.i
  store double %.320.2.i, ptr %scevgep44, align 8, !noalias !17
  %sunkaddr34 = getelementptr i8, ptr %sunkaddr25, i64 24
  %.320.3.i = load double, ptr %sunkaddr34, align 8, !noalias !17
  %scevgep45 = getelementptr i8, ptr %scevgep44, i64 %sunkaddr22.i
  store double %.320.3.i, ptr %scevgep45, align 8, !noalias !17
  %sunkaddr37 = getelementptr i8, ptr %sunkaddr25, i64 32
  %.320.i.1 = load double, ptr %sunkaddr37, align 8, !noalias !17
  %scevgep46 = getelementptr i8, ptr %scevgep45, i64 %sunkaddr22.i
  store double %.320.i.1, ptr %scevgep46, align 8, !noalias !17
  %sunkaddr40 = getelementptr i8, ptr %sunkaddr25, i64 40
  %.320.1.i.1 = load double, ptr %sunkaddr40, align 8, !noalias !17
  %scevgep47 = getelementptr i8, ptr %scevgep46, i64 %sunkaddr22.i
  store double %.320.1.i.1, ptr %scevgep47, align 8, !noalias !17
  %sunkaddr43 = getelementptr i8, ptr %sunkaddr25, i64 48
  %.320.2.i.1 = load double, ptr %sunkaddr43, align 8, !noalias !17
  %scevgep48 = getelementptr i8, ptr %scevgep47, i64 %sunkaddr22.i
  store double %.320.2.i.1, ptr %scevgep48, align 8, !noalias !17
  %.266.3.i.1 = add i64 %.259154156.i, 8
  %sunkaddr44 = shl i64 %.266.3.i.1, 3
  %sunkaddr45 = getelementptr i8, ptr %arg.y.4, i64 %sunkaddr44
  %sunkaddr46 = getelementptr i8, ptr %sunkaddr45, i64 -8
  %.320.3.i.1 = load double, ptr %sunkaddr46, align 8, !noalias !17
  %scevgep49 = getelementptr i8, ptr %scevgep48, i64 %sunkaddr22.i
  store double %.320.3.i.1, ptr %scevgep49, align 8, !noalias !17
  %scevgep50 = getelementptr i8, ptr %scevgep49, i64 %sunkaddr22.i
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
  br i1 %16, label %B74.endif.endif.endif.endif, label %B96.epil.preheader.i
B96.epil.preheader.i:
  %.259154156.epil.init.i = phi i64 [ %unroll_iter.i, %B126.loopexit.unr-lcssa.i ], [ 0, %B96.lr.ph.i ]
  %23 = mul i64 %.259154156.epil.init.i, %arg.table.5.1
  %24 = add i64 %.350.i, %.534
  %25 = add i64 %24, %23
  %26 = shl i64 %25, 3
  %scevgep.i18 = getelementptr i8, ptr %arg.table.4, i64 %26
  %27 = shl i64 %.259154156.epil.init.i, 3
  %scevgep3.i19 = getelementptr i8, ptr %arg.y.4, i64 %27
  br label %B96.epil.i
B96.epil.i:
  %lsr.iv.i20 = phi ptr [ %scevgep2.i22, %B96.epil.i ], [ %scevgep.i18, %B96.epil.preheader.i ]
  %epil.iter.i = phi i64 [ %epil.iter.next.i, %B96.epil.i ], [ 0, %B96.epil.preheader.i ]
  %28 = shl i64 %epil.iter.i, 3
  %scevgep51 = getelementptr i8, ptr %scevgep3.i19, i64 %28
  %.320.epil.i = load double, ptr %scevgep51, align 8, !noalias !17
  store double %.320.epil.i, ptr %lsr.iv.i20, align 8, !noalias !17
  %epil.iter.next.i = add i64 %epil.iter.i, 1
  %scevgep2.i22 = getelementptr i8, ptr %lsr.iv.i20, i64 %sunkaddr22.i
  %epil.iter.cmp.not.i = icmp eq i64 %xtraiter.i, %epil.iter.next.i
  br i1 %epil.iter.cmp.not.i, label %B74.endif.endif.endif.endif, label %B96.epil.i, !llvm.loop !20
B74.endif.endif.endif.endif:
  %.669 = load i64, ptr %.227, align 8
  %.670 = add nsw i64 %.669, 1
  store i64 %.670, ptr %.227, align 8
  %.738 = icmp slt i64 %.670, %arg.grid.2
  br i1 %.738, label %B356, label %common.ret
}
declare i64 @llvm.umin.i64(i64, i64)
define i64 @integrate(ptr readonly %a0, ptr readonly %a1, ptr %a2, ptr %a3, ptr readonly %a4, ptr readonly %a5, ptr readonly %a6, ptr readonly %a7, ptr readonly %a8, ptr readonly %a9, ptr readonly %a10, ptr readonly %a11, ptr readonly %a12, ptr readonly %a13, ptr writeonly %a14, ptr %a15, ptr %a16, ptr %a17, ptr %a18, ptr %a19) local_unnamed_addr {
  %.273.i.i = alloca i8, align 1
  %.468.i.i.i.i = alloca ptr, align 8
  %.578.i2.i.i.i = alloca i8, align 1
  %.1003.i.i.i = alloca ptr, align 8
  %.2039.i.i = alloca i8, align 1
  %.4469.i.i = alloca i8, align 1
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
  %.933.i = add nsw i64 %.111.i, %.109.i
  %.973.i = getelementptr i8, ptr %a1, i64 72
  %.974.i = load i64, ptr %.973.i, align 8, !noalias !21
  %.1080.i = icmp slt i64 %.109.i, 0
  %.1081.i = select i1 %.1080.i, i64 %.933.i, i64 0
  %.1082.i = add i64 %.1081.i, %.109.i
  %.1085.i = icmp slt i64 %.1082.i, 0
  br i1 %.1085.i, label %B0.endif.endif.endif.endi...else.if.i, label %B0.endif.endif.endif.endi...else.endif.i, !prof !24
B1334.i:
  %lsr.iv443.i = phi ptr [ %scevgep444.i, %B1334.i ], [ %scevgep442.i, %B1334.lr.ph.new.i ]
  %lsr.iv439.i = phi ptr [ %scevgep440.i, %B1334.i ], [ %scevgep438.i, %B1334.lr.ph.new.i ]
  %.403030073009.i = phi i64 [ %.4037.1.i, %B1334.i ], [ 0, %B1334.lr.ph.new.i ]
  %scevgep441.i = getelementptr i8, ptr %lsr.iv439.i, i64 -8
  %.4091.i = load double, ptr %scevgep441.i, align 8, !noalias !21
  %scevgep445.i = getelementptr i8, ptr %lsr.iv443.i, i64 -8
  store double %.4091.i, ptr %scevgep445.i, align 8, !noalias !21
  %sunkaddr453.i = getelementptr i8, ptr %lsr.iv443.i, i64 %sunkaddr.i
  %sunkaddr454.i = getelementptr i8, ptr %sunkaddr453.i, i64 -8
  store double %.4091.i, ptr %sunkaddr454.i, align 8, !noalias !21
  %scevgep450.i = getelementptr i8, ptr %lsr.iv443.i, i64 %.idx.i
  %scevgep451.i = getelementptr i8, ptr %scevgep450.i, i64 -8
  store double 0.000000e+00, ptr %scevgep451.i, align 8, !noalias !21
  %.4037.1.i = add nuw i64 %.403030073009.i, 2
  %.4091.1.i = load double, ptr %lsr.iv439.i, align 8, !noalias !21
  store double %.4091.1.i, ptr %lsr.iv443.i, align 8, !noalias !21
  store double %.4091.1.i, ptr %sunkaddr453.i, align 8, !noalias !21
  store double 0.000000e+00, ptr %scevgep450.i, align 8, !noalias !21
  %scevgep440.i = getelementptr i8, ptr %lsr.iv439.i, i64 16
  %scevgep444.i = getelementptr i8, ptr %lsr.iv443.i, i64 16
  %niter.ncmp.1.i = icmp eq i64 %unroll_iter.i, %.4037.1.i
  br i1 %niter.ncmp.1.i, label %B1412.endif.loopexit.unr-lcssa.i, label %B1334.i
B1500.i:
  %h.3.03027.i = phi double [ 0.000000e+00, %B1500.lr.ph.i ], [ %h.4.12968.i, %B2078.i ]
  %.440530183025.i = phi i64 [ 0, %B1500.lr.ph.i ], [ %.4412.i, %B2078.i ]
  %.4412.i = add nuw nsw i64 %.440530183025.i, 1
  %1 = getelementptr double, ptr %a4, i64 %.440530183025.i
  %.4476.i = load double, ptr %1, align 8, !noalias !21
  %.4483.i = icmp slt i64 %.4412.i, %.33.i
  %2 = getelementptr double, ptr %a4, i64 %.4412.i
  %"$phi1578.1.2.1.in.i" = select i1 %.4483.i, ptr %2, ptr %.4551.i
  %"$phi1578.1.2.1.i" = load double, ptr %"$phi1578.1.2.1.in.i", align 8, !noalias !21
  br i1 %53, label %B1592.i, label %B1776.i
B1592.i:
  %.40.i.i = fsub double %.4476.i, %.4476.i
  br i1 %54, label %B1592.endif.i, label %B56.preheader.i.i
B56.preheader.i.i:
  %.4615.i = mul i64 %.440530183025.i, %.1274.i
  %.4617.i = getelementptr double, ptr %a5, i64 %.4615.i
  %scevgep.i.i = getelementptr i8, ptr %.4617.i, i64 40
  br label %B56.i.i
B56.i.i:
  %lsr.iv435.i = phi i64 [ %lsr.iv.next436.i, %B316.i.i ], [ %.1705.sroa.0.3.i, %B56.preheader.i.i ]
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
  %3 = shl i64 %lsr.iv435.i, 3
  %scevgep437.i = getelementptr i8, ptr %.1633.i, i64 %3
  store double %value.2.1.i.i, ptr %scevgep437.i, align 8, !noalias !25
  %scevgep1.i.i = getelementptr i8, ptr %lsr.iv.i.i, i64 48
  %lsr.iv.next436.i = add nuw i64 %lsr.iv435.i, 1
  %exitcond.not.i.i = icmp eq i64 %.1705.sroa.13.0.i, %lsr.iv.next436.i
  br i1 %exitcond.not.i.i, label %B1592.endif.i, label %B56.i.i
B1776.i:
  %4 = getelementptr i8, ptr %a6, i64 %.440530183025.i
  %.4988.i = load i8, ptr %4, align 1, !noalias !21
  %.4989.not.i = icmp eq i8 %.4988.i, 0
  %.4992.i = fneg double %h.3.03027.i
  %"$phi1800.1.2.1.i" = select i1 %.4989.not.i, double %h.3.03027.i, double %.4992.i
  %.5067.i = mul i64 %.440530183025.i, %.1274.i
  %.5069.i = getelementptr double, ptr %a5, i64 %.5067.i
  br i1 %55, label %B1814.i, label %B1980.i
B1814.i:
  call void @llvm.lifetime.start.p0(ptr nonnull %.2039.i.i), !noalias !21
  call void @llvm.lifetime.start.p0(ptr nonnull %.4469.i.i), !noalias !21
  store i8 0, ptr %.2039.i.i, align 1, !noalias !28
  store i8 0, ptr %.4469.i.i, align 1, !noalias !28
  br i1 %72, label %B0.endif.else.endif.endif.endif.i.i, label %B0.endif.else.endif.if.i.i, !prof !31
B422.i.i:
  %.2027.i.i = load i64, ptr %sunkaddr26.i.i, align 8, !noalias !28
  store i8 0, ptr %.2039.i.i, align 1, !noalias !28
  call fastcc void @v34(ptr nonnull %.2039.i.i, i64 %.2027.i.i, double %.4476.i, double %.4476.i, ptr readonly %.5069.i, ptr %a2, i64 %.1802.i, ptr %.1818.i, ptr %a3, i64 %.1167.i, ptr %.1183.i, ptr %.2332.i, i64 %.3521.i, ptr %.3537.i, ptr %.3708.i, ptr readonly %a13)
  br label %B506.endif.endif.i.i
B622.i.i:
  %.2501.i.i = fcmp olt double %.4476.i, %"$phi1578.1.2.1.i"
  br i1 %.2501.i.i, label %B636.preheader.i.i, label %_ZN6poppet6engine10integrator8_segmentB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
B636.preheader.i.i:
  %.5.i.i.i = fmul double %"$phi1578.1.2.1.i", 0x3D06849B86A12B9B
  %.6.i.i.i = fadd double %.5.i.i.i, 1.000000e-15
  %.4411.i.i = fsub double %"$phi1578.1.2.1.i", %.6.i.i.i
  %5 = fcmp ogt double %.1909.i.i, 0.000000e+00
  %invariant.gep.i.i3.i.i.i = getelementptr double, ptr %.1408.i.i, i64 %.1076.i.i
  %6 = icmp slt i64 %.1067.i.i, 1
  br label %B636.i.i
B636.i.i:
  %t.2.0.i.i = phi double [ %t.3.1.i.i, %B2370.else.if.i.i ], [ %.4476.i, %B636.preheader.i.i ]
  %h.6.0.i.i = phi double [ %h.7.1.i.i, %B2370.else.if.i.i ], [ %"$phi1800.1.2.1.i", %B636.preheader.i.i ]
  %error_before.2.0.i.i = phi double [ %error_before.3.1.i.i, %B2370.else.if.i.i ], [ 1.000000e-02, %B636.preheader.i.i ]
  %step_before.3.0.i.i = phi double [ %step_before.4.1.i.i, %B2370.else.if.i.i ], [ 0.000000e+00, %B636.preheader.i.i ]
  %rejected.3.0.i.i = phi i1 [ %rejected.4.1.i.i, %B2370.else.if.i.i ], [ false, %B636.preheader.i.i ]
  %fresh.3.0.i.i = phi i1 [ %fresh.4.1.i.i, %B2370.else.if.i.i ], [ true, %B636.preheader.i.i ]
  %window.2.0.i.i = phi double [ %window.3.1.i.i, %B2370.else.if.i.i ], [ %.4476.i, %B636.preheader.i.i ]
  %calm.2.0.i.i = phi double [ %calm.3.1.i.i, %B2370.else.if.i.i ], [ %.4476.i, %B636.preheader.i.i ]
  %first.3.0.i.i = phi double [ %first.4.1.i.i, %B2370.else.if.i.i ], [ 0.000000e+00, %B636.preheader.i.i ]
  %has_changed.3.0.i.i = phi i1 [ %has_changed.4.1.i.i, %B2370.else.if.i.i ], [ true, %B636.preheader.i.i ]
  %has_acted.5.0.i.i = phi i1 [ %has_acted.6.1.i.i, %B2370.else.if.i.i ], [ %.1974.i.i, %B636.preheader.i.i ]
  br i1 %fresh.3.0.i.i, label %B640.i.i, label %B734.i.i
B640.i.i:
  %.2553.i.i = load i64, ptr %a0, align 8, !noalias !28
  store double %t.2.0.i.i, ptr %.2332.i, align 8, !noalias !32
  %.40.i.i.i.i = fsub double %t.2.0.i.i, %.4476.i
  br i1 %54, label %B0.endif.i.i.i, label %B56.i.i.i.i
B56.i.i.i.i:
  %lsr.iv.i.i.i.i = phi ptr [ %scevgep1.i.i.i.i, %B316.i.i.i.i ], [ %scevgep.i167.i.i, %B640.i.i ]
  %.138222224.i.i.i.i = phi i64 [ %.145.i.i.i.i, %B316.i.i.i.i ], [ 0, %B640.i.i ]
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
  %scevgep7.i.i.i.i = getelementptr i8, ptr %.1818.i, i64 %7
  store double %value.2.1.i.i.i.i, ptr %scevgep7.i.i.i.i, align 8, !noalias !35
  %scevgep1.i.i.i.i = getelementptr i8, ptr %lsr.iv.i.i.i.i, i64 48
  %exitcond.not.i.i.i.i = icmp eq i64 %.1793.i, %.145.i.i.i.i
  br i1 %exitcond.not.i.i.i.i, label %B0.endif.i.i.i, label %B56.i.i.i.i
B148.i.i.i:
  %.356.i.i.i = fsub double %"$phi1578.1.2.1.i", %t.2.0.i.i
  %.56.i.i.i.i = fdiv double 2.000000e+01, %.356.i.i.i
  br i1 %77, label %B148.endif.i.i.i, label %B66.backedge.i.i.i.i
B66.backedge.i.i.i.i:
  %fastest.2.0128.i.i.i.i = phi double [ %.13.i.i.i.i.i, %B66.backedge.i.i.i.i ], [ %.56.i.i.i.i, %B148.i.i.i ]
  %.162124126.i.i.i.i = phi i64 [ %.169.i.i.i.i, %B66.backedge.i.i.i.i ], [ 0, %B148.i.i.i ]
  %8 = shl i64 %.162124126.i.i.i.i, 3
  %scevgep3.i1.i.i.i = getelementptr i8, ptr %.1461.i, i64 %8
  %.223.i.i.i.i = load double, ptr %scevgep3.i1.i.i.i, align 8, !noalias !38
  %.224.i.i.i.i = tail call double @llvm.fabs.f64(double %.223.i.i.i.i)
  %.225.i.i.i.i = fmul double %.224.i.i.i.i, 2.000000e+01
  %scevgep2.i2.i.i.i = getelementptr i8, ptr %a2, i64 %8
  %.255.i.i.i.i = load double, ptr %scevgep2.i2.i.i.i, align 8, !noalias !38
  %.256.i.i.i.i = tail call double @llvm.fabs.f64(double %.255.i.i.i.i)
  %scevgep228.i.i = getelementptr i8, ptr %74, i64 %8
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
  br label %B734.i.i
B0.endif.i.i.i:
  br i1 %76, label %B0.endif.endif.i.i.i, label %B56.i8.i.i.i
B56.i8.i.i.i:
  %lsr.iv.i9.i.i.i = phi ptr [ %scevgep1.i15.i.i.i, %B370.i.i.i.i ], [ %scevgep.i167.i.i, %B0.endif.i.i.i ]
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
  %scevgep6.i14.i.i.i = getelementptr i8, ptr %.2161.i, i64 %9
  store double %slope.2.1.i.i.i.i, ptr %scevgep6.i14.i.i.i, align 8, !noalias !41
  %scevgep1.i15.i.i.i = getelementptr i8, ptr %lsr.iv.i9.i.i.i, i64 48
  %exitcond.not.i16.i.i.i = icmp eq i64 %.2136.i, %.145.i10.i.i.i
  br i1 %exitcond.not.i16.i.i.i, label %B0.endif.endif.i.i.i, label %B56.i8.i.i.i
B0.endif.endif.i.i.i:
  %.304.i.i.i = inttoptr i64 %.2553.i.i to ptr
  tail call void %.304.i.i.i(ptr nonnull %.2332.i, ptr %a2, ptr %.1818.i, ptr %.2161.i, ptr %a3, ptr %.1461.i, ptr %.2814.i, ptr %.748.i.i), !noalias !32
  %.325.i.i.i = fcmp ogt double %h.6.0.i.i, 0.000000e+00
  br i1 %.325.i.i.i, label %B734.i.i, label %B148.i.i.i
B148.endif.i.i.i:
  %fastest.2.0.lcssa.i.i.i.i = phi double [ %.56.i.i.i.i, %B148.i.i.i ], [ %.13.i.i.i.i.i, %B66.backedge.i.i.i.i ]
  %.373.i.i.i.i = fdiv double 1.000000e+00, %fastest.2.0.lcssa.i.i.i.i
  %.417.i.i.i = fcmp olt double %h.6.0.i.i, 0.000000e+00
  br i1 %.417.i.i.i, label %B202.i.i.i, label %B734.i.i
B734.i.i:
  %h.9.1.i.i = phi double [ %h.6.0.i.i, %B636.i.i ], [ %.13.i.i.i.i, %B202.i.i.i ], [ %.373.i.i.i.i, %B148.endif.i.i.i ], [ %h.6.0.i.i, %B0.endif.endif.i.i.i ]
  %.2655.i.i = load double, ptr %a10, align 8, !noalias !28
  %.12.i.i3.i.i = fcmp olt double %.2655.i.i, %h.9.1.i.i
  %.13.i.i4.i.i = select i1 %.12.i.i3.i.i, double %.2655.i.i, double %h.9.1.i.i
  br i1 %.not.i.i, label %_ZN6poppet6engine10integrator6_reachB3v20B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdddddb5ArrayIdLi1E1C7mutable7alignedEx.exit.i.i, label %B58.backedge.preheader.i.i.i.i
B58.backedge.preheader.i.i.i.i:
  br i1 %64, label %B58.backedge.epil.preheader.i.i.i.i, label %B58.backedge.i.i.i.i
B58.backedge.i.i.i.i:
  %first.2.065.i.i.i.i = phi double [ %.13.i.3.i.i.i.i, %B58.backedge.i.i.i.i ], [ 0x7FF0000000000000, %B58.backedge.preheader.i.i.i.i ]
  %.1096163.i.i.i.i = phi i64 [ %.116.3.i.i.i.i, %B58.backedge.i.i.i.i ], [ 0, %B58.backedge.preheader.i.i.i.i ]
  %sunkaddr.i.i.i = shl i64 %.1096163.i.i.i.i, 3
  %sunkaddr10.i.i.i = getelementptr i8, ptr %.1183.i, i64 %sunkaddr.i.i.i
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
  br i1 %65, label %B52.endif.endif.i.i.i, label %B58.backedge.epil.preheader.i.i.i.i
B58.backedge.epil.preheader.i.i.i.i:
  %first.2.065.epil.init.i.i.i.i = phi double [ 0x7FF0000000000000, %B58.backedge.preheader.i.i.i.i ], [ %.13.i.3.i.i.i.i, %common.ret.loopexit.unr-lcssa.i.i.i.i ]
  %.1096163.epil.init.i.i.i.i = phi i64 [ 0, %B58.backedge.preheader.i.i.i.i ], [ %unroll_iter.i.i.i, %common.ret.loopexit.unr-lcssa.i.i.i.i ]
  %10 = shl i64 %.1096163.epil.init.i.i.i.i, 3
  %scevgep.i.i.i.i = getelementptr i8, ptr %.1183.i, i64 %10
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
  %.159.i.i.i = fcmp uge double %first.2.0.lcssa.i.i.i.i, %.4411.i.i
  %12 = or i1 %53, %.159.i.i.i
  %brmerge68.i.i = select i1 %12, i1 true, i1 %.1945.i.i
  %arg.stop.mux.i.i = select i1 %.159.i.i.i, double %"$phi1578.1.2.1.i", double %first.2.0.lcssa.i.i.i.i
  br i1 %brmerge68.i.i, label %_ZN6poppet6engine10integrator6_reachB3v20B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdddddb5ArrayIdLi1E1C7mutable7alignedEx.exit.i.i, label %B152.i.i.i
_ZN6poppet6engine10integrator6_reachB3v20B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdddddb5ArrayIdLi1E1C7mutable7alignedEx.exit.i.i:
  %wanted.2.0.sink.i.i.i = phi double [ %.13.i2.i10.i.i, %B184.i8.i.i ], [ %.13.i.i4.i.i, %B152.i.i.i ], [ %.13.i.i4.i.i, %B734.i.i ], [ %.13.i.i4.i.i, %B52.endif.endif.i.i.i ]
  %arg.stop.sink.i.i.i = phi double [ %"$phi1578.1.2.1.i", %B184.i8.i.i ], [ %first.2.0.lcssa.i.i.i.i, %B152.i.i.i ], [ %"$phi1578.1.2.1.i", %B734.i.i ], [ %arg.stop.mux.i.i, %B52.endif.endif.i.i.i ]
  br i1 %5, label %B810.i.i, label %B838.i.i
B810.i.i:
  %.2743.i.i = load i64, ptr %a17, align 8, !noalias !28
  %.2757.i.i = icmp slt i64 %.2743.i.i, 0
  %.2758.i.i = select i1 %.2757.i.i, i64 %.974.i, i64 0
  %13 = getelementptr double, ptr %a19, i64 %.2743.i.i
  %.2772.i.i = getelementptr double, ptr %13, i64 %.2758.i.i
  %"$phi884.0.2.1.in.sroa.speculate.load.B810.i.i" = load double, ptr %.2772.i.i, align 8, !noalias !28
  br label %B884.i.i
B838.i.i:
  %.2780.i.i = fsub double %arg.stop.sink.i.i.i, %t.2.0.i.i
  %.11.i.i.i = fmul double %.2780.i.i, 5.000000e-01
  %.13.i.i.i = fcmp olt double %wanted.2.0.sink.i.i.i, %.11.i.i.i
  %.24.i.i.i = fcmp olt double %wanted.2.0.sink.i.i.i, %.2780.i.i
  %"$phi50.0.2.0.i.i.i" = select i1 %.24.i.i.i, double %.11.i.i.i, double %.2780.i.i
  %storemerge.i145.i.i = select i1 %.13.i.i.i, double %wanted.2.0.sink.i.i.i, double %"$phi50.0.2.0.i.i.i"
  br label %B884.i.i
B884.i.i:
  %"$phi884.0.2.1.in.sroa.speculated.i.i" = phi double [ %"$phi884.0.2.1.in.sroa.speculate.load.B810.i.i", %B810.i.i ], [ %storemerge.i145.i.i, %B838.i.i ]
  br i1 %exitcond.not.i164.i.i, label %B1044.i.i, label %switch.lookup.i.i
B1044.i.i:
  %.3202.i.i = fsub double %arg.stop.sink.i.i.i, %t.2.0.i.i
  %.3203.i.i = fmul double %.3202.i.i, 0x3FEFFFFFFFFFDCD1
  %.3205.i.i = fcmp oge double %"$phi884.0.2.1.in.sroa.speculated.i.i", %.3203.i.i
  %.3218.i.i = fadd double %t.2.0.i.i, %"$phi884.0.2.1.in.sroa.speculated.i.i"
  %"$phi1080.0.2.1.i.i" = select i1 %.3205.i.i, double %arg.stop.sink.i.i.i, double %.3218.i.i
  store double %t.2.0.i.i, ptr %.2332.i, align 8, !noalias !28
  store double %"$phi884.0.2.1.in.sroa.speculated.i.i", ptr %sunkaddr.i2.i, align 8, !noalias !28
  %.3319.i.i = load i64, ptr %sunkaddr234.i.i, align 8, !noalias !28
  %.3390.i.i = inttoptr i64 %.3319.i.i to ptr
  tail call void %.3390.i.i(ptr nonnull %.2332.i, ptr %a2, ptr %.1989.i, ptr %a3, ptr %.1461.i, ptr %.2814.i, ptr %.748.i.i, ptr %.3182.i, ptr %.1579.i.i, ptr %.920.i.i), !noalias !28
  br i1 %77, label %B1080.endif.thread229.i.i, label %B62.i.i.i
B1080.endif.thread229.i.i:
  %.3465231.i.i = load i64, ptr %sunkaddr246.i.i, align 8, !noalias !28
  %.3466232.i.i = add nsw i64 %.3465231.i.i, 1
  store i64 %.3466232.i.i, ptr %sunkaddr246.i.i, align 8, !noalias !28
  br label %B1326.i.i
B62.i.i.i:
  %worst.2.0263.i.i.i = phi double [ %worst.3.1.i.i.i, %B176.endif.i.i.i ], [ 0.000000e+00, %B1044.i.i ]
  %.185258261.i.i.i = phi i64 [ %.192.i.i.i, %B176.endif.i.i.i ], [ 0, %B1044.i.i ]
  %.192.i.i.i = add nuw nsw i64 %.185258261.i.i.i, 1
  %14 = shl i64 %.185258261.i.i.i, 3
  %scevgep5.i.i.i = getelementptr i8, ptr %.920.i.i, i64 %14
  %.250.i.i.i = load double, ptr %scevgep5.i.i.i, align 8, !noalias !50
  %.262.le.i.i.i = fsub double %.250.i.i.i, %.250.i.i.i
  %.263.le.i.i.i = fcmp ord double %.262.le.i.i.i, 0.000000e+00
  br i1 %.263.le.i.i.i, label %B120.i.i.i, label %B1080.endif.thread.i.i
B120.i.i.i:
  %15 = getelementptr i8, ptr %a9, i64 %.185258261.i.i.i
  %.308.i.i.i = load i8, ptr %15, align 1, !noalias !50
  %.309.i.i.i = icmp ne i8 %.308.i.i.i, 0
  %.312.i.i.i = fcmp ole double %.250.i.i.i, 0.000000e+00
  %or.cond.i.i.i = and i1 %.312.i.i.i, %.309.i.i.i
  br i1 %or.cond.i.i.i, label %B1080.endif.thread.i.i, label %B176.endif.i.i.i
B176.endif.i.i.i:
  %scevgep232.i.i = getelementptr i8, ptr %.1750.i.i, i64 %14
  %.385.i.i.i = load double, ptr %scevgep232.i.i, align 8, !noalias !50
  %scevgep231.i.i = getelementptr i8, ptr %scevgep230.i.i, i64 %14
  %.441.i.i.i = load double, ptr %scevgep231.i.i, align 8, !noalias !50
  %scevgep229.i.i = getelementptr i8, ptr %a8, i64 %14
  %.496.i.i.i = load double, ptr %scevgep229.i.i, align 8, !noalias !50
  %scevgep.i3.i = getelementptr i8, ptr %a2, i64 %14
  %.527.i.i.i = load double, ptr %scevgep.i3.i, align 8, !noalias !50
  %.530.i.i.i = tail call double @llvm.fabs.f64(double %.527.i.i.i)
  %.532.i.i.i = tail call double @llvm.fabs.f64(double %.250.i.i.i)
  %.12.i.i149.i.i = fcmp ogt double %.532.i.i.i, %.530.i.i.i
  %.13.i.i150.i.i = select i1 %.12.i.i149.i.i, double %.532.i.i.i, double %.530.i.i.i
  %.386.i.i.i = tail call double @llvm.fabs.f64(double %.385.i.i.i)
  %.563.i.i.i = fmul double %.496.i.i.i, %.13.i.i150.i.i
  %.564.i.i.i = fadd double %.441.i.i.i, %.563.i.i.i
  %.568.i.i.i = fdiv double %.386.i.i.i, %.564.i.i.i
  %.574.i.i.i = fcmp ole double %.568.i.i.i, %worst.2.0263.i.i.i
  %worst.3.1.i.i.i = select i1 %.574.i.i.i, double %worst.2.0263.i.i.i, double %.568.i.i.i
  %exitcond.not.i.i.i = icmp eq i64 %.27.i, %.192.i.i.i
  br i1 %exitcond.not.i.i.i, label %B1080.endif.i.i, label %B62.i.i.i
B1278.i.i:
  %storemerge.i147227.i.i = phi double [ 0x7FF0000000000000, %B1080.endif.thread.i.i ], [ %worst.3.1.i.i.i, %B1080.endif.i.i ]
  %.3510.le.i.i = fsub double %storemerge.i147227.i.i, %storemerge.i147227.i.i
  %.3511.le.i.i = fcmp ord double %.3510.le.i.i, 0.000000e+00
  %or.cond3347.i.i = select i1 %5, i1 %.3511.le.i.i, i1 false
  br i1 %or.cond3347.i.i, label %B1386.i.i, label %for.end.1.i.i
B1326.i.i:
  %storemerge.i147234.i.i = phi double [ 0.000000e+00, %B1080.endif.thread229.i.i ], [ %worst.3.1.i.i.i, %B1080.endif.i.i ]
  %.3557.i.i = load i64, ptr %a17, align 8, !noalias !28
  %.3565.i.i = icmp sge i64 %.3557.i.i, %.974.i
  %brmerge.i.i = or i1 %5, %.3565.i.i
  br i1 %brmerge.i.i, label %B1386.i.i, label %B1364.i.i
B1364.i.i:
  %.3613.i.i = icmp slt i64 %.3557.i.i, 0
  %.3614.i.i = select i1 %.3613.i.i, i64 %.974.i, i64 0
  %16 = getelementptr double, ptr %a19, i64 %.3557.i.i
  %.3628.i.i = getelementptr double, ptr %16, i64 %.3614.i.i
  store double %"$phi884.0.2.1.in.sroa.speculated.i.i", ptr %.3628.i.i, align 8, !noalias !28
  br label %B1386.i.i
B1386.i.i:
  %storemerge.i147228.i.i = phi double [ %storemerge.i147227.i.i, %B1278.i.i ], [ %storemerge.i147234.i.i, %B1326.i.i ], [ %storemerge.i147234.i.i, %B1364.i.i ]
  call void @llvm.lifetime.start.p0(ptr nonnull %.1003.i.i.i), !noalias !28
  br i1 %.not.i.i, label %B126.i.i.i, label %B58.backedge.preheader.i.i11.i.i
B58.backedge.preheader.i.i11.i.i:
  br i1 %64, label %B58.backedge.epil.preheader.i.i38.i.i, label %B58.backedge.i.i15.i.i
B58.backedge.i.i15.i.i:
  %first.2.065.i.i16.i.i = phi double [ %.13.i.3.i.i33.i.i, %B58.backedge.i.i15.i.i ], [ 0x7FF0000000000000, %B58.backedge.preheader.i.i11.i.i ]
  %.1096163.i.i17.i.i = phi i64 [ %.116.3.i.i34.i.i, %B58.backedge.i.i15.i.i ], [ 0, %B58.backedge.preheader.i.i11.i.i ]
  %sunkaddr.i18.i.i = shl i64 %.1096163.i.i17.i.i, 3
  %sunkaddr13.i19.i.i = getelementptr i8, ptr %.1183.i, i64 %sunkaddr.i18.i.i
  %.170.i.i20.i.i = load double, ptr %sunkaddr13.i19.i.i, align 8, !noalias !53
  %.12.i.i.i21.i.i = fcmp olt double %.170.i.i20.i.i, %first.2.065.i.i16.i.i
  %.13.i.i.i22.i.i = select i1 %.12.i.i.i21.i.i, double %.170.i.i20.i.i, double %first.2.065.i.i16.i.i
  %sunkaddr16.i23.i.i = getelementptr i8, ptr %sunkaddr13.i19.i.i, i64 8
  %.170.1.i.i24.i.i = load double, ptr %sunkaddr16.i23.i.i, align 8, !noalias !53
  %.12.i.1.i.i25.i.i = fcmp olt double %.170.1.i.i24.i.i, %.13.i.i.i22.i.i
  %.13.i.1.i.i26.i.i = select i1 %.12.i.1.i.i25.i.i, double %.170.1.i.i24.i.i, double %.13.i.i.i22.i.i
  %sunkaddr19.i27.i.i = getelementptr i8, ptr %sunkaddr13.i19.i.i, i64 16
  %.170.2.i.i28.i.i = load double, ptr %sunkaddr19.i27.i.i, align 8, !noalias !53
  %.12.i.2.i.i29.i.i = fcmp olt double %.170.2.i.i28.i.i, %.13.i.1.i.i26.i.i
  %.13.i.2.i.i30.i.i = select i1 %.12.i.2.i.i29.i.i, double %.170.2.i.i28.i.i, double %.13.i.1.i.i26.i.i
  %sunkaddr22.i.i.i = getelementptr i8, ptr %sunkaddr13.i19.i.i, i64 24
  %.170.3.i.i31.i.i = load double, ptr %sunkaddr22.i.i.i, align 8, !noalias !53
  %.12.i.3.i.i32.i.i = fcmp olt double %.170.3.i.i31.i.i, %.13.i.2.i.i30.i.i
  %.13.i.3.i.i33.i.i = select i1 %.12.i.3.i.i32.i.i, double %.170.3.i.i31.i.i, double %.13.i.2.i.i30.i.i
  %.116.3.i.i34.i.i = add nuw nsw i64 %.1096163.i.i17.i.i, 4
  %niter.ncmp.3.i.i35.i.i = icmp eq i64 %unroll_iter.i.i.i, %.116.3.i.i34.i.i
  br i1 %niter.ncmp.3.i.i35.i.i, label %common.ret.loopexit.unr-lcssa.i.i36.i.i, label %B58.backedge.i.i15.i.i
common.ret.loopexit.unr-lcssa.i.i36.i.i:
  br i1 %65, label %B26.endif.endif.i.i.i, label %B58.backedge.epil.preheader.i.i38.i.i
B58.backedge.epil.preheader.i.i38.i.i:
  %first.2.065.epil.init.i.i39.i.i = phi double [ 0x7FF0000000000000, %B58.backedge.preheader.i.i11.i.i ], [ %.13.i.3.i.i33.i.i, %common.ret.loopexit.unr-lcssa.i.i36.i.i ]
  %.1096163.epil.init.i.i40.i.i = phi i64 [ 0, %B58.backedge.preheader.i.i11.i.i ], [ %unroll_iter.i.i.i, %common.ret.loopexit.unr-lcssa.i.i36.i.i ]
  %17 = shl i64 %.1096163.epil.init.i.i40.i.i, 3
  %scevgep.i.i41.i.i = getelementptr i8, ptr %.1183.i, i64 %17
  br label %B58.backedge.epil.i.i42.i.i
B58.backedge.epil.i.i42.i.i:
  %first.2.065.epil.i.i43.i.i = phi double [ %.13.i.epil.i.i47.i.i, %B58.backedge.epil.i.i42.i.i ], [ %first.2.065.epil.init.i.i39.i.i, %B58.backedge.epil.preheader.i.i38.i.i ]
  %epil.iter.i.i44.i.i = phi i64 [ %epil.iter.next.i.i48.i.i, %B58.backedge.epil.i.i42.i.i ], [ 0, %B58.backedge.epil.preheader.i.i38.i.i ]
  %18 = shl i64 %epil.iter.i.i44.i.i, 3
  %scevgep7.i.i.i = getelementptr i8, ptr %scevgep.i.i41.i.i, i64 %18
  %.170.epil.i.i45.i.i = load double, ptr %scevgep7.i.i.i, align 8, !noalias !53
  %.12.i.epil.i.i46.i.i = fcmp olt double %.170.epil.i.i45.i.i, %first.2.065.epil.i.i43.i.i
  %.13.i.epil.i.i47.i.i = select i1 %.12.i.epil.i.i46.i.i, double %.170.epil.i.i45.i.i, double %first.2.065.epil.i.i43.i.i
  %epil.iter.next.i.i48.i.i = add i64 %epil.iter.i.i44.i.i, 1
  %epil.iter.cmp.not.i.i49.i.i = icmp eq i64 %xtraiter.i.i.i, %epil.iter.next.i.i48.i.i
  br i1 %epil.iter.cmp.not.i.i49.i.i, label %B26.endif.endif.i.i.i, label %B58.backedge.epil.i.i42.i.i, !llvm.loop !58
B126.i.i.i:
  %"$phi126.0.2.0.i.i.i" = phi i1 [ %.423.i.i.i, %B26.endif.endif.i.i.i ], [ false, %B1386.i.i ]
  %.478.i.i.i = load i64, ptr %sunkaddr459.i, align 8, !noalias !59
  %brmerge.i53.i.i = select i1 %53, i1 true, i1 %"$phi126.0.2.0.i.i.i"
  br i1 %brmerge.i53.i.i, label %B302.i.i.i, label %B200.i.i.i
B200.i.i.i:
  %.522.i54.i.i = load i64, ptr %sunkaddr37.i.i, align 8, !noalias !59
  %.536.i.i.i = icmp slt i64 %.522.i54.i.i, 0
  %.537.i.i.i = select i1 %.536.i.i.i, i64 %.71.i, i64 0
  %19 = getelementptr double, ptr %a7, i64 %.522.i54.i.i
  %.551.i.i.i = getelementptr double, ptr %19, i64 %.537.i.i.i
  %.552.i.i.i = load double, ptr %.551.i.i.i, align 8, !noalias !59
  %.554.i.i.i = fcmp olt double %.552.i.i.i, %"$phi1080.0.2.1.i.i"
  br i1 %.554.i.i.i, label %B302.i.i.i, label %B426.i.i.i
B302.i.i.i:
  %.585.i.i.i = load i64, ptr %.584.i.i.i, align 8, !noalias !59
  %.600.i.i.i = inttoptr i64 %.585.i.i.i to ptr
  tail call void %.600.i.i.i(ptr %.1579.i.i, ptr %.1408.i.i), !noalias !59
  br i1 %53, label %B306.i.i.i, label %B426.i.i.i
B306.i.i.i:
  %.556.i.i.i.i = fmul double %.3218.i.i, 4.000000e-16
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
  %.227.i.i.i.i.i = load double, ptr %scevgep4.i.i.i.i.i, align 8, !noalias !60
  %.229.i.i.i.i.i = fmul double %.64.i.i.i.i.i, %.227.i.i.i.i.i
  %scevgep3.i.i.i.i.i = getelementptr i8, ptr %.920.i.i, i64 %21
  %.259.i.i.i.i.i = load double, ptr %scevgep3.i.i.i.i.i, align 8, !noalias !60
  %scevgep70.i.i.i.i = getelementptr i8, ptr %.1408.i.i, i64 %21
  %.289.i.i.i.i.i = load double, ptr %scevgep70.i.i.i.i, align 8, !noalias !60
  %scevgep69.i.i.i.i = getelementptr i8, ptr %invariant.gep.i.i3.i.i.i, i64 %21
  %.321.i.i.i.i.i = load double, ptr %scevgep69.i.i.i.i, align 8, !noalias !60
  %.323.i.i.i.i.i = fmul double %high.3.1.i.i.i.i, %.321.i.i.i.i.i
  %.324.i.i.i.i.i = fadd double %.289.i.i.i.i.i, %.323.i.i.i.i.i
  %.326.i.i.i.i.i = fmul double %.64.i.i.i.i.i, %.324.i.i.i.i.i
  %.327.i.i.i.i.i = fadd double %.259.i.i.i.i.i, %.326.i.i.i.i.i
  %.329.i.i.i.i.i = fmul double %high.3.1.i.i.i.i, %.327.i.i.i.i.i
  %.330.i.i.i.i.i = fadd double %.229.i.i.i.i.i, %.329.i.i.i.i.i
  %scevgep68.i.i.i.i = getelementptr i8, ptr %.1092.i.i, i64 %21
  store double %.330.i.i.i.i.i, ptr %scevgep68.i.i.i.i, align 8, !noalias !60
  %exitcond.not.i.i.i.i.i = icmp eq i64 %.1067.i.i, %.173.i.i.i.i.i
  br i1 %exitcond.not.i.i.i.i.i, label %B18.endif.i.i.i.i, label %B60.i.i.i.i.i
B186.i.i.i.i:
  %.381.i.i.i.i = fcmp oeq double %high.3.1.i.i.i.i, 1.000000e+00
  br i1 %.381.i.i.i.i, label %_ZN6poppet6engine8stepping11stop_insideB3v24B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE.exit.i.i.i, label %B18.i.i.i.i
B240.i.i.i.i:
  %low.3.2.i.i.i.i = phi double [ %low.4.1.i.i.i.i, %B252.1.i.i.i.i.i ], [ %high.3.1.i.i.i.i, %B18.endif.endif.endif.thread13.i.i.i.i ]
  %theta.1.2.i.i.i.i = phi double [ %high.3.1.i.i.i.i, %B252.1.i.i.i.i.i ], [ %theta.2.1.ph.i.i.i.i, %B18.endif.endif.endif.thread13.i.i.i.i ]
  %event.4.2.i.i.i.i = phi i64 [ %.284326331.i.i.i.i.i, %B252.1.i.i.i.i.i ], [ %event.2.1.i.i.i.i, %B18.endif.endif.endif.thread13.i.i.i.i ]
  %.543.i.i.i.i = fadd double %low.3.2.i.i.i.i, %theta.1.2.i.i.i.i
  %.544.i.i.i.i = fmul double %.543.i.i.i.i, 5.000000e-01
  %.550.i.i.i.i = fsub double %theta.1.2.i.i.i.i, %low.3.2.i.i.i.i
  %.552.i.i.i.i = fmul double %"$phi884.0.2.1.in.sroa.speculated.i.i", %.550.i.i.i.i
  %.557.i.i.i.i = fcmp ole double %.552.i.i.i.i, %.556.i.i.i.i
  %.561.i.i.i.i = fcmp ole double %.544.i.i.i.i, %low.3.2.i.i.i.i
  %or.cond.i.i.i.i = or i1 %.557.i.i.i.i, %.561.i.i.i.i
  %.565.i.i.i.i = fcmp oge double %.544.i.i.i.i, %theta.1.2.i.i.i.i
  %or.cond319.i.i.i.i = or i1 %.565.i.i.i.i, %or.cond.i.i.i.i
  br i1 %or.cond319.i.i.i.i, label %B316.i.i65.i.i, label %B18.outer.i.i.i.i
B316.i.i65.i.i:
  %.64.i18.i.i.i.i = fsub double 1.000000e+00, %theta.1.2.i.i.i.i
  br i1 %6, label %_ZN6poppet6engine8stepping11stop_insideB3v24B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE.exit.i.i.i, label %B60.i22.i.i.i.i
B60.i22.i.i.i.i:
  %.166146148.i23.i.i.i.i = phi i64 [ %.173.i24.i.i.i.i, %B60.i22.i.i.i.i ], [ 0, %B316.i.i65.i.i ]
  %.173.i24.i.i.i.i = add nuw nsw i64 %.166146148.i23.i.i.i.i, 1
  %22 = shl i64 %.166146148.i23.i.i.i.i, 3
  %scevgep4.i25.i.i.i.i = getelementptr i8, ptr %a2, i64 %22
  %.227.i26.i.i.i.i = load double, ptr %scevgep4.i25.i.i.i.i, align 8, !noalias !65
  %.229.i27.i.i.i.i = fmul double %.64.i18.i.i.i.i, %.227.i26.i.i.i.i
  %scevgep3.i28.i.i.i.i = getelementptr i8, ptr %.920.i.i, i64 %22
  %.259.i29.i.i.i.i = load double, ptr %scevgep3.i28.i.i.i.i, align 8, !noalias !65
  %scevgep67.i.i.i.i = getelementptr i8, ptr %.1408.i.i, i64 %22
  %.289.i31.i.i.i.i = load double, ptr %scevgep67.i.i.i.i, align 8, !noalias !65
  %scevgep66.i.i.i.i = getelementptr i8, ptr %invariant.gep.i.i3.i.i.i, i64 %22
  %.321.i33.i.i.i.i = load double, ptr %scevgep66.i.i.i.i, align 8, !noalias !65
  %.323.i34.i.i.i.i = fmul double %theta.1.2.i.i.i.i, %.321.i33.i.i.i.i
  %.324.i35.i.i.i.i = fadd double %.289.i31.i.i.i.i, %.323.i34.i.i.i.i
  %.326.i36.i.i.i.i = fmul double %.64.i18.i.i.i.i, %.324.i35.i.i.i.i
  %.327.i37.i.i.i.i = fadd double %.259.i29.i.i.i.i, %.326.i36.i.i.i.i
  %.329.i38.i.i.i.i = fmul double %theta.1.2.i.i.i.i, %.327.i37.i.i.i.i
  %.330.i39.i.i.i.i = fadd double %.229.i27.i.i.i.i, %.329.i38.i.i.i.i
  %scevgep.i1.i.i.i = getelementptr i8, ptr %.1092.i.i, i64 %22
  store double %.330.i39.i.i.i.i, ptr %scevgep.i1.i.i.i, align 8, !noalias !65
  %exitcond.not.i41.i.i.i.i = icmp eq i64 %.1067.i.i, %.173.i24.i.i.i.i
  br i1 %exitcond.not.i41.i.i.i.i, label %_ZN6poppet6engine8stepping11stop_insideB3v24B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE.exit.i.i.i, label %B60.i22.i.i.i.i
B18.endif.i.i.i.i:
  %.275.i.i.i.i = fmul double %"$phi884.0.2.1.in.sroa.speculated.i.i", %high.3.1.i.i.i.i
  %.277.i.i.i.i = fadd double %t.2.0.i.i, %.275.i.i.i.i
  %.40.i.i.i.i.i = fsub double %.277.i.i.i.i, %.4476.i
  br i1 %54, label %B18.endif.endif.i.i.i.i, label %B56.i.i.i.i.i
B56.i.i.i.i.i:
  %lsr.iv.i.i.i.i.i = phi ptr [ %scevgep1.i46.i.i.i.i, %B316.i.i.i.i.i ], [ %scevgep.i167.i.i, %B18.endif.i.i.i.i ]
  %.138222224.i.i.i.i.i = phi i64 [ %.145.i.i.i.i.i, %B316.i.i.i.i.i ], [ 0, %B18.endif.i.i.i.i ]
  %.145.i.i.i.i.i = add nuw nsw i64 %.138222224.i.i.i.i.i, 1
  %scevgep6.i.i.i.i.i = getelementptr i8, ptr %lsr.iv.i.i.i.i.i, i64 -40
  %.227.i44.i.i.i.i = load double, ptr %scevgep6.i.i.i.i.i, align 8, !noalias !68
  %scevgep5.i.i.i.i.i = getelementptr i8, ptr %lsr.iv.i.i.i.i.i, i64 -32
  %.282.i.i.i.i.i = load double, ptr %scevgep5.i.i.i.i.i, align 8, !noalias !68
  %.284.i.i.i.i.i = fmul double %.40.i.i.i.i.i, %.282.i.i.i.i.i
  %.285.i.i.i.i.i = fadd double %.227.i44.i.i.i.i, %.284.i.i.i.i.i
  %scevgep4.i45.i.i.i.i = getelementptr i8, ptr %lsr.iv.i.i.i.i.i, i64 -24
  %.347.i.i.i.i.i = load double, ptr %scevgep4.i45.i.i.i.i, align 8, !noalias !68
  %.348.i.i.i.i.i = fcmp une double %.347.i.i.i.i.i, 0.000000e+00
  br i1 %.348.i.i.i.i.i, label %B134.i.i.i.i.i, label %B316.i.i.i.i.i
B134.i.i.i.i.i:
  %scevgep3.i48.i.i.i.i = getelementptr i8, ptr %lsr.iv.i.i.i.i.i, i64 -16
  %.405.i.i.i.i.i = load double, ptr %scevgep3.i48.i.i.i.i, align 8, !noalias !68
  %scevgep2.i49.i.i.i.i = getelementptr i8, ptr %lsr.iv.i.i.i.i.i, i64 -8
  %.460.i.i.i.i.i = load double, ptr %scevgep2.i49.i.i.i.i, align 8, !noalias !68
  %.461.i.i.i.i.i = fmul double %.460.i.i.i.i.i, 5.000000e-01
  %.463.i.i.i.i.i = fmul double %.40.i.i.i.i.i, %.461.i.i.i.i.i
  %.464.i.i.i.i.i = fadd double %.405.i.i.i.i.i, %.463.i.i.i.i.i
  %.465.i.i.i.i.i = fmul double %.464.i.i.i.i.i, 0x401921FB54442D18
  %.467.i.i.i.i.i = fmul double %.40.i.i.i.i.i, %.465.i.i.i.i.i
  %.522.i.i.i.i.i = load double, ptr %lsr.iv.i.i.i.i.i, align 8, !noalias !68
  %.523.i.i.i.i.i = fadd double %.522.i.i.i.i.i, %.467.i.i.i.i.i
  %.586.le.i.i.i.i.i = tail call double @llvm.sin.f64(double %.523.i.i.i.i.i)
  %.591.i.i.i.i.i = fmul double %.347.i.i.i.i.i, %.586.le.i.i.i.i.i
  %.593.i.i.i.i.i = fadd double %.285.i.i.i.i.i, %.591.i.i.i.i.i
  br label %B316.i.i.i.i.i
B316.i.i.i.i.i:
  %value.2.1.i.i.i.i.i = phi double [ %.593.i.i.i.i.i, %B134.i.i.i.i.i ], [ %.285.i.i.i.i.i, %B56.i.i.i.i.i ]
  %23 = shl i64 %.138222224.i.i.i.i.i, 3
  %scevgep7.i.i.i.i.i = getelementptr i8, ptr %.1818.i, i64 %23
  store double %value.2.1.i.i.i.i.i, ptr %scevgep7.i.i.i.i.i, align 8, !noalias !68
  %scevgep1.i46.i.i.i.i = getelementptr i8, ptr %lsr.iv.i.i.i.i.i, i64 48
  %exitcond.not.i47.i.i.i.i = icmp eq i64 %.1793.i, %.145.i.i.i.i.i
  br i1 %exitcond.not.i47.i.i.i.i, label %B18.endif.endif.i.i.i.i, label %B56.i.i.i.i.i
B18.endif.endif.i.i.i.i:
  store double %.277.i.i.i.i, ptr %.2332.i, align 8, !noalias !71
  tail call void %20(ptr nonnull %.2332.i, ptr %.1092.i.i, ptr %.1818.i, ptr %a3, ptr %.3879.i), !noalias !71
  br label %B108.endif.endif.i.i.i.i.i
B106.i.i.i.i.i:
  %.291.i.i.i.i.i = add nuw nsw i64 %.284326331.i.i.i.i.i, 1
  %scevgep1.i54.i.i.i.i = getelementptr i8, ptr %lsr.iv.i52.i.i.i.i, i64 16
  %scevgep5.i55.i.i.i.i = getelementptr i8, ptr %lsr.iv4.i.i.i.i.i, i64 24
  %exitcond.not.i56.i.i.i.i = icmp eq i64 %.73.i, %.291.i.i.i.i.i
  br i1 %exitcond.not.i56.i.i.i.i, label %B18.endif.endif.endif.thread13.i.i.i.i, label %B108.endif.endif.i.i.i.i.i
B192.i.i.i.i.i:
  %sunkaddr.i.i.i.i.i = getelementptr i8, ptr %lsr.iv4.i.i.i.i.i, i64 -16
  %.612.i.i.i.i.i = load double, ptr %sunkaddr.i.i.i.i.i, align 8, !noalias !71
  %.701.i.i.i.i.i = getelementptr double, ptr %.3879.i, i64 %.554.i.i.i.i.i
  %.702.i.i.i.i.i = load double, ptr %.701.i.i.i.i.i, align 8, !noalias !71
  %.703.i.i.i.i.i = fmul double %.612.i.i.i.i.i, %.702.i.i.i.i.i
  %.705.i.i.i.i.i = fadd double %.373.i.i.i.i.i, %.703.i.i.i.i.i
  br label %B252.i.i.i.i.i
B252.i.i.i.i.i:
  %value.3.2.i.i.i.i.i = phi double [ %.705.i.i.i.i.i, %B192.i.i.i.i.i ], [ %.373.i.i.i.i.i, %B108.endif.endif.i.i.i.i.i ]
  %.554.1.i.i.i.i.i = load i64, ptr %lsr.iv.i52.i.i.i.i, align 8, !noalias !71
  %.557.1.i.i.i.i.i = icmp sgt i64 %.554.1.i.i.i.i.i, -1
  br i1 %.557.1.i.i.i.i.i, label %B192.1.i.i.i.i.i, label %B252.1.i.i.i.i.i
B192.1.i.i.i.i.i:
  %scevgep6.i57.i.i.i.i = getelementptr i8, ptr %lsr.iv4.i.i.i.i.i, i64 -8
  %.612.1.i.i.i.i.i = load double, ptr %scevgep6.i57.i.i.i.i, align 8, !noalias !71
  %.701.1.i.i.i.i.i = getelementptr double, ptr %.3879.i, i64 %.554.1.i.i.i.i.i
  %.702.1.i.i.i.i.i = load double, ptr %.701.1.i.i.i.i.i, align 8, !noalias !71
  %.703.1.i.i.i.i.i = fmul double %.612.1.i.i.i.i.i, %.702.1.i.i.i.i.i
  %.705.1.i.i.i.i.i = fadd double %value.3.2.i.i.i.i.i, %.703.1.i.i.i.i.i
  br label %B252.1.i.i.i.i.i
B252.1.i.i.i.i.i:
  %value.3.2.1.i.i.i.i.i = phi double [ %.705.1.i.i.i.i.i, %B192.1.i.i.i.i.i ], [ %value.3.2.i.i.i.i.i, %B252.i.i.i.i.i ]
  %.724.i.i.i.i.i = fcmp ogt double %value.3.2.1.i.i.i.i.i, 0.000000e+00
  br i1 %.724.i.i.i.i.i, label %B240.i.i.i.i, label %B106.i.i.i.i.i
B108.endif.endif.i.i.i.i.i:
  %lsr.iv4.i.i.i.i.i = phi ptr [ %scevgep5.i55.i.i.i.i, %B106.i.i.i.i.i ], [ %scevgep3.i145.i, %B18.endif.endif.i.i.i.i ]
  %lsr.iv.i52.i.i.i.i = phi ptr [ %scevgep1.i54.i.i.i.i, %B106.i.i.i.i.i ], [ %scevgep.i144.i, %B18.endif.endif.i.i.i.i ]
  %.284326331.i.i.i.i.i = phi i64 [ %.291.i.i.i.i.i, %B106.i.i.i.i.i ], [ 0, %B18.endif.endif.i.i.i.i ]
  %.373.i.i.i.i.i = load double, ptr %lsr.iv4.i.i.i.i.i, align 8, !noalias !71
  %scevgep2.i53.i.i.i.i = getelementptr i8, ptr %lsr.iv.i52.i.i.i.i, i64 -8
  %.554.i.i.i.i.i = load i64, ptr %scevgep2.i53.i.i.i.i, align 8, !noalias !71
  %.557.i.i.i.i.i = icmp sgt i64 %.554.i.i.i.i.i, -1
  br i1 %.557.i.i.i.i.i, label %B192.i.i.i.i.i, label %B252.i.i.i.i.i
B18.endif.endif.endif.thread13.i.i.i.i:
  %.37115.i.i.i.i = icmp slt i64 %event.2.1.i.i.i.i, 0
  br i1 %.37115.i.i.i.i, label %B186.i.i.i.i, label %B240.i.i.i.i
_ZN6poppet6engine8stepping11stop_insideB3v24B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE.exit.i.i.i:
  %event.4.2.lcssa.sink.i.i.i.i = phi i64 [ -1, %B186.i.i.i.i ], [ %event.4.2.i.i.i.i, %B316.i.i65.i.i ], [ %event.4.2.i.i.i.i, %B60.i22.i.i.i.i ]
  %theta.1.2.lcssa.sink.i.i.i.i = phi double [ 1.000000e+00, %B186.i.i.i.i ], [ %theta.1.2.i.i.i.i, %B316.i.i65.i.i ], [ %theta.1.2.i.i.i.i, %B60.i22.i.i.i.i ]
  %.741.i.i.i = fmul double %"$phi884.0.2.1.in.sroa.speculated.i.i", %theta.1.2.lcssa.sink.i.i.i.i
  %.745.i.i.i = fadd double %t.2.0.i.i, %.741.i.i.i
  %.734793.i.i.i = icmp slt i64 %event.4.2.lcssa.sink.i.i.i.i, 0
  %"$phi412.1.2.0.i.i.i" = select i1 %.734793.i.i.i, double %"$phi1080.0.2.1.i.i", double %.745.i.i.i
  store i64 %event.4.2.lcssa.sink.i.i.i.i, ptr %.4250.i, align 8, !noalias !59
  br label %B536.i.i.i
B426.i.i.i:
  br i1 %"$phi126.0.2.0.i.i.i", label %B430.i.i.i, label %B536.i.i.i
B430.i.i.i:
  %.848.i.i.i = load i64, ptr %sunkaddr26.i.i, align 8, !noalias !59
  call void @llvm.lifetime.start.p0(ptr nonnull %.468.i.i.i.i), !noalias !59
  call void @llvm.lifetime.start.p0(ptr nonnull %.578.i2.i.i.i), !noalias !59
  store i8 0, ptr %.578.i2.i.i.i, align 1, !noalias !74
  %.5.i.i.i.i.i = fmul double %"$phi1080.0.2.1.i.i", 0x3D06849B86A12B9B
  %.6.i.i.i.i.i = fadd double %.5.i.i.i.i.i, 1.000000e-15
  %.340.i.i.i.i = fsub double %"$phi1080.0.2.1.i.i", %.6.i.i.i.i.i
  br label %B6.i.i.i.i
B6.i.i.i.i:
  br i1 %.not.i.i, label %B6.endif.endif.i.i.i.i, label %B58.backedge.preheader.i.i.i.i.i
B58.backedge.preheader.i.i.i.i.i:
  br i1 %64, label %B58.backedge.epil.preheader.i.i.i.i.i, label %B58.backedge.i.i.i.i.i
B58.backedge.i.i.i.i.i:
  %first.2.065.i.i.i.i.i = phi double [ %.13.i.3.i.i.i.i.i, %B58.backedge.i.i.i.i.i ], [ 0x7FF0000000000000, %B58.backedge.preheader.i.i.i.i.i ]
  %.1096163.i.i.i.i.i = phi i64 [ %.116.3.i.i.i.i.i, %B58.backedge.i.i.i.i.i ], [ 0, %B58.backedge.preheader.i.i.i.i.i ]
  %sunkaddr53.i.i.i.i = shl i64 %.1096163.i.i.i.i.i, 3
  %sunkaddr54.i.i.i.i = getelementptr i8, ptr %.1183.i, i64 %sunkaddr53.i.i.i.i
  %.170.i.i.i.i.i = load double, ptr %sunkaddr54.i.i.i.i, align 8, !noalias !77
  %.12.i.i.i.i.i.i = fcmp olt double %.170.i.i.i.i.i, %first.2.065.i.i.i.i.i
  %.13.i.i.i.i.i.i = select i1 %.12.i.i.i.i.i.i, double %.170.i.i.i.i.i, double %first.2.065.i.i.i.i.i
  %sunkaddr57.i.i.i.i = getelementptr i8, ptr %sunkaddr54.i.i.i.i, i64 8
  %.170.1.i.i.i.i.i = load double, ptr %sunkaddr57.i.i.i.i, align 8, !noalias !77
  %.12.i.1.i.i.i.i.i = fcmp olt double %.170.1.i.i.i.i.i, %.13.i.i.i.i.i.i
  %.13.i.1.i.i.i.i.i = select i1 %.12.i.1.i.i.i.i.i, double %.170.1.i.i.i.i.i, double %.13.i.i.i.i.i.i
  %sunkaddr59.i.i.i.i = getelementptr i8, ptr %sunkaddr54.i.i.i.i, i64 16
  %.170.2.i.i.i.i.i = load double, ptr %sunkaddr59.i.i.i.i, align 8, !noalias !77
  %.12.i.2.i.i.i.i.i = fcmp olt double %.170.2.i.i.i.i.i, %.13.i.1.i.i.i.i.i
  %.13.i.2.i.i.i.i.i = select i1 %.12.i.2.i.i.i.i.i, double %.170.2.i.i.i.i.i, double %.13.i.1.i.i.i.i.i
  %sunkaddr62.i.i.i.i = getelementptr i8, ptr %sunkaddr54.i.i.i.i, i64 24
  %.170.3.i.i.i.i.i = load double, ptr %sunkaddr62.i.i.i.i, align 8, !noalias !77
  %.12.i.3.i.i.i.i.i = fcmp olt double %.170.3.i.i.i.i.i, %.13.i.2.i.i.i.i.i
  %.13.i.3.i.i.i.i.i = select i1 %.12.i.3.i.i.i.i.i, double %.170.3.i.i.i.i.i, double %.13.i.2.i.i.i.i.i
  %.116.3.i.i.i.i.i = add nuw nsw i64 %.1096163.i.i.i.i.i, 4
  %niter.ncmp.3.i.i.i.i.i = icmp eq i64 %unroll_iter.i.i.i, %.116.3.i.i.i.i.i
  br i1 %niter.ncmp.3.i.i.i.i.i, label %common.ret.loopexit.unr-lcssa.i.i.i.i.i, label %B58.backedge.i.i.i.i.i
common.ret.loopexit.unr-lcssa.i.i.i.i.i:
  br i1 %65, label %B6.endif.endif.i.i.i.i, label %B58.backedge.epil.preheader.i.i.i.i.i
B58.backedge.epil.preheader.i.i.i.i.i:
  %first.2.065.epil.init.i.i.i.i.i = phi double [ 0x7FF0000000000000, %B58.backedge.preheader.i.i.i.i.i ], [ %.13.i.3.i.i.i.i.i, %common.ret.loopexit.unr-lcssa.i.i.i.i.i ]
  %.1096163.epil.init.i.i.i.i.i = phi i64 [ 0, %B58.backedge.preheader.i.i.i.i.i ], [ %unroll_iter.i.i.i, %common.ret.loopexit.unr-lcssa.i.i.i.i.i ]
  %24 = shl i64 %.1096163.epil.init.i.i.i.i.i, 3
  %scevgep.i.i.i.i.i = getelementptr i8, ptr %.1183.i, i64 %24
  br label %B58.backedge.epil.i.i.i.i.i
B58.backedge.epil.i.i.i.i.i:
  %first.2.065.epil.i.i.i.i.i = phi double [ %.13.i.epil.i.i.i.i.i, %B58.backedge.epil.i.i.i.i.i ], [ %first.2.065.epil.init.i.i.i.i.i, %B58.backedge.epil.preheader.i.i.i.i.i ]
  %epil.iter.i.i.i.i.i = phi i64 [ %epil.iter.next.i.i.i.i.i, %B58.backedge.epil.i.i.i.i.i ], [ 0, %B58.backedge.epil.preheader.i.i.i.i.i ]
  %25 = shl i64 %epil.iter.i.i.i.i.i, 3
  %scevgep70.i4.i.i.i = getelementptr i8, ptr %scevgep.i.i.i.i.i, i64 %25
  %.170.epil.i.i.i.i.i = load double, ptr %scevgep70.i4.i.i.i, align 8, !noalias !77
  %.12.i.epil.i.i.i.i.i = fcmp olt double %.170.epil.i.i.i.i.i, %first.2.065.epil.i.i.i.i.i
  %.13.i.epil.i.i.i.i.i = select i1 %.12.i.epil.i.i.i.i.i, double %.170.epil.i.i.i.i.i, double %first.2.065.epil.i.i.i.i.i
  %epil.iter.next.i.i.i.i.i = add i64 %epil.iter.i.i.i.i.i, 1
  %epil.iter.cmp.not.i.i.i.i.i = icmp eq i64 %xtraiter.i.i.i, %epil.iter.next.i.i.i.i.i
  br i1 %epil.iter.cmp.not.i.i.i.i.i, label %B6.endif.endif.i.i.i.i, label %B58.backedge.epil.i.i.i.i.i, !llvm.loop !80
B96.i.i.i.i:
  call fastcc void @v35(ptr nonnull %.468.i.i.i.i, i64 %.478.i.i.i, double %t.2.0.i.i, double %"$phi884.0.2.1.in.sroa.speculated.i.i", double %first.2.0.lcssa.i.i.i.i.i, double %.4476.i, ptr readonly %.5069.i, ptr readonly %a2, ptr readonly %.920.i.i, ptr readonly %.1408.i.i, i64 %.732.i.i, ptr %.748.i.i, i64 %.1802.i, ptr %.1818.i, ptr %a3, ptr nonnull %.2332.i, i64 %.3863.i, ptr %.3879.i, i64 %.71.i, ptr readonly %a7, i64 %.71.i, ptr %a14, i64 %.71.i, ptr nonnull %a17)
  %.523.i.i64.i.i = fsub double %first.2.0.lcssa.i.i.i.i.i, %t.2.0.i.i
  %.528.i.i.i.i = fdiv double %.523.i.i64.i.i, %"$phi884.0.2.1.in.sroa.speculated.i.i"
  %.64.i.i5.i.i.i = fsub double 1.000000e+00, %.528.i.i.i.i
  br i1 %6, label %B96.endif.endif.endif.i.i.i.i, label %B60.i.i6.i.i.i
B6.endif.endif.i.i.i.i:
  %first.2.0.lcssa.i.i.i.i.i = phi double [ 0x7FF0000000000000, %B6.i.i.i.i ], [ %.13.i.3.i.i.i.i.i, %common.ret.loopexit.unr-lcssa.i.i.i.i.i ], [ %.13.i.epil.i.i.i.i.i, %B58.backedge.epil.i.i.i.i.i ]
  %.342.i.i.i.i = fcmp ult double %first.2.0.lcssa.i.i.i.i.i, %.340.i.i.i.i
  br i1 %.342.i.i.i.i, label %B96.i.i.i.i, label %_ZN6poppet6engine8stepping10act_insideB3v26B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExxdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i.i.i
B60.i.i6.i.i.i:
  %.166146148.i.i7.i.i.i = phi i64 [ %.173.i.i8.i.i.i, %B60.i.i6.i.i.i ], [ 0, %B96.i.i.i.i ]
  %.173.i.i8.i.i.i = add nuw nsw i64 %.166146148.i.i7.i.i.i, 1
  %26 = shl i64 %.166146148.i.i7.i.i.i, 3
  %scevgep4.i24.i.i.i.i = getelementptr i8, ptr %a2, i64 %26
  %.227.i.i9.i.i.i = load double, ptr %scevgep4.i24.i.i.i.i, align 8, !noalias !81
  %.229.i.i10.i.i.i = fmul double %.64.i.i5.i.i.i, %.227.i.i9.i.i.i
  %scevgep3.i.i11.i.i.i = getelementptr i8, ptr %.920.i.i, i64 %26
  %.259.i.i12.i.i.i = load double, ptr %scevgep3.i.i11.i.i.i, align 8, !noalias !81
  %scevgep52.i.i.i.i = getelementptr i8, ptr %.1408.i.i, i64 %26
  %.289.i.i13.i.i.i = load double, ptr %scevgep52.i.i.i.i, align 8, !noalias !81
  %scevgep51.i.i.i.i = getelementptr i8, ptr %invariant.gep.i.i3.i.i.i, i64 %26
  %.321.i.i14.i.i.i = load double, ptr %scevgep51.i.i.i.i, align 8, !noalias !81
  %.323.i.i15.i.i.i = fmul double %.528.i.i.i.i, %.321.i.i14.i.i.i
  %.324.i.i16.i.i.i = fadd double %.289.i.i13.i.i.i, %.323.i.i15.i.i.i
  %.326.i.i17.i.i.i = fmul double %.64.i.i5.i.i.i, %.324.i.i16.i.i.i
  %.327.i.i18.i.i.i = fadd double %.259.i.i12.i.i.i, %.326.i.i17.i.i.i
  %.329.i.i19.i.i.i = fmul double %.528.i.i.i.i, %.327.i.i18.i.i.i
  %.330.i.i20.i.i.i = fadd double %.229.i.i10.i.i.i, %.329.i.i19.i.i.i
  %scevgep50.i.i.i.i = getelementptr i8, ptr %.1092.i.i, i64 %26
  store double %.330.i.i20.i.i.i, ptr %scevgep50.i.i.i.i, align 8, !noalias !81
  %exitcond.not.i.i21.i.i.i = icmp eq i64 %.1067.i.i, %.173.i.i8.i.i.i
  br i1 %exitcond.not.i.i21.i.i.i, label %B96.endif.endif.endif.i.i.i.i, label %B60.i.i6.i.i.i
B96.endif.endif.endif.i.i.i.i:
  store i8 0, ptr %.578.i2.i.i.i, align 1, !noalias !74
  call fastcc void @v34(ptr nonnull %.578.i2.i.i.i, i64 %.848.i.i.i, double %first.2.0.lcssa.i.i.i.i.i, double %.4476.i, ptr readonly %.5069.i, ptr %.1092.i.i, i64 %.1802.i, ptr %.1818.i, ptr %a3, i64 %.1167.i, ptr %.1183.i, ptr nonnull %.2332.i, i64 %.3521.i, ptr %.3537.i, ptr %.3708.i, ptr readonly %a13)
  %.612.i.i.i.i = load i8, ptr %.578.i2.i.i.i, align 1, !noalias !74
  %.615.not.i.i.i.i = icmp eq i8 %.612.i.i.i.i, 0
  br i1 %.615.not.i.i.i.i, label %B6.i.i.i.i, label %_ZN6poppet6engine8stepping10act_insideB3v26B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExxdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i.i.i
_ZN6poppet6engine8stepping10act_insideB3v26B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExxdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i.i.i:
  %storemerge.i.i.i.i = phi double [ %"$phi1080.0.2.1.i.i", %B6.endif.endif.i.i.i.i ], [ %first.2.0.lcssa.i.i.i.i.i, %B96.endif.endif.endif.i.i.i.i ]
  call void @llvm.lifetime.end.p0(ptr nonnull %.468.i.i.i.i), !noalias !59
  call void @llvm.lifetime.end.p0(ptr nonnull %.578.i2.i.i.i), !noalias !59
  br label %B536.i.i.i
B536.i.i.i:
  %reached.3.0.i.i.i = phi double [ %"$phi412.1.2.0.i.i.i", %_ZN6poppet6engine8stepping11stop_insideB3v24B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE.exit.i.i.i ], [ %storemerge.i.i.i.i, %_ZN6poppet6engine8stepping10act_insideB3v26B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExxdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i.i.i ], [ %"$phi1080.0.2.1.i.i", %B426.i.i.i ]
  call fastcc void @v35(ptr nonnull %.1003.i.i.i, i64 %.478.i.i.i, double %t.2.0.i.i, double %"$phi884.0.2.1.in.sroa.speculated.i.i", double %reached.3.0.i.i.i, double %.4476.i, ptr readonly %.5069.i, ptr %a2, ptr readonly %.920.i.i, ptr %.1408.i.i, i64 %.732.i.i, ptr %.748.i.i, i64 %.1802.i, ptr %.1818.i, ptr %a3, ptr nonnull %.2332.i, i64 %.3863.i, ptr %.3879.i, i64 %.71.i, ptr readonly %a7, i64 %.71.i, ptr %a14, i64 %.71.i, ptr nonnull %a17)
  %.1141.i.i.i = load i64, ptr %.4250.i, align 8, !noalias !59
  %.1142.i.i.i = icmp sgt i64 %.1141.i.i.i, -1
  %.1164.i.i.i = fcmp olt double %reached.3.0.i.i.i, %"$phi1080.0.2.1.i.i"
  %or.cond.i55.i.i = select i1 %.1142.i.i.i, i1 true, i1 %.1164.i.i.i
  %arg.xi.4.arg.x1.4.i.i.i = select i1 %or.cond.i55.i.i, ptr %.1092.i.i, ptr %.920.i.i
  br label %B50.endif.endif.i.i.i.i
B26.endif.endif.i.i.i:
  %first.2.0.lcssa.i.i50.i.i = phi double [ %.13.i.3.i.i33.i.i, %common.ret.loopexit.unr-lcssa.i.i36.i.i ], [ %.13.i.epil.i.i47.i.i, %B58.backedge.epil.i.i42.i.i ]
  %.5.i.i51.i.i = fmul double %"$phi1080.0.2.1.i.i", 0x3D06849B86A12B9B
  %.6.i.i52.i.i = fadd double %.5.i.i51.i.i, 1.000000e-15
  %.422.i.i.i = fsub double %"$phi1080.0.2.1.i.i", %.6.i.i52.i.i
  %.423.i.i.i = fcmp olt double %first.2.0.lcssa.i.i50.i.i, %.422.i.i.i
  br label %B126.i.i.i
B50.endif.endif.i.i.i.i:
  %.158230233.i.i.i.i = phi i64 [ 0, %B536.i.i.i ], [ %.165.i.i.i.i, %B50.endif.endif.i.i.i.i ]
  %.165.i.i.i.i = add nuw nsw i64 %.158230233.i.i.i.i, 1
  %27 = shl i64 %.158230233.i.i.i.i, 3
  %scevgep9.i.i.i.i = getelementptr i8, ptr %arg.xi.4.arg.x1.4.i.i.i, i64 %27
  %.219.i.i.i.i = load double, ptr %scevgep9.i.i.i.i, align 8, !noalias !84
  %scevgep6.i.i57.i.i = getelementptr i8, ptr %invariant.gep.i.i.i.i, i64 %27
  %.252.i.i.i.i = load double, ptr %scevgep6.i.i57.i.i, align 8, !noalias !84
  %scevgep8.i.i.i.i = getelementptr i8, ptr %a2, i64 %27
  %.282.i.i58.i.i = load double, ptr %scevgep8.i.i.i.i, align 8, !noalias !84
  %.283.i.i.i.i = fsub double %.219.i.i.i.i, %.282.i.i58.i.i
  %.284.i.i59.i.i = tail call double @llvm.fabs.f64(double %.283.i.i.i.i)
  %.285.i.i60.i.i = fadd double %.252.i.i.i.i, %.284.i.i59.i.i
  store double %.285.i.i60.i.i, ptr %scevgep6.i.i57.i.i, align 8, !noalias !84
  store double %.219.i.i.i.i, ptr %scevgep8.i.i.i.i, align 8, !noalias !84
  %scevgep3.i.i.i = getelementptr i8, ptr %a15, i64 %27
  %.375.i.i.i.i = load double, ptr %scevgep3.i.i.i, align 8, !noalias !84
  %.12.i.i1.i.i.i = fcmp olt double %.219.i.i.i.i, %.375.i.i.i.i
  %.13.i.i2.i.i.i = select i1 %.12.i.i1.i.i.i, double %.219.i.i.i.i, double %.375.i.i.i.i
  %scevgep.i61.i.i = getelementptr i8, ptr %invariant.gep242.i.i.i.i, i64 %27
  %.435.i.i.i.i = load double, ptr %scevgep.i61.i.i, align 8, !noalias !84
  %.12.i4.i.i.i.i = fcmp ogt double %.219.i.i.i.i, %.435.i.i.i.i
  %.13.i5.i.i.i.i = select i1 %.12.i4.i.i.i.i, double %.219.i.i.i.i, double %.435.i.i.i.i
  store double %.13.i.i2.i.i.i, ptr %scevgep3.i.i.i, align 8, !noalias !84
  store double %.13.i5.i.i.i.i, ptr %scevgep.i61.i.i, align 8, !noalias !84
  %exitcond.not.i.i62.i.i = icmp eq i64 %.25.i, %.165.i.i.i.i
  br i1 %exitcond.not.i.i62.i.i, label %_ZN6poppet6engine10integrator7_acceptB3v23B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i.i, label %B50.endif.endif.i.i.i.i
_ZN6poppet6engine10integrator7_acceptB3v23B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i.i:
  %.577.i.i.i.i = load i64, ptr %a17, align 8, !noalias !84
  %.578.i.i63.i.i = add nsw i64 %.577.i.i.i.i, 1
  store i64 %.578.i.i63.i.i, ptr %a17, align 8, !noalias !84
  call void @llvm.lifetime.end.p0(ptr nonnull %.1003.i.i.i), !noalias !28
  store double %reached.3.0.i.i.i, ptr %a16, align 8, !noalias !28
  %.3798.i.i = load i64, ptr %.4250.i, align 8, !noalias !28
  %.3799.i.i = icmp sgt i64 %.3798.i.i, -1
  br i1 %.3799.i.i, label %_ZN6poppet6engine10integrator8_segmentB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B1520.endif.i.i
B1724.i.i:
  %first.2.1.i.i = phi double [ %.4213.i.i, %B1654.endif.endif.i.i ], [ %first.3.0.i.i, %B1520.endif.endif.endif.i.i ]
  %.4221.i.i = fcmp olt double %"$phi884.0.2.1.in.sroa.speculated.i.i", %wanted.2.0.sink.i.i.i
  br i1 %.4221.i.i, label %B1736.i.i, label %B1774.i.i
B1736.i.i:
  %.4227.i.i = fmul double %"$phi884.0.2.1.in.sroa.speculated.i.i", %.13.i4.i.i.i
  %.12.i154.i.i = fcmp ogt double %.4227.i.i, %wanted.2.0.sink.i.i.i
  %.13.i155.i.i = select i1 %.12.i154.i.i, double %.4227.i.i, double %wanted.2.0.sink.i.i.i
  br label %B1818.i.i
B1774.i.i:
  %.12.i156.i.i = fcmp olt double %.13.i4.i.i.i, 1.000000e+00
  %.13.i157.i.i = select i1 %.12.i156.i.i, double %.13.i4.i.i.i, double 1.000000e+00
  %"$phi1814.1.2.1.i.i" = select i1 %rejected.3.0.i.i, double %.13.i157.i.i, double %.13.i4.i.i.i
  %.4322.i.i = fmul double %"$phi884.0.2.1.in.sroa.speculated.i.i", %"$phi1814.1.2.1.i.i"
  br label %B1818.i.i
B1818.i.i:
  %"$phi1818.0.2.1.i.i" = phi double [ %.4322.i.i, %B1774.i.i ], [ %.13.i155.i.i, %B1736.i.i ]
  %.4413.i.i = fcmp olt double %reached.3.0.i.i.i, %.4411.i.i
  %or.cond273.i.i = select i1 %.1974.i.i, i1 %.4413.i.i, i1 false
  br i1 %or.cond273.i.i, label %B1900.i.i, label %B2254.i.i
B1900.i.i:
  %.4457.i.i = load i64, ptr %sunkaddr26.i.i, align 8, !noalias !28
  store i8 0, ptr %.4469.i.i, align 1, !noalias !28
  call fastcc void @v34(ptr nonnull %.4469.i.i, i64 %.4457.i.i, double %reached.3.0.i.i.i, double %.4476.i, ptr readonly %.5069.i, ptr %a2, i64 %.1802.i, ptr %.1818.i, ptr %a3, i64 %.1167.i, ptr %.1183.i, ptr nonnull %.2332.i, i64 %.3521.i, ptr %.3537.i, ptr %.3708.i, ptr readonly %a13)
  %.4503.i.i = load i8, ptr %.4469.i.i, align 1, !noalias !28
  %.4506.i.i = icmp ne i8 %.4503.i.i, 0
  %or.cond1.i.i = select i1 %.4506.i.i, i1 true, i1 %.1164.i.i.i
  br i1 %or.cond1.i.i, label %B1992.endif.i.i, label %B2254.i.i
B2190.i.i:
  %"$phi2190.1.2.2.i.i" = phi double [ 1.500000e-01, %for.end.1.i.i ], [ %.13.i222.i.i, %B2086.endif.i.i ]
  %.4794.i.i = fmul double %"$phi884.0.2.1.in.sroa.speculated.i.i", %"$phi2190.1.2.2.i.i"
  %.4807.i.i = fadd double %t.2.0.i.i, %.4794.i.i
  %.4809.i.i = fcmp ole double %.4807.i.i, %t.2.0.i.i
  %.4812.i.i = fcmp olt double %.4794.i.i, 1.000000e-300
  %or.cond.i.i = or i1 %.4812.i.i, %.4809.i.i
  %brmerge2747.i.i = or i1 %5, %or.cond.i.i
  br i1 %brmerge2747.i.i, label %_ZN6poppet6engine10integrator8_segmentB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B2254.i.i
B2254.i.i:
  %t.3.1.i.i = phi double [ %t.2.0.i.i, %B2190.i.i ], [ %reached.3.0.i.i.i, %B1992.endif.i.i ], [ %reached.3.0.i.i.i, %B1818.i.i ], [ %reached.3.0.i.i.i, %B1900.i.i ]
  %h.7.1.i.i = phi double [ %.4794.i.i, %B2190.i.i ], [ %.13.i159.i.i, %B1992.endif.i.i ], [ %"$phi1818.0.2.1.i.i", %B1818.i.i ], [ %"$phi1818.0.2.1.i.i", %B1900.i.i ]
  %error_before.3.1.i.i = phi double [ %error_before.2.0.i.i, %B2190.i.i ], [ %.13.i218.i.i, %B1992.endif.i.i ], [ %.13.i218.i.i, %B1818.i.i ], [ %.13.i218.i.i, %B1900.i.i ]
  %step_before.4.1.i.i = phi double [ %step_before.3.0.i.i, %B2190.i.i ], [ 0.000000e+00, %B1992.endif.i.i ], [ %"$phi884.0.2.1.in.sroa.speculated.i.i", %B1818.i.i ], [ %"$phi884.0.2.1.in.sroa.speculated.i.i", %B1900.i.i ]
  %rejected.4.1.i.i = phi i1 [ true, %B2190.i.i ], [ false, %B1992.endif.i.i ], [ false, %B1818.i.i ], [ false, %B1900.i.i ]
  %fresh.4.1.i.i = phi i1 [ false, %B2190.i.i ], [ true, %B1992.endif.i.i ], [ true, %B1818.i.i ], [ true, %B1900.i.i ]
  %calm.3.1.i.i = phi double [ %calm.2.0.i.i, %B2190.i.i ], [ %reached.3.0.i.i.i, %B1992.endif.i.i ], [ %calm.2.0.i.i, %B1818.i.i ], [ %calm.2.0.i.i, %B1900.i.i ]
  %first.4.1.i.i = phi double [ %first.3.0.i.i, %B2190.i.i ], [ %first.2.1.i.i, %B1992.endif.i.i ], [ %first.2.1.i.i, %B1818.i.i ], [ %first.2.1.i.i, %B1900.i.i ]
  %has_changed.4.1.i.i = phi i1 [ %has_changed.3.0.i.i, %B2190.i.i ], [ true, %B1992.endif.i.i ], [ false, %B1818.i.i ], [ false, %B1900.i.i ]
  %has_acted.3.1.i.i = phi i1 [ %has_acted.5.0.i.i, %B2190.i.i ], [ true, %B1992.endif.i.i ], [ %has_acted.5.0.i.i, %B1818.i.i ], [ true, %B1900.i.i ]
  %.5170.i.i = load double, ptr %sunkaddr237.i.i, align 8, !noalias !28
  %.94.i.i.i = load i64, ptr %sunkaddr246.i.i, align 8, !noalias !87
  %.114.i.i.i = srem i64 %.94.i.i.i, 400
  %.135.i.i.i = icmp eq i64 %.114.i.i.i, 0
  br i1 %.135.i.i.i, label %B44.i.i.i, label %B184.i.i.i
B44.i.i.i:
  %.5140.i.i = load double, ptr %sunkaddr241.i.i, align 8, !noalias !28
  %.139.i.i.i = fsub double %t.3.1.i.i, %window.2.0.i.i
  %.144.i.i.i = fsub double %.5140.i.i, %window.2.0.i.i
  %.149.i.i.i = fmul double %.144.i.i.i, 1.000000e-04
  %.150.i.i.i = fcmp uge double %.139.i.i.i, %.149.i.i.i
  %"$phi78.0.2.0.not135.i.i.i" = select i1 %.150.i.i.i, i1 true, i1 %has_acted.3.1.i.i
  %.199.i.i.i = load i64, ptr %a17, align 8, !noalias !87
  %.229.i.i.i = load i64, ptr %sunkaddr242.i.i, align 8, !noalias !87
  %.230.i.i.i = sub nsw i64 %.199.i.i.i, %.229.i.i.i
  %.272.i.i.i = icmp sgt i64 %.230.i.i.i, 279
  %brmerge.i.i.i = or i1 %"$phi78.0.2.0.not135.i.i.i", %.272.i.i.i
  br i1 %brmerge.i.i.i, label %B162.i.i.i, label %_ZN6poppet6engine10integrator8_segmentB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
B162.i.i.i:
  store i64 %.199.i.i.i, ptr %sunkaddr242.i.i, align 8, !noalias !87
  br label %B184.i.i.i
B184.i.i.i:
  %28 = fcmp une double %.5170.i.i, 0.000000e+00
  %.427.i.i.i = load double, ptr %sunkaddr244.i.i, align 8, !noalias !87
  %.433.i.i.i = sitofp i64 %.94.i.i.i to double
  %.434.i.i.i = fcmp ole double %.427.i.i.i, %.433.i.i.i
  %brmerge242.i.i = select i1 %.434.i.i.i, i1 true, i1 %28
  br i1 %brmerge242.i.i, label %B2360.split.loop.exit.i.i, label %B2370.else.if.i.i
B2360.split.loop.exit.i.i:
  %.mux.le.i.i = select i1 %.434.i.i.i, i64 3, i64 5
  br label %_ZN6poppet6engine10integrator8_segmentB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
B0.endif.else.endif.if.i.i:
  br label %B0.endif.else.endif.endif.endif.i.i
B0.endif.else.endif.endif.endif.i.i:
  %.635.sroa.0.3.i.i = phi i64 [ %.1445.i, %B0.endif.else.endif.if.i.i ], [ %.25.i, %B1814.i ]
  br i1 %.672.not.i.i, label %B0.endif.endif.else.i.i, label %B0.endif.else.endif.endif.endif.if.i.i, !prof !31
B0.endif.else.endif.endif.endif.if.i.i:
  br label %B0.endif.endif.else.i.i
B0.endif.endif.else.i.i:
  %.635.sroa.13.0.i.i = phi i64 [ %.609.i.i, %B0.endif.else.endif.endif.endif.i.i ], [ %.1445.i, %B0.endif.else.endif.endif.endif.if.i.i ]
  %.723.i.i = sub nsw i64 %.635.sroa.13.0.i.i, %.635.sroa.0.3.i.i
  %.732.i.i = tail call i64 @llvm.smax.i64(i64 %.723.i.i, i64 0)
  %.748.i.i = getelementptr double, ptr %.1461.i, i64 %.635.sroa.0.3.i.i
  br i1 %.672.not.i.i, label %B0.endif.endif.else.endif.endif.endif.i.i, label %B0.endif.endif.else.endif.if.i.i, !prof !31
B0.endif.endif.else.endif.if.i.i:
  br label %B0.endif.endif.else.endif.endif.endif.i.i
B0.endif.endif.else.endif.endif.endif.i.i:
  %.807.sroa.0.3.i.i = phi i64 [ %.1445.i, %B0.endif.endif.else.endif.if.i.i ], [ %.609.i.i, %B0.endif.endif.else.i.i ]
  %.920.i.i = getelementptr double, ptr %.1461.i, i64 %.807.sroa.0.3.i.i
  br i1 %.844.not.i.i, label %B0.endif.endif.endif.else.endif.endif.endif.i.i, label %B0.endif.endif.endif.else.endif.if.i.i, !prof !31
B0.endif.endif.endif.else.endif.if.i.i:
  br label %B0.endif.endif.endif.else.endif.endif.endif.i.i
B0.endif.endif.endif.else.endif.endif.endif.i.i:
  %.979.sroa.0.3.i.i = phi i64 [ %.1445.i, %B0.endif.endif.endif.else.endif.if.i.i ], [ %.781.i.i, %B0.endif.endif.else.endif.endif.endif.i.i ]
  br i1 %.1016.not.i.i, label %B0.endif.endif.endif.endif.else.i.i, label %B0.endif.endif.endif.else.endif.endif.endif.if.i.i, !prof !31
B0.endif.endif.endif.else.endif.endif.endif.if.i.i:
  br label %B0.endif.endif.endif.endif.else.i.i
B0.endif.endif.endif.endif.else.i.i:
  %.979.sroa.13.0.i.i = phi i64 [ %.953.i.i, %B0.endif.endif.endif.else.endif.endif.endif.i.i ], [ %.1445.i, %B0.endif.endif.endif.else.endif.endif.endif.if.i.i ]
  %.1067.i.i = sub nsw i64 %.979.sroa.13.0.i.i, %.979.sroa.0.3.i.i
  %.1076.i.i = tail call i64 @llvm.smax.i64(i64 %.1067.i.i, i64 0)
  %.1092.i.i = getelementptr double, ptr %.1461.i, i64 %.979.sroa.0.3.i.i
  br i1 %.1016.not.i.i, label %B0.endif.endif.endif.endif.else.endif.endif.endif.i.i, label %B0.endif.endif.endif.endif.else.endif.if.i.i, !prof !31
B0.endif.endif.endif.endif.else.endif.if.i.i:
  br label %B0.endif.endif.endif.endif.else.endif.endif.endif.i.i
B0.endif.endif.endif.endif.else.endif.endif.endif.i.i:
  %.1295.sroa.0.3.i.i = phi i64 [ %.1445.i, %B0.endif.endif.endif.endif.else.endif.if.i.i ], [ %.953.i.i, %B0.endif.endif.endif.endif.else.i.i ]
  %.1408.i.i = getelementptr double, ptr %.1461.i, i64 %.1295.sroa.0.3.i.i
  br i1 %.1332.not.i.i, label %B0.endif.endif.endif.endif.endif.endif.else.i.i, label %B0.endif.endif.endif.endif.endif.else.endif.if.i.i, !prof !31
B0.endif.endif.endif.endif.endif.else.endif.if.i.i:
  br label %B0.endif.endif.endif.endif.endif.endif.else.i.i
B0.endif.endif.endif.endif.endif.endif.else.i.i:
  %.1466.sroa.0.3.i.i = phi i64 [ %.1445.i, %B0.endif.endif.endif.endif.endif.else.endif.if.i.i ], [ %.1269.i.i, %B0.endif.endif.endif.endif.else.endif.endif.endif.i.i ]
  %.1579.i.i = getelementptr double, ptr %.1461.i, i64 %.1466.sroa.0.3.i.i
  br i1 %.1657.not.i.i, label %B0.endif.endif.endif.endif.endif.endif.endif.i.i, label %B0.endif.endif.endif.endif.endif.endif.else.endif.if.i.i, !prof !31
B0.endif.endif.endif.endif.endif.endif.endif.i.i:
  %.1637.sroa.0.3.i.i = phi i64 [ %.1445.i, %B0.endif.endif.endif.endif.endif.endif.else.endif.if.i.i ], [ %.1611.i.i, %B0.endif.endif.endif.endif.endif.endif.else.i.i ]
  %.1750.i.i = getelementptr double, ptr %.1461.i, i64 %.1637.sroa.0.3.i.i
  %scevgep.i163.i.i = getelementptr i8, ptr %.5069.i, i64 16
  br label %B56.i.i.i
B56.i.i.i:
  %lsr.iv3.i.i.i = phi i64 [ %lsr.iv.next.i.i.i, %B88.i.i.i ], [ %73, %B0.endif.endif.endif.endif.endif.endif.endif.i.i ]
  %lsr.iv.i.i.i = phi ptr [ %scevgep1.i.i.i, %B88.i.i.i ], [ %scevgep.i163.i.i, %B0.endif.endif.endif.endif.endif.endif.endif.i.i ]
  %scevgep1.i.i.i = getelementptr i8, ptr %lsr.iv.i.i.i, i64 48
  %lsr.iv.next.i.i.i = add i64 %lsr.iv3.i.i.i, -1
  %exitcond.not.i164.i.i = icmp eq i64 %lsr.iv.next.i.i.i, 0
  br i1 %exitcond.not.i164.i.i, label %B0.endif.endif.endif.endif.endif.endif.endif.endif.endif.i.i, label %B58.i.i.i
B58.i.i.i:
  %scevgep2.i165.i.i = getelementptr i8, ptr %lsr.iv.i.i.i, i64 -8
  %.215.i.i.i = load double, ptr %scevgep2.i165.i.i, align 8, !noalias !90
  %.216.i.i.i = fcmp une double %.215.i.i.i, 0.000000e+00
  br i1 %.216.i.i.i, label %B0.endif.endif.endif.endif.endif.endif.endif.endif.endif.i.i, label %B88.i.i.i
B88.i.i.i:
  %.274.i.i.i = load double, ptr %lsr.iv.i.i.i, align 8, !noalias !90
  %.275.i.i.i = fcmp une double %.274.i.i.i, 0.000000e+00
  br i1 %.275.i.i.i, label %B0.endif.endif.endif.endif.endif.endif.endif.endif.endif.i.i, label %B56.i.i.i
B0.endif.endif.endif.endif.endif.endif.else.endif.if.i.i:
  br label %B0.endif.endif.endif.endif.endif.endif.endif.i.i
B0.endif.endif.endif.endif.endif.endif.endif.endif.endif.i.i:
  %.1909.i.i = load double, ptr %.1908.i.i, align 8, !noalias !28
  br i1 %.1974.i.i, label %B422.i.i, label %B506.endif.endif.i.i
B506.endif.endif.i.i:
  %.40.i.i.i = fsub double %.4476.i, %.4476.i
  %scevgep.i167.i.i = getelementptr i8, ptr %.5069.i, i64 40
  br label %B538.else.i.i
B538.else.i.i:
  %.217829122914.i.i = phi i64 [ 0, %B506.endif.endif.i.i ], [ %.2185.i.i, %B538.endif.endif.i.i ]
  %.2185.i.i = add nuw nsw i64 %.217829122914.i.i, 1
  %.2211.i.i = mul nuw nsw i64 %.217829122914.i.i, %.1802.i
  %.2214.i.i = mul nuw nsw i64 %.2185.i.i, %.1802.i
  %.2261.not.i.i = icmp sgt i64 %.1964.i, %.2211.i.i
  br i1 %.2261.not.i.i, label %B538.else.endif.endif.endif.i.i, label %B538.else.endif.if.i.i, !prof !31
B538.endif.i.i:
  %.2241.sroa.13.0.i.i = phi i64 [ %.2214.i.i, %B538.else.endif.endif.endif.i.i ], [ %.1973.i, %B538.else.endif.endif.endif.if.i.i ]
  %.132223.not.i.not.i.i = icmp sgt i64 %.2241.sroa.13.0.i.i, %.2241.sroa.0.3.i.i
  br i1 %.132223.not.i.not.i.i, label %B56.i168.i.i, label %B538.endif.endif.i.i
B56.i168.i.i:
  %lsr.iv451.i.i = phi i64 [ %lsr.iv.next452.i.i, %B316.i.i.i ], [ %.2241.sroa.0.3.i.i, %B538.endif.i.i ]
  %lsr.iv.i169.i.i = phi ptr [ %scevgep1.i172.i.i, %B316.i.i.i ], [ %scevgep.i167.i.i, %B538.endif.i.i ]
  %scevgep6.i.i.i = getelementptr i8, ptr %lsr.iv.i169.i.i, i64 -40
  %.227.i.i.i = load double, ptr %scevgep6.i.i.i, align 8, !noalias !93
  %scevgep5.i170.i.i = getelementptr i8, ptr %lsr.iv.i169.i.i, i64 -32
  %.282.i.i.i = load double, ptr %scevgep5.i170.i.i, align 8, !noalias !93
  %.284.i.i.i = fmul double %.40.i.i.i, %.282.i.i.i
  %.285.i.i.i = fadd double %.227.i.i.i, %.284.i.i.i
  %scevgep4.i171.i.i = getelementptr i8, ptr %lsr.iv.i169.i.i, i64 -24
  %.347.i.i.i = load double, ptr %scevgep4.i171.i.i, align 8, !noalias !93
  %.348.i.i.i = fcmp une double %.347.i.i.i, 0.000000e+00
  br i1 %.348.i.i.i, label %B134.i.i.i, label %B316.i.i.i
B134.i.i.i:
  %scevgep3.i174.i.i = getelementptr i8, ptr %lsr.iv.i169.i.i, i64 -16
  %.405.i.i.i = load double, ptr %scevgep3.i174.i.i, align 8, !noalias !93
  %scevgep2.i175.i.i = getelementptr i8, ptr %lsr.iv.i169.i.i, i64 -8
  %.460.i.i.i = load double, ptr %scevgep2.i175.i.i, align 8, !noalias !93
  %.461.i.i.i = fmul double %.460.i.i.i, 5.000000e-01
  %.463.i.i.i = fmul double %.40.i.i.i, %.461.i.i.i
  %.464.i.i.i = fadd double %.405.i.i.i, %.463.i.i.i
  %.465.i.i.i = fmul double %.464.i.i.i, 0x401921FB54442D18
  %.467.i.i.i = fmul double %.40.i.i.i, %.465.i.i.i
  %.522.i.i.i = load double, ptr %lsr.iv.i169.i.i, align 8, !noalias !93
  %.523.i.i.i = fadd double %.522.i.i.i, %.467.i.i.i
  %.586.le.i.i.i = tail call double @llvm.sin.f64(double %.523.i.i.i)
  %.591.i.i.i = fmul double %.347.i.i.i, %.586.le.i.i.i
  %.593.i.i.i = fadd double %.285.i.i.i, %.591.i.i.i
  br label %B316.i.i.i
B316.i.i.i:
  %value.2.1.i.i.i = phi double [ %.593.i.i.i, %B134.i.i.i ], [ %.285.i.i.i, %B56.i168.i.i ]
  %29 = shl i64 %lsr.iv451.i.i, 3
  %scevgep453.i.i = getelementptr i8, ptr %.1989.i, i64 %29
  store double %value.2.1.i.i.i, ptr %scevgep453.i.i, align 8, !noalias !93
  %scevgep1.i172.i.i = getelementptr i8, ptr %lsr.iv.i169.i.i, i64 48
  %lsr.iv.next452.i.i = add i64 %lsr.iv451.i.i, 1
  %exitcond.not.i173.i.i = icmp eq i64 %.2241.sroa.13.0.i.i, %lsr.iv.next452.i.i
  br i1 %exitcond.not.i173.i.i, label %B538.endif.endif.i.i, label %B56.i168.i.i
B538.else.endif.if.i.i:
  br label %B538.else.endif.endif.endif.i.i
B538.else.endif.endif.endif.i.i:
  %.2241.sroa.0.3.i.i = phi i64 [ %.1973.i, %B538.else.endif.if.i.i ], [ %.2211.i.i, %B538.else.i.i ]
  %.2278.not.i.i = icmp sgt i64 %.1964.i, %.2214.i.i
  br i1 %.2278.not.i.i, label %B538.endif.i.i, label %B538.else.endif.endif.endif.if.i.i, !prof !31
B538.else.endif.endif.endif.if.i.i:
  br label %B538.endif.i.i
B538.endif.endif.i.i:
  %exitcond.not.i1.i = icmp eq i64 %.2185.i.i, 4
  br i1 %exitcond.not.i1.i, label %B622.i.i, label %B538.else.i.i
switch.lookup.i.i:
  %.291729182921.i.i = phi i64 [ %.2924.i.i, %switch.end.endif.endif.i.i ], [ 0, %B884.i.i ]
  %.2924.i.i = add nuw nsw i64 %.291729182921.i.i, 1
  %switch.gep.i.i = getelementptr inbounds double, ptr @v25, i64 %.291729182921.i.i
  %switch.load.i.i = load double, ptr %switch.gep.i.i, align 8, !noalias !28
  %.2981.i.i = fmul double %"$phi884.0.2.1.in.sroa.speculated.i.i", %switch.load.i.i
  %.2983.i.i = fadd double %t.2.0.i.i, %.2981.i.i
  %.2985.i.i = mul nuw nsw i64 %.291729182921.i.i, %.1802.i
  %.2988.i.i = mul nuw nsw i64 %.2924.i.i, %.1802.i
  %.3035.not.i.i = icmp sgt i64 %.1964.i, %.2985.i.i
  br i1 %.3035.not.i.i, label %switch.end.else.endif.endif.endif.i.i, label %switch.end.else.endif.if.i.i, !prof !31
switch.end.endif.i.i:
  %.3015.sroa.13.0.i.i = phi i64 [ %.2988.i.i, %switch.end.else.endif.endif.endif.i.i ], [ %.1973.i, %switch.end.else.endif.endif.endif.if.i.i ]
  %.40.i177.i.i = fsub double %.2983.i.i, %.4476.i
  %.132223.not.i178.not.i.i = icmp sgt i64 %.3015.sroa.13.0.i.i, %.3015.sroa.0.3.i.i
  br i1 %.132223.not.i178.not.i.i, label %B56.i181.i.i, label %switch.end.endif.endif.i.i
B56.i181.i.i:
  %lsr.iv.i4.i = phi i64 [ %lsr.iv.next.i.i, %B316.i194.i.i ], [ %.3015.sroa.0.3.i.i, %switch.end.endif.i.i ]
  %lsr.iv.i182.i.i = phi ptr [ %scevgep1.i197.i.i, %B316.i194.i.i ], [ %scevgep.i167.i.i, %switch.end.endif.i.i ]
  %scevgep6.i185.i.i = getelementptr i8, ptr %lsr.iv.i182.i.i, i64 -40
  %.227.i186.i.i = load double, ptr %scevgep6.i185.i.i, align 8, !noalias !96
  %scevgep5.i187.i.i = getelementptr i8, ptr %lsr.iv.i182.i.i, i64 -32
  %.282.i188.i.i = load double, ptr %scevgep5.i187.i.i, align 8, !noalias !96
  %.284.i189.i.i = fmul double %.40.i177.i.i, %.282.i188.i.i
  %.285.i190.i.i = fadd double %.227.i186.i.i, %.284.i189.i.i
  %scevgep4.i191.i.i = getelementptr i8, ptr %lsr.iv.i182.i.i, i64 -24
  %.347.i192.i.i = load double, ptr %scevgep4.i191.i.i, align 8, !noalias !96
  %.348.i193.i.i = fcmp une double %.347.i192.i.i, 0.000000e+00
  br i1 %.348.i193.i.i, label %B134.i199.i.i, label %B316.i194.i.i
B134.i199.i.i:
  %scevgep3.i200.i.i = getelementptr i8, ptr %lsr.iv.i182.i.i, i64 -16
  %.405.i201.i.i = load double, ptr %scevgep3.i200.i.i, align 8, !noalias !96
  %scevgep2.i202.i.i = getelementptr i8, ptr %lsr.iv.i182.i.i, i64 -8
  %.460.i203.i.i = load double, ptr %scevgep2.i202.i.i, align 8, !noalias !96
  %.461.i204.i.i = fmul double %.460.i203.i.i, 5.000000e-01
  %.463.i205.i.i = fmul double %.40.i177.i.i, %.461.i204.i.i
  %.464.i206.i.i = fadd double %.405.i201.i.i, %.463.i205.i.i
  %.465.i207.i.i = fmul double %.464.i206.i.i, 0x401921FB54442D18
  %.467.i208.i.i = fmul double %.40.i177.i.i, %.465.i207.i.i
  %.522.i209.i.i = load double, ptr %lsr.iv.i182.i.i, align 8, !noalias !96
  %.523.i210.i.i = fadd double %.522.i209.i.i, %.467.i208.i.i
  %.586.le.i211.i.i = tail call double @llvm.sin.f64(double %.523.i210.i.i)
  %.591.i212.i.i = fmul double %.347.i192.i.i, %.586.le.i211.i.i
  %.593.i213.i.i = fadd double %.285.i190.i.i, %.591.i212.i.i
  br label %B316.i194.i.i
B316.i194.i.i:
  %value.2.1.i195.i.i = phi double [ %.593.i213.i.i, %B134.i199.i.i ], [ %.285.i190.i.i, %B56.i181.i.i ]
  %30 = shl i64 %lsr.iv.i4.i, 3
  %scevgep445.i.i = getelementptr i8, ptr %.1989.i, i64 %30
  store double %value.2.1.i195.i.i, ptr %scevgep445.i.i, align 8, !noalias !96
  %scevgep1.i197.i.i = getelementptr i8, ptr %lsr.iv.i182.i.i, i64 48
  %lsr.iv.next.i.i = add i64 %lsr.iv.i4.i, 1
  %exitcond.not.i198.i.i = icmp eq i64 %.3015.sroa.13.0.i.i, %lsr.iv.next.i.i
  br i1 %exitcond.not.i198.i.i, label %switch.end.endif.endif.i.i, label %B56.i181.i.i
switch.end.else.endif.if.i.i:
  br label %switch.end.else.endif.endif.endif.i.i
switch.end.else.endif.endif.endif.i.i:
  %.3015.sroa.0.3.i.i = phi i64 [ %.1973.i, %switch.end.else.endif.if.i.i ], [ %.2985.i.i, %switch.lookup.i.i ]
  %.3052.not.i.i = icmp sgt i64 %.1964.i, %.2988.i.i
  br i1 %.3052.not.i.i, label %switch.end.endif.i.i, label %switch.end.else.endif.endif.endif.if.i.i, !prof !31
switch.end.else.endif.endif.endif.if.i.i:
  br label %switch.end.endif.i.i
switch.end.endif.endif.i.i:
  %exitcond.not308.i.i = icmp eq i64 %.2924.i.i, 4
  br i1 %exitcond.not308.i.i, label %B1044.i.i, label %switch.lookup.i.i
B1080.endif.thread.i.i:
  %.3465224.i.i = load i64, ptr %sunkaddr246.i.i, align 8, !noalias !28
  %.3466225.i.i = add nsw i64 %.3465224.i.i, 1
  store i64 %.3466225.i.i, ptr %sunkaddr246.i.i, align 8, !noalias !28
  br label %B1278.i.i
B1080.endif.i.i:
  %.3465.i.i = load i64, ptr %sunkaddr246.i.i, align 8, !noalias !28
  %.3466.i.i = add nsw i64 %.3465.i.i, 1
  store i64 %.3466.i.i, ptr %sunkaddr246.i.i, align 8, !noalias !28
  %.3498.i.i = fcmp ugt double %worst.3.1.i.i.i, 1.000000e+00
  br i1 %.3498.i.i, label %B1278.i.i, label %B1326.i.i
B1520.endif.i.i:
  %.12.i.i.i = fcmp olt double %storemerge.i147228.i.i, 1.000000e-10
  %.13.i151.i.i = select i1 %.12.i.i.i, double 1.000000e-10, double %storemerge.i147228.i.i
  %.17.i.i.i = tail call double @llvm.pow.f64(double %.13.i151.i.i, double -2.500000e-01)
  %.18.i.i.i = fmul double %.17.i.i.i, 9.000000e-01
  %.27.i.i.i = fcmp ogt double %step_before.3.0.i.i, 0.000000e+00
  br i1 %.27.i.i.i, label %B42.endif.i.i.i, label %B1520.endif.endif.endif.i.i
B42.endif.i.i.i:
  %.34.i.i.i = fdiv double %"$phi884.0.2.1.in.sroa.speculated.i.i", %step_before.3.0.i.i
  %.39.i.i.i = fmul double %.34.i.i.i, 9.000000e-01
  %.42.i.i.i = fmul double %.13.i151.i.i, %.13.i151.i.i
  %.49.i.i.i = fdiv double %error_before.2.0.i.i, %.42.i.i.i
  %.52.i.i.i = tail call double @llvm.pow.f64(double %.49.i.i.i, double 2.500000e-01)
  %.53.i.i.i = fmul double %.39.i.i.i, %.52.i.i.i
  %.12.i1.i.i.i = fcmp olt double %.53.i.i.i, %.18.i.i.i
  %.13.i2.i.i.i = select i1 %.12.i1.i.i.i, double %.53.i.i.i, double %.18.i.i.i
  br label %B1520.endif.endif.endif.i.i
B1520.endif.endif.endif.i.i:
  %factor.2.0.i.i.i = phi double [ %.18.i.i.i, %B1520.endif.i.i ], [ %.13.i2.i.i.i, %B42.endif.i.i.i ]
  %.12.i.i215.i.i = fcmp ogt double %factor.2.0.i.i.i, 1.500000e-01
  %.13.i.i216.i.i = select i1 %.12.i.i215.i.i, double %factor.2.0.i.i.i, double 1.500000e-01
  %.12.i3.i.i.i = fcmp olt double %.13.i.i216.i.i, 6.000000e+00
  %.13.i4.i.i.i = select i1 %.12.i3.i.i.i, double %.13.i.i216.i.i, double 6.000000e+00
  %.12.i217.i.i = fcmp ogt double %.13.i151.i.i, 1.000000e-02
  %.13.i218.i.i = select i1 %.12.i217.i.i, double %.13.i151.i.i, double 1.000000e-02
  br i1 %has_changed.3.0.i.i, label %B1654.endif.endif.i.i, label %B1724.i.i
B1654.endif.endif.i.i:
  %.12.i152.i.i = fcmp ogt double %.13.i4.i.i.i, 5.000000e-01
  %.13.i153.i.i = select i1 %.12.i152.i.i, double %.13.i4.i.i.i, double 5.000000e-01
  %.12.i219.i.i = fcmp olt double %.13.i153.i.i, 2.000000e+00
  %.13.i220.i.i = select i1 %.12.i219.i.i, double %.13.i153.i.i, double 2.000000e+00
  %.4213.i.i = fmul double %"$phi884.0.2.1.in.sroa.speculated.i.i", %.13.i220.i.i
  br label %B1724.i.i
B1992.endif.i.i:
  %.12.i158.i.i = fcmp olt double %first.2.1.i.i, %"$phi1818.0.2.1.i.i"
  %.13.i159.i.i = select i1 %.12.i158.i.i, double %first.2.1.i.i, double %"$phi1818.0.2.1.i.i"
  br label %B2254.i.i
for.end.1.i.i:
  br i1 %.3511.le.i.i, label %B2086.endif.i.i, label %B2190.i.i
B2086.endif.i.i:
  %.4723.i.i = tail call double @llvm.pow.f64(double %storemerge.i147227.i.i, double -2.500000e-01)
  %.4726.i.i = fmul double %.4723.i.i, 9.000000e-01
  %.12.i160.i.i = fcmp olt double %.4726.i.i, 8.000000e-01
  %.13.i161.i.i = select i1 %.12.i160.i.i, double %.4726.i.i, double 8.000000e-01
  %.12.i221.i.i = fcmp ogt double %.13.i161.i.i, 1.500000e-01
  %.13.i222.i.i = select i1 %.12.i221.i.i, double %.13.i161.i.i, double 1.500000e-01
  br label %B2190.i.i
B2370.else.if.i.i:
  %.5519.i.i = icmp ne i64 %.114.i.i.i, 0
  %window.3.1.i.i = select i1 %.5519.i.i, double %window.2.0.i.i, double %t.3.1.i.i
  %has_acted.6.1.i.i = select i1 %.5519.i.i, i1 %has_acted.3.1.i.i, i1 false
  %.5588.i.i = fcmp olt double %t.3.1.i.i, %"$phi1578.1.2.1.i"
  br i1 %.5588.i.i, label %B636.i.i, label %_ZN6poppet6engine10integrator8_segmentB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
_ZN6poppet6engine10integrator8_segmentB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i:
  %.5301.sroa.12.2.i = phi double [ %"$phi1800.1.2.1.i", %B622.i.i ], [ %h.7.1.i.i, %B2360.split.loop.exit.i.i ], [ %"$phi884.0.2.1.in.sroa.speculated.i.i", %_ZN6poppet6engine10integrator7_acceptB3v23B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i.i ], [ %.4794.i.i, %B2190.i.i ], [ %h.7.1.i.i, %B44.i.i.i ], [ %h.7.1.i.i, %B2370.else.if.i.i ]
  %.5301.sroa.7.2.i = phi double [ %.4476.i, %B622.i.i ], [ %t.3.1.i.i, %B2360.split.loop.exit.i.i ], [ %reached.3.0.i.i.i, %_ZN6poppet6engine10integrator7_acceptB3v23B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i.i ], [ %t.2.0.i.i, %B2190.i.i ], [ %t.3.1.i.i, %B44.i.i.i ], [ %t.3.1.i.i, %B2370.else.if.i.i ]
  %.5301.sroa.0.2.i = phi i64 [ 0, %B622.i.i ], [ %.mux.le.i.i, %B2360.split.loop.exit.i.i ], [ 1, %_ZN6poppet6engine10integrator7_acceptB3v23B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i.i ], [ 2, %B2190.i.i ], [ 2, %B44.i.i.i ], [ 0, %B2370.else.if.i.i ]
  call void @llvm.lifetime.end.p0(ptr nonnull %.2039.i.i), !noalias !21
  call void @llvm.lifetime.end.p0(ptr nonnull %.4469.i.i), !noalias !21
  %.5681.not.i = icmp eq i64 %.5301.sroa.0.2.i, 0
  br i1 %.5681.not.i, label %B2078.i, label %B2082.i
B1980.i:
  call void @llvm.lifetime.start.p0(ptr nonnull %.273.i.i), !noalias !21
  %scevgep.i14.i.i = getelementptr i8, ptr %.5069.i, i64 40
  %.5.i.i5.i = fmul double %"$phi1578.1.2.1.i", 0x3D06849B86A12B9B
  %.6.i.i6.i = fadd double %.5.i.i5.i, 1.000000e-15
  %.955.i.i = fsub double %"$phi1578.1.2.1.i", %.6.i.i6.i
  br label %B10.i.i
B10.i.i:
  %now.2.0.i.i = phi double [ %.4476.i, %B1980.i ], [ %.13.i.i12.i, %B552.endif.i.i ]
  br i1 %.not.i.i, label %B116.endif.endif.i.i, label %B32.i.i
B32.i.i:
  %.261.i.i = load i64, ptr %sunkaddr26.i.i, align 8, !noalias !99
  call fastcc void @v34(ptr nonnull %.273.i.i, i64 %.261.i.i, double %now.2.0.i.i, double %.4476.i, ptr readonly %.5069.i, ptr %a2, i64 %.1802.i, ptr %.1818.i, ptr %a3, i64 %.1167.i, ptr %.1183.i, ptr %.2332.i, i64 %.3521.i, ptr %.3537.i, ptr %.3708.i, ptr readonly %a13)
  br i1 %64, label %B58.backedge.epil.preheader.i.i.i, label %B58.backedge.i.i.i
B58.backedge.i.i.i:
  %first.2.065.i.i.i = phi double [ %.13.i.3.i.i.i, %B58.backedge.i.i.i ], [ 0x7FF0000000000000, %B32.i.i ]
  %.1096163.i.i.i = phi i64 [ %.116.3.i.i.i, %B58.backedge.i.i.i ], [ 0, %B32.i.i ]
  %sunkaddr.i7.i = shl i64 %.1096163.i.i.i, 3
  %sunkaddr27.i.i = getelementptr i8, ptr %.1183.i, i64 %sunkaddr.i7.i
  %.170.i.i.i = load double, ptr %sunkaddr27.i.i, align 8, !noalias !102
  %.12.i.i.i8.i = fcmp olt double %.170.i.i.i, %first.2.065.i.i.i
  %.13.i.i.i9.i = select i1 %.12.i.i.i8.i, double %.170.i.i.i, double %first.2.065.i.i.i
  %sunkaddr30.i.i = getelementptr i8, ptr %sunkaddr27.i.i, i64 8
  %.170.1.i.i.i = load double, ptr %sunkaddr30.i.i, align 8, !noalias !102
  %.12.i.1.i.i.i = fcmp olt double %.170.1.i.i.i, %.13.i.i.i9.i
  %.13.i.1.i.i.i = select i1 %.12.i.1.i.i.i, double %.170.1.i.i.i, double %.13.i.i.i9.i
  %sunkaddr33.i.i = getelementptr i8, ptr %sunkaddr27.i.i, i64 16
  %.170.2.i.i.i = load double, ptr %sunkaddr33.i.i, align 8, !noalias !102
  %.12.i.2.i.i.i = fcmp olt double %.170.2.i.i.i, %.13.i.1.i.i.i
  %.13.i.2.i.i.i = select i1 %.12.i.2.i.i.i, double %.170.2.i.i.i, double %.13.i.1.i.i.i
  %sunkaddr36.i.i = getelementptr i8, ptr %sunkaddr27.i.i, i64 24
  %.170.3.i.i.i = load double, ptr %sunkaddr36.i.i, align 8, !noalias !102
  %.12.i.3.i.i.i = fcmp olt double %.170.3.i.i.i, %.13.i.2.i.i.i
  %.13.i.3.i.i.i = select i1 %.12.i.3.i.i.i, double %.170.3.i.i.i, double %.13.i.2.i.i.i
  %.116.3.i.i.i = add nuw nsw i64 %.1096163.i.i.i, 4
  %niter.ncmp.3.i.i.i = icmp eq i64 %unroll_iter.i.i.i, %.116.3.i.i.i
  br i1 %niter.ncmp.3.i.i.i, label %common.ret.loopexit.unr-lcssa.i.i.i, label %B58.backedge.i.i.i
common.ret.loopexit.unr-lcssa.i.i.i:
  br i1 %65, label %B116.endif.endif.i.i, label %B58.backedge.epil.preheader.i.i.i
B58.backedge.epil.preheader.i.i.i:
  %first.2.065.epil.init.i.i.i = phi double [ 0x7FF0000000000000, %B32.i.i ], [ %.13.i.3.i.i.i, %common.ret.loopexit.unr-lcssa.i.i.i ]
  %.1096163.epil.init.i.i.i = phi i64 [ 0, %B32.i.i ], [ %unroll_iter.i.i.i, %common.ret.loopexit.unr-lcssa.i.i.i ]
  %31 = shl i64 %.1096163.epil.init.i.i.i, 3
  %scevgep.i.i10.i = getelementptr i8, ptr %.1183.i, i64 %31
  br label %B58.backedge.epil.i.i.i
B58.backedge.epil.i.i.i:
  %first.2.065.epil.i.i.i = phi double [ %.13.i.epil.i.i.i, %B58.backedge.epil.i.i.i ], [ %first.2.065.epil.init.i.i.i, %B58.backedge.epil.preheader.i.i.i ]
  %epil.iter.i.i.i = phi i64 [ %epil.iter.next.i.i.i, %B58.backedge.epil.i.i.i ], [ 0, %B58.backedge.epil.preheader.i.i.i ]
  %32 = shl i64 %epil.iter.i.i.i, 3
  %scevgep40.i.i = getelementptr i8, ptr %scevgep.i.i10.i, i64 %32
  %.170.epil.i.i.i = load double, ptr %scevgep40.i.i, align 8, !noalias !102
  %.12.i.epil.i.i.i = fcmp olt double %.170.epil.i.i.i, %first.2.065.epil.i.i.i
  %.13.i.epil.i.i.i = select i1 %.12.i.epil.i.i.i, double %.170.epil.i.i.i, double %first.2.065.epil.i.i.i
  %epil.iter.next.i.i.i = add i64 %epil.iter.i.i.i, 1
  %epil.iter.cmp.not.i.i.i = icmp eq i64 %xtraiter.i.i.i, %epil.iter.next.i.i.i
  br i1 %epil.iter.cmp.not.i.i.i, label %B116.endif.endif.i.i, label %B58.backedge.epil.i.i.i, !llvm.loop !105
B230.i.i:
  %.481.i.i = icmp slt i64 %.428.i.i, 0
  %.482.i.i = select i1 %.481.i.i, i64 %.71.i, i64 0
  %33 = getelementptr double, ptr %a7, i64 %.428.i.i
  %.496.i.i = getelementptr double, ptr %33, i64 %.482.i.i
  %.497.i.i = load double, ptr %.496.i.i, align 8, !noalias !99
  %.499.i.i = fcmp olt double %.497.i.i, %.13.i.i12.i
  br i1 %.499.i.i, label %B266.i.i, label %B552.endif.i.i
B266.i.i:
  %.533.i.i = phi i64 [ %.791.i.i, %B516.i.i ], [ %.428.i.i, %B230.i.i ]
  %.547.i.i = icmp slt i64 %.533.i.i, 0
  %.548.i.i = select i1 %.547.i.i, i64 %.71.i, i64 0
  %34 = getelementptr double, ptr %a7, i64 %.533.i.i
  %.562.i.i = getelementptr double, ptr %34, i64 %.548.i.i
  %.563.i.i = load double, ptr %.562.i.i, align 8, !noalias !99
  %.40.i.i13.i = fsub double %.563.i.i, %.4476.i
  br i1 %54, label %B266.endif.i.i, label %B56.i.i14.i
B56.i.i14.i:
  %lsr.iv.i.i15.i = phi ptr [ %scevgep1.i.i27.i, %B316.i.i24.i ], [ %scevgep.i14.i.i, %B266.i.i ]
  %.138222224.i.i.i = phi i64 [ %.145.i.i.i, %B316.i.i24.i ], [ 0, %B266.i.i ]
  %.145.i.i.i = add nuw nsw i64 %.138222224.i.i.i, 1
  %scevgep6.i.i16.i = getelementptr i8, ptr %lsr.iv.i.i15.i, i64 -40
  %.227.i.i17.i = load double, ptr %scevgep6.i.i16.i, align 8, !noalias !106
  %scevgep5.i.i18.i = getelementptr i8, ptr %lsr.iv.i.i15.i, i64 -32
  %.282.i.i19.i = load double, ptr %scevgep5.i.i18.i, align 8, !noalias !106
  %.284.i.i20.i = fmul double %.40.i.i13.i, %.282.i.i19.i
  %.285.i.i21.i = fadd double %.227.i.i17.i, %.284.i.i20.i
  %scevgep4.i15.i.i = getelementptr i8, ptr %lsr.iv.i.i15.i, i64 -24
  %.347.i.i22.i = load double, ptr %scevgep4.i15.i.i, align 8, !noalias !106
  %.348.i.i23.i = fcmp une double %.347.i.i22.i, 0.000000e+00
  br i1 %.348.i.i23.i, label %B134.i.i31.i, label %B316.i.i24.i
B134.i.i31.i:
  %scevgep3.i.i32.i = getelementptr i8, ptr %lsr.iv.i.i15.i, i64 -16
  %.405.i.i33.i = load double, ptr %scevgep3.i.i32.i, align 8, !noalias !106
  %scevgep2.i.i.i = getelementptr i8, ptr %lsr.iv.i.i15.i, i64 -8
  %.460.i.i34.i = load double, ptr %scevgep2.i.i.i, align 8, !noalias !106
  %.461.i.i35.i = fmul double %.460.i.i34.i, 5.000000e-01
  %.463.i.i36.i = fmul double %.40.i.i13.i, %.461.i.i35.i
  %.464.i.i37.i = fadd double %.405.i.i33.i, %.463.i.i36.i
  %.465.i.i38.i = fmul double %.464.i.i37.i, 0x401921FB54442D18
  %.467.i.i39.i = fmul double %.40.i.i13.i, %.465.i.i38.i
  %.522.i.i40.i = load double, ptr %lsr.iv.i.i15.i, align 8, !noalias !106
  %.523.i.i41.i = fadd double %.522.i.i40.i, %.467.i.i39.i
  %.586.le.i.i42.i = tail call double @llvm.sin.f64(double %.523.i.i41.i)
  %.591.i.i43.i = fmul double %.347.i.i22.i, %.586.le.i.i42.i
  %.593.i.i44.i = fadd double %.285.i.i21.i, %.591.i.i43.i
  br label %B316.i.i24.i
B316.i.i24.i:
  %value.2.1.i.i25.i = phi double [ %.593.i.i44.i, %B134.i.i31.i ], [ %.285.i.i21.i, %B56.i.i14.i ]
  %35 = shl i64 %.138222224.i.i.i, 3
  %scevgep7.i.i26.i = getelementptr i8, ptr %.1818.i, i64 %35
  store double %value.2.1.i.i25.i, ptr %scevgep7.i.i26.i, align 8, !noalias !106
  %scevgep1.i.i27.i = getelementptr i8, ptr %lsr.iv.i.i15.i, i64 48
  %exitcond.not.i.i28.i = icmp eq i64 %.1793.i, %.145.i.i.i
  br i1 %exitcond.not.i.i28.i, label %B266.endif.loopexit.i.i, label %B56.i.i14.i
B516.i.i:
  %.904.i29.i = icmp slt i64 %.790.i.i, -1
  %.905.i.i = select i1 %.904.i29.i, i64 %.71.i, i64 0
  %36 = getelementptr double, ptr %a7, i64 %.791.i.i
  %.919.i.i = getelementptr double, ptr %36, i64 %.905.i.i
  %.920.i30.i = load double, ptr %.919.i.i, align 8, !noalias !99
  %.922.i.i = fcmp olt double %.920.i30.i, %.13.i.i12.i
  br i1 %.922.i.i, label %B266.i.i, label %B552.endif.i.i
B116.endif.endif.i.i:
  %first.2.0.lcssa.i.i.i = phi double [ 0x7FF0000000000000, %B10.i.i ], [ %.13.i.3.i.i.i, %common.ret.loopexit.unr-lcssa.i.i.i ], [ %.13.i.epil.i.i.i, %B58.backedge.epil.i.i.i ]
  %.12.i.i11.i = fcmp olt double %first.2.0.lcssa.i.i.i, %"$phi1578.1.2.1.i"
  %.13.i.i12.i = select i1 %.12.i.i11.i, double %first.2.0.lcssa.i.i.i, double %"$phi1578.1.2.1.i"
  %.428.i.i = load i64, ptr %sunkaddr37.i.i, align 8, !noalias !99
  %.436.i.i = icmp slt i64 %.428.i.i, %.71.i
  br i1 %.436.i.i, label %B230.i.i, label %B552.endif.i.i
B266.endif.loopexit.i.i:
  %.656.pre.i.i = load i64, ptr %sunkaddr37.i.i, align 8, !noalias !99
  br label %B266.endif.i.i
B266.endif.i.i:
  %.656.i.i = phi i64 [ %.656.pre.i.i, %B266.endif.loopexit.i.i ], [ %.533.i.i, %B266.i.i ]
  %.626.i.i = load i64, ptr %sunkaddr459.i, align 8, !noalias !99
  %.670.i.i = icmp slt i64 %.656.i.i, 0
  %.671.i.i = select i1 %.670.i.i, i64 %.71.i, i64 0
  %37 = getelementptr double, ptr %a7, i64 %.656.i.i
  %.685.i.i = getelementptr double, ptr %37, i64 %.671.i.i
  %.686.i.i = load double, ptr %.685.i.i, align 8, !noalias !99
  store double %.686.i.i, ptr %.2332.i, align 8, !noalias !109
  %.151.i.i.i = inttoptr i64 %.626.i.i to ptr
  tail call void %.151.i.i.i(ptr nonnull %.2332.i, ptr %a2, ptr %.1818.i, ptr %a3, ptr %.3879.i), !noalias !109
  br i1 %66, label %B266.endif.endif.i.i, label %B96.lr.ph.i.i.i
B96.lr.ph.i.i.i:
  br i1 %67, label %B96.epil.preheader.i.i.i, label %B96.lr.ph.new.i.i.i
B96.lr.ph.new.i.i.i:
  %invariant.gep.i.i.i = getelementptr double, ptr %a14, i64 %.656.i.i
  %invariant.gep159.i.i.i = getelementptr double, ptr %invariant.gep.i.i.i, i64 %.671.i.i
  br i1 %68, label %B96.i.epil.preheader.i.i, label %B96.i.i.i
B96.i.i.i:
  %lsr.iv8.i.i = phi i64 [ %lsr.iv.next9.i.i, %B96.i.i.i ], [ %63, %B96.lr.ph.new.i.i.i ]
  %lsr.iv13.i.i.i = phi ptr [ %scevgep63.i.i, %B96.i.i.i ], [ %invariant.gep159.i.i.i, %B96.lr.ph.new.i.i.i ]
  %.259154156.i.i.i = phi i64 [ %.266.3.i.1.i.i, %B96.i.i.i ], [ 0, %B96.lr.ph.new.i.i.i ]
  %sunkaddr40.i.i = shl i64 %.259154156.i.i.i, 3
  %sunkaddr41.i.i = getelementptr i8, ptr %.3879.i, i64 %sunkaddr40.i.i
  %.320.i.i.i = load double, ptr %sunkaddr41.i.i, align 8, !noalias !109
  store double %.320.i.i.i, ptr %lsr.iv13.i.i.i, align 8, !noalias !109
  %sunkaddr44.i.i = getelementptr i8, ptr %sunkaddr41.i.i, i64 8
  %.320.1.i.i.i = load double, ptr %sunkaddr44.i.i, align 8, !noalias !109
  %sunkaddr23.i.i.i = getelementptr i8, ptr %lsr.iv13.i.i.i, i64 %.16.i.i
  store double %.320.1.i.i.i, ptr %sunkaddr23.i.i.i, align 8, !noalias !109
  %sunkaddr47.i.i = getelementptr i8, ptr %sunkaddr41.i.i, i64 16
  %.320.2.i.i.i = load double, ptr %sunkaddr47.i.i, align 8, !noalias !109
  %scevgep57.i.i = getelementptr i8, ptr %sunkaddr23.i.i.i, i64 %.16.i.i
  store double %.320.2.i.i.i, ptr %scevgep57.i.i, align 8, !noalias !109
  %sunkaddr50.i.i = getelementptr i8, ptr %sunkaddr41.i.i, i64 24
  %.320.3.i.i.i = load double, ptr %sunkaddr50.i.i, align 8, !noalias !109
  %scevgep58.i.i = getelementptr i8, ptr %scevgep57.i.i, i64 %.16.i.i
  store double %.320.3.i.i.i, ptr %scevgep58.i.i, align 8, !noalias !109
  %sunkaddr53.i.i = getelementptr i8, ptr %sunkaddr41.i.i, i64 32
  %.320.i.1.i.i = load double, ptr %sunkaddr53.i.i, align 8, !noalias !109
  %scevgep59.i.i = getelementptr i8, ptr %scevgep58.i.i, i64 %.16.i.i
  store double %.320.i.1.i.i, ptr %scevgep59.i.i, align 8, !noalias !109
  %sunkaddr56.i.i = getelementptr i8, ptr %sunkaddr41.i.i, i64 40
  %.320.1.i.1.i.i = load double, ptr %sunkaddr56.i.i, align 8, !noalias !109
  %scevgep60.i.i = getelementptr i8, ptr %scevgep59.i.i, i64 %.16.i.i
  store double %.320.1.i.1.i.i, ptr %scevgep60.i.i, align 8, !noalias !109
  %sunkaddr59.i.i = getelementptr i8, ptr %sunkaddr41.i.i, i64 48
  %.320.2.i.1.i.i = load double, ptr %sunkaddr59.i.i, align 8, !noalias !109
  %scevgep61.i.i = getelementptr i8, ptr %scevgep60.i.i, i64 %.16.i.i
  store double %.320.2.i.1.i.i, ptr %scevgep61.i.i, align 8, !noalias !109
  %.266.3.i.1.i.i = add i64 %.259154156.i.i.i, 8
  %sunkaddr60.i.i = shl i64 %.266.3.i.1.i.i, 3
  %sunkaddr61.i.i = getelementptr i8, ptr %.3879.i, i64 %sunkaddr60.i.i
  %sunkaddr62.i.i = getelementptr i8, ptr %sunkaddr61.i.i, i64 -8
  %.320.3.i.1.i.i = load double, ptr %sunkaddr62.i.i, align 8, !noalias !109
  %scevgep62.i.i = getelementptr i8, ptr %scevgep61.i.i, i64 %.16.i.i
  store double %.320.3.i.1.i.i, ptr %scevgep62.i.i, align 8, !noalias !109
  %scevgep63.i.i = getelementptr i8, ptr %scevgep62.i.i, i64 %.16.i.i
  %lsr.iv.next9.i.i = add i64 %lsr.iv8.i.i, 2
  %niter.ncmp.1.i.i = icmp eq i64 %lsr.iv.next9.i.i, 0
  br i1 %niter.ncmp.1.i.i, label %B126.loopexit.unr-lcssa.i.unr-lcssa.i.i, label %B96.i.i.i
B126.loopexit.unr-lcssa.i.unr-lcssa.i.i:
  %scevgep14.i.i.i = getelementptr i8, ptr %lsr.iv13.i.i.i, i64 %57
  %scevgep14.i.1.i.i = getelementptr i8, ptr %scevgep14.i.i.i, i64 %57
  br i1 %70, label %B96.i.epil.preheader.i.i, label %B126.loopexit.unr-lcssa.i.i.i
B96.i.epil.preheader.i.i:
  %lsr.iv13.i.epil.init.i.i = phi ptr [ %invariant.gep159.i.i.i, %B96.lr.ph.new.i.i.i ], [ %scevgep14.i.1.i.i, %B126.loopexit.unr-lcssa.i.unr-lcssa.i.i ]
  %.259154156.i.epil.init.i.i = phi i64 [ 0, %B96.lr.ph.new.i.i.i ], [ %.266.3.i.1.i.i, %B126.loopexit.unr-lcssa.i.unr-lcssa.i.i ]
  %sunkaddr.i19.epil.i.i = shl i64 %.259154156.i.epil.init.i.i, 3
  %sunkaddr18.i.epil.i.i = getelementptr i8, ptr %.3879.i, i64 %sunkaddr.i19.epil.i.i
  %.320.i.epil.i.i = load double, ptr %sunkaddr18.i.epil.i.i, align 8, !noalias !109
  store double %.320.i.epil.i.i, ptr %lsr.iv13.i.epil.init.i.i, align 8, !noalias !109
  %sunkaddr21.i.epil.i.i = getelementptr i8, ptr %sunkaddr18.i.epil.i.i, i64 8
  %.320.1.i.epil.i.i = load double, ptr %sunkaddr21.i.epil.i.i, align 8, !noalias !109
  %sunkaddr23.i.epil.i.i = getelementptr i8, ptr %lsr.iv13.i.epil.init.i.i, i64 %.16.i.i
  store double %.320.1.i.epil.i.i, ptr %sunkaddr23.i.epil.i.i, align 8, !noalias !109
  %sunkaddr26.i.epil.i.i = getelementptr i8, ptr %sunkaddr18.i.epil.i.i, i64 16
  %.320.2.i.epil.i.i = load double, ptr %sunkaddr26.i.epil.i.i, align 8, !noalias !109
  %scevgep16.i.epil.i.i = getelementptr i8, ptr %lsr.iv13.i.epil.init.i.i, i64 %58
  store double %.320.2.i.epil.i.i, ptr %scevgep16.i.epil.i.i, align 8, !noalias !109
  %sunkaddr29.i.epil.i.i = getelementptr i8, ptr %sunkaddr18.i.epil.i.i, i64 24
  %.320.3.i.epil.i.i = load double, ptr %sunkaddr29.i.epil.i.i, align 8, !noalias !109
  %scevgep15.i.epil.i.i = getelementptr i8, ptr %lsr.iv13.i.epil.init.i.i, i64 %56
  store double %.320.3.i.epil.i.i, ptr %scevgep15.i.epil.i.i, align 8, !noalias !109
  br label %B126.loopexit.unr-lcssa.i.i.i
B126.loopexit.unr-lcssa.i.i.i:
  br i1 %71, label %B266.endif.endif.i.i, label %B96.epil.preheader.i.i.i
B96.epil.preheader.i.i.i:
  %.259154156.epil.init.i.i.i = phi i64 [ %unroll_iter.i17.i.i, %B126.loopexit.unr-lcssa.i.i.i ], [ 0, %B96.lr.ph.i.i.i ]
  %38 = mul i64 %.259154156.epil.init.i.i.i, %.71.i
  %39 = add i64 %.671.i.i, %.656.i.i
  %40 = add i64 %39, %38
  %41 = shl i64 %40, 3
  %scevgep.i22.i.i = getelementptr i8, ptr %a14, i64 %41
  %42 = shl i64 %.259154156.epil.init.i.i.i, 3
  %scevgep3.i23.i.i = getelementptr i8, ptr %.3879.i, i64 %42
  br label %B96.epil.i.i.i
B96.epil.i.i.i:
  %lsr.iv.i24.i.i = phi ptr [ %scevgep2.i28.i.i, %B96.epil.i.i.i ], [ %scevgep.i22.i.i, %B96.epil.preheader.i.i.i ]
  %epil.iter.i25.i.i = phi i64 [ %epil.iter.next.i27.i.i, %B96.epil.i.i.i ], [ 0, %B96.epil.preheader.i.i.i ]
  %43 = shl i64 %epil.iter.i25.i.i, 3
  %scevgep64.i.i = getelementptr i8, ptr %scevgep3.i23.i.i, i64 %43
  %.320.epil.i.i.i = load double, ptr %scevgep64.i.i, align 8, !noalias !109
  store double %.320.epil.i.i.i, ptr %lsr.iv.i24.i.i, align 8, !noalias !109
  %epil.iter.next.i27.i.i = add i64 %epil.iter.i25.i.i, 1
  %scevgep2.i28.i.i = getelementptr i8, ptr %lsr.iv.i24.i.i, i64 %.16.i.i
  %epil.iter.cmp.not.i29.i.i = icmp eq i64 %xtraiter.i16.i.i, %epil.iter.next.i27.i.i
  br i1 %epil.iter.cmp.not.i29.i.i, label %B266.endif.endif.i.i, label %B96.epil.i.i.i, !llvm.loop !112
B266.endif.endif.i.i:
  %.790.i.i = load i64, ptr %sunkaddr37.i.i, align 8, !noalias !99
  %.791.i.i = add nsw i64 %.790.i.i, 1
  store i64 %.791.i.i, ptr %sunkaddr37.i.i, align 8, !noalias !99
  %.859.i.i = icmp slt i64 %.791.i.i, %.71.i
  br i1 %.859.i.i, label %B516.i.i, label %B552.endif.i.i
B552.endif.i.i:
  %.957.i.i = fcmp ult double %.13.i.i12.i, %.955.i.i
  br i1 %.957.i.i, label %B10.i.i, label %_ZN6poppet6engine10integrator20_rows_without_statesB3v32B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i
_ZN6poppet6engine10integrator20_rows_without_statesB3v32B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i:
  call void @llvm.lifetime.end.p0(ptr nonnull %.273.i.i), !noalias !21
  br label %B2078.i
B2078.i:
  %h.4.12968.i = phi double [ %"$phi1800.1.2.1.i", %_ZN6poppet6engine10integrator20_rows_without_statesB3v32B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i ], [ %.5301.sroa.12.2.i, %_ZN6poppet6engine10integrator8_segmentB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ]
  %t.6.12967.i = phi double [ %"$phi1578.1.2.1.i", %_ZN6poppet6engine10integrator20_rows_without_statesB3v32B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i ], [ %.5301.sroa.7.2.i, %_ZN6poppet6engine10integrator8_segmentB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ]
  %exitcond3048.not.i = icmp eq i64 %.4412.i, %.33.i
  br i1 %exitcond3048.not.i, label %B2082.i, label %B1500.i
B2082.i:
  %status.5.1.i = phi i64 [ 0, %B1412.endif.i ], [ 1, %B1592.endif.endif.i ], [ %.5301.sroa.0.2.i, %_ZN6poppet6engine10integrator8_segmentB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ], [ 0, %B2078.i ]
  %t.4.1.i = phi double [ %.4281.i, %B1412.endif.i ], [ %.4476.i, %B1592.endif.endif.i ], [ %.5301.sroa.7.2.i, %_ZN6poppet6engine10integrator8_segmentB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ], [ %t.6.12967.i, %B2078.i ]
  %k.2.1.i = phi i64 [ 0, %B1412.endif.i ], [ %.440530183025.i, %B1592.endif.endif.i ], [ %.440530183025.i, %_ZN6poppet6engine10integrator8_segmentB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ], [ %.440530183025.i, %B2078.i ]
  %switch.i = icmp ult i64 %status.5.1.i, 2
  br i1 %switch.i, label %B2126.i, label %_ZN6poppet6engine10integrator9integrateB2v1B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAg6cJqBrMeIZJFEGM0QQAE8int64_2a8int64_2a10float64_2a10float64_2a10float64_2a10float64_2a8uint8_2a10float64_2a10float64_2a8uint8_2a10float64_2a8int64_2a10float64_2a8uint8_2a10float64_2a10float64_2a10float64_2a8int64_2a10float64_2a10float64_2a.exit
B2126.i:
  %44 = getelementptr double, ptr %a4, i64 %k.2.1.i
  %.5972.i = load double, ptr %44, align 8, !noalias !21
  %.40.i7.i = fsub double %t.4.1.i, %.5972.i
  %.132223.not.i8.i = icmp slt i64 %.1793.i, 1
  br i1 %.132223.not.i8.i, label %B2126.endif.endif.i, label %B56.preheader.i9.i
B56.preheader.i9.i:
  %.6028.i = mul i64 %k.2.1.i, %.1274.i
  %.6030.i = getelementptr double, ptr %a5, i64 %.6028.i
  %scevgep.i10.i = getelementptr i8, ptr %.6030.i, i64 40
  br label %B56.i11.i
B56.i11.i:
  %lsr.iv432.i = phi i64 [ %lsr.iv.next433.i, %B316.i24.i ], [ %.1705.sroa.0.3.i, %B56.preheader.i9.i ]
  %lsr.iv.i12.i = phi ptr [ %scevgep1.i27.i, %B316.i24.i ], [ %scevgep.i10.i, %B56.preheader.i9.i ]
  %scevgep6.i15.i = getelementptr i8, ptr %lsr.iv.i12.i, i64 -40
  %.227.i16.i = load double, ptr %scevgep6.i15.i, align 8, !noalias !113
  %scevgep5.i17.i = getelementptr i8, ptr %lsr.iv.i12.i, i64 -32
  %.282.i18.i = load double, ptr %scevgep5.i17.i, align 8, !noalias !113
  %.284.i19.i = fmul double %.40.i7.i, %.282.i18.i
  %.285.i20.i = fadd double %.227.i16.i, %.284.i19.i
  %scevgep4.i21.i = getelementptr i8, ptr %lsr.iv.i12.i, i64 -24
  %.347.i22.i = load double, ptr %scevgep4.i21.i, align 8, !noalias !113
  %.348.i23.i = fcmp une double %.347.i22.i, 0.000000e+00
  br i1 %.348.i23.i, label %B134.i29.i, label %B316.i24.i
B134.i29.i:
  %scevgep3.i30.i = getelementptr i8, ptr %lsr.iv.i12.i, i64 -16
  %.405.i31.i = load double, ptr %scevgep3.i30.i, align 8, !noalias !113
  %scevgep2.i32.i = getelementptr i8, ptr %lsr.iv.i12.i, i64 -8
  %.460.i33.i = load double, ptr %scevgep2.i32.i, align 8, !noalias !113
  %.461.i34.i = fmul double %.460.i33.i, 5.000000e-01
  %.463.i35.i = fmul double %.40.i7.i, %.461.i34.i
  %.464.i36.i = fadd double %.405.i31.i, %.463.i35.i
  %.465.i37.i = fmul double %.464.i36.i, 0x401921FB54442D18
  %.467.i38.i = fmul double %.40.i7.i, %.465.i37.i
  %.522.i39.i = load double, ptr %lsr.iv.i12.i, align 8, !noalias !113
  %.523.i40.i = fadd double %.522.i39.i, %.467.i38.i
  %.586.le.i41.i = tail call double @llvm.sin.f64(double %.523.i40.i)
  %.591.i42.i = fmul double %.347.i22.i, %.586.le.i41.i
  %.593.i43.i = fadd double %.285.i20.i, %.591.i42.i
  br label %B316.i24.i
B316.i24.i:
  %value.2.1.i25.i = phi double [ %.593.i43.i, %B134.i29.i ], [ %.285.i20.i, %B56.i11.i ]
  %45 = shl i64 %lsr.iv432.i, 3
  %scevgep434.i = getelementptr i8, ptr %.1633.i, i64 %45
  store double %value.2.1.i25.i, ptr %scevgep434.i, align 8, !noalias !113
  %scevgep1.i27.i = getelementptr i8, ptr %lsr.iv.i12.i, i64 48
  %lsr.iv.next433.i = add nuw i64 %lsr.iv432.i, 1
  %exitcond.not.i28.i = icmp eq i64 %.1705.sroa.13.0.i, %lsr.iv.next433.i
  br i1 %exitcond.not.i28.i, label %B2126.endif.endif.i, label %B56.i11.i
B0.endif.endif.endif.endi...else.if.i:
  br label %B0.endif.endif.endif.endi...else.endif.i
B0.endif.endif.endif.endi...else.endif.i:
  %.1070.sroa.0.1.i = phi i64 [ 0, %B0.endif.endif.endif.endi...else.if.i ], [ %.1082.i, %0 ]
  %.1090.not.i = icmp slt i64 %.1082.i, %.933.i
  br i1 %.1090.not.i, label %B0.endif.endif.endif.endi...endif.3.endif.endif.else.i, label %B0.endif.endif.endif.endi...else.endif.if.i, !prof !31
B0.endif.endif.endif.endi...else.endif.if.i:
  br label %B0.endif.endif.endif.endi...endif.3.endif.endif.else.i
B0.endif.endif.endif.endi...endif.3.endif.endif.else.i:
  %.1070.sroa.0.3.i = phi i64 [ %.933.i, %B0.endif.endif.endif.endi...else.endif.if.i ], [ %.1070.sroa.0.1.i, %B0.endif.endif.endif.endi...else.endif.i ]
  %.1158.i = sub i64 %.933.i, %.1070.sroa.0.3.i
  %.1167.i = tail call i64 @llvm.smax.i64(i64 %.1158.i, i64 0)
  %.1183.i = getelementptr double, ptr %a3, i64 %.1070.sroa.0.3.i
  %.1273.i = mul nsw i64 %.25.i, 12
  %.1274.i = mul i64 %.29.i, 6
  %.1275.i = or i64 %.1273.i, 2
  %.1276.i = add i64 %.1275.i, %.1274.i
  %.1277.i = add i64 %.1276.i, %.31.i
  %.1278.i = add nsw i64 %.1277.i, %.75.i
  %.1279.i = add nsw i64 %.1278.i, %.77.i
  %.1280.i = add nsw i64 %.1279.i, %.111.i
  %.1281.i = add nsw i64 %.1280.i, %.113.i
  %.1368.i = icmp slt i64 %.1281.i, 1
  br i1 %.1368.i, label %B0.endif.endif.endif.endi...endif.4.if.i, label %B0.endif.endif.endif.endi...endif.4.endif.i, !prof !24
B0.endif.endif.endif.endi...endif.4.if.i:
  br label %B0.endif.endif.endif.endi...endif.4.endif.i
B0.endif.endif.endif.endi...endif.4.endif.i:
  %.1348.sroa.0.3.i = phi i64 [ %.1281.i, %B0.endif.endif.endif.endi...endif.4.if.i ], [ 0, %B0.endif.endif.endif.endi...endif.3.endif.endif.else.i ]
  %.1375.i = icmp slt i64 %.25.i, 0
  %.1376.i = select i1 %.1375.i, i64 %.1281.i, i64 0
  %.1377.i = add i64 %.1376.i, %.1273.i
  %.1380.i = icmp slt i64 %.1377.i, 0
  br i1 %.1380.i, label %B0.endif.endif.endif.endi...endif.4.endif.if.i, label %B0.endif.endif.endif.endi...endif.4.endif.endif.i, !prof !24
B0.endif.endif.endif.endi...endif.4.endif.if.i:
  br label %B0.endif.endif.endif.endi...endif.4.endif.endif.i
B0.endif.endif.endif.endi...endif.4.endif.endif.i:
  %.1348.sroa.13.1.i = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.4.endif.if.i ], [ %.1377.i, %B0.endif.endif.endif.endi...endif.4.endif.i ]
  %.1385.not.i = icmp slt i64 %.1377.i, %.1281.i
  br i1 %.1385.not.i, label %B0.endif.endif.endif.endi...else.1.i, label %B0.endif.endif.endif.endi...endif.4.endif.endif.if.i, !prof !31
B0.endif.endif.endif.endi...endif.4.endif.endif.if.i:
  br label %B0.endif.endif.endif.endi...else.1.i
B0.endif.endif.endif.endi...else.1.i:
  %.1348.sroa.13.0.i = phi i64 [ %.1348.sroa.13.1.i, %B0.endif.endif.endif.endi...endif.4.endif.endif.i ], [ %.1281.i, %B0.endif.endif.endif.endi...endif.4.endif.endif.if.i ]
  %.1436.i = sub i64 %.1348.sroa.13.0.i, %.1348.sroa.0.3.i
  %.1445.i = tail call i64 @llvm.smax.i64(i64 %.1436.i, i64 0)
  %.1461.i = getelementptr double, ptr %a18, i64 %.1348.sroa.0.3.i
  br i1 %.1380.i, label %B0.endif.endif.endif.endi...else.1.if.i, label %B0.endif.endif.endif.endi...else.1.endif.i, !prof !24
B0.endif.endif.endif.endi...else.1.if.i:
  br label %B0.endif.endif.endif.endi...else.1.endif.i
B0.endif.endif.endif.endi...else.1.endif.i:
  %.1520.sroa.0.1.i = phi i64 [ 0, %B0.endif.endif.endif.endi...else.1.if.i ], [ %.1377.i, %B0.endif.endif.endif.endi...else.1.i ]
  br i1 %.1385.not.i, label %B0.endif.endif.endif.endi...endif.6.else.i, label %B0.endif.endif.endif.endi...else.1.endif.if.i, !prof !31
B0.endif.endif.endif.endi...else.1.endif.if.i:
  br label %B0.endif.endif.endif.endi...endif.6.else.i
B0.endif.endif.endif.endi...endif.6.else.i:
  %.1520.sroa.0.3.i = phi i64 [ %.1281.i, %B0.endif.endif.endif.endi...else.1.endif.if.i ], [ %.1520.sroa.0.1.i, %B0.endif.endif.endif.endi...else.1.endif.i ]
  %.1608.i = sub i64 %.1281.i, %.1520.sroa.0.3.i
  %.1617.i = tail call i64 @llvm.smax.i64(i64 %.1608.i, i64 0)
  %.1633.i = getelementptr double, ptr %a18, i64 %.1520.sroa.0.3.i
  %.1725.i = icmp slt i64 %.1608.i, 1
  br i1 %.1725.i, label %B0.endif.endif.endif.endi...endif.6.else.endif.if.i, label %B0.endif.endif.endif.endi...endif.6.else.endif.endif.i, !prof !24
B0.endif.endif.endif.endi...endif.6.else.endif.if.i:
  br label %B0.endif.endif.endif.endi...endif.6.else.endif.endif.i
B0.endif.endif.endif.endi...endif.6.else.endif.endif.i:
  %.1705.sroa.0.3.i = phi i64 [ %.1617.i, %B0.endif.endif.endif.endi...endif.6.else.endif.if.i ], [ 0, %B0.endif.endif.endif.endi...endif.6.else.i ]
  %.1732.i = icmp slt i64 %.29.i, 0
  %.1733.i = select i1 %.1732.i, i64 %.1617.i, i64 0
  %.1734.i = add i64 %.1733.i, %.29.i
  %.1737.i = icmp slt i64 %.1734.i, 0
  br i1 %.1737.i, label %B0.endif.endif.endif.endi...if.8.i, label %B0.endif.endif.endif.endi...endif.8.i, !prof !24
B0.endif.endif.endif.endi...if.8.i:
  br label %B0.endif.endif.endif.endi...endif.8.i
B0.endif.endif.endif.endi...endif.8.i:
  %.1705.sroa.13.1.i = phi i64 [ 0, %B0.endif.endif.endif.endi...if.8.i ], [ %.1734.i, %B0.endif.endif.endif.endi...endif.6.else.endif.endif.i ]
  %.1742.not.i = icmp slt i64 %.1734.i, %.1617.i
  br i1 %.1742.not.i, label %B0.endif.endif.endif.endi...endif.6.endif.else.i, label %B0.endif.endif.endif.endi...endif.8.if.i, !prof !31
B0.endif.endif.endif.endi...endif.8.if.i:
  br label %B0.endif.endif.endif.endi...endif.6.endif.else.i
B0.endif.endif.endif.endi...endif.6.endif.else.i:
  %.1705.sroa.13.0.i = phi i64 [ %.1705.sroa.13.1.i, %B0.endif.endif.endif.endi...endif.8.i ], [ %.1617.i, %B0.endif.endif.endif.endi...endif.8.if.i ]
  %.1793.i = sub nsw i64 %.1705.sroa.13.0.i, %.1705.sroa.0.3.i
  %.1802.i = tail call i64 @llvm.smax.i64(i64 %.1793.i, i64 0)
  %.1818.i = getelementptr double, ptr %.1633.i, i64 %.1705.sroa.0.3.i
  %.1850.i = mul nsw i64 %.29.i, 5
  br i1 %.1737.i, label %B0.endif.endif.endif.endi...endif.6.endif.else.if.i, label %B0.endif.endif.endif.endi...endif.6.endif.else.endif.i, !prof !24
B0.endif.endif.endif.endi...endif.6.endif.else.if.i:
  br label %B0.endif.endif.endif.endi...endif.6.endif.else.endif.i
B0.endif.endif.endif.endi...endif.6.endif.else.endif.i:
  %.1876.sroa.0.1.i = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.6.endif.else.if.i ], [ %.1734.i, %B0.endif.endif.endif.endi...endif.6.endif.else.i ]
  br i1 %.1742.not.i, label %B0.endif.endif.endif.endi...endif.10.i, label %B0.endif.endif.endif.endi...if.10.i, !prof !31
B0.endif.endif.endif.endi...if.10.i:
  br label %B0.endif.endif.endif.endi...endif.10.i
B0.endif.endif.endif.endi...endif.10.i:
  %.1876.sroa.0.3.i = phi i64 [ %.1617.i, %B0.endif.endif.endif.endi...if.10.i ], [ %.1876.sroa.0.1.i, %B0.endif.endif.endif.endi...endif.6.endif.else.endif.i ]
  %.1905.i = add i64 %.1733.i, %.1850.i
  %.1908.i = icmp slt i64 %.1905.i, 0
  br i1 %.1908.i, label %B0.endif.endif.endif.endi...endif.10.if.i, label %B0.endif.endif.endif.endi...endif.10.endif.i, !prof !24
B0.endif.endif.endif.endi...endif.10.if.i:
  br label %B0.endif.endif.endif.endi...endif.10.endif.i
B0.endif.endif.endif.endi...endif.10.endif.i:
  %.1876.sroa.13.1.i = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.10.if.i ], [ %.1905.i, %B0.endif.endif.endif.endi...endif.10.i ]
  %.1913.not.i = icmp slt i64 %.1905.i, %.1617.i
  br i1 %.1913.not.i, label %B0.endif.endif.endif.endi...endif.6.endif.endif.else.i, label %B0.endif.endif.endif.endi...endif.10.endif.if.i, !prof !31
B0.endif.endif.endif.endi...endif.10.endif.if.i:
  br label %B0.endif.endif.endif.endi...endif.6.endif.endif.else.i
B0.endif.endif.endif.endi...endif.6.endif.endif.else.i:
  %.1876.sroa.13.0.i = phi i64 [ %.1876.sroa.13.1.i, %B0.endif.endif.endif.endi...endif.10.endif.i ], [ %.1617.i, %B0.endif.endif.endif.endi...endif.10.endif.if.i ]
  %.1964.i = sub nsw i64 %.1876.sroa.13.0.i, %.1876.sroa.0.3.i
  %.1973.i = tail call i64 @llvm.smax.i64(i64 %.1964.i, i64 0)
  %.1989.i = getelementptr double, ptr %.1633.i, i64 %.1876.sroa.0.3.i
  br i1 %.1908.i, label %B0.endif.endif.endif.endi...if.12.i, label %B0.endif.endif.endif.endi...endif.12.i, !prof !24
B0.endif.endif.endif.endi...if.12.i:
  br label %B0.endif.endif.endif.endi...endif.12.i
B0.endif.endif.endif.endi...endif.12.i:
  %.2048.sroa.0.1.i = phi i64 [ 0, %B0.endif.endif.endif.endi...if.12.i ], [ %.1905.i, %B0.endif.endif.endif.endi...endif.6.endif.endif.else.i ]
  br i1 %.1913.not.i, label %B0.endif.endif.endif.endi...endif.12.endif.i, label %B0.endif.endif.endif.endi...endif.12.if.i, !prof !31
B0.endif.endif.endif.endi...endif.12.if.i:
  br label %B0.endif.endif.endif.endi...endif.12.endif.i
B0.endif.endif.endif.endi...endif.12.endif.i:
  %.2048.sroa.0.3.i = phi i64 [ %.1617.i, %B0.endif.endif.endif.endi...endif.12.if.i ], [ %.2048.sroa.0.1.i, %B0.endif.endif.endif.endi...endif.12.i ]
  %.2077.i = add i64 %.1733.i, %.1274.i
  %.2080.i = icmp slt i64 %.2077.i, 0
  br i1 %.2080.i, label %B0.endif.endif.endif.endi...endif.12.endif.if.i, label %B0.endif.endif.endif.endi...endif.12.endif.endif.i, !prof !24
B0.endif.endif.endif.endi...endif.12.endif.if.i:
  br label %B0.endif.endif.endif.endi...endif.12.endif.endif.i
B0.endif.endif.endif.endi...endif.12.endif.endif.i:
  %.2048.sroa.13.1.i = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.12.endif.if.i ], [ %.2077.i, %B0.endif.endif.endif.endi...endif.12.endif.i ]
  %.2085.not.i = icmp slt i64 %.2077.i, %.1617.i
  br i1 %.2085.not.i, label %B0.endif.endif.endif.endi...else.2.i, label %B0.endif.endif.endif.endi...endif.12.endif.endif.if.i, !prof !31
B0.endif.endif.endif.endi...endif.12.endif.endif.if.i:
  br label %B0.endif.endif.endif.endi...else.2.i
B0.endif.endif.endif.endi...else.2.i:
  %.2048.sroa.13.0.i = phi i64 [ %.2048.sroa.13.1.i, %B0.endif.endif.endif.endi...endif.12.endif.endif.i ], [ %.1617.i, %B0.endif.endif.endif.endi...endif.12.endif.endif.if.i ]
  %.2136.i = sub nsw i64 %.2048.sroa.13.0.i, %.2048.sroa.0.3.i
  %.2161.i = getelementptr double, ptr %.1633.i, i64 %.2048.sroa.0.3.i
  br i1 %.2080.i, label %B0.endif.endif.endif.endi...else.2.if.i, label %B0.endif.endif.endif.endi...else.2.endif.i, !prof !24
B0.endif.endif.endif.endi...else.2.if.i:
  br label %B0.endif.endif.endif.endi...else.2.endif.i
B0.endif.endif.endif.endi...else.2.endif.i:
  %.2219.sroa.0.1.i = phi i64 [ 0, %B0.endif.endif.endif.endi...else.2.if.i ], [ %.2077.i, %B0.endif.endif.endif.endi...else.2.i ]
  br i1 %.2085.not.i, label %B0.endif.endif.endif.endi...endif.14.else.endif.i, label %B0.endif.endif.endif.endi...else.2.endif.if.i, !prof !31
B0.endif.endif.endif.endi...else.2.endif.if.i:
  br label %B0.endif.endif.endif.endi...endif.14.else.endif.i
B0.endif.endif.endif.endi...endif.14.else.endif.i:
  %.2219.sroa.0.3.i = phi i64 [ %.1617.i, %B0.endif.endif.endif.endi...else.2.endif.if.i ], [ %.2219.sroa.0.1.i, %B0.endif.endif.endif.endi...else.2.endif.i ]
  %.2307.i = sub nsw i64 %.1617.i, %.2219.sroa.0.3.i
  %.2316.i = tail call i64 @llvm.smax.i64(i64 %.2307.i, i64 0)
  %.2332.i = getelementptr double, ptr %.1633.i, i64 %.2219.sroa.0.3.i
  %.26753050.i = add nsw i64 %.75.i, 2
  %46 = tail call i64 @llvm.umin.i64(i64 %.2316.i, i64 2)
  %.2728.i = icmp slt i64 %.75.i, -2
  %.2729.i = select i1 %.2728.i, i64 %.2316.i, i64 0
  %.2730.i = add i64 %.26753050.i, %.2729.i
  %.2733.i = icmp slt i64 %.2730.i, 0
  %.2738.not.i = icmp slt i64 %.2730.i, %.2316.i
  %.2814.i = getelementptr double, ptr %.2332.i, i64 %46
  br i1 %.2733.i, label %B0.endif.endif.endif.endi...if.21.i, label %B0.endif.endif.endif.endi...endif.21.i, !prof !24
B0.endif.endif.endif.endi...if.21.i:
  br label %B0.endif.endif.endif.endi...endif.21.i
B0.endif.endif.endif.endi...endif.21.i:
  %.2872.sroa.0.1.i = phi i64 [ 0, %B0.endif.endif.endif.endi...if.21.i ], [ %.2730.i, %B0.endif.endif.endif.endi...endif.14.else.endif.i ]
  br i1 %.2738.not.i, label %B0.endif.endif.endif.endi...else.3.i, label %B0.endif.endif.endif.endi...endif.21.if.i, !prof !31
B0.endif.endif.endif.endi...endif.21.if.i:
  br label %B0.endif.endif.endif.endi...else.3.i
B0.endif.endif.endif.endi...else.3.i:
  %.2872.sroa.0.3.i = phi i64 [ %.2316.i, %B0.endif.endif.endif.endi...endif.21.if.i ], [ %.2872.sroa.0.1.i, %B0.endif.endif.endif.endi...endif.21.i ]
  %.2960.i = sub nsw i64 %.2316.i, %.2872.sroa.0.3.i
  %.2969.i = tail call i64 @llvm.smax.i64(i64 %.2960.i, i64 0)
  %.2985.i = getelementptr double, ptr %.2332.i, i64 %.2872.sroa.0.3.i
  %.3089.i = icmp slt i64 %.2960.i, 1
  br i1 %.3089.i, label %B0.endif.endif.endif.endi...else.3.endif.if.i, label %B0.endif.endif.endif.endi...else.3.endif.endif.i, !prof !24
B0.endif.endif.endif.endi...else.3.endif.if.i:
  br label %B0.endif.endif.endif.endi...else.3.endif.endif.i
B0.endif.endif.endif.endi...else.3.endif.endif.i:
  %.3069.sroa.0.3.i = phi i64 [ %.2969.i, %B0.endif.endif.endif.endi...else.3.endif.if.i ], [ 0, %B0.endif.endif.endif.endi...else.3.i ]
  %.3096.i = icmp slt i64 %.77.i, 0
  %.3097.i = select i1 %.3096.i, i64 %.2969.i, i64 0
  %.3098.i = add i64 %.3097.i, %.77.i
  %.3101.i = icmp slt i64 %.3098.i, 0
  %.3106.not.i = icmp slt i64 %.3098.i, %.2969.i
  %.3182.i = getelementptr double, ptr %.2985.i, i64 %.3069.sroa.0.3.i
  br i1 %.3101.i, label %B0.endif.endif.endif.endi...endif.23.else.if.i, label %B0.endif.endif.endif.endi...endif.23.else.endif.i, !prof !24
B0.endif.endif.endif.endi...endif.23.else.if.i:
  br label %B0.endif.endif.endif.endi...endif.23.else.endif.i
B0.endif.endif.endif.endi...endif.23.else.endif.i:
  %.3239.sroa.0.1.i = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.23.else.if.i ], [ %.3098.i, %B0.endif.endif.endif.endi...else.3.endif.endif.i ]
  br i1 %.3106.not.i, label %B0.endif.endif.endif.endi...endif.23.endif.else.i, label %B0.endif.endif.endif.endi...endif.23.else.endif.if.i, !prof !31
B0.endif.endif.endif.endi...endif.23.else.endif.if.i:
  br label %B0.endif.endif.endif.endi...endif.23.endif.else.i
B0.endif.endif.endif.endi...endif.23.endif.else.i:
  %.3239.sroa.0.3.i = phi i64 [ %.2969.i, %B0.endif.endif.endif.endi...endif.23.else.endif.if.i ], [ %.3239.sroa.0.1.i, %B0.endif.endif.endif.endi...endif.23.else.endif.i ]
  %.3327.i = sub nsw i64 %.2969.i, %.3239.sroa.0.3.i
  %.3336.i = tail call i64 @llvm.smax.i64(i64 %.3327.i, i64 0)
  %.3352.i = getelementptr double, ptr %.2985.i, i64 %.3239.sroa.0.3.i
  %.3444.i = icmp slt i64 %.3327.i, 1
  br i1 %.3444.i, label %B0.endif.endif.endif.endi...if.28.i, label %B0.endif.endif.endif.endi...endif.28.i, !prof !24
B0.endif.endif.endif.endi...if.28.i:
  br label %B0.endif.endif.endif.endi...endif.28.i
B0.endif.endif.endif.endi...endif.28.i:
  %.3424.sroa.0.3.i = phi i64 [ %.3336.i, %B0.endif.endif.endif.endi...if.28.i ], [ 0, %B0.endif.endif.endif.endi...endif.23.endif.else.i ]
  %.3451.i = icmp slt i64 %.113.i, 0
  %.3452.i = select i1 %.3451.i, i64 %.3336.i, i64 0
  %.3453.i = add i64 %.3452.i, %.113.i
  %.3456.i = icmp slt i64 %.3453.i, 0
  br i1 %.3456.i, label %B0.endif.endif.endif.endi...endif.28.if.i, label %B0.endif.endif.endif.endi...endif.28.endif.i, !prof !24
B0.endif.endif.endif.endi...endif.28.if.i:
  br label %B0.endif.endif.endif.endi...endif.28.endif.i
B0.endif.endif.endif.endi...endif.28.endif.i:
  %.3424.sroa.13.1.i = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.28.if.i ], [ %.3453.i, %B0.endif.endif.endif.endi...endif.28.i ]
  %.3461.not.i = icmp slt i64 %.3453.i, %.3336.i
  br i1 %.3461.not.i, label %B0.endif.endif.endif.endi...endif.23.endif.endif.else.i, label %B0.endif.endif.endif.endi...endif.28.endif.if.i, !prof !31
B0.endif.endif.endif.endi...endif.28.endif.if.i:
  br label %B0.endif.endif.endif.endi...endif.23.endif.endif.else.i
B0.endif.endif.endif.endi...endif.23.endif.endif.else.i:
  %.3424.sroa.13.0.i = phi i64 [ %.3424.sroa.13.1.i, %B0.endif.endif.endif.endi...endif.28.endif.i ], [ %.3336.i, %B0.endif.endif.endif.endi...endif.28.endif.if.i ]
  %.3512.i = sub nsw i64 %.3424.sroa.13.0.i, %.3424.sroa.0.3.i
  %.3521.i = tail call i64 @llvm.smax.i64(i64 %.3512.i, i64 0)
  %.3537.i = getelementptr double, ptr %.3352.i, i64 %.3424.sroa.0.3.i
  %.3569.i = add nsw i64 %.113.i, %.111.i
  br i1 %.3456.i, label %B0.endif.endif.endif.endi...if.30.i, label %B0.endif.endif.endif.endi...endif.30.i, !prof !24
B0.endif.endif.endif.endi...if.30.i:
  br label %B0.endif.endif.endif.endi...endif.30.i
B0.endif.endif.endif.endi...endif.30.i:
  %.3595.sroa.0.1.i = phi i64 [ 0, %B0.endif.endif.endif.endi...if.30.i ], [ %.3453.i, %B0.endif.endif.endif.endi...endif.23.endif.endif.else.i ]
  br i1 %.3461.not.i, label %B0.endif.endif.endif.endi...endif.30.endif.i, label %B0.endif.endif.endif.endi...endif.30.if.i, !prof !31
B0.endif.endif.endif.endi...endif.30.if.i:
  br label %B0.endif.endif.endif.endi...endif.30.endif.i
B0.endif.endif.endif.endi...endif.30.endif.i:
  %.3595.sroa.0.3.i = phi i64 [ %.3336.i, %B0.endif.endif.endif.endi...endif.30.if.i ], [ %.3595.sroa.0.1.i, %B0.endif.endif.endif.endi...endif.30.i ]
  %.3622.i = icmp slt i64 %.3569.i, 0
  %.3623.i = select i1 %.3622.i, i64 %.3336.i, i64 0
  %.3624.i = add i64 %.3623.i, %.3569.i
  %.3627.i = icmp slt i64 %.3624.i, 0
  %.3632.not.i = icmp slt i64 %.3624.i, %.3336.i
  %.3708.i = getelementptr double, ptr %.3352.i, i64 %.3595.sroa.0.3.i
  br i1 %.3627.i, label %B0.endif.endif.endif.endi...else.4.if.i, label %B0.endif.endif.endif.endi...else.4.endif.i, !prof !24
B0.endif.endif.endif.endi...else.4.if.i:
  br label %B0.endif.endif.endif.endi...else.4.endif.i
B0.endif.endif.endif.endi...else.4.endif.i:
  %.3766.sroa.0.1.i = phi i64 [ 0, %B0.endif.endif.endif.endi...else.4.if.i ], [ %.3624.i, %B0.endif.endif.endif.endi...endif.30.endif.i ]
  br i1 %.3632.not.i, label %B0.endif.endif.endif.endi...endif.32.endif.i, label %B0.endif.endif.endif.endi...else.4.endif.if.i, !prof !31
B0.endif.endif.endif.endi...else.4.endif.if.i:
  br label %B0.endif.endif.endif.endi...endif.32.endif.i
B0.endif.endif.endif.endi...endif.32.endif.i:
  %.3766.sroa.0.3.i = phi i64 [ %.3336.i, %B0.endif.endif.endif.endi...else.4.endif.if.i ], [ %.3766.sroa.0.1.i, %B0.endif.endif.endif.endi...else.4.endif.i ]
  %.3854.i = sub nsw i64 %.3336.i, %.3766.sroa.0.3.i
  %.3863.i = tail call i64 @llvm.smax.i64(i64 %.3854.i, i64 0)
  %.3879.i = getelementptr double, ptr %.3352.i, i64 %.3766.sroa.0.3.i
  %.40243008.not.i = icmp slt i64 %.25.i, 1
  br i1 %.40243008.not.i, label %B1412.endif.i, label %B1334.lr.ph.i
B1334.lr.ph.i:
  %invariant.gep.i = getelementptr double, ptr %a15, i64 %.25.i
  %.idx.i = shl i64 %.25.i, 4
  %invariant.gep3071.i = getelementptr i8, ptr %a15, i64 %.idx.i
  %47 = icmp eq i64 %.25.i, 1
  br i1 %47, label %B1334.epil.preheader.i, label %B1334.lr.ph.new.i
B1334.lr.ph.new.i:
  %unroll_iter.i = and i64 %.25.i, 9223372036854775806
  %scevgep438.i = getelementptr i8, ptr %a2, i64 8
  %scevgep442.i = getelementptr i8, ptr %a15, i64 8
  %sunkaddr.i = shl i64 %.25.i, 3
  br label %B1334.i
B1412.endif.loopexit.unr-lcssa.i:
  %48 = and i64 %.25.i, 1
  %lcmp.mod.not.i = icmp eq i64 %48, 0
  br i1 %lcmp.mod.not.i, label %B1412.endif.i, label %B1334.epil.preheader.i
B1334.epil.preheader.i:
  %.403030073009.epil.init.i = phi i64 [ 0, %B1334.lr.ph.i ], [ %unroll_iter.i, %B1412.endif.loopexit.unr-lcssa.i ]
  %49 = getelementptr double, ptr %a2, i64 %.403030073009.epil.init.i
  %.4091.epil.i = load double, ptr %49, align 8, !noalias !21
  %50 = getelementptr double, ptr %a15, i64 %.403030073009.epil.init.i
  store double %.4091.epil.i, ptr %50, align 8, !noalias !21
  %gep.epil.i = getelementptr double, ptr %invariant.gep.i, i64 %.403030073009.epil.init.i
  store double %.4091.epil.i, ptr %gep.epil.i, align 8, !noalias !21
  %gep3072.epil.i = getelementptr double, ptr %invariant.gep3071.i, i64 %.403030073009.epil.init.i
  store double 0.000000e+00, ptr %gep3072.epil.i, align 8, !noalias !21
  br label %B1412.endif.i
B1412.endif.i:
  %.4250.i = getelementptr i8, ptr %a17, i64 24
  store i64 -1, ptr %.4250.i, align 8, !noalias !21
  %.4281.i = load double, ptr %a4, align 8, !noalias !21
  %.43993024.not.i = icmp slt i64 %.33.i, 1
  br i1 %.43993024.not.i, label %B2082.i, label %B1500.lr.ph.i
B1500.lr.ph.i:
  %.4537.i = tail call i64 @llvm.smin.i64(i64 %.71.i, i64 0)
  %51 = getelementptr double, ptr %a7, i64 %.71.i
  %52 = getelementptr i8, ptr %51, i64 -8
  %.4551.i = getelementptr double, ptr %52, i64 %.4537.i
  %scevgep.i144.i = getelementptr i8, ptr %a11, i64 8
  %scevgep3.i145.i = getelementptr i8, ptr %a12, i64 16
  %53 = icmp sgt i64 %.73.i, 0
  %54 = icmp slt i64 %.1793.i, 1
  %sunkaddr459.i = getelementptr i8, ptr %a0, i64 24
  %55 = icmp sgt i64 %.25.i, 0
  %xtraiter.i.i.i = and i64 %.3521.i, 3
  %unroll_iter.i.i.i = and i64 %.3521.i, 9223372036854775804
  %xtraiter.i16.i.i = and i64 %.3863.i, 3
  %unroll_iter.i17.i.i = and i64 %.3863.i, 9223372036854775804
  %56 = mul i64 %.71.i, 24
  %57 = shl i64 %.71.i, 5
  %58 = shl i64 %.71.i, 4
  %59 = add nsw i64 %unroll_iter.i17.i.i, -4
  %60 = lshr exact i64 %59, 2
  %61 = add nuw nsw i64 %60, 1
  %62 = lshr i64 %61, 1
  %63 = mul nsw i64 %62, -2
  %.not.i.i = icmp slt i64 %.3512.i, 1
  %sunkaddr26.i.i = getelementptr i8, ptr %a0, i64 32
  %64 = icmp slt i64 %.3512.i, 4
  %65 = icmp eq i64 %xtraiter.i.i.i, 0
  %sunkaddr37.i.i = getelementptr i8, ptr %a17, i64 16
  %66 = icmp slt i64 %.3854.i, 1
  %67 = icmp slt i64 %.3854.i, 4
  %68 = icmp eq i64 %59, 0
  %69 = and i64 %59, 4
  %70 = icmp eq i64 %69, 0
  %71 = icmp eq i64 %xtraiter.i16.i.i, 0
  %.609.i.i = shl nuw nsw i64 %.25.i, 1
  %72 = icmp sgt i64 %.1436.i, %.25.i
  %.672.not.i.i = icmp sgt i64 %.1436.i, %.609.i.i
  %.781.i.i = mul nuw nsw i64 %.25.i, 3
  %.844.not.i.i = icmp sgt i64 %.1436.i, %.781.i.i
  %.953.i.i = shl nsw i64 %.25.i, 2
  %.1016.not.i.i = icmp sgt i64 %.1436.i, %.953.i.i
  %.1269.i.i = mul nuw nsw i64 %.25.i, 6
  %.1332.not.i.i = icmp sgt i64 %.1436.i, %.1269.i.i
  %.1611.i.i = mul nuw nsw i64 %.25.i, 11
  %.1657.not.i.i = icmp sgt i64 %.1436.i, %.1611.i.i
  %.arg.coefficients.5.0.i.i.i = tail call i64 @llvm.smax.i64(i64 %.29.i, i64 0)
  %73 = add nuw i64 %.arg.coefficients.5.0.i.i.i, 1
  %.1908.i.i = getelementptr i8, ptr %a10, i64 16
  %.1945.i.i = icmp sgt i64 %.974.i, 0
  %.1974.i.i = icmp sgt i64 %.3512.i, 0
  %.idx.i.i.i.i = shl i64 %.27.i, 4
  %74 = getelementptr i8, ptr %a8, i64 %.idx.i.i.i.i
  %75 = shl i64 %.27.i, 3
  %scevgep230.i.i = getelementptr i8, ptr %a8, i64 %75
  %76 = icmp slt i64 %.2136.i, 1
  %77 = icmp slt i64 %.27.i, 1
  %sunkaddr.i2.i = getelementptr i8, ptr %.2332.i, i64 8
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
B1592.endif.i:
  %.4722.i = load i64, ptr %sunkaddr459.i, align 8, !noalias !21
  store double %.4476.i, ptr %.2332.i, align 8, !noalias !116
  %.168.i.i = inttoptr i64 %.4722.i to ptr
  tail call void %.168.i.i(ptr nonnull %.2332.i, ptr %a2, ptr %.1818.i, ptr %a3, ptr %.3879.i), !noalias !116
  br label %B108.endif.endif.i.i
B106.i.i:
  %.291.i.i = add nuw i64 %.284326331.i.i, 1
  %scevgep1.i148.i = getelementptr i8, ptr %lsr.iv.i146.i, i64 16
  %scevgep5.i149.i = getelementptr i8, ptr %lsr.iv4.i.i, i64 24
  %exitcond.not.i150.i = icmp eq i64 %.73.i, %.291.i.i
  br i1 %exitcond.not.i150.i, label %B1592.endif.endif.thread.i, label %B108.endif.endif.i.i
B192.i.i:
  %sunkaddr.i.i = getelementptr i8, ptr %lsr.iv4.i.i, i64 -16
  %.612.i.i = load double, ptr %sunkaddr.i.i, align 8, !noalias !116
  %.701.i.i = getelementptr double, ptr %.3879.i, i64 %.554.i.i
  %.702.i.i = load double, ptr %.701.i.i, align 8, !noalias !116
  %.703.i.i = fmul double %.612.i.i, %.702.i.i
  %.705.i.i = fadd double %.373.i.i, %.703.i.i
  br label %B252.i.i
B252.i.i:
  %value.3.2.i.i = phi double [ %.705.i.i, %B192.i.i ], [ %.373.i.i, %B108.endif.endif.i.i ]
  %.554.1.i.i = load i64, ptr %lsr.iv.i146.i, align 8, !noalias !116
  %.557.1.i.i = icmp sgt i64 %.554.1.i.i, -1
  br i1 %.557.1.i.i, label %B192.1.i.i, label %B252.1.i.i
B192.1.i.i:
  %scevgep6.i151.i = getelementptr i8, ptr %lsr.iv4.i.i, i64 -8
  %.612.1.i.i = load double, ptr %scevgep6.i151.i, align 8, !noalias !116
  %.701.1.i.i = getelementptr double, ptr %.3879.i, i64 %.554.1.i.i
  %.702.1.i.i = load double, ptr %.701.1.i.i, align 8, !noalias !116
  %.703.1.i.i = fmul double %.612.1.i.i, %.702.1.i.i
  %.705.1.i.i = fadd double %value.3.2.i.i, %.703.1.i.i
  br label %B252.1.i.i
B252.1.i.i:
  %value.3.2.1.i.i = phi double [ %.705.1.i.i, %B192.1.i.i ], [ %value.3.2.i.i, %B252.i.i ]
  %.724.i.i = fcmp ogt double %value.3.2.1.i.i, 0.000000e+00
  br i1 %.724.i.i, label %B1592.endif.endif.i, label %B106.i.i
B108.endif.endif.i.i:
  %lsr.iv4.i.i = phi ptr [ %scevgep3.i145.i, %B1592.endif.i ], [ %scevgep5.i149.i, %B106.i.i ]
  %lsr.iv.i146.i = phi ptr [ %scevgep.i144.i, %B1592.endif.i ], [ %scevgep1.i148.i, %B106.i.i ]
  %.284326331.i.i = phi i64 [ 0, %B1592.endif.i ], [ %.291.i.i, %B106.i.i ]
  %.373.i.i = load double, ptr %lsr.iv4.i.i, align 8, !noalias !116
  %scevgep2.i147.i = getelementptr i8, ptr %lsr.iv.i146.i, i64 -8
  %.554.i.i = load i64, ptr %scevgep2.i147.i, align 8, !noalias !116
  %.557.i.i = icmp sgt i64 %.554.i.i, -1
  br i1 %.557.i.i, label %B192.i.i, label %B252.i.i
B1592.endif.endif.thread.i:
  store i64 -1, ptr %.4250.i, align 8, !noalias !21
  br label %B1776.i
B1592.endif.endif.i:
  store i64 %.284326331.i.i, ptr %.4250.i, align 8, !noalias !21
  br label %B2082.i
B2126.endif.endif.i:
  %.6144.i = getelementptr i8, ptr %a17, i64 16
  %.6145.i = load i64, ptr %.6144.i, align 8, !noalias !21
  %.6147.i = add nsw i64 %.71.i, -1
  %.13.i.i = tail call i64 @llvm.smin.i64(i64 %.6147.i, i64 %.6145.i)
  store i64 %.13.i.i, ptr %.6144.i, align 8, !noalias !21
  %.6236.i = getelementptr i8, ptr %a0, i64 24
  %.6237.i = load i64, ptr %.6236.i, align 8, !noalias !21
  store double %t.4.1.i, ptr %.2332.i, align 8, !noalias !119
  %.151.i.i = inttoptr i64 %.6237.i to ptr
  tail call void %.151.i.i(ptr nonnull %.2332.i, ptr %a2, ptr %.1818.i, ptr %a3, ptr %.3879.i), !noalias !119
  %.253155.not.i.i = icmp slt i64 %.3854.i, 1
  br i1 %.253155.not.i.i, label %B2126.endif.endif.endif.i, label %B96.lr.ph.i.i
B96.lr.ph.i.i:
  %.349.i.i = icmp slt i64 %.13.i.i, 0
  %.350.i.i = select i1 %.349.i.i, i64 %.71.i, i64 0
  %xtraiter.i.i = and i64 %.3863.i, 3
  %78 = icmp ult i64 %.3854.i, 4
  br i1 %78, label %B96.epil.preheader.i.i, label %B96.lr.ph.new.i.i
B96.lr.ph.new.i.i:
  %invariant.gep.i.i = getelementptr double, ptr %a14, i64 %.13.i.i
  %invariant.gep159.i.i = getelementptr double, ptr %invariant.gep.i.i, i64 %.350.i.i
  %unroll_iter.i.i = and i64 %.3863.i, 9223372036854775804
  %79 = mul i64 %.71.i, 24
  %80 = shl i64 %.71.i, 5
  %81 = shl i64 %.71.i, 4
  %82 = add nsw i64 %.3863.i, -4
  %83 = lshr i64 %82, 2
  %84 = icmp eq i64 %83, 0
  br i1 %84, label %B96.i.epil.preheader.i, label %B96.lr.ph.new.i.new.i
B96.lr.ph.new.i.new.i:
  %85 = add nuw nsw i64 %83, 1
  %unroll_iter395.i = and i64 %85, 9223372036854775806
  %86 = add i64 %.2219.sroa.0.3.i, %.1520.sroa.0.3.i
  %87 = add i64 %86, %.2872.sroa.0.3.i
  %88 = add i64 %87, %.3239.sroa.0.3.i
  %89 = add i64 %88, %.3766.sroa.0.3.i
  %90 = shl i64 %89, 3
  %91 = getelementptr i8, ptr %a18, i64 %90
  %scevgep409.i = getelementptr i8, ptr %91, i64 56
  br label %B96.i.i
B96.i.i:
  %lsr.iv.i = phi i64 [ %lsr.iv.next.i, %B96.i.i ], [ %unroll_iter395.i, %B96.lr.ph.new.i.new.i ]
  %lsr.iv13.i.i = phi ptr [ %scevgep431.i, %B96.i.i ], [ %invariant.gep159.i.i, %B96.lr.ph.new.i.new.i ]
  %.259154156.i.i = phi i64 [ %.266.3.i.1.i, %B96.i.i ], [ 0, %B96.lr.ph.new.i.new.i ]
  %sunkaddr.i152.i = shl i64 %.259154156.i.i, 3
  %scevgep423.i = getelementptr i8, ptr %scevgep409.i, i64 %sunkaddr.i152.i
  %scevgep424.i = getelementptr i8, ptr %scevgep423.i, i64 -56
  %.320.i.i = load double, ptr %scevgep424.i, align 8, !noalias !119
  store double %.320.i.i, ptr %lsr.iv13.i.i, align 8, !noalias !119
  %scevgep422.i = getelementptr i8, ptr %scevgep423.i, i64 -48
  %.320.1.i.i = load double, ptr %scevgep422.i, align 8, !noalias !119
  %sunkaddr23.i.i = getelementptr i8, ptr %lsr.iv13.i.i, i64 %.16.i.i
  store double %.320.1.i.i, ptr %sunkaddr23.i.i, align 8, !noalias !119
  %scevgep420.i = getelementptr i8, ptr %scevgep423.i, i64 -40
  %.320.2.i.i = load double, ptr %scevgep420.i, align 8, !noalias !119
  %scevgep425.i = getelementptr i8, ptr %sunkaddr23.i.i, i64 %.16.i.i
  store double %.320.2.i.i, ptr %scevgep425.i, align 8, !noalias !119
  %scevgep418.i = getelementptr i8, ptr %scevgep423.i, i64 -32
  %.320.3.i.i = load double, ptr %scevgep418.i, align 8, !noalias !119
  %scevgep426.i = getelementptr i8, ptr %scevgep425.i, i64 %.16.i.i
  store double %.320.3.i.i, ptr %scevgep426.i, align 8, !noalias !119
  %scevgep416.i = getelementptr i8, ptr %scevgep423.i, i64 -24
  %.320.i.1.i = load double, ptr %scevgep416.i, align 8, !noalias !119
  %scevgep427.i = getelementptr i8, ptr %scevgep426.i, i64 %.16.i.i
  store double %.320.i.1.i, ptr %scevgep427.i, align 8, !noalias !119
  %scevgep414.i = getelementptr i8, ptr %scevgep423.i, i64 -16
  %.320.1.i.1.i = load double, ptr %scevgep414.i, align 8, !noalias !119
  %scevgep428.i = getelementptr i8, ptr %scevgep427.i, i64 %.16.i.i
  store double %.320.1.i.1.i, ptr %scevgep428.i, align 8, !noalias !119
  %scevgep412.i = getelementptr i8, ptr %scevgep423.i, i64 -8
  %.320.2.i.1.i = load double, ptr %scevgep412.i, align 8, !noalias !119
  %scevgep429.i = getelementptr i8, ptr %scevgep428.i, i64 %.16.i.i
  store double %.320.2.i.1.i, ptr %scevgep429.i, align 8, !noalias !119
  %.266.3.i.1.i = add nuw i64 %.259154156.i.i, 8
  %.320.3.i.1.i = load double, ptr %scevgep423.i, align 8, !noalias !119
  %scevgep430.i = getelementptr i8, ptr %scevgep429.i, i64 %.16.i.i
  store double %.320.3.i.1.i, ptr %scevgep430.i, align 8, !noalias !119
  %lsr.iv.next.i = add i64 %lsr.iv.i, -2
  %niter396.ncmp.1.i = icmp eq i64 %lsr.iv.next.i, 0
  %scevgep431.i = getelementptr i8, ptr %scevgep430.i, i64 %.16.i.i
  br i1 %niter396.ncmp.1.i, label %B126.loopexit.unr-lcssa.i.unr-lcssa.i, label %B96.i.i
B126.loopexit.unr-lcssa.i.unr-lcssa.i:
  %scevgep14.i.i = getelementptr i8, ptr %lsr.iv13.i.i, i64 %80
  %scevgep14.i.1.i = getelementptr i8, ptr %scevgep14.i.i, i64 %80
  %92 = and i64 %82, 4
  %lcmp.mod393.not.not.i = icmp eq i64 %92, 0
  br i1 %lcmp.mod393.not.not.i, label %B96.i.epil.preheader.i, label %B126.loopexit.unr-lcssa.i.i
B96.i.epil.preheader.i:
  %lsr.iv13.i.epil.init.i = phi ptr [ %invariant.gep159.i.i, %B96.lr.ph.new.i.i ], [ %scevgep14.i.1.i, %B126.loopexit.unr-lcssa.i.unr-lcssa.i ]
  %.259154156.i.epil.init.i = phi i64 [ 0, %B96.lr.ph.new.i.i ], [ %.266.3.i.1.i, %B126.loopexit.unr-lcssa.i.unr-lcssa.i ]
  %sunkaddr.i152.epil.i = shl i64 %.259154156.i.epil.init.i, 3
  %sunkaddr18.i.epil.i = getelementptr i8, ptr %.3879.i, i64 %sunkaddr.i152.epil.i
  %.320.i.epil.i = load double, ptr %sunkaddr18.i.epil.i, align 8, !noalias !119
  store double %.320.i.epil.i, ptr %lsr.iv13.i.epil.init.i, align 8, !noalias !119
  %sunkaddr21.i.epil.i = getelementptr i8, ptr %sunkaddr18.i.epil.i, i64 8
  %.320.1.i.epil.i = load double, ptr %sunkaddr21.i.epil.i, align 8, !noalias !119
  %sunkaddr23.i.epil.i = getelementptr i8, ptr %lsr.iv13.i.epil.init.i, i64 %.16.i.i
  store double %.320.1.i.epil.i, ptr %sunkaddr23.i.epil.i, align 8, !noalias !119
  %sunkaddr26.i.epil.i = getelementptr i8, ptr %sunkaddr18.i.epil.i, i64 16
  %.320.2.i.epil.i = load double, ptr %sunkaddr26.i.epil.i, align 8, !noalias !119
  %scevgep16.i.epil.i = getelementptr i8, ptr %lsr.iv13.i.epil.init.i, i64 %81
  store double %.320.2.i.epil.i, ptr %scevgep16.i.epil.i, align 8, !noalias !119
  %sunkaddr29.i.epil.i = getelementptr i8, ptr %sunkaddr18.i.epil.i, i64 24
  %.320.3.i.epil.i = load double, ptr %sunkaddr29.i.epil.i, align 8, !noalias !119
  %scevgep15.i.epil.i = getelementptr i8, ptr %lsr.iv13.i.epil.init.i, i64 %79
  store double %.320.3.i.epil.i, ptr %scevgep15.i.epil.i, align 8, !noalias !119
  br label %B126.loopexit.unr-lcssa.i.i
B126.loopexit.unr-lcssa.i.i:
  %lcmp.mod.not.i.i = icmp eq i64 %xtraiter.i.i, 0
  br i1 %lcmp.mod.not.i.i, label %B2126.endif.endif.endif.i, label %B96.epil.preheader.i.i
B96.epil.preheader.i.i:
  %.259154156.epil.init.i.i = phi i64 [ %unroll_iter.i.i, %B126.loopexit.unr-lcssa.i.i ], [ 0, %B96.lr.ph.i.i ]
  %93 = mul i64 %.259154156.epil.init.i.i, %.71.i
  %94 = add i64 %.350.i.i, %.13.i.i
  %95 = add i64 %94, %93
  %96 = shl i64 %95, 3
  %scevgep.i153.i = getelementptr i8, ptr %a14, i64 %96
  %97 = add i64 %.2219.sroa.0.3.i, %.1520.sroa.0.3.i
  %98 = add i64 %97, %.2872.sroa.0.3.i
  %99 = add i64 %98, %.3239.sroa.0.3.i
  %100 = add i64 %99, %.3766.sroa.0.3.i
  %101 = add i64 %100, %.259154156.epil.init.i.i
  %102 = shl i64 %101, 3
  %scevgep.i = getelementptr i8, ptr %a18, i64 %102
  br label %B96.epil.i.i
B96.epil.i.i:
  %lsr.iv.i155.i = phi ptr [ %scevgep2.i157.i, %B96.epil.i.i ], [ %scevgep.i153.i, %B96.epil.preheader.i.i ]
  %epil.iter.i.i = phi i64 [ %epil.iter.next.i.i, %B96.epil.i.i ], [ 0, %B96.epil.preheader.i.i ]
  %103 = shl i64 %epil.iter.i.i, 3
  %scevgep408.i = getelementptr i8, ptr %scevgep.i, i64 %103
  %.320.epil.i.i = load double, ptr %scevgep408.i, align 8, !noalias !119
  store double %.320.epil.i.i, ptr %lsr.iv.i155.i, align 8, !noalias !119
  %epil.iter.next.i.i = add i64 %epil.iter.i.i, 1
  %scevgep2.i157.i = getelementptr i8, ptr %lsr.iv.i155.i, i64 %.16.i.i
  %epil.iter.cmp.not.i.i = icmp eq i64 %xtraiter.i.i, %epil.iter.next.i.i
  br i1 %epil.iter.cmp.not.i.i, label %B2126.endif.endif.endif.i, label %B96.epil.i.i, !llvm.loop !122
B2126.endif.endif.endif.i:
  %.6379.i = load i64, ptr %.6144.i, align 8, !noalias !21
  %.6380.i = add nsw i64 %.6379.i, 1
  store i64 %.6380.i, ptr %.6144.i, align 8, !noalias !21
  br label %_ZN6poppet6engine10integrator9integrateB2v1B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAg6cJqBrMeIZJFEGM0QQAE8int64_2a8int64_2a10float64_2a10float64_2a10float64_2a10float64_2a8uint8_2a10float64_2a10float64_2a8uint8_2a10float64_2a8int64_2a10float64_2a8uint8_2a10float64_2a10float64_2a10float64_2a8int64_2a10float64_2a10float64_2a.exit
_ZN6poppet6engine10integrator9integrateB2v1B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAg6cJqBrMeIZJFEGM0QQAE8int64_2a8int64_2a10float64_2a10float64_2a10float64_2a10float64_2a8uint8_2a10float64_2a10float64_2a8uint8_2a10float64_2a8int64_2a10float64_2a8uint8_2a10float64_2a10float64_2a10float64_2a8int64_2a10float64_2a10float64_2a.exit:
  store double %t.4.1.i, ptr %a16, align 8, !noalias !21
  ret i64 %status.5.1.i
}
declare void @llvm.lifetime.start.p0(ptr)
declare void @llvm.lifetime.end.p0(ptr)
!0 = !{!1}
!1 = distinct !{!1, !2, !"_ZN6poppet6engine8stepping9inputs_atB2v8B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!2 = distinct !{!2, !"_ZN6poppet6engine8stepping9inputs_atB2v8B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!3 = !{!4}
!4 = distinct !{!4, !5, !"_ZN6poppet6engine8stepping12next_instantB3v14B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!5 = distinct !{!5, !"_ZN6poppet6engine8stepping12next_instantB3v14B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedEx"}
!6 = distinct !{!6, !7}
!7 = !{!"llvm.loop.unroll.disable"}
!8 = !{!9}
!9 = distinct !{!9, !10, !"_ZN6poppet6engine8stepping12next_instantB3v14B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!10 = distinct !{!10, !"_ZN6poppet6engine8stepping12next_instantB3v14B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedEx"}
!11 = !{!12}
!12 = distinct !{!12, !13, !"_ZN6poppet6engine8stepping11interpolateB3v25B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!13 = distinct !{!13, !"_ZN6poppet6engine8stepping11interpolateB3v25B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!14 = !{!15}
!15 = distinct !{!15, !16, !"_ZN6poppet6engine8stepping9inputs_atB2v8B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!16 = distinct !{!16, !"_ZN6poppet6engine8stepping9inputs_atB2v8B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!17 = !{!18}
!18 = distinct !{!18, !19, !"_ZN6poppet6engine8stepping5writeB3v28B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedEx: %retptr"}
!19 = distinct !{!19, !"_ZN6poppet6engine8stepping5writeB3v28B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedEx"}
!20 = distinct !{!20, !7}
!21 = !{!22}
!22 = distinct !{!22, !23, !"_ZN6poppet6engine10integrator9integrateB2v1B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAg6cJqBrMeIZJFEGM0QQAE8int64_2a8int64_2a10float64_2a10float64_2a10float64_2a10float64_2a8uint8_2a10float64_2a10float64_2a8uint8_2a10float64_2a8int64_2a10float64_2a8uint8_2a10float64_2a10float64_2a10float64_2a8int64_2a10float64_2a10float64_2a: %retptr"}
!23 = distinct !{!23, !"_ZN6poppet6engine10integrator9integrateB2v1B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAg6cJqBrMeIZJFEGM0QQAE8int64_2a8int64_2a10float64_2a10float64_2a10float64_2a10float64_2a8uint8_2a10float64_2a10float64_2a8uint8_2a10float64_2a8int64_2a10float64_2a8uint8_2a10float64_2a10float64_2a10float64_2a8int64_2a10float64_2a10float64_2a"}
!24 = !{!"branch_weights", i32 1, i32 99}
!25 = !{!26, !22}
!26 = distinct !{!26, !27, !"_ZN6poppet6engine8stepping9inputs_atB2v8B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!27 = distinct !{!27, !"_ZN6poppet6engine8stepping9inputs_atB2v8B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!28 = !{!29, !22}
!29 = distinct !{!29, !30, !"_ZN6poppet6engine10integrator8_segmentB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!30 = distinct !{!30, !"_ZN6poppet6engine10integrator8_segmentB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!31 = !{!"branch_weights", i32 99, i32 1}
!32 = !{!33, !29, !22}
!33 = distinct !{!33, !34, !"_ZN6poppet6engine8stepping5beginB3v16B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!34 = distinct !{!34, !"_ZN6poppet6engine8stepping5beginB3v16B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE"}
!35 = !{!36, !33, !29, !22}
!36 = distinct !{!36, !37, !"_ZN6poppet6engine8stepping9inputs_atB2v8B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!37 = distinct !{!37, !"_ZN6poppet6engine8stepping9inputs_atB2v8B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!38 = !{!39, !33, !29, !22}
!39 = distinct !{!39, !40, !"_ZN6poppet6engine8stepping10first_stepB3v18B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedEd: %retptr"}
!40 = distinct !{!40, !"_ZN6poppet6engine8stepping10first_stepB3v18B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedEd"}
!41 = !{!42, !33, !29, !22}
!42 = distinct !{!42, !43, !"_ZN6poppet6engine8stepping15input_slopes_atB3v17B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!43 = distinct !{!43, !"_ZN6poppet6engine8stepping15input_slopes_atB3v17B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!44 = !{!45, !47, !29, !22}
!45 = distinct !{!45, !46, !"_ZN6poppet6engine8stepping12next_instantB3v14B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!46 = distinct !{!46, !"_ZN6poppet6engine8stepping12next_instantB3v14B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedEx"}
!47 = distinct !{!47, !48, !"_ZN6poppet6engine10integrator6_reachB3v20B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdddddb5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!48 = distinct !{!48, !"_ZN6poppet6engine10integrator6_reachB3v20B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdddddb5ArrayIdLi1E1C7mutable7alignedEx"}
!49 = distinct !{!49, !7}
!50 = !{!51, !29, !22}
!51 = distinct !{!51, !52, !"_ZN6poppet6engine8stepping5errorB3v22B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE: %retptr"}
!52 = distinct !{!52, !"_ZN6poppet6engine8stepping5errorB3v22B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE"}
!53 = !{!54, !56, !29, !22}
!54 = distinct !{!54, !55, !"_ZN6poppet6engine8stepping12next_instantB3v14B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!55 = distinct !{!55, !"_ZN6poppet6engine8stepping12next_instantB3v14B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedEx"}
!56 = distinct !{!56, !57, !"_ZN6poppet6engine10integrator7_acceptB3v23B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE: %retptr"}
!57 = distinct !{!57, !"_ZN6poppet6engine10integrator7_acceptB3v23B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE"}
!58 = distinct !{!58, !7}
!59 = !{!56, !29, !22}
!60 = !{!61, !63, !56, !29, !22}
!61 = distinct !{!61, !62, !"_ZN6poppet6engine8stepping11interpolateB3v25B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!62 = distinct !{!62, !"_ZN6poppet6engine8stepping11interpolateB3v25B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!63 = distinct !{!63, !64, !"_ZN6poppet6engine8stepping11stop_insideB3v24B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!64 = distinct !{!64, !"_ZN6poppet6engine8stepping11stop_insideB3v24B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE"}
!65 = !{!66, !63, !56, !29, !22}
!66 = distinct !{!66, !67, !"_ZN6poppet6engine8stepping11interpolateB3v25B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!67 = distinct !{!67, !"_ZN6poppet6engine8stepping11interpolateB3v25B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!68 = !{!69, !63, !56, !29, !22}
!69 = distinct !{!69, !70, !"_ZN6poppet6engine8stepping9inputs_atB2v8B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!70 = distinct !{!70, !"_ZN6poppet6engine8stepping9inputs_atB2v8B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!71 = !{!72, !63, !56, !29, !22}
!72 = distinct !{!72, !73, !"_ZN6poppet6engine8stepping14stop_conditionB2v9B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!73 = distinct !{!73, !"_ZN6poppet6engine8stepping14stop_conditionB2v9B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE"}
!74 = !{!75, !56, !29, !22}
!75 = distinct !{!75, !76, !"_ZN6poppet6engine8stepping10act_insideB3v26B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExxdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE: %retptr"}
!76 = distinct !{!76, !"_ZN6poppet6engine8stepping10act_insideB3v26B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExxdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE"}
!77 = !{!78, !75, !56, !29, !22}
!78 = distinct !{!78, !79, !"_ZN6poppet6engine8stepping12next_instantB3v14B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!79 = distinct !{!79, !"_ZN6poppet6engine8stepping12next_instantB3v14B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedEx"}
!80 = distinct !{!80, !7}
!81 = !{!82, !75, !56, !29, !22}
!82 = distinct !{!82, !83, !"_ZN6poppet6engine8stepping11interpolateB3v25B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!83 = distinct !{!83, !"_ZN6poppet6engine8stepping11interpolateB3v25B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!84 = !{!85, !56, !29, !22}
!85 = distinct !{!85, !86, !"_ZN6poppet6engine8stepping4takeB3v29B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE: %retptr"}
!86 = distinct !{!86, !"_ZN6poppet6engine8stepping4takeB3v29B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE"}
!87 = !{!88, !29, !22}
!88 = distinct !{!88, !89, !"_ZN6poppet6engine8stepping7verdictB3v31B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEddd5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEbb: %retptr"}
!89 = distinct !{!89, !"_ZN6poppet6engine8stepping7verdictB3v31B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEddd5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEbb"}
!90 = !{!91, !29, !22}
!91 = distinct !{!91, !92, !"_ZN6poppet6engine8stepping6variesB3v11B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!92 = distinct !{!92, !"_ZN6poppet6engine8stepping6variesB3v11B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi2E1C7mutable7alignedE"}
!93 = !{!94, !29, !22}
!94 = distinct !{!94, !95, !"_ZN6poppet6engine8stepping9inputs_atB2v8B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!95 = distinct !{!95, !"_ZN6poppet6engine8stepping9inputs_atB2v8B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!96 = !{!97, !29, !22}
!97 = distinct !{!97, !98, !"_ZN6poppet6engine8stepping9inputs_atB2v8B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!98 = distinct !{!98, !"_ZN6poppet6engine8stepping9inputs_atB2v8B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!99 = !{!100, !22}
!100 = distinct !{!100, !101, !"_ZN6poppet6engine10integrator20_rows_without_statesB3v32B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE: %retptr"}
!101 = distinct !{!101, !"_ZN6poppet6engine10integrator20_rows_without_statesB3v32B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE"}
!102 = !{!103, !100, !22}
!103 = distinct !{!103, !104, !"_ZN6poppet6engine8stepping12next_instantB3v14B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!104 = distinct !{!104, !"_ZN6poppet6engine8stepping12next_instantB3v14B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedEx"}
!105 = distinct !{!105, !7}
!106 = !{!107, !100, !22}
!107 = distinct !{!107, !108, !"_ZN6poppet6engine8stepping9inputs_atB2v8B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!108 = distinct !{!108, !"_ZN6poppet6engine8stepping9inputs_atB2v8B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!109 = !{!110, !100, !22}
!110 = distinct !{!110, !111, !"_ZN6poppet6engine8stepping5writeB3v28B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedEx: %retptr"}
!111 = distinct !{!111, !"_ZN6poppet6engine8stepping5writeB3v28B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedEx"}
!112 = distinct !{!112, !7}
!113 = !{!114, !22}
!114 = distinct !{!114, !115, !"_ZN6poppet6engine8stepping9inputs_atB2v8B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!115 = distinct !{!115, !"_ZN6poppet6engine8stepping9inputs_atB2v8B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!116 = !{!117, !22}
!117 = distinct !{!117, !118, !"_ZN6poppet6engine8stepping14stop_conditionB2v9B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!118 = distinct !{!118, !"_ZN6poppet6engine8stepping14stop_conditionB2v9B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE"}
!119 = !{!120, !22}
!120 = distinct !{!120, !121, !"_ZN6poppet6engine8stepping5writeB3v28B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedEx: %retptr"}
!121 = distinct !{!121, !"_ZN6poppet6engine8stepping5writeB3v28B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedEx"}
!122 = distinct !{!122, !7}
