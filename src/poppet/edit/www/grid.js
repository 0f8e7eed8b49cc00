/* Grid on which wires are routed, and the search for the cheapest way (A*).

   The lines of the grid are near the borders of boxes, the ends and the waypoints. Two nets can cross
   straight, but have no segment in common, and no net has a bend at another net. */

const BEND = 5; // cost of a bend, in units of length
const CROSSING = 4; // cost of a crossing with another net
const BESIDE_WIRE = 1; // additional cost of a unit of length beside another wire
const BESIDE_BOX = 0.6; // additional cost of a unit of length beside a box
const LABEL = 4; // additional cost of a unit of length across a label
const STUB = 8; // cost of a place in front of a port of another net
const CONFLICT = 60; // cost of a place of another net, which is then routed anew
const MAX_STEPS = 20000; // largest number of steps of a search among the other nets, before these make way
const MAX_NODES = 300000; // largest number of nodes of the grid
const BESIDE = 3; // lines beside each border of a box
const MARGIN = 8; // lines outside of all boxes

/* Directions by side. */
export const SIDES = { right: 0, bottom: 1, left: 2, top: 3 };

/* All places of an end. */
export function places(end) {
  return end.also?.length ? [end, ...end.also] : [end];
}

/* Lines of the grid, what its nodes contain, and the search. */
export class Grid {
  constructor(scene, kept, haste) {
    this.haste = haste;
    this.lines(scene, kept);
    const count = this.width * this.ys.length;
    this.columnOf = new Int32Array(count);
    this.rowOf = new Int32Array(count);
    for (let node = 0; node < count; node++) {
      this.columnOf[node] = node % this.width;
      this.rowOf[node] = (node / this.width) | 0;
    }
    this.steps = [1, this.width, -1, -this.width]; // to the next node: right, down, left, up
    this.blocked = new Uint8Array(count); // in a box
    this.price = new Float32Array(count); // additional cost of a unit of length
    this.stub = new Int32Array(count); // net of the port in front of which the node is
    this.along = [new Int32Array(count), new Int32Array(count)]; // net of a wire that passes horizontally, vertically
    this.solid = new Int32Array(count); // net of an end, a bend or a junction
    for (const box of scene.boxes) {
      this.each(box, 1, node => { this.price[node] += BESIDE_BOX; });
      this.each(box, 0, node => { this.blocked[node] = 1; });
    }
    for (const label of scene.labels ?? []) {
      this.each(label, 0, node => { this.price[node] += LABEL; });
    }
    for (let k = 0; k < this.width; k++) this.blocked[k] = this.blocked[count - 1 - k] = 1; // the edge of the grid
    for (let k = 0; k < count; k += this.width) this.blocked[k] = this.blocked[k + this.width - 1] = 1;
    this.goal = new Uint8Array(count); // 0: none, 1: from any direction, otherwise 2 << direction
    this.cost = new Float64Array(4 * count);
    this.stamp = new Int32Array(4 * count); // number of the search that has set the cost
    this.from = new Int32Array(4 * count);
    this.searches = 0;
    this.heap = new Heap();
  }

  /* Choose the coordinates of the lines. */
  lines(scene, kept) {
    const near = [[], []]; // coordinates with free lines on both sides
    const exact = [[], []];
    for (const box of scene.boxes) {
      near[0].push(box.x, box.x + box.width);
      near[1].push(box.y, box.y + box.height);
    }
    for (const net of scene.nets) {
      for (const end of net.ends) {
        for (const place of places(end)) {
          near[0].push(place.x);
          near[1].push(place.y);
        }
        for (const [x, y] of end.waypoints ?? []) {
          exact[0].push(x);
          exact[1].push(y);
        }
      }
    }
    for (const paths of kept.values()) {
      for (const path of paths) {
        for (const [x, y] of path ?? []) {
          exact[0].push(x);
          exact[1].push(y);
        }
      }
    }
    for (let width = BESIDE; width >= 1; width -= 1) {
      [this.xs, this.ys] = [0, 1].map(axis => linesNear(near[axis], exact[axis], width));
      if (this.xs.length * this.ys.length <= MAX_NODES) break;
    }
    this.width = this.xs.length;
    this.columns = new Map([...this.xs].map((x, k) => [x, k]));
    this.rows = new Map([...this.ys].map((y, k) => [y, k]));
  }

  /* Return the node at a place, or -1. */
  node(x, y) {
    const [column, row] = [this.columns.get(x), this.rows.get(y)];
    return column === undefined || row === undefined ? -1 : row * this.width + column;
  }

  point(node) {
    return [this.xs[this.columnOf[node]], this.ys[this.rowOf[node]]];
  }

  /* Return the direction from a node to another one on the same line. */
  direction(from, to) {
    const isVertical = this.columnOf[from] === this.columnOf[to];
    return isVertical ? (to > from ? 1 : 3) : to > from ? 0 : 2;
  }

  /* Call a function for each node in a rectangle that is wider by a margin. */
  each(box, margin, action) {
    const right = box.x + box.width + margin;
    const bottom = box.y + box.height + margin;
    const first = firstAtLeast(this.xs, box.x - margin);
    for (let row = firstAtLeast(this.ys, box.y - margin); this.ys[row] <= bottom; row++) {
      for (let column = first; this.xs[column] <= right; column++) action(row * this.width + column);
    }
  }

  /* Keep the node in front of a port free for its net, if possible. */
  reserve(place, index) {
    const node = this.node(place.x, place.y);
    if (place.side in SIDES) this.stub[node + this.steps[SIDES[place.side]]] = index;
    this.solid[node] = index;
  }

  /* Return all nodes on a path of points. */
  nodesOf(points) {
    const nodes = [this.node(...points[0])];
    for (const [x, y] of points.slice(1)) {
      const goal = this.node(x, y);
      let node = nodes[nodes.length - 1];
      if (node === goal) continue;
      const direction = this.direction(node, goal);
      while (node !== goal) nodes.push((node += this.steps[direction]));
    }
    return nodes;
  }

  /* Mark the nodes of the paths of a net. */
  occupy(net) {
    this.mark(net, net.index);
  }

  /* Free the nodes of the paths of a net, except its ends. */
  release(net) {
    this.mark(net, 0);
    for (const end of net.ends) {
      for (const place of places(end)) this.solid[this.node(place.x, place.y)] = net.index;
    }
  }

  mark(net, index) {
    for (const path of net.paths) {
      for (let k = 0; path && k < path.length; k++) {
        const before = k ? this.direction(path[k - 1], path[k]) : -1;
        const after = k + 1 < path.length ? this.direction(path[k], path[k + 1]) : -1;
        if (before >= 0 && before === after) this.along[before % 2][path[k]] = index;
        else this.solid[path[k]] = index;
      }
    }
  }

  /* Return the nodes at which a way can end, with the direction there (-1: any). */
  targets(net) {
    const goals = new Map();
    for (const path of net.paths) {
      for (let k = 1; path && k < path.length; k++) goals.set(path[k], -1);
    }
    for (const place of places(net.ends[0])) {
      const side = SIDES[place.side] ?? -1;
      const node = this.node(place.x, place.y);
      const front = node + this.steps[side];
      // A place that is covered by another box would cause a search in the whole grid.
      if (side >= 0 && this.blocked[front] && this.solid[front] !== net.index) continue;
      goals.set(node, side < 0 ? -1 : (side + 2) % 4);
    }
    return goals;
  }

  /* Return the nets whose marks a path of a net is not compatible with. */
  conflicts(path, index) {
    const found = new Set();
    for (let k = 0; k < path.length; k++) {
      const before = k ? this.direction(path[k - 1], path[k]) : -1;
      const after = k + 1 < path.length ? this.direction(path[k], path[k + 1]) : -1;
      found.add(this.solid[path[k]]);
      for (const axis of [0, 1]) {
        if (before !== after || before % 2 === axis) found.add(this.along[axis][path[k]]);
      }
    }
    found.delete(0);
    found.delete(index);
    return [...found].sort((a, b) => a - b);
  }

  /* Return the nodes of the cheapest way from one of the starts to one of the goals, or null.

     A start is a node, the direction of its straight step and the directions of a bend. If `isFixed` is a function, the
     way can use nodes of other nets, except of those for which the function returns true. */
  search(starts, goals, index, isFixed) {
    const { blocked, along, solid, price, stub, cost, stamp, from, heap, goal, columnOf, rowOf, xs, ys, steps } = this;
    if (!goals.size) return null;
    const bounds = this.bounds(goals.keys());
    const search = ++this.searches;
    const isTaken = net => !isFixed || isFixed(net);
    heap.clear();
    for (const [node, direction] of goals) goal[node] = 1 << direction + 1;
    const step = (node, direction, before, parent) => {
      const next = node + steps[direction];
      const isGoal = goal[next] !== 0 && (goal[next] === 1 || goal[next] === 2 << direction);
      if (blocked[next] && !isGoal) return;
      const axis = direction & 1;
      const owner = solid[next];
      const same = along[axis][next];
      const across = along[1 - axis][next];
      let total = before;
      if (owner !== 0 && owner !== index) {
        if (blocked[next] || isTaken(owner)) return;
        total += CONFLICT;
      }
      if (same !== 0 && same !== index) {
        if (isTaken(same)) return;
        total += CONFLICT;
      }
      if (across !== 0 && across !== index) {
        if (isGoal) {
          if (isTaken(across)) return;
          total += CONFLICT;
        }
        total += CROSSING;
      }
      if (stub[next] !== 0 && stub[next] !== index) total += STUB;
      const side = steps[1 - axis];
      const beside = (along[axis][next - side] ? BESIDE_WIRE : 0) + (along[axis][next + side] ? BESIDE_WIRE : 0);
      const length = axis ? Math.abs(ys[rowOf[next]] - ys[rowOf[node]]) : Math.abs(xs[columnOf[next]] - xs[columnOf[node]]);
      total += length * (1 + price[next] + beside);
      const state = 4 * next + direction;
      if (stamp[state] === search && cost[state] <= total) return;
      stamp[state] = search;
      cost[state] = total;
      from[state] = parent;
      heap.push(state, total + this.remaining(next, direction, bounds));
    };
    let found = null; 
    for (const { node, straight, turns } of starts) {
      if (goals.has(node)) found = [node];
      if (straight >= 0) step(node, straight, 0, -1 - node);
      for (const turn of turns) step(node, turn, straight < 0 ? 0 : BEND, -1 - node);
    }
    for (let count = 0; heap.size && !found && (isFixed || count < MAX_STEPS); count++) {
      const state = heap.pop();
      const node = state >> 2;
      const direction = state & 3;
      const total = cost[state];
      if (heap.key > total + this.remaining(node, direction, bounds) + 1e-9) continue; // a better one was found
      if (goal[node] !== 0 && (goal[node] === 1 || goal[node] === 2 << direction)) found = this.way(state);
      step(node, direction, total, state);
      const across = along[1 - (direction & 1)][node];
      let bend = BEND;
      if (across !== 0 && across !== index) {
        if (isTaken(across)) continue;
        bend += CONFLICT;
      }
      step(node, (direction + 1) & 3, total + bend, state);
      step(node, (direction + 3) & 3, total + bend, state);
    }
    for (const node of goals.keys()) goal[node] = 0;
    return found;
  }

  bounds(nodes) {
    const points = [...nodes].map(node => this.point(node));
    const [xs, ys] = [0, 1].map(axis => points.map(point => point[axis]));
    return { left: Math.min(...xs), right: Math.max(...xs), top: Math.min(...ys), bottom: Math.max(...ys) };
  }

  /* Return an estimate of the cost from a node to a rectangle. */
  remaining(node, direction, { left, right, top, bottom }) {
    const x = this.xs[this.columnOf[node]];
    const y = this.ys[this.rowOf[node]];
    const dx = x < left ? left - x : x > right ? x - right : 0;
    const dy = y < top ? top - y : y > bottom ? y - bottom : 0;
    const isBent = (dx > 0 && dy > 0) || (dx > 0 && direction % 2 === 1) || (dy > 0 && direction % 2 === 0);
    return this.haste * (dx + dy + (isBent ? BEND : 0));
  }

  way(state) {
    const nodes = [];
    while (state >= 0) {
      nodes.push(state >> 2);
      state = this.from[state];
    }
    nodes.push(-1 - state);
    return nodes.reverse();
  }

  /* Return the first and the last point of a path and its bends. */
  corners(path) {
    const points = path.filter(
      (node, k) => k === 0 || k === path.length - 1 || this.direction(path[k - 1], node) !== this.direction(node, path[k + 1]),
    );
    if (points.length === 1) points.push(points[0]);
    return points.map(node => this.point(node));
  }

  /* Return the points at which at least three wires of a net meet. */
  junctions(paths) {
    const directions = new Map(); // node to bits
    const add = (node, direction) => directions.set(node, (directions.get(node) ?? 0) | (1 << direction));
    for (const path of paths) {
      for (let k = 1; k < path.length; k++) {
        const direction = this.direction(path[k - 1], path[k]);
        add(path[k - 1], direction);
        add(path[k], (direction + 2) % 4);
      }
    }
    const bits = value => (value & 1) + ((value >> 1) & 1) + ((value >> 2) & 1) + ((value >> 3) & 1);
    return [...directions].filter(([, value]) => bits(value) > 2).map(([node]) => this.point(node));
  }
}

/* Return sorted coordinates: whole numbers near some coordinates, and exact ones. */
function linesNear(near, exact, width) {
  const lines = new Set([...near, ...exact]);
  const add = (from, to) => {
    for (let x = Math.ceil(from); x <= to; x++) lines.add(x);
  };
  for (const centre of new Set(near)) add(centre - width, centre + width);
  if (!lines.size) lines.add(0);
  const [first, last] = [Math.min(...lines), Math.max(...lines)];
  add(first - MARGIN, first);
  add(last, last + MARGIN);
  return Float64Array.from(lines).sort();
}

/* Return the index of the first coordinate that is not below a value. */
function firstAtLeast(lines, value) {
  let [low, high] = [0, lines.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (lines[middle] < value) low = middle + 1;
    else high = middle;
  }
  return low;
}

/* Priority queue of numbers, smallest key first. */
class Heap {
  constructor() {
    this.items = [];
    this.keys = [];
    this.size = 0;
    this.key = 0; // key of the last result of `pop`
  }

  clear() {
    this.size = 0;
  }

  push(item, key) {
    const { items, keys } = this;
    let k = this.size++;
    while (k > 0) {
      const parent = (k - 1) >> 1;
      if (keys[parent] <= key) break;
      items[k] = items[parent];
      keys[k] = keys[parent];
      k = parent;
    }
    items[k] = item;
    keys[k] = key;
  }

  pop() {
    const { items, keys } = this;
    const top = items[0];
    this.key = keys[0];
    const size = --this.size;
    const [item, key] = [items[size], keys[size]];
    let k = 0;
    while (true) {
      let child = 2 * k + 1;
      if (child >= size) break;
      if (child + 1 < size && keys[child + 1] < keys[child]) child += 1;
      if (keys[child] >= key) break;
      items[k] = items[child];
      keys[k] = keys[child];
      k = child;
    }
    items[k] = item;
    keys[k] = key;
    return top;
  }
}
