/* Plots that one can zoom and read off, of the numbers that a page carries; uPlot draws axes and grid, and finds places.
   Without this script, and in print, a page shows its SVG pictures. */
(() => {
  "use strict";
  const INK = "#1b1f24", GREY = "#6b7280", GRID = "#e6e8ec", FEW = 200, PAD = 0.05, ROW = 36;
  const isNarrow = () => innerWidth < 640;
  const make = (tag, kind, parent, text) => {
    const found = document.createElement(tag);
    if (kind) found.className = kind;
    if (text) found.textContent = text;
    return parent ? parent.appendChild(found) : found;
  };
  const unpacked = c => Array.isArray(c) ? c : Array.from({ length: c.count }, (_, k) => c.from + k * c.step);
  const isKnown = v => v !== null && v !== undefined;
  const faded = (colour, alpha) => colour + Math.round(255 * (alpha ?? 1)).toString(16).padStart(2, "0");

  /* A number with the digits that a range of `span` shows. */
  function shown(v, span) {
    if (!isKnown(v) || !isFinite(v)) return "-";
    const size = Math.max(Math.abs(v), Math.abs(span));
    if (size !== 0 && (size >= 1e6 || size < 1e-4)) return v.toPrecision(5);
    const digits = span > 0 ? Math.min(10, Math.max(0, Math.ceil(3.2 - Math.log10(span)))) : 4;
    return v.toFixed(digits);
  }

  /* Digits that a step between ticks has behind its point. */
  function decimals(step) {
    let found = 0;
    while (found < 10 && Math.abs(step * 10 ** found - Math.round(step * 10 ** found)) > 1e-6 * step * 10 ** found) found++;
    return found;
  }

  class Panel {
    constructor(figure, spec, columns) {
      Object.assign(this, { figure, spec });
      this.hidden = new Set();
      this.items = [...spec.boxes ?? [], ...spec.bands ?? [], ...spec.rules ?? [], ...spec.lines ?? []];
      for (const one of [...spec.lines ?? [], ...spec.bands ?? []])
        for (const key of ["x", "y", "low", "high"]) if (key in one) one[key] = columns[one[key]];
      for (const line of spec.lines ?? [])
        line.isOrdered = line.x.every((v, k) => !k || !isKnown(v) || !isKnown(line.x[k - 1]) || v >= line.x[k - 1]);
      this.box = make("div", "panel", figure.place);
      this.box.style.flexBasis = `calc(${(100 * spec.share).toFixed(2)}% - .8rem)`;
      this.box.style.setProperty("--place", figure.narrow.indexOf(spec));
      this.head = make("div", "keys", this.box);
      const { second } = spec.y;
      if (spec.title) make("span", "name", this.head, spec.title);
      if (spec.y.label) make("span", "unit", this.head, spec.y.label);
      // A telephone has no room for a second axis.
      if (second && isNarrow()) make("span", "at", this.head, `1 is ${shown(second.factor, second.factor)} ${second.label}`);
      this.at = make("span", "at", this.head);
      this.keys = new Map();
      this.buttons = new Map();
      for (const one of this.items) if (one.label && !this.keys.has(one.label)) this.addKey(one);
      this.plot = make("div", "", this.box);
      this.reset(false);
      this.u = new uPlot(this.options(), [[0, 1]], this.plot);
      this.scale();
      this.touch();
      new ResizeObserver(() => this.resize()).observe(this.box);
    }

    addKey(one) {
      const key = make("button", "key", this.head), swatch = make("i", one.axis || one.y && !one.marker && !one.high ? "line" : "", key);
      const area = one.area ?? one.alpha;
      key.type = "button";
      swatch.style.background = faded(one.colour, area && Math.min(2 * area, 1));
      if (one.dash) swatch.style.background =
        `repeating-linear-gradient(90deg, ${one.colour} 0 ${one.dash[0]}px, transparent 0 ${one.dash[0] + one.dash[1]}px)`;
      if (one.hatch) swatch.style.background =
        `repeating-linear-gradient(135deg, ${one.colour} 0 3px, #fff 0 5px)`;
      make("span", "", key, one.label);
      const value = one.y || one.low ? make("b", "", key) : null;
      key.setAttribute("aria-pressed", "true");
      key.onclick = () => {
        const off = !this.hidden.delete(one.label);
        if (off) this.hidden.add(one.label);
        key.setAttribute("aria-pressed", String(!off));
        this.u.redraw();
      };
      // A band is read as a line with two edges.
      this.keys.set(one.label, { value, line: one.low ? { ...one, y: one.low, isOrdered: true } : one });
      this.buttons.set(one.label, key);
    }

    isShown(one) { return !this.hidden.has(one.label); }

    /* --- Ranges --- */

    reset(draws = true) {
      const { x, y } = this.spec;
      this.view = { x: [...x.range], y: [...y.range] };
      this.isWhole = true;
      if (draws) this.scale();
    }

    scale() {
      const { x, y } = this.view;
      this.u.batch(() => {
        this.u.setScale("x", { min: Math.min(...x), max: Math.max(...x) });
        this.u.setScale("y", { min: Math.min(...y), max: Math.max(...y) });
      });
    }

    /* What is seen, and its heights where none are given: those of the visible lines within it. */
    look(x, y) {
      this.isWhole = false;
      this.view.x = x;
      this.view.y = y ?? (this.spec.rows ? this.view.y : this.heights(x) ?? this.view.y);
      this.scale();
    }

    heights([from, to]) {
      let low = Infinity, high = -Infinity;
      const take = v => { if (isKnown(v) && isFinite(v)) { low = Math.min(low, v); high = Math.max(high, v); } };
      for (const line of this.spec.lines ?? []) {
        if (!this.isShown(line)) continue;
        const { x } = line;
        for (const y of line.high ? [line.y, line.high] : [line.y]) {
          for (let k = 0; k < x.length; k++) if (x[k] >= from && x[k] <= to) take(y[k]);
          if (line.isOrdered && !line.marker) for (const end of [from, to]) take(this.along(line, end, y));
        }
      }
      if (low > high) return null;
      if (this.spec.y.log) return [low / 1.1, high * 1.1];
      const pad = PAD * (high - low) || PAD * Math.abs(high) || 1;
      return [low - pad, high + pad];
    }

    /* The value of a line at a place. */
    along(line, at, y = line.y) {
      const { x } = line;
      let a = 0, b = x.length - 1;
      if (b < 0 || !(at >= x[0] && at <= x[b])) return null;
      while (b - a > 1) { const m = (a + b) >> 1; if (x[m] <= at) a = m; else b = m; }
      if (at === x[b]) return y[b];
      if (line.step || !isKnown(y[a]) || !isKnown(y[b]) || x[a] === x[b]) return y[a];
      return y[a] + (y[b] - y[a]) * (at - x[a]) / (x[b] - x[a]);
    }

    /* The drawn point next to the pointer. */
    nearest(line, left, top) {
      let best = -1, least = Infinity;
      for (let k = 0; k < line.x.length; k++) {
        if (!isKnown(line.x[k]) || !isKnown(line.y[k])) continue;
        const dx = this.u.valToPos(line.x[k], "x") - left;
        const dy = line.isOrdered ? 0 : this.u.valToPos(line.y[k], "y") - top;
        const d = dx * dx + dy * dy;
        if (d < least) { least = d; best = k; }
      }
      return best;
    }

    /* --- uPlot --- */

    height() {
      if (this.spec.rows) return ROW * this.spec.rows.length + (this.spec.x.silent ? 12 : 56);
      const high = 88 * this.spec.box[3] + (this.spec.x.silent ? 20 : 50);
      return Math.max(150, isNarrow() ? Math.min(high, 250) : high);
    }

    resize() {
      const width = this.box.clientWidth;
      if (width > 0 && (width !== this.u.width || this.height() !== this.u.height))
        this.u.setSize({ width, height: this.height() });
    }

    axis(side, own, scale) {
      // What stands upright on paper stands above the panel here.
      const label = side === 3 ? "" : own.label || "", span = () => this.view[scale][1] - this.view[scale][0];
      const found = {
        side, scale: own.factor ? "y2" : scale, stroke: INK, font: "12px system-ui, sans-serif",
        labelFont: "12px system-ui, sans-serif", labelSize: label ? 18 : 0, labelGap: 0, gap: 3,
        label: own.silent ? "" : label, size: side % 2 ? this.widthOf(own) : own.silent ? 8 : 26,
        space: side % 2 ? 28 : 54, ticks: { stroke: GRID, size: 5, width: 1 }, grid: { stroke: GRID, width: 1, show: !own.factor },
        border: { show: true, stroke: GREY, width: 1 },
      };
      if (own.silent) found.values = (u, splits) => splits.map(() => "");
      if (own.ticks) {
        const [places, names] = own.ticks;
        found.splits = (u, k, min, max) => places.filter(v => v >= min && v <= max);
        found.values = (u, splits) => splits.map(v => names[places.indexOf(v)]);
      } else if (own.log) found.values = (u, splits) => splits.map(v => v === null ? "" : String(+v.toPrecision(6)));
      else if (!own.silent)
        found.values = (u, splits, k, space, step) => splits.map(v => span() >= 1e6 || Math.abs(v) >= 1e6
          ? v.toPrecision(3) : v.toFixed(decimals(step)));
      return found;
    }

    /* Room for the numbers of the vertical axes; panels of one time axis lie exactly below each other. */
    widthOf(own) {
      if (own.factor) return 52;
      const names = this.figure.alike(this.spec).flatMap(one => {
        if (one.y.ticks || one.y.log) return one.y.ticks && !one.rows ? one.y.ticks[1] : [];
        const [low, high] = one.y.range, digits = Math.ceil(0.7 - Math.log10(Math.abs(high - low)));
        return [low, high].map(v => v.toFixed(Math.min(10, Math.max(0, digits || 0))));
      });
      return Math.min(110, Math.max(42, ...names.map(t => 7 * t.length + 10)));
    }

    options() {
      const { x, y } = this.spec, distr = own => own.log ? 3 : 1;
      const axes = [this.axis(2, x, "x"), this.axis(3, y, "y")];
      const scales = {
        x: { time: false, distr: distr(x), range: () => this.view.x },
        y: { auto: false, distr: distr(y), dir: y.range[0] > y.range[1] ? -1 : 1,
             range: () => [Math.min(...this.view.y), Math.max(...this.view.y)] },
      };
      const isWide = !isNarrow(), hasSecond = isWide && this.figure.alike(this.spec).some(one => one.y.second);
      if (this.spec.rows) axes[1] = {
        ...axes[1], size: axes[1].size, label: "", labelSize: 0, values: () => [], grid: { show: false },
        ticks: { show: false }, border: { show: false },
      };
      if (y.second && isWide) {
        scales.y2 = { from: "y", range: (u, a, b) => [a * y.second.factor, b * y.second.factor] };
        axes.push(this.axis(1, y.second, "y"));
      }
      return {
        width: Math.max(this.box.clientWidth, 200), height: this.height(), series: [{}], scales, axes,
        legend: { show: false }, padding: [8, !hasSecond ? 12 : y.second ? 0 : 70, 0, 0],
        cursor: { y: !this.figure.isShared(this), points: { show: false },
                  drag: { x: true, y: true, uni: 24, setScale: false }, bind: { dblclick: () => () => this.figure.whole(this) } },
        hooks: {
          draw: [u => this.paint(u)],
          setSelect: [u => this.selected(u)],
          setCursor: [u => this.figure.pointed(this)],
        },
      };
    }

    selected(u) {
      const { left, top, width, height } = u.select;
      if (width < 4 && height < 4) return;
      const over = u.over, x = [left, left + width].map(v => u.posToVal(v, "x"));
      const isAcross = width >= 4, isUp = height >= 4 && height < over.clientHeight - 1;
      const y = isUp ? [top + height, top].map(v => u.posToVal(v, "y")) : null;
      u.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false);
      this.figure.zoom(this, isAcross && width < over.clientWidth - 1 ? x : this.view.x, y);
    }

    /* --- Fingers: two spread and shift, one shifts what is enlarged and else reads off --- */

    touch() {
      const over = this.u.over, fingers = new Map();
      const value = left => this.u.posToVal(left, "x");
      const to = v => this.spec.x.log ? Math.log(v) : v, back = v => this.spec.x.log ? Math.exp(v) : v;
      let start = null;
      const place = e => e.clientX - over.getBoundingClientRect().left;
      const begin = () => { start = [...fingers.values()].map(f => ({ ...f, v: to(value(f.now)) })); };
      over.addEventListener("pointerdown", e => {
        if (e.pointerType !== "touch") return;
        fingers.set(e.pointerId, { first: place(e), now: place(e) });
        over.setPointerCapture(e.pointerId);
        begin();
      });
      over.addEventListener("pointermove", e => {
        const finger = fingers.get(e.pointerId);
        if (!finger) return;
        finger.now = place(e);
        const wide = over.clientWidth, now = [...fingers.values()];
        if (now.length === 1 && this.isWhole) {
          this.u.setCursor({ left: finger.now, top: e.clientY - over.getBoundingClientRect().top });
          return;
        }
        const [a, b] = start, p = now[0].now, [low, high] = this.view.x.map(to);
        let size = high - low;
        if (b && Math.abs(now[1].now - p) > 10) size = Math.abs((b.v - a.v) / (now[1].now - p)) * wide;
        const whole = this.spec.x.range.map(to), most = whole[1] - whole[0];
        if (size >= most) { this.figure.whole(this); return; }
        const from = Math.min(Math.max(a.v - p / wide * size, whole[0]), whole[1] - size);
        this.figure.zoom(this, [back(from), back(from + size)], null);
      });
      let last = -1e9, isTap = true;
      const lift = e => {
        const finger = fingers.get(e.pointerId);
        if (!fingers.delete(e.pointerId)) return;
        isTap = isTap && !fingers.size && e.type === "pointerup" && Math.abs(finger.now - finger.first) < 10;
        if (isTap && e.timeStamp - last < 350) this.figure.whole(this);
        last = isTap ? e.timeStamp : -1e9;
        if (fingers.size) begin();
        isTap = !fingers.size;
      };
      for (const name of ["pointerup", "pointercancel"]) over.addEventListener(name, lift);
    }

    /* --- Reading off --- */

    read() {
      const { left, top } = this.u.cursor, isOff = !(left >= 0), span = v => Math.abs(v[1] - v[0]);
      const at = isOff ? null : this.u.posToVal(left, "x");
      this.at.textContent = isOff ? "" : `${this.figure.nameOf(this)} ${shown(at, span(this.view.x))}`;
      for (const { value } of this.keys.values()) if (value) value.textContent = "";
      if (isOff) return;
      if (this.spec.rows) { this.at.textContent += `: ${this.states(at)}`; return; }
      for (const { value, line } of this.keys.values()) {
        if (!value || !this.isShown(line)) continue;
        if (line.isOrdered && !line.marker) {
          const values = [line.y, line.high].filter(Boolean).map(y => shown(this.along(line, at, y), span(this.view.y)));
          value.textContent = [...new Set(values)].join(" to ");
        }
        else {
          const k = this.nearest(line, left, top);
          if (k >= 0) value.textContent = `${shown(line.y[k], span(this.view.y))} at ${shown(line.x[k], span(this.view.x))}`;
        }
      }
    }

    states(at) {
      return this.spec.rows.map(([row, name]) => {
        const own = (this.spec.boxes ?? []).find(({ at: c }) => {
          for (let k = 0; k < c.length; k += 4)
            if (c[k] <= at && at < c[k + 2] && Math.min(c[k + 1], c[k + 3]) <= row && row <= Math.max(c[k + 1], c[k + 3])) return true;
          return false;
        });
        return `${name} ${own?.label ?? "-"}`;
      }).join("; ");
    }

    isCoarse() {
      const [from, to] = this.view.x;
      return !this.isWhole && (this.spec.lines ?? []).some(line => line.of && this.isShown(line)
        && line.x.reduce((n, v) => n + (v >= from && v <= to), 0) < FEW);
    }

    /* --- Drawing --- */

    /* From values to places on the canvas; straight scales without asking uPlot for each value. */
    placing(scale) {
      const { min, max } = this.u.scales[scale], at = v => this.u.valToPos(v, scale, true);
      if (this.spec[scale].log || !(max > min)) return at;
      const begin = at(min), slope = (at(max) - begin) / (max - min);
      return v => begin + slope * (v - min);
    }

    paint(u) {
      const { ctx, bbox } = u, dpr = devicePixelRatio || 1;
      const X = this.placing("x"), Y = this.placing("y");
      ctx.save();
      ctx.beginPath();
      ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
      ctx.clip();
      ctx.lineJoin = "round";
      for (const one of this.spec.boxes ?? []) if (this.isShown(one)) this.paintBoxes(ctx, bbox, one, X, Y, dpr);
      for (const band of this.spec.bands ?? []) if (this.isShown(band)) {
        ctx.fillStyle = faded(band.colour, band.alpha);
        ctx.beginPath();
        band.x.forEach((v, k) => ctx.lineTo(X(v), Y(band.low[k])));
        for (let k = band.x.length - 1; k >= 0; k--) ctx.lineTo(X(band.x[k]), Y(band.high[k]));
        ctx.fill();
      }
      for (const rule of this.spec.rules ?? []) if (this.isShown(rule)) {
        this.pen(ctx, rule, dpr);
        ctx.beginPath();
        if (rule.axis === "x") { ctx.moveTo(X(rule.at), bbox.top); ctx.lineTo(X(rule.at), bbox.top + bbox.height); }
        else { ctx.moveTo(bbox.left, Y(rule.at)); ctx.lineTo(bbox.left + bbox.width, Y(rule.at)); }
        ctx.stroke();
      }
      for (const one of this.spec.segments ?? []) {
        this.pen(ctx, one, dpr);
        ctx.beginPath();
        for (let k = 0; k < one.at.length; k += 4) {
          ctx.moveTo(X(one.at[k]), Y(one.at[k + 1]));
          ctx.lineTo(X(one.at[k + 2]), Y(one.at[k + 3]));
        }
        ctx.stroke();
      }
      for (const line of this.spec.lines ?? []) if (this.isShown(line)) this.paintLine(ctx, line, X, Y, dpr);
      ctx.setLineDash([]);
      this.paintTexts(ctx, X, Y, dpr, bbox);
      ctx.restore();
    }

    pen(ctx, one, dpr) {
      ctx.strokeStyle = faded(one.colour, one.alpha);
      ctx.lineWidth = 1.3 * dpr * (one.width ?? 1);
      ctx.setLineDash((one.dash ?? []).map(v => v * dpr));
    }

    paintBoxes(ctx, bbox, one, X, Y, dpr) {
      const { at } = one, right = bbox.left + bbox.width, foot = bbox.top + bbox.height;
      for (let k = 0; k < at.length; k += 4) {
        const a = isKnown(at[k]) ? X(at[k]) : bbox.left, c = isKnown(at[k + 2]) ? X(at[k + 2]) : right;
        const b = isKnown(at[k + 1]) ? Y(at[k + 1]) : foot, d = isKnown(at[k + 3]) ? Y(at[k + 3]) : bbox.top;
        const left = Math.max(Math.min(a, c), bbox.left), wide = Math.min(Math.max(a, c), right) - left;
        // In a row the lower half, under its name.
        const top = this.spec.rows ? (b + d) / 2 + 1 * dpr : Math.min(b, d), high = this.spec.rows ? .38 * ROW * dpr : Math.abs(d - b);
        if (wide <= 0) continue;
        ctx.fillStyle = faded(one.colour, one.alpha);
        ctx.fillRect(left, top, wide, high);
        if (!one.hatch) continue;
        ctx.save();
        ctx.beginPath();
        ctx.rect(left, top, wide, high);
        ctx.clip();
        ctx.strokeStyle = "#fff";
        ctx.lineWidth = dpr;
        ctx.beginPath();
        for (let s = Math.floor((left - high) / 6 / dpr) * 6 * dpr; s < left + wide; s += 6 * dpr) {
          ctx.moveTo(s, top + high);
          ctx.lineTo(s + high, top);
        }
        ctx.stroke();
        ctx.restore();
      }
    }

    /* The way of a line. Points within a fifth of a picture element of the way between others are left out: strokes of a
       thousand points are most of the work of a drawing. */
    lead(ctx, { x, y, step }, X, Y) {
      let ax, ay, bx, by, low, high;  // the point drawn last, the one passed last, and slopes from the first that pass all since
      const to = (px, py) => {
        const slope = (py - ay) / (px - ax);
        if (!(px > ax && slope >= low && slope <= high)) {
          ctx.lineTo(bx, by);
          [ax, ay, low, high] = [bx, by, -Infinity, Infinity];
        }
        const dx = px - ax;
        low = dx > 0 ? Math.max(low, (py - ay - .2) / dx) : Infinity;
        high = Math.min(high, (py - ay + .2) / dx);
        bx = px;
        by = py;
      };
      let isDown = false;
      for (let k = 0; k <= x.length; k++) {
        if (k === x.length || !isKnown(x[k]) || !isKnown(y[k])) { if (isDown) ctx.lineTo(bx, by); isDown = false; continue; }
        const px = X(x[k]), py = Y(y[k]);
        if (isDown) { if (step) to(px, by); to(px, py); }
        else { ctx.moveTo(px, py); [ax, ay, bx, by, low, high] = [px, py, px, py, -Infinity, Infinity]; }
        isDown = true;
      }
    }

    /* The area between both edges of a line, such as that of the cells of a tube. */
    paintArea(ctx, line, X, Y) {
      const edge = [], put = (x, y) => edge.push([x, y]);
      ctx.fillStyle = faded(line.colour, line.area);
      ctx.beginPath();
      this.lead(ctx, line, X, Y);
      this.lead({ moveTo: put, lineTo: put }, { ...line, y: line.high }, X, Y);
      for (const [x, y] of edge.reverse()) ctx.lineTo(x, y);
      ctx.fill();
    }

    paintLine(ctx, line, X, Y, dpr) {
      const { x, y, high } = line;
      if (high) this.paintArea(ctx, line, X, Y);
      this.pen(ctx, line, dpr);
      if (line.width) {
        ctx.beginPath();
        this.lead(ctx, line, X, Y);
        if (high) this.lead(ctx, { ...line, y: high }, X, Y);
        ctx.stroke();
      }
      if (!line.marker) return;
      ctx.setLineDash([]);
      ctx.lineWidth = 1.2 * dpr;
      const r = Math.max(1.5, 0.62 * line.size) * dpr;
      for (let k = 0; k < x.length; k++) {
        if (!isKnown(x[k]) || !isKnown(y[k])) continue;
        const px = X(x[k]), py = Y(y[k]);
        ctx.beginPath();
        if (line.marker === "+") { ctx.moveTo(px - r, py); ctx.lineTo(px + r, py); ctx.moveTo(px, py - r); ctx.lineTo(px, py + r); }
        else ctx.arc(px, py, r, 0, 7);
        if (line.fill && line.marker !== "+") { ctx.fillStyle = faded(line.fill, line.alpha); ctx.fill(); }
        if (line.marker === "+" || line.edge) { ctx.strokeStyle = faded(line.edge ?? line.colour, line.alpha); ctx.stroke(); }
      }
    }

    paintTexts(ctx, X, Y, dpr, bbox) {
      ctx.font = `${11 * dpr}px system-ui, sans-serif`;
      for (const [x, y, text, colour, across, up] of this.spec.texts ?? []) {
        ctx.fillStyle = colour;
        ctx.textAlign = across;
        ctx.textBaseline = up;
        const rows = text.split("\n"), wide = Math.max(...rows.map(row => ctx.measureText(row).width));
        // Where there is little room, a text moves to the left before it is cut.
        const ahead = across === "left" ? Math.max(0, X(x) + wide - bbox.left - bbox.width) : 0;
        rows.forEach((row, k) => ctx.fillText(row, X(x) - ahead, Y(y) + 13 * k * dpr));
      }
      ctx.textAlign = "left";
      ctx.textBaseline = "bottom";
      ctx.fillStyle = INK;
      for (const [row, name] of this.spec.rows ?? []) ctx.fillText(name, bbox.left, Y(row));
    }
  }

  class Figure {
    constructor(element, data) {
      this.place = make("div", "live");
      this.panels = [];
      element.prepend(this.place);
      this.place.setAttribute("role", "group");
      this.place.setAttribute("aria-label", (element.querySelector("svg") ?? element).getAttribute("aria-label"));
      const columns = data.columns.map(unpacked);
      this.specs = data.panels;
      // Below each other come first the panels of one column.
      this.narrow = [...data.panels].sort((a, b) => a.box[0] - b.box[0] || a.box[1] - b.box[1]);
      for (const spec of data.panels) this.panels.push(new Panel(this, spec, columns));
      for (const note of data.notes ?? []) make("p", "notes", this.place, note);
      const foot = make("p", "foot", this.place);
      this.hint = make("span", "", foot, matchMedia("(pointer: coarse)").matches
        ? "Two fingers enlarge; a finger reads off, or shifts what is enlarged." : "Drag to enlarge; double click for the whole.");
      this.back = make("button", "", foot, "Show the whole");
      this.back.type = "button";
      this.back.hidden = true;
      this.back.onclick = () => this.panels.forEach(panel => panel.reset()) || this.told();
      this.coarse = make("strong", "", foot);
    }

    alike(spec) { return this.specs.filter(one => one.group === spec.group && one.box[0] === spec.box[0]); }
    siblings(panel) { return this.panels.filter(one => one.spec.group === panel.spec.group); }
    isShared(panel) { return this.specs.filter(one => one.group === panel.spec.group).length > 1; }
    /* What the horizontal axis is called, and its unit. */
    nameOf(panel) { return this.siblings(panel).map(one => one.spec.x.label).filter(Boolean).pop() || "x"; }

    zoom(panel, x, y) {
      if (!(x[1] > x[0])) return;
      for (const one of this.siblings(panel)) one.look([...x], one === panel ? y : null);
      this.told();
    }

    whole(panel) {
      this.siblings(panel).forEach(one => one.reset());
      this.told();
    }

    told() {
      this.back.hidden = this.panels.every(one => one.isWhole);
      const line = this.panels.filter(one => one.isCoarse()).flatMap(one => one.spec.lines).find(one => one.of);
      this.coarse.textContent = line
        ? ` Finer than this page holds: ${line.x.length} of ${line.of} samples, the lowest and highest of each stretch.` : "";
    }

    pointed(panel) {
      if (this.isBusy) return;
      this.isBusy = true;
      const { left } = panel.u.cursor;
      const at = left >= 0 ? panel.u.posToVal(left, "x") : null;
      panel.read();
      for (const one of this.siblings(panel)) if (one !== panel) {
        one.u.setCursor({ left: at === null ? -10 : one.u.valToPos(at, "x"), top: at === null ? -10 : 0 }, false);
        one.read();
      }
      this.isBusy = false;
    }
  }

  for (const script of document.querySelectorAll("script.plot-data")) {
    const figure = script.closest("figure");
    try {
      figure.plot = new Figure(figure, JSON.parse(script.textContent));
      figure.classList.add("is-live");
    } catch (problem) {
      figure.querySelector(".live")?.remove();
      console.error(problem);
    }
  }
})();
