/* Forms of the tasks, each in a dialog. */

import { errorsOf } from "./connection.js";
import { openDialog } from "./dialogs.js";
import { fillOptions, make, newId } from "./elements.js";
import { text } from "./strings.js";
import { identify } from "./task_recording.js";

const SPREAD = "10 %", RUNS = 200;
const LEVEL = "time_to";  // metric that needs a level

/* Form of a task in a dialog; `read` returns the options. The dialog closes when the task has started. */
export class TaskForm {
  constructor(tasks, name) {
    Object.assign(this, { tasks, name });
    this.dialog = openDialog(`tasks.${name}_title`);
    this.dialog.classList.add("task-form");
    this.dialog.dataset.form = name;
    this.form = this.dialog.appendChild(make("form", {}));
    this.fields = this.form.appendChild(make("div", { class: "task-fields" }));
    this.problem = this.form.appendChild(make("p", { class: "why", role: "alert" }));
  }

  /* Add the buttons, and start the task with the options that `read` returns; `task` is a name, or a function that returns it. */
  finish(task, read) {
    const start = make("button", { type: "submit", class: "is-main" }, text("tasks.start"));
    const cancel = make("button", { type: "button", onclick: () => this.dialog.close() }, text("tasks.close"));
    this.form.append(make("p", { class: "task-buttons" }, start, cancel));
    this.form.addEventListener("submit", async event => {
      event.preventDefault();
      this.problem.textContent = "";
      start.disabled = true;
      const id = await this.tasks.start(typeof task === "string" ? task : task(), read(), reply => this.refuse(reply));
      start.disabled = false;
      if (id) this.dialog.close();
    });
    this.fields.querySelector("input, select")?.focus();
  }

  refuse(reply) { this.problem.textContent = errorsOf(reply).map(({ message, hint }) => `${message} ${hint}`).join(" "); }

  note(key, places) { this.fields.append(make("p", { class: "task-note" }, text(key, places))); }

  /* Field with a label; the result is its input. */
  input(name, properties = {}, container = this.fields) {
    const field = make("input", { type: "text", name, autocomplete: "off", spellcheck: false, ...properties });
    container.append(make("label", {}, make("span", {}, text(`tasks.field_${name}`)), field));
    return field;
  }

  /* Field that offers addresses, of which the user can type a part. */
  address(name, addresses, value, container = this.fields) {
    const id = newId(), list = make("datalist", { id });
    fillOptions(list, addresses);
    const field = this.input(name, { list: id, value, required: true }, container);
    field.after(list);
    return field;
  }

  /* Choice; `choices` maps values to texts. */
  choice(name, choices, container = this.fields) {
    const field = make("select", { name }, ...Object.entries(choices).map(([value, words]) => make("option", { value }, words)));
    container.append(make("label", {}, make("span", {}, text(`tasks.field_${name}`)), field));
    return field;
  }

  /* Rows of an address with an optional second field; the result reads them as pairs. */
  rows(names, addresses, first, container = this.fields) {
    const group = container.appendChild(make("fieldset", { class: "task-rows" }, make("legend", {}, text(`tasks.rows_${names[0]}`))));
    const add = make("button", { type: "button", onclick: () => addRow("", first[1] ?? "").focus() }, text("tasks.row_more"));
    group.append(add);
    const addRow = (...values) => {
      const row = make("div", { class: "task-row" });
      add.before(row);
      const fields = names.map((name, k) => (k === 0 ? this.address(name, addresses, values[0], row) : this.input(name, { value: values[k], required: true }, row)));
      const away = make("button", { type: "button", "aria-label": text("tasks.row_away"), onclick: () => { if (group.querySelectorAll(".task-row").length > 1) row.remove(); } }, "×");
      row.append(away);
      return fields[0];
    };
    addRow(...first);
    return () => [...group.querySelectorAll(".task-row")].map(row => [...row.querySelectorAll("input")].map(field => field.value.trim()));
  }

  /* Number of a run: a metric of the file, or a new one; the result reads the options. */
  metric(facts, canBeOfFile) {
    const kinds = Object.fromEntries(Object.entries(facts.metric_kinds).map(([name, meaning]) => [name, `${name.replaceAll("_", " ")}: ${meaning}`]));
    const offered = canBeOfFile ? { "": text("tasks.metrics_of_file") } : {};
    const kind = this.choice("metric", { ...offered, ...kinds });
    const ofField = this.address("of", Object.keys(facts.outputs), proposedOutput(this.tasks.store, facts));
    const level = this.input("value", { placeholder: "5 bar" });
    const update = () => {
      ofField.closest("label").hidden = ofField.disabled = kind.value === "";
      level.closest("label").hidden = level.disabled = kind.value !== LEVEL;
      level.required = kind.value === LEVEL;
    };
    kind.addEventListener("change", update);
    update();
    return () => {
      if (kind.value === "") return {};
      return { metric: { metric: kind.value, of: ofField.value.trim(), ...(kind.value === LEVEL ? { value: level.value.trim() } : {}) } };
    };
  }
}

/* Forms by the name of the button. */
export const FORMS = {
  ensemble(tasks, facts) {
    const form = new TaskForm(tasks, "ensemble");
    const source = facts.has_ensemble ? form.choice("source", { file: text("tasks.source_file"), own: text("tasks.source_own") }) : null;
    const spreads = form.rows(["parameter", "spread"], Object.keys(facts.parameters), [proposedParameter(tasks, facts), SPREAD]);
    const metric = form.metric(facts, facts.metrics.length > 0);
    const runs = form.input("runs", { type: "number", min: 1, max: 1_000_000, step: 1, value: facts.has_ensemble ? "" : RUNS });
    const rows = form.fields.querySelector(".task-rows");
    const update = () => {
      const isOwn = source?.value !== "file";
      rows.hidden = rows.disabled = !isOwn;
    };
    source?.addEventListener("change", update);
    update();
    form.finish("ensemble", () => ({
      ...(source?.value === "file" ? {} : { spreads: Object.fromEntries(spreads()) }),
      ...metric(), ...(runs.value ? { runs: Number(runs.value) } : {}),
    }));
  },

  size(tasks, facts) {
    const form = new TaskForm(tasks, "size");
    const field = form.address("parameter", Object.keys(facts.parameters), proposedParameter(tasks, facts));
    const low = form.input("low"), high = form.input("high");
    const update = () => {
      const { value, range } = facts.parameters[field.value.trim()] ?? {};
      for (const [k, end] of [low, high].entries()) end.placeholder = value > 0 ? range[k] : "";
    };
    field.addEventListener("input", update);
    update();
    const hasRequirements = Object.keys(facts.requirements).length > 0;
    const metric = form.metric(facts, hasRequirements);
    const aim = form.choice("extreme", { "": text("tasks.extreme_none"), smallest: text("tasks.extreme_smallest"), largest: text("tasks.extreme_largest") });
    const requirement = form.input("requirement", { placeholder: "<= 0.5 s", pattern: "\\s*[<>]=?.+" });
    const kind = form.form.elements.metric;
    const show = () => {
      const isOfFile = kind.value === "";
      if (isOfFile && aim.value === "") aim.value = "smallest";
      aim.options[0].disabled = isOfFile;
      requirement.closest("label").hidden = requirement.disabled = isOfFile || aim.value === "";
      requirement.required = !requirement.disabled;
    };
    for (const choice of [kind, aim]) choice.addEventListener("change", show);
    show();
    form.finish("size", () => ({
      address: field.value.trim(), ...metric(),
      ...(low.value.trim() ? { low: low.value.trim() } : {}), ...(high.value.trim() ? { high: high.value.trim() } : {}),
      ...(aim.value ? { extreme: aim.value } : {}), ...(requirement.disabled ? {} : { requirement: requirement.value.trim() }),
    }));
  },

  tune(tasks, facts) {
    const form = new TaskForm(tasks, "tune");
    if (!facts.controllers.length) {
      form.note("tasks.no_controller");
      form.form.append(make("p", { class: "task-buttons" }, make("button", { type: "button", onclick: () => form.dialog.close() }, text("tasks.close"))));
      return;
    }
    const controller = form.choice("controller", Object.fromEntries(facts.controllers.map(name => [name, name])));
    const shape = form.choice("form", { pi: "PI", pid: "PID", p: "P" });
    const sensitivity = form.input("sensitivity", { type: "number", min: 1.1, max: 3, step: 0.05, value: 1.4, required: true });
    form.note("tasks.sensitivity_help");
    const schedule = form.input("schedule", { type: "checkbox" });
    form.finish("tune", () => ({
      controller: controller.value, form: shape.value, sensitivity: Number(sensitivity.value), schedule: schedule.checked,
    }));
  },

  identify,

  energy(tasks) {
    const form = new TaskForm(tasks, "energy");
    form.note("tasks.energy_help");
    const cycle = form.input("cycle", { placeholder: "0.5 s, 1.9 s" });
    form.finish("energy", () => (cycle.value.trim() ? { cycle: cycle.value.trim() } : {}));
  },

  safety(tasks, facts) {
    const form = new TaskForm(tasks, "safety");
    form.note("tasks.safety_help");
    const inputs = Object.keys(facts.inputs), supply = inputs.find(address => /suppl|source/.test(address) && address.endsWith(".pressure"));
    const event = form.rows(["input", "event"], inputs, [supply ?? inputs.find(address => address.endsWith(".pressure")) ?? "", "0 bar g"]);
    form.finish("safety", () => ({ event: Object.fromEntries(event().map(([address, value]) => [address, numberOr(value)])) }));
  },

  fmu(tasks, facts) {
    const form = new TaskForm(tasks, "fmu");
    const version = form.choice("fmi", { 2: "FMI 2.0", 3: "FMI 3.0" });
    const part = partChoice(form, facts, true);
    form.finish("export", () => ({ target: "fmu", fmi: version.value, ...part() }));
  },

  c(tasks, facts) {
    const form = new TaskForm(tasks, "c");
    form.note("tasks.c_help");
    const part = partChoice(form, facts, true);
    form.finish("export", () => ({ target: "c", ...part() }));
  },

  st(tasks, facts) {
    const form = new TaskForm(tasks, "st");
    form.note(facts.sampled.length ? "tasks.st_help" : "tasks.no_sampled");
    const part = partChoice(form, facts, false);
    form.finish("export", () => ({ target: "st", ...part() }));
  },
};

/* Choice of a sampled controller, or of the whole circuit. */
function partChoice(form, { sampled }, canBeWhole) {
  const whole = canBeWhole ? { "": text("tasks.whole") } : {};
  const field = form.choice("part", { ...whole, ...Object.fromEntries(sampled.map(name => [name, name])) });
  return () => (field.value ? { part: field.value } : {});
}

/* Field that was used last, a parameter that the table of the selected part states, otherwise the first of the circuit. */
function proposedParameter({ store, field: last }, { parameters }) {
  if (last in parameters && store.selection.has(last.split(".")[0])) return last;
  const names = Object.keys(parameters);
  const own = [...store.selection].flatMap(part => names.filter(address => address.startsWith(`${part}.`)));
  const isStated = address => {
    const [part, ...field] = address.split(".");
    return field.join(".") in (store.state.view.parts[part]?.fields ?? {});
  };
  return own.find(isStated) ?? own[0] ?? names.find(isStated) ?? names[0] ?? "";
}

/* Output that changes in the last run: of the selected part, otherwise a position or pressure of the circuit. */
function proposedOutput({ selection, run }, { outputs }) {
  const names = Object.keys(outputs);
  const changes = address => {
    const values = run?.series.get(address);
    return values?.some(value => value !== values[0]) ?? false;
  };
  const own = [...selection].flatMap(part => names.filter(address => address.startsWith(`${part}.`)));
  const usual = ["position", "pressure"].flatMap(word => names.filter(address => address.endsWith(`.${word}`)));
  return [...own, ...usual, ...names].find(changes) ?? own[0] ?? usual[0] ?? names[0] ?? "";
}

const numberOr = value => (value !== "" && Number.isFinite(Number(value)) ? Number(value) : value);
