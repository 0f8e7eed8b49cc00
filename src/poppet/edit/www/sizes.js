/* Choice among the fields that state the size of a part; exactly one of them is stated. */

import { startTable } from "./curve_tables.js";
import { make, newId } from "./elements.js";
import { FieldRow } from "./field_row.js";
import { text } from "./strings.js";
import { parts, shown, withUnit } from "./units.js";
import { inWords, plainValue } from "./field_values.js";

const NOTE = "starting value of the editor";

/* Sizes that have nearly the same flow, torque or air consumption. */
const ALIKE = {
  sonic_conductance: [1, "dm^3/(s bar)"],
  effective_area: [5, "mm^2"],
  flow_coefficient_kv: [0.21, ""],
  flow_coefficient_cv: [0.25, ""],
  nominal_flow: [250, "l/min ANR"],
  displacement: [20, "cm^3/rad"],
  rated_torque: [12, "N m"],
  nozzle_conductance: [0.1, "dm^3/(s bar)"],
  air_consumption: [42, "l/min ANR"],
};

/* Return the choices of a kind of part: that of the part and those of its groups. */
export function sizeGroups(entry) {
  const groups = [{ name: "", sizes: entry.sizes }, ...entry.groups];
  return groups.filter(({ sizes }) => sizes.length > 1).map(({ name, sizes }) => new SizeGroup(name, sizes, entry));
}

class SizeGroup {
  constructor(name, names, entry) {
    Object.assign(this, { name, names });
    this.fields = new Map(entry.fields.map(field => [field.name, field]));
    this.hasModel = !name && [...this.fields.values()].some(field => field.type === "model");
  }

  /* Sizes that are displayed first: the stated ones; without a model, the first one if there is none. */
  shown(fields) {
    const stated = this.names.filter(name => name in fields);
    return stated.length || (this.hasModel && "model" in fields) ? stated : [this.names[0]];
  }

  others(fields) {
    const first = this.shown(fields);
    return this.names.filter(name => !first.includes(name));
  }
}

/* Row of a field that can state the size; another size replaces the stated one in the same step. */
export class SizeRow extends FieldRow {
  constructor(store, details) {
    super(store, details);
    Object.assign(this, { part: details.part, group: details.group });
  }

  operations(typed) {
    const operations = super.operations(typed);
    const fields = this.store.state.view.parts[this.part]?.fields ?? {};
    if (!operations?.length || operations[0].value === null) return operations;
    return [...replacing(this.part, this.group, fields, this.field.name), ...operations];
  }
}

/* Operations that remove what cannot be stated beside a size. */
function replacing(part, group, fields, name) {
  // An area and a characteristic determine the critical ratio.
  const ratio = /effective_area|characteristic/.test(name) ? [name.replace(/[^.]+$/, "critical_ratio")] : [];
  const removed = [...group.names.filter(other => other !== name), ...ratio].filter(other => other in fields);
  return removed.map(other => ({ op: "set", address: `${part}.${other}`, value: null }));
}

/* Selection of the field that states the size; another choice replaces the field in one step. */
export class SizeChoice {
  constructor(store, part, group) {
    Object.assign(this, { store, part, group, isDirty: false });
    const id = newId();
    this.input = make("select", { id, onchange: () => this.#change() });
    this.element = make("div", { class: "field size" },
      make("div", { class: "head" }, make("label", { for: id }, text("form.size"))), make("div", { class: "value" }, this.input));
  }

  get fields() { return this.store.state.view.parts[this.part]?.fields ?? {}; }

  update() {
    const { group } = this;
    const present = group.shown(this.fields)[0] ?? "";
    const names = [...group.names, ...(present ? [] : [""])];
    if (this.input.options.length !== names.length) {
      this.input.replaceChildren(...names.map(value =>
        make("option", { value }, value ? inWords(value) : text("form.size_of_model"))));
    }
    this.input.value = present;
  }

  #change() {
    const { group, fields, part } = this;
    const name = this.input.value;
    const stated = group.names.filter(other => other in fields);
    const operations = replacing(part, group, fields, name);
    operations.push({ op: "set", address: `${part}.${name}`, value: this.#start(name, stated[0]) });
    this.store.apply(operations);
  }

  /* Start value of a size, nearly as large as the former one if that has the usual unit. */
  #start(name, former) {
    const field = this.group.fields.get(name);
    if (field.type !== "number") return startTable(this.store.state.view.parts[this.part].kind, name);
    const [number, unit] = ALIKE[name.split(".").at(-1)] ?? [1, field.units[0]];
    const value = shown(number * this.#ratio(former), 3);
    return { value: unit ? withUnit(value, unit) : Number(value), source: "assumed", note: NOTE };
  }

  #ratio(former) {
    const [number, unit] = ALIKE[former?.split(".").at(-1)] ?? [];
    const typed = parts(plainValue(this.fields[former]));
    return typed && typed.unit === unit && Number(typed.number) > 0 ? Number(typed.number) / number : 1;
  }
}
