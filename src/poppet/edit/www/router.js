/* Routes of wires: right angles, around boxes, few bends, few crossings, nets apart from each other.

   A net grows from its first end, the root: each further end finds the cheapest way to what exists of the net. If other
   nets leave no way, the nets in the way are routed anew. The result depends on the scene alone, and no state remains
   between calls. */

import { Grid, SIDES, places } from "./grid.js";

const MAX_REMOVALS = 3; // largest number of times that a net makes way for others
const HASTE = 1.25; // factor of the lower limit of the remaining cost: above 1, the search looks at fewer ways
const HASTE_WHILE_MOVING = 1.6;

/* Route the wires of a scene: {boxes: [{name, x, y, width, height}], nets: [{id, ends}], labels: [{x, y, width, height}]}.

   `x` and `y` are the upper left corner. An end is {x, y, side, name, also: [{x, y, side}], waypoints: [[x, y]]}: `side` is
   "left", "right", "top" or "bottom", and `also` contains other places of the same end. The first end of a net is its root.
   A wire begins at its end, passes its waypoints in their order, and ends at the root or at another wire of its net.

   The result is {wires, routed, scene}. `wires` maps the id of each net to {paths, junctions, straight}: path k is the wire
   of end k + 1 as a list of points, `straight` contains the indices of the paths for which there is no way (a straight line
   instead). `routed` contains the ids of the nets that have been routed.

   `former` is an earlier result. Wires with the same ends that touch no changed box then stay as they are; the search for
   the others is faster, and its ways can be slightly longer. */
export function route(scene, former = null) {
  const nets = scene.nets.map((net, index) => ({ ...net, index: index + 1, removals: 0 }));
  const kept = new Map(nets.map(net => [net.id, net.ends.slice(1).map(() => null)]));
  if (former) keepPaths(scene, kept, former);
  const grid = new Grid(scene, kept, former ? HASTE_WHILE_MOVING : HASTE);
  for (const net of nets) {
    for (const end of net.ends) {
      for (const place of places(end)) grid.reserve(place, net.index);
    }
  }
  for (const net of nets) {
    net.paths = kept.get(net.id).map(points => points && grid.nodesOf(points));
    grid.occupy(net);
  }
  const hasPoints = net => net.ends.some(end => end.waypoints?.length);
  const isComplete = net => net.paths.every(Boolean);
  const queue = nets.filter(net => !isComplete(net) || !former?.wires.has(net.id));
  queue.sort((a, b) => hasPoints(b) - hasPoints(a) || span(a) - span(b) || (a.id < b.id ? -1 : 1));
  const routed = new Set();
  while (queue.length) {
    const net = queue.shift();
    routed.add(net.id);
    routeNet(grid, net, nets, queue);
  }
  const wires = new Map();
  for (const net of nets) {
    const before = former?.wires.get(net.id);
    const paths = kept.get(net.id);
    const isKept = !routed.has(net.id) && paths.length === before.paths.length;
    wires.set(net.id, isKept && paths.every((path, k) => path === before.paths[k]) ? before : wireOf(grid, net));
  }
  return { wires, routed: [...routed], scene };
}

/* Add the paths of a former result that stay: their end and the root are unchanged, no changed box touches them, and they
   end at the root or at a path that stays. */
function keepPaths(scene, kept, former) {
  const boxes = new Map(former.scene.boxes.map(box => [box.name, boxKey(box)]));
  const changed = scene.boxes.filter(box => boxes.get(box.name) !== boxKey(box));
  const nets = new Map(former.scene.nets.map(net => [net.id, net]));
  for (const { id, ends } of scene.nets) {
    const old = nets.get(id);
    if (!old || JSON.stringify(old.ends[0]) !== JSON.stringify(ends[0])) continue;
    const { paths, straight } = former.wires.get(id);
    const known = new Map(old.ends.slice(1).map((end, k) => [end.name, { key: JSON.stringify(end), path: paths[k], index: k }]));
    const free = new Map(); // index of the end to path
    ends.slice(1).forEach((end, k) => {
      const { key, path, index } = known.get(end.name) ?? {};
      const isFree = key === JSON.stringify(end) && !straight.includes(index) && !changed.some(box => touches(path, box));
      if (isFree) free.set(k, path);
    });
    const isRoot = ([x, y]) => places(ends[0]).some(place => place.x === x && place.y === y);
    const meets = ([x, y]) => kept.get(id).some(path => path && touches(path, { x, y, width: 0, height: 0 }));
    for (let count = -1; count !== free.size; ) {
      count = free.size;
      for (const [k, path] of free) {
        const last = path[path.length - 1];
        if (!isRoot(last) && !meets(last)) continue;
        kept.get(id)[k] = path;
        free.delete(k);
      }
    }
  }
}

function boxKey(box) {
  return `${box.x},${box.y},${box.width},${box.height}`;
}

/* Return true if a path has a point in a box or on its border. */
export function touches(path, box) {
  for (let k = 1; k < path.length; k++) {
    const [[x1, y1], [x2, y2]] = [path[k - 1], path[k]];
    if (Math.max(x1, x2) < box.x || Math.min(x1, x2) > box.x + box.width) continue;
    if (Math.max(y1, y2) < box.y || Math.min(y1, y2) > box.y + box.height) continue;
    return true;
  }
  return false;
}

/* Return half the circumference of the ends of a net. */
function span(net) {
  const xs = net.ends.map(end => end.x);
  const ys = net.ends.map(end => end.y);
  return Math.max(...xs) - Math.min(...xs) + Math.max(...ys) - Math.min(...ys);
}

/* Route the ends of a net without a path; nets that have to make way are added to the queue. */
function routeNet(grid, net, nets, queue) {
  const [root, ...others] = net.ends;
  const distance = end => Math.min(...places(root).map(place => Math.abs(end.x - place.x) + Math.abs(end.y - place.y)));
  const missing = [...others.keys()].filter(k => !net.paths[k]);
  missing.sort((a, b) => distance(others[a]) - distance(others[b]) || a - b);
  for (const k of missing) {
    const isFixed = index => nets[index - 1].removals >= MAX_REMOVALS;
    let path = wayOf(grid, net, others[k], null);
    if (!path) {
      path = wayOf(grid, net, others[k], isFixed);
      for (const index of path ? grid.conflicts(path, net.index) : []) {
        const other = nets[index - 1];
        grid.release(other);
        other.paths = other.paths.map(() => null);
        other.removals += 1;
        if (!queue.includes(other)) queue.push(other);
      }
    }
    net.paths[k] = path;
    if (path) grid.occupy({ index: net.index, paths: [path] });
  }
}

/* Return the nodes of the way of an end along its waypoints to its net, or null. */
function wayOf(grid, net, end, isFixed) {
  const targets = grid.targets(net);
  const stops = (end.waypoints ?? []).map(([x, y]) => grid.node(x, y)).filter(node => node >= 0 && !grid.blocked[node]);
  let starts = places(end).map(place => {
    const side = SIDES[place.side];
    return { node: grid.node(place.x, place.y), straight: side ?? -1, turns: side === undefined ? [0, 1, 2, 3] : [] };
  });
  let way = [];
  for (const stop of [...stops, null]) {
    const goals = stop === null ? targets : new Map([[stop, -1]]);
    const leg = grid.search(starts, goals, net.index, isFixed);
    if (!leg && !isFixed) return null;
    if (!leg && stop !== null) continue; // a waypoint that cannot be reached
    if (!leg) return way.length ? wayOf(grid, net, { ...end, waypoints: [] }, isFixed) : null;
    way = [...way, ...leg.slice(way.length ? 1 : 0)];
    const node = way[way.length - 1];
    const straight = way.length > 1 ? grid.direction(way[way.length - 2], node) : -1;
    starts = [{ node, straight, turns: [0, 1, 2, 3].filter(turn => straight < 0 || turn % 2 !== straight % 2) }];
  }
  return withoutLoops(way);
}

/* Return a list of nodes without the parts between two visits of a node. */
function withoutLoops(way) {
  const simple = [];
  const at = new Map();
  for (const node of way) {
    if (at.has(node)) {
      for (const lost of simple.splice(at.get(node) + 1)) at.delete(lost);
    } else {
      at.set(node, simple.length);
      simple.push(node);
    }
  }
  return simple;
}

/* Return paths as points, and the junctions of a net. */
function wireOf(grid, net) {
  const straight = [];
  const paths = net.paths.map((path, k) => {
    if (path) return grid.corners(path);
    straight.push(k);
    const [root, end] = [net.ends[0], net.ends[k + 1]];
    return [[end.x, end.y], [root.x, root.y]];
  });
  return { paths, junctions: grid.junctions(net.paths.filter(Boolean)), straight };
}
