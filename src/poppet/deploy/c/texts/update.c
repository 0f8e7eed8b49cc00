  {
    double *z = m->p + MODEL_NUMBERS, fired[MODEL_TIMERS], after[MODEL_MEMORY];
    int k, any, rounds;
    /* A part can set a timer to the same instant again. */
    for (rounds = 0; rounds < 64; rounds++) {
      for (any = 0, k = 0; k < MODEL_TIMERS; k++) {
        fired[k] = z[k] <= due ? 1.0 : 0.0;
        any |= z[k] <= due;
      }
      if (!any) break;
      if (rounds == 0) inputs_now(m, m->t, m->u, m->slopes);
      update(&m->t, m->x, m->u, m->p, fired, after);
      for (k = 0; k < MODEL_MEMORY; k++) z[k] = after[k];
    }
  }
