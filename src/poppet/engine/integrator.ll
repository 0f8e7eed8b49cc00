; made from integrator.py, stepping.py, job.py, rosenbrock.py, sha256 d951bf8c4d0c7119bbcb2dd23fed446dca7a6434da2ab2905efd845b68f467b6
@switch.table.integrate = private unnamed_addr constant [4 x double] [double 3.860000e-01, double 2.100000e-01, double 6.300000e-01, double 1.000000e+00], align 8
declare double @llvm.fabs.f64(double)
define internal fastcc void @v45(ptr noalias nonnull writeonly %retptr, i64 %arg.run.0.4, ptr %arg.run.1.0.4, i64 %arg.run.1.1.2, ptr %arg.run.1.1.4, ptr readonly %arg.run.1.2.4, i64 %arg.run.1.3.2, ptr %arg.run.1.3.4, ptr %arg.run.1.4.4, i64 %arg.run.5.0.2, ptr %arg.run.5.0.4, ptr %arg.run.5.3.4, ptr readonly %arg.segment.2.4, i64 %arg.segment.2.5.1, double %arg.t, ptr %arg.x.4) unnamed_addr {
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
  %.148211.not.i = icmp slt i64 %arg.run.5.0.2, 1
  %.1203 = inttoptr i64 %arg.run.0.4 to ptr
  %.13131567.not = icmp slt i64 %arg.run.1.1.2, 1
  br label %B112
B112:
  %changed.4.0 = phi i1 [ %changed.3.1.lcssa, %_ZN6poppet6engine8stepping12next_instantB3v16B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE199Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit1561 ], [ false, %B112.preheader ]
  br i1 %.164126.not.i, label %B162.if, label %B226
B226:
  store double %arg.t, ptr %arg.run.5.3.4, align 8
  br i1 %.148211.not.i, label %_ZN6poppet6engine8stepping9inputs_atB3v18B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd72Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_295ArrayIdLi1E1C7mutable7alignedE.exit, label %B58.if.i
B164.i:
  %.44.i.i = getelementptr i8, ptr %2, i64 24
  %.45.i.i = load double, ptr %.44.i.i, align 8, !noalias !3
  %.73.i.i = getelementptr i8, ptr %2, i64 32
  %.74.i.i = load double, ptr %.73.i.i, align 8, !noalias !3
  %.75.i.i = fmul double %.74.i.i, 5.000000e-01
  %.76.i.i = fmul double %.245.i, %.75.i.i
  %.77.i.i = fadd double %.45.i.i, %.76.i.i
  %.78.i.i = fmul double %.245.i, %.77.i.i
  %.87.le.i.i = tail call double @llvm.floor.f64(double %.78.i.i)
  %.92.i.i = fsub double %.78.i.i, %.87.le.i.i
  %.93.i.i = fmul double %.92.i.i, 0x401921FB54442D18
  %.121.i.i = getelementptr i8, ptr %2, i64 40
  %.122.i.i = load double, ptr %.121.i.i, align 8, !noalias !3
  %.126.i.i = fadd double %.122.i.i, %.93.i.i
  %.593.le.i = tail call double @llvm.sin.f64(double %.126.i.i)
  %.598.i = fmul double %.423.i, %.593.le.i
  %.600.i = fadd double %.361.i, %.598.i
  br label %B272.i
B272.i:
  %value.2.1.i = phi double [ %.600.i, %B164.i ], [ %.361.i, %B58.if.i ]
  %1 = getelementptr double, ptr %arg.run.5.0.4, i64 %.90.0213.i
  store double %value.2.1.i, ptr %1, align 8, !noalias !8
  %exitcond.not.i1550 = icmp eq i64 %arg.run.5.0.2, %.161.i
  br i1 %exitcond.not.i1550, label %_ZN6poppet6engine8stepping9inputs_atB3v18B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd72Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_295ArrayIdLi1E1C7mutable7alignedE.exit, label %B58.if.i
B58.if.i:
  %.90.0213.i = phi i64 [ %.161.i, %B272.i ], [ 0, %B226 ]
  %.161.i = add nuw nsw i64 %.90.0213.i, 1
  %.238.i = mul i64 %.90.0213.i, %arg.segment.2.5.1
  %2 = getelementptr double, ptr %arg.segment.2.4, i64 %.238.i
  %.242.i = getelementptr i8, ptr %2, i64 48
  %.243.i = load double, ptr %.242.i, align 8, !noalias !8
  %.245.i = fsub double %arg.t, %.243.i
  %.303.i = load double, ptr %2, align 8, !noalias !8
  %.357.i = getelementptr i8, ptr %2, i64 8
  %.358.i = load double, ptr %.357.i, align 8, !noalias !8
  %.360.i = fmul double %.245.i, %.358.i
  %.361.i = fadd double %.303.i, %.360.i
  %.422.i = getelementptr i8, ptr %2, i64 16
  %.423.i = load double, ptr %.422.i, align 8, !noalias !8
  %.424.i = fcmp une double %.423.i, 0.000000e+00
  br i1 %.424.i, label %B164.i, label %B272.i
_ZN6poppet6engine8stepping9inputs_atB3v18B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd72Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_295ArrayIdLi1E1C7mutable7alignedE.exit:
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
  %changed.3.1.lcssa = phi i1 [ %changed.4.0, %_ZN6poppet6engine8stepping9inputs_atB3v18B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd72Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_295ArrayIdLi1E1C7mutable7alignedE.exit ], [ %changed.5.2, %B542 ]
  br i1 %.164126.not.i, label %B78.if.i1552, label %_ZN6poppet6engine8stepping12next_instantB3v16B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE199Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit1561
B78.if.i1552:
  %first.2.0129.i1553 = phi double [ %.13.i.i1558, %B78.if.i1552 ], [ 0x7FF0000000000000, %B586 ]
  %.106.0128.i1554 = phi i64 [ %.177.i1555, %B78.if.i1552 ], [ 0, %B586 ]
  %.177.i1555 = add nuw nsw i64 %.106.0128.i1554, 1
  %5 = getelementptr double, ptr %arg.run.1.1.4, i64 %.106.0128.i1554
  %.235.i1556 = load double, ptr %5, align 8, !noalias !9
  %.12.i.i1557 = fcmp olt double %.235.i1556, %first.2.0129.i1553
  %.13.i.i1558 = select i1 %.12.i.i1557, double %.235.i1556, double %first.2.0129.i1553
  %exitcond.not.i1559 = icmp eq i64 %arg.run.1.3.2, %.177.i1555
  br i1 %exitcond.not.i1559, label %_ZN6poppet6engine8stepping12next_instantB3v16B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE199Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit1561, label %B78.if.i1552
_ZN6poppet6engine8stepping12next_instantB3v16B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE199Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit1561:
  %first.2.0.lcssa.i1560 = phi double [ 0x7FF0000000000000, %B586 ], [ %.13.i.i1558, %B78.if.i1552 ]
  %.1617 = fcmp ugt double %first.2.0.lcssa.i1560, %.765
  br i1 %.1617, label %B626.loopexit, label %B112
B626.loopexit:
  %6 = zext i1 %changed.3.1.lcssa to i8
  br label %B626
B626:
  %changed.2.1 = phi i8 [ 0, %_ZN6poppet6engine8stepping12next_instantB3v16B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE199Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit ], [ %6, %B626.loopexit ]
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
  %changed.3.11570 = phi i1 [ %changed.5.2, %B542 ], [ %changed.4.0, %_ZN6poppet6engine8stepping9inputs_atB3v18B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd72Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_295ArrayIdLi1E1C7mutable7alignedE.exit ]
  %.1257.01568 = phi i64 [ %.1326, %B542 ], [ 0, %_ZN6poppet6engine8stepping9inputs_atB3v18B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd72Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_295ArrayIdLi1E1C7mutable7alignedE.exit ]
  %.1326 = add nuw nsw i64 %.1257.01568, 1
  %9 = getelementptr i8, ptr %arg.run.1.2.4, i64 %.1257.01568
  %.1392 = load i8, ptr %9, align 1
  %.1396.not = icmp eq i8 %.1392, 0
  %.phi.trans.insert = getelementptr double, ptr %arg.run.1.4.4, i64 %.1257.01568
  %.1523.pre = load double, ptr %.phi.trans.insert, align 8
  br i1 %.1396.not, label %B542, label %B482
}
declare double @llvm.sin.f64(double)
declare double @llvm.floor.f64(double)
declare double @llvm.pow.f64(double, double)
define internal fastcc void @v46(ptr noalias nonnull writeonly %retptr, i64 %arg.run.0.3, ptr %arg.run.1.0.4, ptr %arg.run.3.2.4, ptr readonly %arg.run.4.0.4, i64 %arg.run.4.0.5.1, ptr readonly %arg.run.4.1.4, i64 %arg.run.4.1.5.0, i64 %arg.run.4.1.5.1, i64 %arg.run.5.0.2, ptr %arg.run.5.0.4, ptr %arg.run.5.3.4, ptr readonly %arg.run.5.11.4, i64 %arg.run.5.11.5.0, i64 %arg.run.5.12.2, ptr %arg.run.5.12.4, i64 %arg.run.6.2, ptr readonly %arg.run.6.4, ptr readonly %arg.segment.2.4, i64 %arg.segment.2.5.1, double %arg.step.0, double %arg.step.1, ptr readonly %arg.step.3.4) unnamed_addr {
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
  br i1 %.703768.not.i, label %_ZN6poppet6engine8stepping11interpolateB3v36B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2982Step_28float64_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d, label %B102.if.i
B102.if.i:
  %.645.0769.i = phi i64 [ %.716.i, %B102.if.i ], [ 0, %B48 ]
  %.716.i = add nuw nsw i64 %.645.0769.i, 1
  %0 = getelementptr double, ptr %arg.run.6.4, i64 %.645.0769.i
  %.774.i = load double, ptr %0, align 8, !noalias !12
  %.779.i = fmul double %.478.i, %.774.i
  %1 = getelementptr double, ptr %arg.step.3.4, i64 %.645.0769.i
  %.813.i = load double, ptr %1, align 8, !noalias !12
  %2 = getelementptr double, ptr %arg.run.5.11.4, i64 %.645.0769.i
  %.846.i = load double, ptr %2, align 8, !noalias !12
  %.848.i = add nsw i64 %.645.0769.i, %arg.run.6.2
  %.862.i = icmp slt i64 %.848.i, 0
  %.863.i = select i1 %.862.i, i64 %arg.run.5.11.5.0, i64 0
  %3 = getelementptr double, ptr %arg.run.5.11.4, i64 %.848.i
  %.877.i = getelementptr double, ptr %3, i64 %.863.i
  %.878.i = load double, ptr %.877.i, align 8, !noalias !12
  %.880.i = fmul double %high.3.1, %.878.i
  %.881.i = fadd double %.846.i, %.880.i
  %.883.i = fmul double %.478.i, %.881.i
  %.884.i = fadd double %.813.i, %.883.i
  %.886.i = fmul double %high.3.1, %.884.i
  %.887.i = fadd double %.779.i, %.886.i
  %4 = getelementptr double, ptr %arg.run.5.12.4, i64 %.645.0769.i
  store double %.887.i, ptr %4, align 8, !noalias !12
  %exitcond.not.i = icmp eq i64 %arg.run.5.12.2, %.716.i
  br i1 %exitcond.not.i, label %_ZN6poppet6engine8stepping11interpolateB3v36B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2982Step_28float64_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d, label %B102.if.i
_ZN6poppet6engine8stepping11interpolateB3v36B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2982Step_28float64_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d:
  %.796 = fmul double %arg.step.1, %high.3.1
  %.797 = fadd double %arg.step.0, %.796
  br i1 %.148211.not.i.i.i, label %_ZN6poppet6engine8stepping10outputs_atB3v21B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_, label %B58.if.i.i.i
B164.i.i.i:
  %.44.i.i.i.i = getelementptr i8, ptr %6, i64 24
  %.45.i.i.i.i = load double, ptr %.44.i.i.i.i, align 8, !noalias !15
  %.73.i.i.i.i = getelementptr i8, ptr %6, i64 32
  %.74.i.i.i.i = load double, ptr %.73.i.i.i.i, align 8, !noalias !15
  %.75.i.i.i.i = fmul double %.74.i.i.i.i, 5.000000e-01
  %.76.i.i.i.i = fmul double %.245.i.i.i, %.75.i.i.i.i
  %.77.i.i.i.i = fadd double %.45.i.i.i.i, %.76.i.i.i.i
  %.78.i.i.i.i = fmul double %.245.i.i.i, %.77.i.i.i.i
  %.87.le.i.i.i.i = tail call double @llvm.floor.f64(double %.78.i.i.i.i)
  %.92.i.i.i.i = fsub double %.78.i.i.i.i, %.87.le.i.i.i.i
  %.93.i.i.i.i = fmul double %.92.i.i.i.i, 0x401921FB54442D18
  %.121.i.i.i.i = getelementptr i8, ptr %6, i64 40
  %.122.i.i.i.i = load double, ptr %.121.i.i.i.i, align 8, !noalias !15
  %.126.i.i.i.i = fadd double %.122.i.i.i.i, %.93.i.i.i.i
  %.593.le.i.i.i = tail call double @llvm.sin.f64(double %.126.i.i.i.i)
  %.598.i.i.i = fmul double %.423.i.i.i, %.593.le.i.i.i
  %.600.i.i.i = fadd double %.361.i.i.i, %.598.i.i.i
  br label %B272.i.i.i
B272.i.i.i:
  %value.2.1.i.i.i = phi double [ %.600.i.i.i, %B164.i.i.i ], [ %.361.i.i.i, %B58.if.i.i.i ]
  %5 = getelementptr double, ptr %arg.run.5.0.4, i64 %.90.0213.i.i.i
  store double %value.2.1.i.i.i, ptr %5, align 8, !noalias !24
  %exitcond.not.i.i.i = icmp eq i64 %arg.run.5.0.2, %.161.i.i.i
  br i1 %exitcond.not.i.i.i, label %_ZN6poppet6engine8stepping10outputs_atB3v21B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_, label %B58.if.i.i.i
B58.if.i.i.i:
  %.90.0213.i.i.i = phi i64 [ %.161.i.i.i, %B272.i.i.i ], [ 0, %_ZN6poppet6engine8stepping11interpolateB3v36B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2982Step_28float64_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d ]
  %.161.i.i.i = add nuw nsw i64 %.90.0213.i.i.i, 1
  %.238.i.i.i = mul i64 %.90.0213.i.i.i, %arg.segment.2.5.1
  %6 = getelementptr double, ptr %arg.segment.2.4, i64 %.238.i.i.i
  %.242.i.i.i = getelementptr i8, ptr %6, i64 48
  %.243.i.i.i = load double, ptr %.242.i.i.i, align 8, !noalias !24
  %.245.i.i.i = fsub double %.797, %.243.i.i.i
  %.303.i.i.i = load double, ptr %6, align 8, !noalias !24
  %.357.i.i.i = getelementptr i8, ptr %6, i64 8
  %.358.i.i.i = load double, ptr %.357.i.i.i, align 8, !noalias !24
  %.360.i.i.i = fmul double %.245.i.i.i, %.358.i.i.i
  %.361.i.i.i = fadd double %.303.i.i.i, %.360.i.i.i
  %.422.i.i.i = getelementptr i8, ptr %6, i64 16
  %.423.i.i.i = load double, ptr %.422.i.i.i, align 8, !noalias !24
  %.424.i.i.i = fcmp une double %.423.i.i.i, 0.000000e+00
  br i1 %.424.i.i.i, label %B164.i.i.i, label %B272.i.i.i
_ZN6poppet6engine8stepping10outputs_atB3v21B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_:
  store double %.797, ptr %arg.run.5.3.4, align 8, !noalias !25
  tail call void %.992.i.i(ptr nonnull %arg.run.5.3.4, ptr %arg.run.5.12.4, ptr %arg.run.5.0.4, ptr %arg.run.1.0.4, ptr %arg.run.3.2.4), !noalias !25
  br label %B140.i
B140.i:
  %.859.0.i = phi i64 [ 0, %_ZN6poppet6engine8stepping10outputs_atB3v21B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_ ], [ %.928.i, %B288.i ]
  %exitcond294.not.i = icmp eq i64 %.859.0.i, %spec.select.i
  br i1 %exitcond294.not.i, label %_ZN6poppet6engine8stepping14stop_conditionB3v20B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C, label %B142.i
B142.i:
  %.1005.i = mul i64 %.859.0.i, %arg.run.4.1.5.1
  %7 = getelementptr double, ptr %arg.run.4.1.4, i64 %.1005.i
  %.1009.i = getelementptr i8, ptr %7, i64 16
  %.1010.i = load double, ptr %.1009.i, align 8, !noalias !26
  %.1186.i = mul i64 %.859.0.i, %arg.run.4.0.5.1
  %8 = getelementptr i64, ptr %arg.run.4.0.4, i64 %.1186.i
  br label %B194.if.i
B226.i:
  %9 = getelementptr double, ptr %7, i64 %.1037.0289.i
  %.1249.i = load double, ptr %9, align 8, !noalias !26
  %.1338.i = getelementptr double, ptr %arg.run.3.2.4, i64 %.1191.i
  %.1339.i = load double, ptr %.1338.i, align 8, !noalias !26
  %.1340.i = fmul double %.1249.i, %.1339.i
  %.1342.i = fadd double %value.2.1291.i, %.1340.i
  br label %B286.i
B286.i:
  %value.3.2.i = phi double [ %.1342.i, %B226.i ], [ %value.2.1291.i, %B194.if.i ]
  br i1 %exitcond.not.i1267, label %B288.i, label %B194.if.i
B288.i:
  %.928.i = add nuw i64 %.859.0.i, 1
  %.1361.i = fcmp ogt double %value.3.2.i, 0.000000e+00
  br i1 %.1361.i, label %_ZN6poppet6engine8stepping14stop_conditionB3v20B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C, label %B140.i
B194.if.i:
  %value.2.1291.i = phi double [ %.1010.i, %B142.i ], [ %value.3.2.i, %B286.i ]
  %exitcond.not.i1267 = phi i1 [ false, %B142.i ], [ true, %B286.i ]
  %.1037.0289.i = phi i64 [ 0, %B142.i ], [ 1, %B286.i ]
  %10 = getelementptr i64, ptr %8, i64 %.1037.0289.i
  %.1191.i = load i64, ptr %10, align 8, !noalias !26
  %.1194.i = icmp sgt i64 %.1191.i, -1
  br i1 %.1194.i, label %B226.i, label %B286.i
_ZN6poppet6engine8stepping14stop_conditionB3v20B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C:
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
  %.774.i1273 = load double, ptr %12, align 8, !noalias !27
  %.779.i1274 = fmul double %.478.i1268, %.774.i1273
  %13 = getelementptr double, ptr %arg.step.3.4, i64 %.645.0769.i1271
  %.813.i1275 = load double, ptr %13, align 8, !noalias !27
  %14 = getelementptr double, ptr %arg.run.5.11.4, i64 %.645.0769.i1271
  %.846.i1276 = load double, ptr %14, align 8, !noalias !27
  %.848.i1277 = add nsw i64 %.645.0769.i1271, %arg.run.6.2
  %.862.i1278 = icmp slt i64 %.848.i1277, 0
  %.863.i1279 = select i1 %.862.i1278, i64 %arg.run.5.11.5.0, i64 0
  %15 = getelementptr double, ptr %arg.run.5.11.4, i64 %.848.i1277
  %.877.i1280 = getelementptr double, ptr %15, i64 %.863.i1279
  %.878.i1281 = load double, ptr %.877.i1280, align 8, !noalias !27
  %.880.i1282 = fmul double %high.3.1.theta.2.1, %.878.i1281
  %.881.i1283 = fadd double %.846.i1276, %.880.i1282
  %.883.i1284 = fmul double %.478.i1268, %.881.i1283
  %.884.i1285 = fadd double %.813.i1275, %.883.i1284
  %.886.i1286 = fmul double %high.3.1.theta.2.1, %.884.i1285
  %.887.i1287 = fadd double %.779.i1274, %.886.i1286
  %16 = getelementptr double, ptr %arg.run.5.12.4, i64 %.645.0769.i1271
  store double %.887.i1287, ptr %16, align 8, !noalias !27
  %exitcond.not.i1288 = icmp eq i64 %arg.run.5.12.2, %.716.i1272
  br i1 %exitcond.not.i1288, label %common.ret, label %B102.if.i1270
}
define internal fastcc void @v47(ptr noalias nonnull writeonly %retptr, i64 %arg.run.0.3, i64 %arg.run.0.4, ptr %arg.run.1.0.4, i64 %arg.run.1.1.2, ptr %arg.run.1.1.4, ptr readonly %arg.run.1.2.4, i64 %arg.run.1.3.2, ptr %arg.run.1.3.4, ptr %arg.run.1.4.4, i64 %arg.run.2.1.2, i64 %arg.run.3.0.2, ptr readonly %arg.run.3.0.4, i64 %arg.run.3.0.5.0, ptr writeonly %arg.run.3.1.4, i64 %arg.run.3.1.5.1, i64 %arg.run.3.2.2, ptr %arg.run.3.2.4, i64 %arg.run.5.0.2, ptr %arg.run.5.0.4, ptr %arg.run.5.3.4, ptr %arg.run.5.6.4, i64 %arg.run.5.6.5.0, ptr readonly %arg.run.5.11.4, i64 %arg.run.5.11.5.0, i64 %arg.run.5.12.2, ptr %arg.run.5.12.4, i64 %arg.run.6.2, ptr readonly %arg.run.6.4, ptr %arg.run.9.4, ptr readonly %arg.segment.2.4, i64 %arg.segment.2.5.1, double %arg.step.0, double %arg.step.1, double %arg.step.2, ptr readonly %arg.step.3.4) unnamed_addr {
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
  %.235.i = load double, ptr %0, align 8, !noalias !30
  %.12.i.i = fcmp olt double %.235.i, %first.2.0129.i
  %.13.i.i = select i1 %.12.i.i, double %.235.i, double %first.2.0129.i
  %exitcond.not.i = icmp eq i64 %arg.run.1.3.2, %.177.i
  br i1 %exitcond.not.i, label %_ZN6poppet6engine8stepping12next_instantB3v16B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE199Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit, label %B78.if.i
_ZN6poppet6engine8stepping12next_instantB3v16B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE199Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit:
  %first.2.0.lcssa.i = phi double [ 0x7FF0000000000000, %B6 ], [ %.13.i.i, %B78.if.i ]
  %.586 = fcmp ult double %first.2.0.lcssa.i, %.584
  br i1 %.586, label %B124, label %common.ret
common.ret:
  %storemerge = phi double [ %arg.step.2, %_ZN6poppet6engine8stepping12next_instantB3v16B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE199Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit ], [ %first.2.0.lcssa.i, %_ZN6poppet6engine8stepping11interpolateB3v36B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2982Step_28float64_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d ]
  store double %storemerge, ptr %retptr, align 8
  ret void
B124:
  call fastcc void @v48(ptr %.729, i64 %arg.run.0.3, ptr %arg.run.1.0.4, i64 %arg.run.2.1.2, i64 %arg.run.3.0.2, ptr %arg.run.3.0.4, i64 %arg.run.3.0.5.0, ptr %arg.run.3.1.4, i64 %arg.run.3.1.5.1, i64 %arg.run.3.2.2, ptr %arg.run.3.2.4, i64 %arg.run.5.0.2, ptr %arg.run.5.0.4, ptr %arg.run.5.3.4, ptr %arg.run.5.6.4, i64 %arg.run.5.6.5.0, ptr %arg.run.5.11.4, i64 %arg.run.5.11.5.0, i64 %arg.run.6.2, ptr %arg.run.6.4, ptr %arg.run.9.4, ptr %arg.segment.2.4, i64 %arg.segment.2.5.1, double %arg.step.0, double %arg.step.1, ptr %arg.step.3.4, double %first.2.0.lcssa.i)
  %.850 = fsub double %first.2.0.lcssa.i, %arg.step.0
  %.856 = fdiv double %.850, %arg.step.1
  %.478.i = fsub double 1.000000e+00, %.856
  br i1 %.703768.not.i, label %_ZN6poppet6engine8stepping11interpolateB3v36B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2982Step_28float64_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d, label %B102.if.i
B102.if.i:
  %.645.0769.i = phi i64 [ %.716.i, %B102.if.i ], [ 0, %B124 ]
  %.716.i = add nuw nsw i64 %.645.0769.i, 1
  %1 = getelementptr double, ptr %arg.run.6.4, i64 %.645.0769.i
  %.774.i = load double, ptr %1, align 8, !noalias !33
  %.779.i = fmul double %.478.i, %.774.i
  %2 = getelementptr double, ptr %arg.step.3.4, i64 %.645.0769.i
  %.813.i = load double, ptr %2, align 8, !noalias !33
  %3 = getelementptr double, ptr %arg.run.5.11.4, i64 %.645.0769.i
  %.846.i = load double, ptr %3, align 8, !noalias !33
  %.848.i = add nsw i64 %.645.0769.i, %arg.run.6.2
  %.862.i = icmp slt i64 %.848.i, 0
  %.863.i = select i1 %.862.i, i64 %arg.run.5.11.5.0, i64 0
  %4 = getelementptr double, ptr %arg.run.5.11.4, i64 %.848.i
  %.877.i = getelementptr double, ptr %4, i64 %.863.i
  %.878.i = load double, ptr %.877.i, align 8, !noalias !33
  %.880.i = fmul double %.856, %.878.i
  %.881.i = fadd double %.846.i, %.880.i
  %.883.i = fmul double %.478.i, %.881.i
  %.884.i = fadd double %.813.i, %.883.i
  %.886.i = fmul double %.856, %.884.i
  %.887.i = fadd double %.779.i, %.886.i
  %5 = getelementptr double, ptr %arg.run.5.12.4, i64 %.645.0769.i
  store double %.887.i, ptr %5, align 8, !noalias !33
  %exitcond.not.i1480 = icmp eq i64 %arg.run.5.12.2, %.716.i
  br i1 %exitcond.not.i1480, label %_ZN6poppet6engine8stepping11interpolateB3v36B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2982Step_28float64_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d, label %B102.if.i
_ZN6poppet6engine8stepping11interpolateB3v36B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2982Step_28float64_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d:
  store i8 0, ptr %.1201, align 1
  call fastcc void @v45(ptr %.1201, i64 %arg.run.0.4, ptr %arg.run.1.0.4, i64 %arg.run.1.1.2, ptr %arg.run.1.1.4, ptr %arg.run.1.2.4, i64 %arg.run.1.3.2, ptr %arg.run.1.3.4, ptr %arg.run.1.4.4, i64 %arg.run.5.0.2, ptr %arg.run.5.0.4, ptr %arg.run.5.3.4, ptr %arg.segment.2.4, i64 %arg.segment.2.5.1, double %first.2.0.lcssa.i, ptr %arg.run.5.12.4)
  %.1308 = load i8, ptr %.1201, align 1
  %.1311.not = icmp eq i8 %.1308, 0
  br i1 %.1311.not, label %B6, label %common.ret
}
define internal fastcc void @v48(ptr noalias nonnull writeonly %retptr, i64 %arg.run.0.3, ptr %arg.run.1.0.4, i64 %arg.run.2.1.2, i64 %arg.run.3.0.2, ptr readonly %arg.run.3.0.4, i64 %arg.run.3.0.5.0, ptr writeonly %arg.run.3.1.4, i64 %arg.run.3.1.5.1, i64 %arg.run.3.2.2, ptr %arg.run.3.2.4, i64 %arg.run.5.0.2, ptr %arg.run.5.0.4, ptr %arg.run.5.3.4, ptr %arg.run.5.6.4, i64 %arg.run.5.6.5.0, ptr readonly %arg.run.5.11.4, i64 %arg.run.5.11.5.0, i64 %arg.run.6.2, ptr readonly %arg.run.6.4, ptr %arg.run.9.4, ptr readonly %arg.segment.2.4, i64 %arg.segment.2.5.1, double %arg.step.0, double %arg.step.1, ptr readonly %arg.step.3.4, double %arg.until) unnamed_addr {
entry:
  %.5.i = fmul double %arg.until, 0x3D06849B86A12B9B
  %.6.i = fadd double %.5.i, 1.000000e-15
  %.510 = fsub double %arg.until, %.6.i
  %.731 = icmp slt i64 %arg.run.5.6.5.0, 1
  br i1 %.731, label %B0.endif.else.endif.if, label %B0.endif.else.endif.endif, !prof !36
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
  br i1 %.703768.not.i, label %_ZN6poppet6engine8stepping11interpolateB3v36B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2982Step_28float64_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d, label %B102.if.i
B102.if.i:
  %.645.0769.i = phi i64 [ %.716.i, %B102.if.i ], [ 0, %B244 ]
  %.716.i = add nuw nsw i64 %.645.0769.i, 1
  %2 = getelementptr double, ptr %arg.run.6.4, i64 %.645.0769.i
  %.774.i = load double, ptr %2, align 8, !noalias !37
  %.779.i = fmul double %.478.i, %.774.i
  %3 = getelementptr double, ptr %arg.step.3.4, i64 %.645.0769.i
  %.813.i = load double, ptr %3, align 8, !noalias !37
  %4 = getelementptr double, ptr %arg.run.5.11.4, i64 %.645.0769.i
  %.846.i = load double, ptr %4, align 8, !noalias !37
  %.848.i = add nsw i64 %.645.0769.i, %arg.run.6.2
  %.862.i = icmp slt i64 %.848.i, 0
  %.863.i = select i1 %.862.i, i64 %arg.run.5.11.5.0, i64 0
  %5 = getelementptr double, ptr %arg.run.5.11.4, i64 %.848.i
  %.877.i = getelementptr double, ptr %5, i64 %.863.i
  %.878.i = load double, ptr %.877.i, align 8, !noalias !37
  %.880.i = fmul double %.13.i, %.878.i
  %.881.i = fadd double %.846.i, %.880.i
  %.883.i = fmul double %.478.i, %.881.i
  %.884.i = fadd double %.813.i, %.883.i
  %.886.i = fmul double %.13.i, %.884.i
  %.887.i = fadd double %.779.i, %.886.i
  %6 = getelementptr double, ptr %.824, i64 %.645.0769.i
  store double %.887.i, ptr %6, align 8, !noalias !37
  %exitcond.not.i = icmp eq i64 %.799, %.716.i
  br i1 %exitcond.not.i, label %_ZN6poppet6engine8stepping11interpolateB3v36B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2982Step_28float64_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d, label %B102.if.i
_ZN6poppet6engine8stepping11interpolateB3v36B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2982Step_28float64_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d:
  br i1 %.148211.not.i.i.i, label %_ZN6poppet6engine8stepping10outputs_atB3v21B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_, label %B58.if.i.i.i
B164.i.i.i:
  %.44.i.i.i.i = getelementptr i8, ptr %8, i64 24
  %.45.i.i.i.i = load double, ptr %.44.i.i.i.i, align 8, !noalias !40
  %.73.i.i.i.i = getelementptr i8, ptr %8, i64 32
  %.74.i.i.i.i = load double, ptr %.73.i.i.i.i, align 8, !noalias !40
  %.75.i.i.i.i = fmul double %.74.i.i.i.i, 5.000000e-01
  %.76.i.i.i.i = fmul double %.245.i.i.i, %.75.i.i.i.i
  %.77.i.i.i.i = fadd double %.45.i.i.i.i, %.76.i.i.i.i
  %.78.i.i.i.i = fmul double %.245.i.i.i, %.77.i.i.i.i
  %.87.le.i.i.i.i = tail call double @llvm.floor.f64(double %.78.i.i.i.i)
  %.92.i.i.i.i = fsub double %.78.i.i.i.i, %.87.le.i.i.i.i
  %.93.i.i.i.i = fmul double %.92.i.i.i.i, 0x401921FB54442D18
  %.121.i.i.i.i = getelementptr i8, ptr %8, i64 40
  %.122.i.i.i.i = load double, ptr %.121.i.i.i.i, align 8, !noalias !40
  %.126.i.i.i.i = fadd double %.122.i.i.i.i, %.93.i.i.i.i
  %.593.le.i.i.i = tail call double @llvm.sin.f64(double %.126.i.i.i.i)
  %.598.i.i.i = fmul double %.423.i.i.i, %.593.le.i.i.i
  %.600.i.i.i = fadd double %.361.i.i.i, %.598.i.i.i
  br label %B272.i.i.i
B272.i.i.i:
  %value.2.1.i.i.i = phi double [ %.600.i.i.i, %B164.i.i.i ], [ %.361.i.i.i, %B58.if.i.i.i ]
  %7 = getelementptr double, ptr %arg.run.5.0.4, i64 %.90.0213.i.i.i
  store double %value.2.1.i.i.i, ptr %7, align 8, !noalias !49
  %exitcond.not.i.i.i = icmp eq i64 %arg.run.5.0.2, %.161.i.i.i
  br i1 %exitcond.not.i.i.i, label %_ZN6poppet6engine8stepping10outputs_atB3v21B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_, label %B58.if.i.i.i
B58.if.i.i.i:
  %.90.0213.i.i.i = phi i64 [ %.161.i.i.i, %B272.i.i.i ], [ 0, %_ZN6poppet6engine8stepping11interpolateB3v36B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2982Step_28float64_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d ]
  %.161.i.i.i = add nuw nsw i64 %.90.0213.i.i.i, 1
  %.238.i.i.i = mul i64 %.90.0213.i.i.i, %arg.segment.2.5.1
  %8 = getelementptr double, ptr %arg.segment.2.4, i64 %.238.i.i.i
  %.242.i.i.i = getelementptr i8, ptr %8, i64 48
  %.243.i.i.i = load double, ptr %.242.i.i.i, align 8, !noalias !49
  %.245.i.i.i = fsub double %.1065, %.243.i.i.i
  %.303.i.i.i = load double, ptr %8, align 8, !noalias !49
  %.357.i.i.i = getelementptr i8, ptr %8, i64 8
  %.358.i.i.i = load double, ptr %.357.i.i.i, align 8, !noalias !49
  %.360.i.i.i = fmul double %.245.i.i.i, %.358.i.i.i
  %.361.i.i.i = fadd double %.303.i.i.i, %.360.i.i.i
  %.422.i.i.i = getelementptr i8, ptr %8, i64 16
  %.423.i.i.i = load double, ptr %.422.i.i.i, align 8, !noalias !49
  %.424.i.i.i = fcmp une double %.423.i.i.i, 0.000000e+00
  br i1 %.424.i.i.i, label %B164.i.i.i, label %B272.i.i.i
_ZN6poppet6engine8stepping10outputs_atB3v21B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_:
  store double %.1065, ptr %arg.run.5.3.4, align 8, !noalias !50
  tail call void %.992.i.i(ptr nonnull %arg.run.5.3.4, ptr %.824, ptr %arg.run.5.0.4, ptr %arg.run.1.0.4, ptr %arg.run.3.2.4), !noalias !50
  %.649.i = load i64, ptr %.912, align 8, !noalias !51
  br i1 %.754872.not.i, label %_ZN6poppet6engine8stepping9write_rowB3v39B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_29, label %B116.if.lr.ph.i
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
  %.821.i = load double, ptr %9, align 8, !noalias !51
  %.898.i = mul i64 %.698.0873.i, %arg.run.3.1.5.1
  %gep876.i = getelementptr double, ptr %invariant.gep875.i, i64 %.898.i
  store double %.821.i, ptr %gep876.i, align 8, !noalias !51
  %exitcond.not.i3008 = icmp eq i64 %.767.i, %arg.run.3.2.2
  br i1 %exitcond.not.i3008, label %_ZN6poppet6engine8stepping9write_rowB3v39B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_29, label %B116.if.i
_ZN6poppet6engine8stepping9write_rowB3v39B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_29:
  %.922.i = add nsw i64 %.649.i, 1
  store i64 %.922.i, ptr %.912, align 8, !noalias !51
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
  br i1 %.743, label %B0.endif.else.endif.endif.if, label %B0.endif.else.endif.endif.endif, !prof !36
B0.endif.else.endif.endif.if:
  br label %B0.endif.else.endif.endif.endif
B0.endif.else.endif.endif.endif:
  %.711.sroa.13.1 = phi i64 [ 0, %B0.endif.else.endif.endif.if ], [ %.740, %B0.endif.else.endif.endif ]
  %.748.not = icmp slt i64 %.740, %arg.run.5.6.5.0
  br i1 %.748.not, label %B0.endif.endif, label %B0.endif.else.endif.endif.endif.if, !prof !52
B0.endif.else.endif.endif.endif.if:
  br label %B0.endif.endif
}
declare double @llvm.cos.f64(double)
define i64 @integrate(ptr readonly %job) local_unnamed_addr {
  %.648.i.i = alloca i8, align 1
  %.1307.i.i = alloca { i64, double }, align 8
  %.1528.i.i = alloca ptr, align 8
  %.1113.i.i.i = alloca { i64, double }, align 8
  %.1313.i.i.i = alloca double, align 8
  %.1437.i.i.i = alloca ptr, align 8
  %.3776.i.i = alloca i8, align 1
  %.476.i.i = alloca [38 x i64], align 8
  %.2785.i = alloca i8, align 1
  call void @llvm.lifetime.start.p0(ptr nonnull %.2785.i)
  store i8 0, ptr %.2785.i, align 1, !noalias !53
  call void @llvm.lifetime.start.p0(ptr nonnull %.476.i.i), !noalias !53
  %.fca.1.gep.i.i = getelementptr inbounds i8, ptr %.476.i.i, i64 8
  %.fca.2.gep.i.i = getelementptr inbounds i8, ptr %.476.i.i, i64 16
  %.fca.3.gep.i.i = getelementptr inbounds i8, ptr %.476.i.i, i64 24
  %.fca.4.gep.i.i = getelementptr inbounds i8, ptr %.476.i.i, i64 32
  %.fca.5.gep.i.i = getelementptr inbounds i8, ptr %.476.i.i, i64 40
  %.fca.6.gep.i.i = getelementptr inbounds i8, ptr %.476.i.i, i64 48
  %.fca.7.gep.i.i = getelementptr inbounds i8, ptr %.476.i.i, i64 56
  %.fca.8.gep.i.i = getelementptr inbounds i8, ptr %.476.i.i, i64 64
  %.fca.9.gep.i.i = getelementptr inbounds i8, ptr %.476.i.i, i64 72
  %.fca.10.gep.i.i = getelementptr inbounds i8, ptr %.476.i.i, i64 80
  %.fca.11.gep.i.i = getelementptr inbounds i8, ptr %.476.i.i, i64 88
  %.fca.12.gep.i.i = getelementptr inbounds i8, ptr %.476.i.i, i64 96
  %.fca.13.gep.i.i = getelementptr inbounds i8, ptr %.476.i.i, i64 104
  %.fca.14.gep.i.i = getelementptr inbounds i8, ptr %.476.i.i, i64 112
  %.fca.15.gep.i.i = getelementptr inbounds i8, ptr %.476.i.i, i64 120
  %.fca.16.gep.i.i = getelementptr inbounds i8, ptr %.476.i.i, i64 128
  %.fca.17.gep.i.i = getelementptr inbounds i8, ptr %.476.i.i, i64 136
  %.fca.18.gep.i.i = getelementptr inbounds i8, ptr %.476.i.i, i64 144
  %.fca.19.gep.i.i = getelementptr inbounds i8, ptr %.476.i.i, i64 152
  %.fca.20.gep.i.i = getelementptr inbounds i8, ptr %.476.i.i, i64 160
  %.fca.21.gep.i.i = getelementptr inbounds i8, ptr %.476.i.i, i64 168
  %.fca.22.gep.i.i = getelementptr inbounds i8, ptr %.476.i.i, i64 176
  %.fca.23.gep.i.i = getelementptr inbounds i8, ptr %.476.i.i, i64 184
  %.fca.24.gep.i.i = getelementptr inbounds i8, ptr %.476.i.i, i64 192
  %.fca.25.gep.i.i = getelementptr inbounds i8, ptr %.476.i.i, i64 200
  %.fca.26.gep.i.i = getelementptr inbounds i8, ptr %.476.i.i, i64 208
  %.fca.27.gep.i.i = getelementptr inbounds i8, ptr %.476.i.i, i64 216
  %.fca.28.gep.i.i = getelementptr inbounds i8, ptr %.476.i.i, i64 224
  %.fca.29.gep.i.i = getelementptr inbounds i8, ptr %.476.i.i, i64 232
  %.fca.30.gep.i.i = getelementptr inbounds i8, ptr %.476.i.i, i64 240
  %.fca.31.gep.i.i = getelementptr inbounds i8, ptr %.476.i.i, i64 248
  %.fca.32.gep.i.i = getelementptr inbounds i8, ptr %.476.i.i, i64 256
  %.fca.33.gep.i.i = getelementptr inbounds i8, ptr %.476.i.i, i64 264
  %.fca.34.gep.i.i = getelementptr inbounds i8, ptr %.476.i.i, i64 272
  %.fca.35.gep.i.i = getelementptr inbounds i8, ptr %.476.i.i, i64 280
  %.fca.36.gep.i.i = getelementptr inbounds i8, ptr %.476.i.i, i64 288
  %.fca.37.gep.i.i = getelementptr inbounds i8, ptr %.476.i.i, i64 296
  br label %B38.if.i.i
B38.if.i.i:
  %out.2.sroa.0.0467.i.i = phi i64 [ undef, %0 ], [ %.481.fca.0.load.i.i, %B38.if.i.i ]
  %out.2.sroa.9.0466.i.i = phi i64 [ undef, %0 ], [ %.481.fca.1.load.i.i, %B38.if.i.i ]
  %out.2.sroa.18.0465.i.i = phi i64 [ undef, %0 ], [ %.481.fca.2.load.i.i, %B38.if.i.i ]
  %out.2.sroa.27.0464.i.i = phi i64 [ undef, %0 ], [ %.481.fca.3.load.i.i, %B38.if.i.i ]
  %out.2.sroa.36.0463.i.i = phi i64 [ undef, %0 ], [ %.481.fca.4.load.i.i, %B38.if.i.i ]
  %out.2.sroa.45.0462.i.i = phi i64 [ undef, %0 ], [ %.481.fca.5.load.i.i, %B38.if.i.i ]
  %out.2.sroa.54.0461.i.i = phi i64 [ undef, %0 ], [ %.481.fca.6.load.i.i, %B38.if.i.i ]
  %out.2.sroa.63.0460.i.i = phi i64 [ undef, %0 ], [ %.481.fca.7.load.i.i, %B38.if.i.i ]
  %out.2.sroa.72.0459.i.i = phi i64 [ undef, %0 ], [ %.481.fca.8.load.i.i, %B38.if.i.i ]
  %out.2.sroa.81.0458.i.i = phi i64 [ undef, %0 ], [ %.481.fca.9.load.i.i, %B38.if.i.i ]
  %out.2.sroa.90.0457.i.i = phi i64 [ undef, %0 ], [ %.481.fca.10.load.i.i, %B38.if.i.i ]
  %out.2.sroa.99.0456.i.i = phi i64 [ undef, %0 ], [ %.481.fca.11.load.i.i, %B38.if.i.i ]
  %out.2.sroa.108.0455.i.i = phi i64 [ undef, %0 ], [ %.481.fca.12.load.i.i, %B38.if.i.i ]
  %out.2.sroa.117.0454.i.i = phi i64 [ undef, %0 ], [ %.481.fca.13.load.i.i, %B38.if.i.i ]
  %out.2.sroa.126.0453.i.i = phi i64 [ undef, %0 ], [ %.481.fca.14.load.i.i, %B38.if.i.i ]
  %out.2.sroa.135.0452.i.i = phi i64 [ undef, %0 ], [ %.481.fca.15.load.i.i, %B38.if.i.i ]
  %out.2.sroa.144.0451.i.i = phi i64 [ undef, %0 ], [ %.481.fca.16.load.i.i, %B38.if.i.i ]
  %out.2.sroa.153.0450.i.i = phi i64 [ undef, %0 ], [ %.481.fca.17.load.i.i, %B38.if.i.i ]
  %out.2.sroa.162.0449.i.i = phi i64 [ undef, %0 ], [ %.481.fca.18.load.i.i, %B38.if.i.i ]
  %out.2.sroa.171.0448.i.i = phi i64 [ undef, %0 ], [ %.481.fca.19.load.i.i, %B38.if.i.i ]
  %out.2.sroa.180.0447.i.i = phi i64 [ undef, %0 ], [ %.481.fca.20.load.i.i, %B38.if.i.i ]
  %out.2.sroa.189.0446.i.i = phi i64 [ undef, %0 ], [ %.481.fca.21.load.i.i, %B38.if.i.i ]
  %out.2.sroa.198.0445.i.i = phi i64 [ undef, %0 ], [ %.481.fca.22.load.i.i, %B38.if.i.i ]
  %out.2.sroa.207.0444.i.i = phi i64 [ undef, %0 ], [ %.481.fca.23.load.i.i, %B38.if.i.i ]
  %out.2.sroa.216.0443.i.i = phi i64 [ undef, %0 ], [ %.481.fca.24.load.i.i, %B38.if.i.i ]
  %out.2.sroa.225.0442.i.i = phi i64 [ undef, %0 ], [ %.481.fca.25.load.i.i, %B38.if.i.i ]
  %out.2.sroa.234.0441.i.i = phi i64 [ undef, %0 ], [ %.481.fca.26.load.i.i, %B38.if.i.i ]
  %out.2.sroa.243.0440.i.i = phi i64 [ undef, %0 ], [ %.481.fca.27.load.i.i, %B38.if.i.i ]
  %out.2.sroa.252.0439.i.i = phi i64 [ undef, %0 ], [ %.481.fca.28.load.i.i, %B38.if.i.i ]
  %out.2.sroa.261.0438.i.i = phi i64 [ undef, %0 ], [ %.481.fca.29.load.i.i, %B38.if.i.i ]
  %out.2.sroa.270.0437.i.i = phi i64 [ undef, %0 ], [ %.481.fca.30.load.i.i, %B38.if.i.i ]
  %out.2.sroa.279.0436.i.i = phi i64 [ undef, %0 ], [ %.481.fca.31.load.i.i, %B38.if.i.i ]
  %out.2.sroa.288.0435.i.i = phi i64 [ undef, %0 ], [ %.481.fca.32.load.i.i, %B38.if.i.i ]
  %out.2.sroa.297.0434.i.i = phi i64 [ undef, %0 ], [ %.481.fca.33.load.i.i, %B38.if.i.i ]
  %out.2.sroa.306.0433.i.i = phi i64 [ undef, %0 ], [ %.481.fca.34.load.i.i, %B38.if.i.i ]
  %out.2.sroa.315.0432.i.i = phi i64 [ undef, %0 ], [ %.481.fca.35.load.i.i, %B38.if.i.i ]
  %out.2.sroa.324.0431.i.i = phi i64 [ undef, %0 ], [ %.481.fca.36.load.i.i, %B38.if.i.i ]
  %out.2.sroa.333.0430.i.i = phi i64 [ undef, %0 ], [ %.481.fca.37.load.i.i, %B38.if.i.i ]
  %.349.0428.i.i = phi i64 [ 0, %0 ], [ %.420.i.i, %B38.if.i.i ]
  %.420.i.i = add nuw nsw i64 %.349.0428.i.i, 1
  %1 = getelementptr i64, ptr %job, i64 %.349.0428.i.i
  %.474.i.i = load i64, ptr %1, align 8, !noalias !56
  store i64 %out.2.sroa.0.0467.i.i, ptr %.476.i.i, align 8, !noalias !56
  store i64 %out.2.sroa.9.0466.i.i, ptr %.fca.1.gep.i.i, align 8, !noalias !56
  store i64 %out.2.sroa.18.0465.i.i, ptr %.fca.2.gep.i.i, align 8, !noalias !56
  store i64 %out.2.sroa.27.0464.i.i, ptr %.fca.3.gep.i.i, align 8, !noalias !56
  store i64 %out.2.sroa.36.0463.i.i, ptr %.fca.4.gep.i.i, align 8, !noalias !56
  store i64 %out.2.sroa.45.0462.i.i, ptr %.fca.5.gep.i.i, align 8, !noalias !56
  store i64 %out.2.sroa.54.0461.i.i, ptr %.fca.6.gep.i.i, align 8, !noalias !56
  store i64 %out.2.sroa.63.0460.i.i, ptr %.fca.7.gep.i.i, align 8, !noalias !56
  store i64 %out.2.sroa.72.0459.i.i, ptr %.fca.8.gep.i.i, align 8, !noalias !56
  store i64 %out.2.sroa.81.0458.i.i, ptr %.fca.9.gep.i.i, align 8, !noalias !56
  store i64 %out.2.sroa.90.0457.i.i, ptr %.fca.10.gep.i.i, align 8, !noalias !56
  store i64 %out.2.sroa.99.0456.i.i, ptr %.fca.11.gep.i.i, align 8, !noalias !56
  store i64 %out.2.sroa.108.0455.i.i, ptr %.fca.12.gep.i.i, align 8, !noalias !56
  store i64 %out.2.sroa.117.0454.i.i, ptr %.fca.13.gep.i.i, align 8, !noalias !56
  store i64 %out.2.sroa.126.0453.i.i, ptr %.fca.14.gep.i.i, align 8, !noalias !56
  store i64 %out.2.sroa.135.0452.i.i, ptr %.fca.15.gep.i.i, align 8, !noalias !56
  store i64 %out.2.sroa.144.0451.i.i, ptr %.fca.16.gep.i.i, align 8, !noalias !56
  store i64 %out.2.sroa.153.0450.i.i, ptr %.fca.17.gep.i.i, align 8, !noalias !56
  store i64 %out.2.sroa.162.0449.i.i, ptr %.fca.18.gep.i.i, align 8, !noalias !56
  store i64 %out.2.sroa.171.0448.i.i, ptr %.fca.19.gep.i.i, align 8, !noalias !56
  store i64 %out.2.sroa.180.0447.i.i, ptr %.fca.20.gep.i.i, align 8, !noalias !56
  store i64 %out.2.sroa.189.0446.i.i, ptr %.fca.21.gep.i.i, align 8, !noalias !56
  store i64 %out.2.sroa.198.0445.i.i, ptr %.fca.22.gep.i.i, align 8, !noalias !56
  store i64 %out.2.sroa.207.0444.i.i, ptr %.fca.23.gep.i.i, align 8, !noalias !56
  store i64 %out.2.sroa.216.0443.i.i, ptr %.fca.24.gep.i.i, align 8, !noalias !56
  store i64 %out.2.sroa.225.0442.i.i, ptr %.fca.25.gep.i.i, align 8, !noalias !56
  store i64 %out.2.sroa.234.0441.i.i, ptr %.fca.26.gep.i.i, align 8, !noalias !56
  store i64 %out.2.sroa.243.0440.i.i, ptr %.fca.27.gep.i.i, align 8, !noalias !56
  store i64 %out.2.sroa.252.0439.i.i, ptr %.fca.28.gep.i.i, align 8, !noalias !56
  store i64 %out.2.sroa.261.0438.i.i, ptr %.fca.29.gep.i.i, align 8, !noalias !56
  store i64 %out.2.sroa.270.0437.i.i, ptr %.fca.30.gep.i.i, align 8, !noalias !56
  store i64 %out.2.sroa.279.0436.i.i, ptr %.fca.31.gep.i.i, align 8, !noalias !56
  store i64 %out.2.sroa.288.0435.i.i, ptr %.fca.32.gep.i.i, align 8, !noalias !56
  store i64 %out.2.sroa.297.0434.i.i, ptr %.fca.33.gep.i.i, align 8, !noalias !56
  store i64 %out.2.sroa.306.0433.i.i, ptr %.fca.34.gep.i.i, align 8, !noalias !56
  store i64 %out.2.sroa.315.0432.i.i, ptr %.fca.35.gep.i.i, align 8, !noalias !56
  store i64 %out.2.sroa.324.0431.i.i, ptr %.fca.36.gep.i.i, align 8, !noalias !56
  store i64 %out.2.sroa.333.0430.i.i, ptr %.fca.37.gep.i.i, align 8, !noalias !56
  %.479.i.i = getelementptr inbounds i64, ptr %.476.i.i, i64 %.349.0428.i.i
  store i64 %.474.i.i, ptr %.479.i.i, align 8, !noalias !56
  %.481.fca.0.load.i.i = load i64, ptr %.476.i.i, align 8, !noalias !56
  %.481.fca.1.load.i.i = load i64, ptr %.fca.1.gep.i.i, align 8, !noalias !56
  %.481.fca.2.load.i.i = load i64, ptr %.fca.2.gep.i.i, align 8, !noalias !56
  %.481.fca.3.load.i.i = load i64, ptr %.fca.3.gep.i.i, align 8, !noalias !56
  %.481.fca.4.load.i.i = load i64, ptr %.fca.4.gep.i.i, align 8, !noalias !56
  %.481.fca.5.load.i.i = load i64, ptr %.fca.5.gep.i.i, align 8, !noalias !56
  %.481.fca.6.load.i.i = load i64, ptr %.fca.6.gep.i.i, align 8, !noalias !56
  %.481.fca.7.load.i.i = load i64, ptr %.fca.7.gep.i.i, align 8, !noalias !56
  %.481.fca.8.load.i.i = load i64, ptr %.fca.8.gep.i.i, align 8, !noalias !56
  %.481.fca.9.load.i.i = load i64, ptr %.fca.9.gep.i.i, align 8, !noalias !56
  %.481.fca.10.load.i.i = load i64, ptr %.fca.10.gep.i.i, align 8, !noalias !56
  %.481.fca.11.load.i.i = load i64, ptr %.fca.11.gep.i.i, align 8, !noalias !56
  %.481.fca.12.load.i.i = load i64, ptr %.fca.12.gep.i.i, align 8, !noalias !56
  %.481.fca.13.load.i.i = load i64, ptr %.fca.13.gep.i.i, align 8, !noalias !56
  %.481.fca.14.load.i.i = load i64, ptr %.fca.14.gep.i.i, align 8, !noalias !56
  %.481.fca.15.load.i.i = load i64, ptr %.fca.15.gep.i.i, align 8, !noalias !56
  %.481.fca.16.load.i.i = load i64, ptr %.fca.16.gep.i.i, align 8, !noalias !56
  %.481.fca.17.load.i.i = load i64, ptr %.fca.17.gep.i.i, align 8, !noalias !56
  %.481.fca.18.load.i.i = load i64, ptr %.fca.18.gep.i.i, align 8, !noalias !56
  %.481.fca.19.load.i.i = load i64, ptr %.fca.19.gep.i.i, align 8, !noalias !56
  %.481.fca.20.load.i.i = load i64, ptr %.fca.20.gep.i.i, align 8, !noalias !56
  %.481.fca.21.load.i.i = load i64, ptr %.fca.21.gep.i.i, align 8, !noalias !56
  %.481.fca.22.load.i.i = load i64, ptr %.fca.22.gep.i.i, align 8, !noalias !56
  %.481.fca.23.load.i.i = load i64, ptr %.fca.23.gep.i.i, align 8, !noalias !56
  %.481.fca.24.load.i.i = load i64, ptr %.fca.24.gep.i.i, align 8, !noalias !56
  %.481.fca.25.load.i.i = load i64, ptr %.fca.25.gep.i.i, align 8, !noalias !56
  %.481.fca.26.load.i.i = load i64, ptr %.fca.26.gep.i.i, align 8, !noalias !56
  %.481.fca.27.load.i.i = load i64, ptr %.fca.27.gep.i.i, align 8, !noalias !56
  %.481.fca.28.load.i.i = load i64, ptr %.fca.28.gep.i.i, align 8, !noalias !56
  %.481.fca.29.load.i.i = load i64, ptr %.fca.29.gep.i.i, align 8, !noalias !56
  %.481.fca.30.load.i.i = load i64, ptr %.fca.30.gep.i.i, align 8, !noalias !56
  %.481.fca.31.load.i.i = load i64, ptr %.fca.31.gep.i.i, align 8, !noalias !56
  %.481.fca.32.load.i.i = load i64, ptr %.fca.32.gep.i.i, align 8, !noalias !56
  %.481.fca.33.load.i.i = load i64, ptr %.fca.33.gep.i.i, align 8, !noalias !56
  %.481.fca.34.load.i.i = load i64, ptr %.fca.34.gep.i.i, align 8, !noalias !56
  %.481.fca.35.load.i.i = load i64, ptr %.fca.35.gep.i.i, align 8, !noalias !56
  %.481.fca.36.load.i.i = load i64, ptr %.fca.36.gep.i.i, align 8, !noalias !56
  %.481.fca.37.load.i.i = load i64, ptr %.fca.37.gep.i.i, align 8, !noalias !56
  %exitcond.not.i.i = icmp eq i64 %.420.i.i, 38
  br i1 %exitcond.not.i.i, label %_ZN5numba2np6unsafe7ndarray14to_fixed_tuple12_3clocals_3e7codegen12_3clocals_3e4implB3v45B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi38EE.exit.i, label %B38.if.i.i
_ZN5numba2np6unsafe7ndarray14to_fixed_tuple12_3clocals_3e7codegen12_3clocals_3e4implB3v45B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi38EE.exit.i:
  call void @llvm.lifetime.end.p0(ptr nonnull %.476.i.i), !noalias !53
  %.163.i.i = add nsw i64 %.481.fca.10.load.i.i, %.481.fca.9.load.i.i
  %.297.i.i = mul nsw i64 %.481.fca.5.load.i.i, 12
  %.298.i.i = mul nsw i64 %.481.fca.7.load.i.i, 6
  %.299.i.i = add i64 %.481.fca.11.load.i.i, %.481.fca.10.load.i.i
  %.300.i.i = or i64 %.297.i.i, 2
  %.301.i.i = add i64 %.300.i.i, %.298.i.i
  %.302.i.i = add i64 %.301.i.i, %.481.fca.8.load.i.i
  %.307.i.i = add i64 %.302.i.i, %.299.i.i
  %.309.i.i = add nsw i64 %.307.i.i, %.481.fca.12.load.i.i
  %.311.i.i = add nsw i64 %.309.i.i, %.481.fca.13.load.i.i
  %.397.i.i = icmp slt i64 %.311.i.i, 1
  br i1 %.397.i.i, label %B0.endif.endif.endif.endif.else.endif.if.i.i, label %B0.endif.endif.endif.endif.else.endif.endif.i.i, !prof !36
B0.endif.endif.endif.endif.endif.i.i:
  %.377.sroa.13.0.i.i = phi i64 [ %.311.i.i, %B0.endif.endif.endif.endif.else.endif.endif.endif.if.i.i ], [ %.377.sroa.13.1.i.i, %B0.endif.endif.endif.endif.else.endif.endif.endif.i.i ]
  %.465.i.i = sub i64 %.377.sroa.13.0.i.i, %.377.sroa.0.3.i.i
  %.474.i5406.i = tail call i64 @llvm.smax.i64(i64 %.465.i.i, i64 0)
  br i1 %.409.i.i, label %B0.endif.endif.endif.endif.endif.else.if.i.i, label %B0.endif.endif.endif.endif.endif.else.endif.i.i, !prof !36
B0.endif.endif.endif.endif.else.endif.if.i.i:
  br label %B0.endif.endif.endif.endif.else.endif.endif.i.i
B0.endif.endif.endif.endif.else.endif.endif.i.i:
  %.377.sroa.0.3.i.i = phi i64 [ %.311.i.i, %B0.endif.endif.endif.endif.else.endif.if.i.i ], [ 0, %_ZN5numba2np6unsafe7ndarray14to_fixed_tuple12_3clocals_3e7codegen12_3clocals_3e4implB3v45B42c8tJTC_2fWQA93W1AaAIYBPIqRBFCjDSZRVAJmaQIAE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi38EE.exit.i ]
  %.404.i.i = icmp slt i64 %.481.fca.5.load.i.i, 0
  %.405.i.i = select i1 %.404.i.i, i64 %.311.i.i, i64 0
  %.406.i.i = add i64 %.405.i.i, %.297.i.i
  %.409.i.i = icmp slt i64 %.406.i.i, 0
  br i1 %.409.i.i, label %B0.endif.endif.endif.endif.else.endif.endif.if.i.i, label %B0.endif.endif.endif.endif.else.endif.endif.endif.i.i, !prof !36
B0.endif.endif.endif.endif.else.endif.endif.if.i.i:
  br label %B0.endif.endif.endif.endif.else.endif.endif.endif.i.i
B0.endif.endif.endif.endif.else.endif.endif.endif.i.i:
  %.377.sroa.13.1.i.i = phi i64 [ 0, %B0.endif.endif.endif.endif.else.endif.endif.if.i.i ], [ %.406.i.i, %B0.endif.endif.endif.endif.else.endif.endif.i.i ]
  %.414.not.i.i = icmp slt i64 %.406.i.i, %.311.i.i
  br i1 %.414.not.i.i, label %B0.endif.endif.endif.endif.endif.i.i, label %B0.endif.endif.endif.endif.else.endif.endif.endif.if.i.i, !prof !52
B0.endif.endif.endif.endif.else.endif.endif.endif.if.i.i:
  br label %B0.endif.endif.endif.endif.endif.i.i
B0.endif.endif.endif.endif.endif.else.if.i.i:
  br label %B0.endif.endif.endif.endif.endif.else.endif.i.i
B0.endif.endif.endif.endif.endif.else.endif.i.i:
  %.548.sroa.0.1.i.i = phi i64 [ 0, %B0.endif.endif.endif.endif.endif.else.if.i.i ], [ %.406.i.i, %B0.endif.endif.endif.endif.endif.i.i ]
  br i1 %.414.not.i.i, label %B0.endif.endif.endif.endi...if.i.i, label %B0.endif.endif.endif.endif.endif.else.endif.if.i.i, !prof !52
B0.endif.endif.endif.endif.endif.else.endif.if.i.i:
  br label %B0.endif.endif.endif.endi...if.i.i
B0.endif.endif.endif.endi...if.i.i:
  %.548.sroa.0.3.i.i = phi i64 [ %.311.i.i, %B0.endif.endif.endif.endif.endif.else.endif.if.i.i ], [ %.548.sroa.0.1.i.i, %B0.endif.endif.endif.endif.endif.else.endif.i.i ]
  %.636.i.i = sub i64 %.311.i.i, %.548.sroa.0.3.i.i
  %.645.i.i = tail call i64 @llvm.smax.i64(i64 %.636.i.i, i64 0)
  %.747.i.i = icmp slt i64 %.636.i.i, 1
  br i1 %.747.i.i, label %B0.endif.endif.endif.endif.endif.endif.else.endif.if.i.i, label %B0.endif.endif.endif.endif.endif.endif.else.endif.endif.i.i, !prof !36
B0.endif.endif.endif.endif.endif.endif.else.endif.if.i.i:
  br label %B0.endif.endif.endif.endif.endif.endif.else.endif.endif.i.i
B0.endif.endif.endif.endif.endif.endif.else.endif.endif.i.i:
  %.727.sroa.0.3.i.i = phi i64 [ %.645.i.i, %B0.endif.endif.endif.endif.endif.endif.else.endif.if.i.i ], [ 0, %B0.endif.endif.endif.endi...if.i.i ]
  %.754.i.i = icmp slt i64 %.481.fca.7.load.i.i, 0
  %.755.i.i = select i1 %.754.i.i, i64 %.645.i.i, i64 0
  %.756.i.i = add i64 %.755.i.i, %.481.fca.7.load.i.i
  %.759.i.i = icmp slt i64 %.756.i.i, 0
  br i1 %.759.i.i, label %B0.endif.endif.endif.endi...endif.4.i.i, label %B0.endif.endif.endif.endi...endif.2.thread.i.i, !prof !36
B0.endif.endif.endif.endi...endif.2.thread.i.i:
  %.764.not1965.i.i = icmp sgt i64 %.636.i.i, %.756.i.i
  br i1 %.764.not1965.i.i, label %B0.endif.endif.endif.endif.endif.endif.endif.else.endif.thread.i.i, label %B0.endif.endif.endif.endi...if.4.i.i, !prof !52
B0.endif.endif.endif.endif.endif.endif.endif.else.endif.thread.i.i:
  %.8151972.i.i = sub nsw i64 %.756.i.i, %.727.sroa.0.3.i.i
  %.8241973.i.i = tail call i64 @llvm.smax.i64(i64 %.8151972.i.i, i64 0)
  br label %B0.endif.endif.endif.endi...endif.4.i.i
B0.endif.endif.endif.endi...if.4.i.i:
  %.8151957.i.i = sub nsw i64 %.645.i.i, %.727.sroa.0.3.i.i
  %.8241958.i.i = tail call i64 @llvm.smax.i64(i64 %.8151957.i.i, i64 0)
  br label %B0.endif.endif.endif.endi...endif.4.i.i
B0.endif.endif.endif.endi...endif.4.i.i:
  %.82419612000.i.i = phi i64 [ %.8241958.i.i, %B0.endif.endif.endif.endi...if.4.i.i ], [ %.8241973.i.i, %B0.endif.endif.endif.endif.endif.endif.endif.else.endif.thread.i.i ], [ 0, %B0.endif.endif.endif.endif.endif.endif.else.endif.endif.i.i ]
  %.898.sroa.0.3.i.i = phi i64 [ %.645.i.i, %B0.endif.endif.endif.endi...if.4.i.i ], [ %.756.i.i, %B0.endif.endif.endif.endif.endif.endif.endif.else.endif.thread.i.i ], [ 0, %B0.endif.endif.endif.endif.endif.endif.else.endif.endif.i.i ]
  %.87219631998.i.i = mul nsw i64 %.481.fca.7.load.i.i, 5
  %.927.i.i = add i64 %.755.i.i, %.87219631998.i.i
  %.930.i.i = icmp slt i64 %.927.i.i, 0
  br i1 %.930.i.i, label %B0.endif.endif.endif.endi...endif.6.endif.i.i, label %B0.endif.endif.endif.endi...endif.4.endif.thread.i.i, !prof !36
B0.endif.endif.endif.endi...endif.4.endif.thread.i.i:
  %.935.not1983.i.i = icmp sgt i64 %.636.i.i, %.927.i.i
  br i1 %.935.not1983.i.i, label %B0.endif.endif.endif.endi...endif.6.thread.i.i, label %B0.endif.endif.endif.endi...endif.6.if.i.i, !prof !52
B0.endif.endif.endif.endi...endif.6.thread.i.i:
  %.9861990.i.i = sub nsw i64 %.927.i.i, %.898.sroa.0.3.i.i
  %.9951991.i.i = tail call i64 @llvm.smax.i64(i64 %.9861990.i.i, i64 0)
  br label %B0.endif.endif.endif.endi...endif.6.endif.i.i
B0.endif.endif.endif.endi...endif.6.if.i.i:
  %.9861977.i.i = sub nsw i64 %.645.i.i, %.898.sroa.0.3.i.i
  %.9951978.i.i = tail call i64 @llvm.smax.i64(i64 %.9861977.i.i, i64 0)
  br label %B0.endif.endif.endif.endi...endif.6.endif.i.i
B0.endif.endif.endif.endi...endif.6.endif.i.i:
  %.99519802032.i.i = phi i64 [ %.9951978.i.i, %B0.endif.endif.endif.endi...endif.6.if.i.i ], [ %.9951991.i.i, %B0.endif.endif.endif.endi...endif.6.thread.i.i ], [ 0, %B0.endif.endif.endif.endi...endif.4.i.i ]
  %.1070.sroa.0.3.i.i = phi i64 [ %.645.i.i, %B0.endif.endif.endif.endi...endif.6.if.i.i ], [ %.927.i.i, %B0.endif.endif.endif.endi...endif.6.thread.i.i ], [ 0, %B0.endif.endif.endif.endi...endif.4.i.i ]
  %.1099.i.i = add i64 %.755.i.i, %.298.i.i
  %.1102.i.i = icmp slt i64 %.1099.i.i, 0
  br i1 %.1102.i.i, label %B0.endif.endif.endif.endi...else.endif.endif.endif.if.i.i, label %B0.endif.endif.endif.endi...endif.6.endif.endif.thread.i.i, !prof !36
B0.endif.endif.endif.endi...endif.6.endif.endif.thread.i.i:
  %.1107.not2017.i.i = icmp sgt i64 %.636.i.i, %.1099.i.i
  br i1 %.1107.not2017.i.i, label %B0.endif.endif.endif.endi...else.endif.thread.i.i, label %B0.endif.endif.endif.endi...else.endif.if.i.i, !prof !52
B0.endif.endif.endif.endi...else.endif.thread.i.i:
  %.11582024.i.i = sub nsw i64 %.1099.i.i, %.1070.sroa.0.3.i.i
  %.11672025.i.i = tail call i64 @llvm.smax.i64(i64 %.11582024.i.i, i64 0)
  br label %B0.endif.endif.endif.endi...else.endif.endif.endif.if.i.i
B0.endif.endif.endif.endi...else.endif.if.i.i:
  %.11582011.i.i = sub nsw i64 %.645.i.i, %.1070.sroa.0.3.i.i
  %.11672012.i.i = tail call i64 @llvm.smax.i64(i64 %.11582011.i.i, i64 0)
  br label %B0.endif.endif.endif.endi...else.endif.endif.endif.if.i.i
B0.endif.endif.endif.endi...else.endif.endif.endif.if.i.i:
  %.116720142045.i.i = phi i64 [ %.11672012.i.i, %B0.endif.endif.endif.endi...else.endif.if.i.i ], [ %.11672025.i.i, %B0.endif.endif.endif.endi...else.endif.thread.i.i ], [ 0, %B0.endif.endif.endif.endi...endif.6.endif.i.i ]
  %.1241.sroa.0.3.i.i = phi i64 [ %.645.i.i, %B0.endif.endif.endif.endi...else.endif.if.i.i ], [ %.1099.i.i, %B0.endif.endif.endif.endi...else.endif.thread.i.i ], [ 0, %B0.endif.endif.endif.endi...endif.6.endif.i.i ]
  %.1329.i.i = sub nsw i64 %.645.i.i, %.1241.sroa.0.3.i.i
  %.1338.i.i = tail call i64 @llvm.smax.i64(i64 %.1329.i.i, i64 0)
  %2 = tail call i64 @llvm.umin.i64(i64 %.1338.i.i, i64 2)
  %.16802062.i.i = add nsw i64 %.481.fca.12.load.i.i, 2
  %.1733.i.i = icmp slt i64 %.481.fca.12.load.i.i, -2
  %.1734.i.i = select i1 %.1733.i.i, i64 %.1338.i.i, i64 0
  %.1735.i.i = add i64 %.16802062.i.i, %.1734.i.i
  %.1738.i.i = icmp slt i64 %.1735.i.i, 0
  %.1743.not2071.i.i = icmp sgt i64 %.1329.i.i, %.1735.i.i
  %.1735.i.i..1338.i.i = select i1 %.1743.not2071.i.i, i64 %.1735.i.i, i64 %.1338.i.i, !prof !52
  %.1878.sroa.0.3.i.i = select i1 %.1738.i.i, i64 0, i64 %.1735.i.i..1338.i.i, !prof !36
  %.1966.i.i = sub nsw i64 %.1338.i.i, %.1878.sroa.0.3.i.i
  %.1975.i.i = tail call i64 @llvm.smax.i64(i64 %.1966.i.i, i64 0)
  %.2084.i.i = icmp slt i64 %.1966.i.i, 1
  br i1 %.2084.i.i, label %B0.endif.endif.endif.endi...else.1.endif.if.i.i, label %B0.endif.endif.endif.endi...else.1.endif.endif.i.i, !prof !36
B0.endif.endif.endif.endi...else.1.endif.if.i.i:
  br label %B0.endif.endif.endif.endi...else.1.endif.endif.i.i
B0.endif.endif.endif.endi...else.1.endif.endif.i.i:
  %.2064.sroa.0.3.i.i = phi i64 [ %.1975.i.i, %B0.endif.endif.endif.endi...else.1.endif.if.i.i ], [ 0, %B0.endif.endif.endif.endi...else.endif.endif.endif.if.i.i ]
  %.2091.i.i = icmp slt i64 %.481.fca.13.load.i.i, 0
  %.2092.i.i = select i1 %.2091.i.i, i64 %.1975.i.i, i64 0
  %.2093.i.i = add i64 %.2092.i.i, %.481.fca.13.load.i.i
  %.2096.i.i = icmp slt i64 %.2093.i.i, 0
  %.2101.not2094.i.i = icmp sgt i64 %.1966.i.i, %.2093.i.i
  %.2093.i.i..1975.i.i = select i1 %.2101.not2094.i.i, i64 %.2093.i.i, i64 %.1975.i.i, !prof !52
  %.2235.sroa.0.3.i.i = select i1 %.2096.i.i, i64 0, i64 %.2093.i.i..1975.i.i, !prof !36
  %.2323.i.i = sub nsw i64 %.1975.i.i, %.2235.sroa.0.3.i.i
  %.2332.i.i = tail call i64 @llvm.smax.i64(i64 %.2323.i.i, i64 0)
  %.2434.i.i = icmp slt i64 %.2323.i.i, 1
  br i1 %.2434.i.i, label %B0.endif.endif.endif.endi...if.20.i.i, label %B0.endif.endif.endif.endi...endif.20.i.i, !prof !36
B0.endif.endif.endif.endi...if.20.i.i:
  br label %B0.endif.endif.endif.endi...endif.20.i.i
B0.endif.endif.endif.endi...endif.20.i.i:
  %.2414.sroa.0.3.i.i = phi i64 [ %.2332.i.i, %B0.endif.endif.endif.endi...if.20.i.i ], [ 0, %B0.endif.endif.endif.endi...else.1.endif.endif.i.i ]
  %.2441.i.i = icmp slt i64 %.481.fca.11.load.i.i, 0
  %.2442.i.i = select i1 %.2441.i.i, i64 %.2332.i.i, i64 0
  %.2443.i.i = add i64 %.2442.i.i, %.481.fca.11.load.i.i
  %.2446.i.i = icmp slt i64 %.2443.i.i, 0
  br i1 %.2446.i.i, label %B0.endif.endif.endif.endi...endif.22.endif.i.i, label %B0.endif.endif.endif.endi...endif.20.endif.thread.i.i, !prof !36
B0.endif.endif.endif.endi...endif.20.endif.thread.i.i:
  %.2451.not2126.i.i = icmp sgt i64 %.2323.i.i, %.2443.i.i
  br i1 %.2451.not2126.i.i, label %B0.endif.endif.endif.endi...endif.22.thread.i.i, label %B0.endif.endif.endif.endi...endif.22.if.i.i, !prof !52
B0.endif.endif.endif.endi...endif.22.thread.i.i:
  %.25022133.i.i = sub nsw i64 %.2443.i.i, %.2414.sroa.0.3.i.i
  %.25112134.i.i = tail call i64 @llvm.smax.i64(i64 %.25022133.i.i, i64 0)
  br label %B0.endif.endif.endif.endi...endif.22.endif.i.i
B0.endif.endif.endif.endi...endif.22.if.i.i:
  %.25022118.i.i = sub nsw i64 %.2332.i.i, %.2414.sroa.0.3.i.i
  %.25112119.i.i = tail call i64 @llvm.smax.i64(i64 %.25022118.i.i, i64 0)
  br label %B0.endif.endif.endif.endi...endif.22.endif.i.i
B0.endif.endif.endif.endi...endif.22.endif.i.i:
  %.251121222161.i.i = phi i64 [ %.25112119.i.i, %B0.endif.endif.endif.endi...endif.22.if.i.i ], [ %.25112134.i.i, %B0.endif.endif.endif.endi...endif.22.thread.i.i ], [ 0, %B0.endif.endif.endif.endi...endif.20.i.i ]
  %.2585.sroa.0.3.i.i = phi i64 [ %.2332.i.i, %B0.endif.endif.endif.endi...endif.22.if.i.i ], [ %.2443.i.i, %B0.endif.endif.endif.endi...endif.22.thread.i.i ], [ 0, %B0.endif.endif.endif.endi...endif.20.i.i ]
  %.2612.i.i = icmp slt i64 %.299.i.i, 0
  %.2613.i.i = select i1 %.2612.i.i, i64 %.2332.i.i, i64 0
  %.2614.i.i = add i64 %.2613.i.i, %.299.i.i
  %.2617.i.i = icmp slt i64 %.2614.i.i, 0
  %.2622.not2144.i.i = icmp sgt i64 %.2323.i.i, %.2614.i.i
  %.2614.i.i..2332.i.i = select i1 %.2622.not2144.i.i, i64 %.2614.i.i, i64 %.2332.i.i, !prof !52
  %.2756.sroa.0.3.i.i = select i1 %.2617.i.i, i64 0, i64 %.2614.i.i..2332.i.i, !prof !36
  %.2961.i.i = icmp slt i64 %.465.i.i, 1
  br i1 %.2961.i.i, label %B0.endif.endif.endif.endi...endif.24.else.endif.if.i.i, label %B0.endif.endif.endif.endi...endif.24.else.endif.endif.i.i, !prof !36
B0.endif.endif.endif.endi...endif.24.else.endif.if.i.i:
  br label %B0.endif.endif.endif.endi...endif.24.else.endif.endif.i.i
B0.endif.endif.endif.endi...endif.24.else.endif.endif.i.i:
  %.2941.sroa.0.3.i.i = phi i64 [ %.474.i5406.i, %B0.endif.endif.endif.endi...endif.24.else.endif.if.i.i ], [ 0, %B0.endif.endif.endif.endi...endif.22.endif.i.i ]
  %.2969.i.i = select i1 %.404.i.i, i64 %.474.i5406.i, i64 0
  %.2970.i.i = add i64 %.2969.i.i, %.481.fca.5.load.i.i
  %.2973.i.i = icmp slt i64 %.2970.i.i, 0
  %.2978.not2193.i.i = icmp sgt i64 %.465.i.i, %.2970.i.i
  %.2970.i.i..474.i5406.i = select i1 %.2978.not2193.i.i, i64 %.2970.i.i, i64 %.474.i5406.i, !prof !52
  %.3112.sroa.0.3.i.i = select i1 %.2973.i.i, i64 0, i64 %.2970.i.i..474.i5406.i, !prof !36
  %.308621912209.i.i = shl nsw i64 %.481.fca.5.load.i.i, 1
  %.3141.i.i = add i64 %.2969.i.i, %.308621912209.i.i
  %.3144.i.i = icmp slt i64 %.3141.i.i, 0
  br i1 %.3144.i.i, label %B0.endif.endif.endif.endi...endif.29.if.i.i, label %B0.endif.endif.endif.endi...endif.29.endif.i.i, !prof !36
B0.endif.endif.endif.endi...endif.24.endif.endif.i.i:
  %.3112.sroa.13.0.i.i = phi i64 [ %.474.i5406.i, %B0.endif.endif.endif.endi...endif.29.endif.if.i.i ], [ %.3112.sroa.13.1.i.i, %B0.endif.endif.endif.endi...endif.29.endif.i.i ]
  %.3257.i.i = mul nsw i64 %.481.fca.5.load.i.i, 6
  %.3295.i.i = add i64 %.2969.i.i, %.3257.i.i
  %.3298.i.i = icmp slt i64 %.3295.i.i, 0
  br i1 %.3298.i.i, label %B0.endif.endif.endif.endi...if.31.i.i, label %B0.endif.endif.endif.endi...endif.31.i.i, !prof !36
B0.endif.endif.endif.endi...endif.29.if.i.i:
  br label %B0.endif.endif.endif.endi...endif.29.endif.i.i
B0.endif.endif.endif.endi...endif.29.endif.i.i:
  %.3112.sroa.13.1.i.i = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.29.if.i.i ], [ %.3141.i.i, %B0.endif.endif.endif.endi...endif.24.else.endif.endif.i.i ]
  %.3149.not.i.i = icmp slt i64 %.3141.i.i, %.474.i5406.i
  br i1 %.3149.not.i.i, label %B0.endif.endif.endif.endi...endif.24.endif.endif.i.i, label %B0.endif.endif.endif.endi...endif.29.endif.if.i.i, !prof !52
B0.endif.endif.endif.endi...endif.29.endif.if.i.i:
  br label %B0.endif.endif.endif.endi...endif.24.endif.endif.i.i
B0.endif.endif.endif.endi...if.31.i.i:
  br label %B0.endif.endif.endif.endi...endif.31.i.i
B0.endif.endif.endif.endi...endif.31.i.i:
  %.3283.sroa.0.1.i.i = phi i64 [ 0, %B0.endif.endif.endif.endi...if.31.i.i ], [ %.3295.i.i, %B0.endif.endif.endif.endi...endif.24.endif.endif.i.i ]
  %.3303.not.i.i = icmp slt i64 %.3295.i.i, %.474.i5406.i
  br i1 %.3303.not.i.i, label %B0.endif.endif.endif.endi...endif.31.endif.endif.if.i.i, label %B0.endif.endif.endif.endi...endif.31.if.i.i, !prof !52
B0.endif.endif.endif.endi...endif.31.if.i.i:
  br label %B0.endif.endif.endif.endi...endif.31.endif.endif.if.i.i
B0.endif.endif.endif.endi...endif.31.endif.endif.if.i.i:
  %.3283.sroa.0.3.i.i = phi i64 [ %.474.i5406.i, %B0.endif.endif.endif.endi...endif.31.if.i.i ], [ %.3283.sroa.0.1.i.i, %B0.endif.endif.endif.endi...endif.31.i.i ]
  %.3428.i.i = mul nsw i64 %.481.fca.5.load.i.i, 11
  %.3466.i.i = add i64 %.2969.i.i, %.3428.i.i
  %.3469.i.i = icmp slt i64 %.3466.i.i, 0
  br i1 %.3469.i.i, label %B0.endif.endif.endif.endi...else.3.if.i.i, label %B0.endif.endif.endif.endi...else.3.endif.i.i, !prof !36
B0.endif.endif.endif.endi...else.3.if.i.i:
  br label %B0.endif.endif.endif.endi...else.3.endif.i.i
B0.endif.endif.endif.endi...else.3.endif.i.i:
  %.3454.sroa.0.1.i.i = phi i64 [ 0, %B0.endif.endif.endif.endi...else.3.if.i.i ], [ %.3466.i.i, %B0.endif.endif.endif.endi...endif.31.endif.endif.if.i.i ]
  %.3474.not.i.i = icmp slt i64 %.3466.i.i, %.474.i5406.i
  br i1 %.3474.not.i.i, label %B0.endif.endif.endif.endi...if.34.i.i, label %B0.endif.endif.endif.endi...else.3.endif.if.i.i, !prof !52
B0.endif.endif.endif.endi...else.3.endif.if.i.i:
  br label %B0.endif.endif.endif.endi...if.34.i.i
B0.endif.endif.endif.endi...if.34.i.i:
  %.3454.sroa.0.3.i.i = phi i64 [ %.474.i5406.i, %B0.endif.endif.endif.endi...else.3.endif.if.i.i ], [ %.3454.sroa.0.1.i.i, %B0.endif.endif.endif.endi...else.3.endif.i.i ]
  %.3600.i.i = mul nsw i64 %.481.fca.5.load.i.i, 3
  br i1 %.3144.i.i, label %B0.endif.endif.endif.endi...endif.33.else.if.i.i, label %B0.endif.endif.endif.endi...endif.33.else.endif.i.i, !prof !36
B0.endif.endif.endif.endi...endif.33.else.if.i.i:
  br label %B0.endif.endif.endif.endi...endif.33.else.endif.i.i
B0.endif.endif.endif.endi...endif.33.else.endif.i.i:
  %.3626.sroa.0.1.i.i = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.33.else.if.i.i ], [ %.3141.i.i, %B0.endif.endif.endif.endi...if.34.i.i ]
  br i1 %.3149.not.i.i, label %B0.endif.endif.endif.endi...endif.33.else.endif.endif.i.i, label %B0.endif.endif.endif.endi...endif.33.else.endif.if.i.i, !prof !52
B0.endif.endif.endif.endi...endif.33.else.endif.if.i.i:
  br label %B0.endif.endif.endif.endi...endif.33.else.endif.endif.i.i
B0.endif.endif.endif.endi...endif.33.else.endif.endif.i.i:
  %.3626.sroa.0.3.i.i = phi i64 [ %.474.i5406.i, %B0.endif.endif.endif.endi...endif.33.else.endif.if.i.i ], [ %.3626.sroa.0.1.i.i, %B0.endif.endif.endif.endi...endif.33.else.endif.i.i ]
  %.3655.i.i = add i64 %.2969.i.i, %.3600.i.i
  %.3658.i.i = icmp slt i64 %.3655.i.i, 0
  %.3663.not.i.i = icmp slt i64 %.3655.i.i, %.474.i5406.i
  %.3771.i.i = shl nsw i64 %.481.fca.5.load.i.i, 2
  %.3810.i.i = add i64 %.2969.i.i, %.3771.i.i
  %.3813.i.i = icmp slt i64 %.3810.i.i, 0
  br i1 %.3813.i.i, label %B0.endif.endif.endif.endi...endif.33.endif.else.if.i.i, label %B0.endif.endif.endif.endi...endif.33.endif.else.endif.i.i, !prof !36
B0.endif.endif.endif.endi...endif.33.endif.endif.i.i:
  %.3798.sroa.13.0.i.i = phi i64 [ %.474.i5406.i, %B0.endif.endif.endif.endi...endif.38.endif.if.i.i ], [ %.3798.sroa.13.1.i.i, %B0.endif.endif.endif.endi...endif.38.endif.i.i ]
  br i1 %.3658.i.i, label %B0.endif.endif.endif.endi...if.40.i.i, label %B0.endif.endif.endif.endi...endif.40.i.i, !prof !36
B0.endif.endif.endif.endi...endif.33.endif.else.if.i.i:
  br label %B0.endif.endif.endif.endi...endif.33.endif.else.endif.i.i
B0.endif.endif.endif.endi...endif.33.endif.else.endif.i.i:
  %.3798.sroa.0.1.i.i = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.33.endif.else.if.i.i ], [ %.3810.i.i, %B0.endif.endif.endif.endi...endif.33.else.endif.endif.i.i ]
  %.3818.not.i.i = icmp slt i64 %.3810.i.i, %.474.i5406.i
  br i1 %.3818.not.i.i, label %B0.endif.endif.endif.endi...endif.38.i.i, label %B0.endif.endif.endif.endi...if.38.i.i, !prof !52
B0.endif.endif.endif.endi...if.38.i.i:
  br label %B0.endif.endif.endif.endi...endif.38.i.i
B0.endif.endif.endif.endi...endif.38.i.i:
  %.3798.sroa.0.3.i.i = phi i64 [ %.474.i5406.i, %B0.endif.endif.endif.endi...if.38.i.i ], [ %.3798.sroa.0.1.i.i, %B0.endif.endif.endif.endi...endif.33.endif.else.endif.i.i ]
  br i1 %.3298.i.i, label %B0.endif.endif.endif.endi...endif.38.if.i.i, label %B0.endif.endif.endif.endi...endif.38.endif.i.i, !prof !36
B0.endif.endif.endif.endi...endif.38.if.i.i:
  br label %B0.endif.endif.endif.endi...endif.38.endif.i.i
B0.endif.endif.endif.endi...endif.38.endif.i.i:
  %.3798.sroa.13.1.i.i = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.38.if.i.i ], [ %.3295.i.i, %B0.endif.endif.endif.endi...endif.38.i.i ]
  br i1 %.3303.not.i.i, label %B0.endif.endif.endif.endi...endif.33.endif.endif.i.i, label %B0.endif.endif.endif.endi...endif.38.endif.if.i.i, !prof !52
B0.endif.endif.endif.endi...endif.38.endif.if.i.i:
  br label %B0.endif.endif.endif.endi...endif.33.endif.endif.i.i
B0.endif.endif.endif.endi...endif.33.endif.endif.endif.i.i:
  %.3970.sroa.13.0.i.i = phi i64 [ %.474.i5406.i, %B0.endif.endif.endif.endi...endif.40.endif.endif.if.i.i ], [ %.3970.sroa.13.1.i.i, %B0.endif.endif.endif.endi...endif.40.endif.endif.i.i ]
  %.4273.i.i = icmp slt i64 %.481.fca.9.load.i.i, 0
  %.4274.i.i = select i1 %.4273.i.i, i64 %.163.i.i, i64 0
  %.4275.i.i = add i64 %.4274.i.i, %.481.fca.9.load.i.i
  %.4278.i.i = icmp slt i64 %.4275.i.i, 0
  br i1 %.4278.i.i, label %B0.endif.endif.endif.endi...else.4.if.i.i, label %B0.endif.endif.endif.endi...else.4.endif.i.i, !prof !36
B0.endif.endif.endif.endi...if.40.i.i:
  br label %B0.endif.endif.endif.endi...endif.40.i.i
B0.endif.endif.endif.endi...endif.40.i.i:
  %.3970.sroa.0.1.i.i = phi i64 [ 0, %B0.endif.endif.endif.endi...if.40.i.i ], [ %.3655.i.i, %B0.endif.endif.endif.endi...endif.33.endif.endif.i.i ]
  br i1 %.3663.not.i.i, label %B0.endif.endif.endif.endi...endif.40.endif.i.i, label %B0.endif.endif.endif.endi...endif.40.if.i.i, !prof !52
B0.endif.endif.endif.endi...endif.40.if.i.i:
  br label %B0.endif.endif.endif.endi...endif.40.endif.i.i
B0.endif.endif.endif.endi...endif.40.endif.i.i:
  %.3970.sroa.0.3.i.i = phi i64 [ %.474.i5406.i, %B0.endif.endif.endif.endi...endif.40.if.i.i ], [ %.3970.sroa.0.1.i.i, %B0.endif.endif.endif.endi...endif.40.i.i ]
  br i1 %.3813.i.i, label %B0.endif.endif.endif.endi...endif.40.endif.if.i.i, label %B0.endif.endif.endif.endi...endif.40.endif.endif.i.i, !prof !36
B0.endif.endif.endif.endi...endif.40.endif.if.i.i:
  br label %B0.endif.endif.endif.endi...endif.40.endif.endif.i.i
B0.endif.endif.endif.endi...endif.40.endif.endif.i.i:
  %.3970.sroa.13.1.i.i = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.40.endif.if.i.i ], [ %.3810.i.i, %B0.endif.endif.endif.endi...endif.40.endif.i.i ]
  br i1 %.3818.not.i.i, label %B0.endif.endif.endif.endi...endif.33.endif.endif.endif.i.i, label %B0.endif.endif.endif.endi...endif.40.endif.endif.if.i.i, !prof !52
B0.endif.endif.endif.endi...endif.40.endif.endif.if.i.i:
  br label %B0.endif.endif.endif.endi...endif.33.endif.endif.endif.i.i
B0.endif.endif.endif.endi...else.4.if.i.i:
  br label %B0.endif.endif.endif.endi...else.4.endif.i.i
B0.endif.endif.endif.endi...else.4.endif.i.i:
  %.4263.sroa.0.1.i.i = phi i64 [ 0, %B0.endif.endif.endif.endi...else.4.if.i.i ], [ %.4275.i.i, %B0.endif.endif.endif.endi...endif.33.endif.endif.endif.i.i ]
  %.4283.not.i.i = icmp slt i64 %.4275.i.i, %.163.i.i
  br i1 %.4283.not.i.i, label %_ZN6poppet6engine10integrator7_run_ofB2v3B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE23Job_28int64_20x_2038_29.exit.i, label %B0.endif.endif.endif.endi...else.4.endif.if.i.i, !prof !52
B0.endif.endif.endif.endi...else.4.endif.if.i.i:
  br label %_ZN6poppet6engine10integrator7_run_ofB2v3B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE23Job_28int64_20x_2038_29.exit.i
_ZN6poppet6engine10integrator7_run_ofB2v3B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE23Job_28int64_20x_2038_29.exit.i:
  %.4263.sroa.0.3.i.i = phi i64 [ %.163.i.i, %B0.endif.endif.endif.endi...else.4.endif.if.i.i ], [ %.4263.sroa.0.1.i.i, %B0.endif.endif.endif.endi...else.4.endif.i.i ]
  %.304.i.i = mul nsw i64 %.481.fca.6.load.i.i, 24
  %.305.i.i = add nsw i64 %.481.fca.36.load.i.i, %.304.i.i
  %.306.i.i = inttoptr i64 %.305.i.i to ptr
  %.490.i.i = getelementptr double, ptr %.306.i.i, i64 %.377.sroa.0.3.i.i
  %.4083.i.i = getelementptr double, ptr %.490.i.i, i64 %.3970.sroa.0.3.i.i
  %.4058.i.i = sub nsw i64 %.3970.sroa.13.0.i.i, %.3970.sroa.0.3.i.i
  %.4067.i.i = tail call i64 @llvm.smax.i64(i64 %.4058.i.i, i64 0)
  %.3911.i.i = getelementptr double, ptr %.490.i.i, i64 %.3798.sroa.0.3.i.i
  %.3886.i.i = sub nsw i64 %.3798.sroa.13.0.i.i, %.3798.sroa.0.3.i.i
  %.3895.i.i = tail call i64 @llvm.smax.i64(i64 %.3886.i.i, i64 0)
  %.3739.i.i = getelementptr double, ptr %.490.i.i, i64 %.3626.sroa.0.3.i.i
  %.3567.i.i = getelementptr double, ptr %.490.i.i, i64 %.3454.sroa.0.3.i.i
  %.3396.i.i = getelementptr double, ptr %.490.i.i, i64 %.3283.sroa.0.3.i.i
  %.3225.i.i = getelementptr double, ptr %.490.i.i, i64 %.3112.sroa.0.3.i.i
  %.3200.i.i = sub nsw i64 %.3112.sroa.13.0.i.i, %.3112.sroa.0.3.i.i
  %.3209.i.i = tail call i64 @llvm.smax.i64(i64 %.3200.i.i, i64 0)
  %.305421902210.i.i = getelementptr double, ptr %.490.i.i, i64 %.2941.sroa.0.3.i.i
  %.661.i.i = getelementptr double, ptr %.306.i.i, i64 %.548.sroa.0.3.i.i
  %.1354.i.i = getelementptr double, ptr %.661.i.i, i64 %.1241.sroa.0.3.i.i
  %.1991.i.i = getelementptr double, ptr %.1354.i.i, i64 %.1878.sroa.0.3.i.i
  %.2348.i.i = getelementptr double, ptr %.1991.i.i, i64 %.2235.sroa.0.3.i.i
  %.2869.i.i = getelementptr double, ptr %.2348.i.i, i64 %.2756.sroa.0.3.i.i
  %.2844.i.i = sub nsw i64 %.2332.i.i, %.2756.sroa.0.3.i.i
  %.2853.i.i = tail call i64 @llvm.smax.i64(i64 %.2844.i.i, i64 0)
  %.269821422175.i.i = getelementptr double, ptr %.2348.i.i, i64 %.2585.sroa.0.3.i.i
  %.252721232160.i.i = getelementptr double, ptr %.2348.i.i, i64 %.2414.sroa.0.3.i.i
  %.217720922108.i.i = getelementptr double, ptr %.1991.i.i, i64 %.2064.sroa.0.3.i.i
  %.181920692085.i.i = getelementptr double, ptr %.1354.i.i, i64 %2
  %.118320152044.i.i = getelementptr double, ptr %.661.i.i, i64 %.1070.sroa.0.3.i.i
  %.101119812031.i.i = getelementptr double, ptr %.661.i.i, i64 %.898.sroa.0.3.i.i
  %.84019621999.i.i = getelementptr double, ptr %.661.i.i, i64 %.727.sroa.0.3.i.i
  %.249.i.i = inttoptr i64 %.481.fca.36.load.i.i to ptr
  %.206.i.i = inttoptr i64 %.481.fca.29.load.i.i to ptr
  %.161.i.i = inttoptr i64 %.481.fca.23.load.i.i to ptr
  %.4351.i.i = sub i64 %.163.i.i, %.4263.sroa.0.3.i.i
  %.4360.i.i = tail call i64 @llvm.smax.i64(i64 %.4351.i.i, i64 0)
  %.4376.i.i = getelementptr double, ptr %.161.i.i, i64 %.4263.sroa.0.3.i.i
  %.4409.i.i = inttoptr i64 %.481.fca.16.load.i.i to ptr
  %.4485.i.i = inttoptr i64 %.481.fca.15.load.i.i to ptr
  %.4553.i.i = load double, ptr %.206.i.i, align 8, !noalias !53
  %.4581.i.i = getelementptr i8, ptr %.206.i.i, i64 8
  %.4582.i.i = load double, ptr %.4581.i.i, align 8, !noalias !53
  %.4584.i.i = inttoptr i64 %.481.fca.37.load.i.i to ptr
  %.4652.i.i = getelementptr i8, ptr %.206.i.i, i64 16
  %.4653.i.i = load double, ptr %.4652.i.i, align 8, !noalias !53
  %.4657.i.i = fcmp ogt double %.4653.i.i, 0.000000e+00
  %.4687.i.i = inttoptr i64 %.481.fca.28.load.i.i to ptr
  %.4729.i.i = inttoptr i64 %.481.fca.32.load.i.i to ptr
  %.4804.i.i = inttoptr i64 %.481.fca.30.load.i.i to ptr
  %.4854.i.i = inttoptr i64 %.481.fca.31.load.i.i to ptr
  %.4926.i.i = inttoptr i64 %.481.fca.22.load.i.i to ptr
  %.4967.i.i = inttoptr i64 %.481.fca.33.load.i.i to ptr
  %.5009.i.i = inttoptr i64 %.481.fca.34.load.i.i to ptr
  %.5090.i.i = inttoptr i64 %.481.fca.35.load.i.i to ptr
  %.1025.i = inttoptr i64 %.481.fca.24.load.i.i to ptr
  %.1068.i = inttoptr i64 %.481.fca.27.load.i.i to ptr
  %.1129.i = inttoptr i64 %.481.fca.25.load.i.i to ptr
  %.1178.i = inttoptr i64 %.481.fca.26.load.i.i to ptr
  %.1292.i = inttoptr i64 %.481.fca.14.load.i.i to ptr
  %.1390.i = getelementptr i8, ptr %.206.i.i, i64 24
  %.1391.i = load double, ptr %.1390.i, align 8, !noalias !53
  %.1392.i = fcmp ogt double %.1391.i, 0.000000e+00
  br i1 %.1392.i, label %B744.i, label %B852.i
B744.i:
  %.193303.not.i.i = icmp slt i64 %.481.fca.6.load.i.i, 1
  br i1 %.193303.not.i.i, label %_ZN6poppet6engine8stepping14set_tolerancesB3v13B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE158Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_295ArrayIdLi2E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B56.if.lr.ph.i.i
B56.if.lr.ph.i.i:
  %.idx.i.i = shl i64 %.481.fca.6.load.i.i, 4
  %3 = getelementptr i8, ptr %.1292.i, i64 %.idx.i.i
  %.383.i.i = fmul double %.1391.i, 2.500000e-01
  %4 = getelementptr double, ptr %.1292.i, i64 %.481.fca.6.load.i.i
  %5 = getelementptr double, ptr %.249.i.i, i64 %.481.fca.6.load.i.i
  %6 = getelementptr i8, ptr %.249.i.i, i64 %.idx.i.i
  br label %B56.if.i.i
B140.i.i:
  %.265.i.i = tail call double @llvm.fabs.f64(double %.264.i.i)
  br label %B162.i.i
B144.i.i:
  %7 = getelementptr double, ptr %3, i64 %.135.0304.i.i
  %.375.i.i = load double, ptr %7, align 8, !noalias !59
  br label %B162.i.i
B162.i.i:
  %"$phi162.1.2.1.i.i" = phi double [ %.265.i.i, %B140.i.i ], [ %.375.i.i, %B144.i.i ]
  %.437.i.i = getelementptr double, ptr %.1292.i, i64 %.135.0304.i.i
  %.438.i.i = load double, ptr %.437.i.i, align 8, !noalias !59
  %.439.i.i = fmul double %.383.i.i, %.438.i.i
  %.499.i.i = getelementptr double, ptr %.249.i.i, i64 %.135.0304.i.i
  store double %.439.i.i, ptr %.499.i.i, align 8, !noalias !59
  %.625.i.i = getelementptr double, ptr %4, i64 %.135.0304.i.i
  %.626.i.i = load double, ptr %.625.i.i, align 8, !noalias !59
  %.627.i.i = fmul double %.439.i.i, %.626.i.i
  %.628.i.i = fmul double %"$phi162.1.2.1.i.i", %.627.i.i
  %.688.i.i = getelementptr double, ptr %5, i64 %.135.0304.i.i
  store double %.628.i.i, ptr %.688.i.i, align 8, !noalias !59
  %.756.i5438.i = getelementptr double, ptr %6, i64 %.135.0304.i.i
  store double %"$phi162.1.2.1.i.i", ptr %.756.i5438.i, align 8, !noalias !59
  %exitcond.not.i5439.i = icmp eq i64 %.206.i5436.i, %.481.fca.6.load.i.i
  br i1 %exitcond.not.i5439.i, label %_ZN6poppet6engine8stepping14set_tolerancesB3v13B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE158Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_295ArrayIdLi2E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B56.if.i.i
B56.if.i.i:
  %.135.0304.i.i = phi i64 [ 0, %B56.if.lr.ph.i.i ], [ %.206.i5436.i, %B162.i.i ]
  %.206.i5436.i = add nuw nsw i64 %.135.0304.i.i, 1
  %8 = getelementptr double, ptr %.4926.i.i, i64 %.135.0304.i.i
  %.264.i.i = load double, ptr %8, align 8, !noalias !59
  %9 = getelementptr i8, ptr %.4485.i.i, i64 %.135.0304.i.i
  %.303.i.i = load i8, ptr %9, align 1, !noalias !59
  %.307.i5437.i = icmp ne i8 %.303.i.i, 0
  %.310.i.i = fcmp one double %.264.i.i, 0.000000e+00
  %or.cond.i.i = select i1 %.307.i5437.i, i1 %.310.i.i, i1 false
  br i1 %or.cond.i.i, label %B140.i.i, label %B144.i.i
_ZN6poppet6engine8stepping14set_tolerancesB3v13B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE158Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_295ArrayIdLi2E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE.exit.i:
  %.1645.i = getelementptr i8, ptr %.1354.i.i, i64 8
  store double 0.000000e+00, ptr %.1645.i, align 8, !noalias !53
  br label %B852.i
B852.i:
  %.17435578.not.i = icmp slt i64 %.481.fca.5.load.i.i, 1
  br i1 %.17435578.not.i, label %B1012.i, label %B882.if.preheader.i
B882.if.preheader.i:
  %invariant.gep.i = getelementptr double, ptr %.4967.i.i, i64 %.481.fca.5.load.i.i
  %invariant.gep5666.i = getelementptr double, ptr %.4967.i.i, i64 %.308621912209.i.i
  br label %B882.if.i
B1012.i:
  %.2004.i = getelementptr i8, ptr %.5090.i.i, i64 24
  store i64 -1, ptr %.2004.i, align 8, !noalias !53
  %.2173.i = getelementptr i8, ptr %.1354.i.i, i64 8
  %.2174.i = load double, ptr %.2173.i, align 8, !noalias !53
  %.2264.i = mul i64 %.481.fca.7.load.i.i, 7
  %.24555581.not.i = icmp slt i64 %.481.fca.17.load.i.i, 1
  br i1 %.24555581.not.i, label %B1012.B1792_crit_edge.i, label %B1188.if.lr.ph.i
B1012.B1792_crit_edge.i:
  %.2216.i = load i64, ptr %.1129.i, align 8, !noalias !53
  %.2240.i = icmp slt i64 %.2216.i, 0
  %.2241.i = select i1 %.2240.i, i64 %.481.fca.18.load.i.i, i64 0
  %.2242.i = add i64 %.2241.i, %.2216.i
  %.2266.i = mul i64 %.2242.i, %.2264.i
  %.2268.i = getelementptr double, ptr %.1178.i, i64 %.2266.i
  %.2035.i = load double, ptr %.1025.i, align 8, !noalias !53
  %.pre.i = add nsw i64 %.481.fca.19.load.i.i, -1
  br label %B1792.i
B1188.if.lr.ph.i:
  %10 = getelementptr double, ptr %.4687.i.i, i64 %.481.fca.19.load.i.i
  %.2619.i = getelementptr i8, ptr %10, i64 -8
  %.2775.i = icmp sgt i64 %.481.fca.11.load.i.i, 0
  %.2917.i = icmp sgt i64 %.481.fca.20.load.i.i, 0
  %.148211.not.i.i.i.i = icmp eq i64 %.82419612000.i.i, 0
  %.992.i.i.i = inttoptr i64 %.481.fca.3.load.i.i to ptr
  %.3272.i = icmp sgt i64 %.481.fca.5.load.i.i, 0
  %.fca.1.gep.i5481.i = getelementptr inbounds i8, ptr %.1307.i.i, i64 8
  %.636.i5483.not.i = icmp eq i64 %.251121222161.i.i, 0
  %.980.i.i = getelementptr i8, ptr %.5090.i.i, i64 16
  %.996.i.i = add i64 %.481.fca.19.load.i.i, -1
  %11 = add i64 %.481.fca.19.load.i.i, -2
  %.1415.i.i = icmp ne i64 %.251121222161.i.i, 0
  %spec.select.i.i.i = tail call i64 @llvm.smax.i64(i64 %.481.fca.7.load.i.i, i64 0)
  %.1553.i.i = icmp sgt i64 %.481.fca.21.load.i.i, 0
  %.148231.not.i.i.i.i = icmp eq i64 %.116720142045.i.i, 0
  %.822.i.i.i = inttoptr i64 %.481.fca.0.load.i.i to ptr
  %.585727.not.i.i.i.i = icmp slt i64 %.481.fca.6.load.i.i, 1
  %.idx.i.i.i.i = shl i64 %.481.fca.6.load.i.i, 4
  %12 = getelementptr i8, ptr %.249.i.i, i64 %.idx.i.i.i.i
  %.26.i.i.i = add nsw i64 %.481.fca.21.load.i.i, -1
  %.2529.i.i = inttoptr i64 %.481.fca.1.load.i.i to ptr
  %13 = getelementptr double, ptr %.249.i.i, i64 %.481.fca.6.load.i.i
  %.2704.i.i = getelementptr i8, ptr %.5090.i.i, i64 8
  %.fca.1.gep.i.i.i = getelementptr inbounds i8, ptr %.1113.i.i.i, i64 8
  %.10933044.i.i.i = inttoptr i64 %.481.fca.2.load.i.i to ptr
  %.idx.i.i6066.i.i = shl i64 %.481.fca.5.load.i.i, 4
  %invariant.gep.i.i.i.i = getelementptr i8, ptr %.4967.i.i, i64 %.idx.i.i6066.i.i
  %invariant.gep853.i.i.i.i = getelementptr double, ptr %.4967.i.i, i64 %.481.fca.5.load.i.i
  %.704.i.i.i = getelementptr i8, ptr %.5090.i.i, i64 32
  %.1283.i.i.i = getelementptr i8, ptr %.5009.i.i, i64 8
  br label %B1188.if.i
B1186.i:
  %h.4.15627.i = phi double [ %h.10.1.sink.i.ph5637.i, %B1718.thread5638.i ], [ %"$phi1566.1.2.1.i", %_ZN6poppet6engine10integrator15_without_statesB3v43B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c ]
  %t.5.15626.i = phi double [ %t.4.1.sink.i.ph5636.i, %B1718.thread5638.i ], [ %t.3.1.i5482.i, %_ZN6poppet6engine10integrator15_without_statesB3v43B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c ]
  %exitcond5621.not.i = icmp eq i64 %.2468.i, %.481.fca.17.load.i.i
  br i1 %exitcond5621.not.i, label %B1792.i, label %B1188.if.i
B1340.i:
  store i8 0, ptr %.2785.i, align 1, !noalias !53
  call fastcc void @v45(ptr %.2785.i, i64 %.481.fca.4.load.i.i, ptr %.161.i.i, i64 %.4360.i.i, ptr %.4376.i.i, ptr %.4409.i.i, i64 %.251121222161.i.i, ptr %.252721232160.i.i, ptr %.269821422175.i.i, i64 %.82419612000.i.i, ptr %.84019621999.i.i, ptr %.1354.i.i, ptr %.2706.i, i64 7, double %.2539.i, ptr %.4926.i.i)
  br label %B1396.i
B1396.i:
  br i1 %.2917.i, label %B1418.i, label %B1542.i
B1418.i:
  br i1 %.148211.not.i.i.i.i, label %_ZN6poppet6engine8stepping10outputs_atB3v21B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_, label %B58.if.i.i.i.i
B164.i.i.i.i:
  %.44.i.i.i.i.i = getelementptr i8, ptr %15, i64 24
  %.45.i.i.i.i.i = load double, ptr %.44.i.i.i.i.i, align 8, !noalias !62
  %.73.i.i.i.i.i = getelementptr i8, ptr %15, i64 32
  %.74.i.i.i.i.i = load double, ptr %.73.i.i.i.i.i, align 8, !noalias !62
  %.75.i.i.i.i.i = fmul double %.74.i.i.i.i.i, 5.000000e-01
  %.76.i.i.i.i.i = fmul double %.245.i.i.i.i, %.75.i.i.i.i.i
  %.77.i.i.i.i.i = fadd double %.45.i.i.i.i.i, %.76.i.i.i.i.i
  %.78.i.i.i.i.i = fmul double %.245.i.i.i.i, %.77.i.i.i.i.i
  %.87.le.i.i.i.i.i = tail call double @llvm.floor.f64(double %.78.i.i.i.i.i)
  %.92.i.i.i.i.i = fsub double %.78.i.i.i.i.i, %.87.le.i.i.i.i.i
  %.93.i.i.i.i.i = fmul double %.92.i.i.i.i.i, 0x401921FB54442D18
  %.121.i.i.i.i.i = getelementptr i8, ptr %15, i64 40
  %.122.i.i.i.i.i = load double, ptr %.121.i.i.i.i.i, align 8, !noalias !62
  %.126.i.i.i.i.i = fadd double %.122.i.i.i.i.i, %.93.i.i.i.i.i
  %.593.le.i.i.i.i = tail call double @llvm.sin.f64(double %.126.i.i.i.i.i)
  %.598.i.i.i.i = fmul double %.423.i.i.i.i, %.593.le.i.i.i.i
  %.600.i.i.i.i = fadd double %.361.i.i.i.i, %.598.i.i.i.i
  br label %B272.i.i.i.i
B272.i.i.i.i:
  %value.2.1.i.i.i.i = phi double [ %.600.i.i.i.i, %B164.i.i.i.i ], [ %.361.i.i.i.i, %B58.if.i.i.i.i ]
  %14 = getelementptr double, ptr %.84019621999.i.i, i64 %.90.0213.i.i.i.i
  store double %value.2.1.i.i.i.i, ptr %14, align 8, !noalias !71
  %exitcond.not.i.i.i.i = icmp eq i64 %.82419612000.i.i, %.161.i.i.i.i
  br i1 %exitcond.not.i.i.i.i, label %_ZN6poppet6engine8stepping10outputs_atB3v21B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_, label %B58.if.i.i.i.i
B58.if.i.i.i.i:
  %.90.0213.i.i.i.i = phi i64 [ %.161.i.i.i.i, %B272.i.i.i.i ], [ 0, %B1418.i ]
  %.161.i.i.i.i = add nuw nsw i64 %.90.0213.i.i.i.i, 1
  %.idx.i = mul i64 %.90.0213.i.i.i.i, 56
  %15 = getelementptr i8, ptr %.2706.i, i64 %.idx.i
  %.242.i.i.i.i = getelementptr i8, ptr %15, i64 48
  %.243.i.i.i.i = load double, ptr %.242.i.i.i.i, align 8, !noalias !71
  %.245.i.i.i.i = fsub double %.2539.i, %.243.i.i.i.i
  %.303.i.i.i.i = load double, ptr %15, align 8, !noalias !71
  %.357.i.i.i.i = getelementptr i8, ptr %15, i64 8
  %.358.i.i.i.i = load double, ptr %.357.i.i.i.i, align 8, !noalias !71
  %.360.i.i.i.i = fmul double %.245.i.i.i.i, %.358.i.i.i.i
  %.361.i.i.i.i = fadd double %.303.i.i.i.i, %.360.i.i.i.i
  %.422.i.i.i.i = getelementptr i8, ptr %15, i64 16
  %.423.i.i.i.i = load double, ptr %.422.i.i.i.i, align 8, !noalias !71
  %.424.i.i.i.i = fcmp une double %.423.i.i.i.i, 0.000000e+00
  br i1 %.424.i.i.i.i, label %B164.i.i.i.i, label %B272.i.i.i.i
_ZN6poppet6engine8stepping10outputs_atB3v21B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_:
  store double %.2539.i, ptr %.1354.i.i, align 8, !noalias !72
  tail call void %.992.i.i.i(ptr nonnull %.1354.i.i, ptr %.4926.i.i, ptr %.84019621999.i.i, ptr %.161.i.i, ptr %.2869.i.i), !noalias !72
  br label %B140.i5440.i
B140.i5440.i:
  %.859.0.i.i = phi i64 [ 0, %_ZN6poppet6engine8stepping10outputs_atB3v21B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_ ], [ %.928.i.i, %B288.i.i ]
  %exitcond294.not.i.i = icmp eq i64 %.859.0.i.i, %.481.fca.20.load.i.i
  br i1 %exitcond294.not.i.i, label %_ZN6poppet6engine8stepping14stop_conditionB3v20B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c5536, label %B142.i.i
_ZN6poppet6engine8stepping14stop_conditionB3v20B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c5536:
  store i64 -1, ptr %.2004.i, align 8, !noalias !53
  br label %B1542.i
B142.i.i:
  %.idx5557.i = mul i64 %.859.0.i.i, 24
  %16 = getelementptr i8, ptr %.4854.i.i, i64 %.idx5557.i
  %.1009.i.i = getelementptr i8, ptr %16, i64 16
  %.1010.i.i = load double, ptr %.1009.i.i, align 8, !noalias !73
  %.idx5558.i = shl i64 %.859.0.i.i, 4
  %17 = getelementptr i8, ptr %.4804.i.i, i64 %.idx5558.i
  br label %B194.if.i.i
B226.i.i:
  %18 = getelementptr double, ptr %16, i64 %.1037.0289.i.i
  %.1249.i.i = load double, ptr %18, align 8, !noalias !73
  %.1338.i5442.i = getelementptr double, ptr %.2869.i.i, i64 %.1191.i.i
  %.1339.i.i = load double, ptr %.1338.i5442.i, align 8, !noalias !73
  %.1340.i.i = fmul double %.1249.i.i, %.1339.i.i
  %.1342.i.i = fadd double %value.2.1291.i.i, %.1340.i.i
  br label %B286.i.i
B286.i.i:
  %value.3.2.i.i = phi double [ %.1342.i.i, %B226.i.i ], [ %value.2.1291.i.i, %B194.if.i.i ]
  br i1 %exitcond.not.i5441.i, label %B288.i.i, label %B194.if.i.i
B288.i.i:
  %.928.i.i = add nuw i64 %.859.0.i.i, 1
  %.1361.i.i = fcmp ogt double %value.3.2.i.i, 0.000000e+00
  br i1 %.1361.i.i, label %_ZN6poppet6engine8stepping14stop_conditionB3v20B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C, label %B140.i5440.i
B194.if.i.i:
  %value.2.1291.i.i = phi double [ %.1010.i.i, %B142.i.i ], [ %value.3.2.i.i, %B286.i.i ]
  %exitcond.not.i5441.i = phi i1 [ false, %B142.i.i ], [ true, %B286.i.i ]
  %.1037.0289.i.i = phi i64 [ 0, %B142.i.i ], [ 1, %B286.i.i ]
  %19 = getelementptr i64, ptr %17, i64 %.1037.0289.i.i
  %.1191.i.i = load i64, ptr %19, align 8, !noalias !73
  %.1194.i.i = icmp sgt i64 %.1191.i.i, -1
  br i1 %.1194.i.i, label %B226.i.i, label %B286.i.i
_ZN6poppet6engine8stepping14stop_conditionB3v20B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C:
  store i64 %.859.0.i.i, ptr %.2004.i, align 8, !noalias !53
  br label %B1792.i
B1542.i:
  %20 = getelementptr i8, ptr %.1068.i, i64 %.2361.05582.i
  %.3246.i = load i8, ptr %20, align 1, !noalias !53
  %.3249.not.i = icmp eq i8 %.3246.i, 0
  %.3252.i = fneg double %h.3.05584.i
  %"$phi1566.1.2.1.i" = select i1 %.3249.not.i, double %h.3.05584.i, double %.3252.i
  br i1 %.3272.i, label %B1580.i, label %B1624.i
B1580.i:
  call void @llvm.lifetime.start.p0(ptr nonnull %.3776.i.i), !noalias !53
  br label %B66.i.i.i
B66.i.i.i:
  %.75.0.i.i.i = phi i64 [ 0, %B1580.i ], [ %.146.i.i.i, %B108.i.i.i ]
  %exitcond.not.i.i.i = icmp eq i64 %.75.0.i.i.i, %spec.select.i.i.i
  br i1 %exitcond.not.i.i.i, label %_ZN6poppet6engine8stepping6variesB3v23B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE72Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_29.exit.i.i, label %B66.if.i.i.i
B108.i.i.i:
  %.146.i.i.i = add nuw i64 %.75.0.i.i.i, 1
  %.303.i.i.i = getelementptr i8, ptr %21, i64 16
  %.304.i.i.i = load double, ptr %.303.i.i.i, align 8, !noalias !74
  %.310.i.i.i = fcmp une double %.304.i.i.i, 0.000000e+00
  br i1 %.310.i.i.i, label %_ZN6poppet6engine8stepping6variesB3v23B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE72Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_29.exit.i.i, label %B66.i.i.i
B66.if.i.i.i:
  %.idx5559.i = mul i64 %.75.0.i.i.i, 56
  %21 = getelementptr i8, ptr %.2706.i, i64 %.idx5559.i
  %.233.i.i.i = getelementptr i8, ptr %21, i64 8
  %.234.i.i.i = load double, ptr %.233.i.i.i, align 8, !noalias !74
  %.240.i.i.i = fcmp une double %.234.i.i.i, 0.000000e+00
  br i1 %.240.i.i.i, label %_ZN6poppet6engine8stepping6variesB3v23B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE72Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_29.exit.i.i, label %B108.i.i.i
_ZN6poppet6engine8stepping6variesB3v23B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE72Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_29.exit.i.i:
  %.748.i.i.i = fadd double %.2539.i, 0.000000e+00
  br label %switch.end.else.endif.i.i.i
switch.end.endif.i.i.i:
  %.889.sroa.13.0.i.i.i = phi i64 [ %.99519802032.i.i, %switch.end.else.endif.endif.endif.if.i.i.i ], [ %.863.i.i.i, %switch.end.else.endif.endif.endif.i.i.i ]
  %.977.i.i.i = sub nsw i64 %.889.sroa.13.0.i.i.i, %.889.sroa.0.3.i.i.i
  %.1002.i.i.i = getelementptr double, ptr %.101119812031.i.i, i64 %.889.sroa.0.3.i.i.i
  %.148211.not.i.i.i5443.i = icmp slt i64 %.977.i.i.i, 1
  br i1 %.148211.not.i.i.i5443.i, label %_ZN6poppet6engine8stepping9inputs_atB3v18B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd72Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_295ArrayIdLi1E1C7mutable7alignedE.exit.i.i.i, label %B58.if.i.i.i5444.i
B164.i.i.i5463.i:
  %.44.i.i.i.i5464.i = getelementptr i8, ptr %23, i64 24
  %.45.i.i.i.i5465.i = load double, ptr %.44.i.i.i.i5464.i, align 8, !noalias !79
  %.73.i.i.i.i5466.i = getelementptr i8, ptr %23, i64 32
  %.74.i.i.i.i5467.i = load double, ptr %.73.i.i.i.i5466.i, align 8, !noalias !79
  %.75.i.i.i.i5468.i = fmul double %.74.i.i.i.i5467.i, 5.000000e-01
  %.76.i.i.i.i5469.i = fmul double %.245.i.i.i5450.i, %.75.i.i.i.i5468.i
  %.77.i.i.i.i5470.i = fadd double %.45.i.i.i.i5465.i, %.76.i.i.i.i5469.i
  %.78.i.i.i.i5471.i = fmul double %.245.i.i.i5450.i, %.77.i.i.i.i5470.i
  %.87.le.i.i.i.i5472.i = tail call double @llvm.floor.f64(double %.78.i.i.i.i5471.i)
  %.92.i.i.i.i5473.i = fsub double %.78.i.i.i.i5471.i, %.87.le.i.i.i.i5472.i
  %.93.i.i.i.i5474.i = fmul double %.92.i.i.i.i5473.i, 0x401921FB54442D18
  %.121.i.i.i.i5475.i = getelementptr i8, ptr %23, i64 40
  %.122.i.i.i.i5476.i = load double, ptr %.121.i.i.i.i5475.i, align 8, !noalias !79
  %.126.i.i.i.i5477.i = fadd double %.122.i.i.i.i5476.i, %.93.i.i.i.i5474.i
  %.593.le.i.i.i5478.i = tail call double @llvm.sin.f64(double %.126.i.i.i.i5477.i)
  %.598.i.i.i5479.i = fmul double %.423.i.i.i5457.i, %.593.le.i.i.i5478.i
  %.600.i.i.i5480.i = fadd double %.361.i.i.i5455.i, %.598.i.i.i5479.i
  br label %B272.i.i.i5459.i
B272.i.i.i5459.i:
  %value.2.1.i.i.i5460.i = phi double [ %.600.i.i.i5480.i, %B164.i.i.i5463.i ], [ %.361.i.i.i5455.i, %B58.if.i.i.i5444.i ]
  %22 = getelementptr double, ptr %.1002.i.i.i, i64 %.90.0213.i.i.i5445.i
  store double %value.2.1.i.i.i5460.i, ptr %22, align 8, !noalias !86
  %exitcond.not.i.i.i5461.i = icmp eq i64 %.977.i.i.i, %.161.i.i.i5446.i
  br i1 %exitcond.not.i.i.i5461.i, label %_ZN6poppet6engine8stepping9inputs_atB3v18B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd72Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_295ArrayIdLi1E1C7mutable7alignedE.exit.i.i.i, label %B58.if.i.i.i5444.i
B58.if.i.i.i5444.i:
  %.90.0213.i.i.i5445.i = phi i64 [ %.161.i.i.i5446.i, %B272.i.i.i5459.i ], [ 0, %switch.end.endif.i.i.i ]
  %.161.i.i.i5446.i = add nuw nsw i64 %.90.0213.i.i.i5445.i, 1
  %.idx5560.i = mul i64 %.90.0213.i.i.i5445.i, 56
  %23 = getelementptr i8, ptr %.2706.i, i64 %.idx5560.i
  %.242.i.i.i5448.i = getelementptr i8, ptr %23, i64 48
  %.243.i.i.i5449.i = load double, ptr %.242.i.i.i5448.i, align 8, !noalias !86
  %.245.i.i.i5450.i = fsub double %.748.i.i.i, %.243.i.i.i5449.i
  %.303.i.i.i5451.i = load double, ptr %23, align 8, !noalias !86
  %.357.i.i.i5452.i = getelementptr i8, ptr %23, i64 8
  %.358.i.i.i5453.i = load double, ptr %.357.i.i.i5452.i, align 8, !noalias !86
  %.360.i.i.i5454.i = fmul double %.245.i.i.i5450.i, %.358.i.i.i5453.i
  %.361.i.i.i5455.i = fadd double %.303.i.i.i5451.i, %.360.i.i.i5454.i
  %.422.i.i.i5456.i = getelementptr i8, ptr %23, i64 16
  %.423.i.i.i5457.i = load double, ptr %.422.i.i.i5456.i, align 8, !noalias !86
  %.424.i.i.i5458.i = fcmp une double %.423.i.i.i5457.i, 0.000000e+00
  br i1 %.424.i.i.i5458.i, label %B164.i.i.i5463.i, label %B272.i.i.i5459.i
_ZN6poppet6engine8stepping9inputs_atB3v18B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd72Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_295ArrayIdLi1E1C7mutable7alignedE.exit.i.i.i:
  %exitcond.not.i5936.i.i = icmp eq i64 %.687.i.i.i, 4
  br i1 %exitcond.not.i5936.i.i, label %_ZN6poppet6engine8stepping12stage_inputsB3v24B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_2, label %switch.end.else.endif.i.i.i
switch.end.else.endif.i.i.i:
  %.616.0584.i.i.i = phi i64 [ 0, %_ZN6poppet6engine8stepping6variesB3v23B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE72Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_29.exit.i.i ], [ %.687.i.i.i, %_ZN6poppet6engine8stepping9inputs_atB3v18B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd72Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_295ArrayIdLi1E1C7mutable7alignedE.exit.i.i.i ]
  %.687.i.i.i = add nuw nsw i64 %.616.0584.i.i.i, 1
  %.863.i.i.i = mul nuw nsw i64 %.687.i.i.i, %.82419612000.i.i
  %.860.i.i.i = mul nuw nsw i64 %.616.0584.i.i.i, %.82419612000.i.i
  %.909.not.i.i.i = icmp ult i64 %.860.i.i.i, %.99519802032.i.i
  br i1 %.909.not.i.i.i, label %switch.end.else.endif.endif.endif.i.i.i, label %switch.end.else.endif.if.i.i.i, !prof !52
switch.end.else.endif.if.i.i.i:
  br label %switch.end.else.endif.endif.endif.i.i.i
switch.end.else.endif.endif.endif.i.i.i:
  %.889.sroa.0.3.i.i.i = phi i64 [ %.99519802032.i.i, %switch.end.else.endif.if.i.i.i ], [ %.860.i.i.i, %switch.end.else.endif.i.i.i ]
  %.926.not.i.i.i = icmp ult i64 %.863.i.i.i, %.99519802032.i.i
  br i1 %.926.not.i.i.i, label %switch.end.endif.i.i.i, label %switch.end.else.endif.endif.endif.if.i.i.i, !prof !52
switch.end.else.endif.endif.endif.if.i.i.i:
  br label %switch.end.endif.i.i.i
_ZN6poppet6engine8stepping12stage_inputsB3v24B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_2:
  %.1790.i.i = fcmp olt double %.2539.i, %"$phi1276.4.2.1.i"
  br i1 %.1790.i.i, label %B396.preheader.i.i, label %B1718.thread5638.i
B396.preheader.i.i:
  %.1586.i.i = fcmp ogt double %.2539.i, 0.000000e+00
  %"$phi322.3.2.0.i.i" = select i1 %.1415.i.i, i1 true, i1 %.1586.i.i
  %.5.i.i.i.i = fmul double %"$phi1276.4.2.1.i", 0x3D06849B86A12B9B
  %.6.i.i.i.i = fadd double %.5.i.i.i.i, 1.000000e-15
  %.818.i.i.i = fsub double %"$phi1276.4.2.1.i", %.6.i.i.i.i
  br label %B396.i.i
B396.i.i:
  %h.6.0.i.i = phi double [ %h.7.1.i.i, %B2126.i.i ], [ %"$phi1566.1.2.1.i", %B396.preheader.i.i ]
  %t.2.0.i.i = phi double [ %t.3.1.i.i, %B2126.i.i ], [ %.2539.i, %B396.preheader.i.i ]
  %error_before.2.0.i.i = phi double [ %error_before.3.1.i.i, %B2126.i.i ], [ 1.000000e-02, %B396.preheader.i.i ]
  %step_before.3.0.i.i = phi double [ %step_before.4.1.i.i, %B2126.i.i ], [ 0.000000e+00, %B396.preheader.i.i ]
  %rejected.3.0.i.i = phi i1 [ %rejected.4.1.i.i, %B2126.i.i ], [ false, %B396.preheader.i.i ]
  %fresh.3.0.i.i = phi i1 [ %fresh.4.1.i.i, %B2126.i.i ], [ true, %B396.preheader.i.i ]
  %window.2.0.i.i = phi double [ %window.3.1.i.i, %B2126.i.i ], [ %.2539.i, %B396.preheader.i.i ]
  %calm.2.0.i.i = phi double [ %calm.3.1.i.i, %B2126.i.i ], [ %.2539.i, %B396.preheader.i.i ]
  %first.3.0.i.i = phi double [ %first.4.1.i.i, %B2126.i.i ], [ 0.000000e+00, %B396.preheader.i.i ]
  %has_changed.3.0.i.i = phi i1 [ %has_changed.4.1.i.i, %B2126.i.i ], [ true, %B396.preheader.i.i ]
  %has_acted.5.0.i.i = phi i1 [ %has_acted.6.1.i.i, %B2126.i.i ], [ %"$phi322.3.2.0.i.i", %B396.preheader.i.i ]
  br i1 %fresh.3.0.i.i, label %B400.i.i, label %B450.i.i
B400.i.i:
  store double %t.2.0.i.i, ptr %.1354.i.i, align 8, !noalias !87
  br i1 %.148211.not.i.i.i.i, label %_ZN6poppet6engine8stepping9inputs_atB3v18B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd72Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_295ArrayIdLi1E1C7mutable7alignedE.exit.i5956.i.i, label %B58.if.i.i5938.i.i
B164.i.i5957.i.i:
  %.44.i.i.i5958.i.i = getelementptr i8, ptr %25, i64 24
  %.45.i.i.i5959.i.i = load double, ptr %.44.i.i.i5958.i.i, align 8, !noalias !90
  %.73.i.i.i5960.i.i = getelementptr i8, ptr %25, i64 32
  %.74.i.i.i5961.i.i = load double, ptr %.73.i.i.i5960.i.i, align 8, !noalias !90
  %.75.i.i.i5962.i.i = fmul double %.74.i.i.i5961.i.i, 5.000000e-01
  %.76.i.i.i5963.i.i = fmul double %.245.i.i5944.i.i, %.75.i.i.i5962.i.i
  %.77.i.i.i5964.i.i = fadd double %.45.i.i.i5959.i.i, %.76.i.i.i5963.i.i
  %.78.i.i.i5965.i.i = fmul double %.245.i.i5944.i.i, %.77.i.i.i5964.i.i
  %.87.le.i.i.i5966.i.i = tail call double @llvm.floor.f64(double %.78.i.i.i5965.i.i)
  %.92.i.i.i5967.i.i = fsub double %.78.i.i.i5965.i.i, %.87.le.i.i.i5966.i.i
  %.93.i.i.i5968.i.i = fmul double %.92.i.i.i5967.i.i, 0x401921FB54442D18
  %.121.i.i.i5969.i.i = getelementptr i8, ptr %25, i64 40
  %.122.i.i.i5970.i.i = load double, ptr %.121.i.i.i5969.i.i, align 8, !noalias !90
  %.126.i.i.i5971.i.i = fadd double %.122.i.i.i5970.i.i, %.93.i.i.i5968.i.i
  %.593.le.i.i5972.i.i = tail call double @llvm.sin.f64(double %.126.i.i.i5971.i.i)
  %.598.i.i5973.i.i = fmul double %.423.i.i5951.i.i, %.593.le.i.i5972.i.i
  %.600.i.i5974.i.i = fadd double %.361.i.i5949.i.i, %.598.i.i5973.i.i
  br label %B272.i.i5953.i.i
B272.i.i5953.i.i:
  %value.2.1.i.i5954.i.i = phi double [ %.600.i.i5974.i.i, %B164.i.i5957.i.i ], [ %.361.i.i5949.i.i, %B58.if.i.i5938.i.i ]
  %24 = getelementptr double, ptr %.84019621999.i.i, i64 %.90.0213.i.i5939.i.i
  store double %value.2.1.i.i5954.i.i, ptr %24, align 8, !noalias !95
  %exitcond.not.i.i5955.i.i = icmp eq i64 %.82419612000.i.i, %.161.i.i5940.i.i
  br i1 %exitcond.not.i.i5955.i.i, label %_ZN6poppet6engine8stepping9inputs_atB3v18B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd72Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_295ArrayIdLi1E1C7mutable7alignedE.exit.i5956.i.i, label %B58.if.i.i5938.i.i
B58.if.i.i5938.i.i:
  %.90.0213.i.i5939.i.i = phi i64 [ %.161.i.i5940.i.i, %B272.i.i5953.i.i ], [ 0, %B400.i.i ]
  %.161.i.i5940.i.i = add nuw nsw i64 %.90.0213.i.i5939.i.i, 1
  %.idx5561.i = mul i64 %.90.0213.i.i5939.i.i, 56
  %25 = getelementptr i8, ptr %.2706.i, i64 %.idx5561.i
  %.242.i.i5942.i.i = getelementptr i8, ptr %25, i64 48
  %.243.i.i5943.i.i = load double, ptr %.242.i.i5942.i.i, align 8, !noalias !95
  %.245.i.i5944.i.i = fsub double %t.2.0.i.i, %.243.i.i5943.i.i
  %.303.i.i5945.i.i = load double, ptr %25, align 8, !noalias !95
  %.357.i.i5946.i.i = getelementptr i8, ptr %25, i64 8
  %.358.i.i5947.i.i = load double, ptr %.357.i.i5946.i.i, align 8, !noalias !95
  %.360.i.i5948.i.i = fmul double %.245.i.i5944.i.i, %.358.i.i5947.i.i
  %.361.i.i5949.i.i = fadd double %.303.i.i5945.i.i, %.360.i.i5948.i.i
  %.422.i.i5950.i.i = getelementptr i8, ptr %25, i64 16
  %.423.i.i5951.i.i = load double, ptr %.422.i.i5950.i.i, align 8, !noalias !95
  %.424.i.i5952.i.i = fcmp une double %.423.i.i5951.i.i, 0.000000e+00
  br i1 %.424.i.i5952.i.i, label %B164.i.i5957.i.i, label %B272.i.i5953.i.i
_ZN6poppet6engine8stepping9inputs_atB3v18B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd72Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_295ArrayIdLi1E1C7mutable7alignedE.exit.i5956.i.i:
  br i1 %.148231.not.i.i.i.i, label %_ZN6poppet6engine8stepping15input_slopes_atB3v26B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd72Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_295ArrayIdLi1E1C7mutable7alignedE.exit.i.i.i, label %B58.if.i1365.i.i.i
B110.i.i.i.i:
  %.361.i1371.i.i.i = getelementptr i8, ptr %27, i64 48
  %.362.i.i.i.i = load double, ptr %.361.i1371.i.i.i, align 8, !noalias !96
  %.364.i.i.i.i = fsub double %t.2.0.i.i, %.362.i.i.i.i
  %.419.i.i.i.i = getelementptr i8, ptr %27, i64 24
  %.420.i.i.i.i = load double, ptr %.419.i.i.i.i, align 8, !noalias !96
  %.474.i.i.i.i = getelementptr i8, ptr %27, i64 32
  %.475.i.i.i.i = load double, ptr %.474.i.i.i.i, align 8, !noalias !96
  %.476.i.i.i.i = fmul double %.364.i.i.i.i, %.475.i.i.i.i
  %.477.i.i.i.i = fadd double %.420.i.i.i.i, %.476.i.i.i.i
  %.478.i.i.i.i = fmul double %.477.i.i.i.i, 0x401921FB54442D18
  %.534.i.i.i.i = fmul double %.305.i.i.i.i, %.478.i.i.i.i
  %.75.i.i1372.i.i.i = fmul double %.475.i.i.i.i, 5.000000e-01
  %.76.i.i1373.i.i.i = fmul double %.364.i.i.i.i, %.75.i.i1372.i.i.i
  %.77.i.i1374.i.i.i = fadd double %.420.i.i.i.i, %.76.i.i1373.i.i.i
  %.78.i.i1375.i.i.i = fmul double %.364.i.i.i.i, %.77.i.i1374.i.i.i
  %.87.le.i.i1376.i.i.i = tail call double @llvm.floor.f64(double %.78.i.i1375.i.i.i)
  %.92.i.i1377.i.i.i = fsub double %.78.i.i1375.i.i.i, %.87.le.i.i1376.i.i.i
  %.93.i.i1378.i.i.i = fmul double %.92.i.i1377.i.i.i, 0x401921FB54442D18
  %.121.i.i1379.i.i.i = getelementptr i8, ptr %27, i64 40
  %.122.i.i1380.i.i.i = load double, ptr %.121.i.i1379.i.i.i, align 8, !noalias !99
  %.126.i.i1381.i.i.i = fadd double %.122.i.i1380.i.i.i, %.93.i.i1378.i.i.i
  %.644.le.i.i.i.i = tail call double @llvm.cos.f64(double %.126.i.i1381.i.i.i)
  %.649.i.i.i.i = fmul double %.534.i.i.i.i, %.644.le.i.i.i.i
  %.651.i.i.i.i = fadd double %.243.i1369.i.i.i, %.649.i.i.i.i
  br label %B326.i.i.i.i
B326.i.i.i.i:
  %slope.2.1.i.i.i.i = phi double [ %.651.i.i.i.i, %B110.i.i.i.i ], [ %.243.i1369.i.i.i, %B58.if.i1365.i.i.i ]
  %26 = getelementptr double, ptr %.118320152044.i.i, i64 %.90.0233.i.i.i.i
  store double %slope.2.1.i.i.i.i, ptr %26, align 8, !noalias !96
  %exitcond.not.i1370.i.i.i = icmp eq i64 %.116720142045.i.i, %.161.i1366.i.i.i
  br i1 %exitcond.not.i1370.i.i.i, label %_ZN6poppet6engine8stepping15input_slopes_atB3v26B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd72Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_295ArrayIdLi1E1C7mutable7alignedE.exit.i.i.i, label %B58.if.i1365.i.i.i
B58.if.i1365.i.i.i:
  %.90.0233.i.i.i.i = phi i64 [ %.161.i1366.i.i.i, %B326.i.i.i.i ], [ 0, %_ZN6poppet6engine8stepping9inputs_atB3v18B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd72Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_295ArrayIdLi1E1C7mutable7alignedE.exit.i5956.i.i ]
  %.161.i1366.i.i.i = add nuw nsw i64 %.90.0233.i.i.i.i, 1
  %.idx5562.i = mul i64 %.90.0233.i.i.i.i, 56
  %27 = getelementptr i8, ptr %.2706.i, i64 %.idx5562.i
  %.242.i1368.i.i.i = getelementptr i8, ptr %27, i64 8
  %.243.i1369.i.i.i = load double, ptr %.242.i1368.i.i.i, align 8, !noalias !96
  %.304.i.i.i.i = getelementptr i8, ptr %27, i64 16
  %.305.i.i.i.i = load double, ptr %.304.i.i.i.i, align 8, !noalias !96
  %.306.i.i.i.i = fcmp une double %.305.i.i.i.i, 0.000000e+00
  br i1 %.306.i.i.i.i, label %B110.i.i.i.i, label %B326.i.i.i.i
_ZN6poppet6engine8stepping15input_slopes_atB3v26B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd72Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_295ArrayIdLi1E1C7mutable7alignedE.exit.i.i.i:
  tail call void %.822.i.i.i(ptr nonnull %.1354.i.i, ptr %.4926.i.i, ptr %.84019621999.i.i, ptr %.118320152044.i.i, ptr %.161.i.i, ptr %.305421902210.i.i, ptr %.181920692085.i.i, ptr %.3225.i.i), !noalias !87
  %.849.i.i.i = fcmp ogt double %h.6.0.i.i, 0.000000e+00
  br i1 %.849.i.i.i, label %B450.i.i, label %B298.i.i.i
B298.i.i.i:
  %.994.i.i.i = fsub double %"$phi1276.4.2.1.i", %t.2.0.i.i
  %.447.i.i.i.i = fdiv double 2.000000e+01, %.994.i.i.i
  br i1 %.585727.not.i.i.i.i, label %_ZN6poppet6engine8stepping10first_stepB3v27B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29d.exit.i.i.i, label %B90.if.i.i.i.i
B90.if.i.i.i.i:
  %fastest.2.0730.i.i.i.i = phi double [ %.13.i.i.i.i.i, %B90.if.i.i.i.i ], [ %.447.i.i.i.i, %B298.i.i.i ]
  %.527.0729.i.i.i.i = phi i64 [ %.598.i1382.i.i.i, %B90.if.i.i.i.i ], [ 0, %B298.i.i.i ]
  %.598.i1382.i.i.i = add nuw nsw i64 %.527.0729.i.i.i.i, 1
  %28 = getelementptr double, ptr %.305421902210.i.i, i64 %.527.0729.i.i.i.i
  %.761.i.i.i.i = load double, ptr %28, align 8, !noalias !102
  %.765.i.i.i.i = tail call double @llvm.fabs.f64(double %.761.i.i.i.i)
  %.766.i.i.i.i = fmul double %.765.i.i.i.i, 2.000000e+01
  %29 = getelementptr double, ptr %.4926.i.i, i64 %.527.0729.i.i.i.i
  %.800.i.i.i.i = load double, ptr %29, align 8, !noalias !102
  %.804.i.i.i.i = tail call double @llvm.fabs.f64(double %.800.i.i.i.i)
  %30 = getelementptr double, ptr %12, i64 %.527.0729.i.i.i.i
  %.858.i.i.i.i = load double, ptr %30, align 8, !noalias !102
  %.859.i.i.i.i = fadd double %.804.i.i.i.i, %.858.i.i.i.i
  %.863.i.i.i.i = fdiv double %.766.i.i.i.i, %.859.i.i.i.i
  %.12.i.i.i.i.i = fcmp ogt double %.863.i.i.i.i, %fastest.2.0730.i.i.i.i
  %.13.i.i.i.i.i = select i1 %.12.i.i.i.i.i, double %.863.i.i.i.i, double %fastest.2.0730.i.i.i.i
  %exitcond.not.i1383.i.i.i = icmp eq i64 %.598.i1382.i.i.i, %.481.fca.6.load.i.i
  br i1 %exitcond.not.i1383.i.i.i, label %_ZN6poppet6engine8stepping10first_stepB3v27B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29d.exit.i.i.i, label %B90.if.i.i.i.i
_ZN6poppet6engine8stepping10first_stepB3v27B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29d.exit.i.i.i:
  %fastest.2.0.lcssa.i.i.i.i = phi double [ %.447.i.i.i.i, %B298.i.i.i ], [ %.13.i.i.i.i.i, %B90.if.i.i.i.i ]
  %.1029.i.i.i.i = fdiv double 1.000000e+00, %fastest.2.0.lcssa.i.i.i.i
  %.1231.i.i.i = fcmp olt double %h.6.0.i.i, 0.000000e+00
  br i1 %.1231.i.i.i, label %B358.i.i.i, label %B450.i.i
B358.i.i.i:
  %.1234.i.i.i = fneg double %h.6.0.i.i
  %.12.i.i.i.i = fcmp olt double %.1029.i.i.i.i, %.1234.i.i.i
  %.13.i.i.i.i = select i1 %.12.i.i.i.i, double %.1029.i.i.i.i, double %.1234.i.i.i
  br label %B450.i.i
B450.i.i:
  %h.9.1.i.i = phi double [ %h.6.0.i.i, %B396.i.i ], [ %h.6.0.i.i, %_ZN6poppet6engine8stepping15input_slopes_atB3v26B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd72Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_295ArrayIdLi1E1C7mutable7alignedE.exit.i.i.i ], [ %.13.i.i.i.i, %B358.i.i.i ], [ %.1029.i.i.i.i, %_ZN6poppet6engine8stepping10first_stepB3v27B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29d.exit.i.i.i ]
  %.12.i.i5975.i.i = fcmp olt double %.4553.i.i, %h.9.1.i.i
  %.13.i.i5976.i.i = select i1 %.12.i.i5975.i.i, double %.4553.i.i, double %h.9.1.i.i
  br i1 %.1415.i.i, label %B78.if.i.i.i.i, label %_ZN6poppet6engine8stepping5reachB3v29B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_29dddb
B78.if.i.i.i.i:
  %first.2.0129.i.i.i.i = phi double [ %.13.i.i.i5978.i.i, %B78.if.i.i.i.i ], [ 0x7FF0000000000000, %B450.i.i ]
  %.106.0128.i.i.i.i = phi i64 [ %.177.i.i.i.i, %B78.if.i.i.i.i ], [ 0, %B450.i.i ]
  %.177.i.i.i.i = add nuw nsw i64 %.106.0128.i.i.i.i, 1
  %31 = getelementptr double, ptr %.4376.i.i, i64 %.106.0128.i.i.i.i
  %.235.i.i.i.i = load double, ptr %31, align 8, !noalias !105
  %.12.i.i.i5977.i.i = fcmp olt double %.235.i.i.i.i, %first.2.0129.i.i.i.i
  %.13.i.i.i5978.i.i = select i1 %.12.i.i.i5977.i.i, double %.235.i.i.i.i, double %first.2.0129.i.i.i.i
  %exitcond.not.i.i5979.i.i = icmp eq i64 %.251121222161.i.i, %.177.i.i.i.i
  br i1 %exitcond.not.i.i5979.i.i, label %_ZN6poppet6engine8stepping12next_instantB3v16B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE199Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit.i.i.i, label %B78.if.i.i.i.i
_ZN6poppet6engine8stepping12next_instantB3v16B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE199Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit.i.i.i:
  %.820.i.i.i = fcmp uge double %.13.i.i.i5978.i.i, %.818.i.i.i
  %32 = or i1 %.2917.i, %.820.i.i.i
  %brmerge.i.i.i = select i1 %32, i1 true, i1 %.1553.i.i
  %arg.segment.1.mux.i.i.i = select i1 %.820.i.i.i, double %"$phi1276.4.2.1.i", double %.13.i.i.i5978.i.i
  br i1 %brmerge.i.i.i, label %_ZN6poppet6engine8stepping5reachB3v29B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_29dddb, label %B200.i.i.i
B200.i.i.i:
  %.830.i.i.i = fsub double %.13.i.i.i5978.i.i, %t.2.0.i.i
  %.833.i.i.i = fsub double %t.2.0.i.i, %calm.2.0.i.i
  %.834.i.i.i = fcmp ult double %.830.i.i.i, %.833.i.i.i
  br i1 %.834.i.i.i, label %B232.i.i.i, label %_ZN6poppet6engine8stepping5reachB3v29B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_29dddb
B232.i.i.i:
  %.12.i999.i.i.i = fcmp olt double %.833.i.i.i, %.13.i.i5976.i.i
  %.13.i1000.i.i.i = select i1 %.12.i999.i.i.i, double %.833.i.i.i, double %.13.i.i5976.i.i
  br label %_ZN6poppet6engine8stepping5reachB3v29B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_29dddb
_ZN6poppet6engine8stepping5reachB3v29B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_29dddb:
  %wanted.2.0.sink.i.i.i = phi double [ %.13.i.i5976.i.i, %B450.i.i ], [ %.13.i.i5976.i.i, %B200.i.i.i ], [ %.13.i1000.i.i.i, %B232.i.i.i ], [ %.13.i.i5976.i.i, %_ZN6poppet6engine8stepping12next_instantB3v16B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE199Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit.i.i.i ]
  %arg.segment.1.sink.i.i.i = phi double [ %"$phi1276.4.2.1.i", %B450.i.i ], [ %.13.i.i.i5978.i.i, %B200.i.i.i ], [ %"$phi1276.4.2.1.i", %B232.i.i.i ], [ %arg.segment.1.mux.i.i.i, %_ZN6poppet6engine8stepping12next_instantB3v16B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE199Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit.i.i.i ]
  br i1 %.4657.i.i, label %B520.i.i, label %B582.i.i
B520.i.i:
  %.2112.i.i = load i64, ptr %.5090.i.i, align 8, !noalias !110
  %.2115.i.i = fsub double %arg.segment.1.sink.i.i.i, %t.2.0.i.i
  %.13.i.i5980.i.i = tail call i64 @llvm.smin.i64(i64 %.26.i.i.i, i64 %.2112.i.i)
  %.69.i.i.i = icmp slt i64 %.13.i.i5980.i.i, 0
  %.70.i.i.i = select i1 %.69.i.i.i, i64 %.481.fca.21.load.i.i, i64 0
  %33 = getelementptr double, ptr %.4584.i.i, i64 %.13.i.i5980.i.i
  %.84.i.i.i = getelementptr double, ptr %33, i64 %.70.i.i.i
  %.85.i.i.i = load double, ptr %.84.i.i.i, align 8, !noalias !111
  %.93.i.i.i = fcmp ugt double %.85.i.i.i, 0.000000e+00
  %.97.i.i.i = fcmp ult double %.85.i.i.i, %.2115.i.i
  %or.cond.i.i.i = select i1 %.93.i.i.i, i1 %.97.i.i.i, i1 false
  %"$phi94.0.2.0.i.i.i" = select i1 %or.cond.i.i.i, double %.85.i.i.i, double %.2115.i.i
  br label %B628.i.i
B582.i.i:
  %.2149.i.i = fsub double %arg.segment.1.sink.i.i.i, %t.2.0.i.i
  %.11.i.i.i = fmul double %.2149.i.i, 5.000000e-01
  %.13.i.i.i = fcmp olt double %wanted.2.0.sink.i.i.i, %.11.i.i.i
  %.24.i.i.i = fcmp olt double %wanted.2.0.sink.i.i.i, %.2149.i.i
  %.11.arg.remaining.i.i.i = select i1 %.24.i.i.i, double %.11.i.i.i, double %.2149.i.i
  %storemerge.i5981.i.i = select i1 %.13.i.i.i, double %wanted.2.0.sink.i.i.i, double %.11.arg.remaining.i.i.i
  br label %B628.i.i
B628.i.i:
  %"$phi628.0.2.1.in.sroa.speculated.i.i" = phi double [ %"$phi94.0.2.0.i.i.i", %B520.i.i ], [ %storemerge.i5981.i.i, %B582.i.i ]
  br i1 %exitcond.not.i.i.i, label %B680.i.i, label %B68.if.i5982.i.i
B68.if.i5982.i.i:
  %.616.0584.i5983.i.i = phi i64 [ %.687.i5984.i.i, %_ZN6poppet6engine8stepping9inputs_atB3v18B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd72Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_295ArrayIdLi1E1C7mutable7alignedE.exit.i6032.i.i ], [ 0, %B628.i.i ]
  %.687.i5984.i.i = add nuw nsw i64 %.616.0584.i5983.i.i, 1
  %switch.gep = getelementptr inbounds double, ptr @switch.table.integrate, i64 %.616.0584.i5983.i.i
  %switch.load = load double, ptr %switch.gep, align 8
  %.746.i.i.i = fmul double %"$phi628.0.2.1.in.sroa.speculated.i.i", %switch.load
  %.748.i5988.i.i = fadd double %t.2.0.i.i, %.746.i.i.i
  %.863.i5989.i.i = mul nuw nsw i64 %.687.i5984.i.i, %.82419612000.i.i
  %.860.i5990.i.i = mul nuw nsw i64 %.616.0584.i5983.i.i, %.82419612000.i.i
  %.909.not.i5997.i.i = icmp ult i64 %.860.i5990.i.i, %.99519802032.i.i
  br i1 %.909.not.i5997.i.i, label %switch.end.else.endif.endif.endif.i6005.i.i, label %switch.end.else.endif.if.i5998.i.i, !prof !52
switch.end.endif.i6009.i.i:
  %.889.sroa.13.0.i6010.i.i = phi i64 [ %.99519802032.i.i, %switch.end.else.endif.endif.endif.if.i6008.i.i ], [ %.863.i5989.i.i, %switch.end.else.endif.endif.endif.i6005.i.i ]
  %.977.i6011.i.i = sub nsw i64 %.889.sroa.13.0.i6010.i.i, %.889.sroa.0.3.i6000.i.i
  %.1002.i6012.i.i = getelementptr double, ptr %.101119812031.i.i, i64 %.889.sroa.0.3.i6000.i.i
  %.148211.not.i.i6013.i.i = icmp slt i64 %.977.i6011.i.i, 1
  br i1 %.148211.not.i.i6013.i.i, label %_ZN6poppet6engine8stepping9inputs_atB3v18B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd72Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_295ArrayIdLi1E1C7mutable7alignedE.exit.i6032.i.i, label %B58.if.i.i6014.i.i
B164.i.i6034.i.i:
  %.44.i.i.i6035.i.i = getelementptr i8, ptr %35, i64 24
  %.45.i.i.i6036.i.i = load double, ptr %.44.i.i.i6035.i.i, align 8, !noalias !114
  %.73.i.i.i6037.i.i = getelementptr i8, ptr %35, i64 32
  %.74.i.i.i6038.i.i = load double, ptr %.73.i.i.i6037.i.i, align 8, !noalias !114
  %.75.i.i.i6039.i.i = fmul double %.74.i.i.i6038.i.i, 5.000000e-01
  %.76.i.i.i6040.i.i = fmul double %.245.i.i6020.i.i, %.75.i.i.i6039.i.i
  %.77.i.i.i6041.i.i = fadd double %.45.i.i.i6036.i.i, %.76.i.i.i6040.i.i
  %.78.i.i.i6042.i.i = fmul double %.245.i.i6020.i.i, %.77.i.i.i6041.i.i
  %.87.le.i.i.i6043.i.i = tail call double @llvm.floor.f64(double %.78.i.i.i6042.i.i)
  %.92.i.i.i6044.i.i = fsub double %.78.i.i.i6042.i.i, %.87.le.i.i.i6043.i.i
  %.93.i.i.i6045.i.i = fmul double %.92.i.i.i6044.i.i, 0x401921FB54442D18
  %.121.i.i.i6046.i.i = getelementptr i8, ptr %35, i64 40
  %.122.i.i.i6047.i.i = load double, ptr %.121.i.i.i6046.i.i, align 8, !noalias !114
  %.126.i.i.i6048.i.i = fadd double %.122.i.i.i6047.i.i, %.93.i.i.i6045.i.i
  %.593.le.i.i6049.i.i = tail call double @llvm.sin.f64(double %.126.i.i.i6048.i.i)
  %.598.i.i6050.i.i = fmul double %.423.i.i6027.i.i, %.593.le.i.i6049.i.i
  %.600.i.i6051.i.i = fadd double %.361.i.i6025.i.i, %.598.i.i6050.i.i
  br label %B272.i.i6029.i.i
B272.i.i6029.i.i:
  %value.2.1.i.i6030.i.i = phi double [ %.600.i.i6051.i.i, %B164.i.i6034.i.i ], [ %.361.i.i6025.i.i, %B58.if.i.i6014.i.i ]
  %34 = getelementptr double, ptr %.1002.i6012.i.i, i64 %.90.0213.i.i6015.i.i
  store double %value.2.1.i.i6030.i.i, ptr %34, align 8, !noalias !121
  %exitcond.not.i.i6031.i.i = icmp eq i64 %.977.i6011.i.i, %.161.i.i6016.i.i
  br i1 %exitcond.not.i.i6031.i.i, label %_ZN6poppet6engine8stepping9inputs_atB3v18B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd72Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_295ArrayIdLi1E1C7mutable7alignedE.exit.i6032.i.i, label %B58.if.i.i6014.i.i
B58.if.i.i6014.i.i:
  %.90.0213.i.i6015.i.i = phi i64 [ %.161.i.i6016.i.i, %B272.i.i6029.i.i ], [ 0, %switch.end.endif.i6009.i.i ]
  %.161.i.i6016.i.i = add nuw nsw i64 %.90.0213.i.i6015.i.i, 1
  %.idx5563.i = mul i64 %.90.0213.i.i6015.i.i, 56
  %35 = getelementptr i8, ptr %.2706.i, i64 %.idx5563.i
  %.242.i.i6018.i.i = getelementptr i8, ptr %35, i64 48
  %.243.i.i6019.i.i = load double, ptr %.242.i.i6018.i.i, align 8, !noalias !121
  %.245.i.i6020.i.i = fsub double %.748.i5988.i.i, %.243.i.i6019.i.i
  %.303.i.i6021.i.i = load double, ptr %35, align 8, !noalias !121
  %.357.i.i6022.i.i = getelementptr i8, ptr %35, i64 8
  %.358.i.i6023.i.i = load double, ptr %.357.i.i6022.i.i, align 8, !noalias !121
  %.360.i.i6024.i.i = fmul double %.245.i.i6020.i.i, %.358.i.i6023.i.i
  %.361.i.i6025.i.i = fadd double %.303.i.i6021.i.i, %.360.i.i6024.i.i
  %.422.i.i6026.i.i = getelementptr i8, ptr %35, i64 16
  %.423.i.i6027.i.i = load double, ptr %.422.i.i6026.i.i, align 8, !noalias !121
  %.424.i.i6028.i.i = fcmp une double %.423.i.i6027.i.i, 0.000000e+00
  br i1 %.424.i.i6028.i.i, label %B164.i.i6034.i.i, label %B272.i.i6029.i.i
_ZN6poppet6engine8stepping9inputs_atB3v18B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEd72Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_295ArrayIdLi1E1C7mutable7alignedE.exit.i6032.i.i:
  %exitcond.not.i6033.i.i = icmp eq i64 %.687.i5984.i.i, 4
  br i1 %exitcond.not.i6033.i.i, label %B680.i.i, label %B68.if.i5982.i.i
switch.end.else.endif.if.i5998.i.i:
  br label %switch.end.else.endif.endif.endif.i6005.i.i
switch.end.else.endif.endif.endif.i6005.i.i:
  %.889.sroa.0.3.i6000.i.i = phi i64 [ %.99519802032.i.i, %switch.end.else.endif.if.i5998.i.i ], [ %.860.i5990.i.i, %B68.if.i5982.i.i ]
  %.926.not.i6007.i.i = icmp ult i64 %.863.i5989.i.i, %.99519802032.i.i
  br i1 %.926.not.i6007.i.i, label %switch.end.endif.i6009.i.i, label %switch.end.else.endif.endif.endif.if.i6008.i.i, !prof !52
switch.end.else.endif.endif.endif.if.i6008.i.i:
  br label %switch.end.endif.i6009.i.i
B680.i.i:
  %.2308.i.i = fsub double %arg.segment.1.sink.i.i.i, %t.2.0.i.i
  %.2309.i.i = fmul double %.2308.i.i, 0x3FEFFFFFFFFFDCD1
  %.2311.i.i = fcmp ult double %"$phi628.0.2.1.in.sroa.speculated.i.i", %.2309.i.i
  %.2320.i.i = fadd double %t.2.0.i.i, %"$phi628.0.2.1.in.sroa.speculated.i.i"
  %"$phi716.0.2.1.i.i" = select i1 %.2311.i.i, double %.2320.i.i, double %arg.segment.1.sink.i.i.i
  store double %t.2.0.i.i, ptr %.1354.i.i, align 8, !noalias !110
  store double %"$phi628.0.2.1.in.sroa.speculated.i.i", ptr %.2173.i, align 8, !noalias !110
  tail call void %.2529.i.i(ptr nonnull %.1354.i.i, ptr %.4926.i.i, ptr %.101119812031.i.i, ptr %.161.i.i, ptr %.305421902210.i.i, ptr %.181920692085.i.i, ptr %.3225.i.i, ptr %.217720922108.i.i, ptr %.3396.i.i, ptr %.3739.i.i), !noalias !110
  br i1 %.585727.not.i.i.i.i, label %_ZN6poppet6engine8stepping5errorB3v33B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29.exit.thread6112.i.i, label %B84.if.i.i.i
_ZN6poppet6engine8stepping5errorB3v33B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29.exit.thread6112.i.i:
  %.27056115.i.i = load i64, ptr %.2704.i.i, align 8, !noalias !110
  %.27066116.i.i = add nsw i64 %.27056115.i.i, 1
  store i64 %.27066116.i.i, ptr %.2704.i.i, align 8, !noalias !110
  br label %B1092.i.i
B164.i.i.i:
  %36 = getelementptr i8, ptr %.4485.i.i, i64 %.522.01421.i.i.i
  %.848.i.i.i = load i8, ptr %36, align 1, !noalias !122
  %.852.i.i.i = icmp ne i8 %.848.i.i.i, 0
  %.855.i.i.i = fcmp ole double %.760.i.i.i, 0.000000e+00
  %or.cond.i6059.i.i = and i1 %.855.i.i.i, %.852.i.i.i
  br i1 %or.cond.i6059.i.i, label %_ZN6poppet6engine8stepping5errorB3v33B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29.exit.thread.i.i, label %B240.i.i.i
B240.i.i.i:
  %37 = getelementptr double, ptr %.3567.i.i, i64 %.522.01421.i.i.i
  %.1135.i.i.i = load double, ptr %37, align 8, !noalias !122
  %.1193.i.i.i = getelementptr double, ptr %13, i64 %.522.01421.i.i.i
  %.1194.i.i.i = load double, ptr %.1193.i.i.i, align 8, !noalias !122
  %.1248.i.i.i = getelementptr double, ptr %.249.i.i, i64 %.522.01421.i.i.i
  %.1249.i.i.i = load double, ptr %.1248.i.i.i, align 8, !noalias !122
  %38 = getelementptr double, ptr %.4926.i.i, i64 %.522.01421.i.i.i
  %.1284.i.i.i = load double, ptr %38, align 8, !noalias !122
  %.1290.i.i.i = tail call double @llvm.fabs.f64(double %.1284.i.i.i)
  %.1292.i.i.i = tail call double @llvm.fabs.f64(double %.760.i.i.i)
  %.12.i.i6060.i.i = fcmp ogt double %.1292.i.i.i, %.1290.i.i.i
  %.13.i.i6061.i.i = select i1 %.12.i.i6060.i.i, double %.1292.i.i.i, double %.1290.i.i.i
  %.1139.i.i.i = tail call double @llvm.fabs.f64(double %.1135.i.i.i)
  %.1323.i.i.i = fmul double %.1249.i.i.i, %.13.i.i6061.i.i
  %.1324.i.i.i = fadd double %.1194.i.i.i, %.1323.i.i.i
  %.1328.i.i.i = fdiv double %.1139.i.i.i, %.1324.i.i.i
  %.1334.inv.i.i.i = fcmp ole double %.1328.i.i.i, %worst.2.01422.i.i.i
  %worst.3.1.i.i.i = select i1 %.1334.inv.i.i.i, double %worst.2.01422.i.i.i, double %.1328.i.i.i
  %exitcond.not.i6062.i.i = icmp eq i64 %.593.i.i.i, %.481.fca.6.load.i.i
  br i1 %exitcond.not.i6062.i.i, label %_ZN6poppet6engine8stepping5errorB3v33B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29.exit.i.i, label %B84.if.i.i.i
B84.if.i.i.i:
  %worst.2.01422.i.i.i = phi double [ %worst.3.1.i.i.i, %B240.i.i.i ], [ 0.000000e+00, %B680.i.i ]
  %.522.01421.i.i.i = phi i64 [ %.593.i.i.i, %B240.i.i.i ], [ 0, %B680.i.i ]
  %.593.i.i.i = add nuw nsw i64 %.522.01421.i.i.i, 1
  %39 = getelementptr double, ptr %.3739.i.i, i64 %.522.01421.i.i.i
  %.760.i.i.i = load double, ptr %39, align 8, !noalias !122
  %.775.le.i.i.i = fsub double %.760.i.i.i, %.760.i.i.i
  %.776.le.i.i.i = fcmp ord double %.775.le.i.i.i, 0.000000e+00
  br i1 %.776.le.i.i.i, label %B164.i.i.i, label %_ZN6poppet6engine8stepping5errorB3v33B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29.exit.thread.i.i
_ZN6poppet6engine8stepping5errorB3v33B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29.exit.thread.i.i:
  %.27056104.i.i = load i64, ptr %.2704.i.i, align 8, !noalias !110
  %.27066105.i.i = add nsw i64 %.27056104.i.i, 1
  store i64 %.27066105.i.i, ptr %.2704.i.i, align 8, !noalias !110
  br label %B1034.i.i
_ZN6poppet6engine8stepping5errorB3v33B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29.exit.i.i:
  %.2705.i.i = load i64, ptr %.2704.i.i, align 8, !noalias !110
  %.2706.i.i = add nsw i64 %.2705.i.i, 1
  store i64 %.2706.i.i, ptr %.2704.i.i, align 8, !noalias !110
  %.2738.i.i = fcmp ugt double %worst.3.1.i.i.i, 1.000000e+00
  br i1 %.2738.i.i, label %B1034.i.i, label %B1092.i.i
B1034.i.i:
  %storemerge1418.i6107.i.i = phi double [ 0x7FF0000000000000, %_ZN6poppet6engine8stepping5errorB3v33B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29.exit.thread.i.i ], [ %worst.3.1.i.i.i, %_ZN6poppet6engine8stepping5errorB3v33B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29.exit.i.i ]
  %.2751.le.i.i = fsub double %storemerge1418.i6107.i.i, %storemerge1418.i6107.i.i
  %.2752.le.i.i = fcmp ord double %.2751.le.i.i, 0.000000e+00
  %or.cond6163.i.i = and i1 %.4657.i.i, %.2752.le.i.i
  br i1 %or.cond6163.i.i, label %B1200.i.i, label %for.end.1.i.i
B1092.i.i:
  %storemerge1418.i6108.i.i = phi double [ %worst.3.1.i.i.i, %_ZN6poppet6engine8stepping5errorB3v33B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29.exit.i.i ], [ 0.000000e+00, %_ZN6poppet6engine8stepping5errorB3v33B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29.exit.thread6112.i.i ]
  %.2798.i.i = load i64, ptr %.5090.i.i, align 8, !noalias !110
  %.2806.i.i = icmp sge i64 %.2798.i.i, %.481.fca.21.load.i.i
  %brmerge.i.i = select i1 %.2806.i.i, i1 true, i1 %.4657.i.i
  br i1 %brmerge.i.i, label %B1200.i.i, label %B1150.i.i
B1150.i.i:
  %.2813.i.i = fcmp oeq double %"$phi716.0.2.1.i.i", %arg.segment.1.sink.i.i.i
  %.2818.i.i = fneg double %"$phi628.0.2.1.in.sroa.speculated.i.i"
  %"$phi1170.0.2.2.i.i" = select i1 %.2813.i.i, double %.2818.i.i, double %"$phi628.0.2.1.in.sroa.speculated.i.i"
  %.2871.i.i = icmp slt i64 %.2798.i.i, 0
  %.2872.i.i = select i1 %.2871.i.i, i64 %.481.fca.21.load.i.i, i64 0
  %40 = getelementptr double, ptr %.4584.i.i, i64 %.2798.i.i
  %.2886.i.i = getelementptr double, ptr %40, i64 %.2872.i.i
  store double %"$phi1170.0.2.2.i.i", ptr %.2886.i.i, align 8, !noalias !110
  br label %B1200.i.i
B1200.i.i:
  %storemerge1418.i61086150.i.i = phi double [ %storemerge1418.i6108.i.i, %B1150.i.i ], [ %storemerge1418.i6108.i.i, %B1092.i.i ], [ %storemerge1418.i6107.i.i, %B1034.i.i ]
  call void @llvm.lifetime.start.p0(ptr nonnull %.1113.i.i.i), !noalias !110
  call void @llvm.lifetime.start.p0(ptr nonnull %.1313.i.i.i), !noalias !110
  call void @llvm.lifetime.start.p0(ptr nonnull %.1437.i.i.i), !noalias !110
  br i1 %.1415.i.i, label %B78.if.i.i6069.i.i, label %B166.i.i.i
B78.if.i.i6069.i.i:
  %first.2.0129.i.i6070.i.i = phi double [ %.13.i.i.i6075.i.i, %B78.if.i.i6069.i.i ], [ 0x7FF0000000000000, %B1200.i.i ]
  %.106.0128.i.i6071.i.i = phi i64 [ %.177.i.i6072.i.i, %B78.if.i.i6069.i.i ], [ 0, %B1200.i.i ]
  %.177.i.i6072.i.i = add nuw nsw i64 %.106.0128.i.i6071.i.i, 1
  %41 = getelementptr double, ptr %.4376.i.i, i64 %.106.0128.i.i6071.i.i
  %.235.i.i6073.i.i = load double, ptr %41, align 8, !noalias !125
  %.12.i.i.i6074.i.i = fcmp olt double %.235.i.i6073.i.i, %first.2.0129.i.i6070.i.i
  %.13.i.i.i6075.i.i = select i1 %.12.i.i.i6074.i.i, double %.235.i.i6073.i.i, double %first.2.0129.i.i6070.i.i
  %exitcond.not.i.i6076.i.i = icmp eq i64 %.251121222161.i.i, %.177.i.i6072.i.i
  br i1 %exitcond.not.i.i6076.i.i, label %_ZN6poppet6engine8stepping12next_instantB3v16B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE199Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit.i6077.i.i, label %B78.if.i.i6069.i.i
_ZN6poppet6engine8stepping12next_instantB3v16B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE199Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit.i6077.i.i:
  %.5.i.i6078.i.i = fmul double %"$phi716.0.2.1.i.i", 0x3D06849B86A12B9B
  %.6.i.i6079.i.i = fadd double %.5.i.i6078.i.i, 1.000000e-15
  %.668.i.i.i = fsub double %"$phi716.0.2.1.i.i", %.6.i.i6079.i.i
  %.669.i.i.i = fcmp olt double %.13.i.i.i6075.i.i, %.668.i.i.i
  br label %B166.i.i.i
B166.i.i.i:
  %"$phi166.0.2.0.i.i.i" = phi i1 [ %.669.i.i.i, %_ZN6poppet6engine8stepping12next_instantB3v16B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE199Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit.i6077.i.i ], [ false, %B1200.i.i ]
  %brmerge.i6063.i.i = select i1 %.2917.i, i1 true, i1 %"$phi166.0.2.0.i.i.i"
  br i1 %brmerge.i6063.i.i, label %B404.i.i.i, label %B234.i.i.i
B234.i.i.i:
  %.812.i.i.i = load i64, ptr %.980.i.i, align 8, !noalias !130
  %.825.i.i.i = icmp slt i64 %.812.i.i.i, 0
  %.826.i.i.i = select i1 %.825.i.i.i, i64 %.481.fca.19.load.i.i, i64 0
  %42 = getelementptr double, ptr %.4687.i.i, i64 %.812.i.i.i
  %.840.i.i.i = getelementptr double, ptr %42, i64 %.826.i.i.i
  %.841.i.i.i = load double, ptr %.840.i.i.i, align 8, !noalias !130
  %.846.i.i.i = fcmp olt double %.841.i.i.i, %"$phi716.0.2.1.i.i"
  br i1 %.846.i.i.i, label %B404.thread3043.i.i.i, label %B534.i.i.i
B404.thread3043.i.i.i:
  tail call void %.10933044.i.i.i(ptr %.3396.i.i, ptr %.3911.i.i), !noalias !130
  br label %B534.i.i.i
B404.i.i.i:
  tail call void %.10933044.i.i.i(ptr %.3396.i.i, ptr %.3911.i.i), !noalias !130
  br i1 %.2917.i, label %B408.i.i.i, label %B534.i.i.i
B408.i.i.i:
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %.1113.i.i.i, i8 0, i64 16, i1 false), !noalias !130
  call fastcc void @v46(ptr %.1113.i.i.i, i64 %.481.fca.3.load.i.i, ptr %.161.i.i, ptr %.2869.i.i, ptr readonly %.4804.i.i, i64 2, ptr readonly %.4854.i.i, i64 %.481.fca.20.load.i.i, i64 3, i64 %.82419612000.i.i, ptr %.84019621999.i.i, ptr nonnull %.1354.i.i, ptr %.3911.i.i, i64 %.3895.i.i, i64 %.4067.i.i, ptr %.4083.i.i, i64 %.481.fca.5.load.i.i, ptr %.4926.i.i, ptr readonly %.2706.i, i64 7, double %t.2.0.i.i, double %"$phi628.0.2.1.in.sroa.speculated.i.i", ptr readonly %.3739.i.i)
  %.1220.fca.0.load.i.i.i = load i64, ptr %.1113.i.i.i, align 8, !noalias !130
  %.1220.fca.1.load.i.i.i = load double, ptr %.fca.1.gep.i.i.i, align 8, !noalias !130
  %.1247.i.i.i = fmul double %"$phi628.0.2.1.in.sroa.speculated.i.i", %.1220.fca.1.load.i.i.i
  %.1250.i.i.i = fadd double %t.2.0.i.i, %.1247.i.i.i
  %.12373045.i.i.i = icmp slt i64 %.1220.fca.0.load.i.i.i, 0
  %"$phi510.1.2.0.i.i.i" = select i1 %.12373045.i.i.i, double %"$phi716.0.2.1.i.i", double %.1250.i.i.i
  store i64 %.1220.fca.0.load.i.i.i, ptr %.2004.i, align 8, !noalias !130
  br label %B582.i.i.i
B534.i.i.i:
  br i1 %"$phi166.0.2.0.i.i.i", label %B538.i.i.i, label %B582.i.i.i
B538.i.i.i:
  store double 0.000000e+00, ptr %.1313.i.i.i, align 8, !noalias !130
  call fastcc void @v47(ptr %.1313.i.i.i, i64 %.481.fca.3.load.i.i, i64 %.481.fca.4.load.i.i, ptr %.161.i.i, i64 %.4360.i.i, ptr %.4376.i.i, ptr readonly %.4409.i.i, i64 %.251121222161.i.i, ptr %.252721232160.i.i, ptr %.269821422175.i.i, i64 %.481.fca.6.load.i.i, i64 %.481.fca.19.load.i.i, ptr readonly %.4687.i.i, i64 %.481.fca.19.load.i.i, ptr %.4729.i.i, i64 %.481.fca.19.load.i.i, i64 %.2853.i.i, ptr %.2869.i.i, i64 %.82419612000.i.i, ptr %.84019621999.i.i, ptr nonnull %.1354.i.i, ptr %.3225.i.i, i64 %.3209.i.i, ptr %.3911.i.i, i64 %.3895.i.i, i64 %.4067.i.i, ptr %.4083.i.i, i64 %.481.fca.5.load.i.i, ptr %.4926.i.i, ptr nonnull %.5090.i.i, ptr readonly %.2706.i, i64 7, double %t.2.0.i.i, double %"$phi628.0.2.1.in.sroa.speculated.i.i", double %"$phi716.0.2.1.i.i", ptr readonly %.3739.i.i)
  %.1420.i.i.i = load double, ptr %.1313.i.i.i, align 8, !noalias !130
  br label %B582.i.i.i
B582.i.i.i:
  %reached.3.0.i.i.i = phi double [ %"$phi510.1.2.0.i.i.i", %B408.i.i.i ], [ %.1420.i.i.i, %B538.i.i.i ], [ %"$phi716.0.2.1.i.i", %B534.i.i.i ]
  call fastcc void @v48(ptr %.1437.i.i.i, i64 %.481.fca.3.load.i.i, ptr %.161.i.i, i64 %.481.fca.6.load.i.i, i64 %.481.fca.19.load.i.i, ptr readonly %.4687.i.i, i64 %.481.fca.19.load.i.i, ptr %.4729.i.i, i64 %.481.fca.19.load.i.i, i64 %.2853.i.i, ptr %.2869.i.i, i64 %.82419612000.i.i, ptr %.84019621999.i.i, ptr nonnull %.1354.i.i, ptr %.3225.i.i, i64 %.3209.i.i, ptr %.3911.i.i, i64 %.3895.i.i, i64 %.481.fca.5.load.i.i, ptr %.4926.i.i, ptr nonnull %.5090.i.i, ptr readonly %.2706.i, i64 7, double %t.2.0.i.i, double %"$phi628.0.2.1.in.sroa.speculated.i.i", ptr readonly %.3739.i.i, double %reached.3.0.i.i.i)
  %.1590.i.i.i = load i64, ptr %.2004.i, align 8, !noalias !130
  %.1596.i.i.i = icmp sgt i64 %.1590.i.i.i, -1
  %.1839.i.i.i = fcmp olt double %reached.3.0.i.i.i, %"$phi716.0.2.1.i.i"
  %or.cond.i6064.i.i = select i1 %.1596.i.i.i, i1 true, i1 %.1839.i.i.i
  %spec.select.i6065.i.i = select i1 %or.cond.i6064.i.i, ptr %.4083.i.i, ptr %.3739.i.i
  br label %B76.if.i.i.i.i
B76.if.i.i.i.i:
  %.519.0852.i.i.i.i = phi i64 [ %.590.i.i.i.i, %B76.if.i.i.i.i ], [ 0, %B582.i.i.i ]
  %.590.i.i.i.i = add nuw nsw i64 %.519.0852.i.i.i.i, 1
  %43 = getelementptr double, ptr %spec.select.i6065.i.i, i64 %.519.0852.i.i.i.i
  %.644.i.i.i.i = load double, ptr %43, align 8, !noalias !131
  %gep.i.i.i.i = getelementptr double, ptr %invariant.gep.i.i.i.i, i64 %.519.0852.i.i.i.i
  %.677.i.i.i.i = load double, ptr %gep.i.i.i.i, align 8, !noalias !131
  %44 = getelementptr double, ptr %.4926.i.i, i64 %.519.0852.i.i.i.i
  %.707.i.i.i.i = load double, ptr %44, align 8, !noalias !131
  %.708.i.i.i.i = fsub double %.644.i.i.i.i, %.707.i.i.i.i
  %.709.i.i.i.i = tail call double @llvm.fabs.f64(double %.708.i.i.i.i)
  %.710.i.i.i.i = fadd double %.677.i.i.i.i, %.709.i.i.i.i
  store double %.710.i.i.i.i, ptr %gep.i.i.i.i, align 8, !noalias !131
  store double %.644.i.i.i.i, ptr %44, align 8, !noalias !131
  %45 = getelementptr double, ptr %.4967.i.i, i64 %.519.0852.i.i.i.i
  %.800.i.i6067.i.i = load double, ptr %45, align 8, !noalias !131
  %.12.i.i3040.i.i.i = fcmp olt double %.644.i.i.i.i, %.800.i.i6067.i.i
  %.13.i.i3041.i.i.i = select i1 %.12.i.i3040.i.i.i, double %.644.i.i.i.i, double %.800.i.i6067.i.i
  %gep854.i.i.i.i = getelementptr double, ptr %invariant.gep853.i.i.i.i, i64 %.519.0852.i.i.i.i
  %.860.i.i.i.i = load double, ptr %gep854.i.i.i.i, align 8, !noalias !131
  %.12.i848.i.i.i.i = fcmp ogt double %.644.i.i.i.i, %.860.i.i.i.i
  %.13.i849.i.i.i.i = select i1 %.12.i848.i.i.i.i, double %.644.i.i.i.i, double %.860.i.i.i.i
  store double %.13.i.i3041.i.i.i, ptr %45, align 8, !noalias !131
  store double %.13.i849.i.i.i.i, ptr %gep854.i.i.i.i, align 8, !noalias !131
  %exitcond.not.i3042.i.i.i = icmp eq i64 %.590.i.i.i.i, %.481.fca.5.load.i.i
  br i1 %exitcond.not.i3042.i.i.i, label %_ZN6poppet6engine10integrator7_acceptB3v34B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_5570, label %B76.if.i.i.i.i
_ZN6poppet6engine10integrator7_acceptB3v34B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_5570:
  %.1124.i.i.i.i = load i64, ptr %.5090.i.i, align 8, !noalias !131
  %.1125.i.i.i.i = add nsw i64 %.1124.i.i.i.i, 1
  store i64 %.1125.i.i.i.i, ptr %.5090.i.i, align 8, !noalias !131
  call void @llvm.lifetime.end.p0(ptr nonnull %.1113.i.i.i), !noalias !110
  call void @llvm.lifetime.end.p0(ptr nonnull %.1313.i.i.i), !noalias !110
  call void @llvm.lifetime.end.p0(ptr nonnull %.1437.i.i.i), !noalias !110
  store double %reached.3.0.i.i.i, ptr %.5009.i.i, align 8, !noalias !110
  %.3105.i.i = load i64, ptr %.2004.i, align 8, !noalias !110
  %.3106.i.i = icmp sgt i64 %.3105.i.i, -1
  br i1 %.3106.i.i, label %B1718.i, label %B1350.i.i
B1350.i.i:
  %.12.i.i.i = fcmp olt double %storemerge1418.i61086150.i.i, 1.000000e-10
  %.13.i6080.i.i = select i1 %.12.i.i.i, double 1.000000e-10, double %storemerge1418.i61086150.i.i
  %.17.i.i.i = tail call double @llvm.pow.f64(double %.13.i6080.i.i, double -2.500000e-01)
  %.18.i.i.i = fmul double %.17.i.i.i, 9.000000e-01
  %.27.i.i.i = fcmp ogt double %step_before.3.0.i.i, 0.000000e+00
  br i1 %.27.i.i.i, label %B42.i.i.i, label %_ZN6poppet6engine8stepping6growthB3v41B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdddd.exit.i.i
B42.i.i.i:
  %.34.i.i.i = fdiv double %"$phi628.0.2.1.in.sroa.speculated.i.i", %step_before.3.0.i.i
  %.39.i.i.i = fmul double %.34.i.i.i, 9.000000e-01
  %.42.i.i.i = fmul double %.13.i6080.i.i, %.13.i6080.i.i
  %.49.i.i.i = fdiv double %error_before.2.0.i.i, %.42.i.i.i
  %.52.i.i.i = tail call double @llvm.pow.f64(double %.49.i.i.i, double 2.500000e-01)
  %.53.i.i.i = fmul double %.39.i.i.i, %.52.i.i.i
  %.12.i.i6081.i.i = fcmp olt double %.53.i.i.i, %.18.i.i.i
  %.13.i.i6082.i.i = select i1 %.12.i.i6081.i.i, double %.53.i.i.i, double %.18.i.i.i
  br label %_ZN6poppet6engine8stepping6growthB3v41B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdddd.exit.i.i
_ZN6poppet6engine8stepping6growthB3v41B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdddd.exit.i.i:
  %factor.2.0.i.i.i = phi double [ %.13.i.i6082.i.i, %B42.i.i.i ], [ %.18.i.i.i, %B1350.i.i ]
  %.12.i3.i.i.i = fcmp ogt double %factor.2.0.i.i.i, 1.500000e-01
  %.13.i4.i.i.i = select i1 %.12.i3.i.i.i, double %factor.2.0.i.i.i, double 1.500000e-01
  %.12.i5.i.i.i = fcmp olt double %.13.i4.i.i.i, 6.000000e+00
  %.13.i6.i.i.i = select i1 %.12.i5.i.i.i, double %.13.i4.i.i.i, double 6.000000e+00
  %.12.i6083.i.i = fcmp ogt double %.13.i6080.i.i, 1.000000e-02
  %.13.i6084.i.i = select i1 %.12.i6083.i.i, double %.13.i6080.i.i, double 1.000000e-02
  br i1 %has_changed.3.0.i.i, label %B1484.i.i, label %B1554.i.i
B1484.i.i:
  %.12.i6085.i.i = fcmp ogt double %.13.i6.i.i.i, 5.000000e-01
  %.13.i6086.i.i = select i1 %.12.i6085.i.i, double %.13.i6.i.i.i, double 5.000000e-01
  %.12.i6087.i.i = fcmp olt double %.13.i6086.i.i, 2.000000e+00
  %.13.i6088.i.i = select i1 %.12.i6087.i.i, double %.13.i6086.i.i, double 2.000000e+00
  %.3560.i.i = fmul double %"$phi628.0.2.1.in.sroa.speculated.i.i", %.13.i6088.i.i
  br label %B1554.i.i
B1554.i.i:
  %first.2.1.i.i = phi double [ %.3560.i.i, %B1484.i.i ], [ %first.3.0.i.i, %_ZN6poppet6engine8stepping6growthB3v41B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dEdddd.exit.i.i ]
  %.3568.i.i = fcmp olt double %"$phi628.0.2.1.in.sroa.speculated.i.i", %wanted.2.0.sink.i.i.i
  br i1 %.3568.i.i, label %B1566.i.i, label %B1604.i.i
B1566.i.i:
  %.3574.i.i = fmul double %"$phi628.0.2.1.in.sroa.speculated.i.i", %.13.i6.i.i.i
  %.12.i6089.i.i = fcmp ogt double %.3574.i.i, %wanted.2.0.sink.i.i.i
  %.13.i6090.i.i = select i1 %.12.i6089.i.i, double %.3574.i.i, double %wanted.2.0.sink.i.i.i
  br label %B1648.i.i
B1604.i.i:
  %.12.i6091.i.i = fcmp olt double %.13.i6.i.i.i, 1.000000e+00
  %.13.i6092.i.i = select i1 %.12.i6091.i.i, double %.13.i6.i.i.i, double 1.000000e+00
  %"$phi1644.1.2.1.i.i" = select i1 %rejected.3.0.i.i, double %.13.i6092.i.i, double %.13.i6.i.i.i
  %.3669.i.i = fmul double %"$phi628.0.2.1.in.sroa.speculated.i.i", %"$phi1644.1.2.1.i.i"
  br label %B1648.i.i
B1648.i.i:
  %"$phi1648.0.2.1.i.i" = phi double [ %.13.i6090.i.i, %B1566.i.i ], [ %.3669.i.i, %B1604.i.i ]
  %.3753.i.i = fcmp olt double %reached.3.0.i.i.i, %.818.i.i.i
  %or.cond6133.i.i = select i1 %.1415.i.i, i1 %.3753.i.i, i1 false
  br i1 %or.cond6133.i.i, label %B1712.i.i, label %B2048.i.i
B1712.i.i:
  store i8 0, ptr %.3776.i.i, align 1, !noalias !110
  call fastcc void @v45(ptr %.3776.i.i, i64 %.481.fca.4.load.i.i, ptr %.161.i.i, i64 %.4360.i.i, ptr %.4376.i.i, ptr readonly %.4409.i.i, i64 %.251121222161.i.i, ptr %.252721232160.i.i, ptr %.269821422175.i.i, i64 %.82419612000.i.i, ptr %.84019621999.i.i, ptr nonnull %.1354.i.i, ptr readonly %.2706.i, i64 7, double %reached.3.0.i.i.i, ptr nonnull %.4926.i.i)
  %.3883.i.i = load i8, ptr %.3776.i.i, align 1, !noalias !110
  %.3886.not.i.i = icmp ne i8 %.3883.i.i, 0
  %brmerge5933.i.i = select i1 %.3886.not.i.i, i1 true, i1 %.1839.i.i.i
  br i1 %brmerge5933.i.i, label %B1776.i.i, label %B2048.i.i
B1776.i.i:
  %.12.i6093.i.i = fcmp olt double %first.2.1.i.i, %"$phi1648.0.2.1.i.i"
  %.13.i6094.i.i = select i1 %.12.i6093.i.i, double %first.2.1.i.i, double %"$phi1648.0.2.1.i.i"
  br label %B2048.i.i
B1870.i.i:
  %.4108.i.i = tail call double @llvm.pow.f64(double %storemerge1418.i6107.i.i, double -2.500000e-01)
  %.4111.i.i = fmul double %.4108.i.i, 9.000000e-01
  %.12.i6095.i.i = fcmp olt double %.4111.i.i, 8.000000e-01
  %.13.i6096.i.i = select i1 %.12.i6095.i.i, double %.4111.i.i, double 8.000000e-01
  %.12.i6097.i.i = fcmp ogt double %.13.i6096.i.i, 1.500000e-01
  %.13.i6098.i.i = select i1 %.12.i6097.i.i, double %.13.i6096.i.i, double 1.500000e-01
  br label %B1974.i.i
B1974.i.i:
  %"$phi1974.1.2.2.i.i" = phi double [ %.13.i6098.i.i, %B1870.i.i ], [ 1.500000e-01, %for.end.1.i.i ]
  %.4179.i.i = fmul double %"$phi628.0.2.1.in.sroa.speculated.i.i", %"$phi1974.1.2.2.i.i"
  %.4192.i.i = fadd double %t.2.0.i.i, %.4179.i.i
  %.4194.i.i = fcmp ole double %.4192.i.i, %t.2.0.i.i
  %.4197.i.i = fcmp olt double %.4179.i.i, 1.000000e-300
  %or.cond.i5462.i = or i1 %.4197.i.i, %.4194.i.i
  %brmerge5935.i.i = select i1 %or.cond.i5462.i, i1 true, i1 %.4657.i.i
  br i1 %brmerge5935.i.i, label %B1934.loopexit.i, label %B2048.i.i
B2048.i.i:
  %h.7.1.i.i = phi double [ %.4179.i.i, %B1974.i.i ], [ %"$phi1648.0.2.1.i.i", %B1712.i.i ], [ %.13.i6094.i.i, %B1776.i.i ], [ %"$phi1648.0.2.1.i.i", %B1648.i.i ]
  %t.3.1.i.i = phi double [ %t.2.0.i.i, %B1974.i.i ], [ %reached.3.0.i.i.i, %B1712.i.i ], [ %reached.3.0.i.i.i, %B1776.i.i ], [ %reached.3.0.i.i.i, %B1648.i.i ]
  %error_before.3.1.i.i = phi double [ %error_before.2.0.i.i, %B1974.i.i ], [ %.13.i6084.i.i, %B1712.i.i ], [ %.13.i6084.i.i, %B1776.i.i ], [ %.13.i6084.i.i, %B1648.i.i ]
  %step_before.4.1.i.i = phi double [ %step_before.3.0.i.i, %B1974.i.i ], [ %"$phi628.0.2.1.in.sroa.speculated.i.i", %B1712.i.i ], [ 0.000000e+00, %B1776.i.i ], [ %"$phi628.0.2.1.in.sroa.speculated.i.i", %B1648.i.i ]
  %rejected.4.1.i.i = phi i1 [ true, %B1974.i.i ], [ false, %B1712.i.i ], [ false, %B1776.i.i ], [ false, %B1648.i.i ]
  %fresh.4.1.i.i = phi i1 [ false, %B1974.i.i ], [ true, %B1712.i.i ], [ true, %B1776.i.i ], [ true, %B1648.i.i ]
  %calm.3.1.i.i = phi double [ %calm.2.0.i.i, %B1974.i.i ], [ %calm.2.0.i.i, %B1712.i.i ], [ %reached.3.0.i.i.i, %B1776.i.i ], [ %calm.2.0.i.i, %B1648.i.i ]
  %first.4.1.i.i = phi double [ %first.3.0.i.i, %B1974.i.i ], [ %first.2.1.i.i, %B1712.i.i ], [ %first.2.1.i.i, %B1776.i.i ], [ %first.2.1.i.i, %B1648.i.i ]
  %has_changed.4.1.i.i = phi i1 [ %has_changed.3.0.i.i, %B1974.i.i ], [ false, %B1712.i.i ], [ true, %B1776.i.i ], [ false, %B1648.i.i ]
  %has_acted.3.1.i.i = phi i1 [ %has_acted.5.0.i.i, %B1974.i.i ], [ true, %B1712.i.i ], [ true, %B1776.i.i ], [ %has_acted.5.0.i.i, %B1648.i.i ]
  %.570.i.i.i = load i64, ptr %.2704.i.i, align 8, !noalias !134
  %.590.i.i.i = srem i64 %.570.i.i.i, 400
  %.592.i.i.i = icmp slt i64 %.590.i.i.i, 0
  %.601.i.i.i = add nsw i64 %.590.i.i.i, 400
  %.581.0.i.i.i = select i1 %.592.i.i.i, i64 %.601.i.i.i, i64 %.590.i.i.i
  %.611.i.i.i = icmp ne i64 %.581.0.i.i.i, 0
  br i1 %.611.i.i.i, label %B284.i.i.i, label %B104.i.i.i
B104.i.i.i:
  %.522.i.i.i = load double, ptr %.2619.i, align 8, !noalias !134
  %.615.i.i.i = fsub double %t.3.1.i.i, %window.2.0.i.i
  %.620.i.i.i = fsub double %.522.i.i.i, %window.2.0.i.i
  %.625.i.i.i = fmul double %.620.i.i.i, 1.000000e-04
  %.626.i.i.i = fcmp uge double %.615.i.i.i, %.625.i.i.i
  %.675.i.i.i = load i64, ptr %.5090.i.i, align 8, !noalias !134
  %.705.i.i.i = load i64, ptr %.704.i.i.i, align 8, !noalias !134
  %.706.i.i.i = sub nsw i64 %.675.i.i.i, %.705.i.i.i
  %.748.i6100.i.i = icmp sgt i64 %.706.i.i.i, 279
  %46 = select i1 %.748.i6100.i.i, i1 true, i1 %.626.i.i.i
  %brmerge.i6101.i.i = select i1 %46, i1 true, i1 %has_acted.3.1.i.i
  br i1 %brmerge.i6101.i.i, label %B242.i.i.i, label %B1934.loopexit.i
B242.i.i.i:
  store i64 %.675.i.i.i, ptr %.704.i.i.i, align 8, !noalias !134
  br label %B284.i.i.i
B284.i.i.i:
  %.1010.i.i.i = sitofp i64 %.570.i.i.i to double
  %.1011.i.i.i = fcmp ugt double %.4582.i.i, %.1010.i.i.i
  br i1 %.1011.i.i.i, label %B352.i.i.i, label %B1934.loopexit.i
B352.i.i.i:
  %.1284.i6099.i.i = load double, ptr %.1283.i.i.i, align 8, !noalias !134
  %.1288.i.i.i = fcmp une double %.1284.i6099.i.i, 0.000000e+00
  br i1 %.1288.i.i.i, label %B1934.loopexit.i, label %B2126.i.i
B2126.i.i:
  %window.3.1.i.i = select i1 %.611.i.i.i, double %window.2.0.i.i, double %t.3.1.i.i
  %has_acted.6.1.i.i = select i1 %.611.i.i.i, i1 %has_acted.3.1.i.i, i1 false
  %.5074.i.i = fcmp olt double %t.3.1.i.i, %"$phi1276.4.2.1.i"
  br i1 %.5074.i.i, label %B396.i.i, label %B1718.thread5638.i
for.end.1.i.i:
  br i1 %.2752.le.i.i, label %B1870.i.i, label %B1974.i.i
B1624.i:
  call void @llvm.lifetime.start.p0(ptr nonnull %.648.i.i), !noalias !53
  call void @llvm.lifetime.start.p0(ptr nonnull %.1307.i.i), !noalias !53
  call void @llvm.lifetime.start.p0(ptr nonnull %.1528.i.i), !noalias !53
  %.580.i.i = fcmp olt double %.2539.i, %"$phi1276.4.2.1.i"
  br i1 %.580.i.i, label %B90.preheader.i.i, label %B1624._ZN6poppet6engine10integrator15_without_statesB3v43B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_2
B1624._ZN6poppet6engine10integrator15_without_statesB3v43B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_2:
  %.3561.pre.i = load i64, ptr %.2004.i, align 8, !noalias !53
  br label %_ZN6poppet6engine10integrator15_without_statesB3v43B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c
B90.preheader.i.i:
  %.5.i.i.i = fmul double %"$phi1276.4.2.1.i", 0x3D06849B86A12B9B
  %.6.i.i.i = fadd double %.5.i.i.i, 1.000000e-15
  %.874.i.i = fsub double %"$phi1276.4.2.1.i", %.6.i.i.i
  br label %B90.i.i
B90.i.i:
  %t.2.0.i5484.i = phi double [ %end.5.1.i.i, %B826.i.i ], [ %.2539.i, %B90.preheader.i.i ]
  br i1 %.636.i5483.not.i, label %B304.i.i, label %B136.i.i
B136.i.i:
  call fastcc void @v45(ptr %.648.i.i, i64 %.481.fca.4.load.i.i, ptr %.161.i.i, i64 %.4360.i.i, ptr %.4376.i.i, ptr readonly %.4409.i.i, i64 %.251121222161.i.i, ptr %.252721232160.i.i, ptr %.269821422175.i.i, i64 %.82419612000.i.i, ptr %.84019621999.i.i, ptr %.1354.i.i, ptr readonly %.2706.i, i64 7, double %t.2.0.i5484.i, ptr %.4926.i.i)
  br label %B78.if.i.i.i
B78.if.i.i.i:
  %first.2.0129.i.i.i = phi double [ %.13.i.i.i5490.i, %B78.if.i.i.i ], [ 0x7FF0000000000000, %B136.i.i ]
  %.106.0128.i.i.i = phi i64 [ %.177.i.i.i, %B78.if.i.i.i ], [ 0, %B136.i.i ]
  %.177.i.i.i = add nuw nsw i64 %.106.0128.i.i.i, 1
  %47 = getelementptr double, ptr %.4376.i.i, i64 %.106.0128.i.i.i
  %.235.i.i.i = load double, ptr %47, align 8, !noalias !137
  %.12.i.i.i5489.i = fcmp olt double %.235.i.i.i, %first.2.0129.i.i.i
  %.13.i.i.i5490.i = select i1 %.12.i.i.i5489.i, double %.235.i.i.i, double %first.2.0129.i.i.i
  %exitcond.not.i.i5491.i = icmp eq i64 %.251121222161.i.i, %.177.i.i.i
  br i1 %exitcond.not.i.i5491.i, label %_ZN6poppet6engine8stepping12next_instantB3v16B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE199Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit.i.i, label %B78.if.i.i.i
_ZN6poppet6engine8stepping12next_instantB3v16B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE199Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit.i.i:
  %.876.i.i = fcmp olt double %.13.i.i.i5490.i, %.874.i.i
  %"$phi302.0.2.2.i.i" = select i1 %.876.i.i, double %.13.i.i.i5490.i, double %"$phi1276.4.2.1.i"
  br label %B304.i.i
B304.i.i:
  %end.4.1.i.i = phi double [ %"$phi302.0.2.2.i.i", %_ZN6poppet6engine8stepping12next_instantB3v16B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE199Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit.i.i ], [ %"$phi1276.4.2.1.i", %B90.i.i ]
  br i1 %.2917.i, label %B358.i.i, label %B826.i.i
B358.i.i:
  %.981.i.i = load i64, ptr %.980.i.i, align 8, !noalias !142
  %.998.i.i = icmp slt i64 %.981.i.i, %.996.i.i
  br i1 %.998.i.i, label %B412.i.i, label %B582.i5486.i
B412.i.i:
  %.1021.i.i = icmp slt i64 %.981.i.i, 0
  %.1022.i.i = select i1 %.1021.i.i, i64 %.481.fca.19.load.i.i, i64 0
  %48 = getelementptr double, ptr %.4687.i.i, i64 %.981.i.i
  %.1036.i.i = getelementptr double, ptr %48, i64 %.1022.i.i
  %.1037.i.i = load double, ptr %.1036.i.i, align 8, !noalias !142
  %.5.i2342.i.i = fmul double %t.2.0.i5484.i, 0x3D06849B86A12B9B
  %.6.i2343.i.i = fadd double %.5.i2342.i.i, 1.000000e-15
  %.1066.i.i = fadd double %t.2.0.i5484.i, %.6.i2343.i.i
  %.1067.i.i = fcmp ugt double %.1037.i.i, %.1066.i.i
  br i1 %.1067.i.i, label %B582.i5486.i, label %B478.i.i
B478.i.i:
  %row.2.3.i.i = phi i64 [ %.1073.i.i, %B516.i.i ], [ %.981.i.i, %B412.i.i ]
  %exitcond.not.i5488.i = icmp eq i64 %row.2.3.i.i, %11
  br i1 %exitcond.not.i5488.i, label %B582.i5486.i, label %B516.i.i
B516.i.i:
  %.1073.i.i = add nsw i64 %row.2.3.i.i, 1
  %.1113.i.i = icmp slt i64 %row.2.3.i.i, -1
  %.1114.i.i = select i1 %.1113.i.i, i64 %.481.fca.19.load.i.i, i64 0
  %49 = getelementptr double, ptr %.4687.i.i, i64 %.1073.i.i
  %.1128.i.i = getelementptr double, ptr %49, i64 %.1114.i.i
  %.1129.i.i = load double, ptr %.1128.i.i, align 8, !noalias !142
  %.1159.i.i = fcmp ugt double %.1129.i.i, %.1066.i.i
  br i1 %.1159.i.i, label %B582.i5486.i, label %B478.i.i
B582.i5486.i:
  %row.3.2.i.i = phi i64 [ %.981.i.i, %B412.i.i ], [ %.981.i.i, %B358.i.i ], [ %.1073.i.i, %B516.i.i ], [ %.996.i.i, %B478.i.i ]
  %.1186.i5487.i = icmp slt i64 %row.3.2.i.i, 0
  %.1187.i.i = select i1 %.1186.i5487.i, i64 %.481.fca.19.load.i.i, i64 0
  %50 = getelementptr double, ptr %.4687.i.i, i64 %row.3.2.i.i
  %.1201.i.i = getelementptr double, ptr %50, i64 %.1187.i.i
  %.1202.i.i = load double, ptr %.1201.i.i, align 8, !noalias !142
  %.5.i2346.i.i = fmul double %end.4.1.i.i, 0x3D06849B86A12B9B
  %.6.i2347.i.i = fadd double %.5.i2346.i.i, 1.000000e-15
  %.1229.i.i = fsub double %end.4.1.i.i, %.6.i2347.i.i
  %.1230.i.i = fcmp olt double %.1202.i.i, %.1229.i.i
  %"$phi666.0.2.2.i.i" = select i1 %.1230.i.i, double %.1202.i.i, double %end.4.1.i.i
  %.1287.i.i = fsub double %"$phi666.0.2.2.i.i", %t.2.0.i5484.i
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %.1307.i.i, i8 0, i64 16, i1 false), !noalias !142
  call fastcc void @v46(ptr %.1307.i.i, i64 %.481.fca.3.load.i.i, ptr %.161.i.i, ptr %.2869.i.i, ptr readonly %.4804.i.i, i64 2, ptr readonly %.4854.i.i, i64 %.481.fca.20.load.i.i, i64 3, i64 %.82419612000.i.i, ptr %.84019621999.i.i, ptr %.1354.i.i, ptr readonly %.3911.i.i, i64 %.3895.i.i, i64 %.4067.i.i, ptr %.4083.i.i, i64 %.481.fca.5.load.i.i, ptr %.4926.i.i, ptr readonly %.2706.i, i64 7, double %t.2.0.i5484.i, double %.1287.i.i, ptr %.4926.i.i)
  %.1414.fca.0.load.i.i = load i64, ptr %.1307.i.i, align 8, !noalias !142
  %.1414.fca.1.load.i.i = load double, ptr %.fca.1.gep.i5481.i, align 8, !noalias !142
  %.1445.i.i = fmul double %.1287.i.i, %.1414.fca.1.load.i.i
  %.1449.i.i = fadd double %t.2.0.i5484.i, %.1445.i.i
  %.14342348.i.i = icmp slt i64 %.1414.fca.0.load.i.i, 0
  %"$phi804.1.2.2.i.i" = select i1 %.14342348.i.i, double %"$phi666.0.2.2.i.i", double %.1449.i.i
  store i64 %.1414.fca.0.load.i.i, ptr %.2004.i, align 8, !noalias !142
  br label %B826.i.i
B826.i.i:
  %end.5.1.i.i = phi double [ %"$phi804.1.2.2.i.i", %B582.i5486.i ], [ %end.4.1.i.i, %B304.i.i ]
  %.1505.i.i = fsub double %end.5.1.i.i, %t.2.0.i5484.i
  call fastcc void @v48(ptr %.1528.i.i, i64 %.481.fca.3.load.i.i, ptr %.161.i.i, i64 %.481.fca.6.load.i.i, i64 %.481.fca.19.load.i.i, ptr readonly %.4687.i.i, i64 %.481.fca.19.load.i.i, ptr %.4729.i.i, i64 %.481.fca.19.load.i.i, i64 %.2853.i.i, ptr %.2869.i.i, i64 %.82419612000.i.i, ptr %.84019621999.i.i, ptr %.1354.i.i, ptr %.3225.i.i, i64 %.3209.i.i, ptr readonly %.3911.i.i, i64 %.3895.i.i, i64 %.481.fca.5.load.i.i, ptr %.4926.i.i, ptr %.5090.i.i, ptr readonly %.2706.i, i64 7, double %t.2.0.i5484.i, double %.1505.i.i, ptr %.4926.i.i, double %end.5.1.i.i)
  %.1683.i.i = load i64, ptr %.2004.i, align 8, !noalias !142
  %.1684.i.i = icmp slt i64 %.1683.i.i, 0
  %.1837.i.i = fcmp olt double %end.5.1.i.i, %"$phi1276.4.2.1.i"
  %or.cond.i5485.i = select i1 %.1684.i.i, i1 %.1837.i.i, i1 false
  br i1 %or.cond.i5485.i, label %B90.i.i, label %_ZN6poppet6engine10integrator15_without_statesB3v43B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c
_ZN6poppet6engine10integrator15_without_statesB3v43B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c:
  %.3561.i = phi i64 [ %.3561.pre.i, %B1624._ZN6poppet6engine10integrator15_without_statesB3v43B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_2 ], [ %.1683.i.i, %B826.i.i ]
  %t.3.1.i5482.i = phi double [ %.2539.i, %B1624._ZN6poppet6engine10integrator15_without_statesB3v43B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_2 ], [ %end.5.1.i.i, %B826.i.i ]
  call void @llvm.lifetime.end.p0(ptr nonnull %.648.i.i), !noalias !53
  call void @llvm.lifetime.end.p0(ptr nonnull %.1307.i.i), !noalias !53
  call void @llvm.lifetime.end.p0(ptr nonnull %.1528.i.i), !noalias !53
  %.3562.i = icmp sgt i64 %.3561.i, -1
  br i1 %.3562.i, label %B1792.i, label %B1186.i
B1718.thread5638.i:
  %t.4.1.sink.i.ph5636.i = phi double [ %.2539.i, %_ZN6poppet6engine8stepping12stage_inputsB3v24B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_2 ], [ %t.3.1.i.i, %B2126.i.i ]
  %h.10.1.sink.i.ph5637.i = phi double [ %"$phi1566.1.2.1.i", %_ZN6poppet6engine8stepping12stage_inputsB3v24B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_2 ], [ %h.7.1.i.i, %B2126.i.i ]
  call void @llvm.lifetime.end.p0(ptr nonnull %.3776.i.i), !noalias !53
  br label %B1186.i
B1718.i:
  call void @llvm.lifetime.end.p0(ptr nonnull %.3776.i.i), !noalias !53
  br label %B1792.i
B1792.i:
  %.3854.pre-phi.i = phi i64 [ %.pre.i, %B1012.B1792_crit_edge.i ], [ %.996.i.i, %_ZN6poppet6engine8stepping14stop_conditionB3v20B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C ], [ %.996.i.i, %B1718.i ], [ %.996.i.i, %B1186.i ], [ %.996.i.i, %_ZN6poppet6engine10integrator15_without_statesB3v43B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c ]
  %segment.2.sroa.84.15555.i = phi ptr [ %.2268.i, %B1012.B1792_crit_edge.i ], [ %.2706.i, %_ZN6poppet6engine8stepping14stop_conditionB3v20B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C ], [ %.2706.i, %B1718.i ], [ %.2706.i, %B1186.i ], [ %.2706.i, %_ZN6poppet6engine10integrator15_without_statesB3v43B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c ]
  %status.5.15554.i = phi i64 [ 0, %B1012.B1792_crit_edge.i ], [ 1, %_ZN6poppet6engine8stepping14stop_conditionB3v20B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C ], [ 1, %B1718.i ], [ 1, %_ZN6poppet6engine10integrator15_without_statesB3v43B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c ], [ 0, %B1186.i ]
  %t.4.15552.i = phi double [ %.2035.i, %B1012.B1792_crit_edge.i ], [ %.2539.i, %_ZN6poppet6engine8stepping14stop_conditionB3v20B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C ], [ %reached.3.0.i.i.i, %B1718.i ], [ %t.3.1.i5482.i, %_ZN6poppet6engine10integrator15_without_statesB3v43B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c ], [ %t.5.15626.i, %B1186.i ]
  %h.5.15550.i = phi double [ %.2174.i, %B1012.B1792_crit_edge.i ], [ %h.3.05584.i, %_ZN6poppet6engine8stepping14stop_conditionB3v20B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C ], [ %"$phi628.0.2.1.in.sroa.speculated.i.i", %B1718.i ], [ %"$phi1566.1.2.1.i", %_ZN6poppet6engine10integrator15_without_statesB3v43B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c ], [ %h.4.15627.i, %B1186.i ]
  %.3840.i = getelementptr i8, ptr %.5090.i.i, i64 16
  %.3841.i = load i64, ptr %.3840.i, align 8, !noalias !53
  %.13.i.i = tail call i64 @llvm.smin.i64(i64 %.3854.pre-phi.i, i64 %.3841.i)
  store i64 %.13.i.i, ptr %.3840.i, align 8, !noalias !53
  %.148211.not.i.i.i5492.i = icmp eq i64 %.82419612000.i.i, 0
  br i1 %.148211.not.i.i.i5492.i, label %_ZN6poppet6engine8stepping10outputs_atB3v21B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C5512, label %B58.if.i.i.i5493.i
B164.i.i.i5516.i:
  %.44.i.i.i.i5517.i = getelementptr i8, ptr %52, i64 24
  %.45.i.i.i.i5518.i = load double, ptr %.44.i.i.i.i5517.i, align 8, !noalias !143
  %.73.i.i.i.i5519.i = getelementptr i8, ptr %52, i64 32
  %.74.i.i.i.i5520.i = load double, ptr %.73.i.i.i.i5519.i, align 8, !noalias !143
  %.75.i.i.i.i5521.i = fmul double %.74.i.i.i.i5520.i, 5.000000e-01
  %.76.i.i.i.i5522.i = fmul double %.245.i.i.i5499.i, %.75.i.i.i.i5521.i
  %.77.i.i.i.i5523.i = fadd double %.45.i.i.i.i5518.i, %.76.i.i.i.i5522.i
  %.78.i.i.i.i5524.i = fmul double %.245.i.i.i5499.i, %.77.i.i.i.i5523.i
  %.87.le.i.i.i.i5525.i = tail call double @llvm.floor.f64(double %.78.i.i.i.i5524.i)
  %.92.i.i.i.i5526.i = fsub double %.78.i.i.i.i5524.i, %.87.le.i.i.i.i5525.i
  %.93.i.i.i.i5527.i = fmul double %.92.i.i.i.i5526.i, 0x401921FB54442D18
  %.121.i.i.i.i5528.i = getelementptr i8, ptr %52, i64 40
  %.122.i.i.i.i5529.i = load double, ptr %.121.i.i.i.i5528.i, align 8, !noalias !143
  %.126.i.i.i.i5530.i = fadd double %.122.i.i.i.i5529.i, %.93.i.i.i.i5527.i
  %.593.le.i.i.i5531.i = tail call double @llvm.sin.f64(double %.126.i.i.i.i5530.i)
  %.598.i.i.i5532.i = fmul double %.423.i.i.i5506.i, %.593.le.i.i.i5531.i
  %.600.i.i.i5533.i = fadd double %.361.i.i.i5504.i, %.598.i.i.i5532.i
  br label %B272.i.i.i5508.i
B272.i.i.i5508.i:
  %value.2.1.i.i.i5509.i = phi double [ %.600.i.i.i5533.i, %B164.i.i.i5516.i ], [ %.361.i.i.i5504.i, %B58.if.i.i.i5493.i ]
  %51 = getelementptr double, ptr %.84019621999.i.i, i64 %.90.0213.i.i.i5494.i
  store double %value.2.1.i.i.i5509.i, ptr %51, align 8, !noalias !152
  %exitcond.not.i.i.i5510.i = icmp eq i64 %.82419612000.i.i, %.161.i.i.i5495.i
  br i1 %exitcond.not.i.i.i5510.i, label %_ZN6poppet6engine8stepping10outputs_atB3v21B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C5512, label %B58.if.i.i.i5493.i
B58.if.i.i.i5493.i:
  %.90.0213.i.i.i5494.i = phi i64 [ %.161.i.i.i5495.i, %B272.i.i.i5508.i ], [ 0, %B1792.i ]
  %.161.i.i.i5495.i = add nuw nsw i64 %.90.0213.i.i.i5494.i, 1
  %.idx5564.i = mul i64 %.90.0213.i.i.i5494.i, 56
  %52 = getelementptr i8, ptr %segment.2.sroa.84.15555.i, i64 %.idx5564.i
  %.242.i.i.i5497.i = getelementptr i8, ptr %52, i64 48
  %.243.i.i.i5498.i = load double, ptr %.242.i.i.i5497.i, align 8, !noalias !152
  %.245.i.i.i5499.i = fsub double %t.4.15552.i, %.243.i.i.i5498.i
  %.303.i.i.i5500.i = load double, ptr %52, align 8, !noalias !152
  %.357.i.i.i5501.i = getelementptr i8, ptr %52, i64 8
  %.358.i.i.i5502.i = load double, ptr %.357.i.i.i5501.i, align 8, !noalias !152
  %.360.i.i.i5503.i = fmul double %.245.i.i.i5499.i, %.358.i.i.i5502.i
  %.361.i.i.i5504.i = fadd double %.303.i.i.i5500.i, %.360.i.i.i5503.i
  %.422.i.i.i5505.i = getelementptr i8, ptr %52, i64 16
  %.423.i.i.i5506.i = load double, ptr %.422.i.i.i5505.i, align 8, !noalias !152
  %.424.i.i.i5507.i = fcmp une double %.423.i.i.i5506.i, 0.000000e+00
  br i1 %.424.i.i.i5507.i, label %B164.i.i.i5516.i, label %B272.i.i.i5508.i
_ZN6poppet6engine8stepping10outputs_atB3v21B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C5512:
  store double %t.4.15552.i, ptr %.1354.i.i, align 8, !noalias !153
  %.992.i.i5513.i = inttoptr i64 %.481.fca.3.load.i.i to ptr
  tail call void %.992.i.i5513.i(ptr nonnull %.1354.i.i, ptr %.4926.i.i, ptr %.84019621999.i.i, ptr %.161.i.i, ptr %.2869.i.i), !noalias !153
  %.649.i.i = load i64, ptr %.3840.i, align 8, !noalias !154
  %.754872.not.i.i = icmp slt i64 %.2844.i.i, 1
  br i1 %.754872.not.i.i, label %_ZN6poppet6engine8stepping9write_rowB3v39B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_29, label %B116.if.lr.ph.i.i
B116.if.lr.ph.i.i:
  %invariant.gep.i.i = getelementptr double, ptr %.4729.i.i, i64 %.649.i.i
  %.879.i.i = icmp slt i64 %.649.i.i, 0
  %.880.i.i = select i1 %.879.i.i, i64 %.481.fca.19.load.i.i, i64 0
  %invariant.gep875.i.i = getelementptr double, ptr %invariant.gep.i.i, i64 %.880.i.i
  br label %B116.if.i.i
B116.if.i.i:
  %.698.0873.i.i = phi i64 [ 0, %B116.if.lr.ph.i.i ], [ %.767.i.i, %B116.if.i.i ]
  %.767.i.i = add nuw nsw i64 %.698.0873.i.i, 1
  %53 = getelementptr double, ptr %.2869.i.i, i64 %.698.0873.i.i
  %.821.i.i = load double, ptr %53, align 8, !noalias !154
  %.898.i.i = mul i64 %.698.0873.i.i, %.481.fca.19.load.i.i
  %gep876.i.i = getelementptr double, ptr %invariant.gep875.i.i, i64 %.898.i.i
  store double %.821.i.i, ptr %gep876.i.i, align 8, !noalias !154
  %exitcond.not.i5515.i = icmp eq i64 %.2844.i.i, %.767.i.i
  br i1 %exitcond.not.i5515.i, label %_ZN6poppet6engine8stepping9write_rowB3v39B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_29, label %B116.if.i.i
_ZN6poppet6engine8stepping9write_rowB3v39B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_29:
  %.922.i.i = add nsw i64 %.649.i.i, 1
  store i64 %.922.i.i, ptr %.3840.i, align 8, !noalias !154
  br label %_ZN6poppet6engine10integrator9integrateB2v1B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAg6cJqBrMeIZJFEGM0QQAE8int64_2a.exit
B1934.loopexit.i:
  %.sink.i.ph.i = phi i64 [ 3, %B284.i.i.i ], [ 2, %B104.i.i.i ], [ 2, %B1974.i.i ], [ 5, %B352.i.i.i ]
  %t.4.1.sink.i.ph.i = phi double [ %t.3.1.i.i, %B284.i.i.i ], [ %t.3.1.i.i, %B104.i.i.i ], [ %t.2.0.i.i, %B1974.i.i ], [ %t.3.1.i.i, %B352.i.i.i ]
  %h.10.1.sink.i.ph.i = phi double [ %h.7.1.i.i, %B284.i.i.i ], [ %h.7.1.i.i, %B104.i.i.i ], [ %.4179.i.i, %B1974.i.i ], [ %h.7.1.i.i, %B352.i.i.i ]
  call void @llvm.lifetime.end.p0(ptr nonnull %.3776.i.i), !noalias !53
  br label %_ZN6poppet6engine10integrator9integrateB2v1B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAg6cJqBrMeIZJFEGM0QQAE8int64_2a.exit
B882.if.i:
  %.1687.05579.i = phi i64 [ %.1756.i, %B882.if.i ], [ 0, %B882.if.preheader.i ]
  %.1756.i = add nuw nsw i64 %.1687.05579.i, 1
  %54 = getelementptr double, ptr %.4926.i.i, i64 %.1687.05579.i
  %.1814.i = load double, ptr %54, align 8, !noalias !53
  %55 = getelementptr double, ptr %.4967.i.i, i64 %.1687.05579.i
  store double %.1814.i, ptr %55, align 8, !noalias !53
  %gep.i = getelementptr double, ptr %invariant.gep.i, i64 %.1687.05579.i
  store double %.1814.i, ptr %gep.i, align 8, !noalias !53
  %gep5667.i = getelementptr double, ptr %invariant.gep5666.i, i64 %.1687.05579.i
  store double 0.000000e+00, ptr %gep5667.i, align 8, !noalias !53
  %exitcond.not.i = icmp eq i64 %.481.fca.5.load.i.i, %.1756.i
  br i1 %exitcond.not.i, label %B1012.i, label %B882.if.i
B1188.if.i:
  %h.3.05584.i = phi double [ %.2174.i, %B1188.if.lr.ph.i ], [ %h.4.15627.i, %B1186.i ]
  %.2361.05582.i = phi i64 [ 0, %B1188.if.lr.ph.i ], [ %.2468.i, %B1186.i ]
  %.2468.i = add nuw nsw i64 %.2361.05582.i, 1
  %56 = getelementptr double, ptr %.1025.i, i64 %.2361.05582.i
  %.2539.i = load double, ptr %56, align 8, !noalias !53
  %.2546.i = icmp slt i64 %.2468.i, %.481.fca.17.load.i.i
  %57 = getelementptr double, ptr %.1025.i, i64 %.2468.i
  %"$phi1276.4.2.1.in.i" = select i1 %.2546.i, ptr %57, ptr %.2619.i
  %"$phi1276.4.2.1.i" = load double, ptr %"$phi1276.4.2.1.in.i", align 8, !noalias !53
  %58 = getelementptr i64, ptr %.1129.i, i64 %.2361.05582.i
  %.2654.i = load i64, ptr %58, align 8, !noalias !53
  %.2678.i = icmp slt i64 %.2654.i, 0
  %.2679.i = select i1 %.2678.i, i64 %.481.fca.18.load.i.i, i64 0
  %.2680.i = add i64 %.2679.i, %.2654.i
  %.2704.i = mul i64 %.2680.i, %.2264.i
  %.2706.i = getelementptr double, ptr %.1178.i, i64 %.2704.i
  br i1 %.2775.i, label %B1340.i, label %B1396.i
_ZN6poppet6engine10integrator9integrateB2v1B56c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAg6cJqBrMeIZJFEGM0QQAE8int64_2a.exit:
  %status.5.15553.i = phi i64 [ %status.5.15554.i, %_ZN6poppet6engine8stepping9write_rowB3v39B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_29 ], [ %.sink.i.ph.i, %B1934.loopexit.i ]
  %t.4.15551.i = phi double [ %t.4.15552.i, %_ZN6poppet6engine8stepping9write_rowB3v39B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_29 ], [ %t.4.1.sink.i.ph.i, %B1934.loopexit.i ]
  %h.5.15549.i = phi double [ %h.5.15550.i, %_ZN6poppet6engine8stepping9write_rowB3v39B70c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZJFMEMQ0pdYBFNAA_3d_3dE832Run_28Functions_28int64_20x_205_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Control_28array_28float64_2c_202d_2c_20C_29_2c_20array_28uint8_2c_201d_2c_20C_29_2c_20float64_2c_20float64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20bool_29_2c_20Rows_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29_2c_20Stops_28array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29_2c_20Work_28array_28float64_2c_201d_2c_20C_29_20x_2013_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2972Segment_28float64_2c_20float64_2c_20array_28float64_2c_202d_2c_20C_29_29 ], [ %h.10.1.sink.i.ph.i, %B1934.loopexit.i ]
  store double %t.4.15551.i, ptr %.5009.i.i, align 8, !noalias !53
  store double %h.5.15549.i, ptr %.2173.i, align 8, !noalias !53
  call void @llvm.lifetime.end.p0(ptr nonnull %.2785.i)
  ret i64 %status.5.15553.i
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
!3 = !{!4, !6}
!4 = distinct !{!4, !5, !"scope"}
!5 = distinct !{!5, !"scope"}
!6 = distinct !{!6, !7, !"scope"}
!7 = distinct !{!7, !"scope"}
!8 = !{!6}
!9 = !{!10}
!10 = distinct !{!10, !11, !"scope"}
!11 = distinct !{!11, !"scope"}
!12 = !{!13}
!13 = distinct !{!13, !14, !"scope"}
!14 = distinct !{!14, !"scope"}
!15 = !{!16, !18, !20, !22}
!16 = distinct !{!16, !17, !"scope"}
!17 = distinct !{!17, !"scope"}
!18 = distinct !{!18, !19, !"scope"}
!19 = distinct !{!19, !"scope"}
!20 = distinct !{!20, !21, !"scope"}
!21 = distinct !{!21, !"scope"}
!22 = distinct !{!22, !23, !"scope"}
!23 = distinct !{!23, !"scope"}
!24 = !{!18, !20, !22}
!25 = !{!20, !22}
!26 = !{!22}
!27 = !{!28}
!28 = distinct !{!28, !29, !"scope"}
!29 = distinct !{!29, !"scope"}
!30 = !{!31}
!31 = distinct !{!31, !32, !"scope"}
!32 = distinct !{!32, !"scope"}
!33 = !{!34}
!34 = distinct !{!34, !35, !"scope"}
!35 = distinct !{!35, !"scope"}
!36 = !{!"branch_weights", i32 1, i32 99}
!37 = !{!38}
!38 = distinct !{!38, !39, !"scope"}
!39 = distinct !{!39, !"scope"}
!40 = !{!41, !43, !45, !47}
!41 = distinct !{!41, !42, !"scope"}
!42 = distinct !{!42, !"scope"}
!43 = distinct !{!43, !44, !"scope"}
!44 = distinct !{!44, !"scope"}
!45 = distinct !{!45, !46, !"scope"}
!46 = distinct !{!46, !"scope"}
!47 = distinct !{!47, !48, !"scope"}
!48 = distinct !{!48, !"scope"}
!49 = !{!43, !45, !47}
!50 = !{!45, !47}
!51 = !{!47}
!52 = !{!"branch_weights", i32 99, i32 1}
!53 = !{!54}
!54 = distinct !{!54, !55, !"scope"}
!55 = distinct !{!55, !"scope"}
!56 = !{!57, !54}
!57 = distinct !{!57, !58, !"scope"}
!58 = distinct !{!58, !"scope"}
!59 = !{!60, !54}
!60 = distinct !{!60, !61, !"scope"}
!61 = distinct !{!61, !"scope"}
!62 = !{!63, !65, !67, !69, !54}
!63 = distinct !{!63, !64, !"scope"}
!64 = distinct !{!64, !"scope"}
!65 = distinct !{!65, !66, !"scope"}
!66 = distinct !{!66, !"scope"}
!67 = distinct !{!67, !68, !"scope"}
!68 = distinct !{!68, !"scope"}
!69 = distinct !{!69, !70, !"scope"}
!70 = distinct !{!70, !"scope"}
!71 = !{!65, !67, !69, !54}
!72 = !{!67, !69, !54}
!73 = !{!69, !54}
!74 = !{!75, !77, !54}
!75 = distinct !{!75, !76, !"scope"}
!76 = distinct !{!76, !"scope"}
!77 = distinct !{!77, !78, !"scope"}
!78 = distinct !{!78, !"scope"}
!79 = !{!80, !82, !84, !77, !54}
!80 = distinct !{!80, !81, !"scope"}
!81 = distinct !{!81, !"scope"}
!82 = distinct !{!82, !83, !"scope"}
!83 = distinct !{!83, !"scope"}
!84 = distinct !{!84, !85, !"scope"}
!85 = distinct !{!85, !"scope"}
!86 = !{!82, !84, !77, !54}
!87 = !{!88, !77, !54}
!88 = distinct !{!88, !89, !"scope"}
!89 = distinct !{!89, !"scope"}
!90 = !{!91, !93, !88, !77, !54}
!91 = distinct !{!91, !92, !"scope"}
!92 = distinct !{!92, !"scope"}
!93 = distinct !{!93, !94, !"scope"}
!94 = distinct !{!94, !"scope"}
!95 = !{!93, !88, !77, !54}
!96 = !{!97, !88, !77, !54}
!97 = distinct !{!97, !98, !"scope"}
!98 = distinct !{!98, !"scope"}
!99 = !{!100, !97, !88, !77, !54}
!100 = distinct !{!100, !101, !"scope"}
!101 = distinct !{!101, !"scope"}
!102 = !{!103, !88, !77, !54}
!103 = distinct !{!103, !104, !"scope"}
!104 = distinct !{!104, !"scope"}
!105 = !{!106, !108, !77, !54}
!106 = distinct !{!106, !107, !"scope"}
!107 = distinct !{!107, !"scope"}
!108 = distinct !{!108, !109, !"scope"}
!109 = distinct !{!109, !"scope"}
!110 = !{!77, !54}
!111 = !{!112, !77, !54}
!112 = distinct !{!112, !113, !"scope"}
!113 = distinct !{!113, !"scope"}
!114 = !{!115, !117, !119, !77, !54}
!115 = distinct !{!115, !116, !"scope"}
!116 = distinct !{!116, !"scope"}
!117 = distinct !{!117, !118, !"scope"}
!118 = distinct !{!118, !"scope"}
!119 = distinct !{!119, !120, !"scope"}
!120 = distinct !{!120, !"scope"}
!121 = !{!117, !119, !77, !54}
!122 = !{!123, !77, !54}
!123 = distinct !{!123, !124, !"scope"}
!124 = distinct !{!124, !"scope"}
!125 = !{!126, !128, !77, !54}
!126 = distinct !{!126, !127, !"scope"}
!127 = distinct !{!127, !"scope"}
!128 = distinct !{!128, !129, !"scope"}
!129 = distinct !{!129, !"scope"}
!130 = !{!128, !77, !54}
!131 = !{!132, !128, !77, !54}
!132 = distinct !{!132, !133, !"scope"}
!133 = distinct !{!133, !"scope"}
!134 = !{!135, !77, !54}
!135 = distinct !{!135, !136, !"scope"}
!136 = distinct !{!136, !"scope"}
!137 = !{!138, !140, !54}
!138 = distinct !{!138, !139, !"scope"}
!139 = distinct !{!139, !"scope"}
!140 = distinct !{!140, !141, !"scope"}
!141 = distinct !{!141, !"scope"}
!142 = !{!140, !54}
!143 = !{!144, !146, !148, !150, !54}
!144 = distinct !{!144, !145, !"scope"}
!145 = distinct !{!145, !"scope"}
!146 = distinct !{!146, !147, !"scope"}
!147 = distinct !{!147, !"scope"}
!148 = distinct !{!148, !149, !"scope"}
!149 = distinct !{!149, !"scope"}
!150 = distinct !{!150, !151, !"scope"}
!151 = distinct !{!151, !"scope"}
!152 = !{!146, !148, !150, !54}
!153 = !{!148, !150, !54}
!154 = !{!150, !54}
