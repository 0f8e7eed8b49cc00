/* Keys of the drawing. The page passes keys here that no field uses.

   Tab goes from part to part; Enter selects a part, and then Tab goes to its ports. Arrow keys move the selection, or
   the view if nothing is selected; at a port they go to the next port in that direction. Enter at a port begins and ends a connection. */

import { split, targetOf } from "./connections.js";

const PAN = 40;  // pixels by which an arrow key moves the view
const STEPS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

export class Keys {
  constructor(drawing) {
    this.drawing = drawing;
  }

  /* Use a key; the result is true if it has an effect in the drawing. */
  use(event) {
    const { drawing } = this, { key, ctrlKey, metaKey, altKey } = event;
    if (event.defaultPrevented || altKey) return false;
    if (ctrlKey || metaKey) return this.#command(key.toLowerCase());
    if (key === "Escape") return this.#escape();
    const isHere = drawing.svg.contains(document.activeElement) || document.activeElement === document.body;
    if (key in STEPS) return isHere && this.#arrow(STEPS[key], event.shiftKey);
    if (key === "Enter" || key === " ") return this.#press(event);
    if (this.#isElsewhere()) return false;
    const action = this.#actions()[key.length === 1 ? key.toLowerCase() : key];
    if (!action) return false;
    action();
    return true;
  }

  /* Keys of the drawing have no effect in other panels. */
  #isElsewhere() {
    return document.activeElement?.closest("aside, #curves, dialog") !== null;
  }

  #actions() {
    const { drawing } = this, { connecting } = drawing;
    return {
      Delete: () => drawing.remove(),
      Backspace: () => drawing.remove(),
      r: () => drawing.rotate(),
      m: () => drawing.mirror(),
      p: () => this.#firstPort(),
      c: () => this.#fromNode(),
      w: () => this.#wire(),
      a: () => this.#vent(),
      "+": () => drawing.zoom(1.25),
      "=": () => drawing.zoom(1.25),
      "-": () => drawing.zoom(0.8),
      0: () => drawing.zoom(null),
    };
  }

  /* Copy, cut and paste are events of the document. */
  #command(key) {
    if (key !== "a" || this.#isElsewhere()) return false;
    this.drawing.store.select([...this.drawing.items.keys()]);
    return true;
  }

  #escape() {
    const { drawing } = this, { store } = drawing;
    if (drawing.pointer.escape() || drawing.connecting.cancel() || drawing.offers.close()) return true;
    if (!store.selection.size && !store.wire) return false;
    store.selectWire(null);
    store.select([]);
    return true;
  }

  /* Part or port that has the focus: {part} or {end}. */
  get focused() {
    const { drawing } = this, element = document.activeElement;
    if (!drawing.svg.contains(element)) return null;
    const port = element.closest("[data-port]")?.dataset.port, part = element.closest("[data-part]")?.dataset.part;
    if (port) return { end: drawing.endsAt(port)[0] };
    return part ? { part } : null;
  }

  #press(event) {
    const { focused } = this;
    if (!focused) return false;
    this.press(focused, event.shiftKey);
    return true;
  }

  /* Enter at a part or port, or a click of a screen reader. */
  press(target, isMore = false) {
    const { connecting, store } = this.drawing;
    if (connecting.isActive) { connecting.finish(target); return; }
    if (target.end) { connecting.begin(target.end); return; }
    const isSelected = store.selection.has(target.part);
    if (isMore && isSelected) store.select([...store.selection].filter(name => name !== target.part));
    else store.select(isMore ? [...store.selection, target.part] : [target.part]);
  }

  #arrow([dx, dy], isFar) {
    const { drawing, focused } = this, { store, connecting } = drawing;
    if (focused?.end || connecting.isActive) { this.#go(focused, dx, dy); return true; }
    if (focused && !store.selection.has(focused.part)) store.select([focused.part]);
    const step = isFar ? 4 : 1;
    if (!drawing.selected.length) { drawing.viewport.pan(-PAN * step * dx, -PAN * step * dy); return true; }
    drawing.move(step * dx, step * dy);
    return true;
  }

  /* Move the focus to the next port in a direction; while connecting, to the next possible end. */
  #go(focused, dx, dy) {
    const { drawing } = this, { connecting } = drawing, from = focused?.end ?? drawing.place(focused?.part) ?? connecting.from;
    let best = null, least = Infinity;
    for (const stop of [...drawing.items.values()].flatMap(item => this.#stops(item, connecting))) {
      const [right, down] = [stop.x - from.x, stop.y - from.y];
      const along = right * dx + down * dy, across = Math.abs(right * dy) + Math.abs(down * dx);
      if (along > 0 && stop.node !== document.activeElement && along + 3 * across < least) [best, least] = [stop, along + 3 * across];
    }
    best?.node.focus({ preventScroll: true });
    if (best) drawing.reveal([best.part]);
  }

  #stops(item, connecting) {
    const ports = [...item.ports.values()].filter(({ end }) => end.port).map(({ node, end }) => ({ node, part: item.name, x: end.x, y: end.y }));
    if (!connecting.isActive) return ports;
    const possible = ports.filter(({ node }) => !node.classList.contains("is-impossible"));
    const isNode = item.ends.some(end => !end.port) && !item.item.classList.contains("is-impossible");
    return isNode ? [...possible, { node: item.node, part: item.name, ...item.place }] : possible;
  }

  #firstPort() {
    const { drawing, focused } = this, part = focused?.part ?? focused?.end?.part ?? drawing.selected[0];
    const port = [...drawing.items.get(part)?.ports.values() ?? []].find(({ end }) => end.port);
    port?.node.focus({ preventScroll: true });
  }

  /* Move the focus to the wire of the port that has it, or to the next wire of the part. */
  #wire() {
    const { drawing, focused } = this, part = focused?.part ?? drawing.selected[0];
    const own = [...drawing.wireLayer.querySelectorAll("[data-wire]")].filter(wire => {
      const [end] = drawing.endsAt(wire.dataset.wire);
      return focused?.end ? wire.dataset.wire === focused.end.address : end?.part === part || split(targetOf(drawing.view, end))[0] === part;
    });
    const wire = own[(own.indexOf(document.activeElement.closest("[data-wire]")) + 1) % own.length];
    wire?.focus({ preventScroll: true });
    if (wire) drawing.wires.select(wire.dataset.wire);
  }

  /* Connect the port that has the focus, or a connection in progress, to the atmosphere. */
  #vent() {
    const { connecting } = this.drawing, { focused } = this;
    const isBegun = !connecting.isActive && focused?.end;
    if (isBegun) connecting.begin(focused.end);
    if (connecting.isActive) connecting.vent();
    if (isBegun && connecting.isActive) connecting.cancel();
  }

  /* Begin a connection at a gas node or body. */
  #fromNode() {
    const { drawing, focused } = this, part = focused?.part ?? drawing.selected[0];
    const end = drawing.items.get(part)?.ends.find(one => !one.port) ?? focused?.end;
    if (end && !drawing.connecting.isActive) drawing.connecting.begin(end);
  }
}
