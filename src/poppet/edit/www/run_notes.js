/* Notes on the results of the run, such as a body at its end stop. The server finds them in the table of the run. */

import { request } from "./connection.js";

const CALM = 700;  // ms without an edit before the server is asked

/* Asks for the notes on a full run of the present text. Until they arrive, the notes that need no run remain; they also
   remain if the server does not answer. */
export class RunNotes {
  constructor(store) { this.store = store; }

  #timer = 0;

  /* Ask later, because of an edit or of another run. */
  postpone() {
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => this.#ask(), CALM);
  }

  async #ask() {
    const { run, state, isStale, simulation } = this.store;
    const isComplete = run && !run.isShort && !run.hasResultNotes && ["done", "stopped"].includes(run.status);
    if (!isComplete || isStale || !simulation.hasRun(state.text)) return;
    try {
      const { status, body } = await request(`/notes?revision=${state.revision}`, tableOf(run));
      if (status !== 200 || run !== this.store.run) return;
      Object.assign(run, { notes: body.notes, hasResultNotes: true });
      this.store.dispatchEvent(new CustomEvent("notes"));
    } catch {
      // The next question to the server reports that it does not answer.
    }
  }
}

/* Numbers of a run in the order of `poppet.edit.build.page_notes`. */
function tableOf({ stop, extremes, time, columns, series }) {
  const arrays = [[stop], extremes, time, ...columns.map(({ name }) => series.get(name))];
  const table = new Float64Array(arrays.reduce((sum, { length }) => sum + length, 0));
  let place = 0;
  for (const array of arrays) {
    table.set(array, place);
    place += array.length;
  }
  return table;
}
