/* Gas flows of parts: the ports between which each mass flow rate of a run flows. All functions are pure. */

import { entryOf } from "./connections.js";

const VALVE = { supply: ["supply", "outlet"], exhaust: ["outlet", "exhaust"] };
const PILOT = { fill: ["supply", null], supply_leak: ["supply", null], vent: [null, "exhaust"], exhaust_leak: [null, "exhaust"] };
const INLETS = { a: ["a", "outlet"], b: ["b", "outlet"] };

/* Ports of the positive direction by kind and name of the flow; null is the inside of the part. */
export const FLOWS = {
  compressor: { "": [null, "outlet"] },
  directional_valve: VALVE,
  flow_source: { "": [null, "to"] },
  main_stage: VALVE,
  pilot_stage: PILOT,
  pressure_booster: {
    supply_a: ["drive_supply", null], supply_b: ["drive_supply", null], exhaust_a: [null, "exhaust"], exhaust_b: [null, "exhaust"],
    intake: ["supply", null], outlet: [null, "outlet"],
  },
  pressure_regulator: VALVE,
  proportional_valve: { ...VALVE, ...PILOT },
  quick_exhaust_valve: { inlet: ["inlet", "outlet"], exhaust: ["outlet", "exhaust"] },
  reservoir: {},
  shuttle_valve: INLETS,
  spool_valve: { supply_a: ["supply", "a"], supply_b: ["supply", "b"], exhaust_a: ["a", "exhaust_a"], exhaust_b: ["b", "exhaust_b"] },
  suction_cup: { port: ["port", null] },
  two_pressure_valve: INLETS,
  vacuum_ejector: { supply: ["supply", "exhaust"], vacuum: ["vacuum", "exhaust"] },
};
const PATH = { "": ["from", "to"] };

/* Terms of the flow out of each port of a part, by the address of the port: [[series, sign]]. */
export function portFlows(view, name, names) {
  const { kind, ports } = view.parts[name], terms = new Map();
  const add = (port, series, sign) => {
    const at = port === "drive_supply" && !("drive_supply" in ports) ? "supply" : port;
    const address = `${name}.${at}`;
    terms.set(address, [...terms.get(address) ?? [], [series, sign]]);
  };
  if (kind === "tube") {
    const cells = names.filter(series => series.startsWith(`${name}.`) && /\.\d+\.mass_flow_rate$/.test(series));
    if (cells.length) { add("from", cells[0], -1); add("to", cells.at(-1), 1); }
    return terms;
  }
  for (const [flow, [source, target]] of Object.entries(entryOf(FLOWS, kind) ?? PATH)) {
    const series = `${name}.${flow}${flow && "_"}mass_flow_rate`;
    if (!names.includes(series)) continue;
    if (source) add(source, series, -1);
    if (target) add(target, series, 1);
  }
  return terms;
}

/* Series of the pressure at a gas node or in a tube to which a port is joined; null is the atmosphere. */
export function pressureSeries(view, target, names) {
  if (target === "ambient") return null;
  const [part] = target.split(".");
  if (view.parts[part]?.kind !== "tube") return `${target}.pressure`;
  const cells = names.filter(series => series.startsWith(`${part}.`) && /\.\d+\.pressure$/.test(series));
  return (target.endsWith(".to") ? cells.at(-1) : cells[0]) ?? "";
}
