/* Palette of all kinds of parts: a click adds a part at the nearest free place, a drag at the place of the pointer. */

import { htmlElement, strokesOf, svgElement } from "./symbols.js";
import { text } from "./strings.js";

const SLACK = 6;  // pixels before a press becomes a drag

export class Palette {
  constructor(element, store, drawing) {
    Object.assign(this, { element, store, drawing, buttons: new Map() });
    element.classList.add("palette");
    this.#searchField();
    this.groups = htmlElement("div", { className: "groups" }, element);
    this.empty = htmlElement("p", { className: "empty", hidden: true, textContent: text("palette.nothing") }, element);
    store.addEventListener("state", () => this.#fill());
    this.#fill();
  }

  /* Move the focus to the search field. */
  search() {
    this.field.focus();
    this.field.select();
  }

  #searchField() {
    this.field = htmlElement("input", { type: "search", placeholder: text("palette.search"), autocomplete: "off" }, this.element);
    this.field.setAttribute("aria-label", text("palette.search"));
    this.field.addEventListener("input", () => this.#filter());
    this.field.addEventListener("keydown", event => {
      const first = this.#best();
      if (event.key === "Enter" && first) { event.preventDefault(); this.#add(first.dataset.kind); }
      if (event.key === "ArrowDown" && first) { event.preventDefault(); first.focus(); }
      if (event.key === "Escape" && this.field.value) { event.stopPropagation(); this.field.value = ""; this.#filter(); }
    });
  }

  /* One button per kind, once the palette is known. */
  #fill() {
    const { palette } = this.store;
    if (!palette?.size || palette === this.filled) return;
    this.filled = palette;
    this.groups.replaceChildren();
    this.buttons.clear();
    const lists = new Map();
    for (const entry of palette.values()) {
      if (!lists.has(entry.group)) lists.set(entry.group, this.#group(entry.group));
      this.buttons.set(entry.kind, this.#button(entry, lists.get(entry.group)));
    }
    this.#filter();
  }

  #group(name) {
    const group = htmlElement("section", { className: "group" }, this.groups);
    const heading = htmlElement("h2", { textContent: text(`palette.group_${name}`) }, group);
    group.setAttribute("aria-label", heading.textContent);
    return htmlElement("div", { className: "kinds" }, group);
  }

  #button(entry, list) {
    const button = htmlElement("button", { type: "button", title: entry.summary }, list);
    button.dataset.kind = entry.kind;
    button.tabIndex = -1;
    const [x, y, width, height] = entry.box;
    const symbol = svgElement("svg", { viewBox: `${x - 0.5} ${y - 0.5} ${width + 1} ${height + 1}`, "aria-hidden": true, class: "symbol" }, button);
    symbol.append(...strokesOf(entry.svg));
    const label = htmlElement("span", {}, button);
    for (const word of entry.kind.split(/(?<=_)/)) {
      label.append(word.replace("_", " "));
      if (word.endsWith("_")) htmlElement("wbr", {}, label);
    }
    button.setAttribute("aria-label", text("palette.add", { kind: entry.kind.replaceAll("_", " "), summary: entry.summary }));
    button.addEventListener("click", () => this.isDragged || this.#add(entry.kind));
    button.addEventListener("keydown", event => this.#key(event, button));
    button.addEventListener("pointerdown", event => this.#press(event, button, entry));
    return button;
  }

  #add(kind) {
    return this.drawing.add(kind);
  }

  /* Buttons that the search shows. */
  #shown() {
    return [...this.buttons.values()].filter(button => !button.hidden);
  }

  /* Button of the kind that the search means: the kind itself, or the first one whose name begins with it. */
  #best() {
    const shown = this.#shown(), name = this.field.value.trim().toLowerCase().replaceAll(" ", "_");
    const begins = shown.filter(button => button.dataset.kind.startsWith(name));
    return begins.find(button => button.dataset.kind === name) ?? begins[0] ?? shown[0];
  }

  /* Show the kinds whose name or summary contains all words of the search; those with the name first get the Tab stop. */
  #filter() {
    const words = this.field.value.toLowerCase().split(/[\s_]+/).filter(Boolean);
    for (const [kind, button] of this.buttons) {
      const content = `${kind.replaceAll("_", " ")} ${this.store.palette.get(kind).summary}`.toLowerCase();
      button.hidden = !words.every(word => content.includes(word));
    }
    for (const group of this.groups.children) group.hidden = !group.querySelector("button:not([hidden])");
    this.empty.hidden = this.#shown().length > 0 || !this.buttons.size;
    this.#stop(this.#best());
  }

  /* One button is a Tab stop; arrow keys go to the others. */
  #stop(button) {
    for (const other of this.buttons.values()) other.tabIndex = other === button ? 0 : -1;
  }

  #key(event, button) {
    const shown = this.#shown(), at = shown.indexOf(button);
    const next = {
      ArrowRight: () => shown[at + 1], ArrowLeft: () => shown[at - 1] ?? this.field, Home: () => shown[0], End: () => shown.at(-1),
      ArrowDown: () => below(shown, button, 1), ArrowUp: () => below(shown, button, -1) ?? this.field,
    }[event.key]?.();
    if (!next) return;
    event.preventDefault();
    event.stopPropagation();
    if (next !== this.field) this.#stop(next);
    next.focus();
  }

  /* A drag shows the symbol at the pointer, and adds the part where it ends. */
  #press(event, button, entry) {
    this.isDragged = false;
    if (event.button) return;
    const start = { x: event.clientX, y: event.clientY }, controller = new AbortController();
    let ghost = null;
    const on = (name, handler) => addEventListener(name, handler, { signal: controller.signal });
    const end = () => { ghost?.remove(); controller.abort(); };
    on("pointermove", now => {
      if (!ghost && Math.hypot(now.clientX - start.x, now.clientY - start.y) < SLACK) return;
      if (!ghost) { ghost = this.#ghost(entry); this.isDragged = true; }
      ghost.style.transform = `translate(${now.clientX}px, ${now.clientY}px) translate(-50%, -50%)`;
    });
    on("pointerup", now => {
      end();
      if (this.isDragged) this.#drop(entry.kind, now);
      setTimeout(() => { this.isDragged = false; });  // after the click
    });
    on("pointercancel", end);
    on("keydown", now => { if (now.key === "Escape") end(); });
  }

  #ghost(entry) {
    const [x, y, width, height] = entry.box, scale = 10 * this.drawing.viewport.zoom;
    const ghost = htmlElement("div", { className: "palette-ghost" }, document.body);
    const symbol = svgElement("svg", { viewBox: `${x} ${y} ${width} ${height}`, width: width * scale, height: height * scale, class: "symbol" }, ghost);
    symbol.append(...strokesOf(entry.svg));
    return ghost;
  }

  #drop(kind, event) {
    const { svg, viewport } = this.drawing, { left, top, right, bottom } = svg.getBoundingClientRect();
    const isInside = event.clientX >= left && event.clientX <= right && event.clientY >= top && event.clientY <= bottom;
    if (!isInside) return;
    const point = viewport.point(event), [x, y, width, height] = this.store.palette.get(kind).box;
    this.drawing.add(kind, { x: point.x - x - width / 2, y: point.y - y - height / 2 });
  }
}

/* Nearest button in the next row of the palette, or undefined. */
function below(shown, button, sign) {
  const from = button.getBoundingClientRect();
  const rows = shown.map(other => [other, other.getBoundingClientRect()]).filter(([, box]) => sign * (box.top - from.top) > 4);
  rows.sort((a, b) => sign * (a[1].top - b[1].top) || Math.abs(a[1].left - from.left) - Math.abs(b[1].left - from.left));
  return rows[0]?.[0];
}
