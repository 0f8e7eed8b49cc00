/* Choice of the curves: those of the selected parts and the usual ones, or those of a checklist. */

import { isStaircase, varies } from "./quantities.js";
import { text } from "./strings.js";

const LINES = 8;  // of a plot
const PLOTS = 4;
const CELL = /^(.+)\.(\d+)\.([^.]+)$/;  // an output of a cell of a tube
const USEFUL = 3;  // largest rank of the columns that a selected part shows by itself, if it has one

/* Rank of a column among the usual ones; columns of a low rank are shown first. */
function rankOf({ name, unit, cells }) {
  const first = cells?.[0].name ?? name, last = first.slice(first.lastIndexOf(".") + 1);
  if (unit === "Pa" && /pressure$/.test(last)) return 0;
  if ((unit === "m" || unit === "rad") && /position$|^angle$/.test(last) || /contraction$/.test(last)) return 1;
  if (unit === "kg/s") return 2;
  if (unit === "m/s" || unit === "rad/s") return 3;
  return 4;
}

/* Checklist of all columns, and the choice: null for the usual one, or a set of names. */
export class Choice extends EventTarget {
  constructor(element, store) {
    super();
    Object.assign(this, { store, names: null, columns: [], key: "" });
    this.details = element.appendChild(document.createElement("details"));
    this.details.className = "menu choice";
    const summary = this.details.appendChild(document.createElement("summary"));
    summary.textContent = text("curves.choice");
    this.list = this.details.appendChild(document.createElement("div"));
    this.details.addEventListener("toggle", () => {
      this.fill();
      this.place(summary);
    });
    store.addEventListener("open", () => { this.names = null; });
  }

  /* Place the list above its button, outside the panel of the curves, which would cut it off. */
  place(button) {
    const { right, top } = button.getBoundingClientRect();
    const style = { right: Math.max(4, innerWidth - right), bottom: innerHeight - top, maxHeight: top - 8 };
    for (const [name, size] of Object.entries(style)) this.list.style[name] = `${size}px`;
  }

  /* Columns of a model. */
  setColumns(columns) {
    const key = columns.map(({ name }) => name).join();
    if (key === this.key) return;
    this.key = key;
    this.columns = withBands(columns);
    this.members = new Set(this.columns.flatMap(({ cells }) => cells ?? []).map(({ name }) => name));
    this.fill();
  }

  /* Groups of columns to show: [unit, columns] per plot. */
  groups(run) {
    const { selection } = this.store;
    const isSelected = ({ name }) => selection.has(name.split(".")[0]);
    const columns = this.names ? this.columns.filter(({ name }) => this.names.has(name)) : this.usual(run, isSelected);
    const groups = new Map();
    for (const column of columns) {
      if (!groups.has(column.unit)) groups.set(column.unit, []);
      const group = groups.get(column.unit);
      if (this.names || group.length < LINES) {
        group.push({ ...column, isSelected: isSelected(column), isStep: !column.cells && isStaircase(run.series.get(column.name) ?? []) });
      }
    }
    return [...groups].slice(0, this.names ? undefined : PLOTS);
  }

  /* Columns that vary: those of the selected parts, then pressures and positions, or what there is. */
  usual(run, isSelected) {
    const isMoving = column => (column.cells ?? [column]).some(({ name, unit }) => varies(run.series.get(name) ?? [], unit));
    const columns = this.columns.filter(column => !this.members.has(column.name) && isMoving(column)).sort((a, b) => rankOf(a) - rankOf(b));
    const best = (list, rank) => {
      const useful = list.filter(column => rankOf(column) <= rank);
      return useful.length ? useful : list.filter(column => rankOf(column) === rankOf(list[0]));
    };
    const selected = best(columns.filter(isSelected), USEFUL);
    const others = best(columns.filter(column => !column.inner), 1);
    return withoutTwins([...selected, ...others.filter(column => !isSelected(column))], run);
  }

  fill() {
    if (!this.details.open) return;
    const auto = checkbox(text("curves.choice_auto"), this.names === null, isOn => this.choose(isOn ? null : this.shownNames()));
    const parts = new Map();
    for (const column of this.columns) {
      const part = column.name.split(".")[0];
      parts.set(part, [...parts.get(part) ?? [], column]);
    }
    const shown = this.shownNames();
    const sets = [...parts].map(([part, columns]) => {
      const set = document.createElement("fieldset");
      set.appendChild(document.createElement("legend")).textContent = part;
      for (const { name } of columns) {
        set.append(checkbox(name.slice(part.length + 1) || name, shown.has(name), isOn => {
          const names = new Set(this.shownNames());
          if (isOn) names.add(name);
          else names.delete(name);
          this.choose(names);
        }));
      }
      return set;
    });
    this.list.replaceChildren(auto, ...sets);
  }

  shownNames() {
    return this.names ?? new Set(this.groups(this.store.run).flatMap(([, columns]) => columns.map(({ name }) => name)));
  }

  choose(names) {
    this.names = names;
    const index = [...this.list.querySelectorAll("input")].indexOf(document.activeElement);
    this.fill();
    this.list.querySelectorAll("input")[index]?.focus();
    this.dispatchEvent(new Event("change"));
  }
}

/* Columns, with a band for each output of all cells of a tube. An output with the name of a band, such as the mass flow
   rate at the start of a tube, belongs to the band. */
function withBands(columns) {
  const groups = new Map(columns.map(column => [column.name, []]));
  for (const column of columns) {
    const [, tube, , output] = CELL.exec(column.name) ?? [], name = `${tube}.${output}`;
    if (output) groups.set(name, [...groups.get(name) ?? [], column]);
  }
  const bands = new Map();
  for (const [name, cells] of groups) {
    if (cells.length < 2) continue;
    const numbers = cells.map(cell => Number(CELL.exec(cell.name)[2]));
    const members = columns.filter(column => column.name === name || cells.includes(column));
    const label = text("curves.cells", { name, first: Math.min(...numbers), last: Math.max(...numbers) });
    bands.set(members[0], { ...members[0], name: label, cells: members });
  }
  return columns.flatMap(column => [...bands.has(column) ? [bands.get(column)] : [], column]);
}

/* Columns without those that equal a former one, such as the position of a mass on a piston rod. */
function withoutTwins(columns, run) {
  const isTwin = (a, b) => a.length === b.length && a.every((value, k) => Math.abs(value - b[k]) <= 1e-9 * Math.abs(value));
  return columns.filter((column, k) => {
    if (column.cells) return true;
    const values = run.series.get(column.name);
    return !columns.slice(0, k).some(({ name, unit, cells }) => !cells && unit === column.unit && isTwin(values, run.series.get(name)));
  });
}

function checkbox(label, isChecked, change) {
  const element = document.createElement("label");
  const box = element.appendChild(document.createElement("input"));
  Object.assign(box, { type: "checkbox", checked: isChecked, onchange: () => change(box.checked) });
  element.append(label);
  return element;
}
