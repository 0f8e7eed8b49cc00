/* Form of a tank test: the interpretation of a recording as a picture with its sources, and questions as fields. */

import { fillOptions, make, newId } from "./elements.js";
import { text } from "./strings.js";
import { answer } from "./task_recording.js";

const OPTIONAL = ["time", "pressure", "ambient_temperature", "wall_conductance", "window"];

/* Show the interpretation of the server, again after each answer; the result reads the options of the task. */
export async function tankTest(form, facts, recording, area) {
  const fields = new Map();
  const view = area.appendChild(make("div", { class: "tank-view", "aria-live": "polite" }));
  const questions = area.appendChild(make("div", { class: "tank-questions" }));
  const statements = () => Object.fromEntries([...fields].map(([key, field]) => [key, field.value.trim()]).filter(([, value]) => value));
  const state = { isRunning: false, isStale: false };
  // One interpretation at a time: the server limits the number of tasks. The last one has all answers.
  const update = async () => {
    state.isStale = true;
    if (state.isRunning) return;
    state.isRunning = true;
    while (state.isStale) {
      state.isStale = false;
      const result = await answer(form, "interpret", { recording, statements: statements() });
      if (result && !state.isStale) show(result);
    }
    state.isRunning = false;
  };
  const show = ({ data, notes }) => {
    view.replaceChildren(picture(data), itemTable(data.items), ...notes.map(note => make("p", { class: "task-note" }, note)), ...doubtFields(data.doubts));
    for (const question of data.questions) if (!fields.has(question.key)) fields.set(question.key, questionField(question, questions, update));
    for (const [key, field] of fields) {
      const isOpen = data.questions.some(question => question.key === key), folded = field.closest("details");
      field.closest("label").classList.toggle("is-open", isOpen);
      if (isOpen && folded) folded.open = true;
    }
  };
  await update();
  const further = area.appendChild(make("details", {}, make("summary", {}, text("tasks.tank_further"))));
  for (const key of OPTIONAL) {
    if (fields.has(key)) continue;
    fields.set(key, form.input(`tank_${key}`, { placeholder: text(`tasks.example_${key}`) }, further));
    fields.get(key).addEventListener("change", update);
  }
  const parts = Object.keys(facts.parameters).filter(address => address.endsWith(".sonic_conductance")).map(address => address.replace(/\.sonic_conductance$/, ""));
  const part = form.choice("tank_part", Object.fromEntries([["", text("tasks.tank_no_part")], ...parts.map(name => [name, name])]), area);
  return () => ({ recording, statements: statements(), ...(part.value ? { part: part.value } : {}) });
}

function picture({ picture: content }) {
  return make("img", { class: "tank-picture", src: `data:image/png;base64,${content}`, alt: text("tasks.tank_picture") });
}

/* Table of the items with their sources. */
function itemTable(items) {
  const head = make("tr", {}, ...["item", "value", "origin"].map(name => make("th", { scope: "col" }, text(`tasks.head_${name}`))));
  const rows = items.map(({ subject, value, origins }) => make("tr", {}, make("th", { scope: "row" }, subject), make("td", {}, value), make("td", { class: origins.includes("assumed") ? "is-assumed" : null }, origins.join(", "))));
  const table = make("table", { class: "tank-items" }, make("thead", {}, head), make("tbody", {}, ...rows));
  return make("div", { class: "scroll" }, table);
}

/* Contradictions between recording and answers; the fit starts only after a tick. */
function doubtFields(doubts) {
  if (!doubts.length) return [];
  const accept = make("input", { type: "checkbox", name: "tank_accept", required: true });
  return [...doubts.map(doubt => make("p", { class: "why" }, doubt)), make("label", {}, make("span", {}, text("tasks.tank_accept")), accept)];
}

/* Field of a question: a list for closed choices, otherwise a text with proposals; the result is the field. */
function questionField({ key, text: words, choices, default: preset, is_closed: isClosed }, container, update) {
  const label = container.appendChild(make("label", {}, make("span", {}, words)));
  let field;
  if (isClosed) {
    field = make("select", { name: `tank_${key}`, required: true }, ...["", ...choices].map(value => make("option", { value }, value)));
  } else {
    const list = choices.length ? newId() : null;
    field = make("input", { type: "text", name: `tank_${key}`, required: true, autocomplete: "off", spellcheck: false, placeholder: preset, list });
    if (list) {
      const options = make("datalist", { id: list });
      fillOptions(options, choices);
      label.append(options);
    }
  }
  label.append(field);
  field.addEventListener("change", update);
  return field;
}
