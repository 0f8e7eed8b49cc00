/* Results of tasks: progress, tables, files, and the changes of the circuit that a result offers. */

import { attempt, errorsOf } from "./connection.js";
import { make, show } from "./elements.js";
import { text } from "./strings.js";
import { sizedCurve } from "./task_curve.js";

/* List of tasks, the latest first; an entry is drawn anew only if its task has changed. */
export class TaskList {
  constructor(store, { cancel }) {
    Object.assign(this, { store, cancel, entries: new Map(), applied: new Set(), contents: new Map() });
    this.element = make("section", { hidden: true }, make("h2", {}, text("tasks.results")));
    this.items = this.element.appendChild(make("ul", { class: "task-list" }));
    store.addEventListener("state", () => { for (const { element, task } of this.entries.values()) this.#mark(element, task); });
  }

  /* Remember the present content of the circuit, for which a task begins. */
  begin() { this.contents.set(this.store.state.revision, contentOf(this.store.state)); }

  show(tasks) {
    this.element.hidden = !tasks.length;
    for (const task of tasks) {
      const former = this.entries.get(task.id);
      if (former?.state === "running" && task.state !== "running") {
        this.store.announce(text(`tasks.ended_${task.state}`, { task: nameOf(task), message: task.message }));
      }
      const content = JSON.stringify(task);
      if (former?.content === content) continue;
      const element = former?.element ?? make("li", { "data-result": task.task, "data-id": task.id });
      element.dataset.state = task.state;
      if (former?.state === "running" && task.state === "running") this.#advance(element, task);
      else element.replaceChildren(...this.#content(task));
      this.#mark(element, task);
      this.entries.set(task.id, { element, task, content, state: task.state });
    }
    const present = new Set(tasks.map(({ id }) => id));
    for (const id of this.entries.keys()) if (!present.has(id)) this.entries.delete(id);
    const elements = tasks.map(({ id }) => this.entries.get(id).element);
    if (elements.some((element, k) => this.items.children[k] !== element) || elements.length !== this.items.children.length) {
      this.items.replaceChildren(...elements);
    }
  }

  /* Say whether a task has computed another circuit or an earlier text; another circuit does not get its changes. */
  #mark(element, { id, revision }) {
    const { state } = this.store;
    if (!state) return;  // the circuit of the page is still being loaded
    const isOther = revision < state.opened;
    // Without the content of its text, for example after a reload of the page, any other revision is an earlier text.
    const isEarlier = revision !== state.revision && this.contents.get(revision) !== contentOf(state);
    show(element.querySelector(".task-mark"), isOther ? text("tasks.of_other") : isEarlier && !this.applied.has(id) ? text("tasks.of_earlier") : "");
    const changes = element.querySelector(".task-changes");
    if (changes) changes.hidden = isOther;
  }

  #content(task) {
    const head = make("div", {}, make("h3", {}, nameOf(task)), make("p", { class: "task-note task-mark", hidden: true }));
    if (task.state === "running") {
      const progress = make("progress", { max: 1, "aria-label": text("tasks.progress", { task: nameOf(task) }) });
      const row = make("p", { class: "task-progress" }, progress, make("span", {}),
        make("button", { type: "button", "aria-label": text("tasks.cancel_task", { task: nameOf(task) }), onclick: () => this.cancel(task.id) },
          text("tasks.cancel")));
      this.#advance(row, task);
      return [head, row];
    }
    if (task.state === "cancelled") return [head, make("p", { class: "task-note" }, text("tasks.cancelled"))];
    if (task.state === "failed") {
      return [head, make("ul", { class: "why" }, ...task.errors.map(({ message, hint }) => make("li", {}, `${message} ${hint}`)))];
    }
    return [head, ...this.#result(task)];
  }

  #advance(element, { progress, step, done, total }) {
    const bar = element.querySelector("progress");
    if (progress === null) bar.removeAttribute("value");
    else bar.value = progress;
    const count = total === null ? (done ? String(Math.round(done)) : "") : text("tasks.of", { done: round(done), total: round(total) });
    element.querySelector("span").textContent = text(`tasks.step_${step}`, { count }).trim();
  }

  #result(task) {
    const parts = [];
    if (task.data.curve) parts.push(sizedCurve(task.data.curve));
    if (task.operations.length) parts.push(this.#changes(task));
    if (task.text && !task.text.includes("\n")) parts.push(make("p", {}, task.text));
    else if (task.text) parts.push(make("pre", { tabIndex: 0, role: "region", "aria-label": text("tasks.table", { task: nameOf(task) }) }, task.text));
    if (task.notes.length) {
      parts.push(make("details", {}, make("summary", {}, text("tasks.notes", { count: task.notes.length })),
        make("ul", {}, ...task.notes.map(note => make("li", {}, note)))));
    }
    if (task.files.length) parts.push(make("ul", { class: "task-files" }, ...task.files.map(file => this.#file(file))));
    return parts;
  }

  /* Changes of the circuit, and the button that makes them in one step. */
  #changes(task) {
    const button = make("button", { type: "button", class: "is-main", onclick: () => this.#apply(task, button) },
      text(task.task === "size" ? "tasks.apply_value" : "tasks.apply"));
    const rows = task.operations.map(({ address, value }) => make("li", {}, make("code", {}, address), ` = ${shown(value)}`));
    return make("div", { class: "task-changes" }, make("p", {}, text("tasks.changes")), make("ul", {}, ...rows), button);
  }

  async #apply(task, button) {
    this.applied.add(task.id);
    if (!await this.store.apply(task.operations)) {
      this.applied.delete(task.id);
    } else {
      button.textContent = text("tasks.applied");
      this.store.announce(text("tasks.applied_message", { task: nameOf(task) }));
    }
  }

  #file(file) {
    const name = file.replace(/^\d+-/, ""), path = `/files/${encodeURIComponent(file)}`;
    const note = make("span", { class: "task-note", role: "status" });
    const links = [];
    if (name.endsWith(".html")) {
      links.push(make("a", { href: `${path}?view=1`, target: "_blank", rel: "noopener", "aria-label": text("tasks.open_file", { name }) }, text("tasks.open")));
    }
    links.push(make("a", { href: path, download: name, "aria-label": text("tasks.download_file", { name }) }, text("tasks.download")));
    links.push(make("button", {
      type: "button", class: "link", "aria-label": text("tasks.keep_file", { name }),
      onclick: () => this.#keep(file, note),
    }, text("tasks.keep")));
    return make("li", {}, make("span", {}, name), make("span", { class: "task-links" }, ...links), note);
  }

  /* Copy a result into the folder of the circuit, which never replaces a file: a number is added to the name. */
  async #keep(file, note) {
    const name = file.replace(/^\d+-/, ""), dot = name.lastIndexOf(".");
    for (let number = 1; number < 100; number += 1) {
      const wanted = number === 1 ? name : `${name.slice(0, dot)}-${number}${name.slice(dot)}`;
      const reply = await attempt("/tasks/keep", { file, name: wanted });
      if (reply.status === 200) {
        note.textContent = text("tasks.kept", { name: reply.body.name });
        return;
      }
      if (errorsOf(reply)[0].code !== "edit.file_exists") {
        note.textContent = errorsOf(reply).map(({ message }) => message).join(" ");
        return;
      }
    }
  }
}

/* Name of a task for the user. */
function nameOf({ task, options }) {
  return task === "export" ? text("tasks.export_of", { target: text(`tasks.${options.target}`) }) : text(`tasks.${task}`);
}

/* Content of a circuit without the places of its parts, as a text. */
function contentOf({ view, text: whole }) { return view.error ? whole : JSON.stringify({ ...view, drawing: null }); }

/* Value of an operation for the user. */
function shown(value) {
  if (value === null) return text("tasks.no_value");
  if (typeof value !== "object") return String(value);
  if ("value" in value) return String(value.value);
  return Object.entries(value).map(([key, list]) => `${key}: ${[].concat(list).join(", ")}`).join("; ");
}

const round = value => String(Number(value.toPrecision(4)));
