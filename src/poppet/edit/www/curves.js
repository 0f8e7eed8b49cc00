/* Curves of the last run: one plot per quantity, with the kept run and measured values. */

import { Choice } from "./choice.js";
import { Compare, hasColumn } from "./compare.js";
import { Measured } from "./measured.js";
import { Playback } from "./playback.js";
import { Plot } from "./plot.js";
import { digits } from "./quantities.js";
import { text } from "./strings.js";
import { Values } from "./values.js";

const WIDE = 560;  // px above which two plots are side by side
const [LOWEST, HIGHEST] = [110, 260];  // px of a plot
const GAP = 12;
const FAILURES = { stalled: "curves.status_stalled", "too many": "curves.status_steps", "not finite": "curves.status_infinite" };

/* Panel of the curves. */
export class Curves {
  constructor(element, store) {
    Object.assign(this, { element, store, plots: [], layout: "", frame: 0, cursorFrame: 0 });
    const make = (tag, kind, parent = element) => {
      const node = parent.appendChild(document.createElement(tag));
      node.className = kind;
      return node;
    };
    this.bar = make("div", "curve-bar");
    this.playback = new Playback(make("div", "clock", this.bar), store);
    this.choice = new Choice(this.bar, store);
    this.status = make("p", "status");
    this.grid = make("div", "plots");
    const below = make("div", "below");
    this.compare = new Compare(this.bar, below, store);
    this.measured = new Measured(element, this.bar, below, store);
    this.notes = below.appendChild(document.createElement("details"));
    this.notesTitle = this.notes.appendChild(document.createElement("summary"));
    this.notesList = this.notes.appendChild(document.createElement("ul"));
    this.notes.appendChild(document.createElement("p")).textContent = text("curves.notes_more");
    this.values = new Values(below, store);
    for (const event of ["run", "selection", "state", "busy"]) store.addEventListener(event, () => this.later());
    store.addEventListener("notes", () => this.showNotes());
    for (const source of [this.choice, this.compare, this.measured]) source.addEventListener("change", () => this.later());
    store.addEventListener("cursor", () => {
      this.cursorFrame ||= requestAnimationFrame(() => {
        this.cursorFrame = 0;
        for (const plot of this.plots) plot.showClock();
      });
    });
    new ResizeObserver(() => {
      this.isResized = true;
      this.later();
    }).observe(element);
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.plots.forEach(plot => plot.redraw()));
    this.show();
  }

  /* Play or pause. */
  toggle() { this.playback.toggle(); }

  later() { this.frame ||= requestAnimationFrame(() => { this.frame = 0; this.show(); }); }

  show() {
    const { run, header, isStale } = this.store;
    this.showStatus();
    this.showNotes();
    this.grid.classList.toggle("is-stale", isStale);
    if (!run) {
      this.setPlots([], "");
      return;
    }
    if (header !== this.header) {
      this.header = header;
      this.choice.setColumns(run.columns);
      this.measured.setColumns(run.columns);
    }
    this.showPlots(run);
  }

  showPlots(run) {
    const kept = this.compare.kept?.run ?? null;
    const state = [[...this.store.selection], kept, this.measured.items, this.choice.names, this.header];
    if (!this.groups || state.some((value, k) => !isSame(value, this.groupState[k]))) {
      this.groups = this.choice.groups(run);
      this.groupState = state;
    }
    const lines = this.groups.map(([unit, columns]) => [unit, this.linesOf(columns, kept)]);
    const key = JSON.stringify(lines.map(([unit, own]) => [unit, own.map(({ data, ...line }) => line)]));
    this.setPlots(lines, key);
    if (this.isResized) this.resize();
    lines.forEach(([, own], k) => {
      const pairs = own.map(line => line.data ?? [run.time, curveOf(run, line)]);
      this.plots[k].setData(pairs, run.duration);
    });
    // Only the first values are announced, so the cells of bands come last.
    const shown = this.groups.flatMap(([, columns]) => columns);
    this.values.show([...shown.filter(({ cells }) => !cells), ...shown.flatMap(({ cells }) => cells ?? [])]);
    this.measured.showDeviations(run, kept);
  }

  /* Lines of a plot: the present ones, then those of A and the measured ones in the same colours. */
  linesOf(columns, kept) {
    return columns.flatMap((column, colour) => {
      const base = { name: column.name, isStep: column.isStep, isSelected: column.isSelected, colour };
      // A band has a line for each edge.
      const columns = column.cells ?? [column], edges = column.cells ? ["low", "high"] : [""];
      const cells = columns.map(({ name }) => name);
      const lines = edges.map(edge => ({ ...base, cells, edge, label: column.name, role: "now" }));
      if (columns.every(own => hasColumn(kept, own))) {
        lines.push(...lines.map(line => ({
          ...line, label: `A: ${column.name}`, role: "kept", isSelected: false, data: [kept.time, curveOf(kept, line)],
        })));
      }
      for (const { label, time, values } of columns.flatMap(own => this.measured.linesOf(own))) {
        lines.push({ ...base, label, role: "measured", isSelected: false, isStep: false, data: [time, values] });
      }
      return lines;
    });
  }

  setPlots(lines, key) {
    if (key === this.layout) return;
    this.layout = key;
    for (const plot of this.plots) plot.remove();
    const size = this.sizeFor(lines.length);
    this.plots = lines.map(([unit, own]) => {
      const plot = new Plot(this.grid, unit, this.store);
      plot.setLines(own, size);
      return plot;
    });
    this.isResized = true;
  }

  sizeFor(count) {
    const width = this.element.clientWidth - 24;
    const columns = width >= WIDE && count > 1 ? 2 : 1;
    const rows = Math.max(1, Math.ceil(count / columns));
    const caption = Math.max(22, ...this.plots.map(plot => plot.captionHeight));
    const height = (this.element.clientHeight - this.bar.offsetHeight - this.status.offsetHeight - 16) / rows - caption;
    return {
      width: Math.max(160, Math.floor((width - GAP * (columns - 1)) / columns)), height: Math.round(Math.min(HIGHEST, Math.max(LOWEST, height))),
    };
  }

  /* Fit the plots into the panel; reading sizes makes the browser lay out the page, so that it is not done per run. */
  resize() {
    this.isResized = false;
    const size = this.sizeFor(this.plots.length);
    this.grid.style.gridTemplateColumns = `repeat(auto-fill, ${size.width}px)`;
    for (const plot of this.plots) plot.resize(size);
  }

  showStatus() {
    const { run, isStale, isBusy } = this.store;
    this.element.setAttribute("aria-busy", String(isBusy));
    let shown = text("curves.empty");
    if (run && isStale) shown = text("curves.stale");
    else if (run) shown = statusOf(run, this.store.state.view.run.stop_when);
    if (this.status.textContent !== shown) this.status.textContent = shown;
    this.status.classList.toggle("is-bad", Boolean(run) && !isStale && !["done", "stopped"].includes(run.status));
  }

  showNotes() {
    const { run, state } = this.store;
    const notes = [...new Set([...state?.notes ?? [], ...run?.notes ?? []])];
    this.notes.hidden = !run;
    this.notesTitle.textContent = notes.length ? `${text("curves.notes")} (${notes.length})` : text("curves.notes");
    const isShown = this.notesList.childElementCount === notes.length;
    if (isShown && [...this.notesList.children].every((item, k) => item.textContent === notes[k])) return;
    this.notesList.replaceChildren(...notes.map(note => Object.assign(document.createElement("li"), { textContent: note })));
  }
}

/* Values of a line: those of a column, or the smallest or largest of the cells of a tube. */
function curveOf(run, { cells, edge }) {
  const [first = [], ...others] = cells.map(name => run.series.get(name) ?? []);
  if (!edge) return first;
  const best = edge === "low" ? Math.min : Math.max;
  return Array.from(first, (value, k) => others.reduce((extreme, curve) => best(extreme, curve[k]), value));
}

function statusOf({ status, time, seconds, duration, isShort, until }, conditions) {
  const last = digits(time.at(-1) ?? 0, duration);
  if (isShort) return text("curves.short", { until: digits(until, duration) });
  const milliseconds = 1000 * seconds < 10 ? (1000 * seconds).toPrecision(2) : Math.round(1000 * seconds);
  if (status === "done") return text("curves.status_done", { duration: last, milliseconds });
  if (status !== "stopped") return text(FAILURES[status], { time: last });
  // The domain of a characteristic is a condition that the file does not state.
  return conditions ? text("curves.status_stopped", { time: last, conditions: [conditions].flat().join(", ") })
    : text("curves.status_domain", { time: last });
}

function isSame(a, b) {
  return a === b || Array.isArray(a) && Array.isArray(b) && a.length === b.length && a.every((value, k) => value === b[k]);
}
