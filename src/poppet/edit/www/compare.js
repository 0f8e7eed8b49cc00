/* Comparison of variants: the run that is kept as A, and the differences of the fields from it. */

import { text } from "./strings.js";

/* Buttons of the comparison; `kept` is null or {run, text, view}. */
export class Compare extends EventTarget {
  constructor(bar, parent, store) {
    super();
    Object.assign(this, { store, kept: null });
    this.keep = button(bar, "compare.keep", () => this.keepRun());
    this.back = button(bar, "compare.back", () => store.replaceText(this.kept.text));
    this.drop = button(bar, "compare.drop", () => this.set(null));
    this.details = parent.appendChild(document.createElement("details"));
    this.details.appendChild(document.createElement("summary")).textContent = text("compare.changes");
    this.list = this.details.appendChild(document.createElement("ul"));
    store.addEventListener("run", () => this.showButtons());
    store.addEventListener("state", () => this.show());
    store.addEventListener("open", () => this.set(null));
    this.show();
  }

  keepRun() {
    const { run, state } = this.store;
    this.set({ run, text: state.text, view: state.view });
    this.store.announce(text("compare.kept"));
  }

  set(kept) {
    this.kept = kept;
    this.show();
    this.dispatchEvent(new Event("change"));
  }

  showButtons() {
    const { run, isStale } = this.store;
    this.keep.disabled = !run || run.isShort || isStale;
  }

  show() {
    const { state } = this.store;
    this.showButtons();
    for (const element of [this.back, this.drop, this.details]) element.hidden = !this.kept;
    if (!this.kept || !state) return;
    this.back.disabled = state.text === this.kept.text;
    const rows = differences(this.kept.view, state.view).map(({ address, before, now }) => text("compare.row", {
      address, before: before ?? text("compare.absent"), now: now ?? text("compare.absent"),
    }));
    const items = (rows.length ? rows : [text("compare.no_changes")]).map(row => {
      const item = document.createElement("li");
      item.textContent = row;
      return item;
    });
    this.list.replaceChildren(...items);
  }
}

/* True if a run, which can be null, has a column with the same quantity. */
export function hasColumn(run, { name, unit }) {
  return Boolean(run?.columns.some(column => column.name === name && column.unit === unit));
}

/* Return the addresses whose values differ between two views, with both values as text, or undefined for an absent one. */
export function differences(before, now) {
  const [a, b] = [valuesOf(before), valuesOf(now)];
  return [...new Set([...a.keys(), ...b.keys()])].filter(key => a.get(key) !== b.get(key))
    .map(address => ({ address, before: a.get(address), now: b.get(address) }));
}

function valuesOf(view) {
  const values = new Map();
  for (const [name, { kind, fields, ports }] of Object.entries(view.parts)) {
    values.set(`${name}.kind`, kind);
    for (const [field, value] of Object.entries({ ...fields, ...ports })) values.set(`${name}.${field}`, shown(value));
  }
  for (const section of ["connections", "signals", "run", "ambient", "gas"]) {
    for (const [name, value] of Object.entries(view[section] ?? {})) values.set(section === "run" ? `run.${name}` : name, shown(value));
  }
  return values;
}

/* A number of the file can be a table of value and source. */
function shown(value) {
  const plain = value !== null && typeof value === "object" && "value" in value ? value.value : value;
  return typeof plain === "object" ? JSON.stringify(plain) : String(plain);
}

function button(parent, key, action) {
  const element = parent.appendChild(document.createElement("button"));
  return Object.assign(element, { type: "button", textContent: text(key), onclick: action });
}
