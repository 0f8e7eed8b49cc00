/* Kinds of signals: their fields, their start values, and their values over time. */

/* Fields of each kind; types are `value` (as the input), `difference`, `time`, `frequency`, `fraction`, `number`, `text`. */
export const KINDS = {
  constant: { value: "value" },
  steps: { times: "time", values: "value" },
  points: { times: "time", values: "value" },
  sine: { mean: "value", amplitude: "difference", frequency: "frequency", phase: "angle" },
  chirp: { mean: "value", amplitude: "difference", frequency: "frequency", end_frequency: "frequency", phase: "angle", duration: "time" },
  prbs: { low: "value", high: "value", bit_time: "time", seed: "number" },
  square: { low: "value", high: "value", frequency: "frequency", duty: "fraction" },
  pwm: { frequency: "frequency", duty: "fraction", low: "value", high: "value" },
  file: { path: "text", column: "text", unit: "text", time: "text" },
};

/* Units of the types that do not depend on the input. */
export const UNITS = { time: "s", frequency: "Hz", angle: "rad", fraction: "1", number: "1" };

export const OPTIONAL = new Set(["phase", "duration", "duty", "unit", "time"]);
const PWM_NEEDS = "duty";

/* Return True if a field can be omitted. */
export function isOptional(kind, name) { return (OPTIONAL.has(name) && !(kind === "pwm" && name === PWM_NEEDS)) || (kind === "pwm" && ["low", "high"].includes(name)); }

/* Return the table of a new signal. `low` and `high` are typed values of the input, `span` their difference as a typed
   value, `duration` that of the run in s. */
export function startOf(kind, { low, high, mean, span, duration }) {
  const seconds = share => `${Number((duration * share).toPrecision(3))} s`;
  const hertz = periods => `${Number((periods / duration).toPrecision(3))} Hz`;
  return {
    constant: { value: high },
    steps: { times: ["0 s", seconds(0.25)], values: [low, high] },
    points: { times: ["0 s", seconds(0.25), seconds(0.75)], values: [low, high, low] },
    sine: { mean, amplitude: span, frequency: hertz(2) },
    chirp: { mean, amplitude: span, frequency: hertz(1), end_frequency: hertz(10) },
    prbs: { low, high, bit_time: seconds(0.05), seed: 1 },
    square: { low, high, frequency: hertz(2) },
    pwm: { frequency: hertz(20), duty: 0.5 },
    file: { path: "", column: "" },
  }[kind];
}

/* Return points [time, value] of a signal, or null if they need a run. `number(name)` is a field as a number in display
   units, `list(name)` a list of them. */
export function courseOf(kind, { number, list, duration, samples = 200 }) {
  if (kind === "constant") return [[0, number("value")], [duration, number("value")]];
  if (kind === "steps" || kind === "points") return coursePoints(kind, list("times"), list("values"), duration);
  const times = Array.from({ length: samples + 1 }, (_, k) => k / samples * duration);
  const phase = number("phase") || 0;
  if (kind === "sine") {
    const [mean, amplitude, frequency] = ["mean", "amplitude", "frequency"].map(number);
    if (frequency * duration > samples / 4) return null;
    return times.map(t => [t, mean + amplitude * Math.sin(2 * Math.PI * frequency * t + phase)]);
  }
  if (kind === "chirp") {
    const [mean, amplitude, first, last] = ["mean", "amplitude", "frequency", "end_frequency"].map(number);
    const length = number("duration") || duration;
    if (Math.max(first, last) * duration > samples / 4) return null;
    const angle = t => 2 * Math.PI * (first * t + (last - first) * t * t / 2 / length);
    return times.map(t => [t, mean + amplitude * Math.sin(angle(t) + phase)]);
  }
  if (kind === "square") return courseOfSquare({ number, duration, samples });
  return null;
}

function coursePoints(kind, times, values, duration) {
  const points = times.map((time, k) => [time, values[k]]);
  const end = Math.max(duration, ...times.filter(Number.isFinite));
  const last = [end, values.at(-1)];
  if (kind === "points") return [[0, values[0]], ...points, last];
  return points.flatMap(([time, value], k) => (k ? [[time, values[k - 1]], [time, value]] : [[time, value]])).concat([last]);
}

function courseOfSquare({ number, duration, samples }) {
  const [low, high, frequency] = ["low", "high", "frequency"].map(number);
  const duty = Number.isFinite(number("duty")) ? number("duty") : 0.5;
  const periods = Math.ceil(frequency * duration);
  if (!(periods <= samples / 2)) return null;
  return Array.from({ length: periods }, (_, k) => k / frequency)
    .flatMap(start => [[start, low], [start, high], [start + duty / frequency, high], [start + duty / frequency, low]])
    .filter(([time]) => time <= duration).concat([[duration, low]]);
}
