/* Offers after a connection. They are below the drawing, where they cover no part, and wait for nobody. */

import { htmlElement } from "./symbols.js";
import { text } from "./strings.js";

export class Offers {
  constructor(drawing) {
    this.drawing = drawing;
    this.parent = drawing.svg.parentElement;
    drawing.store.addEventListener("state", () => this.#changed());
  }

  /* Show a sentence and actions: [[label, function]], or elements. */
  show(words, actions) {
    this.close();
    this.note = htmlElement("div", { className: "offer strip" }, this.parent);
    this.note.setAttribute("role", "group");
    this.note.setAttribute("aria-label", words);
    htmlElement("span", { textContent: words }, this.note);
    for (const action of actions) {
      if (action instanceof Element) this.note.append(action);
      else this.#button(...action);
    }
    this.#button("×", () => {}).setAttribute("aria-label", text("drawing.close"));
    this.revision = this.drawing.store.state?.revision;
  }

  #button(label, run) {
    const button = htmlElement("button", { type: "button", textContent: label }, this.note);
    button.addEventListener("click", () => { this.close(); run(); });
    return button;
  }

  close() {
    const { note } = this;
    if (!note) return false;
    if (note.contains(document.activeElement)) this.drawing.svg.focus({ preventScroll: true });
    note.remove();
    this.note = null;
    return true;
  }

  /* The next edit ends an offer. */
  #changed() {
    if (this.note && this.drawing.store.state.revision > this.revision) this.close();
  }
}
