/* Form of the selected part: name, size, fields, ports and inputs. */

import { LinkRow, PortRow, driverOf } from "./connection_rows.js";
import { make, show } from "./elements.js";
import { FieldRow, InputRow, bare } from "./field_row.js";
import { CurveTable, startTable } from "./curve_tables.js";
import { ModelRow } from "./model_row.js";
import { Signals } from "./signals.js";
import { overviewOf } from "./overview.js";
import { SizeChoice, SizeRow, sizeGroups } from "./sizes.js";
import { StepsRow } from "./steps.js";
import { text } from "./strings.js";
import { inWords } from "./field_values.js";

const FURTHER = 4;  // rank of fields that have a default
const NAME = /^[A-Za-z][A-Za-z0-9_-]{0,99}$/;
const RESERVED = new Set(["ambient", "gas", "run", "time", "title", "signals", "parts", "connections"]);
const NO_ENTRY = { fields: [], groups: [], sizes: [] };
const LISTED = 30;  // connections that a gas node shows

/* Panel that follows the selection of the store. */
export class Form {
  constructor(element, store) {
    Object.assign(this, { element, store });
    this.rows = [];
    this.closed = new Set();  // groups that the user closed, by kind and name
    for (const event of ["state", "selection"]) store.addEventListener(event, () => this.update());
    store.addEventListener("run", () => { if (store.header !== this.header) this.#showModel(); });
    store.addEventListener("flush", () => this.flush());
    this.update();
  }

  /* Apply typed values that are not applied yet. */
  flush() { for (const row of this.rows) if (row.isDirty) row.commit(); }

  update() {
    const { selection, state } = this.store;
    const part = selection.size === 1 ? [...selection][0] : null;
    const view = part === null ? null : state?.view.parts[part];
    if (!view) {
      this.#showOverview();
      return;
    }
    const outline = this.#outline(part);
    if (outline !== this.outline) this.#build(part, outline);
    for (const row of this.rows) row.update();
    this.#showErrors(part);
    this.#showConnections(part);
  }

  /* Show the numbers of another model, in the placeholders and in the curves of signals. */
  #showModel() {
    this.header = this.store.header;
    for (const row of this.rows) row.update();
  }

  #showOverview() {
    const { outline, build } = overviewOf(this.store);
    if (this.outline !== outline) {
      this.flush();
      const { elements, rows } = build();
      Object.assign(this, { outline, rows, part: null });
      this.element.replaceChildren(...elements);
    }
    for (const row of this.rows) row.update();
  }

  /* Text that changes when the form needs other rows. */
  #outline(part) {
    const entry = this.store.entry(part), view = this.store.state.view.parts[part];
    const sizes = entry ? sizeGroups(entry).map(group => group.shown(view.fields)) : [];
    const ports = entry?.ports.map(port => `${port.type}:${port.name}:${port.source ?? ""}`);
    const unknown = Object.keys(view.fields).filter(name => !entry?.fields.some(field => field.name === name));
    return JSON.stringify([part, view.kind, sizes, ports, unknown]);
  }

  /* --- Structure --- */

  #build(part, outline) {
    const isOther = this.part !== part;
    if (isOther) this.flush();
    const focus = this.#focus();
    const typed = new Map(isOther ? [] : this.rows.filter(row => row.isDirty).map(row => [row.key, row.input.value]));
    const entry = this.store.entry(part);
    Object.assign(this, { part, outline, rows: [] });
    this.rename = new RenameRow(this.store, part);
    this.rows.push(this.rename);
    this.errors = make("ul", { class: "errors", hidden: true });
    this.connections = make("div", { class: "connections", hidden: true });
    const kind = this.store.state.view.parts[part].kind;
    const content = [
      make("h2", { class: "sr-only" }, text("form.title", { part })),
      this.rename.element,
      make("p", { class: "kind" }, make("b", {}, kind || text("form.no_kind")), entry ? `: ${entry.summary}` : ""),
      this.errors,
      ...(entry ? this.#sections(part, entry) : [this.#kind(part)]),
      this.connections,
    ];
    this.element.replaceChildren(...content);
    if (isOther) this.element.scrollTop = 0;
    for (const row of this.rows) if (typed.has(row.key)) row.input.value = typed.get(row.key);
    this.#restoreFocus(focus);
  }

  #focus() {
    const active = document.activeElement;
    if (!this.element.contains(active)) return null;
    const row = this.rows.findIndex(({ element }) => element.contains(active));
    return { key: row < 0 ? null : this.rows[row].key, tag: active.tagName, type: active.type, start: active.selectionStart };
  }

  #restoreFocus(focus) {
    if (!focus) return;
    const row = this.rows.find(({ key }) => key === focus.key);
    const target = row && [...row.element.querySelectorAll(focus.tag)].find(element => element.type === focus.type && !element.hidden);
    (target ?? row?.input ?? this.rename.input).focus({ preventScroll: true });
  }

  #sections(part, entry) {
    const { fields } = this.store.state.view.parts[part];
    const groups = sizeGroups(entry);
    const inputs = new Map(entry.ports.filter(port => port.type === "input").map(port => [port.name, port]));
    const shown = entry.fields.filter(field => !isLink(field, inputs));
    const unknown = Object.keys(fields).filter(name => !entry.fields.some(field => field.name === name) && !inputs.has(name));
    const ranks = ranked(shown.filter(field => !field.group), fields, groups, inputs);
    const [main, further] = [ranks.filter(([rank]) => rank < FURTHER), ranks.filter(([rank]) => rank === FURTHER)];
    const sections = [
      ...groups.filter(group => !group.name).map(group => this.#size(part, group)),
      ...main.map(([, field]) => this.#field(part, field, inputs)),
      ...unknown.map(name => this.#field(part, unknownField(name), inputs)),
      this.#ports(part, entry),
      this.#inputs(part, entry, shown),
      further.length ? this.#details(entry.kind, "further", text("form.further"), further.map(([, field]) => this.#field(part, field, inputs))) : null,
    ];
    for (const group of entry.groups) {
      const own = ranked(shown.filter(field => field.group === group.name), fields, groups, inputs);
      const size = groups.filter(({ name }) => name === group.name).map(choice => this.#size(part, choice));
      if (own.length) sections.push(this.#group(entry.kind, group, [...size, ...own.map(([, field]) => this.#field(part, field, inputs))]));
    }
    return sections.filter(Boolean);
  }

  #size(part, group) {
    const choice = new SizeChoice(this.store, part, group);
    this.#add(choice, `size ${group.name}`);
    return choice.element;
  }

  #field(part, field, inputs) {
    const read = () => this.store.state.view.parts[part]?.fields[field.name];
    const group = this.store.entry(part)?.groups.find(({ name }) => name === field.group);
    const isRequired = field.required && !group?.optional;
    const sizes = sizeGroups(this.store.entry(part) ?? NO_ENTRY).find(({ names }) => names.includes(field.name));
    const Row = sizes ? SizeRow : field.type === "model" ? ModelRow : field.name === "steps" && field.form === "mapping" ? StepsRow : FieldRow;
    const row = this.#add(new Row(this.store, { owner: part, field, read, isRequired, part, group: sizes, ...this.#stepNames(part, field) }), field.name);
    if (field.type === "reference") {
      const start = startTable(this.store.state.view.parts[part].kind, field.name);
      row.element.append(this.#add(new CurveTable(this.store, { ...row, start }), `curve ${field.name}`).element);
    }
    const input = inputs.get(field.name);
    if (!input) return row.element;
    const driver = this.#add(new LinkRow(this.store, part, input, { isNamed: false }), `driver ${field.name}`);
    row.element.append(driver.element, this.#signal(part, input, field));
    return row.element;
  }

  /* Fields of a sequence that name one of its steps. */
  #stepNames(part, { name }) {
    const steps = () => Object.keys(this.store.state.view.parts[part]?.fields.steps ?? {});
    return ["start", "emergency"].includes(name) ? { choices: steps } : {};
  }

  #signal(part, input, field) { return this.#add(new Signals(this.store, part, input, field), `signal ${input.name}`).element; }

  #add(row, key) {
    row.key = key;
    this.rows.push(row);
    return row;
  }

  /* Field of a kind that is not valid. */
  #kind(part) {
    const field = { ...unknownField("kind"), doc: "", choices: [...this.store.palette.keys()] };
    return this.#add(new FieldRow(this.store, { owner: part, field, read: () => this.store.state.view.parts[part]?.kind }), "kind").element;
  }

  #ports(part, entry) {
    const ports = entry.ports.filter(port => port.name && ["port", "tube", "body"].includes(port.type));
    if (!ports.length) return null;
    const rows = ports.map(port => this.#add(new PortRow(this.store, part, port), `port ${port.name}`));
    return this.#details(entry.kind, "ports", text("form.ports"), rows.map(row => row.element));
  }

  #inputs(part, entry, shown) {
    const others = entry.ports.filter(port => port.type === "input" && !shown.some(field => field.name === port.name));
    if (!others.length) return null;
    const elements = others.map(port => {
      const { element } = this.#add(new LinkRow(this.store, part, port), `input ${port.name}`);
      if (!port.source) element.append(this.#signal(part, port));
      return element;
    });
    return this.#details(entry.kind, "inputs", text("form.inputs"), elements);
  }

  #group(kind, group, children) {
    const name = group.name.split(".").map(inWords).join(": ");
    const title = [name, group.optional ? text("form.group_optional") : ""].filter(Boolean).join(" ");
    return this.#details(kind, group.name, title, [group.doc ? make("p", { class: "help" }, group.doc) : null, ...children]);
  }

  #details(kind, name, title, children) {
    const key = `${kind} ${name}`;
    const element = make("details", { open: !this.closed.has(key) }, make("summary", {}, title), ...children);
    element.addEventListener("toggle", () => { this.closed[element.open ? "delete" : "add"](key); });
    return element;
  }

  /* --- Content that is not a row --- */

  #showErrors(part) {
    const rows = this.rows.filter(row => row.input?.name);
    const isOwn = address => address === part || address.startsWith(`${part}.`);
    const errors = this.store.errors.filter(({ address }) => isOwn(bare(address)) && !rows.some(row => row.concerns(bare(address))));
    this.errors.hidden = !errors.length;
    this.errors.replaceChildren(...errors.map(({ address, message, hint }) =>
      make("li", { class: "bad", "data-address": address }, [message, hint].filter(Boolean).join(" "))));
  }

  #showConnections(part) {
    const { view } = this.store.state;
    const to = value => typeof value === "string" && (value === part || value.startsWith(`${part}.`));
    const lines = [];
    for (const [name, { ports }] of Object.entries(view.parts)) {
      for (const [port, value] of Object.entries(ports)) if (to(value)) lines.push([name, `${name}.${port} → ${value}`]);
    }
    for (const name of Object.keys(view.parts)) {
      for (const port of this.store.entry(name)?.ports ?? []) {
        if (port.type !== "input") continue;
        const output = driverOf(view, name, port.name);
        if (to(output)) lines.push([name, `${output} → ${name}.${port.name}`]);
      }
    }
    const content = JSON.stringify(lines);
    if (this.connections.dataset.content === content) return;
    this.connections.dataset.content = content;
    this.connections.hidden = !lines.length;
    const items = lines.slice(0, LISTED).map(([name, line]) =>
      make("li", {}, make("button", { type: "button", class: "link", onclick: () => this.store.select([name]) }, line)));
    this.connections.replaceChildren(make("h3", {}, text("form.connected")), make("ul", {}, ...items));
  }
}

/* Row of the name of a part. */
class RenameRow extends InputRow {
  constructor(store, part) {
    super(store, { address: part, label: text("form.name") });
    this.part = part;
    this.key = "name";
    this.input.removeAttribute("name");
    this.element.classList.add("rename");
  }

  present() { return this.part; }

  /* Names that the server would refuse. */
  problem(typed) {
    const name = typed.trim();
    if (name !== this.part && name in this.store.state.view.parts) return text("form.name_taken", { name });
    if (RESERVED.has(name)) return text("form.name_reserved", { name });
    return NAME.test(name) ? "" : text("form.name_invalid");
  }

  operations(typed) {
    const name = typed.trim();
    return name === this.part ? [] : name ? [{ op: "rename", part: this.part, name }] : null;
  }

  options() { return { select: [this.input.value.trim()] }; }

  showErrors() {
    show(this.bad, this.refused);
    this.input.setAttribute("aria-invalid", this.refused ? "true" : "false");
  }
}

/* Return pairs of rank and field in the order of the form: those of the size, required and stated ones,
   the model and the inputs, others. */
function ranked(fields, stated, groups, inputs) {
  const sizes = new Set(groups.flatMap(group => group.shown(stated))), others = new Set(groups.flatMap(group => group.others(stated)));
  const ratios = new Set(groups.flatMap(group => group.names.map(name => name.replace(/[^.]+$/, "critical_ratio"))));
  const rank = field => {
    if (others.has(field.name)) return FURTHER;
    if (sizes.has(field.name)) return 0;
    if (ratios.has(field.name)) return 1;
    if (field.required || field.name in stated) return 2;
    return field.type === "model" || inputs.has(field.name) ? 3 : FURTHER;
  };
  return fields.map(field => [rank(field), field]).sort(([first], [second]) => first - second);
}

/* A field that is only the address of an output is a connection. */
function isLink(field, inputs) { return field.type === "reference" && inputs.has(field.name); }

function unknownField(name) {
  return { name, group: "", type: "reference", form: "", doc: text("form.unknown"), required: false, choices: [] };
}
