; made from estimator.py, estimator_job.py, integrator.py, stepping.py, job.py, rosenbrock.py, sha256 4d815c098f0cd7e00e5c2eb2130f207e32faf6d31ba52df3652d415c51368b93
@v60 = private unnamed_addr constant [4 x double] [double 3.860000e-01, double 2.100000e-01, double 6.300000e-01, double 1.000000e+00], align 8
define internal fastcc void @v61(ptr noalias nonnull writeonly %retptr, ptr readonly %arg.fields) unnamed_addr {
entry:
  %.1308.i9147.i = alloca double, align 8
  %.2300.i.i = alloca i8, align 1
  %.1308.i.i = alloca double, align 8
  %.1601.i = alloca i8, align 1
  %.471.i.i = alloca double, align 8
  %.515.i.i = alloca i8, align 1
  %.661.i.i4184 = alloca double, align 8
  %.3013.i = alloca ptr, align 8
  %.3352.i = alloca ptr, align 8
  %.3808.i = alloca { i64, double }, align 8
  %.476.i = alloca [38 x i64], align 8
  %.484.i = alloca [39 x i64], align 8
  call void @llvm.lifetime.start.p0(ptr nonnull %.484.i)
  %.fca.1.gep.i = getelementptr inbounds i8, ptr %.484.i, i64 8
  %.fca.2.gep.i = getelementptr inbounds i8, ptr %.484.i, i64 16
  %.fca.3.gep.i = getelementptr inbounds i8, ptr %.484.i, i64 24
  %.fca.4.gep.i = getelementptr inbounds i8, ptr %.484.i, i64 32
  %.fca.5.gep.i = getelementptr inbounds i8, ptr %.484.i, i64 40
  %.fca.6.gep.i = getelementptr inbounds i8, ptr %.484.i, i64 48
  %.fca.7.gep.i = getelementptr inbounds i8, ptr %.484.i, i64 56
  %.fca.8.gep.i = getelementptr inbounds i8, ptr %.484.i, i64 64
  %.fca.9.gep.i = getelementptr inbounds i8, ptr %.484.i, i64 72
  %.fca.10.gep.i = getelementptr inbounds i8, ptr %.484.i, i64 80
  %.fca.11.gep.i = getelementptr inbounds i8, ptr %.484.i, i64 88
  %.fca.12.gep.i = getelementptr inbounds i8, ptr %.484.i, i64 96
  %.fca.13.gep.i = getelementptr inbounds i8, ptr %.484.i, i64 104
  %.fca.14.gep.i = getelementptr inbounds i8, ptr %.484.i, i64 112
  %.fca.15.gep.i = getelementptr inbounds i8, ptr %.484.i, i64 120
  %.fca.16.gep.i = getelementptr inbounds i8, ptr %.484.i, i64 128
  %.fca.17.gep.i = getelementptr inbounds i8, ptr %.484.i, i64 136
  %.fca.18.gep.i = getelementptr inbounds i8, ptr %.484.i, i64 144
  %.fca.19.gep.i = getelementptr inbounds i8, ptr %.484.i, i64 152
  %.fca.20.gep.i = getelementptr inbounds i8, ptr %.484.i, i64 160
  %.fca.21.gep.i = getelementptr inbounds i8, ptr %.484.i, i64 168
  %.fca.22.gep.i = getelementptr inbounds i8, ptr %.484.i, i64 176
  %.fca.23.gep.i = getelementptr inbounds i8, ptr %.484.i, i64 184
  %.fca.24.gep.i = getelementptr inbounds i8, ptr %.484.i, i64 192
  %.fca.25.gep.i = getelementptr inbounds i8, ptr %.484.i, i64 200
  %.fca.26.gep.i = getelementptr inbounds i8, ptr %.484.i, i64 208
  %.fca.27.gep.i = getelementptr inbounds i8, ptr %.484.i, i64 216
  %.fca.28.gep.i = getelementptr inbounds i8, ptr %.484.i, i64 224
  %.fca.29.gep.i = getelementptr inbounds i8, ptr %.484.i, i64 232
  %.fca.30.gep.i = getelementptr inbounds i8, ptr %.484.i, i64 240
  %.fca.31.gep.i = getelementptr inbounds i8, ptr %.484.i, i64 248
  %.fca.32.gep.i = getelementptr inbounds i8, ptr %.484.i, i64 256
  %.fca.33.gep.i = getelementptr inbounds i8, ptr %.484.i, i64 264
  %.fca.34.gep.i = getelementptr inbounds i8, ptr %.484.i, i64 272
  %.fca.35.gep.i = getelementptr inbounds i8, ptr %.484.i, i64 280
  %.fca.36.gep.i = getelementptr inbounds i8, ptr %.484.i, i64 288
  %.fca.37.gep.i = getelementptr inbounds i8, ptr %.484.i, i64 296
  %.fca.38.gep.i = getelementptr inbounds i8, ptr %.484.i, i64 304
  br label %B38.if.i
B38.if.i:
  %out.2.sroa.0.0477.i = phi i64 [ undef, %entry ], [ %.489.fca.0.load.i, %B38.if.i ]
  %out.2.sroa.9.0476.i = phi i64 [ undef, %entry ], [ %.489.fca.1.load.i, %B38.if.i ]
  %out.2.sroa.18.0475.i = phi i64 [ undef, %entry ], [ %.489.fca.2.load.i, %B38.if.i ]
  %out.2.sroa.27.0474.i = phi i64 [ undef, %entry ], [ %.489.fca.3.load.i, %B38.if.i ]
  %out.2.sroa.36.0473.i = phi i64 [ undef, %entry ], [ %.489.fca.4.load.i, %B38.if.i ]
  %out.2.sroa.45.0472.i = phi i64 [ undef, %entry ], [ %.489.fca.5.load.i, %B38.if.i ]
  %out.2.sroa.54.0471.i = phi i64 [ undef, %entry ], [ %.489.fca.6.load.i, %B38.if.i ]
  %out.2.sroa.63.0470.i = phi i64 [ undef, %entry ], [ %.489.fca.7.load.i, %B38.if.i ]
  %out.2.sroa.72.0469.i = phi i64 [ undef, %entry ], [ %.489.fca.8.load.i, %B38.if.i ]
  %out.2.sroa.81.0468.i = phi i64 [ undef, %entry ], [ %.489.fca.9.load.i, %B38.if.i ]
  %out.2.sroa.90.0467.i = phi i64 [ undef, %entry ], [ %.489.fca.10.load.i, %B38.if.i ]
  %out.2.sroa.99.0466.i = phi i64 [ undef, %entry ], [ %.489.fca.11.load.i, %B38.if.i ]
  %out.2.sroa.108.0465.i = phi i64 [ undef, %entry ], [ %.489.fca.12.load.i, %B38.if.i ]
  %out.2.sroa.117.0464.i = phi i64 [ undef, %entry ], [ %.489.fca.13.load.i, %B38.if.i ]
  %out.2.sroa.126.0463.i = phi i64 [ undef, %entry ], [ %.489.fca.14.load.i, %B38.if.i ]
  %out.2.sroa.135.0462.i = phi i64 [ undef, %entry ], [ %.489.fca.15.load.i, %B38.if.i ]
  %out.2.sroa.144.0461.i = phi i64 [ undef, %entry ], [ %.489.fca.16.load.i, %B38.if.i ]
  %out.2.sroa.153.0460.i = phi i64 [ undef, %entry ], [ %.489.fca.17.load.i, %B38.if.i ]
  %out.2.sroa.162.0459.i = phi i64 [ undef, %entry ], [ %.489.fca.18.load.i, %B38.if.i ]
  %out.2.sroa.171.0458.i = phi i64 [ undef, %entry ], [ %.489.fca.19.load.i, %B38.if.i ]
  %out.2.sroa.180.0457.i = phi i64 [ undef, %entry ], [ %.489.fca.20.load.i, %B38.if.i ]
  %out.2.sroa.189.0456.i = phi i64 [ undef, %entry ], [ %.489.fca.21.load.i, %B38.if.i ]
  %out.2.sroa.198.0455.i = phi i64 [ undef, %entry ], [ %.489.fca.22.load.i, %B38.if.i ]
  %out.2.sroa.207.0454.i = phi i64 [ undef, %entry ], [ %.489.fca.23.load.i, %B38.if.i ]
  %out.2.sroa.216.0453.i = phi i64 [ undef, %entry ], [ %.489.fca.24.load.i, %B38.if.i ]
  %out.2.sroa.225.0452.i = phi i64 [ undef, %entry ], [ %.489.fca.25.load.i, %B38.if.i ]
  %out.2.sroa.234.0451.i = phi i64 [ undef, %entry ], [ %.489.fca.26.load.i, %B38.if.i ]
  %out.2.sroa.243.0450.i = phi i64 [ undef, %entry ], [ %.489.fca.27.load.i, %B38.if.i ]
  %out.2.sroa.252.0449.i = phi i64 [ undef, %entry ], [ %.489.fca.28.load.i, %B38.if.i ]
  %out.2.sroa.261.0448.i = phi i64 [ undef, %entry ], [ %.489.fca.29.load.i, %B38.if.i ]
  %out.2.sroa.270.0447.i = phi i64 [ undef, %entry ], [ %.489.fca.30.load.i, %B38.if.i ]
  %out.2.sroa.279.0446.i = phi i64 [ undef, %entry ], [ %.489.fca.31.load.i, %B38.if.i ]
  %out.2.sroa.288.0445.i = phi i64 [ undef, %entry ], [ %.489.fca.32.load.i, %B38.if.i ]
  %out.2.sroa.297.0444.i = phi i64 [ undef, %entry ], [ %.489.fca.33.load.i, %B38.if.i ]
  %out.2.sroa.306.0443.i = phi i64 [ undef, %entry ], [ %.489.fca.34.load.i, %B38.if.i ]
  %out.2.sroa.315.0442.i = phi i64 [ undef, %entry ], [ %.489.fca.35.load.i, %B38.if.i ]
  %out.2.sroa.324.0441.i = phi i64 [ undef, %entry ], [ %.489.fca.36.load.i, %B38.if.i ]
  %out.2.sroa.333.0440.i = phi i64 [ undef, %entry ], [ %.489.fca.37.load.i, %B38.if.i ]
  %out.2.sroa.342.0439.i = phi i64 [ undef, %entry ], [ %.489.fca.38.load.i, %B38.if.i ]
  %.357.0437.i = phi i64 [ 0, %entry ], [ %.428.i, %B38.if.i ]
  %.428.i = add nuw nsw i64 %.357.0437.i, 1
  %0 = getelementptr i64, ptr %arg.fields, i64 %.357.0437.i
  %.482.i = load i64, ptr %0, align 8, !noalias !0
  store i64 %out.2.sroa.0.0477.i, ptr %.484.i, align 8, !noalias !0
  store i64 %out.2.sroa.9.0476.i, ptr %.fca.1.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.18.0475.i, ptr %.fca.2.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.27.0474.i, ptr %.fca.3.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.36.0473.i, ptr %.fca.4.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.45.0472.i, ptr %.fca.5.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.54.0471.i, ptr %.fca.6.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.63.0470.i, ptr %.fca.7.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.72.0469.i, ptr %.fca.8.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.81.0468.i, ptr %.fca.9.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.90.0467.i, ptr %.fca.10.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.99.0466.i, ptr %.fca.11.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.108.0465.i, ptr %.fca.12.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.117.0464.i, ptr %.fca.13.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.126.0463.i, ptr %.fca.14.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.135.0462.i, ptr %.fca.15.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.144.0461.i, ptr %.fca.16.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.153.0460.i, ptr %.fca.17.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.162.0459.i, ptr %.fca.18.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.171.0458.i, ptr %.fca.19.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.180.0457.i, ptr %.fca.20.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.189.0456.i, ptr %.fca.21.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.198.0455.i, ptr %.fca.22.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.207.0454.i, ptr %.fca.23.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.216.0453.i, ptr %.fca.24.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.225.0452.i, ptr %.fca.25.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.234.0451.i, ptr %.fca.26.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.243.0450.i, ptr %.fca.27.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.252.0449.i, ptr %.fca.28.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.261.0448.i, ptr %.fca.29.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.270.0447.i, ptr %.fca.30.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.279.0446.i, ptr %.fca.31.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.288.0445.i, ptr %.fca.32.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.297.0444.i, ptr %.fca.33.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.306.0443.i, ptr %.fca.34.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.315.0442.i, ptr %.fca.35.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.324.0441.i, ptr %.fca.36.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.333.0440.i, ptr %.fca.37.gep.i, align 8, !noalias !0
  store i64 %out.2.sroa.342.0439.i, ptr %.fca.38.gep.i, align 8, !noalias !0
  %.487.i = getelementptr inbounds i64, ptr %.484.i, i64 %.357.0437.i
  store i64 %.482.i, ptr %.487.i, align 8, !noalias !0
  %.489.fca.0.load.i = load i64, ptr %.484.i, align 8, !noalias !0
  %.489.fca.1.load.i = load i64, ptr %.fca.1.gep.i, align 8, !noalias !0
  %.489.fca.2.load.i = load i64, ptr %.fca.2.gep.i, align 8, !noalias !0
  %.489.fca.3.load.i = load i64, ptr %.fca.3.gep.i, align 8, !noalias !0
  %.489.fca.4.load.i = load i64, ptr %.fca.4.gep.i, align 8, !noalias !0
  %.489.fca.5.load.i = load i64, ptr %.fca.5.gep.i, align 8, !noalias !0
  %.489.fca.6.load.i = load i64, ptr %.fca.6.gep.i, align 8, !noalias !0
  %.489.fca.7.load.i = load i64, ptr %.fca.7.gep.i, align 8, !noalias !0
  %.489.fca.8.load.i = load i64, ptr %.fca.8.gep.i, align 8, !noalias !0
  %.489.fca.9.load.i = load i64, ptr %.fca.9.gep.i, align 8, !noalias !0
  %.489.fca.10.load.i = load i64, ptr %.fca.10.gep.i, align 8, !noalias !0
  %.489.fca.11.load.i = load i64, ptr %.fca.11.gep.i, align 8, !noalias !0
  %.489.fca.12.load.i = load i64, ptr %.fca.12.gep.i, align 8, !noalias !0
  %.489.fca.13.load.i = load i64, ptr %.fca.13.gep.i, align 8, !noalias !0
  %.489.fca.14.load.i = load i64, ptr %.fca.14.gep.i, align 8, !noalias !0
  %.489.fca.15.load.i = load i64, ptr %.fca.15.gep.i, align 8, !noalias !0
  %.489.fca.16.load.i = load i64, ptr %.fca.16.gep.i, align 8, !noalias !0
  %.489.fca.17.load.i = load i64, ptr %.fca.17.gep.i, align 8, !noalias !0
  %.489.fca.18.load.i = load i64, ptr %.fca.18.gep.i, align 8, !noalias !0
  %.489.fca.19.load.i = load i64, ptr %.fca.19.gep.i, align 8, !noalias !0
  %.489.fca.20.load.i = load i64, ptr %.fca.20.gep.i, align 8, !noalias !0
  %.489.fca.21.load.i = load i64, ptr %.fca.21.gep.i, align 8, !noalias !0
  %.489.fca.22.load.i = load i64, ptr %.fca.22.gep.i, align 8, !noalias !0
  %.489.fca.23.load.i = load i64, ptr %.fca.23.gep.i, align 8, !noalias !0
  %.489.fca.24.load.i = load i64, ptr %.fca.24.gep.i, align 8, !noalias !0
  %.489.fca.25.load.i = load i64, ptr %.fca.25.gep.i, align 8, !noalias !0
  %.489.fca.26.load.i = load i64, ptr %.fca.26.gep.i, align 8, !noalias !0
  %.489.fca.27.load.i = load i64, ptr %.fca.27.gep.i, align 8, !noalias !0
  %.489.fca.28.load.i = load i64, ptr %.fca.28.gep.i, align 8, !noalias !0
  %.489.fca.29.load.i = load i64, ptr %.fca.29.gep.i, align 8, !noalias !0
  %.489.fca.30.load.i = load i64, ptr %.fca.30.gep.i, align 8, !noalias !0
  %.489.fca.31.load.i = load i64, ptr %.fca.31.gep.i, align 8, !noalias !0
  %.489.fca.32.load.i = load i64, ptr %.fca.32.gep.i, align 8, !noalias !0
  %.489.fca.33.load.i = load i64, ptr %.fca.33.gep.i, align 8, !noalias !0
  %.489.fca.34.load.i = load i64, ptr %.fca.34.gep.i, align 8, !noalias !0
  %.489.fca.35.load.i = load i64, ptr %.fca.35.gep.i, align 8, !noalias !0
  %.489.fca.36.load.i = load i64, ptr %.fca.36.gep.i, align 8, !noalias !0
  %.489.fca.37.load.i = load i64, ptr %.fca.37.gep.i, align 8, !noalias !0
  %.489.fca.38.load.i = load i64, ptr %.fca.38.gep.i, align 8, !noalias !0
  %exitcond.not.i = icmp eq i64 %.428.i, 39
  br i1 %exitcond.not.i, label %b88, label %B38.if.i
b88:
  call void @llvm.lifetime.end.p0(ptr nonnull %.484.i)
  %.316 = inttoptr i64 %.489.fca.3.load.i to ptr
  call void @llvm.lifetime.start.p0(ptr nonnull %.476.i)
  %.fca.1.gep.i4132 = getelementptr inbounds i8, ptr %.476.i, i64 8
  %.fca.2.gep.i4133 = getelementptr inbounds i8, ptr %.476.i, i64 16
  %.fca.3.gep.i4134 = getelementptr inbounds i8, ptr %.476.i, i64 24
  %.fca.4.gep.i4135 = getelementptr inbounds i8, ptr %.476.i, i64 32
  %.fca.5.gep.i4136 = getelementptr inbounds i8, ptr %.476.i, i64 40
  %.fca.6.gep.i4137 = getelementptr inbounds i8, ptr %.476.i, i64 48
  %.fca.7.gep.i4138 = getelementptr inbounds i8, ptr %.476.i, i64 56
  %.fca.8.gep.i4139 = getelementptr inbounds i8, ptr %.476.i, i64 64
  %.fca.9.gep.i4140 = getelementptr inbounds i8, ptr %.476.i, i64 72
  %.fca.10.gep.i4141 = getelementptr inbounds i8, ptr %.476.i, i64 80
  %.fca.11.gep.i4142 = getelementptr inbounds i8, ptr %.476.i, i64 88
  %.fca.12.gep.i4143 = getelementptr inbounds i8, ptr %.476.i, i64 96
  %.fca.13.gep.i4144 = getelementptr inbounds i8, ptr %.476.i, i64 104
  %.fca.14.gep.i4145 = getelementptr inbounds i8, ptr %.476.i, i64 112
  %.fca.15.gep.i4146 = getelementptr inbounds i8, ptr %.476.i, i64 120
  %.fca.16.gep.i4147 = getelementptr inbounds i8, ptr %.476.i, i64 128
  %.fca.17.gep.i4148 = getelementptr inbounds i8, ptr %.476.i, i64 136
  %.fca.18.gep.i4149 = getelementptr inbounds i8, ptr %.476.i, i64 144
  %.fca.19.gep.i4150 = getelementptr inbounds i8, ptr %.476.i, i64 152
  %.fca.20.gep.i4151 = getelementptr inbounds i8, ptr %.476.i, i64 160
  %.fca.21.gep.i4152 = getelementptr inbounds i8, ptr %.476.i, i64 168
  %.fca.22.gep.i4153 = getelementptr inbounds i8, ptr %.476.i, i64 176
  %.fca.23.gep.i4154 = getelementptr inbounds i8, ptr %.476.i, i64 184
  %.fca.24.gep.i4155 = getelementptr inbounds i8, ptr %.476.i, i64 192
  %.fca.25.gep.i4156 = getelementptr inbounds i8, ptr %.476.i, i64 200
  %.fca.26.gep.i4157 = getelementptr inbounds i8, ptr %.476.i, i64 208
  %.fca.27.gep.i4158 = getelementptr inbounds i8, ptr %.476.i, i64 216
  %.fca.28.gep.i4159 = getelementptr inbounds i8, ptr %.476.i, i64 224
  %.fca.29.gep.i4160 = getelementptr inbounds i8, ptr %.476.i, i64 232
  %.fca.30.gep.i4161 = getelementptr inbounds i8, ptr %.476.i, i64 240
  %.fca.31.gep.i4162 = getelementptr inbounds i8, ptr %.476.i, i64 248
  %.fca.32.gep.i4163 = getelementptr inbounds i8, ptr %.476.i, i64 256
  %.fca.33.gep.i4164 = getelementptr inbounds i8, ptr %.476.i, i64 264
  %.fca.34.gep.i4165 = getelementptr inbounds i8, ptr %.476.i, i64 272
  %.fca.35.gep.i4166 = getelementptr inbounds i8, ptr %.476.i, i64 280
  %.fca.36.gep.i4167 = getelementptr inbounds i8, ptr %.476.i, i64 288
  %.fca.37.gep.i4168 = getelementptr inbounds i8, ptr %.476.i, i64 296
  br label %B38.if.i4169
B38.if.i4169:
  %out.2.sroa.0.0467.i = phi i64 [ undef, %b88 ], [ %.481.fca.0.load.i, %B38.if.i4169 ]
  %out.2.sroa.9.0466.i = phi i64 [ undef, %b88 ], [ %.481.fca.1.load.i, %B38.if.i4169 ]
  %out.2.sroa.18.0465.i = phi i64 [ undef, %b88 ], [ %.481.fca.2.load.i, %B38.if.i4169 ]
  %out.2.sroa.27.0464.i = phi i64 [ undef, %b88 ], [ %.481.fca.3.load.i, %B38.if.i4169 ]
  %out.2.sroa.36.0463.i = phi i64 [ undef, %b88 ], [ %.481.fca.4.load.i, %B38.if.i4169 ]
  %out.2.sroa.45.0462.i = phi i64 [ undef, %b88 ], [ %.481.fca.5.load.i, %B38.if.i4169 ]
  %out.2.sroa.54.0461.i = phi i64 [ undef, %b88 ], [ %.481.fca.6.load.i, %B38.if.i4169 ]
  %out.2.sroa.63.0460.i = phi i64 [ undef, %b88 ], [ %.481.fca.7.load.i, %B38.if.i4169 ]
  %out.2.sroa.72.0459.i = phi i64 [ undef, %b88 ], [ %.481.fca.8.load.i, %B38.if.i4169 ]
  %out.2.sroa.81.0458.i = phi i64 [ undef, %b88 ], [ %.481.fca.9.load.i, %B38.if.i4169 ]
  %out.2.sroa.90.0457.i = phi i64 [ undef, %b88 ], [ %.481.fca.10.load.i, %B38.if.i4169 ]
  %out.2.sroa.99.0456.i = phi i64 [ undef, %b88 ], [ %.481.fca.11.load.i, %B38.if.i4169 ]
  %out.2.sroa.108.0455.i = phi i64 [ undef, %b88 ], [ %.481.fca.12.load.i, %B38.if.i4169 ]
  %out.2.sroa.117.0454.i = phi i64 [ undef, %b88 ], [ %.481.fca.13.load.i, %B38.if.i4169 ]
  %out.2.sroa.126.0453.i = phi i64 [ undef, %b88 ], [ %.481.fca.14.load.i, %B38.if.i4169 ]
  %out.2.sroa.135.0452.i = phi i64 [ undef, %b88 ], [ %.481.fca.15.load.i, %B38.if.i4169 ]
  %out.2.sroa.144.0451.i = phi i64 [ undef, %b88 ], [ %.481.fca.16.load.i, %B38.if.i4169 ]
  %out.2.sroa.153.0450.i = phi i64 [ undef, %b88 ], [ %.481.fca.17.load.i, %B38.if.i4169 ]
  %out.2.sroa.162.0449.i = phi i64 [ undef, %b88 ], [ %.481.fca.18.load.i, %B38.if.i4169 ]
  %out.2.sroa.171.0448.i = phi i64 [ undef, %b88 ], [ %.481.fca.19.load.i, %B38.if.i4169 ]
  %out.2.sroa.180.0447.i = phi i64 [ undef, %b88 ], [ %.481.fca.20.load.i, %B38.if.i4169 ]
  %out.2.sroa.189.0446.i = phi i64 [ undef, %b88 ], [ %.481.fca.21.load.i, %B38.if.i4169 ]
  %out.2.sroa.198.0445.i = phi i64 [ undef, %b88 ], [ %.481.fca.22.load.i, %B38.if.i4169 ]
  %out.2.sroa.207.0444.i = phi i64 [ undef, %b88 ], [ %.481.fca.23.load.i, %B38.if.i4169 ]
  %out.2.sroa.216.0443.i = phi i64 [ undef, %b88 ], [ %.481.fca.24.load.i, %B38.if.i4169 ]
  %out.2.sroa.225.0442.i = phi i64 [ undef, %b88 ], [ %.481.fca.25.load.i, %B38.if.i4169 ]
  %out.2.sroa.234.0441.i = phi i64 [ undef, %b88 ], [ %.481.fca.26.load.i, %B38.if.i4169 ]
  %out.2.sroa.243.0440.i = phi i64 [ undef, %b88 ], [ %.481.fca.27.load.i, %B38.if.i4169 ]
  %out.2.sroa.252.0439.i = phi i64 [ undef, %b88 ], [ %.481.fca.28.load.i, %B38.if.i4169 ]
  %out.2.sroa.261.0438.i = phi i64 [ undef, %b88 ], [ %.481.fca.29.load.i, %B38.if.i4169 ]
  %out.2.sroa.270.0437.i = phi i64 [ undef, %b88 ], [ %.481.fca.30.load.i, %B38.if.i4169 ]
  %out.2.sroa.279.0436.i = phi i64 [ undef, %b88 ], [ %.481.fca.31.load.i, %B38.if.i4169 ]
  %out.2.sroa.288.0435.i = phi i64 [ undef, %b88 ], [ %.481.fca.32.load.i, %B38.if.i4169 ]
  %out.2.sroa.297.0434.i = phi i64 [ undef, %b88 ], [ %.481.fca.33.load.i, %B38.if.i4169 ]
  %out.2.sroa.306.0433.i = phi i64 [ undef, %b88 ], [ %.481.fca.34.load.i, %B38.if.i4169 ]
  %out.2.sroa.315.0432.i = phi i64 [ undef, %b88 ], [ %.481.fca.35.load.i, %B38.if.i4169 ]
  %out.2.sroa.324.0431.i = phi i64 [ undef, %b88 ], [ %.481.fca.36.load.i, %B38.if.i4169 ]
  %out.2.sroa.333.0430.i = phi i64 [ undef, %b88 ], [ %.481.fca.37.load.i, %B38.if.i4169 ]
  %.349.0428.i = phi i64 [ 0, %b88 ], [ %.420.i, %B38.if.i4169 ]
  %.420.i = add nuw nsw i64 %.349.0428.i, 1
  %1 = getelementptr i64, ptr %.316, i64 %.349.0428.i
  %.474.i = load i64, ptr %1, align 8, !noalias !3
  store i64 %out.2.sroa.0.0467.i, ptr %.476.i, align 8, !noalias !3
  store i64 %out.2.sroa.9.0466.i, ptr %.fca.1.gep.i4132, align 8, !noalias !3
  store i64 %out.2.sroa.18.0465.i, ptr %.fca.2.gep.i4133, align 8, !noalias !3
  store i64 %out.2.sroa.27.0464.i, ptr %.fca.3.gep.i4134, align 8, !noalias !3
  store i64 %out.2.sroa.36.0463.i, ptr %.fca.4.gep.i4135, align 8, !noalias !3
  store i64 %out.2.sroa.45.0462.i, ptr %.fca.5.gep.i4136, align 8, !noalias !3
  store i64 %out.2.sroa.54.0461.i, ptr %.fca.6.gep.i4137, align 8, !noalias !3
  store i64 %out.2.sroa.63.0460.i, ptr %.fca.7.gep.i4138, align 8, !noalias !3
  store i64 %out.2.sroa.72.0459.i, ptr %.fca.8.gep.i4139, align 8, !noalias !3
  store i64 %out.2.sroa.81.0458.i, ptr %.fca.9.gep.i4140, align 8, !noalias !3
  store i64 %out.2.sroa.90.0457.i, ptr %.fca.10.gep.i4141, align 8, !noalias !3
  store i64 %out.2.sroa.99.0456.i, ptr %.fca.11.gep.i4142, align 8, !noalias !3
  store i64 %out.2.sroa.108.0455.i, ptr %.fca.12.gep.i4143, align 8, !noalias !3
  store i64 %out.2.sroa.117.0454.i, ptr %.fca.13.gep.i4144, align 8, !noalias !3
  store i64 %out.2.sroa.126.0453.i, ptr %.fca.14.gep.i4145, align 8, !noalias !3
  store i64 %out.2.sroa.135.0452.i, ptr %.fca.15.gep.i4146, align 8, !noalias !3
  store i64 %out.2.sroa.144.0451.i, ptr %.fca.16.gep.i4147, align 8, !noalias !3
  store i64 %out.2.sroa.153.0450.i, ptr %.fca.17.gep.i4148, align 8, !noalias !3
  store i64 %out.2.sroa.162.0449.i, ptr %.fca.18.gep.i4149, align 8, !noalias !3
  store i64 %out.2.sroa.171.0448.i, ptr %.fca.19.gep.i4150, align 8, !noalias !3
  store i64 %out.2.sroa.180.0447.i, ptr %.fca.20.gep.i4151, align 8, !noalias !3
  store i64 %out.2.sroa.189.0446.i, ptr %.fca.21.gep.i4152, align 8, !noalias !3
  store i64 %out.2.sroa.198.0445.i, ptr %.fca.22.gep.i4153, align 8, !noalias !3
  store i64 %out.2.sroa.207.0444.i, ptr %.fca.23.gep.i4154, align 8, !noalias !3
  store i64 %out.2.sroa.216.0443.i, ptr %.fca.24.gep.i4155, align 8, !noalias !3
  store i64 %out.2.sroa.225.0442.i, ptr %.fca.25.gep.i4156, align 8, !noalias !3
  store i64 %out.2.sroa.234.0441.i, ptr %.fca.26.gep.i4157, align 8, !noalias !3
  store i64 %out.2.sroa.243.0440.i, ptr %.fca.27.gep.i4158, align 8, !noalias !3
  store i64 %out.2.sroa.252.0439.i, ptr %.fca.28.gep.i4159, align 8, !noalias !3
  store i64 %out.2.sroa.261.0438.i, ptr %.fca.29.gep.i4160, align 8, !noalias !3
  store i64 %out.2.sroa.270.0437.i, ptr %.fca.30.gep.i4161, align 8, !noalias !3
  store i64 %out.2.sroa.279.0436.i, ptr %.fca.31.gep.i4162, align 8, !noalias !3
  store i64 %out.2.sroa.288.0435.i, ptr %.fca.32.gep.i4163, align 8, !noalias !3
  store i64 %out.2.sroa.297.0434.i, ptr %.fca.33.gep.i4164, align 8, !noalias !3
  store i64 %out.2.sroa.306.0433.i, ptr %.fca.34.gep.i4165, align 8, !noalias !3
  store i64 %out.2.sroa.315.0432.i, ptr %.fca.35.gep.i4166, align 8, !noalias !3
  store i64 %out.2.sroa.324.0431.i, ptr %.fca.36.gep.i4167, align 8, !noalias !3
  store i64 %out.2.sroa.333.0430.i, ptr %.fca.37.gep.i4168, align 8, !noalias !3
  %.479.i = getelementptr inbounds i64, ptr %.476.i, i64 %.349.0428.i
  store i64 %.474.i, ptr %.479.i, align 8, !noalias !3
  %.481.fca.0.load.i = load i64, ptr %.476.i, align 8, !noalias !3
  %.481.fca.1.load.i = load i64, ptr %.fca.1.gep.i4132, align 8, !noalias !3
  %.481.fca.2.load.i = load i64, ptr %.fca.2.gep.i4133, align 8, !noalias !3
  %.481.fca.3.load.i = load i64, ptr %.fca.3.gep.i4134, align 8, !noalias !3
  %.481.fca.4.load.i = load i64, ptr %.fca.4.gep.i4135, align 8, !noalias !3
  %.481.fca.5.load.i = load i64, ptr %.fca.5.gep.i4136, align 8, !noalias !3
  %.481.fca.6.load.i = load i64, ptr %.fca.6.gep.i4137, align 8, !noalias !3
  %.481.fca.7.load.i = load i64, ptr %.fca.7.gep.i4138, align 8, !noalias !3
  %.481.fca.8.load.i = load i64, ptr %.fca.8.gep.i4139, align 8, !noalias !3
  %.481.fca.9.load.i = load i64, ptr %.fca.9.gep.i4140, align 8, !noalias !3
  %.481.fca.10.load.i = load i64, ptr %.fca.10.gep.i4141, align 8, !noalias !3
  %.481.fca.11.load.i = load i64, ptr %.fca.11.gep.i4142, align 8, !noalias !3
  %.481.fca.12.load.i = load i64, ptr %.fca.12.gep.i4143, align 8, !noalias !3
  %.481.fca.13.load.i = load i64, ptr %.fca.13.gep.i4144, align 8, !noalias !3
  %.481.fca.14.load.i = load i64, ptr %.fca.14.gep.i4145, align 8, !noalias !3
  %.481.fca.15.load.i = load i64, ptr %.fca.15.gep.i4146, align 8, !noalias !3
  %.481.fca.16.load.i = load i64, ptr %.fca.16.gep.i4147, align 8, !noalias !3
  %.481.fca.17.load.i = load i64, ptr %.fca.17.gep.i4148, align 8, !noalias !3
  %.481.fca.18.load.i = load i64, ptr %.fca.18.gep.i4149, align 8, !noalias !3
  %.481.fca.19.load.i = load i64, ptr %.fca.19.gep.i4150, align 8, !noalias !3
  %.481.fca.20.load.i = load i64, ptr %.fca.20.gep.i4151, align 8, !noalias !3
  %.481.fca.21.load.i = load i64, ptr %.fca.21.gep.i4152, align 8, !noalias !3
  %.481.fca.22.load.i = load i64, ptr %.fca.22.gep.i4153, align 8, !noalias !3
  %.481.fca.23.load.i = load i64, ptr %.fca.23.gep.i4154, align 8, !noalias !3
  %.481.fca.24.load.i = load i64, ptr %.fca.24.gep.i4155, align 8, !noalias !3
  %.481.fca.25.load.i = load i64, ptr %.fca.25.gep.i4156, align 8, !noalias !3
  %.481.fca.26.load.i = load i64, ptr %.fca.26.gep.i4157, align 8, !noalias !3
  %.481.fca.27.load.i = load i64, ptr %.fca.27.gep.i4158, align 8, !noalias !3
  %.481.fca.28.load.i = load i64, ptr %.fca.28.gep.i4159, align 8, !noalias !3
  %.481.fca.29.load.i = load i64, ptr %.fca.29.gep.i4160, align 8, !noalias !3
  %.481.fca.30.load.i = load i64, ptr %.fca.30.gep.i4161, align 8, !noalias !3
  %.481.fca.31.load.i = load i64, ptr %.fca.31.gep.i4162, align 8, !noalias !3
  %.481.fca.32.load.i = load i64, ptr %.fca.32.gep.i4163, align 8, !noalias !3
  %.481.fca.33.load.i = load i64, ptr %.fca.33.gep.i4164, align 8, !noalias !3
  %.481.fca.34.load.i = load i64, ptr %.fca.34.gep.i4165, align 8, !noalias !3
  %.481.fca.35.load.i = load i64, ptr %.fca.35.gep.i4166, align 8, !noalias !3
  %.481.fca.36.load.i = load i64, ptr %.fca.36.gep.i4167, align 8, !noalias !3
  %.481.fca.37.load.i = load i64, ptr %.fca.37.gep.i4168, align 8, !noalias !3
  %exitcond.not.i4170 = icmp eq i64 %.420.i, 38
  br i1 %exitcond.not.i4170, label %b89, label %B38.if.i4169
b89:
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
  br i1 %.397.i, label %B0.endif.endif.endif.endif.else.endif.if.i, label %B0.endif.endif.endif.endif.else.endif.endif.i, !prof !6
B0.endif.endif.endif.endif.endif.i:
  %.377.sroa.13.0.i = phi i64 [ %.311.i, %B0.endif.endif.endif.endif.else.endif.endif.endif.if.i ], [ %.377.sroa.13.1.i, %B0.endif.endif.endif.endif.else.endif.endif.endif.i ]
  %.465.i = sub i64 %.377.sroa.13.0.i, %.377.sroa.0.3.i
  %.474.i4171 = tail call i64 @llvm.smax.i64(i64 %.465.i, i64 0)
  br i1 %.409.i, label %B0.endif.endif.endif.endif.endif.else.if.i, label %B0.endif.endif.endif.endif.endif.else.endif.i, !prof !6
B0.endif.endif.endif.endif.else.endif.if.i:
  br label %B0.endif.endif.endif.endif.else.endif.endif.i
B0.endif.endif.endif.endif.else.endif.endif.i:
  %.377.sroa.0.3.i = phi i64 [ %.311.i, %B0.endif.endif.endif.endif.else.endif.if.i ], [ 0, %b89 ]
  %.404.i = icmp slt i64 %.481.fca.5.load.i, 0
  %.405.i = select i1 %.404.i, i64 %.311.i, i64 0
  %.406.i = add i64 %.405.i, %.297.i
  %.409.i = icmp slt i64 %.406.i, 0
  br i1 %.409.i, label %B0.endif.endif.endif.endif.else.endif.endif.if.i, label %B0.endif.endif.endif.endif.else.endif.endif.endif.i, !prof !6
B0.endif.endif.endif.endif.else.endif.endif.if.i:
  br label %B0.endif.endif.endif.endif.else.endif.endif.endif.i
B0.endif.endif.endif.endif.else.endif.endif.endif.i:
  %.377.sroa.13.1.i = phi i64 [ 0, %B0.endif.endif.endif.endif.else.endif.endif.if.i ], [ %.406.i, %B0.endif.endif.endif.endif.else.endif.endif.i ]
  %.414.not.i = icmp slt i64 %.406.i, %.311.i
  br i1 %.414.not.i, label %B0.endif.endif.endif.endif.endif.i, label %B0.endif.endif.endif.endif.else.endif.endif.endif.if.i, !prof !7
B0.endif.endif.endif.endif.else.endif.endif.endif.if.i:
  br label %B0.endif.endif.endif.endif.endif.i
B0.endif.endif.endif.endif.endif.else.if.i:
  br label %B0.endif.endif.endif.endif.endif.else.endif.i
B0.endif.endif.endif.endif.endif.else.endif.i:
  %.548.sroa.0.1.i = phi i64 [ 0, %B0.endif.endif.endif.endif.endif.else.if.i ], [ %.406.i, %B0.endif.endif.endif.endif.endif.i ]
  br i1 %.414.not.i, label %B0.endif.endif.endif.endi...if.i, label %B0.endif.endif.endif.endif.endif.else.endif.if.i, !prof !7
B0.endif.endif.endif.endif.endif.else.endif.if.i:
  br label %B0.endif.endif.endif.endi...if.i
B0.endif.endif.endif.endi...if.i:
  %.548.sroa.0.3.i = phi i64 [ %.311.i, %B0.endif.endif.endif.endif.endif.else.endif.if.i ], [ %.548.sroa.0.1.i, %B0.endif.endif.endif.endif.endif.else.endif.i ]
  %.636.i = sub i64 %.311.i, %.548.sroa.0.3.i
  %.645.i = tail call i64 @llvm.smax.i64(i64 %.636.i, i64 0)
  %.747.i = icmp slt i64 %.636.i, 1
  br i1 %.747.i, label %B0.endif.endif.endif.endif.endif.endif.else.endif.if.i, label %B0.endif.endif.endif.endif.endif.endif.else.endif.endif.i, !prof !6
B0.endif.endif.endif.endif.endif.endif.else.endif.if.i:
  br label %B0.endif.endif.endif.endif.endif.endif.else.endif.endif.i
B0.endif.endif.endif.endif.endif.endif.else.endif.endif.i:
  %.727.sroa.0.3.i = phi i64 [ %.645.i, %B0.endif.endif.endif.endif.endif.endif.else.endif.if.i ], [ 0, %B0.endif.endif.endif.endi...if.i ]
  %.754.i = icmp slt i64 %.481.fca.7.load.i, 0
  %.755.i = select i1 %.754.i, i64 %.645.i, i64 0
  %.756.i = add i64 %.755.i, %.481.fca.7.load.i
  %.759.i = icmp slt i64 %.756.i, 0
  br i1 %.759.i, label %B0.endif.endif.endif.endi...endif.4.i, label %B0.endif.endif.endif.endi...endif.2.thread.i, !prof !6
B0.endif.endif.endif.endi...endif.2.thread.i:
  %.764.not1965.i = icmp sgt i64 %.636.i, %.756.i
  br i1 %.764.not1965.i, label %B0.endif.endif.endif.endif.endif.endif.endif.else.endif.thread.i, label %B0.endif.endif.endif.endi...if.4.i, !prof !7
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
  br i1 %.930.i, label %B0.endif.endif.endif.endi...endif.6.endif.i, label %B0.endif.endif.endif.endi...endif.4.endif.thread.i, !prof !6
B0.endif.endif.endif.endi...endif.4.endif.thread.i:
  %.935.not1983.i = icmp sgt i64 %.636.i, %.927.i
  br i1 %.935.not1983.i, label %B0.endif.endif.endif.endi...endif.6.thread.i, label %B0.endif.endif.endif.endi...endif.6.if.i, !prof !7
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
  br i1 %.1102.i, label %B0.endif.endif.endif.endi...else.endif.endif.endif.if.i, label %B0.endif.endif.endif.endi...endif.6.endif.endif.thread.i, !prof !6
B0.endif.endif.endif.endi...endif.6.endif.endif.thread.i:
  %.1107.not2017.i = icmp sgt i64 %.636.i, %.1099.i
  br i1 %.1107.not2017.i, label %B0.endif.endif.endif.endi...else.endif.thread.i, label %B0.endif.endif.endif.endi...else.endif.if.i, !prof !7
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
  %2 = tail call i64 @llvm.umin.i64(i64 %.1338.i, i64 2)
  %.16802062.i = add nsw i64 %.481.fca.12.load.i, 2
  %.1733.i = icmp slt i64 %.481.fca.12.load.i, -2
  %.1734.i = select i1 %.1733.i, i64 %.1338.i, i64 0
  %.1735.i = add i64 %.16802062.i, %.1734.i
  %.1738.i = icmp slt i64 %.1735.i, 0
  %.1743.not2071.i = icmp sgt i64 %.1329.i, %.1735.i
  %.1735.i..1338.i = select i1 %.1743.not2071.i, i64 %.1735.i, i64 %.1338.i, !prof !7
  %.1878.sroa.0.3.i = select i1 %.1738.i, i64 0, i64 %.1735.i..1338.i, !prof !6
  %.1966.i = sub nsw i64 %.1338.i, %.1878.sroa.0.3.i
  %.1975.i = tail call i64 @llvm.smax.i64(i64 %.1966.i, i64 0)
  %.2084.i = icmp slt i64 %.1966.i, 1
  br i1 %.2084.i, label %B0.endif.endif.endif.endi...else.1.endif.if.i, label %B0.endif.endif.endif.endi...else.1.endif.endif.i, !prof !6
B0.endif.endif.endif.endi...else.1.endif.if.i:
  br label %B0.endif.endif.endif.endi...else.1.endif.endif.i
B0.endif.endif.endif.endi...else.1.endif.endif.i:
  %.2064.sroa.0.3.i = phi i64 [ %.1975.i, %B0.endif.endif.endif.endi...else.1.endif.if.i ], [ 0, %B0.endif.endif.endif.endi...else.endif.endif.endif.if.i ]
  %.2091.i = icmp slt i64 %.481.fca.13.load.i, 0
  %.2092.i = select i1 %.2091.i, i64 %.1975.i, i64 0
  %.2093.i = add i64 %.2092.i, %.481.fca.13.load.i
  %.2096.i = icmp slt i64 %.2093.i, 0
  %.2101.not2094.i = icmp sgt i64 %.1966.i, %.2093.i
  %.2093.i..1975.i = select i1 %.2101.not2094.i, i64 %.2093.i, i64 %.1975.i, !prof !7
  %.2235.sroa.0.3.i = select i1 %.2096.i, i64 0, i64 %.2093.i..1975.i, !prof !6
  %.2323.i = sub nsw i64 %.1975.i, %.2235.sroa.0.3.i
  %.2332.i = tail call i64 @llvm.smax.i64(i64 %.2323.i, i64 0)
  %.2434.i = icmp slt i64 %.2323.i, 1
  br i1 %.2434.i, label %B0.endif.endif.endif.endi...if.20.i, label %B0.endif.endif.endif.endi...endif.20.i, !prof !6
B0.endif.endif.endif.endi...if.20.i:
  br label %B0.endif.endif.endif.endi...endif.20.i
B0.endif.endif.endif.endi...endif.20.i:
  %.2414.sroa.0.3.i = phi i64 [ %.2332.i, %B0.endif.endif.endif.endi...if.20.i ], [ 0, %B0.endif.endif.endif.endi...else.1.endif.endif.i ]
  %.2441.i = icmp slt i64 %.481.fca.11.load.i, 0
  %.2442.i = select i1 %.2441.i, i64 %.2332.i, i64 0
  %.2443.i = add i64 %.2442.i, %.481.fca.11.load.i
  %.2446.i = icmp slt i64 %.2443.i, 0
  br i1 %.2446.i, label %B0.endif.endif.endif.endi...endif.22.endif.i, label %B0.endif.endif.endif.endi...endif.20.endif.thread.i, !prof !6
B0.endif.endif.endif.endi...endif.20.endif.thread.i:
  %.2451.not2126.i = icmp sgt i64 %.2323.i, %.2443.i
  br i1 %.2451.not2126.i, label %B0.endif.endif.endif.endi...endif.22.thread.i, label %B0.endif.endif.endif.endi...endif.22.if.i, !prof !7
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
  %.2961.i = icmp slt i64 %.465.i, 1
  br i1 %.2961.i, label %B0.endif.endif.endif.endi...endif.24.else.endif.if.i, label %B0.endif.endif.endif.endi...endif.24.else.endif.endif.i, !prof !6
B0.endif.endif.endif.endi...endif.24.else.endif.if.i:
  br label %B0.endif.endif.endif.endi...endif.24.else.endif.endif.i
B0.endif.endif.endif.endi...endif.24.else.endif.endif.i:
  %.2941.sroa.0.3.i = phi i64 [ %.474.i4171, %B0.endif.endif.endif.endi...endif.24.else.endif.if.i ], [ 0, %B0.endif.endif.endif.endi...endif.22.endif.i ]
  %.2969.i = select i1 %.404.i, i64 %.474.i4171, i64 0
  %.2970.i = add i64 %.2969.i, %.481.fca.5.load.i
  %.2973.i = icmp slt i64 %.2970.i, 0
  %.2978.not2193.i = icmp sgt i64 %.465.i, %.2970.i
  %.2970.i..474.i4171 = select i1 %.2978.not2193.i, i64 %.2970.i, i64 %.474.i4171, !prof !7
  %.3112.sroa.0.3.i = select i1 %.2973.i, i64 0, i64 %.2970.i..474.i4171, !prof !6
  %.308621912209.i = shl nsw i64 %.481.fca.5.load.i, 1
  %.3141.i = add i64 %.2969.i, %.308621912209.i
  %.3144.i = icmp slt i64 %.3141.i, 0
  %.3149.not.i = icmp slt i64 %.3141.i, %.474.i4171
  %.3257.i = mul nsw i64 %.481.fca.5.load.i, 6
  %.3295.i = add i64 %.2969.i, %.3257.i
  %.3298.i = icmp slt i64 %.3295.i, 0
  br i1 %.3298.i, label %B0.endif.endif.endif.endi...if.31.i, label %B0.endif.endif.endif.endi...endif.31.i, !prof !6
B0.endif.endif.endif.endi...if.31.i:
  br label %B0.endif.endif.endif.endi...endif.31.i
B0.endif.endif.endif.endi...endif.31.i:
  %.3283.sroa.0.1.i = phi i64 [ 0, %B0.endif.endif.endif.endi...if.31.i ], [ %.3295.i, %B0.endif.endif.endif.endi...endif.24.else.endif.endif.i ]
  %.3303.not.i = icmp slt i64 %.3295.i, %.474.i4171
  br i1 %.3303.not.i, label %B0.endif.endif.endif.endi...endif.31.endif.endif.if.i, label %B0.endif.endif.endif.endi...endif.31.if.i, !prof !7
B0.endif.endif.endif.endi...endif.31.if.i:
  br label %B0.endif.endif.endif.endi...endif.31.endif.endif.if.i
B0.endif.endif.endif.endi...endif.31.endif.endif.if.i:
  %.3283.sroa.0.3.i = phi i64 [ %.474.i4171, %B0.endif.endif.endif.endi...endif.31.if.i ], [ %.3283.sroa.0.1.i, %B0.endif.endif.endif.endi...endif.31.i ]
  %.3428.i = mul nsw i64 %.481.fca.5.load.i, 11
  %.3466.i = add i64 %.2969.i, %.3428.i
  %.3469.i = icmp slt i64 %.3466.i, 0
  br i1 %.3469.i, label %B0.endif.endif.endif.endi...else.3.if.i, label %B0.endif.endif.endif.endi...else.3.endif.i, !prof !6
B0.endif.endif.endif.endi...else.3.if.i:
  br label %B0.endif.endif.endif.endi...else.3.endif.i
B0.endif.endif.endif.endi...else.3.endif.i:
  %.3454.sroa.0.1.i = phi i64 [ 0, %B0.endif.endif.endif.endi...else.3.if.i ], [ %.3466.i, %B0.endif.endif.endif.endi...endif.31.endif.endif.if.i ]
  %.3474.not.i = icmp slt i64 %.3466.i, %.474.i4171
  br i1 %.3474.not.i, label %B0.endif.endif.endif.endi...if.34.i, label %B0.endif.endif.endif.endi...else.3.endif.if.i, !prof !7
B0.endif.endif.endif.endi...else.3.endif.if.i:
  br label %B0.endif.endif.endif.endi...if.34.i
B0.endif.endif.endif.endi...if.34.i:
  %.3454.sroa.0.3.i = phi i64 [ %.474.i4171, %B0.endif.endif.endif.endi...else.3.endif.if.i ], [ %.3454.sroa.0.1.i, %B0.endif.endif.endif.endi...else.3.endif.i ]
  %.3600.i = mul nsw i64 %.481.fca.5.load.i, 3
  br i1 %.3144.i, label %B0.endif.endif.endif.endi...endif.33.else.if.i, label %B0.endif.endif.endif.endi...endif.33.else.endif.i, !prof !6
B0.endif.endif.endif.endi...endif.33.else.if.i:
  br label %B0.endif.endif.endif.endi...endif.33.else.endif.i
B0.endif.endif.endif.endi...endif.33.else.endif.i:
  %.3626.sroa.0.1.i = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.33.else.if.i ], [ %.3141.i, %B0.endif.endif.endif.endi...if.34.i ]
  br i1 %.3149.not.i, label %B0.endif.endif.endif.endi...endif.33.else.endif.endif.i, label %B0.endif.endif.endif.endi...endif.33.else.endif.if.i, !prof !7
B0.endif.endif.endif.endi...endif.33.else.endif.if.i:
  br label %B0.endif.endif.endif.endi...endif.33.else.endif.endif.i
B0.endif.endif.endif.endi...endif.33.else.endif.endif.i:
  %.3626.sroa.0.3.i = phi i64 [ %.474.i4171, %B0.endif.endif.endif.endi...endif.33.else.endif.if.i ], [ %.3626.sroa.0.1.i, %B0.endif.endif.endif.endi...endif.33.else.endif.i ]
  %.3655.i = add i64 %.2969.i, %.3600.i
  %.3658.i = icmp slt i64 %.3655.i, 0
  %.3663.not.i = icmp slt i64 %.3655.i, %.474.i4171
  %.3771.i = shl nsw i64 %.481.fca.5.load.i, 2
  %.3810.i = add i64 %.2969.i, %.3771.i
  %.3813.i = icmp slt i64 %.3810.i, 0
  br i1 %.3813.i, label %B0.endif.endif.endif.endi...endif.33.endif.else.if.i, label %B0.endif.endif.endif.endi...endif.33.endif.else.endif.i, !prof !6
B0.endif.endif.endif.endi...endif.33.endif.else.if.i:
  br label %B0.endif.endif.endif.endi...endif.33.endif.else.endif.i
B0.endif.endif.endif.endi...endif.33.endif.else.endif.i:
  %.3798.sroa.0.1.i = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.33.endif.else.if.i ], [ %.3810.i, %B0.endif.endif.endif.endi...endif.33.else.endif.endif.i ]
  %.3818.not.i = icmp slt i64 %.3810.i, %.474.i4171
  br i1 %.3818.not.i, label %B0.endif.endif.endif.endi...endif.38.i, label %B0.endif.endif.endif.endi...if.38.i, !prof !7
B0.endif.endif.endif.endi...if.38.i:
  br label %B0.endif.endif.endif.endi...endif.38.i
B0.endif.endif.endif.endi...endif.38.i:
  %.3798.sroa.0.3.i = phi i64 [ %.474.i4171, %B0.endif.endif.endif.endi...if.38.i ], [ %.3798.sroa.0.1.i, %B0.endif.endif.endif.endi...endif.33.endif.else.endif.i ]
  br i1 %.3658.i, label %B0.endif.endif.endif.endi...if.40.i, label %B0.endif.endif.endif.endi...endif.40.i, !prof !6
B0.endif.endif.endif.endi...endif.33.endif.endif.endif.i:
  %.3970.sroa.13.0.i = phi i64 [ %.474.i4171, %B0.endif.endif.endif.endi...endif.40.endif.endif.if.i ], [ %.3970.sroa.13.1.i, %B0.endif.endif.endif.endi...endif.40.endif.endif.i ]
  %.4273.i = icmp slt i64 %.481.fca.9.load.i, 0
  %.4274.i = select i1 %.4273.i, i64 %.163.i, i64 0
  %.4275.i = add i64 %.4274.i, %.481.fca.9.load.i
  %.4278.i = icmp slt i64 %.4275.i, 0
  br i1 %.4278.i, label %B0.endif.endif.endif.endi...else.4.if.i, label %B0.endif.endif.endif.endi...else.4.endif.i, !prof !6
B0.endif.endif.endif.endi...if.40.i:
  br label %B0.endif.endif.endif.endi...endif.40.i
B0.endif.endif.endif.endi...endif.40.i:
  %.3970.sroa.0.1.i = phi i64 [ 0, %B0.endif.endif.endif.endi...if.40.i ], [ %.3655.i, %B0.endif.endif.endif.endi...endif.38.i ]
  br i1 %.3663.not.i, label %B0.endif.endif.endif.endi...endif.40.endif.i, label %B0.endif.endif.endif.endi...endif.40.if.i, !prof !7
B0.endif.endif.endif.endi...endif.40.if.i:
  br label %B0.endif.endif.endif.endi...endif.40.endif.i
B0.endif.endif.endif.endi...endif.40.endif.i:
  %.3970.sroa.0.3.i = phi i64 [ %.474.i4171, %B0.endif.endif.endif.endi...endif.40.if.i ], [ %.3970.sroa.0.1.i, %B0.endif.endif.endif.endi...endif.40.i ]
  br i1 %.3813.i, label %B0.endif.endif.endif.endi...endif.40.endif.if.i, label %B0.endif.endif.endif.endi...endif.40.endif.endif.i, !prof !6
B0.endif.endif.endif.endi...endif.40.endif.if.i:
  br label %B0.endif.endif.endif.endi...endif.40.endif.endif.i
B0.endif.endif.endif.endi...endif.40.endif.endif.i:
  %.3970.sroa.13.1.i = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.40.endif.if.i ], [ %.3810.i, %B0.endif.endif.endif.endi...endif.40.endif.i ]
  br i1 %.3818.not.i, label %B0.endif.endif.endif.endi...endif.33.endif.endif.endif.i, label %B0.endif.endif.endif.endi...endif.40.endif.endif.if.i, !prof !7
B0.endif.endif.endif.endi...endif.40.endif.endif.if.i:
  br label %B0.endif.endif.endif.endi...endif.33.endif.endif.endif.i
B0.endif.endif.endif.endi...else.4.if.i:
  br label %B0.endif.endif.endif.endi...else.4.endif.i
B0.endif.endif.endif.endi...else.4.endif.i:
  %.4263.sroa.0.1.i = phi i64 [ 0, %B0.endif.endif.endif.endi...else.4.if.i ], [ %.4275.i, %B0.endif.endif.endif.endi...endif.33.endif.endif.endif.i ]
  %.4283.not.i = icmp slt i64 %.4275.i, %.163.i
  br i1 %.4283.not.i, label %b90, label %B0.endif.endif.endif.endi...else.4.endif.if.i, !prof !7
B0.endif.endif.endif.endi...else.4.endif.if.i:
  br label %b90
b90:
  %.4263.sroa.0.3.i = phi i64 [ %.163.i, %B0.endif.endif.endif.endi...else.4.endif.if.i ], [ %.4263.sroa.0.1.i, %B0.endif.endif.endif.endi...else.4.endif.i ]
  %.304.i = mul nsw i64 %.481.fca.6.load.i, 24
  %.305.i = add nsw i64 %.481.fca.36.load.i, %.304.i
  %.306.i = inttoptr i64 %.305.i to ptr
  %.490.i = getelementptr double, ptr %.306.i, i64 %.377.sroa.0.3.i
  %.4083.i = getelementptr double, ptr %.490.i, i64 %.3970.sroa.0.3.i
  %.4058.i = sub nsw i64 %.3970.sroa.13.0.i, %.3970.sroa.0.3.i
  %.4067.i = tail call i64 @llvm.smax.i64(i64 %.4058.i, i64 0)
  %.3911.i = getelementptr double, ptr %.490.i, i64 %.3798.sroa.0.3.i
  %.3739.i = getelementptr double, ptr %.490.i, i64 %.3626.sroa.0.3.i
  %.3567.i = getelementptr double, ptr %.490.i, i64 %.3454.sroa.0.3.i
  %.3396.i = getelementptr double, ptr %.490.i, i64 %.3283.sroa.0.3.i
  %.3225.i = getelementptr double, ptr %.490.i, i64 %.3112.sroa.0.3.i
  %.305421902210.i = getelementptr double, ptr %.490.i, i64 %.2941.sroa.0.3.i
  %.661.i = getelementptr double, ptr %.306.i, i64 %.548.sroa.0.3.i
  %.1354.i = getelementptr double, ptr %.661.i, i64 %.1241.sroa.0.3.i
  %.1991.i = getelementptr double, ptr %.1354.i, i64 %.1878.sroa.0.3.i
  %.2348.i = getelementptr double, ptr %.1991.i, i64 %.2235.sroa.0.3.i
  %.269821422175.i = getelementptr double, ptr %.2348.i, i64 %.2585.sroa.0.3.i
  %.252721232160.i = getelementptr double, ptr %.2348.i, i64 %.2414.sroa.0.3.i
  %.217720922108.i = getelementptr double, ptr %.1991.i, i64 %.2064.sroa.0.3.i
  %.181920692085.i = getelementptr double, ptr %.1354.i, i64 %2
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
  %.4926.i = inttoptr i64 %.481.fca.22.load.i to ptr
  %.5090.i = inttoptr i64 %.481.fca.35.load.i to ptr
  %.264.i = add nsw i64 %.489.fca.6.load.i, %.489.fca.5.load.i
  %.265.i = add nsw i64 %.481.fca.5.load.i, %.489.fca.4.load.i
  %.1345.i = mul nsw i64 %.489.fca.9.load.i, %.489.fca.8.load.i
  %.302.i.i = add nsw i64 %.481.fca.5.load.i, 4
  %.303.i.i = add nsw i64 %.302.i.i, %.264.i
  %.304.i.i = mul nsw i64 %.303.i.i, %.489.fca.7.load.i
  %.305.i.i = add nsw i64 %.304.i.i, %.1345.i
  %.307.i.i = mul nsw i64 %.265.i, 5
  %.308.i.i = add i64 %.481.fca.10.load.i, %.307.i.i
  %.310.i.i = add i64 %.305.i.i, %.481.fca.7.load.i
  %.311.i.i = add i64 %.310.i.i, %.308.i.i
  %.388.i.i = icmp slt i64 %.305.i.i, 0
  %.389.i.i = select i1 %.388.i.i, i64 %.311.i.i, i64 0
  %.390.i.i = add i64 %.389.i.i, %.305.i.i
  %.393.i.i = icmp slt i64 %.390.i.i, 0
  br i1 %.393.i.i, label %B0.endif.else.if.i.i, label %B0.endif.else.endif.i.i, !prof !6
B0.endif.else.if.i.i:
  br label %B0.endif.else.endif.i.i
B0.endif.else.endif.i.i:
  %.378.sroa.0.1.i.i = phi i64 [ 0, %B0.endif.else.if.i.i ], [ %.390.i.i, %b90 ]
  %.398.not.i.i = icmp slt i64 %.390.i.i, %.311.i.i
  br i1 %.398.not.i.i, label %B0.endif.else.endif.endif.endif.if.i.i, label %B0.endif.else.endif.if.i.i, !prof !7
B0.endif.else.endif.if.i.i:
  br label %B0.endif.else.endif.endif.endif.if.i.i
B0.endif.else.endif.endif.endif.if.i.i:
  %.378.sroa.0.3.i.i = phi i64 [ %.311.i.i, %B0.endif.else.endif.if.i.i ], [ %.378.sroa.0.1.i.i, %B0.endif.else.endif.i.i ]
  %.466.i.i = sub i64 %.311.i.i, %.378.sroa.0.3.i.i
  %.475.i.i = tail call i64 @llvm.smax.i64(i64 %.466.i.i, i64 0)
  %.949.i.i = icmp slt i64 %.311.i.i, 1
  br i1 %.949.i.i, label %B0.endif.endif.endif.endi...else.endif.if.i.i, label %B0.endif.endif.endif.endi...else.endif.endif.i.i, !prof !6
B0.endif.endif.endif.endi...endif.1.i.i:
  %.929.sroa.13.0.i.i = phi i64 [ %.311.i.i, %B0.endif.endif.endif.endi...else.endif.endif.endif.if.i.i ], [ %.929.sroa.13.1.i.i, %B0.endif.endif.endif.endi...else.endif.endif.endif.i.i ]
  %.1074.i.i = shl nsw i64 %.489.fca.7.load.i, 1
  br i1 %.961.i.i, label %B0.endif.endif.endif.endi...endif.1.else.if.i.i, label %B0.endif.endif.endif.endi...endif.1.else.endif.i.i, !prof !6
B0.endif.endif.endif.endi...else.endif.if.i.i:
  br label %B0.endif.endif.endif.endi...else.endif.endif.i.i
B0.endif.endif.endif.endi...else.endif.endif.i.i:
  %.929.sroa.0.3.i.i = phi i64 [ %.311.i.i, %B0.endif.endif.endif.endi...else.endif.if.i.i ], [ 0, %B0.endif.else.endif.endif.endif.if.i.i ]
  %.956.i.i = icmp slt i64 %.489.fca.7.load.i, 0
  %.957.i.i = select i1 %.956.i.i, i64 %.311.i.i, i64 0
  %.958.i.i = add i64 %.957.i.i, %.489.fca.7.load.i
  %.961.i.i = icmp slt i64 %.958.i.i, 0
  br i1 %.961.i.i, label %B0.endif.endif.endif.endi...else.endif.endif.if.i.i, label %B0.endif.endif.endif.endi...else.endif.endif.endif.i.i, !prof !6
B0.endif.endif.endif.endi...else.endif.endif.if.i.i:
  br label %B0.endif.endif.endif.endi...else.endif.endif.endif.i.i
B0.endif.endif.endif.endi...else.endif.endif.endif.i.i:
  %.929.sroa.13.1.i.i = phi i64 [ 0, %B0.endif.endif.endif.endi...else.endif.endif.if.i.i ], [ %.958.i.i, %B0.endif.endif.endif.endi...else.endif.endif.i.i ]
  %.966.not.i.i = icmp slt i64 %.958.i.i, %.311.i.i
  br i1 %.966.not.i.i, label %B0.endif.endif.endif.endi...endif.1.i.i, label %B0.endif.endif.endif.endi...else.endif.endif.endif.if.i.i, !prof !7
B0.endif.endif.endif.endi...else.endif.endif.endif.if.i.i:
  br label %B0.endif.endif.endif.endi...endif.1.i.i
B0.endif.endif.endif.endi...endif.1.else.if.i.i:
  br label %B0.endif.endif.endif.endi...endif.1.else.endif.i.i
B0.endif.endif.endif.endi...endif.1.else.endif.i.i:
  %.1100.sroa.0.1.i.i = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.1.else.if.i.i ], [ %.958.i.i, %B0.endif.endif.endif.endi...endif.1.i.i ]
  br i1 %.966.not.i.i, label %B0.endif.endif.endif.endi...endif.1.else.endif.endif.i.i, label %B0.endif.endif.endif.endi...endif.1.else.endif.if.i.i, !prof !7
B0.endif.endif.endif.endi...endif.1.else.endif.if.i.i:
  br label %B0.endif.endif.endif.endi...endif.1.else.endif.endif.i.i
B0.endif.endif.endif.endi...endif.1.else.endif.endif.i.i:
  %.1100.sroa.0.3.i.i = phi i64 [ %.311.i.i, %B0.endif.endif.endif.endi...endif.1.else.endif.if.i.i ], [ %.1100.sroa.0.1.i.i, %B0.endif.endif.endif.endi...endif.1.else.endif.i.i ]
  %.1129.i.i = add i64 %.957.i.i, %.1074.i.i
  %.1132.i.i = icmp slt i64 %.1129.i.i, 0
  %.1137.not.i.i = icmp slt i64 %.1129.i.i, %.311.i.i
  %.1245.i.i = shl nsw i64 %.489.fca.7.load.i, 2
  %.1247.i.i = mul nsw i64 %.302.i.i, %.489.fca.7.load.i
  %.1285.i.i = add i64 %.957.i.i, %.1245.i.i
  %.1288.i.i = icmp slt i64 %.1285.i.i, 0
  br i1 %.1288.i.i, label %B0.endif.endif.endif.endi...endif.1.endif.else.if.i.i, label %B0.endif.endif.endif.endi...endif.1.endif.else.endif.i.i, !prof !6
B0.endif.endif.endif.endi...endif.1.endif.else.if.i.i:
  br label %B0.endif.endif.endif.endi...endif.1.endif.else.endif.i.i
B0.endif.endif.endif.endi...endif.1.endif.else.endif.i.i:
  %.1273.sroa.0.1.i.i = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.1.endif.else.if.i.i ], [ %.1285.i.i, %B0.endif.endif.endif.endi...endif.1.else.endif.endif.i.i ]
  %.1293.not.i.i = icmp slt i64 %.1285.i.i, %.311.i.i
  br i1 %.1293.not.i.i, label %B0.endif.endif.endif.endi...endif.4.i.i, label %B0.endif.endif.endif.endi...if.4.i.i, !prof !7
B0.endif.endif.endif.endi...if.4.i.i:
  br label %B0.endif.endif.endif.endi...endif.4.i.i
B0.endif.endif.endif.endi...endif.4.i.i:
  %.1273.sroa.0.3.i.i = phi i64 [ %.311.i.i, %B0.endif.endif.endif.endi...if.4.i.i ], [ %.1273.sroa.0.1.i.i, %B0.endif.endif.endif.endi...endif.1.endif.else.endif.i.i ]
  %.1300.i.i = icmp slt i64 %.1247.i.i, 0
  %.1301.i.i = select i1 %.1300.i.i, i64 %.311.i.i, i64 0
  %.1302.i.i = add i64 %.1301.i.i, %.1247.i.i
  %.1305.i.i = icmp slt i64 %.1302.i.i, 0
  %.1310.not.i.i = icmp slt i64 %.1302.i.i, %.311.i.i
  br i1 %.1305.i.i, label %B0.endif.endif.endif.endi...if.6.i.i, label %B0.endif.endif.endif.endi...endif.6.i.i, !prof !6
B0.endif.endif.endif.endi...if.6.i.i:
  br label %B0.endif.endif.endif.endi...endif.6.i.i
B0.endif.endif.endif.endi...endif.6.i.i:
  %.1448.sroa.0.1.i.i = phi i64 [ 0, %B0.endif.endif.endif.endi...if.6.i.i ], [ %.1302.i.i, %B0.endif.endif.endif.endi...endif.4.i.i ]
  br i1 %.1310.not.i.i, label %B0.endif.endif.endif.endi...endif.6.endif.i.i, label %B0.endif.endif.endif.endi...endif.6.if.i.i, !prof !7
B0.endif.endif.endif.endi...endif.6.if.i.i:
  br label %B0.endif.endif.endif.endi...endif.6.endif.i.i
B0.endif.endif.endif.endi...endif.6.endif.i.i:
  %.1448.sroa.0.3.i.i = phi i64 [ %.311.i.i, %B0.endif.endif.endif.endi...endif.6.if.i.i ], [ %.1448.sroa.0.1.i.i, %B0.endif.endif.endif.endi...endif.6.i.i ]
  %.1475.i.i = icmp slt i64 %.304.i.i, 0
  %.1476.i.i = select i1 %.1475.i.i, i64 %.311.i.i, i64 0
  %.1477.i.i = add i64 %.1476.i.i, %.304.i.i
  %.1480.i.i = icmp slt i64 %.1477.i.i, 0
  %.1485.not.i.i = icmp slt i64 %.1477.i.i, %.311.i.i
  br i1 %.1480.i.i, label %B0.endif.endif.endif.endi...if.9.i.i, label %B0.endif.endif.endif.endi...endif.9.i.i, !prof !6
B0.endif.endif.endif.endi...endif.8.endif.endif.endif.i.i:
  %.1765.sroa.13.0.i.i = phi i64 [ %.311.i.i, %B0.endif.endif.endif.endi...endif.9.endif.endif.if.i.i ], [ %.1765.sroa.13.1.i.i, %B0.endif.endif.endif.endi...endif.9.endif.endif.i.i ]
  %.1911.i.i = mul nsw i64 %.489.fca.7.load.i, 3
  br i1 %.1132.i.i, label %B0.endif.endif.endif.endi...else.1.if.i.i, label %B0.endif.endif.endif.endi...else.1.endif.i.i, !prof !6
B0.endif.endif.endif.endi...if.9.i.i:
  br label %B0.endif.endif.endif.endi...endif.9.i.i
B0.endif.endif.endif.endi...endif.9.i.i:
  %.1765.sroa.0.1.i.i = phi i64 [ 0, %B0.endif.endif.endif.endi...if.9.i.i ], [ %.1477.i.i, %B0.endif.endif.endif.endi...endif.6.endif.i.i ]
  br i1 %.1485.not.i.i, label %B0.endif.endif.endif.endi...endif.9.endif.i.i, label %B0.endif.endif.endif.endi...endif.9.if.i.i, !prof !7
B0.endif.endif.endif.endi...endif.9.if.i.i:
  br label %B0.endif.endif.endif.endi...endif.9.endif.i.i
B0.endif.endif.endif.endi...endif.9.endif.i.i:
  %.1765.sroa.0.3.i.i = phi i64 [ %.311.i.i, %B0.endif.endif.endif.endi...endif.9.if.i.i ], [ %.1765.sroa.0.1.i.i, %B0.endif.endif.endif.endi...endif.9.i.i ]
  br i1 %.393.i.i, label %B0.endif.endif.endif.endi...endif.9.endif.if.i.i, label %B0.endif.endif.endif.endi...endif.9.endif.endif.i.i, !prof !6
B0.endif.endif.endif.endi...endif.9.endif.if.i.i:
  br label %B0.endif.endif.endif.endi...endif.9.endif.endif.i.i
B0.endif.endif.endif.endi...endif.9.endif.endif.i.i:
  %.1765.sroa.13.1.i.i = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.9.endif.if.i.i ], [ %.390.i.i, %B0.endif.endif.endif.endi...endif.9.endif.i.i ]
  br i1 %.398.not.i.i, label %B0.endif.endif.endif.endi...endif.8.endif.endif.endif.i.i, label %B0.endif.endif.endif.endi...endif.9.endif.endif.if.i.i, !prof !7
B0.endif.endif.endif.endi...endif.9.endif.endif.if.i.i:
  br label %B0.endif.endif.endif.endi...endif.8.endif.endif.endif.i.i
B0.endif.endif.endif.endi...endif.11.i.i:
  %.1937.sroa.13.0.i.i = phi i64 [ %.311.i.i, %B0.endif.endif.endif.endi...if.12.i.i ], [ %.1937.sroa.13.1.i.i, %B0.endif.endif.endif.endi...else.1.endif.endif.endif.i.i ]
  br i1 %.1969.i.i, label %B0.endif.endif.endif.endi...endif.11.else.if.i.i, label %B0.endif.endif.endif.endi...endif.11.else.endif.i.i, !prof !6
B0.endif.endif.endif.endi...else.1.if.i.i:
  br label %B0.endif.endif.endif.endi...else.1.endif.i.i
B0.endif.endif.endif.endi...else.1.endif.i.i:
  %.1937.sroa.0.1.i.i = phi i64 [ 0, %B0.endif.endif.endif.endi...else.1.if.i.i ], [ %.1129.i.i, %B0.endif.endif.endif.endi...endif.8.endif.endif.endif.i.i ]
  br i1 %.1137.not.i.i, label %B0.endif.endif.endif.endi...else.1.endif.endif.i.i, label %B0.endif.endif.endif.endi...else.1.endif.if.i.i, !prof !7
B0.endif.endif.endif.endi...else.1.endif.if.i.i:
  br label %B0.endif.endif.endif.endi...else.1.endif.endif.i.i
B0.endif.endif.endif.endi...else.1.endif.endif.i.i:
  %.1937.sroa.0.3.i.i = phi i64 [ %.311.i.i, %B0.endif.endif.endif.endi...else.1.endif.if.i.i ], [ %.1937.sroa.0.1.i.i, %B0.endif.endif.endif.endi...else.1.endif.i.i ]
  %.1966.i.i = add i64 %.957.i.i, %.1911.i.i
  %.1969.i.i = icmp slt i64 %.1966.i.i, 0
  br i1 %.1969.i.i, label %B0.endif.endif.endif.endi...else.1.endif.endif.if.i.i, label %B0.endif.endif.endif.endi...else.1.endif.endif.endif.i.i, !prof !6
B0.endif.endif.endif.endi...else.1.endif.endif.if.i.i:
  br label %B0.endif.endif.endif.endi...else.1.endif.endif.endif.i.i
B0.endif.endif.endif.endi...else.1.endif.endif.endif.i.i:
  %.1937.sroa.13.1.i.i = phi i64 [ 0, %B0.endif.endif.endif.endi...else.1.endif.endif.if.i.i ], [ %.1966.i.i, %B0.endif.endif.endif.endi...else.1.endif.endif.i.i ]
  %.1974.not.i.i = icmp slt i64 %.1966.i.i, %.311.i.i
  br i1 %.1974.not.i.i, label %B0.endif.endif.endif.endi...endif.11.i.i, label %B0.endif.endif.endif.endi...if.12.i.i, !prof !7
B0.endif.endif.endif.endi...if.12.i.i:
  br label %B0.endif.endif.endif.endi...endif.11.i.i
B0.endif.endif.endif.endi...endif.11.endif.i.i:
  %.2109.sroa.13.0.i.i = phi i64 [ %.311.i.i, %B0.endif.endif.endif.endi...endif.14.if.i.i ], [ %.2109.sroa.13.1.i.i, %B0.endif.endif.endif.endi...endif.14.i.i ]
  %.2302.i.i = icmp slt i64 %.466.i.i, 1
  br i1 %.2302.i.i, label %B0.endif.endif.endif.endi...if.16.i.i, label %B0.endif.endif.endif.endi...endif.16.i.i, !prof !6
B0.endif.endif.endif.endi...endif.11.else.if.i.i:
  br label %B0.endif.endif.endif.endi...endif.11.else.endif.i.i
B0.endif.endif.endif.endi...endif.11.else.endif.i.i:
  %.2109.sroa.0.1.i.i = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.11.else.if.i.i ], [ %.1966.i.i, %B0.endif.endif.endif.endi...endif.11.i.i ]
  br i1 %.1974.not.i.i, label %B0.endif.endif.endif.endi...endif.11.else.endif.endif.i.i, label %B0.endif.endif.endif.endi...endif.11.else.endif.if.i.i, !prof !7
B0.endif.endif.endif.endi...endif.11.else.endif.if.i.i:
  br label %B0.endif.endif.endif.endi...endif.11.else.endif.endif.i.i
B0.endif.endif.endif.endi...endif.11.else.endif.endif.i.i:
  %.2109.sroa.0.3.i.i = phi i64 [ %.311.i.i, %B0.endif.endif.endif.endi...endif.11.else.endif.if.i.i ], [ %.2109.sroa.0.1.i.i, %B0.endif.endif.endif.endi...endif.11.else.endif.i.i ]
  br i1 %.1288.i.i, label %B0.endif.endif.endif.endi...if.14.i.i, label %B0.endif.endif.endif.endi...endif.14.i.i, !prof !6
B0.endif.endif.endif.endi...if.14.i.i:
  br label %B0.endif.endif.endif.endi...endif.14.i.i
B0.endif.endif.endif.endi...endif.14.i.i:
  %.2109.sroa.13.1.i.i = phi i64 [ 0, %B0.endif.endif.endif.endi...if.14.i.i ], [ %.1285.i.i, %B0.endif.endif.endif.endi...endif.11.else.endif.endif.i.i ]
  br i1 %.1293.not.i.i, label %B0.endif.endif.endif.endi...endif.11.endif.i.i, label %B0.endif.endif.endif.endi...endif.14.if.i.i, !prof !7
B0.endif.endif.endif.endi...endif.14.if.i.i:
  br label %B0.endif.endif.endif.endi...endif.11.endif.i.i
B0.endif.endif.endif.endi...if.16.i.i:
  br label %B0.endif.endif.endif.endi...endif.16.i.i
B0.endif.endif.endif.endi...endif.16.i.i:
  %.2282.sroa.0.3.i.i = phi i64 [ %.475.i.i, %B0.endif.endif.endif.endi...if.16.i.i ], [ 0, %B0.endif.endif.endif.endi...endif.11.endif.i.i ]
  %.2309.i.i = icmp slt i64 %.265.i, 0
  %.2310.i.i = select i1 %.2309.i.i, i64 %.475.i.i, i64 0
  %.2311.i.i = add i64 %.2310.i.i, %.265.i
  %.2314.i.i = icmp slt i64 %.2311.i.i, 0
  br i1 %.2314.i.i, label %B0.endif.endif.endif.endi...endif.18.endif.i.i, label %B0.endif.endif.endif.endi...endif.16.endif.thread.i.i, !prof !6
B0.endif.endif.endif.endi...endif.16.endif.thread.i.i:
  %.2319.not1483.i.i = icmp sgt i64 %.466.i.i, %.2311.i.i
  br i1 %.2319.not1483.i.i, label %B0.endif.endif.endif.endi...endif.18.thread.i.i, label %B0.endif.endif.endif.endi...endif.18.if.i.i, !prof !7
B0.endif.endif.endif.endi...endif.18.thread.i.i:
  %.23701490.i.i = sub nsw i64 %.2311.i.i, %.2282.sroa.0.3.i.i
  %.23791491.i.i = tail call i64 @llvm.smax.i64(i64 %.23701490.i.i, i64 0)
  br label %B0.endif.endif.endif.endi...endif.18.endif.i.i
B0.endif.endif.endif.endi...endif.18.if.i.i:
  %.23701475.i.i = sub nsw i64 %.475.i.i, %.2282.sroa.0.3.i.i
  %.23791476.i.i = tail call i64 @llvm.smax.i64(i64 %.23701475.i.i, i64 0)
  br label %B0.endif.endif.endif.endi...endif.18.endif.i.i
B0.endif.endif.endif.endi...endif.18.endif.i.i:
  %.237914791521.i.i = phi i64 [ %.23791476.i.i, %B0.endif.endif.endif.endi...endif.18.if.i.i ], [ %.23791491.i.i, %B0.endif.endif.endif.endi...endif.18.thread.i.i ], [ 0, %B0.endif.endif.endif.endi...endif.16.i.i ]
  %.2453.sroa.0.3.i.i = phi i64 [ %.475.i.i, %B0.endif.endif.endif.endi...endif.18.if.i.i ], [ %.2311.i.i, %B0.endif.endif.endif.endi...endif.18.thread.i.i ], [ 0, %B0.endif.endif.endif.endi...endif.16.i.i ]
  %.242714811519.i.i = shl nsw i64 %.265.i, 1
  %.2482.i.i = add i64 %.2310.i.i, %.242714811519.i.i
  %.2485.i.i = icmp slt i64 %.2482.i.i, 0
  %.2490.not1503.i.i = icmp sgt i64 %.466.i.i, %.2482.i.i
  %.2482.i.i..475.i.i = select i1 %.2490.not1503.i.i, i64 %.2482.i.i, i64 %.475.i.i, !prof !7
  %.2625.sroa.0.3.i.i = select i1 %.2485.i.i, i64 0, i64 %.2482.i.i..475.i.i, !prof !6
  %.259915011556.i.i = mul nsw i64 %.265.i, 3
  %.2654.i.i = add i64 %.2310.i.i, %.259915011556.i.i
  %.2657.i.i = icmp slt i64 %.2654.i.i, 0
  %.2662.not1540.i.i = icmp sgt i64 %.466.i.i, %.2654.i.i
  %.2654.i.i..475.i.i = select i1 %.2662.not1540.i.i, i64 %.2654.i.i, i64 %.475.i.i, !prof !7
  %.2797.sroa.0.3.i.i = select i1 %.2657.i.i, i64 0, i64 %.2654.i.i..475.i.i, !prof !6
  %.277115381590.i.i = shl nsw i64 %.265.i, 2
  %.2826.i.i = add i64 %.2310.i.i, %.277115381590.i.i
  %.2829.i.i = icmp slt i64 %.2826.i.i, 0
  br i1 %.2829.i.i, label %B0.endif.endif.endif.endi...endif.25.i.i, label %B0.endif.endif.endif.endi...endif.23.thread.i.i, !prof !6
B0.endif.endif.endif.endi...endif.23.thread.i.i:
  %.2834.not1575.i.i = icmp sgt i64 %.466.i.i, %.2826.i.i
  br i1 %.2834.not1575.i.i, label %B0.endif.endif.endif.endi...endif.20.endif.else.endif.thread.i.i, label %B0.endif.endif.endif.endi...if.25.i.i, !prof !7
B0.endif.endif.endif.endi...endif.20.endif.else.endif.thread.i.i:
  %.28851582.i.i = sub nsw i64 %.2826.i.i, %.2797.sroa.0.3.i.i
  %.28941583.i.i = tail call i64 @llvm.smax.i64(i64 %.28851582.i.i, i64 0)
  br label %B0.endif.endif.endif.endi...endif.25.i.i
B0.endif.endif.endif.endi...if.25.i.i:
  %.28851569.i.i = sub nsw i64 %.475.i.i, %.2797.sroa.0.3.i.i
  %.28941570.i.i = tail call i64 @llvm.smax.i64(i64 %.28851569.i.i, i64 0)
  br label %B0.endif.endif.endif.endi...endif.25.i.i
B0.endif.endif.endif.endi...endif.25.i.i:
  %.289415721633.i.i = phi i64 [ %.28941570.i.i, %B0.endif.endif.endif.endi...if.25.i.i ], [ %.28941583.i.i, %B0.endif.endif.endif.endi...endif.20.endif.else.endif.thread.i.i ], [ 0, %B0.endif.endif.endif.endi...endif.18.endif.i.i ]
  %.2969.sroa.0.3.i.i = phi i64 [ %.475.i.i, %B0.endif.endif.endif.endi...if.25.i.i ], [ %.2826.i.i, %B0.endif.endif.endif.endi...endif.20.endif.else.endif.thread.i.i ], [ 0, %B0.endif.endif.endif.endi...endif.18.endif.i.i ]
  %.2998.i.i = add i64 %.2310.i.i, %.307.i.i
  %.3001.i.i = icmp slt i64 %.2998.i.i, 0
  br i1 %.3001.i.i, label %B0.endif.endif.endif.endi...else.3.endif.endif.i.i, label %B0.endif.endif.endif.endi...endif.25.endif.thread.i.i, !prof !6
B0.endif.endif.endif.endi...endif.25.endif.thread.i.i:
  %.3006.not1615.i.i = icmp sgt i64 %.466.i.i, %.2998.i.i
  br i1 %.3006.not1615.i.i, label %B0.endif.endif.endif.endi...else.3.endif.thread.i.i, label %B0.endif.endif.endif.endi...else.3.endif.if.i.i, !prof !7
B0.endif.endif.endif.endi...else.3.endif.thread.i.i:
  %.30571622.i.i = sub nsw i64 %.2998.i.i, %.2969.sroa.0.3.i.i
  %.30661623.i.i = tail call i64 @llvm.smax.i64(i64 %.30571622.i.i, i64 0)
  br label %B0.endif.endif.endif.endi...else.3.endif.endif.i.i
B0.endif.endif.endif.endi...else.3.endif.if.i.i:
  %.30571603.i.i = sub nsw i64 %.475.i.i, %.2969.sroa.0.3.i.i
  %.30661604.i.i = tail call i64 @llvm.smax.i64(i64 %.30571603.i.i, i64 0)
  br label %B0.endif.endif.endif.endi...else.3.endif.endif.i.i
B0.endif.endif.endif.endi...else.3.endif.endif.i.i:
  %.306616091669.i.i = phi i64 [ %.30661604.i.i, %B0.endif.endif.endif.endi...else.3.endif.if.i.i ], [ %.30661623.i.i, %B0.endif.endif.endif.endi...else.3.endif.thread.i.i ], [ 0, %B0.endif.endif.endif.endi...endif.25.i.i ]
  %.3191.sroa.0.3.i.i = phi i64 [ %.475.i.i, %B0.endif.endif.endif.endi...else.3.endif.if.i.i ], [ %.2998.i.i, %B0.endif.endif.endif.endi...else.3.endif.thread.i.i ], [ 0, %B0.endif.endif.endif.endi...endif.25.i.i ]
  %.3218.i.i = icmp slt i64 %.308.i.i, 0
  %.3219.i.i = select i1 %.3218.i.i, i64 %.475.i.i, i64 0
  %.3220.i.i = add i64 %.3219.i.i, %.308.i.i
  %.3223.i.i = icmp slt i64 %.3220.i.i, 0
  %.3228.not1648.i.i = icmp sgt i64 %.466.i.i, %.3220.i.i
  %.3220.i.i..475.i.i = select i1 %.3228.not1648.i.i, i64 %.3220.i.i, i64 %.475.i.i, !prof !7
  %.3402.sroa.0.3.i.i = select i1 %.3223.i.i, i64 0, i64 %.3220.i.i..475.i.i, !prof !6
  %.1444.i = mul nsw i64 %.489.fca.9.load.i, %.489.fca.9.load.i
  %.1443.i = inttoptr i64 %.489.fca.37.load.i to ptr
  %.1394.i = inttoptr i64 %.489.fca.36.load.i to ptr
  %.16.i1594.i = shl i64 %.1345.i, 3
  %.1344.i = inttoptr i64 %.489.fca.35.load.i to ptr
  %.1295.i = inttoptr i64 %.489.fca.34.load.i to ptr
  %.1252.i = inttoptr i64 %.489.fca.33.load.i to ptr
  %.1211.i = inttoptr i64 %.489.fca.32.load.i to ptr
  %.1170.i = inttoptr i64 %.489.fca.31.load.i to ptr
  %.1129.i = inttoptr i64 %.489.fca.30.load.i to ptr
  %.1088.i = inttoptr i64 %.489.fca.29.load.i to ptr
  %.1047.i = inttoptr i64 %.489.fca.28.load.i to ptr
  %.1006.i = inttoptr i64 %.489.fca.27.load.i to ptr
  %.965.i = inttoptr i64 %.489.fca.26.load.i to ptr
  %.924.i = inttoptr i64 %.489.fca.25.load.i to ptr
  %.883.i = inttoptr i64 %.489.fca.24.load.i to ptr
  %.842.i = inttoptr i64 %.489.fca.23.load.i to ptr
  %.801.i = inttoptr i64 %.489.fca.22.load.i to ptr
  %.752.i = inttoptr i64 %.489.fca.21.load.i to ptr
  %.711.i = inttoptr i64 %.489.fca.20.load.i to ptr
  %.670.i = inttoptr i64 %.489.fca.19.load.i to ptr
  %.629.i = inttoptr i64 %.489.fca.18.load.i to ptr
  %.580.i = inttoptr i64 %.489.fca.17.load.i to ptr
  %.539.i = inttoptr i64 %.489.fca.16.load.i to ptr
  %.497.i = inttoptr i64 %.489.fca.15.load.i to ptr
  %.456.i = inttoptr i64 %.489.fca.14.load.i to ptr
  %.406.i4172 = inttoptr i64 %.489.fca.13.load.i to ptr
  %.16.i.i4174 = shl i64 %.265.i, 3
  %.357.i = inttoptr i64 %.489.fca.12.load.i to ptr
  %.316.i = inttoptr i64 %.489.fca.11.load.i to ptr
  %.271.i = inttoptr i64 %.489.fca.10.load.i to ptr
  %.271.i.i = mul nsw i64 %.481.fca.5.load.i, 24
  %.272.i.i = mul nsw i64 %.271.i.i, %.481.fca.5.load.i
  %.273.i.i = add nsw i64 %.272.i.i, %.489.fca.38.load.i
  %.275.i.i = mul nsw i64 %.271.i.i, %.489.fca.4.load.i
  %.276.i.i = add nsw i64 %.273.i.i, %.275.i.i
  %.277.i.i = shl nsw i64 %.481.fca.5.load.i, 3
  %.278.i.i = mul nsw i64 %.277.i.i, %.264.i
  %.279.i.i = add nsw i64 %.276.i.i, %.278.i.i
  %.282.i.i = add nsw i64 %.308621912209.i, %.265.i
  %.283.i.i = mul nsw i64 %.282.i.i, %.271.i.i
  %.284.i.i = add nsw i64 %.279.i.i, %.283.i.i
  %.286.i.i = mul nsw i64 %.277.i.i, %.265.i
  %.287.i.i = add nsw i64 %.284.i.i, %.286.i.i
  %.289.i.i = mul nsw i64 %.16.i.i4174, %.265.i
  %.290.i.i = add nsw i64 %.287.i.i, %.289.i.i
  %.291.i.i = shl nsw i64 %.489.fca.7.load.i, 3
  %.292.i.i = mul nsw i64 %.265.i, %.291.i.i
  %.293.i.i = add nsw i64 %.290.i.i, %.292.i.i
  %.296.i.i = add nsw i64 %.293.i.i, %.292.i.i
  %.298.i.i = mul nsw i64 %.277.i.i, %.1345.i
  %.299.i.i = add nsw i64 %.296.i.i, %.298.i.i
  %.300.i.i = mul nsw i64 %.481.fca.7.load.i, 56
  %.301.i.i = add nsw i64 %.299.i.i, %.300.i.i
  %.306.i.i = inttoptr i64 %.301.i.i to ptr
  %.491.i.i = getelementptr double, ptr %.306.i.i, i64 %.378.sroa.0.3.i.i
  %.330416461687.i.i = getelementptr double, ptr %.491.i.i, i64 %.3191.sroa.0.3.i.i
  %.311416111667.i.i = inttoptr i64 %.299.i.i to ptr
  %.308216101668.i.i = getelementptr double, ptr %.491.i.i, i64 %.2969.sroa.0.3.i.i
  %.291015731632.i.i = getelementptr double, ptr %.491.i.i, i64 %.2797.sroa.0.3.i.i
  %.273815371591.i.i = getelementptr double, ptr %.491.i.i, i64 %.2625.sroa.0.3.i.i
  %.256615001557.i.i = getelementptr double, ptr %.491.i.i, i64 %.2453.sroa.0.3.i.i
  %.239514801520.i.i = getelementptr double, ptr %.491.i.i, i64 %.2282.sroa.0.3.i.i
  %.2222.i.i = getelementptr double, ptr %.306.i.i, i64 %.2109.sroa.0.3.i.i
  %.2197.i.i = sub i64 %.2109.sroa.13.0.i.i, %.2109.sroa.0.3.i.i
  %.2206.i.i = tail call i64 @llvm.smax.i64(i64 %.2197.i.i, i64 0)
  %.2050.i.i = getelementptr double, ptr %.306.i.i, i64 %.1937.sroa.0.3.i.i
  %.2025.i.i = sub i64 %.1937.sroa.13.0.i.i, %.1937.sroa.0.3.i.i
  %.2034.i.i = tail call i64 @llvm.smax.i64(i64 %.2025.i.i, i64 0)
  %.1878.i.i = getelementptr double, ptr %.306.i.i, i64 %.1765.sroa.0.3.i.i
  %.1853.i.i = sub i64 %.1765.sroa.13.0.i.i, %.1765.sroa.0.3.i.i
  %.1862.i.i = tail call i64 @llvm.smax.i64(i64 %.1853.i.i, i64 0)
  %.1689.i.i = inttoptr i64 %.296.i.i to ptr
  %.1641.i.i = inttoptr i64 %.293.i.i to ptr
  %.1593.i.i = inttoptr i64 %.290.i.i to ptr
  %.1561.i.i = getelementptr double, ptr %.306.i.i, i64 %.1448.sroa.0.3.i.i
  %.1386.i.i = getelementptr double, ptr %.306.i.i, i64 %.1273.sroa.0.3.i.i
  %.1213.i.i = getelementptr double, ptr %.306.i.i, i64 %.1100.sroa.0.3.i.i
  %.1042.i.i = getelementptr double, ptr %.306.i.i, i64 %.929.sroa.0.3.i.i
  %.1017.i.i = sub i64 %.929.sroa.13.0.i.i, %.929.sroa.0.3.i.i
  %.1026.i.i = tail call i64 @llvm.smax.i64(i64 %.1017.i.i, i64 0)
  %.856.i.i = inttoptr i64 %.287.i.i to ptr
  %.808.i.i = inttoptr i64 %.284.i.i to ptr
  %.755.i.i = mul nsw i64 %.282.i.i, %.277.i.i
  %.756.i.i = add nsw i64 %.279.i.i, %.755.i.i
  %.757.i.i = inttoptr i64 %.756.i.i to ptr
  %.702.i.i = inttoptr i64 %.279.i.i to ptr
  %.661.i.i = inttoptr i64 %.276.i.i to ptr
  %.613.i.i = mul nsw i64 %.481.fca.5.load.i, %.489.fca.4.load.i
  %.612.i.i = inttoptr i64 %.273.i.i to ptr
  %.564.i.i = mul nsw i64 %.481.fca.5.load.i, %.481.fca.5.load.i
  %.563.i.i = inttoptr i64 %.489.fca.38.load.i to ptr
  %.3490.i.i = sub nsw i64 %.475.i.i, %.3402.sroa.0.3.i.i
  %.3499.i.i = tail call i64 @llvm.smax.i64(i64 %.3490.i.i, i64 0)
  %.3515.i.i = getelementptr double, ptr %.491.i.i, i64 %.3402.sroa.0.3.i.i
  %.2238 = inttoptr i64 %.481.fca.14.load.i to ptr
  %.2338 = and i64 %.489.fca.0.load.i, 1
  %.2339.not = icmp eq i64 %.2338, 0
  br i1 %.2339.not, label %B576, label %B518
B518:
  call void @llvm.lifetime.start.p0(ptr nonnull %.3013.i)
  call void @llvm.lifetime.start.p0(ptr nonnull %.3352.i)
  call void @llvm.lifetime.start.p0(ptr nonnull %.3808.i)
  %.fca.1.gep.i4185 = getelementptr inbounds i8, ptr %.3808.i, i64 8
  %.1677.i = load double, ptr %.271.i, align 8, !noalias !8
  %.1713.i = getelementptr i8, ptr %.271.i, i64 8
  %.1714.i = load double, ptr %.1713.i, align 8, !noalias !8
  %.1767.i = fcmp ult double %.1714.i, 0.000000e+00
  br i1 %.1767.i, label %B554.thread4213, label %B154.i
B154.i:
  %.1771.i = fadd double %.1677.i, %.1714.i
  %.1779.le.i = fsub double %.1771.i, %.1771.i
  %.1780.le.i = fcmp ord double %.1779.le.i, 0.000000e+00
  br i1 %.1780.le.i, label %B214.i, label %B554.thread4213
B214.i:
  %.2374.i = getelementptr i8, ptr %.1354.i, i64 8
  %.2375.i = load double, ptr %.2374.i, align 8, !noalias !8
  %.2426.i = icmp sgt i64 %.481.fca.5.load.i, 0
  br i1 %.2426.i, label %B304.if.lr.ph.i, label %B428.i
B304.if.lr.ph.i:
  %.266710539.not.i = icmp slt i64 %.265.i, 1
  br label %B304.if.i
B304.loopexit.i:
  %exitcond10562.not.i = icmp eq i64 %.481.fca.5.load.i, %.2483.i
  br i1 %exitcond10562.not.i, label %B428.i, label %B304.if.i
B428.i:
  %.288910545.not.i = icmp slt i64 %.4351.i, 1
  br i1 %.288910545.not.i, label %B506.i, label %B468.if.i
B506.i:
  call fastcc void @v62(ptr %.3013.i, ptr %.406.i4172, i64 %.481.fca.7.load.i, i64 %.489.fca.5.load.i, ptr readonly %.456.i, ptr readonly %.497.i, i64 %.264.i, ptr readonly %.539.i, ptr readonly %.580.i, i64 %.489.fca.4.load.i, i64 %.489.fca.4.load.i, ptr readonly %.629.i, ptr %.161.i, i64 %.163.i, i64 %.481.fca.5.load.i, ptr %.316.i, i64 %.265.i)
  %.3299.i = getelementptr i8, ptr %.206.i, i64 24
  %.3300.i = load double, ptr %.3299.i, align 8, !noalias !8
  %.3301.i = fcmp ogt double %.3300.i, 0.000000e+00
  br i1 %.3301.i, label %B574.i, label %B668.i
B574.i:
  call fastcc void @v63(ptr %.3352.i, ptr %.249.i, i64 %.481.fca.6.load.i, ptr readonly %.4485.i, ptr readonly %.2238, i64 %.481.fca.6.load.i, double %.3300.i, ptr %.4926.i)
  store double 0.000000e+00, ptr %.3299.i, align 8, !noalias !8
  br label %B668.i
B668.i:
  %h.4.0.i = phi double [ 0.000000e+00, %B574.i ], [ %.2375.i, %B506.i ]
  %.3558.i = fcmp ogt double %.1771.i, %.1677.i
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %.5090.i, i8 0, i64 16, i1 false), !noalias !8
  br i1 %.3558.i, label %B740.i, label %B974.i
B740.i:
  %.3567.i4186 = fsub double %.1771.i, %.1677.i
  %.12414322.not.i.i = icmp slt i64 %.489.fca.6.load.i, 1
  br i1 %.12414322.not.i.i, label %B168.i.i, label %B72.if.i.i
B168.i.i:
  %.15594325.not.i.i = icmp slt i64 %.3490.i.i, 1
  br i1 %.15594325.not.i.i, label %b91, label %B218.if.lr.ph.i.i
B218.if.lr.ph.i.i:
  %3 = getelementptr double, ptr %.406.i4172, i64 %.481.fca.7.load.i
  br label %B218.if.i.i
B226.i.i:
  %4 = getelementptr double, ptr %.3515.i.i, i64 %.1503.04326.i.i
  %.1708.i.i = load double, ptr %4, align 8, !noalias !11
  %.1712.i.i = fcmp une double %.1781.pre.i.i, %.1708.i.i
  %5 = freeze i1 %.1712.i.i
  br label %B284.i.i
B284.i.i:
  %"$phi284.1.2.1.i.i" = phi i1 [ %5, %B226.i.i ], [ true, %B218.if.i.i ]
  %.1846.i.i.idx = mul i64 %.1503.04326.i.i, 56
  %.1846.i.i = getelementptr i8, ptr %.311416111667.i.i, i64 %.1846.i.i.idx
  store double %.1781.pre.i.i, ptr %.1846.i.i, align 8, !noalias !11
  %.1913.i.i = getelementptr i8, ptr %.1846.i.i, i64 48
  store double %.1677.i, ptr %.1913.i.i, align 8, !noalias !11
  %.1979.i.i = getelementptr double, ptr %3, i64 %.1503.04326.i.i
  %.1980.i.i = load double, ptr %.1979.i.i, align 8, !noalias !11
  %.2046.i.i = load double, ptr %.1780.phi.trans.insert.i.i, align 8, !noalias !11
  %.2052.i.i = fsub double %.1980.i.i, %.2046.i.i
  %.2057.i.i = fdiv double %.2052.i.i, %.3567.i4186
  %.2117.i.i = getelementptr i8, ptr %.1846.i.i, i64 8
  store double %.2057.i.i, ptr %.2117.i.i, align 8, !noalias !11
  %.2184.i.i = load double, ptr %.1979.i.i, align 8, !noalias !11
  %6 = getelementptr double, ptr %.3515.i.i, i64 %.1503.04326.i.i
  store double %.2184.i.i, ptr %6, align 8, !noalias !11
  %exitcond4329.not.i.i = icmp eq i64 %.3490.i.i, %.1572.i.i
  br i1 %exitcond4329.not.i.i, label %b92, label %B218.if.i.i
B72.if.i.i:
  %.1183.04323.i.i = phi i64 [ %.1254.i.i, %B72.if.i.i ], [ 0, %B740.i ]
  %.1254.i.i = add nuw nsw i64 %.1183.04323.i.i, 1
  %7 = getelementptr i64, ptr %.497.i, i64 %.1183.04323.i.i
  %.1319.i.i = load i64, ptr %7, align 8, !noalias !11
  %.1351.i.i = icmp slt i64 %.1319.i.i, 0
  %.1352.i.i = select i1 %.1351.i.i, i64 %.481.fca.7.load.i, i64 0
  %8 = getelementptr double, ptr %.406.i4172, i64 %.1319.i.i
  %.1374.i.i = getelementptr double, ptr %8, i64 %.1352.i.i
  %.1375.i.i = load double, ptr %.1374.i.i, align 8, !noalias !11
  %.1436.i.i = select i1 %.1351.i.i, i64 %.3499.i.i, i64 0
  %9 = getelementptr double, ptr %.3515.i.i, i64 %.1319.i.i
  %.1450.i.i = getelementptr double, ptr %9, i64 %.1436.i.i
  store double %.1375.i.i, ptr %.1450.i.i, align 8, !noalias !11
  %exitcond.not.i.i = icmp eq i64 %.489.fca.6.load.i, %.1254.i.i
  br i1 %exitcond.not.i.i, label %B168.i.i, label %B72.if.i.i
B218.if.i.i:
  %jumps.2.04328.i.i = phi i1 [ false, %B218.if.lr.ph.i.i ], [ %"$phi284.1.2.1.i.i", %B284.i.i ]
  %.1503.04326.i.i = phi i64 [ 0, %B218.if.lr.ph.i.i ], [ %.1572.i.i, %B284.i.i ]
  %.1572.i.i = add nuw nsw i64 %.1503.04326.i.i, 1
  %.1780.phi.trans.insert.i.i = getelementptr double, ptr %.406.i4172, i64 %.1503.04326.i.i
  %.1781.pre.i.i = load double, ptr %.1780.phi.trans.insert.i.i, align 8, !noalias !11
  br i1 %jumps.2.04328.i.i, label %B284.i.i, label %B226.i.i
b92:
  %.3747.i = fneg double %h.4.0.i
  br i1 %"$phi284.1.2.1.i.i", label %10, label %b91
b91:
  br label %10
10:
  %11 = phi double [ %h.4.0.i, %b91 ], [ %.3747.i, %b92 ]
  br i1 %.2426.i, label %B922.i, label %B890.i
B890.i:
  call void @llvm.lifetime.start.p0(ptr nonnull %.471.i.i), !noalias !8
  call void @llvm.lifetime.start.p0(ptr nonnull %.515.i.i), !noalias !8
  call void @llvm.lifetime.start.p0(ptr nonnull %.661.i.i4184), !noalias !8
  call fastcc void @v64(ptr %.471.i.i, double %.1771.i)
  %.485.i.i = load double, ptr %.471.i.i, align 8, !noalias !14
  %.497.i.i = fsub double %.1771.i, %.485.i.i
  %.505.i.i = fcmp olt double %.1677.i, %.497.i.i
  br i1 %.505.i.i, label %B96.i.i, label %B974.thread10526.i
B96.i.i:
  %t.2.0.i.i = phi double [ %.685.i.i, %B96.i.i ], [ %.1677.i, %B890.i ]
  call fastcc void @v65(ptr %.515.i.i, i64 %.481.fca.4.load.i, ptr %.161.i, i64 %.4360.i, ptr %.4376.i, ptr readonly %.4409.i, i64 %.251121222161.i, ptr %.252721232160.i, ptr %.269821422175.i, i64 %.82419612000.i, ptr %.84019621999.i, ptr %.1354.i, ptr readonly %.311416111667.i.i, i64 7, double %t.2.0.i.i, ptr %.4926.i)
  store double 0.000000e+00, ptr %.661.i.i4184, align 8, !noalias !14
  call fastcc void @v66(ptr %.661.i.i4184, ptr %.4376.i, i64 %.251121222161.i)
  %.685.i.i = load double, ptr %.661.i.i4184, align 8, !noalias !14
  %.713.i.i = fcmp olt double %.685.i.i, %.497.i.i
  br i1 %.713.i.i, label %B96.i.i, label %B974.thread10526.i
B974.thread10526.i:
  call void @llvm.lifetime.end.p0(ptr nonnull %.471.i.i), !noalias !8
  call void @llvm.lifetime.end.p0(ptr nonnull %.515.i.i), !noalias !8
  call void @llvm.lifetime.end.p0(ptr nonnull %.661.i.i4184), !noalias !8
  store double %11, ptr %.2374.i, align 8, !noalias !8
  br label %B364.preheader.B676_crit_edge.i.i
B922.i:
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %.3808.i, i8 0, i64 16, i1 false), !noalias !8
  call fastcc void @v67(ptr %.3808.i, i64 %.489.fca.1.load.i, i64 %.265.i, i64 %.264.i, ptr readonly %.580.i, i64 %.489.fca.4.load.i, i64 %.489.fca.4.load.i, ptr %.1295.i, i64 %.265.i, ptr %.563.i.i, i64 %.564.i.i, ptr %.612.i.i, i64 %.613.i.i, ptr %.661.i.i, ptr %.702.i.i, i64 %.481.fca.5.load.i, i64 %.282.i.i, ptr %.757.i.i, i64 %.308621912209.i, i64 %.282.i.i, i64 %.481.fca.0.load.i, i64 %.481.fca.1.load.i, i64 %.481.fca.2.load.i, i64 %.481.fca.4.load.i, ptr %.161.i, i64 %.4360.i, ptr %.4376.i, ptr readonly %.4409.i, i64 %.251121222161.i, ptr %.252721232160.i, ptr %.269821422175.i, ptr %.249.i, i64 %.481.fca.6.load.i, ptr readonly %.4485.i, double %.4553.i, double %.4582.i, i64 %.82419612000.i, ptr %.84019621999.i, ptr %.101119812031.i, i64 %.99519802032.i, i64 %.116720142045.i, ptr %.118320152044.i, ptr %.1354.i, ptr %.305421902210.i, ptr %.181920692085.i, ptr %.3225.i, ptr %.217720922108.i, ptr %.3396.i, ptr readonly %.3567.i, ptr %.3739.i, ptr %.3911.i, i64 %.4067.i, ptr %.4083.i, i64 %.481.fca.5.load.i, ptr %.4926.i, ptr nonnull %.5090.i, double %.1677.i, double %.1771.i, ptr %.311416111667.i.i, i64 %.481.fca.7.load.i, i64 7, double %11)
  %.4055.fca.1.load.i = load double, ptr %.fca.1.gep.i4185, align 8, !noalias !8
  %.4055.fca.0.load.i = load i64, ptr %.3808.i, align 8, !noalias !8
  store double %.4055.fca.1.load.i, ptr %.2374.i, align 8, !noalias !8
  %.4375.i = icmp eq i64 %.4055.fca.0.load.i, 0
  br i1 %.4375.i, label %B76.if.lr.ph.i.i, label %B1298.i
B974.i:
  store double %h.4.0.i, ptr %.2374.i, align 8, !noalias !8
  br i1 %.2426.i, label %B76.if.lr.ph.i.i, label %B364.preheader.B676_crit_edge.i.i
B76.if.lr.ph.i.i:
  %.13665537.not.i.i = icmp slt i64 %.265.i, 1
  br label %B76.if.i.i
B76.loopexit.i.i:
  %exitcond5597.not.i.i = icmp eq i64 %.481.fca.5.load.i, %.1258.i.i
  br i1 %exitcond5597.not.i.i, label %B364.preheader.i.i, label %B76.if.i.i
B364.preheader.i.i:
  %spec.select.i.i = tail call i64 @llvm.smax.i64(i64 %.489.fca.4.load.i, i64 0)
  %.27225559.not.i.i = icmp slt i64 %.489.fca.4.load.i, 1
  br label %B364.if.i.i
B364.preheader.B676_crit_edge.i.i:
  %.pre5605.i.i = tail call i64 @llvm.smax.i64(i64 %.489.fca.4.load.i, i64 0)
  br label %B676.i.i
B330.i.i:
  %exitcond5596.not.i.i = icmp eq i64 %.265.i, %.1568.i.i
  br i1 %exitcond5596.not.i.i, label %B76.loopexit.i.i, label %B170.if.i.i
B364.loopexit.i.i:
  %exitcond5600.not.i.i = icmp eq i64 %.481.fca.5.load.i, %.2083.i.i
  br i1 %exitcond5600.not.i.i, label %B676.i.i, label %B364.if.i.i
B512.i.i:
  %value.2.2.lcssa.i.i = phi double [ 0.000000e+00, %B400.if.i.i ], [ %.2488.i.i, %B438.if.i.i ]
  %.2532.i.i = icmp slt i64 %.2136.05554.i.i, 0
  %.2533.i.i = select i1 %.2532.i.i, i64 %.265.i, i64 0
  %12 = getelementptr double, ptr %24, i64 %.2136.05554.i.i
  %.2555.i.i = getelementptr double, ptr %12, i64 %.2533.i.i
  store double %value.2.2.lcssa.i.i, ptr %.2555.i.i, align 8, !noalias !17
  %.2601.i.i = add i64 %.2533.i.i, %.2136.05554.i.i
  %.2621.i.i = mul i64 %.2601.i.i, %.265.i
  %gep5557.i.i = getelementptr double, ptr %invariant.gep.i.i, i64 %.2621.i.i
  store double %value.2.2.lcssa.i.i, ptr %gep5557.i.i, align 8, !noalias !17
  %exitcond5599.not.i.i = icmp eq i64 %.2205.i.i, %.481.fca.5.load.i
  br i1 %exitcond5599.not.i.i, label %B562.i.i, label %B400.if.i.i
B562.i.i:
  br i1 %.27225559.not.i.i, label %B364.loopexit.i.i, label %B594.if.lr.ph.i.i
B594.if.lr.ph.i.i:
  %invariant.gep5558.i.i = getelementptr double, ptr %.856.i.i, i64 %.2014.05565.i.i
  %.2813.i.i = mul i64 %.2014.05565.i.i, %.265.i
  %13 = getelementptr double, ptr %.808.i.i, i64 %.2813.i.i
  %14 = getelementptr double, ptr %.856.i.i, i64 %.2813.i.i
  br label %B594.if.i.i
B676.i.i:
  %storemerge5521.pre-phi.i.i = phi i64 [ %.pre5605.i.i, %B364.preheader.B676_crit_edge.i.i ], [ %spec.select.i.i, %B364.loopexit.i.i ]
  %.30515570.not.i.i = icmp slt i64 %.489.fca.4.load.i, 1
  br i1 %.30515570.not.i.i, label %B802.i.i, label %B744.if.lr.ph.i.i
B708.loopexit.i.i:
  %.3060.i.i = add nsw i64 %.2998.05572.i.i, -1
  %.3064.i.i = add i64 %.2995.05571.i.i, 1
  %.3051.i.i = icmp sgt i64 %.2998.05572.i.i, 1
  br i1 %.3051.i.i, label %B744.if.lr.ph.i.i, label %B802.i.i
B802.i.i:
  %.34375578.not.i.i = icmp slt i64 %.265.i, 1
  br i1 %.34375578.not.i.i, label %B1044.i, label %B832.if.i.i
B1078.if.preheader.i.i:
  %.3742.i.i = fdiv double %.3693.i.i, %.3587.i.i
  %.3752.le.i.i = tail call double @llvm.sqrt.f64(double %.3742.i.i)
  %invariant.gep5574.i.i = getelementptr double, ptr %.856.i.i, i64 %.3381.05579.i.i
  br label %B1078.if.i.i
B1176.i.i:
  %exitcond5602.not.i.i = icmp eq i64 %.265.i, %.3450.i.i
  br i1 %exitcond5602.not.i.i, label %B1242.if.lr.ph.i.i, label %B832.if.i.i
B1208.loopexit.i.i:
  %.4422.i.i = add nuw nsw i64 %.4353.05590.i.i, 1
  %exitcond5604.not.i.i = icmp eq i64 %.265.i, %.4422.i.i
  br i1 %exitcond5604.not.i.i, label %b93, label %B1242.if.lr.ph.i.i
B1250.i.i:
  %15 = getelementptr double, ptr %38, i64 %.4480.05583.i.i
  %.4646.i.i = load double, ptr %15, align 8, !noalias !17
  %.4646.i.fr.i = freeze double %.4646.i.i
  %.4661.le.i.i = fsub double %.4646.i.fr.i, %.4646.i.fr.i
  %.4662.le.i.i = fcmp ord double %.4661.le.i.i, 0.000000e+00
  br label %B1314.i.i
B1314.i.i:
  %"$phi1314.2.2.2.i.i" = phi i1 [ false, %B1242.if.i.i ], [ %.4662.le.i.i, %B1250.i.i ]
  %exitcond5603.not.i.i = icmp eq i64 %.265.i, %.4549.i.i
  br i1 %exitcond5603.not.i.i, label %B1208.loopexit.i.i, label %B1242.if.i.i
B76.if.i.i:
  %.1187.05547.i.i = phi i64 [ 0, %B76.if.lr.ph.i.i ], [ %.1258.i.i, %B76.loopexit.i.i ]
  %.1258.i.i = add nuw nsw i64 %.1187.05547.i.i, 1
  br i1 %.13665537.not.i.i, label %B76.loopexit.i.i, label %B110.if.lr.ph.i.i
B110.if.lr.ph.i.i:
  %16 = mul i64 %.1187.05547.i.i, %.16.i.i4174
  %scevgep.i = getelementptr i8, ptr %.808.i.i, i64 %16
  tail call void @llvm.memset.p0.i64(ptr align 8 %scevgep.i, i8 0, i64 %.16.i.i4174, i1 false), !noalias !17
  %.1457.i.i = mul i64 %.1187.05547.i.i, %.265.i
  %17 = getelementptr double, ptr %.808.i.i, i64 %.1457.i.i
  %18 = getelementptr double, ptr %.1295.i, i64 %.1457.i.i
  br label %B170.if.i.i
B170.if.i.i:
  %.1499.05544.i.i = phi i64 [ 0, %B110.if.lr.ph.i.i ], [ %.1568.i.i, %B330.i.i ]
  %.1568.i.i = add nuw nsw i64 %.1499.05544.i.i, 1
  %19 = getelementptr double, ptr %18, i64 %.1499.05544.i.i
  %.1655.i.i = load double, ptr %19, align 8, !noalias !17
  %.1667.i.i = fcmp une double %.1655.i.i, 0.000000e+00
  br i1 %.1667.i.i, label %B246.if.lr.ph.i.i, label %B330.i.i
B246.if.lr.ph.i.i:
  %.1899.i.i = mul i64 %.1499.05544.i.i, %.265.i
  %20 = getelementptr double, ptr %.357.i, i64 %.1899.i.i
  br label %B246.if.i.i
B246.if.i.i:
  %.1693.05541.i.i = phi i64 [ 0, %B246.if.lr.ph.i.i ], [ %.1762.i.i, %B246.if.i.i ]
  %.1762.i.i = add nuw nsw i64 %.1693.05541.i.i, 1
  %21 = getelementptr double, ptr %17, i64 %.1693.05541.i.i
  %.1845.i.i = load double, ptr %21, align 8, !noalias !17
  %22 = getelementptr double, ptr %20, i64 %.1693.05541.i.i
  %.1904.i.i = load double, ptr %22, align 8, !noalias !17
  %.1913.i10515.i = fmul double %.1655.i.i, %.1904.i.i
  %.1914.i.i = fadd double %.1845.i.i, %.1913.i10515.i
  store double %.1914.i.i, ptr %21, align 8, !noalias !17
  %exitcond5595.not.i.i = icmp eq i64 %.265.i, %.1762.i.i
  br i1 %exitcond5595.not.i.i, label %B330.i.i, label %B246.if.i.i
B364.if.i.i:
  %.2014.05565.i.i = phi i64 [ 0, %B364.preheader.i.i ], [ %.2083.i.i, %B364.loopexit.i.i ]
  %.2083.i.i = add nuw nsw i64 %.2014.05565.i.i, 1
  %.21925553.not.not.i.i = icmp sgt i64 %.481.fca.5.load.i, %.2014.05565.i.i
  br i1 %.21925553.not.not.i.i, label %B400.if.lr.ph.i.i, label %B562.i.i
B400.if.lr.ph.i.i:
  %invariant.gep.i.i = getelementptr double, ptr %.856.i.i, i64 %.2014.05565.i.i
  %.2407.i.i = mul i64 %.2014.05565.i.i, %.265.i
  %23 = getelementptr double, ptr %.808.i.i, i64 %.2407.i.i
  %24 = getelementptr double, ptr %.856.i.i, i64 %.2407.i.i
  br label %B400.if.i.i
B400.if.i.i:
  %.2136.05554.i.i = phi i64 [ %.2014.05565.i.i, %B400.if.lr.ph.i.i ], [ %.2205.i.i, %B512.i.i ]
  %.2205.i.i = add nuw i64 %.2136.05554.i.i, 1
  br i1 %.13665537.not.i.i, label %B512.i.i, label %B438.if.lr.ph.i.i
B438.if.lr.ph.i.i:
  %.2451.i.i = icmp slt i64 %.2136.05554.i.i, 0
  %.2452.i.i = select i1 %.2451.i.i, i64 %.481.fca.5.load.i, i64 0
  %.2453.i.i = add i64 %.2452.i.i, %.2136.05554.i.i
  %.2473.i.i = mul i64 %.2453.i.i, %.265.i
  %25 = getelementptr double, ptr %.1295.i, i64 %.2473.i.i
  br label %B438.if.i.i
B438.if.i.i:
  %value.2.25552.i.i = phi double [ 0.000000e+00, %B438.if.lr.ph.i.i ], [ %.2488.i.i, %B438.if.i.i ]
  %.2260.05550.i.i = phi i64 [ 0, %B438.if.lr.ph.i.i ], [ %.2329.i.i, %B438.if.i.i ]
  %.2329.i.i = add nuw nsw i64 %.2260.05550.i.i, 1
  %26 = getelementptr double, ptr %23, i64 %.2260.05550.i.i
  %.2412.i.i = load double, ptr %26, align 8, !noalias !17
  %27 = getelementptr double, ptr %25, i64 %.2260.05550.i.i
  %.2478.i.i = load double, ptr %27, align 8, !noalias !17
  %.2486.i.i = fmul double %.2412.i.i, %.2478.i.i
  %.2488.i.i = fadd double %value.2.25552.i.i, %.2486.i.i
  %exitcond5598.not.i.i = icmp eq i64 %.265.i, %.2329.i.i
  br i1 %exitcond5598.not.i.i, label %B512.i.i, label %B438.if.i.i
B594.if.i.i:
  %.2669.05561.i.i = phi i64 [ %spec.select.i.i, %B594.if.lr.ph.i.i ], [ %.2731.i.i, %B594.if.i.i ]
  %.2666.05560.i.i = phi i64 [ %.481.fca.5.load.i, %B594.if.lr.ph.i.i ], [ %.2735.i.i, %B594.if.i.i ]
  %.2731.i.i = add nsw i64 %.2669.05561.i.i, -1
  %.2735.i.i = add i64 %.2666.05560.i.i, 1
  %.2794.i.i = icmp slt i64 %.2666.05560.i.i, 0
  %.2795.i.i = select i1 %.2794.i.i, i64 %.265.i, i64 0
  %28 = getelementptr double, ptr %13, i64 %.2666.05560.i.i
  %.2817.i.i = getelementptr double, ptr %28, i64 %.2795.i.i
  %.2818.i.i = load double, ptr %.2817.i.i, align 8, !noalias !17
  %29 = getelementptr double, ptr %14, i64 %.2666.05560.i.i
  %.2883.i.i = getelementptr double, ptr %29, i64 %.2795.i.i
  store double %.2818.i.i, ptr %.2883.i.i, align 8, !noalias !17
  %.2925.i.i = add i64 %.2795.i.i, %.2666.05560.i.i
  %.2945.i.i = mul i64 %.2925.i.i, %.265.i
  %gep5563.i.i = getelementptr double, ptr %invariant.gep5558.i.i, i64 %.2945.i.i
  store double %.2818.i.i, ptr %gep5563.i.i, align 8, !noalias !17
  %.2722.i.i = icmp sgt i64 %.2669.05561.i.i, 1
  br i1 %.2722.i.i, label %B594.if.i.i, label %B364.loopexit.i.i
B744.if.lr.ph.i.i:
  %.2998.05572.i.i = phi i64 [ %.3060.i.i, %B708.loopexit.i.i ], [ %storemerge5521.pre-phi.i.i, %B676.i.i ]
  %.2995.05571.i.i = phi i64 [ %.3064.i.i, %B708.loopexit.i.i ], [ %.481.fca.5.load.i, %B676.i.i ]
  %.3242.i.i = icmp slt i64 %.2995.05571.i.i, 0
  %.3243.i.i = select i1 %.3242.i.i, i64 %.265.i, i64 0
  %.3244.i.i = add i64 %.3243.i.i, %.2995.05571.i.i
  %.3264.i.i = mul i64 %.3244.i.i, %.265.i
  %30 = getelementptr double, ptr %.357.i, i64 %.3264.i.i
  %31 = getelementptr double, ptr %.856.i.i, i64 %.3264.i.i
  br label %B744.if.i.i
B744.if.i.i:
  %.3120.05569.i.i = phi i64 [ %storemerge5521.pre-phi.i.i, %B744.if.lr.ph.i.i ], [ %.3182.i.i, %B744.if.i.i ]
  %.3117.05568.i.i = phi i64 [ %.481.fca.5.load.i, %B744.if.lr.ph.i.i ], [ %.3186.i.i, %B744.if.i.i ]
  %.3182.i.i = add nsw i64 %.3120.05569.i.i, -1
  %.3186.i.i = add i64 %.3117.05568.i.i, 1
  %.3245.i.i = icmp slt i64 %.3117.05568.i.i, 0
  %.3246.i.i = select i1 %.3245.i.i, i64 %.265.i, i64 0
  %32 = getelementptr double, ptr %30, i64 %.3117.05568.i.i
  %.3268.i.i = getelementptr double, ptr %32, i64 %.3246.i.i
  %.3269.i.i = load double, ptr %.3268.i.i, align 8, !noalias !17
  %33 = getelementptr double, ptr %31, i64 %.3117.05568.i.i
  %.3334.i.i = getelementptr double, ptr %33, i64 %.3246.i.i
  store double %.3269.i.i, ptr %.3334.i.i, align 8, !noalias !17
  %.3173.i.i = icmp sgt i64 %.3120.05569.i.i, 1
  br i1 %.3173.i.i, label %B744.if.i.i, label %B708.loopexit.i.i
B832.if.i.i:
  %.3381.05579.i.i = phi i64 [ %.3450.i.i, %B1176.i.i ], [ 0, %B802.i.i ]
  %.3450.i.i = add nuw nsw i64 %.3381.05579.i.i, 1
  %.3532.i.i = mul i64 %.3381.05579.i.i, %.265.i
  %34 = getelementptr double, ptr %.856.i.i, i64 %.3532.i.i
  %.3536.i.i = getelementptr double, ptr %34, i64 %.3381.05579.i.i
  %.3537.i.i = load double, ptr %.3536.i.i, align 8, !noalias !17
  %.3546.i.i = fmul double %.3537.i.i, 0x3FF0000000001198
  %35 = getelementptr double, ptr %.924.i, i64 %.3381.05579.i.i
  %.3581.i.i = load double, ptr %35, align 8, !noalias !17
  %.3586.i.i = fmul double %.1714.i, %.3581.i.i
  %.3587.i.i = fadd double %.3546.i.i, %.3586.i.i
  store double %.3587.i.i, ptr %.3536.i.i, align 8, !noalias !17
  %36 = getelementptr double, ptr %.965.i, i64 %.3381.05579.i.i
  %.3693.i.i = load double, ptr %36, align 8, !noalias !17
  %.3698.i.i = fcmp ogt double %.3587.i.i, %.3693.i.i
  br i1 %.3698.i.i, label %B1078.if.preheader.i.i, label %B1176.i.i
B1078.if.i.i:
  %.3784.05576.i.i = phi i64 [ %.3853.i.i, %B1078.if.i.i ], [ 0, %B1078.if.preheader.i.i ]
  %.3853.i.i = add nuw nsw i64 %.3784.05576.i.i, 1
  %37 = getelementptr double, ptr %34, i64 %.3784.05576.i.i
  %.3936.i.i = load double, ptr %37, align 8, !noalias !17
  %.3938.i.i = fmul double %.3752.le.i.i, %.3936.i.i
  store double %.3938.i.i, ptr %37, align 8, !noalias !17
  %.4046.i.i = mul i64 %.3784.05576.i.i, %.265.i
  %gep.i.i = getelementptr double, ptr %invariant.gep5574.i.i, i64 %.4046.i.i
  %.4051.i.i = load double, ptr %gep.i.i, align 8, !noalias !17
  %.4053.i.i = fmul double %.3752.le.i.i, %.4051.i.i
  store double %.4053.i.i, ptr %gep.i.i, align 8, !noalias !17
  %exitcond5601.not.i.i = icmp eq i64 %.265.i, %.3853.i.i
  br i1 %exitcond5601.not.i.i, label %B1176.i.i, label %B1078.if.i.i
B1242.if.lr.ph.i.i:
  %finite.3.05592.i.i = phi i1 [ %"$phi1314.2.2.2.i.i", %B1208.loopexit.i.i ], [ true, %B1176.i.i ]
  %.4353.05590.i.i = phi i64 [ %.4422.i.i, %B1208.loopexit.i.i ], [ 0, %B1176.i.i ]
  %.4641.i.i = mul i64 %.4353.05590.i.i, %.265.i
  %38 = getelementptr double, ptr %.856.i.i, i64 %.4641.i.i
  br label %B1242.if.i.i
B1242.if.i.i:
  %finite.2.15585.i.i = phi i1 [ %finite.3.05592.i.i, %B1242.if.lr.ph.i.i ], [ %"$phi1314.2.2.2.i.i", %B1314.i.i ]
  %.4480.05583.i.i = phi i64 [ 0, %B1242.if.lr.ph.i.i ], [ %.4549.i.i, %B1314.i.i ]
  %.4549.i.i = add nuw nsw i64 %.4480.05583.i.i, 1
  br i1 %finite.2.15585.i.i, label %B1250.i.i, label %B1314.i.i
b93:
  br i1 %"$phi1314.2.2.2.i.i", label %B1044.i, label %B1298.i
B1044.i:
  %.465910551.not.i = icmp slt i64 %.481.fca.5.load.i, 1
  br i1 %.465910551.not.i, label %B1122.i, label %B1074.if.i
B1122.i:
  %.4932.i = icmp sgt i64 %.265.i, 0
  br i1 %.4932.i, label %B1186.if.lr.ph.i, label %B1244.i
B1152.loopexit.i:
  %.4987.i = add nuw nsw i64 %.4918.010558.i, 1
  %exitcond10567.not.i = icmp eq i64 %.265.i, %.4987.i
  br i1 %exitcond10567.not.i, label %B1244.i, label %B1186.if.lr.ph.i
B1244.i:
  br i1 %.2426.i, label %B82.if.lr.ph.i.i, label %B554
B82.if.lr.ph.i.i:
  %.12052066.not.i.i = icmp slt i64 %.1345.i, 1
  br label %B82.if.i.i
B82.loopexit.i.i:
  %exitcond2087.not.i.i = icmp eq i64 %.481.fca.5.load.i, %.1083.i.i
  br i1 %exitcond2087.not.i.i, label %B394.if.i.i, label %B82.if.i.i
B158.i.i:
  br i1 %.4932.i, label %B188.if.lr.ph.i.i, label %B82.loopexit.i.i
B188.if.lr.ph.i.i:
  %.1478.i.i = mul i64 %.1012.02076.i.i, %.265.i
  %39 = getelementptr double, ptr %.1295.i, i64 %.1478.i.i
  %.1676.i.i = mul i64 %.1012.02076.i.i, %.1345.i
  %40 = getelementptr double, ptr %.1689.i.i, i64 %.1676.i.i
  br label %B188.if.i.i
B360.i.i:
  %exitcond2086.not.i.i = icmp eq i64 %.265.i, %.1396.i.i
  br i1 %exitcond2086.not.i.i, label %B82.loopexit.i.i, label %B188.if.i.i
B394.loopexit.i.i:
  %exitcond2089.not.i.i = icmp eq i64 %.481.fca.5.load.i, %.1919.i.i
  br i1 %exitcond2089.not.i.i, label %B554, label %B394.if.i.i
B82.if.i.i:
  %.1012.02076.i.i = phi i64 [ 0, %B82.if.lr.ph.i.i ], [ %.1083.i.i, %B82.loopexit.i.i ]
  %.1083.i.i = add nuw nsw i64 %.1012.02076.i.i, 1
  br i1 %.12052066.not.i.i, label %B158.i.i, label %B138.if.lr.ph.i.i
B138.if.lr.ph.i.i:
  %41 = mul i64 %.1012.02076.i.i, %.16.i1594.i
  %scevgep10568.i = getelementptr i8, ptr %.1689.i.i, i64 %41
  tail call void @llvm.memset.p0.i64(ptr align 8 %scevgep10568.i, i8 0, i64 %.16.i1594.i, i1 false), !noalias !20
  br label %B158.i.i
B188.if.i.i:
  %.1327.02073.i.i = phi i64 [ 0, %B188.if.lr.ph.i.i ], [ %.1396.i.i, %B360.i.i ]
  %.1396.i.i = add nuw nsw i64 %.1327.02073.i.i, 1
  %42 = getelementptr double, ptr %39, i64 %.1327.02073.i.i
  %.1483.i.i = load double, ptr %42, align 8, !noalias !20
  %.1495.i.i = fcmp oeq double %.1483.i.i, 0.000000e+00
  %brmerge.i.i = or i1 %.12052066.not.i.i, %.1495.i.i
  br i1 %brmerge.i.i, label %B360.i.i, label %B286.if.lr.ph.i.i
B286.if.lr.ph.i.i:
  %.1735.i.i = mul i64 %.1327.02073.i.i, %.1345.i
  %43 = getelementptr double, ptr %.1344.i, i64 %.1735.i.i
  br label %B286.if.i.i
B286.if.i.i:
  %.1535.02070.i.i = phi i64 [ 0, %B286.if.lr.ph.i.i ], [ %.1604.i.i, %B286.if.i.i ]
  %.1604.i.i = add nuw nsw i64 %.1535.02070.i.i, 1
  %44 = getelementptr double, ptr %40, i64 %.1535.02070.i.i
  %.1681.i.i = load double, ptr %44, align 8, !noalias !20
  %45 = getelementptr double, ptr %43, i64 %.1535.02070.i.i
  %.1740.i.i = load double, ptr %45, align 8, !noalias !20
  %.1749.i.i = fmul double %.1483.i.i, %.1740.i.i
  %.1750.i.i = fadd double %.1681.i.i, %.1749.i.i
  store double %.1750.i.i, ptr %44, align 8, !noalias !20
  %exitcond2085.not.i.i = icmp eq i64 %.1345.i, %.1604.i.i
  br i1 %exitcond2085.not.i.i, label %B360.i.i, label %B286.if.i.i
B394.if.i.i:
  %.1850.02082.i.i = phi i64 [ %.1919.i.i, %B394.loopexit.i.i ], [ 0, %B82.loopexit.i.i ]
  %.1919.i.i = add nuw nsw i64 %.1850.02082.i.i, 1
  br i1 %.12052066.not.i.i, label %B394.loopexit.i.i, label %B450.if.lr.ph.i.i
B450.if.lr.ph.i.i:
  %.2126.i.i = mul i64 %.1850.02082.i.i, %.1345.i
  %46 = getelementptr double, ptr %.1689.i.i, i64 %.2126.i.i
  %47 = getelementptr double, ptr %.1344.i, i64 %.2126.i.i
  br label %B450.if.i.i
B450.if.i.i:
  %.1985.02079.i.i = phi i64 [ 0, %B450.if.lr.ph.i.i ], [ %.2054.i.i, %B450.if.i.i ]
  %.2054.i.i = add nuw nsw i64 %.1985.02079.i.i, 1
  %48 = getelementptr double, ptr %46, i64 %.1985.02079.i.i
  %.2131.i.i = load double, ptr %48, align 8, !noalias !20
  %49 = getelementptr double, ptr %47, i64 %.1985.02079.i.i
  store double %.2131.i.i, ptr %49, align 8, !noalias !20
  %exitcond2088.not.i.i = icmp eq i64 %.1345.i, %.2054.i.i
  br i1 %exitcond2088.not.i.i, label %B394.loopexit.i.i, label %B450.if.i.i
B1298.i:
  %status.4.0.i = phi i64 [ %.4055.fca.0.load.i, %B922.i ], [ 4, %b93 ]
  store double 0.000000e+00, ptr %.2374.i, align 8, !noalias !8
  br i1 %.288910545.not.i, label %B554.thread4213, label %B1368.if.i
B304.if.i:
  %.2412.010544.i = phi i64 [ 0, %B304.if.lr.ph.i ], [ %.2483.i, %B304.loopexit.i ]
  %.2483.i = add nuw nsw i64 %.2412.010544.i, 1
  %50 = getelementptr double, ptr %.316.i, i64 %.2412.010544.i
  %.2545.i = load double, ptr %50, align 8, !noalias !8
  %51 = getelementptr double, ptr %.4926.i, i64 %.2412.010544.i
  store double %.2545.i, ptr %51, align 8, !noalias !8
  br i1 %.266710539.not.i, label %B304.loopexit.i, label %B380.if.lr.ph.i
B380.if.lr.ph.i:
  %.2776.i = mul i64 %.2412.010544.i, %.265.i
  %52 = getelementptr double, ptr %.1295.i, i64 %.2776.i
  br label %B380.if.i
B380.if.i:
  %.2611.010541.i = phi i64 [ 0, %B380.if.lr.ph.i ], [ %.2680.i, %B380.if.i ]
  %.2680.i = add nuw nsw i64 %.2611.010541.i, 1
  %.2710.i = icmp eq i64 %.2611.010541.i, %.2412.010544.i
  %..i = select i1 %.2710.i, double 1.000000e+00, double 0.000000e+00
  %53 = getelementptr double, ptr %52, i64 %.2611.010541.i
  store double %..i, ptr %53, align 8, !noalias !8
  %exitcond.not.i4190 = icmp eq i64 %.265.i, %.2680.i
  br i1 %exitcond.not.i4190, label %B304.loopexit.i, label %B380.if.i
B468.if.i:
  %.2833.010546.i = phi i64 [ %.2902.i, %B468.if.i ], [ 0, %B428.i ]
  %.2902.i = add nuw nsw i64 %.2833.010546.i, 1
  %54 = getelementptr double, ptr %.4376.i, i64 %.2833.010546.i
  %.2956.i = load double, ptr %54, align 8, !noalias !8
  %55 = getelementptr double, ptr %.330416461687.i.i, i64 %.2833.010546.i
  store double %.2956.i, ptr %55, align 8, !noalias !8
  %exitcond10563.not.i = icmp eq i64 %.4351.i, %.2902.i
  br i1 %exitcond10563.not.i, label %B506.i, label %B468.if.i
B1074.if.i:
  %.4603.010552.i = phi i64 [ %.4672.i, %B1074.if.i ], [ 0, %B1044.i ]
  %.4672.i = add nuw nsw i64 %.4603.010552.i, 1
  %56 = getelementptr double, ptr %.4926.i, i64 %.4603.010552.i
  %.4730.i = load double, ptr %56, align 8, !noalias !8
  %57 = getelementptr double, ptr %.316.i, i64 %.4603.010552.i
  store double %.4730.i, ptr %57, align 8, !noalias !8
  %exitcond10565.not.i = icmp eq i64 %.481.fca.5.load.i, %.4672.i
  br i1 %exitcond10565.not.i, label %B1122.i, label %B1074.if.i
B1186.if.lr.ph.i:
  %.4918.010558.i = phi i64 [ %.4987.i, %B1152.loopexit.i ], [ 0, %B1122.i ]
  %.5186.i = mul i64 %.4918.010558.i, %.265.i
  %58 = getelementptr double, ptr %.856.i.i, i64 %.5186.i
  %59 = getelementptr double, ptr %.357.i, i64 %.5186.i
  br label %B1186.if.i
B1186.if.i:
  %.5039.010555.i = phi i64 [ 0, %B1186.if.lr.ph.i ], [ %.5108.i, %B1186.if.i ]
  %.5108.i = add nuw nsw i64 %.5039.010555.i, 1
  %60 = getelementptr double, ptr %58, i64 %.5039.010555.i
  %.5191.i = load double, ptr %60, align 8, !noalias !8
  %61 = getelementptr double, ptr %59, i64 %.5039.010555.i
  store double %.5191.i, ptr %61, align 8, !noalias !8
  %exitcond10566.not.i = icmp eq i64 %.265.i, %.5108.i
  br i1 %exitcond10566.not.i, label %B1152.loopexit.i, label %B1186.if.i
B1368.if.i:
  %.6278.010549.i = phi i64 [ %.6347.i, %B1368.if.i ], [ 0, %B1298.i ]
  %.6347.i = add nuw nsw i64 %.6278.010549.i, 1
  %62 = getelementptr double, ptr %.330416461687.i.i, i64 %.6278.010549.i
  %.6405.i = load double, ptr %62, align 8, !noalias !8
  %63 = getelementptr double, ptr %.4376.i, i64 %.6278.010549.i
  store double %.6405.i, ptr %63, align 8, !noalias !8
  %exitcond10564.not.i = icmp eq i64 %.4351.i, %.6347.i
  br i1 %exitcond10564.not.i, label %B554.thread4213, label %B1368.if.i
B554.thread4213:
  %storemerge.i.ph = phi i64 [ 4, %B518 ], [ %status.4.0.i, %B1298.i ], [ 4, %B154.i ], [ %status.4.0.i, %B1368.if.i ]
  call void @llvm.lifetime.end.p0(ptr nonnull %.3013.i)
  call void @llvm.lifetime.end.p0(ptr nonnull %.3352.i)
  call void @llvm.lifetime.end.p0(ptr nonnull %.3808.i)
  br label %B638
B554:
  store double %.1771.i, ptr %.271.i, align 8, !noalias !8
  call void @llvm.lifetime.end.p0(ptr nonnull %.3013.i)
  call void @llvm.lifetime.end.p0(ptr nonnull %.3352.i)
  call void @llvm.lifetime.end.p0(ptr nonnull %.3808.i)
  br label %B576
B576:
  %.2687 = and i64 %.489.fca.0.load.i, 2
  %.2688.not = icmp eq i64 %.2687, 0
  br i1 %.2688.not, label %B638, label %B606
B606:
  call void @llvm.lifetime.start.p0(ptr nonnull %.1601.i)
  store i8 0, ptr %.1601.i, align 1, !noalias !23
  call fastcc void @v68(ptr %.1601.i, i64 %.489.fca.2.load.i, ptr readonly %.271.i, ptr %.406.i4172, i64 %.481.fca.7.load.i, i64 %.489.fca.5.load.i, ptr readonly %.456.i, ptr readonly %.497.i, i64 %.264.i, ptr readonly %.539.i, ptr readonly %.580.i, i64 %.489.fca.4.load.i, i64 %.489.fca.4.load.i, ptr readonly %.629.i, ptr readonly %.752.i, i64 %.489.fca.4.load.i, i64 %.489.fca.7.load.i, ptr %.1042.i.i, ptr %.1386.i.i, ptr %.1561.i.i, ptr %.1593.i.i, i64 %.265.i, ptr %.161.i, i64 %.163.i, ptr %.1354.i, i64 %.481.fca.5.load.i, i64 %.265.i, ptr %.316.i, i64 %.265.i)
  %.1846.i = load i8, ptr %.1601.i, align 1, !noalias !23
  %.1849.not.i = icmp eq i8 %.1846.i, 0
  br i1 %.1849.not.i, label %b94, label %B100.i
B100.i:
  %.8486705.not.i.i = icmp slt i64 %.489.fca.7.load.i, 1
  br i1 %.8486705.not.i.i, label %b95, label %B56.if.lr.ph.i.i
B56.if.lr.ph.i.i:
  %.10661078.not.i.i.i = icmp eq i64 %.306616091669.i.i, 0
  br label %B56.if.i.i
B442.i.i:
  store double 0.000000e+00, ptr %79, align 8, !noalias !26
  br label %B879.i.i
B464.i.i:
  %.2138.i.i = fmul double %.1644.i.i, %.1644.i.i
  %64 = getelementptr double, ptr %.883.i, i64 %.789.06707.i.i
  %.2173.i.i = load double, ptr %64, align 8, !noalias !26
  %.2178.i.i = fmul double %variance.2.0.lcssa.i.i.i, %.2173.i.i
  %.2181.i.i = fcmp ogt double %.2138.i.i, %.2178.i.i
  br i1 %.2181.i.i, label %B510.i.i, label %B854.i.i
B510.i.i:
  %.2184.i.i4208 = fcmp ogt double %.1644.i.i, 0.000000e+00
  %..i.i = select i1 %.2184.i.i4208, double 1.000000e+00, double -1.000000e+00
  %65 = getelementptr double, ptr %.1170.i, i64 %.789.06707.i.i
  %.2233.i.i = load double, ptr %65, align 8, !noalias !26
  %.2238.i.i = fmul double %..i.i, %.2233.i.i
  %.2239.i.i = fcmp olt double %.2238.i.i, 0.000000e+00
  br i1 %.2239.i.i, label %B570.i.i, label %B590.i.i
B570.i.i:
  store double 0.000000e+00, ptr %65, align 8, !noalias !26
  br label %B590.i.i
B590.i.i:
  %.2357.i.i = phi double [ 0.000000e+00, %B570.i.i ], [ %.2233.i.i, %B510.i.i ]
  %66 = getelementptr double, ptr %.1211.i, i64 %.789.06707.i.i
  %.2362.i.i = fmul double %..i.i, %.2357.i.i
  %.2363.i.i = fcmp olt double %.2362.i.i, 2.000000e+00
  br i1 %.2363.i.i, label %B672.i.i, label %B736.i.i
B672.i.i:
  %.2403.i.i = fadd double %..i.i, %.2357.i.i
  store double %.2403.i.i, ptr %65, align 8, !noalias !26
  br label %B830.sink.split.i.i
B736.i.i:
  %.2314.i.i4209 = load double, ptr %66, align 8, !noalias !26
  %.2319.i.i = fsub double %.1644.i.i, %.2314.i.i4209
  %.2482.i.i4210 = fmul double %.2319.i.i, %.2319.i.i
  %.2519.i.i = load double, ptr %64, align 8, !noalias !26
  %.2523.i.i = fmul double %.2519.i.i, 2.000000e+00
  %.2558.i.i = load double, ptr %68, align 8, !noalias !26
  %.2562.i.i = fmul double %.2523.i.i, %.2558.i.i
  %.2563.i.i = fcmp ogt double %.2482.i.i4210, %.2562.i.i
  br i1 %.2563.i.i, label %B830.sink.split.i.i, label %B830.i.i
B830.sink.split.i.i:
  store double -1.000000e+00, ptr %79, align 8, !noalias !26
  br label %B830.i.i
B830.i.i:
  store double %.1644.i.i, ptr %66, align 8, !noalias !26
  br label %B879.i.i
B854.i.i:
  %67 = getelementptr double, ptr %.1170.i, i64 %.789.06707.i.i
  store double 0.000000e+00, ptr %67, align 8, !noalias !26
  br label %B879.i.i
B879.i.i:
  %exitcond.not.i.i4193 = icmp eq i64 %.861.i.i, %.489.fca.7.load.i
  br i1 %exitcond.not.i.i4193, label %b95, label %B56.if.i.i
B56.if.i.i:
  %.789.06707.i.i = phi i64 [ 0, %B56.if.lr.ph.i.i ], [ %.861.i.i, %B879.i.i ]
  %.861.i.i = add nuw nsw i64 %.789.06707.i.i, 1
  %.1125.i.i = mul i64 %.789.06707.i.i, %.265.i
  %.1127.i.i = getelementptr double, ptr %.1593.i.i, i64 %.1125.i.i
  %68 = getelementptr double, ptr %.842.i, i64 %.789.06707.i.i
  %.1198.i.i = load double, ptr %68, align 8, !noalias !26
  br i1 %.10661078.not.i.i.i, label %b96, label %B120.if.lr.ph.i.i.i
B180.i.i.i:
  %.1079.i.i.i = add nuw nsw i64 %.1008.01079.i.i.i, 1
  %69 = getelementptr double, ptr %.308216101668.i.i, i64 %.1008.01079.i.i.i
  store double %.1332.i.i.i, ptr %69, align 8, !noalias !29
  %70 = getelementptr double, ptr %.1127.i.i, i64 %.1008.01079.i.i.i
  %.1402.i.i.i = load double, ptr %70, align 8, !noalias !29
  %.1406.i.i.i = fmul double %.1332.i.i.i, %.1402.i.i.i
  %.1410.i.i.i = fadd double %variance.2.01081.i.i.i, %.1406.i.i.i
  %exitcond1083.not.i.i.i = icmp eq i64 %.306616091669.i.i, %.1079.i.i.i
  br i1 %exitcond1083.not.i.i.i, label %b96, label %B120.if.lr.ph.i.i.i
B120.if.lr.ph.i.i.i:
  %variance.2.01081.i.i.i = phi double [ %.1410.i.i.i, %B180.i.i.i ], [ %.1198.i.i, %B56.if.i.i ]
  %.1008.01079.i.i.i = phi i64 [ %.1079.i.i.i, %B180.i.i.i ], [ 0, %B56.if.i.i ]
  %.1287.i.i.i = mul i64 %.1008.01079.i.i.i, %.265.i
  %71 = getelementptr double, ptr %.357.i, i64 %.1287.i.i.i
  br label %B120.if.i.i.i
B120.if.i.i.i:
  %value.2.11077.i.i.i = phi double [ 0.000000e+00, %B120.if.lr.ph.i.i.i ], [ %.1332.i.i.i, %B120.if.i.i.i ]
  %.1140.01075.i.i.i = phi i64 [ 0, %B120.if.lr.ph.i.i.i ], [ %.1209.i.i.i, %B120.if.i.i.i ]
  %.1209.i.i.i = add nuw nsw i64 %.1140.01075.i.i.i, 1
  %72 = getelementptr double, ptr %71, i64 %.1140.01075.i.i.i
  %.1292.i.i.i = load double, ptr %72, align 8, !noalias !29
  %73 = getelementptr double, ptr %.1127.i.i, i64 %.1140.01075.i.i.i
  %.1329.i.i.i = load double, ptr %73, align 8, !noalias !29
  %.1330.i.i.i = fmul double %.1292.i.i.i, %.1329.i.i.i
  %.1332.i.i.i = fadd double %value.2.11077.i.i.i, %.1330.i.i.i
  %exitcond.not.i.i.i = icmp eq i64 %.306616091669.i.i, %.1209.i.i.i
  br i1 %exitcond.not.i.i.i, label %B180.i.i.i, label %B120.if.i.i.i
b96:
  %variance.2.0.lcssa.i.i.i = phi double [ %.1198.i.i, %B56.if.i.i ], [ %.1410.i.i.i, %B180.i.i.i ]
  %74 = getelementptr double, ptr %.801.i, i64 %.789.06707.i.i
  %.1411.i.i = load double, ptr %74, align 8, !noalias !26
  %75 = getelementptr double, ptr %.1042.i.i, i64 %.789.06707.i.i
  %.1640.i.i = load double, ptr %75, align 8, !noalias !26
  %.1644.i.i = fsub double %.1411.i.i, %.1640.i.i
  %.1885.le.i.i = tail call double @llvm.sqrt.f64(double %variance.2.0.lcssa.i.i.i)
  %76 = getelementptr double, ptr %.1006.i, i64 %.789.06707.i.i
  store double %.1640.i.i, ptr %76, align 8, !noalias !26
  %77 = getelementptr double, ptr %.1047.i, i64 %.789.06707.i.i
  store double %.1644.i.i, ptr %77, align 8, !noalias !26
  %78 = getelementptr double, ptr %.1088.i, i64 %.789.06707.i.i
  store double %.1885.le.i.i, ptr %78, align 8, !noalias !26
  %79 = getelementptr double, ptr %.1129.i, i64 %.789.06707.i.i
  store double 1.000000e+00, ptr %79, align 8, !noalias !26
  %.2051.le.i.i = fsub double %.1644.i.i, %.1644.i.i
  %.2052.le.i.i = fcmp ord double %.2051.le.i.i, 0.000000e+00
  %.2075.le.i.i = fsub double %variance.2.0.lcssa.i.i.i, %variance.2.0.lcssa.i.i.i
  %.2076.le.i.i = fcmp ord double %.2075.le.i.i, 0.000000e+00
  %or.cond.i.i = select i1 %.2052.le.i.i, i1 %.2076.le.i.i, i1 false
  br i1 %or.cond.i.i, label %B464.i.i, label %B442.i.i
b95:
  %.2493.i = icmp sgt i64 %.265.i, 0
  br i1 %.2493.i, label %B214.if.lr.ph.i, label %B272.thread.i
B272.thread.i:
  call void @llvm.lifetime.start.p0(ptr nonnull %.1308.i.i), !noalias !23
  br label %B94.i.i
B160.loopexit.i:
  %.2548.i = add nuw nsw i64 %.2479.09302.i, 1
  %exitcond9330.not.i = icmp eq i64 %.265.i, %.2548.i
  br i1 %exitcond9330.not.i, label %B272.i, label %B214.if.lr.ph.i
B272.i:
  call void @llvm.lifetime.start.p0(ptr nonnull %.1308.i.i), !noalias !23
  tail call void @llvm.memset.p0.i64(ptr align 8 %.256615001557.i.i, i8 0, i64 %.16.i.i4174, i1 false), !noalias !32
  br label %B94.i.i
B94.i.i:
  br i1 %.8486705.not.i.i, label %b97, label %B144.if.i.i
B182.i.i:
  store double 0.000000e+00, ptr %.1308.i.i, align 8, !noalias !32
  call fastcc void @v69(ptr %.1308.i.i, i64 %.265.i, ptr %.357.i, i64 %.265.i, i64 %.265.i, ptr readonly %.801.i, i64 %.489.fca.7.load.i, ptr readonly %.842.i, i64 %.489.fca.7.load.i, ptr readonly %.1042.i.i, i64 %.1026.i.i, ptr readonly %.1593.i.i, i64 %.489.fca.7.load.i, i64 %.265.i, ptr %.1641.i.i, i64 %.489.fca.7.load.i, i64 %.265.i, ptr %.2050.i.i, i64 %.2034.i.i, ptr %.2222.i.i, i64 %.2206.i.i, ptr %.256615001557.i.i, ptr readonly %.273815371591.i.i, ptr %.291015731632.i.i, i64 %.289415721633.i.i, i64 %.306616091669.i.i, ptr %.308216101668.i.i, i64 %.1164.01771.i.i)
  %.1464.i.i = load double, ptr %.1308.i.i, align 8, !noalias !32
  %.1477.i.i4206 = fadd double %nis.2.01773.i.i, %.1464.i.i
  br label %B220.i.i
B220.i.i:
  %nis.3.1.i.i = phi double [ %.1477.i.i4206, %B182.i.i ], [ %nis.2.01773.i.i, %B144.if.i.i ]
  %exitcond1774.not.i.i = icmp eq i64 %.489.fca.7.load.i, %.1233.i.i
  br i1 %exitcond1774.not.i.i, label %b97, label %B144.if.i.i
B144.if.i.i:
  %nis.2.01773.i.i = phi double [ %nis.3.1.i.i, %B220.i.i ], [ 0.000000e+00, %B94.i.i ]
  %.1164.01771.i.i = phi i64 [ %.1233.i.i, %B220.i.i ], [ 0, %B94.i.i ]
  %.1233.i.i = add nuw nsw i64 %.1164.01771.i.i, 1
  %80 = getelementptr double, ptr %.1129.i, i64 %.1164.01771.i.i
  %.1299.i.i = load double, ptr %80, align 8, !noalias !32
  %.1303.i.i = fcmp ogt double %.1299.i.i, 0.000000e+00
  br i1 %.1303.i.i, label %B182.i.i, label %B220.i.i
b97:
  %nis.2.0.lcssa.i.i = phi double [ 0.000000e+00, %B94.i.i ], [ %nis.3.1.i.i, %B220.i.i ]
  call void @llvm.lifetime.end.p0(ptr nonnull %.1308.i.i), !noalias !23
  store double %nis.2.0.lcssa.i.i, ptr %.1252.i, align 8, !noalias !23
  br i1 %.2493.i, label %B72.if.i.i4205, label %B148.i.i
B148.i.i:
  %.14451982.not.i.i.i = icmp eq i64 %.237914791521.i.i, 0
  br label %B72.if.i.i.i
B72.loopexit.i.i.i:
  %exitcond1988.not.i.i.i = icmp eq i64 %.1331.i.i.i, 3
  br i1 %exitcond1988.not.i.i.i, label %B242.preheader.i.i, label %B72.if.i.i.i
B242.preheader.i.i:
  br i1 %.2493.i, label %B242.if.i.i, label %B354.i
B166.i.i.i:
  %.1537.i.i.i.i = sub nsw i64 %.1389.01984.i.i.i, %.481.fca.5.load.i
  %.1569.i.i.i.i = getelementptr double, ptr %.670.i, i64 %.1537.i.i.i.i
  %.1570.i.i.i.i = load double, ptr %.1569.i.i.i.i, align 8, !noalias !35
  %.1785.i.i.i = getelementptr double, ptr %.711.i, i64 %.1537.i.i.i.i
  %.1786.i.i.i = load double, ptr %.1785.i.i.i, align 8, !noalias !42
  br label %B220.i.i.i
B220.i.i.i:
  %storemerge.i1978.i.i.i = phi double [ %.1570.i.i.i.i, %B166.i.i.i ], [ 0xFFF0000000000000, %B72.i.i.i.i ], [ %.1996.i.i.i.i, %B108.i.i.i.i ]
  %"$phi220.2.2.2.i.i.i" = phi double [ %.1786.i.i.i, %B166.i.i.i ], [ 0x7FF0000000000000, %B72.i.i.i.i ], [ 0x7FF0000000000000, %B108.i.i.i.i ]
  %81 = getelementptr double, ptr %.239514801520.i.i, i64 %.1389.01984.i.i.i
  %.1830.i.i.i = load double, ptr %81, align 8, !noalias !42
  %.12.i.i.i.i = fcmp ogt double %storemerge.i1978.i.i.i, %.1830.i.i.i
  %.13.i.i.i.i = select i1 %.12.i.i.i.i, double %storemerge.i1978.i.i.i, double %.1830.i.i.i
  %.12.i1971.i.i.i = fcmp olt double %"$phi220.2.2.2.i.i.i", %.13.i.i.i.i
  %.13.i1972.i.i.i = select i1 %.12.i1971.i.i.i, double %"$phi220.2.2.2.i.i.i", double %.13.i.i.i.i
  %.1925.i.i.i = fcmp une double %.13.i1972.i.i.i, %.1830.i.i.i
  br i1 %.1925.i.i.i, label %B318.i.i.i, label %B516.i.i.i
B318.i.i.i:
  %.1975.i.i.i = mul i64 %.1389.01984.i.i.i, %.265.i
  %82 = getelementptr double, ptr %.357.i, i64 %.1975.i.i.i
  %.1979.i.i.i = getelementptr double, ptr %82, i64 %.1389.01984.i.i.i
  %.1980.i.i.i = load double, ptr %.1979.i.i.i, align 8, !noalias !42
  %.1983.i.i.i = fcmp ogt double %.1980.i.i.i, 0.000000e+00
  %or.cond.i.i.i = select i1 %.1983.i.i.i, i1 %83, i1 false
  %.2020.i.i.i = fsub double %.13.i1972.i.i.i, %.1830.i.i.i
  %.2080.i.i.i = fdiv double %.2020.i.i.i, %.1980.i.i.i
  %"$phi404.2.2.2.i.i.i" = select i1 %or.cond.i.i.i, double %.2080.i.i.i, double 0.000000e+00
  %invariant.gep.i.i.i = getelementptr double, ptr %.357.i, i64 %.1389.01984.i.i.i
  br label %B446.if.i.i.i
B506.i.i.i:
  store double %.13.i1972.i.i.i, ptr %81, align 8, !noalias !42
  br label %B516.i.i.i
B516.i.i.i:
  %exitcond1987.not.i.i.i = icmp eq i64 %.237914791521.i.i, %.1458.i.i.i
  br i1 %exitcond1987.not.i.i.i, label %B72.loopexit.i.i.i, label %B116.if.i.i.i
B72.if.i.i.i:
  %.1260.01986.i.i.i = phi i64 [ 0, %B148.i.i ], [ %.1331.i.i.i, %B72.loopexit.i.i.i ]
  %.1331.i.i.i = add nuw nsw i64 %.1260.01986.i.i.i, 1
  %83 = icmp ult i64 %.1260.01986.i.i.i, 2
  br i1 %.14451982.not.i.i.i, label %B72.loopexit.i.i.i, label %B116.if.i.i.i
B116.if.i.i.i:
  %.1389.01984.i.i.i = phi i64 [ %.1458.i.i.i, %B516.i.i.i ], [ 0, %B72.if.i.i.i ]
  %.1458.i.i.i = add nuw nsw i64 %.1389.01984.i.i.i, 1
  %.1213.not.i.i.i.i = icmp slt i64 %.1389.01984.i.i.i, %.481.fca.5.load.i
  br i1 %.1213.not.i.i.i.i, label %B72.i.i.i.i, label %B166.i.i.i
B72.i.i.i.i:
  %84 = getelementptr i8, ptr %.4485.i, i64 %.1389.01984.i.i.i
  %.1753.i.i.i.i = load i8, ptr %84, align 1, !noalias !35
  %.1757.not.i.i.i.i = icmp eq i8 %.1753.i.i.i.i, 0
  br i1 %.1757.not.i.i.i.i, label %B220.i.i.i, label %B108.i.i.i.i
B108.i.i.i.i:
  %85 = getelementptr double, ptr %.316.i, i64 %.1389.01984.i.i.i
  %.1990.i.i.i.i = load double, ptr %85, align 8, !noalias !35
  %.1996.i.i.i.i = fmul double %.1990.i.i.i.i, 1.000000e-01
  br label %B220.i.i.i
B446.if.i.i.i:
  %.2124.01980.i.i.i = phi i64 [ 0, %B318.i.i.i ], [ %.2193.i.i.i, %B446.if.i.i.i ]
  %.2193.i.i.i = add nuw nsw i64 %.2124.01980.i.i.i, 1
  %86 = getelementptr double, ptr %.239514801520.i.i, i64 %.2124.01980.i.i.i
  %.2247.i.i.i = load double, ptr %86, align 8, !noalias !42
  %.2295.i.i.i = mul i64 %.2124.01980.i.i.i, %.265.i
  %gep.i.i.i = getelementptr double, ptr %invariant.gep.i.i.i, i64 %.2295.i.i.i
  %.2300.i.i.i = load double, ptr %gep.i.i.i, align 8, !noalias !42
  %.2304.i.i.i = fmul double %"$phi404.2.2.2.i.i.i", %.2300.i.i.i
  %.2305.i.i.i = fadd double %.2247.i.i.i, %.2304.i.i.i
  store double %.2305.i.i.i, ptr %86, align 8, !noalias !42
  %exitcond.not.i.i9143.i = icmp eq i64 %.237914791521.i.i, %.2193.i.i.i
  br i1 %exitcond.not.i.i9143.i, label %B506.i.i.i, label %B446.if.i.i.i
B242.loopexit.i.i:
  %exitcond3511.not.i.i = icmp eq i64 %.265.i, %.2325.i.i
  br i1 %exitcond3511.not.i.i, label %b98, label %B242.if.i.i
B250.i.i:
  %87 = getelementptr double, ptr %.239514801520.i.i, i64 %.2256.03504.i.i
  %.2395.i.i = load double, ptr %87, align 8, !noalias !43
  %.2406.le.i.i = fsub double %.2395.i.i, %.2395.i.i
  %.2407.le.i.i = fcmp ord double %.2406.le.i.i, 0.000000e+00
  br label %B362.if.lr.ph.i.i
B362.if.lr.ph.i.i:
  %"$phi310.1.2.1.i.i" = phi i1 [ false, %B242.if.i.i ], [ %.2407.le.i.i, %B250.i.i ]
  %.2628.i.i = mul i64 %.2256.03504.i.i, %.265.i
  %88 = getelementptr double, ptr %.357.i, i64 %.2628.i.i
  br label %B362.if.i.i
B370.i.i:
  %89 = getelementptr double, ptr %88, i64 %.2467.03498.i.i
  %.2633.i.i = load double, ptr %89, align 8, !noalias !43
  %.2648.le.i.i = fsub double %.2633.i.i, %.2633.i.i
  %.2649.le.i.i = fcmp ord double %.2648.le.i.i, 0.000000e+00
  br label %B434.i.i
B434.i.i:
  %"$phi434.2.2.2.i.i" = phi i1 [ false, %B362.if.i.i ], [ %.2649.le.i.i, %B370.i.i ]
  %exitcond3510.not.i.i = icmp eq i64 %.265.i, %.2536.i.i
  br i1 %exitcond3510.not.i.i, label %B242.loopexit.i.i, label %B362.if.i.i
B72.if.i.i4205:
  %.1616.03496.i.i = phi i64 [ %.1687.i.i, %B72.if.i.i4205 ], [ 0, %b97 ]
  %.1687.i.i = add nuw nsw i64 %.1616.03496.i.i, 1
  %90 = getelementptr double, ptr %.316.i, i64 %.1616.03496.i.i
  %.1745.i.i = load double, ptr %90, align 8, !noalias !43
  %91 = getelementptr double, ptr %.256615001557.i.i, i64 %.1616.03496.i.i
  %.1782.i.i = load double, ptr %91, align 8, !noalias !43
  %.1786.i.i = fadd double %.1745.i.i, %.1782.i.i
  %92 = getelementptr double, ptr %.239514801520.i.i, i64 %.1616.03496.i.i
  store double %.1786.i.i, ptr %92, align 8, !noalias !43
  %exitcond.not.i9142.i = icmp eq i64 %.265.i, %.1687.i.i
  br i1 %exitcond.not.i9142.i, label %B148.i.i, label %B72.if.i.i4205
B242.if.i.i:
  %finite.3.03506.i.i = phi i1 [ %"$phi434.2.2.2.i.i", %B242.loopexit.i.i ], [ true, %B242.preheader.i.i ]
  %.2256.03504.i.i = phi i64 [ %.2325.i.i, %B242.loopexit.i.i ], [ 0, %B242.preheader.i.i ]
  %.2325.i.i = add nuw nsw i64 %.2256.03504.i.i, 1
  br i1 %finite.3.03506.i.i, label %B250.i.i, label %B362.if.lr.ph.i.i
B362.if.i.i:
  %finite.4.13500.i.i = phi i1 [ %"$phi310.1.2.1.i.i", %B362.if.lr.ph.i.i ], [ %"$phi434.2.2.2.i.i", %B434.i.i ]
  %.2467.03498.i.i = phi i64 [ 0, %B362.if.lr.ph.i.i ], [ %.2536.i.i, %B434.i.i ]
  %.2536.i.i = add nuw nsw i64 %.2467.03498.i.i, 1
  br i1 %finite.4.13500.i.i, label %B370.i.i, label %B434.i.i
b98:
  br i1 %"$phi434.2.2.2.i.i", label %B354.i, label %B696.i
B354.i:
  call void @llvm.lifetime.start.p0(ptr nonnull %.2300.i.i), !noalias !23
  br i1 %.8486705.not.i.i, label %b99, label %B76.if.i.i4194
B280.loopexit.i.i:
  %93 = fmul double %.2064.i.i, %.2064.i.i
  br label %B280.i.i
B280.i.i:
  %.2187.i.i4195 = phi double [ %93, %B280.loopexit.i.i ], [ 0.000000e+00, %B76.if.i.i4194 ]
  br i1 %is_far.2.07355.i.i, label %B432.i.thread.i, label %B284.i.i4196
B284.i.i4196:
  %94 = getelementptr double, ptr %.1129.i, i64 %.1619.07353.i.i
  %.2145.i.i = load double, ptr %94, align 8, !noalias !44
  %.2149.i.i = fcmp ogt double %.2145.i.i, 0.000000e+00
  br i1 %.2149.i.i, label %B432.i.i, label %B432.thread.i.i
B432.i.i:
  %95 = getelementptr double, ptr %.842.i, i64 %.1619.07353.i.i
  %.2265.i.i = load double, ptr %95, align 8, !noalias !44
  %.2272.i.i = fcmp ogt double %.2187.i.i4195, %.2265.i.i
  %exitcond7364.not.i.i = icmp eq i64 %.489.fca.7.load.i, %.1690.i.i
  br i1 %exitcond7364.not.i.i, label %B436.i.i, label %B76.if.i.i4194.backedge
B432.i.thread.i:
  %exitcond7364.not.i9272.i = icmp eq i64 %.489.fca.7.load.i, %.1690.i.i
  br i1 %exitcond7364.not.i9272.i, label %B440.i.i, label %B76.if.i.i4194.backedge
B432.thread.i.i:
  %exitcond7364.not7369.i.i = icmp eq i64 %.489.fca.7.load.i, %.1690.i.i
  br i1 %exitcond7364.not7369.i.i, label %b99, label %B76.if.i.i4194.backedge
B76.if.i.i4194.backedge:
  %is_far.2.07355.i.i.be = phi i1 [ true, %B432.i.thread.i ], [ %.2272.i.i, %B432.i.i ], [ false, %B432.thread.i.i ]
  br label %B76.if.i.i4194
B436.i.i:
  br i1 %.2272.i.i, label %B440.i.i, label %b99
B440.i.i:
  store i8 0, ptr %.2300.i.i, align 1, !noalias !44
  call fastcc void @v68(ptr %.2300.i.i, i64 %.489.fca.2.load.i, ptr readonly %.271.i, ptr %.406.i4172, i64 %.481.fca.7.load.i, i64 %.489.fca.5.load.i, ptr readonly %.456.i, ptr readonly %.497.i, i64 %.264.i, ptr readonly %.539.i, ptr readonly %.580.i, i64 %.489.fca.4.load.i, i64 %.489.fca.4.load.i, ptr readonly %.629.i, ptr readonly %.752.i, i64 %.489.fca.4.load.i, i64 %.489.fca.7.load.i, ptr %.1042.i.i, ptr %.1386.i.i, ptr %.1561.i.i, ptr %.1593.i.i, i64 %.265.i, ptr %.161.i, i64 %.163.i, ptr %.1354.i, i64 %.481.fca.5.load.i, i64 %.237914791521.i.i, ptr %.239514801520.i.i, i64 %.237914791521.i.i)
  %.2545.i.i = load i8, ptr %.2300.i.i, align 1, !noalias !44
  %.2548.not.i.i = icmp eq i8 %.2545.i.i, 0
  br i1 %.2548.not.i.i, label %b99, label %B538.if.i.i
B628.i.i:
  %96 = getelementptr double, ptr %.1129.i, i64 %.3146.07357.i.i
  %.3404.i.i = load double, ptr %96, align 8, !noalias !44
  %.3408.i.i = fcmp ogt double %.3404.i.i, 0.000000e+00
  br i1 %.3408.i.i, label %B662.i.i, label %B732.i.i
B662.i.i:
  %.3414.i.i = fmul double %.3358.i.i, %.3358.i.i
  %97 = getelementptr double, ptr %.842.i, i64 %.3146.07357.i.i
  %.3452.i.i = load double, ptr %97, align 8, !noalias !44
  %.3458.i.i = fmul double %.3452.i.i, 0x3F847AE147AE147C
  %.3459.i.i = fcmp ogt double %.3414.i.i, %.3458.i.i
  br label %B732.i.i
B732.i.i:
  %"$phi732.1.3.1.i.i" = phi i1 [ true, %B538.if.i.i ], [ %.3459.i.i, %B662.i.i ], [ false, %B628.i.i ]
  %exitcond7365.not.i.i = icmp eq i64 %.489.fca.7.load.i, %.3215.i.i
  br i1 %exitcond7365.not.i.i, label %B736.i9146.i, label %B538.if.i.i
B736.i9146.i:
  br i1 %.2493.i, label %B786.if.i.i, label %b100
B76.if.i.i4194:
  %is_far.2.07355.i.i = phi i1 [ %is_far.2.07355.i.i.be, %B76.if.i.i4194.backedge ], [ false, %B354.i ]
  %.1619.07353.i.i = phi i64 [ %.1690.i.i, %B76.if.i.i4194.backedge ], [ 0, %B354.i ]
  %.1690.i.i = add nuw nsw i64 %.1619.07353.i.i, 1
  %98 = getelementptr double, ptr %.1213.i.i, i64 %.1619.07353.i.i
  store double 0.000000e+00, ptr %98, align 8, !noalias !44
  br i1 %.2493.i, label %B150.if.lr.ph.i.i, label %B280.i.i
B150.if.lr.ph.i.i:
  %.1975.i.i = mul i64 %.1619.07353.i.i, %.265.i
  %99 = getelementptr double, ptr %.1593.i.i, i64 %.1975.i.i
  br label %B150.if.i.i
B150.if.i.i:
  %.19217351.i.i = phi double [ 0.000000e+00, %B150.if.lr.ph.i.i ], [ %.2064.i.i, %B150.if.i.i ]
  %.1793.07349.i.i = phi i64 [ 0, %B150.if.lr.ph.i.i ], [ %.1862.i.i4203, %B150.if.i.i ]
  %.1862.i.i4203 = add nuw nsw i64 %.1793.07349.i.i, 1
  %100 = getelementptr double, ptr %99, i64 %.1793.07349.i.i
  %.1980.i.i4204 = load double, ptr %100, align 8, !noalias !44
  %101 = getelementptr double, ptr %.239514801520.i.i, i64 %.1793.07349.i.i
  %.2021.i.i = load double, ptr %101, align 8, !noalias !44
  %102 = getelementptr double, ptr %.316.i, i64 %.1793.07349.i.i
  %.2058.i.i = load double, ptr %102, align 8, !noalias !44
  %.2062.i.i = fsub double %.2021.i.i, %.2058.i.i
  %.2063.i.i = fmul double %.1980.i.i4204, %.2062.i.i
  %.2064.i.i = fadd double %.19217351.i.i, %.2063.i.i
  store double %.2064.i.i, ptr %98, align 8, !noalias !44
  %exitcond.not.i9145.i = icmp eq i64 %.265.i, %.1862.i.i4203
  br i1 %exitcond.not.i9145.i, label %B280.loopexit.i.i, label %B150.if.i.i
B538.if.i.i:
  %is_curved.2.07359.i.i = phi i1 [ %"$phi732.1.3.1.i.i", %B732.i.i ], [ false, %B440.i.i ]
  %.3146.07357.i.i = phi i64 [ %.3215.i.i, %B732.i.i ], [ 0, %B440.i.i ]
  %.3215.i.i = add nuw nsw i64 %.3146.07357.i.i, 1
  %103 = getelementptr double, ptr %.1042.i.i, i64 %.3146.07357.i.i
  %.3277.i.i = load double, ptr %103, align 8, !noalias !44
  %104 = getelementptr double, ptr %.1006.i, i64 %.3146.07357.i.i
  %.3315.i.i = load double, ptr %104, align 8, !noalias !44
  %105 = getelementptr double, ptr %.1213.i.i, i64 %.3146.07357.i.i
  %.3353.i.i = load double, ptr %105, align 8, !noalias !44
  %.3357.i.i = fadd double %.3315.i.i, %.3353.i.i
  %.3358.i.i = fsub double %.3277.i.i, %.3357.i.i
  br i1 %is_curved.2.07359.i.i, label %B732.i.i, label %B628.i.i
B786.if.i.i:
  %.3514.07362.i.i = phi i64 [ %.3583.i.i, %B786.if.i.i ], [ 0, %B736.i9146.i ]
  %.3583.i.i = add nuw nsw i64 %.3514.07362.i.i, 1
  %106 = getelementptr double, ptr %.239514801520.i.i, i64 %.3514.07362.i.i
  %.3641.i.i = load double, ptr %106, align 8, !noalias !44
  %107 = getelementptr double, ptr %.316.i, i64 %.3514.07362.i.i
  %.3678.i.i = load double, ptr %107, align 8, !noalias !44
  %.3682.i.i = fsub double %.3641.i.i, %.3678.i.i
  %108 = getelementptr double, ptr %.273815371591.i.i, i64 %.3514.07362.i.i
  store double %.3682.i.i, ptr %108, align 8, !noalias !44
  %exitcond7366.not.i.i = icmp eq i64 %.265.i, %.3583.i.i
  br i1 %exitcond7366.not.i.i, label %b100, label %B786.if.i.i
b99:
  call void @llvm.lifetime.end.p0(ptr nonnull %.2300.i.i), !noalias !23
  br label %B574.i4197
b100:
  call void @llvm.lifetime.end.p0(ptr nonnull %.2300.i.i), !noalias !23
  br i1 %"$phi732.1.3.1.i.i", label %B416.preheader.i, label %B574.i4197
B416.preheader.i:
  %.37089306.not.i = icmp slt i64 %.265.i, 1
  br i1 %.37089306.not.i, label %B508.thread.i, label %B450.if.lr.ph.i
B508.thread.i:
  call void @llvm.lifetime.start.p0(ptr nonnull %.1308.i9147.i), !noalias !23
  br label %B144.if.i9156.i.preheader
B416.loopexit.i:
  %.3721.i = add nuw nsw i64 %.3652.09307.i, 1
  %exitcond9332.not.i = icmp eq i64 %.265.i, %.3721.i
  br i1 %exitcond9332.not.i, label %B508.i, label %B450.if.lr.ph.i
B508.i:
  call void @llvm.lifetime.start.p0(ptr nonnull %.1308.i9147.i), !noalias !23
  tail call void @llvm.memset.p0.i64(ptr align 8 %.256615001557.i.i, i8 0, i64 %.16.i.i4174, i1 false), !noalias !47
  br label %B144.if.i9156.i.preheader
B144.if.i9156.i.preheader:
  br label %B144.if.i9156.i
B182.i9166.i:
  call fastcc void @v69(ptr %.1308.i9147.i, i64 %.265.i, ptr %.357.i, i64 %.265.i, i64 %.265.i, ptr readonly %.801.i, i64 %.489.fca.7.load.i, ptr readonly %.842.i, i64 %.489.fca.7.load.i, ptr readonly %.1042.i.i, i64 %.1026.i.i, ptr readonly %.1593.i.i, i64 %.489.fca.7.load.i, i64 %.265.i, ptr %.1641.i.i, i64 %.489.fca.7.load.i, i64 %.265.i, ptr %.2050.i.i, i64 %.2034.i.i, ptr %.2222.i.i, i64 %.2206.i.i, ptr %.256615001557.i.i, ptr readonly %.273815371591.i.i, ptr %.291015731632.i.i, i64 %.289415721633.i.i, i64 %.306616091669.i.i, ptr %.308216101668.i.i, i64 %.1164.01771.i9158.i)
  br label %B220.i9162.i
B220.i9162.i:
  %exitcond1774.not.i9164.i = icmp eq i64 %.489.fca.7.load.i, %.1233.i9159.i
  br i1 %exitcond1774.not.i9164.i, label %b101, label %B144.if.i9156.i
B144.if.i9156.i:
  %.1164.01771.i9158.i = phi i64 [ %.1233.i9159.i, %B220.i9162.i ], [ 0, %B144.if.i9156.i.preheader ]
  %.1233.i9159.i = add nuw nsw i64 %.1164.01771.i9158.i, 1
  %109 = getelementptr double, ptr %.1129.i, i64 %.1164.01771.i9158.i
  %.1299.i9160.i = load double, ptr %109, align 8, !noalias !47
  %.1303.i9161.i = fcmp ogt double %.1299.i9160.i, 0.000000e+00
  br i1 %.1303.i9161.i, label %B182.i9166.i, label %B220.i9162.i
b101:
  call void @llvm.lifetime.end.p0(ptr nonnull %.1308.i9147.i), !noalias !23
  br i1 %.2493.i, label %B72.if.i9173.i, label %B72.if.i.i9182.i.preheader
B72.if.i.i9182.i.preheader:
  br label %B72.if.i.i9182.i
B72.loopexit.i.i9206.i:
  %exitcond1988.not.i.i9207.i = icmp eq i64 %.1331.i.i9184.i, 3
  br i1 %exitcond1988.not.i.i9207.i, label %B242.preheader.i9208.i, label %B72.if.i.i9182.i
B242.preheader.i9208.i:
  br i1 %.2493.i, label %B242.if.i9209.i, label %B652.i
B166.i.i9189.i:
  %.1537.i.i.i9190.i = sub nsw i64 %.1389.01984.i.i9186.i, %.481.fca.5.load.i
  %.1569.i.i.i9191.i = getelementptr double, ptr %.670.i, i64 %.1537.i.i.i9190.i
  %.1570.i.i.i9192.i = load double, ptr %.1569.i.i.i9191.i, align 8, !noalias !50
  %.1785.i.i9193.i = getelementptr double, ptr %.711.i, i64 %.1537.i.i.i9190.i
  %.1786.i.i9194.i = load double, ptr %.1785.i.i9193.i, align 8, !noalias !57
  br label %B220.i.i9195.i
B220.i.i9195.i:
  %storemerge.i1978.i.i9196.i = phi double [ %.1570.i.i.i9192.i, %B166.i.i9189.i ], [ 0xFFF0000000000000, %B72.i.i.i9257.i ], [ %.1996.i.i.i9262.i, %B108.i.i.i9260.i ]
  %"$phi220.2.2.2.i.i9197.i" = phi double [ %.1786.i.i9194.i, %B166.i.i9189.i ], [ 0x7FF0000000000000, %B72.i.i.i9257.i ], [ 0x7FF0000000000000, %B108.i.i.i9260.i ]
  %110 = getelementptr double, ptr %.239514801520.i.i, i64 %.1389.01984.i.i9186.i
  %.1830.i.i9198.i = load double, ptr %110, align 8, !noalias !57
  %.12.i.i.i9199.i = fcmp ogt double %storemerge.i1978.i.i9196.i, %.1830.i.i9198.i
  %.13.i.i.i9200.i = select i1 %.12.i.i.i9199.i, double %storemerge.i1978.i.i9196.i, double %.1830.i.i9198.i
  %.12.i1971.i.i9201.i = fcmp olt double %"$phi220.2.2.2.i.i9197.i", %.13.i.i.i9200.i
  %.13.i1972.i.i9202.i = select i1 %.12.i1971.i.i9201.i, double %"$phi220.2.2.2.i.i9197.i", double %.13.i.i.i9200.i
  %.1925.i.i9203.i = fcmp une double %.13.i1972.i.i9202.i, %.1830.i.i9198.i
  br i1 %.1925.i.i9203.i, label %B318.i.i9236.i, label %B516.i.i9204.i
B318.i.i9236.i:
  %.1975.i.i9237.i = mul i64 %.1389.01984.i.i9186.i, %.265.i
  %111 = getelementptr double, ptr %.357.i, i64 %.1975.i.i9237.i
  %.1979.i.i9238.i = getelementptr double, ptr %111, i64 %.1389.01984.i.i9186.i
  %.1980.i.i9239.i = load double, ptr %.1979.i.i9238.i, align 8, !noalias !57
  %.1983.i.i9240.i = fcmp ogt double %.1980.i.i9239.i, 0.000000e+00
  %or.cond.i.i9241.i = select i1 %.1983.i.i9240.i, i1 %112, i1 false
  %.2020.i.i9242.i = fsub double %.13.i1972.i.i9202.i, %.1830.i.i9198.i
  %.2080.i.i9243.i = fdiv double %.2020.i.i9242.i, %.1980.i.i9239.i
  %"$phi404.2.2.2.i.i9244.i" = select i1 %or.cond.i.i9241.i, double %.2080.i.i9243.i, double 0.000000e+00
  %invariant.gep.i.i9245.i = getelementptr double, ptr %.357.i, i64 %.1389.01984.i.i9186.i
  br label %B446.if.i.i9246.i
B506.i.i9256.i:
  store double %.13.i1972.i.i9202.i, ptr %110, align 8, !noalias !57
  br label %B516.i.i9204.i
B516.i.i9204.i:
  %exitcond1987.not.i.i9205.i = icmp eq i64 %.237914791521.i.i, %.1458.i.i9187.i
  br i1 %exitcond1987.not.i.i9205.i, label %B72.loopexit.i.i9206.i, label %B116.if.i.i9185.i
B72.if.i.i9182.i:
  %.1260.01986.i.i9183.i = phi i64 [ %.1331.i.i9184.i, %B72.loopexit.i.i9206.i ], [ 0, %B72.if.i.i9182.i.preheader ]
  %.1331.i.i9184.i = add nuw nsw i64 %.1260.01986.i.i9183.i, 1
  %112 = icmp ult i64 %.1260.01986.i.i9183.i, 2
  br i1 %.14451982.not.i.i.i, label %B72.loopexit.i.i9206.i, label %B116.if.i.i9185.i
B116.if.i.i9185.i:
  %.1389.01984.i.i9186.i = phi i64 [ %.1458.i.i9187.i, %B516.i.i9204.i ], [ 0, %B72.if.i.i9182.i ]
  %.1458.i.i9187.i = add nuw nsw i64 %.1389.01984.i.i9186.i, 1
  %.1213.not.i.i.i9188.i = icmp slt i64 %.1389.01984.i.i9186.i, %.481.fca.5.load.i
  br i1 %.1213.not.i.i.i9188.i, label %B72.i.i.i9257.i, label %B166.i.i9189.i
B72.i.i.i9257.i:
  %113 = getelementptr i8, ptr %.4485.i, i64 %.1389.01984.i.i9186.i
  %.1753.i.i.i9258.i = load i8, ptr %113, align 1, !noalias !50
  %.1757.not.i.i.i9259.i = icmp eq i8 %.1753.i.i.i9258.i, 0
  br i1 %.1757.not.i.i.i9259.i, label %B220.i.i9195.i, label %B108.i.i.i9260.i
B108.i.i.i9260.i:
  %114 = getelementptr double, ptr %.316.i, i64 %.1389.01984.i.i9186.i
  %.1990.i.i.i9261.i = load double, ptr %114, align 8, !noalias !50
  %.1996.i.i.i9262.i = fmul double %.1990.i.i.i9261.i, 1.000000e-01
  br label %B220.i.i9195.i
B446.if.i.i9246.i:
  %.2124.01980.i.i9247.i = phi i64 [ 0, %B318.i.i9236.i ], [ %.2193.i.i9248.i, %B446.if.i.i9246.i ]
  %.2193.i.i9248.i = add nuw nsw i64 %.2124.01980.i.i9247.i, 1
  %115 = getelementptr double, ptr %.239514801520.i.i, i64 %.2124.01980.i.i9247.i
  %.2247.i.i9249.i = load double, ptr %115, align 8, !noalias !57
  %.2295.i.i9250.i = mul i64 %.2124.01980.i.i9247.i, %.265.i
  %gep.i.i9251.i = getelementptr double, ptr %invariant.gep.i.i9245.i, i64 %.2295.i.i9250.i
  %.2300.i.i9252.i = load double, ptr %gep.i.i9251.i, align 8, !noalias !57
  %.2304.i.i9253.i = fmul double %"$phi404.2.2.2.i.i9244.i", %.2300.i.i9252.i
  %.2305.i.i9254.i = fadd double %.2247.i.i9249.i, %.2304.i.i9253.i
  store double %.2305.i.i9254.i, ptr %115, align 8, !noalias !57
  %exitcond.not.i.i9255.i = icmp eq i64 %.237914791521.i.i, %.2193.i.i9248.i
  br i1 %exitcond.not.i.i9255.i, label %B506.i.i9256.i, label %B446.if.i.i9246.i
B242.loopexit.i9223.i:
  %exitcond3511.not.i9224.i = icmp eq i64 %.265.i, %.2325.i9212.i
  br i1 %exitcond3511.not.i9224.i, label %b102, label %B242.if.i9209.i
B250.i9232.i:
  %116 = getelementptr double, ptr %.239514801520.i.i, i64 %.2256.03504.i9211.i
  %.2395.i9233.i = load double, ptr %116, align 8, !noalias !58
  %.2406.le.i9234.i = fsub double %.2395.i9233.i, %.2395.i9233.i
  %.2407.le.i9235.i = fcmp ord double %.2406.le.i9234.i, 0.000000e+00
  br label %B362.if.lr.ph.i9213.i
B362.if.lr.ph.i9213.i:
  %"$phi310.1.2.1.i9214.i" = phi i1 [ false, %B242.if.i9209.i ], [ %.2407.le.i9235.i, %B250.i9232.i ]
  %.2628.i9215.i = mul i64 %.2256.03504.i9211.i, %.265.i
  %117 = getelementptr double, ptr %.357.i, i64 %.2628.i9215.i
  br label %B362.if.i9216.i
B370.i9228.i:
  %118 = getelementptr double, ptr %117, i64 %.2467.03498.i9218.i
  %.2633.i9229.i = load double, ptr %118, align 8, !noalias !58
  %.2648.le.i9230.i = fsub double %.2633.i9229.i, %.2633.i9229.i
  %.2649.le.i9231.i = fcmp ord double %.2648.le.i9230.i, 0.000000e+00
  br label %B434.i9220.i
B434.i9220.i:
  %"$phi434.2.2.2.i9221.i" = phi i1 [ false, %B362.if.i9216.i ], [ %.2649.le.i9231.i, %B370.i9228.i ]
  %exitcond3510.not.i9222.i = icmp eq i64 %.265.i, %.2536.i9219.i
  br i1 %exitcond3510.not.i9222.i, label %B242.loopexit.i9223.i, label %B362.if.i9216.i
B72.if.i9173.i:
  %.1616.03496.i9174.i = phi i64 [ %.1687.i9175.i, %B72.if.i9173.i ], [ 0, %b101 ]
  %.1687.i9175.i = add nuw nsw i64 %.1616.03496.i9174.i, 1
  %119 = getelementptr double, ptr %.316.i, i64 %.1616.03496.i9174.i
  %.1745.i9176.i = load double, ptr %119, align 8, !noalias !58
  %120 = getelementptr double, ptr %.256615001557.i.i, i64 %.1616.03496.i9174.i
  %.1782.i9177.i = load double, ptr %120, align 8, !noalias !58
  %.1786.i9178.i = fadd double %.1745.i9176.i, %.1782.i9177.i
  %121 = getelementptr double, ptr %.239514801520.i.i, i64 %.1616.03496.i9174.i
  store double %.1786.i9178.i, ptr %121, align 8, !noalias !58
  %exitcond.not.i9179.i = icmp eq i64 %.265.i, %.1687.i9175.i
  br i1 %exitcond.not.i9179.i, label %B72.if.i.i9182.i.preheader, label %B72.if.i9173.i
B242.if.i9209.i:
  %finite.3.03506.i9210.i = phi i1 [ %"$phi434.2.2.2.i9221.i", %B242.loopexit.i9223.i ], [ true, %B242.preheader.i9208.i ]
  %.2256.03504.i9211.i = phi i64 [ %.2325.i9212.i, %B242.loopexit.i9223.i ], [ 0, %B242.preheader.i9208.i ]
  %.2325.i9212.i = add nuw nsw i64 %.2256.03504.i9211.i, 1
  br i1 %finite.3.03506.i9210.i, label %B250.i9232.i, label %B362.if.lr.ph.i9213.i
B362.if.i9216.i:
  %finite.4.13500.i9217.i = phi i1 [ %"$phi310.1.2.1.i9214.i", %B362.if.lr.ph.i9213.i ], [ %"$phi434.2.2.2.i9221.i", %B434.i9220.i ]
  %.2467.03498.i9218.i = phi i64 [ 0, %B362.if.lr.ph.i9213.i ], [ %.2536.i9219.i, %B434.i9220.i ]
  %.2536.i9219.i = add nuw nsw i64 %.2467.03498.i9218.i, 1
  br i1 %finite.4.13500.i9217.i, label %B370.i9228.i, label %B434.i9220.i
b102:
  br i1 %"$phi434.2.2.2.i9221.i", label %B574.i4197, label %B696.i
B574.i4197:
  %.47719315.not.i = icmp slt i64 %.265.i, 1
  br i1 %.47719315.not.i, label %B652.i, label %B604.if.i
B652.i:
  br i1 %.8486705.not.i.i, label %b94, label %B160.if.lr.ph.i.i
B160.if.lr.ph.i.i:
  %.22504757.not.i.i = icmp slt i64 %.1853.i.i, 1
  %.34944778.not.i.i = icmp slt i64 %.489.fca.8.load.i, 1
  %.36154775.not.i.i = icmp slt i64 %.489.fca.9.load.i, 1
  %122 = shl nuw i64 %.1862.i.i, 3
  br label %B160.if.i.i
B200.i.i:
  br i1 %.22504757.not.i.i, label %B256.i.i, label %B240.if.i.preheader.i
B240.if.i.preheader.i:
  tail call void @llvm.memset.p0.i64(ptr align 8 %.1878.i.i, i8 0, i64 %122, i1 false), !noalias !59
  br label %B256.i.i
B256.i.i:
  br i1 %.2493.i, label %B286.if.lr.ph.i.i4200, label %B620.i.i
B286.if.lr.ph.i.i4200:
  %.2498.i.i = mul i64 %.2024.04782.i.i, %.265.i
  %123 = getelementptr double, ptr %.1593.i.i, i64 %.2498.i.i
  br label %B286.if.i.i4201
B474.preheader.i.i:
  %124 = getelementptr double, ptr %.1641.i.i, i64 %.2498.i.i
  br label %B474.if.i.i
B442.i9266.i:
  %exitcond4786.not.i.i = icmp eq i64 %.265.i, %.2416.i.i
  br i1 %exitcond4786.not.i.i, label %B474.preheader.i.i, label %B286.if.i.i4201
B474.loopexit.i.i:
  %exitcond4788.not.i.i = icmp eq i64 %.265.i, %.2877.i.i
  br i1 %exitcond4788.not.i.i, label %B620.i.i, label %B474.if.i.i
B620.i.i:
  %125 = getelementptr double, ptr %.2222.i.i, i64 %.2024.04782.i.i
  %.3293.i.i = load double, ptr %125, align 8, !noalias !59
  %126 = getelementptr double, ptr %.2050.i.i, i64 %.2024.04782.i.i
  %.3331.i.i = load double, ptr %126, align 8, !noalias !59
  %.3338.i.i = fdiv double %.3293.i.i, %.3331.i.i
  %.3382.i.i = fdiv double 1.000000e+00, %.3331.i.i
  br i1 %.34944778.not.i.i, label %B1020.i.i, label %B768.if.i.i
B768.loopexit.i.i:
  %exitcond4791.not.i.i = icmp eq i64 %.489.fca.8.load.i, %.3507.i.i
  br i1 %exitcond4791.not.i.i, label %B1020.i.i, label %B768.if.i.i
B802.loopexit.i.i:
  %.3628.i.i = add nuw nsw i64 %.3559.04776.i.i, 1
  %exitcond4790.not.i.i = icmp eq i64 %.489.fca.9.load.i, %.3628.i.i
  br i1 %exitcond4790.not.i.i, label %B768.loopexit.i.i, label %B802.if.i.i
B1020.i.i:
  %exitcond4792.not.i.i = icmp eq i64 %.2096.i.i, %.489.fca.7.load.i
  br i1 %exitcond4792.not.i.i, label %b94, label %B160.if.i.i
B160.if.i.i:
  %.2024.04782.i.i = phi i64 [ 0, %B160.if.lr.ph.i.i ], [ %.2096.i.i, %B1020.i.i ]
  %.2096.i.i = add nuw nsw i64 %.2024.04782.i.i, 1
  %127 = getelementptr double, ptr %.1129.i, i64 %.2024.04782.i.i
  %.2158.i.i = load double, ptr %127, align 8, !noalias !59
  %.2162.i.i = fcmp ogt double %.2158.i.i, 0.000000e+00
  br i1 %.2162.i.i, label %B200.i.i, label %B1020.i.i
B286.if.i.i4201:
  %.2347.04764.i.i = phi i64 [ 0, %B286.if.lr.ph.i.i4200 ], [ %.2416.i.i, %B442.i9266.i ]
  %.2416.i.i = add nuw nsw i64 %.2347.04764.i.i, 1
  %128 = getelementptr double, ptr %123, i64 %.2347.04764.i.i
  %.2503.i.i = load double, ptr %128, align 8, !noalias !59
  %.2515.i.i = fcmp oeq double %.2503.i.i, 0.000000e+00
  %brmerge.i.i4202 = select i1 %.2515.i.i, i1 true, i1 %.22504757.not.i.i
  br i1 %brmerge.i.i4202, label %B442.i9266.i, label %B372.if.lr.ph.i.i
B372.if.lr.ph.i.i:
  %.2724.i.i = mul i64 %.2347.04764.i.i, %.1345.i
  %129 = getelementptr double, ptr %.1344.i, i64 %.2724.i.i
  br label %B372.if.i.i
B372.if.i.i:
  %.2547.04761.i.i = phi i64 [ 0, %B372.if.lr.ph.i.i ], [ %.2616.i.i, %B372.if.i.i ]
  %.2616.i.i = add nuw nsw i64 %.2547.04761.i.i, 1
  %130 = getelementptr double, ptr %.1878.i.i, i64 %.2547.04761.i.i
  %.2670.i.i = load double, ptr %130, align 8, !noalias !59
  %131 = getelementptr double, ptr %129, i64 %.2547.04761.i.i
  %.2729.i.i = load double, ptr %131, align 8, !noalias !59
  %.2738.i.i = fmul double %.2503.i.i, %.2729.i.i
  %.2739.i.i = fadd double %.2670.i.i, %.2738.i.i
  store double %.2739.i.i, ptr %130, align 8, !noalias !59
  %exitcond4785.not.i.i = icmp eq i64 %.1853.i.i, %.2616.i.i
  br i1 %exitcond4785.not.i.i, label %B442.i9266.i, label %B372.if.i.i
B474.if.i.i:
  %.2808.04770.i.i = phi i64 [ 0, %B474.preheader.i.i ], [ %.2877.i.i, %B474.loopexit.i.i ]
  %.2877.i.i = add nuw nsw i64 %.2808.04770.i.i, 1
  %132 = getelementptr double, ptr %124, i64 %.2808.04770.i.i
  %.2964.i.i = load double, ptr %132, align 8, !noalias !59
  br i1 %.22504757.not.i.i, label %B474.loopexit.i.i, label %B548.if.lr.ph.i.i
B548.if.lr.ph.i.i:
  %.3152.i.i = mul i64 %.2808.04770.i.i, %.1345.i
  %133 = getelementptr double, ptr %.1344.i, i64 %.3152.i.i
  br label %B548.if.i.i
B548.if.i.i:
  %.3005.04767.i.i = phi i64 [ 0, %B548.if.lr.ph.i.i ], [ %.3074.i.i, %B548.if.i.i ]
  %.3074.i.i = add nuw nsw i64 %.3005.04767.i.i, 1
  %134 = getelementptr double, ptr %133, i64 %.3005.04767.i.i
  %.3157.i.i = load double, ptr %134, align 8, !noalias !59
  %135 = getelementptr double, ptr %.1878.i.i, i64 %.3005.04767.i.i
  %.3187.i.i = load double, ptr %135, align 8, !noalias !59
  %.3189.i.i = fmul double %.2964.i.i, %.3187.i.i
  %.3190.i.i = fsub double %.3157.i.i, %.3189.i.i
  store double %.3190.i.i, ptr %134, align 8, !noalias !59
  %exitcond4787.not.i.i = icmp eq i64 %.1853.i.i, %.3074.i.i
  br i1 %exitcond4787.not.i.i, label %B474.loopexit.i.i, label %B548.if.i.i
B768.if.i.i:
  %.3438.04779.i.i = phi i64 [ %.3507.i.i, %B768.loopexit.i.i ], [ 0, %B620.i.i ]
  %.3507.i.i = add nuw nsw i64 %.3438.04779.i.i, 1
  br i1 %.36154775.not.i.i, label %B768.loopexit.i.i, label %B802.if.lr.ph.i.i
B802.if.lr.ph.i.i:
  %.3658.i.i = mul i64 %.3438.04779.i.i, %.489.fca.9.load.i
  %136 = getelementptr double, ptr %.1394.i, i64 %.3658.i.i
  %.3987.i.i = mul i64 %.3438.04779.i.i, %.1444.i
  %137 = getelementptr double, ptr %.1443.i, i64 %.3987.i.i
  br label %B802.if.i.i
B802.if.i.i:
  %.3559.04776.i.i = phi i64 [ 0, %B802.if.lr.ph.i.i ], [ %.3628.i.i, %B802.loopexit.i.i ]
  %.3660.i.i = add nsw i64 %.3559.04776.i.i, %.3658.i.i
  %.3674.i.i = icmp slt i64 %.3660.i.i, 0
  %.3675.i.i = select i1 %.3674.i.i, i64 %.1862.i.i, i64 0
  %138 = getelementptr double, ptr %.1878.i.i, i64 %.3660.i.i
  %.3689.i.i = getelementptr double, ptr %138, i64 %.3675.i.i
  %.3690.i.i = load double, ptr %.3689.i.i, align 8, !noalias !59
  %139 = getelementptr double, ptr %136, i64 %.3559.04776.i.i
  %.3753.i.i = load double, ptr %139, align 8, !noalias !59
  %.3756.i.i = fmul double %.3338.i.i, %.3690.i.i
  %.3757.i.i = fadd double %.3753.i.i, %.3756.i.i
  store double %.3757.i.i, ptr %139, align 8, !noalias !59
  %.3939.i.i = mul nuw nsw i64 %.3559.04776.i.i, %.489.fca.9.load.i
  %invariant.gep.i.i4198 = getelementptr double, ptr %137, i64 %.3939.i.i
  br label %B916.if.i.i
B916.if.i.i:
  %.3836.04773.i.i = phi i64 [ 0, %B802.if.i.i ], [ %.3905.i.i, %B916.if.i.i ]
  %.3905.i.i = add nuw nsw i64 %.3836.04773.i.i, 1
  %gep.i.i4199 = getelementptr double, ptr %invariant.gep.i.i4198, i64 %.3836.04773.i.i
  %.3992.i.i = load double, ptr %gep.i.i4199, align 8, !noalias !59
  %.3996.i.i = add nsw i64 %.3836.04773.i.i, %.3658.i.i
  %.4010.i.i = icmp slt i64 %.3996.i.i, 0
  %.4011.i.i = select i1 %.4010.i.i, i64 %.1862.i.i, i64 0
  %140 = getelementptr double, ptr %.1878.i.i, i64 %.3996.i.i
  %.4025.i.i = getelementptr double, ptr %140, i64 %.4011.i.i
  %.4026.i.i = load double, ptr %.4025.i.i, align 8, !noalias !59
  %.4028.i.i = fmul double %.3690.i.i, %.4026.i.i
  %.4030.i.i = fmul double %.3382.i.i, %.4028.i.i
  %.4031.i.i = fadd double %.3992.i.i, %.4030.i.i
  store double %.4031.i.i, ptr %gep.i.i4199, align 8, !noalias !59
  %exitcond4789.not.i.i = icmp eq i64 %.489.fca.9.load.i, %.3905.i.i
  br i1 %exitcond4789.not.i.i, label %B802.loopexit.i.i, label %B916.if.i.i
B696.i:
  %.54329312.not.i = icmp slt i64 %.265.i, 1
  br i1 %.54329312.not.i, label %b94, label %B760.if.lr.ph.i
B726.loopexit.i:
  %.5445.i = add nuw nsw i64 %.5376.09313.i, 1
  %exitcond9334.not.i = icmp eq i64 %.265.i, %.5445.i
  br i1 %exitcond9334.not.i, label %b94, label %B760.if.lr.ph.i
B214.if.lr.ph.i:
  %.2479.09302.i = phi i64 [ %.2548.i, %B160.loopexit.i ], [ 0, %b95 ]
  %141 = getelementptr double, ptr %.273815371591.i.i, i64 %.2479.09302.i
  store double 0.000000e+00, ptr %141, align 8, !noalias !23
  %.2785.i = mul i64 %.2479.09302.i, %.265.i
  %142 = getelementptr double, ptr %.357.i, i64 %.2785.i
  %143 = getelementptr double, ptr %.856.i.i, i64 %.2785.i
  br label %B214.if.i
B214.if.i:
  %.2638.09299.i = phi i64 [ 0, %B214.if.lr.ph.i ], [ %.2707.i, %B214.if.i ]
  %.2707.i = add nuw nsw i64 %.2638.09299.i, 1
  %144 = getelementptr double, ptr %142, i64 %.2638.09299.i
  %.2790.i = load double, ptr %144, align 8, !noalias !23
  %145 = getelementptr double, ptr %143, i64 %.2638.09299.i
  store double %.2790.i, ptr %145, align 8, !noalias !23
  %exitcond.not.i4207 = icmp eq i64 %.265.i, %.2707.i
  br i1 %exitcond.not.i4207, label %B160.loopexit.i, label %B214.if.i
B450.if.lr.ph.i:
  %.3652.09307.i = phi i64 [ %.3721.i, %B416.loopexit.i ], [ 0, %B416.preheader.i ]
  %.3920.i = mul i64 %.3652.09307.i, %.265.i
  %146 = getelementptr double, ptr %.856.i.i, i64 %.3920.i
  %147 = getelementptr double, ptr %.357.i, i64 %.3920.i
  br label %B450.if.i
B450.if.i:
  %.3773.09304.i = phi i64 [ 0, %B450.if.lr.ph.i ], [ %.3842.i, %B450.if.i ]
  %.3842.i = add nuw nsw i64 %.3773.09304.i, 1
  %148 = getelementptr double, ptr %146, i64 %.3773.09304.i
  %.3925.i = load double, ptr %148, align 8, !noalias !23
  %149 = getelementptr double, ptr %147, i64 %.3773.09304.i
  store double %.3925.i, ptr %149, align 8, !noalias !23
  %exitcond9331.not.i = icmp eq i64 %.265.i, %.3842.i
  br i1 %exitcond9331.not.i, label %B416.loopexit.i, label %B450.if.i
B604.if.i:
  %.4715.09316.i = phi i64 [ %.4784.i, %B604.if.i ], [ 0, %B574.i4197 ]
  %.4784.i = add nuw nsw i64 %.4715.09316.i, 1
  %150 = getelementptr double, ptr %.239514801520.i.i, i64 %.4715.09316.i
  %.4842.i = load double, ptr %150, align 8, !noalias !23
  %151 = getelementptr double, ptr %.316.i, i64 %.4715.09316.i
  store double %.4842.i, ptr %151, align 8, !noalias !23
  %exitcond9335.not.i = icmp eq i64 %.265.i, %.4784.i
  br i1 %exitcond9335.not.i, label %B652.i, label %B604.if.i
B760.if.lr.ph.i:
  %.5376.09313.i = phi i64 [ %.5445.i, %B726.loopexit.i ], [ 0, %B696.i ]
  %.5644.i = mul i64 %.5376.09313.i, %.265.i
  %152 = getelementptr double, ptr %.856.i.i, i64 %.5644.i
  %153 = getelementptr double, ptr %.357.i, i64 %.5644.i
  br label %B760.if.i
B760.if.i:
  %.5497.09310.i = phi i64 [ 0, %B760.if.lr.ph.i ], [ %.5566.i, %B760.if.i ]
  %.5566.i = add nuw nsw i64 %.5497.09310.i, 1
  %154 = getelementptr double, ptr %152, i64 %.5497.09310.i
  %.5649.i = load double, ptr %154, align 8, !noalias !23
  %155 = getelementptr double, ptr %153, i64 %.5497.09310.i
  store double %.5649.i, ptr %155, align 8, !noalias !23
  %exitcond9333.not.i = icmp eq i64 %.265.i, %.5566.i
  br i1 %exitcond9333.not.i, label %B726.loopexit.i, label %B760.if.i
b94:
  %.sink.i = phi i64 [ 4, %B606 ], [ 0, %B652.i ], [ 4, %B696.i ], [ 0, %B1020.i.i ], [ 4, %B726.loopexit.i ]
  call void @llvm.lifetime.end.p0(ptr nonnull %.1601.i)
  br label %B638
B638:
  %status.4.0 = phi i64 [ %.sink.i, %b94 ], [ 0, %B576 ], [ %storemerge.i.ph, %B554.thread4213 ]
  store i64 %status.4.0, ptr %retptr, align 8
  ret void
}
define internal fastcc void @v62(ptr noalias nonnull writeonly %retptr, ptr writeonly %arg.est.5.4, i64 %arg.est.5.5.1, i64 %arg.est.6.2, ptr readonly %arg.est.6.4, ptr readonly %arg.est.7.4, i64 %arg.est.8.2, ptr readonly %arg.est.8.4, ptr readonly %arg.est.9.4, i64 %arg.est.9.5.1, i64 %arg.est.10.2, ptr readonly %arg.est.10.4, ptr writeonly %arg.run.1.0.4, i64 %arg.run.1.0.5.0, i64 %arg.run.6.2, ptr readonly %arg.mean.4, i64 %arg.mean.5.0) unnamed_addr {
entry:
  %.13343620.not = icmp slt i64 %arg.est.8.2, 1
  br i1 %.13343620.not, label %B424, label %B102.if.lr.ph
B102.if.lr.ph:
  %.15093616.not = icmp slt i64 %arg.est.10.2, 1
  %0 = getelementptr double, ptr %arg.est.5.4, i64 %arg.est.5.5.1
  br label %B102.if
B276:
  %value.2.1.lcssa = phi double [ %.1409, %B102.if ], [ %.1685, %B182.if ]
  %.1695 = icmp slt i64 %.1276.03621, %arg.est.6.2
  br i1 %.1695, label %B288, label %B342
B288:
  %1 = getelementptr i64, ptr %arg.est.6.4, i64 %.1276.03621
  %.1767 = load i64, ptr %1, align 8
  %.1786 = icmp slt i64 %.1767, 0
  %.1787 = select i1 %.1786, i64 %arg.run.1.0.5.0, i64 0
  %2 = getelementptr double, ptr %arg.run.1.0.4, i64 %.1767
  %.1801 = getelementptr double, ptr %2, i64 %.1787
  store double %value.2.1.lcssa, ptr %.1801, align 8
  br label %B425
B342:
  %.1816 = sub nsw i64 %.1276.03621, %arg.est.6.2
  %.1846 = getelementptr i64, ptr %arg.est.7.4, i64 %.1816
  %.1847 = load i64, ptr %.1846, align 8
  %.1887 = icmp slt i64 %.1847, 0
  %.1888 = select i1 %.1887, i64 %arg.est.5.5.1, i64 0
  %.1889 = add i64 %.1888, %.1847
  %.1910 = getelementptr double, ptr %arg.est.5.4, i64 %.1889
  store double %value.2.1.lcssa, ptr %.1910, align 8
  %.1976 = getelementptr double, ptr %0, i64 %.1889
  store double %value.2.1.lcssa, ptr %.1976, align 8
  br label %B425
B424:
  store ptr null, ptr %retptr, align 8
  ret void
B425:
  %exitcond3623.not = icmp eq i64 %.1347, %arg.est.8.2
  br i1 %exitcond3623.not, label %B424, label %B102.if
B102.if:
  %.1276.03621 = phi i64 [ 0, %B102.if.lr.ph ], [ %.1347, %B425 ]
  %.1347 = add nuw nsw i64 %.1276.03621, 1
  %3 = getelementptr double, ptr %arg.est.8.4, i64 %.1276.03621
  %.1409 = load double, ptr %3, align 8
  br i1 %.15093616.not, label %B276, label %B182.if.lr.ph
B182.if.lr.ph:
  %.1600 = mul i64 %.1276.03621, %arg.est.9.5.1
  %4 = getelementptr double, ptr %arg.est.9.4, i64 %.1600
  br label %B182.if
B182.if:
  %value.2.13619 = phi double [ %.1409, %B182.if.lr.ph ], [ %.1685, %B182.if ]
  %.1453.03617 = phi i64 [ 0, %B182.if.lr.ph ], [ %.1522, %B182.if ]
  %.1522 = add nuw nsw i64 %.1453.03617, 1
  %5 = getelementptr double, ptr %4, i64 %.1453.03617
  %.1605 = load double, ptr %5, align 8
  %.1614 = add nsw i64 %.1453.03617, %arg.run.6.2
  %.1628 = icmp slt i64 %.1614, 0
  %.1629 = select i1 %.1628, i64 %arg.mean.5.0, i64 0
  %6 = getelementptr double, ptr %arg.mean.4, i64 %.1614
  %.1643 = getelementptr double, ptr %6, i64 %.1629
  %.1644 = load double, ptr %.1643, align 8
  %7 = getelementptr double, ptr %arg.est.10.4, i64 %.1453.03617
  %.1678 = load double, ptr %7, align 8
  %.1682 = fsub double %.1644, %.1678
  %.1683 = fmul double %.1605, %.1682
  %.1685 = fadd double %value.2.13619, %.1683
  %exitcond.not = icmp eq i64 %arg.est.10.2, %.1522
  br i1 %exitcond.not, label %B276, label %B182.if
}
define internal fastcc void @v63(ptr noalias nonnull writeonly %retptr, ptr writeonly %arg.control.0.4, i64 %arg.control.0.5.1, ptr readonly %arg.control.1.4, ptr readonly %arg.scales.4, i64 %arg.scales.5.1, double %arg.relative, ptr readonly %arg.x.4) unnamed_addr {
entry:
  %.193303.not = icmp slt i64 %arg.scales.5.1, 1
  br i1 %.193303.not, label %B330, label %B56.if.lr.ph
B56.if.lr.ph:
  %.idx = shl i64 %arg.scales.5.1, 4
  %0 = getelementptr i8, ptr %arg.scales.4, i64 %.idx
  %.383 = fmul double %arg.relative, 2.500000e-01
  %1 = getelementptr double, ptr %arg.scales.4, i64 %arg.scales.5.1
  %2 = getelementptr double, ptr %arg.control.0.4, i64 %arg.control.0.5.1
  %.idx302 = shl i64 %arg.control.0.5.1, 4
  %3 = getelementptr i8, ptr %arg.control.0.4, i64 %.idx302
  br label %B56.if
B140:
  %.265 = tail call double @llvm.fabs.f64(double %.264)
  br label %B162
B144:
  %4 = getelementptr double, ptr %0, i64 %.135.0304
  %.375 = load double, ptr %4, align 8
  br label %B162
B162:
  %"$phi162.1.2.1" = phi double [ %.265, %B140 ], [ %.375, %B144 ]
  %.437 = getelementptr double, ptr %arg.scales.4, i64 %.135.0304
  %.438 = load double, ptr %.437, align 8
  %.439 = fmul double %.383, %.438
  %.499 = getelementptr double, ptr %arg.control.0.4, i64 %.135.0304
  store double %.439, ptr %.499, align 8
  %.625 = getelementptr double, ptr %1, i64 %.135.0304
  %.626 = load double, ptr %.625, align 8
  %.627 = fmul double %.439, %.626
  %.628 = fmul double %"$phi162.1.2.1", %.627
  %.688 = getelementptr double, ptr %2, i64 %.135.0304
  store double %.628, ptr %.688, align 8
  %.756 = getelementptr double, ptr %3, i64 %.135.0304
  store double %"$phi162.1.2.1", ptr %.756, align 8
  %exitcond.not = icmp eq i64 %.206, %arg.scales.5.1
  br i1 %exitcond.not, label %B330, label %B56.if
B330:
  store ptr null, ptr %retptr, align 8
  ret void
B56.if:
  %.135.0304 = phi i64 [ 0, %B56.if.lr.ph ], [ %.206, %B162 ]
  %.206 = add nuw nsw i64 %.135.0304, 1
  %5 = getelementptr double, ptr %arg.x.4, i64 %.135.0304
  %.264 = load double, ptr %5, align 8
  %6 = getelementptr i8, ptr %arg.control.1.4, i64 %.135.0304
  %.303 = load i8, ptr %6, align 1
  %.307 = icmp ne i8 %.303, 0
  %.310 = fcmp one double %.264, 0.000000e+00
  %or.cond = select i1 %.307, i1 %.310, i1 false
  br i1 %or.cond, label %B140, label %B144
}
define internal fastcc void @v67(ptr noalias nonnull writeonly %retptr, i64 %arg.est.0, i64 %arg.est.3.2, i64 %arg.est.8.2, ptr readonly %arg.est.9.4, i64 %arg.est.9.5.1, i64 %arg.est.10.2, ptr %arg.est.26.4, i64 %arg.est.26.5.1, ptr %arg.est.30.0.4, i64 %arg.est.30.0.5.1, ptr %arg.est.30.1.4, i64 %arg.est.30.1.5.1, ptr %arg.est.30.2.4, ptr %arg.est.30.3.4, i64 %arg.est.30.3.5.0, i64 %arg.est.30.3.5.1, ptr %arg.est.30.4.4, i64 %arg.est.30.4.5.0, i64 %arg.est.30.4.5.1, i64 %arg.run.0.0, i64 %arg.run.0.1, i64 %arg.run.0.2, i64 %arg.run.0.4, ptr %arg.run.1.0.4, i64 %arg.run.1.1.2, ptr %arg.run.1.1.4, ptr readonly %arg.run.1.2.4, i64 %arg.run.1.3.2, ptr %arg.run.1.3.4, ptr %arg.run.1.4.4, ptr readonly %arg.run.2.0.4, i64 %arg.run.2.0.5.1, ptr readonly %arg.run.2.1.4, double %arg.run.2.2, double %arg.run.2.3, i64 %arg.run.5.0.2, ptr %arg.run.5.0.4, ptr %arg.run.5.1.4, i64 %arg.run.5.1.5.0, i64 %arg.run.5.2.2, ptr %arg.run.5.2.4, ptr %arg.run.5.3.4, ptr %arg.run.5.4.4, ptr %arg.run.5.5.4, ptr %arg.run.5.6.4, ptr %arg.run.5.7.4, ptr %arg.run.5.8.4, ptr readonly %arg.run.5.9.4, ptr %arg.run.5.10.4, ptr %arg.run.5.11.4, i64 %arg.run.5.12.2, ptr %arg.run.5.12.4, i64 %arg.run.6.2, ptr %arg.run.6.4, ptr %arg.run.9.4, double %arg.segment.0, double %arg.segment.1, ptr readonly %arg.segment.2.4, i64 %arg.segment.2.5.0, i64 %arg.segment.2.5.1, double %arg.h) unnamed_addr {
entry:
  %.1592.i = alloca ptr, align 8
  %.2807 = alloca i8, align 1
  %.2894 = alloca ptr, align 8
  %.3019 = alloca i8, align 1
  %.3220 = alloca double, align 8
  store double 0.000000e+00, ptr %.3220, align 8
  %.3349 = alloca [2 x double], align 8
  %.fca.1.gep = getelementptr inbounds i8, ptr %.3349, i64 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %.3349, i8 0, i64 16, i1 false)
  %.3485 = alloca double, align 8
  store double 0.000000e+00, ptr %.3485, align 8
  %.3518 = alloca ptr, align 8
  %.3925 = alloca double, align 8
  store double 0.000000e+00, ptr %.3925, align 8
  %.4247 = alloca ptr, align 8
  %.4517 = alloca ptr, align 8
  %.4655 = alloca ptr, align 8
  %.4927 = alloca ptr, align 8
  %.6220 = alloca double, align 8
  store double 0.000000e+00, ptr %.6220, align 8
  %.6430 = alloca double, align 8
  store double 0.000000e+00, ptr %.6430, align 8
  %.6480 = alloca i8, align 1
  store i8 0, ptr %.6480, align 1
  %.6707 = alloca double, align 8
  store double 0.000000e+00, ptr %.6707, align 8
  %.2805 = icmp sgt i64 %arg.run.1.3.2, 0
  store i8 0, ptr %.2807, align 1
  call fastcc void @v70(ptr %.2807, ptr %arg.segment.2.4, i64 %arg.segment.2.5.0, i64 %arg.segment.2.5.1)
  %.2825 = load i8, ptr %.2807, align 1
  %.2828.not = icmp eq i8 %.2825, 0
  call fastcc void @v71(ptr %.2894, i64 %arg.run.5.0.2, ptr %arg.run.5.1.4, i64 %arg.run.5.1.5.0, ptr %arg.segment.2.4, i64 %arg.segment.2.5.1, double %arg.segment.0, double 0.000000e+00)
  br i1 %.2805, label %B258, label %B314
B258:
  call fastcc void @v65(ptr %.3019, i64 %arg.run.0.4, ptr %arg.run.1.0.4, i64 %arg.run.1.1.2, ptr %arg.run.1.1.4, ptr %arg.run.1.2.4, i64 %arg.run.1.3.2, ptr %arg.run.1.3.4, ptr %arg.run.1.4.4, i64 %arg.run.5.0.2, ptr %arg.run.5.0.4, ptr %arg.run.5.3.4, ptr %arg.segment.2.4, i64 %arg.segment.2.5.1, double %arg.segment.0, ptr %arg.run.6.4)
  br label %B314
B314:
  %.3195 = fcmp olt double %arg.segment.0, %arg.segment.1
  br i1 %.3195, label %B328.preheader, label %B2294
B328.preheader:
  %.3733 = getelementptr i8, ptr %arg.run.5.3.4, i64 8
  %.3892 = inttoptr i64 %arg.run.0.1 to ptr
  %.4067 = getelementptr i8, ptr %arg.run.9.4, i64 8
  %.4201 = inttoptr i64 %arg.run.0.2 to ptr
  %0 = getelementptr double, ptr %arg.est.30.0.4, i64 %arg.est.30.0.5.1
  %.idx811.i.i = shl i64 %arg.run.2.0.5.1, 4
  %1 = getelementptr i8, ptr %arg.run.2.0.4, i64 %.idx811.i.i
  %.5645 = mul nuw nsw i64 %arg.run.6.2, %arg.run.6.2
  %.idx10808 = shl i64 %arg.est.30.0.5.1, 4
  %2 = getelementptr i8, ptr %arg.est.30.0.4, i64 %.idx10808
  %.5913 = mul i64 %arg.run.6.2, %arg.est.10.2
  %.599310824.not = icmp slt i64 %.5913, 1
  %.idx = shl i64 %arg.est.30.1.5.1, 4
  %3 = getelementptr i8, ptr %arg.est.30.1.4, i64 %.idx
  br label %B328
B328:
  %h.6.0 = phi double [ %h.7.1, %B2280 ], [ %arg.h, %B328.preheader ]
  %t.2.0 = phi double [ %t.3.1, %B2280 ], [ %arg.segment.0, %B328.preheader ]
  %error_before.2.0 = phi double [ %error_before.3.1, %B2280 ], [ 1.000000e-02, %B328.preheader ]
  %step_before.3.0 = phi double [ %step_before.4.1, %B2280 ], [ 0.000000e+00, %B328.preheader ]
  %rejected.3.0 = phi i1 [ %.4101, %B2280 ], [ false, %B328.preheader ]
  %fresh.3.0 = phi i1 [ %fresh.4.1, %B2280 ], [ true, %B328.preheader ]
  %linear.3.0 = phi i1 [ %linear.4.1, %B2280 ], [ false, %B328.preheader ]
  br i1 %fresh.3.0, label %B332, label %B382
B332:
  call fastcc void @v72(ptr %.3220, i64 %arg.run.0.0, ptr %arg.run.1.0.4, ptr %arg.run.2.0.4, i64 %arg.run.2.0.5.1, i64 %arg.run.5.0.2, ptr %arg.run.5.0.4, i64 %arg.run.5.2.2, ptr %arg.run.5.2.4, ptr %arg.run.5.3.4, ptr %arg.run.5.4.4, ptr %arg.run.5.5.4, ptr %arg.run.5.6.4, ptr %arg.run.6.4, double %arg.segment.1, ptr %arg.segment.2.4, i64 %arg.segment.2.5.1, double %t.2.0, double %h.6.0)
  %.3325 = load double, ptr %.3220, align 8
  br label %B382
B382:
  %h.9.1 = phi double [ %.3325, %B332 ], [ %h.6.0, %B328 ]
  call fastcc void @v73(ptr %.3349, ptr %arg.run.1.1.4, i64 %arg.run.1.3.2, double %arg.run.2.2, double %arg.segment.1, double %h.9.1)
  %.3455.fca.0.load = load double, ptr %.3349, align 8
  %.3455.fca.1.load = load double, ptr %.fca.1.gep, align 8
  %.3483 = fsub double %.3455.fca.1.load, %t.2.0
  call fastcc void @v74(ptr %.3485, double %.3455.fca.0.load, double %.3483)
  %.3499 = load double, ptr %.3485, align 8
  br i1 %.2828.not, label %B536, label %B490
B490:
  call fastcc void @v71(ptr %.3518, i64 %arg.run.5.0.2, ptr %arg.run.5.1.4, i64 %arg.run.5.1.5.0, ptr %arg.segment.2.4, i64 %arg.segment.2.5.1, double %t.2.0, double %.3499)
  br label %B536
B536:
  %.3637 = fmul double %.3483, 0x3FEFFFFFFFFFDCD1
  %.3639 = fcmp ult double %.3499, %.3637
  %.3652 = fadd double %t.2.0, %.3499
  %"$phi572.0.2.1" = select i1 %.3639, double %.3652, double %.3455.fca.1.load
  store double %t.2.0, ptr %arg.run.5.3.4, align 8
  store double %.3499, ptr %.3733, align 8
  tail call void %.3892(ptr nonnull %arg.run.5.3.4, ptr %arg.run.6.4, ptr %arg.run.5.1.4, ptr %arg.run.1.0.4, ptr %arg.run.5.4.4, ptr %arg.run.5.5.4, ptr %arg.run.5.6.4, ptr %arg.run.5.7.4, ptr %arg.run.5.8.4, ptr %arg.run.5.10.4)
  store double 0.000000e+00, ptr %.3925, align 8
  call fastcc void @v75(ptr %.3925, ptr %arg.run.2.0.4, i64 %arg.run.2.0.5.1, ptr %arg.run.2.1.4, ptr %arg.run.5.9.4, ptr %arg.run.5.10.4, ptr %arg.run.6.4)
  %.4026 = load double, ptr %.3925, align 8
  %.4068 = load i64, ptr %.4067, align 8
  %.4069 = add nsw i64 %.4068, 1
  store i64 %.4069, ptr %.4067, align 8
  %.4101 = fcmp ugt double %.4026, 1.000000e+00
  br i1 %.4101, label %for.end, label %B902
B902:
  %.4134 = load i64, ptr %arg.run.9.4, align 8
  %.4135 = add nsw i64 %.4134, 1
  store i64 %.4135, ptr %arg.run.9.4, align 8
  tail call void %.4201(ptr %arg.run.5.8.4, ptr %arg.run.5.11.4)
  br i1 %linear.3.0, label %B1128, label %B1078
B1078:
  call fastcc void @v76(ptr %.4247, i64 %arg.est.0, i64 %arg.est.8.2, ptr %arg.est.9.4, i64 %arg.est.9.5.1, i64 %arg.est.10.2, ptr %arg.est.30.0.4, ptr %arg.est.30.1.4, ptr %arg.est.30.2.4, ptr %arg.run.1.0.4, i64 %arg.run.5.0.2, ptr %arg.run.5.0.4, ptr nonnull %arg.run.5.3.4, i64 %arg.run.6.2, ptr %arg.segment.2.4, i64 %arg.segment.2.5.1, double %t.2.0, ptr %arg.run.6.4)
  br label %B1128
B1128:
  call fastcc void @v77(ptr %.4517, ptr %arg.run.5.11.4, i64 %arg.run.6.2, ptr %arg.run.6.4, ptr %arg.run.5.10.4, i64 %arg.run.5.12.2, ptr %arg.run.5.12.4)
  %.4642 = fmul double %.3499, 5.000000e-01
  %.4644 = fadd double %t.2.0, %.4642
  call fastcc void @v78(ptr %.4655, i64 %arg.est.0, i64 %arg.est.8.2, ptr %arg.est.9.4, i64 %arg.est.9.5.1, i64 %arg.est.10.2, ptr %arg.est.30.0.4, i64 %arg.est.30.0.5.1, ptr %arg.est.30.1.4, i64 %arg.est.30.1.5.1, ptr %arg.est.30.2.4, ptr %arg.run.1.0.4, i64 %arg.run.5.0.2, ptr %arg.run.5.0.4, ptr nonnull %arg.run.5.3.4, i64 %arg.run.6.2, ptr %arg.segment.2.4, i64 %arg.segment.2.5.1, double %.4644, ptr %arg.run.5.12.4)
  call fastcc void @v79(ptr %.4927, i64 %arg.est.0, i64 %arg.est.8.2, ptr %arg.est.9.4, i64 %arg.est.9.5.1, i64 %arg.est.10.2, ptr %arg.est.30.0.4, i64 %arg.est.30.0.5.1, ptr %arg.est.30.1.4, i64 %arg.est.30.1.5.1, ptr %arg.est.30.2.4, ptr %arg.run.1.0.4, i64 %arg.run.5.0.2, ptr %arg.run.5.0.4, ptr nonnull %arg.run.5.3.4, i64 %arg.run.6.2, ptr %arg.segment.2.4, i64 %arg.segment.2.5.1, double %"$phi572.0.2.1", ptr %arg.run.5.10.4)
  call void @llvm.lifetime.start.p0(ptr nonnull %.1592.i)
  br label %B86.if.i.i
B236.i.i:
  %.1469.i.i = add nuw nsw i64 %.1398.0816.i.i, 1
  %.1945.i.i = fmul double %.3499, %.1935.i.i
  %4 = getelementptr double, ptr %1, i64 %.1398.0816.i.i
  %.2004.i.i = load double, ptr %4, align 8, !noalias !62
  %.2008.i.i = fdiv double %.1945.i.i, %.2004.i.i
  %.12.i.i.i = fcmp ogt double %.2008.i.i, %largest.2.0817.i.i
  %.13.i.i.i = select i1 %.12.i.i.i, double %.2008.i.i, double %largest.2.0817.i.i
  %exitcond818.not.i.i = icmp eq i64 %.1469.i.i, %arg.run.6.2
  br i1 %exitcond818.not.i.i, label %b103, label %B86.if.i.i
B86.if.i.i:
  %largest.2.0817.i.i = phi double [ 0.000000e+00, %B1128 ], [ %.13.i.i.i, %B236.i.i ]
  %.1398.0816.i.i = phi i64 [ 0, %B1128 ], [ %.1469.i.i, %B236.i.i ]
  %invariant.gep.i.i = getelementptr double, ptr %0, i64 %.1398.0816.i.i
  br label %B124.if.i.i
B124.if.i.i:
  %total.2.1814.i.i = phi double [ 0.000000e+00, %B86.if.i.i ], [ %.1935.i.i, %B124.if.i.i ]
  %.1524.0812.i.i = phi i64 [ 0, %B86.if.i.i ], [ %.1593.i.i, %B124.if.i.i ]
  %.1593.i.i = add nuw nsw i64 %.1524.0812.i.i, 1
  %.1817.i.i = mul nuw nsw i64 %.1524.0812.i.i, %arg.run.6.2
  %gep.i.i = getelementptr double, ptr %invariant.gep.i.i, i64 %.1817.i.i
  %.1872.i.i = load double, ptr %gep.i.i, align 8, !noalias !62
  %.1878.i.i = tail call double @llvm.fabs.f64(double %.1872.i.i)
  %5 = getelementptr double, ptr %1, i64 %.1524.0812.i.i
  %.1932.i.i = load double, ptr %5, align 8, !noalias !62
  %.1933.i.i = fmul double %.1878.i.i, %.1932.i.i
  %.1935.i.i = fadd double %total.2.1814.i.i, %.1933.i.i
  %exitcond.not.i.i = icmp eq i64 %.1593.i.i, %arg.run.6.2
  br i1 %exitcond.not.i.i, label %B236.i.i, label %B124.if.i.i
b103:
  %.2254.i.i = fcmp olt double %.13.i.i.i, 5.000000e-01
  %..i.i = select i1 %.2254.i.i, i64 1, i64 3
  %.1578.i = uitofp i64 %..i.i to double
  %.1588.i = fdiv double 1.000000e+00, %.1578.i
  br label %B68.if.i
B68.if.i:
  %.1480.01441.i = phi i64 [ 0, %b103 ], [ %.1549.i, %B68.if.i ]
  %.1549.i = add nuw nsw i64 %.1480.01441.i, 1
  %6 = uitofp i64 %.1480.01441.i to double
  %.1582.i = fdiv double %6, %.1578.i
  call fastcc void @v80(ptr %.1592.i, i64 %arg.est.3.2, i64 %arg.est.10.2, ptr %arg.est.26.4, i64 %arg.est.26.5.1, ptr nonnull readonly %arg.est.30.0.4, i64 %arg.est.30.0.5.1, ptr readonly %arg.est.30.1.4, i64 %arg.est.30.1.5.1, ptr %arg.est.30.3.4, i64 %arg.est.30.3.5.0, i64 %arg.est.30.3.5.1, ptr %arg.est.30.4.4, i64 %arg.est.30.4.5.0, i64 %arg.est.30.4.5.1, ptr nonnull readonly %arg.run.2.0.4, i64 %arg.run.2.0.5.1, i64 %arg.run.6.2, double %.3499, double %.1582.i, double %.1588.i)
  %exitcond.not.i = icmp eq i64 %.1549.i, %..i.i
  br i1 %exitcond.not.i, label %b104, label %B68.if.i
b104:
  call void @llvm.lifetime.end.p0(ptr nonnull %.1592.i)
  br label %B1360.if
B1500:
  br i1 %.599310824.not, label %B1612, label %B1556.if
B1612:
  %.12.i = fcmp olt double %.4026, 1.000000e-10
  %.13.i = select i1 %.12.i, double 1.000000e-10, double %.4026
  call fastcc void @v81(ptr %.6220, double %.13.i, double %.3499, double %error_before.2.0, double %step_before.3.0)
  %.6234 = load double, ptr %.6220, align 8
  %.12.i10809 = fcmp ogt double %.13.i, 1.000000e-02
  %.13.i10810 = select i1 %.12.i10809, double %.13.i, double 1.000000e-02
  %.6288 = fcmp olt double %.3499, %.3455.fca.0.load
  br i1 %.6288, label %B1756, label %B1794
B1756:
  %.6294 = fmul double %.3499, %.6234
  %.12.i10811 = fcmp ogt double %.6294, %.3455.fca.0.load
  %.13.i10812 = select i1 %.12.i10811, double %.6294, double %.3455.fca.0.load
  br label %B1838
B1794:
  %.12.i10813 = fcmp olt double %.6234, 1.000000e+00
  %.13.i10814 = select i1 %.12.i10813, double %.6234, double 1.000000e+00
  %"$phi1834.1.2.1" = select i1 %rejected.3.0, double %.13.i10814, double %.6234
  %.6389 = fmul double %.3499, %"$phi1834.1.2.1"
  br label %B1838
B1838:
  %"$phi1838.0.2.1" = phi double [ %.13.i10812, %B1756 ], [ %.6389, %B1794 ]
  br i1 %.2805, label %B1848, label %B2208
B1848:
  call fastcc void @v64(ptr %.6430, double %arg.segment.1)
  %.6444 = load double, ptr %.6430, align 8
  %.6455 = fsub double %arg.segment.1, %.6444
  %.6457 = fcmp olt double %"$phi572.0.2.1", %.6455
  br i1 %.6457, label %B1902, label %B2208
B1902:
  store i8 0, ptr %.6480, align 1
  call fastcc void @v65(ptr %.6480, i64 %arg.run.0.4, ptr %arg.run.1.0.4, i64 %arg.run.1.1.2, ptr %arg.run.1.1.4, ptr %arg.run.1.2.4, i64 %arg.run.1.3.2, ptr %arg.run.1.3.4, ptr %arg.run.1.4.4, i64 %arg.run.5.0.2, ptr %arg.run.5.0.4, ptr nonnull %arg.run.5.3.4, ptr %arg.segment.2.4, i64 %arg.segment.2.5.1, double %"$phi572.0.2.1", ptr nonnull %arg.run.6.4)
  %.6587 = load i8, ptr %.6480, align 1
  %.6590.not = icmp eq i8 %.6587, 0
  br i1 %.6590.not, label %B2208, label %B1958
B1958:
  %.6611 = fneg double %"$phi1838.0.2.1"
  br label %B2208
B2016:
  call fastcc void @v82(ptr %.6707, double %.4026)
  %.6721 = load double, ptr %.6707, align 8
  %.6736 = fdiv double 9.000000e-01, %.6721
  %.12.i10815 = fcmp olt double %.6736, 8.000000e-01
  %.13.i10816 = select i1 %.12.i10815, double %.6736, double 8.000000e-01
  %.12.i10817 = fcmp ogt double %.13.i10816, 1.500000e-01
  %.13.i10818 = select i1 %.12.i10817, double %.13.i10816, double 1.500000e-01
  br label %B2150
B2150:
  %"$phi2150.1.2.2" = phi double [ %.13.i10818, %B2016 ], [ 1.500000e-01, %for.end ]
  %.6804 = fmul double %.3499, %"$phi2150.1.2.2"
  %.6817 = fadd double %t.2.0, %.6804
  %.6819 = fcmp ole double %.6817, %t.2.0
  %.6855 = fcmp olt double %.6804, 1.000000e-300
  %or.cond = or i1 %.6855, %.6819
  br i1 %or.cond, label %common.ret, label %B2208
common.ret:
  %.sink = phi i64 [ 0, %B2294 ], [ 2, %B2150 ], [ 3, %B2208 ]
  %.8499.sink = phi double [ %.8499, %B2294 ], [ 0.000000e+00, %B2150 ], [ 0.000000e+00, %B2208 ]
  store i64 %.sink, ptr %retptr, align 8
  %retptr.repack10805 = getelementptr inbounds i8, ptr %retptr, i64 8
  store double %.8499.sink, ptr %retptr.repack10805, align 8
  ret void
B2208:
  %h.7.1 = phi double [ %.6804, %B2150 ], [ %.6611, %B1958 ], [ %"$phi1838.0.2.1", %B1902 ], [ %"$phi1838.0.2.1", %B1848 ], [ %"$phi1838.0.2.1", %B1838 ]
  %t.3.1 = phi double [ %t.2.0, %B2150 ], [ %"$phi572.0.2.1", %B1958 ], [ %"$phi572.0.2.1", %B1902 ], [ %"$phi572.0.2.1", %B1848 ], [ %"$phi572.0.2.1", %B1838 ]
  %error_before.3.1 = phi double [ %error_before.2.0, %B2150 ], [ %.13.i10810, %B1958 ], [ %.13.i10810, %B1902 ], [ %.13.i10810, %B1848 ], [ %.13.i10810, %B1838 ]
  %step_before.4.1 = phi double [ %step_before.3.0, %B2150 ], [ 0.000000e+00, %B1958 ], [ %.3499, %B1902 ], [ %.3499, %B1848 ], [ %.3499, %B1838 ]
  %linear.4.1 = phi i1 [ %linear.3.0, %B2150 ], [ false, %B1958 ], [ true, %B1902 ], [ true, %B1848 ], [ true, %B1838 ]
  %.7412 = load i64, ptr %.4067, align 8
  %.7438 = sitofp i64 %.7412 to double
  %.7439 = fcmp ugt double %arg.run.2.3, %.7438
  br i1 %.7439, label %B2280, label %common.ret
B2280:
  %fresh.4.1 = xor i1 %.4101, true
  %.7989 = fcmp olt double %t.3.1, %arg.segment.1
  br i1 %.7989, label %B328, label %B2294
B2294:
  %h.10.1 = phi double [ %arg.h, %B314 ], [ %h.7.1, %B2280 ]
  %.8499 = tail call double @llvm.fabs.f64(double %h.10.1)
  br label %common.ret
B1360.if:
  %.5470.010821 = phi i64 [ 0, %b104 ], [ %.5539, %B1360.if ]
  %.5539 = add nuw nsw i64 %.5470.010821, 1
  %7 = getelementptr double, ptr %arg.run.5.10.4, i64 %.5470.010821
  %.5597 = load double, ptr %7, align 8
  %8 = getelementptr double, ptr %arg.run.6.4, i64 %.5470.010821
  store double %.5597, ptr %8, align 8
  %exitcond.not = icmp eq i64 %.5539, %arg.run.6.2
  br i1 %exitcond.not, label %B1444.if, label %B1360.if
B1444.if:
  %.5669.010823 = phi i64 [ %.5738, %B1444.if ], [ 0, %B1360.if ]
  %.5672.010822 = phi i64 [ %.5734, %B1444.if ], [ %.5645, %B1360.if ]
  %.5734 = add nsw i64 %.5672.010822, -1
  %.5738 = add nuw nsw i64 %.5669.010823, 1
  %.5821 = getelementptr double, ptr %2, i64 %.5669.010823
  %.5822 = load double, ptr %.5821, align 8
  %.5886 = getelementptr double, ptr %arg.est.30.0.4, i64 %.5669.010823
  store double %.5822, ptr %.5886, align 8
  %.5725 = icmp sgt i64 %.5672.010822, 1
  br i1 %.5725, label %B1444.if, label %B1500
B1556.if:
  %.5937.010826 = phi i64 [ %.6006, %B1556.if ], [ 0, %B1500 ]
  %.6006 = add nuw nsw i64 %.5937.010826, 1
  %.6089 = getelementptr double, ptr %3, i64 %.5937.010826
  %.6090 = load double, ptr %.6089, align 8
  %.6154 = getelementptr double, ptr %arg.est.30.1.4, i64 %.5937.010826
  store double %.6090, ptr %.6154, align 8
  %exitcond10828.not = icmp eq i64 %.5913, %.6006
  br i1 %exitcond10828.not, label %B1612, label %B1556.if
for.end:
  %.6684.le = fsub double %.4026, %.4026
  %.6685.le = fcmp ord double %.6684.le, 0.000000e+00
  br i1 %.6685.le, label %B2016, label %B2150
}
declare double @llvm.sqrt.f64(double)
define internal fastcc void @v64(ptr noalias nonnull writeonly %retptr, double %arg.t) unnamed_addr {
entry:
  %.5 = fmul double %arg.t, 0x3D06849B86A12B9B
  %.6 = fadd double %.5, 1.000000e-15
  store double %.6, ptr %retptr, align 8
  ret void
}
define internal fastcc void @v65(ptr noalias nonnull writeonly %retptr, i64 %arg.run.0.4, ptr %arg.run.1.0.4, i64 %arg.run.1.1.2, ptr %arg.run.1.1.4, ptr readonly %arg.run.1.2.4, i64 %arg.run.1.3.2, ptr %arg.run.1.3.4, ptr %arg.run.1.4.4, i64 %arg.run.5.0.2, ptr %arg.run.5.0.4, ptr %arg.run.5.3.4, ptr readonly %arg.segment.2.4, i64 %arg.segment.2.5.1, double %arg.t, ptr %arg.x.4) unnamed_addr {
entry:
  %.738 = alloca double, align 8
  %.771 = alloca double, align 8
  %.1095 = alloca ptr, align 8
  %.1582 = alloca double, align 8
  call fastcc void @v64(ptr %.738, double %arg.t)
  %.752 = load double, ptr %.738, align 8
  %.765 = fadd double %arg.t, %.752
  store double 0.000000e+00, ptr %.771, align 8
  call fastcc void @v66(ptr %.771, ptr %arg.run.1.1.4, i64 %arg.run.1.3.2)
  %.795 = load double, ptr %.771, align 8
  %.806 = fcmp ugt double %.795, %.765
  br i1 %.806, label %B626, label %B112.preheader
B112.preheader:
  %.9061552.not = icmp slt i64 %arg.run.1.3.2, 1
  %.1203 = inttoptr i64 %arg.run.0.4 to ptr
  %.13131555.not = icmp slt i64 %arg.run.1.1.2, 1
  br label %B112
B112:
  %changed.4.0 = phi i1 [ %changed.3.1.lcssa, %B586 ], [ false, %B112.preheader ]
  br i1 %.9061552.not, label %B226, label %B162.if
B226:
  store double %arg.t, ptr %arg.run.5.3.4, align 8
  call fastcc void @v83(ptr %.1095, double %arg.t, ptr %arg.segment.2.4, i64 %arg.segment.2.5.1, i64 %arg.run.5.0.2, ptr %arg.run.5.0.4)
  tail call void %.1203(ptr nonnull %arg.run.5.3.4, ptr %arg.x.4, ptr %arg.run.5.0.4, ptr %arg.run.1.0.4, ptr %arg.run.1.3.4, ptr %arg.run.1.4.4)
  br i1 %.13131555.not, label %B586, label %B452.if
B482:
  %0 = getelementptr double, ptr %arg.run.1.1.4, i64 %.1257.01556
  %.1475 = load double, ptr %0, align 8
  %.1479 = fcmp une double %.1523.pre, %.1475
  br i1 %.1479, label %B538, label %B542
B538:
  br label %B542
B542:
  %changed.5.2 = phi i1 [ true, %B538 ], [ %changed.3.11558, %B482 ], [ %changed.3.11558, %B452.if ]
  %1 = getelementptr double, ptr %arg.run.1.1.4, i64 %.1257.01556
  store double %.1523.pre, ptr %1, align 8
  %exitcond1559.not = icmp eq i64 %arg.run.1.1.2, %.1326
  br i1 %exitcond1559.not, label %B586, label %B452.if
B586:
  %changed.3.1.lcssa = phi i1 [ %changed.4.0, %B226 ], [ %changed.5.2, %B542 ]
  store double 0.000000e+00, ptr %.1582, align 8
  call fastcc void @v66(ptr %.1582, ptr %arg.run.1.1.4, i64 %arg.run.1.3.2)
  %.1606 = load double, ptr %.1582, align 8
  %.1617 = fcmp ugt double %.1606, %.765
  br i1 %.1617, label %B626.loopexit, label %B112
B626.loopexit:
  %2 = zext i1 %changed.3.1.lcssa to i8
  br label %B626
B626:
  %changed.2.1 = phi i8 [ 0, %entry ], [ %2, %B626.loopexit ]
  store i8 %changed.2.1, ptr %retptr, align 1
  ret void
B162.if:
  %.850.01553 = phi i64 [ %.919, %B162.if ], [ 0, %B112 ]
  %.919 = add nuw nsw i64 %.850.01553, 1
  %3 = getelementptr double, ptr %arg.run.1.1.4, i64 %.850.01553
  %.981 = load double, ptr %3, align 8
  %.986 = fcmp ugt double %.981, %.765
  %. = select i1 %.986, double 0.000000e+00, double 1.000000e+00
  %4 = getelementptr double, ptr %arg.run.1.3.4, i64 %.850.01553
  store double %., ptr %4, align 8
  %exitcond.not = icmp eq i64 %arg.run.1.3.2, %.919
  br i1 %exitcond.not, label %B226, label %B162.if
B452.if:
  %changed.3.11558 = phi i1 [ %changed.5.2, %B542 ], [ %changed.4.0, %B226 ]
  %.1257.01556 = phi i64 [ %.1326, %B542 ], [ 0, %B226 ]
  %.1326 = add nuw nsw i64 %.1257.01556, 1
  %5 = getelementptr i8, ptr %arg.run.1.2.4, i64 %.1257.01556
  %.1392 = load i8, ptr %5, align 1
  %.1396.not = icmp eq i8 %.1392, 0
  %.phi.trans.insert = getelementptr double, ptr %arg.run.1.4.4, i64 %.1257.01556
  %.1523.pre = load double, ptr %.phi.trans.insert, align 8
  br i1 %.1396.not, label %B542, label %B482
}
define internal fastcc void @v66(ptr noalias nonnull writeonly %retptr, ptr readonly %arg.memory.1.4, i64 %arg.memory.3.2) unnamed_addr {
entry:
  %.164126.not = icmp slt i64 %arg.memory.3.2, 1
  br i1 %.164126.not, label %B138, label %B78.if
B138:
  %first.2.0.lcssa = phi double [ 0x7FF0000000000000, %entry ], [ %.13.i, %B78.if ]
  store double %first.2.0.lcssa, ptr %retptr, align 8
  ret void
B78.if:
  %first.2.0129 = phi double [ %.13.i, %B78.if ], [ 0x7FF0000000000000, %entry ]
  %.106.0128 = phi i64 [ %.177, %B78.if ], [ 0, %entry ]
  %.177 = add nuw nsw i64 %.106.0128, 1
  %0 = getelementptr double, ptr %arg.memory.1.4, i64 %.106.0128
  %.235 = load double, ptr %0, align 8
  %.12.i = fcmp olt double %.235, %first.2.0129
  %.13.i = select i1 %.12.i, double %.235, double %first.2.0129
  %exitcond.not = icmp eq i64 %arg.memory.3.2, %.177
  br i1 %exitcond.not, label %B138, label %B78.if
}
define internal fastcc void @v83(ptr noalias nonnull writeonly %retptr, double %arg.t, ptr readonly %arg.segment.2.4, i64 %arg.segment.2.5.1, i64 %arg.u.2, ptr writeonly %arg.u.4) unnamed_addr {
entry:
  %.555 = alloca double, align 8
  %.148211.not = icmp slt i64 %arg.u.2, 1
  br i1 %.148211.not, label %B284, label %B58.if
B164:
  call fastcc void @v84(ptr %.555, ptr nonnull %1, double %.245)
  %.571 = load double, ptr %.555, align 8
  %.593.le = tail call double @llvm.sin.f64(double %.571)
  %.598 = fmul double %.423, %.593.le
  %.600 = fadd double %.361, %.598
  br label %B272
B272:
  %value.2.1 = phi double [ %.600, %B164 ], [ %.361, %B58.if ]
  %0 = getelementptr double, ptr %arg.u.4, i64 %.90.0212
  store double %value.2.1, ptr %0, align 8
  %exitcond.not = icmp eq i64 %arg.u.2, %.161
  br i1 %exitcond.not, label %B284, label %B58.if
B284:
  store ptr null, ptr %retptr, align 8
  ret void
B58.if:
  %.90.0212 = phi i64 [ %.161, %B272 ], [ 0, %entry ]
  %.161 = add nuw nsw i64 %.90.0212, 1
  %.238 = mul i64 %.90.0212, %arg.segment.2.5.1
  %1 = getelementptr double, ptr %arg.segment.2.4, i64 %.238
  %.242 = getelementptr i8, ptr %1, i64 48
  %.243 = load double, ptr %.242, align 8
  %.245 = fsub double %arg.t, %.243
  %.303 = load double, ptr %1, align 8
  %.357 = getelementptr i8, ptr %1, i64 8
  %.358 = load double, ptr %.357, align 8
  %.360 = fmul double %.245, %.358
  %.361 = fadd double %.303, %.360
  %.422 = getelementptr i8, ptr %1, i64 16
  %.423 = load double, ptr %.422, align 8
  %.424 = fcmp une double %.423, 0.000000e+00
  br i1 %.424, label %B164, label %B272
}
define internal fastcc void @v84(ptr noalias nonnull writeonly %retptr, ptr readonly %arg.c.4, double %arg.dt) unnamed_addr {
entry:
  %.44 = getelementptr i8, ptr %arg.c.4, i64 24
  %.45 = load double, ptr %.44, align 8
  %.73 = getelementptr i8, ptr %arg.c.4, i64 32
  %.74 = load double, ptr %.73, align 8
  %.75 = fmul double %.74, 5.000000e-01
  %.76 = fmul double %arg.dt, %.75
  %.77 = fadd double %.45, %.76
  %.78 = fmul double %arg.dt, %.77
  %.87.le = tail call double @llvm.floor.f64(double %.78)
  %.92 = fsub double %.78, %.87.le
  %.93 = fmul double %.92, 0x401921FB54442D18
  %.121 = getelementptr i8, ptr %arg.c.4, i64 40
  %.122 = load double, ptr %.121, align 8
  %.126 = fadd double %.93, %.122
  store double %.126, ptr %retptr, align 8
  ret void
}
declare double @llvm.sin.f64(double)
declare double @llvm.floor.f64(double)
define internal fastcc void @v70(ptr noalias nonnull writeonly %retptr, ptr readonly %arg.segment.2.4, i64 %arg.segment.2.5.0, i64 %arg.segment.2.5.1) unnamed_addr {
entry:
  %spec.select = tail call i64 @llvm.smax.i64(i64 %arg.segment.2.5.0, i64 0)
  br label %B66
B66:
  %.75.0 = phi i64 [ 0, %entry ], [ %.146, %B108 ]
  %exitcond.not = icmp eq i64 %.75.0, %spec.select
  br i1 %exitcond.not, label %common.ret, label %B66.if
B108:
  %.146 = add nuw i64 %.75.0, 1
  %.303 = getelementptr i8, ptr %0, i64 16
  %.304 = load double, ptr %.303, align 8
  %.310 = fcmp une double %.304, 0.000000e+00
  br i1 %.310, label %common.ret, label %B66
common.ret:
  %storemerge125 = phi i8 [ 1, %B66.if ], [ 1, %B108 ], [ 0, %B66 ]
  store i8 %storemerge125, ptr %retptr, align 1
  ret void
B66.if:
  %.229 = mul i64 %.75.0, %arg.segment.2.5.1
  %0 = getelementptr double, ptr %arg.segment.2.4, i64 %.229
  %.233 = getelementptr i8, ptr %0, i64 8
  %.234 = load double, ptr %.233, align 8
  %.240 = fcmp une double %.234, 0.000000e+00
  br i1 %.240, label %common.ret, label %B108
}
define internal fastcc void @v72(ptr noalias nonnull writeonly %retptr, i64 %arg.run.0.0, ptr %arg.run.1.0.4, ptr readonly %arg.run.2.0.4, i64 %arg.run.2.0.5.1, i64 %arg.run.5.0.2, ptr %arg.run.5.0.4, i64 %arg.run.5.2.2, ptr %arg.run.5.2.4, ptr %arg.run.5.3.4, ptr %arg.run.5.4.4, ptr %arg.run.5.5.4, ptr %arg.run.5.6.4, ptr %arg.run.6.4, double %arg.segment.1, ptr readonly %arg.segment.2.4, i64 %arg.segment.2.5.1, double %arg.t, double %arg.h) unnamed_addr {
entry:
  %.569 = alloca ptr, align 8
  %.611 = alloca ptr, align 8
  %.998 = alloca double, align 8
  store double %arg.t, ptr %arg.run.5.3.4, align 8
  call fastcc void @v83(ptr %.569, double %arg.t, ptr %arg.segment.2.4, i64 %arg.segment.2.5.1, i64 %arg.run.5.0.2, ptr %arg.run.5.0.4)
  call fastcc void @v85(ptr %.611, double %arg.t, ptr %arg.segment.2.4, i64 %arg.segment.2.5.1, i64 %arg.run.5.2.2, ptr %arg.run.5.2.4)
  %.822 = inttoptr i64 %arg.run.0.0 to ptr
  tail call void %.822(ptr nonnull %arg.run.5.3.4, ptr %arg.run.6.4, ptr %arg.run.5.0.4, ptr %arg.run.5.2.4, ptr %arg.run.1.0.4, ptr %arg.run.5.4.4, ptr %arg.run.5.5.4, ptr %arg.run.5.6.4)
  %.849 = fcmp ogt double %arg.h, 0.000000e+00
  br i1 %.849, label %common.ret, label %B298
common.ret:
  %storemerge = phi double [ %arg.h, %entry ], [ %.13.i, %B358 ], [ %.1099, %B298 ]
  store double %storemerge, ptr %retptr, align 8
  ret void
B298:
  %.994 = fsub double %arg.segment.1, %arg.t
  store double 0.000000e+00, ptr %.998, align 8
  call fastcc void @v86(ptr %.998, ptr %arg.run.2.0.4, i64 %arg.run.2.0.5.1, ptr %arg.run.5.4.4, ptr %arg.run.6.4, double %.994)
  %.1099 = load double, ptr %.998, align 8
  %.1231 = fcmp olt double %arg.h, 0.000000e+00
  br i1 %.1231, label %B358, label %common.ret
B358:
  %.1234 = fneg double %arg.h
  %.12.i = fcmp olt double %.1099, %.1234
  %.13.i = select i1 %.12.i, double %.1099, double %.1234
  br label %common.ret
}
define internal fastcc void @v73(ptr noalias nonnull writeonly %retptr, ptr readonly %arg.run.1.1.4, i64 %arg.run.1.3.2, double %arg.run.2.2, double %arg.segment.1, double %arg.h) unnamed_addr {
entry:
  %.739 = alloca double, align 8
  %.793 = alloca double, align 8
  %.598 = icmp sgt i64 %arg.run.1.3.2, 0
  br i1 %.598, label %B112, label %common.ret
B112:
  store double 0.000000e+00, ptr %.739, align 8
  call fastcc void @v66(ptr %.739, ptr %arg.run.1.1.4, i64 %arg.run.1.3.2)
  %.763 = load double, ptr %.739, align 8
  call fastcc void @v64(ptr %.793, double %arg.segment.1)
  %.807 = load double, ptr %.793, align 8
  %.818 = fsub double %arg.segment.1, %.807
  %.820 = fcmp olt double %.763, %.818
  br i1 %.820, label %B196, label %common.ret
B196:
  br label %common.ret
common.ret:
  %arg.segment.1.sink = phi double [ %.763, %B196 ], [ %arg.segment.1, %B112 ], [ %arg.segment.1, %entry ]
  %.12.i = fcmp olt double %arg.run.2.2, %arg.h
  %.13.i = select i1 %.12.i, double %arg.run.2.2, double %arg.h
  store double %.13.i, ptr %retptr, align 8
  %retptr.repack994 = getelementptr inbounds i8, ptr %retptr, i64 8
  store double %arg.segment.1.sink, ptr %retptr.repack994, align 8
  ret void
}
define internal fastcc void @v71(ptr noalias nonnull writeonly %retptr, i64 %arg.run.5.0.2, ptr writeonly %arg.run.5.1.4, i64 %arg.run.5.1.5.0, ptr readonly %arg.segment.2.4, i64 %arg.segment.2.5.1, double %arg.t, double %arg.h) unnamed_addr {
entry:
  %.1038 = alloca ptr, align 8
  br label %B68.if
B202:
  store ptr null, ptr %retptr, align 8
  ret void
B68.if:
  %.616.0583 = phi i64 [ 0, %entry ], [ %.687, %switch.end.endif ]
  %.687 = add nuw nsw i64 %.616.0583, 1
  %switch.gep = getelementptr inbounds double, ptr @v60, i64 %.616.0583
  %switch.load = load double, ptr %switch.gep, align 8
  %.746 = fmul double %arg.h, %switch.load
  %.748 = fadd double %arg.t, %.746
  %.863 = mul nsw i64 %.687, %arg.run.5.0.2
  %.860 = mul nsw i64 %.616.0583, %arg.run.5.0.2
  %.899 = icmp slt i64 %.860, 0
  %.900 = select i1 %.899, i64 %arg.run.5.1.5.0, i64 0
  %.901 = add i64 %.900, %.860
  %.904 = icmp slt i64 %.901, 0
  br i1 %.904, label %switch.end.else.if, label %switch.end.else.endif, !prof !6
switch.end.endif:
  %.889.sroa.13.0 = phi i64 [ %arg.run.5.1.5.0, %switch.end.else.endif.endif.endif.if ], [ %.889.sroa.13.1, %switch.end.else.endif.endif.endif ]
  %.977 = sub i64 %.889.sroa.13.0, %.889.sroa.0.3
  %.986 = tail call i64 @llvm.smax.i64(i64 %.977, i64 0)
  %.1002 = getelementptr double, ptr %arg.run.5.1.4, i64 %.889.sroa.0.3
  call fastcc void @v83(ptr %.1038, double %.748, ptr %arg.segment.2.4, i64 %arg.segment.2.5.1, i64 %.986, ptr %.1002)
  %exitcond.not = icmp eq i64 %.687, 4
  br i1 %exitcond.not, label %B202, label %B68.if
switch.end.else.if:
  br label %switch.end.else.endif
switch.end.else.endif:
  %.889.sroa.0.1 = phi i64 [ 0, %switch.end.else.if ], [ %.901, %B68.if ]
  %.909.not = icmp slt i64 %.901, %arg.run.5.1.5.0
  br i1 %.909.not, label %switch.end.else.endif.endif, label %switch.end.else.endif.if, !prof !7
switch.end.else.endif.if:
  br label %switch.end.else.endif.endif
switch.end.else.endif.endif:
  %.889.sroa.0.3 = phi i64 [ %arg.run.5.1.5.0, %switch.end.else.endif.if ], [ %.889.sroa.0.1, %switch.end.else.endif ]
  %.916 = icmp slt i64 %.863, 0
  %.917 = select i1 %.916, i64 %arg.run.5.1.5.0, i64 0
  %.918 = add i64 %.917, %.863
  %.921 = icmp slt i64 %.918, 0
  br i1 %.921, label %switch.end.else.endif.endif.if, label %switch.end.else.endif.endif.endif, !prof !6
switch.end.else.endif.endif.if:
  br label %switch.end.else.endif.endif.endif
switch.end.else.endif.endif.endif:
  %.889.sroa.13.1 = phi i64 [ 0, %switch.end.else.endif.endif.if ], [ %.918, %switch.end.else.endif.endif ]
  %.926.not = icmp slt i64 %.918, %arg.run.5.1.5.0
  br i1 %.926.not, label %switch.end.endif, label %switch.end.else.endif.endif.endif.if, !prof !7
switch.end.else.endif.endif.endif.if:
  br label %switch.end.endif
}
define internal fastcc void @v75(ptr noalias nonnull writeonly %retptr, ptr readonly %arg.run.2.0.4, i64 %arg.run.2.0.5.1, ptr readonly %arg.run.2.1.4, ptr readonly %arg.run.5.9.4, ptr readonly %arg.run.5.10.4, ptr readonly %arg.run.6.4) unnamed_addr {
entry:
  %.5801419.not = icmp slt i64 %arg.run.2.0.5.1, 1
  br i1 %.5801419.not, label %common.ret, label %B84.if.lr.ph
B84.if.lr.ph:
  %0 = getelementptr double, ptr %arg.run.2.0.4, i64 %arg.run.2.0.5.1
  br label %B84.if
B164:
  %1 = getelementptr i8, ptr %arg.run.2.1.4, i64 %.522.01421
  %.848 = load i8, ptr %1, align 1
  %.852 = icmp ne i8 %.848, 0
  %.855 = fcmp ole double %.760, 0.000000e+00
  %or.cond = and i1 %.852, %.855
  br i1 %or.cond, label %common.ret, label %B240
common.ret:
  %storemerge1418 = phi double [ 0.000000e+00, %entry ], [ %worst.3.1, %B240 ], [ 0x7FF0000000000000, %B84.if ], [ 0x7FF0000000000000, %B164 ]
  store double %storemerge1418, ptr %retptr, align 8
  ret void
B240:
  %2 = getelementptr double, ptr %arg.run.5.9.4, i64 %.522.01421
  %.1135 = load double, ptr %2, align 8
  %.1193 = getelementptr double, ptr %0, i64 %.522.01421
  %.1194 = load double, ptr %.1193, align 8
  %.1248 = getelementptr double, ptr %arg.run.2.0.4, i64 %.522.01421
  %.1249 = load double, ptr %.1248, align 8
  %3 = getelementptr double, ptr %arg.run.6.4, i64 %.522.01421
  %.1284 = load double, ptr %3, align 8
  %.1290 = tail call double @llvm.fabs.f64(double %.1284)
  %.1292 = tail call double @llvm.fabs.f64(double %.760)
  %.12.i = fcmp ogt double %.1292, %.1290
  %.13.i = select i1 %.12.i, double %.1292, double %.1290
  %.1139 = tail call double @llvm.fabs.f64(double %.1135)
  %.1323 = fmul double %.1249, %.13.i
  %.1324 = fadd double %.1194, %.1323
  %.1328 = fdiv double %.1139, %.1324
  %.1334.inv = fcmp ole double %.1328, %worst.2.01422
  %worst.3.1 = select i1 %.1334.inv, double %worst.2.01422, double %.1328
  %exitcond.not = icmp eq i64 %.593, %arg.run.2.0.5.1
  br i1 %exitcond.not, label %common.ret, label %B84.if
B84.if:
  %worst.2.01422 = phi double [ 0.000000e+00, %B84.if.lr.ph ], [ %worst.3.1, %B240 ]
  %.522.01421 = phi i64 [ 0, %B84.if.lr.ph ], [ %.593, %B240 ]
  %.593 = add nuw nsw i64 %.522.01421, 1
  %4 = getelementptr double, ptr %arg.run.5.10.4, i64 %.522.01421
  %.760 = load double, ptr %4, align 8
  %.775.le = fsub double %.760, %.760
  %.776.le = fcmp ord double %.775.le, 0.000000e+00
  br i1 %.776.le, label %B164, label %common.ret
}
define internal fastcc void @v76(ptr noalias nonnull writeonly %retptr, i64 %arg.est.0, i64 %arg.est.8.2, ptr readonly %arg.est.9.4, i64 %arg.est.9.5.1, i64 %arg.est.10.2, ptr %arg.est.30.0.4, ptr %arg.est.30.1.4, ptr %arg.est.30.2.4, ptr %arg.run.1.0.4, i64 %arg.run.5.0.2, ptr %arg.run.5.0.4, ptr %arg.run.5.3.4, i64 %arg.run.6.2, ptr readonly %arg.segment.2.4, i64 %arg.segment.2.5.1, double %arg.t, ptr %arg.x.4) unnamed_addr {
entry:
  %.1823 = alloca ptr, align 8
  store double %arg.t, ptr %arg.run.5.3.4, align 8
  call fastcc void @v83(ptr %.1823, double %arg.t, ptr %arg.segment.2.4, i64 %arg.segment.2.5.1, i64 %arg.run.5.0.2, ptr %arg.run.5.0.4)
  %.2200 = inttoptr i64 %arg.est.0 to ptr
  tail call void %.2200(ptr nonnull %arg.run.5.3.4, ptr %arg.x.4, ptr %arg.run.5.0.4, ptr %arg.run.1.0.4, ptr %arg.est.30.0.4, ptr %arg.est.30.2.4)
  %.23132901.not = icmp slt i64 %arg.est.10.2, 1
  br i1 %.23132901.not, label %B624, label %B314.if.lr.ph
B314.if.lr.ph:
  %.26402896.not = icmp slt i64 %arg.est.8.2, 1
  br label %B314.if
B314.loopexit:
  %exitcond2906.not = icmp eq i64 %.2326, %arg.est.10.2
  br i1 %exitcond2906.not, label %B624, label %B314.if
B390:
  %.2326 = add nuw nsw i64 %.2257.02902, 1
  br i1 %.26402896.not, label %B314.loopexit, label %B440.if.lr.ph
B440.if.lr.ph:
  %invariant.gep = getelementptr double, ptr %arg.est.9.4, i64 %.2257.02902
  %invariant.gep2908 = getelementptr double, ptr %arg.est.30.1.4, i64 %.2481
  br label %B440.if
B620:
  %exitcond2905.not = icmp eq i64 %arg.est.8.2, %.2653
  br i1 %exitcond2905.not, label %B314.loopexit, label %B440.if
B624:
  store ptr null, ptr %retptr, align 8
  ret void
B314.if:
  %.2257.02902 = phi i64 [ 0, %B314.if.lr.ph ], [ %.2326, %B314.loopexit ]
  %.2481 = mul nuw nsw i64 %.2257.02902, %arg.run.6.2
  %invariant.gep2907 = getelementptr double, ptr %arg.est.30.1.4, i64 %.2481
  br label %B348.if
B348.if:
  %.2378.02892 = phi i64 [ 0, %B314.if ], [ %.2447, %B348.if ]
  %.2447 = add nuw nsw i64 %.2378.02892, 1
  %gep = getelementptr double, ptr %invariant.gep2907, i64 %.2378.02892
  store double 0.000000e+00, ptr %gep, align 8
  %exitcond.not = icmp eq i64 %.2447, %arg.run.6.2
  br i1 %exitcond.not, label %B390, label %B348.if
B440.if:
  %.2584.02897 = phi i64 [ 0, %B440.if.lr.ph ], [ %.2653, %B620 ]
  %.2653 = add nuw nsw i64 %.2584.02897, 1
  %.2735 = mul i64 %.2584.02897, %arg.est.9.5.1
  %gep2900 = getelementptr double, ptr %invariant.gep, i64 %.2735
  %.2740 = load double, ptr %gep2900, align 8
  %.2752 = fcmp une double %.2740, 0.000000e+00
  br i1 %.2752, label %B516.preheader, label %B620
B516.preheader:
  %.2944 = mul nuw nsw i64 %.2584.02897, %arg.run.6.2
  %invariant.gep2910 = getelementptr double, ptr %arg.est.30.2.4, i64 %.2944
  br label %B516.if
B516.if:
  %.2778.02894 = phi i64 [ 0, %B516.preheader ], [ %.2847, %B516.if ]
  %.2847 = add nuw nsw i64 %.2778.02894, 1
  %gep2909 = getelementptr double, ptr %invariant.gep2908, i64 %.2778.02894
  %.2936 = load double, ptr %gep2909, align 8
  %gep2911 = getelementptr double, ptr %invariant.gep2910, i64 %.2778.02894
  %.2974 = load double, ptr %gep2911, align 8
  %.2979 = fmul double %.2740, %.2974
  %.2980 = fadd double %.2936, %.2979
  store double %.2980, ptr %gep2909, align 8
  %exitcond2904.not = icmp eq i64 %.2847, %arg.run.6.2
  br i1 %exitcond2904.not, label %B620, label %B516.if
}
define internal fastcc void @v77(ptr noalias nonnull writeonly %retptr, ptr readonly %arg.run.5.11.4, i64 %arg.run.6.2, ptr readonly %arg.run.6.4, ptr readonly %arg.step.3.4, i64 %arg.x.2, ptr writeonly %arg.x.4) unnamed_addr {
entry:
  %.703768.not = icmp slt i64 %arg.x.2, 1
  br i1 %.703768.not, label %B234, label %B102.if.preheader
B102.if.preheader:
  %invariant.gep = getelementptr double, ptr %arg.run.5.11.4, i64 %arg.run.6.2
  br label %B102.if
B234:
  store ptr null, ptr %retptr, align 8
  ret void
B102.if:
  %.645.0769 = phi i64 [ %.716, %B102.if ], [ 0, %B102.if.preheader ]
  %.716 = add nuw nsw i64 %.645.0769, 1
  %0 = getelementptr double, ptr %arg.run.6.4, i64 %.645.0769
  %.774 = load double, ptr %0, align 8
  %.779 = fmul double %.774, 5.000000e-01
  %1 = getelementptr double, ptr %arg.step.3.4, i64 %.645.0769
  %.813 = load double, ptr %1, align 8
  %2 = getelementptr double, ptr %arg.run.5.11.4, i64 %.645.0769
  %.846 = load double, ptr %2, align 8
  %gep = getelementptr double, ptr %invariant.gep, i64 %.645.0769
  %.878 = load double, ptr %gep, align 8
  %.880 = fmul double %.878, 5.000000e-01
  %.881 = fadd double %.846, %.880
  %.883 = fmul double %.881, 5.000000e-01
  %.884 = fadd double %.813, %.883
  %.886 = fmul double %.884, 5.000000e-01
  %.887 = fadd double %.779, %.886
  %3 = getelementptr double, ptr %arg.x.4, i64 %.645.0769
  store double %.887, ptr %3, align 8
  %exitcond.not = icmp eq i64 %arg.x.2, %.716
  br i1 %exitcond.not, label %B234, label %B102.if
}
define internal fastcc void @v82(ptr noalias nonnull writeonly %retptr, double %arg.value) unnamed_addr {
entry:
  %.12.le = tail call double @llvm.sqrt.f64(double %arg.value)
  %.24.le = tail call double @llvm.sqrt.f64(double %.12.le)
  store double %.24.le, ptr %retptr, align 8
  ret void
}
declare double @llvm.fabs.f64(double)
define internal fastcc void @v74(ptr noalias nonnull writeonly %retptr, double %arg.desired, double %arg.remaining) unnamed_addr {
entry:
  %.11 = fmul double %arg.remaining, 5.000000e-01
  %.13 = fcmp olt double %arg.desired, %.11
  %.24 = fcmp olt double %arg.desired, %arg.remaining
  %.11.arg.remaining = select i1 %.24, double %.11, double %arg.remaining
  %storemerge = select i1 %.13, double %arg.desired, double %.11.arg.remaining
  store double %storemerge, ptr %retptr, align 8
  ret void
}
define internal fastcc void @v78(ptr noalias nonnull writeonly %retptr, i64 %arg.est.0, i64 %arg.est.8.2, ptr readonly %arg.est.9.4, i64 %arg.est.9.5.1, i64 %arg.est.10.2, ptr %arg.est.30.0.4, i64 %arg.est.30.0.5.1, ptr %arg.est.30.1.4, i64 %arg.est.30.1.5.1, ptr %arg.est.30.2.4, ptr %arg.run.1.0.4, i64 %arg.run.5.0.2, ptr %arg.run.5.0.4, ptr %arg.run.5.3.4, i64 %arg.run.6.2, ptr readonly %arg.segment.2.4, i64 %arg.segment.2.5.1, double %arg.t, ptr %arg.x.4) unnamed_addr {
entry:
  %.1823 = alloca ptr, align 8
  store double %arg.t, ptr %arg.run.5.3.4, align 8
  call fastcc void @v83(ptr %.1823, double %arg.t, ptr %arg.segment.2.4, i64 %arg.segment.2.5.1, i64 %arg.run.5.0.2, ptr %arg.run.5.0.4)
  %.2122 = getelementptr double, ptr %arg.est.30.0.4, i64 %arg.est.30.0.5.1
  %.2200 = inttoptr i64 %arg.est.0 to ptr
  tail call void %.2200(ptr nonnull %arg.run.5.3.4, ptr %arg.x.4, ptr %arg.run.5.0.4, ptr %arg.run.1.0.4, ptr %.2122, ptr %arg.est.30.2.4)
  %.23132901.not = icmp slt i64 %arg.est.10.2, 1
  br i1 %.23132901.not, label %B624, label %B314.if.lr.ph
B314.if.lr.ph:
  %0 = getelementptr double, ptr %arg.est.30.1.4, i64 %arg.est.30.1.5.1
  %.26402896.not = icmp slt i64 %arg.est.8.2, 1
  br label %B314.if
B314.loopexit:
  %exitcond2906.not = icmp eq i64 %.2326, %arg.est.10.2
  br i1 %exitcond2906.not, label %B624, label %B314.if
B390:
  %.2326 = add nuw nsw i64 %.2257.02902, 1
  br i1 %.26402896.not, label %B314.loopexit, label %B440.if.lr.ph
B440.if.lr.ph:
  %invariant.gep = getelementptr double, ptr %arg.est.9.4, i64 %.2257.02902
  %invariant.gep2908 = getelementptr double, ptr %0, i64 %.2481
  br label %B440.if
B620:
  %exitcond2905.not = icmp eq i64 %arg.est.8.2, %.2653
  br i1 %exitcond2905.not, label %B314.loopexit, label %B440.if
B624:
  store ptr null, ptr %retptr, align 8
  ret void
B314.if:
  %.2257.02902 = phi i64 [ 0, %B314.if.lr.ph ], [ %.2326, %B314.loopexit ]
  %.2481 = mul nuw nsw i64 %.2257.02902, %arg.run.6.2
  %invariant.gep2907 = getelementptr double, ptr %0, i64 %.2481
  br label %B348.if
B348.if:
  %.2378.02892 = phi i64 [ 0, %B314.if ], [ %.2447, %B348.if ]
  %.2447 = add nuw nsw i64 %.2378.02892, 1
  %gep = getelementptr double, ptr %invariant.gep2907, i64 %.2378.02892
  store double 0.000000e+00, ptr %gep, align 8
  %exitcond.not = icmp eq i64 %.2447, %arg.run.6.2
  br i1 %exitcond.not, label %B390, label %B348.if
B440.if:
  %.2584.02897 = phi i64 [ 0, %B440.if.lr.ph ], [ %.2653, %B620 ]
  %.2653 = add nuw nsw i64 %.2584.02897, 1
  %.2735 = mul i64 %.2584.02897, %arg.est.9.5.1
  %gep2900 = getelementptr double, ptr %invariant.gep, i64 %.2735
  %.2740 = load double, ptr %gep2900, align 8
  %.2752 = fcmp une double %.2740, 0.000000e+00
  br i1 %.2752, label %B516.preheader, label %B620
B516.preheader:
  %.2944 = mul nuw nsw i64 %.2584.02897, %arg.run.6.2
  %invariant.gep2910 = getelementptr double, ptr %arg.est.30.2.4, i64 %.2944
  br label %B516.if
B516.if:
  %.2778.02894 = phi i64 [ 0, %B516.preheader ], [ %.2847, %B516.if ]
  %.2847 = add nuw nsw i64 %.2778.02894, 1
  %gep2909 = getelementptr double, ptr %invariant.gep2908, i64 %.2778.02894
  %.2936 = load double, ptr %gep2909, align 8
  %gep2911 = getelementptr double, ptr %invariant.gep2910, i64 %.2778.02894
  %.2974 = load double, ptr %gep2911, align 8
  %.2979 = fmul double %.2740, %.2974
  %.2980 = fadd double %.2936, %.2979
  store double %.2980, ptr %gep2909, align 8
  %exitcond2904.not = icmp eq i64 %.2847, %arg.run.6.2
  br i1 %exitcond2904.not, label %B620, label %B516.if
}
define internal fastcc void @v79(ptr noalias nonnull writeonly %retptr, i64 %arg.est.0, i64 %arg.est.8.2, ptr readonly %arg.est.9.4, i64 %arg.est.9.5.1, i64 %arg.est.10.2, ptr %arg.est.30.0.4, i64 %arg.est.30.0.5.1, ptr %arg.est.30.1.4, i64 %arg.est.30.1.5.1, ptr %arg.est.30.2.4, ptr %arg.run.1.0.4, i64 %arg.run.5.0.2, ptr %arg.run.5.0.4, ptr %arg.run.5.3.4, i64 %arg.run.6.2, ptr readonly %arg.segment.2.4, i64 %arg.segment.2.5.1, double %arg.t, ptr %arg.x.4) unnamed_addr {
entry:
  %.1823 = alloca ptr, align 8
  store double %arg.t, ptr %arg.run.5.3.4, align 8
  call fastcc void @v83(ptr %.1823, double %arg.t, ptr %arg.segment.2.4, i64 %arg.segment.2.5.1, i64 %arg.run.5.0.2, ptr %arg.run.5.0.4)
  %.2122.idx = shl i64 %arg.est.30.0.5.1, 4
  %.2122 = getelementptr i8, ptr %arg.est.30.0.4, i64 %.2122.idx
  %.2200 = inttoptr i64 %arg.est.0 to ptr
  tail call void %.2200(ptr nonnull %arg.run.5.3.4, ptr %arg.x.4, ptr %arg.run.5.0.4, ptr %arg.run.1.0.4, ptr %.2122, ptr %arg.est.30.2.4)
  %.23132902.not = icmp slt i64 %arg.est.10.2, 1
  br i1 %.23132902.not, label %B624, label %B314.if.lr.ph
B314.if.lr.ph:
  %.idx2890 = shl i64 %arg.est.30.1.5.1, 4
  %0 = getelementptr i8, ptr %arg.est.30.1.4, i64 %.idx2890
  %.26402897.not = icmp slt i64 %arg.est.8.2, 1
  br label %B314.if
B314.loopexit:
  %exitcond2907.not = icmp eq i64 %.2326, %arg.est.10.2
  br i1 %exitcond2907.not, label %B624, label %B314.if
B390:
  %.2326 = add nuw nsw i64 %.2257.02903, 1
  br i1 %.26402897.not, label %B314.loopexit, label %B440.if.lr.ph
B440.if.lr.ph:
  %invariant.gep = getelementptr double, ptr %arg.est.9.4, i64 %.2257.02903
  %invariant.gep2909 = getelementptr double, ptr %0, i64 %.2481
  br label %B440.if
B620:
  %exitcond2906.not = icmp eq i64 %arg.est.8.2, %.2653
  br i1 %exitcond2906.not, label %B314.loopexit, label %B440.if
B624:
  store ptr null, ptr %retptr, align 8
  ret void
B314.if:
  %.2257.02903 = phi i64 [ 0, %B314.if.lr.ph ], [ %.2326, %B314.loopexit ]
  %.2481 = mul nuw nsw i64 %.2257.02903, %arg.run.6.2
  %invariant.gep2908 = getelementptr double, ptr %0, i64 %.2481
  br label %B348.if
B348.if:
  %.2378.02893 = phi i64 [ 0, %B314.if ], [ %.2447, %B348.if ]
  %.2447 = add nuw nsw i64 %.2378.02893, 1
  %gep = getelementptr double, ptr %invariant.gep2908, i64 %.2378.02893
  store double 0.000000e+00, ptr %gep, align 8
  %exitcond.not = icmp eq i64 %.2447, %arg.run.6.2
  br i1 %exitcond.not, label %B390, label %B348.if
B440.if:
  %.2584.02898 = phi i64 [ 0, %B440.if.lr.ph ], [ %.2653, %B620 ]
  %.2653 = add nuw nsw i64 %.2584.02898, 1
  %.2735 = mul i64 %.2584.02898, %arg.est.9.5.1
  %gep2901 = getelementptr double, ptr %invariant.gep, i64 %.2735
  %.2740 = load double, ptr %gep2901, align 8
  %.2752 = fcmp une double %.2740, 0.000000e+00
  br i1 %.2752, label %B516.preheader, label %B620
B516.preheader:
  %.2944 = mul nuw nsw i64 %.2584.02898, %arg.run.6.2
  %invariant.gep2911 = getelementptr double, ptr %arg.est.30.2.4, i64 %.2944
  br label %B516.if
B516.if:
  %.2778.02895 = phi i64 [ 0, %B516.preheader ], [ %.2847, %B516.if ]
  %.2847 = add nuw nsw i64 %.2778.02895, 1
  %gep2910 = getelementptr double, ptr %invariant.gep2909, i64 %.2778.02895
  %.2936 = load double, ptr %gep2910, align 8
  %gep2912 = getelementptr double, ptr %invariant.gep2911, i64 %.2778.02895
  %.2974 = load double, ptr %gep2912, align 8
  %.2979 = fmul double %.2740, %.2974
  %.2980 = fadd double %.2936, %.2979
  store double %.2980, ptr %gep2910, align 8
  %exitcond2905.not = icmp eq i64 %.2847, %arg.run.6.2
  br i1 %exitcond2905.not, label %B620, label %B516.if
}
define internal fastcc void @v81(ptr noalias nonnull writeonly %retptr, double %arg.error, double %arg.h, double %arg.error_before, double %arg.step_before) unnamed_addr {
entry:
  %.18 = alloca double, align 8
  %.82 = alloca double, align 8
  call fastcc void @v82(ptr %.18, double %arg.error)
  %.32 = load double, ptr %.18, align 8
  %.47 = fdiv double 9.000000e-01, %.32
  %.56 = fcmp ogt double %arg.step_before, 0.000000e+00
  br i1 %.56, label %B62, label %B160
B62:
  %.72 = fmul double %arg.error, %arg.error
  %.79 = fdiv double %arg.error_before, %.72
  call fastcc void @v82(ptr %.82, double %.79)
  %.96 = load double, ptr %.82, align 8
  %.63 = fdiv double %arg.h, %arg.step_before
  %.68 = fmul double %.63, 9.000000e-01
  %.106 = fmul double %.68, %.96
  %.12.i = fcmp olt double %.106, %.47
  %.13.i = select i1 %.12.i, double %.106, double %.47
  br label %B160
B160:
  %factor.2.0 = phi double [ %.13.i, %B62 ], [ %.47, %entry ]
  %.12.i5 = fcmp ogt double %factor.2.0, 1.500000e-01
  %.13.i6 = select i1 %.12.i5, double %factor.2.0, double 1.500000e-01
  %.12.i7 = fcmp olt double %.13.i6, 6.000000e+00
  %.13.i8 = select i1 %.12.i7, double %.13.i6, double 6.000000e+00
  store double %.13.i8, ptr %retptr, align 8
  ret void
}
define internal fastcc void @v80(ptr noalias nonnull writeonly %retptr, i64 %arg.est.3.2, i64 %arg.est.10.2, ptr %arg.est.26.4, i64 %arg.est.26.5.1, ptr readonly %arg.est.30.0.4, i64 %arg.est.30.0.5.1, ptr readonly %arg.est.30.1.4, i64 %arg.est.30.1.5.1, ptr %arg.est.30.3.4, i64 %arg.est.30.3.5.0, i64 %arg.est.30.3.5.1, ptr %arg.est.30.4.4, i64 %arg.est.30.4.5.0, i64 %arg.est.30.4.5.1, ptr readonly %arg.run.2.0.4, i64 %arg.run.2.0.5.1, i64 %arg.run.6.2, double %arg.h, double %arg.first, double %arg.fraction) unnamed_addr {
entry:
  %.4124.i = alloca ptr, align 8
  %.4678 = alloca ptr, align 8
  %.1331 = fmul double %arg.h, %arg.fraction
  call void @llvm.lifetime.start.p0(ptr nonnull %.4124.i)
  %.idx.i = shl i64 %arg.run.2.0.5.1, 4
  %0 = getelementptr i8, ptr %arg.run.2.0.4, i64 %.idx.i
  %.31.i.i = fcmp oeq double %arg.first, 0.000000e+00
  %.34.i.i = fcmp oeq double %arg.first, 1.000000e+00
  %or.cond.i.i = or i1 %.31.i.i, %.34.i.i
  %.182.i.i = fmul double %arg.first, 2.000000e+00
  %.183.i.i = fsub double 1.000000e+00, %.182.i.i
  %.185.i.i = fsub double 1.000000e+00, %arg.first
  %.186.i.i = fmul double %.185.i.i, %.183.i.i
  %.188.i.i = fmul double %arg.first, 4.000000e+00
  %.191.i.i = fmul double %.188.i.i, %.185.i.i
  %.194.i.i = fadd double %.182.i.i, -1.000000e+00
  %.196.i.i = fmul double %arg.first, %.194.i.i
  %1 = getelementptr double, ptr %arg.est.30.0.4, i64 %arg.est.30.0.5.1
  %.idx.i.i = shl i64 %arg.est.30.0.5.1, 4
  %2 = getelementptr i8, ptr %arg.est.30.0.4, i64 %.idx.i.i
  %.sink143.idx.i.i = select i1 %.31.i.i, i64 0, i64 %.idx.i.i
  %.sink143.i.i = getelementptr i8, ptr %arg.est.30.0.4, i64 %.sink143.idx.i.i
  %.33442659.not.i = icmp sgt i64 %arg.est.3.2, 0
  %.36072662.not.i = icmp sgt i64 %arg.est.10.2, 0
  %3 = getelementptr double, ptr %arg.est.30.1.4, i64 %arg.est.30.1.5.1
  %.idx.i2640.i = shl i64 %arg.est.30.1.5.1, 4
  %4 = getelementptr i8, ptr %arg.est.30.1.4, i64 %.idx.i2640.i
  %.sink143.idx.i2650.i = select i1 %.31.i.i, i64 0, i64 %.idx.i2640.i
  %.sink143.i2651.i = getelementptr i8, ptr %arg.est.30.1.4, i64 %.sink143.idx.i2650.i
  %.idx2670.i = shl i64 %arg.run.6.2, 4
  %.idx2671.i = mul i64 %arg.run.6.2, 24
  br label %B128.if.i
B126.loopexit.i:
  %exitcond2669.not.i = icmp eq i64 %.2709.i, %arg.run.6.2
  br i1 %exitcond2669.not.i, label %b105, label %B128.if.i
B294.i:
  %.2709.i = add nuw nsw i64 %.2637.02666.i, 1
  %5 = getelementptr double, ptr %9, i64 %.2637.02666.i
  %.3138.i = load double, ptr %5, align 8, !noalias !67
  %.3140.i = fmul double %.2795.i, 3.000000e+00
  %.3141.i = fadd double %.3140.i, %.3138.i
  store double %.3141.i, ptr %5, align 8, !noalias !67
  %6 = getelementptr double, ptr %5, i64 %arg.run.6.2
  store double %.2795.i, ptr %6, align 8, !noalias !67
  br i1 %.33442659.not.i, label %B406.if.lr.ph.i, label %B476.i
B406.if.lr.ph.i:
  %.3383.i = fmul double %.2795.i, 6.000000e+00
  %.3437.i = mul i64 %.2637.02666.i, %arg.est.26.5.1
  %7 = getelementptr double, ptr %arg.est.26.4, i64 %.3437.i
  %invariant.gep2672.i = getelementptr i8, ptr %9, i64 %.idx2670.i
  br label %B406.if.i
B476.i:
  br i1 %.36072662.not.i, label %B526.if.lr.ph.i, label %B126.loopexit.i
B526.if.lr.ph.i:
  %.3703.i = fmul double %.1331, %.2795.i
  %invariant.gep2674.i = getelementptr i8, ptr %9, i64 %.idx2671.i
  br label %B526.if.i
B128.if.i:
  %.2637.02666.i = phi i64 [ 0, %entry ], [ %.2709.i, %B126.loopexit.i ]
  %8 = getelementptr double, ptr %0, i64 %.2637.02666.i
  %.2791.i = load double, ptr %8, align 8, !noalias !67
  %.2795.i = fdiv double 1.000000e+00, %.2791.i
  %.2918.i = fneg double %.2795.i
  %.2920.i = fmul double %.1331, %.2918.i
  %.3015.i = mul i64 %.2637.02666.i, %arg.est.30.3.5.1
  %9 = getelementptr double, ptr %arg.est.30.3.4, i64 %.3015.i
  %invariant.gep.i = getelementptr double, ptr %9, i64 %arg.run.6.2
  br label %B188.if.i
B188.if.i:
  %.2823.02657.i = phi i64 [ 0, %B128.if.i ], [ %.2892.i, %b106 ]
  %.2892.i = add nuw nsw i64 %.2823.02657.i, 1
  %.2930.i = mul nuw nsw i64 %.2823.02657.i, %arg.run.6.2
  %.2932.i = add nuw nsw i64 %.2930.i, %.2637.02666.i
  br i1 %or.cond.i.i, label %B28.i.i, label %B80.i.i
B28.i.i:
  %10 = getelementptr double, ptr %.sink143.i.i, i64 %.2932.i
  %"$phi78.0.2.0.i.i" = load double, ptr %10, align 8, !noalias !70
  br label %b106
B80.i.i:
  %.252.i.i = getelementptr double, ptr %arg.est.30.0.4, i64 %.2932.i
  %.253.i.i = load double, ptr %.252.i.i, align 8, !noalias !70
  %.254.i.i = fmul double %.186.i.i, %.253.i.i
  %.308.i.i = getelementptr double, ptr %1, i64 %.2932.i
  %.309.i.i = load double, ptr %.308.i.i, align 8, !noalias !70
  %.310.i.i = fmul double %.191.i.i, %.309.i.i
  %.311.i.i = fadd double %.254.i.i, %.310.i.i
  %.367.i.i = getelementptr double, ptr %2, i64 %.2932.i
  %.368.i.i = load double, ptr %.367.i.i, align 8, !noalias !70
  %.376.i.i = fmul double %.196.i.i, %.368.i.i
  %.377.i.i = fadd double %.311.i.i, %.376.i.i
  br label %b106
b106:
  %storemerge.i.i = phi double [ %.377.i.i, %B80.i.i ], [ %"$phi78.0.2.0.i.i", %B28.i.i ]
  %.2967.i = fmul double %.2920.i, %storemerge.i.i
  %11 = getelementptr double, ptr %9, i64 %.2823.02657.i
  store double %.2967.i, ptr %11, align 8, !noalias !67
  %gep.i = getelementptr double, ptr %invariant.gep.i, i64 %.2823.02657.i
  store double 0.000000e+00, ptr %gep.i, align 8, !noalias !67
  %exitcond.not.i = icmp eq i64 %.2892.i, %arg.run.6.2
  br i1 %exitcond.not.i, label %B294.i, label %B188.if.i
B406.if.i:
  %.3288.02660.i = phi i64 [ 0, %B406.if.lr.ph.i ], [ %.3357.i, %B406.if.i ]
  %.3357.i = add nuw nsw i64 %.3288.02660.i, 1
  %12 = getelementptr double, ptr %7, i64 %.3288.02660.i
  %.3442.i = load double, ptr %12, align 8, !noalias !67
  %.3450.i = fmul double %.3383.i, %.3442.i
  %gep2673.i = getelementptr double, ptr %invariant.gep2672.i, i64 %.3288.02660.i
  store double %.3450.i, ptr %gep2673.i, align 8, !noalias !67
  %exitcond2667.not.i = icmp eq i64 %arg.est.3.2, %.3357.i
  br i1 %exitcond2667.not.i, label %B476.i, label %B406.if.i
B526.if.i:
  %.3551.02663.i = phi i64 [ 0, %B526.if.lr.ph.i ], [ %.3620.i, %b107 ]
  %.3620.i = add nuw nsw i64 %.3551.02663.i, 1
  %gep2675.i = getelementptr double, ptr %invariant.gep2674.i, i64 %.3551.02663.i
  %.3700.i = load double, ptr %gep2675.i, align 8, !noalias !67
  %.3713.i = mul nuw nsw i64 %.3551.02663.i, %arg.run.6.2
  %.3715.i = add nuw nsw i64 %.3713.i, %.2637.02666.i
  br i1 %or.cond.i.i, label %B28.i2646.i, label %B80.i2621.i
B28.i2646.i:
  %13 = getelementptr double, ptr %.sink143.i2651.i, i64 %.3715.i
  %"$phi78.0.2.0.i2653.i" = load double, ptr %13, align 8, !noalias !73
  br label %b107
B80.i2621.i:
  %.252.i2633.i = getelementptr double, ptr %arg.est.30.1.4, i64 %.3715.i
  %.253.i2634.i = load double, ptr %.252.i2633.i, align 8, !noalias !73
  %.254.i2635.i = fmul double %.186.i.i, %.253.i2634.i
  %.308.i2636.i = getelementptr double, ptr %3, i64 %.3715.i
  %.309.i2637.i = load double, ptr %.308.i2636.i, align 8, !noalias !73
  %.310.i2638.i = fmul double %.191.i.i, %.309.i2637.i
  %.311.i2639.i = fadd double %.254.i2635.i, %.310.i2638.i
  %.367.i2641.i = getelementptr double, ptr %4, i64 %.3715.i
  %.368.i2642.i = load double, ptr %.367.i2641.i, align 8, !noalias !73
  %.376.i2643.i = fmul double %.196.i.i, %.368.i2642.i
  %.377.i2644.i = fadd double %.311.i2639.i, %.376.i2643.i
  br label %b107
b107:
  %storemerge.i2645.i = phi double [ %.377.i2644.i, %B80.i2621.i ], [ %"$phi78.0.2.0.i2653.i", %B28.i2646.i ]
  %.3750.i = fmul double %.3703.i, %storemerge.i2645.i
  %.3751.i = fadd double %.3700.i, %.3750.i
  store double %.3751.i, ptr %gep2675.i, align 8, !noalias !67
  %exitcond2668.not.i = icmp eq i64 %arg.est.10.2, %.3620.i
  br i1 %exitcond2668.not.i, label %B126.loopexit.i, label %B526.if.i
b105:
  %.2266 = fmul double %arg.fraction, 5.000000e-01
  %.2267 = fadd double %arg.first, %.2266
  %.2268 = fadd double %arg.first, %arg.fraction
  call fastcc void @v87(ptr %.4124.i, ptr nonnull %arg.est.30.3.4, i64 %arg.est.30.3.5.0, i64 %arg.est.30.3.5.1, i64 %arg.run.6.2)
  call void @llvm.lifetime.end.p0(ptr nonnull %.4124.i)
  %.31.i = fcmp oeq double %.2267, 0.000000e+00
  %.34.i = fcmp oeq double %.2267, 1.000000e+00
  %or.cond.i = or i1 %.31.i, %.34.i
  %.31.i3681 = fcmp oeq double %.2268, 0.000000e+00
  %.34.i3682 = fcmp oeq double %.2268, 1.000000e+00
  %or.cond.i3683 = or i1 %.31.i3681, %.34.i3682
  %.182.i = fmul double %.2267, 2.000000e+00
  %.183.i = fsub double 1.000000e+00, %.182.i
  %.185.i = fsub double 1.000000e+00, %.2267
  %.186.i = fmul double %.185.i, %.183.i
  %.188.i = fmul double %.2267, 4.000000e+00
  %.191.i = fmul double %.188.i, %.185.i
  %.194.i = fadd double %.182.i, -1.000000e+00
  %.196.i = fmul double %.2267, %.194.i
  %.sink143.idx.i = select i1 %.31.i, i64 0, i64 %.idx.i.i
  %.sink143.i = getelementptr i8, ptr %arg.est.30.0.4, i64 %.sink143.idx.i
  %.182.i3685 = fmul double %.2268, 2.000000e+00
  %.183.i3686 = fsub double 1.000000e+00, %.182.i3685
  %.185.i3687 = fsub double 1.000000e+00, %.2268
  %.186.i3688 = fmul double %.185.i3687, %.183.i3686
  %.188.i3689 = fmul double %.2268, 4.000000e+00
  %.191.i3690 = fmul double %.188.i3689, %.185.i3687
  %.194.i3691 = fadd double %.182.i3685, -1.000000e+00
  %.196.i3692 = fmul double %.2268, %.194.i3691
  %.sink143.idx.i3713 = select i1 %.31.i3681, i64 0, i64 %.idx.i.i
  %.sink143.i3714 = getelementptr i8, ptr %arg.est.30.0.4, i64 %.sink143.idx.i3713
  %.3914 = shl nuw nsw i64 %arg.run.6.2, 1
  %.4229 = mul nuw nsw i64 %arg.run.6.2, 3
  %.sink143.idx.i3750 = select i1 %.31.i, i64 0, i64 %.idx.i2640.i
  %.sink143.i3751 = getelementptr i8, ptr %arg.est.30.1.4, i64 %.sink143.idx.i3750
  %.sink143.idx.i3787 = select i1 %.31.i3681, i64 0, i64 %.idx.i2640.i
  %.sink143.i3788 = getelementptr i8, ptr %arg.est.30.1.4, i64 %.sink143.idx.i3787
  br label %B210.if
B208.loopexit:
  %exitcond3813.not = icmp eq i64 %.2847, %arg.run.6.2
  br i1 %exitcond3813.not, label %B1138, label %B210.if
B548:
  %.2847 = add nuw nsw i64 %.2777.03805, 1
  %.3508 = getelementptr double, ptr %17, i64 %.3284
  %.3509 = load double, ptr %.3508, align 8
  %.3511 = fadd double %.2933, %.3509
  store double %.3511, ptr %.3508, align 8
  %14 = getelementptr double, ptr %18, i64 %.2777.03805
  %.3617 = load double, ptr %14, align 8
  %.3619 = fmul double %.2933, 4.000000e+00
  %.3620 = fsub double %.3617, %.3619
  store double %.3620, ptr %14, align 8
  %.3727 = getelementptr double, ptr %18, i64 %.3284
  %.3728 = load double, ptr %.3727, align 8
  %.3730 = fmul double %.2933, 3.000000e+00
  %.3731 = fadd double %.3730, %.3728
  store double %.3731, ptr %.3727, align 8
  br i1 %.33442659.not.i, label %B742.if, label %B848
B848:
  br i1 %.36072662.not.i, label %B898.if.lr.ph, label %B208.loopexit
B898.if.lr.ph:
  %.4286 = fmul double %.1331, %.2933
  br label %B898.if
B1138:
  call fastcc void @v87(ptr %.4678, ptr nonnull %arg.est.30.4.4, i64 %arg.est.30.4.5.0, i64 %arg.est.30.4.5.1, i64 %arg.run.6.2)
  %.49203806.not = icmp slt i64 %arg.est.3.2, 1
  %invariant.gep3816 = getelementptr double, ptr %arg.est.30.4.4, i64 %.3914
  br label %B1200.if
B1200.loopexit:
  %exitcond3815.not = icmp eq i64 %.4799, %arg.run.6.2
  br i1 %exitcond3815.not, label %B1320, label %B1200.if
B1320:
  store ptr null, ptr %retptr, align 8
  ret void
B210.if:
  %.2777.03805 = phi i64 [ 0, %b105 ], [ %.2847, %B208.loopexit ]
  %15 = getelementptr double, ptr %0, i64 %.2777.03805
  %.2929 = load double, ptr %15, align 8
  %.2933 = fdiv double 1.000000e+00, %.2929
  %.3104 = mul i64 %.2777.03805, %arg.est.30.3.5.1
  %16 = getelementptr double, ptr %arg.est.30.3.4, i64 %.3104
  %.3211 = mul i64 %.2777.03805, %arg.est.30.4.5.1
  %17 = getelementptr double, ptr %arg.est.30.4.4, i64 %.3211
  %.3220 = fneg double %.2933
  %.3280 = fmul double %.2933, -4.000000e+00
  %.3284 = add nuw nsw i64 %.2777.03805, %arg.run.6.2
  %.3331 = mul i64 %.3284, %arg.est.30.4.5.1
  %18 = getelementptr double, ptr %arg.est.30.4.4, i64 %.3331
  br label %B270.if
B270.if:
  %.2961.03797 = phi i64 [ 0, %B210.if ], [ %.3030, %b108 ]
  %.3030 = add nuw nsw i64 %.2961.03797, 1
  %.3056 = add nuw nsw i64 %.2961.03797, %arg.run.6.2
  %19 = getelementptr double, ptr %16, i64 %.3056
  %.3109 = load double, ptr %19, align 8
  %.3122 = mul nuw nsw i64 %.2961.03797, %arg.run.6.2
  %.3124 = add nuw nsw i64 %.3122, %.2777.03805
  br i1 %or.cond.i, label %B28.i, label %B80.i
B28.i:
  %20 = getelementptr double, ptr %.sink143.i, i64 %.3124
  %"$phi78.0.2.0.i" = load double, ptr %20, align 8, !noalias !76
  br label %b109
B80.i:
  %.252.i = getelementptr double, ptr %arg.est.30.0.4, i64 %.3124
  %.253.i = load double, ptr %.252.i, align 8, !noalias !76
  %.254.i = fmul double %.186.i, %.253.i
  %.308.i = getelementptr double, ptr %1, i64 %.3124
  %.309.i = load double, ptr %.308.i, align 8, !noalias !76
  %.310.i = fmul double %.191.i, %.309.i
  %.311.i = fadd double %.254.i, %.310.i
  %.367.i = getelementptr double, ptr %2, i64 %.3124
  %.368.i = load double, ptr %.367.i, align 8, !noalias !76
  %.376.i = fmul double %.196.i, %.368.i
  %.377.i = fadd double %.311.i, %.376.i
  br label %b109
b109:
  %storemerge.i = phi double [ %.377.i, %B80.i ], [ %"$phi78.0.2.0.i", %B28.i ]
  %.3112 = fmul double %.3109, 4.000000e+00
  %.3160 = fmul double %.1331, %storemerge.i
  %.3161 = fsub double %.3112, %.3160
  %.3163 = fmul double %.2933, %.3161
  %.3215 = getelementptr double, ptr %17, i64 %.2961.03797
  store double %.3163, ptr %.3215, align 8
  %.3221 = fmul double %.3109, %.3220
  %.3275 = getelementptr double, ptr %17, i64 %.3056
  store double %.3221, ptr %.3275, align 8
  %.3281 = fmul double %.3280, %.3109
  %.3335 = getelementptr double, ptr %18, i64 %.2961.03797
  store double %.3281, ptr %.3335, align 8
  br i1 %or.cond.i3683, label %B28.i3709, label %B80.i3684
B28.i3709:
  %21 = getelementptr double, ptr %.sink143.i3714, i64 %.3124
  %"$phi78.0.2.0.i3716" = load double, ptr %21, align 8, !noalias !79
  br label %b108
B80.i3684:
  %.252.i3696 = getelementptr double, ptr %arg.est.30.0.4, i64 %.3124
  %.253.i3697 = load double, ptr %.252.i3696, align 8, !noalias !79
  %.254.i3698 = fmul double %.186.i3688, %.253.i3697
  %.308.i3699 = getelementptr double, ptr %1, i64 %.3124
  %.309.i3700 = load double, ptr %.308.i3699, align 8, !noalias !79
  %.310.i3701 = fmul double %.191.i3690, %.309.i3700
  %.311.i3702 = fadd double %.254.i3698, %.310.i3701
  %.367.i3704 = getelementptr double, ptr %2, i64 %.3124
  %.368.i3705 = load double, ptr %.367.i3704, align 8, !noalias !79
  %.376.i3706 = fmul double %.196.i3692, %.368.i3705
  %.377.i3707 = fadd double %.311.i3702, %.376.i3706
  br label %b108
b108:
  %storemerge.i3708 = phi double [ %.377.i3707, %B80.i3684 ], [ %"$phi78.0.2.0.i3716", %B28.i3709 ]
  %.3386 = fmul double %.1331, %storemerge.i3708
  %.3387 = fsub double %.3109, %.3386
  %.3389 = fmul double %.2933, %.3387
  %.3445 = getelementptr double, ptr %18, i64 %.3056
  store double %.3389, ptr %.3445, align 8
  %exitcond.not = icmp eq i64 %.3030, %arg.run.6.2
  br i1 %exitcond.not, label %B548, label %B270.if
B742.if:
  %.3819.03799 = phi i64 [ %.3888, %B742.if ], [ 0, %B548 ]
  %.3888 = add nuw nsw i64 %.3819.03799, 1
  %.3915 = add nuw nsw i64 %.3819.03799, %.3914
  %22 = getelementptr double, ptr %16, i64 %.3915
  %.3968 = load double, ptr %22, align 8
  %.3972 = fmul double %.2933, %.3968
  %.3973 = fneg double %.3972
  %.4028 = getelementptr double, ptr %17, i64 %.3915
  store double %.3972, ptr %.4028, align 8
  %.4088 = getelementptr double, ptr %18, i64 %.3915
  store double %.3973, ptr %.4088, align 8
  %exitcond3811.not = icmp eq i64 %arg.est.3.2, %.3888
  br i1 %exitcond3811.not, label %B848, label %B742.if
B898.if:
  %.4134.03802 = phi i64 [ 0, %B898.if.lr.ph ], [ %.4203, %b110 ]
  %.4203 = add nuw nsw i64 %.4134.03802, 1
  %.4230 = add nuw nsw i64 %.4134.03802, %.4229
  %.4282 = getelementptr double, ptr %17, i64 %.4230
  %.4283 = load double, ptr %.4282, align 8
  %.4296 = mul nuw nsw i64 %.4134.03802, %arg.run.6.2
  %.4298 = add nuw nsw i64 %.4296, %.2777.03805
  br i1 %or.cond.i, label %B28.i3746, label %B80.i3721
B28.i3746:
  %23 = getelementptr double, ptr %.sink143.i3751, i64 %.4298
  %"$phi78.0.2.0.i3753" = load double, ptr %23, align 8, !noalias !82
  br label %b111
B80.i3721:
  %.252.i3733 = getelementptr double, ptr %arg.est.30.1.4, i64 %.4298
  %.253.i3734 = load double, ptr %.252.i3733, align 8, !noalias !82
  %.254.i3735 = fmul double %.186.i, %.253.i3734
  %.308.i3736 = getelementptr double, ptr %3, i64 %.4298
  %.309.i3737 = load double, ptr %.308.i3736, align 8, !noalias !82
  %.310.i3738 = fmul double %.191.i, %.309.i3737
  %.311.i3739 = fadd double %.254.i3735, %.310.i3738
  %.367.i3741 = getelementptr double, ptr %4, i64 %.4298
  %.368.i3742 = load double, ptr %.367.i3741, align 8, !noalias !82
  %.376.i3743 = fmul double %.196.i, %.368.i3742
  %.377.i3744 = fadd double %.311.i3739, %.376.i3743
  br label %b111
b111:
  %storemerge.i3745 = phi double [ %.377.i3744, %B80.i3721 ], [ %"$phi78.0.2.0.i3753", %B28.i3746 ]
  %.4333 = fmul double %.4286, %storemerge.i3745
  %.4334 = fadd double %.4283, %.4333
  store double %.4334, ptr %.4282, align 8
  %.4441 = getelementptr double, ptr %18, i64 %.4230
  %.4442 = load double, ptr %.4441, align 8
  br i1 %or.cond.i3683, label %B28.i3783, label %B80.i3758
B28.i3783:
  %24 = getelementptr double, ptr %.sink143.i3788, i64 %.4298
  %"$phi78.0.2.0.i3790" = load double, ptr %24, align 8, !noalias !85
  br label %b110
B80.i3758:
  %.252.i3770 = getelementptr double, ptr %arg.est.30.1.4, i64 %.4298
  %.253.i3771 = load double, ptr %.252.i3770, align 8, !noalias !85
  %.254.i3772 = fmul double %.186.i3688, %.253.i3771
  %.308.i3773 = getelementptr double, ptr %3, i64 %.4298
  %.309.i3774 = load double, ptr %.308.i3773, align 8, !noalias !85
  %.310.i3775 = fmul double %.191.i3690, %.309.i3774
  %.311.i3776 = fadd double %.254.i3772, %.310.i3775
  %.367.i3778 = getelementptr double, ptr %4, i64 %.4298
  %.368.i3779 = load double, ptr %.367.i3778, align 8, !noalias !85
  %.376.i3780 = fmul double %.196.i3692, %.368.i3779
  %.377.i3781 = fadd double %.311.i3776, %.376.i3780
  br label %b110
b110:
  %storemerge.i3782 = phi double [ %.377.i3781, %B80.i3758 ], [ %"$phi78.0.2.0.i3790", %B28.i3783 ]
  %.4492 = fmul double %.4286, %storemerge.i3782
  %.4493 = fadd double %.4442, %.4492
  store double %.4493, ptr %.4441, align 8
  %exitcond3812.not = icmp eq i64 %arg.est.10.2, %.4203
  br i1 %exitcond3812.not, label %B208.loopexit, label %B898.if
B1200.if:
  %.4730.03809 = phi i64 [ 0, %B1138 ], [ %.4799, %B1200.loopexit ]
  %.4799 = add nuw nsw i64 %.4730.03809, 1
  br i1 %.49203806.not, label %B1200.loopexit, label %B1254.if.lr.ph
B1254.if.lr.ph:
  %.4960 = add nuw nsw i64 %.4730.03809, %arg.run.6.2
  %.5010 = mul i64 %.4960, %arg.est.30.4.5.1
  %.5071 = mul i64 %.4730.03809, %arg.est.26.5.1
  %25 = getelementptr double, ptr %arg.est.26.4, i64 %.5071
  %gep3817 = getelementptr double, ptr %invariant.gep3816, i64 %.5010
  br label %B1254.if
B1254.if:
  %.4864.03807 = phi i64 [ 0, %B1254.if.lr.ph ], [ %.4933, %B1254.if ]
  %.4933 = add nuw nsw i64 %.4864.03807, 1
  %gep = getelementptr double, ptr %gep3817, i64 %.4864.03807
  %.5015 = load double, ptr %gep, align 8
  %26 = getelementptr double, ptr %25, i64 %.4864.03807
  store double %.5015, ptr %26, align 8
  %exitcond3814.not = icmp eq i64 %arg.est.3.2, %.4933
  br i1 %exitcond3814.not, label %B1200.loopexit, label %B1254.if
}
define internal fastcc void @v87(ptr noalias nonnull writeonly %retptr, ptr %arg.system.4, i64 %arg.system.5.0, i64 %arg.system.5.1, i64 %arg.n) unnamed_addr {
entry:
  %.146799.not = icmp slt i64 %arg.system.5.0, 1
  br i1 %.146799.not, label %B648.preheader, label %B88.if
B86.loopexit:
  %exitcond816.not = icmp eq i64 %arg.system.5.0, %.159
  br i1 %exitcond816.not, label %B648.preheader, label %B88.if
B648.preheader:
  %.2140 = sub i64 %arg.system.5.1, %arg.system.5.0
  %spec.select783 = tail call i64 @llvm.smax.i64(i64 %.2140, i64 0)
  %.2183808.not = icmp slt i64 %.2140, 1
  br label %B648.if
B290:
  %.532.not = icmp eq i64 %pivot.3.2, %.87.0800
  %.572 = sub i64 %arg.system.5.1, %.87.0800
  %.615790.not = icmp slt i64 %.572, 1
  %or.cond = select i1 %.532.not, i1 true, i1 %.615790.not
  br i1 %or.cond, label %B468.if.lr.ph, label %B334.if.lr.ph
B334.if.lr.ph:
  %.733 = icmp slt i64 %pivot.3.2, 0
  %.734 = select i1 %.733, i64 %arg.system.5.0, i64 0
  %.735 = add i64 %.734, %pivot.3.2
  %.755 = mul i64 %.735, %arg.system.5.1
  %0 = getelementptr double, ptr %arg.system.4, i64 %.755
  br label %B334.if
B404.loopexit:
  %.933.pre = load double, ptr %.239, align 8
  br label %B468.if.lr.ph
B468.if.lr.ph:
  %.933.ph = phi double [ %.240, %B290 ], [ %.933.pre, %B404.loopexit ]
  %.939822 = fdiv double 1.000000e+00, %.933.ph
  %.1169 = sub i64 %arg.system.5.1, %.159
  %spec.select781 = tail call i64 @llvm.smax.i64(i64 %.1169, i64 0)
  %.1212793.not814 = icmp slt i64 %.1169, 1
  br label %B468.if
B612:
  %.1025 = icmp ugt i64 %.972.0798, 1
  br i1 %.1025, label %B468.if, label %B86.loopexit
B648.loopexit:
  %exitcond817.not = icmp eq i64 %.1529, %arg.n
  br i1 %exitcond817.not, label %B942, label %B648.if
B774.if.lr.ph:
  %.1943 = select i1 %.1712, i64 %arg.system.5.0, i64 0
  %.1944 = add i64 %.1943, %.1586.0806
  %.1964 = mul i64 %.1944, %arg.system.5.1
  %1 = getelementptr double, ptr %arg.system.4, i64 %.1964
  br label %B774.if
B838:
  %.1642 = icmp sgt i64 %.1589.0807, 1
  br i1 %.1642, label %B706.if, label %B840
B840:
  %.2065 = icmp slt i64 %.1556, 0
  %.2066 = select i1 %.2065, i64 %arg.system.5.0, i64 0
  %.2067 = add i64 %.2066, %.1556
  %.2069 = select i1 %.2065, i64 %arg.system.5.1, i64 0
  %.2087 = mul i64 %.2067, %arg.system.5.1
  %2 = getelementptr double, ptr %arg.system.4, i64 %.2087
  %3 = getelementptr double, ptr %2, i64 %.1556
  %.2091 = getelementptr double, ptr %3, i64 %.2069
  %.2092 = load double, ptr %.2091, align 8
  %.2098 = fdiv double 1.000000e+00, %.2092
  br i1 %.2183808.not, label %B648.loopexit, label %B898.if
B942:
  store ptr null, ptr %retptr, align 8
  ret void
B88.if:
  %.87.0800 = phi i64 [ %.159, %B86.loopexit ], [ 0, %entry ]
  %.159 = add nuw nsw i64 %.87.0800, 1
  %.235 = mul i64 %.87.0800, %arg.system.5.1
  %4 = getelementptr double, ptr %arg.system.4, i64 %.235
  %.239 = getelementptr double, ptr %4, i64 %.87.0800
  %.240 = load double, ptr %.239, align 8
  %.290 = sub nsw i64 %arg.system.5.0, %.159
  %storemerge771 = tail call i64 @llvm.smax.i64(i64 %.290, i64 0)
  %invariant.gep = getelementptr double, ptr %arg.system.4, i64 %.87.0800
  %.333785.not = icmp slt i64 %.290, 1
  br i1 %.333785.not, label %B86.loopexit, label %B180.if.preheader
B180.if.preheader:
  %.243 = tail call double @llvm.fabs.f64(double %.240)
  br label %B180.if
B180.if:
  %pivot.2.1789 = phi i64 [ %pivot.3.2, %B180.if ], [ %.87.0800, %B180.if.preheader ]
  %largest.2.1788 = phi double [ %largest.3.2, %B180.if ], [ %.243, %B180.if.preheader ]
  %.280.0787 = phi i64 [ %.342, %B180.if ], [ %storemerge771, %B180.if.preheader ]
  %.277.0786 = phi i64 [ %.346, %B180.if ], [ %.159, %B180.if.preheader ]
  %.342 = add nsw i64 %.280.0787, -1
  %.346 = add nuw i64 %.277.0786, 1
  %.410 = icmp slt i64 %.277.0786, 0
  %.411 = select i1 %.410, i64 %arg.system.5.0, i64 0
  %.412 = add i64 %.411, %.277.0786
  %.432 = mul i64 %.412, %arg.system.5.1
  %gep = getelementptr double, ptr %invariant.gep, i64 %.432
  %.437 = load double, ptr %gep, align 8
  %.440 = tail call double @llvm.fabs.f64(double %.437)
  %.442 = fcmp ogt double %.440, %largest.2.1788
  %largest.3.2 = select i1 %.442, double %.440, double %largest.2.1788
  %pivot.3.2 = select i1 %.442, i64 %.277.0786, i64 %pivot.2.1789
  %.333 = icmp ugt i64 %.280.0787, 1
  br i1 %.333, label %B180.if, label %B290
B334.if:
  %.559.0791 = phi i64 [ %.87.0800, %B334.if.lr.ph ], [ %.628, %B334.if ]
  %.628 = add nuw i64 %.559.0791, 1
  %.681 = icmp slt i64 %.559.0791, 0
  %.682 = select i1 %.681, i64 %arg.system.5.1, i64 0
  %.683 = add i64 %.682, %.559.0791
  %.704 = getelementptr double, ptr %4, i64 %.683
  %.705 = load double, ptr %.704, align 8
  %.759 = getelementptr double, ptr %0, i64 %.683
  %.760 = load double, ptr %.759, align 8
  store double %.760, ptr %.704, align 8
  store double %.705, ptr %.759, align 8
  %exitcond.not = icmp eq i64 %.628, %arg.system.5.1
  br i1 %exitcond.not, label %B404.loopexit, label %B334.if
B468.if:
  %.972.0798 = phi i64 [ %storemerge771, %B468.if.lr.ph ], [ %.1034, %B612 ]
  %.969.0797 = phi i64 [ %.159, %B468.if.lr.ph ], [ %.1038, %B612 ]
  %.1034 = add nsw i64 %.972.0798, -1
  %.1038 = add nuw i64 %.969.0797, 1
  %.1092 = icmp slt i64 %.969.0797, 0
  %.1093 = select i1 %.1092, i64 %arg.system.5.0, i64 0
  %.1094 = add i64 %.1093, %.969.0797
  %.1114 = mul i64 %.1094, %arg.system.5.1
  %5 = getelementptr double, ptr %arg.system.4, i64 %.1114
  %.1118 = getelementptr double, ptr %5, i64 %.87.0800
  %.1119 = load double, ptr %.1118, align 8
  %.1123 = fmul double %.939822, %.1119
  %.1128 = fcmp oeq double %.1123, 0.000000e+00
  %brmerge = select i1 %.1128, i1 true, i1 %.1212793.not814
  br i1 %brmerge, label %B612, label %B548.if
B548.if:
  %.1159.0795 = phi i64 [ %.1221, %B548.if ], [ %spec.select781, %B468.if ]
  %.1156.0794 = phi i64 [ %.1225, %B548.if ], [ %.159, %B468.if ]
  %.1221 = add nsw i64 %.1159.0795, -1
  %.1225 = add nuw i64 %.1156.0794, 1
  %.1278 = icmp slt i64 %.1156.0794, 0
  %.1279 = select i1 %.1278, i64 %arg.system.5.1, i64 0
  %.1280 = add i64 %.1279, %.1156.0794
  %.1301 = getelementptr double, ptr %5, i64 %.1280
  %.1302 = load double, ptr %.1301, align 8
  %.1354 = getelementptr double, ptr %4, i64 %.1280
  %.1355 = load double, ptr %.1354, align 8
  %.1359 = fmul double %.1123, %.1355
  %.1360 = fsub double %.1302, %.1359
  store double %.1360, ptr %.1301, align 8
  %.1212 = icmp sgt i64 %.1159.0795, 1
  br i1 %.1212, label %B548.if, label %B612
B648.if:
  %.1460.0811 = phi i64 [ 0, %B648.preheader ], [ %.1529, %B648.loopexit ]
  %.1529 = add nuw nsw i64 %.1460.0811, 1
  %6 = xor i64 %.1460.0811, -1
  %.1556 = add i64 %arg.system.5.0, %6
  %.1642805.not = icmp eq i64 %.1460.0811, 0
  br i1 %.1642805.not, label %B840, label %B706.if.lr.ph
B706.if.lr.ph:
  %.1561 = sub i64 %arg.system.5.0, %.1460.0811
  %.1709 = icmp slt i64 %.1556, 0
  %.1710 = select i1 %.1709, i64 %arg.system.5.0, i64 0
  %.1711 = add i64 %.1710, %.1556
  %.1731 = mul i64 %.1711, %arg.system.5.1
  %7 = getelementptr double, ptr %arg.system.4, i64 %.1731
  br label %B706.if
B706.if:
  %.1589.0807 = phi i64 [ %.1460.0811, %B706.if.lr.ph ], [ %.1651, %B838 ]
  %.1586.0806 = phi i64 [ %.1561, %B706.if.lr.ph ], [ %.1655, %B838 ]
  %.1651 = add nsw i64 %.1589.0807, -1
  %.1655 = add i64 %.1586.0806, 1
  %.1712 = icmp slt i64 %.1586.0806, 0
  %.1713 = select i1 %.1712, i64 %arg.system.5.1, i64 0
  %8 = getelementptr double, ptr %7, i64 %.1586.0806
  %.1735 = getelementptr double, ptr %8, i64 %.1713
  %.1736 = load double, ptr %.1735, align 8
  %.1743 = fcmp oeq double %.1736, 0.000000e+00
  %brmerge813 = select i1 %.1743, i1 true, i1 %.2183808.not
  br i1 %brmerge813, label %B838, label %B774.if.lr.ph
B774.if:
  %.1773.0804 = phi i64 [ %spec.select783, %B774.if.lr.ph ], [ %.1835, %B774.if ]
  %.1770.0803 = phi i64 [ %arg.system.5.0, %B774.if.lr.ph ], [ %.1839, %B774.if ]
  %.1835 = add nsw i64 %.1773.0804, -1
  %.1839 = add i64 %.1770.0803, 1
  %.1892 = icmp slt i64 %.1770.0803, 0
  %.1893 = select i1 %.1892, i64 %arg.system.5.1, i64 0
  %.1894 = add i64 %.1893, %.1770.0803
  %.1915 = getelementptr double, ptr %7, i64 %.1894
  %.1916 = load double, ptr %.1915, align 8
  %.1968 = getelementptr double, ptr %1, i64 %.1894
  %.1969 = load double, ptr %.1968, align 8
  %.1973 = fmul double %.1736, %.1969
  %.1974 = fsub double %.1916, %.1973
  store double %.1974, ptr %.1915, align 8
  %.1826 = icmp sgt i64 %.1773.0804, 1
  br i1 %.1826, label %B774.if, label %B838
B898.if:
  %.2130.0810 = phi i64 [ %.2192, %B898.if ], [ %spec.select783, %B840 ]
  %.2127.0809 = phi i64 [ %.2196, %B898.if ], [ %arg.system.5.0, %B840 ]
  %.2192 = add nsw i64 %.2130.0810, -1
  %.2196 = add i64 %.2127.0809, 1
  %.2249 = icmp slt i64 %.2127.0809, 0
  %.2250 = select i1 %.2249, i64 %arg.system.5.1, i64 0
  %9 = getelementptr double, ptr %2, i64 %.2127.0809
  %.2272 = getelementptr double, ptr %9, i64 %.2250
  %.2273 = load double, ptr %.2272, align 8
  %.2275 = fmul double %.2098, %.2273
  store double %.2275, ptr %.2272, align 8
  %.2183 = icmp sgt i64 %.2130.0810, 1
  br i1 %.2183, label %B898.if, label %B648.loopexit
}
define internal fastcc void @v86(ptr noalias nonnull writeonly %retptr, ptr readonly %arg.run.2.0.4, i64 %arg.run.2.0.5.1, ptr readonly %arg.run.5.4.4, ptr readonly %arg.run.6.4, double %arg.span) unnamed_addr {
entry:
  %.447 = fdiv double 2.000000e+01, %arg.span
  %.585727.not = icmp slt i64 %arg.run.2.0.5.1, 1
  br i1 %.585727.not, label %B268, label %B90.if.lr.ph
B90.if.lr.ph:
  %.idx = shl i64 %arg.run.2.0.5.1, 4
  %0 = getelementptr i8, ptr %arg.run.2.0.4, i64 %.idx
  br label %B90.if
B268:
  %fastest.2.0.lcssa = phi double [ %.447, %entry ], [ %.13.i, %B90.if ]
  %.1029 = fdiv double 1.000000e+00, %fastest.2.0.lcssa
  store double %.1029, ptr %retptr, align 8
  ret void
B90.if:
  %fastest.2.0730 = phi double [ %.447, %B90.if.lr.ph ], [ %.13.i, %B90.if ]
  %.527.0729 = phi i64 [ 0, %B90.if.lr.ph ], [ %.598, %B90.if ]
  %.598 = add nuw nsw i64 %.527.0729, 1
  %1 = getelementptr double, ptr %arg.run.5.4.4, i64 %.527.0729
  %.761 = load double, ptr %1, align 8
  %.765 = tail call double @llvm.fabs.f64(double %.761)
  %.766 = fmul double %.765, 2.000000e+01
  %2 = getelementptr double, ptr %arg.run.6.4, i64 %.527.0729
  %.800 = load double, ptr %2, align 8
  %.804 = tail call double @llvm.fabs.f64(double %.800)
  %3 = getelementptr double, ptr %0, i64 %.527.0729
  %.858 = load double, ptr %3, align 8
  %.859 = fadd double %.804, %.858
  %.863 = fdiv double %.766, %.859
  %.12.i = fcmp ogt double %.863, %fastest.2.0730
  %.13.i = select i1 %.12.i, double %.863, double %fastest.2.0730
  %exitcond.not = icmp eq i64 %.598, %arg.run.2.0.5.1
  br i1 %exitcond.not, label %B268, label %B90.if
}
define internal fastcc void @v85(ptr noalias nonnull writeonly %retptr, double %arg.t, ptr readonly %arg.segment.2.4, i64 %arg.segment.2.5.1, i64 %arg.slopes.2, ptr writeonly %arg.slopes.4) unnamed_addr {
entry:
  %.608 = alloca double, align 8
  %.148231.not = icmp slt i64 %arg.slopes.2, 1
  br i1 %.148231.not, label %B338, label %B58.if
B110:
  %.361 = getelementptr i8, ptr %1, i64 48
  %.362 = load double, ptr %.361, align 8
  %.364 = fsub double %arg.t, %.362
  %.419 = getelementptr i8, ptr %1, i64 24
  %.420 = load double, ptr %.419, align 8
  %.474 = getelementptr i8, ptr %1, i64 32
  %.475 = load double, ptr %.474, align 8
  %.476 = fmul double %.364, %.475
  %.477 = fadd double %.420, %.476
  %.478 = fmul double %.477, 0x401921FB54442D18
  %.534 = fmul double %.305, %.478
  call fastcc void @v84(ptr %.608, ptr %1, double %.364)
  %.624 = load double, ptr %.608, align 8
  %.644.le = tail call double @llvm.cos.f64(double %.624)
  %.649 = fmul double %.534, %.644.le
  %.651 = fadd double %.243, %.649
  br label %B326
B326:
  %slope.2.1 = phi double [ %.651, %B110 ], [ %.243, %B58.if ]
  %0 = getelementptr double, ptr %arg.slopes.4, i64 %.90.0232
  store double %slope.2.1, ptr %0, align 8
  %exitcond.not = icmp eq i64 %arg.slopes.2, %.161
  br i1 %exitcond.not, label %B338, label %B58.if
B338:
  store ptr null, ptr %retptr, align 8
  ret void
B58.if:
  %.90.0232 = phi i64 [ %.161, %B326 ], [ 0, %entry ]
  %.161 = add nuw nsw i64 %.90.0232, 1
  %.238 = mul i64 %.90.0232, %arg.segment.2.5.1
  %1 = getelementptr double, ptr %arg.segment.2.4, i64 %.238
  %.242 = getelementptr i8, ptr %1, i64 8
  %.243 = load double, ptr %.242, align 8
  %.304 = getelementptr i8, ptr %1, i64 16
  %.305 = load double, ptr %.304, align 8
  %.306 = fcmp une double %.305, 0.000000e+00
  br i1 %.306, label %B110, label %B326
}
declare double @llvm.cos.f64(double)
define internal fastcc void @v68(ptr noalias nonnull writeonly %retptr, i64 %arg.est.1, ptr readonly %arg.est.2.4, ptr %arg.est.5.4, i64 %arg.est.5.5.1, i64 %arg.est.6.2, ptr readonly %arg.est.6.4, ptr readonly %arg.est.7.4, i64 %arg.est.8.2, ptr readonly %arg.est.8.4, ptr readonly %arg.est.9.4, i64 %arg.est.9.5.1, i64 %arg.est.10.2, ptr readonly %arg.est.10.4, ptr readonly %arg.est.13.4, i64 %arg.est.13.5.1, i64 %arg.est.14.2, ptr %arg.est.30.7.4, ptr %arg.est.30.9.4, ptr %arg.est.30.10.4, ptr %arg.est.30.11.4, i64 %arg.est.30.11.5.1, ptr %arg.run.1.0.4, i64 %arg.run.1.0.5.0, ptr %arg.run.5.3.4, i64 %arg.run.6.2, i64 %arg.mean.2, ptr %arg.mean.4, i64 %arg.mean.5.0) unnamed_addr {
entry:
  %.2676 = alloca ptr, align 8
  call fastcc void @v62(ptr %.2676, ptr %arg.est.5.4, i64 %arg.est.5.5.1, i64 %arg.est.6.2, ptr %arg.est.6.4, ptr %arg.est.7.4, i64 %arg.est.8.2, ptr %arg.est.8.4, ptr %arg.est.9.4, i64 %arg.est.9.5.1, i64 %arg.est.10.2, ptr %arg.est.10.4, ptr %arg.run.1.0.4, i64 %arg.run.1.0.5.0, i64 %arg.run.6.2, ptr %arg.mean.4, i64 %arg.mean.5.0)
  %.2966 = load double, ptr %arg.est.2.4, align 8
  store double %.2966, ptr %arg.run.5.3.4, align 8
  %.3109 = getelementptr double, ptr %arg.est.5.4, i64 %arg.est.5.5.1
  %.3355 = inttoptr i64 %arg.est.1 to ptr
  tail call void %.3355(ptr nonnull %arg.run.5.3.4, ptr %arg.mean.4, ptr %.3109, ptr %arg.run.1.0.4, ptr %arg.est.30.7.4, ptr %arg.est.30.9.4, ptr %arg.est.30.10.4)
  %.34565183.not = icmp slt i64 %arg.est.14.2, 1
  br i1 %.34565183.not, label %B960, label %B334.if.lr.ph
B334.if.lr.ph:
  %.35775164.not = icmp slt i64 %arg.run.6.2, 1
  %.38205173.not = icmp slt i64 %arg.est.10.2, 1
  %.41665167.not = icmp slt i64 %arg.est.8.2, 1
  %.45635176.not = icmp slt i64 %arg.mean.2, 1
  br label %B334.if
B332.loopexit:
  %finite.4.1.lcssa = phi i1 [ %"$phi838.1.2.1", %B838 ], [ %"$phi952.2.2.2", %B952 ]
  %exitcond5193.not = icmp eq i64 %.3469, %arg.est.14.2
  br i1 %exitcond5193.not, label %B960.loopexit, label %B334.if
B432:
  br i1 %.38205173.not, label %B774, label %B482.if.lr.ph
B482.if.lr.ph:
  %.3915 = mul i64 %.3399.05184, %arg.est.13.5.1
  %0 = getelementptr double, ptr %arg.est.13.4, i64 %.3915
  %1 = getelementptr double, ptr %arg.est.30.7.4, i64 %.3399.05184
  %.4380 = mul i64 %.3399.05184, %arg.est.30.11.5.1
  %2 = getelementptr double, ptr %arg.est.30.11.4, i64 %.4380
  %invariant.gep5195 = getelementptr double, ptr %arg.est.30.10.4, i64 %.3399.05184
  br label %B482.if
B742:
  %slope.2.2.lcssa = phi double [ %.3920, %B482.if ], [ %.4313, %B660.if ]
  %.4362 = select i1 %.3982, i64 %arg.est.30.11.5.1, i64 0
  %3 = getelementptr double, ptr %2, i64 %.3968
  %.4384 = getelementptr double, ptr %3, i64 %.4362
  store double %slope.2.2.lcssa, ptr %.4384, align 8
  %exitcond5191.not = icmp eq i64 %arg.est.10.2, %.3833
  br i1 %exitcond5191.not, label %B774, label %B482.if
B774:
  br i1 %finite.3.05186, label %B778, label %B838
B778:
  %4 = getelementptr double, ptr %arg.est.30.7.4, i64 %.3399.05184
  %.4442 = load double, ptr %4, align 8
  %.4453.le = fsub double %.4442, %.4442
  %.4454.le = fcmp ord double %.4453.le, 0.000000e+00
  br label %B838
B838:
  %"$phi838.1.2.1" = phi i1 [ false, %B774 ], [ %.4454.le, %B778 ]
  br i1 %.45635176.not, label %B332.loopexit, label %B880.if.lr.ph
B880.if.lr.ph:
  %.4668 = mul i64 %.3399.05184, %arg.est.30.11.5.1
  %5 = getelementptr double, ptr %arg.est.30.11.4, i64 %.4668
  br label %B880.if
B888:
  %6 = getelementptr double, ptr %5, i64 %.4507.05177
  %.4673 = load double, ptr %6, align 8
  %.4688.le = fsub double %.4673, %.4673
  %.4689.le = fcmp ord double %.4688.le, 0.000000e+00
  br label %B952
B952:
  %"$phi952.2.2.2" = phi i1 [ false, %B880.if ], [ %.4689.le, %B888 ]
  %exitcond5192.not = icmp eq i64 %arg.mean.2, %.4576
  br i1 %exitcond5192.not, label %B332.loopexit, label %B880.if
B960.loopexit:
  %7 = zext i1 %finite.4.1.lcssa to i8
  br label %B960
B960:
  %finite.3.0.lcssa = phi i8 [ 1, %entry ], [ %7, %B960.loopexit ]
  store i8 %finite.3.0.lcssa, ptr %retptr, align 1
  ret void
B334.if:
  %finite.3.05186 = phi i1 [ true, %B334.if.lr.ph ], [ %finite.4.1.lcssa, %B332.loopexit ]
  %.3399.05184 = phi i64 [ 0, %B334.if.lr.ph ], [ %.3469, %B332.loopexit ]
  %.3469 = add nuw nsw i64 %.3399.05184, 1
  br i1 %.35775164.not, label %B432, label %B368.if.lr.ph
B368.if.lr.ph:
  %.3709 = mul i64 %.3399.05184, %arg.est.30.11.5.1
  %8 = getelementptr double, ptr %arg.est.30.11.4, i64 %.3709
  %invariant.gep5194 = getelementptr double, ptr %arg.est.30.9.4, i64 %.3399.05184
  br label %B368.if
B368.if:
  %.3521.05165 = phi i64 [ 0, %B368.if.lr.ph ], [ %.3590, %B368.if ]
  %.3590 = add nuw nsw i64 %.3521.05165, 1
  %.3621 = mul nuw nsw i64 %.3521.05165, %arg.est.14.2
  %gep = getelementptr double, ptr %invariant.gep5194, i64 %.3621
  %.3652 = load double, ptr %gep, align 8
  %9 = getelementptr double, ptr %8, i64 %.3521.05165
  store double %.3652, ptr %9, align 8
  %exitcond.not = icmp eq i64 %arg.run.6.2, %.3590
  br i1 %exitcond.not, label %B432, label %B368.if
B482.if:
  %.3764.05174 = phi i64 [ 0, %B482.if.lr.ph ], [ %.3833, %B742 ]
  %.3833 = add nuw nsw i64 %.3764.05174, 1
  %10 = getelementptr double, ptr %0, i64 %.3764.05174
  %.3920 = load double, ptr %10, align 8
  %.3965 = load double, ptr %1, align 8
  %.3968 = add nsw i64 %.3764.05174, %arg.run.6.2
  %.3982 = icmp slt i64 %.3968, 0
  %.3983 = select i1 %.3982, i64 %arg.mean.5.0, i64 0
  %11 = getelementptr double, ptr %arg.mean.4, i64 %.3968
  %.3997 = getelementptr double, ptr %11, i64 %.3983
  %.3998 = load double, ptr %.3997, align 8
  %12 = getelementptr double, ptr %arg.est.10.4, i64 %.3764.05174
  %.4033 = load double, ptr %12, align 8
  %.4037 = fsub double %.3998, %.4033
  %.4038 = fmul double %.3920, %.4037
  %.4039 = fadd double %.3965, %.4038
  store double %.4039, ptr %1, align 8
  br i1 %.41665167.not, label %B742, label %B660.if.lr.ph
B660.if.lr.ph:
  %invariant.gep = getelementptr double, ptr %arg.est.9.4, i64 %.3764.05174
  br label %B660.if
B660.if:
  %slope.2.25170 = phi double [ %.3920, %B660.if.lr.ph ], [ %.4313, %B660.if ]
  %.4110.05168 = phi i64 [ 0, %B660.if.lr.ph ], [ %.4179, %B660.if ]
  %.4179 = add nuw nsw i64 %.4110.05168, 1
  %.4210 = mul nuw nsw i64 %.4110.05168, %arg.est.14.2
  %gep5196 = getelementptr double, ptr %invariant.gep5195, i64 %.4210
  %.4241 = load double, ptr %gep5196, align 8
  %.4298 = mul i64 %.4110.05168, %arg.est.9.5.1
  %gep5172 = getelementptr double, ptr %invariant.gep, i64 %.4298
  %.4303 = load double, ptr %gep5172, align 8
  %.4311 = fmul double %.4241, %.4303
  %.4313 = fadd double %slope.2.25170, %.4311
  %exitcond5190.not = icmp eq i64 %arg.est.8.2, %.4179
  br i1 %exitcond5190.not, label %B742, label %B660.if
B880.if:
  %finite.4.15179 = phi i1 [ %"$phi838.1.2.1", %B880.if.lr.ph ], [ %"$phi952.2.2.2", %B952 ]
  %.4507.05177 = phi i64 [ 0, %B880.if.lr.ph ], [ %.4576, %B952 ]
  %.4576 = add nuw nsw i64 %.4507.05177, 1
  br i1 %finite.4.15179, label %B888, label %B952
}
define internal fastcc void @v69(ptr noalias nonnull writeonly %retptr, i64 %arg.est.3.2, ptr %arg.est.4.4, i64 %arg.est.4.5.0, i64 %arg.est.4.5.1, ptr readonly %arg.est.14.4, i64 %arg.est.14.5.0, ptr readonly %arg.est.15.4, i64 %arg.est.15.5.0, ptr readonly %arg.est.30.7.4, i64 %arg.est.30.7.5.0, ptr readonly %arg.est.30.11.4, i64 %arg.est.30.11.5.0, i64 %arg.est.30.11.5.1, ptr writeonly %arg.est.30.12.4, i64 %arg.est.30.12.5.0, i64 %arg.est.30.12.5.1, ptr writeonly %arg.est.30.15.4, i64 %arg.est.30.15.5.0, ptr writeonly %arg.est.30.16.4, i64 %arg.est.30.16.5.0, ptr %arg.est.30.18.4, ptr readonly %arg.est.30.19.4, ptr %arg.est.30.20.4, i64 %arg.est.30.20.5.0, i64 %arg.est.30.21.2, ptr %arg.est.30.21.4, i64 %arg.c) unnamed_addr {
entry:
  %.1082 = icmp slt i64 %arg.c, 0
  %.1083 = select i1 %.1082, i64 %arg.est.30.11.5.0, i64 0
  %.1084 = add i64 %.1083, %arg.c
  %.1101 = mul i64 %.1084, %arg.est.30.11.5.1
  %.1103 = getelementptr double, ptr %arg.est.30.11.4, i64 %.1101
  %.2114 = select i1 %.1082, i64 %arg.est.15.5.0, i64 0
  %0 = getelementptr double, ptr %arg.est.15.4, i64 %arg.c
  %.2128 = getelementptr double, ptr %0, i64 %.2114
  %.2129 = load double, ptr %.2128, align 8
  %.10661078.not.i = icmp slt i64 %arg.est.30.21.2, 1
  br i1 %.10661078.not.i, label %b96, label %B120.if.lr.ph.i
B180.i:
  %.1079.i = add nuw nsw i64 %.1008.01079.i, 1
  %1 = getelementptr double, ptr %arg.est.30.21.4, i64 %.1008.01079.i
  store double %.1332.i, ptr %1, align 8, !noalias !88
  %2 = getelementptr double, ptr %.1103, i64 %.1008.01079.i
  %.1402.i = load double, ptr %2, align 8, !noalias !88
  %.1406.i = fmul double %.1332.i, %.1402.i
  %.1410.i = fadd double %variance.2.01081.i, %.1406.i
  %exitcond1083.not.i = icmp eq i64 %arg.est.30.21.2, %.1079.i
  br i1 %exitcond1083.not.i, label %b96, label %B120.if.lr.ph.i
B120.if.lr.ph.i:
  %variance.2.01081.i = phi double [ %.1410.i, %B180.i ], [ %.2129, %entry ]
  %.1008.01079.i = phi i64 [ %.1079.i, %B180.i ], [ 0, %entry ]
  %.1287.i = mul i64 %.1008.01079.i, %arg.est.4.5.1
  %3 = getelementptr double, ptr %arg.est.4.4, i64 %.1287.i
  br label %B120.if.i
B120.if.i:
  %value.2.11077.i = phi double [ 0.000000e+00, %B120.if.lr.ph.i ], [ %.1332.i, %B120.if.i ]
  %.1140.01075.i = phi i64 [ 0, %B120.if.lr.ph.i ], [ %.1209.i, %B120.if.i ]
  %.1209.i = add nuw nsw i64 %.1140.01075.i, 1
  %4 = getelementptr double, ptr %3, i64 %.1140.01075.i
  %.1292.i = load double, ptr %4, align 8, !noalias !88
  %5 = getelementptr double, ptr %.1103, i64 %.1140.01075.i
  %.1329.i = load double, ptr %5, align 8, !noalias !88
  %.1330.i = fmul double %.1292.i, %.1329.i
  %.1332.i = fadd double %value.2.11077.i, %.1330.i
  %exitcond.not.i = icmp eq i64 %arg.est.30.21.2, %.1209.i
  br i1 %exitcond.not.i, label %B180.i, label %B120.if.i
b96:
  %variance.2.0.lcssa.i = phi double [ %.2129, %entry ], [ %.1410.i, %B180.i ]
  %.2327 = select i1 %.1082, i64 %arg.est.14.5.0, i64 0
  %6 = getelementptr double, ptr %arg.est.14.4, i64 %arg.c
  %.2341 = getelementptr double, ptr %6, i64 %.2327
  %.2342 = load double, ptr %.2341, align 8
  %.2365 = select i1 %.1082, i64 %arg.est.30.7.5.0, i64 0
  %7 = getelementptr double, ptr %arg.est.30.7.4, i64 %arg.c
  %.2379 = getelementptr double, ptr %7, i64 %.2365
  %.2380 = load double, ptr %.2379, align 8
  %.2384 = fsub double %.2342, %.2380
  %.24685200.not = icmp slt i64 %arg.est.3.2, 1
  br i1 %.24685200.not, label %B676.preheader.thread, label %B238.if.lr.ph
B676.preheader.thread:
  %.27865235 = select i1 %.1082, i64 %arg.est.30.15.5.0, i64 0
  %8 = getelementptr double, ptr %arg.est.30.15.4, i64 %arg.c
  %.28005236 = getelementptr double, ptr %8, i64 %.27865235
  store double %variance.2.0.lcssa.i, ptr %.28005236, align 8
  %.28255237 = select i1 %.1082, i64 %arg.est.30.16.5.0, i64 0
  %9 = getelementptr double, ptr %arg.est.30.16.4, i64 %arg.c
  %.28395238 = getelementptr double, ptr %9, i64 %.28255237
  store double %.2384, ptr %.28395238, align 8
  br label %B1032
B238.if.lr.ph:
  %.2727 = select i1 %.1082, i64 %arg.est.30.12.5.0, i64 0
  %.2728 = add i64 %.2727, %arg.c
  %.2748 = mul i64 %.2728, %arg.est.30.12.5.1
  %10 = getelementptr double, ptr %arg.est.30.12.4, i64 %.2748
  br label %B238.if
B466.if.lr.ph:
  %.2786 = select i1 %.1082, i64 %arg.est.30.15.5.0, i64 0
  %11 = getelementptr double, ptr %arg.est.30.15.4, i64 %arg.c
  %.2800 = getelementptr double, ptr %11, i64 %.2786
  store double %variance.2.0.lcssa.i, ptr %.2800, align 8
  %.2825 = select i1 %.1082, i64 %arg.est.30.16.5.0, i64 0
  %12 = getelementptr double, ptr %arg.est.30.16.4, i64 %arg.c
  %.2839 = getelementptr double, ptr %12, i64 %.2825
  store double %.2613, ptr %.2839, align 8
  br label %B574.if.lr.ph
B466.loopexit:
  %exitcond5229.not = icmp eq i64 %arg.est.3.2, %.2937
  br i1 %exitcond5229.not, label %B714.if.lr.ph, label %B574.if.lr.ph
B764:
  %13 = getelementptr double, ptr %arg.est.30.21.4, i64 %.3377.05216
  store double %.3682, ptr %13, align 8
  %exitcond5231.not = icmp eq i64 %arg.est.3.2, %.3446
  br i1 %exitcond5231.not, label %B816.if, label %B714.if.lr.ph
B816.loopexit:
  %exitcond5233.not = icmp eq i64 %arg.est.3.2, %.3836
  br i1 %exitcond5233.not, label %B1032, label %B816.if
B1032:
  %innovation.2.0.lcssa523952415243 = phi double [ %.2384, %B676.preheader.thread ], [ %.2613, %B816.loopexit ]
  %.4670 = fmul double %innovation.2.0.lcssa523952415243, %innovation.2.0.lcssa523952415243
  %.4677 = fdiv double %.4670, %variance.2.0.lcssa.i
  store double %.4677, ptr %retptr, align 8
  ret void
B238.if:
  %innovation.2.05203 = phi double [ %.2384, %B238.if.lr.ph ], [ %.2613, %B238.if ]
  %.2412.05201 = phi i64 [ 0, %B238.if.lr.ph ], [ %.2481, %B238.if ]
  %.2481 = add nuw nsw i64 %.2412.05201, 1
  %14 = getelementptr double, ptr %.1103, i64 %.2412.05201
  %.2535 = load double, ptr %14, align 8
  %15 = getelementptr double, ptr %arg.est.30.18.4, i64 %.2412.05201
  %.2569 = load double, ptr %15, align 8
  %16 = getelementptr double, ptr %arg.est.30.19.4, i64 %.2412.05201
  %.2606 = load double, ptr %16, align 8
  %.2610 = fsub double %.2569, %.2606
  %.2611 = fmul double %.2535, %.2610
  %.2613 = fsub double %innovation.2.05203, %.2611
  %17 = getelementptr double, ptr %arg.est.30.21.4, i64 %.2412.05201
  %.2649 = load double, ptr %17, align 8
  %.2657 = fdiv double %.2649, %variance.2.0.lcssa.i
  %18 = getelementptr double, ptr %arg.est.30.20.4, i64 %.2412.05201
  store double %.2657, ptr %18, align 8
  %19 = getelementptr double, ptr %10, i64 %.2412.05201
  store double %.2657, ptr %19, align 8
  %exitcond.not = icmp eq i64 %arg.est.3.2, %.2481
  br i1 %exitcond.not, label %B466.if.lr.ph, label %B238.if
B574.if.lr.ph:
  %.2868.05208 = phi i64 [ 0, %B466.if.lr.ph ], [ %.2937, %B466.loopexit ]
  %.2937 = add nuw nsw i64 %.2868.05208, 1
  %20 = getelementptr double, ptr %arg.est.30.20.4, i64 %.2868.05208
  %.2999 = load double, ptr %20, align 8
  %21 = getelementptr double, ptr %arg.est.30.18.4, i64 %.2868.05208
  %.3040 = load double, ptr %21, align 8
  %.3043 = fmul double %.2613, %.2999
  %.3044 = fadd double %.3040, %.3043
  store double %.3044, ptr %21, align 8
  %.3243 = mul i64 %.2868.05208, %arg.est.4.5.1
  %22 = getelementptr double, ptr %arg.est.4.4, i64 %.3243
  br label %B574.if
B574.if:
  %.3102.05205 = phi i64 [ 0, %B574.if.lr.ph ], [ %.3171, %B574.if ]
  %.3171 = add nuw nsw i64 %.3102.05205, 1
  %23 = getelementptr double, ptr %22, i64 %.3102.05205
  %.3248 = load double, ptr %23, align 8
  %24 = getelementptr double, ptr %arg.est.30.21.4, i64 %.3102.05205
  %.3282 = load double, ptr %24, align 8
  %.3287 = fmul double %.2999, %.3282
  %.3288 = fsub double %.3248, %.3287
  store double %.3288, ptr %23, align 8
  %exitcond5228.not = icmp eq i64 %arg.est.3.2, %.3171
  br i1 %exitcond5228.not, label %B466.loopexit, label %B574.if
B714.if.lr.ph:
  %.3377.05216 = phi i64 [ %.3446, %B764 ], [ 0, %B466.loopexit ]
  %.3446 = add nuw nsw i64 %.3377.05216, 1
  %.3642 = mul i64 %.3377.05216, %arg.est.4.5.1
  %25 = getelementptr double, ptr %arg.est.4.4, i64 %.3642
  br label %B714.if
B714.if:
  %value.2.15213 = phi double [ 0.000000e+00, %B714.if.lr.ph ], [ %.3682, %B714.if ]
  %.3501.05211 = phi i64 [ 0, %B714.if.lr.ph ], [ %.3570, %B714.if ]
  %.3570 = add nuw nsw i64 %.3501.05211, 1
  %26 = getelementptr double, ptr %25, i64 %.3501.05211
  %.3647 = load double, ptr %26, align 8
  %27 = getelementptr double, ptr %.1103, i64 %.3501.05211
  %.3679 = load double, ptr %27, align 8
  %.3680 = fmul double %.3647, %.3679
  %.3682 = fadd double %value.2.15213, %.3680
  %exitcond5230.not = icmp eq i64 %arg.est.3.2, %.3570
  br i1 %exitcond5230.not, label %B764, label %B714.if
B816.if:
  %.3767.05224 = phi i64 [ %.3836, %B816.loopexit ], [ 0, %B764 ]
  %.3836 = add nuw nsw i64 %.3767.05224, 1
  %.39455218.not.not = icmp sgt i64 %arg.est.3.2, %.3767.05224
  br i1 %.39455218.not.not, label %B852.if.lr.ph, label %B816.loopexit
B852.if.lr.ph:
  %invariant.gep = getelementptr double, ptr %arg.est.4.4, i64 %.3767.05224
  %.4030 = mul i64 %.3767.05224, %arg.est.4.5.1
  %28 = getelementptr double, ptr %arg.est.4.4, i64 %.4030
  %29 = getelementptr double, ptr %arg.est.30.20.4, i64 %.3767.05224
  %30 = getelementptr double, ptr %arg.est.30.21.4, i64 %.3767.05224
  br label %B852.if
B852.if:
  %.3889.05219 = phi i64 [ %.3767.05224, %B852.if.lr.ph ], [ %.3958, %B852.if ]
  %.3958 = add nuw i64 %.3889.05219, 1
  %.4011 = icmp slt i64 %.3889.05219, 0
  %.4012 = select i1 %.4011, i64 %arg.est.4.5.1, i64 0
  %31 = getelementptr double, ptr %28, i64 %.3889.05219
  %.4034 = getelementptr double, ptr %31, i64 %.4012
  %.4035 = load double, ptr %.4034, align 8
  %.4054 = select i1 %.4011, i64 %arg.est.30.20.5.0, i64 0
  %32 = getelementptr double, ptr %arg.est.30.20.4, i64 %.3889.05219
  %.4068 = getelementptr double, ptr %32, i64 %.4054
  %.4069 = load double, ptr %.4068, align 8
  %.4107 = load double, ptr %.2128, align 8
  %.4145 = load double, ptr %29, align 8
  %.4149 = fmul double %.4107, %.4145
  %.4184 = load double, ptr %30, align 8
  %.4188 = fsub double %.4149, %.4184
  %.4189 = fmul double %.4069, %.4188
  %.4190 = fadd double %.4035, %.4189
  store double %.4190, ptr %.4034, align 8
  %.4322 = select i1 %.4011, i64 %arg.est.4.5.0, i64 0
  %.4323 = add i64 %.4322, %.3889.05219
  %.4343 = mul i64 %.4323, %arg.est.4.5.1
  %gep5222 = getelementptr double, ptr %invariant.gep, i64 %.4343
  store double %.4190, ptr %gep5222, align 8
  %exitcond5232.not = icmp eq i64 %.3958, %arg.est.3.2
  br i1 %exitcond5232.not, label %B816.loopexit, label %B852.if
}
define i64 @estimate(ptr readonly %job) local_unnamed_addr {
  %status = alloca i64, align 8
  store i64 0, ptr %status, align 8
  call fastcc void @v61(ptr %status, ptr %job)
  %result = load i64, ptr %status, align 8
  ret i64 %result
}
declare i64 @llvm.smax.i64(i64, i64)
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
!6 = !{!"branch_weights", i32 1, i32 99}
!7 = !{!"branch_weights", i32 99, i32 1}
!8 = !{!9}
!9 = distinct !{!9, !10, !"scope"}
!10 = distinct !{!10, !"scope"}
!11 = !{!12, !9}
!12 = distinct !{!12, !13, !"scope"}
!13 = distinct !{!13, !"scope"}
!14 = !{!15, !9}
!15 = distinct !{!15, !16, !"scope"}
!16 = distinct !{!16, !"scope"}
!17 = !{!18, !9}
!18 = distinct !{!18, !19, !"scope"}
!19 = distinct !{!19, !"scope"}
!20 = !{!21, !9}
!21 = distinct !{!21, !22, !"scope"}
!22 = distinct !{!22, !"scope"}
!23 = !{!24}
!24 = distinct !{!24, !25, !"scope"}
!25 = distinct !{!25, !"scope"}
!26 = !{!27, !24}
!27 = distinct !{!27, !28, !"scope"}
!28 = distinct !{!28, !"scope"}
!29 = !{!30, !27, !24}
!30 = distinct !{!30, !31, !"scope"}
!31 = distinct !{!31, !"scope"}
!32 = !{!33, !24}
!33 = distinct !{!33, !34, !"scope"}
!34 = distinct !{!34, !"scope"}
!35 = !{!36, !38, !40, !24}
!36 = distinct !{!36, !37, !"scope"}
!37 = distinct !{!37, !"scope"}
!38 = distinct !{!38, !39, !"scope"}
!39 = distinct !{!39, !"scope"}
!40 = distinct !{!40, !41, !"scope"}
!41 = distinct !{!41, !"scope"}
!42 = !{!38, !40, !24}
!43 = !{!40, !24}
!44 = !{!45, !24}
!45 = distinct !{!45, !46, !"scope"}
!46 = distinct !{!46, !"scope"}
!47 = !{!48, !24}
!48 = distinct !{!48, !49, !"scope"}
!49 = distinct !{!49, !"scope"}
!50 = !{!51, !53, !55, !24}
!51 = distinct !{!51, !52, !"scope"}
!52 = distinct !{!52, !"scope"}
!53 = distinct !{!53, !54, !"scope"}
!54 = distinct !{!54, !"scope"}
!55 = distinct !{!55, !56, !"scope"}
!56 = distinct !{!56, !"scope"}
!57 = !{!53, !55, !24}
!58 = !{!55, !24}
!59 = !{!60, !24}
!60 = distinct !{!60, !61, !"scope"}
!61 = distinct !{!61, !"scope"}
!62 = !{!63, !65}
!63 = distinct !{!63, !64, !"scope"}
!64 = distinct !{!64, !"scope"}
!65 = distinct !{!65, !66, !"scope"}
!66 = distinct !{!66, !"scope"}
!67 = !{!68}
!68 = distinct !{!68, !69, !"scope"}
!69 = distinct !{!69, !"scope"}
!70 = !{!71, !68}
!71 = distinct !{!71, !72, !"scope"}
!72 = distinct !{!72, !"scope"}
!73 = !{!74, !68}
!74 = distinct !{!74, !75, !"scope"}
!75 = distinct !{!75, !"scope"}
!76 = !{!77}
!77 = distinct !{!77, !78, !"scope"}
!78 = distinct !{!78, !"scope"}
!79 = !{!80}
!80 = distinct !{!80, !81, !"scope"}
!81 = distinct !{!81, !"scope"}
!82 = !{!83}
!83 = distinct !{!83, !84, !"scope"}
!84 = distinct !{!84, !"scope"}
!85 = !{!86}
!86 = distinct !{!86, !87, !"scope"}
!87 = distinct !{!87, !"scope"}
!88 = !{!89}
!89 = distinct !{!89, !90, !"scope"}
!90 = distinct !{!90, !"scope"}
