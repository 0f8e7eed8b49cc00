/* Measured curves: CSV files that are dropped on the curves, and the outputs that their columns measure. */

import { hasColumn } from "./compare.js";
import { readTable } from "./csv.js";
import { ambientOf } from "./field_values.js";
import { digits, displayOf, prettyUnit, scaleOf, valueAt } from "./quantities.js";
import { text } from "./strings.js";

const UNITS = {
  Pa: ["Pa", "kPa", "MPa", "mbar", "bar", "psi", "bar g", "mbar g", "kPa g", "psi g"], K: ["K", "degC"], m: ["m", "cm", "mm", "um"],
  "m/s": ["m/s", "mm/s"], rad: ["rad", "deg"], "rad/s": ["rad/s", "deg/s"], N: ["N", "kN"], kg: ["kg", "g"], "m^3": ["m^3", "l"],
  "kg/s": ["kg/s", "g/s", "kg/h", "l/min ANR", "m^3/h ANR", "l/min N"], 1: ["1", "%"], s: ["s", "ms", "min", "h"],
};

/* Columns of dropped files; each has an output (`target`) and a unit. */
export class Measured extends EventTarget {
  constructor(area, bar, parent, store) {
    super();
    Object.assign(this, { store, items: [], columns: [] });
    const label = bar.appendChild(document.createElement("label"));
    label.className = "file";
    label.append(text("measured.open"));
    const input = label.appendChild(document.createElement("input"));
    Object.assign(input, { type: "file", accept: ".csv,.txt", multiple: true });
    input.onchange = () => this.read([...input.files]).then(() => { input.value = ""; });
    this.section = parent.appendChild(document.createElement("section"));
    this.section.setAttribute("aria-label", text("measured.name"));
    this.section.className = "measured";
    this.section.hidden = true;
    listenToDrops(area, files => this.read(files));
    store.addEventListener("open", () => this.change([]));
  }

  /* Outputs that a column can measure. */
  setColumns(columns) {
    this.columns = columns;
    const isMeasured = ({ name, unit }, item) => name === item.target && (!item.unit || unitNamed(unit, item.unit));
    for (const item of this.items) {
      if (!columns.some(column => isMeasured(column, item))) item.target = "";
      if (!item.isChosen) this.match(item);
    }
    this.fill();
  }

  async read(files) {
    const added = [];
    for (const file of files) added.push(...this.itemsOf(file.name, await file.text()));
    if (added.length) this.change([...this.items, ...added]);
  }

  itemsOf(file, content) {
    let columns;
    try {
      columns = readTable(content);
    } catch (problem) {
      this.store.announce(text("measured.invalid", { file, problem: text(problem.message, problem.facts) }));
      return [];
    }
    const clock = columns.find(({ name }) => /^(time|t|zeit)$/i.test(name)) ?? columns[0];
    const unit = unitNamed("s", clock.unit || "s");
    if (!unit) {
      this.store.announce(text("measured.no_time", { file, unit: clock.unit }));
      return [];
    }
    const { factor } = scaleOf(unit, this.store.units);
    const time = clock.values.map(value => value * factor);
    const problem = problemOf(time);
    if (problem) {
      this.store.announce(text("measured.invalid", { file, problem: text(problem) }));
      return [];
    }
    if (!clock.unit) this.store.announce(text("measured.seconds", { file, name: clock.name }));
    return columns.filter(column => column !== clock).map(column => this.itemOf(file, time, column));
  }

  /* A column with the output of its name; a unit that is not known is to be chosen. */
  itemOf(file, time, column) {
    const isKnown = !column.unit || Object.keys(UNITS).some(si => unitNamed(si, column.unit));
    const note = isKnown ? "" : text("measured.unknown_unit", { unit: column.unit });
    const item = { file, time, ...column, unit: isKnown ? column.unit : "", note, target: "", isChosen: false };
    this.match(item);
    return item;
  }

  /* Take the output of the same name as the one that an item measures. */
  match(item) {
    const column = this.columns.find(({ name, unit }) => name === item.name && unitNamed(unit, item.unit || unit));
    if (column) Object.assign(item, { target: column.name, unit: unitNamed(column.unit, item.unit || column.unit) });
  }

  change(items) {
    this.items = items;
    this.fill();
    this.dispatchEvent(new Event("change"));
  }

  /* Measured lines of an output: {label, time, values in SI}. */
  linesOf({ name, unit: si }) {
    return this.items.filter(({ target }) => target === name).map(item => ({
      label: text("curves.measured", { name: item.name || item.file }), time: item.time, values: this.valuesOf(item, si),
    }));
  }

  valuesOf(item, si) {
    const unit = unitNamed(si, item.unit) ?? si;
    const { factor, offset } = scaleOf(unit, this.store.units);
    const gauge = this.store.units[unit]?.gauge ? ambientOf(this.store.state.view, this.store.units) : 0;
    return item.values.map(value => factor * (value + offset) + gauge);
  }

  /* --- List --- */

  fill() {
    this.section.hidden = !this.items.length;
    const heading = Object.assign(document.createElement("h3"), { textContent: text("measured.name") });
    this.section.replaceChildren(heading, ...this.items.map(item => this.row(item)));
  }

  row(item) {
    const row = document.createElement("p");
    const isAlone = this.items.every(one => one === item || one.name !== item.name);
    row.append(isAlone ? item.name || item.file : `${item.name || ""} (${item.file})`);
    const target = row.appendChild(document.createElement("select"));
    target.setAttribute("aria-label", `${item.name} ${text("measured.column")}`);
    target.add(new Option(text("measured.none"), ""));
    for (const { name, unit } of this.columns) if (!item.unit || unitNamed(unit, item.unit)) target.add(new Option(name, name));
    target.value = item.target;
    target.onchange = () => {
      Object.assign(item, { target: target.value, isChosen: true });
      this.change(this.items);
    };
    const column = this.columns.find(({ name }) => name === item.target);
    if (column) {
      const unit = row.appendChild(document.createElement("select"));
      unit.setAttribute("aria-label", text("measured.unit", { name: item.name }));
      for (const name of UNITS[column.unit] ?? [column.unit]) unit.add(new Option(prettyUnit(name), name));
      unit.value = unitNamed(column.unit, item.unit) ?? column.unit;
      unit.onchange = () => {
        Object.assign(item, { unit: unit.value, note: "" });
        this.change(this.items);
      };
    }
    if (item.note) row.appendChild(Object.assign(document.createElement("span"), { className: "why", textContent: item.note }));
    item.output = row.appendChild(document.createElement("output"));
    const gone = row.appendChild(document.createElement("button"));
    Object.assign(gone, { type: "button", textContent: "×", onclick: () => this.change(this.items.filter(one => one !== item)) });
    gone.setAttribute("aria-label", text("measured.gone", { name: item.name }));
    return row;
  }

  /* Show the root mean square of model minus measurement, for the present run and for A. */
  showDeviations(run, kept) {
    for (const item of this.items) {
      if (!item.output) continue;
      const column = this.columns.find(({ name }) => name === item.target);
      if (!column) {
        item.output.textContent = "";
        continue;
      }
      const { unit, from } = displayOf(column.unit, this.store.units);
      const shown = one => digits(from(deviation(one, item, this.valuesOf(item, column.unit))) - from(0));
      const places = { value: shown(run), unit: prettyUnit(unit) };
      item.output.textContent = hasColumn(kept, column) ? text("measured.rms_kept", { ...places, kept: shown(kept) }) : text("measured.rms", places);
    }
  }
}

/* Key of the message on a time column that is not usable, or an empty text. */
function problemOf(time) {
  if (!time.every(Number.isFinite)) return "measured.time_numbers";
  return time.some((value, k) => value < time[k - 1]) ? "measured.time_back" : "";
}

function deviation(run, { time, target }, measured) {
  const values = run.series.get(target) ?? [];
  let sum = 0, count = 0;
  for (let k = 0; k < time.length; k++) {
    const difference = valueAt(run.time, values, time[k]) - measured[k];
    if (!Number.isFinite(difference)) continue;
    sum += difference ** 2;
    count++;
  }
  return count ? Math.sqrt(sum / count) : NaN;
}

/* Unit of an SI unit's list that a file names, in any spelling of signs; null if it is not one. */
function unitNamed(si, name) {
  const plain = unit => unit.replace(/[\s()·]/g, "").replace("°", "deg").replace("²", "^2").replace("³", "^3");
  return (UNITS[si] ?? [si]).find(unit => plain(unit) === plain(name)) ?? null;
}

/* Read files that are dropped on the page, unless another panel takes them; the area shows that it does. */
function listenToDrops(area, read) {
  const isFile = event => !event.defaultPrevented && event.dataTransfer?.types.includes("Files");
  document.addEventListener("dragover", event => {
    if (!isFile(event)) return;
    event.preventDefault();
    area.classList.add("is-over");
  });
  document.addEventListener("dragleave", () => area.classList.remove("is-over"));
  document.addEventListener("drop", event => {
    area.classList.remove("is-over");
    if (!isFile(event)) return;
    event.preventDefault();
    read([...event.dataTransfer.files]);
  });
}
