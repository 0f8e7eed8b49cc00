; made from lanes.py, integrator.py, stepping.py, job.py, rosenbrock.py, sha256 669984bd8b501c8ce73b8467a78aab493bcf0abea9d2e6cf77ae8cf581716acc
@.const.array.data = internal unnamed_addr constant [32 x i8] c"Nb\10X9\B4\D8?\E1z\14\AEG\E1\CA?)\\\8F\C2\F5(\E4?\00\00\00\00\00\00\F0?", align 8
define internal fastcc noundef i32 @v67(ptr noalias nonnull writeonly %retptr, ptr %arg.f.4, i64 %arg.i) unnamed_addr {
entry:
  %.548 = alloca i64, align 8
  %.1432 = alloca ptr, align 8
  %.2912 = alloca ptr, align 8
  %.352.i = getelementptr i8, ptr %arg.f.4, i64 592
  %.353.i = load i64, ptr %.352.i, align 8, !noalias !0
  %.354.i = inttoptr i64 %.353.i to ptr
  %.692.i = load i64, ptr %arg.f.4, align 8, !noalias !0
  %.116 = icmp slt i64 %arg.i, 0
  %.117 = select i1 %.116, i64 %.692.i, i64 0
  %.118 = add i64 %.117, %arg.i
  %.139 = getelementptr i64, ptr %.354.i, i64 %.118
  %0 = getelementptr i64, ptr %.354.i, i64 %.692.i
  %.199 = getelementptr i64, ptr %0, i64 %.118
  %.539 = getelementptr i8, ptr %arg.f.4, i64 208
  %.1800 = getelementptr i8, ptr %arg.f.4, i64 392
  %.2139 = getelementptr i8, ptr %arg.f.4, i64 400
  %.45.i410 = getelementptr i8, ptr %arg.f.4, i64 384
  %1 = getelementptr i8, ptr %arg.f.4, i64 440
  %2 = getelementptr i8, ptr %arg.f.4, i64 432
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
  %.540 = load i64, ptr %.539, align 8
  %.541 = icmp slt i64 %.201, %.540
  br i1 %.541, label %B172, label %B382
B172:
  store i64 0, ptr %.548, align 8
  call fastcc void @v68(ptr %.548, ptr nonnull %arg.f.4, i64 %arg.i)
  %.564 = load i64, ptr %.548, align 8
  %.578 = icmp eq i64 %.564, 0
  br i1 %.578, label %B226, label %B36.backedge
B226:
  %.45.i = load i64, ptr %1, align 8, !noalias !3
  %.46.i = inttoptr i64 %.45.i to ptr
  %.384.i = load i64, ptr %arg.f.4, align 8, !noalias !3
  %.962 = select i1 %.116, i64 %.384.i, i64 0
  %3 = getelementptr double, ptr %.46.i, i64 %arg.i
  %.984 = getelementptr double, ptr %3, i64 %.962
  %.985 = load double, ptr %.984, align 8
  %.45.i399 = load i64, ptr %2, align 8, !noalias !6
  %.46.i400 = inttoptr i64 %.45.i399 to ptr
  %.idx = mul i64 %.384.i, 80
  %4 = getelementptr i8, ptr %.46.i400, i64 %.idx
  %5 = getelementptr double, ptr %4, i64 %arg.i
  %.1395 = getelementptr double, ptr %5, i64 %.962
  %.1396 = load double, ptr %.1395, align 8
  %.1402 = fcmp olt double %.985, %.1396
  br i1 %.1402, label %common.ret, label %B36.backedge
common.ret:
  store ptr null, ptr %retptr, align 8
  ret i32 0
B382:
  call fastcc void @v69(ptr %.1432, ptr nonnull %arg.f.4, i64 %arg.i, i64 %status.3.1)
  br label %B416
B416:
  %.1801 = load i64, ptr %.1800, align 8
  %.2140 = load i64, ptr %.2139, align 8
  %.2141.not = icmp slt i64 %.1801, %.2140
  br i1 %.2141.not, label %B492, label %B566
B492:
  %.46.i411 = load i64, ptr %.45.i410, align 8, !noalias !9
  %.50.i = inttoptr i64 %.46.i411 to ptr
  %.2518 = getelementptr i8, ptr %.50.i, i64 8
  %.2519 = load double, ptr %.2518, align 8
  %.2523 = fcmp une double %.2519, 0.000000e+00
  br i1 %.2523, label %B566, label %B602
B566:
  %.353.i.i = load i64, ptr %.352.i, align 8, !noalias !12
  %.354.i.i = inttoptr i64 %.353.i.i to ptr
  %.692.i.i = load i64, ptr %arg.f.4, align 8, !noalias !12
  %.102.i = select i1 %.116, i64 %.692.i.i, i64 0
  %6 = getelementptr i64, ptr %.354.i.i, i64 %arg.i
  %.124.i = getelementptr i64, ptr %6, i64 %.102.i
  store i64 -1, ptr %.124.i, align 8, !noalias !17
  %.45.i.i = load i64, ptr %1, align 8, !noalias !18
  %.46.i.i = inttoptr i64 %.45.i.i to ptr
  %.384.i.i = load i64, ptr %arg.f.4, align 8, !noalias !18
  %.513.i = select i1 %.116, i64 %.384.i.i, i64 0
  %7 = getelementptr double, ptr %.46.i.i, i64 %.384.i.i
  %8 = getelementptr double, ptr %7, i64 %arg.i
  %.535.i = getelementptr double, ptr %8, i64 %.513.i
  store double 1.000000e-09, ptr %.535.i, align 8, !noalias !17
  %.353.i487.i = load i64, ptr %.352.i, align 8, !noalias !21
  %.354.i488.i = inttoptr i64 %.353.i487.i to ptr
  %.692.i489.i = load i64, ptr %arg.f.4, align 8, !noalias !21
  %.615.i = select i1 %.116, i64 %.692.i489.i, i64 0
  %.idx.i = mul i64 %.692.i489.i, 24
  %9 = getelementptr i8, ptr %.354.i488.i, i64 %.idx.i
  %10 = getelementptr i64, ptr %9, i64 %arg.i
  %.637.i = getelementptr i64, ptr %10, i64 %.615.i
  store i64 0, ptr %.637.i, align 8, !noalias !17
  %.981.i = getelementptr i8, ptr %arg.f.4, i64 408
  %.982.i = load i64, ptr %.981.i, align 8, !noalias !17
  %.983.i = add nsw i64 %.982.i, -1
  store i64 %.983.i, ptr %.981.i, align 8, !noalias !17
  %.1351.i = getelementptr i8, ptr %arg.f.4, i64 128
  %.1352.i = load i64, ptr %.1351.i, align 8, !noalias !17
  %.1999.i = getelementptr i8, ptr %arg.f.4, i64 112
  %.2000.i = load i64, ptr %.1999.i, align 8, !noalias !17
  %.2627.i = shl nsw i64 %.1352.i, 2
  %.3591.i = getelementptr i8, ptr %arg.f.4, i64 144
  %.3592.i = load i64, ptr %.3591.i, align 8, !noalias !17
  %.3930.i = getelementptr i8, ptr %arg.f.4, i64 152
  %.3931.i = load i64, ptr %.3930.i, align 8, !noalias !17
  %.3932.i = add nsw i64 %.3931.i, %.3592.i
  %.4270.i = getelementptr i8, ptr %arg.f.4, i64 176
  %.4271.i = load i64, ptr %.4270.i, align 8, !noalias !17
  %.4272.i = add nsw i64 %.3932.i, %.4271.i
  br label %B534.if.i
B534.loopexit.i:
  %exitcond513.not.i = icmp eq i64 %.4437.i, 5
  br i1 %exitcond513.not.i, label %common.ret, label %B534.if.i
B536.i:
  %.pn.i = phi i64 [ 60, %switch.4.i ], [ 57, %switch.1.i ], [ 58, %switch.2.i ], [ 59, %switch.3.i ], [ 56, %B534.if.i ]
  %.2000.pn.i = phi i64 [ %.4272.i, %switch.4.i ], [ %.1352.i, %switch.1.i ], [ %.2627.i, %switch.2.i ], [ %.1352.i, %switch.3.i ], [ %.2000.i, %B534.if.i ]
  %.4437.i = add nuw nsw i64 %.4310.0512.i, 1
  %11 = getelementptr i64, ptr %arg.f.4, i64 %.pn.i
  %.45.i498.i = load i64, ptr %11, align 8, !noalias !24
  %.46.i499.i = inttoptr i64 %.45.i498.i to ptr
  %.384.i500.i = load i64, ptr %arg.f.4, align 8, !noalias !24
  %.4612509.not.i = icmp slt i64 %.2000.pn.i, 1
  br i1 %.4612509.not.i, label %B534.loopexit.i, label %B606.if.lr.ph.i
B606.if.lr.ph.i:
  %.4733.i = select i1 %.116, i64 %.384.i500.i, i64 0
  br label %B606.if.i
B534.if.i:
  %.4310.0512.i = phi i64 [ 0, %B566 ], [ %.4437.i, %B534.loopexit.i ]
  switch i64 %.4310.0512.i, label %default.unreachable.i [
    i64 0, label %B536.i
    i64 3, label %switch.3.i
    i64 1, label %switch.1.i
    i64 4, label %switch.4.i
    i64 2, label %switch.2.i
  ]
default.unreachable.i:
  unreachable
switch.1.i:
  br label %B536.i
switch.2.i:
  br label %B536.i
switch.3.i:
  br label %B536.i
switch.4.i:
  br label %B536.i
B606.if.i:
  %.4556.0510.i = phi i64 [ 0, %B606.if.lr.ph.i ], [ %.4625.i, %B606.if.i ]
  %.4625.i = add nuw nsw i64 %.4556.0510.i, 1
  %.4698.i = mul i64 %.4556.0510.i, %.384.i500.i
  %.4702.i = getelementptr double, ptr %.46.i499.i, i64 %.4698.i
  %.4703.i = load double, ptr %.4702.i, align 8, !noalias !17
  %12 = getelementptr double, ptr %.4702.i, i64 %arg.i
  %.4755.i = getelementptr double, ptr %12, i64 %.4733.i
  store double %.4703.i, ptr %.4755.i, align 8, !noalias !17
  %exitcond.not.i = icmp eq i64 %.4625.i, %.2000.pn.i
  br i1 %exitcond.not.i, label %B534.loopexit.i, label %B606.if.i
B602:
  call fastcc void @v70(ptr %.2912, ptr nonnull %arg.f.4, i64 %arg.i, i64 %.1801)
  %.3276 = load i64, ptr %.1800, align 8
  %.3277 = add nsw i64 %.3276, 1
  store i64 %.3277, ptr %.1800, align 8
  br label %B36.backedge
B36.backedge:
  %status.3.1.be = phi i64 [ 0, %B602 ], [ %.564, %B226 ], [ %.564, %B172 ]
  br label %B36
}
define internal fastcc void @v68(ptr noalias nonnull writeonly %retptr, ptr readonly %arg.f.4, i64 %arg.i) unnamed_addr {
entry:
  %.49.i = alloca { [5 x i64], { { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, double, double, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, i8 }, { { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] } }, [13 x { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }], { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, align 8
  %.1781 = alloca i64, align 8
  %.3421 = alloca ptr, align 8
  %0 = getelementptr i8, ptr %arg.f.4, i64 432
  %.45.i = load i64, ptr %0, align 8, !noalias !27
  %.46.i = inttoptr i64 %.45.i to ptr
  %.384.i = load i64, ptr %arg.f.4, align 8, !noalias !27
  %.352.i = getelementptr i8, ptr %arg.f.4, i64 592
  %.353.i = load i64, ptr %.352.i, align 8, !noalias !30
  %.354.i = inttoptr i64 %.353.i to ptr
  %.474 = icmp slt i64 %arg.i, 0
  %.475 = select i1 %.474, i64 %.384.i, i64 0
  %.476 = add i64 %.475, %arg.i
  %1 = getelementptr i64, ptr %.354.i, i64 %.384.i
  %.497 = getelementptr i64, ptr %1, i64 %.476
  %.498 = load i64, ptr %.497, align 8
  %.499 = add nsw i64 %.498, 1
  store i64 %.499, ptr %.497, align 8
  %.353.i.i = load i64, ptr %.352.i, align 8, !noalias !33
  %.354.i.i = inttoptr i64 %.353.i.i to ptr
  %.692.i.i = load i64, ptr %arg.f.4, align 8, !noalias !33
  %.96.i = select i1 %.474, i64 %.692.i.i, i64 0
  %2 = getelementptr i64, ptr %.354.i.i, i64 %.692.i.i
  %3 = getelementptr i64, ptr %2, i64 %arg.i
  %.118.i = getelementptr i64, ptr %3, i64 %.96.i
  %.119.i = load i64, ptr %.118.i, align 8, !noalias !38
  %.462.i = getelementptr i8, ptr %arg.f.4, i64 208
  %.463.i = load i64, ptr %.462.i, align 8, !noalias !38
  %.801.i = getelementptr i8, ptr %arg.f.4, i64 128
  %.802.i = load i64, ptr %.801.i, align 8, !noalias !38
  %.45.i.i = getelementptr i8, ptr %arg.f.4, i64 288
  %.46.i.i = load i64, ptr %.45.i.i, align 8, !noalias !39
  %.50.i.i = inttoptr i64 %.46.i.i to ptr
  %.1168.i = add nsw i64 %.119.i, 1
  %.1170.i = icmp slt i64 %.1168.i, %.463.i
  br i1 %.1170.i, label %B204.i, label %B226.i
B204.i:
  %.1187.i = icmp slt i64 %.119.i, -1
  %.1188.i = select i1 %.1187.i, i64 %.463.i, i64 0
  %4 = getelementptr double, ptr %.50.i.i, i64 %.1168.i
  %.1202.i = getelementptr double, ptr %4, i64 %.1188.i
  br label %B322.i
B226.i:
  %.1855.i = getelementptr i8, ptr %arg.f.4, i64 224
  %.1856.i = load i64, ptr %.1855.i, align 8, !noalias !38
  %.45.i376.i = getelementptr i8, ptr %arg.f.4, i64 328
  %.46.i377.i = load i64, ptr %.45.i376.i, align 8, !noalias !42
  %.50.i378.i = inttoptr i64 %.46.i377.i to ptr
  %5 = getelementptr double, ptr %.50.i378.i, i64 %.1856.i
  %.1922.i = getelementptr i8, ptr %5, i64 -8
  br label %B322.i
B322.i:
  %"$phi322.0.2.0.in.i" = phi ptr [ %.1202.i, %B204.i ], [ %.1922.i, %B226.i ]
  %"$phi322.0.2.0.i" = load double, ptr %"$phi322.0.2.0.in.i", align 8, !noalias !38
  %.45.i384.i = getelementptr i8, ptr %arg.f.4, i64 296
  %.46.i385.i = load i64, ptr %.45.i384.i, align 8, !noalias !45
  %.50.i386.i = inttoptr i64 %.46.i385.i to ptr
  %.2300.i = icmp slt i64 %.119.i, 0
  %.2301.i = select i1 %.2300.i, i64 %.463.i, i64 0
  %6 = getelementptr i64, ptr %.50.i386.i, i64 %.119.i
  %.2315.i = getelementptr i64, ptr %6, i64 %.2301.i
  %.2316.i = load i64, ptr %.2315.i, align 8, !noalias !38
  %.2657.i = getelementptr i8, ptr %arg.f.4, i64 248
  %.2658.i = load i64, ptr %.2657.i, align 8, !noalias !38
  %.2659.i = icmp sgt i64 %.2658.i, 0
  br i1 %.2659.i, label %B432.i, label %b84
B432.i:
  %.3001.i = getelementptr i8, ptr %arg.f.4, i64 216
  %.3002.i = load i64, ptr %.3001.i, align 8, !noalias !38
  %.3004.i = mul nsw i64 %.3002.i, %arg.i
  br label %b84
b84:
  %"$phi476.1.2.0.i" = phi i64 [ %.3004.i, %B432.i ], [ 0, %B322.i ]
  %.3018.i = add nsw i64 %"$phi476.1.2.0.i", %.2316.i
  %7 = getelementptr double, ptr %.50.i.i, i64 %.119.i
  %.3052.i = getelementptr double, ptr %7, i64 %.2301.i
  %.3053.i = load double, ptr %.3052.i, align 8, !noalias !38
  %.3398.i = getelementptr i8, ptr %arg.f.4, i64 304
  %.3399.i = load i64, ptr %.3398.i, align 8, !noalias !38
  %.3406.i = mul nsw i64 %.802.i, 56
  %.3407.i = mul nsw i64 %.3406.i, %.3018.i
  %.3408.i = add nsw i64 %.3399.i, %.3407.i
  %.3409.i = inttoptr i64 %.3408.i to ptr
  %.936 = getelementptr i8, ptr %arg.f.4, i64 160
  %.937 = load i64, ptr %.936, align 8
  %.938 = icmp sgt i64 %.937, 0
  %8 = getelementptr i8, ptr %arg.f.4, i64 440
  %.45.i768 = load i64, ptr %8, align 8, !noalias !48
  %.46.i769 = inttoptr i64 %.45.i768 to ptr
  %9 = getelementptr double, ptr %.46.i769, i64 %arg.i
  %.1372 = getelementptr double, ptr %9, i64 %.96.i
  store double %.3053.i, ptr %.1372, align 8
  %.idx = mul i64 %.384.i, 80
  %10 = getelementptr i8, ptr %.46.i, i64 %.idx
  %.1432 = getelementptr double, ptr %10, i64 %.476
  store double %"$phi322.0.2.0.i", ptr %.1432, align 8
  br i1 %.938, label %B368, label %B324
B324:
  %.1773 = getelementptr i8, ptr %arg.f.4, i64 232
  %.1774 = load i64, ptr %.1773, align 8
  %.1775 = icmp sgt i64 %.1774, 0
  br i1 %.1775, label %B368, label %B424
B368:
  store i64 0, ptr %.1781, align 8
  call fastcc void @v71(ptr %.1781, ptr nonnull %arg.f.4, i64 %arg.i, double %.3053.i, ptr %.3409.i, i64 7)
  %.1801 = load i64, ptr %.1781, align 8
  %.1811 = icmp sgt i64 %.1801, -1
  br i1 %.1811, label %common.ret, label %B424
common.ret:
  %storemerge = phi i64 [ 0, %b85 ], [ 1, %B368 ]
  store i64 %storemerge, ptr %retptr, align 8
  ret void
B424:
  %.2184 = getelementptr i8, ptr %arg.f.4, i64 312
  %.2185 = load i64, ptr %.2184, align 8
  %.2186 = inttoptr i64 %.2185 to ptr
  %.2525 = load i64, ptr %.462.i, align 8
  %.2619 = load i64, ptr %.497, align 8
  %.2632 = icmp slt i64 %.2619, 0
  %.2633 = select i1 %.2632, i64 %.2525, i64 0
  %11 = getelementptr i8, ptr %.2186, i64 %.2619
  %.2647 = getelementptr i8, ptr %11, i64 %.2633
  %.2648 = load i8, ptr %.2647, align 1
  %.2652.not = icmp eq i8 %.2648, 0
  br i1 %.2652.not, label %B648, label %B596
B596:
  %.idx749 = mul i64 %.384.i, 88
  %12 = getelementptr i8, ptr %.46.i, i64 %.idx749
  %.2707 = getelementptr double, ptr %12, i64 %.476
  %.2708 = load double, ptr %.2707, align 8
  %.2709 = fneg double %.2708
  store double %.2709, ptr %.2707, align 8
  br label %B648
B648:
  %.idx750 = shl i64 %.384.i, 5
  %13 = getelementptr i8, ptr %.46.i, i64 %.idx750
  %.2831 = getelementptr double, ptr %13, i64 %.476
  store double 0x3FD43D136248490F, ptr %.2831, align 8
  %.idx751 = mul i64 %.384.i, 40
  %14 = getelementptr i8, ptr %.46.i, i64 %.idx751
  %.2886 = getelementptr double, ptr %14, i64 %.476
  store double 0.000000e+00, ptr %.2886, align 8
  %.idx752 = mul i64 %.384.i, 112
  %15 = getelementptr i8, ptr %.46.i, i64 %.idx752
  %.2942 = getelementptr double, ptr %15, i64 %.476
  store double %.3053.i, ptr %.2942, align 8
  %.idx753 = mul i64 %.384.i, 96
  %16 = getelementptr i8, ptr %.46.i, i64 %.idx753
  %.2998 = getelementptr double, ptr %16, i64 %.476
  store double %.3053.i, ptr %.2998, align 8
  %.idx754 = mul i64 %.384.i, 104
  %17 = getelementptr i8, ptr %.46.i, i64 %.idx754
  %.3053 = getelementptr double, ptr %17, i64 %.476
  store double 0.000000e+00, ptr %.3053, align 8
  %.idx755 = shl i64 %.384.i, 4
  %18 = getelementptr i8, ptr %.354.i, i64 %.idx755
  %.3121 = getelementptr i64, ptr %18, i64 %.476
  store i64 0, ptr %.3121, align 8
  %19 = getelementptr i8, ptr %.354.i, i64 %.idx750
  %.3176 = getelementptr i64, ptr %19, i64 %.476
  store i64 1, ptr %.3176, align 8
  %.idx757 = mul i64 %.384.i, 48
  %20 = getelementptr i8, ptr %.354.i, i64 %.idx757
  %.3231 = getelementptr i64, ptr %20, i64 %.476
  store i64 -1, ptr %.3231, align 8
  %.3238 = fcmp ogt double %.3053.i, 0.000000e+00
  %or.cond = select i1 %.938, i1 true, i1 %.3238
  %. = zext i1 %or.cond to i64
  %21 = getelementptr i8, ptr %.354.i, i64 %.idx751
  %.3301 = getelementptr i64, ptr %21, i64 %.476
  store i64 %., ptr %.3301, align 8
  %spec.select.i = tail call i64 @llvm.smax.i64(i64 %.802.i, i64 0)
  br label %B66.i
B66.i:
  %.75.0.i = phi i64 [ 0, %B648 ], [ %.146.i, %B108.i ]
  %exitcond.not.i = icmp eq i64 %.75.0.i, %spec.select.i
  br i1 %exitcond.not.i, label %b86, label %B66.if.i
B108.i:
  %.146.i = add nuw i64 %.75.0.i, 1
  %.303.i = getelementptr i8, ptr %22, i64 16
  %.304.i = load double, ptr %.303.i, align 8, !noalias !51
  %.310.i = fcmp une double %.304.i, 0.000000e+00
  br i1 %.310.i, label %b86, label %B66.i
B66.if.i:
  %.idx784 = mul i64 %.75.0.i, 56
  %22 = getelementptr i8, ptr %.3409.i, i64 %.idx784
  %.233.i = getelementptr i8, ptr %22, i64 8
  %.234.i = load double, ptr %.233.i, align 8, !noalias !51
  %.240.i = fcmp une double %.234.i, 0.000000e+00
  br i1 %.240.i, label %b86, label %B108.i
b86:
  %23 = phi i64 [ 0, %B66.i ], [ 1, %B66.if.i ], [ 1, %B108.i ]
  %.idx759 = mul i64 %.384.i, 24
  %24 = getelementptr i8, ptr %.354.i, i64 %.idx759
  %.3405 = getelementptr i64, ptr %24, i64 %.476
  store i64 %23, ptr %.3405, align 8
  call fastcc void @v72(ptr %.3421, ptr nonnull %arg.f.4, i64 %arg.i, ptr %.3409.i, i64 7, double %.3053.i)
  call void @llvm.lifetime.start.p0(ptr nonnull %.49.i)
  %.fca.5.0.2.gep.i = getelementptr inbounds i8, ptr %.49.i, i64 872
  %.fca.5.0.4.gep.i = getelementptr inbounds i8, ptr %.49.i, i64 888
  call fastcc void @v73(ptr %.49.i, ptr nonnull readonly %arg.f.4, i64 %arg.i)
  %.65.fca.5.0.2.load.i = load i64, ptr %.fca.5.0.2.gep.i, align 8, !noalias !54
  %.65.fca.5.0.4.load.i = load ptr, ptr %.fca.5.0.4.gep.i, align 8, !noalias !54
  %25 = getelementptr i8, ptr %arg.f.4, i64 464
  %.45.i.i779 = load i64, ptr %25, align 8, !noalias !57
  %.46.i.i780 = inttoptr i64 %.45.i.i779 to ptr
  %.384.i.i = load i64, ptr %arg.f.4, align 8, !noalias !57
  %.148211.not.i.i = icmp slt i64 %.65.fca.5.0.2.load.i, 1
  %invariant.gep.i = getelementptr double, ptr %.46.i.i780, i64 %arg.i
  %.1501.i = select i1 %.474, i64 %.384.i.i, i64 0
  %invariant.gep439.i = getelementptr double, ptr %invariant.gep.i, i64 %.1501.i
  br label %B138.if.i
B138.loopexit.i:
  %exitcond443.not.i = icmp eq i64 %.1185.i, 4
  br i1 %exitcond443.not.i, label %b85, label %B138.if.i
B138.if.i:
  %.1116.0442.i = phi i64 [ 0, %b86 ], [ %.1185.i, %B138.loopexit.i ]
  %.1185.i = add nuw nsw i64 %.1116.0442.i, 1
  %26 = getelementptr double, ptr @.const.array.data, i64 %.1116.0442.i
  %.1268.i = load double, ptr %26, align 8, !noalias !54
  %.1273.i = fmul double %.1268.i, 0.000000e+00
  %.1275.i = fadd double %.3053.i, %.1273.i
  br i1 %.148211.not.i.i, label %B138.loopexit.i, label %B58.if.i.i
B164.i.i:
  %.44.i.i.i = getelementptr i8, ptr %28, i64 24
  %.45.i.i.i = load double, ptr %.44.i.i.i, align 8, !noalias !60
  %.73.i.i.i = getelementptr i8, ptr %28, i64 32
  %.74.i.i.i = load double, ptr %.73.i.i.i, align 8, !noalias !60
  %.75.i.i.i = fmul double %.74.i.i.i, 5.000000e-01
  %.76.i.i.i = fmul double %.245.i.i, %.75.i.i.i
  %.77.i.i.i = fadd double %.45.i.i.i, %.76.i.i.i
  %.78.i.i.i = fmul double %.245.i.i, %.77.i.i.i
  %.87.le.i.i.i = tail call double @llvm.floor.f64(double %.78.i.i.i)
  %.92.i.i.i = fsub double %.78.i.i.i, %.87.le.i.i.i
  %.93.i.i.i = fmul double %.92.i.i.i, 0x401921FB54442D18
  %.121.i.i.i = getelementptr i8, ptr %28, i64 40
  %.122.i.i.i = load double, ptr %.121.i.i.i, align 8, !noalias !60
  %.126.i.i.i = fadd double %.122.i.i.i, %.93.i.i.i
  %.593.le.i.i = tail call double @llvm.sin.f64(double %.126.i.i.i)
  %.598.i.i = fmul double %.423.i.i, %.593.le.i.i
  %.600.i.i = fadd double %.361.i.i, %.598.i.i
  br label %B272.i.i
B272.i.i:
  %value.2.1.i.i = phi double [ %.600.i.i, %B164.i.i ], [ %.361.i.i, %B58.if.i.i ]
  %27 = getelementptr double, ptr %.65.fca.5.0.4.load.i, i64 %.90.0213.i.i
  store double %value.2.1.i.i, ptr %27, align 8, !noalias !65
  %exitcond.not.i.i = icmp eq i64 %.65.fca.5.0.2.load.i, %.161.i.i
  br i1 %exitcond.not.i.i, label %B260.preheader.i, label %B58.if.i.i
B260.preheader.i:
  %.1470.i = mul nuw nsw i64 %.1116.0442.i, %.65.fca.5.0.2.load.i
  br label %B260.if.i
B58.if.i.i:
  %.90.0213.i.i = phi i64 [ %.161.i.i, %B272.i.i ], [ 0, %B138.if.i ]
  %.161.i.i = add nuw nsw i64 %.90.0213.i.i, 1
  %.idx785 = mul i64 %.90.0213.i.i, 56
  %28 = getelementptr i8, ptr %.3409.i, i64 %.idx785
  %.242.i.i = getelementptr i8, ptr %28, i64 48
  %.243.i.i = load double, ptr %.242.i.i, align 8, !noalias !65
  %.245.i.i = fsub double %.1275.i, %.243.i.i
  %.303.i.i = load double, ptr %28, align 8, !noalias !65
  %.357.i.i = getelementptr i8, ptr %28, i64 8
  %.358.i.i = load double, ptr %.357.i.i, align 8, !noalias !65
  %.360.i.i = fmul double %.245.i.i, %.358.i.i
  %.361.i.i = fadd double %.303.i.i, %.360.i.i
  %.422.i.i = getelementptr i8, ptr %28, i64 16
  %.423.i.i = load double, ptr %.422.i.i, align 8, !noalias !65
  %.424.i.i = fcmp une double %.423.i.i, 0.000000e+00
  br i1 %.424.i.i, label %B164.i.i, label %B272.i.i
B260.if.i:
  %.1338.0437.i = phi i64 [ 0, %B260.preheader.i ], [ %.1407.i, %B260.if.i ]
  %.1407.i = add nuw nsw i64 %.1338.0437.i, 1
  %29 = getelementptr double, ptr %.65.fca.5.0.4.load.i, i64 %.1338.0437.i
  %.1461.i = load double, ptr %29, align 8, !noalias !54
  %.1471.i = add nuw nsw i64 %.1338.0437.i, %.1470.i
  %.1519.i = mul i64 %.1471.i, %.384.i.i
  %gep440.i = getelementptr double, ptr %invariant.gep439.i, i64 %.1519.i
  store double %.1461.i, ptr %gep440.i, align 8, !noalias !54
  %exitcond.not.i781 = icmp eq i64 %.1407.i, %.65.fca.5.0.2.load.i
  br i1 %exitcond.not.i781, label %B138.loopexit.i, label %B260.if.i
b85:
  call void @llvm.lifetime.end.p0(ptr nonnull %.49.i)
  br label %common.ret
}
define internal fastcc void @v69(ptr noalias nonnull writeonly %retptr, ptr readonly %arg.f.4, i64 %arg.i, i64 %arg.status) unnamed_addr {
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
  call fastcc void @v73(ptr %.27, ptr %arg.f.4, i64 %arg.i)
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
  %.809 = getelementptr i8, ptr %arg.f.4, i64 112
  %.810 = load i64, ptr %.809, align 8
  %.1148 = getelementptr i8, ptr %arg.f.4, i64 168
  %.1149 = load i64, ptr %.1148, align 8
  %.1487 = getelementptr i8, ptr %arg.f.4, i64 136
  %.1488 = load i64, ptr %.1487, align 8
  %.1826 = getelementptr i8, ptr %arg.f.4, i64 224
  %.1827 = load i64, ptr %.1826, align 8
  %0 = getelementptr i8, ptr %arg.f.4, i64 440
  %.45.i = load i64, ptr %0, align 8, !noalias !66
  %.46.i = inttoptr i64 %.45.i to ptr
  %.384.i = load i64, ptr %arg.f.4, align 8, !noalias !66
  %.3313 = icmp slt i64 %arg.i, 0
  %.3314 = select i1 %.3313, i64 %.384.i, i64 0
  %1 = getelementptr double, ptr %.46.i, i64 %arg.i
  %.3336 = getelementptr double, ptr %1, i64 %.3314
  %.3337 = load double, ptr %.3336, align 8
  %.352.i = getelementptr i8, ptr %arg.f.4, i64 592
  %.353.i = load i64, ptr %.352.i, align 8, !noalias !69
  %.354.i = inttoptr i64 %.353.i to ptr
  %2 = getelementptr i64, ptr %.354.i, i64 %arg.i
  %.3438 = getelementptr i64, ptr %2, i64 %.3314
  %.3439 = load i64, ptr %.3438, align 8
  %.175117.not.i = icmp slt i64 %.43.fca.6.2.load, 1
  br i1 %.175117.not.i, label %b87, label %B76.if.lr.ph.i
B76.if.lr.ph.i:
  %3 = getelementptr i8, ptr %arg.f.4, i64 448
  %.45.i.i = load i64, ptr %3, align 8, !noalias !72
  %.46.i.i = inttoptr i64 %.45.i.i to ptr
  %invariant.gep.i = getelementptr double, ptr %.46.i.i, i64 %arg.i
  %invariant.gep120.i = getelementptr double, ptr %invariant.gep.i, i64 %.3314
  br label %B76.if.i
B76.if.i:
  %.119.0118.i = phi i64 [ 0, %B76.if.lr.ph.i ], [ %.188.i, %B76.if.i ]
  %.188.i = add nuw nsw i64 %.119.0118.i, 1
  %.260.i = mul i64 %.119.0118.i, %.384.i
  %gep121.i = getelementptr double, ptr %invariant.gep120.i, i64 %.260.i
  %.265.i = load double, ptr %gep121.i, align 8, !noalias !77
  %4 = getelementptr double, ptr %.43.fca.6.4.load, i64 %.119.0118.i
  store double %.265.i, ptr %4, align 8, !noalias !77
  %exitcond.not.i = icmp eq i64 %.188.i, %.43.fca.6.2.load
  br i1 %exitcond.not.i, label %b87, label %B76.if.i
b87:
  %.4192 = add nsw i64 %.3439, 1
  %.4530 = getelementptr i8, ptr %arg.f.4, i64 368
  %.4531 = load i64, ptr %.4530, align 8
  %.4532 = mul nsw i64 %.4531, %.4192
  %.45.i2559 = getelementptr i8, ptr %arg.f.4, i64 360
  %.46.i2560 = load i64, ptr %.45.i2559, align 8, !noalias !78
  %.50.i = inttoptr i64 %.46.i2560 to ptr
  %.4910 = mul nsw i64 %.4531, %.3439
  %.4946 = icmp slt i64 %.4910, 0
  %.4947 = select i1 %.4946, i64 %.4532, i64 0
  %.4948 = add i64 %.4947, %.4910
  %.4951 = icmp slt i64 %.4948, 0
  br i1 %.4951, label %B0.endif.endif.endif.endif.endif.endif.else.if, label %B0.endif.endif.endif.endif.endif.endif.else.endif, !prof !81
B616:
  %.5127 = add nsw i64 %.1827, -1
  %.13.i = tail call i64 @llvm.smin.i64(i64 %.5127, i64 %.5125)
  store i64 %.13.i, ptr %.5124, align 8
  %.353.i.i = load i64, ptr %.352.i, align 8, !noalias !82
  %.354.i.i = inttoptr i64 %.353.i.i to ptr
  %.692.i.i = load i64, ptr %arg.f.4, align 8, !noalias !82
  %.96.i = select i1 %.3313, i64 %.692.i.i, i64 0
  %5 = getelementptr i64, ptr %.354.i.i, i64 %.692.i.i
  %6 = getelementptr i64, ptr %5, i64 %arg.i
  %.118.i = getelementptr i64, ptr %6, i64 %.96.i
  %.119.i = load i64, ptr %.118.i, align 8, !noalias !87
  %.462.i = getelementptr i8, ptr %arg.f.4, i64 208
  %.463.i = load i64, ptr %.462.i, align 8, !noalias !87
  %.801.i = getelementptr i8, ptr %arg.f.4, i64 128
  %.802.i = load i64, ptr %.801.i, align 8, !noalias !87
  %.45.i384.i = getelementptr i8, ptr %arg.f.4, i64 296
  %.46.i385.i = load i64, ptr %.45.i384.i, align 8, !noalias !88
  %.50.i386.i = inttoptr i64 %.46.i385.i to ptr
  %.2300.i = icmp slt i64 %.119.i, 0
  %.2301.i = select i1 %.2300.i, i64 %.463.i, i64 0
  %7 = getelementptr i64, ptr %.50.i386.i, i64 %.119.i
  %.2315.i = getelementptr i64, ptr %7, i64 %.2301.i
  %.2316.i = load i64, ptr %.2315.i, align 8, !noalias !87
  %.2657.i = getelementptr i8, ptr %arg.f.4, i64 248
  %.2658.i = load i64, ptr %.2657.i, align 8, !noalias !87
  %.2659.i = icmp sgt i64 %.2658.i, 0
  br i1 %.2659.i, label %B432.i, label %b84
B432.i:
  %.3001.i = getelementptr i8, ptr %arg.f.4, i64 216
  %.3002.i = load i64, ptr %.3001.i, align 8, !noalias !87
  %.3004.i = mul nsw i64 %.3002.i, %arg.i
  br label %b84
b84:
  %"$phi476.1.2.0.i" = phi i64 [ %.3004.i, %B432.i ], [ 0, %B616 ]
  %.3018.i = add nsw i64 %"$phi476.1.2.0.i", %.2316.i
  %.3398.i = getelementptr i8, ptr %arg.f.4, i64 304
  %.3399.i = load i64, ptr %.3398.i, align 8, !noalias !87
  %.3406.i = mul nsw i64 %.802.i, 56
  %.3407.i = mul nsw i64 %.3406.i, %.3018.i
  %.3408.i = add nsw i64 %.3407.i, %.3399.i
  %.3409.i = inttoptr i64 %.3408.i to ptr
  %.148211.not.i.i.i = icmp slt i64 %.43.fca.5.0.2.load, 1
  br i1 %.148211.not.i.i.i, label %b88, label %B58.if.i.i.i
B164.i.i.i:
  %.44.i.i.i.i = getelementptr i8, ptr %9, i64 24
  %.45.i.i.i.i = load double, ptr %.44.i.i.i.i, align 8, !noalias !91
  %.73.i.i.i.i = getelementptr i8, ptr %9, i64 32
  %.74.i.i.i.i = load double, ptr %.73.i.i.i.i, align 8, !noalias !91
  %.75.i.i.i.i = fmul double %.74.i.i.i.i, 5.000000e-01
  %.76.i.i.i.i = fmul double %.245.i.i.i, %.75.i.i.i.i
  %.77.i.i.i.i = fadd double %.45.i.i.i.i, %.76.i.i.i.i
  %.78.i.i.i.i = fmul double %.245.i.i.i, %.77.i.i.i.i
  %.87.le.i.i.i.i = tail call double @llvm.floor.f64(double %.78.i.i.i.i)
  %.92.i.i.i.i = fsub double %.78.i.i.i.i, %.87.le.i.i.i.i
  %.93.i.i.i.i = fmul double %.92.i.i.i.i, 0x401921FB54442D18
  %.121.i.i.i.i = getelementptr i8, ptr %9, i64 40
  %.122.i.i.i.i = load double, ptr %.121.i.i.i.i, align 8, !noalias !91
  %.126.i.i.i.i = fadd double %.122.i.i.i.i, %.93.i.i.i.i
  %.593.le.i.i.i = tail call double @llvm.sin.f64(double %.126.i.i.i.i)
  %.598.i.i.i = fmul double %.423.i.i.i, %.593.le.i.i.i
  %.600.i.i.i = fadd double %.361.i.i.i, %.598.i.i.i
  br label %B272.i.i.i
B272.i.i.i:
  %value.2.1.i.i.i = phi double [ %.600.i.i.i, %B164.i.i.i ], [ %.361.i.i.i, %B58.if.i.i.i ]
  %8 = getelementptr double, ptr %.43.fca.5.0.4.load, i64 %.90.0213.i.i.i
  store double %value.2.1.i.i.i, ptr %8, align 8, !noalias !100
  %exitcond.not.i.i.i = icmp eq i64 %.43.fca.5.0.2.load, %.161.i.i.i
  br i1 %exitcond.not.i.i.i, label %b88, label %B58.if.i.i.i
B58.if.i.i.i:
  %.90.0213.i.i.i = phi i64 [ %.161.i.i.i, %B272.i.i.i ], [ 0, %b84 ]
  %.161.i.i.i = add nuw nsw i64 %.90.0213.i.i.i, 1
  %.idx = mul i64 %.90.0213.i.i.i, 56
  %9 = getelementptr i8, ptr %.3409.i, i64 %.idx
  %.242.i.i.i = getelementptr i8, ptr %9, i64 48
  %.243.i.i.i = load double, ptr %.242.i.i.i, align 8, !noalias !100
  %.245.i.i.i = fsub double %.3337, %.243.i.i.i
  %.303.i.i.i = load double, ptr %9, align 8, !noalias !100
  %.357.i.i.i = getelementptr i8, ptr %9, i64 8
  %.358.i.i.i = load double, ptr %.357.i.i.i, align 8, !noalias !100
  %.360.i.i.i = fmul double %.245.i.i.i, %.358.i.i.i
  %.361.i.i.i = fadd double %.303.i.i.i, %.360.i.i.i
  %.422.i.i.i = getelementptr i8, ptr %9, i64 16
  %.423.i.i.i = load double, ptr %.422.i.i.i, align 8, !noalias !100
  %.424.i.i.i = fcmp une double %.423.i.i.i, 0.000000e+00
  br i1 %.424.i.i.i, label %B164.i.i.i, label %B272.i.i.i
b88:
  store double %.3337, ptr %.43.fca.5.3.4.load, align 8, !noalias !101
  %.992.i.i = inttoptr i64 %.43.fca.0.3.load to ptr
  tail call void %.992.i.i(ptr nonnull %.43.fca.5.3.4.load, ptr %.43.fca.6.4.load, ptr %.43.fca.5.0.4.load, ptr %.43.fca.1.0.4.load, ptr %.43.fca.3.2.4.load), !noalias !101
  %.649.i = load i64, ptr %.5124, align 8, !noalias !102
  %.754872.not.i = icmp slt i64 %.43.fca.3.2.2.load, 1
  br i1 %.754872.not.i, label %b89, label %B116.if.lr.ph.i
B116.if.lr.ph.i:
  %invariant.gep.i2563 = getelementptr double, ptr %.43.fca.3.1.4.load, i64 %.649.i
  %.879.i = icmp slt i64 %.649.i, 0
  %.880.i = select i1 %.879.i, i64 %.43.fca.3.1.5.1.load, i64 0
  %invariant.gep875.i = getelementptr double, ptr %invariant.gep.i2563, i64 %.880.i
  br label %B116.if.i
B116.if.i:
  %.698.0873.i = phi i64 [ 0, %B116.if.lr.ph.i ], [ %.767.i, %B116.if.i ]
  %.767.i = add nuw nsw i64 %.698.0873.i, 1
  %10 = getelementptr double, ptr %.43.fca.3.2.4.load, i64 %.698.0873.i
  %.821.i = load double, ptr %10, align 8, !noalias !102
  %.898.i = mul i64 %.698.0873.i, %.43.fca.3.1.5.1.load
  %gep876.i = getelementptr double, ptr %invariant.gep875.i, i64 %.898.i
  store double %.821.i, ptr %gep876.i, align 8, !noalias !102
  %exitcond.not.i2564 = icmp eq i64 %.767.i, %.43.fca.3.2.2.load
  br i1 %exitcond.not.i2564, label %b89, label %B116.if.i
b89:
  %.922.i = add nsw i64 %.649.i, 1
  store i64 %.922.i, ptr %.5124, align 8, !noalias !102
  br label %B896
B788:
  %.5431 = icmp sgt i64 %.5125, 0
  br i1 %.5431, label %B822, label %B896
B822:
  %11 = getelementptr double, ptr %.43.fca.3.0.4.load, i64 %.5125
  %.5519 = getelementptr i8, ptr %11, i64 -8
  %.5520 = load double, ptr %.5519, align 8
  br label %B896
B896:
  %.3337.sink = phi double [ %.3337, %b89 ], [ %.5520, %B822 ], [ 0.000000e+00, %B788 ]
  %12 = getelementptr double, ptr %.5049, i64 %.5033
  %.5394 = getelementptr i8, ptr %12, i64 -8
  store double %.3337.sink, ptr %.5394, align 8
  %.5593 = getelementptr i8, ptr %.43.fca.9.4.load, i64 16
  %.5594 = load i64, ptr %.5593, align 8
  %13 = getelementptr i8, ptr %arg.f.4, i64 576
  %.45.i2565 = load i64, ptr %13, align 8, !noalias !103
  %.46.i2566 = inttoptr i64 %.45.i2565 to ptr
  %.384.i2567 = load i64, ptr %arg.f.4, align 8, !noalias !103
  %.5979 = getelementptr i8, ptr %.43.fca.9.4.load, i64 40
  store i64 %arg.status, ptr %.5979, align 8
  %.60862587.not = icmp slt i64 %.810, 1
  br i1 %.60862587.not, label %B1150, label %B1026.if.preheader
B1026.if.preheader:
  %invariant.gep2612 = getelementptr double, ptr %.5049, i64 %.810
  br label %B1026.if
B1106.if.lr.ph:
  %spec.select2580 = mul nuw nsw i64 %.810, 3
  %invariant.gep = getelementptr double, ptr %.46.i2566, i64 %arg.i
  %.6346 = select i1 %.3313, i64 %.384.i2567, i64 0
  %invariant.gep2593 = getelementptr double, ptr %invariant.gep, i64 %.6346
  %.idx2607 = shl i64 %.810, 4
  %invariant.gep2614 = getelementptr i8, ptr %.5049, i64 %.idx2607
  br label %B1106.if
B1150:
  %.6421 = mul nsw i64 %.810, 5
  %.6423 = add nsw i64 %.6421, %.1149
  %.6460 = icmp slt i64 %.6423, 0
  %.6461 = select i1 %.6460, i64 %.5033, i64 0
  %.6462 = add i64 %.6461, %.6423
  %.6465 = icmp slt i64 %.6462, 0
  br i1 %.6465, label %B1150.else.if, label %B1150.else.endif, !prof !81
B1242.loopexit:
  %exitcond2606.not = icmp eq i64 %.6933, %.1488
  br i1 %exitcond2606.not, label %B1412, label %B1242.if
B1258:
  %.7013 = mul i64 %.6864.02600, %.43.fca.3.1.5.1.load
  %gep = getelementptr double, ptr %invariant.gep2598, i64 %.7013
  %.7017 = getelementptr i8, ptr %gep, i64 -8
  %.7018 = load double, ptr %.7017, align 8
  br label %B1306
B1306:
  %"$phi1306.1.2.1" = phi double [ %.7018, %B1258 ], [ 0x7FF8000000000000, %B1242.if ]
  %.7034 = add nsw i64 %.7032, %.6864.02600
  %.7049 = icmp slt i64 %.7034, 0
  %.7050 = select i1 %.7049, i64 %.5033, i64 0
  %14 = getelementptr double, ptr %.5049, i64 %.7034
  %.7064 = getelementptr double, ptr %14, i64 %.7050
  store double %"$phi1306.1.2.1", ptr %.7064, align 8
  br i1 %.71492595.not, label %B1242.loopexit, label %B1370.if.lr.ph
B1370.if.lr.ph:
  %.7234 = mul i64 %.6864.02600, %.43.fca.3.1.5.1.load
  %15 = getelementptr double, ptr %.43.fca.3.1.4.load, i64 %.7234
  br label %B1370.if
B1412:
  store ptr null, ptr %retptr, align 8
  ret void
B0.endif.endif.endif.endif.endif.endif.else.if:
  br label %B0.endif.endif.endif.endif.endif.endif.else.endif
B0.endif.endif.endif.endif.endif.endif.else.endif:
  %.4936.sroa.0.1 = phi i64 [ 0, %B0.endif.endif.endif.endif.endif.endif.else.if ], [ %.4948, %b87 ]
  %.4956.not = icmp slt i64 %.4948, %.4532
  br i1 %.4956.not, label %B0.endif.endif.endif.endi...endif.if, label %B0.endif.endif.endif.endif.endif.endif.else.endif.if, !prof !106
B0.endif.endif.endif.endif.endif.endif.else.endif.if:
  br label %B0.endif.endif.endif.endi...endif.if
B0.endif.endif.endif.endi...endif.if:
  %.4936.sroa.0.3 = phi i64 [ %.4532, %B0.endif.endif.endif.endif.endif.endif.else.endif.if ], [ %.4936.sroa.0.1, %B0.endif.endif.endif.endif.endif.endif.else.endif ]
  %.5024 = sub i64 %.4532, %.4936.sroa.0.3
  %.5033 = tail call i64 @llvm.smax.i64(i64 %.5024, i64 0)
  %.5049 = getelementptr double, ptr %.50.i, i64 %.4936.sroa.0.3
  %or.cond = icmp ult i64 %arg.status, 2
  %.5124 = getelementptr i8, ptr %.43.fca.9.4.load, i64 16
  %.5125 = load i64, ptr %.5124, align 8
  br i1 %or.cond, label %B616, label %B788
B1026.if:
  %.6030.02588 = phi i64 [ %.6099, %B1026.if ], [ 0, %B1026.if.preheader ]
  %.6099 = add nuw nsw i64 %.6030.02588, 1
  %16 = getelementptr double, ptr %.43.fca.6.4.load, i64 %.6030.02588
  %.6157 = load double, ptr %16, align 8
  %gep2613 = getelementptr double, ptr %invariant.gep2612, i64 %.6030.02588
  store double %.6157, ptr %gep2613, align 8
  %exitcond.not = icmp eq i64 %.810, %.6099
  br i1 %exitcond.not, label %B1106.if.lr.ph, label %B1026.if
B1106.if:
  %.6226.02592 = phi i64 [ %spec.select2580, %B1106.if.lr.ph ], [ %.6288, %B1106.if ]
  %.6223.02591 = phi i64 [ 0, %B1106.if.lr.ph ], [ %.6292, %B1106.if ]
  %.6288 = add nsw i64 %.6226.02592, -1
  %.6292 = add nuw nsw i64 %.6223.02591, 1
  %.6364 = mul i64 %.6223.02591, %.384.i2567
  %gep2594 = getelementptr double, ptr %invariant.gep2593, i64 %.6364
  %.6369 = load double, ptr %gep2594, align 8
  %gep2615 = getelementptr double, ptr %invariant.gep2614, i64 %.6223.02591
  store double %.6369, ptr %gep2615, align 8
  %.6279 = icmp ugt i64 %.6226.02592, 1
  br i1 %.6279, label %B1106.if, label %B1150
B1150.else.if:
  br label %B1150.else.endif
B1150.else.endif:
  %.6450.sroa.0.1 = phi i64 [ 0, %B1150.else.if ], [ %.6462, %B1150 ]
  %.6470.not = icmp slt i64 %.6462, %.5033
  br i1 %.6470.not, label %B1150.else.endif.endif.endif.if, label %B1150.else.endif.if, !prof !106
B1150.else.endif.if:
  br label %B1150.else.endif.endif.endif.if
B1150.else.endif.endif.endif.if:
  %.6450.sroa.0.3 = phi i64 [ %.5033, %B1150.else.endif.if ], [ %.6450.sroa.0.1, %B1150.else.endif ]
  %.6563 = getelementptr double, ptr %.5049, i64 %.6450.sroa.0.3
  %.809.i = load i64, ptr %.1148, align 8, !noalias !107
  %.810.i = icmp sgt i64 %.809.i, 0
  br i1 %.810.i, label %B48.i, label %b90
B48.i:
  %.10121676.not.i = icmp slt i64 %.43.fca.5.0.2.load, 1
  br i1 %.10121676.not.i, label %B144.i, label %B108.if.i.preheader
B108.if.i.preheader:
  %17 = shl nuw i64 %.43.fca.5.0.2.load, 3
  tail call void @llvm.memset.p0.i64(ptr align 8 %.43.fca.5.0.4.load, i8 0, i64 %17, i1 false), !noalias !107
  br label %B144.i
B144.i:
  store double 0.000000e+00, ptr %.43.fca.5.3.4.load, align 8, !noalias !107
  %.1676.i = getelementptr i8, ptr %arg.f.4, i64 88
  %.1677.i = load i64, ptr %.1676.i, align 8, !noalias !107
  %.2093.i = inttoptr i64 %.1677.i to ptr
  tail call void %.2093.i(ptr nonnull %.43.fca.5.3.4.load, ptr %.43.fca.6.4.load, ptr %.43.fca.5.0.4.load, ptr %.43.fca.1.0.4.load, ptr %.6563), !noalias !107
  br label %b90
b90:
  %invariant.gep2598 = getelementptr double, ptr %.43.fca.3.1.4.load, i64 %.5594
  %.69202599.not = icmp slt i64 %.1488, 1
  br i1 %.69202599.not, label %B1412, label %B1242.if.lr.ph
B1242.if.lr.ph:
  %.6962 = icmp sgt i64 %.5594, 0
  %.7031 = shl nsw i64 %.1149, 1
  %.7032 = add nsw i64 %.7031, %.6421
  %.7106 = sub i64 %.1827, %.5594
  %spec.select2581 = tail call i64 @llvm.smax.i64(i64 %.7106, i64 0)
  %.71492595.not = icmp slt i64 %.7106, 1
  br label %B1242.if
B1242.if:
  %.6864.02600 = phi i64 [ 0, %B1242.if.lr.ph ], [ %.6933, %B1242.loopexit ]
  %.6933 = add nuw nsw i64 %.6864.02600, 1
  br i1 %.6962, label %B1258, label %B1306
B1370.if:
  %.7096.02597 = phi i64 [ %spec.select2581, %B1370.if.lr.ph ], [ %.7158, %B1370.if ]
  %.7093.02596 = phi i64 [ %.5594, %B1370.if.lr.ph ], [ %.7162, %B1370.if ]
  %.7158 = add nsw i64 %.7096.02597, -1
  %.7162 = add i64 %.7093.02596, 1
  %.7215 = icmp slt i64 %.7093.02596, 0
  %.7216 = select i1 %.7215, i64 %.43.fca.3.1.5.1.load, i64 0
  %18 = getelementptr double, ptr %15, i64 %.7093.02596
  %.7238 = getelementptr double, ptr %18, i64 %.7216
  store double 0x7FF8000000000000, ptr %.7238, align 8
  %.7149 = icmp sgt i64 %.7096.02597, 1
  br i1 %.7149, label %B1370.if, label %B1242.loopexit
}
define internal fastcc void @v70(ptr noalias nonnull writeonly %retptr, ptr readonly %arg.f.4, i64 %arg.i, i64 %arg.k) unnamed_addr {
entry:
  %.645 = alloca { [5 x i64], { { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, double, double, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, i8 }, { { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] } }, [13 x { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }], { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, align 8
  %.fca.1.0.2.gep = getelementptr inbounds i8, ptr %.645, i64 56
  %.fca.1.0.4.gep = getelementptr inbounds i8, ptr %.645, i64 72
  %.fca.1.0.5.0.gep = getelementptr inbounds i8, ptr %.645, i64 80
  %.fca.1.4.2.gep = getelementptr inbounds i8, ptr %.645, i64 280
  %.fca.1.4.4.gep = getelementptr inbounds i8, ptr %.645, i64 296
  %.fca.2.0.4.gep = getelementptr inbounds i8, ptr %.645, i64 352
  %.fca.2.0.5.1.gep = getelementptr inbounds i8, ptr %.645, i64 368
  %.fca.2.1.4.gep = getelementptr inbounds i8, ptr %.645, i64 424
  %.fca.3.0.0.gep = getelementptr inbounds i8, ptr %.645, i64 528
  %.fca.5.0.2.gep = getelementptr inbounds i8, ptr %.645, i64 872
  %.fca.5.0.4.gep = getelementptr inbounds i8, ptr %.645, i64 888
  %.fca.5.3.4.gep = getelementptr inbounds i8, ptr %.645, i64 1056
  %.fca.6.2.gep3721 = getelementptr inbounds i8, ptr %.645, i64 1600
  %.fca.6.4.gep = getelementptr inbounds i8, ptr %.645, i64 1616
  %.fca.9.4.gep = getelementptr inbounds i8, ptr %.645, i64 1784
  %.352.i = getelementptr i8, ptr %arg.f.4, i64 592
  %.353.i = load i64, ptr %.352.i, align 8, !noalias !110
  %.354.i = inttoptr i64 %.353.i to ptr
  %.692.i = load i64, ptr %arg.f.4, align 8, !noalias !110
  %.99 = icmp slt i64 %arg.i, 0
  %.100 = select i1 %.99, i64 %.692.i, i64 0
  %0 = getelementptr i64, ptr %.354.i, i64 %arg.i
  %.122 = getelementptr i64, ptr %0, i64 %.100
  store i64 %arg.k, ptr %.122, align 8
  %.353.i4267 = load i64, ptr %.352.i, align 8, !noalias !113
  %.354.i4268 = inttoptr i64 %.353.i4267 to ptr
  %.692.i4269 = load i64, ptr %arg.f.4, align 8, !noalias !113
  %.202 = select i1 %.99, i64 %.692.i4269, i64 0
  %1 = getelementptr i64, ptr %.354.i4268, i64 %.692.i4269
  %2 = getelementptr i64, ptr %1, i64 %arg.i
  %.224 = getelementptr i64, ptr %2, i64 %.202
  store i64 -1, ptr %.224, align 8
  %3 = getelementptr i8, ptr %arg.f.4, i64 432
  %.45.i = load i64, ptr %3, align 8, !noalias !116
  %.46.i = inttoptr i64 %.45.i to ptr
  %.384.i = load i64, ptr %arg.f.4, align 8, !noalias !116
  %.613 = select i1 %.99, i64 %.384.i, i64 0
  %.idx = mul i64 %.384.i, 88
  %4 = getelementptr i8, ptr %.46.i, i64 %.idx
  %5 = getelementptr double, ptr %4, i64 %arg.i
  %.635 = getelementptr double, ptr %5, i64 %.613
  store double 0.000000e+00, ptr %.635, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(521) %.645, i8 0, i64 521, i1 false)
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(1280) %.fca.3.0.0.gep, i8 0, i64 1280, i1 false)
  call fastcc void @v73(ptr %.645, ptr nonnull %arg.f.4, i64 %arg.i)
  %.661.fca.1.0.2.load = load i64, ptr %.fca.1.0.2.gep, align 8
  %.661.fca.1.0.4.load = load ptr, ptr %.fca.1.0.4.gep, align 8
  %.661.fca.1.0.5.0.load = load i64, ptr %.fca.1.0.5.0.gep, align 8
  %.661.fca.1.4.2.load = load i64, ptr %.fca.1.4.2.gep, align 8
  %.661.fca.1.4.4.load = load ptr, ptr %.fca.1.4.4.gep, align 8
  %.661.fca.2.0.4.load = load ptr, ptr %.fca.2.0.4.gep, align 8
  %.661.fca.2.0.5.1.load = load i64, ptr %.fca.2.0.5.1.gep, align 8
  %.661.fca.2.1.4.load = load ptr, ptr %.fca.2.1.4.gep, align 8
  %.661.fca.5.0.2.load = load i64, ptr %.fca.5.0.2.gep, align 8
  %.661.fca.5.0.4.load = load ptr, ptr %.fca.5.0.4.gep, align 8
  %.661.fca.5.3.4.load = load ptr, ptr %.fca.5.3.4.gep, align 8
  %.661.fca.6.2.load = load i64, ptr %.fca.6.2.gep3721, align 8
  %.661.fca.6.4.load = load ptr, ptr %.fca.6.4.gep, align 8
  %.661.fca.9.4.load = load ptr, ptr %.fca.9.4.gep, align 8
  %.1425 = getelementptr i8, ptr %arg.f.4, i64 112
  %.1426 = load i64, ptr %.1425, align 8
  %.1764 = getelementptr i8, ptr %arg.f.4, i64 120
  %.1765 = load i64, ptr %.1764, align 8
  %.2103 = getelementptr i8, ptr %arg.f.4, i64 240
  %.2104 = load i64, ptr %.2103, align 8
  %.353.i4286 = getelementptr i8, ptr %arg.f.4, i64 144
  %.45.i4289 = getelementptr i8, ptr %arg.f.4, i64 256
  %.46.i4290 = load i64, ptr %.45.i4289, align 8, !noalias !119
  %.50.i = inttoptr i64 %.46.i4290 to ptr
  %.3712 = icmp sgt i64 %.661.fca.1.0.2.load, 0
  br i1 %.3712, label %B504.if, label %B532
B532:
  %.45.i4291 = getelementptr i8, ptr %arg.f.4, i64 264
  %.46.i4292 = load i64, ptr %.45.i4291, align 8, !noalias !122
  %.50.i4293 = inttoptr i64 %.46.i4292 to ptr
  %.47014414.not = icmp slt i64 %.2104, 1
  br i1 %.47014414.not, label %B764, label %B720.if.lr.ph
B720.if.lr.ph:
  %.4548 = getelementptr i8, ptr %arg.f.4, i64 272
  %.4549 = load i64, ptr %.4548, align 8
  %.4550 = inttoptr i64 %.4549 to ptr
  %arg.k.lobit = lshr i64 %arg.k, 63
  %.4766 = add i64 %arg.k.lobit, %arg.k
  %.4786 = mul i64 %.2104, %.4766
  %6 = getelementptr double, ptr %.4550, i64 %.4786
  br label %B720.if
B764:
  %.5208 = getelementptr i8, ptr %arg.f.4, i64 280
  %.5209 = load i64, ptr %.5208, align 8
  %.5210 = inttoptr i64 %.5209 to ptr
  %.5955 = getelementptr i8, ptr %arg.f.4, i64 304
  %.5956 = load i64, ptr %.5955, align 8
  %.5957 = inttoptr i64 %.5956 to ptr
  %.6295 = getelementptr i8, ptr %arg.f.4, i64 128
  %.6296 = load i64, ptr %.6295, align 8
  %.6699 = getelementptr i8, ptr %arg.f.4, i64 248
  %.6700 = load i64, ptr %.6699, align 8
  %.67804420.not = icmp slt i64 %.6700, 1
  br i1 %.67804420.not, label %B1214, label %B1100.if.lr.ph
B1100.if.lr.ph:
  %.5595 = getelementptr i8, ptr %arg.f.4, i64 216
  %.5596 = load i64, ptr %.5595, align 8
  %.69014417.not = icmp slt i64 %.5596, 1
  %.7026 = mul nsw i64 %.5596, %arg.i
  %.7148 = mul i64 %.6296, 7
  br label %B1100.if
B1100.loopexit:
  %exitcond4447.not = icmp eq i64 %.6793, %.6700
  br i1 %exitcond4447.not, label %B1214, label %B1100.if
B1214:
  %.7525 = getelementptr i8, ptr %arg.f.4, i64 80
  %.7526 = load i64, ptr %.7525, align 8
  %.7552 = inttoptr i64 %.7526 to ptr
  tail call void %.7552(ptr %.661.fca.1.0.4.load, ptr %.661.fca.6.4.load, ptr %.661.fca.1.4.4.load)
  %.76434423.not = icmp slt i64 %.661.fca.1.4.2.load, 1
  br i1 %.76434423.not, label %B1398, label %B1332.if
B1398:
  %.384.i.i = load i64, ptr %arg.f.4, align 8, !noalias !125
  br i1 %.3712, label %B76.if.lr.ph.i, label %b91
B76.if.lr.ph.i:
  %7 = getelementptr i8, ptr %arg.f.4, i64 480
  %.45.i.i = load i64, ptr %7, align 8, !noalias !125
  %.46.i.i = inttoptr i64 %.45.i.i to ptr
  %invariant.gep.i = getelementptr double, ptr %.46.i.i, i64 %arg.i
  %.272.i = select i1 %.99, i64 %.384.i.i, i64 0
  %invariant.gep120.i = getelementptr double, ptr %invariant.gep.i, i64 %.272.i
  br label %B76.if.i
B76.if.i:
  %.119.0118.i = phi i64 [ 0, %B76.if.lr.ph.i ], [ %.188.i, %B76.if.i ]
  %.188.i = add nuw nsw i64 %.119.0118.i, 1
  %8 = getelementptr double, ptr %.661.fca.1.0.4.load, i64 %.119.0118.i
  %.242.i = load double, ptr %8, align 8, !noalias !130
  %.290.i = mul i64 %.119.0118.i, %.384.i.i
  %gep121.i = getelementptr double, ptr %invariant.gep120.i, i64 %.290.i
  store double %.242.i, ptr %gep121.i, align 8, !noalias !130
  %exitcond.not.i = icmp eq i64 %.188.i, %.661.fca.1.0.2.load
  br i1 %exitcond.not.i, label %b92, label %B76.if.i
b92:
  %.9787.pre = load i64, ptr %arg.f.4, align 8
  br label %b91
b91:
  %.9787 = phi i64 [ %.9787.pre, %b92 ], [ %.384.i.i, %B1398 ]
  %.8769 = getelementptr i8, ptr %arg.f.4, i64 24
  %.8770 = load i64, ptr %.8769, align 8
  %.9108 = getelementptr i8, ptr %arg.f.4, i64 480
  %.9109 = load i64, ptr %.9108, align 8
  %.9788 = shl i64 %.661.fca.1.0.2.load, 3
  %.9801 = mul i64 %.9788, %.9787
  %.9802 = add nsw i64 %.9801, %.9109
  %.9803 = inttoptr i64 %.8770 to ptr
  tail call void %.9803(i64 %.9109, i64 %.9802)
  %.384.i.i4311 = load i64, ptr %arg.f.4, align 8, !noalias !131
  %.175117.not.i4312 = icmp slt i64 %.661.fca.6.2.load, 1
  br i1 %.175117.not.i4312, label %b93, label %B76.if.lr.ph.i4313
B76.if.lr.ph.i4313:
  %9 = getelementptr i8, ptr %arg.f.4, i64 448
  %.45.i.i4314 = load i64, ptr %9, align 8, !noalias !131
  %.46.i.i4315 = inttoptr i64 %.45.i.i4314 to ptr
  %invariant.gep.i4316 = getelementptr double, ptr %.46.i.i4315, i64 %arg.i
  %.272.i4318 = select i1 %.99, i64 %.384.i.i4311, i64 0
  %invariant.gep120.i4319 = getelementptr double, ptr %invariant.gep.i4316, i64 %.272.i4318
  br label %B76.if.i4320
B76.if.i4320:
  %.119.0118.i4321 = phi i64 [ 0, %B76.if.lr.ph.i4313 ], [ %.188.i4322, %B76.if.i4320 ]
  %.188.i4322 = add nuw nsw i64 %.119.0118.i4321, 1
  %10 = getelementptr double, ptr %.661.fca.6.4.load, i64 %.119.0118.i4321
  %.242.i4323 = load double, ptr %10, align 8, !noalias !136
  %.290.i4324 = mul i64 %.119.0118.i4321, %.384.i.i4311
  %gep121.i4325 = getelementptr double, ptr %invariant.gep120.i4319, i64 %.290.i4324
  store double %.242.i4323, ptr %gep121.i4325, align 8, !noalias !136
  %exitcond.not.i4326 = icmp eq i64 %.188.i4322, %.661.fca.6.2.load
  br i1 %exitcond.not.i4326, label %b93, label %B76.if.i4320
b93:
  %.10883 = getelementptr i8, ptr %arg.f.4, i64 184
  %.10884 = load i64, ptr %.10883, align 8
  %.10885 = inttoptr i64 %.10884 to ptr
  %.193303.not.i = icmp slt i64 %.1765, 1
  br i1 %.193303.not.i, label %B2204, label %B56.if.lr.ph.i
B56.if.lr.ph.i:
  %.45.i4328 = getelementptr i8, ptr %arg.f.4, i64 336
  %.46.i4329 = load i64, ptr %.45.i4328, align 8, !noalias !137
  %.50.i4330 = inttoptr i64 %.46.i4329 to ptr
  %.10528 = getelementptr i8, ptr %.50.i4330, i64 24
  %.10529 = load double, ptr %.10528, align 8
  %.idx.i = shl i64 %.1765, 4
  %11 = getelementptr i8, ptr %.10885, i64 %.idx.i
  %.383.i = fmul double %.10529, 2.500000e-01
  %12 = getelementptr double, ptr %.10885, i64 %.1765
  %13 = getelementptr double, ptr %.661.fca.2.0.4.load, i64 %.661.fca.2.0.5.1.load
  %.idx302.i = shl i64 %.661.fca.2.0.5.1.load, 4
  %14 = getelementptr i8, ptr %.661.fca.2.0.4.load, i64 %.idx302.i
  br label %B56.if.i
B140.i:
  %.265.i = tail call double @llvm.fabs.f64(double %.264.i)
  br label %B162.i
B144.i:
  %15 = getelementptr double, ptr %11, i64 %.135.0304.i
  %.375.i = load double, ptr %15, align 8, !noalias !140
  br label %B162.i
B162.i:
  %"$phi162.1.2.1.i" = phi double [ %.265.i, %B140.i ], [ %.375.i, %B144.i ]
  %.437.i = getelementptr double, ptr %.10885, i64 %.135.0304.i
  %.438.i = load double, ptr %.437.i, align 8, !noalias !140
  %.439.i = fmul double %.383.i, %.438.i
  %.499.i = getelementptr double, ptr %.661.fca.2.0.4.load, i64 %.135.0304.i
  store double %.439.i, ptr %.499.i, align 8, !noalias !140
  %.625.i = getelementptr double, ptr %12, i64 %.135.0304.i
  %.626.i = load double, ptr %.625.i, align 8, !noalias !140
  %.627.i = fmul double %.439.i, %.626.i
  %.628.i = fmul double %"$phi162.1.2.1.i", %.627.i
  %.688.i = getelementptr double, ptr %13, i64 %.135.0304.i
  store double %.628.i, ptr %.688.i, align 8, !noalias !140
  %.756.i = getelementptr double, ptr %14, i64 %.135.0304.i
  store double %"$phi162.1.2.1.i", ptr %.756.i, align 8, !noalias !140
  %exitcond.not.i4344 = icmp eq i64 %.206.i, %.1765
  br i1 %exitcond.not.i4344, label %B2100.preheader, label %B56.if.i
B56.if.i:
  %.135.0304.i = phi i64 [ 0, %B56.if.lr.ph.i ], [ %.206.i, %B162.i ]
  %.206.i = add nuw nsw i64 %.135.0304.i, 1
  %16 = getelementptr double, ptr %.661.fca.6.4.load, i64 %.135.0304.i
  %.264.i = load double, ptr %16, align 8, !noalias !140
  %17 = getelementptr i8, ptr %.661.fca.2.1.4.load, i64 %.135.0304.i
  %.303.i = load i8, ptr %17, align 1, !noalias !140
  %.307.i = icmp ne i8 %.303.i, 0
  %.310.i = fcmp one double %.264.i, 0.000000e+00
  %or.cond.i = select i1 %.307.i, i1 %.310.i, i1 false
  br i1 %or.cond.i, label %B140.i, label %B144.i
B2100.preheader:
  %.384.i43474401.ph = load i64, ptr %arg.f.4, align 8, !noalias !143
  %.46.i43574403.ph.in.in = getelementptr i8, ptr %arg.f.4, i64 560
  %.46.i43574403.ph.in = load i64, ptr %.46.i43574403.ph.in.in, align 8, !noalias !143
  %.46.i43574403.ph = inttoptr i64 %.46.i43574403.ph.in to ptr
  %invariant.gep = getelementptr double, ptr %.46.i43574403.ph, i64 %arg.i
  %.46.i43464399.ph.in.in = getelementptr i8, ptr %arg.f.4, i64 552
  %.46.i43464399.ph.in = load i64, ptr %.46.i43464399.ph.in.in, align 8, !noalias !143
  %.46.i43464399.ph = inttoptr i64 %.46.i43464399.ph.in to ptr
  %18 = getelementptr double, ptr %.661.fca.2.0.4.load, i64 %.661.fca.2.0.5.1.load
  %.idx4264 = shl i64 %.661.fca.2.0.5.1.load, 4
  %19 = getelementptr i8, ptr %.661.fca.2.0.4.load, i64 %.idx4264
  %.12084 = select i1 %.99, i64 %.384.i43474401.ph, i64 0
  %20 = getelementptr double, ptr %.46.i43464399.ph, i64 %.12084
  %invariant.gep4429 = getelementptr double, ptr %20, i64 %arg.i
  %invariant.gep4433 = getelementptr double, ptr %invariant.gep, i64 %.12084
  br label %B2100.if
B2204:
  %.12561 = add nsw i64 %arg.k, 1
  %.12899 = getelementptr i8, ptr %arg.f.4, i64 368
  %.12900 = load i64, ptr %.12899, align 8
  %.12901 = mul nsw i64 %.12900, %.12561
  %.45.i4367 = getelementptr i8, ptr %arg.f.4, i64 360
  %.46.i4368 = load i64, ptr %.45.i4367, align 8, !noalias !144
  %.50.i4369 = inttoptr i64 %.46.i4368 to ptr
  %.13280 = mul nsw i64 %.12900, %arg.k
  %.13318 = icmp slt i64 %.13280, 0
  %.13319 = select i1 %.13318, i64 %.12901, i64 0
  %.13320 = add i64 %.13319, %.13280
  %.13323 = icmp slt i64 %.13320, 0
  br i1 %.13323, label %B2204.endif.else.if, label %B2204.endif.else.endif, !prof !81
B2658:
  %.14812 = getelementptr i8, ptr %.661.fca.9.4.load, i64 24
  store i64 -1, ptr %.14812, align 8
  store ptr null, ptr %retptr, align 8
  ret void
B504.if:
  %.3698.04413 = phi i64 [ %.3767, %B504.if ], [ 0, %entry ]
  %.3767 = add nuw nsw i64 %.3698.04413, 1
  %21 = getelementptr double, ptr %.50.i, i64 %.3698.04413
  %.3821 = load double, ptr %21, align 8
  %22 = getelementptr double, ptr %.661.fca.1.0.4.load, i64 %.3698.04413
  store double %.3821, ptr %22, align 8
  %exitcond.not = icmp eq i64 %.661.fca.1.0.2.load, %.3767
  br i1 %exitcond.not, label %B532, label %B504.if
B720.if:
  %.4645.04415 = phi i64 [ 0, %B720.if.lr.ph ], [ %.4714, %B720.if ]
  %.4714 = add nuw nsw i64 %.4645.04415, 1
  %23 = getelementptr double, ptr %6, i64 %.4645.04415
  %.4791 = load double, ptr %23, align 8
  %24 = getelementptr i64, ptr %.50.i4293, i64 %.4645.04415
  %.4823 = load i64, ptr %24, align 8
  %.4837 = icmp slt i64 %.4823, 0
  %.4838 = select i1 %.4837, i64 %.661.fca.1.0.5.0.load, i64 0
  %25 = getelementptr double, ptr %.661.fca.1.0.4.load, i64 %.4823
  %.4852 = getelementptr double, ptr %25, i64 %.4838
  store double %.4791, ptr %.4852, align 8
  %exitcond4445.not = icmp eq i64 %.4714, %.2104
  br i1 %exitcond4445.not, label %B764, label %B720.if
B1100.if:
  %.6724.04421 = phi i64 [ 0, %B1100.if.lr.ph ], [ %.6793, %B1100.loopexit ]
  %.6793 = add nuw nsw i64 %.6724.04421, 1
  br i1 %.69014417.not, label %B1100.loopexit, label %B1134.if.lr.ph
B1134.if.lr.ph:
  %.idx4410 = shl i64 %.6724.04421, 4
  %26 = getelementptr i8, ptr %.5210, i64 %.idx4410
  %.6992 = getelementptr i8, ptr %26, i64 8
  br label %B1134.if
B1134.if:
  %.6845.04418 = phi i64 [ 0, %B1134.if.lr.ph ], [ %.6914, %B1134.if ]
  %.6914 = add nuw nsw i64 %.6845.04418, 1
  %.6993 = load i64, ptr %.6992, align 8
  %.7007 = icmp slt i64 %.6993, 0
  %.7008 = select i1 %.7007, i64 %.661.fca.1.0.5.0.load, i64 0
  %27 = getelementptr double, ptr %.661.fca.1.0.4.load, i64 %.6993
  %.7022 = getelementptr double, ptr %27, i64 %.7008
  %.7023 = load double, ptr %.7022, align 8
  %.7027 = add nsw i64 %.6845.04418, %.7026
  %.7082 = load i64, ptr %26, align 8
  %.7027.lobit = lshr i64 %.7027, 63
  %.7120 = add i64 %.7027.lobit, %.7027
  %.7121 = icmp slt i64 %.7082, 0
  %.7122 = select i1 %.7121, i64 %.6296, i64 0
  %.7123 = add i64 %.7122, %.7082
  %.7150 = mul i64 %.7148, %.7120
  %28 = getelementptr double, ptr %.5957, i64 %.7150
  %.7156.idx = mul i64 %.7123, 56
  %.7156 = getelementptr i8, ptr %28, i64 %.7156.idx
  store double %.7023, ptr %.7156, align 8
  %exitcond4446.not = icmp eq i64 %.5596, %.6914
  br i1 %exitcond4446.not, label %B1100.loopexit, label %B1134.if
B1332.if:
  %.7587.04424 = phi i64 [ %.7656, %B1332.if ], [ 0, %B1214 ]
  %.7656 = add nuw nsw i64 %.7587.04424, 1
  %29 = getelementptr double, ptr %.661.fca.1.4.4.load, i64 %.7587.04424
  %.7710 = load double, ptr %29, align 8
  %.8049 = load i64, ptr %.353.i4286, align 8
  %.8050 = add nsw i64 %.8049, %.7587.04424
  %.8064 = icmp slt i64 %.8050, 0
  %.8065 = select i1 %.8064, i64 %.661.fca.1.0.5.0.load, i64 0
  %30 = getelementptr double, ptr %.661.fca.1.0.4.load, i64 %.8050
  %.8079 = getelementptr double, ptr %30, i64 %.8065
  store double %.7710, ptr %.8079, align 8
  %exitcond4448.not = icmp eq i64 %.661.fca.1.4.2.load, %.7656
  br i1 %exitcond4448.not, label %B1398, label %B1332.if
B2100.if:
  %.11799.04427 = phi i64 [ 0, %B2100.preheader ], [ %.11868, %B2100.if ]
  %.11868 = add nuw nsw i64 %.11799.04427, 1
  %.11945 = getelementptr double, ptr %.661.fca.2.0.4.load, i64 %.11799.04427
  %.11946 = load double, ptr %.11945, align 8
  %.11999 = getelementptr double, ptr %18, i64 %.11799.04427
  %.12000 = load double, ptr %.11999, align 8
  %.12053 = getelementptr double, ptr %19, i64 %.11799.04427
  %.12054 = load double, ptr %.12053, align 8
  %.12102 = mul i64 %.11799.04427, %.384.i43474401.ph
  %gep4430 = getelementptr double, ptr %invariant.gep4429, i64 %.12102
  store double %.11946, ptr %gep4430, align 8
  %.12111 = add nuw nsw i64 %.11799.04427, %.1765
  %.12159 = mul i64 %.12111, %.384.i43474401.ph
  %gep4432 = getelementptr double, ptr %invariant.gep4429, i64 %.12159
  store double %.12000, ptr %gep4432, align 8
  %gep4434 = getelementptr double, ptr %invariant.gep4433, i64 %.12102
  store double %.12054, ptr %gep4434, align 8
  %exitcond4449.not = icmp eq i64 %.11868, %.1765
  br i1 %exitcond4449.not, label %B2204, label %B2100.if
B2204.endif.else.if:
  br label %B2204.endif.else.endif
B2204.endif.else.endif:
  %.13308.sroa.0.1 = phi i64 [ 0, %B2204.endif.else.if ], [ %.13320, %B2204 ]
  %.13328.not = icmp slt i64 %.13320, %.12901
  br i1 %.13328.not, label %B2204.endif.else.endif.endif.endif.if, label %B2204.endif.else.endif.if, !prof !106
B2204.endif.else.endif.if:
  br label %B2204.endif.else.endif.endif.endif.if
B2204.endif.else.endif.endif.endif.if:
  %.13308.sroa.0.3 = phi i64 [ %.12901, %B2204.endif.else.endif.if ], [ %.13308.sroa.0.1, %B2204.endif.else.endif ]
  %.13396 = sub i64 %.12901, %.13308.sroa.0.3
  %.13405 = tail call i64 @llvm.smax.i64(i64 %.13396, i64 0)
  %.13421 = getelementptr double, ptr %.50.i4369, i64 %.13308.sroa.0.3
  %.384.i4377 = load i64, ptr %arg.f.4, align 8, !noalias !147
  %.139084435.not = icmp slt i64 %.1426, 1
  br i1 %.139084435.not, label %B2536.else, label %B2438.if.lr.ph
B2438.if.lr.ph:
  %31 = getelementptr i8, ptr %arg.f.4, i64 576
  %.45.i4375 = load i64, ptr %31, align 8, !noalias !147
  %.46.i4376 = inttoptr i64 %.45.i4375 to ptr
  %.14042 = select i1 %.99, i64 %.384.i4377, i64 0
  %32 = getelementptr double, ptr %.46.i4376, i64 %.14042
  %invariant.gep4438 = getelementptr double, ptr %32, i64 %arg.i
  %.14126 = shl nuw nsw i64 %.1426, 1
  br label %B2438.if
B2438.if:
  %.13852.04436 = phi i64 [ 0, %B2438.if.lr.ph ], [ %.13921, %B2438.if ]
  %.13921 = add nuw nsw i64 %.13852.04436, 1
  %33 = getelementptr double, ptr %.661.fca.6.4.load, i64 %.13852.04436
  %.13979 = load double, ptr %33, align 8
  %34 = getelementptr double, ptr %.13421, i64 %.13852.04436
  store double %.13979, ptr %34, align 8
  %.14060 = mul i64 %.13852.04436, %.384.i4377
  %gep = getelementptr double, ptr %invariant.gep4438, i64 %.14060
  store double %.13979, ptr %gep, align 8
  %.14069 = add nuw nsw i64 %.13852.04436, %.1426
  %.14117 = mul i64 %.14069, %.384.i4377
  %gep4440 = getelementptr double, ptr %invariant.gep4438, i64 %.14117
  store double %.13979, ptr %gep4440, align 8
  %.14127 = add nuw nsw i64 %.13852.04436, %.14126
  %.14175 = mul i64 %.14127, %.384.i4377
  %gep4442 = getelementptr double, ptr %invariant.gep4438, i64 %.14175
  store double 0.000000e+00, ptr %gep4442, align 8
  %exitcond4450.not = icmp eq i64 %.13921, %.1426
  br i1 %exitcond4450.not, label %B2536.else, label %B2438.if
B2536.else:
  %.14199 = mul nsw i64 %.1426, 5
  %.14238 = icmp slt i64 %.1426, 0
  %.14239 = select i1 %.14238, i64 %.13405, i64 0
  %.14240 = add i64 %.14239, %.14199
  %.14243 = icmp slt i64 %.14240, 0
  br i1 %.14243, label %B2536.else.if, label %B2536.else.endif, !prof !81
B2536.else.if:
  br label %B2536.else.endif
B2536.else.endif:
  %.14228.sroa.0.1 = phi i64 [ 0, %B2536.else.if ], [ %.14240, %B2536.else ]
  %.14248.not = icmp slt i64 %.14240, %.13405
  br i1 %.14248.not, label %B2536.else.endif.endif.endif.if, label %B2536.else.endif.if, !prof !106
B2536.else.endif.if:
  br label %B2536.else.endif.endif.endif.if
B2536.else.endif.endif.endif.if:
  %.14228.sroa.0.3 = phi i64 [ %.13405, %B2536.else.endif.if ], [ %.14228.sroa.0.1, %B2536.else.endif ]
  %.14341 = getelementptr double, ptr %.13421, i64 %.14228.sroa.0.3
  %.808.i = getelementptr i8, ptr %arg.f.4, i64 168
  %.809.i = load i64, ptr %.808.i, align 8, !noalias !150
  %.810.i = icmp sgt i64 %.809.i, 0
  br i1 %.810.i, label %B48.i, label %B2632.if.preheader
B48.i:
  %.10121676.not.i = icmp slt i64 %.661.fca.5.0.2.load, 1
  br i1 %.10121676.not.i, label %B144.i4387, label %B108.if.i.preheader
B108.if.i.preheader:
  %35 = shl nuw i64 %.661.fca.5.0.2.load, 3
  tail call void @llvm.memset.p0.i64(ptr align 8 %.661.fca.5.0.4.load, i8 0, i64 %35, i1 false), !noalias !150
  br label %B144.i4387
B144.i4387:
  store double 0.000000e+00, ptr %.661.fca.5.3.4.load, align 8, !noalias !150
  %.1676.i = getelementptr i8, ptr %arg.f.4, i64 88
  %.1677.i = load i64, ptr %.1676.i, align 8, !noalias !150
  %.2093.i = inttoptr i64 %.1677.i to ptr
  tail call void %.2093.i(ptr nonnull %.661.fca.5.3.4.load, ptr %.661.fca.6.4.load, ptr %.661.fca.5.0.4.load, ptr %.661.fca.1.0.4.load, ptr %.14341), !noalias !150
  br label %B2632.if.preheader
B2632.if.preheader:
  br label %B2632.if
B2632.if:
  %.14526.04443 = phi i64 [ %.14595, %B2632.if ], [ 0, %B2632.if.preheader ]
  %.14595 = add nuw nsw i64 %.14526.04443, 1
  %36 = getelementptr i64, ptr %.661.fca.9.4.load, i64 %.14526.04443
  store i64 0, ptr %36, align 8
  %exitcond4451.not = icmp eq i64 %.14595, 5
  br i1 %exitcond4451.not, label %B2658, label %B2632.if
}
define internal fastcc void @v73(ptr noalias nonnull writeonly initializes((0, 1808)) %retptr, ptr readonly %arg.f.4, i64 %arg.i) unnamed_addr {
entry:
  %.353 = getelementptr i8, ptr %arg.f.4, i64 112
  %.354 = load i64, ptr %.353, align 8
  %.691 = getelementptr i8, ptr %arg.f.4, i64 120
  %.692 = load i64, ptr %.691, align 8
  %.1029 = getelementptr i8, ptr %arg.f.4, i64 128
  %.1030 = load i64, ptr %.1029, align 8
  %.1367 = getelementptr i8, ptr %arg.f.4, i64 152
  %.1368 = load i64, ptr %.1367, align 8
  %.1705 = getelementptr i8, ptr %arg.f.4, i64 136
  %.1706 = load i64, ptr %.1705, align 8
  %.352.i = getelementptr i8, ptr %arg.f.4, i64 592
  %.353.i = load i64, ptr %.352.i, align 8, !noalias !153
  %.354.i = inttoptr i64 %.353.i to ptr
  %.692.i = load i64, ptr %arg.f.4, align 8, !noalias !153
  %.1809 = icmp slt i64 %arg.i, 0
  %.1810 = select i1 %.1809, i64 %.692.i, i64 0
  %0 = getelementptr i64, ptr %.354.i, i64 %arg.i
  %.1832 = getelementptr i64, ptr %0, i64 %.1810
  %.1833 = load i64, ptr %.1832, align 8
  %.2175 = getelementptr i8, ptr %arg.f.4, i64 608
  %.2176 = load i64, ptr %.2175, align 8
  %.353.i1658 = getelementptr i8, ptr %arg.f.4, i64 144
  %.354.i1659 = load i64, ptr %.353.i1658, align 8, !noalias !156
  %.693.i = add nsw i64 %.354.i1659, %.1368
  %.1030.i = getelementptr i8, ptr %arg.f.4, i64 600
  %.1031.i = load i64, ptr %.1030.i, align 8, !noalias !156
  %.2216 = mul nsw i64 %.354, 6
  %.2217 = shl nsw i64 %.1030, 1
  %.2218 = add nsw i64 %.2217, %.2216
  %.2695 = getelementptr i8, ptr %arg.f.4, i64 160
  %.2696 = load i64, ptr %.2695, align 8
  %.2838 = icmp slt i64 %.2218, 1
  br i1 %.2838, label %B0.endif.endif.endif.endi...endif.endif.if, label %B0.endif.endif.endif.endif.endif.endif.endif.endif, !prof !81
B0.endif.endif.endif.endif.endif.endif.endif.endif:
  %.2818.sroa.0.31750 = phi i64 [ %.2218, %B0.endif.endif.endif.endi...endif.endif.if ], [ 0, %entry ]
  %.45.i = getelementptr i8, ptr %arg.f.4, i64 336
  %.46.i = load i64, ptr %.45.i, align 8, !noalias !159
  %.50.i = inttoptr i64 %.46.i to ptr
  %.3646 = getelementptr i8, ptr %arg.f.4, i64 232
  %.3647 = load i64, ptr %.3646, align 8
  %.3662 = add nsw i64 %.1030, %.2216
  %.3698 = icmp slt i64 %.354, 0
  %.3699 = select i1 %.3698, i64 %.2218, i64 0
  %.3700 = add i64 %.3699, %.2216
  %.3703 = icmp slt i64 %.3700, 0
  br i1 %.3703, label %B0.endif.endif.endif.endi...else.if, label %B0.endif.endif.endif.endi...else.endif, !prof !81
B0.endif.endif.endif.endi...endif.endif.if:
  br label %B0.endif.endif.endif.endif.endif.endif.endif.endif
B0.endif.endif.endif.endi...endif.3:
  %.3688.sroa.13.0 = phi i64 [ %.2218, %B0.endif.endif.endif.endi...else.endif.endif.endif.if ], [ %.3688.sroa.13.1, %B0.endif.endif.endif.endi...else.endif.endif.endif ]
  br i1 %.3720, label %B0.endif.endif.endif.endi...endif.3.else.if, label %B0.endif.endif.endif.endi...endif.3.else.endif, !prof !81
B0.endif.endif.endif.endi...else.if:
  br label %B0.endif.endif.endif.endi...else.endif
B0.endif.endif.endif.endi...else.endif:
  %.3688.sroa.0.1 = phi i64 [ 0, %B0.endif.endif.endif.endi...else.if ], [ %.3700, %B0.endif.endif.endif.endif.endif.endif.endif.endif ]
  %.3708.not = icmp slt i64 %.3700, %.2218
  br i1 %.3708.not, label %B0.endif.endif.endif.endi...else.endif.endif, label %B0.endif.endif.endif.endi...else.endif.if, !prof !106
B0.endif.endif.endif.endi...else.endif.if:
  br label %B0.endif.endif.endif.endi...else.endif.endif
B0.endif.endif.endif.endi...else.endif.endif:
  %.3688.sroa.0.3 = phi i64 [ %.2218, %B0.endif.endif.endif.endi...else.endif.if ], [ %.3688.sroa.0.1, %B0.endif.endif.endif.endi...else.endif ]
  %.3715 = icmp slt i64 %.3662, 0
  %.3716 = select i1 %.3715, i64 %.2218, i64 0
  %.3717 = add i64 %.3716, %.3662
  %.3720 = icmp slt i64 %.3717, 0
  br i1 %.3720, label %B0.endif.endif.endif.endi...else.endif.endif.if, label %B0.endif.endif.endif.endi...else.endif.endif.endif, !prof !81
B0.endif.endif.endif.endi...else.endif.endif.if:
  br label %B0.endif.endif.endif.endi...else.endif.endif.endif
B0.endif.endif.endif.endi...else.endif.endif.endif:
  %.3688.sroa.13.1 = phi i64 [ 0, %B0.endif.endif.endif.endi...else.endif.endif.if ], [ %.3717, %B0.endif.endif.endif.endi...else.endif.endif ]
  %.3725.not = icmp slt i64 %.3717, %.2218
  br i1 %.3725.not, label %B0.endif.endif.endif.endi...endif.3, label %B0.endif.endif.endif.endi...else.endif.endif.endif.if, !prof !106
B0.endif.endif.endif.endi...else.endif.endif.endif.if:
  br label %B0.endif.endif.endif.endi...endif.3
B0.endif.endif.endif.endi...endif.3.else.if:
  br label %B0.endif.endif.endif.endi...endif.3.else.endif
B0.endif.endif.endif.endi...endif.3.else.endif:
  %.3860.sroa.0.1 = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.3.else.if ], [ %.3717, %B0.endif.endif.endif.endi...endif.3 ]
  br i1 %.3725.not, label %B0.endif.endif.endif.endi...endif.4.if, label %B0.endif.endif.endif.endi...endif.3.else.endif.if, !prof !106
B0.endif.endif.endif.endi...endif.3.else.endif.if:
  br label %B0.endif.endif.endif.endi...endif.4.if
B0.endif.endif.endif.endi...endif.4.if:
  %.3860.sroa.0.3 = phi i64 [ %.2218, %B0.endif.endif.endif.endi...endif.3.else.endif.if ], [ %.3860.sroa.0.1, %B0.endif.endif.endif.endi...endif.3.else.endif ]
  br i1 %.2838, label %B0.endif.endif.endif.endi...if.6, label %B0.endif.endif.endif.endi...endif.6, !prof !81
B0.endif.endif.endif.endi...endif.3.endif.endif:
  %.4030.sroa.13.0 = phi i64 [ %.2218, %B0.endif.endif.endif.endi...endif.6.endif.if ], [ %.4030.sroa.13.1, %B0.endif.endif.endif.endi...endif.6.endif ]
  %.4175 = shl nsw i64 %.354, 1
  br i1 %.4062, label %B0.endif.endif.endif.endi...if.8, label %B0.endif.endif.endif.endi...endif.8, !prof !81
B0.endif.endif.endif.endi...if.6:
  br label %B0.endif.endif.endif.endi...endif.6
B0.endif.endif.endif.endi...endif.6:
  %.4030.sroa.0.3 = phi i64 [ %.2218, %B0.endif.endif.endif.endi...if.6 ], [ 0, %B0.endif.endif.endif.endi...endif.4.if ]
  %.4059 = add i64 %.3699, %.354
  %.4062 = icmp slt i64 %.4059, 0
  br i1 %.4062, label %B0.endif.endif.endif.endi...endif.6.if, label %B0.endif.endif.endif.endi...endif.6.endif, !prof !81
B0.endif.endif.endif.endi...endif.6.if:
  br label %B0.endif.endif.endif.endi...endif.6.endif
B0.endif.endif.endif.endi...endif.6.endif:
  %.4030.sroa.13.1 = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.6.if ], [ %.4059, %B0.endif.endif.endif.endi...endif.6 ]
  %.4067.not = icmp slt i64 %.4059, %.2218
  br i1 %.4067.not, label %B0.endif.endif.endif.endi...endif.3.endif.endif, label %B0.endif.endif.endif.endi...endif.6.endif.if, !prof !106
B0.endif.endif.endif.endi...endif.6.endif.if:
  br label %B0.endif.endif.endif.endi...endif.3.endif.endif
B0.endif.endif.endif.endi...endif.3.endif.endif.endif:
  %.4201.sroa.13.0 = phi i64 [ %.2218, %B0.endif.endif.endif.endi...endif.8.endif.endif.if ], [ %.4201.sroa.13.1, %B0.endif.endif.endif.endi...endif.8.endif.endif ]
  %.4347 = shl nsw i64 %.354, 2
  br i1 %.4233, label %B0.endif.endif.endif.endi...else.1.if, label %B0.endif.endif.endif.endi...else.1.endif, !prof !81
B0.endif.endif.endif.endi...if.8:
  br label %B0.endif.endif.endif.endi...endif.8
B0.endif.endif.endif.endi...endif.8:
  %.4201.sroa.0.1 = phi i64 [ 0, %B0.endif.endif.endif.endi...if.8 ], [ %.4059, %B0.endif.endif.endif.endi...endif.3.endif.endif ]
  br i1 %.4067.not, label %B0.endif.endif.endif.endi...endif.8.endif, label %B0.endif.endif.endif.endi...endif.8.if, !prof !106
B0.endif.endif.endif.endi...endif.8.if:
  br label %B0.endif.endif.endif.endi...endif.8.endif
B0.endif.endif.endif.endi...endif.8.endif:
  %.4201.sroa.0.3 = phi i64 [ %.2218, %B0.endif.endif.endif.endi...endif.8.if ], [ %.4201.sroa.0.1, %B0.endif.endif.endif.endi...endif.8 ]
  %.4230 = add i64 %.3699, %.4175
  %.4233 = icmp slt i64 %.4230, 0
  br i1 %.4233, label %B0.endif.endif.endif.endi...endif.8.endif.if, label %B0.endif.endif.endif.endi...endif.8.endif.endif, !prof !81
B0.endif.endif.endif.endi...endif.8.endif.if:
  br label %B0.endif.endif.endif.endi...endif.8.endif.endif
B0.endif.endif.endif.endi...endif.8.endif.endif:
  %.4201.sroa.13.1 = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.8.endif.if ], [ %.4230, %B0.endif.endif.endif.endi...endif.8.endif ]
  %.4238.not = icmp slt i64 %.4230, %.2218
  br i1 %.4238.not, label %B0.endif.endif.endif.endi...endif.3.endif.endif.endif, label %B0.endif.endif.endif.endi...endif.8.endif.endif.if, !prof !106
B0.endif.endif.endif.endi...endif.8.endif.endif.if:
  br label %B0.endif.endif.endif.endi...endif.3.endif.endif.endif
B0.endif.endif.endif.endi...endif.10:
  %.4373.sroa.13.0 = phi i64 [ %.2218, %B0.endif.endif.endif.endi...if.11 ], [ %.4373.sroa.13.1, %B0.endif.endif.endif.endi...else.1.endif.endif.endif ]
  %.4519 = mul nsw i64 %.354, 5
  br i1 %.4405, label %B0.endif.endif.endif.endi...endif.10.else.if, label %B0.endif.endif.endif.endi...endif.10.else.endif, !prof !81
B0.endif.endif.endif.endi...else.1.if:
  br label %B0.endif.endif.endif.endi...else.1.endif
B0.endif.endif.endif.endi...else.1.endif:
  %.4373.sroa.0.1 = phi i64 [ 0, %B0.endif.endif.endif.endi...else.1.if ], [ %.4230, %B0.endif.endif.endif.endi...endif.3.endif.endif.endif ]
  br i1 %.4238.not, label %B0.endif.endif.endif.endi...else.1.endif.endif, label %B0.endif.endif.endif.endi...else.1.endif.if, !prof !106
B0.endif.endif.endif.endi...else.1.endif.if:
  br label %B0.endif.endif.endif.endi...else.1.endif.endif
B0.endif.endif.endif.endi...else.1.endif.endif:
  %.4373.sroa.0.3 = phi i64 [ %.2218, %B0.endif.endif.endif.endi...else.1.endif.if ], [ %.4373.sroa.0.1, %B0.endif.endif.endif.endi...else.1.endif ]
  %.4402 = add i64 %.3699, %.4347
  %.4405 = icmp slt i64 %.4402, 0
  br i1 %.4405, label %B0.endif.endif.endif.endi...else.1.endif.endif.if, label %B0.endif.endif.endif.endi...else.1.endif.endif.endif, !prof !81
B0.endif.endif.endif.endi...else.1.endif.endif.if:
  br label %B0.endif.endif.endif.endi...else.1.endif.endif.endif
B0.endif.endif.endif.endi...else.1.endif.endif.endif:
  %.4373.sroa.13.1 = phi i64 [ 0, %B0.endif.endif.endif.endi...else.1.endif.endif.if ], [ %.4402, %B0.endif.endif.endif.endi...else.1.endif.endif ]
  %.4410.not = icmp slt i64 %.4402, %.2218
  br i1 %.4410.not, label %B0.endif.endif.endif.endi...endif.10, label %B0.endif.endif.endif.endi...if.11, !prof !106
B0.endif.endif.endif.endi...if.11:
  br label %B0.endif.endif.endif.endi...endif.10
B0.endif.endif.endif.endi...endif.10.endif:
  %.4545.sroa.13.0 = phi i64 [ %.2218, %B0.endif.endif.endif.endi...endif.13.if ], [ %.4545.sroa.13.1, %B0.endif.endif.endif.endi...endif.13 ]
  %.5112 = getelementptr i8, ptr %arg.f.4, i64 96
  %.5113 = load i64, ptr %.5112, align 8
  %.5450 = getelementptr i8, ptr %arg.f.4, i64 104
  %.5451 = load i64, ptr %.5450, align 8
  %.5835 = icmp slt i64 %.354.i1659, 0
  %.5836 = select i1 %.5835, i64 %.693.i, i64 0
  %.5837 = add i64 %.5836, %.354.i1659
  %.5840 = icmp slt i64 %.5837, 0
  br i1 %.5840, label %B0.endif.endif.endif.endi...endif.10.endif.else.if, label %B0.endif.endif.endif.endi...endif.10.endif.else.endif, !prof !81
B0.endif.endif.endif.endi...endif.10.else.if:
  br label %B0.endif.endif.endif.endi...endif.10.else.endif
B0.endif.endif.endif.endi...endif.10.else.endif:
  %.4545.sroa.0.1 = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.10.else.if ], [ %.4402, %B0.endif.endif.endif.endi...endif.10 ]
  br i1 %.4410.not, label %B0.endif.endif.endif.endi...endif.10.else.endif.endif, label %B0.endif.endif.endif.endi...endif.10.else.endif.if, !prof !106
B0.endif.endif.endif.endi...endif.10.else.endif.if:
  br label %B0.endif.endif.endif.endi...endif.10.else.endif.endif
B0.endif.endif.endif.endi...endif.10.else.endif.endif:
  %.4545.sroa.0.3 = phi i64 [ %.2218, %B0.endif.endif.endif.endi...endif.10.else.endif.if ], [ %.4545.sroa.0.1, %B0.endif.endif.endif.endi...endif.10.else.endif ]
  %.4574 = add i64 %.3699, %.4519
  %.4577 = icmp slt i64 %.4574, 0
  br i1 %.4577, label %B0.endif.endif.endif.endi...if.13, label %B0.endif.endif.endif.endi...endif.13, !prof !81
B0.endif.endif.endif.endi...if.13:
  br label %B0.endif.endif.endif.endi...endif.13
B0.endif.endif.endif.endi...endif.13:
  %.4545.sroa.13.1 = phi i64 [ 0, %B0.endif.endif.endif.endi...if.13 ], [ %.4574, %B0.endif.endif.endif.endi...endif.10.else.endif.endif ]
  %.4582.not = icmp slt i64 %.4574, %.2218
  br i1 %.4582.not, label %B0.endif.endif.endif.endi...endif.10.endif, label %B0.endif.endif.endif.endi...endif.13.if, !prof !106
B0.endif.endif.endif.endi...endif.13.if:
  br label %B0.endif.endif.endif.endi...endif.10.endif
B0.endif.endif.endif.endi...endif.10.endif.else.if:
  br label %B0.endif.endif.endif.endi...endif.10.endif.else.endif
B0.endif.endif.endif.endi...endif.10.endif.else.endif:
  %.5825.sroa.0.1 = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.10.endif.else.if ], [ %.5837, %B0.endif.endif.endif.endi...endif.10.endif ]
  %.5845.not = icmp slt i64 %.5837, %.693.i
  br i1 %.5845.not, label %B0.endif.endif.endif.endi...endif.15.endif.if, label %B0.endif.endif.endif.endi...if.15, !prof !106
B0.endif.endif.endif.endi...if.15:
  br label %B0.endif.endif.endif.endi...endif.15.endif.if
B0.endif.endif.endif.endi...endif.15.endif.if:
  %.5825.sroa.0.3 = phi i64 [ %.693.i, %B0.endif.endif.endif.endi...if.15 ], [ %.5825.sroa.0.1, %B0.endif.endif.endif.endi...endif.10.endif.else.endif ]
  %.6306 = getelementptr i8, ptr %arg.f.4, i64 200
  %.6307 = load i64, ptr %.6306, align 8
  %.6767 = getelementptr i8, ptr %arg.f.4, i64 192
  %.6768 = load i64, ptr %.6767, align 8
  %.6837 = load double, ptr %.50.i, align 8
  %.6865 = getelementptr i8, ptr %.50.i, i64 8
  %.6866 = load double, ptr %.6865, align 8
  %.7541 = getelementptr i8, ptr %arg.f.4, i64 224
  %.7542 = load i64, ptr %.7541, align 8
  %.45.i1695 = getelementptr i8, ptr %arg.f.4, i64 328
  %.46.i1696 = load i64, ptr %.45.i1695, align 8, !noalias !162
  %.353.i1703 = getelementptr i8, ptr %arg.f.4, i64 424
  %.354.i1704 = load i64, ptr %.353.i1703, align 8, !noalias !165
  %.691.i1705 = getelementptr i8, ptr %arg.f.4, i64 416
  %.692.i1706 = load i64, ptr %.691.i1705, align 8, !noalias !165
  %.8354 = getelementptr i8, ptr %arg.f.4, i64 344
  %.8355 = load i64, ptr %.8354, align 8
  %.8740 = getelementptr i8, ptr %arg.f.4, i64 352
  %.8741 = load i64, ptr %.8740, align 8
  br i1 %.4577, label %B0.endif.endif.endif.endi...if.21, label %B0.endif.endif.endif.endi...endif.21, !prof !81
B0.endif.endif.endif.endi...endif.20.endif.endif.endif:
  %.8839.sroa.13.0 = phi i64 [ %.2218, %B0.endif.endif.endif.endi...endif.21.endif.endif.if ], [ %.8839.sroa.13.1, %B0.endif.endif.endif.endi...endif.21.endif.endif ]
  %.25.i1726 = mul nsw i64 %.3647, 3
  %.8742 = inttoptr i64 %.8741 to ptr
  %.25.i1718 = shl nsw i64 %.3647, 1
  %.8356 = inttoptr i64 %.8355 to ptr
  %.25.i1710 = mul nsw i64 %.7542, %.1706
  %.16.i1709 = shl i64 %.7542, 3
  %.693.i1707 = sub nsw i64 %.1833, %.692.i1706
  %.694.i = shl i64 %.1706, 3
  %.1033.i = mul i64 %.694.i, %.7542
  %.1375.i = mul i64 %.1033.i, %.693.i1707
  %.1376.i = add nsw i64 %.1375.i, %.354.i1704
  %.7607 = inttoptr i64 %.1376.i to ptr
  %.50.i1697 = inttoptr i64 %.46.i1696 to ptr
  %inserted.nitems.11 = insertvalue { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } { ptr null, ptr null, i64 undef, i64 undef, ptr undef, [1 x i64] undef, [1 x i64] undef }, i64 %.692, 2
  %inserted.itemsize.11 = insertvalue { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } %inserted.nitems.11, i64 1, 3
  %.6769 = inttoptr i64 %.6768 to ptr
  %inserted.data.11 = insertvalue { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } %inserted.itemsize.11, ptr %.6769, 4
  %.6796 = insertvalue [1 x i64] undef, i64 %.692, 0
  %inserted.shape.11 = insertvalue { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } %inserted.data.11, [1 x i64] %.6796, 5
  %inserted.strides.11 = insertvalue { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } %inserted.shape.11, [1 x i64] [i64 1], 6
  %.25.i = mul nsw i64 %.692, 3
  %inserted.nitems.10 = insertvalue { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] } { ptr null, ptr null, i64 undef, i64 undef, ptr undef, [2 x i64] undef, [2 x i64] undef }, i64 %.25.i, 2
  %inserted.itemsize.10 = insertvalue { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] } %inserted.nitems.10, i64 8, 3
  %.2264 = shl nsw i64 %.2218, 3
  %.2265 = add nsw i64 %.2176, %.2264
  %.2356 = add i64 %.2265, 16
  %.2357 = add i64 %.2356, %.694.i
  %.2790 = add nsw i64 %.2696, %.1368
  %1 = add i64 %.1706, %.2790
  %2 = shl i64 %1, 3
  %.2792 = add i64 %2, %.2356
  %.6383 = inttoptr i64 %.2792 to ptr
  %inserted.data.10 = insertvalue { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] } %inserted.itemsize.10, ptr %.6383, 4
  %.6417 = insertvalue [2 x i64] [i64 3, i64 undef], i64 %.692, 1
  %inserted.shape.10 = insertvalue { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] } %inserted.data.10, [2 x i64] %.6417, 5
  %.16.i = shl i64 %.692, 3
  %.6419 = insertvalue [2 x i64] undef, i64 %.16.i, 0
  %.6421 = insertvalue [2 x i64] %.6419, i64 8, 1
  %inserted.strides.10 = insertvalue { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] } %inserted.shape.10, [2 x i64] %.6421, 6
  %.6308 = inttoptr i64 %.6307 to ptr
  %.1035.i = shl nsw i64 %arg.i, 3
  %.1036.i = mul nsw i64 %.1035.i, %.693.i
  %.1037.i = add nsw i64 %.1036.i, %.1031.i
  %.1038.i = inttoptr i64 %.1037.i to ptr
  %.5938 = getelementptr double, ptr %.1038.i, i64 %.5825.sroa.0.3
  %.5913 = sub i64 %.693.i, %.5825.sroa.0.3
  %.5922 = tail call i64 @llvm.smax.i64(i64 %.5913, i64 0)
  %.2215 = inttoptr i64 %.2176 to ptr
  %.4658 = getelementptr double, ptr %.2215, i64 %.4545.sroa.0.3
  %.4633 = sub i64 %.4545.sroa.13.0, %.4545.sroa.0.3
  %.4642 = tail call i64 @llvm.smax.i64(i64 %.4633, i64 0)
  %.4486 = getelementptr double, ptr %.2215, i64 %.4373.sroa.0.3
  %.4461 = sub i64 %.4373.sroa.13.0, %.4373.sroa.0.3
  %.4470 = tail call i64 @llvm.smax.i64(i64 %.4461, i64 0)
  %.4314 = getelementptr double, ptr %.2215, i64 %.4201.sroa.0.3
  %.4289 = sub i64 %.4201.sroa.13.0, %.4201.sroa.0.3
  %.4298 = tail call i64 @llvm.smax.i64(i64 %.4289, i64 0)
  %.4143 = getelementptr double, ptr %.2215, i64 %.4030.sroa.0.3
  %.4118 = sub i64 %.4030.sroa.13.0, %.4030.sroa.0.3
  %.4127 = tail call i64 @llvm.smax.i64(i64 %.4118, i64 0)
  %.3973 = getelementptr double, ptr %.2215, i64 %.3860.sroa.0.3
  %.3948 = sub i64 %.2218, %.3860.sroa.0.3
  %.3957 = tail call i64 @llvm.smax.i64(i64 %.3948, i64 0)
  %.3801 = getelementptr double, ptr %.2215, i64 %.3688.sroa.0.3
  %.3776 = sub i64 %.3688.sroa.13.0, %.3688.sroa.0.3
  %.3785 = tail call i64 @llvm.smax.i64(i64 %.3776, i64 0)
  %.2931 = getelementptr double, ptr %.2215, i64 %.2818.sroa.0.31750
  %3 = add i64 %.1706, %.2696
  %4 = shl i64 %3, 3
  %.2743 = add i64 %4, %.2356
  %.2744 = inttoptr i64 %.2743 to ptr
  %.2358 = inttoptr i64 %.2357 to ptr
  %.2309 = inttoptr i64 %.2356 to ptr
  %.2266 = inttoptr i64 %.2265 to ptr
  %.8927 = sub i64 %.8839.sroa.13.0, %.8839.sroa.0.3
  %.8936 = tail call i64 @llvm.smax.i64(i64 %.8927, i64 0)
  %.8952 = getelementptr double, ptr %.2215, i64 %.8839.sroa.0.3
  %.45.i1734 = getelementptr i8, ptr %arg.f.4, i64 384
  %.46.i1735 = load i64, ptr %.45.i1734, align 8, !noalias !168
  %.50.i1736 = inttoptr i64 %.46.i1735 to ptr
  %.353.i1742 = getelementptr i8, ptr %arg.f.4, i64 376
  %.354.i1743 = load i64, ptr %.353.i1742, align 8, !noalias !171
  %.358.i = mul nsw i64 %.1833, 48
  %.359.i = add nsw i64 %.354.i1743, %.358.i
  %.360.i = inttoptr i64 %.359.i to ptr
  %.9953 = insertvalue { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } { ptr null, ptr null, i64 0, i64 8, ptr undef, [1 x i64] undef, [1 x i64] undef }, ptr %.2931, 4
  %.9954 = insertvalue { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } %.9953, [1 x i64] zeroinitializer, 5
  %.9955 = insertvalue { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } %.9954, [1 x i64] [i64 8], 6
  %.9957 = insertvalue { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, double, double, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, i8 } undef, { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] } %inserted.strides.10, 0
  %.9958 = insertvalue { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, double, double, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, i8 } %.9957, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } %inserted.strides.11, 1
  %.9959 = insertvalue { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, double, double, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, i8 } %.9958, double %.6837, 2
  %.9960 = insertvalue { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, double, double, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, i8 } %.9959, double %.6866, 3
  %.9961 = insertvalue { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, double, double, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, i8 } %.9960, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } %.9955, 4
  %.9962 = insertvalue { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, double, double, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, i8 } %.9961, i8 0, 5
  %retptr.repack1280 = getelementptr inbounds i8, ptr %retptr, i64 24
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %retptr, i8 0, i64 24, i1 false)
  store i64 %.5113, ptr %retptr.repack1280, align 8
  %retptr.repack1282 = getelementptr inbounds i8, ptr %retptr, i64 32
  store i64 %.5451, ptr %retptr.repack1282, align 8
  %retptr.repack1258 = getelementptr inbounds i8, ptr %retptr, i64 40
  %retptr.repack1258.repack1294 = getelementptr inbounds i8, ptr %retptr, i64 56
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %retptr.repack1258, i8 0, i64 16, i1 false)
  store i64 %.693.i, ptr %retptr.repack1258.repack1294, align 8
  %retptr.repack1258.repack1296 = getelementptr inbounds i8, ptr %retptr, i64 64
  store i64 8, ptr %retptr.repack1258.repack1296, align 8
  %retptr.repack1258.repack1298 = getelementptr inbounds i8, ptr %retptr, i64 72
  store ptr %.1038.i, ptr %retptr.repack1258.repack1298, align 8
  %retptr.repack1258.repack1300 = getelementptr inbounds i8, ptr %retptr, i64 80
  store i64 %.693.i, ptr %retptr.repack1258.repack1300, align 8
  %retptr.repack1258.repack1302 = getelementptr inbounds i8, ptr %retptr, i64 88
  store i64 8, ptr %retptr.repack1258.repack1302, align 8
  %retptr.repack1258.repack1284 = getelementptr inbounds i8, ptr %retptr, i64 96
  %retptr.repack1258.repack1284.repack1306 = getelementptr inbounds i8, ptr %retptr, i64 112
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %retptr.repack1258.repack1284, i8 0, i64 16, i1 false)
  store i64 %.5922, ptr %retptr.repack1258.repack1284.repack1306, align 8
  %retptr.repack1258.repack1284.repack1308 = getelementptr inbounds i8, ptr %retptr, i64 120
  store i64 8, ptr %retptr.repack1258.repack1284.repack1308, align 8
  %retptr.repack1258.repack1284.repack1310 = getelementptr inbounds i8, ptr %retptr, i64 128
  store ptr %.5938, ptr %retptr.repack1258.repack1284.repack1310, align 8
  %retptr.repack1258.repack1284.repack1312 = getelementptr inbounds i8, ptr %retptr, i64 136
  store i64 %.5922, ptr %retptr.repack1258.repack1284.repack1312, align 8
  %retptr.repack1258.repack1284.repack1314 = getelementptr inbounds i8, ptr %retptr, i64 144
  store i64 8, ptr %retptr.repack1258.repack1284.repack1314, align 8
  %retptr.repack1258.repack1286 = getelementptr inbounds i8, ptr %retptr, i64 152
  %retptr.repack1258.repack1286.repack1318 = getelementptr inbounds i8, ptr %retptr, i64 168
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %retptr.repack1258.repack1286, i8 0, i64 16, i1 false)
  store i64 %.1368, ptr %retptr.repack1258.repack1286.repack1318, align 8
  %retptr.repack1258.repack1286.repack1320 = getelementptr inbounds i8, ptr %retptr, i64 176
  store i64 1, ptr %retptr.repack1258.repack1286.repack1320, align 8
  %retptr.repack1258.repack1286.repack1322 = getelementptr inbounds i8, ptr %retptr, i64 184
  store ptr %.6308, ptr %retptr.repack1258.repack1286.repack1322, align 8
  %retptr.repack1258.repack1286.repack1324 = getelementptr inbounds i8, ptr %retptr, i64 192
  store i64 %.1368, ptr %retptr.repack1258.repack1286.repack1324, align 8
  %retptr.repack1258.repack1286.repack1326 = getelementptr inbounds i8, ptr %retptr, i64 200
  store i64 1, ptr %retptr.repack1258.repack1286.repack1326, align 8
  %retptr.repack1258.repack1288 = getelementptr inbounds i8, ptr %retptr, i64 208
  %retptr.repack1258.repack1288.repack1330 = getelementptr inbounds i8, ptr %retptr, i64 224
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %retptr.repack1258.repack1288, i8 0, i64 16, i1 false)
  store i64 %.2696, ptr %retptr.repack1258.repack1288.repack1330, align 8
  %retptr.repack1258.repack1288.repack1332 = getelementptr inbounds i8, ptr %retptr, i64 232
  store i64 8, ptr %retptr.repack1258.repack1288.repack1332, align 8
  %retptr.repack1258.repack1288.repack1334 = getelementptr inbounds i8, ptr %retptr, i64 240
  store ptr %.2358, ptr %retptr.repack1258.repack1288.repack1334, align 8
  %retptr.repack1258.repack1288.repack1336 = getelementptr inbounds i8, ptr %retptr, i64 248
  store i64 %.2696, ptr %retptr.repack1258.repack1288.repack1336, align 8
  %retptr.repack1258.repack1288.repack1338 = getelementptr inbounds i8, ptr %retptr, i64 256
  store i64 8, ptr %retptr.repack1258.repack1288.repack1338, align 8
  %retptr.repack1258.repack1290 = getelementptr inbounds i8, ptr %retptr, i64 264
  %retptr.repack1258.repack1290.repack1342 = getelementptr inbounds i8, ptr %retptr, i64 280
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %retptr.repack1258.repack1290, i8 0, i64 16, i1 false)
  store i64 %.1368, ptr %retptr.repack1258.repack1290.repack1342, align 8
  %retptr.repack1258.repack1290.repack1344 = getelementptr inbounds i8, ptr %retptr, i64 288
  store i64 8, ptr %retptr.repack1258.repack1290.repack1344, align 8
  %retptr.repack1258.repack1290.repack1346 = getelementptr inbounds i8, ptr %retptr, i64 296
  store ptr %.2744, ptr %retptr.repack1258.repack1290.repack1346, align 8
  %retptr.repack1258.repack1290.repack1348 = getelementptr inbounds i8, ptr %retptr, i64 304
  store i64 %.1368, ptr %retptr.repack1258.repack1290.repack1348, align 8
  %retptr.repack1258.repack1290.repack1350 = getelementptr inbounds i8, ptr %retptr, i64 312
  store i64 8, ptr %retptr.repack1258.repack1290.repack1350, align 8
  %retptr.repack1260 = getelementptr inbounds i8, ptr %retptr, i64 320
  store { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, double, double, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, i8 } %.9962, ptr %retptr.repack1260, align 8
  %retptr.repack1262 = getelementptr inbounds i8, ptr %retptr, i64 528
  %retptr.repack1262.repack1358 = getelementptr inbounds i8, ptr %retptr, i64 544
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %retptr.repack1262, i8 0, i64 16, i1 false)
  store i64 %.7542, ptr %retptr.repack1262.repack1358, align 8
  %retptr.repack1262.repack1360 = getelementptr inbounds i8, ptr %retptr, i64 552
  store i64 8, ptr %retptr.repack1262.repack1360, align 8
  %retptr.repack1262.repack1362 = getelementptr inbounds i8, ptr %retptr, i64 560
  store ptr %.50.i1697, ptr %retptr.repack1262.repack1362, align 8
  %retptr.repack1262.repack1364 = getelementptr inbounds i8, ptr %retptr, i64 568
  store i64 %.7542, ptr %retptr.repack1262.repack1364, align 8
  %retptr.repack1262.repack1366 = getelementptr inbounds i8, ptr %retptr, i64 576
  store i64 8, ptr %retptr.repack1262.repack1366, align 8
  %retptr.repack1262.repack1352 = getelementptr inbounds i8, ptr %retptr, i64 584
  %retptr.repack1262.repack1352.repack1370 = getelementptr inbounds i8, ptr %retptr, i64 600
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %retptr.repack1262.repack1352, i8 0, i64 16, i1 false)
  store i64 %.25.i1710, ptr %retptr.repack1262.repack1352.repack1370, align 8
  %retptr.repack1262.repack1352.repack1372 = getelementptr inbounds i8, ptr %retptr, i64 608
  store i64 8, ptr %retptr.repack1262.repack1352.repack1372, align 8
  %retptr.repack1262.repack1352.repack1374 = getelementptr inbounds i8, ptr %retptr, i64 616
  store ptr %.7607, ptr %retptr.repack1262.repack1352.repack1374, align 8
  %retptr.repack1262.repack1352.repack1376 = getelementptr inbounds i8, ptr %retptr, i64 624
  store i64 %.1706, ptr %retptr.repack1262.repack1352.repack1376, align 8
  %retptr.repack1262.repack1352.repack1376.repack1380 = getelementptr inbounds i8, ptr %retptr, i64 632
  store i64 %.7542, ptr %retptr.repack1262.repack1352.repack1376.repack1380, align 8
  %retptr.repack1262.repack1352.repack1378 = getelementptr inbounds i8, ptr %retptr, i64 640
  store i64 %.16.i1709, ptr %retptr.repack1262.repack1352.repack1378, align 8
  %retptr.repack1262.repack1352.repack1378.repack1382 = getelementptr inbounds i8, ptr %retptr, i64 648
  store i64 8, ptr %retptr.repack1262.repack1352.repack1378.repack1382, align 8
  %retptr.repack1262.repack1354 = getelementptr inbounds i8, ptr %retptr, i64 656
  %retptr.repack1262.repack1354.repack1386 = getelementptr inbounds i8, ptr %retptr, i64 672
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %retptr.repack1262.repack1354, i8 0, i64 16, i1 false)
  store i64 %.1706, ptr %retptr.repack1262.repack1354.repack1386, align 8
  %retptr.repack1262.repack1354.repack1388 = getelementptr inbounds i8, ptr %retptr, i64 680
  store i64 8, ptr %retptr.repack1262.repack1354.repack1388, align 8
  %retptr.repack1262.repack1354.repack1390 = getelementptr inbounds i8, ptr %retptr, i64 688
  store ptr %.2309, ptr %retptr.repack1262.repack1354.repack1390, align 8
  %retptr.repack1262.repack1354.repack1392 = getelementptr inbounds i8, ptr %retptr, i64 696
  store i64 %.1706, ptr %retptr.repack1262.repack1354.repack1392, align 8
  %retptr.repack1262.repack1354.repack1394 = getelementptr inbounds i8, ptr %retptr, i64 704
  store i64 8, ptr %retptr.repack1262.repack1354.repack1394, align 8
  %retptr.repack1264 = getelementptr inbounds i8, ptr %retptr, i64 712
  %retptr.repack1264.repack1400 = getelementptr inbounds i8, ptr %retptr, i64 728
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %retptr.repack1264, i8 0, i64 16, i1 false)
  store i64 %.25.i1718, ptr %retptr.repack1264.repack1400, align 8
  %retptr.repack1264.repack1402 = getelementptr inbounds i8, ptr %retptr, i64 736
  store i64 8, ptr %retptr.repack1264.repack1402, align 8
  %retptr.repack1264.repack1404 = getelementptr inbounds i8, ptr %retptr, i64 744
  store ptr %.8356, ptr %retptr.repack1264.repack1404, align 8
  %retptr.repack1264.repack1406 = getelementptr inbounds i8, ptr %retptr, i64 752
  store i64 %.3647, ptr %retptr.repack1264.repack1406, align 8
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
  store ptr %.8742, ptr %retptr.repack1264.repack1396.repack1420, align 8
  %retptr.repack1264.repack1396.repack1422 = getelementptr inbounds i8, ptr %retptr, i64 824
  store i64 %.3647, ptr %retptr.repack1264.repack1396.repack1422, align 8
  %retptr.repack1264.repack1396.repack1422.repack1426 = getelementptr inbounds i8, ptr %retptr, i64 832
  store i64 3, ptr %retptr.repack1264.repack1396.repack1422.repack1426, align 8
  %retptr.repack1264.repack1396.repack1424 = getelementptr inbounds i8, ptr %retptr, i64 840
  store i64 24, ptr %retptr.repack1264.repack1396.repack1424, align 8
  %retptr.repack1264.repack1396.repack1424.repack1428 = getelementptr inbounds i8, ptr %retptr, i64 848
  store i64 8, ptr %retptr.repack1264.repack1396.repack1424.repack1428, align 8
  %retptr.repack1266 = getelementptr inbounds i8, ptr %retptr, i64 856
  %retptr.repack1266.repack1456 = getelementptr inbounds i8, ptr %retptr, i64 872
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %retptr.repack1266, i8 0, i64 16, i1 false)
  store i64 %.3785, ptr %retptr.repack1266.repack1456, align 8
  %retptr.repack1266.repack1458 = getelementptr inbounds i8, ptr %retptr, i64 880
  store i64 8, ptr %retptr.repack1266.repack1458, align 8
  %retptr.repack1266.repack1460 = getelementptr inbounds i8, ptr %retptr, i64 888
  store ptr %.3801, ptr %retptr.repack1266.repack1460, align 8
  %retptr.repack1266.repack1462 = getelementptr inbounds i8, ptr %retptr, i64 896
  store i64 %.3785, ptr %retptr.repack1266.repack1462, align 8
  %retptr.repack1266.repack1464 = getelementptr inbounds i8, ptr %retptr, i64 904
  store i64 8, ptr %retptr.repack1266.repack1464, align 8
  %retptr.repack1266.repack1430 = getelementptr inbounds i8, ptr %retptr, i64 912
  %retptr.repack1266.repack1430.repack1470 = getelementptr inbounds i8, ptr %retptr, i64 936
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %retptr.repack1266.repack1430, i8 0, i64 24, i1 false)
  store i64 8, ptr %retptr.repack1266.repack1430.repack1470, align 8
  %retptr.repack1266.repack1430.repack1472 = getelementptr inbounds i8, ptr %retptr, i64 944
  store ptr %.2931, ptr %retptr.repack1266.repack1430.repack1472, align 8
  %retptr.repack1266.repack1430.repack1474 = getelementptr inbounds i8, ptr %retptr, i64 952
  store i64 0, ptr %retptr.repack1266.repack1430.repack1474, align 8
  %retptr.repack1266.repack1430.repack1476 = getelementptr inbounds i8, ptr %retptr, i64 960
  store i64 8, ptr %retptr.repack1266.repack1430.repack1476, align 8
  %retptr.repack1266.repack1432 = getelementptr inbounds i8, ptr %retptr, i64 968
  %retptr.repack1266.repack1432.repack1480 = getelementptr inbounds i8, ptr %retptr, i64 984
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %retptr.repack1266.repack1432, i8 0, i64 16, i1 false)
  store i64 %.3957, ptr %retptr.repack1266.repack1432.repack1480, align 8
  %retptr.repack1266.repack1432.repack1482 = getelementptr inbounds i8, ptr %retptr, i64 992
  store i64 8, ptr %retptr.repack1266.repack1432.repack1482, align 8
  %retptr.repack1266.repack1432.repack1484 = getelementptr inbounds i8, ptr %retptr, i64 1000
  store ptr %.3973, ptr %retptr.repack1266.repack1432.repack1484, align 8
  %retptr.repack1266.repack1432.repack1486 = getelementptr inbounds i8, ptr %retptr, i64 1008
  store i64 %.3957, ptr %retptr.repack1266.repack1432.repack1486, align 8
  %retptr.repack1266.repack1432.repack1488 = getelementptr inbounds i8, ptr %retptr, i64 1016
  store i64 8, ptr %retptr.repack1266.repack1432.repack1488, align 8
  %retptr.repack1266.repack1434 = getelementptr inbounds i8, ptr %retptr, i64 1024
  %retptr.repack1266.repack1434.repack1492 = getelementptr inbounds i8, ptr %retptr, i64 1040
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %retptr.repack1266.repack1434, i8 0, i64 16, i1 false)
  store i64 2, ptr %retptr.repack1266.repack1434.repack1492, align 8
  %retptr.repack1266.repack1434.repack1494 = getelementptr inbounds i8, ptr %retptr, i64 1048
  store i64 8, ptr %retptr.repack1266.repack1434.repack1494, align 8
  %retptr.repack1266.repack1434.repack1496 = getelementptr inbounds i8, ptr %retptr, i64 1056
  store ptr %.2266, ptr %retptr.repack1266.repack1434.repack1496, align 8
  %retptr.repack1266.repack1434.repack1498 = getelementptr inbounds i8, ptr %retptr, i64 1064
  store i64 2, ptr %retptr.repack1266.repack1434.repack1498, align 8
  %retptr.repack1266.repack1434.repack1500 = getelementptr inbounds i8, ptr %retptr, i64 1072
  store i64 8, ptr %retptr.repack1266.repack1434.repack1500, align 8
  %retptr.repack1266.repack1436 = getelementptr inbounds i8, ptr %retptr, i64 1080
  %retptr.repack1266.repack1436.repack1506 = getelementptr inbounds i8, ptr %retptr, i64 1104
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %retptr.repack1266.repack1436, i8 0, i64 24, i1 false)
  store i64 8, ptr %retptr.repack1266.repack1436.repack1506, align 8
  %retptr.repack1266.repack1436.repack1508 = getelementptr inbounds i8, ptr %retptr, i64 1112
  store ptr %.2931, ptr %retptr.repack1266.repack1436.repack1508, align 8
  %retptr.repack1266.repack1436.repack1510 = getelementptr inbounds i8, ptr %retptr, i64 1120
  store i64 0, ptr %retptr.repack1266.repack1436.repack1510, align 8
  %retptr.repack1266.repack1436.repack1512 = getelementptr inbounds i8, ptr %retptr, i64 1128
  store i64 8, ptr %retptr.repack1266.repack1436.repack1512, align 8
  %retptr.repack1266.repack1438 = getelementptr inbounds i8, ptr %retptr, i64 1136
  %retptr.repack1266.repack1438.repack1518 = getelementptr inbounds i8, ptr %retptr, i64 1160
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %retptr.repack1266.repack1438, i8 0, i64 24, i1 false)
  store i64 8, ptr %retptr.repack1266.repack1438.repack1518, align 8
  %retptr.repack1266.repack1438.repack1520 = getelementptr inbounds i8, ptr %retptr, i64 1168
  store ptr %.2931, ptr %retptr.repack1266.repack1438.repack1520, align 8
  %retptr.repack1266.repack1438.repack1522 = getelementptr inbounds i8, ptr %retptr, i64 1176
  store i64 0, ptr %retptr.repack1266.repack1438.repack1522, align 8
  %retptr.repack1266.repack1438.repack1524 = getelementptr inbounds i8, ptr %retptr, i64 1184
  store i64 8, ptr %retptr.repack1266.repack1438.repack1524, align 8
  %retptr.repack1266.repack1440 = getelementptr inbounds i8, ptr %retptr, i64 1192
  %retptr.repack1266.repack1440.repack1528 = getelementptr inbounds i8, ptr %retptr, i64 1208
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %retptr.repack1266.repack1440, i8 0, i64 16, i1 false)
  store i64 %.4127, ptr %retptr.repack1266.repack1440.repack1528, align 8
  %retptr.repack1266.repack1440.repack1530 = getelementptr inbounds i8, ptr %retptr, i64 1216
  store i64 8, ptr %retptr.repack1266.repack1440.repack1530, align 8
  %retptr.repack1266.repack1440.repack1532 = getelementptr inbounds i8, ptr %retptr, i64 1224
  store ptr %.4143, ptr %retptr.repack1266.repack1440.repack1532, align 8
  %retptr.repack1266.repack1440.repack1534 = getelementptr inbounds i8, ptr %retptr, i64 1232
  store i64 %.4127, ptr %retptr.repack1266.repack1440.repack1534, align 8
  %retptr.repack1266.repack1440.repack1536 = getelementptr inbounds i8, ptr %retptr, i64 1240
  store i64 8, ptr %retptr.repack1266.repack1440.repack1536, align 8
  %retptr.repack1266.repack1442 = getelementptr inbounds i8, ptr %retptr, i64 1248
  %retptr.repack1266.repack1442.repack1542 = getelementptr inbounds i8, ptr %retptr, i64 1272
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %retptr.repack1266.repack1442, i8 0, i64 24, i1 false)
  store i64 8, ptr %retptr.repack1266.repack1442.repack1542, align 8
  %retptr.repack1266.repack1442.repack1544 = getelementptr inbounds i8, ptr %retptr, i64 1280
  store ptr %.2931, ptr %retptr.repack1266.repack1442.repack1544, align 8
  %retptr.repack1266.repack1442.repack1546 = getelementptr inbounds i8, ptr %retptr, i64 1288
  store i64 0, ptr %retptr.repack1266.repack1442.repack1546, align 8
  %retptr.repack1266.repack1442.repack1548 = getelementptr inbounds i8, ptr %retptr, i64 1296
  store i64 8, ptr %retptr.repack1266.repack1442.repack1548, align 8
  %retptr.repack1266.repack1444 = getelementptr inbounds i8, ptr %retptr, i64 1304
  %retptr.repack1266.repack1444.repack1554 = getelementptr inbounds i8, ptr %retptr, i64 1328
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %retptr.repack1266.repack1444, i8 0, i64 24, i1 false)
  store i64 8, ptr %retptr.repack1266.repack1444.repack1554, align 8
  %retptr.repack1266.repack1444.repack1556 = getelementptr inbounds i8, ptr %retptr, i64 1336
  store ptr %.2931, ptr %retptr.repack1266.repack1444.repack1556, align 8
  %retptr.repack1266.repack1444.repack1558 = getelementptr inbounds i8, ptr %retptr, i64 1344
  store i64 0, ptr %retptr.repack1266.repack1444.repack1558, align 8
  %retptr.repack1266.repack1444.repack1560 = getelementptr inbounds i8, ptr %retptr, i64 1352
  store i64 8, ptr %retptr.repack1266.repack1444.repack1560, align 8
  %retptr.repack1266.repack1446 = getelementptr inbounds i8, ptr %retptr, i64 1360
  %retptr.repack1266.repack1446.repack1566 = getelementptr inbounds i8, ptr %retptr, i64 1384
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %retptr.repack1266.repack1446, i8 0, i64 24, i1 false)
  store i64 8, ptr %retptr.repack1266.repack1446.repack1566, align 8
  %retptr.repack1266.repack1446.repack1568 = getelementptr inbounds i8, ptr %retptr, i64 1392
  store ptr %.2931, ptr %retptr.repack1266.repack1446.repack1568, align 8
  %retptr.repack1266.repack1446.repack1570 = getelementptr inbounds i8, ptr %retptr, i64 1400
  store i64 0, ptr %retptr.repack1266.repack1446.repack1570, align 8
  %retptr.repack1266.repack1446.repack1572 = getelementptr inbounds i8, ptr %retptr, i64 1408
  store i64 8, ptr %retptr.repack1266.repack1446.repack1572, align 8
  %retptr.repack1266.repack1448 = getelementptr inbounds i8, ptr %retptr, i64 1416
  %retptr.repack1266.repack1448.repack1576 = getelementptr inbounds i8, ptr %retptr, i64 1432
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %retptr.repack1266.repack1448, i8 0, i64 16, i1 false)
  store i64 %.4298, ptr %retptr.repack1266.repack1448.repack1576, align 8
  %retptr.repack1266.repack1448.repack1578 = getelementptr inbounds i8, ptr %retptr, i64 1440
  store i64 8, ptr %retptr.repack1266.repack1448.repack1578, align 8
  %retptr.repack1266.repack1448.repack1580 = getelementptr inbounds i8, ptr %retptr, i64 1448
  store ptr %.4314, ptr %retptr.repack1266.repack1448.repack1580, align 8
  %retptr.repack1266.repack1448.repack1582 = getelementptr inbounds i8, ptr %retptr, i64 1456
  store i64 %.4298, ptr %retptr.repack1266.repack1448.repack1582, align 8
  %retptr.repack1266.repack1448.repack1584 = getelementptr inbounds i8, ptr %retptr, i64 1464
  store i64 8, ptr %retptr.repack1266.repack1448.repack1584, align 8
  %retptr.repack1266.repack1450 = getelementptr inbounds i8, ptr %retptr, i64 1472
  %retptr.repack1266.repack1450.repack1588 = getelementptr inbounds i8, ptr %retptr, i64 1488
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %retptr.repack1266.repack1450, i8 0, i64 16, i1 false)
  store i64 %.4470, ptr %retptr.repack1266.repack1450.repack1588, align 8
  %retptr.repack1266.repack1450.repack1590 = getelementptr inbounds i8, ptr %retptr, i64 1496
  store i64 8, ptr %retptr.repack1266.repack1450.repack1590, align 8
  %retptr.repack1266.repack1450.repack1592 = getelementptr inbounds i8, ptr %retptr, i64 1504
  store ptr %.4486, ptr %retptr.repack1266.repack1450.repack1592, align 8
  %retptr.repack1266.repack1450.repack1594 = getelementptr inbounds i8, ptr %retptr, i64 1512
  store i64 %.4470, ptr %retptr.repack1266.repack1450.repack1594, align 8
  %retptr.repack1266.repack1450.repack1596 = getelementptr inbounds i8, ptr %retptr, i64 1520
  store i64 8, ptr %retptr.repack1266.repack1450.repack1596, align 8
  %retptr.repack1266.repack1452 = getelementptr inbounds i8, ptr %retptr, i64 1528
  %retptr.repack1266.repack1452.repack1600 = getelementptr inbounds i8, ptr %retptr, i64 1544
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %retptr.repack1266.repack1452, i8 0, i64 16, i1 false)
  store i64 %.4642, ptr %retptr.repack1266.repack1452.repack1600, align 8
  %retptr.repack1266.repack1452.repack1602 = getelementptr inbounds i8, ptr %retptr, i64 1552
  store i64 8, ptr %retptr.repack1266.repack1452.repack1602, align 8
  %retptr.repack1266.repack1452.repack1604 = getelementptr inbounds i8, ptr %retptr, i64 1560
  store ptr %.4658, ptr %retptr.repack1266.repack1452.repack1604, align 8
  %retptr.repack1266.repack1452.repack1606 = getelementptr inbounds i8, ptr %retptr, i64 1568
  store i64 %.4642, ptr %retptr.repack1266.repack1452.repack1606, align 8
  %retptr.repack1266.repack1452.repack1608 = getelementptr inbounds i8, ptr %retptr, i64 1576
  store i64 8, ptr %retptr.repack1266.repack1452.repack1608, align 8
  %retptr.repack1268 = getelementptr inbounds i8, ptr %retptr, i64 1584
  %retptr.repack1268.repack1612 = getelementptr inbounds i8, ptr %retptr, i64 1600
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %retptr.repack1268, i8 0, i64 16, i1 false)
  store i64 %.8936, ptr %retptr.repack1268.repack1612, align 8
  %retptr.repack1268.repack1614 = getelementptr inbounds i8, ptr %retptr, i64 1608
  store i64 8, ptr %retptr.repack1268.repack1614, align 8
  %retptr.repack1268.repack1616 = getelementptr inbounds i8, ptr %retptr, i64 1616
  store ptr %.8952, ptr %retptr.repack1268.repack1616, align 8
  %retptr.repack1268.repack1618 = getelementptr inbounds i8, ptr %retptr, i64 1624
  store i64 %.8936, ptr %retptr.repack1268.repack1618, align 8
  %retptr.repack1268.repack1620 = getelementptr inbounds i8, ptr %retptr, i64 1632
  store i64 8, ptr %retptr.repack1268.repack1620, align 8
  %retptr.repack1270 = getelementptr inbounds i8, ptr %retptr, i64 1640
  %retptr.repack1270.repack1626 = getelementptr inbounds i8, ptr %retptr, i64 1664
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %retptr.repack1270, i8 0, i64 24, i1 false)
  store i64 8, ptr %retptr.repack1270.repack1626, align 8
  %retptr.repack1270.repack1628 = getelementptr inbounds i8, ptr %retptr, i64 1672
  store ptr %.2931, ptr %retptr.repack1270.repack1628, align 8
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
  store ptr %.360.i, ptr %retptr.repack1274.repack1652, align 8
  %retptr.repack1274.repack1654 = getelementptr inbounds i8, ptr %retptr, i64 1792
  store i64 6, ptr %retptr.repack1274.repack1654, align 8
  %retptr.repack1274.repack1656 = getelementptr inbounds i8, ptr %retptr, i64 1800
  store i64 8, ptr %retptr.repack1274.repack1656, align 8
  ret void
B0.endif.endif.endif.endi...if.21:
  br label %B0.endif.endif.endif.endi...endif.21
B0.endif.endif.endif.endi...endif.21:
  %.8839.sroa.0.1 = phi i64 [ 0, %B0.endif.endif.endif.endi...if.21 ], [ %.4574, %B0.endif.endif.endif.endi...endif.15.endif.if ]
  br i1 %.4582.not, label %B0.endif.endif.endif.endi...endif.21.endif, label %B0.endif.endif.endif.endi...endif.21.if, !prof !106
B0.endif.endif.endif.endi...endif.21.if:
  br label %B0.endif.endif.endif.endi...endif.21.endif
B0.endif.endif.endif.endi...endif.21.endif:
  %.8839.sroa.0.3 = phi i64 [ %.2218, %B0.endif.endif.endif.endi...endif.21.if ], [ %.8839.sroa.0.1, %B0.endif.endif.endif.endi...endif.21 ]
  br i1 %.3703, label %B0.endif.endif.endif.endi...endif.21.endif.if, label %B0.endif.endif.endif.endi...endif.21.endif.endif, !prof !81
B0.endif.endif.endif.endi...endif.21.endif.if:
  br label %B0.endif.endif.endif.endi...endif.21.endif.endif
B0.endif.endif.endif.endi...endif.21.endif.endif:
  %.8839.sroa.13.1 = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.21.endif.if ], [ %.3700, %B0.endif.endif.endif.endi...endif.21.endif ]
  br i1 %.3708.not, label %B0.endif.endif.endif.endi...endif.20.endif.endif.endif, label %B0.endif.endif.endif.endi...endif.21.endif.endif.if, !prof !106
B0.endif.endif.endif.endi...endif.21.endif.endif.if:
  br label %B0.endif.endif.endif.endi...endif.20.endif.endif.endif
}
declare double @llvm.fabs.f64(double)
declare double @llvm.sin.f64(double)
declare double @llvm.floor.f64(double)
define internal fastcc void @v71(ptr noalias nonnull writeonly %retptr, ptr readonly %arg.f.4, i64 %arg.i, double %arg.segment.0, ptr readonly %arg.segment.2.4, i64 %arg.segment.2.5.1) unnamed_addr {
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
  %.1311 = alloca i8, align 1
  store i8 0, ptr %.1311, align 1
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(521) %.46, i8 0, i64 521, i1 false)
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(1280) %.fca.3.0.0.gep, i8 0, i64 1280, i1 false)
  call fastcc void @v73(ptr %.46, ptr %arg.f.4, i64 %arg.i)
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
  %.384.i.i = load i64, ptr %arg.f.4, align 8, !noalias !174
  %.175117.not.i = icmp slt i64 %.62.fca.6.2.load, 1
  br i1 %.175117.not.i, label %b87, label %B76.if.lr.ph.i
B76.if.lr.ph.i:
  %0 = getelementptr i8, ptr %arg.f.4, i64 448
  %.45.i.i = load i64, ptr %0, align 8, !noalias !174
  %.46.i.i = inttoptr i64 %.45.i.i to ptr
  %invariant.gep.i = getelementptr double, ptr %.46.i.i, i64 %arg.i
  %.241.i = icmp slt i64 %arg.i, 0
  %.242.i = select i1 %.241.i, i64 %.384.i.i, i64 0
  %invariant.gep120.i = getelementptr double, ptr %invariant.gep.i, i64 %.242.i
  br label %B76.if.i
B76.if.i:
  %.119.0118.i = phi i64 [ 0, %B76.if.lr.ph.i ], [ %.188.i, %B76.if.i ]
  %.188.i = add nuw nsw i64 %.119.0118.i, 1
  %.260.i = mul i64 %.119.0118.i, %.384.i.i
  %gep121.i = getelementptr double, ptr %invariant.gep120.i, i64 %.260.i
  %.265.i = load double, ptr %gep121.i, align 8, !noalias !179
  %1 = getelementptr double, ptr %.62.fca.6.4.load, i64 %.119.0118.i
  store double %.265.i, ptr %1, align 8, !noalias !179
  %exitcond.not.i = icmp eq i64 %.188.i, %.62.fca.6.2.load
  br i1 %exitcond.not.i, label %b87, label %B76.if.i
b87:
  %.1295 = getelementptr i8, ptr %arg.f.4, i64 160
  %.1296 = load i64, ptr %.1295, align 8
  %.1297 = icmp sgt i64 %.1296, 0
  br i1 %.1297, label %B146, label %B206
B146:
  call fastcc void @v74(ptr %.1311, ptr nonnull %arg.f.4, i64 %arg.i, i64 %.62.fca.0.4.load, ptr %.62.fca.1.0.4.load, i64 %.62.fca.1.1.2.load, ptr %.62.fca.1.1.4.load, ptr %.62.fca.1.2.4.load, i64 %.62.fca.1.3.2.load, ptr %.62.fca.1.3.4.load, ptr %.62.fca.1.4.4.load, i64 %.62.fca.5.0.2.load, ptr %.62.fca.5.0.4.load, ptr %.62.fca.5.3.4.load, ptr %arg.segment.2.4, i64 %arg.segment.2.5.1, double %arg.segment.0, ptr %.62.fca.6.4.load)
  br label %B206
B206:
  %.1784 = getelementptr i8, ptr %arg.f.4, i64 232
  %.1785 = load i64, ptr %.1784, align 8
  %.1791 = icmp sgt i64 %.1785, 0
  br i1 %.1791, label %B250, label %B206.B342_crit_edge
B206.B342_crit_edge:
  %.2124.phi.trans.insert = getelementptr i8, ptr %.62.fca.9.4.load, i64 24
  %.2125.pre = load i64, ptr %.2124.phi.trans.insert, align 8
  br label %B342
B250:
  %.148211.not.i.i.i = icmp slt i64 %.62.fca.5.0.2.load, 1
  br i1 %.148211.not.i.i.i, label %b88, label %B58.if.i.i.i
B164.i.i.i:
  %.44.i.i.i.i = getelementptr i8, ptr %3, i64 24
  %.45.i.i.i.i = load double, ptr %.44.i.i.i.i, align 8, !noalias !180
  %.73.i.i.i.i = getelementptr i8, ptr %3, i64 32
  %.74.i.i.i.i = load double, ptr %.73.i.i.i.i, align 8, !noalias !180
  %.75.i.i.i.i = fmul double %.74.i.i.i.i, 5.000000e-01
  %.76.i.i.i.i = fmul double %.245.i.i.i, %.75.i.i.i.i
  %.77.i.i.i.i = fadd double %.45.i.i.i.i, %.76.i.i.i.i
  %.78.i.i.i.i = fmul double %.245.i.i.i, %.77.i.i.i.i
  %.87.le.i.i.i.i = tail call double @llvm.floor.f64(double %.78.i.i.i.i)
  %.92.i.i.i.i = fsub double %.78.i.i.i.i, %.87.le.i.i.i.i
  %.93.i.i.i.i = fmul double %.92.i.i.i.i, 0x401921FB54442D18
  %.121.i.i.i.i = getelementptr i8, ptr %3, i64 40
  %.122.i.i.i.i = load double, ptr %.121.i.i.i.i, align 8, !noalias !180
  %.126.i.i.i.i = fadd double %.122.i.i.i.i, %.93.i.i.i.i
  %.593.le.i.i.i = tail call double @llvm.sin.f64(double %.126.i.i.i.i)
  %.598.i.i.i = fmul double %.423.i.i.i, %.593.le.i.i.i
  %.600.i.i.i = fadd double %.361.i.i.i, %.598.i.i.i
  br label %B272.i.i.i
B272.i.i.i:
  %value.2.1.i.i.i = phi double [ %.600.i.i.i, %B164.i.i.i ], [ %.361.i.i.i, %B58.if.i.i.i ]
  %2 = getelementptr double, ptr %.62.fca.5.0.4.load, i64 %.90.0213.i.i.i
  store double %value.2.1.i.i.i, ptr %2, align 8, !noalias !189
  %exitcond.not.i.i.i = icmp eq i64 %.62.fca.5.0.2.load, %.161.i.i.i
  br i1 %exitcond.not.i.i.i, label %b88, label %B58.if.i.i.i
B58.if.i.i.i:
  %.90.0213.i.i.i = phi i64 [ %.161.i.i.i, %B272.i.i.i ], [ 0, %B250 ]
  %.161.i.i.i = add nuw nsw i64 %.90.0213.i.i.i, 1
  %.238.i.i.i = mul i64 %.90.0213.i.i.i, %arg.segment.2.5.1
  %3 = getelementptr double, ptr %arg.segment.2.4, i64 %.238.i.i.i
  %.242.i.i.i = getelementptr i8, ptr %3, i64 48
  %.243.i.i.i = load double, ptr %.242.i.i.i, align 8, !noalias !189
  %.245.i.i.i = fsub double %arg.segment.0, %.243.i.i.i
  %.303.i.i.i = load double, ptr %3, align 8, !noalias !189
  %.357.i.i.i = getelementptr i8, ptr %3, i64 8
  %.358.i.i.i = load double, ptr %.357.i.i.i, align 8, !noalias !189
  %.360.i.i.i = fmul double %.245.i.i.i, %.358.i.i.i
  %.361.i.i.i = fadd double %.303.i.i.i, %.360.i.i.i
  %.422.i.i.i = getelementptr i8, ptr %3, i64 16
  %.423.i.i.i = load double, ptr %.422.i.i.i, align 8, !noalias !189
  %.424.i.i.i = fcmp une double %.423.i.i.i, 0.000000e+00
  br i1 %.424.i.i.i, label %B164.i.i.i, label %B272.i.i.i
b88:
  store double %arg.segment.0, ptr %.62.fca.5.3.4.load, align 8, !noalias !190
  %.992.i.i = inttoptr i64 %.62.fca.0.3.load to ptr
  tail call void %.992.i.i(ptr nonnull %.62.fca.5.3.4.load, ptr %.62.fca.6.4.load, ptr %.62.fca.5.0.4.load, ptr %.62.fca.1.0.4.load, ptr %.62.fca.3.2.4.load), !noalias !190
  %spec.select.i = tail call i64 @llvm.smax.i64(i64 %.62.fca.4.1.5.0.load, i64 0)
  br label %B140.i
B140.i:
  %.859.0.i = phi i64 [ 0, %b88 ], [ %.928.i, %B288.i ]
  %exitcond294.not.i = icmp eq i64 %.859.0.i, %spec.select.i
  br i1 %exitcond294.not.i, label %b94, label %B142.i
B142.i:
  %.1005.i = mul i64 %.859.0.i, %.62.fca.4.1.5.1.load
  %4 = getelementptr double, ptr %.62.fca.4.1.4.load, i64 %.1005.i
  %.1009.i = getelementptr i8, ptr %4, i64 16
  %.1010.i = load double, ptr %.1009.i, align 8, !noalias !191
  %.1186.i = mul i64 %.859.0.i, %.62.fca.4.0.5.1.load
  %5 = getelementptr i64, ptr %.62.fca.4.0.4.load, i64 %.1186.i
  br label %B194.if.i
B226.i:
  %6 = getelementptr double, ptr %4, i64 %.1037.0289.i
  %.1249.i = load double, ptr %6, align 8, !noalias !191
  %.1338.i = getelementptr double, ptr %.62.fca.3.2.4.load, i64 %.1191.i
  %.1339.i = load double, ptr %.1338.i, align 8, !noalias !191
  %.1340.i = fmul double %.1249.i, %.1339.i
  %.1342.i = fadd double %value.2.1291.i, %.1340.i
  br label %B286.i
B286.i:
  %value.3.2.i = phi double [ %.1342.i, %B226.i ], [ %value.2.1291.i, %B194.if.i ]
  br i1 %exitcond.not.i1642, label %B288.i, label %B194.if.i
B288.i:
  %.928.i = add nuw i64 %.859.0.i, 1
  %.1361.i = fcmp ogt double %value.3.2.i, 0.000000e+00
  br i1 %.1361.i, label %b94, label %B140.i
B194.if.i:
  %value.2.1291.i = phi double [ %.1010.i, %B142.i ], [ %value.3.2.i, %B286.i ]
  %exitcond.not.i1642 = phi i1 [ false, %B142.i ], [ true, %B286.i ]
  %.1037.0289.i = phi i64 [ 0, %B142.i ], [ 1, %B286.i ]
  %7 = getelementptr i64, ptr %5, i64 %.1037.0289.i
  %.1191.i = load i64, ptr %7, align 8, !noalias !191
  %.1194.i = icmp sgt i64 %.1191.i, -1
  br i1 %.1194.i, label %B226.i, label %B286.i
b94:
  %storemerge280.i = phi i64 [ %.859.0.i, %B288.i ], [ -1, %B140.i ]
  %.1961 = getelementptr i8, ptr %.62.fca.9.4.load, i64 24
  store i64 %storemerge280.i, ptr %.1961, align 8
  br label %B342
B342:
  %.2125 = phi i64 [ %.2125.pre, %B206.B342_crit_edge ], [ %storemerge280.i, %b94 ]
  store i64 %.2125, ptr %retptr, align 8
  ret void
}
define internal fastcc void @v72(ptr noalias nonnull writeonly %retptr, ptr readonly %arg.f.4, i64 %arg.i, ptr readonly %arg.segment.2.4, i64 %arg.segment.2.5.1, double %arg.t) unnamed_addr {
entry:
  %.39 = alloca { [5 x i64], { { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, double, double, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, i8 }, { { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] } }, [13 x { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }], { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, align 8
  %.fca.3.0.0.gep = getelementptr inbounds i8, ptr %.39, i64 528
  %.fca.5.0.2.gep = getelementptr inbounds i8, ptr %.39, i64 872
  %.fca.5.0.4.gep = getelementptr inbounds i8, ptr %.39, i64 888
  %.fca.5.2.2.gep = getelementptr inbounds i8, ptr %.39, i64 984
  %.fca.5.2.4.gep = getelementptr inbounds i8, ptr %.39, i64 1000
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(521) %.39, i8 0, i64 521, i1 false)
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(1280) %.fca.3.0.0.gep, i8 0, i64 1280, i1 false)
  call fastcc void @v73(ptr %.39, ptr %arg.f.4, i64 %arg.i)
  %.55.fca.5.0.2.load = load i64, ptr %.fca.5.0.2.gep, align 8
  %.55.fca.5.0.4.load = load ptr, ptr %.fca.5.0.4.gep, align 8
  %.55.fca.5.2.2.load = load i64, ptr %.fca.5.2.2.gep, align 8
  %.55.fca.5.2.4.load = load ptr, ptr %.fca.5.2.4.gep, align 8
  %.148211.not.i = icmp slt i64 %.55.fca.5.0.2.load, 1
  br i1 %.148211.not.i, label %b95, label %B58.if.i
B164.i:
  %.44.i.i = getelementptr i8, ptr %1, i64 24
  %.45.i.i = load double, ptr %.44.i.i, align 8, !noalias !192
  %.73.i.i = getelementptr i8, ptr %1, i64 32
  %.74.i.i = load double, ptr %.73.i.i, align 8, !noalias !192
  %.75.i.i = fmul double %.74.i.i, 5.000000e-01
  %.76.i.i = fmul double %.245.i, %.75.i.i
  %.77.i.i = fadd double %.45.i.i, %.76.i.i
  %.78.i.i = fmul double %.245.i, %.77.i.i
  %.87.le.i.i = tail call double @llvm.floor.f64(double %.78.i.i)
  %.92.i.i = fsub double %.78.i.i, %.87.le.i.i
  %.93.i.i = fmul double %.92.i.i, 0x401921FB54442D18
  %.121.i.i = getelementptr i8, ptr %1, i64 40
  %.122.i.i = load double, ptr %.121.i.i, align 8, !noalias !192
  %.126.i.i = fadd double %.122.i.i, %.93.i.i
  %.593.le.i = tail call double @llvm.sin.f64(double %.126.i.i)
  %.598.i = fmul double %.423.i, %.593.le.i
  %.600.i = fadd double %.361.i, %.598.i
  br label %B272.i
B272.i:
  %value.2.1.i = phi double [ %.600.i, %B164.i ], [ %.361.i, %B58.if.i ]
  %0 = getelementptr double, ptr %.55.fca.5.0.4.load, i64 %.90.0213.i
  store double %value.2.1.i, ptr %0, align 8, !noalias !197
  %exitcond.not.i = icmp eq i64 %.55.fca.5.0.2.load, %.161.i
  br i1 %exitcond.not.i, label %b95, label %B58.if.i
B58.if.i:
  %.90.0213.i = phi i64 [ %.161.i, %B272.i ], [ 0, %entry ]
  %.161.i = add nuw nsw i64 %.90.0213.i, 1
  %.238.i = mul i64 %.90.0213.i, %arg.segment.2.5.1
  %1 = getelementptr double, ptr %arg.segment.2.4, i64 %.238.i
  %.242.i = getelementptr i8, ptr %1, i64 48
  %.243.i = load double, ptr %.242.i, align 8, !noalias !197
  %.245.i = fsub double %arg.t, %.243.i
  %.303.i = load double, ptr %1, align 8, !noalias !197
  %.357.i = getelementptr i8, ptr %1, i64 8
  %.358.i = load double, ptr %.357.i, align 8, !noalias !197
  %.360.i = fmul double %.245.i, %.358.i
  %.361.i = fadd double %.303.i, %.360.i
  %.422.i = getelementptr i8, ptr %1, i64 16
  %.423.i = load double, ptr %.422.i, align 8, !noalias !197
  %.424.i = fcmp une double %.423.i, 0.000000e+00
  br i1 %.424.i, label %B164.i, label %B272.i
b95:
  %.148231.not.i = icmp slt i64 %.55.fca.5.2.2.load, 1
  br i1 %.148231.not.i, label %b96, label %B58.if.i231
B110.i:
  %.361.i237 = getelementptr i8, ptr %3, i64 48
  %.362.i = load double, ptr %.361.i237, align 8, !noalias !198
  %.364.i = fsub double %arg.t, %.362.i
  %.419.i = getelementptr i8, ptr %3, i64 24
  %.420.i = load double, ptr %.419.i, align 8, !noalias !198
  %.474.i = getelementptr i8, ptr %3, i64 32
  %.475.i = load double, ptr %.474.i, align 8, !noalias !198
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
  %.122.i.i246 = load double, ptr %.121.i.i245, align 8, !noalias !201
  %.126.i.i247 = fadd double %.122.i.i246, %.93.i.i244
  %.644.le.i = tail call double @llvm.cos.f64(double %.126.i.i247)
  %.649.i = fmul double %.534.i, %.644.le.i
  %.651.i = fadd double %.243.i235, %.649.i
  br label %B326.i
B326.i:
  %slope.2.1.i = phi double [ %.651.i, %B110.i ], [ %.243.i235, %B58.if.i231 ]
  %2 = getelementptr double, ptr %.55.fca.5.2.4.load, i64 %.90.0233.i
  store double %slope.2.1.i, ptr %2, align 8, !noalias !198
  %exitcond.not.i236 = icmp eq i64 %.55.fca.5.2.2.load, %.161.i232
  br i1 %exitcond.not.i236, label %b96, label %B58.if.i231
B58.if.i231:
  %.90.0233.i = phi i64 [ %.161.i232, %B326.i ], [ 0, %b95 ]
  %.161.i232 = add nuw nsw i64 %.90.0233.i, 1
  %.238.i233 = mul i64 %.90.0233.i, %arg.segment.2.5.1
  %3 = getelementptr double, ptr %arg.segment.2.4, i64 %.238.i233
  %.242.i234 = getelementptr i8, ptr %3, i64 8
  %.243.i235 = load double, ptr %.242.i234, align 8, !noalias !198
  %.304.i = getelementptr i8, ptr %3, i64 16
  %.305.i = load double, ptr %.304.i, align 8, !noalias !198
  %.306.i = fcmp une double %.305.i, 0.000000e+00
  br i1 %.306.i, label %B110.i, label %B326.i
b96:
  %.384.i.i = load i64, ptr %arg.f.4, align 8, !noalias !204
  br i1 %.148211.not.i, label %b91, label %B76.if.lr.ph.i
B76.if.lr.ph.i:
  %4 = getelementptr i8, ptr %arg.f.4, i64 456
  %.45.i.i248 = load i64, ptr %4, align 8, !noalias !204
  %.46.i.i = inttoptr i64 %.45.i.i248 to ptr
  %invariant.gep.i = getelementptr double, ptr %.46.i.i, i64 %arg.i
  %.271.i = icmp slt i64 %arg.i, 0
  %.272.i = select i1 %.271.i, i64 %.384.i.i, i64 0
  %invariant.gep120.i = getelementptr double, ptr %invariant.gep.i, i64 %.272.i
  br label %B76.if.i
B76.if.i:
  %.119.0118.i = phi i64 [ 0, %B76.if.lr.ph.i ], [ %.188.i, %B76.if.i ]
  %.188.i = add nuw nsw i64 %.119.0118.i, 1
  %5 = getelementptr double, ptr %.55.fca.5.0.4.load, i64 %.119.0118.i
  %.242.i249 = load double, ptr %5, align 8, !noalias !209
  %.290.i = mul i64 %.119.0118.i, %.384.i.i
  %gep121.i = getelementptr double, ptr %invariant.gep120.i, i64 %.290.i
  store double %.242.i249, ptr %gep121.i, align 8, !noalias !209
  %exitcond.not.i250 = icmp eq i64 %.188.i, %.55.fca.5.0.2.load
  br i1 %exitcond.not.i250, label %b92, label %B76.if.i
b92:
  %.384.i.i251.pre = load i64, ptr %arg.f.4, align 8, !noalias !210
  br label %b91
b91:
  %.384.i.i251 = phi i64 [ %.384.i.i251.pre, %b92 ], [ %.384.i.i, %b96 ]
  br i1 %.148231.not.i, label %b97, label %B76.if.lr.ph.i253
B76.if.lr.ph.i253:
  %6 = getelementptr i8, ptr %arg.f.4, i64 472
  %.45.i.i254 = load i64, ptr %6, align 8, !noalias !210
  %.46.i.i255 = inttoptr i64 %.45.i.i254 to ptr
  %invariant.gep.i256 = getelementptr double, ptr %.46.i.i255, i64 %arg.i
  %.271.i257 = icmp slt i64 %arg.i, 0
  %.272.i258 = select i1 %.271.i257, i64 %.384.i.i251, i64 0
  %invariant.gep120.i259 = getelementptr double, ptr %invariant.gep.i256, i64 %.272.i258
  br label %B76.if.i260
B76.if.i260:
  %.119.0118.i261 = phi i64 [ 0, %B76.if.lr.ph.i253 ], [ %.188.i262, %B76.if.i260 ]
  %.188.i262 = add nuw nsw i64 %.119.0118.i261, 1
  %7 = getelementptr double, ptr %.55.fca.5.2.4.load, i64 %.119.0118.i261
  %.242.i263 = load double, ptr %7, align 8, !noalias !215
  %.290.i264 = mul i64 %.119.0118.i261, %.384.i.i251
  %gep121.i265 = getelementptr double, ptr %invariant.gep120.i259, i64 %.290.i264
  store double %.242.i263, ptr %gep121.i265, align 8, !noalias !215
  %exitcond.not.i266 = icmp eq i64 %.188.i262, %.55.fca.5.2.2.load
  br i1 %exitcond.not.i266, label %b97, label %B76.if.i260
b97:
  store ptr null, ptr %retptr, align 8
  ret void
}
declare double @llvm.cos.f64(double)
define internal fastcc void @v74(ptr noalias nonnull writeonly %retptr, ptr readonly %arg.f.4, i64 %arg.i, i64 %arg.run.0.4, ptr %arg.run.1.0.4, i64 %arg.run.1.1.2, ptr %arg.run.1.1.4, ptr readonly %arg.run.1.2.4, i64 %arg.run.1.3.2, ptr %arg.run.1.3.4, ptr %arg.run.1.4.4, i64 %arg.run.5.0.2, ptr %arg.run.5.0.4, ptr %arg.run.5.3.4, ptr readonly %arg.segment.2.4, i64 %arg.segment.2.5.1, double %arg.t, ptr %arg.x.4) unnamed_addr {
entry:
  %.494 = alloca i8, align 1
  store i8 0, ptr %.494, align 1
  call fastcc void @v75(ptr %.494, i64 %arg.run.0.4, ptr %arg.run.1.0.4, i64 %arg.run.1.1.2, ptr %arg.run.1.1.4, ptr %arg.run.1.2.4, i64 %arg.run.1.3.2, ptr %arg.run.1.3.4, ptr %arg.run.1.4.4, i64 %arg.run.5.0.2, ptr %arg.run.5.0.4, ptr %arg.run.5.3.4, ptr %arg.segment.2.4, i64 %arg.segment.2.5.1, double %arg.t, ptr %arg.x.4)
  %.601 = load i8, ptr %.494, align 1
  %.384.i = load i64, ptr %arg.f.4, align 8, !noalias !216
  %.1330 = getelementptr i8, ptr %arg.f.4, i64 152
  %.1331 = load i64, ptr %.1330, align 8
  %.1411627.not = icmp slt i64 %.1331, 1
  br i1 %.1411627.not, label %B254, label %B164.if.lr.ph
B164.if.lr.ph:
  %0 = getelementptr i8, ptr %arg.f.4, i64 480
  %.45.i = load i64, ptr %0, align 8, !noalias !216
  %.46.i = inttoptr i64 %.45.i to ptr
  %invariant.gep = getelementptr double, ptr %.46.i, i64 %arg.i
  %.1854 = getelementptr i8, ptr %arg.f.4, i64 144
  %.1885 = icmp slt i64 %arg.i, 0
  %.1886 = select i1 %.1885, i64 %.384.i, i64 0
  %invariant.gep630 = getelementptr double, ptr %invariant.gep, i64 %.1886
  br label %B164.if
B254:
  %.604 = icmp ne i8 %.601, 0
  %.2052 = zext i1 %.604 to i8
  store i8 %.2052, ptr %retptr, align 1
  ret void
B164.if:
  %.1355.0628 = phi i64 [ 0, %B164.if.lr.ph ], [ %.1424, %B164.if ]
  %.1424 = add nuw nsw i64 %.1355.0628, 1
  %1 = getelementptr double, ptr %arg.run.1.1.4, i64 %.1355.0628
  %.1513 = load double, ptr %1, align 8
  %.1855 = load i64, ptr %.1854, align 8
  %.1856 = add nsw i64 %.1855, %.1355.0628
  %.1856.lobit = lshr i64 %.1856, 63
  %.1884 = add i64 %.1856.lobit, %.1856
  %.1904 = mul i64 %.1884, %.384.i
  %gep631 = getelementptr double, ptr %invariant.gep630, i64 %.1904
  store double %.1513, ptr %gep631, align 8
  %exitcond.not = icmp eq i64 %.1424, %.1331
  br i1 %exitcond.not, label %B254, label %B164.if
}
define internal fastcc void @v75(ptr noalias nonnull writeonly %retptr, i64 %arg.run.0.4, ptr %arg.run.1.0.4, i64 %arg.run.1.1.2, ptr %arg.run.1.1.4, ptr readonly %arg.run.1.2.4, i64 %arg.run.1.3.2, ptr %arg.run.1.3.4, ptr %arg.run.1.4.4, i64 %arg.run.5.0.2, ptr %arg.run.5.0.4, ptr %arg.run.5.3.4, ptr readonly %arg.segment.2.4, i64 %arg.segment.2.5.1, double %arg.t, ptr %arg.x.4) unnamed_addr {
entry:
  %.5.i = fmul double %arg.t, 0x3D06849B86A12B9B
  %.6.i = fadd double %.5.i, 1.000000e-15
  %.765 = fadd double %arg.t, %.6.i
  %.164126.not.i = icmp sgt i64 %arg.run.1.3.2, 0
  br i1 %.164126.not.i, label %B78.if.i, label %b98
B78.if.i:
  %first.2.0129.i = phi double [ %.13.i.i, %B78.if.i ], [ 0x7FF0000000000000, %entry ]
  %.106.0128.i = phi i64 [ %.177.i, %B78.if.i ], [ 0, %entry ]
  %.177.i = add nuw nsw i64 %.106.0128.i, 1
  %0 = getelementptr double, ptr %arg.run.1.1.4, i64 %.106.0128.i
  %.235.i = load double, ptr %0, align 8, !noalias !219
  %.12.i.i = fcmp olt double %.235.i, %first.2.0129.i
  %.13.i.i = select i1 %.12.i.i, double %.235.i, double %first.2.0129.i
  %exitcond.not.i = icmp eq i64 %arg.run.1.3.2, %.177.i
  br i1 %exitcond.not.i, label %b98, label %B78.if.i
b98:
  %first.2.0.lcssa.i = phi double [ 0x7FF0000000000000, %entry ], [ %.13.i.i, %B78.if.i ]
  %.806 = fcmp ugt double %first.2.0.lcssa.i, %.765
  br i1 %.806, label %B626, label %B112.preheader
B112.preheader:
  %.148211.not.i = icmp slt i64 %arg.run.5.0.2, 1
  %.1203 = inttoptr i64 %arg.run.0.4 to ptr
  %.13131567.not = icmp slt i64 %arg.run.1.1.2, 1
  br label %B112
B112:
  %changed.4.0 = phi i1 [ %changed.3.1.lcssa, %b99 ], [ false, %B112.preheader ]
  br i1 %.164126.not.i, label %B162.if, label %B226
B226:
  store double %arg.t, ptr %arg.run.5.3.4, align 8
  br i1 %.148211.not.i, label %b95, label %B58.if.i
B164.i:
  %.44.i.i = getelementptr i8, ptr %2, i64 24
  %.45.i.i = load double, ptr %.44.i.i, align 8, !noalias !222
  %.73.i.i = getelementptr i8, ptr %2, i64 32
  %.74.i.i = load double, ptr %.73.i.i, align 8, !noalias !222
  %.75.i.i = fmul double %.74.i.i, 5.000000e-01
  %.76.i.i = fmul double %.245.i, %.75.i.i
  %.77.i.i = fadd double %.45.i.i, %.76.i.i
  %.78.i.i = fmul double %.245.i, %.77.i.i
  %.87.le.i.i = tail call double @llvm.floor.f64(double %.78.i.i)
  %.92.i.i = fsub double %.78.i.i, %.87.le.i.i
  %.93.i.i = fmul double %.92.i.i, 0x401921FB54442D18
  %.121.i.i = getelementptr i8, ptr %2, i64 40
  %.122.i.i = load double, ptr %.121.i.i, align 8, !noalias !222
  %.126.i.i = fadd double %.122.i.i, %.93.i.i
  %.593.le.i = tail call double @llvm.sin.f64(double %.126.i.i)
  %.598.i = fmul double %.423.i, %.593.le.i
  %.600.i = fadd double %.361.i, %.598.i
  br label %B272.i
B272.i:
  %value.2.1.i = phi double [ %.600.i, %B164.i ], [ %.361.i, %B58.if.i ]
  %1 = getelementptr double, ptr %arg.run.5.0.4, i64 %.90.0213.i
  store double %value.2.1.i, ptr %1, align 8, !noalias !227
  %exitcond.not.i1550 = icmp eq i64 %arg.run.5.0.2, %.161.i
  br i1 %exitcond.not.i1550, label %b95, label %B58.if.i
B58.if.i:
  %.90.0213.i = phi i64 [ %.161.i, %B272.i ], [ 0, %B226 ]
  %.161.i = add nuw nsw i64 %.90.0213.i, 1
  %.238.i = mul i64 %.90.0213.i, %arg.segment.2.5.1
  %2 = getelementptr double, ptr %arg.segment.2.4, i64 %.238.i
  %.242.i = getelementptr i8, ptr %2, i64 48
  %.243.i = load double, ptr %.242.i, align 8, !noalias !227
  %.245.i = fsub double %arg.t, %.243.i
  %.303.i = load double, ptr %2, align 8, !noalias !227
  %.357.i = getelementptr i8, ptr %2, i64 8
  %.358.i = load double, ptr %.357.i, align 8, !noalias !227
  %.360.i = fmul double %.245.i, %.358.i
  %.361.i = fadd double %.303.i, %.360.i
  %.422.i = getelementptr i8, ptr %2, i64 16
  %.423.i = load double, ptr %.422.i, align 8, !noalias !227
  %.424.i = fcmp une double %.423.i, 0.000000e+00
  br i1 %.424.i, label %B164.i, label %B272.i
b95:
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
  %changed.3.1.lcssa = phi i1 [ %changed.4.0, %b95 ], [ %changed.5.2, %B542 ]
  br i1 %.164126.not.i, label %B78.if.i1552, label %b99
B78.if.i1552:
  %first.2.0129.i1553 = phi double [ %.13.i.i1558, %B78.if.i1552 ], [ 0x7FF0000000000000, %B586 ]
  %.106.0128.i1554 = phi i64 [ %.177.i1555, %B78.if.i1552 ], [ 0, %B586 ]
  %.177.i1555 = add nuw nsw i64 %.106.0128.i1554, 1
  %5 = getelementptr double, ptr %arg.run.1.1.4, i64 %.106.0128.i1554
  %.235.i1556 = load double, ptr %5, align 8, !noalias !228
  %.12.i.i1557 = fcmp olt double %.235.i1556, %first.2.0129.i1553
  %.13.i.i1558 = select i1 %.12.i.i1557, double %.235.i1556, double %first.2.0129.i1553
  %exitcond.not.i1559 = icmp eq i64 %arg.run.1.3.2, %.177.i1555
  br i1 %exitcond.not.i1559, label %b99, label %B78.if.i1552
b99:
  %first.2.0.lcssa.i1560 = phi double [ 0x7FF0000000000000, %B586 ], [ %.13.i.i1558, %B78.if.i1552 ]
  %.1617 = fcmp ugt double %first.2.0.lcssa.i1560, %.765
  br i1 %.1617, label %B626.loopexit, label %B112
B626.loopexit:
  %6 = zext i1 %changed.3.1.lcssa to i8
  br label %B626
B626:
  %changed.2.1 = phi i8 [ 0, %b98 ], [ %6, %B626.loopexit ]
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
  %changed.3.11570 = phi i1 [ %changed.5.2, %B542 ], [ %changed.4.0, %b95 ]
  %.1257.01568 = phi i64 [ %.1326, %B542 ], [ 0, %b95 ]
  %.1326 = add nuw nsw i64 %.1257.01568, 1
  %9 = getelementptr i8, ptr %arg.run.1.2.4, i64 %.1257.01568
  %.1392 = load i8, ptr %9, align 1
  %.1396.not = icmp eq i8 %.1392, 0
  %.phi.trans.insert = getelementptr double, ptr %arg.run.1.4.4, i64 %.1257.01568
  %.1523.pre = load double, ptr %.phi.trans.insert, align 8
  br i1 %.1396.not, label %B542, label %B482
}
define internal fastcc noundef i32 @v76(ptr noalias nonnull writeonly %retptr, ptr %arg.f.4, i64 %arg.i, i64 %arg.status) unnamed_addr {
entry:
  %.548 = alloca i64, align 8
  %.1432 = alloca ptr, align 8
  %.2912 = alloca ptr, align 8
  %.352.i = getelementptr i8, ptr %arg.f.4, i64 592
  %.353.i = load i64, ptr %.352.i, align 8, !noalias !231
  %.354.i = inttoptr i64 %.353.i to ptr
  %.692.i = load i64, ptr %arg.f.4, align 8, !noalias !231
  %.116 = icmp slt i64 %arg.i, 0
  %.117 = select i1 %.116, i64 %.692.i, i64 0
  %.118 = add i64 %.117, %arg.i
  %.139 = getelementptr i64, ptr %.354.i, i64 %.118
  %0 = getelementptr i64, ptr %.354.i, i64 %.692.i
  %.199 = getelementptr i64, ptr %0, i64 %.118
  %.539 = getelementptr i8, ptr %arg.f.4, i64 208
  %.1800 = getelementptr i8, ptr %arg.f.4, i64 392
  %.2139 = getelementptr i8, ptr %arg.f.4, i64 400
  %.45.i410 = getelementptr i8, ptr %arg.f.4, i64 384
  %1 = getelementptr i8, ptr %arg.f.4, i64 440
  %2 = getelementptr i8, ptr %arg.f.4, i64 432
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
  %.540 = load i64, ptr %.539, align 8
  %.541 = icmp slt i64 %.201, %.540
  br i1 %.541, label %B172, label %B382
B172:
  store i64 0, ptr %.548, align 8
  call fastcc void @v68(ptr %.548, ptr nonnull %arg.f.4, i64 %arg.i)
  %.564 = load i64, ptr %.548, align 8
  %.578 = icmp eq i64 %.564, 0
  br i1 %.578, label %B226, label %B36.backedge
B226:
  %.45.i = load i64, ptr %1, align 8, !noalias !234
  %.46.i = inttoptr i64 %.45.i to ptr
  %.384.i = load i64, ptr %arg.f.4, align 8, !noalias !234
  %.962 = select i1 %.116, i64 %.384.i, i64 0
  %3 = getelementptr double, ptr %.46.i, i64 %arg.i
  %.984 = getelementptr double, ptr %3, i64 %.962
  %.985 = load double, ptr %.984, align 8
  %.45.i399 = load i64, ptr %2, align 8, !noalias !237
  %.46.i400 = inttoptr i64 %.45.i399 to ptr
  %.idx = mul i64 %.384.i, 80
  %4 = getelementptr i8, ptr %.46.i400, i64 %.idx
  %5 = getelementptr double, ptr %4, i64 %arg.i
  %.1395 = getelementptr double, ptr %5, i64 %.962
  %.1396 = load double, ptr %.1395, align 8
  %.1402 = fcmp olt double %.985, %.1396
  br i1 %.1402, label %common.ret, label %B36.backedge
common.ret:
  store ptr null, ptr %retptr, align 8
  ret i32 0
B382:
  call fastcc void @v69(ptr %.1432, ptr nonnull %arg.f.4, i64 %arg.i, i64 %status.3.1)
  br label %B416
B416:
  %.1801 = load i64, ptr %.1800, align 8
  %.2140 = load i64, ptr %.2139, align 8
  %.2141.not = icmp slt i64 %.1801, %.2140
  br i1 %.2141.not, label %B492, label %B566
B492:
  %.46.i411 = load i64, ptr %.45.i410, align 8, !noalias !240
  %.50.i = inttoptr i64 %.46.i411 to ptr
  %.2518 = getelementptr i8, ptr %.50.i, i64 8
  %.2519 = load double, ptr %.2518, align 8
  %.2523 = fcmp une double %.2519, 0.000000e+00
  br i1 %.2523, label %B566, label %B602
B566:
  %.353.i.i = load i64, ptr %.352.i, align 8, !noalias !243
  %.354.i.i = inttoptr i64 %.353.i.i to ptr
  %.692.i.i = load i64, ptr %arg.f.4, align 8, !noalias !243
  %.102.i = select i1 %.116, i64 %.692.i.i, i64 0
  %6 = getelementptr i64, ptr %.354.i.i, i64 %arg.i
  %.124.i = getelementptr i64, ptr %6, i64 %.102.i
  store i64 -1, ptr %.124.i, align 8, !noalias !248
  %.45.i.i = load i64, ptr %1, align 8, !noalias !249
  %.46.i.i = inttoptr i64 %.45.i.i to ptr
  %.384.i.i = load i64, ptr %arg.f.4, align 8, !noalias !249
  %.513.i = select i1 %.116, i64 %.384.i.i, i64 0
  %7 = getelementptr double, ptr %.46.i.i, i64 %.384.i.i
  %8 = getelementptr double, ptr %7, i64 %arg.i
  %.535.i = getelementptr double, ptr %8, i64 %.513.i
  store double 1.000000e-09, ptr %.535.i, align 8, !noalias !248
  %.353.i487.i = load i64, ptr %.352.i, align 8, !noalias !252
  %.354.i488.i = inttoptr i64 %.353.i487.i to ptr
  %.692.i489.i = load i64, ptr %arg.f.4, align 8, !noalias !252
  %.615.i = select i1 %.116, i64 %.692.i489.i, i64 0
  %.idx.i = mul i64 %.692.i489.i, 24
  %9 = getelementptr i8, ptr %.354.i488.i, i64 %.idx.i
  %10 = getelementptr i64, ptr %9, i64 %arg.i
  %.637.i = getelementptr i64, ptr %10, i64 %.615.i
  store i64 0, ptr %.637.i, align 8, !noalias !248
  %.981.i = getelementptr i8, ptr %arg.f.4, i64 408
  %.982.i = load i64, ptr %.981.i, align 8, !noalias !248
  %.983.i = add nsw i64 %.982.i, -1
  store i64 %.983.i, ptr %.981.i, align 8, !noalias !248
  %.1351.i = getelementptr i8, ptr %arg.f.4, i64 128
  %.1352.i = load i64, ptr %.1351.i, align 8, !noalias !248
  %.1999.i = getelementptr i8, ptr %arg.f.4, i64 112
  %.2000.i = load i64, ptr %.1999.i, align 8, !noalias !248
  %.2627.i = shl nsw i64 %.1352.i, 2
  %.3591.i = getelementptr i8, ptr %arg.f.4, i64 144
  %.3592.i = load i64, ptr %.3591.i, align 8, !noalias !248
  %.3930.i = getelementptr i8, ptr %arg.f.4, i64 152
  %.3931.i = load i64, ptr %.3930.i, align 8, !noalias !248
  %.3932.i = add nsw i64 %.3931.i, %.3592.i
  %.4270.i = getelementptr i8, ptr %arg.f.4, i64 176
  %.4271.i = load i64, ptr %.4270.i, align 8, !noalias !248
  %.4272.i = add nsw i64 %.3932.i, %.4271.i
  br label %B534.if.i
B534.loopexit.i:
  %exitcond513.not.i = icmp eq i64 %.4437.i, 5
  br i1 %exitcond513.not.i, label %common.ret, label %B534.if.i
B536.i:
  %.pn.i = phi i64 [ 60, %switch.4.i ], [ 57, %switch.1.i ], [ 58, %switch.2.i ], [ 59, %switch.3.i ], [ 56, %B534.if.i ]
  %.2000.pn.i = phi i64 [ %.4272.i, %switch.4.i ], [ %.1352.i, %switch.1.i ], [ %.2627.i, %switch.2.i ], [ %.1352.i, %switch.3.i ], [ %.2000.i, %B534.if.i ]
  %.4437.i = add nuw nsw i64 %.4310.0512.i, 1
  %11 = getelementptr i64, ptr %arg.f.4, i64 %.pn.i
  %.45.i498.i = load i64, ptr %11, align 8, !noalias !255
  %.46.i499.i = inttoptr i64 %.45.i498.i to ptr
  %.384.i500.i = load i64, ptr %arg.f.4, align 8, !noalias !255
  %.4612509.not.i = icmp slt i64 %.2000.pn.i, 1
  br i1 %.4612509.not.i, label %B534.loopexit.i, label %B606.if.lr.ph.i
B606.if.lr.ph.i:
  %.4733.i = select i1 %.116, i64 %.384.i500.i, i64 0
  br label %B606.if.i
B534.if.i:
  %.4310.0512.i = phi i64 [ 0, %B566 ], [ %.4437.i, %B534.loopexit.i ]
  switch i64 %.4310.0512.i, label %default.unreachable.i [
    i64 0, label %B536.i
    i64 3, label %switch.3.i
    i64 1, label %switch.1.i
    i64 4, label %switch.4.i
    i64 2, label %switch.2.i
  ]
default.unreachable.i:
  unreachable
switch.1.i:
  br label %B536.i
switch.2.i:
  br label %B536.i
switch.3.i:
  br label %B536.i
switch.4.i:
  br label %B536.i
B606.if.i:
  %.4556.0510.i = phi i64 [ 0, %B606.if.lr.ph.i ], [ %.4625.i, %B606.if.i ]
  %.4625.i = add nuw nsw i64 %.4556.0510.i, 1
  %.4698.i = mul i64 %.4556.0510.i, %.384.i500.i
  %.4702.i = getelementptr double, ptr %.46.i499.i, i64 %.4698.i
  %.4703.i = load double, ptr %.4702.i, align 8, !noalias !248
  %12 = getelementptr double, ptr %.4702.i, i64 %arg.i
  %.4755.i = getelementptr double, ptr %12, i64 %.4733.i
  store double %.4703.i, ptr %.4755.i, align 8, !noalias !248
  %exitcond.not.i = icmp eq i64 %.4625.i, %.2000.pn.i
  br i1 %exitcond.not.i, label %B534.loopexit.i, label %B606.if.i
B602:
  call fastcc void @v70(ptr %.2912, ptr nonnull %arg.f.4, i64 %arg.i, i64 %.1801)
  %.3276 = load i64, ptr %.1800, align 8
  %.3277 = add nsw i64 %.3276, 1
  store i64 %.3277, ptr %.1800, align 8
  br label %B36.backedge
B36.backedge:
  %status.3.1.be = phi i64 [ 0, %B602 ], [ %.564, %B226 ], [ %.564, %B172 ]
  br label %B36
}
define internal fastcc void @v77(ptr noalias nonnull writeonly %retptr, ptr readonly %arg.f.4, i64 %arg.i, double %arg.t, double %arg.h, double %arg.end) unnamed_addr {
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
  %.2573 = alloca { i64, double }, align 8
  %.fca.1.gep324 = getelementptr inbounds i8, ptr %.2573, i64 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %.2573, i8 0, i64 16, i1 false)
  %.2862 = alloca double, align 8
  store double 0.000000e+00, ptr %.2862, align 8
  %.2988 = alloca ptr, align 8
  store ptr null, ptr %.2988, align 8
  %.4203 = alloca i8, align 1
  store i8 0, ptr %.4203, align 1
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(521) %.33, i8 0, i64 521, i1 false)
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(1280) %.fca.3.0.0.gep, i8 0, i64 1280, i1 false)
  call fastcc void @v73(ptr %.33, ptr %arg.f.4, i64 %arg.i)
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
  %.352.i.i = getelementptr i8, ptr %arg.f.4, i64 592
  %.353.i.i = load i64, ptr %.352.i.i, align 8, !noalias !258
  %.354.i.i = inttoptr i64 %.353.i.i to ptr
  %.692.i.i = load i64, ptr %arg.f.4, align 8, !noalias !258
  %.95.i = icmp slt i64 %arg.i, 0
  %.96.i = select i1 %.95.i, i64 %.692.i.i, i64 0
  %0 = getelementptr i64, ptr %.354.i.i, i64 %.692.i.i
  %1 = getelementptr i64, ptr %0, i64 %arg.i
  %.118.i = getelementptr i64, ptr %1, i64 %.96.i
  %.119.i = load i64, ptr %.118.i, align 8, !noalias !263
  %.462.i = getelementptr i8, ptr %arg.f.4, i64 208
  %.463.i = load i64, ptr %.462.i, align 8, !noalias !263
  %.801.i = getelementptr i8, ptr %arg.f.4, i64 128
  %.802.i = load i64, ptr %.801.i, align 8, !noalias !263
  %.1168.i = add nsw i64 %.119.i, 1
  %.1170.i = icmp slt i64 %.1168.i, %.463.i
  br i1 %.1170.i, label %B204.i, label %B226.i
B204.i:
  %.45.i.i = getelementptr i8, ptr %arg.f.4, i64 288
  %.46.i.i = load i64, ptr %.45.i.i, align 8, !noalias !264
  %.50.i.i = inttoptr i64 %.46.i.i to ptr
  %.1187.i = icmp slt i64 %.119.i, -1
  %.1188.i = select i1 %.1187.i, i64 %.463.i, i64 0
  %2 = getelementptr double, ptr %.50.i.i, i64 %.1168.i
  %.1202.i = getelementptr double, ptr %2, i64 %.1188.i
  br label %B322.i
B226.i:
  %.1855.i = getelementptr i8, ptr %arg.f.4, i64 224
  %.1856.i = load i64, ptr %.1855.i, align 8, !noalias !263
  %.45.i376.i = getelementptr i8, ptr %arg.f.4, i64 328
  %.46.i377.i = load i64, ptr %.45.i376.i, align 8, !noalias !267
  %.50.i378.i = inttoptr i64 %.46.i377.i to ptr
  %3 = getelementptr double, ptr %.50.i378.i, i64 %.1856.i
  %.1922.i = getelementptr i8, ptr %3, i64 -8
  br label %B322.i
B322.i:
  %"$phi322.0.2.0.in.i" = phi ptr [ %.1202.i, %B204.i ], [ %.1922.i, %B226.i ]
  %"$phi322.0.2.0.i" = load double, ptr %"$phi322.0.2.0.in.i", align 8, !noalias !263
  %.45.i384.i = getelementptr i8, ptr %arg.f.4, i64 296
  %.46.i385.i = load i64, ptr %.45.i384.i, align 8, !noalias !270
  %.50.i386.i = inttoptr i64 %.46.i385.i to ptr
  %.2300.i = icmp slt i64 %.119.i, 0
  %.2301.i = select i1 %.2300.i, i64 %.463.i, i64 0
  %4 = getelementptr i64, ptr %.50.i386.i, i64 %.119.i
  %.2315.i = getelementptr i64, ptr %4, i64 %.2301.i
  %.2316.i = load i64, ptr %.2315.i, align 8, !noalias !263
  %.2657.i = getelementptr i8, ptr %arg.f.4, i64 248
  %.2658.i = load i64, ptr %.2657.i, align 8, !noalias !263
  %.2659.i = icmp sgt i64 %.2658.i, 0
  br i1 %.2659.i, label %B432.i, label %b84
B432.i:
  %.3001.i = getelementptr i8, ptr %arg.f.4, i64 216
  %.3002.i = load i64, ptr %.3001.i, align 8, !noalias !263
  %.3004.i = mul nsw i64 %.3002.i, %arg.i
  br label %b84
b84:
  %"$phi476.1.2.0.i" = phi i64 [ %.3004.i, %B432.i ], [ 0, %B322.i ]
  %.3018.i = add nsw i64 %"$phi476.1.2.0.i", %.2316.i
  %.3398.i = getelementptr i8, ptr %arg.f.4, i64 304
  %.3399.i = load i64, ptr %.3398.i, align 8, !noalias !263
  %.3406.i = mul nsw i64 %.802.i, 56
  %.3407.i = mul nsw i64 %.3406.i, %.3018.i
  %.3408.i = add nsw i64 %.3399.i, %.3407.i
  %.3409.i = inttoptr i64 %.3408.i to ptr
  %.175117.not.i = icmp sgt i64 %.49.fca.6.2.load, 0
  br i1 %.175117.not.i, label %B76.if.lr.ph.i, label %b87
B76.if.lr.ph.i:
  %5 = getelementptr i8, ptr %arg.f.4, i64 448
  %.45.i.i4192 = load i64, ptr %5, align 8, !noalias !273
  %.46.i.i4193 = inttoptr i64 %.45.i.i4192 to ptr
  %invariant.gep.i = getelementptr double, ptr %.46.i.i4193, i64 %arg.i
  %invariant.gep120.i = getelementptr double, ptr %invariant.gep.i, i64 %.96.i
  br label %B76.if.i
B76.if.i:
  %.119.0118.i = phi i64 [ 0, %B76.if.lr.ph.i ], [ %.188.i, %B76.if.i ]
  %.188.i = add nuw nsw i64 %.119.0118.i, 1
  %.260.i = mul i64 %.119.0118.i, %.692.i.i
  %gep121.i = getelementptr double, ptr %invariant.gep120.i, i64 %.260.i
  %.265.i = load double, ptr %gep121.i, align 8, !noalias !278
  %6 = getelementptr double, ptr %.49.fca.6.4.load, i64 %.119.0118.i
  store double %.265.i, ptr %6, align 8, !noalias !278
  %exitcond.not.i = icmp eq i64 %.188.i, %.49.fca.6.2.load
  br i1 %exitcond.not.i, label %b100, label %B76.if.i
b100:
  %.384.i.i4194.pre = load i64, ptr %arg.f.4, align 8, !noalias !279
  br label %b87
b87:
  %.384.i.i4194 = phi i64 [ %.384.i.i4194.pre, %b100 ], [ %.692.i.i, %b84 ]
  %.175117.not.i4195 = icmp slt i64 %.49.fca.5.10.2.load, 1
  br i1 %.175117.not.i4195, label %b101, label %B76.if.lr.ph.i4196
B76.if.lr.ph.i4196:
  %7 = getelementptr i8, ptr %arg.f.4, i64 536
  %.45.i.i4197 = load i64, ptr %7, align 8, !noalias !279
  %.46.i.i4198 = inttoptr i64 %.45.i.i4197 to ptr
  %invariant.gep.i4199 = getelementptr double, ptr %.46.i.i4198, i64 %arg.i
  %.242.i4201 = select i1 %.95.i, i64 %.384.i.i4194, i64 0
  %invariant.gep120.i4202 = getelementptr double, ptr %invariant.gep.i4199, i64 %.242.i4201
  br label %B76.if.i4203
B76.if.i4203:
  %.119.0118.i4204 = phi i64 [ 0, %B76.if.lr.ph.i4196 ], [ %.188.i4205, %B76.if.i4203 ]
  %.188.i4205 = add nuw nsw i64 %.119.0118.i4204, 1
  %.260.i4206 = mul i64 %.119.0118.i4204, %.384.i.i4194
  %gep121.i4207 = getelementptr double, ptr %invariant.gep120.i4202, i64 %.260.i4206
  %.265.i4208 = load double, ptr %gep121.i4207, align 8, !noalias !284
  %8 = getelementptr double, ptr %.49.fca.5.10.4.load, i64 %.119.0118.i4204
  store double %.265.i4208, ptr %8, align 8, !noalias !284
  %exitcond.not.i4209 = icmp eq i64 %.188.i4205, %.49.fca.5.10.2.load
  br i1 %exitcond.not.i4209, label %b102, label %B76.if.i4203
b102:
  %.384.i.i4211.pre = load i64, ptr %arg.f.4, align 8, !noalias !285
  br label %b101
b101:
  %.384.i.i4211 = phi i64 [ %.384.i.i4211.pre, %b102 ], [ %.384.i.i4194, %b87 ]
  %.175117.not.i4212 = icmp slt i64 %.49.fca.5.11.2.load, 1
  br i1 %.175117.not.i4212, label %b103, label %B76.if.lr.ph.i4213
B76.if.lr.ph.i4213:
  %9 = getelementptr i8, ptr %arg.f.4, i64 544
  %.45.i.i4214 = load i64, ptr %9, align 8, !noalias !285
  %.46.i.i4215 = inttoptr i64 %.45.i.i4214 to ptr
  %invariant.gep.i4216 = getelementptr double, ptr %.46.i.i4215, i64 %arg.i
  %.242.i4218 = select i1 %.95.i, i64 %.384.i.i4211, i64 0
  %invariant.gep120.i4219 = getelementptr double, ptr %invariant.gep.i4216, i64 %.242.i4218
  br label %B76.if.i4220
B76.if.i4220:
  %.119.0118.i4221 = phi i64 [ 0, %B76.if.lr.ph.i4213 ], [ %.188.i4222, %B76.if.i4220 ]
  %.188.i4222 = add nuw nsw i64 %.119.0118.i4221, 1
  %.260.i4223 = mul i64 %.119.0118.i4221, %.384.i.i4211
  %gep121.i4224 = getelementptr double, ptr %invariant.gep120.i4219, i64 %.260.i4223
  %.265.i4225 = load double, ptr %gep121.i4224, align 8, !noalias !290
  %10 = getelementptr double, ptr %.49.fca.5.11.4.load, i64 %.119.0118.i4221
  store double %.265.i4225, ptr %10, align 8, !noalias !290
  %exitcond.not.i4226 = icmp eq i64 %.188.i4222, %.49.fca.5.11.2.load
  br i1 %exitcond.not.i4226, label %b103, label %B76.if.i4220
b103:
  %.2564 = getelementptr i8, ptr %arg.f.4, i64 232
  %.2565 = load i64, ptr %.2564, align 8
  %.2566 = icmp sgt i64 %.2565, 0
  br i1 %.2566, label %B402, label %B508
B402:
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %.2573, i8 0, i64 16, i1 false)
  call fastcc void @v78(ptr %.2573, i64 %.49.fca.0.3.load, ptr %.49.fca.1.0.4.load, ptr %.49.fca.3.2.4.load, ptr %.49.fca.4.0.4.load, i64 %.49.fca.4.0.5.1.load, ptr %.49.fca.4.1.4.load, i64 %.49.fca.4.1.5.0.load, i64 %.49.fca.4.1.5.1.load, i64 %.49.fca.5.0.2.load, ptr %.49.fca.5.0.4.load, ptr %.49.fca.5.3.4.load, ptr %.49.fca.5.11.4.load, i64 %.49.fca.5.11.5.0.load, i64 %.49.fca.5.12.2.load, ptr %.49.fca.5.12.4.load, i64 %.49.fca.6.2.load, ptr %.49.fca.6.4.load, ptr %.3409.i, i64 7, double %arg.t, double %arg.h, ptr %.49.fca.5.10.4.load)
  %.2680.fca.0.load = load i64, ptr %.2573, align 8
  %.2680.fca.1.load = load double, ptr %.fca.1.gep324, align 8
  %.2704 = fmul double %arg.h, %.2680.fca.1.load
  %.2710 = fadd double %arg.t, %.2704
  %.26974254 = icmp slt i64 %.2680.fca.0.load, 0
  %"$phi484.1.2.0" = select i1 %.26974254, double %arg.end, double %.2710
  %.2756 = getelementptr i8, ptr %.49.fca.9.4.load, i64 24
  store i64 %.2680.fca.0.load, ptr %.2756, align 8
  br label %B674
B508:
  %.2788 = icmp sgt i64 %.49.fca.1.3.2.load, 0
  br i1 %.2788, label %B78.if.i, label %B674
B78.if.i:
  %first.2.0129.i = phi double [ %.13.i.i, %B78.if.i ], [ 0x7FF0000000000000, %B508 ]
  %.106.0128.i = phi i64 [ %.177.i, %B78.if.i ], [ 0, %B508 ]
  %.177.i = add nuw nsw i64 %.106.0128.i, 1
  %11 = getelementptr double, ptr %.49.fca.1.1.4.load, i64 %.106.0128.i
  %.235.i = load double, ptr %11, align 8, !noalias !291
  %.12.i.i = fcmp olt double %.235.i, %first.2.0129.i
  %.13.i.i = select i1 %.12.i.i, double %.235.i, double %first.2.0129.i
  %exitcond.not.i4228 = icmp eq i64 %.49.fca.1.3.2.load, %.177.i
  br i1 %exitcond.not.i4228, label %b98, label %B78.if.i
b98:
  %.5.i = fmul double %arg.end, 0x3D06849B86A12B9B
  %.6.i = fadd double %.5.i, 1.000000e-15
  %.2856 = fsub double %arg.end, %.6.i
  %.2857 = fcmp olt double %.13.i.i, %.2856
  br i1 %.2857, label %B630, label %B674
B630:
  store double 0.000000e+00, ptr %.2862, align 8
  call fastcc void @v79(ptr %.2862, i64 %.49.fca.0.3.load, i64 %.49.fca.0.4.load, ptr %.49.fca.1.0.4.load, i64 %.49.fca.1.1.2.load, ptr nonnull %.49.fca.1.1.4.load, ptr %.49.fca.1.2.4.load, i64 %.49.fca.1.3.2.load, ptr %.49.fca.1.3.4.load, ptr %.49.fca.1.4.4.load, i64 %.49.fca.2.1.2.load, i64 %.49.fca.3.0.2.load, ptr %.49.fca.3.0.4.load, i64 %.49.fca.3.0.5.0.load, ptr %.49.fca.3.1.4.load, i64 %.49.fca.3.1.5.1.load, i64 %.49.fca.3.2.2.load, ptr %.49.fca.3.2.4.load, i64 %.49.fca.5.0.2.load, ptr %.49.fca.5.0.4.load, ptr %.49.fca.5.3.4.load, ptr %.49.fca.5.6.4.load, i64 %.49.fca.5.6.5.0.load, ptr %.49.fca.5.11.4.load, i64 %.49.fca.5.11.5.0.load, i64 %.49.fca.5.12.2.load, ptr %.49.fca.5.12.4.load, i64 %.49.fca.6.2.load, ptr %.49.fca.6.4.load, ptr %.49.fca.9.4.load, ptr %.3409.i, i64 7, double %arg.t, double %arg.h, double %arg.end, ptr %.49.fca.5.10.4.load)
  %.2969 = load double, ptr %.2862, align 8
  br label %B674
B674:
  %reached.3.0 = phi double [ %"$phi484.1.2.0", %B402 ], [ %.2969, %B630 ], [ %arg.end, %b98 ], [ %arg.end, %B508 ]
  call fastcc void @v80(ptr %.2988, i64 %.49.fca.0.3.load, ptr %.49.fca.1.0.4.load, i64 %.49.fca.2.1.2.load, i64 %.49.fca.3.0.2.load, ptr %.49.fca.3.0.4.load, i64 %.49.fca.3.0.5.0.load, ptr %.49.fca.3.1.4.load, i64 %.49.fca.3.1.5.1.load, i64 %.49.fca.3.2.2.load, ptr %.49.fca.3.2.4.load, i64 %.49.fca.5.0.2.load, ptr %.49.fca.5.0.4.load, ptr %.49.fca.5.3.4.load, ptr %.49.fca.5.6.4.load, i64 %.49.fca.5.6.5.0.load, ptr %.49.fca.5.11.4.load, i64 %.49.fca.5.11.5.0.load, i64 %.49.fca.6.2.load, ptr %.49.fca.6.4.load, ptr %.49.fca.9.4.load, ptr %.3409.i, i64 7, double %arg.t, double %arg.h, ptr %.49.fca.5.10.4.load, double %reached.3.0)
  %.3138 = getelementptr i8, ptr %.49.fca.9.4.load, i64 24
  %.3139 = load i64, ptr %.3138, align 8
  %.3140 = icmp sgt i64 %.3139, -1
  %.3144 = fcmp olt double %reached.3.0, %arg.end
  %or.cond = select i1 %.3140, i1 true, i1 %.3144
  br i1 %or.cond, label %B766, label %B930
B766:
  br i1 %.175117.not.i, label %B816.if, label %B864
B864:
  %.384.i.i4229 = load i64, ptr %arg.f.4, align 8, !noalias !294
  br i1 %.175117.not.i4195, label %B930, label %B76.if.lr.ph.i4231
B76.if.lr.ph.i4231:
  %12 = getelementptr i8, ptr %arg.f.4, i64 536
  %.45.i.i4232 = load i64, ptr %12, align 8, !noalias !294
  %.46.i.i4233 = inttoptr i64 %.45.i.i4232 to ptr
  %invariant.gep.i4234 = getelementptr double, ptr %.46.i.i4233, i64 %arg.i
  %.272.i = select i1 %.95.i, i64 %.384.i.i4229, i64 0
  %invariant.gep120.i4235 = getelementptr double, ptr %invariant.gep.i4234, i64 %.272.i
  br label %B76.if.i4236
B76.if.i4236:
  %.119.0118.i4237 = phi i64 [ 0, %B76.if.lr.ph.i4231 ], [ %.188.i4238, %B76.if.i4236 ]
  %.188.i4238 = add nuw nsw i64 %.119.0118.i4237, 1
  %13 = getelementptr double, ptr %.49.fca.5.10.4.load, i64 %.119.0118.i4237
  %.242.i4239 = load double, ptr %13, align 8, !noalias !299
  %.290.i = mul i64 %.119.0118.i4237, %.384.i.i4229
  %gep121.i4240 = getelementptr double, ptr %invariant.gep120.i4235, i64 %.290.i
  store double %.242.i4239, ptr %gep121.i4240, align 8, !noalias !299
  %exitcond.not.i4241 = icmp eq i64 %.188.i4238, %.49.fca.5.10.2.load
  br i1 %exitcond.not.i4241, label %B930, label %B76.if.i4236
B930:
  %.3719 = icmp eq i64 %.49.fca.1.3.2.load, 0
  br i1 %.3719, label %common.ret, label %B962
B962:
  %.3750 = load i64, ptr %.3138, align 8
  %.3756 = icmp sgt i64 %.3750, -1
  br i1 %.3756, label %common.ret, label %B1004
common.ret:
  %"$phi1382.1.2.0.pn" = phi i8 [ 0, %B930 ], [ 0, %B962 ], [ 1, %B1082 ], [ %17, %B1372 ]
  %.5650.pn = insertvalue { double, i8 } undef, double %reached.3.0, 0
  %storemerge4191 = insertvalue { double, i8 } %.5650.pn, i8 %"$phi1382.1.2.0.pn", 1
  store { double, i8 } %storemerge4191, ptr %retptr, align 8
  ret void
B1004:
  %.5.i4242 = fmul double %"$phi322.0.2.0.i", 0x3D06849B86A12B9B
  %.6.i4243 = fadd double %.5.i4242, 1.000000e-15
  %.4013 = fsub double %"$phi322.0.2.0.i", %.6.i4243
  %.4015 = fcmp olt double %reached.3.0, %.4013
  br i1 %.4015, label %B1082, label %B1184
B1082:
  %.353.i = load i64, ptr %.352.i.i, align 8, !noalias !300
  %.354.i = inttoptr i64 %.353.i to ptr
  %.692.i = load i64, ptr %arg.f.4, align 8, !noalias !300
  %.4109 = select i1 %.95.i, i64 %.692.i, i64 0
  %.idx = mul i64 %.692.i, 40
  %14 = getelementptr i8, ptr %.354.i, i64 %.idx
  %15 = getelementptr i64, ptr %14, i64 %arg.i
  %.4131 = getelementptr i64, ptr %15, i64 %.4109
  store i64 1, ptr %.4131, align 8
  store i8 0, ptr %.4203, align 1
  call fastcc void @v74(ptr %.4203, ptr nonnull %arg.f.4, i64 %arg.i, i64 %.49.fca.0.4.load, ptr %.49.fca.1.0.4.load, i64 %.49.fca.1.1.2.load, ptr %.49.fca.1.1.4.load, ptr %.49.fca.1.2.4.load, i64 %.49.fca.1.3.2.load, ptr %.49.fca.1.3.4.load, ptr %.49.fca.1.4.4.load, i64 %.49.fca.5.0.2.load, ptr %.49.fca.5.0.4.load, ptr %.49.fca.5.3.4.load, ptr %.3409.i, i64 7, double %reached.3.0, ptr %.49.fca.5.10.4.load)
  %.4312 = load i8, ptr %.4203, align 1
  %.4315.not = icmp eq i8 %.4312, 0
  br i1 %.4315.not, label %B1372, label %common.ret
B1184:
  %.384.i = load i64, ptr %arg.f.4, align 8, !noalias !303
  %.51054258.not = icmp slt i64 %.49.fca.1.1.2.load, 1
  br i1 %.51054258.not, label %B1372, label %B1286.if.lr.ph
B1286.if.lr.ph:
  %16 = getelementptr i8, ptr %arg.f.4, i64 480
  %.45.i = load i64, ptr %16, align 8, !noalias !303
  %.46.i = inttoptr i64 %.45.i to ptr
  %invariant.gep = getelementptr double, ptr %.46.i, i64 %arg.i
  %.5519 = getelementptr i8, ptr %arg.f.4, i64 144
  %.5551 = select i1 %.95.i, i64 %.384.i, i64 0
  %invariant.gep4261 = getelementptr double, ptr %invariant.gep, i64 %.5551
  br label %B1286.if
B1372:
  %17 = zext i1 %.3144 to i8
  br label %common.ret
B816.if:
  %.3183.04256 = phi i64 [ %.3252, %B816.if ], [ 0, %B766 ]
  %.3252 = add nuw nsw i64 %.3183.04256, 1
  %18 = getelementptr double, ptr %.49.fca.5.12.4.load, i64 %.3183.04256
  %.3310 = load double, ptr %18, align 8
  %19 = getelementptr double, ptr %.49.fca.5.10.4.load, i64 %.3183.04256
  store double %.3310, ptr %19, align 8
  %exitcond.not = icmp eq i64 %.49.fca.6.2.load, %.3252
  br i1 %exitcond.not, label %B864, label %B816.if
B1286.if:
  %.5046.04259 = phi i64 [ 0, %B1286.if.lr.ph ], [ %.5118, %B1286.if ]
  %.5118 = add nuw nsw i64 %.5046.04259, 1
  %20 = getelementptr double, ptr %.49.fca.1.1.4.load, i64 %.5046.04259
  %.5178 = load double, ptr %20, align 8
  %.5520 = load i64, ptr %.5519, align 8
  %.5521 = add nsw i64 %.5520, %.5046.04259
  %.5521.lobit = lshr i64 %.5521, 63
  %.5549 = add i64 %.5521.lobit, %.5521
  %.5569 = mul i64 %.5549, %.384.i
  %gep4262 = getelementptr double, ptr %invariant.gep4261, i64 %.5569
  store double %.5178, ptr %gep4262, align 8
  %exitcond4263.not = icmp eq i64 %.5118, %.49.fca.1.1.2.load
  br i1 %exitcond4263.not, label %B1372, label %B1286.if
}
define internal fastcc void @v81(ptr noalias nonnull writeonly %retptr, ptr readonly %arg.f.4, i64 %arg.i, i64 %arg.run) unnamed_addr {
entry:
  %.754 = alloca { [5 x i64], { { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, double, double, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, i8 }, { { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] } }, [13 x { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }], { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, align 8
  %.fca.3.0.0.gep = getelementptr inbounds i8, ptr %.754, i64 528
  %.fca.5.0.2.gep = getelementptr inbounds i8, ptr %.754, i64 872
  %.fca.5.0.4.gep = getelementptr inbounds i8, ptr %.754, i64 888
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(521) %.754, i8 0, i64 521, i1 false)
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(1280) %.fca.3.0.0.gep, i8 0, i64 1280, i1 false)
  %.3672 = alloca ptr, align 8
  %.362 = load i64, ptr %arg.f.4, align 8
  %.700 = getelementptr i8, ptr %arg.f.4, i64 224
  %.701 = load i64, ptr %.700, align 8
  %.352.i.i = getelementptr i8, ptr %arg.f.4, i64 592
  %.353.i.i = load i64, ptr %.352.i.i, align 8, !noalias !306
  %.354.i.i = inttoptr i64 %.353.i.i to ptr
  %.95.i = icmp slt i64 %arg.i, 0
  %.96.i = select i1 %.95.i, i64 %.362, i64 0
  %0 = getelementptr i64, ptr %.354.i.i, i64 %.362
  %1 = getelementptr i64, ptr %0, i64 %arg.i
  %.118.i = getelementptr i64, ptr %1, i64 %.96.i
  %.119.i = load i64, ptr %.118.i, align 8, !noalias !311
  %.462.i = getelementptr i8, ptr %arg.f.4, i64 208
  %.463.i = load i64, ptr %.462.i, align 8, !noalias !311
  %.801.i = getelementptr i8, ptr %arg.f.4, i64 128
  %.802.i = load i64, ptr %.801.i, align 8, !noalias !311
  %.45.i384.i = getelementptr i8, ptr %arg.f.4, i64 296
  %.46.i385.i = load i64, ptr %.45.i384.i, align 8, !noalias !312
  %.50.i386.i = inttoptr i64 %.46.i385.i to ptr
  %.2300.i = icmp slt i64 %.119.i, 0
  %.2301.i = select i1 %.2300.i, i64 %.463.i, i64 0
  %2 = getelementptr i64, ptr %.50.i386.i, i64 %.119.i
  %.2315.i = getelementptr i64, ptr %2, i64 %.2301.i
  %.2316.i = load i64, ptr %.2315.i, align 8, !noalias !311
  %.2657.i = getelementptr i8, ptr %arg.f.4, i64 248
  %.2658.i = load i64, ptr %.2657.i, align 8, !noalias !311
  %.2659.i = icmp sgt i64 %.2658.i, 0
  br i1 %.2659.i, label %B432.i, label %b84
B432.i:
  %.3001.i = getelementptr i8, ptr %arg.f.4, i64 216
  %.3002.i = load i64, ptr %.3001.i, align 8, !noalias !311
  %.3004.i = mul nsw i64 %.3002.i, %arg.i
  br label %b84
b84:
  %"$phi476.1.2.0.i" = phi i64 [ %.3004.i, %B432.i ], [ 0, %entry ]
  %.3018.i = add nsw i64 %"$phi476.1.2.0.i", %.2316.i
  %.3398.i = getelementptr i8, ptr %arg.f.4, i64 304
  %.3399.i = load i64, ptr %.3398.i, align 8, !noalias !311
  %.3406.i = mul nsw i64 %.802.i, 56
  %.3407.i = mul nsw i64 %.3406.i, %.3018.i
  %.3408.i = add nsw i64 %.3407.i, %.3399.i
  %.3409.i = inttoptr i64 %.3408.i to ptr
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(1280) %.fca.3.0.0.gep, i8 0, i64 1280, i1 false)
  call fastcc void @v73(ptr %.754, ptr nonnull %arg.f.4, i64 %arg.i)
  %.770.fca.5.0.2.load = load i64, ptr %.fca.5.0.2.gep, align 8
  %.770.fca.5.0.4.load = load ptr, ptr %.fca.5.0.4.gep, align 8
  %.353.i = getelementptr i8, ptr %arg.f.4, i64 376
  %.354.i = load i64, ptr %.353.i, align 8, !noalias !315
  %.358.i = mul nuw nsw i64 %arg.run, 48
  %.359.i = add nsw i64 %.354.i, %.358.i
  %.360.i = inttoptr i64 %.359.i to ptr
  %.1862 = add nsw i64 %.701, %.362
  %.45.i = getelementptr i8, ptr %arg.f.4, i64 328
  %.46.i = load i64, ptr %.45.i, align 8, !noalias !318
  %.50.i = inttoptr i64 %.46.i to ptr
  %3 = getelementptr i8, ptr %arg.f.4, i64 432
  %.45.i673 = load i64, ptr %3, align 8, !noalias !321
  %.46.i674 = inttoptr i64 %.45.i673 to ptr
  %.384.i = load i64, ptr %arg.f.4, align 8, !noalias !321
  %.2283 = select i1 %.95.i, i64 %.384.i, i64 0
  %.idx = mul i64 %.384.i, 120
  %4 = getelementptr i8, ptr %.46.i674, i64 %.idx
  %5 = getelementptr double, ptr %4, i64 %arg.i
  %.2305 = getelementptr double, ptr %5, i64 %.2283
  %.2306 = load double, ptr %.2305, align 8
  %.2367 = getelementptr i8, ptr %.360.i, i64 16
  %.2368 = load i64, ptr %.2367, align 8
  %.2382 = icmp slt i64 %.2368, 0
  %.2383 = select i1 %.2382, i64 %.1862, i64 0
  %6 = getelementptr double, ptr %.50.i, i64 %.2368
  %.2397 = getelementptr double, ptr %6, i64 %.2383
  %.2398 = load double, ptr %.2397, align 8
  %.2400 = fcmp olt double %.2398, %.2306
  br i1 %.2400, label %B382.preheader, label %common.ret
B382.preheader:
  %.3328 = getelementptr i8, ptr %arg.f.4, i64 64
  %.2485684.not = icmp slt i64 %.362, 1
  %.3667 = getelementptr i8, ptr %arg.f.4, i64 584
  %.148211.not.i = icmp slt i64 %.770.fca.5.0.2.load, 1
  br label %B382
B382:
  br i1 %.2485684.not, label %B586, label %B412.if
B586:
  %.3329 = load i64, ptr %.3328, align 8
  %.3668 = load i64, ptr %.3667, align 8
  call fastcc void @v82(ptr %.3672, ptr nonnull %arg.f.4, i64 %arg.i, i64 %arg.run, i64 %.3329, i64 %.3668)
  %.3727 = load i64, ptr %.2367, align 8
  %.3741 = icmp slt i64 %.3727, 0
  %.3742 = select i1 %.3741, i64 %.1862, i64 0
  %7 = getelementptr double, ptr %.50.i, i64 %.3727
  %.3756 = getelementptr double, ptr %7, i64 %.3742
  %.3757 = load double, ptr %.3756, align 8
  %.3759 = fcmp olt double %.3757, %.2306
  br i1 %.3759, label %B382, label %common.ret
common.ret:
  store ptr null, ptr %retptr, align 8
  ret void
B412.if:
  %.2429.0685 = phi i64 [ %.2498, %b91 ], [ 0, %B382 ]
  %.2498 = add nuw nsw i64 %.2429.0685, 1
  %.2552 = load i64, ptr %.2367, align 8
  %.2553 = add nsw i64 %.2552, %.2429.0685
  %.2567 = icmp slt i64 %.2553, 0
  %.2568 = select i1 %.2567, i64 %.1862, i64 0
  %8 = getelementptr double, ptr %.50.i, i64 %.2553
  %.2582 = getelementptr double, ptr %8, i64 %.2568
  %.2583 = load double, ptr %.2582, align 8
  %.12.i = fcmp olt double %.2306, %.2583
  %.13.i = select i1 %.12.i, double %.2306, double %.2583
  br i1 %.148211.not.i, label %b91, label %B58.if.i
B164.i:
  %.44.i.i = getelementptr i8, ptr %10, i64 24
  %.45.i.i677 = load double, ptr %.44.i.i, align 8, !noalias !324
  %.73.i.i = getelementptr i8, ptr %10, i64 32
  %.74.i.i = load double, ptr %.73.i.i, align 8, !noalias !324
  %.75.i.i = fmul double %.74.i.i, 5.000000e-01
  %.76.i.i = fmul double %.245.i, %.75.i.i
  %.77.i.i = fadd double %.45.i.i677, %.76.i.i
  %.78.i.i = fmul double %.245.i, %.77.i.i
  %.87.le.i.i = tail call double @llvm.floor.f64(double %.78.i.i)
  %.92.i.i = fsub double %.78.i.i, %.87.le.i.i
  %.93.i.i = fmul double %.92.i.i, 0x401921FB54442D18
  %.121.i.i = getelementptr i8, ptr %10, i64 40
  %.122.i.i = load double, ptr %.121.i.i, align 8, !noalias !324
  %.126.i.i = fadd double %.122.i.i, %.93.i.i
  %.593.le.i = tail call double @llvm.sin.f64(double %.126.i.i)
  %.598.i = fmul double %.423.i, %.593.le.i
  %.600.i = fadd double %.361.i, %.598.i
  br label %B272.i
B272.i:
  %value.2.1.i = phi double [ %.600.i, %B164.i ], [ %.361.i, %B58.if.i ]
  %9 = getelementptr double, ptr %.770.fca.5.0.4.load, i64 %.90.0213.i
  store double %value.2.1.i, ptr %9, align 8, !noalias !329
  %exitcond.not.i = icmp eq i64 %.770.fca.5.0.2.load, %.161.i
  br i1 %exitcond.not.i, label %b95, label %B58.if.i
B58.if.i:
  %.90.0213.i = phi i64 [ %.161.i, %B272.i ], [ 0, %B412.if ]
  %.161.i = add nuw nsw i64 %.90.0213.i, 1
  %.idx683 = mul i64 %.90.0213.i, 56
  %10 = getelementptr i8, ptr %.3409.i, i64 %.idx683
  %.242.i = getelementptr i8, ptr %10, i64 48
  %.243.i = load double, ptr %.242.i, align 8, !noalias !329
  %.245.i = fsub double %.13.i, %.243.i
  %.303.i = load double, ptr %10, align 8, !noalias !329
  %.357.i = getelementptr i8, ptr %10, i64 8
  %.358.i675 = load double, ptr %.357.i, align 8, !noalias !329
  %.360.i676 = fmul double %.245.i, %.358.i675
  %.361.i = fadd double %.303.i, %.360.i676
  %.422.i = getelementptr i8, ptr %10, i64 16
  %.423.i = load double, ptr %.422.i, align 8, !noalias !329
  %.424.i = fcmp une double %.423.i, 0.000000e+00
  br i1 %.424.i, label %B164.i, label %B272.i
b95:
  %.384.i.i = load i64, ptr %arg.f.4, align 8, !noalias !330
  %.45.i.i678 = load i64, ptr %.3667, align 8, !noalias !330
  %.46.i.i679 = inttoptr i64 %.45.i.i678 to ptr
  %invariant.gep.i = getelementptr double, ptr %.46.i.i679, i64 %.2429.0685
  br label %B76.if.i
B76.if.i:
  %.119.0118.i = phi i64 [ 0, %b95 ], [ %.188.i, %B76.if.i ]
  %.188.i = add nuw nsw i64 %.119.0118.i, 1
  %11 = getelementptr double, ptr %.770.fca.5.0.4.load, i64 %.119.0118.i
  %.242.i680 = load double, ptr %11, align 8, !noalias !335
  %.290.i = mul i64 %.119.0118.i, %.384.i.i
  %gep121.i = getelementptr double, ptr %invariant.gep.i, i64 %.290.i
  store double %.242.i680, ptr %gep121.i, align 8, !noalias !335
  %exitcond.not.i681 = icmp eq i64 %.188.i, %.770.fca.5.0.2.load
  br i1 %exitcond.not.i681, label %b91, label %B76.if.i
b91:
  %exitcond.not = icmp eq i64 %.362, %.2498
  br i1 %exitcond.not, label %B586, label %B412.if
}
define internal fastcc void @v82(ptr noalias nonnull writeonly initializes((0, 8)) %retptr, ptr readonly %arg.f.4, i64 %arg.i, i64 %arg.run, i64 %arg.function, i64 %arg.u) unnamed_addr {
entry:
  %.357 = getelementptr i8, ptr %arg.f.4, i64 328
  %.358 = load i64, ptr %.357, align 8
  %.353.i = getelementptr i8, ptr %arg.f.4, i64 424
  %.354.i = load i64, ptr %.353.i, align 8, !noalias !336
  %.691.i = getelementptr i8, ptr %arg.f.4, i64 416
  %.692.i = load i64, ptr %.691.i, align 8, !noalias !336
  %.693.i = sub nsw i64 %arg.run, %.692.i
  %.694.i = shl nsw i64 %.693.i, 3
  %.1031.i = getelementptr i8, ptr %arg.f.4, i64 136
  %.1032.i = load i64, ptr %.1031.i, align 8, !noalias !336
  %.1033.i = mul nsw i64 %.694.i, %.1032.i
  %.1370.i = getelementptr i8, ptr %arg.f.4, i64 224
  %.1371.i = load i64, ptr %.1370.i, align 8, !noalias !336
  %.1375.i = mul nsw i64 %.1033.i, %.1371.i
  %.1376.i = add nsw i64 %.1375.i, %.354.i
  %.20 = shl nsw i64 %arg.i, 3
  %.724 = getelementptr i8, ptr %arg.f.4, i64 376
  %.725 = load i64, ptr %.724, align 8
  %.726 = mul nuw nsw i64 %arg.run, 48
  %.727 = add nuw i64 %.726, 16
  %.729 = add i64 %.727, %.725
  %.1066 = getelementptr i8, ptr %arg.f.4, i64 320
  %.1067 = load i64, ptr %.1066, align 8
  %.1404 = getelementptr i8, ptr %arg.f.4, i64 432
  %.1405 = load i64, ptr %.1404, align 8
  %.1744 = load i64, ptr %arg.f.4, align 8
  %.1745 = mul nsw i64 %.1744, 120
  %.1746 = add i64 %.1405, %.20
  %.1747 = add i64 %.1746, %.1745
  %.2084 = getelementptr i8, ptr %arg.f.4, i64 440
  %.2085 = load i64, ptr %.2084, align 8
  %.2086 = add nsw i64 %.2085, %.20
  %.2423 = getelementptr i8, ptr %arg.f.4, i64 448
  %.2424 = load i64, ptr %.2423, align 8
  %.2425 = add nsw i64 %.2424, %.20
  %.2762 = getelementptr i8, ptr %arg.f.4, i64 536
  %.2763 = load i64, ptr %.2762, align 8
  %.2764 = add nsw i64 %.2763, %.20
  %.3101 = getelementptr i8, ptr %arg.f.4, i64 544
  %.3102 = load i64, ptr %.3101, align 8
  %.3103 = add nsw i64 %.3102, %.20
  %.3440 = getelementptr i8, ptr %arg.f.4, i64 480
  %.3441 = load i64, ptr %.3440, align 8
  %.3445 = add nsw i64 %.3441, %.20
  %.3446 = inttoptr i64 %arg.function to ptr
  tail call void %.3446(i64 %.358, i64 %.1376.i, i64 %.729, i64 %.1067, i64 %.1747, i64 %.2086, i64 %.2425, i64 %.2764, i64 %.3103, i64 %arg.u, i64 %.3445)
  store ptr null, ptr %retptr, align 8
  ret void
}
define internal fastcc void @v78(ptr noalias nonnull writeonly %retptr, i64 %arg.run.0.3, ptr %arg.run.1.0.4, ptr %arg.run.3.2.4, ptr readonly %arg.run.4.0.4, i64 %arg.run.4.0.5.1, ptr readonly %arg.run.4.1.4, i64 %arg.run.4.1.5.0, i64 %arg.run.4.1.5.1, i64 %arg.run.5.0.2, ptr %arg.run.5.0.4, ptr %arg.run.5.3.4, ptr readonly %arg.run.5.11.4, i64 %arg.run.5.11.5.0, i64 %arg.run.5.12.2, ptr %arg.run.5.12.4, i64 %arg.run.6.2, ptr readonly %arg.run.6.4, ptr readonly %arg.segment.2.4, i64 %arg.segment.2.5.1, double %arg.step.0, double %arg.step.1, ptr readonly %arg.step.3.4) unnamed_addr {
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
  br i1 %.703768.not.i, label %b104, label %B102.if.i
B102.if.i:
  %.645.0769.i = phi i64 [ %.716.i, %B102.if.i ], [ 0, %B48 ]
  %.716.i = add nuw nsw i64 %.645.0769.i, 1
  %0 = getelementptr double, ptr %arg.run.6.4, i64 %.645.0769.i
  %.774.i = load double, ptr %0, align 8, !noalias !339
  %.779.i = fmul double %.478.i, %.774.i
  %1 = getelementptr double, ptr %arg.step.3.4, i64 %.645.0769.i
  %.813.i = load double, ptr %1, align 8, !noalias !339
  %2 = getelementptr double, ptr %arg.run.5.11.4, i64 %.645.0769.i
  %.846.i = load double, ptr %2, align 8, !noalias !339
  %.848.i = add nsw i64 %.645.0769.i, %arg.run.6.2
  %.862.i = icmp slt i64 %.848.i, 0
  %.863.i = select i1 %.862.i, i64 %arg.run.5.11.5.0, i64 0
  %3 = getelementptr double, ptr %arg.run.5.11.4, i64 %.848.i
  %.877.i = getelementptr double, ptr %3, i64 %.863.i
  %.878.i = load double, ptr %.877.i, align 8, !noalias !339
  %.880.i = fmul double %high.3.1, %.878.i
  %.881.i = fadd double %.846.i, %.880.i
  %.883.i = fmul double %.478.i, %.881.i
  %.884.i = fadd double %.813.i, %.883.i
  %.886.i = fmul double %high.3.1, %.884.i
  %.887.i = fadd double %.779.i, %.886.i
  %4 = getelementptr double, ptr %arg.run.5.12.4, i64 %.645.0769.i
  store double %.887.i, ptr %4, align 8, !noalias !339
  %exitcond.not.i = icmp eq i64 %arg.run.5.12.2, %.716.i
  br i1 %exitcond.not.i, label %b104, label %B102.if.i
b104:
  %.796 = fmul double %arg.step.1, %high.3.1
  %.797 = fadd double %arg.step.0, %.796
  br i1 %.148211.not.i.i.i, label %b88, label %B58.if.i.i.i
B164.i.i.i:
  %.44.i.i.i.i = getelementptr i8, ptr %6, i64 24
  %.45.i.i.i.i = load double, ptr %.44.i.i.i.i, align 8, !noalias !342
  %.73.i.i.i.i = getelementptr i8, ptr %6, i64 32
  %.74.i.i.i.i = load double, ptr %.73.i.i.i.i, align 8, !noalias !342
  %.75.i.i.i.i = fmul double %.74.i.i.i.i, 5.000000e-01
  %.76.i.i.i.i = fmul double %.245.i.i.i, %.75.i.i.i.i
  %.77.i.i.i.i = fadd double %.45.i.i.i.i, %.76.i.i.i.i
  %.78.i.i.i.i = fmul double %.245.i.i.i, %.77.i.i.i.i
  %.87.le.i.i.i.i = tail call double @llvm.floor.f64(double %.78.i.i.i.i)
  %.92.i.i.i.i = fsub double %.78.i.i.i.i, %.87.le.i.i.i.i
  %.93.i.i.i.i = fmul double %.92.i.i.i.i, 0x401921FB54442D18
  %.121.i.i.i.i = getelementptr i8, ptr %6, i64 40
  %.122.i.i.i.i = load double, ptr %.121.i.i.i.i, align 8, !noalias !342
  %.126.i.i.i.i = fadd double %.122.i.i.i.i, %.93.i.i.i.i
  %.593.le.i.i.i = tail call double @llvm.sin.f64(double %.126.i.i.i.i)
  %.598.i.i.i = fmul double %.423.i.i.i, %.593.le.i.i.i
  %.600.i.i.i = fadd double %.361.i.i.i, %.598.i.i.i
  br label %B272.i.i.i
B272.i.i.i:
  %value.2.1.i.i.i = phi double [ %.600.i.i.i, %B164.i.i.i ], [ %.361.i.i.i, %B58.if.i.i.i ]
  %5 = getelementptr double, ptr %arg.run.5.0.4, i64 %.90.0213.i.i.i
  store double %value.2.1.i.i.i, ptr %5, align 8, !noalias !351
  %exitcond.not.i.i.i = icmp eq i64 %arg.run.5.0.2, %.161.i.i.i
  br i1 %exitcond.not.i.i.i, label %b88, label %B58.if.i.i.i
B58.if.i.i.i:
  %.90.0213.i.i.i = phi i64 [ %.161.i.i.i, %B272.i.i.i ], [ 0, %b104 ]
  %.161.i.i.i = add nuw nsw i64 %.90.0213.i.i.i, 1
  %.238.i.i.i = mul i64 %.90.0213.i.i.i, %arg.segment.2.5.1
  %6 = getelementptr double, ptr %arg.segment.2.4, i64 %.238.i.i.i
  %.242.i.i.i = getelementptr i8, ptr %6, i64 48
  %.243.i.i.i = load double, ptr %.242.i.i.i, align 8, !noalias !351
  %.245.i.i.i = fsub double %.797, %.243.i.i.i
  %.303.i.i.i = load double, ptr %6, align 8, !noalias !351
  %.357.i.i.i = getelementptr i8, ptr %6, i64 8
  %.358.i.i.i = load double, ptr %.357.i.i.i, align 8, !noalias !351
  %.360.i.i.i = fmul double %.245.i.i.i, %.358.i.i.i
  %.361.i.i.i = fadd double %.303.i.i.i, %.360.i.i.i
  %.422.i.i.i = getelementptr i8, ptr %6, i64 16
  %.423.i.i.i = load double, ptr %.422.i.i.i, align 8, !noalias !351
  %.424.i.i.i = fcmp une double %.423.i.i.i, 0.000000e+00
  br i1 %.424.i.i.i, label %B164.i.i.i, label %B272.i.i.i
b88:
  store double %.797, ptr %arg.run.5.3.4, align 8, !noalias !352
  tail call void %.992.i.i(ptr nonnull %arg.run.5.3.4, ptr %arg.run.5.12.4, ptr %arg.run.5.0.4, ptr %arg.run.1.0.4, ptr %arg.run.3.2.4), !noalias !352
  br label %B140.i
B140.i:
  %.859.0.i = phi i64 [ 0, %b88 ], [ %.928.i, %B288.i ]
  %exitcond294.not.i = icmp eq i64 %.859.0.i, %spec.select.i
  br i1 %exitcond294.not.i, label %b94, label %B142.i
B142.i:
  %.1005.i = mul i64 %.859.0.i, %arg.run.4.1.5.1
  %7 = getelementptr double, ptr %arg.run.4.1.4, i64 %.1005.i
  %.1009.i = getelementptr i8, ptr %7, i64 16
  %.1010.i = load double, ptr %.1009.i, align 8, !noalias !353
  %.1186.i = mul i64 %.859.0.i, %arg.run.4.0.5.1
  %8 = getelementptr i64, ptr %arg.run.4.0.4, i64 %.1186.i
  br label %B194.if.i
B226.i:
  %9 = getelementptr double, ptr %7, i64 %.1037.0289.i
  %.1249.i = load double, ptr %9, align 8, !noalias !353
  %.1338.i = getelementptr double, ptr %arg.run.3.2.4, i64 %.1191.i
  %.1339.i = load double, ptr %.1338.i, align 8, !noalias !353
  %.1340.i = fmul double %.1249.i, %.1339.i
  %.1342.i = fadd double %value.2.1291.i, %.1340.i
  br label %B286.i
B286.i:
  %value.3.2.i = phi double [ %.1342.i, %B226.i ], [ %value.2.1291.i, %B194.if.i ]
  br i1 %exitcond.not.i1267, label %B288.i, label %B194.if.i
B288.i:
  %.928.i = add nuw i64 %.859.0.i, 1
  %.1361.i = fcmp ogt double %value.3.2.i, 0.000000e+00
  br i1 %.1361.i, label %b94, label %B140.i
B194.if.i:
  %value.2.1291.i = phi double [ %.1010.i, %B142.i ], [ %value.3.2.i, %B286.i ]
  %exitcond.not.i1267 = phi i1 [ false, %B142.i ], [ true, %B286.i ]
  %.1037.0289.i = phi i64 [ 0, %B142.i ], [ 1, %B286.i ]
  %10 = getelementptr i64, ptr %8, i64 %.1037.0289.i
  %.1191.i = load i64, ptr %10, align 8, !noalias !353
  %.1194.i = icmp sgt i64 %.1191.i, -1
  br i1 %.1194.i, label %B226.i, label %B286.i
b94:
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
  %.774.i1273 = load double, ptr %12, align 8, !noalias !354
  %.779.i1274 = fmul double %.478.i1268, %.774.i1273
  %13 = getelementptr double, ptr %arg.step.3.4, i64 %.645.0769.i1271
  %.813.i1275 = load double, ptr %13, align 8, !noalias !354
  %14 = getelementptr double, ptr %arg.run.5.11.4, i64 %.645.0769.i1271
  %.846.i1276 = load double, ptr %14, align 8, !noalias !354
  %.848.i1277 = add nsw i64 %.645.0769.i1271, %arg.run.6.2
  %.862.i1278 = icmp slt i64 %.848.i1277, 0
  %.863.i1279 = select i1 %.862.i1278, i64 %arg.run.5.11.5.0, i64 0
  %15 = getelementptr double, ptr %arg.run.5.11.4, i64 %.848.i1277
  %.877.i1280 = getelementptr double, ptr %15, i64 %.863.i1279
  %.878.i1281 = load double, ptr %.877.i1280, align 8, !noalias !354
  %.880.i1282 = fmul double %high.3.1.theta.2.1, %.878.i1281
  %.881.i1283 = fadd double %.846.i1276, %.880.i1282
  %.883.i1284 = fmul double %.478.i1268, %.881.i1283
  %.884.i1285 = fadd double %.813.i1275, %.883.i1284
  %.886.i1286 = fmul double %high.3.1.theta.2.1, %.884.i1285
  %.887.i1287 = fadd double %.779.i1274, %.886.i1286
  %16 = getelementptr double, ptr %arg.run.5.12.4, i64 %.645.0769.i1271
  store double %.887.i1287, ptr %16, align 8, !noalias !354
  %exitcond.not.i1288 = icmp eq i64 %arg.run.5.12.2, %.716.i1272
  br i1 %exitcond.not.i1288, label %common.ret, label %B102.if.i1270
}
define internal fastcc void @v79(ptr noalias nonnull writeonly %retptr, i64 %arg.run.0.3, i64 %arg.run.0.4, ptr %arg.run.1.0.4, i64 %arg.run.1.1.2, ptr %arg.run.1.1.4, ptr readonly %arg.run.1.2.4, i64 %arg.run.1.3.2, ptr %arg.run.1.3.4, ptr %arg.run.1.4.4, i64 %arg.run.2.1.2, i64 %arg.run.3.0.2, ptr readonly %arg.run.3.0.4, i64 %arg.run.3.0.5.0, ptr writeonly %arg.run.3.1.4, i64 %arg.run.3.1.5.1, i64 %arg.run.3.2.2, ptr %arg.run.3.2.4, i64 %arg.run.5.0.2, ptr %arg.run.5.0.4, ptr %arg.run.5.3.4, ptr %arg.run.5.6.4, i64 %arg.run.5.6.5.0, ptr readonly %arg.run.5.11.4, i64 %arg.run.5.11.5.0, i64 %arg.run.5.12.2, ptr %arg.run.5.12.4, i64 %arg.run.6.2, ptr readonly %arg.run.6.4, ptr %arg.run.9.4, ptr readonly %arg.segment.2.4, i64 %arg.segment.2.5.1, double %arg.step.0, double %arg.step.1, double %arg.step.2, ptr readonly %arg.step.3.4) unnamed_addr {
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
  %.235.i = load double, ptr %0, align 8, !noalias !357
  %.12.i.i = fcmp olt double %.235.i, %first.2.0129.i
  %.13.i.i = select i1 %.12.i.i, double %.235.i, double %first.2.0129.i
  %exitcond.not.i = icmp eq i64 %arg.run.1.3.2, %.177.i
  br i1 %exitcond.not.i, label %b98, label %B78.if.i.backedge
B78.if.i.backedge:
  %first.2.0129.i.be = phi double [ %.13.i.i, %B78.if.i ], [ 0x7FF0000000000000, %b104 ]
  %.106.0128.i.be = phi i64 [ %.177.i, %B78.if.i ], [ 0, %b104 ]
  br label %B78.if.i
b98:
  %.586 = fcmp ult double %.13.i.i, %.584
  br i1 %.586, label %B124, label %common.ret
common.ret:
  %storemerge = phi double [ %arg.step.2, %b98 ], [ %.13.i.i, %b104 ]
  store double %storemerge, ptr %retptr, align 8
  ret void
B124:
  call fastcc void @v80(ptr %.729, i64 %arg.run.0.3, ptr %arg.run.1.0.4, i64 %arg.run.2.1.2, i64 %arg.run.3.0.2, ptr %arg.run.3.0.4, i64 %arg.run.3.0.5.0, ptr %arg.run.3.1.4, i64 %arg.run.3.1.5.1, i64 %arg.run.3.2.2, ptr %arg.run.3.2.4, i64 %arg.run.5.0.2, ptr %arg.run.5.0.4, ptr %arg.run.5.3.4, ptr %arg.run.5.6.4, i64 %arg.run.5.6.5.0, ptr %arg.run.5.11.4, i64 %arg.run.5.11.5.0, i64 %arg.run.6.2, ptr %arg.run.6.4, ptr %arg.run.9.4, ptr %arg.segment.2.4, i64 %arg.segment.2.5.1, double %arg.step.0, double %arg.step.1, ptr %arg.step.3.4, double %.13.i.i)
  %.850 = fsub double %.13.i.i, %arg.step.0
  %.856 = fdiv double %.850, %arg.step.1
  %.478.i = fsub double 1.000000e+00, %.856
  br i1 %.703768.not.i, label %b104, label %B102.if.i
B102.if.i:
  %.645.0769.i = phi i64 [ %.716.i, %B102.if.i ], [ 0, %B124 ]
  %.716.i = add nuw nsw i64 %.645.0769.i, 1
  %1 = getelementptr double, ptr %arg.run.6.4, i64 %.645.0769.i
  %.774.i = load double, ptr %1, align 8, !noalias !360
  %.779.i = fmul double %.478.i, %.774.i
  %2 = getelementptr double, ptr %arg.step.3.4, i64 %.645.0769.i
  %.813.i = load double, ptr %2, align 8, !noalias !360
  %3 = getelementptr double, ptr %arg.run.5.11.4, i64 %.645.0769.i
  %.846.i = load double, ptr %3, align 8, !noalias !360
  %.848.i = add nsw i64 %.645.0769.i, %arg.run.6.2
  %.862.i = icmp slt i64 %.848.i, 0
  %.863.i = select i1 %.862.i, i64 %arg.run.5.11.5.0, i64 0
  %4 = getelementptr double, ptr %arg.run.5.11.4, i64 %.848.i
  %.877.i = getelementptr double, ptr %4, i64 %.863.i
  %.878.i = load double, ptr %.877.i, align 8, !noalias !360
  %.880.i = fmul double %.856, %.878.i
  %.881.i = fadd double %.846.i, %.880.i
  %.883.i = fmul double %.478.i, %.881.i
  %.884.i = fadd double %.813.i, %.883.i
  %.886.i = fmul double %.856, %.884.i
  %.887.i = fadd double %.779.i, %.886.i
  %5 = getelementptr double, ptr %arg.run.5.12.4, i64 %.645.0769.i
  store double %.887.i, ptr %5, align 8, !noalias !360
  %exitcond.not.i1480 = icmp eq i64 %arg.run.5.12.2, %.716.i
  br i1 %exitcond.not.i1480, label %b104, label %B102.if.i
b104:
  store i8 0, ptr %.1201, align 1
  call fastcc void @v75(ptr %.1201, i64 %arg.run.0.4, ptr %arg.run.1.0.4, i64 %arg.run.1.1.2, ptr nonnull %arg.run.1.1.4, ptr %arg.run.1.2.4, i64 %arg.run.1.3.2, ptr %arg.run.1.3.4, ptr %arg.run.1.4.4, i64 %arg.run.5.0.2, ptr %arg.run.5.0.4, ptr %arg.run.5.3.4, ptr %arg.segment.2.4, i64 %arg.segment.2.5.1, double %.13.i.i, ptr %arg.run.5.12.4)
  %.1308 = load i8, ptr %.1201, align 1
  %.1311.not = icmp eq i8 %.1308, 0
  br i1 %.1311.not, label %B78.if.i.backedge, label %common.ret
}
define internal fastcc void @v80(ptr noalias nonnull writeonly %retptr, i64 %arg.run.0.3, ptr %arg.run.1.0.4, i64 %arg.run.2.1.2, i64 %arg.run.3.0.2, ptr readonly %arg.run.3.0.4, i64 %arg.run.3.0.5.0, ptr writeonly %arg.run.3.1.4, i64 %arg.run.3.1.5.1, i64 %arg.run.3.2.2, ptr %arg.run.3.2.4, i64 %arg.run.5.0.2, ptr %arg.run.5.0.4, ptr %arg.run.5.3.4, ptr %arg.run.5.6.4, i64 %arg.run.5.6.5.0, ptr readonly %arg.run.5.11.4, i64 %arg.run.5.11.5.0, i64 %arg.run.6.2, ptr readonly %arg.run.6.4, ptr %arg.run.9.4, ptr readonly %arg.segment.2.4, i64 %arg.segment.2.5.1, double %arg.step.0, double %arg.step.1, ptr readonly %arg.step.3.4, double %arg.until) unnamed_addr {
entry:
  %.5.i = fmul double %arg.until, 0x3D06849B86A12B9B
  %.6.i = fadd double %.5.i, 1.000000e-15
  %.510 = fsub double %arg.until, %.6.i
  %.731 = icmp slt i64 %arg.run.5.6.5.0, 1
  br i1 %.731, label %B0.endif.else.endif.if, label %B0.endif.else.endif.endif, !prof !81
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
  br i1 %.703768.not.i, label %b104, label %B102.if.i
B102.if.i:
  %.645.0769.i = phi i64 [ %.716.i, %B102.if.i ], [ 0, %B244 ]
  %.716.i = add nuw nsw i64 %.645.0769.i, 1
  %2 = getelementptr double, ptr %arg.run.6.4, i64 %.645.0769.i
  %.774.i = load double, ptr %2, align 8, !noalias !363
  %.779.i = fmul double %.478.i, %.774.i
  %3 = getelementptr double, ptr %arg.step.3.4, i64 %.645.0769.i
  %.813.i = load double, ptr %3, align 8, !noalias !363
  %4 = getelementptr double, ptr %arg.run.5.11.4, i64 %.645.0769.i
  %.846.i = load double, ptr %4, align 8, !noalias !363
  %.848.i = add nsw i64 %.645.0769.i, %arg.run.6.2
  %.862.i = icmp slt i64 %.848.i, 0
  %.863.i = select i1 %.862.i, i64 %arg.run.5.11.5.0, i64 0
  %5 = getelementptr double, ptr %arg.run.5.11.4, i64 %.848.i
  %.877.i = getelementptr double, ptr %5, i64 %.863.i
  %.878.i = load double, ptr %.877.i, align 8, !noalias !363
  %.880.i = fmul double %.13.i, %.878.i
  %.881.i = fadd double %.846.i, %.880.i
  %.883.i = fmul double %.478.i, %.881.i
  %.884.i = fadd double %.813.i, %.883.i
  %.886.i = fmul double %.13.i, %.884.i
  %.887.i = fadd double %.779.i, %.886.i
  %6 = getelementptr double, ptr %.824, i64 %.645.0769.i
  store double %.887.i, ptr %6, align 8, !noalias !363
  %exitcond.not.i = icmp eq i64 %.799, %.716.i
  br i1 %exitcond.not.i, label %b104, label %B102.if.i
b104:
  br i1 %.148211.not.i.i.i, label %b88, label %B58.if.i.i.i
B164.i.i.i:
  %.44.i.i.i.i = getelementptr i8, ptr %8, i64 24
  %.45.i.i.i.i = load double, ptr %.44.i.i.i.i, align 8, !noalias !366
  %.73.i.i.i.i = getelementptr i8, ptr %8, i64 32
  %.74.i.i.i.i = load double, ptr %.73.i.i.i.i, align 8, !noalias !366
  %.75.i.i.i.i = fmul double %.74.i.i.i.i, 5.000000e-01
  %.76.i.i.i.i = fmul double %.245.i.i.i, %.75.i.i.i.i
  %.77.i.i.i.i = fadd double %.45.i.i.i.i, %.76.i.i.i.i
  %.78.i.i.i.i = fmul double %.245.i.i.i, %.77.i.i.i.i
  %.87.le.i.i.i.i = tail call double @llvm.floor.f64(double %.78.i.i.i.i)
  %.92.i.i.i.i = fsub double %.78.i.i.i.i, %.87.le.i.i.i.i
  %.93.i.i.i.i = fmul double %.92.i.i.i.i, 0x401921FB54442D18
  %.121.i.i.i.i = getelementptr i8, ptr %8, i64 40
  %.122.i.i.i.i = load double, ptr %.121.i.i.i.i, align 8, !noalias !366
  %.126.i.i.i.i = fadd double %.122.i.i.i.i, %.93.i.i.i.i
  %.593.le.i.i.i = tail call double @llvm.sin.f64(double %.126.i.i.i.i)
  %.598.i.i.i = fmul double %.423.i.i.i, %.593.le.i.i.i
  %.600.i.i.i = fadd double %.361.i.i.i, %.598.i.i.i
  br label %B272.i.i.i
B272.i.i.i:
  %value.2.1.i.i.i = phi double [ %.600.i.i.i, %B164.i.i.i ], [ %.361.i.i.i, %B58.if.i.i.i ]
  %7 = getelementptr double, ptr %arg.run.5.0.4, i64 %.90.0213.i.i.i
  store double %value.2.1.i.i.i, ptr %7, align 8, !noalias !375
  %exitcond.not.i.i.i = icmp eq i64 %arg.run.5.0.2, %.161.i.i.i
  br i1 %exitcond.not.i.i.i, label %b88, label %B58.if.i.i.i
B58.if.i.i.i:
  %.90.0213.i.i.i = phi i64 [ %.161.i.i.i, %B272.i.i.i ], [ 0, %b104 ]
  %.161.i.i.i = add nuw nsw i64 %.90.0213.i.i.i, 1
  %.238.i.i.i = mul i64 %.90.0213.i.i.i, %arg.segment.2.5.1
  %8 = getelementptr double, ptr %arg.segment.2.4, i64 %.238.i.i.i
  %.242.i.i.i = getelementptr i8, ptr %8, i64 48
  %.243.i.i.i = load double, ptr %.242.i.i.i, align 8, !noalias !375
  %.245.i.i.i = fsub double %.1065, %.243.i.i.i
  %.303.i.i.i = load double, ptr %8, align 8, !noalias !375
  %.357.i.i.i = getelementptr i8, ptr %8, i64 8
  %.358.i.i.i = load double, ptr %.357.i.i.i, align 8, !noalias !375
  %.360.i.i.i = fmul double %.245.i.i.i, %.358.i.i.i
  %.361.i.i.i = fadd double %.303.i.i.i, %.360.i.i.i
  %.422.i.i.i = getelementptr i8, ptr %8, i64 16
  %.423.i.i.i = load double, ptr %.422.i.i.i, align 8, !noalias !375
  %.424.i.i.i = fcmp une double %.423.i.i.i, 0.000000e+00
  br i1 %.424.i.i.i, label %B164.i.i.i, label %B272.i.i.i
b88:
  store double %.1065, ptr %arg.run.5.3.4, align 8, !noalias !376
  tail call void %.992.i.i(ptr nonnull %arg.run.5.3.4, ptr %.824, ptr %arg.run.5.0.4, ptr %arg.run.1.0.4, ptr %arg.run.3.2.4), !noalias !376
  %.649.i = load i64, ptr %.912, align 8, !noalias !377
  br i1 %.754872.not.i, label %b89, label %B116.if.lr.ph.i
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
  %.821.i = load double, ptr %9, align 8, !noalias !377
  %.898.i = mul i64 %.698.0873.i, %arg.run.3.1.5.1
  %gep876.i = getelementptr double, ptr %invariant.gep875.i, i64 %.898.i
  store double %.821.i, ptr %gep876.i, align 8, !noalias !377
  %exitcond.not.i3008 = icmp eq i64 %.767.i, %arg.run.3.2.2
  br i1 %exitcond.not.i3008, label %b89, label %B116.if.i
b89:
  %.922.i = add nsw i64 %.649.i, 1
  store i64 %.922.i, ptr %.912, align 8, !noalias !377
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
  br i1 %.743, label %B0.endif.else.endif.endif.if, label %B0.endif.else.endif.endif.endif, !prof !81
B0.endif.else.endif.endif.if:
  br label %B0.endif.else.endif.endif.endif
B0.endif.else.endif.endif.endif:
  %.711.sroa.13.1 = phi i64 [ 0, %B0.endif.else.endif.endif.if ], [ %.740, %B0.endif.else.endif.endif ]
  %.748.not = icmp slt i64 %.740, %arg.run.5.6.5.0
  br i1 %.748.not, label %B0.endif.endif, label %B0.endif.else.endif.endif.endif.if, !prof !106
B0.endif.else.endif.endif.endif.if:
  br label %B0.endif.endif
}
define internal fastcc void @v83(ptr noalias nonnull writeonly %retptr, ptr readonly %arg.f.4, i64 %arg.i, double %arg.t, double %arg.h) unnamed_addr {
entry:
  %.20 = alloca { [5 x i64], { { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, double, double, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, i8 }, { { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] } }, [13 x { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }], { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, align 8
  %.fca.1.1.4.gep = getelementptr inbounds i8, ptr %.20, i64 128
  %.fca.1.3.2.gep = getelementptr inbounds i8, ptr %.20, i64 224
  %.fca.2.2.gep56 = getelementptr inbounds i8, ptr %.20, i64 448
  %.fca.3.0.0.gep = getelementptr inbounds i8, ptr %.20, i64 528
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(521) %.20, i8 0, i64 521, i1 false)
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(1280) %.fca.3.0.0.gep, i8 0, i64 1280, i1 false)
  call fastcc void @v73(ptr %.20, ptr %arg.f.4, i64 %arg.i)
  %.36.fca.1.1.4.load = load ptr, ptr %.fca.1.1.4.gep, align 8
  %.36.fca.1.3.2.load = load i64, ptr %.fca.1.3.2.gep, align 8
  %.36.fca.2.2.load = load double, ptr %.fca.2.2.gep56, align 8
  %.352.i.i = getelementptr i8, ptr %arg.f.4, i64 592
  %.353.i.i = load i64, ptr %.352.i.i, align 8, !noalias !378
  %.354.i.i = inttoptr i64 %.353.i.i to ptr
  %.692.i.i = load i64, ptr %arg.f.4, align 8, !noalias !378
  %.95.i = icmp slt i64 %arg.i, 0
  %.96.i = select i1 %.95.i, i64 %.692.i.i, i64 0
  %0 = getelementptr i64, ptr %.354.i.i, i64 %.692.i.i
  %1 = getelementptr i64, ptr %0, i64 %arg.i
  %.118.i = getelementptr i64, ptr %1, i64 %.96.i
  %.119.i = load i64, ptr %.118.i, align 8, !noalias !383
  %.462.i = getelementptr i8, ptr %arg.f.4, i64 208
  %.463.i = load i64, ptr %.462.i, align 8, !noalias !383
  %.1168.i = add nsw i64 %.119.i, 1
  %.1170.i = icmp slt i64 %.1168.i, %.463.i
  br i1 %.1170.i, label %B204.i, label %B226.i
B204.i:
  %.45.i.i = getelementptr i8, ptr %arg.f.4, i64 288
  %.46.i.i = load i64, ptr %.45.i.i, align 8, !noalias !384
  %.50.i.i = inttoptr i64 %.46.i.i to ptr
  %.1187.i = icmp slt i64 %.119.i, -1
  %.1188.i = select i1 %.1187.i, i64 %.463.i, i64 0
  %2 = getelementptr double, ptr %.50.i.i, i64 %.1168.i
  %.1202.i = getelementptr double, ptr %2, i64 %.1188.i
  br label %B322.i
B226.i:
  %.1855.i = getelementptr i8, ptr %arg.f.4, i64 224
  %.1856.i = load i64, ptr %.1855.i, align 8, !noalias !383
  %.45.i376.i = getelementptr i8, ptr %arg.f.4, i64 328
  %.46.i377.i = load i64, ptr %.45.i376.i, align 8, !noalias !387
  %.50.i378.i = inttoptr i64 %.46.i377.i to ptr
  %3 = getelementptr double, ptr %.50.i378.i, i64 %.1856.i
  %.1922.i = getelementptr i8, ptr %3, i64 -8
  br label %B322.i
B322.i:
  %"$phi322.0.2.0.in.i" = phi ptr [ %.1202.i, %B204.i ], [ %.1922.i, %B226.i ]
  %"$phi322.0.2.0.i" = load double, ptr %"$phi322.0.2.0.in.i", align 8, !noalias !383
  %4 = getelementptr i8, ptr %arg.f.4, i64 432
  %.45.i = load i64, ptr %4, align 8, !noalias !390
  %.46.i = inttoptr i64 %.45.i to ptr
  %.idx = mul i64 %.692.i.i, 96
  %5 = getelementptr i8, ptr %.46.i, i64 %.idx
  %6 = getelementptr double, ptr %5, i64 %arg.i
  %.912 = getelementptr double, ptr %6, i64 %.96.i
  %.913 = load double, ptr %.912, align 8
  %.1255 = getelementptr i8, ptr %arg.f.4, i64 232
  %.1256 = load i64, ptr %.1255, align 8
  %.1260 = icmp sgt i64 %.1256, 0
  %.12.i.i = fcmp olt double %.36.fca.2.2.load, %arg.h
  %.13.i.i = select i1 %.12.i.i, double %.36.fca.2.2.load, double %arg.h
  %.598.i = icmp sgt i64 %.36.fca.1.3.2.load, 0
  br i1 %.598.i, label %B78.if.i.i, label %b105
B78.if.i.i:
  %first.2.0129.i.i = phi double [ %.13.i.i.i, %B78.if.i.i ], [ 0x7FF0000000000000, %B322.i ]
  %.106.0128.i.i = phi i64 [ %.177.i.i, %B78.if.i.i ], [ 0, %B322.i ]
  %.177.i.i = add nuw nsw i64 %.106.0128.i.i, 1
  %7 = getelementptr double, ptr %.36.fca.1.1.4.load, i64 %.106.0128.i.i
  %.235.i.i = load double, ptr %7, align 8, !noalias !393
  %.12.i.i.i = fcmp olt double %.235.i.i, %first.2.0129.i.i
  %.13.i.i.i = select i1 %.12.i.i.i, double %.235.i.i, double %first.2.0129.i.i
  %exitcond.not.i.i = icmp eq i64 %.36.fca.1.3.2.load, %.177.i.i
  br i1 %exitcond.not.i.i, label %b106, label %B78.if.i.i
b106:
  %.5.i.i = fmul double %"$phi322.0.2.0.i", 0x3D06849B86A12B9B
  %.6.i.i = fadd double %.5.i.i, 1.000000e-15
  %.818.i = fsub double %"$phi322.0.2.0.i", %.6.i.i
  %.820.i = fcmp uge double %.13.i.i.i, %.818.i
  %brmerge.i = select i1 %.820.i, i1 true, i1 %.1260
  %arg.segment.1.mux.i = select i1 %.820.i, double %"$phi322.0.2.0.i", double %.13.i.i.i
  br i1 %brmerge.i, label %b105, label %B200.i
B200.i:
  %.830.i = fsub double %.13.i.i.i, %arg.t
  %.833.i = fsub double %arg.t, %.913
  %.834.i = fcmp ult double %.830.i, %.833.i
  br i1 %.834.i, label %B232.i, label %b105
B232.i:
  %.12.i999.i = fcmp olt double %.833.i, %.13.i.i
  %.13.i1000.i = select i1 %.12.i999.i, double %.833.i, double %.13.i.i
  br label %b105
b105:
  %wanted.2.0.sink.i = phi double [ %.13.i.i, %B322.i ], [ %.13.i.i, %B200.i ], [ %.13.i1000.i, %B232.i ], [ %.13.i.i, %b106 ]
  %arg.segment.1.sink.i = phi double [ %"$phi322.0.2.0.i", %B322.i ], [ %.13.i.i.i, %B200.i ], [ %"$phi322.0.2.0.i", %B232.i ], [ %arg.segment.1.mux.i, %b106 ]
  store double %wanted.2.0.sink.i, ptr %retptr, align 8
  %retptr.repack286 = getelementptr inbounds i8, ptr %retptr, i64 8
  store double %arg.segment.1.sink.i, ptr %retptr.repack286, align 8
  ret void
}
define noundef i64 @integrate_lanes(ptr initializes((408, 416)) %job) local_unnamed_addr {
  %.1033.i.i.i = alloca { double, i8 }, align 8
  %.1661.i.i.i = alloca ptr, align 8
  %.2385.i.i.i = alloca ptr, align 8
  %.3921.i.i.i = alloca ptr, align 8
  %.49.i.i2091.i.i = alloca { [5 x i64], { { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, double, double, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, i8 }, { { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] } }, [13 x { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }], { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, align 8
  %.665.i.i.i = alloca [2 x double], align 8
  %.49.i.i.i.i = alloca { [5 x i64], { { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, double, double, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, i8 }, { { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] } }, [13 x { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }], { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, align 8
  %.17657.i.i = alloca ptr, align 8
  %.2589.i = alloca ptr, align 8
  call void @llvm.lifetime.start.p0(ptr nonnull %.2589.i)
  store ptr null, ptr %.2589.i, align 8, !noalias !398
  %.698.i = load i64, ptr %job, align 8, !noalias !398
  %.1036.i = getelementptr i8, ptr %job, i64 120
  %.1037.i = load i64, ptr %.1036.i, align 8, !noalias !398
  %1 = getelementptr i8, ptr %job, i64 568
  %.45.i.i = load i64, ptr %1, align 8, !noalias !402
  %.46.i.i = inttoptr i64 %.45.i.i to ptr
  %.1730.i = getelementptr i8, ptr %job, i64 192
  %.1731.i = load i64, ptr %.1730.i, align 8, !noalias !398
  %.1732.i = inttoptr i64 %.1731.i to ptr
  %.2134.i = getelementptr i8, ptr %job, i64 408
  store i64 %.698.i, ptr %.2134.i, align 8, !noalias !398
  %spec.select.i = tail call i64 @llvm.smax.i64(i64 %.698.i, i64 0)
  %.2336449.not.i = icmp slt i64 %.1037.i, 1
  %.352.i.i = getelementptr i8, ptr %job, i64 592
  br label %B360.i
B360.i:
  %.2159.0.i = phi i64 [ 0, %0 ], [ %.2228.i, %B456.i ]
  %exitcond454.not.i = icmp eq i64 %.2159.0.i, %spec.select.i
  br i1 %exitcond454.not.i, label %B552.i, label %B360.if.i
B456.i:
  %.353.i.i = load i64, ptr %.352.i.i, align 8, !noalias !405
  %.354.i.i = inttoptr i64 %.353.i.i to ptr
  %2 = getelementptr i64, ptr %.354.i.i, i64 %.2159.0.i
  store i64 -1, ptr %2, align 8, !noalias !398
  store ptr null, ptr %.2589.i, align 8, !noalias !398
  %.2595.i = call fastcc i32 @v67(ptr %.2589.i, ptr nonnull %job, i64 %.2159.0.i)
  %.2597.not.i = icmp eq i32 %.2595.i, 0
  br i1 %.2597.not.i, label %B360.i, label %b107, !prof !106
B552.i:
  %.2974.i = load i64, ptr %.2134.i, align 8, !noalias !398
  %.2975.i = icmp sgt i64 %.2974.i, 0
  br i1 %.2975.i, label %B596.preheader.i, label %b107
B596.preheader.i:
  %3 = getelementptr i8, ptr %job, i64 432
  %4 = getelementptr i8, ptr %job, i64 440
  %.1598.i.i = getelementptr i8, ptr %job, i64 160
  %.45.i2081.i.i = getelementptr i8, ptr %job, i64 336
  %.45.i2083.i.i = getelementptr i8, ptr %job, i64 328
  %.4255.i.i = getelementptr i8, ptr %job, i64 448
  %.4594.i.i = getelementptr i8, ptr %job, i64 456
  %.4933.i.i = getelementptr i8, ptr %job, i64 472
  %.5272.i.i = getelementptr i8, ptr %job, i64 480
  %.5611.i.i = getelementptr i8, ptr %job, i64 488
  %.5950.i.i = getelementptr i8, ptr %job, i64 496
  %.6289.i.i = getelementptr i8, ptr %job, i64 504
  %.1942.i.i = getelementptr i8, ptr %job, i64 232
  %.fca.1.gep78.i.i.i = getelementptr inbounds i8, ptr %.665.i.i.i, i64 8
  %5 = getelementptr i8, ptr %job, i64 560
  %.462.i.i2101.i.i = getelementptr i8, ptr %job, i64 208
  %.801.i.i2103.i.i = getelementptr i8, ptr %job, i64 128
  %.45.i384.i.i2105.i.i = getelementptr i8, ptr %job, i64 296
  %.2657.i.i2112.i.i = getelementptr i8, ptr %job, i64 248
  %.3001.i.i2184.i.i = getelementptr i8, ptr %job, i64 216
  %.3398.i.i2118.i.i = getelementptr i8, ptr %job, i64 304
  %.fca.5.0.2.gep.i.i2124.i.i = getelementptr inbounds i8, ptr %.49.i.i2091.i.i, i64 872
  %.fca.5.0.4.gep.i.i2125.i.i = getelementptr inbounds i8, ptr %.49.i.i2091.i.i, i64 888
  %6 = getelementptr i8, ptr %job, i64 464
  %.fca.5.0.2.gep.i.i.i.i = getelementptr inbounds i8, ptr %.49.i.i.i.i, i64 872
  %.fca.5.0.4.gep.i.i.i.i = getelementptr inbounds i8, ptr %.49.i.i.i.i, i64 888
  %.6934.i.i = getelementptr i8, ptr %job, i64 32
  %.9646.i.i = getelementptr i8, ptr %job, i64 512
  %.9985.i.i = getelementptr i8, ptr %job, i64 520
  %.10324.i.i = getelementptr i8, ptr %job, i64 536
  %.10665.i.i = getelementptr i8, ptr %job, i64 48
  %.11004.i.i = getelementptr i8, ptr %job, i64 552
  %.12360.i.i = getelementptr i8, ptr %job, i64 528
  %.353.i2187.i.i = getelementptr i8, ptr %job, i64 376
  %.14196.i.i = getelementptr i8, ptr %job, i64 40
  %.14874.i.i = getelementptr i8, ptr %job, i64 544
  %.fca.1.gep430.i.i.i = getelementptr inbounds i8, ptr %.1033.i.i.i, i64 8
  %.2038.i.i.i = getelementptr i8, ptr %job, i64 72
  %.1855.i.i.i.i = getelementptr i8, ptr %job, i64 224
  %.45.i555.i.i.i = getelementptr i8, ptr %job, i64 384
  %.15998.i.i = getelementptr i8, ptr %job, i64 56
  %.17354.i.i = getelementptr i8, ptr %job, i64 576
  br label %B596.i
B596.i:
  call void @llvm.lifetime.start.p0(ptr nonnull %.17657.i.i), !noalias !398
  store ptr null, ptr %.17657.i.i, align 8, !noalias !408
  %.356.i.i = load i64, ptr %job, align 8, !noalias !408
  %.353.i.i.i = load i64, ptr %.352.i.i, align 8, !noalias !412
  %.354.i.i.i = inttoptr i64 %.353.i.i.i to ptr
  %.45.i.i.i = load i64, ptr %3, align 8, !noalias !415
  %.46.i.i.i = inttoptr i64 %.45.i.i.i to ptr
  %.45.i2070.i.i = load i64, ptr %4, align 8, !noalias !418
  %.46.i2071.i.i = inttoptr i64 %.45.i2070.i.i to ptr
  %.1599.i.i = load i64, ptr %.1598.i.i, align 8, !noalias !408
  %.1600.i.i = icmp sgt i64 %.1599.i.i, 0
  br i1 %.1600.i.i, label %B266.i.i, label %B224.i.i
B224.i.i:
  %.1943.i.i = load i64, ptr %.1942.i.i, align 8, !noalias !408
  %.1944.i.i = icmp sgt i64 %.1943.i.i, 0
  br label %B266.i.i
B266.i.i:
  %"$phi266.0.2.0.i.i" = phi i1 [ true, %B596.i ], [ %.1944.i.i, %B224.i.i ]
  %.46.i2082.i.i = load i64, ptr %.45.i2081.i.i, align 8, !noalias !421
  %.50.i.i.i = inttoptr i64 %.46.i2082.i.i to ptr
  %.46.i2084.i.i = load i64, ptr %.45.i2083.i.i, align 8, !noalias !424
  %.50.i2085.i.i = inttoptr i64 %.46.i2084.i.i to ptr
  %.2696.i.i = getelementptr i8, ptr %.50.i.i.i, i64 16
  %.2697.i.i = load double, ptr %.2696.i.i, align 8, !noalias !408
  %.2698.i.i = fcmp une double %.2697.i.i, 0.000000e+00
  %.27852261.not.i.i = icmp slt i64 %.356.i.i, 1
  br i1 %.27852261.not.i.i, label %B484.i.i, label %B434.if.lr.ph.i.i
B434.if.lr.ph.i.i:
  %.idx2061.i.i = mul i64 %.356.i.i, 24
  %7 = getelementptr i8, ptr %.354.i.i.i, i64 %.idx2061.i.i
  br label %B434.if.i.i
B484.loopexit.i.i:
  %8 = select i1 %.2879.i.i, i64 8, i64 16
  br label %B484.i.i
B484.i.i:
  %moves.2.0.lcssa.i.i = phi i64 [ 16, %B266.i.i ], [ %8, %B484.loopexit.i.i ]
  %"$phi558.0.2.0.in.i.i" = getelementptr i8, ptr %job, i64 %moves.2.0.lcssa.i.i
  %"$phi558.0.2.0.i.i" = load i64, ptr %"$phi558.0.2.0.in.i.i", align 8, !noalias !408
  %.4256.i.i = load i64, ptr %.4255.i.i, align 8, !noalias !408
  %.4595.i.i = load i64, ptr %.4594.i.i, align 8, !noalias !408
  %.4934.i.i = load i64, ptr %.4933.i.i, align 8, !noalias !408
  %.5273.i.i = load i64, ptr %.5272.i.i, align 8, !noalias !408
  %.5612.i.i = load i64, ptr %.5611.i.i, align 8, !noalias !408
  %.5951.i.i = load i64, ptr %.5950.i.i, align 8, !noalias !408
  %.6290.i.i = load i64, ptr %.6289.i.i, align 8, !noalias !408
  %.6291.i.i = inttoptr i64 %"$phi558.0.2.0.i.i" to ptr
  tail call void %.6291.i.i(i64 %.45.i2070.i.i, i64 %.4256.i.i, i64 %.4595.i.i, i64 %.4934.i.i, i64 %.5273.i.i, i64 %.5612.i.i, i64 %.5951.i.i, i64 %.6290.i.i), !noalias !408
  br i1 %.27852261.not.i.i, label %B1040.i.i, label %B892.if.lr.ph.i.i
B892.if.lr.ph.i.i:
  %.idx.i2093.i.i = mul i64 %.356.i.i, 88
  %9 = getelementptr i8, ptr %.46.i.i.i, i64 %.idx.i2093.i.i
  %.idx301.i.i.i = mul i64 %.356.i.i, 80
  %10 = getelementptr i8, ptr %.46.i.i.i, i64 %.idx301.i.i.i
  %.idx303.i.i.i = mul i64 %.356.i.i, 56
  %11 = getelementptr i8, ptr %.46.i.i.i, i64 %.idx303.i.i.i
  %12 = getelementptr double, ptr %.46.i2071.i.i, i64 %.356.i.i
  %.idx304.i.i.i = mul i64 %.356.i.i, 72
  %13 = getelementptr i8, ptr %.46.i.i.i, i64 %.idx304.i.i.i
  br label %B892.if.i.i
B934.i.i:
  %.6474.i.i = icmp ne i64 %.6317.02266.i.i, 0
  %or.cond.i.i = and i1 %.2698.i.i, %.6474.i.i
  br i1 %or.cond.i.i, label %B950.i.i, label %B988.i.i
B950.i.i:
  %.112.i.i.i = load double, ptr %12, align 8, !noalias !427
  %.165.i.i.i = load double, ptr %11, align 8, !noalias !427
  %.218.i.i.i = load double, ptr %13, align 8, !noalias !427
  %.272.i.i.i = getelementptr double, ptr %12, i64 %.6317.02266.i.i
  store double %.112.i.i.i, ptr %.272.i.i.i, align 8, !noalias !427
  %.326.i.i.i = getelementptr double, ptr %11, i64 %.6317.02266.i.i
  store double %.165.i.i.i, ptr %.326.i.i.i, align 8, !noalias !427
  %.380.i.i.i = getelementptr double, ptr %13, i64 %.6317.02266.i.i
  store double %.218.i.i.i, ptr %.380.i.i.i, align 8, !noalias !427
  %.353.i.i.i.i = load i64, ptr %.352.i.i, align 8, !noalias !430
  %.354.i.i.i.i = inttoptr i64 %.353.i.i.i.i to ptr
  %.692.i.i.i.i = load i64, ptr %job, align 8, !noalias !430
  %.idx329.i.i.i = mul i64 %.692.i.i.i.i, 24
  %14 = getelementptr i8, ptr %.354.i.i.i.i, i64 %.idx329.i.i.i
  %.484.i.i.i = getelementptr i64, ptr %14, i64 %.6317.02266.i.i
  %.485.i.i.i = load i64, ptr %.484.i.i.i, align 8, !noalias !427
  %.491.not.i.i.i = icmp eq i64 %.485.i.i.i, 0
  br i1 %.491.not.i.i.i, label %B3181.i.i, label %B188.i.i.i
B188.i.i.i:
  %15 = getelementptr i64, ptr %.354.i.i.i.i, i64 %.692.i.i.i.i
  %16 = getelementptr i64, ptr %15, i64 %.6317.02266.i.i
  %.119.i.i.i.i = load i64, ptr %16, align 8, !noalias !433
  %.463.i.i.i.i = load i64, ptr %.462.i.i2101.i.i, align 8, !noalias !433
  %.802.i.i.i.i = load i64, ptr %.801.i.i2103.i.i, align 8, !noalias !433
  %.46.i385.i.i.i.i = load i64, ptr %.45.i384.i.i2105.i.i, align 8, !noalias !436
  %.50.i386.i.i.i.i = inttoptr i64 %.46.i385.i.i.i.i to ptr
  %.2300.i.i.i.i = icmp slt i64 %.119.i.i.i.i, 0
  %.2301.i.i.i.i = select i1 %.2300.i.i.i.i, i64 %.463.i.i.i.i, i64 0
  %17 = getelementptr i64, ptr %.50.i386.i.i.i.i, i64 %.119.i.i.i.i
  %.2315.i.i.i.i = getelementptr i64, ptr %17, i64 %.2301.i.i.i.i
  %.2316.i.i.i.i = load i64, ptr %.2315.i.i.i.i, align 8, !noalias !433
  %.2658.i.i.i.i = load i64, ptr %.2657.i.i2112.i.i, align 8, !noalias !433
  %.2659.i.i.i.i = icmp sgt i64 %.2658.i.i.i.i, 0
  br i1 %.2659.i.i.i.i, label %B432.i.i.i.i, label %b108
B432.i.i.i.i:
  %.3002.i.i.i.i = load i64, ptr %.3001.i.i2184.i.i, align 8, !noalias !433
  %.3004.i.i.i.i = mul nsw i64 %.3002.i.i.i.i, %.6317.02266.i.i
  br label %b108
b108:
  %"$phi476.1.2.0.i.i.i.i" = phi i64 [ %.3004.i.i.i.i, %B432.i.i.i.i ], [ 0, %B188.i.i.i ]
  %.3018.i.i.i.i = add nsw i64 %"$phi476.1.2.0.i.i.i.i", %.2316.i.i.i.i
  %.3399.i.i.i.i = load i64, ptr %.3398.i.i2118.i.i, align 8, !noalias !433
  %.3406.i.i.i.i = mul nsw i64 %.802.i.i.i.i, 56
  %.3407.i.i.i.i = mul nsw i64 %.3406.i.i.i.i, %.3018.i.i.i.i
  %.3408.i.i.i.i = add nsw i64 %.3407.i.i.i.i, %.3399.i.i.i.i
  %.3409.i.i.i.i = inttoptr i64 %.3408.i.i.i.i to ptr
  %.594.i.i.i = getelementptr double, ptr %.46.i2071.i.i, i64 %.6317.02266.i.i
  %.595.i.i.i = load double, ptr %.594.i.i.i, align 8, !noalias !427
  %.650.i.i.i = load double, ptr %.272.i.i.i, align 8, !noalias !427
  call void @llvm.lifetime.start.p0(ptr nonnull %.49.i.i.i.i), !noalias !427
  call fastcc void @v73(ptr %.49.i.i.i.i, ptr nonnull readonly %job, i64 %.6317.02266.i.i)
  %.65.fca.5.0.2.load.i.i.i.i = load i64, ptr %.fca.5.0.2.gep.i.i.i.i, align 8, !noalias !439
  %.65.fca.5.0.4.load.i.i.i.i = load ptr, ptr %.fca.5.0.4.gep.i.i.i.i, align 8, !noalias !439
  %.45.i.i330.i.i.i = load i64, ptr %6, align 8, !noalias !442
  %.46.i.i331.i.i.i = inttoptr i64 %.45.i.i330.i.i.i to ptr
  %.148211.not.i.i.i.i.i = icmp slt i64 %.65.fca.5.0.2.load.i.i.i.i, 1
  %invariant.gep.i.i.i.i = getelementptr double, ptr %.46.i.i331.i.i.i, i64 %.6317.02266.i.i
  br label %B138.if.i.i.i.i
B138.loopexit.i.i.i.i:
  %exitcond443.not.i.i.i.i = icmp eq i64 %.1185.i.i.i.i, 4
  br i1 %exitcond443.not.i.i.i.i, label %b109, label %B138.if.i.i.i.i
B138.if.i.i.i.i:
  %.1116.0442.i.i.i.i = phi i64 [ 0, %b108 ], [ %.1185.i.i.i.i, %B138.loopexit.i.i.i.i ]
  %.1185.i.i.i.i = add nuw nsw i64 %.1116.0442.i.i.i.i, 1
  %18 = getelementptr double, ptr @.const.array.data, i64 %.1116.0442.i.i.i.i
  %.1268.i.i.i.i = load double, ptr %18, align 8, !noalias !439
  %.1273.i.i.i.i = fmul double %.650.i.i.i, %.1268.i.i.i.i
  %.1275.i.i.i.i = fadd double %.595.i.i.i, %.1273.i.i.i.i
  br i1 %.148211.not.i.i.i.i.i, label %B138.loopexit.i.i.i.i, label %B58.if.i.i.i.i.i
B164.i.i.i.i.i:
  %.44.i.i.i.i.i.i = getelementptr i8, ptr %20, i64 24
  %.45.i.i.i.i.i.i = load double, ptr %.44.i.i.i.i.i.i, align 8, !noalias !445
  %.73.i.i.i.i.i.i = getelementptr i8, ptr %20, i64 32
  %.74.i.i.i.i.i.i = load double, ptr %.73.i.i.i.i.i.i, align 8, !noalias !445
  %.75.i.i.i.i.i.i = fmul double %.74.i.i.i.i.i.i, 5.000000e-01
  %.76.i.i.i.i.i.i = fmul double %.245.i.i.i.i.i, %.75.i.i.i.i.i.i
  %.77.i.i.i.i.i.i = fadd double %.45.i.i.i.i.i.i, %.76.i.i.i.i.i.i
  %.78.i.i.i.i.i.i = fmul double %.245.i.i.i.i.i, %.77.i.i.i.i.i.i
  %.87.le.i.i.i.i.i.i = tail call double @llvm.floor.f64(double %.78.i.i.i.i.i.i)
  %.92.i.i.i.i.i.i = fsub double %.78.i.i.i.i.i.i, %.87.le.i.i.i.i.i.i
  %.93.i.i.i.i.i.i = fmul double %.92.i.i.i.i.i.i, 0x401921FB54442D18
  %.121.i.i.i.i.i.i = getelementptr i8, ptr %20, i64 40
  %.122.i.i.i.i.i.i = load double, ptr %.121.i.i.i.i.i.i, align 8, !noalias !445
  %.126.i.i.i.i.i.i = fadd double %.122.i.i.i.i.i.i, %.93.i.i.i.i.i.i
  %.593.le.i.i.i.i.i = tail call double @llvm.sin.f64(double %.126.i.i.i.i.i.i)
  %.598.i.i.i.i.i = fmul double %.423.i.i.i.i.i, %.593.le.i.i.i.i.i
  %.600.i.i.i.i.i = fadd double %.361.i.i.i.i.i, %.598.i.i.i.i.i
  br label %B272.i.i.i.i.i
B272.i.i.i.i.i:
  %value.2.1.i.i.i.i.i = phi double [ %.600.i.i.i.i.i, %B164.i.i.i.i.i ], [ %.361.i.i.i.i.i, %B58.if.i.i.i.i.i ]
  %19 = getelementptr double, ptr %.65.fca.5.0.4.load.i.i.i.i, i64 %.90.0213.i.i.i.i.i
  store double %value.2.1.i.i.i.i.i, ptr %19, align 8, !noalias !450
  %exitcond.not.i.i.i.i.i = icmp eq i64 %.65.fca.5.0.2.load.i.i.i.i, %.161.i.i.i.i.i
  br i1 %exitcond.not.i.i.i.i.i, label %B260.preheader.i.i.i.i, label %B58.if.i.i.i.i.i
B260.preheader.i.i.i.i:
  %.1470.i.i.i.i = mul nuw nsw i64 %.1116.0442.i.i.i.i, %.65.fca.5.0.2.load.i.i.i.i
  br label %B260.if.i.i.i.i
B58.if.i.i.i.i.i:
  %.90.0213.i.i.i.i.i = phi i64 [ %.161.i.i.i.i.i, %B272.i.i.i.i.i ], [ 0, %B138.if.i.i.i.i ]
  %.161.i.i.i.i.i = add nuw nsw i64 %.90.0213.i.i.i.i.i, 1
  %.idx.i.i.i = mul i64 %.90.0213.i.i.i.i.i, 56
  %20 = getelementptr i8, ptr %.3409.i.i.i.i, i64 %.idx.i.i.i
  %.242.i.i.i.i.i = getelementptr i8, ptr %20, i64 48
  %.243.i.i.i.i.i = load double, ptr %.242.i.i.i.i.i, align 8, !noalias !450
  %.245.i.i.i.i.i = fsub double %.1275.i.i.i.i, %.243.i.i.i.i.i
  %.303.i.i.i.i.i = load double, ptr %20, align 8, !noalias !450
  %.357.i.i.i.i.i = getelementptr i8, ptr %20, i64 8
  %.358.i.i.i.i.i = load double, ptr %.357.i.i.i.i.i, align 8, !noalias !450
  %.360.i.i.i.i.i = fmul double %.245.i.i.i.i.i, %.358.i.i.i.i.i
  %.361.i.i.i.i.i = fadd double %.303.i.i.i.i.i, %.360.i.i.i.i.i
  %.422.i.i.i.i.i = getelementptr i8, ptr %20, i64 16
  %.423.i.i.i.i.i = load double, ptr %.422.i.i.i.i.i, align 8, !noalias !450
  %.424.i.i.i.i.i = fcmp une double %.423.i.i.i.i.i, 0.000000e+00
  br i1 %.424.i.i.i.i.i, label %B164.i.i.i.i.i, label %B272.i.i.i.i.i
B260.if.i.i.i.i:
  %.1338.0437.i.i.i.i = phi i64 [ 0, %B260.preheader.i.i.i.i ], [ %.1407.i.i.i.i, %B260.if.i.i.i.i ]
  %.1407.i.i.i.i = add nuw nsw i64 %.1338.0437.i.i.i.i, 1
  %21 = getelementptr double, ptr %.65.fca.5.0.4.load.i.i.i.i, i64 %.1338.0437.i.i.i.i
  %.1461.i.i.i.i = load double, ptr %21, align 8, !noalias !439
  %.1471.i.i.i.i = add nuw nsw i64 %.1338.0437.i.i.i.i, %.1470.i.i.i.i
  %.1519.i.i.i.i = mul i64 %.1471.i.i.i.i, %.692.i.i.i.i
  %gep440.i.i.i.i = getelementptr double, ptr %invariant.gep.i.i.i.i, i64 %.1519.i.i.i.i
  store double %.1461.i.i.i.i, ptr %gep440.i.i.i.i, align 8, !noalias !439
  %exitcond.not.i.i.i.i = icmp eq i64 %.1407.i.i.i.i, %.65.fca.5.0.2.load.i.i.i.i
  br i1 %exitcond.not.i.i.i.i, label %B138.loopexit.i.i.i.i, label %B260.if.i.i.i.i
b109:
  call void @llvm.lifetime.end.p0(ptr nonnull %.49.i.i.i.i), !noalias !427
  br label %B3181.i.i
B988.i.i:
  %.6548.i.i = load double, ptr %.50.i.i.i, align 8, !noalias !408
  call void @llvm.lifetime.start.p0(ptr nonnull %.665.i.i.i), !noalias !408
  %.117.i.i.i = getelementptr double, ptr %.46.i2071.i.i, i64 %.6317.02266.i.i
  %.118.i.i.i = load double, ptr %.117.i.i.i, align 8, !noalias !451
  %.172.i.i.i = getelementptr double, ptr %9, i64 %.6317.02266.i.i
  %.173.i.i.i = load double, ptr %.172.i.i.i, align 8, !noalias !451
  %.185.i.i.i = fcmp ugt double %.173.i.i.i, 0.000000e+00
  br i1 %.185.i.i.i, label %B100.i.i.i, label %B66.i.i.i
B66.i.i.i:
  %.45.i.i.i.i.i = load i64, ptr %.5611.i.i, align 8, !noalias !454
  %.46.i.i.i.i.i = inttoptr i64 %.45.i.i.i.i.i to ptr
  %.384.i.i.i.i.i = load i64, ptr %job, align 8, !noalias !454
  %.45.i300.i.i.i.i = load i64, ptr %.4255.i.i, align 8, !noalias !459
  %.46.i301.i.i.i.i = inttoptr i64 %.45.i300.i.i.i.i to ptr
  %.45.i311.i.i.i.i = load i64, ptr %5, align 8, !noalias !462
  %.46.i312.i.i.i.i = inttoptr i64 %.45.i311.i.i.i.i to ptr
  %.45.i322.i.i.i.i = load i64, ptr %3, align 8, !noalias !465
  %.46.i323.i.i.i.i = inttoptr i64 %.45.i322.i.i.i.i to ptr
  %.idx.i.i.i.i = mul i64 %.384.i.i.i.i.i, 80
  %22 = getelementptr i8, ptr %.46.i323.i.i.i.i, i64 %.idx.i.i.i.i
  %23 = getelementptr double, ptr %22, i64 %.6317.02266.i.i
  %.1525.i.i.i.i = load double, ptr %23, align 8, !noalias !468
  %.45.i333.i.i.i.i = load i64, ptr %4, align 8, !noalias !469
  %.46.i334.i.i.i.i = inttoptr i64 %.45.i333.i.i.i.i to ptr
  %24 = getelementptr double, ptr %.46.i334.i.i.i.i, i64 %.6317.02266.i.i
  %.1935.i.i.i.i = load double, ptr %24, align 8, !noalias !468
  %.1941.i.i.i.i = fsub double %.1525.i.i.i.i, %.1935.i.i.i.i
  %.1945.i.i.i.i = fdiv double 2.000000e+01, %.1941.i.i.i.i
  %.2286.i.i.i.i = load i64, ptr %.1036.i, align 8, !noalias !468
  %invariant.gep.i.i2094.i.i = getelementptr double, ptr %.46.i.i.i.i.i, i64 %.6317.02266.i.i
  %invariant.gep348.i.i.i.i = getelementptr double, ptr %.46.i301.i.i.i.i, i64 %.6317.02266.i.i
  %invariant.gep351.i.i.i.i = getelementptr double, ptr %.46.i312.i.i.i.i, i64 %.6317.02266.i.i
  %.2369354.not.i.i.i.i = icmp slt i64 %.2286.i.i.i.i, 1
  br i1 %.2369354.not.i.i.i.i, label %B532.i.i.i.i, label %B376.if.i.i.i.i
B532.i.i.i.i:
  %fastest.2.0.lcssa.i.i.i.i = phi double [ %.1945.i.i.i.i, %B66.i.i.i ], [ %.13.i345.i.i.i.i, %B376.if.i.i.i.i ]
  %.2640.i.i.i.i = fcmp olt double %.173.i.i.i, 0.000000e+00
  br i1 %.2640.i.i.i.i, label %B544.i.i.i.i, label %B584.i.i.i.i
B544.i.i.i.i:
  %.2643.i.i.i.i = fneg double %.173.i.i.i
  %.2650.i.i.i.i = fdiv double 1.000000e+00, %fastest.2.0.lcssa.i.i.i.i
  %.12.i.i.i.i.i = fcmp olt double %.2650.i.i.i.i, %.2643.i.i.i.i
  %.13.i.i.i.i.i = select i1 %.12.i.i.i.i.i, double %.2650.i.i.i.i, double %.2643.i.i.i.i
  br label %B100.i.i.i
B584.i.i.i.i:
  %.2691.i.i.i.i = fdiv double 1.000000e+00, %fastest.2.0.lcssa.i.i.i.i
  br label %B100.i.i.i
B376.if.i.i.i.i:
  %fastest.2.0357.i.i.i.i = phi double [ %.13.i345.i.i.i.i, %B376.if.i.i.i.i ], [ %.1945.i.i.i.i, %B66.i.i.i ]
  %.2313.0356.i.i.i.i = phi i64 [ %.2382.i.i.i.i, %B376.if.i.i.i.i ], [ 0, %B66.i.i.i ]
  %.2382.i.i.i.i = add nuw nsw i64 %.2313.0356.i.i.i.i, 1
  %.2454.i.i.i.i = mul i64 %.2313.0356.i.i.i.i, %.384.i.i.i.i.i
  %gep347.i.i.i.i = getelementptr double, ptr %invariant.gep.i.i2094.i.i, i64 %.2454.i.i.i.i
  %.2459.i.i.i.i = load double, ptr %gep347.i.i.i.i, align 8, !noalias !468
  %.2462.i.i.i.i = tail call double @llvm.fabs.f64(double %.2459.i.i.i.i)
  %.2463.i.i.i.i = fmul double %.2462.i.i.i.i, 2.000000e+01
  %gep350.i.i.i.i = getelementptr double, ptr %invariant.gep348.i.i.i.i, i64 %.2454.i.i.i.i
  %.2516.i.i.i.i = load double, ptr %gep350.i.i.i.i, align 8, !noalias !468
  %.2519.i.i.i.i = tail call double @llvm.fabs.f64(double %.2516.i.i.i.i)
  %gep353.i.i.i.i = getelementptr double, ptr %invariant.gep351.i.i.i.i, i64 %.2454.i.i.i.i
  %.2572.i.i.i.i = load double, ptr %gep353.i.i.i.i, align 8, !noalias !468
  %.2575.i.i.i.i = fadd double %.2519.i.i.i.i, %.2572.i.i.i.i
  %.2579.i.i.i.i = fdiv double %.2463.i.i.i.i, %.2575.i.i.i.i
  %.12.i344.i.i.i.i = fcmp ogt double %.2579.i.i.i.i, %fastest.2.0357.i.i.i.i
  %.13.i345.i.i.i.i = select i1 %.12.i344.i.i.i.i, double %.2579.i.i.i.i, double %fastest.2.0357.i.i.i.i
  %exitcond.not.i.i2095.i.i = icmp eq i64 %.2286.i.i.i.i, %.2382.i.i.i.i
  br i1 %exitcond.not.i.i2095.i.i, label %B532.i.i.i.i, label %B376.if.i.i.i.i
B100.i.i.i:
  %h.3.0.i.i.i = phi double [ %.173.i.i.i, %B988.i.i ], [ %.13.i.i.i.i.i, %B544.i.i.i.i ], [ %.2691.i.i.i.i, %B584.i.i.i.i ]
  %.12.i.i.i.i = fcmp olt double %.6548.i.i, %h.3.0.i.i.i
  %.13.i.i.i.i = select i1 %.12.i.i.i.i, double %.6548.i.i, double %h.3.0.i.i.i
  %.311.i.i.i = getelementptr double, ptr %10, i64 %.6317.02266.i.i
  %.312.i.i.i = load double, ptr %.311.i.i.i, align 8, !noalias !451
  %.657.i.i.i = load i64, ptr %.1598.i.i, align 8, !noalias !451
  %.658.i.i.i = icmp sgt i64 %.657.i.i.i, 0
  br i1 %.658.i.i.i, label %B206.i.i.i, label %B248.i.i.i
B206.i.i.i:
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %.665.i.i.i, i8 0, i64 16, i1 false), !noalias !451
  call fastcc void @v83(ptr %.665.i.i.i, ptr nonnull readonly %job, i64 %.6317.02266.i.i, double %.118.i.i.i, double %h.3.0.i.i.i)
  %.681.fca.1.load.i.i.i = load double, ptr %.fca.1.gep78.i.i.i, align 8, !noalias !451
  %wanted.2.0.in.sroa.speculate.load.B206.i.i.i = load double, ptr %.665.i.i.i, align 8, !noalias !451
  br label %B248.i.i.i
B248.i.i.i:
  %latest.2.0.i.i.i = phi double [ %.681.fca.1.load.i.i.i, %B206.i.i.i ], [ %.312.i.i.i, %B100.i.i.i ]
  %wanted.2.0.in.sroa.speculated.i.i.i = phi double [ %wanted.2.0.in.sroa.speculate.load.B206.i.i.i, %B206.i.i.i ], [ %.13.i.i.i.i, %B100.i.i.i ]
  %.710.i.i.i = fsub double %latest.2.0.i.i.i, %.118.i.i.i
  %.11.i.i.i.i = fmul double %.710.i.i.i, 5.000000e-01
  %.13.i305.i.i.i = fcmp olt double %wanted.2.0.in.sroa.speculated.i.i.i, %.11.i.i.i.i
  %.24.i.i.i.i = fcmp olt double %wanted.2.0.in.sroa.speculated.i.i.i, %.710.i.i.i
  %.11.arg.remaining.i.i.i.i = select i1 %.24.i.i.i.i, double %.11.i.i.i.i, double %.710.i.i.i
  %storemerge.i.i.i.i = select i1 %.13.i305.i.i.i, double %wanted.2.0.in.sroa.speculated.i.i.i, double %.11.arg.remaining.i.i.i.i
  %.353.i.i2097.i.i = load i64, ptr %.352.i.i, align 8, !noalias !472
  %.354.i.i2098.i.i = inttoptr i64 %.353.i.i2097.i.i to ptr
  %.692.i.i2099.i.i = load i64, ptr %job, align 8, !noalias !472
  %.idx302.i.i.i = mul i64 %.692.i.i2099.i.i, 24
  %25 = getelementptr i8, ptr %.354.i.i2098.i.i, i64 %.idx302.i.i.i
  %26 = getelementptr i64, ptr %25, i64 %.6317.02266.i.i
  %.835.i.i.i = load i64, ptr %26, align 8, !noalias !451
  %.841.not.i.i.i = icmp eq i64 %.835.i.i.i, 0
  br i1 %.841.not.i.i.i, label %b110, label %B352.i.i.i
B352.i.i.i:
  %27 = getelementptr i64, ptr %.354.i.i2098.i.i, i64 %.692.i.i2099.i.i
  %28 = getelementptr i64, ptr %27, i64 %.6317.02266.i.i
  %.119.i.i2100.i.i = load i64, ptr %28, align 8, !noalias !475
  %.463.i.i2102.i.i = load i64, ptr %.462.i.i2101.i.i, align 8, !noalias !475
  %.802.i.i2104.i.i = load i64, ptr %.801.i.i2103.i.i, align 8, !noalias !475
  %.46.i385.i.i2106.i.i = load i64, ptr %.45.i384.i.i2105.i.i, align 8, !noalias !478
  %.50.i386.i.i2107.i.i = inttoptr i64 %.46.i385.i.i2106.i.i to ptr
  %.2300.i.i2108.i.i = icmp slt i64 %.119.i.i2100.i.i, 0
  %.2301.i.i2109.i.i = select i1 %.2300.i.i2108.i.i, i64 %.463.i.i2102.i.i, i64 0
  %29 = getelementptr i64, ptr %.50.i386.i.i2107.i.i, i64 %.119.i.i2100.i.i
  %.2315.i.i2110.i.i = getelementptr i64, ptr %29, i64 %.2301.i.i2109.i.i
  %.2316.i.i2111.i.i = load i64, ptr %.2315.i.i2110.i.i, align 8, !noalias !475
  %.2658.i.i2113.i.i = load i64, ptr %.2657.i.i2112.i.i, align 8, !noalias !475
  %.2659.i.i2114.i.i = icmp sgt i64 %.2658.i.i2113.i.i, 0
  br i1 %.2659.i.i2114.i.i, label %B432.i.i2183.i.i, label %b111
B432.i.i2183.i.i:
  %.3002.i.i2185.i.i = load i64, ptr %.3001.i.i2184.i.i, align 8, !noalias !475
  %.3004.i.i2186.i.i = mul nsw i64 %.3002.i.i2185.i.i, %.6317.02266.i.i
  br label %b111
b111:
  %"$phi476.1.2.0.i.i2116.i.i" = phi i64 [ %.3004.i.i2186.i.i, %B432.i.i2183.i.i ], [ 0, %B352.i.i.i ]
  %.3018.i.i2117.i.i = add nsw i64 %"$phi476.1.2.0.i.i2116.i.i", %.2316.i.i2111.i.i
  %.3399.i.i2119.i.i = load i64, ptr %.3398.i.i2118.i.i, align 8, !noalias !475
  %.3406.i.i2120.i.i = mul nsw i64 %.802.i.i2104.i.i, 56
  %.3407.i.i2121.i.i = mul nsw i64 %.3406.i.i2120.i.i, %.3018.i.i2117.i.i
  %.3408.i.i2122.i.i = add nsw i64 %.3407.i.i2121.i.i, %.3399.i.i2119.i.i
  %.3409.i.i2123.i.i = inttoptr i64 %.3408.i.i2122.i.i to ptr
  call void @llvm.lifetime.start.p0(ptr nonnull %.49.i.i2091.i.i), !noalias !451
  call fastcc void @v73(ptr %.49.i.i2091.i.i, ptr nonnull readonly %job, i64 %.6317.02266.i.i)
  %.65.fca.5.0.2.load.i.i2127.i.i = load i64, ptr %.fca.5.0.2.gep.i.i2124.i.i, align 8, !noalias !481
  %.65.fca.5.0.4.load.i.i2128.i.i = load ptr, ptr %.fca.5.0.4.gep.i.i2125.i.i, align 8, !noalias !481
  %.45.i.i308.i.i.i = load i64, ptr %6, align 8, !noalias !484
  %.46.i.i309.i.i.i = inttoptr i64 %.45.i.i308.i.i.i to ptr
  %.148211.not.i.i.i2129.i.i = icmp slt i64 %.65.fca.5.0.2.load.i.i2127.i.i, 1
  %invariant.gep.i311.i.i.i = getelementptr double, ptr %.46.i.i309.i.i.i, i64 %.6317.02266.i.i
  br label %B138.if.i.i2130.i.i
B138.loopexit.i.i2162.i.i:
  %exitcond443.not.i.i2163.i.i = icmp eq i64 %.1185.i.i2132.i.i, 4
  br i1 %exitcond443.not.i.i2163.i.i, label %b112, label %B138.if.i.i2130.i.i
B138.if.i.i2130.i.i:
  %.1116.0442.i.i2131.i.i = phi i64 [ 0, %b111 ], [ %.1185.i.i2132.i.i, %B138.loopexit.i.i2162.i.i ]
  %.1185.i.i2132.i.i = add nuw nsw i64 %.1116.0442.i.i2131.i.i, 1
  %30 = getelementptr double, ptr @.const.array.data, i64 %.1116.0442.i.i2131.i.i
  %.1268.i.i2133.i.i = load double, ptr %30, align 8, !noalias !481
  %.1273.i.i2134.i.i = fmul double %storemerge.i.i.i.i, %.1268.i.i2133.i.i
  %.1275.i.i2135.i.i = fadd double %.118.i.i.i, %.1273.i.i2134.i.i
  br i1 %.148211.not.i.i.i2129.i.i, label %B138.loopexit.i.i2162.i.i, label %B58.if.i.i.i2136.i.i
B164.i.i.i2165.i.i:
  %.44.i.i.i.i2166.i.i = getelementptr i8, ptr %32, i64 24
  %.45.i.i.i.i2167.i.i = load double, ptr %.44.i.i.i.i2166.i.i, align 8, !noalias !487
  %.73.i.i.i.i2168.i.i = getelementptr i8, ptr %32, i64 32
  %.74.i.i.i.i2169.i.i = load double, ptr %.73.i.i.i.i2168.i.i, align 8, !noalias !487
  %.75.i.i.i.i2170.i.i = fmul double %.74.i.i.i.i2169.i.i, 5.000000e-01
  %.76.i.i.i.i2171.i.i = fmul double %.245.i.i.i2141.i.i, %.75.i.i.i.i2170.i.i
  %.77.i.i.i.i2172.i.i = fadd double %.45.i.i.i.i2167.i.i, %.76.i.i.i.i2171.i.i
  %.78.i.i.i.i2173.i.i = fmul double %.245.i.i.i2141.i.i, %.77.i.i.i.i2172.i.i
  %.87.le.i.i.i.i2174.i.i = tail call double @llvm.floor.f64(double %.78.i.i.i.i2173.i.i)
  %.92.i.i.i.i2175.i.i = fsub double %.78.i.i.i.i2173.i.i, %.87.le.i.i.i.i2174.i.i
  %.93.i.i.i.i2176.i.i = fmul double %.92.i.i.i.i2175.i.i, 0x401921FB54442D18
  %.121.i.i.i.i2177.i.i = getelementptr i8, ptr %32, i64 40
  %.122.i.i.i.i2178.i.i = load double, ptr %.121.i.i.i.i2177.i.i, align 8, !noalias !487
  %.126.i.i.i.i2179.i.i = fadd double %.122.i.i.i.i2178.i.i, %.93.i.i.i.i2176.i.i
  %.593.le.i.i.i2180.i.i = tail call double @llvm.sin.f64(double %.126.i.i.i.i2179.i.i)
  %.598.i.i.i2181.i.i = fmul double %.423.i.i.i2148.i.i, %.593.le.i.i.i2180.i.i
  %.600.i.i.i2182.i.i = fadd double %.361.i.i.i2146.i.i, %.598.i.i.i2181.i.i
  br label %B272.i.i.i2150.i.i
B272.i.i.i2150.i.i:
  %value.2.1.i.i.i2151.i.i = phi double [ %.600.i.i.i2182.i.i, %B164.i.i.i2165.i.i ], [ %.361.i.i.i2146.i.i, %B58.if.i.i.i2136.i.i ]
  %31 = getelementptr double, ptr %.65.fca.5.0.4.load.i.i2128.i.i, i64 %.90.0213.i.i.i2137.i.i
  store double %value.2.1.i.i.i2151.i.i, ptr %31, align 8, !noalias !492
  %exitcond.not.i.i.i2152.i.i = icmp eq i64 %.65.fca.5.0.2.load.i.i2127.i.i, %.161.i.i.i2138.i.i
  br i1 %exitcond.not.i.i.i2152.i.i, label %B260.preheader.i.i2153.i.i, label %B58.if.i.i.i2136.i.i
B260.preheader.i.i2153.i.i:
  %.1470.i.i2154.i.i = mul nuw nsw i64 %.1116.0442.i.i2131.i.i, %.65.fca.5.0.2.load.i.i2127.i.i
  br label %B260.if.i.i2155.i.i
B58.if.i.i.i2136.i.i:
  %.90.0213.i.i.i2137.i.i = phi i64 [ %.161.i.i.i2138.i.i, %B272.i.i.i2150.i.i ], [ 0, %B138.if.i.i2130.i.i ]
  %.161.i.i.i2138.i.i = add nuw nsw i64 %.90.0213.i.i.i2137.i.i, 1
  %.idx314.i.i.i = mul i64 %.90.0213.i.i.i2137.i.i, 56
  %32 = getelementptr i8, ptr %.3409.i.i2123.i.i, i64 %.idx314.i.i.i
  %.242.i.i.i2139.i.i = getelementptr i8, ptr %32, i64 48
  %.243.i.i.i2140.i.i = load double, ptr %.242.i.i.i2139.i.i, align 8, !noalias !492
  %.245.i.i.i2141.i.i = fsub double %.1275.i.i2135.i.i, %.243.i.i.i2140.i.i
  %.303.i.i.i2142.i.i = load double, ptr %32, align 8, !noalias !492
  %.357.i.i.i2143.i.i = getelementptr i8, ptr %32, i64 8
  %.358.i.i.i2144.i.i = load double, ptr %.357.i.i.i2143.i.i, align 8, !noalias !492
  %.360.i.i.i2145.i.i = fmul double %.245.i.i.i2141.i.i, %.358.i.i.i2144.i.i
  %.361.i.i.i2146.i.i = fadd double %.303.i.i.i2142.i.i, %.360.i.i.i2145.i.i
  %.422.i.i.i2147.i.i = getelementptr i8, ptr %32, i64 16
  %.423.i.i.i2148.i.i = load double, ptr %.422.i.i.i2147.i.i, align 8, !noalias !492
  %.424.i.i.i2149.i.i = fcmp une double %.423.i.i.i2148.i.i, 0.000000e+00
  br i1 %.424.i.i.i2149.i.i, label %B164.i.i.i2165.i.i, label %B272.i.i.i2150.i.i
B260.if.i.i2155.i.i:
  %.1338.0437.i.i2156.i.i = phi i64 [ 0, %B260.preheader.i.i2153.i.i ], [ %.1407.i.i2157.i.i, %B260.if.i.i2155.i.i ]
  %.1407.i.i2157.i.i = add nuw nsw i64 %.1338.0437.i.i2156.i.i, 1
  %33 = getelementptr double, ptr %.65.fca.5.0.4.load.i.i2128.i.i, i64 %.1338.0437.i.i2156.i.i
  %.1461.i.i2158.i.i = load double, ptr %33, align 8, !noalias !481
  %.1471.i.i2159.i.i = add nuw nsw i64 %.1338.0437.i.i2156.i.i, %.1470.i.i2154.i.i
  %.1519.i.i2160.i.i = mul i64 %.1471.i.i2159.i.i, %.692.i.i2099.i.i
  %gep440.i.i2161.i.i = getelementptr double, ptr %invariant.gep.i311.i.i.i, i64 %.1519.i.i2160.i.i
  store double %.1461.i.i2158.i.i, ptr %gep440.i.i2161.i.i, align 8, !noalias !481
  %exitcond.not.i313.i.i.i = icmp eq i64 %.1407.i.i2157.i.i, %.65.fca.5.0.2.load.i.i2127.i.i
  br i1 %exitcond.not.i313.i.i.i, label %B138.loopexit.i.i2162.i.i, label %B260.if.i.i2155.i.i
b112:
  call void @llvm.lifetime.end.p0(ptr nonnull %.49.i.i2091.i.i), !noalias !451
  br label %b110
b110:
  %.995.i.i.i = getelementptr double, ptr %11, i64 %.6317.02266.i.i
  store double %wanted.2.0.in.sroa.speculated.i.i.i, ptr %.995.i.i.i, align 8, !noalias !451
  %.1053.i.i.i = getelementptr double, ptr %12, i64 %.6317.02266.i.i
  store double %storemerge.i.i.i.i, ptr %.1053.i.i.i, align 8, !noalias !451
  %.1065.i.i.i = fmul double %.710.i.i.i, 0x3FEFFFFFFFFFDCD1
  %.1067.i.i.i = fcmp ult double %storemerge.i.i.i.i, %.1065.i.i.i
  %.1084.i.i.i = fadd double %.118.i.i.i, %storemerge.i.i.i.i
  %"$phi494.0.2.0.i.i.i" = select i1 %.1067.i.i.i, double %.1084.i.i.i, double %latest.2.0.i.i.i
  %.1148.i.i.i = getelementptr double, ptr %13, i64 %.6317.02266.i.i
  store double %"$phi494.0.2.0.i.i.i", ptr %.1148.i.i.i, align 8, !noalias !451
  call void @llvm.lifetime.end.p0(ptr nonnull %.665.i.i.i), !noalias !408
  br label %B3181.i.i
B1040.i.i:
  %.6935.i.i = load i64, ptr %.6934.i.i, align 8, !noalias !408
  %.7274.i.i = load i64, ptr %4, align 8, !noalias !408
  %.7613.i.i = load i64, ptr %.4255.i.i, align 8, !noalias !408
  %.7952.i.i = load i64, ptr %6, align 8, !noalias !408
  %.8291.i.i = load i64, ptr %.5272.i.i, align 8, !noalias !408
  %.8630.i.i = load i64, ptr %.5611.i.i, align 8, !noalias !408
  %.8969.i.i = load i64, ptr %.5950.i.i, align 8, !noalias !408
  %.9308.i.i = load i64, ptr %.6289.i.i, align 8, !noalias !408
  %.9647.i.i = load i64, ptr %.9646.i.i, align 8, !noalias !408
  %.9986.i.i = load i64, ptr %.9985.i.i, align 8, !noalias !408
  %.10325.i.i = load i64, ptr %.10324.i.i, align 8, !noalias !408
  %.10326.i.i = inttoptr i64 %.6935.i.i to ptr
  tail call void %.10326.i.i(i64 %.7274.i.i, i64 %.7613.i.i, i64 %.7952.i.i, i64 %.8291.i.i, i64 %.8630.i.i, i64 %.8969.i.i, i64 %.9308.i.i, i64 %.9647.i.i, i64 %.9986.i.i, i64 %.10325.i.i), !noalias !408
  %.10666.i.i = load i64, ptr %.10665.i.i, align 8, !noalias !408
  %.11005.i.i = load i64, ptr %.11004.i.i, align 8, !noalias !408
  %.11344.i.i = load i64, ptr %1, align 8, !noalias !408
  %.11683.i.i = load i64, ptr %.4255.i.i, align 8, !noalias !408
  %.12022.i.i = load i64, ptr %.10324.i.i, align 8, !noalias !408
  %.12361.i.i = load i64, ptr %.12360.i.i, align 8, !noalias !408
  %.12700.i.i = load i64, ptr %4, align 8, !noalias !408
  %.13039.i.i = load i64, ptr %3, align 8, !noalias !408
  %.13040.i.i = inttoptr i64 %.10666.i.i to ptr
  tail call void %.13040.i.i(i64 %.11005.i.i, i64 %.11344.i.i, i64 %.11683.i.i, i64 %.12022.i.i, i64 %.12361.i.i, i64 %.12700.i.i, i64 %.13039.i.i), !noalias !408
  %.13081.i.i = add i64 %.356.i.i, -1
  %.131242268.not.i.i = icmp sgt i64 %.13081.i.i, 0
  %or.cond2291.not.i.i = select i1 %.2698.i.i, i1 %.131242268.not.i.i, i1 false
  br i1 %or.cond2291.not.i.i, label %B1778.if.lr.ph.i.i, label %B1896.i.i
B1778.if.lr.ph.i.i:
  %.13274.idx.i.i = mul i64 %.356.i.i, 48
  %.13274.i.i = getelementptr i8, ptr %.46.i.i.i, i64 %.13274.idx.i.i
  br label %B1778.if.i.i
B1840.i.i:
  %.13275.i.i = load double, ptr %.13274.i.i, align 8, !noalias !408
  br label %B1872.i.i
B1872.i.i:
  %"$phi1872.1.2.1.i.i" = phi double [ %.13275.i.i, %B1840.i.i ], [ 0.000000e+00, %B1778.if.i.i ]
  %.13339.i.i = getelementptr double, ptr %.13274.i.i, i64 %.13068.02269.i.i
  store double %"$phi1872.1.2.1.i.i", ptr %.13339.i.i, align 8, !noalias !408
  %exitcond2287.not.i.i = icmp eq i64 %.13137.i.i, %.356.i.i
  br i1 %exitcond2287.not.i.i, label %B1896.i.i, label %B1778.if.i.i
B1896.i.i:
  br i1 %.27852261.not.i.i, label %B3176.critedge.i.i, label %B1930.if.lr.ph.i.i
B1930.if.lr.ph.i.i:
  %.idx2058.i.i = mul i64 %.356.i.i, 48
  %34 = getelementptr i8, ptr %.46.i.i.i, i64 %.idx2058.i.i
  %.idx2059.i.i = mul i64 %.356.i.i, 72
  %35 = getelementptr i8, ptr %.46.i.i.i, i64 %.idx2059.i.i
  br label %B1930.if.i.i
B1972.i.i:
  %.13589.i.i = getelementptr double, ptr %34, i64 %.13375.02272.i.i
  %.13590.i.i = load double, ptr %.13589.i.i, align 8, !noalias !408
  %.13591.i.i = fcmp une double %.13590.i.i, 0.000000e+00
  br i1 %.13591.i.i, label %B2010.i.i, label %B2146.i.i
B2010.i.i:
  br i1 %"$phi266.0.2.0.i.i", label %B2140.i.i, label %B2016.i.i
B2016.i.i:
  %.354.i2188.i.i = load i64, ptr %.353.i2187.i.i, align 8, !noalias !493
  %.358.i.i.i = mul nuw nsw i64 %.13530.i.i, 48
  %.359.i.i.i = add nsw i64 %.354.i2188.i.i, %.358.i.i.i
  %.360.i.i.i = inttoptr i64 %.359.i.i.i to ptr
  %.13728.i.i = getelementptr i8, ptr %.360.i.i.i, i64 16
  %.13729.i.i = load i64, ptr %.13728.i.i, align 8, !noalias !408
  %.13729.lobit.i.i = lshr i64 %.13729.i.i, 63
  %36 = getelementptr double, ptr %.50.i2085.i.i, i64 %.13729.i.i
  %.13761.i.i = getelementptr double, ptr %36, i64 %.13729.lobit.i.i
  %.13762.i.i = load double, ptr %.13761.i.i, align 8, !noalias !408
  %.13818.i.i = getelementptr double, ptr %35, i64 %.13375.02272.i.i
  %.13819.i.i = load double, ptr %.13818.i.i, align 8, !noalias !408
  %.13820.i.i = fcmp olt double %.13762.i.i, %.13819.i.i
  br label %B2140.i.i
B2140.i.i:
  %"$phi2140.2.2.2.i.i" = phi i1 [ true, %B2010.i.i ], [ %.13820.i.i, %B2016.i.i ]
  %.13828.i.i = or i1 %wants_dense.2.02274.i.i, %"$phi2140.2.2.2.i.i"
  br label %B2146.i.i
B2146.i.i:
  %wants_dense.3.1.i.i = phi i1 [ %.13828.i.i, %B2140.i.i ], [ %wants_dense.2.02274.i.i, %B1972.i.i ], [ %wants_dense.2.02274.i.i, %B1930.if.i.i ]
  %exitcond2288.not.i.i = icmp eq i64 %.356.i.i, %.13444.i.i
  br i1 %exitcond2288.not.i.i, label %B2148.i.i, label %B1930.if.i.i
B2148.i.i:
  br i1 %wants_dense.3.1.i.i, label %B2152.i.i, label %B2282.i.i
B2152.i.i:
  %.14197.i.i = load i64, ptr %.14196.i.i, align 8, !noalias !408
  %.14536.i.i = load i64, ptr %.9985.i.i, align 8, !noalias !408
  %.14875.i.i = load i64, ptr %.14874.i.i, align 8, !noalias !408
  %.14876.i.i = inttoptr i64 %.14197.i.i to ptr
  tail call void %.14876.i.i(i64 %.14536.i.i, i64 %.14875.i.i), !noalias !408
  br label %B2282.i.i
B2282.i.i:
  %37 = getelementptr double, ptr %.46.i2071.i.i, i64 %.356.i.i
  %.idx.i2243.i.i = shl i64 %.356.i.i, 4
  %38 = getelementptr i8, ptr %.46.i.i.i, i64 %.idx.i2243.i.i
  %.idx87.i.i.i = mul i64 %.356.i.i, 88
  %39 = getelementptr i8, ptr %.46.i.i.i, i64 %.idx87.i.i.i
  %40 = getelementptr i8, ptr %.354.i.i.i, i64 %.idx.i2243.i.i
  %.idx932.i.i.i = mul i64 %.356.i.i, 120
  %41 = getelementptr i8, ptr %.46.i.i.i, i64 %.idx932.i.i.i
  %.idx933.i.i.i = mul i64 %.356.i.i, 24
  %42 = getelementptr i8, ptr %.354.i.i.i, i64 %.idx933.i.i.i
  %43 = getelementptr double, ptr %.46.i.i.i, i64 %.356.i.i
  %.idx934.i.i.i = mul i64 %.356.i.i, 56
  %44 = getelementptr i8, ptr %.46.i.i.i, i64 %.idx934.i.i.i
  %45 = getelementptr i8, ptr %.46.i.i.i, i64 %.idx933.i.i.i
  %.idx936.i.i.i = mul i64 %.356.i.i, 40
  %46 = getelementptr i8, ptr %.46.i.i.i, i64 %.idx936.i.i.i
  %.idx937.i.i.i = shl i64 %.356.i.i, 5
  %47 = getelementptr i8, ptr %.46.i.i.i, i64 %.idx937.i.i.i
  %48 = getelementptr i8, ptr %.354.i.i.i, i64 %.idx937.i.i.i
  %.idx939.i.i.i = mul i64 %.356.i.i, 104
  %49 = getelementptr i8, ptr %.46.i.i.i, i64 %.idx939.i.i.i
  %.idx942.i.i.i = mul i64 %.356.i.i, 80
  %50 = getelementptr i8, ptr %.46.i.i.i, i64 %.idx942.i.i.i
  %.idx944.i.i.i = mul i64 %.356.i.i, 96
  %51 = getelementptr i8, ptr %.46.i.i.i, i64 %.idx944.i.i.i
  %.15483.i.i = getelementptr i8, ptr %.50.i.i.i, i64 8
  %.99.i.i.i = getelementptr i8, ptr %.354.i.i.i, i64 %.idx2058.i.i
  br label %B2316.if.i.i
B2362.i.i:
  %.354.i2195.i.i = load i64, ptr %.353.i2187.i.i, align 8, !noalias !496
  %.358.i2196.i.i = mul nuw nsw i64 %.15061.i.i, 48
  %.359.i2197.i.i = add nsw i64 %.354.i2195.i.i, %.358.i2196.i.i
  %.360.i2198.i.i = inttoptr i64 %.359.i2197.i.i to ptr
  %.15144.i.i = getelementptr i8, ptr %.360.i2198.i.i, i64 8
  %.15145.i.i = load i64, ptr %.15144.i.i, align 8, !noalias !408
  %.15146.i.i = add nsw i64 %.15145.i.i, 1
  store i64 %.15146.i.i, ptr %.15144.i.i, align 8, !noalias !408
  %52 = getelementptr double, ptr %34, i64 %.14906.02277.i.i
  %.15231.i.i = load double, ptr %52, align 8, !noalias !408
  %.15232.i.i = fcmp une double %.15231.i.i, 0.000000e+00
  br i1 %.15232.i.i, label %B2474.i.i, label %B2514.i.i
B2474.i.i:
  call void @llvm.lifetime.start.p0(ptr nonnull %.1033.i.i.i), !noalias !408
  call void @llvm.lifetime.start.p0(ptr nonnull %.1661.i.i.i), !noalias !408
  call void @llvm.lifetime.start.p0(ptr nonnull %.2385.i.i.i), !noalias !408
  call void @llvm.lifetime.start.p0(ptr nonnull %.3921.i.i.i), !noalias !408
  %.137.i.i.i = getelementptr double, ptr %.46.i2071.i.i, i64 %.14906.02277.i.i
  %.138.i.i.i = load double, ptr %.137.i.i.i, align 8, !noalias !499
  %.192.i.i.i = getelementptr double, ptr %37, i64 %.14906.02277.i.i
  %.193.i.i.i = load double, ptr %.192.i.i.i, align 8, !noalias !499
  %.247.i.i.i = getelementptr double, ptr %35, i64 %.14906.02277.i.i
  %.248.i.i.i = load double, ptr %.247.i.i.i, align 8, !noalias !499
  %.354.i.i2206.i.i = load i64, ptr %.353.i2187.i.i, align 8, !noalias !502
  %.359.i.i.i.i = add nsw i64 %.354.i.i2206.i.i, %.358.i2196.i.i
  %.360.i.i.i.i = inttoptr i64 %.359.i.i.i.i to ptr
  %.679.i.i.i = load i64, ptr %.1598.i.i, align 8, !noalias !499
  %.680.i.i.i = icmp sgt i64 %.679.i.i.i, 0
  br i1 %.680.i.i.i, label %B204.i.i.i, label %B160.i.i.i
B160.i.i.i:
  %.1020.i.i.i = load i64, ptr %.1942.i.i, align 8, !noalias !499
  %.1021.i.i.i = icmp sgt i64 %.1020.i.i.i, 0
  br i1 %.1021.i.i.i, label %B204.i.i.i, label %B250.i.i.i
B204.i.i.i:
  store double 0.000000e+00, ptr %.1033.i.i.i, align 8, !noalias !499
  store i8 0, ptr %.fca.1.gep430.i.i.i, align 8, !noalias !499
  call fastcc void @v77(ptr %.1033.i.i.i, ptr nonnull readonly %job, i64 %.14906.02277.i.i, double %.138.i.i.i, double %.193.i.i.i, double %.248.i.i.i)
  %.1049.fca.0.load.i.i.i = load double, ptr %.1033.i.i.i, align 8, !noalias !499
  %.1049.fca.1.load.i.i.i = load i8, ptr %.fca.1.gep430.i.i.i, align 8, !noalias !499
  %.1054.i.i.i = icmp ne i8 %.1049.fca.1.load.i.i.i, 0
  br label %B592.i.i.i
B250.i.i.i:
  %.46.i.i.i.i = load i64, ptr %.45.i2083.i.i, align 8, !noalias !505
  %.50.i.i.i.i = inttoptr i64 %.46.i.i.i.i to ptr
  %.1467.i.i.i = getelementptr i8, ptr %.360.i.i.i.i, i64 16
  %.1468.i.i.i = load i64, ptr %.1467.i.i.i, align 8, !noalias !499
  %.1468.lobit.i.i.i = lshr i64 %.1468.i.i.i, 63
  %53 = getelementptr double, ptr %.50.i.i.i.i, i64 %.1468.i.i.i
  %.1496.i.i.i = getelementptr double, ptr %53, i64 %.1468.lobit.i.i.i
  %.1497.i.i.i = load double, ptr %.1496.i.i.i, align 8, !noalias !499
  %.1502.i.i.i = fcmp olt double %.1497.i.i.i, %.248.i.i.i
  br i1 %.1502.i.i.i, label %B346.i.i.i, label %B592.i.i.i
B346.i.i.i:
  %.5.i.i.i.i = fmul double %.248.i.i.i, 0x3D06849B86A12B9B
  %.6.i.i.i.i = fadd double %.5.i.i.i.i, 1.000000e-15
  %.1534.i.i.i = fsub double %.248.i.i.i, %.6.i.i.i.i
  %.1588.i.i.i = getelementptr double, ptr %41, i64 %.14906.02277.i.i
  store double %.1534.i.i.i, ptr %.1588.i.i.i, align 8, !noalias !499
  %54 = getelementptr i64, ptr %42, i64 %.14906.02277.i.i
  %.1644.i.i.i = load i64, ptr %54, align 8, !noalias !499
  %.1645.not.i.i.i = icmp eq i64 %.1644.i.i.i, 0
  br i1 %.1645.not.i.i.i, label %B478.i.i.i, label %B442.i.i.i
B442.i.i.i:
  call fastcc void @v81(ptr %.1661.i.i.i, ptr nonnull readonly %job, i64 %.14906.02277.i.i, i64 %.15061.i.i)
  br label %B592.i.i.i
B478.i.i.i:
  %.2039.i.i.i = load i64, ptr %.2038.i.i.i, align 8, !noalias !499
  %.2378.i.i.i = load i64, ptr %.4594.i.i, align 8, !noalias !499
  %.2380.i.i.i = shl nsw i64 %.14906.02277.i.i, 3
  %.2381.i.i.i = add nsw i64 %.2378.i.i.i, %.2380.i.i.i
  call fastcc void @v82(ptr %.2385.i.i.i, ptr nonnull readonly %job, i64 %.14906.02277.i.i, i64 %.15061.i.i, i64 %.2039.i.i.i, i64 %.2381.i.i.i)
  br label %B592.i.i.i
B592.i.i.i:
  %end.2.0.i.i.i = phi double [ %.1049.fca.0.load.i.i.i, %B204.i.i.i ], [ %.248.i.i.i, %B442.i.i.i ], [ %.248.i.i.i, %B478.i.i.i ], [ %.248.i.i.i, %B250.i.i.i ]
  %has_changed.2.0.i.i.i = phi i1 [ %.1054.i.i.i, %B204.i.i.i ], [ false, %B442.i.i.i ], [ false, %B478.i.i.i ], [ false, %B250.i.i.i ]
  %.2449.i.i.i = load i64, ptr %.360.i.i.i.i, align 8, !noalias !499
  %.2450.i.i.i = add nsw i64 %.2449.i.i.i, 1
  store i64 %.2450.i.i.i, ptr %.360.i.i.i.i, align 8, !noalias !499
  store double %end.2.0.i.i.i, ptr %.137.i.i.i, align 8, !noalias !499
  %.2572.i.i.i = getelementptr i8, ptr %.360.i.i.i.i, i64 24
  %.2573.i.i.i = load i64, ptr %.2572.i.i.i, align 8, !noalias !499
  %.2579.i.i.i = icmp sgt i64 %.2573.i.i.i, -1
  br i1 %.2579.i.i.i, label %b113, label %B696.i.i.i
B696.i.i.i:
  %.2663.i.i.i = getelementptr double, ptr %43, i64 %.14906.02277.i.i
  %.2664.i.i.i = load double, ptr %.2663.i.i.i, align 8, !noalias !499
  %.2718.i.i.i = getelementptr double, ptr %44, i64 %.14906.02277.i.i
  %.2719.i.i.i = load double, ptr %.2718.i.i.i, align 8, !noalias !499
  %.2779.i.i.i = getelementptr double, ptr %45, i64 %.14906.02277.i.i
  %.2780.i.i.i = load double, ptr %.2779.i.i.i, align 8, !noalias !499
  %.2835.i.i.i = getelementptr double, ptr %46, i64 %.14906.02277.i.i
  store double %.193.i.i.i, ptr %.2835.i.i.i, align 8, !noalias !499
  %.2890.i.i.i = getelementptr double, ptr %47, i64 %.14906.02277.i.i
  store double %.2780.i.i.i, ptr %.2890.i.i.i, align 8, !noalias !499
  %.2945.i.i.i = getelementptr i64, ptr %48, i64 %.14906.02277.i.i
  %.2946.i.i.i = load i64, ptr %.2945.i.i.i, align 8, !noalias !499
  %.2947.not.i.i.i = icmp eq i64 %.2946.i.i.i, 0
  br i1 %.2947.not.i.i.i, label %B974.i.i.i, label %B862.i.i.i
B862.i.i.i:
  %.12.i.i2207.i.i = fcmp ogt double %.2664.i.i.i, 5.000000e-01
  %.13.i.i2208.i.i = select i1 %.12.i.i2207.i.i, double %.2664.i.i.i, double 5.000000e-01
  %.12.i953.i.i.i = fcmp olt double %.13.i.i2208.i.i, 2.000000e+00
  %.13.i954.i.i.i = select i1 %.12.i953.i.i.i, double %.13.i.i2208.i.i, double 2.000000e+00
  %.3007.i.i.i = fmul double %.193.i.i.i, %.13.i954.i.i.i
  %.3061.i.i.i = getelementptr double, ptr %49, i64 %.14906.02277.i.i
  store double %.3007.i.i.i, ptr %.3061.i.i.i, align 8, !noalias !499
  store i64 0, ptr %.2945.i.i.i, align 8, !noalias !499
  br label %B974.i.i.i
B974.i.i.i:
  %.3121.i.i.i = fcmp olt double %.193.i.i.i, %.2719.i.i.i
  br i1 %.3121.i.i.i, label %B986.i.i.i, label %B1024.i.i.i
B986.i.i.i:
  %.3125.i.i.i = fmul double %.193.i.i.i, %.2664.i.i.i
  %.12.i955.i.i.i = fcmp ogt double %.3125.i.i.i, %.2719.i.i.i
  %.13.i956.i.i.i = select i1 %.12.i955.i.i.i, double %.3125.i.i.i, double %.2719.i.i.i
  br label %B1094.i.i.i
B1024.i.i.i:
  %.3220.i.i.i = getelementptr i64, ptr %40, i64 %.14906.02277.i.i
  %.3221.i.i.i = load i64, ptr %.3220.i.i.i, align 8, !noalias !499
  %.3222.not.i.i.i = icmp eq i64 %.3221.i.i.i, 0
  %.12.i957.i.i.i = fcmp olt double %.2664.i.i.i, 1.000000e+00
  %55 = select i1 %.3222.not.i.i.i, i1 true, i1 %.12.i957.i.i.i
  %"$phi1090.1.2.0.i.i.i" = select i1 %55, double %.2664.i.i.i, double 1.000000e+00
  %.3273.i.i.i = fmul double %.193.i.i.i, %"$phi1090.1.2.0.i.i.i"
  br label %B1094.i.i.i
B1094.i.i.i:
  %"$phi1094.0.2.0.i.i.i" = phi double [ %.13.i956.i.i.i, %B986.i.i.i ], [ %.3273.i.i.i, %B1024.i.i.i ]
  %.3344.i.i.i = getelementptr i64, ptr %40, i64 %.14906.02277.i.i
  store i64 0, ptr %.3344.i.i.i, align 8, !noalias !499
  br i1 %has_changed.2.0.i.i.i, label %B1124.i.i.i, label %B1364.i.i.i
B1124.i.i.i:
  %.3406.i.i.i = getelementptr double, ptr %50, i64 %.14906.02277.i.i
  %.3407.i.i.i = load double, ptr %.3406.i.i.i, align 8, !noalias !499
  %.5.i959.i.i.i = fmul double %.3407.i.i.i, 0x3D06849B86A12B9B
  %.6.i960.i.i.i = fadd double %.5.i959.i.i.i, 1.000000e-15
  %.3487.i.i.i = fsub double %.3407.i.i.i, %.6.i960.i.i.i
  %.3489.i.i.i = fcmp olt double %end.2.0.i.i.i, %.3487.i.i.i
  br i1 %.3489.i.i.i, label %B1230.i.i.i, label %B1364.i.i.i
B1230.i.i.i:
  %.3544.i.i.i = getelementptr double, ptr %49, i64 %.14906.02277.i.i
  %.3545.i.i.i = load double, ptr %.3544.i.i.i, align 8, !noalias !499
  %.12.i961.i.i.i = fcmp olt double %.3545.i.i.i, %"$phi1094.0.2.0.i.i.i"
  %.13.i962.i.i.i = select i1 %.12.i961.i.i.i, double %.3545.i.i.i, double %"$phi1094.0.2.0.i.i.i"
  store double 0.000000e+00, ptr %.2835.i.i.i, align 8, !noalias !499
  %.3688.i.i.i = getelementptr double, ptr %51, i64 %.14906.02277.i.i
  store double %end.2.0.i.i.i, ptr %.3688.i.i.i, align 8, !noalias !499
  store i64 1, ptr %.2945.i.i.i, align 8, !noalias !499
  br label %B1364.i.i.i
B1364.i.i.i:
  %h.3.0.i2209.i.i = phi double [ %.13.i962.i.i.i, %B1230.i.i.i ], [ %"$phi1094.0.2.0.i.i.i", %B1124.i.i.i ], [ %"$phi1094.0.2.0.i.i.i", %B1094.i.i.i ]
  %.3802.i.i.i = getelementptr double, ptr %39, i64 %.14906.02277.i.i
  store double %h.3.0.i2209.i.i, ptr %.3802.i.i.i, align 8, !noalias !499
  %.3859.i.i.i = getelementptr i64, ptr %42, i64 %.14906.02277.i.i
  %.3860.i.i.i = load i64, ptr %.3859.i.i.i, align 8, !noalias !499
  %.3868.not.i.i.i = icmp eq i64 %.3860.i.i.i, 0
  br i1 %.3868.not.i.i.i, label %B1482.i.i.i, label %B1418.i.i.i
B1418.i.i.i:
  %.353.i.i.i.i.i = load i64, ptr %.352.i.i, align 8, !noalias !508
  %.354.i.i.i.i.i = inttoptr i64 %.353.i.i.i.i.i to ptr
  %.692.i.i.i.i.i = load i64, ptr %job, align 8, !noalias !508
  %56 = getelementptr i64, ptr %.354.i.i.i.i.i, i64 %.692.i.i.i.i.i
  %57 = getelementptr i64, ptr %56, i64 %.14906.02277.i.i
  %.119.i.i2211.i.i = load i64, ptr %57, align 8, !noalias !513
  %.463.i.i2213.i.i = load i64, ptr %.462.i.i2101.i.i, align 8, !noalias !513
  %.802.i.i2215.i.i = load i64, ptr %.801.i.i2103.i.i, align 8, !noalias !513
  %.46.i385.i.i2219.i.i = load i64, ptr %.45.i384.i.i2105.i.i, align 8, !noalias !514
  %.50.i386.i.i2220.i.i = inttoptr i64 %.46.i385.i.i2219.i.i to ptr
  %.2300.i.i2221.i.i = icmp slt i64 %.119.i.i2211.i.i, 0
  %.2301.i.i2222.i.i = select i1 %.2300.i.i2221.i.i, i64 %.463.i.i2213.i.i, i64 0
  %58 = getelementptr i64, ptr %.50.i386.i.i2220.i.i, i64 %.119.i.i2211.i.i
  %.2315.i.i2223.i.i = getelementptr i64, ptr %58, i64 %.2301.i.i2222.i.i
  %.2316.i.i2224.i.i = load i64, ptr %.2315.i.i2223.i.i, align 8, !noalias !513
  %.2658.i.i2226.i.i = load i64, ptr %.2657.i.i2112.i.i, align 8, !noalias !513
  %.2659.i.i2227.i.i = icmp sgt i64 %.2658.i.i2226.i.i, 0
  br i1 %.2659.i.i2227.i.i, label %B432.i.i2237.i.i, label %b114
B432.i.i2237.i.i:
  %.3002.i.i2239.i.i = load i64, ptr %.3001.i.i2184.i.i, align 8, !noalias !513
  %.3004.i.i2240.i.i = mul nsw i64 %.3002.i.i2239.i.i, %.14906.02277.i.i
  br label %b114
b114:
  %"$phi476.1.2.0.i.i2229.i.i" = phi i64 [ %.3004.i.i2240.i.i, %B432.i.i2237.i.i ], [ 0, %B1418.i.i.i ]
  %.3018.i.i2230.i.i = add nsw i64 %"$phi476.1.2.0.i.i2229.i.i", %.2316.i.i2224.i.i
  %.3399.i.i2232.i.i = load i64, ptr %.3398.i.i2118.i.i, align 8, !noalias !513
  %.3406.i.i2233.i.i = mul nsw i64 %.802.i.i2215.i.i, 56
  %.3407.i.i2234.i.i = mul nsw i64 %.3406.i.i2233.i.i, %.3018.i.i2230.i.i
  %.3408.i.i2235.i.i = add nsw i64 %.3399.i.i2232.i.i, %.3407.i.i2234.i.i
  %.3409.i.i2236.i.i = inttoptr i64 %.3408.i.i2235.i.i to ptr
  call fastcc void @v72(ptr %.3921.i.i.i, ptr nonnull readonly %job, i64 %.14906.02277.i.i, ptr %.3409.i.i2236.i.i, i64 7, double %end.2.0.i.i.i)
  br label %B1482.i.i.i
B1482.i.i.i:
  %.4022.i.i.i = getelementptr double, ptr %50, i64 %.14906.02277.i.i
  %.4023.i.i.i = load double, ptr %.4022.i.i.i, align 8, !noalias !499
  %.4032.i.i.i = fcmp olt double %end.2.0.i.i.i, %.4023.i.i.i
  %..i.i.i = sext i1 %.4032.i.i.i to i64
  br label %b113
b113:
  %storemerge.i.i.i = phi i64 [ %..i.i.i, %B1482.i.i.i ], [ 1, %B592.i.i.i ]
  call void @llvm.lifetime.end.p0(ptr nonnull %.1033.i.i.i), !noalias !408
  call void @llvm.lifetime.end.p0(ptr nonnull %.1661.i.i.i), !noalias !408
  call void @llvm.lifetime.end.p0(ptr nonnull %.2385.i.i.i), !noalias !408
  call void @llvm.lifetime.end.p0(ptr nonnull %.3921.i.i.i), !noalias !408
  br label %B2548.i.i
B2514.i.i:
  %.110.i.i.i = getelementptr double, ptr %.46.i2071.i.i, i64 %.14906.02277.i.i
  %.111.i2241.i.i = load double, ptr %.110.i.i.i, align 8, !noalias !517
  %.163.i.i.i = getelementptr double, ptr %37, i64 %.14906.02277.i.i
  %.164.i2242.i.i = load double, ptr %.163.i.i.i, align 8, !noalias !517
  %.221.i.i.i = getelementptr double, ptr %38, i64 %.14906.02277.i.i
  %.222.i.i.i = load double, ptr %.221.i.i.i, align 8, !noalias !517
  %.223.i.i.i = fmul double %.164.i2242.i.i, %.222.i.i.i
  %.279.i.i.i = getelementptr double, ptr %39, i64 %.14906.02277.i.i
  store double %.223.i.i.i, ptr %.279.i.i.i, align 8, !noalias !517
  %59 = getelementptr i64, ptr %40, i64 %.14906.02277.i.i
  store i64 1, ptr %59, align 8, !noalias !517
  %.345.i.i.i = fadd double %.111.i2241.i.i, %.223.i.i.i
  %.346.i.i.i = fcmp ole double %.345.i.i.i, %.111.i2241.i.i
  %.349.i.i.i = fcmp olt double %.223.i.i.i, 1.000000e-300
  %or.cond.i.i.i = or i1 %.349.i.i.i, %.346.i.i.i
  %"$phi172.0.2.0.i.i.i" = select i1 %or.cond.i.i.i, i64 2, i64 -1
  br label %B2548.i.i
B2548.i.i:
  %"$phi2548.1.2.2.in.sroa.speculated.i.i" = phi i64 [ %storemerge.i.i.i, %b113 ], [ %"$phi172.0.2.0.i.i.i", %B2514.i.i ]
  %.15340.i.i = icmp ne i64 %.14906.02277.i.i, 0
  %or.cond1.i.i = and i1 %.2698.i.i, %.15340.i.i
  br i1 %or.cond1.i.i, label %B2566.i.i, label %B2668.i.i
B2566.i.i:
  %.13.i.i.i = tail call i64 @llvm.smin.i64(i64 %"$phi2548.1.2.2.in.sroa.speculated.i.i", i64 0)
  %.100.i.i.i = load i64, ptr %.99.i.i.i, align 8, !noalias !520
  %.101.i.i.i = icmp sgt i64 %.100.i.i.i, 0
  br i1 %.101.i.i.i, label %b115, label %B82.i.i.i
B82.i.i.i:
  %.235.i.i.i = load double, ptr %34, align 8, !noalias !520
  %.236.i.i.i = fcmp une double %.235.i.i.i, 0.000000e+00
  br i1 %.236.i.i.i, label %B120.i.i.i, label %B172.i.i.i
B120.i.i.i:
  %.294.i.i.i = load double, ptr %52, align 8, !noalias !520
  %.302.i.i.i = fcmp oeq double %.294.i.i.i, 0.000000e+00
  br i1 %.302.i.i.i, label %b115, label %B172.i.i.i
B172.i.i.i:
  br label %b115
b115:
  %storemerge.i2244.i.i = phi i64 [ %.100.i.i.i, %B2566.i.i ], [ -1, %B172.i.i.i ], [ 2, %B120.i.i.i ]
  %.13.i2245.i.i = tail call i64 @llvm.smax.i64(i64 %storemerge.i2244.i.i, i64 %.13.i.i.i)
  br label %B2758.i.i
B2668.i.i:
  %.15450.i.i = icmp slt i64 %"$phi2548.1.2.2.in.sroa.speculated.i.i", 1
  br i1 %.15450.i.i, label %B2690.i.i, label %B2758.i.i
B2690.i.i:
  %.15484.i.i = load double, ptr %.15483.i.i, align 8, !noalias !408
  %.67.i.i.i = load i64, ptr %.15144.i.i, align 8, !noalias !523
  %.87.i2246.i.i = srem i64 %.67.i.i.i, 400
  %.89.i2247.i.i = icmp slt i64 %.87.i2246.i.i, 0
  %.98.i.i.i = add nsw i64 %.87.i2246.i.i, 400
  %.78.0.i.i.i = select i1 %.89.i2247.i.i, i64 %.98.i.i.i, i64 %.87.i2246.i.i
  %.108.i.i.i = icmp eq i64 %.78.0.i.i.i, 0
  br i1 %.108.i.i.i, label %B56.i.i.i, label %B590.i.i.i
B56.i.i.i:
  %.45.i.i2249.i.i = load i64, ptr %3, align 8, !noalias !526
  %.46.i.i2250.i.i = inttoptr i64 %.45.i.i2249.i.i to ptr
  %.384.i.i.i.i = load i64, ptr %job, align 8, !noalias !526
  %.353.i.i2252.i.i = load i64, ptr %.352.i.i, align 8, !noalias !529
  %.354.i.i2253.i.i = inttoptr i64 %.353.i.i2252.i.i to ptr
  %.45.i542.i.i.i = load i64, ptr %4, align 8, !noalias !532
  %.46.i543.i.i.i = inttoptr i64 %.45.i542.i.i.i to ptr
  %60 = getelementptr double, ptr %.46.i543.i.i.i, i64 %.14906.02277.i.i
  %.912.i.i.i = load double, ptr %60, align 8, !noalias !523
  %.idx.i2254.i.i = mul i64 %.384.i.i.i.i, 112
  %61 = getelementptr i8, ptr %.46.i.i2250.i.i, i64 %.idx.i2254.i.i
  %62 = getelementptr double, ptr %61, i64 %.14906.02277.i.i
  %.1011.i.i.i = load double, ptr %62, align 8, !noalias !523
  %.1660.i.i.i = load i64, ptr %.1855.i.i.i.i, align 8, !noalias !523
  %.46.i554.i.i.i = load i64, ptr %.45.i2083.i.i, align 8, !noalias !535
  %.50.i.i2255.i.i = inttoptr i64 %.46.i554.i.i.i to ptr
  %63 = getelementptr double, ptr %.50.i.i2255.i.i, i64 %.1660.i.i.i
  %.1726.i.i.i = getelementptr i8, ptr %63, i64 -8
  %.1727.i.i.i = load double, ptr %.1726.i.i.i, align 8, !noalias !523
  %.1732.i.i.i = fsub double %.912.i.i.i, %.1011.i.i.i
  %.1733.i.i.i = fsub double %.1727.i.i.i, %.1011.i.i.i
  %.1734.i.i.i = fmul double %.1733.i.i.i, 1.000000e-04
  %.1735.i.i.i = fcmp olt double %.1732.i.i.i, %.1734.i.i.i
  br i1 %.1735.i.i.i, label %B394.i.i.i, label %B394.thread.i.i.i
B394.thread.i.i.i:
  %.1835565.i.i.i = load i64, ptr %.360.i2198.i.i, align 8, !noalias !523
  %.1864566.i.i.i = getelementptr i8, ptr %.360.i2198.i.i, i64 32
  %.pre.i.i = mul i64 %.384.i.i.i.i, 40
  br label %B498.i.i.i
B394.i.i.i:
  %.idx532.i.i.i = mul i64 %.384.i.i.i.i, 40
  %64 = getelementptr i8, ptr %.354.i.i2253.i.i, i64 %.idx532.i.i.i
  %65 = getelementptr i64, ptr %64, i64 %.14906.02277.i.i
  %.1794.i.i.i = load i64, ptr %65, align 8, !noalias !523
  %.1795.not.i.i.i = icmp ne i64 %.1794.i.i.i, 0
  %.1835.i.i.i = load i64, ptr %.360.i2198.i.i, align 8, !noalias !523
  %.1864.i.i.i = getelementptr i8, ptr %.360.i2198.i.i, i64 32
  %.1865.i.i.i = load i64, ptr %.1864.i.i.i, align 8, !noalias !523
  %.1866.i.i.i = sub nsw i64 %.1835.i.i.i, %.1865.i.i.i
  %.1908.i.i.i = icmp sgt i64 %.1866.i.i.i, 279
  %brmerge.i.i.i = select i1 %.1908.i.i.i, i1 true, i1 %.1795.not.i.i.i
  br i1 %brmerge.i.i.i, label %B498.i.i.i, label %B2758.i.i
B498.i.i.i:
  %.idx533.i.pre-phi.i.i = phi i64 [ %.idx532.i.i.i, %B394.i.i.i ], [ %.pre.i.i, %B394.thread.i.i.i ]
  %.1864572.i.i.i = phi ptr [ %.1864.i.i.i, %B394.i.i.i ], [ %.1864566.i.i.i, %B394.thread.i.i.i ]
  %.1835571.i.i.i = phi i64 [ %.1835.i.i.i, %B394.i.i.i ], [ %.1835565.i.i.i, %B394.thread.i.i.i ]
  store i64 %.1835571.i.i.i, ptr %.1864572.i.i.i, align 8, !noalias !523
  store double %.912.i.i.i, ptr %62, align 8, !noalias !523
  %66 = getelementptr i8, ptr %.354.i.i2253.i.i, i64 %.idx533.i.pre-phi.i.i
  %67 = getelementptr i64, ptr %66, i64 %.14906.02277.i.i
  store i64 0, ptr %67, align 8, !noalias !523
  %.2169.pre.i.i.i = load i64, ptr %.15144.i.i, align 8, !noalias !523
  br label %B590.i.i.i
B590.i.i.i:
  %.2169.i.i.i = phi i64 [ %.67.i.i.i, %B2690.i.i ], [ %.2169.pre.i.i.i, %B498.i.i.i ]
  %.2176.i.i.i = sitofp i64 %.2169.i.i.i to double
  %.2177.i.i.i = fcmp ugt double %.15484.i.i, %.2176.i.i.i
  br i1 %.2177.i.i.i, label %B638.i.i.i, label %B2758.i.i
B638.i.i.i:
  %.46.i556.i.i.i = load i64, ptr %.45.i555.i.i.i, align 8, !noalias !538
  %.50.i557.i.i.i = inttoptr i64 %.46.i556.i.i.i to ptr
  %.2568.i.i.i = getelementptr i8, ptr %.50.i557.i.i.i, i64 8
  %.2569.i.i.i = load double, ptr %.2568.i.i.i, align 8, !noalias !523
  %.2573.i2248.i.i = fcmp une double %.2569.i.i.i, 0.000000e+00
  br i1 %.2573.i2248.i.i, label %select.unfold2256.i.i, label %B2758.i.i
select.unfold2256.i.i:
  br label %B2758.i.i
B2758.i.i:
  %ended.3.2.i.i = phi i64 [ %.13.i2245.i.i, %b115 ], [ %"$phi2548.1.2.2.in.sroa.speculated.i.i", %B2668.i.i ], [ %"$phi2548.1.2.2.in.sroa.speculated.i.i", %B638.i.i.i ], [ 5, %select.unfold2256.i.i ], [ 3, %B590.i.i.i ], [ 2, %B394.i.i.i ]
  %.15613.i.i = getelementptr i64, ptr %.99.i.i.i, i64 %.14906.02277.i.i
  store i64 %ended.3.2.i.i, ptr %.15613.i.i, align 8, !noalias !408
  %.15616.i.i = icmp sgt i64 %ended.3.2.i.i, -1
  %.15620.i.i = or i1 %has_ended.2.02281.i.i, %.15616.i.i
  br label %B2800.i.i
B2800.i.i:
  %has_ended.3.1.i.i = phi i1 [ %.15620.i.i, %B2758.i.i ], [ %has_ended.2.02281.i.i, %B2316.if.i.i ]
  %exitcond2289.not.i.i = icmp eq i64 %.356.i.i, %.14975.i.i
  br i1 %exitcond2289.not.i.i, label %B2802.i.i, label %B2316.if.i.i
B2802.i.i:
  %.15999.i.i = load i64, ptr %.15998.i.i, align 8, !noalias !408
  %.16338.i.i = load i64, ptr %3, align 8, !noalias !408
  %.16677.i.i = load i64, ptr %.4255.i.i, align 8, !noalias !408
  %.17016.i.i = load i64, ptr %.10324.i.i, align 8, !noalias !408
  %.17355.i.i = load i64, ptr %.17354.i.i, align 8, !noalias !408
  %.17356.i.i = inttoptr i64 %.15999.i.i to ptr
  tail call void %.17356.i.i(i64 %.16338.i.i, i64 %.16677.i.i, i64 %.17016.i.i, i64 %.17355.i.i), !noalias !408
  br i1 %has_ended.3.1.i.i, label %B3034.if.i.i, label %B596.endif.i
B3076.i.i:
  %.17595.i.i = getelementptr i64, ptr %.99.i.i.i, i64 %.17388.02284.i.i
  %.17596.i.i = load i64, ptr %.17595.i.i, align 8, !noalias !408
  %.17597.i.i = icmp sgt i64 %.17596.i.i, -1
  br i1 %.17597.i.i, label %B3114.i.i, label %B3174.i.i
B3114.i.i:
  %.17663.i.i = call fastcc i32 @v76(ptr %.17657.i.i, ptr nonnull %job, i64 %.17388.02284.i.i, i64 %.17596.i.i)
  %.17665.not.i.i = icmp eq i32 %.17663.i.i, 0
  br i1 %.17665.not.i.i, label %B3174.i.i, label %B596.if.i, !prof !106
B3174.i.i:
  %exitcond2290.not.i.i = icmp eq i64 %.356.i.i, %.17457.i.i
  br i1 %exitcond2290.not.i.i, label %B596.endif.i, label %B3034.if.i.i
B3176.critedge.i.i:
  %.15999.c.i.i = load i64, ptr %.15998.i.i, align 8, !noalias !408
  %.16338.c.i.i = load i64, ptr %3, align 8, !noalias !408
  %.16677.c.i.i = load i64, ptr %.4255.i.i, align 8, !noalias !408
  %.17016.c.i.i = load i64, ptr %.10324.i.i, align 8, !noalias !408
  %.17355.c.i.i = load i64, ptr %.17354.i.i, align 8, !noalias !408
  %.17356.c.i.i = inttoptr i64 %.15999.c.i.i to ptr
  tail call void %.17356.c.i.i(i64 %.16338.c.i.i, i64 %.16677.c.i.i, i64 %.17016.c.i.i, i64 %.17355.c.i.i), !noalias !408
  br label %B596.endif.i
B3181.i.i:
  %exitcond2286.not.i.i = icmp eq i64 %.356.i.i, %.6386.i.i
  br i1 %exitcond2286.not.i.i, label %B1040.i.i, label %B892.if.i.i
B434.if.i.i:
  %moves.2.02264.i.i = phi i1 [ false, %B434.if.lr.ph.i.i ], [ %.2879.i.i, %B434.if.i.i ]
  %.2729.02262.i.i = phi i64 [ 0, %B434.if.lr.ph.i.i ], [ %.2798.i.i, %B434.if.i.i ]
  %.2798.i.i = add nuw nsw i64 %.2729.02262.i.i, 1
  %68 = getelementptr i64, ptr %7, i64 %.2729.02262.i.i
  %.2876.i.i = load i64, ptr %68, align 8, !noalias !408
  %.2877.i.i = icmp ne i64 %.2876.i.i, 0
  %.2879.i.i = or i1 %moves.2.02264.i.i, %.2877.i.i
  %exitcond.not.i.i = icmp eq i64 %.356.i.i, %.2798.i.i
  br i1 %exitcond.not.i.i, label %B484.loopexit.i.i, label %B434.if.i.i
B892.if.i.i:
  %.6317.02266.i.i = phi i64 [ 0, %B892.if.lr.ph.i.i ], [ %.6386.i.i, %B3181.i.i ]
  %.6386.i.i = add nuw nsw i64 %.6317.02266.i.i, 1
  %69 = getelementptr i64, ptr %.354.i.i.i, i64 %.6317.02266.i.i
  %.6468.i.i = load i64, ptr %69, align 8, !noalias !408
  %.6469.i.i = icmp sgt i64 %.6468.i.i, -1
  br i1 %.6469.i.i, label %B934.i.i, label %B3181.i.i
B1778.if.i.i:
  %.13068.02269.i.i = phi i64 [ 1, %B1778.if.lr.ph.i.i ], [ %.13137.i.i, %B1872.i.i ]
  %.13137.i.i = add nuw i64 %.13068.02269.i.i, 1
  %.13218.i.i = getelementptr double, ptr %.46.i.i.i, i64 %.13068.02269.i.i
  %.13219.i.i = load double, ptr %.13218.i.i, align 8, !noalias !408
  %.13220.i.i = fcmp ueq double %.13219.i.i, 0x7FF0000000000000
  br i1 %.13220.i.i, label %B1872.i.i, label %B1840.i.i
B1930.if.i.i:
  %wants_dense.2.02274.i.i = phi i1 [ false, %B1930.if.lr.ph.i.i ], [ %wants_dense.3.1.i.i, %B2146.i.i ]
  %.13375.02272.i.i = phi i64 [ 0, %B1930.if.lr.ph.i.i ], [ %.13444.i.i, %B2146.i.i ]
  %.13444.i.i = add nuw nsw i64 %.13375.02272.i.i, 1
  %70 = getelementptr i64, ptr %.354.i.i.i, i64 %.13375.02272.i.i
  %.13530.i.i = load i64, ptr %70, align 8, !noalias !408
  %.13531.i.i = icmp sgt i64 %.13530.i.i, -1
  br i1 %.13531.i.i, label %B1972.i.i, label %B2146.i.i
B2316.if.i.i:
  %has_ended.2.02281.i.i = phi i1 [ false, %B2282.i.i ], [ %has_ended.3.1.i.i, %B2800.i.i ]
  %.14906.02277.i.i = phi i64 [ 0, %B2282.i.i ], [ %.14975.i.i, %B2800.i.i ]
  %.14975.i.i = add nuw nsw i64 %.14906.02277.i.i, 1
  %.15060.i.i = getelementptr i64, ptr %.354.i.i.i, i64 %.14906.02277.i.i
  %.15061.i.i = load i64, ptr %.15060.i.i, align 8, !noalias !408
  %.15066.i.i = icmp sgt i64 %.15061.i.i, -1
  br i1 %.15066.i.i, label %B2362.i.i, label %B2800.i.i
B3034.if.i.i:
  %.17388.02284.i.i = phi i64 [ %.17457.i.i, %B3174.i.i ], [ 0, %B2802.i.i ]
  %.17457.i.i = add nuw nsw i64 %.17388.02284.i.i, 1
  %.17538.i.i = getelementptr i64, ptr %.354.i.i.i, i64 %.17388.02284.i.i
  %.17539.i.i = load i64, ptr %.17538.i.i, align 8, !noalias !408
  %.17540.i.i = icmp sgt i64 %.17539.i.i, -1
  br i1 %.17540.i.i, label %B3076.i.i, label %B3174.i.i
B360.if.i:
  %.2228.i = add nuw i64 %.2159.0.i, 1
  br i1 %.2336449.not.i, label %B456.i, label %B394.if.lr.ph.i
B394.if.lr.ph.i:
  %invariant.gep.i = getelementptr double, ptr %.46.i.i, i64 %.2159.0.i
  br label %B394.if.i
B394.if.i:
  %.2280.0450.i = phi i64 [ 0, %B394.if.lr.ph.i ], [ %.2349.i, %B394.if.i ]
  %.2349.i = add nuw nsw i64 %.2280.0450.i, 1
  %71 = getelementptr i8, ptr %.1732.i, i64 %.2280.0450.i
  %.2407.i = load i8, ptr %71, align 1, !noalias !398
  %.2408.not.i = icmp eq i8 %.2407.i, 0
  %..i = select i1 %.2408.not.i, double 0xFFF0000000000000, double 0.000000e+00
  %.2469.i = mul i64 %.2280.0450.i, %.698.i
  %gep453.i = getelementptr double, ptr %invariant.gep.i, i64 %.2469.i
  store double %..i, ptr %gep453.i, align 8, !noalias !398
  %exitcond.not.i = icmp eq i64 %.1037.i, %.2349.i
  br i1 %exitcond.not.i, label %B456.i, label %B394.if.i
B596.if.i:
  call void @llvm.lifetime.end.p0(ptr nonnull %.17657.i.i), !noalias !398
  br label %b107
B596.endif.i:
  call void @llvm.lifetime.end.p0(ptr nonnull %.17657.i.i), !noalias !398
  %.3343.i = load i64, ptr %.2134.i, align 8, !noalias !398
  %.3344.i = icmp sgt i64 %.3343.i, 0
  br i1 %.3344.i, label %B596.i, label %b107
b107:
  call void @llvm.lifetime.end.p0(ptr nonnull %.2589.i)
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
!72 = !{!73, !75}
!73 = distinct !{!73, !74, !"scope"}
!74 = distinct !{!74, !"scope"}
!75 = distinct !{!75, !76, !"scope"}
!76 = distinct !{!76, !"scope"}
!77 = !{!75}
!78 = !{!79}
!79 = distinct !{!79, !80, !"scope"}
!80 = distinct !{!80, !"scope"}
!81 = !{!"branch_weights", i32 1, i32 99}
!82 = !{!83, !85}
!83 = distinct !{!83, !84, !"scope"}
!84 = distinct !{!84, !"scope"}
!85 = distinct !{!85, !86, !"scope"}
!86 = distinct !{!86, !"scope"}
!87 = !{!85}
!88 = !{!89, !85}
!89 = distinct !{!89, !90, !"scope"}
!90 = distinct !{!90, !"scope"}
!91 = !{!92, !94, !96, !98}
!92 = distinct !{!92, !93, !"scope"}
!93 = distinct !{!93, !"scope"}
!94 = distinct !{!94, !95, !"scope"}
!95 = distinct !{!95, !"scope"}
!96 = distinct !{!96, !97, !"scope"}
!97 = distinct !{!97, !"scope"}
!98 = distinct !{!98, !99, !"scope"}
!99 = distinct !{!99, !"scope"}
!100 = !{!94, !96, !98}
!101 = !{!96, !98}
!102 = !{!98}
!103 = !{!104}
!104 = distinct !{!104, !105, !"scope"}
!105 = distinct !{!105, !"scope"}
!106 = !{!"branch_weights", i32 99, i32 1}
!107 = !{!108}
!108 = distinct !{!108, !109, !"scope"}
!109 = distinct !{!109, !"scope"}
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
!125 = !{!126, !128}
!126 = distinct !{!126, !127, !"scope"}
!127 = distinct !{!127, !"scope"}
!128 = distinct !{!128, !129, !"scope"}
!129 = distinct !{!129, !"scope"}
!130 = !{!128}
!131 = !{!132, !134}
!132 = distinct !{!132, !133, !"scope"}
!133 = distinct !{!133, !"scope"}
!134 = distinct !{!134, !135, !"scope"}
!135 = distinct !{!135, !"scope"}
!136 = !{!134}
!137 = !{!138}
!138 = distinct !{!138, !139, !"scope"}
!139 = distinct !{!139, !"scope"}
!140 = !{!141}
!141 = distinct !{!141, !142, !"scope"}
!142 = distinct !{!142, !"scope"}
!143 = !{}
!144 = !{!145}
!145 = distinct !{!145, !146, !"scope"}
!146 = distinct !{!146, !"scope"}
!147 = !{!148}
!148 = distinct !{!148, !149, !"scope"}
!149 = distinct !{!149, !"scope"}
!150 = !{!151}
!151 = distinct !{!151, !152, !"scope"}
!152 = distinct !{!152, !"scope"}
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
!174 = !{!175, !177}
!175 = distinct !{!175, !176, !"scope"}
!176 = distinct !{!176, !"scope"}
!177 = distinct !{!177, !178, !"scope"}
!178 = distinct !{!178, !"scope"}
!179 = !{!177}
!180 = !{!181, !183, !185, !187}
!181 = distinct !{!181, !182, !"scope"}
!182 = distinct !{!182, !"scope"}
!183 = distinct !{!183, !184, !"scope"}
!184 = distinct !{!184, !"scope"}
!185 = distinct !{!185, !186, !"scope"}
!186 = distinct !{!186, !"scope"}
!187 = distinct !{!187, !188, !"scope"}
!188 = distinct !{!188, !"scope"}
!189 = !{!183, !185, !187}
!190 = !{!185, !187}
!191 = !{!187}
!192 = !{!193, !195}
!193 = distinct !{!193, !194, !"scope"}
!194 = distinct !{!194, !"scope"}
!195 = distinct !{!195, !196, !"scope"}
!196 = distinct !{!196, !"scope"}
!197 = !{!195}
!198 = !{!199}
!199 = distinct !{!199, !200, !"scope"}
!200 = distinct !{!200, !"scope"}
!201 = !{!202, !199}
!202 = distinct !{!202, !203, !"scope"}
!203 = distinct !{!203, !"scope"}
!204 = !{!205, !207}
!205 = distinct !{!205, !206, !"scope"}
!206 = distinct !{!206, !"scope"}
!207 = distinct !{!207, !208, !"scope"}
!208 = distinct !{!208, !"scope"}
!209 = !{!207}
!210 = !{!211, !213}
!211 = distinct !{!211, !212, !"scope"}
!212 = distinct !{!212, !"scope"}
!213 = distinct !{!213, !214, !"scope"}
!214 = distinct !{!214, !"scope"}
!215 = !{!213}
!216 = !{!217}
!217 = distinct !{!217, !218, !"scope"}
!218 = distinct !{!218, !"scope"}
!219 = !{!220}
!220 = distinct !{!220, !221, !"scope"}
!221 = distinct !{!221, !"scope"}
!222 = !{!223, !225}
!223 = distinct !{!223, !224, !"scope"}
!224 = distinct !{!224, !"scope"}
!225 = distinct !{!225, !226, !"scope"}
!226 = distinct !{!226, !"scope"}
!227 = !{!225}
!228 = !{!229}
!229 = distinct !{!229, !230, !"scope"}
!230 = distinct !{!230, !"scope"}
!231 = !{!232}
!232 = distinct !{!232, !233, !"scope"}
!233 = distinct !{!233, !"scope"}
!234 = !{!235}
!235 = distinct !{!235, !236, !"scope"}
!236 = distinct !{!236, !"scope"}
!237 = !{!238}
!238 = distinct !{!238, !239, !"scope"}
!239 = distinct !{!239, !"scope"}
!240 = !{!241}
!241 = distinct !{!241, !242, !"scope"}
!242 = distinct !{!242, !"scope"}
!243 = !{!244, !246}
!244 = distinct !{!244, !245, !"scope"}
!245 = distinct !{!245, !"scope"}
!246 = distinct !{!246, !247, !"scope"}
!247 = distinct !{!247, !"scope"}
!248 = !{!246}
!249 = !{!250, !246}
!250 = distinct !{!250, !251, !"scope"}
!251 = distinct !{!251, !"scope"}
!252 = !{!253, !246}
!253 = distinct !{!253, !254, !"scope"}
!254 = distinct !{!254, !"scope"}
!255 = !{!256, !246}
!256 = distinct !{!256, !257, !"scope"}
!257 = distinct !{!257, !"scope"}
!258 = !{!259, !261}
!259 = distinct !{!259, !260, !"scope"}
!260 = distinct !{!260, !"scope"}
!261 = distinct !{!261, !262, !"scope"}
!262 = distinct !{!262, !"scope"}
!263 = !{!261}
!264 = !{!265, !261}
!265 = distinct !{!265, !266, !"scope"}
!266 = distinct !{!266, !"scope"}
!267 = !{!268, !261}
!268 = distinct !{!268, !269, !"scope"}
!269 = distinct !{!269, !"scope"}
!270 = !{!271, !261}
!271 = distinct !{!271, !272, !"scope"}
!272 = distinct !{!272, !"scope"}
!273 = !{!274, !276}
!274 = distinct !{!274, !275, !"scope"}
!275 = distinct !{!275, !"scope"}
!276 = distinct !{!276, !277, !"scope"}
!277 = distinct !{!277, !"scope"}
!278 = !{!276}
!279 = !{!280, !282}
!280 = distinct !{!280, !281, !"scope"}
!281 = distinct !{!281, !"scope"}
!282 = distinct !{!282, !283, !"scope"}
!283 = distinct !{!283, !"scope"}
!284 = !{!282}
!285 = !{!286, !288}
!286 = distinct !{!286, !287, !"scope"}
!287 = distinct !{!287, !"scope"}
!288 = distinct !{!288, !289, !"scope"}
!289 = distinct !{!289, !"scope"}
!290 = !{!288}
!291 = !{!292}
!292 = distinct !{!292, !293, !"scope"}
!293 = distinct !{!293, !"scope"}
!294 = !{!295, !297}
!295 = distinct !{!295, !296, !"scope"}
!296 = distinct !{!296, !"scope"}
!297 = distinct !{!297, !298, !"scope"}
!298 = distinct !{!298, !"scope"}
!299 = !{!297}
!300 = !{!301}
!301 = distinct !{!301, !302, !"scope"}
!302 = distinct !{!302, !"scope"}
!303 = !{!304}
!304 = distinct !{!304, !305, !"scope"}
!305 = distinct !{!305, !"scope"}
!306 = !{!307, !309}
!307 = distinct !{!307, !308, !"scope"}
!308 = distinct !{!308, !"scope"}
!309 = distinct !{!309, !310, !"scope"}
!310 = distinct !{!310, !"scope"}
!311 = !{!309}
!312 = !{!313, !309}
!313 = distinct !{!313, !314, !"scope"}
!314 = distinct !{!314, !"scope"}
!315 = !{!316}
!316 = distinct !{!316, !317, !"scope"}
!317 = distinct !{!317, !"scope"}
!318 = !{!319}
!319 = distinct !{!319, !320, !"scope"}
!320 = distinct !{!320, !"scope"}
!321 = !{!322}
!322 = distinct !{!322, !323, !"scope"}
!323 = distinct !{!323, !"scope"}
!324 = !{!325, !327}
!325 = distinct !{!325, !326, !"scope"}
!326 = distinct !{!326, !"scope"}
!327 = distinct !{!327, !328, !"scope"}
!328 = distinct !{!328, !"scope"}
!329 = !{!327}
!330 = !{!331, !333}
!331 = distinct !{!331, !332, !"scope"}
!332 = distinct !{!332, !"scope"}
!333 = distinct !{!333, !334, !"scope"}
!334 = distinct !{!334, !"scope"}
!335 = !{!333}
!336 = !{!337}
!337 = distinct !{!337, !338, !"scope"}
!338 = distinct !{!338, !"scope"}
!339 = !{!340}
!340 = distinct !{!340, !341, !"scope"}
!341 = distinct !{!341, !"scope"}
!342 = !{!343, !345, !347, !349}
!343 = distinct !{!343, !344, !"scope"}
!344 = distinct !{!344, !"scope"}
!345 = distinct !{!345, !346, !"scope"}
!346 = distinct !{!346, !"scope"}
!347 = distinct !{!347, !348, !"scope"}
!348 = distinct !{!348, !"scope"}
!349 = distinct !{!349, !350, !"scope"}
!350 = distinct !{!350, !"scope"}
!351 = !{!345, !347, !349}
!352 = !{!347, !349}
!353 = !{!349}
!354 = !{!355}
!355 = distinct !{!355, !356, !"scope"}
!356 = distinct !{!356, !"scope"}
!357 = !{!358}
!358 = distinct !{!358, !359, !"scope"}
!359 = distinct !{!359, !"scope"}
!360 = !{!361}
!361 = distinct !{!361, !362, !"scope"}
!362 = distinct !{!362, !"scope"}
!363 = !{!364}
!364 = distinct !{!364, !365, !"scope"}
!365 = distinct !{!365, !"scope"}
!366 = !{!367, !369, !371, !373}
!367 = distinct !{!367, !368, !"scope"}
!368 = distinct !{!368, !"scope"}
!369 = distinct !{!369, !370, !"scope"}
!370 = distinct !{!370, !"scope"}
!371 = distinct !{!371, !372, !"scope"}
!372 = distinct !{!372, !"scope"}
!373 = distinct !{!373, !374, !"scope"}
!374 = distinct !{!374, !"scope"}
!375 = !{!369, !371, !373}
!376 = !{!371, !373}
!377 = !{!373}
!378 = !{!379, !381}
!379 = distinct !{!379, !380, !"scope"}
!380 = distinct !{!380, !"scope"}
!381 = distinct !{!381, !382, !"scope"}
!382 = distinct !{!382, !"scope"}
!383 = !{!381}
!384 = !{!385, !381}
!385 = distinct !{!385, !386, !"scope"}
!386 = distinct !{!386, !"scope"}
!387 = !{!388, !381}
!388 = distinct !{!388, !389, !"scope"}
!389 = distinct !{!389, !"scope"}
!390 = !{!391}
!391 = distinct !{!391, !392, !"scope"}
!392 = distinct !{!392, !"scope"}
!393 = !{!394, !396}
!394 = distinct !{!394, !395, !"scope"}
!395 = distinct !{!395, !"scope"}
!396 = distinct !{!396, !397, !"scope"}
!397 = distinct !{!397, !"scope"}
!398 = !{!399, !401}
!399 = distinct !{!399, !400, !"scope"}
!400 = distinct !{!400, !"scope"}
!401 = distinct !{!401, !400, !"scope"}
!402 = !{!403, !399, !401}
!403 = distinct !{!403, !404, !"scope"}
!404 = distinct !{!404, !"scope"}
!405 = !{!406, !399, !401}
!406 = distinct !{!406, !407, !"scope"}
!407 = distinct !{!407, !"scope"}
!408 = !{!409, !411, !399, !401}
!409 = distinct !{!409, !410, !"scope"}
!410 = distinct !{!410, !"scope"}
!411 = distinct !{!411, !410, !"scope"}
!412 = !{!413, !409, !411, !399, !401}
!413 = distinct !{!413, !414, !"scope"}
!414 = distinct !{!414, !"scope"}
!415 = !{!416, !409, !411, !399, !401}
!416 = distinct !{!416, !417, !"scope"}
!417 = distinct !{!417, !"scope"}
!418 = !{!419, !409, !411, !399, !401}
!419 = distinct !{!419, !420, !"scope"}
!420 = distinct !{!420, !"scope"}
!421 = !{!422, !409, !411, !399, !401}
!422 = distinct !{!422, !423, !"scope"}
!423 = distinct !{!423, !"scope"}
!424 = !{!425, !409, !411, !399, !401}
!425 = distinct !{!425, !426, !"scope"}
!426 = distinct !{!426, !"scope"}
!427 = !{!428, !409, !411, !399, !401}
!428 = distinct !{!428, !429, !"scope"}
!429 = distinct !{!429, !"scope"}
!430 = !{!431, !428, !409, !411, !399, !401}
!431 = distinct !{!431, !432, !"scope"}
!432 = distinct !{!432, !"scope"}
!433 = !{!434, !428, !409, !411, !399, !401}
!434 = distinct !{!434, !435, !"scope"}
!435 = distinct !{!435, !"scope"}
!436 = !{!437, !434, !428, !409, !411, !399, !401}
!437 = distinct !{!437, !438, !"scope"}
!438 = distinct !{!438, !"scope"}
!439 = !{!440, !428, !409, !411, !399, !401}
!440 = distinct !{!440, !441, !"scope"}
!441 = distinct !{!441, !"scope"}
!442 = !{!443, !440, !428, !409, !411, !399, !401}
!443 = distinct !{!443, !444, !"scope"}
!444 = distinct !{!444, !"scope"}
!445 = !{!446, !448, !440, !428, !409, !411, !399, !401}
!446 = distinct !{!446, !447, !"scope"}
!447 = distinct !{!447, !"scope"}
!448 = distinct !{!448, !449, !"scope"}
!449 = distinct !{!449, !"scope"}
!450 = !{!448, !440, !428, !409, !411, !399, !401}
!451 = !{!452, !409, !411, !399, !401}
!452 = distinct !{!452, !453, !"scope"}
!453 = distinct !{!453, !"scope"}
!454 = !{!455, !457, !452, !409, !411, !399, !401}
!455 = distinct !{!455, !456, !"scope"}
!456 = distinct !{!456, !"scope"}
!457 = distinct !{!457, !458, !"scope"}
!458 = distinct !{!458, !"scope"}
!459 = !{!460, !457, !452, !409, !411, !399, !401}
!460 = distinct !{!460, !461, !"scope"}
!461 = distinct !{!461, !"scope"}
!462 = !{!463, !457, !452, !409, !411, !399, !401}
!463 = distinct !{!463, !464, !"scope"}
!464 = distinct !{!464, !"scope"}
!465 = !{!466, !457, !452, !409, !411, !399, !401}
!466 = distinct !{!466, !467, !"scope"}
!467 = distinct !{!467, !"scope"}
!468 = !{!457, !452, !409, !411, !399, !401}
!469 = !{!470, !457, !452, !409, !411, !399, !401}
!470 = distinct !{!470, !471, !"scope"}
!471 = distinct !{!471, !"scope"}
!472 = !{!473, !452, !409, !411, !399, !401}
!473 = distinct !{!473, !474, !"scope"}
!474 = distinct !{!474, !"scope"}
!475 = !{!476, !452, !409, !411, !399, !401}
!476 = distinct !{!476, !477, !"scope"}
!477 = distinct !{!477, !"scope"}
!478 = !{!479, !476, !452, !409, !411, !399, !401}
!479 = distinct !{!479, !480, !"scope"}
!480 = distinct !{!480, !"scope"}
!481 = !{!482, !452, !409, !411, !399, !401}
!482 = distinct !{!482, !483, !"scope"}
!483 = distinct !{!483, !"scope"}
!484 = !{!485, !482, !452, !409, !411, !399, !401}
!485 = distinct !{!485, !486, !"scope"}
!486 = distinct !{!486, !"scope"}
!487 = !{!488, !490, !482, !452, !409, !411, !399, !401}
!488 = distinct !{!488, !489, !"scope"}
!489 = distinct !{!489, !"scope"}
!490 = distinct !{!490, !491, !"scope"}
!491 = distinct !{!491, !"scope"}
!492 = !{!490, !482, !452, !409, !411, !399, !401}
!493 = !{!494, !409, !411, !399, !401}
!494 = distinct !{!494, !495, !"scope"}
!495 = distinct !{!495, !"scope"}
!496 = !{!497, !409, !411, !399, !401}
!497 = distinct !{!497, !498, !"scope"}
!498 = distinct !{!498, !"scope"}
!499 = !{!500, !409, !411, !399, !401}
!500 = distinct !{!500, !501, !"scope"}
!501 = distinct !{!501, !"scope"}
!502 = !{!503, !500, !409, !411, !399, !401}
!503 = distinct !{!503, !504, !"scope"}
!504 = distinct !{!504, !"scope"}
!505 = !{!506, !500, !409, !411, !399, !401}
!506 = distinct !{!506, !507, !"scope"}
!507 = distinct !{!507, !"scope"}
!508 = !{!509, !511, !500, !409, !411, !399, !401}
!509 = distinct !{!509, !510, !"scope"}
!510 = distinct !{!510, !"scope"}
!511 = distinct !{!511, !512, !"scope"}
!512 = distinct !{!512, !"scope"}
!513 = !{!511, !500, !409, !411, !399, !401}
!514 = !{!515, !511, !500, !409, !411, !399, !401}
!515 = distinct !{!515, !516, !"scope"}
!516 = distinct !{!516, !"scope"}
!517 = !{!518, !409, !411, !399, !401}
!518 = distinct !{!518, !519, !"scope"}
!519 = distinct !{!519, !"scope"}
!520 = !{!521, !409, !411, !399, !401}
!521 = distinct !{!521, !522, !"scope"}
!522 = distinct !{!522, !"scope"}
!523 = !{!524, !409, !411, !399, !401}
!524 = distinct !{!524, !525, !"scope"}
!525 = distinct !{!525, !"scope"}
!526 = !{!527, !524, !409, !411, !399, !401}
!527 = distinct !{!527, !528, !"scope"}
!528 = distinct !{!528, !"scope"}
!529 = !{!530, !524, !409, !411, !399, !401}
!530 = distinct !{!530, !531, !"scope"}
!531 = distinct !{!531, !"scope"}
!532 = !{!533, !524, !409, !411, !399, !401}
!533 = distinct !{!533, !534, !"scope"}
!534 = distinct !{!534, !"scope"}
!535 = !{!536, !524, !409, !411, !399, !401}
!536 = distinct !{!536, !537, !"scope"}
!537 = distinct !{!537, !"scope"}
!538 = !{!539, !524, !409, !411, !399, !401}
!539 = distinct !{!539, !540, !"scope"}
!540 = distinct !{!540, !"scope"}
