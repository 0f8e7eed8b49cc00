/* List of the errors of the circuit, and of its table `modbus`. */

import { text } from "./strings.js";

/* Each error has its address, line and hint; a click selects the part that causes it, or shows the line of the text. */
export class Problems {
  constructor(element, store, showLine) {
    Object.assign(this, { element, store, showLine });
    this.title = document.createElement("h2");
    this.list = document.createElement("ul");
    this.title.setAttribute("aria-live", "polite");
    element.append(this.title, this.list);
    store.addEventListener("state", () => this.show());
  }

  show() {
    const { errors, state } = this.store;
    // An empty circuit is incomplete, but that is no news.
    const isEmpty = state.error === null && !Object.keys(state.view.parts).length;
    this.element.hidden = !errors.length || isEmpty;
    const count = this.store.runErrors.length;
    const title = text(count === 1 ? "problems.title_one" : count ? "problems.title" : "problems.title_modbus", { count });
    if (this.title.textContent !== title) this.title.textContent = title;
    // A list that is not replaced keeps the focus.
    const key = JSON.stringify([errors, Object.keys(state.view.parts)]);
    if (key !== this.key) this.list.replaceChildren(...errors.map(error => this.item(error)));
    this.key = key;
  }

  /* Select a part, and focus the field or the port that causes an error. */
  showCause(part, address) {
    this.store.select([part]);
    const name = CSS.escape(address.replace(/^parts\./, ""));
    const places = [`#form [name="${name}"]`, `#drawing [data-port="${name}"]`, `#drawing [data-part="${CSS.escape(part)}"]`];
    // On a narrow page, the form is in another tab.
    places.map(place => document.querySelector(place)).find(element => element?.getClientRects().length)?.focus();
  }

  item(error) {
    const item = document.createElement("li");
    const part = partOf(error.address, this.store.state.view.parts);
    const action = part ? () => this.showCause(part, error.address) : error.line ? () => this.showLine(error.line) : null;
    const content = document.createElement(action ? "button" : "span");
    content.textContent = [error.message, error.hint].filter(Boolean).join(" ");
    if (error.address) content.dataset.address = error.address;
    if (action) Object.assign(content, { type: "button", onclick: action });
    item.append(content);
    return item;
  }
}

/* Return the part of an address such as `parts.bleed.to`, or null. */
export function partOf(address, parts) {
  const names = (address ?? "").split(".");
  return [names[1], names[0]].find(name => name && Object.hasOwn(parts, name)) ?? null;
}
