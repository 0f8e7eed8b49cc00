/* Editor of the signal of an input: kind, curve and values. */

import { CurvePlot } from "./curve_plot.js";
import { make, newId, show } from "./elements.js";
import { PointTable } from "./point_table.js";
import { KINDS, UNITS, courseOf, isOptional, startOf } from "./signal_kinds.js";
import { text } from "./strings.js";
import { fromSi, parts, shown, siOf, withUnit } from "./units.js";
import { ambientOf, isEqual, plainValue } from "./field_values.js";

const USUAL = { Pa: "bar", m: "mm", K: "degC", rad: "deg", "m/s": "mm/s", "kg/s": "l/min ANR" };  // of inputs without a field
const DURATION = 2;  // s, of a run without a duration
const LISTS = new Set(["steps", "points"]);

/* Signal of the input of a part. `field` is the field with the same name, or undefined. */
export class Signals {
  constructor(store, part, input, field) {
    Object.assign(this, { store, part, field, address: `${part}.${input.name}`, unit: input.doc || "1", isDirty: false });
    const id = newId();
    this.kind = make("select", { id, onchange: () => this.#choose() },
      make("option", { value: "" }, text("signals.none")),
      ...Object.keys(KINDS).map(value => make("option", { value }, text(`signals.${value}`))));
    this.input = this.kind;
    this.body = make("div", { class: "signal" });
    this.bad = make("p", { class: "bad", hidden: true });
    this.element = make("div", { class: "field" },
      make("div", { class: "head" }, make("label", { for: id }, text("signals.label"))), make("div", { class: "value" }, this.kind), this.bad, this.body);
    this.kind.setAttribute("aria-label", text("signals.of", { name: this.address }));
  }

  commit() {}

  /* Table of the signal; a value alone is a constant. */
  get table() {
    const stated = this.store.state.view.signals[this.address];
    if (stated === undefined) return null;
    return stated !== null && typeof stated === "object" && "kind" in stated ? stated : { kind: "constant", value: stated };
  }

  get ambient() { return ambientOf(this.store.state.view, this.store.units); }

  get duration() {
    const stated = plainValue(this.store.state.view.run?.duration);
    return siOf(stated ?? "", "s", this.store.units) || DURATION;
  }

  /* Unit in which values are displayed: that of the file, otherwise the usual one. */
  get shownUnit() {
    const { table } = this;
    const first = [table?.values?.[0], table?.value, table?.mean, table?.low].find(value => value !== undefined && typeof value !== "object");
    return parts(first ?? "")?.unit || (this.unit === "1" ? "" : first === undefined ? this.usualUnit : this.unit);
  }

  get usualUnit() { return this.field?.units?.[0] ?? USUAL[this.unit] ?? (this.unit === "1" ? "" : this.unit); }

  update() {
    const { table } = this;
    const kind = table?.kind ?? "";
    if (![...this.kind.options].some(({ value }) => value === kind)) this.kind.append(make("option", { value: kind }));
    this.kind.value = kind;
    if (kind !== this.built) this.#build(kind);
    if (kind in KINDS) this.#fill(table);
    this.#showErrors();
  }

  #showErrors() {
    const errors = this.store.errors.filter(({ address }) => `${address}.`.startsWith(`signals.${this.address}.`));
    show(this.bad, errors.map(({ message, hint }) => [message, hint].filter(Boolean).join(" ")).join(" "));
    if (errors.length) this.bad.dataset.address = errors[0].address;
    else delete this.bad.dataset.address;
  }

  #apply(table, { continues = false } = {}) {
    if (table && isEqual(table, this.table)) return null;
    const operations = [{ op: "signal", address: this.address, table }];
    if (table && this.address in this.store.state.view.connections) operations.unshift({ op: "unlink", input: this.address });
    return this.store.apply(operations, { continues });
  }

  #choose() {
    const kind = this.kind.value;
    this.#apply(kind ? { kind, ...startOf(kind, this.#start()) } : null);
  }

  /* Typical values of the input, from its present value. */
  #start() {
    const { field, unit, usualUnit, store, ambient, duration } = this;
    const stated = plainValue(store.state.view.parts[this.part]?.fields[field?.name]) ?? field?.default ?? 0;
    const si = siOf(stated, unit, store.units, ambient) ?? 0;
    const present = Number(fromSi(si, unit, usualUnit, store.units, ambient) ?? 0);
    const high = unit === "1" ? 1 : present ? 2 * present : 1;
    const low = unit === "1" ? 0 : present;
    const typed = (number, name = usualUnit) => (name ? withUnit(shown(number, 6), name) : Number(shown(number, 6)));
    const difference = usualUnit.replace(/ g$/, "").replace("degC", "K");
    return { low: typed(low), high: typed(high), mean: typed((low + high) / 2), span: typed((high - low) / 2, difference), duration };
  }

  /* --- Structure --- */

  #build(kind) {
    this.built = kind;
    this.plot = this.points = this.inputs = null;
    const content = [];
    if (kind in KINDS && kind !== "constant" && kind !== "file") {
      const isList = LISTS.has(kind);
      this.plot = new CurvePlot({
        label: text("signals.plot", { name: this.address }),
        ...(isList ? { moved: (...move) => this.#move(...move), added: (x, y) => this.#add(x, y), name: k => this.#pointName(k) } : {}),
      });
      content.push(this.plot.svg);
    }
    if (LISTS.has(kind)) {
      const columns = ["times", "values"].map(key => ({ key, label: text(`signals.${key}`) }));
      this.points = new PointTable({ columns, changed: rows => this.#setRows(rows), added: () => this.#add() });
      content.push(this.points.element, make("p", { class: "help" }, text("signals.help")));
    } else if (kind in KINDS) {
      this.inputs = new Map(Object.keys(KINDS[kind]).map(name => [name, this.#parameter(kind, name)]));
      content.push(make("div", { class: "parameters" }, ...[...this.inputs.values()].map(input => input.parentElement)));
    }
    this.body.replaceChildren(...content);
  }

  #parameter(kind, name) {
    const label = text(`signals.${name}`);
    const input = make("input", {
      type: "text", autocomplete: "off", spellcheck: false, placeholder: isOptional(kind, name) ? text("form.optional") : "",
      "aria-label": text("signals.parameter", { name: label, address: this.address }), onchange: () => this.#setParameter(name, input.value),
      onkeydown: event => {
        if (event.key === "Enter") this.#setParameter(name, input.value);
        if (event.key === "Escape") input.value = typedText(this.table?.[name]);
      },
    });
    make("label", {}, make("span", {}, label), input);
    return input;
  }

  #fill(table) {
    for (const [name, input] of this.inputs ?? []) {
      if (document.activeElement !== input || input.value === input.dataset.shown) input.value = typedText(table[name]);
      input.dataset.shown = typedText(table[name]);
    }
    this.points?.show(this.#rows(table));
    this.#draw(table);
  }

  #rows(table) {
    const [times, values] = [table.times, table.values].map(list => (Array.isArray(list) ? list : []));
    return Array.from({ length: Math.max(times.length, values.length) }, (_, k) => [typedText(times[k]), typedText(values[k])]);
  }

  #draw(table) {
    if (!this.plot) return;
    const { shownUnit, duration } = this;
    const unitsOf = KINDS[table.kind];
    const number = name => this.#number(table[name], unitsOf[name] === "value" || unitsOf[name] === "difference" ? shownUnit : UNITS[unitsOf[name]]);
    const list = name => (Array.isArray(table[name]) ? table[name] : []).map(value => this.#number(value, name === "times" ? "s" : shownUnit));
    const course = courseOf(table.kind, { number, list, duration }) ?? this.#recorded();
    const handles = LISTS.has(table.kind) ? list("times").map((time, k) => [time, list("values")[k] ?? NaN]) : [];
    this.plot.draw(course, handles.filter(point => point.every(Number.isFinite)), { x: "s", y: shownUnit });
  }

  /* Values of the input in the last run. */
  #recorded() {
    const { run, units } = this.store;
    const values = run?.series.get(this.address);
    if (!values) return [];
    const every = Math.ceil(values.length / 600);
    const zero = this.#inShownUnit(0, units), one = this.#inShownUnit(1, units);
    return Array.from(run.time).flatMap((time, k) => (k % every ? [] : [[time, zero + (one - zero) * values[k]]]));
  }

  #inShownUnit(si, units) { return Number(fromSi(si, this.unit, this.shownUnit || this.unit, units, this.ambient) ?? si); }

  #number(value, unit) {
    const typed = parts(plainValue(value) ?? "");
    if (!typed) return NaN;
    if (typed.unit === unit || (!typed.unit && unit === "1")) return Number(typed.number);
    const isTime = unit === "s" || unit === "Hz";
    const si = siOf(plainValue(value), isTime ? unit : this.unit, this.store.units, this.ambient);
    return si === null ? NaN : isTime ? si : Number(fromSi(si, this.unit, unit || this.unit, this.store.units, this.ambient) ?? NaN);
  }

  /* --- Changes --- */

  #setParameter(name, typed) {
    const { kind } = this.table;
    const value = this.#typedValue(typed, KINDS[kind][name], this.table[name]);
    const { [name]: _, ...others } = this.table;
    const table = value === null ? others : { ...this.table, [name]: value };
    this.#apply(table);
  }

  /* Typed text as a value; a number gets the unit of the former value, or the usual one. */
  #typedValue(typed, type, former) {
    const word = typed.trim();
    if (!word) return null;
    if (type === "text" || !/^[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?$/.test(word)) {
      if (!/^[[{]/.test(word)) return word;
      try {
        return JSON.parse(word);
      } catch {
        return word;
      }
    }
    const unit = UNITS[type] ?? (former === undefined ? this.shownUnit : parts(former)?.unit ?? "");
    const isBare = typeof former === "number" || unit === "1" || !unit;
    return isBare ? Number(word) : withUnit(word, parts(former ?? "")?.unit || unit);
  }

  #setRows(rows, options) {
    const { table } = this;
    const column = (key, k, type) => rows.map((row, index) => this.#typedValue(row[k], type, table[key]?.[index] ?? table[key]?.at(-1)) ?? 0);
    this.#apply({ ...table, times: column("times", 0, "time"), values: column("values", 1, "value") }, options);
  }

  #move(index, time, value) {
    const { table } = this;
    const rows = this.#rows(table);
    const start = index === 0 && table.kind === "steps" ? 0 : Math.max(time, 0);
    const timeUnit = parts(table.times[index])?.unit || "s";
    rows[index] = [this.#inTimeUnit(start, timeUnit), String(shown(value, 6))];
    this.#setRows(rows, { continues: true });
  }

  #inTimeUnit(seconds, unit) { return String(fromSi(seconds, "s", unit, this.store.units) ?? seconds); }

  /* Add a point: at a place of the plot, otherwise behind the last one. */
  #add(time, value) {
    const { table, duration } = this;
    const rows = this.#rows(table);
    const times = table.times.map(item => siOf(item, "s", this.store.units) ?? 0);
    const last = times.at(-1) ?? 0;
    const at = time ?? (last < duration ? (last + duration) / 2 : last + duration / 10);
    const place = times.findIndex(other => other > at);
    const index = place < 0 ? rows.length : place;
    rows.splice(index, 0, [withUnit(shown(at, 4), "s"), value === undefined ? rows.at(-1)?.[1] ?? "0" : withUnit(shown(value, 4), this.shownUnit)]);
    this.#apply({ ...table, ...this.#lists(rows) });
  }

  #lists(rows) {
    const { table } = this;
    const value = (word, type, key) => this.#typedValue(word, type, table[key].at(-1)) ?? 0;
    return { times: rows.map(row => value(row[0], "time", "times")), values: rows.map(row => value(row[1], "value", "values")) };
  }

  #pointName(index) {
    const [time, value] = this.#rows(this.table)[index] ?? [];
    return text("signals.point_name", { number: index + 1, time, value });
  }
}

function typedText(value) {
  const plain = plainValue(value);
  return plain === undefined || plain === null ? "" : typeof plain === "object" ? JSON.stringify(plain) : String(plain);
}
