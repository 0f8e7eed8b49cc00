/* Steps of a sequence as lines of text. */

import { InputRow } from "./field_row.js";
import { text } from "./strings.js";
import { isEqual, plainValue } from "./field_values.js";

/* Row of the steps; the text has one line per step, and indented lines for its content. */
export class StepsRow extends InputRow {
  constructor(store, { owner, field, read }) {
    super(store, { address: `${owner}.${field.name}`, label: text("form.steps"), help: text("form.steps_help"), isLong: true });
    Object.assign(this, { read, isTable: true });
    this.input.wrap = "off";
    this.element.classList.add("is-stated");
  }

  present() { return linesOf(this.read() ?? {}); }

  problem(typed) {
    const { line } = stepsOf(typed);
    return line ? text("form.steps_invalid", { line }) : "";
  }

  /* Only what differs is set, so that comments and the layout of the file stay; another order sets all steps. */
  operations(typed) {
    const { steps } = stepsOf(typed), present = this.read() ?? {};
    const kept = Object.keys(present).filter(name => name in steps), added = Object.keys(steps).filter(name => !(name in present));
    if (!kept.length || !isEqual(Object.keys(steps), [...kept, ...added])) return [{ op: "set", address: this.address, value: steps }];
    const removed = Object.keys(present).filter(name => !(name in steps));
    return [
      ...removed.map(name => ({ op: "set", address: `${this.address}.${name}`, value: null })),
      ...kept.flatMap(name => changes(`${this.address}.${name}`, present[name], steps[name])),
      ...added.map(name => ({ op: "set", address: `${this.address}.${name}`, value: steps[name] })),
    ];
  }

  update() {
    super.update();
    this.input.rows = Math.min(Math.max(this.input.value.split("\n").length + 1, 4), 24);
  }
}

/* Operations that change the keys of a step which differ. */
function changes(address, former, step) {
  const keys = [...new Set([...Object.keys(former), ...Object.keys(step)])];
  return keys.flatMap(key => {
    const isSame = linesOf({ step: pick(former, key) }) === linesOf({ step: pick(step, key) });
    return isSame ? [] : [{ op: "set", address: `${address}.${key}`, value: step[key] ?? null }];
  });
}

function pick(table, key) { return key in table ? { [key]: table[key] } : {}; }

/* Return steps as lines of text. */
export function linesOf(steps) {
  return Object.entries(steps).flatMap(([name, step]) => [
    `${name}:`,
    ...(step.on?.length ? [`  on: ${step.on.join(", ")}`] : []),
    ...(step.set ? [`  set: ${Object.entries(step.set).map(([output, value]) => `${output} = ${plainValue(value)}`).join(", ")}`] : []),
    ...Object.entries(step.next ?? {}).map(([next, condition]) => `  next ${next}: ${plainValue(condition)}`),
    ...(step.timeout ? [`  timeout ${plainValue(step.timeout.after)}: ${step.timeout.to}`] : []),
  ]).join("\n");
}

/* Return {steps} of lines of text, or {line}, the number of the first line that is not valid. */
export function stepsOf(lines) {
  const steps = {};
  let step = null;
  for (const [k, line] of lines.split("\n").entries()) {
    if (!line.trim()) continue;
    const name = /^(\S.*):\s*$/.exec(line)?.[1];
    if (name) {
      if (name in steps) return { line: k + 1 };
      step = steps[name] = {};
    } else if (!step || !/^\s/.test(line) || !addLine(step, line.trim())) {
      return { line: k + 1 };
    }
  }
  return { steps };
}

function addLine(step, line) {
  const [, on] = /^on:\s*(.+)$/.exec(line) ?? [];
  const [, set] = /^set:\s*(.+)$/.exec(line) ?? [];
  const [, next, condition] = /^next\s+(.+?):\s*(.+)$/.exec(line) ?? [];
  const [, after, to] = /^timeout\s+(.+?):\s*(.+)$/.exec(line) ?? [];
  if (on) step.on = on.split(",").map(output => output.trim()).filter(Boolean);
  else if (set) return addValues(step, set);
  else if (next) step.next = { ...step.next, [next]: condition };
  else if (after) step.timeout = { after, to };
  else return false;
  return true;
}

function addValues(step, set) {
  const pairs = set.split(",").map(item => /^\s*([^=]+?)\s*=\s*(\S+)\s*$/.exec(item)?.slice(1));
  if (pairs.some(pair => !pair)) return false;
  step.set = Object.fromEntries(pairs.map(([output, value]) => [output, Number.isNaN(Number(value)) ? value : Number(value)]));
  return true;
}
