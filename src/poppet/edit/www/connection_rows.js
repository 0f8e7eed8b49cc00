/* Rows of the ports and inputs of a part: what they are connected to, as texts. */

import { connection, split } from "./connections.js";
import { make } from "./elements.js";
import { InputRow } from "./field_row.js";
import { text } from "./strings.js";
import { inWords, plainValue } from "./field_values.js";

const AMBIENT = "ambient";
const HOSE = "20 cm^3";  // volume of a chamber between two ports

/* Row of a port, of a tube end or of a body. */
export class PortRow extends InputRow {
  constructor(store, part, port) {
    const label = inWords(port.name);
    super(store, { address: `${part}.${port.name}`, label, help: port.doc });
    Object.assign(this, { part, port });
    if (port.required) this.name.append(make("span", { class: "required" }, ` ${text("form.required")}`));
    this.input.placeholder = text(port.required ? "form.connect" : "form.connect_optional");
    this.element.dataset.type = "port";
  }

  present() { return String(this.store.state.view.parts[this.part]?.ports[this.port.name] ?? ""); }

  problem(typed) {
    const { view } = this.store.state;
    const reason = this.#plan(typed.trim())?.reason;
    return unknownPart(view, typed, this.part, AMBIENT) || (reason ? text(reason) : "");
  }

  operations(typed) {
    const to = typed.trim();
    if (!to) return [{ op: "disconnect", port: this.address }];
    const plan = this.#plan(to);
    if (!plan?.insert) return plan?.operations ?? [{ op: "connect", port: this.address, to }];
    const fields = { ...this.store.start[plan.insert] };
    if (plan.insert === "chamber") fields.volume = { ...fields.volume, value: HOSE };
    return [{ op: "add", kind: plan.insert, name: this.#between(plan.insert), fields }, ...plan.operations];
  }

  /* Plan of a connection to an end of the drawing; between two ports, a part is inserted. */
  #plan(to) {
    const { view } = this.store.state;
    const [part, port] = split(to);
    const end = to === AMBIENT ? { type: AMBIENT } : this.store.entry(part)?.ports.find(({ name }) => name === port);
    if (!end) return null;
    const from = { address: this.address, part: this.part, port: this.port.name, type: this.port.type };
    const target = { address: to, part, port, type: end.type };
    return connection(view, from, target, () => [], this.#between(from.type === "body" ? "mass" : "chamber"));
  }

  /* Free name for a part that is inserted. */
  #between(kind) {
    const { parts } = this.store.state.view;
    let name = kind;
    for (let number = 2; name in parts; number++) name = `${kind}_${number}`;
    return name;
  }

  update() {
    super.update();
    this.offer(targetsOf(this.store, this.part, this.port), text("form.nothing"));
  }
}

/* Row of an input that no field of the part has: the output that it is connected to. */
export class LinkRow extends InputRow {
  constructor(store, part, input, { isNamed = true } = {}) {
    const label = isNamed ? inWords(input.name) : text("form.driven_by");
    super(store, { address: `${part}.${input.name}`, label, help: isNamed ? helpOf(input, isGiven(store, part, input)) : "" });
    Object.assign(this, { part, source: input });
    this.element.dataset.type = "link";
    this.input.readOnly = isGiven(store, part, input);
    this.input.placeholder = text("form.connect_optional");
    if (!isNamed) {
      this.input.removeAttribute("name");
      this.input.setAttribute("aria-label", text("form.driver_of", { name: inWords(input.name) }));
    }
  }

  present() { return driverOf(this.store.state.view, this.part, this.source.name) || (this.source.source ?? ""); }

  problem(typed) { return unknownPart(this.store.state.view, typed, this.part); }

  operations(typed) {
    const output = typed.trim();
    if (!output) return [{ op: "unlink", input: this.address }];
    const signal = this.address in this.store.state.view.signals ? [{ op: "signal", address: this.address, table: null }] : [];
    return [...signal, { op: "link", input: this.address, output }];
  }

  update() {
    super.update();
    this.offer(this.input.readOnly ? [] : outputsFor(this.store, this.part, this.source.doc), text("form.nothing"));
  }
}

/* Return an error if an address names no other part, otherwise an empty text. */
function unknownPart(view, typed, part, ...others) {
  const name = typed.trim().split(".")[0];
  if (!name || others.includes(typed.trim())) return "";
  if (name === part) return text("form.itself", { name });
  return name in view.parts ? "" : text("form.no_part", { name });
}

/* Return the output that an input is connected to, or an empty text. */
export function driverOf(view, part, input) {
  const stated = plainValue(view.parts[part]?.fields[input]);
  const isAddress = typeof stated === "string" && /^[A-Za-z][\w-]*\.[\w.-]+$/.test(stated) && stated.split(".")[0] in view.parts;
  return view.connections[`${part}.${input}`] ?? (isAddress ? stated : "");
}

/* Return the addresses that a port can be connected to. */
export function targetsOf(store, part, port) {
  const { view } = store.state;
  const others = Object.keys(view.parts).filter(name => name !== part);
  const ends = type => others.flatMap(name => (store.entry(name)?.ports ?? [])
    .filter(end => end.type === type).map(end => ({ name, port: end.name, address: end.name ? `${name}.${end.name}` : name })));
  if (port.type === "body") return ends("body").filter(end => !end.port).map(end => end.address);
  const isOpen = end => view.parts[end.name].ports[end.port] === undefined;
  const open = [...ends("tube"), ...ends("port")].filter(isOpen);
  return [...ends("store").map(end => end.address), ...(port.type === "tube" ? [] : [AMBIENT]), ...open.map(end => end.address)];
}

/* Return the outputs of other parts with a unit. */
export function outputsFor(store, part, unit) {
  const { view } = store.state;
  const names = new Set();
  const isOther = name => name.split(".")[0] !== part && name.split(".")[0] in view.parts;
  for (const column of store.header?.columns ?? []) {
    if (column.unit === unit && isOther(column.name)) names.add(column.name);
  }
  const usual = { Pa: ["store", "pressure"], K: ["store", "temperature"], m: ["body", "position"], "m/s": ["body", "velocity"] }[unit];
  for (const name of Object.keys(view.parts)) {
    for (const port of store.entry(name)?.ports ?? []) {
      const address = port.name ? `${name}.${port.name}` : name;
      if (name === part) continue;
      if (usual && port.type === usual[0] && (port.type === "store" || !port.name)) names.add(`${address}.${usual[1]}`);
      if (port.type === "output" && port.name !== "output") names.add(address);
    }
  }
  return [...names];
}

/* True if the part itself names the output of an input in another field, as conditions of a sequence do. */
export function isGiven(store, part, input) {
  return Boolean(input.source) && !store.entry(part).fields.some(({ name }) => name === input.name);
}

function helpOf({ doc }, isNamed) {
  if (isNamed) return text("form.link_named");
  return doc && doc !== "1" ? text("form.link_help", { unit: doc }) : text("form.link_plain");
}
