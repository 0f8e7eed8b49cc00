/* Drawing of the circuit: parts, ports and wires, drawn by difference so that nodes and focus stay.

   The text of the circuit is the only state. Positions of a running drag, and of parts that the file does not place,
   are those of the drawing. */

import { Animation } from "./animation.js";
import { Clipboard } from "./clipboard.js";
import { Connecting } from "./connecting.js";
import { split } from "./connections.js";
import { around, boxOf, freePlace, isCoordinate, mirroredPlace, overlaps, rotatedPlace } from "./geometry.js";
import { Keys } from "./drawing_keys.js";
import { Offers } from "./offers.js";
import { PartNode } from "./part_node.js";
import { Pointer } from "./pointer.js";
import { svgElement } from "./symbols.js";
import { text } from "./strings.js";
import { Viewport } from "./viewport.js";
import { Wires } from "./wires.js";

const EMPTY = { title: "", parts: {}, connections: {}, signals: {}, drawing: {}, run: {} };
const GAP = 6;  // distance of a new part from the selected one; a valve moves by 4 to the right
const UNKNOWN = {
  kind: "", box: [-4, -3, 8, 6], ports: [], fields: [], svg: '<path class="dashed" d="M-4 -3L4 -3L4 3L-4 3L-4 -3"/>',
};

export class Drawing {
  constructor(svg, store) {
    Object.assign(this, { svg, store, items: new Map(), moving: new Map(), settled: new Map(), coming: new Map() });
    svg.setAttribute("role", "application");
    svg.setAttribute("aria-roledescription", text("drawing.role"));
    if (!svg.hasAttribute("tabindex")) svg.setAttribute("tabindex", 0);
    this.#layers();
    this.viewport = new Viewport(svg, () => this.bounds());
    this.viewport.addEventListener("change", () => this.#zoomed());
    this.wires = new Wires(this.wireLayer, store, () => this.pins());
    this.wires.onRouted = () => this.animation?.later();
    this.offers = new Offers(this);
    this.connecting = new Connecting(this);
    this.animation = new Animation(this);
    this.clipboard = new Clipboard(this);
    this.pointer = new Pointer(this);
    this.keys = new Keys(this);
    store.addEventListener("open", () => this.#opened());
    store.addEventListener("state", () => this.update());
    store.addEventListener("selection", () => this.mark());
    for (const name of ["run", "cursor"]) store.addEventListener(name, () => this.animation.later());
    this.update();
  }

  /* --- Content --- */

  /* Last valid view of the circuit. */
  get view() {
    const view = this.store.state?.view;
    return view && view.parts ? view : EMPTY;
  }

  /* Palette entry of a part with its symbol. */
  entry(name) {
    return this.store.entry(name) ?? UNKNOWN;
  }

  /* Place of a part, including a running drag. */
  place(name) {
    const stated = this.isPlaced(name) ? this.view.drawing[name] : this.settled.get(name) ?? this.store.state?.places?.[name];
    return this.moving.get(name) ?? cleanPlace(stated ?? { x: 0, y: 0 });
  }

  /* True if the file contains the position of a part. */
  isPlaced(name) {
    const place = this.view.drawing[name];
    return isCoordinate(place?.x) && isCoordinate(place?.y);
  }

  /* Ends of all parts at which wires begin or end. */
  get ends() {
    return [...this.items.values()].flatMap(item => item.ends);
  }

  /* Ends of an address, of which a part can have several. */
  endsAt(address) {
    return this.items.get(split(address)[0])?.ends.filter(end => end.address === address) ?? [];
  }

  /* Boxes and names that new parts do not cover. */
  taken(without = new Set()) {
    const items = [...this.items.values()].filter(item => !without.has(item.name));
    return [...items.flatMap(item => [item.box, item.labelBox]), ...this.coming.values()];
  }

  /* Box of the whole drawing, or null. */
  bounds() {
    const points = [...this.wires?.wires.values() ?? []].flatMap(wire => wire.path ?? []);
    const boxes = [...this.items.values()].flatMap(item => [item.box, item.labelBox]);
    return around([...boxes, ...points.map(([x, y]) => ({ x, y, width: 0, height: 0 }))]);
  }

  /* Show the present circuit. */
  update() {
    const { parts } = this.view, isEmpty = this.items.size === 0;
    for (const [name, item] of this.items) {
      if (!(name in parts)) { item.remove(); this.items.delete(name); this.settled.delete(name); }
    }
    for (const name of Object.keys(parts)) {
      if (!this.items.has(name)) {
        this.items.set(name, new PartNode(name, this.partLayer));
        this.#settle(name);
      }
    }
    this.draw();
    this.#order();
    this.mark();
    this.animation.changed();
    if (this.isOpened || (isEmpty && this.items.size > 1)) this.viewport.fit();
    this.isOpened = false;
  }

  /* Another circuit is open. */
  #opened() {
    for (const item of this.items.values()) item.remove();
    for (const memory of [this.items, this.moving, this.settled]) memory.clear();
    this.isOpened = true;
  }

  /* Place a new part that the file does not place: where the layout has it, unless another part is there. */
  #settle(name) {
    if (this.isPlaced(name)) return;
    const entry = this.entry(name), place = this.store.state.places?.[name] ?? { x: 0, y: 0 }, box = boxOf(entry, place);
    const others = [...this.items.values()].filter(item => item.box).map(item => item.box);
    this.settled.set(name, others.some(other => overlaps(box, other)) ? freePlace(entry, name, place, others) : place);
  }

  /* Draw the parts `moved`, or all, at their places, and the wires. */
  draw(moved = null) {
    for (const name of moved ?? this.items.keys()) {
      const entry = this.entry(name);
      this.items.get(name)?.draw(entry, this.place(name), this.#symbol(name, entry));
    }
    const ends = new Map();
    for (const end of this.ends) ends.set(end.address, [...ends.get(end.address) ?? [], end]);
    const items = [...this.items.values()];
    this.wires.update({
      ends, boxes: items.map(({ name, box }) => ({ name, ...box })), labels: items.map(item => item.labelBox), moved,
    });
    this.connecting.redraw();
    this.animation.later();
  }

  #symbol(name, entry) {
    const own = this.store.state?.symbols?.[name]?.svg;
    if (own) return own;
    const isDriven = entry.ports.some(({ type, name: port }) => type === "input"
      && (`${name}.${port}` in this.view.connections || `${name}.${port}` in this.view.signals));
    return (isDriven && entry.svg_driven) || entry.svg;
  }

  /* Show the selection, errors and connections, or the ends that a connection in progress can have. */
  mark() {
    const { selection } = this.store, errors = this.#errors(this.store.errors);
    for (const item of this.items.values()) {
      const kind = this.view.parts[item.name]?.kind ?? "";
      item.mark({ isSelected: selection.has(item.name), kind, view: this.view, errors });
    }
    this.svg.setAttribute("aria-label", text("drawing.label", { count: this.items.size }));
    this.connecting.mark();
  }

  /* Errors with the part and the port at which they are shown. */
  #errors(errors) {
    return errors.filter(error => error.address).map(error => {
      const inside = error.address.replace(/^(parts|connections|signals|drawing)\./, "").replaceAll('"', "");
      const [owner] = split(inside);
      return { address: error.address, code: error.code, owner, port: inside, words: [error.message, error.hint].filter(Boolean).join(" ") };
    }).filter(error => this.items.has(error.owner));
  }

  /* Nodes follow the drawing from left to right, then from top to bottom, so that the Tab key does. */
  #order() {
    const sorted = [...this.items.values()].sort((a, b) => a.box.x - b.box.x || a.box.y - b.box.y);
    const layer = this.partLayer, focused = document.activeElement;
    sorted.forEach((item, k) => {
      if (layer.children[k] === item.item) return;
      if (layer.moveBefore && item.item.isConnected) layer.moveBefore(item.item, layer.children[k] ?? null);
      else layer.insertBefore(item.item, layer.children[k] ?? null);
    });
    if (focused !== document.activeElement && layer.contains(focused)) focused.focus({ preventScroll: true });
  }

  /* --- Operations --- */

  /* Operations that write the places of all parts that the file does not place, except some. */
  pins(without = new Set()) {
    return Object.keys(this.view.parts).filter(name => !this.isPlaced(name) && !without.has(name))
      .map(name => placing(name, this.place(name)));
  }

  /* Store new places of parts; they are shown until the server has answered. */
  async put(places, options = {}) {
    for (const [name, place] of places) this.moving.set(name, place);
    this.draw(new Set(places.keys()));
    const operations = [...places].map(([name, place]) => placing(name, place));
    await this.store.apply([...this.pins(new Set(places.keys())), ...operations, ...this.wires.moved()], options);
    for (const [name, place] of places) {
      if (this.moving.get(name) === place) this.moving.delete(name);
    }
    this.draw(new Set([...places.keys()].filter(name => this.items.has(name))));
    this.#order();
  }

  /* Add a part of a kind at the nearest free place to a point, by default beside the selected part. */
  async add(kind, point = null) {
    const entry = this.store.palette.get(kind);
    const name = this.freeName(kind), area = point ? null : this.viewport.wideArea;
    const place = freePlace(entry, name, point ?? this.#wanted(entry), this.taken(), area);
    if (!await this.insert([this.adding(kind, name, place)], { select: "created" })) return;
    this.store.announce(text("drawing.added", { name }));
    this.reveal([name]);
  }

  /* Make parts and their ports visible. */
  reveal(names) {
    const boxes = names.filter(name => this.items.has(name)).flatMap(name => [this.items.get(name).box, this.items.get(name).labelBox]);
    if (!boxes.length) return;
    const { x, y, width, height } = around(boxes);
    this.viewport.reveal({ x: x - 1.5, y: y - 1.5, width: width + 3, height: height + 3 });
  }

  /* Place at the right of the part that is selected or coming, otherwise in the left half of the visible area. */
  #wanted(entry) {
    const { x, y, width, height } = this.viewport.area, [name] = this.selected;
    const last = [...this.coming.values()].at(-1);
    const gap = GAP + roomForNames(entry);
    if (last) return { x: last.x + last.width + gap - entry.box[0], y: last.row };
    if (this.selected.length !== 1) return { x: x + width / 4, y: y + height / 2 };
    const { box } = this.items.get(name);
    return { x: box.x + box.width + gap - entry.box[0], y: this.place(name).y };
  }

  /* Operation that adds a part with starting values, of which some can be other ones. */
  adding(kind, name, { x, y }, others = {}) {
    const fields = { ...this.store.start?.[kind] };
    for (const [field, value] of Object.entries(others)) {
      const usual = fields[field];
      fields[field] = usual && typeof usual === "object" ? { ...usual, value } : value;
    }
    return { op: "add", kind, name, place: { x, y }, ...Object.keys(fields).length && { fields } };
  }

  /* Apply operations that add parts; their places are taken until the server has answered. */
  async insert(operations, options = {}) {
    const added = operations.filter(({ op }) => op === "add");
    for (const { name, kind, place } of added) this.coming.set(name, { ...boxOf(this.store.palette.get(kind), place), row: place.y });
    const state = await this.store.apply([...this.pins(), ...operations], options);
    for (const { name } of added) this.coming.delete(name);
    return state;
  }

  /* First of the names `orifice`, `orifice_2`, `orifice_3`, ... that no part has. */
  freeName(base, others = new Set()) {
    const isTaken = name => name in this.view.parts || this.coming.has(name) || others.has(name);
    let name = base;
    for (let number = 2; isTaken(name); number++) name = `${base}_${number}`;
    return name;
  }

  /* Rotate the selection by a quarter turn clockwise. */
  rotate() {
    this.#turn(rotatedPlace);
  }

  /* Exchange left and right of the selection. */
  mirror() {
    this.#turn(mirroredPlace);
  }

  #turn(turn) {
    const names = this.selected;
    if (!names.length) return;
    const places = names.map(name => this.place(name));
    const middle = key => Math.round((Math.min(...places.map(place => place[key])) + Math.max(...places.map(place => place[key]))) / 2);
    const centre = { x: middle("x"), y: middle("y") };
    this.put(new Map(names.map((name, k) => [name, turn(places[k], centre)])));
    this.reveal(names);
  }

  /* Remove the selected parts, or the selected wire. */
  remove() {
    const { wire } = this.store, names = this.selected;
    if (names.length) {
      this.#focusBeside(names);
      this.store.apply([{ op: "remove", parts: names }]).then(state => state && this.store.announce(text("drawing.removed", { names: names.join(", ") })));
    } else if (wire) {
      this.wires.disconnect(wire.input ?? wire.port);
      this.store.selectWire(null);
    }
  }

  /* The focus of a part that is removed moves to the drawing. */
  #focusBeside(names) {
    if (names.some(name => this.items.get(name)?.item.contains(document.activeElement))) this.svg.focus({ preventScroll: true });
  }

  /* Move the selection by a distance in grid units. */
  move(dx, dy) {
    const names = this.selected;
    const moved = names.map(name => { const place = this.place(name); return [name, { ...place, x: place.x + dx, y: place.y + dy }]; });
    this.put(new Map(moved), { continues: true });
    this.reveal(names);
  }

  /* Names of the selected parts of the circuit. */
  get selected() {
    return [...this.store.selection].filter(name => this.items.has(name));
  }

  copy() {
    return this.clipboard.copyButton();
  }

  paste() {
    return this.clipboard.pasteButton();
  }

  /* Change the zoom by a factor; without one, show the whole drawing. */
  zoom(factor = null) {
    if (factor === null) this.viewport.fit();
    else this.viewport.zoomBy(factor);
  }

  /* Use a key of the page; the result is true if the drawing used it. */
  onKey(event) {
    return this.keys.use(event);
  }

  /* Show the state of the last run at the cursor. */
  show() {
    this.animation.show();
  }

  /* --- Layers --- */

  #layers() {
    const { svg } = this;
    svg.classList.add("drawing");
    const defs = svgElement("defs", {}, svg);
    const pattern = svgElement("pattern", { id: "grid", width: 1, height: 1, x: -0.5, y: -0.5, patternUnits: "userSpaceOnUse" }, defs);
    svgElement("circle", { cx: 0.5, cy: 0.5, r: 0.07, class: "grid-dot" }, pattern);
    this.grid = svgElement("rect", { class: "grid", fill: "url(#grid)" }, svg);
    for (const name of ["wire", "part", "arrow", "over"]) this[`${name}Layer`] = svgElement("g", { class: `${name}-layer` }, svg);
  }

  #zoomed() {
    const { x, y, width, height } = this.viewport.area;
    for (const [name, value] of Object.entries({ x, y, width, height })) this.grid.setAttribute(name, value);
    this.svg.classList.toggle("is-far", this.viewport.zoom < 0.5);
    this.svg.style.setProperty("--pixel", `${0.1 / this.viewport.zoom}`);
  }
}

/* Width for the names of the inputs at the left of a controller. */
function roomForNames({ ports }) {
  const names = ports.filter(({ type, side }) => type === "input" && side === "left").map(({ name }) => name.length);
  return names.length > 2 ? Math.ceil(0.4 * Math.max(...names)) : 0;
}

/* Place with valid rotation and mirror. */
function cleanPlace({ x, y, rotation, mirror }) {
  return { x, y, rotation: [90, 180, 270].includes(rotation) ? rotation : 0, mirror: mirror === true };
}

/* Operation that stores the place of a part. */
function placing(part, { x, y, rotation = 0, mirror = false }) {
  return { op: "place", part, x, y, rotation, mirror };
}
