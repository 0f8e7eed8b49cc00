/* Content of the form without one selected part: first steps, parts of the circuit, several parts, or a wire. */

import { make } from "./elements.js";
import { FieldRow } from "./field_row.js";
import { text } from "./strings.js";
import { isEqual } from "./field_values.js";

/* Return {outline, build}: a text that changes when the content must be built again, and a function that returns the
   elements and the rows of the content. */
export function overviewOf(store) {
  const { selection, wire, state } = store;
  const parts = Object.entries(state?.view.parts ?? {});
  if (selection.size > 1) return severalParts(store, [...selection]);
  if (wire) return wireContent(store, wire);
  if (!parts.length) return { outline: "steps", build: () => ({ elements: firstSteps(), rows: [] }) };
  const outline = JSON.stringify(["parts", state.view.title, parts.map(([name, { kind }]) => [name, kind])]);
  return { outline, build: () => ({ elements: partList(store, parts), rows: [] }) };
}

function firstSteps() {
  const steps = ["form.step_parts", "form.step_wires", "form.step_numbers"].map(key => make("li", {}, text(key)));
  return [make("h2", {}, text("form.steps_title")), make("ol", { class: "first-steps" }, ...steps)];
}

function partList(store, parts) {
  const items = parts.map(([name, { kind }]) => make("li", {},
    make("button", { type: "button", class: "link", onclick: () => store.select([name]) }, name), make("span", { class: "soft" }, ` ${kind}`)));
  const { title } = store.state.view;
  return [
    title ? make("h2", {}, title) : null, make("p", { class: "hint" }, text("form.none")), make("ul", { class: "part-list" }, ...items),
  ].filter(Boolean);
}

/* --- Several parts --- */

function severalParts(store, names) {
  const { parts } = store.state.view;
  const kinds = new Set(names.map(name => parts[name].kind));
  const fields = kinds.size === 1 ? commonFields(store, names) : [];
  const build = () => {
    const rows = fields.map(field => new SharedRow(store, names, field));
    const title = text("form.several", { count: names.length, names: names.join(", ") });
    const hint = make("p", { class: "help" }, text(fields.length ? "form.several_help" : "form.several_kinds"));
    return { elements: [make("p", { class: "hint" }, title), hint, ...rows.map(row => row.element)], rows };
  };
  return { outline: JSON.stringify(["several", names, fields.map(({ name }) => name)]), build };
}

/* Fields that one of the parts states, and required ones; only numbers, options and switches. */
function commonFields(store, names) {
  const { parts } = store.state.view;
  const entry = store.entry(names[0]);
  const isStated = field => names.some(name => field.name in parts[name].fields);
  return (entry?.fields ?? []).filter(field => ["number", "option", "switch"].includes(field.type) && ((field.required && !field.group) || isStated(field)));
}

/* Row of a field of several parts, which get the same value. */
class SharedRow extends FieldRow {
  constructor(store, names, field) {
    const valueOf = name => store.state.view.parts[name]?.fields[field.name];
    const isSame = () => names.every(name => isEqual(valueOf(name), valueOf(names[0])));
    super(store, { owner: names[0], field, read: () => (isSame() ? valueOf(names[0]) : undefined) });
    Object.assign(this, { names, isSame, key: `shared ${field.name}` });
    this.name.textContent = this.fullName;
    this.input.removeAttribute("name");
    this.slider?.removeAttribute("data-slider");
  }

  get addresses() { return this.names.map(name => `${name}.${this.field.name}`); }

  placeholder() { return !this.isSame || this.isSame() ? super.placeholder() : text("form.various"); }

  concerns() { return false; }
}

/* --- Wire --- */

function wireContent(store, { port, input }) {
  const { view } = store.state;
  const address = port ?? input;
  const [part, ...local] = address.split(".");
  const target = port ? view.parts[part]?.ports[local.join(".")] : view.connections[input];
  const build = () => {
    const operation = port ? { op: "disconnect", port } : { op: "unlink", input };
    const names = [part, String(target ?? "").split(".")[0]].filter(name => name in view.parts);
    const buttons = [
      make("button", { type: "button", onclick: () => store.apply([operation]) }, text("form.disconnect")),
      ...names.map(name => make("button", { type: "button", onclick: () => store.select([name]) }, text("form.show_part", { name }))),
    ];
    const title = make("p", {}, make("b", {}, input ? `${target} → ${address}` : `${address} — ${target ?? ""}`));
    return { elements: [title, make("div", { class: "buttons" }, ...buttons)], rows: [] };
  };
  return { outline: JSON.stringify(["wire", address, target]), build };
}
