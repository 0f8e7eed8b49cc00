/* State of the page. All changes of the circuit go through this class, one after another, to the server. */

import { concernsRun, ConnectionLost, errorsOf, request } from "./connection.js";
import { RunNotes } from "./run_notes.js";
import { Simulation } from "./simulation.js";
import { text } from "./strings.js";
import { merged } from "./text_merge.js";

const POLL = 2000;  // ms between two questions whether the file was changed

/* The only state. Events: "open" (another circuit), "state" (text, view, errors), "selection", "run" (curves or their
   validity), "notes" (on the results of the run), "cursor", "busy", "connection", "message" (for screen readers and the
   status line) and "flush" (apply typed values that are not applied yet). */
export class Store extends EventTarget {
  constructor() {
    super();
    this.state = null;  // last reply of the server, with the last valid view
    this.palette = new Map();  // entry by kind
    this.units = {};  // exact {factor, offset, gauge} by unit
    this.sections = {};  // fields of the tables run, ambient and gas
    this.start = {};  // starting values by kind
    this.selection = new Set();  // names of parts
    this.wire = null;  // selected wire: {port} or {input}
    this.run = null;  // last result: {time, series, columns, notes, status, duration, seconds, isShort}
    this.header = null;  // header of the present model
    this.isStale = true;  // true if the run is not one of the present circuit
    this.cursor = 0;  // time of the values in the drawing, s
    this.isBusy = false;
    this.connection = "ok";  // "ok", "lost" (no answer) or "ended" (session over)
    this.errors = [];  // errors of the text and of the model
    this.message = "";
    this.isPlaying = false;
    this.runNotes = new RunNotes(this);
    this.#waiting = new Map();  // resolve function by number of the edit
    this.ready = this.#newEdit().promise;
    this.simulation = new Simulation({
      run: result => this.#show(result),
      refused: errors => this.#setErrors(errors),
      settled: edit => this.#settle(edit),
      lost: () => {
        this.#setStale(true);
        this.#setConnection("lost");
      },
      behind: () => { if (!this.#isSending) this.#refresh().catch(problem => this.#fail(problem)); },
      busy: isBusy => this.#setBusy(isBusy),
    });
  }

  #waiting;
  #edits = 0;
  #queue = [];
  #isSending = false;
  #timer = null;

  /* Load the palette and the circuit. */
  async load() {
    try {
      const [palette, document] = await Promise.all([request("/palette"), request("/document")]);
      if (palette.status === 200 && document.status === 200) {
        const { kinds, units = {}, start = {}, sections = {} } = palette.body;
        this.palette = new Map(kinds.map(entry => [entry.kind, entry]));
        Object.assign(this, { units, start, sections });
        this.#emit("open");
        this.#accept(document.body, this.#edits);
      } else {
        this.#setConnection(palette.status === 403 || document.status === 403 ? "ended" : "lost");
        this.#settle(this.#edits);
      }
    } catch (problem) {
      this.#fail(problem);
    }
    this.#send();
    this.#timer ??= setInterval(() => this.#poll(), POLL);
  }

  /* --- Changes --- */

  /* Perform operations as one change; with `continues`, the change is merged into a former one that continues too.
     `select`: names of parts to select afterwards, or "created". The result is the state, or null if the change failed. */
  apply(operations, { continues = false, select = null } = {}) {
    const last = this.#queue.at(-1);
    const aims = JSON.stringify(operations.map(({ op, address, part, port, input }) => [op, address, part, port, input]));
    if (continues && last?.body.continues && last.aims === aims) {
      // A newer value of the same fields replaces a value that is not sent yet.
      last.body.operations = operations;
      last.edit = this.#newEdit().edit;
      return last.promise;
    }
    return this.#change("/apply", { operations, continues }, { aims, select, isRepeatable: true });
  }

  undo() { return this.#isIdle && !this.state.can_undo ? Promise.resolve(null) : this.#change("/undo", {}); }

  redo() { return this.#isIdle && !this.state.can_redo ? Promise.resolve(null) : this.#change("/redo", {}); }

  /* Replace the text of the circuit; it can be invalid. If it is a change of the text `base`, with line feeds, the
     changes of the circuit since then remain; the result is null if they are at the same place. */
  replaceText(newText, base) { return this.#change("/text", { text: newText }, { base, isRepeatable: base !== undefined }); }

  /* Take the text of the file, which was changed on disk. */
  reload() { return this.#change("/reload", {}); }

  /* Open a template, a file or an empty circuit: {template}, {file} or {empty: true}; unsaved changes need `discard`. */
  open(source) { return this.#change("/open", source, { isOpen: true }); }

  /* Write the file. The result is null if it is not written; a file that was changed on disk needs `overwrite`. */
  save({ name, overwrite } = {}) {
    this.#emit("flush");
    const body = { ...(name ? { name } : {}), ...(overwrite ? { overwrite } : {}) };
    return this.#change("/save", body, { isSave: true, isRepeatable: true });
  }

  /* Change a number of the running model, in SI, without a change of the text; null restores the number of the text.
     The result is false if the running model cannot change it. */
  number(address, si) {
    if (!this.simulation.canChange(address)) return false;
    this.simulation.setNumber(address, si, this.#newEdit().edit);
    return true;
  }

  /* --- Selection, cursor, messages --- */

  select(names) {
    const parts = this.state?.view.parts ?? {};
    const selection = new Set([...names].filter(name => name in parts));
    const isSame = selection.size === this.selection.size && [...selection].every(name => this.selection.has(name));
    if (isSame && !this.wire) return;
    this.selection = selection;
    this.wire = null;
    this.#emit("selection");
  }

  selectWire(wire) {
    this.selection = new Set();
    this.wire = wire;
    this.#emit("selection");
  }

  setCursor(time) {
    this.cursor = time;
    this.#emit("cursor");
  }

  announce(message) {
    this.message = message;
    this.#emit("message");
  }

  /* --- Access --- */

  /* Entry of the palette for a part, with the symbol and the ports that its options give. */
  entry(part) {
    const entry = this.palette.get(this.state?.view.parts[part]?.kind);
    const symbol = this.state?.symbols?.[part];
    return symbol ? { ...entry, ...symbol } : entry;
  }

  text() { return this.state?.text ?? ""; }

  /* Last run as plain lists in SI. */
  recording() {
    if (!this.run) return { time: [] };
    const series = [...this.run.series].map(([name, values]) => [name, Array.from(values)]);
    return { time: Array.from(this.run.time), ...Object.fromEntries(series) };
  }

  /* --- Queue of changes --- */

  /* True if the state is that of the server. */
  get #isIdle() { return this.state !== null && !this.#isSending && !this.#queue.length; }

  #newEdit() {
    const edit = ++this.#edits;
    const promise = new Promise(resolve => this.#waiting.set(edit, resolve));
    this.ready = promise;
    this.runNotes.postpone();
    return { edit, promise };
  }

  #settle(edit) {
    for (const [number, resolve] of this.#waiting) {
      if (number > edit) continue;
      this.#waiting.delete(number);
      resolve();
    }
  }

  #change(path, body, details = {}) {
    const change = { path, body, ...details };
    change.edit = this.#newEdit().edit;
    change.promise = new Promise(resolve => { change.done = resolve; });
    this.#queue.push(change);
    this.#send();
    return change.promise;
  }

  async #send() {
    if (this.#isSending || !this.state) {
      // Without a server there is nothing that a change can wait for.
      if (!this.state && this.connection !== "ok") for (const change of this.#queue.splice(0)) this.#refuse(change);
      return;
    }
    this.#isSending = true;
    while (this.#queue.length) {
      const change = this.#queue.shift();
      change.done(await this.#perform(change));
    }
    this.#isSending = false;
  }

  async #perform(change) {
    try {
      let reply = await this.#post(change);
      const isStale = reply.status === 409 && reply.body.code === "edit.stale";
      if (isStale) {
        this.#accept(reply.body.state, change.edit - 1);
        if (change.isRepeatable) reply = await this.#post(change);
        this.announce(text(reply.status === 200 ? "page.applied_again" : "page.not_applied"));
      }
      this.#setConnection(reply.status === 403 ? "ended" : "ok");
      if (reply.status === 200) return this.#accept(reply.body, change.edit, change);
      if (reply.body.code === "edit.changed_on_disk") this.#emit("conflict", change);
      else if (!isStale) this.announce(text("problems.refused", { message: messageOf(errorsOf(reply)) }));
    } catch (problem) {
      this.#fail(problem);
      this.announce(text("problems.lost"));
    }
    return this.#refuse(change);
  }

  #post({ path, body, base }) {
    const { revision, text: present } = this.state;
    if (base === undefined) return request(path, { revision, ...body });
    const newText = merged(base, body.text, present.replace(/\r\n/g, "\n"));
    if (newText === null) return { status: 409, body: { message: text("page.not_applied") } };
    return request(path, { revision, text: newText });
  }

  #refuse(change) {
    // The circuit is unchanged, but a former change can still be simulated.
    this.simulation.restore((change.body.operations ?? []).map(({ address }) => address), change.edit);
    this.simulation.finish(change.edit);
    change.done(null);
    return null;
  }

  #fail(problem) {
    if (!(problem instanceof ConnectionLost)) console.error(problem);
    this.#setConnection("lost");
    this.#settle(this.#edits);
  }

  /* Take a state of the server. */
  #accept(reply, edit, { select = null, isOpen = false, isSave = false } = {}) {
    const isValid = !reply.view.error;
    const former = isOpen ? null : this.state;
    const view = isValid ? reply.view : former?.view ?? EMPTY_VIEW;
    // Names of parts such as `constructor` are names in tables without a prototype only.
    for (const table of [reply.places, reply.symbols, ...Object.values(reply.view)]) withoutPrototype(table);
    const kept = isValid ? {} : { places: former?.places ?? {}, symbols: former?.symbols ?? {} };
    this.state = { ...reply, ...kept, view, error: reply.view.error ?? null };
    this.errors = reply.errors ?? [];
    if (isOpen) this.#clear();
    const names = select === "created" ? reply.created ?? [] : select ?? [...this.selection];
    const selection = names.filter(name => name in view.parts);
    const isOther = selection.length !== this.selection.size || selection.some(name => !this.selection.has(name));
    this.selection = new Set(selection);
    if (isOther && selection.length) this.wire = null;
    // The server makes the model while the page draws the circuit.
    if (!isSave && this.#isRunnable) this.simulation.update(this.state, edit);
    if (isOpen) this.#emit("open");
    this.#emit("state");
    if (isOther) this.#emit("selection");
    if (isSave) {
      this.announce(text("problems.saved", { name: this.state.name }));
      this.simulation.finish(edit);
    } else if (!this.#isRunnable) {
      this.#setStale(true);
      this.simulation.stop(edit);
    }
    return this.state;
  }

  /* Errors that keep the circuit from running. */
  get runErrors() { return this.errors.filter(concernsRun); }

  get #isRunnable() { return !this.runErrors.length && !this.state.error && Object.keys(this.state.view.parts).length > 0; }

  #clear() {
    Object.assign(this, { run: null, header: null, selection: new Set(), wire: null, cursor: 0 });
    this.simulation.forget();
    this.#setStale(true);
  }

  async #poll() {
    if (document.visibilityState !== "visible" || this.#isSending || !this.state) return;
    try {
      const { status, body } = await request("/status");
      this.#setConnection(status === 403 ? "ended" : "ok");
      if (status !== 200 || this.#isSending) return;
      if (body.revision !== this.state.revision) await this.#refresh();
      else if (body.changed_on_disk !== this.state.changed_on_disk) {
        this.state = { ...this.state, changed_on_disk: body.changed_on_disk };
        this.#emit("state");
      }
      // The server did not send the model, but answers again.
      if (this.isStale && this.#isRunnable && this.simulation.isIdle) this.simulation.update(this.state, this.#edits);
    } catch {
      this.#setConnection("lost");
    }
  }

  /* Ask the server again after it did not answer. */
  retry() { return this.state ? this.#poll() : this.load(); }

  /* Take the circuit as it is after a change of another page. */
  async #refresh() {
    const { status, body } = await request("/document");
    if (status === 200 && !this.#isSending) this.#accept(body, this.#edits, { isOpen: body.name !== this.state.name });
  }

  /* --- Results --- */

  #show({ run, header }) {
    this.run = run;
    this.header = header;
    this.isStale = false;
    this.cursor = Math.min(this.cursor, run.duration);
    this.#emit("run");
    this.runNotes.postpone();
  }

  #setErrors(errors) {
    this.errors = [...errors, ...this.errors.filter(error => !concernsRun(error))];
    this.#setStale(true);
    this.#emit("state");
  }

  #setStale(isStale) {
    if (this.isStale === isStale) return;
    this.isStale = isStale;
    this.#emit("run");
  }

  #setBusy(isBusy) {
    if (this.isBusy === isBusy) return;
    this.isBusy = isBusy;
    this.#emit("busy");
  }

  #setConnection(connection) {
    if (this.connection === connection) return;
    this.connection = connection;
    this.#emit("connection");
  }

  #emit(name, detail) { this.dispatchEvent(new CustomEvent(name, { detail })); }
}

const EMPTY_VIEW = { title: "", parts: {}, connections: {}, signals: {}, drawing: {}, run: {} };

function withoutPrototype(table) {
  if (table !== null && typeof table === "object") Object.setPrototypeOf(table, null);
}

function messageOf(errors) { return errors.map(({ message }) => message).join(" "); }
