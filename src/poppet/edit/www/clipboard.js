/* Copy, cut and paste of parts through the clipboard of the system, also between windows. */

import { split } from "./connections.js";
import { boxOf, overlaps } from "./geometry.js";
import { text } from "./strings.js";

const KIND = "poppet parts";

export class Clipboard {
  constructor(drawing) {
    this.drawing = drawing;
    for (const name of ["copy", "cut", "paste"]) document.addEventListener(name, event => this.#used(name, event));
  }

  /* Events of the document, which need no permission; fields keep their own. */
  #used(name, event) {
    const element = document.activeElement;
    if (element?.closest("input, textarea, select, aside, dialog, [contenteditable]")) return;
    if (name === "paste") {
      if (this.#paste(event.clipboardData.getData("text/plain"))) event.preventDefault();
      return;
    }
    const words = this.text();
    if (!words || !getSelection().isCollapsed) return;
    event.preventDefault();
    event.clipboardData.setData("text/plain", words);
    this.#said(words);
    if (name === "cut") this.drawing.remove();
  }

  /* Copy by a button of the page. */
  async copyButton() {
    const words = this.text();
    if (!words) return;
    this.#said(words);
    await navigator.clipboard?.writeText(words).catch(() => {});
  }

  /* Paste by a button of the page; without a permission, what this page has copied. */
  async pasteButton() {
    const words = await navigator.clipboard?.readText().catch(() => "");
    if (!this.#paste(words || this.last)) this.drawing.store.announce(text("drawing.nothing_to_paste"));
  }

  #said(words) {
    this.last = words;
    this.drawing.store.announce(text("drawing.copied", { names: this.drawing.selected.join(", ") }));
  }

  /* The selected parts as JSON, with their places, signals, and the connections among them. */
  text() {
    const { drawing } = this, { view, selected } = drawing;
    if (!selected.length) return "";
    const own = new Set(selected), isOwn = address => own.has(split(address)[0]);
    const entries = (table, isKept) => Object.fromEntries(Object.entries(table).filter(isKept));
    return JSON.stringify({
      kind: KIND,
      parts: Object.fromEntries(selected.map(name => [name, tableOf(view.parts[name])])),
      drawing: {
        ...entries(view.drawing, ([key]) => key.includes(".") && isOwn(key)),
        ...Object.fromEntries(selected.map(name => [name, placeOf(drawing.place(name))])),
      },
      connections: entries(view.connections, ([input, output]) => isOwn(input) && isOwn(output)),
      signals: entries(view.signals, ([input]) => isOwn(input)),
    }, null, 1);
  }

  /* Add the parts of a text; false if it contains none. */
  #paste(words) {
    const copy = parsed(words);
    if (!copy) return false;
    this.#add(copy);
    return true;
  }

  async #add({ parts, drawing: places = {}, connections = {}, signals = {} }) {
    const { drawing } = this, { store } = drawing, names = this.#names(Object.keys(parts));
    const moved = this.#moved(parts, places);
    const own = address => { const [part, local] = split(address); return `${names.get(part)}.${local}`; };
    const isIn = address => names.has(split(address)[0]);
    const operations = [
      ...drawing.pins(), { op: "paste", parts, drawing: moved },
      ...Object.entries(connections).filter(pair => pair.every(isIn)).map(([input, output]) => ({ op: "link", input: own(input), output: own(output) })),
      ...Object.entries(signals).filter(([input]) => isIn(input)).map(([input, table]) => ({ op: "signal", address: own(input), table })),
    ];
    const state = await store.apply(operations);
    if (!state) return;
    store.select(state.created);
    drawing.reveal(state.created);
    store.announce(text("drawing.pasted", { names: state.created.join(", ") }));
  }

  /* Names of the copies: those that the operation `paste` chooses. */
  #names(wanted) {
    const { drawing } = this, names = new Map();
    for (const name of wanted) {
      const others = new Set([...wanted, ...names.values()]);
      const isTaken = name in drawing.view.parts;
      names.set(name, isTaken ? drawing.freeName(name.replace(/_\d+$/, "") || name, others) : name);
    }
    return names;
  }

  /* Places of the copies: moved together until they cover nothing. */
  #moved(parts, places) {
    const { drawing } = this, { store } = drawing, taken = drawing.taken();
    const boxes = Object.keys(parts).filter(name => places[name] && store.palette.has(parts[name].kind))
      .map(name => boxOf(store.palette.get(parts[name].kind), places[name]));
    let shift = 0;
    const isFree = () => boxes.every(box => !taken.some(other => overlaps({ ...box, x: box.x + shift, y: box.y + shift }, other, 1)));
    while (!isFree() && shift < 1000) shift += 2;
    const moved = place => (place.points ? { points: place.points.map(([x, y]) => [x + shift, y + shift]) } : { ...place, x: place.x + shift, y: place.y + shift });
    return Object.fromEntries(Object.entries(places).map(([name, place]) => [name, moved(place)]));
  }
}

/* Content of a text that was copied here or in another window, otherwise null. */
function parsed(words) {
  try {
    const copy = JSON.parse(words);
    return copy?.kind === KIND && copy.parts && typeof copy.parts === "object" ? copy : null;
  } catch {
    return null;
  }
}

/* Table of a part as in the file, from the fields with dotted addresses of the view. */
function tableOf({ kind, fields, ports }) {
  const table = { kind };
  for (const [address, value] of Object.entries({ ...fields, ...ports })) {
    const names = address.split("."), last = names.pop();
    let inner = table;
    for (const name of names) inner = inner[name] ??= {};
    inner[last] = value;
  }
  return table;
}

/* Entry of a part in the table `drawing`. */
function placeOf({ x, y, rotation = 0, mirror = false }) {
  return { x, y, ...rotation && { rotation }, ...mirror && { mirror } };
}
