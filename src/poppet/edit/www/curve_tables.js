/* Editor of a field that is a table of columns, such as a characteristic: a plot and a table of points. */

import { CurvePlot } from "./curve_plot.js";
import { fillOptions, make, newId } from "./elements.js";
import { PointTable } from "./point_table.js";
import { text } from "./strings.js";
import { fromSi, parts, shown, siOf, withUnit } from "./units.js";
import { inWords } from "./field_values.js";

const STROKE = {
  kind: "table", stroke: ["0 mm", "0.5 mm", "1 mm"], sonic_conductance: ["0 dm^3/(s bar)", "0.8 dm^3/(s bar)", "1 dm^3/(s bar)"],
  critical_ratio: 0.3, source: "assumed",
};
const SPOOL = {
  position: [-1, 0, 0.1, 0.5, 1],
  sonic_conductance: ["0 dm^3/(s bar)", "0 dm^3/(s bar)", "0.1 dm^3/(s bar)", "1.2 dm^3/(s bar)", "2 dm^3/(s bar)"],
  critical_ratio: 0.3, source: "assumed",
};
const FORCES = {
  contraction: [0, 0.1, 0.25], force_per_pressure: ["250 N/bar", "140 N/bar", "30 N/bar"], passive_force: ["0 N", "-200 N", "-250 N"],
};
const SCHEDULE = { pressure: ["2 bar", "4 bar"], gain: ["0.5 1/bar", "0.5 1/bar"], integral_time: ["0.1 s", "0.1 s"] };

/* Return a table to begin with for a field of a kind of part, or null. */
export function startTable(kind, field) {
  if (field.endsWith("characteristic")) return kind === "spool_valve" ? SPOOL : STROKE;
  return { force_table: FORCES, schedule: SCHEDULE }[field.split(".").at(-1)] ?? null;
}

/* Return the names of the columns of a table with lists of equal length, the first of them is the argument. */
export function columnsOf(value) {
  if (value === null || typeof value !== "object" || Array.isArray(value)) return [];
  const names = Object.keys(value).filter(name => Array.isArray(value[name]) && value[name].every(item => typeof item !== "object"));
  const count = value[names[0]]?.length;
  return names.length > 1 && count > 0 && names.every(name => value[name].length === count) ? names : [];
}

/* Points of a field; each column is set as an own value, so that the rest of the table is unchanged. */
export class CurveTable {
  constructor(store, { address, read, start = null }) {
    Object.assign(this, { store, address, read, isDirty: false });
    const id = newId();
    this.input = make("select", { id, onchange: () => this.update() });
    this.choice = make("label", { for: id, class: "column" }, text("signals.column"), this.input);
    this.body = make("div", { class: "signal" });
    const begin = () => store.apply([{ op: "set", address, value: start }]);
    this.begin = make("button", { type: "button", class: "small", onclick: begin }, text("signals.begin_table"));
    this.hasStart = start !== null;
    this.element = make("div", { class: "field" }, this.begin, this.body);
  }

  commit() {}

  update() {
    const value = this.read();
    const names = columnsOf(value);
    this.begin.hidden = !this.hasStart || typeof value === "object";
    this.body.hidden = !names.length;
    this.element.hidden = this.begin.hidden && this.body.hidden;
    if (!names.length) return;
    if (names.join("|") !== this.built) this.#build(names);
    fillOptions(this.input, names.slice(1), inWords);
    this.choice.hidden = names.length < 3;
    const count = value[names[0]].length;
    this.table.show(Array.from({ length: count }, (_, k) => names.map(name => String(value[name][k]))));
    this.#draw();
  }

  get names() { return [columnsOf(this.read())[0], this.input.value]; }

  #build(names) {
    this.built = names.join("|");
    this.plot = new CurvePlot({
      label: text("signals.plot", { name: this.address }), moved: (...move) => this.#move(...move),
      name: k => this.names.map(name => this.read()[name][k]).join(", "),
    });
    const columns = names.map(key => ({ key, label: inWords(key) }));
    this.table = new PointTable({ columns, changed: rows => this.#setRows(names, rows), added: () => this.#add(names), least: 2 });
    this.body.replaceChildren(this.choice, this.plot.svg, this.table.element);
  }

  #draw() {
    const value = this.read();
    const [x, y] = this.names;
    const units = [x, y].map(name => parts(value[name][0])?.unit ?? "");
    const [across, up] = [x, y].map((name, k) => value[name].map(item => this.#number(item, units[k])));
    const points = across.map((place, k) => [place, up[k]]);
    this.plot.draw(points, points.filter(point => point.every(Number.isFinite)), { x: units[0], y: units[1] });
  }

  /* A value of the column as a number in the unit of its first value. */
  #number(item, unit) {
    const typed = parts(item);
    if (!typed || typed.unit === unit) return typed ? Number(typed.number) : NaN;
    const si = siOf(item, unit, this.store.units);
    return si === null ? NaN : Number(fromSi(si, unit, unit, this.store.units) ?? NaN);
  }

  #setRows(names, rows, options) {
    const value = this.read();
    const operations = names.map((name, k) => {
      const former = index => value[name][index] ?? value[name].at(-1);
      const column = rows.map((row, index) => typedValue(row[k], former(index)));
      return { op: "set", address: `${this.address}.${name}`, value: column };
    }).filter(({ address, value: column }) => JSON.stringify(column) !== JSON.stringify(value[address.slice(this.address.length + 1)]));
    if (operations.length) this.store.apply(operations, options);
  }

  #move(index, across, up) {
    const value = this.read(), names = columnsOf(value);
    const rows = value[names[0]].map((_, k) => names.map(name => String(value[name][k])));
    [across, up].forEach((number, k) => {
      const name = this.names[k];
      rows[index][names.indexOf(name)] = withUnit(shown(number, 6), parts(value[name][0])?.unit ?? "");
    });
    this.#setRows(names, rows, { continues: true });
  }

  #add(names) {
    const value = this.read();
    const rows = value[names[0]].map((_, k) => names.map(name => String(value[name][k])));
    const [before, last] = rows.slice(-2);
    const [first, second] = [before, last].map(row => Number(parts(row[0])?.number));
    const next = withUnit(shown(2 * second - first, 6), parts(last[0])?.unit ?? "");
    this.#setRows(names, [...rows, [next, ...last.slice(1)]]);
  }
}

/* Typed text as a value; a number without a unit gets the unit of the former value. */
function typedValue(word, former) {
  if (!/^[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?$/.test(word)) return word;
  const unit = parts(former)?.unit;
  return unit ? withUnit(word, unit) : Number(word);
}
