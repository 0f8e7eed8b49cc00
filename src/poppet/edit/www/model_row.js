/* Row of the field `model`: search by catalogue number, and the values that a component sets. */

import { make, show } from "./elements.js";
import { FieldRow } from "./field_row.js";
import { text } from "./strings.js";
import { inWords } from "./field_values.js";

const NOTE = "starting value of the editor";

export class ModelRow extends FieldRow {
  constructor(store, details) {
    super(store, details);
    this.part = details.part;
    this.sets = make("p", { class: "sets", hidden: true });
    this.value.after(this.sets);
  }

  placeholder() { return text(this.choices.length ? "form.model_search" : "form.model_none"); }

  /* Setting a model removes the starting values that it replaces. */
  operations(typed) {
    const operations = super.operations(typed);
    const component = this.component(typed.trim());
    if (!operations?.length || !component) return operations;
    const { fields } = this.store.state.view.parts[this.part];
    const { sizes } = this.store.palette.get(this.store.state.view.parts[this.part].kind);
    const isSized = sizes.some(name => name in component.sets);
    const replaced = Object.entries(fields).filter(([name, value]) =>
      value?.note === NOTE && (name in component.sets || (isSized && (sizes.includes(name) || name === "critical_ratio"))));
    const options = Object.entries(component.options).filter(([name, words]) => !words.includes(fields[name]));
    return [
      ...replaced.map(([name]) => ({ op: "set", address: `${this.part}.${name}`, value: null })),
      ...options.map(([name, words]) => ({ op: "set", address: `${this.part}.${name}`, value: words[0] })),
      ...operations,
    ];
  }

  /* Components of the library and of the circuit's own files. */
  get own() { return this.store.state.models?.[this.store.state.view.parts[this.part]?.kind] ?? {}; }

  get choices() { return [...this.field.choices, ...(this.own.choices ?? [])]; }

  component(name) {
    return [...this.field.components, ...(this.own.components ?? [])].find(({ names }) => names.includes(name));
  }

  update() {
    super.update();
    const component = this.component(this.present());
    const values = Object.entries(component?.sets ?? {}).map(([name, value]) => `${inWords(name)} ${value}`);
    show(this.sets, component ? text("form.model_sets", { values: values.join(", "), source: component.source }) : "");
  }
}
