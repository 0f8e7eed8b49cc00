/* Wires of the drawing: four kinds of connections, junctions, selection, and segments that can be dragged.

   A wire is the way from a port or input to what it is connected to, or to another wire of the same net. Its nodes stay
   while the wire exists, so that the focus does. */

import { arrowOf, isVerticalAt, movedSegment, nearestSegment, netOf, sceneOf, wiresOf } from "./nets.js";
import { route } from "./router.js";
import { setTitle, svgElement } from "./symbols.js";
import { text } from "./strings.js";

const REST = 300;  // ms without a change before all wires are routed anew
const JUNCTION = 0.42;
const STEPS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

export class Wires {
  /* Wires are drawn in `group`. `pins` returns the operations that write the places of parts without one. */
  constructor(group, store, pins = () => []) {
    Object.assign(this, { group, store, pins, wires: new Map(), nodes: new Map(), drafts: new Map(), former: null, timer: null });
    this.segment = null;  // selected segment: {x, y, isVertical} of its middle
    store.addEventListener("selection", () => this.#mark());
    group.addEventListener("keydown", event => this.#key(event));
    group.addEventListener("pointermove", event => this.#hover(event));
    group.addEventListener("click", event => this.#clicked(event));
    // The drawing captures the pointer, so that its events have another target.
    group.ownerSVGElement.addEventListener("dblclick", ({ clientX, clientY }) => {
      this.#reset(document.elementFromPoint(clientX, clientY)?.closest("[data-wire]")?.dataset.wire);
    });
  }

  /* Show the wires between ends: `ends` maps addresses to ends, `labels` are boxes of texts. With `moved`, a set of
     parts, a drag is in progress, and other wires stay as they are; otherwise all are routed anew after a pause. */
  update({ ends, boxes, labels, moved = null }) {
    this.input = { ends, boxes, labels };
    const { view } = this.store.state ?? {};
    const wires = view?.parts ? wiresOf(view, ends, boxes) : [];
    for (const wire of wires) this.#place(wire, moved);
    const before = this.wires;
    this.wires = new Map(wires.map(wire => [wire.key, wire]));
    const scene = sceneOf(view ?? { parts: {} }, ends, wires, boxes, labels);
    const words = JSON.stringify(scene), isSame = words === this.words;
    const isOther = ![...before.keys()].some(key => this.wires.has(key));
    [this.scene, this.words] = [scene, words];
    clearTimeout(this.timer);
    if (isSame) this.#draw();
    else this.#route(isOther ? null : this.former);
    if (!moved && !this.isDragging) this.#later();
  }

  /* After a pause, route all wires, whatever the drawing was before: the result then depends on the circuit alone. */
  #later() {
    if (this.isRough) this.timer = setTimeout(() => this.#route(null), REST);
  }

  #route(former) {
    this.former = route(this.scene, former);
    this.isRough = former !== null;
    this.#draw();
  }

  /* Points of a wire during a drag; if both ends have moved together, the points move with them. */
  #place(wire, moved) {
    const { key, end, root: [root] } = wire, old = this.wires.get(key);
    if (this.drafts.has(key)) { wire.points = this.drafts.get(key); return; }
    const same = old?.rest && wire.points.join() === old.rest.points.join();
    wire.rest = moved && same ? old.rest : { points: wire.points, x: end.x, y: end.y, rootX: root.x, rootY: root.y };
    const [dx, dy] = [end.x - wire.rest.x, end.y - wire.rest.y];
    if (dx !== root.x - wire.rest.rootX || dy !== root.y - wire.rest.rootY) return;
    if (dx || dy) wire.points = wire.points.map(([x, y]) => [x + dx, y + dy]);
  }

  /* Operations that store the points of wires that have moved together with both ends. */
  moved() {
    const wires = [...this.wires.values()].filter(({ rest, points }) => rest && points.join() !== rest.points.join());
    return wires.map(({ key, points }) => ({ op: "route", port: key, points }));
  }

  /* --- Drawing --- */

  #draw() {
    const counts = new Map();
    for (const wire of this.wires.values()) {
      const id = netOf(wire), k = counts.get(id) ?? 0, { paths, junctions, straight } = this.former.wires.get(id);
      counts.set(id, k + 1);
      Object.assign(wire, { path: paths[k], isStraight: straight.includes(k), junctions: k + 1 < paths.length ? [] : junctions });
    }
    for (const [key, node] of this.nodes) {
      if (!this.wires.has(key)) this.#remove(key, node);
    }
    for (const wire of this.wires.values()) this.#drawWire(this.nodes.get(wire.key) ?? this.#node(wire.key), wire);
    this.#mark();
    this.onRouted?.();
  }

  #node(key) {
    const item = svgElement("g", { "data-wire": key, role: "button", tabindex: -1 }, this.group);
    const [hit, line, inside, segment] = ["hit", "line", "inside", "segment"].map(name => svgElement("path", { class: name }, item));
    const node = { item, hit, line, inside, segment, dots: [] };
    this.nodes.set(key, node);
    return node;
  }

  #remove(key, { item }) {
    if (item.contains(document.activeElement)) {
      const port = [...this.group.ownerSVGElement.querySelectorAll("[data-port]")].find(one => one.dataset.port === key);
      (port ?? this.group.ownerSVGElement).focus({ preventScroll: true });
    }
    item.remove();
    this.nodes.delete(key);
  }

  #drawWire(node, wire) {
    const { key, kind, target, path, isStraight, junctions } = wire, tap = this.#rootOf(wire)?.isTap && path[path.length - 1];
    const shape = `M${path.map(point => point.join(" ")).join("L")}`;
    if (shape !== node.shape) {
      for (const name of ["hit", "line", "inside"]) node[name].setAttribute("d", shape);
      node.shape = shape;
    }
    const looks = `wire ${kind}${isStraight ? " is-straight" : ""}`;
    if (looks !== node.looks) {
      for (const name of ["pipe", "tube", "body", "signal", "is-straight"]) node.item.classList.remove(name);
      node.item.classList.add(...looks.split(" "));
      node.looks = looks;
    }
    const label = text(isStraight ? "wires.straight" : `wires.${kind}`, { port: key, target });
    if (label !== node.label) {
      node.item.setAttribute("aria-label", label);
      setTitle(node.item, label);
      node.label = label;
    }
    const dots = tap ? [...junctions, tap] : junctions;
    while (node.dots.length > dots.length) node.dots.pop().remove();
    while (node.dots.length < dots.length) node.dots.push(svgElement("circle", { class: "junction", r: JUNCTION }, node.item));
    dots.forEach(([x, y], k) => {
      node.dots[k].setAttribute("cx", x);
      node.dots[k].setAttribute("cy", y);
    });
  }

  /* Show the selection. Wires of selected parts can be reached with the Tab key. */
  #mark() {
    const { wire: chosen, selection } = this.store, selected = chosen?.port ?? chosen?.input;
    if (selected !== this.selected) [this.selected, this.segment] = [selected, null];
    for (const [key, { item, segment }] of this.nodes) {
      const wire = this.wires.get(key), isSelected = key === selected;
      const parts = [wire?.end.part, wire?.root[0].part];
      item.classList.toggle("is-selected", isSelected);
      item.setAttribute("aria-pressed", isSelected);
      item.setAttribute("tabindex", isSelected || parts.some(part => selection.has(part)) ? 0 : -1);
      const k = isSelected && !wire.isStraight ? this.#chosen(wire) : -1;
      segment.setAttribute("d", k < 0 ? "" : `M${wire.path[k].join(" ")}L${wire.path[k + 1].join(" ")}`);
    }
  }

  /* Index of the selected segment of a wire: the one that was selected, or the middle one. */
  #chosen({ path }) {
    if (!this.segment) return Math.floor((path.length - 2) / 2);
    return nearestSegment(path, [this.segment.x, this.segment.y], this.segment.isVertical);
  }

  #choose(path, k) {
    const [[x1, y1], [x2, y2]] = [path[k], path[k + 1]];
    this.segment = { x: (x1 + x2) / 2, y: (y1 + y2) / 2, isVertical: isVerticalAt(path, k) };
  }

  /* Node of a wire, or undefined. */
  node(key) {
    return this.nodes.get(key)?.item;
  }

  /* Anchor of a flow arrow on a wire: place, direction toward its end in degrees, and length of the segment; or null. */
  arrow(key) {
    const wire = this.wires.get(key);
    return wire?.path && !wire.isStraight ? arrowOf(wire.path) : null;
  }

  /* --- Selection and movement --- */

  select(key) {
    const wire = this.wires.get(key);
    if (wire) this.store.selectWire(wire.kind === "signal" ? { input: key } : { port: key });
  }

  /* Remove the connection of a wire. */
  async disconnect(key) {
    const operation = this.wires.get(key)?.kind === "signal" ? { op: "unlink", input: key } : { op: "disconnect", port: key };
    if (await this.store.apply([operation])) this.store.announce(text("wires.disconnected", { port: key }));
  }

  /* Gesture of a pointer that is pressed on a wire: a click selects it, a drag moves the segment. */
  gesture(key, start, toPoint) {
    const wire = this.wires.get(key), { path, points, isStraight } = wire, k = nearestSegment(path, [start.x, start.y]);
    const axis = isVerticalAt(path, k) ? "x" : "y", from = path[k][axis === "x" ? 0 : 1];
    const isChoice = this.selected === key;
    const choose = () => {
      if (!isChoice) this.select(key);
      this.#choose(path, k);
      this.#mark();
      this.node(key)?.focus({ preventScroll: true });
    };
    let coordinate = from;
    return {
      click: choose,
      move: event => {
        const next = Math.round(from + toPoint(event)[axis] - start[axis]);
        if (next === coordinate || isStraight) return;
        if (coordinate === from) choose();
        coordinate = next;
        this.#draft(wire, movedSegment(path, points, k, coordinate, Boolean(this.#rootOf(wire))), coordinate);
      },
      end: () => this.#drop(wire),
      cancel: () => this.#cancel(wire),
    };
  }

  /* End of the target at which a wire ends, or undefined if it ends at another wire. */
  #rootOf({ path, root }) {
    const [x, y] = path[path.length - 1];
    return root.find(end => end.x === x && end.y === y);
  }

  /* Show a wire with other points. */
  #draft({ key }, points, coordinate) {
    this.isDragging = true;
    this.drafts.set(key, points);
    this.segment[this.segment.isVertical ? "x" : "y"] = coordinate;
    this.update({ ...this.input, moved: new Set() });
  }

  #cancel({ key }) {
    this.isDragging = false;
    if (this.drafts.delete(key)) this.update({ ...this.input, moved: new Set() });
  }

  async #drop(wire, options = {}) {
    const points = this.drafts.get(wire.key);
    this.isDragging = false;
    if (!points) return;
    await this.store.apply([...this.pins(), { op: "route", port: wire.key, points }], options);
    if (this.drafts.get(wire.key) === points) this.#cancel(wire);
    this.#later();
  }

  /* Let the router choose the way of a wire again. */
  #reset(key) {
    if (!this.wires.get(key)?.points.length) return;
    this.store.apply([{ op: "route", port: key, points: null }]);
    this.store.announce(text("wires.reset", { port: key }));
  }

  /* The pointer shows in which direction a segment can be moved. */
  #hover(event) {
    const item = event.target.closest("[data-wire]"), wire = this.wires.get(item?.dataset.wire);
    if (!wire?.path) return;
    const { a, d, e, f } = this.group.getScreenCTM();
    const k = nearestSegment(wire.path, [(event.clientX - e) / a, (event.clientY - f) / d]);
    item.style.cursor = wire.isStraight ? "pointer" : isVerticalAt(wire.path, k) ? "ew-resize" : "ns-resize";
  }

  /* Clicks of screen readers have no pointer. */
  #clicked(event) {
    const key = event.target.closest("[data-wire]")?.dataset.wire;
    if (key && event.detail === 0 && !(event.pointerId > 0)) this.select(key);
  }

  /* Keys at a wire: Enter selects; arrows across the selected segment move it, along it they go to the next one. */
  #key(event) {
    const wire = this.wires.get(event.target.closest("[data-wire]")?.dataset.wire), { key, ctrlKey, metaKey, altKey } = event;
    if (!wire || ctrlKey || metaKey || altKey) return;
    const isHere = this.selected === wire.key;
    if (key === "Enter" || key === " ") this.select(wire.key);
    else if (key in STEPS) {
      if (!isHere) this.select(wire.key);
      this.#arrow(wire, STEPS[key], event.shiftKey ? 4 : 1);
    } else if (key.toLowerCase() === "r") this.#reset(wire.key);
    else if (key === "Delete" || key === "Backspace") {
      if (isHere) return;  // the drawing removes what is selected
      this.disconnect(wire.key);
    } else return;
    event.preventDefault();
  }

  #arrow(wire, [dx, dy], step) {
    const { path, points, isStraight } = wire, k = this.#chosen(wire), isVertical = isVerticalAt(path, k);
    if (isStraight) return;
    if (isVertical === (dx === 0)) {
      const ahead = isVertical ? (path[k + 1][1] - path[k][1]) * dy > 0 : (path[k + 1][0] - path[k][0]) * dx > 0;
      const next = k + (ahead ? 1 : -1);
      if (next < 0 || next + 1 >= path.length) return;
      this.#choose(path, next);
      this.#mark();
      this.#tell("wires.segment", wire.key);
      return;
    }
    this.#choose(path, k);
    const coordinate = path[k][isVertical ? 0 : 1] + step * (isVertical ? dx : dy);
    this.#draft(wire, movedSegment(path, points, k, coordinate, Boolean(this.#rootOf(wire))), coordinate);
    this.#tell("wires.moved", wire.key);
    this.#drop(wire, { continues: true });
  }

  /* Announce the selected segment of a wire. */
  #tell(message, key) {
    const wire = this.wires.get(key);
    this.store.announce(text(message, { port: key, number: this.#chosen(wire) + 1, count: wire.path.length - 1 }));
  }
}
