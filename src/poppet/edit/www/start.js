/* Start page: templates, files of the folder, and an empty circuit. */

import { openDialog } from "./dialogs.js";
import { request } from "./connection.js";
import { text } from "./strings.js";

/* Shown instead of the curves while the circuit is empty and has no file, and on demand. */
export class StartPage {
  constructor(element, store) {
    Object.assign(this, { element, store, isAsked: false, isLoaded: false });
    store.addEventListener("state", () => this.update());
    store.addEventListener("open", () => { this.isAsked = false; });
  }

  /* Show the start page above a circuit. */
  open() {
    this.isAsked = true;
    this.isLoaded = false;
    this.update();
    this.element.querySelector("button")?.focus();
  }

  update() {
    const { state } = this.store;
    const isEmpty = state && state.name === null && !Object.keys(state.view.parts).length && !state.error && !state.can_undo;
    const isShown = this.isAsked || Boolean(isEmpty);
    this.element.hidden = !isShown;
    document.body.classList.toggle("is-start", isShown);
    if (isShown && !this.isLoaded) this.load();
  }

  async load() {
    this.isLoaded = true;
    let content = { templates: [], files: [] };
    try {
      const reply = await request("/start");
      if (reply.status === 200) content = reply.body;
    } catch {
      this.isLoaded = false;
    }
    this.fill(content);
  }

  fill({ templates, files }) {
    const root = this.element;
    root.replaceChildren();
    const add = (tag, content, parent = root) => parent.appendChild(Object.assign(document.createElement(tag), { textContent: content }));
    add("h2", text("start.name"));
    add("p", text("start.lead"));
    const row = add("p", "");
    this.button(row, text("start.empty"), { empty: true });
    if (this.isAsked) {
      const back = add("button", text("start.back"), row);
      Object.assign(back, { type: "button", onclick: () => { this.isAsked = false; this.update(); } });
    }
    const columns = add("div", "");
    columns.className = "start-lists";
    const list = (title, items, none) => {
      const section = add("section", "", columns);
      add("h3", title, section);
      if (!items.length) add("p", none, section);
      const own = add("ul", "", section);
      for (const [label, detail, source] of items) {
        const item = add("li", "", own);
        this.button(item, label, source);
        if (detail) add("span", detail.replaceAll("`", ""), item);
      }
    };
    list(text("start.templates"), templates.map(({ name, title, summary }) => [title || name, summary, { template: name }]), "");
    list(text("start.files"), files.map(({ name, title, modified }) => [name, detailOf(title, modified), { file: name }]), text("start.no_files"));
  }

  button(parent, label, source) {
    const button = parent.appendChild(document.createElement("button"));
    Object.assign(button, { type: "button", textContent: label, onclick: () => this.choose(source) });
  }

  choose(source) {
    const open = options => {
      this.isAsked = false;
      this.store.open({ ...source, ...options });
    };
    if (this.store.state?.dirty) askToDiscard(() => open({ discard: true }));
    else open({});
  }
}

/* Time of a file in seconds or as text. */
function detailOf(title, modified) {
  const date = new Date(typeof modified === "number" ? 1000 * modified : modified);
  const shown = Number.isNaN(date.valueOf()) ? "" : date.toLocaleString(document.documentElement.lang, { dateStyle: "medium", timeStyle: "short" });
  return title && shown ? text("start.again", { title, date: shown }) : title || shown;
}

function askToDiscard(open) {
  const dialog = openDialog("start.name");
  dialog.appendChild(document.createElement("p")).textContent = text("start.discard");
  const row = dialog.appendChild(document.createElement("p"));
  const choices = [["start.discard_yes", open], ["save.cancel", () => {}]];
  for (const [key, action] of choices) {
    const button = row.appendChild(document.createElement("button"));
    Object.assign(button, { type: "button", textContent: text(key), onclick: () => { dialog.close(); action(); } });
  }
}
