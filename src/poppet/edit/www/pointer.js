/* Mouse, pen and touch in the drawing: select, drag, connect, band, pan and pinch. */

import { overlaps } from "./geometry.js";
import { svgElement } from "./symbols.js";
import { MODULE } from "./viewport.js";

const SLACK = { mouse: 3, pen: 5, touch: 9 };  // pixels before a press becomes a drag
const NEAR = { mouse: 8, pen: 12, touch: 18 };  // pixels around a port

export class Pointer {
  constructor(drawing) {
    Object.assign(this, { drawing, fingers: new Map(), gesture: null });
    this.band = svgElement("rect", { class: "band", visibility: "hidden" }, drawing.overLayer);
    const { svg } = drawing, on = (name, handler) => svg.addEventListener(name, handler.bind(this));
    on("pointerdown", this.#down);
    on("pointermove", this.#move);
    on("pointerup", this.#up);
    on("pointercancel", this.#cancel);
    on("contextmenu", event => event.preventDefault());
    on("click", this.#clicked);
    on("dblclick", event => event.preventDefault());
  }

  /* Target at a position: {end}, {part}, {wire}, or null for the background. */
  target(event) {
    const { drawing } = this, element = document.elementFromPoint(event.clientX, event.clientY);
    if (!element || !drawing.svg.contains(element)) return null;
    const end = this.#portNear(event, element);
    if (end) return { end };
    const part = element.closest("[data-part]")?.dataset.part;
    if (part) return { part };
    const wire = element.closest("[data-wire]")?.dataset.wire;
    return wire ? { wire } : null;
  }

  /* Nearest port to a position, at most some pixels away, and less far in a part. Ports of overlapping areas are told apart
     by the distance; ports that a connection in progress cannot end at must be hit themselves. */
  #portNear(event, element) {
    const { viewport, items, connecting } = this.drawing, { x, y } = viewport.point(event), isPort = element.closest(".end") !== null;
    const near = NEAR[event.pointerType || "mouse"] / MODULE / viewport.zoom;
    const reach = isPort ? 2 : element.closest("[data-part]") ? Math.min(near, 1) : near;
    let best = null, least = reach;
    for (const item of items.values()) {
      for (const { end, node } of item.ports.values()) {
        const distance = Math.hypot(end.x - x, end.y - y);
        if (!isPort && connecting.isActive && node.classList.contains("is-impossible")) continue;
        if (distance < least) [best, least] = [end, distance];
      }
    }
    const isFar = best && !isPort && viewport.zoom < 0.4;  // parts are easier to hit in a small drawing
    return isFar ? null : best;
  }

  #down(event) {
    const { drawing, fingers } = this, { svg, connecting } = drawing;
    if (event.pointerType === "touch") {
      fingers.set(event.pointerId, event);
      if (fingers.size === 2) { this.#stop(); this.gesture = this.#pinch(); return; }
      if (fingers.size > 2) return;
    }
    if (this.gesture) return;
    const target = this.target(event);
    svg.setPointerCapture(event.pointerId);
    this.gesture = event.button ? this.#panning() : this.#begun(event, target);
    Object.assign(this.gesture, { id: event.pointerId, x: event.clientX, y: event.clientY, last: event, isMoved: false });
  }

  #begun(event, target) {
    const { connecting } = this.drawing;
    if (connecting.isActive) return this.#finishing();
    if (target?.end) return this.#wiring(target.end);
    if (target?.part) return this.#dragging(target.part, event);
    if (target?.wire) return this.#segment(target.wire, event);
    return event.pointerType === "touch" ? this.#panning() : this.#banding(event);
  }

  #move(event) {
    const { gesture, fingers, drawing } = this;
    if (fingers.has(event.pointerId)) fingers.set(event.pointerId, event);
    if (!gesture) {
      if (drawing.connecting.isActive) { drawing.connecting.move(drawing.viewport.point(event)); drawing.connecting.over(this.target(event)); }
      return;
    }
    if (gesture.pinch) { gesture.pinch(); return; }
    if (event.pointerId !== gesture.id) return;
    const distance = Math.hypot(event.clientX - gesture.x, event.clientY - gesture.y);
    if (!gesture.isMoved && distance <= SLACK[event.pointerType || "mouse"]) return;
    gesture.isMoved = true;
    gesture.move(event);
    gesture.last = event;
  }

  #up(event) {
    const { gesture } = this;
    this.fingers.delete(event.pointerId);
    if (!gesture || (gesture.id !== undefined && gesture.id !== event.pointerId)) return;
    this.gesture = null;
    if (gesture.pinch) return;
    if (gesture.isMoved) gesture.end(event);
    else gesture.click?.(event);
  }

  #cancel(event) {
    this.fingers.delete(event.pointerId);
    this.#stop();
  }

  /* Stop a gesture without an effect; the result is true if there was one. */
  #stop() {
    const { gesture } = this;
    this.gesture = null;
    gesture?.cancel?.();
    return Boolean(gesture?.isMoved);
  }

  /* Escape stops a drag. */
  escape() {
    return this.#stop();
  }

  /* Clicks of screen readers have no pointer. */
  #clicked(event) {
    if (event.detail !== 0 || event.pointerId > 0) return;
    const port = event.target.closest("[data-port]")?.dataset.port, part = event.target.closest("[data-part]")?.dataset.part;
    if (port) this.drawing.keys.press({ end: this.drawing.endsAt(port)[0] });
    else if (part) this.drawing.keys.press({ part });
  }

  /* --- Gestures --- */

  #panning() {
    const { viewport, store, connecting } = this.drawing;
    return {
      move: event => viewport.pan(event.clientX - this.gesture.last.clientX, event.clientY - this.gesture.last.clientY),
      end: () => {},
      click: event => { if (event.button === 0 && !connecting.isActive) store.select([]); },
    };
  }

  #pinch() {
    const { fingers } = this, { viewport } = this.drawing;
    const now = () => {
      const [a, b] = [...fingers.values()];
      const clientX = (a.clientX + b.clientX) / 2, clientY = (a.clientY + b.clientY) / 2;
      return { clientX, clientY, distance: Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY) || 1 };
    };
    let last = now();
    return {
      pinch: () => {
        if (fingers.size < 2) return;
        const next = now();
        viewport.pan(next.clientX - last.clientX, next.clientY - last.clientY);
        viewport.zoomBy(next.distance / last.distance, viewport.point(next));
        last = next;
      },
    };
  }

  /* Press at a port: a click or a drag begins a connection, and the end of the drag is the other end. */
  #wiring(end) {
    const { connecting, viewport, items } = this.drawing;
    const port = items.get(end.part)?.port(end.address);
    if (end.port) port?.node.focus({ preventScroll: true });
    connecting.begin(end);
    return {
      move: event => { connecting.move(viewport.point(event)); connecting.over(this.target(event)); },
      end: event => {
        const target = this.target(event);
        connecting.over(null);
        const isStart = target?.end?.address === end.address;
        if (target && !isStart) connecting.finish(target, viewport.point(event));
        if (connecting.isActive) connecting.cancel();
      },
      cancel: () => connecting.cancel(),
    };
  }

  /* Press at a wire: a click selects it, a drag moves its segment. */
  #segment(wire, event) {
    const { viewport, wires } = this.drawing;
    return wires.gesture(wire, viewport.point(event), now => viewport.point(now));
  }

  /* Press while a connection is in progress. */
  #finishing() {
    const { connecting, viewport } = this.drawing;
    const end = event => {
      const target = this.target(event);
      connecting.over(null);
      if (target) connecting.finish(target, viewport.point(event));
      else connecting.cancel();
    };
    return { move: event => { connecting.move(viewport.point(event)); connecting.over(this.target(event)); }, end, click: end };
  }

  /* Press at a part: a click selects it, a drag moves the selection. */
  #dragging(part, event) {
    const { drawing } = this, { store, viewport } = drawing, isMore = event.shiftKey || event.ctrlKey || event.metaKey;
    const start = viewport.point(event), wasSelected = store.selection.has(part);
    if (!wasSelected) store.select(isMore ? [...store.selection, part] : [part]);
    drawing.items.get(part).node.focus({ preventScroll: true });
    const places = new Map(drawing.selected.map(name => [name, drawing.place(name)]));
    let shift = [0, 0];
    const show = () => {
      for (const [name, place] of places) drawing.moving.set(name, { ...place, x: place.x + shift[0], y: place.y + shift[1] });
      drawing.draw(new Set(places.keys()));
    };
    return {
      move: now => {
        const { x, y } = viewport.point(now), next = [Math.round(x - start.x), Math.round(y - start.y)];
        if (next[0] === shift[0] && next[1] === shift[1]) return;
        shift = next;
        show();
      },
      end: () => {
        const moved = new Map([...places].filter(([name]) => drawing.items.has(name)).map(([name]) => [name, drawing.moving.get(name) ?? places.get(name)]));
        if (shift[0] || shift[1]) drawing.put(moved);
        else for (const name of places.keys()) drawing.moving.delete(name);
      },
      click: () => {
        if (isMore && wasSelected) store.select([...store.selection].filter(name => name !== part));
        else if (!isMore && store.selection.size > 1) store.select([part]);
      },
      cancel: () => {
        for (const name of places.keys()) drawing.moving.delete(name);
        drawing.draw(new Set([...places.keys()].filter(name => drawing.items.has(name))));
      },
    };
  }

  /* Press at the background: a click empties the selection, a drag selects what its rectangle touches. */
  #banding(event) {
    const { drawing, band } = this, { store, viewport } = drawing, start = viewport.point(event);
    const before = event.shiftKey || event.ctrlKey || event.metaKey ? [...store.selection] : [];
    const box = now => {
      const { x, y } = viewport.point(now);
      return { x: Math.min(x, start.x), y: Math.min(y, start.y), width: Math.abs(x - start.x), height: Math.abs(y - start.y) };
    };
    drawing.svg.focus({ preventScroll: true });
    return {
      move: now => {
        for (const [name, value] of Object.entries(box(now))) band.setAttribute(name, value);
        band.setAttribute("visibility", "visible");
      },
      end: now => {
        band.setAttribute("visibility", "hidden");
        const inside = [...drawing.items.values()].filter(item => overlaps(item.box, box(now))).map(item => item.name);
        store.select([...new Set([...before, ...inside])]);
      },
      click: () => { store.selectWire(null); store.select(before); },
      cancel: () => band.setAttribute("visibility", "hidden"),
    };
  }
}
