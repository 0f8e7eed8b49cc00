; made from integrator.py, stepping.py, job.py, rosenbrock.py, sha256 9057149d4efce3294ab5413f3ec0eb1ba01b277ad556d4122ed525370a15d6c6
@switch.table.integrate = private unnamed_addr constant [4 x double] [double 3.860000e-01, double 2.100000e-01, double 6.300000e-01, double 1.000000e+00], align 8
declare double @llvm.fabs.f64(double)
define internal fastcc void @v44(ptr noalias nonnull writeonly %retptr, i64 %arg.run.0.4, ptr %arg.run.1.0.4, i64 %arg.run.1.1.2, ptr %arg.run.1.1.4, ptr readonly %arg.run.1.2.4, i64 %arg.run.1.3.2, ptr %arg.run.1.3.4, ptr %arg.run.1.4.4, i64 %arg.run.5.0.2, ptr %arg.run.5.0.4, ptr %arg.run.5.3.4, double %arg.segment.0, ptr readonly %arg.segment.2.4, i64 %arg.segment.2.5.1, double %arg.t, ptr %arg.x.4) unnamed_addr {
entry:
  %.5.i = fmul double %arg.t, 0x3D06849B86A12B9B
  %.6.i = fadd double %.5.i, 1.000000e-15
  %.765 = fadd double %arg.t, %.6.i
  %.164126.not.i = icmp sgt i64 %arg.run.1.3.2, 0
  br i1 %.164126.not.i, label %B78.if.i, label %_ZN6poppet6engine8stepping12next_instantB3v16B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE199Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit
B78.if.i:
  %first.2.0129.i = phi double [ %.13.i.i, %B78.if.i ], [ 0x7FF0000000000000, %entry ]
  %.106.0128.i = phi i64 [ %.177.i, %B78.if.i ], [ 0, %entry ]
  %.177.i = add nuw nsw i64 %.106.0128.i, 1
  %0 = getelementptr double, ptr %arg.run.1.1.4, i64 %.106.0128.i
  %.235.i = load double, ptr %0, align 8, !noalias !0
  %.12.i.i = fcmp olt double %.235.i, %first.2.0129.i
  %.13.i.i = select i1 %.12.i.i, double %.235.i, double %first.2.0129.i
  %exitcond.not.i = icmp eq i64 %arg.run.1.3.2, %.177.i
  br i1 %exitcond.not.i, label %_ZN6poppet6engine8stepping12next_instantB3v16B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE199Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit, label %B78.if.i
_ZN6poppet6engine8stepping12next_instantB3v16B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE199Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit:
  %first.2.0.lcssa.i = phi double [ 0x7FF0000000000000, %entry ], [ %.13.i.i, %B78.if.i ]
  %.806 = fcmp ugt double %first.2.0.lcssa.i, %.765
  br i1 %.806, label %B626, label %B112.preheader
B112.preheader:
  %.40.i = fsub double %arg.t, %arg.segment.0
  %.151223.not.i = icmp slt i64 %arg.run.5.0.2, 1
  %.1203 = inttoptr i64 %arg.run.0.4 to ptr
  %.13131568.not = icmp slt i64 %arg.run.1.1.2, 1
  br label %B112
B112:
  %changed.4.0 = phi i1 [ %changed.3.1.lcssa, %_ZN6poppet6engine8stepping12next_instantB3v16B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE199Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit1562 ], [ false, %B112.preheader ]
  br i1 %.164126.not.i, label %B162.if, label %B226
B226:
  store double %arg.t, ptr %arg.run.5.3.4, align 8
  br i1 %.151223.not.i, label %_ZN6poppet6engine8stepping9inputs_atB3v18B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd72Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_295ArrayIdLi1E1C7mutable7alignedE.exit, label %B78.if.i1550
B158.i:
  %.423.i = getelementptr i8, ptr %.245.i, i64 24
  %.424.i = load double, ptr %.423.i, align 8, !noalias !3
  %.478.i = getelementptr i8, ptr %.245.i, i64 32
  %.479.i = load double, ptr %.478.i, align 8, !noalias !3
  %.480.i = fmul double %.479.i, 5.000000e-01
  %.482.i = fmul double %.40.i, %.480.i
  %.483.i = fadd double %.424.i, %.482.i
  %.484.i = fmul double %.483.i, 0x401921FB54442D18
  %.486.i = fmul double %.40.i, %.484.i
  %.540.i = getelementptr i8, ptr %.245.i, i64 40
  %.541.i = load double, ptr %.540.i, align 8, !noalias !3
  %.542.i = fadd double %.541.i, %.486.i
  %.605.le.i = tail call double @llvm.sin.f64(double %.542.i)
  %.610.i = fmul double %.366.i, %.605.le.i
  %.612.i = fadd double %.304.i, %.610.i
  br label %B340.i
B340.i:
  %value.2.1.i = phi double [ %.612.i, %B158.i ], [ %.304.i, %B78.if.i1550 ]
  %1 = getelementptr double, ptr %arg.run.5.0.4, i64 %.93.0224.i
  store double %value.2.1.i, ptr %1, align 8, !noalias !3
  %exitcond.not.i1551 = icmp eq i64 %arg.run.5.0.2, %.164.i
  br i1 %exitcond.not.i1551, label %_ZN6poppet6engine8stepping9inputs_atB3v18B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd72Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_295ArrayIdLi1E1C7mutable7alignedE.exit, label %B78.if.i1550
B78.if.i1550:
  %.93.0224.i = phi i64 [ %.164.i, %B340.i ], [ 0, %B226 ]
  %.164.i = add nuw nsw i64 %.93.0224.i, 1
  %.241.i = mul i64 %.93.0224.i, %arg.segment.2.5.1
  %.245.i = getelementptr double, ptr %arg.segment.2.4, i64 %.241.i
  %.246.i = load double, ptr %.245.i, align 8, !noalias !3
  %.300.i = getelementptr i8, ptr %.245.i, i64 8
  %.301.i = load double, ptr %.300.i, align 8, !noalias !3
  %.303.i = fmul double %.40.i, %.301.i
  %.304.i = fadd double %.246.i, %.303.i
  %.365.i = getelementptr i8, ptr %.245.i, i64 16
  %.366.i = load double, ptr %.365.i, align 8, !noalias !3
  %.367.i = fcmp une double %.366.i, 0.000000e+00
  br i1 %.367.i, label %B158.i, label %B340.i
_ZN6poppet6engine8stepping9inputs_atB3v18B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd72Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_295ArrayIdLi1E1C7mutable7alignedE.exit:
  tail call void %.1203(ptr nonnull %arg.run.5.3.4, ptr %arg.x.4, ptr %arg.run.5.0.4, ptr %arg.run.1.0.4, ptr %arg.run.1.3.4, ptr %arg.run.1.4.4)
  br i1 %.13131568.not, label %B586, label %B452.if
B482:
  %2 = getelementptr double, ptr %arg.run.1.1.4, i64 %.1257.01569
  %.1475 = load double, ptr %2, align 8
  %.1479 = fcmp une double %.1523.pre, %.1475
  br i1 %.1479, label %B538, label %B542
B538:
  br label %B542
B542:
  %changed.5.2 = phi i1 [ true, %B538 ], [ %changed.3.11571, %B482 ], [ %changed.3.11571, %B452.if ]
  %3 = getelementptr double, ptr %arg.run.1.1.4, i64 %.1257.01569
  store double %.1523.pre, ptr %3, align 8
  %exitcond1572.not = icmp eq i64 %arg.run.1.1.2, %.1326
  br i1 %exitcond1572.not, label %B586, label %B452.if
B586:
  %changed.3.1.lcssa = phi i1 [ %changed.4.0, %_ZN6poppet6engine8stepping9inputs_atB3v18B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd72Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_295ArrayIdLi1E1C7mutable7alignedE.exit ], [ %changed.5.2, %B542 ]
  br i1 %.164126.not.i, label %B78.if.i1553, label %_ZN6poppet6engine8stepping12next_instantB3v16B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE199Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit1562
B78.if.i1553:
  %first.2.0129.i1554 = phi double [ %.13.i.i1559, %B78.if.i1553 ], [ 0x7FF0000000000000, %B586 ]
  %.106.0128.i1555 = phi i64 [ %.177.i1556, %B78.if.i1553 ], [ 0, %B586 ]
  %.177.i1556 = add nuw nsw i64 %.106.0128.i1555, 1
  %4 = getelementptr double, ptr %arg.run.1.1.4, i64 %.106.0128.i1555
  %.235.i1557 = load double, ptr %4, align 8, !noalias !6
  %.12.i.i1558 = fcmp olt double %.235.i1557, %first.2.0129.i1554
  %.13.i.i1559 = select i1 %.12.i.i1558, double %.235.i1557, double %first.2.0129.i1554
  %exitcond.not.i1560 = icmp eq i64 %arg.run.1.3.2, %.177.i1556
  br i1 %exitcond.not.i1560, label %_ZN6poppet6engine8stepping12next_instantB3v16B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE199Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit1562, label %B78.if.i1553
_ZN6poppet6engine8stepping12next_instantB3v16B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE199Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit1562:
  %first.2.0.lcssa.i1561 = phi double [ 0x7FF0000000000000, %B586 ], [ %.13.i.i1559, %B78.if.i1553 ]
  %.1617 = fcmp ugt double %first.2.0.lcssa.i1561, %.765
  br i1 %.1617, label %B626.loopexit, label %B112
B626.loopexit:
  %5 = zext i1 %changed.3.1.lcssa to i8
  br label %B626
B626:
  %changed.2.1 = phi i8 [ 0, %_ZN6poppet6engine8stepping12next_instantB3v16B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE199Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit ], [ %5, %B626.loopexit ]
  store i8 %changed.2.1, ptr %retptr, align 1
  ret void
B162.if:
  %.850.01567 = phi i64 [ %.919, %B162.if ], [ 0, %B112 ]
  %.919 = add nuw nsw i64 %.850.01567, 1
  %6 = getelementptr double, ptr %arg.run.1.1.4, i64 %.850.01567
  %.981 = load double, ptr %6, align 8
  %.986 = fcmp ugt double %.981, %.765
  %. = select i1 %.986, double 0.000000e+00, double 1.000000e+00
  %7 = getelementptr double, ptr %arg.run.1.3.4, i64 %.850.01567
  store double %., ptr %7, align 8
  %exitcond.not = icmp eq i64 %arg.run.1.3.2, %.919
  br i1 %exitcond.not, label %B226, label %B162.if
B452.if:
  %changed.3.11571 = phi i1 [ %changed.5.2, %B542 ], [ %changed.4.0, %_ZN6poppet6engine8stepping9inputs_atB3v18B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd72Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_295ArrayIdLi1E1C7mutable7alignedE.exit ]
  %.1257.01569 = phi i64 [ %.1326, %B542 ], [ 0, %_ZN6poppet6engine8stepping9inputs_atB3v18B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd72Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_295ArrayIdLi1E1C7mutable7alignedE.exit ]
  %.1326 = add nuw nsw i64 %.1257.01569, 1
  %8 = getelementptr i8, ptr %arg.run.1.2.4, i64 %.1257.01569
  %.1392 = load i8, ptr %8, align 1
  %.1396.not = icmp eq i8 %.1392, 0
  %.phi.trans.insert = getelementptr double, ptr %arg.run.1.4.4, i64 %.1257.01569
  %.1523.pre = load double, ptr %.phi.trans.insert, align 8
  br i1 %.1396.not, label %B542, label %B482
}
declare double @llvm.sin.f64(double)
declare double @llvm.pow.f64(double, double)
define internal fastcc void @v45(ptr noalias nonnull writeonly %retptr, i64 %arg.run.0.3, ptr %arg.run.1.0.4, ptr %arg.run.3.2.4, ptr readonly %arg.run.4.0.4, i64 %arg.run.4.0.5.1, ptr readonly %arg.run.4.1.4, i64 %arg.run.4.1.5.0, i64 %arg.run.4.1.5.1, i64 %arg.run.5.0.2, ptr %arg.run.5.0.4, ptr %arg.run.5.3.4, ptr readonly %arg.run.5.11.4, i64 %arg.run.5.11.5.0, i64 %arg.run.5.12.2, ptr %arg.run.5.12.4, i64 %arg.run.6.2, ptr readonly %arg.run.6.4, double %arg.segment.0, ptr readonly %arg.segment.2.4, i64 %arg.segment.2.5.1, double %arg.step.0, double %arg.step.1, ptr readonly %arg.step.3.4) unnamed_addr {
entry:
  %.703768.not.i = icmp slt i64 %arg.run.5.12.2, 1
  %.151223.not.i.i.i = icmp slt i64 %arg.run.5.0.2, 1
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
  br i1 %.703768.not.i, label %_ZN6poppet6engine8stepping11interpolateB3v35B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2982Step_28float64_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d, label %B102.if.i
B102.if.i:
  %.645.0769.i = phi i64 [ %.716.i, %B102.if.i ], [ 0, %B48 ]
  %.716.i = add nuw nsw i64 %.645.0769.i, 1
  %0 = getelementptr double, ptr %arg.run.6.4, i64 %.645.0769.i
  %.774.i = load double, ptr %0, align 8, !noalias !9
  %.779.i = fmul double %.478.i, %.774.i
  %1 = getelementptr double, ptr %arg.step.3.4, i64 %.645.0769.i
  %.813.i = load double, ptr %1, align 8, !noalias !9
  %2 = getelementptr double, ptr %arg.run.5.11.4, i64 %.645.0769.i
  %.846.i = load double, ptr %2, align 8, !noalias !9
  %.848.i = add nsw i64 %.645.0769.i, %arg.run.6.2
  %.862.i = icmp slt i64 %.848.i, 0
  %.863.i = select i1 %.862.i, i64 %arg.run.5.11.5.0, i64 0
  %3 = getelementptr double, ptr %arg.run.5.11.4, i64 %.848.i
  %.877.i = getelementptr double, ptr %3, i64 %.863.i
  %.878.i = load double, ptr %.877.i, align 8, !noalias !9
  %.880.i = fmul double %high.3.1, %.878.i
  %.881.i = fadd double %.846.i, %.880.i
  %.883.i = fmul double %.478.i, %.881.i
  %.884.i = fadd double %.813.i, %.883.i
  %.886.i = fmul double %high.3.1, %.884.i
  %.887.i = fadd double %.779.i, %.886.i
  %4 = getelementptr double, ptr %arg.run.5.12.4, i64 %.645.0769.i
  store double %.887.i, ptr %4, align 8, !noalias !9
  %exitcond.not.i = icmp eq i64 %arg.run.5.12.2, %.716.i
  br i1 %exitcond.not.i, label %_ZN6poppet6engine8stepping11interpolateB3v35B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2982Step_28float64_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d, label %B102.if.i
_ZN6poppet6engine8stepping11interpolateB3v35B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2982Step_28float64_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d:
  %.796 = fmul double %arg.step.1, %high.3.1
  %.797 = fadd double %arg.step.0, %.796
  %.40.i.i.i = fsub double %.797, %arg.segment.0
  br i1 %.151223.not.i.i.i, label %_ZN6poppet6engine8stepping10outputs_atB3v20B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_, label %B78.if.i.i.i
B158.i.i.i:
  %.423.i.i.i = getelementptr i8, ptr %.245.i.i.i, i64 24
  %.424.i.i.i = load double, ptr %.423.i.i.i, align 8, !noalias !12
  %.478.i.i.i = getelementptr i8, ptr %.245.i.i.i, i64 32
  %.479.i.i.i = load double, ptr %.478.i.i.i, align 8, !noalias !12
  %.480.i.i.i = fmul double %.479.i.i.i, 5.000000e-01
  %.482.i.i.i = fmul double %.40.i.i.i, %.480.i.i.i
  %.483.i.i.i = fadd double %.424.i.i.i, %.482.i.i.i
  %.484.i.i.i = fmul double %.483.i.i.i, 0x401921FB54442D18
  %.486.i.i.i = fmul double %.40.i.i.i, %.484.i.i.i
  %.540.i.i.i = getelementptr i8, ptr %.245.i.i.i, i64 40
  %.541.i.i.i = load double, ptr %.540.i.i.i, align 8, !noalias !12
  %.542.i.i.i = fadd double %.541.i.i.i, %.486.i.i.i
  %.605.le.i.i.i = tail call double @llvm.sin.f64(double %.542.i.i.i)
  %.610.i.i.i = fmul double %.366.i.i.i, %.605.le.i.i.i
  %.612.i.i.i = fadd double %.304.i.i.i, %.610.i.i.i
  br label %B340.i.i.i
B340.i.i.i:
  %value.2.1.i.i.i = phi double [ %.612.i.i.i, %B158.i.i.i ], [ %.304.i.i.i, %B78.if.i.i.i ]
  %5 = getelementptr double, ptr %arg.run.5.0.4, i64 %.93.0224.i.i.i
  store double %value.2.1.i.i.i, ptr %5, align 8, !noalias !12
  %exitcond.not.i.i.i = icmp eq i64 %arg.run.5.0.2, %.164.i.i.i
  br i1 %exitcond.not.i.i.i, label %_ZN6poppet6engine8stepping10outputs_atB3v20B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_, label %B78.if.i.i.i
B78.if.i.i.i:
  %.93.0224.i.i.i = phi i64 [ %.164.i.i.i, %B340.i.i.i ], [ 0, %_ZN6poppet6engine8stepping11interpolateB3v35B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2982Step_28float64_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d ]
  %.164.i.i.i = add nuw nsw i64 %.93.0224.i.i.i, 1
  %.241.i.i.i = mul i64 %.93.0224.i.i.i, %arg.segment.2.5.1
  %.245.i.i.i = getelementptr double, ptr %arg.segment.2.4, i64 %.241.i.i.i
  %.246.i.i.i = load double, ptr %.245.i.i.i, align 8, !noalias !12
  %.300.i.i.i = getelementptr i8, ptr %.245.i.i.i, i64 8
  %.301.i.i.i = load double, ptr %.300.i.i.i, align 8, !noalias !12
  %.303.i.i.i = fmul double %.40.i.i.i, %.301.i.i.i
  %.304.i.i.i = fadd double %.246.i.i.i, %.303.i.i.i
  %.365.i.i.i = getelementptr i8, ptr %.245.i.i.i, i64 16
  %.366.i.i.i = load double, ptr %.365.i.i.i, align 8, !noalias !12
  %.367.i.i.i = fcmp une double %.366.i.i.i, 0.000000e+00
  br i1 %.367.i.i.i, label %B158.i.i.i, label %B340.i.i.i
_ZN6poppet6engine8stepping10outputs_atB3v20B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_:
  store double %.797, ptr %arg.run.5.3.4, align 8, !noalias !19
  tail call void %.992.i.i(ptr nonnull %arg.run.5.3.4, ptr %arg.run.5.12.4, ptr %arg.run.5.0.4, ptr %arg.run.1.0.4, ptr %arg.run.3.2.4), !noalias !19
  br label %B140.i
B140.i:
  %.859.0.i = phi i64 [ 0, %_ZN6poppet6engine8stepping10outputs_atB3v20B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_ ], [ %.928.i, %B288.i ]
  %exitcond294.not.i = icmp eq i64 %.859.0.i, %spec.select.i
  br i1 %exitcond294.not.i, label %_ZN6poppet6engine8stepping14stop_conditionB3v19B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C, label %B142.i
B142.i:
  %.1005.i = mul i64 %.859.0.i, %arg.run.4.1.5.1
  %6 = getelementptr double, ptr %arg.run.4.1.4, i64 %.1005.i
  %.1009.i = getelementptr i8, ptr %6, i64 16
  %.1010.i = load double, ptr %.1009.i, align 8, !noalias !20
  %.1186.i = mul i64 %.859.0.i, %arg.run.4.0.5.1
  %7 = getelementptr i64, ptr %arg.run.4.0.4, i64 %.1186.i
  br label %B194.if.i
B226.i:
  %8 = getelementptr double, ptr %6, i64 %.1037.0289.i
  %.1249.i = load double, ptr %8, align 8, !noalias !20
  %.1338.i = getelementptr double, ptr %arg.run.3.2.4, i64 %.1191.i
  %.1339.i = load double, ptr %.1338.i, align 8, !noalias !20
  %.1340.i = fmul double %.1249.i, %.1339.i
  %.1342.i = fadd double %value.2.1291.i, %.1340.i
  br label %B286.i
B286.i:
  %value.3.2.i = phi double [ %.1342.i, %B226.i ], [ %value.2.1291.i, %B194.if.i ]
  br i1 %exitcond.not.i1267, label %B288.i, label %B194.if.i
B288.i:
  %.928.i = add nuw i64 %.859.0.i, 1
  %.1361.i = fcmp ogt double %value.3.2.i, 0.000000e+00
  br i1 %.1361.i, label %_ZN6poppet6engine8stepping14stop_conditionB3v19B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C, label %B140.i
B194.if.i:
  %value.2.1291.i = phi double [ %.1010.i, %B142.i ], [ %value.3.2.i, %B286.i ]
  %exitcond.not.i1267 = phi i1 [ false, %B142.i ], [ true, %B286.i ]
  %.1037.0289.i = phi i64 [ 0, %B142.i ], [ 1, %B286.i ]
  %9 = getelementptr i64, ptr %7, i64 %.1037.0289.i
  %.1191.i = load i64, ptr %9, align 8, !noalias !20
  %.1194.i = icmp sgt i64 %.1191.i, -1
  br i1 %.1194.i, label %B226.i, label %B286.i
_ZN6poppet6engine8stepping14stop_conditionB3v19B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C:
  %storemerge280.i = phi i64 [ %.859.0.i, %B288.i ], [ -1, %B140.i ]
  %10 = and i64 %storemerge280.i, %event.2.1
  %or.cond.not = icmp sgt i64 %10, -1
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
  %11 = getelementptr double, ptr %arg.run.6.4, i64 %.645.0769.i1271
  %.774.i1273 = load double, ptr %11, align 8, !noalias !21
  %.779.i1274 = fmul double %.478.i1268, %.774.i1273
  %12 = getelementptr double, ptr %arg.step.3.4, i64 %.645.0769.i1271
  %.813.i1275 = load double, ptr %12, align 8, !noalias !21
  %13 = getelementptr double, ptr %arg.run.5.11.4, i64 %.645.0769.i1271
  %.846.i1276 = load double, ptr %13, align 8, !noalias !21
  %.848.i1277 = add nsw i64 %.645.0769.i1271, %arg.run.6.2
  %.862.i1278 = icmp slt i64 %.848.i1277, 0
  %.863.i1279 = select i1 %.862.i1278, i64 %arg.run.5.11.5.0, i64 0
  %14 = getelementptr double, ptr %arg.run.5.11.4, i64 %.848.i1277
  %.877.i1280 = getelementptr double, ptr %14, i64 %.863.i1279
  %.878.i1281 = load double, ptr %.877.i1280, align 8, !noalias !21
  %.880.i1282 = fmul double %high.3.1.theta.2.1, %.878.i1281
  %.881.i1283 = fadd double %.846.i1276, %.880.i1282
  %.883.i1284 = fmul double %.478.i1268, %.881.i1283
  %.884.i1285 = fadd double %.813.i1275, %.883.i1284
  %.886.i1286 = fmul double %high.3.1.theta.2.1, %.884.i1285
  %.887.i1287 = fadd double %.779.i1274, %.886.i1286
  %15 = getelementptr double, ptr %arg.run.5.12.4, i64 %.645.0769.i1271
  store double %.887.i1287, ptr %15, align 8, !noalias !21
  %exitcond.not.i1288 = icmp eq i64 %arg.run.5.12.2, %.716.i1272
  br i1 %exitcond.not.i1288, label %common.ret, label %B102.if.i1270
}
define internal fastcc void @v46(ptr noalias nonnull writeonly %retptr, i64 %arg.run.0.3, i64 %arg.run.0.4, ptr %arg.run.1.0.4, i64 %arg.run.1.1.2, ptr %arg.run.1.1.4, ptr readonly %arg.run.1.2.4, i64 %arg.run.1.3.2, ptr %arg.run.1.3.4, ptr %arg.run.1.4.4, i64 %arg.run.2.1.2, i64 %arg.run.3.0.2, ptr readonly %arg.run.3.0.4, i64 %arg.run.3.0.5.0, ptr writeonly %arg.run.3.1.4, i64 %arg.run.3.1.5.1, i64 %arg.run.3.2.2, ptr %arg.run.3.2.4, i64 %arg.run.5.0.2, ptr %arg.run.5.0.4, ptr %arg.run.5.3.4, ptr %arg.run.5.6.4, i64 %arg.run.5.6.5.0, ptr readonly %arg.run.5.11.4, i64 %arg.run.5.11.5.0, i64 %arg.run.5.12.2, ptr %arg.run.5.12.4, i64 %arg.run.6.2, ptr readonly %arg.run.6.4, ptr %arg.run.9.4, double %arg.segment.0, ptr readonly %arg.segment.2.4, i64 %arg.segment.2.5.1, double %arg.step.0, double %arg.step.1, double %arg.step.2, ptr readonly %arg.step.3.4) unnamed_addr {
entry:
  %.729 = alloca ptr, align 8
  %.1201 = alloca i8, align 1
  %.164126.not.i = icmp slt i64 %arg.run.1.3.2, 1
  %.5.i = fmul double %arg.step.2, 0x3D06849B86A12B9B
  %.6.i = fadd double %.5.i, 1.000000e-15
  %.584 = fsub double %arg.step.2, %.6.i
  %.703768.not.i = icmp slt i64 %arg.run.5.12.2, 1
  br label %B6
B6:
  br i1 %.164126.not.i, label %_ZN6poppet6engine8stepping12next_instantB3v16B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE199Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit, label %B78.if.i
B78.if.i:
  %first.2.0129.i = phi double [ %.13.i.i, %B78.if.i ], [ 0x7FF0000000000000, %B6 ]
  %.106.0128.i = phi i64 [ %.177.i, %B78.if.i ], [ 0, %B6 ]
  %.177.i = add nuw nsw i64 %.106.0128.i, 1
  %0 = getelementptr double, ptr %arg.run.1.1.4, i64 %.106.0128.i
  %.235.i = load double, ptr %0, align 8, !noalias !24
  %.12.i.i = fcmp olt double %.235.i, %first.2.0129.i
  %.13.i.i = select i1 %.12.i.i, double %.235.i, double %first.2.0129.i
  %exitcond.not.i = icmp eq i64 %arg.run.1.3.2, %.177.i
  br i1 %exitcond.not.i, label %_ZN6poppet6engine8stepping12next_instantB3v16B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE199Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit, label %B78.if.i
_ZN6poppet6engine8stepping12next_instantB3v16B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE199Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit:
  %first.2.0.lcssa.i = phi double [ 0x7FF0000000000000, %B6 ], [ %.13.i.i, %B78.if.i ]
  %.586 = fcmp ult double %first.2.0.lcssa.i, %.584
  br i1 %.586, label %B124, label %common.ret
common.ret:
  %storemerge = phi double [ %arg.step.2, %_ZN6poppet6engine8stepping12next_instantB3v16B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE199Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit ], [ %first.2.0.lcssa.i, %_ZN6poppet6engine8stepping11interpolateB3v35B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2982Step_28float64_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d ]
  store double %storemerge, ptr %retptr, align 8
  ret void
B124:
  call fastcc void @v47(ptr %.729, i64 %arg.run.0.3, ptr %arg.run.1.0.4, i64 %arg.run.2.1.2, i64 %arg.run.3.0.2, ptr %arg.run.3.0.4, i64 %arg.run.3.0.5.0, ptr %arg.run.3.1.4, i64 %arg.run.3.1.5.1, i64 %arg.run.3.2.2, ptr %arg.run.3.2.4, i64 %arg.run.5.0.2, ptr %arg.run.5.0.4, ptr %arg.run.5.3.4, ptr %arg.run.5.6.4, i64 %arg.run.5.6.5.0, ptr %arg.run.5.11.4, i64 %arg.run.5.11.5.0, i64 %arg.run.6.2, ptr %arg.run.6.4, ptr %arg.run.9.4, double %arg.segment.0, ptr %arg.segment.2.4, i64 %arg.segment.2.5.1, double %arg.step.0, double %arg.step.1, ptr %arg.step.3.4, double %first.2.0.lcssa.i)
  %.850 = fsub double %first.2.0.lcssa.i, %arg.step.0
  %.856 = fdiv double %.850, %arg.step.1
  %.478.i = fsub double 1.000000e+00, %.856
  br i1 %.703768.not.i, label %_ZN6poppet6engine8stepping11interpolateB3v35B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2982Step_28float64_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d, label %B102.if.i
B102.if.i:
  %.645.0769.i = phi i64 [ %.716.i, %B102.if.i ], [ 0, %B124 ]
  %.716.i = add nuw nsw i64 %.645.0769.i, 1
  %1 = getelementptr double, ptr %arg.run.6.4, i64 %.645.0769.i
  %.774.i = load double, ptr %1, align 8, !noalias !27
  %.779.i = fmul double %.478.i, %.774.i
  %2 = getelementptr double, ptr %arg.step.3.4, i64 %.645.0769.i
  %.813.i = load double, ptr %2, align 8, !noalias !27
  %3 = getelementptr double, ptr %arg.run.5.11.4, i64 %.645.0769.i
  %.846.i = load double, ptr %3, align 8, !noalias !27
  %.848.i = add nsw i64 %.645.0769.i, %arg.run.6.2
  %.862.i = icmp slt i64 %.848.i, 0
  %.863.i = select i1 %.862.i, i64 %arg.run.5.11.5.0, i64 0
  %4 = getelementptr double, ptr %arg.run.5.11.4, i64 %.848.i
  %.877.i = getelementptr double, ptr %4, i64 %.863.i
  %.878.i = load double, ptr %.877.i, align 8, !noalias !27
  %.880.i = fmul double %.856, %.878.i
  %.881.i = fadd double %.846.i, %.880.i
  %.883.i = fmul double %.478.i, %.881.i
  %.884.i = fadd double %.813.i, %.883.i
  %.886.i = fmul double %.856, %.884.i
  %.887.i = fadd double %.779.i, %.886.i
  %5 = getelementptr double, ptr %arg.run.5.12.4, i64 %.645.0769.i
  store double %.887.i, ptr %5, align 8, !noalias !27
  %exitcond.not.i1480 = icmp eq i64 %arg.run.5.12.2, %.716.i
  br i1 %exitcond.not.i1480, label %_ZN6poppet6engine8stepping11interpolateB3v35B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2982Step_28float64_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d, label %B102.if.i
_ZN6poppet6engine8stepping11interpolateB3v35B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2982Step_28float64_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d:
  store i8 0, ptr %.1201, align 1
  call fastcc void @v44(ptr %.1201, i64 %arg.run.0.4, ptr %arg.run.1.0.4, i64 %arg.run.1.1.2, ptr %arg.run.1.1.4, ptr %arg.run.1.2.4, i64 %arg.run.1.3.2, ptr %arg.run.1.3.4, ptr %arg.run.1.4.4, i64 %arg.run.5.0.2, ptr %arg.run.5.0.4, ptr %arg.run.5.3.4, double %arg.segment.0, ptr %arg.segment.2.4, i64 %arg.segment.2.5.1, double %first.2.0.lcssa.i, ptr %arg.run.5.12.4)
  %.1308 = load i8, ptr %.1201, align 1
  %.1311.not = icmp eq i8 %.1308, 0
  br i1 %.1311.not, label %B6, label %common.ret
}
define internal fastcc void @v47(ptr noalias nonnull writeonly %retptr, i64 %arg.run.0.3, ptr %arg.run.1.0.4, i64 %arg.run.2.1.2, i64 %arg.run.3.0.2, ptr readonly %arg.run.3.0.4, i64 %arg.run.3.0.5.0, ptr writeonly %arg.run.3.1.4, i64 %arg.run.3.1.5.1, i64 %arg.run.3.2.2, ptr %arg.run.3.2.4, i64 %arg.run.5.0.2, ptr %arg.run.5.0.4, ptr %arg.run.5.3.4, ptr %arg.run.5.6.4, i64 %arg.run.5.6.5.0, ptr readonly %arg.run.5.11.4, i64 %arg.run.5.11.5.0, i64 %arg.run.6.2, ptr readonly %arg.run.6.4, ptr %arg.run.9.4, double %arg.segment.0, ptr readonly %arg.segment.2.4, i64 %arg.segment.2.5.1, double %arg.step.0, double %arg.step.1, ptr readonly %arg.step.3.4, double %arg.until) unnamed_addr {
entry:
  %.5.i = fmul double %arg.until, 0x3D06849B86A12B9B
  %.6.i = fadd double %.5.i, 1.000000e-15
  %.510 = fsub double %arg.until, %.6.i
  %.731 = icmp slt i64 %arg.run.5.6.5.0, 1
  br i1 %.731, label %B0.endif.else.endif.if, label %B0.endif.else.endif.endif, !prof !30
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
  %.151223.not.i.i.i = icmp slt i64 %arg.run.5.0.2, 1
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
  br i1 %.703768.not.i, label %_ZN6poppet6engine8stepping11interpolateB3v35B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2982Step_28float64_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d, label %B102.if.i
B102.if.i:
  %.645.0769.i = phi i64 [ %.716.i, %B102.if.i ], [ 0, %B244 ]
  %.716.i = add nuw nsw i64 %.645.0769.i, 1
  %2 = getelementptr double, ptr %arg.run.6.4, i64 %.645.0769.i
  %.774.i = load double, ptr %2, align 8, !noalias !31
  %.779.i = fmul double %.478.i, %.774.i
  %3 = getelementptr double, ptr %arg.step.3.4, i64 %.645.0769.i
  %.813.i = load double, ptr %3, align 8, !noalias !31
  %4 = getelementptr double, ptr %arg.run.5.11.4, i64 %.645.0769.i
  %.846.i = load double, ptr %4, align 8, !noalias !31
  %.848.i = add nsw i64 %.645.0769.i, %arg.run.6.2
  %.862.i = icmp slt i64 %.848.i, 0
  %.863.i = select i1 %.862.i, i64 %arg.run.5.11.5.0, i64 0
  %5 = getelementptr double, ptr %arg.run.5.11.4, i64 %.848.i
  %.877.i = getelementptr double, ptr %5, i64 %.863.i
  %.878.i = load double, ptr %.877.i, align 8, !noalias !31
  %.880.i = fmul double %.13.i, %.878.i
  %.881.i = fadd double %.846.i, %.880.i
  %.883.i = fmul double %.478.i, %.881.i
  %.884.i = fadd double %.813.i, %.883.i
  %.886.i = fmul double %.13.i, %.884.i
  %.887.i = fadd double %.779.i, %.886.i
  %6 = getelementptr double, ptr %.824, i64 %.645.0769.i
  store double %.887.i, ptr %6, align 8, !noalias !31
  %exitcond.not.i = icmp eq i64 %.799, %.716.i
  br i1 %exitcond.not.i, label %_ZN6poppet6engine8stepping11interpolateB3v35B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2982Step_28float64_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d, label %B102.if.i
_ZN6poppet6engine8stepping11interpolateB3v35B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2982Step_28float64_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d:
  %.40.i.i.i = fsub double %.1065, %arg.segment.0
  br i1 %.151223.not.i.i.i, label %_ZN6poppet6engine8stepping10outputs_atB3v20B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_, label %B78.if.i.i.i
B158.i.i.i:
  %.423.i.i.i = getelementptr i8, ptr %.245.i.i.i, i64 24
  %.424.i.i.i = load double, ptr %.423.i.i.i, align 8, !noalias !34
  %.478.i.i.i = getelementptr i8, ptr %.245.i.i.i, i64 32
  %.479.i.i.i = load double, ptr %.478.i.i.i, align 8, !noalias !34
  %.480.i.i.i = fmul double %.479.i.i.i, 5.000000e-01
  %.482.i.i.i = fmul double %.40.i.i.i, %.480.i.i.i
  %.483.i.i.i = fadd double %.424.i.i.i, %.482.i.i.i
  %.484.i.i.i = fmul double %.483.i.i.i, 0x401921FB54442D18
  %.486.i.i.i = fmul double %.40.i.i.i, %.484.i.i.i
  %.540.i.i.i = getelementptr i8, ptr %.245.i.i.i, i64 40
  %.541.i.i.i = load double, ptr %.540.i.i.i, align 8, !noalias !34
  %.542.i.i.i = fadd double %.541.i.i.i, %.486.i.i.i
  %.605.le.i.i.i = tail call double @llvm.sin.f64(double %.542.i.i.i)
  %.610.i.i.i = fmul double %.366.i.i.i, %.605.le.i.i.i
  %.612.i.i.i = fadd double %.304.i.i.i, %.610.i.i.i
  br label %B340.i.i.i
B340.i.i.i:
  %value.2.1.i.i.i = phi double [ %.612.i.i.i, %B158.i.i.i ], [ %.304.i.i.i, %B78.if.i.i.i ]
  %7 = getelementptr double, ptr %arg.run.5.0.4, i64 %.93.0224.i.i.i
  store double %value.2.1.i.i.i, ptr %7, align 8, !noalias !34
  %exitcond.not.i.i.i = icmp eq i64 %arg.run.5.0.2, %.164.i.i.i
  br i1 %exitcond.not.i.i.i, label %_ZN6poppet6engine8stepping10outputs_atB3v20B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_, label %B78.if.i.i.i
B78.if.i.i.i:
  %.93.0224.i.i.i = phi i64 [ %.164.i.i.i, %B340.i.i.i ], [ 0, %_ZN6poppet6engine8stepping11interpolateB3v35B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2982Step_28float64_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d ]
  %.164.i.i.i = add nuw nsw i64 %.93.0224.i.i.i, 1
  %.241.i.i.i = mul i64 %.93.0224.i.i.i, %arg.segment.2.5.1
  %.245.i.i.i = getelementptr double, ptr %arg.segment.2.4, i64 %.241.i.i.i
  %.246.i.i.i = load double, ptr %.245.i.i.i, align 8, !noalias !34
  %.300.i.i.i = getelementptr i8, ptr %.245.i.i.i, i64 8
  %.301.i.i.i = load double, ptr %.300.i.i.i, align 8, !noalias !34
  %.303.i.i.i = fmul double %.40.i.i.i, %.301.i.i.i
  %.304.i.i.i = fadd double %.246.i.i.i, %.303.i.i.i
  %.365.i.i.i = getelementptr i8, ptr %.245.i.i.i, i64 16
  %.366.i.i.i = load double, ptr %.365.i.i.i, align 8, !noalias !34
  %.367.i.i.i = fcmp une double %.366.i.i.i, 0.000000e+00
  br i1 %.367.i.i.i, label %B158.i.i.i, label %B340.i.i.i
_ZN6poppet6engine8stepping10outputs_atB3v20B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_:
  store double %.1065, ptr %arg.run.5.3.4, align 8, !noalias !41
  tail call void %.992.i.i(ptr nonnull %arg.run.5.3.4, ptr %.824, ptr %arg.run.5.0.4, ptr %arg.run.1.0.4, ptr %arg.run.3.2.4), !noalias !41
  %.649.i = load i64, ptr %.912, align 8, !noalias !42
  br i1 %.754872.not.i, label %_ZN6poppet6engine8stepping9write_rowB3v38B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_29, label %B116.if.lr.ph.i
B116.if.lr.ph.i:
  %invariant.gep.i = getelementptr double, ptr %arg.run.3.1.4, i64 %.649.i
  %.879.i = icmp slt i64 %.649.i, 0
  %.880.i3007 = select i1 %.879.i, i64 %arg.run.3.1.5.1, i64 0
  %invariant.gep875.i = getelementptr double, ptr %invariant.gep.i, i64 %.880.i3007
  br label %B116.if.i
B116.if.i:
  %.698.0873.i = phi i64 [ 0, %B116.if.lr.ph.i ], [ %.767.i, %B116.if.i ]
  %.767.i = add nuw nsw i64 %.698.0873.i, 1
  %8 = getelementptr double, ptr %arg.run.3.2.4, i64 %.698.0873.i
  %.821.i = load double, ptr %8, align 8, !noalias !42
  %.898.i = mul i64 %.698.0873.i, %arg.run.3.1.5.1
  %gep876.i = getelementptr double, ptr %invariant.gep875.i, i64 %.898.i
  store double %.821.i, ptr %gep876.i, align 8, !noalias !42
  %exitcond.not.i3008 = icmp eq i64 %.767.i, %arg.run.3.2.2
  br i1 %exitcond.not.i3008, label %_ZN6poppet6engine8stepping9write_rowB3v38B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_29, label %B116.if.i
_ZN6poppet6engine8stepping9write_rowB3v38B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_29:
  %.922.i = add nsw i64 %.649.i, 1
  store i64 %.922.i, ptr %.912, align 8, !noalias !42
  %.1387 = icmp slt i64 %.922.i, %arg.run.3.0.2
  br i1 %.1387, label %B478, label %common.ret
B478:
  %.1439 = icmp slt i64 %.649.i, -1
  %.1440 = select i1 %.1439, i64 %arg.run.3.0.5.0, i64 0
  %9 = getelementptr double, ptr %arg.run.3.0.4, i64 %.922.i
  %.1454 = getelementptr double, ptr %9, i64 %.1440
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
  br i1 %.743, label %B0.endif.else.endif.endif.if, label %B0.endif.else.endif.endif.endif, !prof !30
B0.endif.else.endif.endif.if:
  br label %B0.endif.else.endif.endif.endif
B0.endif.else.endif.endif.endif:
  %.711.sroa.13.1 = phi i64 [ 0, %B0.endif.else.endif.endif.if ], [ %.740, %B0.endif.else.endif.endif ]
  %.748.not = icmp slt i64 %.740, %arg.run.5.6.5.0
  br i1 %.748.not, label %B0.endif.endif, label %B0.endif.else.endif.endif.endif.if, !prof !43
B0.endif.else.endif.endif.endif.if:
  br label %B0.endif.endif
}
declare double @llvm.cos.f64(double)
define noundef i64 @integrate(ptr readonly %job) local_unnamed_addr {
  %.648.i.i = alloca i8, align 1
  %.1307.i.i = alloca { i64, double }, align 8
  %.1528.i.i = alloca ptr, align 8
  %.1113.i.i.i = alloca { i64, double }, align 8
  %.1313.i.i.i = alloca double, align 8
  %.1437.i.i.i = alloca ptr, align 8
  %.3740.i.i = alloca i8, align 1
  %.460.i.i = alloca [36 x i64], align 8
  %.2306.i = alloca i8, align 1
  call void @llvm.lifetime.start.p0(ptr nonnull %.2306.i)
  store i8 0, ptr %.2306.i, align 1, !noalias !44
  call void @llvm.lifetime.start.p0(ptr nonnull %.460.i.i), !noalias !44
  %.fca.1.gep.i.i = getelementptr inbounds i8, ptr %.460.i.i, i64 8
  %.fca.2.gep.i.i = getelementptr inbounds i8, ptr %.460.i.i, i64 16
  %.fca.3.gep.i.i = getelementptr inbounds i8, ptr %.460.i.i, i64 24
  %.fca.4.gep.i.i = getelementptr inbounds i8, ptr %.460.i.i, i64 32
  %.fca.5.gep.i.i = getelementptr inbounds i8, ptr %.460.i.i, i64 40
  %.fca.6.gep.i.i = getelementptr inbounds i8, ptr %.460.i.i, i64 48
  %.fca.7.gep.i.i = getelementptr inbounds i8, ptr %.460.i.i, i64 56
  %.fca.8.gep.i.i = getelementptr inbounds i8, ptr %.460.i.i, i64 64
  %.fca.9.gep.i.i = getelementptr inbounds i8, ptr %.460.i.i, i64 72
  %.fca.10.gep.i.i = getelementptr inbounds i8, ptr %.460.i.i, i64 80
  %.fca.11.gep.i.i = getelementptr inbounds i8, ptr %.460.i.i, i64 88
  %.fca.12.gep.i.i = getelementptr inbounds i8, ptr %.460.i.i, i64 96
  %.fca.13.gep.i.i = getelementptr inbounds i8, ptr %.460.i.i, i64 104
  %.fca.14.gep.i.i = getelementptr inbounds i8, ptr %.460.i.i, i64 112
  %.fca.15.gep.i.i = getelementptr inbounds i8, ptr %.460.i.i, i64 120
  %.fca.16.gep.i.i = getelementptr inbounds i8, ptr %.460.i.i, i64 128
  %.fca.17.gep.i.i = getelementptr inbounds i8, ptr %.460.i.i, i64 136
  %.fca.18.gep.i.i = getelementptr inbounds i8, ptr %.460.i.i, i64 144
  %.fca.19.gep.i.i = getelementptr inbounds i8, ptr %.460.i.i, i64 152
  %.fca.20.gep.i.i = getelementptr inbounds i8, ptr %.460.i.i, i64 160
  %.fca.21.gep.i.i = getelementptr inbounds i8, ptr %.460.i.i, i64 168
  %.fca.22.gep.i.i = getelementptr inbounds i8, ptr %.460.i.i, i64 176
  %.fca.23.gep.i.i = getelementptr inbounds i8, ptr %.460.i.i, i64 184
  %.fca.24.gep.i.i = getelementptr inbounds i8, ptr %.460.i.i, i64 192
  %.fca.25.gep.i.i = getelementptr inbounds i8, ptr %.460.i.i, i64 200
  %.fca.26.gep.i.i = getelementptr inbounds i8, ptr %.460.i.i, i64 208
  %.fca.27.gep.i.i = getelementptr inbounds i8, ptr %.460.i.i, i64 216
  %.fca.28.gep.i.i = getelementptr inbounds i8, ptr %.460.i.i, i64 224
  %.fca.29.gep.i.i = getelementptr inbounds i8, ptr %.460.i.i, i64 232
  %.fca.30.gep.i.i = getelementptr inbounds i8, ptr %.460.i.i, i64 240
  %.fca.31.gep.i.i = getelementptr inbounds i8, ptr %.460.i.i, i64 248
  %.fca.32.gep.i.i = getelementptr inbounds i8, ptr %.460.i.i, i64 256
  %.fca.33.gep.i.i = getelementptr inbounds i8, ptr %.460.i.i, i64 264
  %.fca.34.gep.i.i = getelementptr inbounds i8, ptr %.460.i.i, i64 272
  %.fca.35.gep.i.i = getelementptr inbounds i8, ptr %.460.i.i, i64 280
  br label %B38.if.i.i
B38.if.i.i:
  %out.2.sroa.0.0447.i.i = phi i64 [ undef, %0 ], [ %.465.fca.0.load.i.i, %B38.if.i.i ]
  %out.2.sroa.9.0446.i.i = phi i64 [ undef, %0 ], [ %.465.fca.1.load.i.i, %B38.if.i.i ]
  %out.2.sroa.18.0445.i.i = phi i64 [ undef, %0 ], [ %.465.fca.2.load.i.i, %B38.if.i.i ]
  %out.2.sroa.27.0444.i.i = phi i64 [ undef, %0 ], [ %.465.fca.3.load.i.i, %B38.if.i.i ]
  %out.2.sroa.36.0443.i.i = phi i64 [ undef, %0 ], [ %.465.fca.4.load.i.i, %B38.if.i.i ]
  %out.2.sroa.45.0442.i.i = phi i64 [ undef, %0 ], [ %.465.fca.5.load.i.i, %B38.if.i.i ]
  %out.2.sroa.54.0441.i.i = phi i64 [ undef, %0 ], [ %.465.fca.6.load.i.i, %B38.if.i.i ]
  %out.2.sroa.63.0440.i.i = phi i64 [ undef, %0 ], [ %.465.fca.7.load.i.i, %B38.if.i.i ]
  %out.2.sroa.72.0439.i.i = phi i64 [ undef, %0 ], [ %.465.fca.8.load.i.i, %B38.if.i.i ]
  %out.2.sroa.81.0438.i.i = phi i64 [ undef, %0 ], [ %.465.fca.9.load.i.i, %B38.if.i.i ]
  %out.2.sroa.90.0437.i.i = phi i64 [ undef, %0 ], [ %.465.fca.10.load.i.i, %B38.if.i.i ]
  %out.2.sroa.99.0436.i.i = phi i64 [ undef, %0 ], [ %.465.fca.11.load.i.i, %B38.if.i.i ]
  %out.2.sroa.108.0435.i.i = phi i64 [ undef, %0 ], [ %.465.fca.12.load.i.i, %B38.if.i.i ]
  %out.2.sroa.117.0434.i.i = phi i64 [ undef, %0 ], [ %.465.fca.13.load.i.i, %B38.if.i.i ]
  %out.2.sroa.126.0433.i.i = phi i64 [ undef, %0 ], [ %.465.fca.14.load.i.i, %B38.if.i.i ]
  %out.2.sroa.135.0432.i.i = phi i64 [ undef, %0 ], [ %.465.fca.15.load.i.i, %B38.if.i.i ]
  %out.2.sroa.144.0431.i.i = phi i64 [ undef, %0 ], [ %.465.fca.16.load.i.i, %B38.if.i.i ]
  %out.2.sroa.153.0430.i.i = phi i64 [ undef, %0 ], [ %.465.fca.17.load.i.i, %B38.if.i.i ]
  %out.2.sroa.162.0429.i.i = phi i64 [ undef, %0 ], [ %.465.fca.18.load.i.i, %B38.if.i.i ]
  %out.2.sroa.171.0428.i.i = phi i64 [ undef, %0 ], [ %.465.fca.19.load.i.i, %B38.if.i.i ]
  %out.2.sroa.180.0427.i.i = phi i64 [ undef, %0 ], [ %.465.fca.20.load.i.i, %B38.if.i.i ]
  %out.2.sroa.189.0426.i.i = phi i64 [ undef, %0 ], [ %.465.fca.21.load.i.i, %B38.if.i.i ]
  %out.2.sroa.198.0425.i.i = phi i64 [ undef, %0 ], [ %.465.fca.22.load.i.i, %B38.if.i.i ]
  %out.2.sroa.207.0424.i.i = phi i64 [ undef, %0 ], [ %.465.fca.23.load.i.i, %B38.if.i.i ]
  %out.2.sroa.216.0423.i.i = phi i64 [ undef, %0 ], [ %.465.fca.24.load.i.i, %B38.if.i.i ]
  %out.2.sroa.225.0422.i.i = phi i64 [ undef, %0 ], [ %.465.fca.25.load.i.i, %B38.if.i.i ]
  %out.2.sroa.234.0421.i.i = phi i64 [ undef, %0 ], [ %.465.fca.26.load.i.i, %B38.if.i.i ]
  %out.2.sroa.243.0420.i.i = phi i64 [ undef, %0 ], [ %.465.fca.27.load.i.i, %B38.if.i.i ]
  %out.2.sroa.252.0419.i.i = phi i64 [ undef, %0 ], [ %.465.fca.28.load.i.i, %B38.if.i.i ]
  %out.2.sroa.261.0418.i.i = phi i64 [ undef, %0 ], [ %.465.fca.29.load.i.i, %B38.if.i.i ]
  %out.2.sroa.270.0417.i.i = phi i64 [ undef, %0 ], [ %.465.fca.30.load.i.i, %B38.if.i.i ]
  %out.2.sroa.279.0416.i.i = phi i64 [ undef, %0 ], [ %.465.fca.31.load.i.i, %B38.if.i.i ]
  %out.2.sroa.288.0415.i.i = phi i64 [ undef, %0 ], [ %.465.fca.32.load.i.i, %B38.if.i.i ]
  %out.2.sroa.297.0414.i.i = phi i64 [ undef, %0 ], [ %.465.fca.33.load.i.i, %B38.if.i.i ]
  %out.2.sroa.306.0413.i.i = phi i64 [ undef, %0 ], [ %.465.fca.34.load.i.i, %B38.if.i.i ]
  %out.2.sroa.315.0412.i.i = phi i64 [ undef, %0 ], [ %.465.fca.35.load.i.i, %B38.if.i.i ]
  %.333.0410.i.i = phi i64 [ 0, %0 ], [ %.404.i.i, %B38.if.i.i ]
  %.404.i.i = add nuw nsw i64 %.333.0410.i.i, 1
  %1 = getelementptr i64, ptr %job, i64 %.333.0410.i.i
  %.458.i.i = load i64, ptr %1, align 8, !noalias !48
  store i64 %out.2.sroa.0.0447.i.i, ptr %.460.i.i, align 8, !noalias !48
  store i64 %out.2.sroa.9.0446.i.i, ptr %.fca.1.gep.i.i, align 8, !noalias !48
  store i64 %out.2.sroa.18.0445.i.i, ptr %.fca.2.gep.i.i, align 8, !noalias !48
  store i64 %out.2.sroa.27.0444.i.i, ptr %.fca.3.gep.i.i, align 8, !noalias !48
  store i64 %out.2.sroa.36.0443.i.i, ptr %.fca.4.gep.i.i, align 8, !noalias !48
  store i64 %out.2.sroa.45.0442.i.i, ptr %.fca.5.gep.i.i, align 8, !noalias !48
  store i64 %out.2.sroa.54.0441.i.i, ptr %.fca.6.gep.i.i, align 8, !noalias !48
  store i64 %out.2.sroa.63.0440.i.i, ptr %.fca.7.gep.i.i, align 8, !noalias !48
  store i64 %out.2.sroa.72.0439.i.i, ptr %.fca.8.gep.i.i, align 8, !noalias !48
  store i64 %out.2.sroa.81.0438.i.i, ptr %.fca.9.gep.i.i, align 8, !noalias !48
  store i64 %out.2.sroa.90.0437.i.i, ptr %.fca.10.gep.i.i, align 8, !noalias !48
  store i64 %out.2.sroa.99.0436.i.i, ptr %.fca.11.gep.i.i, align 8, !noalias !48
  store i64 %out.2.sroa.108.0435.i.i, ptr %.fca.12.gep.i.i, align 8, !noalias !48
  store i64 %out.2.sroa.117.0434.i.i, ptr %.fca.13.gep.i.i, align 8, !noalias !48
  store i64 %out.2.sroa.126.0433.i.i, ptr %.fca.14.gep.i.i, align 8, !noalias !48
  store i64 %out.2.sroa.135.0432.i.i, ptr %.fca.15.gep.i.i, align 8, !noalias !48
  store i64 %out.2.sroa.144.0431.i.i, ptr %.fca.16.gep.i.i, align 8, !noalias !48
  store i64 %out.2.sroa.153.0430.i.i, ptr %.fca.17.gep.i.i, align 8, !noalias !48
  store i64 %out.2.sroa.162.0429.i.i, ptr %.fca.18.gep.i.i, align 8, !noalias !48
  store i64 %out.2.sroa.171.0428.i.i, ptr %.fca.19.gep.i.i, align 8, !noalias !48
  store i64 %out.2.sroa.180.0427.i.i, ptr %.fca.20.gep.i.i, align 8, !noalias !48
  store i64 %out.2.sroa.189.0426.i.i, ptr %.fca.21.gep.i.i, align 8, !noalias !48
  store i64 %out.2.sroa.198.0425.i.i, ptr %.fca.22.gep.i.i, align 8, !noalias !48
  store i64 %out.2.sroa.207.0424.i.i, ptr %.fca.23.gep.i.i, align 8, !noalias !48
  store i64 %out.2.sroa.216.0423.i.i, ptr %.fca.24.gep.i.i, align 8, !noalias !48
  store i64 %out.2.sroa.225.0422.i.i, ptr %.fca.25.gep.i.i, align 8, !noalias !48
  store i64 %out.2.sroa.234.0421.i.i, ptr %.fca.26.gep.i.i, align 8, !noalias !48
  store i64 %out.2.sroa.243.0420.i.i, ptr %.fca.27.gep.i.i, align 8, !noalias !48
  store i64 %out.2.sroa.252.0419.i.i, ptr %.fca.28.gep.i.i, align 8, !noalias !48
  store i64 %out.2.sroa.261.0418.i.i, ptr %.fca.29.gep.i.i, align 8, !noalias !48
  store i64 %out.2.sroa.270.0417.i.i, ptr %.fca.30.gep.i.i, align 8, !noalias !48
  store i64 %out.2.sroa.279.0416.i.i, ptr %.fca.31.gep.i.i, align 8, !noalias !48
  store i64 %out.2.sroa.288.0415.i.i, ptr %.fca.32.gep.i.i, align 8, !noalias !48
  store i64 %out.2.sroa.297.0414.i.i, ptr %.fca.33.gep.i.i, align 8, !noalias !48
  store i64 %out.2.sroa.306.0413.i.i, ptr %.fca.34.gep.i.i, align 8, !noalias !48
  store i64 %out.2.sroa.315.0412.i.i, ptr %.fca.35.gep.i.i, align 8, !noalias !48
  %.463.i.i = getelementptr inbounds i64, ptr %.460.i.i, i64 %.333.0410.i.i
  store i64 %.458.i.i, ptr %.463.i.i, align 8, !noalias !48
  %.465.fca.0.load.i.i = load i64, ptr %.460.i.i, align 8, !noalias !48
  %.465.fca.1.load.i.i = load i64, ptr %.fca.1.gep.i.i, align 8, !noalias !48
  %.465.fca.2.load.i.i = load i64, ptr %.fca.2.gep.i.i, align 8, !noalias !48
  %.465.fca.3.load.i.i = load i64, ptr %.fca.3.gep.i.i, align 8, !noalias !48
  %.465.fca.4.load.i.i = load i64, ptr %.fca.4.gep.i.i, align 8, !noalias !48
  %.465.fca.5.load.i.i = load i64, ptr %.fca.5.gep.i.i, align 8, !noalias !48
  %.465.fca.6.load.i.i = load i64, ptr %.fca.6.gep.i.i, align 8, !noalias !48
  %.465.fca.7.load.i.i = load i64, ptr %.fca.7.gep.i.i, align 8, !noalias !48
  %.465.fca.8.load.i.i = load i64, ptr %.fca.8.gep.i.i, align 8, !noalias !48
  %.465.fca.9.load.i.i = load i64, ptr %.fca.9.gep.i.i, align 8, !noalias !48
  %.465.fca.10.load.i.i = load i64, ptr %.fca.10.gep.i.i, align 8, !noalias !48
  %.465.fca.11.load.i.i = load i64, ptr %.fca.11.gep.i.i, align 8, !noalias !48
  %.465.fca.12.load.i.i = load i64, ptr %.fca.12.gep.i.i, align 8, !noalias !48
  %.465.fca.13.load.i.i = load i64, ptr %.fca.13.gep.i.i, align 8, !noalias !48
  %.465.fca.14.load.i.i = load i64, ptr %.fca.14.gep.i.i, align 8, !noalias !48
  %.465.fca.15.load.i.i = load i64, ptr %.fca.15.gep.i.i, align 8, !noalias !48
  %.465.fca.16.load.i.i = load i64, ptr %.fca.16.gep.i.i, align 8, !noalias !48
  %.465.fca.17.load.i.i = load i64, ptr %.fca.17.gep.i.i, align 8, !noalias !48
  %.465.fca.18.load.i.i = load i64, ptr %.fca.18.gep.i.i, align 8, !noalias !48
  %.465.fca.19.load.i.i = load i64, ptr %.fca.19.gep.i.i, align 8, !noalias !48
  %.465.fca.20.load.i.i = load i64, ptr %.fca.20.gep.i.i, align 8, !noalias !48
  %.465.fca.21.load.i.i = load i64, ptr %.fca.21.gep.i.i, align 8, !noalias !48
  %.465.fca.22.load.i.i = load i64, ptr %.fca.22.gep.i.i, align 8, !noalias !48
  %.465.fca.23.load.i.i = load i64, ptr %.fca.23.gep.i.i, align 8, !noalias !48
  %.465.fca.24.load.i.i = load i64, ptr %.fca.24.gep.i.i, align 8, !noalias !48
  %.465.fca.25.load.i.i = load i64, ptr %.fca.25.gep.i.i, align 8, !noalias !48
  %.465.fca.26.load.i.i = load i64, ptr %.fca.26.gep.i.i, align 8, !noalias !48
  %.465.fca.27.load.i.i = load i64, ptr %.fca.27.gep.i.i, align 8, !noalias !48
  %.465.fca.28.load.i.i = load i64, ptr %.fca.28.gep.i.i, align 8, !noalias !48
  %.465.fca.29.load.i.i = load i64, ptr %.fca.29.gep.i.i, align 8, !noalias !48
  %.465.fca.30.load.i.i = load i64, ptr %.fca.30.gep.i.i, align 8, !noalias !48
  %.465.fca.31.load.i.i = load i64, ptr %.fca.31.gep.i.i, align 8, !noalias !48
  %.465.fca.32.load.i.i = load i64, ptr %.fca.32.gep.i.i, align 8, !noalias !48
  %.465.fca.33.load.i.i = load i64, ptr %.fca.33.gep.i.i, align 8, !noalias !48
  %.465.fca.34.load.i.i = load i64, ptr %.fca.34.gep.i.i, align 8, !noalias !48
  %.465.fca.35.load.i.i = load i64, ptr %.fca.35.gep.i.i, align 8, !noalias !48
  %exitcond.not.i.i = icmp eq i64 %.404.i.i, 36
  br i1 %exitcond.not.i.i, label %_ZN5numba2np6unsafe7ndarray14to_fixed_tuple12_3clocals_3e7codegen12_3clocals_3e4implB3v44B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi36EE.exit.i, label %B38.if.i.i
_ZN5numba2np6unsafe7ndarray14to_fixed_tuple12_3clocals_3e7codegen12_3clocals_3e4implB3v44B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi36EE.exit.i:
  call void @llvm.lifetime.end.p0(ptr nonnull %.460.i.i), !noalias !44
  %.157.i.i = add nsw i64 %.465.fca.10.load.i.i, %.465.fca.9.load.i.i
  %.291.i.i = mul nsw i64 %.465.fca.5.load.i.i, 12
  %.292.i.i = mul nsw i64 %.465.fca.7.load.i.i, 6
  %.293.i.i = add i64 %.465.fca.11.load.i.i, %.465.fca.10.load.i.i
  %.294.i.i = or i64 %.291.i.i, 2
  %.295.i.i = add i64 %.294.i.i, %.292.i.i
  %.296.i.i = add i64 %.295.i.i, %.465.fca.8.load.i.i
  %.301.i.i = add i64 %.296.i.i, %.293.i.i
  %.303.i.i = add nsw i64 %.301.i.i, %.465.fca.12.load.i.i
  %.305.i.i = add nsw i64 %.303.i.i, %.465.fca.13.load.i.i
  %.391.i.i = icmp slt i64 %.305.i.i, 1
  br i1 %.391.i.i, label %B0.endif.endif.endif.endif.else.endif.if.i.i, label %B0.endif.endif.endif.endif.else.endif.endif.i.i, !prof !30
B0.endif.endif.endif.endif.endif.i.i:
  %.371.sroa.13.0.i.i = phi i64 [ %.305.i.i, %B0.endif.endif.endif.endif.else.endif.endif.endif.if.i.i ], [ %.371.sroa.13.1.i.i, %B0.endif.endif.endif.endif.else.endif.endif.endif.i.i ]
  %.459.i.i = sub i64 %.371.sroa.13.0.i.i, %.371.sroa.0.3.i.i
  %.468.i.i = tail call i64 @llvm.smax.i64(i64 %.459.i.i, i64 0)
  br i1 %.403.i.i, label %B0.endif.endif.endif.endif.endif.else.if.i.i, label %B0.endif.endif.endif.endif.endif.else.endif.i.i, !prof !30
B0.endif.endif.endif.endif.else.endif.if.i.i:
  br label %B0.endif.endif.endif.endif.else.endif.endif.i.i
B0.endif.endif.endif.endif.else.endif.endif.i.i:
  %.371.sroa.0.3.i.i = phi i64 [ %.305.i.i, %B0.endif.endif.endif.endif.else.endif.if.i.i ], [ 0, %_ZN5numba2np6unsafe7ndarray14to_fixed_tuple12_3clocals_3e7codegen12_3clocals_3e4implB3v44B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi36EE.exit.i ]
  %.398.i.i = icmp slt i64 %.465.fca.5.load.i.i, 0
  %.399.i.i = select i1 %.398.i.i, i64 %.305.i.i, i64 0
  %.400.i.i = add i64 %.399.i.i, %.291.i.i
  %.403.i.i = icmp slt i64 %.400.i.i, 0
  br i1 %.403.i.i, label %B0.endif.endif.endif.endif.else.endif.endif.if.i.i, label %B0.endif.endif.endif.endif.else.endif.endif.endif.i.i, !prof !30
B0.endif.endif.endif.endif.else.endif.endif.if.i.i:
  br label %B0.endif.endif.endif.endif.else.endif.endif.endif.i.i
B0.endif.endif.endif.endif.else.endif.endif.endif.i.i:
  %.371.sroa.13.1.i.i = phi i64 [ 0, %B0.endif.endif.endif.endif.else.endif.endif.if.i.i ], [ %.400.i.i, %B0.endif.endif.endif.endif.else.endif.endif.i.i ]
  %.408.not.i.i = icmp slt i64 %.400.i.i, %.305.i.i
  br i1 %.408.not.i.i, label %B0.endif.endif.endif.endif.endif.i.i, label %B0.endif.endif.endif.endif.else.endif.endif.endif.if.i.i, !prof !43
B0.endif.endif.endif.endif.else.endif.endif.endif.if.i.i:
  br label %B0.endif.endif.endif.endif.endif.i.i
B0.endif.endif.endif.endif.endif.else.if.i.i:
  br label %B0.endif.endif.endif.endif.endif.else.endif.i.i
B0.endif.endif.endif.endif.endif.else.endif.i.i:
  %.542.sroa.0.1.i.i = phi i64 [ 0, %B0.endif.endif.endif.endif.endif.else.if.i.i ], [ %.400.i.i, %B0.endif.endif.endif.endif.endif.i.i ]
  br i1 %.408.not.i.i, label %B0.endif.endif.endif.endi...if.i.i, label %B0.endif.endif.endif.endif.endif.else.endif.if.i.i, !prof !43
B0.endif.endif.endif.endif.endif.else.endif.if.i.i:
  br label %B0.endif.endif.endif.endi...if.i.i
B0.endif.endif.endif.endi...if.i.i:
  %.542.sroa.0.3.i.i = phi i64 [ %.305.i.i, %B0.endif.endif.endif.endif.endif.else.endif.if.i.i ], [ %.542.sroa.0.1.i.i, %B0.endif.endif.endif.endif.endif.else.endif.i.i ]
  %.630.i.i = sub i64 %.305.i.i, %.542.sroa.0.3.i.i
  %.639.i.i = tail call i64 @llvm.smax.i64(i64 %.630.i.i, i64 0)
  %.741.i.i = icmp slt i64 %.630.i.i, 1
  br i1 %.741.i.i, label %B0.endif.endif.endif.endif.endif.endif.else.endif.if.i.i, label %B0.endif.endif.endif.endif.endif.endif.else.endif.endif.i.i, !prof !30
B0.endif.endif.endif.endif.endif.endif.else.endif.if.i.i:
  br label %B0.endif.endif.endif.endif.endif.endif.else.endif.endif.i.i
B0.endif.endif.endif.endif.endif.endif.else.endif.endif.i.i:
  %.721.sroa.0.3.i.i = phi i64 [ %.639.i.i, %B0.endif.endif.endif.endif.endif.endif.else.endif.if.i.i ], [ 0, %B0.endif.endif.endif.endi...if.i.i ]
  %.748.i.i = icmp slt i64 %.465.fca.7.load.i.i, 0
  %.749.i.i = select i1 %.748.i.i, i64 %.639.i.i, i64 0
  %.750.i.i = add i64 %.749.i.i, %.465.fca.7.load.i.i
  %.753.i.i = icmp slt i64 %.750.i.i, 0
  br i1 %.753.i.i, label %B0.endif.endif.endif.endi...endif.4.i.i, label %B0.endif.endif.endif.endi...endif.2.thread.i.i, !prof !30
B0.endif.endif.endif.endi...endif.2.thread.i.i:
  %.758.not1965.i.i = icmp sgt i64 %.630.i.i, %.750.i.i
  br i1 %.758.not1965.i.i, label %B0.endif.endif.endif.endif.endif.endif.endif.else.endif.thread.i.i, label %B0.endif.endif.endif.endi...if.4.i.i, !prof !43
B0.endif.endif.endif.endif.endif.endif.endif.else.endif.thread.i.i:
  %.8091972.i.i = sub nsw i64 %.750.i.i, %.721.sroa.0.3.i.i
  %.8181973.i.i = tail call i64 @llvm.smax.i64(i64 %.8091972.i.i, i64 0)
  br label %B0.endif.endif.endif.endi...endif.4.i.i
B0.endif.endif.endif.endi...if.4.i.i:
  %.8091957.i.i = sub nsw i64 %.639.i.i, %.721.sroa.0.3.i.i
  %.8181958.i.i = tail call i64 @llvm.smax.i64(i64 %.8091957.i.i, i64 0)
  br label %B0.endif.endif.endif.endi...endif.4.i.i
B0.endif.endif.endif.endi...endif.4.i.i:
  %.81819612000.i.i = phi i64 [ %.8181958.i.i, %B0.endif.endif.endif.endi...if.4.i.i ], [ %.8181973.i.i, %B0.endif.endif.endif.endif.endif.endif.endif.else.endif.thread.i.i ], [ 0, %B0.endif.endif.endif.endif.endif.endif.else.endif.endif.i.i ]
  %.892.sroa.0.3.i.i = phi i64 [ %.639.i.i, %B0.endif.endif.endif.endi...if.4.i.i ], [ %.750.i.i, %B0.endif.endif.endif.endif.endif.endif.endif.else.endif.thread.i.i ], [ 0, %B0.endif.endif.endif.endif.endif.endif.else.endif.endif.i.i ]
  %.86619631998.i.i = mul nsw i64 %.465.fca.7.load.i.i, 5
  %.921.i.i = add i64 %.749.i.i, %.86619631998.i.i
  %.924.i.i = icmp slt i64 %.921.i.i, 0
  br i1 %.924.i.i, label %B0.endif.endif.endif.endi...endif.6.endif.i.i, label %B0.endif.endif.endif.endi...endif.4.endif.thread.i.i, !prof !30
B0.endif.endif.endif.endi...endif.4.endif.thread.i.i:
  %.929.not1983.i.i = icmp sgt i64 %.630.i.i, %.921.i.i
  br i1 %.929.not1983.i.i, label %B0.endif.endif.endif.endi...endif.6.thread.i.i, label %B0.endif.endif.endif.endi...endif.6.if.i.i, !prof !43
B0.endif.endif.endif.endi...endif.6.thread.i.i:
  %.9801990.i.i = sub nsw i64 %.921.i.i, %.892.sroa.0.3.i.i
  %.9891991.i.i = tail call i64 @llvm.smax.i64(i64 %.9801990.i.i, i64 0)
  br label %B0.endif.endif.endif.endi...endif.6.endif.i.i
B0.endif.endif.endif.endi...endif.6.if.i.i:
  %.9801977.i.i = sub nsw i64 %.639.i.i, %.892.sroa.0.3.i.i
  %.9891978.i.i = tail call i64 @llvm.smax.i64(i64 %.9801977.i.i, i64 0)
  br label %B0.endif.endif.endif.endi...endif.6.endif.i.i
B0.endif.endif.endif.endi...endif.6.endif.i.i:
  %.98919802032.i.i = phi i64 [ %.9891978.i.i, %B0.endif.endif.endif.endi...endif.6.if.i.i ], [ %.9891991.i.i, %B0.endif.endif.endif.endi...endif.6.thread.i.i ], [ 0, %B0.endif.endif.endif.endi...endif.4.i.i ]
  %.1064.sroa.0.3.i.i = phi i64 [ %.639.i.i, %B0.endif.endif.endif.endi...endif.6.if.i.i ], [ %.921.i.i, %B0.endif.endif.endif.endi...endif.6.thread.i.i ], [ 0, %B0.endif.endif.endif.endi...endif.4.i.i ]
  %.1093.i.i = add i64 %.749.i.i, %.292.i.i
  %.1096.i.i = icmp slt i64 %.1093.i.i, 0
  br i1 %.1096.i.i, label %B0.endif.endif.endif.endi...else.endif.endif.endif.if.i.i, label %B0.endif.endif.endif.endi...endif.6.endif.endif.thread.i.i, !prof !30
B0.endif.endif.endif.endi...endif.6.endif.endif.thread.i.i:
  %.1101.not2017.i.i = icmp sgt i64 %.630.i.i, %.1093.i.i
  br i1 %.1101.not2017.i.i, label %B0.endif.endif.endif.endi...else.endif.thread.i.i, label %B0.endif.endif.endif.endi...else.endif.if.i.i, !prof !43
B0.endif.endif.endif.endi...else.endif.thread.i.i:
  %.11522024.i.i = sub nsw i64 %.1093.i.i, %.1064.sroa.0.3.i.i
  %.11612025.i.i = tail call i64 @llvm.smax.i64(i64 %.11522024.i.i, i64 0)
  br label %B0.endif.endif.endif.endi...else.endif.endif.endif.if.i.i
B0.endif.endif.endif.endi...else.endif.if.i.i:
  %.11522011.i.i = sub nsw i64 %.639.i.i, %.1064.sroa.0.3.i.i
  %.11612012.i.i = tail call i64 @llvm.smax.i64(i64 %.11522011.i.i, i64 0)
  br label %B0.endif.endif.endif.endi...else.endif.endif.endif.if.i.i
B0.endif.endif.endif.endi...else.endif.endif.endif.if.i.i:
  %.116120142045.i.i = phi i64 [ %.11612012.i.i, %B0.endif.endif.endif.endi...else.endif.if.i.i ], [ %.11612025.i.i, %B0.endif.endif.endif.endi...else.endif.thread.i.i ], [ 0, %B0.endif.endif.endif.endi...endif.6.endif.i.i ]
  %.1235.sroa.0.3.i.i = phi i64 [ %.639.i.i, %B0.endif.endif.endif.endi...else.endif.if.i.i ], [ %.1093.i.i, %B0.endif.endif.endif.endi...else.endif.thread.i.i ], [ 0, %B0.endif.endif.endif.endi...endif.6.endif.i.i ]
  %.1323.i.i = sub nsw i64 %.639.i.i, %.1235.sroa.0.3.i.i
  %.1332.i.i = tail call i64 @llvm.smax.i64(i64 %.1323.i.i, i64 0)
  %2 = tail call i64 @llvm.umin.i64(i64 %.1332.i.i, i64 2)
  %.16742062.i.i = add nsw i64 %.465.fca.12.load.i.i, 2
  %.1727.i.i = icmp slt i64 %.465.fca.12.load.i.i, -2
  %.1728.i.i = select i1 %.1727.i.i, i64 %.1332.i.i, i64 0
  %.1729.i.i = add i64 %.16742062.i.i, %.1728.i.i
  %.1732.i.i = icmp slt i64 %.1729.i.i, 0
  %.1737.not2071.i.i = icmp sgt i64 %.1323.i.i, %.1729.i.i
  %.1729.i.i..1332.i.i = select i1 %.1737.not2071.i.i, i64 %.1729.i.i, i64 %.1332.i.i, !prof !43
  %.1872.sroa.0.3.i.i = select i1 %.1732.i.i, i64 0, i64 %.1729.i.i..1332.i.i, !prof !30
  %.1960.i.i = sub nsw i64 %.1332.i.i, %.1872.sroa.0.3.i.i
  %.1969.i.i = tail call i64 @llvm.smax.i64(i64 %.1960.i.i, i64 0)
  %.2078.i.i = icmp slt i64 %.1960.i.i, 1
  br i1 %.2078.i.i, label %B0.endif.endif.endif.endi...else.1.endif.if.i.i, label %B0.endif.endif.endif.endi...else.1.endif.endif.i.i, !prof !30
B0.endif.endif.endif.endi...else.1.endif.if.i.i:
  br label %B0.endif.endif.endif.endi...else.1.endif.endif.i.i
B0.endif.endif.endif.endi...else.1.endif.endif.i.i:
  %.2058.sroa.0.3.i.i = phi i64 [ %.1969.i.i, %B0.endif.endif.endif.endi...else.1.endif.if.i.i ], [ 0, %B0.endif.endif.endif.endi...else.endif.endif.endif.if.i.i ]
  %.2085.i.i = icmp slt i64 %.465.fca.13.load.i.i, 0
  %.2086.i.i = select i1 %.2085.i.i, i64 %.1969.i.i, i64 0
  %.2087.i.i = add i64 %.2086.i.i, %.465.fca.13.load.i.i
  %.2090.i.i = icmp slt i64 %.2087.i.i, 0
  %.2095.not2094.i.i = icmp sgt i64 %.1960.i.i, %.2087.i.i
  %.2087.i.i..1969.i.i = select i1 %.2095.not2094.i.i, i64 %.2087.i.i, i64 %.1969.i.i, !prof !43
  %.2229.sroa.0.3.i.i = select i1 %.2090.i.i, i64 0, i64 %.2087.i.i..1969.i.i, !prof !30
  %.2317.i.i = sub nsw i64 %.1969.i.i, %.2229.sroa.0.3.i.i
  %.2326.i.i = tail call i64 @llvm.smax.i64(i64 %.2317.i.i, i64 0)
  %.2428.i.i = icmp slt i64 %.2317.i.i, 1
  br i1 %.2428.i.i, label %B0.endif.endif.endif.endi...if.20.i.i, label %B0.endif.endif.endif.endi...endif.20.i.i, !prof !30
B0.endif.endif.endif.endi...if.20.i.i:
  br label %B0.endif.endif.endif.endi...endif.20.i.i
B0.endif.endif.endif.endi...endif.20.i.i:
  %.2408.sroa.0.3.i.i = phi i64 [ %.2326.i.i, %B0.endif.endif.endif.endi...if.20.i.i ], [ 0, %B0.endif.endif.endif.endi...else.1.endif.endif.i.i ]
  %.2435.i.i = icmp slt i64 %.465.fca.11.load.i.i, 0
  %.2436.i.i = select i1 %.2435.i.i, i64 %.2326.i.i, i64 0
  %.2437.i.i = add i64 %.2436.i.i, %.465.fca.11.load.i.i
  %.2440.i.i = icmp slt i64 %.2437.i.i, 0
  br i1 %.2440.i.i, label %B0.endif.endif.endif.endi...endif.22.endif.i.i, label %B0.endif.endif.endif.endi...endif.20.endif.thread.i.i, !prof !30
B0.endif.endif.endif.endi...endif.20.endif.thread.i.i:
  %.2445.not2126.i.i = icmp sgt i64 %.2317.i.i, %.2437.i.i
  br i1 %.2445.not2126.i.i, label %B0.endif.endif.endif.endi...endif.22.thread.i.i, label %B0.endif.endif.endif.endi...endif.22.if.i.i, !prof !43
B0.endif.endif.endif.endi...endif.22.thread.i.i:
  %.24962133.i.i = sub nsw i64 %.2437.i.i, %.2408.sroa.0.3.i.i
  %.25052134.i.i = tail call i64 @llvm.smax.i64(i64 %.24962133.i.i, i64 0)
  br label %B0.endif.endif.endif.endi...endif.22.endif.i.i
B0.endif.endif.endif.endi...endif.22.if.i.i:
  %.24962118.i.i = sub nsw i64 %.2326.i.i, %.2408.sroa.0.3.i.i
  %.25052119.i.i = tail call i64 @llvm.smax.i64(i64 %.24962118.i.i, i64 0)
  br label %B0.endif.endif.endif.endi...endif.22.endif.i.i
B0.endif.endif.endif.endi...endif.22.endif.i.i:
  %.250521222161.i.i = phi i64 [ %.25052119.i.i, %B0.endif.endif.endif.endi...endif.22.if.i.i ], [ %.25052134.i.i, %B0.endif.endif.endif.endi...endif.22.thread.i.i ], [ 0, %B0.endif.endif.endif.endi...endif.20.i.i ]
  %.2579.sroa.0.3.i.i = phi i64 [ %.2326.i.i, %B0.endif.endif.endif.endi...endif.22.if.i.i ], [ %.2437.i.i, %B0.endif.endif.endif.endi...endif.22.thread.i.i ], [ 0, %B0.endif.endif.endif.endi...endif.20.i.i ]
  %.2606.i.i = icmp slt i64 %.293.i.i, 0
  %.2607.i.i = select i1 %.2606.i.i, i64 %.2326.i.i, i64 0
  %.2608.i.i = add i64 %.2607.i.i, %.293.i.i
  %.2611.i.i = icmp slt i64 %.2608.i.i, 0
  %.2616.not2144.i.i = icmp sgt i64 %.2317.i.i, %.2608.i.i
  %.2608.i.i..2326.i.i = select i1 %.2616.not2144.i.i, i64 %.2608.i.i, i64 %.2326.i.i, !prof !43
  %.2750.sroa.0.3.i.i = select i1 %.2611.i.i, i64 0, i64 %.2608.i.i..2326.i.i, !prof !30
  %.2955.i.i = icmp slt i64 %.459.i.i, 1
  br i1 %.2955.i.i, label %B0.endif.endif.endif.endi...endif.24.else.endif.if.i.i, label %B0.endif.endif.endif.endi...endif.24.else.endif.endif.i.i, !prof !30
B0.endif.endif.endif.endi...endif.24.else.endif.if.i.i:
  br label %B0.endif.endif.endif.endi...endif.24.else.endif.endif.i.i
B0.endif.endif.endif.endi...endif.24.else.endif.endif.i.i:
  %.2935.sroa.0.3.i.i = phi i64 [ %.468.i.i, %B0.endif.endif.endif.endi...endif.24.else.endif.if.i.i ], [ 0, %B0.endif.endif.endif.endi...endif.22.endif.i.i ]
  %.2963.i.i = select i1 %.398.i.i, i64 %.468.i.i, i64 0
  %.2964.i.i = add i64 %.2963.i.i, %.465.fca.5.load.i.i
  %.2967.i.i = icmp slt i64 %.2964.i.i, 0
  %.2972.not2193.i.i = icmp sgt i64 %.459.i.i, %.2964.i.i
  %.2964.i.i..468.i.i = select i1 %.2972.not2193.i.i, i64 %.2964.i.i, i64 %.468.i.i, !prof !43
  %.3106.sroa.0.3.i.i = select i1 %.2967.i.i, i64 0, i64 %.2964.i.i..468.i.i, !prof !30
  %.308021912209.i.i = shl nsw i64 %.465.fca.5.load.i.i, 1
  %.3135.i.i = add i64 %.2963.i.i, %.308021912209.i.i
  %.3138.i.i = icmp slt i64 %.3135.i.i, 0
  br i1 %.3138.i.i, label %B0.endif.endif.endif.endi...endif.29.if.i.i, label %B0.endif.endif.endif.endi...endif.29.endif.i.i, !prof !30
B0.endif.endif.endif.endi...endif.24.endif.endif.i.i:
  %.3106.sroa.13.0.i.i = phi i64 [ %.468.i.i, %B0.endif.endif.endif.endi...endif.29.endif.if.i.i ], [ %.3106.sroa.13.1.i.i, %B0.endif.endif.endif.endi...endif.29.endif.i.i ]
  %.3251.i.i = mul nsw i64 %.465.fca.5.load.i.i, 6
  %.3289.i.i = add i64 %.2963.i.i, %.3251.i.i
  %.3292.i.i = icmp slt i64 %.3289.i.i, 0
  br i1 %.3292.i.i, label %B0.endif.endif.endif.endi...if.31.i.i, label %B0.endif.endif.endif.endi...endif.31.i.i, !prof !30
B0.endif.endif.endif.endi...endif.29.if.i.i:
  br label %B0.endif.endif.endif.endi...endif.29.endif.i.i
B0.endif.endif.endif.endi...endif.29.endif.i.i:
  %.3106.sroa.13.1.i.i = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.29.if.i.i ], [ %.3135.i.i, %B0.endif.endif.endif.endi...endif.24.else.endif.endif.i.i ]
  %.3143.not.i.i = icmp slt i64 %.3135.i.i, %.468.i.i
  br i1 %.3143.not.i.i, label %B0.endif.endif.endif.endi...endif.24.endif.endif.i.i, label %B0.endif.endif.endif.endi...endif.29.endif.if.i.i, !prof !43
B0.endif.endif.endif.endi...endif.29.endif.if.i.i:
  br label %B0.endif.endif.endif.endi...endif.24.endif.endif.i.i
B0.endif.endif.endif.endi...if.31.i.i:
  br label %B0.endif.endif.endif.endi...endif.31.i.i
B0.endif.endif.endif.endi...endif.31.i.i:
  %.3277.sroa.0.1.i.i = phi i64 [ 0, %B0.endif.endif.endif.endi...if.31.i.i ], [ %.3289.i.i, %B0.endif.endif.endif.endi...endif.24.endif.endif.i.i ]
  %.3297.not.i.i = icmp slt i64 %.3289.i.i, %.468.i.i
  br i1 %.3297.not.i.i, label %B0.endif.endif.endif.endi...endif.31.endif.endif.if.i.i, label %B0.endif.endif.endif.endi...endif.31.if.i.i, !prof !43
B0.endif.endif.endif.endi...endif.31.if.i.i:
  br label %B0.endif.endif.endif.endi...endif.31.endif.endif.if.i.i
B0.endif.endif.endif.endi...endif.31.endif.endif.if.i.i:
  %.3277.sroa.0.3.i.i = phi i64 [ %.468.i.i, %B0.endif.endif.endif.endi...endif.31.if.i.i ], [ %.3277.sroa.0.1.i.i, %B0.endif.endif.endif.endi...endif.31.i.i ]
  %.3422.i.i = mul nsw i64 %.465.fca.5.load.i.i, 11
  %.3460.i.i = add i64 %.2963.i.i, %.3422.i.i
  %.3463.i.i = icmp slt i64 %.3460.i.i, 0
  br i1 %.3463.i.i, label %B0.endif.endif.endif.endi...else.3.if.i.i, label %B0.endif.endif.endif.endi...else.3.endif.i.i, !prof !30
B0.endif.endif.endif.endi...else.3.if.i.i:
  br label %B0.endif.endif.endif.endi...else.3.endif.i.i
B0.endif.endif.endif.endi...else.3.endif.i.i:
  %.3448.sroa.0.1.i.i = phi i64 [ 0, %B0.endif.endif.endif.endi...else.3.if.i.i ], [ %.3460.i.i, %B0.endif.endif.endif.endi...endif.31.endif.endif.if.i.i ]
  %.3468.not.i.i = icmp slt i64 %.3460.i.i, %.468.i.i
  br i1 %.3468.not.i.i, label %B0.endif.endif.endif.endi...if.34.i.i, label %B0.endif.endif.endif.endi...else.3.endif.if.i.i, !prof !43
B0.endif.endif.endif.endi...else.3.endif.if.i.i:
  br label %B0.endif.endif.endif.endi...if.34.i.i
B0.endif.endif.endif.endi...if.34.i.i:
  %.3448.sroa.0.3.i.i = phi i64 [ %.468.i.i, %B0.endif.endif.endif.endi...else.3.endif.if.i.i ], [ %.3448.sroa.0.1.i.i, %B0.endif.endif.endif.endi...else.3.endif.i.i ]
  %.3594.i.i = mul nsw i64 %.465.fca.5.load.i.i, 3
  br i1 %.3138.i.i, label %B0.endif.endif.endif.endi...endif.33.else.if.i.i, label %B0.endif.endif.endif.endi...endif.33.else.endif.i.i, !prof !30
B0.endif.endif.endif.endi...endif.33.else.if.i.i:
  br label %B0.endif.endif.endif.endi...endif.33.else.endif.i.i
B0.endif.endif.endif.endi...endif.33.else.endif.i.i:
  %.3620.sroa.0.1.i.i = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.33.else.if.i.i ], [ %.3135.i.i, %B0.endif.endif.endif.endi...if.34.i.i ]
  br i1 %.3143.not.i.i, label %B0.endif.endif.endif.endi...endif.33.else.endif.endif.i.i, label %B0.endif.endif.endif.endi...endif.33.else.endif.if.i.i, !prof !43
B0.endif.endif.endif.endi...endif.33.else.endif.if.i.i:
  br label %B0.endif.endif.endif.endi...endif.33.else.endif.endif.i.i
B0.endif.endif.endif.endi...endif.33.else.endif.endif.i.i:
  %.3620.sroa.0.3.i.i = phi i64 [ %.468.i.i, %B0.endif.endif.endif.endi...endif.33.else.endif.if.i.i ], [ %.3620.sroa.0.1.i.i, %B0.endif.endif.endif.endi...endif.33.else.endif.i.i ]
  %.3649.i.i = add i64 %.2963.i.i, %.3594.i.i
  %.3652.i.i = icmp slt i64 %.3649.i.i, 0
  %.3657.not.i.i = icmp slt i64 %.3649.i.i, %.468.i.i
  %.3765.i.i = shl nsw i64 %.465.fca.5.load.i.i, 2
  %.3804.i.i = add i64 %.2963.i.i, %.3765.i.i
  %.3807.i.i = icmp slt i64 %.3804.i.i, 0
  br i1 %.3807.i.i, label %B0.endif.endif.endif.endi...endif.33.endif.else.if.i.i, label %B0.endif.endif.endif.endi...endif.33.endif.else.endif.i.i, !prof !30
B0.endif.endif.endif.endi...endif.33.endif.endif.i.i:
  %.3792.sroa.13.0.i.i = phi i64 [ %.468.i.i, %B0.endif.endif.endif.endi...endif.38.endif.if.i.i ], [ %.3792.sroa.13.1.i.i, %B0.endif.endif.endif.endi...endif.38.endif.i.i ]
  br i1 %.3652.i.i, label %B0.endif.endif.endif.endi...if.40.i.i, label %B0.endif.endif.endif.endi...endif.40.i.i, !prof !30
B0.endif.endif.endif.endi...endif.33.endif.else.if.i.i:
  br label %B0.endif.endif.endif.endi...endif.33.endif.else.endif.i.i
B0.endif.endif.endif.endi...endif.33.endif.else.endif.i.i:
  %.3792.sroa.0.1.i.i = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.33.endif.else.if.i.i ], [ %.3804.i.i, %B0.endif.endif.endif.endi...endif.33.else.endif.endif.i.i ]
  %.3812.not.i.i = icmp slt i64 %.3804.i.i, %.468.i.i
  br i1 %.3812.not.i.i, label %B0.endif.endif.endif.endi...endif.38.i.i, label %B0.endif.endif.endif.endi...if.38.i.i, !prof !43
B0.endif.endif.endif.endi...if.38.i.i:
  br label %B0.endif.endif.endif.endi...endif.38.i.i
B0.endif.endif.endif.endi...endif.38.i.i:
  %.3792.sroa.0.3.i.i = phi i64 [ %.468.i.i, %B0.endif.endif.endif.endi...if.38.i.i ], [ %.3792.sroa.0.1.i.i, %B0.endif.endif.endif.endi...endif.33.endif.else.endif.i.i ]
  br i1 %.3292.i.i, label %B0.endif.endif.endif.endi...endif.38.if.i.i, label %B0.endif.endif.endif.endi...endif.38.endif.i.i, !prof !30
B0.endif.endif.endif.endi...endif.38.if.i.i:
  br label %B0.endif.endif.endif.endi...endif.38.endif.i.i
B0.endif.endif.endif.endi...endif.38.endif.i.i:
  %.3792.sroa.13.1.i.i = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.38.if.i.i ], [ %.3289.i.i, %B0.endif.endif.endif.endi...endif.38.i.i ]
  br i1 %.3297.not.i.i, label %B0.endif.endif.endif.endi...endif.33.endif.endif.i.i, label %B0.endif.endif.endif.endi...endif.38.endif.if.i.i, !prof !43
B0.endif.endif.endif.endi...endif.38.endif.if.i.i:
  br label %B0.endif.endif.endif.endi...endif.33.endif.endif.i.i
B0.endif.endif.endif.endi...endif.33.endif.endif.endif.i.i:
  %.3964.sroa.13.0.i.i = phi i64 [ %.468.i.i, %B0.endif.endif.endif.endi...endif.40.endif.endif.if.i.i ], [ %.3964.sroa.13.1.i.i, %B0.endif.endif.endif.endi...endif.40.endif.endif.i.i ]
  %.4267.i.i = icmp slt i64 %.465.fca.9.load.i.i, 0
  %.4268.i.i = select i1 %.4267.i.i, i64 %.157.i.i, i64 0
  %.4269.i.i = add i64 %.4268.i.i, %.465.fca.9.load.i.i
  %.4272.i.i = icmp slt i64 %.4269.i.i, 0
  br i1 %.4272.i.i, label %B0.endif.endif.endif.endi...else.4.if.i.i, label %B0.endif.endif.endif.endi...else.4.endif.i.i, !prof !30
B0.endif.endif.endif.endi...if.40.i.i:
  br label %B0.endif.endif.endif.endi...endif.40.i.i
B0.endif.endif.endif.endi...endif.40.i.i:
  %.3964.sroa.0.1.i.i = phi i64 [ 0, %B0.endif.endif.endif.endi...if.40.i.i ], [ %.3649.i.i, %B0.endif.endif.endif.endi...endif.33.endif.endif.i.i ]
  br i1 %.3657.not.i.i, label %B0.endif.endif.endif.endi...endif.40.endif.i.i, label %B0.endif.endif.endif.endi...endif.40.if.i.i, !prof !43
B0.endif.endif.endif.endi...endif.40.if.i.i:
  br label %B0.endif.endif.endif.endi...endif.40.endif.i.i
B0.endif.endif.endif.endi...endif.40.endif.i.i:
  %.3964.sroa.0.3.i.i = phi i64 [ %.468.i.i, %B0.endif.endif.endif.endi...endif.40.if.i.i ], [ %.3964.sroa.0.1.i.i, %B0.endif.endif.endif.endi...endif.40.i.i ]
  br i1 %.3807.i.i, label %B0.endif.endif.endif.endi...endif.40.endif.if.i.i, label %B0.endif.endif.endif.endi...endif.40.endif.endif.i.i, !prof !30
B0.endif.endif.endif.endi...endif.40.endif.if.i.i:
  br label %B0.endif.endif.endif.endi...endif.40.endif.endif.i.i
B0.endif.endif.endif.endi...endif.40.endif.endif.i.i:
  %.3964.sroa.13.1.i.i = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.40.endif.if.i.i ], [ %.3804.i.i, %B0.endif.endif.endif.endi...endif.40.endif.i.i ]
  br i1 %.3812.not.i.i, label %B0.endif.endif.endif.endi...endif.33.endif.endif.endif.i.i, label %B0.endif.endif.endif.endi...endif.40.endif.endif.if.i.i, !prof !43
B0.endif.endif.endif.endi...endif.40.endif.endif.if.i.i:
  br label %B0.endif.endif.endif.endi...endif.33.endif.endif.endif.i.i
B0.endif.endif.endif.endi...else.4.if.i.i:
  br label %B0.endif.endif.endif.endi...else.4.endif.i.i
B0.endif.endif.endif.endi...else.4.endif.i.i:
  %.4257.sroa.0.1.i.i = phi i64 [ 0, %B0.endif.endif.endif.endi...else.4.if.i.i ], [ %.4269.i.i, %B0.endif.endif.endif.endi...endif.33.endif.endif.endif.i.i ]
  %.4277.not.i.i = icmp slt i64 %.4269.i.i, %.157.i.i
  br i1 %.4277.not.i.i, label %_ZN6poppet6engine10integrator7_run_ofB2v3B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE23Job_28int64_20x_2036_29.exit.i, label %B0.endif.endif.endif.endi...else.4.endif.if.i.i, !prof !43
B0.endif.endif.endif.endi...else.4.endif.if.i.i:
  br label %_ZN6poppet6engine10integrator7_run_ofB2v3B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE23Job_28int64_20x_2036_29.exit.i
_ZN6poppet6engine10integrator7_run_ofB2v3B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE23Job_28int64_20x_2036_29.exit.i:
  %.4257.sroa.0.3.i.i = phi i64 [ %.157.i.i, %B0.endif.endif.endif.endi...else.4.endif.if.i.i ], [ %.4257.sroa.0.1.i.i, %B0.endif.endif.endif.endi...else.4.endif.i.i ]
  %.298.i.i = mul nsw i64 %.465.fca.6.load.i.i, 24
  %.299.i.i = add nsw i64 %.465.fca.34.load.i.i, %.298.i.i
  %.300.i.i = inttoptr i64 %.299.i.i to ptr
  %.484.i.i = getelementptr double, ptr %.300.i.i, i64 %.371.sroa.0.3.i.i
  %.4077.i.i = getelementptr double, ptr %.484.i.i, i64 %.3964.sroa.0.3.i.i
  %.4052.i.i = sub nsw i64 %.3964.sroa.13.0.i.i, %.3964.sroa.0.3.i.i
  %.4061.i.i = tail call i64 @llvm.smax.i64(i64 %.4052.i.i, i64 0)
  %.3905.i.i = getelementptr double, ptr %.484.i.i, i64 %.3792.sroa.0.3.i.i
  %.3880.i.i = sub nsw i64 %.3792.sroa.13.0.i.i, %.3792.sroa.0.3.i.i
  %.3889.i.i = tail call i64 @llvm.smax.i64(i64 %.3880.i.i, i64 0)
  %.3733.i.i = getelementptr double, ptr %.484.i.i, i64 %.3620.sroa.0.3.i.i
  %.3561.i.i = getelementptr double, ptr %.484.i.i, i64 %.3448.sroa.0.3.i.i
  %.3390.i.i = getelementptr double, ptr %.484.i.i, i64 %.3277.sroa.0.3.i.i
  %.3219.i.i = getelementptr double, ptr %.484.i.i, i64 %.3106.sroa.0.3.i.i
  %.3194.i.i = sub nsw i64 %.3106.sroa.13.0.i.i, %.3106.sroa.0.3.i.i
  %.3203.i.i = tail call i64 @llvm.smax.i64(i64 %.3194.i.i, i64 0)
  %.304821902210.i.i = getelementptr double, ptr %.484.i.i, i64 %.2935.sroa.0.3.i.i
  %.655.i.i = getelementptr double, ptr %.300.i.i, i64 %.542.sroa.0.3.i.i
  %.1348.i.i = getelementptr double, ptr %.655.i.i, i64 %.1235.sroa.0.3.i.i
  %.1985.i.i = getelementptr double, ptr %.1348.i.i, i64 %.1872.sroa.0.3.i.i
  %.2342.i.i = getelementptr double, ptr %.1985.i.i, i64 %.2229.sroa.0.3.i.i
  %.2863.i.i = getelementptr double, ptr %.2342.i.i, i64 %.2750.sroa.0.3.i.i
  %.2838.i.i = sub nsw i64 %.2326.i.i, %.2750.sroa.0.3.i.i
  %.2847.i.i = tail call i64 @llvm.smax.i64(i64 %.2838.i.i, i64 0)
  %.269221422175.i.i = getelementptr double, ptr %.2342.i.i, i64 %.2579.sroa.0.3.i.i
  %.252121232160.i.i = getelementptr double, ptr %.2342.i.i, i64 %.2408.sroa.0.3.i.i
  %.217120922108.i.i = getelementptr double, ptr %.1985.i.i, i64 %.2058.sroa.0.3.i.i
  %.181320692085.i.i = getelementptr double, ptr %.1348.i.i, i64 %2
  %.117720152044.i.i = getelementptr double, ptr %.655.i.i, i64 %.1064.sroa.0.3.i.i
  %.100519812031.i.i = getelementptr double, ptr %.655.i.i, i64 %.892.sroa.0.3.i.i
  %.83419621999.i.i = getelementptr double, ptr %.655.i.i, i64 %.721.sroa.0.3.i.i
  %.243.i.i = inttoptr i64 %.465.fca.34.load.i.i to ptr
  %.200.i.i = inttoptr i64 %.465.fca.27.load.i.i to ptr
  %.155.i.i = inttoptr i64 %.465.fca.22.load.i.i to ptr
  %.4345.i.i = sub i64 %.157.i.i, %.4257.sroa.0.3.i.i
  %.4354.i.i = tail call i64 @llvm.smax.i64(i64 %.4345.i.i, i64 0)
  %.4370.i.i = getelementptr double, ptr %.155.i.i, i64 %.4257.sroa.0.3.i.i
  %.4403.i.i = inttoptr i64 %.465.fca.16.load.i.i to ptr
  %.4479.i.i = inttoptr i64 %.465.fca.15.load.i.i to ptr
  %.4547.i.i = load double, ptr %.200.i.i, align 8, !noalias !44
  %.4575.i.i = getelementptr i8, ptr %.200.i.i, i64 8
  %.4576.i.i = load double, ptr %.4575.i.i, align 8, !noalias !44
  %.4578.i.i = inttoptr i64 %.465.fca.35.load.i.i to ptr
  %.4646.i.i = getelementptr i8, ptr %.200.i.i, i64 16
  %.4647.i.i = load double, ptr %.4646.i.i, align 8, !noalias !44
  %.4651.i.i = fcmp ogt double %.4647.i.i, 0.000000e+00
  %.4681.i.i = inttoptr i64 %.465.fca.26.load.i.i to ptr
  %.4723.i.i = inttoptr i64 %.465.fca.30.load.i.i to ptr
  %.4798.i.i = inttoptr i64 %.465.fca.28.load.i.i to ptr
  %.4848.i.i = inttoptr i64 %.465.fca.29.load.i.i to ptr
  %.4920.i.i = inttoptr i64 %.465.fca.21.load.i.i to ptr
  %.4961.i.i = inttoptr i64 %.465.fca.31.load.i.i to ptr
  %.5003.i.i = inttoptr i64 %.465.fca.32.load.i.i to ptr
  %.5082.i.i = inttoptr i64 %.465.fca.33.load.i.i to ptr
  %.1011.i = inttoptr i64 %.465.fca.23.load.i.i to ptr
  %.1054.i = inttoptr i64 %.465.fca.25.load.i.i to ptr
  %.1115.i = inttoptr i64 %.465.fca.24.load.i.i to ptr
  %.1228.i = inttoptr i64 %.465.fca.14.load.i.i to ptr
  %.193303.not.i.i = icmp slt i64 %.465.fca.6.load.i.i, 1
  br i1 %.193303.not.i.i, label %_ZN6poppet6engine8stepping14set_tolerancesB3v13B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE158Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_295ArrayIdLi2E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B56.if.lr.ph.i.i
B56.if.lr.ph.i.i:
  %.1324.i = getelementptr i8, ptr %.200.i.i, i64 24
  %.1325.i = load double, ptr %.1324.i, align 8, !noalias !44
  %.idx.i.i = shl i64 %.465.fca.6.load.i.i, 4
  %3 = getelementptr i8, ptr %.1228.i, i64 %.idx.i.i
  %.383.i.i = fmul double %.1325.i, 2.500000e-01
  %4 = getelementptr double, ptr %.1228.i, i64 %.465.fca.6.load.i.i
  %5 = getelementptr double, ptr %.243.i.i, i64 %.465.fca.6.load.i.i
  %6 = getelementptr i8, ptr %.243.i.i, i64 %.idx.i.i
  br label %B56.if.i.i
B140.i.i:
  %.265.i.i = tail call double @llvm.fabs.f64(double %.264.i.i)
  br label %B162.i.i
B144.i.i:
  %7 = getelementptr double, ptr %3, i64 %.135.0304.i.i
  %.375.i.i = load double, ptr %7, align 8, !noalias !51
  br label %B162.i.i
B162.i.i:
  %"$phi162.1.2.1.i.i" = phi double [ %.265.i.i, %B140.i.i ], [ %.375.i.i, %B144.i.i ]
  %.437.i.i = getelementptr double, ptr %.1228.i, i64 %.135.0304.i.i
  %.438.i.i = load double, ptr %.437.i.i, align 8, !noalias !51
  %.439.i.i = fmul double %.383.i.i, %.438.i.i
  %.499.i.i = getelementptr double, ptr %.243.i.i, i64 %.135.0304.i.i
  store double %.439.i.i, ptr %.499.i.i, align 8, !noalias !51
  %.625.i.i = getelementptr double, ptr %4, i64 %.135.0304.i.i
  %.626.i.i = load double, ptr %.625.i.i, align 8, !noalias !51
  %.627.i.i = fmul double %.439.i.i, %.626.i.i
  %.628.i.i = fmul double %"$phi162.1.2.1.i.i", %.627.i.i
  %.688.i.i = getelementptr double, ptr %5, i64 %.135.0304.i.i
  store double %.628.i.i, ptr %.688.i.i, align 8, !noalias !51
  %.756.i.i = getelementptr double, ptr %6, i64 %.135.0304.i.i
  store double %"$phi162.1.2.1.i.i", ptr %.756.i.i, align 8, !noalias !51
  %exitcond.not.i4714.i = icmp eq i64 %.206.i.i, %.465.fca.6.load.i.i
  br i1 %exitcond.not.i4714.i, label %_ZN6poppet6engine8stepping14set_tolerancesB3v13B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE158Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_295ArrayIdLi2E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B56.if.i.i
B56.if.i.i:
  %.135.0304.i.i = phi i64 [ 0, %B56.if.lr.ph.i.i ], [ %.206.i.i, %B162.i.i ]
  %.206.i.i = add nuw nsw i64 %.135.0304.i.i, 1
  %8 = getelementptr double, ptr %.4920.i.i, i64 %.135.0304.i.i
  %.264.i.i = load double, ptr %8, align 8, !noalias !51
  %9 = getelementptr i8, ptr %.4479.i.i, i64 %.135.0304.i.i
  %.303.i4713.i = load i8, ptr %9, align 1, !noalias !51
  %.307.i.i = icmp ne i8 %.303.i4713.i, 0
  %.310.i.i = fcmp one double %.264.i.i, 0.000000e+00
  %or.cond.i.i = select i1 %.307.i.i, i1 %.310.i.i, i1 false
  br i1 %or.cond.i.i, label %B140.i.i, label %B144.i.i
_ZN6poppet6engine8stepping14set_tolerancesB3v13B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE158Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_295ArrayIdLi2E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE.exit.i:
  %.14724852.not.i = icmp slt i64 %.465.fca.5.load.i.i, 1
  br i1 %.14724852.not.i, label %B818.i, label %B688.if.preheader.i
B688.if.preheader.i:
  %invariant.gep.i = getelementptr double, ptr %.4961.i.i, i64 %.465.fca.5.load.i.i
  %invariant.gep4928.i = getelementptr double, ptr %.4961.i.i, i64 %.308021912209.i.i
  br label %B688.if.i
B818.i:
  %.1733.i = getelementptr i8, ptr %.5082.i.i, i64 24
  store i64 -1, ptr %.1733.i, align 8, !noalias !44
  %.20084855.not.i = icmp slt i64 %.465.fca.17.load.i.i, 1
  br i1 %.20084855.not.i, label %B818.B1542_crit_edge.i, label %B950.if.lr.ph.i
B818.B1542_crit_edge.i:
  %.1764.i = load double, ptr %.1011.i, align 8, !noalias !44
  %.pre.i = add nsw i64 %.465.fca.18.load.i.i, -1
  br label %B1542.i
B950.if.lr.ph.i:
  %10 = getelementptr double, ptr %.4681.i.i, i64 %.465.fca.18.load.i.i
  %.2170.i = getelementptr i8, ptr %10, i64 -8
  %.2296.i = icmp sgt i64 %.465.fca.11.load.i.i, 0
  %.2438.i = icmp sgt i64 %.465.fca.19.load.i.i, 0
  %.151223.not.i.i.i.i = icmp eq i64 %.81819612000.i.i, 0
  %.992.i.i.i = inttoptr i64 %.465.fca.3.load.i.i to ptr
  %.2783.i = icmp sgt i64 %.465.fca.5.load.i.i, 0
  %.fca.1.gep.i4753.i = getelementptr inbounds i8, ptr %.1307.i.i, i64 8
  %.636.i.not.i = icmp eq i64 %.250521222161.i.i, 0
  %.980.i.i = getelementptr i8, ptr %.5082.i.i, i64 16
  %.996.i.i = add i64 %.465.fca.18.load.i.i, -1
  %11 = add i64 %.465.fca.18.load.i.i, -2
  %.1415.i.i = icmp ne i64 %.250521222161.i.i, 0
  %spec.select.i.i.i = tail call i64 @llvm.smax.i64(i64 %.465.fca.7.load.i.i, i64 0)
  %.1553.i.i = icmp sgt i64 %.465.fca.20.load.i.i, 0
  %.151243.not.i.i.i.i = icmp eq i64 %.116120142045.i.i, 0
  %.822.i.i.i = inttoptr i64 %.465.fca.0.load.i.i to ptr
  %.idx.i.i.i.i = shl i64 %.465.fca.6.load.i.i, 4
  %12 = getelementptr i8, ptr %.243.i.i, i64 %.idx.i.i.i.i
  %.26.i.i.i = add nsw i64 %.465.fca.20.load.i.i, -1
  %.2365.i.i = getelementptr i8, ptr %.1348.i.i, i64 8
  %.2493.i.i = inttoptr i64 %.465.fca.1.load.i.i to ptr
  %13 = getelementptr double, ptr %.243.i.i, i64 %.465.fca.6.load.i.i
  %.2668.i.i = getelementptr i8, ptr %.5082.i.i, i64 8
  %.fca.1.gep.i.i.i = getelementptr inbounds i8, ptr %.1113.i.i.i, i64 8
  %.10933044.i.i.i = inttoptr i64 %.465.fca.2.load.i.i to ptr
  %.idx.i.i6063.i.i = shl i64 %.465.fca.5.load.i.i, 4
  %invariant.gep.i.i.i.i = getelementptr i8, ptr %.4961.i.i, i64 %.idx.i.i6063.i.i
  %invariant.gep853.i.i.i.i = getelementptr double, ptr %.4961.i.i, i64 %.465.fca.5.load.i.i
  %.704.i.i.i = getelementptr i8, ptr %.5082.i.i, i64 32
  %.1283.i.i.i = getelementptr i8, ptr %.5003.i.i, i64 8
  br label %B950.if.i
B948.sink.split.i:
  %h.4.14896.ph.i = phi double [ %"$phi1316.1.2.1.i", %B298.endif.i.i ], [ %h.7.1.i.i, %B2104.i.i ]
  %t.5.14895.ph.i = phi double [ %.2090.i, %B298.endif.i.i ], [ %t.3.1.i.i, %B2104.i.i ]
  call void @llvm.lifetime.end.p0(ptr nonnull %.3740.i.i), !noalias !44
  br label %B948.i
B948.i:
  %h.4.14896.i = phi double [ %"$phi1316.1.2.1.i", %_ZN6poppet6engine10integrator15_without_statesB3v42B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c ], [ %h.4.14896.ph.i, %B948.sink.split.i ]
  %t.5.14895.i = phi double [ %t.3.1.i4754.i, %_ZN6poppet6engine10integrator15_without_statesB3v42B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c ], [ %t.5.14895.ph.i, %B948.sink.split.i ]
  %exitcond4890.not.i = icmp eq i64 %.2021.i, %.465.fca.17.load.i.i
  br i1 %exitcond4890.not.i, label %B1542.i, label %B950.if.i
B1090.i:
  store i8 0, ptr %.2306.i, align 1, !noalias !44
  call fastcc void @v44(ptr %.2306.i, i64 %.465.fca.4.load.i.i, ptr %.155.i.i, i64 %.4354.i.i, ptr %.4370.i.i, ptr %.4403.i.i, i64 %.250521222161.i.i, ptr %.252121232160.i.i, ptr %.269221422175.i.i, i64 %.81819612000.i.i, ptr %.83419621999.i.i, ptr %.1348.i.i, double %.2090.i, ptr %.2227.i, i64 6, double %.2090.i, ptr %.4920.i.i)
  br label %B1146.i
B1146.i:
  br i1 %.2438.i, label %B1168.i, label %B1292.i
B1168.i:
  %.40.i.i.i.i = fsub double %.2090.i, %.2090.i
  br i1 %.151223.not.i.i.i.i, label %_ZN6poppet6engine8stepping10outputs_atB3v20B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_, label %B78.if.i.i.i.i
B158.i.i.i.i:
  %.423.i.i.i.i = getelementptr i8, ptr %.245.i.i.i.i, i64 24
  %.424.i.i.i.i = load double, ptr %.423.i.i.i.i, align 8, !noalias !54
  %.478.i.i.i.i = getelementptr i8, ptr %.245.i.i.i.i, i64 32
  %.479.i.i.i.i = load double, ptr %.478.i.i.i.i, align 8, !noalias !54
  %.480.i.i.i.i = fmul double %.479.i.i.i.i, 5.000000e-01
  %.482.i.i.i.i = fmul double %.40.i.i.i.i, %.480.i.i.i.i
  %.483.i.i.i.i = fadd double %.424.i.i.i.i, %.482.i.i.i.i
  %.484.i.i.i.i = fmul double %.483.i.i.i.i, 0x401921FB54442D18
  %.486.i.i.i.i = fmul double %.40.i.i.i.i, %.484.i.i.i.i
  %.540.i.i.i.i = getelementptr i8, ptr %.245.i.i.i.i, i64 40
  %.541.i.i.i.i = load double, ptr %.540.i.i.i.i, align 8, !noalias !54
  %.542.i.i.i.i = fadd double %.541.i.i.i.i, %.486.i.i.i.i
  %.605.le.i.i.i.i = tail call double @llvm.sin.f64(double %.542.i.i.i.i)
  %.610.i.i.i.i = fmul double %.366.i.i.i.i, %.605.le.i.i.i.i
  %.612.i.i.i.i = fadd double %.304.i.i.i.i, %.610.i.i.i.i
  br label %B340.i.i.i.i
B340.i.i.i.i:
  %value.2.1.i.i.i.i = phi double [ %.612.i.i.i.i, %B158.i.i.i.i ], [ %.304.i.i.i.i, %B78.if.i.i.i.i ]
  %14 = getelementptr double, ptr %.83419621999.i.i, i64 %.93.0224.i.i.i.i
  store double %value.2.1.i.i.i.i, ptr %14, align 8, !noalias !54
  %exitcond.not.i.i.i.i = icmp eq i64 %.81819612000.i.i, %.164.i.i.i.i
  br i1 %exitcond.not.i.i.i.i, label %_ZN6poppet6engine8stepping10outputs_atB3v20B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_, label %B78.if.i.i.i.i
B78.if.i.i.i.i:
  %.93.0224.i.i.i.i = phi i64 [ %.164.i.i.i.i, %B340.i.i.i.i ], [ 0, %B1168.i ]
  %.164.i.i.i.i = add nuw nsw i64 %.93.0224.i.i.i.i, 1
  %.245.i.i.i.idx.i = mul i64 %.93.0224.i.i.i.i, 48
  %.245.i.i.i.i = getelementptr i8, ptr %.2227.i, i64 %.245.i.i.i.idx.i
  %.246.i.i.i.i = load double, ptr %.245.i.i.i.i, align 8, !noalias !54
  %.300.i.i.i.i = getelementptr i8, ptr %.245.i.i.i.i, i64 8
  %.301.i.i.i.i = load double, ptr %.300.i.i.i.i, align 8, !noalias !54
  %.303.i.i.i.i = fmul double %.40.i.i.i.i, %.301.i.i.i.i
  %.304.i.i.i.i = fadd double %.246.i.i.i.i, %.303.i.i.i.i
  %.365.i.i.i.i = getelementptr i8, ptr %.245.i.i.i.i, i64 16
  %.366.i.i.i.i = load double, ptr %.365.i.i.i.i, align 8, !noalias !54
  %.367.i.i.i.i = fcmp une double %.366.i.i.i.i, 0.000000e+00
  br i1 %.367.i.i.i.i, label %B158.i.i.i.i, label %B340.i.i.i.i
_ZN6poppet6engine8stepping10outputs_atB3v20B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_:
  store double %.2090.i, ptr %.1348.i.i, align 8, !noalias !61
  tail call void %.992.i.i.i(ptr nonnull %.1348.i.i, ptr %.4920.i.i, ptr %.83419621999.i.i, ptr %.155.i.i, ptr %.2863.i.i), !noalias !61
  br label %B140.i4715.i
B140.i4715.i:
  %.859.0.i.i = phi i64 [ 0, %_ZN6poppet6engine8stepping10outputs_atB3v20B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_ ], [ %.928.i.i, %B288.i.i ]
  %exitcond294.not.i.i = icmp eq i64 %.859.0.i.i, %.465.fca.19.load.i.i
  br i1 %exitcond294.not.i.i, label %_ZN6poppet6engine8stepping14stop_conditionB3v19B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c4803, label %B142.i.i
_ZN6poppet6engine8stepping14stop_conditionB3v19B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c4803:
  store i64 -1, ptr %.1733.i, align 8, !noalias !44
  br label %B1292.i
B142.i.i:
  %.idx.i = mul i64 %.859.0.i.i, 24
  %15 = getelementptr i8, ptr %.4848.i.i, i64 %.idx.i
  %.1009.i.i = getelementptr i8, ptr %15, i64 16
  %.1010.i.i = load double, ptr %.1009.i.i, align 8, !noalias !62
  %.idx4838.i = shl i64 %.859.0.i.i, 4
  %16 = getelementptr i8, ptr %.4798.i.i, i64 %.idx4838.i
  br label %B194.if.i.i
B226.i.i:
  %17 = getelementptr double, ptr %15, i64 %.1037.0289.i.i
  %.1249.i.i = load double, ptr %17, align 8, !noalias !62
  %.1338.i.i = getelementptr double, ptr %.2863.i.i, i64 %.1191.i.i
  %.1339.i.i = load double, ptr %.1338.i.i, align 8, !noalias !62
  %.1340.i.i = fmul double %.1249.i.i, %.1339.i.i
  %.1342.i.i = fadd double %value.2.1291.i.i, %.1340.i.i
  br label %B286.i.i
B286.i.i:
  %value.3.2.i.i = phi double [ %.1342.i.i, %B226.i.i ], [ %value.2.1291.i.i, %B194.if.i.i ]
  br i1 %exitcond.not.i4716.i, label %B288.i.i, label %B194.if.i.i
B288.i.i:
  %.928.i.i = add nuw i64 %.859.0.i.i, 1
  %.1361.i.i = fcmp ogt double %value.3.2.i.i, 0.000000e+00
  br i1 %.1361.i.i, label %_ZN6poppet6engine8stepping14stop_conditionB3v19B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C, label %B140.i4715.i
B194.if.i.i:
  %value.2.1291.i.i = phi double [ %.1010.i.i, %B142.i.i ], [ %value.3.2.i.i, %B286.i.i ]
  %exitcond.not.i4716.i = phi i1 [ false, %B142.i.i ], [ true, %B286.i.i ]
  %.1037.0289.i.i = phi i64 [ 0, %B142.i.i ], [ 1, %B286.i.i ]
  %18 = getelementptr i64, ptr %16, i64 %.1037.0289.i.i
  %.1191.i.i = load i64, ptr %18, align 8, !noalias !62
  %.1194.i.i = icmp sgt i64 %.1191.i.i, -1
  br i1 %.1194.i.i, label %B226.i.i, label %B286.i.i
_ZN6poppet6engine8stepping14stop_conditionB3v19B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C:
  store i64 %.859.0.i.i, ptr %.1733.i, align 8, !noalias !44
  br label %B1542.i
B1292.i:
  %19 = getelementptr i8, ptr %.1054.i, i64 %.1918.04856.i
  %.2757.i = load i8, ptr %19, align 1, !noalias !44
  %.2760.not.i = icmp eq i8 %.2757.i, 0
  %.2763.i = fneg double %h.3.04858.i
  %"$phi1316.1.2.1.i" = select i1 %.2760.not.i, double %h.3.04858.i, double %.2763.i
  br i1 %.2783.i, label %B1330.i, label %B1374.i
B1330.i:
  call void @llvm.lifetime.start.p0(ptr nonnull %.3740.i.i), !noalias !44
  br label %B66.i.i.i
B66.i.i.i:
  %.75.0.i.i.i = phi i64 [ 0, %B1330.i ], [ %.146.i.i.i, %B108.i.i.i ]
  %exitcond.not.i.i.i = icmp eq i64 %.75.0.i.i.i, %spec.select.i.i.i
  br i1 %exitcond.not.i.i.i, label %_ZN6poppet6engine8stepping6variesB3v22B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE72Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_29.exit.i.i, label %B66.if.i.i.i
B108.i.i.i:
  %.146.i.i.i = add nuw i64 %.75.0.i.i.i, 1
  %.303.i.i.i = getelementptr i8, ptr %20, i64 16
  %.304.i.i.i = load double, ptr %.303.i.i.i, align 8, !noalias !63
  %.310.i.i.i = fcmp une double %.304.i.i.i, 0.000000e+00
  br i1 %.310.i.i.i, label %_ZN6poppet6engine8stepping6variesB3v22B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE72Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_29.exit.i.i, label %B66.i.i.i
B66.if.i.i.i:
  %.idx4839.i = mul i64 %.75.0.i.i.i, 48
  %20 = getelementptr i8, ptr %.2227.i, i64 %.idx4839.i
  %.233.i.i.i = getelementptr i8, ptr %20, i64 8
  %.234.i.i.i = load double, ptr %.233.i.i.i, align 8, !noalias !63
  %.240.i.i.i = fcmp une double %.234.i.i.i, 0.000000e+00
  br i1 %.240.i.i.i, label %_ZN6poppet6engine8stepping6variesB3v22B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE72Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_29.exit.i.i, label %B108.i.i.i
_ZN6poppet6engine8stepping6variesB3v22B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE72Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_29.exit.i.i:
  %.747.i.i.i = fadd double %.2090.i, 0.000000e+00
  %.40.i.i.i4717.i = fsub double %.747.i.i.i, %.2090.i
  br label %switch.end.else.endif.i.i.i
switch.end.endif.i.i.i:
  %.888.sroa.13.0.i.i.i = phi i64 [ %.98919802032.i.i, %switch.end.else.endif.endif.endif.if.i.i.i ], [ %.862.i.i.i, %switch.end.else.endif.endif.endif.i.i.i ]
  %.976.i.i.i = sub nsw i64 %.888.sroa.13.0.i.i.i, %.888.sroa.0.3.i.i.i
  %.1001.i.i.i = getelementptr double, ptr %.100519812031.i.i, i64 %.888.sroa.0.3.i.i.i
  %.151223.not.i.i.i4718.i = icmp slt i64 %.976.i.i.i, 1
  br i1 %.151223.not.i.i.i4718.i, label %_ZN6poppet6engine8stepping9inputs_atB3v18B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd72Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_295ArrayIdLi1E1C7mutable7alignedE.exit.i.i.i, label %B78.if.i.i.i4719.i
B158.i.i.i4737.i:
  %.423.i.i.i4738.i = getelementptr i8, ptr %.245.i.i.i4723.i, i64 24
  %.424.i.i.i4739.i = load double, ptr %.423.i.i.i4738.i, align 8, !noalias !69
  %.478.i.i.i4740.i = getelementptr i8, ptr %.245.i.i.i4723.i, i64 32
  %.479.i.i.i4741.i = load double, ptr %.478.i.i.i4740.i, align 8, !noalias !69
  %.480.i.i.i4742.i = fmul double %.479.i.i.i4741.i, 5.000000e-01
  %.482.i.i.i4743.i = fmul double %.40.i.i.i4717.i, %.480.i.i.i4742.i
  %.483.i.i.i4744.i = fadd double %.424.i.i.i4739.i, %.482.i.i.i4743.i
  %.484.i.i.i4745.i = fmul double %.483.i.i.i4744.i, 0x401921FB54442D18
  %.486.i.i.i4746.i = fmul double %.40.i.i.i4717.i, %.484.i.i.i4745.i
  %.540.i.i.i4747.i = getelementptr i8, ptr %.245.i.i.i4723.i, i64 40
  %.541.i.i.i4748.i = load double, ptr %.540.i.i.i4747.i, align 8, !noalias !69
  %.542.i.i.i4749.i = fadd double %.541.i.i.i4748.i, %.486.i.i.i4746.i
  %.605.le.i.i.i4750.i = tail call double @llvm.sin.f64(double %.542.i.i.i4749.i)
  %.610.i.i.i4751.i = fmul double %.366.i.i.i4730.i, %.605.le.i.i.i4750.i
  %.612.i.i.i4752.i = fadd double %.304.i.i.i4728.i, %.610.i.i.i4751.i
  br label %B340.i.i.i4732.i
B340.i.i.i4732.i:
  %value.2.1.i.i.i4733.i = phi double [ %.612.i.i.i4752.i, %B158.i.i.i4737.i ], [ %.304.i.i.i4728.i, %B78.if.i.i.i4719.i ]
  %21 = getelementptr double, ptr %.1001.i.i.i, i64 %.93.0224.i.i.i4720.i
  store double %value.2.1.i.i.i4733.i, ptr %21, align 8, !noalias !69
  %exitcond.not.i.i.i4734.i = icmp eq i64 %.976.i.i.i, %.164.i.i.i4721.i
  br i1 %exitcond.not.i.i.i4734.i, label %_ZN6poppet6engine8stepping9inputs_atB3v18B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd72Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_295ArrayIdLi1E1C7mutable7alignedE.exit.i.i.i, label %B78.if.i.i.i4719.i
B78.if.i.i.i4719.i:
  %.93.0224.i.i.i4720.i = phi i64 [ %.164.i.i.i4721.i, %B340.i.i.i4732.i ], [ 0, %switch.end.endif.i.i.i ]
  %.164.i.i.i4721.i = add nuw nsw i64 %.93.0224.i.i.i4720.i, 1
  %.245.i.i.i4723.idx.i = mul i64 %.93.0224.i.i.i4720.i, 48
  %.245.i.i.i4723.i = getelementptr i8, ptr %.2227.i, i64 %.245.i.i.i4723.idx.i
  %.246.i.i.i4724.i = load double, ptr %.245.i.i.i4723.i, align 8, !noalias !69
  %.300.i.i.i4725.i = getelementptr i8, ptr %.245.i.i.i4723.i, i64 8
  %.301.i.i.i4726.i = load double, ptr %.300.i.i.i4725.i, align 8, !noalias !69
  %.303.i.i.i4727.i = fmul double %.40.i.i.i4717.i, %.301.i.i.i4726.i
  %.304.i.i.i4728.i = fadd double %.246.i.i.i4724.i, %.303.i.i.i4727.i
  %.365.i.i.i4729.i = getelementptr i8, ptr %.245.i.i.i4723.i, i64 16
  %.366.i.i.i4730.i = load double, ptr %.365.i.i.i4729.i, align 8, !noalias !69
  %.367.i.i.i4731.i = fcmp une double %.366.i.i.i4730.i, 0.000000e+00
  br i1 %.367.i.i.i4731.i, label %B158.i.i.i4737.i, label %B340.i.i.i4732.i
_ZN6poppet6engine8stepping9inputs_atB3v18B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd72Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_295ArrayIdLi1E1C7mutable7alignedE.exit.i.i.i:
  %exitcond.not.i5936.i.i = icmp eq i64 %.687.i.i.i, 4
  br i1 %exitcond.not.i5936.i.i, label %B298.endif.i.i, label %switch.end.else.endif.i.i.i
switch.end.else.endif.i.i.i:
  %.616.0585.i.i.i = phi i64 [ 0, %_ZN6poppet6engine8stepping6variesB3v22B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE72Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_29.exit.i.i ], [ %.687.i.i.i, %_ZN6poppet6engine8stepping9inputs_atB3v18B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd72Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_295ArrayIdLi1E1C7mutable7alignedE.exit.i.i.i ]
  %.687.i.i.i = add nuw nsw i64 %.616.0585.i.i.i, 1
  %.862.i.i.i = mul nuw nsw i64 %.687.i.i.i, %.81819612000.i.i
  %.859.i.i.i = mul nuw nsw i64 %.616.0585.i.i.i, %.81819612000.i.i
  %.908.not.i.i.i = icmp ult i64 %.859.i.i.i, %.98919802032.i.i
  br i1 %.908.not.i.i.i, label %switch.end.else.endif.endif.endif.i.i.i, label %switch.end.else.endif.if.i.i.i, !prof !43
switch.end.else.endif.if.i.i.i:
  br label %switch.end.else.endif.endif.endif.i.i.i
switch.end.else.endif.endif.endif.i.i.i:
  %.888.sroa.0.3.i.i.i = phi i64 [ %.98919802032.i.i, %switch.end.else.endif.if.i.i.i ], [ %.859.i.i.i, %switch.end.else.endif.i.i.i ]
  %.925.not.i.i.i = icmp ult i64 %.862.i.i.i, %.98919802032.i.i
  br i1 %.925.not.i.i.i, label %switch.end.endif.i.i.i, label %switch.end.else.endif.endif.endif.if.i.i.i, !prof !43
switch.end.else.endif.endif.endif.if.i.i.i:
  br label %switch.end.endif.i.i.i
B384.i.i:
  %h.6.0.i.i = phi double [ %h.7.1.i.i, %B2104.i.i ], [ %"$phi1316.1.2.1.i", %B384.preheader.i.i ]
  %t.2.0.i.i = phi double [ %t.3.1.i.i, %B2104.i.i ], [ %.2090.i, %B384.preheader.i.i ]
  %error_before.2.0.i.i = phi double [ %error_before.3.1.i.i, %B2104.i.i ], [ 1.000000e-02, %B384.preheader.i.i ]
  %step_before.3.0.i.i = phi double [ %step_before.4.1.i.i, %B2104.i.i ], [ 0.000000e+00, %B384.preheader.i.i ]
  %rejected.3.0.i.i = phi i1 [ %rejected.4.1.i.i, %B2104.i.i ], [ false, %B384.preheader.i.i ]
  %fresh.3.0.i.i = phi i1 [ %fresh.4.1.i.i, %B2104.i.i ], [ true, %B384.preheader.i.i ]
  %window.2.0.i.i = phi double [ %window.3.1.i.i, %B2104.i.i ], [ %.2090.i, %B384.preheader.i.i ]
  %calm.2.0.i.i = phi double [ %calm.3.1.i.i, %B2104.i.i ], [ %.2090.i, %B384.preheader.i.i ]
  %first.3.0.i.i = phi double [ %first.4.1.i.i, %B2104.i.i ], [ 0.000000e+00, %B384.preheader.i.i ]
  %has_changed.3.0.i.i = phi i1 [ %has_changed.4.1.i.i, %B2104.i.i ], [ true, %B384.preheader.i.i ]
  %has_acted.4.0.i.i = phi i1 [ %has_acted.5.1.i.i, %B2104.i.i ], [ %.1415.i.i, %B384.preheader.i.i ]
  br i1 %fresh.3.0.i.i, label %B388.i.i, label %B438.i.i
B388.i.i:
  store double %t.2.0.i.i, ptr %.1348.i.i, align 8, !noalias !75
  %.40.i.i5937.i.i = fsub double %t.2.0.i.i, %.2090.i
  br i1 %.151223.not.i.i.i.i, label %_ZN6poppet6engine8stepping9inputs_atB3v18B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd72Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_295ArrayIdLi1E1C7mutable7alignedE.exit.i5955.i.i, label %B78.if.i.i5939.i.i
B158.i.i5956.i.i:
  %.423.i.i5957.i.i = getelementptr i8, ptr %.245.i.i5943.i.i, i64 24
  %.424.i.i5958.i.i = load double, ptr %.423.i.i5957.i.i, align 8, !noalias !78
  %.478.i.i5959.i.i = getelementptr i8, ptr %.245.i.i5943.i.i, i64 32
  %.479.i.i5960.i.i = load double, ptr %.478.i.i5959.i.i, align 8, !noalias !78
  %.480.i.i5961.i.i = fmul double %.479.i.i5960.i.i, 5.000000e-01
  %.482.i.i5962.i.i = fmul double %.40.i.i5937.i.i, %.480.i.i5961.i.i
  %.483.i.i5963.i.i = fadd double %.424.i.i5958.i.i, %.482.i.i5962.i.i
  %.484.i.i5964.i.i = fmul double %.483.i.i5963.i.i, 0x401921FB54442D18
  %.486.i.i5965.i.i = fmul double %.40.i.i5937.i.i, %.484.i.i5964.i.i
  %.540.i.i5966.i.i = getelementptr i8, ptr %.245.i.i5943.i.i, i64 40
  %.541.i.i5967.i.i = load double, ptr %.540.i.i5966.i.i, align 8, !noalias !78
  %.542.i.i5968.i.i = fadd double %.541.i.i5967.i.i, %.486.i.i5965.i.i
  %.605.le.i.i5969.i.i = tail call double @llvm.sin.f64(double %.542.i.i5968.i.i)
  %.610.i.i5970.i.i = fmul double %.366.i.i5950.i.i, %.605.le.i.i5969.i.i
  %.612.i.i5971.i.i = fadd double %.304.i.i5948.i.i, %.610.i.i5970.i.i
  br label %B340.i.i5952.i.i
B340.i.i5952.i.i:
  %value.2.1.i.i5953.i.i = phi double [ %.612.i.i5971.i.i, %B158.i.i5956.i.i ], [ %.304.i.i5948.i.i, %B78.if.i.i5939.i.i ]
  %22 = getelementptr double, ptr %.83419621999.i.i, i64 %.93.0224.i.i5940.i.i
  store double %value.2.1.i.i5953.i.i, ptr %22, align 8, !noalias !78
  %exitcond.not.i.i5954.i.i = icmp eq i64 %.81819612000.i.i, %.164.i.i5941.i.i
  br i1 %exitcond.not.i.i5954.i.i, label %_ZN6poppet6engine8stepping9inputs_atB3v18B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd72Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_295ArrayIdLi1E1C7mutable7alignedE.exit.i5955.i.i, label %B78.if.i.i5939.i.i
B78.if.i.i5939.i.i:
  %.93.0224.i.i5940.i.i = phi i64 [ %.164.i.i5941.i.i, %B340.i.i5952.i.i ], [ 0, %B388.i.i ]
  %.164.i.i5941.i.i = add nuw nsw i64 %.93.0224.i.i5940.i.i, 1
  %.245.i.i5943.i.idx.i = mul i64 %.93.0224.i.i5940.i.i, 48
  %.245.i.i5943.i.i = getelementptr i8, ptr %.2227.i, i64 %.245.i.i5943.i.idx.i
  %.246.i.i5944.i.i = load double, ptr %.245.i.i5943.i.i, align 8, !noalias !78
  %.300.i.i5945.i.i = getelementptr i8, ptr %.245.i.i5943.i.i, i64 8
  %.301.i.i5946.i.i = load double, ptr %.300.i.i5945.i.i, align 8, !noalias !78
  %.303.i.i5947.i.i = fmul double %.40.i.i5937.i.i, %.301.i.i5946.i.i
  %.304.i.i5948.i.i = fadd double %.246.i.i5944.i.i, %.303.i.i5947.i.i
  %.365.i.i5949.i.i = getelementptr i8, ptr %.245.i.i5943.i.i, i64 16
  %.366.i.i5950.i.i = load double, ptr %.365.i.i5949.i.i, align 8, !noalias !78
  %.367.i.i5951.i.i = fcmp une double %.366.i.i5950.i.i, 0.000000e+00
  br i1 %.367.i.i5951.i.i, label %B158.i.i5956.i.i, label %B340.i.i5952.i.i
_ZN6poppet6engine8stepping9inputs_atB3v18B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd72Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_295ArrayIdLi1E1C7mutable7alignedE.exit.i5955.i.i:
  br i1 %.151243.not.i.i.i.i, label %_ZN6poppet6engine8stepping15input_slopes_atB3v25B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd72Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_295ArrayIdLi1E1C7mutable7alignedE.exit.i.i.i, label %B78.if.i1366.i.i.i
B130.i.i.i.i:
  %.365.i1372.i.i.i = getelementptr i8, ptr %24, i64 24
  %.366.i1373.i.i.i = load double, ptr %.365.i1372.i.i.i, align 8, !noalias !81
  %.420.i.i.i.i = getelementptr i8, ptr %24, i64 32
  %.421.i.i.i.i = load double, ptr %.420.i.i.i.i, align 8, !noalias !81
  %.422.i.i.i.i = fmul double %.421.i.i.i.i, 5.000000e-01
  %.424.i1374.i.i.i = fmul double %.40.i.i5937.i.i, %.422.i.i.i.i
  %.425.i.i.i.i = fadd double %.366.i1373.i.i.i, %.424.i1374.i.i.i
  %.426.i.i.i.i = fmul double %.425.i.i.i.i, 0x401921FB54442D18
  %.428.i.i.i.i = fmul double %.40.i.i5937.i.i, %.426.i.i.i.i
  %.482.i1375.i.i.i = getelementptr i8, ptr %24, i64 40
  %.483.i1376.i.i.i = load double, ptr %.482.i1375.i.i.i, align 8, !noalias !81
  %.484.i1377.i.i.i = fadd double %.483.i1376.i.i.i, %.428.i.i.i.i
  %.597.i.i.i.i = fmul double %.40.i.i5937.i.i, %.421.i.i.i.i
  %.598.i.i.i.i = fadd double %.366.i1373.i.i.i, %.597.i.i.i.i
  %.599.i.i.i.i = fmul double %.598.i.i.i.i, 0x401921FB54442D18
  %.655.i.i.i.i = fmul double %.308.i.i.i.i, %.599.i.i.i.i
  %.663.le.i.i.i.i = tail call double @llvm.cos.f64(double %.484.i1377.i.i.i)
  %.668.i.i.i.i = fmul double %.655.i.i.i.i, %.663.le.i.i.i.i
  %.670.i.i.i.i = fadd double %.246.i1370.i.i.i, %.668.i.i.i.i
  br label %B394.i.i.i.i
B394.i.i.i.i:
  %slope.2.1.i.i.i.i = phi double [ %.670.i.i.i.i, %B130.i.i.i.i ], [ %.246.i1370.i.i.i, %B78.if.i1366.i.i.i ]
  %23 = getelementptr double, ptr %.117720152044.i.i, i64 %.93.0244.i.i.i.i
  store double %slope.2.1.i.i.i.i, ptr %23, align 8, !noalias !81
  %exitcond.not.i1371.i.i.i = icmp eq i64 %.116120142045.i.i, %.164.i1367.i.i.i
  br i1 %exitcond.not.i1371.i.i.i, label %_ZN6poppet6engine8stepping15input_slopes_atB3v25B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd72Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_295ArrayIdLi1E1C7mutable7alignedE.exit.i.i.i, label %B78.if.i1366.i.i.i
B78.if.i1366.i.i.i:
  %.93.0244.i.i.i.i = phi i64 [ %.164.i1367.i.i.i, %B394.i.i.i.i ], [ 0, %_ZN6poppet6engine8stepping9inputs_atB3v18B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd72Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_295ArrayIdLi1E1C7mutable7alignedE.exit.i5955.i.i ]
  %.164.i1367.i.i.i = add nuw nsw i64 %.93.0244.i.i.i.i, 1
  %.idx4840.i = mul i64 %.93.0244.i.i.i.i, 48
  %24 = getelementptr i8, ptr %.2227.i, i64 %.idx4840.i
  %.245.i1369.i.i.i = getelementptr i8, ptr %24, i64 8
  %.246.i1370.i.i.i = load double, ptr %.245.i1369.i.i.i, align 8, !noalias !81
  %.307.i.i.i.i = getelementptr i8, ptr %24, i64 16
  %.308.i.i.i.i = load double, ptr %.307.i.i.i.i, align 8, !noalias !81
  %.309.i.i.i.i = fcmp une double %.308.i.i.i.i, 0.000000e+00
  br i1 %.309.i.i.i.i, label %B130.i.i.i.i, label %B394.i.i.i.i
_ZN6poppet6engine8stepping15input_slopes_atB3v25B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd72Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_295ArrayIdLi1E1C7mutable7alignedE.exit.i.i.i:
  tail call void %.822.i.i.i(ptr nonnull %.1348.i.i, ptr %.4920.i.i, ptr %.83419621999.i.i, ptr %.117720152044.i.i, ptr %.155.i.i, ptr %.304821902210.i.i, ptr %.181320692085.i.i, ptr %.3219.i.i), !noalias !75
  %.849.i.i.i = fcmp ogt double %h.6.0.i.i, 0.000000e+00
  br i1 %.849.i.i.i, label %B438.i.i, label %B298.i.i.i
B298.i.i.i:
  %.994.i.i.i = fsub double %"$phi1038.4.2.1.i", %t.2.0.i.i
  %.447.i.i.i.i = fdiv double 2.000000e+01, %.994.i.i.i
  br i1 %.193303.not.i.i, label %_ZN6poppet6engine8stepping10first_stepB3v26B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29d.exit.i.i.i, label %B90.if.i.i.i.i
B90.if.i.i.i.i:
  %fastest.2.0730.i.i.i.i = phi double [ %.13.i.i.i.i.i, %B90.if.i.i.i.i ], [ %.447.i.i.i.i, %B298.i.i.i ]
  %.527.0729.i.i.i.i = phi i64 [ %.598.i1378.i.i.i, %B90.if.i.i.i.i ], [ 0, %B298.i.i.i ]
  %.598.i1378.i.i.i = add nuw nsw i64 %.527.0729.i.i.i.i, 1
  %25 = getelementptr double, ptr %.304821902210.i.i, i64 %.527.0729.i.i.i.i
  %.761.i.i.i.i = load double, ptr %25, align 8, !noalias !84
  %.765.i.i.i.i = tail call double @llvm.fabs.f64(double %.761.i.i.i.i)
  %.766.i.i.i.i = fmul double %.765.i.i.i.i, 2.000000e+01
  %26 = getelementptr double, ptr %.4920.i.i, i64 %.527.0729.i.i.i.i
  %.800.i.i.i.i = load double, ptr %26, align 8, !noalias !84
  %.804.i.i.i.i = tail call double @llvm.fabs.f64(double %.800.i.i.i.i)
  %27 = getelementptr double, ptr %12, i64 %.527.0729.i.i.i.i
  %.858.i.i.i.i = load double, ptr %27, align 8, !noalias !84
  %.859.i.i.i.i = fadd double %.804.i.i.i.i, %.858.i.i.i.i
  %.863.i.i.i.i = fdiv double %.766.i.i.i.i, %.859.i.i.i.i
  %.12.i.i.i.i.i = fcmp ogt double %.863.i.i.i.i, %fastest.2.0730.i.i.i.i
  %.13.i.i.i.i.i = select i1 %.12.i.i.i.i.i, double %.863.i.i.i.i, double %fastest.2.0730.i.i.i.i
  %exitcond.not.i1379.i.i.i = icmp eq i64 %.598.i1378.i.i.i, %.465.fca.6.load.i.i
  br i1 %exitcond.not.i1379.i.i.i, label %_ZN6poppet6engine8stepping10first_stepB3v26B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29d.exit.i.i.i, label %B90.if.i.i.i.i
_ZN6poppet6engine8stepping10first_stepB3v26B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29d.exit.i.i.i:
  %fastest.2.0.lcssa.i.i.i.i = phi double [ %.447.i.i.i.i, %B298.i.i.i ], [ %.13.i.i.i.i.i, %B90.if.i.i.i.i ]
  %.1029.i.i.i.i = fdiv double 1.000000e+00, %fastest.2.0.lcssa.i.i.i.i
  %.1231.i.i.i = fcmp olt double %h.6.0.i.i, 0.000000e+00
  br i1 %.1231.i.i.i, label %B358.i.i.i, label %B438.i.i
B358.i.i.i:
  %.1234.i.i.i = fneg double %h.6.0.i.i
  %.12.i.i.i.i = fcmp olt double %.1029.i.i.i.i, %.1234.i.i.i
  %.13.i.i.i.i = select i1 %.12.i.i.i.i, double %.1029.i.i.i.i, double %.1234.i.i.i
  br label %B438.i.i
B438.i.i:
  %h.9.1.i.i = phi double [ %h.6.0.i.i, %B384.i.i ], [ %h.6.0.i.i, %_ZN6poppet6engine8stepping15input_slopes_atB3v25B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd72Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_295ArrayIdLi1E1C7mutable7alignedE.exit.i.i.i ], [ %.13.i.i.i.i, %B358.i.i.i ], [ %.1029.i.i.i.i, %_ZN6poppet6engine8stepping10first_stepB3v26B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29d.exit.i.i.i ]
  %.12.i.i5972.i.i = fcmp olt double %.4547.i.i, %h.9.1.i.i
  %.13.i.i5973.i.i = select i1 %.12.i.i5972.i.i, double %.4547.i.i, double %h.9.1.i.i
  br i1 %.1415.i.i, label %B78.if.i.i5974.i.i, label %_ZN6poppet6engine10integrator6_reachB3v28B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_29
B78.if.i.i5974.i.i:
  %first.2.0129.i.i.i.i = phi double [ %.13.i.i.i5976.i.i, %B78.if.i.i5974.i.i ], [ 0x7FF0000000000000, %B438.i.i ]
  %.106.0128.i.i.i.i = phi i64 [ %.177.i.i.i.i, %B78.if.i.i5974.i.i ], [ 0, %B438.i.i ]
  %.177.i.i.i.i = add nuw nsw i64 %.106.0128.i.i.i.i, 1
  %28 = getelementptr double, ptr %.4370.i.i, i64 %.106.0128.i.i.i.i
  %.235.i.i.i.i = load double, ptr %28, align 8, !noalias !87
  %.12.i.i.i5975.i.i = fcmp olt double %.235.i.i.i.i, %first.2.0129.i.i.i.i
  %.13.i.i.i5976.i.i = select i1 %.12.i.i.i5975.i.i, double %.235.i.i.i.i, double %first.2.0129.i.i.i.i
  %exitcond.not.i.i5977.i.i = icmp eq i64 %.250521222161.i.i, %.177.i.i.i.i
  br i1 %exitcond.not.i.i5977.i.i, label %_ZN6poppet6engine8stepping12next_instantB3v16B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE199Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit.i.i.i, label %B78.if.i.i5974.i.i
_ZN6poppet6engine8stepping12next_instantB3v16B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE199Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit.i.i.i:
  %.818.i.i.i = fcmp uge double %.13.i.i.i5976.i.i, %.816.i.i.i
  %29 = or i1 %.2438.i, %.818.i.i.i
  %brmerge.i.i.i = select i1 %29, i1 true, i1 %.1553.i.i
  %arg.segment.1.mux.i.i.i = select i1 %.818.i.i.i, double %"$phi1038.4.2.1.i", double %.13.i.i.i5976.i.i
  br i1 %brmerge.i.i.i, label %_ZN6poppet6engine10integrator6_reachB3v28B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_29, label %B220.i.i.i
B220.i.i.i:
  %.828.i.i.i = fsub double %.13.i.i.i5976.i.i, %t.2.0.i.i
  %.831.i.i.i = fsub double %t.2.0.i.i, %calm.2.0.i.i
  %.832.i.i.i = fcmp ult double %.828.i.i.i, %.831.i.i.i
  br i1 %.832.i.i.i, label %B252.i.i.i, label %_ZN6poppet6engine10integrator6_reachB3v28B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_29
B252.i.i.i:
  %.12.i999.i.i.i = fcmp olt double %.831.i.i.i, %.13.i.i5973.i.i
  %.13.i1000.i.i.i = select i1 %.12.i999.i.i.i, double %.831.i.i.i, double %.13.i.i5973.i.i
  br label %_ZN6poppet6engine10integrator6_reachB3v28B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_29
_ZN6poppet6engine10integrator6_reachB3v28B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_29:
  %wanted.2.0.sink.i.i.i = phi double [ %.13.i.i5973.i.i, %B438.i.i ], [ %.13.i.i5973.i.i, %B220.i.i.i ], [ %.13.i1000.i.i.i, %B252.i.i.i ], [ %.13.i.i5973.i.i, %_ZN6poppet6engine8stepping12next_instantB3v16B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE199Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit.i.i.i ]
  %arg.segment.1.sink.i.i.i = phi double [ %"$phi1038.4.2.1.i", %B438.i.i ], [ %.13.i.i.i5976.i.i, %B220.i.i.i ], [ %"$phi1038.4.2.1.i", %B252.i.i.i ], [ %arg.segment.1.mux.i.i.i, %_ZN6poppet6engine8stepping12next_instantB3v16B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE199Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit.i.i.i ]
  br i1 %.4651.i.i, label %B498.i.i, label %B560.i.i
B498.i.i:
  %.2076.i.i = load i64, ptr %.5082.i.i, align 8, !noalias !92
  %.2079.i.i = fsub double %arg.segment.1.sink.i.i.i, %t.2.0.i.i
  %.13.i.i5978.i.i = tail call i64 @llvm.smin.i64(i64 %.26.i.i.i, i64 %.2076.i.i)
  %.69.i.i.i = icmp slt i64 %.13.i.i5978.i.i, 0
  %.70.i.i.i = select i1 %.69.i.i.i, i64 %.465.fca.20.load.i.i, i64 0
  %30 = getelementptr double, ptr %.4578.i.i, i64 %.13.i.i5978.i.i
  %.84.i.i.i = getelementptr double, ptr %30, i64 %.70.i.i.i
  %.85.i.i.i = load double, ptr %.84.i.i.i, align 8, !noalias !93
  %.93.i.i.i = fcmp ugt double %.85.i.i.i, 0.000000e+00
  %.97.i.i.i = fcmp ult double %.85.i.i.i, %.2079.i.i
  %or.cond.i.i.i = select i1 %.93.i.i.i, i1 %.97.i.i.i, i1 false
  %"$phi94.0.2.0.i.i.i" = select i1 %or.cond.i.i.i, double %.85.i.i.i, double %.2079.i.i
  br label %B606.i.i
B560.i.i:
  %.2113.i.i = fsub double %arg.segment.1.sink.i.i.i, %t.2.0.i.i
  %.11.i.i.i = fmul double %.2113.i.i, 5.000000e-01
  %.13.i.i.i = fcmp olt double %wanted.2.0.sink.i.i.i, %.11.i.i.i
  %.24.i.i.i = fcmp olt double %wanted.2.0.sink.i.i.i, %.2113.i.i
  %.11.arg.remaining.i.i.i = select i1 %.24.i.i.i, double %.11.i.i.i, double %.2113.i.i
  %storemerge.i5979.i.i = select i1 %.13.i.i.i, double %wanted.2.0.sink.i.i.i, double %.11.arg.remaining.i.i.i
  br label %B606.i.i
B606.i.i:
  %"$phi606.0.2.1.in.sroa.speculated.i.i" = phi double [ %"$phi94.0.2.0.i.i.i", %B498.i.i ], [ %storemerge.i5979.i.i, %B560.i.i ]
  br i1 %exitcond.not.i.i.i, label %B658.i.i, label %B68.if.i5980.i.i
B68.if.i5980.i.i:
  %.616.0585.i5981.i.i = phi i64 [ %.687.i5982.i.i, %_ZN6poppet6engine8stepping9inputs_atB3v18B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd72Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_295ArrayIdLi1E1C7mutable7alignedE.exit.i6029.i.i ], [ 0, %B606.i.i ]
  %.687.i5982.i.i = add nuw nsw i64 %.616.0585.i5981.i.i, 1
  %31 = icmp ult i64 %.616.0585.i5981.i.i, 4
  br i1 %31, label %switch.lookup, label %B1330.if.i
switch.end.endif.i6007.i.i:
  %.888.sroa.13.0.i6008.i.i = phi i64 [ %.98919802032.i.i, %switch.end.else.endif.endif.endif.if.i6006.i.i ], [ %.862.i5987.i.i, %switch.end.else.endif.endif.endif.i6003.i.i ]
  %.976.i6009.i.i = sub nsw i64 %.888.sroa.13.0.i6008.i.i, %.888.sroa.0.3.i5998.i.i
  %.1001.i6010.i.i = getelementptr double, ptr %.100519812031.i.i, i64 %.888.sroa.0.3.i5998.i.i
  %.40.i.i6011.i.i = fsub double %.747.i5986.i.i, %.2090.i
  %.151223.not.i.i6012.i.i = icmp slt i64 %.976.i6009.i.i, 1
  br i1 %.151223.not.i.i6012.i.i, label %_ZN6poppet6engine8stepping9inputs_atB3v18B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd72Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_295ArrayIdLi1E1C7mutable7alignedE.exit.i6029.i.i, label %B78.if.i.i6013.i.i
B158.i.i6033.i.i:
  %.423.i.i6034.i.i = getelementptr i8, ptr %.245.i.i6017.i.i, i64 24
  %.424.i.i6035.i.i = load double, ptr %.423.i.i6034.i.i, align 8, !noalias !96
  %.478.i.i6036.i.i = getelementptr i8, ptr %.245.i.i6017.i.i, i64 32
  %.479.i.i6037.i.i = load double, ptr %.478.i.i6036.i.i, align 8, !noalias !96
  %.480.i.i6038.i.i = fmul double %.479.i.i6037.i.i, 5.000000e-01
  %.482.i.i6039.i.i = fmul double %.40.i.i6011.i.i, %.480.i.i6038.i.i
  %.483.i.i6040.i.i = fadd double %.424.i.i6035.i.i, %.482.i.i6039.i.i
  %.484.i.i6041.i.i = fmul double %.483.i.i6040.i.i, 0x401921FB54442D18
  %.486.i.i6042.i.i = fmul double %.40.i.i6011.i.i, %.484.i.i6041.i.i
  %.540.i.i6043.i.i = getelementptr i8, ptr %.245.i.i6017.i.i, i64 40
  %.541.i.i6044.i.i = load double, ptr %.540.i.i6043.i.i, align 8, !noalias !96
  %.542.i.i6045.i.i = fadd double %.541.i.i6044.i.i, %.486.i.i6042.i.i
  %.605.le.i.i6046.i.i = tail call double @llvm.sin.f64(double %.542.i.i6045.i.i)
  %.610.i.i6047.i.i = fmul double %.366.i.i6024.i.i, %.605.le.i.i6046.i.i
  %.612.i.i6048.i.i = fadd double %.304.i.i6022.i.i, %.610.i.i6047.i.i
  br label %B340.i.i6026.i.i
B340.i.i6026.i.i:
  %value.2.1.i.i6027.i.i = phi double [ %.612.i.i6048.i.i, %B158.i.i6033.i.i ], [ %.304.i.i6022.i.i, %B78.if.i.i6013.i.i ]
  %32 = getelementptr double, ptr %.1001.i6010.i.i, i64 %.93.0224.i.i6014.i.i
  store double %value.2.1.i.i6027.i.i, ptr %32, align 8, !noalias !96
  %exitcond.not.i.i6028.i.i = icmp eq i64 %.976.i6009.i.i, %.164.i.i6015.i.i
  br i1 %exitcond.not.i.i6028.i.i, label %_ZN6poppet6engine8stepping9inputs_atB3v18B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd72Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_295ArrayIdLi1E1C7mutable7alignedE.exit.i6029.i.i, label %B78.if.i.i6013.i.i
B78.if.i.i6013.i.i:
  %.93.0224.i.i6014.i.i = phi i64 [ %.164.i.i6015.i.i, %B340.i.i6026.i.i ], [ 0, %switch.end.endif.i6007.i.i ]
  %.164.i.i6015.i.i = add nuw nsw i64 %.93.0224.i.i6014.i.i, 1
  %.245.i.i6017.i.idx.i = mul i64 %.93.0224.i.i6014.i.i, 48
  %.245.i.i6017.i.i = getelementptr i8, ptr %.2227.i, i64 %.245.i.i6017.i.idx.i
  %.246.i.i6018.i.i = load double, ptr %.245.i.i6017.i.i, align 8, !noalias !96
  %.300.i.i6019.i.i = getelementptr i8, ptr %.245.i.i6017.i.i, i64 8
  %.301.i.i6020.i.i = load double, ptr %.300.i.i6019.i.i, align 8, !noalias !96
  %.303.i.i6021.i.i = fmul double %.40.i.i6011.i.i, %.301.i.i6020.i.i
  %.304.i.i6022.i.i = fadd double %.246.i.i6018.i.i, %.303.i.i6021.i.i
  %.365.i.i6023.i.i = getelementptr i8, ptr %.245.i.i6017.i.i, i64 16
  %.366.i.i6024.i.i = load double, ptr %.365.i.i6023.i.i, align 8, !noalias !96
  %.367.i.i6025.i.i = fcmp une double %.366.i.i6024.i.i, 0.000000e+00
  br i1 %.367.i.i6025.i.i, label %B158.i.i6033.i.i, label %B340.i.i6026.i.i
_ZN6poppet6engine8stepping9inputs_atB3v18B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd72Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_295ArrayIdLi1E1C7mutable7alignedE.exit.i6029.i.i:
  %exitcond.not.i6030.i.i = icmp eq i64 %.687.i5982.i.i, 4
  br i1 %exitcond.not.i6030.i.i, label %B658.i.i, label %B68.if.i5980.i.i
switch.lookup:
  %switch.gep = getelementptr inbounds double, ptr @switch.table.integrate, i64 %.616.0585.i5981.i.i
  %switch.load = load double, ptr %switch.gep, align 8
  %.745.i.i.i = fmul double %"$phi606.0.2.1.in.sroa.speculated.i.i", %switch.load
  %.747.i5986.i.i = fadd double %t.2.0.i.i, %.745.i.i.i
  %.862.i5987.i.i = mul nuw nsw i64 %.687.i5982.i.i, %.81819612000.i.i
  %.859.i5988.i.i = mul nuw nsw i64 %.616.0585.i5981.i.i, %.81819612000.i.i
  %.908.not.i5995.i.i = icmp ult i64 %.859.i5988.i.i, %.98919802032.i.i
  br i1 %.908.not.i5995.i.i, label %switch.end.else.endif.endif.endif.i6003.i.i, label %switch.end.else.endif.if.i5996.i.i, !prof !43
switch.end.else.endif.if.i5996.i.i:
  br label %switch.end.else.endif.endif.endif.i6003.i.i
switch.end.else.endif.endif.endif.i6003.i.i:
  %.888.sroa.0.3.i5998.i.i = phi i64 [ %.98919802032.i.i, %switch.end.else.endif.if.i5996.i.i ], [ %.859.i5988.i.i, %switch.lookup ]
  %.925.not.i6005.i.i = icmp ult i64 %.862.i5987.i.i, %.98919802032.i.i
  br i1 %.925.not.i6005.i.i, label %switch.end.endif.i6007.i.i, label %switch.end.else.endif.endif.endif.if.i6006.i.i, !prof !43
switch.end.else.endif.endif.endif.if.i6006.i.i:
  br label %switch.end.endif.i6007.i.i
B658.i.i:
  %.2272.i.i = fsub double %arg.segment.1.sink.i.i.i, %t.2.0.i.i
  %.2273.i.i = fmul double %.2272.i.i, 0x3FEFFFFFFFFFDCD1
  %.2275.i.i = fcmp ult double %"$phi606.0.2.1.in.sroa.speculated.i.i", %.2273.i.i
  %.2284.i.i = fadd double %t.2.0.i.i, %"$phi606.0.2.1.in.sroa.speculated.i.i"
  %"$phi694.0.2.1.i.i" = select i1 %.2275.i.i, double %.2284.i.i, double %arg.segment.1.sink.i.i.i
  store double %t.2.0.i.i, ptr %.1348.i.i, align 8, !noalias !92
  store double %"$phi606.0.2.1.in.sroa.speculated.i.i", ptr %.2365.i.i, align 8, !noalias !92
  tail call void %.2493.i.i(ptr nonnull %.1348.i.i, ptr %.4920.i.i, ptr %.100519812031.i.i, ptr %.155.i.i, ptr %.304821902210.i.i, ptr %.181320692085.i.i, ptr %.3219.i.i, ptr %.217120922108.i.i, ptr %.3390.i.i, ptr %.3733.i.i), !noalias !92
  br i1 %.193303.not.i.i, label %_ZN6poppet6engine8stepping5errorB3v32B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29.exit.thread6118.i.i, label %B84.if.i.i.i
_ZN6poppet6engine8stepping5errorB3v32B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29.exit.thread6118.i.i:
  %.26696121.i.i = load i64, ptr %.2668.i.i, align 8, !noalias !92
  %.26706122.i.i = add nsw i64 %.26696121.i.i, 1
  store i64 %.26706122.i.i, ptr %.2668.i.i, align 8, !noalias !92
  br label %B1070.i.i
B164.i.i.i:
  %33 = getelementptr i8, ptr %.4479.i.i, i64 %.522.01421.i.i.i
  %.848.i.i.i = load i8, ptr %33, align 1, !noalias !102
  %.852.i.i.i = icmp ne i8 %.848.i.i.i, 0
  %.855.i.i.i = fcmp ole double %.760.i.i.i, 0.000000e+00
  %or.cond.i6056.i.i = and i1 %.855.i.i.i, %.852.i.i.i
  br i1 %or.cond.i6056.i.i, label %_ZN6poppet6engine8stepping5errorB3v32B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29.exit.thread.i.i, label %B240.i.i.i
B240.i.i.i:
  %34 = getelementptr double, ptr %.3561.i.i, i64 %.522.01421.i.i.i
  %.1135.i.i.i = load double, ptr %34, align 8, !noalias !102
  %.1193.i.i.i = getelementptr double, ptr %13, i64 %.522.01421.i.i.i
  %.1194.i.i.i = load double, ptr %.1193.i.i.i, align 8, !noalias !102
  %.1248.i.i.i = getelementptr double, ptr %.243.i.i, i64 %.522.01421.i.i.i
  %.1249.i.i.i = load double, ptr %.1248.i.i.i, align 8, !noalias !102
  %35 = getelementptr double, ptr %.4920.i.i, i64 %.522.01421.i.i.i
  %.1284.i.i.i = load double, ptr %35, align 8, !noalias !102
  %.1290.i.i.i = tail call double @llvm.fabs.f64(double %.1284.i.i.i)
  %.1292.i.i.i = tail call double @llvm.fabs.f64(double %.760.i.i.i)
  %.12.i.i6057.i.i = fcmp ogt double %.1292.i.i.i, %.1290.i.i.i
  %.13.i.i6058.i.i = select i1 %.12.i.i6057.i.i, double %.1292.i.i.i, double %.1290.i.i.i
  %.1139.i.i.i = tail call double @llvm.fabs.f64(double %.1135.i.i.i)
  %.1323.i.i.i = fmul double %.1249.i.i.i, %.13.i.i6058.i.i
  %.1324.i.i.i = fadd double %.1194.i.i.i, %.1323.i.i.i
  %.1328.i.i.i = fdiv double %.1139.i.i.i, %.1324.i.i.i
  %.1334.inv.i.i.i = fcmp ole double %.1328.i.i.i, %worst.2.01422.i.i.i
  %worst.3.1.i.i.i = select i1 %.1334.inv.i.i.i, double %worst.2.01422.i.i.i, double %.1328.i.i.i
  %exitcond.not.i6059.i.i = icmp eq i64 %.593.i.i.i, %.465.fca.6.load.i.i
  br i1 %exitcond.not.i6059.i.i, label %_ZN6poppet6engine8stepping5errorB3v32B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29.exit.i.i, label %B84.if.i.i.i
B84.if.i.i.i:
  %worst.2.01422.i.i.i = phi double [ %worst.3.1.i.i.i, %B240.i.i.i ], [ 0.000000e+00, %B658.i.i ]
  %.522.01421.i.i.i = phi i64 [ %.593.i.i.i, %B240.i.i.i ], [ 0, %B658.i.i ]
  %.593.i.i.i = add nuw nsw i64 %.522.01421.i.i.i, 1
  %36 = getelementptr double, ptr %.3733.i.i, i64 %.522.01421.i.i.i
  %.760.i.i.i = load double, ptr %36, align 8, !noalias !102
  %.775.le.i.i.i = fsub double %.760.i.i.i, %.760.i.i.i
  %.776.le.i.i.i = fcmp ord double %.775.le.i.i.i, 0.000000e+00
  br i1 %.776.le.i.i.i, label %B164.i.i.i, label %_ZN6poppet6engine8stepping5errorB3v32B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29.exit.thread.i.i
_ZN6poppet6engine8stepping5errorB3v32B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29.exit.thread.i.i:
  %.26696110.i.i = load i64, ptr %.2668.i.i, align 8, !noalias !92
  %.26706111.i.i = add nsw i64 %.26696110.i.i, 1
  store i64 %.26706111.i.i, ptr %.2668.i.i, align 8, !noalias !92
  br label %B1012.i.i
_ZN6poppet6engine8stepping5errorB3v32B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29.exit.i.i:
  %.2669.i.i = load i64, ptr %.2668.i.i, align 8, !noalias !92
  %.2670.i.i = add nsw i64 %.2669.i.i, 1
  store i64 %.2670.i.i, ptr %.2668.i.i, align 8, !noalias !92
  %.2702.i.i = fcmp ugt double %worst.3.1.i.i.i, 1.000000e+00
  br i1 %.2702.i.i, label %B1012.i.i, label %B1070.i.i
B1012.i.i:
  %storemerge1418.i6113.i.i = phi double [ 0x7FF0000000000000, %_ZN6poppet6engine8stepping5errorB3v32B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29.exit.thread.i.i ], [ %worst.3.1.i.i.i, %_ZN6poppet6engine8stepping5errorB3v32B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29.exit.i.i ]
  %.2715.le.i.i = fsub double %storemerge1418.i6113.i.i, %storemerge1418.i6113.i.i
  %.2716.le.i.i = fcmp ord double %.2715.le.i.i, 0.000000e+00
  %or.cond6169.i.i = and i1 %.4651.i.i, %.2716.le.i.i
  br i1 %or.cond6169.i.i, label %B1178.i.i, label %for.end.1.i.i
B1070.i.i:
  %storemerge1418.i6114.i.i = phi double [ %worst.3.1.i.i.i, %_ZN6poppet6engine8stepping5errorB3v32B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29.exit.i.i ], [ 0.000000e+00, %_ZN6poppet6engine8stepping5errorB3v32B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29.exit.thread6118.i.i ]
  %.2762.i.i = load i64, ptr %.5082.i.i, align 8, !noalias !92
  %.2770.i.i = icmp sge i64 %.2762.i.i, %.465.fca.20.load.i.i
  %brmerge.i.i = select i1 %.2770.i.i, i1 true, i1 %.4651.i.i
  br i1 %brmerge.i.i, label %B1178.i.i, label %B1128.i.i
B1128.i.i:
  %.2777.i.i = fcmp oeq double %"$phi694.0.2.1.i.i", %arg.segment.1.sink.i.i.i
  %.2782.i.i = fneg double %"$phi606.0.2.1.in.sroa.speculated.i.i"
  %"$phi1148.0.2.2.i.i" = select i1 %.2777.i.i, double %.2782.i.i, double %"$phi606.0.2.1.in.sroa.speculated.i.i"
  %.2835.i.i = icmp slt i64 %.2762.i.i, 0
  %.2836.i.i = select i1 %.2835.i.i, i64 %.465.fca.20.load.i.i, i64 0
  %37 = getelementptr double, ptr %.4578.i.i, i64 %.2762.i.i
  %.2850.i.i = getelementptr double, ptr %37, i64 %.2836.i.i
  store double %"$phi1148.0.2.2.i.i", ptr %.2850.i.i, align 8, !noalias !92
  br label %B1178.i.i
B1178.i.i:
  %storemerge1418.i61146156.i.i = phi double [ %storemerge1418.i6114.i.i, %B1128.i.i ], [ %storemerge1418.i6114.i.i, %B1070.i.i ], [ %storemerge1418.i6113.i.i, %B1012.i.i ]
  call void @llvm.lifetime.start.p0(ptr nonnull %.1113.i.i.i), !noalias !92
  call void @llvm.lifetime.start.p0(ptr nonnull %.1313.i.i.i), !noalias !92
  call void @llvm.lifetime.start.p0(ptr nonnull %.1437.i.i.i), !noalias !92
  br i1 %.1415.i.i, label %B78.if.i.i6066.i.i, label %B166.i.i.i
B78.if.i.i6066.i.i:
  %first.2.0129.i.i6067.i.i = phi double [ %.13.i.i.i6072.i.i, %B78.if.i.i6066.i.i ], [ 0x7FF0000000000000, %B1178.i.i ]
  %.106.0128.i.i6068.i.i = phi i64 [ %.177.i.i6069.i.i, %B78.if.i.i6066.i.i ], [ 0, %B1178.i.i ]
  %.177.i.i6069.i.i = add nuw nsw i64 %.106.0128.i.i6068.i.i, 1
  %38 = getelementptr double, ptr %.4370.i.i, i64 %.106.0128.i.i6068.i.i
  %.235.i.i6070.i.i = load double, ptr %38, align 8, !noalias !105
  %.12.i.i.i6071.i.i = fcmp olt double %.235.i.i6070.i.i, %first.2.0129.i.i6067.i.i
  %.13.i.i.i6072.i.i = select i1 %.12.i.i.i6071.i.i, double %.235.i.i6070.i.i, double %first.2.0129.i.i6067.i.i
  %exitcond.not.i.i6073.i.i = icmp eq i64 %.250521222161.i.i, %.177.i.i6069.i.i
  br i1 %exitcond.not.i.i6073.i.i, label %_ZN6poppet6engine8stepping12next_instantB3v16B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE199Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit.i6074.i.i, label %B78.if.i.i6066.i.i
_ZN6poppet6engine8stepping12next_instantB3v16B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE199Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit.i6074.i.i:
  %.5.i.i6075.i.i = fmul double %"$phi694.0.2.1.i.i", 0x3D06849B86A12B9B
  %.6.i.i6076.i.i = fadd double %.5.i.i6075.i.i, 1.000000e-15
  %.668.i.i.i = fsub double %"$phi694.0.2.1.i.i", %.6.i.i6076.i.i
  %.669.i.i.i = fcmp olt double %.13.i.i.i6072.i.i, %.668.i.i.i
  br label %B166.i.i.i
B166.i.i.i:
  %"$phi166.0.2.0.i.i.i" = phi i1 [ %.669.i.i.i, %_ZN6poppet6engine8stepping12next_instantB3v16B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE199Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit.i6074.i.i ], [ false, %B1178.i.i ]
  %brmerge.i6060.i.i = select i1 %.2438.i, i1 true, i1 %"$phi166.0.2.0.i.i.i"
  br i1 %brmerge.i6060.i.i, label %B404.i.i.i, label %B234.i.i.i
B234.i.i.i:
  %.812.i.i.i = load i64, ptr %.980.i.i, align 8, !noalias !110
  %.825.i.i.i = icmp slt i64 %.812.i.i.i, 0
  %.826.i.i.i = select i1 %.825.i.i.i, i64 %.465.fca.18.load.i.i, i64 0
  %39 = getelementptr double, ptr %.4681.i.i, i64 %.812.i.i.i
  %.840.i.i.i = getelementptr double, ptr %39, i64 %.826.i.i.i
  %.841.i.i.i = load double, ptr %.840.i.i.i, align 8, !noalias !110
  %.846.i.i.i = fcmp olt double %.841.i.i.i, %"$phi694.0.2.1.i.i"
  br i1 %.846.i.i.i, label %B404.thread3043.i.i.i, label %B534.i.i.i
B404.thread3043.i.i.i:
  tail call void %.10933044.i.i.i(ptr %.3390.i.i, ptr %.3905.i.i), !noalias !110
  br label %B534.i.i.i
B404.i.i.i:
  tail call void %.10933044.i.i.i(ptr %.3390.i.i, ptr %.3905.i.i), !noalias !110
  br i1 %.2438.i, label %B408.i.i.i, label %B534.i.i.i
B408.i.i.i:
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %.1113.i.i.i, i8 0, i64 16, i1 false), !noalias !110
  call fastcc void @v45(ptr %.1113.i.i.i, i64 %.465.fca.3.load.i.i, ptr %.155.i.i, ptr %.2863.i.i, ptr readonly %.4798.i.i, i64 2, ptr readonly %.4848.i.i, i64 %.465.fca.19.load.i.i, i64 3, i64 %.81819612000.i.i, ptr %.83419621999.i.i, ptr nonnull %.1348.i.i, ptr %.3905.i.i, i64 %.3889.i.i, i64 %.4061.i.i, ptr %.4077.i.i, i64 %.465.fca.5.load.i.i, ptr %.4920.i.i, double %.2090.i, ptr readonly %.2227.i, i64 6, double %t.2.0.i.i, double %"$phi606.0.2.1.in.sroa.speculated.i.i", ptr readonly %.3733.i.i)
  %.1220.fca.0.load.i.i.i = load i64, ptr %.1113.i.i.i, align 8, !noalias !110
  %.1220.fca.1.load.i.i.i = load double, ptr %.fca.1.gep.i.i.i, align 8, !noalias !110
  %.1247.i.i.i = fmul double %"$phi606.0.2.1.in.sroa.speculated.i.i", %.1220.fca.1.load.i.i.i
  %.1250.i.i.i = fadd double %t.2.0.i.i, %.1247.i.i.i
  %.12373045.i.i.i = icmp slt i64 %.1220.fca.0.load.i.i.i, 0
  %"$phi510.1.2.0.i.i.i" = select i1 %.12373045.i.i.i, double %"$phi694.0.2.1.i.i", double %.1250.i.i.i
  store i64 %.1220.fca.0.load.i.i.i, ptr %.1733.i, align 8, !noalias !110
  br label %B582.i.i.i
B534.i.i.i:
  br i1 %"$phi166.0.2.0.i.i.i", label %B538.i.i.i, label %B582.i.i.i
B538.i.i.i:
  store double 0.000000e+00, ptr %.1313.i.i.i, align 8, !noalias !110
  call fastcc void @v46(ptr %.1313.i.i.i, i64 %.465.fca.3.load.i.i, i64 %.465.fca.4.load.i.i, ptr %.155.i.i, i64 %.4354.i.i, ptr %.4370.i.i, ptr readonly %.4403.i.i, i64 %.250521222161.i.i, ptr %.252121232160.i.i, ptr %.269221422175.i.i, i64 %.465.fca.6.load.i.i, i64 %.465.fca.18.load.i.i, ptr readonly %.4681.i.i, i64 %.465.fca.18.load.i.i, ptr %.4723.i.i, i64 %.465.fca.18.load.i.i, i64 %.2847.i.i, ptr %.2863.i.i, i64 %.81819612000.i.i, ptr %.83419621999.i.i, ptr nonnull %.1348.i.i, ptr %.3219.i.i, i64 %.3203.i.i, ptr %.3905.i.i, i64 %.3889.i.i, i64 %.4061.i.i, ptr %.4077.i.i, i64 %.465.fca.5.load.i.i, ptr %.4920.i.i, ptr nonnull %.5082.i.i, double %.2090.i, ptr readonly %.2227.i, i64 6, double %t.2.0.i.i, double %"$phi606.0.2.1.in.sroa.speculated.i.i", double %"$phi694.0.2.1.i.i", ptr readonly %.3733.i.i)
  %.1420.i.i.i = load double, ptr %.1313.i.i.i, align 8, !noalias !110
  br label %B582.i.i.i
B582.i.i.i:
  %reached.3.0.i.i.i = phi double [ %"$phi510.1.2.0.i.i.i", %B408.i.i.i ], [ %.1420.i.i.i, %B538.i.i.i ], [ %"$phi694.0.2.1.i.i", %B534.i.i.i ]
  call fastcc void @v47(ptr %.1437.i.i.i, i64 %.465.fca.3.load.i.i, ptr %.155.i.i, i64 %.465.fca.6.load.i.i, i64 %.465.fca.18.load.i.i, ptr readonly %.4681.i.i, i64 %.465.fca.18.load.i.i, ptr %.4723.i.i, i64 %.465.fca.18.load.i.i, i64 %.2847.i.i, ptr %.2863.i.i, i64 %.81819612000.i.i, ptr %.83419621999.i.i, ptr nonnull %.1348.i.i, ptr %.3219.i.i, i64 %.3203.i.i, ptr %.3905.i.i, i64 %.3889.i.i, i64 %.465.fca.5.load.i.i, ptr %.4920.i.i, ptr nonnull %.5082.i.i, double %.2090.i, ptr readonly %.2227.i, i64 6, double %t.2.0.i.i, double %"$phi606.0.2.1.in.sroa.speculated.i.i", ptr readonly %.3733.i.i, double %reached.3.0.i.i.i)
  %.1590.i.i.i = load i64, ptr %.1733.i, align 8, !noalias !110
  %.1596.i.i.i = icmp sgt i64 %.1590.i.i.i, -1
  %.1839.i.i.i = fcmp olt double %reached.3.0.i.i.i, %"$phi694.0.2.1.i.i"
  %or.cond.i6061.i.i = select i1 %.1596.i.i.i, i1 true, i1 %.1839.i.i.i
  %spec.select.i6062.i.i = select i1 %or.cond.i6061.i.i, ptr %.4077.i.i, ptr %.3733.i.i
  br label %B76.if.i.i.i.i
B76.if.i.i.i.i:
  %.519.0852.i.i.i.i = phi i64 [ %.590.i.i.i.i, %B76.if.i.i.i.i ], [ 0, %B582.i.i.i ]
  %.590.i.i.i.i = add nuw nsw i64 %.519.0852.i.i.i.i, 1
  %40 = getelementptr double, ptr %spec.select.i6062.i.i, i64 %.519.0852.i.i.i.i
  %.644.i.i.i.i = load double, ptr %40, align 8, !noalias !111
  %gep.i.i.i.i = getelementptr double, ptr %invariant.gep.i.i.i.i, i64 %.519.0852.i.i.i.i
  %.677.i.i.i.i = load double, ptr %gep.i.i.i.i, align 8, !noalias !111
  %41 = getelementptr double, ptr %.4920.i.i, i64 %.519.0852.i.i.i.i
  %.707.i.i.i.i = load double, ptr %41, align 8, !noalias !111
  %.708.i.i.i.i = fsub double %.644.i.i.i.i, %.707.i.i.i.i
  %.709.i.i.i.i = tail call double @llvm.fabs.f64(double %.708.i.i.i.i)
  %.710.i.i.i.i = fadd double %.677.i.i.i.i, %.709.i.i.i.i
  store double %.710.i.i.i.i, ptr %gep.i.i.i.i, align 8, !noalias !111
  store double %.644.i.i.i.i, ptr %41, align 8, !noalias !111
  %42 = getelementptr double, ptr %.4961.i.i, i64 %.519.0852.i.i.i.i
  %.800.i.i6064.i.i = load double, ptr %42, align 8, !noalias !111
  %.12.i.i3040.i.i.i = fcmp olt double %.644.i.i.i.i, %.800.i.i6064.i.i
  %.13.i.i3041.i.i.i = select i1 %.12.i.i3040.i.i.i, double %.644.i.i.i.i, double %.800.i.i6064.i.i
  %gep854.i.i.i.i = getelementptr double, ptr %invariant.gep853.i.i.i.i, i64 %.519.0852.i.i.i.i
  %.860.i.i.i.i = load double, ptr %gep854.i.i.i.i, align 8, !noalias !111
  %.12.i848.i.i.i.i = fcmp ogt double %.644.i.i.i.i, %.860.i.i.i.i
  %.13.i849.i.i.i.i = select i1 %.12.i848.i.i.i.i, double %.644.i.i.i.i, double %.860.i.i.i.i
  store double %.13.i.i3041.i.i.i, ptr %42, align 8, !noalias !111
  store double %.13.i849.i.i.i.i, ptr %gep854.i.i.i.i, align 8, !noalias !111
  %exitcond.not.i3042.i.i.i = icmp eq i64 %.590.i.i.i.i, %.465.fca.5.load.i.i
  br i1 %exitcond.not.i3042.i.i.i, label %_ZN6poppet6engine10integrator7_acceptB3v33B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_4846, label %B76.if.i.i.i.i
_ZN6poppet6engine10integrator7_acceptB3v33B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_4846:
  %.1124.i.i.i.i = load i64, ptr %.5082.i.i, align 8, !noalias !111
  %.1125.i.i.i.i = add nsw i64 %.1124.i.i.i.i, 1
  store i64 %.1125.i.i.i.i, ptr %.5082.i.i, align 8, !noalias !111
  call void @llvm.lifetime.end.p0(ptr nonnull %.1113.i.i.i), !noalias !92
  call void @llvm.lifetime.end.p0(ptr nonnull %.1313.i.i.i), !noalias !92
  call void @llvm.lifetime.end.p0(ptr nonnull %.1437.i.i.i), !noalias !92
  store double %reached.3.0.i.i.i, ptr %.5003.i.i, align 8, !noalias !92
  %.3069.i.i = load i64, ptr %.1733.i, align 8, !noalias !92
  %.3070.i.i = icmp sgt i64 %.3069.i.i, -1
  br i1 %.3070.i.i, label %B1468.i, label %B1328.i.i
B1328.i.i:
  %.12.i.i.i = fcmp olt double %storemerge1418.i61146156.i.i, 1.000000e-10
  %.13.i6077.i.i = select i1 %.12.i.i.i, double 1.000000e-10, double %storemerge1418.i61146156.i.i
  %.17.i.i.i = tail call double @llvm.pow.f64(double %.13.i6077.i.i, double -2.500000e-01)
  %.18.i.i.i = fmul double %.17.i.i.i, 9.000000e-01
  %.27.i.i.i = fcmp ogt double %step_before.3.0.i.i, 0.000000e+00
  br i1 %.27.i.i.i, label %B42.i.i.i, label %_ZN6poppet6engine8stepping6growthB3v40B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdddd.exit.i.i
B42.i.i.i:
  %.34.i.i.i = fdiv double %"$phi606.0.2.1.in.sroa.speculated.i.i", %step_before.3.0.i.i
  %.39.i.i.i = fmul double %.34.i.i.i, 9.000000e-01
  %.42.i.i.i = fmul double %.13.i6077.i.i, %.13.i6077.i.i
  %.49.i.i.i = fdiv double %error_before.2.0.i.i, %.42.i.i.i
  %.52.i.i.i = tail call double @llvm.pow.f64(double %.49.i.i.i, double 2.500000e-01)
  %.53.i.i.i = fmul double %.39.i.i.i, %.52.i.i.i
  %.12.i.i6078.i.i = fcmp olt double %.53.i.i.i, %.18.i.i.i
  %.13.i.i6079.i.i = select i1 %.12.i.i6078.i.i, double %.53.i.i.i, double %.18.i.i.i
  br label %_ZN6poppet6engine8stepping6growthB3v40B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdddd.exit.i.i
_ZN6poppet6engine8stepping6growthB3v40B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdddd.exit.i.i:
  %factor.2.0.i.i.i = phi double [ %.13.i.i6079.i.i, %B42.i.i.i ], [ %.18.i.i.i, %B1328.i.i ]
  %.12.i3.i.i.i = fcmp ogt double %factor.2.0.i.i.i, 1.500000e-01
  %.13.i4.i.i.i = select i1 %.12.i3.i.i.i, double %factor.2.0.i.i.i, double 1.500000e-01
  %.12.i5.i.i.i = fcmp olt double %.13.i4.i.i.i, 6.000000e+00
  %.13.i6.i.i.i = select i1 %.12.i5.i.i.i, double %.13.i4.i.i.i, double 6.000000e+00
  %.12.i6080.i.i = fcmp ogt double %.13.i6077.i.i, 1.000000e-02
  %.13.i6081.i.i = select i1 %.12.i6080.i.i, double %.13.i6077.i.i, double 1.000000e-02
  br i1 %has_changed.3.0.i.i, label %B1462.i.i, label %B1532.i.i
B1462.i.i:
  %.12.i6082.i.i = fcmp ogt double %.13.i6.i.i.i, 5.000000e-01
  %.13.i6083.i.i = select i1 %.12.i6082.i.i, double %.13.i6.i.i.i, double 5.000000e-01
  %.12.i6084.i.i = fcmp olt double %.13.i6083.i.i, 2.000000e+00
  %.13.i6085.i.i = select i1 %.12.i6084.i.i, double %.13.i6083.i.i, double 2.000000e+00
  %.3524.i.i = fmul double %"$phi606.0.2.1.in.sroa.speculated.i.i", %.13.i6085.i.i
  br label %B1532.i.i
B1532.i.i:
  %first.2.1.i.i = phi double [ %.3524.i.i, %B1462.i.i ], [ %first.3.0.i.i, %_ZN6poppet6engine8stepping6growthB3v40B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdddd.exit.i.i ]
  %.3532.i.i = fcmp olt double %"$phi606.0.2.1.in.sroa.speculated.i.i", %wanted.2.0.sink.i.i.i
  br i1 %.3532.i.i, label %B1544.i.i, label %B1582.i.i
B1544.i.i:
  %.3538.i.i = fmul double %"$phi606.0.2.1.in.sroa.speculated.i.i", %.13.i6.i.i.i
  %.12.i6086.i.i = fcmp ogt double %.3538.i.i, %wanted.2.0.sink.i.i.i
  %.13.i6087.i.i = select i1 %.12.i6086.i.i, double %.3538.i.i, double %wanted.2.0.sink.i.i.i
  br label %B1626.i.i
B1582.i.i:
  %.12.i6088.i.i = fcmp olt double %.13.i6.i.i.i, 1.000000e+00
  %.13.i6089.i.i = select i1 %.12.i6088.i.i, double %.13.i6.i.i.i, double 1.000000e+00
  %"$phi1622.1.2.1.i.i" = select i1 %rejected.3.0.i.i, double %.13.i6089.i.i, double %.13.i6.i.i.i
  %.3633.i.i = fmul double %"$phi606.0.2.1.in.sroa.speculated.i.i", %"$phi1622.1.2.1.i.i"
  br label %B1626.i.i
B1626.i.i:
  %"$phi1626.0.2.1.i.i" = phi double [ %.13.i6087.i.i, %B1544.i.i ], [ %.3633.i.i, %B1582.i.i ]
  %.3717.i4736.i = fcmp olt double %reached.3.0.i.i.i, %.816.i.i.i
  %or.cond6139.i.i = select i1 %.1415.i.i, i1 %.3717.i4736.i, i1 false
  br i1 %or.cond6139.i.i, label %B1690.i.i, label %B2026.i.i
B1690.i.i:
  store i8 0, ptr %.3740.i.i, align 1, !noalias !92
  call fastcc void @v44(ptr %.3740.i.i, i64 %.465.fca.4.load.i.i, ptr %.155.i.i, i64 %.4354.i.i, ptr %.4370.i.i, ptr readonly %.4403.i.i, i64 %.250521222161.i.i, ptr %.252121232160.i.i, ptr %.269221422175.i.i, i64 %.81819612000.i.i, ptr %.83419621999.i.i, ptr nonnull %.1348.i.i, double %.2090.i, ptr readonly %.2227.i, i64 6, double %reached.3.0.i.i.i, ptr nonnull %.4920.i.i)
  %.3847.i.i = load i8, ptr %.3740.i.i, align 1, !noalias !92
  %.3850.not.i.i = icmp ne i8 %.3847.i.i, 0
  %brmerge5933.i.i = select i1 %.3850.not.i.i, i1 true, i1 %.1839.i.i.i
  br i1 %brmerge5933.i.i, label %B1754.i.i, label %B2026.i.i
B1754.i.i:
  %.12.i6090.i.i = fcmp olt double %first.2.1.i.i, %"$phi1626.0.2.1.i.i"
  %.13.i6091.i.i = select i1 %.12.i6090.i.i, double %first.2.1.i.i, double %"$phi1626.0.2.1.i.i"
  br label %B2026.i.i
B1848.i.i:
  %.4072.i.i = tail call double @llvm.pow.f64(double %storemerge1418.i6113.i.i, double -2.500000e-01)
  %.4075.i.i = fmul double %.4072.i.i, 9.000000e-01
  %.12.i6092.i.i = fcmp olt double %.4075.i.i, 8.000000e-01
  %.13.i6093.i.i = select i1 %.12.i6092.i.i, double %.4075.i.i, double 8.000000e-01
  %.12.i6094.i.i = fcmp ogt double %.13.i6093.i.i, 1.500000e-01
  %.13.i6095.i.i = select i1 %.12.i6094.i.i, double %.13.i6093.i.i, double 1.500000e-01
  br label %B1952.i.i
B1952.i.i:
  %"$phi1952.1.2.2.i.i" = phi double [ %.13.i6095.i.i, %B1848.i.i ], [ 1.500000e-01, %for.end.1.i.i ]
  %.4143.i.i = fmul double %"$phi606.0.2.1.in.sroa.speculated.i.i", %"$phi1952.1.2.2.i.i"
  %.4156.i.i = fadd double %t.2.0.i.i, %.4143.i.i
  %.4158.i.i = fcmp ole double %.4156.i.i, %t.2.0.i.i
  %.4161.i.i = fcmp olt double %.4143.i.i, 1.000000e-300
  %or.cond.i4735.i = or i1 %.4161.i.i, %.4158.i.i
  %brmerge5935.i.i = select i1 %or.cond.i4735.i, i1 true, i1 %.4651.i.i
  br i1 %brmerge5935.i.i, label %B1684.loopexit.i, label %B2026.i.i
B2026.i.i:
  %h.7.1.i.i = phi double [ %.4143.i.i, %B1952.i.i ], [ %"$phi1626.0.2.1.i.i", %B1690.i.i ], [ %.13.i6091.i.i, %B1754.i.i ], [ %"$phi1626.0.2.1.i.i", %B1626.i.i ]
  %t.3.1.i.i = phi double [ %t.2.0.i.i, %B1952.i.i ], [ %reached.3.0.i.i.i, %B1690.i.i ], [ %reached.3.0.i.i.i, %B1754.i.i ], [ %reached.3.0.i.i.i, %B1626.i.i ]
  %error_before.3.1.i.i = phi double [ %error_before.2.0.i.i, %B1952.i.i ], [ %.13.i6081.i.i, %B1690.i.i ], [ %.13.i6081.i.i, %B1754.i.i ], [ %.13.i6081.i.i, %B1626.i.i ]
  %step_before.4.1.i.i = phi double [ %step_before.3.0.i.i, %B1952.i.i ], [ %"$phi606.0.2.1.in.sroa.speculated.i.i", %B1690.i.i ], [ 0.000000e+00, %B1754.i.i ], [ %"$phi606.0.2.1.in.sroa.speculated.i.i", %B1626.i.i ]
  %rejected.4.1.i.i = phi i1 [ true, %B1952.i.i ], [ false, %B1690.i.i ], [ false, %B1754.i.i ], [ false, %B1626.i.i ]
  %fresh.4.1.i.i = phi i1 [ false, %B1952.i.i ], [ true, %B1690.i.i ], [ true, %B1754.i.i ], [ true, %B1626.i.i ]
  %calm.3.1.i.i = phi double [ %calm.2.0.i.i, %B1952.i.i ], [ %calm.2.0.i.i, %B1690.i.i ], [ %reached.3.0.i.i.i, %B1754.i.i ], [ %calm.2.0.i.i, %B1626.i.i ]
  %first.4.1.i.i = phi double [ %first.3.0.i.i, %B1952.i.i ], [ %first.2.1.i.i, %B1690.i.i ], [ %first.2.1.i.i, %B1754.i.i ], [ %first.2.1.i.i, %B1626.i.i ]
  %has_changed.4.1.i.i = phi i1 [ %has_changed.3.0.i.i, %B1952.i.i ], [ false, %B1690.i.i ], [ true, %B1754.i.i ], [ false, %B1626.i.i ]
  %has_acted.3.1.i.i = phi i1 [ %has_acted.4.0.i.i, %B1952.i.i ], [ true, %B1690.i.i ], [ true, %B1754.i.i ], [ %has_acted.4.0.i.i, %B1626.i.i ]
  %.570.i.i.i = load i64, ptr %.2668.i.i, align 8, !noalias !114
  %.590.i.i.i = srem i64 %.570.i.i.i, 400
  %.592.i.i.i = icmp slt i64 %.590.i.i.i, 0
  %.601.i.i.i = add nsw i64 %.590.i.i.i, 400
  %.581.0.i.i.i = select i1 %.592.i.i.i, i64 %.601.i.i.i, i64 %.590.i.i.i
  %.611.i.i.i = icmp ne i64 %.581.0.i.i.i, 0
  br i1 %.611.i.i.i, label %B284.i.i.i, label %B104.i.i.i
B104.i.i.i:
  %.522.i.i.i = load double, ptr %.2170.i, align 8, !noalias !114
  %.615.i.i.i = fsub double %t.3.1.i.i, %window.2.0.i.i
  %.620.i.i.i = fsub double %.522.i.i.i, %window.2.0.i.i
  %.625.i.i.i = fmul double %.620.i.i.i, 1.000000e-04
  %.626.i.i.i = fcmp uge double %.615.i.i.i, %.625.i.i.i
  %.675.i.i.i = load i64, ptr %.5082.i.i, align 8, !noalias !114
  %.705.i.i.i = load i64, ptr %.704.i.i.i, align 8, !noalias !114
  %.706.i.i.i = sub nsw i64 %.675.i.i.i, %.705.i.i.i
  %.748.i.i.i = icmp sgt i64 %.706.i.i.i, 279
  %43 = select i1 %.748.i.i.i, i1 true, i1 %.626.i.i.i
  %brmerge.i6097.i.i = select i1 %43, i1 true, i1 %has_acted.3.1.i.i
  br i1 %brmerge.i6097.i.i, label %B242.i.i.i, label %B1684.loopexit.i
B242.i.i.i:
  store i64 %.675.i.i.i, ptr %.704.i.i.i, align 8, !noalias !114
  br label %B284.i.i.i
B284.i.i.i:
  %.1010.i.i.i = sitofp i64 %.570.i.i.i to double
  %.1011.i.i.i = fcmp ugt double %.4576.i.i, %.1010.i.i.i
  br i1 %.1011.i.i.i, label %B352.i.i.i, label %B1684.loopexit.i
B352.i.i.i:
  %.1284.i6096.i.i = load double, ptr %.1283.i.i.i, align 8, !noalias !114
  %.1288.i.i.i = fcmp une double %.1284.i6096.i.i, 0.000000e+00
  br i1 %.1288.i.i.i, label %B1684.loopexit.i, label %B2104.i.i
B2104.i.i:
  %window.3.1.i.i = select i1 %.611.i.i.i, double %window.2.0.i.i, double %t.3.1.i.i
  %has_acted.5.1.i.i = select i1 %.611.i.i.i, i1 %has_acted.3.1.i.i, i1 false
  %.5038.i.i = fcmp olt double %t.3.1.i.i, %"$phi1038.4.2.1.i"
  br i1 %.5038.i.i, label %B384.i.i, label %B948.sink.split.i
B298.endif.i.i:
  %.1753.i.i = fcmp olt double %.2090.i, %"$phi1038.4.2.1.i"
  br i1 %.1753.i.i, label %B384.preheader.i.i, label %B948.sink.split.i
B384.preheader.i.i:
  %.5.i.i.i.i = fmul double %"$phi1038.4.2.1.i", 0x3D06849B86A12B9B
  %.6.i.i.i.i = fadd double %.5.i.i.i.i, 1.000000e-15
  %.816.i.i.i = fsub double %"$phi1038.4.2.1.i", %.6.i.i.i.i
  br label %B384.i.i
for.end.1.i.i:
  br i1 %.2716.le.i.i, label %B1848.i.i, label %B1952.i.i
B1374.i:
  call void @llvm.lifetime.start.p0(ptr nonnull %.648.i.i), !noalias !44
  call void @llvm.lifetime.start.p0(ptr nonnull %.1307.i.i), !noalias !44
  call void @llvm.lifetime.start.p0(ptr nonnull %.1528.i.i), !noalias !44
  %.580.i.i = fcmp olt double %.2090.i, %"$phi1038.4.2.1.i"
  br i1 %.580.i.i, label %B90.preheader.i.i, label %B1374._ZN6poppet6engine10integrator15_without_statesB3v42B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_2
B1374._ZN6poppet6engine10integrator15_without_statesB3v42B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_2:
  %.3072.pre.i = load i64, ptr %.1733.i, align 8, !noalias !44
  br label %_ZN6poppet6engine10integrator15_without_statesB3v42B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c
B90.preheader.i.i:
  %.5.i.i.i = fmul double %"$phi1038.4.2.1.i", 0x3D06849B86A12B9B
  %.6.i.i.i = fadd double %.5.i.i.i, 1.000000e-15
  %.874.i.i = fsub double %"$phi1038.4.2.1.i", %.6.i.i.i
  br label %B90.i.i
B90.i.i:
  %t.2.0.i4755.i = phi double [ %end.5.1.i.i, %B826.i.i ], [ %.2090.i, %B90.preheader.i.i ]
  br i1 %.636.i.not.i, label %B304.i.i, label %B136.i.i
B136.i.i:
  call fastcc void @v44(ptr %.648.i.i, i64 %.465.fca.4.load.i.i, ptr %.155.i.i, i64 %.4354.i.i, ptr %.4370.i.i, ptr readonly %.4403.i.i, i64 %.250521222161.i.i, ptr %.252121232160.i.i, ptr %.269221422175.i.i, i64 %.81819612000.i.i, ptr %.83419621999.i.i, ptr %.1348.i.i, double %.2090.i, ptr readonly %.2227.i, i64 6, double %t.2.0.i4755.i, ptr %.4920.i.i)
  br label %B78.if.i.i.i
B78.if.i.i.i:
  %first.2.0129.i.i.i = phi double [ %.13.i.i.i4760.i, %B78.if.i.i.i ], [ 0x7FF0000000000000, %B136.i.i ]
  %.106.0128.i.i.i = phi i64 [ %.177.i.i.i, %B78.if.i.i.i ], [ 0, %B136.i.i ]
  %.177.i.i.i = add nuw nsw i64 %.106.0128.i.i.i, 1
  %44 = getelementptr double, ptr %.4370.i.i, i64 %.106.0128.i.i.i
  %.235.i.i.i = load double, ptr %44, align 8, !noalias !117
  %.12.i.i.i4759.i = fcmp olt double %.235.i.i.i, %first.2.0129.i.i.i
  %.13.i.i.i4760.i = select i1 %.12.i.i.i4759.i, double %.235.i.i.i, double %first.2.0129.i.i.i
  %exitcond.not.i.i4761.i = icmp eq i64 %.250521222161.i.i, %.177.i.i.i
  br i1 %exitcond.not.i.i4761.i, label %_ZN6poppet6engine8stepping12next_instantB3v16B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE199Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit.i.i, label %B78.if.i.i.i
_ZN6poppet6engine8stepping12next_instantB3v16B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE199Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit.i.i:
  %.876.i.i = fcmp olt double %.13.i.i.i4760.i, %.874.i.i
  %"$phi302.0.2.2.i.i" = select i1 %.876.i.i, double %.13.i.i.i4760.i, double %"$phi1038.4.2.1.i"
  br label %B304.i.i
B304.i.i:
  %end.4.1.i.i = phi double [ %"$phi302.0.2.2.i.i", %_ZN6poppet6engine8stepping12next_instantB3v16B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE199Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit.i.i ], [ %"$phi1038.4.2.1.i", %B90.i.i ]
  br i1 %.2438.i, label %B358.i.i, label %B826.i.i
B358.i.i:
  %.981.i.i = load i64, ptr %.980.i.i, align 8, !noalias !122
  %.998.i.i = icmp slt i64 %.981.i.i, %.996.i.i
  br i1 %.998.i.i, label %B412.i.i, label %B582.i.i
B412.i.i:
  %.1021.i.i = icmp slt i64 %.981.i.i, 0
  %.1022.i.i = select i1 %.1021.i.i, i64 %.465.fca.18.load.i.i, i64 0
  %45 = getelementptr double, ptr %.4681.i.i, i64 %.981.i.i
  %.1036.i.i = getelementptr double, ptr %45, i64 %.1022.i.i
  %.1037.i.i = load double, ptr %.1036.i.i, align 8, !noalias !122
  %.5.i2342.i.i = fmul double %t.2.0.i4755.i, 0x3D06849B86A12B9B
  %.6.i2343.i.i = fadd double %.5.i2342.i.i, 1.000000e-15
  %.1066.i.i = fadd double %t.2.0.i4755.i, %.6.i2343.i.i
  %.1067.i.i = fcmp ugt double %.1037.i.i, %.1066.i.i
  br i1 %.1067.i.i, label %B582.i.i, label %B478.i.i
B478.i.i:
  %row.2.3.i.i = phi i64 [ %.1073.i.i, %B516.i.i ], [ %.981.i.i, %B412.i.i ]
  %exitcond.not.i4758.i = icmp eq i64 %row.2.3.i.i, %11
  br i1 %exitcond.not.i4758.i, label %B582.i.i, label %B516.i.i
B516.i.i:
  %.1073.i.i = add nsw i64 %row.2.3.i.i, 1
  %.1113.i.i = icmp slt i64 %row.2.3.i.i, -1
  %.1114.i.i = select i1 %.1113.i.i, i64 %.465.fca.18.load.i.i, i64 0
  %46 = getelementptr double, ptr %.4681.i.i, i64 %.1073.i.i
  %.1128.i.i = getelementptr double, ptr %46, i64 %.1114.i.i
  %.1129.i.i = load double, ptr %.1128.i.i, align 8, !noalias !122
  %.1159.i.i = fcmp ugt double %.1129.i.i, %.1066.i.i
  br i1 %.1159.i.i, label %B582.i.i, label %B478.i.i
B582.i.i:
  %row.3.2.i.i = phi i64 [ %.981.i.i, %B412.i.i ], [ %.981.i.i, %B358.i.i ], [ %.1073.i.i, %B516.i.i ], [ %.996.i.i, %B478.i.i ]
  %.1186.i4757.i = icmp slt i64 %row.3.2.i.i, 0
  %.1187.i.i = select i1 %.1186.i4757.i, i64 %.465.fca.18.load.i.i, i64 0
  %47 = getelementptr double, ptr %.4681.i.i, i64 %row.3.2.i.i
  %.1201.i.i = getelementptr double, ptr %47, i64 %.1187.i.i
  %.1202.i.i = load double, ptr %.1201.i.i, align 8, !noalias !122
  %.5.i2346.i.i = fmul double %end.4.1.i.i, 0x3D06849B86A12B9B
  %.6.i2347.i.i = fadd double %.5.i2346.i.i, 1.000000e-15
  %.1229.i.i = fsub double %end.4.1.i.i, %.6.i2347.i.i
  %.1230.i.i = fcmp olt double %.1202.i.i, %.1229.i.i
  %"$phi666.0.2.2.i.i" = select i1 %.1230.i.i, double %.1202.i.i, double %end.4.1.i.i
  %.1287.i.i = fsub double %"$phi666.0.2.2.i.i", %t.2.0.i4755.i
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %.1307.i.i, i8 0, i64 16, i1 false), !noalias !122
  call fastcc void @v45(ptr %.1307.i.i, i64 %.465.fca.3.load.i.i, ptr %.155.i.i, ptr %.2863.i.i, ptr readonly %.4798.i.i, i64 2, ptr readonly %.4848.i.i, i64 %.465.fca.19.load.i.i, i64 3, i64 %.81819612000.i.i, ptr %.83419621999.i.i, ptr %.1348.i.i, ptr readonly %.3905.i.i, i64 %.3889.i.i, i64 %.4061.i.i, ptr %.4077.i.i, i64 %.465.fca.5.load.i.i, ptr %.4920.i.i, double %.2090.i, ptr readonly %.2227.i, i64 6, double %t.2.0.i4755.i, double %.1287.i.i, ptr %.4920.i.i)
  %.1414.fca.0.load.i.i = load i64, ptr %.1307.i.i, align 8, !noalias !122
  %.1414.fca.1.load.i.i = load double, ptr %.fca.1.gep.i4753.i, align 8, !noalias !122
  %.1445.i.i = fmul double %.1287.i.i, %.1414.fca.1.load.i.i
  %.1449.i.i = fadd double %t.2.0.i4755.i, %.1445.i.i
  %.14342348.i.i = icmp slt i64 %.1414.fca.0.load.i.i, 0
  %"$phi804.1.2.2.i.i" = select i1 %.14342348.i.i, double %"$phi666.0.2.2.i.i", double %.1449.i.i
  store i64 %.1414.fca.0.load.i.i, ptr %.1733.i, align 8, !noalias !122
  br label %B826.i.i
B826.i.i:
  %end.5.1.i.i = phi double [ %"$phi804.1.2.2.i.i", %B582.i.i ], [ %end.4.1.i.i, %B304.i.i ]
  %.1505.i.i = fsub double %end.5.1.i.i, %t.2.0.i4755.i
  call fastcc void @v47(ptr %.1528.i.i, i64 %.465.fca.3.load.i.i, ptr %.155.i.i, i64 %.465.fca.6.load.i.i, i64 %.465.fca.18.load.i.i, ptr readonly %.4681.i.i, i64 %.465.fca.18.load.i.i, ptr %.4723.i.i, i64 %.465.fca.18.load.i.i, i64 %.2847.i.i, ptr %.2863.i.i, i64 %.81819612000.i.i, ptr %.83419621999.i.i, ptr %.1348.i.i, ptr %.3219.i.i, i64 %.3203.i.i, ptr readonly %.3905.i.i, i64 %.3889.i.i, i64 %.465.fca.5.load.i.i, ptr %.4920.i.i, ptr %.5082.i.i, double %.2090.i, ptr readonly %.2227.i, i64 6, double %t.2.0.i4755.i, double %.1505.i.i, ptr %.4920.i.i, double %end.5.1.i.i)
  %.1683.i.i = load i64, ptr %.1733.i, align 8, !noalias !122
  %.1684.i.i = icmp slt i64 %.1683.i.i, 0
  %.1837.i.i = fcmp olt double %end.5.1.i.i, %"$phi1038.4.2.1.i"
  %or.cond.i4756.i = select i1 %.1684.i.i, i1 %.1837.i.i, i1 false
  br i1 %or.cond.i4756.i, label %B90.i.i, label %_ZN6poppet6engine10integrator15_without_statesB3v42B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c
_ZN6poppet6engine10integrator15_without_statesB3v42B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c:
  %.3072.i = phi i64 [ %.3072.pre.i, %B1374._ZN6poppet6engine10integrator15_without_statesB3v42B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_2 ], [ %.1683.i.i, %B826.i.i ]
  %t.3.1.i4754.i = phi double [ %.2090.i, %B1374._ZN6poppet6engine10integrator15_without_statesB3v42B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_2 ], [ %end.5.1.i.i, %B826.i.i ]
  call void @llvm.lifetime.end.p0(ptr nonnull %.648.i.i), !noalias !44
  call void @llvm.lifetime.end.p0(ptr nonnull %.1307.i.i), !noalias !44
  call void @llvm.lifetime.end.p0(ptr nonnull %.1528.i.i), !noalias !44
  %.3073.i = icmp sgt i64 %.3072.i, -1
  br i1 %.3073.i, label %B1542.i, label %B948.i
B1468.i:
  call void @llvm.lifetime.end.p0(ptr nonnull %.3740.i.i), !noalias !44
  br label %B1542.i
B1542.i:
  %.3348.pre-phi.i = phi i64 [ %.pre.i, %B818.B1542_crit_edge.i ], [ %.996.i.i, %_ZN6poppet6engine8stepping14stop_conditionB3v19B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C ], [ %.996.i.i, %B1468.i ], [ %.996.i.i, %B948.i ], [ %.996.i.i, %_ZN6poppet6engine10integrator15_without_statesB3v42B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c ]
  %segment.2.sroa.0.14836.i = phi double [ %.1764.i, %B818.B1542_crit_edge.i ], [ %.2090.i, %_ZN6poppet6engine8stepping14stop_conditionB3v19B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C ], [ %.2090.i, %B1468.i ], [ %.2090.i, %B948.i ], [ %.2090.i, %_ZN6poppet6engine10integrator15_without_statesB3v42B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c ]
  %segment.2.sroa.84.14835.i = phi ptr [ %.1115.i, %B818.B1542_crit_edge.i ], [ %.2227.i, %_ZN6poppet6engine8stepping14stop_conditionB3v19B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C ], [ %.2227.i, %B1468.i ], [ %.2227.i, %B948.i ], [ %.2227.i, %_ZN6poppet6engine10integrator15_without_statesB3v42B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c ]
  %status.5.14834.i = phi i64 [ 0, %B818.B1542_crit_edge.i ], [ 1, %_ZN6poppet6engine8stepping14stop_conditionB3v19B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C ], [ 1, %B1468.i ], [ 1, %_ZN6poppet6engine10integrator15_without_statesB3v42B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c ], [ 0, %B948.i ]
  %t.4.14832.i = phi double [ %.1764.i, %B818.B1542_crit_edge.i ], [ %.2090.i, %_ZN6poppet6engine8stepping14stop_conditionB3v19B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C ], [ %reached.3.0.i.i.i, %B1468.i ], [ %t.3.1.i4754.i, %_ZN6poppet6engine10integrator15_without_statesB3v42B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c ], [ %t.5.14895.i, %B948.i ]
  %.3334.i = getelementptr i8, ptr %.5082.i.i, i64 16
  %.3335.i = load i64, ptr %.3334.i, align 8, !noalias !44
  %.13.i.i = tail call i64 @llvm.smin.i64(i64 %.3348.pre-phi.i, i64 %.3335.i)
  store i64 %.13.i.i, ptr %.3334.i, align 8, !noalias !44
  %.40.i.i.i4762.i = fsub double %t.4.14832.i, %segment.2.sroa.0.14836.i
  %.151223.not.i.i.i4763.i = icmp eq i64 %.81819612000.i.i, 0
  br i1 %.151223.not.i.i.i4763.i, label %_ZN6poppet6engine8stepping10outputs_atB3v20B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C4781, label %B78.if.i.i.i4764.i
B158.i.i.i4785.i:
  %.423.i.i.i4786.i = getelementptr i8, ptr %.245.i.i.i4768.i, i64 24
  %.424.i.i.i4787.i = load double, ptr %.423.i.i.i4786.i, align 8, !noalias !123
  %.478.i.i.i4788.i = getelementptr i8, ptr %.245.i.i.i4768.i, i64 32
  %.479.i.i.i4789.i = load double, ptr %.478.i.i.i4788.i, align 8, !noalias !123
  %.480.i.i.i4790.i = fmul double %.479.i.i.i4789.i, 5.000000e-01
  %.482.i.i.i4791.i = fmul double %.40.i.i.i4762.i, %.480.i.i.i4790.i
  %.483.i.i.i4792.i = fadd double %.424.i.i.i4787.i, %.482.i.i.i4791.i
  %.484.i.i.i4793.i = fmul double %.483.i.i.i4792.i, 0x401921FB54442D18
  %.486.i.i.i4794.i = fmul double %.40.i.i.i4762.i, %.484.i.i.i4793.i
  %.540.i.i.i4795.i = getelementptr i8, ptr %.245.i.i.i4768.i, i64 40
  %.541.i.i.i4796.i = load double, ptr %.540.i.i.i4795.i, align 8, !noalias !123
  %.542.i.i.i4797.i = fadd double %.541.i.i.i4796.i, %.486.i.i.i4794.i
  %.605.le.i.i.i4798.i = tail call double @llvm.sin.f64(double %.542.i.i.i4797.i)
  %.610.i.i.i4799.i = fmul double %.366.i.i.i4775.i, %.605.le.i.i.i4798.i
  %.612.i.i.i4800.i = fadd double %.304.i.i.i4773.i, %.610.i.i.i4799.i
  br label %B340.i.i.i4777.i
B340.i.i.i4777.i:
  %value.2.1.i.i.i4778.i = phi double [ %.612.i.i.i4800.i, %B158.i.i.i4785.i ], [ %.304.i.i.i4773.i, %B78.if.i.i.i4764.i ]
  %48 = getelementptr double, ptr %.83419621999.i.i, i64 %.93.0224.i.i.i4765.i
  store double %value.2.1.i.i.i4778.i, ptr %48, align 8, !noalias !123
  %exitcond.not.i.i.i4779.i = icmp eq i64 %.81819612000.i.i, %.164.i.i.i4766.i
  br i1 %exitcond.not.i.i.i4779.i, label %_ZN6poppet6engine8stepping10outputs_atB3v20B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C4781, label %B78.if.i.i.i4764.i
B78.if.i.i.i4764.i:
  %.93.0224.i.i.i4765.i = phi i64 [ %.164.i.i.i4766.i, %B340.i.i.i4777.i ], [ 0, %B1542.i ]
  %.164.i.i.i4766.i = add nuw nsw i64 %.93.0224.i.i.i4765.i, 1
  %.245.i.i.i4768.idx.i = mul i64 %.93.0224.i.i.i4765.i, 48
  %.245.i.i.i4768.i = getelementptr i8, ptr %segment.2.sroa.84.14835.i, i64 %.245.i.i.i4768.idx.i
  %.246.i.i.i4769.i = load double, ptr %.245.i.i.i4768.i, align 8, !noalias !123
  %.300.i.i.i4770.i = getelementptr i8, ptr %.245.i.i.i4768.i, i64 8
  %.301.i.i.i4771.i = load double, ptr %.300.i.i.i4770.i, align 8, !noalias !123
  %.303.i.i.i4772.i = fmul double %.40.i.i.i4762.i, %.301.i.i.i4771.i
  %.304.i.i.i4773.i = fadd double %.246.i.i.i4769.i, %.303.i.i.i4772.i
  %.365.i.i.i4774.i = getelementptr i8, ptr %.245.i.i.i4768.i, i64 16
  %.366.i.i.i4775.i = load double, ptr %.365.i.i.i4774.i, align 8, !noalias !123
  %.367.i.i.i4776.i = fcmp une double %.366.i.i.i4775.i, 0.000000e+00
  br i1 %.367.i.i.i4776.i, label %B158.i.i.i4785.i, label %B340.i.i.i4777.i
_ZN6poppet6engine8stepping10outputs_atB3v20B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C4781:
  store double %t.4.14832.i, ptr %.1348.i.i, align 8, !noalias !130
  %.992.i.i4782.i = inttoptr i64 %.465.fca.3.load.i.i to ptr
  tail call void %.992.i.i4782.i(ptr nonnull %.1348.i.i, ptr %.4920.i.i, ptr %.83419621999.i.i, ptr %.155.i.i, ptr %.2863.i.i), !noalias !130
  %.649.i.i = load i64, ptr %.3334.i, align 8, !noalias !131
  %.754872.not.i.i = icmp slt i64 %.2838.i.i, 1
  br i1 %.754872.not.i.i, label %_ZN6poppet6engine8stepping9write_rowB3v38B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_29, label %B116.if.lr.ph.i.i
B116.if.lr.ph.i.i:
  %invariant.gep.i.i = getelementptr double, ptr %.4723.i.i, i64 %.649.i.i
  %.879.i.i = icmp slt i64 %.649.i.i, 0
  %.880.i.i = select i1 %.879.i.i, i64 %.465.fca.18.load.i.i, i64 0
  %invariant.gep875.i.i = getelementptr double, ptr %invariant.gep.i.i, i64 %.880.i.i
  br label %B116.if.i.i
B116.if.i.i:
  %.698.0873.i.i = phi i64 [ 0, %B116.if.lr.ph.i.i ], [ %.767.i.i, %B116.if.i.i ]
  %.767.i.i = add nuw nsw i64 %.698.0873.i.i, 1
  %49 = getelementptr double, ptr %.2863.i.i, i64 %.698.0873.i.i
  %.821.i.i = load double, ptr %49, align 8, !noalias !131
  %.898.i.i = mul i64 %.698.0873.i.i, %.465.fca.18.load.i.i
  %gep876.i.i = getelementptr double, ptr %invariant.gep875.i.i, i64 %.898.i.i
  store double %.821.i.i, ptr %gep876.i.i, align 8, !noalias !131
  %exitcond.not.i4784.i = icmp eq i64 %.2838.i.i, %.767.i.i
  br i1 %exitcond.not.i4784.i, label %_ZN6poppet6engine8stepping9write_rowB3v38B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_29, label %B116.if.i.i
_ZN6poppet6engine8stepping9write_rowB3v38B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_29:
  %.922.i.i = add nsw i64 %.649.i.i, 1
  store i64 %.922.i.i, ptr %.3334.i, align 8, !noalias !131
  br label %B1684.i
B1684.loopexit.i:
  %.2789.sroa.7.0.ph.ph.ph.i = phi double [ %t.2.0.i.i, %B1952.i.i ], [ %t.3.1.i.i, %B104.i.i.i ], [ %t.3.1.i.i, %B352.i.i.i ], [ %t.3.1.i.i, %B284.i.i.i ]
  %.2789.sroa.0.0.ph.ph.ph.i = phi i64 [ 2, %B1952.i.i ], [ 2, %B104.i.i.i ], [ 5, %B352.i.i.i ], [ 3, %B284.i.i.i ]
  call void @llvm.lifetime.end.p0(ptr nonnull %.3740.i.i), !noalias !44
  br label %B1684.i
B1684.i:
  %status.5.14833.i = phi i64 [ %status.5.14834.i, %_ZN6poppet6engine8stepping9write_rowB3v38B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_29 ], [ %.2789.sroa.0.0.ph.ph.ph.i, %B1684.loopexit.i ]
  %t.4.14831.i = phi double [ %t.4.14832.i, %_ZN6poppet6engine8stepping9write_rowB3v38B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_29 ], [ %.2789.sroa.7.0.ph.ph.ph.i, %B1684.loopexit.i ]
  store double %t.4.14831.i, ptr %.5003.i.i, align 8, !noalias !44
  br label %_ZN6poppet6engine10integrator9integrateB2v1B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAg6cJqBrMeIZJFEGM0QQAE8int64_2a.exit
B688.if.i:
  %.1416.04853.i = phi i64 [ %.1485.i, %B688.if.i ], [ 0, %B688.if.preheader.i ]
  %.1485.i = add nuw nsw i64 %.1416.04853.i, 1
  %50 = getelementptr double, ptr %.4920.i.i, i64 %.1416.04853.i
  %.1543.i = load double, ptr %50, align 8, !noalias !44
  %51 = getelementptr double, ptr %.4961.i.i, i64 %.1416.04853.i
  store double %.1543.i, ptr %51, align 8, !noalias !44
  %gep.i = getelementptr double, ptr %invariant.gep.i, i64 %.1416.04853.i
  store double %.1543.i, ptr %gep.i, align 8, !noalias !44
  %gep4929.i = getelementptr double, ptr %invariant.gep4928.i, i64 %.1416.04853.i
  store double 0.000000e+00, ptr %gep4929.i, align 8, !noalias !44
  %exitcond.not.i = icmp eq i64 %.465.fca.5.load.i.i, %.1485.i
  br i1 %exitcond.not.i, label %B818.i, label %B688.if.i
B950.if.i:
  %h.3.04858.i = phi double [ 0.000000e+00, %B950.if.lr.ph.i ], [ %h.4.14896.i, %B948.i ]
  %.1918.04856.i = phi i64 [ 0, %B950.if.lr.ph.i ], [ %.2021.i, %B948.i ]
  %.2021.i = add nuw nsw i64 %.1918.04856.i, 1
  %52 = getelementptr double, ptr %.1011.i, i64 %.1918.04856.i
  %.2090.i = load double, ptr %52, align 8, !noalias !44
  %.2097.i = icmp slt i64 %.2021.i, %.465.fca.17.load.i.i
  %53 = getelementptr double, ptr %.1011.i, i64 %.2021.i
  %"$phi1038.4.2.1.in.i" = select i1 %.2097.i, ptr %53, ptr %.2170.i
  %"$phi1038.4.2.1.i" = load double, ptr %"$phi1038.4.2.1.in.i", align 8, !noalias !44
  %.2225.i = mul i64 %.1918.04856.i, %.292.i.i
  %.2227.i = getelementptr double, ptr %.1115.i, i64 %.2225.i
  br i1 %.2296.i, label %B1090.i, label %B1146.i
B1330.if.i:
  call void @llvm.lifetime.end.p0(ptr nonnull %.3740.i.i), !noalias !44
  br label %_ZN6poppet6engine10integrator9integrateB2v1B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAg6cJqBrMeIZJFEGM0QQAE8int64_2a.exit
_ZN6poppet6engine10integrator9integrateB2v1B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAg6cJqBrMeIZJFEGM0QQAE8int64_2a.exit:
  %status.0 = phi i64 [ %status.5.14833.i, %B1684.i ], [ 0, %B1330.if.i ]
  call void @llvm.lifetime.end.p0(ptr nonnull %.2306.i)
  ret i64 %status.0
}
declare i64 @llvm.smax.i64(i64, i64)
declare i64 @llvm.smin.i64(i64, i64)
declare void @llvm.memset.p0.i64(ptr writeonly, i8, i64, i1 immarg)
declare i64 @llvm.umin.i64(i64, i64)
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
!12 = !{!13, !15, !17}
!13 = distinct !{!13, !14, !"scope"}
!14 = distinct !{!14, !"scope"}
!15 = distinct !{!15, !16, !"scope"}
!16 = distinct !{!16, !"scope"}
!17 = distinct !{!17, !18, !"scope"}
!18 = distinct !{!18, !"scope"}
!19 = !{!15, !17}
!20 = !{!17}
!21 = !{!22}
!22 = distinct !{!22, !23, !"scope"}
!23 = distinct !{!23, !"scope"}
!24 = !{!25}
!25 = distinct !{!25, !26, !"scope"}
!26 = distinct !{!26, !"scope"}
!27 = !{!28}
!28 = distinct !{!28, !29, !"scope"}
!29 = distinct !{!29, !"scope"}
!30 = !{!"branch_weights", i32 1, i32 99}
!31 = !{!32}
!32 = distinct !{!32, !33, !"scope"}
!33 = distinct !{!33, !"scope"}
!34 = !{!35, !37, !39}
!35 = distinct !{!35, !36, !"scope"}
!36 = distinct !{!36, !"scope"}
!37 = distinct !{!37, !38, !"scope"}
!38 = distinct !{!38, !"scope"}
!39 = distinct !{!39, !40, !"scope"}
!40 = distinct !{!40, !"scope"}
!41 = !{!37, !39}
!42 = !{!39}
!43 = !{!"branch_weights", i32 99, i32 1}
!44 = !{!45, !47}
!45 = distinct !{!45, !46, !"scope"}
!46 = distinct !{!46, !"scope"}
!47 = distinct !{!47, !46, !"scope"}
!48 = !{!49, !45, !47}
!49 = distinct !{!49, !50, !"scope"}
!50 = distinct !{!50, !"scope"}
!51 = !{!52, !45, !47}
!52 = distinct !{!52, !53, !"scope"}
!53 = distinct !{!53, !"scope"}
!54 = !{!55, !57, !59, !45, !47}
!55 = distinct !{!55, !56, !"scope"}
!56 = distinct !{!56, !"scope"}
!57 = distinct !{!57, !58, !"scope"}
!58 = distinct !{!58, !"scope"}
!59 = distinct !{!59, !60, !"scope"}
!60 = distinct !{!60, !"scope"}
!61 = !{!57, !59, !45, !47}
!62 = !{!59, !45, !47}
!63 = !{!64, !66, !68, !45, !47}
!64 = distinct !{!64, !65, !"scope"}
!65 = distinct !{!65, !"scope"}
!66 = distinct !{!66, !67, !"scope"}
!67 = distinct !{!67, !"scope"}
!68 = distinct !{!68, !67, !"scope"}
!69 = !{!70, !72, !74, !66, !68, !45, !47}
!70 = distinct !{!70, !71, !"scope"}
!71 = distinct !{!71, !"scope"}
!72 = distinct !{!72, !73, !"scope"}
!73 = distinct !{!73, !"scope"}
!74 = distinct !{!74, !73, !"scope"}
!75 = !{!76, !66, !68, !45, !47}
!76 = distinct !{!76, !77, !"scope"}
!77 = distinct !{!77, !"scope"}
!78 = !{!79, !76, !66, !68, !45, !47}
!79 = distinct !{!79, !80, !"scope"}
!80 = distinct !{!80, !"scope"}
!81 = !{!82, !76, !66, !68, !45, !47}
!82 = distinct !{!82, !83, !"scope"}
!83 = distinct !{!83, !"scope"}
!84 = !{!85, !76, !66, !68, !45, !47}
!85 = distinct !{!85, !86, !"scope"}
!86 = distinct !{!86, !"scope"}
!87 = !{!88, !90, !66, !68, !45, !47}
!88 = distinct !{!88, !89, !"scope"}
!89 = distinct !{!89, !"scope"}
!90 = distinct !{!90, !91, !"scope"}
!91 = distinct !{!91, !"scope"}
!92 = !{!66, !68, !45, !47}
!93 = !{!94, !66, !68, !45, !47}
!94 = distinct !{!94, !95, !"scope"}
!95 = distinct !{!95, !"scope"}
!96 = !{!97, !99, !101, !66, !68, !45, !47}
!97 = distinct !{!97, !98, !"scope"}
!98 = distinct !{!98, !"scope"}
!99 = distinct !{!99, !100, !"scope"}
!100 = distinct !{!100, !"scope"}
!101 = distinct !{!101, !100, !"scope"}
!102 = !{!103, !66, !68, !45, !47}
!103 = distinct !{!103, !104, !"scope"}
!104 = distinct !{!104, !"scope"}
!105 = !{!106, !108, !66, !68, !45, !47}
!106 = distinct !{!106, !107, !"scope"}
!107 = distinct !{!107, !"scope"}
!108 = distinct !{!108, !109, !"scope"}
!109 = distinct !{!109, !"scope"}
!110 = !{!108, !66, !68, !45, !47}
!111 = !{!112, !108, !66, !68, !45, !47}
!112 = distinct !{!112, !113, !"scope"}
!113 = distinct !{!113, !"scope"}
!114 = !{!115, !66, !68, !45, !47}
!115 = distinct !{!115, !116, !"scope"}
!116 = distinct !{!116, !"scope"}
!117 = !{!118, !120, !45, !47}
!118 = distinct !{!118, !119, !"scope"}
!119 = distinct !{!119, !"scope"}
!120 = distinct !{!120, !121, !"scope"}
!121 = distinct !{!121, !"scope"}
!122 = !{!120, !45, !47}
!123 = !{!124, !126, !128, !45, !47}
!124 = distinct !{!124, !125, !"scope"}
!125 = distinct !{!125, !"scope"}
!126 = distinct !{!126, !127, !"scope"}
!127 = distinct !{!127, !"scope"}
!128 = distinct !{!128, !129, !"scope"}
!129 = distinct !{!129, !"scope"}
!130 = !{!126, !128, !45, !47}
!131 = !{!128, !45, !47}
