; made from integrator.py, stepping.py, job.py, rosenbrock.py, sha256 e2a011bd484f385f4e5635c7af3fbbe24992e1657fde0dd134c4ac429d7c5b0d
@v46 = private unnamed_addr constant [4 x double] [double 3.860000e-01, double 2.100000e-01, double 6.300000e-01, double 1.000000e+00], align 8
define internal fastcc void @v47(ptr noalias nonnull writeonly %retptr, ptr readonly %arg.fields) unnamed_addr {
entry:
  %.648.i = alloca i8, align 1
  %.1307.i = alloca { i64, double }, align 8
  %.1528.i = alloca ptr, align 8
  %.1113.i.i = alloca { i64, double }, align 8
  %.1313.i.i = alloca double, align 8
  %.1437.i.i = alloca ptr, align 8
  %.3776.i = alloca i8, align 1
  %.476.i = alloca [38 x i64], align 8
  %.2785 = alloca i8, align 1
  store i8 0, ptr %.2785, align 1
  call void @llvm.lifetime.start.p0(ptr nonnull %.476.i)
  %.fca.1.gep.i = getelementptr inbounds i8, ptr %.476.i, i64 8
  %.fca.2.gep.i = getelementptr inbounds i8, ptr %.476.i, i64 16
  %.fca.3.gep.i = getelementptr inbounds i8, ptr %.476.i, i64 24
  %.fca.4.gep.i = getelementptr inbounds i8, ptr %.476.i, i64 32
  %.fca.5.gep.i = getelementptr inbounds i8, ptr %.476.i, i64 40
  %.fca.6.gep.i = getelementptr inbounds i8, ptr %.476.i, i64 48
  %.fca.7.gep.i = getelementptr inbounds i8, ptr %.476.i, i64 56
  %.fca.8.gep.i = getelementptr inbounds i8, ptr %.476.i, i64 64
  %.fca.9.gep.i = getelementptr inbounds i8, ptr %.476.i, i64 72
  %.fca.10.gep.i = getelementptr inbounds i8, ptr %.476.i, i64 80
  %.fca.11.gep.i = getelementptr inbounds i8, ptr %.476.i, i64 88
  %.fca.12.gep.i = getelementptr inbounds i8, ptr %.476.i, i64 96
  %.fca.13.gep.i = getelementptr inbounds i8, ptr %.476.i, i64 104
  %.fca.14.gep.i = getelementptr inbounds i8, ptr %.476.i, i64 112
  %.fca.15.gep.i = getelementptr inbounds i8, ptr %.476.i, i64 120
  %.fca.16.gep.i = getelementptr inbounds i8, ptr %.476.i, i64 128
  %.fca.17.gep.i = getelementptr inbounds i8, ptr %.476.i, i64 136
  %.fca.18.gep.i = getelementptr inbounds i8, ptr %.476.i, i64 144
  %.fca.19.gep.i = getelementptr inbounds i8, ptr %.476.i, i64 152
  %.fca.20.gep.i = getelementptr inbounds i8, ptr %.476.i, i64 160
  %.fca.21.gep.i = getelementptr inbounds i8, ptr %.476.i, i64 168
  %.fca.22.gep.i = getelementptr inbounds i8, ptr %.476.i, i64 176
  %.fca.23.gep.i = getelementptr inbounds i8, ptr %.476.i, i64 184
  %.fca.24.gep.i = getelementptr inbounds i8, ptr %.476.i, i64 192
  %.fca.25.gep.i = getelementptr inbounds i8, ptr %.476.i, i64 200
  %.fca.26.gep.i = getelementptr inbounds i8, ptr %.476.i, i64 208
  %.fca.27.gep.i = getelementptr inbounds i8, ptr %.476.i, i64 216
  %.fca.28.gep.i = getelementptr inbounds i8, ptr %.476.i, i64 224
  %.fca.29.gep.i = getelementptr inbounds i8, ptr %.476.i, i64 232
  %.fca.30.gep.i = getelementptr inbounds i8, ptr %.476.i, i64 240
  %.fca.31.gep.i = getelementptr inbounds i8, ptr %.476.i, i64 248
  %.fca.32.gep.i = getelementptr inbounds i8, ptr %.476.i, i64 256
  %.fca.33.gep.i = getelementptr inbounds i8, ptr %.476.i, i64 264
  %.fca.34.gep.i = getelementptr inbounds i8, ptr %.476.i, i64 272
  %.fca.35.gep.i = getelementptr inbounds i8, ptr %.476.i, i64 280
  %.fca.36.gep.i = getelementptr inbounds i8, ptr %.476.i, i64 288
  %.fca.37.gep.i = getelementptr inbounds i8, ptr %.476.i, i64 296
  br label %B38.if.i
B38.if.i:
  %out.2.sroa.0.0467.i = phi i64 [ undef, %entry ], [ %.481.fca.0.load.i, %B38.if.i ]
  %out.2.sroa.9.0466.i = phi i64 [ undef, %entry ], [ %.481.fca.1.load.i, %B38.if.i ]
  %out.2.sroa.18.0465.i = phi i64 [ undef, %entry ], [ %.481.fca.2.load.i, %B38.if.i ]
  %out.2.sroa.27.0464.i = phi i64 [ undef, %entry ], [ %.481.fca.3.load.i, %B38.if.i ]
  %out.2.sroa.36.0463.i = phi i64 [ undef, %entry ], [ %.481.fca.4.load.i, %B38.if.i ]
  %out.2.sroa.45.0462.i = phi i64 [ undef, %entry ], [ %.481.fca.5.load.i, %B38.if.i ]
  %out.2.sroa.54.0461.i = phi i64 [ undef, %entry ], [ %.481.fca.6.load.i, %B38.if.i ]
  %out.2.sroa.63.0460.i = phi i64 [ undef, %entry ], [ %.481.fca.7.load.i, %B38.if.i ]
  %out.2.sroa.72.0459.i = phi i64 [ undef, %entry ], [ %.481.fca.8.load.i, %B38.if.i ]
  %out.2.sroa.81.0458.i = phi i64 [ undef, %entry ], [ %.481.fca.9.load.i, %B38.if.i ]
  %out.2.sroa.90.0457.i = phi i64 [ undef, %entry ], [ %.481.fca.10.load.i, %B38.if.i ]
  %out.2.sroa.99.0456.i = phi i64 [ undef, %entry ], [ %.481.fca.11.load.i, %B38.if.i ]
  %out.2.sroa.108.0455.i = phi i64 [ undef, %entry ], [ %.481.fca.12.load.i, %B38.if.i ]
  %out.2.sroa.117.0454.i = phi i64 [ undef, %entry ], [ %.481.fca.13.load.i, %B38.if.i ]
  %out.2.sroa.126.0453.i = phi i64 [ undef, %entry ], [ %.481.fca.14.load.i, %B38.if.i ]
  %out.2.sroa.135.0452.i = phi i64 [ undef, %entry ], [ %.481.fca.15.load.i, %B38.if.i ]
  %out.2.sroa.144.0451.i = phi i64 [ undef, %entry ], [ %.481.fca.16.load.i, %B38.if.i ]
  %out.2.sroa.153.0450.i = phi i64 [ undef, %entry ], [ %.481.fca.17.load.i, %B38.if.i ]
  %out.2.sroa.162.0449.i = phi i64 [ undef, %entry ], [ %.481.fca.18.load.i, %B38.if.i ]
  %out.2.sroa.171.0448.i = phi i64 [ undef, %entry ], [ %.481.fca.19.load.i, %B38.if.i ]
  %out.2.sroa.180.0447.i = phi i64 [ undef, %entry ], [ %.481.fca.20.load.i, %B38.if.i ]
  %out.2.sroa.189.0446.i = phi i64 [ undef, %entry ], [ %.481.fca.21.load.i, %B38.if.i ]
  %out.2.sroa.198.0445.i = phi i64 [ undef, %entry ], [ %.481.fca.22.load.i, %B38.if.i ]
  %out.2.sroa.207.0444.i = phi i64 [ undef, %entry ], [ %.481.fca.23.load.i, %B38.if.i ]
  %out.2.sroa.216.0443.i = phi i64 [ undef, %entry ], [ %.481.fca.24.load.i, %B38.if.i ]
  %out.2.sroa.225.0442.i = phi i64 [ undef, %entry ], [ %.481.fca.25.load.i, %B38.if.i ]
  %out.2.sroa.234.0441.i = phi i64 [ undef, %entry ], [ %.481.fca.26.load.i, %B38.if.i ]
  %out.2.sroa.243.0440.i = phi i64 [ undef, %entry ], [ %.481.fca.27.load.i, %B38.if.i ]
  %out.2.sroa.252.0439.i = phi i64 [ undef, %entry ], [ %.481.fca.28.load.i, %B38.if.i ]
  %out.2.sroa.261.0438.i = phi i64 [ undef, %entry ], [ %.481.fca.29.load.i, %B38.if.i ]
  %out.2.sroa.270.0437.i = phi i64 [ undef, %entry ], [ %.481.fca.30.load.i, %B38.if.i ]
  %out.2.sroa.279.0436.i = phi i64 [ undef, %entry ], [ %.481.fca.31.load.i, %B38.if.i ]
  %out.2.sroa.288.0435.i = phi i64 [ undef, %entry ], [ %.481.fca.32.load.i, %B38.if.i ]
  %out.2.sroa.297.0434.i = phi i64 [ undef, %entry ], [ %.481.fca.33.load.i, %B38.if.i ]
  %out.2.sroa.306.0433.i = phi i64 [ undef, %entry ], [ %.481.fca.34.load.i, %B38.if.i ]
  %out.2.sroa.315.0432.i = phi i64 [ undef, %entry ], [ %.481.fca.35.load.i, %B38.if.i ]
  %out.2.sroa.324.0431.i = phi i64 [ undef, %entry ], [ %.481.fca.36.load.i, %B38.if.i ]
  %out.2.sroa.333.0430.i = phi i64 [ undef, %entry ], [ %.481.fca.37.load.i, %B38.if.i ]
  %.349.0428.i = phi i64 [ 0, %entry ], [ %.420.i, %B38.if.i ]
  %.420.i = add nuw nsw i64 %.349.0428.i, 1
  %0 = getelementptr i64, ptr %arg.fields, i64 %.349.0428.i
  %.474.i = load i64, ptr %0, align 8, !noalias !0
  store i64 %out.2.sroa.0.0467.i, ptr %.476.i, align 8, !noalias !0
  store i64 %out.2.sroa.9.0466.i, ptr %.fca.1.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.18.0465.i, ptr %.fca.2.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.27.0464.i, ptr %.fca.3.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.36.0463.i, ptr %.fca.4.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.45.0462.i, ptr %.fca.5.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.54.0461.i, ptr %.fca.6.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.63.0460.i, ptr %.fca.7.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.72.0459.i, ptr %.fca.8.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.81.0458.i, ptr %.fca.9.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.90.0457.i, ptr %.fca.10.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.99.0456.i, ptr %.fca.11.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.108.0455.i, ptr %.fca.12.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.117.0454.i, ptr %.fca.13.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.126.0453.i, ptr %.fca.14.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.135.0452.i, ptr %.fca.15.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.144.0451.i, ptr %.fca.16.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.153.0450.i, ptr %.fca.17.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.162.0449.i, ptr %.fca.18.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.171.0448.i, ptr %.fca.19.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.180.0447.i, ptr %.fca.20.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.189.0446.i, ptr %.fca.21.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.198.0445.i, ptr %.fca.22.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.207.0444.i, ptr %.fca.23.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.216.0443.i, ptr %.fca.24.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.225.0442.i, ptr %.fca.25.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.234.0441.i, ptr %.fca.26.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.243.0440.i, ptr %.fca.27.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.252.0439.i, ptr %.fca.28.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.261.0438.i, ptr %.fca.29.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.270.0437.i, ptr %.fca.30.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.279.0436.i, ptr %.fca.31.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.288.0435.i, ptr %.fca.32.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.297.0434.i, ptr %.fca.33.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.306.0433.i, ptr %.fca.34.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.315.0432.i, ptr %.fca.35.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.324.0431.i, ptr %.fca.36.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.333.0430.i, ptr %.fca.37.gep.i, align 8, !noalias !0
  %.479.i = getelementptr inbounds i64, ptr %.476.i, i64 %.349.0428.i
  store i64 %.474.i, ptr %.479.i, align 8, !noalias !0
  %.481.fca.0.load.i = load i64, ptr %.476.i, align 8, !noalias !0
  %.481.fca.1.load.i = load i64, ptr %.fca.1.gep.i, align 8, !noalias !0
  %.481.fca.2.load.i = load i64, ptr %.fca.2.gep.i, align 8, !noalias !0
  %.481.fca.3.load.i = load i64, ptr %.fca.3.gep.i, align 8, !noalias !0
  %.481.fca.4.load.i = load i64, ptr %.fca.4.gep.i, align 8, !noalias !0
  %.481.fca.5.load.i = load i64, ptr %.fca.5.gep.i, align 8, !noalias !0
  %.481.fca.6.load.i = load i64, ptr %.fca.6.gep.i, align 8, !noalias !0
  %.481.fca.7.load.i = load i64, ptr %.fca.7.gep.i, align 8, !noalias !0
  %.481.fca.8.load.i = load i64, ptr %.fca.8.gep.i, align 8, !noalias !0
  %.481.fca.9.load.i = load i64, ptr %.fca.9.gep.i, align 8, !noalias !0
  %.481.fca.10.load.i = load i64, ptr %.fca.10.gep.i, align 8, !noalias !0
  %.481.fca.11.load.i = load i64, ptr %.fca.11.gep.i, align 8, !noalias !0
  %.481.fca.12.load.i = load i64, ptr %.fca.12.gep.i, align 8, !noalias !0
  %.481.fca.13.load.i = load i64, ptr %.fca.13.gep.i, align 8, !noalias !0
  %.481.fca.14.load.i = load i64, ptr %.fca.14.gep.i, align 8, !noalias !0
  %.481.fca.15.load.i = load i64, ptr %.fca.15.gep.i, align 8, !noalias !0
  %.481.fca.16.load.i = load i64, ptr %.fca.16.gep.i, align 8, !noalias !0
  %.481.fca.17.load.i = load i64, ptr %.fca.17.gep.i, align 8, !noalias !0
  %.481.fca.18.load.i = load i64, ptr %.fca.18.gep.i, align 8, !noalias !0
  %.481.fca.19.load.i = load i64, ptr %.fca.19.gep.i, align 8, !noalias !0
  %.481.fca.20.load.i = load i64, ptr %.fca.20.gep.i, align 8, !noalias !0
  %.481.fca.21.load.i = load i64, ptr %.fca.21.gep.i, align 8, !noalias !0
  %.481.fca.22.load.i = load i64, ptr %.fca.22.gep.i, align 8, !noalias !0
  %.481.fca.23.load.i = load i64, ptr %.fca.23.gep.i, align 8, !noalias !0
  %.481.fca.24.load.i = load i64, ptr %.fca.24.gep.i, align 8, !noalias !0
  %.481.fca.25.load.i = load i64, ptr %.fca.25.gep.i, align 8, !noalias !0
  %.481.fca.26.load.i = load i64, ptr %.fca.26.gep.i, align 8, !noalias !0
  %.481.fca.27.load.i = load i64, ptr %.fca.27.gep.i, align 8, !noalias !0
  %.481.fca.28.load.i = load i64, ptr %.fca.28.gep.i, align 8, !noalias !0
  %.481.fca.29.load.i = load i64, ptr %.fca.29.gep.i, align 8, !noalias !0
  %.481.fca.30.load.i = load i64, ptr %.fca.30.gep.i, align 8, !noalias !0
  %.481.fca.31.load.i = load i64, ptr %.fca.31.gep.i, align 8, !noalias !0
  %.481.fca.32.load.i = load i64, ptr %.fca.32.gep.i, align 8, !noalias !0
  %.481.fca.33.load.i = load i64, ptr %.fca.33.gep.i, align 8, !noalias !0
  %.481.fca.34.load.i = load i64, ptr %.fca.34.gep.i, align 8, !noalias !0
  %.481.fca.35.load.i = load i64, ptr %.fca.35.gep.i, align 8, !noalias !0
  %.481.fca.36.load.i = load i64, ptr %.fca.36.gep.i, align 8, !noalias !0
  %.481.fca.37.load.i = load i64, ptr %.fca.37.gep.i, align 8, !noalias !0
  %exitcond.not.i = icmp eq i64 %.420.i, 38
  br i1 %exitcond.not.i, label %b52, label %B38.if.i
b52:
  call void @llvm.lifetime.end.p0(ptr nonnull %.476.i)
  %.163.i = add nsw i64 %.481.fca.10.load.i, %.481.fca.9.load.i
  %.297.i = mul nsw i64 %.481.fca.5.load.i, 12
  %.298.i = mul nsw i64 %.481.fca.7.load.i, 6
  %.299.i = add i64 %.481.fca.11.load.i, %.481.fca.10.load.i
  %.300.i = or i64 %.297.i, 2
  %.301.i = add i64 %.300.i, %.298.i
  %.302.i = add i64 %.301.i, %.481.fca.8.load.i
  %.307.i = add i64 %.302.i, %.299.i
  %.309.i = add nsw i64 %.307.i, %.481.fca.12.load.i
  %.311.i = add nsw i64 %.309.i, %.481.fca.13.load.i
  %.397.i = icmp slt i64 %.311.i, 1
  br i1 %.397.i, label %B0.endif.endif.endif.endif.else.endif.if.i, label %B0.endif.endif.endif.endif.else.endif.endif.i, !prof !3
B0.endif.endif.endif.endif.endif.i:
  %.377.sroa.13.0.i = phi i64 [ %.311.i, %B0.endif.endif.endif.endif.else.endif.endif.endif.if.i ], [ %.377.sroa.13.1.i, %B0.endif.endif.endif.endif.else.endif.endif.endif.i ]
  %.465.i = sub i64 %.377.sroa.13.0.i, %.377.sroa.0.3.i
  %.474.i5406 = tail call i64 @llvm.smax.i64(i64 %.465.i, i64 0)
  br i1 %.409.i, label %B0.endif.endif.endif.endif.endif.else.if.i, label %B0.endif.endif.endif.endif.endif.else.endif.i, !prof !3
B0.endif.endif.endif.endif.else.endif.if.i:
  br label %B0.endif.endif.endif.endif.else.endif.endif.i
B0.endif.endif.endif.endif.else.endif.endif.i:
  %.377.sroa.0.3.i = phi i64 [ %.311.i, %B0.endif.endif.endif.endif.else.endif.if.i ], [ 0, %b52 ]
  %.404.i = icmp slt i64 %.481.fca.5.load.i, 0
  %.405.i = select i1 %.404.i, i64 %.311.i, i64 0
  %.406.i = add i64 %.405.i, %.297.i
  %.409.i = icmp slt i64 %.406.i, 0
  br i1 %.409.i, label %B0.endif.endif.endif.endif.else.endif.endif.if.i, label %B0.endif.endif.endif.endif.else.endif.endif.endif.i, !prof !3
B0.endif.endif.endif.endif.else.endif.endif.if.i:
  br label %B0.endif.endif.endif.endif.else.endif.endif.endif.i
B0.endif.endif.endif.endif.else.endif.endif.endif.i:
  %.377.sroa.13.1.i = phi i64 [ 0, %B0.endif.endif.endif.endif.else.endif.endif.if.i ], [ %.406.i, %B0.endif.endif.endif.endif.else.endif.endif.i ]
  %.414.not.i = icmp slt i64 %.406.i, %.311.i
  br i1 %.414.not.i, label %B0.endif.endif.endif.endif.endif.i, label %B0.endif.endif.endif.endif.else.endif.endif.endif.if.i, !prof !4
B0.endif.endif.endif.endif.else.endif.endif.endif.if.i:
  br label %B0.endif.endif.endif.endif.endif.i
B0.endif.endif.endif.endif.endif.else.if.i:
  br label %B0.endif.endif.endif.endif.endif.else.endif.i
B0.endif.endif.endif.endif.endif.else.endif.i:
  %.548.sroa.0.1.i = phi i64 [ 0, %B0.endif.endif.endif.endif.endif.else.if.i ], [ %.406.i, %B0.endif.endif.endif.endif.endif.i ]
  br i1 %.414.not.i, label %B0.endif.endif.endif.endi...if.i, label %B0.endif.endif.endif.endif.endif.else.endif.if.i, !prof !4
B0.endif.endif.endif.endif.endif.else.endif.if.i:
  br label %B0.endif.endif.endif.endi...if.i
B0.endif.endif.endif.endi...if.i:
  %.548.sroa.0.3.i = phi i64 [ %.311.i, %B0.endif.endif.endif.endif.endif.else.endif.if.i ], [ %.548.sroa.0.1.i, %B0.endif.endif.endif.endif.endif.else.endif.i ]
  %.636.i = sub i64 %.311.i, %.548.sroa.0.3.i
  %.645.i = tail call i64 @llvm.smax.i64(i64 %.636.i, i64 0)
  %.747.i = icmp slt i64 %.636.i, 1
  br i1 %.747.i, label %B0.endif.endif.endif.endif.endif.endif.else.endif.if.i, label %B0.endif.endif.endif.endif.endif.endif.else.endif.endif.i, !prof !3
B0.endif.endif.endif.endif.endif.endif.else.endif.if.i:
  br label %B0.endif.endif.endif.endif.endif.endif.else.endif.endif.i
B0.endif.endif.endif.endif.endif.endif.else.endif.endif.i:
  %.727.sroa.0.3.i = phi i64 [ %.645.i, %B0.endif.endif.endif.endif.endif.endif.else.endif.if.i ], [ 0, %B0.endif.endif.endif.endi...if.i ]
  %.754.i = icmp slt i64 %.481.fca.7.load.i, 0
  %.755.i = select i1 %.754.i, i64 %.645.i, i64 0
  %.756.i = add i64 %.755.i, %.481.fca.7.load.i
  %.759.i = icmp slt i64 %.756.i, 0
  br i1 %.759.i, label %B0.endif.endif.endif.endi...endif.4.i, label %B0.endif.endif.endif.endi...endif.2.thread.i, !prof !3
B0.endif.endif.endif.endi...endif.2.thread.i:
  %.764.not1965.i = icmp sgt i64 %.636.i, %.756.i
  br i1 %.764.not1965.i, label %B0.endif.endif.endif.endif.endif.endif.endif.else.endif.thread.i, label %B0.endif.endif.endif.endi...if.4.i, !prof !4
B0.endif.endif.endif.endif.endif.endif.endif.else.endif.thread.i:
  %.8151972.i = sub nsw i64 %.756.i, %.727.sroa.0.3.i
  %.8241973.i = tail call i64 @llvm.smax.i64(i64 %.8151972.i, i64 0)
  br label %B0.endif.endif.endif.endi...endif.4.i
B0.endif.endif.endif.endi...if.4.i:
  %.8151957.i = sub nsw i64 %.645.i, %.727.sroa.0.3.i
  %.8241958.i = tail call i64 @llvm.smax.i64(i64 %.8151957.i, i64 0)
  br label %B0.endif.endif.endif.endi...endif.4.i
B0.endif.endif.endif.endi...endif.4.i:
  %.82419612000.i = phi i64 [ %.8241958.i, %B0.endif.endif.endif.endi...if.4.i ], [ %.8241973.i, %B0.endif.endif.endif.endif.endif.endif.endif.else.endif.thread.i ], [ 0, %B0.endif.endif.endif.endif.endif.endif.else.endif.endif.i ]
  %.898.sroa.0.3.i = phi i64 [ %.645.i, %B0.endif.endif.endif.endi...if.4.i ], [ %.756.i, %B0.endif.endif.endif.endif.endif.endif.endif.else.endif.thread.i ], [ 0, %B0.endif.endif.endif.endif.endif.endif.else.endif.endif.i ]
  %.87219631998.i = mul nsw i64 %.481.fca.7.load.i, 5
  %.927.i = add i64 %.755.i, %.87219631998.i
  %.930.i = icmp slt i64 %.927.i, 0
  br i1 %.930.i, label %B0.endif.endif.endif.endi...endif.6.endif.i, label %B0.endif.endif.endif.endi...endif.4.endif.thread.i, !prof !3
B0.endif.endif.endif.endi...endif.4.endif.thread.i:
  %.935.not1983.i = icmp sgt i64 %.636.i, %.927.i
  br i1 %.935.not1983.i, label %B0.endif.endif.endif.endi...endif.6.thread.i, label %B0.endif.endif.endif.endi...endif.6.if.i, !prof !4
B0.endif.endif.endif.endi...endif.6.thread.i:
  %.9861990.i = sub nsw i64 %.927.i, %.898.sroa.0.3.i
  %.9951991.i = tail call i64 @llvm.smax.i64(i64 %.9861990.i, i64 0)
  br label %B0.endif.endif.endif.endi...endif.6.endif.i
B0.endif.endif.endif.endi...endif.6.if.i:
  %.9861977.i = sub nsw i64 %.645.i, %.898.sroa.0.3.i
  %.9951978.i = tail call i64 @llvm.smax.i64(i64 %.9861977.i, i64 0)
  br label %B0.endif.endif.endif.endi...endif.6.endif.i
B0.endif.endif.endif.endi...endif.6.endif.i:
  %.99519802032.i = phi i64 [ %.9951978.i, %B0.endif.endif.endif.endi...endif.6.if.i ], [ %.9951991.i, %B0.endif.endif.endif.endi...endif.6.thread.i ], [ 0, %B0.endif.endif.endif.endi...endif.4.i ]
  %.1070.sroa.0.3.i = phi i64 [ %.645.i, %B0.endif.endif.endif.endi...endif.6.if.i ], [ %.927.i, %B0.endif.endif.endif.endi...endif.6.thread.i ], [ 0, %B0.endif.endif.endif.endi...endif.4.i ]
  %.1099.i = add i64 %.755.i, %.298.i
  %.1102.i = icmp slt i64 %.1099.i, 0
  br i1 %.1102.i, label %B0.endif.endif.endif.endi...else.endif.endif.endif.if.i, label %B0.endif.endif.endif.endi...endif.6.endif.endif.thread.i, !prof !3
B0.endif.endif.endif.endi...endif.6.endif.endif.thread.i:
  %.1107.not2017.i = icmp sgt i64 %.636.i, %.1099.i
  br i1 %.1107.not2017.i, label %B0.endif.endif.endif.endi...else.endif.thread.i, label %B0.endif.endif.endif.endi...else.endif.if.i, !prof !4
B0.endif.endif.endif.endi...else.endif.thread.i:
  %.11582024.i = sub nsw i64 %.1099.i, %.1070.sroa.0.3.i
  %.11672025.i = tail call i64 @llvm.smax.i64(i64 %.11582024.i, i64 0)
  br label %B0.endif.endif.endif.endi...else.endif.endif.endif.if.i
B0.endif.endif.endif.endi...else.endif.if.i:
  %.11582011.i = sub nsw i64 %.645.i, %.1070.sroa.0.3.i
  %.11672012.i = tail call i64 @llvm.smax.i64(i64 %.11582011.i, i64 0)
  br label %B0.endif.endif.endif.endi...else.endif.endif.endif.if.i
B0.endif.endif.endif.endi...else.endif.endif.endif.if.i:
  %.116720142045.i = phi i64 [ %.11672012.i, %B0.endif.endif.endif.endi...else.endif.if.i ], [ %.11672025.i, %B0.endif.endif.endif.endi...else.endif.thread.i ], [ 0, %B0.endif.endif.endif.endi...endif.6.endif.i ]
  %.1241.sroa.0.3.i = phi i64 [ %.645.i, %B0.endif.endif.endif.endi...else.endif.if.i ], [ %.1099.i, %B0.endif.endif.endif.endi...else.endif.thread.i ], [ 0, %B0.endif.endif.endif.endi...endif.6.endif.i ]
  %.1329.i = sub nsw i64 %.645.i, %.1241.sroa.0.3.i
  %.1338.i = tail call i64 @llvm.smax.i64(i64 %.1329.i, i64 0)
  %1 = tail call i64 @llvm.umin.i64(i64 %.1338.i, i64 2)
  %.16802062.i = add nsw i64 %.481.fca.12.load.i, 2
  %.1733.i = icmp slt i64 %.481.fca.12.load.i, -2
  %.1734.i = select i1 %.1733.i, i64 %.1338.i, i64 0
  %.1735.i = add i64 %.16802062.i, %.1734.i
  %.1738.i = icmp slt i64 %.1735.i, 0
  %.1743.not2071.i = icmp sgt i64 %.1329.i, %.1735.i
  %.1735.i..1338.i = select i1 %.1743.not2071.i, i64 %.1735.i, i64 %.1338.i, !prof !4
  %.1878.sroa.0.3.i = select i1 %.1738.i, i64 0, i64 %.1735.i..1338.i, !prof !3
  %.1966.i = sub nsw i64 %.1338.i, %.1878.sroa.0.3.i
  %.1975.i = tail call i64 @llvm.smax.i64(i64 %.1966.i, i64 0)
  %.2084.i = icmp slt i64 %.1966.i, 1
  br i1 %.2084.i, label %B0.endif.endif.endif.endi...else.1.endif.if.i, label %B0.endif.endif.endif.endi...else.1.endif.endif.i, !prof !3
B0.endif.endif.endif.endi...else.1.endif.if.i:
  br label %B0.endif.endif.endif.endi...else.1.endif.endif.i
B0.endif.endif.endif.endi...else.1.endif.endif.i:
  %.2064.sroa.0.3.i = phi i64 [ %.1975.i, %B0.endif.endif.endif.endi...else.1.endif.if.i ], [ 0, %B0.endif.endif.endif.endi...else.endif.endif.endif.if.i ]
  %.2091.i = icmp slt i64 %.481.fca.13.load.i, 0
  %.2092.i = select i1 %.2091.i, i64 %.1975.i, i64 0
  %.2093.i = add i64 %.2092.i, %.481.fca.13.load.i
  %.2096.i = icmp slt i64 %.2093.i, 0
  %.2101.not2094.i = icmp sgt i64 %.1966.i, %.2093.i
  %.2093.i..1975.i = select i1 %.2101.not2094.i, i64 %.2093.i, i64 %.1975.i, !prof !4
  %.2235.sroa.0.3.i = select i1 %.2096.i, i64 0, i64 %.2093.i..1975.i, !prof !3
  %.2323.i = sub nsw i64 %.1975.i, %.2235.sroa.0.3.i
  %.2332.i = tail call i64 @llvm.smax.i64(i64 %.2323.i, i64 0)
  %.2434.i = icmp slt i64 %.2323.i, 1
  br i1 %.2434.i, label %B0.endif.endif.endif.endi...if.20.i, label %B0.endif.endif.endif.endi...endif.20.i, !prof !3
B0.endif.endif.endif.endi...if.20.i:
  br label %B0.endif.endif.endif.endi...endif.20.i
B0.endif.endif.endif.endi...endif.20.i:
  %.2414.sroa.0.3.i = phi i64 [ %.2332.i, %B0.endif.endif.endif.endi...if.20.i ], [ 0, %B0.endif.endif.endif.endi...else.1.endif.endif.i ]
  %.2441.i = icmp slt i64 %.481.fca.11.load.i, 0
  %.2442.i = select i1 %.2441.i, i64 %.2332.i, i64 0
  %.2443.i = add i64 %.2442.i, %.481.fca.11.load.i
  %.2446.i = icmp slt i64 %.2443.i, 0
  br i1 %.2446.i, label %B0.endif.endif.endif.endi...endif.22.endif.i, label %B0.endif.endif.endif.endi...endif.20.endif.thread.i, !prof !3
B0.endif.endif.endif.endi...endif.20.endif.thread.i:
  %.2451.not2126.i = icmp sgt i64 %.2323.i, %.2443.i
  br i1 %.2451.not2126.i, label %B0.endif.endif.endif.endi...endif.22.thread.i, label %B0.endif.endif.endif.endi...endif.22.if.i, !prof !4
B0.endif.endif.endif.endi...endif.22.thread.i:
  %.25022133.i = sub nsw i64 %.2443.i, %.2414.sroa.0.3.i
  %.25112134.i = tail call i64 @llvm.smax.i64(i64 %.25022133.i, i64 0)
  br label %B0.endif.endif.endif.endi...endif.22.endif.i
B0.endif.endif.endif.endi...endif.22.if.i:
  %.25022118.i = sub nsw i64 %.2332.i, %.2414.sroa.0.3.i
  %.25112119.i = tail call i64 @llvm.smax.i64(i64 %.25022118.i, i64 0)
  br label %B0.endif.endif.endif.endi...endif.22.endif.i
B0.endif.endif.endif.endi...endif.22.endif.i:
  %.251121222161.i = phi i64 [ %.25112119.i, %B0.endif.endif.endif.endi...endif.22.if.i ], [ %.25112134.i, %B0.endif.endif.endif.endi...endif.22.thread.i ], [ 0, %B0.endif.endif.endif.endi...endif.20.i ]
  %.2585.sroa.0.3.i = phi i64 [ %.2332.i, %B0.endif.endif.endif.endi...endif.22.if.i ], [ %.2443.i, %B0.endif.endif.endif.endi...endif.22.thread.i ], [ 0, %B0.endif.endif.endif.endi...endif.20.i ]
  %.2612.i = icmp slt i64 %.299.i, 0
  %.2613.i = select i1 %.2612.i, i64 %.2332.i, i64 0
  %.2614.i = add i64 %.2613.i, %.299.i
  %.2617.i = icmp slt i64 %.2614.i, 0
  %.2622.not2144.i = icmp sgt i64 %.2323.i, %.2614.i
  %.2614.i..2332.i = select i1 %.2622.not2144.i, i64 %.2614.i, i64 %.2332.i, !prof !4
  %.2756.sroa.0.3.i = select i1 %.2617.i, i64 0, i64 %.2614.i..2332.i, !prof !3
  %.2961.i = icmp slt i64 %.465.i, 1
  br i1 %.2961.i, label %B0.endif.endif.endif.endi...endif.24.else.endif.if.i, label %B0.endif.endif.endif.endi...endif.24.else.endif.endif.i, !prof !3
B0.endif.endif.endif.endi...endif.24.else.endif.if.i:
  br label %B0.endif.endif.endif.endi...endif.24.else.endif.endif.i
B0.endif.endif.endif.endi...endif.24.else.endif.endif.i:
  %.2941.sroa.0.3.i = phi i64 [ %.474.i5406, %B0.endif.endif.endif.endi...endif.24.else.endif.if.i ], [ 0, %B0.endif.endif.endif.endi...endif.22.endif.i ]
  %.2969.i = select i1 %.404.i, i64 %.474.i5406, i64 0
  %.2970.i = add i64 %.2969.i, %.481.fca.5.load.i
  %.2973.i = icmp slt i64 %.2970.i, 0
  %.2978.not2193.i = icmp sgt i64 %.465.i, %.2970.i
  %.2970.i..474.i5406 = select i1 %.2978.not2193.i, i64 %.2970.i, i64 %.474.i5406, !prof !4
  %.3112.sroa.0.3.i = select i1 %.2973.i, i64 0, i64 %.2970.i..474.i5406, !prof !3
  %.308621912209.i = shl nsw i64 %.481.fca.5.load.i, 1
  %.3141.i = add i64 %.2969.i, %.308621912209.i
  %.3144.i = icmp slt i64 %.3141.i, 0
  br i1 %.3144.i, label %B0.endif.endif.endif.endi...endif.29.if.i, label %B0.endif.endif.endif.endi...endif.29.endif.i, !prof !3
B0.endif.endif.endif.endi...endif.24.endif.endif.i:
  %.3112.sroa.13.0.i = phi i64 [ %.474.i5406, %B0.endif.endif.endif.endi...endif.29.endif.if.i ], [ %.3112.sroa.13.1.i, %B0.endif.endif.endif.endi...endif.29.endif.i ]
  %.3257.i = mul nsw i64 %.481.fca.5.load.i, 6
  %.3295.i = add i64 %.2969.i, %.3257.i
  %.3298.i = icmp slt i64 %.3295.i, 0
  br i1 %.3298.i, label %B0.endif.endif.endif.endi...if.31.i, label %B0.endif.endif.endif.endi...endif.31.i, !prof !3
B0.endif.endif.endif.endi...endif.29.if.i:
  br label %B0.endif.endif.endif.endi...endif.29.endif.i
B0.endif.endif.endif.endi...endif.29.endif.i:
  %.3112.sroa.13.1.i = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.29.if.i ], [ %.3141.i, %B0.endif.endif.endif.endi...endif.24.else.endif.endif.i ]
  %.3149.not.i = icmp slt i64 %.3141.i, %.474.i5406
  br i1 %.3149.not.i, label %B0.endif.endif.endif.endi...endif.24.endif.endif.i, label %B0.endif.endif.endif.endi...endif.29.endif.if.i, !prof !4
B0.endif.endif.endif.endi...endif.29.endif.if.i:
  br label %B0.endif.endif.endif.endi...endif.24.endif.endif.i
B0.endif.endif.endif.endi...if.31.i:
  br label %B0.endif.endif.endif.endi...endif.31.i
B0.endif.endif.endif.endi...endif.31.i:
  %.3283.sroa.0.1.i = phi i64 [ 0, %B0.endif.endif.endif.endi...if.31.i ], [ %.3295.i, %B0.endif.endif.endif.endi...endif.24.endif.endif.i ]
  %.3303.not.i = icmp slt i64 %.3295.i, %.474.i5406
  br i1 %.3303.not.i, label %B0.endif.endif.endif.endi...endif.31.endif.endif.if.i, label %B0.endif.endif.endif.endi...endif.31.if.i, !prof !4
B0.endif.endif.endif.endi...endif.31.if.i:
  br label %B0.endif.endif.endif.endi...endif.31.endif.endif.if.i
B0.endif.endif.endif.endi...endif.31.endif.endif.if.i:
  %.3283.sroa.0.3.i = phi i64 [ %.474.i5406, %B0.endif.endif.endif.endi...endif.31.if.i ], [ %.3283.sroa.0.1.i, %B0.endif.endif.endif.endi...endif.31.i ]
  %.3428.i = mul nsw i64 %.481.fca.5.load.i, 11
  %.3466.i = add i64 %.2969.i, %.3428.i
  %.3469.i = icmp slt i64 %.3466.i, 0
  br i1 %.3469.i, label %B0.endif.endif.endif.endi...else.3.if.i, label %B0.endif.endif.endif.endi...else.3.endif.i, !prof !3
B0.endif.endif.endif.endi...else.3.if.i:
  br label %B0.endif.endif.endif.endi...else.3.endif.i
B0.endif.endif.endif.endi...else.3.endif.i:
  %.3454.sroa.0.1.i = phi i64 [ 0, %B0.endif.endif.endif.endi...else.3.if.i ], [ %.3466.i, %B0.endif.endif.endif.endi...endif.31.endif.endif.if.i ]
  %.3474.not.i = icmp slt i64 %.3466.i, %.474.i5406
  br i1 %.3474.not.i, label %B0.endif.endif.endif.endi...if.34.i, label %B0.endif.endif.endif.endi...else.3.endif.if.i, !prof !4
B0.endif.endif.endif.endi...else.3.endif.if.i:
  br label %B0.endif.endif.endif.endi...if.34.i
B0.endif.endif.endif.endi...if.34.i:
  %.3454.sroa.0.3.i = phi i64 [ %.474.i5406, %B0.endif.endif.endif.endi...else.3.endif.if.i ], [ %.3454.sroa.0.1.i, %B0.endif.endif.endif.endi...else.3.endif.i ]
  %.3600.i = mul nsw i64 %.481.fca.5.load.i, 3
  br i1 %.3144.i, label %B0.endif.endif.endif.endi...endif.33.else.if.i, label %B0.endif.endif.endif.endi...endif.33.else.endif.i, !prof !3
B0.endif.endif.endif.endi...endif.33.else.if.i:
  br label %B0.endif.endif.endif.endi...endif.33.else.endif.i
B0.endif.endif.endif.endi...endif.33.else.endif.i:
  %.3626.sroa.0.1.i = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.33.else.if.i ], [ %.3141.i, %B0.endif.endif.endif.endi...if.34.i ]
  br i1 %.3149.not.i, label %B0.endif.endif.endif.endi...endif.33.else.endif.endif.i, label %B0.endif.endif.endif.endi...endif.33.else.endif.if.i, !prof !4
B0.endif.endif.endif.endi...endif.33.else.endif.if.i:
  br label %B0.endif.endif.endif.endi...endif.33.else.endif.endif.i
B0.endif.endif.endif.endi...endif.33.else.endif.endif.i:
  %.3626.sroa.0.3.i = phi i64 [ %.474.i5406, %B0.endif.endif.endif.endi...endif.33.else.endif.if.i ], [ %.3626.sroa.0.1.i, %B0.endif.endif.endif.endi...endif.33.else.endif.i ]
  %.3655.i = add i64 %.2969.i, %.3600.i
  %.3658.i = icmp slt i64 %.3655.i, 0
  %.3663.not.i = icmp slt i64 %.3655.i, %.474.i5406
  %.3771.i = shl nsw i64 %.481.fca.5.load.i, 2
  %.3810.i = add i64 %.2969.i, %.3771.i
  %.3813.i = icmp slt i64 %.3810.i, 0
  br i1 %.3813.i, label %B0.endif.endif.endif.endi...endif.33.endif.else.if.i, label %B0.endif.endif.endif.endi...endif.33.endif.else.endif.i, !prof !3
B0.endif.endif.endif.endi...endif.33.endif.endif.i:
  %.3798.sroa.13.0.i = phi i64 [ %.474.i5406, %B0.endif.endif.endif.endi...endif.38.endif.if.i ], [ %.3798.sroa.13.1.i, %B0.endif.endif.endif.endi...endif.38.endif.i ]
  br i1 %.3658.i, label %B0.endif.endif.endif.endi...if.40.i, label %B0.endif.endif.endif.endi...endif.40.i, !prof !3
B0.endif.endif.endif.endi...endif.33.endif.else.if.i:
  br label %B0.endif.endif.endif.endi...endif.33.endif.else.endif.i
B0.endif.endif.endif.endi...endif.33.endif.else.endif.i:
  %.3798.sroa.0.1.i = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.33.endif.else.if.i ], [ %.3810.i, %B0.endif.endif.endif.endi...endif.33.else.endif.endif.i ]
  %.3818.not.i = icmp slt i64 %.3810.i, %.474.i5406
  br i1 %.3818.not.i, label %B0.endif.endif.endif.endi...endif.38.i, label %B0.endif.endif.endif.endi...if.38.i, !prof !4
B0.endif.endif.endif.endi...if.38.i:
  br label %B0.endif.endif.endif.endi...endif.38.i
B0.endif.endif.endif.endi...endif.38.i:
  %.3798.sroa.0.3.i = phi i64 [ %.474.i5406, %B0.endif.endif.endif.endi...if.38.i ], [ %.3798.sroa.0.1.i, %B0.endif.endif.endif.endi...endif.33.endif.else.endif.i ]
  br i1 %.3298.i, label %B0.endif.endif.endif.endi...endif.38.if.i, label %B0.endif.endif.endif.endi...endif.38.endif.i, !prof !3
B0.endif.endif.endif.endi...endif.38.if.i:
  br label %B0.endif.endif.endif.endi...endif.38.endif.i
B0.endif.endif.endif.endi...endif.38.endif.i:
  %.3798.sroa.13.1.i = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.38.if.i ], [ %.3295.i, %B0.endif.endif.endif.endi...endif.38.i ]
  br i1 %.3303.not.i, label %B0.endif.endif.endif.endi...endif.33.endif.endif.i, label %B0.endif.endif.endif.endi...endif.38.endif.if.i, !prof !4
B0.endif.endif.endif.endi...endif.38.endif.if.i:
  br label %B0.endif.endif.endif.endi...endif.33.endif.endif.i
B0.endif.endif.endif.endi...endif.33.endif.endif.endif.i:
  %.3970.sroa.13.0.i = phi i64 [ %.474.i5406, %B0.endif.endif.endif.endi...endif.40.endif.endif.if.i ], [ %.3970.sroa.13.1.i, %B0.endif.endif.endif.endi...endif.40.endif.endif.i ]
  %.4273.i = icmp slt i64 %.481.fca.9.load.i, 0
  %.4274.i = select i1 %.4273.i, i64 %.163.i, i64 0
  %.4275.i = add i64 %.4274.i, %.481.fca.9.load.i
  %.4278.i = icmp slt i64 %.4275.i, 0
  br i1 %.4278.i, label %B0.endif.endif.endif.endi...else.4.if.i, label %B0.endif.endif.endif.endi...else.4.endif.i, !prof !3
B0.endif.endif.endif.endi...if.40.i:
  br label %B0.endif.endif.endif.endi...endif.40.i
B0.endif.endif.endif.endi...endif.40.i:
  %.3970.sroa.0.1.i = phi i64 [ 0, %B0.endif.endif.endif.endi...if.40.i ], [ %.3655.i, %B0.endif.endif.endif.endi...endif.33.endif.endif.i ]
  br i1 %.3663.not.i, label %B0.endif.endif.endif.endi...endif.40.endif.i, label %B0.endif.endif.endif.endi...endif.40.if.i, !prof !4
B0.endif.endif.endif.endi...endif.40.if.i:
  br label %B0.endif.endif.endif.endi...endif.40.endif.i
B0.endif.endif.endif.endi...endif.40.endif.i:
  %.3970.sroa.0.3.i = phi i64 [ %.474.i5406, %B0.endif.endif.endif.endi...endif.40.if.i ], [ %.3970.sroa.0.1.i, %B0.endif.endif.endif.endi...endif.40.i ]
  br i1 %.3813.i, label %B0.endif.endif.endif.endi...endif.40.endif.if.i, label %B0.endif.endif.endif.endi...endif.40.endif.endif.i, !prof !3
B0.endif.endif.endif.endi...endif.40.endif.if.i:
  br label %B0.endif.endif.endif.endi...endif.40.endif.endif.i
B0.endif.endif.endif.endi...endif.40.endif.endif.i:
  %.3970.sroa.13.1.i = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.40.endif.if.i ], [ %.3810.i, %B0.endif.endif.endif.endi...endif.40.endif.i ]
  br i1 %.3818.not.i, label %B0.endif.endif.endif.endi...endif.33.endif.endif.endif.i, label %B0.endif.endif.endif.endi...endif.40.endif.endif.if.i, !prof !4
B0.endif.endif.endif.endi...endif.40.endif.endif.if.i:
  br label %B0.endif.endif.endif.endi...endif.33.endif.endif.endif.i
B0.endif.endif.endif.endi...else.4.if.i:
  br label %B0.endif.endif.endif.endi...else.4.endif.i
B0.endif.endif.endif.endi...else.4.endif.i:
  %.4263.sroa.0.1.i = phi i64 [ 0, %B0.endif.endif.endif.endi...else.4.if.i ], [ %.4275.i, %B0.endif.endif.endif.endi...endif.33.endif.endif.endif.i ]
  %.4283.not.i = icmp slt i64 %.4275.i, %.163.i
  br i1 %.4283.not.i, label %b53, label %B0.endif.endif.endif.endi...else.4.endif.if.i, !prof !4
B0.endif.endif.endif.endi...else.4.endif.if.i:
  br label %b53
b53:
  %.4263.sroa.0.3.i = phi i64 [ %.163.i, %B0.endif.endif.endif.endi...else.4.endif.if.i ], [ %.4263.sroa.0.1.i, %B0.endif.endif.endif.endi...else.4.endif.i ]
  %.304.i = mul nsw i64 %.481.fca.6.load.i, 24
  %.305.i = add nsw i64 %.481.fca.36.load.i, %.304.i
  %.306.i = inttoptr i64 %.305.i to ptr
  %.490.i = getelementptr double, ptr %.306.i, i64 %.377.sroa.0.3.i
  %.4083.i = getelementptr double, ptr %.490.i, i64 %.3970.sroa.0.3.i
  %.4058.i = sub nsw i64 %.3970.sroa.13.0.i, %.3970.sroa.0.3.i
  %.4067.i = tail call i64 @llvm.smax.i64(i64 %.4058.i, i64 0)
  %.3911.i = getelementptr double, ptr %.490.i, i64 %.3798.sroa.0.3.i
  %.3886.i = sub nsw i64 %.3798.sroa.13.0.i, %.3798.sroa.0.3.i
  %.3895.i = tail call i64 @llvm.smax.i64(i64 %.3886.i, i64 0)
  %.3739.i = getelementptr double, ptr %.490.i, i64 %.3626.sroa.0.3.i
  %.3567.i = getelementptr double, ptr %.490.i, i64 %.3454.sroa.0.3.i
  %.3396.i = getelementptr double, ptr %.490.i, i64 %.3283.sroa.0.3.i
  %.3225.i = getelementptr double, ptr %.490.i, i64 %.3112.sroa.0.3.i
  %.3200.i = sub nsw i64 %.3112.sroa.13.0.i, %.3112.sroa.0.3.i
  %.3209.i = tail call i64 @llvm.smax.i64(i64 %.3200.i, i64 0)
  %.305421902210.i = getelementptr double, ptr %.490.i, i64 %.2941.sroa.0.3.i
  %.661.i = getelementptr double, ptr %.306.i, i64 %.548.sroa.0.3.i
  %.1354.i = getelementptr double, ptr %.661.i, i64 %.1241.sroa.0.3.i
  %.1991.i = getelementptr double, ptr %.1354.i, i64 %.1878.sroa.0.3.i
  %.2348.i = getelementptr double, ptr %.1991.i, i64 %.2235.sroa.0.3.i
  %.2869.i = getelementptr double, ptr %.2348.i, i64 %.2756.sroa.0.3.i
  %.2844.i = sub nsw i64 %.2332.i, %.2756.sroa.0.3.i
  %.2853.i = tail call i64 @llvm.smax.i64(i64 %.2844.i, i64 0)
  %.269821422175.i = getelementptr double, ptr %.2348.i, i64 %.2585.sroa.0.3.i
  %.252721232160.i = getelementptr double, ptr %.2348.i, i64 %.2414.sroa.0.3.i
  %.217720922108.i = getelementptr double, ptr %.1991.i, i64 %.2064.sroa.0.3.i
  %.181920692085.i = getelementptr double, ptr %.1354.i, i64 %1
  %.118320152044.i = getelementptr double, ptr %.661.i, i64 %.1070.sroa.0.3.i
  %.101119812031.i = getelementptr double, ptr %.661.i, i64 %.898.sroa.0.3.i
  %.84019621999.i = getelementptr double, ptr %.661.i, i64 %.727.sroa.0.3.i
  %.249.i = inttoptr i64 %.481.fca.36.load.i to ptr
  %.206.i = inttoptr i64 %.481.fca.29.load.i to ptr
  %.161.i = inttoptr i64 %.481.fca.23.load.i to ptr
  %.4351.i = sub i64 %.163.i, %.4263.sroa.0.3.i
  %.4360.i = tail call i64 @llvm.smax.i64(i64 %.4351.i, i64 0)
  %.4376.i = getelementptr double, ptr %.161.i, i64 %.4263.sroa.0.3.i
  %.4409.i = inttoptr i64 %.481.fca.16.load.i to ptr
  %.4485.i = inttoptr i64 %.481.fca.15.load.i to ptr
  %.4553.i = load double, ptr %.206.i, align 8
  %.4581.i = getelementptr i8, ptr %.206.i, i64 8
  %.4582.i = load double, ptr %.4581.i, align 8
  %.4584.i = inttoptr i64 %.481.fca.37.load.i to ptr
  %.4652.i = getelementptr i8, ptr %.206.i, i64 16
  %.4653.i = load double, ptr %.4652.i, align 8
  %.4657.i = fcmp ogt double %.4653.i, 0.000000e+00
  %.4687.i = inttoptr i64 %.481.fca.28.load.i to ptr
  %.4729.i = inttoptr i64 %.481.fca.32.load.i to ptr
  %.4804.i = inttoptr i64 %.481.fca.30.load.i to ptr
  %.4854.i = inttoptr i64 %.481.fca.31.load.i to ptr
  %.4926.i = inttoptr i64 %.481.fca.22.load.i to ptr
  %.4967.i = inttoptr i64 %.481.fca.33.load.i to ptr
  %.5009.i = inttoptr i64 %.481.fca.34.load.i to ptr
  %.5090.i = inttoptr i64 %.481.fca.35.load.i to ptr
  %.1025 = inttoptr i64 %.481.fca.24.load.i to ptr
  %.1068 = inttoptr i64 %.481.fca.27.load.i to ptr
  %.1129 = inttoptr i64 %.481.fca.25.load.i to ptr
  %.1178 = inttoptr i64 %.481.fca.26.load.i to ptr
  %.1292 = inttoptr i64 %.481.fca.14.load.i to ptr
  %.1390 = getelementptr i8, ptr %.206.i, i64 24
  %.1391 = load double, ptr %.1390, align 8
  %.1392 = fcmp ogt double %.1391, 0.000000e+00
  br i1 %.1392, label %B744, label %B852
B744:
  %.193303.not.i = icmp slt i64 %.481.fca.6.load.i, 1
  br i1 %.193303.not.i, label %b54, label %B56.if.lr.ph.i
B56.if.lr.ph.i:
  %.idx.i = shl i64 %.481.fca.6.load.i, 4
  %2 = getelementptr i8, ptr %.1292, i64 %.idx.i
  %.383.i = fmul double %.1391, 2.500000e-01
  %3 = getelementptr double, ptr %.1292, i64 %.481.fca.6.load.i
  %4 = getelementptr double, ptr %.249.i, i64 %.481.fca.6.load.i
  %5 = getelementptr i8, ptr %.249.i, i64 %.idx.i
  br label %B56.if.i
B140.i:
  %.265.i = tail call double @llvm.fabs.f64(double %.264.i)
  br label %B162.i
B144.i:
  %6 = getelementptr double, ptr %2, i64 %.135.0304.i
  %.375.i = load double, ptr %6, align 8, !noalias !5
  br label %B162.i
B162.i:
  %"$phi162.1.2.1.i" = phi double [ %.265.i, %B140.i ], [ %.375.i, %B144.i ]
  %.437.i = getelementptr double, ptr %.1292, i64 %.135.0304.i
  %.438.i = load double, ptr %.437.i, align 8, !noalias !5
  %.439.i = fmul double %.383.i, %.438.i
  %.499.i = getelementptr double, ptr %.249.i, i64 %.135.0304.i
  store double %.439.i, ptr %.499.i, align 8, !noalias !5
  %.625.i = getelementptr double, ptr %3, i64 %.135.0304.i
  %.626.i = load double, ptr %.625.i, align 8, !noalias !5
  %.627.i = fmul double %.439.i, %.626.i
  %.628.i = fmul double %"$phi162.1.2.1.i", %.627.i
  %.688.i = getelementptr double, ptr %4, i64 %.135.0304.i
  store double %.628.i, ptr %.688.i, align 8, !noalias !5
  %.756.i5438 = getelementptr double, ptr %5, i64 %.135.0304.i
  store double %"$phi162.1.2.1.i", ptr %.756.i5438, align 8, !noalias !5
  %exitcond.not.i5439 = icmp eq i64 %.206.i5436, %.481.fca.6.load.i
  br i1 %exitcond.not.i5439, label %b54, label %B56.if.i
B56.if.i:
  %.135.0304.i = phi i64 [ 0, %B56.if.lr.ph.i ], [ %.206.i5436, %B162.i ]
  %.206.i5436 = add nuw nsw i64 %.135.0304.i, 1
  %7 = getelementptr double, ptr %.4926.i, i64 %.135.0304.i
  %.264.i = load double, ptr %7, align 8, !noalias !5
  %8 = getelementptr i8, ptr %.4485.i, i64 %.135.0304.i
  %.303.i = load i8, ptr %8, align 1, !noalias !5
  %.307.i5437 = icmp ne i8 %.303.i, 0
  %.310.i = fcmp one double %.264.i, 0.000000e+00
  %or.cond.i = select i1 %.307.i5437, i1 %.310.i, i1 false
  br i1 %or.cond.i, label %B140.i, label %B144.i
b54:
  %.1645 = getelementptr i8, ptr %.1354.i, i64 8
  store double 0.000000e+00, ptr %.1645, align 8
  br label %B852
B852:
  %.17435578.not = icmp slt i64 %.481.fca.5.load.i, 1
  br i1 %.17435578.not, label %B1012, label %B882.if.preheader
B882.if.preheader:
  %invariant.gep = getelementptr double, ptr %.4967.i, i64 %.481.fca.5.load.i
  %invariant.gep5666 = getelementptr double, ptr %.4967.i, i64 %.308621912209.i
  br label %B882.if
B1012:
  %.2004 = getelementptr i8, ptr %.5090.i, i64 24
  store i64 -1, ptr %.2004, align 8
  %.2173 = getelementptr i8, ptr %.1354.i, i64 8
  %.2174 = load double, ptr %.2173, align 8
  %.2264 = mul i64 %.481.fca.7.load.i, 7
  %.24555581.not = icmp slt i64 %.481.fca.17.load.i, 1
  br i1 %.24555581.not, label %B1012.B1792_crit_edge, label %B1188.if.lr.ph
B1012.B1792_crit_edge:
  %.2216 = load i64, ptr %.1129, align 8
  %.2240 = icmp slt i64 %.2216, 0
  %.2241 = select i1 %.2240, i64 %.481.fca.18.load.i, i64 0
  %.2242 = add i64 %.2241, %.2216
  %.2266 = mul i64 %.2242, %.2264
  %.2268 = getelementptr double, ptr %.1178, i64 %.2266
  %.2035 = load double, ptr %.1025, align 8
  %.pre = add nsw i64 %.481.fca.19.load.i, -1
  br label %B1792
B1188.if.lr.ph:
  %9 = getelementptr double, ptr %.4687.i, i64 %.481.fca.19.load.i
  %.2619 = getelementptr i8, ptr %9, i64 -8
  %.2775 = icmp sgt i64 %.481.fca.11.load.i, 0
  %.2917 = icmp sgt i64 %.481.fca.20.load.i, 0
  %.148211.not.i.i.i = icmp eq i64 %.82419612000.i, 0
  %.992.i.i = inttoptr i64 %.481.fca.3.load.i to ptr
  %.3272 = icmp sgt i64 %.481.fca.5.load.i, 0
  %.fca.1.gep.i5481 = getelementptr inbounds i8, ptr %.1307.i, i64 8
  %.636.i5483.not = icmp eq i64 %.251121222161.i, 0
  %.980.i = getelementptr i8, ptr %.5090.i, i64 16
  %.996.i = add i64 %.481.fca.19.load.i, -1
  %10 = add i64 %.481.fca.19.load.i, -2
  %.1415.i = icmp ne i64 %.251121222161.i, 0
  %spec.select.i.i = tail call i64 @llvm.smax.i64(i64 %.481.fca.7.load.i, i64 0)
  %.1553.i = icmp sgt i64 %.481.fca.21.load.i, 0
  %.148231.not.i.i.i = icmp eq i64 %.116720142045.i, 0
  %.822.i.i = inttoptr i64 %.481.fca.0.load.i to ptr
  %.585727.not.i.i.i = icmp slt i64 %.481.fca.6.load.i, 1
  %.idx.i.i.i = shl i64 %.481.fca.6.load.i, 4
  %11 = getelementptr i8, ptr %.249.i, i64 %.idx.i.i.i
  %.26.i.i = add nsw i64 %.481.fca.21.load.i, -1
  %.2529.i = inttoptr i64 %.481.fca.1.load.i to ptr
  %12 = getelementptr double, ptr %.249.i, i64 %.481.fca.6.load.i
  %.2704.i = getelementptr i8, ptr %.5090.i, i64 8
  %.fca.1.gep.i.i = getelementptr inbounds i8, ptr %.1113.i.i, i64 8
  %.10933044.i.i = inttoptr i64 %.481.fca.2.load.i to ptr
  %.idx.i.i6067.i = shl i64 %.481.fca.5.load.i, 4
  %invariant.gep.i.i.i = getelementptr i8, ptr %.4967.i, i64 %.idx.i.i6067.i
  %invariant.gep853.i.i.i = getelementptr double, ptr %.4967.i, i64 %.481.fca.5.load.i
  %.704.i.i = getelementptr i8, ptr %.5090.i, i64 32
  %.1283.i.i = getelementptr i8, ptr %.5009.i, i64 8
  br label %B1188.if
B1186:
  %h.4.15627 = phi double [ %h.10.1.sink.i.ph5637, %B1718.thread5638 ], [ %"$phi1566.1.2.1", %b55 ]
  %t.5.15626 = phi double [ %t.4.1.sink.i.ph5636, %B1718.thread5638 ], [ %t.3.1.i5482, %b55 ]
  %exitcond5621.not = icmp eq i64 %.2468, %.481.fca.17.load.i
  br i1 %exitcond5621.not, label %B1792, label %B1188.if
B1340:
  store i8 0, ptr %.2785, align 1
  call fastcc void @v48(ptr %.2785, i64 %.481.fca.4.load.i, ptr %.161.i, i64 %.4360.i, ptr %.4376.i, ptr %.4409.i, i64 %.251121222161.i, ptr %.252721232160.i, ptr %.269821422175.i, i64 %.82419612000.i, ptr %.84019621999.i, ptr %.1354.i, ptr %.2706, i64 7, double %.2539, ptr %.4926.i)
  br label %B1396
B1396:
  br i1 %.2917, label %B1418, label %B1542
B1418:
  br i1 %.148211.not.i.i.i, label %b56, label %B58.if.i.i.i
B164.i.i.i:
  %.44.i.i.i.i = getelementptr i8, ptr %14, i64 24
  %.45.i.i.i.i = load double, ptr %.44.i.i.i.i, align 8, !noalias !8
  %.73.i.i.i.i = getelementptr i8, ptr %14, i64 32
  %.74.i.i.i.i = load double, ptr %.73.i.i.i.i, align 8, !noalias !8
  %.75.i.i.i.i = fmul double %.74.i.i.i.i, 5.000000e-01
  %.76.i.i.i.i = fmul double %.245.i.i.i, %.75.i.i.i.i
  %.77.i.i.i.i = fadd double %.45.i.i.i.i, %.76.i.i.i.i
  %.78.i.i.i.i = fmul double %.245.i.i.i, %.77.i.i.i.i
  %.87.le.i.i.i.i = tail call double @llvm.floor.f64(double %.78.i.i.i.i)
  %.92.i.i.i.i = fsub double %.78.i.i.i.i, %.87.le.i.i.i.i
  %.93.i.i.i.i = fmul double %.92.i.i.i.i, 0x401921FB54442D18
  %.121.i.i.i.i = getelementptr i8, ptr %14, i64 40
  %.122.i.i.i.i = load double, ptr %.121.i.i.i.i, align 8, !noalias !8
  %.126.i.i.i.i = fadd double %.122.i.i.i.i, %.93.i.i.i.i
  %.593.le.i.i.i = tail call double @llvm.sin.f64(double %.126.i.i.i.i)
  %.598.i.i.i = fmul double %.423.i.i.i, %.593.le.i.i.i
  %.600.i.i.i = fadd double %.361.i.i.i, %.598.i.i.i
  br label %B272.i.i.i
B272.i.i.i:
  %value.2.1.i.i.i = phi double [ %.600.i.i.i, %B164.i.i.i ], [ %.361.i.i.i, %B58.if.i.i.i ]
  %13 = getelementptr double, ptr %.84019621999.i, i64 %.90.0213.i.i.i
  store double %value.2.1.i.i.i, ptr %13, align 8, !noalias !17
  %exitcond.not.i.i.i = icmp eq i64 %.82419612000.i, %.161.i.i.i
  br i1 %exitcond.not.i.i.i, label %b56, label %B58.if.i.i.i
B58.if.i.i.i:
  %.90.0213.i.i.i = phi i64 [ %.161.i.i.i, %B272.i.i.i ], [ 0, %B1418 ]
  %.161.i.i.i = add nuw nsw i64 %.90.0213.i.i.i, 1
  %.idx = mul i64 %.90.0213.i.i.i, 56
  %14 = getelementptr i8, ptr %.2706, i64 %.idx
  %.242.i.i.i = getelementptr i8, ptr %14, i64 48
  %.243.i.i.i = load double, ptr %.242.i.i.i, align 8, !noalias !17
  %.245.i.i.i = fsub double %.2539, %.243.i.i.i
  %.303.i.i.i = load double, ptr %14, align 8, !noalias !17
  %.357.i.i.i = getelementptr i8, ptr %14, i64 8
  %.358.i.i.i = load double, ptr %.357.i.i.i, align 8, !noalias !17
  %.360.i.i.i = fmul double %.245.i.i.i, %.358.i.i.i
  %.361.i.i.i = fadd double %.303.i.i.i, %.360.i.i.i
  %.422.i.i.i = getelementptr i8, ptr %14, i64 16
  %.423.i.i.i = load double, ptr %.422.i.i.i, align 8, !noalias !17
  %.424.i.i.i = fcmp une double %.423.i.i.i, 0.000000e+00
  br i1 %.424.i.i.i, label %B164.i.i.i, label %B272.i.i.i
b56:
  store double %.2539, ptr %.1354.i, align 8, !noalias !18
  tail call void %.992.i.i(ptr nonnull %.1354.i, ptr %.4926.i, ptr %.84019621999.i, ptr %.161.i, ptr %.2869.i), !noalias !18
  br label %B140.i5440
B140.i5440:
  %.859.0.i = phi i64 [ 0, %b56 ], [ %.928.i, %B288.i ]
  %exitcond294.not.i = icmp eq i64 %.859.0.i, %.481.fca.20.load.i
  br i1 %exitcond294.not.i, label %b57, label %B142.i
b57:
  store i64 -1, ptr %.2004, align 8
  br label %B1542
B142.i:
  %.idx5557 = mul i64 %.859.0.i, 24
  %15 = getelementptr i8, ptr %.4854.i, i64 %.idx5557
  %.1009.i = getelementptr i8, ptr %15, i64 16
  %.1010.i = load double, ptr %.1009.i, align 8, !noalias !19
  %.idx5558 = shl i64 %.859.0.i, 4
  %16 = getelementptr i8, ptr %.4804.i, i64 %.idx5558
  br label %B194.if.i
B226.i:
  %17 = getelementptr double, ptr %15, i64 %.1037.0289.i
  %.1249.i = load double, ptr %17, align 8, !noalias !19
  %.1338.i5442 = getelementptr double, ptr %.2869.i, i64 %.1191.i
  %.1339.i = load double, ptr %.1338.i5442, align 8, !noalias !19
  %.1340.i = fmul double %.1249.i, %.1339.i
  %.1342.i = fadd double %value.2.1291.i, %.1340.i
  br label %B286.i
B286.i:
  %value.3.2.i = phi double [ %.1342.i, %B226.i ], [ %value.2.1291.i, %B194.if.i ]
  br i1 %exitcond.not.i5441, label %B288.i, label %B194.if.i
B288.i:
  %.928.i = add nuw i64 %.859.0.i, 1
  %.1361.i = fcmp ogt double %value.3.2.i, 0.000000e+00
  br i1 %.1361.i, label %b58, label %B140.i5440
B194.if.i:
  %value.2.1291.i = phi double [ %.1010.i, %B142.i ], [ %value.3.2.i, %B286.i ]
  %exitcond.not.i5441 = phi i1 [ false, %B142.i ], [ true, %B286.i ]
  %.1037.0289.i = phi i64 [ 0, %B142.i ], [ 1, %B286.i ]
  %18 = getelementptr i64, ptr %16, i64 %.1037.0289.i
  %.1191.i = load i64, ptr %18, align 8, !noalias !19
  %.1194.i = icmp sgt i64 %.1191.i, -1
  br i1 %.1194.i, label %B226.i, label %B286.i
b58:
  store i64 %.859.0.i, ptr %.2004, align 8
  br label %B1792
B1542:
  %19 = getelementptr i8, ptr %.1068, i64 %.2361.05582
  %.3246 = load i8, ptr %19, align 1
  %.3249.not = icmp eq i8 %.3246, 0
  %.3252 = fneg double %h.3.05584
  %"$phi1566.1.2.1" = select i1 %.3249.not, double %h.3.05584, double %.3252
  br i1 %.3272, label %B1580, label %B1624
B1580:
  call void @llvm.lifetime.start.p0(ptr nonnull %.3776.i)
  br label %B66.i.i
B66.i.i:
  %.75.0.i.i = phi i64 [ 0, %B1580 ], [ %.146.i.i, %B108.i.i ]
  %exitcond.not.i.i = icmp eq i64 %.75.0.i.i, %spec.select.i.i
  br i1 %exitcond.not.i.i, label %b59, label %B66.if.i.i
B108.i.i:
  %.146.i.i = add nuw i64 %.75.0.i.i, 1
  %.303.i.i = getelementptr i8, ptr %20, i64 16
  %.304.i.i = load double, ptr %.303.i.i, align 8, !noalias !20
  %.310.i.i = fcmp une double %.304.i.i, 0.000000e+00
  br i1 %.310.i.i, label %b59, label %B66.i.i
B66.if.i.i:
  %.idx5559 = mul i64 %.75.0.i.i, 56
  %20 = getelementptr i8, ptr %.2706, i64 %.idx5559
  %.233.i.i = getelementptr i8, ptr %20, i64 8
  %.234.i.i = load double, ptr %.233.i.i, align 8, !noalias !20
  %.240.i.i = fcmp une double %.234.i.i, 0.000000e+00
  br i1 %.240.i.i, label %b59, label %B108.i.i
b59:
  %.748.i.i = fadd double %.2539, 0.000000e+00
  br label %switch.end.else.endif.i.i
switch.end.endif.i.i:
  %.889.sroa.13.0.i.i = phi i64 [ %.99519802032.i, %switch.end.else.endif.endif.endif.if.i.i ], [ %.863.i.i, %switch.end.else.endif.endif.endif.i.i ]
  %.977.i.i = sub nsw i64 %.889.sroa.13.0.i.i, %.889.sroa.0.3.i.i
  %.1002.i.i = getelementptr double, ptr %.101119812031.i, i64 %.889.sroa.0.3.i.i
  %.148211.not.i.i.i5443 = icmp slt i64 %.977.i.i, 1
  br i1 %.148211.not.i.i.i5443, label %b60, label %B58.if.i.i.i5444
B164.i.i.i5463:
  %.44.i.i.i.i5464 = getelementptr i8, ptr %22, i64 24
  %.45.i.i.i.i5465 = load double, ptr %.44.i.i.i.i5464, align 8, !noalias !25
  %.73.i.i.i.i5466 = getelementptr i8, ptr %22, i64 32
  %.74.i.i.i.i5467 = load double, ptr %.73.i.i.i.i5466, align 8, !noalias !25
  %.75.i.i.i.i5468 = fmul double %.74.i.i.i.i5467, 5.000000e-01
  %.76.i.i.i.i5469 = fmul double %.245.i.i.i5450, %.75.i.i.i.i5468
  %.77.i.i.i.i5470 = fadd double %.45.i.i.i.i5465, %.76.i.i.i.i5469
  %.78.i.i.i.i5471 = fmul double %.245.i.i.i5450, %.77.i.i.i.i5470
  %.87.le.i.i.i.i5472 = tail call double @llvm.floor.f64(double %.78.i.i.i.i5471)
  %.92.i.i.i.i5473 = fsub double %.78.i.i.i.i5471, %.87.le.i.i.i.i5472
  %.93.i.i.i.i5474 = fmul double %.92.i.i.i.i5473, 0x401921FB54442D18
  %.121.i.i.i.i5475 = getelementptr i8, ptr %22, i64 40
  %.122.i.i.i.i5476 = load double, ptr %.121.i.i.i.i5475, align 8, !noalias !25
  %.126.i.i.i.i5477 = fadd double %.122.i.i.i.i5476, %.93.i.i.i.i5474
  %.593.le.i.i.i5478 = tail call double @llvm.sin.f64(double %.126.i.i.i.i5477)
  %.598.i.i.i5479 = fmul double %.423.i.i.i5457, %.593.le.i.i.i5478
  %.600.i.i.i5480 = fadd double %.361.i.i.i5455, %.598.i.i.i5479
  br label %B272.i.i.i5459
B272.i.i.i5459:
  %value.2.1.i.i.i5460 = phi double [ %.600.i.i.i5480, %B164.i.i.i5463 ], [ %.361.i.i.i5455, %B58.if.i.i.i5444 ]
  %21 = getelementptr double, ptr %.1002.i.i, i64 %.90.0213.i.i.i5445
  store double %value.2.1.i.i.i5460, ptr %21, align 8, !noalias !32
  %exitcond.not.i.i.i5461 = icmp eq i64 %.977.i.i, %.161.i.i.i5446
  br i1 %exitcond.not.i.i.i5461, label %b60, label %B58.if.i.i.i5444
B58.if.i.i.i5444:
  %.90.0213.i.i.i5445 = phi i64 [ %.161.i.i.i5446, %B272.i.i.i5459 ], [ 0, %switch.end.endif.i.i ]
  %.161.i.i.i5446 = add nuw nsw i64 %.90.0213.i.i.i5445, 1
  %.idx5560 = mul i64 %.90.0213.i.i.i5445, 56
  %22 = getelementptr i8, ptr %.2706, i64 %.idx5560
  %.242.i.i.i5448 = getelementptr i8, ptr %22, i64 48
  %.243.i.i.i5449 = load double, ptr %.242.i.i.i5448, align 8, !noalias !32
  %.245.i.i.i5450 = fsub double %.748.i.i, %.243.i.i.i5449
  %.303.i.i.i5451 = load double, ptr %22, align 8, !noalias !32
  %.357.i.i.i5452 = getelementptr i8, ptr %22, i64 8
  %.358.i.i.i5453 = load double, ptr %.357.i.i.i5452, align 8, !noalias !32
  %.360.i.i.i5454 = fmul double %.245.i.i.i5450, %.358.i.i.i5453
  %.361.i.i.i5455 = fadd double %.303.i.i.i5451, %.360.i.i.i5454
  %.422.i.i.i5456 = getelementptr i8, ptr %22, i64 16
  %.423.i.i.i5457 = load double, ptr %.422.i.i.i5456, align 8, !noalias !32
  %.424.i.i.i5458 = fcmp une double %.423.i.i.i5457, 0.000000e+00
  br i1 %.424.i.i.i5458, label %B164.i.i.i5463, label %B272.i.i.i5459
b60:
  %exitcond.not.i5937.i = icmp eq i64 %.687.i.i, 4
  br i1 %exitcond.not.i5937.i, label %b61, label %switch.end.else.endif.i.i
switch.end.else.endif.i.i:
  %.616.0584.i.i = phi i64 [ 0, %b59 ], [ %.687.i.i, %b60 ]
  %.687.i.i = add nuw nsw i64 %.616.0584.i.i, 1
  %.863.i.i = mul nuw nsw i64 %.687.i.i, %.82419612000.i
  %.860.i.i = mul nuw nsw i64 %.616.0584.i.i, %.82419612000.i
  %.909.not.i.i = icmp ult i64 %.860.i.i, %.99519802032.i
  br i1 %.909.not.i.i, label %switch.end.else.endif.endif.endif.i.i, label %switch.end.else.endif.if.i.i, !prof !4
switch.end.else.endif.if.i.i:
  br label %switch.end.else.endif.endif.endif.i.i
switch.end.else.endif.endif.endif.i.i:
  %.889.sroa.0.3.i.i = phi i64 [ %.99519802032.i, %switch.end.else.endif.if.i.i ], [ %.860.i.i, %switch.end.else.endif.i.i ]
  %.926.not.i.i = icmp ult i64 %.863.i.i, %.99519802032.i
  br i1 %.926.not.i.i, label %switch.end.endif.i.i, label %switch.end.else.endif.endif.endif.if.i.i, !prof !4
switch.end.else.endif.endif.endif.if.i.i:
  br label %switch.end.endif.i.i
b61:
  %.1790.i = fcmp olt double %.2539, %"$phi1276.4.2.1"
  br i1 %.1790.i, label %B396.preheader.i, label %B1718.thread5638
B396.preheader.i:
  %.1586.i = fcmp ogt double %.2539, 0.000000e+00
  %"$phi322.3.2.0.i" = select i1 %.1415.i, i1 true, i1 %.1586.i
  %.5.i.i.i = fmul double %"$phi1276.4.2.1", 0x3D06849B86A12B9B
  %.6.i.i.i = fadd double %.5.i.i.i, 1.000000e-15
  %.818.i.i = fsub double %"$phi1276.4.2.1", %.6.i.i.i
  br label %B396.i
B396.i:
  %h.6.0.i = phi double [ %h.7.1.i, %B2156.i ], [ %"$phi1566.1.2.1", %B396.preheader.i ]
  %t.2.0.i = phi double [ %t.3.1.i, %B2156.i ], [ %.2539, %B396.preheader.i ]
  %error_before.2.0.i = phi double [ %error_before.3.1.i, %B2156.i ], [ 1.000000e-02, %B396.preheader.i ]
  %step_before.3.0.i = phi double [ %step_before.4.1.i, %B2156.i ], [ 0.000000e+00, %B396.preheader.i ]
  %rejected.3.0.i = phi i1 [ %rejected.4.1.i, %B2156.i ], [ false, %B396.preheader.i ]
  %fresh.3.0.i = phi i1 [ %fresh.4.1.i, %B2156.i ], [ true, %B396.preheader.i ]
  %window.2.0.i = phi double [ %window.3.1.i, %B2156.i ], [ %.2539, %B396.preheader.i ]
  %calm.2.0.i = phi double [ %calm.3.1.i, %B2156.i ], [ %.2539, %B396.preheader.i ]
  %first.3.0.i = phi double [ %first.4.1.i, %B2156.i ], [ 0.000000e+00, %B396.preheader.i ]
  %has_changed.3.0.i = phi i1 [ %has_changed.4.1.i, %B2156.i ], [ true, %B396.preheader.i ]
  %has_acted.5.0.i = phi i1 [ %has_acted.6.1.i, %B2156.i ], [ %"$phi322.3.2.0.i", %B396.preheader.i ]
  br i1 %fresh.3.0.i, label %B400.i, label %B450.i
B400.i:
  store double %t.2.0.i, ptr %.1354.i, align 8, !noalias !33
  br i1 %.148211.not.i.i.i, label %b62, label %B58.if.i.i5939.i
B164.i.i5958.i:
  %.44.i.i.i5959.i = getelementptr i8, ptr %24, i64 24
  %.45.i.i.i5960.i = load double, ptr %.44.i.i.i5959.i, align 8, !noalias !36
  %.73.i.i.i5961.i = getelementptr i8, ptr %24, i64 32
  %.74.i.i.i5962.i = load double, ptr %.73.i.i.i5961.i, align 8, !noalias !36
  %.75.i.i.i5963.i = fmul double %.74.i.i.i5962.i, 5.000000e-01
  %.76.i.i.i5964.i = fmul double %.245.i.i5945.i, %.75.i.i.i5963.i
  %.77.i.i.i5965.i = fadd double %.45.i.i.i5960.i, %.76.i.i.i5964.i
  %.78.i.i.i5966.i = fmul double %.245.i.i5945.i, %.77.i.i.i5965.i
  %.87.le.i.i.i5967.i = tail call double @llvm.floor.f64(double %.78.i.i.i5966.i)
  %.92.i.i.i5968.i = fsub double %.78.i.i.i5966.i, %.87.le.i.i.i5967.i
  %.93.i.i.i5969.i = fmul double %.92.i.i.i5968.i, 0x401921FB54442D18
  %.121.i.i.i5970.i = getelementptr i8, ptr %24, i64 40
  %.122.i.i.i5971.i = load double, ptr %.121.i.i.i5970.i, align 8, !noalias !36
  %.126.i.i.i5972.i = fadd double %.122.i.i.i5971.i, %.93.i.i.i5969.i
  %.593.le.i.i5973.i = tail call double @llvm.sin.f64(double %.126.i.i.i5972.i)
  %.598.i.i5974.i = fmul double %.423.i.i5952.i, %.593.le.i.i5973.i
  %.600.i.i5975.i = fadd double %.361.i.i5950.i, %.598.i.i5974.i
  br label %B272.i.i5954.i
B272.i.i5954.i:
  %value.2.1.i.i5955.i = phi double [ %.600.i.i5975.i, %B164.i.i5958.i ], [ %.361.i.i5950.i, %B58.if.i.i5939.i ]
  %23 = getelementptr double, ptr %.84019621999.i, i64 %.90.0213.i.i5940.i
  store double %value.2.1.i.i5955.i, ptr %23, align 8, !noalias !41
  %exitcond.not.i.i5956.i = icmp eq i64 %.82419612000.i, %.161.i.i5941.i
  br i1 %exitcond.not.i.i5956.i, label %b62, label %B58.if.i.i5939.i
B58.if.i.i5939.i:
  %.90.0213.i.i5940.i = phi i64 [ %.161.i.i5941.i, %B272.i.i5954.i ], [ 0, %B400.i ]
  %.161.i.i5941.i = add nuw nsw i64 %.90.0213.i.i5940.i, 1
  %.idx5561 = mul i64 %.90.0213.i.i5940.i, 56
  %24 = getelementptr i8, ptr %.2706, i64 %.idx5561
  %.242.i.i5943.i = getelementptr i8, ptr %24, i64 48
  %.243.i.i5944.i = load double, ptr %.242.i.i5943.i, align 8, !noalias !41
  %.245.i.i5945.i = fsub double %t.2.0.i, %.243.i.i5944.i
  %.303.i.i5946.i = load double, ptr %24, align 8, !noalias !41
  %.357.i.i5947.i = getelementptr i8, ptr %24, i64 8
  %.358.i.i5948.i = load double, ptr %.357.i.i5947.i, align 8, !noalias !41
  %.360.i.i5949.i = fmul double %.245.i.i5945.i, %.358.i.i5948.i
  %.361.i.i5950.i = fadd double %.303.i.i5946.i, %.360.i.i5949.i
  %.422.i.i5951.i = getelementptr i8, ptr %24, i64 16
  %.423.i.i5952.i = load double, ptr %.422.i.i5951.i, align 8, !noalias !41
  %.424.i.i5953.i = fcmp une double %.423.i.i5952.i, 0.000000e+00
  br i1 %.424.i.i5953.i, label %B164.i.i5958.i, label %B272.i.i5954.i
b62:
  br i1 %.148231.not.i.i.i, label %b63, label %B58.if.i1365.i.i
B110.i.i.i:
  %.361.i1371.i.i = getelementptr i8, ptr %26, i64 48
  %.362.i.i.i = load double, ptr %.361.i1371.i.i, align 8, !noalias !42
  %.364.i.i.i = fsub double %t.2.0.i, %.362.i.i.i
  %.419.i.i.i = getelementptr i8, ptr %26, i64 24
  %.420.i.i.i = load double, ptr %.419.i.i.i, align 8, !noalias !42
  %.474.i.i.i = getelementptr i8, ptr %26, i64 32
  %.475.i.i.i = load double, ptr %.474.i.i.i, align 8, !noalias !42
  %.476.i.i.i = fmul double %.364.i.i.i, %.475.i.i.i
  %.477.i.i.i = fadd double %.420.i.i.i, %.476.i.i.i
  %.478.i.i.i = fmul double %.477.i.i.i, 0x401921FB54442D18
  %.534.i.i.i = fmul double %.305.i.i.i, %.478.i.i.i
  %.75.i.i1372.i.i = fmul double %.475.i.i.i, 5.000000e-01
  %.76.i.i1373.i.i = fmul double %.364.i.i.i, %.75.i.i1372.i.i
  %.77.i.i1374.i.i = fadd double %.420.i.i.i, %.76.i.i1373.i.i
  %.78.i.i1375.i.i = fmul double %.364.i.i.i, %.77.i.i1374.i.i
  %.87.le.i.i1376.i.i = tail call double @llvm.floor.f64(double %.78.i.i1375.i.i)
  %.92.i.i1377.i.i = fsub double %.78.i.i1375.i.i, %.87.le.i.i1376.i.i
  %.93.i.i1378.i.i = fmul double %.92.i.i1377.i.i, 0x401921FB54442D18
  %.121.i.i1379.i.i = getelementptr i8, ptr %26, i64 40
  %.122.i.i1380.i.i = load double, ptr %.121.i.i1379.i.i, align 8, !noalias !45
  %.126.i.i1381.i.i = fadd double %.122.i.i1380.i.i, %.93.i.i1378.i.i
  %.644.le.i.i.i = tail call double @llvm.cos.f64(double %.126.i.i1381.i.i)
  %.649.i.i.i = fmul double %.534.i.i.i, %.644.le.i.i.i
  %.651.i.i.i = fadd double %.243.i1369.i.i, %.649.i.i.i
  br label %B326.i.i.i
B326.i.i.i:
  %slope.2.1.i.i.i = phi double [ %.651.i.i.i, %B110.i.i.i ], [ %.243.i1369.i.i, %B58.if.i1365.i.i ]
  %25 = getelementptr double, ptr %.118320152044.i, i64 %.90.0233.i.i.i
  store double %slope.2.1.i.i.i, ptr %25, align 8, !noalias !42
  %exitcond.not.i1370.i.i = icmp eq i64 %.116720142045.i, %.161.i1366.i.i
  br i1 %exitcond.not.i1370.i.i, label %b63, label %B58.if.i1365.i.i
B58.if.i1365.i.i:
  %.90.0233.i.i.i = phi i64 [ %.161.i1366.i.i, %B326.i.i.i ], [ 0, %b62 ]
  %.161.i1366.i.i = add nuw nsw i64 %.90.0233.i.i.i, 1
  %.idx5562 = mul i64 %.90.0233.i.i.i, 56
  %26 = getelementptr i8, ptr %.2706, i64 %.idx5562
  %.242.i1368.i.i = getelementptr i8, ptr %26, i64 8
  %.243.i1369.i.i = load double, ptr %.242.i1368.i.i, align 8, !noalias !42
  %.304.i.i.i = getelementptr i8, ptr %26, i64 16
  %.305.i.i.i = load double, ptr %.304.i.i.i, align 8, !noalias !42
  %.306.i.i.i = fcmp une double %.305.i.i.i, 0.000000e+00
  br i1 %.306.i.i.i, label %B110.i.i.i, label %B326.i.i.i
b63:
  tail call void %.822.i.i(ptr nonnull %.1354.i, ptr %.4926.i, ptr %.84019621999.i, ptr %.118320152044.i, ptr %.161.i, ptr %.305421902210.i, ptr %.181920692085.i, ptr %.3225.i), !noalias !33
  %.849.i.i = fcmp ogt double %h.6.0.i, 0.000000e+00
  br i1 %.849.i.i, label %B450.i, label %B298.i.i
B298.i.i:
  %.994.i.i = fsub double %"$phi1276.4.2.1", %t.2.0.i
  %.447.i.i.i = fdiv double 2.000000e+01, %.994.i.i
  br i1 %.585727.not.i.i.i, label %b64, label %B90.if.i.i.i
B90.if.i.i.i:
  %fastest.2.0730.i.i.i = phi double [ %.13.i.i.i.i, %B90.if.i.i.i ], [ %.447.i.i.i, %B298.i.i ]
  %.527.0729.i.i.i = phi i64 [ %.598.i1382.i.i, %B90.if.i.i.i ], [ 0, %B298.i.i ]
  %.598.i1382.i.i = add nuw nsw i64 %.527.0729.i.i.i, 1
  %27 = getelementptr double, ptr %.305421902210.i, i64 %.527.0729.i.i.i
  %.761.i.i.i = load double, ptr %27, align 8, !noalias !48
  %.765.i.i.i = tail call double @llvm.fabs.f64(double %.761.i.i.i)
  %.766.i.i.i = fmul double %.765.i.i.i, 2.000000e+01
  %28 = getelementptr double, ptr %.4926.i, i64 %.527.0729.i.i.i
  %.800.i.i.i = load double, ptr %28, align 8, !noalias !48
  %.804.i.i.i = tail call double @llvm.fabs.f64(double %.800.i.i.i)
  %29 = getelementptr double, ptr %11, i64 %.527.0729.i.i.i
  %.858.i.i.i = load double, ptr %29, align 8, !noalias !48
  %.859.i.i.i = fadd double %.804.i.i.i, %.858.i.i.i
  %.863.i.i.i = fdiv double %.766.i.i.i, %.859.i.i.i
  %.12.i.i.i.i = fcmp ogt double %.863.i.i.i, %fastest.2.0730.i.i.i
  %.13.i.i.i.i = select i1 %.12.i.i.i.i, double %.863.i.i.i, double %fastest.2.0730.i.i.i
  %exitcond.not.i1383.i.i = icmp eq i64 %.598.i1382.i.i, %.481.fca.6.load.i
  br i1 %exitcond.not.i1383.i.i, label %b64, label %B90.if.i.i.i
b64:
  %fastest.2.0.lcssa.i.i.i = phi double [ %.447.i.i.i, %B298.i.i ], [ %.13.i.i.i.i, %B90.if.i.i.i ]
  %.1029.i.i.i = fdiv double 1.000000e+00, %fastest.2.0.lcssa.i.i.i
  %.1231.i.i = fcmp olt double %h.6.0.i, 0.000000e+00
  br i1 %.1231.i.i, label %B358.i.i, label %B450.i
B358.i.i:
  %.1234.i.i = fneg double %h.6.0.i
  %.12.i.i.i = fcmp olt double %.1029.i.i.i, %.1234.i.i
  %.13.i.i.i = select i1 %.12.i.i.i, double %.1029.i.i.i, double %.1234.i.i
  br label %B450.i
B450.i:
  %h.9.1.i = phi double [ %h.6.0.i, %B396.i ], [ %h.6.0.i, %b63 ], [ %.13.i.i.i, %B358.i.i ], [ %.1029.i.i.i, %b64 ]
  %.12.i.i5976.i = fcmp olt double %.4553.i, %h.9.1.i
  %.13.i.i5977.i = select i1 %.12.i.i5976.i, double %.4553.i, double %h.9.1.i
  br i1 %.1415.i, label %B78.if.i.i.i, label %b65
B78.if.i.i.i:
  %first.2.0129.i.i.i = phi double [ %.13.i.i.i5979.i, %B78.if.i.i.i ], [ 0x7FF0000000000000, %B450.i ]
  %.106.0128.i.i.i = phi i64 [ %.177.i.i.i, %B78.if.i.i.i ], [ 0, %B450.i ]
  %.177.i.i.i = add nuw nsw i64 %.106.0128.i.i.i, 1
  %30 = getelementptr double, ptr %.4376.i, i64 %.106.0128.i.i.i
  %.235.i.i.i = load double, ptr %30, align 8, !noalias !51
  %.12.i.i.i5978.i = fcmp olt double %.235.i.i.i, %first.2.0129.i.i.i
  %.13.i.i.i5979.i = select i1 %.12.i.i.i5978.i, double %.235.i.i.i, double %first.2.0129.i.i.i
  %exitcond.not.i.i5980.i = icmp eq i64 %.251121222161.i, %.177.i.i.i
  br i1 %exitcond.not.i.i5980.i, label %b66, label %B78.if.i.i.i
b66:
  %.820.i.i = fcmp uge double %.13.i.i.i5979.i, %.818.i.i
  %31 = or i1 %.2917, %.820.i.i
  %brmerge.i.i = select i1 %31, i1 true, i1 %.1553.i
  %arg.segment.1.mux.i.i = select i1 %.820.i.i, double %"$phi1276.4.2.1", double %.13.i.i.i5979.i
  br i1 %brmerge.i.i, label %b65, label %B200.i.i
B200.i.i:
  %.830.i.i = fsub double %.13.i.i.i5979.i, %t.2.0.i
  %.833.i.i = fsub double %t.2.0.i, %calm.2.0.i
  %.834.i.i = fcmp ult double %.830.i.i, %.833.i.i
  br i1 %.834.i.i, label %B232.i.i, label %b65
B232.i.i:
  %.12.i999.i.i = fcmp olt double %.833.i.i, %.13.i.i5977.i
  %.13.i1000.i.i = select i1 %.12.i999.i.i, double %.833.i.i, double %.13.i.i5977.i
  br label %b65
b65:
  %desired.2.0.sink.i.i = phi double [ %.13.i.i5977.i, %B450.i ], [ %.13.i.i5977.i, %B200.i.i ], [ %.13.i1000.i.i, %B232.i.i ], [ %.13.i.i5977.i, %b66 ]
  %arg.segment.1.sink.i.i = phi double [ %"$phi1276.4.2.1", %B450.i ], [ %.13.i.i.i5979.i, %B200.i.i ], [ %"$phi1276.4.2.1", %B232.i.i ], [ %arg.segment.1.mux.i.i, %b66 ]
  br i1 %.4657.i, label %B520.i, label %B582.i
B520.i:
  %.2112.i = load i64, ptr %.5090.i, align 8, !noalias !56
  %.2115.i = fsub double %arg.segment.1.sink.i.i, %t.2.0.i
  %.13.i.i5981.i = tail call i64 @llvm.smin.i64(i64 %.26.i.i, i64 %.2112.i)
  %.69.i.i = icmp slt i64 %.13.i.i5981.i, 0
  %.70.i.i = select i1 %.69.i.i, i64 %.481.fca.21.load.i, i64 0
  %32 = getelementptr double, ptr %.4584.i, i64 %.13.i.i5981.i
  %.84.i.i = getelementptr double, ptr %32, i64 %.70.i.i
  %.85.i.i = load double, ptr %.84.i.i, align 8, !noalias !57
  %.93.i.i = fcmp ugt double %.85.i.i, 0.000000e+00
  %.97.i.i = fcmp ult double %.85.i.i, %.2115.i
  %or.cond.i.i = select i1 %.93.i.i, i1 %.97.i.i, i1 false
  %"$phi94.0.2.0.i.i" = select i1 %or.cond.i.i, double %.85.i.i, double %.2115.i
  br label %B628.i
B582.i:
  %.2149.i = fsub double %arg.segment.1.sink.i.i, %t.2.0.i
  %.11.i.i = fmul double %.2149.i, 5.000000e-01
  %.13.i.i = fcmp olt double %desired.2.0.sink.i.i, %.11.i.i
  %.24.i.i = fcmp olt double %desired.2.0.sink.i.i, %.2149.i
  %.11.arg.remaining.i.i = select i1 %.24.i.i, double %.11.i.i, double %.2149.i
  %storemerge.i5982.i = select i1 %.13.i.i, double %desired.2.0.sink.i.i, double %.11.arg.remaining.i.i
  br label %B628.i
B628.i:
  %"$phi628.0.2.1.in.sroa.speculated.i" = phi double [ %"$phi94.0.2.0.i.i", %B520.i ], [ %storemerge.i5982.i, %B582.i ]
  br i1 %exitcond.not.i.i, label %B680.i, label %B68.if.i5983.i
B68.if.i5983.i:
  %.616.0584.i5984.i = phi i64 [ %.687.i5985.i, %b67 ], [ 0, %B628.i ]
  %.687.i5985.i = add nuw nsw i64 %.616.0584.i5984.i, 1
  %switch.gep = getelementptr inbounds double, ptr @v46, i64 %.616.0584.i5984.i
  %switch.load = load double, ptr %switch.gep, align 8
  %.746.i.i = fmul double %"$phi628.0.2.1.in.sroa.speculated.i", %switch.load
  %.748.i5989.i = fadd double %t.2.0.i, %.746.i.i
  %.863.i5990.i = mul nuw nsw i64 %.687.i5985.i, %.82419612000.i
  %.860.i5991.i = mul nuw nsw i64 %.616.0584.i5984.i, %.82419612000.i
  %.909.not.i5998.i = icmp ult i64 %.860.i5991.i, %.99519802032.i
  br i1 %.909.not.i5998.i, label %switch.end.else.endif.endif.endif.i6006.i, label %switch.end.else.endif.if.i5999.i, !prof !4
switch.end.endif.i6010.i:
  %.889.sroa.13.0.i6011.i = phi i64 [ %.99519802032.i, %switch.end.else.endif.endif.endif.if.i6009.i ], [ %.863.i5990.i, %switch.end.else.endif.endif.endif.i6006.i ]
  %.977.i6012.i = sub nsw i64 %.889.sroa.13.0.i6011.i, %.889.sroa.0.3.i6001.i
  %.1002.i6013.i = getelementptr double, ptr %.101119812031.i, i64 %.889.sroa.0.3.i6001.i
  %.148211.not.i.i6014.i = icmp slt i64 %.977.i6012.i, 1
  br i1 %.148211.not.i.i6014.i, label %b67, label %B58.if.i.i6015.i
B164.i.i6035.i:
  %.44.i.i.i6036.i = getelementptr i8, ptr %34, i64 24
  %.45.i.i.i6037.i = load double, ptr %.44.i.i.i6036.i, align 8, !noalias !60
  %.73.i.i.i6038.i = getelementptr i8, ptr %34, i64 32
  %.74.i.i.i6039.i = load double, ptr %.73.i.i.i6038.i, align 8, !noalias !60
  %.75.i.i.i6040.i = fmul double %.74.i.i.i6039.i, 5.000000e-01
  %.76.i.i.i6041.i = fmul double %.245.i.i6021.i, %.75.i.i.i6040.i
  %.77.i.i.i6042.i = fadd double %.45.i.i.i6037.i, %.76.i.i.i6041.i
  %.78.i.i.i6043.i = fmul double %.245.i.i6021.i, %.77.i.i.i6042.i
  %.87.le.i.i.i6044.i = tail call double @llvm.floor.f64(double %.78.i.i.i6043.i)
  %.92.i.i.i6045.i = fsub double %.78.i.i.i6043.i, %.87.le.i.i.i6044.i
  %.93.i.i.i6046.i = fmul double %.92.i.i.i6045.i, 0x401921FB54442D18
  %.121.i.i.i6047.i = getelementptr i8, ptr %34, i64 40
  %.122.i.i.i6048.i = load double, ptr %.121.i.i.i6047.i, align 8, !noalias !60
  %.126.i.i.i6049.i = fadd double %.122.i.i.i6048.i, %.93.i.i.i6046.i
  %.593.le.i.i6050.i = tail call double @llvm.sin.f64(double %.126.i.i.i6049.i)
  %.598.i.i6051.i = fmul double %.423.i.i6028.i, %.593.le.i.i6050.i
  %.600.i.i6052.i = fadd double %.361.i.i6026.i, %.598.i.i6051.i
  br label %B272.i.i6030.i
B272.i.i6030.i:
  %value.2.1.i.i6031.i = phi double [ %.600.i.i6052.i, %B164.i.i6035.i ], [ %.361.i.i6026.i, %B58.if.i.i6015.i ]
  %33 = getelementptr double, ptr %.1002.i6013.i, i64 %.90.0213.i.i6016.i
  store double %value.2.1.i.i6031.i, ptr %33, align 8, !noalias !67
  %exitcond.not.i.i6032.i = icmp eq i64 %.977.i6012.i, %.161.i.i6017.i
  br i1 %exitcond.not.i.i6032.i, label %b67, label %B58.if.i.i6015.i
B58.if.i.i6015.i:
  %.90.0213.i.i6016.i = phi i64 [ %.161.i.i6017.i, %B272.i.i6030.i ], [ 0, %switch.end.endif.i6010.i ]
  %.161.i.i6017.i = add nuw nsw i64 %.90.0213.i.i6016.i, 1
  %.idx5563 = mul i64 %.90.0213.i.i6016.i, 56
  %34 = getelementptr i8, ptr %.2706, i64 %.idx5563
  %.242.i.i6019.i = getelementptr i8, ptr %34, i64 48
  %.243.i.i6020.i = load double, ptr %.242.i.i6019.i, align 8, !noalias !67
  %.245.i.i6021.i = fsub double %.748.i5989.i, %.243.i.i6020.i
  %.303.i.i6022.i = load double, ptr %34, align 8, !noalias !67
  %.357.i.i6023.i = getelementptr i8, ptr %34, i64 8
  %.358.i.i6024.i = load double, ptr %.357.i.i6023.i, align 8, !noalias !67
  %.360.i.i6025.i = fmul double %.245.i.i6021.i, %.358.i.i6024.i
  %.361.i.i6026.i = fadd double %.303.i.i6022.i, %.360.i.i6025.i
  %.422.i.i6027.i = getelementptr i8, ptr %34, i64 16
  %.423.i.i6028.i = load double, ptr %.422.i.i6027.i, align 8, !noalias !67
  %.424.i.i6029.i = fcmp une double %.423.i.i6028.i, 0.000000e+00
  br i1 %.424.i.i6029.i, label %B164.i.i6035.i, label %B272.i.i6030.i
b67:
  %exitcond.not.i6034.i = icmp eq i64 %.687.i5985.i, 4
  br i1 %exitcond.not.i6034.i, label %B680.i, label %B68.if.i5983.i
switch.end.else.endif.if.i5999.i:
  br label %switch.end.else.endif.endif.endif.i6006.i
switch.end.else.endif.endif.endif.i6006.i:
  %.889.sroa.0.3.i6001.i = phi i64 [ %.99519802032.i, %switch.end.else.endif.if.i5999.i ], [ %.860.i5991.i, %B68.if.i5983.i ]
  %.926.not.i6008.i = icmp ult i64 %.863.i5990.i, %.99519802032.i
  br i1 %.926.not.i6008.i, label %switch.end.endif.i6010.i, label %switch.end.else.endif.endif.endif.if.i6009.i, !prof !4
switch.end.else.endif.endif.endif.if.i6009.i:
  br label %switch.end.endif.i6010.i
B680.i:
  %.2308.i = fsub double %arg.segment.1.sink.i.i, %t.2.0.i
  %.2309.i = fmul double %.2308.i, 0x3FEFFFFFFFFFDCD1
  %.2311.i = fcmp ult double %"$phi628.0.2.1.in.sroa.speculated.i", %.2309.i
  %.2320.i = fadd double %t.2.0.i, %"$phi628.0.2.1.in.sroa.speculated.i"
  %"$phi716.0.2.1.i" = select i1 %.2311.i, double %.2320.i, double %arg.segment.1.sink.i.i
  store double %t.2.0.i, ptr %.1354.i, align 8, !noalias !56
  store double %"$phi628.0.2.1.in.sroa.speculated.i", ptr %.2173, align 8, !noalias !56
  tail call void %.2529.i(ptr nonnull %.1354.i, ptr %.4926.i, ptr %.101119812031.i, ptr %.161.i, ptr %.305421902210.i, ptr %.181920692085.i, ptr %.3225.i, ptr %.217720922108.i, ptr %.3396.i, ptr %.3739.i), !noalias !56
  br i1 %.585727.not.i.i.i, label %b68, label %B84.if.i.i
b68:
  %.27056116.i = load i64, ptr %.2704.i, align 8, !noalias !56
  %.27066117.i = add nsw i64 %.27056116.i, 1
  store i64 %.27066117.i, ptr %.2704.i, align 8, !noalias !56
  br label %B1092.i
B164.i.i:
  %35 = getelementptr i8, ptr %.4485.i, i64 %.522.01421.i.i
  %.848.i.i = load i8, ptr %35, align 1, !noalias !68
  %.852.i.i = icmp ne i8 %.848.i.i, 0
  %.855.i.i = fcmp ole double %.760.i.i, 0.000000e+00
  %or.cond.i6060.i = and i1 %.855.i.i, %.852.i.i
  br i1 %or.cond.i6060.i, label %b69, label %B240.i.i
B240.i.i:
  %36 = getelementptr double, ptr %.3567.i, i64 %.522.01421.i.i
  %.1135.i.i = load double, ptr %36, align 8, !noalias !68
  %.1193.i.i = getelementptr double, ptr %12, i64 %.522.01421.i.i
  %.1194.i.i = load double, ptr %.1193.i.i, align 8, !noalias !68
  %.1248.i.i = getelementptr double, ptr %.249.i, i64 %.522.01421.i.i
  %.1249.i.i = load double, ptr %.1248.i.i, align 8, !noalias !68
  %37 = getelementptr double, ptr %.4926.i, i64 %.522.01421.i.i
  %.1284.i.i = load double, ptr %37, align 8, !noalias !68
  %.1290.i.i = tail call double @llvm.fabs.f64(double %.1284.i.i)
  %.1292.i.i = tail call double @llvm.fabs.f64(double %.760.i.i)
  %.12.i.i6061.i = fcmp ogt double %.1292.i.i, %.1290.i.i
  %.13.i.i6062.i = select i1 %.12.i.i6061.i, double %.1292.i.i, double %.1290.i.i
  %.1139.i.i = tail call double @llvm.fabs.f64(double %.1135.i.i)
  %.1323.i.i = fmul double %.1249.i.i, %.13.i.i6062.i
  %.1324.i.i = fadd double %.1194.i.i, %.1323.i.i
  %.1328.i.i = fdiv double %.1139.i.i, %.1324.i.i
  %.1334.inv.i.i = fcmp ole double %.1328.i.i, %worst.2.01422.i.i
  %worst.3.1.i.i = select i1 %.1334.inv.i.i, double %worst.2.01422.i.i, double %.1328.i.i
  %exitcond.not.i6063.i = icmp eq i64 %.593.i.i, %.481.fca.6.load.i
  br i1 %exitcond.not.i6063.i, label %b70, label %B84.if.i.i
B84.if.i.i:
  %worst.2.01422.i.i = phi double [ %worst.3.1.i.i, %B240.i.i ], [ 0.000000e+00, %B680.i ]
  %.522.01421.i.i = phi i64 [ %.593.i.i, %B240.i.i ], [ 0, %B680.i ]
  %.593.i.i = add nuw nsw i64 %.522.01421.i.i, 1
  %38 = getelementptr double, ptr %.3739.i, i64 %.522.01421.i.i
  %.760.i.i = load double, ptr %38, align 8, !noalias !68
  %.775.le.i.i = fsub double %.760.i.i, %.760.i.i
  %.776.le.i.i = fcmp ord double %.775.le.i.i, 0.000000e+00
  br i1 %.776.le.i.i, label %B164.i.i, label %b69
b69:
  %.27056105.i = load i64, ptr %.2704.i, align 8, !noalias !56
  %.27066106.i = add nsw i64 %.27056105.i, 1
  store i64 %.27066106.i, ptr %.2704.i, align 8, !noalias !56
  br label %B1034.i
b70:
  %.2705.i = load i64, ptr %.2704.i, align 8, !noalias !56
  %.2706.i = add nsw i64 %.2705.i, 1
  store i64 %.2706.i, ptr %.2704.i, align 8, !noalias !56
  %.2738.i = fcmp ugt double %worst.3.1.i.i, 1.000000e+00
  br i1 %.2738.i, label %B1034.i, label %B1092.i
B1034.i:
  %storemerge1418.i6108.i = phi double [ 0x7FF0000000000000, %b69 ], [ %worst.3.1.i.i, %b70 ]
  %.2751.le.i = fsub double %storemerge1418.i6108.i, %storemerge1418.i6108.i
  %.2752.le.i = fcmp ord double %.2751.le.i, 0.000000e+00
  %or.cond6164.i = and i1 %.4657.i, %.2752.le.i
  br i1 %or.cond6164.i, label %B1200.i, label %for.end.1.i
B1092.i:
  %storemerge1418.i6109.i = phi double [ %worst.3.1.i.i, %b70 ], [ 0.000000e+00, %b68 ]
  %.2798.i = load i64, ptr %.5090.i, align 8, !noalias !56
  %.2806.i = icmp sge i64 %.2798.i, %.481.fca.21.load.i
  %brmerge.i = select i1 %.2806.i, i1 true, i1 %.4657.i
  br i1 %brmerge.i, label %B1200.i, label %B1150.i
B1150.i:
  %.2813.i = fcmp oeq double %"$phi716.0.2.1.i", %arg.segment.1.sink.i.i
  %.2818.i = fneg double %"$phi628.0.2.1.in.sroa.speculated.i"
  %"$phi1170.0.2.2.i" = select i1 %.2813.i, double %.2818.i, double %"$phi628.0.2.1.in.sroa.speculated.i"
  %.2871.i = icmp slt i64 %.2798.i, 0
  %.2872.i = select i1 %.2871.i, i64 %.481.fca.21.load.i, i64 0
  %39 = getelementptr double, ptr %.4584.i, i64 %.2798.i
  %.2886.i = getelementptr double, ptr %39, i64 %.2872.i
  store double %"$phi1170.0.2.2.i", ptr %.2886.i, align 8, !noalias !56
  br label %B1200.i
B1200.i:
  %storemerge1418.i61096151.i = phi double [ %storemerge1418.i6109.i, %B1150.i ], [ %storemerge1418.i6109.i, %B1092.i ], [ %storemerge1418.i6108.i, %B1034.i ]
  call void @llvm.lifetime.start.p0(ptr nonnull %.1113.i.i), !noalias !56
  call void @llvm.lifetime.start.p0(ptr nonnull %.1313.i.i), !noalias !56
  call void @llvm.lifetime.start.p0(ptr nonnull %.1437.i.i), !noalias !56
  br i1 %.1415.i, label %B78.if.i.i6070.i, label %B166.i.i
B78.if.i.i6070.i:
  %first.2.0129.i.i6071.i = phi double [ %.13.i.i.i6076.i, %B78.if.i.i6070.i ], [ 0x7FF0000000000000, %B1200.i ]
  %.106.0128.i.i6072.i = phi i64 [ %.177.i.i6073.i, %B78.if.i.i6070.i ], [ 0, %B1200.i ]
  %.177.i.i6073.i = add nuw nsw i64 %.106.0128.i.i6072.i, 1
  %40 = getelementptr double, ptr %.4376.i, i64 %.106.0128.i.i6072.i
  %.235.i.i6074.i = load double, ptr %40, align 8, !noalias !71
  %.12.i.i.i6075.i = fcmp olt double %.235.i.i6074.i, %first.2.0129.i.i6071.i
  %.13.i.i.i6076.i = select i1 %.12.i.i.i6075.i, double %.235.i.i6074.i, double %first.2.0129.i.i6071.i
  %exitcond.not.i.i6077.i = icmp eq i64 %.251121222161.i, %.177.i.i6073.i
  br i1 %exitcond.not.i.i6077.i, label %b71, label %B78.if.i.i6070.i
b71:
  %.5.i.i6079.i = fmul double %"$phi716.0.2.1.i", 0x3D06849B86A12B9B
  %.6.i.i6080.i = fadd double %.5.i.i6079.i, 1.000000e-15
  %.668.i.i = fsub double %"$phi716.0.2.1.i", %.6.i.i6080.i
  %.669.i.i = fcmp olt double %.13.i.i.i6076.i, %.668.i.i
  br label %B166.i.i
B166.i.i:
  %"$phi166.0.2.0.i.i" = phi i1 [ %.669.i.i, %b71 ], [ false, %B1200.i ]
  %brmerge.i6064.i = select i1 %.2917, i1 true, i1 %"$phi166.0.2.0.i.i"
  br i1 %brmerge.i6064.i, label %B404.i.i, label %B234.i.i
B234.i.i:
  %.812.i.i = load i64, ptr %.980.i, align 8, !noalias !76
  %.825.i.i = icmp slt i64 %.812.i.i, 0
  %.826.i.i = select i1 %.825.i.i, i64 %.481.fca.19.load.i, i64 0
  %41 = getelementptr double, ptr %.4687.i, i64 %.812.i.i
  %.840.i.i = getelementptr double, ptr %41, i64 %.826.i.i
  %.841.i.i = load double, ptr %.840.i.i, align 8, !noalias !76
  %.846.i.i = fcmp olt double %.841.i.i, %"$phi716.0.2.1.i"
  br i1 %.846.i.i, label %B404.thread3043.i.i, label %B534.i.i
B404.thread3043.i.i:
  tail call void %.10933044.i.i(ptr %.3396.i, ptr %.3911.i), !noalias !76
  br label %B534.i.i
B404.i.i:
  tail call void %.10933044.i.i(ptr %.3396.i, ptr %.3911.i), !noalias !76
  br i1 %.2917, label %B408.i.i, label %B534.i.i
B408.i.i:
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %.1113.i.i, i8 0, i64 16, i1 false), !noalias !76
  call fastcc void @v49(ptr %.1113.i.i, i64 %.481.fca.3.load.i, ptr %.161.i, ptr %.2869.i, ptr readonly %.4804.i, i64 2, ptr readonly %.4854.i, i64 %.481.fca.20.load.i, i64 3, i64 %.82419612000.i, ptr %.84019621999.i, ptr nonnull %.1354.i, ptr %.3911.i, i64 %.3895.i, i64 %.4067.i, ptr %.4083.i, i64 %.481.fca.5.load.i, ptr %.4926.i, ptr readonly %.2706, i64 7, double %t.2.0.i, double %"$phi628.0.2.1.in.sroa.speculated.i", ptr readonly %.3739.i)
  %.1220.fca.0.load.i.i = load i64, ptr %.1113.i.i, align 8, !noalias !76
  %.1220.fca.1.load.i.i = load double, ptr %.fca.1.gep.i.i, align 8, !noalias !76
  %.1247.i.i = fmul double %"$phi628.0.2.1.in.sroa.speculated.i", %.1220.fca.1.load.i.i
  %.1250.i.i = fadd double %t.2.0.i, %.1247.i.i
  %.12373045.i.i = icmp slt i64 %.1220.fca.0.load.i.i, 0
  %"$phi510.1.2.0.i.i" = select i1 %.12373045.i.i, double %"$phi716.0.2.1.i", double %.1250.i.i
  store i64 %.1220.fca.0.load.i.i, ptr %.2004, align 8, !noalias !76
  br label %B582.i.i
B534.i.i:
  br i1 %"$phi166.0.2.0.i.i", label %B538.i.i, label %B582.i.i
B538.i.i:
  store double 0.000000e+00, ptr %.1313.i.i, align 8, !noalias !76
  call fastcc void @v50(ptr %.1313.i.i, i64 %.481.fca.3.load.i, i64 %.481.fca.4.load.i, ptr %.161.i, i64 %.4360.i, ptr %.4376.i, ptr readonly %.4409.i, i64 %.251121222161.i, ptr %.252721232160.i, ptr %.269821422175.i, i64 %.481.fca.6.load.i, i64 %.481.fca.19.load.i, ptr readonly %.4687.i, i64 %.481.fca.19.load.i, ptr %.4729.i, i64 %.481.fca.19.load.i, i64 %.2853.i, ptr %.2869.i, i64 %.82419612000.i, ptr %.84019621999.i, ptr nonnull %.1354.i, ptr %.3225.i, i64 %.3209.i, ptr %.3911.i, i64 %.3895.i, i64 %.4067.i, ptr %.4083.i, i64 %.481.fca.5.load.i, ptr %.4926.i, ptr nonnull %.5090.i, ptr readonly %.2706, i64 7, double %t.2.0.i, double %"$phi628.0.2.1.in.sroa.speculated.i", double %"$phi716.0.2.1.i", ptr readonly %.3739.i)
  %.1420.i.i = load double, ptr %.1313.i.i, align 8, !noalias !76
  br label %B582.i.i
B582.i.i:
  %reached.3.0.i.i = phi double [ %"$phi510.1.2.0.i.i", %B408.i.i ], [ %.1420.i.i, %B538.i.i ], [ %"$phi716.0.2.1.i", %B534.i.i ]
  call fastcc void @v51(ptr %.1437.i.i, i64 %.481.fca.3.load.i, ptr %.161.i, i64 %.481.fca.6.load.i, i64 %.481.fca.19.load.i, ptr readonly %.4687.i, i64 %.481.fca.19.load.i, ptr %.4729.i, i64 %.481.fca.19.load.i, i64 %.2853.i, ptr %.2869.i, i64 %.82419612000.i, ptr %.84019621999.i, ptr nonnull %.1354.i, ptr %.3225.i, i64 %.3209.i, ptr %.3911.i, i64 %.3895.i, i64 %.481.fca.5.load.i, ptr %.4926.i, ptr nonnull %.5090.i, ptr readonly %.2706, i64 7, double %t.2.0.i, double %"$phi628.0.2.1.in.sroa.speculated.i", ptr readonly %.3739.i, double %reached.3.0.i.i)
  %.1590.i.i = load i64, ptr %.2004, align 8, !noalias !76
  %.1596.i.i = icmp sgt i64 %.1590.i.i, -1
  %.1839.i.i = fcmp olt double %reached.3.0.i.i, %"$phi716.0.2.1.i"
  %or.cond.i6065.i = select i1 %.1596.i.i, i1 true, i1 %.1839.i.i
  %spec.select.i6066.i = select i1 %or.cond.i6065.i, ptr %.4083.i, ptr %.3739.i
  br label %B76.if.i.i.i
B76.if.i.i.i:
  %.519.0852.i.i.i = phi i64 [ %.590.i.i.i, %B76.if.i.i.i ], [ 0, %B582.i.i ]
  %.590.i.i.i = add nuw nsw i64 %.519.0852.i.i.i, 1
  %42 = getelementptr double, ptr %spec.select.i6066.i, i64 %.519.0852.i.i.i
  %.644.i.i.i = load double, ptr %42, align 8, !noalias !77
  %gep.i.i.i = getelementptr double, ptr %invariant.gep.i.i.i, i64 %.519.0852.i.i.i
  %.677.i.i.i = load double, ptr %gep.i.i.i, align 8, !noalias !77
  %43 = getelementptr double, ptr %.4926.i, i64 %.519.0852.i.i.i
  %.707.i.i.i = load double, ptr %43, align 8, !noalias !77
  %.708.i.i.i = fsub double %.644.i.i.i, %.707.i.i.i
  %.709.i.i.i = tail call double @llvm.fabs.f64(double %.708.i.i.i)
  %.710.i.i.i = fadd double %.677.i.i.i, %.709.i.i.i
  store double %.710.i.i.i, ptr %gep.i.i.i, align 8, !noalias !77
  store double %.644.i.i.i, ptr %43, align 8, !noalias !77
  %44 = getelementptr double, ptr %.4967.i, i64 %.519.0852.i.i.i
  %.800.i.i6068.i = load double, ptr %44, align 8, !noalias !77
  %.12.i.i3040.i.i = fcmp olt double %.644.i.i.i, %.800.i.i6068.i
  %.13.i.i3041.i.i = select i1 %.12.i.i3040.i.i, double %.644.i.i.i, double %.800.i.i6068.i
  %gep854.i.i.i = getelementptr double, ptr %invariant.gep853.i.i.i, i64 %.519.0852.i.i.i
  %.860.i.i.i = load double, ptr %gep854.i.i.i, align 8, !noalias !77
  %.12.i848.i.i.i = fcmp ogt double %.644.i.i.i, %.860.i.i.i
  %.13.i849.i.i.i = select i1 %.12.i848.i.i.i, double %.644.i.i.i, double %.860.i.i.i
  store double %.13.i.i3041.i.i, ptr %44, align 8, !noalias !77
  store double %.13.i849.i.i.i, ptr %gep854.i.i.i, align 8, !noalias !77
  %exitcond.not.i3042.i.i = icmp eq i64 %.590.i.i.i, %.481.fca.5.load.i
  br i1 %exitcond.not.i3042.i.i, label %b72, label %B76.if.i.i.i
b72:
  %.1124.i.i.i = load i64, ptr %.5090.i, align 8, !noalias !77
  %.1125.i.i.i = add nsw i64 %.1124.i.i.i, 1
  store i64 %.1125.i.i.i, ptr %.5090.i, align 8, !noalias !77
  call void @llvm.lifetime.end.p0(ptr nonnull %.1113.i.i), !noalias !56
  call void @llvm.lifetime.end.p0(ptr nonnull %.1313.i.i), !noalias !56
  call void @llvm.lifetime.end.p0(ptr nonnull %.1437.i.i), !noalias !56
  store double %reached.3.0.i.i, ptr %.5009.i, align 8, !noalias !56
  %.3105.i = load i64, ptr %.2004, align 8, !noalias !56
  %.3106.i = icmp sgt i64 %.3105.i, -1
  br i1 %.3106.i, label %B1718, label %B1350.i
B1350.i:
  %.12.i.i = fcmp olt double %storemerge1418.i61096151.i, 1.000000e-10
  %.13.i6081.i = select i1 %.12.i.i, double 1.000000e-10, double %storemerge1418.i61096151.i
  %.12.le.i.i.i = tail call double @llvm.sqrt.f64(double %.13.i6081.i)
  %.24.le.i.i.i = tail call double @llvm.sqrt.f64(double %.12.le.i.i.i)
  %.47.i.i = fdiv double 9.000000e-01, %.24.le.i.i.i
  %.56.i.i = fcmp ogt double %step_before.3.0.i, 0.000000e+00
  br i1 %.56.i.i, label %B62.i.i, label %b73
B62.i.i:
  %.72.i.i = fmul double %.13.i6081.i, %.13.i6081.i
  %.79.i.i = fdiv double %error_before.2.0.i, %.72.i.i
  %.12.le.i5.i.i = tail call double @llvm.sqrt.f64(double %.79.i.i)
  %.24.le.i6.i.i = tail call double @llvm.sqrt.f64(double %.12.le.i5.i.i)
  %.63.i.i = fdiv double %"$phi628.0.2.1.in.sroa.speculated.i", %step_before.3.0.i
  %.68.i.i = fmul double %.63.i.i, 9.000000e-01
  %.106.i.i = fmul double %.68.i.i, %.24.le.i6.i.i
  %.12.i.i6082.i = fcmp olt double %.106.i.i, %.47.i.i
  %.13.i.i6083.i = select i1 %.12.i.i6082.i, double %.106.i.i, double %.47.i.i
  br label %b73
b73:
  %factor.2.0.i.i = phi double [ %.13.i.i6083.i, %B62.i.i ], [ %.47.i.i, %B1350.i ]
  %.12.i7.i.i = fcmp ogt double %factor.2.0.i.i, 1.500000e-01
  %.13.i8.i.i = select i1 %.12.i7.i.i, double %factor.2.0.i.i, double 1.500000e-01
  %.12.i9.i.i = fcmp olt double %.13.i8.i.i, 6.000000e+00
  %.13.i10.i.i = select i1 %.12.i9.i.i, double %.13.i8.i.i, double 6.000000e+00
  %.12.i6084.i = fcmp ogt double %.13.i6081.i, 1.000000e-02
  %.13.i6085.i = select i1 %.12.i6084.i, double %.13.i6081.i, double 1.000000e-02
  br i1 %has_changed.3.0.i, label %B1484.i, label %B1554.i
B1484.i:
  %.12.i6086.i = fcmp ogt double %.13.i10.i.i, 5.000000e-01
  %.13.i6087.i = select i1 %.12.i6086.i, double %.13.i10.i.i, double 5.000000e-01
  %.12.i6088.i = fcmp olt double %.13.i6087.i, 2.000000e+00
  %.13.i6089.i = select i1 %.12.i6088.i, double %.13.i6087.i, double 2.000000e+00
  %.3560.i = fmul double %"$phi628.0.2.1.in.sroa.speculated.i", %.13.i6089.i
  br label %B1554.i
B1554.i:
  %first.2.1.i = phi double [ %.3560.i, %B1484.i ], [ %first.3.0.i, %b73 ]
  %.3568.i = fcmp olt double %"$phi628.0.2.1.in.sroa.speculated.i", %desired.2.0.sink.i.i
  br i1 %.3568.i, label %B1566.i, label %B1604.i
B1566.i:
  %.3574.i = fmul double %"$phi628.0.2.1.in.sroa.speculated.i", %.13.i10.i.i
  %.12.i6090.i = fcmp ogt double %.3574.i, %desired.2.0.sink.i.i
  %.13.i6091.i = select i1 %.12.i6090.i, double %.3574.i, double %desired.2.0.sink.i.i
  br label %B1648.i
B1604.i:
  %.12.i6092.i = fcmp olt double %.13.i10.i.i, 1.000000e+00
  %.13.i6093.i = select i1 %.12.i6092.i, double %.13.i10.i.i, double 1.000000e+00
  %"$phi1644.1.2.1.i" = select i1 %rejected.3.0.i, double %.13.i6093.i, double %.13.i10.i.i
  %.3669.i = fmul double %"$phi628.0.2.1.in.sroa.speculated.i", %"$phi1644.1.2.1.i"
  br label %B1648.i
B1648.i:
  %"$phi1648.0.2.1.i" = phi double [ %.13.i6091.i, %B1566.i ], [ %.3669.i, %B1604.i ]
  %.3753.i = fcmp olt double %reached.3.0.i.i, %.818.i.i
  %or.cond6134.i = select i1 %.1415.i, i1 %.3753.i, i1 false
  br i1 %or.cond6134.i, label %B1712.i, label %B2078.i
B1712.i:
  store i8 0, ptr %.3776.i, align 1, !noalias !56
  call fastcc void @v48(ptr %.3776.i, i64 %.481.fca.4.load.i, ptr %.161.i, i64 %.4360.i, ptr %.4376.i, ptr readonly %.4409.i, i64 %.251121222161.i, ptr %.252721232160.i, ptr %.269821422175.i, i64 %.82419612000.i, ptr %.84019621999.i, ptr nonnull %.1354.i, ptr readonly %.2706, i64 7, double %reached.3.0.i.i, ptr nonnull %.4926.i)
  %.3883.i = load i8, ptr %.3776.i, align 1, !noalias !56
  %.3886.not.i = icmp ne i8 %.3883.i, 0
  %brmerge5934.i = select i1 %.3886.not.i, i1 true, i1 %.1839.i.i
  br i1 %brmerge5934.i, label %B1776.i, label %B2078.i
B1776.i:
  %.12.i6094.i = fcmp olt double %first.2.1.i, %"$phi1648.0.2.1.i"
  %.13.i6095.i = select i1 %.12.i6094.i, double %first.2.1.i, double %"$phi1648.0.2.1.i"
  br label %B2078.i
B1870.i:
  %.12.le.i.i = tail call double @llvm.sqrt.f64(double %storemerge1418.i6108.i)
  %.24.le.i.i = tail call double @llvm.sqrt.f64(double %.12.le.i.i)
  %.4137.i = fdiv double 9.000000e-01, %.24.le.i.i
  %.12.i6096.i = fcmp olt double %.4137.i, 8.000000e-01
  %.13.i6097.i = select i1 %.12.i6096.i, double %.4137.i, double 8.000000e-01
  %.12.i6098.i = fcmp ogt double %.13.i6097.i, 1.500000e-01
  %.13.i6099.i = select i1 %.12.i6098.i, double %.13.i6097.i, double 1.500000e-01
  br label %B2004.i
B2004.i:
  %"$phi2004.1.2.2.i" = phi double [ %.13.i6099.i, %B1870.i ], [ 1.500000e-01, %for.end.1.i ]
  %.4205.i = fmul double %"$phi628.0.2.1.in.sroa.speculated.i", %"$phi2004.1.2.2.i"
  %.4218.i = fadd double %t.2.0.i, %.4205.i
  %.4220.i = fcmp ole double %.4218.i, %t.2.0.i
  %.4223.i = fcmp olt double %.4205.i, 1.000000e-300
  %or.cond.i5462 = or i1 %.4223.i, %.4220.i
  %brmerge5936.i = select i1 %or.cond.i5462, i1 true, i1 %.4657.i
  br i1 %brmerge5936.i, label %B1934.loopexit, label %B2078.i
B2078.i:
  %h.7.1.i = phi double [ %.4205.i, %B2004.i ], [ %"$phi1648.0.2.1.i", %B1712.i ], [ %.13.i6095.i, %B1776.i ], [ %"$phi1648.0.2.1.i", %B1648.i ]
  %t.3.1.i = phi double [ %t.2.0.i, %B2004.i ], [ %reached.3.0.i.i, %B1712.i ], [ %reached.3.0.i.i, %B1776.i ], [ %reached.3.0.i.i, %B1648.i ]
  %error_before.3.1.i = phi double [ %error_before.2.0.i, %B2004.i ], [ %.13.i6085.i, %B1712.i ], [ %.13.i6085.i, %B1776.i ], [ %.13.i6085.i, %B1648.i ]
  %step_before.4.1.i = phi double [ %step_before.3.0.i, %B2004.i ], [ %"$phi628.0.2.1.in.sroa.speculated.i", %B1712.i ], [ 0.000000e+00, %B1776.i ], [ %"$phi628.0.2.1.in.sroa.speculated.i", %B1648.i ]
  %rejected.4.1.i = phi i1 [ true, %B2004.i ], [ false, %B1712.i ], [ false, %B1776.i ], [ false, %B1648.i ]
  %fresh.4.1.i = phi i1 [ false, %B2004.i ], [ true, %B1712.i ], [ true, %B1776.i ], [ true, %B1648.i ]
  %calm.3.1.i = phi double [ %calm.2.0.i, %B2004.i ], [ %calm.2.0.i, %B1712.i ], [ %reached.3.0.i.i, %B1776.i ], [ %calm.2.0.i, %B1648.i ]
  %first.4.1.i = phi double [ %first.3.0.i, %B2004.i ], [ %first.2.1.i, %B1712.i ], [ %first.2.1.i, %B1776.i ], [ %first.2.1.i, %B1648.i ]
  %has_changed.4.1.i = phi i1 [ %has_changed.3.0.i, %B2004.i ], [ false, %B1712.i ], [ true, %B1776.i ], [ false, %B1648.i ]
  %has_acted.3.1.i = phi i1 [ %has_acted.5.0.i, %B2004.i ], [ true, %B1712.i ], [ true, %B1776.i ], [ %has_acted.5.0.i, %B1648.i ]
  %.570.i.i = load i64, ptr %.2704.i, align 8, !noalias !80
  %.590.i.i = srem i64 %.570.i.i, 400
  %.592.i.i = icmp slt i64 %.590.i.i, 0
  %.601.i.i = add nsw i64 %.590.i.i, 400
  %.581.0.i.i = select i1 %.592.i.i, i64 %.601.i.i, i64 %.590.i.i
  %.611.i.i = icmp ne i64 %.581.0.i.i, 0
  br i1 %.611.i.i, label %B284.i.i, label %B104.i.i
B104.i.i:
  %.522.i.i = load double, ptr %.2619, align 8, !noalias !80
  %.615.i.i = fsub double %t.3.1.i, %window.2.0.i
  %.620.i.i = fsub double %.522.i.i, %window.2.0.i
  %.625.i.i = fmul double %.620.i.i, 1.000000e-04
  %.626.i.i = fcmp uge double %.615.i.i, %.625.i.i
  %.675.i.i = load i64, ptr %.5090.i, align 8, !noalias !80
  %.705.i.i = load i64, ptr %.704.i.i, align 8, !noalias !80
  %.706.i.i = sub nsw i64 %.675.i.i, %.705.i.i
  %.748.i6101.i = icmp sgt i64 %.706.i.i, 279
  %45 = select i1 %.748.i6101.i, i1 true, i1 %.626.i.i
  %brmerge.i6102.i = select i1 %45, i1 true, i1 %has_acted.3.1.i
  br i1 %brmerge.i6102.i, label %B242.i.i, label %B1934.loopexit
B242.i.i:
  store i64 %.675.i.i, ptr %.704.i.i, align 8, !noalias !80
  br label %B284.i.i
B284.i.i:
  %.1010.i.i = sitofp i64 %.570.i.i to double
  %.1011.i.i = fcmp ugt double %.4582.i, %.1010.i.i
  br i1 %.1011.i.i, label %B352.i.i, label %B1934.loopexit
B352.i.i:
  %.1284.i6100.i = load double, ptr %.1283.i.i, align 8, !noalias !80
  %.1288.i.i = fcmp une double %.1284.i6100.i, 0.000000e+00
  br i1 %.1288.i.i, label %B1934.loopexit, label %B2156.i
B2156.i:
  %window.3.1.i = select i1 %.611.i.i, double %window.2.0.i, double %t.3.1.i
  %has_acted.6.1.i = select i1 %.611.i.i, i1 %has_acted.3.1.i, i1 false
  %.5100.i = fcmp olt double %t.3.1.i, %"$phi1276.4.2.1"
  br i1 %.5100.i, label %B396.i, label %B1718.thread5638
for.end.1.i:
  br i1 %.2752.le.i, label %B1870.i, label %B2004.i
B1624:
  call void @llvm.lifetime.start.p0(ptr nonnull %.648.i)
  call void @llvm.lifetime.start.p0(ptr nonnull %.1307.i)
  call void @llvm.lifetime.start.p0(ptr nonnull %.1528.i)
  %.580.i = fcmp olt double %.2539, %"$phi1276.4.2.1"
  br i1 %.580.i, label %B90.preheader.i, label %b74
b74:
  %.3561.pre = load i64, ptr %.2004, align 8
  br label %b55
B90.preheader.i:
  %.5.i.i = fmul double %"$phi1276.4.2.1", 0x3D06849B86A12B9B
  %.6.i.i = fadd double %.5.i.i, 1.000000e-15
  %.874.i = fsub double %"$phi1276.4.2.1", %.6.i.i
  br label %B90.i
B90.i:
  %t.2.0.i5484 = phi double [ %end.5.1.i, %B826.i ], [ %.2539, %B90.preheader.i ]
  br i1 %.636.i5483.not, label %B304.i, label %B136.i
B136.i:
  call fastcc void @v48(ptr %.648.i, i64 %.481.fca.4.load.i, ptr %.161.i, i64 %.4360.i, ptr %.4376.i, ptr readonly %.4409.i, i64 %.251121222161.i, ptr %.252721232160.i, ptr %.269821422175.i, i64 %.82419612000.i, ptr %.84019621999.i, ptr %.1354.i, ptr readonly %.2706, i64 7, double %t.2.0.i5484, ptr %.4926.i)
  br label %B78.if.i.i
B78.if.i.i:
  %first.2.0129.i.i = phi double [ %.13.i.i.i5490, %B78.if.i.i ], [ 0x7FF0000000000000, %B136.i ]
  %.106.0128.i.i = phi i64 [ %.177.i.i, %B78.if.i.i ], [ 0, %B136.i ]
  %.177.i.i = add nuw nsw i64 %.106.0128.i.i, 1
  %46 = getelementptr double, ptr %.4376.i, i64 %.106.0128.i.i
  %.235.i.i = load double, ptr %46, align 8, !noalias !83
  %.12.i.i.i5489 = fcmp olt double %.235.i.i, %first.2.0129.i.i
  %.13.i.i.i5490 = select i1 %.12.i.i.i5489, double %.235.i.i, double %first.2.0129.i.i
  %exitcond.not.i.i5491 = icmp eq i64 %.251121222161.i, %.177.i.i
  br i1 %exitcond.not.i.i5491, label %b75, label %B78.if.i.i
b75:
  %.876.i = fcmp olt double %.13.i.i.i5490, %.874.i
  %"$phi302.0.2.2.i" = select i1 %.876.i, double %.13.i.i.i5490, double %"$phi1276.4.2.1"
  br label %B304.i
B304.i:
  %end.4.1.i = phi double [ %"$phi302.0.2.2.i", %b75 ], [ %"$phi1276.4.2.1", %B90.i ]
  br i1 %.2917, label %B358.i, label %B826.i
B358.i:
  %.981.i = load i64, ptr %.980.i, align 8, !noalias !88
  %.998.i = icmp slt i64 %.981.i, %.996.i
  br i1 %.998.i, label %B412.i, label %B582.i5486
B412.i:
  %.1021.i = icmp slt i64 %.981.i, 0
  %.1022.i = select i1 %.1021.i, i64 %.481.fca.19.load.i, i64 0
  %47 = getelementptr double, ptr %.4687.i, i64 %.981.i
  %.1036.i = getelementptr double, ptr %47, i64 %.1022.i
  %.1037.i = load double, ptr %.1036.i, align 8, !noalias !88
  %.5.i2342.i = fmul double %t.2.0.i5484, 0x3D06849B86A12B9B
  %.6.i2343.i = fadd double %.5.i2342.i, 1.000000e-15
  %.1066.i = fadd double %t.2.0.i5484, %.6.i2343.i
  %.1067.i = fcmp ugt double %.1037.i, %.1066.i
  br i1 %.1067.i, label %B582.i5486, label %B478.i
B478.i:
  %row.2.3.i = phi i64 [ %.1073.i, %B516.i ], [ %.981.i, %B412.i ]
  %exitcond.not.i5488 = icmp eq i64 %row.2.3.i, %10
  br i1 %exitcond.not.i5488, label %B582.i5486, label %B516.i
B516.i:
  %.1073.i = add nsw i64 %row.2.3.i, 1
  %.1113.i = icmp slt i64 %row.2.3.i, -1
  %.1114.i = select i1 %.1113.i, i64 %.481.fca.19.load.i, i64 0
  %48 = getelementptr double, ptr %.4687.i, i64 %.1073.i
  %.1128.i = getelementptr double, ptr %48, i64 %.1114.i
  %.1129.i = load double, ptr %.1128.i, align 8, !noalias !88
  %.1159.i = fcmp ugt double %.1129.i, %.1066.i
  br i1 %.1159.i, label %B582.i5486, label %B478.i
B582.i5486:
  %row.3.2.i = phi i64 [ %.981.i, %B412.i ], [ %.981.i, %B358.i ], [ %.996.i, %B478.i ], [ %.1073.i, %B516.i ]
  %.1186.i5487 = icmp slt i64 %row.3.2.i, 0
  %.1187.i = select i1 %.1186.i5487, i64 %.481.fca.19.load.i, i64 0
  %49 = getelementptr double, ptr %.4687.i, i64 %row.3.2.i
  %.1201.i = getelementptr double, ptr %49, i64 %.1187.i
  %.1202.i = load double, ptr %.1201.i, align 8, !noalias !88
  %.5.i2346.i = fmul double %end.4.1.i, 0x3D06849B86A12B9B
  %.6.i2347.i = fadd double %.5.i2346.i, 1.000000e-15
  %.1229.i = fsub double %end.4.1.i, %.6.i2347.i
  %.1230.i = fcmp olt double %.1202.i, %.1229.i
  %"$phi666.0.2.2.i" = select i1 %.1230.i, double %.1202.i, double %end.4.1.i
  %.1287.i = fsub double %"$phi666.0.2.2.i", %t.2.0.i5484
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %.1307.i, i8 0, i64 16, i1 false), !noalias !88
  call fastcc void @v49(ptr %.1307.i, i64 %.481.fca.3.load.i, ptr %.161.i, ptr %.2869.i, ptr readonly %.4804.i, i64 2, ptr readonly %.4854.i, i64 %.481.fca.20.load.i, i64 3, i64 %.82419612000.i, ptr %.84019621999.i, ptr %.1354.i, ptr readonly %.3911.i, i64 %.3895.i, i64 %.4067.i, ptr %.4083.i, i64 %.481.fca.5.load.i, ptr %.4926.i, ptr readonly %.2706, i64 7, double %t.2.0.i5484, double %.1287.i, ptr %.4926.i)
  %.1414.fca.0.load.i = load i64, ptr %.1307.i, align 8, !noalias !88
  %.1414.fca.1.load.i = load double, ptr %.fca.1.gep.i5481, align 8, !noalias !88
  %.1445.i = fmul double %.1287.i, %.1414.fca.1.load.i
  %.1449.i = fadd double %t.2.0.i5484, %.1445.i
  %.14342348.i = icmp slt i64 %.1414.fca.0.load.i, 0
  %"$phi804.1.2.2.i" = select i1 %.14342348.i, double %"$phi666.0.2.2.i", double %.1449.i
  store i64 %.1414.fca.0.load.i, ptr %.2004, align 8, !noalias !88
  br label %B826.i
B826.i:
  %end.5.1.i = phi double [ %"$phi804.1.2.2.i", %B582.i5486 ], [ %end.4.1.i, %B304.i ]
  %.1505.i = fsub double %end.5.1.i, %t.2.0.i5484
  call fastcc void @v51(ptr %.1528.i, i64 %.481.fca.3.load.i, ptr %.161.i, i64 %.481.fca.6.load.i, i64 %.481.fca.19.load.i, ptr readonly %.4687.i, i64 %.481.fca.19.load.i, ptr %.4729.i, i64 %.481.fca.19.load.i, i64 %.2853.i, ptr %.2869.i, i64 %.82419612000.i, ptr %.84019621999.i, ptr %.1354.i, ptr %.3225.i, i64 %.3209.i, ptr readonly %.3911.i, i64 %.3895.i, i64 %.481.fca.5.load.i, ptr %.4926.i, ptr %.5090.i, ptr readonly %.2706, i64 7, double %t.2.0.i5484, double %.1505.i, ptr %.4926.i, double %end.5.1.i)
  %.1683.i = load i64, ptr %.2004, align 8, !noalias !88
  %.1684.i = icmp slt i64 %.1683.i, 0
  %.1837.i = fcmp olt double %end.5.1.i, %"$phi1276.4.2.1"
  %or.cond.i5485 = select i1 %.1684.i, i1 %.1837.i, i1 false
  br i1 %or.cond.i5485, label %B90.i, label %b55
b55:
  %.3561 = phi i64 [ %.3561.pre, %b74 ], [ %.1683.i, %B826.i ]
  %t.3.1.i5482 = phi double [ %.2539, %b74 ], [ %end.5.1.i, %B826.i ]
  call void @llvm.lifetime.end.p0(ptr nonnull %.648.i)
  call void @llvm.lifetime.end.p0(ptr nonnull %.1307.i)
  call void @llvm.lifetime.end.p0(ptr nonnull %.1528.i)
  %.3562 = icmp sgt i64 %.3561, -1
  br i1 %.3562, label %B1792, label %B1186
B1718.thread5638:
  %t.4.1.sink.i.ph5636 = phi double [ %.2539, %b61 ], [ %t.3.1.i, %B2156.i ]
  %h.10.1.sink.i.ph5637 = phi double [ %"$phi1566.1.2.1", %b61 ], [ %h.7.1.i, %B2156.i ]
  call void @llvm.lifetime.end.p0(ptr nonnull %.3776.i)
  br label %B1186
B1718:
  call void @llvm.lifetime.end.p0(ptr nonnull %.3776.i)
  br label %B1792
B1792:
  %.3854.pre-phi = phi i64 [ %.pre, %B1012.B1792_crit_edge ], [ %.996.i, %b58 ], [ %.996.i, %B1718 ], [ %.996.i, %b55 ], [ %.996.i, %B1186 ]
  %segment.2.sroa.84.15555 = phi ptr [ %.2268, %B1012.B1792_crit_edge ], [ %.2706, %b58 ], [ %.2706, %B1718 ], [ %.2706, %b55 ], [ %.2706, %B1186 ]
  %status.5.15554 = phi i64 [ 0, %B1012.B1792_crit_edge ], [ 1, %b58 ], [ 1, %B1718 ], [ 0, %B1186 ], [ 1, %b55 ]
  %t.4.15552 = phi double [ %.2035, %B1012.B1792_crit_edge ], [ %.2539, %b58 ], [ %reached.3.0.i.i, %B1718 ], [ %t.5.15626, %B1186 ], [ %t.3.1.i5482, %b55 ]
  %h.5.15550 = phi double [ %.2174, %B1012.B1792_crit_edge ], [ %h.3.05584, %b58 ], [ %"$phi628.0.2.1.in.sroa.speculated.i", %B1718 ], [ %h.4.15627, %B1186 ], [ %"$phi1566.1.2.1", %b55 ]
  %.3840 = getelementptr i8, ptr %.5090.i, i64 16
  %.3841 = load i64, ptr %.3840, align 8
  %.13.i = tail call i64 @llvm.smin.i64(i64 %.3854.pre-phi, i64 %.3841)
  store i64 %.13.i, ptr %.3840, align 8
  %.148211.not.i.i.i5492 = icmp eq i64 %.82419612000.i, 0
  br i1 %.148211.not.i.i.i5492, label %b76, label %B58.if.i.i.i5493
B164.i.i.i5516:
  %.44.i.i.i.i5517 = getelementptr i8, ptr %51, i64 24
  %.45.i.i.i.i5518 = load double, ptr %.44.i.i.i.i5517, align 8, !noalias !89
  %.73.i.i.i.i5519 = getelementptr i8, ptr %51, i64 32
  %.74.i.i.i.i5520 = load double, ptr %.73.i.i.i.i5519, align 8, !noalias !89
  %.75.i.i.i.i5521 = fmul double %.74.i.i.i.i5520, 5.000000e-01
  %.76.i.i.i.i5522 = fmul double %.245.i.i.i5499, %.75.i.i.i.i5521
  %.77.i.i.i.i5523 = fadd double %.45.i.i.i.i5518, %.76.i.i.i.i5522
  %.78.i.i.i.i5524 = fmul double %.245.i.i.i5499, %.77.i.i.i.i5523
  %.87.le.i.i.i.i5525 = tail call double @llvm.floor.f64(double %.78.i.i.i.i5524)
  %.92.i.i.i.i5526 = fsub double %.78.i.i.i.i5524, %.87.le.i.i.i.i5525
  %.93.i.i.i.i5527 = fmul double %.92.i.i.i.i5526, 0x401921FB54442D18
  %.121.i.i.i.i5528 = getelementptr i8, ptr %51, i64 40
  %.122.i.i.i.i5529 = load double, ptr %.121.i.i.i.i5528, align 8, !noalias !89
  %.126.i.i.i.i5530 = fadd double %.122.i.i.i.i5529, %.93.i.i.i.i5527
  %.593.le.i.i.i5531 = tail call double @llvm.sin.f64(double %.126.i.i.i.i5530)
  %.598.i.i.i5532 = fmul double %.423.i.i.i5506, %.593.le.i.i.i5531
  %.600.i.i.i5533 = fadd double %.361.i.i.i5504, %.598.i.i.i5532
  br label %B272.i.i.i5508
B272.i.i.i5508:
  %value.2.1.i.i.i5509 = phi double [ %.600.i.i.i5533, %B164.i.i.i5516 ], [ %.361.i.i.i5504, %B58.if.i.i.i5493 ]
  %50 = getelementptr double, ptr %.84019621999.i, i64 %.90.0213.i.i.i5494
  store double %value.2.1.i.i.i5509, ptr %50, align 8, !noalias !98
  %exitcond.not.i.i.i5510 = icmp eq i64 %.82419612000.i, %.161.i.i.i5495
  br i1 %exitcond.not.i.i.i5510, label %b76, label %B58.if.i.i.i5493
B58.if.i.i.i5493:
  %.90.0213.i.i.i5494 = phi i64 [ %.161.i.i.i5495, %B272.i.i.i5508 ], [ 0, %B1792 ]
  %.161.i.i.i5495 = add nuw nsw i64 %.90.0213.i.i.i5494, 1
  %.idx5564 = mul i64 %.90.0213.i.i.i5494, 56
  %51 = getelementptr i8, ptr %segment.2.sroa.84.15555, i64 %.idx5564
  %.242.i.i.i5497 = getelementptr i8, ptr %51, i64 48
  %.243.i.i.i5498 = load double, ptr %.242.i.i.i5497, align 8, !noalias !98
  %.245.i.i.i5499 = fsub double %t.4.15552, %.243.i.i.i5498
  %.303.i.i.i5500 = load double, ptr %51, align 8, !noalias !98
  %.357.i.i.i5501 = getelementptr i8, ptr %51, i64 8
  %.358.i.i.i5502 = load double, ptr %.357.i.i.i5501, align 8, !noalias !98
  %.360.i.i.i5503 = fmul double %.245.i.i.i5499, %.358.i.i.i5502
  %.361.i.i.i5504 = fadd double %.303.i.i.i5500, %.360.i.i.i5503
  %.422.i.i.i5505 = getelementptr i8, ptr %51, i64 16
  %.423.i.i.i5506 = load double, ptr %.422.i.i.i5505, align 8, !noalias !98
  %.424.i.i.i5507 = fcmp une double %.423.i.i.i5506, 0.000000e+00
  br i1 %.424.i.i.i5507, label %B164.i.i.i5516, label %B272.i.i.i5508
b76:
  store double %t.4.15552, ptr %.1354.i, align 8, !noalias !99
  %.992.i.i5513 = inttoptr i64 %.481.fca.3.load.i to ptr
  tail call void %.992.i.i5513(ptr nonnull %.1354.i, ptr %.4926.i, ptr %.84019621999.i, ptr %.161.i, ptr %.2869.i), !noalias !99
  %.649.i = load i64, ptr %.3840, align 8, !noalias !100
  %.754872.not.i = icmp slt i64 %.2844.i, 1
  br i1 %.754872.not.i, label %b77, label %B116.if.lr.ph.i
B116.if.lr.ph.i:
  %invariant.gep.i = getelementptr double, ptr %.4729.i, i64 %.649.i
  %.879.i = icmp slt i64 %.649.i, 0
  %.880.i = select i1 %.879.i, i64 %.481.fca.19.load.i, i64 0
  %invariant.gep875.i = getelementptr double, ptr %invariant.gep.i, i64 %.880.i
  br label %B116.if.i
B116.if.i:
  %.698.0873.i = phi i64 [ 0, %B116.if.lr.ph.i ], [ %.767.i, %B116.if.i ]
  %.767.i = add nuw nsw i64 %.698.0873.i, 1
  %52 = getelementptr double, ptr %.2869.i, i64 %.698.0873.i
  %.821.i = load double, ptr %52, align 8, !noalias !100
  %.898.i = mul i64 %.698.0873.i, %.481.fca.19.load.i
  %gep876.i = getelementptr double, ptr %invariant.gep875.i, i64 %.898.i
  store double %.821.i, ptr %gep876.i, align 8, !noalias !100
  %exitcond.not.i5515 = icmp eq i64 %.2844.i, %.767.i
  br i1 %exitcond.not.i5515, label %b77, label %B116.if.i
b77:
  %.922.i = add nsw i64 %.649.i, 1
  store i64 %.922.i, ptr %.3840, align 8, !noalias !100
  br label %B1934
B1934.loopexit:
  %.sink.i.ph = phi i64 [ 3, %B284.i.i ], [ 2, %B104.i.i ], [ 2, %B2004.i ], [ 5, %B352.i.i ]
  %t.4.1.sink.i.ph = phi double [ %t.3.1.i, %B284.i.i ], [ %t.3.1.i, %B104.i.i ], [ %t.2.0.i, %B2004.i ], [ %t.3.1.i, %B352.i.i ]
  %h.10.1.sink.i.ph = phi double [ %h.7.1.i, %B284.i.i ], [ %h.7.1.i, %B104.i.i ], [ %.4205.i, %B2004.i ], [ %h.7.1.i, %B352.i.i ]
  call void @llvm.lifetime.end.p0(ptr nonnull %.3776.i)
  br label %B1934
B1934:
  %status.5.15553 = phi i64 [ %status.5.15554, %b77 ], [ %.sink.i.ph, %B1934.loopexit ]
  %t.4.15551 = phi double [ %t.4.15552, %b77 ], [ %t.4.1.sink.i.ph, %B1934.loopexit ]
  %h.5.15549 = phi double [ %h.5.15550, %b77 ], [ %h.10.1.sink.i.ph, %B1934.loopexit ]
  store double %t.4.15551, ptr %.5009.i, align 8
  store double %h.5.15549, ptr %.2173, align 8
  store i64 %status.5.15553, ptr %retptr, align 8
  ret void
B882.if:
  %.1687.05579 = phi i64 [ %.1756, %B882.if ], [ 0, %B882.if.preheader ]
  %.1756 = add nuw nsw i64 %.1687.05579, 1
  %53 = getelementptr double, ptr %.4926.i, i64 %.1687.05579
  %.1814 = load double, ptr %53, align 8
  %54 = getelementptr double, ptr %.4967.i, i64 %.1687.05579
  store double %.1814, ptr %54, align 8
  %gep = getelementptr double, ptr %invariant.gep, i64 %.1687.05579
  store double %.1814, ptr %gep, align 8
  %gep5667 = getelementptr double, ptr %invariant.gep5666, i64 %.1687.05579
  store double 0.000000e+00, ptr %gep5667, align 8
  %exitcond.not = icmp eq i64 %.481.fca.5.load.i, %.1756
  br i1 %exitcond.not, label %B1012, label %B882.if
B1188.if:
  %h.3.05584 = phi double [ %.2174, %B1188.if.lr.ph ], [ %h.4.15627, %B1186 ]
  %.2361.05582 = phi i64 [ 0, %B1188.if.lr.ph ], [ %.2468, %B1186 ]
  %.2468 = add nuw nsw i64 %.2361.05582, 1
  %55 = getelementptr double, ptr %.1025, i64 %.2361.05582
  %.2539 = load double, ptr %55, align 8
  %.2546 = icmp slt i64 %.2468, %.481.fca.17.load.i
  %56 = getelementptr double, ptr %.1025, i64 %.2468
  %"$phi1276.4.2.1.in" = select i1 %.2546, ptr %56, ptr %.2619
  %"$phi1276.4.2.1" = load double, ptr %"$phi1276.4.2.1.in", align 8
  %57 = getelementptr i64, ptr %.1129, i64 %.2361.05582
  %.2654 = load i64, ptr %57, align 8
  %.2678 = icmp slt i64 %.2654, 0
  %.2679 = select i1 %.2678, i64 %.481.fca.18.load.i, i64 0
  %.2680 = add i64 %.2679, %.2654
  %.2704 = mul i64 %.2680, %.2264
  %.2706 = getelementptr double, ptr %.1178, i64 %.2704
  br i1 %.2775, label %B1340, label %B1396
}
declare double @llvm.fabs.f64(double)
define internal fastcc void @v48(ptr noalias nonnull writeonly %retptr, i64 %arg.run.0.4, ptr %arg.run.1.0.4, i64 %arg.run.1.1.2, ptr %arg.run.1.1.4, ptr readonly %arg.run.1.2.4, i64 %arg.run.1.3.2, ptr %arg.run.1.3.4, ptr %arg.run.1.4.4, i64 %arg.run.5.0.2, ptr %arg.run.5.0.4, ptr %arg.run.5.3.4, ptr readonly %arg.segment.2.4, i64 %arg.segment.2.5.1, double %arg.t, ptr %arg.x.4) unnamed_addr {
entry:
  %.5.i = fmul double %arg.t, 0x3D06849B86A12B9B
  %.6.i = fadd double %.5.i, 1.000000e-15
  %.765 = fadd double %arg.t, %.6.i
  %.164126.not.i = icmp sgt i64 %arg.run.1.3.2, 0
  br i1 %.164126.not.i, label %B78.if.i, label %b78
B78.if.i:
  %first.2.0129.i = phi double [ %.13.i.i, %B78.if.i ], [ 0x7FF0000000000000, %entry ]
  %.106.0128.i = phi i64 [ %.177.i, %B78.if.i ], [ 0, %entry ]
  %.177.i = add nuw nsw i64 %.106.0128.i, 1
  %0 = getelementptr double, ptr %arg.run.1.1.4, i64 %.106.0128.i
  %.235.i = load double, ptr %0, align 8, !noalias !101
  %.12.i.i = fcmp olt double %.235.i, %first.2.0129.i
  %.13.i.i = select i1 %.12.i.i, double %.235.i, double %first.2.0129.i
  %exitcond.not.i = icmp eq i64 %arg.run.1.3.2, %.177.i
  br i1 %exitcond.not.i, label %b78, label %B78.if.i
b78:
  %first.2.0.lcssa.i = phi double [ 0x7FF0000000000000, %entry ], [ %.13.i.i, %B78.if.i ]
  %.806 = fcmp ugt double %first.2.0.lcssa.i, %.765
  br i1 %.806, label %B626, label %B112.preheader
B112.preheader:
  %.148211.not.i = icmp slt i64 %arg.run.5.0.2, 1
  %.1203 = inttoptr i64 %arg.run.0.4 to ptr
  %.13131567.not = icmp slt i64 %arg.run.1.1.2, 1
  br label %B112
B112:
  %changed.4.0 = phi i1 [ %changed.3.1.lcssa, %b79 ], [ false, %B112.preheader ]
  br i1 %.164126.not.i, label %B162.if, label %B226
B226:
  store double %arg.t, ptr %arg.run.5.3.4, align 8
  br i1 %.148211.not.i, label %b80, label %B58.if.i
B164.i:
  %.44.i.i = getelementptr i8, ptr %2, i64 24
  %.45.i.i = load double, ptr %.44.i.i, align 8, !noalias !104
  %.73.i.i = getelementptr i8, ptr %2, i64 32
  %.74.i.i = load double, ptr %.73.i.i, align 8, !noalias !104
  %.75.i.i = fmul double %.74.i.i, 5.000000e-01
  %.76.i.i = fmul double %.245.i, %.75.i.i
  %.77.i.i = fadd double %.45.i.i, %.76.i.i
  %.78.i.i = fmul double %.245.i, %.77.i.i
  %.87.le.i.i = tail call double @llvm.floor.f64(double %.78.i.i)
  %.92.i.i = fsub double %.78.i.i, %.87.le.i.i
  %.93.i.i = fmul double %.92.i.i, 0x401921FB54442D18
  %.121.i.i = getelementptr i8, ptr %2, i64 40
  %.122.i.i = load double, ptr %.121.i.i, align 8, !noalias !104
  %.126.i.i = fadd double %.122.i.i, %.93.i.i
  %.593.le.i = tail call double @llvm.sin.f64(double %.126.i.i)
  %.598.i = fmul double %.423.i, %.593.le.i
  %.600.i = fadd double %.361.i, %.598.i
  br label %B272.i
B272.i:
  %value.2.1.i = phi double [ %.600.i, %B164.i ], [ %.361.i, %B58.if.i ]
  %1 = getelementptr double, ptr %arg.run.5.0.4, i64 %.90.0213.i
  store double %value.2.1.i, ptr %1, align 8, !noalias !109
  %exitcond.not.i1550 = icmp eq i64 %arg.run.5.0.2, %.161.i
  br i1 %exitcond.not.i1550, label %b80, label %B58.if.i
B58.if.i:
  %.90.0213.i = phi i64 [ %.161.i, %B272.i ], [ 0, %B226 ]
  %.161.i = add nuw nsw i64 %.90.0213.i, 1
  %.238.i = mul i64 %.90.0213.i, %arg.segment.2.5.1
  %2 = getelementptr double, ptr %arg.segment.2.4, i64 %.238.i
  %.242.i = getelementptr i8, ptr %2, i64 48
  %.243.i = load double, ptr %.242.i, align 8, !noalias !109
  %.245.i = fsub double %arg.t, %.243.i
  %.303.i = load double, ptr %2, align 8, !noalias !109
  %.357.i = getelementptr i8, ptr %2, i64 8
  %.358.i = load double, ptr %.357.i, align 8, !noalias !109
  %.360.i = fmul double %.245.i, %.358.i
  %.361.i = fadd double %.303.i, %.360.i
  %.422.i = getelementptr i8, ptr %2, i64 16
  %.423.i = load double, ptr %.422.i, align 8, !noalias !109
  %.424.i = fcmp une double %.423.i, 0.000000e+00
  br i1 %.424.i, label %B164.i, label %B272.i
b80:
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
  %changed.3.1.lcssa = phi i1 [ %changed.4.0, %b80 ], [ %changed.5.2, %B542 ]
  br i1 %.164126.not.i, label %B78.if.i1552, label %b79
B78.if.i1552:
  %first.2.0129.i1553 = phi double [ %.13.i.i1558, %B78.if.i1552 ], [ 0x7FF0000000000000, %B586 ]
  %.106.0128.i1554 = phi i64 [ %.177.i1555, %B78.if.i1552 ], [ 0, %B586 ]
  %.177.i1555 = add nuw nsw i64 %.106.0128.i1554, 1
  %5 = getelementptr double, ptr %arg.run.1.1.4, i64 %.106.0128.i1554
  %.235.i1556 = load double, ptr %5, align 8, !noalias !110
  %.12.i.i1557 = fcmp olt double %.235.i1556, %first.2.0129.i1553
  %.13.i.i1558 = select i1 %.12.i.i1557, double %.235.i1556, double %first.2.0129.i1553
  %exitcond.not.i1559 = icmp eq i64 %arg.run.1.3.2, %.177.i1555
  br i1 %exitcond.not.i1559, label %b79, label %B78.if.i1552
b79:
  %first.2.0.lcssa.i1560 = phi double [ 0x7FF0000000000000, %B586 ], [ %.13.i.i1558, %B78.if.i1552 ]
  %.1617 = fcmp ugt double %first.2.0.lcssa.i1560, %.765
  br i1 %.1617, label %B626.loopexit, label %B112
B626.loopexit:
  %6 = zext i1 %changed.3.1.lcssa to i8
  br label %B626
B626:
  %changed.2.1 = phi i8 [ 0, %b78 ], [ %6, %B626.loopexit ]
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
  %changed.3.11570 = phi i1 [ %changed.5.2, %B542 ], [ %changed.4.0, %b80 ]
  %.1257.01568 = phi i64 [ %.1326, %B542 ], [ 0, %b80 ]
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
declare double @llvm.sqrt.f64(double)
define internal fastcc void @v49(ptr noalias nonnull writeonly %retptr, i64 %arg.run.0.3, ptr %arg.run.1.0.4, ptr %arg.run.3.2.4, ptr readonly %arg.run.4.0.4, i64 %arg.run.4.0.5.1, ptr readonly %arg.run.4.1.4, i64 %arg.run.4.1.5.0, i64 %arg.run.4.1.5.1, i64 %arg.run.5.0.2, ptr %arg.run.5.0.4, ptr %arg.run.5.3.4, ptr readonly %arg.run.5.11.4, i64 %arg.run.5.11.5.0, i64 %arg.run.5.12.2, ptr %arg.run.5.12.4, i64 %arg.run.6.2, ptr readonly %arg.run.6.4, ptr readonly %arg.segment.2.4, i64 %arg.segment.2.5.1, double %arg.step.0, double %arg.step.1, ptr readonly %arg.step.3.4) unnamed_addr {
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
  br i1 %.703768.not.i, label %b81, label %B102.if.i
B102.if.i:
  %.645.0769.i = phi i64 [ %.716.i, %B102.if.i ], [ 0, %B48 ]
  %.716.i = add nuw nsw i64 %.645.0769.i, 1
  %0 = getelementptr double, ptr %arg.run.6.4, i64 %.645.0769.i
  %.774.i = load double, ptr %0, align 8, !noalias !113
  %.779.i = fmul double %.478.i, %.774.i
  %1 = getelementptr double, ptr %arg.step.3.4, i64 %.645.0769.i
  %.813.i = load double, ptr %1, align 8, !noalias !113
  %2 = getelementptr double, ptr %arg.run.5.11.4, i64 %.645.0769.i
  %.846.i = load double, ptr %2, align 8, !noalias !113
  %.848.i = add nsw i64 %.645.0769.i, %arg.run.6.2
  %.862.i = icmp slt i64 %.848.i, 0
  %.863.i = select i1 %.862.i, i64 %arg.run.5.11.5.0, i64 0
  %3 = getelementptr double, ptr %arg.run.5.11.4, i64 %.848.i
  %.877.i = getelementptr double, ptr %3, i64 %.863.i
  %.878.i = load double, ptr %.877.i, align 8, !noalias !113
  %.880.i = fmul double %high.3.1, %.878.i
  %.881.i = fadd double %.846.i, %.880.i
  %.883.i = fmul double %.478.i, %.881.i
  %.884.i = fadd double %.813.i, %.883.i
  %.886.i = fmul double %high.3.1, %.884.i
  %.887.i = fadd double %.779.i, %.886.i
  %4 = getelementptr double, ptr %arg.run.5.12.4, i64 %.645.0769.i
  store double %.887.i, ptr %4, align 8, !noalias !113
  %exitcond.not.i = icmp eq i64 %arg.run.5.12.2, %.716.i
  br i1 %exitcond.not.i, label %b81, label %B102.if.i
b81:
  %.796 = fmul double %arg.step.1, %high.3.1
  %.797 = fadd double %arg.step.0, %.796
  br i1 %.148211.not.i.i.i, label %b56, label %B58.if.i.i.i
B164.i.i.i:
  %.44.i.i.i.i = getelementptr i8, ptr %6, i64 24
  %.45.i.i.i.i = load double, ptr %.44.i.i.i.i, align 8, !noalias !116
  %.73.i.i.i.i = getelementptr i8, ptr %6, i64 32
  %.74.i.i.i.i = load double, ptr %.73.i.i.i.i, align 8, !noalias !116
  %.75.i.i.i.i = fmul double %.74.i.i.i.i, 5.000000e-01
  %.76.i.i.i.i = fmul double %.245.i.i.i, %.75.i.i.i.i
  %.77.i.i.i.i = fadd double %.45.i.i.i.i, %.76.i.i.i.i
  %.78.i.i.i.i = fmul double %.245.i.i.i, %.77.i.i.i.i
  %.87.le.i.i.i.i = tail call double @llvm.floor.f64(double %.78.i.i.i.i)
  %.92.i.i.i.i = fsub double %.78.i.i.i.i, %.87.le.i.i.i.i
  %.93.i.i.i.i = fmul double %.92.i.i.i.i, 0x401921FB54442D18
  %.121.i.i.i.i = getelementptr i8, ptr %6, i64 40
  %.122.i.i.i.i = load double, ptr %.121.i.i.i.i, align 8, !noalias !116
  %.126.i.i.i.i = fadd double %.122.i.i.i.i, %.93.i.i.i.i
  %.593.le.i.i.i = tail call double @llvm.sin.f64(double %.126.i.i.i.i)
  %.598.i.i.i = fmul double %.423.i.i.i, %.593.le.i.i.i
  %.600.i.i.i = fadd double %.361.i.i.i, %.598.i.i.i
  br label %B272.i.i.i
B272.i.i.i:
  %value.2.1.i.i.i = phi double [ %.600.i.i.i, %B164.i.i.i ], [ %.361.i.i.i, %B58.if.i.i.i ]
  %5 = getelementptr double, ptr %arg.run.5.0.4, i64 %.90.0213.i.i.i
  store double %value.2.1.i.i.i, ptr %5, align 8, !noalias !125
  %exitcond.not.i.i.i = icmp eq i64 %arg.run.5.0.2, %.161.i.i.i
  br i1 %exitcond.not.i.i.i, label %b56, label %B58.if.i.i.i
B58.if.i.i.i:
  %.90.0213.i.i.i = phi i64 [ %.161.i.i.i, %B272.i.i.i ], [ 0, %b81 ]
  %.161.i.i.i = add nuw nsw i64 %.90.0213.i.i.i, 1
  %.238.i.i.i = mul i64 %.90.0213.i.i.i, %arg.segment.2.5.1
  %6 = getelementptr double, ptr %arg.segment.2.4, i64 %.238.i.i.i
  %.242.i.i.i = getelementptr i8, ptr %6, i64 48
  %.243.i.i.i = load double, ptr %.242.i.i.i, align 8, !noalias !125
  %.245.i.i.i = fsub double %.797, %.243.i.i.i
  %.303.i.i.i = load double, ptr %6, align 8, !noalias !125
  %.357.i.i.i = getelementptr i8, ptr %6, i64 8
  %.358.i.i.i = load double, ptr %.357.i.i.i, align 8, !noalias !125
  %.360.i.i.i = fmul double %.245.i.i.i, %.358.i.i.i
  %.361.i.i.i = fadd double %.303.i.i.i, %.360.i.i.i
  %.422.i.i.i = getelementptr i8, ptr %6, i64 16
  %.423.i.i.i = load double, ptr %.422.i.i.i, align 8, !noalias !125
  %.424.i.i.i = fcmp une double %.423.i.i.i, 0.000000e+00
  br i1 %.424.i.i.i, label %B164.i.i.i, label %B272.i.i.i
b56:
  store double %.797, ptr %arg.run.5.3.4, align 8, !noalias !126
  tail call void %.992.i.i(ptr nonnull %arg.run.5.3.4, ptr %arg.run.5.12.4, ptr %arg.run.5.0.4, ptr %arg.run.1.0.4, ptr %arg.run.3.2.4), !noalias !126
  br label %B140.i
B140.i:
  %.859.0.i = phi i64 [ 0, %b56 ], [ %.928.i, %B288.i ]
  %exitcond294.not.i = icmp eq i64 %.859.0.i, %spec.select.i
  br i1 %exitcond294.not.i, label %b58, label %B142.i
B142.i:
  %.1005.i = mul i64 %.859.0.i, %arg.run.4.1.5.1
  %7 = getelementptr double, ptr %arg.run.4.1.4, i64 %.1005.i
  %.1009.i = getelementptr i8, ptr %7, i64 16
  %.1010.i = load double, ptr %.1009.i, align 8, !noalias !127
  %.1186.i = mul i64 %.859.0.i, %arg.run.4.0.5.1
  %8 = getelementptr i64, ptr %arg.run.4.0.4, i64 %.1186.i
  br label %B194.if.i
B226.i:
  %9 = getelementptr double, ptr %7, i64 %.1037.0289.i
  %.1249.i = load double, ptr %9, align 8, !noalias !127
  %.1338.i = getelementptr double, ptr %arg.run.3.2.4, i64 %.1191.i
  %.1339.i = load double, ptr %.1338.i, align 8, !noalias !127
  %.1340.i = fmul double %.1249.i, %.1339.i
  %.1342.i = fadd double %value.2.1291.i, %.1340.i
  br label %B286.i
B286.i:
  %value.3.2.i = phi double [ %.1342.i, %B226.i ], [ %value.2.1291.i, %B194.if.i ]
  br i1 %exitcond.not.i1267, label %B288.i, label %B194.if.i
B288.i:
  %.928.i = add nuw i64 %.859.0.i, 1
  %.1361.i = fcmp ogt double %value.3.2.i, 0.000000e+00
  br i1 %.1361.i, label %b58, label %B140.i
B194.if.i:
  %value.2.1291.i = phi double [ %.1010.i, %B142.i ], [ %value.3.2.i, %B286.i ]
  %exitcond.not.i1267 = phi i1 [ false, %B142.i ], [ true, %B286.i ]
  %.1037.0289.i = phi i64 [ 0, %B142.i ], [ 1, %B286.i ]
  %10 = getelementptr i64, ptr %8, i64 %.1037.0289.i
  %.1191.i = load i64, ptr %10, align 8, !noalias !127
  %.1194.i = icmp sgt i64 %.1191.i, -1
  br i1 %.1194.i, label %B226.i, label %B286.i
b58:
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
  %.774.i1273 = load double, ptr %12, align 8, !noalias !128
  %.779.i1274 = fmul double %.478.i1268, %.774.i1273
  %13 = getelementptr double, ptr %arg.step.3.4, i64 %.645.0769.i1271
  %.813.i1275 = load double, ptr %13, align 8, !noalias !128
  %14 = getelementptr double, ptr %arg.run.5.11.4, i64 %.645.0769.i1271
  %.846.i1276 = load double, ptr %14, align 8, !noalias !128
  %.848.i1277 = add nsw i64 %.645.0769.i1271, %arg.run.6.2
  %.862.i1278 = icmp slt i64 %.848.i1277, 0
  %.863.i1279 = select i1 %.862.i1278, i64 %arg.run.5.11.5.0, i64 0
  %15 = getelementptr double, ptr %arg.run.5.11.4, i64 %.848.i1277
  %.877.i1280 = getelementptr double, ptr %15, i64 %.863.i1279
  %.878.i1281 = load double, ptr %.877.i1280, align 8, !noalias !128
  %.880.i1282 = fmul double %high.3.1.theta.2.1, %.878.i1281
  %.881.i1283 = fadd double %.846.i1276, %.880.i1282
  %.883.i1284 = fmul double %.478.i1268, %.881.i1283
  %.884.i1285 = fadd double %.813.i1275, %.883.i1284
  %.886.i1286 = fmul double %high.3.1.theta.2.1, %.884.i1285
  %.887.i1287 = fadd double %.779.i1274, %.886.i1286
  %16 = getelementptr double, ptr %arg.run.5.12.4, i64 %.645.0769.i1271
  store double %.887.i1287, ptr %16, align 8, !noalias !128
  %exitcond.not.i1288 = icmp eq i64 %arg.run.5.12.2, %.716.i1272
  br i1 %exitcond.not.i1288, label %common.ret, label %B102.if.i1270
}
define internal fastcc void @v50(ptr noalias nonnull writeonly %retptr, i64 %arg.run.0.3, i64 %arg.run.0.4, ptr %arg.run.1.0.4, i64 %arg.run.1.1.2, ptr %arg.run.1.1.4, ptr readonly %arg.run.1.2.4, i64 %arg.run.1.3.2, ptr %arg.run.1.3.4, ptr %arg.run.1.4.4, i64 %arg.run.2.1.2, i64 %arg.run.3.0.2, ptr readonly %arg.run.3.0.4, i64 %arg.run.3.0.5.0, ptr writeonly %arg.run.3.1.4, i64 %arg.run.3.1.5.1, i64 %arg.run.3.2.2, ptr %arg.run.3.2.4, i64 %arg.run.5.0.2, ptr %arg.run.5.0.4, ptr %arg.run.5.3.4, ptr %arg.run.5.6.4, i64 %arg.run.5.6.5.0, ptr readonly %arg.run.5.11.4, i64 %arg.run.5.11.5.0, i64 %arg.run.5.12.2, ptr %arg.run.5.12.4, i64 %arg.run.6.2, ptr readonly %arg.run.6.4, ptr %arg.run.9.4, ptr readonly %arg.segment.2.4, i64 %arg.segment.2.5.1, double %arg.step.0, double %arg.step.1, double %arg.step.2, ptr readonly %arg.step.3.4) unnamed_addr {
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
  br i1 %.164126.not.i, label %b78, label %B78.if.i
B78.if.i:
  %first.2.0129.i = phi double [ %.13.i.i, %B78.if.i ], [ 0x7FF0000000000000, %B6 ]
  %.106.0128.i = phi i64 [ %.177.i, %B78.if.i ], [ 0, %B6 ]
  %.177.i = add nuw nsw i64 %.106.0128.i, 1
  %0 = getelementptr double, ptr %arg.run.1.1.4, i64 %.106.0128.i
  %.235.i = load double, ptr %0, align 8, !noalias !131
  %.12.i.i = fcmp olt double %.235.i, %first.2.0129.i
  %.13.i.i = select i1 %.12.i.i, double %.235.i, double %first.2.0129.i
  %exitcond.not.i = icmp eq i64 %arg.run.1.3.2, %.177.i
  br i1 %exitcond.not.i, label %b78, label %B78.if.i
b78:
  %first.2.0.lcssa.i = phi double [ 0x7FF0000000000000, %B6 ], [ %.13.i.i, %B78.if.i ]
  %.586 = fcmp ult double %first.2.0.lcssa.i, %.584
  br i1 %.586, label %B124, label %common.ret
common.ret:
  %storemerge = phi double [ %arg.step.2, %b78 ], [ %first.2.0.lcssa.i, %b81 ]
  store double %storemerge, ptr %retptr, align 8
  ret void
B124:
  call fastcc void @v51(ptr %.729, i64 %arg.run.0.3, ptr %arg.run.1.0.4, i64 %arg.run.2.1.2, i64 %arg.run.3.0.2, ptr %arg.run.3.0.4, i64 %arg.run.3.0.5.0, ptr %arg.run.3.1.4, i64 %arg.run.3.1.5.1, i64 %arg.run.3.2.2, ptr %arg.run.3.2.4, i64 %arg.run.5.0.2, ptr %arg.run.5.0.4, ptr %arg.run.5.3.4, ptr %arg.run.5.6.4, i64 %arg.run.5.6.5.0, ptr %arg.run.5.11.4, i64 %arg.run.5.11.5.0, i64 %arg.run.6.2, ptr %arg.run.6.4, ptr %arg.run.9.4, ptr %arg.segment.2.4, i64 %arg.segment.2.5.1, double %arg.step.0, double %arg.step.1, ptr %arg.step.3.4, double %first.2.0.lcssa.i)
  %.850 = fsub double %first.2.0.lcssa.i, %arg.step.0
  %.856 = fdiv double %.850, %arg.step.1
  %.478.i = fsub double 1.000000e+00, %.856
  br i1 %.703768.not.i, label %b81, label %B102.if.i
B102.if.i:
  %.645.0769.i = phi i64 [ %.716.i, %B102.if.i ], [ 0, %B124 ]
  %.716.i = add nuw nsw i64 %.645.0769.i, 1
  %1 = getelementptr double, ptr %arg.run.6.4, i64 %.645.0769.i
  %.774.i = load double, ptr %1, align 8, !noalias !134
  %.779.i = fmul double %.478.i, %.774.i
  %2 = getelementptr double, ptr %arg.step.3.4, i64 %.645.0769.i
  %.813.i = load double, ptr %2, align 8, !noalias !134
  %3 = getelementptr double, ptr %arg.run.5.11.4, i64 %.645.0769.i
  %.846.i = load double, ptr %3, align 8, !noalias !134
  %.848.i = add nsw i64 %.645.0769.i, %arg.run.6.2
  %.862.i = icmp slt i64 %.848.i, 0
  %.863.i = select i1 %.862.i, i64 %arg.run.5.11.5.0, i64 0
  %4 = getelementptr double, ptr %arg.run.5.11.4, i64 %.848.i
  %.877.i = getelementptr double, ptr %4, i64 %.863.i
  %.878.i = load double, ptr %.877.i, align 8, !noalias !134
  %.880.i = fmul double %.856, %.878.i
  %.881.i = fadd double %.846.i, %.880.i
  %.883.i = fmul double %.478.i, %.881.i
  %.884.i = fadd double %.813.i, %.883.i
  %.886.i = fmul double %.856, %.884.i
  %.887.i = fadd double %.779.i, %.886.i
  %5 = getelementptr double, ptr %arg.run.5.12.4, i64 %.645.0769.i
  store double %.887.i, ptr %5, align 8, !noalias !134
  %exitcond.not.i1480 = icmp eq i64 %arg.run.5.12.2, %.716.i
  br i1 %exitcond.not.i1480, label %b81, label %B102.if.i
b81:
  store i8 0, ptr %.1201, align 1
  call fastcc void @v48(ptr %.1201, i64 %arg.run.0.4, ptr %arg.run.1.0.4, i64 %arg.run.1.1.2, ptr %arg.run.1.1.4, ptr %arg.run.1.2.4, i64 %arg.run.1.3.2, ptr %arg.run.1.3.4, ptr %arg.run.1.4.4, i64 %arg.run.5.0.2, ptr %arg.run.5.0.4, ptr %arg.run.5.3.4, ptr %arg.segment.2.4, i64 %arg.segment.2.5.1, double %first.2.0.lcssa.i, ptr %arg.run.5.12.4)
  %.1308 = load i8, ptr %.1201, align 1
  %.1311.not = icmp eq i8 %.1308, 0
  br i1 %.1311.not, label %B6, label %common.ret
}
define internal fastcc void @v51(ptr noalias nonnull writeonly %retptr, i64 %arg.run.0.3, ptr %arg.run.1.0.4, i64 %arg.run.2.1.2, i64 %arg.run.3.0.2, ptr readonly %arg.run.3.0.4, i64 %arg.run.3.0.5.0, ptr writeonly %arg.run.3.1.4, i64 %arg.run.3.1.5.1, i64 %arg.run.3.2.2, ptr %arg.run.3.2.4, i64 %arg.run.5.0.2, ptr %arg.run.5.0.4, ptr %arg.run.5.3.4, ptr %arg.run.5.6.4, i64 %arg.run.5.6.5.0, ptr readonly %arg.run.5.11.4, i64 %arg.run.5.11.5.0, i64 %arg.run.6.2, ptr readonly %arg.run.6.4, ptr %arg.run.9.4, ptr readonly %arg.segment.2.4, i64 %arg.segment.2.5.1, double %arg.step.0, double %arg.step.1, ptr readonly %arg.step.3.4, double %arg.end) unnamed_addr {
entry:
  %.5.i = fmul double %arg.end, 0x3D06849B86A12B9B
  %.6.i = fadd double %.5.i, 1.000000e-15
  %.510 = fsub double %arg.end, %.6.i
  %.731 = icmp slt i64 %arg.run.5.6.5.0, 1
  br i1 %.731, label %B0.endif.else.endif.if, label %B0.endif.else.endif.endif, !prof !3
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
  br i1 %.703768.not.i, label %b81, label %B102.if.i
B102.if.i:
  %.645.0769.i = phi i64 [ %.716.i, %B102.if.i ], [ 0, %B244 ]
  %.716.i = add nuw nsw i64 %.645.0769.i, 1
  %2 = getelementptr double, ptr %arg.run.6.4, i64 %.645.0769.i
  %.774.i = load double, ptr %2, align 8, !noalias !137
  %.779.i = fmul double %.478.i, %.774.i
  %3 = getelementptr double, ptr %arg.step.3.4, i64 %.645.0769.i
  %.813.i = load double, ptr %3, align 8, !noalias !137
  %4 = getelementptr double, ptr %arg.run.5.11.4, i64 %.645.0769.i
  %.846.i = load double, ptr %4, align 8, !noalias !137
  %.848.i = add nsw i64 %.645.0769.i, %arg.run.6.2
  %.862.i = icmp slt i64 %.848.i, 0
  %.863.i = select i1 %.862.i, i64 %arg.run.5.11.5.0, i64 0
  %5 = getelementptr double, ptr %arg.run.5.11.4, i64 %.848.i
  %.877.i = getelementptr double, ptr %5, i64 %.863.i
  %.878.i = load double, ptr %.877.i, align 8, !noalias !137
  %.880.i = fmul double %.13.i, %.878.i
  %.881.i = fadd double %.846.i, %.880.i
  %.883.i = fmul double %.478.i, %.881.i
  %.884.i = fadd double %.813.i, %.883.i
  %.886.i = fmul double %.13.i, %.884.i
  %.887.i = fadd double %.779.i, %.886.i
  %6 = getelementptr double, ptr %.824, i64 %.645.0769.i
  store double %.887.i, ptr %6, align 8, !noalias !137
  %exitcond.not.i = icmp eq i64 %.799, %.716.i
  br i1 %exitcond.not.i, label %b81, label %B102.if.i
b81:
  br i1 %.148211.not.i.i.i, label %b56, label %B58.if.i.i.i
B164.i.i.i:
  %.44.i.i.i.i = getelementptr i8, ptr %8, i64 24
  %.45.i.i.i.i = load double, ptr %.44.i.i.i.i, align 8, !noalias !140
  %.73.i.i.i.i = getelementptr i8, ptr %8, i64 32
  %.74.i.i.i.i = load double, ptr %.73.i.i.i.i, align 8, !noalias !140
  %.75.i.i.i.i = fmul double %.74.i.i.i.i, 5.000000e-01
  %.76.i.i.i.i = fmul double %.245.i.i.i, %.75.i.i.i.i
  %.77.i.i.i.i = fadd double %.45.i.i.i.i, %.76.i.i.i.i
  %.78.i.i.i.i = fmul double %.245.i.i.i, %.77.i.i.i.i
  %.87.le.i.i.i.i = tail call double @llvm.floor.f64(double %.78.i.i.i.i)
  %.92.i.i.i.i = fsub double %.78.i.i.i.i, %.87.le.i.i.i.i
  %.93.i.i.i.i = fmul double %.92.i.i.i.i, 0x401921FB54442D18
  %.121.i.i.i.i = getelementptr i8, ptr %8, i64 40
  %.122.i.i.i.i = load double, ptr %.121.i.i.i.i, align 8, !noalias !140
  %.126.i.i.i.i = fadd double %.122.i.i.i.i, %.93.i.i.i.i
  %.593.le.i.i.i = tail call double @llvm.sin.f64(double %.126.i.i.i.i)
  %.598.i.i.i = fmul double %.423.i.i.i, %.593.le.i.i.i
  %.600.i.i.i = fadd double %.361.i.i.i, %.598.i.i.i
  br label %B272.i.i.i
B272.i.i.i:
  %value.2.1.i.i.i = phi double [ %.600.i.i.i, %B164.i.i.i ], [ %.361.i.i.i, %B58.if.i.i.i ]
  %7 = getelementptr double, ptr %arg.run.5.0.4, i64 %.90.0213.i.i.i
  store double %value.2.1.i.i.i, ptr %7, align 8, !noalias !149
  %exitcond.not.i.i.i = icmp eq i64 %arg.run.5.0.2, %.161.i.i.i
  br i1 %exitcond.not.i.i.i, label %b56, label %B58.if.i.i.i
B58.if.i.i.i:
  %.90.0213.i.i.i = phi i64 [ %.161.i.i.i, %B272.i.i.i ], [ 0, %b81 ]
  %.161.i.i.i = add nuw nsw i64 %.90.0213.i.i.i, 1
  %.238.i.i.i = mul i64 %.90.0213.i.i.i, %arg.segment.2.5.1
  %8 = getelementptr double, ptr %arg.segment.2.4, i64 %.238.i.i.i
  %.242.i.i.i = getelementptr i8, ptr %8, i64 48
  %.243.i.i.i = load double, ptr %.242.i.i.i, align 8, !noalias !149
  %.245.i.i.i = fsub double %.1065, %.243.i.i.i
  %.303.i.i.i = load double, ptr %8, align 8, !noalias !149
  %.357.i.i.i = getelementptr i8, ptr %8, i64 8
  %.358.i.i.i = load double, ptr %.357.i.i.i, align 8, !noalias !149
  %.360.i.i.i = fmul double %.245.i.i.i, %.358.i.i.i
  %.361.i.i.i = fadd double %.303.i.i.i, %.360.i.i.i
  %.422.i.i.i = getelementptr i8, ptr %8, i64 16
  %.423.i.i.i = load double, ptr %.422.i.i.i, align 8, !noalias !149
  %.424.i.i.i = fcmp une double %.423.i.i.i, 0.000000e+00
  br i1 %.424.i.i.i, label %B164.i.i.i, label %B272.i.i.i
b56:
  store double %.1065, ptr %arg.run.5.3.4, align 8, !noalias !150
  tail call void %.992.i.i(ptr nonnull %arg.run.5.3.4, ptr %.824, ptr %arg.run.5.0.4, ptr %arg.run.1.0.4, ptr %arg.run.3.2.4), !noalias !150
  %.649.i = load i64, ptr %.912, align 8, !noalias !151
  br i1 %.754872.not.i, label %b77, label %B116.if.lr.ph.i
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
  %.821.i = load double, ptr %9, align 8, !noalias !151
  %.898.i = mul i64 %.698.0873.i, %arg.run.3.1.5.1
  %gep876.i = getelementptr double, ptr %invariant.gep875.i, i64 %.898.i
  store double %.821.i, ptr %gep876.i, align 8, !noalias !151
  %exitcond.not.i3008 = icmp eq i64 %.767.i, %arg.run.3.2.2
  br i1 %exitcond.not.i3008, label %b77, label %B116.if.i
b77:
  %.922.i = add nsw i64 %.649.i, 1
  store i64 %.922.i, ptr %.912, align 8, !noalias !151
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
  br i1 %.743, label %B0.endif.else.endif.endif.if, label %B0.endif.else.endif.endif.endif, !prof !3
B0.endif.else.endif.endif.if:
  br label %B0.endif.else.endif.endif.endif
B0.endif.else.endif.endif.endif:
  %.711.sroa.13.1 = phi i64 [ 0, %B0.endif.else.endif.endif.if ], [ %.740, %B0.endif.else.endif.endif ]
  %.748.not = icmp slt i64 %.740, %arg.run.5.6.5.0
  br i1 %.748.not, label %B0.endif.endif, label %B0.endif.else.endif.endif.endif.if, !prof !4
B0.endif.else.endif.endif.endif.if:
  br label %B0.endif.endif
}
declare double @llvm.cos.f64(double)
define i64 @integrate(ptr readonly %job) local_unnamed_addr {
  %status = alloca i64, align 8
  store i64 0, ptr %status, align 8
  call fastcc void @v47(ptr %status, ptr %job)
  %result = load i64, ptr %status, align 8
  ret i64 %result
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
!3 = !{!"branch_weights", i32 1, i32 99}
!4 = !{!"branch_weights", i32 99, i32 1}
!5 = !{!6}
!6 = distinct !{!6, !7, !"scope"}
!7 = distinct !{!7, !"scope"}
!8 = !{!9, !11, !13, !15}
!9 = distinct !{!9, !10, !"scope"}
!10 = distinct !{!10, !"scope"}
!11 = distinct !{!11, !12, !"scope"}
!12 = distinct !{!12, !"scope"}
!13 = distinct !{!13, !14, !"scope"}
!14 = distinct !{!14, !"scope"}
!15 = distinct !{!15, !16, !"scope"}
!16 = distinct !{!16, !"scope"}
!17 = !{!11, !13, !15}
!18 = !{!13, !15}
!19 = !{!15}
!20 = !{!21, !23}
!21 = distinct !{!21, !22, !"scope"}
!22 = distinct !{!22, !"scope"}
!23 = distinct !{!23, !24, !"scope"}
!24 = distinct !{!24, !"scope"}
!25 = !{!26, !28, !30, !23}
!26 = distinct !{!26, !27, !"scope"}
!27 = distinct !{!27, !"scope"}
!28 = distinct !{!28, !29, !"scope"}
!29 = distinct !{!29, !"scope"}
!30 = distinct !{!30, !31, !"scope"}
!31 = distinct !{!31, !"scope"}
!32 = !{!28, !30, !23}
!33 = !{!34, !23}
!34 = distinct !{!34, !35, !"scope"}
!35 = distinct !{!35, !"scope"}
!36 = !{!37, !39, !34, !23}
!37 = distinct !{!37, !38, !"scope"}
!38 = distinct !{!38, !"scope"}
!39 = distinct !{!39, !40, !"scope"}
!40 = distinct !{!40, !"scope"}
!41 = !{!39, !34, !23}
!42 = !{!43, !34, !23}
!43 = distinct !{!43, !44, !"scope"}
!44 = distinct !{!44, !"scope"}
!45 = !{!46, !43, !34, !23}
!46 = distinct !{!46, !47, !"scope"}
!47 = distinct !{!47, !"scope"}
!48 = !{!49, !34, !23}
!49 = distinct !{!49, !50, !"scope"}
!50 = distinct !{!50, !"scope"}
!51 = !{!52, !54, !23}
!52 = distinct !{!52, !53, !"scope"}
!53 = distinct !{!53, !"scope"}
!54 = distinct !{!54, !55, !"scope"}
!55 = distinct !{!55, !"scope"}
!56 = !{!23}
!57 = !{!58, !23}
!58 = distinct !{!58, !59, !"scope"}
!59 = distinct !{!59, !"scope"}
!60 = !{!61, !63, !65, !23}
!61 = distinct !{!61, !62, !"scope"}
!62 = distinct !{!62, !"scope"}
!63 = distinct !{!63, !64, !"scope"}
!64 = distinct !{!64, !"scope"}
!65 = distinct !{!65, !66, !"scope"}
!66 = distinct !{!66, !"scope"}
!67 = !{!63, !65, !23}
!68 = !{!69, !23}
!69 = distinct !{!69, !70, !"scope"}
!70 = distinct !{!70, !"scope"}
!71 = !{!72, !74, !23}
!72 = distinct !{!72, !73, !"scope"}
!73 = distinct !{!73, !"scope"}
!74 = distinct !{!74, !75, !"scope"}
!75 = distinct !{!75, !"scope"}
!76 = !{!74, !23}
!77 = !{!78, !74, !23}
!78 = distinct !{!78, !79, !"scope"}
!79 = distinct !{!79, !"scope"}
!80 = !{!81, !23}
!81 = distinct !{!81, !82, !"scope"}
!82 = distinct !{!82, !"scope"}
!83 = !{!84, !86}
!84 = distinct !{!84, !85, !"scope"}
!85 = distinct !{!85, !"scope"}
!86 = distinct !{!86, !87, !"scope"}
!87 = distinct !{!87, !"scope"}
!88 = !{!86}
!89 = !{!90, !92, !94, !96}
!90 = distinct !{!90, !91, !"scope"}
!91 = distinct !{!91, !"scope"}
!92 = distinct !{!92, !93, !"scope"}
!93 = distinct !{!93, !"scope"}
!94 = distinct !{!94, !95, !"scope"}
!95 = distinct !{!95, !"scope"}
!96 = distinct !{!96, !97, !"scope"}
!97 = distinct !{!97, !"scope"}
!98 = !{!92, !94, !96}
!99 = !{!94, !96}
!100 = !{!96}
!101 = !{!102}
!102 = distinct !{!102, !103, !"scope"}
!103 = distinct !{!103, !"scope"}
!104 = !{!105, !107}
!105 = distinct !{!105, !106, !"scope"}
!106 = distinct !{!106, !"scope"}
!107 = distinct !{!107, !108, !"scope"}
!108 = distinct !{!108, !"scope"}
!109 = !{!107}
!110 = !{!111}
!111 = distinct !{!111, !112, !"scope"}
!112 = distinct !{!112, !"scope"}
!113 = !{!114}
!114 = distinct !{!114, !115, !"scope"}
!115 = distinct !{!115, !"scope"}
!116 = !{!117, !119, !121, !123}
!117 = distinct !{!117, !118, !"scope"}
!118 = distinct !{!118, !"scope"}
!119 = distinct !{!119, !120, !"scope"}
!120 = distinct !{!120, !"scope"}
!121 = distinct !{!121, !122, !"scope"}
!122 = distinct !{!122, !"scope"}
!123 = distinct !{!123, !124, !"scope"}
!124 = distinct !{!124, !"scope"}
!125 = !{!119, !121, !123}
!126 = !{!121, !123}
!127 = !{!123}
!128 = !{!129}
!129 = distinct !{!129, !130, !"scope"}
!130 = distinct !{!130, !"scope"}
!131 = !{!132}
!132 = distinct !{!132, !133, !"scope"}
!133 = distinct !{!133, !"scope"}
!134 = !{!135}
!135 = distinct !{!135, !136, !"scope"}
!136 = distinct !{!136, !"scope"}
!137 = !{!138}
!138 = distinct !{!138, !139, !"scope"}
!139 = distinct !{!139, !"scope"}
!140 = !{!141, !143, !145, !147}
!141 = distinct !{!141, !142, !"scope"}
!142 = distinct !{!142, !"scope"}
!143 = distinct !{!143, !144, !"scope"}
!144 = distinct !{!144, !"scope"}
!145 = distinct !{!145, !146, !"scope"}
!146 = distinct !{!146, !"scope"}
!147 = distinct !{!147, !148, !"scope"}
!148 = distinct !{!148, !"scope"}
!149 = !{!143, !145, !147}
!150 = !{!145, !147}
!151 = !{!147}
