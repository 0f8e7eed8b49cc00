/* Source of a value: where it comes from, its location and a note. */

import { make, newId } from "./elements.js";
import { text } from "./strings.js";
import { isEqual, isSourced, plainValue } from "./field_values.js";

const KINDS = ["given", "assumed", "measured", "fitted", "datasheet", "standard", "paper"];
const TEXTS = ["locator", "note"];

/* Button that shows the source, and the fields below it, which are built when they are needed. */
export class SourceEditor {
  constructor(label, write) {
    Object.assign(this, { label, write });
    this.element = make("div", { class: "origin", id: newId(), hidden: true });
    this.button = make("button", {
      type: "button", class: "source", "aria-expanded": "false", "aria-controls": this.element.id, onclick: () => this.#toggle(),
    });
  }

  update(stated) {
    this.stated = stated;
    const kind = isSourced(stated) ? stated.source ?? "given" : "given";
    this.button.hidden = stated === undefined || (typeof stated === "object" && !isSourced(stated));
    this.button.textContent = kind === "given" ? text("form.source") : text(`form.source_${kind}`);
    this.button.dataset.source = kind;
    this.button.setAttribute("aria-label", text("form.source_of", { name: this.label, source: text(`form.source_${kind}`) }));
    this.button.title = isSourced(stated) ? [stated.locator, stated.note].filter(Boolean).join("; ") : "";
    if (this.button.hidden) this.#open(false);
    if (this.kind) this.#fill();
  }

  #toggle() { this.#open(this.element.hidden); }

  #open(isOpen) {
    if (isOpen && !this.kind) this.#build();
    this.element.hidden = !isOpen;
    this.button.setAttribute("aria-expanded", String(isOpen));
  }

  #build() {
    const apply = () => this.#apply();
    const { label } = this;
    this.kind = make("select", { "aria-label": text("form.source_kind_of", { name: label }), onchange: apply }, ...KINDS.map(value => make("option", { value }, text(`form.source_${value}`))));
    this.texts = TEXTS.map(name => make("input", {
      type: "text", autocomplete: "off", "aria-label": text(`form.source_${name}_of`, { name: label }), onchange: apply,
    }));
    this.element.append(
      make("label", {}, make("span", {}, text("form.source")), this.kind),
      ...TEXTS.map((name, k) => make("label", {}, make("span", {}, text(`form.source_${name}`)), this.texts[k])),
    );
    this.#fill();
  }

  #fill() {
    const table = isSourced(this.stated) ? this.stated : {};
    this.kind.value = table.source ?? "given";
    TEXTS.forEach((name, k) => { if (document.activeElement !== this.texts[k]) this.texts[k].value = table[name] ?? ""; });
  }

  #apply() {
    const entries = TEXTS.map((name, k) => [name, this.texts[k].value.trim()]).filter(([, value]) => value);
    const value = plainValue(this.stated);
    const isPlain = this.kind.value === "given" && !entries.length;
    const next = isPlain ? value : { value, source: this.kind.value, ...Object.fromEntries(entries) };
    if (!isEqual(next, this.stated)) this.write(next);
  }
}
