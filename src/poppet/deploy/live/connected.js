/* Connected mode of a page: values, inputs and faults of a circuit that `poppet serve` runs. Names of a circuit go into
   the page as text only. */
const WINDOWS = [10, 60, 600];  // durations of the curves that the user can select [s]
const MAX_SAMPLES = 6000;  // of a curve; more frequent values are shown, but not kept
const MAX_EVENTS = 50;
const REDRAW = 66;  // shortest time between two drawings of the curves [ms]
const WRITE = 50;  // shortest time between two messages with inputs [ms]
const QUIET = 400;  // time after a change of an input in which the values of the server do not replace it [ms]
const SIGMAS = 2;  // half-width of the bands of estimates
const STATES = { starting: "Starting", running: "Running", failed: "Failed", stopped: "Stopped" };

/* Server and token in the fragment of an address, `#connect=ws://127.0.0.1:8030&token=...`; null without a server. */
function connectionOf(fragment) {
  const words = new URLSearchParams(fragment.slice(1)), server = words.get("connect");
  return server ? { server: server.replace(/\/+$/, ""), token: words.get("token") ?? "" } : null;
}

function pageElement(tag, parent, look = {}, text) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(look)) name === "className" ? element.className = value : element.setAttribute(name, value);
  if (text !== undefined) element.textContent = text;
  return parent ? parent.appendChild(element) : element;
}

/* Set the text of an element only if it changes, so screen readers do not repeat it. */
function setText(element, text) {
  if (element.textContent !== text) element.textContent = text;
}

/* Name of a part or an input with places for line breaks. */
function breakable(parent, name) {
  for (const word of name.split(/(?<=[._])/)) { parent.append(word); pageElement("wbr", parent); }
}

const numberOfText = text => { const plain = text.trim().replace(",", "."); return plain === "" ? NaN : Number(plain); };

/* A value with the half-width of its band, which determines the digits. */
function withBand(value, band) {
  const decimals = Math.min(12, Math.max(0, 1 - Math.floor(Math.log10(band > 0 ? band : 1e-12))));
  return `${value.toFixed(decimals)} ± ${band.toFixed(decimals)}`;
}

/* Rows of a message: times, and values of the series that have changed. */
function rowsOf(buffer) {
  const [nRows, nSeries, lost] = new Uint32Array(buffer, 0, 3), places = 16 + 4 * nSeries, first = places + places % 8;
  const series = new Uint32Array(buffer, 16, nSeries), time = new Float64Array(buffer, first, nRows);
  return { lost, series, time, values: new Float32Array(buffer, first + 8 * nRows, nRows * nSeries) };
}

/* Curves in a window of time that moves with the machine. */
class RollingWindow {
  constructor(duration) {
    Object.assign(this, { duration, time: [], series: new Map(), now: new Map(), last: -Infinity });
  }

  clear() {
    this.time.length = 0;
    for (const values of this.series.values()) values.length = 0;
    this.now.clear();
    this.last = -Infinity;
  }

  /* Values of a curve, in the order of `time`. */
  curve(column) {
    if (!this.series.has(column)) this.series.set(column, this.time.map(() => null));
    return this.series.get(column);
  }

  /* Add the rows of a message. Series that are not in it are constant. */
  add({ series, time, values }) {
    const n = time.length;
    if (n && time[0] < this.last) this.clear();
    for (let row = 0; row < n; row++) {
      series.forEach((column, k) => this.now.set(column, values[k * n + row]));
      if (time[row] - this.last < this.duration / MAX_SAMPLES) continue;
      this.last = time[row];
      this.time.push(time[row]);
      for (const [column, kept] of this.series) kept.push(this.now.get(column) ?? null);
    }
    // Curves become shorter in large pieces, because each one moves all values.
    const begin = this.last - this.duration, old = this.time.findIndex(t => t >= begin);
    if (old > MAX_SAMPLES / 10) for (const list of [this.time, ...this.series.values()]) list.splice(0, old);
  }
}

class ConnectedPage {
  /* `content` is the data of the page, and `target` the result of `connectionOf`. */
  constructor(content, target) {
    Object.assign(this, { content, target, rows: [], waiting: new Map(), numbers: 0, delay: 500, lost: 0, written: 0 });
    this.outputs = content.outputs;
    this.timeSize = content.time[1];
    document.body.classList.add("is-connected");
    for (const name of ["clock", "reset"]) document.getElementById(name)?.closest(".clock, .buttons")?.remove();
    this.drawing = new PageDrawing(document.getElementById("drawing"), content.drawing, this.outputs);
    const caption = document.querySelector(".sketch figcaption");
    if (caption) caption.textContent = "Values in blue are the present ones.";
    this.window = new RollingWindow(WINDOWS[1]);
    this.watched = { time: [], faults: new Map() };
    this.makePanels();
    this.makeControls();
    this.connect();
    globalThis.connected = this;
  }

  /* --- Parts of the page --- */

  makePanels() {
    this.plot = document.getElementById("curves").plot;
    this.away = new Set();
    for (const panel of this.plot.panels) {
      const { spec } = panel, kept = (spec.lines ?? []).filter(line => line.isKept);
      if (spec.rows) {
        // Only the axis of time remains of the bars.
        for (const box of spec.boxes) { box.at = []; panel.buttons.get(box.label).hidden = true; }
        Object.assign(spec, { rows: [], boxes: [] });
        spec.y.range = [0, 1];
      } else panel.box.hidden = !spec.lines.length;
      for (const line of kept) panel.buttons.get(line.label)?.remove();
      spec.lines = (spec.lines ?? []).filter(line => !line.isKept);
      for (const line of spec.lines) this.prepare(line);
      const band = new Map((spec.bands ?? []).map(one => [one.fault, one]));
      for (const line of spec.lines) if ("fault" in line) this.watched.faults.set(line.fault, { line, band: band.get(line.fault) });
      new IntersectionObserver(seen => {
        if (!seen[seen.length - 1].isIntersecting) this.away.add(panel);
        else if (this.away.delete(panel)) this.later();
      }, { rootMargin: "100px" }).observe(panel.box);
    }
    for (const { line, band } of this.watched.faults.values()) {
      Object.assign(line, { x: this.watched.time, y: [], isOrdered: true });
      if (band) Object.assign(band, { label: line.label, x: this.watched.time, low: [], high: [] });
    }
  }

  /* A line whose values follow; they are assigned when the columns of the machine are known. */
  prepare(line) {
    Object.assign(line, { x: [], y: [], isOrdered: true });
    if (line.cells) line.high = [];
  }

  makeControls() {
    const place = document.querySelector(".controls");
    place.replaceChildren();
    place.setAttribute("aria-label", "Machine");
    this.link = pageElement("p", place, { className: "link", role: "status" });
    this.state = pageElement("p", place, { className: "state", role: "status" });
    this.facts = pageElement("dl", place, { className: "facts" });
    this.told = pageElement("p", place, { className: "lead small", role: "alert" });
    this.watch = pageElement("div", place, { className: "condition" });
    this.watch.hidden = true;
    this.group = pageElement("fieldset", place, { className: "group", disabled: "" });
    pageElement("legend", this.group, { className: "hidden-words" }, "Inputs and faults");
    this.sliders = pageElement("div", this.group, { id: "inputs" });
    this.faults = pageElement("div", this.group, { id: "faults" });
    this.makeView(pageElement("div", place, { className: "view" }));
    document.getElementById("status")?.remove();
    document.getElementById("measured")?.remove();
  }

  /* Selection of the window, and of further curves. */
  makeView(place) {
    pageElement("h3", place, {}, "Curves");
    const windows = pageElement("select", pageElement("label", place, {}, "Last "), { "aria-label": "duration of the curves" });
    for (const seconds of WINDOWS) windows.add(new Option(seconds < 60 ? `${seconds} s` : `${seconds / 60} min`, seconds));
    windows.value = this.window.duration;
    windows.onchange = () => { this.window.duration = +windows.value; this.later(); };
    this.more = pageElement("select", pageElement("label", place, {}, "Add "), { "aria-label": "curve to add" });
    this.more.onchange = () => { this.addCurve(this.offers[this.more.value]); };
    this.listCurves();
  }

  /* Panel for the curves of a unit; it has a line, or the unit in its data. */
  panelOf(unit) {
    return this.plot.panels.find(({ spec }) => !spec.rows && (spec.unit ?? this.outputs[spec.lines[0]?.output]?.unit) === unit);
  }

  listCurves() {
    const key = ({ output, cells }) => String(cells ?? output);
    const shown = new Set(this.plot.panels.flatMap(panel => panel.spec.lines.map(key)));
    const lines = [...this.content.tubes ?? [], ...this.outputs.map(({ address }, output) => ({ label: address, output, width: 1.4 }))];
    this.offers = lines.filter(line => !shown.has(key(line)) && this.panelOf(this.outputs[line.output].unit));
    this.more.replaceChildren(new Option("a curve", ""), ...this.offers.map(({ label }, k) => new Option(label, k)));
    this.more.parentElement.hidden = !this.offers.length;
  }

  addCurve(offer) {
    const panel = this.panelOf(this.outputs[offer.output].unit), colours = ["#1f77b4", "#d62728", "#2ca02c", "#9467bd", "#8c564b", "#17becf"];
    const line = { ...offer, colour: colours[panel.spec.lines.length % colours.length] };
    this.prepare(line);
    panel.spec.lines.push(line);
    panel.addKey(line);
    panel.box.hidden = false;
    this.listCurves();
    this.subscribe();
    panel.resize();
  }

  /* --- Connection --- */

  connect() {
    const { server, token } = this.target;
    let socket;
    try { socket = new WebSocket(`${server}/live${token ? `?token=${encodeURIComponent(token)}` : ""}`); }
    catch (problem) { setText(this.link, `${server} is not an address of a server: ${problem.message}`); return; }
    socket.binaryType = "arraybuffer";
    this.socket = socket;
    setText(this.link, this.hello ? "Connection lost. Connecting again …" : `Connecting to ${server} …`);
    socket.onmessage = ({ data }) => typeof data === "string" ? this.message(JSON.parse(data)) : this.rowsArrived(rowsOf(data));
    socket.onclose = ({ code, reason }) => {
      this.group.disabled = true;
      document.body.classList.add("is-stale");
      const why = reason || (code === 1006 ? "If the server has been started again, open the address that it prints now." : "");
      setText(this.link, `No connection to ${server}. ${why} The page tries again.`);
      setTimeout(() => this.connect(), this.delay);
      this.delay = Math.min(5000, 1.6 * this.delay);
    };
  }

  send(content) {
    if (this.socket?.readyState === WebSocket.OPEN) this.socket.send(JSON.stringify(content));
  }

  message(content) {
    if (content.hello) this.greet(content.hello);
    else if (content.status) this.showStatus(content.status);
    else if (content.watch) this.showWatch(content.watch);
    else if ("reply" in content) this.answered(content);
  }

  /* First message of a server: its columns, inputs and faults. */
  greet(hello) {
    const isOther = this.hello && this.hello.start !== hello.start, same = this.hello && JSON.stringify([this.hello.inputs, this.hello.faults]) === JSON.stringify([hello.inputs, hello.faults]);
    this.hello = hello;
    this.delay = 500;
    this.group.disabled = false;
    document.body.classList.remove("is-stale");
    setText(this.link, `Connected to ${this.target.server}${hello.title && hello.title !== this.content.title ? `: ${hello.title}` : ""}`);
    const units = new Map(hello.columns);
    this.columns = this.outputs.map(({ address, si }) => {
      const k = hello.columns.findIndex(([name]) => name === address);
      return k >= 0 && (units.get(address) || "1") === (si || "1") ? k : -1;
    });
    const missing = this.outputs.filter((_, k) => this.columns[k] < 0).map(({ address }) => address);
    this.warn(missing.length ? `The served circuit does not have these outputs of the page: ${missing.slice(0, 5).join(", ")}${missing.length > 5 ? ", …" : ""}.` : "");
    if (isOther) { this.window.clear(); this.clearWatch(); this.event("The server was started again."); }
    if (!same) { this.makeInputs(hello.inputs); this.makeFaults(hello.faults); }
    this.makeWatch(hello.watch);
    this.subscribe();
    document.body.classList.add("is-ready");
  }

  warn(text) { setText(this.told, text); }

  /* Request the series that the page shows. */
  subscribe() {
    if (!this.columns) return;
    const used = new Set([...this.content.drawing.values, ...this.content.drawing.movers].map(item => item.output));
    for (const panel of this.plot.panels) for (const line of panel.spec.lines) {
      if (!("output" in line) || panel.spec.rows) continue;
      const shown = line.cells ?? [line.output], columns = shown.map(k => this.columns[k]).filter(column => column >= 0);
      for (const k of shown) used.add(k);
      if (columns.length) line.raw = columns.map(column => this.window.curve(column));
    }
    this.send({ series: [...used].map(k => this.columns[k]).filter(column => column >= 0) });
  }

  /* --- Inputs and faults --- */

  makeInputs(inputs) {
    this.sliders.replaceChildren();
    this.rows = inputs.map(input => input.is_flag ? this.makeSwitch(input) : this.makeSlider(input));
    if (inputs.length) this.sliders.prepend(pageElement("h3", null, {}, "Inputs"));
    else pageElement("p", this.sliders, { className: "lead small" }, "No input of this circuit can be written: signals or connections drive all of them.");
  }

  rowOf(input, kind) {
    const row = pageElement("div", this.sliders, { className: `row ${kind}` }), label = pageElement("label", row, { for: `n-${input.address}`, title: input.doc });
    breakable(label, input.address);
    return row;
  }

  /* Text of the error of a row; screen readers announce it. */
  explained(row, field, address) {
    const node = pageElement("span", row, { className: "why", id: `why-${address}`, role: "status" });
    field.setAttribute("aria-describedby", node.id);
    return text => {
      setText(node, text);
      if (text) field.setAttribute("aria-invalid", "true");
      else field.removeAttribute("aria-invalid");
    };
  }

  makeSwitch(input) {
    const row = this.rowOf(input, "is-flag"), box = pageElement("input", row, { type: "checkbox", role: "switch", id: `n-${input.address}` });
    const explain = this.explained(row, box, input.address);
    let quietUntil = 0;
    box.onchange = () => { quietUntil = performance.now() + QUIET; this.write(input.address, box.checked ? 1 : 0, explain); };
    return value => { if (performance.now() > quietUntil) box.checked = value >= .5; };
  }

  makeSlider(input) {
    const { address, factor, shift, unit, low, high, range: ends, initial } = input, row = this.rowOf(input, "");
    const out = v => v * factor + shift, back = v => (v - shift) / factor;
    const field = pageElement("input", row, { type: "text", id: `n-${address}`, inputmode: "decimal", autocomplete: "off" });
    pageElement("span", row, { className: "unit" }, unit);
    const reset = pageElement("button", row, { type: "button", title: "As at the start", "aria-label": `${address} as at the start` }, "↺");
    const range = ends && pageElement("input", row, { type: "range", min: out(ends[0]), max: out(ends[1]), step: "any", "aria-label": address });
    const explain = this.explained(row, field, address);
    const limits = [low === null ? "" : `at least ${fiveDigits(out(low))}`, high === null ? "" : `at most ${fiveDigits(out(high))}`].filter(Boolean).join(" and ");
    let quietUntil = 0, shown = NaN, isHeld = false;
    const give = (value, isExact) => {
      quietUntil = performance.now() + QUIET;
      shown = value;
      if (range) range.value = out(value);
      if (!isExact) field.value = fiveDigits(out(value));
      this.write(address, value, explain);
    };
    field.onchange = () => {
      const value = back(numberOfText(field.value));
      if (Number.isFinite(value) && value >= (low ?? -Infinity) && value <= (high ?? Infinity)) { give(value, true); return; }
      explain(`Enter a number${unit ? ` in ${unit}` : ""}${limits ? `, ${limits}` : ""}. ${fiveDigits(out(shown))} ${unit} stays in use.`);
    };
    field.oninput = () => explain("");
    if (range) {
      range.oninput = () => give(Math.min(high ?? Infinity, Math.max(low ?? -Infinity, back(+range.value))));
      range.onpointerdown = () => { isHeld = true; };
      range.onpointerup = range.onpointercancel = () => { isHeld = false; };
      range.onkeydown = event => {
        const way = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1, PageUp: 10, PageDown: -10 }[event.key];
        if (!way) return;
        event.preventDefault();
        range.value = +range.value + way * (out(ends[1]) - out(ends[0])) / 100;
        range.oninput();
      };
    }
    reset.onclick = () => give(initial);
    return value => {
      if (isHeld || performance.now() < quietUntil) return;
      reset.disabled = value === initial;
      if (value === shown && field.value) return;
      shown = value;
      if (range) range.value = out(value);
      if (document.activeElement !== field) field.value = fiveDigits(out(value));
    };
  }

  makeFaults(faults) {
    this.faults.replaceChildren();
    this.choices = new Map();
    const valves = Object.entries(faults);
    if (!valves.length) return;
    pageElement("h3", this.faults, {}, "Faults");
    this.summary = pageElement("p", this.faults, { className: "lead small", role: "status" });
    for (const [valve, words] of valves) {
      const row = pageElement("div", this.faults, { className: "row fault" }), label = pageElement("label", row, { for: `fault-${valve}` });
      breakable(label, valve);
      const choice = pageElement("select", row, { id: `fault-${valve}` });
      for (const word of ["none", ...words]) choice.add(new Option(word.replaceAll("_", " "), word));
      const explain = this.explained(row, choice, `fault-${valve}`);
      choice.onchange = () => this.ask({ fault: { [valve]: choice.value } }, explain);
      this.choices.set(valve, { row, choice });
    }
  }

  /* Send an input soon; later values of the same input replace it. */
  write(address, value, explain) {
    explain("");
    this.writes ??= new Map();
    this.writes.set(address, { value, explain });
    const wait = this.written + WRITE - performance.now();
    if (wait <= 0) this.flush();
    else this.timer ??= setTimeout(() => this.flush(), wait);
  }

  flush() {
    clearTimeout(this.timer);
    this.timer = undefined;
    this.written = performance.now();
    for (const [address, { value, explain }] of this.writes) this.ask({ set: { [address]: value } }, explain);
    this.writes.clear();
  }

  ask(content, explain) {
    this.waiting.set(++this.numbers, explain);
    this.send({ id: this.numbers, ...content });
  }

  answered({ reply, errors }) {
    const explain = this.waiting.get(reply), text = (errors ?? []).map(({ message, hint }) => `${message} ${hint}`).join(" ");
    this.waiting.delete(reply);
    if (explain) explain(text);
    else if (text) this.warn(text);
  }

  /* --- Values --- */

  rowsArrived(rows) {
    if (rows.time.length && rows.time[0] < this.window.last) this.clearWatch();
    this.window.add(rows);
    this.lost += rows.lost;
    this.now = rows.time.length ? rows.time[rows.time.length - 1] : this.now;
    this.drawing.show(k => this.valueOf(k), k => this.rangeOf(k));
    this.later();
  }

  /* Present value of an output in SI units. */
  valueOf(output) { return this.window.now.get(this.columns[output]) ?? NaN; }

  rangeOf(output) {
    let [low, high] = [Infinity, -Infinity];
    for (const v of this.window.series.get(this.columns[output]) ?? []) if (v !== null) { low = Math.min(low, v); high = Math.max(high, v); }
    return [low, high];
  }

  /* Draw the curves soon. */
  later() {
    if (this.isAsked) return;
    this.isAsked = true;
    setTimeout(() => requestAnimationFrame(() => { this.isAsked = false; this.drawCurves(); }), REDRAW);
  }

  drawCurves() {
    const size = this.timeSize, duration = this.window.duration / size, end = Math.max((this.now ?? 0) / size, duration);
    const time = this.window.time.map(t => t / size);
    for (const panel of this.plot.panels) {
      panel.spec.x.range = [end - duration, end];
      if (!this.away.has(panel)) this.scale(panel, time);
    }
  }

  /* Draw a visible panel. The curves of the others are not converted: there can be hundreds. */
  scale(panel, time) {
    for (const line of panel.spec.lines) {
      if (!line.raw) continue;
      const { factor, shift } = this.outputs[line.output];
      const [y, high] = (line.cells ? edgesOf(line.raw) : line.raw).map(curve => curve.map(v => v === null ? null : v * factor + shift));
      Object.assign(line, { x: time, y }, high && { high });
    }
    const range = panel.heights(panel.spec.x.range), { rules = [] } = panel.spec;
    if (range) panel.spec.y.range = [Math.min(range[0], ...rules.map(({ at }) => at - .2)), Math.max(range[1], ...rules.map(({ at }) => at + .2))];
    if (panel.isWhole) panel.reset();
    else panel.u.redraw(false);
    panel.read();
  }

  showStatus(status) {
    const { state, time, periods, late, latest, inputs, faults, note, clients } = status;
    setText(this.state, `${STATES[state] ?? state}${note ? `: ${note}` : ""}`);
    this.state.dataset.state = state;
    const { period, speed } = this.hello, facts = [
      ["time", `${time.toFixed(2)} s`], ["periods", `${periods} of ${fiveDigits(1000 * period)} ms${speed === 1 ? "" : `, speed ${speed ?? "without a clock"}`}`],
      ["late periods", `${late}${late ? `, the latest by ${(1000 * latest).toFixed(1)} ms` : ""}`], ["pages", String(clients)],
      ...this.lost ? [["rows left out", String(this.lost)]] : [],
    ];
    if (this.facts.children.length !== facts.length) {
      this.facts.replaceChildren();
      for (const [name] of facts) { const item = pageElement("div", this.facts); pageElement("dt", item, {}, name); pageElement("dd", item); }
    }
    facts.forEach(([, text], k) => setText(this.facts.children[k].lastChild, text));
    // The server sends them only if they have changed; while the user changes an input, its row ignores them.
    this.inputs = inputs ?? this.inputs;
    this.present = faults ?? this.present;
    this.rows.forEach((show, k) => show(this.inputs[k]));
    this.showFaults(this.present);
  }

  showFaults(faults) {
    const present = Object.entries(faults).filter(([, word]) => word !== "none");
    if (this.summary) setText(this.summary, present.length ? `Present: ${present.map(([valve, word]) => `${valve} ${word.replaceAll("_", " ")}`).join(", ")}.` : "No valve has a fault.");
    for (const [valve, { row, choice }] of this.choices) {
      const word = faults[valve] ?? "none";
      row.classList.toggle("is-changed", word !== "none");
      if (document.activeElement !== choice || choice.value === word) choice.value = word;
    }
  }

  /* --- Condition monitoring --- */

  makeWatch(watch) {
    this.watch.hidden = !watch;
    if (!watch || this.verdict) return;
    pageElement("h3", this.watch, {}, "Condition");
    this.verdict = pageElement("p", this.watch, { className: "verdict-line", role: "status" }, "The watch is starting.");
    const table = pageElement("table", this.watch), head = pageElement("tr", pageElement("thead", table));
    pageElement("caption", table, {}, `Estimates with ${SIGMAS} standard deviations`);
    for (const word of ["fault", "estimate", "probability"]) pageElement("th", head, { scope: "col" }, word);
    const body = pageElement("tbody", table);
    this.estimates = new Map(watch.faults.map(fault => {
      const row = pageElement("tr", body);
      breakable(pageElement("th", row, { scope: "row", title: fault.address }), fault.name);
      return [fault.name, { fault, row, estimate: pageElement("td", row), probability: pageElement("td", row) }];
    }));
    this.hint = pageElement("p", this.watch, { className: "lead small" }, watch.note);
    pageElement("h3", this.watch, {}, "Events");
    this.events = pageElement("ol", this.watch, { className: "events", role: "log", "aria-label": "events of the watch" });
  }

  clearWatch() {
    this.watched.time.length = 0;
    for (const { line, band } of this.watched.faults.values()) for (const list of [line.y, band?.low ?? [], band?.high ?? []]) list.length = 0;
  }

  event(text) {
    if (!this.events) { this.warn(text); return; }
    this.events.prepend(pageElement("li", null, {}, text));
    while (this.events.children.length > MAX_EVENTS) this.events.lastChild.remove();
  }

  showWatch({ time, verdict, kind, alarm, faults, events }) {
    setText(this.verdict, verdict);
    this.verdict.dataset.kind = kind;
    this.verdict.classList.toggle("is-alarm", alarm !== "");
    for (const text of events) this.event(text);
    if (time === null) return;
    if (this.watched.time.length && time / this.timeSize < this.watched.time[this.watched.time.length - 1]) this.clearWatch();
    this.watched.time.push(time / this.timeSize);
    for (const [name, [value, sigma, change, probability]] of Object.entries(faults)) {
      const { fault, row, estimate, probability: cell } = this.estimates.get(name), { factor, shift, unit, alarm: size } = fault;
      row.classList.toggle("is-alarm", alarm.split(/ (?:or|and) /).includes(name));
      setText(estimate, `${withBand(value * factor + shift, SIGMAS * sigma * Math.abs(factor))} ${unit}`);
      setText(cell, `${(100 * probability).toFixed(0)} %`);
      const curve = this.watched.faults.get(name);
      if (!curve) continue;
      curve.line.y.push(change / size);
      curve.band?.low.push((change - SIGMAS * sigma) / size);
      curve.band?.high.push((change + SIGMAS * sigma) / size);
    }
    const old = this.watched.time.findIndex(t => t >= (time - this.window.duration) / this.timeSize);
    if (old > MAX_SAMPLES / 10) {
      this.watched.time.splice(0, old);
      for (const { line, band } of this.watched.faults.values()) for (const list of [line.y, band?.low ?? [], band?.high ?? []]) list.splice(0, old);
    }
    this.later();
  }
}
