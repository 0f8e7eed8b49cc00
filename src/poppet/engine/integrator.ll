; made from integrator.py, sha256 3154971d953ad2a44545d54309a81b1738bc1aa63bfef7b1be80687c37473dd2
@v21 = private unnamed_addr constant [4 x double] [double 3.860000e-01, double 2.100000e-01, double 6.300000e-01, double 1.000000e+00], align 8
declare i64 @llvm.smax.i64(i64, i64)
declare i64 @llvm.smin.i64(i64, i64)
declare double @llvm.sin.f64(double)
declare double @llvm.fabs.f64(double)
declare double @llvm.cos.f64(double)
declare double @llvm.pow.f64(double, double)
declare i64 @llvm.umin.i64(i64, i64)
define i64 @integrate(ptr readonly %a0, ptr readonly %a1, ptr %a2, ptr %a3, ptr readonly %a4, ptr readonly %a5, ptr readonly %a6, ptr readonly %a7, ptr readonly %a8, ptr readonly %a9, ptr readonly %a10, ptr readonly %a11, ptr readonly %a12, ptr writeonly %a13, ptr %a14, ptr %a15, ptr %a16, ptr %a17, ptr %a18) local_unnamed_addr {
  %.24.i = load i64, ptr %a1, align 8, !noalias !0
  %.25.i = getelementptr i8, ptr %a1, i64 8
  %.26.i = load i64, ptr %.25.i, align 8, !noalias !0
  %.27.i = getelementptr i8, ptr %a1, i64 16
  %.28.i = load i64, ptr %.27.i, align 8, !noalias !0
  %.29.i = getelementptr i8, ptr %a1, i64 24
  %.30.i = load i64, ptr %.29.i, align 8, !noalias !0
  %.31.i = getelementptr i8, ptr %a1, i64 32
  %.32.i = load i64, ptr %.31.i, align 8, !noalias !0
  %.69.i = getelementptr i8, ptr %a1, i64 40
  %.70.i = load i64, ptr %.69.i, align 8, !noalias !0
  %.71.i = getelementptr i8, ptr %a1, i64 48
  %.72.i = load i64, ptr %.71.i, align 8, !noalias !0
  %.73.i = getelementptr i8, ptr %a1, i64 56
  %.74.i = load i64, ptr %.73.i, align 8, !noalias !0
  %.75.i = getelementptr i8, ptr %a1, i64 64
  %.76.i = load i64, ptr %.75.i, align 8, !noalias !0
  %.16.i.i = shl i64 %.70.i, 3
  %.967.i = getelementptr i8, ptr %a1, i64 72
  %.968.i = load i64, ptr %.967.i, align 8, !noalias !0
  %.1039.i = mul nsw i64 %.24.i, 12
  %.1040.i = mul i64 %.28.i, 6
  %.1041.i = or i64 %.1039.i, 2
  %.1042.i = add i64 %.1041.i, %.1040.i
  %.1043.i = add i64 %.1042.i, %.30.i
  %.1044.i = add nsw i64 %.1043.i, %.74.i
  %.1045.i = add nsw i64 %.1044.i, %.76.i
  %.1132.i = icmp slt i64 %.1045.i, 1
  br i1 %.1132.i, label %B0.endif.endif.endif.endi...endif.3.else.endif.if.i, label %B0.endif.endif.endif.endi...endif.3.else.endif.endif.i, !prof !3
B1140.i:
  %lsr.iv429.i = phi ptr [ %scevgep430.i, %B1140.i ], [ %scevgep428.i, %B1140.lr.ph.new.i ]
  %lsr.iv425.i = phi ptr [ %scevgep426.i, %B1140.i ], [ %scevgep424.i, %B1140.lr.ph.new.i ]
  %.325526272629.i = phi i64 [ %.3262.1.i, %B1140.i ], [ 0, %B1140.lr.ph.new.i ]
  %scevgep427.i = getelementptr i8, ptr %lsr.iv425.i, i64 -8
  %.3316.i = load double, ptr %scevgep427.i, align 8, !noalias !0
  %scevgep431.i = getelementptr i8, ptr %lsr.iv429.i, i64 -8
  store double %.3316.i, ptr %scevgep431.i, align 8, !noalias !0
  %sunkaddr439.i = getelementptr i8, ptr %lsr.iv429.i, i64 %sunkaddr.i
  %sunkaddr440.i = getelementptr i8, ptr %sunkaddr439.i, i64 -8
  store double %.3316.i, ptr %sunkaddr440.i, align 8, !noalias !0
  %scevgep436.i = getelementptr i8, ptr %lsr.iv429.i, i64 %.idx.i
  %scevgep437.i = getelementptr i8, ptr %scevgep436.i, i64 -8
  store double 0.000000e+00, ptr %scevgep437.i, align 8, !noalias !0
  %.3262.1.i = add nuw i64 %.325526272629.i, 2
  %.3316.1.i = load double, ptr %lsr.iv425.i, align 8, !noalias !0
  store double %.3316.1.i, ptr %lsr.iv429.i, align 8, !noalias !0
  store double %.3316.1.i, ptr %sunkaddr439.i, align 8, !noalias !0
  store double 0.000000e+00, ptr %scevgep436.i, align 8, !noalias !0
  %scevgep426.i = getelementptr i8, ptr %lsr.iv425.i, i64 16
  %scevgep430.i = getelementptr i8, ptr %lsr.iv429.i, i64 16
  %niter.ncmp.1.i = icmp eq i64 %unroll_iter.i, %.3262.1.i
  br i1 %niter.ncmp.1.i, label %B1218.endif.loopexit.unr-lcssa.i, label %B1140.i
B1306.i:
  %h.3.02647.i = phi double [ 0.000000e+00, %B1306.lr.ph.i ], [ %h.4.12588.i, %B1816.i ]
  %.363026382645.i = phi i64 [ 0, %B1306.lr.ph.i ], [ %.3637.i, %B1816.i ]
  %.3637.i = add nuw nsw i64 %.363026382645.i, 1
  %1 = getelementptr double, ptr %a4, i64 %.363026382645.i
  %.3701.i = load double, ptr %1, align 8, !noalias !0
  %.3708.i = icmp slt i64 %.3637.i, %.32.i
  %2 = getelementptr double, ptr %a4, i64 %.3637.i
  %"$phi1384.1.2.1.in.i" = select i1 %.3708.i, ptr %2, ptr %.3776.i
  %"$phi1384.1.2.1.i" = load double, ptr %"$phi1384.1.2.1.in.i", align 8, !noalias !0
  br i1 %58, label %B1398.i, label %B1562.i
B1398.i:
  %.40.i.i = fsub double %.3701.i, %.3701.i
  br i1 %59, label %B1398.endif.i, label %B56.preheader.i.i
B56.preheader.i.i:
  %.3841.i = mul i64 %.363026382645.i, %.1040.i
  %.3843.i = getelementptr double, ptr %a5, i64 %.3841.i
  %scevgep.i.i = getelementptr i8, ptr %.3843.i, i64 40
  br label %B56.i.i
B56.i.i:
  %lsr.iv421.i = phi i64 [ %lsr.iv.next422.i, %B316.i.i ], [ %.1469.sroa.0.3.i, %B56.preheader.i.i ]
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
  %3 = shl i64 %lsr.iv421.i, 3
  %scevgep423.i = getelementptr i8, ptr %.1397.i, i64 %3
  store double %value.2.1.i.i, ptr %scevgep423.i, align 8, !noalias !4
  %scevgep1.i.i = getelementptr i8, ptr %lsr.iv.i.i, i64 48
  %lsr.iv.next422.i = add nuw i64 %lsr.iv421.i, 1
  %exitcond.not.i.i = icmp eq i64 %.1469.sroa.13.0.i, %lsr.iv.next422.i
  br i1 %exitcond.not.i.i, label %B1398.endif.i, label %B56.i.i
B1562.i:
  %4 = getelementptr i8, ptr %a6, i64 %.363026382645.i
  %.4195.i = load i8, ptr %4, align 1, !noalias !0
  %.4196.not.i = icmp eq i8 %.4195.i, 0
  %.4199.i = fneg double %h.3.02647.i
  %"$phi1586.1.2.1.i" = select i1 %.4196.not.i, double %h.3.02647.i, double %.4199.i
  br i1 %60, label %B1600.i, label %B1704.i
B1600.i:
  %.4274.i = mul i64 %.363026382645.i, %.1040.i
  %.4276.i = getelementptr double, ptr %a5, i64 %.4274.i
  %.409.i.i = load i64, ptr %sunkaddr446.i, align 8, !noalias !7
  br i1 %75, label %B0.endif.else.endif.endif.endif.i.i, label %B0.endif.else.endif.if.i.i, !prof !10
B476.i.i:
  %.2306.i.i = fcmp olt double %.3701.i, %"$phi1384.1.2.1.i"
  br i1 %.2306.i.i, label %B490.preheader.i.i, label %_ZN6poppet6engine10integrator8_segmentB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
B490.preheader.i.i:
  %5 = fcmp ogt double %.1898.i.i, 0.000000e+00
  %invariant.gep.i.i.i.i = getelementptr double, ptr %.1385.i.i, i64 %.1053.i.i
  %6 = icmp slt i64 %.1044.i.i, 1
  %7 = inttoptr i64 %.409.i.i to ptr
  %invariant.gep.i.i14.i.i = getelementptr double, ptr %.1385.i.i, i64 %.709.i.i
  %8 = icmp slt i64 %.700.i.i, 1
  br label %B490.i.i
B490.i.i:
  %t.2.0.i.i = phi double [ %t.3.1.i.i, %B2192.else.if.i.i ], [ %.3701.i, %B490.preheader.i.i ]
  %h.5.0.i.i = phi double [ %h.6.1.i.i, %B2192.else.if.i.i ], [ %"$phi1586.1.2.1.i", %B490.preheader.i.i ]
  %error_before.2.0.i.i = phi double [ %error_before.3.1.i.i, %B2192.else.if.i.i ], [ 1.000000e-02, %B490.preheader.i.i ]
  %step_before.2.0.i.i = phi double [ %step_before.3.1.i.i, %B2192.else.if.i.i ], [ 0.000000e+00, %B490.preheader.i.i ]
  %rejected.3.0.i.i = phi i1 [ %rejected.4.1.i.i, %B2192.else.if.i.i ], [ false, %B490.preheader.i.i ]
  %fresh.3.0.i.i = phi i1 [ %fresh.4.1.i.i, %B2192.else.if.i.i ], [ true, %B490.preheader.i.i ]
  %window.2.0.i.i = phi double [ %window.3.1.i.i, %B2192.else.if.i.i ], [ %.3701.i, %B490.preheader.i.i ]
  br i1 %fresh.3.0.i.i, label %B494.i.i, label %B752.endif.i.i
B494.i.i:
  store double %t.2.0.i.i, ptr %.2096.i, align 8, !noalias !7
  %.40.i.i.i = fsub double %t.2.0.i.i, %.3701.i
  br i1 %59, label %B494.endif.i.i, label %B56.i.i.i
B56.i.i.i:
  %lsr.iv.i.i.i = phi ptr [ %scevgep1.i.i.i, %B316.i.i.i ], [ %scevgep.i142.i.i, %B494.i.i ]
  %.138222224.i.i.i = phi i64 [ %.145.i.i.i, %B316.i.i.i ], [ 0, %B494.i.i ]
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
  %9 = shl i64 %.138222224.i.i.i, 3
  %scevgep7.i.i.i = getelementptr i8, ptr %.1582.i, i64 %9
  store double %value.2.1.i.i.i, ptr %scevgep7.i.i.i, align 8, !noalias !11
  %scevgep1.i.i.i = getelementptr i8, ptr %lsr.iv.i.i.i, i64 48
  %exitcond.not.i.i.i = icmp eq i64 %.1557.i, %.145.i.i.i
  br i1 %exitcond.not.i.i.i, label %B494.endif.i.i, label %B56.i.i.i
B660.i.i:
  %.2537.i.i = fsub double %"$phi1384.1.2.1.i", %t.2.0.i.i
  %.56.i.i.i = fdiv double 2.000000e+01, %.2537.i.i
  br i1 %80, label %B660.endif.i.i, label %B66.backedge.i.i.i
B66.backedge.i.i.i:
  %fastest.2.0128.i.i.i = phi double [ %.13.i.i.i.i, %B66.backedge.i.i.i ], [ %.56.i.i.i, %B660.i.i ]
  %.162124126.i.i.i = phi i64 [ %.169.i.i.i, %B66.backedge.i.i.i ], [ 0, %B660.i.i ]
  %10 = shl i64 %.162124126.i.i.i, 3
  %scevgep3.i108.i.i = getelementptr i8, ptr %.1225.i, i64 %10
  %.223.i.i.i = load double, ptr %scevgep3.i108.i.i, align 8, !noalias !14
  %.224.i.i.i = tail call double @llvm.fabs.f64(double %.223.i.i.i)
  %.225.i.i.i = fmul double %.224.i.i.i, 2.000000e+01
  %scevgep2.i109.i.i = getelementptr i8, ptr %a2, i64 %10
  %.255.i.i.i = load double, ptr %scevgep2.i109.i.i, align 8, !noalias !14
  %.256.i.i.i = tail call double @llvm.fabs.f64(double %.255.i.i.i)
  %scevgep155.i.i = getelementptr i8, ptr %77, i64 %10
  %.310.i.i.i = load double, ptr %scevgep155.i.i, align 8, !noalias !14
  %.311.i.i.i = fadd double %.256.i.i.i, %.310.i.i.i
  %.315.i.i.i = fdiv double %.225.i.i.i, %.311.i.i.i
  %.12.i.i.i.i = fcmp ogt double %.315.i.i.i, %fastest.2.0128.i.i.i
  %.13.i.i.i.i = select i1 %.12.i.i.i.i, double %.315.i.i.i, double %fastest.2.0128.i.i.i
  %.169.i.i.i = add nuw nsw i64 %.162124126.i.i.i, 1
  %exitcond.not.i111.i.i = icmp eq i64 %.26.i, %.169.i.i.i
  br i1 %exitcond.not.i111.i.i, label %B660.endif.i.i, label %B66.backedge.i.i.i
B714.i.i:
  %.2580.i.i = fneg double %h.5.0.i.i
  %.12.i.i.i = fcmp olt double %.373.i.i.i, %.2580.i.i
  %.13.i.i.i = select i1 %.12.i.i.i, double %.373.i.i.i, double %.2580.i.i
  br label %B752.endif.i.i
B800.i.i:
  %.2736.i.i = load i64, ptr %a16, align 8, !noalias !7
  %.2750.i.i = icmp slt i64 %.2736.i.i, 0
  %.2751.i.i = select i1 %.2750.i.i, i64 %.968.i, i64 0
  %11 = getelementptr double, ptr %a18, i64 %.2736.i.i
  %.2765.i.i = getelementptr double, ptr %11, i64 %.2751.i.i
  %"$phi864.0.2.1.in.sroa.speculate.load.B800.i.i" = load double, ptr %.2765.i.i, align 8, !noalias !7
  br label %B864.i.i
B828.i.i:
  %.2774.i.i = fsub double %"$phi1384.1.2.1.i", %t.2.0.i.i
  %.11.i.i.i = fmul double %.2774.i.i, 5.000000e-01
  %.13.i114.i.i = fcmp olt double %.13.i113.i.i, %.11.i.i.i
  %.24.i.i.i = fcmp olt double %.13.i113.i.i, %.2774.i.i
  %"$phi50.0.2.0.i.i.i" = select i1 %.24.i.i.i, double %.11.i.i.i, double %.2774.i.i
  %storemerge.i.i.i = select i1 %.13.i114.i.i, double %.13.i113.i.i, double %"$phi50.0.2.0.i.i.i"
  br label %B864.i.i
B864.i.i:
  %"$phi864.0.2.1.in.sroa.speculated.i.i" = phi double [ %"$phi864.0.2.1.in.sroa.speculate.load.B800.i.i", %B800.i.i ], [ %storemerge.i.i.i, %B828.i.i ]
  br i1 %exitcond.not.i137.i.i, label %B1014.i.i, label %switch.lookup.i.i
B1014.i.i:
  %.3197.i.i = fsub double %"$phi1384.1.2.1.i", %t.2.0.i.i
  %.3198.i.i = fmul double %.3197.i.i, 0x3FEFFFFFFFFFDCD1
  %.3200.i.i = fcmp oge double %"$phi864.0.2.1.in.sroa.speculated.i.i", %.3198.i.i
  %.3209.i.i = fadd double %t.2.0.i.i, %"$phi864.0.2.1.in.sroa.speculated.i.i"
  %"$phi1050.0.2.1.i.i" = select i1 %.3200.i.i, double %"$phi1384.1.2.1.i", double %.3209.i.i
  store double %t.2.0.i.i, ptr %.2096.i, align 8, !noalias !7
  store double %"$phi864.0.2.1.in.sroa.speculated.i.i", ptr %sunkaddr160.i.i, align 8, !noalias !7
  %.3310.i.i = load i64, ptr %sunkaddr.i2.i, align 8, !noalias !7
  %.3381.i.i = inttoptr i64 %.3310.i.i to ptr
  tail call void %.3381.i.i(ptr nonnull %.2096.i, ptr %a2, ptr %.1753.i, ptr %a3, ptr %.1225.i, ptr %.2578.i, ptr %.725.i.i, ptr %.2946.i, ptr %.1556.i.i, ptr %.897.i.i), !noalias !7
  br i1 %80, label %B1050.endif.thread246.i.i, label %B62.i.i.i
B1050.endif.thread246.i.i:
  %.3457248.i.i = load i64, ptr %sunkaddr174.i.i, align 8, !noalias !7
  %.3458249.i.i = add nsw i64 %.3457248.i.i, 1
  store i64 %.3458249.i.i, ptr %sunkaddr174.i.i, align 8, !noalias !7
  br label %B1276.i.i
B62.i.i.i:
  %worst.2.0263.i.i.i = phi double [ %worst.3.1.i.i.i, %B176.endif.i.i.i ], [ 0.000000e+00, %B1014.i.i ]
  %.185258261.i.i.i = phi i64 [ %.192.i.i.i, %B176.endif.i.i.i ], [ 0, %B1014.i.i ]
  %.192.i.i.i = add nuw nsw i64 %.185258261.i.i.i, 1
  %12 = shl i64 %.185258261.i.i.i, 3
  %scevgep5.i115.i.i = getelementptr i8, ptr %.897.i.i, i64 %12
  %.250.i.i.i = load double, ptr %scevgep5.i115.i.i, align 8, !noalias !17
  %.262.le.i.i.i = fsub double %.250.i.i.i, %.250.i.i.i
  %.263.le.i.i.i = fcmp ord double %.262.le.i.i.i, 0.000000e+00
  br i1 %.263.le.i.i.i, label %B120.i.i.i, label %B1050.endif.thread.i.i
B120.i.i.i:
  %13 = getelementptr i8, ptr %a9, i64 %.185258261.i.i.i
  %.308.i.i.i = load i8, ptr %13, align 1, !noalias !17
  %.309.i.i.i = icmp ne i8 %.308.i.i.i, 0
  %.312.i.i.i = fcmp ole double %.250.i.i.i, 0.000000e+00
  %or.cond.i.i.i = and i1 %.312.i.i.i, %.309.i.i.i
  br i1 %or.cond.i.i.i, label %B1050.endif.thread.i.i, label %B176.endif.i.i.i
B176.endif.i.i.i:
  %scevgep159.i.i = getelementptr i8, ptr %.1727.i.i, i64 %12
  %.385.i.i.i = load double, ptr %scevgep159.i.i, align 8, !noalias !17
  %scevgep158.i.i = getelementptr i8, ptr %scevgep157.i.i, i64 %12
  %.441.i.i.i = load double, ptr %scevgep158.i.i, align 8, !noalias !17
  %scevgep156.i.i = getelementptr i8, ptr %a8, i64 %12
  %.496.i.i.i = load double, ptr %scevgep156.i.i, align 8, !noalias !17
  %scevgep.i3.i = getelementptr i8, ptr %a2, i64 %12
  %.527.i.i.i = load double, ptr %scevgep.i3.i, align 8, !noalias !17
  %.530.i.i.i = tail call double @llvm.fabs.f64(double %.527.i.i.i)
  %.532.i.i.i = tail call double @llvm.fabs.f64(double %.250.i.i.i)
  %.12.i.i121.i.i = fcmp ogt double %.532.i.i.i, %.530.i.i.i
  %.13.i.i122.i.i = select i1 %.12.i.i121.i.i, double %.532.i.i.i, double %.530.i.i.i
  %.386.i.i.i = tail call double @llvm.fabs.f64(double %.385.i.i.i)
  %.563.i.i.i = fmul double %.496.i.i.i, %.13.i.i122.i.i
  %.564.i.i.i = fadd double %.441.i.i.i, %.563.i.i.i
  %.568.i.i.i = fdiv double %.386.i.i.i, %.564.i.i.i
  %.574.i.i.i = fcmp ole double %.568.i.i.i, %worst.2.0263.i.i.i
  %worst.3.1.i.i.i = select i1 %.574.i.i.i, double %worst.2.0263.i.i.i, double %.568.i.i.i
  %exitcond.not.i123.i.i = icmp eq i64 %.26.i, %.192.i.i.i
  br i1 %exitcond.not.i123.i.i, label %B1050.endif.i.i, label %B62.i.i.i
B1228.i.i:
  %storemerge.i116244.i.i = phi double [ 0x7FF0000000000000, %B1050.endif.thread.i.i ], [ %worst.3.1.i.i.i, %B1050.endif.i.i ]
  %.3502.le.i.i = fsub double %storemerge.i116244.i.i, %storemerge.i116244.i.i
  %.3503.le.i.i = fcmp ord double %.3502.le.i.i, 0.000000e+00
  %or.cond3194.i.i = select i1 %5, i1 %.3503.le.i.i, i1 false
  br i1 %or.cond3194.i.i, label %B1336.i.i, label %for.end.1.i.i
B1276.i.i:
  %storemerge.i116251.i.i = phi double [ 0.000000e+00, %B1050.endif.thread246.i.i ], [ %worst.3.1.i.i.i, %B1050.endif.i.i ]
  %.3549.i.i = load i64, ptr %a16, align 8, !noalias !7
  %.3557.i.i = icmp sge i64 %.3549.i.i, %.968.i
  %brmerge.i.i = or i1 %5, %.3557.i.i
  br i1 %brmerge.i.i, label %B1336.i.i, label %B1314.i.i
B1314.i.i:
  %.3605.i.i = icmp slt i64 %.3549.i.i, 0
  %.3606.i.i = select i1 %.3605.i.i, i64 %.968.i, i64 0
  %14 = getelementptr double, ptr %a18, i64 %.3549.i.i
  %.3620.i.i = getelementptr double, ptr %14, i64 %.3606.i.i
  store double %"$phi864.0.2.1.in.sroa.speculated.i.i", ptr %.3620.i.i, align 8, !noalias !7
  br label %B1336.i.i
B1336.i.i:
  %storemerge.i116245.i.i = phi double [ %storemerge.i116244.i.i, %B1228.i.i ], [ %storemerge.i116251.i.i, %B1276.i.i ], [ %storemerge.i116251.i.i, %B1314.i.i ]
  br i1 %58, label %B1436.i.i, label %B1340.i.i
B1340.i.i:
  %.3654.i.i = load i64, ptr %.179.i.i, align 8, !noalias !7
  %.3668.i.i = icmp slt i64 %.3654.i.i, 0
  %.3669.i.i = select i1 %.3668.i.i, i64 %.70.i, i64 0
  %15 = getelementptr double, ptr %a7, i64 %.3654.i.i
  %.3683.i.i = getelementptr double, ptr %15, i64 %.3669.i.i
  %.3684.i.i = load double, ptr %.3683.i.i, align 8, !noalias !7
  %.3686.i.i = fcmp olt double %.3684.i.i, %"$phi1050.0.2.1.i.i"
  br i1 %.3686.i.i, label %B1432.i.i, label %B1544.i.i
B1432.i.i:
  %.3717.i.i = load i64, ptr %sunkaddr163.i.i, align 8, !noalias !7
  %.3732.i.i = inttoptr i64 %.3717.i.i to ptr
  tail call void %.3732.i.i(ptr %.1556.i.i, ptr %.1385.i.i), !noalias !7
  br label %B1544.i.i
B1436.i.i:
  %.37172705.i.i = load i64, ptr %sunkaddr163.i.i, align 8, !noalias !7
  %.37322706.i.i = inttoptr i64 %.37172705.i.i to ptr
  tail call void %.37322706.i.i(ptr %.1556.i.i, ptr %.1385.i.i), !noalias !7
  %.556.i.i.i = fmul double %.3209.i.i, 4.000000e-16
  br label %B18.outer.i.i.i
B18.outer.i.i.i:
  %low.4.1.ph.i.i.i = phi double [ 0.000000e+00, %B1436.i.i ], [ %low.3.2.i.i.i, %B240.i.i.i ]
  %high.3.1.ph.i.i.i = phi double [ 5.000000e-01, %B1436.i.i ], [ %.544.i.i.i, %B240.i.i.i ]
  %event.2.1.ph.i.i.i = phi i64 [ -1, %B1436.i.i ], [ %event.4.2.i.i.i, %B240.i.i.i ]
  %theta.2.1.ph.i.i.i = phi double [ 0.000000e+00, %B1436.i.i ], [ %theta.1.2.i.i.i, %B240.i.i.i ]
  br label %B18.i.i.i
B18.i.i.i:
  %low.4.1.i.i.i = phi double [ 5.000000e-01, %B186.i.i.i ], [ %low.4.1.ph.i.i.i, %B18.outer.i.i.i ]
  %high.3.1.i.i.i = phi double [ 1.000000e+00, %B186.i.i.i ], [ %high.3.1.ph.i.i.i, %B18.outer.i.i.i ]
  %event.2.1.i.i.i = phi i64 [ -1, %B186.i.i.i ], [ %event.2.1.ph.i.i.i, %B18.outer.i.i.i ]
  %.64.i.i.i.i = fsub double 1.000000e+00, %high.3.1.i.i.i
  br i1 %6, label %B18.endif.i.i.i, label %B60.i.i.i.i
B60.i.i.i.i:
  %.166146148.i.i.i.i = phi i64 [ %.173.i.i.i.i, %B60.i.i.i.i ], [ 0, %B18.i.i.i ]
  %.173.i.i.i.i = add nuw nsw i64 %.166146148.i.i.i.i, 1
  %16 = shl i64 %.166146148.i.i.i.i, 3
  %scevgep4.i.i.i.i = getelementptr i8, ptr %a2, i64 %16
  %.227.i.i.i.i = load double, ptr %scevgep4.i.i.i.i, align 8, !noalias !20
  %.229.i.i.i.i = fmul double %.64.i.i.i.i, %.227.i.i.i.i
  %scevgep3.i.i.i.i = getelementptr i8, ptr %.897.i.i, i64 %16
  %.259.i.i.i.i = load double, ptr %scevgep3.i.i.i.i, align 8, !noalias !20
  %scevgep65.i.i.i = getelementptr i8, ptr %.1385.i.i, i64 %16
  %.289.i.i.i.i = load double, ptr %scevgep65.i.i.i, align 8, !noalias !20
  %scevgep64.i.i.i = getelementptr i8, ptr %invariant.gep.i.i.i.i, i64 %16
  %.321.i.i.i.i = load double, ptr %scevgep64.i.i.i, align 8, !noalias !20
  %.323.i.i.i.i = fmul double %high.3.1.i.i.i, %.321.i.i.i.i
  %.324.i.i.i.i = fadd double %.289.i.i.i.i, %.323.i.i.i.i
  %.326.i.i.i.i = fmul double %.64.i.i.i.i, %.324.i.i.i.i
  %.327.i.i.i.i = fadd double %.259.i.i.i.i, %.326.i.i.i.i
  %.329.i.i.i.i = fmul double %high.3.1.i.i.i, %.327.i.i.i.i
  %.330.i.i.i.i = fadd double %.229.i.i.i.i, %.329.i.i.i.i
  %scevgep63.i.i.i = getelementptr i8, ptr %.1069.i.i, i64 %16
  store double %.330.i.i.i.i, ptr %scevgep63.i.i.i, align 8, !noalias !20
  %exitcond.not.i.i.i.i = icmp eq i64 %.1044.i.i, %.173.i.i.i.i
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
  %.552.i.i.i = fmul double %"$phi864.0.2.1.in.sroa.speculated.i.i", %.550.i.i.i
  %.557.i.i.i = fcmp ole double %.552.i.i.i, %.556.i.i.i
  %.561.i.i.i = fcmp ole double %.544.i.i.i, %low.3.2.i.i.i
  %or.cond.i2.i.i = or i1 %.557.i.i.i, %.561.i.i.i
  %.565.i.i.i = fcmp oge double %.544.i.i.i, %theta.1.2.i.i.i
  %or.cond319.i.i.i = or i1 %.565.i.i.i, %or.cond.i2.i.i
  br i1 %or.cond319.i.i.i, label %B316.i3.i.i, label %B18.outer.i.i.i
B316.i3.i.i:
  %.64.i18.i.i.i = fsub double 1.000000e+00, %theta.1.2.i.i.i
  br i1 %6, label %_ZN6poppet6engine10integrator12_stop_insideB3v18B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE.exit.i.i, label %B60.i22.i.i.i
B60.i22.i.i.i:
  %.166146148.i23.i.i.i = phi i64 [ %.173.i24.i.i.i, %B60.i22.i.i.i ], [ 0, %B316.i3.i.i ]
  %.173.i24.i.i.i = add nuw nsw i64 %.166146148.i23.i.i.i, 1
  %17 = shl i64 %.166146148.i23.i.i.i, 3
  %scevgep4.i25.i.i.i = getelementptr i8, ptr %a2, i64 %17
  %.227.i26.i.i.i = load double, ptr %scevgep4.i25.i.i.i, align 8, !noalias !25
  %.229.i27.i.i.i = fmul double %.64.i18.i.i.i, %.227.i26.i.i.i
  %scevgep3.i28.i.i.i = getelementptr i8, ptr %.897.i.i, i64 %17
  %.259.i29.i.i.i = load double, ptr %scevgep3.i28.i.i.i, align 8, !noalias !25
  %scevgep62.i.i.i = getelementptr i8, ptr %.1385.i.i, i64 %17
  %.289.i31.i.i.i = load double, ptr %scevgep62.i.i.i, align 8, !noalias !25
  %scevgep61.i.i.i = getelementptr i8, ptr %invariant.gep.i.i.i.i, i64 %17
  %.321.i33.i.i.i = load double, ptr %scevgep61.i.i.i, align 8, !noalias !25
  %.323.i34.i.i.i = fmul double %theta.1.2.i.i.i, %.321.i33.i.i.i
  %.324.i35.i.i.i = fadd double %.289.i31.i.i.i, %.323.i34.i.i.i
  %.326.i36.i.i.i = fmul double %.64.i18.i.i.i, %.324.i35.i.i.i
  %.327.i37.i.i.i = fadd double %.259.i29.i.i.i, %.326.i36.i.i.i
  %.329.i38.i.i.i = fmul double %theta.1.2.i.i.i, %.327.i37.i.i.i
  %.330.i39.i.i.i = fadd double %.229.i27.i.i.i, %.329.i38.i.i.i
  %scevgep60.i.i.i = getelementptr i8, ptr %.1069.i.i, i64 %17
  store double %.330.i39.i.i.i, ptr %scevgep60.i.i.i, align 8, !noalias !25
  %exitcond.not.i41.i.i.i = icmp eq i64 %.1044.i.i, %.173.i24.i.i.i
  br i1 %exitcond.not.i41.i.i.i, label %_ZN6poppet6engine10integrator12_stop_insideB3v18B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE.exit.i.i, label %B60.i22.i.i.i
B18.endif.i.i.i:
  %.275.i1.i.i = fmul double %"$phi864.0.2.1.in.sroa.speculated.i.i", %high.3.1.i.i.i
  %.277.i.i.i = fadd double %t.2.0.i.i, %.275.i1.i.i
  %.40.i.i.i.i = fsub double %.277.i.i.i, %.3701.i
  br i1 %59, label %B18.endif.endif.i.i.i, label %B56.i.i.i.i
B56.i.i.i.i:
  %lsr.iv.i.i.i.i = phi ptr [ %scevgep1.i46.i.i.i, %B316.i.i.i.i ], [ %scevgep.i142.i.i, %B18.endif.i.i.i ]
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
  %18 = shl i64 %.138222224.i.i.i.i, 3
  %scevgep7.i.i.i.i = getelementptr i8, ptr %.1582.i, i64 %18
  store double %value.2.1.i.i.i.i, ptr %scevgep7.i.i.i.i, align 8, !noalias !28
  %scevgep1.i46.i.i.i = getelementptr i8, ptr %lsr.iv.i.i.i.i, i64 48
  %exitcond.not.i47.i.i.i = icmp eq i64 %.1557.i, %.145.i.i.i.i
  br i1 %exitcond.not.i47.i.i.i, label %B18.endif.endif.i.i.i, label %B56.i.i.i.i
B18.endif.endif.i.i.i:
  store double %.277.i.i.i, ptr %.2096.i, align 8, !noalias !31
  tail call void %7(ptr nonnull %.2096.i, ptr %.1069.i.i, ptr %.1582.i, ptr %a3, ptr %.3116.i), !noalias !31
  br label %B108.endif.endif.i.i.i.i
B106.i.i.i.i:
  %.291.i.i.i.i = add nuw nsw i64 %.284326331.i.i.i.i, 1
  %scevgep1.i54.i.i.i = getelementptr i8, ptr %lsr.iv.i52.i.i.i, i64 16
  %scevgep5.i55.i.i.i = getelementptr i8, ptr %lsr.iv4.i.i.i.i, i64 24
  %exitcond.not.i56.i.i.i = icmp eq i64 %.72.i, %.291.i.i.i.i
  br i1 %exitcond.not.i56.i.i.i, label %B18.endif.endif.endif.thread13.i.i.i, label %B108.endif.endif.i.i.i.i
B192.i.i.i.i:
  %sunkaddr.i.i.i.i = getelementptr i8, ptr %lsr.iv4.i.i.i.i, i64 -16
  %.612.i.i.i.i = load double, ptr %sunkaddr.i.i.i.i, align 8, !noalias !31
  %.701.i.i.i.i = getelementptr double, ptr %.3116.i, i64 %.554.i.i.i.i
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
  %.701.1.i.i.i.i = getelementptr double, ptr %.3116.i, i64 %.554.1.i.i.i.i
  %.702.1.i.i.i.i = load double, ptr %.701.1.i.i.i.i, align 8, !noalias !31
  %.703.1.i.i.i.i = fmul double %.612.1.i.i.i.i, %.702.1.i.i.i.i
  %.705.1.i.i.i.i = fadd double %value.3.2.i.i.i.i, %.703.1.i.i.i.i
  br label %B252.1.i.i.i.i
B252.1.i.i.i.i:
  %value.3.2.1.i.i.i.i = phi double [ %.705.1.i.i.i.i, %B192.1.i.i.i.i ], [ %value.3.2.i.i.i.i, %B252.i.i.i.i ]
  %.724.i.i.i.i = fcmp ogt double %value.3.2.1.i.i.i.i, 0.000000e+00
  br i1 %.724.i.i.i.i, label %B240.i.i.i, label %B106.i.i.i.i
B108.endif.endif.i.i.i.i:
  %lsr.iv4.i.i.i.i = phi ptr [ %scevgep5.i55.i.i.i, %B106.i.i.i.i ], [ %scevgep3.i140.i, %B18.endif.endif.i.i.i ]
  %lsr.iv.i52.i.i.i = phi ptr [ %scevgep1.i54.i.i.i, %B106.i.i.i.i ], [ %scevgep.i139.i, %B18.endif.endif.i.i.i ]
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
  %.3827.i.i = fmul double %"$phi864.0.2.1.in.sroa.speculated.i.i", %theta.1.2.lcssa.sink.i.i.i
  %.3831.i.i = fadd double %t.2.0.i.i, %.3827.i.i
  %.38182727.i.i = icmp slt i64 %event.4.2.lcssa.sink.i.i.i, 0
  %"$phi1532.1.2.2.i.i" = select i1 %.38182727.i.i, double %"$phi1050.0.2.1.i.i", double %.3831.i.i
  store i64 %event.4.2.lcssa.sink.i.i.i, ptr %.3475.i, align 8, !noalias !7
  br label %B1544.i.i
B1544.i.i:
  %end.2.1.i.i = phi double [ %"$phi1532.1.2.2.i.i", %_ZN6poppet6engine10integrator12_stop_insideB3v18B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE.exit.i.i ], [ %"$phi1050.0.2.1.i.i", %B1432.i.i ], [ %"$phi1050.0.2.1.i.i", %B1340.i.i ]
  %.256.i5.i.i = load i64, ptr %.179.i.i, align 8, !noalias !34
  %.264.i.i.i = icmp slt i64 %.256.i5.i.i, %.70.i
  br i1 %.264.i.i.i, label %B38.i.i.i, label %B494.endif.endif.i.i.i.preheader
B38.i.i.i:
  %.309.i12.i.i = icmp slt i64 %.256.i5.i.i, 0
  %.310.i13.i.i = select i1 %.309.i12.i.i, i64 %.70.i, i64 0
  %19 = getelementptr double, ptr %a7, i64 %.256.i5.i.i
  %.324.i.i.i = getelementptr double, ptr %19, i64 %.310.i13.i.i
  %.325.i.i.i = load double, ptr %.324.i.i.i, align 8, !noalias !34
  %.327.i.i.i = fcmp olt double %.325.i.i.i, %end.2.1.i.i
  br i1 %.327.i.i.i, label %B74.i.i.i, label %B494.endif.endif.i.i.i.preheader
B74.i.i.i:
  %.362.i.i.i = phi i64 [ %.698.i.i.i, %B356.i.i.i ], [ %.256.i5.i.i, %B38.i.i.i ]
  %.376.i.i.i = icmp slt i64 %.362.i.i.i, 0
  %.377.i.i.i = select i1 %.376.i.i.i, i64 %.70.i, i64 0
  %20 = getelementptr double, ptr %a7, i64 %.362.i.i.i
  %.391.i.i.i = getelementptr double, ptr %20, i64 %.377.i.i.i
  %.392.i.i.i = load double, ptr %.391.i.i.i, align 8, !noalias !34
  %.394.i.i.i = fsub double %.392.i.i.i, %t.2.0.i.i
  %.399.i.i.i = fdiv double %.394.i.i.i, %"$phi864.0.2.1.in.sroa.speculated.i.i"
  %.64.i.i15.i.i = fsub double 1.000000e+00, %.399.i.i.i
  br i1 %8, label %B74.endif.endif.i.i.i, label %B60.i.i16.i.i
B60.i.i16.i.i:
  %.166146148.i.i17.i.i = phi i64 [ %.173.i.i18.i.i, %B60.i.i16.i.i ], [ 0, %B74.i.i.i ]
  %.173.i.i18.i.i = add nuw nsw i64 %.166146148.i.i17.i.i, 1
  %21 = shl i64 %.166146148.i.i17.i.i, 3
  %scevgep4.i.i19.i.i = getelementptr i8, ptr %a2, i64 %21
  %.227.i.i20.i.i = load double, ptr %scevgep4.i.i19.i.i, align 8, !noalias !37
  %.229.i.i21.i.i = fmul double %.64.i.i15.i.i, %.227.i.i20.i.i
  %scevgep3.i.i22.i.i = getelementptr i8, ptr %.897.i.i, i64 %21
  %.259.i.i23.i.i = load double, ptr %scevgep3.i.i22.i.i, align 8, !noalias !37
  %scevgep9.i.i.i = getelementptr i8, ptr %.1385.i.i, i64 %21
  %.289.i.i24.i.i = load double, ptr %scevgep9.i.i.i, align 8, !noalias !37
  %scevgep8.i.i.i = getelementptr i8, ptr %invariant.gep.i.i14.i.i, i64 %21
  %.321.i.i25.i.i = load double, ptr %scevgep8.i.i.i, align 8, !noalias !37
  %.323.i.i26.i.i = fmul double %.399.i.i.i, %.321.i.i25.i.i
  %.324.i.i27.i.i = fadd double %.289.i.i24.i.i, %.323.i.i26.i.i
  %.326.i.i28.i.i = fmul double %.64.i.i15.i.i, %.324.i.i27.i.i
  %.327.i.i29.i.i = fadd double %.259.i.i23.i.i, %.326.i.i28.i.i
  %.329.i.i30.i.i = fmul double %.399.i.i.i, %.327.i.i29.i.i
  %.330.i.i31.i.i = fadd double %.229.i.i21.i.i, %.329.i.i30.i.i
  %scevgep7.i32.i.i = getelementptr i8, ptr %.725.i.i, i64 %21
  store double %.330.i.i31.i.i, ptr %scevgep7.i32.i.i, align 8, !noalias !37
  %exitcond.not.i.i33.i.i = icmp eq i64 %.700.i.i, %.173.i.i18.i.i
  br i1 %exitcond.not.i.i33.i.i, label %B74.endif.endif.loopexit.i.i.i, label %B60.i.i16.i.i
B356.i.i.i:
  %.811.i.i.i = icmp slt i64 %.697.i.i.i, -1
  %.812.i.i.i = select i1 %.811.i.i.i, i64 %.70.i, i64 0
  %22 = getelementptr double, ptr %a7, i64 %.698.i.i.i
  %.826.i.i.i = getelementptr double, ptr %22, i64 %.812.i.i.i
  %.827.i.i.i = load double, ptr %.826.i.i.i, align 8, !noalias !34
  %.829.i.i.i = fcmp olt double %.827.i.i.i, %end.2.1.i.i
  br i1 %.829.i.i.i, label %B74.i.i.i, label %B494.endif.endif.i.i.i.preheader
B74.endif.endif.loopexit.i.i.i:
  %.468.pre.i.i.i = load i64, ptr %.179.i.i, align 8, !noalias !34
  br label %B74.endif.endif.i.i.i
B74.endif.endif.i.i.i:
  %.468.i.i.i = phi i64 [ %.468.pre.i.i.i, %B74.endif.endif.loopexit.i.i.i ], [ %.362.i.i.i, %B74.i.i.i ]
  %.482.i.i.i = icmp slt i64 %.468.i.i.i, 0
  %.483.i.i.i = select i1 %.482.i.i.i, i64 %.70.i, i64 0
  %23 = getelementptr double, ptr %a7, i64 %.468.i.i.i
  %.497.i.i.i = getelementptr double, ptr %23, i64 %.483.i.i.i
  %.498.i.i.i = load double, ptr %.497.i.i.i, align 8, !noalias !34
  %.40.i.i34.i.i = fsub double %.498.i.i.i, %.3701.i
  br i1 %59, label %B74.endif.endif.endif.i.i.i, label %B56.i.i35.i.i
B56.i.i35.i.i:
  %lsr.iv.i.i36.i.i = phi ptr [ %scevgep1.i13.i.i.i, %B316.i.i46.i.i ], [ %scevgep.i142.i.i, %B74.endif.endif.i.i.i ]
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
  %24 = shl i64 %.138222224.i.i37.i.i, 3
  %scevgep7.i.i48.i.i = getelementptr i8, ptr %.1582.i, i64 %24
  store double %value.2.1.i.i47.i.i, ptr %scevgep7.i.i48.i.i, align 8, !noalias !40
  %scevgep1.i13.i.i.i = getelementptr i8, ptr %lsr.iv.i.i36.i.i, i64 48
  %exitcond.not.i14.i.i.i = icmp eq i64 %.1557.i, %.145.i.i38.i.i
  br i1 %exitcond.not.i14.i.i.i, label %B74.endif.endif.endif.loopexit.i.i.i, label %B56.i.i35.i.i
B74.endif.endif.endif.loopexit.i.i.i:
  %.562.pre.i.i.i = load i64, ptr %.179.i.i, align 8, !noalias !34
  br label %B74.endif.endif.endif.i.i.i
B74.endif.endif.endif.i.i.i:
  %.562.i.i.i = phi i64 [ %.562.pre.i.i.i, %B74.endif.endif.endif.loopexit.i.i.i ], [ %.468.i.i.i, %B74.endif.endif.i.i.i ]
  %.576.i.i.i = icmp slt i64 %.562.i.i.i, 0
  %.577.i.i.i = select i1 %.576.i.i.i, i64 %.70.i, i64 0
  %25 = getelementptr double, ptr %a7, i64 %.562.i.i.i
  %.591.i49.i.i = getelementptr double, ptr %25, i64 %.577.i.i.i
  %.592.i.i.i = load double, ptr %.591.i49.i.i, align 8, !noalias !34
  store double %.592.i.i.i, ptr %.2096.i, align 8, !noalias !43
  tail call void %7(ptr nonnull %.2096.i, ptr %.725.i.i, ptr %.1582.i, ptr %a3, ptr %.3116.i), !noalias !43
  br i1 %69, label %B74.endif.endif.endif.endif.i.i.i, label %B96.lr.ph.i.i.i.i
B96.lr.ph.i.i.i.i:
  br i1 %70, label %B96.epil.preheader.i.i.i.i, label %B96.lr.ph.new.i.i.i.i
B96.lr.ph.new.i.i.i.i:
  %invariant.gep.i17.i.i.i = getelementptr double, ptr %a13, i64 %.562.i.i.i
  %invariant.gep159.i.i.i.i = getelementptr double, ptr %invariant.gep.i17.i.i.i, i64 %.577.i.i.i
  br i1 %71, label %B96.i.epil.preheader.i.i.i, label %B96.i.i.i.i
B96.i.i.i.i:
  %lsr.iv.i50.i.i = phi i64 [ %lsr.iv.next.i51.i.i, %B96.i.i.i.i ], [ %81, %B96.lr.ph.new.i.i.i.i ]
  %lsr.iv13.i.i.i.i = phi ptr [ %scevgep57.i.i.i, %B96.i.i.i.i ], [ %invariant.gep159.i.i.i.i, %B96.lr.ph.new.i.i.i.i ]
  %.259154156.i.i.i.i = phi i64 [ %.266.3.i.1.i.i.i, %B96.i.i.i.i ], [ 0, %B96.lr.ph.new.i.i.i.i ]
  %sunkaddr26.i.i.i = shl i64 %.259154156.i.i.i.i, 3
  %sunkaddr27.i.i.i = getelementptr i8, ptr %.3116.i, i64 %sunkaddr26.i.i.i
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
  %sunkaddr47.i.i.i = getelementptr i8, ptr %.3116.i, i64 %sunkaddr46.i.i.i
  %sunkaddr49.i.i.i = getelementptr i8, ptr %sunkaddr47.i.i.i, i64 -8
  %.320.3.i.1.i.i.i = load double, ptr %sunkaddr49.i.i.i, align 8, !noalias !43
  %scevgep56.i.i.i = getelementptr i8, ptr %scevgep55.i.i.i, i64 %.16.i.i
  store double %.320.3.i.1.i.i.i, ptr %scevgep56.i.i.i, align 8, !noalias !43
  %scevgep57.i.i.i = getelementptr i8, ptr %scevgep56.i.i.i, i64 %.16.i.i
  %lsr.iv.next.i51.i.i = add i64 %lsr.iv.i50.i.i, -2
  %niter.ncmp.1.i.i.i = icmp eq i64 %lsr.iv.next.i51.i.i, 0
  br i1 %niter.ncmp.1.i.i.i, label %B126.loopexit.unr-lcssa.i.unr-lcssa.i.i.i, label %B96.i.i.i.i
B126.loopexit.unr-lcssa.i.unr-lcssa.i.i.i:
  %scevgep14.i.i.i.i = getelementptr i8, ptr %lsr.iv13.i.i.i.i, i64 %62
  %scevgep14.i.1.i.i.i = getelementptr i8, ptr %scevgep14.i.i.i.i, i64 %62
  br i1 %73, label %B96.i.epil.preheader.i.i.i, label %B126.loopexit.unr-lcssa.i.i.i.i
B96.i.epil.preheader.i.i.i:
  %lsr.iv13.i.epil.init.i.i.i = phi ptr [ %invariant.gep159.i.i.i.i, %B96.lr.ph.new.i.i.i.i ], [ %scevgep14.i.1.i.i.i, %B126.loopexit.unr-lcssa.i.unr-lcssa.i.i.i ]
  %.259154156.i.epil.init.i.i.i = phi i64 [ 0, %B96.lr.ph.new.i.i.i.i ], [ %.266.3.i.1.i.i.i, %B126.loopexit.unr-lcssa.i.unr-lcssa.i.i.i ]
  %sunkaddr.i.epil.i.i.i = shl i64 %.259154156.i.epil.init.i.i.i, 3
  %sunkaddr18.i.epil.i.i.i = getelementptr i8, ptr %.3116.i, i64 %sunkaddr.i.epil.i.i.i
  %.320.i.epil.i.i.i = load double, ptr %sunkaddr18.i.epil.i.i.i, align 8, !noalias !43
  store double %.320.i.epil.i.i.i, ptr %lsr.iv13.i.epil.init.i.i.i, align 8, !noalias !43
  %sunkaddr21.i.epil.i.i.i = getelementptr i8, ptr %sunkaddr18.i.epil.i.i.i, i64 8
  %.320.1.i.epil.i.i.i = load double, ptr %sunkaddr21.i.epil.i.i.i, align 8, !noalias !43
  %sunkaddr23.i.epil.i.i.i = getelementptr i8, ptr %lsr.iv13.i.epil.init.i.i.i, i64 %.16.i.i
  store double %.320.1.i.epil.i.i.i, ptr %sunkaddr23.i.epil.i.i.i, align 8, !noalias !43
  %sunkaddr26.i.epil.i.i.i = getelementptr i8, ptr %sunkaddr18.i.epil.i.i.i, i64 16
  %.320.2.i.epil.i.i.i = load double, ptr %sunkaddr26.i.epil.i.i.i, align 8, !noalias !43
  %scevgep16.i.epil.i.i.i = getelementptr i8, ptr %lsr.iv13.i.epil.init.i.i.i, i64 %63
  store double %.320.2.i.epil.i.i.i, ptr %scevgep16.i.epil.i.i.i, align 8, !noalias !43
  %sunkaddr29.i.epil.i.i.i = getelementptr i8, ptr %sunkaddr18.i.epil.i.i.i, i64 24
  %.320.3.i.epil.i.i.i = load double, ptr %sunkaddr29.i.epil.i.i.i, align 8, !noalias !43
  %scevgep15.i.epil.i.i.i = getelementptr i8, ptr %lsr.iv13.i.epil.init.i.i.i, i64 %61
  store double %.320.3.i.epil.i.i.i, ptr %scevgep15.i.epil.i.i.i, align 8, !noalias !43
  br label %B126.loopexit.unr-lcssa.i.i.i.i
B126.loopexit.unr-lcssa.i.i.i.i:
  br i1 %74, label %B74.endif.endif.endif.endif.i.i.i, label %B96.epil.preheader.i.i.i.i
B96.epil.preheader.i.i.i.i:
  %.259154156.epil.init.i.i.i.i = phi i64 [ %unroll_iter.i.i.i, %B126.loopexit.unr-lcssa.i.i.i.i ], [ 0, %B96.lr.ph.i.i.i.i ]
  %26 = mul i64 %.259154156.epil.init.i.i.i.i, %.70.i
  %27 = add i64 %.577.i.i.i, %.562.i.i.i
  %28 = add i64 %27, %26
  %29 = shl i64 %28, 3
  %scevgep.i18.i.i.i = getelementptr i8, ptr %a13, i64 %29
  %30 = shl i64 %.259154156.epil.init.i.i.i.i, 3
  %scevgep3.i19.i.i.i = getelementptr i8, ptr %.3116.i, i64 %30
  br label %B96.epil.i.i.i.i
B96.epil.i.i.i.i:
  %lsr.iv.i20.i.i.i = phi ptr [ %scevgep2.i22.i.i.i, %B96.epil.i.i.i.i ], [ %scevgep.i18.i.i.i, %B96.epil.preheader.i.i.i.i ]
  %epil.iter.i.i.i.i = phi i64 [ %epil.iter.next.i.i.i.i, %B96.epil.i.i.i.i ], [ 0, %B96.epil.preheader.i.i.i.i ]
  %31 = shl i64 %epil.iter.i.i.i.i, 3
  %scevgep58.i.i.i = getelementptr i8, ptr %scevgep3.i19.i.i.i, i64 %31
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
  %.766.i.i.i = icmp slt i64 %.698.i.i.i, %.70.i
  br i1 %.766.i.i.i, label %B356.i.i.i, label %B494.endif.endif.i.i.i.preheader
B494.endif.endif.i.i.i.preheader:
  br label %B494.endif.endif.i.i.i
B494.endif.endif.i.i.i:
  %.991619622.i.i.i = phi i64 [ %.998.i.i.i, %B494.endif.endif.i.i.i ], [ 0, %B494.endif.endif.i.i.i.preheader ]
  %.998.i.i.i = add nuw nsw i64 %.991619622.i.i.i, 1
  %.1055.i.i.i = load i64, ptr %.3475.i, align 8, !noalias !34
  %.1056625.i.i.i = icmp slt i64 %.1055.i.i.i, 0
  %"$phi494.1.2.1.in.v.i.i.i" = select i1 %.1056625.i.i.i, ptr %.897.i.i, ptr %.1069.i.i
  %32 = shl i64 %.991619622.i.i.i, 3
  %scevgep29.i.i.i = getelementptr i8, ptr %"$phi494.1.2.1.in.v.i.i.i", i64 %32
  %"$phi494.1.2.1.i.i.i" = load double, ptr %scevgep29.i.i.i, align 8, !noalias !34
  %scevgep28.i.i.i = getelementptr i8, ptr %invariant.gep.i.i.i, i64 %32
  %.1163.i.i.i = load double, ptr %scevgep28.i.i.i, align 8, !noalias !34
  %scevgep31.i.i.i = getelementptr i8, ptr %a2, i64 %32
  %.1194.i.i.i = load double, ptr %scevgep31.i.i.i, align 8, !noalias !34
  %.1195.i.i.i = fsub double %"$phi494.1.2.1.i.i.i", %.1194.i.i.i
  %.1196.i.i.i = tail call double @llvm.fabs.f64(double %.1195.i.i.i)
  %.1197.i.i.i = fadd double %.1163.i.i.i, %.1196.i.i.i
  store double %.1197.i.i.i, ptr %scevgep28.i.i.i, align 8, !noalias !34
  store double %"$phi494.1.2.1.i.i.i", ptr %scevgep31.i.i.i, align 8, !noalias !34
  %scevgep6.i7.i.i = getelementptr i8, ptr %a14, i64 %32
  %.1289.i.i.i = load double, ptr %scevgep6.i7.i.i, align 8, !noalias !34
  %.12.i.i8.i.i = fcmp olt double %"$phi494.1.2.1.i.i.i", %.1289.i.i.i
  %.13.i.i9.i.i = select i1 %.12.i.i8.i.i, double %"$phi494.1.2.1.i.i.i", double %.1289.i.i.i
  %scevgep5.i10.i.i = getelementptr i8, ptr %invariant.gep645.i.i.i, i64 %32
  %.1350.i.i.i = load double, ptr %scevgep5.i10.i.i, align 8, !noalias !34
  %.12.i23.i.i.i = fcmp ogt double %"$phi494.1.2.1.i.i.i", %.1350.i.i.i
  %.13.i24.i.i.i = select i1 %.12.i23.i.i.i, double %"$phi494.1.2.1.i.i.i", double %.1350.i.i.i
  store double %.13.i.i9.i.i, ptr %scevgep6.i7.i.i, align 8, !noalias !34
  store double %.13.i24.i.i.i, ptr %scevgep5.i10.i.i, align 8, !noalias !34
  %exitcond.not.i11.i.i = icmp eq i64 %.24.i, %.998.i.i.i
  br i1 %exitcond.not.i11.i.i, label %_ZN6poppet6engine10integrator5_takeB3v20B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i.i, label %B494.endif.endif.i.i.i
_ZN6poppet6engine10integrator5_takeB3v20B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i.i:
  %.1501.i.i.i = load i64, ptr %a16, align 8, !noalias !34
  %.1502.i.i.i = add nsw i64 %.1501.i.i.i, 1
  store i64 %.1502.i.i.i, ptr %a16, align 8, !noalias !34
  store double %end.2.1.i.i, ptr %a15, align 8, !noalias !7
  %.4029.i.i = load i64, ptr %.3475.i, align 8, !noalias !7
  %.4030.i.i = icmp sgt i64 %.4029.i.i, -1
  br i1 %.4030.i.i, label %_ZN6poppet6engine10integrator8_segmentB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B1668.endif.i.i
B1788.i.i:
  %.4345.i.i = fmul double %"$phi864.0.2.1.in.sroa.speculated.i.i", %.13.i4.i.i.i
  %.12.i126.i.i = fcmp ogt double %.4345.i.i, %.13.i113.i.i
  %.13.i127.i.i = select i1 %.12.i126.i.i, double %.4345.i.i, double %.13.i113.i.i
  br label %B2088.i.i
B1826.i.i:
  %.12.i128.i.i = fcmp olt double %.13.i4.i.i.i, 1.000000e+00
  %.13.i129.i.i = select i1 %.12.i128.i.i, double %.13.i4.i.i.i, double 1.000000e+00
  %"$phi1866.1.2.1.i.i" = select i1 %rejected.3.0.i.i, double %.13.i129.i.i, double %.13.i4.i.i.i
  %.4440.i.i = fmul double %"$phi864.0.2.1.in.sroa.speculated.i.i", %"$phi1866.1.2.1.i.i"
  br label %B2088.i.i
B2024.i.i:
  %"$phi2024.1.2.2.i.i" = phi double [ 1.500000e-01, %for.end.1.i.i ], [ %.13.i239.i.i, %B1920.endif.i.i ]
  %.4590.i.i = fmul double %"$phi864.0.2.1.in.sroa.speculated.i.i", %"$phi2024.1.2.2.i.i"
  %.4603.i.i = fadd double %t.2.0.i.i, %.4590.i.i
  %.4605.i.i = fcmp ole double %.4603.i.i, %t.2.0.i.i
  %.4608.i.i = fcmp olt double %.4590.i.i, 1.000000e-300
  %or.cond.i.i = or i1 %.4608.i.i, %.4605.i.i
  %brmerge2718.i.i = or i1 %5, %or.cond.i.i
  br i1 %brmerge2718.i.i, label %_ZN6poppet6engine10integrator8_segmentB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B2088.i.i
B2088.i.i:
  %t.3.1.i.i = phi double [ %t.2.0.i.i, %B2024.i.i ], [ %end.2.1.i.i, %B1826.i.i ], [ %end.2.1.i.i, %B1788.i.i ]
  %error_before.3.1.i.i = phi double [ %error_before.2.0.i.i, %B2024.i.i ], [ %.13.i237.i.i, %B1826.i.i ], [ %.13.i237.i.i, %B1788.i.i ]
  %step_before.3.1.i.i = phi double [ %step_before.2.0.i.i, %B2024.i.i ], [ %"$phi864.0.2.1.in.sroa.speculated.i.i", %B1826.i.i ], [ %"$phi864.0.2.1.in.sroa.speculated.i.i", %B1788.i.i ]
  %fresh.4.1.i.i = phi i1 [ false, %B2024.i.i ], [ true, %B1826.i.i ], [ true, %B1788.i.i ]
  %h.6.1.i.i = phi double [ %.4590.i.i, %B2024.i.i ], [ %.4440.i.i, %B1826.i.i ], [ %.13.i127.i.i, %B1788.i.i ]
  %rejected.4.1.i.i = phi i1 [ true, %B2024.i.i ], [ false, %B1826.i.i ], [ false, %B1788.i.i ]
  %.4883.i.i = load double, ptr %sunkaddr167.i.i, align 8, !noalias !7
  %.4913.i.i = load double, ptr %sunkaddr168.i.i, align 8, !noalias !7
  %.82.i.i.i = load i64, ptr %sunkaddr174.i.i, align 8, !noalias !48
  %.102.i.i.i = srem i64 %.82.i.i.i, 400
  %.123.i.i.i = icmp eq i64 %.102.i.i.i, 0
  br i1 %.123.i.i.i, label %B44.endif.i.i.i, label %B174.i.i.i
B108.i.i.i:
  %.231.i.i.i = fsub double %t.3.1.i.i, %window.2.0.i.i
  %.236.i.i.i = fsub double %.4883.i.i, %window.2.0.i.i
  %.241.i.i.i = fmul double %.236.i.i.i, 1.000000e-04
  %.242.i.i.i = fcmp olt double %.231.i.i.i, %.241.i.i.i
  br i1 %.242.i.i.i, label %_ZN6poppet6engine10integrator8_segmentB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B152.i.i.i
B152.i.i.i:
  store i64 %.154.i.i.i, ptr %sunkaddr172.i.i, align 8, !noalias !48
  br label %B174.i.i.i
B174.i.i.i:
  %33 = fcmp une double %.4913.i.i, 0.000000e+00
  %.395.i.i.i = load double, ptr %sunkaddr171.i.i, align 8, !noalias !48
  %.401.i.i.i = sitofp i64 %.82.i.i.i to double
  %.402.i.i.i = fcmp ole double %.395.i.i.i, %.401.i.i.i
  %brmerge256.i.i = select i1 %.402.i.i.i, i1 true, i1 %33
  br i1 %brmerge256.i.i, label %B2182.split.loop.exit.i.i, label %B2192.else.if.i.i
B44.endif.i.i.i:
  %.154.i.i.i = load i64, ptr %a16, align 8, !noalias !48
  %.184.i.i.i = load i64, ptr %sunkaddr172.i.i, align 8, !noalias !48
  %.185.i.i.i = sub nsw i64 %.154.i.i.i, %.184.i.i.i
  %.227.i132.i.i = icmp slt i64 %.185.i.i.i, 280
  br i1 %.227.i132.i.i, label %B108.i.i.i, label %B152.i.i.i
B2182.split.loop.exit.i.i:
  %.mux.le.i.i = select i1 %.402.i.i.i, i64 3, i64 5
  br label %_ZN6poppet6engine10integrator8_segmentB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
B0.endif.else.endif.if.i.i:
  br label %B0.endif.else.endif.endif.endif.i.i
B0.endif.else.endif.endif.endif.i.i:
  %.612.sroa.0.3.i.i = phi i64 [ %.1209.i, %B0.endif.else.endif.if.i.i ], [ %.24.i, %B1600.i ]
  br i1 %.649.not.i.i, label %B0.endif.endif.else.i.i, label %B0.endif.else.endif.endif.endif.if.i.i, !prof !10
B0.endif.else.endif.endif.endif.if.i.i:
  br label %B0.endif.endif.else.i.i
B0.endif.endif.else.i.i:
  %.612.sroa.13.0.i.i = phi i64 [ %.586.i.i, %B0.endif.else.endif.endif.endif.i.i ], [ %.1209.i, %B0.endif.else.endif.endif.endif.if.i.i ]
  %.700.i.i = sub nsw i64 %.612.sroa.13.0.i.i, %.612.sroa.0.3.i.i
  %.709.i.i = tail call i64 @llvm.smax.i64(i64 %.700.i.i, i64 0)
  %.725.i.i = getelementptr double, ptr %.1225.i, i64 %.612.sroa.0.3.i.i
  br i1 %.649.not.i.i, label %B0.endif.endif.else.endif.endif.endif.i.i, label %B0.endif.endif.else.endif.if.i.i, !prof !10
B0.endif.endif.else.endif.if.i.i:
  br label %B0.endif.endif.else.endif.endif.endif.i.i
B0.endif.endif.else.endif.endif.endif.i.i:
  %.784.sroa.0.3.i.i = phi i64 [ %.1209.i, %B0.endif.endif.else.endif.if.i.i ], [ %.586.i.i, %B0.endif.endif.else.i.i ]
  %.897.i.i = getelementptr double, ptr %.1225.i, i64 %.784.sroa.0.3.i.i
  br i1 %.821.not.i.i, label %B0.endif.endif.endif.else.endif.endif.endif.i.i, label %B0.endif.endif.endif.else.endif.if.i.i, !prof !10
B0.endif.endif.endif.else.endif.if.i.i:
  br label %B0.endif.endif.endif.else.endif.endif.endif.i.i
B0.endif.endif.endif.else.endif.endif.endif.i.i:
  %.956.sroa.0.3.i.i = phi i64 [ %.1209.i, %B0.endif.endif.endif.else.endif.if.i.i ], [ %.758.i.i, %B0.endif.endif.else.endif.endif.endif.i.i ]
  br i1 %.993.not.i.i, label %B0.endif.endif.endif.endif.else.i.i, label %B0.endif.endif.endif.else.endif.endif.endif.if.i.i, !prof !10
B0.endif.endif.endif.else.endif.endif.endif.if.i.i:
  br label %B0.endif.endif.endif.endif.else.i.i
B0.endif.endif.endif.endif.else.i.i:
  %.956.sroa.13.0.i.i = phi i64 [ %.930.i.i, %B0.endif.endif.endif.else.endif.endif.endif.i.i ], [ %.1209.i, %B0.endif.endif.endif.else.endif.endif.endif.if.i.i ]
  %.1044.i.i = sub nsw i64 %.956.sroa.13.0.i.i, %.956.sroa.0.3.i.i
  %.1053.i.i = tail call i64 @llvm.smax.i64(i64 %.1044.i.i, i64 0)
  %.1069.i.i = getelementptr double, ptr %.1225.i, i64 %.956.sroa.0.3.i.i
  br i1 %.993.not.i.i, label %B0.endif.endif.endif.endif.else.endif.endif.endif.i.i, label %B0.endif.endif.endif.endif.else.endif.if.i.i, !prof !10
B0.endif.endif.endif.endif.else.endif.if.i.i:
  br label %B0.endif.endif.endif.endif.else.endif.endif.endif.i.i
B0.endif.endif.endif.endif.else.endif.endif.endif.i.i:
  %.1272.sroa.0.3.i.i = phi i64 [ %.1209.i, %B0.endif.endif.endif.endif.else.endif.if.i.i ], [ %.930.i.i, %B0.endif.endif.endif.endif.else.i.i ]
  %.1385.i.i = getelementptr double, ptr %.1225.i, i64 %.1272.sroa.0.3.i.i
  br i1 %.1309.not.i.i, label %B0.endif.endif.endif.endif.endif.endif.else.i.i, label %B0.endif.endif.endif.endif.endif.else.endif.if.i.i, !prof !10
B0.endif.endif.endif.endif.endif.else.endif.if.i.i:
  br label %B0.endif.endif.endif.endif.endif.endif.else.i.i
B0.endif.endif.endif.endif.endif.endif.else.i.i:
  %.1443.sroa.0.3.i.i = phi i64 [ %.1209.i, %B0.endif.endif.endif.endif.endif.else.endif.if.i.i ], [ %.1246.i.i, %B0.endif.endif.endif.endif.else.endif.endif.endif.i.i ]
  %.1556.i.i = getelementptr double, ptr %.1225.i, i64 %.1443.sroa.0.3.i.i
  br i1 %.1634.not.i.i, label %B0.endif.endif.endif.endif.endif.endif.endif.i.i, label %B0.endif.endif.endif.endif.endif.endif.else.endif.if.i.i, !prof !10
B0.endif.endif.endif.endif.endif.endif.endif.i.i:
  %.1614.sroa.0.3.i.i = phi i64 [ %.1209.i, %B0.endif.endif.endif.endif.endif.endif.else.endif.if.i.i ], [ %.1588.i.i, %B0.endif.endif.endif.endif.endif.endif.else.i.i ]
  %.1727.i.i = getelementptr double, ptr %.1225.i, i64 %.1614.sroa.0.3.i.i
  %scevgep.i133.i.i = getelementptr i8, ptr %.4276.i, i64 16
  br label %B56.i134.i.i
B56.i134.i.i:
  %lsr.iv3.i.i.i = phi i64 [ %lsr.iv.next.i.i.i, %B88.i.i.i ], [ %76, %B0.endif.endif.endif.endif.endif.endif.endif.i.i ]
  %lsr.iv.i135.i.i = phi ptr [ %scevgep1.i136.i.i, %B88.i.i.i ], [ %scevgep.i133.i.i, %B0.endif.endif.endif.endif.endif.endif.endif.i.i ]
  %scevgep1.i136.i.i = getelementptr i8, ptr %lsr.iv.i135.i.i, i64 48
  %lsr.iv.next.i.i.i = add i64 %lsr.iv3.i.i.i, -1
  %exitcond.not.i137.i.i = icmp eq i64 %lsr.iv.next.i.i.i, 0
  br i1 %exitcond.not.i137.i.i, label %B0.endif.endif.endif.endi...endif.5.endif.i.i, label %B58.i.i.i
B58.i.i.i:
  %scevgep2.i138.i.i = getelementptr i8, ptr %lsr.iv.i135.i.i, i64 -8
  %.215.i.i.i = load double, ptr %scevgep2.i138.i.i, align 8, !noalias !51
  %.216.i.i.i = fcmp une double %.215.i.i.i, 0.000000e+00
  br i1 %.216.i.i.i, label %B0.endif.endif.endif.endi...endif.5.endif.i.i, label %B88.i.i.i
B88.i.i.i:
  %.274.i.i.i = load double, ptr %lsr.iv.i135.i.i, align 8, !noalias !51
  %.275.i.i.i = fcmp une double %.274.i.i.i, 0.000000e+00
  br i1 %.275.i.i.i, label %B0.endif.endif.endif.endi...endif.5.endif.i.i, label %B56.i134.i.i
B0.endif.endif.endif.endif.endif.endif.else.endif.if.i.i:
  br label %B0.endif.endif.endif.endif.endif.endif.endif.i.i
B0.endif.endif.endif.endi...endif.5.endif.i.i:
  %.1898.i.i = load double, ptr %.1897.i.i, align 8, !noalias !7
  %.40.i139.i.i = fsub double %.3701.i, %.3701.i
  %scevgep.i142.i.i = getelementptr i8, ptr %.4276.i, i64 40
  br label %B402.else.i.i
B402.else.i.i:
  %.200628462848.i.i = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.5.endif.i.i ], [ %.2013.i.i, %B402.endif.endif.i.i ]
  %.2013.i.i = add nuw nsw i64 %.200628462848.i.i, 1
  %.2040.i.i = mul nuw nsw i64 %.200628462848.i.i, %.1566.i
  %.2043.i.i = mul nuw nsw i64 %.2013.i.i, %.1566.i
  %.2090.not.i.i = icmp sgt i64 %.1728.i, %.2040.i.i
  br i1 %.2090.not.i.i, label %B402.else.endif.endif.endif.i.i, label %B402.else.endif.if.i.i, !prof !10
B402.endif.i.i:
  %.2070.sroa.13.0.i.i = phi i64 [ %.2043.i.i, %B402.else.endif.endif.endif.i.i ], [ %.1737.i, %B402.else.endif.endif.endif.if.i.i ]
  %.132223.not.i140.not.i.i = icmp sgt i64 %.2070.sroa.13.0.i.i, %.2070.sroa.0.3.i.i
  br i1 %.132223.not.i140.not.i.i, label %B56.i143.i.i, label %B402.endif.endif.i.i
B56.i143.i.i:
  %lsr.iv399.i.i = phi i64 [ %lsr.iv.next400.i.i, %B316.i156.i.i ], [ %.2070.sroa.0.3.i.i, %B402.endif.i.i ]
  %lsr.iv.i144.i.i = phi ptr [ %scevgep1.i159.i.i, %B316.i156.i.i ], [ %scevgep.i142.i.i, %B402.endif.i.i ]
  %scevgep6.i147.i.i = getelementptr i8, ptr %lsr.iv.i144.i.i, i64 -40
  %.227.i148.i.i = load double, ptr %scevgep6.i147.i.i, align 8, !noalias !54
  %scevgep5.i149.i.i = getelementptr i8, ptr %lsr.iv.i144.i.i, i64 -32
  %.282.i150.i.i = load double, ptr %scevgep5.i149.i.i, align 8, !noalias !54
  %.284.i151.i.i = fmul double %.40.i139.i.i, %.282.i150.i.i
  %.285.i152.i.i = fadd double %.227.i148.i.i, %.284.i151.i.i
  %scevgep4.i153.i.i = getelementptr i8, ptr %lsr.iv.i144.i.i, i64 -24
  %.347.i154.i.i = load double, ptr %scevgep4.i153.i.i, align 8, !noalias !54
  %.348.i155.i.i = fcmp une double %.347.i154.i.i, 0.000000e+00
  br i1 %.348.i155.i.i, label %B134.i161.i.i, label %B316.i156.i.i
B134.i161.i.i:
  %scevgep3.i162.i.i = getelementptr i8, ptr %lsr.iv.i144.i.i, i64 -16
  %.405.i163.i.i = load double, ptr %scevgep3.i162.i.i, align 8, !noalias !54
  %scevgep2.i164.i.i = getelementptr i8, ptr %lsr.iv.i144.i.i, i64 -8
  %.460.i165.i.i = load double, ptr %scevgep2.i164.i.i, align 8, !noalias !54
  %.461.i166.i.i = fmul double %.460.i165.i.i, 5.000000e-01
  %.463.i167.i.i = fmul double %.40.i139.i.i, %.461.i166.i.i
  %.464.i168.i.i = fadd double %.405.i163.i.i, %.463.i167.i.i
  %.465.i169.i.i = fmul double %.464.i168.i.i, 0x401921FB54442D18
  %.467.i170.i.i = fmul double %.40.i139.i.i, %.465.i169.i.i
  %.522.i171.i.i = load double, ptr %lsr.iv.i144.i.i, align 8, !noalias !54
  %.523.i172.i.i = fadd double %.522.i171.i.i, %.467.i170.i.i
  %.586.le.i173.i.i = tail call double @llvm.sin.f64(double %.523.i172.i.i)
  %.591.i174.i.i = fmul double %.347.i154.i.i, %.586.le.i173.i.i
  %.593.i175.i.i = fadd double %.285.i152.i.i, %.591.i174.i.i
  br label %B316.i156.i.i
B316.i156.i.i:
  %value.2.1.i157.i.i = phi double [ %.593.i175.i.i, %B134.i161.i.i ], [ %.285.i152.i.i, %B56.i143.i.i ]
  %34 = shl i64 %lsr.iv399.i.i, 3
  %scevgep401.i.i = getelementptr i8, ptr %.1753.i, i64 %34
  store double %value.2.1.i157.i.i, ptr %scevgep401.i.i, align 8, !noalias !54
  %scevgep1.i159.i.i = getelementptr i8, ptr %lsr.iv.i144.i.i, i64 48
  %lsr.iv.next400.i.i = add i64 %lsr.iv399.i.i, 1
  %exitcond.not.i160.i.i = icmp eq i64 %.2070.sroa.13.0.i.i, %lsr.iv.next400.i.i
  br i1 %exitcond.not.i160.i.i, label %B402.endif.endif.i.i, label %B56.i143.i.i
B402.else.endif.if.i.i:
  br label %B402.else.endif.endif.endif.i.i
B402.else.endif.endif.endif.i.i:
  %.2070.sroa.0.3.i.i = phi i64 [ %.1737.i, %B402.else.endif.if.i.i ], [ %.2040.i.i, %B402.else.i.i ]
  %.2107.not.i.i = icmp sgt i64 %.1728.i, %.2043.i.i
  br i1 %.2107.not.i.i, label %B402.endif.i.i, label %B402.else.endif.endif.endif.if.i.i, !prof !10
B402.else.endif.endif.endif.if.i.i:
  br label %B402.endif.i.i
B402.endif.endif.i.i:
  %exitcond.not.i1.i = icmp eq i64 %.2013.i.i, 4
  br i1 %exitcond.not.i1.i, label %B476.i.i, label %B402.else.i.i
B494.endif.i.i:
  br i1 %79, label %B494.endif.endif.i.i, label %B56.i180.i.i
B56.i180.i.i:
  %lsr.iv.i181.i.i = phi ptr [ %scevgep1.i187.i.i, %B370.i.i.i ], [ %scevgep.i142.i.i, %B494.endif.i.i ]
  %.138242244.i.i.i = phi i64 [ %.145.i182.i.i, %B370.i.i.i ], [ 0, %B494.endif.i.i ]
  %.145.i182.i.i = add nuw nsw i64 %.138242244.i.i.i, 1
  %scevgep5.i183.i.i = getelementptr i8, ptr %lsr.iv.i181.i.i, i64 -32
  %.227.i184.i.i = load double, ptr %scevgep5.i183.i.i, align 8, !noalias !57
  %scevgep4.i185.i.i = getelementptr i8, ptr %lsr.iv.i181.i.i, i64 -24
  %.289.i.i.i = load double, ptr %scevgep4.i185.i.i, align 8, !noalias !57
  %.290.i.i.i = fcmp une double %.289.i.i.i, 0.000000e+00
  br i1 %.290.i.i.i, label %B106.i.i.i, label %B370.i.i.i
B106.i.i.i:
  %scevgep3.i189.i.i = getelementptr i8, ptr %lsr.iv.i181.i.i, i64 -16
  %.347.i190.i.i = load double, ptr %scevgep3.i189.i.i, align 8, !noalias !57
  %scevgep2.i191.i.i = getelementptr i8, ptr %lsr.iv.i181.i.i, i64 -8
  %.402.i192.i.i = load double, ptr %scevgep2.i191.i.i, align 8, !noalias !57
  %.403.i.i.i = fmul double %.402.i192.i.i, 5.000000e-01
  %.405.i193.i.i = fmul double %.40.i.i.i, %.403.i.i.i
  %.406.i.i.i = fadd double %.347.i190.i.i, %.405.i193.i.i
  %.407.i.i.i = fmul double %.406.i.i.i, 0x401921FB54442D18
  %.409.i.i.i = fmul double %.40.i.i.i, %.407.i.i.i
  %.464.i194.i.i = load double, ptr %lsr.iv.i181.i.i, align 8, !noalias !57
  %.465.i195.i.i = fadd double %.464.i194.i.i, %.409.i.i.i
  %.578.i.i.i = fmul double %.40.i.i.i, %.402.i192.i.i
  %.579.i.i.i = fadd double %.347.i190.i.i, %.578.i.i.i
  %.580.i.i.i = fmul double %.579.i.i.i, 0x401921FB54442D18
  %.636.i.i.i = fmul double %.289.i.i.i, %.580.i.i.i
  %.644.le.i.i.i = tail call double @llvm.cos.f64(double %.465.i195.i.i)
  %.649.i.i.i = fmul double %.636.i.i.i, %.644.le.i.i.i
  %.651.i.i.i = fadd double %.227.i184.i.i, %.649.i.i.i
  br label %B370.i.i.i
B370.i.i.i:
  %slope.2.1.i.i.i = phi double [ %.651.i.i.i, %B106.i.i.i ], [ %.227.i184.i.i, %B56.i180.i.i ]
  %35 = shl i64 %.138242244.i.i.i, 3
  %scevgep6.i186.i.i = getelementptr i8, ptr %.1925.i, i64 %35
  store double %slope.2.1.i.i.i, ptr %scevgep6.i186.i.i, align 8, !noalias !57
  %scevgep1.i187.i.i = getelementptr i8, ptr %lsr.iv.i181.i.i, i64 48
  %exitcond.not.i188.i.i = icmp eq i64 %.1900.i, %.145.i182.i.i
  br i1 %exitcond.not.i188.i.i, label %B494.endif.endif.i.i, label %B56.i180.i.i
B494.endif.endif.i.i:
  %.2462.i.i = load i64, ptr %a0, align 8, !noalias !7
  %.2519.i.i = inttoptr i64 %.2462.i.i to ptr
  tail call void %.2519.i.i(ptr nonnull %.2096.i, ptr %a2, ptr %.1582.i, ptr %.1925.i, ptr %a3, ptr %.1225.i, ptr %.2578.i, ptr %.725.i.i), !noalias !7
  %.2528.i.i = fcmp ugt double %h.5.0.i.i, 0.000000e+00
  br i1 %.2528.i.i, label %B752.endif.i.i, label %B660.i.i
B660.endif.i.i:
  %fastest.2.0.lcssa.i.i.i = phi double [ %.56.i.i.i, %B660.i.i ], [ %.13.i.i.i.i, %B66.backedge.i.i.i ]
  %.373.i.i.i = fdiv double 1.000000e+00, %fastest.2.0.lcssa.i.i.i
  %.2577.i.i = fcmp olt double %h.5.0.i.i, 0.000000e+00
  br i1 %.2577.i.i, label %B714.i.i, label %B752.endif.i.i
B752.endif.i.i:
  %h.7.1.i.i = phi double [ %h.5.0.i.i, %B490.i.i ], [ %h.5.0.i.i, %B494.endif.endif.i.i ], [ %.373.i.i.i, %B660.endif.i.i ], [ %.13.i.i.i, %B714.i.i ]
  %.2670.i.i = load double, ptr %a10, align 8, !noalias !7
  %.12.i112.i.i = fcmp olt double %.2670.i.i, %h.7.1.i.i
  %.13.i113.i.i = select i1 %.12.i112.i.i, double %.2670.i.i, double %h.7.1.i.i
  br i1 %5, label %B800.i.i, label %B828.i.i
switch.lookup.i.i:
  %.291128522855.i.i = phi i64 [ %.2918.i.i, %switch.end.endif.endif.i.i ], [ 0, %B864.i.i ]
  %.2918.i.i = add nuw nsw i64 %.291128522855.i.i, 1
  %switch.gep.i.i = getelementptr inbounds double, ptr @v21, i64 %.291128522855.i.i
  %switch.load.i.i = load double, ptr %switch.gep.i.i, align 8, !noalias !7
  %.2976.i.i = fmul double %"$phi864.0.2.1.in.sroa.speculated.i.i", %switch.load.i.i
  %.2978.i.i = fadd double %t.2.0.i.i, %.2976.i.i
  %.2980.i.i = mul nuw nsw i64 %.291128522855.i.i, %.1566.i
  %.2983.i.i = mul nuw nsw i64 %.2918.i.i, %.1566.i
  %.3030.not.i.i = icmp sgt i64 %.1728.i, %.2980.i.i
  br i1 %.3030.not.i.i, label %switch.end.else.endif.endif.endif.i.i, label %switch.end.else.endif.if.i.i, !prof !10
switch.end.endif.i.i:
  %.3010.sroa.13.0.i.i = phi i64 [ %.2983.i.i, %switch.end.else.endif.endif.endif.i.i ], [ %.1737.i, %switch.end.else.endif.endif.endif.if.i.i ]
  %.40.i196.i.i = fsub double %.2978.i.i, %.3701.i
  %.132223.not.i197.not.i.i = icmp sgt i64 %.3010.sroa.13.0.i.i, %.3010.sroa.0.3.i.i
  br i1 %.132223.not.i197.not.i.i, label %B56.i200.i.i, label %switch.end.endif.endif.i.i
B56.i200.i.i:
  %lsr.iv.i4.i = phi i64 [ %lsr.iv.next.i.i, %B316.i213.i.i ], [ %.3010.sroa.0.3.i.i, %switch.end.endif.i.i ]
  %lsr.iv.i201.i.i = phi ptr [ %scevgep1.i216.i.i, %B316.i213.i.i ], [ %scevgep.i142.i.i, %switch.end.endif.i.i ]
  %scevgep6.i204.i.i = getelementptr i8, ptr %lsr.iv.i201.i.i, i64 -40
  %.227.i205.i.i = load double, ptr %scevgep6.i204.i.i, align 8, !noalias !60
  %scevgep5.i206.i.i = getelementptr i8, ptr %lsr.iv.i201.i.i, i64 -32
  %.282.i207.i.i = load double, ptr %scevgep5.i206.i.i, align 8, !noalias !60
  %.284.i208.i.i = fmul double %.40.i196.i.i, %.282.i207.i.i
  %.285.i209.i.i = fadd double %.227.i205.i.i, %.284.i208.i.i
  %scevgep4.i210.i.i = getelementptr i8, ptr %lsr.iv.i201.i.i, i64 -24
  %.347.i211.i.i = load double, ptr %scevgep4.i210.i.i, align 8, !noalias !60
  %.348.i212.i.i = fcmp une double %.347.i211.i.i, 0.000000e+00
  br i1 %.348.i212.i.i, label %B134.i218.i.i, label %B316.i213.i.i
B134.i218.i.i:
  %scevgep3.i219.i.i = getelementptr i8, ptr %lsr.iv.i201.i.i, i64 -16
  %.405.i220.i.i = load double, ptr %scevgep3.i219.i.i, align 8, !noalias !60
  %scevgep2.i221.i.i = getelementptr i8, ptr %lsr.iv.i201.i.i, i64 -8
  %.460.i222.i.i = load double, ptr %scevgep2.i221.i.i, align 8, !noalias !60
  %.461.i223.i.i = fmul double %.460.i222.i.i, 5.000000e-01
  %.463.i224.i.i = fmul double %.40.i196.i.i, %.461.i223.i.i
  %.464.i225.i.i = fadd double %.405.i220.i.i, %.463.i224.i.i
  %.465.i226.i.i = fmul double %.464.i225.i.i, 0x401921FB54442D18
  %.467.i227.i.i = fmul double %.40.i196.i.i, %.465.i226.i.i
  %.522.i228.i.i = load double, ptr %lsr.iv.i201.i.i, align 8, !noalias !60
  %.523.i229.i.i = fadd double %.522.i228.i.i, %.467.i227.i.i
  %.586.le.i230.i.i = tail call double @llvm.sin.f64(double %.523.i229.i.i)
  %.591.i231.i.i = fmul double %.347.i211.i.i, %.586.le.i230.i.i
  %.593.i232.i.i = fadd double %.285.i209.i.i, %.591.i231.i.i
  br label %B316.i213.i.i
B316.i213.i.i:
  %value.2.1.i214.i.i = phi double [ %.593.i232.i.i, %B134.i218.i.i ], [ %.285.i209.i.i, %B56.i200.i.i ]
  %36 = shl i64 %lsr.iv.i4.i, 3
  %scevgep393.i.i = getelementptr i8, ptr %.1753.i, i64 %36
  store double %value.2.1.i214.i.i, ptr %scevgep393.i.i, align 8, !noalias !60
  %scevgep1.i216.i.i = getelementptr i8, ptr %lsr.iv.i201.i.i, i64 48
  %lsr.iv.next.i.i = add i64 %lsr.iv.i4.i, 1
  %exitcond.not.i217.i.i = icmp eq i64 %.3010.sroa.13.0.i.i, %lsr.iv.next.i.i
  br i1 %exitcond.not.i217.i.i, label %switch.end.endif.endif.i.i, label %B56.i200.i.i
switch.end.else.endif.if.i.i:
  br label %switch.end.else.endif.endif.endif.i.i
switch.end.else.endif.endif.endif.i.i:
  %.3010.sroa.0.3.i.i = phi i64 [ %.1737.i, %switch.end.else.endif.if.i.i ], [ %.2980.i.i, %switch.lookup.i.i ]
  %.3047.not.i.i = icmp sgt i64 %.1728.i, %.2983.i.i
  br i1 %.3047.not.i.i, label %switch.end.endif.i.i, label %switch.end.else.endif.endif.endif.if.i.i, !prof !10
switch.end.else.endif.endif.endif.if.i.i:
  br label %switch.end.endif.i.i
switch.end.endif.endif.i.i:
  %exitcond.not300.i.i = icmp eq i64 %.2918.i.i, 4
  br i1 %exitcond.not300.i.i, label %B1014.i.i, label %switch.lookup.i.i
B1050.endif.thread.i.i:
  %.3457241.i.i = load i64, ptr %sunkaddr174.i.i, align 8, !noalias !7
  %.3458242.i.i = add nsw i64 %.3457241.i.i, 1
  store i64 %.3458242.i.i, ptr %sunkaddr174.i.i, align 8, !noalias !7
  br label %B1228.i.i
B1050.endif.i.i:
  %.3457.i.i = load i64, ptr %sunkaddr174.i.i, align 8, !noalias !7
  %.3458.i.i = add nsw i64 %.3457.i.i, 1
  store i64 %.3458.i.i, ptr %sunkaddr174.i.i, align 8, !noalias !7
  %.3490.i.i = fcmp ugt double %worst.3.1.i.i.i, 1.000000e+00
  br i1 %.3490.i.i, label %B1228.i.i, label %B1276.i.i
B1668.endif.i.i:
  %.12.i124.i.i = fcmp olt double %storemerge.i116245.i.i, 1.000000e-10
  %.13.i125.i.i = select i1 %.12.i124.i.i, double 1.000000e-10, double %storemerge.i116245.i.i
  %.17.i.i.i = tail call double @llvm.pow.f64(double %.13.i125.i.i, double -2.500000e-01)
  %.18.i.i.i = fmul double %.17.i.i.i, 9.000000e-01
  %.27.i.i.i = fcmp ogt double %step_before.2.0.i.i, 0.000000e+00
  br i1 %.27.i.i.i, label %B42.endif.i.i.i, label %B1668.endif.endif.endif.i.i
B42.endif.i.i.i:
  %.34.i.i.i = fdiv double %"$phi864.0.2.1.in.sroa.speculated.i.i", %step_before.2.0.i.i
  %.39.i.i.i = fmul double %.34.i.i.i, 9.000000e-01
  %.42.i.i.i = fmul double %.13.i125.i.i, %.13.i125.i.i
  %.49.i.i.i = fdiv double %error_before.2.0.i.i, %.42.i.i.i
  %.52.i.i.i = tail call double @llvm.pow.f64(double %.49.i.i.i, double 2.500000e-01)
  %.53.i.i.i = fmul double %.39.i.i.i, %.52.i.i.i
  %.12.i1.i.i.i = fcmp olt double %.53.i.i.i, %.18.i.i.i
  %.13.i2.i.i.i = select i1 %.12.i1.i.i.i, double %.53.i.i.i, double %.18.i.i.i
  br label %B1668.endif.endif.endif.i.i
B1668.endif.endif.endif.i.i:
  %factor.2.0.i.i.i = phi double [ %.18.i.i.i, %B1668.endif.i.i ], [ %.13.i2.i.i.i, %B42.endif.i.i.i ]
  %.12.i.i234.i.i = fcmp ogt double %factor.2.0.i.i.i, 1.500000e-01
  %.13.i.i235.i.i = select i1 %.12.i.i234.i.i, double %factor.2.0.i.i.i, double 1.500000e-01
  %.12.i3.i.i.i = fcmp olt double %.13.i.i235.i.i, 6.000000e+00
  %.13.i4.i.i.i = select i1 %.12.i3.i.i.i, double %.13.i.i235.i.i, double 6.000000e+00
  %.12.i236.i.i = fcmp ogt double %.13.i125.i.i, 1.000000e-02
  %.13.i237.i.i = select i1 %.12.i236.i.i, double %.13.i125.i.i, double 1.000000e-02
  %.4339.i.i = fcmp olt double %"$phi864.0.2.1.in.sroa.speculated.i.i", %.13.i113.i.i
  br i1 %.4339.i.i, label %B1788.i.i, label %B1826.i.i
for.end.1.i.i:
  br i1 %.3503.le.i.i, label %B1920.endif.i.i, label %B2024.i.i
B1920.endif.i.i:
  %.4519.i.i = tail call double @llvm.pow.f64(double %storemerge.i116244.i.i, double -2.500000e-01)
  %.4522.i.i = fmul double %.4519.i.i, 9.000000e-01
  %.12.i130.i.i = fcmp olt double %.4522.i.i, 8.000000e-01
  %.13.i131.i.i = select i1 %.12.i130.i.i, double %.4522.i.i, double 8.000000e-01
  %.12.i238.i.i = fcmp ogt double %.13.i131.i.i, 1.500000e-01
  %.13.i239.i.i = select i1 %.12.i238.i.i, double %.13.i131.i.i, double 1.500000e-01
  br label %B2024.i.i
B2192.else.if.i.i:
  %window.3.1.i.i = select i1 %.123.i.i.i, double %t.3.1.i.i, double %window.2.0.i.i
  %.5275.i.i = fcmp olt double %t.3.1.i.i, %"$phi1384.1.2.1.i"
  br i1 %.5275.i.i, label %B490.i.i, label %_ZN6poppet6engine10integrator8_segmentB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
_ZN6poppet6engine10integrator8_segmentB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i:
  %.4340.sroa.12.2.i = phi double [ %"$phi1586.1.2.1.i", %B476.i.i ], [ %h.6.1.i.i, %B2182.split.loop.exit.i.i ], [ %"$phi864.0.2.1.in.sroa.speculated.i.i", %_ZN6poppet6engine10integrator5_takeB3v20B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i.i ], [ %.4590.i.i, %B2024.i.i ], [ %h.6.1.i.i, %B108.i.i.i ], [ %h.6.1.i.i, %B2192.else.if.i.i ]
  %.4340.sroa.7.2.i = phi double [ %.3701.i, %B476.i.i ], [ %t.3.1.i.i, %B2182.split.loop.exit.i.i ], [ %end.2.1.i.i, %_ZN6poppet6engine10integrator5_takeB3v20B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i.i ], [ %t.2.0.i.i, %B2024.i.i ], [ %t.3.1.i.i, %B108.i.i.i ], [ %t.3.1.i.i, %B2192.else.if.i.i ]
  %.4340.sroa.0.2.i = phi i64 [ 0, %B476.i.i ], [ %.mux.le.i.i, %B2182.split.loop.exit.i.i ], [ 1, %_ZN6poppet6engine10integrator5_takeB3v20B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dExdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit.i.i ], [ 2, %B2024.i.i ], [ 2, %B108.i.i.i ], [ 0, %B2192.else.if.i.i ]
  %.4647.not.i = icmp eq i64 %.4340.sroa.0.2.i, 0
  br i1 %.4647.not.i, label %B1816.i, label %B1820.i
B1704.i:
  %.4487.i = load i64, ptr %sunkaddr446.i, align 8, !noalias !0
  %.4538.i = mul i64 %.363026382645.i, %.1040.i
  %.4540.i = getelementptr double, ptr %a5, i64 %.4538.i
  %.180.i.i = load i64, ptr %.179.i.i, align 8, !noalias !63
  %.188.i.i = icmp slt i64 %.180.i.i, %.70.i
  br i1 %.188.i.i, label %B38.i.i, label %B1816.i
B38.i.i:
  %.233.i.i = icmp slt i64 %.180.i.i, 0
  %.234.i.i = select i1 %.233.i.i, i64 %.70.i, i64 0
  %37 = getelementptr double, ptr %a7, i64 %.180.i.i
  %.248.i.i = getelementptr double, ptr %37, i64 %.234.i.i
  %.249.i.i = load double, ptr %.248.i.i, align 8, !noalias !63
  %.251.i.i = fcmp olt double %.249.i.i, %"$phi1384.1.2.1.i"
  br i1 %.251.i.i, label %B74.preheader.i.i, label %B1816.i
B74.preheader.i.i:
  %scevgep.i.i.i = getelementptr i8, ptr %.4540.i, i64 40
  %38 = inttoptr i64 %.4487.i to ptr
  br label %B74.i.i
B74.i.i:
  %.286.i.i = phi i64 [ %.518.i.i, %B282.i.i ], [ %.180.i.i, %B74.preheader.i.i ]
  %.300.i.i = icmp slt i64 %.286.i.i, 0
  %.301.i.i = select i1 %.300.i.i, i64 %.70.i, i64 0
  %39 = getelementptr double, ptr %a7, i64 %.286.i.i
  %.315.i.i = getelementptr double, ptr %39, i64 %.301.i.i
  %.316.i.i = load double, ptr %.315.i.i, align 8, !noalias !63
  %.40.i.i5.i = fsub double %.316.i.i, %.3701.i
  br i1 %59, label %B74.endif.i.i, label %B56.i.i6.i
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
  br i1 %.348.i.i18.i, label %B134.i.i26.i, label %B316.i.i19.i
B134.i.i26.i:
  %scevgep3.i.i27.i = getelementptr i8, ptr %lsr.iv.i.i7.i, i64 -16
  %.405.i.i28.i = load double, ptr %scevgep3.i.i27.i, align 8, !noalias !66
  %scevgep2.i.i29.i = getelementptr i8, ptr %lsr.iv.i.i7.i, i64 -8
  %.460.i.i30.i = load double, ptr %scevgep2.i.i29.i, align 8, !noalias !66
  %.461.i.i31.i = fmul double %.460.i.i30.i, 5.000000e-01
  %.463.i.i32.i = fmul double %.40.i.i5.i, %.461.i.i31.i
  %.464.i.i33.i = fadd double %.405.i.i28.i, %.463.i.i32.i
  %.465.i.i34.i = fmul double %.464.i.i33.i, 0x401921FB54442D18
  %.467.i.i35.i = fmul double %.40.i.i5.i, %.465.i.i34.i
  %.522.i.i36.i = load double, ptr %lsr.iv.i.i7.i, align 8, !noalias !66
  %.523.i.i37.i = fadd double %.522.i.i36.i, %.467.i.i35.i
  %.586.le.i.i38.i = tail call double @llvm.sin.f64(double %.523.i.i37.i)
  %.591.i.i39.i = fmul double %.347.i.i17.i, %.586.le.i.i38.i
  %.593.i.i40.i = fadd double %.285.i.i15.i, %.591.i.i39.i
  br label %B316.i.i19.i
B316.i.i19.i:
  %value.2.1.i.i20.i = phi double [ %.593.i.i40.i, %B134.i.i26.i ], [ %.285.i.i15.i, %B56.i.i6.i ]
  %40 = shl i64 %.138222224.i.i8.i, 3
  %scevgep7.i.i21.i = getelementptr i8, ptr %.1582.i, i64 %40
  store double %value.2.1.i.i20.i, ptr %scevgep7.i.i21.i, align 8, !noalias !66
  %scevgep1.i.i22.i = getelementptr i8, ptr %lsr.iv.i.i7.i, i64 48
  %exitcond.not.i.i23.i = icmp eq i64 %.1557.i, %.145.i.i9.i
  br i1 %exitcond.not.i.i23.i, label %B74.endif.loopexit.i.i, label %B56.i.i6.i
B282.i.i:
  %.631.i.i = icmp slt i64 %.517.i.i, -1
  %.632.i.i = select i1 %.631.i.i, i64 %.70.i, i64 0
  %41 = getelementptr double, ptr %a7, i64 %.518.i.i
  %.646.i.i = getelementptr double, ptr %41, i64 %.632.i.i
  %.647.i.i = load double, ptr %.646.i.i, align 8, !noalias !63
  %.649.i.i = fcmp olt double %.647.i.i, %"$phi1384.1.2.1.i"
  br i1 %.649.i.i, label %B74.i.i, label %B1816.i
B74.endif.loopexit.i.i:
  %.382.pre.i.i = load i64, ptr %.179.i.i, align 8, !noalias !63
  br label %B74.endif.i.i
B74.endif.i.i:
  %.382.i.i = phi i64 [ %.382.pre.i.i, %B74.endif.loopexit.i.i ], [ %.286.i.i, %B74.i.i ]
  %.396.i.i = icmp slt i64 %.382.i.i, 0
  %.397.i.i = select i1 %.396.i.i, i64 %.70.i, i64 0
  %42 = getelementptr double, ptr %a7, i64 %.382.i.i
  %.411.i.i = getelementptr double, ptr %42, i64 %.397.i.i
  %.412.i.i = load double, ptr %.411.i.i, align 8, !noalias !63
  store double %.412.i.i, ptr %.2096.i, align 8, !noalias !69
  tail call void %38(ptr nonnull %.2096.i, ptr %a2, ptr %.1582.i, ptr %a3, ptr %.3116.i), !noalias !69
  br i1 %69, label %B74.endif.endif.i.i, label %B96.lr.ph.i.i.i
B96.lr.ph.i.i.i:
  br i1 %70, label %B96.epil.preheader.i.i.i, label %B96.lr.ph.new.i.i.i
B96.lr.ph.new.i.i.i:
  %invariant.gep.i.i24.i = getelementptr double, ptr %a13, i64 %.382.i.i
  %invariant.gep159.i.i.i = getelementptr double, ptr %invariant.gep.i.i24.i, i64 %.397.i.i
  br i1 %71, label %B96.i.epil.preheader.i.i, label %B96.i.i.i
B96.i.i.i:
  %lsr.iv1.i.i = phi i64 [ %lsr.iv.next2.i.i, %B96.i.i.i ], [ %68, %B96.lr.ph.new.i.i.i ]
  %lsr.iv13.i.i.i = phi ptr [ %scevgep32.i.i, %B96.i.i.i ], [ %invariant.gep159.i.i.i, %B96.lr.ph.new.i.i.i ]
  %.259154156.i.i.i = phi i64 [ %.266.3.i.1.i.i, %B96.i.i.i ], [ 0, %B96.lr.ph.new.i.i.i ]
  %sunkaddr18.i.i = shl i64 %.259154156.i.i.i, 3
  %sunkaddr19.i.i = getelementptr i8, ptr %.3116.i, i64 %sunkaddr18.i.i
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
  %sunkaddr39.i.i = getelementptr i8, ptr %.3116.i, i64 %sunkaddr38.i.i
  %sunkaddr40.i.i = getelementptr i8, ptr %sunkaddr39.i.i, i64 -8
  %.320.3.i.1.i.i = load double, ptr %sunkaddr40.i.i, align 8, !noalias !69
  %scevgep31.i.i = getelementptr i8, ptr %scevgep30.i.i, i64 %.16.i.i
  store double %.320.3.i.1.i.i, ptr %scevgep31.i.i, align 8, !noalias !69
  %scevgep32.i.i = getelementptr i8, ptr %scevgep31.i.i, i64 %.16.i.i
  %lsr.iv.next2.i.i = add i64 %lsr.iv1.i.i, 2
  %niter.ncmp.1.i.i = icmp eq i64 %lsr.iv.next2.i.i, 0
  br i1 %niter.ncmp.1.i.i, label %B126.loopexit.unr-lcssa.i.unr-lcssa.i.i, label %B96.i.i.i
B126.loopexit.unr-lcssa.i.unr-lcssa.i.i:
  %scevgep14.i.i.i = getelementptr i8, ptr %lsr.iv13.i.i.i, i64 %62
  %scevgep14.i.1.i.i = getelementptr i8, ptr %scevgep14.i.i.i, i64 %62
  br i1 %73, label %B96.i.epil.preheader.i.i, label %B126.loopexit.unr-lcssa.i.i.i
B96.i.epil.preheader.i.i:
  %lsr.iv13.i.epil.init.i.i = phi ptr [ %invariant.gep159.i.i.i, %B96.lr.ph.new.i.i.i ], [ %scevgep14.i.1.i.i, %B126.loopexit.unr-lcssa.i.unr-lcssa.i.i ]
  %.259154156.i.epil.init.i.i = phi i64 [ 0, %B96.lr.ph.new.i.i.i ], [ %.266.3.i.1.i.i, %B126.loopexit.unr-lcssa.i.unr-lcssa.i.i ]
  %sunkaddr.i.epil.i.i = shl i64 %.259154156.i.epil.init.i.i, 3
  %sunkaddr18.i.epil.i.i = getelementptr i8, ptr %.3116.i, i64 %sunkaddr.i.epil.i.i
  %.320.i.epil.i.i = load double, ptr %sunkaddr18.i.epil.i.i, align 8, !noalias !69
  store double %.320.i.epil.i.i, ptr %lsr.iv13.i.epil.init.i.i, align 8, !noalias !69
  %sunkaddr21.i.epil.i.i = getelementptr i8, ptr %sunkaddr18.i.epil.i.i, i64 8
  %.320.1.i.epil.i.i = load double, ptr %sunkaddr21.i.epil.i.i, align 8, !noalias !69
  %sunkaddr23.i.epil.i.i = getelementptr i8, ptr %lsr.iv13.i.epil.init.i.i, i64 %.16.i.i
  store double %.320.1.i.epil.i.i, ptr %sunkaddr23.i.epil.i.i, align 8, !noalias !69
  %sunkaddr26.i.epil.i.i = getelementptr i8, ptr %sunkaddr18.i.epil.i.i, i64 16
  %.320.2.i.epil.i.i = load double, ptr %sunkaddr26.i.epil.i.i, align 8, !noalias !69
  %scevgep16.i.epil.i.i = getelementptr i8, ptr %lsr.iv13.i.epil.init.i.i, i64 %63
  store double %.320.2.i.epil.i.i, ptr %scevgep16.i.epil.i.i, align 8, !noalias !69
  %sunkaddr29.i.epil.i.i = getelementptr i8, ptr %sunkaddr18.i.epil.i.i, i64 24
  %.320.3.i.epil.i.i = load double, ptr %sunkaddr29.i.epil.i.i, align 8, !noalias !69
  %scevgep15.i.epil.i.i = getelementptr i8, ptr %lsr.iv13.i.epil.init.i.i, i64 %61
  store double %.320.3.i.epil.i.i, ptr %scevgep15.i.epil.i.i, align 8, !noalias !69
  br label %B126.loopexit.unr-lcssa.i.i.i
B126.loopexit.unr-lcssa.i.i.i:
  br i1 %74, label %B74.endif.endif.i.i, label %B96.epil.preheader.i.i.i
B96.epil.preheader.i.i.i:
  %.259154156.epil.init.i.i.i = phi i64 [ %unroll_iter.i.i.i, %B126.loopexit.unr-lcssa.i.i.i ], [ 0, %B96.lr.ph.i.i.i ]
  %43 = mul i64 %.259154156.epil.init.i.i.i, %.70.i
  %44 = add i64 %.397.i.i, %.382.i.i
  %45 = add i64 %44, %43
  %46 = shl i64 %45, 3
  %scevgep.i4.i.i = getelementptr i8, ptr %a13, i64 %46
  %47 = shl i64 %.259154156.epil.init.i.i.i, 3
  %scevgep3.i5.i.i = getelementptr i8, ptr %.3116.i, i64 %47
  br label %B96.epil.i.i.i
B96.epil.i.i.i:
  %lsr.iv.i6.i.i = phi ptr [ %scevgep2.i8.i.i, %B96.epil.i.i.i ], [ %scevgep.i4.i.i, %B96.epil.preheader.i.i.i ]
  %epil.iter.i.i.i = phi i64 [ %epil.iter.next.i.i.i, %B96.epil.i.i.i ], [ 0, %B96.epil.preheader.i.i.i ]
  %48 = shl i64 %epil.iter.i.i.i, 3
  %scevgep33.i.i = getelementptr i8, ptr %scevgep3.i5.i.i, i64 %48
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
  %.586.i25.i = icmp slt i64 %.518.i.i, %.70.i
  br i1 %.586.i25.i, label %B282.i.i, label %B1816.i
B1816.i:
  %h.4.12588.i = phi double [ %.4340.sroa.12.2.i, %_ZN6poppet6engine10integrator8_segmentB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ], [ %"$phi1586.1.2.1.i", %B1704.i ], [ %"$phi1586.1.2.1.i", %B38.i.i ], [ %"$phi1586.1.2.1.i", %B282.i.i ], [ %"$phi1586.1.2.1.i", %B74.endif.endif.i.i ]
  %t.6.12587.i = phi double [ %.4340.sroa.7.2.i, %_ZN6poppet6engine10integrator8_segmentB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ], [ %"$phi1384.1.2.1.i", %B1704.i ], [ %"$phi1384.1.2.1.i", %B38.i.i ], [ %"$phi1384.1.2.1.i", %B282.i.i ], [ %"$phi1384.1.2.1.i", %B74.endif.endif.i.i ]
  %exitcond2668.not.i = icmp eq i64 %.3637.i, %.32.i
  br i1 %exitcond2668.not.i, label %B1820.i, label %B1306.i
B1820.i:
  %status.5.1.i = phi i64 [ 0, %B1218.endif.i ], [ 1, %B1398.endif.endif.i ], [ %.4340.sroa.0.2.i, %_ZN6poppet6engine10integrator8_segmentB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ], [ 0, %B1816.i ]
  %t.4.1.i = phi double [ %.3506.i, %B1218.endif.i ], [ %.3701.i, %B1398.endif.endif.i ], [ %.4340.sroa.7.2.i, %_ZN6poppet6engine10integrator8_segmentB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ], [ %t.6.12587.i, %B1816.i ]
  %k.2.1.i = phi i64 [ 0, %B1218.endif.i ], [ %.363026382645.i, %B1398.endif.endif.i ], [ %.363026382645.i, %_ZN6poppet6engine10integrator8_segmentB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ], [ %.363026382645.i, %B1816.i ]
  %switch.i = icmp ult i64 %status.5.1.i, 2
  br i1 %switch.i, label %B1864.i, label %_ZN6poppet6engine10integrator9integrateB2v1B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAg6cJqBrMeIZJFEGM0QQAE8int64_2a8int64_2a10float64_2a10float64_2a10float64_2a10float64_2a8uint8_2a10float64_2a10float64_2a8uint8_2a10float64_2a8int64_2a10float64_2a10float64_2a10float64_2a10float64_2a8int64_2a10float64_2a10float64_2a.exit
B1864.i:
  %49 = getelementptr double, ptr %a4, i64 %k.2.1.i
  %.4899.i = load double, ptr %49, align 8, !noalias !0
  %.40.i7.i = fsub double %t.4.1.i, %.4899.i
  %.132223.not.i8.i = icmp slt i64 %.1557.i, 1
  br i1 %.132223.not.i8.i, label %B1864.endif.endif.i, label %B56.preheader.i9.i
B56.preheader.i9.i:
  %.4955.i = mul i64 %k.2.1.i, %.1040.i
  %.4957.i = getelementptr double, ptr %a5, i64 %.4955.i
  %scevgep.i10.i = getelementptr i8, ptr %.4957.i, i64 40
  br label %B56.i11.i
B56.i11.i:
  %lsr.iv418.i = phi i64 [ %lsr.iv.next419.i, %B316.i24.i ], [ %.1469.sroa.0.3.i, %B56.preheader.i9.i ]
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
  %50 = shl i64 %lsr.iv418.i, 3
  %scevgep420.i = getelementptr i8, ptr %.1397.i, i64 %50
  store double %value.2.1.i25.i, ptr %scevgep420.i, align 8, !noalias !73
  %scevgep1.i27.i = getelementptr i8, ptr %lsr.iv.i12.i, i64 48
  %lsr.iv.next419.i = add nuw i64 %lsr.iv418.i, 1
  %exitcond.not.i28.i = icmp eq i64 %.1469.sroa.13.0.i, %lsr.iv.next419.i
  br i1 %exitcond.not.i28.i, label %B1864.endif.endif.i, label %B56.i11.i
B0.endif.endif.endif.endi...endif.3.else.endif.if.i:
  br label %B0.endif.endif.endif.endi...endif.3.else.endif.endif.i
B0.endif.endif.endif.endi...endif.3.else.endif.endif.i:
  %.1112.sroa.0.3.i = phi i64 [ %.1045.i, %B0.endif.endif.endif.endi...endif.3.else.endif.if.i ], [ 0, %0 ]
  %.1139.i = icmp slt i64 %.24.i, 0
  %.1140.i = select i1 %.1139.i, i64 %.1045.i, i64 0
  %.1141.i = add i64 %.1140.i, %.1039.i
  %.1144.i = icmp slt i64 %.1141.i, 0
  br i1 %.1144.i, label %B0.endif.endif.endif.endi...if.4.i, label %B0.endif.endif.endif.endi...endif.4.i, !prof !3
B0.endif.endif.endif.endi...if.4.i:
  br label %B0.endif.endif.endif.endi...endif.4.i
B0.endif.endif.endif.endi...endif.4.i:
  %.1112.sroa.13.1.i = phi i64 [ 0, %B0.endif.endif.endif.endi...if.4.i ], [ %.1141.i, %B0.endif.endif.endif.endi...endif.3.else.endif.endif.i ]
  %.1149.not.i = icmp slt i64 %.1141.i, %.1045.i
  br i1 %.1149.not.i, label %B0.endif.endif.endif.endi...endif.3.endif.else.i, label %B0.endif.endif.endif.endi...endif.4.if.i, !prof !10
B0.endif.endif.endif.endi...endif.4.if.i:
  br label %B0.endif.endif.endif.endi...endif.3.endif.else.i
B0.endif.endif.endif.endi...endif.3.endif.else.i:
  %.1112.sroa.13.0.i = phi i64 [ %.1112.sroa.13.1.i, %B0.endif.endif.endif.endi...endif.4.i ], [ %.1045.i, %B0.endif.endif.endif.endi...endif.4.if.i ]
  %.1200.i = sub i64 %.1112.sroa.13.0.i, %.1112.sroa.0.3.i
  %.1209.i = tail call i64 @llvm.smax.i64(i64 %.1200.i, i64 0)
  %.1225.i = getelementptr double, ptr %a17, i64 %.1112.sroa.0.3.i
  br i1 %.1144.i, label %B0.endif.endif.endif.endi...endif.3.endif.else.if.i, label %B0.endif.endif.endif.endi...endif.3.endif.else.endif.i, !prof !3
B0.endif.endif.endif.endi...endif.3.endif.else.if.i:
  br label %B0.endif.endif.endif.endi...endif.3.endif.else.endif.i
B0.endif.endif.endif.endi...endif.3.endif.else.endif.i:
  %.1284.sroa.0.1.i = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.3.endif.else.if.i ], [ %.1141.i, %B0.endif.endif.endif.endi...endif.3.endif.else.i ]
  br i1 %.1149.not.i, label %B0.endif.endif.endif.endi...endif.3.endif.endif.else.i, label %B0.endif.endif.endif.endi...if.6.i, !prof !10
B0.endif.endif.endif.endi...if.6.i:
  br label %B0.endif.endif.endif.endi...endif.3.endif.endif.else.i
B0.endif.endif.endif.endi...endif.3.endif.endif.else.i:
  %.1284.sroa.0.3.i = phi i64 [ %.1045.i, %B0.endif.endif.endif.endi...if.6.i ], [ %.1284.sroa.0.1.i, %B0.endif.endif.endif.endi...endif.3.endif.else.endif.i ]
  %.1372.i = sub i64 %.1045.i, %.1284.sroa.0.3.i
  %.1381.i = tail call i64 @llvm.smax.i64(i64 %.1372.i, i64 0)
  %.1397.i = getelementptr double, ptr %a17, i64 %.1284.sroa.0.3.i
  %.1489.i = icmp slt i64 %.1372.i, 1
  br i1 %.1489.i, label %B0.endif.endif.endif.endi...endif.8.if.i, label %B0.endif.endif.endif.endi...endif.8.endif.i, !prof !3
B0.endif.endif.endif.endi...endif.8.if.i:
  br label %B0.endif.endif.endif.endi...endif.8.endif.i
B0.endif.endif.endif.endi...endif.8.endif.i:
  %.1469.sroa.0.3.i = phi i64 [ %.1381.i, %B0.endif.endif.endif.endi...endif.8.if.i ], [ 0, %B0.endif.endif.endif.endi...endif.3.endif.endif.else.i ]
  %.1496.i = icmp slt i64 %.28.i, 0
  %.1497.i = select i1 %.1496.i, i64 %.1381.i, i64 0
  %.1498.i = add i64 %.1497.i, %.28.i
  %.1501.i = icmp slt i64 %.1498.i, 0
  br i1 %.1501.i, label %B0.endif.endif.endif.endi...endif.8.endif.if.i, label %B0.endif.endif.endif.endi...endif.8.endif.endif.i, !prof !3
B0.endif.endif.endif.endi...endif.8.endif.if.i:
  br label %B0.endif.endif.endif.endi...endif.8.endif.endif.i
B0.endif.endif.endif.endi...endif.8.endif.endif.i:
  %.1469.sroa.13.1.i = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.8.endif.if.i ], [ %.1498.i, %B0.endif.endif.endif.endi...endif.8.endif.i ]
  %.1506.not.i = icmp slt i64 %.1498.i, %.1381.i
  br i1 %.1506.not.i, label %B0.endif.endif.endif.endi...else.i, label %B0.endif.endif.endif.endi...endif.8.endif.endif.if.i, !prof !10
B0.endif.endif.endif.endi...endif.8.endif.endif.if.i:
  br label %B0.endif.endif.endif.endi...else.i
B0.endif.endif.endif.endi...else.i:
  %.1469.sroa.13.0.i = phi i64 [ %.1469.sroa.13.1.i, %B0.endif.endif.endif.endi...endif.8.endif.endif.i ], [ %.1381.i, %B0.endif.endif.endif.endi...endif.8.endif.endif.if.i ]
  %.1557.i = sub nsw i64 %.1469.sroa.13.0.i, %.1469.sroa.0.3.i
  %.1566.i = tail call i64 @llvm.smax.i64(i64 %.1557.i, i64 0)
  %.1582.i = getelementptr double, ptr %.1397.i, i64 %.1469.sroa.0.3.i
  %.1614.i = mul nsw i64 %.28.i, 5
  br i1 %.1501.i, label %B0.endif.endif.endif.endi...else.if.i, label %B0.endif.endif.endif.endi...else.endif.i, !prof !3
B0.endif.endif.endif.endi...else.if.i:
  br label %B0.endif.endif.endif.endi...else.endif.i
B0.endif.endif.endif.endi...else.endif.i:
  %.1640.sroa.0.1.i = phi i64 [ 0, %B0.endif.endif.endif.endi...else.if.i ], [ %.1498.i, %B0.endif.endif.endif.endi...else.i ]
  br i1 %.1506.not.i, label %B0.endif.endif.endif.endi...else.endif.endif.i, label %B0.endif.endif.endif.endi...else.endif.if.i, !prof !10
B0.endif.endif.endif.endi...else.endif.if.i:
  br label %B0.endif.endif.endif.endi...else.endif.endif.i
B0.endif.endif.endif.endi...else.endif.endif.i:
  %.1640.sroa.0.3.i = phi i64 [ %.1381.i, %B0.endif.endif.endif.endi...else.endif.if.i ], [ %.1640.sroa.0.1.i, %B0.endif.endif.endif.endi...else.endif.i ]
  %.1669.i = add i64 %.1497.i, %.1614.i
  %.1672.i = icmp slt i64 %.1669.i, 0
  br i1 %.1672.i, label %B0.endif.endif.endif.endi...else.endif.endif.if.i, label %B0.endif.endif.endif.endi...else.endif.endif.endif.i, !prof !3
B0.endif.endif.endif.endi...else.endif.endif.if.i:
  br label %B0.endif.endif.endif.endi...else.endif.endif.endif.i
B0.endif.endif.endif.endi...else.endif.endif.endif.i:
  %.1640.sroa.13.1.i = phi i64 [ 0, %B0.endif.endif.endif.endi...else.endif.endif.if.i ], [ %.1669.i, %B0.endif.endif.endif.endi...else.endif.endif.i ]
  %.1677.not.i = icmp slt i64 %.1669.i, %.1381.i
  br i1 %.1677.not.i, label %B0.endif.endif.endif.endi...endif.10.else.i, label %B0.endif.endif.endif.endi...else.endif.endif.endif.if.i, !prof !10
B0.endif.endif.endif.endi...else.endif.endif.endif.if.i:
  br label %B0.endif.endif.endif.endi...endif.10.else.i
B0.endif.endif.endif.endi...endif.10.else.i:
  %.1640.sroa.13.0.i = phi i64 [ %.1640.sroa.13.1.i, %B0.endif.endif.endif.endi...else.endif.endif.endif.i ], [ %.1381.i, %B0.endif.endif.endif.endi...else.endif.endif.endif.if.i ]
  %.1728.i = sub nsw i64 %.1640.sroa.13.0.i, %.1640.sroa.0.3.i
  %.1737.i = tail call i64 @llvm.smax.i64(i64 %.1728.i, i64 0)
  %.1753.i = getelementptr double, ptr %.1397.i, i64 %.1640.sroa.0.3.i
  br i1 %.1672.i, label %B0.endif.endif.endif.endi...endif.10.else.if.i, label %B0.endif.endif.endif.endi...endif.10.else.endif.i, !prof !3
B0.endif.endif.endif.endi...endif.10.else.if.i:
  br label %B0.endif.endif.endif.endi...endif.10.else.endif.i
B0.endif.endif.endif.endi...endif.10.else.endif.i:
  %.1812.sroa.0.1.i = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.10.else.if.i ], [ %.1669.i, %B0.endif.endif.endif.endi...endif.10.else.i ]
  br i1 %.1677.not.i, label %B0.endif.endif.endif.endi...endif.10.else.endif.endif.i, label %B0.endif.endif.endif.endi...endif.10.else.endif.if.i, !prof !10
B0.endif.endif.endif.endi...endif.10.else.endif.if.i:
  br label %B0.endif.endif.endif.endi...endif.10.else.endif.endif.i
B0.endif.endif.endif.endi...endif.10.else.endif.endif.i:
  %.1812.sroa.0.3.i = phi i64 [ %.1381.i, %B0.endif.endif.endif.endi...endif.10.else.endif.if.i ], [ %.1812.sroa.0.1.i, %B0.endif.endif.endif.endi...endif.10.else.endif.i ]
  %.1841.i = add i64 %.1497.i, %.1040.i
  %.1844.i = icmp slt i64 %.1841.i, 0
  br i1 %.1844.i, label %B0.endif.endif.endif.endi...if.12.i, label %B0.endif.endif.endif.endi...endif.12.i, !prof !3
B0.endif.endif.endif.endi...if.12.i:
  br label %B0.endif.endif.endif.endi...endif.12.i
B0.endif.endif.endif.endi...endif.12.i:
  %.1812.sroa.13.1.i = phi i64 [ 0, %B0.endif.endif.endif.endi...if.12.i ], [ %.1841.i, %B0.endif.endif.endif.endi...endif.10.else.endif.endif.i ]
  %.1849.not.i = icmp slt i64 %.1841.i, %.1381.i
  br i1 %.1849.not.i, label %B0.endif.endif.endif.endi...endif.10.endif.else.i, label %B0.endif.endif.endif.endi...endif.12.if.i, !prof !10
B0.endif.endif.endif.endi...endif.12.if.i:
  br label %B0.endif.endif.endif.endi...endif.10.endif.else.i
B0.endif.endif.endif.endi...endif.10.endif.else.i:
  %.1812.sroa.13.0.i = phi i64 [ %.1812.sroa.13.1.i, %B0.endif.endif.endif.endi...endif.12.i ], [ %.1381.i, %B0.endif.endif.endif.endi...endif.12.if.i ]
  %.1900.i = sub nsw i64 %.1812.sroa.13.0.i, %.1812.sroa.0.3.i
  %.1925.i = getelementptr double, ptr %.1397.i, i64 %.1812.sroa.0.3.i
  br i1 %.1844.i, label %B0.endif.endif.endif.endi...endif.10.endif.else.if.i, label %B0.endif.endif.endif.endi...endif.10.endif.else.endif.i, !prof !3
B0.endif.endif.endif.endi...endif.10.endif.else.if.i:
  br label %B0.endif.endif.endif.endi...endif.10.endif.else.endif.i
B0.endif.endif.endif.endi...endif.10.endif.else.endif.i:
  %.1983.sroa.0.1.i = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.10.endif.else.if.i ], [ %.1841.i, %B0.endif.endif.endif.endi...endif.10.endif.else.i ]
  br i1 %.1849.not.i, label %B0.endif.endif.endif.endi...endif.16.i, label %B0.endif.endif.endif.endi...if.14.i, !prof !10
B0.endif.endif.endif.endi...if.14.i:
  br label %B0.endif.endif.endif.endi...endif.16.i
B0.endif.endif.endif.endi...endif.16.i:
  %.1983.sroa.0.3.i = phi i64 [ %.1381.i, %B0.endif.endif.endif.endi...if.14.i ], [ %.1983.sroa.0.1.i, %B0.endif.endif.endif.endi...endif.10.endif.else.endif.i ]
  %.2071.i = sub nsw i64 %.1381.i, %.1983.sroa.0.3.i
  %.2080.i = tail call i64 @llvm.smax.i64(i64 %.2071.i, i64 0)
  %.2096.i = getelementptr double, ptr %.1397.i, i64 %.1983.sroa.0.3.i
  %.24392670.i = add nsw i64 %.74.i, 2
  %51 = tail call i64 @llvm.umin.i64(i64 %.2080.i, i64 2)
  %.2492.i = icmp slt i64 %.74.i, -2
  %.2493.i = select i1 %.2492.i, i64 %.2080.i, i64 0
  %.2494.i = add i64 %.24392670.i, %.2493.i
  %.2497.i = icmp slt i64 %.2494.i, 0
  %.2502.not.i = icmp slt i64 %.2494.i, %.2080.i
  %.2578.i = getelementptr double, ptr %.2096.i, i64 %51
  br i1 %.2497.i, label %B0.endif.endif.endif.endi...endif.18.else.if.i, label %B0.endif.endif.endif.endi...endif.18.else.endif.i, !prof !3
B0.endif.endif.endif.endi...endif.18.else.if.i:
  br label %B0.endif.endif.endif.endi...endif.18.else.endif.i
B0.endif.endif.endif.endi...endif.18.else.endif.i:
  %.2636.sroa.0.1.i = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.18.else.if.i ], [ %.2494.i, %B0.endif.endif.endif.endi...endif.16.i ]
  br i1 %.2502.not.i, label %B0.endif.endif.endif.endi...endif.18.endif.else.i, label %B0.endif.endif.endif.endi...endif.18.else.endif.if.i, !prof !10
B0.endif.endif.endif.endi...endif.18.else.endif.if.i:
  br label %B0.endif.endif.endif.endi...endif.18.endif.else.i
B0.endif.endif.endif.endi...endif.18.endif.else.i:
  %.2636.sroa.0.3.i = phi i64 [ %.2080.i, %B0.endif.endif.endif.endi...endif.18.else.endif.if.i ], [ %.2636.sroa.0.1.i, %B0.endif.endif.endif.endi...endif.18.else.endif.i ]
  %.2724.i = sub nsw i64 %.2080.i, %.2636.sroa.0.3.i
  %.2733.i = tail call i64 @llvm.smax.i64(i64 %.2724.i, i64 0)
  %.2749.i = getelementptr double, ptr %.2096.i, i64 %.2636.sroa.0.3.i
  %.2853.i = icmp slt i64 %.2724.i, 1
  br i1 %.2853.i, label %B0.endif.endif.endif.endi...if.23.i, label %B0.endif.endif.endif.endi...endif.23.i, !prof !3
B0.endif.endif.endif.endi...if.23.i:
  br label %B0.endif.endif.endif.endi...endif.23.i
B0.endif.endif.endif.endi...endif.23.i:
  %.2833.sroa.0.3.i = phi i64 [ %.2733.i, %B0.endif.endif.endif.endi...if.23.i ], [ 0, %B0.endif.endif.endif.endi...endif.18.endif.else.i ]
  %.2860.i = icmp slt i64 %.76.i, 0
  %.2861.i = select i1 %.2860.i, i64 %.2733.i, i64 0
  %.2862.i = add i64 %.2861.i, %.76.i
  %.2865.i = icmp slt i64 %.2862.i, 0
  %.2870.not.i = icmp slt i64 %.2862.i, %.2733.i
  %.2946.i = getelementptr double, ptr %.2749.i, i64 %.2833.sroa.0.3.i
  br i1 %.2865.i, label %B0.endif.endif.endif.endi...if.25.i, label %B0.endif.endif.endif.endi...endif.25.i, !prof !3
B0.endif.endif.endif.endi...if.25.i:
  br label %B0.endif.endif.endif.endi...endif.25.i
B0.endif.endif.endif.endi...endif.25.i:
  %.3003.sroa.0.1.i = phi i64 [ 0, %B0.endif.endif.endif.endi...if.25.i ], [ %.2862.i, %B0.endif.endif.endif.endi...endif.23.i ]
  br i1 %.2870.not.i, label %B0.endif.endif.endif.endi...endif.27.i, label %B0.endif.endif.endif.endi...endif.25.if.i, !prof !10
B0.endif.endif.endif.endi...endif.25.if.i:
  br label %B0.endif.endif.endif.endi...endif.27.i
B0.endif.endif.endif.endi...endif.27.i:
  %.3003.sroa.0.3.i = phi i64 [ %.2733.i, %B0.endif.endif.endif.endi...endif.25.if.i ], [ %.3003.sroa.0.1.i, %B0.endif.endif.endif.endi...endif.25.i ]
  %.3091.i = sub nsw i64 %.2733.i, %.3003.sroa.0.3.i
  %.3100.i = tail call i64 @llvm.smax.i64(i64 %.3091.i, i64 0)
  %.3116.i = getelementptr double, ptr %.2749.i, i64 %.3003.sroa.0.3.i
  %.32492628.not.i = icmp slt i64 %.24.i, 1
  br i1 %.32492628.not.i, label %B1218.endif.i, label %B1140.lr.ph.i
B1140.lr.ph.i:
  %invariant.gep.i = getelementptr double, ptr %a14, i64 %.24.i
  %.idx.i = shl i64 %.24.i, 4
  %invariant.gep2691.i = getelementptr i8, ptr %a14, i64 %.idx.i
  %52 = icmp eq i64 %.24.i, 1
  br i1 %52, label %B1140.epil.preheader.i, label %B1140.lr.ph.new.i
B1140.lr.ph.new.i:
  %unroll_iter.i = and i64 %.24.i, 9223372036854775806
  %scevgep424.i = getelementptr i8, ptr %a2, i64 8
  %scevgep428.i = getelementptr i8, ptr %a14, i64 8
  %sunkaddr.i = shl i64 %.24.i, 3
  br label %B1140.i
B1218.endif.loopexit.unr-lcssa.i:
  %53 = and i64 %.24.i, 1
  %lcmp.mod.not.i = icmp eq i64 %53, 0
  br i1 %lcmp.mod.not.i, label %B1218.endif.i, label %B1140.epil.preheader.i
B1140.epil.preheader.i:
  %.325526272629.epil.init.i = phi i64 [ 0, %B1140.lr.ph.i ], [ %unroll_iter.i, %B1218.endif.loopexit.unr-lcssa.i ]
  %54 = getelementptr double, ptr %a2, i64 %.325526272629.epil.init.i
  %.3316.epil.i = load double, ptr %54, align 8, !noalias !0
  %55 = getelementptr double, ptr %a14, i64 %.325526272629.epil.init.i
  store double %.3316.epil.i, ptr %55, align 8, !noalias !0
  %gep.epil.i = getelementptr double, ptr %invariant.gep.i, i64 %.325526272629.epil.init.i
  store double %.3316.epil.i, ptr %gep.epil.i, align 8, !noalias !0
  %gep2692.epil.i = getelementptr double, ptr %invariant.gep2691.i, i64 %.325526272629.epil.init.i
  store double 0.000000e+00, ptr %gep2692.epil.i, align 8, !noalias !0
  br label %B1218.endif.i
B1218.endif.i:
  %.3475.i = getelementptr i8, ptr %a16, i64 24
  store i64 -1, ptr %.3475.i, align 8, !noalias !0
  %.3506.i = load double, ptr %a4, align 8, !noalias !0
  %.36242644.not.i = icmp slt i64 %.32.i, 1
  br i1 %.36242644.not.i, label %B1820.i, label %B1306.lr.ph.i
B1306.lr.ph.i:
  %.3762.i = tail call i64 @llvm.smin.i64(i64 %.70.i, i64 0)
  %56 = getelementptr double, ptr %a7, i64 %.70.i
  %57 = getelementptr i8, ptr %56, i64 -8
  %.3776.i = getelementptr double, ptr %57, i64 %.3762.i
  %scevgep.i139.i = getelementptr i8, ptr %a11, i64 8
  %scevgep3.i140.i = getelementptr i8, ptr %a12, i64 16
  %58 = icmp sgt i64 %.72.i, 0
  %59 = icmp slt i64 %.1557.i, 1
  %sunkaddr446.i = getelementptr i8, ptr %a0, i64 24
  %60 = icmp sgt i64 %.24.i, 0
  %.179.i.i = getelementptr i8, ptr %a16, i64 16
  %xtraiter.i.i.i = and i64 %.3100.i, 3
  %unroll_iter.i.i.i = and i64 %.3100.i, 9223372036854775804
  %61 = mul i64 %.70.i, 24
  %62 = shl i64 %.70.i, 5
  %63 = shl i64 %.70.i, 4
  %64 = add nsw i64 %unroll_iter.i.i.i, -4
  %65 = lshr exact i64 %64, 2
  %66 = add nuw nsw i64 %65, 1
  %67 = lshr i64 %66, 1
  %68 = mul nsw i64 %67, -2
  %69 = icmp slt i64 %.3091.i, 1
  %70 = icmp slt i64 %.3091.i, 4
  %71 = icmp eq i64 %64, 0
  %72 = and i64 %64, 4
  %73 = icmp eq i64 %72, 0
  %74 = icmp eq i64 %xtraiter.i.i.i, 0
  %.586.i.i = shl nuw nsw i64 %.24.i, 1
  %75 = icmp sgt i64 %.1200.i, %.24.i
  %.649.not.i.i = icmp sgt i64 %.1200.i, %.586.i.i
  %.758.i.i = mul nuw nsw i64 %.24.i, 3
  %.821.not.i.i = icmp sgt i64 %.1200.i, %.758.i.i
  %.930.i.i = shl nsw i64 %.24.i, 2
  %.993.not.i.i = icmp sgt i64 %.1200.i, %.930.i.i
  %.1246.i.i = mul nuw nsw i64 %.24.i, 6
  %.1309.not.i.i = icmp sgt i64 %.1200.i, %.1246.i.i
  %.1588.i.i = mul nuw nsw i64 %.24.i, 11
  %.1634.not.i.i = icmp sgt i64 %.1200.i, %.1588.i.i
  %.arg.coefficients.5.0.i.i.i = tail call i64 @llvm.smax.i64(i64 %.28.i, i64 0)
  %76 = add nuw i64 %.arg.coefficients.5.0.i.i.i, 1
  %.1897.i.i = getelementptr i8, ptr %a10, i64 16
  %.idx.i.i.i = shl i64 %.26.i, 4
  %77 = getelementptr i8, ptr %a8, i64 %.idx.i.i.i
  %78 = shl i64 %.26.i, 3
  %scevgep157.i.i = getelementptr i8, ptr %a8, i64 %78
  %79 = icmp slt i64 %.1900.i, 1
  %80 = icmp slt i64 %.26.i, 1
  %sunkaddr160.i.i = getelementptr i8, ptr %.2096.i, i64 8
  %sunkaddr.i2.i = getelementptr i8, ptr %a0, i64 8
  %sunkaddr174.i.i = getelementptr i8, ptr %a16, i64 8
  %sunkaddr163.i.i = getelementptr i8, ptr %a0, i64 16
  %81 = and i64 %66, 9223372036854775806
  %.idx.i6.i.i = shl i64 %.24.i, 4
  %invariant.gep.i.i.i = getelementptr i8, ptr %a14, i64 %.idx.i6.i.i
  %invariant.gep645.i.i.i = getelementptr double, ptr %a14, i64 %.24.i
  %sunkaddr166.i.i = getelementptr i8, ptr %a7, i64 %.16.i.i
  %sunkaddr167.i.i = getelementptr i8, ptr %sunkaddr166.i.i, i64 -8
  %sunkaddr168.i.i = getelementptr i8, ptr %a15, i64 8
  %sunkaddr172.i.i = getelementptr i8, ptr %a16, i64 32
  %sunkaddr171.i.i = getelementptr i8, ptr %a10, i64 8
  br label %B1306.i
B1398.endif.i:
  %.3949.i = load i64, ptr %sunkaddr446.i, align 8, !noalias !0
  store double %.3701.i, ptr %.2096.i, align 8, !noalias !76
  %.168.i.i = inttoptr i64 %.3949.i to ptr
  tail call void %.168.i.i(ptr nonnull %.2096.i, ptr %a2, ptr %.1582.i, ptr %a3, ptr %.3116.i), !noalias !76
  br label %B108.endif.endif.i.i
B106.i.i:
  %.291.i.i = add nuw i64 %.284326331.i.i, 1
  %scevgep1.i143.i = getelementptr i8, ptr %lsr.iv.i141.i, i64 16
  %scevgep5.i144.i = getelementptr i8, ptr %lsr.iv4.i.i, i64 24
  %exitcond.not.i145.i = icmp eq i64 %.72.i, %.291.i.i
  br i1 %exitcond.not.i145.i, label %B1398.endif.endif.thread.i, label %B108.endif.endif.i.i
B192.i.i:
  %sunkaddr.i.i = getelementptr i8, ptr %lsr.iv4.i.i, i64 -16
  %.612.i.i = load double, ptr %sunkaddr.i.i, align 8, !noalias !76
  %.701.i.i = getelementptr double, ptr %.3116.i, i64 %.554.i.i
  %.702.i.i = load double, ptr %.701.i.i, align 8, !noalias !76
  %.703.i.i = fmul double %.612.i.i, %.702.i.i
  %.705.i.i = fadd double %.373.i.i, %.703.i.i
  br label %B252.i.i
B252.i.i:
  %value.3.2.i.i = phi double [ %.705.i.i, %B192.i.i ], [ %.373.i.i, %B108.endif.endif.i.i ]
  %.554.1.i.i = load i64, ptr %lsr.iv.i141.i, align 8, !noalias !76
  %.557.1.i.i = icmp sgt i64 %.554.1.i.i, -1
  br i1 %.557.1.i.i, label %B192.1.i.i, label %B252.1.i.i
B192.1.i.i:
  %scevgep6.i146.i = getelementptr i8, ptr %lsr.iv4.i.i, i64 -8
  %.612.1.i.i = load double, ptr %scevgep6.i146.i, align 8, !noalias !76
  %.701.1.i.i = getelementptr double, ptr %.3116.i, i64 %.554.1.i.i
  %.702.1.i.i = load double, ptr %.701.1.i.i, align 8, !noalias !76
  %.703.1.i.i = fmul double %.612.1.i.i, %.702.1.i.i
  %.705.1.i.i = fadd double %value.3.2.i.i, %.703.1.i.i
  br label %B252.1.i.i
B252.1.i.i:
  %value.3.2.1.i.i = phi double [ %.705.1.i.i, %B192.1.i.i ], [ %value.3.2.i.i, %B252.i.i ]
  %.724.i.i = fcmp ogt double %value.3.2.1.i.i, 0.000000e+00
  br i1 %.724.i.i, label %B1398.endif.endif.i, label %B106.i.i
B108.endif.endif.i.i:
  %lsr.iv4.i.i = phi ptr [ %scevgep3.i140.i, %B1398.endif.i ], [ %scevgep5.i144.i, %B106.i.i ]
  %lsr.iv.i141.i = phi ptr [ %scevgep.i139.i, %B1398.endif.i ], [ %scevgep1.i143.i, %B106.i.i ]
  %.284326331.i.i = phi i64 [ 0, %B1398.endif.i ], [ %.291.i.i, %B106.i.i ]
  %.373.i.i = load double, ptr %lsr.iv4.i.i, align 8, !noalias !76
  %scevgep2.i142.i = getelementptr i8, ptr %lsr.iv.i141.i, i64 -8
  %.554.i.i = load i64, ptr %scevgep2.i142.i, align 8, !noalias !76
  %.557.i.i = icmp sgt i64 %.554.i.i, -1
  br i1 %.557.i.i, label %B192.i.i, label %B252.i.i
B1398.endif.endif.thread.i:
  store i64 -1, ptr %.3475.i, align 8, !noalias !0
  br label %B1562.i
B1398.endif.endif.i:
  store i64 %.284326331.i.i, ptr %.3475.i, align 8, !noalias !0
  br label %B1820.i
B1864.endif.endif.i:
  %.5071.i = getelementptr i8, ptr %a16, i64 16
  %.5072.i = load i64, ptr %.5071.i, align 8, !noalias !0
  %.5074.i = add nsw i64 %.70.i, -1
  %.13.i.i = tail call i64 @llvm.smin.i64(i64 %.5074.i, i64 %.5072.i)
  store i64 %.13.i.i, ptr %.5071.i, align 8, !noalias !0
  %.5164.i = getelementptr i8, ptr %a0, i64 24
  %.5165.i = load i64, ptr %.5164.i, align 8, !noalias !0
  store double %t.4.1.i, ptr %.2096.i, align 8, !noalias !79
  %.151.i.i = inttoptr i64 %.5165.i to ptr
  tail call void %.151.i.i(ptr nonnull %.2096.i, ptr %a2, ptr %.1582.i, ptr %a3, ptr %.3116.i), !noalias !79
  %.253155.not.i.i = icmp slt i64 %.3091.i, 1
  br i1 %.253155.not.i.i, label %B1864.endif.endif.endif.i, label %B96.lr.ph.i.i
B96.lr.ph.i.i:
  %.349.i.i = icmp slt i64 %.13.i.i, 0
  %.350.i.i = select i1 %.349.i.i, i64 %.70.i, i64 0
  %xtraiter.i.i = and i64 %.3100.i, 3
  %82 = icmp ult i64 %.3091.i, 4
  br i1 %82, label %B96.epil.preheader.i.i, label %B96.lr.ph.new.i.i
B96.lr.ph.new.i.i:
  %invariant.gep.i.i = getelementptr double, ptr %a13, i64 %.13.i.i
  %invariant.gep159.i.i = getelementptr double, ptr %invariant.gep.i.i, i64 %.350.i.i
  %unroll_iter.i.i = and i64 %.3100.i, 9223372036854775804
  %83 = mul i64 %.70.i, 24
  %84 = shl i64 %.70.i, 5
  %85 = shl i64 %.70.i, 4
  %86 = add nsw i64 %.3100.i, -4
  %87 = lshr i64 %86, 2
  %88 = icmp eq i64 %87, 0
  br i1 %88, label %B96.i.epil.preheader.i, label %B96.lr.ph.new.i.new.i
B96.lr.ph.new.i.new.i:
  %89 = add nuw nsw i64 %87, 1
  %unroll_iter381.i = and i64 %89, 9223372036854775806
  %90 = add i64 %.1983.sroa.0.3.i, %.1284.sroa.0.3.i
  %91 = add i64 %90, %.2636.sroa.0.3.i
  %92 = add i64 %91, %.3003.sroa.0.3.i
  %93 = shl i64 %92, 3
  %94 = getelementptr i8, ptr %a17, i64 %93
  %scevgep395.i = getelementptr i8, ptr %94, i64 56
  br label %B96.i.i
B96.i.i:
  %lsr.iv.i = phi i64 [ %lsr.iv.next.i, %B96.i.i ], [ %unroll_iter381.i, %B96.lr.ph.new.i.new.i ]
  %lsr.iv13.i.i = phi ptr [ %scevgep417.i, %B96.i.i ], [ %invariant.gep159.i.i, %B96.lr.ph.new.i.new.i ]
  %.259154156.i.i = phi i64 [ %.266.3.i.1.i, %B96.i.i ], [ 0, %B96.lr.ph.new.i.new.i ]
  %sunkaddr.i147.i = shl i64 %.259154156.i.i, 3
  %scevgep409.i = getelementptr i8, ptr %scevgep395.i, i64 %sunkaddr.i147.i
  %scevgep410.i = getelementptr i8, ptr %scevgep409.i, i64 -56
  %.320.i.i = load double, ptr %scevgep410.i, align 8, !noalias !79
  store double %.320.i.i, ptr %lsr.iv13.i.i, align 8, !noalias !79
  %scevgep408.i = getelementptr i8, ptr %scevgep409.i, i64 -48
  %.320.1.i.i = load double, ptr %scevgep408.i, align 8, !noalias !79
  %sunkaddr23.i.i = getelementptr i8, ptr %lsr.iv13.i.i, i64 %.16.i.i
  store double %.320.1.i.i, ptr %sunkaddr23.i.i, align 8, !noalias !79
  %scevgep406.i = getelementptr i8, ptr %scevgep409.i, i64 -40
  %.320.2.i.i = load double, ptr %scevgep406.i, align 8, !noalias !79
  %scevgep411.i = getelementptr i8, ptr %sunkaddr23.i.i, i64 %.16.i.i
  store double %.320.2.i.i, ptr %scevgep411.i, align 8, !noalias !79
  %scevgep404.i = getelementptr i8, ptr %scevgep409.i, i64 -32
  %.320.3.i.i = load double, ptr %scevgep404.i, align 8, !noalias !79
  %scevgep412.i = getelementptr i8, ptr %scevgep411.i, i64 %.16.i.i
  store double %.320.3.i.i, ptr %scevgep412.i, align 8, !noalias !79
  %scevgep402.i = getelementptr i8, ptr %scevgep409.i, i64 -24
  %.320.i.1.i = load double, ptr %scevgep402.i, align 8, !noalias !79
  %scevgep413.i = getelementptr i8, ptr %scevgep412.i, i64 %.16.i.i
  store double %.320.i.1.i, ptr %scevgep413.i, align 8, !noalias !79
  %scevgep400.i = getelementptr i8, ptr %scevgep409.i, i64 -16
  %.320.1.i.1.i = load double, ptr %scevgep400.i, align 8, !noalias !79
  %scevgep414.i = getelementptr i8, ptr %scevgep413.i, i64 %.16.i.i
  store double %.320.1.i.1.i, ptr %scevgep414.i, align 8, !noalias !79
  %scevgep398.i = getelementptr i8, ptr %scevgep409.i, i64 -8
  %.320.2.i.1.i = load double, ptr %scevgep398.i, align 8, !noalias !79
  %scevgep415.i = getelementptr i8, ptr %scevgep414.i, i64 %.16.i.i
  store double %.320.2.i.1.i, ptr %scevgep415.i, align 8, !noalias !79
  %.266.3.i.1.i = add nuw i64 %.259154156.i.i, 8
  %.320.3.i.1.i = load double, ptr %scevgep409.i, align 8, !noalias !79
  %scevgep416.i = getelementptr i8, ptr %scevgep415.i, i64 %.16.i.i
  store double %.320.3.i.1.i, ptr %scevgep416.i, align 8, !noalias !79
  %lsr.iv.next.i = add i64 %lsr.iv.i, -2
  %niter382.ncmp.1.i = icmp eq i64 %lsr.iv.next.i, 0
  %scevgep417.i = getelementptr i8, ptr %scevgep416.i, i64 %.16.i.i
  br i1 %niter382.ncmp.1.i, label %B126.loopexit.unr-lcssa.i.unr-lcssa.i, label %B96.i.i
B126.loopexit.unr-lcssa.i.unr-lcssa.i:
  %scevgep14.i.i = getelementptr i8, ptr %lsr.iv13.i.i, i64 %84
  %scevgep14.i.1.i = getelementptr i8, ptr %scevgep14.i.i, i64 %84
  %95 = and i64 %86, 4
  %lcmp.mod379.not.not.i = icmp eq i64 %95, 0
  br i1 %lcmp.mod379.not.not.i, label %B96.i.epil.preheader.i, label %B126.loopexit.unr-lcssa.i.i
B96.i.epil.preheader.i:
  %lsr.iv13.i.epil.init.i = phi ptr [ %invariant.gep159.i.i, %B96.lr.ph.new.i.i ], [ %scevgep14.i.1.i, %B126.loopexit.unr-lcssa.i.unr-lcssa.i ]
  %.259154156.i.epil.init.i = phi i64 [ 0, %B96.lr.ph.new.i.i ], [ %.266.3.i.1.i, %B126.loopexit.unr-lcssa.i.unr-lcssa.i ]
  %sunkaddr.i147.epil.i = shl i64 %.259154156.i.epil.init.i, 3
  %sunkaddr18.i.epil.i = getelementptr i8, ptr %.3116.i, i64 %sunkaddr.i147.epil.i
  %.320.i.epil.i = load double, ptr %sunkaddr18.i.epil.i, align 8, !noalias !79
  store double %.320.i.epil.i, ptr %lsr.iv13.i.epil.init.i, align 8, !noalias !79
  %sunkaddr21.i.epil.i = getelementptr i8, ptr %sunkaddr18.i.epil.i, i64 8
  %.320.1.i.epil.i = load double, ptr %sunkaddr21.i.epil.i, align 8, !noalias !79
  %sunkaddr23.i.epil.i = getelementptr i8, ptr %lsr.iv13.i.epil.init.i, i64 %.16.i.i
  store double %.320.1.i.epil.i, ptr %sunkaddr23.i.epil.i, align 8, !noalias !79
  %sunkaddr26.i.epil.i = getelementptr i8, ptr %sunkaddr18.i.epil.i, i64 16
  %.320.2.i.epil.i = load double, ptr %sunkaddr26.i.epil.i, align 8, !noalias !79
  %scevgep16.i.epil.i = getelementptr i8, ptr %lsr.iv13.i.epil.init.i, i64 %85
  store double %.320.2.i.epil.i, ptr %scevgep16.i.epil.i, align 8, !noalias !79
  %sunkaddr29.i.epil.i = getelementptr i8, ptr %sunkaddr18.i.epil.i, i64 24
  %.320.3.i.epil.i = load double, ptr %sunkaddr29.i.epil.i, align 8, !noalias !79
  %scevgep15.i.epil.i = getelementptr i8, ptr %lsr.iv13.i.epil.init.i, i64 %83
  store double %.320.3.i.epil.i, ptr %scevgep15.i.epil.i, align 8, !noalias !79
  br label %B126.loopexit.unr-lcssa.i.i
B126.loopexit.unr-lcssa.i.i:
  %lcmp.mod.not.i.i = icmp eq i64 %xtraiter.i.i, 0
  br i1 %lcmp.mod.not.i.i, label %B1864.endif.endif.endif.i, label %B96.epil.preheader.i.i
B96.epil.preheader.i.i:
  %.259154156.epil.init.i.i = phi i64 [ %unroll_iter.i.i, %B126.loopexit.unr-lcssa.i.i ], [ 0, %B96.lr.ph.i.i ]
  %96 = mul i64 %.259154156.epil.init.i.i, %.70.i
  %97 = add i64 %.350.i.i, %.13.i.i
  %98 = add i64 %97, %96
  %99 = shl i64 %98, 3
  %scevgep.i148.i = getelementptr i8, ptr %a13, i64 %99
  %100 = add i64 %.1983.sroa.0.3.i, %.1284.sroa.0.3.i
  %101 = add i64 %100, %.2636.sroa.0.3.i
  %102 = add i64 %101, %.3003.sroa.0.3.i
  %103 = add i64 %102, %.259154156.epil.init.i.i
  %104 = shl i64 %103, 3
  %scevgep.i = getelementptr i8, ptr %a17, i64 %104
  br label %B96.epil.i.i
B96.epil.i.i:
  %lsr.iv.i150.i = phi ptr [ %scevgep2.i152.i, %B96.epil.i.i ], [ %scevgep.i148.i, %B96.epil.preheader.i.i ]
  %epil.iter.i.i = phi i64 [ %epil.iter.next.i.i, %B96.epil.i.i ], [ 0, %B96.epil.preheader.i.i ]
  %105 = shl i64 %epil.iter.i.i, 3
  %scevgep394.i = getelementptr i8, ptr %scevgep.i, i64 %105
  %.320.epil.i.i = load double, ptr %scevgep394.i, align 8, !noalias !79
  store double %.320.epil.i.i, ptr %lsr.iv.i150.i, align 8, !noalias !79
  %epil.iter.next.i.i = add i64 %epil.iter.i.i, 1
  %scevgep2.i152.i = getelementptr i8, ptr %lsr.iv.i150.i, i64 %.16.i.i
  %epil.iter.cmp.not.i.i = icmp eq i64 %xtraiter.i.i, %epil.iter.next.i.i
  br i1 %epil.iter.cmp.not.i.i, label %B1864.endif.endif.endif.i, label %B96.epil.i.i, !llvm.loop !82
B1864.endif.endif.endif.i:
  %.5307.i = load i64, ptr %.5071.i, align 8, !noalias !0
  %.5308.i = add nsw i64 %.5307.i, 1
  store i64 %.5308.i, ptr %.5071.i, align 8, !noalias !0
  br label %_ZN6poppet6engine10integrator9integrateB2v1B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAg6cJqBrMeIZJFEGM0QQAE8int64_2a8int64_2a10float64_2a10float64_2a10float64_2a10float64_2a8uint8_2a10float64_2a10float64_2a8uint8_2a10float64_2a8int64_2a10float64_2a10float64_2a10float64_2a10float64_2a8int64_2a10float64_2a10float64_2a.exit
_ZN6poppet6engine10integrator9integrateB2v1B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAg6cJqBrMeIZJFEGM0QQAE8int64_2a8int64_2a10float64_2a10float64_2a10float64_2a10float64_2a8uint8_2a10float64_2a10float64_2a8uint8_2a10float64_2a8int64_2a10float64_2a10float64_2a10float64_2a10float64_2a8int64_2a10float64_2a10float64_2a.exit:
  store double %t.4.1.i, ptr %a15, align 8, !noalias !0
  ret i64 %status.5.1.i
}
!0 = !{!1}
!1 = distinct !{!1, !2, !"_ZN6poppet6engine10integrator9integrateB2v1B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAg6cJqBrMeIZJFEGM0QQAE8int64_2a8int64_2a10float64_2a10float64_2a10float64_2a10float64_2a8uint8_2a10float64_2a10float64_2a8uint8_2a10float64_2a8int64_2a10float64_2a10float64_2a10float64_2a10float64_2a8int64_2a10float64_2a10float64_2a: %retptr"}
!2 = distinct !{!2, !"_ZN6poppet6engine10integrator9integrateB2v1B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAg6cJqBrMeIZJFEGM0QQAE8int64_2a8int64_2a10float64_2a10float64_2a10float64_2a10float64_2a8uint8_2a10float64_2a10float64_2a8uint8_2a10float64_2a8int64_2a10float64_2a10float64_2a10float64_2a10float64_2a8int64_2a10float64_2a10float64_2a"}
!3 = !{!"branch_weights", i32 1, i32 99}
!4 = !{!5, !1}
!5 = distinct !{!5, !6, !"_ZN6poppet6engine10integrator10_inputs_atB2v8B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!6 = distinct !{!6, !"_ZN6poppet6engine10integrator10_inputs_atB2v8B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!7 = !{!8, !1}
!8 = distinct !{!8, !9, !"_ZN6poppet6engine10integrator8_segmentB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!9 = distinct !{!9, !"_ZN6poppet6engine10integrator8_segmentB3v10B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEdddd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIhLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
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
