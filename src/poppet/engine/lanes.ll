; made from lanes.py, integrator.py, stepping.py, job.py, rosenbrock.py, sha256 cd48958c5bfaeed5edbd3c5ae235ac5f5e3a8de95aa75dc9b836b89cc5b15e34
@.const.array.data = internal unnamed_addr constant [32 x i8] c"Nb\10X9\B4\D8?\E1z\14\AEG\E1\CA?)\\\8F\C2\F5(\E4?\00\00\00\00\00\00\F0?", align 8
define internal fastcc void @v66(ptr noalias nonnull writeonly %retptr, ptr %arg.f.4, i64 %arg.i) unnamed_addr {
entry:
  %.536 = alloca i64, align 8
  %.1396 = alloca ptr, align 8
  %.3615 = alloca ptr, align 8
  %.340.i = getelementptr i8, ptr %arg.f.4, i64 568
  %.341.i = load i64, ptr %.340.i, align 8, !noalias !0
  %.342.i = inttoptr i64 %.341.i to ptr
  %.668.i = load i64, ptr %arg.f.4, align 8, !noalias !0
  %.116 = icmp slt i64 %arg.i, 0
  %.117 = select i1 %.116, i64 %.668.i, i64 0
  %.118 = add i64 %.117, %arg.i
  %.139 = getelementptr i64, ptr %.342.i, i64 %.118
  %0 = getelementptr i64, ptr %.342.i, i64 %.668.i
  %.199 = getelementptr i64, ptr %0, i64 %.118
  %.527 = getelementptr i8, ptr %arg.f.4, i64 184
  %.1752 = getelementptr i8, ptr %arg.f.4, i64 368
  %.2079 = getelementptr i8, ptr %arg.f.4, i64 376
  %.45.i506 = getelementptr i8, ptr %arg.f.4, i64 360
  %.44.i = getelementptr i8, ptr %arg.f.4, i64 416
  %.44.i494 = getelementptr i8, ptr %arg.f.4, i64 408
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
  %.528 = load i64, ptr %.527, align 8
  %.529 = icmp slt i64 %.201, %.528
  br i1 %.529, label %B172, label %B382
B172:
  store i64 0, ptr %.536, align 8
  call fastcc void @v67(ptr %.536, ptr nonnull %arg.f.4, i64 %arg.i)
  %.552 = load i64, ptr %.536, align 8
  %.566 = icmp eq i64 %.552, 0
  br i1 %.566, label %B226, label %B36.backedge
B226:
  %.45.i = load i64, ptr %.44.i, align 8, !noalias !3
  %.46.i = inttoptr i64 %.45.i to ptr
  %.372.i = load i64, ptr %arg.f.4, align 8, !noalias !3
  %.938 = select i1 %.116, i64 %.372.i, i64 0
  %1 = getelementptr double, ptr %.46.i, i64 %arg.i
  %.960 = getelementptr double, ptr %1, i64 %.938
  %.961 = load double, ptr %.960, align 8
  %.45.i495 = load i64, ptr %.44.i494, align 8, !noalias !6
  %.46.i496 = inttoptr i64 %.45.i495 to ptr
  %.idx = mul i64 %.372.i, 80
  %2 = getelementptr i8, ptr %.46.i496, i64 %.idx
  %3 = getelementptr double, ptr %2, i64 %arg.i
  %.1359 = getelementptr double, ptr %3, i64 %.938
  %.1360 = load double, ptr %.1359, align 8
  %.1366 = fcmp olt double %.961, %.1360
  br i1 %.1366, label %common.ret, label %B36.backedge
common.ret:
  store ptr null, ptr %retptr, align 8
  ret void
B382:
  call fastcc void @v68(ptr %.1396, ptr nonnull %arg.f.4, i64 %arg.i, i64 %status.3.1)
  br label %B416
B416:
  %.1753 = load i64, ptr %.1752, align 8
  %.2080 = load i64, ptr %.2079, align 8
  %.2081.not = icmp slt i64 %.1753, %.2080
  br i1 %.2081.not, label %B492, label %B566
B492:
  %.46.i507 = load i64, ptr %.45.i506, align 8, !noalias !9
  %.50.i = inttoptr i64 %.46.i507 to ptr
  %.2446 = getelementptr i8, ptr %.50.i, i64 8
  %.2447 = load double, ptr %.2446, align 8
  %.2451 = fcmp une double %.2447, 0.000000e+00
  br i1 %.2451, label %B566, label %B710
B566:
  store i64 -1, ptr %.139, align 8
  %.45.i509 = load i64, ptr %.44.i, align 8, !noalias !12
  %.46.i510 = inttoptr i64 %.45.i509 to ptr
  %.372.i511 = load i64, ptr %arg.f.4, align 8, !noalias !12
  %.2891 = select i1 %.116, i64 %.372.i511, i64 0
  %4 = getelementptr double, ptr %.46.i510, i64 %.372.i511
  %5 = getelementptr double, ptr %4, i64 %arg.i
  %.2913 = getelementptr double, ptr %5, i64 %.2891
  store double 0.000000e+00, ptr %.2913, align 8
  %.3245 = getelementptr i8, ptr %arg.f.4, i64 384
  %.3246 = load i64, ptr %.3245, align 8
  %.3247 = add nsw i64 %.3246, -1
  store i64 %.3247, ptr %.3245, align 8
  br label %common.ret
B710:
  call fastcc void @v69(ptr %.3615, ptr nonnull %arg.f.4, i64 %arg.i, i64 %.1753)
  %.3967 = load i64, ptr %.1752, align 8
  %.3968 = add nsw i64 %.3967, 1
  store i64 %.3968, ptr %.1752, align 8
  br label %B36.backedge
B36.backedge:
  %status.3.1.be = phi i64 [ 0, %B710 ], [ %.552, %B226 ], [ %.552, %B172 ]
  br label %B36
}
define internal fastcc void @v67(ptr noalias nonnull writeonly %retptr, ptr readonly %arg.f.4, i64 %arg.i) unnamed_addr {
entry:
  %.49.i = alloca { [5 x i64], { { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, double, double, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, i8 }, { { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] } }, [13 x { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }], { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, align 8
  %.1733 = alloca i64, align 8
  %.3349 = alloca ptr, align 8
  %.44.i = getelementptr i8, ptr %arg.f.4, i64 408
  %.45.i = load i64, ptr %.44.i, align 8, !noalias !15
  %.46.i = inttoptr i64 %.45.i to ptr
  %.372.i = load i64, ptr %arg.f.4, align 8, !noalias !15
  %.340.i = getelementptr i8, ptr %arg.f.4, i64 568
  %.341.i = load i64, ptr %.340.i, align 8, !noalias !18
  %.342.i = inttoptr i64 %.341.i to ptr
  %.462 = icmp slt i64 %arg.i, 0
  %.463 = select i1 %.462, i64 %.372.i, i64 0
  %.464 = add i64 %.463, %arg.i
  %0 = getelementptr i64, ptr %.342.i, i64 %.372.i
  %.485 = getelementptr i64, ptr %0, i64 %.464
  %.486 = load i64, ptr %.485, align 8
  %.487 = add nsw i64 %.486, 1
  store i64 %.487, ptr %.485, align 8
  %.341.i.i = load i64, ptr %.340.i, align 8, !noalias !21
  %.342.i.i = inttoptr i64 %.341.i.i to ptr
  %.668.i.i = load i64, ptr %arg.f.4, align 8, !noalias !21
  %.96.i = select i1 %.462, i64 %.668.i.i, i64 0
  %1 = getelementptr i64, ptr %.342.i.i, i64 %.668.i.i
  %2 = getelementptr i64, ptr %1, i64 %arg.i
  %.118.i = getelementptr i64, ptr %2, i64 %.96.i
  %.119.i = load i64, ptr %.118.i, align 8, !noalias !26
  %.450.i = getelementptr i8, ptr %arg.f.4, i64 184
  %.451.i = load i64, ptr %.450.i, align 8, !noalias !26
  %.777.i = getelementptr i8, ptr %arg.f.4, i64 112
  %.778.i = load i64, ptr %.777.i, align 8, !noalias !26
  %.45.i.i = getelementptr i8, ptr %arg.f.4, i64 264
  %.46.i.i = load i64, ptr %.45.i.i, align 8, !noalias !27
  %.50.i.i = inttoptr i64 %.46.i.i to ptr
  %.1132.i = add nsw i64 %.119.i, 1
  %.1134.i = icmp slt i64 %.1132.i, %.451.i
  br i1 %.1134.i, label %B204.i, label %B226.i
B204.i:
  %.1151.i = icmp slt i64 %.119.i, -1
  %.1152.i = select i1 %.1151.i, i64 %.451.i, i64 0
  %3 = getelementptr double, ptr %.50.i.i, i64 %.1132.i
  %.1166.i = getelementptr double, ptr %3, i64 %.1152.i
  br label %B322.i
B226.i:
  %.1795.i = getelementptr i8, ptr %arg.f.4, i64 200
  %.1796.i = load i64, ptr %.1795.i, align 8, !noalias !26
  %.45.i376.i = getelementptr i8, ptr %arg.f.4, i64 304
  %.46.i377.i = load i64, ptr %.45.i376.i, align 8, !noalias !30
  %.50.i378.i = inttoptr i64 %.46.i377.i to ptr
  %4 = getelementptr double, ptr %.50.i378.i, i64 %.1796.i
  %.1862.i = getelementptr i8, ptr %4, i64 -8
  br label %B322.i
B322.i:
  %"$phi322.0.2.0.in.i" = phi ptr [ %.1166.i, %B204.i ], [ %.1862.i, %B226.i ]
  %"$phi322.0.2.0.i" = load double, ptr %"$phi322.0.2.0.in.i", align 8, !noalias !26
  %.45.i384.i = getelementptr i8, ptr %arg.f.4, i64 272
  %.46.i385.i = load i64, ptr %.45.i384.i, align 8, !noalias !33
  %.50.i386.i = inttoptr i64 %.46.i385.i to ptr
  %.2228.i = icmp slt i64 %.119.i, 0
  %.2229.i = select i1 %.2228.i, i64 %.451.i, i64 0
  %5 = getelementptr i64, ptr %.50.i386.i, i64 %.119.i
  %.2243.i = getelementptr i64, ptr %5, i64 %.2229.i
  %.2244.i = load i64, ptr %.2243.i, align 8, !noalias !26
  %.2573.i = getelementptr i8, ptr %arg.f.4, i64 224
  %.2574.i = load i64, ptr %.2573.i, align 8, !noalias !26
  %.2575.i = icmp sgt i64 %.2574.i, 0
  br i1 %.2575.i, label %B432.i, label %b83
B432.i:
  %.2905.i = getelementptr i8, ptr %arg.f.4, i64 192
  %.2906.i = load i64, ptr %.2905.i, align 8, !noalias !26
  %.2908.i = mul nsw i64 %.2906.i, %arg.i
  br label %b83
b83:
  %"$phi476.1.2.0.i" = phi i64 [ %.2908.i, %B432.i ], [ 0, %B322.i ]
  %.2922.i = add nsw i64 %"$phi476.1.2.0.i", %.2244.i
  %6 = getelementptr double, ptr %.50.i.i, i64 %.119.i
  %.2956.i = getelementptr double, ptr %6, i64 %.2229.i
  %.2957.i = load double, ptr %.2956.i, align 8, !noalias !26
  %.3290.i = getelementptr i8, ptr %arg.f.4, i64 280
  %.3291.i = load i64, ptr %.3290.i, align 8, !noalias !26
  %.3298.i = mul nsw i64 %.778.i, 56
  %.3299.i = mul nsw i64 %.3298.i, %.2922.i
  %.3300.i = add nsw i64 %.3291.i, %.3299.i
  %.3301.i = inttoptr i64 %.3300.i to ptr
  %.912 = getelementptr i8, ptr %arg.f.4, i64 144
  %.913 = load i64, ptr %.912, align 8
  %.914 = icmp sgt i64 %.913, 0
  %.44.i768 = getelementptr i8, ptr %arg.f.4, i64 416
  %.45.i769 = load i64, ptr %.44.i768, align 8, !noalias !36
  %.46.i770 = inttoptr i64 %.45.i769 to ptr
  %7 = getelementptr double, ptr %.46.i770, i64 %arg.i
  %.1336 = getelementptr double, ptr %7, i64 %.96.i
  store double %.2957.i, ptr %.1336, align 8
  %.idx = mul i64 %.372.i, 80
  %8 = getelementptr i8, ptr %.46.i, i64 %.idx
  %.1396 = getelementptr double, ptr %8, i64 %.464
  store double %"$phi322.0.2.0.i", ptr %.1396, align 8
  br i1 %.914, label %B368, label %B324
B324:
  %.1725 = getelementptr i8, ptr %arg.f.4, i64 208
  %.1726 = load i64, ptr %.1725, align 8
  %.1727 = icmp sgt i64 %.1726, 0
  br i1 %.1727, label %B368, label %B424
B368:
  store i64 0, ptr %.1733, align 8
  call fastcc void @v70(ptr %.1733, ptr nonnull %arg.f.4, i64 %arg.i, double %.2957.i, ptr %.3301.i, i64 7)
  %.1753 = load i64, ptr %.1733, align 8
  %.1763 = icmp sgt i64 %.1753, -1
  br i1 %.1763, label %common.ret, label %B424
common.ret:
  %storemerge = phi i64 [ 0, %b84 ], [ 1, %B368 ]
  store i64 %storemerge, ptr %retptr, align 8
  ret void
B424:
  %.2124 = getelementptr i8, ptr %arg.f.4, i64 288
  %.2125 = load i64, ptr %.2124, align 8
  %.2126 = inttoptr i64 %.2125 to ptr
  %.2453 = load i64, ptr %.450.i, align 8
  %.2547 = load i64, ptr %.485, align 8
  %.2560 = icmp slt i64 %.2547, 0
  %.2561 = select i1 %.2560, i64 %.2453, i64 0
  %9 = getelementptr i8, ptr %.2126, i64 %.2547
  %.2575 = getelementptr i8, ptr %9, i64 %.2561
  %.2576 = load i8, ptr %.2575, align 1
  %.2580.not = icmp eq i8 %.2576, 0
  br i1 %.2580.not, label %B648, label %B596
B596:
  %.idx749 = mul i64 %.372.i, 88
  %10 = getelementptr i8, ptr %.46.i, i64 %.idx749
  %.2635 = getelementptr double, ptr %10, i64 %.464
  %.2636 = load double, ptr %.2635, align 8
  %.2637 = fneg double %.2636
  store double %.2637, ptr %.2635, align 8
  br label %B648
B648:
  %.idx750 = shl i64 %.372.i, 5
  %11 = getelementptr i8, ptr %.46.i, i64 %.idx750
  %.2759 = getelementptr double, ptr %11, i64 %.464
  store double 0x3FD43D136248490F, ptr %.2759, align 8
  %.idx751 = mul i64 %.372.i, 40
  %12 = getelementptr i8, ptr %.46.i, i64 %.idx751
  %.2814 = getelementptr double, ptr %12, i64 %.464
  store double 0.000000e+00, ptr %.2814, align 8
  %.idx752 = mul i64 %.372.i, 112
  %13 = getelementptr i8, ptr %.46.i, i64 %.idx752
  %.2870 = getelementptr double, ptr %13, i64 %.464
  store double %.2957.i, ptr %.2870, align 8
  %.idx753 = mul i64 %.372.i, 96
  %14 = getelementptr i8, ptr %.46.i, i64 %.idx753
  %.2926 = getelementptr double, ptr %14, i64 %.464
  store double %.2957.i, ptr %.2926, align 8
  %.idx754 = mul i64 %.372.i, 104
  %15 = getelementptr i8, ptr %.46.i, i64 %.idx754
  %.2981 = getelementptr double, ptr %15, i64 %.464
  store double 0.000000e+00, ptr %.2981, align 8
  %.idx755 = shl i64 %.372.i, 4
  %16 = getelementptr i8, ptr %.342.i, i64 %.idx755
  %.3049 = getelementptr i64, ptr %16, i64 %.464
  store i64 0, ptr %.3049, align 8
  %17 = getelementptr i8, ptr %.342.i, i64 %.idx750
  %.3104 = getelementptr i64, ptr %17, i64 %.464
  store i64 1, ptr %.3104, align 8
  %.idx757 = mul i64 %.372.i, 48
  %18 = getelementptr i8, ptr %.342.i, i64 %.idx757
  %.3159 = getelementptr i64, ptr %18, i64 %.464
  store i64 -1, ptr %.3159, align 8
  %.3166 = fcmp ogt double %.2957.i, 0.000000e+00
  %or.cond = select i1 %.914, i1 true, i1 %.3166
  %. = zext i1 %or.cond to i64
  %19 = getelementptr i8, ptr %.342.i, i64 %.idx751
  %.3229 = getelementptr i64, ptr %19, i64 %.464
  store i64 %., ptr %.3229, align 8
  %spec.select.i = tail call i64 @llvm.smax.i64(i64 %.778.i, i64 0)
  br label %B66.i
B66.i:
  %.75.0.i = phi i64 [ 0, %B648 ], [ %.146.i, %B108.i ]
  %exitcond.not.i = icmp eq i64 %.75.0.i, %spec.select.i
  br i1 %exitcond.not.i, label %b85, label %B66.if.i
B108.i:
  %.146.i = add nuw i64 %.75.0.i, 1
  %.303.i = getelementptr i8, ptr %20, i64 16
  %.304.i = load double, ptr %.303.i, align 8, !noalias !39
  %.310.i = fcmp une double %.304.i, 0.000000e+00
  br i1 %.310.i, label %b85, label %B66.i
B66.if.i:
  %.idx785 = mul i64 %.75.0.i, 56
  %20 = getelementptr i8, ptr %.3301.i, i64 %.idx785
  %.233.i = getelementptr i8, ptr %20, i64 8
  %.234.i = load double, ptr %.233.i, align 8, !noalias !39
  %.240.i = fcmp une double %.234.i, 0.000000e+00
  br i1 %.240.i, label %b85, label %B108.i
b85:
  %21 = phi i64 [ 0, %B66.i ], [ 1, %B66.if.i ], [ 1, %B108.i ]
  %.idx759 = mul i64 %.372.i, 24
  %22 = getelementptr i8, ptr %.342.i, i64 %.idx759
  %.3333 = getelementptr i64, ptr %22, i64 %.464
  store i64 %21, ptr %.3333, align 8
  call fastcc void @v71(ptr %.3349, ptr nonnull %arg.f.4, i64 %arg.i, ptr %.3301.i, i64 7, double %.2957.i)
  call void @llvm.lifetime.start.p0(ptr nonnull %.49.i)
  %.fca.5.0.2.gep.i = getelementptr inbounds i8, ptr %.49.i, i64 872
  %.fca.5.0.4.gep.i = getelementptr inbounds i8, ptr %.49.i, i64 888
  call fastcc void @v72(ptr %.49.i, ptr nonnull readonly %arg.f.4, i64 %arg.i)
  %.65.fca.5.0.2.load.i = load i64, ptr %.fca.5.0.2.gep.i, align 8, !noalias !42
  %.65.fca.5.0.4.load.i = load ptr, ptr %.fca.5.0.4.gep.i, align 8, !noalias !42
  %.44.i.i = getelementptr i8, ptr %arg.f.4, i64 440
  %.45.i.i780 = load i64, ptr %.44.i.i, align 8, !noalias !45
  %.46.i.i781 = inttoptr i64 %.45.i.i780 to ptr
  %.372.i.i = load i64, ptr %arg.f.4, align 8, !noalias !45
  %.148211.not.i.i = icmp slt i64 %.65.fca.5.0.2.load.i, 1
  %invariant.gep.i = getelementptr double, ptr %.46.i.i781, i64 %arg.i
  %.1489.i = select i1 %.462, i64 %.372.i.i, i64 0
  %invariant.gep439.i = getelementptr double, ptr %invariant.gep.i, i64 %.1489.i
  br label %B138.if.i
B138.loopexit.i:
  %exitcond443.not.i = icmp eq i64 %.1173.i, 4
  br i1 %exitcond443.not.i, label %b84, label %B138.if.i
B138.if.i:
  %.1104.0442.i = phi i64 [ 0, %b85 ], [ %.1173.i, %B138.loopexit.i ]
  %.1173.i = add nuw nsw i64 %.1104.0442.i, 1
  %23 = getelementptr double, ptr @.const.array.data, i64 %.1104.0442.i
  %.1256.i = load double, ptr %23, align 8, !noalias !42
  %.1261.i = fmul double %.1256.i, 0.000000e+00
  %.1263.i = fadd double %.2957.i, %.1261.i
  br i1 %.148211.not.i.i, label %B138.loopexit.i, label %B58.if.i.i
B164.i.i:
  %.44.i.i.i = getelementptr i8, ptr %25, i64 24
  %.45.i.i.i = load double, ptr %.44.i.i.i, align 8, !noalias !48
  %.73.i.i.i = getelementptr i8, ptr %25, i64 32
  %.74.i.i.i = load double, ptr %.73.i.i.i, align 8, !noalias !48
  %.75.i.i.i = fmul double %.74.i.i.i, 5.000000e-01
  %.76.i.i.i = fmul double %.245.i.i, %.75.i.i.i
  %.77.i.i.i = fadd double %.45.i.i.i, %.76.i.i.i
  %.78.i.i.i = fmul double %.245.i.i, %.77.i.i.i
  %.87.le.i.i.i = tail call double @llvm.floor.f64(double %.78.i.i.i)
  %.92.i.i.i = fsub double %.78.i.i.i, %.87.le.i.i.i
  %.93.i.i.i = fmul double %.92.i.i.i, 0x401921FB54442D18
  %.121.i.i.i = getelementptr i8, ptr %25, i64 40
  %.122.i.i.i = load double, ptr %.121.i.i.i, align 8, !noalias !48
  %.126.i.i.i = fadd double %.122.i.i.i, %.93.i.i.i
  %.593.le.i.i = tail call double @llvm.sin.f64(double %.126.i.i.i)
  %.598.i.i = fmul double %.423.i.i, %.593.le.i.i
  %.600.i.i = fadd double %.361.i.i, %.598.i.i
  br label %B272.i.i
B272.i.i:
  %value.2.1.i.i = phi double [ %.600.i.i, %B164.i.i ], [ %.361.i.i, %B58.if.i.i ]
  %24 = getelementptr double, ptr %.65.fca.5.0.4.load.i, i64 %.90.0213.i.i
  store double %value.2.1.i.i, ptr %24, align 8, !noalias !53
  %exitcond.not.i.i = icmp eq i64 %.65.fca.5.0.2.load.i, %.161.i.i
  br i1 %exitcond.not.i.i, label %B260.preheader.i, label %B58.if.i.i
B260.preheader.i:
  %.1458.i = mul nuw nsw i64 %.1104.0442.i, %.65.fca.5.0.2.load.i
  br label %B260.if.i
B58.if.i.i:
  %.90.0213.i.i = phi i64 [ %.161.i.i, %B272.i.i ], [ 0, %B138.if.i ]
  %.161.i.i = add nuw nsw i64 %.90.0213.i.i, 1
  %.idx786 = mul i64 %.90.0213.i.i, 56
  %25 = getelementptr i8, ptr %.3301.i, i64 %.idx786
  %.242.i.i = getelementptr i8, ptr %25, i64 48
  %.243.i.i = load double, ptr %.242.i.i, align 8, !noalias !53
  %.245.i.i = fsub double %.1263.i, %.243.i.i
  %.303.i.i = load double, ptr %25, align 8, !noalias !53
  %.357.i.i = getelementptr i8, ptr %25, i64 8
  %.358.i.i = load double, ptr %.357.i.i, align 8, !noalias !53
  %.360.i.i = fmul double %.245.i.i, %.358.i.i
  %.361.i.i = fadd double %.303.i.i, %.360.i.i
  %.422.i.i = getelementptr i8, ptr %25, i64 16
  %.423.i.i = load double, ptr %.422.i.i, align 8, !noalias !53
  %.424.i.i = fcmp une double %.423.i.i, 0.000000e+00
  br i1 %.424.i.i, label %B164.i.i, label %B272.i.i
B260.if.i:
  %.1326.0437.i = phi i64 [ 0, %B260.preheader.i ], [ %.1395.i, %B260.if.i ]
  %.1395.i = add nuw nsw i64 %.1326.0437.i, 1
  %26 = getelementptr double, ptr %.65.fca.5.0.4.load.i, i64 %.1326.0437.i
  %.1449.i = load double, ptr %26, align 8, !noalias !42
  %.1459.i = add nuw nsw i64 %.1326.0437.i, %.1458.i
  %.1507.i = mul i64 %.1459.i, %.372.i.i
  %gep440.i = getelementptr double, ptr %invariant.gep439.i, i64 %.1507.i
  store double %.1449.i, ptr %gep440.i, align 8, !noalias !42
  %exitcond.not.i782 = icmp eq i64 %.1395.i, %.65.fca.5.0.2.load.i
  br i1 %exitcond.not.i782, label %B138.loopexit.i, label %B260.if.i
b84:
  call void @llvm.lifetime.end.p0(ptr nonnull %.49.i)
  br label %common.ret
}
define internal fastcc void @v68(ptr noalias nonnull writeonly %retptr, ptr readonly %arg.f.4, i64 %arg.i, i64 %arg.status) unnamed_addr {
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
  call fastcc void @v72(ptr %.27, ptr %arg.f.4, i64 %arg.i)
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
  %.797 = getelementptr i8, ptr %arg.f.4, i64 96
  %.798 = load i64, ptr %.797, align 8
  %.1124 = getelementptr i8, ptr %arg.f.4, i64 152
  %.1125 = load i64, ptr %.1124, align 8
  %.1451 = getelementptr i8, ptr %arg.f.4, i64 120
  %.1452 = load i64, ptr %.1451, align 8
  %.1778 = getelementptr i8, ptr %arg.f.4, i64 200
  %.1779 = load i64, ptr %.1778, align 8
  %.44.i = getelementptr i8, ptr %arg.f.4, i64 416
  %.45.i = load i64, ptr %.44.i, align 8, !noalias !54
  %.46.i = inttoptr i64 %.45.i to ptr
  %.372.i = load i64, ptr %arg.f.4, align 8, !noalias !54
  %.3253 = icmp slt i64 %arg.i, 0
  %.3254 = select i1 %.3253, i64 %.372.i, i64 0
  %0 = getelementptr double, ptr %.46.i, i64 %arg.i
  %.3276 = getelementptr double, ptr %0, i64 %.3254
  %.3277 = load double, ptr %.3276, align 8
  %.340.i = getelementptr i8, ptr %arg.f.4, i64 568
  %.341.i = load i64, ptr %.340.i, align 8, !noalias !57
  %.342.i = inttoptr i64 %.341.i to ptr
  %1 = getelementptr i64, ptr %.342.i, i64 %arg.i
  %.3378 = getelementptr i64, ptr %1, i64 %.3254
  %.3379 = load i64, ptr %.3378, align 8
  %.175117.not.i = icmp slt i64 %.43.fca.6.2.load, 1
  br i1 %.175117.not.i, label %b86, label %B76.if.lr.ph.i
B76.if.lr.ph.i:
  %.44.i.i = getelementptr i8, ptr %arg.f.4, i64 424
  %.45.i.i = load i64, ptr %.44.i.i, align 8, !noalias !60
  %.46.i.i = inttoptr i64 %.45.i.i to ptr
  %invariant.gep.i = getelementptr double, ptr %.46.i.i, i64 %arg.i
  %invariant.gep120.i = getelementptr double, ptr %invariant.gep.i, i64 %.3254
  br label %B76.if.i
B76.if.i:
  %.119.0118.i = phi i64 [ 0, %B76.if.lr.ph.i ], [ %.188.i, %B76.if.i ]
  %.188.i = add nuw nsw i64 %.119.0118.i, 1
  %.260.i = mul i64 %.119.0118.i, %.372.i
  %gep121.i = getelementptr double, ptr %invariant.gep120.i, i64 %.260.i
  %.265.i = load double, ptr %gep121.i, align 8, !noalias !65
  %2 = getelementptr double, ptr %.43.fca.6.4.load, i64 %.119.0118.i
  store double %.265.i, ptr %2, align 8, !noalias !65
  %exitcond.not.i = icmp eq i64 %.188.i, %.43.fca.6.2.load
  br i1 %exitcond.not.i, label %b86, label %B76.if.i
b86:
  %.4108 = add nsw i64 %.3379, 1
  %.4434 = getelementptr i8, ptr %arg.f.4, i64 344
  %.4435 = load i64, ptr %.4434, align 8
  %.4436 = mul nsw i64 %.4435, %.4108
  %.45.i2559 = getelementptr i8, ptr %arg.f.4, i64 336
  %.46.i2560 = load i64, ptr %.45.i2559, align 8, !noalias !66
  %.50.i = inttoptr i64 %.46.i2560 to ptr
  %.4802 = mul nsw i64 %.4435, %.3379
  %.4838 = icmp slt i64 %.4802, 0
  %.4839 = select i1 %.4838, i64 %.4436, i64 0
  %.4840 = add i64 %.4839, %.4802
  %.4843 = icmp slt i64 %.4840, 0
  br i1 %.4843, label %B0.endif.endif.endif.endif.endif.endif.else.if, label %B0.endif.endif.endif.endif.endif.endif.else.endif, !prof !69
B616:
  %.5019 = add nsw i64 %.1779, -1
  %.13.i = tail call i64 @llvm.smin.i64(i64 %.5019, i64 %.5017)
  store i64 %.13.i, ptr %.5016, align 8
  %.341.i.i = load i64, ptr %.340.i, align 8, !noalias !70
  %.342.i.i = inttoptr i64 %.341.i.i to ptr
  %.668.i.i = load i64, ptr %arg.f.4, align 8, !noalias !70
  %.96.i = select i1 %.3253, i64 %.668.i.i, i64 0
  %3 = getelementptr i64, ptr %.342.i.i, i64 %.668.i.i
  %4 = getelementptr i64, ptr %3, i64 %arg.i
  %.118.i = getelementptr i64, ptr %4, i64 %.96.i
  %.119.i = load i64, ptr %.118.i, align 8, !noalias !75
  %.450.i = getelementptr i8, ptr %arg.f.4, i64 184
  %.451.i = load i64, ptr %.450.i, align 8, !noalias !75
  %.777.i = getelementptr i8, ptr %arg.f.4, i64 112
  %.778.i = load i64, ptr %.777.i, align 8, !noalias !75
  %.45.i384.i = getelementptr i8, ptr %arg.f.4, i64 272
  %.46.i385.i = load i64, ptr %.45.i384.i, align 8, !noalias !76
  %.50.i386.i = inttoptr i64 %.46.i385.i to ptr
  %.2228.i = icmp slt i64 %.119.i, 0
  %.2229.i = select i1 %.2228.i, i64 %.451.i, i64 0
  %5 = getelementptr i64, ptr %.50.i386.i, i64 %.119.i
  %.2243.i = getelementptr i64, ptr %5, i64 %.2229.i
  %.2244.i = load i64, ptr %.2243.i, align 8, !noalias !75
  %.2573.i = getelementptr i8, ptr %arg.f.4, i64 224
  %.2574.i = load i64, ptr %.2573.i, align 8, !noalias !75
  %.2575.i = icmp sgt i64 %.2574.i, 0
  br i1 %.2575.i, label %B432.i, label %b83
B432.i:
  %.2905.i = getelementptr i8, ptr %arg.f.4, i64 192
  %.2906.i = load i64, ptr %.2905.i, align 8, !noalias !75
  %.2908.i = mul nsw i64 %.2906.i, %arg.i
  br label %b83
b83:
  %"$phi476.1.2.0.i" = phi i64 [ %.2908.i, %B432.i ], [ 0, %B616 ]
  %.2922.i = add nsw i64 %"$phi476.1.2.0.i", %.2244.i
  %.3290.i = getelementptr i8, ptr %arg.f.4, i64 280
  %.3291.i = load i64, ptr %.3290.i, align 8, !noalias !75
  %.3298.i = mul nsw i64 %.778.i, 56
  %.3299.i = mul nsw i64 %.3298.i, %.2922.i
  %.3300.i = add nsw i64 %.3299.i, %.3291.i
  %.3301.i = inttoptr i64 %.3300.i to ptr
  %.148211.not.i.i.i = icmp slt i64 %.43.fca.5.0.2.load, 1
  br i1 %.148211.not.i.i.i, label %b87, label %B58.if.i.i.i
B164.i.i.i:
  %.44.i.i.i.i = getelementptr i8, ptr %7, i64 24
  %.45.i.i.i.i = load double, ptr %.44.i.i.i.i, align 8, !noalias !79
  %.73.i.i.i.i = getelementptr i8, ptr %7, i64 32
  %.74.i.i.i.i = load double, ptr %.73.i.i.i.i, align 8, !noalias !79
  %.75.i.i.i.i = fmul double %.74.i.i.i.i, 5.000000e-01
  %.76.i.i.i.i = fmul double %.245.i.i.i, %.75.i.i.i.i
  %.77.i.i.i.i = fadd double %.45.i.i.i.i, %.76.i.i.i.i
  %.78.i.i.i.i = fmul double %.245.i.i.i, %.77.i.i.i.i
  %.87.le.i.i.i.i = tail call double @llvm.floor.f64(double %.78.i.i.i.i)
  %.92.i.i.i.i = fsub double %.78.i.i.i.i, %.87.le.i.i.i.i
  %.93.i.i.i.i = fmul double %.92.i.i.i.i, 0x401921FB54442D18
  %.121.i.i.i.i = getelementptr i8, ptr %7, i64 40
  %.122.i.i.i.i = load double, ptr %.121.i.i.i.i, align 8, !noalias !79
  %.126.i.i.i.i = fadd double %.122.i.i.i.i, %.93.i.i.i.i
  %.593.le.i.i.i = tail call double @llvm.sin.f64(double %.126.i.i.i.i)
  %.598.i.i.i = fmul double %.423.i.i.i, %.593.le.i.i.i
  %.600.i.i.i = fadd double %.361.i.i.i, %.598.i.i.i
  br label %B272.i.i.i
B272.i.i.i:
  %value.2.1.i.i.i = phi double [ %.600.i.i.i, %B164.i.i.i ], [ %.361.i.i.i, %B58.if.i.i.i ]
  %6 = getelementptr double, ptr %.43.fca.5.0.4.load, i64 %.90.0213.i.i.i
  store double %value.2.1.i.i.i, ptr %6, align 8, !noalias !88
  %exitcond.not.i.i.i = icmp eq i64 %.43.fca.5.0.2.load, %.161.i.i.i
  br i1 %exitcond.not.i.i.i, label %b87, label %B58.if.i.i.i
B58.if.i.i.i:
  %.90.0213.i.i.i = phi i64 [ %.161.i.i.i, %B272.i.i.i ], [ 0, %b83 ]
  %.161.i.i.i = add nuw nsw i64 %.90.0213.i.i.i, 1
  %.idx = mul i64 %.90.0213.i.i.i, 56
  %7 = getelementptr i8, ptr %.3301.i, i64 %.idx
  %.242.i.i.i = getelementptr i8, ptr %7, i64 48
  %.243.i.i.i = load double, ptr %.242.i.i.i, align 8, !noalias !88
  %.245.i.i.i = fsub double %.3277, %.243.i.i.i
  %.303.i.i.i = load double, ptr %7, align 8, !noalias !88
  %.357.i.i.i = getelementptr i8, ptr %7, i64 8
  %.358.i.i.i = load double, ptr %.357.i.i.i, align 8, !noalias !88
  %.360.i.i.i = fmul double %.245.i.i.i, %.358.i.i.i
  %.361.i.i.i = fadd double %.303.i.i.i, %.360.i.i.i
  %.422.i.i.i = getelementptr i8, ptr %7, i64 16
  %.423.i.i.i = load double, ptr %.422.i.i.i, align 8, !noalias !88
  %.424.i.i.i = fcmp une double %.423.i.i.i, 0.000000e+00
  br i1 %.424.i.i.i, label %B164.i.i.i, label %B272.i.i.i
b87:
  store double %.3277, ptr %.43.fca.5.3.4.load, align 8, !noalias !89
  %.992.i.i = inttoptr i64 %.43.fca.0.3.load to ptr
  tail call void %.992.i.i(ptr nonnull %.43.fca.5.3.4.load, ptr %.43.fca.6.4.load, ptr %.43.fca.5.0.4.load, ptr %.43.fca.1.0.4.load, ptr %.43.fca.3.2.4.load), !noalias !89
  %.649.i = load i64, ptr %.5016, align 8, !noalias !90
  %.754872.not.i = icmp slt i64 %.43.fca.3.2.2.load, 1
  br i1 %.754872.not.i, label %b88, label %B116.if.lr.ph.i
B116.if.lr.ph.i:
  %invariant.gep.i2563 = getelementptr double, ptr %.43.fca.3.1.4.load, i64 %.649.i
  %.879.i = icmp slt i64 %.649.i, 0
  %.880.i = select i1 %.879.i, i64 %.43.fca.3.1.5.1.load, i64 0
  %invariant.gep875.i = getelementptr double, ptr %invariant.gep.i2563, i64 %.880.i
  br label %B116.if.i
B116.if.i:
  %.698.0873.i = phi i64 [ 0, %B116.if.lr.ph.i ], [ %.767.i, %B116.if.i ]
  %.767.i = add nuw nsw i64 %.698.0873.i, 1
  %8 = getelementptr double, ptr %.43.fca.3.2.4.load, i64 %.698.0873.i
  %.821.i = load double, ptr %8, align 8, !noalias !90
  %.898.i = mul i64 %.698.0873.i, %.43.fca.3.1.5.1.load
  %gep876.i = getelementptr double, ptr %invariant.gep875.i, i64 %.898.i
  store double %.821.i, ptr %gep876.i, align 8, !noalias !90
  %exitcond.not.i2564 = icmp eq i64 %.767.i, %.43.fca.3.2.2.load
  br i1 %exitcond.not.i2564, label %b88, label %B116.if.i
b88:
  %.922.i = add nsw i64 %.649.i, 1
  store i64 %.922.i, ptr %.5016, align 8, !noalias !90
  br label %B896
B788:
  %.5323 = icmp sgt i64 %.5017, 0
  br i1 %.5323, label %B822, label %B896
B822:
  %9 = getelementptr double, ptr %.43.fca.3.0.4.load, i64 %.5017
  %.5411 = getelementptr i8, ptr %9, i64 -8
  %.5412 = load double, ptr %.5411, align 8
  br label %B896
B896:
  %.3277.sink = phi double [ %.3277, %b88 ], [ %.5412, %B822 ], [ 0.000000e+00, %B788 ]
  %10 = getelementptr double, ptr %.4941, i64 %.4925
  %.5286 = getelementptr i8, ptr %10, i64 -8
  store double %.3277.sink, ptr %.5286, align 8
  %.5485 = getelementptr i8, ptr %.43.fca.9.4.load, i64 16
  %.5486 = load i64, ptr %.5485, align 8
  %.44.i2565 = getelementptr i8, ptr %arg.f.4, i64 552
  %.45.i2566 = load i64, ptr %.44.i2565, align 8, !noalias !91
  %.46.i2567 = inttoptr i64 %.45.i2566 to ptr
  %.372.i2568 = load i64, ptr %arg.f.4, align 8, !noalias !91
  %.5859 = getelementptr i8, ptr %.43.fca.9.4.load, i64 40
  store i64 %arg.status, ptr %.5859, align 8
  %.59662588.not = icmp slt i64 %.798, 1
  br i1 %.59662588.not, label %B1150, label %B1026.if.preheader
B1026.if.preheader:
  %invariant.gep2613 = getelementptr double, ptr %.4941, i64 %.798
  br label %B1026.if
B1106.if.lr.ph:
  %spec.select2581 = mul nuw nsw i64 %.798, 3
  %invariant.gep = getelementptr double, ptr %.46.i2567, i64 %arg.i
  %.6226 = select i1 %.3253, i64 %.372.i2568, i64 0
  %invariant.gep2594 = getelementptr double, ptr %invariant.gep, i64 %.6226
  %.idx2608 = shl i64 %.798, 4
  %invariant.gep2615 = getelementptr i8, ptr %.4941, i64 %.idx2608
  br label %B1106.if
B1150:
  %.6301 = mul nsw i64 %.798, 5
  %.6303 = add nsw i64 %.6301, %.1125
  %.6340 = icmp slt i64 %.6303, 0
  %.6341 = select i1 %.6340, i64 %.4925, i64 0
  %.6342 = add i64 %.6341, %.6303
  %.6345 = icmp slt i64 %.6342, 0
  br i1 %.6345, label %B1150.else.if, label %B1150.else.endif, !prof !69
B1242.loopexit:
  %exitcond2607.not = icmp eq i64 %.6813, %.1452
  br i1 %exitcond2607.not, label %B1412, label %B1242.if
B1258:
  %.6893 = mul i64 %.6744.02601, %.43.fca.3.1.5.1.load
  %gep = getelementptr double, ptr %invariant.gep2599, i64 %.6893
  %.6897 = getelementptr i8, ptr %gep, i64 -8
  %.6898 = load double, ptr %.6897, align 8
  br label %B1306
B1306:
  %"$phi1306.1.2.1" = phi double [ %.6898, %B1258 ], [ 0x7FF8000000000000, %B1242.if ]
  %.6914 = add nsw i64 %.6912, %.6744.02601
  %.6929 = icmp slt i64 %.6914, 0
  %.6930 = select i1 %.6929, i64 %.4925, i64 0
  %11 = getelementptr double, ptr %.4941, i64 %.6914
  %.6944 = getelementptr double, ptr %11, i64 %.6930
  store double %"$phi1306.1.2.1", ptr %.6944, align 8
  br i1 %.70292596.not, label %B1242.loopexit, label %B1370.if.lr.ph
B1370.if.lr.ph:
  %.7114 = mul i64 %.6744.02601, %.43.fca.3.1.5.1.load
  %12 = getelementptr double, ptr %.43.fca.3.1.4.load, i64 %.7114
  br label %B1370.if
B1412:
  store ptr null, ptr %retptr, align 8
  ret void
B0.endif.endif.endif.endif.endif.endif.else.if:
  br label %B0.endif.endif.endif.endif.endif.endif.else.endif
B0.endif.endif.endif.endif.endif.endif.else.endif:
  %.4828.sroa.0.1 = phi i64 [ 0, %B0.endif.endif.endif.endif.endif.endif.else.if ], [ %.4840, %b86 ]
  %.4848.not = icmp slt i64 %.4840, %.4436
  br i1 %.4848.not, label %B0.endif.endif.endif.endi...endif.if, label %B0.endif.endif.endif.endif.endif.endif.else.endif.if, !prof !94
B0.endif.endif.endif.endif.endif.endif.else.endif.if:
  br label %B0.endif.endif.endif.endi...endif.if
B0.endif.endif.endif.endi...endif.if:
  %.4828.sroa.0.3 = phi i64 [ %.4436, %B0.endif.endif.endif.endif.endif.endif.else.endif.if ], [ %.4828.sroa.0.1, %B0.endif.endif.endif.endif.endif.endif.else.endif ]
  %.4916 = sub i64 %.4436, %.4828.sroa.0.3
  %.4925 = tail call i64 @llvm.smax.i64(i64 %.4916, i64 0)
  %.4941 = getelementptr double, ptr %.50.i, i64 %.4828.sroa.0.3
  %or.cond = icmp ult i64 %arg.status, 2
  %.5016 = getelementptr i8, ptr %.43.fca.9.4.load, i64 16
  %.5017 = load i64, ptr %.5016, align 8
  br i1 %or.cond, label %B616, label %B788
B1026.if:
  %.5910.02589 = phi i64 [ %.5979, %B1026.if ], [ 0, %B1026.if.preheader ]
  %.5979 = add nuw nsw i64 %.5910.02589, 1
  %13 = getelementptr double, ptr %.43.fca.6.4.load, i64 %.5910.02589
  %.6037 = load double, ptr %13, align 8
  %gep2614 = getelementptr double, ptr %invariant.gep2613, i64 %.5910.02589
  store double %.6037, ptr %gep2614, align 8
  %exitcond.not = icmp eq i64 %.798, %.5979
  br i1 %exitcond.not, label %B1106.if.lr.ph, label %B1026.if
B1106.if:
  %.6106.02593 = phi i64 [ %spec.select2581, %B1106.if.lr.ph ], [ %.6168, %B1106.if ]
  %.6103.02592 = phi i64 [ 0, %B1106.if.lr.ph ], [ %.6172, %B1106.if ]
  %.6168 = add nsw i64 %.6106.02593, -1
  %.6172 = add nuw nsw i64 %.6103.02592, 1
  %.6244 = mul i64 %.6103.02592, %.372.i2568
  %gep2595 = getelementptr double, ptr %invariant.gep2594, i64 %.6244
  %.6249 = load double, ptr %gep2595, align 8
  %gep2616 = getelementptr double, ptr %invariant.gep2615, i64 %.6103.02592
  store double %.6249, ptr %gep2616, align 8
  %.6159 = icmp ugt i64 %.6106.02593, 1
  br i1 %.6159, label %B1106.if, label %B1150
B1150.else.if:
  br label %B1150.else.endif
B1150.else.endif:
  %.6330.sroa.0.1 = phi i64 [ 0, %B1150.else.if ], [ %.6342, %B1150 ]
  %.6350.not = icmp slt i64 %.6342, %.4925
  br i1 %.6350.not, label %B1150.else.endif.endif.endif.if, label %B1150.else.endif.if, !prof !94
B1150.else.endif.if:
  br label %B1150.else.endif.endif.endif.if
B1150.else.endif.endif.endif.if:
  %.6330.sroa.0.3 = phi i64 [ %.4925, %B1150.else.endif.if ], [ %.6330.sroa.0.1, %B1150.else.endif ]
  %.6443 = getelementptr double, ptr %.4941, i64 %.6330.sroa.0.3
  %.797.i = load i64, ptr %.1124, align 8, !noalias !95
  %.798.i = icmp sgt i64 %.797.i, 0
  br i1 %.798.i, label %B48.i, label %b89
B48.i:
  %.10001676.not.i = icmp slt i64 %.43.fca.5.0.2.load, 1
  br i1 %.10001676.not.i, label %B144.i, label %B108.if.i.preheader
B108.if.i.preheader:
  %14 = shl nuw i64 %.43.fca.5.0.2.load, 3
  tail call void @llvm.memset.p0.i64(ptr align 8 %.43.fca.5.0.4.load, i8 0, i64 %14, i1 false), !noalias !95
  br label %B144.i
B144.i:
  store double 0.000000e+00, ptr %.43.fca.5.3.4.load, align 8, !noalias !95
  %.1652.i = getelementptr i8, ptr %arg.f.4, i64 72
  %.1653.i = load i64, ptr %.1652.i, align 8, !noalias !95
  %.2069.i = inttoptr i64 %.1653.i to ptr
  tail call void %.2069.i(ptr nonnull %.43.fca.5.3.4.load, ptr %.43.fca.6.4.load, ptr %.43.fca.5.0.4.load, ptr %.43.fca.1.0.4.load, ptr %.6443), !noalias !95
  br label %b89
b89:
  %invariant.gep2599 = getelementptr double, ptr %.43.fca.3.1.4.load, i64 %.5486
  %.68002600.not = icmp slt i64 %.1452, 1
  br i1 %.68002600.not, label %B1412, label %B1242.if.lr.ph
B1242.if.lr.ph:
  %.6842 = icmp sgt i64 %.5486, 0
  %.6911 = shl nsw i64 %.1125, 1
  %.6912 = add nsw i64 %.6911, %.6301
  %.6986 = sub i64 %.1779, %.5486
  %spec.select2582 = tail call i64 @llvm.smax.i64(i64 %.6986, i64 0)
  %.70292596.not = icmp slt i64 %.6986, 1
  br label %B1242.if
B1242.if:
  %.6744.02601 = phi i64 [ 0, %B1242.if.lr.ph ], [ %.6813, %B1242.loopexit ]
  %.6813 = add nuw nsw i64 %.6744.02601, 1
  br i1 %.6842, label %B1258, label %B1306
B1370.if:
  %.6976.02598 = phi i64 [ %spec.select2582, %B1370.if.lr.ph ], [ %.7038, %B1370.if ]
  %.6973.02597 = phi i64 [ %.5486, %B1370.if.lr.ph ], [ %.7042, %B1370.if ]
  %.7038 = add nsw i64 %.6976.02598, -1
  %.7042 = add i64 %.6973.02597, 1
  %.7095 = icmp slt i64 %.6973.02597, 0
  %.7096 = select i1 %.7095, i64 %.43.fca.3.1.5.1.load, i64 0
  %15 = getelementptr double, ptr %12, i64 %.6973.02597
  %.7118 = getelementptr double, ptr %15, i64 %.7096
  store double 0x7FF8000000000000, ptr %.7118, align 8
  %.7029 = icmp sgt i64 %.6976.02598, 1
  br i1 %.7029, label %B1370.if, label %B1242.loopexit
}
define internal fastcc void @v69(ptr noalias nonnull writeonly %retptr, ptr readonly %arg.f.4, i64 %arg.i, i64 %arg.k) unnamed_addr {
entry:
  %.633 = alloca { [5 x i64], { { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, double, double, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, i8 }, { { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] } }, [13 x { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }], { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, align 8
  %.fca.1.0.2.gep = getelementptr inbounds i8, ptr %.633, i64 56
  %.fca.1.0.4.gep = getelementptr inbounds i8, ptr %.633, i64 72
  %.fca.1.0.5.0.gep = getelementptr inbounds i8, ptr %.633, i64 80
  %.fca.1.4.2.gep = getelementptr inbounds i8, ptr %.633, i64 280
  %.fca.1.4.4.gep = getelementptr inbounds i8, ptr %.633, i64 296
  %.fca.2.0.4.gep = getelementptr inbounds i8, ptr %.633, i64 352
  %.fca.2.0.5.1.gep = getelementptr inbounds i8, ptr %.633, i64 368
  %.fca.2.1.4.gep = getelementptr inbounds i8, ptr %.633, i64 424
  %.fca.3.0.0.gep = getelementptr inbounds i8, ptr %.633, i64 528
  %.fca.5.0.2.gep = getelementptr inbounds i8, ptr %.633, i64 872
  %.fca.5.0.4.gep = getelementptr inbounds i8, ptr %.633, i64 888
  %.fca.5.3.4.gep = getelementptr inbounds i8, ptr %.633, i64 1056
  %.fca.6.2.gep3639 = getelementptr inbounds i8, ptr %.633, i64 1600
  %.fca.6.4.gep = getelementptr inbounds i8, ptr %.633, i64 1616
  %.fca.9.4.gep = getelementptr inbounds i8, ptr %.633, i64 1784
  %.340.i = getelementptr i8, ptr %arg.f.4, i64 568
  %.341.i = load i64, ptr %.340.i, align 8, !noalias !98
  %.342.i = inttoptr i64 %.341.i to ptr
  %.668.i = load i64, ptr %arg.f.4, align 8, !noalias !98
  %.99 = icmp slt i64 %arg.i, 0
  %.100 = select i1 %.99, i64 %.668.i, i64 0
  %0 = getelementptr i64, ptr %.342.i, i64 %arg.i
  %.122 = getelementptr i64, ptr %0, i64 %.100
  store i64 %arg.k, ptr %.122, align 8
  %.341.i4169 = load i64, ptr %.340.i, align 8, !noalias !101
  %.342.i4170 = inttoptr i64 %.341.i4169 to ptr
  %.668.i4171 = load i64, ptr %arg.f.4, align 8, !noalias !101
  %.202 = select i1 %.99, i64 %.668.i4171, i64 0
  %1 = getelementptr i64, ptr %.342.i4170, i64 %.668.i4171
  %2 = getelementptr i64, ptr %1, i64 %arg.i
  %.224 = getelementptr i64, ptr %2, i64 %.202
  store i64 -1, ptr %.224, align 8
  %.44.i = getelementptr i8, ptr %arg.f.4, i64 408
  %.45.i = load i64, ptr %.44.i, align 8, !noalias !104
  %.46.i = inttoptr i64 %.45.i to ptr
  %.372.i = load i64, ptr %arg.f.4, align 8, !noalias !104
  %.601 = select i1 %.99, i64 %.372.i, i64 0
  %.idx = mul i64 %.372.i, 88
  %3 = getelementptr i8, ptr %.46.i, i64 %.idx
  %4 = getelementptr double, ptr %3, i64 %arg.i
  %.623 = getelementptr double, ptr %4, i64 %.601
  store double 0.000000e+00, ptr %.623, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(521) %.633, i8 0, i64 521, i1 false)
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(1280) %.fca.3.0.0.gep, i8 0, i64 1280, i1 false)
  call fastcc void @v72(ptr %.633, ptr nonnull %arg.f.4, i64 %arg.i)
  %.649.fca.1.0.2.load = load i64, ptr %.fca.1.0.2.gep, align 8
  %.649.fca.1.0.4.load = load ptr, ptr %.fca.1.0.4.gep, align 8
  %.649.fca.1.0.5.0.load = load i64, ptr %.fca.1.0.5.0.gep, align 8
  %.649.fca.1.4.2.load = load i64, ptr %.fca.1.4.2.gep, align 8
  %.649.fca.1.4.4.load = load ptr, ptr %.fca.1.4.4.gep, align 8
  %.649.fca.2.0.4.load = load ptr, ptr %.fca.2.0.4.gep, align 8
  %.649.fca.2.0.5.1.load = load i64, ptr %.fca.2.0.5.1.gep, align 8
  %.649.fca.2.1.4.load = load ptr, ptr %.fca.2.1.4.gep, align 8
  %.649.fca.5.0.2.load = load i64, ptr %.fca.5.0.2.gep, align 8
  %.649.fca.5.0.4.load = load ptr, ptr %.fca.5.0.4.gep, align 8
  %.649.fca.5.3.4.load = load ptr, ptr %.fca.5.3.4.gep, align 8
  %.649.fca.6.2.load = load i64, ptr %.fca.6.2.gep3639, align 8
  %.649.fca.6.4.load = load ptr, ptr %.fca.6.4.gep, align 8
  %.649.fca.9.4.load = load ptr, ptr %.fca.9.4.gep, align 8
  %.1401 = getelementptr i8, ptr %arg.f.4, i64 96
  %.1402 = load i64, ptr %.1401, align 8
  %.1728 = getelementptr i8, ptr %arg.f.4, i64 104
  %.1729 = load i64, ptr %.1728, align 8
  %.2055 = getelementptr i8, ptr %arg.f.4, i64 216
  %.2056 = load i64, ptr %.2055, align 8
  %.341.i4188 = getelementptr i8, ptr %arg.f.4, i64 128
  %.45.i4191 = getelementptr i8, ptr %arg.f.4, i64 232
  %.46.i4192 = load i64, ptr %.45.i4191, align 8, !noalias !107
  %.50.i = inttoptr i64 %.46.i4192 to ptr
  %.3652 = icmp sgt i64 %.649.fca.1.0.2.load, 0
  br i1 %.3652, label %B504.if, label %B532
B532:
  %.45.i4193 = getelementptr i8, ptr %arg.f.4, i64 240
  %.46.i4194 = load i64, ptr %.45.i4193, align 8, !noalias !110
  %.50.i4195 = inttoptr i64 %.46.i4194 to ptr
  %.46174322.not = icmp slt i64 %.2056, 1
  br i1 %.46174322.not, label %B764, label %B720.if.lr.ph
B720.if.lr.ph:
  %.4464 = getelementptr i8, ptr %arg.f.4, i64 248
  %.4465 = load i64, ptr %.4464, align 8
  %.4466 = inttoptr i64 %.4465 to ptr
  %arg.k.lobit = lshr i64 %arg.k, 63
  %.4682 = add i64 %arg.k.lobit, %arg.k
  %.4702 = mul i64 %.2056, %.4682
  %5 = getelementptr double, ptr %.4466, i64 %.4702
  br label %B720.if
B764:
  %.5112 = getelementptr i8, ptr %arg.f.4, i64 256
  %.5113 = load i64, ptr %.5112, align 8
  %.5114 = inttoptr i64 %.5113 to ptr
  %.5835 = getelementptr i8, ptr %arg.f.4, i64 280
  %.5836 = load i64, ptr %.5835, align 8
  %.5837 = inttoptr i64 %.5836 to ptr
  %.6163 = getelementptr i8, ptr %arg.f.4, i64 112
  %.6164 = load i64, ptr %.6163, align 8
  %.6555 = getelementptr i8, ptr %arg.f.4, i64 224
  %.6556 = load i64, ptr %.6555, align 8
  %.66364328.not = icmp slt i64 %.6556, 1
  br i1 %.66364328.not, label %B1214, label %B1100.if.lr.ph
B1100.if.lr.ph:
  %.5487 = getelementptr i8, ptr %arg.f.4, i64 192
  %.5488 = load i64, ptr %.5487, align 8
  %.67574325.not = icmp slt i64 %.5488, 1
  %.6882 = mul nsw i64 %.5488, %arg.i
  %.7004 = mul i64 %.6164, 7
  br label %B1100.if
B1100.loopexit:
  %exitcond4355.not = icmp eq i64 %.6649, %.6556
  br i1 %exitcond4355.not, label %B1214, label %B1100.if
B1214:
  %.7369 = getelementptr i8, ptr %arg.f.4, i64 64
  %.7370 = load i64, ptr %.7369, align 8
  %.7396 = inttoptr i64 %.7370 to ptr
  tail call void %.7396(ptr %.649.fca.1.0.4.load, ptr %.649.fca.6.4.load, ptr %.649.fca.1.4.4.load)
  %.74874331.not = icmp slt i64 %.649.fca.1.4.2.load, 1
  br i1 %.74874331.not, label %B1398, label %B1332.if
B1398:
  %.372.i.i = load i64, ptr %arg.f.4, align 8, !noalias !113
  br i1 %.3652, label %B76.if.lr.ph.i, label %b90
B76.if.lr.ph.i:
  %.44.i.i = getelementptr i8, ptr %arg.f.4, i64 456
  %.45.i.i = load i64, ptr %.44.i.i, align 8, !noalias !113
  %.46.i.i = inttoptr i64 %.45.i.i to ptr
  %invariant.gep.i = getelementptr double, ptr %.46.i.i, i64 %arg.i
  %.272.i = select i1 %.99, i64 %.372.i.i, i64 0
  %invariant.gep120.i = getelementptr double, ptr %invariant.gep.i, i64 %.272.i
  br label %B76.if.i
B76.if.i:
  %.119.0118.i = phi i64 [ 0, %B76.if.lr.ph.i ], [ %.188.i, %B76.if.i ]
  %.188.i = add nuw nsw i64 %.119.0118.i, 1
  %6 = getelementptr double, ptr %.649.fca.1.0.4.load, i64 %.119.0118.i
  %.242.i = load double, ptr %6, align 8, !noalias !118
  %.290.i = mul i64 %.119.0118.i, %.372.i.i
  %gep121.i = getelementptr double, ptr %invariant.gep120.i, i64 %.290.i
  store double %.242.i, ptr %gep121.i, align 8, !noalias !118
  %exitcond.not.i = icmp eq i64 %.188.i, %.649.fca.1.0.2.load
  br i1 %exitcond.not.i, label %b91, label %B76.if.i
b91:
  %.372.i.i4213.pre = load i64, ptr %arg.f.4, align 8, !noalias !119
  br label %b90
b90:
  %.372.i.i4213 = phi i64 [ %.372.i.i4213.pre, %b91 ], [ %.372.i.i, %B1398 ]
  %.175117.not.i4214 = icmp slt i64 %.649.fca.6.2.load, 1
  br i1 %.175117.not.i4214, label %b92, label %B76.if.lr.ph.i4215
B76.if.lr.ph.i4215:
  %.44.i.i4216 = getelementptr i8, ptr %arg.f.4, i64 424
  %.45.i.i4217 = load i64, ptr %.44.i.i4216, align 8, !noalias !119
  %.46.i.i4218 = inttoptr i64 %.45.i.i4217 to ptr
  %invariant.gep.i4219 = getelementptr double, ptr %.46.i.i4218, i64 %arg.i
  %.272.i4221 = select i1 %.99, i64 %.372.i.i4213, i64 0
  %invariant.gep120.i4222 = getelementptr double, ptr %invariant.gep.i4219, i64 %.272.i4221
  br label %B76.if.i4223
B76.if.i4223:
  %.119.0118.i4224 = phi i64 [ 0, %B76.if.lr.ph.i4215 ], [ %.188.i4225, %B76.if.i4223 ]
  %.188.i4225 = add nuw nsw i64 %.119.0118.i4224, 1
  %7 = getelementptr double, ptr %.649.fca.6.4.load, i64 %.119.0118.i4224
  %.242.i4226 = load double, ptr %7, align 8, !noalias !124
  %.290.i4227 = mul i64 %.119.0118.i4224, %.372.i.i4213
  %gep121.i4228 = getelementptr double, ptr %invariant.gep120.i4222, i64 %.290.i4227
  store double %.242.i4226, ptr %gep121.i4228, align 8, !noalias !124
  %exitcond.not.i4229 = icmp eq i64 %.188.i4225, %.649.fca.6.2.load
  br i1 %exitcond.not.i4229, label %b92, label %B76.if.i4223
b92:
  %.9299 = getelementptr i8, ptr %arg.f.4, i64 160
  %.9300 = load i64, ptr %.9299, align 8
  %.9301 = inttoptr i64 %.9300 to ptr
  %.193303.not.i = icmp slt i64 %.1729, 1
  br i1 %.193303.not.i, label %B2014, label %B56.if.lr.ph.i
B56.if.lr.ph.i:
  %.45.i4231 = getelementptr i8, ptr %arg.f.4, i64 312
  %.46.i4232 = load i64, ptr %.45.i4231, align 8, !noalias !125
  %.50.i4233 = inttoptr i64 %.46.i4232 to ptr
  %.8956 = getelementptr i8, ptr %.50.i4233, i64 24
  %.8957 = load double, ptr %.8956, align 8
  %.idx.i = shl i64 %.1729, 4
  %8 = getelementptr i8, ptr %.9301, i64 %.idx.i
  %.383.i = fmul double %.8957, 2.500000e-01
  %9 = getelementptr double, ptr %.9301, i64 %.1729
  %10 = getelementptr double, ptr %.649.fca.2.0.4.load, i64 %.649.fca.2.0.5.1.load
  %.idx302.i = shl i64 %.649.fca.2.0.5.1.load, 4
  %11 = getelementptr i8, ptr %.649.fca.2.0.4.load, i64 %.idx302.i
  br label %B56.if.i
B140.i:
  %.265.i = tail call double @llvm.fabs.f64(double %.264.i)
  br label %B162.i
B144.i:
  %12 = getelementptr double, ptr %8, i64 %.135.0304.i
  %.375.i = load double, ptr %12, align 8, !noalias !128
  br label %B162.i
B162.i:
  %"$phi162.1.2.1.i" = phi double [ %.265.i, %B140.i ], [ %.375.i, %B144.i ]
  %.437.i = getelementptr double, ptr %.9301, i64 %.135.0304.i
  %.438.i = load double, ptr %.437.i, align 8, !noalias !128
  %.439.i = fmul double %.383.i, %.438.i
  %.499.i = getelementptr double, ptr %.649.fca.2.0.4.load, i64 %.135.0304.i
  store double %.439.i, ptr %.499.i, align 8, !noalias !128
  %.625.i = getelementptr double, ptr %9, i64 %.135.0304.i
  %.626.i = load double, ptr %.625.i, align 8, !noalias !128
  %.627.i = fmul double %.439.i, %.626.i
  %.628.i = fmul double %"$phi162.1.2.1.i", %.627.i
  %.688.i = getelementptr double, ptr %10, i64 %.135.0304.i
  store double %.628.i, ptr %.688.i, align 8, !noalias !128
  %.756.i = getelementptr double, ptr %11, i64 %.135.0304.i
  store double %"$phi162.1.2.1.i", ptr %.756.i, align 8, !noalias !128
  %exitcond.not.i4247 = icmp eq i64 %.206.i, %.1729
  br i1 %exitcond.not.i4247, label %B1910.preheader, label %B56.if.i
B56.if.i:
  %.135.0304.i = phi i64 [ 0, %B56.if.lr.ph.i ], [ %.206.i, %B162.i ]
  %.206.i = add nuw nsw i64 %.135.0304.i, 1
  %13 = getelementptr double, ptr %.649.fca.6.4.load, i64 %.135.0304.i
  %.264.i = load double, ptr %13, align 8, !noalias !128
  %14 = getelementptr i8, ptr %.649.fca.2.1.4.load, i64 %.135.0304.i
  %.303.i = load i8, ptr %14, align 1, !noalias !128
  %.307.i = icmp ne i8 %.303.i, 0
  %.310.i = fcmp one double %.264.i, 0.000000e+00
  %or.cond.i = select i1 %.307.i, i1 %.310.i, i1 false
  br i1 %or.cond.i, label %B140.i, label %B144.i
B1910.preheader:
  %.372.i42514309.ph = load i64, ptr %arg.f.4, align 8, !noalias !131
  %.46.i42624311.ph.in.in = getelementptr i8, ptr %arg.f.4, i64 536
  %.46.i42624311.ph.in = load i64, ptr %.46.i42624311.ph.in.in, align 8, !noalias !131
  %.46.i42624311.ph = inttoptr i64 %.46.i42624311.ph.in to ptr
  %invariant.gep = getelementptr double, ptr %.46.i42624311.ph, i64 %arg.i
  %.46.i42504307.ph.in.in = getelementptr i8, ptr %arg.f.4, i64 528
  %.46.i42504307.ph.in = load i64, ptr %.46.i42504307.ph.in.in, align 8, !noalias !131
  %.46.i42504307.ph = inttoptr i64 %.46.i42504307.ph.in to ptr
  %15 = getelementptr double, ptr %.649.fca.2.0.4.load, i64 %.649.fca.2.0.5.1.load
  %.idx4166 = shl i64 %.649.fca.2.0.5.1.load, 4
  %16 = getelementptr i8, ptr %.649.fca.2.0.4.load, i64 %.idx4166
  %.10476 = select i1 %.99, i64 %.372.i42514309.ph, i64 0
  %17 = getelementptr double, ptr %.46.i42504307.ph, i64 %.10476
  %invariant.gep4337 = getelementptr double, ptr %17, i64 %arg.i
  %invariant.gep4341 = getelementptr double, ptr %invariant.gep, i64 %.10476
  br label %B1910.if
B2014:
  %.10941 = add nsw i64 %arg.k, 1
  %.11267 = getelementptr i8, ptr %arg.f.4, i64 344
  %.11268 = load i64, ptr %.11267, align 8
  %.11269 = mul nsw i64 %.11268, %.10941
  %.45.i4272 = getelementptr i8, ptr %arg.f.4, i64 336
  %.46.i4273 = load i64, ptr %.45.i4272, align 8, !noalias !132
  %.50.i4274 = inttoptr i64 %.46.i4273 to ptr
  %.11636 = mul nsw i64 %.11268, %arg.k
  %.11674 = icmp slt i64 %.11636, 0
  %.11675 = select i1 %.11674, i64 %.11269, i64 0
  %.11676 = add i64 %.11675, %.11636
  %.11679 = icmp slt i64 %.11676, 0
  br i1 %.11679, label %B2014.endif.else.if, label %B2014.endif.else.endif, !prof !69
B2468:
  %.13156 = getelementptr i8, ptr %.649.fca.9.4.load, i64 24
  store i64 -1, ptr %.13156, align 8
  store ptr null, ptr %retptr, align 8
  ret void
B504.if:
  %.3638.04321 = phi i64 [ %.3707, %B504.if ], [ 0, %entry ]
  %.3707 = add nuw nsw i64 %.3638.04321, 1
  %18 = getelementptr double, ptr %.50.i, i64 %.3638.04321
  %.3761 = load double, ptr %18, align 8
  %19 = getelementptr double, ptr %.649.fca.1.0.4.load, i64 %.3638.04321
  store double %.3761, ptr %19, align 8
  %exitcond.not = icmp eq i64 %.649.fca.1.0.2.load, %.3707
  br i1 %exitcond.not, label %B532, label %B504.if
B720.if:
  %.4561.04323 = phi i64 [ 0, %B720.if.lr.ph ], [ %.4630, %B720.if ]
  %.4630 = add nuw nsw i64 %.4561.04323, 1
  %20 = getelementptr double, ptr %5, i64 %.4561.04323
  %.4707 = load double, ptr %20, align 8
  %21 = getelementptr i64, ptr %.50.i4195, i64 %.4561.04323
  %.4739 = load i64, ptr %21, align 8
  %.4753 = icmp slt i64 %.4739, 0
  %.4754 = select i1 %.4753, i64 %.649.fca.1.0.5.0.load, i64 0
  %22 = getelementptr double, ptr %.649.fca.1.0.4.load, i64 %.4739
  %.4768 = getelementptr double, ptr %22, i64 %.4754
  store double %.4707, ptr %.4768, align 8
  %exitcond4353.not = icmp eq i64 %.4630, %.2056
  br i1 %exitcond4353.not, label %B764, label %B720.if
B1100.if:
  %.6580.04329 = phi i64 [ 0, %B1100.if.lr.ph ], [ %.6649, %B1100.loopexit ]
  %.6649 = add nuw nsw i64 %.6580.04329, 1
  br i1 %.67574325.not, label %B1100.loopexit, label %B1134.if.lr.ph
B1134.if.lr.ph:
  %.idx4318 = shl i64 %.6580.04329, 4
  %23 = getelementptr i8, ptr %.5114, i64 %.idx4318
  %.6848 = getelementptr i8, ptr %23, i64 8
  br label %B1134.if
B1134.if:
  %.6701.04326 = phi i64 [ 0, %B1134.if.lr.ph ], [ %.6770, %B1134.if ]
  %.6770 = add nuw nsw i64 %.6701.04326, 1
  %.6849 = load i64, ptr %.6848, align 8
  %.6863 = icmp slt i64 %.6849, 0
  %.6864 = select i1 %.6863, i64 %.649.fca.1.0.5.0.load, i64 0
  %24 = getelementptr double, ptr %.649.fca.1.0.4.load, i64 %.6849
  %.6878 = getelementptr double, ptr %24, i64 %.6864
  %.6879 = load double, ptr %.6878, align 8
  %.6883 = add nsw i64 %.6701.04326, %.6882
  %.6938 = load i64, ptr %23, align 8
  %.6883.lobit = lshr i64 %.6883, 63
  %.6976 = add i64 %.6883.lobit, %.6883
  %.6977 = icmp slt i64 %.6938, 0
  %.6978 = select i1 %.6977, i64 %.6164, i64 0
  %.6979 = add i64 %.6978, %.6938
  %.7006 = mul i64 %.7004, %.6976
  %25 = getelementptr double, ptr %.5837, i64 %.7006
  %.7012.idx = mul i64 %.6979, 56
  %.7012 = getelementptr i8, ptr %25, i64 %.7012.idx
  store double %.6879, ptr %.7012, align 8
  %exitcond4354.not = icmp eq i64 %.5488, %.6770
  br i1 %exitcond4354.not, label %B1100.loopexit, label %B1134.if
B1332.if:
  %.7431.04332 = phi i64 [ %.7500, %B1332.if ], [ 0, %B1214 ]
  %.7500 = add nuw nsw i64 %.7431.04332, 1
  %26 = getelementptr double, ptr %.649.fca.1.4.4.load, i64 %.7431.04332
  %.7554 = load double, ptr %26, align 8
  %.7881 = load i64, ptr %.341.i4188, align 8
  %.7882 = add nsw i64 %.7881, %.7431.04332
  %.7896 = icmp slt i64 %.7882, 0
  %.7897 = select i1 %.7896, i64 %.649.fca.1.0.5.0.load, i64 0
  %27 = getelementptr double, ptr %.649.fca.1.0.4.load, i64 %.7882
  %.7911 = getelementptr double, ptr %27, i64 %.7897
  store double %.7554, ptr %.7911, align 8
  %exitcond4356.not = icmp eq i64 %.649.fca.1.4.2.load, %.7500
  br i1 %exitcond4356.not, label %B1398, label %B1332.if
B1910.if:
  %.10191.04335 = phi i64 [ 0, %B1910.preheader ], [ %.10260, %B1910.if ]
  %.10260 = add nuw nsw i64 %.10191.04335, 1
  %.10337 = getelementptr double, ptr %.649.fca.2.0.4.load, i64 %.10191.04335
  %.10338 = load double, ptr %.10337, align 8
  %.10391 = getelementptr double, ptr %15, i64 %.10191.04335
  %.10392 = load double, ptr %.10391, align 8
  %.10445 = getelementptr double, ptr %16, i64 %.10191.04335
  %.10446 = load double, ptr %.10445, align 8
  %.10494 = mul i64 %.10191.04335, %.372.i42514309.ph
  %gep4338 = getelementptr double, ptr %invariant.gep4337, i64 %.10494
  store double %.10338, ptr %gep4338, align 8
  %.10503 = add nuw nsw i64 %.10191.04335, %.1729
  %.10551 = mul i64 %.10503, %.372.i42514309.ph
  %gep4340 = getelementptr double, ptr %invariant.gep4337, i64 %.10551
  store double %.10392, ptr %gep4340, align 8
  %gep4342 = getelementptr double, ptr %invariant.gep4341, i64 %.10494
  store double %.10446, ptr %gep4342, align 8
  %exitcond4357.not = icmp eq i64 %.10260, %.1729
  br i1 %exitcond4357.not, label %B2014, label %B1910.if
B2014.endif.else.if:
  br label %B2014.endif.else.endif
B2014.endif.else.endif:
  %.11664.sroa.0.1 = phi i64 [ 0, %B2014.endif.else.if ], [ %.11676, %B2014 ]
  %.11684.not = icmp slt i64 %.11676, %.11269
  br i1 %.11684.not, label %B2014.endif.else.endif.endif.endif.if, label %B2014.endif.else.endif.if, !prof !94
B2014.endif.else.endif.if:
  br label %B2014.endif.else.endif.endif.endif.if
B2014.endif.else.endif.endif.endif.if:
  %.11664.sroa.0.3 = phi i64 [ %.11269, %B2014.endif.else.endif.if ], [ %.11664.sroa.0.1, %B2014.endif.else.endif ]
  %.11752 = sub i64 %.11269, %.11664.sroa.0.3
  %.11761 = tail call i64 @llvm.smax.i64(i64 %.11752, i64 0)
  %.11777 = getelementptr double, ptr %.50.i4274, i64 %.11664.sroa.0.3
  %.372.i4283 = load i64, ptr %arg.f.4, align 8, !noalias !135
  %.122524343.not = icmp slt i64 %.1402, 1
  br i1 %.122524343.not, label %B2346.else, label %B2248.if.lr.ph
B2248.if.lr.ph:
  %.44.i4280 = getelementptr i8, ptr %arg.f.4, i64 552
  %.45.i4281 = load i64, ptr %.44.i4280, align 8, !noalias !135
  %.46.i4282 = inttoptr i64 %.45.i4281 to ptr
  %.12386 = select i1 %.99, i64 %.372.i4283, i64 0
  %28 = getelementptr double, ptr %.46.i4282, i64 %.12386
  %invariant.gep4346 = getelementptr double, ptr %28, i64 %arg.i
  %.12470 = shl nuw nsw i64 %.1402, 1
  br label %B2248.if
B2248.if:
  %.12196.04344 = phi i64 [ 0, %B2248.if.lr.ph ], [ %.12265, %B2248.if ]
  %.12265 = add nuw nsw i64 %.12196.04344, 1
  %29 = getelementptr double, ptr %.649.fca.6.4.load, i64 %.12196.04344
  %.12323 = load double, ptr %29, align 8
  %30 = getelementptr double, ptr %.11777, i64 %.12196.04344
  store double %.12323, ptr %30, align 8
  %.12404 = mul i64 %.12196.04344, %.372.i4283
  %gep = getelementptr double, ptr %invariant.gep4346, i64 %.12404
  store double %.12323, ptr %gep, align 8
  %.12413 = add nuw nsw i64 %.12196.04344, %.1402
  %.12461 = mul i64 %.12413, %.372.i4283
  %gep4348 = getelementptr double, ptr %invariant.gep4346, i64 %.12461
  store double %.12323, ptr %gep4348, align 8
  %.12471 = add nuw nsw i64 %.12196.04344, %.12470
  %.12519 = mul i64 %.12471, %.372.i4283
  %gep4350 = getelementptr double, ptr %invariant.gep4346, i64 %.12519
  store double 0.000000e+00, ptr %gep4350, align 8
  %exitcond4358.not = icmp eq i64 %.12265, %.1402
  br i1 %exitcond4358.not, label %B2346.else, label %B2248.if
B2346.else:
  %.12543 = mul nsw i64 %.1402, 5
  %.12582 = icmp slt i64 %.1402, 0
  %.12583 = select i1 %.12582, i64 %.11761, i64 0
  %.12584 = add i64 %.12583, %.12543
  %.12587 = icmp slt i64 %.12584, 0
  br i1 %.12587, label %B2346.else.if, label %B2346.else.endif, !prof !69
B2346.else.if:
  br label %B2346.else.endif
B2346.else.endif:
  %.12572.sroa.0.1 = phi i64 [ 0, %B2346.else.if ], [ %.12584, %B2346.else ]
  %.12592.not = icmp slt i64 %.12584, %.11761
  br i1 %.12592.not, label %B2346.else.endif.endif.endif.if, label %B2346.else.endif.if, !prof !94
B2346.else.endif.if:
  br label %B2346.else.endif.endif.endif.if
B2346.else.endif.endif.endif.if:
  %.12572.sroa.0.3 = phi i64 [ %.11761, %B2346.else.endif.if ], [ %.12572.sroa.0.1, %B2346.else.endif ]
  %.12685 = getelementptr double, ptr %.11777, i64 %.12572.sroa.0.3
  %.796.i = getelementptr i8, ptr %arg.f.4, i64 152
  %.797.i = load i64, ptr %.796.i, align 8, !noalias !138
  %.798.i = icmp sgt i64 %.797.i, 0
  br i1 %.798.i, label %B48.i, label %B2442.if.preheader
B48.i:
  %.10001676.not.i = icmp slt i64 %.649.fca.5.0.2.load, 1
  br i1 %.10001676.not.i, label %B144.i4293, label %B108.if.i.preheader
B108.if.i.preheader:
  %31 = shl nuw i64 %.649.fca.5.0.2.load, 3
  tail call void @llvm.memset.p0.i64(ptr align 8 %.649.fca.5.0.4.load, i8 0, i64 %31, i1 false), !noalias !138
  br label %B144.i4293
B144.i4293:
  store double 0.000000e+00, ptr %.649.fca.5.3.4.load, align 8, !noalias !138
  %.1652.i = getelementptr i8, ptr %arg.f.4, i64 72
  %.1653.i = load i64, ptr %.1652.i, align 8, !noalias !138
  %.2069.i = inttoptr i64 %.1653.i to ptr
  tail call void %.2069.i(ptr nonnull %.649.fca.5.3.4.load, ptr %.649.fca.6.4.load, ptr %.649.fca.5.0.4.load, ptr %.649.fca.1.0.4.load, ptr %.12685), !noalias !138
  br label %B2442.if.preheader
B2442.if.preheader:
  br label %B2442.if
B2442.if:
  %.12870.04351 = phi i64 [ %.12939, %B2442.if ], [ 0, %B2442.if.preheader ]
  %.12939 = add nuw nsw i64 %.12870.04351, 1
  %32 = getelementptr i64, ptr %.649.fca.9.4.load, i64 %.12870.04351
  store i64 0, ptr %32, align 8
  %exitcond4359.not = icmp eq i64 %.12939, 5
  br i1 %exitcond4359.not, label %B2468, label %B2442.if
}
define internal fastcc void @v72(ptr noalias nonnull writeonly initializes((0, 1808)) %retptr, ptr readonly %arg.f.4, i64 %arg.i) unnamed_addr {
entry:
  %.341 = getelementptr i8, ptr %arg.f.4, i64 96
  %.342 = load i64, ptr %.341, align 8
  %.667 = getelementptr i8, ptr %arg.f.4, i64 104
  %.668 = load i64, ptr %.667, align 8
  %.993 = getelementptr i8, ptr %arg.f.4, i64 112
  %.994 = load i64, ptr %.993, align 8
  %.1319 = getelementptr i8, ptr %arg.f.4, i64 136
  %.1320 = load i64, ptr %.1319, align 8
  %.1645 = getelementptr i8, ptr %arg.f.4, i64 120
  %.1646 = load i64, ptr %.1645, align 8
  %.340.i = getelementptr i8, ptr %arg.f.4, i64 568
  %.341.i = load i64, ptr %.340.i, align 8, !noalias !141
  %.342.i = inttoptr i64 %.341.i to ptr
  %.668.i = load i64, ptr %arg.f.4, align 8, !noalias !141
  %.1749 = icmp slt i64 %arg.i, 0
  %.1750 = select i1 %.1749, i64 %.668.i, i64 0
  %0 = getelementptr i64, ptr %.342.i, i64 %arg.i
  %.1772 = getelementptr i64, ptr %0, i64 %.1750
  %.1773 = load i64, ptr %.1772, align 8
  %.2103 = getelementptr i8, ptr %arg.f.4, i64 584
  %.2104 = load i64, ptr %.2103, align 8
  %.341.i1658 = getelementptr i8, ptr %arg.f.4, i64 128
  %.342.i1659 = load i64, ptr %.341.i1658, align 8, !noalias !144
  %.669.i = add nsw i64 %.342.i1659, %.1320
  %.994.i = getelementptr i8, ptr %arg.f.4, i64 576
  %.995.i = load i64, ptr %.994.i, align 8, !noalias !144
  %.2144 = mul nsw i64 %.342, 6
  %.2145 = shl nsw i64 %.994, 1
  %.2146 = add nsw i64 %.2145, %.2144
  %.2611 = getelementptr i8, ptr %arg.f.4, i64 144
  %.2612 = load i64, ptr %.2611, align 8
  %.2754 = icmp slt i64 %.2146, 1
  br i1 %.2754, label %B0.endif.endif.endif.endi...endif.endif.if, label %B0.endif.endif.endif.endif.endif.endif.endif.endif, !prof !69
B0.endif.endif.endif.endif.endif.endif.endif.endif:
  %.2734.sroa.0.31750 = phi i64 [ %.2146, %B0.endif.endif.endif.endi...endif.endif.if ], [ 0, %entry ]
  %.45.i = getelementptr i8, ptr %arg.f.4, i64 312
  %.46.i = load i64, ptr %.45.i, align 8, !noalias !147
  %.50.i = inttoptr i64 %.46.i to ptr
  %.3538 = getelementptr i8, ptr %arg.f.4, i64 208
  %.3539 = load i64, ptr %.3538, align 8
  %.3554 = add nsw i64 %.994, %.2144
  %.3590 = icmp slt i64 %.342, 0
  %.3591 = select i1 %.3590, i64 %.2146, i64 0
  %.3592 = add i64 %.3591, %.2144
  %.3595 = icmp slt i64 %.3592, 0
  br i1 %.3595, label %B0.endif.endif.endif.endi...else.if, label %B0.endif.endif.endif.endi...else.endif, !prof !69
B0.endif.endif.endif.endi...endif.endif.if:
  br label %B0.endif.endif.endif.endif.endif.endif.endif.endif
B0.endif.endif.endif.endi...endif.3:
  %.3580.sroa.13.0 = phi i64 [ %.2146, %B0.endif.endif.endif.endi...else.endif.endif.endif.if ], [ %.3580.sroa.13.1, %B0.endif.endif.endif.endi...else.endif.endif.endif ]
  br i1 %.3612, label %B0.endif.endif.endif.endi...endif.3.else.if, label %B0.endif.endif.endif.endi...endif.3.else.endif, !prof !69
B0.endif.endif.endif.endi...else.if:
  br label %B0.endif.endif.endif.endi...else.endif
B0.endif.endif.endif.endi...else.endif:
  %.3580.sroa.0.1 = phi i64 [ 0, %B0.endif.endif.endif.endi...else.if ], [ %.3592, %B0.endif.endif.endif.endif.endif.endif.endif.endif ]
  %.3600.not = icmp slt i64 %.3592, %.2146
  br i1 %.3600.not, label %B0.endif.endif.endif.endi...else.endif.endif, label %B0.endif.endif.endif.endi...else.endif.if, !prof !94
B0.endif.endif.endif.endi...else.endif.if:
  br label %B0.endif.endif.endif.endi...else.endif.endif
B0.endif.endif.endif.endi...else.endif.endif:
  %.3580.sroa.0.3 = phi i64 [ %.2146, %B0.endif.endif.endif.endi...else.endif.if ], [ %.3580.sroa.0.1, %B0.endif.endif.endif.endi...else.endif ]
  %.3607 = icmp slt i64 %.3554, 0
  %.3608 = select i1 %.3607, i64 %.2146, i64 0
  %.3609 = add i64 %.3608, %.3554
  %.3612 = icmp slt i64 %.3609, 0
  br i1 %.3612, label %B0.endif.endif.endif.endi...else.endif.endif.if, label %B0.endif.endif.endif.endi...else.endif.endif.endif, !prof !69
B0.endif.endif.endif.endi...else.endif.endif.if:
  br label %B0.endif.endif.endif.endi...else.endif.endif.endif
B0.endif.endif.endif.endi...else.endif.endif.endif:
  %.3580.sroa.13.1 = phi i64 [ 0, %B0.endif.endif.endif.endi...else.endif.endif.if ], [ %.3609, %B0.endif.endif.endif.endi...else.endif.endif ]
  %.3617.not = icmp slt i64 %.3609, %.2146
  br i1 %.3617.not, label %B0.endif.endif.endif.endi...endif.3, label %B0.endif.endif.endif.endi...else.endif.endif.endif.if, !prof !94
B0.endif.endif.endif.endi...else.endif.endif.endif.if:
  br label %B0.endif.endif.endif.endi...endif.3
B0.endif.endif.endif.endi...endif.3.else.if:
  br label %B0.endif.endif.endif.endi...endif.3.else.endif
B0.endif.endif.endif.endi...endif.3.else.endif:
  %.3752.sroa.0.1 = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.3.else.if ], [ %.3609, %B0.endif.endif.endif.endi...endif.3 ]
  br i1 %.3617.not, label %B0.endif.endif.endif.endi...endif.4.if, label %B0.endif.endif.endif.endi...endif.3.else.endif.if, !prof !94
B0.endif.endif.endif.endi...endif.3.else.endif.if:
  br label %B0.endif.endif.endif.endi...endif.4.if
B0.endif.endif.endif.endi...endif.4.if:
  %.3752.sroa.0.3 = phi i64 [ %.2146, %B0.endif.endif.endif.endi...endif.3.else.endif.if ], [ %.3752.sroa.0.1, %B0.endif.endif.endif.endi...endif.3.else.endif ]
  br i1 %.2754, label %B0.endif.endif.endif.endi...if.6, label %B0.endif.endif.endif.endi...endif.6, !prof !69
B0.endif.endif.endif.endi...endif.3.endif.endif:
  %.3922.sroa.13.0 = phi i64 [ %.2146, %B0.endif.endif.endif.endi...endif.6.endif.if ], [ %.3922.sroa.13.1, %B0.endif.endif.endif.endi...endif.6.endif ]
  %.4067 = shl nsw i64 %.342, 1
  br i1 %.3954, label %B0.endif.endif.endif.endi...if.8, label %B0.endif.endif.endif.endi...endif.8, !prof !69
B0.endif.endif.endif.endi...if.6:
  br label %B0.endif.endif.endif.endi...endif.6
B0.endif.endif.endif.endi...endif.6:
  %.3922.sroa.0.3 = phi i64 [ %.2146, %B0.endif.endif.endif.endi...if.6 ], [ 0, %B0.endif.endif.endif.endi...endif.4.if ]
  %.3951 = add i64 %.3591, %.342
  %.3954 = icmp slt i64 %.3951, 0
  br i1 %.3954, label %B0.endif.endif.endif.endi...endif.6.if, label %B0.endif.endif.endif.endi...endif.6.endif, !prof !69
B0.endif.endif.endif.endi...endif.6.if:
  br label %B0.endif.endif.endif.endi...endif.6.endif
B0.endif.endif.endif.endi...endif.6.endif:
  %.3922.sroa.13.1 = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.6.if ], [ %.3951, %B0.endif.endif.endif.endi...endif.6 ]
  %.3959.not = icmp slt i64 %.3951, %.2146
  br i1 %.3959.not, label %B0.endif.endif.endif.endi...endif.3.endif.endif, label %B0.endif.endif.endif.endi...endif.6.endif.if, !prof !94
B0.endif.endif.endif.endi...endif.6.endif.if:
  br label %B0.endif.endif.endif.endi...endif.3.endif.endif
B0.endif.endif.endif.endi...endif.3.endif.endif.endif:
  %.4093.sroa.13.0 = phi i64 [ %.2146, %B0.endif.endif.endif.endi...endif.8.endif.endif.if ], [ %.4093.sroa.13.1, %B0.endif.endif.endif.endi...endif.8.endif.endif ]
  %.4239 = shl nsw i64 %.342, 2
  br i1 %.4125, label %B0.endif.endif.endif.endi...else.1.if, label %B0.endif.endif.endif.endi...else.1.endif, !prof !69
B0.endif.endif.endif.endi...if.8:
  br label %B0.endif.endif.endif.endi...endif.8
B0.endif.endif.endif.endi...endif.8:
  %.4093.sroa.0.1 = phi i64 [ 0, %B0.endif.endif.endif.endi...if.8 ], [ %.3951, %B0.endif.endif.endif.endi...endif.3.endif.endif ]
  br i1 %.3959.not, label %B0.endif.endif.endif.endi...endif.8.endif, label %B0.endif.endif.endif.endi...endif.8.if, !prof !94
B0.endif.endif.endif.endi...endif.8.if:
  br label %B0.endif.endif.endif.endi...endif.8.endif
B0.endif.endif.endif.endi...endif.8.endif:
  %.4093.sroa.0.3 = phi i64 [ %.2146, %B0.endif.endif.endif.endi...endif.8.if ], [ %.4093.sroa.0.1, %B0.endif.endif.endif.endi...endif.8 ]
  %.4122 = add i64 %.3591, %.4067
  %.4125 = icmp slt i64 %.4122, 0
  br i1 %.4125, label %B0.endif.endif.endif.endi...endif.8.endif.if, label %B0.endif.endif.endif.endi...endif.8.endif.endif, !prof !69
B0.endif.endif.endif.endi...endif.8.endif.if:
  br label %B0.endif.endif.endif.endi...endif.8.endif.endif
B0.endif.endif.endif.endi...endif.8.endif.endif:
  %.4093.sroa.13.1 = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.8.endif.if ], [ %.4122, %B0.endif.endif.endif.endi...endif.8.endif ]
  %.4130.not = icmp slt i64 %.4122, %.2146
  br i1 %.4130.not, label %B0.endif.endif.endif.endi...endif.3.endif.endif.endif, label %B0.endif.endif.endif.endi...endif.8.endif.endif.if, !prof !94
B0.endif.endif.endif.endi...endif.8.endif.endif.if:
  br label %B0.endif.endif.endif.endi...endif.3.endif.endif.endif
B0.endif.endif.endif.endi...endif.10:
  %.4265.sroa.13.0 = phi i64 [ %.2146, %B0.endif.endif.endif.endi...if.11 ], [ %.4265.sroa.13.1, %B0.endif.endif.endif.endi...else.1.endif.endif.endif ]
  %.4411 = mul nsw i64 %.342, 5
  br i1 %.4297, label %B0.endif.endif.endif.endi...endif.10.else.if, label %B0.endif.endif.endif.endi...endif.10.else.endif, !prof !69
B0.endif.endif.endif.endi...else.1.if:
  br label %B0.endif.endif.endif.endi...else.1.endif
B0.endif.endif.endif.endi...else.1.endif:
  %.4265.sroa.0.1 = phi i64 [ 0, %B0.endif.endif.endif.endi...else.1.if ], [ %.4122, %B0.endif.endif.endif.endi...endif.3.endif.endif.endif ]
  br i1 %.4130.not, label %B0.endif.endif.endif.endi...else.1.endif.endif, label %B0.endif.endif.endif.endi...else.1.endif.if, !prof !94
B0.endif.endif.endif.endi...else.1.endif.if:
  br label %B0.endif.endif.endif.endi...else.1.endif.endif
B0.endif.endif.endif.endi...else.1.endif.endif:
  %.4265.sroa.0.3 = phi i64 [ %.2146, %B0.endif.endif.endif.endi...else.1.endif.if ], [ %.4265.sroa.0.1, %B0.endif.endif.endif.endi...else.1.endif ]
  %.4294 = add i64 %.3591, %.4239
  %.4297 = icmp slt i64 %.4294, 0
  br i1 %.4297, label %B0.endif.endif.endif.endi...else.1.endif.endif.if, label %B0.endif.endif.endif.endi...else.1.endif.endif.endif, !prof !69
B0.endif.endif.endif.endi...else.1.endif.endif.if:
  br label %B0.endif.endif.endif.endi...else.1.endif.endif.endif
B0.endif.endif.endif.endi...else.1.endif.endif.endif:
  %.4265.sroa.13.1 = phi i64 [ 0, %B0.endif.endif.endif.endi...else.1.endif.endif.if ], [ %.4294, %B0.endif.endif.endif.endi...else.1.endif.endif ]
  %.4302.not = icmp slt i64 %.4294, %.2146
  br i1 %.4302.not, label %B0.endif.endif.endif.endi...endif.10, label %B0.endif.endif.endif.endi...if.11, !prof !94
B0.endif.endif.endif.endi...if.11:
  br label %B0.endif.endif.endif.endi...endif.10
B0.endif.endif.endif.endi...endif.10.endif:
  %.4437.sroa.13.0 = phi i64 [ %.2146, %B0.endif.endif.endif.endi...endif.13.if ], [ %.4437.sroa.13.1, %B0.endif.endif.endif.endi...endif.13 ]
  %.4992 = getelementptr i8, ptr %arg.f.4, i64 80
  %.4993 = load i64, ptr %.4992, align 8
  %.5318 = getelementptr i8, ptr %arg.f.4, i64 88
  %.5319 = load i64, ptr %.5318, align 8
  %.5691 = icmp slt i64 %.342.i1659, 0
  %.5692 = select i1 %.5691, i64 %.669.i, i64 0
  %.5693 = add i64 %.5692, %.342.i1659
  %.5696 = icmp slt i64 %.5693, 0
  br i1 %.5696, label %B0.endif.endif.endif.endi...endif.10.endif.else.if, label %B0.endif.endif.endif.endi...endif.10.endif.else.endif, !prof !69
B0.endif.endif.endif.endi...endif.10.else.if:
  br label %B0.endif.endif.endif.endi...endif.10.else.endif
B0.endif.endif.endif.endi...endif.10.else.endif:
  %.4437.sroa.0.1 = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.10.else.if ], [ %.4294, %B0.endif.endif.endif.endi...endif.10 ]
  br i1 %.4302.not, label %B0.endif.endif.endif.endi...endif.10.else.endif.endif, label %B0.endif.endif.endif.endi...endif.10.else.endif.if, !prof !94
B0.endif.endif.endif.endi...endif.10.else.endif.if:
  br label %B0.endif.endif.endif.endi...endif.10.else.endif.endif
B0.endif.endif.endif.endi...endif.10.else.endif.endif:
  %.4437.sroa.0.3 = phi i64 [ %.2146, %B0.endif.endif.endif.endi...endif.10.else.endif.if ], [ %.4437.sroa.0.1, %B0.endif.endif.endif.endi...endif.10.else.endif ]
  %.4466 = add i64 %.3591, %.4411
  %.4469 = icmp slt i64 %.4466, 0
  br i1 %.4469, label %B0.endif.endif.endif.endi...if.13, label %B0.endif.endif.endif.endi...endif.13, !prof !69
B0.endif.endif.endif.endi...if.13:
  br label %B0.endif.endif.endif.endi...endif.13
B0.endif.endif.endif.endi...endif.13:
  %.4437.sroa.13.1 = phi i64 [ 0, %B0.endif.endif.endif.endi...if.13 ], [ %.4466, %B0.endif.endif.endif.endi...endif.10.else.endif.endif ]
  %.4474.not = icmp slt i64 %.4466, %.2146
  br i1 %.4474.not, label %B0.endif.endif.endif.endi...endif.10.endif, label %B0.endif.endif.endif.endi...endif.13.if, !prof !94
B0.endif.endif.endif.endi...endif.13.if:
  br label %B0.endif.endif.endif.endi...endif.10.endif
B0.endif.endif.endif.endi...endif.10.endif.else.if:
  br label %B0.endif.endif.endif.endi...endif.10.endif.else.endif
B0.endif.endif.endif.endi...endif.10.endif.else.endif:
  %.5681.sroa.0.1 = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.10.endif.else.if ], [ %.5693, %B0.endif.endif.endif.endi...endif.10.endif ]
  %.5701.not = icmp slt i64 %.5693, %.669.i
  br i1 %.5701.not, label %B0.endif.endif.endif.endi...endif.15.endif.if, label %B0.endif.endif.endif.endi...if.15, !prof !94
B0.endif.endif.endif.endi...if.15:
  br label %B0.endif.endif.endif.endi...endif.15.endif.if
B0.endif.endif.endif.endi...endif.15.endif.if:
  %.5681.sroa.0.3 = phi i64 [ %.669.i, %B0.endif.endif.endif.endi...if.15 ], [ %.5681.sroa.0.1, %B0.endif.endif.endif.endi...endif.10.endif.else.endif ]
  %.6150 = getelementptr i8, ptr %arg.f.4, i64 176
  %.6151 = load i64, ptr %.6150, align 8
  %.6599 = getelementptr i8, ptr %arg.f.4, i64 168
  %.6600 = load i64, ptr %.6599, align 8
  %.6669 = load double, ptr %.50.i, align 8
  %.6697 = getelementptr i8, ptr %.50.i, i64 8
  %.6698 = load double, ptr %.6697, align 8
  %.7349 = getelementptr i8, ptr %arg.f.4, i64 200
  %.7350 = load i64, ptr %.7349, align 8
  %.45.i1695 = getelementptr i8, ptr %arg.f.4, i64 304
  %.46.i1696 = load i64, ptr %.45.i1695, align 8, !noalias !150
  %.341.i1703 = getelementptr i8, ptr %arg.f.4, i64 400
  %.342.i1704 = load i64, ptr %.341.i1703, align 8, !noalias !153
  %.667.i1705 = getelementptr i8, ptr %arg.f.4, i64 392
  %.668.i1706 = load i64, ptr %.667.i1705, align 8, !noalias !153
  %.8138 = getelementptr i8, ptr %arg.f.4, i64 320
  %.8139 = load i64, ptr %.8138, align 8
  %.8512 = getelementptr i8, ptr %arg.f.4, i64 328
  %.8513 = load i64, ptr %.8512, align 8
  br i1 %.4469, label %B0.endif.endif.endif.endi...if.21, label %B0.endif.endif.endif.endi...endif.21, !prof !69
B0.endif.endif.endif.endi...endif.20.endif.endif.endif:
  %.8611.sroa.13.0 = phi i64 [ %.2146, %B0.endif.endif.endif.endi...endif.21.endif.endif.if ], [ %.8611.sroa.13.1, %B0.endif.endif.endif.endi...endif.21.endif.endif ]
  %.25.i1726 = mul nsw i64 %.3539, 3
  %.8514 = inttoptr i64 %.8513 to ptr
  %.25.i1718 = shl nsw i64 %.3539, 1
  %.8140 = inttoptr i64 %.8139 to ptr
  %.25.i1710 = mul nsw i64 %.7350, %.1646
  %.16.i1709 = shl i64 %.7350, 3
  %.669.i1707 = sub nsw i64 %.1773, %.668.i1706
  %.670.i = shl i64 %.1646, 3
  %.997.i = mul i64 %.670.i, %.7350
  %.1327.i = mul i64 %.997.i, %.669.i1707
  %.1328.i = add nsw i64 %.1327.i, %.342.i1704
  %.7415 = inttoptr i64 %.1328.i to ptr
  %.50.i1697 = inttoptr i64 %.46.i1696 to ptr
  %inserted.nitems.11 = insertvalue { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } { ptr null, ptr null, i64 undef, i64 undef, ptr undef, [1 x i64] undef, [1 x i64] undef }, i64 %.668, 2
  %inserted.itemsize.11 = insertvalue { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } %inserted.nitems.11, i64 1, 3
  %.6601 = inttoptr i64 %.6600 to ptr
  %inserted.data.11 = insertvalue { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } %inserted.itemsize.11, ptr %.6601, 4
  %.6628 = insertvalue [1 x i64] undef, i64 %.668, 0
  %inserted.shape.11 = insertvalue { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } %inserted.data.11, [1 x i64] %.6628, 5
  %inserted.strides.11 = insertvalue { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } %inserted.shape.11, [1 x i64] [i64 1], 6
  %.25.i = mul nsw i64 %.668, 3
  %inserted.nitems.10 = insertvalue { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] } { ptr null, ptr null, i64 undef, i64 undef, ptr undef, [2 x i64] undef, [2 x i64] undef }, i64 %.25.i, 2
  %inserted.itemsize.10 = insertvalue { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] } %inserted.nitems.10, i64 8, 3
  %.2192 = shl nsw i64 %.2146, 3
  %.2193 = add nsw i64 %.2104, %.2192
  %.2284 = add i64 %.2193, 16
  %.2285 = add i64 %.2284, %.670.i
  %.2706 = add nsw i64 %.2612, %.1320
  %1 = add i64 %.1646, %.2706
  %2 = shl i64 %1, 3
  %.2708 = add i64 %2, %.2284
  %.6227 = inttoptr i64 %.2708 to ptr
  %inserted.data.10 = insertvalue { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] } %inserted.itemsize.10, ptr %.6227, 4
  %.6261 = insertvalue [2 x i64] [i64 3, i64 undef], i64 %.668, 1
  %inserted.shape.10 = insertvalue { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] } %inserted.data.10, [2 x i64] %.6261, 5
  %.16.i = shl i64 %.668, 3
  %.6263 = insertvalue [2 x i64] undef, i64 %.16.i, 0
  %.6265 = insertvalue [2 x i64] %.6263, i64 8, 1
  %inserted.strides.10 = insertvalue { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] } %inserted.shape.10, [2 x i64] %.6265, 6
  %.6152 = inttoptr i64 %.6151 to ptr
  %.999.i = shl nsw i64 %arg.i, 3
  %.1000.i = mul nsw i64 %.999.i, %.669.i
  %.1001.i = add nsw i64 %.1000.i, %.995.i
  %.1002.i = inttoptr i64 %.1001.i to ptr
  %.5794 = getelementptr double, ptr %.1002.i, i64 %.5681.sroa.0.3
  %.5769 = sub i64 %.669.i, %.5681.sroa.0.3
  %.5778 = tail call i64 @llvm.smax.i64(i64 %.5769, i64 0)
  %.2143 = inttoptr i64 %.2104 to ptr
  %.4550 = getelementptr double, ptr %.2143, i64 %.4437.sroa.0.3
  %.4525 = sub i64 %.4437.sroa.13.0, %.4437.sroa.0.3
  %.4534 = tail call i64 @llvm.smax.i64(i64 %.4525, i64 0)
  %.4378 = getelementptr double, ptr %.2143, i64 %.4265.sroa.0.3
  %.4353 = sub i64 %.4265.sroa.13.0, %.4265.sroa.0.3
  %.4362 = tail call i64 @llvm.smax.i64(i64 %.4353, i64 0)
  %.4206 = getelementptr double, ptr %.2143, i64 %.4093.sroa.0.3
  %.4181 = sub i64 %.4093.sroa.13.0, %.4093.sroa.0.3
  %.4190 = tail call i64 @llvm.smax.i64(i64 %.4181, i64 0)
  %.4035 = getelementptr double, ptr %.2143, i64 %.3922.sroa.0.3
  %.4010 = sub i64 %.3922.sroa.13.0, %.3922.sroa.0.3
  %.4019 = tail call i64 @llvm.smax.i64(i64 %.4010, i64 0)
  %.3865 = getelementptr double, ptr %.2143, i64 %.3752.sroa.0.3
  %.3840 = sub i64 %.2146, %.3752.sroa.0.3
  %.3849 = tail call i64 @llvm.smax.i64(i64 %.3840, i64 0)
  %.3693 = getelementptr double, ptr %.2143, i64 %.3580.sroa.0.3
  %.3668 = sub i64 %.3580.sroa.13.0, %.3580.sroa.0.3
  %.3677 = tail call i64 @llvm.smax.i64(i64 %.3668, i64 0)
  %.2847 = getelementptr double, ptr %.2143, i64 %.2734.sroa.0.31750
  %3 = add i64 %.1646, %.2612
  %4 = shl i64 %3, 3
  %.2659 = add i64 %4, %.2284
  %.2660 = inttoptr i64 %.2659 to ptr
  %.2286 = inttoptr i64 %.2285 to ptr
  %.2237 = inttoptr i64 %.2284 to ptr
  %.2194 = inttoptr i64 %.2193 to ptr
  %.8699 = sub i64 %.8611.sroa.13.0, %.8611.sroa.0.3
  %.8708 = tail call i64 @llvm.smax.i64(i64 %.8699, i64 0)
  %.8724 = getelementptr double, ptr %.2143, i64 %.8611.sroa.0.3
  %.45.i1734 = getelementptr i8, ptr %arg.f.4, i64 360
  %.46.i1735 = load i64, ptr %.45.i1734, align 8, !noalias !156
  %.50.i1736 = inttoptr i64 %.46.i1735 to ptr
  %.341.i1742 = getelementptr i8, ptr %arg.f.4, i64 352
  %.342.i1743 = load i64, ptr %.341.i1742, align 8, !noalias !159
  %.346.i = mul nsw i64 %.1773, 48
  %.347.i = add nsw i64 %.342.i1743, %.346.i
  %.348.i = inttoptr i64 %.347.i to ptr
  %.9713 = insertvalue { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } { ptr null, ptr null, i64 0, i64 8, ptr undef, [1 x i64] undef, [1 x i64] undef }, ptr %.2847, 4
  %.9714 = insertvalue { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } %.9713, [1 x i64] zeroinitializer, 5
  %.9715 = insertvalue { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } %.9714, [1 x i64] [i64 8], 6
  %.9717 = insertvalue { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, double, double, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, i8 } undef, { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] } %inserted.strides.10, 0
  %.9718 = insertvalue { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, double, double, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, i8 } %.9717, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } %inserted.strides.11, 1
  %.9719 = insertvalue { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, double, double, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, i8 } %.9718, double %.6669, 2
  %.9720 = insertvalue { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, double, double, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, i8 } %.9719, double %.6698, 3
  %.9721 = insertvalue { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, double, double, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, i8 } %.9720, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } %.9715, 4
  %.9722 = insertvalue { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, double, double, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, i8 } %.9721, i8 0, 5
  %retptr.repack1280 = getelementptr inbounds i8, ptr %retptr, i64 24
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %retptr, i8 0, i64 24, i1 false)
  store i64 %.4993, ptr %retptr.repack1280, align 8
  %retptr.repack1282 = getelementptr inbounds i8, ptr %retptr, i64 32
  store i64 %.5319, ptr %retptr.repack1282, align 8
  %retptr.repack1258 = getelementptr inbounds i8, ptr %retptr, i64 40
  %retptr.repack1258.repack1294 = getelementptr inbounds i8, ptr %retptr, i64 56
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %retptr.repack1258, i8 0, i64 16, i1 false)
  store i64 %.669.i, ptr %retptr.repack1258.repack1294, align 8
  %retptr.repack1258.repack1296 = getelementptr inbounds i8, ptr %retptr, i64 64
  store i64 8, ptr %retptr.repack1258.repack1296, align 8
  %retptr.repack1258.repack1298 = getelementptr inbounds i8, ptr %retptr, i64 72
  store ptr %.1002.i, ptr %retptr.repack1258.repack1298, align 8
  %retptr.repack1258.repack1300 = getelementptr inbounds i8, ptr %retptr, i64 80
  store i64 %.669.i, ptr %retptr.repack1258.repack1300, align 8
  %retptr.repack1258.repack1302 = getelementptr inbounds i8, ptr %retptr, i64 88
  store i64 8, ptr %retptr.repack1258.repack1302, align 8
  %retptr.repack1258.repack1284 = getelementptr inbounds i8, ptr %retptr, i64 96
  %retptr.repack1258.repack1284.repack1306 = getelementptr inbounds i8, ptr %retptr, i64 112
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %retptr.repack1258.repack1284, i8 0, i64 16, i1 false)
  store i64 %.5778, ptr %retptr.repack1258.repack1284.repack1306, align 8
  %retptr.repack1258.repack1284.repack1308 = getelementptr inbounds i8, ptr %retptr, i64 120
  store i64 8, ptr %retptr.repack1258.repack1284.repack1308, align 8
  %retptr.repack1258.repack1284.repack1310 = getelementptr inbounds i8, ptr %retptr, i64 128
  store ptr %.5794, ptr %retptr.repack1258.repack1284.repack1310, align 8
  %retptr.repack1258.repack1284.repack1312 = getelementptr inbounds i8, ptr %retptr, i64 136
  store i64 %.5778, ptr %retptr.repack1258.repack1284.repack1312, align 8
  %retptr.repack1258.repack1284.repack1314 = getelementptr inbounds i8, ptr %retptr, i64 144
  store i64 8, ptr %retptr.repack1258.repack1284.repack1314, align 8
  %retptr.repack1258.repack1286 = getelementptr inbounds i8, ptr %retptr, i64 152
  %retptr.repack1258.repack1286.repack1318 = getelementptr inbounds i8, ptr %retptr, i64 168
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %retptr.repack1258.repack1286, i8 0, i64 16, i1 false)
  store i64 %.1320, ptr %retptr.repack1258.repack1286.repack1318, align 8
  %retptr.repack1258.repack1286.repack1320 = getelementptr inbounds i8, ptr %retptr, i64 176
  store i64 1, ptr %retptr.repack1258.repack1286.repack1320, align 8
  %retptr.repack1258.repack1286.repack1322 = getelementptr inbounds i8, ptr %retptr, i64 184
  store ptr %.6152, ptr %retptr.repack1258.repack1286.repack1322, align 8
  %retptr.repack1258.repack1286.repack1324 = getelementptr inbounds i8, ptr %retptr, i64 192
  store i64 %.1320, ptr %retptr.repack1258.repack1286.repack1324, align 8
  %retptr.repack1258.repack1286.repack1326 = getelementptr inbounds i8, ptr %retptr, i64 200
  store i64 1, ptr %retptr.repack1258.repack1286.repack1326, align 8
  %retptr.repack1258.repack1288 = getelementptr inbounds i8, ptr %retptr, i64 208
  %retptr.repack1258.repack1288.repack1330 = getelementptr inbounds i8, ptr %retptr, i64 224
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %retptr.repack1258.repack1288, i8 0, i64 16, i1 false)
  store i64 %.2612, ptr %retptr.repack1258.repack1288.repack1330, align 8
  %retptr.repack1258.repack1288.repack1332 = getelementptr inbounds i8, ptr %retptr, i64 232
  store i64 8, ptr %retptr.repack1258.repack1288.repack1332, align 8
  %retptr.repack1258.repack1288.repack1334 = getelementptr inbounds i8, ptr %retptr, i64 240
  store ptr %.2286, ptr %retptr.repack1258.repack1288.repack1334, align 8
  %retptr.repack1258.repack1288.repack1336 = getelementptr inbounds i8, ptr %retptr, i64 248
  store i64 %.2612, ptr %retptr.repack1258.repack1288.repack1336, align 8
  %retptr.repack1258.repack1288.repack1338 = getelementptr inbounds i8, ptr %retptr, i64 256
  store i64 8, ptr %retptr.repack1258.repack1288.repack1338, align 8
  %retptr.repack1258.repack1290 = getelementptr inbounds i8, ptr %retptr, i64 264
  %retptr.repack1258.repack1290.repack1342 = getelementptr inbounds i8, ptr %retptr, i64 280
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %retptr.repack1258.repack1290, i8 0, i64 16, i1 false)
  store i64 %.1320, ptr %retptr.repack1258.repack1290.repack1342, align 8
  %retptr.repack1258.repack1290.repack1344 = getelementptr inbounds i8, ptr %retptr, i64 288
  store i64 8, ptr %retptr.repack1258.repack1290.repack1344, align 8
  %retptr.repack1258.repack1290.repack1346 = getelementptr inbounds i8, ptr %retptr, i64 296
  store ptr %.2660, ptr %retptr.repack1258.repack1290.repack1346, align 8
  %retptr.repack1258.repack1290.repack1348 = getelementptr inbounds i8, ptr %retptr, i64 304
  store i64 %.1320, ptr %retptr.repack1258.repack1290.repack1348, align 8
  %retptr.repack1258.repack1290.repack1350 = getelementptr inbounds i8, ptr %retptr, i64 312
  store i64 8, ptr %retptr.repack1258.repack1290.repack1350, align 8
  %retptr.repack1260 = getelementptr inbounds i8, ptr %retptr, i64 320
  store { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, double, double, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, i8 } %.9722, ptr %retptr.repack1260, align 8
  %retptr.repack1262 = getelementptr inbounds i8, ptr %retptr, i64 528
  %retptr.repack1262.repack1358 = getelementptr inbounds i8, ptr %retptr, i64 544
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %retptr.repack1262, i8 0, i64 16, i1 false)
  store i64 %.7350, ptr %retptr.repack1262.repack1358, align 8
  %retptr.repack1262.repack1360 = getelementptr inbounds i8, ptr %retptr, i64 552
  store i64 8, ptr %retptr.repack1262.repack1360, align 8
  %retptr.repack1262.repack1362 = getelementptr inbounds i8, ptr %retptr, i64 560
  store ptr %.50.i1697, ptr %retptr.repack1262.repack1362, align 8
  %retptr.repack1262.repack1364 = getelementptr inbounds i8, ptr %retptr, i64 568
  store i64 %.7350, ptr %retptr.repack1262.repack1364, align 8
  %retptr.repack1262.repack1366 = getelementptr inbounds i8, ptr %retptr, i64 576
  store i64 8, ptr %retptr.repack1262.repack1366, align 8
  %retptr.repack1262.repack1352 = getelementptr inbounds i8, ptr %retptr, i64 584
  %retptr.repack1262.repack1352.repack1370 = getelementptr inbounds i8, ptr %retptr, i64 600
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %retptr.repack1262.repack1352, i8 0, i64 16, i1 false)
  store i64 %.25.i1710, ptr %retptr.repack1262.repack1352.repack1370, align 8
  %retptr.repack1262.repack1352.repack1372 = getelementptr inbounds i8, ptr %retptr, i64 608
  store i64 8, ptr %retptr.repack1262.repack1352.repack1372, align 8
  %retptr.repack1262.repack1352.repack1374 = getelementptr inbounds i8, ptr %retptr, i64 616
  store ptr %.7415, ptr %retptr.repack1262.repack1352.repack1374, align 8
  %retptr.repack1262.repack1352.repack1376 = getelementptr inbounds i8, ptr %retptr, i64 624
  store i64 %.1646, ptr %retptr.repack1262.repack1352.repack1376, align 8
  %retptr.repack1262.repack1352.repack1376.repack1380 = getelementptr inbounds i8, ptr %retptr, i64 632
  store i64 %.7350, ptr %retptr.repack1262.repack1352.repack1376.repack1380, align 8
  %retptr.repack1262.repack1352.repack1378 = getelementptr inbounds i8, ptr %retptr, i64 640
  store i64 %.16.i1709, ptr %retptr.repack1262.repack1352.repack1378, align 8
  %retptr.repack1262.repack1352.repack1378.repack1382 = getelementptr inbounds i8, ptr %retptr, i64 648
  store i64 8, ptr %retptr.repack1262.repack1352.repack1378.repack1382, align 8
  %retptr.repack1262.repack1354 = getelementptr inbounds i8, ptr %retptr, i64 656
  %retptr.repack1262.repack1354.repack1386 = getelementptr inbounds i8, ptr %retptr, i64 672
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %retptr.repack1262.repack1354, i8 0, i64 16, i1 false)
  store i64 %.1646, ptr %retptr.repack1262.repack1354.repack1386, align 8
  %retptr.repack1262.repack1354.repack1388 = getelementptr inbounds i8, ptr %retptr, i64 680
  store i64 8, ptr %retptr.repack1262.repack1354.repack1388, align 8
  %retptr.repack1262.repack1354.repack1390 = getelementptr inbounds i8, ptr %retptr, i64 688
  store ptr %.2237, ptr %retptr.repack1262.repack1354.repack1390, align 8
  %retptr.repack1262.repack1354.repack1392 = getelementptr inbounds i8, ptr %retptr, i64 696
  store i64 %.1646, ptr %retptr.repack1262.repack1354.repack1392, align 8
  %retptr.repack1262.repack1354.repack1394 = getelementptr inbounds i8, ptr %retptr, i64 704
  store i64 8, ptr %retptr.repack1262.repack1354.repack1394, align 8
  %retptr.repack1264 = getelementptr inbounds i8, ptr %retptr, i64 712
  %retptr.repack1264.repack1400 = getelementptr inbounds i8, ptr %retptr, i64 728
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %retptr.repack1264, i8 0, i64 16, i1 false)
  store i64 %.25.i1718, ptr %retptr.repack1264.repack1400, align 8
  %retptr.repack1264.repack1402 = getelementptr inbounds i8, ptr %retptr, i64 736
  store i64 8, ptr %retptr.repack1264.repack1402, align 8
  %retptr.repack1264.repack1404 = getelementptr inbounds i8, ptr %retptr, i64 744
  store ptr %.8140, ptr %retptr.repack1264.repack1404, align 8
  %retptr.repack1264.repack1406 = getelementptr inbounds i8, ptr %retptr, i64 752
  store i64 %.3539, ptr %retptr.repack1264.repack1406, align 8
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
  store ptr %.8514, ptr %retptr.repack1264.repack1396.repack1420, align 8
  %retptr.repack1264.repack1396.repack1422 = getelementptr inbounds i8, ptr %retptr, i64 824
  store i64 %.3539, ptr %retptr.repack1264.repack1396.repack1422, align 8
  %retptr.repack1264.repack1396.repack1422.repack1426 = getelementptr inbounds i8, ptr %retptr, i64 832
  store i64 3, ptr %retptr.repack1264.repack1396.repack1422.repack1426, align 8
  %retptr.repack1264.repack1396.repack1424 = getelementptr inbounds i8, ptr %retptr, i64 840
  store i64 24, ptr %retptr.repack1264.repack1396.repack1424, align 8
  %retptr.repack1264.repack1396.repack1424.repack1428 = getelementptr inbounds i8, ptr %retptr, i64 848
  store i64 8, ptr %retptr.repack1264.repack1396.repack1424.repack1428, align 8
  %retptr.repack1266 = getelementptr inbounds i8, ptr %retptr, i64 856
  %retptr.repack1266.repack1456 = getelementptr inbounds i8, ptr %retptr, i64 872
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %retptr.repack1266, i8 0, i64 16, i1 false)
  store i64 %.3677, ptr %retptr.repack1266.repack1456, align 8
  %retptr.repack1266.repack1458 = getelementptr inbounds i8, ptr %retptr, i64 880
  store i64 8, ptr %retptr.repack1266.repack1458, align 8
  %retptr.repack1266.repack1460 = getelementptr inbounds i8, ptr %retptr, i64 888
  store ptr %.3693, ptr %retptr.repack1266.repack1460, align 8
  %retptr.repack1266.repack1462 = getelementptr inbounds i8, ptr %retptr, i64 896
  store i64 %.3677, ptr %retptr.repack1266.repack1462, align 8
  %retptr.repack1266.repack1464 = getelementptr inbounds i8, ptr %retptr, i64 904
  store i64 8, ptr %retptr.repack1266.repack1464, align 8
  %retptr.repack1266.repack1430 = getelementptr inbounds i8, ptr %retptr, i64 912
  %retptr.repack1266.repack1430.repack1470 = getelementptr inbounds i8, ptr %retptr, i64 936
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %retptr.repack1266.repack1430, i8 0, i64 24, i1 false)
  store i64 8, ptr %retptr.repack1266.repack1430.repack1470, align 8
  %retptr.repack1266.repack1430.repack1472 = getelementptr inbounds i8, ptr %retptr, i64 944
  store ptr %.2847, ptr %retptr.repack1266.repack1430.repack1472, align 8
  %retptr.repack1266.repack1430.repack1474 = getelementptr inbounds i8, ptr %retptr, i64 952
  store i64 0, ptr %retptr.repack1266.repack1430.repack1474, align 8
  %retptr.repack1266.repack1430.repack1476 = getelementptr inbounds i8, ptr %retptr, i64 960
  store i64 8, ptr %retptr.repack1266.repack1430.repack1476, align 8
  %retptr.repack1266.repack1432 = getelementptr inbounds i8, ptr %retptr, i64 968
  %retptr.repack1266.repack1432.repack1480 = getelementptr inbounds i8, ptr %retptr, i64 984
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %retptr.repack1266.repack1432, i8 0, i64 16, i1 false)
  store i64 %.3849, ptr %retptr.repack1266.repack1432.repack1480, align 8
  %retptr.repack1266.repack1432.repack1482 = getelementptr inbounds i8, ptr %retptr, i64 992
  store i64 8, ptr %retptr.repack1266.repack1432.repack1482, align 8
  %retptr.repack1266.repack1432.repack1484 = getelementptr inbounds i8, ptr %retptr, i64 1000
  store ptr %.3865, ptr %retptr.repack1266.repack1432.repack1484, align 8
  %retptr.repack1266.repack1432.repack1486 = getelementptr inbounds i8, ptr %retptr, i64 1008
  store i64 %.3849, ptr %retptr.repack1266.repack1432.repack1486, align 8
  %retptr.repack1266.repack1432.repack1488 = getelementptr inbounds i8, ptr %retptr, i64 1016
  store i64 8, ptr %retptr.repack1266.repack1432.repack1488, align 8
  %retptr.repack1266.repack1434 = getelementptr inbounds i8, ptr %retptr, i64 1024
  %retptr.repack1266.repack1434.repack1492 = getelementptr inbounds i8, ptr %retptr, i64 1040
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %retptr.repack1266.repack1434, i8 0, i64 16, i1 false)
  store i64 2, ptr %retptr.repack1266.repack1434.repack1492, align 8
  %retptr.repack1266.repack1434.repack1494 = getelementptr inbounds i8, ptr %retptr, i64 1048
  store i64 8, ptr %retptr.repack1266.repack1434.repack1494, align 8
  %retptr.repack1266.repack1434.repack1496 = getelementptr inbounds i8, ptr %retptr, i64 1056
  store ptr %.2194, ptr %retptr.repack1266.repack1434.repack1496, align 8
  %retptr.repack1266.repack1434.repack1498 = getelementptr inbounds i8, ptr %retptr, i64 1064
  store i64 2, ptr %retptr.repack1266.repack1434.repack1498, align 8
  %retptr.repack1266.repack1434.repack1500 = getelementptr inbounds i8, ptr %retptr, i64 1072
  store i64 8, ptr %retptr.repack1266.repack1434.repack1500, align 8
  %retptr.repack1266.repack1436 = getelementptr inbounds i8, ptr %retptr, i64 1080
  %retptr.repack1266.repack1436.repack1506 = getelementptr inbounds i8, ptr %retptr, i64 1104
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %retptr.repack1266.repack1436, i8 0, i64 24, i1 false)
  store i64 8, ptr %retptr.repack1266.repack1436.repack1506, align 8
  %retptr.repack1266.repack1436.repack1508 = getelementptr inbounds i8, ptr %retptr, i64 1112
  store ptr %.2847, ptr %retptr.repack1266.repack1436.repack1508, align 8
  %retptr.repack1266.repack1436.repack1510 = getelementptr inbounds i8, ptr %retptr, i64 1120
  store i64 0, ptr %retptr.repack1266.repack1436.repack1510, align 8
  %retptr.repack1266.repack1436.repack1512 = getelementptr inbounds i8, ptr %retptr, i64 1128
  store i64 8, ptr %retptr.repack1266.repack1436.repack1512, align 8
  %retptr.repack1266.repack1438 = getelementptr inbounds i8, ptr %retptr, i64 1136
  %retptr.repack1266.repack1438.repack1518 = getelementptr inbounds i8, ptr %retptr, i64 1160
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %retptr.repack1266.repack1438, i8 0, i64 24, i1 false)
  store i64 8, ptr %retptr.repack1266.repack1438.repack1518, align 8
  %retptr.repack1266.repack1438.repack1520 = getelementptr inbounds i8, ptr %retptr, i64 1168
  store ptr %.2847, ptr %retptr.repack1266.repack1438.repack1520, align 8
  %retptr.repack1266.repack1438.repack1522 = getelementptr inbounds i8, ptr %retptr, i64 1176
  store i64 0, ptr %retptr.repack1266.repack1438.repack1522, align 8
  %retptr.repack1266.repack1438.repack1524 = getelementptr inbounds i8, ptr %retptr, i64 1184
  store i64 8, ptr %retptr.repack1266.repack1438.repack1524, align 8
  %retptr.repack1266.repack1440 = getelementptr inbounds i8, ptr %retptr, i64 1192
  %retptr.repack1266.repack1440.repack1528 = getelementptr inbounds i8, ptr %retptr, i64 1208
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %retptr.repack1266.repack1440, i8 0, i64 16, i1 false)
  store i64 %.4019, ptr %retptr.repack1266.repack1440.repack1528, align 8
  %retptr.repack1266.repack1440.repack1530 = getelementptr inbounds i8, ptr %retptr, i64 1216
  store i64 8, ptr %retptr.repack1266.repack1440.repack1530, align 8
  %retptr.repack1266.repack1440.repack1532 = getelementptr inbounds i8, ptr %retptr, i64 1224
  store ptr %.4035, ptr %retptr.repack1266.repack1440.repack1532, align 8
  %retptr.repack1266.repack1440.repack1534 = getelementptr inbounds i8, ptr %retptr, i64 1232
  store i64 %.4019, ptr %retptr.repack1266.repack1440.repack1534, align 8
  %retptr.repack1266.repack1440.repack1536 = getelementptr inbounds i8, ptr %retptr, i64 1240
  store i64 8, ptr %retptr.repack1266.repack1440.repack1536, align 8
  %retptr.repack1266.repack1442 = getelementptr inbounds i8, ptr %retptr, i64 1248
  %retptr.repack1266.repack1442.repack1542 = getelementptr inbounds i8, ptr %retptr, i64 1272
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %retptr.repack1266.repack1442, i8 0, i64 24, i1 false)
  store i64 8, ptr %retptr.repack1266.repack1442.repack1542, align 8
  %retptr.repack1266.repack1442.repack1544 = getelementptr inbounds i8, ptr %retptr, i64 1280
  store ptr %.2847, ptr %retptr.repack1266.repack1442.repack1544, align 8
  %retptr.repack1266.repack1442.repack1546 = getelementptr inbounds i8, ptr %retptr, i64 1288
  store i64 0, ptr %retptr.repack1266.repack1442.repack1546, align 8
  %retptr.repack1266.repack1442.repack1548 = getelementptr inbounds i8, ptr %retptr, i64 1296
  store i64 8, ptr %retptr.repack1266.repack1442.repack1548, align 8
  %retptr.repack1266.repack1444 = getelementptr inbounds i8, ptr %retptr, i64 1304
  %retptr.repack1266.repack1444.repack1554 = getelementptr inbounds i8, ptr %retptr, i64 1328
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %retptr.repack1266.repack1444, i8 0, i64 24, i1 false)
  store i64 8, ptr %retptr.repack1266.repack1444.repack1554, align 8
  %retptr.repack1266.repack1444.repack1556 = getelementptr inbounds i8, ptr %retptr, i64 1336
  store ptr %.2847, ptr %retptr.repack1266.repack1444.repack1556, align 8
  %retptr.repack1266.repack1444.repack1558 = getelementptr inbounds i8, ptr %retptr, i64 1344
  store i64 0, ptr %retptr.repack1266.repack1444.repack1558, align 8
  %retptr.repack1266.repack1444.repack1560 = getelementptr inbounds i8, ptr %retptr, i64 1352
  store i64 8, ptr %retptr.repack1266.repack1444.repack1560, align 8
  %retptr.repack1266.repack1446 = getelementptr inbounds i8, ptr %retptr, i64 1360
  %retptr.repack1266.repack1446.repack1566 = getelementptr inbounds i8, ptr %retptr, i64 1384
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %retptr.repack1266.repack1446, i8 0, i64 24, i1 false)
  store i64 8, ptr %retptr.repack1266.repack1446.repack1566, align 8
  %retptr.repack1266.repack1446.repack1568 = getelementptr inbounds i8, ptr %retptr, i64 1392
  store ptr %.2847, ptr %retptr.repack1266.repack1446.repack1568, align 8
  %retptr.repack1266.repack1446.repack1570 = getelementptr inbounds i8, ptr %retptr, i64 1400
  store i64 0, ptr %retptr.repack1266.repack1446.repack1570, align 8
  %retptr.repack1266.repack1446.repack1572 = getelementptr inbounds i8, ptr %retptr, i64 1408
  store i64 8, ptr %retptr.repack1266.repack1446.repack1572, align 8
  %retptr.repack1266.repack1448 = getelementptr inbounds i8, ptr %retptr, i64 1416
  %retptr.repack1266.repack1448.repack1576 = getelementptr inbounds i8, ptr %retptr, i64 1432
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %retptr.repack1266.repack1448, i8 0, i64 16, i1 false)
  store i64 %.4190, ptr %retptr.repack1266.repack1448.repack1576, align 8
  %retptr.repack1266.repack1448.repack1578 = getelementptr inbounds i8, ptr %retptr, i64 1440
  store i64 8, ptr %retptr.repack1266.repack1448.repack1578, align 8
  %retptr.repack1266.repack1448.repack1580 = getelementptr inbounds i8, ptr %retptr, i64 1448
  store ptr %.4206, ptr %retptr.repack1266.repack1448.repack1580, align 8
  %retptr.repack1266.repack1448.repack1582 = getelementptr inbounds i8, ptr %retptr, i64 1456
  store i64 %.4190, ptr %retptr.repack1266.repack1448.repack1582, align 8
  %retptr.repack1266.repack1448.repack1584 = getelementptr inbounds i8, ptr %retptr, i64 1464
  store i64 8, ptr %retptr.repack1266.repack1448.repack1584, align 8
  %retptr.repack1266.repack1450 = getelementptr inbounds i8, ptr %retptr, i64 1472
  %retptr.repack1266.repack1450.repack1588 = getelementptr inbounds i8, ptr %retptr, i64 1488
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %retptr.repack1266.repack1450, i8 0, i64 16, i1 false)
  store i64 %.4362, ptr %retptr.repack1266.repack1450.repack1588, align 8
  %retptr.repack1266.repack1450.repack1590 = getelementptr inbounds i8, ptr %retptr, i64 1496
  store i64 8, ptr %retptr.repack1266.repack1450.repack1590, align 8
  %retptr.repack1266.repack1450.repack1592 = getelementptr inbounds i8, ptr %retptr, i64 1504
  store ptr %.4378, ptr %retptr.repack1266.repack1450.repack1592, align 8
  %retptr.repack1266.repack1450.repack1594 = getelementptr inbounds i8, ptr %retptr, i64 1512
  store i64 %.4362, ptr %retptr.repack1266.repack1450.repack1594, align 8
  %retptr.repack1266.repack1450.repack1596 = getelementptr inbounds i8, ptr %retptr, i64 1520
  store i64 8, ptr %retptr.repack1266.repack1450.repack1596, align 8
  %retptr.repack1266.repack1452 = getelementptr inbounds i8, ptr %retptr, i64 1528
  %retptr.repack1266.repack1452.repack1600 = getelementptr inbounds i8, ptr %retptr, i64 1544
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %retptr.repack1266.repack1452, i8 0, i64 16, i1 false)
  store i64 %.4534, ptr %retptr.repack1266.repack1452.repack1600, align 8
  %retptr.repack1266.repack1452.repack1602 = getelementptr inbounds i8, ptr %retptr, i64 1552
  store i64 8, ptr %retptr.repack1266.repack1452.repack1602, align 8
  %retptr.repack1266.repack1452.repack1604 = getelementptr inbounds i8, ptr %retptr, i64 1560
  store ptr %.4550, ptr %retptr.repack1266.repack1452.repack1604, align 8
  %retptr.repack1266.repack1452.repack1606 = getelementptr inbounds i8, ptr %retptr, i64 1568
  store i64 %.4534, ptr %retptr.repack1266.repack1452.repack1606, align 8
  %retptr.repack1266.repack1452.repack1608 = getelementptr inbounds i8, ptr %retptr, i64 1576
  store i64 8, ptr %retptr.repack1266.repack1452.repack1608, align 8
  %retptr.repack1268 = getelementptr inbounds i8, ptr %retptr, i64 1584
  %retptr.repack1268.repack1612 = getelementptr inbounds i8, ptr %retptr, i64 1600
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %retptr.repack1268, i8 0, i64 16, i1 false)
  store i64 %.8708, ptr %retptr.repack1268.repack1612, align 8
  %retptr.repack1268.repack1614 = getelementptr inbounds i8, ptr %retptr, i64 1608
  store i64 8, ptr %retptr.repack1268.repack1614, align 8
  %retptr.repack1268.repack1616 = getelementptr inbounds i8, ptr %retptr, i64 1616
  store ptr %.8724, ptr %retptr.repack1268.repack1616, align 8
  %retptr.repack1268.repack1618 = getelementptr inbounds i8, ptr %retptr, i64 1624
  store i64 %.8708, ptr %retptr.repack1268.repack1618, align 8
  %retptr.repack1268.repack1620 = getelementptr inbounds i8, ptr %retptr, i64 1632
  store i64 8, ptr %retptr.repack1268.repack1620, align 8
  %retptr.repack1270 = getelementptr inbounds i8, ptr %retptr, i64 1640
  %retptr.repack1270.repack1626 = getelementptr inbounds i8, ptr %retptr, i64 1664
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %retptr.repack1270, i8 0, i64 24, i1 false)
  store i64 8, ptr %retptr.repack1270.repack1626, align 8
  %retptr.repack1270.repack1628 = getelementptr inbounds i8, ptr %retptr, i64 1672
  store ptr %.2847, ptr %retptr.repack1270.repack1628, align 8
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
  store ptr %.348.i, ptr %retptr.repack1274.repack1652, align 8
  %retptr.repack1274.repack1654 = getelementptr inbounds i8, ptr %retptr, i64 1792
  store i64 6, ptr %retptr.repack1274.repack1654, align 8
  %retptr.repack1274.repack1656 = getelementptr inbounds i8, ptr %retptr, i64 1800
  store i64 8, ptr %retptr.repack1274.repack1656, align 8
  ret void
B0.endif.endif.endif.endi...if.21:
  br label %B0.endif.endif.endif.endi...endif.21
B0.endif.endif.endif.endi...endif.21:
  %.8611.sroa.0.1 = phi i64 [ 0, %B0.endif.endif.endif.endi...if.21 ], [ %.4466, %B0.endif.endif.endif.endi...endif.15.endif.if ]
  br i1 %.4474.not, label %B0.endif.endif.endif.endi...endif.21.endif, label %B0.endif.endif.endif.endi...endif.21.if, !prof !94
B0.endif.endif.endif.endi...endif.21.if:
  br label %B0.endif.endif.endif.endi...endif.21.endif
B0.endif.endif.endif.endi...endif.21.endif:
  %.8611.sroa.0.3 = phi i64 [ %.2146, %B0.endif.endif.endif.endi...endif.21.if ], [ %.8611.sroa.0.1, %B0.endif.endif.endif.endi...endif.21 ]
  br i1 %.3595, label %B0.endif.endif.endif.endi...endif.21.endif.if, label %B0.endif.endif.endif.endi...endif.21.endif.endif, !prof !69
B0.endif.endif.endif.endi...endif.21.endif.if:
  br label %B0.endif.endif.endif.endi...endif.21.endif.endif
B0.endif.endif.endif.endi...endif.21.endif.endif:
  %.8611.sroa.13.1 = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.21.endif.if ], [ %.3592, %B0.endif.endif.endif.endi...endif.21.endif ]
  br i1 %.3600.not, label %B0.endif.endif.endif.endi...endif.20.endif.endif.endif, label %B0.endif.endif.endif.endi...endif.21.endif.endif.if, !prof !94
B0.endif.endif.endif.endi...endif.21.endif.endif.if:
  br label %B0.endif.endif.endif.endi...endif.20.endif.endif.endif
}
declare double @llvm.fabs.f64(double)
declare double @llvm.sin.f64(double)
declare double @llvm.floor.f64(double)
define internal fastcc void @v70(ptr noalias nonnull writeonly %retptr, ptr readonly %arg.f.4, i64 %arg.i, double %arg.segment.0, ptr readonly %arg.segment.2.4, i64 %arg.segment.2.5.1) unnamed_addr {
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
  %.1287 = alloca i8, align 1
  store i8 0, ptr %.1287, align 1
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(521) %.46, i8 0, i64 521, i1 false)
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(1280) %.fca.3.0.0.gep, i8 0, i64 1280, i1 false)
  call fastcc void @v72(ptr %.46, ptr %arg.f.4, i64 %arg.i)
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
  %.372.i.i = load i64, ptr %arg.f.4, align 8, !noalias !162
  %.175117.not.i = icmp slt i64 %.62.fca.6.2.load, 1
  br i1 %.175117.not.i, label %b86, label %B76.if.lr.ph.i
B76.if.lr.ph.i:
  %.44.i.i = getelementptr i8, ptr %arg.f.4, i64 424
  %.45.i.i = load i64, ptr %.44.i.i, align 8, !noalias !162
  %.46.i.i = inttoptr i64 %.45.i.i to ptr
  %invariant.gep.i = getelementptr double, ptr %.46.i.i, i64 %arg.i
  %.241.i = icmp slt i64 %arg.i, 0
  %.242.i = select i1 %.241.i, i64 %.372.i.i, i64 0
  %invariant.gep120.i = getelementptr double, ptr %invariant.gep.i, i64 %.242.i
  br label %B76.if.i
B76.if.i:
  %.119.0118.i = phi i64 [ 0, %B76.if.lr.ph.i ], [ %.188.i, %B76.if.i ]
  %.188.i = add nuw nsw i64 %.119.0118.i, 1
  %.260.i = mul i64 %.119.0118.i, %.372.i.i
  %gep121.i = getelementptr double, ptr %invariant.gep120.i, i64 %.260.i
  %.265.i = load double, ptr %gep121.i, align 8, !noalias !167
  %0 = getelementptr double, ptr %.62.fca.6.4.load, i64 %.119.0118.i
  store double %.265.i, ptr %0, align 8, !noalias !167
  %exitcond.not.i = icmp eq i64 %.188.i, %.62.fca.6.2.load
  br i1 %exitcond.not.i, label %b86, label %B76.if.i
b86:
  %.1271 = getelementptr i8, ptr %arg.f.4, i64 144
  %.1272 = load i64, ptr %.1271, align 8
  %.1273 = icmp sgt i64 %.1272, 0
  br i1 %.1273, label %B146, label %B206
B146:
  call fastcc void @v73(ptr %.1287, ptr nonnull %arg.f.4, i64 %arg.i, i64 %.62.fca.0.4.load, ptr %.62.fca.1.0.4.load, i64 %.62.fca.1.1.2.load, ptr %.62.fca.1.1.4.load, ptr %.62.fca.1.2.4.load, i64 %.62.fca.1.3.2.load, ptr %.62.fca.1.3.4.load, ptr %.62.fca.1.4.4.load, i64 %.62.fca.5.0.2.load, ptr %.62.fca.5.0.4.load, ptr %.62.fca.5.3.4.load, ptr %arg.segment.2.4, i64 %arg.segment.2.5.1, double %arg.segment.0, ptr %.62.fca.6.4.load)
  br label %B206
B206:
  %.1748 = getelementptr i8, ptr %arg.f.4, i64 208
  %.1749 = load i64, ptr %.1748, align 8
  %.1755 = icmp sgt i64 %.1749, 0
  br i1 %.1755, label %B250, label %B206.B342_crit_edge
B206.B342_crit_edge:
  %.2088.phi.trans.insert = getelementptr i8, ptr %.62.fca.9.4.load, i64 24
  %.2089.pre = load i64, ptr %.2088.phi.trans.insert, align 8
  br label %B342
B250:
  %.148211.not.i.i.i = icmp slt i64 %.62.fca.5.0.2.load, 1
  br i1 %.148211.not.i.i.i, label %b87, label %B58.if.i.i.i
B164.i.i.i:
  %.44.i.i.i.i = getelementptr i8, ptr %2, i64 24
  %.45.i.i.i.i = load double, ptr %.44.i.i.i.i, align 8, !noalias !168
  %.73.i.i.i.i = getelementptr i8, ptr %2, i64 32
  %.74.i.i.i.i = load double, ptr %.73.i.i.i.i, align 8, !noalias !168
  %.75.i.i.i.i = fmul double %.74.i.i.i.i, 5.000000e-01
  %.76.i.i.i.i = fmul double %.245.i.i.i, %.75.i.i.i.i
  %.77.i.i.i.i = fadd double %.45.i.i.i.i, %.76.i.i.i.i
  %.78.i.i.i.i = fmul double %.245.i.i.i, %.77.i.i.i.i
  %.87.le.i.i.i.i = tail call double @llvm.floor.f64(double %.78.i.i.i.i)
  %.92.i.i.i.i = fsub double %.78.i.i.i.i, %.87.le.i.i.i.i
  %.93.i.i.i.i = fmul double %.92.i.i.i.i, 0x401921FB54442D18
  %.121.i.i.i.i = getelementptr i8, ptr %2, i64 40
  %.122.i.i.i.i = load double, ptr %.121.i.i.i.i, align 8, !noalias !168
  %.126.i.i.i.i = fadd double %.122.i.i.i.i, %.93.i.i.i.i
  %.593.le.i.i.i = tail call double @llvm.sin.f64(double %.126.i.i.i.i)
  %.598.i.i.i = fmul double %.423.i.i.i, %.593.le.i.i.i
  %.600.i.i.i = fadd double %.361.i.i.i, %.598.i.i.i
  br label %B272.i.i.i
B272.i.i.i:
  %value.2.1.i.i.i = phi double [ %.600.i.i.i, %B164.i.i.i ], [ %.361.i.i.i, %B58.if.i.i.i ]
  %1 = getelementptr double, ptr %.62.fca.5.0.4.load, i64 %.90.0213.i.i.i
  store double %value.2.1.i.i.i, ptr %1, align 8, !noalias !177
  %exitcond.not.i.i.i = icmp eq i64 %.62.fca.5.0.2.load, %.161.i.i.i
  br i1 %exitcond.not.i.i.i, label %b87, label %B58.if.i.i.i
B58.if.i.i.i:
  %.90.0213.i.i.i = phi i64 [ %.161.i.i.i, %B272.i.i.i ], [ 0, %B250 ]
  %.161.i.i.i = add nuw nsw i64 %.90.0213.i.i.i, 1
  %.238.i.i.i = mul i64 %.90.0213.i.i.i, %arg.segment.2.5.1
  %2 = getelementptr double, ptr %arg.segment.2.4, i64 %.238.i.i.i
  %.242.i.i.i = getelementptr i8, ptr %2, i64 48
  %.243.i.i.i = load double, ptr %.242.i.i.i, align 8, !noalias !177
  %.245.i.i.i = fsub double %arg.segment.0, %.243.i.i.i
  %.303.i.i.i = load double, ptr %2, align 8, !noalias !177
  %.357.i.i.i = getelementptr i8, ptr %2, i64 8
  %.358.i.i.i = load double, ptr %.357.i.i.i, align 8, !noalias !177
  %.360.i.i.i = fmul double %.245.i.i.i, %.358.i.i.i
  %.361.i.i.i = fadd double %.303.i.i.i, %.360.i.i.i
  %.422.i.i.i = getelementptr i8, ptr %2, i64 16
  %.423.i.i.i = load double, ptr %.422.i.i.i, align 8, !noalias !177
  %.424.i.i.i = fcmp une double %.423.i.i.i, 0.000000e+00
  br i1 %.424.i.i.i, label %B164.i.i.i, label %B272.i.i.i
b87:
  store double %arg.segment.0, ptr %.62.fca.5.3.4.load, align 8, !noalias !178
  %.992.i.i = inttoptr i64 %.62.fca.0.3.load to ptr
  tail call void %.992.i.i(ptr nonnull %.62.fca.5.3.4.load, ptr %.62.fca.6.4.load, ptr %.62.fca.5.0.4.load, ptr %.62.fca.1.0.4.load, ptr %.62.fca.3.2.4.load), !noalias !178
  %spec.select.i = tail call i64 @llvm.smax.i64(i64 %.62.fca.4.1.5.0.load, i64 0)
  br label %B140.i
B140.i:
  %.859.0.i = phi i64 [ 0, %b87 ], [ %.928.i, %B288.i ]
  %exitcond294.not.i = icmp eq i64 %.859.0.i, %spec.select.i
  br i1 %exitcond294.not.i, label %b93, label %B142.i
B142.i:
  %.1005.i = mul i64 %.859.0.i, %.62.fca.4.1.5.1.load
  %3 = getelementptr double, ptr %.62.fca.4.1.4.load, i64 %.1005.i
  %.1009.i = getelementptr i8, ptr %3, i64 16
  %.1010.i = load double, ptr %.1009.i, align 8, !noalias !179
  %.1186.i = mul i64 %.859.0.i, %.62.fca.4.0.5.1.load
  %4 = getelementptr i64, ptr %.62.fca.4.0.4.load, i64 %.1186.i
  br label %B194.if.i
B226.i:
  %5 = getelementptr double, ptr %3, i64 %.1037.0289.i
  %.1249.i = load double, ptr %5, align 8, !noalias !179
  %.1338.i = getelementptr double, ptr %.62.fca.3.2.4.load, i64 %.1191.i
  %.1339.i = load double, ptr %.1338.i, align 8, !noalias !179
  %.1340.i = fmul double %.1249.i, %.1339.i
  %.1342.i = fadd double %value.2.1291.i, %.1340.i
  br label %B286.i
B286.i:
  %value.3.2.i = phi double [ %.1342.i, %B226.i ], [ %value.2.1291.i, %B194.if.i ]
  br i1 %exitcond.not.i1642, label %B288.i, label %B194.if.i
B288.i:
  %.928.i = add nuw i64 %.859.0.i, 1
  %.1361.i = fcmp ogt double %value.3.2.i, 0.000000e+00
  br i1 %.1361.i, label %b93, label %B140.i
B194.if.i:
  %value.2.1291.i = phi double [ %.1010.i, %B142.i ], [ %value.3.2.i, %B286.i ]
  %exitcond.not.i1642 = phi i1 [ false, %B142.i ], [ true, %B286.i ]
  %.1037.0289.i = phi i64 [ 0, %B142.i ], [ 1, %B286.i ]
  %6 = getelementptr i64, ptr %4, i64 %.1037.0289.i
  %.1191.i = load i64, ptr %6, align 8, !noalias !179
  %.1194.i = icmp sgt i64 %.1191.i, -1
  br i1 %.1194.i, label %B226.i, label %B286.i
b93:
  %storemerge280.i = phi i64 [ %.859.0.i, %B288.i ], [ -1, %B140.i ]
  %.1925 = getelementptr i8, ptr %.62.fca.9.4.load, i64 24
  store i64 %storemerge280.i, ptr %.1925, align 8
  br label %B342
B342:
  %.2089 = phi i64 [ %.2089.pre, %B206.B342_crit_edge ], [ %storemerge280.i, %b93 ]
  store i64 %.2089, ptr %retptr, align 8
  ret void
}
define internal fastcc void @v71(ptr noalias nonnull writeonly %retptr, ptr readonly %arg.f.4, i64 %arg.i, ptr readonly %arg.segment.2.4, i64 %arg.segment.2.5.1, double %arg.t) unnamed_addr {
entry:
  %.39 = alloca { [5 x i64], { { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, double, double, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, i8 }, { { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] } }, [13 x { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }], { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, align 8
  %.fca.3.0.0.gep = getelementptr inbounds i8, ptr %.39, i64 528
  %.fca.5.0.2.gep = getelementptr inbounds i8, ptr %.39, i64 872
  %.fca.5.0.4.gep = getelementptr inbounds i8, ptr %.39, i64 888
  %.fca.5.2.2.gep = getelementptr inbounds i8, ptr %.39, i64 984
  %.fca.5.2.4.gep = getelementptr inbounds i8, ptr %.39, i64 1000
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(521) %.39, i8 0, i64 521, i1 false)
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(1280) %.fca.3.0.0.gep, i8 0, i64 1280, i1 false)
  call fastcc void @v72(ptr %.39, ptr %arg.f.4, i64 %arg.i)
  %.55.fca.5.0.2.load = load i64, ptr %.fca.5.0.2.gep, align 8
  %.55.fca.5.0.4.load = load ptr, ptr %.fca.5.0.4.gep, align 8
  %.55.fca.5.2.2.load = load i64, ptr %.fca.5.2.2.gep, align 8
  %.55.fca.5.2.4.load = load ptr, ptr %.fca.5.2.4.gep, align 8
  %.148211.not.i = icmp slt i64 %.55.fca.5.0.2.load, 1
  br i1 %.148211.not.i, label %b94, label %B58.if.i
B164.i:
  %.44.i.i = getelementptr i8, ptr %1, i64 24
  %.45.i.i = load double, ptr %.44.i.i, align 8, !noalias !180
  %.73.i.i = getelementptr i8, ptr %1, i64 32
  %.74.i.i = load double, ptr %.73.i.i, align 8, !noalias !180
  %.75.i.i = fmul double %.74.i.i, 5.000000e-01
  %.76.i.i = fmul double %.245.i, %.75.i.i
  %.77.i.i = fadd double %.45.i.i, %.76.i.i
  %.78.i.i = fmul double %.245.i, %.77.i.i
  %.87.le.i.i = tail call double @llvm.floor.f64(double %.78.i.i)
  %.92.i.i = fsub double %.78.i.i, %.87.le.i.i
  %.93.i.i = fmul double %.92.i.i, 0x401921FB54442D18
  %.121.i.i = getelementptr i8, ptr %1, i64 40
  %.122.i.i = load double, ptr %.121.i.i, align 8, !noalias !180
  %.126.i.i = fadd double %.122.i.i, %.93.i.i
  %.593.le.i = tail call double @llvm.sin.f64(double %.126.i.i)
  %.598.i = fmul double %.423.i, %.593.le.i
  %.600.i = fadd double %.361.i, %.598.i
  br label %B272.i
B272.i:
  %value.2.1.i = phi double [ %.600.i, %B164.i ], [ %.361.i, %B58.if.i ]
  %0 = getelementptr double, ptr %.55.fca.5.0.4.load, i64 %.90.0213.i
  store double %value.2.1.i, ptr %0, align 8, !noalias !185
  %exitcond.not.i = icmp eq i64 %.55.fca.5.0.2.load, %.161.i
  br i1 %exitcond.not.i, label %b94, label %B58.if.i
B58.if.i:
  %.90.0213.i = phi i64 [ %.161.i, %B272.i ], [ 0, %entry ]
  %.161.i = add nuw nsw i64 %.90.0213.i, 1
  %.238.i = mul i64 %.90.0213.i, %arg.segment.2.5.1
  %1 = getelementptr double, ptr %arg.segment.2.4, i64 %.238.i
  %.242.i = getelementptr i8, ptr %1, i64 48
  %.243.i = load double, ptr %.242.i, align 8, !noalias !185
  %.245.i = fsub double %arg.t, %.243.i
  %.303.i = load double, ptr %1, align 8, !noalias !185
  %.357.i = getelementptr i8, ptr %1, i64 8
  %.358.i = load double, ptr %.357.i, align 8, !noalias !185
  %.360.i = fmul double %.245.i, %.358.i
  %.361.i = fadd double %.303.i, %.360.i
  %.422.i = getelementptr i8, ptr %1, i64 16
  %.423.i = load double, ptr %.422.i, align 8, !noalias !185
  %.424.i = fcmp une double %.423.i, 0.000000e+00
  br i1 %.424.i, label %B164.i, label %B272.i
b94:
  %.148231.not.i = icmp slt i64 %.55.fca.5.2.2.load, 1
  br i1 %.148231.not.i, label %b95, label %B58.if.i231
B110.i:
  %.361.i237 = getelementptr i8, ptr %3, i64 48
  %.362.i = load double, ptr %.361.i237, align 8, !noalias !186
  %.364.i = fsub double %arg.t, %.362.i
  %.419.i = getelementptr i8, ptr %3, i64 24
  %.420.i = load double, ptr %.419.i, align 8, !noalias !186
  %.474.i = getelementptr i8, ptr %3, i64 32
  %.475.i = load double, ptr %.474.i, align 8, !noalias !186
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
  %.122.i.i246 = load double, ptr %.121.i.i245, align 8, !noalias !189
  %.126.i.i247 = fadd double %.122.i.i246, %.93.i.i244
  %.644.le.i = tail call double @llvm.cos.f64(double %.126.i.i247)
  %.649.i = fmul double %.534.i, %.644.le.i
  %.651.i = fadd double %.243.i235, %.649.i
  br label %B326.i
B326.i:
  %slope.2.1.i = phi double [ %.651.i, %B110.i ], [ %.243.i235, %B58.if.i231 ]
  %2 = getelementptr double, ptr %.55.fca.5.2.4.load, i64 %.90.0233.i
  store double %slope.2.1.i, ptr %2, align 8, !noalias !186
  %exitcond.not.i236 = icmp eq i64 %.55.fca.5.2.2.load, %.161.i232
  br i1 %exitcond.not.i236, label %b95, label %B58.if.i231
B58.if.i231:
  %.90.0233.i = phi i64 [ %.161.i232, %B326.i ], [ 0, %b94 ]
  %.161.i232 = add nuw nsw i64 %.90.0233.i, 1
  %.238.i233 = mul i64 %.90.0233.i, %arg.segment.2.5.1
  %3 = getelementptr double, ptr %arg.segment.2.4, i64 %.238.i233
  %.242.i234 = getelementptr i8, ptr %3, i64 8
  %.243.i235 = load double, ptr %.242.i234, align 8, !noalias !186
  %.304.i = getelementptr i8, ptr %3, i64 16
  %.305.i = load double, ptr %.304.i, align 8, !noalias !186
  %.306.i = fcmp une double %.305.i, 0.000000e+00
  br i1 %.306.i, label %B110.i, label %B326.i
b95:
  %.372.i.i = load i64, ptr %arg.f.4, align 8, !noalias !192
  br i1 %.148211.not.i, label %b90, label %B76.if.lr.ph.i
B76.if.lr.ph.i:
  %.44.i.i248 = getelementptr i8, ptr %arg.f.4, i64 432
  %.45.i.i249 = load i64, ptr %.44.i.i248, align 8, !noalias !192
  %.46.i.i = inttoptr i64 %.45.i.i249 to ptr
  %invariant.gep.i = getelementptr double, ptr %.46.i.i, i64 %arg.i
  %.271.i = icmp slt i64 %arg.i, 0
  %.272.i = select i1 %.271.i, i64 %.372.i.i, i64 0
  %invariant.gep120.i = getelementptr double, ptr %invariant.gep.i, i64 %.272.i
  br label %B76.if.i
B76.if.i:
  %.119.0118.i = phi i64 [ 0, %B76.if.lr.ph.i ], [ %.188.i, %B76.if.i ]
  %.188.i = add nuw nsw i64 %.119.0118.i, 1
  %4 = getelementptr double, ptr %.55.fca.5.0.4.load, i64 %.119.0118.i
  %.242.i250 = load double, ptr %4, align 8, !noalias !197
  %.290.i = mul i64 %.119.0118.i, %.372.i.i
  %gep121.i = getelementptr double, ptr %invariant.gep120.i, i64 %.290.i
  store double %.242.i250, ptr %gep121.i, align 8, !noalias !197
  %exitcond.not.i251 = icmp eq i64 %.188.i, %.55.fca.5.0.2.load
  br i1 %exitcond.not.i251, label %b91, label %B76.if.i
b91:
  %.372.i.i252.pre = load i64, ptr %arg.f.4, align 8, !noalias !198
  br label %b90
b90:
  %.372.i.i252 = phi i64 [ %.372.i.i252.pre, %b91 ], [ %.372.i.i, %b95 ]
  br i1 %.148231.not.i, label %b96, label %B76.if.lr.ph.i254
B76.if.lr.ph.i254:
  %.44.i.i255 = getelementptr i8, ptr %arg.f.4, i64 448
  %.45.i.i256 = load i64, ptr %.44.i.i255, align 8, !noalias !198
  %.46.i.i257 = inttoptr i64 %.45.i.i256 to ptr
  %invariant.gep.i258 = getelementptr double, ptr %.46.i.i257, i64 %arg.i
  %.271.i259 = icmp slt i64 %arg.i, 0
  %.272.i260 = select i1 %.271.i259, i64 %.372.i.i252, i64 0
  %invariant.gep120.i261 = getelementptr double, ptr %invariant.gep.i258, i64 %.272.i260
  br label %B76.if.i262
B76.if.i262:
  %.119.0118.i263 = phi i64 [ 0, %B76.if.lr.ph.i254 ], [ %.188.i264, %B76.if.i262 ]
  %.188.i264 = add nuw nsw i64 %.119.0118.i263, 1
  %5 = getelementptr double, ptr %.55.fca.5.2.4.load, i64 %.119.0118.i263
  %.242.i265 = load double, ptr %5, align 8, !noalias !203
  %.290.i266 = mul i64 %.119.0118.i263, %.372.i.i252
  %gep121.i267 = getelementptr double, ptr %invariant.gep120.i261, i64 %.290.i266
  store double %.242.i265, ptr %gep121.i267, align 8, !noalias !203
  %exitcond.not.i268 = icmp eq i64 %.188.i264, %.55.fca.5.2.2.load
  br i1 %exitcond.not.i268, label %b96, label %B76.if.i262
b96:
  store ptr null, ptr %retptr, align 8
  ret void
}
declare double @llvm.cos.f64(double)
define internal fastcc void @v73(ptr noalias nonnull writeonly %retptr, ptr readonly %arg.f.4, i64 %arg.i, i64 %arg.run.0.4, ptr %arg.run.1.0.4, i64 %arg.run.1.1.2, ptr %arg.run.1.1.4, ptr readonly %arg.run.1.2.4, i64 %arg.run.1.3.2, ptr %arg.run.1.3.4, ptr %arg.run.1.4.4, i64 %arg.run.5.0.2, ptr %arg.run.5.0.4, ptr %arg.run.5.3.4, ptr readonly %arg.segment.2.4, i64 %arg.segment.2.5.1, double %arg.t, ptr %arg.x.4) unnamed_addr {
entry:
  %.494 = alloca i8, align 1
  store i8 0, ptr %.494, align 1
  call fastcc void @v74(ptr %.494, i64 %arg.run.0.4, ptr %arg.run.1.0.4, i64 %arg.run.1.1.2, ptr %arg.run.1.1.4, ptr %arg.run.1.2.4, i64 %arg.run.1.3.2, ptr %arg.run.1.3.4, ptr %arg.run.1.4.4, i64 %arg.run.5.0.2, ptr %arg.run.5.0.4, ptr %arg.run.5.3.4, ptr %arg.segment.2.4, i64 %arg.segment.2.5.1, double %arg.t, ptr %arg.x.4)
  %.601 = load i8, ptr %.494, align 1
  %.372.i = load i64, ptr %arg.f.4, align 8, !noalias !204
  %.1306 = getelementptr i8, ptr %arg.f.4, i64 136
  %.1307 = load i64, ptr %.1306, align 8
  %.1387627.not = icmp slt i64 %.1307, 1
  br i1 %.1387627.not, label %B254, label %B164.if.lr.ph
B164.if.lr.ph:
  %.44.i = getelementptr i8, ptr %arg.f.4, i64 456
  %.45.i = load i64, ptr %.44.i, align 8, !noalias !204
  %.46.i = inttoptr i64 %.45.i to ptr
  %invariant.gep = getelementptr double, ptr %.46.i, i64 %arg.i
  %.1818 = getelementptr i8, ptr %arg.f.4, i64 128
  %.1849 = icmp slt i64 %arg.i, 0
  %.1850 = select i1 %.1849, i64 %.372.i, i64 0
  %invariant.gep630 = getelementptr double, ptr %invariant.gep, i64 %.1850
  br label %B164.if
B254:
  %.604 = icmp ne i8 %.601, 0
  %.2016 = zext i1 %.604 to i8
  store i8 %.2016, ptr %retptr, align 1
  ret void
B164.if:
  %.1331.0628 = phi i64 [ 0, %B164.if.lr.ph ], [ %.1400, %B164.if ]
  %.1400 = add nuw nsw i64 %.1331.0628, 1
  %0 = getelementptr double, ptr %arg.run.1.1.4, i64 %.1331.0628
  %.1489 = load double, ptr %0, align 8
  %.1819 = load i64, ptr %.1818, align 8
  %.1820 = add nsw i64 %.1819, %.1331.0628
  %.1820.lobit = lshr i64 %.1820, 63
  %.1848 = add i64 %.1820.lobit, %.1820
  %.1868 = mul i64 %.1848, %.372.i
  %gep631 = getelementptr double, ptr %invariant.gep630, i64 %.1868
  store double %.1489, ptr %gep631, align 8
  %exitcond.not = icmp eq i64 %.1400, %.1307
  br i1 %exitcond.not, label %B254, label %B164.if
}
define internal fastcc void @v74(ptr noalias nonnull writeonly %retptr, i64 %arg.run.0.4, ptr %arg.run.1.0.4, i64 %arg.run.1.1.2, ptr %arg.run.1.1.4, ptr readonly %arg.run.1.2.4, i64 %arg.run.1.3.2, ptr %arg.run.1.3.4, ptr %arg.run.1.4.4, i64 %arg.run.5.0.2, ptr %arg.run.5.0.4, ptr %arg.run.5.3.4, ptr readonly %arg.segment.2.4, i64 %arg.segment.2.5.1, double %arg.t, ptr %arg.x.4) unnamed_addr {
entry:
  %.5.i = fmul double %arg.t, 0x3D06849B86A12B9B
  %.6.i = fadd double %.5.i, 1.000000e-15
  %.765 = fadd double %arg.t, %.6.i
  %.164126.not.i = icmp sgt i64 %arg.run.1.3.2, 0
  br i1 %.164126.not.i, label %B78.if.i, label %b97
B78.if.i:
  %first.2.0129.i = phi double [ %.13.i.i, %B78.if.i ], [ 0x7FF0000000000000, %entry ]
  %.106.0128.i = phi i64 [ %.177.i, %B78.if.i ], [ 0, %entry ]
  %.177.i = add nuw nsw i64 %.106.0128.i, 1
  %0 = getelementptr double, ptr %arg.run.1.1.4, i64 %.106.0128.i
  %.235.i = load double, ptr %0, align 8, !noalias !207
  %.12.i.i = fcmp olt double %.235.i, %first.2.0129.i
  %.13.i.i = select i1 %.12.i.i, double %.235.i, double %first.2.0129.i
  %exitcond.not.i = icmp eq i64 %arg.run.1.3.2, %.177.i
  br i1 %exitcond.not.i, label %b97, label %B78.if.i
b97:
  %first.2.0.lcssa.i = phi double [ 0x7FF0000000000000, %entry ], [ %.13.i.i, %B78.if.i ]
  %.806 = fcmp ugt double %first.2.0.lcssa.i, %.765
  br i1 %.806, label %B626, label %B112.preheader
B112.preheader:
  %.148211.not.i = icmp slt i64 %arg.run.5.0.2, 1
  %.1203 = inttoptr i64 %arg.run.0.4 to ptr
  %.13131567.not = icmp slt i64 %arg.run.1.1.2, 1
  br label %B112
B112:
  %changed.4.0 = phi i1 [ %changed.3.1.lcssa, %b98 ], [ false, %B112.preheader ]
  br i1 %.164126.not.i, label %B162.if, label %B226
B226:
  store double %arg.t, ptr %arg.run.5.3.4, align 8
  br i1 %.148211.not.i, label %b94, label %B58.if.i
B164.i:
  %.44.i.i = getelementptr i8, ptr %2, i64 24
  %.45.i.i = load double, ptr %.44.i.i, align 8, !noalias !210
  %.73.i.i = getelementptr i8, ptr %2, i64 32
  %.74.i.i = load double, ptr %.73.i.i, align 8, !noalias !210
  %.75.i.i = fmul double %.74.i.i, 5.000000e-01
  %.76.i.i = fmul double %.245.i, %.75.i.i
  %.77.i.i = fadd double %.45.i.i, %.76.i.i
  %.78.i.i = fmul double %.245.i, %.77.i.i
  %.87.le.i.i = tail call double @llvm.floor.f64(double %.78.i.i)
  %.92.i.i = fsub double %.78.i.i, %.87.le.i.i
  %.93.i.i = fmul double %.92.i.i, 0x401921FB54442D18
  %.121.i.i = getelementptr i8, ptr %2, i64 40
  %.122.i.i = load double, ptr %.121.i.i, align 8, !noalias !210
  %.126.i.i = fadd double %.122.i.i, %.93.i.i
  %.593.le.i = tail call double @llvm.sin.f64(double %.126.i.i)
  %.598.i = fmul double %.423.i, %.593.le.i
  %.600.i = fadd double %.361.i, %.598.i
  br label %B272.i
B272.i:
  %value.2.1.i = phi double [ %.600.i, %B164.i ], [ %.361.i, %B58.if.i ]
  %1 = getelementptr double, ptr %arg.run.5.0.4, i64 %.90.0213.i
  store double %value.2.1.i, ptr %1, align 8, !noalias !215
  %exitcond.not.i1550 = icmp eq i64 %arg.run.5.0.2, %.161.i
  br i1 %exitcond.not.i1550, label %b94, label %B58.if.i
B58.if.i:
  %.90.0213.i = phi i64 [ %.161.i, %B272.i ], [ 0, %B226 ]
  %.161.i = add nuw nsw i64 %.90.0213.i, 1
  %.238.i = mul i64 %.90.0213.i, %arg.segment.2.5.1
  %2 = getelementptr double, ptr %arg.segment.2.4, i64 %.238.i
  %.242.i = getelementptr i8, ptr %2, i64 48
  %.243.i = load double, ptr %.242.i, align 8, !noalias !215
  %.245.i = fsub double %arg.t, %.243.i
  %.303.i = load double, ptr %2, align 8, !noalias !215
  %.357.i = getelementptr i8, ptr %2, i64 8
  %.358.i = load double, ptr %.357.i, align 8, !noalias !215
  %.360.i = fmul double %.245.i, %.358.i
  %.361.i = fadd double %.303.i, %.360.i
  %.422.i = getelementptr i8, ptr %2, i64 16
  %.423.i = load double, ptr %.422.i, align 8, !noalias !215
  %.424.i = fcmp une double %.423.i, 0.000000e+00
  br i1 %.424.i, label %B164.i, label %B272.i
b94:
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
  %changed.3.1.lcssa = phi i1 [ %changed.4.0, %b94 ], [ %changed.5.2, %B542 ]
  br i1 %.164126.not.i, label %B78.if.i1552, label %b98
B78.if.i1552:
  %first.2.0129.i1553 = phi double [ %.13.i.i1558, %B78.if.i1552 ], [ 0x7FF0000000000000, %B586 ]
  %.106.0128.i1554 = phi i64 [ %.177.i1555, %B78.if.i1552 ], [ 0, %B586 ]
  %.177.i1555 = add nuw nsw i64 %.106.0128.i1554, 1
  %5 = getelementptr double, ptr %arg.run.1.1.4, i64 %.106.0128.i1554
  %.235.i1556 = load double, ptr %5, align 8, !noalias !216
  %.12.i.i1557 = fcmp olt double %.235.i1556, %first.2.0129.i1553
  %.13.i.i1558 = select i1 %.12.i.i1557, double %.235.i1556, double %first.2.0129.i1553
  %exitcond.not.i1559 = icmp eq i64 %arg.run.1.3.2, %.177.i1555
  br i1 %exitcond.not.i1559, label %b98, label %B78.if.i1552
b98:
  %first.2.0.lcssa.i1560 = phi double [ 0x7FF0000000000000, %B586 ], [ %.13.i.i1558, %B78.if.i1552 ]
  %.1617 = fcmp ugt double %first.2.0.lcssa.i1560, %.765
  br i1 %.1617, label %B626.loopexit, label %B112
B626.loopexit:
  %6 = zext i1 %changed.3.1.lcssa to i8
  br label %B626
B626:
  %changed.2.1 = phi i8 [ 0, %b97 ], [ %6, %B626.loopexit ]
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
  %changed.3.11570 = phi i1 [ %changed.5.2, %B542 ], [ %changed.4.0, %b94 ]
  %.1257.01568 = phi i64 [ %.1326, %B542 ], [ 0, %b94 ]
  %.1326 = add nuw nsw i64 %.1257.01568, 1
  %9 = getelementptr i8, ptr %arg.run.1.2.4, i64 %.1257.01568
  %.1392 = load i8, ptr %9, align 1
  %.1396.not = icmp eq i8 %.1392, 0
  %.phi.trans.insert = getelementptr double, ptr %arg.run.1.4.4, i64 %.1257.01568
  %.1523.pre = load double, ptr %.phi.trans.insert, align 8
  br i1 %.1396.not, label %B542, label %B482
}
define internal fastcc void @v75(ptr noalias nonnull writeonly %retptr, ptr %arg.f.4, i64 %arg.i, i64 %arg.status) unnamed_addr {
entry:
  %.536 = alloca i64, align 8
  %.1396 = alloca ptr, align 8
  %.3615 = alloca ptr, align 8
  %.340.i = getelementptr i8, ptr %arg.f.4, i64 568
  %.341.i = load i64, ptr %.340.i, align 8, !noalias !219
  %.342.i = inttoptr i64 %.341.i to ptr
  %.668.i = load i64, ptr %arg.f.4, align 8, !noalias !219
  %.116 = icmp slt i64 %arg.i, 0
  %.117 = select i1 %.116, i64 %.668.i, i64 0
  %.118 = add i64 %.117, %arg.i
  %.139 = getelementptr i64, ptr %.342.i, i64 %.118
  %0 = getelementptr i64, ptr %.342.i, i64 %.668.i
  %.199 = getelementptr i64, ptr %0, i64 %.118
  %.527 = getelementptr i8, ptr %arg.f.4, i64 184
  %.1752 = getelementptr i8, ptr %arg.f.4, i64 368
  %.2079 = getelementptr i8, ptr %arg.f.4, i64 376
  %.45.i506 = getelementptr i8, ptr %arg.f.4, i64 360
  %.44.i = getelementptr i8, ptr %arg.f.4, i64 416
  %.44.i494 = getelementptr i8, ptr %arg.f.4, i64 408
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
  %.528 = load i64, ptr %.527, align 8
  %.529 = icmp slt i64 %.201, %.528
  br i1 %.529, label %B172, label %B382
B172:
  store i64 0, ptr %.536, align 8
  call fastcc void @v67(ptr %.536, ptr nonnull %arg.f.4, i64 %arg.i)
  %.552 = load i64, ptr %.536, align 8
  %.566 = icmp eq i64 %.552, 0
  br i1 %.566, label %B226, label %B36.backedge
B226:
  %.45.i = load i64, ptr %.44.i, align 8, !noalias !222
  %.46.i = inttoptr i64 %.45.i to ptr
  %.372.i = load i64, ptr %arg.f.4, align 8, !noalias !222
  %.938 = select i1 %.116, i64 %.372.i, i64 0
  %1 = getelementptr double, ptr %.46.i, i64 %arg.i
  %.960 = getelementptr double, ptr %1, i64 %.938
  %.961 = load double, ptr %.960, align 8
  %.45.i495 = load i64, ptr %.44.i494, align 8, !noalias !225
  %.46.i496 = inttoptr i64 %.45.i495 to ptr
  %.idx = mul i64 %.372.i, 80
  %2 = getelementptr i8, ptr %.46.i496, i64 %.idx
  %3 = getelementptr double, ptr %2, i64 %arg.i
  %.1359 = getelementptr double, ptr %3, i64 %.938
  %.1360 = load double, ptr %.1359, align 8
  %.1366 = fcmp olt double %.961, %.1360
  br i1 %.1366, label %common.ret, label %B36.backedge
common.ret:
  store ptr null, ptr %retptr, align 8
  ret void
B382:
  call fastcc void @v68(ptr %.1396, ptr nonnull %arg.f.4, i64 %arg.i, i64 %status.3.1)
  br label %B416
B416:
  %.1753 = load i64, ptr %.1752, align 8
  %.2080 = load i64, ptr %.2079, align 8
  %.2081.not = icmp slt i64 %.1753, %.2080
  br i1 %.2081.not, label %B492, label %B566
B492:
  %.46.i507 = load i64, ptr %.45.i506, align 8, !noalias !228
  %.50.i = inttoptr i64 %.46.i507 to ptr
  %.2446 = getelementptr i8, ptr %.50.i, i64 8
  %.2447 = load double, ptr %.2446, align 8
  %.2451 = fcmp une double %.2447, 0.000000e+00
  br i1 %.2451, label %B566, label %B710
B566:
  store i64 -1, ptr %.139, align 8
  %.45.i509 = load i64, ptr %.44.i, align 8, !noalias !231
  %.46.i510 = inttoptr i64 %.45.i509 to ptr
  %.372.i511 = load i64, ptr %arg.f.4, align 8, !noalias !231
  %.2891 = select i1 %.116, i64 %.372.i511, i64 0
  %4 = getelementptr double, ptr %.46.i510, i64 %.372.i511
  %5 = getelementptr double, ptr %4, i64 %arg.i
  %.2913 = getelementptr double, ptr %5, i64 %.2891
  store double 0.000000e+00, ptr %.2913, align 8
  %.3245 = getelementptr i8, ptr %arg.f.4, i64 384
  %.3246 = load i64, ptr %.3245, align 8
  %.3247 = add nsw i64 %.3246, -1
  store i64 %.3247, ptr %.3245, align 8
  br label %common.ret
B710:
  call fastcc void @v69(ptr %.3615, ptr nonnull %arg.f.4, i64 %arg.i, i64 %.1753)
  %.3967 = load i64, ptr %.1752, align 8
  %.3968 = add nsw i64 %.3967, 1
  store i64 %.3968, ptr %.1752, align 8
  br label %B36.backedge
B36.backedge:
  %status.3.1.be = phi i64 [ 0, %B710 ], [ %.552, %B226 ], [ %.552, %B172 ]
  br label %B36
}
define internal fastcc void @v76(ptr noalias nonnull writeonly %retptr, ptr readonly %arg.f.4, i64 %arg.i, double %arg.t, double %arg.h, double %arg.end) unnamed_addr {
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
  %.2525 = alloca { i64, double }, align 8
  %.fca.1.gep324 = getelementptr inbounds i8, ptr %.2525, i64 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %.2525, i8 0, i64 16, i1 false)
  %.2814 = alloca double, align 8
  store double 0.000000e+00, ptr %.2814, align 8
  %.2940 = alloca ptr, align 8
  store ptr null, ptr %.2940, align 8
  %.4143 = alloca i8, align 1
  store i8 0, ptr %.4143, align 1
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(521) %.33, i8 0, i64 521, i1 false)
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(1280) %.fca.3.0.0.gep, i8 0, i64 1280, i1 false)
  call fastcc void @v72(ptr %.33, ptr %arg.f.4, i64 %arg.i)
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
  %.340.i.i = getelementptr i8, ptr %arg.f.4, i64 568
  %.341.i.i = load i64, ptr %.340.i.i, align 8, !noalias !234
  %.342.i.i = inttoptr i64 %.341.i.i to ptr
  %.668.i.i = load i64, ptr %arg.f.4, align 8, !noalias !234
  %.95.i = icmp slt i64 %arg.i, 0
  %.96.i = select i1 %.95.i, i64 %.668.i.i, i64 0
  %0 = getelementptr i64, ptr %.342.i.i, i64 %.668.i.i
  %1 = getelementptr i64, ptr %0, i64 %arg.i
  %.118.i = getelementptr i64, ptr %1, i64 %.96.i
  %.119.i = load i64, ptr %.118.i, align 8, !noalias !239
  %.450.i = getelementptr i8, ptr %arg.f.4, i64 184
  %.451.i = load i64, ptr %.450.i, align 8, !noalias !239
  %.777.i = getelementptr i8, ptr %arg.f.4, i64 112
  %.778.i = load i64, ptr %.777.i, align 8, !noalias !239
  %.1132.i = add nsw i64 %.119.i, 1
  %.1134.i = icmp slt i64 %.1132.i, %.451.i
  br i1 %.1134.i, label %B204.i, label %B226.i
B204.i:
  %.45.i.i = getelementptr i8, ptr %arg.f.4, i64 264
  %.46.i.i = load i64, ptr %.45.i.i, align 8, !noalias !240
  %.50.i.i = inttoptr i64 %.46.i.i to ptr
  %.1151.i = icmp slt i64 %.119.i, -1
  %.1152.i = select i1 %.1151.i, i64 %.451.i, i64 0
  %2 = getelementptr double, ptr %.50.i.i, i64 %.1132.i
  %.1166.i = getelementptr double, ptr %2, i64 %.1152.i
  br label %B322.i
B226.i:
  %.1795.i = getelementptr i8, ptr %arg.f.4, i64 200
  %.1796.i = load i64, ptr %.1795.i, align 8, !noalias !239
  %.45.i376.i = getelementptr i8, ptr %arg.f.4, i64 304
  %.46.i377.i = load i64, ptr %.45.i376.i, align 8, !noalias !243
  %.50.i378.i = inttoptr i64 %.46.i377.i to ptr
  %3 = getelementptr double, ptr %.50.i378.i, i64 %.1796.i
  %.1862.i = getelementptr i8, ptr %3, i64 -8
  br label %B322.i
B322.i:
  %"$phi322.0.2.0.in.i" = phi ptr [ %.1166.i, %B204.i ], [ %.1862.i, %B226.i ]
  %"$phi322.0.2.0.i" = load double, ptr %"$phi322.0.2.0.in.i", align 8, !noalias !239
  %.45.i384.i = getelementptr i8, ptr %arg.f.4, i64 272
  %.46.i385.i = load i64, ptr %.45.i384.i, align 8, !noalias !246
  %.50.i386.i = inttoptr i64 %.46.i385.i to ptr
  %.2228.i = icmp slt i64 %.119.i, 0
  %.2229.i = select i1 %.2228.i, i64 %.451.i, i64 0
  %4 = getelementptr i64, ptr %.50.i386.i, i64 %.119.i
  %.2243.i = getelementptr i64, ptr %4, i64 %.2229.i
  %.2244.i = load i64, ptr %.2243.i, align 8, !noalias !239
  %.2573.i = getelementptr i8, ptr %arg.f.4, i64 224
  %.2574.i = load i64, ptr %.2573.i, align 8, !noalias !239
  %.2575.i = icmp sgt i64 %.2574.i, 0
  br i1 %.2575.i, label %B432.i, label %b83
B432.i:
  %.2905.i = getelementptr i8, ptr %arg.f.4, i64 192
  %.2906.i = load i64, ptr %.2905.i, align 8, !noalias !239
  %.2908.i = mul nsw i64 %.2906.i, %arg.i
  br label %b83
b83:
  %"$phi476.1.2.0.i" = phi i64 [ %.2908.i, %B432.i ], [ 0, %B322.i ]
  %.2922.i = add nsw i64 %"$phi476.1.2.0.i", %.2244.i
  %.3290.i = getelementptr i8, ptr %arg.f.4, i64 280
  %.3291.i = load i64, ptr %.3290.i, align 8, !noalias !239
  %.3298.i = mul nsw i64 %.778.i, 56
  %.3299.i = mul nsw i64 %.3298.i, %.2922.i
  %.3300.i = add nsw i64 %.3291.i, %.3299.i
  %.3301.i = inttoptr i64 %.3300.i to ptr
  %.175117.not.i = icmp sgt i64 %.49.fca.6.2.load, 0
  br i1 %.175117.not.i, label %B76.if.lr.ph.i, label %b86
B76.if.lr.ph.i:
  %.44.i.i = getelementptr i8, ptr %arg.f.4, i64 424
  %.45.i.i4192 = load i64, ptr %.44.i.i, align 8, !noalias !249
  %.46.i.i4193 = inttoptr i64 %.45.i.i4192 to ptr
  %invariant.gep.i = getelementptr double, ptr %.46.i.i4193, i64 %arg.i
  %invariant.gep120.i = getelementptr double, ptr %invariant.gep.i, i64 %.96.i
  br label %B76.if.i
B76.if.i:
  %.119.0118.i = phi i64 [ 0, %B76.if.lr.ph.i ], [ %.188.i, %B76.if.i ]
  %.188.i = add nuw nsw i64 %.119.0118.i, 1
  %.260.i = mul i64 %.119.0118.i, %.668.i.i
  %gep121.i = getelementptr double, ptr %invariant.gep120.i, i64 %.260.i
  %.265.i = load double, ptr %gep121.i, align 8, !noalias !254
  %5 = getelementptr double, ptr %.49.fca.6.4.load, i64 %.119.0118.i
  store double %.265.i, ptr %5, align 8, !noalias !254
  %exitcond.not.i = icmp eq i64 %.188.i, %.49.fca.6.2.load
  br i1 %exitcond.not.i, label %b99, label %B76.if.i
b99:
  %.372.i.i4194.pre = load i64, ptr %arg.f.4, align 8, !noalias !255
  br label %b86
b86:
  %.372.i.i4194 = phi i64 [ %.372.i.i4194.pre, %b99 ], [ %.668.i.i, %b83 ]
  %.175117.not.i4195 = icmp slt i64 %.49.fca.5.10.2.load, 1
  br i1 %.175117.not.i4195, label %b100, label %B76.if.lr.ph.i4196
B76.if.lr.ph.i4196:
  %.44.i.i4197 = getelementptr i8, ptr %arg.f.4, i64 512
  %.45.i.i4198 = load i64, ptr %.44.i.i4197, align 8, !noalias !255
  %.46.i.i4199 = inttoptr i64 %.45.i.i4198 to ptr
  %invariant.gep.i4200 = getelementptr double, ptr %.46.i.i4199, i64 %arg.i
  %.242.i4202 = select i1 %.95.i, i64 %.372.i.i4194, i64 0
  %invariant.gep120.i4203 = getelementptr double, ptr %invariant.gep.i4200, i64 %.242.i4202
  br label %B76.if.i4204
B76.if.i4204:
  %.119.0118.i4205 = phi i64 [ 0, %B76.if.lr.ph.i4196 ], [ %.188.i4206, %B76.if.i4204 ]
  %.188.i4206 = add nuw nsw i64 %.119.0118.i4205, 1
  %.260.i4207 = mul i64 %.119.0118.i4205, %.372.i.i4194
  %gep121.i4208 = getelementptr double, ptr %invariant.gep120.i4203, i64 %.260.i4207
  %.265.i4209 = load double, ptr %gep121.i4208, align 8, !noalias !260
  %6 = getelementptr double, ptr %.49.fca.5.10.4.load, i64 %.119.0118.i4205
  store double %.265.i4209, ptr %6, align 8, !noalias !260
  %exitcond.not.i4210 = icmp eq i64 %.188.i4206, %.49.fca.5.10.2.load
  br i1 %exitcond.not.i4210, label %b101, label %B76.if.i4204
b101:
  %.372.i.i4212.pre = load i64, ptr %arg.f.4, align 8, !noalias !261
  br label %b100
b100:
  %.372.i.i4212 = phi i64 [ %.372.i.i4212.pre, %b101 ], [ %.372.i.i4194, %b86 ]
  %.175117.not.i4213 = icmp slt i64 %.49.fca.5.11.2.load, 1
  br i1 %.175117.not.i4213, label %b102, label %B76.if.lr.ph.i4214
B76.if.lr.ph.i4214:
  %.44.i.i4215 = getelementptr i8, ptr %arg.f.4, i64 520
  %.45.i.i4216 = load i64, ptr %.44.i.i4215, align 8, !noalias !261
  %.46.i.i4217 = inttoptr i64 %.45.i.i4216 to ptr
  %invariant.gep.i4218 = getelementptr double, ptr %.46.i.i4217, i64 %arg.i
  %.242.i4220 = select i1 %.95.i, i64 %.372.i.i4212, i64 0
  %invariant.gep120.i4221 = getelementptr double, ptr %invariant.gep.i4218, i64 %.242.i4220
  br label %B76.if.i4222
B76.if.i4222:
  %.119.0118.i4223 = phi i64 [ 0, %B76.if.lr.ph.i4214 ], [ %.188.i4224, %B76.if.i4222 ]
  %.188.i4224 = add nuw nsw i64 %.119.0118.i4223, 1
  %.260.i4225 = mul i64 %.119.0118.i4223, %.372.i.i4212
  %gep121.i4226 = getelementptr double, ptr %invariant.gep120.i4221, i64 %.260.i4225
  %.265.i4227 = load double, ptr %gep121.i4226, align 8, !noalias !266
  %7 = getelementptr double, ptr %.49.fca.5.11.4.load, i64 %.119.0118.i4223
  store double %.265.i4227, ptr %7, align 8, !noalias !266
  %exitcond.not.i4228 = icmp eq i64 %.188.i4224, %.49.fca.5.11.2.load
  br i1 %exitcond.not.i4228, label %b102, label %B76.if.i4222
b102:
  %.2516 = getelementptr i8, ptr %arg.f.4, i64 208
  %.2517 = load i64, ptr %.2516, align 8
  %.2518 = icmp sgt i64 %.2517, 0
  br i1 %.2518, label %B402, label %B508
B402:
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %.2525, i8 0, i64 16, i1 false)
  call fastcc void @v77(ptr %.2525, i64 %.49.fca.0.3.load, ptr %.49.fca.1.0.4.load, ptr %.49.fca.3.2.4.load, ptr %.49.fca.4.0.4.load, i64 %.49.fca.4.0.5.1.load, ptr %.49.fca.4.1.4.load, i64 %.49.fca.4.1.5.0.load, i64 %.49.fca.4.1.5.1.load, i64 %.49.fca.5.0.2.load, ptr %.49.fca.5.0.4.load, ptr %.49.fca.5.3.4.load, ptr %.49.fca.5.11.4.load, i64 %.49.fca.5.11.5.0.load, i64 %.49.fca.5.12.2.load, ptr %.49.fca.5.12.4.load, i64 %.49.fca.6.2.load, ptr %.49.fca.6.4.load, ptr %.3301.i, i64 7, double %arg.t, double %arg.h, ptr %.49.fca.5.10.4.load)
  %.2632.fca.0.load = load i64, ptr %.2525, align 8
  %.2632.fca.1.load = load double, ptr %.fca.1.gep324, align 8
  %.2656 = fmul double %arg.h, %.2632.fca.1.load
  %.2662 = fadd double %arg.t, %.2656
  %.26494257 = icmp slt i64 %.2632.fca.0.load, 0
  %"$phi484.1.2.0" = select i1 %.26494257, double %arg.end, double %.2662
  %.2708 = getelementptr i8, ptr %.49.fca.9.4.load, i64 24
  store i64 %.2632.fca.0.load, ptr %.2708, align 8
  br label %B674
B508:
  %.2740 = icmp sgt i64 %.49.fca.1.3.2.load, 0
  br i1 %.2740, label %B78.if.i, label %B674
B78.if.i:
  %first.2.0129.i = phi double [ %.13.i.i, %B78.if.i ], [ 0x7FF0000000000000, %B508 ]
  %.106.0128.i = phi i64 [ %.177.i, %B78.if.i ], [ 0, %B508 ]
  %.177.i = add nuw nsw i64 %.106.0128.i, 1
  %8 = getelementptr double, ptr %.49.fca.1.1.4.load, i64 %.106.0128.i
  %.235.i = load double, ptr %8, align 8, !noalias !267
  %.12.i.i = fcmp olt double %.235.i, %first.2.0129.i
  %.13.i.i = select i1 %.12.i.i, double %.235.i, double %first.2.0129.i
  %exitcond.not.i4230 = icmp eq i64 %.49.fca.1.3.2.load, %.177.i
  br i1 %exitcond.not.i4230, label %b97, label %B78.if.i
b97:
  %.5.i = fmul double %arg.end, 0x3D06849B86A12B9B
  %.6.i = fadd double %.5.i, 1.000000e-15
  %.2808 = fsub double %arg.end, %.6.i
  %.2809 = fcmp olt double %.13.i.i, %.2808
  br i1 %.2809, label %B630, label %B674
B630:
  store double 0.000000e+00, ptr %.2814, align 8
  call fastcc void @v78(ptr %.2814, i64 %.49.fca.0.3.load, i64 %.49.fca.0.4.load, ptr %.49.fca.1.0.4.load, i64 %.49.fca.1.1.2.load, ptr nonnull %.49.fca.1.1.4.load, ptr %.49.fca.1.2.4.load, i64 %.49.fca.1.3.2.load, ptr %.49.fca.1.3.4.load, ptr %.49.fca.1.4.4.load, i64 %.49.fca.2.1.2.load, i64 %.49.fca.3.0.2.load, ptr %.49.fca.3.0.4.load, i64 %.49.fca.3.0.5.0.load, ptr %.49.fca.3.1.4.load, i64 %.49.fca.3.1.5.1.load, i64 %.49.fca.3.2.2.load, ptr %.49.fca.3.2.4.load, i64 %.49.fca.5.0.2.load, ptr %.49.fca.5.0.4.load, ptr %.49.fca.5.3.4.load, ptr %.49.fca.5.6.4.load, i64 %.49.fca.5.6.5.0.load, ptr %.49.fca.5.11.4.load, i64 %.49.fca.5.11.5.0.load, i64 %.49.fca.5.12.2.load, ptr %.49.fca.5.12.4.load, i64 %.49.fca.6.2.load, ptr %.49.fca.6.4.load, ptr %.49.fca.9.4.load, ptr %.3301.i, i64 7, double %arg.t, double %arg.h, double %arg.end, ptr %.49.fca.5.10.4.load)
  %.2921 = load double, ptr %.2814, align 8
  br label %B674
B674:
  %reached.3.0 = phi double [ %"$phi484.1.2.0", %B402 ], [ %.2921, %B630 ], [ %arg.end, %b97 ], [ %arg.end, %B508 ]
  call fastcc void @v79(ptr %.2940, i64 %.49.fca.0.3.load, ptr %.49.fca.1.0.4.load, i64 %.49.fca.2.1.2.load, i64 %.49.fca.3.0.2.load, ptr %.49.fca.3.0.4.load, i64 %.49.fca.3.0.5.0.load, ptr %.49.fca.3.1.4.load, i64 %.49.fca.3.1.5.1.load, i64 %.49.fca.3.2.2.load, ptr %.49.fca.3.2.4.load, i64 %.49.fca.5.0.2.load, ptr %.49.fca.5.0.4.load, ptr %.49.fca.5.3.4.load, ptr %.49.fca.5.6.4.load, i64 %.49.fca.5.6.5.0.load, ptr %.49.fca.5.11.4.load, i64 %.49.fca.5.11.5.0.load, i64 %.49.fca.6.2.load, ptr %.49.fca.6.4.load, ptr %.49.fca.9.4.load, ptr %.3301.i, i64 7, double %arg.t, double %arg.h, ptr %.49.fca.5.10.4.load, double %reached.3.0)
  %.3090 = getelementptr i8, ptr %.49.fca.9.4.load, i64 24
  %.3091 = load i64, ptr %.3090, align 8
  %.3092 = icmp sgt i64 %.3091, -1
  %.3096 = fcmp olt double %reached.3.0, %arg.end
  %or.cond = select i1 %.3092, i1 true, i1 %.3096
  br i1 %or.cond, label %B766, label %B930
B766:
  br i1 %.175117.not.i, label %B816.if, label %B864
B864:
  %.372.i.i4231 = load i64, ptr %arg.f.4, align 8, !noalias !270
  br i1 %.175117.not.i4195, label %B930, label %B76.if.lr.ph.i4233
B76.if.lr.ph.i4233:
  %.44.i.i4234 = getelementptr i8, ptr %arg.f.4, i64 512
  %.45.i.i4235 = load i64, ptr %.44.i.i4234, align 8, !noalias !270
  %.46.i.i4236 = inttoptr i64 %.45.i.i4235 to ptr
  %invariant.gep.i4237 = getelementptr double, ptr %.46.i.i4236, i64 %arg.i
  %.272.i = select i1 %.95.i, i64 %.372.i.i4231, i64 0
  %invariant.gep120.i4238 = getelementptr double, ptr %invariant.gep.i4237, i64 %.272.i
  br label %B76.if.i4239
B76.if.i4239:
  %.119.0118.i4240 = phi i64 [ 0, %B76.if.lr.ph.i4233 ], [ %.188.i4241, %B76.if.i4239 ]
  %.188.i4241 = add nuw nsw i64 %.119.0118.i4240, 1
  %9 = getelementptr double, ptr %.49.fca.5.10.4.load, i64 %.119.0118.i4240
  %.242.i4242 = load double, ptr %9, align 8, !noalias !275
  %.290.i = mul i64 %.119.0118.i4240, %.372.i.i4231
  %gep121.i4243 = getelementptr double, ptr %invariant.gep120.i4238, i64 %.290.i
  store double %.242.i4242, ptr %gep121.i4243, align 8, !noalias !275
  %exitcond.not.i4244 = icmp eq i64 %.188.i4241, %.49.fca.5.10.2.load
  br i1 %exitcond.not.i4244, label %B930, label %B76.if.i4239
B930:
  %.3659 = icmp eq i64 %.49.fca.1.3.2.load, 0
  br i1 %.3659, label %common.ret, label %B962
B962:
  %.3690 = load i64, ptr %.3090, align 8
  %.3696 = icmp sgt i64 %.3690, -1
  br i1 %.3696, label %common.ret, label %B1004
common.ret:
  %"$phi1382.1.2.0.pn" = phi i8 [ 0, %B930 ], [ 0, %B962 ], [ 1, %B1082 ], [ %12, %B1372 ]
  %.5566.pn = insertvalue { double, i8 } undef, double %reached.3.0, 0
  %storemerge4191 = insertvalue { double, i8 } %.5566.pn, i8 %"$phi1382.1.2.0.pn", 1
  store { double, i8 } %storemerge4191, ptr %retptr, align 8
  ret void
B1004:
  %.5.i4245 = fmul double %"$phi322.0.2.0.i", 0x3D06849B86A12B9B
  %.6.i4246 = fadd double %.5.i4245, 1.000000e-15
  %.3953 = fsub double %"$phi322.0.2.0.i", %.6.i4246
  %.3955 = fcmp olt double %reached.3.0, %.3953
  br i1 %.3955, label %B1082, label %B1184
B1082:
  %.341.i = load i64, ptr %.340.i.i, align 8, !noalias !276
  %.342.i = inttoptr i64 %.341.i to ptr
  %.668.i = load i64, ptr %arg.f.4, align 8, !noalias !276
  %.4049 = select i1 %.95.i, i64 %.668.i, i64 0
  %.idx = mul i64 %.668.i, 40
  %10 = getelementptr i8, ptr %.342.i, i64 %.idx
  %11 = getelementptr i64, ptr %10, i64 %arg.i
  %.4071 = getelementptr i64, ptr %11, i64 %.4049
  store i64 1, ptr %.4071, align 8
  store i8 0, ptr %.4143, align 1
  call fastcc void @v73(ptr %.4143, ptr nonnull %arg.f.4, i64 %arg.i, i64 %.49.fca.0.4.load, ptr %.49.fca.1.0.4.load, i64 %.49.fca.1.1.2.load, ptr %.49.fca.1.1.4.load, ptr %.49.fca.1.2.4.load, i64 %.49.fca.1.3.2.load, ptr %.49.fca.1.3.4.load, ptr %.49.fca.1.4.4.load, i64 %.49.fca.5.0.2.load, ptr %.49.fca.5.0.4.load, ptr %.49.fca.5.3.4.load, ptr %.3301.i, i64 7, double %reached.3.0, ptr %.49.fca.5.10.4.load)
  %.4252 = load i8, ptr %.4143, align 1
  %.4255.not = icmp eq i8 %.4252, 0
  br i1 %.4255.not, label %B1372, label %common.ret
B1184:
  %.372.i = load i64, ptr %arg.f.4, align 8, !noalias !279
  %.50334261.not = icmp slt i64 %.49.fca.1.1.2.load, 1
  br i1 %.50334261.not, label %B1372, label %B1286.if.lr.ph
B1286.if.lr.ph:
  %.44.i = getelementptr i8, ptr %arg.f.4, i64 456
  %.45.i = load i64, ptr %.44.i, align 8, !noalias !279
  %.46.i = inttoptr i64 %.45.i to ptr
  %invariant.gep = getelementptr double, ptr %.46.i, i64 %arg.i
  %.5435 = getelementptr i8, ptr %arg.f.4, i64 128
  %.5467 = select i1 %.95.i, i64 %.372.i, i64 0
  %invariant.gep4264 = getelementptr double, ptr %invariant.gep, i64 %.5467
  br label %B1286.if
B1372:
  %12 = zext i1 %.3096 to i8
  br label %common.ret
B816.if:
  %.3135.04259 = phi i64 [ %.3204, %B816.if ], [ 0, %B766 ]
  %.3204 = add nuw nsw i64 %.3135.04259, 1
  %13 = getelementptr double, ptr %.49.fca.5.12.4.load, i64 %.3135.04259
  %.3262 = load double, ptr %13, align 8
  %14 = getelementptr double, ptr %.49.fca.5.10.4.load, i64 %.3135.04259
  store double %.3262, ptr %14, align 8
  %exitcond.not = icmp eq i64 %.49.fca.6.2.load, %.3204
  br i1 %exitcond.not, label %B864, label %B816.if
B1286.if:
  %.4974.04262 = phi i64 [ 0, %B1286.if.lr.ph ], [ %.5046, %B1286.if ]
  %.5046 = add nuw nsw i64 %.4974.04262, 1
  %15 = getelementptr double, ptr %.49.fca.1.1.4.load, i64 %.4974.04262
  %.5106 = load double, ptr %15, align 8
  %.5436 = load i64, ptr %.5435, align 8
  %.5437 = add nsw i64 %.5436, %.4974.04262
  %.5437.lobit = lshr i64 %.5437, 63
  %.5465 = add i64 %.5437.lobit, %.5437
  %.5485 = mul i64 %.5465, %.372.i
  %gep4265 = getelementptr double, ptr %invariant.gep4264, i64 %.5485
  store double %.5106, ptr %gep4265, align 8
  %exitcond4266.not = icmp eq i64 %.5046, %.49.fca.1.1.2.load
  br i1 %exitcond4266.not, label %B1372, label %B1286.if
}
define internal fastcc void @v80(ptr noalias nonnull writeonly %retptr, ptr readonly %arg.f.4, i64 %arg.i, i64 %arg.run) unnamed_addr {
entry:
  %.730 = alloca { [5 x i64], { { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, double, double, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, i8 }, { { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] } }, [13 x { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }], { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, align 8
  %.fca.3.0.0.gep = getelementptr inbounds i8, ptr %.730, i64 528
  %.fca.5.0.2.gep = getelementptr inbounds i8, ptr %.730, i64 872
  %.fca.5.0.4.gep = getelementptr inbounds i8, ptr %.730, i64 888
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(521) %.730, i8 0, i64 521, i1 false)
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(1280) %.fca.3.0.0.gep, i8 0, i64 1280, i1 false)
  %.3588 = alloca ptr, align 8
  %.350 = load i64, ptr %arg.f.4, align 8
  %.676 = getelementptr i8, ptr %arg.f.4, i64 200
  %.677 = load i64, ptr %.676, align 8
  %.340.i.i = getelementptr i8, ptr %arg.f.4, i64 568
  %.341.i.i = load i64, ptr %.340.i.i, align 8, !noalias !282
  %.342.i.i = inttoptr i64 %.341.i.i to ptr
  %.95.i = icmp slt i64 %arg.i, 0
  %.96.i = select i1 %.95.i, i64 %.350, i64 0
  %0 = getelementptr i64, ptr %.342.i.i, i64 %.350
  %1 = getelementptr i64, ptr %0, i64 %arg.i
  %.118.i = getelementptr i64, ptr %1, i64 %.96.i
  %.119.i = load i64, ptr %.118.i, align 8, !noalias !287
  %.450.i = getelementptr i8, ptr %arg.f.4, i64 184
  %.451.i = load i64, ptr %.450.i, align 8, !noalias !287
  %.777.i = getelementptr i8, ptr %arg.f.4, i64 112
  %.778.i = load i64, ptr %.777.i, align 8, !noalias !287
  %.45.i384.i = getelementptr i8, ptr %arg.f.4, i64 272
  %.46.i385.i = load i64, ptr %.45.i384.i, align 8, !noalias !288
  %.50.i386.i = inttoptr i64 %.46.i385.i to ptr
  %.2228.i = icmp slt i64 %.119.i, 0
  %.2229.i = select i1 %.2228.i, i64 %.451.i, i64 0
  %2 = getelementptr i64, ptr %.50.i386.i, i64 %.119.i
  %.2243.i = getelementptr i64, ptr %2, i64 %.2229.i
  %.2244.i = load i64, ptr %.2243.i, align 8, !noalias !287
  %.2573.i = getelementptr i8, ptr %arg.f.4, i64 224
  %.2574.i = load i64, ptr %.2573.i, align 8, !noalias !287
  %.2575.i = icmp sgt i64 %.2574.i, 0
  br i1 %.2575.i, label %B432.i, label %b83
B432.i:
  %.2905.i = getelementptr i8, ptr %arg.f.4, i64 192
  %.2906.i = load i64, ptr %.2905.i, align 8, !noalias !287
  %.2908.i = mul nsw i64 %.2906.i, %arg.i
  br label %b83
b83:
  %"$phi476.1.2.0.i" = phi i64 [ %.2908.i, %B432.i ], [ 0, %entry ]
  %.2922.i = add nsw i64 %"$phi476.1.2.0.i", %.2244.i
  %.3290.i = getelementptr i8, ptr %arg.f.4, i64 280
  %.3291.i = load i64, ptr %.3290.i, align 8, !noalias !287
  %.3298.i = mul nsw i64 %.778.i, 56
  %.3299.i = mul nsw i64 %.3298.i, %.2922.i
  %.3300.i = add nsw i64 %.3299.i, %.3291.i
  %.3301.i = inttoptr i64 %.3300.i to ptr
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(1280) %.fca.3.0.0.gep, i8 0, i64 1280, i1 false)
  call fastcc void @v72(ptr %.730, ptr nonnull %arg.f.4, i64 %arg.i)
  %.746.fca.5.0.2.load = load i64, ptr %.fca.5.0.2.gep, align 8
  %.746.fca.5.0.4.load = load ptr, ptr %.fca.5.0.4.gep, align 8
  %.341.i = getelementptr i8, ptr %arg.f.4, i64 352
  %.342.i = load i64, ptr %.341.i, align 8, !noalias !291
  %.346.i = mul nuw nsw i64 %arg.run, 48
  %.347.i = add nsw i64 %.342.i, %.346.i
  %.348.i = inttoptr i64 %.347.i to ptr
  %.1826 = add nsw i64 %.677, %.350
  %.45.i = getelementptr i8, ptr %arg.f.4, i64 304
  %.46.i = load i64, ptr %.45.i, align 8, !noalias !294
  %.50.i = inttoptr i64 %.46.i to ptr
  %.44.i = getelementptr i8, ptr %arg.f.4, i64 408
  %.45.i673 = load i64, ptr %.44.i, align 8, !noalias !297
  %.46.i674 = inttoptr i64 %.45.i673 to ptr
  %.372.i = load i64, ptr %arg.f.4, align 8, !noalias !297
  %.2235 = select i1 %.95.i, i64 %.372.i, i64 0
  %.idx = mul i64 %.372.i, 120
  %3 = getelementptr i8, ptr %.46.i674, i64 %.idx
  %4 = getelementptr double, ptr %3, i64 %arg.i
  %.2257 = getelementptr double, ptr %4, i64 %.2235
  %.2258 = load double, ptr %.2257, align 8
  %.2319 = getelementptr i8, ptr %.348.i, i64 16
  %.2320 = load i64, ptr %.2319, align 8
  %.2334 = icmp slt i64 %.2320, 0
  %.2335 = select i1 %.2334, i64 %.1826, i64 0
  %5 = getelementptr double, ptr %.50.i, i64 %.2320
  %.2349 = getelementptr double, ptr %5, i64 %.2335
  %.2350 = load double, ptr %.2349, align 8
  %.2352 = fcmp olt double %.2350, %.2258
  br i1 %.2352, label %B382.preheader, label %common.ret
B382.preheader:
  %.3256 = getelementptr i8, ptr %arg.f.4, i64 48
  %.2437683.not = icmp slt i64 %.350, 1
  %.3583 = getelementptr i8, ptr %arg.f.4, i64 560
  %.148211.not.i = icmp slt i64 %.746.fca.5.0.2.load, 1
  br label %B382
B382:
  br i1 %.2437683.not, label %B586, label %B412.if
B586:
  %.3257 = load i64, ptr %.3256, align 8
  %.3584 = load i64, ptr %.3583, align 8
  call fastcc void @v81(ptr %.3588, ptr nonnull %arg.f.4, i64 %arg.i, i64 %arg.run, i64 %.3257, i64 %.3584)
  %.3643 = load i64, ptr %.2319, align 8
  %.3657 = icmp slt i64 %.3643, 0
  %.3658 = select i1 %.3657, i64 %.1826, i64 0
  %6 = getelementptr double, ptr %.50.i, i64 %.3643
  %.3672 = getelementptr double, ptr %6, i64 %.3658
  %.3673 = load double, ptr %.3672, align 8
  %.3675 = fcmp olt double %.3673, %.2258
  br i1 %.3675, label %B382, label %common.ret
common.ret:
  store ptr null, ptr %retptr, align 8
  ret void
B412.if:
  %.2381.0684 = phi i64 [ %.2450, %b90 ], [ 0, %B382 ]
  %.2450 = add nuw nsw i64 %.2381.0684, 1
  %.2504 = load i64, ptr %.2319, align 8
  %.2505 = add nsw i64 %.2504, %.2381.0684
  %.2519 = icmp slt i64 %.2505, 0
  %.2520 = select i1 %.2519, i64 %.1826, i64 0
  %7 = getelementptr double, ptr %.50.i, i64 %.2505
  %.2534 = getelementptr double, ptr %7, i64 %.2520
  %.2535 = load double, ptr %.2534, align 8
  %.12.i = fcmp olt double %.2258, %.2535
  %.13.i = select i1 %.12.i, double %.2258, double %.2535
  br i1 %.148211.not.i, label %b90, label %B58.if.i
B164.i:
  %.44.i.i = getelementptr i8, ptr %9, i64 24
  %.45.i.i675 = load double, ptr %.44.i.i, align 8, !noalias !300
  %.73.i.i = getelementptr i8, ptr %9, i64 32
  %.74.i.i = load double, ptr %.73.i.i, align 8, !noalias !300
  %.75.i.i = fmul double %.74.i.i, 5.000000e-01
  %.76.i.i = fmul double %.245.i, %.75.i.i
  %.77.i.i = fadd double %.45.i.i675, %.76.i.i
  %.78.i.i = fmul double %.245.i, %.77.i.i
  %.87.le.i.i = tail call double @llvm.floor.f64(double %.78.i.i)
  %.92.i.i = fsub double %.78.i.i, %.87.le.i.i
  %.93.i.i = fmul double %.92.i.i, 0x401921FB54442D18
  %.121.i.i = getelementptr i8, ptr %9, i64 40
  %.122.i.i = load double, ptr %.121.i.i, align 8, !noalias !300
  %.126.i.i = fadd double %.122.i.i, %.93.i.i
  %.593.le.i = tail call double @llvm.sin.f64(double %.126.i.i)
  %.598.i = fmul double %.423.i, %.593.le.i
  %.600.i = fadd double %.361.i, %.598.i
  br label %B272.i
B272.i:
  %value.2.1.i = phi double [ %.600.i, %B164.i ], [ %.361.i, %B58.if.i ]
  %8 = getelementptr double, ptr %.746.fca.5.0.4.load, i64 %.90.0213.i
  store double %value.2.1.i, ptr %8, align 8, !noalias !305
  %exitcond.not.i = icmp eq i64 %.746.fca.5.0.2.load, %.161.i
  br i1 %exitcond.not.i, label %b94, label %B58.if.i
B58.if.i:
  %.90.0213.i = phi i64 [ %.161.i, %B272.i ], [ 0, %B412.if ]
  %.161.i = add nuw nsw i64 %.90.0213.i, 1
  %.idx682 = mul i64 %.90.0213.i, 56
  %9 = getelementptr i8, ptr %.3301.i, i64 %.idx682
  %.242.i = getelementptr i8, ptr %9, i64 48
  %.243.i = load double, ptr %.242.i, align 8, !noalias !305
  %.245.i = fsub double %.13.i, %.243.i
  %.303.i = load double, ptr %9, align 8, !noalias !305
  %.357.i = getelementptr i8, ptr %9, i64 8
  %.358.i = load double, ptr %.357.i, align 8, !noalias !305
  %.360.i = fmul double %.245.i, %.358.i
  %.361.i = fadd double %.303.i, %.360.i
  %.422.i = getelementptr i8, ptr %9, i64 16
  %.423.i = load double, ptr %.422.i, align 8, !noalias !305
  %.424.i = fcmp une double %.423.i, 0.000000e+00
  br i1 %.424.i, label %B164.i, label %B272.i
b94:
  %.372.i.i = load i64, ptr %arg.f.4, align 8, !noalias !306
  %.45.i.i677 = load i64, ptr %.3583, align 8, !noalias !306
  %.46.i.i678 = inttoptr i64 %.45.i.i677 to ptr
  %invariant.gep.i = getelementptr double, ptr %.46.i.i678, i64 %.2381.0684
  br label %B76.if.i
B76.if.i:
  %.119.0118.i = phi i64 [ 0, %b94 ], [ %.188.i, %B76.if.i ]
  %.188.i = add nuw nsw i64 %.119.0118.i, 1
  %10 = getelementptr double, ptr %.746.fca.5.0.4.load, i64 %.119.0118.i
  %.242.i679 = load double, ptr %10, align 8, !noalias !311
  %.290.i = mul i64 %.119.0118.i, %.372.i.i
  %gep121.i = getelementptr double, ptr %invariant.gep.i, i64 %.290.i
  store double %.242.i679, ptr %gep121.i, align 8, !noalias !311
  %exitcond.not.i680 = icmp eq i64 %.188.i, %.746.fca.5.0.2.load
  br i1 %exitcond.not.i680, label %b90, label %B76.if.i
b90:
  %exitcond.not = icmp eq i64 %.350, %.2450
  br i1 %exitcond.not, label %B586, label %B412.if
}
define internal fastcc void @v81(ptr noalias nonnull writeonly initializes((0, 8)) %retptr, ptr readonly %arg.f.4, i64 %arg.i, i64 %arg.run, i64 %arg.function, i64 %arg.u) unnamed_addr {
entry:
  %.345 = getelementptr i8, ptr %arg.f.4, i64 304
  %.346 = load i64, ptr %.345, align 8
  %.341.i = getelementptr i8, ptr %arg.f.4, i64 400
  %.342.i = load i64, ptr %.341.i, align 8, !noalias !312
  %.667.i = getelementptr i8, ptr %arg.f.4, i64 392
  %.668.i = load i64, ptr %.667.i, align 8, !noalias !312
  %.669.i = sub nsw i64 %arg.run, %.668.i
  %.670.i = shl nsw i64 %.669.i, 3
  %.995.i = getelementptr i8, ptr %arg.f.4, i64 120
  %.996.i = load i64, ptr %.995.i, align 8, !noalias !312
  %.997.i = mul nsw i64 %.670.i, %.996.i
  %.1322.i = getelementptr i8, ptr %arg.f.4, i64 200
  %.1323.i = load i64, ptr %.1322.i, align 8, !noalias !312
  %.1327.i = mul nsw i64 %.997.i, %.1323.i
  %.1328.i = add nsw i64 %.1327.i, %.342.i
  %.20 = shl nsw i64 %arg.i, 3
  %.700 = getelementptr i8, ptr %arg.f.4, i64 352
  %.701 = load i64, ptr %.700, align 8
  %.702 = mul nuw nsw i64 %arg.run, 48
  %.703 = add nuw i64 %.702, 16
  %.705 = add i64 %.703, %.701
  %.1030 = getelementptr i8, ptr %arg.f.4, i64 296
  %.1031 = load i64, ptr %.1030, align 8
  %.1356 = getelementptr i8, ptr %arg.f.4, i64 408
  %.1357 = load i64, ptr %.1356, align 8
  %.1684 = load i64, ptr %arg.f.4, align 8
  %.1685 = mul nsw i64 %.1684, 120
  %.1686 = add i64 %.1357, %.20
  %.1687 = add i64 %.1686, %.1685
  %.2012 = getelementptr i8, ptr %arg.f.4, i64 416
  %.2013 = load i64, ptr %.2012, align 8
  %.2014 = add nsw i64 %.2013, %.20
  %.2339 = getelementptr i8, ptr %arg.f.4, i64 424
  %.2340 = load i64, ptr %.2339, align 8
  %.2341 = add nsw i64 %.2340, %.20
  %.2666 = getelementptr i8, ptr %arg.f.4, i64 512
  %.2667 = load i64, ptr %.2666, align 8
  %.2668 = add nsw i64 %.2667, %.20
  %.2993 = getelementptr i8, ptr %arg.f.4, i64 520
  %.2994 = load i64, ptr %.2993, align 8
  %.2995 = add nsw i64 %.2994, %.20
  %.3320 = getelementptr i8, ptr %arg.f.4, i64 456
  %.3321 = load i64, ptr %.3320, align 8
  %.3325 = add nsw i64 %.3321, %.20
  %.3326 = inttoptr i64 %arg.function to ptr
  tail call void %.3326(i64 %.346, i64 %.1328.i, i64 %.705, i64 %.1031, i64 %.1687, i64 %.2014, i64 %.2341, i64 %.2668, i64 %.2995, i64 %arg.u, i64 %.3325)
  store ptr null, ptr %retptr, align 8
  ret void
}
define internal fastcc void @v77(ptr noalias nonnull writeonly %retptr, i64 %arg.run.0.3, ptr %arg.run.1.0.4, ptr %arg.run.3.2.4, ptr readonly %arg.run.4.0.4, i64 %arg.run.4.0.5.1, ptr readonly %arg.run.4.1.4, i64 %arg.run.4.1.5.0, i64 %arg.run.4.1.5.1, i64 %arg.run.5.0.2, ptr %arg.run.5.0.4, ptr %arg.run.5.3.4, ptr readonly %arg.run.5.11.4, i64 %arg.run.5.11.5.0, i64 %arg.run.5.12.2, ptr %arg.run.5.12.4, i64 %arg.run.6.2, ptr readonly %arg.run.6.4, ptr readonly %arg.segment.2.4, i64 %arg.segment.2.5.1, double %arg.step.0, double %arg.step.1, ptr readonly %arg.step.3.4) unnamed_addr {
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
  br i1 %.703768.not.i, label %b103, label %B102.if.i
B102.if.i:
  %.645.0769.i = phi i64 [ %.716.i, %B102.if.i ], [ 0, %B48 ]
  %.716.i = add nuw nsw i64 %.645.0769.i, 1
  %0 = getelementptr double, ptr %arg.run.6.4, i64 %.645.0769.i
  %.774.i = load double, ptr %0, align 8, !noalias !315
  %.779.i = fmul double %.478.i, %.774.i
  %1 = getelementptr double, ptr %arg.step.3.4, i64 %.645.0769.i
  %.813.i = load double, ptr %1, align 8, !noalias !315
  %2 = getelementptr double, ptr %arg.run.5.11.4, i64 %.645.0769.i
  %.846.i = load double, ptr %2, align 8, !noalias !315
  %.848.i = add nsw i64 %.645.0769.i, %arg.run.6.2
  %.862.i = icmp slt i64 %.848.i, 0
  %.863.i = select i1 %.862.i, i64 %arg.run.5.11.5.0, i64 0
  %3 = getelementptr double, ptr %arg.run.5.11.4, i64 %.848.i
  %.877.i = getelementptr double, ptr %3, i64 %.863.i
  %.878.i = load double, ptr %.877.i, align 8, !noalias !315
  %.880.i = fmul double %high.3.1, %.878.i
  %.881.i = fadd double %.846.i, %.880.i
  %.883.i = fmul double %.478.i, %.881.i
  %.884.i = fadd double %.813.i, %.883.i
  %.886.i = fmul double %high.3.1, %.884.i
  %.887.i = fadd double %.779.i, %.886.i
  %4 = getelementptr double, ptr %arg.run.5.12.4, i64 %.645.0769.i
  store double %.887.i, ptr %4, align 8, !noalias !315
  %exitcond.not.i = icmp eq i64 %arg.run.5.12.2, %.716.i
  br i1 %exitcond.not.i, label %b103, label %B102.if.i
b103:
  %.796 = fmul double %arg.step.1, %high.3.1
  %.797 = fadd double %arg.step.0, %.796
  br i1 %.148211.not.i.i.i, label %b87, label %B58.if.i.i.i
B164.i.i.i:
  %.44.i.i.i.i = getelementptr i8, ptr %6, i64 24
  %.45.i.i.i.i = load double, ptr %.44.i.i.i.i, align 8, !noalias !318
  %.73.i.i.i.i = getelementptr i8, ptr %6, i64 32
  %.74.i.i.i.i = load double, ptr %.73.i.i.i.i, align 8, !noalias !318
  %.75.i.i.i.i = fmul double %.74.i.i.i.i, 5.000000e-01
  %.76.i.i.i.i = fmul double %.245.i.i.i, %.75.i.i.i.i
  %.77.i.i.i.i = fadd double %.45.i.i.i.i, %.76.i.i.i.i
  %.78.i.i.i.i = fmul double %.245.i.i.i, %.77.i.i.i.i
  %.87.le.i.i.i.i = tail call double @llvm.floor.f64(double %.78.i.i.i.i)
  %.92.i.i.i.i = fsub double %.78.i.i.i.i, %.87.le.i.i.i.i
  %.93.i.i.i.i = fmul double %.92.i.i.i.i, 0x401921FB54442D18
  %.121.i.i.i.i = getelementptr i8, ptr %6, i64 40
  %.122.i.i.i.i = load double, ptr %.121.i.i.i.i, align 8, !noalias !318
  %.126.i.i.i.i = fadd double %.122.i.i.i.i, %.93.i.i.i.i
  %.593.le.i.i.i = tail call double @llvm.sin.f64(double %.126.i.i.i.i)
  %.598.i.i.i = fmul double %.423.i.i.i, %.593.le.i.i.i
  %.600.i.i.i = fadd double %.361.i.i.i, %.598.i.i.i
  br label %B272.i.i.i
B272.i.i.i:
  %value.2.1.i.i.i = phi double [ %.600.i.i.i, %B164.i.i.i ], [ %.361.i.i.i, %B58.if.i.i.i ]
  %5 = getelementptr double, ptr %arg.run.5.0.4, i64 %.90.0213.i.i.i
  store double %value.2.1.i.i.i, ptr %5, align 8, !noalias !327
  %exitcond.not.i.i.i = icmp eq i64 %arg.run.5.0.2, %.161.i.i.i
  br i1 %exitcond.not.i.i.i, label %b87, label %B58.if.i.i.i
B58.if.i.i.i:
  %.90.0213.i.i.i = phi i64 [ %.161.i.i.i, %B272.i.i.i ], [ 0, %b103 ]
  %.161.i.i.i = add nuw nsw i64 %.90.0213.i.i.i, 1
  %.238.i.i.i = mul i64 %.90.0213.i.i.i, %arg.segment.2.5.1
  %6 = getelementptr double, ptr %arg.segment.2.4, i64 %.238.i.i.i
  %.242.i.i.i = getelementptr i8, ptr %6, i64 48
  %.243.i.i.i = load double, ptr %.242.i.i.i, align 8, !noalias !327
  %.245.i.i.i = fsub double %.797, %.243.i.i.i
  %.303.i.i.i = load double, ptr %6, align 8, !noalias !327
  %.357.i.i.i = getelementptr i8, ptr %6, i64 8
  %.358.i.i.i = load double, ptr %.357.i.i.i, align 8, !noalias !327
  %.360.i.i.i = fmul double %.245.i.i.i, %.358.i.i.i
  %.361.i.i.i = fadd double %.303.i.i.i, %.360.i.i.i
  %.422.i.i.i = getelementptr i8, ptr %6, i64 16
  %.423.i.i.i = load double, ptr %.422.i.i.i, align 8, !noalias !327
  %.424.i.i.i = fcmp une double %.423.i.i.i, 0.000000e+00
  br i1 %.424.i.i.i, label %B164.i.i.i, label %B272.i.i.i
b87:
  store double %.797, ptr %arg.run.5.3.4, align 8, !noalias !328
  tail call void %.992.i.i(ptr nonnull %arg.run.5.3.4, ptr %arg.run.5.12.4, ptr %arg.run.5.0.4, ptr %arg.run.1.0.4, ptr %arg.run.3.2.4), !noalias !328
  br label %B140.i
B140.i:
  %.859.0.i = phi i64 [ 0, %b87 ], [ %.928.i, %B288.i ]
  %exitcond294.not.i = icmp eq i64 %.859.0.i, %spec.select.i
  br i1 %exitcond294.not.i, label %b93, label %B142.i
B142.i:
  %.1005.i = mul i64 %.859.0.i, %arg.run.4.1.5.1
  %7 = getelementptr double, ptr %arg.run.4.1.4, i64 %.1005.i
  %.1009.i = getelementptr i8, ptr %7, i64 16
  %.1010.i = load double, ptr %.1009.i, align 8, !noalias !329
  %.1186.i = mul i64 %.859.0.i, %arg.run.4.0.5.1
  %8 = getelementptr i64, ptr %arg.run.4.0.4, i64 %.1186.i
  br label %B194.if.i
B226.i:
  %9 = getelementptr double, ptr %7, i64 %.1037.0289.i
  %.1249.i = load double, ptr %9, align 8, !noalias !329
  %.1338.i = getelementptr double, ptr %arg.run.3.2.4, i64 %.1191.i
  %.1339.i = load double, ptr %.1338.i, align 8, !noalias !329
  %.1340.i = fmul double %.1249.i, %.1339.i
  %.1342.i = fadd double %value.2.1291.i, %.1340.i
  br label %B286.i
B286.i:
  %value.3.2.i = phi double [ %.1342.i, %B226.i ], [ %value.2.1291.i, %B194.if.i ]
  br i1 %exitcond.not.i1267, label %B288.i, label %B194.if.i
B288.i:
  %.928.i = add nuw i64 %.859.0.i, 1
  %.1361.i = fcmp ogt double %value.3.2.i, 0.000000e+00
  br i1 %.1361.i, label %b93, label %B140.i
B194.if.i:
  %value.2.1291.i = phi double [ %.1010.i, %B142.i ], [ %value.3.2.i, %B286.i ]
  %exitcond.not.i1267 = phi i1 [ false, %B142.i ], [ true, %B286.i ]
  %.1037.0289.i = phi i64 [ 0, %B142.i ], [ 1, %B286.i ]
  %10 = getelementptr i64, ptr %8, i64 %.1037.0289.i
  %.1191.i = load i64, ptr %10, align 8, !noalias !329
  %.1194.i = icmp sgt i64 %.1191.i, -1
  br i1 %.1194.i, label %B226.i, label %B286.i
b93:
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
  %.774.i1273 = load double, ptr %12, align 8, !noalias !330
  %.779.i1274 = fmul double %.478.i1268, %.774.i1273
  %13 = getelementptr double, ptr %arg.step.3.4, i64 %.645.0769.i1271
  %.813.i1275 = load double, ptr %13, align 8, !noalias !330
  %14 = getelementptr double, ptr %arg.run.5.11.4, i64 %.645.0769.i1271
  %.846.i1276 = load double, ptr %14, align 8, !noalias !330
  %.848.i1277 = add nsw i64 %.645.0769.i1271, %arg.run.6.2
  %.862.i1278 = icmp slt i64 %.848.i1277, 0
  %.863.i1279 = select i1 %.862.i1278, i64 %arg.run.5.11.5.0, i64 0
  %15 = getelementptr double, ptr %arg.run.5.11.4, i64 %.848.i1277
  %.877.i1280 = getelementptr double, ptr %15, i64 %.863.i1279
  %.878.i1281 = load double, ptr %.877.i1280, align 8, !noalias !330
  %.880.i1282 = fmul double %high.3.1.theta.2.1, %.878.i1281
  %.881.i1283 = fadd double %.846.i1276, %.880.i1282
  %.883.i1284 = fmul double %.478.i1268, %.881.i1283
  %.884.i1285 = fadd double %.813.i1275, %.883.i1284
  %.886.i1286 = fmul double %high.3.1.theta.2.1, %.884.i1285
  %.887.i1287 = fadd double %.779.i1274, %.886.i1286
  %16 = getelementptr double, ptr %arg.run.5.12.4, i64 %.645.0769.i1271
  store double %.887.i1287, ptr %16, align 8, !noalias !330
  %exitcond.not.i1288 = icmp eq i64 %arg.run.5.12.2, %.716.i1272
  br i1 %exitcond.not.i1288, label %common.ret, label %B102.if.i1270
}
define internal fastcc void @v78(ptr noalias nonnull writeonly %retptr, i64 %arg.run.0.3, i64 %arg.run.0.4, ptr %arg.run.1.0.4, i64 %arg.run.1.1.2, ptr %arg.run.1.1.4, ptr readonly %arg.run.1.2.4, i64 %arg.run.1.3.2, ptr %arg.run.1.3.4, ptr %arg.run.1.4.4, i64 %arg.run.2.1.2, i64 %arg.run.3.0.2, ptr readonly %arg.run.3.0.4, i64 %arg.run.3.0.5.0, ptr writeonly %arg.run.3.1.4, i64 %arg.run.3.1.5.1, i64 %arg.run.3.2.2, ptr %arg.run.3.2.4, i64 %arg.run.5.0.2, ptr %arg.run.5.0.4, ptr %arg.run.5.3.4, ptr %arg.run.5.6.4, i64 %arg.run.5.6.5.0, ptr readonly %arg.run.5.11.4, i64 %arg.run.5.11.5.0, i64 %arg.run.5.12.2, ptr %arg.run.5.12.4, i64 %arg.run.6.2, ptr readonly %arg.run.6.4, ptr %arg.run.9.4, ptr readonly %arg.segment.2.4, i64 %arg.segment.2.5.1, double %arg.step.0, double %arg.step.1, double %arg.step.2, ptr readonly %arg.step.3.4) unnamed_addr {
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
  %.235.i = load double, ptr %0, align 8, !noalias !333
  %.12.i.i = fcmp olt double %.235.i, %first.2.0129.i
  %.13.i.i = select i1 %.12.i.i, double %.235.i, double %first.2.0129.i
  %exitcond.not.i = icmp eq i64 %arg.run.1.3.2, %.177.i
  br i1 %exitcond.not.i, label %b97, label %B78.if.i.backedge
B78.if.i.backedge:
  %first.2.0129.i.be = phi double [ %.13.i.i, %B78.if.i ], [ 0x7FF0000000000000, %b103 ]
  %.106.0128.i.be = phi i64 [ %.177.i, %B78.if.i ], [ 0, %b103 ]
  br label %B78.if.i
b97:
  %.586 = fcmp ult double %.13.i.i, %.584
  br i1 %.586, label %B124, label %common.ret
common.ret:
  %storemerge = phi double [ %arg.step.2, %b97 ], [ %.13.i.i, %b103 ]
  store double %storemerge, ptr %retptr, align 8
  ret void
B124:
  call fastcc void @v79(ptr %.729, i64 %arg.run.0.3, ptr %arg.run.1.0.4, i64 %arg.run.2.1.2, i64 %arg.run.3.0.2, ptr %arg.run.3.0.4, i64 %arg.run.3.0.5.0, ptr %arg.run.3.1.4, i64 %arg.run.3.1.5.1, i64 %arg.run.3.2.2, ptr %arg.run.3.2.4, i64 %arg.run.5.0.2, ptr %arg.run.5.0.4, ptr %arg.run.5.3.4, ptr %arg.run.5.6.4, i64 %arg.run.5.6.5.0, ptr %arg.run.5.11.4, i64 %arg.run.5.11.5.0, i64 %arg.run.6.2, ptr %arg.run.6.4, ptr %arg.run.9.4, ptr %arg.segment.2.4, i64 %arg.segment.2.5.1, double %arg.step.0, double %arg.step.1, ptr %arg.step.3.4, double %.13.i.i)
  %.850 = fsub double %.13.i.i, %arg.step.0
  %.856 = fdiv double %.850, %arg.step.1
  %.478.i = fsub double 1.000000e+00, %.856
  br i1 %.703768.not.i, label %b103, label %B102.if.i
B102.if.i:
  %.645.0769.i = phi i64 [ %.716.i, %B102.if.i ], [ 0, %B124 ]
  %.716.i = add nuw nsw i64 %.645.0769.i, 1
  %1 = getelementptr double, ptr %arg.run.6.4, i64 %.645.0769.i
  %.774.i = load double, ptr %1, align 8, !noalias !336
  %.779.i = fmul double %.478.i, %.774.i
  %2 = getelementptr double, ptr %arg.step.3.4, i64 %.645.0769.i
  %.813.i = load double, ptr %2, align 8, !noalias !336
  %3 = getelementptr double, ptr %arg.run.5.11.4, i64 %.645.0769.i
  %.846.i = load double, ptr %3, align 8, !noalias !336
  %.848.i = add nsw i64 %.645.0769.i, %arg.run.6.2
  %.862.i = icmp slt i64 %.848.i, 0
  %.863.i = select i1 %.862.i, i64 %arg.run.5.11.5.0, i64 0
  %4 = getelementptr double, ptr %arg.run.5.11.4, i64 %.848.i
  %.877.i = getelementptr double, ptr %4, i64 %.863.i
  %.878.i = load double, ptr %.877.i, align 8, !noalias !336
  %.880.i = fmul double %.856, %.878.i
  %.881.i = fadd double %.846.i, %.880.i
  %.883.i = fmul double %.478.i, %.881.i
  %.884.i = fadd double %.813.i, %.883.i
  %.886.i = fmul double %.856, %.884.i
  %.887.i = fadd double %.779.i, %.886.i
  %5 = getelementptr double, ptr %arg.run.5.12.4, i64 %.645.0769.i
  store double %.887.i, ptr %5, align 8, !noalias !336
  %exitcond.not.i1480 = icmp eq i64 %arg.run.5.12.2, %.716.i
  br i1 %exitcond.not.i1480, label %b103, label %B102.if.i
b103:
  store i8 0, ptr %.1201, align 1
  call fastcc void @v74(ptr %.1201, i64 %arg.run.0.4, ptr %arg.run.1.0.4, i64 %arg.run.1.1.2, ptr nonnull %arg.run.1.1.4, ptr %arg.run.1.2.4, i64 %arg.run.1.3.2, ptr %arg.run.1.3.4, ptr %arg.run.1.4.4, i64 %arg.run.5.0.2, ptr %arg.run.5.0.4, ptr %arg.run.5.3.4, ptr %arg.segment.2.4, i64 %arg.segment.2.5.1, double %.13.i.i, ptr %arg.run.5.12.4)
  %.1308 = load i8, ptr %.1201, align 1
  %.1311.not = icmp eq i8 %.1308, 0
  br i1 %.1311.not, label %B78.if.i.backedge, label %common.ret
}
define internal fastcc void @v79(ptr noalias nonnull writeonly %retptr, i64 %arg.run.0.3, ptr %arg.run.1.0.4, i64 %arg.run.2.1.2, i64 %arg.run.3.0.2, ptr readonly %arg.run.3.0.4, i64 %arg.run.3.0.5.0, ptr writeonly %arg.run.3.1.4, i64 %arg.run.3.1.5.1, i64 %arg.run.3.2.2, ptr %arg.run.3.2.4, i64 %arg.run.5.0.2, ptr %arg.run.5.0.4, ptr %arg.run.5.3.4, ptr %arg.run.5.6.4, i64 %arg.run.5.6.5.0, ptr readonly %arg.run.5.11.4, i64 %arg.run.5.11.5.0, i64 %arg.run.6.2, ptr readonly %arg.run.6.4, ptr %arg.run.9.4, ptr readonly %arg.segment.2.4, i64 %arg.segment.2.5.1, double %arg.step.0, double %arg.step.1, ptr readonly %arg.step.3.4, double %arg.until) unnamed_addr {
entry:
  %.5.i = fmul double %arg.until, 0x3D06849B86A12B9B
  %.6.i = fadd double %.5.i, 1.000000e-15
  %.510 = fsub double %arg.until, %.6.i
  %.731 = icmp slt i64 %arg.run.5.6.5.0, 1
  br i1 %.731, label %B0.endif.else.endif.if, label %B0.endif.else.endif.endif, !prof !69
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
  br i1 %.703768.not.i, label %b103, label %B102.if.i
B102.if.i:
  %.645.0769.i = phi i64 [ %.716.i, %B102.if.i ], [ 0, %B244 ]
  %.716.i = add nuw nsw i64 %.645.0769.i, 1
  %2 = getelementptr double, ptr %arg.run.6.4, i64 %.645.0769.i
  %.774.i = load double, ptr %2, align 8, !noalias !339
  %.779.i = fmul double %.478.i, %.774.i
  %3 = getelementptr double, ptr %arg.step.3.4, i64 %.645.0769.i
  %.813.i = load double, ptr %3, align 8, !noalias !339
  %4 = getelementptr double, ptr %arg.run.5.11.4, i64 %.645.0769.i
  %.846.i = load double, ptr %4, align 8, !noalias !339
  %.848.i = add nsw i64 %.645.0769.i, %arg.run.6.2
  %.862.i = icmp slt i64 %.848.i, 0
  %.863.i = select i1 %.862.i, i64 %arg.run.5.11.5.0, i64 0
  %5 = getelementptr double, ptr %arg.run.5.11.4, i64 %.848.i
  %.877.i = getelementptr double, ptr %5, i64 %.863.i
  %.878.i = load double, ptr %.877.i, align 8, !noalias !339
  %.880.i = fmul double %.13.i, %.878.i
  %.881.i = fadd double %.846.i, %.880.i
  %.883.i = fmul double %.478.i, %.881.i
  %.884.i = fadd double %.813.i, %.883.i
  %.886.i = fmul double %.13.i, %.884.i
  %.887.i = fadd double %.779.i, %.886.i
  %6 = getelementptr double, ptr %.824, i64 %.645.0769.i
  store double %.887.i, ptr %6, align 8, !noalias !339
  %exitcond.not.i = icmp eq i64 %.799, %.716.i
  br i1 %exitcond.not.i, label %b103, label %B102.if.i
b103:
  br i1 %.148211.not.i.i.i, label %b87, label %B58.if.i.i.i
B164.i.i.i:
  %.44.i.i.i.i = getelementptr i8, ptr %8, i64 24
  %.45.i.i.i.i = load double, ptr %.44.i.i.i.i, align 8, !noalias !342
  %.73.i.i.i.i = getelementptr i8, ptr %8, i64 32
  %.74.i.i.i.i = load double, ptr %.73.i.i.i.i, align 8, !noalias !342
  %.75.i.i.i.i = fmul double %.74.i.i.i.i, 5.000000e-01
  %.76.i.i.i.i = fmul double %.245.i.i.i, %.75.i.i.i.i
  %.77.i.i.i.i = fadd double %.45.i.i.i.i, %.76.i.i.i.i
  %.78.i.i.i.i = fmul double %.245.i.i.i, %.77.i.i.i.i
  %.87.le.i.i.i.i = tail call double @llvm.floor.f64(double %.78.i.i.i.i)
  %.92.i.i.i.i = fsub double %.78.i.i.i.i, %.87.le.i.i.i.i
  %.93.i.i.i.i = fmul double %.92.i.i.i.i, 0x401921FB54442D18
  %.121.i.i.i.i = getelementptr i8, ptr %8, i64 40
  %.122.i.i.i.i = load double, ptr %.121.i.i.i.i, align 8, !noalias !342
  %.126.i.i.i.i = fadd double %.122.i.i.i.i, %.93.i.i.i.i
  %.593.le.i.i.i = tail call double @llvm.sin.f64(double %.126.i.i.i.i)
  %.598.i.i.i = fmul double %.423.i.i.i, %.593.le.i.i.i
  %.600.i.i.i = fadd double %.361.i.i.i, %.598.i.i.i
  br label %B272.i.i.i
B272.i.i.i:
  %value.2.1.i.i.i = phi double [ %.600.i.i.i, %B164.i.i.i ], [ %.361.i.i.i, %B58.if.i.i.i ]
  %7 = getelementptr double, ptr %arg.run.5.0.4, i64 %.90.0213.i.i.i
  store double %value.2.1.i.i.i, ptr %7, align 8, !noalias !351
  %exitcond.not.i.i.i = icmp eq i64 %arg.run.5.0.2, %.161.i.i.i
  br i1 %exitcond.not.i.i.i, label %b87, label %B58.if.i.i.i
B58.if.i.i.i:
  %.90.0213.i.i.i = phi i64 [ %.161.i.i.i, %B272.i.i.i ], [ 0, %b103 ]
  %.161.i.i.i = add nuw nsw i64 %.90.0213.i.i.i, 1
  %.238.i.i.i = mul i64 %.90.0213.i.i.i, %arg.segment.2.5.1
  %8 = getelementptr double, ptr %arg.segment.2.4, i64 %.238.i.i.i
  %.242.i.i.i = getelementptr i8, ptr %8, i64 48
  %.243.i.i.i = load double, ptr %.242.i.i.i, align 8, !noalias !351
  %.245.i.i.i = fsub double %.1065, %.243.i.i.i
  %.303.i.i.i = load double, ptr %8, align 8, !noalias !351
  %.357.i.i.i = getelementptr i8, ptr %8, i64 8
  %.358.i.i.i = load double, ptr %.357.i.i.i, align 8, !noalias !351
  %.360.i.i.i = fmul double %.245.i.i.i, %.358.i.i.i
  %.361.i.i.i = fadd double %.303.i.i.i, %.360.i.i.i
  %.422.i.i.i = getelementptr i8, ptr %8, i64 16
  %.423.i.i.i = load double, ptr %.422.i.i.i, align 8, !noalias !351
  %.424.i.i.i = fcmp une double %.423.i.i.i, 0.000000e+00
  br i1 %.424.i.i.i, label %B164.i.i.i, label %B272.i.i.i
b87:
  store double %.1065, ptr %arg.run.5.3.4, align 8, !noalias !352
  tail call void %.992.i.i(ptr nonnull %arg.run.5.3.4, ptr %.824, ptr %arg.run.5.0.4, ptr %arg.run.1.0.4, ptr %arg.run.3.2.4), !noalias !352
  %.649.i = load i64, ptr %.912, align 8, !noalias !353
  br i1 %.754872.not.i, label %b88, label %B116.if.lr.ph.i
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
  %.821.i = load double, ptr %9, align 8, !noalias !353
  %.898.i = mul i64 %.698.0873.i, %arg.run.3.1.5.1
  %gep876.i = getelementptr double, ptr %invariant.gep875.i, i64 %.898.i
  store double %.821.i, ptr %gep876.i, align 8, !noalias !353
  %exitcond.not.i3008 = icmp eq i64 %.767.i, %arg.run.3.2.2
  br i1 %exitcond.not.i3008, label %b88, label %B116.if.i
b88:
  %.922.i = add nsw i64 %.649.i, 1
  store i64 %.922.i, ptr %.912, align 8, !noalias !353
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
  br i1 %.743, label %B0.endif.else.endif.endif.if, label %B0.endif.else.endif.endif.endif, !prof !69
B0.endif.else.endif.endif.if:
  br label %B0.endif.else.endif.endif.endif
B0.endif.else.endif.endif.endif:
  %.711.sroa.13.1 = phi i64 [ 0, %B0.endif.else.endif.endif.if ], [ %.740, %B0.endif.else.endif.endif ]
  %.748.not = icmp slt i64 %.740, %arg.run.5.6.5.0
  br i1 %.748.not, label %B0.endif.endif, label %B0.endif.else.endif.endif.endif.if, !prof !94
B0.endif.else.endif.endif.endif.if:
  br label %B0.endif.endif
}
define internal fastcc void @v82(ptr noalias nonnull writeonly %retptr, ptr readonly %arg.f.4, i64 %arg.i, double %arg.t, double %arg.h) unnamed_addr {
entry:
  %.20 = alloca { [5 x i64], { { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, double, double, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, i8 }, { { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] } }, [13 x { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }], { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, align 8
  %.fca.1.1.4.gep = getelementptr inbounds i8, ptr %.20, i64 128
  %.fca.1.3.2.gep = getelementptr inbounds i8, ptr %.20, i64 224
  %.fca.2.2.gep56 = getelementptr inbounds i8, ptr %.20, i64 448
  %.fca.3.0.0.gep = getelementptr inbounds i8, ptr %.20, i64 528
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(521) %.20, i8 0, i64 521, i1 false)
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(1280) %.fca.3.0.0.gep, i8 0, i64 1280, i1 false)
  call fastcc void @v72(ptr %.20, ptr %arg.f.4, i64 %arg.i)
  %.36.fca.1.1.4.load = load ptr, ptr %.fca.1.1.4.gep, align 8
  %.36.fca.1.3.2.load = load i64, ptr %.fca.1.3.2.gep, align 8
  %.36.fca.2.2.load = load double, ptr %.fca.2.2.gep56, align 8
  %.340.i.i = getelementptr i8, ptr %arg.f.4, i64 568
  %.341.i.i = load i64, ptr %.340.i.i, align 8, !noalias !354
  %.342.i.i = inttoptr i64 %.341.i.i to ptr
  %.668.i.i = load i64, ptr %arg.f.4, align 8, !noalias !354
  %.95.i = icmp slt i64 %arg.i, 0
  %.96.i = select i1 %.95.i, i64 %.668.i.i, i64 0
  %0 = getelementptr i64, ptr %.342.i.i, i64 %.668.i.i
  %1 = getelementptr i64, ptr %0, i64 %arg.i
  %.118.i = getelementptr i64, ptr %1, i64 %.96.i
  %.119.i = load i64, ptr %.118.i, align 8, !noalias !359
  %.450.i = getelementptr i8, ptr %arg.f.4, i64 184
  %.451.i = load i64, ptr %.450.i, align 8, !noalias !359
  %.1132.i = add nsw i64 %.119.i, 1
  %.1134.i = icmp slt i64 %.1132.i, %.451.i
  br i1 %.1134.i, label %B204.i, label %B226.i
B204.i:
  %.45.i.i = getelementptr i8, ptr %arg.f.4, i64 264
  %.46.i.i = load i64, ptr %.45.i.i, align 8, !noalias !360
  %.50.i.i = inttoptr i64 %.46.i.i to ptr
  %.1151.i = icmp slt i64 %.119.i, -1
  %.1152.i = select i1 %.1151.i, i64 %.451.i, i64 0
  %2 = getelementptr double, ptr %.50.i.i, i64 %.1132.i
  %.1166.i = getelementptr double, ptr %2, i64 %.1152.i
  br label %B322.i
B226.i:
  %.1795.i = getelementptr i8, ptr %arg.f.4, i64 200
  %.1796.i = load i64, ptr %.1795.i, align 8, !noalias !359
  %.45.i376.i = getelementptr i8, ptr %arg.f.4, i64 304
  %.46.i377.i = load i64, ptr %.45.i376.i, align 8, !noalias !363
  %.50.i378.i = inttoptr i64 %.46.i377.i to ptr
  %3 = getelementptr double, ptr %.50.i378.i, i64 %.1796.i
  %.1862.i = getelementptr i8, ptr %3, i64 -8
  br label %B322.i
B322.i:
  %"$phi322.0.2.0.in.i" = phi ptr [ %.1166.i, %B204.i ], [ %.1862.i, %B226.i ]
  %"$phi322.0.2.0.i" = load double, ptr %"$phi322.0.2.0.in.i", align 8, !noalias !359
  %.44.i = getelementptr i8, ptr %arg.f.4, i64 408
  %.45.i = load i64, ptr %.44.i, align 8, !noalias !366
  %.46.i = inttoptr i64 %.45.i to ptr
  %.idx = mul i64 %.668.i.i, 96
  %4 = getelementptr i8, ptr %.46.i, i64 %.idx
  %5 = getelementptr double, ptr %4, i64 %arg.i
  %.900 = getelementptr double, ptr %5, i64 %.96.i
  %.901 = load double, ptr %.900, align 8
  %.1231 = getelementptr i8, ptr %arg.f.4, i64 208
  %.1232 = load i64, ptr %.1231, align 8
  %.1236 = icmp sgt i64 %.1232, 0
  %.12.i.i = fcmp olt double %.36.fca.2.2.load, %arg.h
  %.13.i.i = select i1 %.12.i.i, double %.36.fca.2.2.load, double %arg.h
  %.598.i = icmp sgt i64 %.36.fca.1.3.2.load, 0
  br i1 %.598.i, label %B78.if.i.i, label %b104
B78.if.i.i:
  %first.2.0129.i.i = phi double [ %.13.i.i.i, %B78.if.i.i ], [ 0x7FF0000000000000, %B322.i ]
  %.106.0128.i.i = phi i64 [ %.177.i.i, %B78.if.i.i ], [ 0, %B322.i ]
  %.177.i.i = add nuw nsw i64 %.106.0128.i.i, 1
  %6 = getelementptr double, ptr %.36.fca.1.1.4.load, i64 %.106.0128.i.i
  %.235.i.i = load double, ptr %6, align 8, !noalias !369
  %.12.i.i.i = fcmp olt double %.235.i.i, %first.2.0129.i.i
  %.13.i.i.i = select i1 %.12.i.i.i, double %.235.i.i, double %first.2.0129.i.i
  %exitcond.not.i.i = icmp eq i64 %.36.fca.1.3.2.load, %.177.i.i
  br i1 %exitcond.not.i.i, label %b105, label %B78.if.i.i
b105:
  %.5.i.i = fmul double %"$phi322.0.2.0.i", 0x3D06849B86A12B9B
  %.6.i.i = fadd double %.5.i.i, 1.000000e-15
  %.818.i = fsub double %"$phi322.0.2.0.i", %.6.i.i
  %.820.i = fcmp uge double %.13.i.i.i, %.818.i
  %brmerge.i = select i1 %.820.i, i1 true, i1 %.1236
  %arg.segment.1.mux.i = select i1 %.820.i, double %"$phi322.0.2.0.i", double %.13.i.i.i
  br i1 %brmerge.i, label %b104, label %B200.i
B200.i:
  %.830.i = fsub double %.13.i.i.i, %arg.t
  %.833.i = fsub double %arg.t, %.901
  %.834.i = fcmp ult double %.830.i, %.833.i
  br i1 %.834.i, label %B232.i, label %b104
B232.i:
  %.12.i999.i = fcmp olt double %.833.i, %.13.i.i
  %.13.i1000.i = select i1 %.12.i999.i, double %.833.i, double %.13.i.i
  br label %b104
b104:
  %wanted.2.0.sink.i = phi double [ %.13.i.i, %B322.i ], [ %.13.i.i, %B200.i ], [ %.13.i1000.i, %B232.i ], [ %.13.i.i, %b105 ]
  %arg.segment.1.sink.i = phi double [ %"$phi322.0.2.0.i", %B322.i ], [ %.13.i.i.i, %B200.i ], [ %"$phi322.0.2.0.i", %B232.i ], [ %arg.segment.1.mux.i, %b105 ]
  store double %wanted.2.0.sink.i, ptr %retptr, align 8
  %retptr.repack286 = getelementptr inbounds i8, ptr %retptr, i64 8
  store double %arg.segment.1.sink.i, ptr %retptr.repack286, align 8
  ret void
}
define noundef i64 @integrate_lanes(ptr initializes((384, 392)) %job) local_unnamed_addr {
  %.1009.i.i.i = alloca { double, i8 }, align 8
  %.1625.i.i.i = alloca ptr, align 8
  %.2325.i.i.i = alloca ptr, align 8
  %.3861.i.i.i = alloca ptr, align 8
  %.49.i.i1984.i.i = alloca { [5 x i64], { { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, double, double, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, i8 }, { { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] } }, [13 x { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }], { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, align 8
  %.653.i.i.i = alloca [2 x double], align 8
  %.49.i.i.i.i = alloca { [5 x i64], { { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, double, double, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, i8 }, { { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, { { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] }, { ptr, ptr, i64, i64, ptr, [2 x i64], [2 x i64] } }, [13 x { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }], { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] } }, align 8
  %.16603.i.i = alloca ptr, align 8
  %.2517.i = alloca ptr, align 8
  call void @llvm.lifetime.start.p0(ptr nonnull %.2517.i)
  %.674.i = load i64, ptr %job, align 8, !noalias !374
  %.1000.i = getelementptr i8, ptr %job, i64 104
  %.1001.i = load i64, ptr %.1000.i, align 8, !noalias !374
  %.44.i.i = getelementptr i8, ptr %job, i64 544
  %.45.i.i = load i64, ptr %.44.i.i, align 8, !noalias !377
  %.46.i.i = inttoptr i64 %.45.i.i to ptr
  %.1670.i = getelementptr i8, ptr %job, i64 168
  %.1671.i = load i64, ptr %.1670.i, align 8, !noalias !374
  %.1672.i = inttoptr i64 %.1671.i to ptr
  %.2062.i = getelementptr i8, ptr %job, i64 384
  store i64 %.674.i, ptr %.2062.i, align 8, !noalias !374
  %.2143451.not.i = icmp slt i64 %.674.i, 1
  br i1 %.2143451.not.i, label %b106, label %B360.if.lr.ph.i
B360.if.lr.ph.i:
  %.2264446.not.i = icmp slt i64 %.1001.i, 1
  %.340.i.i = getelementptr i8, ptr %job, i64 568
  br label %B360.if.i
B456.i:
  %.341.i.i = load i64, ptr %.340.i.i, align 8, !noalias !380
  %.342.i.i = inttoptr i64 %.341.i.i to ptr
  %1 = getelementptr i64, ptr %.342.i.i, i64 %.2087.0453.i
  store i64 -1, ptr %1, align 8, !noalias !374
  store ptr null, ptr %.2517.i, align 8, !noalias !374
  call fastcc void @v66(ptr %.2517.i, ptr nonnull %job, i64 %.2087.0453.i)
  %exitcond454.not.i = icmp eq i64 %.2156.i, %.674.i
  br i1 %exitcond454.not.i, label %B552.i, label %B360.if.i
B552.i:
  %.2890.pre.i = load i64, ptr %.2062.i, align 8, !noalias !374
  %2 = icmp sgt i64 %.2890.pre.i, 0
  br i1 %2, label %B596.preheader.i, label %b106
B596.preheader.i:
  %.44.i.i.i = getelementptr i8, ptr %job, i64 408
  %.44.i1962.i.i = getelementptr i8, ptr %job, i64 416
  %.1550.i.i = getelementptr i8, ptr %job, i64 144
  %.45.i1974.i.i = getelementptr i8, ptr %job, i64 312
  %.45.i1976.i.i = getelementptr i8, ptr %job, i64 304
  %.2943.i.i = getelementptr i8, ptr %job, i64 8
  %.3597.i.i = getelementptr i8, ptr %job, i64 424
  %.3924.i.i = getelementptr i8, ptr %job, i64 432
  %.4251.i.i = getelementptr i8, ptr %job, i64 448
  %.4578.i.i = getelementptr i8, ptr %job, i64 456
  %.4905.i.i = getelementptr i8, ptr %job, i64 464
  %.5232.i.i = getelementptr i8, ptr %job, i64 472
  %.5559.i.i = getelementptr i8, ptr %job, i64 480
  %.1882.i.i = getelementptr i8, ptr %job, i64 208
  %.fca.1.gep78.i.i.i = getelementptr inbounds i8, ptr %.653.i.i.i, i64 8
  %.44.i312.i.i.i.i = getelementptr i8, ptr %job, i64 536
  %.450.i.i1995.i.i = getelementptr i8, ptr %job, i64 184
  %.777.i.i1997.i.i = getelementptr i8, ptr %job, i64 112
  %.45.i384.i.i1999.i.i = getelementptr i8, ptr %job, i64 272
  %.2573.i.i2006.i.i = getelementptr i8, ptr %job, i64 224
  %.2905.i.i2078.i.i = getelementptr i8, ptr %job, i64 192
  %.3290.i.i2012.i.i = getelementptr i8, ptr %job, i64 280
  %.fca.5.0.2.gep.i.i2018.i.i = getelementptr inbounds i8, ptr %.49.i.i1984.i.i, i64 872
  %.fca.5.0.4.gep.i.i2019.i.i = getelementptr inbounds i8, ptr %.49.i.i1984.i.i, i64 888
  %.44.i.i308.i.i.i = getelementptr i8, ptr %job, i64 440
  %.fca.5.0.2.gep.i.i.i.i = getelementptr inbounds i8, ptr %.49.i.i.i.i, i64 872
  %.fca.5.0.4.gep.i.i.i.i = getelementptr inbounds i8, ptr %.49.i.i.i.i, i64 888
  %.6192.i.i = getelementptr i8, ptr %job, i64 16
  %.8808.i.i = getelementptr i8, ptr %job, i64 488
  %.9135.i.i = getelementptr i8, ptr %job, i64 496
  %.9462.i.i = getelementptr i8, ptr %job, i64 512
  %.9791.i.i = getelementptr i8, ptr %job, i64 32
  %.10118.i.i = getelementptr i8, ptr %job, i64 528
  %.11426.i.i = getelementptr i8, ptr %job, i64 504
  %.341.i2081.i.i = getelementptr i8, ptr %job, i64 352
  %.13226.i.i = getelementptr i8, ptr %job, i64 24
  %.13880.i.i = getelementptr i8, ptr %job, i64 520
  %.fca.1.gep430.i.i.i = getelementptr inbounds i8, ptr %.1009.i.i.i, i64 8
  %.1990.i.i.i = getelementptr i8, ptr %job, i64 56
  %.1795.i.i.i.i = getelementptr i8, ptr %job, i64 200
  %.45.i556.i.i.i = getelementptr i8, ptr %job, i64 360
  %.14992.i.i = getelementptr i8, ptr %job, i64 40
  %.16300.i.i = getelementptr i8, ptr %job, i64 552
  br label %B596.i
B596.i:
  call void @llvm.lifetime.start.p0(ptr nonnull %.16603.i.i), !noalias !374
  store ptr null, ptr %.16603.i.i, align 8, !noalias !383
  %.344.i.i = load i64, ptr %job, align 8, !noalias !383
  %.341.i.i.i = load i64, ptr %.340.i.i, align 8, !noalias !386
  %.342.i.i.i = inttoptr i64 %.341.i.i.i to ptr
  %.45.i.i.i = load i64, ptr %.44.i.i.i, align 8, !noalias !389
  %.46.i.i.i = inttoptr i64 %.45.i.i.i to ptr
  %.45.i1963.i.i = load i64, ptr %.44.i1962.i.i, align 8, !noalias !392
  %.46.i1964.i.i = inttoptr i64 %.45.i1963.i.i to ptr
  %.1551.i.i = load i64, ptr %.1550.i.i, align 8, !noalias !383
  %.1552.i.i = icmp sgt i64 %.1551.i.i, 0
  br i1 %.1552.i.i, label %B266.i.i, label %B224.i.i
B224.i.i:
  %.1883.i.i = load i64, ptr %.1882.i.i, align 8, !noalias !383
  %.1884.i.i = icmp sgt i64 %.1883.i.i, 0
  br label %B266.i.i
B266.i.i:
  %"$phi266.0.2.0.i.i" = phi i1 [ true, %B596.i ], [ %.1884.i.i, %B224.i.i ]
  %.46.i1975.i.i = load i64, ptr %.45.i1974.i.i, align 8, !noalias !395
  %.50.i.i.i = inttoptr i64 %.46.i1975.i.i to ptr
  %.46.i1977.i.i = load i64, ptr %.45.i1976.i.i, align 8, !noalias !398
  %.50.i1978.i.i = inttoptr i64 %.46.i1977.i.i to ptr
  %.2612.i.i = getelementptr i8, ptr %.50.i.i.i, i64 16
  %.2613.i.i = load double, ptr %.2612.i.i, align 8, !noalias !383
  %.2614.i.i = fcmp une double %.2613.i.i, 0.000000e+00
  %.2944.i.i = load i64, ptr %.2943.i.i, align 8, !noalias !383
  %.3598.i.i = load i64, ptr %.3597.i.i, align 8, !noalias !383
  %.3925.i.i = load i64, ptr %.3924.i.i, align 8, !noalias !383
  %.4252.i.i = load i64, ptr %.4251.i.i, align 8, !noalias !383
  %.4579.i.i = load i64, ptr %.4578.i.i, align 8, !noalias !383
  %.4906.i.i = load i64, ptr %.4905.i.i, align 8, !noalias !383
  %.5233.i.i = load i64, ptr %.5232.i.i, align 8, !noalias !383
  %.5560.i.i = load i64, ptr %.5559.i.i, align 8, !noalias !383
  %.5561.i.i = inttoptr i64 %.2944.i.i to ptr
  tail call void %.5561.i.i(i64 %.45.i1963.i.i, i64 %.3598.i.i, i64 %.3925.i.i, i64 %.4252.i.i, i64 %.4579.i.i, i64 %.4906.i.i, i64 %.5233.i.i, i64 %.5560.i.i), !noalias !383
  %.56432157.not.i.i = icmp slt i64 %.344.i.i, 1
  br i1 %.56432157.not.i.i, label %B912.i.i, label %B764.if.lr.ph.i.i
B764.if.lr.ph.i.i:
  %.idx.i1986.i.i = mul i64 %.344.i.i, 88
  %3 = getelementptr i8, ptr %.46.i.i.i, i64 %.idx.i1986.i.i
  %.idx301.i.i.i = mul i64 %.344.i.i, 80
  %4 = getelementptr i8, ptr %.46.i.i.i, i64 %.idx301.i.i.i
  %.idx303.i.i.i = mul i64 %.344.i.i, 56
  %5 = getelementptr i8, ptr %.46.i.i.i, i64 %.idx303.i.i.i
  %6 = getelementptr double, ptr %.46.i1964.i.i, i64 %.344.i.i
  %.idx304.i.i.i = mul i64 %.344.i.i, 72
  %7 = getelementptr i8, ptr %.46.i.i.i, i64 %.idx304.i.i.i
  br label %B764.if.i.i
B806.i.i:
  %.5744.i.i = icmp ne i64 %.5587.02158.i.i, 0
  %or.cond.i.i = and i1 %.2614.i.i, %.5744.i.i
  br i1 %or.cond.i.i, label %B822.i.i, label %B860.i.i
B822.i.i:
  %.112.i.i.i = load double, ptr %6, align 8, !noalias !401
  %.165.i.i.i = load double, ptr %5, align 8, !noalias !401
  %.218.i.i.i = load double, ptr %7, align 8, !noalias !401
  %.272.i.i.i = getelementptr double, ptr %6, i64 %.5587.02158.i.i
  store double %.112.i.i.i, ptr %.272.i.i.i, align 8, !noalias !401
  %.326.i.i.i = getelementptr double, ptr %5, i64 %.5587.02158.i.i
  store double %.165.i.i.i, ptr %.326.i.i.i, align 8, !noalias !401
  %.380.i.i.i = getelementptr double, ptr %7, i64 %.5587.02158.i.i
  store double %.218.i.i.i, ptr %.380.i.i.i, align 8, !noalias !401
  %.341.i.i.i.i = load i64, ptr %.340.i.i, align 8, !noalias !404
  %.342.i.i.i.i = inttoptr i64 %.341.i.i.i.i to ptr
  %.668.i.i.i.i = load i64, ptr %job, align 8, !noalias !404
  %.idx329.i.i.i = mul i64 %.668.i.i.i.i, 24
  %8 = getelementptr i8, ptr %.342.i.i.i.i, i64 %.idx329.i.i.i
  %.484.i.i.i = getelementptr i64, ptr %8, i64 %.5587.02158.i.i
  %.485.i.i.i = load i64, ptr %.484.i.i.i, align 8, !noalias !401
  %.491.not.i.i.i = icmp eq i64 %.485.i.i.i, 0
  br i1 %.491.not.i.i.i, label %B3053.i.i, label %B188.i.i.i
B188.i.i.i:
  %9 = getelementptr i64, ptr %.342.i.i.i.i, i64 %.668.i.i.i.i
  %10 = getelementptr i64, ptr %9, i64 %.5587.02158.i.i
  %.119.i.i.i.i = load i64, ptr %10, align 8, !noalias !407
  %.451.i.i.i.i = load i64, ptr %.450.i.i1995.i.i, align 8, !noalias !407
  %.778.i.i.i.i = load i64, ptr %.777.i.i1997.i.i, align 8, !noalias !407
  %.46.i385.i.i.i.i = load i64, ptr %.45.i384.i.i1999.i.i, align 8, !noalias !410
  %.50.i386.i.i.i.i = inttoptr i64 %.46.i385.i.i.i.i to ptr
  %.2228.i.i.i.i = icmp slt i64 %.119.i.i.i.i, 0
  %.2229.i.i.i.i = select i1 %.2228.i.i.i.i, i64 %.451.i.i.i.i, i64 0
  %11 = getelementptr i64, ptr %.50.i386.i.i.i.i, i64 %.119.i.i.i.i
  %.2243.i.i.i.i = getelementptr i64, ptr %11, i64 %.2229.i.i.i.i
  %.2244.i.i.i.i = load i64, ptr %.2243.i.i.i.i, align 8, !noalias !407
  %.2574.i.i.i.i = load i64, ptr %.2573.i.i2006.i.i, align 8, !noalias !407
  %.2575.i.i.i.i = icmp sgt i64 %.2574.i.i.i.i, 0
  br i1 %.2575.i.i.i.i, label %B432.i.i.i.i, label %b107
B432.i.i.i.i:
  %.2906.i.i.i.i = load i64, ptr %.2905.i.i2078.i.i, align 8, !noalias !407
  %.2908.i.i.i.i = mul nsw i64 %.2906.i.i.i.i, %.5587.02158.i.i
  br label %b107
b107:
  %"$phi476.1.2.0.i.i.i.i" = phi i64 [ %.2908.i.i.i.i, %B432.i.i.i.i ], [ 0, %B188.i.i.i ]
  %.2922.i.i.i.i = add nsw i64 %"$phi476.1.2.0.i.i.i.i", %.2244.i.i.i.i
  %.3291.i.i.i.i = load i64, ptr %.3290.i.i2012.i.i, align 8, !noalias !407
  %.3298.i.i.i.i = mul nsw i64 %.778.i.i.i.i, 56
  %.3299.i.i.i.i = mul nsw i64 %.3298.i.i.i.i, %.2922.i.i.i.i
  %.3300.i.i.i.i = add nsw i64 %.3299.i.i.i.i, %.3291.i.i.i.i
  %.3301.i.i.i.i = inttoptr i64 %.3300.i.i.i.i to ptr
  %.594.i.i.i = getelementptr double, ptr %.46.i1964.i.i, i64 %.5587.02158.i.i
  %.595.i.i.i = load double, ptr %.594.i.i.i, align 8, !noalias !401
  %.650.i.i.i = load double, ptr %.272.i.i.i, align 8, !noalias !401
  call void @llvm.lifetime.start.p0(ptr nonnull %.49.i.i.i.i), !noalias !401
  call fastcc void @v72(ptr %.49.i.i.i.i, ptr nonnull readonly %job, i64 %.5587.02158.i.i)
  %.65.fca.5.0.2.load.i.i.i.i = load i64, ptr %.fca.5.0.2.gep.i.i.i.i, align 8, !noalias !413
  %.65.fca.5.0.4.load.i.i.i.i = load ptr, ptr %.fca.5.0.4.gep.i.i.i.i, align 8, !noalias !413
  %.45.i.i330.i.i.i = load i64, ptr %.44.i.i308.i.i.i, align 8, !noalias !416
  %.46.i.i331.i.i.i = inttoptr i64 %.45.i.i330.i.i.i to ptr
  %.148211.not.i.i.i.i.i = icmp slt i64 %.65.fca.5.0.2.load.i.i.i.i, 1
  %invariant.gep.i.i.i.i = getelementptr double, ptr %.46.i.i331.i.i.i, i64 %.5587.02158.i.i
  br label %B138.if.i.i.i.i
B138.loopexit.i.i.i.i:
  %exitcond443.not.i.i.i.i = icmp eq i64 %.1173.i.i.i.i, 4
  br i1 %exitcond443.not.i.i.i.i, label %b108, label %B138.if.i.i.i.i
B138.if.i.i.i.i:
  %.1104.0442.i.i.i.i = phi i64 [ 0, %b107 ], [ %.1173.i.i.i.i, %B138.loopexit.i.i.i.i ]
  %.1173.i.i.i.i = add nuw nsw i64 %.1104.0442.i.i.i.i, 1
  %12 = getelementptr double, ptr @.const.array.data, i64 %.1104.0442.i.i.i.i
  %.1256.i.i.i.i = load double, ptr %12, align 8, !noalias !413
  %.1261.i.i.i.i = fmul double %.650.i.i.i, %.1256.i.i.i.i
  %.1263.i.i.i.i = fadd double %.595.i.i.i, %.1261.i.i.i.i
  br i1 %.148211.not.i.i.i.i.i, label %B138.loopexit.i.i.i.i, label %B58.if.i.i.i.i.i
B164.i.i.i.i.i:
  %.44.i.i.i.i.i.i = getelementptr i8, ptr %14, i64 24
  %.45.i.i.i.i.i.i = load double, ptr %.44.i.i.i.i.i.i, align 8, !noalias !419
  %.73.i.i.i.i.i.i = getelementptr i8, ptr %14, i64 32
  %.74.i.i.i.i.i.i = load double, ptr %.73.i.i.i.i.i.i, align 8, !noalias !419
  %.75.i.i.i.i.i.i = fmul double %.74.i.i.i.i.i.i, 5.000000e-01
  %.76.i.i.i.i.i.i = fmul double %.245.i.i.i.i.i, %.75.i.i.i.i.i.i
  %.77.i.i.i.i.i.i = fadd double %.45.i.i.i.i.i.i, %.76.i.i.i.i.i.i
  %.78.i.i.i.i.i.i = fmul double %.245.i.i.i.i.i, %.77.i.i.i.i.i.i
  %.87.le.i.i.i.i.i.i = tail call double @llvm.floor.f64(double %.78.i.i.i.i.i.i)
  %.92.i.i.i.i.i.i = fsub double %.78.i.i.i.i.i.i, %.87.le.i.i.i.i.i.i
  %.93.i.i.i.i.i.i = fmul double %.92.i.i.i.i.i.i, 0x401921FB54442D18
  %.121.i.i.i.i.i.i = getelementptr i8, ptr %14, i64 40
  %.122.i.i.i.i.i.i = load double, ptr %.121.i.i.i.i.i.i, align 8, !noalias !419
  %.126.i.i.i.i.i.i = fadd double %.122.i.i.i.i.i.i, %.93.i.i.i.i.i.i
  %.593.le.i.i.i.i.i = tail call double @llvm.sin.f64(double %.126.i.i.i.i.i.i)
  %.598.i.i.i.i.i = fmul double %.423.i.i.i.i.i, %.593.le.i.i.i.i.i
  %.600.i.i.i.i.i = fadd double %.361.i.i.i.i.i, %.598.i.i.i.i.i
  br label %B272.i.i.i.i.i
B272.i.i.i.i.i:
  %value.2.1.i.i.i.i.i = phi double [ %.600.i.i.i.i.i, %B164.i.i.i.i.i ], [ %.361.i.i.i.i.i, %B58.if.i.i.i.i.i ]
  %13 = getelementptr double, ptr %.65.fca.5.0.4.load.i.i.i.i, i64 %.90.0213.i.i.i.i.i
  store double %value.2.1.i.i.i.i.i, ptr %13, align 8, !noalias !424
  %exitcond.not.i.i.i.i.i = icmp eq i64 %.65.fca.5.0.2.load.i.i.i.i, %.161.i.i.i.i.i
  br i1 %exitcond.not.i.i.i.i.i, label %B260.preheader.i.i.i.i, label %B58.if.i.i.i.i.i
B260.preheader.i.i.i.i:
  %.1458.i.i.i.i = mul nuw nsw i64 %.1104.0442.i.i.i.i, %.65.fca.5.0.2.load.i.i.i.i
  br label %B260.if.i.i.i.i
B58.if.i.i.i.i.i:
  %.90.0213.i.i.i.i.i = phi i64 [ %.161.i.i.i.i.i, %B272.i.i.i.i.i ], [ 0, %B138.if.i.i.i.i ]
  %.161.i.i.i.i.i = add nuw nsw i64 %.90.0213.i.i.i.i.i, 1
  %.idx.i.i.i = mul i64 %.90.0213.i.i.i.i.i, 56
  %14 = getelementptr i8, ptr %.3301.i.i.i.i, i64 %.idx.i.i.i
  %.242.i.i.i.i.i = getelementptr i8, ptr %14, i64 48
  %.243.i.i.i.i.i = load double, ptr %.242.i.i.i.i.i, align 8, !noalias !424
  %.245.i.i.i.i.i = fsub double %.1263.i.i.i.i, %.243.i.i.i.i.i
  %.303.i.i.i.i.i = load double, ptr %14, align 8, !noalias !424
  %.357.i.i.i.i.i = getelementptr i8, ptr %14, i64 8
  %.358.i.i.i.i.i = load double, ptr %.357.i.i.i.i.i, align 8, !noalias !424
  %.360.i.i.i.i.i = fmul double %.245.i.i.i.i.i, %.358.i.i.i.i.i
  %.361.i.i.i.i.i = fadd double %.303.i.i.i.i.i, %.360.i.i.i.i.i
  %.422.i.i.i.i.i = getelementptr i8, ptr %14, i64 16
  %.423.i.i.i.i.i = load double, ptr %.422.i.i.i.i.i, align 8, !noalias !424
  %.424.i.i.i.i.i = fcmp une double %.423.i.i.i.i.i, 0.000000e+00
  br i1 %.424.i.i.i.i.i, label %B164.i.i.i.i.i, label %B272.i.i.i.i.i
B260.if.i.i.i.i:
  %.1326.0437.i.i.i.i = phi i64 [ 0, %B260.preheader.i.i.i.i ], [ %.1395.i.i.i.i, %B260.if.i.i.i.i ]
  %.1395.i.i.i.i = add nuw nsw i64 %.1326.0437.i.i.i.i, 1
  %15 = getelementptr double, ptr %.65.fca.5.0.4.load.i.i.i.i, i64 %.1326.0437.i.i.i.i
  %.1449.i.i.i.i = load double, ptr %15, align 8, !noalias !413
  %.1459.i.i.i.i = add nuw nsw i64 %.1326.0437.i.i.i.i, %.1458.i.i.i.i
  %.1507.i.i.i.i = mul i64 %.1459.i.i.i.i, %.668.i.i.i.i
  %gep440.i.i.i.i = getelementptr double, ptr %invariant.gep.i.i.i.i, i64 %.1507.i.i.i.i
  store double %.1449.i.i.i.i, ptr %gep440.i.i.i.i, align 8, !noalias !413
  %exitcond.not.i.i.i.i = icmp eq i64 %.1395.i.i.i.i, %.65.fca.5.0.2.load.i.i.i.i
  br i1 %exitcond.not.i.i.i.i, label %B138.loopexit.i.i.i.i, label %B260.if.i.i.i.i
b108:
  call void @llvm.lifetime.end.p0(ptr nonnull %.49.i.i.i.i), !noalias !401
  br label %B3053.i.i
B860.i.i:
  %.5818.i.i = load double, ptr %.50.i.i.i, align 8, !noalias !383
  call void @llvm.lifetime.start.p0(ptr nonnull %.653.i.i.i), !noalias !383
  %.117.i.i.i = getelementptr double, ptr %.46.i1964.i.i, i64 %.5587.02158.i.i
  %.118.i.i.i = load double, ptr %.117.i.i.i, align 8, !noalias !425
  %.172.i.i.i = getelementptr double, ptr %3, i64 %.5587.02158.i.i
  %.173.i.i.i = load double, ptr %.172.i.i.i, align 8, !noalias !425
  %.185.i.i.i = fcmp ugt double %.173.i.i.i, 0.000000e+00
  br i1 %.185.i.i.i, label %B100.i.i.i, label %B66.i.i.i
B66.i.i.i:
  %.45.i.i.i.i.i = load i64, ptr %.4905.i.i, align 8, !noalias !428
  %.46.i.i.i.i.i = inttoptr i64 %.45.i.i.i.i.i to ptr
  %.372.i.i.i.i.i = load i64, ptr %job, align 8, !noalias !428
  %.45.i301.i.i.i.i = load i64, ptr %.3597.i.i, align 8, !noalias !433
  %.46.i302.i.i.i.i = inttoptr i64 %.45.i301.i.i.i.i to ptr
  %.45.i313.i.i.i.i = load i64, ptr %.44.i312.i.i.i.i, align 8, !noalias !436
  %.46.i314.i.i.i.i = inttoptr i64 %.45.i313.i.i.i.i to ptr
  %.45.i325.i.i.i.i = load i64, ptr %.44.i.i.i, align 8, !noalias !439
  %.46.i326.i.i.i.i = inttoptr i64 %.45.i325.i.i.i.i to ptr
  %.idx.i.i.i.i = mul i64 %.372.i.i.i.i.i, 80
  %16 = getelementptr i8, ptr %.46.i326.i.i.i.i, i64 %.idx.i.i.i.i
  %17 = getelementptr double, ptr %16, i64 %.5587.02158.i.i
  %.1477.i.i.i.i = load double, ptr %17, align 8, !noalias !442
  %.45.i337.i.i.i.i = load i64, ptr %.44.i1962.i.i, align 8, !noalias !443
  %.46.i338.i.i.i.i = inttoptr i64 %.45.i337.i.i.i.i to ptr
  %18 = getelementptr double, ptr %.46.i338.i.i.i.i, i64 %.5587.02158.i.i
  %.1875.i.i.i.i = load double, ptr %18, align 8, !noalias !442
  %.1881.i.i.i.i = fsub double %.1477.i.i.i.i, %.1875.i.i.i.i
  %.1885.i.i.i.i = fdiv double 2.000000e+01, %.1881.i.i.i.i
  %.2214.i.i.i.i = load i64, ptr %.1000.i, align 8, !noalias !442
  %invariant.gep.i.i1988.i.i = getelementptr double, ptr %.46.i.i.i.i.i, i64 %.5587.02158.i.i
  %invariant.gep352.i.i.i.i = getelementptr double, ptr %.46.i302.i.i.i.i, i64 %.5587.02158.i.i
  %invariant.gep355.i.i.i.i = getelementptr double, ptr %.46.i314.i.i.i.i, i64 %.5587.02158.i.i
  %.2297358.not.i.i.i.i = icmp slt i64 %.2214.i.i.i.i, 1
  br i1 %.2297358.not.i.i.i.i, label %B532.i.i.i.i, label %B376.if.i.i.i.i
B532.i.i.i.i:
  %fastest.2.0.lcssa.i.i.i.i = phi double [ %.1885.i.i.i.i, %B66.i.i.i ], [ %.13.i349.i.i.i.i, %B376.if.i.i.i.i ]
  %.2568.i.i.i.i = fcmp olt double %.173.i.i.i, 0.000000e+00
  br i1 %.2568.i.i.i.i, label %B544.i.i.i.i, label %B584.i.i.i.i
B544.i.i.i.i:
  %.2571.i.i.i.i = fneg double %.173.i.i.i
  %.2578.i.i.i.i = fdiv double 1.000000e+00, %fastest.2.0.lcssa.i.i.i.i
  %.12.i.i.i.i.i = fcmp olt double %.2578.i.i.i.i, %.2571.i.i.i.i
  %.13.i.i.i.i.i = select i1 %.12.i.i.i.i.i, double %.2578.i.i.i.i, double %.2571.i.i.i.i
  br label %B100.i.i.i
B584.i.i.i.i:
  %.2619.i.i.i.i = fdiv double 1.000000e+00, %fastest.2.0.lcssa.i.i.i.i
  br label %B100.i.i.i
B376.if.i.i.i.i:
  %fastest.2.0361.i.i.i.i = phi double [ %.13.i349.i.i.i.i, %B376.if.i.i.i.i ], [ %.1885.i.i.i.i, %B66.i.i.i ]
  %.2241.0360.i.i.i.i = phi i64 [ %.2310.i.i.i.i, %B376.if.i.i.i.i ], [ 0, %B66.i.i.i ]
  %.2310.i.i.i.i = add nuw nsw i64 %.2241.0360.i.i.i.i, 1
  %.2382.i.i.i.i = mul i64 %.2241.0360.i.i.i.i, %.372.i.i.i.i.i
  %gep351.i.i.i.i = getelementptr double, ptr %invariant.gep.i.i1988.i.i, i64 %.2382.i.i.i.i
  %.2387.i.i.i.i = load double, ptr %gep351.i.i.i.i, align 8, !noalias !442
  %.2390.i.i.i.i = tail call double @llvm.fabs.f64(double %.2387.i.i.i.i)
  %.2391.i.i.i.i = fmul double %.2390.i.i.i.i, 2.000000e+01
  %gep354.i.i.i.i = getelementptr double, ptr %invariant.gep352.i.i.i.i, i64 %.2382.i.i.i.i
  %.2444.i.i.i.i = load double, ptr %gep354.i.i.i.i, align 8, !noalias !442
  %.2447.i.i.i.i = tail call double @llvm.fabs.f64(double %.2444.i.i.i.i)
  %gep357.i.i.i.i = getelementptr double, ptr %invariant.gep355.i.i.i.i, i64 %.2382.i.i.i.i
  %.2500.i.i.i.i = load double, ptr %gep357.i.i.i.i, align 8, !noalias !442
  %.2503.i.i.i.i = fadd double %.2447.i.i.i.i, %.2500.i.i.i.i
  %.2507.i.i.i.i = fdiv double %.2391.i.i.i.i, %.2503.i.i.i.i
  %.12.i348.i.i.i.i = fcmp ogt double %.2507.i.i.i.i, %fastest.2.0361.i.i.i.i
  %.13.i349.i.i.i.i = select i1 %.12.i348.i.i.i.i, double %.2507.i.i.i.i, double %fastest.2.0361.i.i.i.i
  %exitcond.not.i.i1989.i.i = icmp eq i64 %.2214.i.i.i.i, %.2310.i.i.i.i
  br i1 %exitcond.not.i.i1989.i.i, label %B532.i.i.i.i, label %B376.if.i.i.i.i
B100.i.i.i:
  %h.3.0.i.i.i = phi double [ %.173.i.i.i, %B860.i.i ], [ %.13.i.i.i.i.i, %B544.i.i.i.i ], [ %.2619.i.i.i.i, %B584.i.i.i.i ]
  %.12.i.i.i.i = fcmp olt double %.5818.i.i, %h.3.0.i.i.i
  %.13.i.i.i.i = select i1 %.12.i.i.i.i, double %.5818.i.i, double %h.3.0.i.i.i
  %.311.i.i.i = getelementptr double, ptr %4, i64 %.5587.02158.i.i
  %.312.i.i.i = load double, ptr %.311.i.i.i, align 8, !noalias !425
  %.645.i.i.i = load i64, ptr %.1550.i.i, align 8, !noalias !425
  %.646.i.i.i = icmp sgt i64 %.645.i.i.i, 0
  br i1 %.646.i.i.i, label %B206.i.i.i, label %B248.i.i.i
B206.i.i.i:
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %.653.i.i.i, i8 0, i64 16, i1 false), !noalias !425
  call fastcc void @v82(ptr %.653.i.i.i, ptr nonnull readonly %job, i64 %.5587.02158.i.i, double %.118.i.i.i, double %h.3.0.i.i.i)
  %.669.fca.1.load.i.i.i = load double, ptr %.fca.1.gep78.i.i.i, align 8, !noalias !425
  %wanted.2.0.in.sroa.speculate.load.B206.i.i.i = load double, ptr %.653.i.i.i, align 8, !noalias !425
  br label %B248.i.i.i
B248.i.i.i:
  %latest.2.0.i.i.i = phi double [ %.669.fca.1.load.i.i.i, %B206.i.i.i ], [ %.312.i.i.i, %B100.i.i.i ]
  %wanted.2.0.in.sroa.speculated.i.i.i = phi double [ %wanted.2.0.in.sroa.speculate.load.B206.i.i.i, %B206.i.i.i ], [ %.13.i.i.i.i, %B100.i.i.i ]
  %.698.i.i.i = fsub double %latest.2.0.i.i.i, %.118.i.i.i
  %.11.i.i.i.i = fmul double %.698.i.i.i, 5.000000e-01
  %.13.i305.i.i.i = fcmp olt double %wanted.2.0.in.sroa.speculated.i.i.i, %.11.i.i.i.i
  %.24.i.i.i.i = fcmp olt double %wanted.2.0.in.sroa.speculated.i.i.i, %.698.i.i.i
  %.11.arg.remaining.i.i.i.i = select i1 %.24.i.i.i.i, double %.11.i.i.i.i, double %.698.i.i.i
  %storemerge.i.i.i.i = select i1 %.13.i305.i.i.i, double %wanted.2.0.in.sroa.speculated.i.i.i, double %.11.arg.remaining.i.i.i.i
  %.341.i.i1991.i.i = load i64, ptr %.340.i.i, align 8, !noalias !446
  %.342.i.i1992.i.i = inttoptr i64 %.341.i.i1991.i.i to ptr
  %.668.i.i1993.i.i = load i64, ptr %job, align 8, !noalias !446
  %.idx302.i.i.i = mul i64 %.668.i.i1993.i.i, 24
  %19 = getelementptr i8, ptr %.342.i.i1992.i.i, i64 %.idx302.i.i.i
  %20 = getelementptr i64, ptr %19, i64 %.5587.02158.i.i
  %.823.i.i.i = load i64, ptr %20, align 8, !noalias !425
  %.829.not.i.i.i = icmp eq i64 %.823.i.i.i, 0
  br i1 %.829.not.i.i.i, label %b109, label %B352.i.i.i
B352.i.i.i:
  %21 = getelementptr i64, ptr %.342.i.i1992.i.i, i64 %.668.i.i1993.i.i
  %22 = getelementptr i64, ptr %21, i64 %.5587.02158.i.i
  %.119.i.i1994.i.i = load i64, ptr %22, align 8, !noalias !449
  %.451.i.i1996.i.i = load i64, ptr %.450.i.i1995.i.i, align 8, !noalias !449
  %.778.i.i1998.i.i = load i64, ptr %.777.i.i1997.i.i, align 8, !noalias !449
  %.46.i385.i.i2000.i.i = load i64, ptr %.45.i384.i.i1999.i.i, align 8, !noalias !452
  %.50.i386.i.i2001.i.i = inttoptr i64 %.46.i385.i.i2000.i.i to ptr
  %.2228.i.i2002.i.i = icmp slt i64 %.119.i.i1994.i.i, 0
  %.2229.i.i2003.i.i = select i1 %.2228.i.i2002.i.i, i64 %.451.i.i1996.i.i, i64 0
  %23 = getelementptr i64, ptr %.50.i386.i.i2001.i.i, i64 %.119.i.i1994.i.i
  %.2243.i.i2004.i.i = getelementptr i64, ptr %23, i64 %.2229.i.i2003.i.i
  %.2244.i.i2005.i.i = load i64, ptr %.2243.i.i2004.i.i, align 8, !noalias !449
  %.2574.i.i2007.i.i = load i64, ptr %.2573.i.i2006.i.i, align 8, !noalias !449
  %.2575.i.i2008.i.i = icmp sgt i64 %.2574.i.i2007.i.i, 0
  br i1 %.2575.i.i2008.i.i, label %B432.i.i2077.i.i, label %b110
B432.i.i2077.i.i:
  %.2906.i.i2079.i.i = load i64, ptr %.2905.i.i2078.i.i, align 8, !noalias !449
  %.2908.i.i2080.i.i = mul nsw i64 %.2906.i.i2079.i.i, %.5587.02158.i.i
  br label %b110
b110:
  %"$phi476.1.2.0.i.i2010.i.i" = phi i64 [ %.2908.i.i2080.i.i, %B432.i.i2077.i.i ], [ 0, %B352.i.i.i ]
  %.2922.i.i2011.i.i = add nsw i64 %"$phi476.1.2.0.i.i2010.i.i", %.2244.i.i2005.i.i
  %.3291.i.i2013.i.i = load i64, ptr %.3290.i.i2012.i.i, align 8, !noalias !449
  %.3298.i.i2014.i.i = mul nsw i64 %.778.i.i1998.i.i, 56
  %.3299.i.i2015.i.i = mul nsw i64 %.3298.i.i2014.i.i, %.2922.i.i2011.i.i
  %.3300.i.i2016.i.i = add nsw i64 %.3299.i.i2015.i.i, %.3291.i.i2013.i.i
  %.3301.i.i2017.i.i = inttoptr i64 %.3300.i.i2016.i.i to ptr
  call void @llvm.lifetime.start.p0(ptr nonnull %.49.i.i1984.i.i), !noalias !425
  call fastcc void @v72(ptr %.49.i.i1984.i.i, ptr nonnull readonly %job, i64 %.5587.02158.i.i)
  %.65.fca.5.0.2.load.i.i2021.i.i = load i64, ptr %.fca.5.0.2.gep.i.i2018.i.i, align 8, !noalias !455
  %.65.fca.5.0.4.load.i.i2022.i.i = load ptr, ptr %.fca.5.0.4.gep.i.i2019.i.i, align 8, !noalias !455
  %.45.i.i309.i.i.i = load i64, ptr %.44.i.i308.i.i.i, align 8, !noalias !458
  %.46.i.i310.i.i.i = inttoptr i64 %.45.i.i309.i.i.i to ptr
  %.148211.not.i.i.i2023.i.i = icmp slt i64 %.65.fca.5.0.2.load.i.i2021.i.i, 1
  %invariant.gep.i312.i.i.i = getelementptr double, ptr %.46.i.i310.i.i.i, i64 %.5587.02158.i.i
  br label %B138.if.i.i2024.i.i
B138.loopexit.i.i2056.i.i:
  %exitcond443.not.i.i2057.i.i = icmp eq i64 %.1173.i.i2026.i.i, 4
  br i1 %exitcond443.not.i.i2057.i.i, label %b111, label %B138.if.i.i2024.i.i
B138.if.i.i2024.i.i:
  %.1104.0442.i.i2025.i.i = phi i64 [ 0, %b110 ], [ %.1173.i.i2026.i.i, %B138.loopexit.i.i2056.i.i ]
  %.1173.i.i2026.i.i = add nuw nsw i64 %.1104.0442.i.i2025.i.i, 1
  %24 = getelementptr double, ptr @.const.array.data, i64 %.1104.0442.i.i2025.i.i
  %.1256.i.i2027.i.i = load double, ptr %24, align 8, !noalias !455
  %.1261.i.i2028.i.i = fmul double %storemerge.i.i.i.i, %.1256.i.i2027.i.i
  %.1263.i.i2029.i.i = fadd double %.118.i.i.i, %.1261.i.i2028.i.i
  br i1 %.148211.not.i.i.i2023.i.i, label %B138.loopexit.i.i2056.i.i, label %B58.if.i.i.i2030.i.i
B164.i.i.i2059.i.i:
  %.44.i.i.i.i2060.i.i = getelementptr i8, ptr %26, i64 24
  %.45.i.i.i.i2061.i.i = load double, ptr %.44.i.i.i.i2060.i.i, align 8, !noalias !461
  %.73.i.i.i.i2062.i.i = getelementptr i8, ptr %26, i64 32
  %.74.i.i.i.i2063.i.i = load double, ptr %.73.i.i.i.i2062.i.i, align 8, !noalias !461
  %.75.i.i.i.i2064.i.i = fmul double %.74.i.i.i.i2063.i.i, 5.000000e-01
  %.76.i.i.i.i2065.i.i = fmul double %.245.i.i.i2035.i.i, %.75.i.i.i.i2064.i.i
  %.77.i.i.i.i2066.i.i = fadd double %.45.i.i.i.i2061.i.i, %.76.i.i.i.i2065.i.i
  %.78.i.i.i.i2067.i.i = fmul double %.245.i.i.i2035.i.i, %.77.i.i.i.i2066.i.i
  %.87.le.i.i.i.i2068.i.i = tail call double @llvm.floor.f64(double %.78.i.i.i.i2067.i.i)
  %.92.i.i.i.i2069.i.i = fsub double %.78.i.i.i.i2067.i.i, %.87.le.i.i.i.i2068.i.i
  %.93.i.i.i.i2070.i.i = fmul double %.92.i.i.i.i2069.i.i, 0x401921FB54442D18
  %.121.i.i.i.i2071.i.i = getelementptr i8, ptr %26, i64 40
  %.122.i.i.i.i2072.i.i = load double, ptr %.121.i.i.i.i2071.i.i, align 8, !noalias !461
  %.126.i.i.i.i2073.i.i = fadd double %.122.i.i.i.i2072.i.i, %.93.i.i.i.i2070.i.i
  %.593.le.i.i.i2074.i.i = tail call double @llvm.sin.f64(double %.126.i.i.i.i2073.i.i)
  %.598.i.i.i2075.i.i = fmul double %.423.i.i.i2042.i.i, %.593.le.i.i.i2074.i.i
  %.600.i.i.i2076.i.i = fadd double %.361.i.i.i2040.i.i, %.598.i.i.i2075.i.i
  br label %B272.i.i.i2044.i.i
B272.i.i.i2044.i.i:
  %value.2.1.i.i.i2045.i.i = phi double [ %.600.i.i.i2076.i.i, %B164.i.i.i2059.i.i ], [ %.361.i.i.i2040.i.i, %B58.if.i.i.i2030.i.i ]
  %25 = getelementptr double, ptr %.65.fca.5.0.4.load.i.i2022.i.i, i64 %.90.0213.i.i.i2031.i.i
  store double %value.2.1.i.i.i2045.i.i, ptr %25, align 8, !noalias !466
  %exitcond.not.i.i.i2046.i.i = icmp eq i64 %.65.fca.5.0.2.load.i.i2021.i.i, %.161.i.i.i2032.i.i
  br i1 %exitcond.not.i.i.i2046.i.i, label %B260.preheader.i.i2047.i.i, label %B58.if.i.i.i2030.i.i
B260.preheader.i.i2047.i.i:
  %.1458.i.i2048.i.i = mul nuw nsw i64 %.1104.0442.i.i2025.i.i, %.65.fca.5.0.2.load.i.i2021.i.i
  br label %B260.if.i.i2049.i.i
B58.if.i.i.i2030.i.i:
  %.90.0213.i.i.i2031.i.i = phi i64 [ %.161.i.i.i2032.i.i, %B272.i.i.i2044.i.i ], [ 0, %B138.if.i.i2024.i.i ]
  %.161.i.i.i2032.i.i = add nuw nsw i64 %.90.0213.i.i.i2031.i.i, 1
  %.idx314.i.i.i = mul i64 %.90.0213.i.i.i2031.i.i, 56
  %26 = getelementptr i8, ptr %.3301.i.i2017.i.i, i64 %.idx314.i.i.i
  %.242.i.i.i2033.i.i = getelementptr i8, ptr %26, i64 48
  %.243.i.i.i2034.i.i = load double, ptr %.242.i.i.i2033.i.i, align 8, !noalias !466
  %.245.i.i.i2035.i.i = fsub double %.1263.i.i2029.i.i, %.243.i.i.i2034.i.i
  %.303.i.i.i2036.i.i = load double, ptr %26, align 8, !noalias !466
  %.357.i.i.i2037.i.i = getelementptr i8, ptr %26, i64 8
  %.358.i.i.i2038.i.i = load double, ptr %.357.i.i.i2037.i.i, align 8, !noalias !466
  %.360.i.i.i2039.i.i = fmul double %.245.i.i.i2035.i.i, %.358.i.i.i2038.i.i
  %.361.i.i.i2040.i.i = fadd double %.303.i.i.i2036.i.i, %.360.i.i.i2039.i.i
  %.422.i.i.i2041.i.i = getelementptr i8, ptr %26, i64 16
  %.423.i.i.i2042.i.i = load double, ptr %.422.i.i.i2041.i.i, align 8, !noalias !466
  %.424.i.i.i2043.i.i = fcmp une double %.423.i.i.i2042.i.i, 0.000000e+00
  br i1 %.424.i.i.i2043.i.i, label %B164.i.i.i2059.i.i, label %B272.i.i.i2044.i.i
B260.if.i.i2049.i.i:
  %.1326.0437.i.i2050.i.i = phi i64 [ 0, %B260.preheader.i.i2047.i.i ], [ %.1395.i.i2051.i.i, %B260.if.i.i2049.i.i ]
  %.1395.i.i2051.i.i = add nuw nsw i64 %.1326.0437.i.i2050.i.i, 1
  %27 = getelementptr double, ptr %.65.fca.5.0.4.load.i.i2022.i.i, i64 %.1326.0437.i.i2050.i.i
  %.1449.i.i2052.i.i = load double, ptr %27, align 8, !noalias !455
  %.1459.i.i2053.i.i = add nuw nsw i64 %.1326.0437.i.i2050.i.i, %.1458.i.i2048.i.i
  %.1507.i.i2054.i.i = mul i64 %.1459.i.i2053.i.i, %.668.i.i1993.i.i
  %gep440.i.i2055.i.i = getelementptr double, ptr %invariant.gep.i312.i.i.i, i64 %.1507.i.i2054.i.i
  store double %.1449.i.i2052.i.i, ptr %gep440.i.i2055.i.i, align 8, !noalias !455
  %exitcond.not.i313.i.i.i = icmp eq i64 %.1395.i.i2051.i.i, %.65.fca.5.0.2.load.i.i2021.i.i
  br i1 %exitcond.not.i313.i.i.i, label %B138.loopexit.i.i2056.i.i, label %B260.if.i.i2049.i.i
b111:
  call void @llvm.lifetime.end.p0(ptr nonnull %.49.i.i1984.i.i), !noalias !425
  br label %b109
b109:
  %.983.i.i.i = getelementptr double, ptr %5, i64 %.5587.02158.i.i
  store double %wanted.2.0.in.sroa.speculated.i.i.i, ptr %.983.i.i.i, align 8, !noalias !425
  %.1041.i.i.i = getelementptr double, ptr %6, i64 %.5587.02158.i.i
  store double %storemerge.i.i.i.i, ptr %.1041.i.i.i, align 8, !noalias !425
  %.1053.i.i.i = fmul double %.698.i.i.i, 0x3FEFFFFFFFFFDCD1
  %.1055.i.i.i = fcmp ult double %storemerge.i.i.i.i, %.1053.i.i.i
  %.1072.i.i.i = fadd double %.118.i.i.i, %storemerge.i.i.i.i
  %"$phi494.0.2.0.i.i.i" = select i1 %.1055.i.i.i, double %.1072.i.i.i, double %latest.2.0.i.i.i
  %.1136.i.i.i = getelementptr double, ptr %7, i64 %.5587.02158.i.i
  store double %"$phi494.0.2.0.i.i.i", ptr %.1136.i.i.i, align 8, !noalias !425
  call void @llvm.lifetime.end.p0(ptr nonnull %.653.i.i.i), !noalias !383
  br label %B3053.i.i
B912.i.i:
  %.6193.i.i = load i64, ptr %.6192.i.i, align 8, !noalias !383
  %.6520.i.i = load i64, ptr %.44.i1962.i.i, align 8, !noalias !383
  %.6847.i.i = load i64, ptr %.3597.i.i, align 8, !noalias !383
  %.7174.i.i = load i64, ptr %.44.i.i308.i.i.i, align 8, !noalias !383
  %.7501.i.i = load i64, ptr %.4578.i.i, align 8, !noalias !383
  %.7828.i.i = load i64, ptr %.4905.i.i, align 8, !noalias !383
  %.8155.i.i = load i64, ptr %.5232.i.i, align 8, !noalias !383
  %.8482.i.i = load i64, ptr %.5559.i.i, align 8, !noalias !383
  %.8809.i.i = load i64, ptr %.8808.i.i, align 8, !noalias !383
  %.9136.i.i = load i64, ptr %.9135.i.i, align 8, !noalias !383
  %.9463.i.i = load i64, ptr %.9462.i.i, align 8, !noalias !383
  %.9464.i.i = inttoptr i64 %.6193.i.i to ptr
  tail call void %.9464.i.i(i64 %.6520.i.i, i64 %.6847.i.i, i64 %.7174.i.i, i64 %.7501.i.i, i64 %.7828.i.i, i64 %.8155.i.i, i64 %.8482.i.i, i64 %.8809.i.i, i64 %.9136.i.i, i64 %.9463.i.i), !noalias !383
  %.9792.i.i = load i64, ptr %.9791.i.i, align 8, !noalias !383
  %.10119.i.i = load i64, ptr %.10118.i.i, align 8, !noalias !383
  %.10446.i.i = load i64, ptr %.44.i.i, align 8, !noalias !383
  %.10773.i.i = load i64, ptr %.3597.i.i, align 8, !noalias !383
  %.11100.i.i = load i64, ptr %.9462.i.i, align 8, !noalias !383
  %.11427.i.i = load i64, ptr %.11426.i.i, align 8, !noalias !383
  %.11754.i.i = load i64, ptr %.44.i1962.i.i, align 8, !noalias !383
  %.12081.i.i = load i64, ptr %.44.i.i.i, align 8, !noalias !383
  %.12082.i.i = inttoptr i64 %.9792.i.i to ptr
  tail call void %.12082.i.i(i64 %.10119.i.i, i64 %.10446.i.i, i64 %.10773.i.i, i64 %.11100.i.i, i64 %.11427.i.i, i64 %.11754.i.i, i64 %.12081.i.i), !noalias !383
  %.12123.i.i = add i64 %.344.i.i, -1
  %.121662160.not.i.i = icmp sgt i64 %.12123.i.i, 0
  %or.cond2182.not.i.i = select i1 %.2614.i.i, i1 %.121662160.not.i.i, i1 false
  br i1 %or.cond2182.not.i.i, label %B1650.if.lr.ph.i.i, label %B1768.i.i
B1650.if.lr.ph.i.i:
  %.12316.idx.i.i = mul i64 %.344.i.i, 48
  %.12316.i.i = getelementptr i8, ptr %.46.i.i.i, i64 %.12316.idx.i.i
  br label %B1650.if.i.i
B1712.i.i:
  %.12317.i.i = load double, ptr %.12316.i.i, align 8, !noalias !383
  br label %B1744.i.i
B1744.i.i:
  %"$phi1744.1.2.1.i.i" = phi double [ %.12317.i.i, %B1712.i.i ], [ 0.000000e+00, %B1650.if.i.i ]
  %.12381.i.i = getelementptr double, ptr %.12316.i.i, i64 %.12110.02161.i.i
  store double %"$phi1744.1.2.1.i.i", ptr %.12381.i.i, align 8, !noalias !383
  %exitcond2178.not.i.i = icmp eq i64 %.12179.i.i, %.344.i.i
  br i1 %exitcond2178.not.i.i, label %B1768.i.i, label %B1650.if.i.i
B1768.i.i:
  br i1 %.56432157.not.i.i, label %common.ret.critedge.i.i, label %B1802.if.lr.ph.i.i
B1802.if.lr.ph.i.i:
  %.idx1951.i.i = mul i64 %.344.i.i, 48
  %28 = getelementptr i8, ptr %.46.i.i.i, i64 %.idx1951.i.i
  %.idx1952.i.i = mul i64 %.344.i.i, 72
  %29 = getelementptr i8, ptr %.46.i.i.i, i64 %.idx1952.i.i
  br label %B1802.if.i.i
B1844.i.i:
  %.12631.i.i = getelementptr double, ptr %28, i64 %.12417.02164.i.i
  %.12632.i.i = load double, ptr %.12631.i.i, align 8, !noalias !383
  %.12633.i.i = fcmp une double %.12632.i.i, 0.000000e+00
  br i1 %.12633.i.i, label %B1882.i.i, label %B2018.i.i
B1882.i.i:
  br i1 %"$phi266.0.2.0.i.i", label %B2012.i.i, label %B1888.i.i
B1888.i.i:
  %.342.i2082.i.i = load i64, ptr %.341.i2081.i.i, align 8, !noalias !467
  %.346.i.i.i = mul nuw nsw i64 %.12572.i.i, 48
  %.347.i.i.i = add nsw i64 %.342.i2082.i.i, %.346.i.i.i
  %.348.i.i.i = inttoptr i64 %.347.i.i.i to ptr
  %.12770.i.i = getelementptr i8, ptr %.348.i.i.i, i64 16
  %.12771.i.i = load i64, ptr %.12770.i.i, align 8, !noalias !383
  %.12771.lobit.i.i = lshr i64 %.12771.i.i, 63
  %30 = getelementptr double, ptr %.50.i1978.i.i, i64 %.12771.i.i
  %.12803.i.i = getelementptr double, ptr %30, i64 %.12771.lobit.i.i
  %.12804.i.i = load double, ptr %.12803.i.i, align 8, !noalias !383
  %.12860.i.i = getelementptr double, ptr %29, i64 %.12417.02164.i.i
  %.12861.i.i = load double, ptr %.12860.i.i, align 8, !noalias !383
  %.12862.i.i = fcmp olt double %.12804.i.i, %.12861.i.i
  br label %B2012.i.i
B2012.i.i:
  %"$phi2012.2.2.2.i.i" = phi i1 [ true, %B1882.i.i ], [ %.12862.i.i, %B1888.i.i ]
  %.12870.i.i = or i1 %wants_dense.2.02166.i.i, %"$phi2012.2.2.2.i.i"
  br label %B2018.i.i
B2018.i.i:
  %wants_dense.3.1.i.i = phi i1 [ %.12870.i.i, %B2012.i.i ], [ %wants_dense.2.02166.i.i, %B1844.i.i ], [ %wants_dense.2.02166.i.i, %B1802.if.i.i ]
  %exitcond2179.not.i.i = icmp eq i64 %.344.i.i, %.12486.i.i
  br i1 %exitcond2179.not.i.i, label %B2020.i.i, label %B1802.if.i.i
B2020.i.i:
  br i1 %wants_dense.3.1.i.i, label %B2024.i.i, label %B2154.i.i
B2024.i.i:
  %.13227.i.i = load i64, ptr %.13226.i.i, align 8, !noalias !383
  %.13554.i.i = load i64, ptr %.9135.i.i, align 8, !noalias !383
  %.13881.i.i = load i64, ptr %.13880.i.i, align 8, !noalias !383
  %.13882.i.i = inttoptr i64 %.13227.i.i to ptr
  tail call void %.13882.i.i(i64 %.13554.i.i, i64 %.13881.i.i), !noalias !383
  br label %B2154.i.i
B2154.i.i:
  %31 = getelementptr double, ptr %.46.i1964.i.i, i64 %.344.i.i
  %.idx.i2138.i.i = shl i64 %.344.i.i, 4
  %32 = getelementptr i8, ptr %.46.i.i.i, i64 %.idx.i2138.i.i
  %.idx87.i.i.i = mul i64 %.344.i.i, 88
  %33 = getelementptr i8, ptr %.46.i.i.i, i64 %.idx87.i.i.i
  %34 = getelementptr i8, ptr %.342.i.i.i, i64 %.idx.i2138.i.i
  %.idx932.i.i.i = mul i64 %.344.i.i, 120
  %35 = getelementptr i8, ptr %.46.i.i.i, i64 %.idx932.i.i.i
  %.idx933.i.i.i = mul i64 %.344.i.i, 24
  %36 = getelementptr i8, ptr %.342.i.i.i, i64 %.idx933.i.i.i
  %37 = getelementptr double, ptr %.46.i.i.i, i64 %.344.i.i
  %.idx934.i.i.i = mul i64 %.344.i.i, 56
  %38 = getelementptr i8, ptr %.46.i.i.i, i64 %.idx934.i.i.i
  %39 = getelementptr i8, ptr %.46.i.i.i, i64 %.idx933.i.i.i
  %.idx936.i.i.i = mul i64 %.344.i.i, 40
  %40 = getelementptr i8, ptr %.46.i.i.i, i64 %.idx936.i.i.i
  %.idx937.i.i.i = shl i64 %.344.i.i, 5
  %41 = getelementptr i8, ptr %.46.i.i.i, i64 %.idx937.i.i.i
  %42 = getelementptr i8, ptr %.342.i.i.i, i64 %.idx937.i.i.i
  %.idx939.i.i.i = mul i64 %.344.i.i, 104
  %43 = getelementptr i8, ptr %.46.i.i.i, i64 %.idx939.i.i.i
  %.idx942.i.i.i = mul i64 %.344.i.i, 80
  %44 = getelementptr i8, ptr %.46.i.i.i, i64 %.idx942.i.i.i
  %.idx944.i.i.i = mul i64 %.344.i.i, 96
  %45 = getelementptr i8, ptr %.46.i.i.i, i64 %.idx944.i.i.i
  %.14489.i.i = getelementptr i8, ptr %.50.i.i.i, i64 8
  %.99.i.i.i = getelementptr i8, ptr %.342.i.i.i, i64 %.idx1951.i.i
  br label %B2188.if.i.i
B2234.i.i:
  %.342.i2089.i.i = load i64, ptr %.341.i2081.i.i, align 8, !noalias !470
  %.346.i2090.i.i = mul nuw nsw i64 %.14067.i.i, 48
  %.347.i2091.i.i = add nsw i64 %.342.i2089.i.i, %.346.i2090.i.i
  %.348.i2092.i.i = inttoptr i64 %.347.i2091.i.i to ptr
  %.14150.i.i = getelementptr i8, ptr %.348.i2092.i.i, i64 8
  %.14151.i.i = load i64, ptr %.14150.i.i, align 8, !noalias !383
  %.14152.i.i = add nsw i64 %.14151.i.i, 1
  store i64 %.14152.i.i, ptr %.14150.i.i, align 8, !noalias !383
  %46 = getelementptr double, ptr %28, i64 %.13912.02168.i.i
  %.14237.i.i = load double, ptr %46, align 8, !noalias !383
  %.14238.i.i = fcmp une double %.14237.i.i, 0.000000e+00
  br i1 %.14238.i.i, label %B2346.i.i, label %B2386.i.i
B2346.i.i:
  call void @llvm.lifetime.start.p0(ptr nonnull %.1009.i.i.i), !noalias !383
  call void @llvm.lifetime.start.p0(ptr nonnull %.1625.i.i.i), !noalias !383
  call void @llvm.lifetime.start.p0(ptr nonnull %.2325.i.i.i), !noalias !383
  call void @llvm.lifetime.start.p0(ptr nonnull %.3861.i.i.i), !noalias !383
  %.137.i.i.i = getelementptr double, ptr %.46.i1964.i.i, i64 %.13912.02168.i.i
  %.138.i.i.i = load double, ptr %.137.i.i.i, align 8, !noalias !473
  %.192.i.i.i = getelementptr double, ptr %31, i64 %.13912.02168.i.i
  %.193.i.i.i = load double, ptr %.192.i.i.i, align 8, !noalias !473
  %.247.i.i.i = getelementptr double, ptr %29, i64 %.13912.02168.i.i
  %.248.i.i.i = load double, ptr %.247.i.i.i, align 8, !noalias !473
  %.342.i.i2100.i.i = load i64, ptr %.341.i2081.i.i, align 8, !noalias !476
  %.347.i.i.i.i = add nsw i64 %.342.i.i2100.i.i, %.346.i2090.i.i
  %.348.i.i.i.i = inttoptr i64 %.347.i.i.i.i to ptr
  %.667.i.i.i = load i64, ptr %.1550.i.i, align 8, !noalias !473
  %.668.i2101.i.i = icmp sgt i64 %.667.i.i.i, 0
  br i1 %.668.i2101.i.i, label %B204.i.i.i, label %B160.i.i.i
B160.i.i.i:
  %.996.i.i.i = load i64, ptr %.1882.i.i, align 8, !noalias !473
  %.997.i.i.i = icmp sgt i64 %.996.i.i.i, 0
  br i1 %.997.i.i.i, label %B204.i.i.i, label %B250.i.i.i
B204.i.i.i:
  store double 0.000000e+00, ptr %.1009.i.i.i, align 8, !noalias !473
  store i8 0, ptr %.fca.1.gep430.i.i.i, align 8, !noalias !473
  call fastcc void @v76(ptr %.1009.i.i.i, ptr nonnull readonly %job, i64 %.13912.02168.i.i, double %.138.i.i.i, double %.193.i.i.i, double %.248.i.i.i)
  %.1025.fca.0.load.i.i.i = load double, ptr %.1009.i.i.i, align 8, !noalias !473
  %.1025.fca.1.load.i.i.i = load i8, ptr %.fca.1.gep430.i.i.i, align 8, !noalias !473
  %.1030.i.i.i = icmp ne i8 %.1025.fca.1.load.i.i.i, 0
  br label %B592.i.i.i
B250.i.i.i:
  %.46.i.i.i.i = load i64, ptr %.45.i1976.i.i, align 8, !noalias !479
  %.50.i.i.i.i = inttoptr i64 %.46.i.i.i.i to ptr
  %.1431.i.i.i = getelementptr i8, ptr %.348.i.i.i.i, i64 16
  %.1432.i.i.i = load i64, ptr %.1431.i.i.i, align 8, !noalias !473
  %.1432.lobit.i.i.i = lshr i64 %.1432.i.i.i, 63
  %47 = getelementptr double, ptr %.50.i.i.i.i, i64 %.1432.i.i.i
  %.1460.i.i.i = getelementptr double, ptr %47, i64 %.1432.lobit.i.i.i
  %.1461.i.i.i = load double, ptr %.1460.i.i.i, align 8, !noalias !473
  %.1466.i.i.i = fcmp olt double %.1461.i.i.i, %.248.i.i.i
  br i1 %.1466.i.i.i, label %B346.i.i.i, label %B592.i.i.i
B346.i.i.i:
  %.5.i.i.i.i = fmul double %.248.i.i.i, 0x3D06849B86A12B9B
  %.6.i.i.i.i = fadd double %.5.i.i.i.i, 1.000000e-15
  %.1498.i.i.i = fsub double %.248.i.i.i, %.6.i.i.i.i
  %.1552.i.i.i = getelementptr double, ptr %35, i64 %.13912.02168.i.i
  store double %.1498.i.i.i, ptr %.1552.i.i.i, align 8, !noalias !473
  %48 = getelementptr i64, ptr %36, i64 %.13912.02168.i.i
  %.1608.i.i.i = load i64, ptr %48, align 8, !noalias !473
  %.1609.not.i.i.i = icmp eq i64 %.1608.i.i.i, 0
  br i1 %.1609.not.i.i.i, label %B478.i.i.i, label %B442.i.i.i
B442.i.i.i:
  call fastcc void @v80(ptr %.1625.i.i.i, ptr nonnull readonly %job, i64 %.13912.02168.i.i, i64 %.14067.i.i)
  br label %B592.i.i.i
B478.i.i.i:
  %.1991.i.i.i = load i64, ptr %.1990.i.i.i, align 8, !noalias !473
  %.2318.i.i.i = load i64, ptr %.3924.i.i, align 8, !noalias !473
  %.2320.i.i.i = shl nsw i64 %.13912.02168.i.i, 3
  %.2321.i.i.i = add nsw i64 %.2318.i.i.i, %.2320.i.i.i
  call fastcc void @v81(ptr %.2325.i.i.i, ptr nonnull readonly %job, i64 %.13912.02168.i.i, i64 %.14067.i.i, i64 %.1991.i.i.i, i64 %.2321.i.i.i)
  br label %B592.i.i.i
B592.i.i.i:
  %end.2.0.i.i.i = phi double [ %.1025.fca.0.load.i.i.i, %B204.i.i.i ], [ %.248.i.i.i, %B442.i.i.i ], [ %.248.i.i.i, %B478.i.i.i ], [ %.248.i.i.i, %B250.i.i.i ]
  %has_changed.2.0.i.i.i = phi i1 [ %.1030.i.i.i, %B204.i.i.i ], [ false, %B442.i.i.i ], [ false, %B478.i.i.i ], [ false, %B250.i.i.i ]
  %.2389.i.i.i = load i64, ptr %.348.i.i.i.i, align 8, !noalias !473
  %.2390.i.i.i = add nsw i64 %.2389.i.i.i, 1
  store i64 %.2390.i.i.i, ptr %.348.i.i.i.i, align 8, !noalias !473
  store double %end.2.0.i.i.i, ptr %.137.i.i.i, align 8, !noalias !473
  %.2512.i.i.i = getelementptr i8, ptr %.348.i.i.i.i, i64 24
  %.2513.i.i.i = load i64, ptr %.2512.i.i.i, align 8, !noalias !473
  %.2519.i.i.i = icmp sgt i64 %.2513.i.i.i, -1
  br i1 %.2519.i.i.i, label %b112, label %B696.i.i.i
B696.i.i.i:
  %.2603.i.i.i = getelementptr double, ptr %37, i64 %.13912.02168.i.i
  %.2604.i.i.i = load double, ptr %.2603.i.i.i, align 8, !noalias !473
  %.2658.i.i.i = getelementptr double, ptr %38, i64 %.13912.02168.i.i
  %.2659.i.i.i = load double, ptr %.2658.i.i.i, align 8, !noalias !473
  %.2719.i.i.i = getelementptr double, ptr %39, i64 %.13912.02168.i.i
  %.2720.i.i.i = load double, ptr %.2719.i.i.i, align 8, !noalias !473
  %.2775.i.i.i = getelementptr double, ptr %40, i64 %.13912.02168.i.i
  store double %.193.i.i.i, ptr %.2775.i.i.i, align 8, !noalias !473
  %.2830.i.i.i = getelementptr double, ptr %41, i64 %.13912.02168.i.i
  store double %.2720.i.i.i, ptr %.2830.i.i.i, align 8, !noalias !473
  %.2885.i.i.i = getelementptr i64, ptr %42, i64 %.13912.02168.i.i
  %.2886.i.i.i = load i64, ptr %.2885.i.i.i, align 8, !noalias !473
  %.2887.not.i.i.i = icmp eq i64 %.2886.i.i.i, 0
  br i1 %.2887.not.i.i.i, label %B974.i.i.i, label %B862.i.i.i
B862.i.i.i:
  %.12.i.i2102.i.i = fcmp ogt double %.2604.i.i.i, 5.000000e-01
  %.13.i.i2103.i.i = select i1 %.12.i.i2102.i.i, double %.2604.i.i.i, double 5.000000e-01
  %.12.i953.i.i.i = fcmp olt double %.13.i.i2103.i.i, 2.000000e+00
  %.13.i954.i.i.i = select i1 %.12.i953.i.i.i, double %.13.i.i2103.i.i, double 2.000000e+00
  %.2947.i.i.i = fmul double %.193.i.i.i, %.13.i954.i.i.i
  %.3001.i.i.i = getelementptr double, ptr %43, i64 %.13912.02168.i.i
  store double %.2947.i.i.i, ptr %.3001.i.i.i, align 8, !noalias !473
  store i64 0, ptr %.2885.i.i.i, align 8, !noalias !473
  br label %B974.i.i.i
B974.i.i.i:
  %.3061.i.i.i = fcmp olt double %.193.i.i.i, %.2659.i.i.i
  br i1 %.3061.i.i.i, label %B986.i.i.i, label %B1024.i.i.i
B986.i.i.i:
  %.3065.i.i.i = fmul double %.193.i.i.i, %.2604.i.i.i
  %.12.i955.i.i.i = fcmp ogt double %.3065.i.i.i, %.2659.i.i.i
  %.13.i956.i.i.i = select i1 %.12.i955.i.i.i, double %.3065.i.i.i, double %.2659.i.i.i
  br label %B1094.i.i.i
B1024.i.i.i:
  %.3160.i.i.i = getelementptr i64, ptr %34, i64 %.13912.02168.i.i
  %.3161.i.i.i = load i64, ptr %.3160.i.i.i, align 8, !noalias !473
  %.3162.not.i.i.i = icmp eq i64 %.3161.i.i.i, 0
  %.12.i957.i.i.i = fcmp olt double %.2604.i.i.i, 1.000000e+00
  %49 = select i1 %.3162.not.i.i.i, i1 true, i1 %.12.i957.i.i.i
  %"$phi1090.1.2.0.i.i.i" = select i1 %49, double %.2604.i.i.i, double 1.000000e+00
  %.3213.i.i.i = fmul double %.193.i.i.i, %"$phi1090.1.2.0.i.i.i"
  br label %B1094.i.i.i
B1094.i.i.i:
  %"$phi1094.0.2.0.i.i.i" = phi double [ %.13.i956.i.i.i, %B986.i.i.i ], [ %.3213.i.i.i, %B1024.i.i.i ]
  %.3284.i.i.i = getelementptr i64, ptr %34, i64 %.13912.02168.i.i
  store i64 0, ptr %.3284.i.i.i, align 8, !noalias !473
  br i1 %has_changed.2.0.i.i.i, label %B1124.i.i.i, label %B1364.i.i.i
B1124.i.i.i:
  %.3346.i.i.i = getelementptr double, ptr %44, i64 %.13912.02168.i.i
  %.3347.i.i.i = load double, ptr %.3346.i.i.i, align 8, !noalias !473
  %.5.i959.i.i.i = fmul double %.3347.i.i.i, 0x3D06849B86A12B9B
  %.6.i960.i.i.i = fadd double %.5.i959.i.i.i, 1.000000e-15
  %.3427.i.i.i = fsub double %.3347.i.i.i, %.6.i960.i.i.i
  %.3429.i.i.i = fcmp olt double %end.2.0.i.i.i, %.3427.i.i.i
  br i1 %.3429.i.i.i, label %B1230.i.i.i, label %B1364.i.i.i
B1230.i.i.i:
  %.3484.i.i.i = getelementptr double, ptr %43, i64 %.13912.02168.i.i
  %.3485.i.i.i = load double, ptr %.3484.i.i.i, align 8, !noalias !473
  %.12.i961.i.i.i = fcmp olt double %.3485.i.i.i, %"$phi1094.0.2.0.i.i.i"
  %.13.i962.i.i.i = select i1 %.12.i961.i.i.i, double %.3485.i.i.i, double %"$phi1094.0.2.0.i.i.i"
  store double 0.000000e+00, ptr %.2775.i.i.i, align 8, !noalias !473
  %.3628.i.i.i = getelementptr double, ptr %45, i64 %.13912.02168.i.i
  store double %end.2.0.i.i.i, ptr %.3628.i.i.i, align 8, !noalias !473
  store i64 1, ptr %.2885.i.i.i, align 8, !noalias !473
  br label %B1364.i.i.i
B1364.i.i.i:
  %h.3.0.i2104.i.i = phi double [ %.13.i962.i.i.i, %B1230.i.i.i ], [ %"$phi1094.0.2.0.i.i.i", %B1124.i.i.i ], [ %"$phi1094.0.2.0.i.i.i", %B1094.i.i.i ]
  %.3742.i.i.i = getelementptr double, ptr %33, i64 %.13912.02168.i.i
  store double %h.3.0.i2104.i.i, ptr %.3742.i.i.i, align 8, !noalias !473
  %.3799.i.i.i = getelementptr i64, ptr %36, i64 %.13912.02168.i.i
  %.3800.i.i.i = load i64, ptr %.3799.i.i.i, align 8, !noalias !473
  %.3808.not.i.i.i = icmp eq i64 %.3800.i.i.i, 0
  br i1 %.3808.not.i.i.i, label %B1482.i.i.i, label %B1418.i.i.i
B1418.i.i.i:
  %.341.i.i.i.i.i = load i64, ptr %.340.i.i, align 8, !noalias !482
  %.342.i.i.i.i.i = inttoptr i64 %.341.i.i.i.i.i to ptr
  %.668.i.i.i.i.i = load i64, ptr %job, align 8, !noalias !482
  %50 = getelementptr i64, ptr %.342.i.i.i.i.i, i64 %.668.i.i.i.i.i
  %51 = getelementptr i64, ptr %50, i64 %.13912.02168.i.i
  %.119.i.i2106.i.i = load i64, ptr %51, align 8, !noalias !487
  %.451.i.i2108.i.i = load i64, ptr %.450.i.i1995.i.i, align 8, !noalias !487
  %.778.i.i2110.i.i = load i64, ptr %.777.i.i1997.i.i, align 8, !noalias !487
  %.46.i385.i.i2114.i.i = load i64, ptr %.45.i384.i.i1999.i.i, align 8, !noalias !488
  %.50.i386.i.i2115.i.i = inttoptr i64 %.46.i385.i.i2114.i.i to ptr
  %.2228.i.i2116.i.i = icmp slt i64 %.119.i.i2106.i.i, 0
  %.2229.i.i2117.i.i = select i1 %.2228.i.i2116.i.i, i64 %.451.i.i2108.i.i, i64 0
  %52 = getelementptr i64, ptr %.50.i386.i.i2115.i.i, i64 %.119.i.i2106.i.i
  %.2243.i.i2118.i.i = getelementptr i64, ptr %52, i64 %.2229.i.i2117.i.i
  %.2244.i.i2119.i.i = load i64, ptr %.2243.i.i2118.i.i, align 8, !noalias !487
  %.2574.i.i2121.i.i = load i64, ptr %.2573.i.i2006.i.i, align 8, !noalias !487
  %.2575.i.i2122.i.i = icmp sgt i64 %.2574.i.i2121.i.i, 0
  br i1 %.2575.i.i2122.i.i, label %B432.i.i2132.i.i, label %b113
B432.i.i2132.i.i:
  %.2906.i.i2134.i.i = load i64, ptr %.2905.i.i2078.i.i, align 8, !noalias !487
  %.2908.i.i2135.i.i = mul nsw i64 %.2906.i.i2134.i.i, %.13912.02168.i.i
  br label %b113
b113:
  %"$phi476.1.2.0.i.i2124.i.i" = phi i64 [ %.2908.i.i2135.i.i, %B432.i.i2132.i.i ], [ 0, %B1418.i.i.i ]
  %.2922.i.i2125.i.i = add nsw i64 %"$phi476.1.2.0.i.i2124.i.i", %.2244.i.i2119.i.i
  %.3291.i.i2127.i.i = load i64, ptr %.3290.i.i2012.i.i, align 8, !noalias !487
  %.3298.i.i2128.i.i = mul nsw i64 %.778.i.i2110.i.i, 56
  %.3299.i.i2129.i.i = mul nsw i64 %.3298.i.i2128.i.i, %.2922.i.i2125.i.i
  %.3300.i.i2130.i.i = add nsw i64 %.3291.i.i2127.i.i, %.3299.i.i2129.i.i
  %.3301.i.i2131.i.i = inttoptr i64 %.3300.i.i2130.i.i to ptr
  call fastcc void @v71(ptr %.3861.i.i.i, ptr nonnull readonly %job, i64 %.13912.02168.i.i, ptr %.3301.i.i2131.i.i, i64 7, double %end.2.0.i.i.i)
  br label %B1482.i.i.i
B1482.i.i.i:
  %.3962.i.i.i = getelementptr double, ptr %44, i64 %.13912.02168.i.i
  %.3963.i.i.i = load double, ptr %.3962.i.i.i, align 8, !noalias !473
  %.3972.i.i.i = fcmp olt double %end.2.0.i.i.i, %.3963.i.i.i
  %..i.i.i = sext i1 %.3972.i.i.i to i64
  br label %b112
b112:
  %storemerge.i.i.i = phi i64 [ %..i.i.i, %B1482.i.i.i ], [ 1, %B592.i.i.i ]
  call void @llvm.lifetime.end.p0(ptr nonnull %.1009.i.i.i), !noalias !383
  call void @llvm.lifetime.end.p0(ptr nonnull %.1625.i.i.i), !noalias !383
  call void @llvm.lifetime.end.p0(ptr nonnull %.2325.i.i.i), !noalias !383
  call void @llvm.lifetime.end.p0(ptr nonnull %.3861.i.i.i), !noalias !383
  br label %B2420.i.i
B2386.i.i:
  %.110.i.i.i = getelementptr double, ptr %.46.i1964.i.i, i64 %.13912.02168.i.i
  %.111.i2136.i.i = load double, ptr %.110.i.i.i, align 8, !noalias !491
  %.163.i.i.i = getelementptr double, ptr %31, i64 %.13912.02168.i.i
  %.164.i2137.i.i = load double, ptr %.163.i.i.i, align 8, !noalias !491
  %.221.i.i.i = getelementptr double, ptr %32, i64 %.13912.02168.i.i
  %.222.i.i.i = load double, ptr %.221.i.i.i, align 8, !noalias !491
  %.223.i.i.i = fmul double %.164.i2137.i.i, %.222.i.i.i
  %.279.i.i.i = getelementptr double, ptr %33, i64 %.13912.02168.i.i
  store double %.223.i.i.i, ptr %.279.i.i.i, align 8, !noalias !491
  %53 = getelementptr i64, ptr %34, i64 %.13912.02168.i.i
  store i64 1, ptr %53, align 8, !noalias !491
  %.345.i.i.i = fadd double %.111.i2136.i.i, %.223.i.i.i
  %.346.i2139.i.i = fcmp ole double %.345.i.i.i, %.111.i2136.i.i
  %.349.i.i.i = fcmp olt double %.223.i.i.i, 1.000000e-300
  %or.cond.i.i.i = or i1 %.349.i.i.i, %.346.i2139.i.i
  %"$phi172.0.2.0.i.i.i" = select i1 %or.cond.i.i.i, i64 2, i64 -1
  br label %B2420.i.i
B2420.i.i:
  %"$phi2420.1.2.2.in.sroa.speculated.i.i" = phi i64 [ %storemerge.i.i.i, %b112 ], [ %"$phi172.0.2.0.i.i.i", %B2386.i.i ]
  %.14346.i.i = icmp ne i64 %.13912.02168.i.i, 0
  %or.cond1.i.i = and i1 %.2614.i.i, %.14346.i.i
  br i1 %or.cond1.i.i, label %B2438.i.i, label %B2540.i.i
B2438.i.i:
  %.13.i.i.i = tail call i64 @llvm.smin.i64(i64 %"$phi2420.1.2.2.in.sroa.speculated.i.i", i64 0)
  %.100.i.i.i = load i64, ptr %.99.i.i.i, align 8, !noalias !494
  %.101.i.i.i = icmp sgt i64 %.100.i.i.i, 0
  br i1 %.101.i.i.i, label %b114, label %B82.i.i.i
B82.i.i.i:
  %.235.i.i.i = load double, ptr %28, align 8, !noalias !494
  %.236.i.i.i = fcmp une double %.235.i.i.i, 0.000000e+00
  br i1 %.236.i.i.i, label %B120.i.i.i, label %B172.i.i.i
B120.i.i.i:
  %.294.i.i.i = load double, ptr %46, align 8, !noalias !494
  %.302.i.i.i = fcmp oeq double %.294.i.i.i, 0.000000e+00
  br i1 %.302.i.i.i, label %b114, label %B172.i.i.i
B172.i.i.i:
  br label %b114
b114:
  %storemerge.i2140.i.i = phi i64 [ %.100.i.i.i, %B2438.i.i ], [ -1, %B172.i.i.i ], [ 2, %B120.i.i.i ]
  %.13.i2141.i.i = tail call i64 @llvm.smax.i64(i64 %storemerge.i2140.i.i, i64 %.13.i.i.i)
  br label %B2630.i.i
B2540.i.i:
  %.14456.i.i = icmp slt i64 %"$phi2420.1.2.2.in.sroa.speculated.i.i", 1
  br i1 %.14456.i.i, label %B2562.i.i, label %B2630.i.i
B2562.i.i:
  %.14490.i.i = load double, ptr %.14489.i.i, align 8, !noalias !383
  %.67.i.i.i = load i64, ptr %.14150.i.i, align 8, !noalias !497
  %.87.i2142.i.i = srem i64 %.67.i.i.i, 400
  %.89.i2143.i.i = icmp slt i64 %.87.i2142.i.i, 0
  %.98.i.i.i = add nsw i64 %.87.i2142.i.i, 400
  %.78.0.i.i.i = select i1 %.89.i2143.i.i, i64 %.98.i.i.i, i64 %.87.i2142.i.i
  %.108.i.i.i = icmp eq i64 %.78.0.i.i.i, 0
  br i1 %.108.i.i.i, label %B56.i.i.i, label %B590.i.i.i
B56.i.i.i:
  %.45.i.i2145.i.i = load i64, ptr %.44.i.i.i, align 8, !noalias !500
  %.46.i.i2146.i.i = inttoptr i64 %.45.i.i2145.i.i to ptr
  %.372.i.i.i.i = load i64, ptr %job, align 8, !noalias !500
  %.341.i.i2148.i.i = load i64, ptr %.340.i.i, align 8, !noalias !503
  %.342.i.i2149.i.i = inttoptr i64 %.341.i.i2148.i.i to ptr
  %.45.i543.i.i.i = load i64, ptr %.44.i1962.i.i, align 8, !noalias !506
  %.46.i544.i.i.i = inttoptr i64 %.45.i543.i.i.i to ptr
  %54 = getelementptr double, ptr %.46.i544.i.i.i, i64 %.13912.02168.i.i
  %.888.i.i.i = load double, ptr %54, align 8, !noalias !497
  %.idx.i2150.i.i = mul i64 %.372.i.i.i.i, 112
  %55 = getelementptr i8, ptr %.46.i.i2146.i.i, i64 %.idx.i2150.i.i
  %56 = getelementptr double, ptr %55, i64 %.13912.02168.i.i
  %.987.i.i.i = load double, ptr %56, align 8, !noalias !497
  %.1612.i.i.i = load i64, ptr %.1795.i.i.i.i, align 8, !noalias !497
  %.46.i555.i.i.i = load i64, ptr %.45.i1976.i.i, align 8, !noalias !509
  %.50.i.i2151.i.i = inttoptr i64 %.46.i555.i.i.i to ptr
  %57 = getelementptr double, ptr %.50.i.i2151.i.i, i64 %.1612.i.i.i
  %.1678.i.i.i = getelementptr i8, ptr %57, i64 -8
  %.1679.i.i.i = load double, ptr %.1678.i.i.i, align 8, !noalias !497
  %.1684.i.i.i = fsub double %.888.i.i.i, %.987.i.i.i
  %.1685.i.i.i = fsub double %.1679.i.i.i, %.987.i.i.i
  %.1686.i.i.i = fmul double %.1685.i.i.i, 1.000000e-04
  %.1687.i.i.i = fcmp olt double %.1684.i.i.i, %.1686.i.i.i
  br i1 %.1687.i.i.i, label %B394.i.i.i, label %B394.thread.i.i.i
B394.thread.i.i.i:
  %.1787566.i.i.i = load i64, ptr %.348.i2092.i.i, align 8, !noalias !497
  %.1816567.i.i.i = getelementptr i8, ptr %.348.i2092.i.i, i64 32
  %.pre.i.i = mul i64 %.372.i.i.i.i, 40
  br label %B498.i.i.i
B394.i.i.i:
  %.idx532.i.i.i = mul i64 %.372.i.i.i.i, 40
  %58 = getelementptr i8, ptr %.342.i.i2149.i.i, i64 %.idx532.i.i.i
  %59 = getelementptr i64, ptr %58, i64 %.13912.02168.i.i
  %.1746.i.i.i = load i64, ptr %59, align 8, !noalias !497
  %.1747.not.i.i.i = icmp ne i64 %.1746.i.i.i, 0
  %.1787.i.i.i = load i64, ptr %.348.i2092.i.i, align 8, !noalias !497
  %.1816.i.i.i = getelementptr i8, ptr %.348.i2092.i.i, i64 32
  %.1817.i.i.i = load i64, ptr %.1816.i.i.i, align 8, !noalias !497
  %.1818.i.i.i = sub nsw i64 %.1787.i.i.i, %.1817.i.i.i
  %.1860.i.i.i = icmp sgt i64 %.1818.i.i.i, 279
  %brmerge.i.i.i = select i1 %.1860.i.i.i, i1 true, i1 %.1747.not.i.i.i
  br i1 %brmerge.i.i.i, label %B498.i.i.i, label %B2630.i.i
B498.i.i.i:
  %.idx533.i.pre-phi.i.i = phi i64 [ %.idx532.i.i.i, %B394.i.i.i ], [ %.pre.i.i, %B394.thread.i.i.i ]
  %.1816573.i.i.i = phi ptr [ %.1816.i.i.i, %B394.i.i.i ], [ %.1816567.i.i.i, %B394.thread.i.i.i ]
  %.1787572.i.i.i = phi i64 [ %.1787.i.i.i, %B394.i.i.i ], [ %.1787566.i.i.i, %B394.thread.i.i.i ]
  store i64 %.1787572.i.i.i, ptr %.1816573.i.i.i, align 8, !noalias !497
  store double %.888.i.i.i, ptr %56, align 8, !noalias !497
  %60 = getelementptr i8, ptr %.342.i.i2149.i.i, i64 %.idx533.i.pre-phi.i.i
  %61 = getelementptr i64, ptr %60, i64 %.13912.02168.i.i
  store i64 0, ptr %61, align 8, !noalias !497
  %.2121.pre.i.i.i = load i64, ptr %.14150.i.i, align 8, !noalias !497
  br label %B590.i.i.i
B590.i.i.i:
  %.2121.i.i.i = phi i64 [ %.67.i.i.i, %B2562.i.i ], [ %.2121.pre.i.i.i, %B498.i.i.i ]
  %.2128.i.i.i = sitofp i64 %.2121.i.i.i to double
  %.2129.i.i.i = fcmp ugt double %.14490.i.i, %.2128.i.i.i
  br i1 %.2129.i.i.i, label %B638.i.i.i, label %B2630.i.i
B638.i.i.i:
  %.46.i557.i.i.i = load i64, ptr %.45.i556.i.i.i, align 8, !noalias !512
  %.50.i558.i.i.i = inttoptr i64 %.46.i557.i.i.i to ptr
  %.2508.i.i.i = getelementptr i8, ptr %.50.i558.i.i.i, i64 8
  %.2509.i.i.i = load double, ptr %.2508.i.i.i, align 8, !noalias !497
  %.2513.i2144.i.i = fcmp une double %.2509.i.i.i, 0.000000e+00
  br i1 %.2513.i2144.i.i, label %select.unfold2152.i.i, label %B2630.i.i
select.unfold2152.i.i:
  br label %B2630.i.i
B2630.i.i:
  %ended.3.2.i.i = phi i64 [ %.13.i2141.i.i, %b114 ], [ %"$phi2420.1.2.2.in.sroa.speculated.i.i", %B2540.i.i ], [ %"$phi2420.1.2.2.in.sroa.speculated.i.i", %B638.i.i.i ], [ 5, %select.unfold2152.i.i ], [ 3, %B590.i.i.i ], [ 2, %B394.i.i.i ]
  %.14619.i.i = getelementptr i64, ptr %.99.i.i.i, i64 %.13912.02168.i.i
  store i64 %ended.3.2.i.i, ptr %.14619.i.i, align 8, !noalias !383
  %.14622.i.i = icmp sgt i64 %ended.3.2.i.i, -1
  %.14626.i.i = or i1 %has_ended.2.02172.i.i, %.14622.i.i
  br label %B2672.i.i
B2672.i.i:
  %has_ended.3.1.i.i = phi i1 [ %.14626.i.i, %B2630.i.i ], [ %has_ended.2.02172.i.i, %B2188.if.i.i ]
  %exitcond2180.not.i.i = icmp eq i64 %.344.i.i, %.13981.i.i
  br i1 %exitcond2180.not.i.i, label %B2674.i.i, label %B2188.if.i.i
B2674.i.i:
  %.14993.i.i = load i64, ptr %.14992.i.i, align 8, !noalias !383
  %.15320.i.i = load i64, ptr %.44.i.i.i, align 8, !noalias !383
  %.15647.i.i = load i64, ptr %.3597.i.i, align 8, !noalias !383
  %.15974.i.i = load i64, ptr %.9462.i.i, align 8, !noalias !383
  %.16301.i.i = load i64, ptr %.16300.i.i, align 8, !noalias !383
  %.16302.i.i = inttoptr i64 %.14993.i.i to ptr
  tail call void %.16302.i.i(i64 %.15320.i.i, i64 %.15647.i.i, i64 %.15974.i.i, i64 %.16301.i.i), !noalias !383
  br i1 %has_ended.3.1.i.i, label %B2906.if.i.i, label %b115
B2948.i.i:
  %.16541.i.i = getelementptr i64, ptr %.99.i.i.i, i64 %.16334.02175.i.i
  %.16542.i.i = load i64, ptr %.16541.i.i, align 8, !noalias !383
  %.16543.i.i = icmp sgt i64 %.16542.i.i, -1
  br i1 %.16543.i.i, label %B2986.i.i, label %B3046.i.i
B2986.i.i:
  call fastcc void @v75(ptr %.16603.i.i, ptr nonnull %job, i64 %.16334.02175.i.i, i64 %.16542.i.i)
  br label %B3046.i.i
B3046.i.i:
  %exitcond2181.not.i.i = icmp eq i64 %.344.i.i, %.16403.i.i
  br i1 %exitcond2181.not.i.i, label %b115, label %B2906.if.i.i
common.ret.critedge.i.i:
  %.14993.c.i.i = load i64, ptr %.14992.i.i, align 8, !noalias !383
  %.15320.c.i.i = load i64, ptr %.44.i.i.i, align 8, !noalias !383
  %.15647.c.i.i = load i64, ptr %.3597.i.i, align 8, !noalias !383
  %.15974.c.i.i = load i64, ptr %.9462.i.i, align 8, !noalias !383
  %.16301.c.i.i = load i64, ptr %.16300.i.i, align 8, !noalias !383
  %.16302.c.i.i = inttoptr i64 %.14993.c.i.i to ptr
  tail call void %.16302.c.i.i(i64 %.15320.c.i.i, i64 %.15647.c.i.i, i64 %.15974.c.i.i, i64 %.16301.c.i.i), !noalias !383
  br label %b115
B3053.i.i:
  %exitcond.not.i.i = icmp eq i64 %.344.i.i, %.5656.i.i
  br i1 %exitcond.not.i.i, label %B912.i.i, label %B764.if.i.i
B764.if.i.i:
  %.5587.02158.i.i = phi i64 [ 0, %B764.if.lr.ph.i.i ], [ %.5656.i.i, %B3053.i.i ]
  %.5656.i.i = add nuw nsw i64 %.5587.02158.i.i, 1
  %62 = getelementptr i64, ptr %.342.i.i.i, i64 %.5587.02158.i.i
  %.5738.i.i = load i64, ptr %62, align 8, !noalias !383
  %.5739.i.i = icmp sgt i64 %.5738.i.i, -1
  br i1 %.5739.i.i, label %B806.i.i, label %B3053.i.i
B1650.if.i.i:
  %.12110.02161.i.i = phi i64 [ 1, %B1650.if.lr.ph.i.i ], [ %.12179.i.i, %B1744.i.i ]
  %.12179.i.i = add nuw i64 %.12110.02161.i.i, 1
  %.12260.i.i = getelementptr double, ptr %.46.i.i.i, i64 %.12110.02161.i.i
  %.12261.i.i = load double, ptr %.12260.i.i, align 8, !noalias !383
  %.12262.i.i = fcmp ueq double %.12261.i.i, 0x7FF0000000000000
  br i1 %.12262.i.i, label %B1744.i.i, label %B1712.i.i
B1802.if.i.i:
  %wants_dense.2.02166.i.i = phi i1 [ false, %B1802.if.lr.ph.i.i ], [ %wants_dense.3.1.i.i, %B2018.i.i ]
  %.12417.02164.i.i = phi i64 [ 0, %B1802.if.lr.ph.i.i ], [ %.12486.i.i, %B2018.i.i ]
  %.12486.i.i = add nuw nsw i64 %.12417.02164.i.i, 1
  %63 = getelementptr i64, ptr %.342.i.i.i, i64 %.12417.02164.i.i
  %.12572.i.i = load i64, ptr %63, align 8, !noalias !383
  %.12573.i.i = icmp sgt i64 %.12572.i.i, -1
  br i1 %.12573.i.i, label %B1844.i.i, label %B2018.i.i
B2188.if.i.i:
  %has_ended.2.02172.i.i = phi i1 [ false, %B2154.i.i ], [ %has_ended.3.1.i.i, %B2672.i.i ]
  %.13912.02168.i.i = phi i64 [ 0, %B2154.i.i ], [ %.13981.i.i, %B2672.i.i ]
  %.13981.i.i = add nuw nsw i64 %.13912.02168.i.i, 1
  %.14066.i.i = getelementptr i64, ptr %.342.i.i.i, i64 %.13912.02168.i.i
  %.14067.i.i = load i64, ptr %.14066.i.i, align 8, !noalias !383
  %.14072.i.i = icmp sgt i64 %.14067.i.i, -1
  br i1 %.14072.i.i, label %B2234.i.i, label %B2672.i.i
B2906.if.i.i:
  %.16334.02175.i.i = phi i64 [ %.16403.i.i, %B3046.i.i ], [ 0, %B2674.i.i ]
  %.16403.i.i = add nuw nsw i64 %.16334.02175.i.i, 1
  %.16484.i.i = getelementptr i64, ptr %.342.i.i.i, i64 %.16334.02175.i.i
  %.16485.i.i = load i64, ptr %.16484.i.i, align 8, !noalias !383
  %.16486.i.i = icmp sgt i64 %.16485.i.i, -1
  br i1 %.16486.i.i, label %B2948.i.i, label %B3046.i.i
b115:
  call void @llvm.lifetime.end.p0(ptr nonnull %.16603.i.i), !noalias !374
  %.3247.i = load i64, ptr %.2062.i, align 8, !noalias !374
  %.3248.i = icmp sgt i64 %.3247.i, 0
  br i1 %.3248.i, label %B596.i, label %b106
B360.if.i:
  %.2087.0453.i = phi i64 [ 0, %B360.if.lr.ph.i ], [ %.2156.i, %B456.i ]
  %.2156.i = add nuw nsw i64 %.2087.0453.i, 1
  br i1 %.2264446.not.i, label %B456.i, label %B394.if.lr.ph.i
B394.if.lr.ph.i:
  %invariant.gep.i = getelementptr double, ptr %.46.i.i, i64 %.2087.0453.i
  br label %B394.if.i
B394.if.i:
  %.2208.0447.i = phi i64 [ 0, %B394.if.lr.ph.i ], [ %.2277.i, %B394.if.i ]
  %.2277.i = add nuw nsw i64 %.2208.0447.i, 1
  %64 = getelementptr i8, ptr %.1672.i, i64 %.2208.0447.i
  %.2335.i = load i8, ptr %64, align 1, !noalias !374
  %.2336.not.i = icmp eq i8 %.2335.i, 0
  %..i = select i1 %.2336.not.i, double 0xFFF0000000000000, double 0.000000e+00
  %.2397.i = mul i64 %.2208.0447.i, %.674.i
  %gep450.i = getelementptr double, ptr %invariant.gep.i, i64 %.2397.i
  store double %..i, ptr %gep450.i, align 8, !noalias !374
  %exitcond.not.i = icmp eq i64 %.1001.i, %.2277.i
  br i1 %exitcond.not.i, label %B456.i, label %B394.if.i
b106:
  call void @llvm.lifetime.end.p0(ptr nonnull %.2517.i)
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
!12 = !{!13}
!13 = distinct !{!13, !14, !"scope"}
!14 = distinct !{!14, !"scope"}
!15 = !{!16}
!16 = distinct !{!16, !17, !"scope"}
!17 = distinct !{!17, !"scope"}
!18 = !{!19}
!19 = distinct !{!19, !20, !"scope"}
!20 = distinct !{!20, !"scope"}
!21 = !{!22, !24}
!22 = distinct !{!22, !23, !"scope"}
!23 = distinct !{!23, !"scope"}
!24 = distinct !{!24, !25, !"scope"}
!25 = distinct !{!25, !"scope"}
!26 = !{!24}
!27 = !{!28, !24}
!28 = distinct !{!28, !29, !"scope"}
!29 = distinct !{!29, !"scope"}
!30 = !{!31, !24}
!31 = distinct !{!31, !32, !"scope"}
!32 = distinct !{!32, !"scope"}
!33 = !{!34, !24}
!34 = distinct !{!34, !35, !"scope"}
!35 = distinct !{!35, !"scope"}
!36 = !{!37}
!37 = distinct !{!37, !38, !"scope"}
!38 = distinct !{!38, !"scope"}
!39 = !{!40}
!40 = distinct !{!40, !41, !"scope"}
!41 = distinct !{!41, !"scope"}
!42 = !{!43}
!43 = distinct !{!43, !44, !"scope"}
!44 = distinct !{!44, !"scope"}
!45 = !{!46, !43}
!46 = distinct !{!46, !47, !"scope"}
!47 = distinct !{!47, !"scope"}
!48 = !{!49, !51, !43}
!49 = distinct !{!49, !50, !"scope"}
!50 = distinct !{!50, !"scope"}
!51 = distinct !{!51, !52, !"scope"}
!52 = distinct !{!52, !"scope"}
!53 = !{!51, !43}
!54 = !{!55}
!55 = distinct !{!55, !56, !"scope"}
!56 = distinct !{!56, !"scope"}
!57 = !{!58}
!58 = distinct !{!58, !59, !"scope"}
!59 = distinct !{!59, !"scope"}
!60 = !{!61, !63}
!61 = distinct !{!61, !62, !"scope"}
!62 = distinct !{!62, !"scope"}
!63 = distinct !{!63, !64, !"scope"}
!64 = distinct !{!64, !"scope"}
!65 = !{!63}
!66 = !{!67}
!67 = distinct !{!67, !68, !"scope"}
!68 = distinct !{!68, !"scope"}
!69 = !{!"branch_weights", i32 1, i32 99}
!70 = !{!71, !73}
!71 = distinct !{!71, !72, !"scope"}
!72 = distinct !{!72, !"scope"}
!73 = distinct !{!73, !74, !"scope"}
!74 = distinct !{!74, !"scope"}
!75 = !{!73}
!76 = !{!77, !73}
!77 = distinct !{!77, !78, !"scope"}
!78 = distinct !{!78, !"scope"}
!79 = !{!80, !82, !84, !86}
!80 = distinct !{!80, !81, !"scope"}
!81 = distinct !{!81, !"scope"}
!82 = distinct !{!82, !83, !"scope"}
!83 = distinct !{!83, !"scope"}
!84 = distinct !{!84, !85, !"scope"}
!85 = distinct !{!85, !"scope"}
!86 = distinct !{!86, !87, !"scope"}
!87 = distinct !{!87, !"scope"}
!88 = !{!82, !84, !86}
!89 = !{!84, !86}
!90 = !{!86}
!91 = !{!92}
!92 = distinct !{!92, !93, !"scope"}
!93 = distinct !{!93, !"scope"}
!94 = !{!"branch_weights", i32 99, i32 1}
!95 = !{!96}
!96 = distinct !{!96, !97, !"scope"}
!97 = distinct !{!97, !"scope"}
!98 = !{!99}
!99 = distinct !{!99, !100, !"scope"}
!100 = distinct !{!100, !"scope"}
!101 = !{!102}
!102 = distinct !{!102, !103, !"scope"}
!103 = distinct !{!103, !"scope"}
!104 = !{!105}
!105 = distinct !{!105, !106, !"scope"}
!106 = distinct !{!106, !"scope"}
!107 = !{!108}
!108 = distinct !{!108, !109, !"scope"}
!109 = distinct !{!109, !"scope"}
!110 = !{!111}
!111 = distinct !{!111, !112, !"scope"}
!112 = distinct !{!112, !"scope"}
!113 = !{!114, !116}
!114 = distinct !{!114, !115, !"scope"}
!115 = distinct !{!115, !"scope"}
!116 = distinct !{!116, !117, !"scope"}
!117 = distinct !{!117, !"scope"}
!118 = !{!116}
!119 = !{!120, !122}
!120 = distinct !{!120, !121, !"scope"}
!121 = distinct !{!121, !"scope"}
!122 = distinct !{!122, !123, !"scope"}
!123 = distinct !{!123, !"scope"}
!124 = !{!122}
!125 = !{!126}
!126 = distinct !{!126, !127, !"scope"}
!127 = distinct !{!127, !"scope"}
!128 = !{!129}
!129 = distinct !{!129, !130, !"scope"}
!130 = distinct !{!130, !"scope"}
!131 = !{}
!132 = !{!133}
!133 = distinct !{!133, !134, !"scope"}
!134 = distinct !{!134, !"scope"}
!135 = !{!136}
!136 = distinct !{!136, !137, !"scope"}
!137 = distinct !{!137, !"scope"}
!138 = !{!139}
!139 = distinct !{!139, !140, !"scope"}
!140 = distinct !{!140, !"scope"}
!141 = !{!142}
!142 = distinct !{!142, !143, !"scope"}
!143 = distinct !{!143, !"scope"}
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
!162 = !{!163, !165}
!163 = distinct !{!163, !164, !"scope"}
!164 = distinct !{!164, !"scope"}
!165 = distinct !{!165, !166, !"scope"}
!166 = distinct !{!166, !"scope"}
!167 = !{!165}
!168 = !{!169, !171, !173, !175}
!169 = distinct !{!169, !170, !"scope"}
!170 = distinct !{!170, !"scope"}
!171 = distinct !{!171, !172, !"scope"}
!172 = distinct !{!172, !"scope"}
!173 = distinct !{!173, !174, !"scope"}
!174 = distinct !{!174, !"scope"}
!175 = distinct !{!175, !176, !"scope"}
!176 = distinct !{!176, !"scope"}
!177 = !{!171, !173, !175}
!178 = !{!173, !175}
!179 = !{!175}
!180 = !{!181, !183}
!181 = distinct !{!181, !182, !"scope"}
!182 = distinct !{!182, !"scope"}
!183 = distinct !{!183, !184, !"scope"}
!184 = distinct !{!184, !"scope"}
!185 = !{!183}
!186 = !{!187}
!187 = distinct !{!187, !188, !"scope"}
!188 = distinct !{!188, !"scope"}
!189 = !{!190, !187}
!190 = distinct !{!190, !191, !"scope"}
!191 = distinct !{!191, !"scope"}
!192 = !{!193, !195}
!193 = distinct !{!193, !194, !"scope"}
!194 = distinct !{!194, !"scope"}
!195 = distinct !{!195, !196, !"scope"}
!196 = distinct !{!196, !"scope"}
!197 = !{!195}
!198 = !{!199, !201}
!199 = distinct !{!199, !200, !"scope"}
!200 = distinct !{!200, !"scope"}
!201 = distinct !{!201, !202, !"scope"}
!202 = distinct !{!202, !"scope"}
!203 = !{!201}
!204 = !{!205}
!205 = distinct !{!205, !206, !"scope"}
!206 = distinct !{!206, !"scope"}
!207 = !{!208}
!208 = distinct !{!208, !209, !"scope"}
!209 = distinct !{!209, !"scope"}
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
!222 = !{!223}
!223 = distinct !{!223, !224, !"scope"}
!224 = distinct !{!224, !"scope"}
!225 = !{!226}
!226 = distinct !{!226, !227, !"scope"}
!227 = distinct !{!227, !"scope"}
!228 = !{!229}
!229 = distinct !{!229, !230, !"scope"}
!230 = distinct !{!230, !"scope"}
!231 = !{!232}
!232 = distinct !{!232, !233, !"scope"}
!233 = distinct !{!233, !"scope"}
!234 = !{!235, !237}
!235 = distinct !{!235, !236, !"scope"}
!236 = distinct !{!236, !"scope"}
!237 = distinct !{!237, !238, !"scope"}
!238 = distinct !{!238, !"scope"}
!239 = !{!237}
!240 = !{!241, !237}
!241 = distinct !{!241, !242, !"scope"}
!242 = distinct !{!242, !"scope"}
!243 = !{!244, !237}
!244 = distinct !{!244, !245, !"scope"}
!245 = distinct !{!245, !"scope"}
!246 = !{!247, !237}
!247 = distinct !{!247, !248, !"scope"}
!248 = distinct !{!248, !"scope"}
!249 = !{!250, !252}
!250 = distinct !{!250, !251, !"scope"}
!251 = distinct !{!251, !"scope"}
!252 = distinct !{!252, !253, !"scope"}
!253 = distinct !{!253, !"scope"}
!254 = !{!252}
!255 = !{!256, !258}
!256 = distinct !{!256, !257, !"scope"}
!257 = distinct !{!257, !"scope"}
!258 = distinct !{!258, !259, !"scope"}
!259 = distinct !{!259, !"scope"}
!260 = !{!258}
!261 = !{!262, !264}
!262 = distinct !{!262, !263, !"scope"}
!263 = distinct !{!263, !"scope"}
!264 = distinct !{!264, !265, !"scope"}
!265 = distinct !{!265, !"scope"}
!266 = !{!264}
!267 = !{!268}
!268 = distinct !{!268, !269, !"scope"}
!269 = distinct !{!269, !"scope"}
!270 = !{!271, !273}
!271 = distinct !{!271, !272, !"scope"}
!272 = distinct !{!272, !"scope"}
!273 = distinct !{!273, !274, !"scope"}
!274 = distinct !{!274, !"scope"}
!275 = !{!273}
!276 = !{!277}
!277 = distinct !{!277, !278, !"scope"}
!278 = distinct !{!278, !"scope"}
!279 = !{!280}
!280 = distinct !{!280, !281, !"scope"}
!281 = distinct !{!281, !"scope"}
!282 = !{!283, !285}
!283 = distinct !{!283, !284, !"scope"}
!284 = distinct !{!284, !"scope"}
!285 = distinct !{!285, !286, !"scope"}
!286 = distinct !{!286, !"scope"}
!287 = !{!285}
!288 = !{!289, !285}
!289 = distinct !{!289, !290, !"scope"}
!290 = distinct !{!290, !"scope"}
!291 = !{!292}
!292 = distinct !{!292, !293, !"scope"}
!293 = distinct !{!293, !"scope"}
!294 = !{!295}
!295 = distinct !{!295, !296, !"scope"}
!296 = distinct !{!296, !"scope"}
!297 = !{!298}
!298 = distinct !{!298, !299, !"scope"}
!299 = distinct !{!299, !"scope"}
!300 = !{!301, !303}
!301 = distinct !{!301, !302, !"scope"}
!302 = distinct !{!302, !"scope"}
!303 = distinct !{!303, !304, !"scope"}
!304 = distinct !{!304, !"scope"}
!305 = !{!303}
!306 = !{!307, !309}
!307 = distinct !{!307, !308, !"scope"}
!308 = distinct !{!308, !"scope"}
!309 = distinct !{!309, !310, !"scope"}
!310 = distinct !{!310, !"scope"}
!311 = !{!309}
!312 = !{!313}
!313 = distinct !{!313, !314, !"scope"}
!314 = distinct !{!314, !"scope"}
!315 = !{!316}
!316 = distinct !{!316, !317, !"scope"}
!317 = distinct !{!317, !"scope"}
!318 = !{!319, !321, !323, !325}
!319 = distinct !{!319, !320, !"scope"}
!320 = distinct !{!320, !"scope"}
!321 = distinct !{!321, !322, !"scope"}
!322 = distinct !{!322, !"scope"}
!323 = distinct !{!323, !324, !"scope"}
!324 = distinct !{!324, !"scope"}
!325 = distinct !{!325, !326, !"scope"}
!326 = distinct !{!326, !"scope"}
!327 = !{!321, !323, !325}
!328 = !{!323, !325}
!329 = !{!325}
!330 = !{!331}
!331 = distinct !{!331, !332, !"scope"}
!332 = distinct !{!332, !"scope"}
!333 = !{!334}
!334 = distinct !{!334, !335, !"scope"}
!335 = distinct !{!335, !"scope"}
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
!354 = !{!355, !357}
!355 = distinct !{!355, !356, !"scope"}
!356 = distinct !{!356, !"scope"}
!357 = distinct !{!357, !358, !"scope"}
!358 = distinct !{!358, !"scope"}
!359 = !{!357}
!360 = !{!361, !357}
!361 = distinct !{!361, !362, !"scope"}
!362 = distinct !{!362, !"scope"}
!363 = !{!364, !357}
!364 = distinct !{!364, !365, !"scope"}
!365 = distinct !{!365, !"scope"}
!366 = !{!367}
!367 = distinct !{!367, !368, !"scope"}
!368 = distinct !{!368, !"scope"}
!369 = !{!370, !372}
!370 = distinct !{!370, !371, !"scope"}
!371 = distinct !{!371, !"scope"}
!372 = distinct !{!372, !373, !"scope"}
!373 = distinct !{!373, !"scope"}
!374 = !{!375}
!375 = distinct !{!375, !376, !"scope"}
!376 = distinct !{!376, !"scope"}
!377 = !{!378, !375}
!378 = distinct !{!378, !379, !"scope"}
!379 = distinct !{!379, !"scope"}
!380 = !{!381, !375}
!381 = distinct !{!381, !382, !"scope"}
!382 = distinct !{!382, !"scope"}
!383 = !{!384, !375}
!384 = distinct !{!384, !385, !"scope"}
!385 = distinct !{!385, !"scope"}
!386 = !{!387, !384, !375}
!387 = distinct !{!387, !388, !"scope"}
!388 = distinct !{!388, !"scope"}
!389 = !{!390, !384, !375}
!390 = distinct !{!390, !391, !"scope"}
!391 = distinct !{!391, !"scope"}
!392 = !{!393, !384, !375}
!393 = distinct !{!393, !394, !"scope"}
!394 = distinct !{!394, !"scope"}
!395 = !{!396, !384, !375}
!396 = distinct !{!396, !397, !"scope"}
!397 = distinct !{!397, !"scope"}
!398 = !{!399, !384, !375}
!399 = distinct !{!399, !400, !"scope"}
!400 = distinct !{!400, !"scope"}
!401 = !{!402, !384, !375}
!402 = distinct !{!402, !403, !"scope"}
!403 = distinct !{!403, !"scope"}
!404 = !{!405, !402, !384, !375}
!405 = distinct !{!405, !406, !"scope"}
!406 = distinct !{!406, !"scope"}
!407 = !{!408, !402, !384, !375}
!408 = distinct !{!408, !409, !"scope"}
!409 = distinct !{!409, !"scope"}
!410 = !{!411, !408, !402, !384, !375}
!411 = distinct !{!411, !412, !"scope"}
!412 = distinct !{!412, !"scope"}
!413 = !{!414, !402, !384, !375}
!414 = distinct !{!414, !415, !"scope"}
!415 = distinct !{!415, !"scope"}
!416 = !{!417, !414, !402, !384, !375}
!417 = distinct !{!417, !418, !"scope"}
!418 = distinct !{!418, !"scope"}
!419 = !{!420, !422, !414, !402, !384, !375}
!420 = distinct !{!420, !421, !"scope"}
!421 = distinct !{!421, !"scope"}
!422 = distinct !{!422, !423, !"scope"}
!423 = distinct !{!423, !"scope"}
!424 = !{!422, !414, !402, !384, !375}
!425 = !{!426, !384, !375}
!426 = distinct !{!426, !427, !"scope"}
!427 = distinct !{!427, !"scope"}
!428 = !{!429, !431, !426, !384, !375}
!429 = distinct !{!429, !430, !"scope"}
!430 = distinct !{!430, !"scope"}
!431 = distinct !{!431, !432, !"scope"}
!432 = distinct !{!432, !"scope"}
!433 = !{!434, !431, !426, !384, !375}
!434 = distinct !{!434, !435, !"scope"}
!435 = distinct !{!435, !"scope"}
!436 = !{!437, !431, !426, !384, !375}
!437 = distinct !{!437, !438, !"scope"}
!438 = distinct !{!438, !"scope"}
!439 = !{!440, !431, !426, !384, !375}
!440 = distinct !{!440, !441, !"scope"}
!441 = distinct !{!441, !"scope"}
!442 = !{!431, !426, !384, !375}
!443 = !{!444, !431, !426, !384, !375}
!444 = distinct !{!444, !445, !"scope"}
!445 = distinct !{!445, !"scope"}
!446 = !{!447, !426, !384, !375}
!447 = distinct !{!447, !448, !"scope"}
!448 = distinct !{!448, !"scope"}
!449 = !{!450, !426, !384, !375}
!450 = distinct !{!450, !451, !"scope"}
!451 = distinct !{!451, !"scope"}
!452 = !{!453, !450, !426, !384, !375}
!453 = distinct !{!453, !454, !"scope"}
!454 = distinct !{!454, !"scope"}
!455 = !{!456, !426, !384, !375}
!456 = distinct !{!456, !457, !"scope"}
!457 = distinct !{!457, !"scope"}
!458 = !{!459, !456, !426, !384, !375}
!459 = distinct !{!459, !460, !"scope"}
!460 = distinct !{!460, !"scope"}
!461 = !{!462, !464, !456, !426, !384, !375}
!462 = distinct !{!462, !463, !"scope"}
!463 = distinct !{!463, !"scope"}
!464 = distinct !{!464, !465, !"scope"}
!465 = distinct !{!465, !"scope"}
!466 = !{!464, !456, !426, !384, !375}
!467 = !{!468, !384, !375}
!468 = distinct !{!468, !469, !"scope"}
!469 = distinct !{!469, !"scope"}
!470 = !{!471, !384, !375}
!471 = distinct !{!471, !472, !"scope"}
!472 = distinct !{!472, !"scope"}
!473 = !{!474, !384, !375}
!474 = distinct !{!474, !475, !"scope"}
!475 = distinct !{!475, !"scope"}
!476 = !{!477, !474, !384, !375}
!477 = distinct !{!477, !478, !"scope"}
!478 = distinct !{!478, !"scope"}
!479 = !{!480, !474, !384, !375}
!480 = distinct !{!480, !481, !"scope"}
!481 = distinct !{!481, !"scope"}
!482 = !{!483, !485, !474, !384, !375}
!483 = distinct !{!483, !484, !"scope"}
!484 = distinct !{!484, !"scope"}
!485 = distinct !{!485, !486, !"scope"}
!486 = distinct !{!486, !"scope"}
!487 = !{!485, !474, !384, !375}
!488 = !{!489, !485, !474, !384, !375}
!489 = distinct !{!489, !490, !"scope"}
!490 = distinct !{!490, !"scope"}
!491 = !{!492, !384, !375}
!492 = distinct !{!492, !493, !"scope"}
!493 = distinct !{!493, !"scope"}
!494 = !{!495, !384, !375}
!495 = distinct !{!495, !496, !"scope"}
!496 = distinct !{!496, !"scope"}
!497 = !{!498, !384, !375}
!498 = distinct !{!498, !499, !"scope"}
!499 = distinct !{!499, !"scope"}
!500 = !{!501, !498, !384, !375}
!501 = distinct !{!501, !502, !"scope"}
!502 = distinct !{!502, !"scope"}
!503 = !{!504, !498, !384, !375}
!504 = distinct !{!504, !505, !"scope"}
!505 = distinct !{!505, !"scope"}
!506 = !{!507, !498, !384, !375}
!507 = distinct !{!507, !508, !"scope"}
!508 = distinct !{!508, !"scope"}
!509 = !{!510, !498, !384, !375}
!510 = distinct !{!510, !511, !"scope"}
!511 = distinct !{!511, !"scope"}
!512 = !{!513, !498, !384, !375}
!513 = distinct !{!513, !514, !"scope"}
!514 = distinct !{!514, !"scope"}
