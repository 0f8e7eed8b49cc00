/* Visible part of the drawing: pan, zoom about a point, and conversion of positions. */

import { contains } from "./geometry.js";

export const MODULE = 10;  // pixels of a grid unit at zoom 1
const WIDE = 0.6;  // least zoom at which new parts stay in the visible area
const LEAST = 0.2, MOST = 5, EDGE = 4;  // limits of the zoom; grid units that stay visible of the drawing

export class Viewport extends EventTarget {
  /* `bounds` returns the box of the whole drawing, or null if it is empty. */
  constructor(svg, bounds) {
    super();
    Object.assign(this, { svg, bounds, x: -20, y: -15, zoom: 1, isUntouched: true, lastSize: { width: 600, height: 400 } });
    new ResizeObserver(() => this.#resized()).observe(svg);
    svg.addEventListener("wheel", event => this.#wheel(event), { passive: false });
  }

  /* Width and height of the drawing area in pixels; while it is hidden, the last ones. */
  get size() {
    const { width, height } = this.svg.getBoundingClientRect();
    if (width && height) this.lastSize = { width, height };
    return this.lastSize;
  }

  /* Visible box in grid units. */
  get area() {
    const { width, height } = this.size, scale = MODULE * this.zoom;
    return { x: this.x, y: this.y, width: width / scale, height: height / scale };
  }

  /* Visible box, or a larger one about it that would be visible at a smaller zoom at which names can be read. */
  get wideArea() {
    const { x, y, width, height } = this.area, factor = Math.max(1, this.zoom / WIDE);
    return { x: x - width * (factor - 1) / 2, y: y - height * (factor - 1) / 2, width: width * factor, height: height * factor };
  }

  /* Position in the drawing of a position in the window. */
  point({ clientX, clientY }) {
    const { left, top } = this.svg.getBoundingClientRect(), scale = MODULE * this.zoom;
    return { x: this.x + (clientX - left) / scale, y: this.y + (clientY - top) / scale };
  }

  /* Move the drawing by a distance in pixels. */
  pan(dx, dy) {
    this.isUntouched = false;
    this.#show(this.x - dx / (MODULE * this.zoom), this.y - dy / (MODULE * this.zoom), this.zoom);
  }

  /* Change the zoom within its limits; the whole of a large drawing can be below them. `fixed` is the point of the drawing
     that stays in place, by default the middle. */
  zoomBy(factor, fixed = this.#middle()) {
    this.isUntouched = false;
    const zoom = Math.min(MOST, Math.max(Math.min(LEAST, this.zoom), this.zoom * factor)), ratio = this.zoom / zoom;
    this.#show(fixed.x - (fixed.x - this.x) * ratio, fixed.y - (fixed.y - this.y) * ratio, zoom);
  }

  /* Show the whole drawing, not larger than at zoom `most`. */
  fit(most = 1) {
    const box = this.bounds(), { width, height } = this.size;
    this.isUntouched = true;
    if (!box) { this.#show(-width / MODULE / 2, -height / MODULE / 2, 1); return; }
    const ratio = Math.min(width / (box.width + 2 * EDGE), height / (box.height + 2 * EDGE)) / MODULE;
    const zoom = Math.min(most, ratio), scale = MODULE * zoom;
    this.#show(box.x + box.width / 2 - width / scale / 2, box.y + box.height / 2 - height / scale / 2, zoom);
  }

  /* Make a box visible: by moving the drawing if the user chose the view, otherwise by showing the whole drawing. */
  reveal(box) {
    if (contains(this.area, box)) return;
    const { x, y, width, height } = this.area;
    if (this.isUntouched || box.width > width || box.height > height) { this.fit(); return; }
    const shift = (low, size, from, length) => (low < from ? low - 1 - from : Math.max(0, low + size + 1 - from - length));
    this.#show(this.x + shift(box.x, box.width, x, width), this.y + shift(box.y, box.height, y, height), this.zoom);
  }

  #middle() {
    const { x, y, width, height } = this.area;
    return { x: x + width / 2, y: y + height / 2 };
  }

  #show(x, y, zoom) {
    this.zoom = zoom;
    const { width, height } = this.size, scale = MODULE * zoom, box = this.bounds();
    const within = (value, low, size, length) =>
      Math.min(low + size - EDGE, Math.max(low + EDGE - length, value));
    this.x = box ? within(x, box.x, box.width, width / scale) : x;
    this.y = box ? within(y, box.y, box.height, height / scale) : y;
    this.shown = this.area;
    this.svg.setAttribute("viewBox", `${this.x} ${this.y} ${width / scale} ${height / scale}`);
    this.dispatchEvent(new Event("change"));
  }

  /* What was visible stays visible. */
  #resized() {
    if (!this.svg.getBoundingClientRect().width) return;
    const box = this.bounds(), before = this.shown;
    const isCut = box && (!before || contains(before, box)) && !contains(this.area, box);
    if (isCut || !before) this.fit(before ? this.zoom : 1);
    else this.#show(this.x, this.y, this.zoom);
  }

  /* The wheel zooms about the pointer; with Shift, and on a touch pad, it moves the drawing. */
  #wheel(event) {
    event.preventDefault();
    const { deltaX, deltaY, deltaMode, ctrlKey, shiftKey } = event;
    const unit = deltaMode ? 20 : 1, isPad = !deltaMode && (deltaX !== 0 || Math.abs(deltaY) < 30);
    if (!ctrlKey && (shiftKey || isPad)) {
      const isTurned = shiftKey && deltaX === 0;
      this.pan(-unit * (isTurned ? deltaY : deltaX), isTurned ? 0 : -unit * deltaY);
    } else {
      this.zoomBy(Math.exp(-Math.max(-200, Math.min(200, unit * deltaY)) * (ctrlKey && isPad ? 0.01 : 0.002)), this.point(event));
    }
  }
}
