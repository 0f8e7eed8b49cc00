/* Table of typed values, one row per point of a curve. */

import { make } from "./elements.js";
import { text } from "./strings.js";

/* Columns are {key, label}; `changed(rows)` is called with all typed texts after a change. */
export class PointTable {
  constructor({ columns, changed, added, least = 1 }) {
    Object.assign(this, { columns, changed, least, rows: [] });
    this.body = make("tbody");
    const heads = columns.map(({ label }) => make("th", { scope: "col" }, label));
    this.add = make("button", { type: "button", class: "small", onclick: added }, text("signals.add_row"));
    this.element = make("div", { class: "points" },
      make("table", {}, make("thead", {}, make("tr", {}, ...heads, make("td"))), this.body), this.add);
  }

  /* Show rows of texts; a cell that is being edited keeps its text. */
  show(rows) {
    while (this.body.rows.length > rows.length) this.body.deleteRow(-1);
    while (this.body.rows.length < rows.length) this.body.append(this.#row(this.body.rows.length));
    rows.forEach((row, k) => {
      row.forEach((value, column) => {
        const input = this.body.rows[k].cells[column].firstChild;
        if (document.activeElement !== input || input.value === this.rows[k]?.[column]) input.value = value;
      });
      this.body.rows[k].querySelector("button").disabled = rows.length <= this.least;
    });
    this.rows = rows;
  }

  #row(index) {
    const cells = this.columns.map(({ label }, column) => make("td", {}, make("input", {
      type: "text", autocomplete: "off", spellcheck: false, "aria-label": text("signals.cell", { column: label, row: index + 1 }),
      onchange: () => this.#commit(), onkeydown: event => this.#onKey(event, index, column),
    })));
    const remove = make("button", {
      type: "button", class: "small", "aria-label": text("signals.remove_row", { row: index + 1 }), onclick: () => this.#remove(index),
    }, "×");
    return make("tr", {}, ...cells, make("td", {}, remove));
  }

  #onKey(event, index, column) {
    if (event.key === "Enter") {
      event.preventDefault();
      this.#commit();
    } else if (event.key === "Escape") {
      event.target.value = this.rows[index]?.[column] ?? "";
    } else if (["ArrowUp", "ArrowDown"].includes(event.key)) {
      const other = this.body.rows[index + (event.key === "ArrowUp" ? -1 : 1)];
      other?.cells[column].firstChild.focus();
    }
  }

  get typed() { return [...this.body.rows].map(row => this.columns.map((_, column) => row.cells[column].firstChild.value.trim())); }

  #commit() {
    const { typed } = this;
    if (JSON.stringify(typed) !== JSON.stringify(this.rows)) this.changed(typed);
  }

  #remove(index) { this.changed(this.typed.filter((_, k) => k !== index)); }
}
