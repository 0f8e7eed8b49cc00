/* Moving parts of symbols: pistons, spools, closing elements and levers. */

import { svgElement } from "./symbols.js";

/* Functions by kind that move the strokes of a symbol: (strokes, fields) -> (context) -> nothing. In the context,
   `series(local)` is the value of an output of the part now or undefined, `share(local, size)` its fraction of a size or
   of the range of the run, and `item` has the ports of the part. */
export const MOTIONS = {
  check_valve: strokes => ({ share, series }) => {
    const flow = series("mass_flow_rate");
    if (flow !== undefined) shift(strokes.at(-1), 0.9 * Math.sqrt(Math.max(0, flow) / share.most("mass_flow_rate")), 0);
  },
  cylinder: strokes => piston(strokes, { low: -3.6, high: 1.6, half: 1.5, rod: 4.4 }, ({ share }) => share("piston_position", "stroke_length")),
  directional_valve: boxes("position", { rest: fields => (fields.normally === "open" ? 1 : 0) }),
  gripper: strokes => piston(strokes, { low: -3.6, high: -0.4, half: 1.5, rod: 1.28 }, ({ share }) => share("piston_position", "jaw_stroke")),
  joint: lever("position", [0, 0], 3.2),
  main_stage: boxes("stroke", { isContinuous: true }),
  mass: strokes => ({ share }) => {
    const part = share("position");
    if (part !== undefined) for (const stroke of strokes.slice(1, -1)) shift(stroke, 1.4 * (part - 0.5), 0);
  },
  proportional_valve: boxes("stroke", { isContinuous: true }),
  rotary_actuator: lever("shaft.position", [-0.8, 0], 2.7),
  spool_valve: (strokes, fields) => (String(fields.function).startsWith("5/2") ? twoPositions : threePositions)(strokes, fields),
};

const threePositions = boxes("position"), twoPositions = boxes("position", { rest: () => -1, step: 2 });

/* Fills of the chambers of a symbol: the gas node and the box [left, top, width, height], or the strokes. */
export const CHAMBERS = { cylinder: ["cap", "rod"], gripper: ["cap", "rod"] };

function shift(stroke, dx, dy) {
  stroke.setAttribute("transform", `translate(${dx.toFixed(3)} ${dy.toFixed(3)})`);
}

/* The boxes of a valve move; the ports stay. A continuous valve that is closed has them half way; `rest` is the position in
   which the symbol shows the valve. */
function boxes(local, { isContinuous = false, rest = () => 0, step = 4 } = {}) {
  return (strokes, fields) => {
    const from = rest(fields), sign = from > 0 ? -1 : 1;
    return ({ series, share, item }) => {
      const position = isContinuous ? 0.5 + 0.5 * series(local) / share.most(local) : series(local);
      if (!Number.isFinite(position)) return;
      const distance = step * sign * (position - from);
      for (const stroke of strokes) shift(stroke, distance, 0);
      item.shiftLeads(distance);
    };
  };
}

/* A piston between two ends, with a rod to a fixed point, and the gas on both sides. */
function piston(strokes, { low, high, half, rod }, where) {
  const [outline, disc, line] = strokes, fills = [0, 1].map(() => {
    const rect = svgElement("rect", { class: "gas", y: -half, height: 2 * half });
    outline.after(rect);
    return rect;
  });
  const move = context => {
    const part = where(context);
    if (part === undefined) return;
    const x = low + (high - low) * Math.max(0, Math.min(1, part));
    disc.setAttribute("d", `M${x} ${half + 0.1}L${x} ${-half - 0.1}`);
    line.setAttribute("d", `M${x} 0L${rod} 0`);
    for (const [rect, from, to] of [[fills[0], low - 0.3, x], [fills[1], x, high + 0.3]]) {
      rect.setAttribute("x", from);
      rect.setAttribute("width", Math.max(0, to - from));
    }
  };
  move.fills = fills;
  return move;
}

/* A lever that shows an angle. */
function lever(local, [x, y], length) {
  return strokes => {
    const line = svgElement("path", { class: "lever", d: `M${x} ${y}h${length}` });
    strokes[0].parentNode.append(line);
    return ({ series }) => {
      const angle = series(local);
      line.style.display = angle === undefined ? "none" : "";
      if (angle !== undefined) line.setAttribute("transform", `rotate(${(-angle * 180 / Math.PI).toFixed(2)} ${x} ${y})`);
    };
  };
}
