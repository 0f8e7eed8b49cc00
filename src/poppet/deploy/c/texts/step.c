  double f0[MODEL_STATES], f1[MODEL_STATES], drift[MODEL_STATES], J[@JACOBIAN@], lu[@FACTOR@];
  double k1[MODEL_STATES], k2[MODEL_STATES], x1[MODEL_STATES], u1[MODEL_ROOM_OF_INPUTS];
  const double shift = 1.0 / (GAMMA * h), t1 = m->t + h;
  int s;
  /* (I - gamma h J) k1 = f(t, x) + gamma h f_t */
  jacobian(&m->t, m->x, m->u, m->slopes, m->p, f0, J, drift);
  factor(J, &shift, lu);
  for (s = 0; s < MODEL_STATES; s++) f1[s] = shift * f0[s] + drift[s];
  solve(lu, f1, k1);
  for (s = 0; s < MODEL_STATES; s++) x1[s] = m->x[s] + h * k1[s];
  /* (I - gamma h J) k2 = f(t + h, x + h k1) - 2 k1 - gamma h f_t */
  if (moves) inputs_now(m, t1, u1, 0);
  rates(&t1, x1, moves ? u1 : m->u, m->p, f1);
  for (s = 0; s < MODEL_STATES; s++) f1[s] = shift * (f1[s] - 2.0 * k1[s]) - drift[s];
  solve(lu, f1, k2);
  for (s = 0; s < MODEL_STATES; s++) {
    const double apart = 0.5 * h * (k1[s] + k2[s]);
    x1[s] = m->x[s] + h * k1[s] + apart;
    if (is_choosy && fabs(apart) > APART * (fabs(m->x[s]) + nominal[s])) return 1;
    if (!(x1[s] - x1[s] == 0.0) || (positive[s] && x1[s] <= 0.0)) return 1;
  }
  /* Set very small values to zero: denormal numbers are a hundred times slower on a processor. */
  for (s = 0; s < MODEL_STATES; s++) m->x[s] = fabs(x1[s]) < 1e-100 ? 0.0 : x1[s];
  return 0;
