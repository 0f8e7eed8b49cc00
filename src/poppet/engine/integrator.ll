; made from integrator.py, sha256 a71c9b3f7b95f3a2b6abbedf3e409a54ef052eb07096d9da3daaaf432e693c51
@v18 = private unnamed_addr constant [4 x double] [double 3.860000e-01, double 2.100000e-01, double 6.300000e-01, double 1.000000e+00], align 8
declare i64 @llvm.smax.i64(i64, i64)
declare i64 @llvm.smin.i64(i64, i64)
declare double @llvm.sin.f64(double)
declare double @llvm.fabs.f64(double)
declare double @llvm.cos.f64(double)
declare double @llvm.pow.f64(double, double)
declare i64 @llvm.umin.i64(i64, i64)
define i64 @integrate(ptr readonly %a0, ptr readonly %a1, ptr %a2, ptr %a3, ptr readonly %a4, ptr readonly %a5, ptr readonly %a6, ptr readonly %a7, ptr readonly %a8, ptr readonly %a9, ptr readonly %a10, ptr readonly %a11, ptr readonly %a12, ptr writeonly %a13, ptr %a14, ptr %a15, ptr %a16, ptr %a17) local_unnamed_addr {
  %.23.i = load i64, ptr %a1, align 8, !noalias !0
  %.24.i = getelementptr i8, ptr %a1, i64 8
  %.25.i = load i64, ptr %.24.i, align 8, !noalias !0
  %.26.i = getelementptr i8, ptr %a1, i64 16
  %.27.i = load i64, ptr %.26.i, align 8, !noalias !0
  %.28.i = getelementptr i8, ptr %a1, i64 24
  %.29.i = load i64, ptr %.28.i, align 8, !noalias !0
  %.30.i = getelementptr i8, ptr %a1, i64 32
  %.31.i = load i64, ptr %.30.i, align 8, !noalias !0
  %.68.i = getelementptr i8, ptr %a1, i64 40
  %.69.i = load i64, ptr %.68.i, align 8, !noalias !0
  %.70.i = getelementptr i8, ptr %a1, i64 48
  %.71.i = load i64, ptr %.70.i, align 8, !noalias !0
  %.72.i = getelementptr i8, ptr %a1, i64 56
  %.73.i = load i64, ptr %.72.i, align 8, !noalias !0
  %.74.i = getelementptr i8, ptr %a1, i64 64
  %.75.i = load i64, ptr %.74.i, align 8, !noalias !0
  %.16.i.i = shl i64 %.69.i, 3
  %.985.i = mul nsw i64 %.23.i, 12
  %.986.i = mul i64 %.27.i, 6
  %.987.i = or i64 %.985.i, 2
  %.988.i = add i64 %.987.i, %.986.i
  %.989.i = add i64 %.988.i, %.29.i
  %.990.i = add nsw i64 %.989.i, %.73.i
  %.991.i = add nsw i64 %.990.i, %.75.i
  %.1078.i = icmp slt i64 %.991.i, 1
  br i1 %.1078.i, label %B0.endif.endif.endif.endi...else.endif.if.i, label %B0.endif.endif.endif.endi...else.endif.endif.i, !prof !3
B1094.i:
  %lsr.iv415.i = phi ptr [ %scevgep416.i, %B1094.i ], [ %scevgep414.i, %B1094.lr.ph.new.i ]
  %lsr.iv411.i = phi ptr [ %scevgep412.i, %B1094.i ], [ %scevgep410.i, %B1094.lr.ph.new.i ]
  %.320125682570.i = phi i64 [ %.3208.1.i, %B1094.i ], [ 0, %B1094.lr.ph.new.i ]
  %scevgep413.i = getelementptr i8, ptr %lsr.iv411.i, i64 -8
  %.3262.i = load double, ptr %scevgep413.i, align 8, !noalias !0
  %scevgep417.i = getelementptr i8, ptr %lsr.iv415.i, i64 -8
  store double %.3262.i, ptr %scevgep417.i, align 8, !noalias !0
  %sunkaddr425.i = getelementptr i8, ptr %lsr.iv415.i, i64 %sunkaddr.i
  %sunkaddr426.i = getelementptr i8, ptr %sunkaddr425.i, i64 -8
  store double %.3262.i, ptr %sunkaddr426.i, align 8, !noalias !0
  %scevgep422.i = getelementptr i8, ptr %lsr.iv415.i, i64 %.idx.i
  %scevgep423.i = getelementptr i8, ptr %scevgep422.i, i64 -8
  store double 0.000000e+00, ptr %scevgep423.i, align 8, !noalias !0
  %.3208.1.i = add nuw i64 %.320125682570.i, 2
  %.3262.1.i = load double, ptr %lsr.iv411.i, align 8, !noalias !0
  store double %.3262.1.i, ptr %lsr.iv415.i, align 8, !noalias !0
  store double %.3262.1.i, ptr %sunkaddr425.i, align 8, !noalias !0
  store double 0.000000e+00, ptr %scevgep422.i, align 8, !noalias !0
  %scevgep412.i = getelementptr i8, ptr %lsr.iv411.i, i64 16
  %scevgep416.i = getelementptr i8, ptr %lsr.iv415.i, i64 16
  %niter.ncmp.1.i = icmp eq i64 %unroll_iter.i, %.3208.1.i
  br i1 %niter.ncmp.1.i, label %B1172.endif.loopexit.unr-lcssa.i, label %B1094.i
B1260.i:
  %h.3.02588.i = phi double [ 0.000000e+00, %B1260.lr.ph.i ], [ %h.4.12529.i, %B1768.i ]
  %.357625792586.i = phi i64 [ 0, %B1260.lr.ph.i ], [ %.3583.i, %B1768.i ]
  %.3583.i = add nuw nsw i64 %.357625792586.i, 1
  %1 = getelementptr double, ptr %a4, i64 %.357625792586.i
  %.3647.i = load double, ptr %1, align 8, !noalias !0
  %.3654.i = icmp slt i64 %.3583.i, %.31.i
  %2 = getelementptr double, ptr %a4, i64 %.3583.i
  %"$phi1338.1.2.1.in.i" = select i1 %.3654.i, ptr %2, ptr %.3722.i
  %"$phi1338.1.2.1.i" = load double, ptr %"$phi1338.1.2.1.in.i", align 8, !noalias !0
  br i1 %60, label %B1352.i, label %B1516.i
B1352.i:
  %.40.i.i = fsub double %.3647.i, %.3647.i
  br i1 %61, label %B1352.endif.i, label %B56.preheader.i.i
B56.preheader.i.i:
  %.3787.i = mul i64 %.357625792586.i, %.986.i
  %.3789.i = getelementptr double, ptr %a5, i64 %.3787.i
  %scevgep.i.i = getelementptr i8, ptr %.3789.i, i64 40
  br label %B56.i.i
B56.i.i:
  %lsr.iv407.i = phi i64 [ %lsr.iv.next408.i, %B316.i.i ], [ %.1415.sroa.0.3.i, %B56.preheader.i.i ]
  %lsr.iv.i.i = phi ptr [ %scevgep1.i.i, %B316.i.i ], [ %scevgep.i.i, %B56.preheader.i.i ]
  %scevgep6.i.i = getelementptr i8, ptr %lsr.iv.i.i, i64 -40
  %.227.i.i = load double, ptr %scevgep6.i.i, align 8, !noalias !4
  %scevgep5.i.i = getelementptr i8, ptr %lsr.iv.i.i, i64 -32
  %.282.i.i = load double, ptr %scevgep5.i.i, align 8, !noalias !4
  %.284.i.i = fmul double %.40.i.i, %.282.i.i
  %.285.i.i = fadd double %.227.i.i, %.284.i.i
  %scevgep4.i.i = getelementptr i8, ptr %lsr.iv.i.i, i64 -24
  %.347.i.i = load double, ptr %scevgep4.i.i, align 8, !noalias !4
  %.348.i.i = fcmp une double %.347.i.i, 0.000000e+00
  br i1 %.348.i.i, label %B134.i.i, label %B316.i.i
B134.i.i:
  %scevgep3.i.i = getelementptr i8, ptr %lsr.iv.i.i, i64 -16
  %.405.i.i = load double, ptr %scevgep3.i.i, align 8, !noalias !4
  %scevgep2.i.i = getelementptr i8, ptr %lsr.iv.i.i, i64 -8
  %.460.i.i = load double, ptr %scevgep2.i.i, align 8, !noalias !4
  %.461.i.i = fmul double %.460.i.i, 5.000000e-01
  %.463.i.i = fmul double %.40.i.i, %.461.i.i
  %.464.i.i = fadd double %.405.i.i, %.463.i.i
  %.465.i.i = fmul double %.464.i.i, 0x401921FB54442D18
  %.467.i.i = fmul double %.40.i.i, %.465.i.i
  %.522.i.i = load double, ptr %lsr.iv.i.i, align 8, !noalias !4
  %.523.i.i = fadd double %.522.i.i, %.467.i.i
  %.586.le.i.i = tail call double @llvm.sin.f64(double %.523.i.i)
  %.591.i.i = fmul double %.347.i.i, %.586.le.i.i
  %.593.i.i = fadd double %.285.i.i, %.591.i.i
  br label %B316.i.i
B316.i.i:
  %value.2.1.i.i = phi double [ %.593.i.i, %B134.i.i ], [ %.285.i.i, %B56.i.i ]
  %3 = shl i64 %lsr.iv407.i, 3
  %scevgep409.i = getelementptr i8, ptr %.1343.i, i64 %3
  store double %value.2.1.i.i, ptr %scevgep409.i, align 8, !noalias !4
  %scevgep1.i.i = getelementptr i8, ptr %lsr.iv.i.i, i64 48
  %lsr.iv.next408.i = add nuw i64 %lsr.iv407.i, 1
  %exitcond.not.i.i = icmp eq i64 %.1415.sroa.13.0.i, %lsr.iv.next408.i
  br i1 %exitcond.not.i.i, label %B1352.endif.i, label %B56.i.i
B1516.i:
  %4 = getelementptr i8, ptr %a6, i64 %.357625792586.i
  %.4136.i = load i8, ptr %4, align 1, !noalias !0
  %.4137.not.i = icmp eq i8 %.4136.i, 0
  %.4140.i = fneg double %h.3.02588.i
  %"$phi1540.1.2.1.i" = select i1 %.4137.not.i, double %h.3.02588.i, double %.4140.i
  br i1 %62, label %B1554.i, label %B1656.i
B1554.i:
  %.4215.i = mul i64 %.357625792586.i, %.986.i
  %.4217.i = getelementptr double, ptr %a5, i64 %.4215.i
  %.388.i.i = load i64, ptr %.387.i.i, align 8, !noalias !7
  %.418.i.i = load i64, ptr %sunkaddr432.i, align 8, !noalias !7
  br i1 %77, label %B0.endif.else.endif.endif.i.i, label %B0.endif.else.endif.if.i.i, !prof !10
B472.i.i:
  %.2352.i.i = fcmp olt double %.3647.i, %"$phi1338.1.2.1.i"
  br i1 %.2352.i.i, label %B486.preheader.i.i, label %_ZN6poppet6engine10integrator8_segmentB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i
B486.preheader.i.i:
  %invariant.gep.i.i.i = getelementptr double, ptr %.1262.i.i, i64 %.724.i1.i
  %5 = add nuw i64 %.1713.sroa.0.3.i.i, %.1321.sroa.0.3.i.i
  %6 = shl i64 %5, 3
  %scevgep468.i.i = getelementptr i8, ptr %.1171.i, i64 %6
  %7 = inttoptr i64 %.388.i.i to ptr
  %invariant.gep.i.i.i.i = getelementptr double, ptr %.1262.i.i, i64 %.1072.i.i
  %8 = icmp slt i64 %.1063.i.i, 1
  %9 = inttoptr i64 %.418.i.i to ptr
  %10 = icmp slt i64 %.715.i.i, 1
  br label %B486.i.i
B486.i.i:
  %t.2.0.i.i = phi double [ %t.3.1.i.i, %B2912.i.i ], [ %.3647.i, %B486.preheader.i.i ]
  %h.5.0.i.i = phi double [ %h.6.1.i.i, %B2912.i.i ], [ %"$phi1540.1.2.1.i", %B486.preheader.i.i ]
  %error_before.2.0.i.i = phi double [ %error_before.3.1.i.i, %B2912.i.i ], [ 1.000000e-02, %B486.preheader.i.i ]
  %step_before.2.0.i.i = phi double [ %step_before.3.1.i.i, %B2912.i.i ], [ 0.000000e+00, %B486.preheader.i.i ]
  %rejected.3.0.i.i = phi i1 [ %rejected.4.1.i.i, %B2912.i.i ], [ false, %B486.preheader.i.i ]
  %fresh.3.0.i.i = phi i1 [ %.3409331.i.i, %B2912.i.i ], [ true, %B486.preheader.i.i ]
  %window.2.0.i.i = phi double [ %window.3.1.i.i, %B2912.i.i ], [ %.3647.i, %B486.preheader.i.i ]
  br i1 %fresh.3.0.i.i, label %B490.i.i, label %B748.endif.i.i
B490.i.i:
  store double %t.2.0.i.i, ptr %.2042.i, align 8, !noalias !7
  %.40.i.i.i = fsub double %t.2.0.i.i, %.3647.i
  br i1 %61, label %B490.endif.i.i, label %B56.i.i.i
B56.i.i.i:
  %lsr.iv.i.i.i = phi ptr [ %scevgep1.i.i.i, %B316.i.i.i ], [ %scevgep.i182.i.i, %B490.i.i ]
  %.138222224.i.i.i = phi i64 [ %.145.i.i.i, %B316.i.i.i ], [ 0, %B490.i.i ]
  %.145.i.i.i = add nuw nsw i64 %.138222224.i.i.i, 1
  %scevgep6.i.i.i = getelementptr i8, ptr %lsr.iv.i.i.i, i64 -40
  %.227.i.i.i = load double, ptr %scevgep6.i.i.i, align 8, !noalias !11
  %scevgep5.i.i.i = getelementptr i8, ptr %lsr.iv.i.i.i, i64 -32
  %.282.i.i.i = load double, ptr %scevgep5.i.i.i, align 8, !noalias !11
  %.284.i.i.i = fmul double %.40.i.i.i, %.282.i.i.i
  %.285.i.i.i = fadd double %.227.i.i.i, %.284.i.i.i
  %scevgep4.i.i.i = getelementptr i8, ptr %lsr.iv.i.i.i, i64 -24
  %.347.i.i.i = load double, ptr %scevgep4.i.i.i, align 8, !noalias !11
  %.348.i.i.i = fcmp une double %.347.i.i.i, 0.000000e+00
  br i1 %.348.i.i.i, label %B134.i.i.i, label %B316.i.i.i
B134.i.i.i:
  %scevgep3.i.i.i = getelementptr i8, ptr %lsr.iv.i.i.i, i64 -16
  %.405.i.i.i = load double, ptr %scevgep3.i.i.i, align 8, !noalias !11
  %scevgep2.i.i.i = getelementptr i8, ptr %lsr.iv.i.i.i, i64 -8
  %.460.i.i.i = load double, ptr %scevgep2.i.i.i, align 8, !noalias !11
  %.461.i.i.i = fmul double %.460.i.i.i, 5.000000e-01
  %.463.i.i.i = fmul double %.40.i.i.i, %.461.i.i.i
  %.464.i.i.i = fadd double %.405.i.i.i, %.463.i.i.i
  %.465.i.i.i = fmul double %.464.i.i.i, 0x401921FB54442D18
  %.467.i.i.i = fmul double %.40.i.i.i, %.465.i.i.i
  %.522.i.i.i = load double, ptr %lsr.iv.i.i.i, align 8, !noalias !11
  %.523.i.i.i = fadd double %.522.i.i.i, %.467.i.i.i
  %.586.le.i.i.i = tail call double @llvm.sin.f64(double %.523.i.i.i)
  %.591.i.i.i = fmul double %.347.i.i.i, %.586.le.i.i.i
  %.593.i.i.i = fadd double %.285.i.i.i, %.591.i.i.i
  br label %B316.i.i.i
B316.i.i.i:
  %value.2.1.i.i.i = phi double [ %.593.i.i.i, %B134.i.i.i ], [ %.285.i.i.i, %B56.i.i.i ]
  %11 = shl i64 %.138222224.i.i.i, 3
  %scevgep7.i.i.i = getelementptr i8, ptr %.1528.i, i64 %11
  store double %value.2.1.i.i.i, ptr %scevgep7.i.i.i, align 8, !noalias !11
  %scevgep1.i.i.i = getelementptr i8, ptr %lsr.iv.i.i.i, i64 48
  %exitcond.not.i.i.i = icmp eq i64 %.1503.i, %.145.i.i.i
  br i1 %exitcond.not.i.i.i, label %B490.endif.i.i, label %B56.i.i.i
B656.i.i:
  %.2583.i.i = fsub double %"$phi1338.1.2.1.i", %t.2.0.i.i
  %.56.i.i.i = fdiv double 2.000000e+01, %.2583.i.i
  br i1 %83, label %B656.endif.i.i, label %B66.backedge.i.i.i
B66.backedge.i.i.i:
  %fastest.2.0128.i.i.i = phi double [ %.13.i.i.i.i, %B66.backedge.i.i.i ], [ %.56.i.i.i, %B656.i.i ]
  %.162124126.i.i.i = phi i64 [ %.169.i.i.i, %B66.backedge.i.i.i ], [ 0, %B656.i.i ]
  %12 = shl i64 %.162124126.i.i.i, 3
  %scevgep3.i142.i.i = getelementptr i8, ptr %.1171.i, i64 %12
  %.223.i.i.i = load double, ptr %scevgep3.i142.i.i, align 8, !noalias !14
  %.224.i.i.i = tail call double @llvm.fabs.f64(double %.223.i.i.i)
  %.225.i.i.i = fmul double %.224.i.i.i, 2.000000e+01
  %scevgep2.i143.i.i = getelementptr i8, ptr %a2, i64 %12
  %.255.i.i.i = load double, ptr %scevgep2.i143.i.i, align 8, !noalias !14
  %.256.i.i.i = tail call double @llvm.fabs.f64(double %.255.i.i.i)
  %scevgep133.i.i = getelementptr i8, ptr %79, i64 %12
  %.310.i.i.i = load double, ptr %scevgep133.i.i, align 8, !noalias !14
  %.311.i.i.i = fadd double %.256.i.i.i, %.310.i.i.i
  %.315.i.i.i = fdiv double %.225.i.i.i, %.311.i.i.i
  %.12.i.i.i.i = fcmp ogt double %.315.i.i.i, %fastest.2.0128.i.i.i
  %.13.i.i.i.i = select i1 %.12.i.i.i.i, double %.315.i.i.i, double %fastest.2.0128.i.i.i
  %.169.i.i.i = add nuw nsw i64 %.162124126.i.i.i, 1
  %exitcond.not.i145.i.i = icmp eq i64 %.25.i, %.169.i.i.i
  br i1 %exitcond.not.i145.i.i, label %B656.endif.i.i, label %B66.backedge.i.i.i
B710.i.i:
  %.2626.i.i = fneg double %h.5.0.i.i
  %.12.i.i.i = fcmp olt double %.373.i.i.i, %.2626.i.i
  %.13.i.i.i = select i1 %.12.i.i.i, double %.373.i.i.i, double %.2626.i.i
  br label %B748.endif.i.i
B820.i.i:
  %.2767.i.i = fcmp olt double %.13.i147.i.i, %.2753.i.i
  br i1 %.2767.i.i, label %B862.i.i, label %B854.i.i
B854.i.i:
  br label %B862.i.i
B862.i.i:
  %"$phi862.0.3.1.i.i" = phi double [ %.2753.i.i, %B854.i.i ], [ %.13.i147.i.i, %B748.endif.i.i ], [ %.2754.i.i, %B820.i.i ]
  br i1 %exitcond.not.i177.i.i, label %B1008.i.i, label %switch.lookup.i.i
B1008.i.i:
  store double %t.2.0.i.i, ptr %.2042.i, align 8, !noalias !7
  store double %"$phi862.0.3.1.i.i", ptr %sunkaddr168.i.i, align 8, !noalias !7
  tail call void %7(ptr nonnull %.2042.i, ptr %a2, ptr %.1699.i, ptr %a3, ptr %.1171.i, ptr %.2524.i, ptr %.740.i.i, ptr %.2892.i, ptr %.1434.i.i, ptr %.914.i.i), !noalias !7
  br i1 %83, label %B1008.endif.thread333.i.i, label %B62.i.i.i
B1008.endif.thread333.i.i:
  %.3376335.i.i = load i64, ptr %sunkaddr181.i.i, align 8, !noalias !7
  %.3377336.i.i = add nsw i64 %.3376335.i.i, 1
  store i64 %.3377336.i.i, ptr %sunkaddr181.i.i, align 8, !noalias !7
  br label %B1182.i.i
B62.i.i.i:
  %worst.2.0263.i.i.i = phi double [ %worst.3.1.i.i.i, %B176.endif.i.i.i ], [ 0.000000e+00, %B1008.i.i ]
  %.185258261.i.i.i = phi i64 [ %.192.i.i.i, %B176.endif.i.i.i ], [ 0, %B1008.i.i ]
  %.192.i.i.i = add nuw nsw i64 %.185258261.i.i.i, 1
  %13 = shl i64 %.185258261.i.i.i, 3
  %scevgep5.i148.i.i = getelementptr i8, ptr %.914.i.i, i64 %13
  %.250.i.i.i = load double, ptr %scevgep5.i148.i.i, align 8, !noalias !17
  %.262.le.i.i.i = fsub double %.250.i.i.i, %.250.i.i.i
  %.263.le.i.i.i = fcmp ord double %.262.le.i.i.i, 0.000000e+00
  br i1 %.263.le.i.i.i, label %B120.i.i.i, label %B1008.endif.thread.i.i
B120.i.i.i:
  %14 = getelementptr i8, ptr %a9, i64 %.185258261.i.i.i
  %.308.i.i.i = load i8, ptr %14, align 1, !noalias !17
  %.309.i.i.i = icmp ne i8 %.308.i.i.i, 0
  %.312.i.i.i = fcmp ole double %.250.i.i.i, 0.000000e+00
  %or.cond.i.i.i = and i1 %.312.i.i.i, %.309.i.i.i
  br i1 %or.cond.i.i.i, label %B1008.endif.thread.i.i, label %B176.endif.i.i.i
B176.endif.i.i.i:
  %scevgep137.i.i = getelementptr i8, ptr %scevgep468.i.i, i64 %13
  %.385.i.i.i = load double, ptr %scevgep137.i.i, align 8, !noalias !17
  %scevgep136.i.i = getelementptr i8, ptr %scevgep135.i.i, i64 %13
  %.441.i.i.i = load double, ptr %scevgep136.i.i, align 8, !noalias !17
  %scevgep134.i.i = getelementptr i8, ptr %a8, i64 %13
  %.496.i.i.i = load double, ptr %scevgep134.i.i, align 8, !noalias !17
  %scevgep.i4.i = getelementptr i8, ptr %a2, i64 %13
  %.527.i.i.i = load double, ptr %scevgep.i4.i, align 8, !noalias !17
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
  %exitcond.not.i155.i.i = icmp eq i64 %.25.i, %.192.i.i.i
  br i1 %exitcond.not.i155.i.i, label %B1008.endif.i.i, label %B62.i.i.i
B1182.i.i:
  %storemerge.i338.i.i = phi double [ 0.000000e+00, %B1008.endif.thread333.i.i ], [ %worst.3.1.i.i.i, %B1008.endif.i.i ]
  %15 = fcmp oge double %"$phi862.0.3.1.i.i", %.2753.i.i
  %.3424.i.i = fadd double %t.2.0.i.i, %"$phi862.0.3.1.i.i"
  %"$phi1198.0.2.1.i.i" = select i1 %15, double %"$phi1338.1.2.1.i", double %.3424.i.i
  br i1 %60, label %B1304.i.i, label %B1208.i.i
B1208.i.i:
  %.3468.i.i = load i64, ptr %.179.i.i, align 8, !noalias !7
  %.3482.i.i = icmp slt i64 %.3468.i.i, 0
  %.3483.i.i = select i1 %.3482.i.i, i64 %.69.i, i64 0
  %16 = getelementptr double, ptr %a7, i64 %.3468.i.i
  %.3497.i.i = getelementptr double, ptr %16, i64 %.3483.i.i
  %.3498.i.i = load double, ptr %.3497.i.i, align 8, !noalias !7
  %.3500.i.i = fcmp olt double %.3498.i.i, %"$phi1198.0.2.1.i.i"
  br i1 %.3500.i.i, label %B1300.i.i, label %B1396.i.i
B1300.i.i:
  %.3531.i.i = load i64, ptr %sunkaddr170.i.i, align 8, !noalias !7
  %.3546.i.i = inttoptr i64 %.3531.i.i to ptr
  tail call void %.3546.i.i(ptr %.1434.i.i, ptr %.1262.i.i), !noalias !7
  br label %B1396.i.i
B1304.i.i:
  %.35313775.i.i = load i64, ptr %sunkaddr170.i.i, align 8, !noalias !7
  %.35463776.i.i = inttoptr i64 %.35313775.i.i to ptr
  tail call void %.35463776.i.i(ptr %.1434.i.i, ptr %.1262.i.i), !noalias !7
  %.556.i.i.i = fmul double %.3424.i.i, 4.000000e-16
  br label %B18.outer.i.i.i
B18.outer.i.i.i:
  %low.4.1.ph.i.i.i = phi double [ 0.000000e+00, %B1304.i.i ], [ %low.3.2.i.i.i, %B240.i.i.i ]
  %high.3.1.ph.i.i.i = phi double [ 5.000000e-01, %B1304.i.i ], [ %.544.i.i.i, %B240.i.i.i ]
  %event.2.1.ph.i.i.i = phi i64 [ -1, %B1304.i.i ], [ %event.4.2.i.i.i, %B240.i.i.i ]
  %theta.2.1.ph.i.i.i = phi double [ 0.000000e+00, %B1304.i.i ], [ %theta.1.2.i.i.i, %B240.i.i.i ]
  br label %B18.i.i.i
B18.i.i.i:
  %low.4.1.i.i.i = phi double [ 5.000000e-01, %B186.i.i.i ], [ %low.4.1.ph.i.i.i, %B18.outer.i.i.i ]
  %high.3.1.i.i.i = phi double [ 1.000000e+00, %B186.i.i.i ], [ %high.3.1.ph.i.i.i, %B18.outer.i.i.i ]
  %event.2.1.i.i.i = phi i64 [ -1, %B186.i.i.i ], [ %event.2.1.ph.i.i.i, %B18.outer.i.i.i ]
  %.64.i.i.i.i = fsub double 1.000000e+00, %high.3.1.i.i.i
  br i1 %8, label %B18.endif.i.i.i, label %B60.i.i.i.i
B60.i.i.i.i:
  %.166146148.i.i.i.i = phi i64 [ %.173.i.i.i.i, %B60.i.i.i.i ], [ 0, %B18.i.i.i ]
  %.173.i.i.i.i = add nuw nsw i64 %.166146148.i.i.i.i, 1
  %17 = shl i64 %.166146148.i.i.i.i, 3
  %scevgep4.i.i.i.i = getelementptr i8, ptr %a2, i64 %17
  %.227.i.i.i.i = load double, ptr %scevgep4.i.i.i.i, align 8, !noalias !20
  %.229.i.i.i.i = fmul double %.64.i.i.i.i, %.227.i.i.i.i
  %scevgep3.i.i.i.i = getelementptr i8, ptr %.914.i.i, i64 %17
  %.259.i.i.i.i = load double, ptr %scevgep3.i.i.i.i, align 8, !noalias !20
  %scevgep65.i.i.i = getelementptr i8, ptr %.1262.i.i, i64 %17
  %.289.i.i.i.i = load double, ptr %scevgep65.i.i.i, align 8, !noalias !20
  %scevgep64.i.i.i = getelementptr i8, ptr %invariant.gep.i.i.i.i, i64 %17
  %.321.i.i.i.i = load double, ptr %scevgep64.i.i.i, align 8, !noalias !20
  %.323.i.i.i.i = fmul double %high.3.1.i.i.i, %.321.i.i.i.i
  %.324.i.i.i.i = fadd double %.289.i.i.i.i, %.323.i.i.i.i
  %.326.i.i.i.i = fmul double %.64.i.i.i.i, %.324.i.i.i.i
  %.327.i.i.i.i = fadd double %.259.i.i.i.i, %.326.i.i.i.i
  %.329.i.i.i.i = fmul double %high.3.1.i.i.i, %.327.i.i.i.i
  %.330.i.i.i.i = fadd double %.229.i.i.i.i, %.329.i.i.i.i
  %scevgep63.i.i.i = getelementptr i8, ptr %.1088.i.i, i64 %17
  store double %.330.i.i.i.i, ptr %scevgep63.i.i.i, align 8, !noalias !20
  %exitcond.not.i.i.i.i = icmp eq i64 %.1063.i.i, %.173.i.i.i.i
  br i1 %exitcond.not.i.i.i.i, label %B18.endif.i.i.i, label %B60.i.i.i.i
B186.i.i.i:
  %.381.i.i.i = fcmp oeq double %high.3.1.i.i.i, 1.000000e+00
  br i1 %.381.i.i.i, label %_ZN6poppet6engine10integrator12_stop_insideB3v17B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE.exit.i.i, label %B18.i.i.i
B240.i.i.i:
  %low.3.2.i.i.i = phi double [ %low.4.1.i.i.i, %B252.1.i.i.i.i ], [ %high.3.1.i.i.i, %B18.endif.endif.endif.thread13.i.i.i ]
  %theta.1.2.i.i.i = phi double [ %high.3.1.i.i.i, %B252.1.i.i.i.i ], [ %theta.2.1.ph.i.i.i, %B18.endif.endif.endif.thread13.i.i.i ]
  %event.4.2.i.i.i = phi i64 [ %.284326331.i.i.i.i, %B252.1.i.i.i.i ], [ %event.2.1.i.i.i, %B18.endif.endif.endif.thread13.i.i.i ]
  %.543.i.i.i = fadd double %low.3.2.i.i.i, %theta.1.2.i.i.i
  %.544.i.i.i = fmul double %.543.i.i.i, 5.000000e-01
  %.550.i.i.i = fsub double %theta.1.2.i.i.i, %low.3.2.i.i.i
  %.552.i.i.i = fmul double %"$phi862.0.3.1.i.i", %.550.i.i.i
  %.557.i.i.i = fcmp ole double %.552.i.i.i, %.556.i.i.i
  %.561.i.i.i = fcmp ole double %.544.i.i.i, %low.3.2.i.i.i
  %or.cond.i2.i.i = or i1 %.557.i.i.i, %.561.i.i.i
  %.565.i.i.i = fcmp oge double %.544.i.i.i, %theta.1.2.i.i.i
  %or.cond319.i.i.i = or i1 %.565.i.i.i, %or.cond.i2.i.i
  br i1 %or.cond319.i.i.i, label %B316.i3.i.i, label %B18.outer.i.i.i
B316.i3.i.i:
  %.64.i18.i.i.i = fsub double 1.000000e+00, %theta.1.2.i.i.i
  br i1 %8, label %_ZN6poppet6engine10integrator12_stop_insideB3v17B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE.exit.i.i, label %B60.i22.i.i.i
B60.i22.i.i.i:
  %.166146148.i23.i.i.i = phi i64 [ %.173.i24.i.i.i, %B60.i22.i.i.i ], [ 0, %B316.i3.i.i ]
  %.173.i24.i.i.i = add nuw nsw i64 %.166146148.i23.i.i.i, 1
  %18 = shl i64 %.166146148.i23.i.i.i, 3
  %scevgep4.i25.i.i.i = getelementptr i8, ptr %a2, i64 %18
  %.227.i26.i.i.i = load double, ptr %scevgep4.i25.i.i.i, align 8, !noalias !25
  %.229.i27.i.i.i = fmul double %.64.i18.i.i.i, %.227.i26.i.i.i
  %scevgep3.i28.i.i.i = getelementptr i8, ptr %.914.i.i, i64 %18
  %.259.i29.i.i.i = load double, ptr %scevgep3.i28.i.i.i, align 8, !noalias !25
  %scevgep62.i.i.i = getelementptr i8, ptr %.1262.i.i, i64 %18
  %.289.i31.i.i.i = load double, ptr %scevgep62.i.i.i, align 8, !noalias !25
  %scevgep61.i.i.i = getelementptr i8, ptr %invariant.gep.i.i.i.i, i64 %18
  %.321.i33.i.i.i = load double, ptr %scevgep61.i.i.i, align 8, !noalias !25
  %.323.i34.i.i.i = fmul double %theta.1.2.i.i.i, %.321.i33.i.i.i
  %.324.i35.i.i.i = fadd double %.289.i31.i.i.i, %.323.i34.i.i.i
  %.326.i36.i.i.i = fmul double %.64.i18.i.i.i, %.324.i35.i.i.i
  %.327.i37.i.i.i = fadd double %.259.i29.i.i.i, %.326.i36.i.i.i
  %.329.i38.i.i.i = fmul double %theta.1.2.i.i.i, %.327.i37.i.i.i
  %.330.i39.i.i.i = fadd double %.229.i27.i.i.i, %.329.i38.i.i.i
  %scevgep60.i.i.i = getelementptr i8, ptr %.1088.i.i, i64 %18
  store double %.330.i39.i.i.i, ptr %scevgep60.i.i.i, align 8, !noalias !25
  %exitcond.not.i41.i.i.i = icmp eq i64 %.1063.i.i, %.173.i24.i.i.i
  br i1 %exitcond.not.i41.i.i.i, label %_ZN6poppet6engine10integrator12_stop_insideB3v17B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE.exit.i.i, label %B60.i22.i.i.i
B18.endif.i.i.i:
  %.275.i1.i.i = fmul double %"$phi862.0.3.1.i.i", %high.3.1.i.i.i
  %.277.i.i.i = fadd double %t.2.0.i.i, %.275.i1.i.i
  %.40.i.i.i.i = fsub double %.277.i.i.i, %.3647.i
  br i1 %61, label %B18.endif.endif.i.i.i, label %B56.i.i.i.i
B56.i.i.i.i:
  %lsr.iv.i.i.i.i = phi ptr [ %scevgep1.i46.i.i.i, %B316.i.i.i.i ], [ %scevgep.i182.i.i, %B18.endif.i.i.i ]
  %.138222224.i.i.i.i = phi i64 [ %.145.i.i.i.i, %B316.i.i.i.i ], [ 0, %B18.endif.i.i.i ]
  %.145.i.i.i.i = add nuw nsw i64 %.138222224.i.i.i.i, 1
  %scevgep6.i.i.i.i = getelementptr i8, ptr %lsr.iv.i.i.i.i, i64 -40
  %.227.i44.i.i.i = load double, ptr %scevgep6.i.i.i.i, align 8, !noalias !28
  %scevgep5.i.i.i.i = getelementptr i8, ptr %lsr.iv.i.i.i.i, i64 -32
  %.282.i.i.i.i = load double, ptr %scevgep5.i.i.i.i, align 8, !noalias !28
  %.284.i.i.i.i = fmul double %.40.i.i.i.i, %.282.i.i.i.i
  %.285.i.i.i.i = fadd double %.227.i44.i.i.i, %.284.i.i.i.i
  %scevgep4.i45.i.i.i = getelementptr i8, ptr %lsr.iv.i.i.i.i, i64 -24
  %.347.i.i.i.i = load double, ptr %scevgep4.i45.i.i.i, align 8, !noalias !28
  %.348.i.i.i.i = fcmp une double %.347.i.i.i.i, 0.000000e+00
  br i1 %.348.i.i.i.i, label %B134.i.i.i.i, label %B316.i.i.i.i
B134.i.i.i.i:
  %scevgep3.i48.i.i.i = getelementptr i8, ptr %lsr.iv.i.i.i.i, i64 -16
  %.405.i.i.i.i = load double, ptr %scevgep3.i48.i.i.i, align 8, !noalias !28
  %scevgep2.i49.i.i.i = getelementptr i8, ptr %lsr.iv.i.i.i.i, i64 -8
  %.460.i.i.i.i = load double, ptr %scevgep2.i49.i.i.i, align 8, !noalias !28
  %.461.i.i.i.i = fmul double %.460.i.i.i.i, 5.000000e-01
  %.463.i.i.i.i = fmul double %.40.i.i.i.i, %.461.i.i.i.i
  %.464.i.i.i.i = fadd double %.405.i.i.i.i, %.463.i.i.i.i
  %.465.i.i.i.i = fmul double %.464.i.i.i.i, 0x401921FB54442D18
  %.467.i.i.i.i = fmul double %.40.i.i.i.i, %.465.i.i.i.i
  %.522.i.i.i.i = load double, ptr %lsr.iv.i.i.i.i, align 8, !noalias !28
  %.523.i.i.i.i = fadd double %.522.i.i.i.i, %.467.i.i.i.i
  %.586.le.i.i.i.i = tail call double @llvm.sin.f64(double %.523.i.i.i.i)
  %.591.i.i.i.i = fmul double %.347.i.i.i.i, %.586.le.i.i.i.i
  %.593.i.i.i.i = fadd double %.285.i.i.i.i, %.591.i.i.i.i
  br label %B316.i.i.i.i
B316.i.i.i.i:
  %value.2.1.i.i.i.i = phi double [ %.593.i.i.i.i, %B134.i.i.i.i ], [ %.285.i.i.i.i, %B56.i.i.i.i ]
  %19 = shl i64 %.138222224.i.i.i.i, 3
  %scevgep7.i.i.i.i = getelementptr i8, ptr %.1528.i, i64 %19
  store double %value.2.1.i.i.i.i, ptr %scevgep7.i.i.i.i, align 8, !noalias !28
  %scevgep1.i46.i.i.i = getelementptr i8, ptr %lsr.iv.i.i.i.i, i64 48
  %exitcond.not.i47.i.i.i = icmp eq i64 %.1503.i, %.145.i.i.i.i
  br i1 %exitcond.not.i47.i.i.i, label %B18.endif.endif.i.i.i, label %B56.i.i.i.i
B18.endif.endif.i.i.i:
  store double %.277.i.i.i, ptr %.2042.i, align 8, !noalias !31
  tail call void %9(ptr nonnull %.2042.i, ptr %.1088.i.i, ptr %.1528.i, ptr %a3, ptr %.3062.i), !noalias !31
  br label %B108.endif.endif.i.i.i.i
B106.i.i.i.i:
  %.291.i.i.i.i = add nuw nsw i64 %.284326331.i.i.i.i, 1
  %scevgep1.i54.i.i.i = getelementptr i8, ptr %lsr.iv.i52.i.i.i, i64 16
  %scevgep5.i55.i.i.i = getelementptr i8, ptr %lsr.iv4.i.i.i.i, i64 24
  %exitcond.not.i56.i.i.i = icmp eq i64 %.71.i, %.291.i.i.i.i
  br i1 %exitcond.not.i56.i.i.i, label %B18.endif.endif.endif.thread13.i.i.i, label %B108.endif.endif.i.i.i.i
B192.i.i.i.i:
  %sunkaddr.i.i.i.i = getelementptr i8, ptr %lsr.iv4.i.i.i.i, i64 -16
  %.612.i.i.i.i = load double, ptr %sunkaddr.i.i.i.i, align 8, !noalias !31
  %.701.i.i.i.i = getelementptr double, ptr %.3062.i, i64 %.554.i.i.i.i
  %.702.i.i.i.i = load double, ptr %.701.i.i.i.i, align 8, !noalias !31
  %.703.i.i.i.i = fmul double %.612.i.i.i.i, %.702.i.i.i.i
  %.705.i.i.i.i = fadd double %.373.i.i.i.i, %.703.i.i.i.i
  br label %B252.i.i.i.i
B252.i.i.i.i:
  %value.3.2.i.i.i.i = phi double [ %.705.i.i.i.i, %B192.i.i.i.i ], [ %.373.i.i.i.i, %B108.endif.endif.i.i.i.i ]
  %.554.1.i.i.i.i = load i64, ptr %lsr.iv.i52.i.i.i, align 8, !noalias !31
  %.557.1.i.i.i.i = icmp sgt i64 %.554.1.i.i.i.i, -1
  br i1 %.557.1.i.i.i.i, label %B192.1.i.i.i.i, label %B252.1.i.i.i.i
B192.1.i.i.i.i:
  %scevgep6.i57.i.i.i = getelementptr i8, ptr %lsr.iv4.i.i.i.i, i64 -8
  %.612.1.i.i.i.i = load double, ptr %scevgep6.i57.i.i.i, align 8, !noalias !31
  %.701.1.i.i.i.i = getelementptr double, ptr %.3062.i, i64 %.554.1.i.i.i.i
  %.702.1.i.i.i.i = load double, ptr %.701.1.i.i.i.i, align 8, !noalias !31
  %.703.1.i.i.i.i = fmul double %.612.1.i.i.i.i, %.702.1.i.i.i.i
  %.705.1.i.i.i.i = fadd double %value.3.2.i.i.i.i, %.703.1.i.i.i.i
  br label %B252.1.i.i.i.i
B252.1.i.i.i.i:
  %value.3.2.1.i.i.i.i = phi double [ %.705.1.i.i.i.i, %B192.1.i.i.i.i ], [ %value.3.2.i.i.i.i, %B252.i.i.i.i ]
  %.724.i.i.i.i = fcmp ogt double %value.3.2.1.i.i.i.i, 0.000000e+00
  br i1 %.724.i.i.i.i, label %B240.i.i.i, label %B106.i.i.i.i
B108.endif.endif.i.i.i.i:
  %lsr.iv4.i.i.i.i = phi ptr [ %scevgep5.i55.i.i.i, %B106.i.i.i.i ], [ %scevgep3.i135.i, %B18.endif.endif.i.i.i ]
  %lsr.iv.i52.i.i.i = phi ptr [ %scevgep1.i54.i.i.i, %B106.i.i.i.i ], [ %scevgep.i134.i, %B18.endif.endif.i.i.i ]
  %.284326331.i.i.i.i = phi i64 [ %.291.i.i.i.i, %B106.i.i.i.i ], [ 0, %B18.endif.endif.i.i.i ]
  %.373.i.i.i.i = load double, ptr %lsr.iv4.i.i.i.i, align 8, !noalias !31
  %scevgep2.i53.i.i.i = getelementptr i8, ptr %lsr.iv.i52.i.i.i, i64 -8
  %.554.i.i.i.i = load i64, ptr %scevgep2.i53.i.i.i, align 8, !noalias !31
  %.557.i.i.i.i = icmp sgt i64 %.554.i.i.i.i, -1
  br i1 %.557.i.i.i.i, label %B192.i.i.i.i, label %B252.i.i.i.i
B18.endif.endif.endif.thread13.i.i.i:
  %.37115.i.i.i = icmp slt i64 %event.2.1.i.i.i, 0
  br i1 %.37115.i.i.i, label %B186.i.i.i, label %B240.i.i.i
_ZN6poppet6engine10integrator12_stop_insideB3v17B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE.exit.i.i:
  %event.4.2.lcssa.sink.i.i.i = phi i64 [ -1, %B186.i.i.i ], [ %event.4.2.i.i.i, %B316.i3.i.i ], [ %event.4.2.i.i.i, %B60.i22.i.i.i ]
  %theta.1.2.lcssa.sink.i.i.i = phi double [ 1.000000e+00, %B186.i.i.i ], [ %theta.1.2.i.i.i, %B316.i3.i.i ], [ %theta.1.2.i.i.i, %B60.i22.i.i.i ]
  %.3648.i.i = icmp sgt i64 %event.4.2.lcssa.sink.i.i.i, -1
  br i1 %.3648.i.i, label %B1380.i.i, label %B1396.i.i
B1380.i.i:
  %.3657.i.i = fmul double %"$phi862.0.3.1.i.i", %theta.1.2.lcssa.sink.i.i.i
  %.3661.i.i = fadd double %t.2.0.i.i, %.3657.i.i
  br label %B1396.i.i
B1396.i.i:
  %event.2.1.i.i = phi i64 [ %event.4.2.lcssa.sink.i.i.i, %B1380.i.i ], [ %event.4.2.lcssa.sink.i.i.i, %_ZN6poppet6engine10integrator12_stop_insideB3v17B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE.exit.i.i ], [ -1, %B1300.i.i ], [ -1, %B1208.i.i ]
  %end.2.1.i.i = phi double [ %.3661.i.i, %B1380.i.i ], [ %"$phi1198.0.2.1.i.i", %_ZN6poppet6engine10integrator12_stop_insideB3v17B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE.exit.i.i ], [ %"$phi1198.0.2.1.i.i", %B1300.i.i ], [ %"$phi1198.0.2.1.i.i", %B1208.i.i ]
  %.3700.i.i = load i64, ptr %.179.i.i, align 8, !noalias !7
  %.3708.i.i = icmp slt i64 %.3700.i.i, %.69.i
  br i1 %.3708.i.i, label %B1430.i.i, label %B1784.endif.i.i
B1430.i.i:
  %.3753.i.i = icmp slt i64 %.3700.i.i, 0
  %.3754.i.i = select i1 %.3753.i.i, i64 %.69.i, i64 0
  %20 = getelementptr double, ptr %a7, i64 %.3700.i.i
  %.3768.i.i = getelementptr double, ptr %20, i64 %.3754.i.i
  %.3769.i.i = load double, ptr %.3768.i.i, align 8, !noalias !7
  %.3771.i.i = fcmp olt double %.3769.i.i, %end.2.1.i.i
  br i1 %.3771.i.i, label %B1466.i.i, label %B1784.endif.i.i
B1466.i.i:
  %.3806.i.i = phi i64 [ %.4140.i.i, %B1748.i.i ], [ %.3700.i.i, %B1430.i.i ]
  %.3820.i.i = icmp slt i64 %.3806.i.i, 0
  %.3821.i.i = select i1 %.3820.i.i, i64 %.69.i, i64 0
  %21 = getelementptr double, ptr %a7, i64 %.3806.i.i
  %.3835.i.i = getelementptr double, ptr %21, i64 %.3821.i.i
  %.3836.i.i = load double, ptr %.3835.i.i, align 8, !noalias !7
  %.3838.i.i = fsub double %.3836.i.i, %t.2.0.i.i
  %.3843.i.i = fdiv double %.3838.i.i, %"$phi862.0.3.1.i.i"
  %.64.i.i.i = fsub double 1.000000e+00, %.3843.i.i
  br i1 %10, label %B1466.endif.endif.i.i, label %B60.i.i.i
B60.i.i.i:
  %.166146148.i.i.i = phi i64 [ %.173.i.i.i, %B60.i.i.i ], [ 0, %B1466.i.i ]
  %.173.i.i.i = add nuw nsw i64 %.166146148.i.i.i, 1
  %22 = shl i64 %.166146148.i.i.i, 3
  %scevgep4.i156.i.i = getelementptr i8, ptr %a2, i64 %22
  %.227.i157.i.i = load double, ptr %scevgep4.i156.i.i, align 8, !noalias !34
  %.229.i.i.i = fmul double %.64.i.i.i, %.227.i157.i.i
  %scevgep3.i158.i.i = getelementptr i8, ptr %.914.i.i, i64 %22
  %.259.i.i.i = load double, ptr %scevgep3.i158.i.i, align 8, !noalias !34
  %scevgep140.i.i = getelementptr i8, ptr %.1262.i.i, i64 %22
  %.289.i.i.i = load double, ptr %scevgep140.i.i, align 8, !noalias !34
  %scevgep139.i.i = getelementptr i8, ptr %invariant.gep.i.i.i, i64 %22
  %.321.i.i.i = load double, ptr %scevgep139.i.i, align 8, !noalias !34
  %.323.i.i.i = fmul double %.3843.i.i, %.321.i.i.i
  %.324.i.i.i = fadd double %.289.i.i.i, %.323.i.i.i
  %.326.i.i.i = fmul double %.64.i.i.i, %.324.i.i.i
  %.327.i.i.i = fadd double %.259.i.i.i, %.326.i.i.i
  %.329.i.i.i = fmul double %.3843.i.i, %.327.i.i.i
  %.330.i.i.i = fadd double %.229.i.i.i, %.329.i.i.i
  %scevgep138.i.i = getelementptr i8, ptr %.740.i.i, i64 %22
  store double %.330.i.i.i, ptr %scevgep138.i.i, align 8, !noalias !34
  %exitcond.not.i162.i.i = icmp eq i64 %.715.i.i, %.173.i.i.i
  br i1 %exitcond.not.i162.i.i, label %B1466.endif.endif.loopexit.i.i, label %B60.i.i.i
B1748.i.i:
  %.4253.i.i = icmp slt i64 %.4139.i.i, -1
  %.4254.i.i = select i1 %.4253.i.i, i64 %.69.i, i64 0
  %23 = getelementptr double, ptr %a7, i64 %.4140.i.i
  %.4268.i.i = getelementptr double, ptr %23, i64 %.4254.i.i
  %.4269.i.i = load double, ptr %.4268.i.i, align 8, !noalias !7
  %.4271.i.i = fcmp olt double %.4269.i.i, %end.2.1.i.i
  br i1 %.4271.i.i, label %B1466.i.i, label %B1784.endif.i.i
B1816.i.i:
  %.436639673970.i.i = phi i64 [ %.4373.i.i, %B1852.endif.endif.i.i ], [ 0, %B1784.endif.i.i ]
  %.4373.i.i = add nuw nsw i64 %.436639673970.i.i, 1
  %24 = shl i64 %.436639673970.i.i, 3
  br i1 %37, label %B1830.i.i, label %B1816.B1852_crit_edge.i.i
B1816.B1852_crit_edge.i.i:
  %scevgep163.i.i = getelementptr i8, ptr %.914.i.i, i64 %24
  %.4531.pre.i.i = load double, ptr %scevgep163.i.i, align 8, !noalias !7
  br label %B1852.endif.endif.i.i
B1830.i.i:
  %scevgep167.i.i = getelementptr i8, ptr %.1088.i.i, i64 %24
  %.4434.i.i = load double, ptr %scevgep167.i.i, align 8, !noalias !7
  %scevgep164.i.i = getelementptr i8, ptr %.914.i.i, i64 %24
  store double %.4434.i.i, ptr %scevgep164.i.i, align 8, !noalias !7
  br label %B1852.endif.endif.i.i
B2114.i.i:
  %.4940.i.i = load i64, ptr %a16, align 8, !noalias !7
  %.4941.i.i = add nsw i64 %.4940.i.i, 1
  store i64 %.4941.i.i, ptr %a16, align 8, !noalias !7
  store double %end.2.1.i.i, ptr %a15, align 8, !noalias !7
  br i1 %37, label %B2176.i.i, label %B2206.endif.i.i
B2176.i.i:
  store i64 %event.2.1.i.i, ptr %.3421.i, align 8, !noalias !7
  br label %_ZN6poppet6engine10integrator8_segmentB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i
B2322.i.i:
  %.5359.i.i = fmul double %"$phi862.0.3.1.i.i", %.13.i4.i.i.i
  %.12.i167.i.i = fcmp ogt double %.5359.i.i, %.13.i147.i.i
  %.13.i168.i.i = select i1 %.12.i167.i.i, double %.5359.i.i, double %.13.i147.i.i
  br label %B2618.else.if.i.i
B2360.i.i:
  %.12.i169.i.i = fcmp olt double %.13.i4.i.i.i, 1.000000e+00
  %.13.i170.i.i = select i1 %.12.i169.i.i, double %.13.i4.i.i.i, double 1.000000e+00
  %"$phi2400.1.2.1.i.i" = select i1 %rejected.3.0.i.i, double %.13.i170.i.i, double %.13.i4.i.i.i
  %.5454.i.i = fmul double %"$phi862.0.3.1.i.i", %"$phi2400.1.2.1.i.i"
  br label %B2618.else.if.i.i
B2558.i.i:
  %"$phi2558.1.2.2.i.i" = phi double [ 1.500000e-01, %for.end.i.i ], [ %.13.i325.i.i, %B2454.endif.i.i ]
  %.5604.i.i = fmul double %"$phi862.0.3.1.i.i", %"$phi2558.1.2.2.i.i"
  %.5617.i.i = fadd double %t.2.0.i.i, %.5604.i.i
  %.5619.i.i = fcmp ole double %.5617.i.i, %t.2.0.i.i
  %.5648.i.i = fcmp olt double %.5604.i.i, 1.000000e-300
  %or.cond.i.i = or i1 %.5648.i.i, %.5619.i.i
  br i1 %or.cond.i.i, label %_ZN6poppet6engine10integrator8_segmentB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i, label %B2618.else.if.i.i
B2722.i.i:
  %.6046.i.i = fsub double %t.3.1.i.i, %window.2.0.i.i
  %.6076.i.i = load double, ptr %sunkaddr176.i.i, align 8, !noalias !7
  %.6078.i.i = fsub double %.6076.i.i, %window.2.0.i.i
  %.6081.i.i = fmul double %.6078.i.i, 1.000000e-04
  %.6082.i.i = fcmp olt double %.6046.i.i, %.6081.i.i
  br i1 %.6082.i.i, label %_ZN6poppet6engine10integrator8_segmentB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i, label %B2784.i.i
B2784.i.i:
  store i64 %.5969.i.i, ptr %sunkaddr209.i.i, align 8, !noalias !7
  br label %B2812.i.i
B2812.i.i:
  %window.3.1.i.i = phi double [ %t.3.1.i.i, %B2784.i.i ], [ %window.2.0.i.i, %B2618.else.if.i.i ]
  %.6405.i.i = load double, ptr %sunkaddr178.i.i, align 8, !noalias !7
  %.6406.i.i = sitofp i64 %.5895.i.i to double
  %.6407.i.i = fcmp ugt double %.6405.i.i, %.6406.i.i
  br i1 %.6407.i.i, label %B2868.i.i, label %_ZN6poppet6engine10integrator8_segmentB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i
B2868.i.i:
  %.6634.i.i = load double, ptr %sunkaddr179.i.i, align 8, !noalias !7
  %.6635.i.i = fcmp une double %.6634.i.i, 0.000000e+00
  br i1 %.6635.i.i, label %_ZN6poppet6engine10integrator8_segmentB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i, label %B2912.i.i
B2912.i.i:
  %.6874.i.i = fcmp olt double %t.3.1.i.i, %"$phi1338.1.2.1.i"
  br i1 %.6874.i.i, label %B486.i.i, label %_ZN6poppet6engine10integrator8_segmentB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i
B0.endif.else.endif.if.i.i:
  br label %B0.endif.else.endif.endif.i.i
B0.endif.else.endif.endif.i.i:
  %.627.sroa.0.3.i.i = phi i64 [ %.1155.i, %B0.endif.else.endif.if.i.i ], [ %.23.i, %B1554.i ]
  br i1 %.659.i.i, label %B0.endif.else.endif.endif.if.i.i, label %B0.endif.else.endif.endif.endif.i.i, !prof !3
B0.endif.else.endif.endif.if.i.i:
  br label %B0.endif.else.endif.endif.endif.i.i
B0.endif.else.endif.endif.endif.i.i:
  %.627.sroa.13.1.i.i = phi i64 [ 0, %B0.endif.else.endif.endif.if.i.i ], [ %.600.i.i, %B0.endif.else.endif.endif.i.i ]
  br i1 %.664.not.i.i, label %B0.endif.endif.else.i.i, label %B0.endif.else.endif.endif.endif.if.i.i, !prof !10
B0.endif.else.endif.endif.endif.if.i.i:
  br label %B0.endif.endif.else.i.i
B0.endif.endif.else.i.i:
  %.627.sroa.13.0.i.i = phi i64 [ %.627.sroa.13.1.i.i, %B0.endif.else.endif.endif.endif.i.i ], [ %.1155.i, %B0.endif.else.endif.endif.endif.if.i.i ]
  %.715.i.i = sub nsw i64 %.627.sroa.13.0.i.i, %.627.sroa.0.3.i.i
  %.724.i1.i = tail call i64 @llvm.smax.i64(i64 %.715.i.i, i64 0)
  %.740.i.i = getelementptr double, ptr %.1171.i, i64 %.627.sroa.0.3.i.i
  br i1 %.659.i.i, label %B0.endif.endif.else.if.i.i, label %B0.endif.endif.else.endif.i.i, !prof !3
B0.endif.endif.else.if.i.i:
  br label %B0.endif.endif.else.endif.i.i
B0.endif.endif.else.endif.i.i:
  %.801.sroa.0.1.i.i = phi i64 [ 0, %B0.endif.endif.else.if.i.i ], [ %.600.i.i, %B0.endif.endif.else.i.i ]
  br i1 %.664.not.i.i, label %B0.endif.endif.else.endif.endif.endif.i.i, label %B0.endif.endif.else.endif.if.i.i, !prof !10
B0.endif.endif.else.endif.if.i.i:
  br label %B0.endif.endif.else.endif.endif.endif.i.i
B0.endif.endif.else.endif.endif.endif.i.i:
  %.801.sroa.0.3.i.i = phi i64 [ %.1155.i, %B0.endif.endif.else.endif.if.i.i ], [ %.801.sroa.0.1.i.i, %B0.endif.endif.else.endif.i.i ]
  %.914.i.i = getelementptr double, ptr %.1171.i, i64 %.801.sroa.0.3.i.i
  br i1 %.838.not.i.i, label %B0.endif.endif.endif.else.endif.endif.endif.i.i, label %B0.endif.endif.endif.else.endif.if.i.i, !prof !10
B0.endif.endif.endif.else.endif.if.i.i:
  br label %B0.endif.endif.endif.else.endif.endif.endif.i.i
B0.endif.endif.endif.else.endif.endif.endif.i.i:
  %.975.sroa.0.3.i.i = phi i64 [ %.1155.i, %B0.endif.endif.endif.else.endif.if.i.i ], [ %.775.i.i, %B0.endif.endif.else.endif.endif.endif.i.i ]
  br i1 %.1012.not.i.i, label %B0.endif.endif.endif.endif.else.i.i, label %B0.endif.endif.endif.else.endif.endif.endif.if.i.i, !prof !10
B0.endif.endif.endif.else.endif.endif.endif.if.i.i:
  br label %B0.endif.endif.endif.endif.else.i.i
B0.endif.endif.endif.endif.else.i.i:
  %.975.sroa.13.0.i.i = phi i64 [ %.949.i.i, %B0.endif.endif.endif.else.endif.endif.endif.i.i ], [ %.1155.i, %B0.endif.endif.endif.else.endif.endif.endif.if.i.i ]
  %.1063.i.i = sub nsw i64 %.975.sroa.13.0.i.i, %.975.sroa.0.3.i.i
  %.1072.i.i = tail call i64 @llvm.smax.i64(i64 %.1063.i.i, i64 0)
  %.1088.i.i = getelementptr double, ptr %.1171.i, i64 %.975.sroa.0.3.i.i
  br i1 %.1012.not.i.i, label %B0.endif.endif.endif.endif.else.endif.endif.endif.i.i, label %B0.endif.endif.endif.endif.else.endif.if.i.i, !prof !10
B0.endif.endif.endif.endif.else.endif.if.i.i:
  br label %B0.endif.endif.endif.endif.else.endif.endif.endif.i.i
B0.endif.endif.endif.endif.else.endif.endif.endif.i.i:
  %.1149.sroa.0.3.i.i = phi i64 [ %.1155.i, %B0.endif.endif.endif.endif.else.endif.if.i.i ], [ %.949.i.i, %B0.endif.endif.endif.endif.else.i.i ]
  %.1262.i.i = getelementptr double, ptr %.1171.i, i64 %.1149.sroa.0.3.i.i
  br i1 %.1186.not.i.i, label %B0.endif.endif.endif.endif.endif.endif.else.i.i, label %B0.endif.endif.endif.endif.endif.else.endif.if.i.i, !prof !10
B0.endif.endif.endif.endif.endif.else.endif.if.i.i:
  br label %B0.endif.endif.endif.endif.endif.endif.else.i.i
B0.endif.endif.endif.endif.endif.endif.else.i.i:
  %.1321.sroa.0.3.i.i = phi i64 [ %.1155.i, %B0.endif.endif.endif.endif.endif.else.endif.if.i.i ], [ %.1123.i.i, %B0.endif.endif.endif.endif.else.endif.endif.endif.i.i ]
  %.1409.i.i = sub nsw i64 %.1155.i, %.1321.sroa.0.3.i.i
  %.1434.i.i = getelementptr double, ptr %.1171.i, i64 %.1321.sroa.0.3.i.i
  %.1733.not.i.i = icmp sgt i64 %.1409.i.i, %.1686.i.i
  br i1 %.1733.not.i.i, label %B0.endif.endif.endif.endif.endif.endif.endif.i.i, label %B0.endif.endif.endif.endif.endif.endif.else.endif.if.i.i, !prof !10
B0.endif.endif.endif.endif.endif.endif.endif.i.i:
  %.1713.sroa.0.3.i.i = phi i64 [ %.1418.i.i, %B0.endif.endif.endif.endif.endif.endif.else.endif.if.i.i ], [ %.1686.i.i, %B0.endif.endif.endif.endif.endif.endif.else.i.i ]
  %scevgep.i173.i.i = getelementptr i8, ptr %.4217.i, i64 16
  br label %B56.i174.i.i
B56.i174.i.i:
  %lsr.iv3.i.i.i = phi i64 [ %lsr.iv.next.i.i.i, %B88.i.i.i ], [ %78, %B0.endif.endif.endif.endif.endif.endif.endif.i.i ]
  %lsr.iv.i175.i.i = phi ptr [ %scevgep1.i176.i.i, %B88.i.i.i ], [ %scevgep.i173.i.i, %B0.endif.endif.endif.endif.endif.endif.endif.i.i ]
  %scevgep1.i176.i.i = getelementptr i8, ptr %lsr.iv.i175.i.i, i64 48
  %lsr.iv.next.i.i.i = add i64 %lsr.iv3.i.i.i, -1
  %exitcond.not.i177.i.i = icmp eq i64 %lsr.iv.next.i.i.i, 0
  br i1 %exitcond.not.i177.i.i, label %B0.endif.endif.endif.endi...endif.5.endif.i.i, label %B58.i.i.i
B58.i.i.i:
  %scevgep2.i178.i.i = getelementptr i8, ptr %lsr.iv.i175.i.i, i64 -8
  %.215.i.i.i = load double, ptr %scevgep2.i178.i.i, align 8, !noalias !37
  %.216.i.i.i = fcmp une double %.215.i.i.i, 0.000000e+00
  br i1 %.216.i.i.i, label %B0.endif.endif.endif.endi...endif.5.endif.i.i, label %B88.i.i.i
B88.i.i.i:
  %.274.i.i.i = load double, ptr %lsr.iv.i175.i.i, align 8, !noalias !37
  %.275.i.i.i = fcmp une double %.274.i.i.i, 0.000000e+00
  br i1 %.275.i.i.i, label %B0.endif.endif.endif.endi...endif.5.endif.i.i, label %B56.i174.i.i
B0.endif.endif.endif.endif.endif.endif.else.endif.if.i.i:
  %.1418.i.i = tail call i64 @llvm.smax.i64(i64 %.1409.i.i, i64 0)
  br label %B0.endif.endif.endif.endif.endif.endif.endif.i.i
B0.endif.endif.endif.endi...endif.5.endif.i.i:
  %.40.i179.i.i = fsub double %.3647.i, %.3647.i
  %scevgep.i182.i.i = getelementptr i8, ptr %.4217.i, i64 40
  br label %B398.else.i.i
B398.else.i.i:
  %.205239553957.i.i = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.5.endif.i.i ], [ %.2059.i.i, %B398.endif.endif.i.i ]
  %.2059.i.i = add nuw nsw i64 %.205239553957.i.i, 1
  %.2086.i.i = mul nuw nsw i64 %.205239553957.i.i, %.1512.i
  %.2089.i.i = mul nuw nsw i64 %.2059.i.i, %.1512.i
  %.2136.not.i.i = icmp sgt i64 %.1674.i, %.2086.i.i
  br i1 %.2136.not.i.i, label %B398.else.endif.endif.endif.i.i, label %B398.else.endif.if.i.i, !prof !10
B398.endif.i.i:
  %.2116.sroa.13.0.i.i = phi i64 [ %.2089.i.i, %B398.else.endif.endif.endif.i.i ], [ %.1683.i, %B398.else.endif.endif.endif.if.i.i ]
  %.132223.not.i180.not.i.i = icmp sgt i64 %.2116.sroa.13.0.i.i, %.2116.sroa.0.3.i.i
  br i1 %.132223.not.i180.not.i.i, label %B56.i183.i.i, label %B398.endif.endif.i.i
B56.i183.i.i:
  %lsr.iv507.i.i = phi i64 [ %lsr.iv.next508.i.i, %B316.i196.i.i ], [ %.2116.sroa.0.3.i.i, %B398.endif.i.i ]
  %lsr.iv.i184.i.i = phi ptr [ %scevgep1.i199.i.i, %B316.i196.i.i ], [ %scevgep.i182.i.i, %B398.endif.i.i ]
  %scevgep6.i187.i.i = getelementptr i8, ptr %lsr.iv.i184.i.i, i64 -40
  %.227.i188.i.i = load double, ptr %scevgep6.i187.i.i, align 8, !noalias !40
  %scevgep5.i189.i.i = getelementptr i8, ptr %lsr.iv.i184.i.i, i64 -32
  %.282.i190.i.i = load double, ptr %scevgep5.i189.i.i, align 8, !noalias !40
  %.284.i191.i.i = fmul double %.40.i179.i.i, %.282.i190.i.i
  %.285.i192.i.i = fadd double %.227.i188.i.i, %.284.i191.i.i
  %scevgep4.i193.i.i = getelementptr i8, ptr %lsr.iv.i184.i.i, i64 -24
  %.347.i194.i.i = load double, ptr %scevgep4.i193.i.i, align 8, !noalias !40
  %.348.i195.i.i = fcmp une double %.347.i194.i.i, 0.000000e+00
  br i1 %.348.i195.i.i, label %B134.i201.i.i, label %B316.i196.i.i
B134.i201.i.i:
  %scevgep3.i202.i.i = getelementptr i8, ptr %lsr.iv.i184.i.i, i64 -16
  %.405.i203.i.i = load double, ptr %scevgep3.i202.i.i, align 8, !noalias !40
  %scevgep2.i204.i.i = getelementptr i8, ptr %lsr.iv.i184.i.i, i64 -8
  %.460.i205.i.i = load double, ptr %scevgep2.i204.i.i, align 8, !noalias !40
  %.461.i206.i.i = fmul double %.460.i205.i.i, 5.000000e-01
  %.463.i207.i.i = fmul double %.40.i179.i.i, %.461.i206.i.i
  %.464.i208.i.i = fadd double %.405.i203.i.i, %.463.i207.i.i
  %.465.i209.i.i = fmul double %.464.i208.i.i, 0x401921FB54442D18
  %.467.i210.i.i = fmul double %.40.i179.i.i, %.465.i209.i.i
  %.522.i211.i.i = load double, ptr %lsr.iv.i184.i.i, align 8, !noalias !40
  %.523.i212.i.i = fadd double %.522.i211.i.i, %.467.i210.i.i
  %.586.le.i213.i.i = tail call double @llvm.sin.f64(double %.523.i212.i.i)
  %.591.i214.i.i = fmul double %.347.i194.i.i, %.586.le.i213.i.i
  %.593.i215.i.i = fadd double %.285.i192.i.i, %.591.i214.i.i
  br label %B316.i196.i.i
B316.i196.i.i:
  %value.2.1.i197.i.i = phi double [ %.593.i215.i.i, %B134.i201.i.i ], [ %.285.i192.i.i, %B56.i183.i.i ]
  %25 = shl i64 %lsr.iv507.i.i, 3
  %scevgep509.i.i = getelementptr i8, ptr %.1699.i, i64 %25
  store double %value.2.1.i197.i.i, ptr %scevgep509.i.i, align 8, !noalias !40
  %scevgep1.i199.i.i = getelementptr i8, ptr %lsr.iv.i184.i.i, i64 48
  %lsr.iv.next508.i.i = add i64 %lsr.iv507.i.i, 1
  %exitcond.not.i200.i.i = icmp eq i64 %.2116.sroa.13.0.i.i, %lsr.iv.next508.i.i
  br i1 %exitcond.not.i200.i.i, label %B398.endif.endif.i.i, label %B56.i183.i.i
B398.else.endif.if.i.i:
  br label %B398.else.endif.endif.endif.i.i
B398.else.endif.endif.endif.i.i:
  %.2116.sroa.0.3.i.i = phi i64 [ %.1683.i, %B398.else.endif.if.i.i ], [ %.2086.i.i, %B398.else.i.i ]
  %.2153.not.i.i = icmp sgt i64 %.1674.i, %.2089.i.i
  br i1 %.2153.not.i.i, label %B398.endif.i.i, label %B398.else.endif.endif.endif.if.i.i, !prof !10
B398.else.endif.endif.endif.if.i.i:
  br label %B398.endif.i.i
B398.endif.endif.i.i:
  %exitcond.not.i2.i = icmp eq i64 %.2059.i.i, 4
  br i1 %exitcond.not.i2.i, label %B472.i.i, label %B398.else.i.i
B490.endif.i.i:
  br i1 %82, label %B490.endif.endif.i.i, label %B56.i220.i.i
B56.i220.i.i:
  %lsr.iv.i221.i.i = phi ptr [ %scevgep1.i228.i.i, %B370.i.i.i ], [ %scevgep.i182.i.i, %B490.endif.i.i ]
  %.138242244.i.i.i = phi i64 [ %.145.i222.i.i, %B370.i.i.i ], [ 0, %B490.endif.i.i ]
  %.145.i222.i.i = add nuw nsw i64 %.138242244.i.i.i, 1
  %scevgep5.i223.i.i = getelementptr i8, ptr %lsr.iv.i221.i.i, i64 -32
  %.227.i224.i.i = load double, ptr %scevgep5.i223.i.i, align 8, !noalias !43
  %scevgep4.i225.i.i = getelementptr i8, ptr %lsr.iv.i221.i.i, i64 -24
  %.289.i226.i.i = load double, ptr %scevgep4.i225.i.i, align 8, !noalias !43
  %.290.i.i.i = fcmp une double %.289.i226.i.i, 0.000000e+00
  br i1 %.290.i.i.i, label %B106.i.i.i, label %B370.i.i.i
B106.i.i.i:
  %scevgep3.i230.i.i = getelementptr i8, ptr %lsr.iv.i221.i.i, i64 -16
  %.347.i231.i.i = load double, ptr %scevgep3.i230.i.i, align 8, !noalias !43
  %scevgep2.i232.i.i = getelementptr i8, ptr %lsr.iv.i221.i.i, i64 -8
  %.402.i.i.i = load double, ptr %scevgep2.i232.i.i, align 8, !noalias !43
  %.403.i.i.i = fmul double %.402.i.i.i, 5.000000e-01
  %.405.i233.i.i = fmul double %.40.i.i.i, %.403.i.i.i
  %.406.i.i.i = fadd double %.347.i231.i.i, %.405.i233.i.i
  %.407.i.i.i = fmul double %.406.i.i.i, 0x401921FB54442D18
  %.409.i.i.i = fmul double %.40.i.i.i, %.407.i.i.i
  %.464.i234.i.i = load double, ptr %lsr.iv.i221.i.i, align 8, !noalias !43
  %.465.i235.i.i = fadd double %.464.i234.i.i, %.409.i.i.i
  %.578.i.i.i = fmul double %.40.i.i.i, %.402.i.i.i
  %.579.i.i.i = fadd double %.347.i231.i.i, %.578.i.i.i
  %.580.i.i.i = fmul double %.579.i.i.i, 0x401921FB54442D18
  %.636.i.i.i = fmul double %.289.i226.i.i, %.580.i.i.i
  %.644.le.i.i.i = tail call double @llvm.cos.f64(double %.465.i235.i.i)
  %.649.i.i.i = fmul double %.636.i.i.i, %.644.le.i.i.i
  %.651.i.i.i = fadd double %.227.i224.i.i, %.649.i.i.i
  br label %B370.i.i.i
B370.i.i.i:
  %slope.2.1.i.i.i = phi double [ %.651.i.i.i, %B106.i.i.i ], [ %.227.i224.i.i, %B56.i220.i.i ]
  %26 = shl i64 %.138242244.i.i.i, 3
  %scevgep6.i227.i.i = getelementptr i8, ptr %.1871.i, i64 %26
  store double %slope.2.1.i.i.i, ptr %scevgep6.i227.i.i, align 8, !noalias !43
  %scevgep1.i228.i.i = getelementptr i8, ptr %lsr.iv.i221.i.i, i64 48
  %exitcond.not.i229.i.i = icmp eq i64 %.1846.i, %.145.i222.i.i
  br i1 %exitcond.not.i229.i.i, label %B490.endif.endif.i.i, label %B56.i220.i.i
B490.endif.endif.i.i:
  %.2508.i.i = load i64, ptr %a0, align 8, !noalias !7
  %.2565.i.i = inttoptr i64 %.2508.i.i to ptr
  tail call void %.2565.i.i(ptr nonnull %.2042.i, ptr %a2, ptr %.1528.i, ptr %.1871.i, ptr %a3, ptr %.1171.i, ptr %.2524.i, ptr %.740.i.i), !noalias !7
  %.2574.i.i = fcmp ugt double %h.5.0.i.i, 0.000000e+00
  br i1 %.2574.i.i, label %B748.endif.i.i, label %B656.i.i
B656.endif.i.i:
  %fastest.2.0.lcssa.i.i.i = phi double [ %.56.i.i.i, %B656.i.i ], [ %.13.i.i.i.i, %B66.backedge.i.i.i ]
  %.373.i.i.i = fdiv double 1.000000e+00, %fastest.2.0.lcssa.i.i.i
  %.2623.i.i = fcmp olt double %h.5.0.i.i, 0.000000e+00
  br i1 %.2623.i.i, label %B710.i.i, label %B748.endif.i.i
B748.endif.i.i:
  %h.7.1.i.i = phi double [ %h.5.0.i.i, %B486.i.i ], [ %h.5.0.i.i, %B490.endif.endif.i.i ], [ %.373.i.i.i, %B656.endif.i.i ], [ %.13.i.i.i, %B710.i.i ]
  %.2716.i.i = load double, ptr %a10, align 8, !noalias !7
  %.12.i146.i.i = fcmp olt double %.2716.i.i, %h.7.1.i.i
  %.13.i147.i.i = select i1 %.12.i146.i.i, double %.2716.i.i, double %h.7.1.i.i
  %.2753.i.i = fsub double %"$phi1338.1.2.1.i", %t.2.0.i.i
  %.2754.i.i = fmul double %.2753.i.i, 5.000000e-01
  %.2756.i.i = fcmp olt double %.13.i147.i.i, %.2754.i.i
  br i1 %.2756.i.i, label %B862.i.i, label %B820.i.i
switch.lookup.i.i:
  %.287539593963.i.i = phi i64 [ %.2882.i.i, %switch.end.endif.endif.i.i ], [ 0, %B862.i.i ]
  %.2882.i.i = add nuw nsw i64 %.287539593963.i.i, 1
  %switch.gep.i.i = getelementptr inbounds double, ptr @v18, i64 %.287539593963.i.i
  %switch.load.i.i = load double, ptr %switch.gep.i.i, align 8, !noalias !7
  %.2940.i.i = fmul double %"$phi862.0.3.1.i.i", %switch.load.i.i
  %.2942.i.i = fadd double %t.2.0.i.i, %.2940.i.i
  %.2944.i.i = mul nuw nsw i64 %.287539593963.i.i, %.1512.i
  %.2947.i.i = mul nuw nsw i64 %.2882.i.i, %.1512.i
  %.2994.not.i.i = icmp sgt i64 %.1674.i, %.2944.i.i
  br i1 %.2994.not.i.i, label %switch.end.else.endif.endif.endif.i.i, label %switch.end.else.endif.if.i.i, !prof !10
switch.end.endif.i.i:
  %.2974.sroa.13.0.i.i = phi i64 [ %.2947.i.i, %switch.end.else.endif.endif.endif.i.i ], [ %.1683.i, %switch.end.else.endif.endif.endif.if.i.i ]
  %.40.i236.i.i = fsub double %.2942.i.i, %.3647.i
  %.132223.not.i237.not.i.i = icmp sgt i64 %.2974.sroa.13.0.i.i, %.2974.sroa.0.3.i.i
  br i1 %.132223.not.i237.not.i.i, label %B56.i240.i.i, label %switch.end.endif.endif.i.i
B56.i240.i.i:
  %lsr.iv.i5.i = phi i64 [ %lsr.iv.next.i.i, %B316.i253.i.i ], [ %.2974.sroa.0.3.i.i, %switch.end.endif.i.i ]
  %lsr.iv.i241.i.i = phi ptr [ %scevgep1.i256.i.i, %B316.i253.i.i ], [ %scevgep.i182.i.i, %switch.end.endif.i.i ]
  %scevgep6.i244.i.i = getelementptr i8, ptr %lsr.iv.i241.i.i, i64 -40
  %.227.i245.i.i = load double, ptr %scevgep6.i244.i.i, align 8, !noalias !46
  %scevgep5.i246.i.i = getelementptr i8, ptr %lsr.iv.i241.i.i, i64 -32
  %.282.i247.i.i = load double, ptr %scevgep5.i246.i.i, align 8, !noalias !46
  %.284.i248.i.i = fmul double %.40.i236.i.i, %.282.i247.i.i
  %.285.i249.i.i = fadd double %.227.i245.i.i, %.284.i248.i.i
  %scevgep4.i250.i.i = getelementptr i8, ptr %lsr.iv.i241.i.i, i64 -24
  %.347.i251.i.i = load double, ptr %scevgep4.i250.i.i, align 8, !noalias !46
  %.348.i252.i.i = fcmp une double %.347.i251.i.i, 0.000000e+00
  br i1 %.348.i252.i.i, label %B134.i258.i.i, label %B316.i253.i.i
B134.i258.i.i:
  %scevgep3.i259.i.i = getelementptr i8, ptr %lsr.iv.i241.i.i, i64 -16
  %.405.i260.i.i = load double, ptr %scevgep3.i259.i.i, align 8, !noalias !46
  %scevgep2.i261.i.i = getelementptr i8, ptr %lsr.iv.i241.i.i, i64 -8
  %.460.i262.i.i = load double, ptr %scevgep2.i261.i.i, align 8, !noalias !46
  %.461.i263.i.i = fmul double %.460.i262.i.i, 5.000000e-01
  %.463.i264.i.i = fmul double %.40.i236.i.i, %.461.i263.i.i
  %.464.i265.i.i = fadd double %.405.i260.i.i, %.463.i264.i.i
  %.465.i266.i.i = fmul double %.464.i265.i.i, 0x401921FB54442D18
  %.467.i267.i.i = fmul double %.40.i236.i.i, %.465.i266.i.i
  %.522.i268.i.i = load double, ptr %lsr.iv.i241.i.i, align 8, !noalias !46
  %.523.i269.i.i = fadd double %.522.i268.i.i, %.467.i267.i.i
  %.586.le.i270.i.i = tail call double @llvm.sin.f64(double %.523.i269.i.i)
  %.591.i271.i.i = fmul double %.347.i251.i.i, %.586.le.i270.i.i
  %.593.i272.i.i = fadd double %.285.i249.i.i, %.591.i271.i.i
  br label %B316.i253.i.i
B316.i253.i.i:
  %value.2.1.i254.i.i = phi double [ %.593.i272.i.i, %B134.i258.i.i ], [ %.285.i249.i.i, %B56.i240.i.i ]
  %27 = shl i64 %lsr.iv.i5.i, 3
  %scevgep463.i.i = getelementptr i8, ptr %.1699.i, i64 %27
  store double %value.2.1.i254.i.i, ptr %scevgep463.i.i, align 8, !noalias !46
  %scevgep1.i256.i.i = getelementptr i8, ptr %lsr.iv.i241.i.i, i64 48
  %lsr.iv.next.i.i = add i64 %lsr.iv.i5.i, 1
  %exitcond.not.i257.i.i = icmp eq i64 %.2974.sroa.13.0.i.i, %lsr.iv.next.i.i
  br i1 %exitcond.not.i257.i.i, label %switch.end.endif.endif.i.i, label %B56.i240.i.i
switch.end.else.endif.if.i.i:
  br label %switch.end.else.endif.endif.endif.i.i
switch.end.else.endif.endif.endif.i.i:
  %.2974.sroa.0.3.i.i = phi i64 [ %.1683.i, %switch.end.else.endif.if.i.i ], [ %.2944.i.i, %switch.lookup.i.i ]
  %.3011.not.i.i = icmp sgt i64 %.1674.i, %.2947.i.i
  br i1 %.3011.not.i.i, label %switch.end.endif.i.i, label %switch.end.else.endif.endif.endif.if.i.i, !prof !10
switch.end.else.endif.endif.endif.if.i.i:
  br label %switch.end.endif.i.i
switch.end.endif.endif.i.i:
  %exitcond4382.not.i.i = icmp eq i64 %.2882.i.i, 4
  br i1 %exitcond4382.not.i.i, label %B1008.i.i, label %switch.lookup.i.i
B1008.endif.thread.i.i:
  %.3376327.i.i = load i64, ptr %sunkaddr181.i.i, align 8, !noalias !7
  %.3377328.i.i = add nsw i64 %.3376327.i.i, 1
  store i64 %.3377328.i.i, ptr %sunkaddr181.i.i, align 8, !noalias !7
  br label %for.end.i.i
B1008.endif.i.i:
  %.3376.i.i = load i64, ptr %sunkaddr181.i.i, align 8, !noalias !7
  %.3377.i.i = add nsw i64 %.3376.i.i, 1
  store i64 %.3377.i.i, ptr %sunkaddr181.i.i, align 8, !noalias !7
  %.3409.i.i = fcmp ugt double %worst.3.1.i.i.i, 1.000000e+00
  br i1 %.3409.i.i, label %for.end.i.i, label %B1182.i.i
B1466.endif.endif.loopexit.i.i:
  %.3910.pre.i.i = load i64, ptr %.179.i.i, align 8, !noalias !7
  br label %B1466.endif.endif.i.i
B1466.endif.endif.i.i:
  %.3910.i.i = phi i64 [ %.3910.pre.i.i, %B1466.endif.endif.loopexit.i.i ], [ %.3806.i.i, %B1466.i.i ]
  %.3924.i.i = icmp slt i64 %.3910.i.i, 0
  %.3925.i.i = select i1 %.3924.i.i, i64 %.69.i, i64 0
  %28 = getelementptr double, ptr %a7, i64 %.3910.i.i
  %.3939.i.i = getelementptr double, ptr %28, i64 %.3925.i.i
  %.3940.i.i = load double, ptr %.3939.i.i, align 8, !noalias !7
  %.40.i274.i.i = fsub double %.3940.i.i, %.3647.i
  br i1 %61, label %B1466.endif.endif.endif.i.i, label %B56.i278.i.i
B56.i278.i.i:
  %lsr.iv.i279.i.i = phi ptr [ %scevgep1.i294.i.i, %B316.i291.i.i ], [ %scevgep.i182.i.i, %B1466.endif.endif.i.i ]
  %.138222224.i280.i.i = phi i64 [ %.145.i281.i.i, %B316.i291.i.i ], [ 0, %B1466.endif.endif.i.i ]
  %.145.i281.i.i = add nuw nsw i64 %.138222224.i280.i.i, 1
  %scevgep6.i282.i.i = getelementptr i8, ptr %lsr.iv.i279.i.i, i64 -40
  %.227.i283.i.i = load double, ptr %scevgep6.i282.i.i, align 8, !noalias !49
  %scevgep5.i284.i.i = getelementptr i8, ptr %lsr.iv.i279.i.i, i64 -32
  %.282.i285.i.i = load double, ptr %scevgep5.i284.i.i, align 8, !noalias !49
  %.284.i286.i.i = fmul double %.40.i274.i.i, %.282.i285.i.i
  %.285.i287.i.i = fadd double %.227.i283.i.i, %.284.i286.i.i
  %scevgep4.i288.i.i = getelementptr i8, ptr %lsr.iv.i279.i.i, i64 -24
  %.347.i289.i.i = load double, ptr %scevgep4.i288.i.i, align 8, !noalias !49
  %.348.i290.i.i = fcmp une double %.347.i289.i.i, 0.000000e+00
  br i1 %.348.i290.i.i, label %B134.i296.i.i, label %B316.i291.i.i
B134.i296.i.i:
  %scevgep3.i297.i.i = getelementptr i8, ptr %lsr.iv.i279.i.i, i64 -16
  %.405.i298.i.i = load double, ptr %scevgep3.i297.i.i, align 8, !noalias !49
  %scevgep2.i299.i.i = getelementptr i8, ptr %lsr.iv.i279.i.i, i64 -8
  %.460.i300.i.i = load double, ptr %scevgep2.i299.i.i, align 8, !noalias !49
  %.461.i301.i.i = fmul double %.460.i300.i.i, 5.000000e-01
  %.463.i302.i.i = fmul double %.40.i274.i.i, %.461.i301.i.i
  %.464.i303.i.i = fadd double %.405.i298.i.i, %.463.i302.i.i
  %.465.i304.i.i = fmul double %.464.i303.i.i, 0x401921FB54442D18
  %.467.i305.i.i = fmul double %.40.i274.i.i, %.465.i304.i.i
  %.522.i306.i.i = load double, ptr %lsr.iv.i279.i.i, align 8, !noalias !49
  %.523.i307.i.i = fadd double %.522.i306.i.i, %.467.i305.i.i
  %.586.le.i308.i.i = tail call double @llvm.sin.f64(double %.523.i307.i.i)
  %.591.i309.i.i = fmul double %.347.i289.i.i, %.586.le.i308.i.i
  %.593.i310.i.i = fadd double %.285.i287.i.i, %.591.i309.i.i
  br label %B316.i291.i.i
B316.i291.i.i:
  %value.2.1.i292.i.i = phi double [ %.593.i310.i.i, %B134.i296.i.i ], [ %.285.i287.i.i, %B56.i278.i.i ]
  %29 = shl i64 %.138222224.i280.i.i, 3
  %scevgep7.i293.i.i = getelementptr i8, ptr %.1528.i, i64 %29
  store double %value.2.1.i292.i.i, ptr %scevgep7.i293.i.i, align 8, !noalias !49
  %scevgep1.i294.i.i = getelementptr i8, ptr %lsr.iv.i279.i.i, i64 48
  %exitcond.not.i295.i.i = icmp eq i64 %.1503.i, %.145.i281.i.i
  br i1 %exitcond.not.i295.i.i, label %B1466.endif.endif.endif.loopexit.i.i, label %B56.i278.i.i
B1466.endif.endif.endif.loopexit.i.i:
  %.4004.pre.i.i = load i64, ptr %.179.i.i, align 8, !noalias !7
  br label %B1466.endif.endif.endif.i.i
B1466.endif.endif.endif.i.i:
  %.4004.i.i = phi i64 [ %.4004.pre.i.i, %B1466.endif.endif.endif.loopexit.i.i ], [ %.3910.i.i, %B1466.endif.endif.i.i ]
  %.4018.i.i = icmp slt i64 %.4004.i.i, 0
  %.4019.i.i = select i1 %.4018.i.i, i64 %.69.i, i64 0
  %30 = getelementptr double, ptr %a7, i64 %.4004.i.i
  %.4033.i.i = getelementptr double, ptr %30, i64 %.4019.i.i
  %.4034.i.i = load double, ptr %.4033.i.i, align 8, !noalias !7
  store double %.4034.i.i, ptr %.2042.i, align 8, !noalias !52
  tail call void %9(ptr nonnull %.2042.i, ptr %.740.i.i, ptr %.1528.i, ptr %a3, ptr %.3062.i), !noalias !52
  br i1 %71, label %B1466.endif.endif.endif.endif.i.i, label %B96.lr.ph.i.i.i
B96.lr.ph.i.i.i:
  br i1 %72, label %B96.epil.preheader.i.i.i, label %B96.lr.ph.new.i.i.i
B96.lr.ph.new.i.i.i:
  %invariant.gep.i312.i.i = getelementptr double, ptr %a13, i64 %.4004.i.i
  %invariant.gep159.i.i.i = getelementptr double, ptr %invariant.gep.i312.i.i, i64 %.4019.i.i
  br i1 %73, label %B96.i.epil.preheader.i.i, label %B96.i.i.i
B96.i.i.i:
  %lsr.iv141.i.i = phi i64 [ %lsr.iv.next142.i.i, %B96.i.i.i ], [ %70, %B96.lr.ph.new.i.i.i ]
  %lsr.iv13.i.i.i = phi ptr [ %scevgep497.i.i, %B96.i.i.i ], [ %invariant.gep159.i.i.i, %B96.lr.ph.new.i.i.i ]
  %.259154156.i.i.i = phi i64 [ %.266.3.i.1.i.i, %B96.i.i.i ], [ 0, %B96.lr.ph.new.i.i.i ]
  %sunkaddr184.i.i = shl i64 %.259154156.i.i.i, 3
  %sunkaddr185.i.i = getelementptr i8, ptr %.3062.i, i64 %sunkaddr184.i.i
  %.320.i.i.i = load double, ptr %sunkaddr185.i.i, align 8, !noalias !52
  store double %.320.i.i.i, ptr %lsr.iv13.i.i.i, align 8, !noalias !52
  %sunkaddr188.i.i = getelementptr i8, ptr %sunkaddr185.i.i, i64 8
  %.320.1.i.i.i = load double, ptr %sunkaddr188.i.i, align 8, !noalias !52
  %sunkaddr23.i.i.i = getelementptr i8, ptr %lsr.iv13.i.i.i, i64 %.16.i.i
  store double %.320.1.i.i.i, ptr %sunkaddr23.i.i.i, align 8, !noalias !52
  %sunkaddr191.i.i = getelementptr i8, ptr %sunkaddr185.i.i, i64 16
  %.320.2.i.i.i = load double, ptr %sunkaddr191.i.i, align 8, !noalias !52
  %scevgep491.i.i = getelementptr i8, ptr %sunkaddr23.i.i.i, i64 %.16.i.i
  store double %.320.2.i.i.i, ptr %scevgep491.i.i, align 8, !noalias !52
  %sunkaddr194.i.i = getelementptr i8, ptr %sunkaddr185.i.i, i64 24
  %.320.3.i.i.i = load double, ptr %sunkaddr194.i.i, align 8, !noalias !52
  %scevgep492.i.i = getelementptr i8, ptr %scevgep491.i.i, i64 %.16.i.i
  store double %.320.3.i.i.i, ptr %scevgep492.i.i, align 8, !noalias !52
  %sunkaddr197.i.i = getelementptr i8, ptr %sunkaddr185.i.i, i64 32
  %.320.i.1.i.i = load double, ptr %sunkaddr197.i.i, align 8, !noalias !52
  %scevgep493.i.i = getelementptr i8, ptr %scevgep492.i.i, i64 %.16.i.i
  store double %.320.i.1.i.i, ptr %scevgep493.i.i, align 8, !noalias !52
  %sunkaddr200.i.i = getelementptr i8, ptr %sunkaddr185.i.i, i64 40
  %.320.1.i.1.i.i = load double, ptr %sunkaddr200.i.i, align 8, !noalias !52
  %scevgep494.i.i = getelementptr i8, ptr %scevgep493.i.i, i64 %.16.i.i
  store double %.320.1.i.1.i.i, ptr %scevgep494.i.i, align 8, !noalias !52
  %sunkaddr203.i.i = getelementptr i8, ptr %sunkaddr185.i.i, i64 48
  %.320.2.i.1.i.i = load double, ptr %sunkaddr203.i.i, align 8, !noalias !52
  %scevgep495.i.i = getelementptr i8, ptr %scevgep494.i.i, i64 %.16.i.i
  store double %.320.2.i.1.i.i, ptr %scevgep495.i.i, align 8, !noalias !52
  %.266.3.i.1.i.i = add i64 %.259154156.i.i.i, 8
  %sunkaddr204.i.i = shl i64 %.266.3.i.1.i.i, 3
  %sunkaddr205.i.i = getelementptr i8, ptr %.3062.i, i64 %sunkaddr204.i.i
  %sunkaddr206.i.i = getelementptr i8, ptr %sunkaddr205.i.i, i64 -8
  %.320.3.i.1.i.i = load double, ptr %sunkaddr206.i.i, align 8, !noalias !52
  %scevgep496.i.i = getelementptr i8, ptr %scevgep495.i.i, i64 %.16.i.i
  store double %.320.3.i.1.i.i, ptr %scevgep496.i.i, align 8, !noalias !52
  %scevgep497.i.i = getelementptr i8, ptr %scevgep496.i.i, i64 %.16.i.i
  %lsr.iv.next142.i.i = add i64 %lsr.iv141.i.i, 2
  %niter.ncmp.1.i.i = icmp eq i64 %lsr.iv.next142.i.i, 0
  br i1 %niter.ncmp.1.i.i, label %B126.loopexit.unr-lcssa.i.unr-lcssa.i.i, label %B96.i.i.i
B126.loopexit.unr-lcssa.i.unr-lcssa.i.i:
  %scevgep14.i.i.i = getelementptr i8, ptr %lsr.iv13.i.i.i, i64 %64
  %scevgep14.i.1.i.i = getelementptr i8, ptr %scevgep14.i.i.i, i64 %64
  br i1 %75, label %B96.i.epil.preheader.i.i, label %B126.loopexit.unr-lcssa.i.i.i
B96.i.epil.preheader.i.i:
  %lsr.iv13.i.epil.init.i.i = phi ptr [ %invariant.gep159.i.i.i, %B96.lr.ph.new.i.i.i ], [ %scevgep14.i.1.i.i, %B126.loopexit.unr-lcssa.i.unr-lcssa.i.i ]
  %.259154156.i.epil.init.i.i = phi i64 [ 0, %B96.lr.ph.new.i.i.i ], [ %.266.3.i.1.i.i, %B126.loopexit.unr-lcssa.i.unr-lcssa.i.i ]
  %sunkaddr.i.epil.i.i = shl i64 %.259154156.i.epil.init.i.i, 3
  %sunkaddr18.i.epil.i.i = getelementptr i8, ptr %.3062.i, i64 %sunkaddr.i.epil.i.i
  %.320.i.epil.i.i = load double, ptr %sunkaddr18.i.epil.i.i, align 8, !noalias !52
  store double %.320.i.epil.i.i, ptr %lsr.iv13.i.epil.init.i.i, align 8, !noalias !52
  %sunkaddr21.i.epil.i.i = getelementptr i8, ptr %sunkaddr18.i.epil.i.i, i64 8
  %.320.1.i.epil.i.i = load double, ptr %sunkaddr21.i.epil.i.i, align 8, !noalias !52
  %sunkaddr23.i.epil.i.i = getelementptr i8, ptr %lsr.iv13.i.epil.init.i.i, i64 %.16.i.i
  store double %.320.1.i.epil.i.i, ptr %sunkaddr23.i.epil.i.i, align 8, !noalias !52
  %sunkaddr26.i.epil.i.i = getelementptr i8, ptr %sunkaddr18.i.epil.i.i, i64 16
  %.320.2.i.epil.i.i = load double, ptr %sunkaddr26.i.epil.i.i, align 8, !noalias !52
  %scevgep16.i.epil.i.i = getelementptr i8, ptr %lsr.iv13.i.epil.init.i.i, i64 %65
  store double %.320.2.i.epil.i.i, ptr %scevgep16.i.epil.i.i, align 8, !noalias !52
  %sunkaddr29.i.epil.i.i = getelementptr i8, ptr %sunkaddr18.i.epil.i.i, i64 24
  %.320.3.i.epil.i.i = load double, ptr %sunkaddr29.i.epil.i.i, align 8, !noalias !52
  %scevgep15.i.epil.i.i = getelementptr i8, ptr %lsr.iv13.i.epil.init.i.i, i64 %63
  store double %.320.3.i.epil.i.i, ptr %scevgep15.i.epil.i.i, align 8, !noalias !52
  br label %B126.loopexit.unr-lcssa.i.i.i
B126.loopexit.unr-lcssa.i.i.i:
  br i1 %76, label %B1466.endif.endif.endif.endif.i.i, label %B96.epil.preheader.i.i.i
B96.epil.preheader.i.i.i:
  %.259154156.epil.init.i.i.i = phi i64 [ %unroll_iter.i.i7.i, %B126.loopexit.unr-lcssa.i.i.i ], [ 0, %B96.lr.ph.i.i.i ]
  %31 = mul i64 %.259154156.epil.init.i.i.i, %.69.i
  %32 = add i64 %.4019.i.i, %.4004.i.i
  %33 = add i64 %32, %31
  %34 = shl i64 %33, 3
  %scevgep.i313.i.i = getelementptr i8, ptr %a13, i64 %34
  %35 = shl i64 %.259154156.epil.init.i.i.i, 3
  %scevgep3.i314.i.i = getelementptr i8, ptr %.3062.i, i64 %35
  br label %B96.epil.i.i.i
B96.epil.i.i.i:
  %lsr.iv.i315.i.i = phi ptr [ %scevgep2.i317.i.i, %B96.epil.i.i.i ], [ %scevgep.i313.i.i, %B96.epil.preheader.i.i.i ]
  %epil.iter.i.i.i = phi i64 [ %epil.iter.next.i.i.i, %B96.epil.i.i.i ], [ 0, %B96.epil.preheader.i.i.i ]
  %36 = shl i64 %epil.iter.i.i.i, 3
  %scevgep498.i.i = getelementptr i8, ptr %scevgep3.i314.i.i, i64 %36
  %.320.epil.i.i.i = load double, ptr %scevgep498.i.i, align 8, !noalias !52
  store double %.320.epil.i.i.i, ptr %lsr.iv.i315.i.i, align 8, !noalias !52
  %epil.iter.next.i.i.i = add i64 %epil.iter.i.i.i, 1
  %scevgep2.i317.i.i = getelementptr i8, ptr %lsr.iv.i315.i.i, i64 %.16.i.i
  %epil.iter.cmp.not.i.i.i = icmp eq i64 %xtraiter.i.i6.i, %epil.iter.next.i.i.i
  br i1 %epil.iter.cmp.not.i.i.i, label %B1466.endif.endif.endif.endif.i.i, label %B96.epil.i.i.i, !llvm.loop !55
B1466.endif.endif.endif.endif.i.i:
  %.4139.i.i = load i64, ptr %.179.i.i, align 8, !noalias !7
  %.4140.i.i = add nsw i64 %.4139.i.i, 1
  store i64 %.4140.i.i, ptr %.179.i.i, align 8, !noalias !7
  %.4208.i.i = icmp slt i64 %.4140.i.i, %.69.i
  br i1 %.4208.i.i, label %B1748.i.i, label %B1784.endif.i.i
B1784.endif.i.i:
  %37 = icmp sgt i64 %event.2.1.i.i, -1
  br label %B1816.i.i
B1852.endif.endif.i.i:
  %.4531.i.i = phi double [ %.4434.i.i, %B1830.i.i ], [ %.4531.pre.i.i, %B1816.B1852_crit_edge.i.i ]
  %38 = shl i64 %.436639673970.i.i, 3
  %scevgep166.i.i = getelementptr i8, ptr %scevgep165.i.i, i64 %38
  %.4500.i.i = load double, ptr %scevgep166.i.i, align 8, !noalias !7
  %scevgep162.i.i = getelementptr i8, ptr %.914.i.i, i64 %38
  %scevgep161.i.i = getelementptr i8, ptr %a2, i64 %38
  %.4562.i.i = load double, ptr %scevgep161.i.i, align 8, !noalias !7
  %.4563.i.i = fsub double %.4531.i.i, %.4562.i.i
  %.4564.i.i = tail call double @llvm.fabs.f64(double %.4563.i.i)
  %.4565.i.i = fadd double %.4500.i.i, %.4564.i.i
  store double %.4565.i.i, ptr %scevgep166.i.i, align 8, !noalias !7
  %.4626.i.i = load double, ptr %scevgep162.i.i, align 8, !noalias !7
  store double %.4626.i.i, ptr %scevgep161.i.i, align 8, !noalias !7
  %scevgep160.i.i = getelementptr i8, ptr %a14, i64 %38
  %.4688.i.i = load double, ptr %scevgep160.i.i, align 8, !noalias !7
  %.12.i163.i.i = fcmp olt double %.4626.i.i, %.4688.i.i
  %.13.i164.i.i = select i1 %.12.i163.i.i, double %.4626.i.i, double %.4688.i.i
  %scevgep159.i.i = getelementptr i8, ptr %invariant.gep4527.i.i, i64 %38
  %.4780.i.i = load double, ptr %scevgep159.i.i, align 8, !noalias !7
  %.12.i318.i.i = fcmp ogt double %.4626.i.i, %.4780.i.i
  %.13.i319.i.i = select i1 %.12.i318.i.i, double %.4626.i.i, double %.4780.i.i
  store double %.13.i164.i.i, ptr %scevgep160.i.i, align 8, !noalias !7
  store double %.13.i319.i.i, ptr %scevgep159.i.i, align 8, !noalias !7
  %exitcond4383.not.i.i = icmp eq i64 %.23.i, %.4373.i.i
  br i1 %exitcond4383.not.i.i, label %B2114.i.i, label %B1816.i.i
B2206.endif.i.i:
  %.12.i165.i.i = fcmp olt double %storemerge.i338.i.i, 1.000000e-10
  %.13.i166.i.i = select i1 %.12.i165.i.i, double 1.000000e-10, double %storemerge.i338.i.i
  %.17.i.i.i = tail call double @llvm.pow.f64(double %.13.i166.i.i, double -2.500000e-01)
  %.18.i.i.i = fmul double %.17.i.i.i, 9.000000e-01
  %.27.i.i.i = fcmp ogt double %step_before.2.0.i.i, 0.000000e+00
  br i1 %.27.i.i.i, label %B42.endif.i.i.i, label %B2206.endif.endif.endif.i.i
B42.endif.i.i.i:
  %.34.i.i.i = fdiv double %"$phi862.0.3.1.i.i", %step_before.2.0.i.i
  %.39.i.i.i = fmul double %.34.i.i.i, 9.000000e-01
  %.42.i.i.i = fmul double %.13.i166.i.i, %.13.i166.i.i
  %.49.i.i.i = fdiv double %error_before.2.0.i.i, %.42.i.i.i
  %.52.i.i.i = tail call double @llvm.pow.f64(double %.49.i.i.i, double 2.500000e-01)
  %.53.i.i.i = fmul double %.39.i.i.i, %.52.i.i.i
  %.12.i1.i.i.i = fcmp olt double %.53.i.i.i, %.18.i.i.i
  %.13.i2.i.i.i = select i1 %.12.i1.i.i.i, double %.53.i.i.i, double %.18.i.i.i
  br label %B2206.endif.endif.endif.i.i
B2206.endif.endif.endif.i.i:
  %factor.2.0.i.i.i = phi double [ %.18.i.i.i, %B2206.endif.i.i ], [ %.13.i2.i.i.i, %B42.endif.i.i.i ]
  %.12.i.i320.i.i = fcmp ogt double %factor.2.0.i.i.i, 1.500000e-01
  %.13.i.i321.i.i = select i1 %.12.i.i320.i.i, double %factor.2.0.i.i.i, double 1.500000e-01
  %.12.i3.i.i.i = fcmp olt double %.13.i.i321.i.i, 6.000000e+00
  %.13.i4.i.i.i = select i1 %.12.i3.i.i.i, double %.13.i.i321.i.i, double 6.000000e+00
  %.12.i322.i.i = fcmp ogt double %.13.i166.i.i, 1.000000e-02
  %.13.i323.i.i = select i1 %.12.i322.i.i, double %.13.i166.i.i, double 1.000000e-02
  %.5353.i.i = fcmp olt double %"$phi862.0.3.1.i.i", %.13.i147.i.i
  br i1 %.5353.i.i, label %B2322.i.i, label %B2360.i.i
for.end.i.i:
  %storemerge.i330.i.i = phi double [ 0x7FF0000000000000, %B1008.endif.thread.i.i ], [ %worst.3.1.i.i.i, %B1008.endif.i.i ]
  %.5510.le.i.i = fsub double %storemerge.i330.i.i, %storemerge.i330.i.i
  %.5511.le.i.i = fcmp ord double %.5510.le.i.i, 0.000000e+00
  br i1 %.5511.le.i.i, label %B2454.endif.i.i, label %B2558.i.i
B2454.endif.i.i:
  %.5533.i.i = tail call double @llvm.pow.f64(double %storemerge.i330.i.i, double -2.500000e-01)
  %.5536.i.i = fmul double %.5533.i.i, 9.000000e-01
  %.12.i171.i.i = fcmp olt double %.5536.i.i, 8.000000e-01
  %.13.i172.i.i = select i1 %.12.i171.i.i, double %.5536.i.i, double 8.000000e-01
  %.12.i324.i.i = fcmp ogt double %.13.i172.i.i, 1.500000e-01
  %.13.i325.i.i = select i1 %.12.i324.i.i, double %.13.i172.i.i, double 1.500000e-01
  br label %B2558.i.i
B2618.else.if.i.i:
  %.3409331.i.i = phi i1 [ false, %B2558.i.i ], [ true, %B2360.i.i ], [ true, %B2322.i.i ]
  %t.3.1.i.i = phi double [ %t.2.0.i.i, %B2558.i.i ], [ %end.2.1.i.i, %B2360.i.i ], [ %end.2.1.i.i, %B2322.i.i ]
  %error_before.3.1.i.i = phi double [ %error_before.2.0.i.i, %B2558.i.i ], [ %.13.i323.i.i, %B2360.i.i ], [ %.13.i323.i.i, %B2322.i.i ]
  %step_before.3.1.i.i = phi double [ %step_before.2.0.i.i, %B2558.i.i ], [ %"$phi862.0.3.1.i.i", %B2360.i.i ], [ %"$phi862.0.3.1.i.i", %B2322.i.i ]
  %h.6.1.i.i = phi double [ %.5604.i.i, %B2558.i.i ], [ %.5454.i.i, %B2360.i.i ], [ %.13.i168.i.i, %B2322.i.i ]
  %rejected.4.1.i.i = xor i1 %.3409331.i.i, true
  %.5895.i.i = load i64, ptr %sunkaddr181.i.i, align 8, !noalias !7
  %.5915.i.i = srem i64 %.5895.i.i, 400
  %.5936.i.i = icmp eq i64 %.5915.i.i, 0
  br i1 %.5936.i.i, label %B2658.endif.i.i, label %B2812.i.i
B2658.endif.i.i:
  %.5969.i.i = load i64, ptr %a16, align 8, !noalias !7
  %.5999.i.i = load i64, ptr %sunkaddr209.i.i, align 8, !noalias !7
  %.6000.i.i = sub nsw i64 %.5969.i.i, %.5999.i.i
  %.6042.i.i = icmp slt i64 %.6000.i.i, 280
  br i1 %.6042.i.i, label %B2722.i.i, label %B2784.i.i
_ZN6poppet6engine10integrator8_segmentB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i:
  %.4280.sroa.16.2.i = phi double [ %"$phi862.0.3.1.i.i", %B2176.i.i ], [ %"$phi1540.1.2.1.i", %B472.i.i ], [ %.5604.i.i, %B2558.i.i ], [ %h.6.1.i.i, %B2812.i.i ], [ %h.6.1.i.i, %B2868.i.i ], [ %h.6.1.i.i, %B2722.i.i ], [ %h.6.1.i.i, %B2912.i.i ]
  %.4280.sroa.9.2.i = phi double [ %end.2.1.i.i, %B2176.i.i ], [ %.3647.i, %B472.i.i ], [ %t.2.0.i.i, %B2558.i.i ], [ %t.3.1.i.i, %B2812.i.i ], [ %t.3.1.i.i, %B2868.i.i ], [ %t.3.1.i.i, %B2722.i.i ], [ %t.3.1.i.i, %B2912.i.i ]
  %.4585.not.i = phi i1 [ false, %B2176.i.i ], [ true, %B472.i.i ], [ false, %B2558.i.i ], [ false, %B2812.i.i ], [ false, %B2868.i.i ], [ false, %B2722.i.i ], [ true, %B2912.i.i ]
  %.4280.sroa.0.2.i = phi i64 [ 1, %B2176.i.i ], [ 0, %B472.i.i ], [ 2, %B2558.i.i ], [ 3, %B2812.i.i ], [ 5, %B2868.i.i ], [ 2, %B2722.i.i ], [ 0, %B2912.i.i ]
  br i1 %.4585.not.i, label %B1768.i, label %B1772.i
B1656.i:
  %.4425.i = load i64, ptr %sunkaddr432.i, align 8, !noalias !0
  %.4476.i = mul i64 %.357625792586.i, %.986.i
  %.4478.i = getelementptr double, ptr %a5, i64 %.4476.i
  %.180.i.i = load i64, ptr %.179.i.i, align 8, !noalias !57
  %.188.i.i = icmp slt i64 %.180.i.i, %.69.i
  br i1 %.188.i.i, label %B38.i.i, label %B1768.i
B38.i.i:
  %.233.i.i = icmp slt i64 %.180.i.i, 0
  %.234.i.i = select i1 %.233.i.i, i64 %.69.i, i64 0
  %39 = getelementptr double, ptr %a7, i64 %.180.i.i
  %.248.i.i = getelementptr double, ptr %39, i64 %.234.i.i
  %.249.i.i = load double, ptr %.248.i.i, align 8, !noalias !57
  %.251.i.i = fcmp olt double %.249.i.i, %"$phi1338.1.2.1.i"
  br i1 %.251.i.i, label %B74.preheader.i.i, label %B1768.i
B74.preheader.i.i:
  %scevgep.i.i.i = getelementptr i8, ptr %.4478.i, i64 40
  %40 = inttoptr i64 %.4425.i to ptr
  br label %B74.i.i
B74.i.i:
  %.286.i.i = phi i64 [ %.518.i.i, %B282.i.i ], [ %.180.i.i, %B74.preheader.i.i ]
  %.300.i.i = icmp slt i64 %.286.i.i, 0
  %.301.i.i = select i1 %.300.i.i, i64 %.69.i, i64 0
  %41 = getelementptr double, ptr %a7, i64 %.286.i.i
  %.315.i.i = getelementptr double, ptr %41, i64 %.301.i.i
  %.316.i.i = load double, ptr %.315.i.i, align 8, !noalias !57
  %.40.i.i9.i = fsub double %.316.i.i, %.3647.i
  br i1 %61, label %B74.endif.i.i, label %B56.i.i10.i
B56.i.i10.i:
  %lsr.iv.i.i11.i = phi ptr [ %scevgep1.i.i26.i, %B316.i.i23.i ], [ %scevgep.i.i.i, %B74.i.i ]
  %.138222224.i.i12.i = phi i64 [ %.145.i.i13.i, %B316.i.i23.i ], [ 0, %B74.i.i ]
  %.145.i.i13.i = add nuw nsw i64 %.138222224.i.i12.i, 1
  %scevgep6.i.i14.i = getelementptr i8, ptr %lsr.iv.i.i11.i, i64 -40
  %.227.i.i15.i = load double, ptr %scevgep6.i.i14.i, align 8, !noalias !60
  %scevgep5.i.i16.i = getelementptr i8, ptr %lsr.iv.i.i11.i, i64 -32
  %.282.i.i17.i = load double, ptr %scevgep5.i.i16.i, align 8, !noalias !60
  %.284.i.i18.i = fmul double %.40.i.i9.i, %.282.i.i17.i
  %.285.i.i19.i = fadd double %.227.i.i15.i, %.284.i.i18.i
  %scevgep4.i.i20.i = getelementptr i8, ptr %lsr.iv.i.i11.i, i64 -24
  %.347.i.i21.i = load double, ptr %scevgep4.i.i20.i, align 8, !noalias !60
  %.348.i.i22.i = fcmp une double %.347.i.i21.i, 0.000000e+00
  br i1 %.348.i.i22.i, label %B134.i.i73.i, label %B316.i.i23.i
B134.i.i73.i:
  %scevgep3.i.i74.i = getelementptr i8, ptr %lsr.iv.i.i11.i, i64 -16
  %.405.i.i75.i = load double, ptr %scevgep3.i.i74.i, align 8, !noalias !60
  %scevgep2.i.i76.i = getelementptr i8, ptr %lsr.iv.i.i11.i, i64 -8
  %.460.i.i77.i = load double, ptr %scevgep2.i.i76.i, align 8, !noalias !60
  %.461.i.i78.i = fmul double %.460.i.i77.i, 5.000000e-01
  %.463.i.i79.i = fmul double %.40.i.i9.i, %.461.i.i78.i
  %.464.i.i80.i = fadd double %.405.i.i75.i, %.463.i.i79.i
  %.465.i.i81.i = fmul double %.464.i.i80.i, 0x401921FB54442D18
  %.467.i.i82.i = fmul double %.40.i.i9.i, %.465.i.i81.i
  %.522.i.i83.i = load double, ptr %lsr.iv.i.i11.i, align 8, !noalias !60
  %.523.i.i84.i = fadd double %.522.i.i83.i, %.467.i.i82.i
  %.586.le.i.i85.i = tail call double @llvm.sin.f64(double %.523.i.i84.i)
  %.591.i.i86.i = fmul double %.347.i.i21.i, %.586.le.i.i85.i
  %.593.i.i87.i = fadd double %.285.i.i19.i, %.591.i.i86.i
  br label %B316.i.i23.i
B316.i.i23.i:
  %value.2.1.i.i24.i = phi double [ %.593.i.i87.i, %B134.i.i73.i ], [ %.285.i.i19.i, %B56.i.i10.i ]
  %42 = shl i64 %.138222224.i.i12.i, 3
  %scevgep7.i.i25.i = getelementptr i8, ptr %.1528.i, i64 %42
  store double %value.2.1.i.i24.i, ptr %scevgep7.i.i25.i, align 8, !noalias !60
  %scevgep1.i.i26.i = getelementptr i8, ptr %lsr.iv.i.i11.i, i64 48
  %exitcond.not.i.i27.i = icmp eq i64 %.1503.i, %.145.i.i13.i
  br i1 %exitcond.not.i.i27.i, label %B74.endif.loopexit.i.i, label %B56.i.i10.i
B282.i.i:
  %.631.i.i = icmp slt i64 %.517.i.i, -1
  %.632.i.i = select i1 %.631.i.i, i64 %.69.i, i64 0
  %43 = getelementptr double, ptr %a7, i64 %.518.i.i
  %.646.i.i = getelementptr double, ptr %43, i64 %.632.i.i
  %.647.i.i = load double, ptr %.646.i.i, align 8, !noalias !57
  %.649.i.i = fcmp olt double %.647.i.i, %"$phi1338.1.2.1.i"
  br i1 %.649.i.i, label %B74.i.i, label %B1768.i
B74.endif.loopexit.i.i:
  %.382.pre.i.i = load i64, ptr %.179.i.i, align 8, !noalias !57
  br label %B74.endif.i.i
B74.endif.i.i:
  %.382.i.i = phi i64 [ %.382.pre.i.i, %B74.endif.loopexit.i.i ], [ %.286.i.i, %B74.i.i ]
  %.396.i.i = icmp slt i64 %.382.i.i, 0
  %.397.i.i = select i1 %.396.i.i, i64 %.69.i, i64 0
  %44 = getelementptr double, ptr %a7, i64 %.382.i.i
  %.411.i.i = getelementptr double, ptr %44, i64 %.397.i.i
  %.412.i.i = load double, ptr %.411.i.i, align 8, !noalias !57
  store double %.412.i.i, ptr %.2042.i, align 8, !noalias !63
  tail call void %40(ptr nonnull %.2042.i, ptr %a2, ptr %.1528.i, ptr %a3, ptr %.3062.i), !noalias !63
  br i1 %71, label %B74.endif.endif.i.i, label %B96.lr.ph.i.i28.i
B96.lr.ph.i.i28.i:
  br i1 %72, label %B96.epil.preheader.i.i51.i, label %B96.lr.ph.new.i.i30.i
B96.lr.ph.new.i.i30.i:
  %invariant.gep.i.i31.i = getelementptr double, ptr %a13, i64 %.382.i.i
  %invariant.gep159.i.i32.i = getelementptr double, ptr %invariant.gep.i.i31.i, i64 %.397.i.i
  br i1 %73, label %B96.i.epil.preheader.i58.i, label %B96.i.i33.i
B96.i.i33.i:
  %lsr.iv1.i.i = phi i64 [ %lsr.iv.next2.i.i, %B96.i.i33.i ], [ %70, %B96.lr.ph.new.i.i30.i ]
  %lsr.iv13.i.i34.i = phi ptr [ %scevgep32.i.i, %B96.i.i33.i ], [ %invariant.gep159.i.i32.i, %B96.lr.ph.new.i.i30.i ]
  %.259154156.i.i35.i = phi i64 [ %.266.3.i.1.i44.i, %B96.i.i33.i ], [ 0, %B96.lr.ph.new.i.i30.i ]
  %sunkaddr18.i.i = shl i64 %.259154156.i.i35.i, 3
  %sunkaddr19.i.i = getelementptr i8, ptr %.3062.i, i64 %sunkaddr18.i.i
  %.320.i.i36.i = load double, ptr %sunkaddr19.i.i, align 8, !noalias !63
  store double %.320.i.i36.i, ptr %lsr.iv13.i.i34.i, align 8, !noalias !63
  %sunkaddr22.i.i = getelementptr i8, ptr %sunkaddr19.i.i, i64 8
  %.320.1.i.i37.i = load double, ptr %sunkaddr22.i.i, align 8, !noalias !63
  %sunkaddr23.i.i38.i = getelementptr i8, ptr %lsr.iv13.i.i34.i, i64 %.16.i.i
  store double %.320.1.i.i37.i, ptr %sunkaddr23.i.i38.i, align 8, !noalias !63
  %sunkaddr25.i.i = getelementptr i8, ptr %sunkaddr19.i.i, i64 16
  %.320.2.i.i39.i = load double, ptr %sunkaddr25.i.i, align 8, !noalias !63
  %scevgep26.i.i = getelementptr i8, ptr %sunkaddr23.i.i38.i, i64 %.16.i.i
  store double %.320.2.i.i39.i, ptr %scevgep26.i.i, align 8, !noalias !63
  %sunkaddr28.i.i = getelementptr i8, ptr %sunkaddr19.i.i, i64 24
  %.320.3.i.i40.i = load double, ptr %sunkaddr28.i.i, align 8, !noalias !63
  %scevgep27.i.i = getelementptr i8, ptr %scevgep26.i.i, i64 %.16.i.i
  store double %.320.3.i.i40.i, ptr %scevgep27.i.i, align 8, !noalias !63
  %sunkaddr31.i.i = getelementptr i8, ptr %sunkaddr19.i.i, i64 32
  %.320.i.1.i41.i = load double, ptr %sunkaddr31.i.i, align 8, !noalias !63
  %scevgep28.i.i = getelementptr i8, ptr %scevgep27.i.i, i64 %.16.i.i
  store double %.320.i.1.i41.i, ptr %scevgep28.i.i, align 8, !noalias !63
  %sunkaddr34.i.i = getelementptr i8, ptr %sunkaddr19.i.i, i64 40
  %.320.1.i.1.i42.i = load double, ptr %sunkaddr34.i.i, align 8, !noalias !63
  %scevgep29.i.i = getelementptr i8, ptr %scevgep28.i.i, i64 %.16.i.i
  store double %.320.1.i.1.i42.i, ptr %scevgep29.i.i, align 8, !noalias !63
  %sunkaddr37.i.i = getelementptr i8, ptr %sunkaddr19.i.i, i64 48
  %.320.2.i.1.i43.i = load double, ptr %sunkaddr37.i.i, align 8, !noalias !63
  %scevgep30.i.i = getelementptr i8, ptr %scevgep29.i.i, i64 %.16.i.i
  store double %.320.2.i.1.i43.i, ptr %scevgep30.i.i, align 8, !noalias !63
  %.266.3.i.1.i44.i = add i64 %.259154156.i.i35.i, 8
  %sunkaddr38.i.i = shl i64 %.266.3.i.1.i44.i, 3
  %sunkaddr39.i.i = getelementptr i8, ptr %.3062.i, i64 %sunkaddr38.i.i
  %sunkaddr40.i.i = getelementptr i8, ptr %sunkaddr39.i.i, i64 -8
  %.320.3.i.1.i45.i = load double, ptr %sunkaddr40.i.i, align 8, !noalias !63
  %scevgep31.i.i = getelementptr i8, ptr %scevgep30.i.i, i64 %.16.i.i
  store double %.320.3.i.1.i45.i, ptr %scevgep31.i.i, align 8, !noalias !63
  %scevgep32.i.i = getelementptr i8, ptr %scevgep31.i.i, i64 %.16.i.i
  %lsr.iv.next2.i.i = add i64 %lsr.iv1.i.i, 2
  %niter.ncmp.1.i46.i = icmp eq i64 %lsr.iv.next2.i.i, 0
  br i1 %niter.ncmp.1.i46.i, label %B126.loopexit.unr-lcssa.i.unr-lcssa.i47.i, label %B96.i.i33.i
B126.loopexit.unr-lcssa.i.unr-lcssa.i47.i:
  %scevgep14.i.i48.i = getelementptr i8, ptr %lsr.iv13.i.i34.i, i64 %64
  %scevgep14.i.1.i49.i = getelementptr i8, ptr %scevgep14.i.i48.i, i64 %64
  br i1 %75, label %B96.i.epil.preheader.i58.i, label %B126.loopexit.unr-lcssa.i.i50.i
B96.i.epil.preheader.i58.i:
  %lsr.iv13.i.epil.init.i59.i = phi ptr [ %invariant.gep159.i.i32.i, %B96.lr.ph.new.i.i30.i ], [ %scevgep14.i.1.i49.i, %B126.loopexit.unr-lcssa.i.unr-lcssa.i47.i ]
  %.259154156.i.epil.init.i60.i = phi i64 [ 0, %B96.lr.ph.new.i.i30.i ], [ %.266.3.i.1.i44.i, %B126.loopexit.unr-lcssa.i.unr-lcssa.i47.i ]
  %sunkaddr.i.epil.i61.i = shl i64 %.259154156.i.epil.init.i60.i, 3
  %sunkaddr18.i.epil.i62.i = getelementptr i8, ptr %.3062.i, i64 %sunkaddr.i.epil.i61.i
  %.320.i.epil.i63.i = load double, ptr %sunkaddr18.i.epil.i62.i, align 8, !noalias !63
  store double %.320.i.epil.i63.i, ptr %lsr.iv13.i.epil.init.i59.i, align 8, !noalias !63
  %sunkaddr21.i.epil.i64.i = getelementptr i8, ptr %sunkaddr18.i.epil.i62.i, i64 8
  %.320.1.i.epil.i65.i = load double, ptr %sunkaddr21.i.epil.i64.i, align 8, !noalias !63
  %sunkaddr23.i.epil.i66.i = getelementptr i8, ptr %lsr.iv13.i.epil.init.i59.i, i64 %.16.i.i
  store double %.320.1.i.epil.i65.i, ptr %sunkaddr23.i.epil.i66.i, align 8, !noalias !63
  %sunkaddr26.i.epil.i67.i = getelementptr i8, ptr %sunkaddr18.i.epil.i62.i, i64 16
  %.320.2.i.epil.i68.i = load double, ptr %sunkaddr26.i.epil.i67.i, align 8, !noalias !63
  %scevgep16.i.epil.i69.i = getelementptr i8, ptr %lsr.iv13.i.epil.init.i59.i, i64 %65
  store double %.320.2.i.epil.i68.i, ptr %scevgep16.i.epil.i69.i, align 8, !noalias !63
  %sunkaddr29.i.epil.i70.i = getelementptr i8, ptr %sunkaddr18.i.epil.i62.i, i64 24
  %.320.3.i.epil.i71.i = load double, ptr %sunkaddr29.i.epil.i70.i, align 8, !noalias !63
  %scevgep15.i.epil.i72.i = getelementptr i8, ptr %lsr.iv13.i.epil.init.i59.i, i64 %63
  store double %.320.3.i.epil.i71.i, ptr %scevgep15.i.epil.i72.i, align 8, !noalias !63
  br label %B126.loopexit.unr-lcssa.i.i50.i
B126.loopexit.unr-lcssa.i.i50.i:
  br i1 %76, label %B74.endif.endif.i.i, label %B96.epil.preheader.i.i51.i
B96.epil.preheader.i.i51.i:
  %.259154156.epil.init.i.i52.i = phi i64 [ %unroll_iter.i.i7.i, %B126.loopexit.unr-lcssa.i.i50.i ], [ 0, %B96.lr.ph.i.i28.i ]
  %45 = mul i64 %.259154156.epil.init.i.i52.i, %.69.i
  %46 = add i64 %.397.i.i, %.382.i.i
  %47 = add i64 %46, %45
  %48 = shl i64 %47, 3
  %scevgep.i4.i.i = getelementptr i8, ptr %a13, i64 %48
  %49 = shl i64 %.259154156.epil.init.i.i52.i, 3
  %scevgep3.i5.i.i = getelementptr i8, ptr %.3062.i, i64 %49
  br label %B96.epil.i.i53.i
B96.epil.i.i53.i:
  %lsr.iv.i6.i.i = phi ptr [ %scevgep2.i8.i.i, %B96.epil.i.i53.i ], [ %scevgep.i4.i.i, %B96.epil.preheader.i.i51.i ]
  %epil.iter.i.i54.i = phi i64 [ %epil.iter.next.i.i56.i, %B96.epil.i.i53.i ], [ 0, %B96.epil.preheader.i.i51.i ]
  %50 = shl i64 %epil.iter.i.i54.i, 3
  %scevgep33.i.i = getelementptr i8, ptr %scevgep3.i5.i.i, i64 %50
  %.320.epil.i.i55.i = load double, ptr %scevgep33.i.i, align 8, !noalias !63
  store double %.320.epil.i.i55.i, ptr %lsr.iv.i6.i.i, align 8, !noalias !63
  %epil.iter.next.i.i56.i = add i64 %epil.iter.i.i54.i, 1
  %scevgep2.i8.i.i = getelementptr i8, ptr %lsr.iv.i6.i.i, i64 %.16.i.i
  %epil.iter.cmp.not.i.i57.i = icmp eq i64 %xtraiter.i.i6.i, %epil.iter.next.i.i56.i
  br i1 %epil.iter.cmp.not.i.i57.i, label %B74.endif.endif.i.i, label %B96.epil.i.i53.i, !llvm.loop !66
B74.endif.endif.i.i:
  %.517.i.i = load i64, ptr %.179.i.i, align 8, !noalias !57
  %.518.i.i = add nsw i64 %.517.i.i, 1
  store i64 %.518.i.i, ptr %.179.i.i, align 8, !noalias !57
  %.586.i.i = icmp slt i64 %.518.i.i, %.69.i
  br i1 %.586.i.i, label %B282.i.i, label %B1768.i
B1768.i:
  %h.4.12529.i = phi double [ %.4280.sroa.16.2.i, %_ZN6poppet6engine10integrator8_segmentB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i ], [ %"$phi1540.1.2.1.i", %B1656.i ], [ %"$phi1540.1.2.1.i", %B38.i.i ], [ %"$phi1540.1.2.1.i", %B282.i.i ], [ %"$phi1540.1.2.1.i", %B74.endif.endif.i.i ]
  %t.6.12528.i = phi double [ %.4280.sroa.9.2.i, %_ZN6poppet6engine10integrator8_segmentB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i ], [ %"$phi1338.1.2.1.i", %B1656.i ], [ %"$phi1338.1.2.1.i", %B38.i.i ], [ %"$phi1338.1.2.1.i", %B282.i.i ], [ %"$phi1338.1.2.1.i", %B74.endif.endif.i.i ]
  %exitcond2609.not.i = icmp eq i64 %.3583.i, %.31.i
  br i1 %exitcond2609.not.i, label %B1772.i, label %B1260.i
B1772.i:
  %status.5.1.i = phi i64 [ 0, %B1172.endif.i ], [ 1, %B1352.endif.endif.i ], [ %.4280.sroa.0.2.i, %_ZN6poppet6engine10integrator8_segmentB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i ], [ 0, %B1768.i ]
  %t.4.1.i = phi double [ %.3452.i, %B1172.endif.i ], [ %.3647.i, %B1352.endif.endif.i ], [ %.4280.sroa.9.2.i, %_ZN6poppet6engine10integrator8_segmentB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i ], [ %t.6.12528.i, %B1768.i ]
  %k.2.1.i = phi i64 [ 0, %B1172.endif.i ], [ %.357625792586.i, %B1352.endif.endif.i ], [ %.357625792586.i, %_ZN6poppet6engine10integrator8_segmentB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i ], [ %.357625792586.i, %B1768.i ]
  %switch.i = icmp ult i64 %status.5.1.i, 2
  br i1 %switch.i, label %B1816.i, label %_ZN6poppet6engine10integrator9integrateB2v1B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAg6cJqBrMeIZJFEGM0QQAE8int64_2a8int64_2a10float64_2a10float64_2a10float64_2a10float64_2a8uint8_2a10float64_2a10float64_2a8uint8_2a10float64_2a8int64_2a10float64_2a10float64_2a10float64_2a10float64_2a8int64_2a10float64_2a.exit
B1816.i:
  %51 = getelementptr double, ptr %a4, i64 %k.2.1.i
  %.4827.i = load double, ptr %51, align 8, !noalias !0
  %.40.i7.i = fsub double %t.4.1.i, %.4827.i
  %.132223.not.i8.i = icmp slt i64 %.1503.i, 1
  br i1 %.132223.not.i8.i, label %B1816.endif.endif.i, label %B56.preheader.i9.i
B56.preheader.i9.i:
  %.4883.i = mul i64 %k.2.1.i, %.986.i
  %.4885.i = getelementptr double, ptr %a5, i64 %.4883.i
  %scevgep.i10.i = getelementptr i8, ptr %.4885.i, i64 40
  br label %B56.i11.i
B56.i11.i:
  %lsr.iv404.i = phi i64 [ %lsr.iv.next405.i, %B316.i24.i ], [ %.1415.sroa.0.3.i, %B56.preheader.i9.i ]
  %lsr.iv.i12.i = phi ptr [ %scevgep1.i27.i, %B316.i24.i ], [ %scevgep.i10.i, %B56.preheader.i9.i ]
  %scevgep6.i15.i = getelementptr i8, ptr %lsr.iv.i12.i, i64 -40
  %.227.i16.i = load double, ptr %scevgep6.i15.i, align 8, !noalias !67
  %scevgep5.i17.i = getelementptr i8, ptr %lsr.iv.i12.i, i64 -32
  %.282.i18.i = load double, ptr %scevgep5.i17.i, align 8, !noalias !67
  %.284.i19.i = fmul double %.40.i7.i, %.282.i18.i
  %.285.i20.i = fadd double %.227.i16.i, %.284.i19.i
  %scevgep4.i21.i = getelementptr i8, ptr %lsr.iv.i12.i, i64 -24
  %.347.i22.i = load double, ptr %scevgep4.i21.i, align 8, !noalias !67
  %.348.i23.i = fcmp une double %.347.i22.i, 0.000000e+00
  br i1 %.348.i23.i, label %B134.i29.i, label %B316.i24.i
B134.i29.i:
  %scevgep3.i30.i = getelementptr i8, ptr %lsr.iv.i12.i, i64 -16
  %.405.i31.i = load double, ptr %scevgep3.i30.i, align 8, !noalias !67
  %scevgep2.i32.i = getelementptr i8, ptr %lsr.iv.i12.i, i64 -8
  %.460.i33.i = load double, ptr %scevgep2.i32.i, align 8, !noalias !67
  %.461.i34.i = fmul double %.460.i33.i, 5.000000e-01
  %.463.i35.i = fmul double %.40.i7.i, %.461.i34.i
  %.464.i36.i = fadd double %.405.i31.i, %.463.i35.i
  %.465.i37.i = fmul double %.464.i36.i, 0x401921FB54442D18
  %.467.i38.i = fmul double %.40.i7.i, %.465.i37.i
  %.522.i39.i = load double, ptr %lsr.iv.i12.i, align 8, !noalias !67
  %.523.i40.i = fadd double %.522.i39.i, %.467.i38.i
  %.586.le.i41.i = tail call double @llvm.sin.f64(double %.523.i40.i)
  %.591.i42.i = fmul double %.347.i22.i, %.586.le.i41.i
  %.593.i43.i = fadd double %.285.i20.i, %.591.i42.i
  br label %B316.i24.i
B316.i24.i:
  %value.2.1.i25.i = phi double [ %.593.i43.i, %B134.i29.i ], [ %.285.i20.i, %B56.i11.i ]
  %52 = shl i64 %lsr.iv404.i, 3
  %scevgep406.i = getelementptr i8, ptr %.1343.i, i64 %52
  store double %value.2.1.i25.i, ptr %scevgep406.i, align 8, !noalias !67
  %scevgep1.i27.i = getelementptr i8, ptr %lsr.iv.i12.i, i64 48
  %lsr.iv.next405.i = add nuw i64 %lsr.iv404.i, 1
  %exitcond.not.i28.i = icmp eq i64 %.1415.sroa.13.0.i, %lsr.iv.next405.i
  br i1 %exitcond.not.i28.i, label %B1816.endif.endif.i, label %B56.i11.i
B0.endif.endif.endif.endi...else.endif.if.i:
  br label %B0.endif.endif.endif.endi...else.endif.endif.i
B0.endif.endif.endif.endi...else.endif.endif.i:
  %.1058.sroa.0.3.i = phi i64 [ %.991.i, %B0.endif.endif.endif.endi...else.endif.if.i ], [ 0, %0 ]
  %.1085.i = icmp slt i64 %.23.i, 0
  %.1086.i = select i1 %.1085.i, i64 %.991.i, i64 0
  %.1087.i = add i64 %.1086.i, %.985.i
  %.1090.i = icmp slt i64 %.1087.i, 0
  br i1 %.1090.i, label %B0.endif.endif.endif.endi...else.endif.endif.if.i, label %B0.endif.endif.endif.endi...else.endif.endif.endif.i, !prof !3
B0.endif.endif.endif.endi...else.endif.endif.if.i:
  br label %B0.endif.endif.endif.endi...else.endif.endif.endif.i
B0.endif.endif.endif.endi...else.endif.endif.endif.i:
  %.1058.sroa.13.1.i = phi i64 [ 0, %B0.endif.endif.endif.endi...else.endif.endif.if.i ], [ %.1087.i, %B0.endif.endif.endif.endi...else.endif.endif.i ]
  %.1095.not.i = icmp slt i64 %.1087.i, %.991.i
  br i1 %.1095.not.i, label %B0.endif.endif.endif.endi...endif.3.else.i, label %B0.endif.endif.endif.endi...else.endif.endif.endif.if.i, !prof !10
B0.endif.endif.endif.endi...else.endif.endif.endif.if.i:
  br label %B0.endif.endif.endif.endi...endif.3.else.i
B0.endif.endif.endif.endi...endif.3.else.i:
  %.1058.sroa.13.0.i = phi i64 [ %.1058.sroa.13.1.i, %B0.endif.endif.endif.endi...else.endif.endif.endif.i ], [ %.991.i, %B0.endif.endif.endif.endi...else.endif.endif.endif.if.i ]
  %.1146.i = sub i64 %.1058.sroa.13.0.i, %.1058.sroa.0.3.i
  %.1155.i = tail call i64 @llvm.smax.i64(i64 %.1146.i, i64 0)
  %.1171.i = getelementptr double, ptr %a17, i64 %.1058.sroa.0.3.i
  br i1 %.1090.i, label %B0.endif.endif.endif.endi...endif.3.else.if.i, label %B0.endif.endif.endif.endi...endif.3.else.endif.i, !prof !3
B0.endif.endif.endif.endi...endif.3.else.if.i:
  br label %B0.endif.endif.endif.endi...endif.3.else.endif.i
B0.endif.endif.endif.endi...endif.3.else.endif.i:
  %.1230.sroa.0.1.i = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.3.else.if.i ], [ %.1087.i, %B0.endif.endif.endif.endi...endif.3.else.i ]
  br i1 %.1095.not.i, label %B0.endif.endif.endif.endi...endif.3.endif.else.i, label %B0.endif.endif.endif.endi...endif.3.else.endif.if.i, !prof !10
B0.endif.endif.endif.endi...endif.3.else.endif.if.i:
  br label %B0.endif.endif.endif.endi...endif.3.endif.else.i
B0.endif.endif.endif.endi...endif.3.endif.else.i:
  %.1230.sroa.0.3.i = phi i64 [ %.991.i, %B0.endif.endif.endif.endi...endif.3.else.endif.if.i ], [ %.1230.sroa.0.1.i, %B0.endif.endif.endif.endi...endif.3.else.endif.i ]
  %.1318.i = sub i64 %.991.i, %.1230.sroa.0.3.i
  %.1327.i = tail call i64 @llvm.smax.i64(i64 %.1318.i, i64 0)
  %.1343.i = getelementptr double, ptr %a17, i64 %.1230.sroa.0.3.i
  %.1435.i = icmp slt i64 %.1318.i, 1
  br i1 %.1435.i, label %B0.endif.endif.endif.endi...if.6.i, label %B0.endif.endif.endif.endi...endif.6.i, !prof !3
B0.endif.endif.endif.endi...if.6.i:
  br label %B0.endif.endif.endif.endi...endif.6.i
B0.endif.endif.endif.endi...endif.6.i:
  %.1415.sroa.0.3.i = phi i64 [ %.1327.i, %B0.endif.endif.endif.endi...if.6.i ], [ 0, %B0.endif.endif.endif.endi...endif.3.endif.else.i ]
  %.1442.i = icmp slt i64 %.27.i, 0
  %.1443.i = select i1 %.1442.i, i64 %.1327.i, i64 0
  %.1444.i = add i64 %.1443.i, %.27.i
  %.1447.i = icmp slt i64 %.1444.i, 0
  br i1 %.1447.i, label %B0.endif.endif.endif.endi...endif.6.if.i, label %B0.endif.endif.endif.endi...endif.6.endif.i, !prof !3
B0.endif.endif.endif.endi...endif.6.if.i:
  br label %B0.endif.endif.endif.endi...endif.6.endif.i
B0.endif.endif.endif.endi...endif.6.endif.i:
  %.1415.sroa.13.1.i = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.6.if.i ], [ %.1444.i, %B0.endif.endif.endif.endi...endif.6.i ]
  %.1452.not.i = icmp slt i64 %.1444.i, %.1327.i
  br i1 %.1452.not.i, label %B0.endif.endif.endif.endi...endif.3.endif.endif.else.i, label %B0.endif.endif.endif.endi...endif.6.endif.if.i, !prof !10
B0.endif.endif.endif.endi...endif.6.endif.if.i:
  br label %B0.endif.endif.endif.endi...endif.3.endif.endif.else.i
B0.endif.endif.endif.endi...endif.3.endif.endif.else.i:
  %.1415.sroa.13.0.i = phi i64 [ %.1415.sroa.13.1.i, %B0.endif.endif.endif.endi...endif.6.endif.i ], [ %.1327.i, %B0.endif.endif.endif.endi...endif.6.endif.if.i ]
  %.1503.i = sub nsw i64 %.1415.sroa.13.0.i, %.1415.sroa.0.3.i
  %.1512.i = tail call i64 @llvm.smax.i64(i64 %.1503.i, i64 0)
  %.1528.i = getelementptr double, ptr %.1343.i, i64 %.1415.sroa.0.3.i
  %.1560.i = mul nsw i64 %.27.i, 5
  br i1 %.1447.i, label %B0.endif.endif.endif.endi...if.8.i, label %B0.endif.endif.endif.endi...endif.8.i, !prof !3
B0.endif.endif.endif.endi...if.8.i:
  br label %B0.endif.endif.endif.endi...endif.8.i
B0.endif.endif.endif.endi...endif.8.i:
  %.1586.sroa.0.1.i = phi i64 [ 0, %B0.endif.endif.endif.endi...if.8.i ], [ %.1444.i, %B0.endif.endif.endif.endi...endif.3.endif.endif.else.i ]
  br i1 %.1452.not.i, label %B0.endif.endif.endif.endi...endif.8.endif.i, label %B0.endif.endif.endif.endi...endif.8.if.i, !prof !10
B0.endif.endif.endif.endi...endif.8.if.i:
  br label %B0.endif.endif.endif.endi...endif.8.endif.i
B0.endif.endif.endif.endi...endif.8.endif.i:
  %.1586.sroa.0.3.i = phi i64 [ %.1327.i, %B0.endif.endif.endif.endi...endif.8.if.i ], [ %.1586.sroa.0.1.i, %B0.endif.endif.endif.endi...endif.8.i ]
  %.1615.i = add i64 %.1443.i, %.1560.i
  %.1618.i = icmp slt i64 %.1615.i, 0
  br i1 %.1618.i, label %B0.endif.endif.endif.endi...endif.8.endif.if.i, label %B0.endif.endif.endif.endi...endif.8.endif.endif.i, !prof !3
B0.endif.endif.endif.endi...endif.8.endif.if.i:
  br label %B0.endif.endif.endif.endi...endif.8.endif.endif.i
B0.endif.endif.endif.endi...endif.8.endif.endif.i:
  %.1586.sroa.13.1.i = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.8.endif.if.i ], [ %.1615.i, %B0.endif.endif.endif.endi...endif.8.endif.i ]
  %.1623.not.i = icmp slt i64 %.1615.i, %.1327.i
  br i1 %.1623.not.i, label %B0.endif.endif.endif.endi...else.1.i, label %B0.endif.endif.endif.endi...endif.8.endif.endif.if.i, !prof !10
B0.endif.endif.endif.endi...endif.8.endif.endif.if.i:
  br label %B0.endif.endif.endif.endi...else.1.i
B0.endif.endif.endif.endi...else.1.i:
  %.1586.sroa.13.0.i = phi i64 [ %.1586.sroa.13.1.i, %B0.endif.endif.endif.endi...endif.8.endif.endif.i ], [ %.1327.i, %B0.endif.endif.endif.endi...endif.8.endif.endif.if.i ]
  %.1674.i = sub nsw i64 %.1586.sroa.13.0.i, %.1586.sroa.0.3.i
  %.1683.i = tail call i64 @llvm.smax.i64(i64 %.1674.i, i64 0)
  %.1699.i = getelementptr double, ptr %.1343.i, i64 %.1586.sroa.0.3.i
  br i1 %.1618.i, label %B0.endif.endif.endif.endi...else.1.if.i, label %B0.endif.endif.endif.endi...else.1.endif.i, !prof !3
B0.endif.endif.endif.endi...else.1.if.i:
  br label %B0.endif.endif.endif.endi...else.1.endif.i
B0.endif.endif.endif.endi...else.1.endif.i:
  %.1758.sroa.0.1.i = phi i64 [ 0, %B0.endif.endif.endif.endi...else.1.if.i ], [ %.1615.i, %B0.endif.endif.endif.endi...else.1.i ]
  br i1 %.1623.not.i, label %B0.endif.endif.endif.endi...else.1.endif.endif.i, label %B0.endif.endif.endif.endi...else.1.endif.if.i, !prof !10
B0.endif.endif.endif.endi...else.1.endif.if.i:
  br label %B0.endif.endif.endif.endi...else.1.endif.endif.i
B0.endif.endif.endif.endi...else.1.endif.endif.i:
  %.1758.sroa.0.3.i = phi i64 [ %.1327.i, %B0.endif.endif.endif.endi...else.1.endif.if.i ], [ %.1758.sroa.0.1.i, %B0.endif.endif.endif.endi...else.1.endif.i ]
  %.1787.i = add i64 %.1443.i, %.986.i
  %.1790.i = icmp slt i64 %.1787.i, 0
  br i1 %.1790.i, label %B0.endif.endif.endif.endi...else.1.endif.endif.if.i, label %B0.endif.endif.endif.endi...else.1.endif.endif.endif.i, !prof !3
B0.endif.endif.endif.endi...else.1.endif.endif.if.i:
  br label %B0.endif.endif.endif.endi...else.1.endif.endif.endif.i
B0.endif.endif.endif.endi...else.1.endif.endif.endif.i:
  %.1758.sroa.13.1.i = phi i64 [ 0, %B0.endif.endif.endif.endi...else.1.endif.endif.if.i ], [ %.1787.i, %B0.endif.endif.endif.endi...else.1.endif.endif.i ]
  %.1795.not.i = icmp slt i64 %.1787.i, %.1327.i
  br i1 %.1795.not.i, label %B0.endif.endif.endif.endi...endif.10.else.i, label %B0.endif.endif.endif.endi...if.11.i, !prof !10
B0.endif.endif.endif.endi...if.11.i:
  br label %B0.endif.endif.endif.endi...endif.10.else.i
B0.endif.endif.endif.endi...endif.10.else.i:
  %.1758.sroa.13.0.i = phi i64 [ %.1758.sroa.13.1.i, %B0.endif.endif.endif.endi...else.1.endif.endif.endif.i ], [ %.1327.i, %B0.endif.endif.endif.endi...if.11.i ]
  %.1846.i = sub nsw i64 %.1758.sroa.13.0.i, %.1758.sroa.0.3.i
  %.1871.i = getelementptr double, ptr %.1343.i, i64 %.1758.sroa.0.3.i
  br i1 %.1790.i, label %B0.endif.endif.endif.endi...endif.10.else.if.i, label %B0.endif.endif.endif.endi...endif.10.else.endif.i, !prof !3
B0.endif.endif.endif.endi...endif.10.else.if.i:
  br label %B0.endif.endif.endif.endi...endif.10.else.endif.i
B0.endif.endif.endif.endi...endif.10.else.endif.i:
  %.1929.sroa.0.1.i = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.10.else.if.i ], [ %.1787.i, %B0.endif.endif.endif.endi...endif.10.else.i ]
  br i1 %.1795.not.i, label %B0.endif.endif.endif.endi...endif.10.endif.else.endif.i, label %B0.endif.endif.endif.endi...endif.10.else.endif.if.i, !prof !10
B0.endif.endif.endif.endi...endif.10.else.endif.if.i:
  br label %B0.endif.endif.endif.endi...endif.10.endif.else.endif.i
B0.endif.endif.endif.endi...endif.10.endif.else.endif.i:
  %.1929.sroa.0.3.i = phi i64 [ %.1327.i, %B0.endif.endif.endif.endi...endif.10.else.endif.if.i ], [ %.1929.sroa.0.1.i, %B0.endif.endif.endif.endi...endif.10.else.endif.i ]
  %.2017.i = sub nsw i64 %.1327.i, %.1929.sroa.0.3.i
  %.2026.i = tail call i64 @llvm.smax.i64(i64 %.2017.i, i64 0)
  %.2042.i = getelementptr double, ptr %.1343.i, i64 %.1929.sroa.0.3.i
  %.23852611.i = add nsw i64 %.73.i, 2
  %53 = tail call i64 @llvm.umin.i64(i64 %.2026.i, i64 2)
  %.2438.i = icmp slt i64 %.73.i, -2
  %.2439.i = select i1 %.2438.i, i64 %.2026.i, i64 0
  %.2440.i = add i64 %.23852611.i, %.2439.i
  %.2443.i = icmp slt i64 %.2440.i, 0
  %.2448.not.i = icmp slt i64 %.2440.i, %.2026.i
  %.2524.i = getelementptr double, ptr %.2042.i, i64 %53
  br i1 %.2443.i, label %B0.endif.endif.endif.endi...else.2.if.i, label %B0.endif.endif.endif.endi...else.2.endif.i, !prof !3
B0.endif.endif.endif.endi...else.2.if.i:
  br label %B0.endif.endif.endif.endi...else.2.endif.i
B0.endif.endif.endif.endi...else.2.endif.i:
  %.2582.sroa.0.1.i = phi i64 [ 0, %B0.endif.endif.endif.endi...else.2.if.i ], [ %.2440.i, %B0.endif.endif.endif.endi...endif.10.endif.else.endif.i ]
  br i1 %.2448.not.i, label %B0.endif.endif.endif.endi...endif.19.else.i, label %B0.endif.endif.endif.endi...else.2.endif.if.i, !prof !10
B0.endif.endif.endif.endi...else.2.endif.if.i:
  br label %B0.endif.endif.endif.endi...endif.19.else.i
B0.endif.endif.endif.endi...endif.19.else.i:
  %.2582.sroa.0.3.i = phi i64 [ %.2026.i, %B0.endif.endif.endif.endi...else.2.endif.if.i ], [ %.2582.sroa.0.1.i, %B0.endif.endif.endif.endi...else.2.endif.i ]
  %.2670.i = sub nsw i64 %.2026.i, %.2582.sroa.0.3.i
  %.2679.i = tail call i64 @llvm.smax.i64(i64 %.2670.i, i64 0)
  %.2695.i = getelementptr double, ptr %.2042.i, i64 %.2582.sroa.0.3.i
  %.2799.i = icmp slt i64 %.2670.i, 1
  br i1 %.2799.i, label %B0.endif.endif.endif.endi...endif.19.else.endif.if.i, label %B0.endif.endif.endif.endi...endif.19.else.endif.endif.i, !prof !3
B0.endif.endif.endif.endi...endif.19.else.endif.if.i:
  br label %B0.endif.endif.endif.endi...endif.19.else.endif.endif.i
B0.endif.endif.endif.endi...endif.19.else.endif.endif.i:
  %.2779.sroa.0.3.i = phi i64 [ %.2679.i, %B0.endif.endif.endif.endi...endif.19.else.endif.if.i ], [ 0, %B0.endif.endif.endif.endi...endif.19.else.i ]
  %.2806.i = icmp slt i64 %.75.i, 0
  %.2807.i = select i1 %.2806.i, i64 %.2679.i, i64 0
  %.2808.i = add i64 %.2807.i, %.75.i
  %.2811.i = icmp slt i64 %.2808.i, 0
  %.2816.not.i = icmp slt i64 %.2808.i, %.2679.i
  %.2892.i = getelementptr double, ptr %.2695.i, i64 %.2779.sroa.0.3.i
  br i1 %.2811.i, label %B0.endif.endif.endif.endi...endif.19.endif.else.if.i, label %B0.endif.endif.endif.endi...endif.19.endif.else.endif.i, !prof !3
B0.endif.endif.endif.endi...endif.19.endif.else.if.i:
  br label %B0.endif.endif.endif.endi...endif.19.endif.else.endif.i
B0.endif.endif.endif.endi...endif.19.endif.else.endif.i:
  %.2949.sroa.0.1.i = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.19.endif.else.if.i ], [ %.2808.i, %B0.endif.endif.endif.endi...endif.19.else.endif.endif.i ]
  br i1 %.2816.not.i, label %B0.endif.endif.endif.endi...endif.19.endif.endif.endif.i, label %B0.endif.endif.endif.endi...if.24.i, !prof !10
B0.endif.endif.endif.endi...if.24.i:
  br label %B0.endif.endif.endif.endi...endif.19.endif.endif.endif.i
B0.endif.endif.endif.endi...endif.19.endif.endif.endif.i:
  %.2949.sroa.0.3.i = phi i64 [ %.2679.i, %B0.endif.endif.endif.endi...if.24.i ], [ %.2949.sroa.0.1.i, %B0.endif.endif.endif.endi...endif.19.endif.else.endif.i ]
  %.3037.i = sub nsw i64 %.2679.i, %.2949.sroa.0.3.i
  %.3046.i = tail call i64 @llvm.smax.i64(i64 %.3037.i, i64 0)
  %.3062.i = getelementptr double, ptr %.2695.i, i64 %.2949.sroa.0.3.i
  %.31952569.not.i = icmp slt i64 %.23.i, 1
  br i1 %.31952569.not.i, label %B1172.endif.i, label %B1094.lr.ph.i
B1094.lr.ph.i:
  %invariant.gep.i = getelementptr double, ptr %a14, i64 %.23.i
  %.idx.i = shl i64 %.23.i, 4
  %invariant.gep2632.i = getelementptr i8, ptr %a14, i64 %.idx.i
  %54 = icmp eq i64 %.23.i, 1
  br i1 %54, label %B1094.epil.preheader.i, label %B1094.lr.ph.new.i
B1094.lr.ph.new.i:
  %unroll_iter.i = and i64 %.23.i, 9223372036854775806
  %scevgep410.i = getelementptr i8, ptr %a2, i64 8
  %scevgep414.i = getelementptr i8, ptr %a14, i64 8
  %sunkaddr.i = shl i64 %.23.i, 3
  br label %B1094.i
B1172.endif.loopexit.unr-lcssa.i:
  %55 = and i64 %.23.i, 1
  %lcmp.mod.not.i = icmp eq i64 %55, 0
  br i1 %lcmp.mod.not.i, label %B1172.endif.i, label %B1094.epil.preheader.i
B1094.epil.preheader.i:
  %.320125682570.epil.init.i = phi i64 [ 0, %B1094.lr.ph.i ], [ %unroll_iter.i, %B1172.endif.loopexit.unr-lcssa.i ]
  %56 = getelementptr double, ptr %a2, i64 %.320125682570.epil.init.i
  %.3262.epil.i = load double, ptr %56, align 8, !noalias !0
  %57 = getelementptr double, ptr %a14, i64 %.320125682570.epil.init.i
  store double %.3262.epil.i, ptr %57, align 8, !noalias !0
  %gep.epil.i = getelementptr double, ptr %invariant.gep.i, i64 %.320125682570.epil.init.i
  store double %.3262.epil.i, ptr %gep.epil.i, align 8, !noalias !0
  %gep2633.epil.i = getelementptr double, ptr %invariant.gep2632.i, i64 %.320125682570.epil.init.i
  store double 0.000000e+00, ptr %gep2633.epil.i, align 8, !noalias !0
  br label %B1172.endif.i
B1172.endif.i:
  %.3421.i = getelementptr i8, ptr %a16, i64 24
  store i64 -1, ptr %.3421.i, align 8, !noalias !0
  %.3452.i = load double, ptr %a4, align 8, !noalias !0
  %.35702585.not.i = icmp slt i64 %.31.i, 1
  br i1 %.35702585.not.i, label %B1772.i, label %B1260.lr.ph.i
B1260.lr.ph.i:
  %.3708.i = tail call i64 @llvm.smin.i64(i64 %.69.i, i64 0)
  %58 = getelementptr double, ptr %a7, i64 %.69.i
  %59 = getelementptr i8, ptr %58, i64 -8
  %.3722.i = getelementptr double, ptr %59, i64 %.3708.i
  %scevgep.i134.i = getelementptr i8, ptr %a11, i64 8
  %scevgep3.i135.i = getelementptr i8, ptr %a12, i64 16
  %60 = icmp sgt i64 %.71.i, 0
  %61 = icmp slt i64 %.1503.i, 1
  %sunkaddr432.i = getelementptr i8, ptr %a0, i64 24
  %62 = icmp sgt i64 %.23.i, 0
  %.179.i.i = getelementptr i8, ptr %a16, i64 16
  %xtraiter.i.i6.i = and i64 %.3046.i, 3
  %unroll_iter.i.i7.i = and i64 %.3046.i, 9223372036854775804
  %63 = mul i64 %.69.i, 24
  %64 = shl i64 %.69.i, 5
  %65 = shl i64 %.69.i, 4
  %66 = add nsw i64 %unroll_iter.i.i7.i, -4
  %67 = lshr exact i64 %66, 2
  %68 = add nuw nsw i64 %67, 1
  %69 = lshr i64 %68, 1
  %70 = mul nsw i64 %69, -2
  %71 = icmp slt i64 %.3037.i, 1
  %72 = icmp slt i64 %.3037.i, 4
  %73 = icmp eq i64 %66, 0
  %74 = and i64 %66, 4
  %75 = icmp eq i64 %74, 0
  %76 = icmp eq i64 %xtraiter.i.i6.i, 0
  %.387.i.i = getelementptr i8, ptr %a0, i64 8
  %.600.i.i = shl nuw i64 %.23.i, 1
  %77 = icmp sgt i64 %.1146.i, %.23.i
  %.659.i.i = icmp slt i64 %.600.i.i, 0
  %.664.not.i.i = icmp slt i64 %.600.i.i, %.1155.i
  %.775.i.i = mul nuw nsw i64 %.23.i, 3
  %.838.not.i.i = icmp sgt i64 %.1146.i, %.775.i.i
  %.949.i.i = shl nsw i64 %.23.i, 2
  %.1012.not.i.i = icmp sgt i64 %.1146.i, %.949.i.i
  %.1123.i.i = mul nuw nsw i64 %.23.i, 6
  %.1186.not.i.i = icmp sgt i64 %.1146.i, %.1123.i.i
  %.1686.i.i = mul nuw nsw i64 %.23.i, 5
  %.arg.coefficients.5.0.i.i.i = tail call i64 @llvm.smax.i64(i64 %.27.i, i64 0)
  %78 = add nuw i64 %.arg.coefficients.5.0.i.i.i, 1
  %invariant.gep4527.i.i = getelementptr double, ptr %a14, i64 %.23.i
  %.idx.i.i.i = shl i64 %.25.i, 4
  %79 = getelementptr i8, ptr %a8, i64 %.idx.i.i.i
  %80 = shl i64 %.25.i, 3
  %scevgep135.i.i = getelementptr i8, ptr %a8, i64 %80
  %81 = shl i64 %.23.i, 4
  %scevgep165.i.i = getelementptr i8, ptr %a14, i64 %81
  %82 = icmp slt i64 %.1846.i, 1
  %83 = icmp slt i64 %.25.i, 1
  %sunkaddr168.i.i = getelementptr i8, ptr %.2042.i, i64 8
  %sunkaddr181.i.i = getelementptr i8, ptr %a16, i64 8
  %sunkaddr170.i.i = getelementptr i8, ptr %a0, i64 16
  %sunkaddr209.i.i = getelementptr i8, ptr %a16, i64 32
  %sunkaddr175.i.i = getelementptr i8, ptr %a7, i64 %.16.i.i
  %sunkaddr176.i.i = getelementptr i8, ptr %sunkaddr175.i.i, i64 -8
  %sunkaddr178.i.i = getelementptr i8, ptr %a10, i64 8
  %sunkaddr179.i.i = getelementptr i8, ptr %a15, i64 8
  br label %B1260.i
B1352.endif.i:
  %.3895.i = load i64, ptr %sunkaddr432.i, align 8, !noalias !0
  store double %.3647.i, ptr %.2042.i, align 8, !noalias !70
  %.168.i.i = inttoptr i64 %.3895.i to ptr
  tail call void %.168.i.i(ptr nonnull %.2042.i, ptr %a2, ptr %.1528.i, ptr %a3, ptr %.3062.i), !noalias !70
  br label %B108.endif.endif.i.i
B106.i.i:
  %.291.i.i = add nuw i64 %.284326331.i.i, 1
  %scevgep1.i138.i = getelementptr i8, ptr %lsr.iv.i136.i, i64 16
  %scevgep5.i139.i = getelementptr i8, ptr %lsr.iv4.i.i, i64 24
  %exitcond.not.i140.i = icmp eq i64 %.71.i, %.291.i.i
  br i1 %exitcond.not.i140.i, label %B1352.endif.endif.thread.i, label %B108.endif.endif.i.i
B192.i.i:
  %sunkaddr.i.i = getelementptr i8, ptr %lsr.iv4.i.i, i64 -16
  %.612.i.i = load double, ptr %sunkaddr.i.i, align 8, !noalias !70
  %.701.i.i = getelementptr double, ptr %.3062.i, i64 %.554.i.i
  %.702.i.i = load double, ptr %.701.i.i, align 8, !noalias !70
  %.703.i.i = fmul double %.612.i.i, %.702.i.i
  %.705.i.i = fadd double %.373.i.i, %.703.i.i
  br label %B252.i.i
B252.i.i:
  %value.3.2.i.i = phi double [ %.705.i.i, %B192.i.i ], [ %.373.i.i, %B108.endif.endif.i.i ]
  %.554.1.i.i = load i64, ptr %lsr.iv.i136.i, align 8, !noalias !70
  %.557.1.i.i = icmp sgt i64 %.554.1.i.i, -1
  br i1 %.557.1.i.i, label %B192.1.i.i, label %B252.1.i.i
B192.1.i.i:
  %scevgep6.i141.i = getelementptr i8, ptr %lsr.iv4.i.i, i64 -8
  %.612.1.i.i = load double, ptr %scevgep6.i141.i, align 8, !noalias !70
  %.701.1.i.i = getelementptr double, ptr %.3062.i, i64 %.554.1.i.i
  %.702.1.i.i = load double, ptr %.701.1.i.i, align 8, !noalias !70
  %.703.1.i.i = fmul double %.612.1.i.i, %.702.1.i.i
  %.705.1.i.i = fadd double %value.3.2.i.i, %.703.1.i.i
  br label %B252.1.i.i
B252.1.i.i:
  %value.3.2.1.i.i = phi double [ %.705.1.i.i, %B192.1.i.i ], [ %value.3.2.i.i, %B252.i.i ]
  %.724.i.i = fcmp ogt double %value.3.2.1.i.i, 0.000000e+00
  br i1 %.724.i.i, label %B1352.endif.endif.i, label %B106.i.i
B108.endif.endif.i.i:
  %lsr.iv4.i.i = phi ptr [ %scevgep3.i135.i, %B1352.endif.i ], [ %scevgep5.i139.i, %B106.i.i ]
  %lsr.iv.i136.i = phi ptr [ %scevgep.i134.i, %B1352.endif.i ], [ %scevgep1.i138.i, %B106.i.i ]
  %.284326331.i.i = phi i64 [ 0, %B1352.endif.i ], [ %.291.i.i, %B106.i.i ]
  %.373.i.i = load double, ptr %lsr.iv4.i.i, align 8, !noalias !70
  %scevgep2.i137.i = getelementptr i8, ptr %lsr.iv.i136.i, i64 -8
  %.554.i.i = load i64, ptr %scevgep2.i137.i, align 8, !noalias !70
  %.557.i.i = icmp sgt i64 %.554.i.i, -1
  br i1 %.557.i.i, label %B192.i.i, label %B252.i.i
B1352.endif.endif.thread.i:
  store i64 -1, ptr %.3421.i, align 8, !noalias !0
  br label %B1516.i
B1352.endif.endif.i:
  store i64 %.284326331.i.i, ptr %.3421.i, align 8, !noalias !0
  br label %B1772.i
B1816.endif.endif.i:
  %.4999.i = getelementptr i8, ptr %a16, i64 16
  %.5000.i = load i64, ptr %.4999.i, align 8, !noalias !0
  %.5002.i = add nsw i64 %.69.i, -1
  %.13.i.i = tail call i64 @llvm.smin.i64(i64 %.5002.i, i64 %.5000.i)
  store i64 %.13.i.i, ptr %.4999.i, align 8, !noalias !0
  %.5092.i = getelementptr i8, ptr %a0, i64 24
  %.5093.i = load i64, ptr %.5092.i, align 8, !noalias !0
  store double %t.4.1.i, ptr %.2042.i, align 8, !noalias !73
  %.151.i.i = inttoptr i64 %.5093.i to ptr
  tail call void %.151.i.i(ptr nonnull %.2042.i, ptr %a2, ptr %.1528.i, ptr %a3, ptr %.3062.i), !noalias !73
  %.253155.not.i.i = icmp slt i64 %.3037.i, 1
  br i1 %.253155.not.i.i, label %B1816.endif.endif.endif.i, label %B96.lr.ph.i.i
B96.lr.ph.i.i:
  %.349.i.i = icmp slt i64 %.13.i.i, 0
  %.350.i.i = select i1 %.349.i.i, i64 %.69.i, i64 0
  %xtraiter.i.i = and i64 %.3046.i, 3
  %84 = icmp ult i64 %.3037.i, 4
  br i1 %84, label %B96.epil.preheader.i.i, label %B96.lr.ph.new.i.i
B96.lr.ph.new.i.i:
  %invariant.gep.i.i = getelementptr double, ptr %a13, i64 %.13.i.i
  %invariant.gep159.i.i = getelementptr double, ptr %invariant.gep.i.i, i64 %.350.i.i
  %unroll_iter.i.i = and i64 %.3046.i, 9223372036854775804
  %85 = mul i64 %.69.i, 24
  %86 = shl i64 %.69.i, 5
  %87 = shl i64 %.69.i, 4
  %88 = add nsw i64 %.3046.i, -4
  %89 = lshr i64 %88, 2
  %90 = icmp eq i64 %89, 0
  br i1 %90, label %B96.i.epil.preheader.i, label %B96.lr.ph.new.i.new.i
B96.lr.ph.new.i.new.i:
  %91 = add nuw nsw i64 %89, 1
  %unroll_iter367.i = and i64 %91, 9223372036854775806
  %92 = add i64 %.1929.sroa.0.3.i, %.1230.sroa.0.3.i
  %93 = add i64 %92, %.2582.sroa.0.3.i
  %94 = add i64 %93, %.2949.sroa.0.3.i
  %95 = shl i64 %94, 3
  %96 = getelementptr i8, ptr %a17, i64 %95
  %scevgep381.i = getelementptr i8, ptr %96, i64 56
  br label %B96.i.i
B96.i.i:
  %lsr.iv.i = phi i64 [ %lsr.iv.next.i, %B96.i.i ], [ %unroll_iter367.i, %B96.lr.ph.new.i.new.i ]
  %lsr.iv13.i.i = phi ptr [ %scevgep403.i, %B96.i.i ], [ %invariant.gep159.i.i, %B96.lr.ph.new.i.new.i ]
  %.259154156.i.i = phi i64 [ %.266.3.i.1.i, %B96.i.i ], [ 0, %B96.lr.ph.new.i.new.i ]
  %sunkaddr.i142.i = shl i64 %.259154156.i.i, 3
  %scevgep395.i = getelementptr i8, ptr %scevgep381.i, i64 %sunkaddr.i142.i
  %scevgep396.i = getelementptr i8, ptr %scevgep395.i, i64 -56
  %.320.i.i = load double, ptr %scevgep396.i, align 8, !noalias !73
  store double %.320.i.i, ptr %lsr.iv13.i.i, align 8, !noalias !73
  %scevgep394.i = getelementptr i8, ptr %scevgep395.i, i64 -48
  %.320.1.i.i = load double, ptr %scevgep394.i, align 8, !noalias !73
  %sunkaddr23.i.i = getelementptr i8, ptr %lsr.iv13.i.i, i64 %.16.i.i
  store double %.320.1.i.i, ptr %sunkaddr23.i.i, align 8, !noalias !73
  %scevgep392.i = getelementptr i8, ptr %scevgep395.i, i64 -40
  %.320.2.i.i = load double, ptr %scevgep392.i, align 8, !noalias !73
  %scevgep397.i = getelementptr i8, ptr %sunkaddr23.i.i, i64 %.16.i.i
  store double %.320.2.i.i, ptr %scevgep397.i, align 8, !noalias !73
  %scevgep390.i = getelementptr i8, ptr %scevgep395.i, i64 -32
  %.320.3.i.i = load double, ptr %scevgep390.i, align 8, !noalias !73
  %scevgep398.i = getelementptr i8, ptr %scevgep397.i, i64 %.16.i.i
  store double %.320.3.i.i, ptr %scevgep398.i, align 8, !noalias !73
  %scevgep388.i = getelementptr i8, ptr %scevgep395.i, i64 -24
  %.320.i.1.i = load double, ptr %scevgep388.i, align 8, !noalias !73
  %scevgep399.i = getelementptr i8, ptr %scevgep398.i, i64 %.16.i.i
  store double %.320.i.1.i, ptr %scevgep399.i, align 8, !noalias !73
  %scevgep386.i = getelementptr i8, ptr %scevgep395.i, i64 -16
  %.320.1.i.1.i = load double, ptr %scevgep386.i, align 8, !noalias !73
  %scevgep400.i = getelementptr i8, ptr %scevgep399.i, i64 %.16.i.i
  store double %.320.1.i.1.i, ptr %scevgep400.i, align 8, !noalias !73
  %scevgep384.i = getelementptr i8, ptr %scevgep395.i, i64 -8
  %.320.2.i.1.i = load double, ptr %scevgep384.i, align 8, !noalias !73
  %scevgep401.i = getelementptr i8, ptr %scevgep400.i, i64 %.16.i.i
  store double %.320.2.i.1.i, ptr %scevgep401.i, align 8, !noalias !73
  %.266.3.i.1.i = add nuw i64 %.259154156.i.i, 8
  %.320.3.i.1.i = load double, ptr %scevgep395.i, align 8, !noalias !73
  %scevgep402.i = getelementptr i8, ptr %scevgep401.i, i64 %.16.i.i
  store double %.320.3.i.1.i, ptr %scevgep402.i, align 8, !noalias !73
  %lsr.iv.next.i = add i64 %lsr.iv.i, -2
  %niter368.ncmp.1.i = icmp eq i64 %lsr.iv.next.i, 0
  %scevgep403.i = getelementptr i8, ptr %scevgep402.i, i64 %.16.i.i
  br i1 %niter368.ncmp.1.i, label %B126.loopexit.unr-lcssa.i.unr-lcssa.i, label %B96.i.i
B126.loopexit.unr-lcssa.i.unr-lcssa.i:
  %scevgep14.i.i = getelementptr i8, ptr %lsr.iv13.i.i, i64 %86
  %scevgep14.i.1.i = getelementptr i8, ptr %scevgep14.i.i, i64 %86
  %97 = and i64 %88, 4
  %lcmp.mod365.not.not.i = icmp eq i64 %97, 0
  br i1 %lcmp.mod365.not.not.i, label %B96.i.epil.preheader.i, label %B126.loopexit.unr-lcssa.i.i
B96.i.epil.preheader.i:
  %lsr.iv13.i.epil.init.i = phi ptr [ %invariant.gep159.i.i, %B96.lr.ph.new.i.i ], [ %scevgep14.i.1.i, %B126.loopexit.unr-lcssa.i.unr-lcssa.i ]
  %.259154156.i.epil.init.i = phi i64 [ 0, %B96.lr.ph.new.i.i ], [ %.266.3.i.1.i, %B126.loopexit.unr-lcssa.i.unr-lcssa.i ]
  %sunkaddr.i142.epil.i = shl i64 %.259154156.i.epil.init.i, 3
  %sunkaddr18.i.epil.i = getelementptr i8, ptr %.3062.i, i64 %sunkaddr.i142.epil.i
  %.320.i.epil.i = load double, ptr %sunkaddr18.i.epil.i, align 8, !noalias !73
  store double %.320.i.epil.i, ptr %lsr.iv13.i.epil.init.i, align 8, !noalias !73
  %sunkaddr21.i.epil.i = getelementptr i8, ptr %sunkaddr18.i.epil.i, i64 8
  %.320.1.i.epil.i = load double, ptr %sunkaddr21.i.epil.i, align 8, !noalias !73
  %sunkaddr23.i.epil.i = getelementptr i8, ptr %lsr.iv13.i.epil.init.i, i64 %.16.i.i
  store double %.320.1.i.epil.i, ptr %sunkaddr23.i.epil.i, align 8, !noalias !73
  %sunkaddr26.i.epil.i = getelementptr i8, ptr %sunkaddr18.i.epil.i, i64 16
  %.320.2.i.epil.i = load double, ptr %sunkaddr26.i.epil.i, align 8, !noalias !73
  %scevgep16.i.epil.i = getelementptr i8, ptr %lsr.iv13.i.epil.init.i, i64 %87
  store double %.320.2.i.epil.i, ptr %scevgep16.i.epil.i, align 8, !noalias !73
  %sunkaddr29.i.epil.i = getelementptr i8, ptr %sunkaddr18.i.epil.i, i64 24
  %.320.3.i.epil.i = load double, ptr %sunkaddr29.i.epil.i, align 8, !noalias !73
  %scevgep15.i.epil.i = getelementptr i8, ptr %lsr.iv13.i.epil.init.i, i64 %85
  store double %.320.3.i.epil.i, ptr %scevgep15.i.epil.i, align 8, !noalias !73
  br label %B126.loopexit.unr-lcssa.i.i
B126.loopexit.unr-lcssa.i.i:
  %lcmp.mod.not.i.i = icmp eq i64 %xtraiter.i.i, 0
  br i1 %lcmp.mod.not.i.i, label %B1816.endif.endif.endif.i, label %B96.epil.preheader.i.i
B96.epil.preheader.i.i:
  %.259154156.epil.init.i.i = phi i64 [ %unroll_iter.i.i, %B126.loopexit.unr-lcssa.i.i ], [ 0, %B96.lr.ph.i.i ]
  %98 = mul i64 %.259154156.epil.init.i.i, %.69.i
  %99 = add i64 %.350.i.i, %.13.i.i
  %100 = add i64 %99, %98
  %101 = shl i64 %100, 3
  %scevgep.i143.i = getelementptr i8, ptr %a13, i64 %101
  %102 = add i64 %.1929.sroa.0.3.i, %.1230.sroa.0.3.i
  %103 = add i64 %102, %.2582.sroa.0.3.i
  %104 = add i64 %103, %.2949.sroa.0.3.i
  %105 = add i64 %104, %.259154156.epil.init.i.i
  %106 = shl i64 %105, 3
  %scevgep.i = getelementptr i8, ptr %a17, i64 %106
  br label %B96.epil.i.i
B96.epil.i.i:
  %lsr.iv.i145.i = phi ptr [ %scevgep2.i147.i, %B96.epil.i.i ], [ %scevgep.i143.i, %B96.epil.preheader.i.i ]
  %epil.iter.i.i = phi i64 [ %epil.iter.next.i.i, %B96.epil.i.i ], [ 0, %B96.epil.preheader.i.i ]
  %107 = shl i64 %epil.iter.i.i, 3
  %scevgep380.i = getelementptr i8, ptr %scevgep.i, i64 %107
  %.320.epil.i.i = load double, ptr %scevgep380.i, align 8, !noalias !73
  store double %.320.epil.i.i, ptr %lsr.iv.i145.i, align 8, !noalias !73
  %epil.iter.next.i.i = add i64 %epil.iter.i.i, 1
  %scevgep2.i147.i = getelementptr i8, ptr %lsr.iv.i145.i, i64 %.16.i.i
  %epil.iter.cmp.not.i.i = icmp eq i64 %xtraiter.i.i, %epil.iter.next.i.i
  br i1 %epil.iter.cmp.not.i.i, label %B1816.endif.endif.endif.i, label %B96.epil.i.i, !llvm.loop !76
B1816.endif.endif.endif.i:
  %.5235.i = load i64, ptr %.4999.i, align 8, !noalias !0
  %.5236.i = add nsw i64 %.5235.i, 1
  store i64 %.5236.i, ptr %.4999.i, align 8, !noalias !0
  br label %_ZN6poppet6engine10integrator9integrateB2v1B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAg6cJqBrMeIZJFEGM0QQAE8int64_2a8int64_2a10float64_2a10float64_2a10float64_2a10float64_2a8uint8_2a10float64_2a10float64_2a8uint8_2a10float64_2a8int64_2a10float64_2a10float64_2a10float64_2a10float64_2a8int64_2a10float64_2a.exit
_ZN6poppet6engine10integrator9integrateB2v1B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAg6cJqBrMeIZJFEGM0QQAE8int64_2a8int64_2a10float64_2a10float64_2a10float64_2a10float64_2a8uint8_2a10float64_2a10float64_2a8uint8_2a10float64_2a8int64_2a10float64_2a10float64_2a10float64_2a10float64_2a8int64_2a10float64_2a.exit:
  store double %t.4.1.i, ptr %a15, align 8, !noalias !0
  ret i64 %status.5.1.i
}
!0 = !{!1}
!1 = distinct !{!1, !2, !"_ZN6poppet6engine10integrator9integrateB2v1B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAg6cJqBrMeIZJFEGM0QQAE8int64_2a8int64_2a10float64_2a10float64_2a10float64_2a10float64_2a8uint8_2a10float64_2a10float64_2a8uint8_2a10float64_2a8int64_2a10float64_2a10float64_2a10float64_2a10float64_2a8int64_2a10float64_2a: %retptr"}
!2 = distinct !{!2, !"_ZN6poppet6engine10integrator9integrateB2v1B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAg6cJqBrMeIZJFEGM0QQAE8int64_2a8int64_2a10float64_2a10float64_2a10float64_2a10float64_2a8uint8_2a10float64_2a10float64_2a8uint8_2a10float64_2a8int64_2a10float64_2a10float64_2a10float64_2a10float64_2a8int64_2a10float64_2a"}
!3 = !{!"branch_weights", i32 1, i32 99}
!4 = !{!5, !1}
!5 = distinct !{!5, !6, !"_ZN6poppet6engine10integrator10_inputs_atB2v8B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!6 = distinct !{!6, !"_ZN6poppet6engine10integrator10_inputs_atB2v8B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!7 = !{!8, !1}
!8 = distinct !{!8, !9, !"_ZN6poppet6engine10integrator8_segmentB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE: %retptr"}
!9 = distinct !{!9, !"_ZN6poppet6engine10integrator8_segmentB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE"}
!10 = !{!"branch_weights", i32 99, i32 1}
!11 = !{!12, !8, !1}
!12 = distinct !{!12, !13, !"_ZN6poppet6engine10integrator10_inputs_atB2v8B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!13 = distinct !{!13, !"_ZN6poppet6engine10integrator10_inputs_atB2v8B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!14 = !{!15, !8, !1}
!15 = distinct !{!15, !16, !"_ZN6poppet6engine10integrator11_first_stepB3v13B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedEd: %retptr"}
!16 = distinct !{!16, !"_ZN6poppet6engine10integrator11_first_stepB3v13B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedEd"}
!17 = !{!18, !8, !1}
!18 = distinct !{!18, !19, !"_ZN6poppet6engine10integrator6_errorB3v16B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE: %retptr"}
!19 = distinct !{!19, !"_ZN6poppet6engine10integrator6_errorB3v16B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE"}
!20 = !{!21, !23, !8, !1}
!21 = distinct !{!21, !22, !"_ZN6poppet6engine10integrator12_interpolateB3v18B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!22 = distinct !{!22, !"_ZN6poppet6engine10integrator12_interpolateB3v18B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!23 = distinct !{!23, !24, !"_ZN6poppet6engine10integrator12_stop_insideB3v17B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!24 = distinct !{!24, !"_ZN6poppet6engine10integrator12_stop_insideB3v17B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE"}
!25 = !{!26, !23, !8, !1}
!26 = distinct !{!26, !27, !"_ZN6poppet6engine10integrator12_interpolateB3v18B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!27 = distinct !{!27, !"_ZN6poppet6engine10integrator12_interpolateB3v18B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!28 = !{!29, !23, !8, !1}
!29 = distinct !{!29, !30, !"_ZN6poppet6engine10integrator10_inputs_atB2v8B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!30 = distinct !{!30, !"_ZN6poppet6engine10integrator10_inputs_atB2v8B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!31 = !{!32, !23, !8, !1}
!32 = distinct !{!32, !33, !"_ZN6poppet6engine10integrator15_stop_conditionB2v9B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!33 = distinct !{!33, !"_ZN6poppet6engine10integrator15_stop_conditionB2v9B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE"}
!34 = !{!35, !8, !1}
!35 = distinct !{!35, !36, !"_ZN6poppet6engine10integrator12_interpolateB3v18B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!36 = distinct !{!36, !"_ZN6poppet6engine10integrator12_interpolateB3v18B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!37 = !{!38, !8, !1}
!38 = distinct !{!38, !39, !"_ZN6poppet6engine10integrator7_variesB3v11B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!39 = distinct !{!39, !"_ZN6poppet6engine10integrator7_variesB3v11B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi2E1C7mutable7alignedE"}
!40 = !{!41, !8, !1}
!41 = distinct !{!41, !42, !"_ZN6poppet6engine10integrator10_inputs_atB2v8B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!42 = distinct !{!42, !"_ZN6poppet6engine10integrator10_inputs_atB2v8B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!43 = !{!44, !8, !1}
!44 = distinct !{!44, !45, !"_ZN6poppet6engine10integrator16_input_slopes_atB3v12B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!45 = distinct !{!45, !"_ZN6poppet6engine10integrator16_input_slopes_atB3v12B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!46 = !{!47, !8, !1}
!47 = distinct !{!47, !48, !"_ZN6poppet6engine10integrator10_inputs_atB2v8B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!48 = distinct !{!48, !"_ZN6poppet6engine10integrator10_inputs_atB2v8B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!49 = !{!50, !8, !1}
!50 = distinct !{!50, !51, !"_ZN6poppet6engine10integrator10_inputs_atB2v8B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!51 = distinct !{!51, !"_ZN6poppet6engine10integrator10_inputs_atB2v8B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!52 = !{!53, !8, !1}
!53 = distinct !{!53, !54, !"_ZN6poppet6engine10integrator6_writeB3v19B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedEx: %retptr"}
!54 = distinct !{!54, !"_ZN6poppet6engine10integrator6_writeB3v19B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedEx"}
!55 = distinct !{!55, !56}
!56 = !{!"llvm.loop.unroll.disable"}
!57 = !{!58, !1}
!58 = distinct !{!58, !59, !"_ZN6poppet6engine10integrator20_rows_without_statesB3v21B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE: %retptr"}
!59 = distinct !{!59, !"_ZN6poppet6engine10integrator20_rows_without_statesB3v21B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE"}
!60 = !{!61, !58, !1}
!61 = distinct !{!61, !62, !"_ZN6poppet6engine10integrator10_inputs_atB2v8B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!62 = distinct !{!62, !"_ZN6poppet6engine10integrator10_inputs_atB2v8B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!63 = !{!64, !58, !1}
!64 = distinct !{!64, !65, !"_ZN6poppet6engine10integrator6_writeB3v19B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedEx: %retptr"}
!65 = distinct !{!65, !"_ZN6poppet6engine10integrator6_writeB3v19B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedEx"}
!66 = distinct !{!66, !56}
!67 = !{!68, !1}
!68 = distinct !{!68, !69, !"_ZN6poppet6engine10integrator10_inputs_atB2v8B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!69 = distinct !{!69, !"_ZN6poppet6engine10integrator10_inputs_atB2v8B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!70 = !{!71, !1}
!71 = distinct !{!71, !72, !"_ZN6poppet6engine10integrator15_stop_conditionB2v9B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!72 = distinct !{!72, !"_ZN6poppet6engine10integrator15_stop_conditionB2v9B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE"}
!73 = !{!74, !1}
!74 = distinct !{!74, !75, !"_ZN6poppet6engine10integrator6_writeB3v19B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedEx: %retptr"}
!75 = distinct !{!75, !"_ZN6poppet6engine10integrator6_writeB3v19B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedEx"}
!76 = distinct !{!76, !56}
