/* Simulation of the present circuit: the model from the server, and its runs in a worker. */

import { ConnectionLost, errorsOf, request } from "./connection.js";
import { text } from "./strings.js";

const HANGS = 20;  // s after which a run is ended
const SHORT_RUN = 0.012;  // s that a run may take while a number is dragged
const SHORTEST = 0.02;  // fraction of the duration that such a run has at least
const NEARLY_WHOLE = 0.6;  // fraction of the duration above which a run is not shortened
const QUIET = 250;  // ms after the last number, then the run is performed in full

/* At most one run is under way, and the last value wins. Callbacks: run({run, header}), refused(errors), settled(edit),
   lost(), behind() if the server has a newer circuit, busy(isBusy). Edits have ascending numbers; settled(edit) includes all edits before it. */
export class Simulation {
  constructor(callbacks) {
    this.callbacks = callbacks;
    this.limit = HANGS;
    this.forget();
  }

  #worker = null;
  #watch = 0;
  #timer = 0;  // of the full run after short ones
  #sent = null;  // job in the worker
  #next = null;  // job that waits for the worker
  #wanted = null;  // {revision, physics, edit} whose model is not fetched yet
  #present = null;  // the same of the last valid circuit
  #isFetching = false;
  physics = null;  // text of the circuit that runs, without its drawing
  #edit = 0;  // last edit of the text, or of a number that is dragged
  #crashes = 0;

  /* Forget the circuit; the next one has another model. */
  forget() {
    this.#wanted = this.#present = null;
    this.#drop();
    this.numbers = new Map();  // changed numbers by address: {si, edit}
    this.header = null;  // header of the model in the worker
    this.seconds = 0;  // computing time of the last full run
  }

  /* True if a number of the present circuit can change without the server. */
  canChange(address) { return this.physics !== null && this.#present !== null && address in (this.header?.numbers ?? {}); }

  /* True if the last run is the full run of a text, without numbers that differ from it. */
  hasRun(circuit) { return this.isIdle && !this.numbers.size && this.physics === physicsOf(circuit); }

  /* Simulate a valid circuit; nothing happens if only its drawing has changed. */
  update({ revision, text: circuit }, edit) {
    this.#edit = Math.max(this.#edit, edit);
    const physics = physicsOf(circuit);
    this.#present = { revision, physics, edit };
    if (physics === this.physics && !this.#wanted && !this.#isFetching && !this.numbers.size) {
      this.#finish();
      return;
    }
    this.#wanted = this.#present;
    this.#fetch();
  }

  /* End the simulation, because the circuit has errors. */
  stop(edit) {
    this.#edit = Math.max(this.#edit, edit);
    this.#wanted = this.#present = null;
    this.#drop();
    this.callbacks.settled(this.#edit);
    this.#tell();
  }

  /* Settle an edit that was refused, as soon as the former ones are settled. */
  finish(edit) {
    this.#edit = Math.max(this.#edit, edit);
    this.#finish();
  }

  /* Run with another number; null restores the number of the text. */
  setNumber(address, si, edit) {
    this.#edit = Math.max(this.#edit, edit);
    if (si === null) this.numbers.delete(address);
    else this.numbers.set(address, { si, edit });
    this.#post({ isDrag: true });
  }

  /* Return to the numbers of the text, after a change of them was refused. */
  restore(addresses, edit) {
    this.#edit = Math.max(this.#edit, edit);
    const changed = addresses.filter(address => this.numbers.delete(address));
    if (changed.length && this.header) this.#post({ isDrag: true });
  }

  /* --- Model --- */

  async #fetch() {
    if (this.#isFetching) return;
    this.#isFetching = true;
    this.#tell();
    while (this.#wanted) {
      const wanted = this.#wanted;
      try {
        const key = this.header ? `&key=${encodeURIComponent(this.header.key)}` : "";
        const reply = await request(`/model?revision=${wanted.revision}${key}`);
        if (wanted !== this.#wanted) continue;  // a newer circuit
        this.#wanted = null;
        if (reply.status === 200) this.#post({ payload: reply.body, ...wanted });
        else if (reply.status !== 204) this.#refuse(errorsOf(reply));
        else this.callbacks.behind();
      } catch (problem) {
        this.#wanted = null;
        if (!(problem instanceof ConnectionLost)) throw problem;
        this.#drop();
        this.callbacks.lost();
        this.callbacks.settled(wanted.edit);
      }
    }
    this.#isFetching = false;
    this.#finish();
  }

  #refuse(errors) {
    this.#drop();
    this.callbacks.refused(errors);
    this.callbacks.settled(this.#edit);
  }

  /* Forget the run that is under way, because it is one of a former circuit. */
  #drop() {
    this.physics = this.#next = null;
    this.#cancelFull();
    if (this.#sent) this.#sent.isDropped = true;
  }

  /* --- Runs --- */

  #post(job) {
    // A model that waits for the worker is still to be loaded.
    this.#next = { ...this.#next?.payload && !job.payload ? { ...this.#next } : {}, ...job };
    if (!this.#sent) this.#start();
  }

  #start() {
    this.#cancelFull();
    const job = this.#next;
    this.#next = null;
    if (!job) return;
    this.#sent = job;
    if (job.payload) for (const [address, { edit }] of this.numbers) if (edit <= job.edit) this.numbers.delete(address);
    const { payload, isDrag } = job;
    const duration = this.header?.duration ?? 0;
    const share = SHORT_RUN / (this.seconds || SHORT_RUN);
    job.until = isDrag && !payload && share < NEARLY_WHOLE ? Math.max(share, SHORTEST) * duration : null;
    const numbers = [...this.numbers].map(([address, { si }]) => [address, si]);
    job.includes = this.#edit;
    this.#watch = setTimeout(() => this.#hang(), 1000 * this.limit);
    this.#tell();
    this.#open().postMessage({ payload, numbers, until: job.until }, payload ? [payload] : []);
  }

  #open() {
    if (this.#worker) return this.#worker;
    this.#worker = new Worker("/www/worker.js", { type: "module" });
    this.#worker.onmessage = ({ data }) => this.#receive(data);
    this.#worker.onerror = event => {
      event.preventDefault();
      this.#crash(event.message ?? "");
    };
    return this.#worker;
  }

  #receive(reply) {
    clearTimeout(this.#watch);
    const job = this.#sent;
    this.#sent = null;
    if (reply.error !== undefined) {
      this.#crash(reply.error, job);
      return;
    }
    this.#crashes = 0;
    if (job.payload) {
      this.header = reply.header;
      this.physics = job.isDropped ? null : job.physics;
    }
    const isShort = job.until !== null;
    this.seconds = reply.seconds / (isShort ? job.until / this.header.duration : 1);
    if (!job.isDropped) {
      const run = { ...reply.run, duration: this.header.duration, columns: this.header.columns, isShort, until: job.until };
      run.notes = this.header.notes ?? [];
      this.callbacks.run({ run, header: this.header });
    }
    if (!isShort && !this.#next && !this.#wanted) this.callbacks.settled(job.includes);
    if (this.#next) this.#start();
    else if (isShort && !job.isDropped) this.#timer = setTimeout(() => this.#post({}), QUIET);
    this.#finish();
  }

  /* --- Failures of the worker --- */

  #end() {
    clearTimeout(this.#watch);
    this.#worker?.terminate();
    this.#worker = null;
    this.#sent = null;
    this.header = null;  // the next worker has no model
    this.physics = null;
  }

  #hang() {
    this.#end();
    this.#next = null;
    this.numbers.clear();
    this.#refuse([{ code: "page.hangs", address: "", line: null, message: text("problems.hangs", { seconds: this.limit }), hint: "" }]);
    this.#tell();
  }

  #crash(message, job = this.#sent) {
    const isOld = job?.payload === undefined;
    this.#end();
    this.#crashes++;
    const wanted = this.#wanted ?? this.#present;
    if (wanted && this.#crashes < 2 && !job?.isDropped) {
      // Load the model anew, with its code, since the server does not send the code of a known structure.
      this.#wanted = wanted;
      this.#fetch();
      return;
    }
    this.#next = null;
    if (isOld) this.numbers.clear();
    console.warn("simulation", message);
    this.#refuse([{ code: "page.crashed", address: "", line: null, message: `${text("problems.crashed")} ${message}`.trim(), hint: "" }]);
    this.#tell();
  }

  #cancelFull() {
    clearTimeout(this.#timer);
    this.#timer = 0;
  }

  /* --- State --- */

  get isIdle() { return !this.#wanted && !this.#isFetching && !this.#sent && !this.#next && !this.#timer; }

  #finish() {
    this.#tell();
    if (this.isIdle) this.callbacks.settled(this.#edit);
  }

  #tell() { this.callbacks.busy(!this.isIdle); }
}

/* Return the text of a circuit without the tables of its drawing, which do not change a run. */
export function physicsOf(circuit) {
  if (/"""|'''/.test(circuit)) return circuit;  // a text of several lines can look like a table
  const lines = [];
  let isDrawing = false;
  for (const line of circuit.split("\n")) {
    if (/^\s*\[/.test(line)) isDrawing = /^\s*\[\s*drawing\s*[.\]]/.test(line);
    if (!isDrawing && line.trim()) lines.push(line.trimEnd());
  }
  return lines.join("\n");
}
