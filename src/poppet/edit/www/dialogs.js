/* Dialogs of the page: help, and the name of a file. */

import { text } from "./strings.js";

const KEYS = [
  ["Ctrl+S", "toolbar.save"], ["Ctrl+Z, Ctrl+Y", "help.undo"], ["Del", "toolbar.delete"], ["R", "toolbar.rotate"], ["M", "toolbar.mirror"],
  ["Ctrl+A, C, X, V", "help.select"], ["← ↑ → ↓, Shift", "help.move"], ["P, W", "help.ports"], ["C", "help.begin"], ["A", "help.vent"],
  ["+, -, 0", "help.zoom"], ["Space", "help.play"], ["/", "help.search"],
  ["Esc", "help.escape"],
];

/* Show the keys and hints. */
export function showHelp() {
  const dialog = openDialog("help.name");
  for (const key of ["help.connect", "help.numbers", "help.pan"]) add(dialog, "p", text(key));
  add(dialog, "h3", text("help.keys"));
  const list = add(dialog, "dl", "");
  for (const [keys, meaning] of KEYS) {
    add(list, "dt", keys);
    add(list, "dd", text(meaning));
  }
  const close = add(dialog, "button", text("help.close"));
  close.type = "button";
  close.onclick = () => dialog.close();
}

/* Ask for the name of the file and write it; the dialog stays open if the file cannot be written. */
export function askFileName(store) {
  const dialog = openDialog("save.name");
  const form = add(dialog, "form", "");
  const label = add(form, "label", text("save.file", { folder: store.state?.folder ?? "" }));
  const field = add(label, "input", "");
  Object.assign(field, { type: "text", name: "file", value: store.state?.name ?? "circuit.toml", required: true, autocomplete: "off" });
  const problem = add(form, "p", "");
  problem.className = "why";
  problem.setAttribute("role", "alert");
  const row = add(form, "p", "");
  const write = add(row, "button", text("save.write"));
  write.type = "submit";
  const cancel = add(row, "button", text("save.cancel"));
  cancel.type = "button";
  cancel.onclick = () => dialog.close();
  return new Promise(resolve => {
    dialog.addEventListener("close", () => resolve(null));
    form.onsubmit = async event => {
      event.preventDefault();
      const name = field.value.trim();
      const state = await store.save({ name: /\.toml$/i.test(name) ? name : `${name}.toml` });
      if (state) {
        resolve(state);
        dialog.close();
      } else {
        problem.textContent = store.message;
      }
    };
    field.select();
  });
}

/* Open an empty dialog with a heading; it is removed when it closes. */
export function openDialog(title) {
  const focus = document.activeElement;
  const dialog = add(document.body, "dialog", "");
  const heading = add(dialog, "h2", text(title));
  heading.id = "dialog-title";
  dialog.setAttribute("aria-labelledby", heading.id);
  dialog.addEventListener("close", () => {
    dialog.remove();
    focus?.focus?.();
  });
  dialog.showModal();
  return dialog;
}

function add(parent, tag, content) {
  return parent.appendChild(Object.assign(document.createElement(tag), { textContent: content }));
}
