; made from integrator.py, sha256 1629fd0941dedc176dbc40cbac8061fc7da0e1721248e33b1be29a5a1b92e223
@v21 = private unnamed_addr constant [4 x double] [double 3.860000e-01, double 2.100000e-01, double 6.300000e-01, double 1.000000e+00], align 8
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
  br i1 %55, label %B1352.i, label %B1516.i
B1352.i:
  %.40.i.i = fsub double %.3647.i, %.3647.i
  br i1 %56, label %B1352.endif.i, label %B56.preheader.i.i
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
  br i1 %57, label %B1554.i, label %B1656.i
B1554.i:
  %.4215.i = mul i64 %.357625792586.i, %.986.i
  %.4217.i = getelementptr double, ptr %a5, i64 %.4215.i
  %.395.i.i = load i64, ptr %sunkaddr432.i, align 8, !noalias !7
  br i1 %72, label %B0.endif.else.endif.endif.endif.i.i, label %B0.endif.else.endif.if.i.i, !prof !10
B446.i.i:
  %.2250.i.i = fcmp olt double %.3647.i, %"$phi1338.1.2.1.i"
  br i1 %.2250.i.i, label %B460.preheader.i.i, label %_ZN6poppet6engine10integrator8_segmentB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i
B460.preheader.i.i:
  %invariant.gep.i.i.i.i = getelementptr double, ptr %.1371.i.i, i64 %.1039.i.i
  %5 = icmp slt i64 %.1030.i.i, 1
  %6 = inttoptr i64 %.395.i.i to ptr
  %invariant.gep.i.i14.i.i = getelementptr double, ptr %.1371.i.i, i64 %.695.i.i
  %7 = icmp slt i64 %.686.i.i, 1
  br label %B460.i.i
B460.i.i:
  %t.2.0.i.i = phi double [ %t.3.1.i.i, %B2014.else.if.i.i ], [ %.3647.i, %B460.preheader.i.i ]
  %h.5.0.i.i = phi double [ %h.6.1.i.i, %B2014.else.if.i.i ], [ %"$phi1540.1.2.1.i", %B460.preheader.i.i ]
  %error_before.2.0.i.i = phi double [ %error_before.3.1.i.i, %B2014.else.if.i.i ], [ 1.000000e-02, %B460.preheader.i.i ]
  %step_before.2.0.i.i = phi double [ %step_before.3.1.i.i, %B2014.else.if.i.i ], [ 0.000000e+00, %B460.preheader.i.i ]
  %rejected.3.0.i.i = phi i1 [ %rejected.4.1.i.i, %B2014.else.if.i.i ], [ false, %B460.preheader.i.i ]
  %fresh.3.0.i.i = phi i1 [ %.3361263.i.i, %B2014.else.if.i.i ], [ true, %B460.preheader.i.i ]
  %window.2.0.i.i = phi double [ %window.3.1.i.i, %B2014.else.if.i.i ], [ %.3647.i, %B460.preheader.i.i ]
  br i1 %fresh.3.0.i.i, label %B464.i.i, label %B722.endif.endif.i.i
B464.i.i:
  store double %t.2.0.i.i, ptr %.2042.i, align 8, !noalias !7
  %.40.i.i.i = fsub double %t.2.0.i.i, %.3647.i
  br i1 %56, label %B464.endif.i.i, label %B56.i.i.i
B56.i.i.i:
  %lsr.iv.i.i.i = phi ptr [ %scevgep1.i.i.i, %B316.i.i.i ], [ %scevgep.i158.i.i, %B464.i.i ]
  %.138222224.i.i.i = phi i64 [ %.145.i.i.i, %B316.i.i.i ], [ 0, %B464.i.i ]
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
  %8 = shl i64 %.138222224.i.i.i, 3
  %scevgep7.i.i.i = getelementptr i8, ptr %.1528.i, i64 %8
  store double %value.2.1.i.i.i, ptr %scevgep7.i.i.i, align 8, !noalias !11
  %scevgep1.i.i.i = getelementptr i8, ptr %lsr.iv.i.i.i, i64 48
  %exitcond.not.i.i.i = icmp eq i64 %.1503.i, %.145.i.i.i
  br i1 %exitcond.not.i.i.i, label %B464.endif.i.i, label %B56.i.i.i
B630.i.i:
  %.2481.i.i = fsub double %"$phi1338.1.2.1.i", %t.2.0.i.i
  %.56.i.i.i = fdiv double 2.000000e+01, %.2481.i.i
  br i1 %77, label %B630.endif.i.i, label %B66.backedge.i.i.i
B66.backedge.i.i.i:
  %fastest.2.0128.i.i.i = phi double [ %.13.i.i.i.i, %B66.backedge.i.i.i ], [ %.56.i.i.i, %B630.i.i ]
  %.162124126.i.i.i = phi i64 [ %.169.i.i.i, %B66.backedge.i.i.i ], [ 0, %B630.i.i ]
  %9 = shl i64 %.162124126.i.i.i, 3
  %scevgep3.i126.i.i = getelementptr i8, ptr %.1171.i, i64 %9
  %.223.i.i.i = load double, ptr %scevgep3.i126.i.i, align 8, !noalias !14
  %.224.i.i.i = tail call double @llvm.fabs.f64(double %.223.i.i.i)
  %.225.i.i.i = fmul double %.224.i.i.i, 2.000000e+01
  %scevgep2.i127.i.i = getelementptr i8, ptr %a2, i64 %9
  %.255.i.i.i = load double, ptr %scevgep2.i127.i.i, align 8, !noalias !14
  %.256.i.i.i = tail call double @llvm.fabs.f64(double %.255.i.i.i)
  %scevgep155.i.i = getelementptr i8, ptr %74, i64 %9
  %.310.i.i.i = load double, ptr %scevgep155.i.i, align 8, !noalias !14
  %.311.i.i.i = fadd double %.256.i.i.i, %.310.i.i.i
  %.315.i.i.i = fdiv double %.225.i.i.i, %.311.i.i.i
  %.12.i.i.i.i = fcmp ogt double %.315.i.i.i, %fastest.2.0128.i.i.i
  %.13.i.i.i.i = select i1 %.12.i.i.i.i, double %.315.i.i.i, double %fastest.2.0128.i.i.i
  %.169.i.i.i = add nuw nsw i64 %.162124126.i.i.i, 1
  %exitcond.not.i129.i.i = icmp eq i64 %.25.i, %.169.i.i.i
  br i1 %exitcond.not.i129.i.i, label %B630.endif.i.i, label %B66.backedge.i.i.i
B684.i.i:
  %.2524.i.i = fneg double %h.5.0.i.i
  %.12.i.i.i = fcmp olt double %.373.i.i.i, %.2524.i.i
  %.13.i.i.i = select i1 %.12.i.i.i, double %.373.i.i.i, double %.2524.i.i
  br label %B722.endif.endif.i.i
B952.i.i:
  %.3071.i.i = fcmp oge double %storemerge.i213.i.i, %.2652.i.i
  %.3080.i.i = fadd double %t.2.0.i.i, %storemerge.i213.i.i
  %"$phi982.0.2.1.i.i" = select i1 %.3071.i.i, double %"$phi1338.1.2.1.i", double %.3080.i.i
  store double %t.2.0.i.i, ptr %.2042.i, align 8, !noalias !7
  store double %storemerge.i213.i.i, ptr %sunkaddr160.i.i, align 8, !noalias !7
  %.3181.i.i = load i64, ptr %sunkaddr.i2.i, align 8, !noalias !7
  %.3252.i.i = inttoptr i64 %.3181.i.i to ptr
  tail call void %.3252.i.i(ptr nonnull %.2042.i, ptr %a2, ptr %.1699.i, ptr %a3, ptr %.1171.i, ptr %.2524.i, ptr %.711.i.i, ptr %.2892.i, ptr %.1542.i.i, ptr %.883.i.i), !noalias !7
  br i1 %77, label %B982.endif.thread265.i.i, label %B62.i.i.i
B982.endif.thread265.i.i:
  %.3328267.i.i = load i64, ptr %sunkaddr174.i.i, align 8, !noalias !7
  %.3329268.i.i = add nsw i64 %.3328267.i.i, 1
  store i64 %.3329268.i.i, ptr %sunkaddr174.i.i, align 8, !noalias !7
  br label %B1162.i.i
B62.i.i.i:
  %worst.2.0263.i.i.i = phi double [ %worst.3.1.i.i.i, %B176.endif.i.i.i ], [ 0.000000e+00, %B952.i.i ]
  %.185258261.i.i.i = phi i64 [ %.192.i.i.i, %B176.endif.i.i.i ], [ 0, %B952.i.i ]
  %.192.i.i.i = add nuw nsw i64 %.185258261.i.i.i, 1
  %10 = shl i64 %.185258261.i.i.i, 3
  %scevgep5.i132.i.i = getelementptr i8, ptr %.883.i.i, i64 %10
  %.250.i.i.i = load double, ptr %scevgep5.i132.i.i, align 8, !noalias !17
  %.262.le.i.i.i = fsub double %.250.i.i.i, %.250.i.i.i
  %.263.le.i.i.i = fcmp ord double %.262.le.i.i.i, 0.000000e+00
  br i1 %.263.le.i.i.i, label %B120.i.i.i, label %B982.endif.thread.i.i
B120.i.i.i:
  %11 = getelementptr i8, ptr %a9, i64 %.185258261.i.i.i
  %.308.i.i.i = load i8, ptr %11, align 1, !noalias !17
  %.309.i.i.i = icmp ne i8 %.308.i.i.i, 0
  %.312.i.i.i = fcmp ole double %.250.i.i.i, 0.000000e+00
  %or.cond.i.i.i = and i1 %.312.i.i.i, %.309.i.i.i
  br i1 %or.cond.i.i.i, label %B982.endif.thread.i.i, label %B176.endif.i.i.i
B176.endif.i.i.i:
  %scevgep159.i.i = getelementptr i8, ptr %.1713.i.i, i64 %10
  %.385.i.i.i = load double, ptr %scevgep159.i.i, align 8, !noalias !17
  %scevgep158.i.i = getelementptr i8, ptr %scevgep157.i.i, i64 %10
  %.441.i.i.i = load double, ptr %scevgep158.i.i, align 8, !noalias !17
  %scevgep156.i.i = getelementptr i8, ptr %a8, i64 %10
  %.496.i.i.i = load double, ptr %scevgep156.i.i, align 8, !noalias !17
  %scevgep.i3.i = getelementptr i8, ptr %a2, i64 %10
  %.527.i.i.i = load double, ptr %scevgep.i3.i, align 8, !noalias !17
  %.530.i.i.i = tail call double @llvm.fabs.f64(double %.527.i.i.i)
  %.532.i.i.i = tail call double @llvm.fabs.f64(double %.250.i.i.i)
  %.12.i.i137.i.i = fcmp ogt double %.532.i.i.i, %.530.i.i.i
  %.13.i.i138.i.i = select i1 %.12.i.i137.i.i, double %.532.i.i.i, double %.530.i.i.i
  %.386.i.i.i = tail call double @llvm.fabs.f64(double %.385.i.i.i)
  %.563.i.i.i = fmul double %.496.i.i.i, %.13.i.i138.i.i
  %.564.i.i.i = fadd double %.441.i.i.i, %.563.i.i.i
  %.568.i.i.i = fdiv double %.386.i.i.i, %.564.i.i.i
  %.574.i.i.i = fcmp ole double %.568.i.i.i, %worst.2.0263.i.i.i
  %worst.3.1.i.i.i = select i1 %.574.i.i.i, double %worst.2.0263.i.i.i, double %.568.i.i.i
  %exitcond.not.i139.i.i = icmp eq i64 %.25.i, %.192.i.i.i
  br i1 %exitcond.not.i139.i.i, label %B982.endif.i.i, label %B62.i.i.i
B1162.i.i:
  %storemerge.i270.i.i = phi double [ 0.000000e+00, %B982.endif.thread265.i.i ], [ %worst.3.1.i.i.i, %B982.endif.i.i ]
  br i1 %55, label %B1262.i.i, label %B1166.i.i
B1166.i.i:
  %.3396.i.i = load i64, ptr %.179.i.i, align 8, !noalias !7
  %.3410.i.i = icmp slt i64 %.3396.i.i, 0
  %.3411.i.i = select i1 %.3410.i.i, i64 %.69.i, i64 0
  %12 = getelementptr double, ptr %a7, i64 %.3396.i.i
  %.3425.i.i = getelementptr double, ptr %12, i64 %.3411.i.i
  %.3426.i.i = load double, ptr %.3425.i.i, align 8, !noalias !7
  %.3428.i.i = fcmp olt double %.3426.i.i, %"$phi982.0.2.1.i.i"
  br i1 %.3428.i.i, label %B1258.i.i, label %B1370.i.i
B1258.i.i:
  %.3459.i.i = load i64, ptr %sunkaddr163.i.i, align 8, !noalias !7
  %.3474.i.i = inttoptr i64 %.3459.i.i to ptr
  tail call void %.3474.i.i(ptr %.1542.i.i, ptr %.1371.i.i), !noalias !7
  br label %B1370.i.i
B1262.i.i:
  %.34592560.i.i = load i64, ptr %sunkaddr163.i.i, align 8, !noalias !7
  %.34742561.i.i = inttoptr i64 %.34592560.i.i to ptr
  tail call void %.34742561.i.i(ptr %.1542.i.i, ptr %.1371.i.i), !noalias !7
  %.556.i.i.i = fmul double %.3080.i.i, 4.000000e-16
  br label %B18.outer.i.i.i
B18.outer.i.i.i:
  %low.4.1.ph.i.i.i = phi double [ 0.000000e+00, %B1262.i.i ], [ %low.3.2.i.i.i, %B240.i.i.i ]
  %high.3.1.ph.i.i.i = phi double [ 5.000000e-01, %B1262.i.i ], [ %.544.i.i.i, %B240.i.i.i ]
  %event.2.1.ph.i.i.i = phi i64 [ -1, %B1262.i.i ], [ %event.4.2.i.i.i, %B240.i.i.i ]
  %theta.2.1.ph.i.i.i = phi double [ 0.000000e+00, %B1262.i.i ], [ %theta.1.2.i.i.i, %B240.i.i.i ]
  br label %B18.i.i.i
B18.i.i.i:
  %low.4.1.i.i.i = phi double [ 5.000000e-01, %B186.i.i.i ], [ %low.4.1.ph.i.i.i, %B18.outer.i.i.i ]
  %high.3.1.i.i.i = phi double [ 1.000000e+00, %B186.i.i.i ], [ %high.3.1.ph.i.i.i, %B18.outer.i.i.i ]
  %event.2.1.i.i.i = phi i64 [ -1, %B186.i.i.i ], [ %event.2.1.ph.i.i.i, %B18.outer.i.i.i ]
  %.64.i.i.i.i = fsub double 1.000000e+00, %high.3.1.i.i.i
  br i1 %5, label %B18.endif.i.i.i, label %B60.i.i.i.i
B60.i.i.i.i:
  %.166146148.i.i.i.i = phi i64 [ %.173.i.i.i.i, %B60.i.i.i.i ], [ 0, %B18.i.i.i ]
  %.173.i.i.i.i = add nuw nsw i64 %.166146148.i.i.i.i, 1
  %13 = shl i64 %.166146148.i.i.i.i, 3
  %scevgep4.i.i.i.i = getelementptr i8, ptr %a2, i64 %13
  %.227.i.i.i.i = load double, ptr %scevgep4.i.i.i.i, align 8, !noalias !20
  %.229.i.i.i.i = fmul double %.64.i.i.i.i, %.227.i.i.i.i
  %scevgep3.i.i.i.i = getelementptr i8, ptr %.883.i.i, i64 %13
  %.259.i.i.i.i = load double, ptr %scevgep3.i.i.i.i, align 8, !noalias !20
  %scevgep65.i.i.i = getelementptr i8, ptr %.1371.i.i, i64 %13
  %.289.i.i.i.i = load double, ptr %scevgep65.i.i.i, align 8, !noalias !20
  %scevgep64.i.i.i = getelementptr i8, ptr %invariant.gep.i.i.i.i, i64 %13
  %.321.i.i.i.i = load double, ptr %scevgep64.i.i.i, align 8, !noalias !20
  %.323.i.i.i.i = fmul double %high.3.1.i.i.i, %.321.i.i.i.i
  %.324.i.i.i.i = fadd double %.289.i.i.i.i, %.323.i.i.i.i
  %.326.i.i.i.i = fmul double %.64.i.i.i.i, %.324.i.i.i.i
  %.327.i.i.i.i = fadd double %.259.i.i.i.i, %.326.i.i.i.i
  %.329.i.i.i.i = fmul double %high.3.1.i.i.i, %.327.i.i.i.i
  %.330.i.i.i.i = fadd double %.229.i.i.i.i, %.329.i.i.i.i
  %scevgep63.i.i.i = getelementptr i8, ptr %.1055.i.i, i64 %13
  store double %.330.i.i.i.i, ptr %scevgep63.i.i.i, align 8, !noalias !20
  %exitcond.not.i.i.i.i = icmp eq i64 %.1030.i.i, %.173.i.i.i.i
  br i1 %exitcond.not.i.i.i.i, label %B18.endif.i.i.i, label %B60.i.i.i.i
B186.i.i.i:
  %.381.i.i.i = fcmp oeq double %high.3.1.i.i.i, 1.000000e+00
  br i1 %.381.i.i.i, label %_ZN6poppet6engine10integrator12_stop_insideB3v18B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE.exit.i.i, label %B18.i.i.i
B240.i.i.i:
  %low.3.2.i.i.i = phi double [ %low.4.1.i.i.i, %B252.1.i.i.i.i ], [ %high.3.1.i.i.i, %B18.endif.endif.endif.thread13.i.i.i ]
  %theta.1.2.i.i.i = phi double [ %high.3.1.i.i.i, %B252.1.i.i.i.i ], [ %theta.2.1.ph.i.i.i, %B18.endif.endif.endif.thread13.i.i.i ]
  %event.4.2.i.i.i = phi i64 [ %.284326331.i.i.i.i, %B252.1.i.i.i.i ], [ %event.2.1.i.i.i, %B18.endif.endif.endif.thread13.i.i.i ]
  %.543.i.i.i = fadd double %low.3.2.i.i.i, %theta.1.2.i.i.i
  %.544.i.i.i = fmul double %.543.i.i.i, 5.000000e-01
  %.550.i.i.i = fsub double %theta.1.2.i.i.i, %low.3.2.i.i.i
  %.552.i.i.i = fmul double %storemerge.i213.i.i, %.550.i.i.i
  %.557.i.i.i = fcmp ole double %.552.i.i.i, %.556.i.i.i
  %.561.i.i.i = fcmp ole double %.544.i.i.i, %low.3.2.i.i.i
  %or.cond.i2.i.i = or i1 %.557.i.i.i, %.561.i.i.i
  %.565.i.i.i = fcmp oge double %.544.i.i.i, %theta.1.2.i.i.i
  %or.cond319.i.i.i = or i1 %.565.i.i.i, %or.cond.i2.i.i
  br i1 %or.cond319.i.i.i, label %B316.i3.i.i, label %B18.outer.i.i.i
B316.i3.i.i:
  %.64.i18.i.i.i = fsub double 1.000000e+00, %theta.1.2.i.i.i
  br i1 %5, label %_ZN6poppet6engine10integrator12_stop_insideB3v18B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE.exit.i.i, label %B60.i22.i.i.i
B60.i22.i.i.i:
  %.166146148.i23.i.i.i = phi i64 [ %.173.i24.i.i.i, %B60.i22.i.i.i ], [ 0, %B316.i3.i.i ]
  %.173.i24.i.i.i = add nuw nsw i64 %.166146148.i23.i.i.i, 1
  %14 = shl i64 %.166146148.i23.i.i.i, 3
  %scevgep4.i25.i.i.i = getelementptr i8, ptr %a2, i64 %14
  %.227.i26.i.i.i = load double, ptr %scevgep4.i25.i.i.i, align 8, !noalias !25
  %.229.i27.i.i.i = fmul double %.64.i18.i.i.i, %.227.i26.i.i.i
  %scevgep3.i28.i.i.i = getelementptr i8, ptr %.883.i.i, i64 %14
  %.259.i29.i.i.i = load double, ptr %scevgep3.i28.i.i.i, align 8, !noalias !25
  %scevgep62.i.i.i = getelementptr i8, ptr %.1371.i.i, i64 %14
  %.289.i31.i.i.i = load double, ptr %scevgep62.i.i.i, align 8, !noalias !25
  %scevgep61.i.i.i = getelementptr i8, ptr %invariant.gep.i.i.i.i, i64 %14
  %.321.i33.i.i.i = load double, ptr %scevgep61.i.i.i, align 8, !noalias !25
  %.323.i34.i.i.i = fmul double %theta.1.2.i.i.i, %.321.i33.i.i.i
  %.324.i35.i.i.i = fadd double %.289.i31.i.i.i, %.323.i34.i.i.i
  %.326.i36.i.i.i = fmul double %.64.i18.i.i.i, %.324.i35.i.i.i
  %.327.i37.i.i.i = fadd double %.259.i29.i.i.i, %.326.i36.i.i.i
  %.329.i38.i.i.i = fmul double %theta.1.2.i.i.i, %.327.i37.i.i.i
  %.330.i39.i.i.i = fadd double %.229.i27.i.i.i, %.329.i38.i.i.i
  %scevgep60.i.i.i = getelementptr i8, ptr %.1055.i.i, i64 %14
  store double %.330.i39.i.i.i, ptr %scevgep60.i.i.i, align 8, !noalias !25
  %exitcond.not.i41.i.i.i = icmp eq i64 %.1030.i.i, %.173.i24.i.i.i
  br i1 %exitcond.not.i41.i.i.i, label %_ZN6poppet6engine10integrator12_stop_insideB3v18B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE.exit.i.i, label %B60.i22.i.i.i
B18.endif.i.i.i:
  %.275.i1.i.i = fmul double %storemerge.i213.i.i, %high.3.1.i.i.i
  %.277.i.i.i = fadd double %t.2.0.i.i, %.275.i1.i.i
  %.40.i.i.i.i = fsub double %.277.i.i.i, %.3647.i
  br i1 %56, label %B18.endif.endif.i.i.i, label %B56.i.i.i.i
B56.i.i.i.i:
  %lsr.iv.i.i.i.i = phi ptr [ %scevgep1.i46.i.i.i, %B316.i.i.i.i ], [ %scevgep.i158.i.i, %B18.endif.i.i.i ]
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
  %15 = shl i64 %.138222224.i.i.i.i, 3
  %scevgep7.i.i.i.i = getelementptr i8, ptr %.1528.i, i64 %15
  store double %value.2.1.i.i.i.i, ptr %scevgep7.i.i.i.i, align 8, !noalias !28
  %scevgep1.i46.i.i.i = getelementptr i8, ptr %lsr.iv.i.i.i.i, i64 48
  %exitcond.not.i47.i.i.i = icmp eq i64 %.1503.i, %.145.i.i.i.i
  br i1 %exitcond.not.i47.i.i.i, label %B18.endif.endif.i.i.i, label %B56.i.i.i.i
B18.endif.endif.i.i.i:
  store double %.277.i.i.i, ptr %.2042.i, align 8, !noalias !31
  tail call void %6(ptr nonnull %.2042.i, ptr %.1055.i.i, ptr %.1528.i, ptr %a3, ptr %.3062.i), !noalias !31
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
_ZN6poppet6engine10integrator12_stop_insideB3v18B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE.exit.i.i:
  %event.4.2.lcssa.sink.i.i.i = phi i64 [ -1, %B186.i.i.i ], [ %event.4.2.i.i.i, %B316.i3.i.i ], [ %event.4.2.i.i.i, %B60.i22.i.i.i ]
  %theta.1.2.lcssa.sink.i.i.i = phi double [ 1.000000e+00, %B186.i.i.i ], [ %theta.1.2.i.i.i, %B316.i3.i.i ], [ %theta.1.2.i.i.i, %B60.i22.i.i.i ]
  %.3569.i.i = fmul double %storemerge.i213.i.i, %theta.1.2.lcssa.sink.i.i.i
  %.3573.i.i = fadd double %t.2.0.i.i, %.3569.i.i
  %.35602580.i.i = icmp slt i64 %event.4.2.lcssa.sink.i.i.i, 0
  %"$phi1358.1.2.2.i.i" = select i1 %.35602580.i.i, double %"$phi982.0.2.1.i.i", double %.3573.i.i
  store i64 %event.4.2.lcssa.sink.i.i.i, ptr %.3421.i, align 8, !noalias !7
  br label %B1370.i.i
B1370.i.i:
  %end.2.1.i.i = phi double [ %"$phi1358.1.2.2.i.i", %_ZN6poppet6engine10integrator12_stop_insideB3v18B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE.exit.i.i ], [ %"$phi982.0.2.1.i.i", %B1258.i.i ], [ %"$phi982.0.2.1.i.i", %B1166.i.i ]
  %.256.i5.i.i = load i64, ptr %.179.i.i, align 8, !noalias !34
  %.264.i.i.i = icmp slt i64 %.256.i5.i.i, %.69.i
  br i1 %.264.i.i.i, label %B38.i.i.i, label %B494.endif.endif.i.i.i.preheader
B38.i.i.i:
  %.309.i12.i.i = icmp slt i64 %.256.i5.i.i, 0
  %.310.i13.i.i = select i1 %.309.i12.i.i, i64 %.69.i, i64 0
  %16 = getelementptr double, ptr %a7, i64 %.256.i5.i.i
  %.324.i.i.i = getelementptr double, ptr %16, i64 %.310.i13.i.i
  %.325.i.i.i = load double, ptr %.324.i.i.i, align 8, !noalias !34
  %.327.i.i.i = fcmp olt double %.325.i.i.i, %end.2.1.i.i
  br i1 %.327.i.i.i, label %B74.i.i.i, label %B494.endif.endif.i.i.i.preheader
B74.i.i.i:
  %.362.i.i.i = phi i64 [ %.698.i.i.i, %B356.i.i.i ], [ %.256.i5.i.i, %B38.i.i.i ]
  %.376.i.i.i = icmp slt i64 %.362.i.i.i, 0
  %.377.i.i.i = select i1 %.376.i.i.i, i64 %.69.i, i64 0
  %17 = getelementptr double, ptr %a7, i64 %.362.i.i.i
  %.391.i.i.i = getelementptr double, ptr %17, i64 %.377.i.i.i
  %.392.i.i.i = load double, ptr %.391.i.i.i, align 8, !noalias !34
  %.394.i.i.i = fsub double %.392.i.i.i, %t.2.0.i.i
  %.399.i.i.i = fdiv double %.394.i.i.i, %storemerge.i213.i.i
  %.64.i.i15.i.i = fsub double 1.000000e+00, %.399.i.i.i
  br i1 %7, label %B74.endif.endif.i.i.i, label %B60.i.i16.i.i
B60.i.i16.i.i:
  %.166146148.i.i17.i.i = phi i64 [ %.173.i.i18.i.i, %B60.i.i16.i.i ], [ 0, %B74.i.i.i ]
  %.173.i.i18.i.i = add nuw nsw i64 %.166146148.i.i17.i.i, 1
  %18 = shl i64 %.166146148.i.i17.i.i, 3
  %scevgep4.i.i19.i.i = getelementptr i8, ptr %a2, i64 %18
  %.227.i.i20.i.i = load double, ptr %scevgep4.i.i19.i.i, align 8, !noalias !37
  %.229.i.i21.i.i = fmul double %.64.i.i15.i.i, %.227.i.i20.i.i
  %scevgep3.i.i22.i.i = getelementptr i8, ptr %.883.i.i, i64 %18
  %.259.i.i23.i.i = load double, ptr %scevgep3.i.i22.i.i, align 8, !noalias !37
  %scevgep9.i.i.i = getelementptr i8, ptr %.1371.i.i, i64 %18
  %.289.i.i24.i.i = load double, ptr %scevgep9.i.i.i, align 8, !noalias !37
  %scevgep8.i.i.i = getelementptr i8, ptr %invariant.gep.i.i14.i.i, i64 %18
  %.321.i.i25.i.i = load double, ptr %scevgep8.i.i.i, align 8, !noalias !37
  %.323.i.i26.i.i = fmul double %.399.i.i.i, %.321.i.i25.i.i
  %.324.i.i27.i.i = fadd double %.289.i.i24.i.i, %.323.i.i26.i.i
  %.326.i.i28.i.i = fmul double %.64.i.i15.i.i, %.324.i.i27.i.i
  %.327.i.i29.i.i = fadd double %.259.i.i23.i.i, %.326.i.i28.i.i
  %.329.i.i30.i.i = fmul double %.399.i.i.i, %.327.i.i29.i.i
  %.330.i.i31.i.i = fadd double %.229.i.i21.i.i, %.329.i.i30.i.i
  %scevgep7.i32.i.i = getelementptr i8, ptr %.711.i.i, i64 %18
  store double %.330.i.i31.i.i, ptr %scevgep7.i32.i.i, align 8, !noalias !37
  %exitcond.not.i.i33.i.i = icmp eq i64 %.686.i.i, %.173.i.i18.i.i
  br i1 %exitcond.not.i.i33.i.i, label %B74.endif.endif.loopexit.i.i.i, label %B60.i.i16.i.i
B356.i.i.i:
  %.811.i.i.i = icmp slt i64 %.697.i.i.i, -1
  %.812.i.i.i = select i1 %.811.i.i.i, i64 %.69.i, i64 0
  %19 = getelementptr double, ptr %a7, i64 %.698.i.i.i
  %.826.i.i.i = getelementptr double, ptr %19, i64 %.812.i.i.i
  %.827.i.i.i = load double, ptr %.826.i.i.i, align 8, !noalias !34
  %.829.i.i.i = fcmp olt double %.827.i.i.i, %end.2.1.i.i
  br i1 %.829.i.i.i, label %B74.i.i.i, label %B494.endif.endif.i.i.i.preheader
B74.endif.endif.loopexit.i.i.i:
  %.468.pre.i.i.i = load i64, ptr %.179.i.i, align 8, !noalias !34
  br label %B74.endif.endif.i.i.i
B74.endif.endif.i.i.i:
  %.468.i.i.i = phi i64 [ %.468.pre.i.i.i, %B74.endif.endif.loopexit.i.i.i ], [ %.362.i.i.i, %B74.i.i.i ]
  %.482.i.i.i = icmp slt i64 %.468.i.i.i, 0
  %.483.i.i.i = select i1 %.482.i.i.i, i64 %.69.i, i64 0
  %20 = getelementptr double, ptr %a7, i64 %.468.i.i.i
  %.497.i.i.i = getelementptr double, ptr %20, i64 %.483.i.i.i
  %.498.i.i.i = load double, ptr %.497.i.i.i, align 8, !noalias !34
  %.40.i.i34.i.i = fsub double %.498.i.i.i, %.3647.i
  br i1 %56, label %B74.endif.endif.endif.i.i.i, label %B56.i.i35.i.i
B56.i.i35.i.i:
  %lsr.iv.i.i36.i.i = phi ptr [ %scevgep1.i13.i.i.i, %B316.i.i46.i.i ], [ %scevgep.i158.i.i, %B74.endif.endif.i.i.i ]
  %.138222224.i.i37.i.i = phi i64 [ %.145.i.i38.i.i, %B316.i.i46.i.i ], [ 0, %B74.endif.endif.i.i.i ]
  %.145.i.i38.i.i = add nuw nsw i64 %.138222224.i.i37.i.i, 1
  %scevgep6.i.i39.i.i = getelementptr i8, ptr %lsr.iv.i.i36.i.i, i64 -40
  %.227.i11.i.i.i = load double, ptr %scevgep6.i.i39.i.i, align 8, !noalias !40
  %scevgep5.i.i40.i.i = getelementptr i8, ptr %lsr.iv.i.i36.i.i, i64 -32
  %.282.i.i41.i.i = load double, ptr %scevgep5.i.i40.i.i, align 8, !noalias !40
  %.284.i.i42.i.i = fmul double %.40.i.i34.i.i, %.282.i.i41.i.i
  %.285.i.i43.i.i = fadd double %.227.i11.i.i.i, %.284.i.i42.i.i
  %scevgep4.i12.i.i.i = getelementptr i8, ptr %lsr.iv.i.i36.i.i, i64 -24
  %.347.i.i44.i.i = load double, ptr %scevgep4.i12.i.i.i, align 8, !noalias !40
  %.348.i.i45.i.i = fcmp une double %.347.i.i44.i.i, 0.000000e+00
  br i1 %.348.i.i45.i.i, label %B134.i.i52.i.i, label %B316.i.i46.i.i
B134.i.i52.i.i:
  %scevgep3.i15.i.i.i = getelementptr i8, ptr %lsr.iv.i.i36.i.i, i64 -16
  %.405.i.i53.i.i = load double, ptr %scevgep3.i15.i.i.i, align 8, !noalias !40
  %scevgep2.i16.i.i.i = getelementptr i8, ptr %lsr.iv.i.i36.i.i, i64 -8
  %.460.i.i54.i.i = load double, ptr %scevgep2.i16.i.i.i, align 8, !noalias !40
  %.461.i.i55.i.i = fmul double %.460.i.i54.i.i, 5.000000e-01
  %.463.i.i56.i.i = fmul double %.40.i.i34.i.i, %.461.i.i55.i.i
  %.464.i.i57.i.i = fadd double %.405.i.i53.i.i, %.463.i.i56.i.i
  %.465.i.i58.i.i = fmul double %.464.i.i57.i.i, 0x401921FB54442D18
  %.467.i.i59.i.i = fmul double %.40.i.i34.i.i, %.465.i.i58.i.i
  %.522.i.i60.i.i = load double, ptr %lsr.iv.i.i36.i.i, align 8, !noalias !40
  %.523.i.i61.i.i = fadd double %.522.i.i60.i.i, %.467.i.i59.i.i
  %.586.le.i.i62.i.i = tail call double @llvm.sin.f64(double %.523.i.i61.i.i)
  %.591.i.i63.i.i = fmul double %.347.i.i44.i.i, %.586.le.i.i62.i.i
  %.593.i.i64.i.i = fadd double %.285.i.i43.i.i, %.591.i.i63.i.i
  br label %B316.i.i46.i.i
B316.i.i46.i.i:
  %value.2.1.i.i47.i.i = phi double [ %.593.i.i64.i.i, %B134.i.i52.i.i ], [ %.285.i.i43.i.i, %B56.i.i35.i.i ]
  %21 = shl i64 %.138222224.i.i37.i.i, 3
  %scevgep7.i.i48.i.i = getelementptr i8, ptr %.1528.i, i64 %21
  store double %value.2.1.i.i47.i.i, ptr %scevgep7.i.i48.i.i, align 8, !noalias !40
  %scevgep1.i13.i.i.i = getelementptr i8, ptr %lsr.iv.i.i36.i.i, i64 48
  %exitcond.not.i14.i.i.i = icmp eq i64 %.1503.i, %.145.i.i38.i.i
  br i1 %exitcond.not.i14.i.i.i, label %B74.endif.endif.endif.loopexit.i.i.i, label %B56.i.i35.i.i
B74.endif.endif.endif.loopexit.i.i.i:
  %.562.pre.i.i.i = load i64, ptr %.179.i.i, align 8, !noalias !34
  br label %B74.endif.endif.endif.i.i.i
B74.endif.endif.endif.i.i.i:
  %.562.i.i.i = phi i64 [ %.562.pre.i.i.i, %B74.endif.endif.endif.loopexit.i.i.i ], [ %.468.i.i.i, %B74.endif.endif.i.i.i ]
  %.576.i.i.i = icmp slt i64 %.562.i.i.i, 0
  %.577.i.i.i = select i1 %.576.i.i.i, i64 %.69.i, i64 0
  %22 = getelementptr double, ptr %a7, i64 %.562.i.i.i
  %.591.i49.i.i = getelementptr double, ptr %22, i64 %.577.i.i.i
  %.592.i.i.i = load double, ptr %.591.i49.i.i, align 8, !noalias !34
  store double %.592.i.i.i, ptr %.2042.i, align 8, !noalias !43
  tail call void %6(ptr nonnull %.2042.i, ptr %.711.i.i, ptr %.1528.i, ptr %a3, ptr %.3062.i), !noalias !43
  br i1 %66, label %B74.endif.endif.endif.endif.i.i.i, label %B96.lr.ph.i.i.i.i
B96.lr.ph.i.i.i.i:
  br i1 %67, label %B96.epil.preheader.i.i.i.i, label %B96.lr.ph.new.i.i.i.i
B96.lr.ph.new.i.i.i.i:
  %invariant.gep.i17.i.i.i = getelementptr double, ptr %a13, i64 %.562.i.i.i
  %invariant.gep159.i.i.i.i = getelementptr double, ptr %invariant.gep.i17.i.i.i, i64 %.577.i.i.i
  br i1 %68, label %B96.i.epil.preheader.i.i.i, label %B96.i.i.i.i
B96.i.i.i.i:
  %lsr.iv.i50.i.i = phi i64 [ %lsr.iv.next.i51.i.i, %B96.i.i.i.i ], [ %78, %B96.lr.ph.new.i.i.i.i ]
  %lsr.iv13.i.i.i.i = phi ptr [ %scevgep57.i.i.i, %B96.i.i.i.i ], [ %invariant.gep159.i.i.i.i, %B96.lr.ph.new.i.i.i.i ]
  %.259154156.i.i.i.i = phi i64 [ %.266.3.i.1.i.i.i, %B96.i.i.i.i ], [ 0, %B96.lr.ph.new.i.i.i.i ]
  %sunkaddr26.i.i.i = shl i64 %.259154156.i.i.i.i, 3
  %sunkaddr27.i.i.i = getelementptr i8, ptr %.3062.i, i64 %sunkaddr26.i.i.i
  %.320.i.i.i.i = load double, ptr %sunkaddr27.i.i.i, align 8, !noalias !43
  store double %.320.i.i.i.i, ptr %lsr.iv13.i.i.i.i, align 8, !noalias !43
  %sunkaddr30.i.i.i = getelementptr i8, ptr %sunkaddr27.i.i.i, i64 8
  %.320.1.i.i.i.i = load double, ptr %sunkaddr30.i.i.i, align 8, !noalias !43
  %sunkaddr23.i.i.i.i = getelementptr i8, ptr %lsr.iv13.i.i.i.i, i64 %.16.i.i
  store double %.320.1.i.i.i.i, ptr %sunkaddr23.i.i.i.i, align 8, !noalias !43
  %sunkaddr33.i.i.i = getelementptr i8, ptr %sunkaddr27.i.i.i, i64 16
  %.320.2.i.i.i.i = load double, ptr %sunkaddr33.i.i.i, align 8, !noalias !43
  %scevgep51.i.i.i = getelementptr i8, ptr %sunkaddr23.i.i.i.i, i64 %.16.i.i
  store double %.320.2.i.i.i.i, ptr %scevgep51.i.i.i, align 8, !noalias !43
  %sunkaddr36.i.i.i = getelementptr i8, ptr %sunkaddr27.i.i.i, i64 24
  %.320.3.i.i.i.i = load double, ptr %sunkaddr36.i.i.i, align 8, !noalias !43
  %scevgep52.i.i.i = getelementptr i8, ptr %scevgep51.i.i.i, i64 %.16.i.i
  store double %.320.3.i.i.i.i, ptr %scevgep52.i.i.i, align 8, !noalias !43
  %sunkaddr39.i.i.i = getelementptr i8, ptr %sunkaddr27.i.i.i, i64 32
  %.320.i.1.i.i.i = load double, ptr %sunkaddr39.i.i.i, align 8, !noalias !43
  %scevgep53.i.i.i = getelementptr i8, ptr %scevgep52.i.i.i, i64 %.16.i.i
  store double %.320.i.1.i.i.i, ptr %scevgep53.i.i.i, align 8, !noalias !43
  %sunkaddr42.i.i.i = getelementptr i8, ptr %sunkaddr27.i.i.i, i64 40
  %.320.1.i.1.i.i.i = load double, ptr %sunkaddr42.i.i.i, align 8, !noalias !43
  %scevgep54.i.i.i = getelementptr i8, ptr %scevgep53.i.i.i, i64 %.16.i.i
  store double %.320.1.i.1.i.i.i, ptr %scevgep54.i.i.i, align 8, !noalias !43
  %sunkaddr45.i.i.i = getelementptr i8, ptr %sunkaddr27.i.i.i, i64 48
  %.320.2.i.1.i.i.i = load double, ptr %sunkaddr45.i.i.i, align 8, !noalias !43
  %scevgep55.i.i.i = getelementptr i8, ptr %scevgep54.i.i.i, i64 %.16.i.i
  store double %.320.2.i.1.i.i.i, ptr %scevgep55.i.i.i, align 8, !noalias !43
  %.266.3.i.1.i.i.i = add i64 %.259154156.i.i.i.i, 8
  %sunkaddr46.i.i.i = shl i64 %.266.3.i.1.i.i.i, 3
  %sunkaddr47.i.i.i = getelementptr i8, ptr %.3062.i, i64 %sunkaddr46.i.i.i
  %sunkaddr49.i.i.i = getelementptr i8, ptr %sunkaddr47.i.i.i, i64 -8
  %.320.3.i.1.i.i.i = load double, ptr %sunkaddr49.i.i.i, align 8, !noalias !43
  %scevgep56.i.i.i = getelementptr i8, ptr %scevgep55.i.i.i, i64 %.16.i.i
  store double %.320.3.i.1.i.i.i, ptr %scevgep56.i.i.i, align 8, !noalias !43
  %scevgep57.i.i.i = getelementptr i8, ptr %scevgep56.i.i.i, i64 %.16.i.i
  %lsr.iv.next.i51.i.i = add i64 %lsr.iv.i50.i.i, -2
  %niter.ncmp.1.i.i.i = icmp eq i64 %lsr.iv.next.i51.i.i, 0
  br i1 %niter.ncmp.1.i.i.i, label %B126.loopexit.unr-lcssa.i.unr-lcssa.i.i.i, label %B96.i.i.i.i
B126.loopexit.unr-lcssa.i.unr-lcssa.i.i.i:
  %scevgep14.i.i.i.i = getelementptr i8, ptr %lsr.iv13.i.i.i.i, i64 %59
  %scevgep14.i.1.i.i.i = getelementptr i8, ptr %scevgep14.i.i.i.i, i64 %59
  br i1 %70, label %B96.i.epil.preheader.i.i.i, label %B126.loopexit.unr-lcssa.i.i.i.i
B96.i.epil.preheader.i.i.i:
  %lsr.iv13.i.epil.init.i.i.i = phi ptr [ %invariant.gep159.i.i.i.i, %B96.lr.ph.new.i.i.i.i ], [ %scevgep14.i.1.i.i.i, %B126.loopexit.unr-lcssa.i.unr-lcssa.i.i.i ]
  %.259154156.i.epil.init.i.i.i = phi i64 [ 0, %B96.lr.ph.new.i.i.i.i ], [ %.266.3.i.1.i.i.i, %B126.loopexit.unr-lcssa.i.unr-lcssa.i.i.i ]
  %sunkaddr.i.epil.i.i.i = shl i64 %.259154156.i.epil.init.i.i.i, 3
  %sunkaddr18.i.epil.i.i.i = getelementptr i8, ptr %.3062.i, i64 %sunkaddr.i.epil.i.i.i
  %.320.i.epil.i.i.i = load double, ptr %sunkaddr18.i.epil.i.i.i, align 8, !noalias !43
  store double %.320.i.epil.i.i.i, ptr %lsr.iv13.i.epil.init.i.i.i, align 8, !noalias !43
  %sunkaddr21.i.epil.i.i.i = getelementptr i8, ptr %sunkaddr18.i.epil.i.i.i, i64 8
  %.320.1.i.epil.i.i.i = load double, ptr %sunkaddr21.i.epil.i.i.i, align 8, !noalias !43
  %sunkaddr23.i.epil.i.i.i = getelementptr i8, ptr %lsr.iv13.i.epil.init.i.i.i, i64 %.16.i.i
  store double %.320.1.i.epil.i.i.i, ptr %sunkaddr23.i.epil.i.i.i, align 8, !noalias !43
  %sunkaddr26.i.epil.i.i.i = getelementptr i8, ptr %sunkaddr18.i.epil.i.i.i, i64 16
  %.320.2.i.epil.i.i.i = load double, ptr %sunkaddr26.i.epil.i.i.i, align 8, !noalias !43
  %scevgep16.i.epil.i.i.i = getelementptr i8, ptr %lsr.iv13.i.epil.init.i.i.i, i64 %60
  store double %.320.2.i.epil.i.i.i, ptr %scevgep16.i.epil.i.i.i, align 8, !noalias !43
  %sunkaddr29.i.epil.i.i.i = getelementptr i8, ptr %sunkaddr18.i.epil.i.i.i, i64 24
  %.320.3.i.epil.i.i.i = load double, ptr %sunkaddr29.i.epil.i.i.i, align 8, !noalias !43
  %scevgep15.i.epil.i.i.i = getelementptr i8, ptr %lsr.iv13.i.epil.init.i.i.i, i64 %58
  store double %.320.3.i.epil.i.i.i, ptr %scevgep15.i.epil.i.i.i, align 8, !noalias !43
  br label %B126.loopexit.unr-lcssa.i.i.i.i
B126.loopexit.unr-lcssa.i.i.i.i:
  br i1 %71, label %B74.endif.endif.endif.endif.i.i.i, label %B96.epil.preheader.i.i.i.i
B96.epil.preheader.i.i.i.i:
  %.259154156.epil.init.i.i.i.i = phi i64 [ %unroll_iter.i.i.i, %B126.loopexit.unr-lcssa.i.i.i.i ], [ 0, %B96.lr.ph.i.i.i.i ]
  %23 = mul i64 %.259154156.epil.init.i.i.i.i, %.69.i
  %24 = add i64 %.577.i.i.i, %.562.i.i.i
  %25 = add i64 %24, %23
  %26 = shl i64 %25, 3
  %scevgep.i18.i.i.i = getelementptr i8, ptr %a13, i64 %26
  %27 = shl i64 %.259154156.epil.init.i.i.i.i, 3
  %scevgep3.i19.i.i.i = getelementptr i8, ptr %.3062.i, i64 %27
  br label %B96.epil.i.i.i.i
B96.epil.i.i.i.i:
  %lsr.iv.i20.i.i.i = phi ptr [ %scevgep2.i22.i.i.i, %B96.epil.i.i.i.i ], [ %scevgep.i18.i.i.i, %B96.epil.preheader.i.i.i.i ]
  %epil.iter.i.i.i.i = phi i64 [ %epil.iter.next.i.i.i.i, %B96.epil.i.i.i.i ], [ 0, %B96.epil.preheader.i.i.i.i ]
  %28 = shl i64 %epil.iter.i.i.i.i, 3
  %scevgep58.i.i.i = getelementptr i8, ptr %scevgep3.i19.i.i.i, i64 %28
  %.320.epil.i.i.i.i = load double, ptr %scevgep58.i.i.i, align 8, !noalias !43
  store double %.320.epil.i.i.i.i, ptr %lsr.iv.i20.i.i.i, align 8, !noalias !43
  %epil.iter.next.i.i.i.i = add i64 %epil.iter.i.i.i.i, 1
  %scevgep2.i22.i.i.i = getelementptr i8, ptr %lsr.iv.i20.i.i.i, i64 %.16.i.i
  %epil.iter.cmp.not.i.i.i.i = icmp eq i64 %xtraiter.i.i.i, %epil.iter.next.i.i.i.i
  br i1 %epil.iter.cmp.not.i.i.i.i, label %B74.endif.endif.endif.endif.i.i.i, label %B96.epil.i.i.i.i, !llvm.loop !46
B74.endif.endif.endif.endif.i.i.i:
  %.697.i.i.i = load i64, ptr %.179.i.i, align 8, !noalias !34
  %.698.i.i.i = add nsw i64 %.697.i.i.i, 1
  store i64 %.698.i.i.i, ptr %.179.i.i, align 8, !noalias !34
  %.766.i.i.i = icmp slt i64 %.698.i.i.i, %.69.i
  br i1 %.766.i.i.i, label %B356.i.i.i, label %B494.endif.endif.i.i.i.preheader
B494.endif.endif.i.i.i.preheader:
  br label %B494.endif.endif.i.i.i
B494.endif.endif.i.i.i:
  %.991619622.i.i.i = phi i64 [ %.998.i.i.i, %B494.endif.endif.i.i.i ], [ 0, %B494.endif.endif.i.i.i.preheader ]
  %.998.i.i.i = add nuw nsw i64 %.991619622.i.i.i, 1
  %.1055.i.i.i = load i64, ptr %.3421.i, align 8, !noalias !34
  %.1056625.i.i.i = icmp slt i64 %.1055.i.i.i, 0
  %"$phi494.1.2.1.in.v.i.i.i" = select i1 %.1056625.i.i.i, ptr %.883.i.i, ptr %.1055.i.i
  %29 = shl i64 %.991619622.i.i.i, 3
  %scevgep29.i.i.i = getelementptr i8, ptr %"$phi494.1.2.1.in.v.i.i.i", i64 %29
  %"$phi494.1.2.1.i.i.i" = load double, ptr %scevgep29.i.i.i, align 8, !noalias !34
  %scevgep28.i.i.i = getelementptr i8, ptr %invariant.gep.i.i.i, i64 %29
  %.1163.i.i.i = load double, ptr %scevgep28.i.i.i, align 8, !noalias !34
  %scevgep31.i.i.i = getelementptr i8, ptr %a2, i64 %29
  %.1194.i.i.i = load double, ptr %scevgep31.i.i.i, align 8, !noalias !34
  %.1195.i.i.i = fsub double %"$phi494.1.2.1.i.i.i", %.1194.i.i.i
  %.1196.i.i.i = tail call double @llvm.fabs.f64(double %.1195.i.i.i)
  %.1197.i.i.i = fadd double %.1163.i.i.i, %.1196.i.i.i
  store double %.1197.i.i.i, ptr %scevgep28.i.i.i, align 8, !noalias !34
  store double %"$phi494.1.2.1.i.i.i", ptr %scevgep31.i.i.i, align 8, !noalias !34
  %scevgep6.i7.i.i = getelementptr i8, ptr %a14, i64 %29
  %.1289.i.i.i = load double, ptr %scevgep6.i7.i.i, align 8, !noalias !34
  %.12.i.i8.i.i = fcmp olt double %"$phi494.1.2.1.i.i.i", %.1289.i.i.i
  %.13.i.i9.i.i = select i1 %.12.i.i8.i.i, double %"$phi494.1.2.1.i.i.i", double %.1289.i.i.i
  %scevgep5.i10.i.i = getelementptr i8, ptr %invariant.gep645.i.i.i, i64 %29
  %.1350.i.i.i = load double, ptr %scevgep5.i10.i.i, align 8, !noalias !34
  %.12.i23.i.i.i = fcmp ogt double %"$phi494.1.2.1.i.i.i", %.1350.i.i.i
  %.13.i24.i.i.i = select i1 %.12.i23.i.i.i, double %"$phi494.1.2.1.i.i.i", double %.1350.i.i.i
  store double %.13.i.i9.i.i, ptr %scevgep6.i7.i.i, align 8, !noalias !34
  store double %.13.i24.i.i.i, ptr %scevgep5.i10.i.i, align 8, !noalias !34
  %exitcond.not.i11.i.i = icmp eq i64 %.23.i, %.998.i.i.i
  br i1 %exitcond.not.i11.i.i, label %_ZN6poppet6engine10integrator5_takeB3v20B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i.i, label %B494.endif.endif.i.i.i
_ZN6poppet6engine10integrator5_takeB3v20B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i.i:
  %.1501.i.i.i = load i64, ptr %a16, align 8, !noalias !34
  %.1502.i.i.i = add nsw i64 %.1501.i.i.i, 1
  store i64 %.1502.i.i.i, ptr %a16, align 8, !noalias !34
  store double %end.2.1.i.i, ptr %a15, align 8, !noalias !7
  %.3771.i.i = load i64, ptr %.3421.i, align 8, !noalias !7
  %.3772.i.i = icmp sgt i64 %.3771.i.i, -1
  br i1 %.3772.i.i, label %_ZN6poppet6engine10integrator8_segmentB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i, label %B1494.endif.i.i
B1614.i.i:
  %.4080.i.i = fmul double %storemerge.i213.i.i, %.13.i4.i.i.i
  %.12.i142.i.i = fcmp ogt double %.4080.i.i, %.13.i131.i.i
  %.13.i143.i.i = select i1 %.12.i142.i.i, double %.4080.i.i, double %.13.i131.i.i
  br label %B1910.i.i
B1652.i.i:
  %.12.i144.i.i = fcmp olt double %.13.i4.i.i.i, 1.000000e+00
  %.13.i145.i.i = select i1 %.12.i144.i.i, double %.13.i4.i.i.i, double 1.000000e+00
  %"$phi1692.1.2.1.i.i" = select i1 %rejected.3.0.i.i, double %.13.i145.i.i, double %.13.i4.i.i.i
  %.4175.i.i = fmul double %storemerge.i213.i.i, %"$phi1692.1.2.1.i.i"
  br label %B1910.i.i
B1850.i.i:
  %"$phi1850.1.2.2.i.i" = phi double [ 1.500000e-01, %for.end.i.i ], [ %.13.i257.i.i, %B1746.endif.i.i ]
  %.4325.i.i = fmul double %storemerge.i213.i.i, %"$phi1850.1.2.2.i.i"
  %.4338.i.i = fadd double %t.2.0.i.i, %.4325.i.i
  %.4340.i.i = fcmp ole double %.4338.i.i, %t.2.0.i.i
  %.4369.i.i = fcmp olt double %.4325.i.i, 1.000000e-300
  %or.cond.i.i = or i1 %.4369.i.i, %.4340.i.i
  br i1 %or.cond.i.i, label %_ZN6poppet6engine10integrator8_segmentB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i, label %B1910.i.i
B1910.i.i:
  %.3361263.i.i = phi i1 [ false, %B1850.i.i ], [ true, %B1652.i.i ], [ true, %B1614.i.i ]
  %t.3.1.i.i = phi double [ %t.2.0.i.i, %B1850.i.i ], [ %end.2.1.i.i, %B1652.i.i ], [ %end.2.1.i.i, %B1614.i.i ]
  %error_before.3.1.i.i = phi double [ %error_before.2.0.i.i, %B1850.i.i ], [ %.13.i255.i.i, %B1652.i.i ], [ %.13.i255.i.i, %B1614.i.i ]
  %step_before.3.1.i.i = phi double [ %step_before.2.0.i.i, %B1850.i.i ], [ %storemerge.i213.i.i, %B1652.i.i ], [ %storemerge.i213.i.i, %B1614.i.i ]
  %h.6.1.i.i = phi double [ %.4325.i.i, %B1850.i.i ], [ %.4175.i.i, %B1652.i.i ], [ %.13.i143.i.i, %B1614.i.i ]
  %rejected.4.1.i.i = xor i1 %.3361263.i.i, true
  %.4609.i.i = load double, ptr %sunkaddr167.i.i, align 8, !noalias !7
  %.4639.i.i = load double, ptr %sunkaddr168.i.i, align 8, !noalias !7
  %.82.i.i.i = load i64, ptr %sunkaddr174.i.i, align 8, !noalias !48
  %.102.i.i.i = srem i64 %.82.i.i.i, 400
  %.123.i.i.i = icmp eq i64 %.102.i.i.i, 0
  br i1 %.123.i.i.i, label %B44.endif.i.i.i, label %B174.i.i.i
B108.i.i.i:
  %.231.i.i.i = fsub double %t.3.1.i.i, %window.2.0.i.i
  %.236.i.i.i = fsub double %.4609.i.i, %window.2.0.i.i
  %.241.i.i.i = fmul double %.236.i.i.i, 1.000000e-04
  %.242.i.i.i = fcmp olt double %.231.i.i.i, %.241.i.i.i
  br i1 %.242.i.i.i, label %_ZN6poppet6engine10integrator8_segmentB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i, label %B152.i.i.i
B152.i.i.i:
  store i64 %.154.i.i.i, ptr %sunkaddr172.i.i, align 8, !noalias !48
  br label %B174.i.i.i
B174.i.i.i:
  %30 = fcmp une double %.4639.i.i, 0.000000e+00
  %.395.i.i.i = load double, ptr %sunkaddr171.i.i, align 8, !noalias !48
  %.401.i.i.i = sitofp i64 %.82.i.i.i to double
  %.402.i.i.i = fcmp ole double %.395.i.i.i, %.401.i.i.i
  %brmerge.i.i = select i1 %.402.i.i.i, i1 true, i1 %30
  br i1 %brmerge.i.i, label %B2004.split.loop.exit.i.i, label %B2014.else.if.i.i
B44.endif.i.i.i:
  %.154.i.i.i = load i64, ptr %a16, align 8, !noalias !48
  %.184.i.i.i = load i64, ptr %sunkaddr172.i.i, align 8, !noalias !48
  %.185.i.i.i = sub nsw i64 %.154.i.i.i, %.184.i.i.i
  %.227.i148.i.i = icmp slt i64 %.185.i.i.i, 280
  br i1 %.227.i148.i.i, label %B108.i.i.i, label %B152.i.i.i
B2004.split.loop.exit.i.i:
  %.mux.le.i.i = select i1 %.402.i.i.i, i64 3, i64 5
  br label %_ZN6poppet6engine10integrator8_segmentB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i
B0.endif.else.endif.if.i.i:
  br label %B0.endif.else.endif.endif.endif.i.i
B0.endif.else.endif.endif.endif.i.i:
  %.598.sroa.0.3.i.i = phi i64 [ %.1155.i, %B0.endif.else.endif.if.i.i ], [ %.23.i, %B1554.i ]
  br i1 %.635.not.i.i, label %B0.endif.endif.else.i.i, label %B0.endif.else.endif.endif.endif.if.i.i, !prof !10
B0.endif.else.endif.endif.endif.if.i.i:
  br label %B0.endif.endif.else.i.i
B0.endif.endif.else.i.i:
  %.598.sroa.13.0.i.i = phi i64 [ %.572.i.i, %B0.endif.else.endif.endif.endif.i.i ], [ %.1155.i, %B0.endif.else.endif.endif.endif.if.i.i ]
  %.686.i.i = sub nsw i64 %.598.sroa.13.0.i.i, %.598.sroa.0.3.i.i
  %.695.i.i = tail call i64 @llvm.smax.i64(i64 %.686.i.i, i64 0)
  %.711.i.i = getelementptr double, ptr %.1171.i, i64 %.598.sroa.0.3.i.i
  br i1 %.635.not.i.i, label %B0.endif.endif.else.endif.endif.endif.i.i, label %B0.endif.endif.else.endif.if.i.i, !prof !10
B0.endif.endif.else.endif.if.i.i:
  br label %B0.endif.endif.else.endif.endif.endif.i.i
B0.endif.endif.else.endif.endif.endif.i.i:
  %.770.sroa.0.3.i.i = phi i64 [ %.1155.i, %B0.endif.endif.else.endif.if.i.i ], [ %.572.i.i, %B0.endif.endif.else.i.i ]
  %.883.i.i = getelementptr double, ptr %.1171.i, i64 %.770.sroa.0.3.i.i
  br i1 %.807.not.i.i, label %B0.endif.endif.endif.else.endif.endif.endif.i.i, label %B0.endif.endif.endif.else.endif.if.i.i, !prof !10
B0.endif.endif.endif.else.endif.if.i.i:
  br label %B0.endif.endif.endif.else.endif.endif.endif.i.i
B0.endif.endif.endif.else.endif.endif.endif.i.i:
  %.942.sroa.0.3.i.i = phi i64 [ %.1155.i, %B0.endif.endif.endif.else.endif.if.i.i ], [ %.744.i.i, %B0.endif.endif.else.endif.endif.endif.i.i ]
  br i1 %.979.not.i.i, label %B0.endif.endif.endif.endif.else.i.i, label %B0.endif.endif.endif.else.endif.endif.endif.if.i.i, !prof !10
B0.endif.endif.endif.else.endif.endif.endif.if.i.i:
  br label %B0.endif.endif.endif.endif.else.i.i
B0.endif.endif.endif.endif.else.i.i:
  %.942.sroa.13.0.i.i = phi i64 [ %.916.i.i, %B0.endif.endif.endif.else.endif.endif.endif.i.i ], [ %.1155.i, %B0.endif.endif.endif.else.endif.endif.endif.if.i.i ]
  %.1030.i.i = sub nsw i64 %.942.sroa.13.0.i.i, %.942.sroa.0.3.i.i
  %.1039.i.i = tail call i64 @llvm.smax.i64(i64 %.1030.i.i, i64 0)
  %.1055.i.i = getelementptr double, ptr %.1171.i, i64 %.942.sroa.0.3.i.i
  br i1 %.979.not.i.i, label %B0.endif.endif.endif.endif.else.endif.endif.endif.i.i, label %B0.endif.endif.endif.endif.else.endif.if.i.i, !prof !10
B0.endif.endif.endif.endif.else.endif.if.i.i:
  br label %B0.endif.endif.endif.endif.else.endif.endif.endif.i.i
B0.endif.endif.endif.endif.else.endif.endif.endif.i.i:
  %.1258.sroa.0.3.i.i = phi i64 [ %.1155.i, %B0.endif.endif.endif.endif.else.endif.if.i.i ], [ %.916.i.i, %B0.endif.endif.endif.endif.else.i.i ]
  %.1371.i.i = getelementptr double, ptr %.1171.i, i64 %.1258.sroa.0.3.i.i
  br i1 %.1295.not.i.i, label %B0.endif.endif.endif.endif.endif.endif.else.i.i, label %B0.endif.endif.endif.endif.endif.else.endif.if.i.i, !prof !10
B0.endif.endif.endif.endif.endif.else.endif.if.i.i:
  br label %B0.endif.endif.endif.endif.endif.endif.else.i.i
B0.endif.endif.endif.endif.endif.endif.else.i.i:
  %.1429.sroa.0.3.i.i = phi i64 [ %.1155.i, %B0.endif.endif.endif.endif.endif.else.endif.if.i.i ], [ %.1232.i.i, %B0.endif.endif.endif.endif.else.endif.endif.endif.i.i ]
  %.1542.i.i = getelementptr double, ptr %.1171.i, i64 %.1429.sroa.0.3.i.i
  br i1 %.1620.not.i.i, label %B0.endif.endif.endif.endif.endif.endif.endif.i.i, label %B0.endif.endif.endif.endif.endif.endif.else.endif.if.i.i, !prof !10
B0.endif.endif.endif.endif.endif.endif.endif.i.i:
  %.1600.sroa.0.3.i.i = phi i64 [ %.1155.i, %B0.endif.endif.endif.endif.endif.endif.else.endif.if.i.i ], [ %.1574.i.i, %B0.endif.endif.endif.endif.endif.endif.else.i.i ]
  %.1713.i.i = getelementptr double, ptr %.1171.i, i64 %.1600.sroa.0.3.i.i
  %scevgep.i149.i.i = getelementptr i8, ptr %.4217.i, i64 16
  br label %B56.i150.i.i
B56.i150.i.i:
  %lsr.iv3.i.i.i = phi i64 [ %lsr.iv.next.i.i.i, %B88.i.i.i ], [ %73, %B0.endif.endif.endif.endif.endif.endif.endif.i.i ]
  %lsr.iv.i151.i.i = phi ptr [ %scevgep1.i152.i.i, %B88.i.i.i ], [ %scevgep.i149.i.i, %B0.endif.endif.endif.endif.endif.endif.endif.i.i ]
  %scevgep1.i152.i.i = getelementptr i8, ptr %lsr.iv.i151.i.i, i64 48
  %lsr.iv.next.i.i.i = add i64 %lsr.iv3.i.i.i, -1
  %exitcond.not.i153.i.i = icmp eq i64 %lsr.iv.next.i.i.i, 0
  br i1 %exitcond.not.i153.i.i, label %B0.endif.endif.endif.endi...endif.5.endif.i.i, label %B58.i.i.i
B58.i.i.i:
  %scevgep2.i154.i.i = getelementptr i8, ptr %lsr.iv.i151.i.i, i64 -8
  %.215.i.i.i = load double, ptr %scevgep2.i154.i.i, align 8, !noalias !51
  %.216.i.i.i = fcmp une double %.215.i.i.i, 0.000000e+00
  br i1 %.216.i.i.i, label %B0.endif.endif.endif.endi...endif.5.endif.i.i, label %B88.i.i.i
B88.i.i.i:
  %.274.i.i.i = load double, ptr %lsr.iv.i151.i.i, align 8, !noalias !51
  %.275.i.i.i = fcmp une double %.274.i.i.i, 0.000000e+00
  br i1 %.275.i.i.i, label %B0.endif.endif.endif.endi...endif.5.endif.i.i, label %B56.i150.i.i
B0.endif.endif.endif.endif.endif.endif.else.endif.if.i.i:
  br label %B0.endif.endif.endif.endif.endif.endif.endif.i.i
B0.endif.endif.endif.endi...endif.5.endif.i.i:
  %.40.i155.i.i = fsub double %.3647.i, %.3647.i
  %scevgep.i158.i.i = getelementptr i8, ptr %.4217.i, i64 40
  br label %B372.else.i.i
B372.else.i.i:
  %.195027172719.i.i = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.5.endif.i.i ], [ %.1957.i.i, %B372.endif.endif.i.i ]
  %.1957.i.i = add nuw nsw i64 %.195027172719.i.i, 1
  %.1984.i.i = mul nuw nsw i64 %.195027172719.i.i, %.1512.i
  %.1987.i.i = mul nuw nsw i64 %.1957.i.i, %.1512.i
  %.2034.not.i.i = icmp sgt i64 %.1674.i, %.1984.i.i
  br i1 %.2034.not.i.i, label %B372.else.endif.endif.endif.i.i, label %B372.else.endif.if.i.i, !prof !10
B372.endif.i.i:
  %.2014.sroa.13.0.i.i = phi i64 [ %.1987.i.i, %B372.else.endif.endif.endif.i.i ], [ %.1683.i, %B372.else.endif.endif.endif.if.i.i ]
  %.132223.not.i156.not.i.i = icmp sgt i64 %.2014.sroa.13.0.i.i, %.2014.sroa.0.3.i.i
  br i1 %.132223.not.i156.not.i.i, label %B56.i159.i.i, label %B372.endif.endif.i.i
B56.i159.i.i:
  %lsr.iv418.i.i = phi i64 [ %lsr.iv.next419.i.i, %B316.i172.i.i ], [ %.2014.sroa.0.3.i.i, %B372.endif.i.i ]
  %lsr.iv.i160.i.i = phi ptr [ %scevgep1.i175.i.i, %B316.i172.i.i ], [ %scevgep.i158.i.i, %B372.endif.i.i ]
  %scevgep6.i163.i.i = getelementptr i8, ptr %lsr.iv.i160.i.i, i64 -40
  %.227.i164.i.i = load double, ptr %scevgep6.i163.i.i, align 8, !noalias !54
  %scevgep5.i165.i.i = getelementptr i8, ptr %lsr.iv.i160.i.i, i64 -32
  %.282.i166.i.i = load double, ptr %scevgep5.i165.i.i, align 8, !noalias !54
  %.284.i167.i.i = fmul double %.40.i155.i.i, %.282.i166.i.i
  %.285.i168.i.i = fadd double %.227.i164.i.i, %.284.i167.i.i
  %scevgep4.i169.i.i = getelementptr i8, ptr %lsr.iv.i160.i.i, i64 -24
  %.347.i170.i.i = load double, ptr %scevgep4.i169.i.i, align 8, !noalias !54
  %.348.i171.i.i = fcmp une double %.347.i170.i.i, 0.000000e+00
  br i1 %.348.i171.i.i, label %B134.i177.i.i, label %B316.i172.i.i
B134.i177.i.i:
  %scevgep3.i178.i.i = getelementptr i8, ptr %lsr.iv.i160.i.i, i64 -16
  %.405.i179.i.i = load double, ptr %scevgep3.i178.i.i, align 8, !noalias !54
  %scevgep2.i180.i.i = getelementptr i8, ptr %lsr.iv.i160.i.i, i64 -8
  %.460.i181.i.i = load double, ptr %scevgep2.i180.i.i, align 8, !noalias !54
  %.461.i182.i.i = fmul double %.460.i181.i.i, 5.000000e-01
  %.463.i183.i.i = fmul double %.40.i155.i.i, %.461.i182.i.i
  %.464.i184.i.i = fadd double %.405.i179.i.i, %.463.i183.i.i
  %.465.i185.i.i = fmul double %.464.i184.i.i, 0x401921FB54442D18
  %.467.i186.i.i = fmul double %.40.i155.i.i, %.465.i185.i.i
  %.522.i187.i.i = load double, ptr %lsr.iv.i160.i.i, align 8, !noalias !54
  %.523.i188.i.i = fadd double %.522.i187.i.i, %.467.i186.i.i
  %.586.le.i189.i.i = tail call double @llvm.sin.f64(double %.523.i188.i.i)
  %.591.i190.i.i = fmul double %.347.i170.i.i, %.586.le.i189.i.i
  %.593.i191.i.i = fadd double %.285.i168.i.i, %.591.i190.i.i
  br label %B316.i172.i.i
B316.i172.i.i:
  %value.2.1.i173.i.i = phi double [ %.593.i191.i.i, %B134.i177.i.i ], [ %.285.i168.i.i, %B56.i159.i.i ]
  %31 = shl i64 %lsr.iv418.i.i, 3
  %scevgep420.i.i = getelementptr i8, ptr %.1699.i, i64 %31
  store double %value.2.1.i173.i.i, ptr %scevgep420.i.i, align 8, !noalias !54
  %scevgep1.i175.i.i = getelementptr i8, ptr %lsr.iv.i160.i.i, i64 48
  %lsr.iv.next419.i.i = add i64 %lsr.iv418.i.i, 1
  %exitcond.not.i176.i.i = icmp eq i64 %.2014.sroa.13.0.i.i, %lsr.iv.next419.i.i
  br i1 %exitcond.not.i176.i.i, label %B372.endif.endif.i.i, label %B56.i159.i.i
B372.else.endif.if.i.i:
  br label %B372.else.endif.endif.endif.i.i
B372.else.endif.endif.endif.i.i:
  %.2014.sroa.0.3.i.i = phi i64 [ %.1683.i, %B372.else.endif.if.i.i ], [ %.1984.i.i, %B372.else.i.i ]
  %.2051.not.i.i = icmp sgt i64 %.1674.i, %.1987.i.i
  br i1 %.2051.not.i.i, label %B372.endif.i.i, label %B372.else.endif.endif.endif.if.i.i, !prof !10
B372.else.endif.endif.endif.if.i.i:
  br label %B372.endif.i.i
B372.endif.endif.i.i:
  %exitcond.not.i1.i = icmp eq i64 %.1957.i.i, 4
  br i1 %exitcond.not.i1.i, label %B446.i.i, label %B372.else.i.i
B464.endif.i.i:
  br i1 %76, label %B464.endif.endif.i.i, label %B56.i196.i.i
B56.i196.i.i:
  %lsr.iv.i197.i.i = phi ptr [ %scevgep1.i203.i.i, %B370.i.i.i ], [ %scevgep.i158.i.i, %B464.endif.i.i ]
  %.138242244.i.i.i = phi i64 [ %.145.i198.i.i, %B370.i.i.i ], [ 0, %B464.endif.i.i ]
  %.145.i198.i.i = add nuw nsw i64 %.138242244.i.i.i, 1
  %scevgep5.i199.i.i = getelementptr i8, ptr %lsr.iv.i197.i.i, i64 -32
  %.227.i200.i.i = load double, ptr %scevgep5.i199.i.i, align 8, !noalias !57
  %scevgep4.i201.i.i = getelementptr i8, ptr %lsr.iv.i197.i.i, i64 -24
  %.289.i.i.i = load double, ptr %scevgep4.i201.i.i, align 8, !noalias !57
  %.290.i.i.i = fcmp une double %.289.i.i.i, 0.000000e+00
  br i1 %.290.i.i.i, label %B106.i.i.i, label %B370.i.i.i
B106.i.i.i:
  %scevgep3.i205.i.i = getelementptr i8, ptr %lsr.iv.i197.i.i, i64 -16
  %.347.i206.i.i = load double, ptr %scevgep3.i205.i.i, align 8, !noalias !57
  %scevgep2.i207.i.i = getelementptr i8, ptr %lsr.iv.i197.i.i, i64 -8
  %.402.i208.i.i = load double, ptr %scevgep2.i207.i.i, align 8, !noalias !57
  %.403.i.i.i = fmul double %.402.i208.i.i, 5.000000e-01
  %.405.i209.i.i = fmul double %.40.i.i.i, %.403.i.i.i
  %.406.i.i.i = fadd double %.347.i206.i.i, %.405.i209.i.i
  %.407.i.i.i = fmul double %.406.i.i.i, 0x401921FB54442D18
  %.409.i.i.i = fmul double %.40.i.i.i, %.407.i.i.i
  %.464.i210.i.i = load double, ptr %lsr.iv.i197.i.i, align 8, !noalias !57
  %.465.i211.i.i = fadd double %.464.i210.i.i, %.409.i.i.i
  %.578.i.i.i = fmul double %.40.i.i.i, %.402.i208.i.i
  %.579.i.i.i = fadd double %.347.i206.i.i, %.578.i.i.i
  %.580.i.i.i = fmul double %.579.i.i.i, 0x401921FB54442D18
  %.636.i.i.i = fmul double %.289.i.i.i, %.580.i.i.i
  %.644.le.i.i.i = tail call double @llvm.cos.f64(double %.465.i211.i.i)
  %.649.i.i.i = fmul double %.636.i.i.i, %.644.le.i.i.i
  %.651.i.i.i = fadd double %.227.i200.i.i, %.649.i.i.i
  br label %B370.i.i.i
B370.i.i.i:
  %slope.2.1.i.i.i = phi double [ %.651.i.i.i, %B106.i.i.i ], [ %.227.i200.i.i, %B56.i196.i.i ]
  %32 = shl i64 %.138242244.i.i.i, 3
  %scevgep6.i202.i.i = getelementptr i8, ptr %.1871.i, i64 %32
  store double %slope.2.1.i.i.i, ptr %scevgep6.i202.i.i, align 8, !noalias !57
  %scevgep1.i203.i.i = getelementptr i8, ptr %lsr.iv.i197.i.i, i64 48
  %exitcond.not.i204.i.i = icmp eq i64 %.1846.i, %.145.i198.i.i
  br i1 %exitcond.not.i204.i.i, label %B464.endif.endif.i.i, label %B56.i196.i.i
B464.endif.endif.i.i:
  %.2406.i.i = load i64, ptr %a0, align 8, !noalias !7
  %.2463.i.i = inttoptr i64 %.2406.i.i to ptr
  tail call void %.2463.i.i(ptr nonnull %.2042.i, ptr %a2, ptr %.1528.i, ptr %.1871.i, ptr %a3, ptr %.1171.i, ptr %.2524.i, ptr %.711.i.i), !noalias !7
  %.2472.i.i = fcmp ugt double %h.5.0.i.i, 0.000000e+00
  br i1 %.2472.i.i, label %B722.endif.endif.i.i, label %B630.i.i
B630.endif.i.i:
  %fastest.2.0.lcssa.i.i.i = phi double [ %.56.i.i.i, %B630.i.i ], [ %.13.i.i.i.i, %B66.backedge.i.i.i ]
  %.373.i.i.i = fdiv double 1.000000e+00, %fastest.2.0.lcssa.i.i.i
  %.2521.i.i = fcmp olt double %h.5.0.i.i, 0.000000e+00
  br i1 %.2521.i.i, label %B684.i.i, label %B722.endif.endif.i.i
B722.endif.endif.i.i:
  %h.7.1.i.i = phi double [ %h.5.0.i.i, %B460.i.i ], [ %h.5.0.i.i, %B464.endif.endif.i.i ], [ %.373.i.i.i, %B630.endif.i.i ], [ %.13.i.i.i, %B684.i.i ]
  %.2614.i.i = load double, ptr %a10, align 8, !noalias !7
  %.12.i130.i.i = fcmp olt double %.2614.i.i, %h.7.1.i.i
  %.13.i131.i.i = select i1 %.12.i130.i.i, double %.2614.i.i, double %h.7.1.i.i
  %.2652.i.i = fsub double %"$phi1338.1.2.1.i", %t.2.0.i.i
  %.11.i.i.i = fmul double %.2652.i.i, 5.000000e-01
  %.13.i212.i.i = fcmp olt double %.13.i131.i.i, %.11.i.i.i
  %.24.i.i.i = fcmp olt double %.13.i131.i.i, %.2652.i.i
  %"$phi50.0.2.0.i.i.i" = select i1 %.24.i.i.i, double %.11.i.i.i, double %.2652.i.i
  %storemerge.i213.i.i = select i1 %.13.i212.i.i, double %.13.i131.i.i, double %"$phi50.0.2.0.i.i.i"
  br i1 %exitcond.not.i153.i.i, label %B952.i.i, label %switch.lookup.i.i
switch.lookup.i.i:
  %.278327232726.i.i = phi i64 [ %.2790.i.i, %switch.end.endif.endif.i.i ], [ 0, %B722.endif.endif.i.i ]
  %.2790.i.i = add nuw nsw i64 %.278327232726.i.i, 1
  %switch.gep.i.i = getelementptr inbounds double, ptr @v21, i64 %.278327232726.i.i
  %switch.load.i.i = load double, ptr %switch.gep.i.i, align 8, !noalias !7
  %.2848.i.i = fmul double %storemerge.i213.i.i, %switch.load.i.i
  %.2850.i.i = fadd double %t.2.0.i.i, %.2848.i.i
  %.2852.i.i = mul nuw nsw i64 %.278327232726.i.i, %.1512.i
  %.2855.i.i = mul nuw nsw i64 %.2790.i.i, %.1512.i
  %.2902.not.i.i = icmp sgt i64 %.1674.i, %.2852.i.i
  br i1 %.2902.not.i.i, label %switch.end.else.endif.endif.endif.i.i, label %switch.end.else.endif.if.i.i, !prof !10
switch.end.endif.i.i:
  %.2882.sroa.13.0.i.i = phi i64 [ %.2855.i.i, %switch.end.else.endif.endif.endif.i.i ], [ %.1683.i, %switch.end.else.endif.endif.endif.if.i.i ]
  %.40.i214.i.i = fsub double %.2850.i.i, %.3647.i
  %.132223.not.i215.not.i.i = icmp sgt i64 %.2882.sroa.13.0.i.i, %.2882.sroa.0.3.i.i
  br i1 %.132223.not.i215.not.i.i, label %B56.i218.i.i, label %switch.end.endif.endif.i.i
B56.i218.i.i:
  %lsr.iv.i4.i = phi i64 [ %lsr.iv.next.i.i, %B316.i231.i.i ], [ %.2882.sroa.0.3.i.i, %switch.end.endif.i.i ]
  %lsr.iv.i219.i.i = phi ptr [ %scevgep1.i234.i.i, %B316.i231.i.i ], [ %scevgep.i158.i.i, %switch.end.endif.i.i ]
  %scevgep6.i222.i.i = getelementptr i8, ptr %lsr.iv.i219.i.i, i64 -40
  %.227.i223.i.i = load double, ptr %scevgep6.i222.i.i, align 8, !noalias !60
  %scevgep5.i224.i.i = getelementptr i8, ptr %lsr.iv.i219.i.i, i64 -32
  %.282.i225.i.i = load double, ptr %scevgep5.i224.i.i, align 8, !noalias !60
  %.284.i226.i.i = fmul double %.40.i214.i.i, %.282.i225.i.i
  %.285.i227.i.i = fadd double %.227.i223.i.i, %.284.i226.i.i
  %scevgep4.i228.i.i = getelementptr i8, ptr %lsr.iv.i219.i.i, i64 -24
  %.347.i229.i.i = load double, ptr %scevgep4.i228.i.i, align 8, !noalias !60
  %.348.i230.i.i = fcmp une double %.347.i229.i.i, 0.000000e+00
  br i1 %.348.i230.i.i, label %B134.i236.i.i, label %B316.i231.i.i
B134.i236.i.i:
  %scevgep3.i237.i.i = getelementptr i8, ptr %lsr.iv.i219.i.i, i64 -16
  %.405.i238.i.i = load double, ptr %scevgep3.i237.i.i, align 8, !noalias !60
  %scevgep2.i239.i.i = getelementptr i8, ptr %lsr.iv.i219.i.i, i64 -8
  %.460.i240.i.i = load double, ptr %scevgep2.i239.i.i, align 8, !noalias !60
  %.461.i241.i.i = fmul double %.460.i240.i.i, 5.000000e-01
  %.463.i242.i.i = fmul double %.40.i214.i.i, %.461.i241.i.i
  %.464.i243.i.i = fadd double %.405.i238.i.i, %.463.i242.i.i
  %.465.i244.i.i = fmul double %.464.i243.i.i, 0x401921FB54442D18
  %.467.i245.i.i = fmul double %.40.i214.i.i, %.465.i244.i.i
  %.522.i246.i.i = load double, ptr %lsr.iv.i219.i.i, align 8, !noalias !60
  %.523.i247.i.i = fadd double %.522.i246.i.i, %.467.i245.i.i
  %.586.le.i248.i.i = tail call double @llvm.sin.f64(double %.523.i247.i.i)
  %.591.i249.i.i = fmul double %.347.i229.i.i, %.586.le.i248.i.i
  %.593.i250.i.i = fadd double %.285.i227.i.i, %.591.i249.i.i
  br label %B316.i231.i.i
B316.i231.i.i:
  %value.2.1.i232.i.i = phi double [ %.593.i250.i.i, %B134.i236.i.i ], [ %.285.i227.i.i, %B56.i218.i.i ]
  %33 = shl i64 %lsr.iv.i4.i, 3
  %scevgep412.i.i = getelementptr i8, ptr %.1699.i, i64 %33
  store double %value.2.1.i232.i.i, ptr %scevgep412.i.i, align 8, !noalias !60
  %scevgep1.i234.i.i = getelementptr i8, ptr %lsr.iv.i219.i.i, i64 48
  %lsr.iv.next.i.i = add i64 %lsr.iv.i4.i, 1
  %exitcond.not.i235.i.i = icmp eq i64 %.2882.sroa.13.0.i.i, %lsr.iv.next.i.i
  br i1 %exitcond.not.i235.i.i, label %switch.end.endif.endif.i.i, label %B56.i218.i.i
switch.end.else.endif.if.i.i:
  br label %switch.end.else.endif.endif.endif.i.i
switch.end.else.endif.endif.endif.i.i:
  %.2882.sroa.0.3.i.i = phi i64 [ %.1683.i, %switch.end.else.endif.if.i.i ], [ %.2852.i.i, %switch.lookup.i.i ]
  %.2919.not.i.i = icmp sgt i64 %.1674.i, %.2855.i.i
  br i1 %.2919.not.i.i, label %switch.end.endif.i.i, label %switch.end.else.endif.endif.endif.if.i.i, !prof !10
switch.end.else.endif.endif.endif.if.i.i:
  br label %switch.end.endif.i.i
switch.end.endif.endif.i.i:
  %exitcond.not319.i.i = icmp eq i64 %.2790.i.i, 4
  br i1 %exitcond.not319.i.i, label %B952.i.i, label %switch.lookup.i.i
B982.endif.thread.i.i:
  %.3328259.i.i = load i64, ptr %sunkaddr174.i.i, align 8, !noalias !7
  %.3329260.i.i = add nsw i64 %.3328259.i.i, 1
  store i64 %.3329260.i.i, ptr %sunkaddr174.i.i, align 8, !noalias !7
  br label %for.end.i.i
B982.endif.i.i:
  %.3328.i.i = load i64, ptr %sunkaddr174.i.i, align 8, !noalias !7
  %.3329.i.i = add nsw i64 %.3328.i.i, 1
  store i64 %.3329.i.i, ptr %sunkaddr174.i.i, align 8, !noalias !7
  %.3361.i.i = fcmp ugt double %worst.3.1.i.i.i, 1.000000e+00
  br i1 %.3361.i.i, label %for.end.i.i, label %B1162.i.i
B1494.endif.i.i:
  %.12.i140.i.i = fcmp olt double %storemerge.i270.i.i, 1.000000e-10
  %.13.i141.i.i = select i1 %.12.i140.i.i, double 1.000000e-10, double %storemerge.i270.i.i
  %.17.i.i.i = tail call double @llvm.pow.f64(double %.13.i141.i.i, double -2.500000e-01)
  %.18.i.i.i = fmul double %.17.i.i.i, 9.000000e-01
  %.27.i.i.i = fcmp ogt double %step_before.2.0.i.i, 0.000000e+00
  br i1 %.27.i.i.i, label %B42.endif.i.i.i, label %B1494.endif.endif.endif.i.i
B42.endif.i.i.i:
  %.34.i.i.i = fdiv double %storemerge.i213.i.i, %step_before.2.0.i.i
  %.39.i.i.i = fmul double %.34.i.i.i, 9.000000e-01
  %.42.i.i.i = fmul double %.13.i141.i.i, %.13.i141.i.i
  %.49.i.i.i = fdiv double %error_before.2.0.i.i, %.42.i.i.i
  %.52.i.i.i = tail call double @llvm.pow.f64(double %.49.i.i.i, double 2.500000e-01)
  %.53.i.i.i = fmul double %.39.i.i.i, %.52.i.i.i
  %.12.i1.i.i.i = fcmp olt double %.53.i.i.i, %.18.i.i.i
  %.13.i2.i.i.i = select i1 %.12.i1.i.i.i, double %.53.i.i.i, double %.18.i.i.i
  br label %B1494.endif.endif.endif.i.i
B1494.endif.endif.endif.i.i:
  %factor.2.0.i.i.i = phi double [ %.18.i.i.i, %B1494.endif.i.i ], [ %.13.i2.i.i.i, %B42.endif.i.i.i ]
  %.12.i.i252.i.i = fcmp ogt double %factor.2.0.i.i.i, 1.500000e-01
  %.13.i.i253.i.i = select i1 %.12.i.i252.i.i, double %factor.2.0.i.i.i, double 1.500000e-01
  %.12.i3.i.i.i = fcmp olt double %.13.i.i253.i.i, 6.000000e+00
  %.13.i4.i.i.i = select i1 %.12.i3.i.i.i, double %.13.i.i253.i.i, double 6.000000e+00
  %.12.i254.i.i = fcmp ogt double %.13.i141.i.i, 1.000000e-02
  %.13.i255.i.i = select i1 %.12.i254.i.i, double %.13.i141.i.i, double 1.000000e-02
  %.4074.i.i = fcmp olt double %storemerge.i213.i.i, %.13.i131.i.i
  br i1 %.4074.i.i, label %B1614.i.i, label %B1652.i.i
for.end.i.i:
  %storemerge.i262.i.i = phi double [ 0x7FF0000000000000, %B982.endif.thread.i.i ], [ %worst.3.1.i.i.i, %B982.endif.i.i ]
  %.4231.le.i.i = fsub double %storemerge.i262.i.i, %storemerge.i262.i.i
  %.4232.le.i.i = fcmp ord double %.4231.le.i.i, 0.000000e+00
  br i1 %.4232.le.i.i, label %B1746.endif.i.i, label %B1850.i.i
B1746.endif.i.i:
  %.4254.i.i = tail call double @llvm.pow.f64(double %storemerge.i262.i.i, double -2.500000e-01)
  %.4257.i.i = fmul double %.4254.i.i, 9.000000e-01
  %.12.i146.i.i = fcmp olt double %.4257.i.i, 8.000000e-01
  %.13.i147.i.i = select i1 %.12.i146.i.i, double %.4257.i.i, double 8.000000e-01
  %.12.i256.i.i = fcmp ogt double %.13.i147.i.i, 1.500000e-01
  %.13.i257.i.i = select i1 %.12.i256.i.i, double %.13.i147.i.i, double 1.500000e-01
  br label %B1850.i.i
B2014.else.if.i.i:
  %window.3.1.i.i = select i1 %.123.i.i.i, double %t.3.1.i.i, double %window.2.0.i.i
  %.4994.i.i = fcmp olt double %t.3.1.i.i, %"$phi1338.1.2.1.i"
  br i1 %.4994.i.i, label %B460.i.i, label %_ZN6poppet6engine10integrator8_segmentB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i
_ZN6poppet6engine10integrator8_segmentB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i:
  %.4280.sroa.12.2.i = phi double [ %"$phi1540.1.2.1.i", %B446.i.i ], [ %h.6.1.i.i, %B2004.split.loop.exit.i.i ], [ %storemerge.i213.i.i, %_ZN6poppet6engine10integrator5_takeB3v20B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i.i ], [ %.4325.i.i, %B1850.i.i ], [ %h.6.1.i.i, %B108.i.i.i ], [ %h.6.1.i.i, %B2014.else.if.i.i ]
  %.4280.sroa.7.2.i = phi double [ %.3647.i, %B446.i.i ], [ %t.3.1.i.i, %B2004.split.loop.exit.i.i ], [ %end.2.1.i.i, %_ZN6poppet6engine10integrator5_takeB3v20B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i.i ], [ %t.2.0.i.i, %B1850.i.i ], [ %t.3.1.i.i, %B108.i.i.i ], [ %t.3.1.i.i, %B2014.else.if.i.i ]
  %.4280.sroa.0.2.i = phi i64 [ 0, %B446.i.i ], [ %.mux.le.i.i, %B2004.split.loop.exit.i.i ], [ 1, %_ZN6poppet6engine10integrator5_takeB3v20B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i.i ], [ 2, %B1850.i.i ], [ 2, %B108.i.i.i ], [ 0, %B2014.else.if.i.i ]
  %.4585.not.i = icmp eq i64 %.4280.sroa.0.2.i, 0
  br i1 %.4585.not.i, label %B1768.i, label %B1772.i
B1656.i:
  %.4425.i = load i64, ptr %sunkaddr432.i, align 8, !noalias !0
  %.4476.i = mul i64 %.357625792586.i, %.986.i
  %.4478.i = getelementptr double, ptr %a5, i64 %.4476.i
  %.180.i.i = load i64, ptr %.179.i.i, align 8, !noalias !63
  %.188.i.i = icmp slt i64 %.180.i.i, %.69.i
  br i1 %.188.i.i, label %B38.i.i, label %B1768.i
B38.i.i:
  %.233.i.i = icmp slt i64 %.180.i.i, 0
  %.234.i.i = select i1 %.233.i.i, i64 %.69.i, i64 0
  %34 = getelementptr double, ptr %a7, i64 %.180.i.i
  %.248.i.i = getelementptr double, ptr %34, i64 %.234.i.i
  %.249.i.i = load double, ptr %.248.i.i, align 8, !noalias !63
  %.251.i.i = fcmp olt double %.249.i.i, %"$phi1338.1.2.1.i"
  br i1 %.251.i.i, label %B74.preheader.i.i, label %B1768.i
B74.preheader.i.i:
  %scevgep.i.i.i = getelementptr i8, ptr %.4478.i, i64 40
  %35 = inttoptr i64 %.4425.i to ptr
  br label %B74.i.i
B74.i.i:
  %.286.i.i = phi i64 [ %.518.i.i, %B282.i.i ], [ %.180.i.i, %B74.preheader.i.i ]
  %.300.i.i = icmp slt i64 %.286.i.i, 0
  %.301.i.i = select i1 %.300.i.i, i64 %.69.i, i64 0
  %36 = getelementptr double, ptr %a7, i64 %.286.i.i
  %.315.i.i = getelementptr double, ptr %36, i64 %.301.i.i
  %.316.i.i = load double, ptr %.315.i.i, align 8, !noalias !63
  %.40.i.i5.i = fsub double %.316.i.i, %.3647.i
  br i1 %56, label %B74.endif.i.i, label %B56.i.i6.i
B56.i.i6.i:
  %lsr.iv.i.i7.i = phi ptr [ %scevgep1.i.i22.i, %B316.i.i19.i ], [ %scevgep.i.i.i, %B74.i.i ]
  %.138222224.i.i8.i = phi i64 [ %.145.i.i9.i, %B316.i.i19.i ], [ 0, %B74.i.i ]
  %.145.i.i9.i = add nuw nsw i64 %.138222224.i.i8.i, 1
  %scevgep6.i.i10.i = getelementptr i8, ptr %lsr.iv.i.i7.i, i64 -40
  %.227.i.i11.i = load double, ptr %scevgep6.i.i10.i, align 8, !noalias !66
  %scevgep5.i.i12.i = getelementptr i8, ptr %lsr.iv.i.i7.i, i64 -32
  %.282.i.i13.i = load double, ptr %scevgep5.i.i12.i, align 8, !noalias !66
  %.284.i.i14.i = fmul double %.40.i.i5.i, %.282.i.i13.i
  %.285.i.i15.i = fadd double %.227.i.i11.i, %.284.i.i14.i
  %scevgep4.i.i16.i = getelementptr i8, ptr %lsr.iv.i.i7.i, i64 -24
  %.347.i.i17.i = load double, ptr %scevgep4.i.i16.i, align 8, !noalias !66
  %.348.i.i18.i = fcmp une double %.347.i.i17.i, 0.000000e+00
  br i1 %.348.i.i18.i, label %B134.i.i25.i, label %B316.i.i19.i
B134.i.i25.i:
  %scevgep3.i.i26.i = getelementptr i8, ptr %lsr.iv.i.i7.i, i64 -16
  %.405.i.i27.i = load double, ptr %scevgep3.i.i26.i, align 8, !noalias !66
  %scevgep2.i.i28.i = getelementptr i8, ptr %lsr.iv.i.i7.i, i64 -8
  %.460.i.i29.i = load double, ptr %scevgep2.i.i28.i, align 8, !noalias !66
  %.461.i.i30.i = fmul double %.460.i.i29.i, 5.000000e-01
  %.463.i.i31.i = fmul double %.40.i.i5.i, %.461.i.i30.i
  %.464.i.i32.i = fadd double %.405.i.i27.i, %.463.i.i31.i
  %.465.i.i33.i = fmul double %.464.i.i32.i, 0x401921FB54442D18
  %.467.i.i34.i = fmul double %.40.i.i5.i, %.465.i.i33.i
  %.522.i.i35.i = load double, ptr %lsr.iv.i.i7.i, align 8, !noalias !66
  %.523.i.i36.i = fadd double %.522.i.i35.i, %.467.i.i34.i
  %.586.le.i.i37.i = tail call double @llvm.sin.f64(double %.523.i.i36.i)
  %.591.i.i38.i = fmul double %.347.i.i17.i, %.586.le.i.i37.i
  %.593.i.i39.i = fadd double %.285.i.i15.i, %.591.i.i38.i
  br label %B316.i.i19.i
B316.i.i19.i:
  %value.2.1.i.i20.i = phi double [ %.593.i.i39.i, %B134.i.i25.i ], [ %.285.i.i15.i, %B56.i.i6.i ]
  %37 = shl i64 %.138222224.i.i8.i, 3
  %scevgep7.i.i21.i = getelementptr i8, ptr %.1528.i, i64 %37
  store double %value.2.1.i.i20.i, ptr %scevgep7.i.i21.i, align 8, !noalias !66
  %scevgep1.i.i22.i = getelementptr i8, ptr %lsr.iv.i.i7.i, i64 48
  %exitcond.not.i.i23.i = icmp eq i64 %.1503.i, %.145.i.i9.i
  br i1 %exitcond.not.i.i23.i, label %B74.endif.loopexit.i.i, label %B56.i.i6.i
B282.i.i:
  %.631.i.i = icmp slt i64 %.517.i.i, -1
  %.632.i.i = select i1 %.631.i.i, i64 %.69.i, i64 0
  %38 = getelementptr double, ptr %a7, i64 %.518.i.i
  %.646.i.i = getelementptr double, ptr %38, i64 %.632.i.i
  %.647.i.i = load double, ptr %.646.i.i, align 8, !noalias !63
  %.649.i.i = fcmp olt double %.647.i.i, %"$phi1338.1.2.1.i"
  br i1 %.649.i.i, label %B74.i.i, label %B1768.i
B74.endif.loopexit.i.i:
  %.382.pre.i.i = load i64, ptr %.179.i.i, align 8, !noalias !63
  br label %B74.endif.i.i
B74.endif.i.i:
  %.382.i.i = phi i64 [ %.382.pre.i.i, %B74.endif.loopexit.i.i ], [ %.286.i.i, %B74.i.i ]
  %.396.i.i = icmp slt i64 %.382.i.i, 0
  %.397.i.i = select i1 %.396.i.i, i64 %.69.i, i64 0
  %39 = getelementptr double, ptr %a7, i64 %.382.i.i
  %.411.i.i = getelementptr double, ptr %39, i64 %.397.i.i
  %.412.i.i = load double, ptr %.411.i.i, align 8, !noalias !63
  store double %.412.i.i, ptr %.2042.i, align 8, !noalias !69
  tail call void %35(ptr nonnull %.2042.i, ptr %a2, ptr %.1528.i, ptr %a3, ptr %.3062.i), !noalias !69
  br i1 %66, label %B74.endif.endif.i.i, label %B96.lr.ph.i.i.i
B96.lr.ph.i.i.i:
  br i1 %67, label %B96.epil.preheader.i.i.i, label %B96.lr.ph.new.i.i.i
B96.lr.ph.new.i.i.i:
  %invariant.gep.i.i24.i = getelementptr double, ptr %a13, i64 %.382.i.i
  %invariant.gep159.i.i.i = getelementptr double, ptr %invariant.gep.i.i24.i, i64 %.397.i.i
  br i1 %68, label %B96.i.epil.preheader.i.i, label %B96.i.i.i
B96.i.i.i:
  %lsr.iv1.i.i = phi i64 [ %lsr.iv.next2.i.i, %B96.i.i.i ], [ %65, %B96.lr.ph.new.i.i.i ]
  %lsr.iv13.i.i.i = phi ptr [ %scevgep32.i.i, %B96.i.i.i ], [ %invariant.gep159.i.i.i, %B96.lr.ph.new.i.i.i ]
  %.259154156.i.i.i = phi i64 [ %.266.3.i.1.i.i, %B96.i.i.i ], [ 0, %B96.lr.ph.new.i.i.i ]
  %sunkaddr18.i.i = shl i64 %.259154156.i.i.i, 3
  %sunkaddr19.i.i = getelementptr i8, ptr %.3062.i, i64 %sunkaddr18.i.i
  %.320.i.i.i = load double, ptr %sunkaddr19.i.i, align 8, !noalias !69
  store double %.320.i.i.i, ptr %lsr.iv13.i.i.i, align 8, !noalias !69
  %sunkaddr22.i.i = getelementptr i8, ptr %sunkaddr19.i.i, i64 8
  %.320.1.i.i.i = load double, ptr %sunkaddr22.i.i, align 8, !noalias !69
  %sunkaddr23.i.i.i = getelementptr i8, ptr %lsr.iv13.i.i.i, i64 %.16.i.i
  store double %.320.1.i.i.i, ptr %sunkaddr23.i.i.i, align 8, !noalias !69
  %sunkaddr25.i.i = getelementptr i8, ptr %sunkaddr19.i.i, i64 16
  %.320.2.i.i.i = load double, ptr %sunkaddr25.i.i, align 8, !noalias !69
  %scevgep26.i.i = getelementptr i8, ptr %sunkaddr23.i.i.i, i64 %.16.i.i
  store double %.320.2.i.i.i, ptr %scevgep26.i.i, align 8, !noalias !69
  %sunkaddr28.i.i = getelementptr i8, ptr %sunkaddr19.i.i, i64 24
  %.320.3.i.i.i = load double, ptr %sunkaddr28.i.i, align 8, !noalias !69
  %scevgep27.i.i = getelementptr i8, ptr %scevgep26.i.i, i64 %.16.i.i
  store double %.320.3.i.i.i, ptr %scevgep27.i.i, align 8, !noalias !69
  %sunkaddr31.i.i = getelementptr i8, ptr %sunkaddr19.i.i, i64 32
  %.320.i.1.i.i = load double, ptr %sunkaddr31.i.i, align 8, !noalias !69
  %scevgep28.i.i = getelementptr i8, ptr %scevgep27.i.i, i64 %.16.i.i
  store double %.320.i.1.i.i, ptr %scevgep28.i.i, align 8, !noalias !69
  %sunkaddr34.i.i = getelementptr i8, ptr %sunkaddr19.i.i, i64 40
  %.320.1.i.1.i.i = load double, ptr %sunkaddr34.i.i, align 8, !noalias !69
  %scevgep29.i.i = getelementptr i8, ptr %scevgep28.i.i, i64 %.16.i.i
  store double %.320.1.i.1.i.i, ptr %scevgep29.i.i, align 8, !noalias !69
  %sunkaddr37.i.i = getelementptr i8, ptr %sunkaddr19.i.i, i64 48
  %.320.2.i.1.i.i = load double, ptr %sunkaddr37.i.i, align 8, !noalias !69
  %scevgep30.i.i = getelementptr i8, ptr %scevgep29.i.i, i64 %.16.i.i
  store double %.320.2.i.1.i.i, ptr %scevgep30.i.i, align 8, !noalias !69
  %.266.3.i.1.i.i = add i64 %.259154156.i.i.i, 8
  %sunkaddr38.i.i = shl i64 %.266.3.i.1.i.i, 3
  %sunkaddr39.i.i = getelementptr i8, ptr %.3062.i, i64 %sunkaddr38.i.i
  %sunkaddr40.i.i = getelementptr i8, ptr %sunkaddr39.i.i, i64 -8
  %.320.3.i.1.i.i = load double, ptr %sunkaddr40.i.i, align 8, !noalias !69
  %scevgep31.i.i = getelementptr i8, ptr %scevgep30.i.i, i64 %.16.i.i
  store double %.320.3.i.1.i.i, ptr %scevgep31.i.i, align 8, !noalias !69
  %scevgep32.i.i = getelementptr i8, ptr %scevgep31.i.i, i64 %.16.i.i
  %lsr.iv.next2.i.i = add i64 %lsr.iv1.i.i, 2
  %niter.ncmp.1.i.i = icmp eq i64 %lsr.iv.next2.i.i, 0
  br i1 %niter.ncmp.1.i.i, label %B126.loopexit.unr-lcssa.i.unr-lcssa.i.i, label %B96.i.i.i
B126.loopexit.unr-lcssa.i.unr-lcssa.i.i:
  %scevgep14.i.i.i = getelementptr i8, ptr %lsr.iv13.i.i.i, i64 %59
  %scevgep14.i.1.i.i = getelementptr i8, ptr %scevgep14.i.i.i, i64 %59
  br i1 %70, label %B96.i.epil.preheader.i.i, label %B126.loopexit.unr-lcssa.i.i.i
B96.i.epil.preheader.i.i:
  %lsr.iv13.i.epil.init.i.i = phi ptr [ %invariant.gep159.i.i.i, %B96.lr.ph.new.i.i.i ], [ %scevgep14.i.1.i.i, %B126.loopexit.unr-lcssa.i.unr-lcssa.i.i ]
  %.259154156.i.epil.init.i.i = phi i64 [ 0, %B96.lr.ph.new.i.i.i ], [ %.266.3.i.1.i.i, %B126.loopexit.unr-lcssa.i.unr-lcssa.i.i ]
  %sunkaddr.i.epil.i.i = shl i64 %.259154156.i.epil.init.i.i, 3
  %sunkaddr18.i.epil.i.i = getelementptr i8, ptr %.3062.i, i64 %sunkaddr.i.epil.i.i
  %.320.i.epil.i.i = load double, ptr %sunkaddr18.i.epil.i.i, align 8, !noalias !69
  store double %.320.i.epil.i.i, ptr %lsr.iv13.i.epil.init.i.i, align 8, !noalias !69
  %sunkaddr21.i.epil.i.i = getelementptr i8, ptr %sunkaddr18.i.epil.i.i, i64 8
  %.320.1.i.epil.i.i = load double, ptr %sunkaddr21.i.epil.i.i, align 8, !noalias !69
  %sunkaddr23.i.epil.i.i = getelementptr i8, ptr %lsr.iv13.i.epil.init.i.i, i64 %.16.i.i
  store double %.320.1.i.epil.i.i, ptr %sunkaddr23.i.epil.i.i, align 8, !noalias !69
  %sunkaddr26.i.epil.i.i = getelementptr i8, ptr %sunkaddr18.i.epil.i.i, i64 16
  %.320.2.i.epil.i.i = load double, ptr %sunkaddr26.i.epil.i.i, align 8, !noalias !69
  %scevgep16.i.epil.i.i = getelementptr i8, ptr %lsr.iv13.i.epil.init.i.i, i64 %60
  store double %.320.2.i.epil.i.i, ptr %scevgep16.i.epil.i.i, align 8, !noalias !69
  %sunkaddr29.i.epil.i.i = getelementptr i8, ptr %sunkaddr18.i.epil.i.i, i64 24
  %.320.3.i.epil.i.i = load double, ptr %sunkaddr29.i.epil.i.i, align 8, !noalias !69
  %scevgep15.i.epil.i.i = getelementptr i8, ptr %lsr.iv13.i.epil.init.i.i, i64 %58
  store double %.320.3.i.epil.i.i, ptr %scevgep15.i.epil.i.i, align 8, !noalias !69
  br label %B126.loopexit.unr-lcssa.i.i.i
B126.loopexit.unr-lcssa.i.i.i:
  br i1 %71, label %B74.endif.endif.i.i, label %B96.epil.preheader.i.i.i
B96.epil.preheader.i.i.i:
  %.259154156.epil.init.i.i.i = phi i64 [ %unroll_iter.i.i.i, %B126.loopexit.unr-lcssa.i.i.i ], [ 0, %B96.lr.ph.i.i.i ]
  %40 = mul i64 %.259154156.epil.init.i.i.i, %.69.i
  %41 = add i64 %.397.i.i, %.382.i.i
  %42 = add i64 %41, %40
  %43 = shl i64 %42, 3
  %scevgep.i4.i.i = getelementptr i8, ptr %a13, i64 %43
  %44 = shl i64 %.259154156.epil.init.i.i.i, 3
  %scevgep3.i5.i.i = getelementptr i8, ptr %.3062.i, i64 %44
  br label %B96.epil.i.i.i
B96.epil.i.i.i:
  %lsr.iv.i6.i.i = phi ptr [ %scevgep2.i8.i.i, %B96.epil.i.i.i ], [ %scevgep.i4.i.i, %B96.epil.preheader.i.i.i ]
  %epil.iter.i.i.i = phi i64 [ %epil.iter.next.i.i.i, %B96.epil.i.i.i ], [ 0, %B96.epil.preheader.i.i.i ]
  %45 = shl i64 %epil.iter.i.i.i, 3
  %scevgep33.i.i = getelementptr i8, ptr %scevgep3.i5.i.i, i64 %45
  %.320.epil.i.i.i = load double, ptr %scevgep33.i.i, align 8, !noalias !69
  store double %.320.epil.i.i.i, ptr %lsr.iv.i6.i.i, align 8, !noalias !69
  %epil.iter.next.i.i.i = add i64 %epil.iter.i.i.i, 1
  %scevgep2.i8.i.i = getelementptr i8, ptr %lsr.iv.i6.i.i, i64 %.16.i.i
  %epil.iter.cmp.not.i.i.i = icmp eq i64 %xtraiter.i.i.i, %epil.iter.next.i.i.i
  br i1 %epil.iter.cmp.not.i.i.i, label %B74.endif.endif.i.i, label %B96.epil.i.i.i, !llvm.loop !72
B74.endif.endif.i.i:
  %.517.i.i = load i64, ptr %.179.i.i, align 8, !noalias !63
  %.518.i.i = add nsw i64 %.517.i.i, 1
  store i64 %.518.i.i, ptr %.179.i.i, align 8, !noalias !63
  %.586.i.i = icmp slt i64 %.518.i.i, %.69.i
  br i1 %.586.i.i, label %B282.i.i, label %B1768.i
B1768.i:
  %h.4.12529.i = phi double [ %.4280.sroa.12.2.i, %_ZN6poppet6engine10integrator8_segmentB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i ], [ %"$phi1540.1.2.1.i", %B1656.i ], [ %"$phi1540.1.2.1.i", %B38.i.i ], [ %"$phi1540.1.2.1.i", %B282.i.i ], [ %"$phi1540.1.2.1.i", %B74.endif.endif.i.i ]
  %t.6.12528.i = phi double [ %.4280.sroa.7.2.i, %_ZN6poppet6engine10integrator8_segmentB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i ], [ %"$phi1338.1.2.1.i", %B1656.i ], [ %"$phi1338.1.2.1.i", %B38.i.i ], [ %"$phi1338.1.2.1.i", %B282.i.i ], [ %"$phi1338.1.2.1.i", %B74.endif.endif.i.i ]
  %exitcond2609.not.i = icmp eq i64 %.3583.i, %.31.i
  br i1 %exitcond2609.not.i, label %B1772.i, label %B1260.i
B1772.i:
  %status.5.1.i = phi i64 [ 0, %B1172.endif.i ], [ 1, %B1352.endif.endif.i ], [ %.4280.sroa.0.2.i, %_ZN6poppet6engine10integrator8_segmentB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i ], [ 0, %B1768.i ]
  %t.4.1.i = phi double [ %.3452.i, %B1172.endif.i ], [ %.3647.i, %B1352.endif.endif.i ], [ %.4280.sroa.7.2.i, %_ZN6poppet6engine10integrator8_segmentB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i ], [ %t.6.12528.i, %B1768.i ]
  %k.2.1.i = phi i64 [ 0, %B1172.endif.i ], [ %.357625792586.i, %B1352.endif.endif.i ], [ %.357625792586.i, %_ZN6poppet6engine10integrator8_segmentB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i ], [ %.357625792586.i, %B1768.i ]
  %switch.i = icmp ult i64 %status.5.1.i, 2
  br i1 %switch.i, label %B1816.i, label %_ZN6poppet6engine10integrator9integrateB2v1B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAg6cJqBrMeIZJFEGM0QQAE8int64_2a8int64_2a10float64_2a10float64_2a10float64_2a10float64_2a8uint8_2a10float64_2a10float64_2a8uint8_2a10float64_2a8int64_2a10float64_2a10float64_2a10float64_2a10float64_2a8int64_2a10float64_2a.exit
B1816.i:
  %46 = getelementptr double, ptr %a4, i64 %k.2.1.i
  %.4827.i = load double, ptr %46, align 8, !noalias !0
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
  %.227.i16.i = load double, ptr %scevgep6.i15.i, align 8, !noalias !73
  %scevgep5.i17.i = getelementptr i8, ptr %lsr.iv.i12.i, i64 -32
  %.282.i18.i = load double, ptr %scevgep5.i17.i, align 8, !noalias !73
  %.284.i19.i = fmul double %.40.i7.i, %.282.i18.i
  %.285.i20.i = fadd double %.227.i16.i, %.284.i19.i
  %scevgep4.i21.i = getelementptr i8, ptr %lsr.iv.i12.i, i64 -24
  %.347.i22.i = load double, ptr %scevgep4.i21.i, align 8, !noalias !73
  %.348.i23.i = fcmp une double %.347.i22.i, 0.000000e+00
  br i1 %.348.i23.i, label %B134.i29.i, label %B316.i24.i
B134.i29.i:
  %scevgep3.i30.i = getelementptr i8, ptr %lsr.iv.i12.i, i64 -16
  %.405.i31.i = load double, ptr %scevgep3.i30.i, align 8, !noalias !73
  %scevgep2.i32.i = getelementptr i8, ptr %lsr.iv.i12.i, i64 -8
  %.460.i33.i = load double, ptr %scevgep2.i32.i, align 8, !noalias !73
  %.461.i34.i = fmul double %.460.i33.i, 5.000000e-01
  %.463.i35.i = fmul double %.40.i7.i, %.461.i34.i
  %.464.i36.i = fadd double %.405.i31.i, %.463.i35.i
  %.465.i37.i = fmul double %.464.i36.i, 0x401921FB54442D18
  %.467.i38.i = fmul double %.40.i7.i, %.465.i37.i
  %.522.i39.i = load double, ptr %lsr.iv.i12.i, align 8, !noalias !73
  %.523.i40.i = fadd double %.522.i39.i, %.467.i38.i
  %.586.le.i41.i = tail call double @llvm.sin.f64(double %.523.i40.i)
  %.591.i42.i = fmul double %.347.i22.i, %.586.le.i41.i
  %.593.i43.i = fadd double %.285.i20.i, %.591.i42.i
  br label %B316.i24.i
B316.i24.i:
  %value.2.1.i25.i = phi double [ %.593.i43.i, %B134.i29.i ], [ %.285.i20.i, %B56.i11.i ]
  %47 = shl i64 %lsr.iv404.i, 3
  %scevgep406.i = getelementptr i8, ptr %.1343.i, i64 %47
  store double %value.2.1.i25.i, ptr %scevgep406.i, align 8, !noalias !73
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
  %48 = tail call i64 @llvm.umin.i64(i64 %.2026.i, i64 2)
  %.2438.i = icmp slt i64 %.73.i, -2
  %.2439.i = select i1 %.2438.i, i64 %.2026.i, i64 0
  %.2440.i = add i64 %.23852611.i, %.2439.i
  %.2443.i = icmp slt i64 %.2440.i, 0
  %.2448.not.i = icmp slt i64 %.2440.i, %.2026.i
  %.2524.i = getelementptr double, ptr %.2042.i, i64 %48
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
  %49 = icmp eq i64 %.23.i, 1
  br i1 %49, label %B1094.epil.preheader.i, label %B1094.lr.ph.new.i
B1094.lr.ph.new.i:
  %unroll_iter.i = and i64 %.23.i, 9223372036854775806
  %scevgep410.i = getelementptr i8, ptr %a2, i64 8
  %scevgep414.i = getelementptr i8, ptr %a14, i64 8
  %sunkaddr.i = shl i64 %.23.i, 3
  br label %B1094.i
B1172.endif.loopexit.unr-lcssa.i:
  %50 = and i64 %.23.i, 1
  %lcmp.mod.not.i = icmp eq i64 %50, 0
  br i1 %lcmp.mod.not.i, label %B1172.endif.i, label %B1094.epil.preheader.i
B1094.epil.preheader.i:
  %.320125682570.epil.init.i = phi i64 [ 0, %B1094.lr.ph.i ], [ %unroll_iter.i, %B1172.endif.loopexit.unr-lcssa.i ]
  %51 = getelementptr double, ptr %a2, i64 %.320125682570.epil.init.i
  %.3262.epil.i = load double, ptr %51, align 8, !noalias !0
  %52 = getelementptr double, ptr %a14, i64 %.320125682570.epil.init.i
  store double %.3262.epil.i, ptr %52, align 8, !noalias !0
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
  %53 = getelementptr double, ptr %a7, i64 %.69.i
  %54 = getelementptr i8, ptr %53, i64 -8
  %.3722.i = getelementptr double, ptr %54, i64 %.3708.i
  %scevgep.i134.i = getelementptr i8, ptr %a11, i64 8
  %scevgep3.i135.i = getelementptr i8, ptr %a12, i64 16
  %55 = icmp sgt i64 %.71.i, 0
  %56 = icmp slt i64 %.1503.i, 1
  %sunkaddr432.i = getelementptr i8, ptr %a0, i64 24
  %57 = icmp sgt i64 %.23.i, 0
  %.179.i.i = getelementptr i8, ptr %a16, i64 16
  %xtraiter.i.i.i = and i64 %.3046.i, 3
  %unroll_iter.i.i.i = and i64 %.3046.i, 9223372036854775804
  %58 = mul i64 %.69.i, 24
  %59 = shl i64 %.69.i, 5
  %60 = shl i64 %.69.i, 4
  %61 = add nsw i64 %unroll_iter.i.i.i, -4
  %62 = lshr exact i64 %61, 2
  %63 = add nuw nsw i64 %62, 1
  %64 = lshr i64 %63, 1
  %65 = mul nsw i64 %64, -2
  %66 = icmp slt i64 %.3037.i, 1
  %67 = icmp slt i64 %.3037.i, 4
  %68 = icmp eq i64 %61, 0
  %69 = and i64 %61, 4
  %70 = icmp eq i64 %69, 0
  %71 = icmp eq i64 %xtraiter.i.i.i, 0
  %.572.i.i = shl nuw nsw i64 %.23.i, 1
  %72 = icmp sgt i64 %.1146.i, %.23.i
  %.635.not.i.i = icmp sgt i64 %.1146.i, %.572.i.i
  %.744.i.i = mul nuw nsw i64 %.23.i, 3
  %.807.not.i.i = icmp sgt i64 %.1146.i, %.744.i.i
  %.916.i.i = shl nsw i64 %.23.i, 2
  %.979.not.i.i = icmp sgt i64 %.1146.i, %.916.i.i
  %.1232.i.i = mul nuw nsw i64 %.23.i, 6
  %.1295.not.i.i = icmp sgt i64 %.1146.i, %.1232.i.i
  %.1574.i.i = mul nuw nsw i64 %.23.i, 11
  %.1620.not.i.i = icmp sgt i64 %.1146.i, %.1574.i.i
  %.arg.coefficients.5.0.i.i.i = tail call i64 @llvm.smax.i64(i64 %.27.i, i64 0)
  %73 = add nuw i64 %.arg.coefficients.5.0.i.i.i, 1
  %.idx.i.i.i = shl i64 %.25.i, 4
  %74 = getelementptr i8, ptr %a8, i64 %.idx.i.i.i
  %75 = shl i64 %.25.i, 3
  %scevgep157.i.i = getelementptr i8, ptr %a8, i64 %75
  %76 = icmp slt i64 %.1846.i, 1
  %77 = icmp slt i64 %.25.i, 1
  %sunkaddr160.i.i = getelementptr i8, ptr %.2042.i, i64 8
  %sunkaddr.i2.i = getelementptr i8, ptr %a0, i64 8
  %sunkaddr174.i.i = getelementptr i8, ptr %a16, i64 8
  %sunkaddr163.i.i = getelementptr i8, ptr %a0, i64 16
  %78 = and i64 %63, 9223372036854775806
  %.idx.i6.i.i = shl i64 %.23.i, 4
  %invariant.gep.i.i.i = getelementptr i8, ptr %a14, i64 %.idx.i6.i.i
  %invariant.gep645.i.i.i = getelementptr double, ptr %a14, i64 %.23.i
  %sunkaddr166.i.i = getelementptr i8, ptr %a7, i64 %.16.i.i
  %sunkaddr167.i.i = getelementptr i8, ptr %sunkaddr166.i.i, i64 -8
  %sunkaddr168.i.i = getelementptr i8, ptr %a15, i64 8
  %sunkaddr172.i.i = getelementptr i8, ptr %a16, i64 32
  %sunkaddr171.i.i = getelementptr i8, ptr %a10, i64 8
  br label %B1260.i
B1352.endif.i:
  %.3895.i = load i64, ptr %sunkaddr432.i, align 8, !noalias !0
  store double %.3647.i, ptr %.2042.i, align 8, !noalias !76
  %.168.i.i = inttoptr i64 %.3895.i to ptr
  tail call void %.168.i.i(ptr nonnull %.2042.i, ptr %a2, ptr %.1528.i, ptr %a3, ptr %.3062.i), !noalias !76
  br label %B108.endif.endif.i.i
B106.i.i:
  %.291.i.i = add nuw i64 %.284326331.i.i, 1
  %scevgep1.i138.i = getelementptr i8, ptr %lsr.iv.i136.i, i64 16
  %scevgep5.i139.i = getelementptr i8, ptr %lsr.iv4.i.i, i64 24
  %exitcond.not.i140.i = icmp eq i64 %.71.i, %.291.i.i
  br i1 %exitcond.not.i140.i, label %B1352.endif.endif.thread.i, label %B108.endif.endif.i.i
B192.i.i:
  %sunkaddr.i.i = getelementptr i8, ptr %lsr.iv4.i.i, i64 -16
  %.612.i.i = load double, ptr %sunkaddr.i.i, align 8, !noalias !76
  %.701.i.i = getelementptr double, ptr %.3062.i, i64 %.554.i.i
  %.702.i.i = load double, ptr %.701.i.i, align 8, !noalias !76
  %.703.i.i = fmul double %.612.i.i, %.702.i.i
  %.705.i.i = fadd double %.373.i.i, %.703.i.i
  br label %B252.i.i
B252.i.i:
  %value.3.2.i.i = phi double [ %.705.i.i, %B192.i.i ], [ %.373.i.i, %B108.endif.endif.i.i ]
  %.554.1.i.i = load i64, ptr %lsr.iv.i136.i, align 8, !noalias !76
  %.557.1.i.i = icmp sgt i64 %.554.1.i.i, -1
  br i1 %.557.1.i.i, label %B192.1.i.i, label %B252.1.i.i
B192.1.i.i:
  %scevgep6.i141.i = getelementptr i8, ptr %lsr.iv4.i.i, i64 -8
  %.612.1.i.i = load double, ptr %scevgep6.i141.i, align 8, !noalias !76
  %.701.1.i.i = getelementptr double, ptr %.3062.i, i64 %.554.1.i.i
  %.702.1.i.i = load double, ptr %.701.1.i.i, align 8, !noalias !76
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
  %.373.i.i = load double, ptr %lsr.iv4.i.i, align 8, !noalias !76
  %scevgep2.i137.i = getelementptr i8, ptr %lsr.iv.i136.i, i64 -8
  %.554.i.i = load i64, ptr %scevgep2.i137.i, align 8, !noalias !76
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
  store double %t.4.1.i, ptr %.2042.i, align 8, !noalias !79
  %.151.i.i = inttoptr i64 %.5093.i to ptr
  tail call void %.151.i.i(ptr nonnull %.2042.i, ptr %a2, ptr %.1528.i, ptr %a3, ptr %.3062.i), !noalias !79
  %.253155.not.i.i = icmp slt i64 %.3037.i, 1
  br i1 %.253155.not.i.i, label %B1816.endif.endif.endif.i, label %B96.lr.ph.i.i
B96.lr.ph.i.i:
  %.349.i.i = icmp slt i64 %.13.i.i, 0
  %.350.i.i = select i1 %.349.i.i, i64 %.69.i, i64 0
  %xtraiter.i.i = and i64 %.3046.i, 3
  %79 = icmp ult i64 %.3037.i, 4
  br i1 %79, label %B96.epil.preheader.i.i, label %B96.lr.ph.new.i.i
B96.lr.ph.new.i.i:
  %invariant.gep.i.i = getelementptr double, ptr %a13, i64 %.13.i.i
  %invariant.gep159.i.i = getelementptr double, ptr %invariant.gep.i.i, i64 %.350.i.i
  %unroll_iter.i.i = and i64 %.3046.i, 9223372036854775804
  %80 = mul i64 %.69.i, 24
  %81 = shl i64 %.69.i, 5
  %82 = shl i64 %.69.i, 4
  %83 = add nsw i64 %.3046.i, -4
  %84 = lshr i64 %83, 2
  %85 = icmp eq i64 %84, 0
  br i1 %85, label %B96.i.epil.preheader.i, label %B96.lr.ph.new.i.new.i
B96.lr.ph.new.i.new.i:
  %86 = add nuw nsw i64 %84, 1
  %unroll_iter367.i = and i64 %86, 9223372036854775806
  %87 = add i64 %.1929.sroa.0.3.i, %.1230.sroa.0.3.i
  %88 = add i64 %87, %.2582.sroa.0.3.i
  %89 = add i64 %88, %.2949.sroa.0.3.i
  %90 = shl i64 %89, 3
  %91 = getelementptr i8, ptr %a17, i64 %90
  %scevgep381.i = getelementptr i8, ptr %91, i64 56
  br label %B96.i.i
B96.i.i:
  %lsr.iv.i = phi i64 [ %lsr.iv.next.i, %B96.i.i ], [ %unroll_iter367.i, %B96.lr.ph.new.i.new.i ]
  %lsr.iv13.i.i = phi ptr [ %scevgep403.i, %B96.i.i ], [ %invariant.gep159.i.i, %B96.lr.ph.new.i.new.i ]
  %.259154156.i.i = phi i64 [ %.266.3.i.1.i, %B96.i.i ], [ 0, %B96.lr.ph.new.i.new.i ]
  %sunkaddr.i142.i = shl i64 %.259154156.i.i, 3
  %scevgep395.i = getelementptr i8, ptr %scevgep381.i, i64 %sunkaddr.i142.i
  %scevgep396.i = getelementptr i8, ptr %scevgep395.i, i64 -56
  %.320.i.i = load double, ptr %scevgep396.i, align 8, !noalias !79
  store double %.320.i.i, ptr %lsr.iv13.i.i, align 8, !noalias !79
  %scevgep394.i = getelementptr i8, ptr %scevgep395.i, i64 -48
  %.320.1.i.i = load double, ptr %scevgep394.i, align 8, !noalias !79
  %sunkaddr23.i.i = getelementptr i8, ptr %lsr.iv13.i.i, i64 %.16.i.i
  store double %.320.1.i.i, ptr %sunkaddr23.i.i, align 8, !noalias !79
  %scevgep392.i = getelementptr i8, ptr %scevgep395.i, i64 -40
  %.320.2.i.i = load double, ptr %scevgep392.i, align 8, !noalias !79
  %scevgep397.i = getelementptr i8, ptr %sunkaddr23.i.i, i64 %.16.i.i
  store double %.320.2.i.i, ptr %scevgep397.i, align 8, !noalias !79
  %scevgep390.i = getelementptr i8, ptr %scevgep395.i, i64 -32
  %.320.3.i.i = load double, ptr %scevgep390.i, align 8, !noalias !79
  %scevgep398.i = getelementptr i8, ptr %scevgep397.i, i64 %.16.i.i
  store double %.320.3.i.i, ptr %scevgep398.i, align 8, !noalias !79
  %scevgep388.i = getelementptr i8, ptr %scevgep395.i, i64 -24
  %.320.i.1.i = load double, ptr %scevgep388.i, align 8, !noalias !79
  %scevgep399.i = getelementptr i8, ptr %scevgep398.i, i64 %.16.i.i
  store double %.320.i.1.i, ptr %scevgep399.i, align 8, !noalias !79
  %scevgep386.i = getelementptr i8, ptr %scevgep395.i, i64 -16
  %.320.1.i.1.i = load double, ptr %scevgep386.i, align 8, !noalias !79
  %scevgep400.i = getelementptr i8, ptr %scevgep399.i, i64 %.16.i.i
  store double %.320.1.i.1.i, ptr %scevgep400.i, align 8, !noalias !79
  %scevgep384.i = getelementptr i8, ptr %scevgep395.i, i64 -8
  %.320.2.i.1.i = load double, ptr %scevgep384.i, align 8, !noalias !79
  %scevgep401.i = getelementptr i8, ptr %scevgep400.i, i64 %.16.i.i
  store double %.320.2.i.1.i, ptr %scevgep401.i, align 8, !noalias !79
  %.266.3.i.1.i = add nuw i64 %.259154156.i.i, 8
  %.320.3.i.1.i = load double, ptr %scevgep395.i, align 8, !noalias !79
  %scevgep402.i = getelementptr i8, ptr %scevgep401.i, i64 %.16.i.i
  store double %.320.3.i.1.i, ptr %scevgep402.i, align 8, !noalias !79
  %lsr.iv.next.i = add i64 %lsr.iv.i, -2
  %niter368.ncmp.1.i = icmp eq i64 %lsr.iv.next.i, 0
  %scevgep403.i = getelementptr i8, ptr %scevgep402.i, i64 %.16.i.i
  br i1 %niter368.ncmp.1.i, label %B126.loopexit.unr-lcssa.i.unr-lcssa.i, label %B96.i.i
B126.loopexit.unr-lcssa.i.unr-lcssa.i:
  %scevgep14.i.i = getelementptr i8, ptr %lsr.iv13.i.i, i64 %81
  %scevgep14.i.1.i = getelementptr i8, ptr %scevgep14.i.i, i64 %81
  %92 = and i64 %83, 4
  %lcmp.mod365.not.not.i = icmp eq i64 %92, 0
  br i1 %lcmp.mod365.not.not.i, label %B96.i.epil.preheader.i, label %B126.loopexit.unr-lcssa.i.i
B96.i.epil.preheader.i:
  %lsr.iv13.i.epil.init.i = phi ptr [ %invariant.gep159.i.i, %B96.lr.ph.new.i.i ], [ %scevgep14.i.1.i, %B126.loopexit.unr-lcssa.i.unr-lcssa.i ]
  %.259154156.i.epil.init.i = phi i64 [ 0, %B96.lr.ph.new.i.i ], [ %.266.3.i.1.i, %B126.loopexit.unr-lcssa.i.unr-lcssa.i ]
  %sunkaddr.i142.epil.i = shl i64 %.259154156.i.epil.init.i, 3
  %sunkaddr18.i.epil.i = getelementptr i8, ptr %.3062.i, i64 %sunkaddr.i142.epil.i
  %.320.i.epil.i = load double, ptr %sunkaddr18.i.epil.i, align 8, !noalias !79
  store double %.320.i.epil.i, ptr %lsr.iv13.i.epil.init.i, align 8, !noalias !79
  %sunkaddr21.i.epil.i = getelementptr i8, ptr %sunkaddr18.i.epil.i, i64 8
  %.320.1.i.epil.i = load double, ptr %sunkaddr21.i.epil.i, align 8, !noalias !79
  %sunkaddr23.i.epil.i = getelementptr i8, ptr %lsr.iv13.i.epil.init.i, i64 %.16.i.i
  store double %.320.1.i.epil.i, ptr %sunkaddr23.i.epil.i, align 8, !noalias !79
  %sunkaddr26.i.epil.i = getelementptr i8, ptr %sunkaddr18.i.epil.i, i64 16
  %.320.2.i.epil.i = load double, ptr %sunkaddr26.i.epil.i, align 8, !noalias !79
  %scevgep16.i.epil.i = getelementptr i8, ptr %lsr.iv13.i.epil.init.i, i64 %82
  store double %.320.2.i.epil.i, ptr %scevgep16.i.epil.i, align 8, !noalias !79
  %sunkaddr29.i.epil.i = getelementptr i8, ptr %sunkaddr18.i.epil.i, i64 24
  %.320.3.i.epil.i = load double, ptr %sunkaddr29.i.epil.i, align 8, !noalias !79
  %scevgep15.i.epil.i = getelementptr i8, ptr %lsr.iv13.i.epil.init.i, i64 %80
  store double %.320.3.i.epil.i, ptr %scevgep15.i.epil.i, align 8, !noalias !79
  br label %B126.loopexit.unr-lcssa.i.i
B126.loopexit.unr-lcssa.i.i:
  %lcmp.mod.not.i.i = icmp eq i64 %xtraiter.i.i, 0
  br i1 %lcmp.mod.not.i.i, label %B1816.endif.endif.endif.i, label %B96.epil.preheader.i.i
B96.epil.preheader.i.i:
  %.259154156.epil.init.i.i = phi i64 [ %unroll_iter.i.i, %B126.loopexit.unr-lcssa.i.i ], [ 0, %B96.lr.ph.i.i ]
  %93 = mul i64 %.259154156.epil.init.i.i, %.69.i
  %94 = add i64 %.350.i.i, %.13.i.i
  %95 = add i64 %94, %93
  %96 = shl i64 %95, 3
  %scevgep.i143.i = getelementptr i8, ptr %a13, i64 %96
  %97 = add i64 %.1929.sroa.0.3.i, %.1230.sroa.0.3.i
  %98 = add i64 %97, %.2582.sroa.0.3.i
  %99 = add i64 %98, %.2949.sroa.0.3.i
  %100 = add i64 %99, %.259154156.epil.init.i.i
  %101 = shl i64 %100, 3
  %scevgep.i = getelementptr i8, ptr %a17, i64 %101
  br label %B96.epil.i.i
B96.epil.i.i:
  %lsr.iv.i145.i = phi ptr [ %scevgep2.i147.i, %B96.epil.i.i ], [ %scevgep.i143.i, %B96.epil.preheader.i.i ]
  %epil.iter.i.i = phi i64 [ %epil.iter.next.i.i, %B96.epil.i.i ], [ 0, %B96.epil.preheader.i.i ]
  %102 = shl i64 %epil.iter.i.i, 3
  %scevgep380.i = getelementptr i8, ptr %scevgep.i, i64 %102
  %.320.epil.i.i = load double, ptr %scevgep380.i, align 8, !noalias !79
  store double %.320.epil.i.i, ptr %lsr.iv.i145.i, align 8, !noalias !79
  %epil.iter.next.i.i = add i64 %epil.iter.i.i, 1
  %scevgep2.i147.i = getelementptr i8, ptr %lsr.iv.i145.i, i64 %.16.i.i
  %epil.iter.cmp.not.i.i = icmp eq i64 %xtraiter.i.i, %epil.iter.next.i.i
  br i1 %epil.iter.cmp.not.i.i, label %B1816.endif.endif.endif.i, label %B96.epil.i.i, !llvm.loop !82
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
!18 = distinct !{!18, !19, !"_ZN6poppet6engine10integrator6_errorB3v17B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE: %retptr"}
!19 = distinct !{!19, !"_ZN6poppet6engine10integrator6_errorB3v17B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE"}
!20 = !{!21, !23, !8, !1}
!21 = distinct !{!21, !22, !"_ZN6poppet6engine10integrator12_interpolateB3v19B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!22 = distinct !{!22, !"_ZN6poppet6engine10integrator12_interpolateB3v19B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!23 = distinct !{!23, !24, !"_ZN6poppet6engine10integrator12_stop_insideB3v18B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!24 = distinct !{!24, !"_ZN6poppet6engine10integrator12_stop_insideB3v18B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE"}
!25 = !{!26, !23, !8, !1}
!26 = distinct !{!26, !27, !"_ZN6poppet6engine10integrator12_interpolateB3v19B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!27 = distinct !{!27, !"_ZN6poppet6engine10integrator12_interpolateB3v19B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!28 = !{!29, !23, !8, !1}
!29 = distinct !{!29, !30, !"_ZN6poppet6engine10integrator10_inputs_atB2v8B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!30 = distinct !{!30, !"_ZN6poppet6engine10integrator10_inputs_atB2v8B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!31 = !{!32, !23, !8, !1}
!32 = distinct !{!32, !33, !"_ZN6poppet6engine10integrator15_stop_conditionB2v9B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!33 = distinct !{!33, !"_ZN6poppet6engine10integrator15_stop_conditionB2v9B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE"}
!34 = !{!35, !8, !1}
!35 = distinct !{!35, !36, !"_ZN6poppet6engine10integrator5_takeB3v20B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE: %retptr"}
!36 = distinct !{!36, !"_ZN6poppet6engine10integrator5_takeB3v20B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE"}
!37 = !{!38, !35, !8, !1}
!38 = distinct !{!38, !39, !"_ZN6poppet6engine10integrator12_interpolateB3v19B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!39 = distinct !{!39, !"_ZN6poppet6engine10integrator12_interpolateB3v19B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!40 = !{!41, !35, !8, !1}
!41 = distinct !{!41, !42, !"_ZN6poppet6engine10integrator10_inputs_atB2v8B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!42 = distinct !{!42, !"_ZN6poppet6engine10integrator10_inputs_atB2v8B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!43 = !{!44, !35, !8, !1}
!44 = distinct !{!44, !45, !"_ZN6poppet6engine10integrator6_writeB3v21B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedEx: %retptr"}
!45 = distinct !{!45, !"_ZN6poppet6engine10integrator6_writeB3v21B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedEx"}
!46 = distinct !{!46, !47}
!47 = !{!"llvm.loop.unroll.disable"}
!48 = !{!49, !8, !1}
!49 = distinct !{!49, !50, !"_ZN6poppet6engine10integrator8_verdictB3v23B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEddd5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEb: %retptr"}
!50 = distinct !{!50, !"_ZN6poppet6engine10integrator8_verdictB3v23B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEddd5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEb"}
!51 = !{!52, !8, !1}
!52 = distinct !{!52, !53, !"_ZN6poppet6engine10integrator7_variesB3v11B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!53 = distinct !{!53, !"_ZN6poppet6engine10integrator7_variesB3v11B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIdLi2E1C7mutable7alignedE"}
!54 = !{!55, !8, !1}
!55 = distinct !{!55, !56, !"_ZN6poppet6engine10integrator10_inputs_atB2v8B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!56 = distinct !{!56, !"_ZN6poppet6engine10integrator10_inputs_atB2v8B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!57 = !{!58, !8, !1}
!58 = distinct !{!58, !59, !"_ZN6poppet6engine10integrator16_input_slopes_atB3v12B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!59 = distinct !{!59, !"_ZN6poppet6engine10integrator16_input_slopes_atB3v12B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!60 = !{!61, !8, !1}
!61 = distinct !{!61, !62, !"_ZN6poppet6engine10integrator10_inputs_atB2v8B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!62 = distinct !{!62, !"_ZN6poppet6engine10integrator10_inputs_atB2v8B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!63 = !{!64, !1}
!64 = distinct !{!64, !65, !"_ZN6poppet6engine10integrator20_rows_without_statesB3v24B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE: %retptr"}
!65 = distinct !{!65, !"_ZN6poppet6engine10integrator20_rows_without_statesB3v24B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE"}
!66 = !{!67, !64, !1}
!67 = distinct !{!67, !68, !"_ZN6poppet6engine10integrator10_inputs_atB2v8B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!68 = distinct !{!68, !"_ZN6poppet6engine10integrator10_inputs_atB2v8B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!69 = !{!70, !64, !1}
!70 = distinct !{!70, !71, !"_ZN6poppet6engine10integrator6_writeB3v21B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedEx: %retptr"}
!71 = distinct !{!71, !"_ZN6poppet6engine10integrator6_writeB3v21B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedEx"}
!72 = distinct !{!72, !47}
!73 = !{!74, !1}
!74 = distinct !{!74, !75, !"_ZN6poppet6engine10integrator10_inputs_atB2v8B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!75 = distinct !{!75, !"_ZN6poppet6engine10integrator10_inputs_atB2v8B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!76 = !{!77, !1}
!77 = distinct !{!77, !78, !"_ZN6poppet6engine10integrator15_stop_conditionB2v9B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!78 = distinct !{!78, !"_ZN6poppet6engine10integrator15_stop_conditionB2v9B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE"}
!79 = !{!80, !1}
!80 = distinct !{!80, !81, !"_ZN6poppet6engine10integrator6_writeB3v21B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedEx: %retptr"}
!81 = distinct !{!81, !"_ZN6poppet6engine10integrator6_writeB3v21B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedEx"}
!82 = distinct !{!82, !47}
