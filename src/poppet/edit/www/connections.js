/* Rules of connections: which operations connect two ends of the drawing, or why they cannot be connected.

   An end is {address, part, port, type}; types are `port`, `tube`, `store`, `body`, `input` and `output` as in the
   palette, `ambient`, and `wire` with the address of a port or input on that wire. All functions are pure. */

const GAS = new Set(["port", "tube", "store", "ambient"]);

/* Outputs of controllers and of nodes, which inputs can be connected to; other outputs come from a run. */
export const OUTPUTS = {
  antagonist: ["flexor_pressure", "extensor_pressure"],
  electronics: ["fill_duty", "vent_duty"],
  inverse_muscle: ["pressure"],
  pid: ["command", "fill_command", "vent_command"],
  pressure_controller: ["command", "fill_command", "vent_command"],
  switch: ["state"],
};

/* Group of connections of an end: gas, body or signal. */
export function mediumOf({ type }) {
  return GAS.has(type) ? "gas" : type === "body" ? "body" : "signal";
}

/* Output that an input is connected to, by the table of connections or by a field of its part; otherwise undefined. */
export function sourceOf(view, end) {
  const stated = view.parts[end.part]?.fields[end.port];
  return view.connections[end.address] ?? end.source ?? (typeof stated === "string" && stated.includes(".") ? stated : undefined);
}

/* What a port, tube end, body or input is connected to, or undefined. */
export function targetOf(view, end) {
  if (end.type === "input") return sourceOf(view, end);
  return end.port ? view.parts[end.part]?.ports[end.port] : undefined;
}

/* Ends of `target` that the end `from` could be connected to; a part stands for one of its ends. */
export function candidates(view, ends, from, part) {
  if (part === from.part) return [];
  const own = ends.filter(end => end.part === part), medium = mediumOf(from);
  if (medium === "signal") return own.filter(end => end.type === (from.type === "output" ? "input" : "output"));
  const fitting = own.filter(end => mediumOf(end) === medium && end.address !== from.address);
  const node = fitting.filter(end => end.address === part);
  if (node.length && from.type !== "store") return node;
  const open = fitting.filter(end => end.port && end.type !== "store" && targetOf(view, end) === undefined);
  return fitting.filter(end => end.type === "store").concat(open);
}

/* Plan of a connection of two ends: {operations, insert?, link?} or {reason: key of a text}.

   `insert` is the kind of a part between the ends, which the operations expect with the name `between`. With `link`,
   the user can choose among several outputs. */
export function connection(view, from, to, outputs = () => [], between = "") {
  const isOwn = from.part !== "" && from.part === to.part && mediumOf(from) === "gas" && mediumOf(to) === "gas";
  if ((from.address === to.address && from.type === to.type) || (isOwn && to.type !== "wire")) return { reason: "drawing.no_itself" };
  if (to.type === "wire") return ontoWire(view, from, to);
  if (from.type === "input" || to.type === "input") return signal(from, to, outputs);
  if (from.type === "output" || to.type === "output") return { reason: "drawing.no_output" };
  const medium = mediumOf(from);
  if (medium !== mediumOf(to)) return { reason: medium === "body" || to.type === "body" ? "drawing.no_body" : "drawing.no_gas" };
  return medium === "body" ? bodies(from, to, between) : gas(view, from, to, between);
}

function ontoWire(view, from, wire) {
  const [part, port] = split(wire.address), source = sourceOf(view, { ...wire, part, port });
  const isLink = source !== undefined && !(port in (view.parts[part]?.ports ?? {}));
  const store = isLink ? source : view.parts[part]?.ports[port];
  if (store === undefined) return { reason: "drawing.no_wire" };
  if (isLink !== (mediumOf(from) === "signal")) return { reason: isLink ? "drawing.no_gas" : "drawing.no_signal" };
  if (isLink) {
    return from.type === "input" ? { operations: [{ op: "link", input: from.address, output: store }] }
      : { reason: "drawing.no_output" };
  }
  if (from.type === "store") return { reason: "drawing.no_stores" };
  return { operations: [connect(from.address, store)] };
}

/* An input and an output; other parts have several outputs, of which the first one is connected. */
function signal(from, to, outputs) {
  const [input, source] = from.type === "input" ? [from, to] : [to, from];
  if (source.type === "input") return { reason: "drawing.no_inputs" };
  if (source.type === "ambient") return { reason: "drawing.no_signal" };
  const choices = outputs(source, input);
  if (!choices.length) return { reason: "drawing.no_outputs" };
  return { operations: [{ op: "link", input: input.address, output: choices[0] }], link: { input: input.address, choices } };
}

function bodies(from, to, between) {
  const nodes = [from, to].filter(end => !end.port);
  if (nodes.length === 2) return { reason: "drawing.no_bodies" };
  if (nodes.length === 1) return { operations: [connect((from.port ? from : to).address, nodes[0].address)] };
  return {
    insert: "mass", operations: [connect(from.address, between), connect(to.address, between)],
  };
}

function gas(view, from, to, between) {
  const isNode = end => end.type === "store" || end.type === "ambient", nodes = [from, to].filter(isNode);
  if (nodes.length === 2) return { reason: "drawing.no_stores" };
  if (nodes.length === 1) return { operations: [connect((isNode(from) ? to : from).address, nodes[0].address)] };
  const tubes = [from, to].filter(end => end.type === "tube");
  if (tubes.length === 1) return { operations: [connect(from.address, to.address)] };
  // A port joins the gas node of the other one.
  for (const [end, other] of [[from, to], [to, from]]) {
    const node = targetOf(view, other);
    if (node !== undefined && node !== "ambient" && !isTubeEnd(view, node) && targetOf(view, end) !== node) {
      return { operations: [connect(end.address, node)] };
    }
  }
  if (targetOf(view, from) !== undefined && targetOf(view, from) === targetOf(view, to) && targetOf(view, from) !== "ambient") {
    return { reason: "drawing.no_twice" };
  }
  return {
    insert: "chamber", operations: [connect(from.address, between), connect(to.address, between)],
    tube: !tubes.length && [connect(`${between}.from`, from.address), connect(`${between}.to`, to.address)],
  };
}

/* True if a target names a tube, or the port of a part: a port that is joined to a tube has no gas node. */
function isTubeEnd(view, target) {
  const [part, port] = split(target);
  if (view.parts[part]?.kind === "tube") return true;
  return port !== "" && port in (view.parts[part]?.ports ?? {});
}

function connect(port, to) {
  return { op: "connect", port, to };
}

/* Entry of a table by a name that a document can contain, such as "constructor"; otherwise undefined. */
export function entryOf(table, name) {
  return Object.hasOwn(table, name) ? table[name] : undefined;
}

/* Name of the part and of the port in an address. */
export function split(address) {
  const at = address.indexOf(".");
  return at < 0 ? [address, ""] : [address.slice(0, at), address.slice(at + 1)];
}

/* Outputs of a source for an input, likeliest first. `columns` are the names of the outputs of the last run. */
export function outputsOf(view, source, input, columns) {
  const kind = view.parts[source.part]?.kind;
  if (source.type === "output" && source.port !== "output") return [source.address];
  const table = entryOf(OUTPUTS, kind)?.map(name => `${source.part}.${name}`) ?? [];
  const prefix = source.port && source.type !== "output" ? `${source.address}.` : `${source.part}.`;
  const seen = columns.filter(name => name.startsWith(prefix) && !(name in view.connections));
  const usual = source.type === "store" ? ["pressure", "temperature", "mass"] : source.type === "body" ? ["position", "velocity"] : [];
  const [, local] = split(input.address), used = new Set(Object.values(view.connections));
  const all = [...new Set([...table, ...usual.map(name => prefix + name), ...seen])];
  const rank = name => {
    const [, output] = split(name);
    if (output.endsWith(local) || (local === "measurement" && /pressure$|position$/.test(output))) return 0;
    return used.has(name) ? 2 : 1;
  };
  return all.map((name, k) => [rank(name), k, name]).sort((a, b) => a[0] - b[0] || a[1] - b[1]).map(item => item[2]);
}
