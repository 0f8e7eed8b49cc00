/* Banners about the file and the connection: changed on disk, no answer, session over. */

import { text } from "./strings.js";

/* Banners stay until their reason ends or the user decides. */
export class Banners {
  constructor(element, store, commands) {
    Object.assign(this, { element, store, commands, banners: new Map(), isKept: false });
    store.addEventListener("connection", () => this.showConnection());
    store.addEventListener("state", () => this.showDisk());
    store.addEventListener("conflict", ({ detail }) => this.showConflict(detail));
  }

  showConnection() {
    this.remove("connection");
    const { connection } = this.store;
    if (connection === "ok") return;
    const retry = connection === "lost" ? [["problems.retry", () => this.store.retry()]] : [];
    this.add("connection", text(`problems.${connection}`), [...retry, ["toolbar.copy_text", this.commands.copyText]]);
  }

  showDisk() {
    const { changed_on_disk: isChanged, name } = this.store.state;
    if (!isChanged) {
      this.isKept = false;
      this.remove("disk");
    } else if (!this.isKept && !this.banners.has("disk")) {
      this.add("disk", text("problems.disk", { name }), [
        ["problems.disk_keep", () => { this.isKept = true; this.remove("disk"); }],
        ["problems.disk_take", () => { this.remove("disk"); this.store.reload(); }],
      ]);
    }
  }

  /* The file was changed on disk after it was opened, and was to be written. */
  showConflict(change) {
    const { name } = this.store.state;
    this.remove("disk");
    this.add("disk", text("problems.overwrite", { name }), [
      ["problems.overwrite_yes", () => { this.remove("disk"); this.store.save({ name: change.body.name, overwrite: true }); }],
      ["problems.disk_take", () => { this.remove("disk"); this.store.reload(); }],
      ["toolbar.save_as", () => { this.remove("disk"); this.commands.saveAs(); }],
    ]);
  }

  add(key, message, actions) {
    this.remove(key);
    const banner = document.createElement("div");
    banner.className = "banner";
    banner.setAttribute("role", "alert");
    banner.append(Object.assign(document.createElement("p"), { textContent: message }));
    for (const [label, action] of actions) {
      const button = Object.assign(document.createElement("button"), { type: "button", textContent: text(label), onclick: action });
      banner.append(button);
    }
    this.element.append(banner);
    this.banners.set(key, banner);
  }

  remove(key) {
    this.banners.get(key)?.remove();
    this.banners.delete(key);
  }
}
