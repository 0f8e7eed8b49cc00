/* Tasks of the server: reports, studies, audits and exports, with their progress and results. */

import { attempt, concernsRun, errorsOf } from "./connection.js";
import { make, show } from "./elements.js";
import { download, pictureOf, pngOf } from "./picture.js";
import { FORMS } from "./task_forms.js";
import { TaskList } from "./task_list.js";
import { text } from "./strings.js";

const PERIOD = 300;  // ms between two questions for the progress
const GROUPS = {
  study: ["report", "size", "ensemble", "tune", "identify"],
  audit: ["energy", "safety", "faults"],
  export: ["live", "fmu", "c", "st", "ssp", "toml", "svg", "png"],
};

/* Panel of the tasks: buttons, and the list of results. */
export class Tasks {
  constructor(element, store) {
    Object.assign(this, { element, store, timer: null, field: "" });
    this.problem = make("p", { class: "why", role: "alert" });
    this.list = new TaskList(store, { cancel: id => this.#cancel(id) });
    const groups = Object.entries(GROUPS).map(([group, names]) => make("section", {},
      make("h2", {}, text(`tasks.group_${group}`)),
      make("div", { class: "task-buttons" }, ...names.map(name => this.#button(name))),
    ));
    element.classList.add("tasks");
    this.need = make("p", { class: "task-note", hidden: true });
    element.replaceChildren(this.need, ...groups, this.problem, this.list.element);
    store.addEventListener("state", () => this.#update());
    this.#listenToDrops();
    // The field that was used last is the parameter that a form proposes.
    document.getElementById("form").addEventListener("focusin", event => { if (event.target.name) this.field = event.target.name; });
    this.#update();
    this.refresh();
  }

  #button(name) {
    const button = make("button", { type: "button", "data-task": name, title: text(`tasks.${name}_hint`), onclick: () => this.open(name) });
    button.textContent = name in FORMS ? text("tasks.dots", { task: text(`tasks.${name}`) }) : text(`tasks.${name}`);
    return button;
  }

  /* Begin a task, or open its form; `file` is a recording that was dropped on the panel. */
  async open(name, file = null) {
    this.problem.textContent = "";
    if (name in PAGE_EXPORTS) {
      await PAGE_EXPORTS[name](this.store);
      return;
    }
    this.store.dispatchEvent(new CustomEvent("flush"));
    await this.store.ready;
    if (!(name in FORMS)) {
      await this.start(...DIRECT[name]);
      return;
    }
    const { status, body } = await attempt("/tasks/facts");
    if (status === 200) FORMS[name](this, body, file);
    else this.#refuse({ status, body });
  }

  /* Start a task; the result is its identifier, or null with the errors in `show`. */
  async start(task, options = {}, show = reply => this.#refuse(reply)) {
    this.list.begin();
    const reply = await attempt("/tasks", { task, options });
    if (reply.status !== 200) {
      show(reply);
      return null;
    }
    await this.refresh();
    return reply.body.id;
  }

  /* Wait for the end of a task, and return its state. */
  async result(id) {
    for (;;) {
      const { body } = await attempt(`/tasks/${id}`);
      if (body.state !== "running") return body;
      await new Promise(resolve => setTimeout(resolve, PERIOD));
    }
  }

  /* Ask for all tasks, and again while one of them runs. */
  async refresh() {
    clearTimeout(this.timer);
    const { status, body } = await attempt("/tasks");
    if (status !== 200) return;
    this.list.show(body.tasks.filter(({ task }) => !["columns", "interpret"].includes(task)));
    if (body.tasks.some(({ state }) => state === "running")) this.timer = setTimeout(() => this.refresh(), PERIOD);
  }

  async #cancel(id) {
    await attempt(`/tasks/${id}/cancel`, {});
    await this.refresh();
  }

  #refuse(reply) { this.problem.textContent = errorsOf(reply).map(({ message, hint }) => `${message} ${hint}`).join(" "); }

  /* A recording that is dropped on the panel begins an identification. */
  #listenToDrops() {
    this.element.addEventListener("dragover", event => { if (event.dataTransfer.types.includes("Files")) event.preventDefault(); });
    this.element.addEventListener("drop", event => {
      const [file] = event.dataTransfer.files;
      if (!file) return;
      event.preventDefault();
      if (!this.element.querySelector("[data-task=identify]").disabled) this.open("identify", file);
    });
  }

  /* A circuit with errors has no tasks, except the text and the picture of its drawing. */
  #update() {
    const { state } = this.store;
    const isEmpty = !Object.keys(state?.view.parts ?? {}).length, isWrong = state?.errors?.some(concernsRun) || Boolean(state?.error);
    show(this.need, isWrong || isEmpty ? text("tasks.need") : "");
    for (const button of this.element.querySelectorAll("[data-task]")) {
      const isOfPage = button.dataset.task in PAGE_EXPORTS;
      button.disabled = isEmpty || (!isOfPage && isWrong);
    }
  }
}

/* Task and options of the buttons without a form. */
const DIRECT = {
  report: ["report"],
  faults: ["faults"],
  live: ["export", { target: "live" }],
  ssp: ["export", { target: "ssp" }],
};

const nameOf = store => (store.state.name ?? "circuit.toml").replace(/\.toml$/i, "");

/* Exports that the page makes itself. */
const PAGE_EXPORTS = {
  toml: store => download(`${nameOf(store)}.toml`, new Blob([store.text()], { type: "application/toml" })),
  svg: store => download(`${nameOf(store)}.svg`, new Blob([pictureOf(store.state.view.title)], { type: "image/svg+xml" })),
  png: async store => download(`${nameOf(store)}.png`, await pngOf(pictureOf(store.state.view.title))),
};
