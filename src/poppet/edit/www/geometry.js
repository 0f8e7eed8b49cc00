/* Places of parts in the drawing: boxes, ports and labels in grid units. All functions are pure.

   A symbol is first mirrored (left and right exchanged), then rotated clockwise, then moved to the place of its part. */

export const MARGIN = 2;  // free space around a new part
const FARTHEST = 1e5;  // largest coordinate, as in poppet.edit.operations
const LETTER = 0.68, LINE = 1.6, VALUE = 7;  // width of a letter, height of a line, and letters of a value
const ASIDE = 1.3;  // distance of a name from the ports beside it
const SIDES = ["top", "right", "bottom", "left"];

/* True if a value of the file is a coordinate. */
export function isCoordinate(value) { return Number.isFinite(value) && Math.abs(value) <= FARTHEST; }

/* Point of a symbol after mirroring and rotation, relative to the place of the part. */
export function turned({ rotation = 0, mirror = false }, x, y) {
  const across = mirror ? -x : x;
  switch (rotation) {
    case 90: return [0 - y, across];
    case 180: return [0 - across, 0 - y];
    case 270: return [y, 0 - across];
    default: return [across, y];
  }
}

/* Side of a symbol after mirroring and rotation. */
export function turnedSide({ rotation = 0, mirror = false }, side) {
  const place = SIDES.indexOf(side);
  const mirrored = mirror && place % 2 ? 4 - place : place;
  return SIDES[(mirrored + rotation / 90) % 4];
}

/* Place of a part after a quarter turn clockwise about a point. */
export function rotatedPlace({ x, y, rotation = 0, mirror = false }, centre) {
  return { x: centre.x - (y - centre.y), y: centre.y + (x - centre.x), rotation: (rotation + 90) % 360, mirror };
}

/* Place of a part after left and right are exchanged about a point. */
export function mirroredPlace({ x, y, rotation = 0, mirror = false }, centre) {
  return { x: 2 * centre.x - x, y, rotation: (360 - rotation) % 360, mirror: !mirror };
}

/* Box of a part: left end, top end, width and height. */
export function boxOf(entry, place) {
  const [left, top, width, height] = entry.box;
  const corners = [turned(place, left, top), turned(place, left + width, top + height)];
  const x = Math.min(corners[0][0], corners[1][0]), y = Math.min(corners[0][1], corners[1][1]);
  const [w, h] = (place.rotation ?? 0) % 180 ? [height, width] : [width, height];
  return { x: place.x + x, y: place.y + y, width: w, height: h };
}

/* Ends at which wires can begin or end: ports with the address `part.port`; the part itself has the address `part`,
   and can have several ends. */
export function endsOf(name, entry, place) {
  return entry.ports.flatMap(port => [port, ...port.also ?? []].map(where => {
    const [x, y] = turned(place, where.x, where.y);
    return {
      address: port.name ? `${name}.${port.name}` : name, part: name, port: port.name, type: port.type,
      x: place.x + x, y: place.y + y, side: turnedSide(place, where.side), symbolSide: where.side, lead: where.lead,
      required: port.required, doc: port.doc, source: port.source,
    };
  }));
}

/* Place of the name of a part beside its box, away from its ports, and of a value beyond it: text anchor, base lines, and
   the box of both. */
export function labelOf(name, box, ends) {
  const width = LETTER * Math.max(name.length, VALUE), height = 2 * LINE;
  const at = side => ends.filter(end => end.side === side).map(end => end.x);
  const label = (anchor, x, top, isAbove = false) => {
    const left = anchor === "middle" ? x - width / 2 : anchor === "end" ? x - width : x;
    const lines = [top + 0.75 * LINE, top + 1.75 * LINE];
    const [y, valueY] = isAbove ? lines.reverse() : lines;
    return { anchor, x, y, valueY, box: { x: left, y: top, width, height } };
  };
  const middle = box.x + box.width / 2, below = box.y + box.height, centre = box.y + (box.height - height) / 2;
  if (!at("bottom").length) return label("middle", middle, below);
  if (!at("top").length) return label("middle", middle, box.y - height, true);
  if (!at("right").length && box.width < 8) return label("start", box.x + box.width + 0.4, centre);
  if (!at("left").length && box.width < 8) return label("end", box.x - 0.4, centre);
  const [first, last] = [Math.min(...at("bottom")), Math.max(...at("bottom"))];
  return first - box.x >= box.x + box.width - last ? label("end", first - ASIDE, below) : label("start", last + ASIDE, below);
}

/* True if two boxes overlap, where the first one is larger by a margin on all sides. */
export function overlaps(a, b, margin = 0) {
  return a.x - margin < b.x + b.width && b.x < a.x + a.width + margin
    && a.y - margin < b.y + b.height && b.y < a.y + a.height + margin;
}

/* Box that contains all boxes, or null if there is none. */
export function around(boxes) {
  if (!boxes.length) return null;
  const x = Math.min(...boxes.map(box => box.x)), y = Math.min(...boxes.map(box => box.y));
  return {
    x, y, width: Math.max(...boxes.map(box => box.x + box.width)) - x,
    height: Math.max(...boxes.map(box => box.y + box.height)) - y,
  };
}

/* Nearest place to `wanted` at which a part with a name covers no box in `taken`; places in `area` come first. */
export function freePlace(entry, name, wanted, taken, area = null) {
  const start = { x: Math.round(wanted.x), y: Math.round(wanted.y) }, origin = { x: 0, y: 0 };
  const box = boxOf(entry, origin), label = labelOf(name, box, endsOf(name, entry, origin)).box, whole = around([box, label]);
  const at = (one, { x, y }) => ({ ...one, x: one.x + x, y: one.y + y });
  const isFree = place => {
    const [own, words] = [at(box, place), at(label, place)];
    return !taken.some(other => overlaps(own, other, MARGIN) || overlaps(words, other, MARGIN / 2));
  };
  if (area) {
    const isSeen = place => contains(area, at(whole, place));
    const place = nearest(start, Math.ceil(Math.max(area.width, area.height)), one => isSeen(one) && isFree(one));
    if (place) return place;
  }
  return nearest(start, Infinity, isFree);
}

/* True if a box is inside another one. */
export function contains(outer, box) {
  return box.x >= outer.x && box.y >= outer.y && box.x + box.width <= outer.x + outer.width
    && box.y + box.height <= outer.y + outer.height;
}

/* Nearest point of the grid with a property, in squares of increasing size around a start; null beyond a limit. */
function nearest(start, limit, has) {
  let best = null, least = Infinity;
  for (let size = 0; size <= limit && size <= least; size++) {
    for (const [dx, dy] of ring(size)) {
      const distance = Math.hypot(dx, dy);
      if (distance < least && has({ x: start.x + dx, y: start.y + dy })) {
        [best, least] = [{ x: start.x + dx, y: start.y + dy }, distance];
      }
    }
  }
  return best;
}

/* Offsets on the border of a square. */
function* ring(size) {
  if (size === 0) { yield [0, 0]; return; }
  for (let k = -size; k < size; k++) {
    yield [k + 1, size];
    yield [k, -size];
    yield [size, k];
    yield [-size, k + 1];
  }
}
