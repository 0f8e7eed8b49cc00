/* Text of the circuit file: it can be edited, and errors are displayed at their lines. */

import { make } from "./elements.js";
import { text } from "./strings.js";
import { merged } from "./text_merge.js";

const QUIET = 600;  // ms after the last key, then the text is applied

/* Panel with the text. A text that is being typed is never replaced; changes elsewhere are added to it. `applied` is the
   text of the circuit to which the typed text refers. */
export class TextPanel {
  constructor(element, store) {
    Object.assign(this, { element, store, applied: "", sent: 0 });
    this.gutter = make("pre", { class: "gutter", "aria-hidden": "true" });
    this.area = make("textarea", {
      class: "code", spellcheck: false, wrap: "off", autocomplete: "off", "aria-label": text("text.name"), "aria-describedby": "text-help",
      oninput: () => this.#onInput(), onchange: () => this.apply(), onkeydown: event => this.#onKey(event),
      onscroll: () => { this.gutter.scrollTop = this.area.scrollTop; },
    });
    this.errors = make("ul", { class: "errors", hidden: true });
    this.state = make("p", { class: "help", id: "text-help" }, text("text.help"));
    element.replaceChildren(make("div", { class: "editor" }, this.gutter, this.area), this.state, this.errors);
    store.addEventListener("state", () => this.update());
    store.addEventListener("selection", () => this.#showPart());
    store.addEventListener("flush", () => this.apply());
    this.update();
  }

  #timer = 0;

  /* Text of the circuit; a text area has no carriage returns. */
  get present() { return this.store.text().replace(/\r\n/g, "\n"); }

  get isDirty() { return this.area.value !== this.applied; }

  #onInput() {
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => this.apply(), QUIET);
    this.#showNumbers();
  }

  #onKey(event) {
    if (event.key !== "Enter" || !event.ctrlKey) return;
    event.preventDefault();
    this.apply();
  }

  /* Send the typed text. */
  async apply() {
    clearTimeout(this.#timer);
    if (!this.isDirty) return;
    const typed = this.area.value;
    const former = this.applied;
    this.applied = typed;
    this.sent++;
    const state = await this.store.replaceText(typed, former);
    this.sent--;
    // A text that was refused refers to the present circuit, so that it can be applied in its place.
    if (!state && this.applied === typed) this.applied = this.present;
    this.update();
    this.state.textContent = text(state ? "text.help" : "text.refused");
  }

  update() {
    const shown = merged(this.applied, this.area.value, this.present);
    // While a text is sent, the circuit does not contain it yet.
    if (!this.sent && shown !== null) {
      this.#show(shown);
      this.applied = this.present;
    }
    this.#showNumbers();
    this.#showErrors();
  }

  #show(shown) {
    const { area } = this;
    if (area.value === shown) return;
    const { selectionStart, selectionEnd, scrollTop } = area;
    area.value = shown;
    if (document.activeElement === area) area.setSelectionRange(selectionStart, selectionEnd);
    area.scrollTop = scrollTop;
  }

  #showNumbers() {
    const count = this.area.value.split("\n").length;
    const bad = new Set(this.store.errors.map(({ line }) => line).filter(Boolean));
    const key = `${count} ${[...bad]}`;
    if (this.gutter.dataset.key === key) return;
    this.gutter.dataset.key = key;
    const numbers = Array.from({ length: count }, (_, k) => k + 1);
    this.gutter.replaceChildren(...numbers.flatMap(line => [bad.has(line) ? make("b", { class: "mark" }, `${line}`) : `${line}`, "\n"]));
    this.gutter.scrollTop = this.area.scrollTop;
  }

  #showErrors() {
    const { errors } = this.store;
    this.errors.hidden = !errors.length;
    this.area.setAttribute("aria-invalid", errors.length ? "true" : "false");
    this.errors.replaceChildren(...errors.map(({ address, line, message, hint }) => {
      const content = [line ? text("text.line", { line }) : "", message, hint].filter(Boolean).join(" ");
      const properties = { type: "button", class: "link", onclick: () => this.goTo(line), disabled: !line };
      return make("li", { class: "bad", "data-address": address || null }, make("button", properties, content));
    }));
  }

  /* Put the cursor at a line. */
  goTo(line) {
    this.#scrollTo(line);
    const start = this.area.value.split("\n").slice(0, line - 1).join("\n").length + (line > 1 ? 1 : 0);
    this.area.focus({ preventScroll: true });
    const end = this.area.value.indexOf("\n", start);
    this.area.setSelectionRange(start, end < 0 ? this.area.value.length : end);
  }

  #scrollTo(line) {
    const height = this.area.scrollHeight / Math.max(this.area.value.split("\n").length, 1);
    this.area.scrollTop = Math.max(0, (line - 3) * height);
  }

  /* Show the table of the selected part. */
  #showPart() {
    const [part] = this.store.selection;
    const line = this.store.state?.view.parts[part]?.line;
    if (line && document.activeElement !== this.area) this.#scrollTo(line);
  }
}
