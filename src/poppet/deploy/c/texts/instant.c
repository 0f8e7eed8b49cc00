    {
      for (k = 0; k < MODEL_TIMERS; k++) {
        double instant = m->p[MODEL_NUMBERS + k];
        if (instant < end - do_rounding(end)) end = instant;
      }
    }
