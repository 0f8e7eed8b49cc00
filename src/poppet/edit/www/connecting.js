/* Connecting two ends of the drawing by clicks, by a drag, or with keys.

   While a connection is in progress, ends that cannot be connected are grey, and their tooltip states the reason. */

import { candidates, connection, mediumOf, outputsOf, split } from "./connections.js";
import { freePlace } from "./geometry.js";
import { htmlElement, setTitle, svgElement } from "./symbols.js";
import { text } from "./strings.js";

/* Values of parts that are inserted between two ports: a chamber is the gas in a short hose. */
const BETWEEN = { chamber: { volume: "20 cm^3" }, mass: {} };

export class Connecting {
  constructor(drawing) {
    Object.assign(this, { drawing, from: null });
    this.line = svgElement("path", { class: "rubber" }, drawing.overLayer);
    this.bar = htmlElement("div", { className: "connect-bar strip", hidden: true }, drawing.svg.parentElement);
  }

  get isActive() {
    return this.from !== null;
  }

  /* Begin a connection at an end. */
  begin(end) {
    const { store } = this.drawing;
    this.from = end;
    this.columns = (store.header?.columns ?? store.run?.columns ?? []).map(({ name }) => name);
    this.drawing.offers.close();
    this.drawing.svg.classList.add("is-connecting");
    this.mark();
    this.#showBar();
    this.move(end);
    store.announce(text("drawing.begun", { port: end.address }));
  }

  /* End without a connection. The focus stays at the first end. */
  cancel() {
    if (!this.from) return false;
    const { from, drawing } = this;
    this.#end();
    if (this.bar.contains(document.activeElement)) this.#nodeOf(from)?.focus({ preventScroll: true });
    drawing.store.announce(text("drawing.cancelled"));
    return true;
  }

  #end() {
    this.from = null;
    this.line.setAttribute("d", "");
    this.bar.hidden = true;
    this.drawing.svg.classList.remove("is-connecting");
    for (const item of this.drawing.items.values()) {
      item.node.setAttribute("tabindex", 0);
      for (const element of [item.item, ...[...item.ports.values()].map(port => port.node)]) {
        element.classList.remove("is-impossible", "is-possible", "is-start", "is-over");
      }
    }
    this.drawing.mark();
  }

  /* Draw the line to a point. */
  move({ x, y }) {
    if (this.from) this.line.setAttribute("d", `M${this.from.x} ${this.from.y}L${x} ${y}`);
  }

  /* The ends have moved, or are gone. */
  redraw() {
    if (!this.from) return;
    const end = this.drawing.endsAt(this.from.address)[0];
    if (end) this.from = end;
    else this.#end();
  }

  /* Best end of a target, and the plan of its connection. A target is {end}, {part} or {wire}. */
  plan(target, point = null) {
    const { from } = this, { view } = this.drawing;
    if (target.end) return { end: target.end, ...this.#planOf(target.end) };
    if (target.part === from.part) return { reason: "drawing.no_itself" };
    if (target.wire) return this.#planOf({ address: target.wire, type: "wire", port: split(target.wire)[1], ...point });
    const own = candidates(view, this.drawing.ends, from, target.part).map(end => ({ end, ...this.#planOf(end) }));
    const near = ({ end }) => Math.hypot(end.x - (point ?? from).x, end.y - (point ?? from).y);
    const possible = own.filter(plan => !plan.reason).sort((a, b) => near(a) - near(b));
    if (possible.length) return possible[0];
    if (mediumOf(from) === "signal" && from.type === "input") return this.#outputs(target.part);
    return own[0] ?? { reason: `drawing.no_${mediumOf(from)}_here` };
  }

  /* An input is connected to an output of a part that has no port for it, such as a position. */
  #outputs(part) {
    const end = { address: part, part, port: "", type: this.drawing.ends.find(one => one.address === part)?.type ?? "part" };
    return { end, ...this.#planOf(end) };
  }

  #planOf(end) {
    const { view } = this.drawing, outputs = (source, input) => outputsOf(view, source, input, this.columns);
    return connection(view, this.from, end, outputs, "\0");
  }

  /* Connect to a target; the reason is announced if that is not possible, and the connection stays in progress. */
  finish(target, point = null) {
    const { from, drawing } = this;
    if (target.end?.address === from.address && target.end.type === from.type) { this.cancel(); return; }
    const plan = this.plan(target, point);
    if (plan.reason) {
      const words = text(plan.reason);
      this.reason.textContent = words;
      drawing.store.announce(words);
      return;
    }
    this.#end();
    if (plan.insert) this.#insert(from, plan);
    else this.#apply(plan);
  }

  async #apply(plan) {
    const { store, offers, view } = this.drawing, [{ port, to, input, output }] = plan.operations;
    const [part, local] = split(port ?? ""), former = view.parts[part]?.ports[local];
    if (!await store.apply(plan.operations)) return;
    const isMoved = former !== undefined && former !== to && former !== split(to)[0];
    const words = text(isMoved ? "drawing.moved" : "drawing.connected", { port: port ?? input, target: to ?? output, former });
    store.announce(words);
    if (isMoved) offers.show(words, [[text("drawing.take_back"), () => store.undo()]]);
    if (plan.link?.choices.length > 1) offers.show(text("drawing.source", { input }), [this.#choice(plan.link)]);
  }

  /* Selection of another output of the same part. */
  #choice({ input, choices }) {
    const select = htmlElement("select");
    select.setAttribute("aria-label", text("drawing.source", { input }));
    for (const name of choices) select.add(new Option(name, name));
    select.addEventListener("change", () => {
      this.drawing.store.apply([{ op: "link", input, output: select.value }], { continues: true });
    });
    return select;
  }

  /* Insert a part between two ports, and offer a tube instead of a chamber. */
  async #insert(from, { insert: kind, operations, end, tube }) {
    const { drawing } = this, { store } = drawing, name = drawing.freeName(kind), entry = store.palette.get(kind);
    const place = freePlace(entry, name, { x: (from.x + end.x) / 2, y: (from.y + end.y) / 2 }, drawing.taken());
    const state = await drawing.insert([drawing.adding(kind, name, place, BETWEEN[kind]), ...renamed(operations, name)]);
    if (!state) return;
    store.announce(text(`drawing.inserted_${kind}`, { name }));
    drawing.reveal([name]);
    const back = [text("drawing.take_back"), () => store.undo()];
    drawing.offers.show(text(`drawing.inserted_${kind}`, { name }), tube ? [this.#tube(name, tube, place), back] : [back]);
  }

  #tube(chamber, operations, place) {
    const { drawing } = this, name = drawing.freeName("tube");
    const list = [{ op: "remove", parts: [chamber] }, drawing.adding("tube", name, place), ...renamed(operations, name)];
    return [text("drawing.tube"), async () => {
      if (await drawing.store.apply(list)) drawing.store.announce(text("drawing.inserted_tube", { name }));
    }];
  }

  /* Connect the port to the atmosphere. */
  vent() {
    const { from } = this, end = { address: "ambient", part: "", port: "", type: "ambient", x: from.x, y: from.y };
    this.finish({ end });
  }

  /* Show which ends can be connected. */
  mark() {
    if (!this.from) return;
    for (const item of this.drawing.items.values()) {
      const whole = this.plan({ part: item.name });
      item.item.classList.toggle("is-impossible", Boolean(whole.reason));
      item.node.setAttribute("tabindex", whole.reason ? -1 : 0);
      for (const port of item.ports.values()) this.#markPort(port);
    }
  }

  #markPort({ node, end }) {
    const isStart = end.address === this.from.address && end.type === this.from.type;
    const { reason } = isStart ? {} : this.plan({ end });
    node.classList.toggle("is-start", isStart);
    node.classList.toggle("is-possible", !isStart && !reason);
    node.classList.toggle("is-impossible", Boolean(reason));
    if (end.port) node.setAttribute("tabindex", reason ? -1 : 0);
    setTitle(node, reason ? `${end.address}: ${text(reason)}` : end.address);
  }

  /* Mark the target under the pointer. */
  over(target) {
    const node = target?.end ? this.#nodeOf(target.end) : target?.part ? this.drawing.items.get(target.part)?.item : null;
    if (node === this.marked) return;
    this.marked?.classList.remove("is-over");
    node?.classList.add("is-over");
    this.marked = node;
    if (!this.from) return;
    const { reason } = target ? this.plan(target) : {};
    this.reason.textContent = reason ? text(reason) : "";
  }

  #nodeOf(end) {
    return this.drawing.items.get(end.part)?.port(end.address)?.node;
  }

  /* Bar with all possible targets, the atmosphere, and the way out. */
  #showBar() {
    const { from, bar } = this, isGas = mediumOf(from) === "gas" && from.type !== "store";
    bar.replaceChildren();
    htmlElement("span", { textContent: text("drawing.begun", { port: from.address }) }, bar);
    if (isGas) button(bar, text("drawing.atmosphere"), () => this.vent());
    this.#targets(bar);
    button(bar, text("drawing.cancel"), () => this.cancel());
    this.reason = htmlElement("span", { className: "reason" }, bar);
    bar.hidden = false;
  }

  /* List of all possible ends, nearest first. */
  #targets(bar) {
    const { from, drawing } = this, select = htmlElement("select", {}, bar), seen = new Map();
    select.setAttribute("aria-label", text("drawing.targets"));
    select.add(new Option(text("drawing.targets"), ""));
    for (const end of drawing.ends) {
      if (end.address !== from.address && !seen.has(end.address) && !this.plan({ end }).reason) seen.set(end.address, end);
    }
    const distance = end => Math.hypot(end.x - from.x, end.y - from.y);
    for (const { address } of [...seen.values()].sort((a, b) => distance(a) - distance(b))) select.add(new Option(address, address));
    // Keys change the choice of a closed list, hence the button.
    button(bar, text("drawing.connect"), () => select.value && this.finish({ end: seen.get(select.value) }));
  }
}

function button(parent, label, run) {
  htmlElement("button", { type: "button", textContent: label }, parent).addEventListener("click", run);
}

/* Operations in which a new part has its name. */
function renamed(operations, name) {
  const change = value => (typeof value === "string" ? value.replace("\0", name) : value);
  return operations.map(operation => Object.fromEntries(Object.entries(operation).map(([key, value]) => [key, change(value)])));
}
