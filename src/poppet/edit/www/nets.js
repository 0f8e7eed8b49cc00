/* Nets of a circuit: which ends of the drawing a wire joins, and the scene for the router. All functions are pure. */

import { sourceOf, split } from "./connections.js";
import { isCoordinate } from "./geometry.js";

/* Kinds of wires by the type of the end at which they begin. */
const KINDS = { port: "pipe", tube: "tube", body: "body", input: "signal" };
const VENT = { width: 2, length: 2.4 };  // size of the symbol of an exhaust to the atmosphere
const OUTWARD = { left: [-1, 0], right: [1, 0], top: [0, -1], bottom: [0, 1] };

/* Wires of a circuit: {key, kind, target, root, end, points}. `key` is the address of the port or input at which a wire
   begins, `target` the address at which it ends, `root` the ends at that address, of which the wire takes one. Wires
   with the same target belong to one net. Roots that are no ports, such as that of a measured pressure, have `isTap`.

   `ends` maps addresses to lists of ends, `boxes` are those of the parts. */
export function wiresOf(view, ends, boxes) {
  const borders = new Borders(ends, boxes);
  return [...gasAndBodies(view, ends), ...signals(view, ends, borders)].map(wire => ({
    ...wire, kind: KINDS[wire.end.type], points: pointsOf(view.drawing[wire.key]),
  }));
}

function* gasAndBodies(view, ends) {
  for (const [part, { ports }] of Object.entries(view.parts)) {
    for (const [port, target] of Object.entries(ports)) {
      const key = `${part}.${port}`, end = ends.get(key)?.[0];
      if (!end || typeof target !== "string") continue;
      const isRoot = end.type === "body" ? one => one.type === "body"
        : one => one.type === "store" || (end.type === "tube" && one.type === "port");
      const root = (ends.get(target) ?? []).filter(isRoot);
      // A port at a tube has no end of its own: the wire begins at the tube.
      if (root.length) yield { key, end, target, root };
    }
  }
}

function* signals(view, ends, borders) {
  for (const [key, [end]] of ends) {
    if (end.type !== "input") continue;
    const source = sourceOf(view, end);
    if (source === undefined) continue;
    const exact = (ends.get(source) ?? []).filter(one => one.type === "output");
    const root = exact.length ? exact : borders.of(source);
    if (root.length) yield { key, end, target: source, root };
  }
}

/* Valid points of an entry of the drawing. */
function pointsOf(entry) {
  const { points } = entry ?? {};
  const isPoint = point => Array.isArray(point) && point.length === 2 && point.every(isCoordinate);
  return Array.isArray(points) && points.every(isPoint) ? points : [];
}

/* Places on the border of parts for outputs that have no port, such as the pressure of a chamber. */
class Borders {
  constructor(ends, boxes) {
    this.boxes = new Map(boxes.map(box => [box.name, box]));
    this.taken = new Map(boxes.map(box => [box.name, new Set()]));
    for (const end of [...ends.values()].flat()) this.taken.get(end.part)?.add(`${end.x},${end.y}`);
    this.ends = ends;
    this.roots = new Map();
  }

  /* Ends of an output: the port that stands for any output of a controller, or a free place on each side. */
  of(address) {
    if (!this.roots.has(address)) this.roots.set(address, this.#choose(address));
    return this.roots.get(address);
  }

  #choose(address) {
    const [part] = split(address), box = this.boxes.get(part), any = this.ends.get(`${part}.output`)?.[0];
    if (!box) return [];
    if (any?.type === "output" && ![...this.roots.values()].some(([root]) => root === any)) return [any];
    const { x, y, width, height } = box;
    const across = this.#free(part, x, width, at => [[at, y], [at, y + height]]);
    const down = this.#free(part, y, height, at => [[x, at], [x + width, at]]);
    const sides = [
      ...across === null ? [] : [[across, y, "top"], [across, y + height, "bottom"]],
      ...down === null ? [] : [[x, down, "left"], [x + width, down, "right"]],
    ];
    for (const [left, top] of sides) this.taken.get(part).add(`${left},${top}`);
    return sides.map(([left, top, side]) => ({ address, part, x: left, y: top, side, isTap: true }));
  }

  /* Free coordinate nearest to the middle of two opposite sides, or null. */
  #free(part, start, length, places) {
    const middle = Math.round(start + length / 2), reach = Math.ceil(length / 2) - 1;
    for (let k = 0; k <= 2 * reach; k++) {
      const at = middle + (k % 2 ? 1 : -1) * Math.ceil(k / 2);
      const isInside = at > start && at < start + length;
      if (isInside && places(at).every(point => !this.taken.get(part).has(point.join()))) return at;
    }
    return null;
  }
}

/* Scene for the router: {boxes, nets, labels}. Wires of a net are in the order of the wires. */
export function sceneOf(view, ends, wires, boxes, labels) {
  const nets = new Map();
  for (const wire of wires) {
    const id = netOf(wire), [first, ...others] = wire.root;
    if (!nets.has(id)) {
      const also = others.map(({ x, y, side }) => ({ x, y, side }));
      nets.set(id, { id, ends: [{ name: wire.target, x: first.x, y: first.y, side: first.side, also }] });
    }
    const { x, y, side } = wire.end;
    nets.get(id).ends.push({ name: wire.key, x, y, side, waypoints: wire.points });
  }
  return { boxes, nets: [...nets.values()], labels: [...labels, ...vents(view, ends)] };
}

/* Id of the net of a wire. */
export function netOf({ kind, target }) {
  return `${kind === "tube" ? "pipe" : kind} ${target}`;
}

/* Boxes of the symbols at ports that are open to the atmosphere. */
function* vents(view, ends) {
  for (const [part, { ports }] of Object.entries(view.parts)) {
    for (const [port, target] of Object.entries(ports)) {
      const end = target === "ambient" ? ends.get(`${part}.${port}`)?.[0] : undefined;
      if (!end) continue;
      const [dx, dy] = OUTWARD[end.side], width = dx ? VENT.length : VENT.width, height = dx ? VENT.width : VENT.length;
      yield { x: end.x + (dx * VENT.length - width) / 2, y: end.y + (dy * VENT.length - height) / 2, width, height };
    }
  }
}

/* --- Segments --- */

/* Index of the segment of a path that is nearest to a point; with `isVertical`, of those in that direction. */
export function nearestSegment(path, [x, y], isVertical = null) {
  let best = 0, least = Infinity;
  for (let k = 0; k + 1 < path.length; k++) {
    if (isVertical !== null && isVerticalAt(path, k) !== isVertical) continue;
    const distance = distanceTo(path[k], path[k + 1], x, y);
    if (distance < least) [best, least] = [k, distance];
  }
  return best;
}

/* True if a segment of a path is vertical. */
export function isVerticalAt(path, k) {
  return path[k][0] === path[k + 1][0];
}

function distanceTo([x1, y1], [x2, y2], x, y) {
  const dx = Math.max(Math.min(x1, x2) - x, 0, x - Math.max(x1, x2));
  const dy = Math.max(Math.min(y1, y2) - y, 0, y - Math.max(y1, y2));
  return Math.hypot(dx, dy);
}

/* Points of a wire after its segment `k` has moved to another coordinate: the ends of the moved segment, between the
   former points in the other segments. A wire leaves its port by one unit before the moved segment begins. */
export function movedSegment(path, points, k, coordinate, isRootEnd) {
  const axis = isVerticalAt(path, k) ? 0 : 1;
  const shifted = point => (axis ? [point[0], coordinate] : [coordinate, point[1]]);
  const toward = ([x1, y1], [x2, y2]) => [x1 + Math.sign(x2 - x1), y1 + Math.sign(y2 - y1)];
  const [first, last] = [path[k], path[k + 1]], end = path.length - 2;
  const segment = [
    shifted(k === 0 ? toward(first, last) : first),
    shifted(k === end && isRootEnd ? toward(last, first) : last),
  ];
  const place = point => {
    const own = nearestSegment(path, point);
    return distanceTo(first, last, ...point) === 0 ? k : own;
  };
  const before = points.filter(point => place(point) < k), after = points.filter(point => place(point) > k);
  return [...before, ...segment, ...after].filter((point, n, all) => n === 0 || point.join() !== all[n - 1].join());
}

/* Middle of the longest segment of a path with the direction there, in degrees, for an arrow toward the end. */
export function arrowOf(path) {
  let best = 0, most = -1;
  for (let k = 0; k + 1 < path.length; k++) {
    const length = Math.abs(path[k + 1][0] - path[k][0]) + Math.abs(path[k + 1][1] - path[k][1]);
    if (length > most) [best, most] = [k, length];
  }
  const [[x1, y1], [x2, y2]] = [path[best], path[best + 1]];
  return { x: (x1 + x2) / 2, y: (y1 + y2) / 2, angle: Math.atan2(y2 - y1, x2 - x1) * 180 / Math.PI, length: most };
}
