/* Nodes of one part in the drawing: symbol, name, ports and marks of errors. */

import { split, targetOf } from "./connections.js";
import { boxOf, endsOf, labelOf } from "./geometry.js";
import { setTitle, strokesOf, svgElement } from "./symbols.js";
import { text } from "./strings.js";

const REACH = 1.2;  // radius of the area of a port, in grid units
const DOT = 0.34;
const OPEN = new Set(["fields.missing_port", "wiring.alone", "wiring.drives_nothing"]);  // errors of drawings in progress

export class PartNode {
  /* The group of the part is appended to `parent`. */
  constructor(name, parent) {
    this.name = name;
    this.item = svgElement("g", { class: "item" }, parent);
    this.node = svgElement("g", { "data-part": name, role: "button", tabindex: 0, class: "part" }, this.item);
    this.area = svgElement("rect", { class: "area" }, this.node);
    this.symbol = svgElement("g", { class: "symbol" }, this.node);
    this.label = svgElement("text", { class: "name" }, this.item);
    this.value = svgElement("text", { class: "value" }, this.item);
    this.marks = svgElement("g", { class: "marks" }, this.item);
    this.ports = new Map();
    this.svg = "";
  }

  /* Show the part at a place. Returns true if its ends have moved. */
  draw(entry, place, svg) {
    const key = JSON.stringify([entry.box, entry.ports, place]);
    if (svg !== this.svg) {
      this.svg = svg;
      this.reset();
    }
    if (key === this.key) return false;
    [this.key, this.entry, this.place] = [key, entry, place];
    this.box = boxOf(entry, place);
    this.ends = endsOf(this.name, entry, place);
    const { x, y, rotation = 0, mirror = false } = place;
    this.node.setAttribute("transform", `translate(${x} ${y})`);
    this.symbol.setAttribute("transform", `rotate(${rotation})${mirror ? " scale(-1 1)" : ""}`);
    setBox(this.area, { ...this.box, x: this.box.x - x, y: this.box.y - y });
    this.#drawLabel();
    this.#drawPorts();
    return true;
  }

  /* The symbol has moved along its horizontal axis: lengthen the lines from ports at its ends. */
  shiftLeads(distance) {
    for (const { lead, end } of this.ports.values()) {
      const sign = { left: 1, right: -1 }[end.symbolSide] ?? 0;
      if (sign) drawLead(lead, { side: end.side, lead: end.lead + sign * distance });
    }
  }

  /* Draw the symbol as in the palette. */
  reset() {
    this.strokes = strokesOf(this.svg);
    this.symbol.replaceChildren(...this.strokes);
    this.shiftLeads(0);
  }

  #drawLabel() {
    const place = labelOf(this.name, this.box, this.ends);
    this.label.textContent = this.name;
    for (const [line, y] of [[this.label, place.y], [this.value, place.valueY]]) {
      line.setAttribute("x", place.x);
      line.setAttribute("y", y);
      line.setAttribute("text-anchor", place.anchor);
    }
    this.labelBox = place.box;
  }

  #drawPorts() {
    const kept = new Set();
    this.ends.forEach((end, k) => {
      const key = `${end.address} ${this.ends.slice(0, k).filter(other => other.address === end.address).length}`;
      kept.add(key);
      if (!this.ports.has(key)) this.ports.set(key, portNode(end, this.item));
      const port = this.ports.get(key);
      port.end = end;
      for (const group of [port.node, port.beside]) group.setAttribute("transform", `translate(${end.x} ${end.y})`);
      port.reach.setAttribute("r", reachOf(end, this.ends));
      drawLead(port.lead, end);
      drawName(port.name, end);
      port.vent.setAttribute("transform", `rotate(${{ bottom: 0, left: 90, top: 180, right: 270 }[end.side]})`);
    });
    for (const [key, port] of this.ports) {
      if (!kept.has(key)) { port.node.remove(); port.beside.remove(); this.ports.delete(key); }
    }
  }

  /* Node of a port by its address. */
  port(address) {
    return [...this.ports.values()].find(port => port.end.address === address);
  }

  /* Show the selection and what the ports are connected to. */
  mark({ isSelected, kind, view, errors }) {
    this.node.setAttribute("aria-pressed", isSelected);
    this.item.classList.toggle("is-selected", isSelected);
    const own = errors.filter(error => error.owner === this.name);
    const atPort = new Map(own.filter(error => this.port(error.port)).map(error => [error.port, error]));
    this.#marks(own.filter(error => !atPort.has(error.port)));
    const words = own.map(error => error.words).join(" ");
    this.node.setAttribute("aria-label", text(words ? "drawing.part_error" : "drawing.part", { name: this.name, kind, errors: words }));
    for (const port of this.ports.values()) markPort(port, view, atPort.get(port.end.address), isSelected);
  }

  /* One mark per error of the part, at the upper right corner of its box. */
  #marks(errors) {
    while (this.marks.childElementCount > errors.length) this.marks.lastElementChild.remove();
    errors.forEach((error, k) => {
      let mark = this.marks.children[k];
      if (!mark) {
        mark = svgElement("g", { class: "mark", role: "img" }, this.marks);
        svgElement("circle", { r: 0.8 }, mark);
        svgElement("path", { d: "M0 -0.45V0.1M0 0.38V0.42" }, mark);
      }
      mark.setAttribute("transform", `translate(${this.box.x + this.box.width - 1.9 * k} ${this.box.y})`);
      mark.setAttribute("data-address", error.address);
      mark.setAttribute("aria-label", error.words);
      setTitle(mark, error.words);
    });
  }

  remove() {
    this.item.remove();
  }
}

function portNode(end, parent) {
  // The centre of a port is that of its area, which the line to the symbol and the vent are no part of.
  const beside = svgElement("g", { class: "beside" }, parent), node = svgElement("g", { class: `end ${end.type}` }, parent);
  if (end.port) {
    for (const [name, value] of [["data-port", end.address], ["role", "button"], ["tabindex", -1]]) node.setAttribute(name, value);
  } else {
    node.setAttribute("data-node", end.address);
  }
  const reach = svgElement("circle", { class: "reach" }, node);
  const lead = svgElement("path", { class: "lead" }, beside);
  const vent = svgElement("path", { class: "vent", d: "M0 0V1.2M-0.8 1.2H0.8L0 2.4Z" }, beside);
  const name = svgElement("text", { class: "port-name" }, beside);
  const isSignal = end.type === "input" || end.type === "output";
  if (isSignal) svgElement("path", { class: "dot", d: `M0 -${DOT * 1.3}L${DOT * 1.3} 0L0 ${DOT * 1.3}L-${DOT * 1.3} 0Z` }, node);
  else if (end.type === "body") svgElement("rect", { class: "dot", x: -DOT, y: -DOT, width: 2 * DOT, height: 2 * DOT }, node);
  else svgElement("circle", { class: "dot", r: DOT }, node);
  return { node, beside, reach, lead, vent, name, end };
}

/* Areas of the ports of a part do not overlap. */
function reachOf(end, ends) {
  const distances = ends.filter(other => other !== end).map(other => Math.hypot(other.x - end.x, other.y - end.y));
  return Math.max(0.45, Math.min(REACH, ...distances.map(distance => distance / 2)));
}

/* Line from the border of the box to the symbol. */
function drawLead(path, { side, lead }) {
  const [dx, dy] = { left: [1, 0], right: [-1, 0], top: [0, 1], bottom: [0, -1] }[side];
  path.setAttribute("d", lead ? `M0 0L${dx * lead} ${dy * lead}` : "");
}

/* Name of a port along its wire, outside the box. */
function drawName(label, { port, side }) {
  const angle = { left: 0, right: 0, top: -90, bottom: -90 }[side], isAhead = side === "right" || side === "top";
  label.textContent = port && port.replaceAll("_", " ");
  label.setAttribute("text-anchor", isAhead ? "start" : "end");
  label.setAttribute("x", isAhead ? 0.8 : -0.8);
  label.setAttribute("y", -0.2);
  label.setAttribute("transform", `rotate(${angle})`);
}

function markPort({ node, beside, end }, view, error, isSelected) {
  const target = targetOf(view, end) ?? (end.address in view.signals ? "~" : drivenBy(view, end));
  const isJoined = target !== undefined, isVented = target === "ambient";
  node.classList.toggle("is-joined", isJoined && !isVented);
  for (const group of [node, beside]) group.classList.toggle("is-vented", isVented);
  node.classList.toggle("is-required", end.required && !isJoined);
  node.classList.toggle("is-wrong", error !== undefined && !OPEN.has(error.code));
  if (error) node.setAttribute("data-address", error.address);
  else node.removeAttribute("data-address");
  if (!end.port) { setTitle(node, text("drawing.node_title", { name: end.part })); return; }
  const joined = !isJoined ? text(end.required ? "drawing.open_required" : "drawing.open")
    : target === "~" ? text("drawing.driven") : text("drawing.joined", { target: isVented ? text("drawing.ambient") : target });
  const words = text("drawing.port", { port: end.address, type: text(`drawing.type_${end.type}`), joined });
  const label = error ? `${words} ${error.words}` : words;
  if (node.getAttribute("aria-label") !== label) node.setAttribute("aria-label", label);
  node.setAttribute("tabindex", isSelected ? 0 : -1);
  setTitle(node, error ? `${end.address}: ${error.words}` : `${words}\n${end.doc}`);
}

/* Inputs that an output drives, as a text; "output" stands for any output of a controller. */
function drivenBy(view, { type, address, part, port }) {
  if (type !== "output") return undefined;
  const isOwn = source => source === address || (port === "output" && split(source)[0] === part);
  return Object.entries(view.connections).filter(([, source]) => isOwn(source)).map(([input]) => input).join(", ") || undefined;
}

function setBox(rect, { x, y, width, height }) {
  for (const [name, value] of [["x", x], ["y", y], ["width", width], ["height", height]]) rect.setAttribute(name, value);
}
