; made from lanes.py, integrator.py, stepping.py, job.py, rosenbrock.py, sha256 9a57f6122cf8fd54070888bbb2dd40a7acd3e6be27f5c6d9abd0b1cc1d220cfa
@.const.array.data = internal unnamed_addr constant [32 x i8] c"Nb\10X9\B4\D8?\E1z\14\AEG\E1\CA?)\\\8F\C2\F5(\E4?\00\00\00\00\00\00\F0?", align 8
define internal fastcc noundef i32 @v71(ptr noalias nonnull writeonly %retptr, ptr %arg.f.4, i64 %arg.i) unnamed_addr {
entry:
  %.556 = alloca i64, align 8
  %.1456 = alloca ptr, align 8
  %.2968 = alloca ptr, align 8
  %.360.i = getelementptr i8, ptr %arg.f.4, i64 608
  %.361.i = load i64, ptr %.360.i, align 8, !noalias !0
  %.362.i = inttoptr i64 %.361.i to ptr
  %.708.i = load i64, ptr %arg.f.4, align 8, !noalias !0
  %.116 = icmp slt i64 %arg.i, 0
  %.117 = select i1 %.116, i64 %.708.i, i64 0
  %.118 = add i64 %.117, %arg.i
  %.139 = getelementptr i64, ptr %.362.i, i64 %.118
  %0 = getelementptr i64, ptr %.362.i, i64 %.708.i
  %.199 = getelementptr i64, ptr %0, i64 %.118
  %.547 = getelementptr i8, ptr %arg.f.4, i64 224
  %.1832 = getelementptr i8, ptr %arg.f.4, i64 408
  %.2179 = getelementptr i8, ptr %arg.f.4, i64 416
  %.45.i410 = getelementptr i8, ptr %arg.f.4, i64 400
  %1 = getelementptr i8, ptr %arg.f.4, i64 456
  %2 = getelementptr i8, ptr %arg.f.4, i64 448
  br label %B36
B36:
  %status.3.1 = phi i64 [ 0, %entry ], [ %status.3.1.be, %B36.backedge ]
  %.140 = load i64, ptr %.139, align 8
  %.141 = icmp sgt i64 %.140, -1
  br i1 %.141, label %B74, label %B416
B74:
  %.144 = icmp eq i64 %status.3.1, 0
  br i1 %.144, label %B96, label %B382
B96:
  %.200 = load i64, ptr %.199, align 8
  %.201 = add nsw i64 %.200, 1
  %.548 = load i64, ptr %.547, align 8
  %.549 = icmp slt i64 %.201, %.548
  br i1 %.549, label %B172, label %B382
B172:
  store i64 0, ptr %.556, align 8
  call fastcc void @v72(ptr %.556, ptr nonnull %arg.f.4, i64 %arg.i)
  %.572 = load i64, ptr %.556, align 8
  %.586 = icmp eq i64 %.572, 0
  br i1 %.586, label %B226, label %B36.backedge
B226:
  %.45.i = load i64, ptr %1, align 8, !noalias !3
  %.46.i = inttoptr i64 %.45.i to ptr
  %.392.i = load i64, ptr %arg.f.4, align 8, !noalias !3
  %.978 = select i1 %.116, i64 %.392.i, i64 0
  %3 = getelementptr double, ptr %.46.i, i64 %arg.i
  %.1000 = getelementptr double, ptr %3, i64 %.978
  %.1001 = load double, ptr %.1000, align 8
  %.45.i399 = load i64, ptr %2, align 8, !noalias !6
  %.46.i400 = inttoptr i64 %.45.i399 to ptr
  %.idx = mul i64 %.392.i, 96
  %4 = getelementptr i8, ptr %.46.i400, i64 %.idx
  %5 = getelementptr double, ptr %4, i64 %arg.i
  %.1419 = getelementptr double, ptr %5, i64 %.978
  %.1420 = load double, ptr %.1419, align 8
  %.1426 = fcmp olt double %.1001, %.1420
  br i1 %.1426, label %common.ret, label %B36.backedge
common.ret:
  store ptr null, ptr %retptr, align 8
  ret i32 0
B382:
  call fastcc void @v73(ptr %.1456, ptr nonnull %arg.f.4, i64 %arg.i, i64 %status.3.1)
  br label %B416
B416:
  %.1833 = load i64, ptr %.1832, align 8
  %.2180 = load i64, ptr %.2179, align 8
  %.2181.not = icmp slt i64 %.1833, %.2180
  br i1 %.2181.not, label %B492, label %B566
B492:
  %.46.i411 = load i64, ptr %.45.i410, align 8, !noalias !9
  %.50.i = inttoptr i64 %.46.i411 to ptr
  %.2566 = getelementptr i8, ptr %.50.i, i64 8
  %.2567 = load double, ptr %.2566, align 8
  %.2571 = fcmp une double %.2567, 0.000000e+00
  br i1 %.2571, label %B566, label %B602
B566:
  %.45.i.i = load i64, ptr %2, align 8, !noalias !12
  %.46.i.i = inttoptr i64 %.45.i.i to ptr
  %.392.i.i = load i64, ptr %arg.f.4, align 8, !noalias !12
  %.728.i = getelementptr i8, ptr %arg.f.4, i64 144
  %.729.i = load i64, ptr %.728.i, align 8, !noalias !17
  %.361.i.i = load i64, ptr %.360.i, align 8, !noalias !18
  %.362.i.i = inttoptr i64 %.361.i.i to ptr
  %.819.i = select i1 %.116, i64 %.392.i.i, i64 0
  %6 = getelementptr i64, ptr %.362.i.i, i64 %arg.i
  %.841.i = getelementptr i64, ptr %6, i64 %.819.i
  store i64 -1, ptr %.841.i, align 8, !noalias !17
  %.361.i650.i = load i64, ptr %.360.i, align 8, !noalias !21
  %.362.i651.i = inttoptr i64 %.361.i650.i to ptr
  %.708.i652.i = load i64, ptr %arg.f.4, align 8, !noalias !21
  %.921.i = select i1 %.116, i64 %.708.i652.i, i64 0
  %.idx.i = shl i64 %.708.i652.i, 4
  %7 = getelementptr i8, ptr %.362.i651.i, i64 %.idx.i
  %8 = getelementptr i64, ptr %7, i64 %arg.i
  %.943.i = getelementptr i64, ptr %8, i64 %.921.i
  store i64 0, ptr %.943.i, align 8, !noalias !17
  %.981.i = add i64 %.819.i, %arg.i
  %.idx636.i = shl i64 %.392.i.i, 6
  %9 = getelementptr i8, ptr %.46.i.i, i64 %.idx636.i
  %.1002.i = getelementptr double, ptr %9, i64 %.981.i
  store double 1.000000e-09, ptr %.1002.i, align 8, !noalias !17
  %.idx637.i = mul i64 %.392.i.i, 96
  %10 = getelementptr i8, ptr %.46.i.i, i64 %.idx637.i
  %.1056.i = getelementptr double, ptr %10, i64 %.981.i
  store double 0x7FF0000000000000, ptr %.1056.i, align 8, !noalias !17
  %.idx638.i = mul i64 %.392.i.i, 80
  %11 = getelementptr i8, ptr %.46.i.i, i64 %.idx638.i
  %.1110.i = getelementptr double, ptr %11, i64 %.981.i
  store double 0x7FF0000000000000, ptr %.1110.i, align 8, !noalias !17
  %.idx639.i = mul i64 %.392.i.i, 104
  %12 = getelementptr i8, ptr %.46.i.i, i64 %.idx639.i
  %.1164.i = getelementptr double, ptr %12, i64 %.981.i
  store double 0x7FF0000000000000, ptr %.1164.i, align 8, !noalias !17
  %.idx640.i = shl i64 %.392.i.i, 7
  %13 = getelementptr i8, ptr %.46.i.i, i64 %.idx640.i
  %.1218.i = getelementptr double, ptr %13, i64 %.981.i
  store double 0x7FF0000000000000, ptr %.1218.i, align 8, !noalias !17
  %.1570.i = getelementptr i8, ptr %arg.f.4, i64 424
  %.1571.i = load i64, ptr %.1570.i, align 8, !noalias !17
  %.1572.i = add nsw i64 %.1571.i, -1
  store i64 %.1572.i, ptr %.1570.i, align 8, !noalias !17
  %.2265.i = getelementptr i8, ptr %arg.f.4, i64 128
  %.2266.i = load i64, ptr %.2265.i, align 8, !noalias !17
  %.2909.i = shl nsw i64 %.729.i, 2
  %.3897.i = getelementptr i8, ptr %arg.f.4, i64 136
  %.3898.i = load i64, ptr %.3897.i, align 8, !noalias !17
  %.3899.i = shl nsw i64 %.3898.i, 1
  %.4566.i = getelementptr i8, ptr %arg.f.4, i64 160
  %.4567.i = load i64, ptr %.4566.i, align 8, !noalias !17
  %.4913.i = getelementptr i8, ptr %arg.f.4, i64 168
  %.4914.i = load i64, ptr %.4913.i, align 8, !noalias !17
  %.4915.i = add nsw i64 %.4914.i, %.4567.i
  %.5261.i = getelementptr i8, ptr %arg.f.4, i64 192
  %.5262.i = load i64, ptr %.5261.i, align 8, !noalias !17
  %.5263.i = add nsw i64 %.4915.i, %.5262.i
  br label %B728.if.i
B728.loopexit.i:
  %exitcond676.not.i = icmp eq i64 %.5451.i, 6
  br i1 %exitcond676.not.i, label %common.ret, label %B728.if.i
B730.i:
  %.pn.i = phi i64 [ 62, %switch.5.i ], [ 59, %switch.1.i ], [ 60, %switch.2.i ], [ 61, %switch.3.i ], [ 71, %switch.4.i ], [ 58, %B728.if.i ]
  %.2266.pn.i = phi i64 [ %.5263.i, %switch.5.i ], [ %.729.i, %switch.1.i ], [ %.2909.i, %switch.2.i ], [ %.729.i, %switch.3.i ], [ %.3899.i, %switch.4.i ], [ %.2266.i, %B728.if.i ]
  %.5451.i = add nuw nsw i64 %.5307.0675.i, 1
  %14 = getelementptr i64, ptr %arg.f.4, i64 %.pn.i
  %.45.i661.i = load i64, ptr %14, align 8, !noalias !24
  %.46.i662.i = inttoptr i64 %.45.i661.i to ptr
  %.392.i663.i = load i64, ptr %arg.f.4, align 8, !noalias !24
  %.5626672.not.i = icmp slt i64 %.2266.pn.i, 1
  br i1 %.5626672.not.i, label %B728.loopexit.i, label %B800.if.lr.ph.i
B800.if.lr.ph.i:
  %.5747.i = select i1 %.116, i64 %.392.i663.i, i64 0
  br label %B800.if.i
B728.if.i:
  %.5307.0675.i = phi i64 [ 0, %B566 ], [ %.5451.i, %B728.loopexit.i ]
  switch i64 %.5307.0675.i, label %default.unreachable.i [
    i64 0, label %B730.i
    i64 3, label %switch.3.i
    i64 1, label %switch.1.i
    i64 5, label %switch.5.i
    i64 2, label %switch.2.i
    i64 4, label %switch.4.i
  ]
default.unreachable.i:
  unreachable
switch.1.i:
  br label %B730.i
switch.2.i:
  br label %B730.i
switch.3.i:
  br label %B730.i
switch.4.i:
  br label %B730.i
switch.5.i:
  br label %B730.i
B800.if.i:
  %.5570.0673.i = phi i64 [ 0, %B800.if.lr.ph.i ], [ %.5639.i, %B800.if.i ]
  %.5639.i = add nuw nsw i64 %.5570.0673.i, 1
  %.5712.i = mul i64 %.5570.0673.i, %.392.i663.i
  %.5716.i = getelementptr double, ptr %.46.i662.i, i64 %.5712.i
  %.5717.i = load double, ptr %.5716.i, align 8, !noalias !17
  %15 = getelementptr double, ptr %.5716.i, i64 %arg.i
  %.5769.i = getelementptr double, ptr %15, i64 %.5747.i
  store double %.5717.i, ptr %.5769.i, align 8, !noalias !17
  %exitcond.not.i = icmp eq i64 %.5639.i, %.2266.pn.i
  br i1 %exitcond.not.i, label %B728.loopexit.i, label %B800.if.i
B602:
  call fastcc void @v74(ptr %.2968, ptr nonnull %arg.f.4, i64 %arg.i, i64 %.1833)
  %.3340 = load i64, ptr %.1832, align 8
  %.3341 = add nsw i64 %.3340, 1
  store i64 %.3341, ptr %.1832, align 8
  br label %B36.backedge
B36.backedge:
  %status.3.1.be = phi i64 [ 0, %B602 ], [ %.572, %B226 ], [ %.572, %B172 ]
  br label %B36
}
define internal fastcc void @v72(ptr noalias nonnull writeonly %retptr, ptr readonly %arg.f.4, i64 %arg.i) unnamed_addr {
entry:
  %.49.i = alloca { [5 x i64], { { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, double, double, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, i8 }, { { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] } }, [13 x { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }], { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, align 8
  %.1870 = alloca i64, align 8
  %.3524 = alloca ptr, align 8
  %0 = getelementptr i8, ptr %arg.f.4, i64 448
  %.45.i = load i64, ptr %0, align 8, !noalias !27
  %.46.i = inttoptr i64 %.45.i to ptr
  %.392.i = load i64, ptr %arg.f.4, align 8, !noalias !27
  %.360.i = getelementptr i8, ptr %arg.f.4, i64 608
  %.361.i = load i64, ptr %.360.i, align 8, !noalias !30
  %.362.i = inttoptr i64 %.361.i to ptr
  %.482 = icmp slt i64 %arg.i, 0
  %.483 = select i1 %.482, i64 %.392.i, i64 0
  %.484 = add i64 %.483, %arg.i
  %1 = getelementptr i64, ptr %.362.i, i64 %.392.i
  %.505 = getelementptr i64, ptr %1, i64 %.484
  %.506 = load i64, ptr %.505, align 8
  %.507 = add nsw i64 %.506, 1
  store i64 %.507, ptr %.505, align 8
  %.361.i.i = load i64, ptr %.360.i, align 8, !noalias !33
  %.362.i.i = inttoptr i64 %.361.i.i to ptr
  %.708.i.i = load i64, ptr %arg.f.4, align 8, !noalias !33
  %.96.i = select i1 %.482, i64 %.708.i.i, i64 0
  %2 = getelementptr i64, ptr %.362.i.i, i64 %.708.i.i
  %3 = getelementptr i64, ptr %2, i64 %arg.i
  %.118.i = getelementptr i64, ptr %3, i64 %.96.i
  %.119.i = load i64, ptr %.118.i, align 8, !noalias !38
  %.470.i = getelementptr i8, ptr %arg.f.4, i64 224
  %.471.i = load i64, ptr %.470.i, align 8, !noalias !38
  %.817.i = getelementptr i8, ptr %arg.f.4, i64 144
  %.818.i = load i64, ptr %.817.i, align 8, !noalias !38
  %.45.i.i = getelementptr i8, ptr %arg.f.4, i64 304
  %.46.i.i = load i64, ptr %.45.i.i, align 8, !noalias !39
  %.50.i.i = inttoptr i64 %.46.i.i to ptr
  %.1192.i = add nsw i64 %.119.i, 1
  %.1194.i = icmp slt i64 %.1192.i, %.471.i
  br i1 %.1194.i, label %B204.i, label %B226.i
B204.i:
  %.1211.i = icmp slt i64 %.119.i, -1
  %.1212.i = select i1 %.1211.i, i64 %.471.i, i64 0
  %4 = getelementptr double, ptr %.50.i.i, i64 %.1192.i
  %.1226.i = getelementptr double, ptr %4, i64 %.1212.i
  br label %B322.i
B226.i:
  %.1895.i = getelementptr i8, ptr %arg.f.4, i64 240
  %.1896.i = load i64, ptr %.1895.i, align 8, !noalias !38
  %.45.i376.i = getelementptr i8, ptr %arg.f.4, i64 344
  %.46.i377.i = load i64, ptr %.45.i376.i, align 8, !noalias !42
  %.50.i378.i = inttoptr i64 %.46.i377.i to ptr
  %5 = getelementptr double, ptr %.50.i378.i, i64 %.1896.i
  %.1962.i = getelementptr i8, ptr %5, i64 -8
  br label %B322.i
B322.i:
  %"$phi322.0.2.0.in.i" = phi ptr [ %.1226.i, %B204.i ], [ %.1962.i, %B226.i ]
  %"$phi322.0.2.0.i" = load double, ptr %"$phi322.0.2.0.in.i", align 8, !noalias !38
  %.45.i384.i = getelementptr i8, ptr %arg.f.4, i64 312
  %.46.i385.i = load i64, ptr %.45.i384.i, align 8, !noalias !45
  %.50.i386.i = inttoptr i64 %.46.i385.i to ptr
  %.2348.i = icmp slt i64 %.119.i, 0
  %.2349.i = select i1 %.2348.i, i64 %.471.i, i64 0
  %6 = getelementptr i64, ptr %.50.i386.i, i64 %.119.i
  %.2363.i = getelementptr i64, ptr %6, i64 %.2349.i
  %.2364.i = load i64, ptr %.2363.i, align 8, !noalias !38
  %.2713.i = getelementptr i8, ptr %arg.f.4, i64 264
  %.2714.i = load i64, ptr %.2713.i, align 8, !noalias !38
  %.2715.i = icmp sgt i64 %.2714.i, 0
  br i1 %.2715.i, label %B432.i, label %b92
B432.i:
  %.3065.i = getelementptr i8, ptr %arg.f.4, i64 232
  %.3066.i = load i64, ptr %.3065.i, align 8, !noalias !38
  %.3068.i = mul nsw i64 %.3066.i, %arg.i
  br label %b92
b92:
  %"$phi476.1.2.0.i" = phi i64 [ %.3068.i, %B432.i ], [ 0, %B322.i ]
  %.3082.i = add nsw i64 %"$phi476.1.2.0.i", %.2364.i
  %7 = getelementptr double, ptr %.50.i.i, i64 %.119.i
  %.3116.i = getelementptr double, ptr %7, i64 %.2349.i
  %.3117.i = load double, ptr %.3116.i, align 8, !noalias !38
  %.3470.i = getelementptr i8, ptr %arg.f.4, i64 320
  %.3471.i = load i64, ptr %.3470.i, align 8, !noalias !38
  %.3478.i = mul nsw i64 %.818.i, 56
  %.3479.i = mul nsw i64 %.3478.i, %.3082.i
  %.3480.i = add nsw i64 %.3471.i, %.3479.i
  %.3481.i = inttoptr i64 %.3480.i to ptr
  %.952 = getelementptr i8, ptr %arg.f.4, i64 176
  %.953 = load i64, ptr %.952, align 8
  %.954 = icmp sgt i64 %.953, 0
  %8 = getelementptr i8, ptr %arg.f.4, i64 456
  %.45.i802 = load i64, ptr %8, align 8, !noalias !48
  %.46.i803 = inttoptr i64 %.45.i802 to ptr
  %9 = getelementptr double, ptr %.46.i803, i64 %arg.i
  %.1398 = getelementptr double, ptr %9, i64 %.96.i
  store double %.3117.i, ptr %.1398, align 8
  %.idx = mul i64 %.392.i, 96
  %10 = getelementptr i8, ptr %.46.i, i64 %.idx
  %.1458 = getelementptr double, ptr %10, i64 %.484
  store double %"$phi322.0.2.0.i", ptr %.1458, align 8
  %.idx782 = mul i64 %.392.i, 80
  %11 = getelementptr i8, ptr %.46.i, i64 %.idx782
  %.1513 = getelementptr double, ptr %11, i64 %.484
  store double %"$phi322.0.2.0.i", ptr %.1513, align 8
  br i1 %.954, label %B402, label %B358
B358:
  %.1862 = getelementptr i8, ptr %arg.f.4, i64 248
  %.1863 = load i64, ptr %.1862, align 8
  %.1864 = icmp sgt i64 %.1863, 0
  br i1 %.1864, label %B402, label %B458
B402:
  store i64 0, ptr %.1870, align 8
  call fastcc void @v75(ptr %.1870, ptr nonnull %arg.f.4, i64 %arg.i, double %.3117.i, ptr %.3481.i, i64 7)
  %.1890 = load i64, ptr %.1870, align 8
  %.1900 = icmp sgt i64 %.1890, -1
  br i1 %.1900, label %common.ret, label %B458
common.ret:
  %storemerge = phi i64 [ 0, %b93 ], [ 1, %B402 ]
  store i64 %storemerge, ptr %retptr, align 8
  ret void
B458:
  %.2281 = getelementptr i8, ptr %arg.f.4, i64 328
  %.2282 = load i64, ptr %.2281, align 8
  %.2283 = inttoptr i64 %.2282 to ptr
  %.2630 = load i64, ptr %.470.i, align 8
  %.2724 = load i64, ptr %.505, align 8
  %.2737 = icmp slt i64 %.2724, 0
  %.2738 = select i1 %.2737, i64 %.2630, i64 0
  %12 = getelementptr i8, ptr %.2283, i64 %.2724
  %.2752 = getelementptr i8, ptr %12, i64 %.2738
  %.2753 = load i8, ptr %.2752, align 1
  %.2757.not = icmp eq i8 %.2753, 0
  br i1 %.2757.not, label %B682, label %B630
B630:
  %.idx783 = shl i64 %.392.i, 6
  %13 = getelementptr i8, ptr %.46.i, i64 %.idx783
  %.2812 = getelementptr double, ptr %13, i64 %.484
  %.2813 = load double, ptr %.2812, align 8
  %.2814 = fneg double %.2813
  store double %.2814, ptr %.2812, align 8
  br label %B682
B682:
  %.idx784 = shl i64 %.392.i, 5
  %14 = getelementptr i8, ptr %.46.i, i64 %.idx784
  %.2936 = getelementptr double, ptr %14, i64 %.484
  store double 0x3FD43D136248490F, ptr %.2936, align 8
  %.idx785 = mul i64 %.392.i, 40
  %15 = getelementptr i8, ptr %.46.i, i64 %.idx785
  %.2991 = getelementptr double, ptr %15, i64 %.484
  store double 0.000000e+00, ptr %.2991, align 8
  %.idx786 = mul i64 %.392.i, 160
  %16 = getelementptr i8, ptr %.46.i, i64 %.idx786
  %.3047 = getelementptr double, ptr %16, i64 %.484
  store double %.3117.i, ptr %.3047, align 8
  %.idx787 = mul i64 %.392.i, 144
  %17 = getelementptr i8, ptr %.46.i, i64 %.idx787
  %.3103 = getelementptr double, ptr %17, i64 %.484
  store double %.3117.i, ptr %.3103, align 8
  %.idx788 = mul i64 %.392.i, 152
  %18 = getelementptr i8, ptr %.46.i, i64 %.idx788
  %.3158 = getelementptr double, ptr %18, i64 %.484
  store double 0.000000e+00, ptr %.3158, align 8
  %.idx789 = mul i64 %.392.i, 56
  %19 = getelementptr i8, ptr %.46.i, i64 %.idx789
  %.3213 = getelementptr double, ptr %19, i64 %.484
  store double 0.000000e+00, ptr %.3213, align 8
  %.idx790 = mul i64 %.392.i, 24
  %20 = getelementptr i8, ptr %.362.i, i64 %.idx790
  %.3279 = getelementptr i64, ptr %20, i64 %.484
  store i64 1, ptr %.3279, align 8
  %21 = getelementptr i8, ptr %.362.i, i64 %.idx785
  %.3334 = getelementptr i64, ptr %21, i64 %.484
  store i64 -1, ptr %.3334, align 8
  %.3341 = fcmp ogt double %.3117.i, 0.000000e+00
  %or.cond = select i1 %.954, i1 true, i1 %.3341
  %. = zext i1 %or.cond to i64
  %22 = getelementptr i8, ptr %.362.i, i64 %.idx784
  %.3404 = getelementptr i64, ptr %22, i64 %.484
  store i64 %., ptr %.3404, align 8
  %spec.select.i = tail call i64 @llvm.smax.i64(i64 %.818.i, i64 0)
  br label %B66.i
B66.i:
  %.75.0.i = phi i64 [ 0, %B682 ], [ %.146.i, %B108.i ]
  %exitcond.not.i = icmp eq i64 %.75.0.i, %spec.select.i
  br i1 %exitcond.not.i, label %b94, label %B66.if.i
B108.i:
  %.146.i = add nuw i64 %.75.0.i, 1
  %.303.i = getelementptr i8, ptr %23, i64 16
  %.304.i = load double, ptr %.303.i, align 8, !noalias !51
  %.310.i = fcmp une double %.304.i, 0.000000e+00
  br i1 %.310.i, label %b94, label %B66.i
B66.if.i:
  %.idx820 = mul i64 %.75.0.i, 56
  %23 = getelementptr i8, ptr %.3481.i, i64 %.idx820
  %.233.i = getelementptr i8, ptr %23, i64 8
  %.234.i = load double, ptr %.233.i, align 8, !noalias !51
  %.240.i = fcmp une double %.234.i, 0.000000e+00
  br i1 %.240.i, label %b94, label %B108.i
b94:
  %24 = phi i64 [ 0, %B66.i ], [ 1, %B66.if.i ], [ 1, %B108.i ]
  %.idx793 = shl i64 %.392.i, 4
  %25 = getelementptr i8, ptr %.362.i, i64 %.idx793
  %.3508 = getelementptr i64, ptr %25, i64 %.484
  store i64 %24, ptr %.3508, align 8
  call fastcc void @v76(ptr %.3524, ptr nonnull %arg.f.4, i64 %arg.i, ptr %.3481.i, i64 7, double %.3117.i)
  call void @llvm.lifetime.start.p0(ptr nonnull %.49.i)
  %.fca.5.0.2.gep.i = getelementptr inbounds i8, ptr %.49.i, i64 872
  %.fca.5.0.4.gep.i = getelementptr inbounds i8, ptr %.49.i, i64 888
  call fastcc void @v77(ptr %.49.i, ptr nonnull readonly %arg.f.4, i64 %arg.i)
  %.65.fca.5.0.2.load.i = load i64, ptr %.fca.5.0.2.gep.i, align 8, !noalias !54
  %.65.fca.5.0.4.load.i = load ptr, ptr %.fca.5.0.4.gep.i, align 8, !noalias !54
  %26 = getelementptr i8, ptr %arg.f.4, i64 480
  %.45.i.i813 = load i64, ptr %26, align 8, !noalias !57
  %.46.i.i814 = inttoptr i64 %.45.i.i813 to ptr
  %.392.i.i = load i64, ptr %arg.f.4, align 8, !noalias !57
  %.148211.not.i.i = icmp slt i64 %.65.fca.5.0.2.load.i, 1
  %invariant.gep.i = getelementptr double, ptr %.46.i.i814, i64 %arg.i
  %.1509.i = select i1 %.482, i64 %.392.i.i, i64 0
  %invariant.gep439.i = getelementptr double, ptr %invariant.gep.i, i64 %.1509.i
  br label %B138.if.i
B138.loopexit.i:
  %exitcond443.not.i = icmp eq i64 %.1193.i, 4
  br i1 %exitcond443.not.i, label %b93, label %B138.if.i
B138.if.i:
  %.1124.0442.i = phi i64 [ 0, %b94 ], [ %.1193.i, %B138.loopexit.i ]
  %.1193.i = add nuw nsw i64 %.1124.0442.i, 1
  %27 = getelementptr double, ptr @.const.array.data, i64 %.1124.0442.i
  %.1276.i = load double, ptr %27, align 8, !noalias !54
  %.1281.i = fmul double %.1276.i, 0.000000e+00
  %.1283.i = fadd double %.3117.i, %.1281.i
  br i1 %.148211.not.i.i, label %B138.loopexit.i, label %B58.if.i.i
B164.i.i:
  %.44.i.i.i = getelementptr i8, ptr %29, i64 24
  %.45.i.i.i = load double, ptr %.44.i.i.i, align 8, !noalias !60
  %.73.i.i.i = getelementptr i8, ptr %29, i64 32
  %.74.i.i.i = load double, ptr %.73.i.i.i, align 8, !noalias !60
  %.75.i.i.i = fmul double %.74.i.i.i, 5.000000e-01
  %.76.i.i.i = fmul double %.245.i.i, %.75.i.i.i
  %.77.i.i.i = fadd double %.45.i.i.i, %.76.i.i.i
  %.78.i.i.i = fmul double %.245.i.i, %.77.i.i.i
  %.87.le.i.i.i = tail call double @llvm.floor.f64(double %.78.i.i.i)
  %.92.i.i.i = fsub double %.78.i.i.i, %.87.le.i.i.i
  %.93.i.i.i = fmul double %.92.i.i.i, 0x401921FB54442D18
  %.121.i.i.i = getelementptr i8, ptr %29, i64 40
  %.122.i.i.i = load double, ptr %.121.i.i.i, align 8, !noalias !60
  %.126.i.i.i = fadd double %.122.i.i.i, %.93.i.i.i
  %.593.le.i.i = tail call double @llvm.sin.f64(double %.126.i.i.i)
  %.598.i.i = fmul double %.423.i.i, %.593.le.i.i
  %.600.i.i = fadd double %.361.i.i816, %.598.i.i
  br label %B272.i.i
B272.i.i:
  %value.2.1.i.i = phi double [ %.600.i.i, %B164.i.i ], [ %.361.i.i816, %B58.if.i.i ]
  %28 = getelementptr double, ptr %.65.fca.5.0.4.load.i, i64 %.90.0213.i.i
  store double %value.2.1.i.i, ptr %28, align 8, !noalias !65
  %exitcond.not.i.i = icmp eq i64 %.65.fca.5.0.2.load.i, %.161.i.i
  br i1 %exitcond.not.i.i, label %B260.preheader.i, label %B58.if.i.i
B260.preheader.i:
  %.1478.i = mul nuw nsw i64 %.1124.0442.i, %.65.fca.5.0.2.load.i
  br label %B260.if.i
B58.if.i.i:
  %.90.0213.i.i = phi i64 [ %.161.i.i, %B272.i.i ], [ 0, %B138.if.i ]
  %.161.i.i = add nuw nsw i64 %.90.0213.i.i, 1
  %.idx821 = mul i64 %.90.0213.i.i, 56
  %29 = getelementptr i8, ptr %.3481.i, i64 %.idx821
  %.242.i.i = getelementptr i8, ptr %29, i64 48
  %.243.i.i = load double, ptr %.242.i.i, align 8, !noalias !65
  %.245.i.i = fsub double %.1283.i, %.243.i.i
  %.303.i.i = load double, ptr %29, align 8, !noalias !65
  %.357.i.i = getelementptr i8, ptr %29, i64 8
  %.358.i.i = load double, ptr %.357.i.i, align 8, !noalias !65
  %.360.i.i815 = fmul double %.245.i.i, %.358.i.i
  %.361.i.i816 = fadd double %.303.i.i, %.360.i.i815
  %.422.i.i = getelementptr i8, ptr %29, i64 16
  %.423.i.i = load double, ptr %.422.i.i, align 8, !noalias !65
  %.424.i.i = fcmp une double %.423.i.i, 0.000000e+00
  br i1 %.424.i.i, label %B164.i.i, label %B272.i.i
B260.if.i:
  %.1346.0437.i = phi i64 [ 0, %B260.preheader.i ], [ %.1415.i, %B260.if.i ]
  %.1415.i = add nuw nsw i64 %.1346.0437.i, 1
  %30 = getelementptr double, ptr %.65.fca.5.0.4.load.i, i64 %.1346.0437.i
  %.1469.i = load double, ptr %30, align 8, !noalias !54
  %.1479.i = add nuw nsw i64 %.1346.0437.i, %.1478.i
  %.1527.i = mul i64 %.1479.i, %.392.i.i
  %gep440.i = getelementptr double, ptr %invariant.gep439.i, i64 %.1527.i
  store double %.1469.i, ptr %gep440.i, align 8, !noalias !54
  %exitcond.not.i817 = icmp eq i64 %.1415.i, %.65.fca.5.0.2.load.i
  br i1 %exitcond.not.i817, label %B138.loopexit.i, label %B260.if.i
b93:
  call void @llvm.lifetime.end.p0(ptr nonnull %.49.i)
  br label %common.ret
}
define internal fastcc void @v73(ptr noalias nonnull writeonly %retptr, ptr readonly %arg.f.4, i64 %arg.i, i64 %arg.status) unnamed_addr {
entry:
  %.27 = alloca { [5 x i64], { { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, double, double, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, i8 }, { { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] } }, [13 x { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }], { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, align 8
  %.fca.0.3.gep = getelementptr inbounds i8, ptr %.27, i64 24
  %.fca.1.0.4.gep = getelementptr inbounds i8, ptr %.27, i64 72
  %.fca.3.0.0.gep = getelementptr inbounds i8, ptr %.27, i64 528
  %.fca.3.0.4.gep = getelementptr inbounds i8, ptr %.27, i64 560
  %.fca.3.1.4.gep = getelementptr inbounds i8, ptr %.27, i64 616
  %.fca.3.1.5.1.gep = getelementptr inbounds i8, ptr %.27, i64 632
  %.fca.3.2.2.gep = getelementptr inbounds i8, ptr %.27, i64 672
  %.fca.3.2.4.gep = getelementptr inbounds i8, ptr %.27, i64 688
  %.fca.5.0.2.gep = getelementptr inbounds i8, ptr %.27, i64 872
  %.fca.5.0.4.gep = getelementptr inbounds i8, ptr %.27, i64 888
  %.fca.5.3.4.gep = getelementptr inbounds i8, ptr %.27, i64 1056
  %.fca.6.2.gep = getelementptr inbounds i8, ptr %.27, i64 1600
  %.fca.6.4.gep = getelementptr inbounds i8, ptr %.27, i64 1616
  %.fca.9.4.gep = getelementptr inbounds i8, ptr %.27, i64 1784
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(521) %.27, i8 0, i64 521, i1 false)
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(1280) %.fca.3.0.0.gep, i8 0, i64 1280, i1 false)
  call fastcc void @v77(ptr %.27, ptr %arg.f.4, i64 %arg.i)
  %.43.fca.0.3.load = load i64, ptr %.fca.0.3.gep, align 8
  %.43.fca.1.0.4.load = load ptr, ptr %.fca.1.0.4.gep, align 8
  %.43.fca.3.0.4.load = load ptr, ptr %.fca.3.0.4.gep, align 8
  %.43.fca.3.1.4.load = load ptr, ptr %.fca.3.1.4.gep, align 8
  %.43.fca.3.1.5.1.load = load i64, ptr %.fca.3.1.5.1.gep, align 8
  %.43.fca.3.2.2.load = load i64, ptr %.fca.3.2.2.gep, align 8
  %.43.fca.3.2.4.load = load ptr, ptr %.fca.3.2.4.gep, align 8
  %.43.fca.5.0.2.load = load i64, ptr %.fca.5.0.2.gep, align 8
  %.43.fca.5.0.4.load = load ptr, ptr %.fca.5.0.4.gep, align 8
  %.43.fca.5.3.4.load = load ptr, ptr %.fca.5.3.4.gep, align 8
  %.43.fca.6.2.load = load i64, ptr %.fca.6.2.gep, align 8
  %.43.fca.6.4.load = load ptr, ptr %.fca.6.4.gep, align 8
  %.43.fca.9.4.load = load ptr, ptr %.fca.9.4.gep, align 8
  %.817 = getelementptr i8, ptr %arg.f.4, i64 128
  %.818 = load i64, ptr %.817, align 8
  %.1164 = getelementptr i8, ptr %arg.f.4, i64 184
  %.1165 = load i64, ptr %.1164, align 8
  %.1511 = getelementptr i8, ptr %arg.f.4, i64 152
  %.1512 = load i64, ptr %.1511, align 8
  %.1858 = getelementptr i8, ptr %arg.f.4, i64 240
  %.1859 = load i64, ptr %.1858, align 8
  %0 = getelementptr i8, ptr %arg.f.4, i64 456
  %.45.i = load i64, ptr %0, align 8, !noalias !66
  %.46.i = inttoptr i64 %.45.i to ptr
  %.392.i = load i64, ptr %arg.f.4, align 8, !noalias !66
  %.3353 = icmp slt i64 %arg.i, 0
  %.3354 = select i1 %.3353, i64 %.392.i, i64 0
  %1 = getelementptr double, ptr %.46.i, i64 %arg.i
  %.3376 = getelementptr double, ptr %1, i64 %.3354
  %.3377 = load double, ptr %.3376, align 8
  %.360.i = getelementptr i8, ptr %arg.f.4, i64 608
  %.361.i = load i64, ptr %.360.i, align 8, !noalias !69
  %.362.i = inttoptr i64 %.361.i to ptr
  %2 = getelementptr i64, ptr %.362.i, i64 %arg.i
  %.3478 = getelementptr i64, ptr %2, i64 %.3354
  %.3479 = load i64, ptr %.3478, align 8
  %3 = getelementptr i8, ptr %arg.f.4, i64 448
  %.45.i2694 = load i64, ptr %3, align 8, !noalias !72
  %.46.i2695 = inttoptr i64 %.45.i2694 to ptr
  %.idx = mul i64 %.392.i, 112
  %4 = getelementptr i8, ptr %.46.i2695, i64 %.idx
  %5 = getelementptr double, ptr %4, i64 %arg.i
  %.3986 = getelementptr double, ptr %5, i64 %.3354
  %.3987 = load double, ptr %.3986, align 8
  %.5.i = fptosi double %.3987 to i64
  %.idx2682 = mul i64 %.392.i, 120
  %6 = getelementptr i8, ptr %.46.i2695, i64 %.idx2682
  %7 = getelementptr double, ptr %6, i64 %arg.i
  %.4429 = getelementptr double, ptr %7, i64 %.3354
  %.4430 = load double, ptr %.4429, align 8
  %.5.i2716 = fptosi double %.4430 to i64
  %.4488 = getelementptr i8, ptr %.43.fca.9.4.load, i64 8
  store i64 %.5.i, ptr %.4488, align 8
  store i64 %.5.i2716, ptr %.43.fca.9.4.load, align 8
  %.392.i.i = load i64, ptr %arg.f.4, align 8, !noalias !75
  %.175117.not.i = icmp slt i64 %.43.fca.6.2.load, 1
  br i1 %.175117.not.i, label %b95, label %B76.if.lr.ph.i
B76.if.lr.ph.i:
  %8 = getelementptr i8, ptr %arg.f.4, i64 464
  %.45.i.i = load i64, ptr %8, align 8, !noalias !75
  %.46.i.i = inttoptr i64 %.45.i.i to ptr
  %invariant.gep.i = getelementptr double, ptr %.46.i.i, i64 %arg.i
  %.242.i = select i1 %.3353, i64 %.392.i.i, i64 0
  %invariant.gep120.i = getelementptr double, ptr %invariant.gep.i, i64 %.242.i
  br label %B76.if.i
B76.if.i:
  %.119.0118.i = phi i64 [ 0, %B76.if.lr.ph.i ], [ %.188.i, %B76.if.i ]
  %.188.i = add nuw nsw i64 %.119.0118.i, 1
  %.260.i = mul i64 %.119.0118.i, %.392.i.i
  %gep121.i = getelementptr double, ptr %invariant.gep120.i, i64 %.260.i
  %.265.i = load double, ptr %gep121.i, align 8, !noalias !80
  %9 = getelementptr double, ptr %.43.fca.6.4.load, i64 %.119.0118.i
  store double %.265.i, ptr %9, align 8, !noalias !80
  %exitcond.not.i = icmp eq i64 %.188.i, %.43.fca.6.2.load
  br i1 %exitcond.not.i, label %b95, label %B76.if.i
b95:
  %.5194 = add nsw i64 %.3479, 1
  %.5540 = getelementptr i8, ptr %arg.f.4, i64 384
  %.5541 = load i64, ptr %.5540, align 8
  %.5542 = mul nsw i64 %.5541, %.5194
  %.45.i2717 = getelementptr i8, ptr %arg.f.4, i64 376
  %.46.i2718 = load i64, ptr %.45.i2717, align 8, !noalias !81
  %.50.i = inttoptr i64 %.46.i2718 to ptr
  %.5928 = mul nsw i64 %.5541, %.3479
  %.5964 = icmp slt i64 %.5928, 0
  %.5965 = select i1 %.5964, i64 %.5542, i64 0
  %.5966 = add i64 %.5965, %.5928
  %.5969 = icmp slt i64 %.5966, 0
  br i1 %.5969, label %B0.endif.endif.endif.endi...endif.1.else.if, label %B0.endif.endif.endif.endi...endif.1.else.endif, !prof !84
B858:
  %.6145 = add nsw i64 %.1859, -1
  %.13.i = tail call i64 @llvm.smin.i64(i64 %.6145, i64 %.6143)
  store i64 %.13.i, ptr %.6142, align 8
  %.361.i.i = load i64, ptr %.360.i, align 8, !noalias !85
  %.362.i.i = inttoptr i64 %.361.i.i to ptr
  %.708.i.i = load i64, ptr %arg.f.4, align 8, !noalias !85
  %.96.i = select i1 %.3353, i64 %.708.i.i, i64 0
  %10 = getelementptr i64, ptr %.362.i.i, i64 %.708.i.i
  %11 = getelementptr i64, ptr %10, i64 %arg.i
  %.118.i = getelementptr i64, ptr %11, i64 %.96.i
  %.119.i = load i64, ptr %.118.i, align 8, !noalias !90
  %.470.i = getelementptr i8, ptr %arg.f.4, i64 224
  %.471.i = load i64, ptr %.470.i, align 8, !noalias !90
  %.817.i = getelementptr i8, ptr %arg.f.4, i64 144
  %.818.i = load i64, ptr %.817.i, align 8, !noalias !90
  %.45.i384.i = getelementptr i8, ptr %arg.f.4, i64 312
  %.46.i385.i = load i64, ptr %.45.i384.i, align 8, !noalias !91
  %.50.i386.i = inttoptr i64 %.46.i385.i to ptr
  %.2348.i = icmp slt i64 %.119.i, 0
  %.2349.i = select i1 %.2348.i, i64 %.471.i, i64 0
  %12 = getelementptr i64, ptr %.50.i386.i, i64 %.119.i
  %.2363.i = getelementptr i64, ptr %12, i64 %.2349.i
  %.2364.i = load i64, ptr %.2363.i, align 8, !noalias !90
  %.2713.i = getelementptr i8, ptr %arg.f.4, i64 264
  %.2714.i = load i64, ptr %.2713.i, align 8, !noalias !90
  %.2715.i = icmp sgt i64 %.2714.i, 0
  br i1 %.2715.i, label %B432.i, label %b92
B432.i:
  %.3065.i = getelementptr i8, ptr %arg.f.4, i64 232
  %.3066.i = load i64, ptr %.3065.i, align 8, !noalias !90
  %.3068.i = mul nsw i64 %.3066.i, %arg.i
  br label %b92
b92:
  %"$phi476.1.2.0.i" = phi i64 [ %.3068.i, %B432.i ], [ 0, %B858 ]
  %.3082.i = add nsw i64 %"$phi476.1.2.0.i", %.2364.i
  %.3470.i = getelementptr i8, ptr %arg.f.4, i64 320
  %.3471.i = load i64, ptr %.3470.i, align 8, !noalias !90
  %.3478.i = mul nsw i64 %.818.i, 56
  %.3479.i = mul nsw i64 %.3478.i, %.3082.i
  %.3480.i = add nsw i64 %.3479.i, %.3471.i
  %.3481.i = inttoptr i64 %.3480.i to ptr
  %.148211.not.i.i.i = icmp slt i64 %.43.fca.5.0.2.load, 1
  br i1 %.148211.not.i.i.i, label %b96, label %B58.if.i.i.i
B164.i.i.i:
  %.44.i.i.i.i = getelementptr i8, ptr %14, i64 24
  %.45.i.i.i.i = load double, ptr %.44.i.i.i.i, align 8, !noalias !94
  %.73.i.i.i.i = getelementptr i8, ptr %14, i64 32
  %.74.i.i.i.i = load double, ptr %.73.i.i.i.i, align 8, !noalias !94
  %.75.i.i.i.i = fmul double %.74.i.i.i.i, 5.000000e-01
  %.76.i.i.i.i = fmul double %.245.i.i.i, %.75.i.i.i.i
  %.77.i.i.i.i = fadd double %.45.i.i.i.i, %.76.i.i.i.i
  %.78.i.i.i.i = fmul double %.245.i.i.i, %.77.i.i.i.i
  %.87.le.i.i.i.i = tail call double @llvm.floor.f64(double %.78.i.i.i.i)
  %.92.i.i.i.i = fsub double %.78.i.i.i.i, %.87.le.i.i.i.i
  %.93.i.i.i.i = fmul double %.92.i.i.i.i, 0x401921FB54442D18
  %.121.i.i.i.i = getelementptr i8, ptr %14, i64 40
  %.122.i.i.i.i = load double, ptr %.121.i.i.i.i, align 8, !noalias !94
  %.126.i.i.i.i = fadd double %.122.i.i.i.i, %.93.i.i.i.i
  %.593.le.i.i.i = tail call double @llvm.sin.f64(double %.126.i.i.i.i)
  %.598.i.i.i = fmul double %.423.i.i.i, %.593.le.i.i.i
  %.600.i.i.i = fadd double %.361.i.i.i, %.598.i.i.i
  br label %B272.i.i.i
B272.i.i.i:
  %value.2.1.i.i.i = phi double [ %.600.i.i.i, %B164.i.i.i ], [ %.361.i.i.i, %B58.if.i.i.i ]
  %13 = getelementptr double, ptr %.43.fca.5.0.4.load, i64 %.90.0213.i.i.i
  store double %value.2.1.i.i.i, ptr %13, align 8, !noalias !103
  %exitcond.not.i.i.i = icmp eq i64 %.43.fca.5.0.2.load, %.161.i.i.i
  br i1 %exitcond.not.i.i.i, label %b96, label %B58.if.i.i.i
B58.if.i.i.i:
  %.90.0213.i.i.i = phi i64 [ %.161.i.i.i, %B272.i.i.i ], [ 0, %b92 ]
  %.161.i.i.i = add nuw nsw i64 %.90.0213.i.i.i, 1
  %.idx2743 = mul i64 %.90.0213.i.i.i, 56
  %14 = getelementptr i8, ptr %.3481.i, i64 %.idx2743
  %.242.i.i.i = getelementptr i8, ptr %14, i64 48
  %.243.i.i.i = load double, ptr %.242.i.i.i, align 8, !noalias !103
  %.245.i.i.i = fsub double %.3377, %.243.i.i.i
  %.303.i.i.i = load double, ptr %14, align 8, !noalias !103
  %.357.i.i.i = getelementptr i8, ptr %14, i64 8
  %.358.i.i.i = load double, ptr %.357.i.i.i, align 8, !noalias !103
  %.360.i.i.i = fmul double %.245.i.i.i, %.358.i.i.i
  %.361.i.i.i = fadd double %.303.i.i.i, %.360.i.i.i
  %.422.i.i.i = getelementptr i8, ptr %14, i64 16
  %.423.i.i.i = load double, ptr %.422.i.i.i, align 8, !noalias !103
  %.424.i.i.i = fcmp une double %.423.i.i.i, 0.000000e+00
  br i1 %.424.i.i.i, label %B164.i.i.i, label %B272.i.i.i
b96:
  store double %.3377, ptr %.43.fca.5.3.4.load, align 8, !noalias !104
  %.992.i.i = inttoptr i64 %.43.fca.0.3.load to ptr
  tail call void %.992.i.i(ptr nonnull %.43.fca.5.3.4.load, ptr %.43.fca.6.4.load, ptr %.43.fca.5.0.4.load, ptr %.43.fca.1.0.4.load, ptr %.43.fca.3.2.4.load), !noalias !104
  %.649.i = load i64, ptr %.6142, align 8, !noalias !105
  %.754872.not.i = icmp slt i64 %.43.fca.3.2.2.load, 1
  br i1 %.754872.not.i, label %b97, label %B116.if.lr.ph.i
B116.if.lr.ph.i:
  %invariant.gep.i2721 = getelementptr double, ptr %.43.fca.3.1.4.load, i64 %.649.i
  %.879.i = icmp slt i64 %.649.i, 0
  %.880.i = select i1 %.879.i, i64 %.43.fca.3.1.5.1.load, i64 0
  %invariant.gep875.i = getelementptr double, ptr %invariant.gep.i2721, i64 %.880.i
  br label %B116.if.i
B116.if.i:
  %.698.0873.i = phi i64 [ 0, %B116.if.lr.ph.i ], [ %.767.i, %B116.if.i ]
  %.767.i = add nuw nsw i64 %.698.0873.i, 1
  %15 = getelementptr double, ptr %.43.fca.3.2.4.load, i64 %.698.0873.i
  %.821.i = load double, ptr %15, align 8, !noalias !105
  %.898.i = mul i64 %.698.0873.i, %.43.fca.3.1.5.1.load
  %gep876.i = getelementptr double, ptr %invariant.gep875.i, i64 %.898.i
  store double %.821.i, ptr %gep876.i, align 8, !noalias !105
  %exitcond.not.i2722 = icmp eq i64 %.767.i, %.43.fca.3.2.2.load
  br i1 %exitcond.not.i2722, label %b97, label %B116.if.i
b97:
  %.922.i = add nsw i64 %.649.i, 1
  store i64 %.922.i, ptr %.6142, align 8, !noalias !105
  br label %B1138
B1030:
  %.6449 = icmp sgt i64 %.6143, 0
  br i1 %.6449, label %B1064, label %B1138
B1064:
  %16 = getelementptr double, ptr %.43.fca.3.0.4.load, i64 %.6143
  %.6537 = getelementptr i8, ptr %16, i64 -8
  %.6538 = load double, ptr %.6537, align 8
  br label %B1138
B1138:
  %.3377.sink = phi double [ %.3377, %b97 ], [ %.6538, %B1064 ], [ 0.000000e+00, %B1030 ]
  %17 = getelementptr double, ptr %.6067, i64 %.6051
  %.6412 = getelementptr i8, ptr %17, i64 -8
  store double %.3377.sink, ptr %.6412, align 8
  %.6611 = getelementptr i8, ptr %.43.fca.9.4.load, i64 16
  %.6612 = load i64, ptr %.6611, align 8
  %18 = getelementptr i8, ptr %arg.f.4, i64 592
  %.45.i2723 = load i64, ptr %18, align 8, !noalias !106
  %.46.i2724 = inttoptr i64 %.45.i2723 to ptr
  %.392.i2725 = load i64, ptr %arg.f.4, align 8, !noalias !106
  %.7005 = getelementptr i8, ptr %.43.fca.9.4.load, i64 40
  store i64 %arg.status, ptr %.7005, align 8
  %.71122748.not = icmp slt i64 %.818, 1
  br i1 %.71122748.not, label %B1392, label %B1268.if.preheader
B1268.if.preheader:
  %invariant.gep2773 = getelementptr double, ptr %.6067, i64 %.818
  br label %B1268.if
B1348.if.lr.ph:
  %spec.select2740 = mul nuw nsw i64 %.818, 3
  %invariant.gep = getelementptr double, ptr %.46.i2724, i64 %arg.i
  %.7372 = select i1 %.3353, i64 %.392.i2725, i64 0
  %invariant.gep2754 = getelementptr double, ptr %invariant.gep, i64 %.7372
  %.idx2768 = shl i64 %.818, 4
  %invariant.gep2775 = getelementptr i8, ptr %.6067, i64 %.idx2768
  br label %B1348.if
B1392:
  %.7447 = mul nsw i64 %.818, 5
  %.7449 = add nsw i64 %.7447, %.1165
  %.7486 = icmp slt i64 %.7449, 0
  %.7487 = select i1 %.7486, i64 %.6051, i64 0
  %.7488 = add i64 %.7487, %.7449
  %.7491 = icmp slt i64 %.7488, 0
  br i1 %.7491, label %B1392.else.if, label %B1392.else.endif, !prof !84
B1484.loopexit:
  %exitcond2767.not = icmp eq i64 %.7959, %.1512
  br i1 %exitcond2767.not, label %B1654, label %B1484.if
B1500:
  %.8039 = mul i64 %.7890.02761, %.43.fca.3.1.5.1.load
  %gep = getelementptr double, ptr %invariant.gep2759, i64 %.8039
  %.8043 = getelementptr i8, ptr %gep, i64 -8
  %.8044 = load double, ptr %.8043, align 8
  br label %B1548
B1548:
  %"$phi1548.1.2.1" = phi double [ %.8044, %B1500 ], [ 0x7FF8000000000000, %B1484.if ]
  %.8060 = add nsw i64 %.8058, %.7890.02761
  %.8075 = icmp slt i64 %.8060, 0
  %.8076 = select i1 %.8075, i64 %.6051, i64 0
  %19 = getelementptr double, ptr %.6067, i64 %.8060
  %.8090 = getelementptr double, ptr %19, i64 %.8076
  store double %"$phi1548.1.2.1", ptr %.8090, align 8
  br i1 %.81752756.not, label %B1484.loopexit, label %B1612.if.lr.ph
B1612.if.lr.ph:
  %.8260 = mul i64 %.7890.02761, %.43.fca.3.1.5.1.load
  %20 = getelementptr double, ptr %.43.fca.3.1.4.load, i64 %.8260
  br label %B1612.if
B1654:
  store ptr null, ptr %retptr, align 8
  ret void
B0.endif.endif.endif.endi...endif.1.else.if:
  br label %B0.endif.endif.endif.endi...endif.1.else.endif
B0.endif.endif.endif.endi...endif.1.else.endif:
  %.5954.sroa.0.1 = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.1.else.if ], [ %.5966, %b95 ]
  %.5974.not = icmp slt i64 %.5966, %.5542
  br i1 %.5974.not, label %B0.endif.endif.endif.endi...endif.2.if, label %B0.endif.endif.endif.endi...endif.1.else.endif.if, !prof !109
B0.endif.endif.endif.endi...endif.1.else.endif.if:
  br label %B0.endif.endif.endif.endi...endif.2.if
B0.endif.endif.endif.endi...endif.2.if:
  %.5954.sroa.0.3 = phi i64 [ %.5542, %B0.endif.endif.endif.endi...endif.1.else.endif.if ], [ %.5954.sroa.0.1, %B0.endif.endif.endif.endi...endif.1.else.endif ]
  %.6042 = sub i64 %.5542, %.5954.sroa.0.3
  %.6051 = tail call i64 @llvm.smax.i64(i64 %.6042, i64 0)
  %.6067 = getelementptr double, ptr %.50.i, i64 %.5954.sroa.0.3
  %or.cond = icmp ult i64 %arg.status, 2
  %.6142 = getelementptr i8, ptr %.43.fca.9.4.load, i64 16
  %.6143 = load i64, ptr %.6142, align 8
  br i1 %or.cond, label %B858, label %B1030
B1268.if:
  %.7056.02749 = phi i64 [ %.7125, %B1268.if ], [ 0, %B1268.if.preheader ]
  %.7125 = add nuw nsw i64 %.7056.02749, 1
  %21 = getelementptr double, ptr %.43.fca.6.4.load, i64 %.7056.02749
  %.7183 = load double, ptr %21, align 8
  %gep2774 = getelementptr double, ptr %invariant.gep2773, i64 %.7056.02749
  store double %.7183, ptr %gep2774, align 8
  %exitcond.not = icmp eq i64 %.818, %.7125
  br i1 %exitcond.not, label %B1348.if.lr.ph, label %B1268.if
B1348.if:
  %.7252.02753 = phi i64 [ %spec.select2740, %B1348.if.lr.ph ], [ %.7314, %B1348.if ]
  %.7249.02752 = phi i64 [ 0, %B1348.if.lr.ph ], [ %.7318, %B1348.if ]
  %.7314 = add nsw i64 %.7252.02753, -1
  %.7318 = add nuw nsw i64 %.7249.02752, 1
  %.7390 = mul i64 %.7249.02752, %.392.i2725
  %gep2755 = getelementptr double, ptr %invariant.gep2754, i64 %.7390
  %.7395 = load double, ptr %gep2755, align 8
  %gep2776 = getelementptr double, ptr %invariant.gep2775, i64 %.7249.02752
  store double %.7395, ptr %gep2776, align 8
  %.7305 = icmp ugt i64 %.7252.02753, 1
  br i1 %.7305, label %B1348.if, label %B1392
B1392.else.if:
  br label %B1392.else.endif
B1392.else.endif:
  %.7476.sroa.0.1 = phi i64 [ 0, %B1392.else.if ], [ %.7488, %B1392 ]
  %.7496.not = icmp slt i64 %.7488, %.6051
  br i1 %.7496.not, label %B1392.else.endif.endif.endif.if, label %B1392.else.endif.if, !prof !109
B1392.else.endif.if:
  br label %B1392.else.endif.endif.endif.if
B1392.else.endif.endif.endif.if:
  %.7476.sroa.0.3 = phi i64 [ %.6051, %B1392.else.endif.if ], [ %.7476.sroa.0.1, %B1392.else.endif ]
  %.7589 = getelementptr double, ptr %.6067, i64 %.7476.sroa.0.3
  %.817.i2734 = load i64, ptr %.1164, align 8, !noalias !110
  %.818.i2735 = icmp sgt i64 %.817.i2734, 0
  br i1 %.818.i2735, label %B48.i, label %b98
B48.i:
  %.10201676.not.i = icmp slt i64 %.43.fca.5.0.2.load, 1
  br i1 %.10201676.not.i, label %B144.i, label %B108.if.i.preheader
B108.if.i.preheader:
  %22 = shl nuw i64 %.43.fca.5.0.2.load, 3
  tail call void @llvm.memset.p0.i64(ptr align 8 %.43.fca.5.0.4.load, i8 0, i64 %22, i1 false), !noalias !110
  br label %B144.i
B144.i:
  store double 0.000000e+00, ptr %.43.fca.5.3.4.load, align 8, !noalias !110
  %.1692.i = getelementptr i8, ptr %arg.f.4, i64 104
  %.1693.i = load i64, ptr %.1692.i, align 8, !noalias !110
  %.2109.i = inttoptr i64 %.1693.i to ptr
  tail call void %.2109.i(ptr nonnull %.43.fca.5.3.4.load, ptr %.43.fca.6.4.load, ptr %.43.fca.5.0.4.load, ptr %.43.fca.1.0.4.load, ptr %.7589), !noalias !110
  br label %b98
b98:
  %invariant.gep2759 = getelementptr double, ptr %.43.fca.3.1.4.load, i64 %.6612
  %.79462760.not = icmp slt i64 %.1512, 1
  br i1 %.79462760.not, label %B1654, label %B1484.if.lr.ph
B1484.if.lr.ph:
  %.7988 = icmp sgt i64 %.6612, 0
  %.8057 = shl nsw i64 %.1165, 1
  %.8058 = add nsw i64 %.8057, %.7447
  %.8132 = sub i64 %.1859, %.6612
  %spec.select2741 = tail call i64 @llvm.smax.i64(i64 %.8132, i64 0)
  %.81752756.not = icmp slt i64 %.8132, 1
  br label %B1484.if
B1484.if:
  %.7890.02761 = phi i64 [ 0, %B1484.if.lr.ph ], [ %.7959, %B1484.loopexit ]
  %.7959 = add nuw nsw i64 %.7890.02761, 1
  br i1 %.7988, label %B1500, label %B1548
B1612.if:
  %.8122.02758 = phi i64 [ %spec.select2741, %B1612.if.lr.ph ], [ %.8184, %B1612.if ]
  %.8119.02757 = phi i64 [ %.6612, %B1612.if.lr.ph ], [ %.8188, %B1612.if ]
  %.8184 = add nsw i64 %.8122.02758, -1
  %.8188 = add i64 %.8119.02757, 1
  %.8241 = icmp slt i64 %.8119.02757, 0
  %.8242 = select i1 %.8241, i64 %.43.fca.3.1.5.1.load, i64 0
  %23 = getelementptr double, ptr %20, i64 %.8119.02757
  %.8264 = getelementptr double, ptr %23, i64 %.8242
  store double 0x7FF8000000000000, ptr %.8264, align 8
  %.8175 = icmp sgt i64 %.8122.02758, 1
  br i1 %.8175, label %B1612.if, label %B1484.loopexit
}
define internal fastcc void @v74(ptr noalias nonnull writeonly %retptr, ptr readonly %arg.f.4, i64 %arg.i, i64 %arg.k) unnamed_addr {
entry:
  %.1671 = alloca { [5 x i64], { { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, double, double, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, i8 }, { { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] } }, [13 x { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }], { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, align 8
  %.fca.1.0.2.gep = getelementptr inbounds i8, ptr %.1671, i64 56
  %.fca.1.0.4.gep = getelementptr inbounds i8, ptr %.1671, i64 72
  %.fca.1.0.5.0.gep = getelementptr inbounds i8, ptr %.1671, i64 80
  %.fca.1.4.2.gep = getelementptr inbounds i8, ptr %.1671, i64 280
  %.fca.1.4.4.gep = getelementptr inbounds i8, ptr %.1671, i64 296
  %.fca.2.0.4.gep = getelementptr inbounds i8, ptr %.1671, i64 352
  %.fca.2.0.5.1.gep = getelementptr inbounds i8, ptr %.1671, i64 368
  %.fca.2.1.4.gep = getelementptr inbounds i8, ptr %.1671, i64 424
  %.fca.3.0.0.gep = getelementptr inbounds i8, ptr %.1671, i64 528
  %.fca.5.0.2.gep = getelementptr inbounds i8, ptr %.1671, i64 872
  %.fca.5.0.4.gep = getelementptr inbounds i8, ptr %.1671, i64 888
  %.fca.5.3.4.gep = getelementptr inbounds i8, ptr %.1671, i64 1056
  %.fca.6.2.gep3721 = getelementptr inbounds i8, ptr %.1671, i64 1600
  %.fca.6.4.gep = getelementptr inbounds i8, ptr %.1671, i64 1616
  %.fca.9.4.gep = getelementptr inbounds i8, ptr %.1671, i64 1784
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(521) %.1671, i8 0, i64 521, i1 false)
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(1280) %.fca.3.0.0.gep, i8 0, i64 1280, i1 false)
  %.360.i = getelementptr i8, ptr %arg.f.4, i64 608
  %.361.i = load i64, ptr %.360.i, align 8, !noalias !113
  %.362.i = inttoptr i64 %.361.i to ptr
  %.708.i = load i64, ptr %arg.f.4, align 8, !noalias !113
  %.99 = icmp slt i64 %arg.i, 0
  %.100 = select i1 %.99, i64 %.708.i, i64 0
  %0 = getelementptr i64, ptr %.362.i, i64 %arg.i
  %.122 = getelementptr i64, ptr %0, i64 %.100
  store i64 %arg.k, ptr %.122, align 8
  %.361.i4470 = load i64, ptr %.360.i, align 8, !noalias !116
  %.362.i4471 = inttoptr i64 %.361.i4470 to ptr
  %.708.i4472 = load i64, ptr %arg.f.4, align 8, !noalias !116
  %.202 = select i1 %.99, i64 %.708.i4472, i64 0
  %1 = getelementptr i64, ptr %.362.i4471, i64 %.708.i4472
  %2 = getelementptr i64, ptr %1, i64 %arg.i
  %.224 = getelementptr i64, ptr %2, i64 %.202
  store i64 -1, ptr %.224, align 8
  %3 = getelementptr i8, ptr %arg.f.4, i64 448
  %.45.i = load i64, ptr %3, align 8, !noalias !119
  %.46.i = inttoptr i64 %.45.i to ptr
  %.392.i = load i64, ptr %arg.f.4, align 8, !noalias !119
  %.621 = select i1 %.99, i64 %.392.i, i64 0
  %.622 = add i64 %.621, %arg.i
  %.idx = shl i64 %.392.i, 6
  %4 = getelementptr i8, ptr %.46.i, i64 %.idx
  %.643 = getelementptr double, ptr %4, i64 %.622
  store double 0.000000e+00, ptr %.643, align 8
  %.idx4458 = mul i64 %.392.i, 112
  %5 = getelementptr i8, ptr %.46.i, i64 %.idx4458
  %.697 = getelementptr double, ptr %5, i64 %.622
  store double 0.000000e+00, ptr %.697, align 8
  %.idx4459 = mul i64 %.392.i, 120
  %6 = getelementptr i8, ptr %.46.i, i64 %.idx4459
  %.751 = getelementptr double, ptr %6, i64 %.622
  store double 0.000000e+00, ptr %.751, align 8
  %.45.i4489 = getelementptr i8, ptr %arg.f.4, i64 344
  %.46.i4490 = load i64, ptr %.45.i4489, align 8, !noalias !122
  %.50.i = inttoptr i64 %.46.i4490 to ptr
  %.1137 = load double, ptr %.50.i, align 8
  %.45.i4491 = getelementptr i8, ptr %arg.f.4, i64 352
  %.46.i4492 = load i64, ptr %.45.i4491, align 8, !noalias !125
  %.50.i4493 = inttoptr i64 %.46.i4492 to ptr
  %.1524 = getelementptr i8, ptr %.50.i4493, i64 8
  %.1525 = load double, ptr %.1524, align 8
  %.9.i = fcmp olt double %.1525, 4.000000e+02
  %.10.i = select i1 %.9.i, double %.1525, double 4.000000e+02
  %.idx4460 = mul i64 %.392.i, 104
  %7 = getelementptr i8, ptr %.46.i, i64 %.idx4460
  %.1607 = getelementptr double, ptr %7, i64 %.622
  store double %.1137, ptr %.1607, align 8
  %.idx4461 = shl i64 %.392.i, 7
  %8 = getelementptr i8, ptr %.46.i, i64 %.idx4461
  %.1661 = getelementptr double, ptr %8, i64 %.622
  store double %.10.i, ptr %.1661, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(521) %.1671, i8 0, i64 521, i1 false)
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(1280) %.fca.3.0.0.gep, i8 0, i64 1280, i1 false)
  call fastcc void @v77(ptr %.1671, ptr nonnull %arg.f.4, i64 %arg.i)
  %.1687.fca.1.0.2.load = load i64, ptr %.fca.1.0.2.gep, align 8
  %.1687.fca.1.0.4.load = load ptr, ptr %.fca.1.0.4.gep, align 8
  %.1687.fca.1.0.5.0.load = load i64, ptr %.fca.1.0.5.0.gep, align 8
  %.1687.fca.1.4.2.load = load i64, ptr %.fca.1.4.2.gep, align 8
  %.1687.fca.1.4.4.load = load ptr, ptr %.fca.1.4.4.gep, align 8
  %.1687.fca.2.0.4.load = load ptr, ptr %.fca.2.0.4.gep, align 8
  %.1687.fca.2.0.5.1.load = load i64, ptr %.fca.2.0.5.1.gep, align 8
  %.1687.fca.2.1.4.load = load ptr, ptr %.fca.2.1.4.gep, align 8
  %.1687.fca.5.0.2.load = load i64, ptr %.fca.5.0.2.gep, align 8
  %.1687.fca.5.0.4.load = load ptr, ptr %.fca.5.0.4.gep, align 8
  %.1687.fca.5.3.4.load = load ptr, ptr %.fca.5.3.4.gep, align 8
  %.1687.fca.6.2.load = load i64, ptr %.fca.6.2.gep3721, align 8
  %.1687.fca.6.4.load = load ptr, ptr %.fca.6.4.gep, align 8
  %.1687.fca.9.4.load = load ptr, ptr %.fca.9.4.gep, align 8
  %.2459 = getelementptr i8, ptr %arg.f.4, i64 128
  %.2460 = load i64, ptr %.2459, align 8
  %.2806 = getelementptr i8, ptr %arg.f.4, i64 136
  %.2807 = load i64, ptr %.2806, align 8
  %.3153 = getelementptr i8, ptr %arg.f.4, i64 256
  %.3154 = load i64, ptr %.3153, align 8
  %.361.i4499 = getelementptr i8, ptr %arg.f.4, i64 160
  %.45.i4502 = getelementptr i8, ptr %arg.f.4, i64 272
  %.46.i4503 = load i64, ptr %.45.i4502, align 8, !noalias !128
  %.50.i4504 = inttoptr i64 %.46.i4503 to ptr
  %.4770 = icmp sgt i64 %.1687.fca.1.0.2.load, 0
  br i1 %.4770, label %B768.if, label %B796
B796:
  %.45.i4510 = getelementptr i8, ptr %arg.f.4, i64 280
  %.46.i4511 = load i64, ptr %.45.i4510, align 8, !noalias !131
  %.50.i4512 = inttoptr i64 %.46.i4511 to ptr
  %.57754633.not = icmp slt i64 %.3154, 1
  br i1 %.57754633.not, label %B1028, label %B984.if.lr.ph
B984.if.lr.ph:
  %.5622 = getelementptr i8, ptr %arg.f.4, i64 288
  %.5623 = load i64, ptr %.5622, align 8
  %.5624 = inttoptr i64 %.5623 to ptr
  %arg.k.lobit = lshr i64 %arg.k, 63
  %.5840 = add i64 %arg.k.lobit, %arg.k
  %.5860 = mul i64 %.3154, %.5840
  %9 = getelementptr double, ptr %.5624, i64 %.5860
  br label %B984.if
B1028:
  %.6290 = getelementptr i8, ptr %arg.f.4, i64 296
  %.6291 = load i64, ptr %.6290, align 8
  %.6292 = inttoptr i64 %.6291 to ptr
  %.7053 = getelementptr i8, ptr %arg.f.4, i64 320
  %.7054 = load i64, ptr %.7053, align 8
  %.7055 = inttoptr i64 %.7054 to ptr
  %.7401 = getelementptr i8, ptr %arg.f.4, i64 144
  %.7402 = load i64, ptr %.7401, align 8
  %.7813 = getelementptr i8, ptr %arg.f.4, i64 264
  %.7814 = load i64, ptr %.7813, align 8
  %.78944639.not = icmp slt i64 %.7814, 1
  br i1 %.78944639.not, label %B1478, label %B1364.if.lr.ph
B1364.if.lr.ph:
  %.6685 = getelementptr i8, ptr %arg.f.4, i64 232
  %.6686 = load i64, ptr %.6685, align 8
  %.80154636.not = icmp slt i64 %.6686, 1
  %.8140 = mul nsw i64 %.6686, %arg.i
  %.8262 = mul i64 %.7402, 7
  br label %B1364.if
B1364.loopexit:
  %exitcond4666.not = icmp eq i64 %.7907, %.7814
  br i1 %exitcond4666.not, label %B1478, label %B1364.if
B1478:
  %.8647 = getelementptr i8, ptr %arg.f.4, i64 96
  %.8648 = load i64, ptr %.8647, align 8
  %.8674 = inttoptr i64 %.8648 to ptr
  tail call void %.8674(ptr %.1687.fca.1.0.4.load, ptr %.1687.fca.6.4.load, ptr %.1687.fca.1.4.4.load)
  %.87654642.not = icmp slt i64 %.1687.fca.1.4.2.load, 1
  br i1 %.87654642.not, label %B1662, label %B1596.if
B1662:
  %.392.i.i = load i64, ptr %arg.f.4, align 8, !noalias !134
  br i1 %.4770, label %B76.if.lr.ph.i, label %b99
B76.if.lr.ph.i:
  %10 = getelementptr i8, ptr %arg.f.4, i64 496
  %.45.i.i = load i64, ptr %10, align 8, !noalias !134
  %.46.i.i = inttoptr i64 %.45.i.i to ptr
  %invariant.gep.i = getelementptr double, ptr %.46.i.i, i64 %arg.i
  %.272.i = select i1 %.99, i64 %.392.i.i, i64 0
  %invariant.gep120.i = getelementptr double, ptr %invariant.gep.i, i64 %.272.i
  br label %B76.if.i
B76.if.i:
  %.119.0118.i = phi i64 [ 0, %B76.if.lr.ph.i ], [ %.188.i, %B76.if.i ]
  %.188.i = add nuw nsw i64 %.119.0118.i, 1
  %11 = getelementptr double, ptr %.1687.fca.1.0.4.load, i64 %.119.0118.i
  %.242.i = load double, ptr %11, align 8, !noalias !139
  %.290.i = mul i64 %.119.0118.i, %.392.i.i
  %gep121.i = getelementptr double, ptr %invariant.gep120.i, i64 %.290.i
  store double %.242.i, ptr %gep121.i, align 8, !noalias !139
  %exitcond.not.i = icmp eq i64 %.188.i, %.1687.fca.1.0.2.load
  br i1 %exitcond.not.i, label %b100, label %B76.if.i
b100:
  %.10957.pre = load i64, ptr %arg.f.4, align 8
  br label %b99
b99:
  %.10957 = phi i64 [ %.10957.pre, %b100 ], [ %.392.i.i, %B1662 ]
  %.9915 = getelementptr i8, ptr %arg.f.4, i64 24
  %.9916 = load i64, ptr %.9915, align 8
  %.10262 = getelementptr i8, ptr %arg.f.4, i64 496
  %.10263 = load i64, ptr %.10262, align 8
  %.10958 = shl i64 %.1687.fca.1.0.2.load, 3
  %.10971 = mul i64 %.10958, %.10957
  %.10972 = add nsw i64 %.10971, %.10263
  %.10973 = inttoptr i64 %.9916 to ptr
  tail call void %.10973(i64 %.10263, i64 %.10972)
  %.392.i.i4530 = load i64, ptr %arg.f.4, align 8, !noalias !140
  %.175117.not.i4531 = icmp slt i64 %.1687.fca.6.2.load, 1
  br i1 %.175117.not.i4531, label %b101, label %B76.if.lr.ph.i4532
B76.if.lr.ph.i4532:
  %12 = getelementptr i8, ptr %arg.f.4, i64 464
  %.45.i.i4533 = load i64, ptr %12, align 8, !noalias !140
  %.46.i.i4534 = inttoptr i64 %.45.i.i4533 to ptr
  %invariant.gep.i4535 = getelementptr double, ptr %.46.i.i4534, i64 %arg.i
  %.272.i4537 = select i1 %.99, i64 %.392.i.i4530, i64 0
  %invariant.gep120.i4538 = getelementptr double, ptr %invariant.gep.i4535, i64 %.272.i4537
  br label %B76.if.i4539
B76.if.i4539:
  %.119.0118.i4540 = phi i64 [ 0, %B76.if.lr.ph.i4532 ], [ %.188.i4541, %B76.if.i4539 ]
  %.188.i4541 = add nuw nsw i64 %.119.0118.i4540, 1
  %13 = getelementptr double, ptr %.1687.fca.6.4.load, i64 %.119.0118.i4540
  %.242.i4542 = load double, ptr %13, align 8, !noalias !145
  %.290.i4543 = mul i64 %.119.0118.i4540, %.392.i.i4530
  %gep121.i4544 = getelementptr double, ptr %invariant.gep120.i4538, i64 %.290.i4543
  store double %.242.i4542, ptr %gep121.i4544, align 8, !noalias !145
  %exitcond.not.i4545 = icmp eq i64 %.188.i4541, %.1687.fca.6.2.load
  br i1 %exitcond.not.i4545, label %b101, label %B76.if.i4539
b101:
  %.12077 = getelementptr i8, ptr %arg.f.4, i64 200
  %.12078 = load i64, ptr %.12077, align 8
  %.12079 = inttoptr i64 %.12078 to ptr
  %.193303.not.i = icmp slt i64 %.2807, 1
  br i1 %.193303.not.i, label %B2468, label %B56.if.lr.ph.i
B56.if.lr.ph.i:
  %.46.i4548 = load i64, ptr %.45.i4491, align 8, !noalias !146
  %.50.i4549 = inttoptr i64 %.46.i4548 to ptr
  %.11714 = getelementptr i8, ptr %.50.i4549, i64 24
  %.11715 = load double, ptr %.11714, align 8
  %.idx.i = shl i64 %.2807, 4
  %14 = getelementptr i8, ptr %.12079, i64 %.idx.i
  %.383.i = fmul double %.11715, 2.500000e-01
  %15 = getelementptr double, ptr %.12079, i64 %.2807
  %16 = getelementptr double, ptr %.1687.fca.2.0.4.load, i64 %.1687.fca.2.0.5.1.load
  %.idx302.i = shl i64 %.1687.fca.2.0.5.1.load, 4
  %17 = getelementptr i8, ptr %.1687.fca.2.0.4.load, i64 %.idx302.i
  br label %B56.if.i
B140.i:
  %.265.i = tail call double @llvm.fabs.f64(double %.264.i)
  br label %B162.i
B144.i:
  %18 = getelementptr double, ptr %14, i64 %.135.0304.i
  %.375.i = load double, ptr %18, align 8, !noalias !149
  br label %B162.i
B162.i:
  %"$phi162.1.2.1.i" = phi double [ %.265.i, %B140.i ], [ %.375.i, %B144.i ]
  %.437.i = getelementptr double, ptr %.12079, i64 %.135.0304.i
  %.438.i = load double, ptr %.437.i, align 8, !noalias !149
  %.439.i = fmul double %.383.i, %.438.i
  %.499.i = getelementptr double, ptr %.1687.fca.2.0.4.load, i64 %.135.0304.i
  store double %.439.i, ptr %.499.i, align 8, !noalias !149
  %.625.i = getelementptr double, ptr %15, i64 %.135.0304.i
  %.626.i = load double, ptr %.625.i, align 8, !noalias !149
  %.627.i = fmul double %.439.i, %.626.i
  %.628.i = fmul double %"$phi162.1.2.1.i", %.627.i
  %.688.i = getelementptr double, ptr %16, i64 %.135.0304.i
  store double %.628.i, ptr %.688.i, align 8, !noalias !149
  %.756.i = getelementptr double, ptr %17, i64 %.135.0304.i
  store double %"$phi162.1.2.1.i", ptr %.756.i, align 8, !noalias !149
  %exitcond.not.i4563 = icmp eq i64 %.206.i, %.2807
  br i1 %exitcond.not.i4563, label %B2364.preheader, label %B56.if.i
B56.if.i:
  %.135.0304.i = phi i64 [ 0, %B56.if.lr.ph.i ], [ %.206.i, %B162.i ]
  %.206.i = add nuw nsw i64 %.135.0304.i, 1
  %19 = getelementptr double, ptr %.1687.fca.6.4.load, i64 %.135.0304.i
  %.264.i = load double, ptr %19, align 8, !noalias !149
  %20 = getelementptr i8, ptr %.1687.fca.2.1.4.load, i64 %.135.0304.i
  %.303.i = load i8, ptr %20, align 1, !noalias !149
  %.307.i = icmp ne i8 %.303.i, 0
  %.310.i = fcmp one double %.264.i, 0.000000e+00
  %or.cond.i = select i1 %.307.i, i1 %.310.i, i1 false
  br i1 %or.cond.i, label %B140.i, label %B144.i
B2364.preheader:
  %.392.i45664620.ph = load i64, ptr %arg.f.4, align 8, !noalias !152
  %.46.i45764622.ph.in.in = getelementptr i8, ptr %arg.f.4, i64 576
  %.46.i45764622.ph.in = load i64, ptr %.46.i45764622.ph.in.in, align 8, !noalias !152
  %.46.i45764622.ph = inttoptr i64 %.46.i45764622.ph.in to ptr
  %invariant.gep = getelementptr double, ptr %.46.i45764622.ph, i64 %arg.i
  %.46.i45654618.ph.in.in = getelementptr i8, ptr %arg.f.4, i64 568
  %.46.i45654618.ph.in = load i64, ptr %.46.i45654618.ph.in.in, align 8, !noalias !152
  %.46.i45654618.ph = inttoptr i64 %.46.i45654618.ph.in to ptr
  %21 = getelementptr double, ptr %.1687.fca.2.0.4.load, i64 %.1687.fca.2.0.5.1.load
  %.idx4467 = shl i64 %.1687.fca.2.0.5.1.load, 4
  %22 = getelementptr i8, ptr %.1687.fca.2.0.4.load, i64 %.idx4467
  %.13294 = select i1 %.99, i64 %.392.i45664620.ph, i64 0
  %23 = getelementptr double, ptr %.46.i45654618.ph, i64 %.13294
  %invariant.gep4648 = getelementptr double, ptr %23, i64 %arg.i
  %invariant.gep4652 = getelementptr double, ptr %invariant.gep, i64 %.13294
  br label %B2364.if
B2468:
  %.13779 = add nsw i64 %arg.k, 1
  %.14125 = getelementptr i8, ptr %arg.f.4, i64 384
  %.14126 = load i64, ptr %.14125, align 8
  %.14127 = mul nsw i64 %.14126, %.13779
  %.45.i4586 = getelementptr i8, ptr %arg.f.4, i64 376
  %.46.i4587 = load i64, ptr %.45.i4586, align 8, !noalias !153
  %.50.i4588 = inttoptr i64 %.46.i4587 to ptr
  %.14514 = mul nsw i64 %.14126, %arg.k
  %.14552 = icmp slt i64 %.14514, 0
  %.14553 = select i1 %.14552, i64 %.14127, i64 0
  %.14554 = add i64 %.14553, %.14514
  %.14557 = icmp slt i64 %.14554, 0
  br i1 %.14557, label %B2468.endif.else.if, label %B2468.endif.else.endif, !prof !84
B2922:
  %.16054 = getelementptr i8, ptr %.1687.fca.9.4.load, i64 24
  store i64 -1, ptr %.16054, align 8
  store ptr null, ptr %retptr, align 8
  ret void
B768.if:
  %.4756.04632 = phi i64 [ %.4825, %B768.if ], [ 0, %entry ]
  %.4825 = add nuw nsw i64 %.4756.04632, 1
  %24 = getelementptr double, ptr %.50.i4504, i64 %.4756.04632
  %.4879 = load double, ptr %24, align 8
  %25 = getelementptr double, ptr %.1687.fca.1.0.4.load, i64 %.4756.04632
  store double %.4879, ptr %25, align 8
  %exitcond.not = icmp eq i64 %.1687.fca.1.0.2.load, %.4825
  br i1 %exitcond.not, label %B796, label %B768.if
B984.if:
  %.5719.04634 = phi i64 [ 0, %B984.if.lr.ph ], [ %.5788, %B984.if ]
  %.5788 = add nuw nsw i64 %.5719.04634, 1
  %26 = getelementptr double, ptr %9, i64 %.5719.04634
  %.5865 = load double, ptr %26, align 8
  %27 = getelementptr i64, ptr %.50.i4512, i64 %.5719.04634
  %.5897 = load i64, ptr %27, align 8
  %.5911 = icmp slt i64 %.5897, 0
  %.5912 = select i1 %.5911, i64 %.1687.fca.1.0.5.0.load, i64 0
  %28 = getelementptr double, ptr %.1687.fca.1.0.4.load, i64 %.5897
  %.5926 = getelementptr double, ptr %28, i64 %.5912
  store double %.5865, ptr %.5926, align 8
  %exitcond4664.not = icmp eq i64 %.5788, %.3154
  br i1 %exitcond4664.not, label %B1028, label %B984.if
B1364.if:
  %.7838.04640 = phi i64 [ 0, %B1364.if.lr.ph ], [ %.7907, %B1364.loopexit ]
  %.7907 = add nuw nsw i64 %.7838.04640, 1
  br i1 %.80154636.not, label %B1364.loopexit, label %B1398.if.lr.ph
B1398.if.lr.ph:
  %.idx4629 = shl i64 %.7838.04640, 4
  %29 = getelementptr i8, ptr %.6292, i64 %.idx4629
  %.8106 = getelementptr i8, ptr %29, i64 8
  br label %B1398.if
B1398.if:
  %.7959.04637 = phi i64 [ 0, %B1398.if.lr.ph ], [ %.8028, %B1398.if ]
  %.8028 = add nuw nsw i64 %.7959.04637, 1
  %.8107 = load i64, ptr %.8106, align 8
  %.8121 = icmp slt i64 %.8107, 0
  %.8122 = select i1 %.8121, i64 %.1687.fca.1.0.5.0.load, i64 0
  %30 = getelementptr double, ptr %.1687.fca.1.0.4.load, i64 %.8107
  %.8136 = getelementptr double, ptr %30, i64 %.8122
  %.8137 = load double, ptr %.8136, align 8
  %.8141 = add nsw i64 %.7959.04637, %.8140
  %.8196 = load i64, ptr %29, align 8
  %.8141.lobit = lshr i64 %.8141, 63
  %.8234 = add i64 %.8141.lobit, %.8141
  %.8235 = icmp slt i64 %.8196, 0
  %.8236 = select i1 %.8235, i64 %.7402, i64 0
  %.8237 = add i64 %.8236, %.8196
  %.8264 = mul i64 %.8262, %.8234
  %31 = getelementptr double, ptr %.7055, i64 %.8264
  %.8270.idx = mul i64 %.8237, 56
  %.8270 = getelementptr i8, ptr %31, i64 %.8270.idx
  store double %.8137, ptr %.8270, align 8
  %exitcond4665.not = icmp eq i64 %.6686, %.8028
  br i1 %exitcond4665.not, label %B1364.loopexit, label %B1398.if
B1596.if:
  %.8709.04643 = phi i64 [ %.8778, %B1596.if ], [ 0, %B1478 ]
  %.8778 = add nuw nsw i64 %.8709.04643, 1
  %32 = getelementptr double, ptr %.1687.fca.1.4.4.load, i64 %.8709.04643
  %.8832 = load double, ptr %32, align 8
  %.9179 = load i64, ptr %.361.i4499, align 8
  %.9180 = add nsw i64 %.9179, %.8709.04643
  %.9194 = icmp slt i64 %.9180, 0
  %.9195 = select i1 %.9194, i64 %.1687.fca.1.0.5.0.load, i64 0
  %33 = getelementptr double, ptr %.1687.fca.1.0.4.load, i64 %.9180
  %.9209 = getelementptr double, ptr %33, i64 %.9195
  store double %.8832, ptr %.9209, align 8
  %exitcond4667.not = icmp eq i64 %.1687.fca.1.4.2.load, %.8778
  br i1 %exitcond4667.not, label %B1662, label %B1596.if
B2364.if:
  %.13009.04646 = phi i64 [ 0, %B2364.preheader ], [ %.13078, %B2364.if ]
  %.13078 = add nuw nsw i64 %.13009.04646, 1
  %.13155 = getelementptr double, ptr %.1687.fca.2.0.4.load, i64 %.13009.04646
  %.13156 = load double, ptr %.13155, align 8
  %.13209 = getelementptr double, ptr %21, i64 %.13009.04646
  %.13210 = load double, ptr %.13209, align 8
  %.13263 = getelementptr double, ptr %22, i64 %.13009.04646
  %.13264 = load double, ptr %.13263, align 8
  %.13312 = mul i64 %.13009.04646, %.392.i45664620.ph
  %gep4649 = getelementptr double, ptr %invariant.gep4648, i64 %.13312
  store double %.13156, ptr %gep4649, align 8
  %.13321 = add nuw nsw i64 %.13009.04646, %.2807
  %.13369 = mul i64 %.13321, %.392.i45664620.ph
  %gep4651 = getelementptr double, ptr %invariant.gep4648, i64 %.13369
  store double %.13210, ptr %gep4651, align 8
  %gep4653 = getelementptr double, ptr %invariant.gep4652, i64 %.13312
  store double %.13264, ptr %gep4653, align 8
  %exitcond4668.not = icmp eq i64 %.13078, %.2807
  br i1 %exitcond4668.not, label %B2468, label %B2364.if
B2468.endif.else.if:
  br label %B2468.endif.else.endif
B2468.endif.else.endif:
  %.14542.sroa.0.1 = phi i64 [ 0, %B2468.endif.else.if ], [ %.14554, %B2468 ]
  %.14562.not = icmp slt i64 %.14554, %.14127
  br i1 %.14562.not, label %B2468.endif.else.endif.endif.endif.if, label %B2468.endif.else.endif.if, !prof !109
B2468.endif.else.endif.if:
  br label %B2468.endif.else.endif.endif.endif.if
B2468.endif.else.endif.endif.endif.if:
  %.14542.sroa.0.3 = phi i64 [ %.14127, %B2468.endif.else.endif.if ], [ %.14542.sroa.0.1, %B2468.endif.else.endif ]
  %.14630 = sub i64 %.14127, %.14542.sroa.0.3
  %.14639 = tail call i64 @llvm.smax.i64(i64 %.14630, i64 0)
  %.14655 = getelementptr double, ptr %.50.i4588, i64 %.14542.sroa.0.3
  %.392.i4596 = load i64, ptr %arg.f.4, align 8, !noalias !156
  %.151504654.not = icmp slt i64 %.2460, 1
  br i1 %.151504654.not, label %B2800.else, label %B2702.if.lr.ph
B2702.if.lr.ph:
  %34 = getelementptr i8, ptr %arg.f.4, i64 592
  %.45.i4594 = load i64, ptr %34, align 8, !noalias !156
  %.46.i4595 = inttoptr i64 %.45.i4594 to ptr
  %.15284 = select i1 %.99, i64 %.392.i4596, i64 0
  %35 = getelementptr double, ptr %.46.i4595, i64 %.15284
  %invariant.gep4657 = getelementptr double, ptr %35, i64 %arg.i
  %.15368 = shl nuw nsw i64 %.2460, 1
  br label %B2702.if
B2702.if:
  %.15094.04655 = phi i64 [ 0, %B2702.if.lr.ph ], [ %.15163, %B2702.if ]
  %.15163 = add nuw nsw i64 %.15094.04655, 1
  %36 = getelementptr double, ptr %.1687.fca.6.4.load, i64 %.15094.04655
  %.15221 = load double, ptr %36, align 8
  %37 = getelementptr double, ptr %.14655, i64 %.15094.04655
  store double %.15221, ptr %37, align 8
  %.15302 = mul i64 %.15094.04655, %.392.i4596
  %gep = getelementptr double, ptr %invariant.gep4657, i64 %.15302
  store double %.15221, ptr %gep, align 8
  %.15311 = add nuw nsw i64 %.15094.04655, %.2460
  %.15359 = mul i64 %.15311, %.392.i4596
  %gep4659 = getelementptr double, ptr %invariant.gep4657, i64 %.15359
  store double %.15221, ptr %gep4659, align 8
  %.15369 = add nuw nsw i64 %.15094.04655, %.15368
  %.15417 = mul i64 %.15369, %.392.i4596
  %gep4661 = getelementptr double, ptr %invariant.gep4657, i64 %.15417
  store double 0.000000e+00, ptr %gep4661, align 8
  %exitcond4669.not = icmp eq i64 %.15163, %.2460
  br i1 %exitcond4669.not, label %B2800.else, label %B2702.if
B2800.else:
  %.15441 = mul nsw i64 %.2460, 5
  %.15480 = icmp slt i64 %.2460, 0
  %.15481 = select i1 %.15480, i64 %.14639, i64 0
  %.15482 = add i64 %.15481, %.15441
  %.15485 = icmp slt i64 %.15482, 0
  br i1 %.15485, label %B2800.else.if, label %B2800.else.endif, !prof !84
B2800.else.if:
  br label %B2800.else.endif
B2800.else.endif:
  %.15470.sroa.0.1 = phi i64 [ 0, %B2800.else.if ], [ %.15482, %B2800.else ]
  %.15490.not = icmp slt i64 %.15482, %.14639
  br i1 %.15490.not, label %B2800.else.endif.endif.endif.if, label %B2800.else.endif.if, !prof !109
B2800.else.endif.if:
  br label %B2800.else.endif.endif.endif.if
B2800.else.endif.endif.endif.if:
  %.15470.sroa.0.3 = phi i64 [ %.14639, %B2800.else.endif.if ], [ %.15470.sroa.0.1, %B2800.else.endif ]
  %.15583 = getelementptr double, ptr %.14655, i64 %.15470.sroa.0.3
  %.816.i = getelementptr i8, ptr %arg.f.4, i64 184
  %.817.i = load i64, ptr %.816.i, align 8, !noalias !159
  %.818.i = icmp sgt i64 %.817.i, 0
  br i1 %.818.i, label %B48.i, label %B2896.if.preheader
B48.i:
  %.10201676.not.i = icmp slt i64 %.1687.fca.5.0.2.load, 1
  br i1 %.10201676.not.i, label %B144.i4606, label %B108.if.i.preheader
B108.if.i.preheader:
  %38 = shl nuw i64 %.1687.fca.5.0.2.load, 3
  tail call void @llvm.memset.p0.i64(ptr align 8 %.1687.fca.5.0.4.load, i8 0, i64 %38, i1 false), !noalias !159
  br label %B144.i4606
B144.i4606:
  store double 0.000000e+00, ptr %.1687.fca.5.3.4.load, align 8, !noalias !159
  %.1692.i = getelementptr i8, ptr %arg.f.4, i64 104
  %.1693.i = load i64, ptr %.1692.i, align 8, !noalias !159
  %.2109.i = inttoptr i64 %.1693.i to ptr
  tail call void %.2109.i(ptr nonnull %.1687.fca.5.3.4.load, ptr %.1687.fca.6.4.load, ptr %.1687.fca.5.0.4.load, ptr %.1687.fca.1.0.4.load, ptr %.15583), !noalias !159
  br label %B2896.if.preheader
B2896.if.preheader:
  br label %B2896.if
B2896.if:
  %.15768.04662 = phi i64 [ %.15837, %B2896.if ], [ 0, %B2896.if.preheader ]
  %.15837 = add nuw nsw i64 %.15768.04662, 1
  %39 = getelementptr i64, ptr %.1687.fca.9.4.load, i64 %.15768.04662
  store i64 0, ptr %39, align 8
  %exitcond4670.not = icmp eq i64 %.15837, 5
  br i1 %exitcond4670.not, label %B2922, label %B2896.if
}
define internal fastcc void @v77(ptr noalias nonnull writeonly initializes((0, 1808)) %retptr, ptr readonly %arg.f.4, i64 %arg.i) unnamed_addr {
entry:
  %.361 = getelementptr i8, ptr %arg.f.4, i64 128
  %.362 = load i64, ptr %.361, align 8
  %.707 = getelementptr i8, ptr %arg.f.4, i64 136
  %.708 = load i64, ptr %.707, align 8
  %.1053 = getelementptr i8, ptr %arg.f.4, i64 144
  %.1054 = load i64, ptr %.1053, align 8
  %.1399 = getelementptr i8, ptr %arg.f.4, i64 168
  %.1400 = load i64, ptr %.1399, align 8
  %.1745 = getelementptr i8, ptr %arg.f.4, i64 152
  %.1746 = load i64, ptr %.1745, align 8
  %.360.i = getelementptr i8, ptr %arg.f.4, i64 608
  %.361.i = load i64, ptr %.360.i, align 8, !noalias !162
  %.362.i = inttoptr i64 %.361.i to ptr
  %.708.i = load i64, ptr %arg.f.4, align 8, !noalias !162
  %.1849 = icmp slt i64 %arg.i, 0
  %.1850 = select i1 %.1849, i64 %.708.i, i64 0
  %0 = getelementptr i64, ptr %.362.i, i64 %arg.i
  %.1872 = getelementptr i64, ptr %0, i64 %.1850
  %.1873 = load i64, ptr %.1872, align 8
  %.2223 = getelementptr i8, ptr %arg.f.4, i64 624
  %.2224 = load i64, ptr %.2223, align 8
  %.361.i1658 = getelementptr i8, ptr %arg.f.4, i64 160
  %.362.i1659 = load i64, ptr %.361.i1658, align 8, !noalias !165
  %.709.i = add nsw i64 %.362.i1659, %.1400
  %.1054.i = getelementptr i8, ptr %arg.f.4, i64 616
  %.1055.i = load i64, ptr %.1054.i, align 8, !noalias !165
  %.2264 = mul nsw i64 %.362, 6
  %.2265 = shl nsw i64 %.1054, 1
  %.2266 = add nsw i64 %.2265, %.2264
  %.2751 = getelementptr i8, ptr %arg.f.4, i64 176
  %.2752 = load i64, ptr %.2751, align 8
  %.2894 = icmp slt i64 %.2266, 1
  br i1 %.2894, label %B0.endif.endif.endif.endi...endif.endif.if, label %B0.endif.endif.endif.endif.endif.endif.endif.endif, !prof !84
B0.endif.endif.endif.endif.endif.endif.endif.endif:
  %.2874.sroa.0.31750 = phi i64 [ %.2266, %B0.endif.endif.endif.endi...endif.endif.if ], [ 0, %entry ]
  %.45.i = getelementptr i8, ptr %arg.f.4, i64 352
  %.46.i = load i64, ptr %.45.i, align 8, !noalias !168
  %.50.i = inttoptr i64 %.46.i to ptr
  %.3718 = getelementptr i8, ptr %arg.f.4, i64 248
  %.3719 = load i64, ptr %.3718, align 8
  %.3734 = add nsw i64 %.1054, %.2264
  %.3770 = icmp slt i64 %.362, 0
  %.3771 = select i1 %.3770, i64 %.2266, i64 0
  %.3772 = add i64 %.3771, %.2264
  %.3775 = icmp slt i64 %.3772, 0
  br i1 %.3775, label %B0.endif.endif.endif.endi...else.if, label %B0.endif.endif.endif.endi...else.endif, !prof !84
B0.endif.endif.endif.endi...endif.endif.if:
  br label %B0.endif.endif.endif.endif.endif.endif.endif.endif
B0.endif.endif.endif.endi...endif.3:
  %.3760.sroa.13.0 = phi i64 [ %.2266, %B0.endif.endif.endif.endi...else.endif.endif.endif.if ], [ %.3760.sroa.13.1, %B0.endif.endif.endif.endi...else.endif.endif.endif ]
  br i1 %.3792, label %B0.endif.endif.endif.endi...endif.3.else.if, label %B0.endif.endif.endif.endi...endif.3.else.endif, !prof !84
B0.endif.endif.endif.endi...else.if:
  br label %B0.endif.endif.endif.endi...else.endif
B0.endif.endif.endif.endi...else.endif:
  %.3760.sroa.0.1 = phi i64 [ 0, %B0.endif.endif.endif.endi...else.if ], [ %.3772, %B0.endif.endif.endif.endif.endif.endif.endif.endif ]
  %.3780.not = icmp slt i64 %.3772, %.2266
  br i1 %.3780.not, label %B0.endif.endif.endif.endi...else.endif.endif, label %B0.endif.endif.endif.endi...else.endif.if, !prof !109
B0.endif.endif.endif.endi...else.endif.if:
  br label %B0.endif.endif.endif.endi...else.endif.endif
B0.endif.endif.endif.endi...else.endif.endif:
  %.3760.sroa.0.3 = phi i64 [ %.2266, %B0.endif.endif.endif.endi...else.endif.if ], [ %.3760.sroa.0.1, %B0.endif.endif.endif.endi...else.endif ]
  %.3787 = icmp slt i64 %.3734, 0
  %.3788 = select i1 %.3787, i64 %.2266, i64 0
  %.3789 = add i64 %.3788, %.3734
  %.3792 = icmp slt i64 %.3789, 0
  br i1 %.3792, label %B0.endif.endif.endif.endi...else.endif.endif.if, label %B0.endif.endif.endif.endi...else.endif.endif.endif, !prof !84
B0.endif.endif.endif.endi...else.endif.endif.if:
  br label %B0.endif.endif.endif.endi...else.endif.endif.endif
B0.endif.endif.endif.endi...else.endif.endif.endif:
  %.3760.sroa.13.1 = phi i64 [ 0, %B0.endif.endif.endif.endi...else.endif.endif.if ], [ %.3789, %B0.endif.endif.endif.endi...else.endif.endif ]
  %.3797.not = icmp slt i64 %.3789, %.2266
  br i1 %.3797.not, label %B0.endif.endif.endif.endi...endif.3, label %B0.endif.endif.endif.endi...else.endif.endif.endif.if, !prof !109
B0.endif.endif.endif.endi...else.endif.endif.endif.if:
  br label %B0.endif.endif.endif.endi...endif.3
B0.endif.endif.endif.endi...endif.3.else.if:
  br label %B0.endif.endif.endif.endi...endif.3.else.endif
B0.endif.endif.endif.endi...endif.3.else.endif:
  %.3932.sroa.0.1 = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.3.else.if ], [ %.3789, %B0.endif.endif.endif.endi...endif.3 ]
  br i1 %.3797.not, label %B0.endif.endif.endif.endi...endif.4.if, label %B0.endif.endif.endif.endi...endif.3.else.endif.if, !prof !109
B0.endif.endif.endif.endi...endif.3.else.endif.if:
  br label %B0.endif.endif.endif.endi...endif.4.if
B0.endif.endif.endif.endi...endif.4.if:
  %.3932.sroa.0.3 = phi i64 [ %.2266, %B0.endif.endif.endif.endi...endif.3.else.endif.if ], [ %.3932.sroa.0.1, %B0.endif.endif.endif.endi...endif.3.else.endif ]
  br i1 %.2894, label %B0.endif.endif.endif.endi...if.6, label %B0.endif.endif.endif.endi...endif.6, !prof !84
B0.endif.endif.endif.endi...endif.3.endif.endif:
  %.4102.sroa.13.0 = phi i64 [ %.2266, %B0.endif.endif.endif.endi...endif.6.endif.if ], [ %.4102.sroa.13.1, %B0.endif.endif.endif.endi...endif.6.endif ]
  %.4247 = shl nsw i64 %.362, 1
  br i1 %.4134, label %B0.endif.endif.endif.endi...if.8, label %B0.endif.endif.endif.endi...endif.8, !prof !84
B0.endif.endif.endif.endi...if.6:
  br label %B0.endif.endif.endif.endi...endif.6
B0.endif.endif.endif.endi...endif.6:
  %.4102.sroa.0.3 = phi i64 [ %.2266, %B0.endif.endif.endif.endi...if.6 ], [ 0, %B0.endif.endif.endif.endi...endif.4.if ]
  %.4131 = add i64 %.3771, %.362
  %.4134 = icmp slt i64 %.4131, 0
  br i1 %.4134, label %B0.endif.endif.endif.endi...endif.6.if, label %B0.endif.endif.endif.endi...endif.6.endif, !prof !84
B0.endif.endif.endif.endi...endif.6.if:
  br label %B0.endif.endif.endif.endi...endif.6.endif
B0.endif.endif.endif.endi...endif.6.endif:
  %.4102.sroa.13.1 = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.6.if ], [ %.4131, %B0.endif.endif.endif.endi...endif.6 ]
  %.4139.not = icmp slt i64 %.4131, %.2266
  br i1 %.4139.not, label %B0.endif.endif.endif.endi...endif.3.endif.endif, label %B0.endif.endif.endif.endi...endif.6.endif.if, !prof !109
B0.endif.endif.endif.endi...endif.6.endif.if:
  br label %B0.endif.endif.endif.endi...endif.3.endif.endif
B0.endif.endif.endif.endi...endif.3.endif.endif.endif:
  %.4273.sroa.13.0 = phi i64 [ %.2266, %B0.endif.endif.endif.endi...endif.8.endif.endif.if ], [ %.4273.sroa.13.1, %B0.endif.endif.endif.endi...endif.8.endif.endif ]
  %.4419 = shl nsw i64 %.362, 2
  br i1 %.4305, label %B0.endif.endif.endif.endi...else.1.if, label %B0.endif.endif.endif.endi...else.1.endif, !prof !84
B0.endif.endif.endif.endi...if.8:
  br label %B0.endif.endif.endif.endi...endif.8
B0.endif.endif.endif.endi...endif.8:
  %.4273.sroa.0.1 = phi i64 [ 0, %B0.endif.endif.endif.endi...if.8 ], [ %.4131, %B0.endif.endif.endif.endi...endif.3.endif.endif ]
  br i1 %.4139.not, label %B0.endif.endif.endif.endi...endif.8.endif, label %B0.endif.endif.endif.endi...endif.8.if, !prof !109
B0.endif.endif.endif.endi...endif.8.if:
  br label %B0.endif.endif.endif.endi...endif.8.endif
B0.endif.endif.endif.endi...endif.8.endif:
  %.4273.sroa.0.3 = phi i64 [ %.2266, %B0.endif.endif.endif.endi...endif.8.if ], [ %.4273.sroa.0.1, %B0.endif.endif.endif.endi...endif.8 ]
  %.4302 = add i64 %.3771, %.4247
  %.4305 = icmp slt i64 %.4302, 0
  br i1 %.4305, label %B0.endif.endif.endif.endi...endif.8.endif.if, label %B0.endif.endif.endif.endi...endif.8.endif.endif, !prof !84
B0.endif.endif.endif.endi...endif.8.endif.if:
  br label %B0.endif.endif.endif.endi...endif.8.endif.endif
B0.endif.endif.endif.endi...endif.8.endif.endif:
  %.4273.sroa.13.1 = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.8.endif.if ], [ %.4302, %B0.endif.endif.endif.endi...endif.8.endif ]
  %.4310.not = icmp slt i64 %.4302, %.2266
  br i1 %.4310.not, label %B0.endif.endif.endif.endi...endif.3.endif.endif.endif, label %B0.endif.endif.endif.endi...endif.8.endif.endif.if, !prof !109
B0.endif.endif.endif.endi...endif.8.endif.endif.if:
  br label %B0.endif.endif.endif.endi...endif.3.endif.endif.endif
B0.endif.endif.endif.endi...endif.10:
  %.4445.sroa.13.0 = phi i64 [ %.2266, %B0.endif.endif.endif.endi...if.11 ], [ %.4445.sroa.13.1, %B0.endif.endif.endif.endi...else.1.endif.endif.endif ]
  %.4591 = mul nsw i64 %.362, 5
  br i1 %.4477, label %B0.endif.endif.endif.endi...endif.10.else.if, label %B0.endif.endif.endif.endi...endif.10.else.endif, !prof !84
B0.endif.endif.endif.endi...else.1.if:
  br label %B0.endif.endif.endif.endi...else.1.endif
B0.endif.endif.endif.endi...else.1.endif:
  %.4445.sroa.0.1 = phi i64 [ 0, %B0.endif.endif.endif.endi...else.1.if ], [ %.4302, %B0.endif.endif.endif.endi...endif.3.endif.endif.endif ]
  br i1 %.4310.not, label %B0.endif.endif.endif.endi...else.1.endif.endif, label %B0.endif.endif.endif.endi...else.1.endif.if, !prof !109
B0.endif.endif.endif.endi...else.1.endif.if:
  br label %B0.endif.endif.endif.endi...else.1.endif.endif
B0.endif.endif.endif.endi...else.1.endif.endif:
  %.4445.sroa.0.3 = phi i64 [ %.2266, %B0.endif.endif.endif.endi...else.1.endif.if ], [ %.4445.sroa.0.1, %B0.endif.endif.endif.endi...else.1.endif ]
  %.4474 = add i64 %.3771, %.4419
  %.4477 = icmp slt i64 %.4474, 0
  br i1 %.4477, label %B0.endif.endif.endif.endi...else.1.endif.endif.if, label %B0.endif.endif.endif.endi...else.1.endif.endif.endif, !prof !84
B0.endif.endif.endif.endi...else.1.endif.endif.if:
  br label %B0.endif.endif.endif.endi...else.1.endif.endif.endif
B0.endif.endif.endif.endi...else.1.endif.endif.endif:
  %.4445.sroa.13.1 = phi i64 [ 0, %B0.endif.endif.endif.endi...else.1.endif.endif.if ], [ %.4474, %B0.endif.endif.endif.endi...else.1.endif.endif ]
  %.4482.not = icmp slt i64 %.4474, %.2266
  br i1 %.4482.not, label %B0.endif.endif.endif.endi...endif.10, label %B0.endif.endif.endif.endi...if.11, !prof !109
B0.endif.endif.endif.endi...if.11:
  br label %B0.endif.endif.endif.endi...endif.10
B0.endif.endif.endif.endi...endif.10.endif:
  %.4617.sroa.13.0 = phi i64 [ %.2266, %B0.endif.endif.endif.endi...endif.13.if ], [ %.4617.sroa.13.1, %B0.endif.endif.endif.endi...endif.13 ]
  %.5192 = getelementptr i8, ptr %arg.f.4, i64 112
  %.5193 = load i64, ptr %.5192, align 8
  %.5538 = getelementptr i8, ptr %arg.f.4, i64 120
  %.5539 = load i64, ptr %.5538, align 8
  %.5931 = icmp slt i64 %.362.i1659, 0
  %.5932 = select i1 %.5931, i64 %.709.i, i64 0
  %.5933 = add i64 %.5932, %.362.i1659
  %.5936 = icmp slt i64 %.5933, 0
  br i1 %.5936, label %B0.endif.endif.endif.endi...endif.10.endif.else.if, label %B0.endif.endif.endif.endi...endif.10.endif.else.endif, !prof !84
B0.endif.endif.endif.endi...endif.10.else.if:
  br label %B0.endif.endif.endif.endi...endif.10.else.endif
B0.endif.endif.endif.endi...endif.10.else.endif:
  %.4617.sroa.0.1 = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.10.else.if ], [ %.4474, %B0.endif.endif.endif.endi...endif.10 ]
  br i1 %.4482.not, label %B0.endif.endif.endif.endi...endif.10.else.endif.endif, label %B0.endif.endif.endif.endi...endif.10.else.endif.if, !prof !109
B0.endif.endif.endif.endi...endif.10.else.endif.if:
  br label %B0.endif.endif.endif.endi...endif.10.else.endif.endif
B0.endif.endif.endif.endi...endif.10.else.endif.endif:
  %.4617.sroa.0.3 = phi i64 [ %.2266, %B0.endif.endif.endif.endi...endif.10.else.endif.if ], [ %.4617.sroa.0.1, %B0.endif.endif.endif.endi...endif.10.else.endif ]
  %.4646 = add i64 %.3771, %.4591
  %.4649 = icmp slt i64 %.4646, 0
  br i1 %.4649, label %B0.endif.endif.endif.endi...if.13, label %B0.endif.endif.endif.endi...endif.13, !prof !84
B0.endif.endif.endif.endi...if.13:
  br label %B0.endif.endif.endif.endi...endif.13
B0.endif.endif.endif.endi...endif.13:
  %.4617.sroa.13.1 = phi i64 [ 0, %B0.endif.endif.endif.endi...if.13 ], [ %.4646, %B0.endif.endif.endif.endi...endif.10.else.endif.endif ]
  %.4654.not = icmp slt i64 %.4646, %.2266
  br i1 %.4654.not, label %B0.endif.endif.endif.endi...endif.10.endif, label %B0.endif.endif.endif.endi...endif.13.if, !prof !109
B0.endif.endif.endif.endi...endif.13.if:
  br label %B0.endif.endif.endif.endi...endif.10.endif
B0.endif.endif.endif.endi...endif.10.endif.else.if:
  br label %B0.endif.endif.endif.endi...endif.10.endif.else.endif
B0.endif.endif.endif.endi...endif.10.endif.else.endif:
  %.5921.sroa.0.1 = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.10.endif.else.if ], [ %.5933, %B0.endif.endif.endif.endi...endif.10.endif ]
  %.5941.not = icmp slt i64 %.5933, %.709.i
  br i1 %.5941.not, label %B0.endif.endif.endif.endi...endif.15.endif.if, label %B0.endif.endif.endif.endi...if.15, !prof !109
B0.endif.endif.endif.endi...if.15:
  br label %B0.endif.endif.endif.endi...endif.15.endif.if
B0.endif.endif.endif.endi...endif.15.endif.if:
  %.5921.sroa.0.3 = phi i64 [ %.709.i, %B0.endif.endif.endif.endi...if.15 ], [ %.5921.sroa.0.1, %B0.endif.endif.endif.endi...endif.10.endif.else.endif ]
  %.6410 = getelementptr i8, ptr %arg.f.4, i64 216
  %.6411 = load i64, ptr %.6410, align 8
  %.6879 = getelementptr i8, ptr %arg.f.4, i64 208
  %.6880 = load i64, ptr %.6879, align 8
  %.6949 = load double, ptr %.50.i, align 8
  %.6977 = getelementptr i8, ptr %.50.i, i64 8
  %.6978 = load double, ptr %.6977, align 8
  %.7669 = getelementptr i8, ptr %arg.f.4, i64 240
  %.7670 = load i64, ptr %.7669, align 8
  %.45.i1695 = getelementptr i8, ptr %arg.f.4, i64 344
  %.46.i1696 = load i64, ptr %.45.i1695, align 8, !noalias !171
  %.361.i1703 = getelementptr i8, ptr %arg.f.4, i64 440
  %.362.i1704 = load i64, ptr %.361.i1703, align 8, !noalias !174
  %.707.i1705 = getelementptr i8, ptr %arg.f.4, i64 432
  %.708.i1706 = load i64, ptr %.707.i1705, align 8, !noalias !174
  %.8498 = getelementptr i8, ptr %arg.f.4, i64 360
  %.8499 = load i64, ptr %.8498, align 8
  %.8892 = getelementptr i8, ptr %arg.f.4, i64 368
  %.8893 = load i64, ptr %.8892, align 8
  br i1 %.4649, label %B0.endif.endif.endif.endi...if.21, label %B0.endif.endif.endif.endi...endif.21, !prof !84
B0.endif.endif.endif.endi...endif.20.endif.endif.endif:
  %.8991.sroa.13.0 = phi i64 [ %.2266, %B0.endif.endif.endif.endi...endif.21.endif.endif.if ], [ %.8991.sroa.13.1, %B0.endif.endif.endif.endi...endif.21.endif.endif ]
  %.25.i1726 = mul nsw i64 %.3719, 3
  %.8894 = inttoptr i64 %.8893 to ptr
  %.25.i1718 = shl nsw i64 %.3719, 1
  %.8500 = inttoptr i64 %.8499 to ptr
  %.25.i1710 = mul nsw i64 %.7670, %.1746
  %.16.i1709 = shl i64 %.7670, 3
  %.709.i1707 = sub nsw i64 %.1873, %.708.i1706
  %.710.i = shl i64 %.1746, 3
  %.1057.i = mul i64 %.710.i, %.7670
  %.1407.i = mul i64 %.1057.i, %.709.i1707
  %.1408.i = add nsw i64 %.1407.i, %.362.i1704
  %.7735 = inttoptr i64 %.1408.i to ptr
  %.50.i1697 = inttoptr i64 %.46.i1696 to ptr
  %inserted.nitems.11 = insertvalue { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } { ptr null, ptr null, i64 undef, i64 undef, ptr undef, [1 x i64] undef, [1 x i64] undef }, i64 %.708, 2
  %inserted.itemsize.11 = insertvalue { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } %inserted.nitems.11, i64 1, 3
  %.6881 = inttoptr i64 %.6880 to ptr
  %inserted.data.11 = insertvalue { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } %inserted.itemsize.11, ptr %.6881, 4
  %.6908 = insertvalue [1 x i64] undef, i64 %.708, 0
  %inserted.shape.11 = insertvalue { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } %inserted.data.11, [1 x i64] %.6908, 5
  %inserted.strides.11 = insertvalue { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } %inserted.shape.11, [1 x i64] [i64 1], 6
  %.25.i = mul nsw i64 %.708, 3
  %inserted.nitems.10 = insertvalue { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] } { ptr null, ptr null, i64 undef, i64 undef, ptr undef, [2 x i64] undef, [2 x i64] undef }, i64 %.25.i, 2
  %inserted.itemsize.10 = insertvalue { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] } %inserted.nitems.10, i64 8, 3
  %.2312 = shl nsw i64 %.2266, 3
  %.2313 = add nsw i64 %.2224, %.2312
  %.2404 = add i64 %.2313, 16
  %.2405 = add i64 %.2404, %.710.i
  %.2846 = add nsw i64 %.2752, %.1400
  %1 = add i64 %.1746, %.2846
  %2 = shl i64 %1, 3
  %.2848 = add i64 %2, %.2404
  %.6487 = inttoptr i64 %.2848 to ptr
  %inserted.data.10 = insertvalue { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] } %inserted.itemsize.10, ptr %.6487, 4
  %.6521 = insertvalue [2 x i64] [i64 3, i64 undef], i64 %.708, 1
  %inserted.shape.10 = insertvalue { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] } %inserted.data.10, [2 x i64] %.6521, 5
  %.16.i = shl i64 %.708, 3
  %.6523 = insertvalue [2 x i64] undef, i64 %.16.i, 0
  %.6525 = insertvalue [2 x i64] %.6523, i64 8, 1
  %inserted.strides.10 = insertvalue { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] } %inserted.shape.10, [2 x i64] %.6525, 6
  %.6412 = inttoptr i64 %.6411 to ptr
  %.1059.i = shl nsw i64 %arg.i, 3
  %.1060.i = mul nsw i64 %.1059.i, %.709.i
  %.1061.i = add nsw i64 %.1060.i, %.1055.i
  %.1062.i = inttoptr i64 %.1061.i to ptr
  %.6034 = getelementptr double, ptr %.1062.i, i64 %.5921.sroa.0.3
  %.6009 = sub i64 %.709.i, %.5921.sroa.0.3
  %.6018 = tail call i64 @llvm.smax.i64(i64 %.6009, i64 0)
  %.2263 = inttoptr i64 %.2224 to ptr
  %.4730 = getelementptr double, ptr %.2263, i64 %.4617.sroa.0.3
  %.4705 = sub i64 %.4617.sroa.13.0, %.4617.sroa.0.3
  %.4714 = tail call i64 @llvm.smax.i64(i64 %.4705, i64 0)
  %.4558 = getelementptr double, ptr %.2263, i64 %.4445.sroa.0.3
  %.4533 = sub i64 %.4445.sroa.13.0, %.4445.sroa.0.3
  %.4542 = tail call i64 @llvm.smax.i64(i64 %.4533, i64 0)
  %.4386 = getelementptr double, ptr %.2263, i64 %.4273.sroa.0.3
  %.4361 = sub i64 %.4273.sroa.13.0, %.4273.sroa.0.3
  %.4370 = tail call i64 @llvm.smax.i64(i64 %.4361, i64 0)
  %.4215 = getelementptr double, ptr %.2263, i64 %.4102.sroa.0.3
  %.4190 = sub i64 %.4102.sroa.13.0, %.4102.sroa.0.3
  %.4199 = tail call i64 @llvm.smax.i64(i64 %.4190, i64 0)
  %.4045 = getelementptr double, ptr %.2263, i64 %.3932.sroa.0.3
  %.4020 = sub i64 %.2266, %.3932.sroa.0.3
  %.4029 = tail call i64 @llvm.smax.i64(i64 %.4020, i64 0)
  %.3873 = getelementptr double, ptr %.2263, i64 %.3760.sroa.0.3
  %.3848 = sub i64 %.3760.sroa.13.0, %.3760.sroa.0.3
  %.3857 = tail call i64 @llvm.smax.i64(i64 %.3848, i64 0)
  %.2987 = getelementptr double, ptr %.2263, i64 %.2874.sroa.0.31750
  %3 = add i64 %.1746, %.2752
  %4 = shl i64 %3, 3
  %.2799 = add i64 %4, %.2404
  %.2800 = inttoptr i64 %.2799 to ptr
  %.2406 = inttoptr i64 %.2405 to ptr
  %.2357 = inttoptr i64 %.2404 to ptr
  %.2314 = inttoptr i64 %.2313 to ptr
  %.9079 = sub i64 %.8991.sroa.13.0, %.8991.sroa.0.3
  %.9088 = tail call i64 @llvm.smax.i64(i64 %.9079, i64 0)
  %.9104 = getelementptr double, ptr %.2263, i64 %.8991.sroa.0.3
  %.45.i1734 = getelementptr i8, ptr %arg.f.4, i64 400
  %.46.i1735 = load i64, ptr %.45.i1734, align 8, !noalias !177
  %.50.i1736 = inttoptr i64 %.46.i1735 to ptr
  %.361.i1742 = getelementptr i8, ptr %arg.f.4, i64 392
  %.362.i1743 = load i64, ptr %.361.i1742, align 8, !noalias !180
  %.366.i = mul nsw i64 %.1873, 48
  %.367.i = add nsw i64 %.362.i1743, %.366.i
  %.368.i = inttoptr i64 %.367.i to ptr
  %.10113 = insertvalue { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } { ptr null, ptr null, i64 0, i64 8, ptr undef, [1 x i64] undef, [1 x i64] undef }, ptr %.2987, 4
  %.10114 = insertvalue { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } %.10113, [1 x i64] zeroinitializer, 5
  %.10115 = insertvalue { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } %.10114, [1 x i64] [i64 8], 6
  %.10117 = insertvalue { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, double, double, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, i8 } undef, { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] } %inserted.strides.10, 0
  %.10118 = insertvalue { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, double, double, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, i8 } %.10117, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } %inserted.strides.11, 1
  %.10119 = insertvalue { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, double, double, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, i8 } %.10118, double %.6949, 2
  %.10120 = insertvalue { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, double, double, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, i8 } %.10119, double %.6978, 3
  %.10121 = insertvalue { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, double, double, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, i8 } %.10120, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } %.10115, 4
  %.10122 = insertvalue { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, double, double, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, i8 } %.10121, i8 0, 5
  %retptr.repack1280 = getelementptr inbounds i8, ptr %retptr, i64 24
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %retptr, i8 0, i64 24, i1 false)
  store i64 %.5193, ptr %retptr.repack1280, align 8
  %retptr.repack1282 = getelementptr inbounds i8, ptr %retptr, i64 32
  store i64 %.5539, ptr %retptr.repack1282, align 8
  %retptr.repack1258 = getelementptr inbounds i8, ptr %retptr, i64 40
  %retptr.repack1258.repack1294 = getelementptr inbounds i8, ptr %retptr, i64 56
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %retptr.repack1258, i8 0, i64 16, i1 false)
  store i64 %.709.i, ptr %retptr.repack1258.repack1294, align 8
  %retptr.repack1258.repack1296 = getelementptr inbounds i8, ptr %retptr, i64 64
  store i64 8, ptr %retptr.repack1258.repack1296, align 8
  %retptr.repack1258.repack1298 = getelementptr inbounds i8, ptr %retptr, i64 72
  store ptr %.1062.i, ptr %retptr.repack1258.repack1298, align 8
  %retptr.repack1258.repack1300 = getelementptr inbounds i8, ptr %retptr, i64 80
  store i64 %.709.i, ptr %retptr.repack1258.repack1300, align 8
  %retptr.repack1258.repack1302 = getelementptr inbounds i8, ptr %retptr, i64 88
  store i64 8, ptr %retptr.repack1258.repack1302, align 8
  %retptr.repack1258.repack1284 = getelementptr inbounds i8, ptr %retptr, i64 96
  %retptr.repack1258.repack1284.repack1306 = getelementptr inbounds i8, ptr %retptr, i64 112
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %retptr.repack1258.repack1284, i8 0, i64 16, i1 false)
  store i64 %.6018, ptr %retptr.repack1258.repack1284.repack1306, align 8
  %retptr.repack1258.repack1284.repack1308 = getelementptr inbounds i8, ptr %retptr, i64 120
  store i64 8, ptr %retptr.repack1258.repack1284.repack1308, align 8
  %retptr.repack1258.repack1284.repack1310 = getelementptr inbounds i8, ptr %retptr, i64 128
  store ptr %.6034, ptr %retptr.repack1258.repack1284.repack1310, align 8
  %retptr.repack1258.repack1284.repack1312 = getelementptr inbounds i8, ptr %retptr, i64 136
  store i64 %.6018, ptr %retptr.repack1258.repack1284.repack1312, align 8
  %retptr.repack1258.repack1284.repack1314 = getelementptr inbounds i8, ptr %retptr, i64 144
  store i64 8, ptr %retptr.repack1258.repack1284.repack1314, align 8
  %retptr.repack1258.repack1286 = getelementptr inbounds i8, ptr %retptr, i64 152
  %retptr.repack1258.repack1286.repack1318 = getelementptr inbounds i8, ptr %retptr, i64 168
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %retptr.repack1258.repack1286, i8 0, i64 16, i1 false)
  store i64 %.1400, ptr %retptr.repack1258.repack1286.repack1318, align 8
  %retptr.repack1258.repack1286.repack1320 = getelementptr inbounds i8, ptr %retptr, i64 176
  store i64 1, ptr %retptr.repack1258.repack1286.repack1320, align 8
  %retptr.repack1258.repack1286.repack1322 = getelementptr inbounds i8, ptr %retptr, i64 184
  store ptr %.6412, ptr %retptr.repack1258.repack1286.repack1322, align 8
  %retptr.repack1258.repack1286.repack1324 = getelementptr inbounds i8, ptr %retptr, i64 192
  store i64 %.1400, ptr %retptr.repack1258.repack1286.repack1324, align 8
  %retptr.repack1258.repack1286.repack1326 = getelementptr inbounds i8, ptr %retptr, i64 200
  store i64 1, ptr %retptr.repack1258.repack1286.repack1326, align 8
  %retptr.repack1258.repack1288 = getelementptr inbounds i8, ptr %retptr, i64 208
  %retptr.repack1258.repack1288.repack1330 = getelementptr inbounds i8, ptr %retptr, i64 224
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %retptr.repack1258.repack1288, i8 0, i64 16, i1 false)
  store i64 %.2752, ptr %retptr.repack1258.repack1288.repack1330, align 8
  %retptr.repack1258.repack1288.repack1332 = getelementptr inbounds i8, ptr %retptr, i64 232
  store i64 8, ptr %retptr.repack1258.repack1288.repack1332, align 8
  %retptr.repack1258.repack1288.repack1334 = getelementptr inbounds i8, ptr %retptr, i64 240
  store ptr %.2406, ptr %retptr.repack1258.repack1288.repack1334, align 8
  %retptr.repack1258.repack1288.repack1336 = getelementptr inbounds i8, ptr %retptr, i64 248
  store i64 %.2752, ptr %retptr.repack1258.repack1288.repack1336, align 8
  %retptr.repack1258.repack1288.repack1338 = getelementptr inbounds i8, ptr %retptr, i64 256
  store i64 8, ptr %retptr.repack1258.repack1288.repack1338, align 8
  %retptr.repack1258.repack1290 = getelementptr inbounds i8, ptr %retptr, i64 264
  %retptr.repack1258.repack1290.repack1342 = getelementptr inbounds i8, ptr %retptr, i64 280
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %retptr.repack1258.repack1290, i8 0, i64 16, i1 false)
  store i64 %.1400, ptr %retptr.repack1258.repack1290.repack1342, align 8
  %retptr.repack1258.repack1290.repack1344 = getelementptr inbounds i8, ptr %retptr, i64 288
  store i64 8, ptr %retptr.repack1258.repack1290.repack1344, align 8
  %retptr.repack1258.repack1290.repack1346 = getelementptr inbounds i8, ptr %retptr, i64 296
  store ptr %.2800, ptr %retptr.repack1258.repack1290.repack1346, align 8
  %retptr.repack1258.repack1290.repack1348 = getelementptr inbounds i8, ptr %retptr, i64 304
  store i64 %.1400, ptr %retptr.repack1258.repack1290.repack1348, align 8
  %retptr.repack1258.repack1290.repack1350 = getelementptr inbounds i8, ptr %retptr, i64 312
  store i64 8, ptr %retptr.repack1258.repack1290.repack1350, align 8
  %retptr.repack1260 = getelementptr inbounds i8, ptr %retptr, i64 320
  store { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, double, double, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, i8 } %.10122, ptr %retptr.repack1260, align 8
  %retptr.repack1262 = getelementptr inbounds i8, ptr %retptr, i64 528
  %retptr.repack1262.repack1358 = getelementptr inbounds i8, ptr %retptr, i64 544
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %retptr.repack1262, i8 0, i64 16, i1 false)
  store i64 %.7670, ptr %retptr.repack1262.repack1358, align 8
  %retptr.repack1262.repack1360 = getelementptr inbounds i8, ptr %retptr, i64 552
  store i64 8, ptr %retptr.repack1262.repack1360, align 8
  %retptr.repack1262.repack1362 = getelementptr inbounds i8, ptr %retptr, i64 560
  store ptr %.50.i1697, ptr %retptr.repack1262.repack1362, align 8
  %retptr.repack1262.repack1364 = getelementptr inbounds i8, ptr %retptr, i64 568
  store i64 %.7670, ptr %retptr.repack1262.repack1364, align 8
  %retptr.repack1262.repack1366 = getelementptr inbounds i8, ptr %retptr, i64 576
  store i64 8, ptr %retptr.repack1262.repack1366, align 8
  %retptr.repack1262.repack1352 = getelementptr inbounds i8, ptr %retptr, i64 584
  %retptr.repack1262.repack1352.repack1370 = getelementptr inbounds i8, ptr %retptr, i64 600
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %retptr.repack1262.repack1352, i8 0, i64 16, i1 false)
  store i64 %.25.i1710, ptr %retptr.repack1262.repack1352.repack1370, align 8
  %retptr.repack1262.repack1352.repack1372 = getelementptr inbounds i8, ptr %retptr, i64 608
  store i64 8, ptr %retptr.repack1262.repack1352.repack1372, align 8
  %retptr.repack1262.repack1352.repack1374 = getelementptr inbounds i8, ptr %retptr, i64 616
  store ptr %.7735, ptr %retptr.repack1262.repack1352.repack1374, align 8
  %retptr.repack1262.repack1352.repack1376 = getelementptr inbounds i8, ptr %retptr, i64 624
  store i64 %.1746, ptr %retptr.repack1262.repack1352.repack1376, align 8
  %retptr.repack1262.repack1352.repack1376.repack1380 = getelementptr inbounds i8, ptr %retptr, i64 632
  store i64 %.7670, ptr %retptr.repack1262.repack1352.repack1376.repack1380, align 8
  %retptr.repack1262.repack1352.repack1378 = getelementptr inbounds i8, ptr %retptr, i64 640
  store i64 %.16.i1709, ptr %retptr.repack1262.repack1352.repack1378, align 8
  %retptr.repack1262.repack1352.repack1378.repack1382 = getelementptr inbounds i8, ptr %retptr, i64 648
  store i64 8, ptr %retptr.repack1262.repack1352.repack1378.repack1382, align 8
  %retptr.repack1262.repack1354 = getelementptr inbounds i8, ptr %retptr, i64 656
  %retptr.repack1262.repack1354.repack1386 = getelementptr inbounds i8, ptr %retptr, i64 672
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %retptr.repack1262.repack1354, i8 0, i64 16, i1 false)
  store i64 %.1746, ptr %retptr.repack1262.repack1354.repack1386, align 8
  %retptr.repack1262.repack1354.repack1388 = getelementptr inbounds i8, ptr %retptr, i64 680
  store i64 8, ptr %retptr.repack1262.repack1354.repack1388, align 8
  %retptr.repack1262.repack1354.repack1390 = getelementptr inbounds i8, ptr %retptr, i64 688
  store ptr %.2357, ptr %retptr.repack1262.repack1354.repack1390, align 8
  %retptr.repack1262.repack1354.repack1392 = getelementptr inbounds i8, ptr %retptr, i64 696
  store i64 %.1746, ptr %retptr.repack1262.repack1354.repack1392, align 8
  %retptr.repack1262.repack1354.repack1394 = getelementptr inbounds i8, ptr %retptr, i64 704
  store i64 8, ptr %retptr.repack1262.repack1354.repack1394, align 8
  %retptr.repack1264 = getelementptr inbounds i8, ptr %retptr, i64 712
  %retptr.repack1264.repack1400 = getelementptr inbounds i8, ptr %retptr, i64 728
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %retptr.repack1264, i8 0, i64 16, i1 false)
  store i64 %.25.i1718, ptr %retptr.repack1264.repack1400, align 8
  %retptr.repack1264.repack1402 = getelementptr inbounds i8, ptr %retptr, i64 736
  store i64 8, ptr %retptr.repack1264.repack1402, align 8
  %retptr.repack1264.repack1404 = getelementptr inbounds i8, ptr %retptr, i64 744
  store ptr %.8500, ptr %retptr.repack1264.repack1404, align 8
  %retptr.repack1264.repack1406 = getelementptr inbounds i8, ptr %retptr, i64 752
  store i64 %.3719, ptr %retptr.repack1264.repack1406, align 8
  %retptr.repack1264.repack1406.repack1410 = getelementptr inbounds i8, ptr %retptr, i64 760
  store i64 2, ptr %retptr.repack1264.repack1406.repack1410, align 8
  %retptr.repack1264.repack1408 = getelementptr inbounds i8, ptr %retptr, i64 768
  store i64 16, ptr %retptr.repack1264.repack1408, align 8
  %retptr.repack1264.repack1408.repack1412 = getelementptr inbounds i8, ptr %retptr, i64 776
  store i64 8, ptr %retptr.repack1264.repack1408.repack1412, align 8
  %retptr.repack1264.repack1396 = getelementptr inbounds i8, ptr %retptr, i64 784
  %retptr.repack1264.repack1396.repack1416 = getelementptr inbounds i8, ptr %retptr, i64 800
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %retptr.repack1264.repack1396, i8 0, i64 16, i1 false)
  store i64 %.25.i1726, ptr %retptr.repack1264.repack1396.repack1416, align 8
  %retptr.repack1264.repack1396.repack1418 = getelementptr inbounds i8, ptr %retptr, i64 808
  store i64 8, ptr %retptr.repack1264.repack1396.repack1418, align 8
  %retptr.repack1264.repack1396.repack1420 = getelementptr inbounds i8, ptr %retptr, i64 816
  store ptr %.8894, ptr %retptr.repack1264.repack1396.repack1420, align 8
  %retptr.repack1264.repack1396.repack1422 = getelementptr inbounds i8, ptr %retptr, i64 824
  store i64 %.3719, ptr %retptr.repack1264.repack1396.repack1422, align 8
  %retptr.repack1264.repack1396.repack1422.repack1426 = getelementptr inbounds i8, ptr %retptr, i64 832
  store i64 3, ptr %retptr.repack1264.repack1396.repack1422.repack1426, align 8
  %retptr.repack1264.repack1396.repack1424 = getelementptr inbounds i8, ptr %retptr, i64 840
  store i64 24, ptr %retptr.repack1264.repack1396.repack1424, align 8
  %retptr.repack1264.repack1396.repack1424.repack1428 = getelementptr inbounds i8, ptr %retptr, i64 848
  store i64 8, ptr %retptr.repack1264.repack1396.repack1424.repack1428, align 8
  %retptr.repack1266 = getelementptr inbounds i8, ptr %retptr, i64 856
  %retptr.repack1266.repack1456 = getelementptr inbounds i8, ptr %retptr, i64 872
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %retptr.repack1266, i8 0, i64 16, i1 false)
  store i64 %.3857, ptr %retptr.repack1266.repack1456, align 8
  %retptr.repack1266.repack1458 = getelementptr inbounds i8, ptr %retptr, i64 880
  store i64 8, ptr %retptr.repack1266.repack1458, align 8
  %retptr.repack1266.repack1460 = getelementptr inbounds i8, ptr %retptr, i64 888
  store ptr %.3873, ptr %retptr.repack1266.repack1460, align 8
  %retptr.repack1266.repack1462 = getelementptr inbounds i8, ptr %retptr, i64 896
  store i64 %.3857, ptr %retptr.repack1266.repack1462, align 8
  %retptr.repack1266.repack1464 = getelementptr inbounds i8, ptr %retptr, i64 904
  store i64 8, ptr %retptr.repack1266.repack1464, align 8
  %retptr.repack1266.repack1430 = getelementptr inbounds i8, ptr %retptr, i64 912
  %retptr.repack1266.repack1430.repack1470 = getelementptr inbounds i8, ptr %retptr, i64 936
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %retptr.repack1266.repack1430, i8 0, i64 24, i1 false)
  store i64 8, ptr %retptr.repack1266.repack1430.repack1470, align 8
  %retptr.repack1266.repack1430.repack1472 = getelementptr inbounds i8, ptr %retptr, i64 944
  store ptr %.2987, ptr %retptr.repack1266.repack1430.repack1472, align 8
  %retptr.repack1266.repack1430.repack1474 = getelementptr inbounds i8, ptr %retptr, i64 952
  store i64 0, ptr %retptr.repack1266.repack1430.repack1474, align 8
  %retptr.repack1266.repack1430.repack1476 = getelementptr inbounds i8, ptr %retptr, i64 960
  store i64 8, ptr %retptr.repack1266.repack1430.repack1476, align 8
  %retptr.repack1266.repack1432 = getelementptr inbounds i8, ptr %retptr, i64 968
  %retptr.repack1266.repack1432.repack1480 = getelementptr inbounds i8, ptr %retptr, i64 984
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %retptr.repack1266.repack1432, i8 0, i64 16, i1 false)
  store i64 %.4029, ptr %retptr.repack1266.repack1432.repack1480, align 8
  %retptr.repack1266.repack1432.repack1482 = getelementptr inbounds i8, ptr %retptr, i64 992
  store i64 8, ptr %retptr.repack1266.repack1432.repack1482, align 8
  %retptr.repack1266.repack1432.repack1484 = getelementptr inbounds i8, ptr %retptr, i64 1000
  store ptr %.4045, ptr %retptr.repack1266.repack1432.repack1484, align 8
  %retptr.repack1266.repack1432.repack1486 = getelementptr inbounds i8, ptr %retptr, i64 1008
  store i64 %.4029, ptr %retptr.repack1266.repack1432.repack1486, align 8
  %retptr.repack1266.repack1432.repack1488 = getelementptr inbounds i8, ptr %retptr, i64 1016
  store i64 8, ptr %retptr.repack1266.repack1432.repack1488, align 8
  %retptr.repack1266.repack1434 = getelementptr inbounds i8, ptr %retptr, i64 1024
  %retptr.repack1266.repack1434.repack1492 = getelementptr inbounds i8, ptr %retptr, i64 1040
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %retptr.repack1266.repack1434, i8 0, i64 16, i1 false)
  store i64 2, ptr %retptr.repack1266.repack1434.repack1492, align 8
  %retptr.repack1266.repack1434.repack1494 = getelementptr inbounds i8, ptr %retptr, i64 1048
  store i64 8, ptr %retptr.repack1266.repack1434.repack1494, align 8
  %retptr.repack1266.repack1434.repack1496 = getelementptr inbounds i8, ptr %retptr, i64 1056
  store ptr %.2314, ptr %retptr.repack1266.repack1434.repack1496, align 8
  %retptr.repack1266.repack1434.repack1498 = getelementptr inbounds i8, ptr %retptr, i64 1064
  store i64 2, ptr %retptr.repack1266.repack1434.repack1498, align 8
  %retptr.repack1266.repack1434.repack1500 = getelementptr inbounds i8, ptr %retptr, i64 1072
  store i64 8, ptr %retptr.repack1266.repack1434.repack1500, align 8
  %retptr.repack1266.repack1436 = getelementptr inbounds i8, ptr %retptr, i64 1080
  %retptr.repack1266.repack1436.repack1506 = getelementptr inbounds i8, ptr %retptr, i64 1104
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %retptr.repack1266.repack1436, i8 0, i64 24, i1 false)
  store i64 8, ptr %retptr.repack1266.repack1436.repack1506, align 8
  %retptr.repack1266.repack1436.repack1508 = getelementptr inbounds i8, ptr %retptr, i64 1112
  store ptr %.2987, ptr %retptr.repack1266.repack1436.repack1508, align 8
  %retptr.repack1266.repack1436.repack1510 = getelementptr inbounds i8, ptr %retptr, i64 1120
  store i64 0, ptr %retptr.repack1266.repack1436.repack1510, align 8
  %retptr.repack1266.repack1436.repack1512 = getelementptr inbounds i8, ptr %retptr, i64 1128
  store i64 8, ptr %retptr.repack1266.repack1436.repack1512, align 8
  %retptr.repack1266.repack1438 = getelementptr inbounds i8, ptr %retptr, i64 1136
  %retptr.repack1266.repack1438.repack1518 = getelementptr inbounds i8, ptr %retptr, i64 1160
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %retptr.repack1266.repack1438, i8 0, i64 24, i1 false)
  store i64 8, ptr %retptr.repack1266.repack1438.repack1518, align 8
  %retptr.repack1266.repack1438.repack1520 = getelementptr inbounds i8, ptr %retptr, i64 1168
  store ptr %.2987, ptr %retptr.repack1266.repack1438.repack1520, align 8
  %retptr.repack1266.repack1438.repack1522 = getelementptr inbounds i8, ptr %retptr, i64 1176
  store i64 0, ptr %retptr.repack1266.repack1438.repack1522, align 8
  %retptr.repack1266.repack1438.repack1524 = getelementptr inbounds i8, ptr %retptr, i64 1184
  store i64 8, ptr %retptr.repack1266.repack1438.repack1524, align 8
  %retptr.repack1266.repack1440 = getelementptr inbounds i8, ptr %retptr, i64 1192
  %retptr.repack1266.repack1440.repack1528 = getelementptr inbounds i8, ptr %retptr, i64 1208
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %retptr.repack1266.repack1440, i8 0, i64 16, i1 false)
  store i64 %.4199, ptr %retptr.repack1266.repack1440.repack1528, align 8
  %retptr.repack1266.repack1440.repack1530 = getelementptr inbounds i8, ptr %retptr, i64 1216
  store i64 8, ptr %retptr.repack1266.repack1440.repack1530, align 8
  %retptr.repack1266.repack1440.repack1532 = getelementptr inbounds i8, ptr %retptr, i64 1224
  store ptr %.4215, ptr %retptr.repack1266.repack1440.repack1532, align 8
  %retptr.repack1266.repack1440.repack1534 = getelementptr inbounds i8, ptr %retptr, i64 1232
  store i64 %.4199, ptr %retptr.repack1266.repack1440.repack1534, align 8
  %retptr.repack1266.repack1440.repack1536 = getelementptr inbounds i8, ptr %retptr, i64 1240
  store i64 8, ptr %retptr.repack1266.repack1440.repack1536, align 8
  %retptr.repack1266.repack1442 = getelementptr inbounds i8, ptr %retptr, i64 1248
  %retptr.repack1266.repack1442.repack1542 = getelementptr inbounds i8, ptr %retptr, i64 1272
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %retptr.repack1266.repack1442, i8 0, i64 24, i1 false)
  store i64 8, ptr %retptr.repack1266.repack1442.repack1542, align 8
  %retptr.repack1266.repack1442.repack1544 = getelementptr inbounds i8, ptr %retptr, i64 1280
  store ptr %.2987, ptr %retptr.repack1266.repack1442.repack1544, align 8
  %retptr.repack1266.repack1442.repack1546 = getelementptr inbounds i8, ptr %retptr, i64 1288
  store i64 0, ptr %retptr.repack1266.repack1442.repack1546, align 8
  %retptr.repack1266.repack1442.repack1548 = getelementptr inbounds i8, ptr %retptr, i64 1296
  store i64 8, ptr %retptr.repack1266.repack1442.repack1548, align 8
  %retptr.repack1266.repack1444 = getelementptr inbounds i8, ptr %retptr, i64 1304
  %retptr.repack1266.repack1444.repack1554 = getelementptr inbounds i8, ptr %retptr, i64 1328
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %retptr.repack1266.repack1444, i8 0, i64 24, i1 false)
  store i64 8, ptr %retptr.repack1266.repack1444.repack1554, align 8
  %retptr.repack1266.repack1444.repack1556 = getelementptr inbounds i8, ptr %retptr, i64 1336
  store ptr %.2987, ptr %retptr.repack1266.repack1444.repack1556, align 8
  %retptr.repack1266.repack1444.repack1558 = getelementptr inbounds i8, ptr %retptr, i64 1344
  store i64 0, ptr %retptr.repack1266.repack1444.repack1558, align 8
  %retptr.repack1266.repack1444.repack1560 = getelementptr inbounds i8, ptr %retptr, i64 1352
  store i64 8, ptr %retptr.repack1266.repack1444.repack1560, align 8
  %retptr.repack1266.repack1446 = getelementptr inbounds i8, ptr %retptr, i64 1360
  %retptr.repack1266.repack1446.repack1566 = getelementptr inbounds i8, ptr %retptr, i64 1384
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %retptr.repack1266.repack1446, i8 0, i64 24, i1 false)
  store i64 8, ptr %retptr.repack1266.repack1446.repack1566, align 8
  %retptr.repack1266.repack1446.repack1568 = getelementptr inbounds i8, ptr %retptr, i64 1392
  store ptr %.2987, ptr %retptr.repack1266.repack1446.repack1568, align 8
  %retptr.repack1266.repack1446.repack1570 = getelementptr inbounds i8, ptr %retptr, i64 1400
  store i64 0, ptr %retptr.repack1266.repack1446.repack1570, align 8
  %retptr.repack1266.repack1446.repack1572 = getelementptr inbounds i8, ptr %retptr, i64 1408
  store i64 8, ptr %retptr.repack1266.repack1446.repack1572, align 8
  %retptr.repack1266.repack1448 = getelementptr inbounds i8, ptr %retptr, i64 1416
  %retptr.repack1266.repack1448.repack1576 = getelementptr inbounds i8, ptr %retptr, i64 1432
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %retptr.repack1266.repack1448, i8 0, i64 16, i1 false)
  store i64 %.4370, ptr %retptr.repack1266.repack1448.repack1576, align 8
  %retptr.repack1266.repack1448.repack1578 = getelementptr inbounds i8, ptr %retptr, i64 1440
  store i64 8, ptr %retptr.repack1266.repack1448.repack1578, align 8
  %retptr.repack1266.repack1448.repack1580 = getelementptr inbounds i8, ptr %retptr, i64 1448
  store ptr %.4386, ptr %retptr.repack1266.repack1448.repack1580, align 8
  %retptr.repack1266.repack1448.repack1582 = getelementptr inbounds i8, ptr %retptr, i64 1456
  store i64 %.4370, ptr %retptr.repack1266.repack1448.repack1582, align 8
  %retptr.repack1266.repack1448.repack1584 = getelementptr inbounds i8, ptr %retptr, i64 1464
  store i64 8, ptr %retptr.repack1266.repack1448.repack1584, align 8
  %retptr.repack1266.repack1450 = getelementptr inbounds i8, ptr %retptr, i64 1472
  %retptr.repack1266.repack1450.repack1588 = getelementptr inbounds i8, ptr %retptr, i64 1488
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %retptr.repack1266.repack1450, i8 0, i64 16, i1 false)
  store i64 %.4542, ptr %retptr.repack1266.repack1450.repack1588, align 8
  %retptr.repack1266.repack1450.repack1590 = getelementptr inbounds i8, ptr %retptr, i64 1496
  store i64 8, ptr %retptr.repack1266.repack1450.repack1590, align 8
  %retptr.repack1266.repack1450.repack1592 = getelementptr inbounds i8, ptr %retptr, i64 1504
  store ptr %.4558, ptr %retptr.repack1266.repack1450.repack1592, align 8
  %retptr.repack1266.repack1450.repack1594 = getelementptr inbounds i8, ptr %retptr, i64 1512
  store i64 %.4542, ptr %retptr.repack1266.repack1450.repack1594, align 8
  %retptr.repack1266.repack1450.repack1596 = getelementptr inbounds i8, ptr %retptr, i64 1520
  store i64 8, ptr %retptr.repack1266.repack1450.repack1596, align 8
  %retptr.repack1266.repack1452 = getelementptr inbounds i8, ptr %retptr, i64 1528
  %retptr.repack1266.repack1452.repack1600 = getelementptr inbounds i8, ptr %retptr, i64 1544
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %retptr.repack1266.repack1452, i8 0, i64 16, i1 false)
  store i64 %.4714, ptr %retptr.repack1266.repack1452.repack1600, align 8
  %retptr.repack1266.repack1452.repack1602 = getelementptr inbounds i8, ptr %retptr, i64 1552
  store i64 8, ptr %retptr.repack1266.repack1452.repack1602, align 8
  %retptr.repack1266.repack1452.repack1604 = getelementptr inbounds i8, ptr %retptr, i64 1560
  store ptr %.4730, ptr %retptr.repack1266.repack1452.repack1604, align 8
  %retptr.repack1266.repack1452.repack1606 = getelementptr inbounds i8, ptr %retptr, i64 1568
  store i64 %.4714, ptr %retptr.repack1266.repack1452.repack1606, align 8
  %retptr.repack1266.repack1452.repack1608 = getelementptr inbounds i8, ptr %retptr, i64 1576
  store i64 8, ptr %retptr.repack1266.repack1452.repack1608, align 8
  %retptr.repack1268 = getelementptr inbounds i8, ptr %retptr, i64 1584
  %retptr.repack1268.repack1612 = getelementptr inbounds i8, ptr %retptr, i64 1600
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %retptr.repack1268, i8 0, i64 16, i1 false)
  store i64 %.9088, ptr %retptr.repack1268.repack1612, align 8
  %retptr.repack1268.repack1614 = getelementptr inbounds i8, ptr %retptr, i64 1608
  store i64 8, ptr %retptr.repack1268.repack1614, align 8
  %retptr.repack1268.repack1616 = getelementptr inbounds i8, ptr %retptr, i64 1616
  store ptr %.9104, ptr %retptr.repack1268.repack1616, align 8
  %retptr.repack1268.repack1618 = getelementptr inbounds i8, ptr %retptr, i64 1624
  store i64 %.9088, ptr %retptr.repack1268.repack1618, align 8
  %retptr.repack1268.repack1620 = getelementptr inbounds i8, ptr %retptr, i64 1632
  store i64 8, ptr %retptr.repack1268.repack1620, align 8
  %retptr.repack1270 = getelementptr inbounds i8, ptr %retptr, i64 1640
  %retptr.repack1270.repack1626 = getelementptr inbounds i8, ptr %retptr, i64 1664
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %retptr.repack1270, i8 0, i64 24, i1 false)
  store i64 8, ptr %retptr.repack1270.repack1626, align 8
  %retptr.repack1270.repack1628 = getelementptr inbounds i8, ptr %retptr, i64 1672
  store ptr %.2987, ptr %retptr.repack1270.repack1628, align 8
  %retptr.repack1270.repack1630 = getelementptr inbounds i8, ptr %retptr, i64 1680
  store i64 0, ptr %retptr.repack1270.repack1630, align 8
  %retptr.repack1270.repack1632 = getelementptr inbounds i8, ptr %retptr, i64 1688
  store i64 8, ptr %retptr.repack1270.repack1632, align 8
  %retptr.repack1272 = getelementptr inbounds i8, ptr %retptr, i64 1696
  %retptr.repack1272.repack1636 = getelementptr inbounds i8, ptr %retptr, i64 1712
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %retptr.repack1272, i8 0, i64 16, i1 false)
  store i64 2, ptr %retptr.repack1272.repack1636, align 8
  %retptr.repack1272.repack1638 = getelementptr inbounds i8, ptr %retptr, i64 1720
  store i64 8, ptr %retptr.repack1272.repack1638, align 8
  %retptr.repack1272.repack1640 = getelementptr inbounds i8, ptr %retptr, i64 1728
  store ptr %.50.i1736, ptr %retptr.repack1272.repack1640, align 8
  %retptr.repack1272.repack1642 = getelementptr inbounds i8, ptr %retptr, i64 1736
  store i64 2, ptr %retptr.repack1272.repack1642, align 8
  %retptr.repack1272.repack1644 = getelementptr inbounds i8, ptr %retptr, i64 1744
  store i64 8, ptr %retptr.repack1272.repack1644, align 8
  %retptr.repack1274 = getelementptr inbounds i8, ptr %retptr, i64 1752
  %retptr.repack1274.repack1648 = getelementptr inbounds i8, ptr %retptr, i64 1768
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %retptr.repack1274, i8 0, i64 16, i1 false)
  store i64 6, ptr %retptr.repack1274.repack1648, align 8
  %retptr.repack1274.repack1650 = getelementptr inbounds i8, ptr %retptr, i64 1776
  store i64 8, ptr %retptr.repack1274.repack1650, align 8
  %retptr.repack1274.repack1652 = getelementptr inbounds i8, ptr %retptr, i64 1784
  store ptr %.368.i, ptr %retptr.repack1274.repack1652, align 8
  %retptr.repack1274.repack1654 = getelementptr inbounds i8, ptr %retptr, i64 1792
  store i64 6, ptr %retptr.repack1274.repack1654, align 8
  %retptr.repack1274.repack1656 = getelementptr inbounds i8, ptr %retptr, i64 1800
  store i64 8, ptr %retptr.repack1274.repack1656, align 8
  ret void
B0.endif.endif.endif.endi...if.21:
  br label %B0.endif.endif.endif.endi...endif.21
B0.endif.endif.endif.endi...endif.21:
  %.8991.sroa.0.1 = phi i64 [ 0, %B0.endif.endif.endif.endi...if.21 ], [ %.4646, %B0.endif.endif.endif.endi...endif.15.endif.if ]
  br i1 %.4654.not, label %B0.endif.endif.endif.endi...endif.21.endif, label %B0.endif.endif.endif.endi...endif.21.if, !prof !109
B0.endif.endif.endif.endi...endif.21.if:
  br label %B0.endif.endif.endif.endi...endif.21.endif
B0.endif.endif.endif.endi...endif.21.endif:
  %.8991.sroa.0.3 = phi i64 [ %.2266, %B0.endif.endif.endif.endi...endif.21.if ], [ %.8991.sroa.0.1, %B0.endif.endif.endif.endi...endif.21 ]
  br i1 %.3775, label %B0.endif.endif.endif.endi...endif.21.endif.if, label %B0.endif.endif.endif.endi...endif.21.endif.endif, !prof !84
B0.endif.endif.endif.endi...endif.21.endif.if:
  br label %B0.endif.endif.endif.endi...endif.21.endif.endif
B0.endif.endif.endif.endi...endif.21.endif.endif:
  %.8991.sroa.13.1 = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.21.endif.if ], [ %.3772, %B0.endif.endif.endif.endi...endif.21.endif ]
  br i1 %.3780.not, label %B0.endif.endif.endif.endi...endif.20.endif.endif.endif, label %B0.endif.endif.endif.endi...endif.21.endif.endif.if, !prof !109
B0.endif.endif.endif.endi...endif.21.endif.endif.if:
  br label %B0.endif.endif.endif.endi...endif.20.endif.endif.endif
}
declare double @llvm.fabs.f64(double)
declare double @llvm.sin.f64(double)
declare double @llvm.floor.f64(double)
define internal fastcc void @v75(ptr noalias nonnull writeonly %retptr, ptr readonly %arg.f.4, i64 %arg.i, double %arg.segment.0, ptr readonly %arg.segment.2.4, i64 %arg.segment.2.5.1) unnamed_addr {
entry:
  %.46 = alloca { [5 x i64], { { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, double, double, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, i8 }, { { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] } }, [13 x { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }], { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, align 8
  %.fca.0.3.gep = getelementptr inbounds i8, ptr %.46, i64 24
  %.fca.0.4.gep = getelementptr inbounds i8, ptr %.46, i64 32
  %.fca.1.0.4.gep = getelementptr inbounds i8, ptr %.46, i64 72
  %.fca.1.1.2.gep = getelementptr inbounds i8, ptr %.46, i64 112
  %.fca.1.1.4.gep = getelementptr inbounds i8, ptr %.46, i64 128
  %.fca.1.2.4.gep = getelementptr inbounds i8, ptr %.46, i64 184
  %.fca.1.3.2.gep = getelementptr inbounds i8, ptr %.46, i64 224
  %.fca.1.3.4.gep = getelementptr inbounds i8, ptr %.46, i64 240
  %.fca.1.4.4.gep = getelementptr inbounds i8, ptr %.46, i64 296
  %.fca.3.0.0.gep = getelementptr inbounds i8, ptr %.46, i64 528
  %.fca.3.2.4.gep = getelementptr inbounds i8, ptr %.46, i64 688
  %.fca.4.0.4.gep = getelementptr inbounds i8, ptr %.46, i64 744
  %.fca.4.0.5.1.gep = getelementptr inbounds i8, ptr %.46, i64 760
  %.fca.4.1.4.gep = getelementptr inbounds i8, ptr %.46, i64 816
  %.fca.4.1.5.0.gep = getelementptr inbounds i8, ptr %.46, i64 824
  %.fca.4.1.5.1.gep = getelementptr inbounds i8, ptr %.46, i64 832
  %.fca.5.0.2.gep = getelementptr inbounds i8, ptr %.46, i64 872
  %.fca.5.0.4.gep = getelementptr inbounds i8, ptr %.46, i64 888
  %.fca.5.3.4.gep = getelementptr inbounds i8, ptr %.46, i64 1056
  %.fca.6.2.gep = getelementptr inbounds i8, ptr %.46, i64 1600
  %.fca.6.4.gep = getelementptr inbounds i8, ptr %.46, i64 1616
  %.fca.9.4.gep = getelementptr inbounds i8, ptr %.46, i64 1784
  %.1327 = alloca i8, align 1
  store i8 0, ptr %.1327, align 1
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(521) %.46, i8 0, i64 521, i1 false)
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(1280) %.fca.3.0.0.gep, i8 0, i64 1280, i1 false)
  call fastcc void @v77(ptr %.46, ptr %arg.f.4, i64 %arg.i)
  %.62.fca.0.3.load = load i64, ptr %.fca.0.3.gep, align 8
  %.62.fca.0.4.load = load i64, ptr %.fca.0.4.gep, align 8
  %.62.fca.1.0.4.load = load ptr, ptr %.fca.1.0.4.gep, align 8
  %.62.fca.1.1.2.load = load i64, ptr %.fca.1.1.2.gep, align 8
  %.62.fca.1.1.4.load = load ptr, ptr %.fca.1.1.4.gep, align 8
  %.62.fca.1.2.4.load = load ptr, ptr %.fca.1.2.4.gep, align 8
  %.62.fca.1.3.2.load = load i64, ptr %.fca.1.3.2.gep, align 8
  %.62.fca.1.3.4.load = load ptr, ptr %.fca.1.3.4.gep, align 8
  %.62.fca.1.4.4.load = load ptr, ptr %.fca.1.4.4.gep, align 8
  %.62.fca.3.2.4.load = load ptr, ptr %.fca.3.2.4.gep, align 8
  %.62.fca.4.0.4.load = load ptr, ptr %.fca.4.0.4.gep, align 8
  %.62.fca.4.0.5.1.load = load i64, ptr %.fca.4.0.5.1.gep, align 8
  %.62.fca.4.1.4.load = load ptr, ptr %.fca.4.1.4.gep, align 8
  %.62.fca.4.1.5.0.load = load i64, ptr %.fca.4.1.5.0.gep, align 8
  %.62.fca.4.1.5.1.load = load i64, ptr %.fca.4.1.5.1.gep, align 8
  %.62.fca.5.0.2.load = load i64, ptr %.fca.5.0.2.gep, align 8
  %.62.fca.5.0.4.load = load ptr, ptr %.fca.5.0.4.gep, align 8
  %.62.fca.5.3.4.load = load ptr, ptr %.fca.5.3.4.gep, align 8
  %.62.fca.6.2.load = load i64, ptr %.fca.6.2.gep, align 8
  %.62.fca.6.4.load = load ptr, ptr %.fca.6.4.gep, align 8
  %.62.fca.9.4.load = load ptr, ptr %.fca.9.4.gep, align 8
  %.392.i.i = load i64, ptr %arg.f.4, align 8, !noalias !183
  %.175117.not.i = icmp slt i64 %.62.fca.6.2.load, 1
  br i1 %.175117.not.i, label %b95, label %B76.if.lr.ph.i
B76.if.lr.ph.i:
  %0 = getelementptr i8, ptr %arg.f.4, i64 464
  %.45.i.i = load i64, ptr %0, align 8, !noalias !183
  %.46.i.i = inttoptr i64 %.45.i.i to ptr
  %invariant.gep.i = getelementptr double, ptr %.46.i.i, i64 %arg.i
  %.241.i = icmp slt i64 %arg.i, 0
  %.242.i = select i1 %.241.i, i64 %.392.i.i, i64 0
  %invariant.gep120.i = getelementptr double, ptr %invariant.gep.i, i64 %.242.i
  br label %B76.if.i
B76.if.i:
  %.119.0118.i = phi i64 [ 0, %B76.if.lr.ph.i ], [ %.188.i, %B76.if.i ]
  %.188.i = add nuw nsw i64 %.119.0118.i, 1
  %.260.i = mul i64 %.119.0118.i, %.392.i.i
  %gep121.i = getelementptr double, ptr %invariant.gep120.i, i64 %.260.i
  %.265.i = load double, ptr %gep121.i, align 8, !noalias !188
  %1 = getelementptr double, ptr %.62.fca.6.4.load, i64 %.119.0118.i
  store double %.265.i, ptr %1, align 8, !noalias !188
  %exitcond.not.i = icmp eq i64 %.188.i, %.62.fca.6.2.load
  br i1 %exitcond.not.i, label %b95, label %B76.if.i
b95:
  %.1311 = getelementptr i8, ptr %arg.f.4, i64 176
  %.1312 = load i64, ptr %.1311, align 8
  %.1313 = icmp sgt i64 %.1312, 0
  br i1 %.1313, label %B146, label %B206
B146:
  call fastcc void @v78(ptr %.1327, ptr nonnull %arg.f.4, i64 %arg.i, i64 %.62.fca.0.4.load, ptr %.62.fca.1.0.4.load, i64 %.62.fca.1.1.2.load, ptr %.62.fca.1.1.4.load, ptr %.62.fca.1.2.4.load, i64 %.62.fca.1.3.2.load, ptr %.62.fca.1.3.4.load, ptr %.62.fca.1.4.4.load, i64 %.62.fca.5.0.2.load, ptr %.62.fca.5.0.4.load, ptr %.62.fca.5.3.4.load, ptr %arg.segment.2.4, i64 %arg.segment.2.5.1, double %arg.segment.0, ptr %.62.fca.6.4.load)
  br label %B206
B206:
  %.1808 = getelementptr i8, ptr %arg.f.4, i64 248
  %.1809 = load i64, ptr %.1808, align 8
  %.1815 = icmp sgt i64 %.1809, 0
  br i1 %.1815, label %B250, label %B206.B342_crit_edge
B206.B342_crit_edge:
  %.2148.phi.trans.insert = getelementptr i8, ptr %.62.fca.9.4.load, i64 24
  %.2149.pre = load i64, ptr %.2148.phi.trans.insert, align 8
  br label %B342
B250:
  %.148211.not.i.i.i = icmp slt i64 %.62.fca.5.0.2.load, 1
  br i1 %.148211.not.i.i.i, label %b96, label %B58.if.i.i.i
B164.i.i.i:
  %.44.i.i.i.i = getelementptr i8, ptr %3, i64 24
  %.45.i.i.i.i = load double, ptr %.44.i.i.i.i, align 8, !noalias !189
  %.73.i.i.i.i = getelementptr i8, ptr %3, i64 32
  %.74.i.i.i.i = load double, ptr %.73.i.i.i.i, align 8, !noalias !189
  %.75.i.i.i.i = fmul double %.74.i.i.i.i, 5.000000e-01
  %.76.i.i.i.i = fmul double %.245.i.i.i, %.75.i.i.i.i
  %.77.i.i.i.i = fadd double %.45.i.i.i.i, %.76.i.i.i.i
  %.78.i.i.i.i = fmul double %.245.i.i.i, %.77.i.i.i.i
  %.87.le.i.i.i.i = tail call double @llvm.floor.f64(double %.78.i.i.i.i)
  %.92.i.i.i.i = fsub double %.78.i.i.i.i, %.87.le.i.i.i.i
  %.93.i.i.i.i = fmul double %.92.i.i.i.i, 0x401921FB54442D18
  %.121.i.i.i.i = getelementptr i8, ptr %3, i64 40
  %.122.i.i.i.i = load double, ptr %.121.i.i.i.i, align 8, !noalias !189
  %.126.i.i.i.i = fadd double %.122.i.i.i.i, %.93.i.i.i.i
  %.593.le.i.i.i = tail call double @llvm.sin.f64(double %.126.i.i.i.i)
  %.598.i.i.i = fmul double %.423.i.i.i, %.593.le.i.i.i
  %.600.i.i.i = fadd double %.361.i.i.i, %.598.i.i.i
  br label %B272.i.i.i
B272.i.i.i:
  %value.2.1.i.i.i = phi double [ %.600.i.i.i, %B164.i.i.i ], [ %.361.i.i.i, %B58.if.i.i.i ]
  %2 = getelementptr double, ptr %.62.fca.5.0.4.load, i64 %.90.0213.i.i.i
  store double %value.2.1.i.i.i, ptr %2, align 8, !noalias !198
  %exitcond.not.i.i.i = icmp eq i64 %.62.fca.5.0.2.load, %.161.i.i.i
  br i1 %exitcond.not.i.i.i, label %b96, label %B58.if.i.i.i
B58.if.i.i.i:
  %.90.0213.i.i.i = phi i64 [ %.161.i.i.i, %B272.i.i.i ], [ 0, %B250 ]
  %.161.i.i.i = add nuw nsw i64 %.90.0213.i.i.i, 1
  %.238.i.i.i = mul i64 %.90.0213.i.i.i, %arg.segment.2.5.1
  %3 = getelementptr double, ptr %arg.segment.2.4, i64 %.238.i.i.i
  %.242.i.i.i = getelementptr i8, ptr %3, i64 48
  %.243.i.i.i = load double, ptr %.242.i.i.i, align 8, !noalias !198
  %.245.i.i.i = fsub double %arg.segment.0, %.243.i.i.i
  %.303.i.i.i = load double, ptr %3, align 8, !noalias !198
  %.357.i.i.i = getelementptr i8, ptr %3, i64 8
  %.358.i.i.i = load double, ptr %.357.i.i.i, align 8, !noalias !198
  %.360.i.i.i = fmul double %.245.i.i.i, %.358.i.i.i
  %.361.i.i.i = fadd double %.303.i.i.i, %.360.i.i.i
  %.422.i.i.i = getelementptr i8, ptr %3, i64 16
  %.423.i.i.i = load double, ptr %.422.i.i.i, align 8, !noalias !198
  %.424.i.i.i = fcmp une double %.423.i.i.i, 0.000000e+00
  br i1 %.424.i.i.i, label %B164.i.i.i, label %B272.i.i.i
b96:
  store double %arg.segment.0, ptr %.62.fca.5.3.4.load, align 8, !noalias !199
  %.992.i.i = inttoptr i64 %.62.fca.0.3.load to ptr
  tail call void %.992.i.i(ptr nonnull %.62.fca.5.3.4.load, ptr %.62.fca.6.4.load, ptr %.62.fca.5.0.4.load, ptr %.62.fca.1.0.4.load, ptr %.62.fca.3.2.4.load), !noalias !199
  %spec.select.i = tail call i64 @llvm.smax.i64(i64 %.62.fca.4.1.5.0.load, i64 0)
  br label %B140.i
B140.i:
  %.859.0.i = phi i64 [ 0, %b96 ], [ %.928.i, %B288.i ]
  %exitcond294.not.i = icmp eq i64 %.859.0.i, %spec.select.i
  br i1 %exitcond294.not.i, label %b102, label %B142.i
B142.i:
  %.1005.i = mul i64 %.859.0.i, %.62.fca.4.1.5.1.load
  %4 = getelementptr double, ptr %.62.fca.4.1.4.load, i64 %.1005.i
  %.1009.i = getelementptr i8, ptr %4, i64 16
  %.1010.i = load double, ptr %.1009.i, align 8, !noalias !200
  %.1186.i = mul i64 %.859.0.i, %.62.fca.4.0.5.1.load
  %5 = getelementptr i64, ptr %.62.fca.4.0.4.load, i64 %.1186.i
  br label %B194.if.i
B226.i:
  %6 = getelementptr double, ptr %4, i64 %.1037.0289.i
  %.1249.i = load double, ptr %6, align 8, !noalias !200
  %.1338.i = getelementptr double, ptr %.62.fca.3.2.4.load, i64 %.1191.i
  %.1339.i = load double, ptr %.1338.i, align 8, !noalias !200
  %.1340.i = fmul double %.1249.i, %.1339.i
  %.1342.i = fadd double %value.2.1291.i, %.1340.i
  br label %B286.i
B286.i:
  %value.3.2.i = phi double [ %.1342.i, %B226.i ], [ %value.2.1291.i, %B194.if.i ]
  br i1 %exitcond.not.i1642, label %B288.i, label %B194.if.i
B288.i:
  %.928.i = add nuw i64 %.859.0.i, 1
  %.1361.i = fcmp ogt double %value.3.2.i, 0.000000e+00
  br i1 %.1361.i, label %b102, label %B140.i
B194.if.i:
  %value.2.1291.i = phi double [ %.1010.i, %B142.i ], [ %value.3.2.i, %B286.i ]
  %exitcond.not.i1642 = phi i1 [ false, %B142.i ], [ true, %B286.i ]
  %.1037.0289.i = phi i64 [ 0, %B142.i ], [ 1, %B286.i ]
  %7 = getelementptr i64, ptr %5, i64 %.1037.0289.i
  %.1191.i = load i64, ptr %7, align 8, !noalias !200
  %.1194.i = icmp sgt i64 %.1191.i, -1
  br i1 %.1194.i, label %B226.i, label %B286.i
b102:
  %storemerge280.i = phi i64 [ %.859.0.i, %B288.i ], [ -1, %B140.i ]
  %.1985 = getelementptr i8, ptr %.62.fca.9.4.load, i64 24
  store i64 %storemerge280.i, ptr %.1985, align 8
  br label %B342
B342:
  %.2149 = phi i64 [ %.2149.pre, %B206.B342_crit_edge ], [ %storemerge280.i, %b102 ]
  store i64 %.2149, ptr %retptr, align 8
  ret void
}
define internal fastcc void @v76(ptr noalias nonnull writeonly %retptr, ptr readonly %arg.f.4, i64 %arg.i, ptr readonly %arg.segment.2.4, i64 %arg.segment.2.5.1, double %arg.t) unnamed_addr {
entry:
  %.39 = alloca { [5 x i64], { { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, double, double, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, i8 }, { { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] } }, [13 x { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }], { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, align 8
  %.fca.3.0.0.gep = getelementptr inbounds i8, ptr %.39, i64 528
  %.fca.5.0.2.gep = getelementptr inbounds i8, ptr %.39, i64 872
  %.fca.5.0.4.gep = getelementptr inbounds i8, ptr %.39, i64 888
  %.fca.5.2.2.gep = getelementptr inbounds i8, ptr %.39, i64 984
  %.fca.5.2.4.gep = getelementptr inbounds i8, ptr %.39, i64 1000
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(521) %.39, i8 0, i64 521, i1 false)
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(1280) %.fca.3.0.0.gep, i8 0, i64 1280, i1 false)
  call fastcc void @v77(ptr %.39, ptr %arg.f.4, i64 %arg.i)
  %.55.fca.5.0.2.load = load i64, ptr %.fca.5.0.2.gep, align 8
  %.55.fca.5.0.4.load = load ptr, ptr %.fca.5.0.4.gep, align 8
  %.55.fca.5.2.2.load = load i64, ptr %.fca.5.2.2.gep, align 8
  %.55.fca.5.2.4.load = load ptr, ptr %.fca.5.2.4.gep, align 8
  %.148211.not.i = icmp slt i64 %.55.fca.5.0.2.load, 1
  br i1 %.148211.not.i, label %b103, label %B58.if.i
B164.i:
  %.44.i.i = getelementptr i8, ptr %1, i64 24
  %.45.i.i = load double, ptr %.44.i.i, align 8, !noalias !201
  %.73.i.i = getelementptr i8, ptr %1, i64 32
  %.74.i.i = load double, ptr %.73.i.i, align 8, !noalias !201
  %.75.i.i = fmul double %.74.i.i, 5.000000e-01
  %.76.i.i = fmul double %.245.i, %.75.i.i
  %.77.i.i = fadd double %.45.i.i, %.76.i.i
  %.78.i.i = fmul double %.245.i, %.77.i.i
  %.87.le.i.i = tail call double @llvm.floor.f64(double %.78.i.i)
  %.92.i.i = fsub double %.78.i.i, %.87.le.i.i
  %.93.i.i = fmul double %.92.i.i, 0x401921FB54442D18
  %.121.i.i = getelementptr i8, ptr %1, i64 40
  %.122.i.i = load double, ptr %.121.i.i, align 8, !noalias !201
  %.126.i.i = fadd double %.122.i.i, %.93.i.i
  %.593.le.i = tail call double @llvm.sin.f64(double %.126.i.i)
  %.598.i = fmul double %.423.i, %.593.le.i
  %.600.i = fadd double %.361.i, %.598.i
  br label %B272.i
B272.i:
  %value.2.1.i = phi double [ %.600.i, %B164.i ], [ %.361.i, %B58.if.i ]
  %0 = getelementptr double, ptr %.55.fca.5.0.4.load, i64 %.90.0213.i
  store double %value.2.1.i, ptr %0, align 8, !noalias !206
  %exitcond.not.i = icmp eq i64 %.55.fca.5.0.2.load, %.161.i
  br i1 %exitcond.not.i, label %b103, label %B58.if.i
B58.if.i:
  %.90.0213.i = phi i64 [ %.161.i, %B272.i ], [ 0, %entry ]
  %.161.i = add nuw nsw i64 %.90.0213.i, 1
  %.238.i = mul i64 %.90.0213.i, %arg.segment.2.5.1
  %1 = getelementptr double, ptr %arg.segment.2.4, i64 %.238.i
  %.242.i = getelementptr i8, ptr %1, i64 48
  %.243.i = load double, ptr %.242.i, align 8, !noalias !206
  %.245.i = fsub double %arg.t, %.243.i
  %.303.i = load double, ptr %1, align 8, !noalias !206
  %.357.i = getelementptr i8, ptr %1, i64 8
  %.358.i = load double, ptr %.357.i, align 8, !noalias !206
  %.360.i = fmul double %.245.i, %.358.i
  %.361.i = fadd double %.303.i, %.360.i
  %.422.i = getelementptr i8, ptr %1, i64 16
  %.423.i = load double, ptr %.422.i, align 8, !noalias !206
  %.424.i = fcmp une double %.423.i, 0.000000e+00
  br i1 %.424.i, label %B164.i, label %B272.i
b103:
  %.148231.not.i = icmp slt i64 %.55.fca.5.2.2.load, 1
  br i1 %.148231.not.i, label %b104, label %B58.if.i231
B110.i:
  %.361.i237 = getelementptr i8, ptr %3, i64 48
  %.362.i = load double, ptr %.361.i237, align 8, !noalias !207
  %.364.i = fsub double %arg.t, %.362.i
  %.419.i = getelementptr i8, ptr %3, i64 24
  %.420.i = load double, ptr %.419.i, align 8, !noalias !207
  %.474.i = getelementptr i8, ptr %3, i64 32
  %.475.i = load double, ptr %.474.i, align 8, !noalias !207
  %.476.i = fmul double %.364.i, %.475.i
  %.477.i = fadd double %.420.i, %.476.i
  %.478.i = fmul double %.477.i, 0x401921FB54442D18
  %.534.i = fmul double %.305.i, %.478.i
  %.75.i.i238 = fmul double %.475.i, 5.000000e-01
  %.76.i.i239 = fmul double %.364.i, %.75.i.i238
  %.77.i.i240 = fadd double %.420.i, %.76.i.i239
  %.78.i.i241 = fmul double %.364.i, %.77.i.i240
  %.87.le.i.i242 = tail call double @llvm.floor.f64(double %.78.i.i241)
  %.92.i.i243 = fsub double %.78.i.i241, %.87.le.i.i242
  %.93.i.i244 = fmul double %.92.i.i243, 0x401921FB54442D18
  %.121.i.i245 = getelementptr i8, ptr %3, i64 40
  %.122.i.i246 = load double, ptr %.121.i.i245, align 8, !noalias !210
  %.126.i.i247 = fadd double %.122.i.i246, %.93.i.i244
  %.644.le.i = tail call double @llvm.cos.f64(double %.126.i.i247)
  %.649.i = fmul double %.534.i, %.644.le.i
  %.651.i = fadd double %.243.i235, %.649.i
  br label %B326.i
B326.i:
  %slope.2.1.i = phi double [ %.651.i, %B110.i ], [ %.243.i235, %B58.if.i231 ]
  %2 = getelementptr double, ptr %.55.fca.5.2.4.load, i64 %.90.0233.i
  store double %slope.2.1.i, ptr %2, align 8, !noalias !207
  %exitcond.not.i236 = icmp eq i64 %.55.fca.5.2.2.load, %.161.i232
  br i1 %exitcond.not.i236, label %b104, label %B58.if.i231
B58.if.i231:
  %.90.0233.i = phi i64 [ %.161.i232, %B326.i ], [ 0, %b103 ]
  %.161.i232 = add nuw nsw i64 %.90.0233.i, 1
  %.238.i233 = mul i64 %.90.0233.i, %arg.segment.2.5.1
  %3 = getelementptr double, ptr %arg.segment.2.4, i64 %.238.i233
  %.242.i234 = getelementptr i8, ptr %3, i64 8
  %.243.i235 = load double, ptr %.242.i234, align 8, !noalias !207
  %.304.i = getelementptr i8, ptr %3, i64 16
  %.305.i = load double, ptr %.304.i, align 8, !noalias !207
  %.306.i = fcmp une double %.305.i, 0.000000e+00
  br i1 %.306.i, label %B110.i, label %B326.i
b104:
  %.392.i.i = load i64, ptr %arg.f.4, align 8, !noalias !213
  br i1 %.148211.not.i, label %b99, label %B76.if.lr.ph.i
B76.if.lr.ph.i:
  %4 = getelementptr i8, ptr %arg.f.4, i64 472
  %.45.i.i248 = load i64, ptr %4, align 8, !noalias !213
  %.46.i.i = inttoptr i64 %.45.i.i248 to ptr
  %invariant.gep.i = getelementptr double, ptr %.46.i.i, i64 %arg.i
  %.271.i = icmp slt i64 %arg.i, 0
  %.272.i = select i1 %.271.i, i64 %.392.i.i, i64 0
  %invariant.gep120.i = getelementptr double, ptr %invariant.gep.i, i64 %.272.i
  br label %B76.if.i
B76.if.i:
  %.119.0118.i = phi i64 [ 0, %B76.if.lr.ph.i ], [ %.188.i, %B76.if.i ]
  %.188.i = add nuw nsw i64 %.119.0118.i, 1
  %5 = getelementptr double, ptr %.55.fca.5.0.4.load, i64 %.119.0118.i
  %.242.i249 = load double, ptr %5, align 8, !noalias !218
  %.290.i = mul i64 %.119.0118.i, %.392.i.i
  %gep121.i = getelementptr double, ptr %invariant.gep120.i, i64 %.290.i
  store double %.242.i249, ptr %gep121.i, align 8, !noalias !218
  %exitcond.not.i250 = icmp eq i64 %.188.i, %.55.fca.5.0.2.load
  br i1 %exitcond.not.i250, label %b100, label %B76.if.i
b100:
  %.392.i.i251.pre = load i64, ptr %arg.f.4, align 8, !noalias !219
  br label %b99
b99:
  %.392.i.i251 = phi i64 [ %.392.i.i251.pre, %b100 ], [ %.392.i.i, %b104 ]
  br i1 %.148231.not.i, label %b105, label %B76.if.lr.ph.i253
B76.if.lr.ph.i253:
  %6 = getelementptr i8, ptr %arg.f.4, i64 488
  %.45.i.i254 = load i64, ptr %6, align 8, !noalias !219
  %.46.i.i255 = inttoptr i64 %.45.i.i254 to ptr
  %invariant.gep.i256 = getelementptr double, ptr %.46.i.i255, i64 %arg.i
  %.271.i257 = icmp slt i64 %arg.i, 0
  %.272.i258 = select i1 %.271.i257, i64 %.392.i.i251, i64 0
  %invariant.gep120.i259 = getelementptr double, ptr %invariant.gep.i256, i64 %.272.i258
  br label %B76.if.i260
B76.if.i260:
  %.119.0118.i261 = phi i64 [ 0, %B76.if.lr.ph.i253 ], [ %.188.i262, %B76.if.i260 ]
  %.188.i262 = add nuw nsw i64 %.119.0118.i261, 1
  %7 = getelementptr double, ptr %.55.fca.5.2.4.load, i64 %.119.0118.i261
  %.242.i263 = load double, ptr %7, align 8, !noalias !224
  %.290.i264 = mul i64 %.119.0118.i261, %.392.i.i251
  %gep121.i265 = getelementptr double, ptr %invariant.gep120.i259, i64 %.290.i264
  store double %.242.i263, ptr %gep121.i265, align 8, !noalias !224
  %exitcond.not.i266 = icmp eq i64 %.188.i262, %.55.fca.5.2.2.load
  br i1 %exitcond.not.i266, label %b105, label %B76.if.i260
b105:
  store ptr null, ptr %retptr, align 8
  ret void
}
declare double @llvm.cos.f64(double)
define internal fastcc void @v78(ptr noalias nonnull writeonly %retptr, ptr readonly %arg.f.4, i64 %arg.i, i64 %arg.run.0.4, ptr %arg.run.1.0.4, i64 %arg.run.1.1.2, ptr %arg.run.1.1.4, ptr readonly %arg.run.1.2.4, i64 %arg.run.1.3.2, ptr %arg.run.1.3.4, ptr %arg.run.1.4.4, i64 %arg.run.5.0.2, ptr %arg.run.5.0.4, ptr %arg.run.5.3.4, ptr readonly %arg.segment.2.4, i64 %arg.segment.2.5.1, double %arg.t, ptr %arg.x.4) unnamed_addr {
entry:
  %.494 = alloca i8, align 1
  store i8 0, ptr %.494, align 1
  call fastcc void @v79(ptr %.494, i64 %arg.run.0.4, ptr %arg.run.1.0.4, i64 %arg.run.1.1.2, ptr %arg.run.1.1.4, ptr %arg.run.1.2.4, i64 %arg.run.1.3.2, ptr %arg.run.1.3.4, ptr %arg.run.1.4.4, i64 %arg.run.5.0.2, ptr %arg.run.5.0.4, ptr %arg.run.5.3.4, ptr %arg.segment.2.4, i64 %arg.segment.2.5.1, double %arg.t, ptr %arg.x.4)
  %.601 = load i8, ptr %.494, align 1
  %.392.i = load i64, ptr %arg.f.4, align 8, !noalias !225
  %.1346 = getelementptr i8, ptr %arg.f.4, i64 168
  %.1347 = load i64, ptr %.1346, align 8
  %.1427627.not = icmp slt i64 %.1347, 1
  br i1 %.1427627.not, label %B254, label %B164.if.lr.ph
B164.if.lr.ph:
  %0 = getelementptr i8, ptr %arg.f.4, i64 496
  %.45.i = load i64, ptr %0, align 8, !noalias !225
  %.46.i = inttoptr i64 %.45.i to ptr
  %invariant.gep = getelementptr double, ptr %.46.i, i64 %arg.i
  %.1878 = getelementptr i8, ptr %arg.f.4, i64 160
  %.1909 = icmp slt i64 %arg.i, 0
  %.1910 = select i1 %.1909, i64 %.392.i, i64 0
  %invariant.gep630 = getelementptr double, ptr %invariant.gep, i64 %.1910
  br label %B164.if
B254:
  %.604 = icmp ne i8 %.601, 0
  %.2076 = zext i1 %.604 to i8
  store i8 %.2076, ptr %retptr, align 1
  ret void
B164.if:
  %.1371.0628 = phi i64 [ 0, %B164.if.lr.ph ], [ %.1440, %B164.if ]
  %.1440 = add nuw nsw i64 %.1371.0628, 1
  %1 = getelementptr double, ptr %arg.run.1.1.4, i64 %.1371.0628
  %.1529 = load double, ptr %1, align 8
  %.1879 = load i64, ptr %.1878, align 8
  %.1880 = add nsw i64 %.1879, %.1371.0628
  %.1880.lobit = lshr i64 %.1880, 63
  %.1908 = add i64 %.1880.lobit, %.1880
  %.1928 = mul i64 %.1908, %.392.i
  %gep631 = getelementptr double, ptr %invariant.gep630, i64 %.1928
  store double %.1529, ptr %gep631, align 8
  %exitcond.not = icmp eq i64 %.1440, %.1347
  br i1 %exitcond.not, label %B254, label %B164.if
}
define internal fastcc void @v79(ptr noalias nonnull writeonly %retptr, i64 %arg.run.0.4, ptr %arg.run.1.0.4, i64 %arg.run.1.1.2, ptr %arg.run.1.1.4, ptr readonly %arg.run.1.2.4, i64 %arg.run.1.3.2, ptr %arg.run.1.3.4, ptr %arg.run.1.4.4, i64 %arg.run.5.0.2, ptr %arg.run.5.0.4, ptr %arg.run.5.3.4, ptr readonly %arg.segment.2.4, i64 %arg.segment.2.5.1, double %arg.t, ptr %arg.x.4) unnamed_addr {
entry:
  %.5.i = fmul double %arg.t, 0x3D06849B86A12B9B
  %.6.i = fadd double %.5.i, 1.000000e-15
  %.765 = fadd double %arg.t, %.6.i
  %.164126.not.i = icmp sgt i64 %arg.run.1.3.2, 0
  br i1 %.164126.not.i, label %B78.if.i, label %b106
B78.if.i:
  %first.2.0129.i = phi double [ %.13.i.i, %B78.if.i ], [ 0x7FF0000000000000, %entry ]
  %.106.0128.i = phi i64 [ %.177.i, %B78.if.i ], [ 0, %entry ]
  %.177.i = add nuw nsw i64 %.106.0128.i, 1
  %0 = getelementptr double, ptr %arg.run.1.1.4, i64 %.106.0128.i
  %.235.i = load double, ptr %0, align 8, !noalias !228
  %.12.i.i = fcmp olt double %.235.i, %first.2.0129.i
  %.13.i.i = select i1 %.12.i.i, double %.235.i, double %first.2.0129.i
  %exitcond.not.i = icmp eq i64 %arg.run.1.3.2, %.177.i
  br i1 %exitcond.not.i, label %b106, label %B78.if.i
b106:
  %first.2.0.lcssa.i = phi double [ 0x7FF0000000000000, %entry ], [ %.13.i.i, %B78.if.i ]
  %.806 = fcmp ugt double %first.2.0.lcssa.i, %.765
  br i1 %.806, label %B626, label %B112.preheader
B112.preheader:
  %.148211.not.i = icmp slt i64 %arg.run.5.0.2, 1
  %.1203 = inttoptr i64 %arg.run.0.4 to ptr
  %.13131567.not = icmp slt i64 %arg.run.1.1.2, 1
  br label %B112
B112:
  %changed.4.0 = phi i1 [ %changed.3.1.lcssa, %b107 ], [ false, %B112.preheader ]
  br i1 %.164126.not.i, label %B162.if, label %B226
B226:
  store double %arg.t, ptr %arg.run.5.3.4, align 8
  br i1 %.148211.not.i, label %b103, label %B58.if.i
B164.i:
  %.44.i.i = getelementptr i8, ptr %2, i64 24
  %.45.i.i = load double, ptr %.44.i.i, align 8, !noalias !231
  %.73.i.i = getelementptr i8, ptr %2, i64 32
  %.74.i.i = load double, ptr %.73.i.i, align 8, !noalias !231
  %.75.i.i = fmul double %.74.i.i, 5.000000e-01
  %.76.i.i = fmul double %.245.i, %.75.i.i
  %.77.i.i = fadd double %.45.i.i, %.76.i.i
  %.78.i.i = fmul double %.245.i, %.77.i.i
  %.87.le.i.i = tail call double @llvm.floor.f64(double %.78.i.i)
  %.92.i.i = fsub double %.78.i.i, %.87.le.i.i
  %.93.i.i = fmul double %.92.i.i, 0x401921FB54442D18
  %.121.i.i = getelementptr i8, ptr %2, i64 40
  %.122.i.i = load double, ptr %.121.i.i, align 8, !noalias !231
  %.126.i.i = fadd double %.122.i.i, %.93.i.i
  %.593.le.i = tail call double @llvm.sin.f64(double %.126.i.i)
  %.598.i = fmul double %.423.i, %.593.le.i
  %.600.i = fadd double %.361.i, %.598.i
  br label %B272.i
B272.i:
  %value.2.1.i = phi double [ %.600.i, %B164.i ], [ %.361.i, %B58.if.i ]
  %1 = getelementptr double, ptr %arg.run.5.0.4, i64 %.90.0213.i
  store double %value.2.1.i, ptr %1, align 8, !noalias !236
  %exitcond.not.i1550 = icmp eq i64 %arg.run.5.0.2, %.161.i
  br i1 %exitcond.not.i1550, label %b103, label %B58.if.i
B58.if.i:
  %.90.0213.i = phi i64 [ %.161.i, %B272.i ], [ 0, %B226 ]
  %.161.i = add nuw nsw i64 %.90.0213.i, 1
  %.238.i = mul i64 %.90.0213.i, %arg.segment.2.5.1
  %2 = getelementptr double, ptr %arg.segment.2.4, i64 %.238.i
  %.242.i = getelementptr i8, ptr %2, i64 48
  %.243.i = load double, ptr %.242.i, align 8, !noalias !236
  %.245.i = fsub double %arg.t, %.243.i
  %.303.i = load double, ptr %2, align 8, !noalias !236
  %.357.i = getelementptr i8, ptr %2, i64 8
  %.358.i = load double, ptr %.357.i, align 8, !noalias !236
  %.360.i = fmul double %.245.i, %.358.i
  %.361.i = fadd double %.303.i, %.360.i
  %.422.i = getelementptr i8, ptr %2, i64 16
  %.423.i = load double, ptr %.422.i, align 8, !noalias !236
  %.424.i = fcmp une double %.423.i, 0.000000e+00
  br i1 %.424.i, label %B164.i, label %B272.i
b103:
  tail call void %.1203(ptr nonnull %arg.run.5.3.4, ptr %arg.x.4, ptr %arg.run.5.0.4, ptr %arg.run.1.0.4, ptr %arg.run.1.3.4, ptr %arg.run.1.4.4)
  br i1 %.13131567.not, label %B586, label %B452.if
B482:
  %3 = getelementptr double, ptr %arg.run.1.1.4, i64 %.1257.01568
  %.1475 = load double, ptr %3, align 8
  %.1479 = fcmp une double %.1523.pre, %.1475
  br i1 %.1479, label %B538, label %B542
B538:
  br label %B542
B542:
  %changed.5.2 = phi i1 [ true, %B538 ], [ %changed.3.11570, %B482 ], [ %changed.3.11570, %B452.if ]
  %4 = getelementptr double, ptr %arg.run.1.1.4, i64 %.1257.01568
  store double %.1523.pre, ptr %4, align 8
  %exitcond1571.not = icmp eq i64 %arg.run.1.1.2, %.1326
  br i1 %exitcond1571.not, label %B586, label %B452.if
B586:
  %changed.3.1.lcssa = phi i1 [ %changed.4.0, %b103 ], [ %changed.5.2, %B542 ]
  br i1 %.164126.not.i, label %B78.if.i1552, label %b107
B78.if.i1552:
  %first.2.0129.i1553 = phi double [ %.13.i.i1558, %B78.if.i1552 ], [ 0x7FF0000000000000, %B586 ]
  %.106.0128.i1554 = phi i64 [ %.177.i1555, %B78.if.i1552 ], [ 0, %B586 ]
  %.177.i1555 = add nuw nsw i64 %.106.0128.i1554, 1
  %5 = getelementptr double, ptr %arg.run.1.1.4, i64 %.106.0128.i1554
  %.235.i1556 = load double, ptr %5, align 8, !noalias !237
  %.12.i.i1557 = fcmp olt double %.235.i1556, %first.2.0129.i1553
  %.13.i.i1558 = select i1 %.12.i.i1557, double %.235.i1556, double %first.2.0129.i1553
  %exitcond.not.i1559 = icmp eq i64 %arg.run.1.3.2, %.177.i1555
  br i1 %exitcond.not.i1559, label %b107, label %B78.if.i1552
b107:
  %first.2.0.lcssa.i1560 = phi double [ 0x7FF0000000000000, %B586 ], [ %.13.i.i1558, %B78.if.i1552 ]
  %.1617 = fcmp ugt double %first.2.0.lcssa.i1560, %.765
  br i1 %.1617, label %B626.loopexit, label %B112
B626.loopexit:
  %6 = zext i1 %changed.3.1.lcssa to i8
  br label %B626
B626:
  %changed.2.1 = phi i8 [ 0, %b106 ], [ %6, %B626.loopexit ]
  store i8 %changed.2.1, ptr %retptr, align 1
  ret void
B162.if:
  %.850.01566 = phi i64 [ %.919, %B162.if ], [ 0, %B112 ]
  %.919 = add nuw nsw i64 %.850.01566, 1
  %7 = getelementptr double, ptr %arg.run.1.1.4, i64 %.850.01566
  %.981 = load double, ptr %7, align 8
  %.986 = fcmp ugt double %.981, %.765
  %. = select i1 %.986, double 0.000000e+00, double 1.000000e+00
  %8 = getelementptr double, ptr %arg.run.1.3.4, i64 %.850.01566
  store double %., ptr %8, align 8
  %exitcond.not = icmp eq i64 %arg.run.1.3.2, %.919
  br i1 %exitcond.not, label %B226, label %B162.if
B452.if:
  %changed.3.11570 = phi i1 [ %changed.5.2, %B542 ], [ %changed.4.0, %b103 ]
  %.1257.01568 = phi i64 [ %.1326, %B542 ], [ 0, %b103 ]
  %.1326 = add nuw nsw i64 %.1257.01568, 1
  %9 = getelementptr i8, ptr %arg.run.1.2.4, i64 %.1257.01568
  %.1392 = load i8, ptr %9, align 1
  %.1396.not = icmp eq i8 %.1392, 0
  %.phi.trans.insert = getelementptr double, ptr %arg.run.1.4.4, i64 %.1257.01568
  %.1523.pre = load double, ptr %.phi.trans.insert, align 8
  br i1 %.1396.not, label %B542, label %B482
}
define internal fastcc void @v80(ptr noalias nonnull writeonly initializes((0, 1)) %retptr, ptr readonly %arg.f.4, i64 %arg.i, ptr %arg.control.4, i64 %arg.control.5.1, ptr readonly %arg.th.4, i64 %arg.th.5.1) unnamed_addr {
entry:
  %.218 = alloca { double, i8 }, align 8
  %.fca.1.gep = getelementptr inbounds i8, ptr %.218, i64 8
  %.82 = icmp slt i64 %arg.i, 0
  %.83 = select i1 %.82, i64 %arg.th.5.1, i64 0
  %.84 = add i64 %.83, %arg.i
  %.105 = getelementptr double, ptr %arg.th.4, i64 %.84
  %.106 = load double, ptr %.105, align 8
  %0 = getelementptr double, ptr %arg.th.4, i64 %arg.th.5.1
  %.158 = getelementptr double, ptr %0, i64 %.84
  %.159 = load double, ptr %.158, align 8
  %.194 = select i1 %.82, i64 %arg.control.5.1, i64 0
  %.idx = mul i64 %arg.control.5.1, 88
  %1 = getelementptr i8, ptr %arg.control.4, i64 %.idx
  %2 = getelementptr double, ptr %1, i64 %arg.i
  %.216 = getelementptr double, ptr %2, i64 %.194
  %.217 = load double, ptr %.216, align 8
  store double 0.000000e+00, ptr %.218, align 8
  store i8 0, ptr %.fca.1.gep, align 8
  call fastcc void @v81(ptr %.218, ptr %arg.f.4, i64 %arg.i, double %.106, double %.159, double %.217)
  %.234.fca.0.load = load double, ptr %.218, align 8
  %.234.fca.1.load = load i8, ptr %.fca.1.gep, align 8
  %.239 = icmp ne i8 %.234.fca.1.load, 0
  store double %.234.fca.0.load, ptr %.216, align 8
  %.320 = zext i1 %.239 to i8
  store i8 %.320, ptr %retptr, align 1
  ret void
}
define internal fastcc void @v82(ptr noalias nonnull writeonly initializes((0, 8)) %retptr, ptr readonly %arg.f.4, i64 %arg.i, ptr %arg.control.4, i64 %arg.control.5.1, ptr readonly %arg.flags.4, i64 %arg.flags.5.1, i64 %arg.run) unnamed_addr {
entry:
  %.264 = alloca ptr, align 8
  %.992 = alloca ptr, align 8
  %.92 = icmp slt i64 %arg.i, 0
  %.93 = select i1 %.92, i64 %arg.control.5.1, i64 0
  %.94 = add i64 %.93, %arg.i
  %.idx = mul i64 %arg.control.5.1, 88
  %0 = getelementptr i8, ptr %arg.control.4, i64 %.idx
  %.115 = getelementptr double, ptr %0, i64 %.94
  %.116 = load double, ptr %.115, align 8
  %.5.i = fmul double %.116, 0x3D06849B86A12B9B
  %.6.i = fadd double %.5.i, 1.000000e-15
  %.143 = fsub double %.116, %.6.i
  %.idx231 = mul i64 %arg.control.5.1, 168
  %1 = getelementptr i8, ptr %arg.control.4, i64 %.idx231
  %.197 = getelementptr double, ptr %1, i64 %.94
  store double %.143, ptr %.197, align 8
  %.229 = select i1 %.92, i64 %arg.flags.5.1, i64 0
  %.idx232 = shl i64 %arg.flags.5.1, 4
  %2 = getelementptr i8, ptr %arg.flags.4, i64 %.idx232
  %3 = getelementptr i64, ptr %2, i64 %arg.i
  %.251 = getelementptr i64, ptr %3, i64 %.229
  %.252 = load i64, ptr %.251, align 8
  %.258.not = icmp eq i64 %.252, 0
  br i1 %.258.not, label %B166, label %B130
B130:
  call fastcc void @v83(ptr %.264, ptr %arg.f.4, i64 %arg.i, i64 %arg.run)
  br label %B280
B166:
  %.637 = getelementptr i8, ptr %arg.f.4, i64 88
  %.638 = load i64, ptr %.637, align 8
  %.984 = getelementptr i8, ptr %arg.f.4, i64 472
  %.985 = load i64, ptr %.984, align 8
  %.987 = shl nsw i64 %arg.i, 3
  %.988 = add nsw i64 %.985, %.987
  call fastcc void @v84(ptr %.992, ptr %arg.f.4, i64 %arg.i, i64 %arg.run, i64 %.638, i64 %.988)
  br label %B280
B280:
  %.45.i = getelementptr i8, ptr %arg.f.4, i64 344
  %.46.i = load i64, ptr %.45.i, align 8, !noalias !240
  %.50.i = inttoptr i64 %.46.i to ptr
  %.361.i = getelementptr i8, ptr %arg.f.4, i64 392
  %.362.i = load i64, ptr %.361.i, align 8, !noalias !243
  %.366.i = mul nsw i64 %arg.run, 48
  %.367.i = add nsw i64 %.362.i, %.366.i
  %.368.i = inttoptr i64 %.367.i to ptr
  %.1449 = getelementptr i8, ptr %.368.i, i64 16
  %.1450 = load i64, ptr %.1449, align 8
  %.1450.lobit = lshr i64 %.1450, 63
  %4 = getelementptr double, ptr %.50.i, i64 %.1450
  %.1481 = getelementptr double, ptr %4, i64 %.1450.lobit
  %.1482 = load double, ptr %.1481, align 8
  %.idx233 = mul i64 %arg.control.5.1, 104
  %5 = getelementptr i8, ptr %arg.control.4, i64 %.idx233
  %.1541 = getelementptr double, ptr %5, i64 %.94
  store double %.1482, ptr %.1541, align 8
  store ptr null, ptr %retptr, align 8
  ret void
}
define internal fastcc void @v85(ptr noalias nonnull writeonly initializes((0, 8)) %retptr, i64 %arg.i, ptr %arg.control.4, i64 %arg.control.5.1, ptr readonly %arg.th.4, i64 %arg.th.5.1, ptr %arg.flags.4, i64 %arg.flags.5.1, i8 %arg.has_changed) unnamed_addr {
entry:
  %.47.not = icmp eq i8 %arg.has_changed, 0
  %.109 = icmp slt i64 %arg.i, 0
  %.110 = select i1 %.109, i64 %arg.flags.5.1, i64 0
  %.idx = mul i64 %arg.flags.5.1, 24
  %0 = getelementptr i8, ptr %arg.flags.4, i64 %.idx
  %1 = getelementptr i64, ptr %0, i64 %arg.i
  %.132 = getelementptr i64, ptr %1, i64 %.110
  %.133 = load i64, ptr %.132, align 8
  %.134.not = icmp eq i64 %.133, 0
  %.pre = select i1 %.109, i64 %arg.th.5.1, i64 0
  br i1 %.134.not, label %B188, label %B34
B34:
  %2 = getelementptr double, ptr %arg.th.4, i64 %arg.th.5.1
  %3 = getelementptr double, ptr %2, i64 %arg.i
  %.189 = getelementptr double, ptr %3, i64 %.pre
  %.190 = load double, ptr %.189, align 8
  %.222 = select i1 %.109, i64 %arg.control.5.1, i64 0
  %.223 = add i64 %.222, %arg.i
  %4 = getelementptr double, ptr %arg.control.4, i64 %arg.control.5.1
  %.244 = getelementptr double, ptr %4, i64 %.223
  %.245 = load double, ptr %.244, align 8
  %.12.i = fcmp ogt double %.245, 5.000000e-01
  %.13.i = select i1 %.12.i, double %.245, double 5.000000e-01
  %.12.i379 = fcmp olt double %.13.i, 2.000000e+00
  %.13.i380 = select i1 %.12.i379, double %.13.i, double 2.000000e+00
  %.304 = fmul double %.190, %.13.i380
  %.idx373 = mul i64 %arg.control.5.1, 152
  %5 = getelementptr i8, ptr %arg.control.4, i64 %.idx373
  %.358 = getelementptr double, ptr %5, i64 %.223
  store double %.304, ptr %.358, align 8
  store i64 0, ptr %.132, align 8
  br label %B188
B188:
  %6 = getelementptr double, ptr %arg.th.4, i64 %arg.i
  %.469 = getelementptr double, ptr %6, i64 %.pre
  %.470 = load double, ptr %.469, align 8
  br i1 %.47.not, label %common.ret, label %B212
B212:
  %.516 = select i1 %.109, i64 %arg.control.5.1, i64 0
  %.517 = add i64 %.516, %arg.i
  %.idx374 = mul i64 %arg.control.5.1, 96
  %7 = getelementptr i8, ptr %arg.control.4, i64 %.idx374
  %.538 = getelementptr double, ptr %7, i64 %.517
  %.539 = load double, ptr %.538, align 8
  %.5.i = fmul double %.539, 0x3D06849B86A12B9B
  %.6.i = fadd double %.5.i, 1.000000e-15
  %.619 = fsub double %.539, %.6.i
  %.621 = fcmp olt double %.470, %.619
  br i1 %.621, label %B318, label %common.ret
B318:
  %.idx375 = shl i64 %arg.control.5.1, 6
  %8 = getelementptr i8, ptr %arg.control.4, i64 %.idx375
  %.676 = getelementptr double, ptr %8, i64 %.517
  %.677 = load double, ptr %.676, align 8
  %.idx376 = mul i64 %arg.control.5.1, 152
  %9 = getelementptr i8, ptr %arg.control.4, i64 %.idx376
  %.731 = getelementptr double, ptr %9, i64 %.517
  %.732 = load double, ptr %.731, align 8
  %.12.i381 = fcmp olt double %.732, %.677
  %.13.i382 = select i1 %.12.i381, double %.732, double %.677
  store double %.13.i382, ptr %.676, align 8
  %.idx377 = mul i64 %arg.control.5.1, 40
  %10 = getelementptr i8, ptr %arg.control.4, i64 %.idx377
  %.869 = getelementptr double, ptr %10, i64 %.517
  store double 0.000000e+00, ptr %.869, align 8
  %.idx378 = mul i64 %arg.control.5.1, 144
  %11 = getelementptr i8, ptr %arg.control.4, i64 %.idx378
  %.925 = getelementptr double, ptr %11, i64 %.517
  store double %.470, ptr %.925, align 8
  store i64 1, ptr %.132, align 8
  br label %common.ret
common.ret:
  store ptr null, ptr %retptr, align 8
  ret void
}
define internal fastcc void @v86(ptr noalias nonnull writeonly initializes((0, 8)) %retptr, ptr readonly %arg.f.4, i64 %arg.i, ptr readonly %arg.control.4, i64 %arg.control.5.1, ptr readonly %arg.th.4, i64 %arg.th.5.1, ptr readonly %arg.flags.4, i64 %arg.flags.5.1) unnamed_addr {
entry:
  %.110 = icmp slt i64 %arg.i, 0
  %.111 = select i1 %.110, i64 %arg.flags.5.1, i64 0
  %0 = getelementptr i64, ptr %arg.flags.4, i64 %arg.i
  %.133 = getelementptr i64, ptr %0, i64 %.111
  %.134 = load i64, ptr %.133, align 8
  %.361.i = getelementptr i8, ptr %arg.f.4, i64 392
  %.362.i = load i64, ptr %.361.i, align 8, !noalias !246
  %.366.i = mul nsw i64 %.134, 48
  %.367.i = add nsw i64 %.362.i, %.366.i
  %.368.i = inttoptr i64 %.367.i to ptr
  %.205 = select i1 %.110, i64 %arg.th.5.1, i64 0
  %1 = getelementptr double, ptr %arg.th.4, i64 %arg.i
  %.227 = getelementptr double, ptr %1, i64 %.205
  %.228 = load double, ptr %.227, align 8
  %.265 = select i1 %.110, i64 %arg.control.5.1, i64 0
  %.266 = add i64 %.265, %arg.i
  %.idx540 = mul i64 %arg.control.5.1, 48
  %2 = getelementptr i8, ptr %arg.control.4, i64 %.idx540
  %.360 = getelementptr double, ptr %2, i64 %.266
  %.361 = load double, ptr %.360, align 8
  %.362 = fcmp oeq double %.361, 0.000000e+00
  br i1 %.362, label %B150, label %B200
B150:
  %.idx = shl i64 %arg.control.5.1, 6
  %3 = getelementptr i8, ptr %arg.control.4, i64 %.idx
  %.287 = getelementptr double, ptr %3, i64 %.266
  %.288 = load double, ptr %.287, align 8
  %.366 = fadd double %.228, %.288
  %.368 = fcmp ole double %.366, %.228
  %.373 = fcmp olt double %.288, 1.000000e-300
  %or.cond544 = or i1 %.373, %.368
  %"$phi196.0.2.0" = select i1 %or.cond544, i64 2, i64 -1
  br label %B306
B200:
  %.423 = getelementptr i8, ptr %.368.i, i64 24
  %.424 = load i64, ptr %.423, align 8
  %.425 = icmp sgt i64 %.424, -1
  br i1 %.425, label %B306.thread, label %B250
B250:
  %.idx541 = mul i64 %arg.control.5.1, 96
  %4 = getelementptr i8, ptr %arg.control.4, i64 %.idx541
  %.485 = getelementptr double, ptr %4, i64 %.266
  %.486 = load double, ptr %.485, align 8
  %.488 = fcmp olt double %.228, %.486
  %. = sext i1 %.488 to i64
  br label %B306
B306:
  %ended.3.0 = phi i64 [ %"$phi196.0.2.0", %B150 ], [ %., %B250 ]
  %.45.i = getelementptr i8, ptr %arg.f.4, i64 352
  %.46.i = load i64, ptr %.45.i, align 8, !noalias !249
  %.50.i = inttoptr i64 %.46.i to ptr
  %.895 = getelementptr i8, ptr %.50.i, i64 16
  %.896 = load double, ptr %.895, align 8
  %.897 = fcmp une double %.896, 0.000000e+00
  %.900 = icmp sgt i64 %arg.i, 0
  %or.cond = and i1 %.900, %.897
  br i1 %or.cond, label %B396, label %B496
B306.thread:
  %.45.i560 = getelementptr i8, ptr %arg.f.4, i64 352
  %.46.i561 = load i64, ptr %.45.i560, align 8, !noalias !252
  %.50.i562 = inttoptr i64 %.46.i561 to ptr
  %.895563 = getelementptr i8, ptr %.50.i562, i64 16
  %.896564 = load double, ptr %.895563, align 8
  %.897565 = fcmp une double %.896564, 0.000000e+00
  %.900566 = icmp sgt i64 %arg.i, 0
  %or.cond567 = and i1 %.900566, %.897565
  br i1 %or.cond567, label %B396, label %common.ret
B396:
  %ended.3.0569 = phi i64 [ 1, %B306.thread ], [ %ended.3.0, %B306 ]
  %.13.i = tail call i64 @llvm.smin.i64(i64 %ended.3.0569, i64 0)
  %.99.idx.i = mul i64 %arg.flags.5.1, 40
  %.99.i = getelementptr i8, ptr %arg.flags.4, i64 %.99.idx.i
  %.100.i = load i64, ptr %.99.i, align 8, !noalias !254
  %.101.i = icmp sgt i64 %.100.i, 0
  br i1 %.101.i, label %b108, label %B82.i
B82.i:
  %.235.i = load double, ptr %2, align 8, !noalias !254
  %.236.i = fcmp une double %.235.i, 0.000000e+00
  br i1 %.236.i, label %B120.i, label %B172.i
B120.i:
  %.293.i = getelementptr double, ptr %2, i64 %arg.i
  %.294.i = load double, ptr %.293.i, align 8, !noalias !254
  %.302.i = fcmp oeq double %.294.i, 0.000000e+00
  br i1 %.302.i, label %b108, label %B172.i
B172.i:
  br label %b108
b108:
  %storemerge.i = phi i64 [ %.100.i, %B396 ], [ -1, %B172.i ], [ 2, %B120.i ]
  %.13.i550 = tail call i64 @llvm.smax.i64(i64 %storemerge.i, i64 %.13.i)
  br label %common.ret
B496:
  %.1038 = icmp slt i64 %ended.3.0, 1
  br i1 %.1038, label %B518, label %common.ret
B518:
  %.idx542 = mul i64 %arg.control.5.1, 112
  %5 = getelementptr i8, ptr %arg.control.4, i64 %.idx542
  %.1093 = getelementptr double, ptr %5, i64 %.266
  %.1094 = load double, ptr %.1093, align 8
  %.idx543 = shl i64 %arg.control.5.1, 7
  %6 = getelementptr i8, ptr %arg.control.4, i64 %.idx543
  %.1148 = getelementptr double, ptr %6, i64 %.266
  %.1149 = load double, ptr %.1148, align 8
  %.1157 = fcmp ult double %.1094, %.1149
  br i1 %.1157, label %B582, label %B656
B582:
  %.45.i551 = getelementptr i8, ptr %arg.f.4, i64 400
  %.46.i552 = load i64, ptr %.45.i551, align 8, !noalias !257
  %.50.i553 = inttoptr i64 %.46.i552 to ptr
  %.1542 = getelementptr i8, ptr %.50.i553, i64 8
  %.1543 = load double, ptr %.1542, align 8
  %.1547 = fcmp une double %.1543, 0.000000e+00
  br i1 %.1547, label %B656, label %common.ret
B656:
  %.1578 = getelementptr i8, ptr %.50.i, i64 8
  %.1579 = load double, ptr %.1578, align 8
  %7 = getelementptr i8, ptr %arg.f.4, i64 448
  %.45.i.i = load i64, ptr %7, align 8, !noalias !260
  %.46.i.i = inttoptr i64 %.45.i.i to ptr
  %.392.i.i = load i64, ptr %arg.f.4, align 8, !noalias !260
  %.439.i = select i1 %.110, i64 %.392.i.i, i64 0
  %.440.i = add i64 %.439.i, %arg.i
  %.idx.i = mul i64 %.392.i.i, 112
  %8 = getelementptr i8, ptr %.46.i.i, i64 %.idx.i
  %.461.i = getelementptr double, ptr %8, i64 %.440.i
  %.462.i = load double, ptr %.461.i, align 8, !noalias !265
  %.5.i.i = fptosi double %.462.i to i64
  %.idx562.i = mul i64 %.392.i.i, 120
  %9 = getelementptr i8, ptr %.46.i.i, i64 %.idx562.i
  %.540.i = getelementptr double, ptr %9, i64 %.440.i
  %.541.i = load double, ptr %.540.i, align 8, !noalias !265
  %.5.i567.i = fptosi double %.541.i to i64
  %.592.i = srem i64 %.5.i.i, 400
  %.2265.i = sdiv i64 %.5.i.i, 400
  %.594.i = icmp sgt i64 %.592.i, -1
  %.603.i = add nsw i64 %.592.i, 400
  %.583.0.i = select i1 %.594.i, i64 %.592.i, i64 %.603.i
  %.613.i = icmp eq i64 %.583.0.i, 0
  br i1 %.613.i, label %B196.i, label %B634.else.if.i
B196.i:
  %.360.i.i = getelementptr i8, ptr %arg.f.4, i64 608
  %.361.i.i = load i64, ptr %.360.i.i, align 8, !noalias !266
  %.362.i.i = inttoptr i64 %.361.i.i to ptr
  %10 = getelementptr i8, ptr %arg.f.4, i64 456
  %.45.i576.i = load i64, ptr %10, align 8, !noalias !269
  %.46.i577.i = inttoptr i64 %.45.i576.i to ptr
  %11 = getelementptr double, ptr %.46.i577.i, i64 %arg.i
  %.1070.i = getelementptr double, ptr %11, i64 %.439.i
  %.1071.i = load double, ptr %.1070.i, align 8, !noalias !265
  %.idx563.i = mul i64 %.392.i.i, 160
  %12 = getelementptr i8, ptr %.46.i.i, i64 %.idx563.i
  %.1151.i = getelementptr double, ptr %12, i64 %.440.i
  %.1152.i = load double, ptr %.1151.i, align 8, !noalias !265
  %.1816.i = getelementptr i8, ptr %arg.f.4, i64 240
  %.1817.i = load i64, ptr %.1816.i, align 8, !noalias !265
  %.45.i587.i = getelementptr i8, ptr %arg.f.4, i64 344
  %.46.i588.i = load i64, ptr %.45.i587.i, align 8, !noalias !272
  %.50.i.i = inttoptr i64 %.46.i588.i to ptr
  %13 = getelementptr double, ptr %.50.i.i, i64 %.1817.i
  %.1883.i = getelementptr i8, ptr %13, i64 -8
  %.1884.i = load double, ptr %.1883.i, align 8, !noalias !265
  %.1889.i = fsub double %.1071.i, %.1152.i
  %.1890.i = fsub double %.1884.i, %.1152.i
  %.1891.i = fmul double %.1890.i, 1.000000e-04
  %.1892.i = fcmp olt double %.1889.i, %.1891.i
  br i1 %.1892.i, label %B482.i, label %B482.thread.i
B482.thread.i:
  %.1991598.i = getelementptr i8, ptr %.368.i, i64 32
  %.pre.i = shl i64 %.392.i.i, 5
  br label %B564.i
B482.i:
  %.idx564.i = shl i64 %.392.i.i, 5
  %14 = getelementptr i8, ptr %.362.i.i, i64 %.idx564.i
  %15 = getelementptr i64, ptr %14, i64 %arg.i
  %.1950.i = getelementptr i64, ptr %15, i64 %.439.i
  %.1951.i = load i64, ptr %.1950.i, align 8, !noalias !265
  %.1952.not.i = icmp ne i64 %.1951.i, 0
  %.1991.i = getelementptr i8, ptr %.368.i, i64 32
  %.1992.i = load i64, ptr %.1991.i, align 8, !noalias !265
  %.1994.i = sub nsw i64 %.5.i567.i, %.1992.i
  %.2036.i = icmp sgt i64 %.1994.i, 279
  %brmerge.i = select i1 %.2036.i, i1 true, i1 %.1952.not.i
  br i1 %brmerge.i, label %B564.i, label %common.ret
B564.i:
  %.idx565.pre-phi.i = phi i64 [ %.pre.i, %B482.thread.i ], [ %.idx564.i, %B482.i ]
  %.1991605.i = phi ptr [ %.1991598.i, %B482.thread.i ], [ %.1991.i, %B482.i ]
  store i64 %.5.i567.i, ptr %.1991605.i, align 8, !noalias !265
  store double %.1071.i, ptr %.1151.i, align 8, !noalias !265
  %16 = getelementptr i8, ptr %.362.i.i, i64 %.idx565.pre-phi.i
  %17 = getelementptr i64, ptr %16, i64 %arg.i
  %.2229.i = getelementptr i64, ptr %17, i64 %.439.i
  store i64 0, ptr %.2229.i, align 8, !noalias !265
  br label %B634.else.if.i
B750.i:
  %.45.i589.i = getelementptr i8, ptr %arg.f.4, i64 400
  %.46.i590.i = load i64, ptr %.45.i589.i, align 8, !noalias !275
  %.50.i591.i = inttoptr i64 %.46.i590.i to ptr
  %.2784.i = getelementptr i8, ptr %.50.i591.i, i64 8
  %.2785.i = load double, ptr %.2784.i, align 8, !noalias !265
  %.2789.i = fcmp une double %.2785.i, 0.000000e+00
  br i1 %.2789.i, label %select.unfold, label %common.ret
B634.else.if.i:
  %18 = zext i1 %.594.i to i64
  %.2254.0.i = add nsw i64 %.2265.i, %18
  %.2288.i = mul nsw i64 %.2254.0.i, 400
  %.8.i.i = sitofp i64 %.2288.i to double
  %.9.i.i = fcmp olt double %.1579, %.8.i.i
  %.10.i.i = select i1 %.9.i.i, double %.1579, double %.8.i.i
  %.idx566.i = shl i64 %.392.i.i, 7
  %19 = getelementptr i8, ptr %.46.i.i, i64 %.idx566.i
  %.2371.i = getelementptr double, ptr %19, i64 %.440.i
  store double %.10.i.i, ptr %.2371.i, align 8, !noalias !265
  %.2382.i = sitofp i64 %.5.i.i to double
  %.2383.i = fcmp ugt double %.1579, %.2382.i
  br i1 %.2383.i, label %B750.i, label %common.ret
select.unfold:
  br label %common.ret
common.ret:
  %.13.i550.sink = phi i64 [ %.13.i550, %b108 ], [ 1, %B306.thread ], [ %ended.3.0, %B496 ], [ %ended.3.0, %B582 ], [ %ended.3.0, %B750.i ], [ 5, %select.unfold ], [ 3, %B634.else.if.i ], [ 2, %B482.i ]
  store i64 %.13.i550.sink, ptr %retptr, align 8
  ret void
}
define internal fastcc noundef i32 @v87(ptr noalias nonnull writeonly %retptr, ptr %arg.f.4, i64 %arg.i, i64 %arg.status) unnamed_addr {
entry:
  %.556 = alloca i64, align 8
  %.1456 = alloca ptr, align 8
  %.2968 = alloca ptr, align 8
  %.360.i = getelementptr i8, ptr %arg.f.4, i64 608
  %.361.i = load i64, ptr %.360.i, align 8, !noalias !278
  %.362.i = inttoptr i64 %.361.i to ptr
  %.708.i = load i64, ptr %arg.f.4, align 8, !noalias !278
  %.116 = icmp slt i64 %arg.i, 0
  %.117 = select i1 %.116, i64 %.708.i, i64 0
  %.118 = add i64 %.117, %arg.i
  %.139 = getelementptr i64, ptr %.362.i, i64 %.118
  %0 = getelementptr i64, ptr %.362.i, i64 %.708.i
  %.199 = getelementptr i64, ptr %0, i64 %.118
  %.547 = getelementptr i8, ptr %arg.f.4, i64 224
  %.1832 = getelementptr i8, ptr %arg.f.4, i64 408
  %.2179 = getelementptr i8, ptr %arg.f.4, i64 416
  %.45.i410 = getelementptr i8, ptr %arg.f.4, i64 400
  %1 = getelementptr i8, ptr %arg.f.4, i64 456
  %2 = getelementptr i8, ptr %arg.f.4, i64 448
  br label %B36
B36:
  %status.3.1 = phi i64 [ %arg.status, %entry ], [ %status.3.1.be, %B36.backedge ]
  %.140 = load i64, ptr %.139, align 8
  %.141 = icmp sgt i64 %.140, -1
  br i1 %.141, label %B74, label %B416
B74:
  %.144 = icmp eq i64 %status.3.1, 0
  br i1 %.144, label %B96, label %B382
B96:
  %.200 = load i64, ptr %.199, align 8
  %.201 = add nsw i64 %.200, 1
  %.548 = load i64, ptr %.547, align 8
  %.549 = icmp slt i64 %.201, %.548
  br i1 %.549, label %B172, label %B382
B172:
  store i64 0, ptr %.556, align 8
  call fastcc void @v72(ptr %.556, ptr nonnull %arg.f.4, i64 %arg.i)
  %.572 = load i64, ptr %.556, align 8
  %.586 = icmp eq i64 %.572, 0
  br i1 %.586, label %B226, label %B36.backedge
B226:
  %.45.i = load i64, ptr %1, align 8, !noalias !281
  %.46.i = inttoptr i64 %.45.i to ptr
  %.392.i = load i64, ptr %arg.f.4, align 8, !noalias !281
  %.978 = select i1 %.116, i64 %.392.i, i64 0
  %3 = getelementptr double, ptr %.46.i, i64 %arg.i
  %.1000 = getelementptr double, ptr %3, i64 %.978
  %.1001 = load double, ptr %.1000, align 8
  %.45.i399 = load i64, ptr %2, align 8, !noalias !284
  %.46.i400 = inttoptr i64 %.45.i399 to ptr
  %.idx = mul i64 %.392.i, 96
  %4 = getelementptr i8, ptr %.46.i400, i64 %.idx
  %5 = getelementptr double, ptr %4, i64 %arg.i
  %.1419 = getelementptr double, ptr %5, i64 %.978
  %.1420 = load double, ptr %.1419, align 8
  %.1426 = fcmp olt double %.1001, %.1420
  br i1 %.1426, label %common.ret, label %B36.backedge
common.ret:
  store ptr null, ptr %retptr, align 8
  ret i32 0
B382:
  call fastcc void @v73(ptr %.1456, ptr nonnull %arg.f.4, i64 %arg.i, i64 %status.3.1)
  br label %B416
B416:
  %.1833 = load i64, ptr %.1832, align 8
  %.2180 = load i64, ptr %.2179, align 8
  %.2181.not = icmp slt i64 %.1833, %.2180
  br i1 %.2181.not, label %B492, label %B566
B492:
  %.46.i411 = load i64, ptr %.45.i410, align 8, !noalias !287
  %.50.i = inttoptr i64 %.46.i411 to ptr
  %.2566 = getelementptr i8, ptr %.50.i, i64 8
  %.2567 = load double, ptr %.2566, align 8
  %.2571 = fcmp une double %.2567, 0.000000e+00
  br i1 %.2571, label %B566, label %B602
B566:
  %.45.i.i = load i64, ptr %2, align 8, !noalias !290
  %.46.i.i = inttoptr i64 %.45.i.i to ptr
  %.392.i.i = load i64, ptr %arg.f.4, align 8, !noalias !290
  %.728.i = getelementptr i8, ptr %arg.f.4, i64 144
  %.729.i = load i64, ptr %.728.i, align 8, !noalias !295
  %.361.i.i = load i64, ptr %.360.i, align 8, !noalias !296
  %.362.i.i = inttoptr i64 %.361.i.i to ptr
  %.819.i = select i1 %.116, i64 %.392.i.i, i64 0
  %6 = getelementptr i64, ptr %.362.i.i, i64 %arg.i
  %.841.i = getelementptr i64, ptr %6, i64 %.819.i
  store i64 -1, ptr %.841.i, align 8, !noalias !295
  %.361.i650.i = load i64, ptr %.360.i, align 8, !noalias !299
  %.362.i651.i = inttoptr i64 %.361.i650.i to ptr
  %.708.i652.i = load i64, ptr %arg.f.4, align 8, !noalias !299
  %.921.i = select i1 %.116, i64 %.708.i652.i, i64 0
  %.idx.i = shl i64 %.708.i652.i, 4
  %7 = getelementptr i8, ptr %.362.i651.i, i64 %.idx.i
  %8 = getelementptr i64, ptr %7, i64 %arg.i
  %.943.i = getelementptr i64, ptr %8, i64 %.921.i
  store i64 0, ptr %.943.i, align 8, !noalias !295
  %.981.i = add i64 %.819.i, %arg.i
  %.idx636.i = shl i64 %.392.i.i, 6
  %9 = getelementptr i8, ptr %.46.i.i, i64 %.idx636.i
  %.1002.i = getelementptr double, ptr %9, i64 %.981.i
  store double 1.000000e-09, ptr %.1002.i, align 8, !noalias !295
  %.idx637.i = mul i64 %.392.i.i, 96
  %10 = getelementptr i8, ptr %.46.i.i, i64 %.idx637.i
  %.1056.i = getelementptr double, ptr %10, i64 %.981.i
  store double 0x7FF0000000000000, ptr %.1056.i, align 8, !noalias !295
  %.idx638.i = mul i64 %.392.i.i, 80
  %11 = getelementptr i8, ptr %.46.i.i, i64 %.idx638.i
  %.1110.i = getelementptr double, ptr %11, i64 %.981.i
  store double 0x7FF0000000000000, ptr %.1110.i, align 8, !noalias !295
  %.idx639.i = mul i64 %.392.i.i, 104
  %12 = getelementptr i8, ptr %.46.i.i, i64 %.idx639.i
  %.1164.i = getelementptr double, ptr %12, i64 %.981.i
  store double 0x7FF0000000000000, ptr %.1164.i, align 8, !noalias !295
  %.idx640.i = shl i64 %.392.i.i, 7
  %13 = getelementptr i8, ptr %.46.i.i, i64 %.idx640.i
  %.1218.i = getelementptr double, ptr %13, i64 %.981.i
  store double 0x7FF0000000000000, ptr %.1218.i, align 8, !noalias !295
  %.1570.i = getelementptr i8, ptr %arg.f.4, i64 424
  %.1571.i = load i64, ptr %.1570.i, align 8, !noalias !295
  %.1572.i = add nsw i64 %.1571.i, -1
  store i64 %.1572.i, ptr %.1570.i, align 8, !noalias !295
  %.2265.i = getelementptr i8, ptr %arg.f.4, i64 128
  %.2266.i = load i64, ptr %.2265.i, align 8, !noalias !295
  %.2909.i = shl nsw i64 %.729.i, 2
  %.3897.i = getelementptr i8, ptr %arg.f.4, i64 136
  %.3898.i = load i64, ptr %.3897.i, align 8, !noalias !295
  %.3899.i = shl nsw i64 %.3898.i, 1
  %.4566.i = getelementptr i8, ptr %arg.f.4, i64 160
  %.4567.i = load i64, ptr %.4566.i, align 8, !noalias !295
  %.4913.i = getelementptr i8, ptr %arg.f.4, i64 168
  %.4914.i = load i64, ptr %.4913.i, align 8, !noalias !295
  %.4915.i = add nsw i64 %.4914.i, %.4567.i
  %.5261.i = getelementptr i8, ptr %arg.f.4, i64 192
  %.5262.i = load i64, ptr %.5261.i, align 8, !noalias !295
  %.5263.i = add nsw i64 %.4915.i, %.5262.i
  br label %B728.if.i
B728.loopexit.i:
  %exitcond676.not.i = icmp eq i64 %.5451.i, 6
  br i1 %exitcond676.not.i, label %common.ret, label %B728.if.i
B730.i:
  %.pn.i = phi i64 [ 62, %switch.5.i ], [ 59, %switch.1.i ], [ 60, %switch.2.i ], [ 61, %switch.3.i ], [ 71, %switch.4.i ], [ 58, %B728.if.i ]
  %.2266.pn.i = phi i64 [ %.5263.i, %switch.5.i ], [ %.729.i, %switch.1.i ], [ %.2909.i, %switch.2.i ], [ %.729.i, %switch.3.i ], [ %.3899.i, %switch.4.i ], [ %.2266.i, %B728.if.i ]
  %.5451.i = add nuw nsw i64 %.5307.0675.i, 1
  %14 = getelementptr i64, ptr %arg.f.4, i64 %.pn.i
  %.45.i661.i = load i64, ptr %14, align 8, !noalias !302
  %.46.i662.i = inttoptr i64 %.45.i661.i to ptr
  %.392.i663.i = load i64, ptr %arg.f.4, align 8, !noalias !302
  %.5626672.not.i = icmp slt i64 %.2266.pn.i, 1
  br i1 %.5626672.not.i, label %B728.loopexit.i, label %B800.if.lr.ph.i
B800.if.lr.ph.i:
  %.5747.i = select i1 %.116, i64 %.392.i663.i, i64 0
  br label %B800.if.i
B728.if.i:
  %.5307.0675.i = phi i64 [ 0, %B566 ], [ %.5451.i, %B728.loopexit.i ]
  switch i64 %.5307.0675.i, label %default.unreachable.i [
    i64 0, label %B730.i
    i64 3, label %switch.3.i
    i64 1, label %switch.1.i
    i64 5, label %switch.5.i
    i64 2, label %switch.2.i
    i64 4, label %switch.4.i
  ]
default.unreachable.i:
  unreachable
switch.1.i:
  br label %B730.i
switch.2.i:
  br label %B730.i
switch.3.i:
  br label %B730.i
switch.4.i:
  br label %B730.i
switch.5.i:
  br label %B730.i
B800.if.i:
  %.5570.0673.i = phi i64 [ 0, %B800.if.lr.ph.i ], [ %.5639.i, %B800.if.i ]
  %.5639.i = add nuw nsw i64 %.5570.0673.i, 1
  %.5712.i = mul i64 %.5570.0673.i, %.392.i663.i
  %.5716.i = getelementptr double, ptr %.46.i662.i, i64 %.5712.i
  %.5717.i = load double, ptr %.5716.i, align 8, !noalias !295
  %15 = getelementptr double, ptr %.5716.i, i64 %arg.i
  %.5769.i = getelementptr double, ptr %15, i64 %.5747.i
  store double %.5717.i, ptr %.5769.i, align 8, !noalias !295
  %exitcond.not.i = icmp eq i64 %.5639.i, %.2266.pn.i
  br i1 %exitcond.not.i, label %B728.loopexit.i, label %B800.if.i
B602:
  call fastcc void @v74(ptr %.2968, ptr nonnull %arg.f.4, i64 %arg.i, i64 %.1833)
  %.3340 = load i64, ptr %.1832, align 8
  %.3341 = add nsw i64 %.3340, 1
  store i64 %.3341, ptr %.1832, align 8
  br label %B36.backedge
B36.backedge:
  %status.3.1.be = phi i64 [ 0, %B602 ], [ %.572, %B226 ], [ %.572, %B172 ]
  br label %B36
}
define internal fastcc void @v88(ptr noalias nonnull writeonly %retptr, ptr readonly %arg.f.4, i64 %arg.i, double %arg.t, double %arg.h) unnamed_addr {
entry:
  %.20 = alloca { [5 x i64], { { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, double, double, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, i8 }, { { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] } }, [13 x { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }], { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, align 8
  %.fca.1.1.4.gep = getelementptr inbounds i8, ptr %.20, i64 128
  %.fca.1.3.2.gep = getelementptr inbounds i8, ptr %.20, i64 224
  %.fca.2.2.gep56 = getelementptr inbounds i8, ptr %.20, i64 448
  %.fca.3.0.0.gep = getelementptr inbounds i8, ptr %.20, i64 528
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(521) %.20, i8 0, i64 521, i1 false)
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(1280) %.fca.3.0.0.gep, i8 0, i64 1280, i1 false)
  call fastcc void @v77(ptr %.20, ptr %arg.f.4, i64 %arg.i)
  %.36.fca.1.1.4.load = load ptr, ptr %.fca.1.1.4.gep, align 8
  %.36.fca.1.3.2.load = load i64, ptr %.fca.1.3.2.gep, align 8
  %.36.fca.2.2.load = load double, ptr %.fca.2.2.gep56, align 8
  %.360.i.i = getelementptr i8, ptr %arg.f.4, i64 608
  %.361.i.i = load i64, ptr %.360.i.i, align 8, !noalias !305
  %.362.i.i = inttoptr i64 %.361.i.i to ptr
  %.708.i.i = load i64, ptr %arg.f.4, align 8, !noalias !305
  %.95.i = icmp slt i64 %arg.i, 0
  %.96.i = select i1 %.95.i, i64 %.708.i.i, i64 0
  %0 = getelementptr i64, ptr %.362.i.i, i64 %.708.i.i
  %1 = getelementptr i64, ptr %0, i64 %arg.i
  %.118.i = getelementptr i64, ptr %1, i64 %.96.i
  %.119.i = load i64, ptr %.118.i, align 8, !noalias !310
  %.470.i = getelementptr i8, ptr %arg.f.4, i64 224
  %.471.i = load i64, ptr %.470.i, align 8, !noalias !310
  %.1192.i = add nsw i64 %.119.i, 1
  %.1194.i = icmp slt i64 %.1192.i, %.471.i
  br i1 %.1194.i, label %B204.i, label %B226.i
B204.i:
  %.45.i.i = getelementptr i8, ptr %arg.f.4, i64 304
  %.46.i.i = load i64, ptr %.45.i.i, align 8, !noalias !311
  %.50.i.i = inttoptr i64 %.46.i.i to ptr
  %.1211.i = icmp slt i64 %.119.i, -1
  %.1212.i = select i1 %.1211.i, i64 %.471.i, i64 0
  %2 = getelementptr double, ptr %.50.i.i, i64 %.1192.i
  %.1226.i = getelementptr double, ptr %2, i64 %.1212.i
  br label %B322.i
B226.i:
  %.1895.i = getelementptr i8, ptr %arg.f.4, i64 240
  %.1896.i = load i64, ptr %.1895.i, align 8, !noalias !310
  %.45.i376.i = getelementptr i8, ptr %arg.f.4, i64 344
  %.46.i377.i = load i64, ptr %.45.i376.i, align 8, !noalias !314
  %.50.i378.i = inttoptr i64 %.46.i377.i to ptr
  %3 = getelementptr double, ptr %.50.i378.i, i64 %.1896.i
  %.1962.i = getelementptr i8, ptr %3, i64 -8
  br label %B322.i
B322.i:
  %"$phi322.0.2.0.in.i" = phi ptr [ %.1226.i, %B204.i ], [ %.1962.i, %B226.i ]
  %"$phi322.0.2.0.i" = load double, ptr %"$phi322.0.2.0.in.i", align 8, !noalias !310
  %4 = getelementptr i8, ptr %arg.f.4, i64 448
  %.45.i = load i64, ptr %4, align 8, !noalias !317
  %.46.i = inttoptr i64 %.45.i to ptr
  %.idx = mul i64 %.708.i.i, 144
  %5 = getelementptr i8, ptr %.46.i, i64 %.idx
  %6 = getelementptr double, ptr %5, i64 %arg.i
  %.920 = getelementptr double, ptr %6, i64 %.96.i
  %.921 = load double, ptr %.920, align 8
  %.1271 = getelementptr i8, ptr %arg.f.4, i64 248
  %.1272 = load i64, ptr %.1271, align 8
  %.1276 = icmp sgt i64 %.1272, 0
  %.12.i.i = fcmp olt double %.36.fca.2.2.load, %arg.h
  %.13.i.i = select i1 %.12.i.i, double %.36.fca.2.2.load, double %arg.h
  %.598.i = icmp sgt i64 %.36.fca.1.3.2.load, 0
  br i1 %.598.i, label %B78.if.i.i, label %b109
B78.if.i.i:
  %first.2.0129.i.i = phi double [ %.13.i.i.i, %B78.if.i.i ], [ 0x7FF0000000000000, %B322.i ]
  %.106.0128.i.i = phi i64 [ %.177.i.i, %B78.if.i.i ], [ 0, %B322.i ]
  %.177.i.i = add nuw nsw i64 %.106.0128.i.i, 1
  %7 = getelementptr double, ptr %.36.fca.1.1.4.load, i64 %.106.0128.i.i
  %.235.i.i = load double, ptr %7, align 8, !noalias !320
  %.12.i.i.i = fcmp olt double %.235.i.i, %first.2.0129.i.i
  %.13.i.i.i = select i1 %.12.i.i.i, double %.235.i.i, double %first.2.0129.i.i
  %exitcond.not.i.i = icmp eq i64 %.36.fca.1.3.2.load, %.177.i.i
  br i1 %exitcond.not.i.i, label %b110, label %B78.if.i.i
b110:
  %.5.i.i = fmul double %"$phi322.0.2.0.i", 0x3D06849B86A12B9B
  %.6.i.i = fadd double %.5.i.i, 1.000000e-15
  %.818.i288 = fsub double %"$phi322.0.2.0.i", %.6.i.i
  %.820.i = fcmp uge double %.13.i.i.i, %.818.i288
  %brmerge.i = select i1 %.820.i, i1 true, i1 %.1276
  %arg.segment.1.mux.i = select i1 %.820.i, double %"$phi322.0.2.0.i", double %.13.i.i.i
  br i1 %brmerge.i, label %b109, label %B200.i
B200.i:
  %.830.i = fsub double %.13.i.i.i, %arg.t
  %.833.i = fsub double %arg.t, %.921
  %.834.i = fcmp ult double %.830.i, %.833.i
  br i1 %.834.i, label %B232.i, label %b109
B232.i:
  %.12.i999.i = fcmp olt double %.833.i, %.13.i.i
  %.13.i1000.i = select i1 %.12.i999.i, double %.833.i, double %.13.i.i
  br label %b109
b109:
  %desired.2.0.sink.i = phi double [ %.13.i.i, %B322.i ], [ %.13.i.i, %B200.i ], [ %.13.i1000.i, %B232.i ], [ %.13.i.i, %b110 ]
  %arg.segment.1.sink.i = phi double [ %"$phi322.0.2.0.i", %B322.i ], [ %.13.i.i.i, %B200.i ], [ %"$phi322.0.2.0.i", %B232.i ], [ %arg.segment.1.mux.i, %b110 ]
  store double %desired.2.0.sink.i, ptr %retptr, align 8
  %retptr.repack286 = getelementptr inbounds i8, ptr %retptr, i64 8
  store double %arg.segment.1.sink.i, ptr %retptr.repack286, align 8
  ret void
}
define internal fastcc void @v83(ptr noalias nonnull writeonly %retptr, ptr readonly %arg.f.4, i64 %arg.i, i64 %arg.run) unnamed_addr {
entry:
  %.770 = alloca { [5 x i64], { { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, double, double, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, i8 }, { { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] } }, [13 x { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }], { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, align 8
  %.fca.3.0.0.gep = getelementptr inbounds i8, ptr %.770, i64 528
  %.fca.5.0.2.gep = getelementptr inbounds i8, ptr %.770, i64 872
  %.fca.5.0.4.gep = getelementptr inbounds i8, ptr %.770, i64 888
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(521) %.770, i8 0, i64 521, i1 false)
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(1280) %.fca.3.0.0.gep, i8 0, i64 1280, i1 false)
  %.3728 = alloca ptr, align 8
  %.370 = load i64, ptr %arg.f.4, align 8
  %.716 = getelementptr i8, ptr %arg.f.4, i64 240
  %.717 = load i64, ptr %.716, align 8
  %.360.i.i = getelementptr i8, ptr %arg.f.4, i64 608
  %.361.i.i = load i64, ptr %.360.i.i, align 8, !noalias !325
  %.362.i.i = inttoptr i64 %.361.i.i to ptr
  %.95.i = icmp slt i64 %arg.i, 0
  %.96.i = select i1 %.95.i, i64 %.370, i64 0
  %0 = getelementptr i64, ptr %.362.i.i, i64 %.370
  %1 = getelementptr i64, ptr %0, i64 %arg.i
  %.118.i = getelementptr i64, ptr %1, i64 %.96.i
  %.119.i = load i64, ptr %.118.i, align 8, !noalias !330
  %.470.i = getelementptr i8, ptr %arg.f.4, i64 224
  %.471.i = load i64, ptr %.470.i, align 8, !noalias !330
  %.817.i = getelementptr i8, ptr %arg.f.4, i64 144
  %.818.i = load i64, ptr %.817.i, align 8, !noalias !330
  %.45.i384.i = getelementptr i8, ptr %arg.f.4, i64 312
  %.46.i385.i = load i64, ptr %.45.i384.i, align 8, !noalias !331
  %.50.i386.i = inttoptr i64 %.46.i385.i to ptr
  %.2348.i = icmp slt i64 %.119.i, 0
  %.2349.i = select i1 %.2348.i, i64 %.471.i, i64 0
  %2 = getelementptr i64, ptr %.50.i386.i, i64 %.119.i
  %.2363.i = getelementptr i64, ptr %2, i64 %.2349.i
  %.2364.i = load i64, ptr %.2363.i, align 8, !noalias !330
  %.2713.i = getelementptr i8, ptr %arg.f.4, i64 264
  %.2714.i = load i64, ptr %.2713.i, align 8, !noalias !330
  %.2715.i = icmp sgt i64 %.2714.i, 0
  br i1 %.2715.i, label %B432.i, label %b92
B432.i:
  %.3065.i = getelementptr i8, ptr %arg.f.4, i64 232
  %.3066.i = load i64, ptr %.3065.i, align 8, !noalias !330
  %.3068.i = mul nsw i64 %.3066.i, %arg.i
  br label %b92
b92:
  %"$phi476.1.2.0.i" = phi i64 [ %.3068.i, %B432.i ], [ 0, %entry ]
  %.3082.i = add nsw i64 %"$phi476.1.2.0.i", %.2364.i
  %.3470.i = getelementptr i8, ptr %arg.f.4, i64 320
  %.3471.i = load i64, ptr %.3470.i, align 8, !noalias !330
  %.3478.i = mul nsw i64 %.818.i, 56
  %.3479.i = mul nsw i64 %.3478.i, %.3082.i
  %.3480.i = add nsw i64 %.3479.i, %.3471.i
  %.3481.i = inttoptr i64 %.3480.i to ptr
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(1280) %.fca.3.0.0.gep, i8 0, i64 1280, i1 false)
  call fastcc void @v77(ptr %.770, ptr nonnull %arg.f.4, i64 %arg.i)
  %.786.fca.5.0.2.load = load i64, ptr %.fca.5.0.2.gep, align 8
  %.786.fca.5.0.4.load = load ptr, ptr %.fca.5.0.4.gep, align 8
  %.361.i = getelementptr i8, ptr %arg.f.4, i64 392
  %.362.i = load i64, ptr %.361.i, align 8, !noalias !334
  %.366.i = mul nsw i64 %arg.run, 48
  %.367.i = add nsw i64 %.362.i, %.366.i
  %.368.i = inttoptr i64 %.367.i to ptr
  %.1886 = add nsw i64 %.717, %.370
  %.45.i = getelementptr i8, ptr %arg.f.4, i64 344
  %.46.i = load i64, ptr %.45.i, align 8, !noalias !337
  %.50.i = inttoptr i64 %.46.i to ptr
  %3 = getelementptr i8, ptr %arg.f.4, i64 448
  %.45.i673 = load i64, ptr %3, align 8, !noalias !340
  %.46.i674 = inttoptr i64 %.45.i673 to ptr
  %.392.i = load i64, ptr %arg.f.4, align 8, !noalias !340
  %.2315 = select i1 %.95.i, i64 %.392.i, i64 0
  %.idx = mul i64 %.392.i, 168
  %4 = getelementptr i8, ptr %.46.i674, i64 %.idx
  %5 = getelementptr double, ptr %4, i64 %arg.i
  %.2337 = getelementptr double, ptr %5, i64 %.2315
  %.2338 = load double, ptr %.2337, align 8
  %.2399 = getelementptr i8, ptr %.368.i, i64 16
  %.2400 = load i64, ptr %.2399, align 8
  %.2414 = icmp slt i64 %.2400, 0
  %.2415 = select i1 %.2414, i64 %.1886, i64 0
  %6 = getelementptr double, ptr %.50.i, i64 %.2400
  %.2429 = getelementptr double, ptr %6, i64 %.2415
  %.2430 = load double, ptr %.2429, align 8
  %.2432 = fcmp olt double %.2430, %.2338
  br i1 %.2432, label %B382.preheader, label %common.ret
B382.preheader:
  %.3376 = getelementptr i8, ptr %arg.f.4, i64 80
  %.2517683.not = icmp slt i64 %.370, 1
  %.3723 = getelementptr i8, ptr %arg.f.4, i64 600
  %.148211.not.i = icmp slt i64 %.786.fca.5.0.2.load, 1
  br label %B382
B382:
  br i1 %.2517683.not, label %B586, label %B412.if
B586:
  %.3377 = load i64, ptr %.3376, align 8
  %.3724 = load i64, ptr %.3723, align 8
  call fastcc void @v84(ptr %.3728, ptr nonnull %arg.f.4, i64 %arg.i, i64 %arg.run, i64 %.3377, i64 %.3724)
  %.3783 = load i64, ptr %.2399, align 8
  %.3797 = icmp slt i64 %.3783, 0
  %.3798 = select i1 %.3797, i64 %.1886, i64 0
  %7 = getelementptr double, ptr %.50.i, i64 %.3783
  %.3812 = getelementptr double, ptr %7, i64 %.3798
  %.3813 = load double, ptr %.3812, align 8
  %.3815 = fcmp olt double %.3813, %.2338
  br i1 %.3815, label %B382, label %common.ret
common.ret:
  store ptr null, ptr %retptr, align 8
  ret void
B412.if:
  %.2461.0684 = phi i64 [ %.2530, %b99 ], [ 0, %B382 ]
  %.2530 = add nuw nsw i64 %.2461.0684, 1
  %.2584 = load i64, ptr %.2399, align 8
  %.2585 = add nsw i64 %.2584, %.2461.0684
  %.2599 = icmp slt i64 %.2585, 0
  %.2600 = select i1 %.2599, i64 %.1886, i64 0
  %8 = getelementptr double, ptr %.50.i, i64 %.2585
  %.2614 = getelementptr double, ptr %8, i64 %.2600
  %.2615 = load double, ptr %.2614, align 8
  %.12.i = fcmp olt double %.2338, %.2615
  %.13.i = select i1 %.12.i, double %.2338, double %.2615
  br i1 %.148211.not.i, label %b99, label %B58.if.i
B164.i:
  %.44.i.i = getelementptr i8, ptr %10, i64 24
  %.45.i.i676 = load double, ptr %.44.i.i, align 8, !noalias !343
  %.73.i.i = getelementptr i8, ptr %10, i64 32
  %.74.i.i = load double, ptr %.73.i.i, align 8, !noalias !343
  %.75.i.i = fmul double %.74.i.i, 5.000000e-01
  %.76.i.i = fmul double %.245.i, %.75.i.i
  %.77.i.i = fadd double %.45.i.i676, %.76.i.i
  %.78.i.i = fmul double %.245.i, %.77.i.i
  %.87.le.i.i = tail call double @llvm.floor.f64(double %.78.i.i)
  %.92.i.i = fsub double %.78.i.i, %.87.le.i.i
  %.93.i.i = fmul double %.92.i.i, 0x401921FB54442D18
  %.121.i.i = getelementptr i8, ptr %10, i64 40
  %.122.i.i = load double, ptr %.121.i.i, align 8, !noalias !343
  %.126.i.i = fadd double %.122.i.i, %.93.i.i
  %.593.le.i = tail call double @llvm.sin.f64(double %.126.i.i)
  %.598.i = fmul double %.423.i, %.593.le.i
  %.600.i = fadd double %.361.i675, %.598.i
  br label %B272.i
B272.i:
  %value.2.1.i = phi double [ %.600.i, %B164.i ], [ %.361.i675, %B58.if.i ]
  %9 = getelementptr double, ptr %.786.fca.5.0.4.load, i64 %.90.0213.i
  store double %value.2.1.i, ptr %9, align 8, !noalias !348
  %exitcond.not.i = icmp eq i64 %.786.fca.5.0.2.load, %.161.i
  br i1 %exitcond.not.i, label %b103, label %B58.if.i
B58.if.i:
  %.90.0213.i = phi i64 [ %.161.i, %B272.i ], [ 0, %B412.if ]
  %.161.i = add nuw nsw i64 %.90.0213.i, 1
  %.idx682 = mul i64 %.90.0213.i, 56
  %10 = getelementptr i8, ptr %.3481.i, i64 %.idx682
  %.242.i = getelementptr i8, ptr %10, i64 48
  %.243.i = load double, ptr %.242.i, align 8, !noalias !348
  %.245.i = fsub double %.13.i, %.243.i
  %.303.i = load double, ptr %10, align 8, !noalias !348
  %.357.i = getelementptr i8, ptr %10, i64 8
  %.358.i = load double, ptr %.357.i, align 8, !noalias !348
  %.360.i = fmul double %.245.i, %.358.i
  %.361.i675 = fadd double %.303.i, %.360.i
  %.422.i = getelementptr i8, ptr %10, i64 16
  %.423.i = load double, ptr %.422.i, align 8, !noalias !348
  %.424.i = fcmp une double %.423.i, 0.000000e+00
  br i1 %.424.i, label %B164.i, label %B272.i
b103:
  %.392.i.i = load i64, ptr %arg.f.4, align 8, !noalias !349
  %.45.i.i677 = load i64, ptr %.3723, align 8, !noalias !349
  %.46.i.i678 = inttoptr i64 %.45.i.i677 to ptr
  %invariant.gep.i = getelementptr double, ptr %.46.i.i678, i64 %.2461.0684
  br label %B76.if.i
B76.if.i:
  %.119.0118.i = phi i64 [ 0, %b103 ], [ %.188.i, %B76.if.i ]
  %.188.i = add nuw nsw i64 %.119.0118.i, 1
  %11 = getelementptr double, ptr %.786.fca.5.0.4.load, i64 %.119.0118.i
  %.242.i679 = load double, ptr %11, align 8, !noalias !354
  %.290.i = mul i64 %.119.0118.i, %.392.i.i
  %gep121.i = getelementptr double, ptr %invariant.gep.i, i64 %.290.i
  store double %.242.i679, ptr %gep121.i, align 8, !noalias !354
  %exitcond.not.i680 = icmp eq i64 %.188.i, %.786.fca.5.0.2.load
  br i1 %exitcond.not.i680, label %b99, label %B76.if.i
b99:
  %exitcond.not = icmp eq i64 %.370, %.2530
  br i1 %exitcond.not, label %B586, label %B412.if
}
define internal fastcc void @v84(ptr noalias nonnull writeonly initializes((0, 8)) %retptr, ptr readonly %arg.f.4, i64 %arg.i, i64 %arg.run, i64 %arg.function, i64 %arg.u) unnamed_addr {
entry:
  %.365 = getelementptr i8, ptr %arg.f.4, i64 344
  %.366 = load i64, ptr %.365, align 8
  %.361.i = getelementptr i8, ptr %arg.f.4, i64 440
  %.362.i = load i64, ptr %.361.i, align 8, !noalias !355
  %.707.i = getelementptr i8, ptr %arg.f.4, i64 432
  %.708.i = load i64, ptr %.707.i, align 8, !noalias !355
  %.709.i = sub nsw i64 %arg.run, %.708.i
  %.710.i = shl nsw i64 %.709.i, 3
  %.1055.i = getelementptr i8, ptr %arg.f.4, i64 152
  %.1056.i = load i64, ptr %.1055.i, align 8, !noalias !355
  %.1057.i = mul nsw i64 %.710.i, %.1056.i
  %.1402.i = getelementptr i8, ptr %arg.f.4, i64 240
  %.1403.i = load i64, ptr %.1402.i, align 8, !noalias !355
  %.1407.i = mul nsw i64 %.1057.i, %.1403.i
  %.1408.i = add nsw i64 %.1407.i, %.362.i
  %.20 = shl nsw i64 %arg.i, 3
  %.740 = getelementptr i8, ptr %arg.f.4, i64 392
  %.741 = load i64, ptr %.740, align 8
  %.742 = mul nsw i64 %arg.run, 48
  %.743 = add i64 %.742, 16
  %.745 = add i64 %.743, %.741
  %.1090 = getelementptr i8, ptr %arg.f.4, i64 336
  %.1091 = load i64, ptr %.1090, align 8
  %.1436 = getelementptr i8, ptr %arg.f.4, i64 448
  %.1437 = load i64, ptr %.1436, align 8
  %.1784 = load i64, ptr %arg.f.4, align 8
  %.1785 = mul nsw i64 %.1784, 168
  %.1786 = add i64 %.1437, %.20
  %.1787 = add i64 %.1786, %.1785
  %.2132 = getelementptr i8, ptr %arg.f.4, i64 456
  %.2133 = load i64, ptr %.2132, align 8
  %.2134 = add nsw i64 %.2133, %.20
  %.2479 = getelementptr i8, ptr %arg.f.4, i64 464
  %.2480 = load i64, ptr %.2479, align 8
  %.2481 = add nsw i64 %.2480, %.20
  %.2826 = getelementptr i8, ptr %arg.f.4, i64 552
  %.2827 = load i64, ptr %.2826, align 8
  %.2828 = add nsw i64 %.2827, %.20
  %.3173 = getelementptr i8, ptr %arg.f.4, i64 560
  %.3174 = load i64, ptr %.3173, align 8
  %.3175 = add nsw i64 %.3174, %.20
  %.3520 = getelementptr i8, ptr %arg.f.4, i64 496
  %.3521 = load i64, ptr %.3520, align 8
  %.3525 = add nsw i64 %.3521, %.20
  %.3526 = inttoptr i64 %arg.function to ptr
  tail call void %.3526(i64 %.366, i64 %.1408.i, i64 %.745, i64 %.1091, i64 %.1787, i64 %.2134, i64 %.2481, i64 %.2828, i64 %.3175, i64 %arg.u, i64 %.3525)
  store ptr null, ptr %retptr, align 8
  ret void
}
define internal fastcc void @v81(ptr noalias nonnull writeonly %retptr, ptr readonly %arg.f.4, i64 %arg.i, double %arg.t, double %arg.h, double %arg.end) unnamed_addr {
entry:
  %.33 = alloca { [5 x i64], { { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, double, double, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, i8 }, { { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] } }, [13 x { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }], { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, align 8
  %.fca.0.3.gep = getelementptr inbounds i8, ptr %.33, i64 24
  %.fca.0.4.gep = getelementptr inbounds i8, ptr %.33, i64 32
  %.fca.1.0.4.gep = getelementptr inbounds i8, ptr %.33, i64 72
  %.fca.1.1.2.gep = getelementptr inbounds i8, ptr %.33, i64 112
  %.fca.1.1.4.gep = getelementptr inbounds i8, ptr %.33, i64 128
  %.fca.1.2.4.gep = getelementptr inbounds i8, ptr %.33, i64 184
  %.fca.1.3.2.gep = getelementptr inbounds i8, ptr %.33, i64 224
  %.fca.1.3.4.gep = getelementptr inbounds i8, ptr %.33, i64 240
  %.fca.1.4.4.gep = getelementptr inbounds i8, ptr %.33, i64 296
  %.fca.2.1.2.gep = getelementptr inbounds i8, ptr %.33, i64 408
  %.fca.3.0.0.gep = getelementptr inbounds i8, ptr %.33, i64 528
  %.fca.3.0.2.gep = getelementptr inbounds i8, ptr %.33, i64 544
  %.fca.3.0.4.gep = getelementptr inbounds i8, ptr %.33, i64 560
  %.fca.3.0.5.0.gep = getelementptr inbounds i8, ptr %.33, i64 568
  %.fca.3.1.4.gep = getelementptr inbounds i8, ptr %.33, i64 616
  %.fca.3.1.5.1.gep = getelementptr inbounds i8, ptr %.33, i64 632
  %.fca.3.2.2.gep = getelementptr inbounds i8, ptr %.33, i64 672
  %.fca.3.2.4.gep = getelementptr inbounds i8, ptr %.33, i64 688
  %.fca.4.0.4.gep = getelementptr inbounds i8, ptr %.33, i64 744
  %.fca.4.0.5.1.gep = getelementptr inbounds i8, ptr %.33, i64 760
  %.fca.4.1.4.gep = getelementptr inbounds i8, ptr %.33, i64 816
  %.fca.4.1.5.0.gep = getelementptr inbounds i8, ptr %.33, i64 824
  %.fca.4.1.5.1.gep = getelementptr inbounds i8, ptr %.33, i64 832
  %.fca.5.0.2.gep = getelementptr inbounds i8, ptr %.33, i64 872
  %.fca.5.0.4.gep = getelementptr inbounds i8, ptr %.33, i64 888
  %.fca.5.3.4.gep = getelementptr inbounds i8, ptr %.33, i64 1056
  %.fca.5.6.4.gep = getelementptr inbounds i8, ptr %.33, i64 1224
  %.fca.5.6.5.0.gep = getelementptr inbounds i8, ptr %.33, i64 1232
  %.fca.5.10.2.gep = getelementptr inbounds i8, ptr %.33, i64 1432
  %.fca.5.10.4.gep = getelementptr inbounds i8, ptr %.33, i64 1448
  %.fca.5.11.2.gep = getelementptr inbounds i8, ptr %.33, i64 1488
  %.fca.5.11.4.gep = getelementptr inbounds i8, ptr %.33, i64 1504
  %.fca.5.11.5.0.gep = getelementptr inbounds i8, ptr %.33, i64 1512
  %.fca.5.12.2.gep = getelementptr inbounds i8, ptr %.33, i64 1544
  %.fca.5.12.4.gep = getelementptr inbounds i8, ptr %.33, i64 1560
  %.fca.6.2.gep = getelementptr inbounds i8, ptr %.33, i64 1600
  %.fca.6.4.gep = getelementptr inbounds i8, ptr %.33, i64 1616
  %.fca.9.4.gep = getelementptr inbounds i8, ptr %.33, i64 1784
  %.2605 = alloca { i64, double }, align 8
  %.fca.1.gep324 = getelementptr inbounds i8, ptr %.2605, i64 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %.2605, i8 0, i64 16, i1 false)
  %.2894 = alloca double, align 8
  store double 0.000000e+00, ptr %.2894, align 8
  %.3020 = alloca ptr, align 8
  store ptr null, ptr %.3020, align 8
  %.4243 = alloca i8, align 1
  store i8 0, ptr %.4243, align 1
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(521) %.33, i8 0, i64 521, i1 false)
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(1280) %.fca.3.0.0.gep, i8 0, i64 1280, i1 false)
  call fastcc void @v77(ptr %.33, ptr %arg.f.4, i64 %arg.i)
  %.49.fca.0.3.load = load i64, ptr %.fca.0.3.gep, align 8
  %.49.fca.0.4.load = load i64, ptr %.fca.0.4.gep, align 8
  %.49.fca.1.0.4.load = load ptr, ptr %.fca.1.0.4.gep, align 8
  %.49.fca.1.1.2.load = load i64, ptr %.fca.1.1.2.gep, align 8
  %.49.fca.1.1.4.load = load ptr, ptr %.fca.1.1.4.gep, align 8
  %.49.fca.1.2.4.load = load ptr, ptr %.fca.1.2.4.gep, align 8
  %.49.fca.1.3.2.load = load i64, ptr %.fca.1.3.2.gep, align 8
  %.49.fca.1.3.4.load = load ptr, ptr %.fca.1.3.4.gep, align 8
  %.49.fca.1.4.4.load = load ptr, ptr %.fca.1.4.4.gep, align 8
  %.49.fca.2.1.2.load = load i64, ptr %.fca.2.1.2.gep, align 8
  %.49.fca.3.0.2.load = load i64, ptr %.fca.3.0.2.gep, align 8
  %.49.fca.3.0.4.load = load ptr, ptr %.fca.3.0.4.gep, align 8
  %.49.fca.3.0.5.0.load = load i64, ptr %.fca.3.0.5.0.gep, align 8
  %.49.fca.3.1.4.load = load ptr, ptr %.fca.3.1.4.gep, align 8
  %.49.fca.3.1.5.1.load = load i64, ptr %.fca.3.1.5.1.gep, align 8
  %.49.fca.3.2.2.load = load i64, ptr %.fca.3.2.2.gep, align 8
  %.49.fca.3.2.4.load = load ptr, ptr %.fca.3.2.4.gep, align 8
  %.49.fca.4.0.4.load = load ptr, ptr %.fca.4.0.4.gep, align 8
  %.49.fca.4.0.5.1.load = load i64, ptr %.fca.4.0.5.1.gep, align 8
  %.49.fca.4.1.4.load = load ptr, ptr %.fca.4.1.4.gep, align 8
  %.49.fca.4.1.5.0.load = load i64, ptr %.fca.4.1.5.0.gep, align 8
  %.49.fca.4.1.5.1.load = load i64, ptr %.fca.4.1.5.1.gep, align 8
  %.49.fca.5.0.2.load = load i64, ptr %.fca.5.0.2.gep, align 8
  %.49.fca.5.0.4.load = load ptr, ptr %.fca.5.0.4.gep, align 8
  %.49.fca.5.3.4.load = load ptr, ptr %.fca.5.3.4.gep, align 8
  %.49.fca.5.6.4.load = load ptr, ptr %.fca.5.6.4.gep, align 8
  %.49.fca.5.6.5.0.load = load i64, ptr %.fca.5.6.5.0.gep, align 8
  %.49.fca.5.10.2.load = load i64, ptr %.fca.5.10.2.gep, align 8
  %.49.fca.5.10.4.load = load ptr, ptr %.fca.5.10.4.gep, align 8
  %.49.fca.5.11.2.load = load i64, ptr %.fca.5.11.2.gep, align 8
  %.49.fca.5.11.4.load = load ptr, ptr %.fca.5.11.4.gep, align 8
  %.49.fca.5.11.5.0.load = load i64, ptr %.fca.5.11.5.0.gep, align 8
  %.49.fca.5.12.2.load = load i64, ptr %.fca.5.12.2.gep, align 8
  %.49.fca.5.12.4.load = load ptr, ptr %.fca.5.12.4.gep, align 8
  %.49.fca.6.2.load = load i64, ptr %.fca.6.2.gep, align 8
  %.49.fca.6.4.load = load ptr, ptr %.fca.6.4.gep, align 8
  %.49.fca.9.4.load = load ptr, ptr %.fca.9.4.gep, align 8
  %.360.i.i = getelementptr i8, ptr %arg.f.4, i64 608
  %.361.i.i = load i64, ptr %.360.i.i, align 8, !noalias !358
  %.362.i.i = inttoptr i64 %.361.i.i to ptr
  %.708.i.i = load i64, ptr %arg.f.4, align 8, !noalias !358
  %.95.i = icmp slt i64 %arg.i, 0
  %.96.i = select i1 %.95.i, i64 %.708.i.i, i64 0
  %0 = getelementptr i64, ptr %.362.i.i, i64 %.708.i.i
  %1 = getelementptr i64, ptr %0, i64 %arg.i
  %.118.i = getelementptr i64, ptr %1, i64 %.96.i
  %.119.i = load i64, ptr %.118.i, align 8, !noalias !363
  %.470.i = getelementptr i8, ptr %arg.f.4, i64 224
  %.471.i = load i64, ptr %.470.i, align 8, !noalias !363
  %.817.i = getelementptr i8, ptr %arg.f.4, i64 144
  %.818.i = load i64, ptr %.817.i, align 8, !noalias !363
  %.1192.i = add nsw i64 %.119.i, 1
  %.1194.i = icmp slt i64 %.1192.i, %.471.i
  br i1 %.1194.i, label %B204.i, label %B226.i
B204.i:
  %.45.i.i = getelementptr i8, ptr %arg.f.4, i64 304
  %.46.i.i = load i64, ptr %.45.i.i, align 8, !noalias !364
  %.50.i.i = inttoptr i64 %.46.i.i to ptr
  %.1211.i = icmp slt i64 %.119.i, -1
  %.1212.i = select i1 %.1211.i, i64 %.471.i, i64 0
  %2 = getelementptr double, ptr %.50.i.i, i64 %.1192.i
  %.1226.i = getelementptr double, ptr %2, i64 %.1212.i
  br label %B322.i
B226.i:
  %.1895.i = getelementptr i8, ptr %arg.f.4, i64 240
  %.1896.i = load i64, ptr %.1895.i, align 8, !noalias !363
  %.45.i376.i = getelementptr i8, ptr %arg.f.4, i64 344
  %.46.i377.i = load i64, ptr %.45.i376.i, align 8, !noalias !367
  %.50.i378.i = inttoptr i64 %.46.i377.i to ptr
  %3 = getelementptr double, ptr %.50.i378.i, i64 %.1896.i
  %.1962.i = getelementptr i8, ptr %3, i64 -8
  br label %B322.i
B322.i:
  %"$phi322.0.2.0.in.i" = phi ptr [ %.1226.i, %B204.i ], [ %.1962.i, %B226.i ]
  %"$phi322.0.2.0.i" = load double, ptr %"$phi322.0.2.0.in.i", align 8, !noalias !363
  %.45.i384.i = getelementptr i8, ptr %arg.f.4, i64 312
  %.46.i385.i = load i64, ptr %.45.i384.i, align 8, !noalias !370
  %.50.i386.i = inttoptr i64 %.46.i385.i to ptr
  %.2348.i = icmp slt i64 %.119.i, 0
  %.2349.i = select i1 %.2348.i, i64 %.471.i, i64 0
  %4 = getelementptr i64, ptr %.50.i386.i, i64 %.119.i
  %.2363.i = getelementptr i64, ptr %4, i64 %.2349.i
  %.2364.i = load i64, ptr %.2363.i, align 8, !noalias !363
  %.2713.i = getelementptr i8, ptr %arg.f.4, i64 264
  %.2714.i = load i64, ptr %.2713.i, align 8, !noalias !363
  %.2715.i = icmp sgt i64 %.2714.i, 0
  br i1 %.2715.i, label %B432.i, label %b92
B432.i:
  %.3065.i = getelementptr i8, ptr %arg.f.4, i64 232
  %.3066.i = load i64, ptr %.3065.i, align 8, !noalias !363
  %.3068.i = mul nsw i64 %.3066.i, %arg.i
  br label %b92
b92:
  %"$phi476.1.2.0.i" = phi i64 [ %.3068.i, %B432.i ], [ 0, %B322.i ]
  %.3082.i = add nsw i64 %"$phi476.1.2.0.i", %.2364.i
  %.3470.i = getelementptr i8, ptr %arg.f.4, i64 320
  %.3471.i = load i64, ptr %.3470.i, align 8, !noalias !363
  %.3478.i = mul nsw i64 %.818.i, 56
  %.3479.i = mul nsw i64 %.3478.i, %.3082.i
  %.3480.i = add nsw i64 %.3471.i, %.3479.i
  %.3481.i = inttoptr i64 %.3480.i to ptr
  %.175117.not.i = icmp sgt i64 %.49.fca.6.2.load, 0
  br i1 %.175117.not.i, label %B76.if.lr.ph.i, label %b95
B76.if.lr.ph.i:
  %5 = getelementptr i8, ptr %arg.f.4, i64 464
  %.45.i.i4192 = load i64, ptr %5, align 8, !noalias !373
  %.46.i.i4193 = inttoptr i64 %.45.i.i4192 to ptr
  %invariant.gep.i = getelementptr double, ptr %.46.i.i4193, i64 %arg.i
  %invariant.gep120.i = getelementptr double, ptr %invariant.gep.i, i64 %.96.i
  br label %B76.if.i
B76.if.i:
  %.119.0118.i = phi i64 [ 0, %B76.if.lr.ph.i ], [ %.188.i, %B76.if.i ]
  %.188.i = add nuw nsw i64 %.119.0118.i, 1
  %.260.i = mul i64 %.119.0118.i, %.708.i.i
  %gep121.i = getelementptr double, ptr %invariant.gep120.i, i64 %.260.i
  %.265.i = load double, ptr %gep121.i, align 8, !noalias !378
  %6 = getelementptr double, ptr %.49.fca.6.4.load, i64 %.119.0118.i
  store double %.265.i, ptr %6, align 8, !noalias !378
  %exitcond.not.i = icmp eq i64 %.188.i, %.49.fca.6.2.load
  br i1 %exitcond.not.i, label %b111, label %B76.if.i
b111:
  %.392.i.i4194.pre = load i64, ptr %arg.f.4, align 8, !noalias !379
  br label %b95
b95:
  %.392.i.i4194 = phi i64 [ %.392.i.i4194.pre, %b111 ], [ %.708.i.i, %b92 ]
  %.175117.not.i4195 = icmp slt i64 %.49.fca.5.10.2.load, 1
  br i1 %.175117.not.i4195, label %b112, label %B76.if.lr.ph.i4196
B76.if.lr.ph.i4196:
  %7 = getelementptr i8, ptr %arg.f.4, i64 552
  %.45.i.i4197 = load i64, ptr %7, align 8, !noalias !379
  %.46.i.i4198 = inttoptr i64 %.45.i.i4197 to ptr
  %invariant.gep.i4199 = getelementptr double, ptr %.46.i.i4198, i64 %arg.i
  %.242.i4201 = select i1 %.95.i, i64 %.392.i.i4194, i64 0
  %invariant.gep120.i4202 = getelementptr double, ptr %invariant.gep.i4199, i64 %.242.i4201
  br label %B76.if.i4203
B76.if.i4203:
  %.119.0118.i4204 = phi i64 [ 0, %B76.if.lr.ph.i4196 ], [ %.188.i4205, %B76.if.i4203 ]
  %.188.i4205 = add nuw nsw i64 %.119.0118.i4204, 1
  %.260.i4206 = mul i64 %.119.0118.i4204, %.392.i.i4194
  %gep121.i4207 = getelementptr double, ptr %invariant.gep120.i4202, i64 %.260.i4206
  %.265.i4208 = load double, ptr %gep121.i4207, align 8, !noalias !384
  %8 = getelementptr double, ptr %.49.fca.5.10.4.load, i64 %.119.0118.i4204
  store double %.265.i4208, ptr %8, align 8, !noalias !384
  %exitcond.not.i4209 = icmp eq i64 %.188.i4205, %.49.fca.5.10.2.load
  br i1 %exitcond.not.i4209, label %b113, label %B76.if.i4203
b113:
  %.392.i.i4211.pre = load i64, ptr %arg.f.4, align 8, !noalias !385
  br label %b112
b112:
  %.392.i.i4211 = phi i64 [ %.392.i.i4211.pre, %b113 ], [ %.392.i.i4194, %b95 ]
  %.175117.not.i4212 = icmp slt i64 %.49.fca.5.11.2.load, 1
  br i1 %.175117.not.i4212, label %b114, label %B76.if.lr.ph.i4213
B76.if.lr.ph.i4213:
  %9 = getelementptr i8, ptr %arg.f.4, i64 560
  %.45.i.i4214 = load i64, ptr %9, align 8, !noalias !385
  %.46.i.i4215 = inttoptr i64 %.45.i.i4214 to ptr
  %invariant.gep.i4216 = getelementptr double, ptr %.46.i.i4215, i64 %arg.i
  %.242.i4218 = select i1 %.95.i, i64 %.392.i.i4211, i64 0
  %invariant.gep120.i4219 = getelementptr double, ptr %invariant.gep.i4216, i64 %.242.i4218
  br label %B76.if.i4220
B76.if.i4220:
  %.119.0118.i4221 = phi i64 [ 0, %B76.if.lr.ph.i4213 ], [ %.188.i4222, %B76.if.i4220 ]
  %.188.i4222 = add nuw nsw i64 %.119.0118.i4221, 1
  %.260.i4223 = mul i64 %.119.0118.i4221, %.392.i.i4211
  %gep121.i4224 = getelementptr double, ptr %invariant.gep120.i4219, i64 %.260.i4223
  %.265.i4225 = load double, ptr %gep121.i4224, align 8, !noalias !390
  %10 = getelementptr double, ptr %.49.fca.5.11.4.load, i64 %.119.0118.i4221
  store double %.265.i4225, ptr %10, align 8, !noalias !390
  %exitcond.not.i4226 = icmp eq i64 %.188.i4222, %.49.fca.5.11.2.load
  br i1 %exitcond.not.i4226, label %b114, label %B76.if.i4220
b114:
  %.2596 = getelementptr i8, ptr %arg.f.4, i64 248
  %.2597 = load i64, ptr %.2596, align 8
  %.2598 = icmp sgt i64 %.2597, 0
  br i1 %.2598, label %B402, label %B508
B402:
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %.2605, i8 0, i64 16, i1 false)
  call fastcc void @v89(ptr %.2605, i64 %.49.fca.0.3.load, ptr %.49.fca.1.0.4.load, ptr %.49.fca.3.2.4.load, ptr %.49.fca.4.0.4.load, i64 %.49.fca.4.0.5.1.load, ptr %.49.fca.4.1.4.load, i64 %.49.fca.4.1.5.0.load, i64 %.49.fca.4.1.5.1.load, i64 %.49.fca.5.0.2.load, ptr %.49.fca.5.0.4.load, ptr %.49.fca.5.3.4.load, ptr %.49.fca.5.11.4.load, i64 %.49.fca.5.11.5.0.load, i64 %.49.fca.5.12.2.load, ptr %.49.fca.5.12.4.load, i64 %.49.fca.6.2.load, ptr %.49.fca.6.4.load, ptr %.3481.i, i64 7, double %arg.t, double %arg.h, ptr %.49.fca.5.10.4.load)
  %.2712.fca.0.load = load i64, ptr %.2605, align 8
  %.2712.fca.1.load = load double, ptr %.fca.1.gep324, align 8
  %.2736 = fmul double %arg.h, %.2712.fca.1.load
  %.2742 = fadd double %arg.t, %.2736
  %.27294254 = icmp slt i64 %.2712.fca.0.load, 0
  %"$phi484.1.2.0" = select i1 %.27294254, double %arg.end, double %.2742
  %.2788 = getelementptr i8, ptr %.49.fca.9.4.load, i64 24
  store i64 %.2712.fca.0.load, ptr %.2788, align 8
  br label %B674
B508:
  %.2820 = icmp sgt i64 %.49.fca.1.3.2.load, 0
  br i1 %.2820, label %B78.if.i, label %B674
B78.if.i:
  %first.2.0129.i = phi double [ %.13.i.i, %B78.if.i ], [ 0x7FF0000000000000, %B508 ]
  %.106.0128.i = phi i64 [ %.177.i, %B78.if.i ], [ 0, %B508 ]
  %.177.i = add nuw nsw i64 %.106.0128.i, 1
  %11 = getelementptr double, ptr %.49.fca.1.1.4.load, i64 %.106.0128.i
  %.235.i = load double, ptr %11, align 8, !noalias !391
  %.12.i.i = fcmp olt double %.235.i, %first.2.0129.i
  %.13.i.i = select i1 %.12.i.i, double %.235.i, double %first.2.0129.i
  %exitcond.not.i4228 = icmp eq i64 %.49.fca.1.3.2.load, %.177.i
  br i1 %exitcond.not.i4228, label %b106, label %B78.if.i
b106:
  %.5.i = fmul double %arg.end, 0x3D06849B86A12B9B
  %.6.i = fadd double %.5.i, 1.000000e-15
  %.2888 = fsub double %arg.end, %.6.i
  %.2889 = fcmp olt double %.13.i.i, %.2888
  br i1 %.2889, label %B630, label %B674
B630:
  store double 0.000000e+00, ptr %.2894, align 8
  call fastcc void @v90(ptr %.2894, i64 %.49.fca.0.3.load, i64 %.49.fca.0.4.load, ptr %.49.fca.1.0.4.load, i64 %.49.fca.1.1.2.load, ptr nonnull %.49.fca.1.1.4.load, ptr %.49.fca.1.2.4.load, i64 %.49.fca.1.3.2.load, ptr %.49.fca.1.3.4.load, ptr %.49.fca.1.4.4.load, i64 %.49.fca.2.1.2.load, i64 %.49.fca.3.0.2.load, ptr %.49.fca.3.0.4.load, i64 %.49.fca.3.0.5.0.load, ptr %.49.fca.3.1.4.load, i64 %.49.fca.3.1.5.1.load, i64 %.49.fca.3.2.2.load, ptr %.49.fca.3.2.4.load, i64 %.49.fca.5.0.2.load, ptr %.49.fca.5.0.4.load, ptr %.49.fca.5.3.4.load, ptr %.49.fca.5.6.4.load, i64 %.49.fca.5.6.5.0.load, ptr %.49.fca.5.11.4.load, i64 %.49.fca.5.11.5.0.load, i64 %.49.fca.5.12.2.load, ptr %.49.fca.5.12.4.load, i64 %.49.fca.6.2.load, ptr %.49.fca.6.4.load, ptr %.49.fca.9.4.load, ptr %.3481.i, i64 7, double %arg.t, double %arg.h, double %arg.end, ptr %.49.fca.5.10.4.load)
  %.3001 = load double, ptr %.2894, align 8
  br label %B674
B674:
  %reached.3.0 = phi double [ %"$phi484.1.2.0", %B402 ], [ %.3001, %B630 ], [ %arg.end, %b106 ], [ %arg.end, %B508 ]
  call fastcc void @v91(ptr %.3020, i64 %.49.fca.0.3.load, ptr %.49.fca.1.0.4.load, i64 %.49.fca.2.1.2.load, i64 %.49.fca.3.0.2.load, ptr %.49.fca.3.0.4.load, i64 %.49.fca.3.0.5.0.load, ptr %.49.fca.3.1.4.load, i64 %.49.fca.3.1.5.1.load, i64 %.49.fca.3.2.2.load, ptr %.49.fca.3.2.4.load, i64 %.49.fca.5.0.2.load, ptr %.49.fca.5.0.4.load, ptr %.49.fca.5.3.4.load, ptr %.49.fca.5.6.4.load, i64 %.49.fca.5.6.5.0.load, ptr %.49.fca.5.11.4.load, i64 %.49.fca.5.11.5.0.load, i64 %.49.fca.6.2.load, ptr %.49.fca.6.4.load, ptr %.49.fca.9.4.load, ptr %.3481.i, i64 7, double %arg.t, double %arg.h, ptr %.49.fca.5.10.4.load, double %reached.3.0)
  %.3170 = getelementptr i8, ptr %.49.fca.9.4.load, i64 24
  %.3171 = load i64, ptr %.3170, align 8
  %.3172 = icmp sgt i64 %.3171, -1
  %.3176 = fcmp olt double %reached.3.0, %arg.end
  %or.cond = select i1 %.3172, i1 true, i1 %.3176
  br i1 %or.cond, label %B766, label %B930
B766:
  br i1 %.175117.not.i, label %B816.if, label %B864
B864:
  %.392.i.i4229 = load i64, ptr %arg.f.4, align 8, !noalias !394
  br i1 %.175117.not.i4195, label %B930, label %B76.if.lr.ph.i4231
B76.if.lr.ph.i4231:
  %12 = getelementptr i8, ptr %arg.f.4, i64 552
  %.45.i.i4232 = load i64, ptr %12, align 8, !noalias !394
  %.46.i.i4233 = inttoptr i64 %.45.i.i4232 to ptr
  %invariant.gep.i4234 = getelementptr double, ptr %.46.i.i4233, i64 %arg.i
  %.272.i = select i1 %.95.i, i64 %.392.i.i4229, i64 0
  %invariant.gep120.i4235 = getelementptr double, ptr %invariant.gep.i4234, i64 %.272.i
  br label %B76.if.i4236
B76.if.i4236:
  %.119.0118.i4237 = phi i64 [ 0, %B76.if.lr.ph.i4231 ], [ %.188.i4238, %B76.if.i4236 ]
  %.188.i4238 = add nuw nsw i64 %.119.0118.i4237, 1
  %13 = getelementptr double, ptr %.49.fca.5.10.4.load, i64 %.119.0118.i4237
  %.242.i4239 = load double, ptr %13, align 8, !noalias !399
  %.290.i = mul i64 %.119.0118.i4237, %.392.i.i4229
  %gep121.i4240 = getelementptr double, ptr %invariant.gep120.i4235, i64 %.290.i
  store double %.242.i4239, ptr %gep121.i4240, align 8, !noalias !399
  %exitcond.not.i4241 = icmp eq i64 %.188.i4238, %.49.fca.5.10.2.load
  br i1 %exitcond.not.i4241, label %B930, label %B76.if.i4236
B930:
  %.3759 = icmp eq i64 %.49.fca.1.3.2.load, 0
  br i1 %.3759, label %common.ret, label %B962
B962:
  %.3790 = load i64, ptr %.3170, align 8
  %.3796 = icmp sgt i64 %.3790, -1
  br i1 %.3796, label %common.ret, label %B1004
common.ret:
  %"$phi1382.1.2.0.pn" = phi i8 [ 0, %B930 ], [ 0, %B962 ], [ 1, %B1082 ], [ %17, %B1372 ]
  %.5706.pn = insertvalue { double, i8 } undef, double %reached.3.0, 0
  %storemerge4191 = insertvalue { double, i8 } %.5706.pn, i8 %"$phi1382.1.2.0.pn", 1
  store { double, i8 } %storemerge4191, ptr %retptr, align 8
  ret void
B1004:
  %.5.i4242 = fmul double %"$phi322.0.2.0.i", 0x3D06849B86A12B9B
  %.6.i4243 = fadd double %.5.i4242, 1.000000e-15
  %.4053 = fsub double %"$phi322.0.2.0.i", %.6.i4243
  %.4055 = fcmp olt double %reached.3.0, %.4053
  br i1 %.4055, label %B1082, label %B1184
B1082:
  %.361.i = load i64, ptr %.360.i.i, align 8, !noalias !400
  %.362.i = inttoptr i64 %.361.i to ptr
  %.708.i = load i64, ptr %arg.f.4, align 8, !noalias !400
  %.4149 = select i1 %.95.i, i64 %.708.i, i64 0
  %.idx = shl i64 %.708.i, 5
  %14 = getelementptr i8, ptr %.362.i, i64 %.idx
  %15 = getelementptr i64, ptr %14, i64 %arg.i
  %.4171 = getelementptr i64, ptr %15, i64 %.4149
  store i64 1, ptr %.4171, align 8
  store i8 0, ptr %.4243, align 1
  call fastcc void @v78(ptr %.4243, ptr nonnull %arg.f.4, i64 %arg.i, i64 %.49.fca.0.4.load, ptr %.49.fca.1.0.4.load, i64 %.49.fca.1.1.2.load, ptr %.49.fca.1.1.4.load, ptr %.49.fca.1.2.4.load, i64 %.49.fca.1.3.2.load, ptr %.49.fca.1.3.4.load, ptr %.49.fca.1.4.4.load, i64 %.49.fca.5.0.2.load, ptr %.49.fca.5.0.4.load, ptr %.49.fca.5.3.4.load, ptr %.3481.i, i64 7, double %reached.3.0, ptr %.49.fca.5.10.4.load)
  %.4352 = load i8, ptr %.4243, align 1
  %.4355.not = icmp eq i8 %.4352, 0
  br i1 %.4355.not, label %B1372, label %common.ret
B1184:
  %.392.i = load i64, ptr %arg.f.4, align 8, !noalias !403
  %.51534258.not = icmp slt i64 %.49.fca.1.1.2.load, 1
  br i1 %.51534258.not, label %B1372, label %B1286.if.lr.ph
B1286.if.lr.ph:
  %16 = getelementptr i8, ptr %arg.f.4, i64 496
  %.45.i = load i64, ptr %16, align 8, !noalias !403
  %.46.i = inttoptr i64 %.45.i to ptr
  %invariant.gep = getelementptr double, ptr %.46.i, i64 %arg.i
  %.5575 = getelementptr i8, ptr %arg.f.4, i64 160
  %.5607 = select i1 %.95.i, i64 %.392.i, i64 0
  %invariant.gep4261 = getelementptr double, ptr %invariant.gep, i64 %.5607
  br label %B1286.if
B1372:
  %17 = zext i1 %.3176 to i8
  br label %common.ret
B816.if:
  %.3215.04256 = phi i64 [ %.3284, %B816.if ], [ 0, %B766 ]
  %.3284 = add nuw nsw i64 %.3215.04256, 1
  %18 = getelementptr double, ptr %.49.fca.5.12.4.load, i64 %.3215.04256
  %.3342 = load double, ptr %18, align 8
  %19 = getelementptr double, ptr %.49.fca.5.10.4.load, i64 %.3215.04256
  store double %.3342, ptr %19, align 8
  %exitcond.not = icmp eq i64 %.49.fca.6.2.load, %.3284
  br i1 %exitcond.not, label %B864, label %B816.if
B1286.if:
  %.5094.04259 = phi i64 [ 0, %B1286.if.lr.ph ], [ %.5166, %B1286.if ]
  %.5166 = add nuw nsw i64 %.5094.04259, 1
  %20 = getelementptr double, ptr %.49.fca.1.1.4.load, i64 %.5094.04259
  %.5226 = load double, ptr %20, align 8
  %.5576 = load i64, ptr %.5575, align 8
  %.5577 = add nsw i64 %.5576, %.5094.04259
  %.5577.lobit = lshr i64 %.5577, 63
  %.5605 = add i64 %.5577.lobit, %.5577
  %.5625 = mul i64 %.5605, %.392.i
  %gep4262 = getelementptr double, ptr %invariant.gep4261, i64 %.5625
  store double %.5226, ptr %gep4262, align 8
  %exitcond4263.not = icmp eq i64 %.5166, %.49.fca.1.1.2.load
  br i1 %exitcond4263.not, label %B1372, label %B1286.if
}
define internal fastcc void @v89(ptr noalias nonnull writeonly %retptr, i64 %arg.run.0.3, ptr %arg.run.1.0.4, ptr %arg.run.3.2.4, ptr readonly %arg.run.4.0.4, i64 %arg.run.4.0.5.1, ptr readonly %arg.run.4.1.4, i64 %arg.run.4.1.5.0, i64 %arg.run.4.1.5.1, i64 %arg.run.5.0.2, ptr %arg.run.5.0.4, ptr %arg.run.5.3.4, ptr readonly %arg.run.5.11.4, i64 %arg.run.5.11.5.0, i64 %arg.run.5.12.2, ptr %arg.run.5.12.4, i64 %arg.run.6.2, ptr readonly %arg.run.6.4, ptr readonly %arg.segment.2.4, i64 %arg.segment.2.5.1, double %arg.step.0, double %arg.step.1, ptr readonly %arg.step.3.4) unnamed_addr {
entry:
  %.703768.not.i = icmp slt i64 %arg.run.5.12.2, 1
  %.148211.not.i.i.i = icmp slt i64 %arg.run.5.0.2, 1
  %.992.i.i = inttoptr i64 %arg.run.0.3 to ptr
  %spec.select.i = tail call i64 @llvm.smax.i64(i64 %arg.run.4.1.5.0, i64 0)
  %.1175 = fadd double %arg.step.0, %arg.step.1
  %.1176 = fmul double %.1175, 4.000000e-16
  br label %B48.outer
B48.outer:
  %low.4.1.ph = phi double [ 0.000000e+00, %entry ], [ %low.4.1.high.3.1, %B204 ]
  %high.3.1.ph = phi double [ 5.000000e-01, %entry ], [ %.1161, %B204 ]
  %event.2.1.ph = phi i64 [ -1, %entry ], [ %.908.event.2.1, %B204 ]
  %theta.2.1.ph = phi double [ 0.000000e+00, %entry ], [ %high.3.1.theta.2.1, %B204 ]
  br label %B48
B48:
  %low.4.1 = phi double [ 5.000000e-01, %B176 ], [ %low.4.1.ph, %B48.outer ]
  %high.3.1 = phi double [ 1.000000e+00, %B176 ], [ %high.3.1.ph, %B48.outer ]
  %event.2.1 = phi i64 [ -1, %B176 ], [ %event.2.1.ph, %B48.outer ]
  %.478.i = fsub double 1.000000e+00, %high.3.1
  br i1 %.703768.not.i, label %b115, label %B102.if.i
B102.if.i:
  %.645.0769.i = phi i64 [ %.716.i, %B102.if.i ], [ 0, %B48 ]
  %.716.i = add nuw nsw i64 %.645.0769.i, 1
  %0 = getelementptr double, ptr %arg.run.6.4, i64 %.645.0769.i
  %.774.i = load double, ptr %0, align 8, !noalias !406
  %.779.i = fmul double %.478.i, %.774.i
  %1 = getelementptr double, ptr %arg.step.3.4, i64 %.645.0769.i
  %.813.i = load double, ptr %1, align 8, !noalias !406
  %2 = getelementptr double, ptr %arg.run.5.11.4, i64 %.645.0769.i
  %.846.i = load double, ptr %2, align 8, !noalias !406
  %.848.i = add nsw i64 %.645.0769.i, %arg.run.6.2
  %.862.i = icmp slt i64 %.848.i, 0
  %.863.i = select i1 %.862.i, i64 %arg.run.5.11.5.0, i64 0
  %3 = getelementptr double, ptr %arg.run.5.11.4, i64 %.848.i
  %.877.i = getelementptr double, ptr %3, i64 %.863.i
  %.878.i = load double, ptr %.877.i, align 8, !noalias !406
  %.880.i = fmul double %high.3.1, %.878.i
  %.881.i = fadd double %.846.i, %.880.i
  %.883.i = fmul double %.478.i, %.881.i
  %.884.i = fadd double %.813.i, %.883.i
  %.886.i = fmul double %high.3.1, %.884.i
  %.887.i = fadd double %.779.i, %.886.i
  %4 = getelementptr double, ptr %arg.run.5.12.4, i64 %.645.0769.i
  store double %.887.i, ptr %4, align 8, !noalias !406
  %exitcond.not.i = icmp eq i64 %arg.run.5.12.2, %.716.i
  br i1 %exitcond.not.i, label %b115, label %B102.if.i
b115:
  %.796 = fmul double %arg.step.1, %high.3.1
  %.797 = fadd double %arg.step.0, %.796
  br i1 %.148211.not.i.i.i, label %b96, label %B58.if.i.i.i
B164.i.i.i:
  %.44.i.i.i.i = getelementptr i8, ptr %6, i64 24
  %.45.i.i.i.i = load double, ptr %.44.i.i.i.i, align 8, !noalias !409
  %.73.i.i.i.i = getelementptr i8, ptr %6, i64 32
  %.74.i.i.i.i = load double, ptr %.73.i.i.i.i, align 8, !noalias !409
  %.75.i.i.i.i = fmul double %.74.i.i.i.i, 5.000000e-01
  %.76.i.i.i.i = fmul double %.245.i.i.i, %.75.i.i.i.i
  %.77.i.i.i.i = fadd double %.45.i.i.i.i, %.76.i.i.i.i
  %.78.i.i.i.i = fmul double %.245.i.i.i, %.77.i.i.i.i
  %.87.le.i.i.i.i = tail call double @llvm.floor.f64(double %.78.i.i.i.i)
  %.92.i.i.i.i = fsub double %.78.i.i.i.i, %.87.le.i.i.i.i
  %.93.i.i.i.i = fmul double %.92.i.i.i.i, 0x401921FB54442D18
  %.121.i.i.i.i = getelementptr i8, ptr %6, i64 40
  %.122.i.i.i.i = load double, ptr %.121.i.i.i.i, align 8, !noalias !409
  %.126.i.i.i.i = fadd double %.122.i.i.i.i, %.93.i.i.i.i
  %.593.le.i.i.i = tail call double @llvm.sin.f64(double %.126.i.i.i.i)
  %.598.i.i.i = fmul double %.423.i.i.i, %.593.le.i.i.i
  %.600.i.i.i = fadd double %.361.i.i.i, %.598.i.i.i
  br label %B272.i.i.i
B272.i.i.i:
  %value.2.1.i.i.i = phi double [ %.600.i.i.i, %B164.i.i.i ], [ %.361.i.i.i, %B58.if.i.i.i ]
  %5 = getelementptr double, ptr %arg.run.5.0.4, i64 %.90.0213.i.i.i
  store double %value.2.1.i.i.i, ptr %5, align 8, !noalias !418
  %exitcond.not.i.i.i = icmp eq i64 %arg.run.5.0.2, %.161.i.i.i
  br i1 %exitcond.not.i.i.i, label %b96, label %B58.if.i.i.i
B58.if.i.i.i:
  %.90.0213.i.i.i = phi i64 [ %.161.i.i.i, %B272.i.i.i ], [ 0, %b115 ]
  %.161.i.i.i = add nuw nsw i64 %.90.0213.i.i.i, 1
  %.238.i.i.i = mul i64 %.90.0213.i.i.i, %arg.segment.2.5.1
  %6 = getelementptr double, ptr %arg.segment.2.4, i64 %.238.i.i.i
  %.242.i.i.i = getelementptr i8, ptr %6, i64 48
  %.243.i.i.i = load double, ptr %.242.i.i.i, align 8, !noalias !418
  %.245.i.i.i = fsub double %.797, %.243.i.i.i
  %.303.i.i.i = load double, ptr %6, align 8, !noalias !418
  %.357.i.i.i = getelementptr i8, ptr %6, i64 8
  %.358.i.i.i = load double, ptr %.357.i.i.i, align 8, !noalias !418
  %.360.i.i.i = fmul double %.245.i.i.i, %.358.i.i.i
  %.361.i.i.i = fadd double %.303.i.i.i, %.360.i.i.i
  %.422.i.i.i = getelementptr i8, ptr %6, i64 16
  %.423.i.i.i = load double, ptr %.422.i.i.i, align 8, !noalias !418
  %.424.i.i.i = fcmp une double %.423.i.i.i, 0.000000e+00
  br i1 %.424.i.i.i, label %B164.i.i.i, label %B272.i.i.i
b96:
  store double %.797, ptr %arg.run.5.3.4, align 8, !noalias !419
  tail call void %.992.i.i(ptr nonnull %arg.run.5.3.4, ptr %arg.run.5.12.4, ptr %arg.run.5.0.4, ptr %arg.run.1.0.4, ptr %arg.run.3.2.4), !noalias !419
  br label %B140.i
B140.i:
  %.859.0.i = phi i64 [ 0, %b96 ], [ %.928.i, %B288.i ]
  %exitcond294.not.i = icmp eq i64 %.859.0.i, %spec.select.i
  br i1 %exitcond294.not.i, label %b102, label %B142.i
B142.i:
  %.1005.i = mul i64 %.859.0.i, %arg.run.4.1.5.1
  %7 = getelementptr double, ptr %arg.run.4.1.4, i64 %.1005.i
  %.1009.i = getelementptr i8, ptr %7, i64 16
  %.1010.i = load double, ptr %.1009.i, align 8, !noalias !420
  %.1186.i = mul i64 %.859.0.i, %arg.run.4.0.5.1
  %8 = getelementptr i64, ptr %arg.run.4.0.4, i64 %.1186.i
  br label %B194.if.i
B226.i:
  %9 = getelementptr double, ptr %7, i64 %.1037.0289.i
  %.1249.i = load double, ptr %9, align 8, !noalias !420
  %.1338.i = getelementptr double, ptr %arg.run.3.2.4, i64 %.1191.i
  %.1339.i = load double, ptr %.1338.i, align 8, !noalias !420
  %.1340.i = fmul double %.1249.i, %.1339.i
  %.1342.i = fadd double %value.2.1291.i, %.1340.i
  br label %B286.i
B286.i:
  %value.3.2.i = phi double [ %.1342.i, %B226.i ], [ %value.2.1291.i, %B194.if.i ]
  br i1 %exitcond.not.i1267, label %B288.i, label %B194.if.i
B288.i:
  %.928.i = add nuw i64 %.859.0.i, 1
  %.1361.i = fcmp ogt double %value.3.2.i, 0.000000e+00
  br i1 %.1361.i, label %b102, label %B140.i
B194.if.i:
  %value.2.1291.i = phi double [ %.1010.i, %B142.i ], [ %value.3.2.i, %B286.i ]
  %exitcond.not.i1267 = phi i1 [ false, %B142.i ], [ true, %B286.i ]
  %.1037.0289.i = phi i64 [ 0, %B142.i ], [ 1, %B286.i ]
  %10 = getelementptr i64, ptr %8, i64 %.1037.0289.i
  %.1191.i = load i64, ptr %10, align 8, !noalias !420
  %.1194.i = icmp sgt i64 %.1191.i, -1
  br i1 %.1194.i, label %B226.i, label %B286.i
b102:
  %storemerge280.i = phi i64 [ %.859.0.i, %B288.i ], [ -1, %B140.i ]
  %11 = and i64 %storemerge280.i, %event.2.1
  %or.cond.not = icmp sgt i64 %11, -1
  br i1 %or.cond.not, label %B204, label %B176
B176:
  %.932 = fcmp oeq double %high.3.1, 1.000000e+00
  br i1 %.932, label %common.ret, label %B48
common.ret:
  %.908.event.2.1.lcssa.sink = phi i64 [ %.908.event.2.1, %B102.if.i1270 ], [ %.908.event.2.1, %B336 ], [ -1, %B176 ]
  %high.3.1.theta.2.1.lcssa.sink = phi double [ %high.3.1.theta.2.1, %B102.if.i1270 ], [ %high.3.1.theta.2.1, %B336 ], [ 1.000000e+00, %B176 ]
  store i64 %.908.event.2.1.lcssa.sink, ptr %retptr, align 8
  %retptr.repack1262 = getelementptr inbounds i8, ptr %retptr, i64 8
  store double %high.3.1.theta.2.1.lcssa.sink, ptr %retptr.repack1262, align 8
  ret void
B204:
  %.1113 = icmp sgt i64 %storemerge280.i, -1
  %low.4.1.high.3.1 = select i1 %.1113, double %low.4.1, double %high.3.1
  %high.3.1.theta.2.1 = select i1 %.1113, double %high.3.1, double %theta.2.1.ph
  %.908.event.2.1 = select i1 %.1113, i64 %storemerge280.i, i64 %event.2.1
  %.1160 = fadd double %low.4.1.high.3.1, %high.3.1.theta.2.1
  %.1161 = fmul double %.1160, 5.000000e-01
  %.1167 = fsub double %high.3.1.theta.2.1, %low.4.1.high.3.1
  %.1170 = fmul double %arg.step.1, %.1167
  %.1177 = fcmp ugt double %.1170, %.1176
  %.1181 = fcmp ugt double %.1161, %low.4.1.high.3.1
  %or.cond1265 = and i1 %.1177, %.1181
  %.1185 = fcmp ult double %.1161, %high.3.1.theta.2.1
  %or.cond1266 = and i1 %.1185, %or.cond1265
  br i1 %or.cond1266, label %B48.outer, label %B336
B336:
  %.478.i1268 = fsub double 1.000000e+00, %high.3.1.theta.2.1
  br i1 %.703768.not.i, label %common.ret, label %B102.if.i1270
B102.if.i1270:
  %.645.0769.i1271 = phi i64 [ %.716.i1272, %B102.if.i1270 ], [ 0, %B336 ]
  %.716.i1272 = add nuw nsw i64 %.645.0769.i1271, 1
  %12 = getelementptr double, ptr %arg.run.6.4, i64 %.645.0769.i1271
  %.774.i1273 = load double, ptr %12, align 8, !noalias !421
  %.779.i1274 = fmul double %.478.i1268, %.774.i1273
  %13 = getelementptr double, ptr %arg.step.3.4, i64 %.645.0769.i1271
  %.813.i1275 = load double, ptr %13, align 8, !noalias !421
  %14 = getelementptr double, ptr %arg.run.5.11.4, i64 %.645.0769.i1271
  %.846.i1276 = load double, ptr %14, align 8, !noalias !421
  %.848.i1277 = add nsw i64 %.645.0769.i1271, %arg.run.6.2
  %.862.i1278 = icmp slt i64 %.848.i1277, 0
  %.863.i1279 = select i1 %.862.i1278, i64 %arg.run.5.11.5.0, i64 0
  %15 = getelementptr double, ptr %arg.run.5.11.4, i64 %.848.i1277
  %.877.i1280 = getelementptr double, ptr %15, i64 %.863.i1279
  %.878.i1281 = load double, ptr %.877.i1280, align 8, !noalias !421
  %.880.i1282 = fmul double %high.3.1.theta.2.1, %.878.i1281
  %.881.i1283 = fadd double %.846.i1276, %.880.i1282
  %.883.i1284 = fmul double %.478.i1268, %.881.i1283
  %.884.i1285 = fadd double %.813.i1275, %.883.i1284
  %.886.i1286 = fmul double %high.3.1.theta.2.1, %.884.i1285
  %.887.i1287 = fadd double %.779.i1274, %.886.i1286
  %16 = getelementptr double, ptr %arg.run.5.12.4, i64 %.645.0769.i1271
  store double %.887.i1287, ptr %16, align 8, !noalias !421
  %exitcond.not.i1288 = icmp eq i64 %arg.run.5.12.2, %.716.i1272
  br i1 %exitcond.not.i1288, label %common.ret, label %B102.if.i1270
}
define internal fastcc void @v90(ptr noalias nonnull writeonly %retptr, i64 %arg.run.0.3, i64 %arg.run.0.4, ptr %arg.run.1.0.4, i64 %arg.run.1.1.2, ptr %arg.run.1.1.4, ptr readonly %arg.run.1.2.4, i64 %arg.run.1.3.2, ptr %arg.run.1.3.4, ptr %arg.run.1.4.4, i64 %arg.run.2.1.2, i64 %arg.run.3.0.2, ptr readonly %arg.run.3.0.4, i64 %arg.run.3.0.5.0, ptr writeonly %arg.run.3.1.4, i64 %arg.run.3.1.5.1, i64 %arg.run.3.2.2, ptr %arg.run.3.2.4, i64 %arg.run.5.0.2, ptr %arg.run.5.0.4, ptr %arg.run.5.3.4, ptr %arg.run.5.6.4, i64 %arg.run.5.6.5.0, ptr readonly %arg.run.5.11.4, i64 %arg.run.5.11.5.0, i64 %arg.run.5.12.2, ptr %arg.run.5.12.4, i64 %arg.run.6.2, ptr readonly %arg.run.6.4, ptr %arg.run.9.4, ptr readonly %arg.segment.2.4, i64 %arg.segment.2.5.1, double %arg.step.0, double %arg.step.1, double %arg.step.2, ptr readonly %arg.step.3.4) unnamed_addr {
entry:
  %.729 = alloca ptr, align 8
  %.1201 = alloca i8, align 1
  %.5.i = fmul double %arg.step.2, 0x3D06849B86A12B9B
  %.6.i = fadd double %.5.i, 1.000000e-15
  %.584 = fsub double %arg.step.2, %.6.i
  %.703768.not.i = icmp slt i64 %arg.run.5.12.2, 1
  br label %B78.if.i
B78.if.i:
  %first.2.0129.i = phi double [ 0x7FF0000000000000, %entry ], [ %first.2.0129.i.be, %B78.if.i.backedge ]
  %.106.0128.i = phi i64 [ 0, %entry ], [ %.106.0128.i.be, %B78.if.i.backedge ]
  %.177.i = add nuw nsw i64 %.106.0128.i, 1
  %0 = getelementptr double, ptr %arg.run.1.1.4, i64 %.106.0128.i
  %.235.i = load double, ptr %0, align 8, !noalias !424
  %.12.i.i = fcmp olt double %.235.i, %first.2.0129.i
  %.13.i.i = select i1 %.12.i.i, double %.235.i, double %first.2.0129.i
  %exitcond.not.i = icmp eq i64 %arg.run.1.3.2, %.177.i
  br i1 %exitcond.not.i, label %b106, label %B78.if.i.backedge
B78.if.i.backedge:
  %first.2.0129.i.be = phi double [ %.13.i.i, %B78.if.i ], [ 0x7FF0000000000000, %b115 ]
  %.106.0128.i.be = phi i64 [ %.177.i, %B78.if.i ], [ 0, %b115 ]
  br label %B78.if.i
b106:
  %.586 = fcmp ult double %.13.i.i, %.584
  br i1 %.586, label %B124, label %common.ret
common.ret:
  %storemerge = phi double [ %arg.step.2, %b106 ], [ %.13.i.i, %b115 ]
  store double %storemerge, ptr %retptr, align 8
  ret void
B124:
  call fastcc void @v91(ptr %.729, i64 %arg.run.0.3, ptr %arg.run.1.0.4, i64 %arg.run.2.1.2, i64 %arg.run.3.0.2, ptr %arg.run.3.0.4, i64 %arg.run.3.0.5.0, ptr %arg.run.3.1.4, i64 %arg.run.3.1.5.1, i64 %arg.run.3.2.2, ptr %arg.run.3.2.4, i64 %arg.run.5.0.2, ptr %arg.run.5.0.4, ptr %arg.run.5.3.4, ptr %arg.run.5.6.4, i64 %arg.run.5.6.5.0, ptr %arg.run.5.11.4, i64 %arg.run.5.11.5.0, i64 %arg.run.6.2, ptr %arg.run.6.4, ptr %arg.run.9.4, ptr %arg.segment.2.4, i64 %arg.segment.2.5.1, double %arg.step.0, double %arg.step.1, ptr %arg.step.3.4, double %.13.i.i)
  %.850 = fsub double %.13.i.i, %arg.step.0
  %.856 = fdiv double %.850, %arg.step.1
  %.478.i = fsub double 1.000000e+00, %.856
  br i1 %.703768.not.i, label %b115, label %B102.if.i
B102.if.i:
  %.645.0769.i = phi i64 [ %.716.i, %B102.if.i ], [ 0, %B124 ]
  %.716.i = add nuw nsw i64 %.645.0769.i, 1
  %1 = getelementptr double, ptr %arg.run.6.4, i64 %.645.0769.i
  %.774.i = load double, ptr %1, align 8, !noalias !427
  %.779.i = fmul double %.478.i, %.774.i
  %2 = getelementptr double, ptr %arg.step.3.4, i64 %.645.0769.i
  %.813.i = load double, ptr %2, align 8, !noalias !427
  %3 = getelementptr double, ptr %arg.run.5.11.4, i64 %.645.0769.i
  %.846.i = load double, ptr %3, align 8, !noalias !427
  %.848.i = add nsw i64 %.645.0769.i, %arg.run.6.2
  %.862.i = icmp slt i64 %.848.i, 0
  %.863.i = select i1 %.862.i, i64 %arg.run.5.11.5.0, i64 0
  %4 = getelementptr double, ptr %arg.run.5.11.4, i64 %.848.i
  %.877.i = getelementptr double, ptr %4, i64 %.863.i
  %.878.i = load double, ptr %.877.i, align 8, !noalias !427
  %.880.i = fmul double %.856, %.878.i
  %.881.i = fadd double %.846.i, %.880.i
  %.883.i = fmul double %.478.i, %.881.i
  %.884.i = fadd double %.813.i, %.883.i
  %.886.i = fmul double %.856, %.884.i
  %.887.i = fadd double %.779.i, %.886.i
  %5 = getelementptr double, ptr %arg.run.5.12.4, i64 %.645.0769.i
  store double %.887.i, ptr %5, align 8, !noalias !427
  %exitcond.not.i1480 = icmp eq i64 %arg.run.5.12.2, %.716.i
  br i1 %exitcond.not.i1480, label %b115, label %B102.if.i
b115:
  store i8 0, ptr %.1201, align 1
  call fastcc void @v79(ptr %.1201, i64 %arg.run.0.4, ptr %arg.run.1.0.4, i64 %arg.run.1.1.2, ptr nonnull %arg.run.1.1.4, ptr %arg.run.1.2.4, i64 %arg.run.1.3.2, ptr %arg.run.1.3.4, ptr %arg.run.1.4.4, i64 %arg.run.5.0.2, ptr %arg.run.5.0.4, ptr %arg.run.5.3.4, ptr %arg.segment.2.4, i64 %arg.segment.2.5.1, double %.13.i.i, ptr %arg.run.5.12.4)
  %.1308 = load i8, ptr %.1201, align 1
  %.1311.not = icmp eq i8 %.1308, 0
  br i1 %.1311.not, label %B78.if.i.backedge, label %common.ret
}
define internal fastcc void @v91(ptr noalias nonnull writeonly %retptr, i64 %arg.run.0.3, ptr %arg.run.1.0.4, i64 %arg.run.2.1.2, i64 %arg.run.3.0.2, ptr readonly %arg.run.3.0.4, i64 %arg.run.3.0.5.0, ptr writeonly %arg.run.3.1.4, i64 %arg.run.3.1.5.1, i64 %arg.run.3.2.2, ptr %arg.run.3.2.4, i64 %arg.run.5.0.2, ptr %arg.run.5.0.4, ptr %arg.run.5.3.4, ptr %arg.run.5.6.4, i64 %arg.run.5.6.5.0, ptr readonly %arg.run.5.11.4, i64 %arg.run.5.11.5.0, i64 %arg.run.6.2, ptr readonly %arg.run.6.4, ptr %arg.run.9.4, ptr readonly %arg.segment.2.4, i64 %arg.segment.2.5.1, double %arg.step.0, double %arg.step.1, ptr readonly %arg.step.3.4, double %arg.end) unnamed_addr {
entry:
  %.5.i = fmul double %arg.end, 0x3D06849B86A12B9B
  %.6.i = fadd double %.5.i, 1.000000e-15
  %.510 = fsub double %arg.end, %.6.i
  %.731 = icmp slt i64 %arg.run.5.6.5.0, 1
  br i1 %.731, label %B0.endif.else.endif.if, label %B0.endif.else.endif.endif, !prof !84
B188:
  %.976 = icmp slt i64 %.913, 0
  %.977 = select i1 %.976, i64 %arg.run.3.0.5.0, i64 0
  %0 = getelementptr double, ptr %arg.run.3.0.4, i64 %.913
  %.991 = getelementptr double, ptr %0, i64 %.977
  %.992 = load double, ptr %.991, align 8
  %.994 = fcmp olt double %.992, %.510
  br i1 %.994, label %B244.preheader, label %common.ret
B244.preheader:
  %.703768.not.i = icmp slt i64 %.799, 1
  %.148211.not.i.i.i = icmp slt i64 %arg.run.5.0.2, 1
  %.992.i.i = inttoptr i64 %arg.run.0.3 to ptr
  %.754872.not.i = icmp slt i64 %arg.run.3.2.2, 1
  br label %B244
B244:
  %.1032 = phi i64 [ %.913, %B244.preheader ], [ %.922.i, %B478 ]
  %.1049 = icmp slt i64 %.1032, 0
  %.1050 = select i1 %.1049, i64 %arg.run.3.0.5.0, i64 0
  %1 = getelementptr double, ptr %arg.run.3.0.4, i64 %.1032
  %.1064 = getelementptr double, ptr %1, i64 %.1050
  %.1065 = load double, ptr %.1064, align 8
  %.1069 = fsub double %.1065, %arg.step.0
  %.1075 = fdiv double %.1069, %arg.step.1
  %.12.i = fcmp ogt double %.1075, 0.000000e+00
  %.13.i = select i1 %.12.i, double %.1075, double 0.000000e+00
  %.478.i = fsub double 1.000000e+00, %.13.i
  br i1 %.703768.not.i, label %b115, label %B102.if.i
B102.if.i:
  %.645.0769.i = phi i64 [ %.716.i, %B102.if.i ], [ 0, %B244 ]
  %.716.i = add nuw nsw i64 %.645.0769.i, 1
  %2 = getelementptr double, ptr %arg.run.6.4, i64 %.645.0769.i
  %.774.i = load double, ptr %2, align 8, !noalias !430
  %.779.i = fmul double %.478.i, %.774.i
  %3 = getelementptr double, ptr %arg.step.3.4, i64 %.645.0769.i
  %.813.i = load double, ptr %3, align 8, !noalias !430
  %4 = getelementptr double, ptr %arg.run.5.11.4, i64 %.645.0769.i
  %.846.i = load double, ptr %4, align 8, !noalias !430
  %.848.i = add nsw i64 %.645.0769.i, %arg.run.6.2
  %.862.i = icmp slt i64 %.848.i, 0
  %.863.i = select i1 %.862.i, i64 %arg.run.5.11.5.0, i64 0
  %5 = getelementptr double, ptr %arg.run.5.11.4, i64 %.848.i
  %.877.i = getelementptr double, ptr %5, i64 %.863.i
  %.878.i = load double, ptr %.877.i, align 8, !noalias !430
  %.880.i = fmul double %.13.i, %.878.i
  %.881.i = fadd double %.846.i, %.880.i
  %.883.i = fmul double %.478.i, %.881.i
  %.884.i = fadd double %.813.i, %.883.i
  %.886.i = fmul double %.13.i, %.884.i
  %.887.i = fadd double %.779.i, %.886.i
  %6 = getelementptr double, ptr %.824, i64 %.645.0769.i
  store double %.887.i, ptr %6, align 8, !noalias !430
  %exitcond.not.i = icmp eq i64 %.799, %.716.i
  br i1 %exitcond.not.i, label %b115, label %B102.if.i
b115:
  br i1 %.148211.not.i.i.i, label %b96, label %B58.if.i.i.i
B164.i.i.i:
  %.44.i.i.i.i = getelementptr i8, ptr %8, i64 24
  %.45.i.i.i.i = load double, ptr %.44.i.i.i.i, align 8, !noalias !433
  %.73.i.i.i.i = getelementptr i8, ptr %8, i64 32
  %.74.i.i.i.i = load double, ptr %.73.i.i.i.i, align 8, !noalias !433
  %.75.i.i.i.i = fmul double %.74.i.i.i.i, 5.000000e-01
  %.76.i.i.i.i = fmul double %.245.i.i.i, %.75.i.i.i.i
  %.77.i.i.i.i = fadd double %.45.i.i.i.i, %.76.i.i.i.i
  %.78.i.i.i.i = fmul double %.245.i.i.i, %.77.i.i.i.i
  %.87.le.i.i.i.i = tail call double @llvm.floor.f64(double %.78.i.i.i.i)
  %.92.i.i.i.i = fsub double %.78.i.i.i.i, %.87.le.i.i.i.i
  %.93.i.i.i.i = fmul double %.92.i.i.i.i, 0x401921FB54442D18
  %.121.i.i.i.i = getelementptr i8, ptr %8, i64 40
  %.122.i.i.i.i = load double, ptr %.121.i.i.i.i, align 8, !noalias !433
  %.126.i.i.i.i = fadd double %.122.i.i.i.i, %.93.i.i.i.i
  %.593.le.i.i.i = tail call double @llvm.sin.f64(double %.126.i.i.i.i)
  %.598.i.i.i = fmul double %.423.i.i.i, %.593.le.i.i.i
  %.600.i.i.i = fadd double %.361.i.i.i, %.598.i.i.i
  br label %B272.i.i.i
B272.i.i.i:
  %value.2.1.i.i.i = phi double [ %.600.i.i.i, %B164.i.i.i ], [ %.361.i.i.i, %B58.if.i.i.i ]
  %7 = getelementptr double, ptr %arg.run.5.0.4, i64 %.90.0213.i.i.i
  store double %value.2.1.i.i.i, ptr %7, align 8, !noalias !442
  %exitcond.not.i.i.i = icmp eq i64 %arg.run.5.0.2, %.161.i.i.i
  br i1 %exitcond.not.i.i.i, label %b96, label %B58.if.i.i.i
B58.if.i.i.i:
  %.90.0213.i.i.i = phi i64 [ %.161.i.i.i, %B272.i.i.i ], [ 0, %b115 ]
  %.161.i.i.i = add nuw nsw i64 %.90.0213.i.i.i, 1
  %.238.i.i.i = mul i64 %.90.0213.i.i.i, %arg.segment.2.5.1
  %8 = getelementptr double, ptr %arg.segment.2.4, i64 %.238.i.i.i
  %.242.i.i.i = getelementptr i8, ptr %8, i64 48
  %.243.i.i.i = load double, ptr %.242.i.i.i, align 8, !noalias !442
  %.245.i.i.i = fsub double %.1065, %.243.i.i.i
  %.303.i.i.i = load double, ptr %8, align 8, !noalias !442
  %.357.i.i.i = getelementptr i8, ptr %8, i64 8
  %.358.i.i.i = load double, ptr %.357.i.i.i, align 8, !noalias !442
  %.360.i.i.i = fmul double %.245.i.i.i, %.358.i.i.i
  %.361.i.i.i = fadd double %.303.i.i.i, %.360.i.i.i
  %.422.i.i.i = getelementptr i8, ptr %8, i64 16
  %.423.i.i.i = load double, ptr %.422.i.i.i, align 8, !noalias !442
  %.424.i.i.i = fcmp une double %.423.i.i.i, 0.000000e+00
  br i1 %.424.i.i.i, label %B164.i.i.i, label %B272.i.i.i
b96:
  store double %.1065, ptr %arg.run.5.3.4, align 8, !noalias !443
  tail call void %.992.i.i(ptr nonnull %arg.run.5.3.4, ptr %.824, ptr %arg.run.5.0.4, ptr %arg.run.1.0.4, ptr %arg.run.3.2.4), !noalias !443
  %.649.i = load i64, ptr %.912, align 8, !noalias !444
  br i1 %.754872.not.i, label %b97, label %B116.if.lr.ph.i
B116.if.lr.ph.i:
  %invariant.gep.i = getelementptr double, ptr %arg.run.3.1.4, i64 %.649.i
  %.879.i = icmp slt i64 %.649.i, 0
  %.880.i3007 = select i1 %.879.i, i64 %arg.run.3.1.5.1, i64 0
  %invariant.gep875.i = getelementptr double, ptr %invariant.gep.i, i64 %.880.i3007
  br label %B116.if.i
B116.if.i:
  %.698.0873.i = phi i64 [ 0, %B116.if.lr.ph.i ], [ %.767.i, %B116.if.i ]
  %.767.i = add nuw nsw i64 %.698.0873.i, 1
  %9 = getelementptr double, ptr %arg.run.3.2.4, i64 %.698.0873.i
  %.821.i = load double, ptr %9, align 8, !noalias !444
  %.898.i = mul i64 %.698.0873.i, %arg.run.3.1.5.1
  %gep876.i = getelementptr double, ptr %invariant.gep875.i, i64 %.898.i
  store double %.821.i, ptr %gep876.i, align 8, !noalias !444
  %exitcond.not.i3008 = icmp eq i64 %.767.i, %arg.run.3.2.2
  br i1 %exitcond.not.i3008, label %b97, label %B116.if.i
b97:
  %.922.i = add nsw i64 %.649.i, 1
  store i64 %.922.i, ptr %.912, align 8, !noalias !444
  %.1387 = icmp slt i64 %.922.i, %arg.run.3.0.2
  br i1 %.1387, label %B478, label %common.ret
B478:
  %.1439 = icmp slt i64 %.649.i, -1
  %.1440 = select i1 %.1439, i64 %arg.run.3.0.5.0, i64 0
  %10 = getelementptr double, ptr %arg.run.3.0.4, i64 %.922.i
  %.1454 = getelementptr double, ptr %10, i64 %.1440
  %.1455 = load double, ptr %.1454, align 8
  %.1457 = fcmp olt double %.1455, %.510
  br i1 %.1457, label %B244, label %common.ret
common.ret:
  store ptr null, ptr %retptr, align 8
  ret void
B0.endif.endif:
  %.711.sroa.13.0 = phi i64 [ %arg.run.5.6.5.0, %B0.endif.else.endif.endif.endif.if ], [ %.711.sroa.13.1, %B0.endif.else.endif.endif.endif ]
  %.799 = sub i64 %.711.sroa.13.0, %.711.sroa.0.3
  %.824 = getelementptr double, ptr %arg.run.5.6.4, i64 %.711.sroa.0.3
  %.912 = getelementptr i8, ptr %arg.run.9.4, i64 16
  %.913 = load i64, ptr %.912, align 8
  %.924 = icmp slt i64 %.913, %arg.run.3.0.2
  br i1 %.924, label %B188, label %common.ret
B0.endif.else.endif.if:
  br label %B0.endif.else.endif.endif
B0.endif.else.endif.endif:
  %.711.sroa.0.3 = phi i64 [ %arg.run.5.6.5.0, %B0.endif.else.endif.if ], [ 0, %entry ]
  %.738 = icmp slt i64 %arg.run.2.1.2, 0
  %.739 = select i1 %.738, i64 %arg.run.5.6.5.0, i64 0
  %.740 = add i64 %.739, %arg.run.2.1.2
  %.743 = icmp slt i64 %.740, 0
  br i1 %.743, label %B0.endif.else.endif.endif.if, label %B0.endif.else.endif.endif.endif, !prof !84
B0.endif.else.endif.endif.if:
  br label %B0.endif.else.endif.endif.endif
B0.endif.else.endif.endif.endif:
  %.711.sroa.13.1 = phi i64 [ 0, %B0.endif.else.endif.endif.if ], [ %.740, %B0.endif.else.endif.endif ]
  %.748.not = icmp slt i64 %.740, %arg.run.5.6.5.0
  br i1 %.748.not, label %B0.endif.endif, label %B0.endif.else.endif.endif.endif.if, !prof !109
B0.endif.else.endif.endif.endif.if:
  br label %B0.endif.endif
}
define noundef i64 @integrate_lanes(ptr initializes((424, 432)) %job) local_unnamed_addr {
  %.49.i.i.i.i.i = alloca { [5 x i64], { { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, double, double, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, i8 }, { { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] } }, [13 x { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }], { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, align 8
  %.49.i.i.i.i = alloca { [5 x i64], { { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, double, double, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, i8 }, { { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] } }, [13 x { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }], { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, align 8
  %.5458.i.i.i = alloca [2 x double], align 8
  %.11308.i.i = alloca i8, align 1
  %.11448.i.i = alloca ptr, align 8
  %.12683.i.i = alloca ptr, align 8
  %.13078.i.i = alloca ptr, align 8
  %.15490.i.i = alloca i64, align 8
  %.15973.i.i = alloca ptr, align 8
  %.2637.i = alloca ptr, align 8
  call void @llvm.lifetime.start.p0(ptr nonnull %.2637.i)
  store ptr null, ptr %.2637.i, align 8, !noalias !445
  %.714.i = load i64, ptr %job, align 8, !noalias !445
  %.1060.i = getelementptr i8, ptr %job, i64 136
  %.1061.i = load i64, ptr %.1060.i, align 8, !noalias !445
  %1 = getelementptr i8, ptr %job, i64 584
  %.45.i.i = load i64, ptr %1, align 8, !noalias !449
  %.46.i.i = inttoptr i64 %.45.i.i to ptr
  %.1770.i = getelementptr i8, ptr %job, i64 208
  %.1771.i = load i64, ptr %.1770.i, align 8, !noalias !445
  %.1772.i = inttoptr i64 %.1771.i to ptr
  %.2182.i = getelementptr i8, ptr %job, i64 424
  store i64 %.714.i, ptr %.2182.i, align 8, !noalias !445
  %spec.select.i = tail call i64 @llvm.smax.i64(i64 %.714.i, i64 0)
  %.2384449.not.i = icmp slt i64 %.1061.i, 1
  %.360.i.i = getelementptr i8, ptr %job, i64 608
  br label %B360.i
B360.i:
  %.2207.0.i = phi i64 [ 0, %0 ], [ %.2276.i, %B456.i ]
  %exitcond454.not.i = icmp eq i64 %.2207.0.i, %spec.select.i
  br i1 %exitcond454.not.i, label %B552.i, label %B360.if.i
B456.i:
  %.361.i.i = load i64, ptr %.360.i.i, align 8, !noalias !452
  %.362.i.i = inttoptr i64 %.361.i.i to ptr
  %2 = getelementptr i64, ptr %.362.i.i, i64 %.2207.0.i
  store i64 -1, ptr %2, align 8, !noalias !445
  store ptr null, ptr %.2637.i, align 8, !noalias !445
  %.2643.i = call fastcc i32 @v71(ptr %.2637.i, ptr nonnull %job, i64 %.2207.0.i)
  %.2645.not.i = icmp eq i32 %.2643.i, 0
  br i1 %.2645.not.i, label %B360.i, label %b116, !prof !109
B552.i:
  %.3030.i = load i64, ptr %.2182.i, align 8, !noalias !445
  %.3031.i = icmp sgt i64 %.3030.i, 0
  br i1 %.3031.i, label %B596.preheader.i, label %b116
B596.preheader.i:
  %3 = getelementptr i8, ptr %job, i64 448
  %4 = getelementptr i8, ptr %job, i64 456
  %.1630.i.i = getelementptr i8, ptr %job, i64 176
  %.45.i2038.i.i = getelementptr i8, ptr %job, i64 352
  %.fca.1.gep233.i.i.i = getelementptr inbounds i8, ptr %.5458.i.i.i, i64 8
  %.2405.i.i.i = getelementptr i8, ptr %job, i64 464
  %.2752.i.i.i = getelementptr i8, ptr %job, i64 472
  %.3099.i.i.i = getelementptr i8, ptr %job, i64 488
  %.3446.i.i.i = getelementptr i8, ptr %job, i64 496
  %.3793.i.i.i = getelementptr i8, ptr %job, i64 504
  %.4140.i.i.i = getelementptr i8, ptr %job, i64 512
  %.4487.i.i.i = getelementptr i8, ptr %job, i64 520
  %.1982.i.i = getelementptr i8, ptr %job, i64 248
  %5 = getelementptr i8, ptr %job, i64 576
  %.5957.i.i.i = getelementptr i8, ptr %job, i64 48
  %.470.i.i.i.i.i = getelementptr i8, ptr %job, i64 224
  %.817.i.i.i.i.i = getelementptr i8, ptr %job, i64 144
  %.45.i384.i.i.i.i.i = getelementptr i8, ptr %job, i64 312
  %.2713.i.i.i.i.i = getelementptr i8, ptr %job, i64 264
  %.3065.i.i.i.i.i = getelementptr i8, ptr %job, i64 232
  %.3470.i.i.i.i.i = getelementptr i8, ptr %job, i64 320
  %.fca.5.0.2.gep.i.i.i.i.i = getelementptr inbounds i8, ptr %.49.i.i.i.i.i, i64 872
  %.fca.5.0.4.gep.i.i.i.i.i = getelementptr inbounds i8, ptr %.49.i.i.i.i.i, i64 888
  %6 = getelementptr i8, ptr %job, i64 480
  %.fca.5.0.2.gep.i.i.i.i = getelementptr inbounds i8, ptr %.49.i.i.i.i, i64 872
  %.fca.5.0.4.gep.i.i.i.i = getelementptr inbounds i8, ptr %.49.i.i.i.i, i64 888
  %.3185.i.i = getelementptr i8, ptr %job, i64 32
  %.5961.i.i = getelementptr i8, ptr %job, i64 528
  %.6308.i.i = getelementptr i8, ptr %job, i64 536
  %.6655.i.i = getelementptr i8, ptr %job, i64 552
  %.7004.i.i = getelementptr i8, ptr %job, i64 56
  %.7351.i.i = getelementptr i8, ptr %job, i64 568
  %.8739.i.i = getelementptr i8, ptr %job, i64 544
  %.10471.i.i = getelementptr i8, ptr %job, i64 40
  %.11165.i.i = getelementptr i8, ptr %job, i64 560
  %.11846.i.i = getelementptr i8, ptr %job, i64 64
  %.13468.i.i = getelementptr i8, ptr %job, i64 72
  %.14856.i.i = getelementptr i8, ptr %job, i64 592
  %.45.i2043.i.i = getelementptr i8, ptr %job, i64 400
  br label %B596.i
B596.i:
  call void @llvm.lifetime.start.p0(ptr nonnull %.11308.i.i), !noalias !445
  call void @llvm.lifetime.start.p0(ptr nonnull %.11448.i.i), !noalias !445
  call void @llvm.lifetime.start.p0(ptr nonnull %.12683.i.i), !noalias !445
  call void @llvm.lifetime.start.p0(ptr nonnull %.13078.i.i), !noalias !445
  call void @llvm.lifetime.start.p0(ptr nonnull %.15490.i.i), !noalias !445
  call void @llvm.lifetime.start.p0(ptr nonnull %.15973.i.i), !noalias !445
  store i8 0, ptr %.11308.i.i, align 1, !noalias !455
  store ptr null, ptr %.11448.i.i, align 8, !noalias !455
  store ptr null, ptr %.12683.i.i, align 8, !noalias !455
  store ptr null, ptr %.13078.i.i, align 8, !noalias !455
  store i64 0, ptr %.15490.i.i, align 8, !noalias !455
  store ptr null, ptr %.15973.i.i, align 8, !noalias !455
  %.364.i.i = load i64, ptr %job, align 8, !noalias !455
  %.361.i.i.i = load i64, ptr %.360.i.i, align 8, !noalias !459
  %.362.i.i.i = inttoptr i64 %.361.i.i.i to ptr
  %.45.i.i.i = load i64, ptr %3, align 8, !noalias !462
  %.46.i.i.i = inttoptr i64 %.45.i.i.i to ptr
  %.45.i2027.i.i = load i64, ptr %4, align 8, !noalias !465
  %.46.i2028.i.i = inttoptr i64 %.45.i2027.i.i to ptr
  %.1631.i.i = load i64, ptr %.1630.i.i, align 8, !noalias !455
  %.1632.i.i = icmp sgt i64 %.1631.i.i, 0
  br i1 %.1632.i.i, label %B266.i.i, label %B224.i.i
B224.i.i:
  %.1983.i.i = load i64, ptr %.1982.i.i, align 8, !noalias !455
  %.1984.i.i = icmp sgt i64 %.1983.i.i, 0
  br label %B266.i.i
B266.i.i:
  %"$phi266.0.2.0.i.i" = phi i1 [ true, %B596.i ], [ %.1984.i.i, %B224.i.i ]
  %.46.i2039.i.i = load i64, ptr %.45.i2038.i.i, align 8, !noalias !468
  %.50.i.i.i = inttoptr i64 %.46.i2039.i.i to ptr
  %.2371.i.i = getelementptr i8, ptr %.50.i.i.i, i64 16
  %.2372.i.i = load double, ptr %.2371.i.i, align 8, !noalias !455
  %.2376.i.i = fcmp une double %.2372.i.i, 0.000000e+00
  %.2735.i.i = mul nsw i64 %.364.i.i, 136
  %.2736.i.i = add nsw i64 %.45.i.i.i, %.2735.i.i
  %.2737.i.i = inttoptr i64 %.2736.i.i to ptr
  call void @llvm.lifetime.start.p0(ptr nonnull %.5458.i.i.i), !noalias !455
  %.815.i.i.i = fcmp oeq double %.2372.i.i, 0.000000e+00
  %.905937.not.i.i.i = icmp sgt i64 %.364.i.i, 0
  br i1 %.905937.not.i.i.i, label %B148.if.lr.ph.i.i.i, label %B198.thread.i.i.i
B148.if.lr.ph.i.i.i:
  %.idx920.i.i.i = shl i64 %.364.i.i, 4
  %7 = getelementptr i8, ptr %.362.i.i.i, i64 %.idx920.i.i.i
  br label %B148.if.i.i.i
B198.i.i.i:
  %spec.select.i.i.i = select i1 %.999.i.i.i, i64 8, i64 16
  br label %B198.thread.i.i.i
B198.thread.i.i.i:
  %moves.2.0.lcssa960.i.i.i = phi i1 [ false, %B266.i.i ], [ %.999.i.i.i, %B198.i.i.i ]
  %8 = phi i64 [ 16, %B266.i.i ], [ %spec.select.i.i.i, %B198.i.i.i ]
  %"$phi272.0.2.0.in.i.i.i" = getelementptr i8, ptr %job, i64 %8
  %"$phi272.0.2.0.i.i.i" = load i64, ptr %"$phi272.0.2.0.in.i.i.i", align 8, !noalias !471
  %.2406.i.i.i = load i64, ptr %.2405.i.i.i, align 8, !noalias !471
  %.2753.i.i.i = load i64, ptr %.2752.i.i.i, align 8, !noalias !471
  %.3100.i.i.i = load i64, ptr %.3099.i.i.i, align 8, !noalias !471
  %.3447.i.i.i = load i64, ptr %.3446.i.i.i, align 8, !noalias !471
  %.3794.i.i.i = load i64, ptr %.3793.i.i.i, align 8, !noalias !471
  %.4141.i.i.i = load i64, ptr %.4140.i.i.i, align 8, !noalias !471
  %.4488.i.i.i = load i64, ptr %.4487.i.i.i, align 8, !noalias !471
  %.4489.i.i.i = inttoptr i64 %"$phi272.0.2.0.i.i.i" to ptr
  tail call void %.4489.i.i.i(i64 %.45.i2027.i.i, i64 %.2406.i.i.i, i64 %.2753.i.i.i, i64 %.3100.i.i.i, i64 %.3447.i.i.i, i64 %.3794.i.i.i, i64 %.4141.i.i.i, i64 %.4488.i.i.i), !noalias !471
  br i1 %.905937.not.i.i.i, label %B606.if.lr.ph.i.i.i, label %B972.i.i.i
B606.if.lr.ph.i.i.i:
  %.idx919.i.i.i = shl i64 %.364.i.i, 6
  %9 = getelementptr i8, ptr %.46.i.i.i, i64 %.idx919.i.i.i
  br label %B606.if.i.i.i
B648.i.i.i:
  %.45.i.i.i.i.i = load i64, ptr %.3793.i.i.i, align 8, !noalias !474
  %.46.i.i.i.i.i = inttoptr i64 %.45.i.i.i.i.i to ptr
  %.392.i.i.i.i.i = load i64, ptr %job, align 8, !noalias !474
  %.45.i300.i.i.i.i = load i64, ptr %.2405.i.i.i, align 8, !noalias !479
  %.46.i301.i.i.i.i = inttoptr i64 %.45.i300.i.i.i.i to ptr
  %.45.i311.i.i.i.i = load i64, ptr %5, align 8, !noalias !482
  %.46.i312.i.i.i.i = inttoptr i64 %.45.i311.i.i.i.i to ptr
  %.45.i322.i.i.i.i = load i64, ptr %3, align 8, !noalias !485
  %.46.i323.i.i.i.i = inttoptr i64 %.45.i322.i.i.i.i to ptr
  %.idx.i.i.i.i = mul i64 %.392.i.i.i.i.i, 96
  %10 = getelementptr i8, ptr %.46.i323.i.i.i.i, i64 %.idx.i.i.i.i
  %11 = getelementptr double, ptr %10, i64 %.4515.0943.i.i.i
  %.1557.i.i.i.i = load double, ptr %11, align 8, !noalias !488
  %.45.i333.i.i.i.i = load i64, ptr %4, align 8, !noalias !489
  %.46.i334.i.i.i.i = inttoptr i64 %.45.i333.i.i.i.i to ptr
  %12 = getelementptr double, ptr %.46.i334.i.i.i.i, i64 %.4515.0943.i.i.i
  %.1975.i.i.i.i = load double, ptr %12, align 8, !noalias !488
  %.1981.i.i.i.i = fsub double %.1557.i.i.i.i, %.1975.i.i.i.i
  %.1985.i.i.i.i = fdiv double 2.000000e+01, %.1981.i.i.i.i
  %.2334.i.i.i.i = load i64, ptr %.1060.i, align 8, !noalias !488
  %invariant.gep.i.i.i.i = getelementptr double, ptr %.46.i.i.i.i.i, i64 %.4515.0943.i.i.i
  %invariant.gep348.i.i.i.i = getelementptr double, ptr %.46.i301.i.i.i.i, i64 %.4515.0943.i.i.i
  %invariant.gep351.i.i.i.i = getelementptr double, ptr %.46.i312.i.i.i.i, i64 %.4515.0943.i.i.i
  %.2417354.not.i.i.i.i = icmp slt i64 %.2334.i.i.i.i, 1
  br i1 %.2417354.not.i.i.i.i, label %B532.i.i.i.i, label %B376.if.i.i.i.i
B532.i.i.i.i:
  %fastest.2.0.lcssa.i.i.i.i = phi double [ %.1985.i.i.i.i, %B648.i.i.i ], [ %.13.i345.i.i.i.i, %B376.if.i.i.i.i ]
  %.2688.i.i.i.i = fcmp olt double %.4666.i.i.i, 0.000000e+00
  br i1 %.2688.i.i.i.i, label %B544.i.i.i.i, label %B584.i.i.i.i
B544.i.i.i.i:
  %.2691.i.i.i.i = fneg double %.4666.i.i.i
  %.2698.i.i.i.i = fdiv double 1.000000e+00, %fastest.2.0.lcssa.i.i.i.i
  %.12.i.i.i.i.i = fcmp olt double %.2698.i.i.i.i, %.2691.i.i.i.i
  %.13.i.i.i.i.i = select i1 %.12.i.i.i.i.i, double %.2698.i.i.i.i, double %.2691.i.i.i.i
  br label %b117
B584.i.i.i.i:
  %.2739.i.i.i.i = fdiv double 1.000000e+00, %fastest.2.0.lcssa.i.i.i.i
  br label %b117
B376.if.i.i.i.i:
  %fastest.2.0357.i.i.i.i = phi double [ %.13.i345.i.i.i.i, %B376.if.i.i.i.i ], [ %.1985.i.i.i.i, %B648.i.i.i ]
  %.2361.0356.i.i.i.i = phi i64 [ %.2430.i.i.i.i, %B376.if.i.i.i.i ], [ 0, %B648.i.i.i ]
  %.2430.i.i.i.i = add nuw nsw i64 %.2361.0356.i.i.i.i, 1
  %.2502.i.i.i.i = mul i64 %.2361.0356.i.i.i.i, %.392.i.i.i.i.i
  %gep347.i.i.i.i = getelementptr double, ptr %invariant.gep.i.i.i.i, i64 %.2502.i.i.i.i
  %.2507.i.i.i.i = load double, ptr %gep347.i.i.i.i, align 8, !noalias !488
  %.2510.i.i.i.i = tail call double @llvm.fabs.f64(double %.2507.i.i.i.i)
  %.2511.i.i.i.i = fmul double %.2510.i.i.i.i, 2.000000e+01
  %gep350.i.i.i.i = getelementptr double, ptr %invariant.gep348.i.i.i.i, i64 %.2502.i.i.i.i
  %.2564.i.i.i.i = load double, ptr %gep350.i.i.i.i, align 8, !noalias !488
  %.2567.i.i.i.i = tail call double @llvm.fabs.f64(double %.2564.i.i.i.i)
  %gep353.i.i.i.i = getelementptr double, ptr %invariant.gep351.i.i.i.i, i64 %.2502.i.i.i.i
  %.2620.i.i.i.i = load double, ptr %gep353.i.i.i.i, align 8, !noalias !488
  %.2623.i.i.i.i = fadd double %.2567.i.i.i.i, %.2620.i.i.i.i
  %.2627.i.i.i.i = fdiv double %.2511.i.i.i.i, %.2623.i.i.i.i
  %.12.i344.i.i.i.i = fcmp ogt double %.2627.i.i.i.i, %fastest.2.0357.i.i.i.i
  %.13.i345.i.i.i.i = select i1 %.12.i344.i.i.i.i, double %.2627.i.i.i.i, double %fastest.2.0357.i.i.i.i
  %exitcond.not.i.i.i.i = icmp eq i64 %.2334.i.i.i.i, %.2430.i.i.i.i
  br i1 %exitcond.not.i.i.i.i, label %B532.i.i.i.i, label %B376.if.i.i.i.i
b117:
  %"$phi592.0.2.0.i.i.i.i" = phi double [ %.13.i.i.i.i.i, %B544.i.i.i.i ], [ %.2739.i.i.i.i, %B584.i.i.i.i ]
  store double %"$phi592.0.2.0.i.i.i.i", ptr %25, align 8, !noalias !471
  br label %B728.i.i.i
B728.i.i.i:
  %exitcond954.not.i.i.i = icmp eq i64 %.364.i.i, %.4584.i.i.i
  br i1 %exitcond954.not.i.i.i, label %B730.i.i.i, label %B606.if.i.i.i
B730.i.i.i:
  %.5164.i.i.i = load i64, ptr %.1630.i.i, align 8, !noalias !471
  %.5165.i.i.i = icmp sgt i64 %.5164.i.i.i, 0
  br i1 %.5165.i.i.i, label %B804.if.lr.ph.i.i.i, label %B972.i.i.i
B804.if.lr.ph.i.i.i:
  %.idx918.i.i.i = mul i64 %.364.i.i, 80
  %13 = getelementptr i8, ptr %.46.i.i.i, i64 %.idx918.i.i.i
  br label %B804.if.i.i.i
B846.i.i.i:
  %14 = getelementptr double, ptr %.46.i2028.i.i, i64 %.5191.0945.i.i.i
  %.5400.i.i.i = load double, ptr %14, align 8, !noalias !471
  %.5454.i.i.i = getelementptr double, ptr %9, i64 %.5191.0945.i.i.i
  %.5455.i.i.i = load double, ptr %.5454.i.i.i, align 8, !noalias !471
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %.5458.i.i.i, i8 0, i64 16, i1 false), !noalias !471
  call fastcc void @v88(ptr %.5458.i.i.i, ptr nonnull readonly %job, i64 %.5191.0945.i.i.i, double %.5400.i.i.i, double %.5455.i.i.i)
  %.5474.fca.1.load.i.i.i = load double, ptr %.fca.1.gep233.i.i.i, align 8, !noalias !471
  %.5474.fca.0.load.i.i.i = load double, ptr %.5458.i.i.i, align 8, !noalias !471
  store double %.5474.fca.0.load.i.i.i, ptr %.5454.i.i.i, align 8, !noalias !471
  %.5602.i.i.i = getelementptr double, ptr %13, i64 %.5191.0945.i.i.i
  store double %.5474.fca.1.load.i.i.i, ptr %.5602.i.i.i, align 8, !noalias !471
  br label %B970.i.i.i
B970.i.i.i:
  %exitcond955.not.i.i.i = icmp eq i64 %.364.i.i, %.5260.i.i.i
  br i1 %exitcond955.not.i.i.i, label %B972.i.i.i, label %B804.if.i.i.i
B972.i.i.i:
  %.5958.i.i.i = load i64, ptr %.5957.i.i.i, align 8, !noalias !471
  %.6305.i.i.i = load i64, ptr %3, align 8, !noalias !471
  %.6652.i.i.i = load i64, ptr %4, align 8, !noalias !471
  %.6999.i.i.i = load i64, ptr %.45.i2038.i.i, align 8, !noalias !471
  %.7000.i.i.i = inttoptr i64 %.5958.i.i.i to ptr
  tail call void %.7000.i.i.i(i64 %.6305.i.i.i, i64 %.6652.i.i.i, i64 %.6999.i.i.i), !noalias !471
  %.7043.i.i.i = add i64 %.364.i.i, -1
  %.7086947.not.i.i.i = icmp slt i64 %.7043.i.i.i, 1
  %or.cond967.i.i.i = or i1 %.7086947.not.i.i.i, %.815.i.i.i
  br i1 %or.cond967.i.i.i, label %B1214.i.i.i, label %B1172.if.lr.ph.i.i.i
B1172.if.lr.ph.i.i.i:
  %.111.i.i.i.i = getelementptr double, ptr %.46.i2028.i.i, i64 %.364.i.i
  %.164.idx.i.i.i.i = mul i64 %.364.i.i, 72
  %.164.i.i.i.i = getelementptr i8, ptr %.46.i.i.i, i64 %.164.idx.i.i.i.i
  %.217.idx.i.i.i.i = mul i64 %.364.i.i, 88
  %.217.i.i.i.i = getelementptr i8, ptr %.46.i.i.i, i64 %.217.idx.i.i.i.i
  br label %B1172.if.i.i.i
B1214.i.i.i:
  %or.cond953.i.i.i = and i1 %.905937.not.i.i.i, %moves.2.0.lcssa960.i.i.i
  br i1 %or.cond953.i.i.i, label %B1248.if.lr.ph.i.i.i, label %b118
B1248.if.lr.ph.i.i.i:
  %.idx.i.i.i = shl i64 %.364.i.i, 4
  %15 = getelementptr i8, ptr %.362.i.i.i, i64 %.idx.i.i.i
  %16 = getelementptr double, ptr %.46.i2028.i.i, i64 %.364.i.i
  br label %B1248.if.i.i.i
B1282.i.i.i:
  %.361.i.i.i.i.i = load i64, ptr %.360.i.i, align 8, !noalias !492
  %.362.i.i.i.i.i = inttoptr i64 %.361.i.i.i.i.i to ptr
  %.708.i.i.i.i.i = load i64, ptr %job, align 8, !noalias !492
  %17 = getelementptr i64, ptr %.362.i.i.i.i.i, i64 %.708.i.i.i.i.i
  %18 = getelementptr i64, ptr %17, i64 %.7202.0951.i.i.i
  %.119.i.i.i.i = load i64, ptr %18, align 8, !noalias !497
  %.471.i.i.i.i = load i64, ptr %.470.i.i.i.i.i, align 8, !noalias !497
  %.818.i.i.i.i = load i64, ptr %.817.i.i.i.i.i, align 8, !noalias !497
  %.46.i385.i.i.i.i = load i64, ptr %.45.i384.i.i.i.i.i, align 8, !noalias !498
  %.50.i386.i.i.i.i = inttoptr i64 %.46.i385.i.i.i.i to ptr
  %.2348.i.i.i.i = icmp slt i64 %.119.i.i.i.i, 0
  %.2349.i.i.i.i = select i1 %.2348.i.i.i.i, i64 %.471.i.i.i.i, i64 0
  %19 = getelementptr i64, ptr %.50.i386.i.i.i.i, i64 %.119.i.i.i.i
  %.2363.i.i.i.i = getelementptr i64, ptr %19, i64 %.2349.i.i.i.i
  %.2364.i.i.i.i = load i64, ptr %.2363.i.i.i.i, align 8, !noalias !497
  %.2714.i.i.i.i = load i64, ptr %.2713.i.i.i.i.i, align 8, !noalias !497
  %.2715.i.i.i.i = icmp sgt i64 %.2714.i.i.i.i, 0
  br i1 %.2715.i.i.i.i, label %B432.i.i.i.i, label %b119
B432.i.i.i.i:
  %.3066.i.i.i.i = load i64, ptr %.3065.i.i.i.i.i, align 8, !noalias !497
  %.3068.i.i.i.i = mul nsw i64 %.3066.i.i.i.i, %.7202.0951.i.i.i
  br label %b119
b119:
  %"$phi476.1.2.0.i.i.i.i" = phi i64 [ %.3068.i.i.i.i, %B432.i.i.i.i ], [ 0, %B1282.i.i.i ]
  %.3082.i.i.i.i = add nsw i64 %"$phi476.1.2.0.i.i.i.i", %.2364.i.i.i.i
  %.3471.i.i.i.i = load i64, ptr %.3470.i.i.i.i.i, align 8, !noalias !497
  %.3478.i.i.i.i = mul nsw i64 %.818.i.i.i.i, 56
  %.3479.i.i.i.i = mul nsw i64 %.3478.i.i.i.i, %.3082.i.i.i.i
  %.3480.i.i.i.i = add nsw i64 %.3479.i.i.i.i, %.3471.i.i.i.i
  %.3481.i.i.i.i = inttoptr i64 %.3480.i.i.i.i to ptr
  %.7457.i.i.i = getelementptr double, ptr %.46.i2028.i.i, i64 %.7202.0951.i.i.i
  %.7458.i.i.i = load double, ptr %.7457.i.i.i, align 8, !noalias !471
  %.7512.i.i.i = getelementptr double, ptr %16, i64 %.7202.0951.i.i.i
  %.7513.i.i.i = load double, ptr %.7512.i.i.i, align 8, !noalias !471
  call void @llvm.lifetime.start.p0(ptr nonnull %.49.i.i.i.i), !noalias !471
  call fastcc void @v77(ptr %.49.i.i.i.i, ptr nonnull readonly %job, i64 %.7202.0951.i.i.i)
  %.65.fca.5.0.2.load.i.i.i.i = load i64, ptr %.fca.5.0.2.gep.i.i.i.i, align 8, !noalias !501
  %.65.fca.5.0.4.load.i.i.i.i = load ptr, ptr %.fca.5.0.4.gep.i.i.i.i, align 8, !noalias !501
  %.45.i.i923.i.i.i = load i64, ptr %6, align 8, !noalias !504
  %.46.i.i924.i.i.i = inttoptr i64 %.45.i.i923.i.i.i to ptr
  %.148211.not.i.i.i.i.i = icmp slt i64 %.65.fca.5.0.2.load.i.i.i.i, 1
  %invariant.gep.i926.i.i.i = getelementptr double, ptr %.46.i.i924.i.i.i, i64 %.7202.0951.i.i.i
  br label %B138.if.i.i.i.i
B138.loopexit.i.i.i.i:
  %exitcond443.not.i.i.i.i = icmp eq i64 %.1193.i.i.i.i, 4
  br i1 %exitcond443.not.i.i.i.i, label %b120, label %B138.if.i.i.i.i
B138.if.i.i.i.i:
  %.1124.0442.i.i.i.i = phi i64 [ 0, %b119 ], [ %.1193.i.i.i.i, %B138.loopexit.i.i.i.i ]
  %.1193.i.i.i.i = add nuw nsw i64 %.1124.0442.i.i.i.i, 1
  %20 = getelementptr double, ptr @.const.array.data, i64 %.1124.0442.i.i.i.i
  %.1276.i.i.i.i = load double, ptr %20, align 8, !noalias !501
  %.1281.i.i.i.i = fmul double %.7513.i.i.i, %.1276.i.i.i.i
  %.1283.i.i.i.i = fadd double %.7458.i.i.i, %.1281.i.i.i.i
  br i1 %.148211.not.i.i.i.i.i, label %B138.loopexit.i.i.i.i, label %B58.if.i.i.i.i.i
B164.i.i.i.i.i:
  %.44.i.i.i.i.i.i = getelementptr i8, ptr %22, i64 24
  %.45.i.i.i.i.i.i = load double, ptr %.44.i.i.i.i.i.i, align 8, !noalias !507
  %.73.i.i.i.i.i.i = getelementptr i8, ptr %22, i64 32
  %.74.i.i.i.i.i.i = load double, ptr %.73.i.i.i.i.i.i, align 8, !noalias !507
  %.75.i.i.i.i.i.i = fmul double %.74.i.i.i.i.i.i, 5.000000e-01
  %.76.i.i.i.i.i.i = fmul double %.245.i.i.i.i.i, %.75.i.i.i.i.i.i
  %.77.i.i.i.i.i.i = fadd double %.45.i.i.i.i.i.i, %.76.i.i.i.i.i.i
  %.78.i.i.i.i.i.i = fmul double %.245.i.i.i.i.i, %.77.i.i.i.i.i.i
  %.87.le.i.i.i.i.i.i = tail call double @llvm.floor.f64(double %.78.i.i.i.i.i.i)
  %.92.i.i.i.i.i.i = fsub double %.78.i.i.i.i.i.i, %.87.le.i.i.i.i.i.i
  %.93.i.i.i.i.i.i = fmul double %.92.i.i.i.i.i.i, 0x401921FB54442D18
  %.121.i.i.i.i.i.i = getelementptr i8, ptr %22, i64 40
  %.122.i.i.i.i.i.i = load double, ptr %.121.i.i.i.i.i.i, align 8, !noalias !507
  %.126.i.i.i.i.i.i = fadd double %.122.i.i.i.i.i.i, %.93.i.i.i.i.i.i
  %.593.le.i.i.i.i.i = tail call double @llvm.sin.f64(double %.126.i.i.i.i.i.i)
  %.598.i.i.i.i.i = fmul double %.423.i.i.i.i.i, %.593.le.i.i.i.i.i
  %.600.i.i.i.i.i = fadd double %.361.i.i928.i.i.i, %.598.i.i.i.i.i
  br label %B272.i.i.i.i.i
B272.i.i.i.i.i:
  %value.2.1.i.i.i.i.i = phi double [ %.600.i.i.i.i.i, %B164.i.i.i.i.i ], [ %.361.i.i928.i.i.i, %B58.if.i.i.i.i.i ]
  %21 = getelementptr double, ptr %.65.fca.5.0.4.load.i.i.i.i, i64 %.90.0213.i.i.i.i.i
  store double %value.2.1.i.i.i.i.i, ptr %21, align 8, !noalias !512
  %exitcond.not.i.i.i.i.i = icmp eq i64 %.65.fca.5.0.2.load.i.i.i.i, %.161.i.i.i.i.i
  br i1 %exitcond.not.i.i.i.i.i, label %B260.preheader.i.i.i.i, label %B58.if.i.i.i.i.i
B260.preheader.i.i.i.i:
  %.1478.i.i.i.i = mul nuw nsw i64 %.1124.0442.i.i.i.i, %.65.fca.5.0.2.load.i.i.i.i
  br label %B260.if.i.i.i.i
B58.if.i.i.i.i.i:
  %.90.0213.i.i.i.i.i = phi i64 [ %.161.i.i.i.i.i, %B272.i.i.i.i.i ], [ 0, %B138.if.i.i.i.i ]
  %.161.i.i.i.i.i = add nuw nsw i64 %.90.0213.i.i.i.i.i, 1
  %.idx936.i.i.i = mul i64 %.90.0213.i.i.i.i.i, 56
  %22 = getelementptr i8, ptr %.3481.i.i.i.i, i64 %.idx936.i.i.i
  %.242.i.i.i.i.i = getelementptr i8, ptr %22, i64 48
  %.243.i.i.i.i.i = load double, ptr %.242.i.i.i.i.i, align 8, !noalias !512
  %.245.i.i.i.i.i = fsub double %.1283.i.i.i.i, %.243.i.i.i.i.i
  %.303.i.i.i.i.i = load double, ptr %22, align 8, !noalias !512
  %.357.i.i.i.i.i = getelementptr i8, ptr %22, i64 8
  %.358.i.i.i.i.i = load double, ptr %.357.i.i.i.i.i, align 8, !noalias !512
  %.360.i.i927.i.i.i = fmul double %.245.i.i.i.i.i, %.358.i.i.i.i.i
  %.361.i.i928.i.i.i = fadd double %.303.i.i.i.i.i, %.360.i.i927.i.i.i
  %.422.i.i.i.i.i = getelementptr i8, ptr %22, i64 16
  %.423.i.i.i.i.i = load double, ptr %.422.i.i.i.i.i, align 8, !noalias !512
  %.424.i.i.i.i.i = fcmp une double %.423.i.i.i.i.i, 0.000000e+00
  br i1 %.424.i.i.i.i.i, label %B164.i.i.i.i.i, label %B272.i.i.i.i.i
B260.if.i.i.i.i:
  %.1346.0437.i.i.i.i = phi i64 [ 0, %B260.preheader.i.i.i.i ], [ %.1415.i.i.i.i, %B260.if.i.i.i.i ]
  %.1415.i.i.i.i = add nuw nsw i64 %.1346.0437.i.i.i.i, 1
  %23 = getelementptr double, ptr %.65.fca.5.0.4.load.i.i.i.i, i64 %.1346.0437.i.i.i.i
  %.1469.i.i.i.i = load double, ptr %23, align 8, !noalias !501
  %.1479.i.i.i.i = add nuw nsw i64 %.1346.0437.i.i.i.i, %.1478.i.i.i.i
  %.1527.i.i.i.i = mul i64 %.1479.i.i.i.i, %.708.i.i.i.i.i
  %gep440.i.i.i.i = getelementptr double, ptr %invariant.gep.i926.i.i.i, i64 %.1527.i.i.i.i
  store double %.1469.i.i.i.i, ptr %gep440.i.i.i.i, align 8, !noalias !501
  %exitcond.not.i929.i.i.i = icmp eq i64 %.1415.i.i.i.i, %.65.fca.5.0.2.load.i.i.i.i
  br i1 %exitcond.not.i929.i.i.i, label %B138.loopexit.i.i.i.i, label %B260.if.i.i.i.i
b120:
  call void @llvm.lifetime.end.p0(ptr nonnull %.49.i.i.i.i), !noalias !471
  br label %B1380.i.i.i
B1380.i.i.i:
  %exitcond957.not.i.i.i = icmp eq i64 %.364.i.i, %.7271.i.i.i
  br i1 %exitcond957.not.i.i.i, label %b118, label %B1248.if.i.i.i
B148.if.i.i.i:
  %moves.2.0940.i.i.i = phi i1 [ false, %B148.if.lr.ph.i.i.i ], [ %.999.i.i.i, %B148.if.i.i.i ]
  %.849.0939.i.i.i = phi i64 [ 0, %B148.if.lr.ph.i.i.i ], [ %.918.i.i.i, %B148.if.i.i.i ]
  %.918.i.i.i = add nuw nsw i64 %.849.0939.i.i.i, 1
  %24 = getelementptr i64, ptr %7, i64 %.849.0939.i.i.i
  %.996.i.i.i = load i64, ptr %24, align 8, !noalias !471
  %.996.fr.i.i.i = freeze i64 %.996.i.i.i
  %.997.i.i.i = icmp ne i64 %.996.fr.i.i.i, 0
  %.999.i.i.i = or i1 %moves.2.0940.i.i.i, %.997.i.i.i
  %exitcond.not.i.i.i = icmp eq i64 %.364.i.i, %.918.i.i.i
  br i1 %exitcond.not.i.i.i, label %B198.i.i.i, label %B148.if.i.i.i
B606.if.i.i.i:
  %.4515.0943.i.i.i = phi i64 [ 0, %B606.if.lr.ph.i.i.i ], [ %.4584.i.i.i, %B728.i.i.i ]
  %.4584.i.i.i = add nuw nsw i64 %.4515.0943.i.i.i, 1
  %25 = getelementptr double, ptr %9, i64 %.4515.0943.i.i.i
  %.4666.i.i.i = load double, ptr %25, align 8, !noalias !471
  %.4667.i.i.i = fcmp ugt double %.4666.i.i.i, 0.000000e+00
  br i1 %.4667.i.i.i, label %B728.i.i.i, label %B648.i.i.i
B804.if.i.i.i:
  %.5191.0945.i.i.i = phi i64 [ 0, %B804.if.lr.ph.i.i.i ], [ %.5260.i.i.i, %B970.i.i.i ]
  %.5260.i.i.i = add nuw nsw i64 %.5191.0945.i.i.i, 1
  %26 = getelementptr i64, ptr %.362.i.i.i, i64 %.5191.0945.i.i.i
  %.5342.i.i.i = load i64, ptr %26, align 8, !noalias !471
  %.5343.i.i.i = icmp sgt i64 %.5342.i.i.i, -1
  br i1 %.5343.i.i.i, label %B846.i.i.i, label %B970.i.i.i
B1172.if.i.i.i:
  %.7030.0948.i.i.i = phi i64 [ 1, %B1172.if.lr.ph.i.i.i ], [ %.7099.i.i.i, %b121 ]
  %.7099.i.i.i = add nuw i64 %.7030.0948.i.i.i, 1
  %.112.i.i.i.i = load double, ptr %.111.i.i.i.i, align 8, !noalias !513
  %.165.i.i.i.i = load double, ptr %.164.i.i.i.i, align 8, !noalias !513
  %.218.i.i.i.i = load double, ptr %.217.i.i.i.i, align 8, !noalias !513
  %.272.i.i.i.i = getelementptr double, ptr %.111.i.i.i.i, i64 %.7030.0948.i.i.i
  store double %.112.i.i.i.i, ptr %.272.i.i.i.i, align 8, !noalias !513
  %.326.i.i.i.i = getelementptr double, ptr %.164.i.i.i.i, i64 %.7030.0948.i.i.i
  store double %.165.i.i.i.i, ptr %.326.i.i.i.i, align 8, !noalias !513
  %.380.i.i.i.i = getelementptr double, ptr %.217.i.i.i.i, i64 %.7030.0948.i.i.i
  store double %.218.i.i.i.i, ptr %.380.i.i.i.i, align 8, !noalias !513
  %.361.i.i931.i.i.i = load i64, ptr %.360.i.i, align 8, !noalias !516
  %.362.i.i932.i.i.i = inttoptr i64 %.361.i.i931.i.i.i to ptr
  %.708.i.i933.i.i.i = load i64, ptr %job, align 8, !noalias !516
  %.idx329.i.i.i.i = shl i64 %.708.i.i933.i.i.i, 4
  %27 = getelementptr i8, ptr %.362.i.i932.i.i.i, i64 %.idx329.i.i.i.i
  %28 = getelementptr i64, ptr %27, i64 %.7030.0948.i.i.i
  %.485.i.i.i.i = load i64, ptr %28, align 8, !noalias !513
  %.491.not.i.i.i.i = icmp eq i64 %.485.i.i.i.i, 0
  br i1 %.491.not.i.i.i.i, label %b121, label %B188.i.i.i.i
B188.i.i.i.i:
  %29 = getelementptr i64, ptr %.362.i.i932.i.i.i, i64 %.708.i.i933.i.i.i
  %30 = getelementptr i64, ptr %29, i64 %.7030.0948.i.i.i
  %.119.i.i.i.i.i = load i64, ptr %30, align 8, !noalias !519
  %.471.i.i.i.i.i = load i64, ptr %.470.i.i.i.i.i, align 8, !noalias !519
  %.818.i.i.i.i.i = load i64, ptr %.817.i.i.i.i.i, align 8, !noalias !519
  %.46.i385.i.i.i.i.i = load i64, ptr %.45.i384.i.i.i.i.i, align 8, !noalias !522
  %.50.i386.i.i.i.i.i = inttoptr i64 %.46.i385.i.i.i.i.i to ptr
  %.2348.i.i.i.i.i = icmp slt i64 %.119.i.i.i.i.i, 0
  %.2349.i.i.i.i.i = select i1 %.2348.i.i.i.i.i, i64 %.471.i.i.i.i.i, i64 0
  %31 = getelementptr i64, ptr %.50.i386.i.i.i.i.i, i64 %.119.i.i.i.i.i
  %.2363.i.i.i.i.i = getelementptr i64, ptr %31, i64 %.2349.i.i.i.i.i
  %.2364.i.i.i.i.i = load i64, ptr %.2363.i.i.i.i.i, align 8, !noalias !519
  %.2714.i.i.i.i.i = load i64, ptr %.2713.i.i.i.i.i, align 8, !noalias !519
  %.2715.i.i.i.i.i = icmp sgt i64 %.2714.i.i.i.i.i, 0
  br i1 %.2715.i.i.i.i.i, label %B432.i.i.i.i.i, label %b122
B432.i.i.i.i.i:
  %.3066.i.i.i.i.i = load i64, ptr %.3065.i.i.i.i.i, align 8, !noalias !519
  %.3068.i.i.i.i.i = mul nsw i64 %.3066.i.i.i.i.i, %.7030.0948.i.i.i
  br label %b122
b122:
  %"$phi476.1.2.0.i.i.i.i.i" = phi i64 [ %.3068.i.i.i.i.i, %B432.i.i.i.i.i ], [ 0, %B188.i.i.i.i ]
  %.3082.i.i.i.i.i = add nsw i64 %"$phi476.1.2.0.i.i.i.i.i", %.2364.i.i.i.i.i
  %.3471.i.i.i.i.i = load i64, ptr %.3470.i.i.i.i.i, align 8, !noalias !519
  %.3478.i.i.i.i.i = mul nsw i64 %.818.i.i.i.i.i, 56
  %.3479.i.i.i.i.i = mul nsw i64 %.3478.i.i.i.i.i, %.3082.i.i.i.i.i
  %.3480.i.i.i.i.i = add nsw i64 %.3479.i.i.i.i.i, %.3471.i.i.i.i.i
  %.3481.i.i.i.i.i = inttoptr i64 %.3480.i.i.i.i.i to ptr
  %.594.i.i.i.i = getelementptr double, ptr %.46.i2028.i.i, i64 %.7030.0948.i.i.i
  %.595.i.i.i.i = load double, ptr %.594.i.i.i.i, align 8, !noalias !513
  %.650.i.i.i.i = load double, ptr %.272.i.i.i.i, align 8, !noalias !513
  call void @llvm.lifetime.start.p0(ptr nonnull %.49.i.i.i.i.i), !noalias !513
  call fastcc void @v77(ptr %.49.i.i.i.i.i, ptr nonnull readonly %job, i64 %.7030.0948.i.i.i)
  %.65.fca.5.0.2.load.i.i.i.i.i = load i64, ptr %.fca.5.0.2.gep.i.i.i.i.i, align 8, !noalias !525
  %.65.fca.5.0.4.load.i.i.i.i.i = load ptr, ptr %.fca.5.0.4.gep.i.i.i.i.i, align 8, !noalias !525
  %.45.i.i330.i.i.i.i = load i64, ptr %6, align 8, !noalias !528
  %.46.i.i331.i.i.i.i = inttoptr i64 %.45.i.i330.i.i.i.i to ptr
  %.148211.not.i.i.i.i.i.i = icmp slt i64 %.65.fca.5.0.2.load.i.i.i.i.i, 1
  %invariant.gep.i.i.i.i.i = getelementptr double, ptr %.46.i.i331.i.i.i.i, i64 %.7030.0948.i.i.i
  br label %B138.if.i.i.i.i.i
B138.loopexit.i.i.i.i.i:
  %exitcond443.not.i.i.i.i.i = icmp eq i64 %.1193.i.i.i.i.i, 4
  br i1 %exitcond443.not.i.i.i.i.i, label %b123, label %B138.if.i.i.i.i.i
B138.if.i.i.i.i.i:
  %.1124.0442.i.i.i.i.i = phi i64 [ 0, %b122 ], [ %.1193.i.i.i.i.i, %B138.loopexit.i.i.i.i.i ]
  %.1193.i.i.i.i.i = add nuw nsw i64 %.1124.0442.i.i.i.i.i, 1
  %32 = getelementptr double, ptr @.const.array.data, i64 %.1124.0442.i.i.i.i.i
  %.1276.i.i.i.i.i = load double, ptr %32, align 8, !noalias !525
  %.1281.i.i.i.i.i = fmul double %.650.i.i.i.i, %.1276.i.i.i.i.i
  %.1283.i.i.i.i.i = fadd double %.595.i.i.i.i, %.1281.i.i.i.i.i
  br i1 %.148211.not.i.i.i.i.i.i, label %B138.loopexit.i.i.i.i.i, label %B58.if.i.i.i.i.i.i
B164.i.i.i.i.i.i:
  %.44.i.i.i.i.i.i.i = getelementptr i8, ptr %34, i64 24
  %.45.i.i.i.i.i.i.i = load double, ptr %.44.i.i.i.i.i.i.i, align 8, !noalias !531
  %.73.i.i.i.i.i.i.i = getelementptr i8, ptr %34, i64 32
  %.74.i.i.i.i.i.i.i = load double, ptr %.73.i.i.i.i.i.i.i, align 8, !noalias !531
  %.75.i.i.i.i.i.i.i = fmul double %.74.i.i.i.i.i.i.i, 5.000000e-01
  %.76.i.i.i.i.i.i.i = fmul double %.245.i.i.i.i.i.i, %.75.i.i.i.i.i.i.i
  %.77.i.i.i.i.i.i.i = fadd double %.45.i.i.i.i.i.i.i, %.76.i.i.i.i.i.i.i
  %.78.i.i.i.i.i.i.i = fmul double %.245.i.i.i.i.i.i, %.77.i.i.i.i.i.i.i
  %.87.le.i.i.i.i.i.i.i = tail call double @llvm.floor.f64(double %.78.i.i.i.i.i.i.i)
  %.92.i.i.i.i.i.i.i = fsub double %.78.i.i.i.i.i.i.i, %.87.le.i.i.i.i.i.i.i
  %.93.i.i.i.i.i.i.i = fmul double %.92.i.i.i.i.i.i.i, 0x401921FB54442D18
  %.121.i.i.i.i.i.i.i = getelementptr i8, ptr %34, i64 40
  %.122.i.i.i.i.i.i.i = load double, ptr %.121.i.i.i.i.i.i.i, align 8, !noalias !531
  %.126.i.i.i.i.i.i.i = fadd double %.122.i.i.i.i.i.i.i, %.93.i.i.i.i.i.i.i
  %.593.le.i.i.i.i.i.i = tail call double @llvm.sin.f64(double %.126.i.i.i.i.i.i.i)
  %.598.i.i.i.i.i.i = fmul double %.423.i.i.i.i.i.i, %.593.le.i.i.i.i.i.i
  %.600.i.i.i.i.i.i = fadd double %.361.i.i333.i.i.i.i, %.598.i.i.i.i.i.i
  br label %B272.i.i.i.i.i.i
B272.i.i.i.i.i.i:
  %value.2.1.i.i.i.i.i.i = phi double [ %.600.i.i.i.i.i.i, %B164.i.i.i.i.i.i ], [ %.361.i.i333.i.i.i.i, %B58.if.i.i.i.i.i.i ]
  %33 = getelementptr double, ptr %.65.fca.5.0.4.load.i.i.i.i.i, i64 %.90.0213.i.i.i.i.i.i
  store double %value.2.1.i.i.i.i.i.i, ptr %33, align 8, !noalias !536
  %exitcond.not.i.i.i.i.i.i = icmp eq i64 %.65.fca.5.0.2.load.i.i.i.i.i, %.161.i.i.i.i.i.i
  br i1 %exitcond.not.i.i.i.i.i.i, label %B260.preheader.i.i.i.i.i, label %B58.if.i.i.i.i.i.i
B260.preheader.i.i.i.i.i:
  %.1478.i.i.i.i.i = mul nuw nsw i64 %.1124.0442.i.i.i.i.i, %.65.fca.5.0.2.load.i.i.i.i.i
  br label %B260.if.i.i.i.i.i
B58.if.i.i.i.i.i.i:
  %.90.0213.i.i.i.i.i.i = phi i64 [ %.161.i.i.i.i.i.i, %B272.i.i.i.i.i.i ], [ 0, %B138.if.i.i.i.i.i ]
  %.161.i.i.i.i.i.i = add nuw nsw i64 %.90.0213.i.i.i.i.i.i, 1
  %.idx.i934.i.i.i = mul i64 %.90.0213.i.i.i.i.i.i, 56
  %34 = getelementptr i8, ptr %.3481.i.i.i.i.i, i64 %.idx.i934.i.i.i
  %.242.i.i.i.i.i.i = getelementptr i8, ptr %34, i64 48
  %.243.i.i.i.i.i.i = load double, ptr %.242.i.i.i.i.i.i, align 8, !noalias !536
  %.245.i.i.i.i.i.i = fsub double %.1283.i.i.i.i.i, %.243.i.i.i.i.i.i
  %.303.i.i.i.i.i.i = load double, ptr %34, align 8, !noalias !536
  %.357.i.i.i.i.i.i = getelementptr i8, ptr %34, i64 8
  %.358.i.i.i.i.i.i = load double, ptr %.357.i.i.i.i.i.i, align 8, !noalias !536
  %.360.i.i332.i.i.i.i = fmul double %.245.i.i.i.i.i.i, %.358.i.i.i.i.i.i
  %.361.i.i333.i.i.i.i = fadd double %.303.i.i.i.i.i.i, %.360.i.i332.i.i.i.i
  %.422.i.i.i.i.i.i = getelementptr i8, ptr %34, i64 16
  %.423.i.i.i.i.i.i = load double, ptr %.422.i.i.i.i.i.i, align 8, !noalias !536
  %.424.i.i.i.i.i.i = fcmp une double %.423.i.i.i.i.i.i, 0.000000e+00
  br i1 %.424.i.i.i.i.i.i, label %B164.i.i.i.i.i.i, label %B272.i.i.i.i.i.i
B260.if.i.i.i.i.i:
  %.1346.0437.i.i.i.i.i = phi i64 [ 0, %B260.preheader.i.i.i.i.i ], [ %.1415.i.i.i.i.i, %B260.if.i.i.i.i.i ]
  %.1415.i.i.i.i.i = add nuw nsw i64 %.1346.0437.i.i.i.i.i, 1
  %35 = getelementptr double, ptr %.65.fca.5.0.4.load.i.i.i.i.i, i64 %.1346.0437.i.i.i.i.i
  %.1469.i.i.i.i.i = load double, ptr %35, align 8, !noalias !525
  %.1479.i.i.i.i.i = add nuw nsw i64 %.1346.0437.i.i.i.i.i, %.1478.i.i.i.i.i
  %.1527.i.i.i.i.i = mul i64 %.1479.i.i.i.i.i, %.708.i.i933.i.i.i
  %gep440.i.i.i.i.i = getelementptr double, ptr %invariant.gep.i.i.i.i.i, i64 %.1527.i.i.i.i.i
  store double %.1469.i.i.i.i.i, ptr %gep440.i.i.i.i.i, align 8, !noalias !525
  %exitcond.not.i.i935.i.i.i = icmp eq i64 %.1415.i.i.i.i.i, %.65.fca.5.0.2.load.i.i.i.i.i
  br i1 %exitcond.not.i.i935.i.i.i, label %B138.loopexit.i.i.i.i.i, label %B260.if.i.i.i.i.i
b123:
  call void @llvm.lifetime.end.p0(ptr nonnull %.49.i.i.i.i.i), !noalias !513
  br label %b121
b121:
  %exitcond956.not.i.i.i = icmp eq i64 %.7099.i.i.i, %.364.i.i
  br i1 %exitcond956.not.i.i.i, label %B1214.i.i.i, label %B1172.if.i.i.i
B1248.if.i.i.i:
  %.7202.0951.i.i.i = phi i64 [ 0, %B1248.if.lr.ph.i.i.i ], [ %.7271.i.i.i, %B1380.i.i.i ]
  %.7271.i.i.i = add nuw nsw i64 %.7202.0951.i.i.i, 1
  %36 = getelementptr i64, ptr %15, i64 %.7202.0951.i.i.i
  %.7353.i.i.i = load i64, ptr %36, align 8, !noalias !471
  %.7354.not.i.i.i = icmp eq i64 %.7353.i.i.i, 0
  br i1 %.7354.not.i.i.i, label %B1380.i.i.i, label %B1282.i.i.i
b118:
  call void @llvm.lifetime.end.p0(ptr nonnull %.5458.i.i.i), !noalias !455
  %.3186.i.i = load i64, ptr %.3185.i.i, align 8, !noalias !455
  %.3533.i.i = load i64, ptr %4, align 8, !noalias !455
  %.3880.i.i = load i64, ptr %.2405.i.i.i, align 8, !noalias !455
  %.4227.i.i = load i64, ptr %6, align 8, !noalias !455
  %.4574.i.i = load i64, ptr %.3446.i.i.i, align 8, !noalias !455
  %.4921.i.i = load i64, ptr %.3793.i.i.i, align 8, !noalias !455
  %.5268.i.i = load i64, ptr %.4140.i.i.i, align 8, !noalias !455
  %.5615.i.i = load i64, ptr %.4487.i.i.i, align 8, !noalias !455
  %.5962.i.i = load i64, ptr %.5961.i.i, align 8, !noalias !455
  %.6309.i.i = load i64, ptr %.6308.i.i, align 8, !noalias !455
  %.6656.i.i = load i64, ptr %.6655.i.i, align 8, !noalias !455
  %.6657.i.i = inttoptr i64 %.3186.i.i to ptr
  tail call void %.6657.i.i(i64 %.3533.i.i, i64 %.3880.i.i, i64 %.4227.i.i, i64 %.4574.i.i, i64 %.4921.i.i, i64 %.5268.i.i, i64 %.5615.i.i, i64 %.5962.i.i, i64 %.6309.i.i, i64 %.6656.i.i), !noalias !455
  %.7005.i.i = load i64, ptr %.7004.i.i, align 8, !noalias !455
  %.7352.i.i = load i64, ptr %.7351.i.i, align 8, !noalias !455
  %.7699.i.i = load i64, ptr %1, align 8, !noalias !455
  %.8046.i.i = load i64, ptr %.2405.i.i.i, align 8, !noalias !455
  %.8393.i.i = load i64, ptr %.6655.i.i, align 8, !noalias !455
  %.8740.i.i = load i64, ptr %.8739.i.i, align 8, !noalias !455
  %.9087.i.i = load i64, ptr %4, align 8, !noalias !455
  %.9434.i.i = load i64, ptr %3, align 8, !noalias !455
  %.9435.i.i = inttoptr i64 %.7005.i.i to ptr
  tail call void %.9435.i.i(i64 %.7352.i.i, i64 %.7699.i.i, i64 %.8046.i.i, i64 %.8393.i.i, i64 %.8740.i.i, i64 %.9087.i.i, i64 %.9434.i.i), !noalias !455
  %brmerge.i.i = select i1 %.2376.i.i, i1 true, i1 %"$phi266.0.2.0.i.i"
  br i1 %brmerge.i.i, label %B1216.i.i, label %B1572.i.i
B1216.i.i:
  store i64 0, ptr %.2737.i.i, align 8, !noalias !455
  %.95512057.not.i.i = icmp slt i64 %.364.i.i, 1
  br i1 %.95512057.not.i.i, label %B1572.B1938_crit_edge.i.i, label %B1256.if.lr.ph.i.i
B1256.if.lr.ph.i.i:
  %.9706.idx.i.i = mul i64 %.364.i.i, 48
  %.9706.i.i = getelementptr i8, ptr %.46.i.i.i, i64 %.9706.idx.i.i
  %.idx2015.i.i = mul i64 %.364.i.i, 104
  %37 = getelementptr i8, ptr %.46.i.i.i, i64 %.idx2015.i.i
  %.idx2016.i.i = mul i64 %.364.i.i, 88
  %38 = getelementptr i8, ptr %.46.i.i.i, i64 %.idx2016.i.i
  br label %B1256.if.i.i
B1276.i.i:
  %.9650.i.i = getelementptr double, ptr %.46.i.i.i, i64 %.9495.02058.i.i
  %.9651.i.i = load double, ptr %.9650.i.i, align 8, !noalias !455
  %.9652.i.i = fcmp ueq double %.9651.i.i, 0x7FF0000000000000
  br i1 %.9652.i.i, label %B1366.i.i, label %B1334.i.i
B1334.i.i:
  %.9707.i.i = load double, ptr %.9706.i.i, align 8, !noalias !455
  br label %B1366.i.i
B1366.i.i:
  %"$phi1366.1.2.2.i.i" = phi double [ %.9707.i.i, %B1334.i.i ], [ 0.000000e+00, %B1276.i.i ]
  %.9769.i.i = getelementptr double, ptr %.9706.i.i, i64 %.9495.02058.i.i
  store double %"$phi1366.1.2.2.i.i", ptr %.9769.i.i, align 8, !noalias !455
  br label %B1388.i.i
B1388.i.i:
  %39 = getelementptr i64, ptr %.362.i.i.i, i64 %.9495.02058.i.i
  %.9828.i.i = load i64, ptr %39, align 8, !noalias !455
  %.9829.i.i = icmp sgt i64 %.9828.i.i, -1
  br i1 %.9829.i.i, label %B1426.i.i, label %B1570.i.i
B1426.i.i:
  %.9884.i.i = getelementptr double, ptr %.9706.i.i, i64 %.9495.02058.i.i
  %.9885.i.i = load double, ptr %.9884.i.i, align 8, !noalias !455
  %.9886.i.i = fcmp une double %.9885.i.i, 0.000000e+00
  br i1 %.9886.i.i, label %B1464.i.i, label %B1570.i.i
B1464.i.i:
  br i1 %"$phi266.0.2.0.i.i", label %B1532.i.i, label %B1468.i.i
B1468.i.i:
  %.9943.i.i = getelementptr double, ptr %37, i64 %.9495.02058.i.i
  %.9944.i.i = load double, ptr %.9943.i.i, align 8, !noalias !455
  %.9998.i.i = getelementptr double, ptr %38, i64 %.9495.02058.i.i
  %.9999.i.i = load double, ptr %.9998.i.i, align 8, !noalias !455
  %.10000.i.i = fcmp olt double %.9944.i.i, %.9999.i.i
  br i1 %.10000.i.i, label %B1532.i.i, label %B1570.i.i
B1532.i.i:
  %.10031.i.i = load i64, ptr %.2737.i.i, align 8, !noalias !455
  %.10033.i.i = shl nuw i64 1, %.9495.02058.i.i
  %.10036.i.i = or i64 %.10031.i.i, %.10033.i.i
  store i64 %.10036.i.i, ptr %.2737.i.i, align 8, !noalias !455
  br label %B1570.i.i
B1570.i.i:
  %exitcond.not.i.i = icmp eq i64 %.9564.i.i, %.364.i.i
  br i1 %exitcond.not.i.i, label %B1572.i.i, label %B1256.if.i.i
B1572.i.i:
  %.10104.pr.i.i = load i64, ptr %.2737.i.i, align 8, !noalias !455
  %.10116.not.i.i = icmp eq i64 %.10104.pr.i.i, 0
  br i1 %.10116.not.i.i, label %B1572.B1938_crit_edge.i.i, label %B1604.i.i
B1572.B1938_crit_edge.i.i:
  %.pre.i.i = tail call i64 @llvm.smax.i64(i64 %.364.i.i, i64 0)
  br label %B1938.i.i
B1604.i.i:
  %.10472.i.i = load i64, ptr %.10471.i.i, align 8, !noalias !455
  %.10819.i.i = load i64, ptr %.6308.i.i, align 8, !noalias !455
  %.11166.i.i = load i64, ptr %.11165.i.i, align 8, !noalias !455
  %.11167.i.i = inttoptr i64 %.10472.i.i to ptr
  tail call void %.11167.i.i(i64 %.10819.i.i, i64 %.11166.i.i), !noalias !455
  %spec.select2054.i.i = tail call i64 @llvm.smax.i64(i64 %.364.i.i, i64 0)
  %.112522060.not.i.i = icmp slt i64 %.364.i.i, 1
  br i1 %.112522060.not.i.i, label %B1938.i.i, label %B1764.if.i.i
B1792.i.i:
  br i1 %"$phi266.0.2.0.i.i", label %B1796.i.i, label %B1872.i.i
B1796.i.i:
  call fastcc void @v80(ptr %.11308.i.i, ptr nonnull %job, i64 %.11193.02061.i.i, ptr %.46.i.i.i, i64 %.364.i.i, ptr %.46.i2028.i.i, i64 %.364.i.i)
  %.11332.i.i = load i8, ptr %.11308.i.i, align 1, !noalias !455
  %.11335.i.i = icmp ne i8 %.11332.i.i, 0
  %.15.i.i.i = zext i1 %.11335.i.i to i64
  %.11377.i.i = shl nuw i64 %.15.i.i.i, %.11193.02061.i.i
  %.11381.i.i = or i64 %.11377.i.i, %changed.2.12063.i.i
  br label %B3047.i.i
B1872.i.i:
  %40 = getelementptr i64, ptr %.362.i.i.i, i64 %.11193.02061.i.i
  %.11443.i.i = load i64, ptr %40, align 8, !noalias !455
  call fastcc void @v82(ptr %.11448.i.i, ptr nonnull %job, i64 %.11193.02061.i.i, ptr %.46.i.i.i, i64 %.364.i.i, ptr %.362.i.i.i, i64 %.364.i.i, i64 %.11443.i.i)
  br label %B3047.i.i
B1938.i.i:
  %.101042086.i.i = phi i64 [ 0, %B1572.B1938_crit_edge.i.i ], [ %.10104.pr.i.i, %B1604.i.i ], [ %.10104.pr.i.i, %B3047.i.i ]
  %spec.select2055.pre-phi.i.i = phi i64 [ %.pre.i.i, %B1572.B1938_crit_edge.i.i ], [ %spec.select2054.i.i, %B1604.i.i ], [ %spec.select2054.i.i, %B3047.i.i ]
  %changed.4.0.i.i = phi i64 [ 0, %B1572.B1938_crit_edge.i.i ], [ 0, %B1604.i.i ], [ %changed.3.1.i.i, %B3047.i.i ]
  %.11847.i.i = load i64, ptr %.11846.i.i, align 8, !noalias !455
  %.12194.i.i = load i64, ptr %3, align 8, !noalias !455
  %.12541.i.i = load i64, ptr %4, align 8, !noalias !455
  %.12542.i.i = inttoptr i64 %.11847.i.i to ptr
  tail call void %.12542.i.i(i64 %.12194.i.i, i64 %.12541.i.i), !noalias !455
  %or.cond2078.i.i = and i1 %.905937.not.i.i.i, %"$phi266.0.2.0.i.i"
  br i1 %or.cond2078.i.i, label %B2102.if.i.i, label %B2190.i.i
B2130.i.i:
  %41 = lshr i64 %changed.4.0.i.i, %.12570.02065.i.i
  %42 = trunc i64 %41 to i8
  %.12699.i.i = and i8 %42, 1
  call fastcc void @v85(ptr %.12683.i.i, i64 %.12570.02065.i.i, ptr %.46.i.i.i, i64 %.364.i.i, ptr %.46.i2028.i.i, i64 %.364.i.i, ptr %.362.i.i.i, i64 %.364.i.i, i8 %.12699.i.i)
  br label %B2188.i.i
B2188.i.i:
  %exitcond2080.not.i.i = icmp eq i64 %.12639.i.i, %spec.select2055.pre-phi.i.i
  br i1 %exitcond2080.not.i.i, label %B2190.i.i, label %B2102.if.i.i
B2190.i.i:
  br i1 %or.cond953.i.i.i, label %B2224.if.lr.ph.i.i, label %B2378.i.i
B2224.if.lr.ph.i.i:
  %.idx2008.i.i = shl i64 %.364.i.i, 4
  %43 = getelementptr i8, ptr %.362.i.i.i, i64 %.idx2008.i.i
  %.idx2009.i.i = mul i64 %.364.i.i, 48
  %44 = getelementptr i8, ptr %.46.i.i.i, i64 %.idx2009.i.i
  br label %B2224.if.i.i
B2258.i.i:
  %45 = getelementptr double, ptr %44, i64 %.12762.02068.i.i
  %.12970.i.i = load double, ptr %45, align 8, !noalias !455
  %.12971.i.i = fcmp une double %.12970.i.i, 0.000000e+00
  br i1 %.12971.i.i, label %B2296.i.i, label %B2376.i.i
B2296.i.i:
  %.361.i.i.i.i = load i64, ptr %.360.i.i, align 8, !noalias !537
  %.362.i.i.i.i = inttoptr i64 %.361.i.i.i.i to ptr
  %.708.i.i.i.i = load i64, ptr %job, align 8, !noalias !537
  %46 = getelementptr i64, ptr %.362.i.i.i.i, i64 %.708.i.i.i.i
  %47 = getelementptr i64, ptr %46, i64 %.12762.02068.i.i
  %.119.i.i.i = load i64, ptr %47, align 8, !noalias !542
  %.471.i.i.i = load i64, ptr %.470.i.i.i.i.i, align 8, !noalias !542
  %.818.i.i.i = load i64, ptr %.817.i.i.i.i.i, align 8, !noalias !542
  %.46.i385.i.i.i = load i64, ptr %.45.i384.i.i.i.i.i, align 8, !noalias !543
  %.50.i386.i.i.i = inttoptr i64 %.46.i385.i.i.i to ptr
  %.2348.i.i.i = icmp slt i64 %.119.i.i.i, 0
  %.2349.i.i.i = select i1 %.2348.i.i.i, i64 %.471.i.i.i, i64 0
  %48 = getelementptr i64, ptr %.50.i386.i.i.i, i64 %.119.i.i.i
  %.2363.i.i.i = getelementptr i64, ptr %48, i64 %.2349.i.i.i
  %.2364.i.i.i = load i64, ptr %.2363.i.i.i, align 8, !noalias !542
  %.2714.i.i.i = load i64, ptr %.2713.i.i.i.i.i, align 8, !noalias !542
  %.2715.i.i.i = icmp sgt i64 %.2714.i.i.i, 0
  br i1 %.2715.i.i.i, label %B432.i.i.i, label %b124
B432.i.i.i:
  %.3066.i.i.i = load i64, ptr %.3065.i.i.i.i.i, align 8, !noalias !542
  %.3068.i.i.i = mul nsw i64 %.3066.i.i.i, %.12762.02068.i.i
  br label %b124
b124:
  %"$phi476.1.2.0.i.i.i" = phi i64 [ %.3068.i.i.i, %B432.i.i.i ], [ 0, %B2296.i.i ]
  %.3082.i.i.i = add nsw i64 %"$phi476.1.2.0.i.i.i", %.2364.i.i.i
  %.3471.i.i.i = load i64, ptr %.3470.i.i.i.i.i, align 8, !noalias !542
  %.3478.i.i.i = mul nsw i64 %.818.i.i.i, 56
  %.3479.i.i.i = mul nsw i64 %.3478.i.i.i, %.3082.i.i.i
  %.3480.i.i.i = add nsw i64 %.3471.i.i.i, %.3479.i.i.i
  %.3481.i.i.i = inttoptr i64 %.3480.i.i.i to ptr
  %49 = getelementptr double, ptr %.46.i2028.i.i, i64 %.12762.02068.i.i
  %.13075.i.i = load double, ptr %49, align 8, !noalias !455
  call fastcc void @v76(ptr %.13078.i.i, ptr nonnull %job, i64 %.12762.02068.i.i, ptr %.3481.i.i.i, i64 7, double %.13075.i.i)
  br label %B2376.i.i
B2376.i.i:
  %exitcond2081.not.i.i = icmp eq i64 %.12831.i.i, %.364.i.i
  br i1 %exitcond2081.not.i.i, label %B2378.i.i, label %B2224.if.i.i
B2378.i.i:
  %.13469.i.i = load i64, ptr %.13468.i.i, align 8, !noalias !455
  %.13816.i.i = load i64, ptr %3, align 8, !noalias !455
  %.14163.i.i = load i64, ptr %.2405.i.i.i, align 8, !noalias !455
  %.14510.i.i = load i64, ptr %.6655.i.i, align 8, !noalias !455
  %.14857.i.i = load i64, ptr %.14856.i.i, align 8, !noalias !455
  %.14858.i.i = inttoptr i64 %.13469.i.i to ptr
  tail call void %.14858.i.i(i64 %.13816.i.i, i64 %.14163.i.i, i64 %.14510.i.i, i64 %.14857.i.i), !noalias !455
  %.14888.i.i = getelementptr i8, ptr %.2737.i.i, i64 8
  %.14889.i.i = load i64, ptr %.14888.i.i, align 8, !noalias !455
  %.14895.not.i.i = icmp ne i64 %.14889.i.i, 0
  %brmerge2017.i.i = select i1 %.14895.not.i.i, i1 true, i1 %"$phi266.0.2.0.i.i"
  %brmerge2018.i.i = select i1 %brmerge2017.i.i, i1 true, i1 %.2376.i.i
  br i1 %brmerge2018.i.i, label %B2682.i.i, label %B2608.i.i
B2608.i.i:
  %.46.i2044.i.i = load i64, ptr %.45.i2043.i.i, align 8, !noalias !546
  %.50.i2045.i.i = inttoptr i64 %.46.i2044.i.i to ptr
  %.15288.i.i = getelementptr i8, ptr %.50.i2045.i.i, i64 8
  %.15289.i.i = load double, ptr %.15288.i.i, align 8, !noalias !455
  %.15293.i.i = fcmp oeq double %.15289.i.i, 0.000000e+00
  %.153822070.not.i.i = icmp slt i64 %.364.i.i, 1
  %or.cond2089.i.i = select i1 %.15293.i.i, i1 true, i1 %.153822070.not.i.i
  br i1 %or.cond2089.i.i, label %B596.endif.i, label %B2716.if.lr.ph.i.i
B2682.i.i:
  %.153822070.not.old.i.i = icmp slt i64 %.364.i.i, 1
  br i1 %.153822070.not.old.i.i, label %B596.endif.i, label %B2716.if.lr.ph.i.i
B2716.if.lr.ph.i.i:
  %.idx2007.i.i = mul i64 %.364.i.i, 40
  %50 = getelementptr i8, ptr %.362.i.i.i, i64 %.idx2007.i.i
  br label %B2716.if.i.i
B2758.i.i:
  call fastcc void @v86(ptr %.15490.i.i, ptr nonnull %job, i64 %.15326.02071.i.i, ptr %.46.i.i.i, i64 %.364.i.i, ptr %.46.i2028.i.i, i64 %.364.i.i, ptr nonnull %.362.i.i.i, i64 %.364.i.i)
  %.15518.i.i = load i64, ptr %.15490.i.i, align 8, !noalias !455
  %.15581.i.i = getelementptr i64, ptr %50, i64 %.15326.02071.i.i
  store i64 %.15518.i.i, ptr %.15581.i.i, align 8, !noalias !455
  %.15640.i.i = icmp sgt i64 %.15518.i.i, -1
  %.15642.i.i = or i1 %has_ended.2.02073.i.i, %.15640.i.i
  br label %B2860.i.i
B2860.i.i:
  %has_ended.3.1.i.i = phi i1 [ %.15642.i.i, %B2758.i.i ], [ %has_ended.2.02073.i.i, %B2716.if.i.i ]
  %exitcond2082.not.i.i = icmp eq i64 %.15395.i.i, %spec.select2055.pre-phi.i.i
  br i1 %exitcond2082.not.i.i, label %B2862.i.i, label %B2716.if.i.i
B2862.i.i:
  br i1 %has_ended.3.1.i.i, label %B2896.if.i.i, label %B596.endif.i
B2938.i.i:
  %.15911.i.i = getelementptr i64, ptr %50, i64 %.15704.02076.i.i
  %.15912.i.i = load i64, ptr %.15911.i.i, align 8, !noalias !455
  %.15913.i.i = icmp sgt i64 %.15912.i.i, -1
  br i1 %.15913.i.i, label %B2976.i.i, label %B3036.i.i
B2976.i.i:
  %.15979.i.i = call fastcc i32 @v87(ptr %.15973.i.i, ptr nonnull %job, i64 %.15704.02076.i.i, i64 %.15912.i.i)
  %.15981.not.i.i = icmp eq i32 %.15979.i.i, 0
  br i1 %.15981.not.i.i, label %B3036.i.i, label %B596.if.i, !prof !109
B3036.i.i:
  %exitcond2083.not.i.i = icmp eq i64 %.15773.i.i, %spec.select2055.pre-phi.i.i
  br i1 %exitcond2083.not.i.i, label %B596.endif.i, label %B2896.if.i.i
B3047.i.i:
  %changed.3.1.i.i = phi i64 [ %.11381.i.i, %B1796.i.i ], [ %changed.2.12063.i.i, %B1872.i.i ], [ %changed.2.12063.i.i, %B1764.if.i.i ]
  %exitcond2079.not.i.i = icmp eq i64 %.364.i.i, %.11265.i.i
  br i1 %exitcond2079.not.i.i, label %B1938.i.i, label %B1764.if.i.i
B1256.if.i.i:
  %.9495.02058.i.i = phi i64 [ 0, %B1256.if.lr.ph.i.i ], [ %.9564.i.i, %B1570.i.i ]
  %.9564.i.i = add nuw nsw i64 %.9495.02058.i.i, 1
  %.9595.i.i = icmp ne i64 %.9495.02058.i.i, 0
  %or.cond.i.i = select i1 %.2376.i.i, i1 %.9595.i.i, i1 false
  br i1 %or.cond.i.i, label %B1276.i.i, label %B1388.i.i
B1764.if.i.i:
  %changed.2.12063.i.i = phi i64 [ %changed.3.1.i.i, %B3047.i.i ], [ 0, %B1604.i.i ]
  %.11193.02061.i.i = phi i64 [ %.11265.i.i, %B3047.i.i ], [ 0, %B1604.i.i ]
  %.11265.i.i = add nuw nsw i64 %.11193.02061.i.i, 1
  %51 = shl nuw i64 1, %.11193.02061.i.i
  %52 = and i64 %51, %.10104.pr.i.i
  %.11299.not.i.i = icmp eq i64 %52, 0
  br i1 %.11299.not.i.i, label %B3047.i.i, label %B1792.i.i
B2102.if.i.i:
  %.12570.02065.i.i = phi i64 [ %.12639.i.i, %B2188.i.i ], [ 0, %B1938.i.i ]
  %.12639.i.i = add nuw nsw i64 %.12570.02065.i.i, 1
  %53 = shl nuw i64 1, %.12570.02065.i.i
  %54 = and i64 %53, %.101042086.i.i
  %.12671.not.i.i = icmp eq i64 %54, 0
  br i1 %.12671.not.i.i, label %B2188.i.i, label %B2130.i.i
B2224.if.i.i:
  %.12762.02068.i.i = phi i64 [ 0, %B2224.if.lr.ph.i.i ], [ %.12831.i.i, %B2376.i.i ]
  %.12831.i.i = add nuw nsw i64 %.12762.02068.i.i, 1
  %55 = getelementptr i64, ptr %43, i64 %.12762.02068.i.i
  %.12913.i.i = load i64, ptr %55, align 8, !noalias !455
  %.12914.not.i.i = icmp eq i64 %.12913.i.i, 0
  br i1 %.12914.not.i.i, label %B2376.i.i, label %B2258.i.i
B2716.if.i.i:
  %has_ended.2.02073.i.i = phi i1 [ false, %B2716.if.lr.ph.i.i ], [ %has_ended.3.1.i.i, %B2860.i.i ]
  %.15326.02071.i.i = phi i64 [ 0, %B2716.if.lr.ph.i.i ], [ %.15395.i.i, %B2860.i.i ]
  %.15395.i.i = add nuw nsw i64 %.15326.02071.i.i, 1
  %.15480.i.i = getelementptr i64, ptr %.362.i.i.i, i64 %.15326.02071.i.i
  %.15481.i.i = load i64, ptr %.15480.i.i, align 8, !noalias !455
  %.15482.i.i = icmp sgt i64 %.15481.i.i, -1
  br i1 %.15482.i.i, label %B2758.i.i, label %B2860.i.i
B2896.if.i.i:
  %.15704.02076.i.i = phi i64 [ %.15773.i.i, %B3036.i.i ], [ 0, %B2862.i.i ]
  %.15773.i.i = add nuw nsw i64 %.15704.02076.i.i, 1
  %.15854.i.i = getelementptr i64, ptr %.362.i.i.i, i64 %.15704.02076.i.i
  %.15855.i.i = load i64, ptr %.15854.i.i, align 8, !noalias !455
  %.15856.i.i = icmp sgt i64 %.15855.i.i, -1
  br i1 %.15856.i.i, label %B2938.i.i, label %B3036.i.i
B360.if.i:
  %.2276.i = add nuw i64 %.2207.0.i, 1
  br i1 %.2384449.not.i, label %B456.i, label %B394.if.lr.ph.i
B394.if.lr.ph.i:
  %invariant.gep.i = getelementptr double, ptr %.46.i.i, i64 %.2207.0.i
  br label %B394.if.i
B394.if.i:
  %.2328.0450.i = phi i64 [ 0, %B394.if.lr.ph.i ], [ %.2397.i, %B394.if.i ]
  %.2397.i = add nuw nsw i64 %.2328.0450.i, 1
  %56 = getelementptr i8, ptr %.1772.i, i64 %.2328.0450.i
  %.2455.i = load i8, ptr %56, align 1, !noalias !445
  %.2456.not.i = icmp eq i8 %.2455.i, 0
  %..i = select i1 %.2456.not.i, double 0xFFF0000000000000, double 0.000000e+00
  %.2517.i = mul i64 %.2328.0450.i, %.714.i
  %gep453.i = getelementptr double, ptr %invariant.gep.i, i64 %.2517.i
  store double %..i, ptr %gep453.i, align 8, !noalias !445
  %exitcond.not.i = icmp eq i64 %.1061.i, %.2397.i
  br i1 %exitcond.not.i, label %B456.i, label %B394.if.i
B596.if.i:
  call void @llvm.lifetime.end.p0(ptr nonnull %.11308.i.i), !noalias !445
  call void @llvm.lifetime.end.p0(ptr nonnull %.11448.i.i), !noalias !445
  call void @llvm.lifetime.end.p0(ptr nonnull %.12683.i.i), !noalias !445
  call void @llvm.lifetime.end.p0(ptr nonnull %.13078.i.i), !noalias !445
  call void @llvm.lifetime.end.p0(ptr nonnull %.15490.i.i), !noalias !445
  call void @llvm.lifetime.end.p0(ptr nonnull %.15973.i.i), !noalias !445
  br label %b116
B596.endif.i:
  call void @llvm.lifetime.end.p0(ptr nonnull %.11308.i.i), !noalias !445
  call void @llvm.lifetime.end.p0(ptr nonnull %.11448.i.i), !noalias !445
  call void @llvm.lifetime.end.p0(ptr nonnull %.12683.i.i), !noalias !445
  call void @llvm.lifetime.end.p0(ptr nonnull %.13078.i.i), !noalias !445
  call void @llvm.lifetime.end.p0(ptr nonnull %.15490.i.i), !noalias !445
  call void @llvm.lifetime.end.p0(ptr nonnull %.15973.i.i), !noalias !445
  %.3407.i = load i64, ptr %.2182.i, align 8, !noalias !445
  %.3408.i = icmp sgt i64 %.3407.i, 0
  br i1 %.3408.i, label %B596.i, label %b116
b116:
  call void @llvm.lifetime.end.p0(ptr nonnull %.2637.i)
  ret i64 0
}
declare i64 @llvm.smax.i64(i64, i64)
declare i64 @llvm.smin.i64(i64, i64)
declare void @llvm.memset.p0.i64(ptr writeonly, i8, i64, i1 immarg)
declare void @llvm.lifetime.start.p0(ptr)
declare void @llvm.lifetime.end.p0(ptr)
!0 = !{!1}
!1 = distinct !{!1, !2, !"scope"}
!2 = distinct !{!2, !"scope"}
!3 = !{!4}
!4 = distinct !{!4, !5, !"scope"}
!5 = distinct !{!5, !"scope"}
!6 = !{!7}
!7 = distinct !{!7, !8, !"scope"}
!8 = distinct !{!8, !"scope"}
!9 = !{!10}
!10 = distinct !{!10, !11, !"scope"}
!11 = distinct !{!11, !"scope"}
!12 = !{!13, !15}
!13 = distinct !{!13, !14, !"scope"}
!14 = distinct !{!14, !"scope"}
!15 = distinct !{!15, !16, !"scope"}
!16 = distinct !{!16, !"scope"}
!17 = !{!15}
!18 = !{!19, !15}
!19 = distinct !{!19, !20, !"scope"}
!20 = distinct !{!20, !"scope"}
!21 = !{!22, !15}
!22 = distinct !{!22, !23, !"scope"}
!23 = distinct !{!23, !"scope"}
!24 = !{!25, !15}
!25 = distinct !{!25, !26, !"scope"}
!26 = distinct !{!26, !"scope"}
!27 = !{!28}
!28 = distinct !{!28, !29, !"scope"}
!29 = distinct !{!29, !"scope"}
!30 = !{!31}
!31 = distinct !{!31, !32, !"scope"}
!32 = distinct !{!32, !"scope"}
!33 = !{!34, !36}
!34 = distinct !{!34, !35, !"scope"}
!35 = distinct !{!35, !"scope"}
!36 = distinct !{!36, !37, !"scope"}
!37 = distinct !{!37, !"scope"}
!38 = !{!36}
!39 = !{!40, !36}
!40 = distinct !{!40, !41, !"scope"}
!41 = distinct !{!41, !"scope"}
!42 = !{!43, !36}
!43 = distinct !{!43, !44, !"scope"}
!44 = distinct !{!44, !"scope"}
!45 = !{!46, !36}
!46 = distinct !{!46, !47, !"scope"}
!47 = distinct !{!47, !"scope"}
!48 = !{!49}
!49 = distinct !{!49, !50, !"scope"}
!50 = distinct !{!50, !"scope"}
!51 = !{!52}
!52 = distinct !{!52, !53, !"scope"}
!53 = distinct !{!53, !"scope"}
!54 = !{!55}
!55 = distinct !{!55, !56, !"scope"}
!56 = distinct !{!56, !"scope"}
!57 = !{!58, !55}
!58 = distinct !{!58, !59, !"scope"}
!59 = distinct !{!59, !"scope"}
!60 = !{!61, !63, !55}
!61 = distinct !{!61, !62, !"scope"}
!62 = distinct !{!62, !"scope"}
!63 = distinct !{!63, !64, !"scope"}
!64 = distinct !{!64, !"scope"}
!65 = !{!63, !55}
!66 = !{!67}
!67 = distinct !{!67, !68, !"scope"}
!68 = distinct !{!68, !"scope"}
!69 = !{!70}
!70 = distinct !{!70, !71, !"scope"}
!71 = distinct !{!71, !"scope"}
!72 = !{!73}
!73 = distinct !{!73, !74, !"scope"}
!74 = distinct !{!74, !"scope"}
!75 = !{!76, !78}
!76 = distinct !{!76, !77, !"scope"}
!77 = distinct !{!77, !"scope"}
!78 = distinct !{!78, !79, !"scope"}
!79 = distinct !{!79, !"scope"}
!80 = !{!78}
!81 = !{!82}
!82 = distinct !{!82, !83, !"scope"}
!83 = distinct !{!83, !"scope"}
!84 = !{!"branch_weights", i32 1, i32 99}
!85 = !{!86, !88}
!86 = distinct !{!86, !87, !"scope"}
!87 = distinct !{!87, !"scope"}
!88 = distinct !{!88, !89, !"scope"}
!89 = distinct !{!89, !"scope"}
!90 = !{!88}
!91 = !{!92, !88}
!92 = distinct !{!92, !93, !"scope"}
!93 = distinct !{!93, !"scope"}
!94 = !{!95, !97, !99, !101}
!95 = distinct !{!95, !96, !"scope"}
!96 = distinct !{!96, !"scope"}
!97 = distinct !{!97, !98, !"scope"}
!98 = distinct !{!98, !"scope"}
!99 = distinct !{!99, !100, !"scope"}
!100 = distinct !{!100, !"scope"}
!101 = distinct !{!101, !102, !"scope"}
!102 = distinct !{!102, !"scope"}
!103 = !{!97, !99, !101}
!104 = !{!99, !101}
!105 = !{!101}
!106 = !{!107}
!107 = distinct !{!107, !108, !"scope"}
!108 = distinct !{!108, !"scope"}
!109 = !{!"branch_weights", i32 99, i32 1}
!110 = !{!111}
!111 = distinct !{!111, !112, !"scope"}
!112 = distinct !{!112, !"scope"}
!113 = !{!114}
!114 = distinct !{!114, !115, !"scope"}
!115 = distinct !{!115, !"scope"}
!116 = !{!117}
!117 = distinct !{!117, !118, !"scope"}
!118 = distinct !{!118, !"scope"}
!119 = !{!120}
!120 = distinct !{!120, !121, !"scope"}
!121 = distinct !{!121, !"scope"}
!122 = !{!123}
!123 = distinct !{!123, !124, !"scope"}
!124 = distinct !{!124, !"scope"}
!125 = !{!126}
!126 = distinct !{!126, !127, !"scope"}
!127 = distinct !{!127, !"scope"}
!128 = !{!129}
!129 = distinct !{!129, !130, !"scope"}
!130 = distinct !{!130, !"scope"}
!131 = !{!132}
!132 = distinct !{!132, !133, !"scope"}
!133 = distinct !{!133, !"scope"}
!134 = !{!135, !137}
!135 = distinct !{!135, !136, !"scope"}
!136 = distinct !{!136, !"scope"}
!137 = distinct !{!137, !138, !"scope"}
!138 = distinct !{!138, !"scope"}
!139 = !{!137}
!140 = !{!141, !143}
!141 = distinct !{!141, !142, !"scope"}
!142 = distinct !{!142, !"scope"}
!143 = distinct !{!143, !144, !"scope"}
!144 = distinct !{!144, !"scope"}
!145 = !{!143}
!146 = !{!147}
!147 = distinct !{!147, !148, !"scope"}
!148 = distinct !{!148, !"scope"}
!149 = !{!150}
!150 = distinct !{!150, !151, !"scope"}
!151 = distinct !{!151, !"scope"}
!152 = !{}
!153 = !{!154}
!154 = distinct !{!154, !155, !"scope"}
!155 = distinct !{!155, !"scope"}
!156 = !{!157}
!157 = distinct !{!157, !158, !"scope"}
!158 = distinct !{!158, !"scope"}
!159 = !{!160}
!160 = distinct !{!160, !161, !"scope"}
!161 = distinct !{!161, !"scope"}
!162 = !{!163}
!163 = distinct !{!163, !164, !"scope"}
!164 = distinct !{!164, !"scope"}
!165 = !{!166}
!166 = distinct !{!166, !167, !"scope"}
!167 = distinct !{!167, !"scope"}
!168 = !{!169}
!169 = distinct !{!169, !170, !"scope"}
!170 = distinct !{!170, !"scope"}
!171 = !{!172}
!172 = distinct !{!172, !173, !"scope"}
!173 = distinct !{!173, !"scope"}
!174 = !{!175}
!175 = distinct !{!175, !176, !"scope"}
!176 = distinct !{!176, !"scope"}
!177 = !{!178}
!178 = distinct !{!178, !179, !"scope"}
!179 = distinct !{!179, !"scope"}
!180 = !{!181}
!181 = distinct !{!181, !182, !"scope"}
!182 = distinct !{!182, !"scope"}
!183 = !{!184, !186}
!184 = distinct !{!184, !185, !"scope"}
!185 = distinct !{!185, !"scope"}
!186 = distinct !{!186, !187, !"scope"}
!187 = distinct !{!187, !"scope"}
!188 = !{!186}
!189 = !{!190, !192, !194, !196}
!190 = distinct !{!190, !191, !"scope"}
!191 = distinct !{!191, !"scope"}
!192 = distinct !{!192, !193, !"scope"}
!193 = distinct !{!193, !"scope"}
!194 = distinct !{!194, !195, !"scope"}
!195 = distinct !{!195, !"scope"}
!196 = distinct !{!196, !197, !"scope"}
!197 = distinct !{!197, !"scope"}
!198 = !{!192, !194, !196}
!199 = !{!194, !196}
!200 = !{!196}
!201 = !{!202, !204}
!202 = distinct !{!202, !203, !"scope"}
!203 = distinct !{!203, !"scope"}
!204 = distinct !{!204, !205, !"scope"}
!205 = distinct !{!205, !"scope"}
!206 = !{!204}
!207 = !{!208}
!208 = distinct !{!208, !209, !"scope"}
!209 = distinct !{!209, !"scope"}
!210 = !{!211, !208}
!211 = distinct !{!211, !212, !"scope"}
!212 = distinct !{!212, !"scope"}
!213 = !{!214, !216}
!214 = distinct !{!214, !215, !"scope"}
!215 = distinct !{!215, !"scope"}
!216 = distinct !{!216, !217, !"scope"}
!217 = distinct !{!217, !"scope"}
!218 = !{!216}
!219 = !{!220, !222}
!220 = distinct !{!220, !221, !"scope"}
!221 = distinct !{!221, !"scope"}
!222 = distinct !{!222, !223, !"scope"}
!223 = distinct !{!223, !"scope"}
!224 = !{!222}
!225 = !{!226}
!226 = distinct !{!226, !227, !"scope"}
!227 = distinct !{!227, !"scope"}
!228 = !{!229}
!229 = distinct !{!229, !230, !"scope"}
!230 = distinct !{!230, !"scope"}
!231 = !{!232, !234}
!232 = distinct !{!232, !233, !"scope"}
!233 = distinct !{!233, !"scope"}
!234 = distinct !{!234, !235, !"scope"}
!235 = distinct !{!235, !"scope"}
!236 = !{!234}
!237 = !{!238}
!238 = distinct !{!238, !239, !"scope"}
!239 = distinct !{!239, !"scope"}
!240 = !{!241}
!241 = distinct !{!241, !242, !"scope"}
!242 = distinct !{!242, !"scope"}
!243 = !{!244}
!244 = distinct !{!244, !245, !"scope"}
!245 = distinct !{!245, !"scope"}
!246 = !{!247}
!247 = distinct !{!247, !248, !"scope"}
!248 = distinct !{!248, !"scope"}
!249 = !{!250}
!250 = distinct !{!250, !251, !"scope"}
!251 = distinct !{!251, !"scope"}
!252 = !{!253}
!253 = distinct !{!253, !251, !"scope"}
!254 = !{!255}
!255 = distinct !{!255, !256, !"scope"}
!256 = distinct !{!256, !"scope"}
!257 = !{!258}
!258 = distinct !{!258, !259, !"scope"}
!259 = distinct !{!259, !"scope"}
!260 = !{!261, !263}
!261 = distinct !{!261, !262, !"scope"}
!262 = distinct !{!262, !"scope"}
!263 = distinct !{!263, !264, !"scope"}
!264 = distinct !{!264, !"scope"}
!265 = !{!263}
!266 = !{!267, !263}
!267 = distinct !{!267, !268, !"scope"}
!268 = distinct !{!268, !"scope"}
!269 = !{!270, !263}
!270 = distinct !{!270, !271, !"scope"}
!271 = distinct !{!271, !"scope"}
!272 = !{!273, !263}
!273 = distinct !{!273, !274, !"scope"}
!274 = distinct !{!274, !"scope"}
!275 = !{!276, !263}
!276 = distinct !{!276, !277, !"scope"}
!277 = distinct !{!277, !"scope"}
!278 = !{!279}
!279 = distinct !{!279, !280, !"scope"}
!280 = distinct !{!280, !"scope"}
!281 = !{!282}
!282 = distinct !{!282, !283, !"scope"}
!283 = distinct !{!283, !"scope"}
!284 = !{!285}
!285 = distinct !{!285, !286, !"scope"}
!286 = distinct !{!286, !"scope"}
!287 = !{!288}
!288 = distinct !{!288, !289, !"scope"}
!289 = distinct !{!289, !"scope"}
!290 = !{!291, !293}
!291 = distinct !{!291, !292, !"scope"}
!292 = distinct !{!292, !"scope"}
!293 = distinct !{!293, !294, !"scope"}
!294 = distinct !{!294, !"scope"}
!295 = !{!293}
!296 = !{!297, !293}
!297 = distinct !{!297, !298, !"scope"}
!298 = distinct !{!298, !"scope"}
!299 = !{!300, !293}
!300 = distinct !{!300, !301, !"scope"}
!301 = distinct !{!301, !"scope"}
!302 = !{!303, !293}
!303 = distinct !{!303, !304, !"scope"}
!304 = distinct !{!304, !"scope"}
!305 = !{!306, !308}
!306 = distinct !{!306, !307, !"scope"}
!307 = distinct !{!307, !"scope"}
!308 = distinct !{!308, !309, !"scope"}
!309 = distinct !{!309, !"scope"}
!310 = !{!308}
!311 = !{!312, !308}
!312 = distinct !{!312, !313, !"scope"}
!313 = distinct !{!313, !"scope"}
!314 = !{!315, !308}
!315 = distinct !{!315, !316, !"scope"}
!316 = distinct !{!316, !"scope"}
!317 = !{!318}
!318 = distinct !{!318, !319, !"scope"}
!319 = distinct !{!319, !"scope"}
!320 = !{!321, !323}
!321 = distinct !{!321, !322, !"scope"}
!322 = distinct !{!322, !"scope"}
!323 = distinct !{!323, !324, !"scope"}
!324 = distinct !{!324, !"scope"}
!325 = !{!326, !328}
!326 = distinct !{!326, !327, !"scope"}
!327 = distinct !{!327, !"scope"}
!328 = distinct !{!328, !329, !"scope"}
!329 = distinct !{!329, !"scope"}
!330 = !{!328}
!331 = !{!332, !328}
!332 = distinct !{!332, !333, !"scope"}
!333 = distinct !{!333, !"scope"}
!334 = !{!335}
!335 = distinct !{!335, !336, !"scope"}
!336 = distinct !{!336, !"scope"}
!337 = !{!338}
!338 = distinct !{!338, !339, !"scope"}
!339 = distinct !{!339, !"scope"}
!340 = !{!341}
!341 = distinct !{!341, !342, !"scope"}
!342 = distinct !{!342, !"scope"}
!343 = !{!344, !346}
!344 = distinct !{!344, !345, !"scope"}
!345 = distinct !{!345, !"scope"}
!346 = distinct !{!346, !347, !"scope"}
!347 = distinct !{!347, !"scope"}
!348 = !{!346}
!349 = !{!350, !352}
!350 = distinct !{!350, !351, !"scope"}
!351 = distinct !{!351, !"scope"}
!352 = distinct !{!352, !353, !"scope"}
!353 = distinct !{!353, !"scope"}
!354 = !{!352}
!355 = !{!356}
!356 = distinct !{!356, !357, !"scope"}
!357 = distinct !{!357, !"scope"}
!358 = !{!359, !361}
!359 = distinct !{!359, !360, !"scope"}
!360 = distinct !{!360, !"scope"}
!361 = distinct !{!361, !362, !"scope"}
!362 = distinct !{!362, !"scope"}
!363 = !{!361}
!364 = !{!365, !361}
!365 = distinct !{!365, !366, !"scope"}
!366 = distinct !{!366, !"scope"}
!367 = !{!368, !361}
!368 = distinct !{!368, !369, !"scope"}
!369 = distinct !{!369, !"scope"}
!370 = !{!371, !361}
!371 = distinct !{!371, !372, !"scope"}
!372 = distinct !{!372, !"scope"}
!373 = !{!374, !376}
!374 = distinct !{!374, !375, !"scope"}
!375 = distinct !{!375, !"scope"}
!376 = distinct !{!376, !377, !"scope"}
!377 = distinct !{!377, !"scope"}
!378 = !{!376}
!379 = !{!380, !382}
!380 = distinct !{!380, !381, !"scope"}
!381 = distinct !{!381, !"scope"}
!382 = distinct !{!382, !383, !"scope"}
!383 = distinct !{!383, !"scope"}
!384 = !{!382}
!385 = !{!386, !388}
!386 = distinct !{!386, !387, !"scope"}
!387 = distinct !{!387, !"scope"}
!388 = distinct !{!388, !389, !"scope"}
!389 = distinct !{!389, !"scope"}
!390 = !{!388}
!391 = !{!392}
!392 = distinct !{!392, !393, !"scope"}
!393 = distinct !{!393, !"scope"}
!394 = !{!395, !397}
!395 = distinct !{!395, !396, !"scope"}
!396 = distinct !{!396, !"scope"}
!397 = distinct !{!397, !398, !"scope"}
!398 = distinct !{!398, !"scope"}
!399 = !{!397}
!400 = !{!401}
!401 = distinct !{!401, !402, !"scope"}
!402 = distinct !{!402, !"scope"}
!403 = !{!404}
!404 = distinct !{!404, !405, !"scope"}
!405 = distinct !{!405, !"scope"}
!406 = !{!407}
!407 = distinct !{!407, !408, !"scope"}
!408 = distinct !{!408, !"scope"}
!409 = !{!410, !412, !414, !416}
!410 = distinct !{!410, !411, !"scope"}
!411 = distinct !{!411, !"scope"}
!412 = distinct !{!412, !413, !"scope"}
!413 = distinct !{!413, !"scope"}
!414 = distinct !{!414, !415, !"scope"}
!415 = distinct !{!415, !"scope"}
!416 = distinct !{!416, !417, !"scope"}
!417 = distinct !{!417, !"scope"}
!418 = !{!412, !414, !416}
!419 = !{!414, !416}
!420 = !{!416}
!421 = !{!422}
!422 = distinct !{!422, !423, !"scope"}
!423 = distinct !{!423, !"scope"}
!424 = !{!425}
!425 = distinct !{!425, !426, !"scope"}
!426 = distinct !{!426, !"scope"}
!427 = !{!428}
!428 = distinct !{!428, !429, !"scope"}
!429 = distinct !{!429, !"scope"}
!430 = !{!431}
!431 = distinct !{!431, !432, !"scope"}
!432 = distinct !{!432, !"scope"}
!433 = !{!434, !436, !438, !440}
!434 = distinct !{!434, !435, !"scope"}
!435 = distinct !{!435, !"scope"}
!436 = distinct !{!436, !437, !"scope"}
!437 = distinct !{!437, !"scope"}
!438 = distinct !{!438, !439, !"scope"}
!439 = distinct !{!439, !"scope"}
!440 = distinct !{!440, !441, !"scope"}
!441 = distinct !{!441, !"scope"}
!442 = !{!436, !438, !440}
!443 = !{!438, !440}
!444 = !{!440}
!445 = !{!446, !448}
!446 = distinct !{!446, !447, !"scope"}
!447 = distinct !{!447, !"scope"}
!448 = distinct !{!448, !447, !"scope"}
!449 = !{!450, !446, !448}
!450 = distinct !{!450, !451, !"scope"}
!451 = distinct !{!451, !"scope"}
!452 = !{!453, !446, !448}
!453 = distinct !{!453, !454, !"scope"}
!454 = distinct !{!454, !"scope"}
!455 = !{!456, !458, !446, !448}
!456 = distinct !{!456, !457, !"scope"}
!457 = distinct !{!457, !"scope"}
!458 = distinct !{!458, !457, !"scope"}
!459 = !{!460, !456, !458, !446, !448}
!460 = distinct !{!460, !461, !"scope"}
!461 = distinct !{!461, !"scope"}
!462 = !{!463, !456, !458, !446, !448}
!463 = distinct !{!463, !464, !"scope"}
!464 = distinct !{!464, !"scope"}
!465 = !{!466, !456, !458, !446, !448}
!466 = distinct !{!466, !467, !"scope"}
!467 = distinct !{!467, !"scope"}
!468 = !{!469, !456, !458, !446, !448}
!469 = distinct !{!469, !470, !"scope"}
!470 = distinct !{!470, !"scope"}
!471 = !{!472, !456, !458, !446, !448}
!472 = distinct !{!472, !473, !"scope"}
!473 = distinct !{!473, !"scope"}
!474 = !{!475, !477, !472, !456, !458, !446, !448}
!475 = distinct !{!475, !476, !"scope"}
!476 = distinct !{!476, !"scope"}
!477 = distinct !{!477, !478, !"scope"}
!478 = distinct !{!478, !"scope"}
!479 = !{!480, !477, !472, !456, !458, !446, !448}
!480 = distinct !{!480, !481, !"scope"}
!481 = distinct !{!481, !"scope"}
!482 = !{!483, !477, !472, !456, !458, !446, !448}
!483 = distinct !{!483, !484, !"scope"}
!484 = distinct !{!484, !"scope"}
!485 = !{!486, !477, !472, !456, !458, !446, !448}
!486 = distinct !{!486, !487, !"scope"}
!487 = distinct !{!487, !"scope"}
!488 = !{!477, !472, !456, !458, !446, !448}
!489 = !{!490, !477, !472, !456, !458, !446, !448}
!490 = distinct !{!490, !491, !"scope"}
!491 = distinct !{!491, !"scope"}
!492 = !{!493, !495, !472, !456, !458, !446, !448}
!493 = distinct !{!493, !494, !"scope"}
!494 = distinct !{!494, !"scope"}
!495 = distinct !{!495, !496, !"scope"}
!496 = distinct !{!496, !"scope"}
!497 = !{!495, !472, !456, !458, !446, !448}
!498 = !{!499, !495, !472, !456, !458, !446, !448}
!499 = distinct !{!499, !500, !"scope"}
!500 = distinct !{!500, !"scope"}
!501 = !{!502, !472, !456, !458, !446, !448}
!502 = distinct !{!502, !503, !"scope"}
!503 = distinct !{!503, !"scope"}
!504 = !{!505, !502, !472, !456, !458, !446, !448}
!505 = distinct !{!505, !506, !"scope"}
!506 = distinct !{!506, !"scope"}
!507 = !{!508, !510, !502, !472, !456, !458, !446, !448}
!508 = distinct !{!508, !509, !"scope"}
!509 = distinct !{!509, !"scope"}
!510 = distinct !{!510, !511, !"scope"}
!511 = distinct !{!511, !"scope"}
!512 = !{!510, !502, !472, !456, !458, !446, !448}
!513 = !{!514, !472, !456, !458, !446, !448}
!514 = distinct !{!514, !515, !"scope"}
!515 = distinct !{!515, !"scope"}
!516 = !{!517, !514, !472, !456, !458, !446, !448}
!517 = distinct !{!517, !518, !"scope"}
!518 = distinct !{!518, !"scope"}
!519 = !{!520, !514, !472, !456, !458, !446, !448}
!520 = distinct !{!520, !521, !"scope"}
!521 = distinct !{!521, !"scope"}
!522 = !{!523, !520, !514, !472, !456, !458, !446, !448}
!523 = distinct !{!523, !524, !"scope"}
!524 = distinct !{!524, !"scope"}
!525 = !{!526, !514, !472, !456, !458, !446, !448}
!526 = distinct !{!526, !527, !"scope"}
!527 = distinct !{!527, !"scope"}
!528 = !{!529, !526, !514, !472, !456, !458, !446, !448}
!529 = distinct !{!529, !530, !"scope"}
!530 = distinct !{!530, !"scope"}
!531 = !{!532, !534, !526, !514, !472, !456, !458, !446, !448}
!532 = distinct !{!532, !533, !"scope"}
!533 = distinct !{!533, !"scope"}
!534 = distinct !{!534, !535, !"scope"}
!535 = distinct !{!535, !"scope"}
!536 = !{!534, !526, !514, !472, !456, !458, !446, !448}
!537 = !{!538, !540, !456, !458, !446, !448}
!538 = distinct !{!538, !539, !"scope"}
!539 = distinct !{!539, !"scope"}
!540 = distinct !{!540, !541, !"scope"}
!541 = distinct !{!541, !"scope"}
!542 = !{!540, !456, !458, !446, !448}
!543 = !{!544, !540, !456, !458, !446, !448}
!544 = distinct !{!544, !545, !"scope"}
!545 = distinct !{!545, !"scope"}
!546 = !{!547, !456, !458, !446, !448}
!547 = distinct !{!547, !548, !"scope"}
!548 = distinct !{!548, !"scope"}
