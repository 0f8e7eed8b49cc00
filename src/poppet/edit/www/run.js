/* Title of the circuit, run options, stop conditions, ambient and gas. */

import { make } from "./elements.js";
import { FieldRow, InputRow } from "./field_row.js";
import { text } from "./strings.js";
import { plainValue } from "./field_values.js";

const STOP = "stop_when";

/* Panel of the circuit. */
export class Run {
  constructor(element, store) {
    Object.assign(this, { element, store, rows: [] });
    store.addEventListener("state", () => this.update());
    store.addEventListener("flush", () => { for (const row of this.rows) if (row.isDirty) row.commit(); });
  }

  update() {
    if (!this.rows.length && this.store.sections.run) this.#build();
    for (const row of this.rows) row.update();
  }

  #build() {
    const { store } = this;
    const title = new TextRow(store, { address: "title", label: text("run.title") }, view => view.title ?? "");
    const stop = new StopRow(store);
    const rows = table => store.sections[table].filter(field => field.name !== STOP).map(field => new TableRow(store, table, field));
    const [run, ambient, gas] = ["run", "ambient", "gas"].map(rows);
    this.rows = [title, ...run, stop, ...ambient, ...gas];
    const section = (name, content) => make("section", {}, make("h2", {}, text(`run.${name}`)), ...content.map(row => row.element));
    this.element.replaceChildren(
      title.element, section("run", [...run, stop]), section("ambient", ambient), section("gas", gas),
    );
  }
}

/* Row of a text at the top level of the file. */
class TextRow extends InputRow {
  constructor(store, details, read) {
    super(store, details);
    this.read = read;
  }

  present() { return String(this.read(this.store.state.view)); }

  operations(typed) { return [{ op: "set", address: this.address, value: typed.trim() || null }]; }
}

/* Row of a field of the table `run`, `ambient` or `gas`. */
class TableRow extends FieldRow {
  constructor(store, table, field) {
    // The ambient pressure is the reference of gauge pressures.
    const units = table === "ambient" ? field.units.filter(unit => !store.units[unit]?.gauge) : field.units;
    super(store, { owner: table, field: { ...field, units }, read: () => this.#read() });
    this.table = table;
  }

  #read() {
    const content = this.store.state.view[this.table];
    if (typeof content === "string") return this.field.name === "name" ? content : undefined;
    return content?.[this.field.name];
  }

  /* `gas = "helium"` becomes a table when another of its fields is set. */
  operations(typed) {
    const operations = super.operations(typed);
    const short = this.store.state.view[this.table];
    if (typeof short !== "string" || !operations?.length) return operations;
    if (this.field.name === "name") return operations.map(operation => ({ ...operation, address: this.table }));
    return [
      { op: "set", address: this.table, value: null }, { op: "set", address: `${this.table}.name`, value: short }, ...operations,
    ];
  }
}

/* Row of the stop conditions, one per line. */
class StopRow extends InputRow {
  constructor(store) {
    super(store, { address: `run.${STOP}`, label: text("run.stop"), help: text("run.stop_help"), isLong: true });
    this.input.placeholder = text("run.stop_example");
  }

  present() {
    const stated = plainValue(this.store.state.view.run?.[STOP]) ?? [];
    return (Array.isArray(stated) ? stated : [stated]).join("\n");
  }

  operations(typed) {
    const lines = typed.split("\n").map(line => line.trim()).filter(Boolean);
    const value = lines.length > 1 ? lines : lines[0] ?? null;
    return lines.join("\n") === this.present() ? [] : [{ op: "set", address: this.address, value }];
  }
}
