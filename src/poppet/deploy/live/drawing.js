/* Smallest and largest value of curves at each time. */
function edgesOf([first, ...others]) {
  const low = Array.from(first), high = [...low];
  for (const curve of others) for (let k = 0; k < low.length; k++) {
    const v = curve[k];
    if (v === null) continue;
    if (low[k] === null || v < low[k]) low[k] = v;
    if (high[k] === null || v > high[k]) high[k] = v;
  }
  return [low, high];
}

/* Drawing of a page: the schematic, with values and moving bodies of its parts. */
class PageDrawing {
  /* `place` is the element of the drawing, and `drawing` and `outputs` are data of the page. */
  constructor(place, drawing, outputs) {
    this.outputs = outputs;
    place.innerHTML = drawing.svg;
    this.svg = place.querySelector("svg");
    this.values = drawing.values.map(item => {
      const text = this.shape("text", { x: item.x, y: item.y + 2.7, "text-anchor": "middle", "font-size": 7.5, fill: "#1f5fa8",
                                        "font-family": "system-ui, sans-serif", "font-weight": 600 });
      this.shape("title", {}, text).textContent = outputs[item.output].address;
      return { ...item, text, node: text.appendChild(document.createTextNode("")) };
    });
    this.movers = drawing.movers.map(mover => ({ ...mover, ...this.body(mover) }));
    this.captions = [...this.svg.querySelectorAll('[id^="circuit-caption."]')];
  }

  /* Dim the parameters of some parts: they are those of the file, and a slider has changed one of them. */
  dim(parts) {
    for (const caption of this.captions) caption.classList.toggle("is-past", parts.has(caption.id.split(".")[1]));
  }

  shape(tag, look, parent = this.svg) {
    const element = document.createElementNS("http://www.w3.org/2000/svg", tag);
    for (const name in look) element.setAttribute(name, look[name]);
    return parent.appendChild(element);
  }

  /* A body at rest; `to` moves it to a fraction of its travel, or to an angle. */
  body({ kind, x, y, width, height }) {
    const ink = { fill: "none", stroke: "#1b1f24", "stroke-width": 1 }, solid = { fill: "#c2410c", stroke: "#1b1f24", "stroke-width": .8 };
    const left = x - width / 2, top = y - height / 2, moved = this.shape("g", { class: "mover" });
    if (kind === "lever") {
      this.shape("circle", { cx: x, cy: y, r: 2, fill: "#1b1f24" });
      this.shape("line", { x1: x, y1: y, x2: x + height * .8, y2: y, stroke: "#c2410c", "stroke-width": 2.4, "stroke-linecap": "round" }, moved);
      return { moved, to: (share, angle) => moved.setAttribute("transform", `rotate(${-angle * 180 / Math.PI} ${x} ${y})`) };
    }
    const travel = kind === "poppet" ? width * .35 : width * .62;
    if (kind === "poppet") {
      this.shape("path", { d: `M${left} ${top} h${width * .35} v${height * .28} M${left} ${top + height} h${width * .35} v${-height * .28}`, ...ink });
      const seat = left + width * .35;
      this.shape("path", { d: `M${seat - 5} ${y} L${seat + 1} ${top} V${top + height} Z M${seat + 1} ${y} h${width * .25}`, ...solid }, moved);
    } else {
      this.shape("rect", { x: left, y: top, width: width * .72, height, ...ink });
      this.shape("path", { d: `M${left + 1} ${top + .6} h5 v${height - 1.2} h-5 Z M${left + 6} ${y} h${width * .66}`, ...solid }, moved);
    }
    return { moved, to: share => moved.setAttribute("transform", `translate(${(share * travel).toFixed(2)} 0)`) };
  }

  /* Show values: `valueOf` returns the SI value of an output, and `rangeOf` its range if a body has no end stops. */
  show(valueOf, rangeOf) {
    for (const { output, sign, node } of this.values) {
      const { unit, factor, shift } = this.outputs[output];
      const words = `${sign} ${fiveDigits(valueOf(output) * factor + shift)} ${unit.replace("deg", "°")}`;
      if (node.data !== words) node.data = words;
    }
    for (const mover of this.movers) {
      const [low, high] = mover.stops ?? rangeOf(mover.output), value = valueOf(mover.output);
      mover.to(high > low ? Math.min(1, Math.max(0, (value - low) / (high - low))) : 0, value);
    }
  }
}

const fiveDigits = value => Number.isFinite(value) ? String(+value.toPrecision(5)) : "-";
