/* Results for screen readers: a table of the curves, and an announcement after each run. */

import { digits, displayOf, noiseOf, prettyUnit, sizeOf, valueAt } from "./quantities.js";
import { text } from "./strings.js";

const ROWS = 11;
const ANNOUNCED = 3;
const QUIET = 900;  // ms without another run

/* Table and announcement of the shown columns. */
export class Values {
  constructor(parent, store) {
    Object.assign(this, { store, columns: [], timer: 0, last: "" });
    this.details = parent.appendChild(document.createElement("details"));
    this.details.appendChild(document.createElement("summary")).textContent = text("curves.table");
    const scroll = this.details.appendChild(document.createElement("div"));
    scroll.className = "scroll";
    scroll.tabIndex = 0;
    scroll.setAttribute("role", "region");
    scroll.setAttribute("aria-label", text("curves.table"));
    this.table = scroll.appendChild(document.createElement("table"));
    this.details.addEventListener("toggle", () => this.fill());
    store.addEventListener("run", () => {
      // The last result is not that of the present circuit.
      if (store.isStale && store.message === this.last) store.announce("");
    });
    store.addEventListener("open", () => {
      clearTimeout(this.timer);
      this.last = "";
    });
  }

  show(columns) {
    this.columns = columns;
    this.fill();
    clearTimeout(this.timer);
    if (!this.store.isStale && !this.store.run.isShort) this.timer = setTimeout(() => this.announce(), QUIET);
  }

  fill() {
    const { run, units } = this.store;
    if (!this.details.open || !run) return;
    const caption = document.createElement("caption");
    caption.textContent = text("curves.table_caption");
    const displays = this.columns.map(({ unit }) => displayOf(unit, units));
    const titles = this.columns.map(({ name }, k) => (displays[k].unit ? `${name} [${prettyUnit(displays[k].unit)}]` : name));
    const body = Array.from({ length: ROWS }, (_, row) => {
      const time = (run.time.at(-1) ?? 0) * row / (ROWS - 1);
      const values = this.columns.map(({ name, unit, isStep }, k) => {
        const curve = run.series.get(name);
        return this.shown(curve, valueAt(run.time, curve, time, isStep), displays[k], unit);
      });
      return rowOf("td", [digits(time, run.duration), ...values]);
    });
    const head = document.createElement("thead");
    head.append(rowOf("th", [text("curves.head_time"), ...titles]));
    const tbody = document.createElement("tbody");
    tbody.append(...body);
    this.table.replaceChildren(caption, head, tbody);
  }

  /* Value with the digits that suit the largest value of its curve; noise of the solver is 0. */
  shown(values, value, display, si) {
    const size = sizeOf(values);
    const clean = Math.abs(value) < noiseOf(si, size) ? 0 : value;
    return digits(display.from(clean), 0.1 * Math.abs(display.from(Math.max(size, noiseOf(si)))));
  }

  announce() {
    const { run, units } = this.store;
    if (!run) return;
    const values = this.columns.slice(0, ANNOUNCED).map(({ name, unit }) => {
      const display = displayOf(unit, units);
      const value = this.shown(run.series.get(name) ?? [], run.series.get(name)?.at(-1) ?? NaN, display, unit);
      return text("curves.summary_value", { name, value, unit: prettyUnit(display.unit) }).trim();
    });
    const message = text("curves.summary", { values: values.join("; ") });
    if (message === this.last) return;
    this.last = message;
    this.store.announce(message);
  }
}

function rowOf(tag, cells) {
  const row = document.createElement("tr");
  for (const cell of cells) {
    const element = row.appendChild(document.createElement(tag));
    element.textContent = cell;
    if (tag === "th") element.scope = "col";
  }
  return row;
}
