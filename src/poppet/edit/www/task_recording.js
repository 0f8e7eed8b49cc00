/* Form of the identification: a recording, its columns, and the free parameters. */

import { errorsOf } from "./connection.js";
import { fillOptions, make, newId } from "./elements.js";
import { text } from "./strings.js";
import { TaskForm } from "./task_forms.js";
import { tankTest } from "./task_tank.js";

const TYPES = ".csv,.txt,.tsv,.dat,.asc,.lvm,.log,.tdms,.mf4,.mdf,.mat,.parquet";
const EXAMPLES = { Pa: "bar g", K: "degC", "kg/s": "g/s", m: "mm", "m/s": "m/s", N: "N", rad: "deg", s: "s", 1: "1" };

/* Ask for a recording, unless one was dropped; its columns follow when the server has read it. */
export function identify(tasks, facts, dropped) {
  const form = new TaskForm(tasks, "identify");
  form.note("tasks.identify_help");
  const field = form.input("recording", { type: "file", accept: TYPES, required: true });
  const area = form.fields.appendChild(make("div", { "aria-live": "polite" }));
  const state = {};
  const take = file => {
    field.required = false;
    return read(form, facts, file, area, state);
  };
  field.addEventListener("change", () => { if (field.files.length) take(field.files[0]); });
  form.dialog.addEventListener("dragover", event => event.preventDefault());
  form.dialog.addEventListener("drop", event => {
    event.preventDefault();
    const [file] = event.dataTransfer.files;
    if (file) take(file);
  });
  form.finish(() => state.task ?? "identify", () => state.options?.() ?? {});
  if (dropped) take(dropped);
}

/* Send a recording to the server, which lists its columns. */
async function read(form, facts, file, area, state) {
  form.problem.textContent = "";
  area.replaceChildren(make("p", { class: "task-note" }, text("tasks.reading", { file: file.name })));
  const reply = await fetch(`/upload?name=${encodeURIComponent(file.name)}`, {
    method: "POST", body: file, headers: { "Content-Type": "application/octet-stream" }, credentials: "same-origin",
  }).catch(() => null);
  const body = await reply?.json().catch(() => ({}));
  if (!reply?.ok) {
    area.replaceChildren();
    form.problem.textContent = !reply ? text("problems.lost") : reply.status === 413 ? text("tasks.too_large") : errorsOf({ status: reply.status, body })[0].message;
    return;
  }
  area.replaceChildren();
  const model = form.choice("model", { circuit: text("tasks.model_circuit"), tank: text("tasks.model_tank") }, area);
  const content = area.appendChild(make("div", {}));
  const update = async () => {
    // A form that arrives after another choice stays outside of the page.
    const place = make("div", { class: "task-fields" });
    content.replaceChildren(place);
    Object.assign(state, { task: model.value === "tank" ? "tank" : "identify", options: null });
    const show = model.value === "tank" ? tankTest : columnsForm;
    const options = await show(form, facts, body.name, place);
    if (options && place.isConnected) state.options = options;
  };
  model.addEventListener("change", update);
  await update();
}

/* Result of a task that reads the recording; the form shows its errors, and the result is then null. */
export async function answer(form, task, options) {
  form.problem.textContent = "";
  const id = await form.tasks.start(task, options, refusal => form.refuse(refusal));
  const result = id && await form.tasks.result(id);
  if (result?.state === "done") return result;
  form.problem.textContent = result?.errors.map(({ message, hint }) => `${message} ${hint}`).join(" ") ?? form.problem.textContent;
  return null;
}

/* Table of the columns, free parameters and start values; the result reads the options. */
async function columnsForm(form, facts, recording, area) {
  const result = await answer(form, "columns", { recording });
  if (!result) return null;
  const { data, notes } = result;
  const quantities = { ...facts.inputs, ...facts.outputs }, id = newId(), list = make("datalist", { id });
  fillOptions(list, Object.keys(quantities));
  const rows = data.columns.map(column => columnRow(column, quantities, id));
  const head = make("tr", {}, ...["column", "range", "quantity", "unit"].map(name => make("th", { scope: "col" }, text(`tasks.head_${name}`))));
  area.append(
    ...notes.map(note => make("p", { class: "task-note" }, note)), list,
    make("div", { class: "scroll" }, make("table", { class: "task-columns" }, make("thead", {}, head), make("tbody", {}, ...rows.map(({ row }) => row)))),
  );
  const free = form.rows(["free"], Object.keys(facts.parameters), [""], area);
  const start = form.choice("start_values", {
    first: text("tasks.start_first"), free: text("tasks.start_free"), circuit: text("tasks.start_circuit"),
  }, area);
  return () => {
    const used = rows.map(({ read: value }) => value()).filter(({ address }) => address);
    const time = used.find(({ address }) => address === "time");
    const columns = used.filter(({ address }) => address !== "time").map(({ address, ...column }) => [address, column]);
    return {
      recording, columns: Object.fromEntries(columns), free: free().map(([address]) => address), start: start.value,
      ...(time ? { time: { column: time.column, ...(time.unit ? { unit: time.unit } : {}) } } : {}),
    };
  };
}

/* Row of one column: its name, its range, the quantity that it contains, and the unit. */
function columnRow({ name, unit, address, is_time, low, high }, quantities, list) {
  const quantity = make("input", {
    type: "text", list: is_time ? null : list, value: is_time ? "time" : address, readOnly: is_time, autocomplete: "off", "data-column": name,
    "aria-label": text("tasks.quantity_of", { name }), placeholder: text("tasks.not_used"),
  });
  const unitField = make("input", {
    type: "text", value: unit, "aria-label": text("tasks.unit_of", { name }), size: 6, autocomplete: "off",
  });
  // A unit that the heading does not state is not guessed: gauge or absolute makes a difference of 1 bar.
  const update = () => {
    const si = is_time ? "s" : quantities[quantity.value.trim()];
    unitField.required = si !== undefined && si !== "1";
    unitField.placeholder = EXAMPLES[si] ?? "";
  };
  quantity.addEventListener("input", update);
  update();
  const range = low === null ? "" : `${digits(low)} ... ${digits(high)}`;
  const row = make("tr", {}, make("th", { scope: "row" }, name), make("td", {}, range), make("td", {}, quantity), make("td", {}, unitField));
  const value = () => ({ address: quantity.value.trim(), column: name, unit: unitField.value.trim() });
  return { row, read: value };
}

const digits = value => String(Number(value.toPrecision(4)));
